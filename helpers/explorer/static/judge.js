var ArmJudge=(()=>{var Oe=Object.defineProperty;var Xn=Object.getOwnPropertyDescriptor;var Qn=Object.getOwnPropertyNames;var er=Object.prototype.hasOwnProperty;var x=(e,t)=>{for(var n in t)Oe(e,n,{get:t[n],enumerable:!0})},tr=(e,t,n,r)=>{if(t&&typeof t=="object"||typeof t=="function")for(let o of Qn(t))!er.call(e,o)&&o!==n&&Oe(e,o,{get:()=>t[o],enumerable:!(r=Xn(t,o))||r.enumerable});return e};var nr=e=>tr(Oe({},"__esModule",{value:!0}),e);var Qs={};x(Qs,{kit:()=>Cn});var Le={};x(Le,{ArmError:()=>h,learn:()=>ke,listed:()=>Te,lower:()=>ce,quoted:()=>_e,say:()=>y,shown:()=>D,size:()=>or,spelled:()=>P,tuple:()=>Re});var Ne={},ke=e=>{Ne={...Ne,...e}};function y(e,t={}){let n=Ne[e];for(let[r,o]of Object.entries(t))n=n.replaceAll(`{${r}}`,()=>String(o));return n}var h=class extends Error{},Te=(e,t="and")=>e.length===1?e[0]:`${e.slice(0,-1).join(", ")} ${t} ${e.at(-1)}`,ce=e=>/^.(\p{Lu}|_)/su.test(e)?e:e.slice(0,1).toLowerCase()+e.slice(1),rr=9e6;function or(e,t=3){if(!Number.isFinite(e))return Number.isNaN(e)?"nan":e>0?"inf":"-inf";if(e===0)return"0";let[n,r]=sr(e,t).split("e"),o=Number(r),s=a=>a.includes(".")?a.replace(/\.?0+$/,""):a;return o>=t&&Math.abs(e)<rr?(+`${n}e${r}`).toFixed(0):o<-4||o>=t?`${s(n)}e${Lt(o)}`:s((+`${n}e${r}`).toFixed(Math.max(0,t-1-o)))}function sr(e,t){let n=e.toExponential(t-1),[r,o]=e.toExponential(t+25).split("e"),s=t===1?r.indexOf("."):r.indexOf(".")+t,a=r.slice(s).replace(".",""),i=r.slice(0,s);return/^50*$/.test(a)&&"02468".includes(i.at(-1))?`${i}e${o}`:n}var Lt=e=>`${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;function P(e){let[t,n]=e.toExponential().split("e"),r=Number(n);if(e!==0&&(r<-4||r>=16))return`${t}e${Lt(r)}`;let o=BigInt(Math.trunc(e)).toString();return r>20?o:String(e).includes("e")?e.toFixed(20).replace(/0+$/,""):String(e)}function D(e){let t=e.includes("'")&&!e.includes('"')?'"':"'",n={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},r=[...e].map(s=>n[s]??ar(s)).join(""),o=[...`${t}${r}${t}`];return o.length<=80?o.join(""):`${o.slice(0,77).join("")}...`}function ar(e){let t=e.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(e)||e===" "?e:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var Re=e=>e.length===1?`(${e[0]},)`:`(${e.join(", ")})`;function _e(e){return e.includes(`
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
`;var Ie={};x(Ie,{judges:()=>Y});var Y=[];var He={};x(He,{KINDS:()=>Ct,LARGEST:()=>Ge,LONGEST:()=>Be,MOST_ROWS:()=>De,TYPED:()=>Pt,carriedOver:()=>Gt,fits:()=>qt,homeOf:()=>xr,limited:()=>$r,outside:()=>vr,range:()=>yr,reachOf:()=>jr,rowsFault:()=>qe,sameRow:()=>Bt,typedArm:()=>Ue});var Pe={};x(Pe,{GRAVITY:()=>cr,cosSin:()=>ze,cross:()=>Ce,dot:()=>lr,gravityTorque:()=>fr,jacobianColumns:()=>dr,joints:()=>b,liftedEnergy:()=>hr,linkFrames:()=>mr,matrix:()=>pr,minus:()=>Fe,norm:()=>ur,plus:()=>le,scaled:()=>zt,wrenchTorque:()=>wr});var cr=9.81,lr=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],zt=(e,t)=>[e*t[0],e*t[1],e*t[2]],le=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],Fe=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],Ce=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],ur=e=>Math.sqrt(e.reduce((t,n)=>t+n*n,0)),B=(e,t,n,r)=>[e*t[0]+n*r[0],e*t[1]+n*r[1],e*t[2]+n*r[2]];function ze(e){let t=e/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(e),Math.sin(e)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var b=e=>e.rows.flatMap((t,n)=>t.kind==="fixed"?[]:[n]);function mr(e,t){let[n,r,o,s]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:n,y:r,z:o,o:s}],i=0;for(let c of e.rows){let l=c.kind==="fixed"?0:t[i++],[u,p]=ze(c.kind==="revolute"?c.theta+l:c.theta),[f,d]=ze(c.alpha),g=c.kind==="prismatic"?c.d+l:c.d;[n,r]=[B(u,n,p,r),B(u,r,-p,n)],s=le(B(g,o,c.a,n),s),[r,o]=[B(f,r,d,o),B(f,o,-d,r)],a.push({x:n,y:r,z:o,o:s})}return a}var pr=({x:e,y:t,z:n,o:r})=>[0,1,2].map(o=>[e[o],t[o],n[o],r[o]]).concat([[0,0,0,1]]);function dr(e,t,n=t.at(-1).o){return b(e).map(r=>{let{z:o,o:s}=t[r];return e.rows[r].kind==="revolute"?[...Ce(o,Fe(n,s)),...o]:[...o,0,0,0]})}function fr(e,t,n=9.81){let r=Ft(e,t);return b(e).map(o=>{let{z:s,o:a}=t[o],i=c=>e.rows[o].kind==="revolute"?Ce(s,Fe(c,a))[2]:s[2];return r.reduce((c,{mass:l,centre:u,row:p})=>c+(p<o?0:l*n*i(u)),0)})}var hr=(e,t,n=9.81)=>Ft(e,t).reduce((r,{mass:o,centre:s})=>r+o*n*s[2],0),Ft=(e,t)=>e.rows.flatMap((n,r)=>n.body?[gr(n.body,t[r+1],r)]:[]);function gr([e,...t],{x:n,y:r,z:o,o:s},a){return{mass:e,row:a,centre:le(s,le(B(t[0],n,t[1],r),zt(t[2],o)))}}var wr=(e,t)=>e.map(n=>n.reduce((r,o,s)=>r+o*t[s],0));var Ct=["revolute","prismatic","fixed"],De=16,Be=100,Ge=1e3,Pt="Your arm",Dt=[["a",Be],["alpha",Ge],["d",Be],["theta",Ge]];function qe(e){if(!Array.isArray(e)||!e.length)return"the table has no rows";if(e.length>De)return`the table has ${e.length} rows; ${De} are the most`;for(let[t,n]of e.entries()){if(!Ct.includes(n?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[r,o]of Dt){if(!Number.isFinite(n[r]))return`row ${t+1} has no number for ${r}`;if(Math.abs(n[r])>o)return`row ${t+1} has ${n[r]} for ${r}; ${o} is the most`}}return null}var br=({kind:e,a:t,alpha:n,d:r,theta:o})=>({kind:e,a:t,alpha:n,d:r,theta:o,lower:null,upper:null,speed:null,effort:null}),Bt=(e,t)=>e.kind===t.kind&&Dt.every(([n])=>Math.abs(e[n]-t[n])<1e-12);function Ue(e,t){if(e.length===t.rows.length&&e.every((r,o)=>Bt(r,t.rows[o])))return t;let n={name:Pt,home:[],rows:e.map(br)};return{...n,home:Gt(t,t.home,n,r=>r)}}function Gt(e,t,n,r){let o=new Map(b(e).map((s,a)=>[s,[e.rows[s].kind,t[a]??0]]));return b(n).map(s=>{let[a,i]=o.get(r(s))??[];return a===n.rows[s].kind?i:0})}var xr=e=>qt(e,e.home)?[...e.home]:b(e).map(()=>0),qt=(e,t)=>Array.isArray(t)&&t.length===b(e).length&&t.every(Number.isFinite);function yr(e){let t=e.kind==="revolute"?Math.PI:1;return[e.lower??-t,e.upper??t]}var vr=(e,t)=>t<(e.lower??-1/0)-1e-9||t>(e.upper??1/0)+1e-9,$r=e=>b(e).some(t=>e.rows[t].lower!==null||e.rows[t].upper!==null),jr=e=>e.rows.reduce((t,n)=>t+Math.abs(n.a)+Math.abs(n.d)+(n.kind==="prismatic"?Math.abs(n.upper??.3):0),0)||.3;var We={};x(We,{attribute:()=>Er,calm:()=>Or,h:()=>m,indexed:()=>Sr,svg:()=>Ar,whereNew:()=>Mr,write:()=>G});function m(e,t={},...n){let[r,...o]=e.split("."),s=document.createElement(r);o.length&&(s.className=o.join(" "));for(let[a,i]of Object.entries(t))a.startsWith("on")?s.addEventListener(a.slice(2),i):i!==void 0&&i!==!1&&s.setAttribute(a,i===!0?"":i);return s.append(...n.flat()),s}function Ar(e,t={},...n){let r=document.createElementNS("http://www.w3.org/2000/svg",e);for(let[o,s]of Object.entries(t))r.setAttribute(o,s);return r.append(...n),r}function G(e,t){e.textContent!==t&&(e.textContent=t)}function Er(e,t,n){e.getAttribute(t)!==n&&e.setAttribute(t,n)}function Mr(e,t){let n=[];return r=>{let o=e(r);n.length&&o.every((s,a)=>s===n[a])||(n=o,t(r))}}var Sr=(e,t)=>[m("i",{},e),m("sub",{},String(t))],Or=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var $t={};x($t,{ASKED:()=>v,CHOICES:()=>wt,EMPTY:()=>Z,LONGEST_ANSWER:()=>$n,OWN:()=>N,UNITS:()=>W,armOf:()=>yt,asPython:()=>ts,fromFragment:()=>xt,judge:()=>vt,toFragment:()=>bt});var $=Math.PI/180,Ze=180/Math.PI;var v={jacobian:{title:"Jacobian at a pose",fields:["q","unit","frame","first","values"],script:"jacobian"},torques:{title:"Joint torques at a pose",fields:["q","unit","wrench"],script:"jacobian"},table:{title:"Denavit-Hartenberg table",fields:["columns","lengths","angles","convention","values"],script:"table"},branches:{title:"All joint angles for a target",fields:["target","unit"],script:"motion"},pose:{title:"Joint angles for one pose",fields:["target","unit"],script:"motion"},trace:{title:"Joints along a circle",fields:["q","unit","radius","plane","period","steps","pace"],script:"motion",longest:5e6}};var pt={};x(pt,{eachJoint:()=>lt,inRadians:()=>mt,lookup:()=>ct,numbered:()=>at,numbers:()=>bn,pose:()=>ut,poseFault:()=>yn,rowsInRadians:()=>zo,turning:()=>re,variables:()=>it});var Xe={};x(Xe,{HALF:()=>Wt,HAND:()=>Zt,RIGHT:()=>me,ROUNDED:()=>pe,SLOPPY:()=>Kt,SO_FAR:()=>J,TELLING:()=>Vt,WRONG:()=>Ve,bands:()=>Ir,beyond:()=>Fr,decimalsOf:()=>_r,farthest:()=>Je,generous:()=>Yt,graded:()=>zr,margins:()=>Lr,units:()=>X});var[me,J,pe,Ve]=["right","so far","rounded","wrong"],Wt=.51,Zt=3.01,Nr=1e-6,Kt=.001,Vt=.0021,kr=13,Ut=-12,Tr=/^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/,Ht=e=>+`1e${e}`;function Rr(e){let t=Tr.exec(e.trim());if(!t||!(t[1]||t[2]))return null;let n=(t[1]+t[2]).replace(/^0+/,"").length,r=t[2].length-Number(t[3]??0);return{decimals:r,digits:n,first:n-1-r}}function X(e){let t=e.map(Rr),n=t.filter(i=>i&&i.digits&&i.first>Ut),r=i=>n.reduce((c,l)=>Math.max(c,l[i]),n.length?-1/0:0),[o,s]=[r("decimals"),r("digits")];if(s>=kr||t.includes(null)&&o<=0)return e.map(()=>0);let a=n.every(i=>i.decimals<=s-1-i.first)&&n.some(i=>i.digits===s&&i.decimals<o);return t.map(i=>i?!a||!i.digits||i.first<=Ut?Ht(-o):Ht(Math.max(-o,i.first-s+1)):0)}function _r(e){let t=e.filter(n=>n>0);return t.length?Math.max(0,Math.round(-Math.log10(Math.min(...t)))):null}function Lr(e,t,n=null,r=null){let o=t.map(l=>Nr*l),s=e.map(()=>0);if(r!==null){let l=o.map(u=>Math.max(r,u*.001));return{allowed:l,band:l,loose:l,units:s,slop:s}}let a=e.map((l,u)=>Math.max(Wt*l,o[u])),i=e.map((l,u)=>Math.max(Zt*l,o[u])),c=i.map((l,u)=>Math.max(l,Kt*t[u]));return{allowed:a,band:i,loose:c,units:e,slop:n??s}}var Ye=(e,t,n)=>e.map((r,o)=>r+n*t[o]),Je=({loose:e,band:t,slop:n})=>Ye(t,n,2).map((r,o)=>Math.max(r,e[o])),Yt=({allowed:e,slop:t})=>Ye(e,t,1);function Ir(e){let t=e.slop.some(Boolean)?[Ye(e.band,e.slop,2)]:[];return[e.band,...t,Je(e),e.allowed]}var Ke=(e,t,n)=>e.every((r,o)=>Math.abs(r-t[o])<=n[o]),ue=(e,t)=>e.reduce((n,r,o)=>Math.max(n,Math.abs(r-t[o])),0);function zr(e,t,n,r){let o=r.filter(a=>ue(a,t)>Vt);for(let a of[n.allowed,Yt(n)]){let i=o.some(c=>Ke(e,c,a));if(Ke(e,t,a)){let c=Math.max(0,...n.units),l=o.reduce((u,p)=>Math.min(u,ue(p,t)),1/0);return i||c>l/2.1?J:me}if(i)return Ve}if(!Ke(e,t,Je(n)))return Ve;let s=ue(e,t);return o.some(a=>ue(e,a)<=s)?J:pe}function Fr(e,t,{band:n,allowed:r}){let o=a=>e.map((i,c)=>Math.abs(i-t[c])>a[c]),s=o(n);return s.includes(!0)?s:o(r)}var tt={};x(tt,{isNumber:()=>q,number:()=>L,parse:()=>O,plain:()=>A,symbols:()=>_,value:()=>U});var Jt=2e4,en=60,tn={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:e=>e*$,deg2rad:e=>e*$,degrees:e=>e*Ze,rad2deg:e=>e*Ze,sind:e=>Math.sin(e*$),cosd:e=>Math.cos(e*$),float:e=>e,Float:e=>e,Integer:e=>e,float64:e=>e,float32:e=>e,int64:e=>e},Xt={"+":(e,t)=>e+t,"-":(e,t)=>e-t,"*":(e,t)=>e*t,"/":(e,t)=>t===0?NaN:e/t,"^":Pr},nn={pi:Math.PI,deg:$,rad:1},Cr=e=>Object.hasOwn(tn,e),rn=e=>Object.hasOwn(nn,e);function Pr(e,t){let n=e**t;return Number.isFinite(n)||!Number.isFinite(e)?n:NaN}var j=(e,t)=>[...e].map(n=>[n,t]),Dr="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),Br=new Map([...j("−–—‐‑‒﹣－","-"),...j("×⋅·∙∗","*"),...j("÷∕⁄","/"),...j("       　"," "),...j("​⁡⁢\uFEFF",""),...j("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((e,t)=>j(e,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((e,t)=>j(e,` ${Dr[t]}`)),...j("π𝜋"," pi "),...j("°º"," deg"),["$"," "],["²","^2"],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),Gr=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)\b/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text|mathit|mathbf|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)\b/g," deg"],[/\\(?:cdot|times|ast)\b/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/\\d?t?frac\s*(\d)\s*(\d)/g,"(($1)/($2))"]],qr=/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,Ur=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,Hr=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,Qe=new RegExp(String.raw`\s*(?:(${Ur})|(${Hr})|(\*\*|[-+*/^()]))`,"y"),Wr=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,Zr=/[cs]_?(?:\d|\{[\d+-]+\})+/g,Kr=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,q=e=>Kr.test(e);function A(e){if(q(e))return e;e=[...e].map(t=>Br.get(t)??t).join("");for(let[t,n]of Gr)e=e.replace(t,n);for(let t="";t!==e;)[t,e]=[e,e.replace(qr,"(($1)/($2))")];return e=e.replace(/\\([A-Za-z]+)/g," $1 "),e=e.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),e=e.replace(/(?<=\w)\s*\(t\)/g,""),e=e.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),e=e.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),e=e.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),e.replace(/[ \t]+/g," ").trim()}function O(e,t="the formula"){if(e.length>Jt)throw new h(`${t} has ${e.length} characters; expected at most ${Jt}`);let n=Yr(A(e));if(!n)throw new h(`${t} is ${D(e)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let r=Vr(n);if(r?.[1]!==n.length)throw new h(`${t} is ${D(e)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return r[0]}var S=class extends Error{};function Vr(e){try{return on(e,0,0)}catch(t){if(t instanceof S)return null;throw t}}function Yr(e){let t=[];for(let n=0;n<e.length;n=Qe.lastIndex){Qe.lastIndex=n;let r=Qe.exec(e);if(!r)return null;let[,o,s,a]=r;if(o!==void 0)t.push(["num",o]);else if(a!==void 0)t.push(["sign",a==="**"?"^":a]);else for(let i of Wr.test(s)?s.match(Zr):[s])t.push(["name",i])}return t}function de(e,t){if(t>=e.length)throw new S;return e[t]}function on(e,t,n){let[r,o]=Qt(e,t,n);for(;o<e.length&&["+","-"].includes(e[o][1]);){let[s,a]=Qt(e,o+1,n);[r,o]=[[e[o][1],r,s],a]}return[r,o]}function Qt(e,t,n){let[r,o]=Q(e,t,n);for(;o<e.length;){let[s,a]=e[o];if(a==="*"||a==="/"){let[i,c]=Q(e,o+1,n);[r,o]=[[a,r,i],c]}else if(a==="("||s!=="sign"){let[i,c]=sn(e,o,n);[r,o]=[["*",r,i],c]}else break}return[r,o]}function Q(e,t,n){if(n>en)throw new S;let r=de(e,t)[1];if(r==="-"){let[o,s]=Q(e,t+1,n+1);return[["neg",o],s]}return r==="+"?Q(e,t+1,n+1):sn(e,t,n)}function sn(e,t,n){let[r,o]=et(e,t,n);if(o>=e.length||e[o][1]!=="^")return[r,o];let[s,a]=Q(e,o+1,n+1);return[["^",r,s],a]}function et(e,t,n){let[r,o]=de(e,t);if(r==="num")return[["num",Number(o)],t+1];if(r==="name"&&Cr(o)&&t+1<e.length){let[i,c]=Jr(e,t+1,n+1);return[["call",o,i],c]}if(r==="name")return[["name",o],t+1];if(o!=="(")throw new S;let[s,a]=on(e,t+1,n+1);if(de(e,a)[1]!==")")throw new S;return[s,a+1]}function Jr(e,t,n){if(n>en)throw new S;if(de(e,t)[1]!=="-")return et(e,t,n);let[r,o]=et(e,t+1,n);return[["neg",r],o]}function _(e,t=new Set){for(let n=[e];n.length;){let[r,...o]=n.pop();r==="name"&&!rn(o[0])&&t.add(o[0]),n.push(...o.filter(Array.isArray).reverse())}return t}function U(e,t){let n=fe(e,t);if(!Number.isFinite(n))throw new h("a formula divides by zero or is too large; expected a finite value");return n}function fe(e,t){let n=[];for(;Object.hasOwn(Xt,e[0]);e=e[1])n.push(e);let r=Xr(e,t);return n.reduceRight((o,[s,,a])=>Xt[s](o,fe(a,t)),r)}function Xr([e,t,n],r){if(e==="num")return t;if(e==="neg")return-fe(t,r);if(e==="call")return tn[t](fe(n,r));let o=rn(t)?nn[t]:r(t);if(o===void 0)throw new h(`no value for ${t}`);return o}function L(e){try{return U(O(e),()=>{})}catch(t){if(t instanceof h)return null;throw t}}var st={};x(st,{cells:()=>I,withoutHeader:()=>te});var Qr=/(?<![^\n])[ \t]*```[^\n\r]*/g,an=String.raw`(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*`,eo=new RegExp(an+String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,"g"),to=new RegExp(an,"g"),no=/((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*[#%][^\n\r]*/g,ro=/^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[[({])/,oo=/^[ \t\r\n]*=[ \t]*(?=[[({])/,so=String.raw`\{(?:[A-Za-z]*matrix\*?|array|tabular)\}`,[ao,io]=["begin","end"].map(e=>new RegExp(String.raw`\\${e}${so}`,"g")),co=new RegExp(String.raw`\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}`+String.raw`|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed|left[ \t]*[\[(|.]|\[|\()`+String.raw`|[$&{ \t\r\n]`,"g"),lo=/\\end\{[a-z]+\*?\}|\\label\{[^{}]*\}|\\(?:right[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]/g,uo=/^[^=0-9][^=]*=$/,mo=[[/\\[hv]?phantom\{[^{}]*\}/g," "],[/\\num\{([^{}]*)\}/g,"$1"],[/\{([-+])\}/g,"$1"],[/(?<=[0-9])\{,\}(?=[0-9])/g,"."]],cn=e=>e.replace(Qr,"").replace(no,"$1").replace(eo,"").replace(to,"").replace(ro,"").replace(oo,"");function ln(e){let[t,n]=[ao,io].map(r=>[...e.matchAll(r)]);if(t.length===1&&n.length===1){let[r,o]=[t[0].index,n[0].index+n[0][0].length],s=e.slice(0,r).replace(co,""),a=e.slice(o).replace(lo,""),i=!s||uo.test(s)&&!s.includes("frac");e=e.slice(i?r:0,a?e.length:o)}for(let[r,o]of mo)e=e.replace(r,o);return e}var un=5e6,fn=String.raw`[\p{L}\p{N}_.]`,po=String.raw`^\s*(?:${fn}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`,fo="Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym",mn=new RegExp(String.raw`${po}(?:${fn}*(?:${fo})\s*\(\s*)+`,"u"),ho=/\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u,go=/^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u,wo=/\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g,bo=/\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|toprule|midrule|bottomrule|nonumber)\b/g,pn=/(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/,dn=/^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m,xo=/^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im,yo=/^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/,hn=e=>{let t=e.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);return t.at(-1)===""&&t.pop(),t},nt=(e,t)=>{let[n,r]=[0,e.length];for(;n<r&&t.includes(e[n]);)n++;for(;r>n&&t.includes(e[r-1]);)r--;return e.slice(n,r)},ee=(e,t)=>{let n=e.length;for(;n>0&&t.includes(e[n-1]);)n--;return e.slice(0,n)};function I(e){if(e.length>un)throw new h(`the text has ${e.length} characters; expected at most ${un}`);let t=vo(nt(cn(e).trim(),"`$").trim()).filter(n=>n.some(r=>r.trim())).map(n=>n.map(r=>r.trim()));if(!t.length)throw new h("the text is empty; expected rows of numbers or formulas");return t}function vo(e){if(e.includes("\\begin{")||e.includes("\\\\"))return $o(e);if(e.split("|").length>2&&!/^[^|]*\[[^\]|]*\|/.test(e))return jo(e);let t=mn.test(e)?e.replace(mn,"").replace(ho,""):e;return t=ee(t.replace(go,"").trim(),";").trim(),t&&"[({".includes(t[0])?gn(t):Mo(t)}function $o(e){return e=ln(e).replace(/\\left\s*[[(.|]\s*(?=\\begin)/g," ").replace(wo," ").replace(bo," ").replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u,"").replace(/\\\\\s*\[[^\]]*\]/g,"\\\\").replaceAll("$"," ").replaceAll("\\["," ").replaceAll("\\]"," "),e.split(/\\\\|\\cr\b/).map(t=>t.split("&"))}var jo=e=>hn(e).map(t=>t.trim()).filter(t=>t.includes("|")&&!/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(t)).map(t=>t.replace(/^\||\|$/g,"").replaceAll("$"," ").split("|"));function gn(e){let t=he(e);if(t.every(H)){let r=t.map(he);if(!r.some(a=>a.some(H)))return r;let o=a=>H(a)&&he(a).length===1?he(a)[0]:a,s=r.map(a=>a.map(o));return s.some(a=>a.some(H))?t.flatMap(gn):s}let n=e.trim().slice(1,-1);return H(e)&&!n.includes("[")?n.replace(/\.\.\.[^\n]*\n/g," ").split(/[;\n]/).map(ge):[t]}function H(e){return e=e.trim(),!e||!"[({".includes(e[0])||!Ao(e)?!1:e[0]!=="("||ot(e.slice(1,-1))}var rt=e=>"[({".includes(e)?1:"])}".includes(e)?-1:0;function Ao(e){let t=0;for(let n=0;n<e.length;n++)if(t+=rt(e[n]),!t)return n===e.length-1;return!1}function ot(e){let t=0;for(let n=0;n<e.length;n++)if(t+=rt(e[n]),e[n]===","&&!t)return!0;return!1}function he(e){return e=ee(e.trim(),","),ge(H(e)?e.slice(1,-1):e)}function ge(e){let t=e.trim().split(/\s+/);if(t.every(q))return t;let n=[],[r,o]=[0,""],s=ot(e);for(let a=0;a<e.length;a++){let i=e[a];r+=rt(i),(s?i===",":/\s/.test(i)&&!Eo(e,a))&&!r?(n.push(o),o=""):o+=i,!s&&!r&&i==="]"&&(n.push(o),o="")}return n.push(o),n.filter(a=>a.trim()).map(a=>nt(a.trim(),`'"`))}function Eo(e,t){let[n,r]=[e.slice(0,t).trimEnd(),e.slice(t).trim()];return r==="*"?pn.test(`${n}*`):n.endsWith("*")&&r&&!"*/^)=".includes(r[0])&&pn.test(n)?!1:!n||!r||"+-*/^=(".includes(n.at(-1))||"*/^)=".includes(r[0])?!0:"+-".includes(r[0])&&r.length>1&&/\s/.test(r[1])||r.startsWith("deg")||r[0]==="°"}function Mo(e){let t=dn.exec(e);e=e.replace(new RegExp(dn,"gm"),"");let r=e.split(xo).filter(s=>s.trim()).map(So),o=r[0]??[];return r.every(s=>s.length===o.length)&&(o=o.map((s,a)=>r.flatMap(i=>i[a]))),t?o.map(s=>s.map(a=>L(a)?`${a}*${t[1]}`:a)):o}function So(e){let t=hn(e).filter(o=>o.trim()&&!yo.test(o)).filter(o=>!/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(o)),n=o=>t.some(s=>ee(s.trim(),";").includes(o)),r=["	",";"].find(n);if(r){let o=s=>ee(nt(s,`\r
 `),r);return t.map(s=>o(s).split(r).map(No))}return t.some(ot)?Oo(t):t.map(o=>ge(o.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g,"")))}function Oo(e){let t=e.every(n=>/^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(n));return e.map(n=>ge(t?n.replaceAll(",","."):ee(n,",")))}function No(e){let t=e.trim();return t[0]==='"'&&t.at(-1)==='"'&&(e=t.slice(1,-1)),e=e.replace(/^[ \t]*=/,""),e.split(",").length===2&&!e.includes("(")?e.replace(/(?<=\d),(?=\d)/g,"."):e}var ko=e=>e.every(t=>t.every(n=>L(n)!==null));function te(e){let[t,...n]=e,r=t.map(A).filter(Boolean);return n.length>0&&r.every(s=>L(s)===null)&&ko(n)?n:e}var To=/^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/,wn=/^([cs])((?:[+-]?\d)+)$/i,Ro=/^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/,at=e=>b(e).map(t=>t+1),re=e=>b(e).map(t=>e.rows[t].kind==="revolute"),it=e=>at(e).map(t=>`q_${t}`);function ct(e,t,n=[]){let r=[];return{known:s=>{let[a,i]=Fo([...s].sort(),e,t,n);for(let c of i)r.includes(c)||r.push(c);return a},said:r}}var _o=e=>{if(e.size)throw new h(y("symbols for numbers",{names:[...e].sort().join(", ")}));return new Map};function bn(e,t,n=_o,r="numbers"){if(typeof e=="string")return Lo(e,t,n);let o=xn(e),s=e.flat(1/0);if(!s.every(Number.isFinite))throw new h(y("not finite",{what:t,wanted:r}));return{values:s,units:X(s.map(P)),shape:o,symbolic:!1}}var xn=e=>Array.isArray(e)?[e.length,...e.length?xn(e[0]):[]]:[];function Lo(e,t,n){let r=te(I(e)),o=[...new Set(r.map(d=>d.length))].sort((d,g)=>d-g);if(o.length>1)throw new h(y("ragged",{what:t,widths:o.join(", ")}));let s=r.flat().map(A),a=s.map(d=>q(d)?["num",Number(d)]:O(d,`an entry of ${t}`)),i=new Set;for(let d of a)_(d,i);let c=n(i),l=a.map(d=>U(d,g=>c.get(g))),u=s.map(Io),p=X(u.map(([d])=>d)).map((d,g)=>d*u[g][1]),f=a.map((d,g)=>u[g][1]===1?d:["num",l[g]]);return{values:l,units:p,shape:[r.length,o[0]],symbolic:i.size>0,trees:f}}function Io(e){let t=Ro.exec(e);return t?[t[1],Number(t[2])]:[e,1]}var lt=e=>`one value for each of ${it(e).join(", ")}`;function ut(e,t,n="rad"){let r=bn(e,`${t.name}: q`,void 0,lt(t)),o=typeof e=="string"?[r.values.length]:r.shape,s=b(t).length;if(o.length!==1||o[0]!==s)throw new h(yn(t,o,`one pose, (${s},)`));return mt(r,t,n)}function yn(e,t,n){let r=Re(t);return`${e.name}: q has shape ${r}; expected ${n}, ${lt(e)}`}function mt(e,t,n){let r=re(t),o=s=>n==="deg"&&r[s%r.length]?$:1;return{...e,values:e.values.map((s,a)=>s*o(a)),units:e.units.map((s,a)=>s*o(a))}}function zo(e,t){let n=re(t),r=n.some(Boolean)&&!n.every(Boolean),o=r?X(e.flatMap(({values:i})=>i.filter((c,l)=>n[l])).map(P)):[],s=0,a=(i,c)=>{if(!r||!n[c])return i;let l=o[s++];return i>0?Math.max(l,i):i};return e.map(i=>mt({...i,units:i.units.map(a)},t,"deg"))}var ne=e=>e.replace(/\(t\)|[_{}'*^\\ ]/g,"").replace(/[ϑθ]/g,"theta").toLowerCase();function Fo(e,t,n,r){let o=new Map([...t.values??[],...r]),s=new Map([...o].map(([u,p])=>[ne(u),p])),a=new Map(e.filter(u=>s.has(ne(u))).map(u=>[u,s.get(ne(u))])),i=new Map(e.filter(u=>!a.has(u)).map(u=>[u,Co(u)])),[c,l]=Po([...new Set([...i.values()].flatMap(u=>u??[]))],t);for(let[u,p]of i){let f=(p??[]).map(d=>c.get(d));if(!f.length||f.includes(void 0)){let d=[...it(t),...(t.values??[]).map(([g])=>g)].join(", ");throw new h(y("unknown symbol",{arm:t.name,name:u,known:d}))}a.set(u,Do(ne(u),f.map(d=>n[d])))}return[a,l]}function Co(e){let t=ne(e),n=To.exec(t);if(n)return[Number(n[2])];let r=wn.exec(t);return r?[...r[2].matchAll(/\d/g)].map(Number):null}function Po(e,t){let n=at(t),r=new Map(n.map((a,i)=>[a,i])),o=a=>e.every(i=>i>=a&&i<a+n.length);if(e.every(a=>r.has(a)))return[r,[]];let s=a=>new Map(n.map((i,c)=>[c+a,c]));return o(1)?[s(1),[y("taken: counted on",{joints:n.join(", ")})]]:o(0)?[s(0),[y("taken: from zero",{joints:n.join(", ")})]]:[r,[]]}function Do(e,t){let n=wn.exec(e);if(!n)return t[0];let r=[...n[2].matchAll(/([+-]?)\d/g)].map(([,s])=>s==="-"?-1:1),o=t.reduce((s,a,i)=>s+r[i]*a,0);return e[0]==="c"?Math.cos(o):Math.sin(o)}var dt={};x(dt,{ownValues:()=>we,valuesCall:()=>Uo});var Bo=/^\s*(?:values\s*=\s*)?(?:dict\s*\(([^]*)\)|\{([^]*)\})\s*$/,Go=/^\s*(["']?)(.+?)\1\s*[=:]\s*([^=:]+?)\s*$/s,qo=/^[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?$/;function we(e){let[,t,n]=Bo.exec(e)??[];return(t??n??e).split(/[,;\n]/).filter(o=>o.trim()).map(o=>{let[,,s,a]=Go.exec(o)??[],[i,c]=s?[A(s),L(a)]:["",null];if(c!==null&&qo.test(i))return[i,c];throw new h(`your own symbols: ${D(o.trim())} is not read; expected such as h = 0.333`)})}function Uo(e){let t=we(e).map(([n,r])=>`"${n}": ${P(r)}`);return t.length?[`values={${t.join(", ")}}`]:[]}var gt={};x(gt,{checkerOf:()=>xe,load:()=>oe,ready:()=>ht,register:()=>Wo});var ft=new Map,be=new Map,Ho=typeof document>"u"?null:document.currentScript?.src,Wo=(e,t)=>{ft.set(e,t)},xe=e=>ft.get(e),ht=e=>ft.has(e)?Promise.resolve():oe(v[e].script);function oe(e){return be.has(e)||be.set(e,Zo(e)),be.get(e)}function Zo(e){return new Promise((t,n)=>{let r=()=>{be.delete(e),n(new Error(`The script judge-${e}.js could not be loaded.`))},o=new URL(`judge-${e}.js`,Ho).href;document.head.append(Object.assign(document.createElement("script"),{src:o,onload:()=>t(),onerror:r}))})}var vn=12e3,Ko={table:2e3,q:500,wrench:300,values:500,answer:8e3,target:1e3},$n=2e4,Vo="the arm asked about",N="own",W=["rad","deg"],wt={unit:W,first:["v","omega"],plane:["zy","yz","zx","xz"],pace:["even","rest"],lengths:["","m","cm","mm"],angles:["",...W],convention:["","standard","craig"]},Z={ask:"jacobian",arm:"",table:"",q:"",unit:"rad",frame:"0",first:"v",wrench:"",values:"",answer:"",columns:"",lengths:"",angles:"",convention:"",target:"",radius:"0.1",plane:"zy",period:"5",steps:"",pace:"even"};function bt(e){let t=Object.entries(e).filter(([n,r])=>r!==Z[n]||n==="ask"||n==="arm");return`#${new URLSearchParams(t)}`}function xt(e,t){let n=e.replace(/^#/,"");if(!/^ask=/.test(n))return{question:null,words:""};let r=i=>({question:null,words:`The link could not be read: ${i}.`});if(n.length>vn)return r(`it has ${n.length} characters; ${vn} are the most`);let o=new URLSearchParams(n),s={...Z};for(let[i,c]of o){if(!Object.hasOwn(Z,i))return r(`it has a field “${i.slice(0,40)}”`);if(c.length>(Ko[i]??40))return r(`its ${i} is too long`);s[i]=c}if(!Object.hasOwn(v,s.ask))return r("it asks what is not judged here");if(s.arm!==N&&!t.includes(s.arm))return r(`there is no arm called “${s.arm}” here`);let a=Object.keys(wt).find(i=>!wt[i].includes(s[i]));return a?r(`its ${a} is none`):/^\d{1,2}$/.test(s.frame)?{question:s,words:""}:r("its frame is none")}function yt(e,t){if(e.arm!==N)return t.find(({key:s})=>s===e.arm);if(!e.table.trim())throw new h("Type the table of your arm: a row for each joint, a α d θ.");let n=new Map(v[e.ask].fields.includes("values")?we(e.values):[]),r=I(e.table).filter((s,a)=>a||!s.some(i=>/^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(i))).map((s,a)=>Xo(s.length===5?s.slice(1):s,a+1,e.unit,n)),o=qe(r);if(o)throw new h(`${o}.`);return{...Ue(r,{name:"",home:[],rows:[]}),name:Vo}}var Yo=["a","alpha","d","theta"],Jo=/^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;function Xo(e,t,n,r){if(e.length!==4)throw new h(`Row ${t} of the table has ${e.length} entries; expected four: a α d θ.`);let o=e.map((p,f)=>O(p||"0",`row ${t}, ${Yo[f]}`)),s=o.map(p=>[..._(p)].filter(f=>!r.has(f))),a=s.flatMap((p,f)=>p.filter(d=>f<2||!Jo.test(d)));if(a.length)throw new h(`Row ${t} of the table: no value for ${a[0]}; write numbers, and a variable such as q1.`);let[i,c,l,u]=o.map((p,f)=>{let d=n==="deg"&&f%2&&!/deg|°|pi|π/.test(e[f]);return U(p,g=>r.get(g)??0)*(d?$:1)});return{kind:s[2].length?"prismatic":"revolute",a:i,alpha:c,d:l,theta:u}}function vt(e,t){let n,r;try{n=yt(e,t);let o=Qo(e,n);if(o)return{error:o,arm:n};if(r=jn(e)?ut(e.q,n,e.unit).values:void 0,!e.answer.trim())return{error:"Type or paste your answer.",arm:n,q:r};let s=v[e.ask].longest??$n;if(e.answer.length>s)return{error:`The answer is longer than ${s} characters.`,arm:n,q:r};let a=xe(e.ask);return a?{report:a.verdict(e,n),arm:n,q:r}:{error:"The checker is being loaded.",waiting:!0,arm:n,q:r}}catch(o){if(o instanceof h)return{error:es(o.message),arm:n,q:r};throw o}}var jn=({ask:e})=>v[e].fields.includes("q"),Qo=(e,t)=>jn(e)&&!e.q.trim()?`Type the pose: ${b(t).length} joint values.`:null,es=e=>e.slice(0,1).toUpperCase()+e.slice(1);function ts(e,t){let n=yt(e,t),[r,o]=e.arm===N?["arm",rs(n)]:[n.python,ns(n.python)],{call:s,imports:a=[]}=xe(e.ask),i=[...o,...a,"from helpers import checks",""];return e.arm===N&&i.push(...os(n),""),i.push(`mine = ${_e(e.answer)}`,`print(${s(e,r,n)})`),`${i.join(`
`)}
`}var ns=e=>[`from helpers.robots import ${/^\w+/.exec(e)[0]}`],An={revolute:"revolute",prismatic:"prismatic",fixed:"fixed"},rs=e=>[`from helpers.arm import Arm, ${[...new Set(e.rows.map(({kind:t})=>An[t]))].sort().join(", ")}`],os=e=>["rows = [",...e.rows.map(({kind:t,a:n,alpha:r,d:o,theta:s})=>`    ${An[t]}(a=${n}, alpha=${r}, d=${o}, theta=${s}),`),"]",`arm = Arm("${e.name}", rows)`];var Et={};x(Et,{MARKS:()=>At,better:()=>hs,both:()=>En,cause:()=>is,complete:()=>ds,explain:()=>us,explainAll:()=>Sn,linesOf:()=>ye,nameOf:()=>cs,several:()=>fs,textOf:()=>gs,wordsOf:()=>Mn});var ss=.6,as=.85,jt=.7,is=(e,t={})=>({keys:[e],fields:[t]}),En=(e,t)=>({keys:[...e.keys,...t.keys],fields:[...e.fields,...t.fields]}),cs=({keys:e,fields:t})=>e.map((n,r)=>ls(n,t[r])).join(" + ");function ls(e,t){if("_of"in t)return t._of;let n=Object.entries(t).filter(([r])=>!r.startsWith("_"));return[e,...n.map(([,r])=>r)].join(":")}function Mn({keys:e,fields:t}){let[n,r]=e.map((o,s)=>y(o,t[s]));return r===void 0?n:y("and also",{first:n,second:ce(r)})}var us=(e,t,n,r,o,s=jt)=>Sn(e,t,[n],r.map((a,i)=>[[a],o[i]]),s)[0];function Sn(e,t,n,r,o=jt){let s=n.map(i=>{let c=e.filter((u,p)=>Math.abs(u-t[p])>i[p]).length,l=[Math.max(3,ss*c),Math.max(4,as*c)];return{band:i,count:c,least:l,named:[]}}),a=0;for(let[i,c]of r){let l=i.length>1?2:i[0].keys.length;for(let{band:u,count:p,least:f,named:d}of s){let g=ms(e,c,u,p,f[l-1]);(g?p-g>=f[l-1]:p>0)&&d.push({k:a,cost:l+o*g,parts:i,A:c})}a++}return s.map(i=>ps(e,i))}function ms(e,t,n,r,o){let s=0;for(let a=0;a<e.length;a++)if(!(Math.abs(e[a]-t[a])<=n[a])&&(s++,r-s<o))return s;return s}function ps(e,{band:t,named:n}){if(!n.length)return null;let r=i=>Math.round(i*1e6);n.sort((i,c)=>r(i.cost)-r(c.cost)||i.k-c.k);let[{cost:o,A:s}]=n;return{causes:n.filter(i=>i.cost===o).map(({parts:i})=>i.reduce(En)),odd:e.map((i,c)=>!(Math.abs(i-s[c])<=t[c]))}}var ds=e=>!!e&&!e.odd.includes(!0);function fs(e,t=3){let n=[...new Set(e.map(Mn))].slice(0,e[0].keys.length===1?t:1);return n.length===1?n[0]:y("or",{first:n[0],others:Te(n.slice(1).map(ce),"or")})}function hs(e,t=jt){let n=r=>r.causes[0].keys.length+t*r.odd.filter(Boolean).length;return e.filter(Boolean).reduce((r,o)=>r&&n(r)<=n(o)?r:o,null)}var At={[me]:"✔",[J]:"◐",[pe]:"≈",wrong:"✘"},ye=({headline:e,findings:t,taken:n,notes:r})=>[...t.filter(({what:o,words:s})=>o!=="cause"&&!e.includes(s.slice(1))).map(({words:o})=>o),...n.map(o=>`Taken as ${o}`),...r.map(o=>`Note: ${o}`)],gs=e=>[e.headline,...ye(e).map(t=>`- ${t}`)].join(`
`);var Rt={};x(Rt,{matrixOf:()=>zn,namesOf:()=>Ot,showRead:()=>Nt,tell:()=>Tt,typeset:()=>ae});var ws="http://www.w3.org/1998/Math/MathML",[Mt,k,kn,z]=[1,2,3,4],[bs,xs]=["⁡","⁢"],ys={alpha:"α",beta:"β",gamma:"γ",delta:"δ",theta:"θ",th:"θ",phi:"φ",psi:"ψ",omega:"ω",lambda:"λ",pi:"π",inf:"∞"},vs={asin:"arcsin",acos:"arccos",atan:"arctan",sind:"sin",cosd:"cos"},$s=/^(?:[Ff]loat|Integer|float64|float32|int64)$/,js=/^(?:radians|deg2rad)$/,F=e=>["mo",e],T=e=>e.length===1?e[0]:["mrow",e],On={stretchy:"false",lspace:"0",rspace:"0"},Tn=(e,t="(",n=")")=>T([["mo",t,{form:"prefix",...On}],...e,["mo",n,{form:"postfix",...On}]]),ve=e=>["math",[T(E(e).pieces)],{displaystyle:"true"}];function se([e,t,n={}]){let r=document.createElementNS(ws,e);for(let[o,s]of Object.entries(n))r.setAttribute(o,s);return r.append(...typeof t=="string"?[t]:t.map(se)),r}var $e=([e,t])=>e==="num"||e==="neg"&&t[0]==="num";function E(e){let[t,n,r]=e;if(t==="num")return As(n);if(t==="name")return{level:z,pieces:[Es(n)]};if(t==="call")return Ms(n,r);if(t==="^")return{level:kn,pieces:[["msup",[T(C(n,z)),T(E(r).pieces)]]]};if(t==="/"&&n[0]==="neg")return Nn(["neg",["/",n[1],r]]);if(t==="/"){let o=[n,r].map(s=>T(E(s).pieces));return{level:k,pieces:[["mfrac",o]]}}return t==="*"?Ss(e):Nn(e)}function C(e,t){let{level:n,pieces:r}=E(e);return n<t?[Tn(r)]:r}function As(e){let[t,n]=String(Math.abs(e)).split("e"),r=[["mn",t]];if(n){let o=T([...n[0]==="-"?[F("−")]:[],["mn",n.replace(/^[+-]/,"")]]);r.push(F("⋅"),["msup",[["mn","10"],o]])}return e<0?{level:Mt,pieces:[F("−"),...r]}:{level:n?k:z,pieces:r}}function Es(e){let[,t,n,r]=/^([A-Za-z]+)_?(.*?)('?)$/.exec(e.replace(/[{}]/g,""));if(t==="deg"&&!n)return["mi","°"];let o=["mi",(ys[t]??t)+r.replace("'","′")],a=(n.match(/\d+|[A-Za-z_]+|[+-]/g)??[]).map(i=>[/\d/.test(i)?"mn":/\w/.test(i)?"mi":"mo",i.replace("-","−")]);return a.length?["msub",[o,T(a)]]:o}function Ms(e,t){if($s.test(e))return E(t);if(e==="sqrt")return{level:z,pieces:[["msqrt",[T(E(t).pieces)]]]};if(e==="abs")return{level:z,pieces:[Tn(E(t).pieces,"|","|")]};if(js.test(e))return{level:k,pieces:[...C(t,z),["mi","°"]]};let n=e.endsWith("d")?[["mi","°"]]:[],r=C(t,z),s=r[0][0]==="mrow"?r:[["mspace","",{width:"0.17em"}],...r];return{level:kn,pieces:[["mi",vs[e]??e],F(bs),...s,...n]}}function Ss(e){let t=_n(e,["*"]).map(([,o])=>o),n=t[0][0]==="neg"||t[0][0]==="num"&&t[0][1]<0,r=n?E(t[0]).pieces:C(t[0],k);return t.slice(1).forEach((o,s)=>{o[0]==="name"&&o[1]==="deg"||r.push(F(Os(t[s],o)?"⋅":xs)),r.push(...C(o,k))}),{level:n?Mt:k,pieces:r}}var Os=(e,t)=>Rn(t)||e[0]==="call"&&t[0]!=="call"&&e[1]!=="sqrt"&&e[1]!=="abs",Rn=([e,t])=>e==="num"||["^","*"].includes(e)&&Rn(t);function Nn(e){let t=[];for(let[n,r]of _n(e,["+","-"]))n&&t.push(F(n==="-"?"−":"+")),n?t.push(...C(r,k)):r[0]==="neg"?t.push(F("−"),...C(r[1],k)):t.push(...E(r).pieces);return{level:Mt,pieces:t}}function _n(e,t){let n=[];for(;t.includes(e[0]);)n.push([e[0],e[2]]),e=e[1];return[["",e],...n.reverse()]}var Ns={v:["vx","vy","vz","ωx","ωy","ωz"],omega:["ωx","ωy","ωz","vx","vy","vz"]},ks=["a (m)","α","d (m)","θ"],St=40,In=8e3;function Ot({ask:e,first:t},n,[r,o]){let s=b(n).map(c=>c+1),a=c=>s.length===o?`joint ${s[c]}`:String(c+1),i={torques:r===1?["τ"]:[],jacobian:r===6?Ns[t]:[]}[e]??[];return{columns:Array.from({length:o},(c,l)=>a(l)),rows:Array.from({length:r},(c,l)=>i[l]??`row ${l+1}`)}}function zn(e,{report:t,arm:n}){let r=t?.typed;if(!r||r.shape.length!==2)return null;let o=e.ask==="torques"&&r.shape[1]===1,[s,a]=o?[1,r.values.length]:r.shape,i=t.wrong?.length===r.values.length?t.wrong:[];return{...Ot(e,n,[s,a]),typed:r,wrong:i,shape:[s,a]}}function Nt(e,t,n){let r=Ts(t,n);if(e.hidden=!r,!r)return;let{columns:o,rows:s,cell:a,unread:i=0}=r,c=m("tr",{},m("td"),o.map(g=>m("th",{scope:"col"},g))),l=s.slice(0,St).map((g,K)=>m("tr",{},m("th",{scope:"row"},g),o.map((ie,V)=>a(K,V)))),u=s.length>St?`, its first ${St} of ${s.length} rows`:"",p=i?`; ${i===1?"1 entry":`${i} entries`} could not be`:"",f=m("caption",{},`How your answer is read${u}${p}`),d=t.ask==="table"?"table.read":"table.read.matrix";e.replaceChildren(m(d,{},f,m("thead",{},c),m("tbody",{},l)))}function Ts(e,t){let{table:n}=t.report??{};return n?Rs(n):_s(e,zn(e,t))??Ls(e,t)}var Rs=({cells:e,trees:t,wrong:n})=>({columns:ks,rows:e.map((r,o)=>String(o+1)),cell(r,o){let[s,a]=[t[r][o],e[r][o]],i=/^-?q_\d+$/.test(a);return je(s&&!$e(s)?Fn(s,i?"":a):kt(a),n[r][o])}});function _s({answer:e},t){if(!t)return null;let{typed:n,wrong:r,shape:o}=t,s=e.length>In?[]:n.trees??[];return{...t,cell(a,i){let c=a*o[1]+i,l=s[c];return!l||$e(l)&&n.units[c]?je(kt(Ln(n,c)),r[c]):je(Fn(l,$e(l)?"":Ln(n,c)),r[c])}}}function Ls(e,{error:t,waiting:n,arm:r,q:o}){let{ask:s,answer:a}=e;if(!t||n||!r||!a.trim()||s==="trace"||a.length>In)return null;let i=Is(s,a).map(l=>l.map(u=>zs(s,u,r,o))),c=Math.max(0,...i.map(l=>l.length));return{...Ot(e,r,[i.length,c]),unread:i.flat().filter(({tree:l})=>!l).length,cell(l,u){let{tree:p,text:f}=i[l][u]??{};return f===void 0?m("td"):p?m("td",{},se(ve(p))):je(f,!0,"not read: ")}}}function Is(e,t){try{let n=te(I(t));return e==="table"&&!n[0].some(r=>/\d/.test(r))?n.slice(1):n}catch(n){if(n instanceof h)return[];throw n}}function zs(e,t,n,r){let o=e==="branches"||e==="pose";try{let s=O(A(o?t.replace(/^.*[=:]/,""):t).replace(/\*+$/,"")||"0");return e==="jacobian"&&r&&ct(n,r).known(_(s)),{tree:s,text:t}}catch(s){if(s instanceof h)return{tree:null,text:t};throw s}}function Ln({values:e,units:t},n){let r=Math.min(6,t[n]?Math.max(0,Math.round(-Math.log10(t[n]))):4);return(Number(e[n].toFixed(r))+0).toFixed(r)}var kt=e=>ae(e.replaceAll("-","−")),Fn=(e,t)=>t?[se(ve(e)),m("span.value",{},"= ",kt(t))]:[se(ve(e))],je=(e,t,n="wrong: ")=>t?m("td.off",{},m("span.unseen",{},n),e):m("td",{},e);function Tt(e,{report:t,error:n}){if(e.className=`verdict ${t?.grade??""}`,!t)return e.replaceChildren(m("p",{},ae(n)));let r=ye(t).filter(a=>!t.headline.endsWith(a.slice(1))),o=r.length?[m("ul",{},r.map(a=>m("li",{},ae(a))))]:[],s=m("span",{"aria-hidden":"true"},`${At[t.grade]} `);return e.replaceChildren(m("p.headline",{},s,ae(t.headline)),...o)}var Fs=/(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g,Cs={theta:"θ",alpha:"α"};function ae(e){let t=[],n=0;for(let r of e.matchAll(Fs)){let[o,s,a,i]=r;t.push(e.slice(n,r.index),m("i",{},Cs[s]??s)),t.push(m("sub",{},(a??i).replace("-","−"))),n=r.index+o.length}return[...t,e.slice(n)]}var Cn={"arm.js":He,"dom.js":We,"kinematics.js":Pe,"judge/ask.js":$t,"judge/digits.js":Xe,"judge/door.js":pt,"judge/formula.js":tt,"judge/grid.js":st,"judge/judges.js":Ie,"judge/own_values.js":dt,"judge/ranking.js":Et,"judge/registry.js":gt,"judge/say.js":Le,"judge/shown.js":Rt};var Pn=e=>[["","as it looks"],...e.map(t=>[t,t])],Dn={spellcheck:"false",autocomplete:"off",autocapitalize:"off"},Gn={table:{label:"Table",rows:6,whole:!0,hint:"A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen."},q:{label:"Pose q",hint:"",whole:!0},unit:{label:"Angles in",choices:W.map(e=>[e,e])},frame:{label:"Rows in the axes of",choices:[]},first:{label:"Order of the rows",choices:[["v","v, then ω"],["omega","ω, then v"]]},wrench:{label:"Wrench on the tool, by the world",whole:!0,hint:"Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down."},columns:{label:"Order of the columns",hint:"As in “theta d a alpha”; guessed where it is empty."},lengths:{label:"Lengths in",choices:Pn(["m","cm","mm"])},angles:{label:"Angles in",choices:Pn(W)},convention:{label:"Convention",choices:[["","as it looks"],["standard","standard"],["craig","modified (Craig)"]]},target:{label:"Where the tip should be",rows:4,whole:!0,hint:"A point x, y, z in m, or a pose: its three or four rows, in base axes."},radius:{label:"Radius of the circle below the tip, in m"},plane:{label:"Its plane",choices:[["zy","towards +y first"],["yz","towards −y"],["zx","towards +x"],["xz","towards −x"]]},period:{label:"Time for it, in s"},steps:{label:"Steps",hint:"Empty: as many as your answer has."},pace:{label:"Pace",choices:[["even","even"],["rest","from rest to rest"]]},values:{label:"Your own symbols",whole:!0,hint:"Numbers for those that the arm does not have, in m and rad, as in “h = 0.333, l = 0.1”."},answer:{label:"Your answer",hint:"",rows:8,whole:!0}},Ps={jacobian:"Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",table:"A row for each link, with heads or without: lists, Link(…) lines, MATLAB, LaTeX, Markdown, CSV or cells.",branches:"A row for each answer, angles in the joints' order; names such as theta1 = may stand before them.",pose:"One value for each joint, in the joints' order; names such as theta1 = may stand before them.",trace:"A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",torques:"One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet."},Ds="Pose q at which the circle begins",Bs=["frame","first","values","columns","lengths","angles","convention"],qn=([e,t])=>m("option",{value:e},t);function Gs({choices:e,rows:t,hint:n},r,o){let s=n===void 0?{}:{"aria-describedby":[`${r}-hint`,...o].join(" ")},a={id:r,...s};return e?m("select",a,e.map(qn)):t?m("textarea",{rows:t,wrap:"off",...Dn,...a}):m("input",{...Dn,...a})}function qs(e,t,n){let r=m("label",{for:t},e.label),o=e.hint===void 0?[]:[m("p.about",{id:`${t}-hint`},e.hint)];return m(e.whole?"div.field.whole":"div.field",{},r,n,...o)}function Un(e,t,n){let r={ask:{label:"Question",choices:Object.entries(v).map(([l,{title:u}])=>[l,u])},arm:{label:"Arm",choices:[...t.map(({key:l,title:u})=>[l,u]),...t.length>1&&n?[]:[[N,"My own table"]]]},...Gn},o=l=>`${e}-${l}`,s=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Gs(u,o(l),l==="answer"?[o("private")]:[])])),a=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,qs(u,o(l),s[l])]));for(let l of n?Us(n,t):[])a[l]?.classList.add("given");let i=n?Hs(n,t):"";return n&&(s.answer.rows=6),{form:m("form",{"aria-label":`Check an answer${i&&`: ${i}`}`},i?m("p.asked",{},"Judged here: ",i):[],Object.values(a)),fields:s,boxes:a}}var Us=(e,t)=>[...Object.keys(e),...Bs,...t.length<2?["arm"]:[],..."q"in e?["unit"]:[]];function Hs({ask:e,q:t,wrench:n},r){let o=r.length===1?`, ${r[0].title}`:"";return[`${v[e].title}${o}`,t&&`q = (${t})`,n&&`wrench (${n})`].filter(Boolean).join(", ")}function Hn({fields:e,boxes:t},n,r){let o=new Set(["ask","arm","answer",...v[n.ask].fields]);n.arm===N&&o.add("table");for(let[i,c]of Object.entries(t))c.hidden=!o.has(i);Bn(t.answer,Ps[n.ask]??"");let s=r.find(({key:i})=>i===n.arm);G(t.q.querySelector("label"),n.ask==="trace"?Ds:Gn.q.label),Bn(t.q,s?Ws(s):"One value for each joint, in the table's order.");let a=s?s.rows.length:16;if(e.frame.options.length!==a+1){let i=l=>l?`frame ${l}`:"the base",c=Array.from({length:a+1},(l,u)=>qn([String(u),i(u)]));e.frame.replaceChildren(...c),e.frame.value=n.frame}}var Bn=(e,t)=>G(e.querySelector(".about"),t),Ws=e=>`${b(e).map(n=>`q_${n+1}`).join(", ")}${re(e).includes(!1)?"; m where a joint slides":""}`;var Zs=5e4,Wn=120,Ks=350,Zn="Nothing that you type leaves this page: a script in it judges, without a network too.",Vs="It names the mistake and does not print the solution.",Ys=0;function Kn(e){let{arms:t,examples:n=[],given:r}=JSON.parse(e.querySelector("script").textContent),o=`judge-${++Ys}`,s=Un(o,t,r),{form:a,fields:i}=s,c=Js(o,r),l=[],u={...Z,arm:t[0]?.key,...r??n[0]},p,f=0,d=!1,g=w=>u[w].length>Zs?"":u[w],K=()=>{for(let[w,M]of Object.entries(i))M.value!==g(w)&&(M.value=g(w));Hn(s,u,t)},ie=w=>G(c.said,w),V=()=>Tt(c.verdict,p),Ae=()=>Nt(c.taken,u,p),Ee=()=>{Me(),V(),Ae()},Vn=()=>{Me(),V(),f=setTimeout(Ae)},Yn=()=>{Me(),Ae(),f=setTimeout(V,Ks-Wn)},Me=()=>{clearTimeout(f),d=!1,p=vt(u,t),p.waiting&&ht(u.ask).then(Ee,({message:w})=>ie(w)),i.answer.setAttribute("aria-invalid",String(p.report?.grade==="wrong"));for(let w of l)w(u,p)},Se=w=>{u={...u,...w},K(),Ee()};a.addEventListener("input",({target:w,inputType:M})=>{let R=Object.keys(i).find(Jn=>i[Jn]===w);R&&(u={...u,[R]:w.value},R==="arm"&&(u.frame="0"),(R==="arm"||R==="ask")&&(u.q=Xs(u,n)?.q??u.q),K(),d=!0,clearTimeout(f),M==="insertFromPaste"||M==="insertFromDrop"?Vn():f=setTimeout(Yn,Wn))}),a.addEventListener("submit",w=>w.preventDefault());let _t=()=>{let{question:w,words:M}=xt(location.hash,t.map(({key:R})=>R));(w||M)&&e.scrollIntoView({block:"start"}),ie(M),w&&Se(w)};return e.replaceChildren(a,...Object.values(c)),Se({}),r||(addEventListener("hashchange",_t),_t()),{stub:e,arms:t,examples:n,given:r,...s,parts:c,...{question:()=>u,verdict:()=>(d&&Ee(),p)},put:Se,follow:w=>{l.push(w),w(u,p)},say:ie,links:{fragment:()=>bt(u),open:()=>!0}}}function Js(e,t){return{verdict:m("div.verdict",{role:"status","aria-live":"polite","aria-atomic":"true"}),taken:m("div.scroll.taken",{role:"region",tabindex:"0","aria-label":"How your answer is read"}),tools:m("div.tools"),said:m("p.about",{role:"status"}),private:m("p.private",{id:`${e}-private`},t?Zn:`${Zn} ${Vs}`)}}var Xs=(e,t)=>t.find(n=>n.arm===e.arm&&n.ask===e.ask);document.head.append(Object.assign(document.createElement("style"),{textContent:It}));for(let e of document.querySelectorAll(".arm-judge"))Y.push(Kn(e));if(Y.some(({given:e})=>!e))oe("page");else for(let{stub:e}of Y)e.addEventListener("focusin",()=>oe("page"),{once:!0});ke({"and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","unknown symbol":"{arm}: no value for {name}; known are {known}. Give values={'{name}': ...} if it is a length of yours","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what}: NaN or infinity stands among the numbers; expected {wanted}",ragged:"{what} has rows of {widths} entries; expected rows of one length",row:"row {row}","taken: counted on":"symbols numbered on past what does not move: 1, 2, 3 ... are joints {joints}","taken: from zero":"symbols numbered from 0: 0, 1, 2 ... are joints {joints}"});return nr(Qs);})();
