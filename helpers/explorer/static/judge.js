var ArmJudge=(()=>{var Ne=Object.defineProperty;var er=Object.getOwnPropertyDescriptor;var tr=Object.getOwnPropertyNames;var nr=Object.prototype.hasOwnProperty;var x=(e,t)=>{for(var n in t)Ne(e,n,{get:t[n],enumerable:!0})},rr=(e,t,n,r)=>{if(t&&typeof t=="object"||typeof t=="function")for(let o of tr(t))!nr.call(e,o)&&o!==n&&Ne(e,o,{get:()=>t[o],enumerable:!(r=er(t,o))||r.enumerable});return e};var or=e=>rr(Ne({},"__esModule",{value:!0}),e);var oa={};x(oa,{kit:()=>Dn});var ze={};x(ze,{ArmError:()=>f,learn:()=>Re,listed:()=>ke,lower:()=>ce,quoted:()=>Le,say:()=>y,shown:()=>M,size:()=>ar,spelled:()=>D,tuple:()=>_e});var Te={},Re=e=>{Te={...Te,...e}};function y(e,t={}){let n=Te[e];for(let[r,o]of Object.entries(t))n=n.replaceAll(`{${r}}`,()=>String(o));return n}var f=class extends Error{},ke=(e,t="and")=>e.length===1?e[0]:`${e.slice(0,-1).join(", ")} ${t} ${e.at(-1)}`,ce=e=>/^.(\p{Lu}|_)/su.test(e)?e:e.slice(0,1).toLowerCase()+e.slice(1),sr=9e6;function ar(e,t=3){if(!Number.isFinite(e))return Number.isNaN(e)?"nan":e>0?"inf":"-inf";if(e===0)return"0";let[n,r]=ir(e,t).split("e"),o=Number(r),s=a=>a.includes(".")?a.replace(/\.?0+$/,""):a;return o>=t&&Math.abs(e)<sr?(+`${n}e${r}`).toFixed(0):o<-4||o>=t?`${s(n)}e${zt(o)}`:s((+`${n}e${r}`).toFixed(Math.max(0,t-1-o)))}function ir(e,t){let n=e.toExponential(t-1),[r,o]=e.toExponential(t+25).split("e"),s=t===1?r.indexOf("."):r.indexOf(".")+t,a=r.slice(s).replace(".",""),i=r.slice(0,s);return/^50*$/.test(a)&&"02468".includes(i.at(-1))?`${i}e${o}`:n}var zt=e=>`${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;function D(e){let[t,n]=e.toExponential().split("e"),r=Number(n);if(e!==0&&(r<-4||r>=16))return`${t}e${zt(r)}`;let o=BigInt(Math.trunc(e)).toString();return r>20?o:String(e).includes("e")?e.toFixed(20).replace(/0+$/,""):String(e)}function M(e){let t=e.includes("'")&&!e.includes('"')?'"':"'",n={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},r=[...e].map(s=>n[s]??cr(s)).join(""),o=[...`${t}${r}${t}`];return o.length<=80?o.join(""):`${o.slice(0,77).join("")}...`}function cr(e){let t=e.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(e)||e===" "?e:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var _e=e=>e.length===1?`(${e[0]},)`:`(${e.join(", ")})`;function Le(e){return e.includes(`
`)&&!/"""|["\\]$/.test(e)&&!/[\r\0]/.test(e)?`r"""${e}"""`:JSON.stringify(e)}var It=`.arm-judge {
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
`;var Ie={};x(Ie,{judges:()=>V});var V=[];var He={};x(He,{KINDS:()=>Pt,LARGEST:()=>Ge,LONGEST:()=>qe,MOST_ROWS:()=>Be,TYPED:()=>Dt,carriedOver:()=>Gt,fits:()=>Zt,homeOf:()=>vr,limited:()=>Ar,outside:()=>jr,range:()=>$r,reachOf:()=>Er,rowsFault:()=>Ze,sameRow:()=>qt,typedArm:()=>Ue});var De={};x(De,{GRAVITY:()=>ur,cosSin:()=>Fe,cross:()=>Pe,dot:()=>mr,gravityTorque:()=>gr,jacobianColumns:()=>hr,joints:()=>b,liftedEnergy:()=>wr,linkFrames:()=>dr,matrix:()=>fr,minus:()=>Ce,norm:()=>pr,plus:()=>le,scaled:()=>Ft,wrenchTorque:()=>xr});var ur=9.81,mr=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],Ft=(e,t)=>[e*t[0],e*t[1],e*t[2]],le=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],Ce=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],Pe=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],pr=e=>Math.sqrt(e.reduce((t,n)=>t+n*n,0)),B=(e,t,n,r)=>[e*t[0]+n*r[0],e*t[1]+n*r[1],e*t[2]+n*r[2]];function Fe(e){let t=e/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(e),Math.sin(e)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var b=e=>e.rows.flatMap((t,n)=>t.kind==="fixed"?[]:[n]);function dr(e,t){let[n,r,o,s]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:n,y:r,z:o,o:s}],i=0;for(let c of e.rows){let l=c.kind==="fixed"?0:t[i++],[u,d]=Fe(c.kind==="revolute"?c.theta+l:c.theta),[h,p]=Fe(c.alpha),w=c.kind==="prismatic"?c.d+l:c.d;[n,r]=[B(u,n,d,r),B(u,r,-d,n)],s=le(B(w,o,c.a,n),s),[r,o]=[B(h,r,p,o),B(h,o,-p,r)],a.push({x:n,y:r,z:o,o:s})}return a}var fr=({x:e,y:t,z:n,o:r})=>[0,1,2].map(o=>[e[o],t[o],n[o],r[o]]).concat([[0,0,0,1]]);function hr(e,t,n=t.at(-1).o){return b(e).map(r=>{let{z:o,o:s}=t[r];return e.rows[r].kind==="revolute"?[...Pe(o,Ce(n,s)),...o]:[...o,0,0,0]})}function gr(e,t,n=9.81){let r=Ct(e,t);return b(e).map(o=>{let{z:s,o:a}=t[o],i=c=>e.rows[o].kind==="revolute"?Pe(s,Ce(c,a))[2]:s[2];return r.reduce((c,{mass:l,centre:u,row:d})=>c+(d<o?0:l*n*i(u)),0)})}var wr=(e,t,n=9.81)=>Ct(e,t).reduce((r,{mass:o,centre:s})=>r+o*n*s[2],0),Ct=(e,t)=>e.rows.flatMap((n,r)=>n.body?[br(n.body,t[r+1],r)]:[]);function br([e,...t],{x:n,y:r,z:o,o:s},a){return{mass:e,row:a,centre:le(s,le(B(t[0],n,t[1],r),Ft(t[2],o)))}}var xr=(e,t)=>e.map(n=>n.reduce((r,o,s)=>r+o*t[s],0));var Pt=["revolute","prismatic","fixed"],Be=16,qe=100,Ge=1e3,Dt="Your arm",Bt=[["a",qe],["alpha",Ge],["d",qe],["theta",Ge]];function Ze(e){if(!Array.isArray(e)||!e.length)return"the table has no rows";if(e.length>Be)return`the table has ${e.length} rows; ${Be} are the most`;for(let[t,n]of e.entries()){if(!Pt.includes(n?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[r,o]of Bt){if(!Number.isFinite(n[r]))return`row ${t+1} has no number for ${r}`;if(Math.abs(n[r])>o)return`row ${t+1} has ${n[r]} for ${r}; ${o} is the most`}}return null}var yr=({kind:e,a:t,alpha:n,d:r,theta:o})=>({kind:e,a:t,alpha:n,d:r,theta:o,lower:null,upper:null,speed:null,effort:null}),qt=(e,t)=>e.kind===t.kind&&Bt.every(([n])=>Math.abs(e[n]-t[n])<1e-12);function Ue(e,t){if(e.length===t.rows.length&&e.every((r,o)=>qt(r,t.rows[o])))return t;let n={name:Dt,home:[],rows:e.map(yr)};return{...n,home:Gt(t,t.home,n,r=>r)}}function Gt(e,t,n,r){let o=new Map(b(e).map((s,a)=>[s,[e.rows[s].kind,t[a]??0]]));return b(n).map(s=>{let[a,i]=o.get(r(s))??[];return a===n.rows[s].kind?i:0})}var vr=e=>Zt(e,e.home)?[...e.home]:b(e).map(()=>0),Zt=(e,t)=>Array.isArray(t)&&t.length===b(e).length&&t.every(Number.isFinite);function $r(e){let t=e.kind==="revolute"?Math.PI:1;return[e.lower??-t,e.upper??t]}var jr=(e,t)=>t<(e.lower??-1/0)-1e-9||t>(e.upper??1/0)+1e-9,Ar=e=>b(e).some(t=>e.rows[t].lower!==null||e.rows[t].upper!==null),Er=e=>e.rows.reduce((t,n)=>t+Math.abs(n.a)+Math.abs(n.d)+(n.kind==="prismatic"?Math.abs(n.upper??.3):0),0)||.3;var We={};x(We,{attribute:()=>Mr,calm:()=>Tr,h:()=>m,indexed:()=>Nr,svg:()=>Sr,whereNew:()=>Or,write:()=>q});function m(e,t={},...n){let[r,...o]=e.split("."),s=document.createElement(r);o.length&&(s.className=o.join(" "));for(let[a,i]of Object.entries(t))a.startsWith("on")?s.addEventListener(a.slice(2),i):i!==void 0&&i!==!1&&s.setAttribute(a,i===!0?"":i);return s.append(...n.flat()),s}function Sr(e,t={},...n){let r=document.createElementNS("http://www.w3.org/2000/svg",e);for(let[o,s]of Object.entries(t))r.setAttribute(o,s);return r.append(...n),r}function q(e,t){e.textContent!==t&&(e.textContent=t)}function Mr(e,t,n){e.getAttribute(t)!==n&&e.setAttribute(t,n)}function Or(e,t){let n=[];return r=>{let o=e(r);n.length&&o.every((s,a)=>s===n[a])||(n=o,t(r))}}var Nr=(e,t)=>[m("i",{},e),m("sub",{},String(t))],Tr=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var jt={};x(jt,{ASKED:()=>v,CHOICES:()=>bt,EMPTY:()=>W,LONGEST_ANSWER:()=>An,OWN:()=>T,UNITS:()=>H,armOf:()=>vt,asPython:()=>as,fromFragment:()=>yt,judge:()=>$t,toFragment:()=>xt});var $=Math.PI/180,Ke=180/Math.PI;var v={jacobian:{title:"Jacobian at a pose",fields:["q","unit","frame","first","values"],script:"jacobian"},torques:{title:"Joint torques at a pose",fields:["q","unit","wrench"],script:"jacobian"},table:{title:"Denavit-Hartenberg table",fields:["columns","lengths","angles","convention","values"],script:"table"},branches:{title:"All joint angles for a target",fields:["target","unit"],script:"motion"},pose:{title:"Joint angles for one pose",fields:["target","unit"],script:"motion"},trace:{title:"Joints along a circle",fields:["q","unit","radius","plane","period","steps","pace"],script:"motion",longest:5e6}};var dt={};x(dt,{eachJoint:()=>ut,inRadians:()=>pt,lookup:()=>lt,numbered:()=>it,numbers:()=>yn,pose:()=>mt,poseFault:()=>$n,rowsInRadians:()=>Bo,turning:()=>ne,variables:()=>ct});var Qe={};x(Qe,{HALF:()=>Wt,HAND:()=>Kt,RIGHT:()=>me,ROUNDED:()=>pe,SLOPPY:()=>Vt,SO_FAR:()=>Y,TELLING:()=>Yt,WRONG:()=>Ye,bands:()=>Fr,beyond:()=>Pr,decimalsOf:()=>zr,farthest:()=>Xe,generous:()=>Jt,graded:()=>Cr,margins:()=>Ir,units:()=>J});var[me,Y,pe,Ye]=["right","so far","rounded","wrong"],Wt=.51,Kt=3.01,Rr=1e-6,Vt=.001,Yt=.0021,kr=13,Ut=-12,_r=/^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/,Ht=e=>+`1e${e}`;function Lr(e){let t=_r.exec(e.trim());if(!t||!(t[1]||t[2]))return null;let n=(t[1]+t[2]).replace(/^0+/,"").length,r=t[2].length-Number(t[3]??0);return{decimals:r,digits:n,first:n-1-r}}function J(e){let t=e.map(Lr),n=t.filter(i=>i&&i.digits&&i.first>Ut),r=i=>n.reduce((c,l)=>Math.max(c,l[i]),n.length?-1/0:0),[o,s]=[r("decimals"),r("digits")];if(s>=kr||t.includes(null)&&o<=0)return e.map(()=>0);let a=n.every(i=>i.decimals<=s-1-i.first)&&n.some(i=>i.digits===s&&i.decimals<o);return t.map(i=>i?!a||!i.digits||i.first<=Ut?Ht(-o):Ht(Math.max(-o,i.first-s+1)):0)}function zr(e){let t=e.filter(n=>n>0);return t.length?Math.max(0,Math.round(-Math.log10(Math.min(...t)))):null}function Ir(e,t,n=null,r=null){let o=t.map(l=>Rr*l),s=e.map(()=>0);if(r!==null){let l=o.map(u=>Math.max(r,u*.001));return{allowed:l,band:l,loose:l,units:s,slop:s}}let a=e.map((l,u)=>Math.max(Wt*l,o[u])),i=e.map((l,u)=>Math.max(Kt*l,o[u])),c=i.map((l,u)=>Math.max(l,Vt*t[u]));return{allowed:a,band:i,loose:c,units:e,slop:n??s}}var Je=(e,t,n)=>e.map((r,o)=>r+n*t[o]),Xe=({loose:e,band:t,slop:n})=>Je(t,n,2).map((r,o)=>Math.max(r,e[o])),Jt=({allowed:e,slop:t})=>Je(e,t,1);function Fr(e){let t=e.slop.some(Boolean)?[Je(e.band,e.slop,2)]:[];return[e.band,...t,Xe(e),e.allowed]}var Ve=(e,t,n)=>e.every((r,o)=>Math.abs(r-t[o])<=n[o]),ue=(e,t)=>e.reduce((n,r,o)=>Math.max(n,Math.abs(r-t[o])),0);function Cr(e,t,n,r){let o=r.filter(a=>ue(a,t)>Yt);for(let a of[n.allowed,Jt(n)]){let i=o.some(c=>Ve(e,c,a));if(Ve(e,t,a)){let c=Math.max(0,...n.units),l=o.reduce((u,d)=>Math.min(u,ue(d,t)),1/0);return i||c>l/2.1?Y:me}if(i)return Ye}if(!Ve(e,t,Xe(n)))return Ye;let s=ue(e,t);return o.some(a=>ue(e,a)<=s)?Y:pe}function Pr(e,t,{band:n,allowed:r}){let o=a=>e.map((i,c)=>Math.abs(i-t[c])>a[c]),s=o(n);return s.includes(!0)?s:o(r)}var nt={};x(nt,{isNumber:()=>G,number:()=>z,parse:()=>N,plain:()=>A,symbols:()=>L,value:()=>Z});var Xt=2e4,tn=60,nn={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:e=>e*$,deg2rad:e=>e*$,degrees:e=>e*Ke,rad2deg:e=>e*Ke,sind:e=>Math.sin(e*$),cosd:e=>Math.cos(e*$),float:e=>e,Float:e=>e,Integer:e=>e,float64:e=>e,float32:e=>e,int64:e=>e},Qt={"+":(e,t)=>e+t,"-":(e,t)=>e-t,"*":(e,t)=>e*t,"/":(e,t)=>t===0?NaN:e/t,"^":Br},rn={pi:Math.PI,deg:$,rad:1},Dr=e=>Object.hasOwn(nn,e),on=e=>Object.hasOwn(rn,e);function Br(e,t){let n=e**t;return Number.isFinite(n)||!Number.isFinite(e)?n:NaN}var j=(e,t)=>[...e].map(n=>[n,t]),qr="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),Gr=new Map([...j("−–—‐‑‒﹣－","-"),...j("×⋅·∙∗","*"),...j("÷∕⁄","/"),...j("       　"," "),...j("​⁡⁢\uFEFF",""),...j("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((e,t)=>j(e,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((e,t)=>j(e,` ${qr[t]}`)),...j("π𝜋"," pi "),...j("°º"," deg"),["$"," "],["²","^2"],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),Zr=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)(?![A-Za-z])/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text|mathit|mathbf|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)(?![A-Za-z])/g," deg"],[/\\(?:cdot|times|ast)(?![A-Za-z])/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/\\d?t?frac\s*(\d)\s*(\d)/g,"(($1)/($2))"]],Ur=/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,Hr=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,Wr=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,et=new RegExp(String.raw`\s*(?:(${Hr})|(${Wr})|(\*\*|[-+*/^()]))`,"y"),Kr=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,Vr=/[cs]_?(?:\d|\{[\d+-]+\})+/g,Yr=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,G=e=>Yr.test(e);function A(e){if(G(e))return e;e=[...e].map(t=>Gr.get(t)??t).join("");for(let[t,n]of Zr)e=e.replace(t,n);for(let t="";t!==e;)[t,e]=[e,e.replace(Ur,"(($1)/($2))")];return e=e.replace(/\\([A-Za-z]+)/g," $1 "),e=e.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),e=e.replace(/(?<=\w)\s*\(t\)/g,""),e=e.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),e=e.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),e=e.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),e.replace(/[ \t]+/g," ").trim()}function N(e,t="the formula"){if(e.length>Xt)throw new f(`${t} has ${e.length} characters; expected at most ${Xt}`);let n=Xr(A(e));if(!n)throw new f(`${t} is ${M(e)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let r=Jr(n);if(r?.[1]!==n.length)throw new f(`${t} is ${M(e)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return r[0]}var O=class extends Error{};function Jr(e){try{return sn(e,0,0)}catch(t){if(t instanceof O)return null;throw t}}function Xr(e){let t=[];for(let n=0;n<e.length;n=et.lastIndex){et.lastIndex=n;let r=et.exec(e);if(!r)return null;let[,o,s,a]=r;if(o!==void 0)t.push(["num",o]);else if(a!==void 0)t.push(["sign",a==="**"?"^":a]);else for(let i of Kr.test(s)?s.match(Vr):[s])t.push(["name",i])}return t}function de(e,t){if(t>=e.length)throw new O;return e[t]}function sn(e,t,n){let[r,o]=en(e,t,n);for(;o<e.length&&["+","-"].includes(e[o][1]);){let[s,a]=en(e,o+1,n);[r,o]=[[e[o][1],r,s],a]}return[r,o]}function en(e,t,n){let[r,o]=X(e,t,n);for(;o<e.length;){let[s,a]=e[o];if(a==="*"||a==="/"){let[i,c]=X(e,o+1,n);[r,o]=[[a,r,i],c]}else if(a==="("||s!=="sign"){let[i,c]=an(e,o,n);[r,o]=[["*",r,i],c]}else break}return[r,o]}function X(e,t,n){if(n>tn)throw new O;let r=de(e,t)[1];if(r==="-"){let[o,s]=X(e,t+1,n+1);return[["neg",o],s]}return r==="+"?X(e,t+1,n+1):an(e,t,n)}function an(e,t,n){let[r,o]=tt(e,t,n);if(o>=e.length||e[o][1]!=="^")return[r,o];let[s,a]=X(e,o+1,n+1);return[["^",r,s],a]}function tt(e,t,n){let[r,o]=de(e,t);if(r==="num")return[["num",Number(o)],t+1];if(r==="name"&&Dr(o)&&t+1<e.length){let[i,c]=Qr(e,t+1,n+1);return[["call",o,i],c]}if(r==="name")return[["name",o],t+1];if(o!=="(")throw new O;let[s,a]=sn(e,t+1,n+1);if(de(e,a)[1]!==")")throw new O;return[s,a+1]}function Qr(e,t,n){if(n>tn)throw new O;if(de(e,t)[1]!=="-")return tt(e,t,n);let[r,o]=tt(e,t+1,n);return[["neg",r],o]}function L(e,t=new Set){for(let n=[e];n.length;){let[r,...o]=n.pop();r==="name"&&!on(o[0])&&t.add(o[0]),n.push(...o.filter(Array.isArray).reverse())}return t}function Z(e,t){let n=fe(e,t);if(!Number.isFinite(n))throw new f("a formula divides by zero or is too large; expected a finite value");return n}function fe(e,t){let n=[];for(;Object.hasOwn(Qt,e[0]);e=e[1])n.push(e);let r=eo(e,t);return n.reduceRight((o,[s,,a])=>Qt[s](o,fe(a,t)),r)}function eo([e,t,n],r){if(e==="num")return t;if(e==="neg")return-fe(t,r);if(e==="call")return nn[t](fe(n,r));let o=on(t)?rn[t]:r(t);if(o===void 0)throw new f(`no value for ${t}`);return o}function z(e){try{return Z(N(e),()=>{})}catch(t){if(t instanceof f)return null;throw t}}var at={};x(at,{cells:()=>I,withoutHeader:()=>ee});var to=/(?<![^\n])[ \t]*```[^\n\r]*/g,ln=String.raw`(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*`,no=new RegExp(ln+String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,"g"),ro=new RegExp(ln,"g"),oo=/((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*[#%][^\n\r]*/g,so=/^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[[({])/,ao=/^[ \t\r\n]*=[ \t]*(?=[[({])/,io=String.raw`\{(?:[A-Za-z]*matrix\*?|array|tabular)\}`,[co,lo]=["begin","end"].map(e=>new RegExp(String.raw`\\${e}${io}`,"g")),uo=new RegExp(String.raw`\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}`+String.raw`|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed|left[ \t]*[\[(|.]|\[|\()`+String.raw`|[$&{ \t\r\n]`,"g"),mo=/\\end\{[a-z]+\*?\}|\\label\{[^{}]*\}|\\(?:right[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]/g,cn=String.raw`(?:(?!\\[dt]?frac[0-9])[^-=0-9][^=]*=)+`,[po,fo]=[new RegExp(cn,"g"),new RegExp(`^${cn}$`)],ho=new RegExp(String.raw`^(?:\\(?:[dt]?frac|cdot|times|ast|sqrt|pi)|[-+*/^0-9.,(){}]`+String.raw`|(?<![A-Za-z])[A-Za-z](?:_[0-9A-Za-z])?(?![A-Za-z]))+$`),go=[[/\\[hv]?phantom\{[^{}]*\}/g," "],[/\\num\{([^{}]*)\}/g,"$1"],[/\{([-+])\}/g,"$1"],[/(?<=[0-9])\{,\}(?=[0-9])/g,"."]],un=e=>e.replaceAll("\uFEFF","").replace(to,"").replace(oo,"$1").replace(no,"").replace(ro,"").replace(so,"").replace(ao,"");function mn(e){let[t,n]=[co,lo].map(r=>[...e.matchAll(r)]);if(t.length===1&&n.length===1){let[r,o]=[t[0].index,n[0].index+n[0][0].length],s=e.slice(0,r).replace(uo,""),a=e.slice(o).replace(mo,"");he(e.slice(0,r),s.replace(po,"")),he(e.slice(o),a);let i=!s||fo.test(s);e=e.slice(i?r:0,a?e.length:o)}for(let[r,o]of go)e=e.replace(r,o);return e}function he(e,t){if(!ho.test(t))return;let n=M(e.trim());throw new f(`beside the matrix stands ${n}; expected entries that hold it`)}var pn=5e6,gn=String.raw`[\p{L}\p{N}_.]`,wo=String.raw`^\s*(?:${gn}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`,bo="Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym",dn=new RegExp(String.raw`${wo}(?:${gn}*(?:${bo})\s*\(\s*)+`,"u"),xo=/\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u,yo=/^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u,vo=/\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g,$o=/\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|(?:top|mid|bottom)rule|nonumber)(?![A-Za-z])/g,fn=/(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/,jo=/^[-+*/^.0-9e \t]+(?=\[)/,hn=/^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m,Ao=/^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im,Eo=/^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/,wn=e=>{let t=e.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);return t.at(-1)===""&&t.pop(),t},rt=(e,t)=>{let[n,r]=[0,e.length];for(;n<r&&t.includes(e[n]);)n++;for(;r>n&&t.includes(e[r-1]);)r--;return e.slice(n,r)},Q=(e,t)=>{let n=e.length;for(;n>0&&t.includes(e[n-1]);)n--;return e.slice(0,n)};function I(e){if(e.length>pn)throw new f(`the text has ${e.length} characters; expected at most ${pn}`);let t=So(rt(un(e).trim(),"`$").trim()).filter(n=>n.some(r=>r.trim())).map(n=>n.map(r=>r.trim()));if(!t.length)throw new f("the text is empty; expected rows of numbers or formulas");return t}function So(e){if(e.includes("\\begin{")||e.includes("\\\\"))return Mo(e);if(e.split("|").length>2&&!/^[^|]*\[[^\]|]*\|/.test(e))return Oo(e);let t=dn.test(e)?e.replace(dn,"").replace(xo,""):e;if(t=Q(t.replace(yo,"").trim(),";").trim(),t&&"[({".includes(t[0]))return bn(t);let n=jo.exec(t);return n&&he(n[0],n[0].replace(/[ \t]/g,"")),Ro(t)}function Mo(e){return e=mn(e).replace(/\\left\s*[[(.|]\s*(?=\\begin)/g," ").replace(vo," ").replace($o," ").replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u,"").replace(/\\\\\s*\[[^\]]*\]/g,"\\\\").replaceAll("$"," ").replaceAll("\\["," ").replaceAll("\\]"," "),e.split(/\\\\|\\cr(?![A-Za-z])/).map(t=>t.split("&"))}var Oo=e=>wn(e).map(t=>t.trim()).filter(t=>t.includes("|")&&!/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(t)).map(t=>t.replace(/^\||\|$/g,"").replaceAll("$"," ").split("|"));function bn(e){let t=ge(e);if(t.every(U)){let r=t.map(ge);if(!r.some(a=>a.some(U)))return r;let o=a=>U(a)&&ge(a).length===1?ge(a)[0]:a,s=r.map(a=>a.map(o));return s.some(a=>a.some(U))?t.flatMap(bn):s}let n=e.trim().slice(1,-1);return U(e)&&!n.includes("[")?n.replace(/\.\.\.[^\n]*\n/g," ").split(/[;\n]/).map(we):[t]}function U(e){return e=e.trim(),!e||!"[({".includes(e[0])||!No(e)?!1:e[0]!=="("||st(e.slice(1,-1))}var ot=e=>"[({".includes(e)?1:"])}".includes(e)?-1:0;function No(e){let t=0;for(let n=0;n<e.length;n++)if(t+=ot(e[n]),!t)return n===e.length-1;return!1}function st(e){let t=0;for(let n=0;n<e.length;n++)if(t+=ot(e[n]),e[n]===","&&!t)return!0;return!1}function ge(e){return e=Q(e.trim(),","),we(U(e)?e.slice(1,-1):e)}function we(e){let t=e.trim().split(/\s+/);if(t.every(G))return t;let n=[],[r,o]=[0,""],s=st(e);for(let a=0;a<e.length;a++){let i=e[a];r+=ot(i),(s?i===",":/\s/.test(i)&&!To(e,a))&&!r?(n.push(o),o=""):o+=i,!s&&!r&&i==="]"&&(n.push(o),o="")}return n.push(o),n.filter(a=>a.trim()).map(a=>rt(a.trim(),`'"`))}function To(e,t){let[n,r]=[e.slice(0,t).trimEnd(),e.slice(t).trim()];return r==="*"?fn.test(`${n}*`):n.endsWith("*")&&r&&!"*/^)=".includes(r[0])&&fn.test(n)?!1:!n||!r||"+-*/^=(".includes(n.at(-1))||"*/^)=".includes(r[0])?!0:"+-".includes(r[0])&&r.length>1&&/\s/.test(r[1])||r.startsWith("deg")||r[0]==="°"}function Ro(e){let t=hn.exec(e);e=e.replace(new RegExp(hn,"gm"),"");let n=e.split(Ao).map(ko).filter(s=>s.length),r=[...new Set(n.map(s=>s.length))].sort((s,a)=>s-a);if(r.length>1)throw new f(`the blocks of columns have ${r.join(", ")} rows; expected as many in each`);let o=(n[0]??[]).map((s,a)=>n.flatMap(i=>i[a]));return t?o.map(s=>s.map(a=>z(a)?`${a}*${t[1]}`:a)):o}function ko(e){let t=wn(e).filter(o=>o.trim()&&!Eo.test(o)).filter(o=>!/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(o)),n=o=>t.some(s=>Q(s.trim(),";").includes(o)),r=["	",";"].find(n);if(r){let o=s=>Q(rt(s,`\r
 `),r);return t.map(s=>o(s).split(r).map(Lo))}return t.some(st)?_o(t):t.map(o=>we(o.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g,"")))}function _o(e){let t=e.every(n=>/^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(n));return e.map(n=>we(t?n.replaceAll(",","."):Q(n,",")))}function Lo(e){let t=e.trim();return t[0]==='"'&&t.at(-1)==='"'&&(e=t.slice(1,-1)),e=e.replace(/^[ \t]*=/,""),e.split(",").length===2&&!e.includes("(")?e.replace(/(?<=\d),(?=\d)/g,"."):e}var zo=e=>e.every(t=>t.every(n=>z(n)!==null));function ee(e){let[t,...n]=e,r=t.map(A).filter(Boolean);return n.length>0&&r.every(s=>z(s)===null)&&zo(n)?n:e}var Io=/^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/,xn=/^([cs])((?:[+-]?\d)+)$/i,Fo=/^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/,it=e=>b(e).map(t=>t+1),ne=e=>b(e).map(t=>e.rows[t].kind==="revolute"),ct=e=>it(e).map(t=>`q_${t}`);function lt(e,t,n=[]){let r=[];return{known:s=>{let[a,i]=qo([...s].sort(),e,t,n);for(let c of i)r.includes(c)||r.push(c);return a},said:r}}var Co=e=>{if(e.size)throw new f(y("symbols for numbers",{names:[...e].sort().join(", ")}));return new Map};function yn(e,t,n=Co,r="numbers"){if(typeof e=="string")return Po(e,t,n);let o=vn(e),s=e.flat(1/0);if(!s.every(Number.isFinite))throw new f(y("not finite",{what:t,wanted:r}));return{values:s,units:J(s.map(D)),shape:o,symbolic:!1}}var vn=e=>Array.isArray(e)?[e.length,...e.length?vn(e[0]):[]]:[];function Po(e,t,n){let r=ee(I(e)),o=[...new Set(r.map(p=>p.length))].sort((p,w)=>p-w);if(o.length>1)throw new f(y("ragged",{what:t,widths:o.join(", ")}));let s=r.flat().map(A),a=s.map(p=>G(p)?["num",Number(p)]:N(p,`an entry of ${t}`)),i=new Set;for(let p of a)L(p,i);let c=n(i),l=a.map(p=>Z(p,w=>c.get(w))),u=s.map(Do),d=J(u.map(([p])=>p)).map((p,w)=>p*u[w][1]),h=a.map((p,w)=>u[w][1]===1?p:["num",l[w]]);return{values:l,units:d,shape:[r.length,o[0]],symbolic:i.size>0,trees:h}}function Do(e){let t=Fo.exec(e);return t?[t[1],Number(t[2])]:[e,1]}var ut=e=>`one value for each of ${ct(e).join(", ")}`;function mt(e,t,n="rad"){let r=yn(e,`${t.name}: q`,void 0,ut(t)),o=typeof e=="string"?[r.values.length]:r.shape,s=b(t).length;if(o.length!==1||o[0]!==s)throw new f($n(t,o,`one pose, (${s},)`));return pt(r,t,n)}function $n(e,t,n){let r=_e(t);return`${e.name}: q has shape ${r}; expected ${n}, ${ut(e)}`}function pt(e,t,n){let r=ne(t),o=s=>n==="deg"&&r[s%r.length]?$:1;return{...e,values:e.values.map((s,a)=>s*o(a)),units:e.units.map((s,a)=>s*o(a))}}function Bo(e,t){let n=ne(t),r=n.some(Boolean)&&!n.every(Boolean),o=r?J(e.flatMap(({values:i})=>i.filter((c,l)=>n[l])).map(D)):[],s=0,a=(i,c)=>{if(!r||!n[c])return i;let l=o[s++];return i>0?Math.max(l,i):i};return e.map(i=>pt({...i,units:i.units.map(a)},t,"deg"))}var te=e=>e.replace(/\(t\)|[_{}'*^\\ ]/g,"").replace(/[ϑθ]/g,"theta").toLowerCase();function qo(e,t,n,r){let o=new Map([...t.values??[],...r]),s=new Map([...o].map(([u,d])=>[te(u),d])),a=new Map(e.filter(u=>s.has(te(u))).map(u=>[u,s.get(te(u))])),i=new Map(e.filter(u=>!a.has(u)).map(u=>[u,Go(u)])),[c,l]=Zo([...new Set([...i.values()].flatMap(u=>u??[]))],t);for(let[u,d]of i){let h=(d??[]).map(p=>c.get(p));if(!h.length||h.includes(void 0)){let p=[...ct(t),...(t.values??[]).map(([w])=>w)].join(", ");throw new f(y("unknown symbol",{arm:t.name,name:u,known:p}))}a.set(u,Uo(te(u),h.map(p=>n[p])))}return[a,l]}function Go(e){let t=te(e),n=Io.exec(t);if(n)return[Number(n[2])];let r=xn.exec(t);return r?[...r[2].matchAll(/\d/g)].map(Number):null}function Zo(e,t){let n=it(t),r=new Map(n.map((a,i)=>[a,i])),o=a=>e.every(i=>i>=a&&i<a+n.length);if(e.every(a=>r.has(a)))return[r,[]];let s=a=>new Map(n.map((i,c)=>[c+a,c]));return o(1)?[s(1),[y("taken: counted on",{joints:n.join(", ")})]]:o(0)?[s(0),[y("taken: from zero",{joints:n.join(", ")})]]:[r,[]]}function Uo(e,t){let n=xn.exec(e);if(!n)return t[0];let r=[...n[2].matchAll(/([+-]?)\d/g)].map(([,s])=>s==="-"?-1:1),o=t.reduce((s,a,i)=>s+r[i]*a,0);return e[0]==="c"?Math.cos(o):Math.sin(o)}var ft={};x(ft,{ownValues:()=>be,valuesCall:()=>Vo});var Ho=/^\s*(?:values\s*=\s*)?(?:dict\s*\(([^]*)\)|\{([^]*)\})\s*$/,Wo=/^\s*(["']?)(.+?)\1\s*[=:]\s*([^=:]+?)\s*$/s,Ko=/^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;function be(e){let[,t,n]=Ho.exec(e)??[];return(t??n??e).split(/[,;\n]/).filter(o=>o.trim()).map(o=>{let[,,s,a]=Wo.exec(o)??[],[i,c]=s?[A(s),z(a)]:["",null];if(c!==null&&Ko.test(i))return[i,c];throw new f(`your own symbols: ${M(o.trim())} is not read; expected such as h = 0.333`)})}function Vo(e){let t=be(e).map(([n,r])=>`"${n}": ${D(r)}`);return t.length?[`values={${t.join(", ")}}`]:[]}var wt={};x(wt,{checkerOf:()=>ye,load:()=>re,ready:()=>gt,register:()=>Jo});var ht=new Map,xe=new Map,Yo=typeof document>"u"?null:document.currentScript?.src,Jo=(e,t)=>{ht.set(e,t)},ye=e=>ht.get(e),gt=e=>ht.has(e)?Promise.resolve():re(v[e].script);function re(e){return xe.has(e)||xe.set(e,Xo(e)),xe.get(e)}function Xo(e){return new Promise((t,n)=>{let r=()=>{xe.delete(e),n(new Error(`The script judge-${e}.js could not be loaded.`))},o=new URL(`judge-${e}.js`,Yo).href;document.head.append(Object.assign(document.createElement("script"),{src:o,onload:()=>t(),onerror:r}))})}var jn=12e3,Qo={table:2e3,q:500,wrench:300,values:500,answer:8e3,target:1e3},An=2e4,es="the arm asked about",T="own",H=["rad","deg"],bt={unit:H,first:["v","omega"],plane:["zy","yz","zx","xz"],pace:["even","rest"],lengths:["","m","cm","mm"],angles:["",...H],convention:["","standard","craig"]},W={ask:"jacobian",arm:"",table:"",q:"",unit:"rad",frame:"0",first:"v",wrench:"",values:"",answer:"",columns:"",lengths:"",angles:"",convention:"",target:"",radius:"0.1",plane:"zy",period:"5",steps:"",pace:"even"};function xt(e){let t=Object.entries(e).filter(([n,r])=>r!==W[n]||n==="ask"||n==="arm");return`#${new URLSearchParams(t)}`}function yt(e,t){let n=e.replace(/^#/,"");if(!/^ask=/.test(n))return{question:null,words:""};let r=i=>({question:null,words:`The link could not be read: ${i}.`});if(n.length>jn)return r(`it has ${n.length} characters; ${jn} are the most`);let o=new URLSearchParams(n),s={...W};for(let[i,c]of o){if(!Object.hasOwn(W,i))return r(`it has a field “${i.slice(0,40)}”`);if(c.length>(Qo[i]??40))return r(`its ${i} is too long`);s[i]=c}if(!Object.hasOwn(v,s.ask))return r("it asks what is not judged here");if(s.arm!==T&&!t.includes(s.arm))return r(`there is no arm called “${s.arm}” here`);let a=Object.keys(bt).find(i=>!bt[i].includes(s[i]));return a?r(`its ${a} is none`):/^\d{1,2}$/.test(s.frame)?{question:s,words:""}:r("its frame is none")}function vt(e,t){if(e.arm!==T)return t.find(({key:s})=>s===e.arm);if(!e.table.trim())throw new f("Type the table of your arm: a row for each joint, a α d θ.");let n=new Map(v[e.ask].fields.includes("values")?be(e.values):[]),r=I(e.table).filter((s,a)=>a||!s.some(i=>/^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(i))).map((s,a)=>rs(s.length===5?s.slice(1):s,a+1,e.unit,n)),o=Ze(r);if(o)throw new f(`${o}.`);return{...Ue(r,{name:"",home:[],rows:[]}),name:es}}var ts=["a","alpha","d","theta"],ns=/^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;function rs(e,t,n,r){if(e.length!==4)throw new f(`Row ${t} of the table has ${e.length} entries; expected four: a α d θ.`);let o=e.map((d,h)=>N(d||"0",`row ${t}, ${ts[h]}`)),s=o.map(d=>[...L(d)].filter(h=>!r.has(h))),a=s.flatMap((d,h)=>d.filter(p=>h<2||!ns.test(p)));if(a.length)throw new f(`Row ${t} of the table: no value for ${a[0]}; write numbers, and a variable such as q1.`);let[i,c,l,u]=o.map((d,h)=>{let p=n==="deg"&&h%2&&!/deg|°|pi|π/.test(e[h]);return Z(d,w=>r.get(w)??0)*(p?$:1)});return{kind:s[2].length?"prismatic":"revolute",a:i,alpha:c,d:l,theta:u}}function $t(e,t){let n,r;try{n=vt(e,t);let o=os(e,n);if(o)return{error:o,arm:n};if(r=En(e)?mt(e.q,n,e.unit).values:void 0,!e.answer.trim())return{error:"Type or paste your answer.",arm:n,q:r};let s=v[e.ask].longest??An;if(e.answer.length>s)return{error:`The answer is longer than ${s} characters.`,arm:n,q:r};let a=ye(e.ask);return a?{report:a.verdict(e,n),arm:n,q:r}:{error:"The checker is being loaded.",waiting:!0,arm:n,q:r}}catch(o){if(o instanceof f)return{error:ss(o.message),arm:n,q:r};throw o}}var En=({ask:e})=>v[e].fields.includes("q"),os=(e,t)=>En(e)&&!e.q.trim()?`Type the pose: ${b(t).length} joint values.`:null,ss=e=>e.slice(0,1).toUpperCase()+e.slice(1);function as(e,t){let n=vt(e,t),[r,o]=e.arm===T?["arm",cs(n)]:[n.python,is(n.python)],{call:s,imports:a=[]}=ye(e.ask),i=[...o,...a,"from helpers import checks",""];return e.arm===T&&i.push(...ls(n),""),i.push(`mine = ${Le(e.answer)}`,`print(${s(e,r,n)})`),`${i.join(`
`)}
`}var is=e=>[`from helpers.robots import ${/^\w+/.exec(e)[0]}`],Sn={revolute:"revolute",prismatic:"prismatic",fixed:"fixed"},cs=e=>[`from helpers.arm import Arm, ${[...new Set(e.rows.map(({kind:t})=>Sn[t]))].sort().join(", ")}`],ls=e=>["rows = [",...e.rows.map(({kind:t,a:n,alpha:r,d:o,theta:s})=>`    ${Sn[t]}(a=${n}, alpha=${r}, d=${o}, theta=${s}),`),"]",`arm = Arm("${e.name}", rows)`];var St={};x(St,{MARKS:()=>Et,better:()=>ys,both:()=>Mn,cause:()=>ps,complete:()=>bs,explain:()=>hs,explainAll:()=>Nn,linesOf:()=>ve,nameOf:()=>ds,several:()=>xs,textOf:()=>vs,wordsOf:()=>On});var us=.6,ms=.85,At=.7,ps=(e,t={})=>({keys:[e],fields:[t]}),Mn=(e,t)=>({keys:[...e.keys,...t.keys],fields:[...e.fields,...t.fields]}),ds=({keys:e,fields:t})=>e.map((n,r)=>fs(n,t[r])).join(" + ");function fs(e,t){if("_of"in t)return t._of;let n=Object.entries(t).filter(([r])=>!r.startsWith("_"));return[e,...n.map(([,r])=>r)].join(":")}function On({keys:e,fields:t}){let[n,r]=e.map((o,s)=>y(o,t[s]));return r===void 0?n:y("and also",{first:n,second:ce(r)})}var hs=(e,t,n,r,o,s=At)=>Nn(e,t,[n],r.map((a,i)=>[[a],o[i]]),s)[0];function Nn(e,t,n,r,o=At){let s=n.map(a=>{let i=e.filter((l,u)=>Math.abs(l-t[u])>a[u]).length,c=[Math.max(3,us*i),Math.max(4,ms*i)];return{band:a,count:i,least:c,named:[]}});for(let[a,i]of r){let c=a.length>1?2:a[0].keys.length;for(let{band:l,count:u,least:d,named:h}of s){let p=gs(e,i,l,u,d[c-1]);(p?u-p>=d[c-1]:u>0)&&h.push({cost:c+o*p,parts:a,A:i})}}return s.map(a=>ws(e,a))}function gs(e,t,n,r,o){let s=0;for(let a=0;a<e.length;a++)if(!(Math.abs(e[a]-t[a])<=n[a])&&(s++,r-s<o))return s;return s}function ws(e,{band:t,named:n}){if(!n.length)return null;let r=Math.min(...n.map(({cost:c})=>c)),o=n.filter(({cost:c})=>c===r),s=o.map(({parts:c})=>c.reduce(Mn)),[{A:a}]=o,i=e.map((c,l)=>c-a[l]);return{causes:s,odd:i.map((c,l)=>!(Math.abs(c)<=t[l])),rest:i}}var bs=e=>!!e&&!e.odd.includes(!0);function xs(e,t=3){let n=[...new Set(e.map(On))].slice(0,e[0].keys.length===1?t:1);return n.length===1?n[0]:y("or",{first:n[0],others:ke(n.slice(1).map(ce),"or")})}function ys(e,t=At){let n=r=>r.causes[0].keys.length+t*r.odd.filter(Boolean).length;return e.filter(Boolean).reduce((r,o)=>r&&n(r)<=n(o)?r:o,null)}var Et={[me]:"✔",[Y]:"◐",[pe]:"≈",wrong:"✘"},ve=({headline:e,findings:t,taken:n,notes:r})=>[...t.filter(({what:o,words:s})=>o!=="cause"&&!e.includes(s.slice(1))).map(({words:o})=>o),...n.map(o=>`Taken as ${o}`),...r.map(o=>`Note: ${o}`)],vs=e=>[e.headline,...ve(e).map(t=>`- ${t}`)].join(`
`);var _t={};x(_t,{matrixOf:()=>Cn,namesOf:()=>Nt,showRead:()=>Tt,tell:()=>kt,typeset:()=>se});var $s="http://www.w3.org/1998/Math/MathML",[Mt,R,kn,F]=[1,2,3,4],[js,As]=["⁡","⁢"],Es={alpha:"α",beta:"β",gamma:"γ",delta:"δ",theta:"θ",th:"θ",phi:"φ",psi:"ψ",omega:"ω",lambda:"λ",pi:"π",inf:"∞"},Ss={asin:"arcsin",acos:"arccos",atan:"arctan",sind:"sin",cosd:"cos"},Ms=/^(?:[Ff]loat|Integer|float64|float32|int64)$/,Os=/^(?:radians|deg2rad)$/,C=e=>["mo",e],k=e=>e.length===1?e[0]:["mrow",e],Tn={stretchy:"false",lspace:"0",rspace:"0"},_n=(e,t="(",n=")")=>k([["mo",t,{form:"prefix",...Tn}],...e,["mo",n,{form:"postfix",...Tn}]]),$e=e=>["math",[k(E(e).pieces)],{displaystyle:"true"}];function oe([e,t,n={}]){let r=document.createElementNS($s,e);for(let[o,s]of Object.entries(n))r.setAttribute(o,s);return r.append(...typeof t=="string"?[t]:t.map(oe)),r}var je=([e,t])=>e==="num"||e==="neg"&&t[0]==="num";function E(e){let[t,n,r]=e;if(t==="num")return Ns(n);if(t==="name")return{level:F,pieces:[Ts(n)]};if(t==="call")return Rs(n,r);if(t==="^")return{level:kn,pieces:[["msup",[k(P(n,F)),k(E(r).pieces)]]]};if(t==="/"&&n[0]==="neg")return Rn(["neg",["/",n[1],r]]);if(t==="/"){let o=[n,r].map(s=>k(E(s).pieces));return{level:R,pieces:[["mfrac",o]]}}return t==="*"?ks(e):Rn(e)}function P(e,t){let{level:n,pieces:r}=E(e);return n<t?[_n(r)]:r}function Ns(e){let[t,n]=String(Math.abs(e)).split("e"),r=[["mn",t]];if(n){let o=k([...n[0]==="-"?[C("−")]:[],["mn",n.replace(/^[+-]/,"")]]);r.push(C("⋅"),["msup",[["mn","10"],o]])}return e<0?{level:Mt,pieces:[C("−"),...r]}:{level:n?R:F,pieces:r}}function Ts(e){let[,t,n,r]=/^([A-Za-z]+)_?(.*?)('?)$/.exec(e.replace(/[{}]/g,""));if(t==="deg"&&!n)return["mi","°"];let o=["mi",(Es[t]??t)+r.replace("'","′")],a=(n.match(/\d+|[A-Za-z_]+|[+-]/g)??[]).map(i=>[/\d/.test(i)?"mn":/\w/.test(i)?"mi":"mo",i.replace("-","−")]);return a.length?["msub",[o,k(a)]]:o}function Rs(e,t){if(Ms.test(e))return E(t);if(e==="sqrt")return{level:F,pieces:[["msqrt",[k(E(t).pieces)]]]};if(e==="abs")return{level:F,pieces:[_n(E(t).pieces,"|","|")]};if(Os.test(e))return{level:R,pieces:[...P(t,F),["mi","°"]]};let n=e.endsWith("d")?[["mi","°"]]:[],r=P(t,F),s=r[0][0]==="mrow"?r:[["mspace","",{width:"0.17em"}],...r];return{level:kn,pieces:[["mi",Ss[e]??e],C(js),...s,...n]}}function ks(e){let t=zn(e,["*"]).map(([,o])=>o),n=t[0][0]==="neg"||t[0][0]==="num"&&t[0][1]<0,r=n?E(t[0]).pieces:P(t[0],R);return t.slice(1).forEach((o,s)=>{o[0]==="name"&&o[1]==="deg"||r.push(C(_s(t[s],o)?"⋅":As)),r.push(...P(o,R))}),{level:n?Mt:R,pieces:r}}var _s=(e,t)=>Ln(t)||e[0]==="call"&&t[0]!=="call"&&e[1]!=="sqrt"&&e[1]!=="abs",Ln=([e,t])=>e==="num"||["^","*"].includes(e)&&Ln(t);function Rn(e){let t=[];for(let[n,r]of zn(e,["+","-"]))n&&t.push(C(n==="-"?"−":"+")),n?t.push(...P(r,R)):r[0]==="neg"?t.push(C("−"),...P(r[1],R)):t.push(...E(r).pieces);return{level:Mt,pieces:t}}function zn(e,t){let n=[];for(;t.includes(e[0]);)n.push([e[0],e[2]]),e=e[1];return[["",e],...n.reverse()]}var Ls={v:["vx","vy","vz","ωx","ωy","ωz"],omega:["ωx","ωy","ωz","vx","vy","vz"]},zs=["a (m)","α","d (m)","θ"],Ot=40,Fn=8e3;function Nt({ask:e,first:t},n,[r,o]){let s=b(n).map(c=>c+1),a=c=>s.length===o?`joint ${s[c]}`:String(c+1),i={torques:r===1?["τ"]:[],jacobian:r===6?Ls[t]:[]}[e]??[];return{columns:Array.from({length:o},(c,l)=>a(l)),rows:Array.from({length:r},(c,l)=>i[l]??`row ${l+1}`)}}function Cn(e,{report:t,arm:n}){let r=t?.typed;if(!r||r.shape.length!==2)return null;let o=e.ask==="torques"&&r.shape[1]===1,[s,a]=o?[1,r.values.length]:r.shape,i=t.wrong?.length===r.values.length?t.wrong:[];return{...Nt(e,n,[s,a]),typed:r,wrong:i,shape:[s,a]}}function Tt(e,t,n){let r=Is(t,n);if(e.hidden=!r,!r)return;let{columns:o,rows:s,cell:a,unread:i=0}=r,c=m("tr",{},m("td"),o.map(w=>m("th",{scope:"col"},w))),l=s.slice(0,Ot).map((w,ae)=>m("tr",{},m("th",{scope:"row"},w),o.map((ie,K)=>a(ae,K)))),u=s.length>Ot?`, its first ${Ot} of ${s.length} rows`:"",d=i?`; ${i===1?"1 entry":`${i} entries`} could not be`:"",h=m("caption",{},`How your answer is read${u}${d}`),p=t.ask==="table"?"table.read":"table.read.matrix";e.replaceChildren(m(p,{},h,m("thead",{},c),m("tbody",{},l)))}function Is(e,t){let{table:n}=t.report??{};return n?Fs(n):Cs(e,Cn(e,t))??Ps(e,t)}var Fs=({cells:e,trees:t,wrong:n})=>({columns:zs,rows:e.map((r,o)=>String(o+1)),cell(r,o){let[s,a]=[t[r][o],e[r][o]],i=/^-?q_\d+$/.test(a);return Ae(s&&!je(s)?Pn(s,i?"":a):Rt(a),n[r][o])}});function Cs({answer:e},t){if(!t)return null;let{typed:n,wrong:r,shape:o}=t,s=e.length>Fn?[]:n.trees??[];return{...t,cell(a,i){let c=a*o[1]+i,l=s[c];return!l||je(l)&&n.units[c]?Ae(Rt(In(n,c)),r[c]):Ae(Pn(l,je(l)?"":In(n,c)),r[c])}}}function Ps(e,{error:t,waiting:n,arm:r,q:o}){let{ask:s,answer:a}=e;if(!t||n||!r||!a.trim()||s==="trace"||a.length>Fn)return null;let i=Ds(s,a).map(l=>l.map(u=>Bs(s,u,r,o))),c=Math.max(0,...i.map(l=>l.length));return{...Nt(e,r,[i.length,c]),unread:i.flat().filter(({tree:l})=>!l).length,cell(l,u){let{tree:d,text:h}=i[l][u]??{};return h===void 0?m("td"):d?m("td",{},oe($e(d))):Ae(h,!0,"not read: ")}}}function Ds(e,t){try{let n=ee(I(t));return e==="table"&&!n[0].some(r=>/\d/.test(r))?n.slice(1):n}catch(n){if(n instanceof f)return[];throw n}}function Bs(e,t,n,r){let o=e==="branches"||e==="pose";try{let s=N(A(o?t.replace(/^.*[=:]/,""):t).replace(/\*+$/,"")||"0");return e==="jacobian"&&r&&lt(n,r).known(L(s)),{tree:s,text:t}}catch(s){if(s instanceof f)return{tree:null,text:t};throw s}}function In({values:e,units:t},n){let r=Math.min(6,t[n]?Math.max(0,Math.round(-Math.log10(t[n]))):4);return(Number(e[n].toFixed(r))+0).toFixed(r)}var Rt=e=>se(e.replaceAll("-","−")),Pn=(e,t)=>t?[oe($e(e)),m("span.value",{},"= ",Rt(t))]:[oe($e(e))],Ae=(e,t,n="wrong: ")=>t?m("td.off",{},m("span.unseen",{},n),e):m("td",{},e);function kt(e,{report:t,error:n}){if(e.className=`verdict ${t?.grade??""}`,!t)return e.replaceChildren(m("p",{},se(n)));let r=ve(t).filter(a=>!t.headline.endsWith(a.slice(1))),o=r.length?[m("ul",{},r.map(a=>m("li",{},se(a))))]:[],s=m("span",{"aria-hidden":"true"},`${Et[t.grade]} `);return e.replaceChildren(m("p.headline",{},s,se(t.headline)),...o)}var qs=/(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g,Gs={theta:"θ",alpha:"α"};function se(e){let t=[],n=0;for(let r of e.matchAll(qs)){let[o,s,a,i]=r;t.push(e.slice(n,r.index),m("i",{},Gs[s]??s)),t.push(m("sub",{},(a??i).replace("-","−"))),n=r.index+o.length}return[...t,e.slice(n)]}var Dn={"arm.js":He,"dom.js":We,"kinematics.js":De,"judge/ask.js":jt,"judge/digits.js":Qe,"judge/door.js":dt,"judge/formula.js":nt,"judge/grid.js":at,"judge/judges.js":Ie,"judge/own_values.js":ft,"judge/ranking.js":St,"judge/registry.js":wt,"judge/say.js":ze,"judge/shown.js":_t};var Bn=e=>[["","as it looks"],...e.map(t=>[t,t])],qn={spellcheck:"false",autocomplete:"off",autocapitalize:"off"},Zn={table:{label:"Table",rows:6,whole:!0,hint:"A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen."},q:{label:"Pose q",hint:"",whole:!0},unit:{label:"Angles in",choices:H.map(e=>[e,e])},frame:{label:"Rows in the axes of",choices:[]},first:{label:"Order of the rows",choices:[["v","v, then ω"],["omega","ω, then v"]]},wrench:{label:"Wrench on the tool, by the world",whole:!0,hint:"Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down."},columns:{label:"Order of the columns",hint:"As in “theta d a alpha”; guessed where it is empty."},lengths:{label:"Lengths in",choices:Bn(["m","cm","mm"])},angles:{label:"Angles in",choices:Bn(H)},convention:{label:"Convention",choices:[["","as it looks"],["standard","standard"],["craig","modified (Craig)"]]},target:{label:"Where the tip should be",rows:4,whole:!0,hint:"A point x, y, z in m, or a pose: its three or four rows, in base axes."},radius:{label:"Radius of the circle below the tip, in m"},plane:{label:"Its plane",choices:[["zy","towards +y first"],["yz","towards −y"],["zx","towards +x"],["xz","towards −x"]]},period:{label:"Time for it, in s"},steps:{label:"Steps",hint:"Empty: as many as your answer has."},pace:{label:"Pace",choices:[["even","even"],["rest","from rest to rest"]]},values:{label:"Your own symbols",whole:!0,hint:"Numbers for those that the arm does not have, in m and rad, as in “h = 0.333, l = 0.1”."},answer:{label:"Your answer",hint:"",rows:8,whole:!0}},Zs={jacobian:"Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",table:"A row for each link, with heads or without: lists, Link(…) lines, MATLAB, LaTeX, Markdown, CSV or cells.",branches:"A row for each answer, angles in the joints' order; names such as theta1 = may stand before them.",pose:"One value for each joint, in the joints' order; names such as theta1 = may stand before them.",trace:"A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",torques:"One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet."},Us="Pose q at which the circle begins",Hs=["frame","first","values","columns","lengths","angles","convention"],Un=([e,t])=>m("option",{value:e},t);function Ws({choices:e,rows:t,hint:n},r,o){let s=n===void 0?{}:{"aria-describedby":[`${r}-hint`,...o].join(" ")},a={id:r,...s};return e?m("select",a,e.map(Un)):t?m("textarea",{rows:t,wrap:"off",...qn,...a}):m("input",{...qn,...a})}function Ks(e,t,n){let r=m("label",{for:t},e.label),o=e.hint===void 0?[]:[m("p.about",{id:`${t}-hint`},e.hint)];return m(e.whole?"div.field.whole":"div.field",{},r,n,...o)}function Hn(e,t,n){let r={ask:{label:"Question",choices:Object.entries(v).map(([l,{title:u}])=>[l,u])},arm:{label:"Arm",choices:[...t.map(({key:l,title:u})=>[l,u]),...t.length>1&&n?[]:[[T,"My own table"]]]},...Zn},o=l=>`${e}-${l}`,s=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Ws(u,o(l),l==="answer"?[o("private")]:[])])),a=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Ks(u,o(l),s[l])]));for(let l of n?Vs(n,t):[])a[l]?.classList.add("given");let i=n?Ys(n,t):"";return n&&(s.answer.rows=6),{form:m("form",{"aria-label":`Check an answer${i&&`: ${i}`}`},i?m("p.asked",{},"Judged here: ",i):[],Object.values(a)),fields:s,boxes:a}}var Vs=(e,t)=>[...Object.keys(e),...Hs,...t.length<2?["arm"]:[],..."q"in e?["unit"]:[]];function Ys({ask:e,q:t,wrench:n},r){let o=r.length===1?`, ${r[0].title}`:"";return[`${v[e].title}${o}`,t&&`q = (${t})`,n&&`wrench (${n})`].filter(Boolean).join(", ")}function Wn({fields:e,boxes:t},n,r){let o=new Set(["ask","arm","answer",...v[n.ask].fields]);n.arm===T&&o.add("table");for(let[i,c]of Object.entries(t))c.hidden=!o.has(i);Gn(t.answer,Zs[n.ask]??"");let s=r.find(({key:i})=>i===n.arm);q(t.q.querySelector("label"),n.ask==="trace"?Us:Zn.q.label),Gn(t.q,s?Js(s):"One value for each joint, in the table's order.");let a=s?s.rows.length:16;if(e.frame.options.length!==a+1){let i=l=>l?`frame ${l}`:"the base",c=Array.from({length:a+1},(l,u)=>Un([String(u),i(u)]));e.frame.replaceChildren(...c),e.frame.value=n.frame}}var Gn=(e,t)=>q(e.querySelector(".about"),t),Js=e=>`${b(e).map(n=>`q_${n+1}`).join(", ")}${ne(e).includes(!1)?"; m where a joint slides":""}`;var Xs=5e4,Kn=120,Qs=350,Vn="Nothing that you type leaves this page: a script in it judges, without a network too.",ea="It names the mistake and does not print the solution.",ta=0;function Yn(e){let{arms:t,examples:n=[],given:r}=JSON.parse(e.querySelector("script").textContent),o=`judge-${++ta}`,s=Hn(o,t,r),{form:a,fields:i}=s,c=na(o,r),l=[],u={...W,arm:t[0]?.key,...r??n[0]},d,h=0,p=!1,w=g=>u[g].length>Xs?"":u[g],ae=()=>{for(let[g,S]of Object.entries(i))S.value!==w(g)&&(S.value=w(g));Wn(s,u,t)},ie=g=>q(c.said,g),K=()=>kt(c.verdict,d),Ee=()=>Tt(c.taken,u,d),Se=()=>{Me(),K(),Ee()},Jn=()=>{Me(),K(),h=setTimeout(Ee)},Xn=()=>{Me(),Ee(),h=setTimeout(K,Qs-Kn)},Me=()=>{clearTimeout(h),p=!1,d=$t(u,t),d.waiting&&gt(u.ask).then(Se,({message:g})=>ie(g)),i.answer.setAttribute("aria-invalid",String(d.report?.grade==="wrong"));for(let g of l)g(u,d)},Oe=g=>{u={...u,...g},ae(),Se()};a.addEventListener("input",({target:g,inputType:S})=>{let _=Object.keys(i).find(Qn=>i[Qn]===g);_&&(u={...u,[_]:g.value},_==="arm"&&(u.frame="0"),(_==="arm"||_==="ask")&&(u.q=ra(u,n)?.q??u.q),ae(),p=!0,clearTimeout(h),S==="insertFromPaste"||S==="insertFromDrop"?Jn():h=setTimeout(Xn,Kn))}),a.addEventListener("submit",g=>g.preventDefault());let Lt=()=>{let{question:g,words:S}=yt(location.hash,t.map(({key:_})=>_));(g||S)&&e.scrollIntoView({block:"start"}),ie(S),g&&Oe(g)};return e.replaceChildren(a,...Object.values(c)),Oe({}),r||(addEventListener("hashchange",Lt),Lt()),{stub:e,arms:t,examples:n,given:r,...s,parts:c,...{question:()=>u,verdict:()=>(p&&Se(),d)},put:Oe,follow:g=>{l.push(g),g(u,d)},say:ie,links:{fragment:()=>xt(u),open:()=>!0}}}function na(e,t){return{verdict:m("div.verdict",{role:"status","aria-live":"polite","aria-atomic":"true"}),taken:m("div.scroll.taken",{role:"region",tabindex:"0","aria-label":"How your answer is read"}),tools:m("div.tools"),said:m("p.about",{role:"status"}),private:m("p.private",{id:`${e}-private`},t?Vn:`${Vn} ${ea}`)}}var ra=(e,t)=>t.find(n=>n.arm===e.arm&&n.ask===e.ask);document.head.append(Object.assign(document.createElement("style"),{textContent:It}));for(let e of document.querySelectorAll(".arm-judge"))V.push(Yn(e));if(V.some(({given:e})=>!e))re("page");else for(let{stub:e}of V)e.addEventListener("focusin",()=>re("page"),{once:!0});Re({"and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","unknown symbol":"{arm}: no value for {name}; known are {known}. Give values={'{name}': ...} if it is a length of yours","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what}: NaN or infinity stands among the numbers; expected {wanted}",ragged:"{what} has rows of {widths} entries; expected rows of one length",row:"row {row}","taken: counted on":"symbols numbered on past what does not move: 1, 2, 3 ... are joints {joints}","taken: from zero":"symbols numbered from 0: 0, 1, 2 ... are joints {joints}"});return or(oa);})();
