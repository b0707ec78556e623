var ArmJudge=(()=>{var Me=Object.defineProperty;var Vn=Object.getOwnPropertyDescriptor;var Yn=Object.getOwnPropertyNames;var Jn=Object.prototype.hasOwnProperty;var x=(e,t)=>{for(var n in t)Me(e,n,{get:t[n],enumerable:!0})},Xn=(e,t,n,r)=>{if(t&&typeof t=="object"||typeof t=="function")for(let o of Yn(t))!Jn.call(e,o)&&o!==n&&Me(e,o,{get:()=>t[o],enumerable:!(r=Vn(t,o))||r.enumerable});return e};var Qn=e=>Xn(Me({},"__esModule",{value:!0}),e);var Ks={};x(Ks,{kit:()=>zn});var Re={};x(Re,{ArmError:()=>h,learn:()=>Oe,listed:()=>Ne,lower:()=>ue,quoted:()=>Te,say:()=>y,shown:()=>B,size:()=>tr,spelled:()=>D,tuple:()=>ke});var Se={},Oe=e=>{Se={...Se,...e}};function y(e,t={}){let n=Se[e];for(let[r,o]of Object.entries(t))n=n.replaceAll(`{${r}}`,()=>String(o));return n}var h=class extends Error{},Ne=(e,t="and")=>e.length===1?e[0]:`${e.slice(0,-1).join(", ")} ${t} ${e.at(-1)}`,ue=e=>/^.(\p{Lu}|_)/su.test(e)?e:e.slice(0,1).toLowerCase()+e.slice(1),er=9e6;function tr(e,t=3){if(!Number.isFinite(e))return Number.isNaN(e)?"nan":e>0?"inf":"-inf";if(e===0)return"0";let[n,r]=nr(e,t).split("e"),o=Number(r),s=a=>a.includes(".")?a.replace(/\.?0+$/,""):a;return o>=t&&Math.abs(e)<er?(+`${n}e${r}`).toFixed(0):o<-4||o>=t?`${s(n)}e${_t(o)}`:s((+`${n}e${r}`).toFixed(Math.max(0,t-1-o)))}function nr(e,t){let n=e.toExponential(t-1),[r,o]=e.toExponential(t+25).split("e"),s=t===1?r.indexOf("."):r.indexOf(".")+t,a=r.slice(s).replace(".",""),i=r.slice(0,s);return/^50*$/.test(a)&&"02468".includes(i.at(-1))?`${i}e${o}`:n}var _t=e=>`${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;function D(e){let[t,n]=e.toExponential().split("e"),r=Number(n);if(e!==0&&(r<-4||r>=16))return`${t}e${_t(r)}`;let o=BigInt(Math.trunc(e)).toString();return r>20?o:String(e).includes("e")?e.toFixed(20).replace(/0+$/,""):String(e)}function B(e){let t=e.includes("'")&&!e.includes('"')?'"':"'",n={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},r=[...e].map(s=>n[s]??rr(s)).join(""),o=[...`${t}${r}${t}`];return o.length<=80?o.join(""):`${o.slice(0,77).join("")}...`}function rr(e){let t=e.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(e)||e===" "?e:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var ke=e=>e.length===1?`(${e[0]},)`:`(${e.join(", ")})`;function Te(e){return e.includes(`
`)&&!/"""|["\\]$/.test(e)&&!/[\r\0]/.test(e)?`r"""${e}"""`:JSON.stringify(e)}var Lt=`.arm-judge {
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
`;var _e={};x(_e,{judges:()=>V});var V=[];var Ge={};x(Ge,{KINDS:()=>Ft,LARGEST:()=>De,LONGEST:()=>Pe,MOST_ROWS:()=>Ce,TYPED:()=>Ct,carriedOver:()=>Bt,fits:()=>qt,homeOf:()=>gr,limited:()=>xr,outside:()=>br,range:()=>wr,reachOf:()=>yr,rowsFault:()=>Be,sameRow:()=>Dt,typedArm:()=>qe});var Fe={};x(Fe,{GRAVITY:()=>sr,cosSin:()=>Le,cross:()=>ze,dot:()=>ar,gravityTorque:()=>mr,jacobianColumns:()=>ur,joints:()=>b,liftedEnergy:()=>pr,linkFrames:()=>cr,matrix:()=>lr,minus:()=>Ie,norm:()=>ir,plus:()=>me,scaled:()=>It,wrenchTorque:()=>fr});var sr=9.81,ar=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],It=(e,t)=>[e*t[0],e*t[1],e*t[2]],me=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],Ie=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],ze=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],ir=e=>Math.sqrt(e.reduce((t,n)=>t+n*n,0)),q=(e,t,n,r)=>[e*t[0]+n*r[0],e*t[1]+n*r[1],e*t[2]+n*r[2]];function Le(e){let t=e/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(e),Math.sin(e)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var b=e=>e.rows.flatMap((t,n)=>t.kind==="fixed"?[]:[n]);function cr(e,t){let[n,r,o,s]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:n,y:r,z:o,o:s}],i=0;for(let c of e.rows){let l=c.kind==="fixed"?0:t[i++],[u,p]=Le(c.kind==="revolute"?c.theta+l:c.theta),[f,d]=Le(c.alpha),g=c.kind==="prismatic"?c.d+l:c.d;[n,r]=[q(u,n,p,r),q(u,r,-p,n)],s=me(q(g,o,c.a,n),s),[r,o]=[q(f,r,d,o),q(f,o,-d,r)],a.push({x:n,y:r,z:o,o:s})}return a}var lr=({x:e,y:t,z:n,o:r})=>[0,1,2].map(o=>[e[o],t[o],n[o],r[o]]).concat([[0,0,0,1]]);function ur(e,t,n=t.at(-1).o){return b(e).map(r=>{let{z:o,o:s}=t[r];return e.rows[r].kind==="revolute"?[...ze(o,Ie(n,s)),...o]:[...o,0,0,0]})}function mr(e,t,n=9.81){let r=zt(e,t);return b(e).map(o=>{let{z:s,o:a}=t[o],i=c=>e.rows[o].kind==="revolute"?ze(s,Ie(c,a))[2]:s[2];return r.reduce((c,{mass:l,centre:u,row:p})=>c+(p<o?0:l*n*i(u)),0)})}var pr=(e,t,n=9.81)=>zt(e,t).reduce((r,{mass:o,centre:s})=>r+o*n*s[2],0),zt=(e,t)=>e.rows.flatMap((n,r)=>n.body?[dr(n.body,t[r+1],r)]:[]);function dr([e,...t],{x:n,y:r,z:o,o:s},a){return{mass:e,row:a,centre:me(s,me(q(t[0],n,t[1],r),It(t[2],o)))}}var fr=(e,t)=>e.map(n=>n.reduce((r,o,s)=>r+o*t[s],0));var Ft=["revolute","prismatic","fixed"],Ce=16,Pe=100,De=1e3,Ct="Your arm",Pt=[["a",Pe],["alpha",De],["d",Pe],["theta",De]];function Be(e){if(!Array.isArray(e)||!e.length)return"the table has no rows";if(e.length>Ce)return`the table has ${e.length} rows; ${Ce} are the most`;for(let[t,n]of e.entries()){if(!Ft.includes(n?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[r,o]of Pt){if(!Number.isFinite(n[r]))return`row ${t+1} has no number for ${r}`;if(Math.abs(n[r])>o)return`row ${t+1} has ${n[r]} for ${r}; ${o} is the most`}}return null}var hr=({kind:e,a:t,alpha:n,d:r,theta:o})=>({kind:e,a:t,alpha:n,d:r,theta:o,lower:null,upper:null,speed:null,effort:null}),Dt=(e,t)=>e.kind===t.kind&&Pt.every(([n])=>Math.abs(e[n]-t[n])<1e-12);function qe(e,t){if(e.length===t.rows.length&&e.every((r,o)=>Dt(r,t.rows[o])))return t;let n={name:Ct,home:[],rows:e.map(hr)};return{...n,home:Bt(t,t.home,n,r=>r)}}function Bt(e,t,n,r){let o=new Map(b(e).map((s,a)=>[s,[e.rows[s].kind,t[a]??0]]));return b(n).map(s=>{let[a,i]=o.get(r(s))??[];return a===n.rows[s].kind?i:0})}var gr=e=>qt(e,e.home)?[...e.home]:b(e).map(()=>0),qt=(e,t)=>Array.isArray(t)&&t.length===b(e).length&&t.every(Number.isFinite);function wr(e){let t=e.kind==="revolute"?Math.PI:1;return[e.lower??-t,e.upper??t]}var br=(e,t)=>t<(e.lower??-1/0)-1e-9||t>(e.upper??1/0)+1e-9,xr=e=>b(e).some(t=>e.rows[t].lower!==null||e.rows[t].upper!==null),yr=e=>e.rows.reduce((t,n)=>t+Math.abs(n.a)+Math.abs(n.d)+(n.kind==="prismatic"?Math.abs(n.upper??.3):0),0)||.3;var Ue={};x(Ue,{attribute:()=>$r,calm:()=>Er,h:()=>m,indexed:()=>Ar,svg:()=>vr,whereNew:()=>jr,write:()=>G});function m(e,t={},...n){let[r,...o]=e.split("."),s=document.createElement(r);o.length&&(s.className=o.join(" "));for(let[a,i]of Object.entries(t))a.startsWith("on")?s.addEventListener(a.slice(2),i):i!==void 0&&i!==!1&&s.setAttribute(a,i===!0?"":i);return s.append(...n.flat()),s}function vr(e,t={},...n){let r=document.createElementNS("http://www.w3.org/2000/svg",e);for(let[o,s]of Object.entries(t))r.setAttribute(o,s);return r.append(...n),r}function G(e,t){e.textContent!==t&&(e.textContent=t)}function $r(e,t,n){e.getAttribute(t)!==n&&e.setAttribute(t,n)}function jr(e,t){let n=[];return r=>{let o=e(r);n.length&&o.every((s,a)=>s===n[a])||(n=o,t(r))}}var Ar=(e,t)=>[m("i",{},e),m("sub",{},String(t))],Er=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var yt={};x(yt,{ASKED:()=>v,CHOICES:()=>ht,EMPTY:()=>Z,LONGEST_ANSWER:()=>vn,OWN:()=>T,UNITS:()=>W,armOf:()=>bt,asPython:()=>Vo,fromFragment:()=>wt,judge:()=>xt,toFragment:()=>gt});var $=Math.PI/180,He=180/Math.PI;var v={jacobian:{title:"Jacobian at a pose",fields:["q","unit","frame","first","values"],script:"jacobian"},torques:{title:"Joint torques at a pose",fields:["q","unit","wrench"],script:"jacobian"},table:{title:"Denavit-Hartenberg table",fields:["columns","lengths","angles","convention","values"],script:"table"},branches:{title:"All joint angles for a target",fields:["target","unit"],script:"motion"},pose:{title:"Joint angles for one pose",fields:["target","unit"],script:"motion"},trace:{title:"Joints along a circle",fields:["q","unit","radius","plane","period","steps","pace"],script:"motion",longest:5e6}};var ut={};x(ut,{eachJoint:()=>it,inRadians:()=>lt,lookup:()=>at,numbered:()=>ot,numbers:()=>wn,pose:()=>ct,poseFault:()=>xn,rowsInRadians:()=>ko,turning:()=>re,variables:()=>st});var Ye={};x(Ye,{HALF:()=>Ht,HAND:()=>Wt,RIGHT:()=>de,ROUNDED:()=>fe,SLOPPY:()=>Zt,SO_FAR:()=>Y,TELLING:()=>Kt,WRONG:()=>Ze,bands:()=>Rr,beyond:()=>Lr,decimalsOf:()=>kr,farthest:()=>Ve,generous:()=>Vt,graded:()=>_r,margins:()=>Tr,units:()=>J});var[de,Y,fe,Ze]=["right","so far","rounded","wrong"],Ht=.51,Wt=3.01,Mr=1e-6,Zt=.001,Kt=.0021,Sr=13,Gt=-12,Or=/^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/,Ut=e=>+`1e${e}`;function Nr(e){let t=Or.exec(e.trim());if(!t||!(t[1]||t[2]))return null;let n=(t[1]+t[2]).replace(/^0+/,"").length,r=t[2].length-Number(t[3]??0);return{decimals:r,digits:n,first:n-1-r}}function J(e){let t=e.map(Nr),n=t.filter(i=>i&&i.digits&&i.first>Gt),r=i=>n.reduce((c,l)=>Math.max(c,l[i]),n.length?-1/0:0),[o,s]=[r("decimals"),r("digits")];if(s>=Sr||t.includes(null)&&o<=0)return e.map(()=>0);let a=n.every(i=>i.decimals<=s-1-i.first)&&n.some(i=>i.digits===s&&i.decimals<o);return t.map(i=>i?!a||!i.digits||i.first<=Gt?Ut(-o):Ut(Math.max(-o,i.first-s+1)):0)}function kr(e){let t=e.filter(n=>n>0);return t.length?Math.max(0,Math.round(-Math.log10(Math.min(...t)))):null}function Tr(e,t,n=null,r=null){let o=t.map(l=>Mr*l),s=e.map(()=>0);if(r!==null){let l=o.map(u=>Math.max(r,u*.001));return{allowed:l,band:l,loose:l,units:s,slop:s}}let a=e.map((l,u)=>Math.max(Ht*l,o[u])),i=e.map((l,u)=>Math.max(Wt*l,o[u])),c=i.map((l,u)=>Math.max(l,Zt*t[u]));return{allowed:a,band:i,loose:c,units:e,slop:n??s}}var Ke=(e,t,n)=>e.map((r,o)=>r+n*t[o]),Ve=({loose:e,band:t,slop:n})=>Ke(t,n,2).map((r,o)=>Math.max(r,e[o])),Vt=({allowed:e,slop:t})=>Ke(e,t,1);function Rr(e){let t=e.slop.some(Boolean)?[Ke(e.band,e.slop,2)]:[];return[e.band,...t,Ve(e),e.allowed]}var We=(e,t,n)=>e.every((r,o)=>Math.abs(r-t[o])<=n[o]),pe=(e,t)=>e.reduce((n,r,o)=>Math.max(n,Math.abs(r-t[o])),0);function _r(e,t,n,r){let o=r.filter(a=>pe(a,t)>Kt);for(let a of[n.allowed,Vt(n)]){let i=o.some(c=>We(e,c,a));if(We(e,t,a)){let c=Math.max(0,...n.units),l=o.reduce((u,p)=>Math.min(u,pe(p,t)),1/0);return i||c>l/2.1?Y:de}if(i)return Ze}if(!We(e,t,Ve(n)))return Ze;let s=pe(e,t);return o.some(a=>pe(e,a)<=s)?Y:fe}function Lr(e,t,{band:n,allowed:r}){let o=a=>e.map((i,c)=>Math.abs(i-t[c])>a[c]),s=o(n);return s.includes(!0)?s:o(r)}var Qe={};x(Qe,{isNumber:()=>U,number:()=>I,parse:()=>O,plain:()=>A,symbols:()=>N,value:()=>H});var Yt=2e4,Xt=60,Qt={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:e=>e*$,deg2rad:e=>e*$,degrees:e=>e*He,rad2deg:e=>e*He,sind:e=>Math.sin(e*$),cosd:e=>Math.cos(e*$),float:e=>e,Float:e=>e,Integer:e=>e,float64:e=>e,float32:e=>e,int64:e=>e},en={pi:Math.PI,deg:$,rad:1},Ir=e=>Object.hasOwn(Qt,e),tn=e=>Object.hasOwn(en,e),j=(e,t)=>[...e].map(n=>[n,t]),zr="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),Fr=new Map([...j("−–—‐‑‒﹣－","-"),...j("×⋅·∙∗","*"),...j("÷∕⁄","/"),...j("       　"," "),...j("​⁡⁢\uFEFF",""),...j("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((e,t)=>j(e,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((e,t)=>j(e,` ${zr[t]}`)),...j("π𝜋"," pi "),...j("°º"," deg"),["$"," "],["²","^2"],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),Cr=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)\b/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text|mathit|mathbf|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)\b/g," deg"],[/\\(?:cdot|times|ast)\b/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/\\d?t?frac\s*(\d)\s*(\d)/g,"(($1)/($2))"]],Pr=/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,Dr=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,Br=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,Je=new RegExp(String.raw`\s*(?:(${Dr})|(${Br})|(\*\*|[-+*/^()]))`,"y"),qr=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,Gr=/[cs]_?(?:\d|\{[\d+-]+\})+/g,Ur=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,U=e=>Ur.test(e);function A(e){if(U(e))return e;e=[...e].map(t=>Fr.get(t)??t).join("");for(let[t,n]of Cr)e=e.replace(t,n);for(let t="";t!==e;)[t,e]=[e,e.replace(Pr,"(($1)/($2))")];return e=e.replace(/\\([A-Za-z]+)/g," $1 "),e=e.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),e=e.replace(/(?<=\w)\s*\(t\)/g,""),e=e.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),e=e.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),e=e.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),e.replace(/[ \t]+/g," ").trim()}function O(e,t="the formula"){if(e.length>Yt)throw new h(`${t} has ${e.length} characters; expected at most ${Yt}`);let n=Wr(A(e));if(!n)throw new h(`${t} is ${B(e)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let r=Hr(n);if(r?.[1]!==n.length)throw new h(`${t} is ${B(e)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return r[0]}var S=class extends Error{};function Hr(e){try{return nn(e,0,0)}catch(t){if(t instanceof S)return null;throw t}}function Wr(e){let t=[];for(let n=0;n<e.length;n=Je.lastIndex){Je.lastIndex=n;let r=Je.exec(e);if(!r)return e.slice(n).trim()?null:t;let[,o,s,a]=r;if(o!==void 0)t.push(["num",o]);else if(a!==void 0)t.push(["sign",a==="**"?"^":a]);else for(let i of qr.test(s)?s.match(Gr):[s])t.push(["name",i])}return t}function he(e,t){if(t>=e.length)throw new S;return e[t]}function nn(e,t,n){if(n>Xt)throw new S;let[r,o]=Jt(e,t,n);for(;o<e.length&&["+","-"].includes(e[o][1]);){let[s,a]=Jt(e,o+1,n);[r,o]=[[e[o][1],r,s],a]}return[r,o]}function Jt(e,t,n){let[r,o]=Q(e,t,n);for(;o<e.length;){let[s,a]=e[o];if(a==="*"||a==="/"){let[i,c]=Q(e,o+1,n);[r,o]=[[a,r,i],c]}else if(a==="("||s!=="sign"){let[i,c]=rn(e,o,n);[r,o]=[["*",r,i],c]}else break}return[r,o]}function Q(e,t,n){if(n>Xt)throw new S;let r=he(e,t)[1];if(r==="-"){let[o,s]=Q(e,t+1,n+1);return[["neg",o],s]}return r==="+"?Q(e,t+1,n+1):rn(e,t,n)}function rn(e,t,n){let[r,o]=Xe(e,t,n);if(o>=e.length||e[o][1]!=="^")return[r,o];let[s,a]=Q(e,o+1,n+1);return[["^",r,s],a]}function Xe(e,t,n){let[r,o]=he(e,t);if(r==="num")return[["num",Number(o)],t+1];if(r==="name"&&Ir(o)&&t+1<e.length){let[i,c]=Zr(e,t+1,n);return[["call",o,i],c]}if(r==="name")return[["name",o],t+1];if(o!=="(")throw new S;let[s,a]=nn(e,t+1,n+1);if(he(e,a)[1]!==")")throw new S;return[s,a+1]}function Zr(e,t,n){if(he(e,t)[1]!=="-")return Xe(e,t,n);let[r,o]=Xe(e,t+1,n);return[["neg",r],o]}function N(e,t=new Set){if(e[0]==="name")return tn(e[1])?t:t.add(e[1]);for(let n of e.slice(1))Array.isArray(n)&&N(n,t);return t}function H(e,t){let n=X(e,t);if(!Number.isFinite(n))throw new h("a formula divides by zero or is too large; expected a finite value");return n}function X(e,t){let[n,r,o]=e;if(n==="num")return r;if(n==="name"){let c=tn(r)?en[r]:t(r);if(c===void 0)throw new h(`no value for ${r}`);return c}if(n==="neg")return-X(r,t);if(n==="call")return Qt[r](X(o,t));let[s,a]=[X(r,t),X(o,t)];if(n==="+")return s+a;if(n==="-")return s-a;if(n==="*")return s*a;if(n==="/")return a===0?NaN:s/a;let i=s**a;return Number.isFinite(i)||!Number.isFinite(s)?i:NaN}function I(e){try{return H(O(e),()=>{})}catch(t){if(t instanceof h)return null;throw t}}var rt={};x(rt,{cells:()=>z,withoutHeader:()=>te});var Kr=/(?<![^\n])[ \t]*```[^\n\r]*/g,on=String.raw`(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*`,Vr=new RegExp(on+String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,"g"),Yr=new RegExp(on,"g"),Jr=/((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*[#%][^\n\r]*/g,Xr=/^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[[({])/,Qr=/^[ \t\r\n]*=[ \t]*(?=[[({])/,eo=String.raw`\{(?:[A-Za-z]*matrix\*?|array|tabular)\}`,[to,no]=["begin","end"].map(e=>new RegExp(String.raw`\\${e}${eo}`,"g")),ro=new RegExp(String.raw`\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}`+String.raw`|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed|left[ \t]*[\[(|.]|\[|\()`+String.raw`|[$&{ \t\r\n]`,"g"),oo=/\\end\{[a-z]+\*?\}|\\label\{[^{}]*\}|\\(?:right[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]/g,so=/^[^=0-9][^=]*=$/,ao=[[/\\[hv]?phantom\{[^{}]*\}/g," "],[/\\num\{([^{}]*)\}/g,"$1"],[/\{([-+])\}/g,"$1"],[/(?<=[0-9])\{,\}(?=[0-9])/g,"."]],sn=e=>e.replace(Kr,"").replace(Jr,"$1").replace(Vr,"").replace(Yr,"").replace(Xr,"").replace(Qr,"");function an(e){let[t,n]=[to,no].map(r=>[...e.matchAll(r)]);if(t.length===1&&n.length===1){let[r,o]=[t[0].index,n[0].index+n[0][0].length],s=e.slice(0,r).replace(ro,""),a=e.slice(o).replace(oo,""),i=!s||so.test(s)&&!s.includes("frac");e=e.slice(i?r:0,a?e.length:o)}for(let[r,o]of ao)e=e.replace(r,o);return e}var cn=5e6,pn=String.raw`[\p{L}\p{N}_.]`,io=String.raw`^\s*(?:${pn}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`,co="Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym",ln=new RegExp(String.raw`${io}(?:${pn}*(?:${co})\s*\(\s*)+`,"u"),lo=/\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u,uo=/^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u,mo=/\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g,po=/\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|toprule|midrule|bottomrule|nonumber)\b/g,fo=/(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/,un=/^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m,mn=/^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im,ho=/^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/,dn=e=>{let t=e.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);return t.at(-1)===""&&t.pop(),t},et=(e,t)=>{let[n,r]=[0,e.length];for(;n<r&&t.includes(e[n]);)n++;for(;r>n&&t.includes(e[r-1]);)r--;return e.slice(n,r)},ee=(e,t)=>{let n=e.length;for(;n>0&&t.includes(e[n-1]);)n--;return e.slice(0,n)};function z(e){if(e.length>cn)throw new h(`the text has ${e.length} characters; expected at most ${cn}`);let t=go(et(sn(e).trim(),"`$").trim()).filter(n=>n.some(r=>r.trim())).map(n=>n.map(r=>r.trim()));if(!t.length)throw new h("the text is empty; expected rows of numbers or formulas");return t}function go(e){if(e.includes("\\begin{")||e.includes("\\\\"))return wo(e);if(e.split("|").length>2&&!e.split("|")[0].includes("["))return bo(e);let t=ln.test(e)?e.replace(ln,"").replace(lo,""):e;return t=ee(t.replace(uo,"").trim(),";").trim(),t&&"[({".includes(t[0])?fn(t):yo(t)}function wo(e){return e=an(e).replace(/\\left\s*[[(.|]\s*(?=\\begin)/g," ").replace(mo," ").replace(po," ").replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u,"").replace(/\\\\\s*\[[^\]]*\]/g,"\\\\").replaceAll("$"," ").replaceAll("\\["," ").replaceAll("\\]"," "),e.split(/\\\\|\\cr\b/).map(t=>t.split("&"))}var bo=e=>dn(e).map(t=>t.trim()).filter(t=>t.includes("|")&&!/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(t)).map(t=>t.replace(/^\||\|$/g,"").replaceAll("$"," ").split("|"));function fn(e){let t=ge(e);if(t.length===1&&!k(t[0]))return[t];if(t.every(k)){let r=t.map(ge);if(!r.some(a=>a.some(k)))return r;let o=a=>k(a)&&ge(a).length===1?ge(a)[0]:a,s=r.map(a=>a.map(o));return s.some(a=>a.some(k))?t.flatMap(fn):s}let n=k(e)?e.trim().slice(1,-1):e;return k(e)&&/[;\n]/.test(n)&&!n.includes("[")?n.replace(/\.\.\.[^\n]*\n/g," ").split(/[;\n]/).map(we):[t]}function k(e){return e=e.trim(),!e||!"[({".includes(e[0])||!hn(e)?!1:e[0]!=="("||nt(e.slice(1,-1))}var tt=e=>"[({".includes(e)?1:"])}".includes(e)?-1:0;function hn(e){let t=0;for(let n=0;n<e.length;n++)if(t+=tt(e[n]),!t)return n===e.length-1;return!1}function nt(e){let t=0;for(let n=0;n<e.length;n++)if(t+=tt(e[n]),e[n]===","&&!t)return!0;return!1}function ge(e){return e=ee(e.trim(),","),we(k(e)||e[0]==="["&&hn(e)?e.slice(1,-1):e)}function we(e){let t=e.trim().split(/\s+/);if(t.every(U))return t;let n=[],[r,o]=[0,""],s=nt(e);for(let a=0;a<e.length;a++){let i=e[a];r+=tt(i),(s?i===",":/\s/.test(i)&&!xo(e,a))&&!r?(n.push(o),o=""):o+=i,!s&&!r&&i==="]"&&(n.push(o),o="")}return n.push(o),n.filter(a=>a.trim()).map(a=>et(a.trim(),`'"`))}function xo(e,t){let[n,r]=[e.slice(0,t).trimEnd(),e.slice(t).trimStart()];return n.endsWith("*")&&r&&!"*/^)=".includes(r[0])&&fo.test(n)?!1:!n||!r||"+-*/^=(".includes(n.at(-1))||"*/^)=".includes(r[0])?!0:"+-".includes(r[0])&&r.length>1&&/\s/.test(r[1])||r.startsWith("deg")||r[0]==="°"}function yo(e){let t=un.exec(e);e=e.replace(new RegExp(un,"gm"),"");let r=(mn.test(e)?e.split(new RegExp(mn,"gim")).filter(s=>s.trim()):[e]).map(vo),o=r[0];return r.length>1&&r.every(s=>s.length===o.length)&&(o=o.map((s,a)=>r.flatMap(i=>i[a]))),t?o.map(s=>s.map(a=>I(a)?`${a}*${t[1]}`:a)):o}function vo(e){let t=dn(e).filter(o=>o.trim()&&!ho.test(o)).filter(o=>!/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(o)),n=o=>t.some(s=>ee(s.trim(),";").includes(o)),r=["	",";"].find(n);if(r){let o=s=>ee(et(s,`\r
 `),r);return t.map(s=>o(s).split(r).map(jo))}return t.some(nt)?$o(t):t.map(o=>we(o.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g,"")))}function $o(e){let t=e.every(n=>/^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(n));return e.map(n=>we(t?n.replaceAll(",","."):ee(n,",")))}function jo(e){let t=e.trim();return t[0]==='"'&&t.at(-1)==='"'&&(e=t.slice(1,-1)),e=e.replace(/^[ \t]*=/,""),e.split(",").length===2&&!e.includes("(")?e.replace(/(?<=\d),(?=\d)/g,"."):e}var Ao=e=>e.every(t=>t.every(n=>I(n)!==null));function te(e){let[t,...n]=e,r=t.map(A).filter(Boolean);return n.length>0&&r.every(s=>I(s)===null)&&Ao(n)?n:e}var Eo=/^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/,gn=/^([cs])((?:[+-]?\d)+)$/i,Mo=/^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/,ot=e=>b(e).map(t=>t+1),re=e=>b(e).map(t=>e.rows[t].kind==="revolute"),st=e=>ot(e).map(t=>`q_${t}`);function at(e,t,n=[]){let r=[];return{known:s=>{let[a,i]=To([...s].sort(),e,t,n);for(let c of i)r.includes(c)||r.push(c);return a},said:r}}var So=e=>{if(e.size)throw new h(y("symbols for numbers",{names:[...e].sort().join(", ")}));return new Map};function wn(e,t,n=So,r="numbers"){if(typeof e=="string")return Oo(e,t,n);let o=bn(e),s=e.flat(1/0);if(!s.every(Number.isFinite))throw new h(y("not finite",{what:t,wanted:r}));return{values:s,units:J(s.map(D)),shape:o,symbolic:!1}}var bn=e=>Array.isArray(e)?[e.length,...e.length?bn(e[0]):[]]:[];function Oo(e,t,n){let r=te(z(e)),o=[...new Set(r.map(d=>d.length))].sort((d,g)=>d-g);if(o.length>1)throw new h(y("ragged",{what:t,widths:o.join(", ")}));let s=r.flat().map(A),a=s.map(d=>U(d)?["num",Number(d)]:O(d,`an entry of ${t}`)),i=new Set;for(let d of a)N(d,i);let c=n(i),l=a.map(d=>H(d,g=>c.get(g))),u=s.map(No),p=J(u.map(([d])=>d)).map((d,g)=>d*u[g][1]),f=a.map((d,g)=>u[g][1]===1?d:["num",l[g]]);return{values:l,units:p,shape:[r.length,o[0]],symbolic:i.size>0,trees:f}}function No(e){let t=Mo.exec(e);return t?[t[1],Number(t[2])]:[e,1]}var it=e=>`one value for each of ${st(e).join(", ")}`;function ct(e,t,n="rad"){let r=wn(e,`${t.name}: q`,void 0,it(t)),o=typeof e=="string"?[r.values.length]:r.shape,s=b(t).length;if(o.length!==1||o[0]!==s)throw new h(xn(t,o,`one pose, (${s},)`));return lt(r,t,n)}function xn(e,t,n){let r=ke(t);return`${e.name}: q has shape ${r}; expected ${n}, ${it(e)}`}function lt(e,t,n){let r=re(t),o=s=>n==="deg"&&r[s%r.length]?$:1;return{...e,values:e.values.map((s,a)=>s*o(a)),units:e.units.map((s,a)=>s*o(a))}}function ko(e,t){let n=re(t),r=n.some(Boolean)&&!n.every(Boolean),o=r?J(e.flatMap(({values:i})=>i.filter((c,l)=>n[l])).map(D)):[],s=0,a=(i,c)=>{if(!r||!n[c])return i;let l=o[s++];return i>0?Math.max(l,i):i};return e.map(i=>lt({...i,units:i.units.map(a)},t,"deg"))}var ne=e=>e.replace(/\(t\)|[_{}'*^\\ ]/g,"").replace(/[ϑθ]/g,"theta").toLowerCase();function To(e,t,n,r){let o=new Map([...t.values??[],...r]),s=new Map([...o].map(([u,p])=>[ne(u),p])),a=new Map(e.filter(u=>s.has(ne(u))).map(u=>[u,s.get(ne(u))])),i=new Map(e.filter(u=>!a.has(u)).map(u=>[u,Ro(u)])),[c,l]=_o([...new Set([...i.values()].flatMap(u=>u??[]))],t);for(let[u,p]of i){let f=(p??[]).map(d=>c.get(d));if(!f.length||f.includes(void 0)){let d=[...st(t),...(t.values??[]).map(([g])=>g)].join(", ");throw new h(y("unknown symbol",{arm:t.name,name:u,known:d}))}a.set(u,Lo(ne(u),f.map(d=>n[d])))}return[a,l]}function Ro(e){let t=ne(e),n=Eo.exec(t);if(n)return[Number(n[2])];let r=gn.exec(t);return r?[...r[2].matchAll(/\d/g)].map(Number):null}function _o(e,t){let n=ot(t),r=new Map(n.map((a,i)=>[a,i])),o=a=>e.every(i=>i>=a&&i<a+n.length);if(e.every(a=>r.has(a)))return[r,[]];let s=a=>new Map(n.map((i,c)=>[c+a,c]));return o(1)?[s(1),[y("taken: counted on",{joints:n.join(", ")})]]:o(0)?[s(0),[y("taken: from zero",{joints:n.join(", ")})]]:[r,[]]}function Lo(e,t){let n=gn.exec(e);if(!n)return t[0];let r=[...n[2].matchAll(/([+-]?)\d/g)].map(([,s])=>s==="-"?-1:1),o=t.reduce((s,a,i)=>s+r[i]*a,0);return e[0]==="c"?Math.cos(o):Math.sin(o)}var mt={};x(mt,{ownValues:()=>be,valuesCall:()=>Co});var Io=/^\s*(?:values\s*=\s*)?(?:dict\s*\(([^]*)\)|\{([^]*)\})\s*$/,zo=/^\s*(["']?)(.+?)\1\s*[=:]\s*([^=:]+?)\s*$/s,Fo=/^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;function be(e){let[,t,n]=Io.exec(e)??[];return(t??n??e).split(/[,;\n]/).filter(o=>o.trim()).map(o=>{let[,,s,a]=zo.exec(o)??[],[i,c]=s?[A(s),I(a)]:["",null];if(c!==null&&Fo.test(i))return[i,c];throw new h(`your own symbols: ${B(o.trim())} is not read; expected such as h = 0.333`)})}function Co(e){let t=be(e).map(([n,r])=>`"${n}": ${D(r)}`);return t.length?[`values={${t.join(", ")}}`]:[]}var ft={};x(ft,{checkerOf:()=>ye,load:()=>oe,ready:()=>dt,register:()=>Do});var pt=new Map,xe=new Map,Po=typeof document>"u"?null:document.currentScript?.src,Do=(e,t)=>{pt.set(e,t)},ye=e=>pt.get(e),dt=e=>pt.has(e)?Promise.resolve():oe(v[e].script);function oe(e){return xe.has(e)||xe.set(e,Bo(e)),xe.get(e)}function Bo(e){return new Promise((t,n)=>{let r=()=>{xe.delete(e),n(new Error(`The script judge-${e}.js could not be loaded.`))},o=new URL(`judge-${e}.js`,Po).href;document.head.append(Object.assign(document.createElement("script"),{src:o,onload:()=>t(),onerror:r}))})}var yn=12e3,qo={table:2e3,q:500,wrench:300,values:500,answer:8e3,target:1e3},vn=2e4,Go="the arm asked about",T="own",W=["rad","deg"],ht={unit:W,first:["v","omega"],plane:["zy","yz","zx","xz"],pace:["even","rest"],lengths:["","m","cm","mm"],angles:["",...W],convention:["","standard","craig"]},Z={ask:"jacobian",arm:"",table:"",q:"",unit:"rad",frame:"0",first:"v",wrench:"",values:"",answer:"",columns:"",lengths:"",angles:"",convention:"",target:"",radius:"0.1",plane:"zy",period:"5",steps:"",pace:"even"};function gt(e){let t=Object.entries(e).filter(([n,r])=>r!==Z[n]||n==="ask"||n==="arm");return`#${new URLSearchParams(t)}`}function wt(e,t){let n=e.replace(/^#/,"");if(!/^ask=/.test(n))return{question:null,words:""};let r=i=>({question:null,words:`The link could not be read: ${i}.`});if(n.length>yn)return r(`it has ${n.length} characters; ${yn} are the most`);let o=new URLSearchParams(n),s={...Z};for(let[i,c]of o){if(!Object.hasOwn(Z,i))return r(`it has a field “${i.slice(0,40)}”`);if(c.length>(qo[i]??40))return r(`its ${i} is too long`);s[i]=c}if(!Object.hasOwn(v,s.ask))return r("it asks what is not judged here");if(s.arm!==T&&!t.includes(s.arm))return r(`there is no arm called “${s.arm}” here`);let a=Object.keys(ht).find(i=>!ht[i].includes(s[i]));return a?r(`its ${a} is none`):/^\d{1,2}$/.test(s.frame)?{question:s,words:""}:r("its frame is none")}function bt(e,t){if(e.arm!==T)return t.find(({key:s})=>s===e.arm);if(!e.table.trim())throw new h("Type the table of your arm: a row for each joint, a α d θ.");let n=new Map(v[e.ask].fields.includes("values")?be(e.values):[]),r=z(e.table).filter((s,a)=>a||!s.some(i=>/^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(i))).map((s,a)=>Wo(s.length===5?s.slice(1):s,a+1,e.unit,n)),o=Be(r);if(o)throw new h(`${o}.`);return{...qe(r,{name:"",home:[],rows:[]}),name:Go}}var Uo=["a","alpha","d","theta"],Ho=/^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;function Wo(e,t,n,r){if(e.length!==4)throw new h(`Row ${t} of the table has ${e.length} entries; expected four: a α d θ.`);let o=e.map((p,f)=>O(p||"0",`row ${t}, ${Uo[f]}`)),s=o.map(p=>[...N(p)].filter(f=>!r.has(f))),a=s.flatMap((p,f)=>p.filter(d=>f<2||!Ho.test(d)));if(a.length)throw new h(`Row ${t} of the table: no value for ${a[0]}; write numbers, and a variable such as q1.`);let[i,c,l,u]=o.map((p,f)=>{let d=n==="deg"&&f%2&&!/deg|°|pi|π/.test(e[f]);return H(p,g=>r.get(g)??0)*(d?$:1)});return{kind:s[2].length?"prismatic":"revolute",a:i,alpha:c,d:l,theta:u}}function xt(e,t){let n,r;try{n=bt(e,t);let o=Zo(e,n);if(o)return{error:o,arm:n};if(r=$n(e)?ct(e.q,n,e.unit).values:void 0,!e.answer.trim())return{error:"Type or paste your answer.",arm:n,q:r};let s=v[e.ask].longest??vn;if(e.answer.length>s)return{error:`The answer is longer than ${s} characters.`,arm:n,q:r};let a=ye(e.ask);return a?{report:a.verdict(e,n),arm:n,q:r}:{error:"The checker is being loaded.",waiting:!0,arm:n,q:r}}catch(o){if(o instanceof h)return{error:Ko(o.message),arm:n,q:r};throw o}}var $n=({ask:e})=>v[e].fields.includes("q"),Zo=(e,t)=>$n(e)&&!e.q.trim()?`Type the pose: ${b(t).length} joint values.`:null,Ko=e=>e.slice(0,1).toUpperCase()+e.slice(1);function Vo(e,t){let n=bt(e,t),[r,o]=e.arm===T?["arm",Jo(n)]:[n.python,Yo(n.python)],{call:s,imports:a=[]}=ye(e.ask),i=[...o,...a,"from helpers import checks",""];return e.arm===T&&i.push(...Xo(n),""),i.push(`mine = ${Te(e.answer)}`,`print(${s(e,r,n)})`),`${i.join(`
`)}
`}var Yo=e=>[`from helpers.robots import ${/^\w+/.exec(e)[0]}`],jn={revolute:"revolute",prismatic:"prismatic",fixed:"fixed"},Jo=e=>[`from helpers.arm import Arm, ${[...new Set(e.rows.map(({kind:t})=>jn[t]))].sort().join(", ")}`],Xo=e=>["rows = [",...e.rows.map(({kind:t,a:n,alpha:r,d:o,theta:s})=>`    ${jn[t]}(a=${n}, alpha=${r}, d=${o}, theta=${s}),`),"]",`arm = Arm("${e.name}", rows)`];var jt={};x(jt,{MARKS:()=>$t,better:()=>ls,both:()=>An,cause:()=>ts,complete:()=>is,explain:()=>os,explainAll:()=>Mn,linesOf:()=>ve,nameOf:()=>ns,several:()=>cs,textOf:()=>us,wordsOf:()=>En});var Qo=.6,es=.85,vt=.7,ts=(e,t={})=>({keys:[e],fields:[t]}),An=(e,t)=>({keys:[...e.keys,...t.keys],fields:[...e.fields,...t.fields]}),ns=({keys:e,fields:t})=>e.map((n,r)=>rs(n,t[r])).join(" + ");function rs(e,t){if("_of"in t)return t._of;let n=Object.entries(t).filter(([r])=>!r.startsWith("_"));return[e,...n.map(([,r])=>r)].join(":")}function En({keys:e,fields:t}){let[n,r]=e.map((o,s)=>y(o,t[s]));return r===void 0?n:y("and also",{first:n,second:ue(r)})}var os=(e,t,n,r,o,s=vt)=>Mn(e,t,[n],r.map((a,i)=>[[a],o[i]]),s)[0];function Mn(e,t,n,r,o=vt){let s=n.map(i=>{let c=e.filter((u,p)=>Math.abs(u-t[p])>i[p]).length,l=[Math.max(3,Qo*c),Math.max(4,es*c)];return{band:i,count:c,least:l,named:[]}}),a=0;for(let[i,c]of r){let l=i.length>1?2:i[0].keys.length;for(let{band:u,count:p,least:f,named:d}of s){let g=ss(e,c,u,p,f[l-1]);(g?p-g>=f[l-1]:p>0)&&d.push({k:a,cost:l+o*g,parts:i,A:c})}a++}return s.map(i=>as(e,i))}function ss(e,t,n,r,o){let s=0;for(let a=0;a<e.length;a++)if(!(Math.abs(e[a]-t[a])<=n[a])&&(s++,r-s<o))return s;return s}function as(e,{band:t,named:n}){if(!n.length)return null;let r=i=>Math.round(i*1e6);n.sort((i,c)=>r(i.cost)-r(c.cost)||i.k-c.k);let[{cost:o,A:s}]=n;return{causes:n.filter(i=>i.cost===o).map(({parts:i})=>i.reduce(An)),odd:e.map((i,c)=>!(Math.abs(i-s[c])<=t[c]))}}var is=e=>!!e&&!e.odd.includes(!0);function cs(e,t=3){let n=[...new Set(e.map(En))].slice(0,e[0].keys.length===1?t:1);return n.length===1?n[0]:y("or",{first:n[0],others:Ne(n.slice(1).map(ue),"or")})}function ls(e,t=vt){let n=r=>r.causes[0].keys.length+t*r.odd.filter(Boolean).length;return e.filter(Boolean).reduce((r,o)=>r&&n(r)<=n(o)?r:o,null)}var $t={[de]:"✔",[Y]:"◐",[fe]:"≈",wrong:"✘"},ve=({headline:e,findings:t,taken:n,notes:r})=>[...t.filter(({what:o,words:s})=>o!=="cause"&&!e.includes(s.slice(1))).map(({words:o})=>o),...n.map(o=>`Taken as ${o}`),...r.map(o=>`Note: ${o}`)],us=e=>[e.headline,...ve(e).map(t=>`- ${t}`)].join(`
`);var kt={};x(kt,{matrixOf:()=>Ln,namesOf:()=>Mt,showRead:()=>St,tell:()=>Nt,typeset:()=>ae});var ms="http://www.w3.org/1998/Math/MathML",[At,R,On,F]=[1,2,3,4],[ps,ds]=["⁡","⁢"],fs={alpha:"α",beta:"β",gamma:"γ",delta:"δ",theta:"θ",th:"θ",phi:"φ",psi:"ψ",omega:"ω",lambda:"λ",pi:"π",inf:"∞"},hs={asin:"arcsin",acos:"arccos",atan:"arctan",sind:"sin",cosd:"cos"},gs=/^(?:[Ff]loat|Integer|float64|float32|int64)$/,ws=/^(?:radians|deg2rad)$/,C=e=>["mo",e],_=e=>e.length===1?e[0]:["mrow",e],Sn={stretchy:"false",lspace:"0",rspace:"0"},Nn=(e,t="(",n=")")=>_([["mo",t,{form:"prefix",...Sn}],...e,["mo",n,{form:"postfix",...Sn}]]),$e=e=>["math",[_(E(e).pieces)],{displaystyle:"true"}];function se([e,t,n={}]){let r=document.createElementNS(ms,e);for(let[o,s]of Object.entries(n))r.setAttribute(o,s);return r.append(...typeof t=="string"?[t]:t.map(se)),r}var je=([e,t])=>e==="num"||e==="neg"&&t[0]==="num";function E(e){let[t,n,r]=e;if(t==="num")return bs(n);if(t==="name")return{level:F,pieces:[xs(n)]};if(t==="call")return ys(n,r);if(t==="^")return{level:On,pieces:[["msup",[_(P(n,F)),_(E(r).pieces)]]]};if(t==="/"){let o=[n,r].map(s=>_(E(s).pieces));return{level:R,pieces:[["mfrac",o]]}}return t==="*"?vs(e):js(e)}function P(e,t){let{level:n,pieces:r}=E(e);return n<t?[Nn(r)]:r}function bs(e){let[t,n]=String(Math.abs(e)).split("e"),r=[["mn",t]];if(n){let o=_([...n[0]==="-"?[C("−")]:[],["mn",n.replace(/^[+-]/,"")]]);r.push(C("⋅"),["msup",[["mn","10"],o]])}return e<0?{level:At,pieces:[C("−"),...r]}:{level:n?R:F,pieces:r}}function xs(e){let[,t,n,r]=/^([A-Za-z]+)_?(.*?)('?)$/.exec(e.replace(/[{}]/g,""));if(t==="deg"&&!n)return["mi","°"];let o=["mi",(fs[t]??t)+r.replace("'","′")],a=(n.match(/\d+|[A-Za-z_]+|[+-]/g)??[]).map(i=>[/\d/.test(i)?"mn":/\w/.test(i)?"mi":"mo",i.replace("-","−")]);return a.length?["msub",[o,_(a)]]:o}function ys(e,t){if(gs.test(e))return E(t);if(e==="sqrt")return{level:F,pieces:[["msqrt",[_(E(t).pieces)]]]};if(e==="abs")return{level:F,pieces:[Nn(E(t).pieces,"|","|")]};if(ws.test(e))return{level:R,pieces:[...P(t,F),["mi","°"]]};let n=e.endsWith("d")?[["mi","°"]]:[],r=P(t,F),s=r[0][0]==="mrow"?r:[["mspace","",{width:"0.17em"}],...r];return{level:On,pieces:[["mi",hs[e]??e],C(ps),...s,...n]}}function vs(e){let t=Tn(e,["*"]).map(([,o])=>o),n=t[0][0]==="neg"||t[0][0]==="num"&&t[0][1]<0,r=n?E(t[0]).pieces:P(t[0],R);return t.slice(1).forEach((o,s)=>{o[0]==="name"&&o[1]==="deg"||r.push(C($s(t[s],o)?"⋅":ds)),r.push(...P(o,R))}),{level:n?At:R,pieces:r}}var $s=(e,t)=>kn(t)||e[0]==="call"&&t[0]!=="call"&&e[1]!=="sqrt"&&e[1]!=="abs",kn=([e,t])=>e==="num"||["^","*"].includes(e)&&kn(t);function js(e){let t=[];for(let[n,r]of Tn(e,["+","-"]))n&&t.push(C(n==="-"?"−":"+")),n?t.push(...P(r,R)):r[0]==="neg"?t.push(C("−"),...P(r[1],R)):t.push(...E(r).pieces);return{level:At,pieces:t}}function Tn(e,t){let n=[];for(;t.includes(e[0]);)n.push([e[0],e[2]]),e=e[1];return[["",e],...n.reverse()]}var As={v:["vx","vy","vz","ωx","ωy","ωz"],omega:["ωx","ωy","ωz","vx","vy","vz"]},Es=["a (m)","α","d (m)","θ"],Et=40,_n=8e3;function Mt({ask:e,first:t},n,[r,o]){let s=b(n).map(c=>c+1),a=c=>s.length===o?`joint ${s[c]}`:String(c+1),i={torques:r===1?["τ"]:[],jacobian:r===6?As[t]:[]}[e]??[];return{columns:Array.from({length:o},(c,l)=>a(l)),rows:Array.from({length:r},(c,l)=>i[l]??`row ${l+1}`)}}function Ln(e,{report:t,arm:n}){let r=t?.typed;if(!r||r.shape.length!==2)return null;let o=e.ask==="torques"&&r.shape[1]===1,[s,a]=o?[1,r.values.length]:r.shape,i=t.wrong?.length===r.values.length?t.wrong:[];return{...Mt(e,n,[s,a]),typed:r,wrong:i,shape:[s,a]}}function St(e,t,n){let r=Ms(t,n);if(e.hidden=!r,!r)return;let{columns:o,rows:s,cell:a,unread:i=0}=r,c=m("tr",{},m("td"),o.map(g=>m("th",{scope:"col"},g))),l=s.slice(0,Et).map((g,K)=>m("tr",{},m("th",{scope:"row"},g),o.map((ie,ce)=>a(K,ce)))),u=s.length>Et?`, its first ${Et} of ${s.length} rows`:"",p=i?`; ${i===1?"1 entry":`${i} entries`} could not be`:"",f=m("caption",{},`How your answer is read${u}${p}`),d=t.ask==="table"?"table.read":"table.read.matrix";e.replaceChildren(m(d,{},f,m("thead",{},c),m("tbody",{},l)))}function Ms(e,t){let{table:n}=t.report??{};return n?Ss(n):Os(e,Ln(e,t))??Ns(e,t)}var Ss=({cells:e,trees:t,wrong:n})=>({columns:Es,rows:e.map((r,o)=>String(o+1)),cell(r,o){let[s,a]=[t[r][o],e[r][o]],i=/^-?q_\d+$/.test(a);return Ae(s&&!je(s)?In(s,i?"":a):Ot(a),n[r][o])}});function Os({answer:e},t){if(!t)return null;let{typed:n,wrong:r,shape:o}=t,s=e.length>_n?[]:n.trees??[];return{...t,cell(a,i){let c=a*o[1]+i,l=s[c];return!l||je(l)&&n.units[c]?Ae(Ot(Rn(n,c)),r[c]):Ae(In(l,je(l)?"":Rn(n,c)),r[c])}}}function Ns(e,{error:t,waiting:n,arm:r,q:o}){let{ask:s,answer:a}=e;if(!t||n||!r||!a.trim()||s==="trace"||a.length>_n)return null;let i=ks(s,a).map(l=>l.map(u=>Ts(s,u,r,o))),c=Math.max(0,...i.map(l=>l.length));return{...Mt(e,r,[i.length,c]),unread:i.flat().filter(({tree:l})=>!l).length,cell(l,u){let{tree:p,text:f}=i[l][u]??{};return f===void 0?m("td"):p?m("td",{},se($e(p))):Ae(f,!0,"not read: ")}}}function ks(e,t){try{let n=te(z(t));return e==="table"&&!n[0].some(r=>/\d/.test(r))?n.slice(1):n}catch(n){if(n instanceof h)return[];throw n}}function Ts(e,t,n,r){let o=e==="branches"||e==="pose";try{let s=O(A(o?t.replace(/^.*[=:]/,""):t).replace(/\*+$/,"")||"0");return e==="jacobian"&&r&&at(n,r).known(N(s)),{tree:s,text:t}}catch(s){if(s instanceof h)return{tree:null,text:t};throw s}}function Rn({values:e,units:t},n){let r=Math.min(6,t[n]?Math.max(0,Math.round(-Math.log10(t[n]))):4);return(Number(e[n].toFixed(r))+0).toFixed(r)}var Ot=e=>ae(e.replaceAll("-","−")),In=(e,t)=>t?[se($e(e)),m("span.value",{},"= ",Ot(t))]:[se($e(e))],Ae=(e,t,n="wrong: ")=>t?m("td.off",{},m("span.unseen",{},n),e):m("td",{},e);function Nt(e,{report:t,error:n}){if(e.className=`verdict ${t?.grade??""}`,!t)return e.replaceChildren(m("p",{},ae(n)));let r=ve(t).filter(a=>!t.headline.endsWith(a.slice(1))),o=r.length?[m("ul",{},r.map(a=>m("li",{},ae(a))))]:[],s=m("span",{"aria-hidden":"true"},`${$t[t.grade]} `);return e.replaceChildren(m("p.headline",{},s,ae(t.headline)),...o)}var Rs=/(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g,_s={theta:"θ",alpha:"α"};function ae(e){let t=[],n=0;for(let r of e.matchAll(Rs)){let[o,s,a,i]=r;t.push(e.slice(n,r.index),m("i",{},_s[s]??s)),t.push(m("sub",{},(a??i).replace("-","−"))),n=r.index+o.length}return[...t,e.slice(n)]}var zn={"arm.js":Ge,"dom.js":Ue,"kinematics.js":Fe,"judge/ask.js":yt,"judge/digits.js":Ye,"judge/door.js":ut,"judge/formula.js":Qe,"judge/grid.js":rt,"judge/judges.js":_e,"judge/own_values.js":mt,"judge/ranking.js":jt,"judge/registry.js":ft,"judge/say.js":Re,"judge/shown.js":kt};var Fn=e=>[["","as it looks"],...e.map(t=>[t,t])],Cn={spellcheck:"false",autocomplete:"off",autocapitalize:"off"},Dn={table:{label:"Table",rows:6,whole:!0,hint:"A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen."},q:{label:"Pose q",hint:"",whole:!0},unit:{label:"Angles in",choices:W.map(e=>[e,e])},frame:{label:"Rows in the axes of",choices:[]},first:{label:"Order of the rows",choices:[["v","v, then ω"],["omega","ω, then v"]]},wrench:{label:"Wrench on the tool, by the world",whole:!0,hint:"Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down."},values:{label:"Your own symbols",whole:!0,hint:"Numbers for those that the arm does not have, in m and rad, as in “h = 0.333, l = 0.1”."},columns:{label:"Order of the columns",hint:"As in “theta d a alpha”; guessed where it is empty."},lengths:{label:"Lengths in",choices:Fn(["m","cm","mm"])},angles:{label:"Angles in",choices:Fn(W)},convention:{label:"Convention",choices:[["","as it looks"],["standard","standard"],["craig","modified (Craig)"]]},target:{label:"Where the tip should be",rows:4,whole:!0,hint:"A point x, y, z in m, or a pose: its three or four rows, in base axes."},radius:{label:"Radius of the circle below the tip, in m"},plane:{label:"Its plane",choices:[["zy","towards +y first"],["yz","towards −y"],["zx","towards +x"],["xz","towards −x"]]},period:{label:"Time for it, in s"},steps:{label:"Steps",hint:"Empty: as many as your answer has."},pace:{label:"Pace",choices:[["even","even"],["rest","from rest to rest"]]},answer:{label:"Your answer",hint:"",rows:8,whole:!0}},Ls={jacobian:"Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",table:"A row for each link, with heads or without: lists, Link(…) lines, MATLAB, LaTeX, Markdown, CSV or cells.",branches:"A row for each answer, angles in the joints' order; names such as theta1 = may stand before them.",pose:"One value for each joint, in the joints' order; names such as theta1 = may stand before them.",trace:"A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",torques:"One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet."},Is="Pose q at which the circle begins",zs=["frame","first","values","columns","lengths","angles","convention"],Bn=([e,t])=>m("option",{value:e},t);function Fs({choices:e,rows:t,hint:n},r,o){let s=n===void 0?{}:{"aria-describedby":[`${r}-hint`,...o].join(" ")},a={id:r,...s};return e?m("select",a,e.map(Bn)):t?m("textarea",{rows:t,wrap:"off",...Cn,...a}):m("input",{...Cn,...a})}function Cs(e,t,n){let r=m("label",{for:t},e.label),o=e.hint===void 0?[]:[m("p.about",{id:`${t}-hint`},e.hint)];return m(e.whole?"div.field.whole":"div.field",{},r,n,...o)}function qn(e,t,n){let r={ask:{label:"Question",choices:Object.entries(v).map(([l,{title:u}])=>[l,u])},arm:{label:"Arm",choices:[...t.map(({key:l,title:u})=>[l,u]),...t.length>1&&n?[]:[[T,"My own table"]]]},...Dn},o=l=>`${e}-${l}`,s=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Fs(u,o(l),l==="answer"?[o("private")]:[])])),a=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Cs(u,o(l),s[l])]));for(let l of n?Ps(n,t):[])a[l]?.classList.add("given");let i=n?Ds(n,t):"";return n&&(s.answer.rows=6),{form:m("form",{"aria-label":`Check an answer${i&&`: ${i}`}`},i?m("p.asked",{},"Judged here: ",i):[],Object.values(a)),fields:s,boxes:a}}var Ps=(e,t)=>[...Object.keys(e),...zs,...t.length<2?["arm"]:[],..."q"in e?["unit"]:[]];function Ds({ask:e,q:t,wrench:n},r){let o=r.length===1?`, ${r[0].title}`:"";return[`${v[e].title}${o}`,t&&`q = (${t})`,n&&`wrench (${n})`].filter(Boolean).join(", ")}function Gn({fields:e,boxes:t},n,r){let o=new Set(["ask","arm","answer",...v[n.ask].fields]);n.arm===T&&o.add("table");for(let[i,c]of Object.entries(t))c.hidden=!o.has(i);Pn(t.answer,Ls[n.ask]??"");let s=r.find(({key:i})=>i===n.arm);G(t.q.querySelector("label"),n.ask==="trace"?Is:Dn.q.label),Pn(t.q,s?Bs(s):"One value for each joint, in the table's order.");let a=s?s.rows.length:16;if(e.frame.options.length!==a+1){let i=l=>l?`frame ${l}`:"the base",c=Array.from({length:a+1},(l,u)=>Bn([String(u),i(u)]));e.frame.replaceChildren(...c),e.frame.value=n.frame}}var Pn=(e,t)=>G(e.querySelector(".about"),t),Bs=e=>`${b(e).map(n=>`q_${n+1}`).join(", ")}${re(e).includes(!1)?"; m where a joint slides":""}`;var qs=5e4,Un=120,Gs=350,Hn="Nothing that you type leaves this page: a script in it judges, without a network too.",Us="It names the mistake and does not print the solution.",Hs=0;function Wn(e){let{arms:t,examples:n=[],given:r}=JSON.parse(e.querySelector("script").textContent),o=`judge-${++Hs}`,s=qn(o,t,r),{form:a,fields:i}=s,c=Ws(o,r),l=[],u={...Z,arm:t[0]?.key,...r??n[0]},p,f=0,d=!1,g=w=>u[w].length>qs?"":u[w],K=()=>{for(let[w,M]of Object.entries(i))M.value!==g(w)&&(M.value=g(w));Gn(s,u,t)},ie=w=>G(c.said,w),ce=()=>Nt(c.verdict,p),le=()=>{Tt(),ce()},Zn=()=>{Tt(),f=setTimeout(ce,Gs-Un)},Tt=()=>{clearTimeout(f),d=!1,p=xt(u,t),p.waiting&&dt(u.ask).then(le,({message:w})=>ie(w)),i.answer.setAttribute("aria-invalid",String(p.report?.grade==="wrong")),St(c.taken,u,p);for(let w of l)w(u,p)},Ee=w=>{u={...u,...w},K(),le()};a.addEventListener("input",({target:w,inputType:M})=>{let L=Object.keys(i).find(Kn=>i[Kn]===w);L&&(u={...u,[L]:w.value},L==="arm"&&(u.frame="0"),(L==="arm"||L==="ask")&&(u.q=Zs(u,n)?.q??u.q),K(),d=!0,clearTimeout(f),M==="insertFromPaste"||M==="insertFromDrop"?le():f=setTimeout(Zn,Un))}),a.addEventListener("submit",w=>w.preventDefault());let Rt=()=>{let{question:w,words:M}=wt(location.hash,t.map(({key:L})=>L));(w||M)&&e.scrollIntoView({block:"start"}),ie(M),w&&Ee(w)};return e.replaceChildren(a,...Object.values(c)),Ee({}),r||(addEventListener("hashchange",Rt),Rt()),{stub:e,arms:t,examples:n,given:r,...s,parts:c,...{question:()=>u,verdict:()=>(d&&le(),p)},put:Ee,follow:w=>{l.push(w),w(u,p)},say:ie,links:{fragment:()=>gt(u),open:()=>!0}}}function Ws(e,t){return{verdict:m("div.verdict",{role:"status","aria-live":"polite","aria-atomic":"true"}),taken:m("div.scroll",{role:"region",tabindex:"0","aria-label":"How your answer is read"}),tools:m("div.tools"),said:m("p.about",{role:"status"}),private:m("p.private",{id:`${e}-private`},t?Hn:`${Hn} ${Us}`)}}var Zs=(e,t)=>t.find(n=>n.arm===e.arm&&n.ask===e.ask);document.head.append(Object.assign(document.createElement("style"),{textContent:Lt}));for(let e of document.querySelectorAll(".arm-judge"))V.push(Wn(e));if(V.some(({given:e})=>!e))oe("page");else for(let{stub:e}of V)e.addEventListener("focusin",()=>oe("page"),{once:!0});Oe({"and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","unknown symbol":"{arm}: no value for {name}; known are {known}. Give values={'{name}': ...} if it is a length of yours","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what}: NaN or infinity stands among the numbers; expected {wanted}",ragged:"{what} has rows of {widths} entries; expected rows of one length",row:"row {row}","taken: counted on":"symbols numbered on past what does not move: 1, 2, 3 ... are joints {joints}","taken: from zero":"symbols numbered from 0: 0, 1, 2 ... are joints {joints}"});return Qn(Ks);})();
