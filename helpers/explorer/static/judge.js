var ArmJudge=(()=>{var Ae=Object.defineProperty;var Zn=Object.getOwnPropertyDescriptor;var Kn=Object.getOwnPropertyNames;var Vn=Object.prototype.hasOwnProperty;var x=(e,t)=>{for(var n in t)Ae(e,n,{get:t[n],enumerable:!0})},Yn=(e,t,n,r)=>{if(t&&typeof t=="object"||typeof t=="function")for(let o of Kn(t))!Vn.call(e,o)&&o!==n&&Ae(e,o,{get:()=>t[o],enumerable:!(r=Zn(t,o))||r.enumerable});return e};var Jn=e=>Yn(Ae({},"__esModule",{value:!0}),e);var Hs={};x(Hs,{kit:()=>Ln});var Te={};x(Te,{ArmError:()=>f,learn:()=>Me,listed:()=>Se,lower:()=>ue,quoted:()=>Ne,say:()=>v,shown:()=>B,size:()=>Xn,spelled:()=>D,tuple:()=>Oe});var Ee={},Me=e=>{Ee={...Ee,...e}};function v(e,t={}){let n=Ee[e];for(let[r,o]of Object.entries(t))n=n.replaceAll(`{${r}}`,()=>String(o));return n}var f=class extends Error{},Se=(e,t="and")=>e.length===1?e[0]:`${e.slice(0,-1).join(", ")} ${t} ${e.at(-1)}`,ue=e=>/^.(\p{Lu}|_)/su.test(e)?e:e.slice(0,1).toLowerCase()+e.slice(1);function Xn(e,t=3){if(!Number.isFinite(e))return Number.isNaN(e)?"nan":e>0?"inf":"-inf";if(e===0)return"0";let[n,r]=Qn(e,t).split("e"),o=Number(r),s=a=>a.includes(".")?a.replace(/\.?0+$/,""):a;return o<-4||o>=t?`${s(n)}e${kt(o)}`:s((+`${n}e${r}`).toFixed(Math.max(0,t-1-o)))}function Qn(e,t){let n=e.toExponential(t-1),[r,o]=e.toExponential(t+25).split("e"),s=t===1?r.indexOf("."):r.indexOf(".")+t,a=r.slice(s).replace(".",""),i=r.slice(0,s);return/^50*$/.test(a)&&"02468".includes(i.at(-1))?`${i}e${o}`:n}var kt=e=>`${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;function D(e){let[t,n]=e.toExponential().split("e"),r=Number(n);if(e!==0&&(r<-4||r>=16))return`${t}e${kt(r)}`;let o=BigInt(Math.trunc(e)).toString();return r>20?o:String(e).includes("e")?e.toFixed(20).replace(/0+$/,""):String(e)}function B(e){let t=e.includes("'")&&!e.includes('"')?'"':"'",n={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},r=[...e].map(s=>n[s]??er(s)).join(""),o=[...`${t}${r}${t}`];return o.length<=80?o.join(""):`${o.slice(0,77).join("")}...`}function er(e){let t=e.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(e)||e===" "?e:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var Oe=e=>e.length===1?`(${e[0]},)`:`(${e.join(", ")})`;function Ne(e){return e.includes(`
`)&&!/"""|["\\]$/.test(e)&&!/[\r\0]/.test(e)?`r"""${e}"""`:JSON.stringify(e)}var Rt=`.arm-judge {
  max-width: var(--wide, 46rem);
  margin: 1.5rem 0;
  padding: 1rem 1.1rem 1.1rem;
  border: 1px solid var(--line);
  border-radius: 10px;
  background: var(--raised);
  font-family: var(--sans, system-ui, sans-serif);
  font-size: 0.95rem;
  line-height: 1.45;
}
.arm-judge form {
  display: grid;
  grid-template-columns: repeat(auto-fit, minmax(min(100%, 15rem), 1fr));
  gap: 0.7rem 1rem;
}
.arm-judge .field {
  display: grid;
  gap: 0.2rem;
  align-content: start;
  min-width: 0;
}
.arm-judge .whole {
  grid-column: 1 / -1;
}
.arm-judge :is([hidden], .given) {
  display: none;
}
.arm-judge label {
  font-weight: 600;
}
.arm-judge .about,
.arm-judge .private {
  margin: 0;
  color: var(--quiet);
  font-size: 0.9em;
  max-width: none;
}
.arm-judge :is(select, input, textarea, button) {
  min-height: 2.5rem;
  padding: 0.35rem 0.55rem;
  border: 1px solid var(--quiet);
  border-radius: 6px;
  color: var(--text);
  background: var(--ground);
  font: inherit;
  font-weight: 400;
  font-size: max(1em, 16px);
  min-width: 0;
  max-width: 100%;
}
.arm-judge :is(input, textarea) {
  font-family: var(--mono, monospace);
}
.arm-judge sub {
  line-height: 0;
}
.arm-judge textarea {
  width: 100%;
  box-sizing: border-box;
  resize: vertical;
}
.arm-judge button {
  cursor: pointer;
  font-size: 1em;
}
.arm-judge button:hover {
  border-color: var(--link);
}
.arm-judge :focus-visible {
  outline: 3px solid var(--link);
  outline-offset: 1px;
}
.arm-judge .tools {
  display: flex;
  flex-wrap: wrap;
  gap: 0.5rem;
  margin: 0.8rem 0;
  align-items: center;
}
.arm-judge .verdict {
  margin-top: 0.9rem;
  padding: 0.7rem 0.9rem;
  border-left: 4px solid var(--quiet);
  border-radius: 4px;
  background: var(--ground);
}
.arm-judge .verdict.right {
  border-color: var(--proof);
}
.arm-judge .verdict:is(.wrong, .rounded, .so) {
  border-color: var(--slip);
}
.arm-judge .verdict p {
  margin: 0;
  max-width: none;
  overflow-wrap: anywhere;
}
.arm-judge .verdict .headline {
  font-weight: 600;
}
.arm-judge .verdict ul {
  margin: 0.4rem 0 0;
  padding-left: 1.2rem;
}
.arm-judge .scroll {
  position: relative;
  overflow-x: auto;
  margin-top: 0.8rem;
}
.arm-judge table {
  width: auto;
  margin: 0;
  border-collapse: collapse;
  font-size: 0.9em;
  font-variant-numeric: tabular-nums;
}
.arm-judge caption {
  text-align: left;
  font-weight: 600;
  padding-bottom: 0.2rem;
}
.arm-judge :is(th, td) {
  padding: 0.2rem 0.55rem;
  text-align: right;
  border: 0;
  border-bottom: 1px solid var(--line);
  white-space: nowrap;
}
.arm-judge .read :is(td, tbody th) {
  vertical-align: middle;
}
.arm-judge .read math {
  font-size: 1.1em;
}
.arm-judge .value {
  display: block;
  color: var(--quiet);
  font-size: 0.85em;
}
.arm-judge .matrix tbody td {
  border: 0;
}
.arm-judge .matrix tbody tr:first-child {
  --top: linear-gradient(var(--text), var(--text));
}
.arm-judge .matrix tbody tr:last-child {
  --bottom: linear-gradient(var(--text), var(--text));
}
.arm-judge .matrix tbody td:nth-child(2) {
  border-left: 1.5px solid var(--text);
  background:
    var(--top, none) left top / 0.4em 1.5px no-repeat,
    var(--bottom, none) left bottom / 0.4em 1.5px no-repeat;
}
.arm-judge .matrix tbody td:last-child {
  border-right: 1.5px solid var(--text);
  background:
    var(--top, none) right top / 0.4em 1.5px no-repeat,
    var(--bottom, none) right bottom / 0.4em 1.5px no-repeat;
}
.arm-judge td.off {
  color: var(--slip);
  font-weight: 700;
  text-decoration: underline wavy;
  text-underline-offset: 0.2em;
}
.arm-judge .unseen {
  position: absolute;
  width: 1px;
  height: 1px;
  overflow: hidden;
  clip-path: inset(50%);
  white-space: nowrap;
}
.arm-judge.small {
  padding: 0.7rem 0.9rem 0.8rem;
}
.arm-judge .asked {
  grid-column: 1 / -1;
  margin: 0;
  max-width: none;
  font-weight: 600;
}
.arm-judge .beside {
  display: block;
  min-height: 16rem;
}
.arm-judge .over {
  display: flex;
  flex-wrap: wrap;
  gap: 0.2rem 1rem;
  justify-content: space-between;
  align-items: baseline;
}
.arm-judge .filling input {
  width: 5.2rem;
  min-height: 2.2rem;
  padding: 0.2rem 0.3rem;
  text-align: right;
}
.arm-judge .filling :is(th, td) {
  padding: 0.1rem 0.15rem;
  border: 0;
}
.arm-judge .filling input.off {
  border-color: var(--slip);
  border-width: 2px;
  color: var(--slip);
}
.arm-judge .practice {
  margin-bottom: 0.9rem;
  padding-bottom: 0.7rem;
  border-bottom: 1px solid var(--line);
}
.arm-judge summary {
  min-height: 2rem;
  font-weight: 600;
  cursor: pointer;
}
.arm-judge .choice {
  display: flex;
  flex-wrap: wrap;
  gap: 0.5rem;
  align-items: end;
  margin: 0.5rem 0;
}
.arm-judge .choice input {
  width: 7rem;
}
.arm-judge .problem {
  margin: 0.6rem 4px;
}
.arm-judge .problem :is(p, pre) {
  max-width: none;
  margin: 0.4rem 0;
}
.arm-judge .keep {
  display: block;
  font-weight: 400;
}
.arm-judge .keep input {
  min-height: 0;
}
.arm-judge.over-it {
  outline: 3px dashed var(--link);
  outline-offset: 2px;
}
`;var _e={};x(_e,{judges:()=>V});var V=[];var Be={};x(Be,{KINDS:()=>zt,LARGEST:()=>Ce,LONGEST:()=>Fe,MOST_ROWS:()=>ze,TYPED:()=>Ft,carriedOver:()=>Dt,fits:()=>Bt,homeOf:()=>dr,limited:()=>gr,outside:()=>hr,range:()=>fr,reachOf:()=>wr,rowsFault:()=>Pe,sameRow:()=>Pt,typedArm:()=>De});var Ie={};x(Ie,{GRAVITY:()=>nr,cosSin:()=>ke,cross:()=>Le,dot:()=>rr,gravityTorque:()=>cr,jacobianColumns:()=>ir,joints:()=>b,liftedEnergy:()=>lr,linkFrames:()=>sr,matrix:()=>ar,minus:()=>Re,norm:()=>or,plus:()=>me,scaled:()=>Lt,wrenchTorque:()=>mr});var nr=9.81,rr=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],Lt=(e,t)=>[e*t[0],e*t[1],e*t[2]],me=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],Re=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],Le=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],or=e=>Math.sqrt(e.reduce((t,n)=>t+n*n,0)),q=(e,t,n,r)=>[e*t[0]+n*r[0],e*t[1]+n*r[1],e*t[2]+n*r[2]];function ke(e){let t=e/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(e),Math.sin(e)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var b=e=>e.rows.flatMap((t,n)=>t.kind==="fixed"?[]:[n]);function sr(e,t){let[n,r,o,s]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:n,y:r,z:o,o:s}],i=0;for(let c of e.rows){let l=c.kind==="fixed"?0:t[i++],[u,p]=ke(c.kind==="revolute"?c.theta+l:c.theta),[h,d]=ke(c.alpha),g=c.kind==="prismatic"?c.d+l:c.d;[n,r]=[q(u,n,p,r),q(u,r,-p,n)],s=me(q(g,o,c.a,n),s),[r,o]=[q(h,r,d,o),q(h,o,-d,r)],a.push({x:n,y:r,z:o,o:s})}return a}var ar=({x:e,y:t,z:n,o:r})=>[0,1,2].map(o=>[e[o],t[o],n[o],r[o]]).concat([[0,0,0,1]]);function ir(e,t,n=t.at(-1).o){return b(e).map(r=>{let{z:o,o:s}=t[r];return e.rows[r].kind==="revolute"?[...Le(o,Re(n,s)),...o]:[...o,0,0,0]})}function cr(e,t,n=9.81){let r=It(e,t);return b(e).map(o=>{let{z:s,o:a}=t[o],i=c=>e.rows[o].kind==="revolute"?Le(s,Re(c,a))[2]:s[2];return r.reduce((c,{mass:l,centre:u,row:p})=>c+(p<o?0:l*n*i(u)),0)})}var lr=(e,t,n=9.81)=>It(e,t).reduce((r,{mass:o,centre:s})=>r+o*n*s[2],0),It=(e,t)=>e.rows.flatMap((n,r)=>n.body?[ur(n.body,t[r+1],r)]:[]);function ur([e,...t],{x:n,y:r,z:o,o:s},a){return{mass:e,row:a,centre:me(s,me(q(t[0],n,t[1],r),Lt(t[2],o)))}}var mr=(e,t)=>e.map(n=>n.reduce((r,o,s)=>r+o*t[s],0));var zt=["revolute","prismatic","fixed"],ze=16,Fe=100,Ce=1e3,Ft="Your arm",Ct=[["a",Fe],["alpha",Ce],["d",Fe],["theta",Ce]];function Pe(e){if(!Array.isArray(e)||!e.length)return"the table has no rows";if(e.length>ze)return`the table has ${e.length} rows; ${ze} are the most`;for(let[t,n]of e.entries()){if(!zt.includes(n?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[r,o]of Ct){if(!Number.isFinite(n[r]))return`row ${t+1} has no number for ${r}`;if(Math.abs(n[r])>o)return`row ${t+1} has ${n[r]} for ${r}; ${o} is the most`}}return null}var pr=({kind:e,a:t,alpha:n,d:r,theta:o})=>({kind:e,a:t,alpha:n,d:r,theta:o,lower:null,upper:null,speed:null,effort:null}),Pt=(e,t)=>e.kind===t.kind&&Ct.every(([n])=>Math.abs(e[n]-t[n])<1e-12);function De(e,t){if(e.length===t.rows.length&&e.every((r,o)=>Pt(r,t.rows[o])))return t;let n={name:Ft,home:[],rows:e.map(pr)};return{...n,home:Dt(t,t.home,n,r=>r)}}function Dt(e,t,n,r){let o=new Map(b(e).map((s,a)=>[s,[e.rows[s].kind,t[a]??0]]));return b(n).map(s=>{let[a,i]=o.get(r(s))??[];return a===n.rows[s].kind?i:0})}var dr=e=>Bt(e,e.home)?[...e.home]:b(e).map(()=>0),Bt=(e,t)=>Array.isArray(t)&&t.length===b(e).length&&t.every(Number.isFinite);function fr(e){let t=e.kind==="revolute"?Math.PI:1;return[e.lower??-t,e.upper??t]}var hr=(e,t)=>t<(e.lower??-1/0)-1e-9||t>(e.upper??1/0)+1e-9,gr=e=>b(e).some(t=>e.rows[t].lower!==null||e.rows[t].upper!==null),wr=e=>e.rows.reduce((t,n)=>t+Math.abs(n.a)+Math.abs(n.d)+(n.kind==="prismatic"?Math.abs(n.upper??.3):0),0)||.3;var qe={};x(qe,{attribute:()=>xr,calm:()=>$r,h:()=>m,indexed:()=>vr,svg:()=>br,whereNew:()=>yr,write:()=>G});function m(e,t={},...n){let[r,...o]=e.split("."),s=document.createElement(r);o.length&&(s.className=o.join(" "));for(let[a,i]of Object.entries(t))a.startsWith("on")?s.addEventListener(a.slice(2),i):i!==void 0&&i!==!1&&s.setAttribute(a,i===!0?"":i);return s.append(...n.flat()),s}function br(e,t={},...n){let r=document.createElementNS("http://www.w3.org/2000/svg",e);for(let[o,s]of Object.entries(t))r.setAttribute(o,s);return r.append(...n),r}function G(e,t){e.textContent!==t&&(e.textContent=t)}function xr(e,t,n){e.getAttribute(t)!==n&&e.setAttribute(t,n)}function yr(e,t){let n=[];return r=>{let o=e(r);n.length&&o.every((s,a)=>s===n[a])||(n=o,t(r))}}var vr=(e,t)=>[m("i",{},e),m("sub",{},String(t))],$r=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var bt={};x(bt,{ASKED:()=>$,CHOICES:()=>dt,EMPTY:()=>Z,LONGEST_ANSWER:()=>yn,OWN:()=>R,UNITS:()=>W,armOf:()=>gt,asPython:()=>Wo,fromFragment:()=>ht,judge:()=>wt,toFragment:()=>ft});var j=Math.PI/180,Ge=180/Math.PI;var $={jacobian:{title:"Jacobian at a pose",fields:["q","unit","frame","first","values"],script:"jacobian"},torques:{title:"Joint torques at a pose",fields:["q","unit","wrench"],script:"jacobian"},table:{title:"Denavit-Hartenberg table",fields:["columns","lengths","angles","convention","values"],script:"table"},branches:{title:"All joint angles for a target",fields:["target","unit"],script:"motion"},pose:{title:"Joint angles for one pose",fields:["target","unit"],script:"motion"},trace:{title:"Joints along a circle",fields:["q","unit","radius","plane","period","steps","pace"],script:"motion",longest:5e6}};var ct={};x(ct,{eachJoint:()=>st,inRadians:()=>it,lookup:()=>ot,numbered:()=>nt,numbers:()=>gn,pose:()=>at,poseFault:()=>bn,rowsInRadians:()=>So,turning:()=>re,variables:()=>rt});var Ke={};x(Ke,{HALF:()=>Ut,HAND:()=>Ht,RIGHT:()=>de,ROUNDED:()=>fe,SLOPPY:()=>Wt,SO_FAR:()=>Y,TELLING:()=>Zt,WRONG:()=>He,bands:()=>Nr,beyond:()=>_r,decimalsOf:()=>Sr,farthest:()=>Ze,generous:()=>Kt,graded:()=>Tr,margins:()=>Or,units:()=>J});var[de,Y,fe,He]=["right","so far","rounded","wrong"],Ut=.51,Ht=3.01,jr=1e-6,Wt=.001,Zt=.0021,Ar=13,qt=-12,Er=/^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/,Gt=e=>+`1e${e}`;function Mr(e){let t=Er.exec(e.trim());if(!t||!(t[1]||t[2]))return null;let n=(t[1]+t[2]).replace(/^0+/,"").length,r=t[2].length-Number(t[3]??0);return{decimals:r,digits:n,first:n-1-r}}function J(e){let t=e.map(Mr),n=t.filter(i=>i&&i.digits&&i.first>qt),r=i=>n.reduce((c,l)=>Math.max(c,l[i]),n.length?-1/0:0),[o,s]=[r("decimals"),r("digits")];if(s>=Ar||t.includes(null)&&o<=0)return e.map(()=>0);let a=n.every(i=>i.decimals<=s-1-i.first)&&n.some(i=>i.digits===s&&i.decimals<o);return t.map(i=>i?!a||!i.digits||i.first<=qt?Gt(-o):Gt(Math.max(-o,i.first-s+1)):0)}function Sr(e){let t=e.filter(n=>n>0);return t.length?Math.max(0,Math.round(-Math.log10(Math.min(...t)))):null}function Or(e,t,n=null,r=null){let o=t.map(l=>jr*l),s=e.map(()=>0);if(r!==null){let l=o.map(u=>Math.max(r,u*.001));return{allowed:l,band:l,loose:l,units:s,slop:s}}let a=e.map((l,u)=>Math.max(Ut*l,o[u])),i=e.map((l,u)=>Math.max(Ht*l,o[u])),c=i.map((l,u)=>Math.max(l,Wt*t[u]));return{allowed:a,band:i,loose:c,units:e,slop:n??s}}var We=(e,t,n)=>e.map((r,o)=>r+n*t[o]),Ze=({loose:e,band:t,slop:n})=>We(t,n,2).map((r,o)=>Math.max(r,e[o])),Kt=({allowed:e,slop:t})=>We(e,t,1);function Nr(e){let t=e.slop.some(Boolean)?[We(e.band,e.slop,2)]:[];return[e.band,...t,Ze(e),e.allowed]}var Ue=(e,t,n)=>e.every((r,o)=>Math.abs(r-t[o])<=n[o]),pe=(e,t)=>e.reduce((n,r,o)=>Math.max(n,Math.abs(r-t[o])),0);function Tr(e,t,n,r){let o=r.filter(a=>pe(a,t)>Zt);for(let a of[n.allowed,Kt(n)]){let i=o.some(c=>Ue(e,c,a));if(Ue(e,t,a)){let c=Math.max(0,...n.units),l=o.reduce((u,p)=>Math.min(u,pe(p,t)),1/0);return i||c>l/2.1?Y:de}if(i)return He}if(!Ue(e,t,Ze(n)))return He;let s=pe(e,t);return o.some(a=>pe(e,a)<=s)?Y:fe}function _r(e,t,{band:n,allowed:r}){let o=a=>e.map((i,c)=>Math.abs(i-t[c])>a[c]),s=o(n);return s.includes(!0)?s:o(r)}var Je={};x(Je,{isNumber:()=>U,number:()=>z,parse:()=>T,plain:()=>E,symbols:()=>_,value:()=>H});var Vt=2e4,Jt=60,Xt={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:e=>e*j,deg2rad:e=>e*j,degrees:e=>e*Ge,rad2deg:e=>e*Ge,sind:e=>Math.sin(e*j),cosd:e=>Math.cos(e*j),float:e=>e,Float:e=>e,Integer:e=>e,float64:e=>e,float32:e=>e,int64:e=>e},Qt={pi:Math.PI,deg:j,rad:1},kr=e=>Object.hasOwn(Xt,e),en=e=>Object.hasOwn(Qt,e),A=(e,t)=>[...e].map(n=>[n,t]),Rr="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),Lr=new Map([...A("−–—‐‑‒﹣－","-"),...A("×⋅·∙∗","*"),...A("÷∕⁄","/"),...A("       　"," "),...A("​⁡⁢\uFEFF",""),...A("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((e,t)=>A(e,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((e,t)=>A(e,` ${Rr[t]}`)),...A("π𝜋"," pi "),...A("°º"," deg"),["$"," "],["²","^2"],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),Ir=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)\b/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text|mathit|mathbf|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)\b/g," deg"],[/\\(?:cdot|times|ast)\b/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/\\d?t?frac\s*(\d)\s*(\d)/g,"(($1)/($2))"]],zr=/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,Fr=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,Cr=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,Ve=new RegExp(String.raw`\s*(?:(${Fr})|(${Cr})|(\*\*|[-+*/^()]))`,"y"),Pr=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,Dr=/[cs]_?(?:\d|\{[\d+-]+\})+/g,Br=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,U=e=>Br.test(e);function E(e){if(U(e))return e;e=[...e].map(t=>Lr.get(t)??t).join("");for(let[t,n]of Ir)e=e.replace(t,n);for(let t="";t!==e;)[t,e]=[e,e.replace(zr,"(($1)/($2))")];return e=e.replace(/\\([A-Za-z]+)/g," $1 "),e=e.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),e=e.replace(/(?<=\w)\s*\(t\)/g,""),e=e.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),e=e.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),e=e.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),e.replace(/[ \t]+/g," ").trim()}function T(e,t="the formula"){if(e.length>Vt)throw new f(`${t} has ${e.length} characters; expected at most ${Vt}`);let n=Gr(E(e));if(!n)throw new f(`${t} is ${B(e)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let r=qr(n);if(r?.[1]!==n.length)throw new f(`${t} is ${B(e)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return r[0]}var N=class extends Error{};function qr(e){try{return tn(e,0,0)}catch(t){if(t instanceof N)return null;throw t}}function Gr(e){let t=[];for(let n=0;n<e.length;n=Ve.lastIndex){Ve.lastIndex=n;let r=Ve.exec(e);if(!r)return e.slice(n).trim()?null:t;let[,o,s,a]=r;if(o!==void 0)t.push(["num",o]);else if(a!==void 0)t.push(["sign",a==="**"?"^":a]);else for(let i of Pr.test(s)?s.match(Dr):[s])t.push(["name",i])}return t}function he(e,t){if(t>=e.length)throw new N;return e[t]}function tn(e,t,n){if(n>Jt)throw new N;let[r,o]=Yt(e,t,n);for(;o<e.length&&["+","-"].includes(e[o][1]);){let[s,a]=Yt(e,o+1,n);[r,o]=[[e[o][1],r,s],a]}return[r,o]}function Yt(e,t,n){let[r,o]=Q(e,t,n);for(;o<e.length;){let[s,a]=e[o];if(a==="*"||a==="/"){let[i,c]=Q(e,o+1,n);[r,o]=[[a,r,i],c]}else if(a==="("||s!=="sign"){let[i,c]=nn(e,o,n);[r,o]=[["*",r,i],c]}else break}return[r,o]}function Q(e,t,n){if(n>Jt)throw new N;let r=he(e,t)[1];if(r==="-"){let[o,s]=Q(e,t+1,n+1);return[["neg",o],s]}return r==="+"?Q(e,t+1,n+1):nn(e,t,n)}function nn(e,t,n){let[r,o]=Ye(e,t,n);if(o>=e.length||e[o][1]!=="^")return[r,o];let[s,a]=Q(e,o+1,n+1);return[["^",r,s],a]}function Ye(e,t,n){let[r,o]=he(e,t);if(r==="num")return[["num",Number(o)],t+1];if(r==="name"&&kr(o)&&t+1<e.length){let[i,c]=Ur(e,t+1,n);return[["call",o,i],c]}if(r==="name")return[["name",o],t+1];if(o!=="(")throw new N;let[s,a]=tn(e,t+1,n+1);if(he(e,a)[1]!==")")throw new N;return[s,a+1]}function Ur(e,t,n){if(he(e,t)[1]!=="-")return Ye(e,t,n);let[r,o]=Ye(e,t+1,n);return[["neg",r],o]}function _(e,t=new Set){if(e[0]==="name")return en(e[1])?t:t.add(e[1]);for(let n of e.slice(1))Array.isArray(n)&&_(n,t);return t}function H(e,t){let n=X(e,t);if(!Number.isFinite(n))throw new f("a formula divides by zero or is too large; expected a finite value");return n}function X(e,t){let[n,r,o]=e;if(n==="num")return r;if(n==="name"){let c=en(r)?Qt[r]:t(r);if(c===void 0)throw new f(`no value for ${r}`);return c}if(n==="neg")return-X(r,t);if(n==="call")return Xt[r](X(o,t));let[s,a]=[X(r,t),X(o,t)];if(n==="+")return s+a;if(n==="-")return s-a;if(n==="*")return s*a;if(n==="/")return a===0?NaN:s/a;let i=s**a;return Number.isFinite(i)||!Number.isFinite(s)?i:NaN}function z(e){try{return H(T(e),()=>{})}catch(t){if(t instanceof f)return null;throw t}}var tt={};x(tt,{cells:()=>F,withoutHeader:()=>te});var Hr=/(?<![^\n])[ \t]*```[^\n\r]*/g,rn=String.raw`(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*`,Wr=new RegExp(rn+String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,"g"),Zr=new RegExp(rn,"g"),Kr=/((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*[#%][^\n\r]*/g,Vr=/^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[[({])/,Yr=/^[ \t\r\n]*=[ \t]*(?=[[({])/,Jr=String.raw`\{(?:[A-Za-z]*matrix\*?|array|tabular)\}`,[Xr,Qr]=["begin","end"].map(e=>new RegExp(String.raw`\\${e}${Jr}`,"g")),eo=new RegExp(String.raw`\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}`+String.raw`|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed|left[ \t]*[\[(|.]|\[|\()`+String.raw`|[$&{ \t\r\n]`,"g"),to=/\\end\{[a-z]+\*?\}|\\label\{[^{}]*\}|\\(?:right[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]/g,no=/^[^=0-9][^=]*=$/,ro=[[/\\[hv]?phantom\{[^{}]*\}/g," "],[/\\num\{([^{}]*)\}/g,"$1"],[/\{([-+])\}/g,"$1"],[/(?<=[0-9])\{,\}(?=[0-9])/g,"."]],on=e=>e.replace(Hr,"").replace(Kr,"$1").replace(Wr,"").replace(Zr,"").replace(Vr,"").replace(Yr,"");function sn(e){let[t,n]=[Xr,Qr].map(r=>[...e.matchAll(r)]);if(t.length===1&&n.length===1){let[r,o]=[t[0].index,n[0].index+n[0][0].length],s=e.slice(0,r).replace(eo,""),a=e.slice(o).replace(to,""),i=!s||no.test(s)&&!s.includes("frac");e=e.slice(i?r:0,a?e.length:o)}for(let[r,o]of ro)e=e.replace(r,o);return e}var an=5e6,mn=String.raw`[\p{L}\p{N}_.]`,oo=String.raw`^\s*(?:${mn}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`,so="Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym",cn=new RegExp(String.raw`${oo}(?:${mn}*(?:${so})\s*\(\s*)+`,"u"),ao=/\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u,io=/^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u,co=/\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g,lo=/\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|toprule|midrule|bottomrule|nonumber)\b/g,uo=/(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/,ln=/^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m,un=/^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im,mo=/^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/,pn=e=>{let t=e.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);return t.at(-1)===""&&t.pop(),t},Xe=(e,t)=>{let[n,r]=[0,e.length];for(;n<r&&t.includes(e[n]);)n++;for(;r>n&&t.includes(e[r-1]);)r--;return e.slice(n,r)},ee=(e,t)=>{let n=e.length;for(;n>0&&t.includes(e[n-1]);)n--;return e.slice(0,n)};function F(e){if(e.length>an)throw new f(`the text has ${e.length} characters; expected at most ${an}`);let t=po(Xe(on(e).trim(),"`$").trim()).filter(n=>n.some(r=>r.trim())).map(n=>n.map(r=>r.trim()));if(!t.length)throw new f("the text is empty; expected rows of numbers or formulas");return t}function po(e){if(e.includes("\\begin{")||e.includes("\\\\"))return fo(e);if(e.split("|").length>2&&!e.split("|")[0].includes("["))return ho(e);let t=cn.test(e)?e.replace(cn,"").replace(ao,""):e;return t=ee(t.replace(io,"").trim(),";").trim(),t&&"[({".includes(t[0])?dn(t):wo(t)}function fo(e){return e=sn(e).replace(/\\left\s*[[(.|]\s*(?=\\begin)/g," ").replace(co," ").replace(lo," ").replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u,"").replace(/\\\\\s*\[[^\]]*\]/g,"\\\\").replaceAll("$"," ").replaceAll("\\["," ").replaceAll("\\]"," "),e.split(/\\\\|\\cr\b/).map(t=>t.split("&"))}var ho=e=>pn(e).map(t=>t.trim()).filter(t=>t.includes("|")&&!/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(t)).map(t=>t.replace(/^\||\|$/g,"").replaceAll("$"," ").split("|"));function dn(e){let t=ge(e);if(t.length===1&&!k(t[0]))return[t];if(t.every(k)){let r=t.map(ge);if(!r.some(a=>a.some(k)))return r;let o=a=>k(a)&&ge(a).length===1?ge(a)[0]:a,s=r.map(a=>a.map(o));return s.some(a=>a.some(k))?t.flatMap(dn):s}let n=k(e)?e.trim().slice(1,-1):e;return k(e)&&/[;\n]/.test(n)&&!n.includes("[")?n.replace(/\.\.\.[^\n]*\n/g," ").split(/[;\n]/).map(we):[t]}function k(e){return e=e.trim(),!e||!"[({".includes(e[0])||!fn(e)?!1:e[0]!=="("||et(e.slice(1,-1))}var Qe=e=>"[({".includes(e)?1:"])}".includes(e)?-1:0;function fn(e){let t=0;for(let n=0;n<e.length;n++)if(t+=Qe(e[n]),!t)return n===e.length-1;return!1}function et(e){let t=0;for(let n=0;n<e.length;n++)if(t+=Qe(e[n]),e[n]===","&&!t)return!0;return!1}function ge(e){return e=ee(e.trim(),","),we(k(e)||e[0]==="["&&fn(e)?e.slice(1,-1):e)}function we(e){let t=e.trim().split(/\s+/);if(t.every(U))return t;let n=[],[r,o]=[0,""],s=et(e);for(let a=0;a<e.length;a++){let i=e[a];r+=Qe(i),(s?i===",":/\s/.test(i)&&!go(e,a))&&!r?(n.push(o),o=""):o+=i,!s&&!r&&i==="]"&&(n.push(o),o="")}return n.push(o),n.filter(a=>a.trim()).map(a=>Xe(a.trim(),`'"`))}function go(e,t){let[n,r]=[e.slice(0,t).trimEnd(),e.slice(t).trimStart()];return n.endsWith("*")&&r&&!"*/^)=".includes(r[0])&&uo.test(n)?!1:!n||!r||"+-*/^=(".includes(n.at(-1))||"*/^)=".includes(r[0])?!0:"+-".includes(r[0])&&r.length>1&&/\s/.test(r[1])||r.startsWith("deg")||r[0]==="°"}function wo(e){let t=ln.exec(e);e=e.replace(new RegExp(ln,"gm"),"");let r=(un.test(e)?e.split(new RegExp(un,"gim")).filter(s=>s.trim()):[e]).map(bo),o=r[0];return r.length>1&&r.every(s=>s.length===o.length)&&(o=o.map((s,a)=>r.flatMap(i=>i[a]))),t?o.map(s=>s.map(a=>z(a)?`${a}*${t[1]}`:a)):o}function bo(e){let t=pn(e).filter(o=>o.trim()&&!mo.test(o)).filter(o=>!/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(o)),n=o=>t.some(s=>ee(s.trim(),";").includes(o)),r=["	",";"].find(n);if(r){let o=s=>ee(Xe(s,`\r
 `),r);return t.map(s=>o(s).split(r).map(yo))}return t.some(et)?xo(t):t.map(o=>we(o.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g,"")))}function xo(e){let t=e.every(n=>/^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(n));return e.map(n=>we(t?n.replaceAll(",","."):ee(n,",")))}function yo(e){let t=e.trim();return t[0]==='"'&&t.at(-1)==='"'&&(e=t.slice(1,-1)),e=e.replace(/^[ \t]*=/,""),e.split(",").length===2&&!e.includes("(")?e.replace(/(?<=\d),(?=\d)/g,"."):e}var vo=e=>e.every(t=>t.every(n=>z(n)!==null));function te(e){let[t,...n]=e,r=t.map(E).filter(Boolean);return n.length>0&&r.every(s=>z(s)===null)&&vo(n)?n:e}var $o=/^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/,hn=/^([cs])((?:[+-]?\d)+)$/i,jo=/^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/,nt=e=>b(e).map(t=>t+1),re=e=>b(e).map(t=>e.rows[t].kind==="revolute"),rt=e=>nt(e).map(t=>`q_${t}`);function ot(e,t,n=[]){let r=[];return{known:s=>{let[a,i]=Oo([...s].sort(),e,t,n);for(let c of i)r.includes(c)||r.push(c);return a},said:r}}var Ao=e=>{if(e.size)throw new f(v("symbols for numbers",{names:[...e].sort().join(", ")}));return new Map};function gn(e,t,n=Ao,r="numbers"){if(typeof e=="string")return Eo(e,t,n);let o=wn(e),s=e.flat(1/0);if(!s.every(Number.isFinite))throw new f(v("not finite",{what:t,wanted:r}));return{values:s,units:J(s.map(D)),shape:o,symbolic:!1}}var wn=e=>Array.isArray(e)?[e.length,...e.length?wn(e[0]):[]]:[];function Eo(e,t,n){let r=te(F(e)),o=[...new Set(r.map(d=>d.length))].sort((d,g)=>d-g);if(o.length>1)throw new f(v("ragged",{what:t,widths:o.join(", ")}));let s=r.flat().map(E),a=s.map(d=>U(d)?["num",Number(d)]:T(d,`an entry of ${t}`)),i=new Set;for(let d of a)_(d,i);let c=n(i),l=a.map(d=>H(d,g=>c.get(g))),u=s.map(Mo),p=J(u.map(([d])=>d)).map((d,g)=>d*u[g][1]),h=a.map((d,g)=>u[g][1]===1?d:["num",l[g]]);return{values:l,units:p,shape:[r.length,o[0]],symbolic:i.size>0,trees:h}}function Mo(e){let t=jo.exec(e);return t?[t[1],Number(t[2])]:[e,1]}var st=e=>`one value for each of ${rt(e).join(", ")}`;function at(e,t,n="rad"){let r=gn(e,`${t.name}: q`,void 0,st(t)),o=typeof e=="string"?[r.values.length]:r.shape,s=b(t).length;if(o.length!==1||o[0]!==s)throw new f(bn(t,o,`one pose, (${s},)`));return it(r,t,n)}function bn(e,t,n){let r=Oe(t);return`${e.name}: q has shape ${r}; expected ${n}, ${st(e)}`}function it(e,t,n){let r=re(t),o=s=>n==="deg"&&r[s%r.length]?j:1;return{...e,values:e.values.map((s,a)=>s*o(a)),units:e.units.map((s,a)=>s*o(a))}}function So(e,t){let n=re(t),r=n.some(Boolean)&&!n.every(Boolean),o=r?J(e.flatMap(({values:i})=>i.filter((c,l)=>n[l])).map(D)):[],s=0,a=(i,c)=>{if(!r||!n[c])return i;let l=o[s++];return i>0?Math.max(l,i):i};return e.map(i=>it({...i,units:i.units.map(a)},t,"deg"))}var ne=e=>e.replace(/\(t\)|[_{}'*^\\ ]/g,"").replace(/[ϑθ]/g,"theta").toLowerCase();function Oo(e,t,n,r){let o=new Map([...t.values??[],...r]),s=new Map([...o].map(([u,p])=>[ne(u),p])),a=new Map(e.filter(u=>s.has(ne(u))).map(u=>[u,s.get(ne(u))])),i=new Map(e.filter(u=>!a.has(u)).map(u=>[u,No(u)])),[c,l]=To([...new Set([...i.values()].flatMap(u=>u??[]))],t);for(let[u,p]of i){let h=(p??[]).map(d=>c.get(d));if(!h.length||h.includes(void 0)){let d=[...rt(t),...(t.values??[]).map(([g])=>g)].join(", ");throw new f(v("unknown symbol",{arm:t.name,name:u,known:d}))}a.set(u,_o(ne(u),h.map(d=>n[d])))}return[a,l]}function No(e){let t=ne(e),n=$o.exec(t);if(n)return[Number(n[2])];let r=hn.exec(t);return r?[...r[2].matchAll(/\d/g)].map(Number):null}function To(e,t){let n=nt(t),r=new Map(n.map((a,i)=>[a,i])),o=a=>e.every(i=>i>=a&&i<a+n.length);if(e.every(a=>r.has(a)))return[r,[]];let s=a=>new Map(n.map((i,c)=>[c+a,c]));return o(1)?[s(1),[v("taken: counted on",{joints:n.join(", ")})]]:o(0)?[s(0),[v("taken: from zero",{joints:n.join(", ")})]]:[r,[]]}function _o(e,t){let n=hn.exec(e);if(!n)return t[0];let r=[...n[2].matchAll(/([+-]?)\d/g)].map(([,s])=>s==="-"?-1:1),o=t.reduce((s,a,i)=>s+r[i]*a,0);return e[0]==="c"?Math.cos(o):Math.sin(o)}var lt={};x(lt,{ownValues:()=>be,valuesCall:()=>Io});var ko=/^\s*(?:values\s*=\s*)?(?:dict\s*\(([^]*)\)|\{([^]*)\})\s*$/,Ro=/^\s*(["']?)(.+?)\1\s*[=:]\s*([^=:]+?)\s*$/s,Lo=/^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;function be(e){let[,t,n]=ko.exec(e)??[];return(t??n??e).split(/[,;\n]/).filter(o=>o.trim()).map(o=>{let[,,s,a]=Ro.exec(o)??[],[i,c]=s?[E(s),z(a)]:["",null];if(c!==null&&Lo.test(i))return[i,c];throw new f(`your own symbols: ${B(o.trim())} is not read; expected such as h = 0.333`)})}function Io(e){let t=be(e).map(([n,r])=>`"${n}": ${D(r)}`);return t.length?[`values={${t.join(", ")}}`]:[]}var pt={};x(pt,{checkerOf:()=>ye,load:()=>oe,ready:()=>mt,register:()=>Fo});var ut=new Map,xe=new Map,zo=typeof document>"u"?null:document.currentScript?.src,Fo=(e,t)=>{ut.set(e,t)},ye=e=>ut.get(e),mt=e=>ut.has(e)?Promise.resolve():oe($[e].script);function oe(e){return xe.has(e)||xe.set(e,Co(e)),xe.get(e)}function Co(e){return new Promise((t,n)=>{let r=()=>{xe.delete(e),n(new Error(`The script judge-${e}.js could not be loaded.`))},o=new URL(`judge-${e}.js`,zo).href;document.head.append(Object.assign(document.createElement("script"),{src:o,onload:()=>t(),onerror:r}))})}var xn=12e3,Po={table:2e3,q:500,wrench:300,values:500,answer:8e3,target:1e3},yn=2e4,Do="the arm asked about",R="own",W=["rad","deg"],dt={unit:W,first:["v","omega"],plane:["zy","yz","zx","xz"],pace:["even","rest"],lengths:["","m","cm","mm"],angles:["",...W],convention:["","standard","craig"]},Z={ask:"jacobian",arm:"",table:"",q:"",unit:"rad",frame:"0",first:"v",wrench:"",values:"",answer:"",columns:"",lengths:"",angles:"",convention:"",target:"",radius:"0.1",plane:"zy",period:"5",steps:"",pace:"even"};function ft(e){let t=Object.entries(e).filter(([n,r])=>r!==Z[n]||n==="ask"||n==="arm");return`#${new URLSearchParams(t)}`}function ht(e,t){let n=e.replace(/^#/,"");if(!/^ask=/.test(n))return{question:null,words:""};let r=i=>({question:null,words:`The link could not be read: ${i}.`});if(n.length>xn)return r(`it has ${n.length} characters; ${xn} are the most`);let o=new URLSearchParams(n),s={...Z};for(let[i,c]of o){if(!Object.hasOwn(Z,i))return r(`it has a field “${i.slice(0,40)}”`);if(c.length>(Po[i]??40))return r(`its ${i} is too long`);s[i]=c}if(!Object.hasOwn($,s.ask))return r("it asks what is not judged here");if(s.arm!==R&&!t.includes(s.arm))return r(`there is no arm called “${s.arm}” here`);let a=Object.keys(dt).find(i=>!dt[i].includes(s[i]));return a?r(`its ${a} is none`):/^\d{1,2}$/.test(s.frame)?{question:s,words:""}:r("its frame is none")}function gt(e,t){if(e.arm!==R)return t.find(({key:s})=>s===e.arm);if(!e.table.trim())throw new f("Type the table of your arm: a row for each joint, a α d θ.");let n=new Map($[e.ask].fields.includes("values")?be(e.values):[]),r=F(e.table).filter((s,a)=>a||!s.some(i=>/^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(i))).map((s,a)=>Go(s.length===5?s.slice(1):s,a+1,e.unit,n)),o=Pe(r);if(o)throw new f(`${o}.`);return{...De(r,{name:"",home:[],rows:[]}),name:Do}}var Bo=["a","alpha","d","theta"],qo=/^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;function Go(e,t,n,r){if(e.length!==4)throw new f(`Row ${t} of the table has ${e.length} entries; expected four: a α d θ.`);let o=e.map((p,h)=>T(p||"0",`row ${t}, ${Bo[h]}`)),s=o.map(p=>[..._(p)].filter(h=>!r.has(h))),a=s.flatMap((p,h)=>p.filter(d=>h<2||!qo.test(d)));if(a.length)throw new f(`Row ${t} of the table: no value for ${a[0]}; write numbers, and a variable such as q1.`);let[i,c,l,u]=o.map((p,h)=>{let d=n==="deg"&&h%2&&!/deg|°|pi|π/.test(e[h]);return H(p,g=>r.get(g)??0)*(d?j:1)});return{kind:s[2].length?"prismatic":"revolute",a:i,alpha:c,d:l,theta:u}}function wt(e,t){try{let n=gt(e,t),r=Uo(e,n);if(r)return{error:r,arm:n};let o=vn(e)?at(e.q,n,e.unit).values:void 0;if(!e.answer.trim())return{error:"Type or paste your answer.",arm:n,q:o};let s=$[e.ask].longest??yn;if(e.answer.length>s)return{error:`The answer is longer than ${s} characters.`,arm:n,q:o};let a=ye(e.ask);return a?{report:a.verdict(e,n),arm:n,q:o}:{error:"The checker is being loaded.",waiting:!0,arm:n,q:o}}catch(n){if(n instanceof f)return{error:Ho(n.message)};throw n}}var vn=({ask:e})=>$[e].fields.includes("q"),Uo=(e,t)=>vn(e)&&!e.q.trim()?`Type the pose: ${b(t).length} joint values.`:null,Ho=e=>e.slice(0,1).toUpperCase()+e.slice(1);function Wo(e,t){let n=gt(e,t),[r,o]=e.arm===R?["arm",Ko(n)]:[n.python,Zo(n.python)],{call:s,imports:a=[]}=ye(e.ask),i=[...o,...a,"from helpers import checks",""];return e.arm===R&&i.push(...Vo(n),""),i.push(`mine = ${Ne(e.answer)}`,`print(${s(e,r,n)})`),`${i.join(`
`)}
`}var Zo=e=>[`from helpers.robots import ${/^\w+/.exec(e)[0]}`],$n={revolute:"revolute",prismatic:"prismatic",fixed:"fixed"},Ko=e=>[`from helpers.arm import Arm, ${[...new Set(e.rows.map(({kind:t})=>$n[t]))].sort().join(", ")}`],Vo=e=>["rows = [",...e.rows.map(({kind:t,a:n,alpha:r,d:o,theta:s})=>`    ${$n[t]}(a=${n}, alpha=${r}, d=${o}, theta=${s}),`),"]",`arm = Arm("${e.name}", rows)`];var vt={};x(vt,{MARKS:()=>yt,better:()=>as,both:()=>jn,cause:()=>Xo,complete:()=>os,explain:()=>ts,explainAll:()=>En,linesOf:()=>ve,nameOf:()=>Qo,several:()=>ss,textOf:()=>is,wordsOf:()=>An});var Yo=.6,Jo=.85,xt=.7,Xo=(e,t={})=>({keys:[e],fields:[t]}),jn=(e,t)=>({keys:[...e.keys,...t.keys],fields:[...e.fields,...t.fields]}),Qo=({keys:e,fields:t})=>e.map((n,r)=>es(n,t[r])).join(" + ");function es(e,t){if("_of"in t)return t._of;let n=Object.entries(t).filter(([r])=>!r.startsWith("_"));return[e,...n.map(([,r])=>r)].join(":")}function An({keys:e,fields:t}){let[n,r]=e.map((o,s)=>v(o,t[s]));return r===void 0?n:v("and also",{first:n,second:ue(r)})}var ts=(e,t,n,r,o,s=xt)=>En(e,t,[n],r.map((a,i)=>[[a],o[i]]),s)[0];function En(e,t,n,r,o=xt){let s=n.map(i=>{let c=e.filter((u,p)=>Math.abs(u-t[p])>i[p]).length,l=[Math.max(3,Yo*c),Math.max(4,Jo*c)];return{band:i,count:c,least:l,named:[]}}),a=0;for(let[i,c]of r){let l=i.length>1?2:i[0].keys.length;for(let{band:u,count:p,least:h,named:d}of s){let g=ns(e,c,u,p,h[l-1]);(g?p-g>=h[l-1]:p>0)&&d.push({k:a,cost:l+o*g,parts:i,A:c})}a++}return s.map(i=>rs(e,i))}function ns(e,t,n,r,o){let s=0;for(let a=0;a<e.length;a++)if(!(Math.abs(e[a]-t[a])<=n[a])&&(s++,r-s<o))return s;return s}function rs(e,{band:t,named:n}){if(!n.length)return null;let r=i=>Math.round(i*1e6);n.sort((i,c)=>r(i.cost)-r(c.cost)||i.k-c.k);let[{cost:o,A:s}]=n;return{causes:n.filter(i=>i.cost===o).map(({parts:i})=>i.reduce(jn)),odd:e.map((i,c)=>!(Math.abs(i-s[c])<=t[c]))}}var os=e=>!!e&&!e.odd.includes(!0);function ss(e,t=3){let n=[...new Set(e.map(An))].slice(0,e[0].keys.length===1?t:1);return n.length===1?n[0]:v("or",{first:n[0],others:Se(n.slice(1).map(ue),"or")})}function as(e,t=xt){let n=r=>r.causes[0].keys.length+t*r.odd.filter(Boolean).length;return e.filter(Boolean).reduce((r,o)=>r&&n(r)<=n(o)?r:o,null)}var yt={[de]:"✔",[Y]:"◐",[fe]:"≈",wrong:"✘"},ve=({headline:e,findings:t,taken:n,notes:r})=>[...t.filter(({what:o,words:s})=>o!=="cause"&&!e.includes(s.slice(1))).map(({words:o})=>o),...n.map(o=>`Taken as ${o}`),...r.map(o=>`Note: ${o}`)],is=e=>[e.headline,...ve(e).map(t=>`- ${t}`)].join(`
`);var Nt={};x(Nt,{matrixOf:()=>kn,namesOf:()=>_n,showRead:()=>Et,tell:()=>Ot,typeset:()=>ae});var cs="http://www.w3.org/1998/Math/MathML",[$t,L,Mn,C]=[1,2,3,4],[ls,us]=["⁡","⁢"],ms={alpha:"α",beta:"β",gamma:"γ",delta:"δ",theta:"θ",th:"θ",phi:"φ",psi:"ψ",omega:"ω",lambda:"λ",pi:"π",inf:"∞"},ps={asin:"arcsin",acos:"arccos",atan:"arctan",sind:"sin",cosd:"cos"},ds=/^(?:[Ff]loat|Integer|float64|float32|int64)$/,fs=/^(?:radians|deg2rad)$/,y=e=>["mo",e],M=e=>e.length===1?e[0]:["mrow",e],$e=e=>["math",[M(S(e).pieces)]];function se([e,t]){let n=document.createElementNS(cs,e);return e==="math"&&n.setAttribute("displaystyle","true"),n.append(...typeof t=="string"?[t]:t.map(se)),n}var jt=([e,t])=>e==="num"||e==="neg"&&t[0]==="num";function S(e){let[t,n,r]=e;if(t==="num")return hs(n);if(t==="name")return{level:C,pieces:[gs(n)]};if(t==="call")return ws(n,r);if(t==="^")return{level:Mn,pieces:[["msup",[M(P(n,C)),M(S(r).pieces)]]]};if(t==="/"){let o=[n,r].map(s=>M(S(s).pieces));return{level:L,pieces:[["mfrac",o]]}}return t==="*"?bs(e):ys(e)}function P(e,t){let{level:n,pieces:r}=S(e);return n<t?[M([y("("),...r,y(")")])]:r}function hs(e){let[t,n]=String(Math.abs(e)).split("e"),r=[["mn",t]];if(n){let o=M([...n[0]==="-"?[y("−")]:[],["mn",n.replace(/^[+-]/,"")]]);r.push(y("⋅"),["msup",[["mn","10"],o]])}return e<0?{level:$t,pieces:[y("−"),...r]}:{level:n?L:C,pieces:r}}function gs(e){let[,t,n,r]=/^([A-Za-z]+)_?(.*?)('?)$/.exec(e.replace(/[{}]/g,""));if(t==="deg"&&!n)return["mi","°"];let o=["mi",(ms[t]??t)+r.replace("'","′")],a=(n.match(/\d+|[A-Za-z_]+|[+-]/g)??[]).map(i=>[/\d/.test(i)?"mn":/\w/.test(i)?"mi":"mo",i.replace("-","−")]);return a.length?["msub",[o,M(a)]]:o}function ws(e,t){if(ds.test(e))return S(t);if(e==="sqrt")return{level:C,pieces:[["msqrt",[M(S(t).pieces)]]]};if(e==="abs")return{level:C,pieces:[M([y("|"),...S(t).pieces,y("|")])]};if(fs.test(e))return{level:L,pieces:[...P(t,C),["mi","°"]]};let n=e.endsWith("d")?[["mi","°"]]:[],r=P(t,C),s=t[0]==="name"||t[0]==="num"||r[0][0]==="mrow"?r:[M([y("("),...r,y(")")])];return{level:Mn,pieces:[["mi",ps[e]??e],y(ls),...s,...n]}}function bs(e){let t=On(e,["*"]).map(([,o])=>o),n=t[0][0]==="neg"||t[0][0]==="num"&&t[0][1]<0,r=n?S(t[0]).pieces:P(t[0],L);return t.slice(1).forEach((o,s)=>{o[0]==="name"&&o[1]==="deg"||r.push(y(xs(t[s],o)?"⋅":us)),r.push(...P(o,L))}),{level:n?$t:L,pieces:r}}var xs=(e,t)=>Sn(t)||e[0]==="call"&&t[0]!=="call"&&e[1]!=="sqrt"&&e[1]!=="abs",Sn=([e,t])=>e==="num"||["^","*"].includes(e)&&Sn(t);function ys(e){let t=[];for(let[n,r]of On(e,["+","-"]))n&&t.push(y(n==="-"?"−":"+")),n?t.push(...P(r,L)):r[0]==="neg"?t.push(y("−"),...P(r[1],L)):t.push(...S(r).pieces);return{level:$t,pieces:t}}function On(e,t){let n=[];for(;t.includes(e[0]);)n.push([e[0],e[2]]),e=e[1];return[["",e],...n.reverse()]}var vs={v:["vx","vy","vz","ωx","ωy","ωz"],omega:["ωx","ωy","ωz","vx","vy","vz"]},$s=["a (m)","α","d (m)","θ"],At=40,Tn=8e3;function _n({ask:e,first:t},n,[r,o]){let s=b(n).map(c=>c+1),a=c=>s.length===o?`joint ${s[c]}`:String(c+1),i={torques:r===1?["τ"]:[],jacobian:r===6?vs[t]:[]}[e]??[];return{columns:Array.from({length:o},(c,l)=>a(l)),rows:Array.from({length:r},(c,l)=>i[l]??`row ${l+1}`)}}function kn(e,{report:t,arm:n}){let r=t?.typed;if(!r||r.shape.length!==2)return null;let o=e.ask==="torques"&&r.shape[1]===1,[s,a]=o?[1,r.values.length]:r.shape,i=t.wrong?.length===r.values.length?t.wrong:[];return{..._n(e,n,[s,a]),typed:r,wrong:i,shape:[s,a]}}function Et(e,t,n){let r=js(t,n);if(e.hidden=!r,!r)return;let{columns:o,rows:s,cell:a,unread:i=0}=r,c=m("tr",{},m("td"),o.map(g=>m("th",{scope:"col"},g))),l=s.slice(0,At).map((g,K)=>m("tr",{},m("th",{scope:"row"},g),o.map((ie,ce)=>a(K,ce)))),u=s.length>At?`, its first ${At} of ${s.length} rows`:"",p=i?`; ${i===1?"1 entry":`${i} entries`} could not be`:"",h=m("caption",{},`How your answer is read${u}${p}`),d=t.ask==="table"?"table.read":"table.read.matrix";e.replaceChildren(m(d,{},h,m("thead",{},c),m("tbody",{},l)))}function js(e,t){let{table:n}=t.report??{};return n?As(n):Es(e,kn(e,t))??Ms(e,t)}var As=({cells:e,trees:t,wrong:n})=>({columns:$s,rows:e.map((r,o)=>String(o+1)),cell(r,o){let[s,a]=[t[r][o],e[r][o]],i=/^-?q_\d+$/.test(a);return St(s&&!jt(s)?Rn(s,i?"":a):Mt(a),n[r][o])}});function Es({answer:e},t){if(!t)return null;let{typed:n,wrong:r,shape:o}=t,s=e.length>Tn?[]:n.trees??[];return{...t,cell(a,i){let c=a*o[1]+i,l=s[c]&&!jt(s[c]);return St(l?Rn(s[c],Nn(n,c)):Mt(Nn(n,c)),r[c])}}}function Ms({ask:e,answer:t},{error:n,waiting:r,arm:o,q:s}){if(!n||r||!o||!t.trim()||e==="trace"||t.length>Tn)return null;let a=Ss(e,t).map(c=>c.map(l=>Os(e,l,o,s))),i=Math.max(0,...a.map(c=>c.length));return{columns:Array.from({length:i},(c,l)=>String(l+1)),rows:a.map((c,l)=>`row ${l+1}`),unread:a.flat().filter(({tree:c})=>!c).length,cell(c,l){let{tree:u,text:p}=a[c][l]??{};return p===void 0?m("td"):u?m("td",{},se($e(u))):St(p,!0,"not read: ")}}}function Ss(e,t){try{let n=te(F(t));return e==="table"&&!n[0].some(r=>/\d/.test(r))?n.slice(1):n}catch(n){if(n instanceof f)return[];throw n}}function Os(e,t,n,r){let o=e==="branches"||e==="pose";try{let s=T(E(o?t.replace(/^.*[=:]/,""):t).replace(/\*+$/,"")||"0");return e==="jacobian"&&r&&ot(n,r).known(_(s)),{tree:s,text:t}}catch(s){if(s instanceof f)return{tree:null,text:t};throw s}}function Nn({values:e,units:t},n){let r=Math.min(6,t[n]?Math.max(0,Math.round(-Math.log10(t[n]))):4);return(Number(e[n].toFixed(r))+0).toFixed(r)}var Mt=e=>ae(e.replaceAll("-","−")),Rn=(e,t)=>t?[se($e(e)),m("span.value",{},"= ",Mt(t))]:[se($e(e))],St=(e,t,n="wrong: ")=>t?m("td.off",{},m("span.unseen",{},n),e):m("td",{},e);function Ot(e,{report:t,error:n}){if(e.className=`verdict ${t?.grade??""}`,!t)return e.replaceChildren(m("p",{},ae(n)));let r=ve(t).filter(a=>!t.headline.endsWith(a.slice(1))),o=r.length?[m("ul",{},r.map(a=>m("li",{},ae(a))))]:[],s=m("span",{"aria-hidden":"true"},`${yt[t.grade]} `);return e.replaceChildren(m("p.headline",{},s,ae(t.headline)),...o)}var Ns=/(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g,Ts={theta:"θ",alpha:"α"};function ae(e){let t=[],n=0;for(let r of e.matchAll(Ns)){let[o,s,a,i]=r;t.push(e.slice(n,r.index),m("i",{},Ts[s]??s)),t.push(m("sub",{},(a??i).replace("-","−"))),n=r.index+o.length}return[...t,e.slice(n)]}var Ln={"arm.js":Be,"dom.js":qe,"kinematics.js":Ie,"judge/ask.js":bt,"judge/digits.js":Ke,"judge/door.js":ct,"judge/formula.js":Je,"judge/grid.js":tt,"judge/judges.js":_e,"judge/own_values.js":lt,"judge/ranking.js":vt,"judge/registry.js":pt,"judge/say.js":Te,"judge/shown.js":Nt};var In=e=>[["","as it looks"],...e.map(t=>[t,t])],zn={spellcheck:"false",autocomplete:"off",autocapitalize:"off"},Cn={table:{label:"Table",rows:6,whole:!0,hint:"A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen."},q:{label:"Pose q",hint:"",whole:!0},unit:{label:"Angles in",choices:W.map(e=>[e,e])},frame:{label:"Rows in the axes of",choices:[]},first:{label:"Order of the rows",choices:[["v","v, then ω"],["omega","ω, then v"]]},wrench:{label:"Wrench on the tool, by the world",whole:!0,hint:"Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down."},values:{label:"Your own symbols",whole:!0,hint:"Numbers for those that the arm does not have, in m and rad, as in “h = 0.333, l = 0.1”."},columns:{label:"Order of the columns",hint:"As in “theta d a alpha”; guessed where it is empty."},lengths:{label:"Lengths in",choices:In(["m","cm","mm"])},angles:{label:"Angles in",choices:In(W)},convention:{label:"Convention",choices:[["","as it looks"],["standard","standard"],["craig","modified (Craig)"]]},target:{label:"Where the tip should be",rows:4,whole:!0,hint:"A point x, y, z in m, or a pose: its three or four rows, in base axes."},radius:{label:"Radius of the circle below the tip, in m"},plane:{label:"Its plane",choices:[["zy","towards +y first"],["yz","towards −y"],["zx","towards +x"],["xz","towards −x"]]},period:{label:"Time for it, in s"},steps:{label:"Steps",hint:"Empty: as many as your answer has."},pace:{label:"Pace",choices:[["even","even"],["rest","from rest to rest"]]},answer:{label:"Your answer",hint:"",rows:8,whole:!0}},_s={jacobian:"Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",table:"A row for each link, with heads or without: lists, Link(…) lines, MATLAB, LaTeX, Markdown, CSV or cells.",branches:"A row for each answer, angles in the joints' order; names such as theta1 = may stand before them.",pose:"One value for each joint, in the joints' order; names such as theta1 = may stand before them.",trace:"A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",torques:"One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet."},ks="Pose q at which the circle begins",Rs=["frame","first","values","columns","lengths","angles","convention"],Pn=([e,t])=>m("option",{value:e},t);function Ls({choices:e,rows:t,hint:n},r,o){let s=n===void 0?{}:{"aria-describedby":[`${r}-hint`,...o].join(" ")},a={id:r,...s};return e?m("select",a,e.map(Pn)):t?m("textarea",{rows:t,wrap:"off",...zn,...a}):m("input",{...zn,...a})}function Is(e,t,n){let r=m("label",{for:t},e.label),o=e.hint===void 0?[]:[m("p.about",{id:`${t}-hint`},e.hint)];return m(e.whole?"div.field.whole":"div.field",{},r,n,...o)}function Dn(e,t,n){let r={ask:{label:"Question",choices:Object.entries($).map(([l,{title:u}])=>[l,u])},arm:{label:"Arm",choices:[...t.map(({key:l,title:u})=>[l,u]),...t.length>1&&n?[]:[[R,"My own table"]]]},...Cn},o=l=>`${e}-${l}`,s=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Ls(u,o(l),l==="answer"?[o("private")]:[])])),a=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Is(u,o(l),s[l])]));for(let l of n?zs(n,t):[])a[l]?.classList.add("given");let i=n?Fs(n,t):"";return n&&(s.answer.rows=6),{form:m("form",{"aria-label":`Check an answer${i&&`: ${i}`}`},i?m("p.asked",{},"Judged here: ",i):[],Object.values(a)),fields:s,boxes:a}}var zs=(e,t)=>[...Object.keys(e),...Rs,...t.length<2?["arm"]:[],..."q"in e?["unit"]:[]];function Fs({ask:e,q:t,wrench:n},r){let o=r.length===1?`, ${r[0].title}`:"";return[`${$[e].title}${o}`,t&&`q = (${t})`,n&&`wrench (${n})`].filter(Boolean).join(", ")}function Bn({fields:e,boxes:t},n,r){let o=new Set(["ask","arm","answer",...$[n.ask].fields]);n.arm===R&&o.add("table");for(let[i,c]of Object.entries(t))c.hidden=!o.has(i);Fn(t.answer,_s[n.ask]??"");let s=r.find(({key:i})=>i===n.arm);G(t.q.querySelector("label"),n.ask==="trace"?ks:Cn.q.label),Fn(t.q,s?Cs(s):"One value for each joint, in the table's order.");let a=s?s.rows.length:16;if(e.frame.options.length!==a+1){let i=l=>l?`frame ${l}`:"the base",c=Array.from({length:a+1},(l,u)=>Pn([String(u),i(u)]));e.frame.replaceChildren(...c),e.frame.value=n.frame}}var Fn=(e,t)=>G(e.querySelector(".about"),t),Cs=e=>`${b(e).map(n=>`q_${n+1}`).join(", ")}${re(e).includes(!1)?"; m where a joint slides":""}`;var Ps=5e4,qn=120,Ds=350,Gn="Nothing that you type leaves this page: a script in it judges, without a network too.",Bs="It names the mistake and does not print the solution.",qs=0;function Un(e){let{arms:t,examples:n=[],given:r}=JSON.parse(e.querySelector("script").textContent),o=`judge-${++qs}`,s=Dn(o,t,r),{form:a,fields:i}=s,c=Gs(o,r),l=[],u={...Z,arm:t[0]?.key,...r??n[0]},p,h=0,d=!1,g=w=>u[w].length>Ps?"":u[w],K=()=>{for(let[w,O]of Object.entries(i))O.value!==g(w)&&(O.value=g(w));Bn(s,u,t)},ie=w=>G(c.said,w),ce=()=>Ot(c.verdict,p),le=()=>{Tt(),ce()},Hn=()=>{Tt(),h=setTimeout(ce,Ds-qn)},Tt=()=>{clearTimeout(h),d=!1,p=wt(u,t),p.waiting&&mt(u.ask).then(le,({message:w})=>ie(w)),i.answer.setAttribute("aria-invalid",String(p.report?.grade==="wrong")),Et(c.taken,u,p);for(let w of l)w(u,p)},je=w=>{u={...u,...w},K(),le()};a.addEventListener("input",({target:w,inputType:O})=>{let I=Object.keys(i).find(Wn=>i[Wn]===w);I&&(u={...u,[I]:w.value},I==="arm"&&(u.frame="0"),(I==="arm"||I==="ask")&&(u.q=Us(u,n)?.q??u.q),K(),d=!0,clearTimeout(h),O==="insertFromPaste"||O==="insertFromDrop"?le():h=setTimeout(Hn,qn))}),a.addEventListener("submit",w=>w.preventDefault());let _t=()=>{let{question:w,words:O}=ht(location.hash,t.map(({key:I})=>I));(w||O)&&e.scrollIntoView({block:"start"}),ie(O),w&&je(w)};return e.replaceChildren(a,...Object.values(c)),je({}),r||(addEventListener("hashchange",_t),_t()),{stub:e,arms:t,examples:n,given:r,...s,parts:c,...{question:()=>u,verdict:()=>(d&&le(),p)},put:je,follow:w=>{l.push(w),w(u,p)},say:ie,links:{fragment:()=>ft(u),open:()=>!0}}}function Gs(e,t){return{verdict:m("div.verdict",{role:"status","aria-live":"polite","aria-atomic":"true"}),taken:m("div.scroll",{role:"region",tabindex:"0","aria-label":"How your answer is read"}),tools:m("div.tools"),said:m("p.about",{role:"status"}),private:m("p.private",{id:`${e}-private`},t?Gn:`${Gn} ${Bs}`)}}var Us=(e,t)=>t.find(n=>n.arm===e.arm&&n.ask===e.ask);document.head.append(Object.assign(document.createElement("style"),{textContent:Rt}));for(let e of document.querySelectorAll(".arm-judge"))V.push(Un(e));if(V.some(({given:e})=>!e))oe("page");else for(let{stub:e}of V)e.addEventListener("focusin",()=>oe("page"),{once:!0});Me({"and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","unknown symbol":"{arm}: no value for {name}; known are {known}. Give values={'{name}': ...} if it is a length of yours","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what} holds NaN or infinity; expected {wanted}",ragged:"{what} has rows of {widths} entries; expected rows of one length","taken: counted on":"symbols numbered on past what does not move: 1, 2, 3 ... are joints {joints}","taken: from zero":"symbols numbered from 0: 0, 1, 2 ... are joints {joints}"});return Jn(Hs);})();
