var ArmJudge=(()=>{var Ne=Object.defineProperty;var rr=Object.getOwnPropertyDescriptor;var or=Object.getOwnPropertyNames;var sr=Object.prototype.hasOwnProperty;var x=(e,t)=>{for(var n in t)Ne(e,n,{get:t[n],enumerable:!0})},ar=(e,t,n,r)=>{if(t&&typeof t=="object"||typeof t=="function")for(let o of or(t))!sr.call(e,o)&&o!==n&&Ne(e,o,{get:()=>t[o],enumerable:!(r=rr(t,o))||r.enumerable});return e};var ir=e=>ar(Ne({},"__esModule",{value:!0}),e);var ua={};x(ua,{kit:()=>Gn});var ze={};x(ze,{ArmError:()=>f,learn:()=>Re,listed:()=>ke,lower:()=>ce,quoted:()=>Le,say:()=>y,shown:()=>M,size:()=>lr,spelled:()=>D,tuple:()=>_e});var Te={},Re=e=>{Te={...Te,...e}};function y(e,t={}){let n=Te[e];for(let[r,o]of Object.entries(t))n=n.replaceAll(`{${r}}`,()=>String(o));return n}var f=class extends Error{},ke=(e,t="and")=>e.length===1?e[0]:`${e.slice(0,-1).join(", ")} ${t} ${e.at(-1)}`,ce=e=>/^.(\p{Lu}|_)/su.test(e)?e:e.slice(0,1).toLowerCase()+e.slice(1),cr=9e6;function lr(e,t=3){if(!Number.isFinite(e))return Number.isNaN(e)?"nan":e>0?"inf":"-inf";if(e===0)return"0";let[n,r]=ur(e,t).split("e"),o=Number(r),s=a=>a.includes(".")?a.replace(/\.?0+$/,""):a;return o>=t&&Math.abs(e)<cr?(+`${n}e${r}`).toFixed(0):o<-4||o>=t?`${s(n)}e${It(o)}`:s((+`${n}e${r}`).toFixed(Math.max(0,t-1-o)))}function ur(e,t){let n=e.toExponential(t-1),[r,o]=e.toExponential(t+25).split("e"),s=t===1?r.indexOf("."):r.indexOf(".")+t,a=r.slice(s).replace(".",""),i=r.slice(0,s);return/^50*$/.test(a)&&"02468".includes(i.at(-1))?`${i}e${o}`:n}var It=e=>`${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;function D(e){let[t,n]=e.toExponential().split("e"),r=Number(n);if(e!==0&&(r<-4||r>=16))return`${t}e${It(r)}`;let o=BigInt(Math.trunc(e)).toString();return r>20?o:String(e).includes("e")?e.toFixed(20).replace(/0+$/,""):String(e)}function M(e){let t=e.includes("'")&&!e.includes('"')?'"':"'",n={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},r=[...e].map(s=>n[s]??mr(s)).join(""),o=[...`${t}${r}${t}`];return o.length<=80?o.join(""):`${o.slice(0,77).join("")}...`}function mr(e){let t=e.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(e)||e===" "?e:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var _e=e=>e.length===1?`(${e[0]},)`:`(${e.join(", ")})`;function Le(e){return e.includes(`
`)&&!/"""|["\\]$/.test(e)&&!/[\r\0]/.test(e)?`r"""${e}"""`:JSON.stringify(e)}var Ft=`.arm-judge {
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
.arm-judge .unbroken {
  white-space: nowrap;
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
/* The grid shows the same, but for formulas. */
.arm-judge.in-grid .taken:not(:has(math)) {
  display: none;
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
`;var Ie={};x(Ie,{judges:()=>V});var V=[];var He={};x(He,{KINDS:()=>Dt,LARGEST:()=>Ge,LONGEST:()=>qe,MOST_ROWS:()=>Be,TYPED:()=>Bt,carriedOver:()=>Ut,fits:()=>Zt,homeOf:()=>Ar,limited:()=>Mr,outside:()=>Sr,range:()=>Er,reachOf:()=>Or,rowsFault:()=>Ue,sameRow:()=>Gt,typedArm:()=>Ze});var De={};x(De,{GRAVITY:()=>dr,cosSin:()=>Fe,cross:()=>Pe,dot:()=>fr,gravityTorque:()=>xr,jacobianColumns:()=>br,joints:()=>b,liftedEnergy:()=>yr,linkFrames:()=>gr,matrix:()=>wr,minus:()=>Ce,norm:()=>hr,plus:()=>le,scaled:()=>Ct,wrenchTorque:()=>vr});var dr=9.81,fr=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],Ct=(e,t)=>[e*t[0],e*t[1],e*t[2]],le=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],Ce=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],Pe=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],hr=e=>Math.sqrt(e.reduce((t,n)=>t+n*n,0)),B=(e,t,n,r)=>[e*t[0]+n*r[0],e*t[1]+n*r[1],e*t[2]+n*r[2]];function Fe(e){let t=e/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(e),Math.sin(e)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var b=e=>e.rows.flatMap((t,n)=>t.kind==="fixed"?[]:[n]);function gr(e,t){let[n,r,o,s]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:n,y:r,z:o,o:s}],i=0;for(let c of e.rows){let u=c.kind==="fixed"?0:t[i++],[l,d]=Fe(c.kind==="revolute"?c.theta+u:c.theta),[h,p]=Fe(c.alpha),w=c.kind==="prismatic"?c.d+u:c.d;[n,r]=[B(l,n,d,r),B(l,r,-d,n)],s=le(B(w,o,c.a,n),s),[r,o]=[B(h,r,p,o),B(h,o,-p,r)],a.push({x:n,y:r,z:o,o:s})}return a}var wr=({x:e,y:t,z:n,o:r})=>[0,1,2].map(o=>[e[o],t[o],n[o],r[o]]).concat([[0,0,0,1]]);function br(e,t,n=t.at(-1).o){return b(e).map(r=>{let{z:o,o:s}=t[r];return e.rows[r].kind==="revolute"?[...Pe(o,Ce(n,s)),...o]:[...o,0,0,0]})}function xr(e,t,n=9.81){let r=Pt(e,t);return b(e).map(o=>{let{z:s,o:a}=t[o],i=c=>e.rows[o].kind==="revolute"?Pe(s,Ce(c,a))[2]:s[2];return r.reduce((c,{mass:u,centre:l,row:d})=>c+(d<o?0:u*n*i(l)),0)})}var yr=(e,t,n=9.81)=>Pt(e,t).reduce((r,{mass:o,centre:s})=>r+o*n*s[2],0),Pt=(e,t)=>e.rows.flatMap((n,r)=>n.body?[$r(n.body,t[r+1],r)]:[]);function $r([e,...t],{x:n,y:r,z:o,o:s},a){return{mass:e,row:a,centre:le(s,le(B(t[0],n,t[1],r),Ct(t[2],o)))}}var vr=(e,t)=>e.map(n=>n.reduce((r,o,s)=>r+o*t[s],0));var Dt=["revolute","prismatic","fixed"],Be=16,qe=100,Ge=1e3,Bt="Your arm",qt=[["a",qe],["alpha",Ge],["d",qe],["theta",Ge]];function Ue(e){if(!Array.isArray(e)||!e.length)return"the table has no rows";if(e.length>Be)return`the table has ${e.length} rows; ${Be} are the most`;for(let[t,n]of e.entries()){if(!Dt.includes(n?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[r,o]of qt){if(!Number.isFinite(n[r]))return`row ${t+1} has no number for ${r}`;if(Math.abs(n[r])>o)return`row ${t+1} has ${n[r]} for ${r}; ${o} is the most`}}return null}var jr=({kind:e,a:t,alpha:n,d:r,theta:o})=>({kind:e,a:t,alpha:n,d:r,theta:o,lower:null,upper:null,speed:null,effort:null}),Gt=(e,t)=>e.kind===t.kind&&qt.every(([n])=>Math.abs(e[n]-t[n])<1e-12);function Ze(e,t){if(e.length===t.rows.length&&e.every((r,o)=>Gt(r,t.rows[o])))return t;let n={name:Bt,home:[],rows:e.map(jr)};return{...n,home:Ut(t,t.home,n,r=>r)}}function Ut(e,t,n,r){let o=new Map(b(e).map((s,a)=>[s,[e.rows[s].kind,t[a]??0]]));return b(n).map(s=>{let[a,i]=o.get(r(s))??[];return a===n.rows[s].kind?i:0})}var Ar=e=>Zt(e,e.home)?[...e.home]:b(e).map(()=>0),Zt=(e,t)=>Array.isArray(t)&&t.length===b(e).length&&t.every(Number.isFinite);function Er(e){let t=e.kind==="revolute"?Math.PI:1;return[e.lower??-t,e.upper??t]}var Sr=(e,t)=>t<(e.lower??-1/0)-1e-9||t>(e.upper??1/0)+1e-9,Mr=e=>b(e).some(t=>e.rows[t].lower!==null||e.rows[t].upper!==null),Or=e=>e.rows.reduce((t,n)=>t+Math.abs(n.a)+Math.abs(n.d)+(n.kind==="prismatic"?Math.abs(n.upper??.3):0),0)||.3;var We={};x(We,{attribute:()=>Tr,calm:()=>_r,h:()=>m,indexed:()=>kr,svg:()=>Nr,whereNew:()=>Rr,write:()=>q});function m(e,t={},...n){let[r,...o]=e.split("."),s=document.createElement(r);o.length&&(s.className=o.join(" "));for(let[a,i]of Object.entries(t))a.startsWith("on")?s.addEventListener(a.slice(2),i):i!==void 0&&i!==!1&&s.setAttribute(a,i===!0?"":i);return s.append(...n.flat()),s}function Nr(e,t={},...n){let r=document.createElementNS("http://www.w3.org/2000/svg",e);for(let[o,s]of Object.entries(t))r.setAttribute(o,s);return r.append(...n),r}function q(e,t){e.textContent!==t&&(e.textContent=t)}function Tr(e,t,n){e.getAttribute(t)!==n&&e.setAttribute(t,n)}function Rr(e,t){let n=[];return r=>{let o=e(r);n.length&&o.every((s,a)=>s===n[a])||(n=o,t(r))}}var kr=(e,t)=>[m("i",{},e),m("sub",{},String(t))],_r=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var jt={};x(jt,{ASKED:()=>$,CHOICES:()=>bt,EMPTY:()=>W,LONGEST_ANSWER:()=>En,OWN:()=>T,UNITS:()=>H,armOf:()=>$t,asPython:()=>ls,fromFragment:()=>yt,judge:()=>vt,toFragment:()=>xt});var v=Math.PI/180,Ke=180/Math.PI;var $={jacobian:{title:"Jacobian at a pose",fields:["q","unit","frame","first","values"],script:"jacobian"},torques:{title:"Joint torques at a pose",fields:["q","unit","wrench"],script:"jacobian"},table:{title:"Denavit-Hartenberg table",fields:["columns","lengths","angles","convention","values"],script:"table"},branches:{title:"All joint angles for a target",fields:["target","unit"],script:"motion"},pose:{title:"Joint angles for one pose",fields:["target","unit"],script:"motion"},trace:{title:"Joints along a circle",fields:["q","unit","radius","plane","period","steps","pace"],script:"motion",longest:5e6}};var dt={};x(dt,{eachJoint:()=>ut,inRadians:()=>pt,lookup:()=>lt,numbered:()=>it,numbers:()=>$n,pose:()=>mt,poseFault:()=>jn,rowsInRadians:()=>Uo,turning:()=>ne,variables:()=>ct});var Qe={};x(Qe,{HALF:()=>Kt,HAND:()=>Vt,RIGHT:()=>me,ROUNDED:()=>pe,SLOPPY:()=>Yt,SO_FAR:()=>Y,TELLING:()=>Jt,WRONG:()=>Ye,bands:()=>Dr,beyond:()=>qr,decimalsOf:()=>Cr,farthest:()=>Xe,generous:()=>Xt,graded:()=>Br,margins:()=>Pr,units:()=>J});var[me,Y,pe,Ye]=["right","so far","rounded","wrong"],Kt=.51,Vt=3.01,Lr=1e-6,Yt=.001,Jt=.0021,zr=13,Ht=-12,Ir=/^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/,Wt=e=>+`1e${e}`;function Fr(e){let t=Ir.exec(e.trim());if(!t||!(t[1]||t[2]))return null;let n=(t[1]+t[2]).replace(/^0+/,"").length,r=t[2].length-Number(t[3]??0);return{decimals:r,digits:n,first:n-1-r}}function J(e){let t=e.map(Fr),n=t.filter(i=>i&&i.digits&&i.first>Ht),r=i=>n.reduce((c,u)=>Math.max(c,u[i]),n.length?-1/0:0),[o,s]=[r("decimals"),r("digits")];if(s>=zr||t.includes(null)&&o<=0)return e.map(()=>0);let a=n.every(i=>i.decimals<=s-1-i.first)&&n.some(i=>i.digits===s&&i.decimals<o);return t.map(i=>i?!a||!i.digits||i.first<=Ht?Wt(-o):Wt(Math.max(-o,i.first-s+1)):0)}function Cr(e){let t=e.filter(n=>n>0);return t.length?Math.max(0,Math.round(-Math.log10(Math.min(...t)))):null}function Pr(e,t,n=null,r=null){let o=t.map(u=>Lr*u),s=e.map(()=>0);if(r!==null){let u=o.map(l=>Math.max(r,l*.001));return{allowed:u,band:u,loose:u,units:s,slop:s}}let a=e.map((u,l)=>Math.max(Kt*u,o[l])),i=e.map((u,l)=>Math.max(Vt*u,o[l])),c=i.map((u,l)=>Math.max(u,Yt*t[l]));return{allowed:a,band:i,loose:c,units:e,slop:n??s}}var Je=(e,t,n)=>e.map((r,o)=>r+n*t[o]),Xe=({loose:e,band:t,slop:n})=>Je(t,n,2).map((r,o)=>Math.max(r,e[o])),Xt=({allowed:e,slop:t})=>Je(e,t,1);function Dr(e){let t=e.slop.some(Boolean)?[Je(e.band,e.slop,2)]:[];return[e.band,...t,Xe(e),e.allowed]}var Ve=(e,t,n)=>e.every((r,o)=>Math.abs(r-t[o])<=n[o]),ue=(e,t)=>e.reduce((n,r,o)=>Math.max(n,Math.abs(r-t[o])),0);function Br(e,t,n,r){let o=r.filter(a=>ue(a,t)>Jt);for(let a of[n.allowed,Xt(n)]){let i=o.some(c=>Ve(e,c,a));if(Ve(e,t,a)){let c=Math.max(0,...n.units),u=o.reduce((l,d)=>Math.min(l,ue(d,t)),1/0);return i||c>u/2.1?Y:me}if(i)return Ye}if(!Ve(e,t,Xe(n)))return Ye;let s=ue(e,t);return o.some(a=>ue(e,a)<=s)?Y:pe}function qr(e,t,{band:n,allowed:r}){let o=a=>e.map((i,c)=>Math.abs(i-t[c])>a[c]),s=o(n);return s.includes(!0)?s:o(r)}var nt={};x(nt,{isNumber:()=>G,number:()=>z,parse:()=>N,plain:()=>A,symbols:()=>L,value:()=>U});var Qt=2e4,nn=60,rn={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:e=>e*v,deg2rad:e=>e*v,degrees:e=>e*Ke,rad2deg:e=>e*Ke,sind:e=>Math.sin(e*v),cosd:e=>Math.cos(e*v),float:e=>e,Float:e=>e,Integer:e=>e,float64:e=>e,float32:e=>e,int64:e=>e},en={"+":(e,t)=>e+t,"-":(e,t)=>e-t,"*":(e,t)=>e*t,"/":(e,t)=>t===0?NaN:e/t,"^":Ur},on={pi:Math.PI,deg:v,rad:1},Gr=e=>Object.hasOwn(rn,e),sn=e=>Object.hasOwn(on,e);function Ur(e,t){let n=e**t;return Number.isFinite(n)||!Number.isFinite(e)?n:NaN}var j=(e,t)=>[...e].map(n=>[n,t]),Zr="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),Hr=new Map([...j("−–—‐‑‒﹣－","-"),...j("×⋅·∙∗","*"),...j("÷∕⁄","/"),...j("       　"," "),...j("​⁡⁢\uFEFF",""),...j("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((e,t)=>j(e,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((e,t)=>j(e,` ${Zr[t]}`)),...j("π𝜋"," pi "),...j("°º"," deg"),["$"," "],["²","^2"],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),Wr=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)(?![A-Za-z])/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text|mathit|mathbf|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)(?![A-Za-z])/g," deg"],[/\\(?:cdot|times|ast)(?![A-Za-z])/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/\\d?t?frac\s*(\d)\s*(\d)/g,"(($1)/($2))"]],Kr=/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,Vr=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,Yr=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,et=new RegExp(String.raw`\s*(?:(${Vr})|(${Yr})|(\*\*|[-+*/^()]))`,"y"),Jr=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,Xr=/[cs]_?(?:\d|\{[\d+-]+\})+/g,Qr=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,G=e=>Qr.test(e);function A(e){if(G(e))return e;e=[...e].map(t=>Hr.get(t)??t).join("");for(let[t,n]of Wr)e=e.replace(t,n);for(let t="";t!==e;)[t,e]=[e,e.replace(Kr,"(($1)/($2))")];return e=e.replace(/\\([A-Za-z]+)/g," $1 "),e=e.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),e=e.replace(/(?<=\w)\s*\(t\)/g,""),e=e.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),e=e.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),e=e.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),e.replace(/[ \t]+/g," ").trim()}function N(e,t="the formula"){if(e.length>Qt)throw new f(`${t} has ${e.length} characters; expected at most ${Qt}`);let n=to(A(e));if(!n)throw new f(`${t} is ${M(e)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let r=eo(n);if(r?.[1]!==n.length)throw new f(`${t} is ${M(e)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return r[0]}var O=class extends Error{};function eo(e){try{return an(e,0,0)}catch(t){if(t instanceof O)return null;throw t}}function to(e){let t=[];for(let n=0;n<e.length;n=et.lastIndex){et.lastIndex=n;let r=et.exec(e);if(!r)return null;let[,o,s,a]=r;if(o!==void 0)t.push(["num",o]);else if(a!==void 0)t.push(["sign",a==="**"?"^":a]);else for(let i of Jr.test(s)?s.match(Xr):[s])t.push(["name",i])}return t}function de(e,t){if(t>=e.length)throw new O;return e[t]}function an(e,t,n){let[r,o]=tn(e,t,n);for(;o<e.length&&["+","-"].includes(e[o][1]);){let[s,a]=tn(e,o+1,n);[r,o]=[[e[o][1],r,s],a]}return[r,o]}function tn(e,t,n){let[r,o]=X(e,t,n);for(;o<e.length;){let[s,a]=e[o];if(a==="*"||a==="/"){let[i,c]=X(e,o+1,n);[r,o]=[[a,r,i],c]}else if(a==="("||s!=="sign"){let[i,c]=cn(e,o,n);[r,o]=[["*",r,i],c]}else break}return[r,o]}function X(e,t,n){if(n>nn)throw new O;let r=de(e,t)[1];if(r==="-"){let[o,s]=X(e,t+1,n+1);return[["neg",o],s]}return r==="+"?X(e,t+1,n+1):cn(e,t,n)}function cn(e,t,n){let[r,o]=tt(e,t,n);if(o>=e.length||e[o][1]!=="^")return[r,o];let[s,a]=X(e,o+1,n+1);return[["^",r,s],a]}function tt(e,t,n){let[r,o]=de(e,t);if(r==="num")return[["num",Number(o)],t+1];if(r==="name"&&Gr(o)&&t+1<e.length){let[i,c]=no(e,t+1,n+1);return[["call",o,i],c]}if(r==="name")return[["name",o],t+1];if(o!=="(")throw new O;let[s,a]=an(e,t+1,n+1);if(de(e,a)[1]!==")")throw new O;return[s,a+1]}function no(e,t,n){if(n>nn)throw new O;if(de(e,t)[1]!=="-")return tt(e,t,n);let[r,o]=tt(e,t+1,n);return[["neg",r],o]}function L(e,t=new Set){for(let n=[e];n.length;){let[r,...o]=n.pop();r==="name"&&!sn(o[0])&&t.add(o[0]),n.push(...o.filter(Array.isArray).reverse())}return t}function U(e,t){let n=fe(e,t);if(!Number.isFinite(n))throw new f("a formula divides by zero or is too large; expected a finite value");return n}function fe(e,t){let n=[];for(;Object.hasOwn(en,e[0]);e=e[1])n.push(e);let r=ro(e,t);return n.reduceRight((o,[s,,a])=>en[s](o,fe(a,t)),r)}function ro([e,t,n],r){if(e==="num")return t;if(e==="neg")return-fe(t,r);if(e==="call")return rn[t](fe(n,r));let o=sn(t)?on[t]:r(t);if(o===void 0)throw new f(`no value for ${t}`);return o}function z(e){try{return U(N(e),()=>{})}catch(t){if(t instanceof f)return null;throw t}}var at={};x(at,{cells:()=>I,withoutHeader:()=>ee});var oo=/(?<![^\n])[ \t]*```[^\n\r]*/g,un=String.raw`(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*`,so=new RegExp(un+String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,"g"),ao=new RegExp(un,"g"),io=/((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*[#%][^\n\r]*/g,co=/^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[[({])/,lo=/^[ \t\r\n]*=[ \t]*(?=[[({])/,uo=String.raw`\{(?:[A-Za-z]*matrix\*?|array|tabular)\}`,[mo,po]=["begin","end"].map(e=>new RegExp(String.raw`\\${e}${uo}`,"g")),fo=new RegExp(String.raw`\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}`+String.raw`|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed|left[ \t]*[\[(|.]|\[|\()`+String.raw`|[$&{ \t\r\n]`,"g"),ho=/\\end\{[a-z]+\*?\}|\\label\{[^{}]*\}|\\(?:right[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]/g,ln=String.raw`(?:(?!\\[dt]?frac[0-9])[^-=0-9][^=]*=)+`,[go,wo]=[new RegExp(ln,"g"),new RegExp(`^${ln}$`)],bo=new RegExp(String.raw`^(?:\\(?:[dt]?frac|cdot|times|ast|sqrt|pi)|[-+*/^0-9.,(){}]`+String.raw`|(?<![A-Za-z])[A-Za-z](?:_[0-9A-Za-z])?(?![A-Za-z]))+$`),xo=[[/\\[hv]?phantom\{[^{}]*\}/g," "],[/\\num\{([^{}]*)\}/g,"$1"],[/\{([-+])\}/g,"$1"],[/(?<=[0-9])\{,\}(?=[0-9])/g,"."]],mn=e=>e.replaceAll("\uFEFF","").replace(oo,"").replace(io,"$1").replace(so,"").replace(ao,"").replace(co,"").replace(lo,"");function pn(e){let[t,n]=[mo,po].map(r=>[...e.matchAll(r)]);if(t.length===1&&n.length===1){let[r,o]=[t[0].index,n[0].index+n[0][0].length],s=e.slice(0,r).replace(fo,""),a=e.slice(o).replace(ho,"");he(e.slice(0,r),s.replace(go,"")),he(e.slice(o),a);let i=!s||wo.test(s);e=e.slice(i?r:0,a?e.length:o)}for(let[r,o]of xo)e=e.replace(r,o);return e}function he(e,t){if(!bo.test(t))return;let n=M(e.trim());throw new f(`beside the matrix stands ${n}; expected entries that hold it`)}var dn=5e6,wn=String.raw`[\p{L}\p{N}_.]`,yo=String.raw`^\s*(?:${wn}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`,$o="Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym",fn=new RegExp(String.raw`${yo}(?:${wn}*(?:${$o})\s*\(\s*)+`,"u"),vo=/\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u,jo=/^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u,Ao=/\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g,Eo=/\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|(?:top|mid|bottom)rule|nonumber)(?![A-Za-z])/g,hn=/(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/,So=/^[-+*/^.0-9e \t]+(?=\[)/,gn=/^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m,Mo=/^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im,Oo=/^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/,bn=e=>{let t=e.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);return t.at(-1)===""&&t.pop(),t},rt=(e,t)=>{let[n,r]=[0,e.length];for(;n<r&&t.includes(e[n]);)n++;for(;r>n&&t.includes(e[r-1]);)r--;return e.slice(n,r)},Q=(e,t)=>{let n=e.length;for(;n>0&&t.includes(e[n-1]);)n--;return e.slice(0,n)};function I(e){if(e.length>dn)throw new f(`the text has ${e.length} characters; expected at most ${dn}`);let t=No(rt(mn(e).trim(),"`$").trim()).filter(n=>n.some(r=>r.trim())).map(n=>n.map(r=>r.trim()));if(!t.length)throw new f("the text is empty; expected rows of numbers or formulas");return t}function No(e){if(e.includes("\\begin{")||e.includes("\\\\"))return To(e);if(e.split("|").length>2&&!/^[^|]*\[[^\]|]*\|/.test(e))return Ro(e);let t=fn.test(e)?e.replace(fn,"").replace(vo,""):e;if(t=Q(t.replace(jo,"").trim(),";").trim(),t&&"[({".includes(t[0]))return xn(t);let n=So.exec(t);return n&&he(n[0],n[0].replace(/[ \t]/g,"")),Lo(t)}function To(e){return e=pn(e).replace(/\\left\s*[[(.|]\s*(?=\\begin)/g," ").replace(Ao," ").replace(Eo," ").replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u,"").replace(/\\\\\s*\[[^\]]*\]/g,"\\\\").replaceAll("$"," ").replaceAll("\\["," ").replaceAll("\\]"," "),e.split(/\\\\|\\cr(?![A-Za-z])/).map(t=>t.split("&"))}var Ro=e=>bn(e).map(t=>t.trim()).filter(t=>t.includes("|")&&!/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(t)).map(t=>t.replace(/^\||\|$/g,"").replaceAll("$"," ").split("|"));function xn(e){let t=ge(e);if(t.every(Z)){let r=t.map(ge);if(!r.some(a=>a.some(Z)))return r;let o=a=>Z(a)&&ge(a).length===1?ge(a)[0]:a,s=r.map(a=>a.map(o));return s.some(a=>a.some(Z))?t.flatMap(xn):s}let n=e.trim().slice(1,-1);return Z(e)&&!n.includes("[")?n.replace(/\.\.\.[^\n]*\n/g," ").split(/[;\n]/).map(we):[t]}function Z(e){return e=e.trim(),!e||!"[({".includes(e[0])||!ko(e)?!1:e[0]!=="("||st(e.slice(1,-1))}var ot=e=>"[({".includes(e)?1:"])}".includes(e)?-1:0;function ko(e){let t=0;for(let n=0;n<e.length;n++)if(t+=ot(e[n]),!t)return n===e.length-1;return!1}function st(e){let t=0;for(let n=0;n<e.length;n++)if(t+=ot(e[n]),e[n]===","&&!t)return!0;return!1}function ge(e){return e=Q(e.trim(),","),we(Z(e)?e.slice(1,-1):e)}function we(e){let t=e.trim().split(/\s+/);if(t.every(G))return t;let n=[],[r,o]=[0,""],s=st(e);for(let a=0;a<e.length;a++){let i=e[a];r+=ot(i),(s?i===",":/\s/.test(i)&&!_o(e,a))&&!r?(n.push(o),o=""):o+=i,!s&&!r&&i==="]"&&(n.push(o),o="")}return n.push(o),n.filter(a=>a.trim()).map(a=>rt(a.trim(),`'"`))}function _o(e,t){let[n,r]=[e.slice(0,t).trimEnd(),e.slice(t).trim()];return r==="*"?hn.test(`${n}*`):n.endsWith("*")&&r&&!"*/^)=".includes(r[0])&&hn.test(n)?!1:!n||!r||"+-*/^=(".includes(n.at(-1))||"*/^)=".includes(r[0])?!0:"+-".includes(r[0])&&r.length>1&&/\s/.test(r[1])||r.startsWith("deg")||r[0]==="°"}function Lo(e){let t=gn.exec(e);e=e.replace(new RegExp(gn,"gm"),"");let n=e.split(Mo).map(zo).filter(s=>s.length),r=[...new Set(n.map(s=>s.length))].sort((s,a)=>s-a);if(r.length>1)throw new f(`the blocks of columns have ${r.join(", ")} rows; expected as many in each`);let o=(n[0]??[]).map((s,a)=>n.flatMap(i=>i[a]));return t?o.map(s=>s.map(a=>z(a)?`${a}*${t[1]}`:a)):o}function zo(e){let t=bn(e).filter(o=>o.trim()&&!Oo.test(o)).filter(o=>!/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(o)),n=o=>t.some(s=>Q(s.trim(),";").includes(o)),r=["	",";"].find(n);if(r){let o=s=>Q(rt(s,`\r
 `),r);return t.map(s=>o(s).split(r).map(Fo))}return t.some(st)?Io(t):t.map(o=>we(o.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g,"")))}function Io(e){let t=e.every(n=>/^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(n));return e.map(n=>we(t?n.replaceAll(",","."):Q(n,",")))}function Fo(e){let t=e.trim();return t[0]==='"'&&t.at(-1)==='"'&&(e=t.slice(1,-1)),e=e.replace(/^[ \t]*=/,""),e.split(",").length===2&&!e.includes("(")?e.replace(/(?<=\d),(?=\d)/g,"."):e}var Co=e=>e.every(t=>t.every(n=>z(n)!==null));function ee(e){let[t,...n]=e,r=t.map(A).filter(Boolean);return n.length>0&&r.every(s=>z(s)===null)&&Co(n)?n:e}var Po=/^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/,yn=/^([cs])((?:[+-]?\d)+)$/i,Do=/^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/,it=e=>b(e).map(t=>t+1),ne=e=>b(e).map(t=>e.rows[t].kind==="revolute"),ct=e=>it(e).map(t=>`q_${t}`);function lt(e,t,n=[]){let r=[];return{known:s=>{let[a,i]=Zo([...s].sort(),e,t,n);for(let c of i)r.includes(c)||r.push(c);return a},said:r}}var Bo=e=>{if(e.size)throw new f(y("symbols for numbers",{names:[...e].sort().join(", ")}));return new Map};function $n(e,t,n=Bo,r="numbers"){if(typeof e=="string")return qo(e,t,n);let o=vn(e),s=e.flat(1/0);if(!s.every(Number.isFinite))throw new f(y("not finite",{what:t,wanted:r}));return{values:s,units:J(s.map(D)),shape:o,symbolic:!1}}var vn=e=>Array.isArray(e)?[e.length,...e.length?vn(e[0]):[]]:[];function qo(e,t,n){let r=ee(I(e)),o=[...new Set(r.map(p=>p.length))].sort((p,w)=>p-w);if(o.length>1)throw new f(y("ragged",{what:t,widths:o.join(", ")}));let s=r.flat().map(A),a=s.map(p=>G(p)?["num",Number(p)]:N(p,`an entry of ${t}`)),i=new Set;for(let p of a)L(p,i);let c=n(i),u=a.map(p=>U(p,w=>c.get(w))),l=s.map(Go),d=J(l.map(([p])=>p)).map((p,w)=>p*l[w][1]),h=a.map((p,w)=>l[w][1]===1?p:["num",u[w]]);return{values:u,units:d,shape:[r.length,o[0]],symbolic:i.size>0,trees:h}}function Go(e){let t=Do.exec(e);return t?[t[1],Number(t[2])]:[e,1]}var ut=e=>`one value for each of ${ct(e).join(", ")}`;function mt(e,t,n="rad"){let r=$n(e,`${t.name}: q`,void 0,ut(t)),o=typeof e=="string"?[r.values.length]:r.shape,s=b(t).length;if(o.length!==1||o[0]!==s)throw new f(jn(t,o,`one pose, (${s},)`));return pt(r,t,n)}function jn(e,t,n){let r=_e(t);return`${e.name}: q has shape ${r}; expected ${n}, ${ut(e)}`}function pt(e,t,n){let r=ne(t),o=s=>n==="deg"&&r[s%r.length]?v:1;return{...e,values:e.values.map((s,a)=>s*o(a)),units:e.units.map((s,a)=>s*o(a))}}function Uo(e,t){let n=ne(t),r=n.some(Boolean)&&!n.every(Boolean),o=r?J(e.flatMap(({values:i})=>i.filter((c,u)=>n[u])).map(D)):[],s=0,a=(i,c)=>{if(!r||!n[c])return i;let u=o[s++];return i>0?Math.max(u,i):i};return e.map(i=>pt({...i,units:i.units.map(a)},t,"deg"))}var te=e=>e.replace(/\(t\)|[_{}'*^\\ ]/g,"").replace(/[ϑθ]/g,"theta").toLowerCase();function Zo(e,t,n,r){let o=new Map([...t.values??[],...r]),s=new Map([...o].map(([l,d])=>[te(l),d])),a=new Map(e.filter(l=>s.has(te(l))).map(l=>[l,s.get(te(l))])),i=new Map(e.filter(l=>!a.has(l)).map(l=>[l,Ho(l)])),[c,u]=Wo([...new Set([...i.values()].flatMap(l=>l??[]))],t);for(let[l,d]of i){let h=(d??[]).map(p=>c.get(p));if(!h.length||h.includes(void 0)){let p=[...ct(t),...(t.values??[]).map(([w])=>w)].join(", ");throw new f(y("unknown symbol",{arm:t.name,name:l,known:p}))}a.set(l,Ko(te(l),h.map(p=>n[p])))}return[a,u]}function Ho(e){let t=te(e),n=Po.exec(t);if(n)return[Number(n[2])];let r=yn.exec(t);return r?[...r[2].matchAll(/\d/g)].map(Number):null}function Wo(e,t){let n=it(t),r=new Map(n.map((a,i)=>[a,i])),o=a=>e.every(i=>i>=a&&i<a+n.length);if(e.every(a=>r.has(a)))return[r,[]];let s=a=>new Map(n.map((i,c)=>[c+a,c]));return o(1)?[s(1),[y("taken: counted on",{joints:n.join(", ")})]]:o(0)?[s(0),[y("taken: from zero",{joints:n.join(", ")})]]:[r,[]]}function Ko(e,t){let n=yn.exec(e);if(!n)return t[0];let r=[...n[2].matchAll(/([+-]?)\d/g)].map(([,s])=>s==="-"?-1:1),o=t.reduce((s,a,i)=>s+r[i]*a,0);return e[0]==="c"?Math.cos(o):Math.sin(o)}var ft={};x(ft,{ownValues:()=>be,valuesCall:()=>Xo});var Vo=/^\s*(?:values\s*=\s*)?(?:dict\s*\(([^]*)\)|\{([^]*)\})\s*$/,Yo=/^\s*(["']?)(.+?)\1\s*[=:]\s*([^=:]+?)\s*$/s,Jo=/^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;function be(e){let[,t,n]=Vo.exec(e)??[];return(t??n??e).split(/[,;\n]/).filter(o=>o.trim()).map(o=>{let[,,s,a]=Yo.exec(o)??[],[i,c]=s?[A(s),z(a)]:["",null];if(c!==null&&Jo.test(i))return[i,c];throw new f(`your own symbols: ${M(o.trim())} is not read; expected such as h = 0.333`)})}function Xo(e){let t=be(e).map(([n,r])=>`"${n}": ${D(r)}`);return t.length?[`values={${t.join(", ")}}`]:[]}var wt={};x(wt,{checkerOf:()=>ye,load:()=>re,ready:()=>gt,register:()=>es});var ht=new Map,xe=new Map,Qo=typeof document>"u"?null:document.currentScript?.src,es=(e,t)=>{ht.set(e,t)},ye=e=>ht.get(e),gt=e=>ht.has(e)?Promise.resolve():re($[e].script);function re(e){return xe.has(e)||xe.set(e,ts(e)),xe.get(e)}function ts(e){return new Promise((t,n)=>{let r=()=>{xe.delete(e),n(new Error(`The script judge-${e}.js could not be loaded.`))},o=new URL(`judge-${e}.js`,Qo).href;document.head.append(Object.assign(document.createElement("script"),{src:o,onload:()=>t(),onerror:r}))})}var An=12e3,ns={table:2e3,q:500,wrench:300,values:500,answer:8e3,target:1e3},En=2e4,rs="the arm asked about",T="own",H=["rad","deg"],bt={unit:H,first:["v","omega"],plane:["zy","yz","zx","xz"],pace:["even","rest"],lengths:["","m","cm","mm"],angles:["",...H],convention:["","standard","craig"]},W={ask:"jacobian",arm:"",table:"",q:"",unit:"rad",frame:"0",first:"v",wrench:"",values:"",answer:"",columns:"",lengths:"",angles:"",convention:"",target:"",radius:"0.1",plane:"zy",period:"5",steps:"",pace:"even"};function xt(e){let t=Object.entries(e).filter(([n,r])=>r!==W[n]||n==="ask"||n==="arm");return`#${new URLSearchParams(t)}`}function yt(e,t){let n=e.replace(/^#/,"");if(!/^ask=/.test(n))return{question:null,words:""};let r=i=>({question:null,words:`The link could not be read: ${i}.`});if(n.length>An)return r(`it has ${n.length} characters; ${An} are the most`);let o=new URLSearchParams(n),s={...W};for(let[i,c]of o){if(!Object.hasOwn(W,i))return r(`it has a field “${i.slice(0,40)}”`);if(c.length>(ns[i]??40))return r(`its ${i} is too long`);s[i]=c}if(!Object.hasOwn($,s.ask))return r("it asks what is not judged here");if(s.arm!==T&&!t.includes(s.arm))return r(`there is no arm called “${s.arm}” here`);let a=Object.keys(bt).find(i=>!bt[i].includes(s[i]));return a?r(`its ${a} is none`):/^\d{1,2}$/.test(s.frame)?{question:s,words:""}:r("its frame is none")}function $t(e,t){if(e.arm!==T)return t.find(({key:s})=>s===e.arm);if(!e.table.trim())throw new f("Type the table of your arm: a row for each joint, a α d θ.");let n=new Map($[e.ask].fields.includes("values")?be(e.values):[]),r=I(e.table).filter((s,a)=>a||!s.some(i=>/^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(i))).map((s,a)=>as(s.length===5?s.slice(1):s,a+1,e.unit,n)),o=Ue(r);if(o)throw new f(`${o}.`);return{...Ze(r,{name:"",home:[],rows:[]}),name:rs}}var os=["a","alpha","d","theta"],ss=/^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;function as(e,t,n,r){if(e.length!==4)throw new f(`Row ${t} of the table has ${e.length} entries; expected four: a α d θ.`);let o=e.map((d,h)=>N(d||"0",`row ${t}, ${os[h]}`)),s=o.map(d=>[...L(d)].filter(h=>!r.has(h))),a=s.flatMap((d,h)=>d.filter(p=>h<2||!ss.test(p)));if(a.length)throw new f(`Row ${t} of the table: no value for ${a[0]}; write numbers, and a variable such as q1.`);let[i,c,u,l]=o.map((d,h)=>{let p=n==="deg"&&h%2&&!/deg|°|pi|π/.test(e[h]);return U(d,w=>r.get(w)??0)*(p?v:1)});return{kind:s[2].length?"prismatic":"revolute",a:i,alpha:c,d:u,theta:l}}function vt(e,t){let n,r;try{n=$t(e,t);let o=is(e,n);if(o)return{error:o,arm:n};if(r=Sn(e)?mt(e.q,n,e.unit).values:void 0,!e.answer.trim())return{error:"Type or paste your answer.",arm:n,q:r};let s=$[e.ask].longest??En;if(e.answer.length>s)return{error:`The answer is longer than ${s} characters.`,arm:n,q:r};let a=ye(e.ask);return a?{report:a.verdict(e,n),arm:n,q:r}:{error:"The checker is being loaded.",waiting:!0,arm:n,q:r}}catch(o){if(o instanceof f)return{error:cs(o.message),arm:n,q:r};throw o}}var Sn=({ask:e})=>$[e].fields.includes("q"),is=(e,t)=>Sn(e)&&!e.q.trim()?`Type the pose: ${b(t).length} joint values.`:null,cs=e=>e.slice(0,1).toUpperCase()+e.slice(1);function ls(e,t){let n=$t(e,t),[r,o]=e.arm===T?["arm",ms(n)]:[n.python,us(n.python)],{call:s,imports:a=[]}=ye(e.ask),i=[...o,...a,"from helpers import checks",""];return e.arm===T&&i.push(...ps(n),""),i.push(`mine = ${Le(e.answer)}`,`print(${s(e,r,n)})`),`${i.join(`
`)}
`}var us=e=>[`from helpers.robots import ${/^\w+/.exec(e)[0]}`],Mn={revolute:"revolute",prismatic:"prismatic",fixed:"fixed"},ms=e=>[`from helpers.arm import Arm, ${[...new Set(e.rows.map(({kind:t})=>Mn[t]))].sort().join(", ")}`],ps=e=>["rows = [",...e.rows.map(({kind:t,a:n,alpha:r,d:o,theta:s})=>`    ${Mn[t]}(a=${n}, alpha=${r}, d=${o}, theta=${s}),`),"]",`arm = Arm("${e.name}", rows)`];var St={};x(St,{MARKS:()=>Et,better:()=>js,both:()=>On,cause:()=>hs,complete:()=>$s,explain:()=>bs,explainAll:()=>Tn,linesOf:()=>$e,nameOf:()=>gs,several:()=>vs,textOf:()=>As,wordsOf:()=>Nn});var ds=.6,fs=.85,At=.7,hs=(e,t={})=>({keys:[e],fields:[t]}),On=(e,t)=>({keys:[...e.keys,...t.keys],fields:[...e.fields,...t.fields]}),gs=({keys:e,fields:t})=>e.map((n,r)=>ws(n,t[r])).join(" + ");function ws(e,t){if("_of"in t)return t._of;let n=Object.entries(t).filter(([r])=>!r.startsWith("_"));return[e,...n.map(([,r])=>r)].join(":")}function Nn({keys:e,fields:t}){let[n,r]=e.map((o,s)=>y(o,t[s]));return r===void 0?n:y("and also",{first:n,second:ce(r)})}var bs=(e,t,n,r,o,s=At)=>Tn(e,t,[n],r.map((a,i)=>[[a],o[i]]),s)[0];function Tn(e,t,n,r,o=At){let s=n.map(a=>{let i=e.filter((u,l)=>Math.abs(u-t[l])>a[l]).length,c=[Math.max(3,ds*i),Math.max(4,fs*i)];return{band:a,count:i,least:c,named:[]}});for(let[a,i]of r){let c=a.length>1?2:a[0].keys.length;for(let{band:u,count:l,least:d,named:h}of s){let p=xs(e,i,u,l,d[c-1]);(p?l-p>=d[c-1]:l>0)&&h.push({cost:c+o*p,parts:a,A:i})}}return s.map(a=>ys(e,a))}function xs(e,t,n,r,o){let s=0;for(let a=0;a<e.length;a++)if(!(Math.abs(e[a]-t[a])<=n[a])&&(s++,r-s<o))return s;return s}function ys(e,{band:t,named:n}){if(!n.length)return null;let r=Math.min(...n.map(({cost:i})=>i)),o=n.filter(({cost:i})=>i===r),s=o.map(({parts:i})=>i.reduce(On)),[{A:a}]=o;return{causes:s,odd:e.map((i,c)=>!(Math.abs(i-a[c])<=t[c]))}}var $s=e=>!!e&&!e.odd.includes(!0);function vs(e,t=3){let n=[...new Set(e.map(Nn))].slice(0,e[0].keys.length===1?t:1);return n.length===1?n[0]:y("or",{first:n[0],others:ke(n.slice(1).map(ce),"or")})}function js(e,t=At){let n=r=>r.causes[0].keys.length+t*r.odd.filter(Boolean).length;return e.filter(Boolean).reduce((r,o)=>r&&n(r)<=n(o)?r:o,null)}var Et={[me]:"✔",[Y]:"◐",[pe]:"≈",wrong:"✘"},$e=({headline:e,findings:t,taken:n,notes:r})=>[...t.filter(({what:o,words:s})=>o!=="cause"&&!e.includes(s.slice(1))).map(({words:o})=>o),...n.map(o=>`Taken as ${o}`),...r.map(o=>`Note: ${o}`)],As=e=>[e.headline,...$e(e).map(t=>`- ${t}`)].join(`
`);var Lt={};x(Lt,{matrixOf:()=>Bn,namesOf:()=>Tt,showRead:()=>Rt,tell:()=>_t,typeset:()=>se});var Es="http://www.w3.org/1998/Math/MathML",[Mt,R,_n,F]=[1,2,3,4],[Ss,Ms]=["⁡","⁢"],Os={alpha:"α",beta:"β",gamma:"γ",delta:"δ",theta:"θ",th:"θ",phi:"φ",psi:"ψ",omega:"ω",lambda:"λ",pi:"π",inf:"∞"},Ns={asin:"arcsin",acos:"arccos",atan:"arctan",sind:"sin",cosd:"cos"},Ts=/^(?:[Ff]loat|Integer|float64|float32|int64)$/,Rs=/^(?:radians|deg2rad)$/,C=e=>["mo",e],k=e=>e.length===1?e[0]:["mrow",e],Rn={stretchy:"false",lspace:"0",rspace:"0"},Ln=(e,t="(",n=")")=>k([["mo",t,{form:"prefix",...Rn}],...e,["mo",n,{form:"postfix",...Rn}]]),ve=e=>["math",[k(E(e).pieces)],{displaystyle:"true"}];function oe([e,t,n={}]){let r=document.createElementNS(Es,e);for(let[o,s]of Object.entries(n))r.setAttribute(o,s);return r.append(...typeof t=="string"?[t]:t.map(oe)),r}var je=([e,t])=>e==="num"||e==="neg"&&t[0]==="num";function E(e){let[t,n,r]=e;if(t==="num")return ks(n);if(t==="name")return{level:F,pieces:[_s(n)]};if(t==="call")return Ls(n,r);if(t==="^")return{level:_n,pieces:[["msup",[k(P(n,F)),k(E(r).pieces)]]]};if(t==="/"&&n[0]==="neg")return kn(["neg",["/",n[1],r]]);if(t==="/"){let o=[n,r].map(s=>k(E(s).pieces));return{level:R,pieces:[["mfrac",o]]}}return t==="*"?zs(e):kn(e)}function P(e,t){let{level:n,pieces:r}=E(e);return n<t?[Ln(r)]:r}function ks(e){let[t,n]=String(Math.abs(e)).split("e"),r=[["mn",t]];if(n){let o=k([...n[0]==="-"?[C("−")]:[],["mn",n.replace(/^[+-]/,"")]]);r.push(C("⋅"),["msup",[["mn","10"],o]])}return e<0?{level:Mt,pieces:[C("−"),...r]}:{level:n?R:F,pieces:r}}function _s(e){let[,t,n,r]=/^([A-Za-z]+)_?(.*?)('?)$/.exec(e.replace(/[{}]/g,""));if(t==="deg"&&!n)return["mi","°"];let o=["mi",(Os[t]??t)+r.replace("'","′")],a=(n.match(/\d+|[A-Za-z_]+|[+-]/g)??[]).map(i=>[/\d/.test(i)?"mn":/\w/.test(i)?"mi":"mo",i.replace("-","−")]);return a.length?["msub",[o,k(a)]]:o}function Ls(e,t){if(Ts.test(e))return E(t);if(e==="sqrt")return{level:F,pieces:[["msqrt",[k(E(t).pieces)]]]};if(e==="abs")return{level:F,pieces:[Ln(E(t).pieces,"|","|")]};if(Rs.test(e))return{level:R,pieces:[...P(t,F),["mi","°"]]};let n=e.endsWith("d")?[["mi","°"]]:[],r=P(t,F),s=r[0][0]==="mrow"?r:[["mspace","",{width:"0.17em"}],...r];return{level:_n,pieces:[["mi",Ns[e]??e],C(Ss),...s,...n]}}function zs(e){let t=In(e,["*"]).map(([,o])=>o),n=t[0][0]==="neg"||t[0][0]==="num"&&t[0][1]<0,r=n?E(t[0]).pieces:P(t[0],R);return t.slice(1).forEach((o,s)=>{o[0]==="name"&&o[1]==="deg"||r.push(C(Is(t[s],o)?"⋅":Ms)),r.push(...P(o,R))}),{level:n?Mt:R,pieces:r}}var Is=(e,t)=>zn(t)||e[0]==="call"&&t[0]!=="call"&&e[1]!=="sqrt"&&e[1]!=="abs",zn=([e,t])=>e==="num"||["^","*"].includes(e)&&zn(t);function kn(e){let t=[];for(let[n,r]of In(e,["+","-"]))n&&t.push(C(n==="-"?"−":"+")),n?t.push(...P(r,R)):r[0]==="neg"?t.push(C("−"),...P(r[1],R)):t.push(...E(r).pieces);return{level:Mt,pieces:t}}function In(e,t){let n=[];for(;t.includes(e[0]);)n.push([e[0],e[2]]),e=e[1];return[["",e],...n.reverse()]}var Fs={v:["vx","vy","vz","ωx","ωy","ωz"],omega:["ωx","ωy","ωz","vx","vy","vz"]},Cs=["a (m)","α","d (m)","θ"],Ot=40,Dn=8e3;function Tt({ask:e,first:t},n,[r,o]){let s=b(n).map(c=>c+1),a=c=>s.length===o?`joint ${s[c]}`:String(c+1),i={torques:r===1?["τ"]:[],jacobian:r===6?Fs[t]:[]}[e]??[];return{columns:Array.from({length:o},(c,u)=>a(u)),rows:Array.from({length:r},(c,u)=>i[u]??`row ${u+1}`)}}function Bn(e,{report:t,arm:n}){let r=t?.typed;if(!r||r.shape.length!==2)return null;let o=e.ask==="torques"&&r.shape[1]===1,[s,a]=o?[1,r.values.length]:r.shape,i=t.wrong?.length===r.values.length?t.wrong:[];return{...Tt(e,n,[s,a]),typed:r,wrong:i,shape:[s,a]}}function Rt(e,t,n){let r=Ps(t,n);if(e.hidden=!r,!r)return;let{columns:o,rows:s,cell:a,unread:i=0}=r,c=m("tr",{},m("td"),o.map(w=>m("th",{scope:"col"},w))),u=s.slice(0,Ot).map((w,ae)=>m("tr",{},m("th",{scope:"row"},w),o.map((ie,K)=>a(ae,K)))),l=s.length>Ot?`, its first ${Ot} of ${s.length} rows`:"",d=i?`; ${i===1?"1 entry":`${i} entries`} could not be`:"",h=m("caption",{},`How your answer is read${l}${d}`),p=t.ask==="table"?"table.read":"table.read.matrix";e.replaceChildren(m(p,{},h,m("thead",{},c),m("tbody",{},u)))}function Ps(e,t){let{table:n}=t.report??{};return n?Ds(n):Bs(e,Bn(e,t))??qs(e,t)}var Ds=({cells:e,trees:t,wrong:n})=>({columns:Cs,rows:e.map((r,o)=>String(o+1)),cell(r,o){let[s,a]=[t[r][o],e[r][o]],i=/^-?q_\d+$/.test(a);return Ae(s&&!je(s)?qn(s,i?"":a):kt(a),n[r][o])}});function Bs({answer:e},t){if(!t)return null;let{typed:n,wrong:r,shape:o}=t,s=e.length>Dn?[]:n.trees??[];return{...t,cell(a,i){let c=a*o[1]+i,u=s[c];return!u||je(u)&&n.units[c]?Ae(kt(Fn(n,c)),r[c]):Ae(qn(u,je(u)?"":Fn(n,c)),r[c])}}}function qs(e,{error:t,waiting:n,arm:r,q:o}){let{ask:s,answer:a}=e;if(!t||n||!r||!a.trim()||s==="trace"||a.length>Dn)return null;let i=Gs(s,a).map(u=>u.map(l=>Us(s,l,r,o))),c=Math.max(0,...i.map(u=>u.length));return{...Tt(e,r,[i.length,c]),unread:i.flat().filter(({tree:u})=>!u).length,cell(u,l){let{tree:d,text:h}=i[u][l]??{};return h===void 0?m("td"):d?m("td",{},oe(ve(d))):Ae(h,!0,"not read: ")}}}function Gs(e,t){try{let n=ee(I(t));return e==="table"&&!n[0].some(r=>/\d/.test(r))?n.slice(1):n}catch(n){if(n instanceof f)return[];throw n}}function Us(e,t,n,r){let o=e==="branches"||e==="pose";try{let s=N(A(o?t.replace(/^.*[=:]/,""):t).replace(/\*+$/,"")||"0");return e==="jacobian"&&r&&lt(n,r).known(L(s)),{tree:s,text:t}}catch(s){if(s instanceof f)return{tree:null,text:t};throw s}}function Fn({values:e,units:t},n){let r=Math.min(6,t[n]?Math.max(0,Math.round(-Math.log10(t[n]))):4);return(Number(e[n].toFixed(r))+0).toFixed(r)}var kt=e=>se(e.replaceAll("-","−")),qn=(e,t)=>t?[oe(ve(e)),m("span.value",{},"= ",kt(t))]:[oe(ve(e))],Ae=(e,t,n="wrong: ")=>t?m("td.off",{},m("span.unseen",{},n),e):m("td",{},e);function _t(e,{report:t,error:n}){if(e.className=`verdict ${t?.grade??""}`,!t)return e.replaceChildren(m("p",{},se(n)));let r=$e(t).filter(a=>!t.headline.endsWith(a.slice(1))),o=r.length?[m("ul",{},r.map(a=>m("li",{},se(a))))]:[],s=m("span",{"aria-hidden":"true"},`${Et[t.grade]} `);return e.replaceChildren(m("p.headline",{},s,se(t.headline)),...o)}var Zs=/(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g,Hs={theta:"θ",alpha:"α"},Cn=String.raw`(?:N m|N|mm|m\/s\^2|m\/s²|m|degrees|deg|rad)(?![\w/^])`,Nt=String.raw`[-+±−]*[\w.^°]{1,8}(?:\{[^}\s]{1,5}\})?(?![\w^°({]|\.\w)`,Ws=String.raw`[^\s,;]{1,16}(?![^\s,;])`,Ks=[String.raw`(?<![\w.^°}])\(?${Nt} [-+−<>] ${Nt}(?: ${Cn})?[)'’”",.;:]*`,String.raw`(?<![\w.])[-+±−]*\d[\d.]*(?:(?:e-?\d+)? ${Cn}|e-\d+)`,String.raw`\p{L}+ [-+−]['’”",.;:)]+`,String.raw`(?<![\w)\]}])[-+±]+(?:${Ws}|${Nt})`,String.raw`N m(?!\w)`],Vs=new RegExp(`(${Ks.join("|")})`,"u"),se=e=>e.split(Vs).flatMap((t,n)=>n%2?m("span.unbroken",{},Pn(t)):Pn(t));function Pn(e){let t=[],n=0;for(let r of e.matchAll(Zs)){let[o,s,a,i]=r;t.push(e.slice(n,r.index),m("i",{},Hs[s]??s)),t.push(m("sub",{},(a??i).replace("-","−"))),n=r.index+o.length}return[...t,e.slice(n)]}var Gn={"arm.js":He,"dom.js":We,"kinematics.js":De,"judge/ask.js":jt,"judge/digits.js":Qe,"judge/door.js":dt,"judge/formula.js":nt,"judge/grid.js":at,"judge/judges.js":Ie,"judge/own_values.js":ft,"judge/ranking.js":St,"judge/registry.js":wt,"judge/say.js":ze,"judge/shown.js":Lt};var Un=e=>[["","as it looks"],...e.map(t=>[t,t])],Zn={spellcheck:"false",autocomplete:"off",autocapitalize:"off"},Wn={table:{label:"Table",rows:6,whole:!0,hint:"A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen."},q:{label:"Pose q",hint:"",whole:!0},unit:{label:"Angles in",choices:H.map(e=>[e,e])},frame:{label:"Rows in the axes of",choices:[]},first:{label:"Order of the rows",choices:[["v","v, then ω"],["omega","ω, then v"]]},wrench:{label:"Wrench on the tool, by the world",whole:!0,hint:"Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down."},columns:{label:"Order of the columns",hint:"As in “theta d a alpha”; guessed where it is empty."},lengths:{label:"Lengths in",choices:Un(["m","cm","mm"])},angles:{label:"Angles in",choices:Un(H)},convention:{label:"Convention",choices:[["","as it looks"],["standard","standard"],["craig","modified (Craig)"]]},target:{label:"Where the tip should be",rows:4,whole:!0,hint:"A point x, y, z in m, or a pose: its three or four rows, in base axes."},radius:{label:"Radius of the circle below the tip, in m"},plane:{label:"Its plane",choices:[["zy","towards +y first"],["yz","towards −y"],["zx","towards +x"],["xz","towards −x"]]},period:{label:"Time for it, in s"},steps:{label:"Steps",hint:"Empty: as many as your answer has."},pace:{label:"Pace",choices:[["even","even"],["rest","from rest to rest"]]},values:{label:"Your own symbols",whole:!0,hint:"Numbers for those that the arm does not have, in m and rad, as in “h = 0.333, l = 0.1”."},answer:{label:"Your answer",hint:"",rows:8,whole:!0}},Ys={jacobian:"Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",table:"A row for each link, with heads or without: lists, Link(…) lines, MATLAB, LaTeX, Markdown, CSV or cells.",branches:"A row for each answer, angles in the joints' order; names such as theta1 = may stand before them.",pose:"One value for each joint, in the joints' order; names such as theta1 = may stand before them.",trace:"A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",torques:"One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet."},Js="Pose q at which the circle begins",Xs=["frame","first","values","columns","lengths","angles","convention"],Kn=([e,t])=>m("option",{value:e},t);function Qs({choices:e,rows:t,hint:n},r,o){let s=n===void 0?{}:{"aria-describedby":[`${r}-hint`,...o].join(" ")},a={id:r,...s};return e?m("select",a,e.map(Kn)):t?m("textarea",{rows:t,wrap:"off",...Zn,...a}):m("input",{...Zn,...a})}function ea(e,t,n){let r=m("label",{for:t},e.label),o=e.hint===void 0?[]:[m("p.about",{id:`${t}-hint`},e.hint)];return m(e.whole?"div.field.whole":"div.field",{},r,n,...o)}function Vn(e,t,n){let r={ask:{label:"Question",choices:Object.entries($).map(([u,{title:l}])=>[u,l])},arm:{label:"Arm",choices:[...t.map(({key:u,title:l})=>[u,l]),...t.length>1&&n?[]:[[T,"My own table"]]]},...Wn},o=u=>`${e}-${u}`,s=Object.fromEntries(Object.entries(r).map(([u,l])=>[u,Qs(l,o(u),u==="answer"?[o("private")]:[])])),a=Object.fromEntries(Object.entries(r).map(([u,l])=>[u,ea(l,o(u),s[u])]));for(let u of n?ta(n,t):[])a[u]?.classList.add("given");let i=n?na(n,t):"";return n&&(s.answer.rows=6),{form:m("form",{"aria-label":`Check an answer${i&&`: ${i}`}`},i?m("p.asked",{},"Judged here: ",i):[],Object.values(a)),fields:s,boxes:a}}var ta=(e,t)=>[...Object.keys(e),...Xs,...t.length<2?["arm"]:[],..."q"in e?["unit"]:[]];function na({ask:e,q:t,wrench:n},r){let o=r.length===1?`, ${r[0].title}`:"";return[`${$[e].title}${o}`,t&&`q = (${t})`,n&&`wrench (${n})`].filter(Boolean).join(", ")}function Yn({fields:e,boxes:t},n,r){let o=new Set(["ask","arm","answer",...$[n.ask].fields]);n.arm===T&&o.add("table");for(let[i,c]of Object.entries(t))c.hidden=!o.has(i);Hn(t.answer,Ys[n.ask]??"");let s=r.find(({key:i})=>i===n.arm);q(t.q.querySelector("label"),n.ask==="trace"?Js:Wn.q.label),Hn(t.q,s?ra(s):"One value for each joint, in the table's order.");let a=s?s.rows.length:16;if(e.frame.options.length!==a+1){let i=u=>u?`frame ${u}`:"the base",c=Array.from({length:a+1},(u,l)=>Kn([String(l),i(l)]));e.frame.replaceChildren(...c),e.frame.value=n.frame}}var Hn=(e,t)=>q(e.querySelector(".about"),t),ra=e=>`${b(e).map(n=>`q_${n+1}`).join(", ")}${ne(e).includes(!1)?"; m where a joint slides":""}`;var oa=5e4,Jn=120,sa=350,Xn="Nothing that you type leaves this page: a script in it judges, without a network too.",aa="It names the mistake and does not print the solution.",ia=0;function Qn(e){let{arms:t,examples:n=[],given:r}=JSON.parse(e.querySelector("script").textContent),o=`judge-${++ia}`,s=Vn(o,t,r),{form:a,fields:i}=s,c=ca(o,r),u=[],l={...W,arm:t[0]?.key,...r??n[0]},d,h=0,p=!1,w=g=>l[g].length>oa?"":l[g],ae=()=>{for(let[g,S]of Object.entries(i))S.value!==w(g)&&(S.value=w(g));Yn(s,l,t)},ie=g=>q(c.said,g),K=()=>_t(c.verdict,d),Ee=()=>Rt(c.taken,l,d),Se=()=>{Me(),K(),Ee()},er=()=>{Me(),K(),h=setTimeout(Ee)},tr=()=>{Me(),Ee(),h=setTimeout(K,sa-Jn)},Me=()=>{clearTimeout(h),p=!1,d=vt(l,t),d.waiting&&gt(l.ask).then(Se,({message:g})=>ie(g)),i.answer.setAttribute("aria-invalid",String(d.report?.grade==="wrong"));for(let g of u)g(l,d)},Oe=g=>{l={...l,...g},ae(),Se()};a.addEventListener("input",({target:g,inputType:S})=>{let _=Object.keys(i).find(nr=>i[nr]===g);_&&(l={...l,[_]:g.value},_==="arm"&&(l.frame="0"),(_==="arm"||_==="ask")&&(l.q=la(l,n)?.q??l.q),ae(),p=!0,clearTimeout(h),S==="insertFromPaste"||S==="insertFromDrop"?er():h=setTimeout(tr,Jn))}),a.addEventListener("submit",g=>g.preventDefault());let zt=()=>{let{question:g,words:S}=yt(location.hash,t.map(({key:_})=>_));(g||S)&&e.scrollIntoView({block:"start"}),ie(S),g&&Oe(g)};return e.replaceChildren(a,...Object.values(c)),Oe({}),r||(addEventListener("hashchange",zt),zt()),{stub:e,arms:t,examples:n,given:r,...s,parts:c,...{question:()=>l,verdict:()=>(p&&Se(),d)},put:Oe,follow:g=>{u.push(g),g(l,d)},say:ie,links:{fragment:()=>xt(l),open:()=>!0}}}function ca(e,t){return{verdict:m("div.verdict",{role:"status","aria-live":"polite","aria-atomic":"true"}),taken:m("div.scroll.taken",{role:"region",tabindex:"0","aria-label":"How your answer is read"}),tools:m("div.tools"),said:m("p.about",{role:"status"}),private:m("p.private",{id:`${e}-private`},t?Xn:`${Xn} ${aa}`)}}var la=(e,t)=>t.find(n=>n.arm===e.arm&&n.ask===e.ask);document.head.append(Object.assign(document.createElement("style"),{textContent:Ft}));for(let e of document.querySelectorAll(".arm-judge"))V.push(Qn(e));if(V.some(({given:e})=>!e))re("page");else for(let{stub:e}of V)e.addEventListener("focusin",()=>re("page"),{once:!0});Re({"and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","unknown symbol":"{arm}: no value for {name}; known are {known}. Give values={'{name}': ...} if it is a length of yours","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what}: NaN or infinity stands among the numbers; expected {wanted}",ragged:"{what} has rows of {widths} entries; expected rows of one length",row:"row {row}","taken: counted on":"symbols numbered on past what does not move: 1, 2, 3 ... are joints {joints}","taken: from zero":"symbols numbered from 0: 0, 1, 2 ... are joints {joints}"});return ir(ua);})();
