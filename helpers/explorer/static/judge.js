var ArmJudge=(()=>{var pe=Object.defineProperty;var $n=Object.getOwnPropertyDescriptor;var jn=Object.getOwnPropertyNames;var vn=Object.prototype.hasOwnProperty;var b=(e,t)=>{for(var n in t)pe(e,n,{get:t[n],enumerable:!0})},Mn=(e,t,n,r)=>{if(t&&typeof t=="object"||typeof t=="function")for(let o of jn(t))!vn.call(e,o)&&o!==n&&pe(e,o,{get:()=>t[o],enumerable:!(r=$n(t,o))||r.enumerable});return e};var An=e=>Mn(pe({},"__esModule",{value:!0}),e);var es={};b(es,{kit:()=>mn});var be={};b(be,{ArmError:()=>h,learn:()=>fe,listed:()=>he,lower:()=>V,quoted:()=>we,say:()=>x,shown:()=>X,size:()=>Sn,spelled:()=>Y,tuple:()=>ge});var de={},fe=e=>{de={...de,...e}};function x(e,t={}){let n=de[e];for(let[r,o]of Object.entries(t))n=n.replaceAll(`{${r}}`,()=>String(o));return n}var h=class extends Error{},he=(e,t="and")=>e.length===1?e[0]:`${e.slice(0,-1).join(", ")} ${t} ${e.at(-1)}`,V=e=>/^.(\p{Lu}|_)/su.test(e)?e:e.slice(0,1).toLowerCase()+e.slice(1);function Sn(e,t=3){if(!Number.isFinite(e))return Number.isNaN(e)?"nan":e>0?"inf":"-inf";if(e===0)return"0";let[n,r]=En(e,t).split("e"),o=Number(r),s=a=>a.includes(".")?a.replace(/\.?0+$/,""):a;return o<-4||o>=t?`${s(n)}e${ft(o)}`:s((+`${n}e${r}`).toFixed(Math.max(0,t-1-o)))}function En(e,t){let n=e.toExponential(t-1),[r,o]=e.toExponential(t+25).split("e"),s=t===1?r.indexOf("."):r.indexOf(".")+t,a=r.slice(s).replace(".",""),i=r.slice(0,s);return/^50*$/.test(a)&&"02468".includes(i.at(-1))?`${i}e${o}`:n}var ft=e=>`${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;function Y(e){let[t,n]=e.toExponential().split("e"),r=Number(n);if(e!==0&&(r<-4||r>=16))return`${t}e${ft(r)}`;let o=BigInt(Math.trunc(e)).toString();return r>20?o:String(e).includes("e")?e.toFixed(20).replace(/0+$/,""):String(e)}function X(e){let t=e.includes("'")&&!e.includes('"')?'"':"'",n={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},r=[...e].map(s=>n[s]??On(s)).join(""),o=[...`${t}${r}${t}`];return o.length<=80?o.join(""):`${o.slice(0,77).join("")}...`}function On(e){let t=e.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(e)||e===" "?e:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var ge=e=>e.length===1?`(${e[0]},)`:`(${e.join(", ")})`;function we(e){return e.includes(`
`)&&!/"""|["\\]$/.test(e)&&!/[\r\0]/.test(e)?`r"""${e}"""`:JSON.stringify(e)}var ht=`.arm-judge {
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
`;var xe={};b(xe,{judges:()=>I});var I=[];var Ne={};b(Ne,{KINDS:()=>bt,LARGEST:()=>Se,LONGEST:()=>Ae,MOST_ROWS:()=>Me,TYPED:()=>xt,carriedOver:()=>jt,fits:()=>vt,homeOf:()=>Bn,limited:()=>Gn,outside:()=>Un,range:()=>qn,reachOf:()=>Hn,rowsFault:()=>Ee,sameRow:()=>$t,typedArm:()=>Oe});var ve={};b(ve,{GRAVITY:()=>kn,cosSin:()=>ye,cross:()=>je,dot:()=>Tn,gravityTorque:()=>zn,jacobianColumns:()=>In,joints:()=>g,liftedEnergy:()=>Fn,linkFrames:()=>Rn,matrix:()=>Ln,minus:()=>$e,norm:()=>_n,plus:()=>Q,scaled:()=>gt,wrenchTorque:()=>Pn});var kn=9.81,Tn=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],gt=(e,t)=>[e*t[0],e*t[1],e*t[2]],Q=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],$e=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],je=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],_n=e=>Math.sqrt(e.reduce((t,n)=>t+n*n,0)),O=(e,t,n,r)=>[e*t[0]+n*r[0],e*t[1]+n*r[1],e*t[2]+n*r[2]];function ye(e){let t=e/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(e),Math.sin(e)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var g=e=>e.rows.flatMap((t,n)=>t.kind==="fixed"?[]:[n]);function Rn(e,t){let[n,r,o,s]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:n,y:r,z:o,o:s}],i=0;for(let c of e.rows){let l=c.kind==="fixed"?0:t[i++],[u,m]=ye(c.kind==="revolute"?c.theta+l:c.theta),[d,w]=ye(c.alpha),$=c.kind==="prismatic"?c.d+l:c.d;[n,r]=[O(u,n,m,r),O(u,r,-m,n)],s=Q(O($,o,c.a,n),s),[r,o]=[O(d,r,w,o),O(d,o,-w,r)],a.push({x:n,y:r,z:o,o:s})}return a}var Ln=({x:e,y:t,z:n,o:r})=>[0,1,2].map(o=>[e[o],t[o],n[o],r[o]]).concat([[0,0,0,1]]);function In(e,t,n=t.at(-1).o){return g(e).map(r=>{let{z:o,o:s}=t[r];return e.rows[r].kind==="revolute"?[...je(o,$e(n,s)),...o]:[...o,0,0,0]})}function zn(e,t,n=9.81){let r=wt(e,t);return g(e).map(o=>{let{z:s,o:a}=t[o],i=c=>e.rows[o].kind==="revolute"?je(s,$e(c,a))[2]:s[2];return r.reduce((c,{mass:l,centre:u,row:m})=>c+(m<o?0:l*n*i(u)),0)})}var Fn=(e,t,n=9.81)=>wt(e,t).reduce((r,{mass:o,centre:s})=>r+o*n*s[2],0),wt=(e,t)=>e.rows.flatMap((n,r)=>n.body?[Cn(n.body,t[r+1],r)]:[]);function Cn([e,...t],{x:n,y:r,z:o,o:s},a){return{mass:e,row:a,centre:Q(s,Q(O(t[0],n,t[1],r),gt(t[2],o)))}}var Pn=(e,t)=>e.map(n=>n.reduce((r,o,s)=>r+o*t[s],0));var bt=["revolute","prismatic","fixed"],Me=16,Ae=100,Se=1e3,xt="Your arm",yt=[["a",Ae],["alpha",Se],["d",Ae],["theta",Se]];function Ee(e){if(!Array.isArray(e)||!e.length)return"the table has no rows";if(e.length>Me)return`the table has ${e.length} rows; ${Me} are the most`;for(let[t,n]of e.entries()){if(!bt.includes(n?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[r,o]of yt){if(!Number.isFinite(n[r]))return`row ${t+1} has no number for ${r}`;if(Math.abs(n[r])>o)return`row ${t+1} has ${n[r]} for ${r}; ${o} is the most`}}return null}var Dn=({kind:e,a:t,alpha:n,d:r,theta:o})=>({kind:e,a:t,alpha:n,d:r,theta:o,lower:null,upper:null,speed:null,effort:null}),$t=(e,t)=>e.kind===t.kind&&yt.every(([n])=>Math.abs(e[n]-t[n])<1e-12);function Oe(e,t){if(e.length===t.rows.length&&e.every((r,o)=>$t(r,t.rows[o])))return t;let n={name:xt,home:[],rows:e.map(Dn)};return{...n,home:jt(t,t.home,n,r=>r)}}function jt(e,t,n,r){let o=new Map(g(e).map((s,a)=>[s,[e.rows[s].kind,t[a]??0]]));return g(n).map(s=>{let[a,i]=o.get(r(s))??[];return a===n.rows[s].kind?i:0})}var Bn=e=>vt(e,e.home)?[...e.home]:g(e).map(()=>0),vt=(e,t)=>Array.isArray(t)&&t.length===g(e).length&&t.every(Number.isFinite);function qn(e){let t=e.kind==="revolute"?Math.PI:1;return[e.lower??-t,e.upper??t]}var Un=(e,t)=>t<(e.lower??-1/0)-1e-9||t>(e.upper??1/0)+1e-9,Gn=e=>g(e).some(t=>e.rows[t].lower!==null||e.rows[t].upper!==null),Hn=e=>e.rows.reduce((t,n)=>t+Math.abs(n.a)+Math.abs(n.d)+(n.kind==="prismatic"?Math.abs(n.upper??.3):0),0)||.3;var ke={};b(ke,{attribute:()=>Kn,calm:()=>Vn,h:()=>p,indexed:()=>Jn,svg:()=>Wn,whereNew:()=>Zn,write:()=>z});function p(e,t={},...n){let[r,...o]=e.split("."),s=document.createElement(r);o.length&&(s.className=o.join(" "));for(let[a,i]of Object.entries(t))a.startsWith("on")?s.addEventListener(a.slice(2),i):i!==void 0&&i!==!1&&s.setAttribute(a,i===!0?"":i);return s.append(...n.flat()),s}function Wn(e,t={},...n){let r=document.createElementNS("http://www.w3.org/2000/svg",e);for(let[o,s]of Object.entries(t))r.setAttribute(o,s);return r.append(...n),r}function z(e,t){e.textContent!==t&&(e.textContent=t)}function Kn(e,t,n){e.getAttribute(t)!==n&&e.setAttribute(t,n)}function Zn(e,t){let n=[];return r=>{let o=e(r);n.length&&o.every((s,a)=>s===n[a])||(n=o,t(r))}}var Jn=(e,t)=>[p("i",{},e),p("sub",{},String(t))],Vn=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var ot={};b(ot,{ASKED:()=>y,CHOICES:()=>Qe,EMPTY:()=>L,LONGEST_ANSWER:()=>tn,OWN:()=>S,UNITS:()=>R,armOf:()=>nt,asPython:()=>wo,fromFragment:()=>tt,judge:()=>rt,toFragment:()=>et});var y={jacobian:{title:"Jacobian at a pose",fields:["q","unit","frame","first"],script:"jacobian"},torques:{title:"Joint torques at a pose",fields:["q","unit","wrench"],script:"jacobian"},table:{title:"Denavit-Hartenberg table",fields:["columns","lengths","angles","convention"],script:"table"},branches:{title:"All joint angles for a target",fields:["target","unit"],script:"motion"},pose:{title:"Joint angles for one pose",fields:["target","unit"],script:"motion"},trace:{title:"Joints along a circle",fields:["q","unit","radius","plane","period","steps","pace"],script:"motion",longest:5e6}};var Je={};b(Je,{eachJoint:()=>We,inRadians:()=>Ze,lookup:()=>Yr,numbered:()=>Ge,numbers:()=>Yt,pose:()=>Ke,poseFault:()=>Qt,rowsInRadians:()=>to,turning:()=>W,variables:()=>He});var Ie={};b(Ie,{HALF:()=>St,HAND:()=>Et,RIGHT:()=>te,ROUNDED:()=>ne,SLOPPY:()=>Ot,SO_FAR:()=>F,TELLING:()=>Nt,WRONG:()=>_e,bands:()=>rr,beyond:()=>sr,decimalsOf:()=>tr,farthest:()=>Le,generous:()=>kt,graded:()=>or,margins:()=>nr,units:()=>C});var[te,F,ne,_e]=["right","so far","rounded","wrong"],St=.51,Et=3.01,Yn=1e-6,Ot=.001,Nt=.0021,Xn=13,Mt=-12,Qn=/^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/,At=e=>+`1e${e}`;function er(e){let t=Qn.exec(e.trim());if(!t||!(t[1]||t[2]))return null;let n=(t[1]+t[2]).replace(/^0+/,"").length,r=t[2].length-Number(t[3]??0);return{decimals:r,digits:n,first:n-1-r}}function C(e){let t=e.map(er),n=t.filter(i=>i&&i.digits&&i.first>Mt),r=i=>n.reduce((c,l)=>Math.max(c,l[i]),n.length?-1/0:0),[o,s]=[r("decimals"),r("digits")];if(s>=Xn||t.includes(null)&&o<=0)return e.map(()=>0);let a=n.every(i=>i.decimals<=s-1-i.first)&&n.some(i=>i.digits===s&&i.decimals<o);return t.map(i=>i?!a||!i.digits||i.first<=Mt?At(-o):At(Math.max(-o,i.first-s+1)):0)}function tr(e){let t=e.filter(n=>n>0);return t.length?Math.max(0,Math.round(-Math.log10(Math.min(...t)))):null}function nr(e,t,n=null,r=null){let o=t.map(l=>Yn*l),s=e.map(()=>0);if(r!==null){let l=o.map(u=>Math.max(r,u*.001));return{allowed:l,band:l,loose:l,units:s,slop:s}}let a=e.map((l,u)=>Math.max(St*l,o[u])),i=e.map((l,u)=>Math.max(Et*l,o[u])),c=i.map((l,u)=>Math.max(l,Ot*t[u]));return{allowed:a,band:i,loose:c,units:e,slop:n??s}}var Re=(e,t,n)=>e.map((r,o)=>r+n*t[o]),Le=({loose:e,band:t,slop:n})=>Re(t,n,2).map((r,o)=>Math.max(r,e[o])),kt=({allowed:e,slop:t})=>Re(e,t,1);function rr(e){let t=e.slop.some(Boolean)?[Re(e.band,e.slop,2)]:[];return[e.band,...t,Le(e),e.allowed]}var Te=(e,t,n)=>e.every((r,o)=>Math.abs(r-t[o])<=n[o]),ee=(e,t)=>e.reduce((n,r,o)=>Math.max(n,Math.abs(r-t[o])),0);function or(e,t,n,r){let o=r.filter(a=>ee(a,t)>Nt);for(let a of[n.allowed,kt(n)]){let i=o.some(c=>Te(e,c,a));if(Te(e,t,a)){let c=Math.max(0,...n.units),l=o.reduce((u,m)=>Math.min(u,ee(m,t)),1/0);return i||c>l/2.1?F:te}if(i)return _e}if(!Te(e,t,Le(n)))return _e;let s=ee(e,t);return o.some(a=>ee(e,a)<=s)?F:ne}function sr(e,t,{band:n,allowed:r}){let o=a=>e.map((i,c)=>Math.abs(i-t[c])>a[c]),s=o(n);return s.includes(!0)?s:o(r)}var Ce={};b(Ce,{isNumber:()=>oe,number:()=>q,parse:()=>k,plain:()=>N,symbols:()=>T,value:()=>_});var Tt=2e4,Rt=60,P=Math.PI/180,Lt={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:e=>e*P,deg2rad:e=>e*P,degrees:e=>e*(180/Math.PI),rad2deg:e=>e*(180/Math.PI),sind:e=>Math.sin(e*P),cosd:e=>Math.cos(e*P),float:e=>e,Float:e=>e,Integer:e=>e,float64:e=>e,float32:e=>e,int64:e=>e},It={pi:Math.PI,deg:P,rad:1},ar=e=>Object.hasOwn(Lt,e),zt=e=>Object.hasOwn(It,e),j=(e,t)=>[...e].map(n=>[n,t]),ir="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),cr=new Map([...j("−–—‐‑‒﹣－","-"),...j("×⋅·∙∗","*"),...j("÷∕⁄","/"),...j("       　"," "),...j("​⁡⁢\uFEFF",""),...j("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((e,t)=>j(e,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((e,t)=>j(e,` ${ir[t]}`)),...j("π𝜋"," pi "),...j("°º"," deg"),["$"," "],["²","^2"],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),lr=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)\b/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text|mathit|mathbf|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)\b/g," deg"],[/\\(?:cdot|times|ast)\b/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/\\d?t?frac\s*(\d)\s*(\d)/g,"(($1)/($2))"]],ur=/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,mr=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,pr=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,ze=new RegExp(String.raw`\s*(?:(${mr})|(${pr})|(\*\*|[-+*/^()]))`,"y"),dr=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,fr=/[cs]_?(?:\d|\{[\d+-]+\})+/g,hr=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,oe=e=>hr.test(e);function N(e){if(oe(e))return e;e=[...e].map(t=>cr.get(t)??t).join("");for(let[t,n]of lr)e=e.replace(t,n);for(let t="";t!==e;)[t,e]=[e,e.replace(ur,"(($1)/($2))")];return e=e.replace(/\\([A-Za-z]+)/g," $1 "),e=e.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),e=e.replace(/(?<=\w)\s*\(t\)/g,""),e=e.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),e=e.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),e=e.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),e.replace(/[ \t]+/g," ").trim()}function k(e,t="the formula"){if(e.length>Tt)throw new h(`${t} has ${e.length} characters; expected at most ${Tt}`);let n=wr(N(e));if(!n)throw new h(`${t} is ${X(e)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let r=gr(n);if(r?.[1]!==n.length)throw new h(`${t} is ${X(e)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return r[0]}var M=class extends Error{};function gr(e){try{return Ft(e,0,0)}catch(t){if(t instanceof M)return null;throw t}}function wr(e){let t=[];for(let n=0;n<e.length;n=ze.lastIndex){ze.lastIndex=n;let r=ze.exec(e);if(!r)return e.slice(n).trim()?null:t;let[,o,s,a]=r;if(o!==void 0)t.push(["num",o]);else if(a!==void 0)t.push(["sign",a==="**"?"^":a]);else for(let i of dr.test(s)?s.match(fr):[s])t.push(["name",i])}return t}function re(e,t){if(t>=e.length)throw new M;return e[t]}function Ft(e,t,n){if(n>Rt)throw new M;let[r,o]=_t(e,t,n);for(;o<e.length&&["+","-"].includes(e[o][1]);){let[s,a]=_t(e,o+1,n);[r,o]=[[e[o][1],r,s],a]}return[r,o]}function _t(e,t,n){let[r,o]=B(e,t,n);for(;o<e.length;){let[s,a]=e[o];if(a==="*"||a==="/"){let[i,c]=B(e,o+1,n);[r,o]=[[a,r,i],c]}else if(a==="("||s!=="sign"){let[i,c]=Ct(e,o,n);[r,o]=[["*",r,i],c]}else break}return[r,o]}function B(e,t,n){if(n>Rt)throw new M;let r=re(e,t)[1];if(r==="-"){let[o,s]=B(e,t+1,n+1);return[["neg",o],s]}return r==="+"?B(e,t+1,n+1):Ct(e,t,n)}function Ct(e,t,n){let[r,o]=Fe(e,t,n);if(o>=e.length||e[o][1]!=="^")return[r,o];let[s,a]=B(e,o+1,n+1);return[["^",r,s],a]}function Fe(e,t,n){let[r,o]=re(e,t);if(r==="num")return[["num",Number(o)],t+1];if(r==="name"&&ar(o)&&t+1<e.length){let[i,c]=br(e,t+1,n);return[["call",o,i],c]}if(r==="name")return[["name",o],t+1];if(o!=="(")throw new M;let[s,a]=Ft(e,t+1,n+1);if(re(e,a)[1]!==")")throw new M;return[s,a+1]}function br(e,t,n){if(re(e,t)[1]!=="-")return Fe(e,t,n);let[r,o]=Fe(e,t+1,n);return[["neg",r],o]}function T(e,t=new Set){if(e[0]==="name")return zt(e[1])?t:t.add(e[1]);for(let n of e.slice(1))Array.isArray(n)&&T(n,t);return t}function _(e,t){let n=D(e,t);if(!Number.isFinite(n))throw new h("a formula divides by zero or is too large; expected a finite value");return n}function D(e,t){let[n,r,o]=e;if(n==="num")return r;if(n==="name"){let c=zt(r)?It[r]:t(r);if(c===void 0)throw new h(`no value for ${r}`);return c}if(n==="neg")return-D(r,t);if(n==="call")return Lt[r](D(o,t));let[s,a]=[D(r,t),D(o,t)];if(n==="+")return s+a;if(n==="-")return s-a;if(n==="*")return s*a;if(n==="/")return a===0?NaN:s/a;let i=s**a;return Number.isFinite(i)||!Number.isFinite(s)?i:NaN}function q(e){try{return _(k(e),()=>{})}catch(t){if(t instanceof h)return null;throw t}}var Ue={};b(Ue,{cells:()=>G,withoutHeader:()=>qe});var xr=/(?<![^\n])[ \t]*```[^\n\r]*/g,Pt=String.raw`(?<![^\n])[ \t]*(?:>>>?|(?:In|Out) ?\[[0-9]*\]:)[ \t]*`,yr=new RegExp(Pt+String.raw`(?:[A-Za-z_][A-Za-z0-9_]*|(?:print|disp|display)\([A-Za-z0-9_]*\))[ \t]*(?![^\n\r])`,"g"),$r=new RegExp(Pt,"g"),jr=/((?<![^\n])|[;,\]]|\.\.\.|\\\\)[ \t]*[#%][^\n\r]*/g,vr=/^[ \t\r\n]*[A-Za-z_][A-Za-z0-9_]*[ \t]*:[ \t\r\n]*(?=[[({])/,Mr=/^[ \t\r\n]*=[ \t]*(?=[[({])/,Ar=String.raw`\{(?:[A-Za-z]*matrix\*?|array|tabular)\}`,[Sr,Er]=["begin","end"].map(e=>new RegExp(String.raw`\\${e}${Ar}`,"g")),Or=new RegExp(String.raw`\\begin\{[a-z]+\*?\}|\\label\{[^{}]*\}`+String.raw`|\\(?:displaystyle|scriptsize|footnotesize|small|tiny|boxed|left[ \t]*[\[(|.]|\[|\()`+String.raw`|[$&{ \t\r\n]`,"g"),Nr=/\\end\{[a-z]+\*?\}|\\label\{[^{}]*\}|\\(?:right[ \t]*[\])|.]|\]|\))|[$}.,; \t\r\n]/g,kr=/^[^=0-9][^=]*=$/,Tr=[[/\\[hv]?phantom\{[^{}]*\}/g," "],[/\\num\{([^{}]*)\}/g,"$1"],[/\{([-+])\}/g,"$1"],[/(?<=[0-9])\{,\}(?=[0-9])/g,"."]],Dt=e=>e.replace(xr,"").replace(jr,"$1").replace(yr,"").replace($r,"").replace(vr,"").replace(Mr,"");function Bt(e){let[t,n]=[Sr,Er].map(r=>[...e.matchAll(r)]);if(t.length===1&&n.length===1){let[r,o]=[t[0].index,n[0].index+n[0][0].length],s=e.slice(0,r).replace(Or,""),a=e.slice(o).replace(Nr,""),i=!s||kr.test(s)&&!s.includes("frac");e=e.slice(i?r:0,a?e.length:o)}for(let[r,o]of Tr)e=e.replace(r,o);return e}var qt=5e6,Wt=String.raw`[\p{L}\p{N}_.]`,_r=String.raw`^\s*(?:${Wt}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`,Rr="Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym",Ut=new RegExp(String.raw`${_r}(?:${Wt}*(?:${Rr})\s*\(\s*)+`,"u"),Lr=/\)?(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u,Ir=/^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u,zr=/\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g,Fr=/\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|toprule|midrule|bottomrule|nonumber)\b/g,Cr=/(?:^|[\s[(])-?(?:θ|\\?theta|th|q)_?\{?(?:\d+|i)?\}?\^?\*$|^\s*\*$/,Gt=/^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m,Ht=/^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im,Pr=/^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/,Kt=e=>{let t=e.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);return t.at(-1)===""&&t.pop(),t},Pe=(e,t)=>{let[n,r]=[0,e.length];for(;n<r&&t.includes(e[n]);)n++;for(;r>n&&t.includes(e[r-1]);)r--;return e.slice(n,r)},U=(e,t)=>{let n=e.length;for(;n>0&&t.includes(e[n-1]);)n--;return e.slice(0,n)};function G(e){if(e.length>qt)throw new h(`the text has ${e.length} characters; expected at most ${qt}`);let t=Dr(Pe(Dt(e).trim(),"`$").trim()).filter(n=>n.some(r=>r.trim())).map(n=>n.map(r=>r.trim()));if(!t.length)throw new h("the text is empty; expected rows of numbers or formulas");return t}function Dr(e){if(e.includes("\\begin{")||e.includes("\\\\"))return Br(e);if(e.split("|").length>2&&!e.split("|")[0].includes("["))return qr(e);let t=Ut.test(e)?e.replace(Ut,"").replace(Lr,""):e;return t=U(t.replace(Ir,"").trim(),";").trim(),t&&"[({".includes(t[0])?Zt(t):Gr(t)}function Br(e){return e=Bt(e).replace(/\\left\s*[[(.|]\s*(?=\\begin)/g," ").replace(zr," ").replace(Fr," ").replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u,"").replace(/\\\\\s*\[[^\]]*\]/g,"\\\\").replaceAll("$"," ").replaceAll("\\["," ").replaceAll("\\]"," "),e.split(/\\\\|\\cr\b/).map(t=>t.split("&"))}var qr=e=>Kt(e).map(t=>t.trim()).filter(t=>t.includes("|")&&!/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(t)).map(t=>t.replace(/^\||\|$/g,"").replaceAll("$"," ").split("|"));function Zt(e){let t=se(e);if(t.length===1&&!A(t[0]))return[t];if(t.every(A)){let r=t.map(se);if(!r.some(a=>a.some(A)))return r;let o=a=>A(a)&&se(a).length===1?se(a)[0]:a,s=r.map(a=>a.map(o));return s.some(a=>a.some(A))?t.flatMap(Zt):s}let n=A(e)?e.trim().slice(1,-1):e;return A(e)&&/[;\n]/.test(n)&&!n.includes("[")?n.replace(/\.\.\.[^\n]*\n/g," ").split(/[;\n]/).map(ae):[t]}function A(e){return e=e.trim(),!e||!"[({".includes(e[0])||!Jt(e)?!1:e[0]!=="("||Be(e.slice(1,-1))}var De=e=>"[({".includes(e)?1:"])}".includes(e)?-1:0;function Jt(e){let t=0;for(let n=0;n<e.length;n++)if(t+=De(e[n]),!t)return n===e.length-1;return!1}function Be(e){let t=0;for(let n=0;n<e.length;n++)if(t+=De(e[n]),e[n]===","&&!t)return!0;return!1}function se(e){return e=U(e.trim(),","),ae(A(e)||e[0]==="["&&Jt(e)?e.slice(1,-1):e)}function ae(e){let t=e.trim().split(/\s+/);if(t.every(oe))return t;let n=[],[r,o]=[0,""],s=Be(e);for(let a=0;a<e.length;a++){let i=e[a];r+=De(i),(s?i===",":/\s/.test(i)&&!Ur(e,a))&&!r?(n.push(o),o=""):o+=i,!s&&!r&&i==="]"&&(n.push(o),o="")}return n.push(o),n.filter(a=>a.trim()).map(a=>Pe(a.trim(),`'"`))}function Ur(e,t){let[n,r]=[e.slice(0,t).trimEnd(),e.slice(t).trimStart()];return n.endsWith("*")&&r&&!"*/^)=".includes(r[0])&&Cr.test(n)?!1:!n||!r||"+-*/^=(".includes(n.at(-1))||"*/^)=".includes(r[0])?!0:"+-".includes(r[0])&&r.length>1&&/\s/.test(r[1])||r.startsWith("deg")||r[0]==="°"}function Gr(e){let t=Gt.exec(e);e=e.replace(new RegExp(Gt,"gm"),"");let r=(Ht.test(e)?e.split(new RegExp(Ht,"gim")).filter(s=>s.trim()):[e]).map(Hr),o=r[0];return r.length>1&&r.every(s=>s.length===o.length)&&(o=o.map((s,a)=>r.flatMap(i=>i[a]))),t?o.map(s=>s.map(a=>q(a)?`${a}*${t[1]}`:a)):o}function Hr(e){let t=Kt(e).filter(o=>o.trim()&&!Pr.test(o)).filter(o=>!/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(o)),n=o=>t.some(s=>U(s.trim(),";").includes(o)),r=["	",";"].find(n);if(r){let o=s=>U(Pe(s,`\r
 `),r);return t.map(s=>o(s).split(r).map(Kr))}return t.some(Be)?Wr(t):t.map(o=>ae(o.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g,"")))}function Wr(e){let t=e.every(n=>/^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(n));return e.map(n=>ae(t?n.replaceAll(",","."):U(n,",")))}function Kr(e){let t=e.trim();return t[0]==='"'&&t.at(-1)==='"'&&(e=t.slice(1,-1)),e=e.replace(/^[ \t]*=/,""),e.split(",").length===2&&!e.includes("(")?e.replace(/(?<=\d),(?=\d)/g,"."):e}var Zr=e=>e.every(t=>t.every(n=>q(n)!==null));function qe(e){let[t,...n]=e,r=t.map(N).filter(Boolean);return n.length>0&&r.every(s=>q(s)===null)&&Zr(n)?n:e}var Jr=/^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/,Vt=/^([cs])((?:[+-]?\d)+)$/i,Vr=/^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/,Ge=e=>g(e).map(t=>t+1),W=e=>g(e).map(t=>e.rows[t].kind==="revolute"),He=e=>Ge(e).map(t=>`q_${t}`);function Yr(e,t){let n=[];return{known:o=>{let[s,a]=no([...o].sort(),e,t);for(let i of a)n.includes(i)||n.push(i);return s},said:n}}var Xr=e=>{if(e.size)throw new h(x("symbols for numbers",{names:[...e].sort().join(", ")}));return new Map};function Yt(e,t,n=Xr,r="numbers"){if(typeof e=="string")return Qr(e,t,n);let o=Xt(e),s=e.flat(1/0);if(!s.every(Number.isFinite))throw new h(x("not finite",{what:t,wanted:r}));return{values:s,units:C(s.map(Y)),shape:o,symbolic:!1}}var Xt=e=>Array.isArray(e)?[e.length,...e.length?Xt(e[0]):[]]:[];function Qr(e,t,n){let r=qe(G(e)),o=[...new Set(r.map(d=>d.length))].sort((d,w)=>d-w);if(o.length>1)throw new h(x("ragged",{what:t,widths:o.join(", ")}));let s=r.flat().map(N),a=s.map(d=>k(d,`an entry of ${t}`)),i=new Set;for(let d of a)T(d,i);let c=n(i),l=a.map(d=>_(d,w=>c.get(w))),u=s.map(eo),m=C(u.map(([d])=>d)).map((d,w)=>d*u[w][1]);return{values:l,units:m,shape:[r.length,o[0]],symbolic:i.size>0}}function eo(e){let t=Vr.exec(e);return t?[t[1],Number(t[2])]:[e,1]}var We=e=>`one value for each of ${He(e).join(", ")}`;function Ke(e,t,n="rad"){let r=Yt(e,`${t.name}: q`,void 0,We(t)),o=typeof e=="string"?[r.values.length]:r.shape,s=g(t).length;if(o.length!==1||o[0]!==s)throw new h(Qt(t,o,`one pose, (${s},)`));return Ze(r,t,n)}function Qt(e,t,n){let r=ge(t);return`${e.name}: q has shape ${r}; expected ${n}, ${We(e)}`}function Ze(e,t,n){let r=W(t),o=s=>n==="deg"&&r[s%r.length]?Math.PI/180:1;return{...e,values:e.values.map((s,a)=>s*o(a)),units:e.units.map((s,a)=>s*o(a))}}function to(e,t){let n=W(t),r=n.some(Boolean)&&!n.every(Boolean),o=r?C(e.flatMap(({values:i})=>i.filter((c,l)=>n[l])).map(Y)):[],s=0,a=(i,c)=>{if(!r||!n[c])return i;let l=o[s++];return i>0?Math.max(l,i):i};return e.map(i=>Ze({...i,units:i.units.map(a)},t,"deg"))}var H=e=>e.replace(/\(t\)|[_{}'*^\\ ]/g,"").replace(/[ϑθ]/g,"theta").toLowerCase();function no(e,t,n){let r=new Map((t.values??[]).map(([c,l])=>[H(c),l])),o=new Map(e.filter(c=>r.has(H(c))).map(c=>[c,r.get(H(c))])),s=new Map(e.filter(c=>!o.has(c)).map(c=>[c,ro(c)])),[a,i]=oo([...new Set([...s.values()].flatMap(c=>c??[]))],t);for(let[c,l]of s){let u=(l??[]).map(m=>a.get(m));if(!u.length||u.includes(void 0)){let m=[...He(t),...(t.values??[]).map(([d])=>d)].join(", ");throw new h(x("unknown symbol",{arm:t.name,name:c,known:m}))}o.set(c,so(H(c),u.map(m=>n[m])))}return[o,i]}function ro(e){let t=H(e),n=Jr.exec(t);if(n)return[Number(n[2])];let r=Vt.exec(t);return r?[...r[2].matchAll(/\d/g)].map(Number):null}function oo(e,t){let n=Ge(t),r=new Map(n.map((a,i)=>[a,i])),o=a=>e.every(i=>i>=a&&i<a+n.length);if(e.every(a=>r.has(a)))return[r,[]];let s=a=>new Map(n.map((i,c)=>[c+a,c]));return o(1)?[s(1),[x("taken: counted on",{joints:n.join(", ")})]]:o(0)?[s(0),[x("taken: from zero",{joints:n.join(", ")})]]:[r,[]]}function so(e,t){let n=Vt.exec(e);if(!n)return t[0];let r=[...n[2].matchAll(/([+-]?)\d/g)].map(([,s])=>s==="-"?-1:1),o=t.reduce((s,a,i)=>s+r[i]*a,0);return e[0]==="c"?Math.cos(o):Math.sin(o)}var Xe={};b(Xe,{checkerOf:()=>ce,load:()=>K,ready:()=>Ye,register:()=>io});var Ve=new Map,ie=new Map,ao=typeof document>"u"?null:document.currentScript?.src,io=(e,t)=>{Ve.set(e,t)},ce=e=>Ve.get(e),Ye=e=>Ve.has(e)?Promise.resolve():K(y[e].script);function K(e){return ie.has(e)||ie.set(e,co(e)),ie.get(e)}function co(e){return new Promise((t,n)=>{let r=()=>{ie.delete(e),n(new Error(`The script judge-${e}.js could not be loaded.`))},o=new URL(`judge-${e}.js`,ao).href;document.head.append(Object.assign(document.createElement("script"),{src:o,onload:()=>t(),onerror:r}))})}var en=12e3,lo={table:2e3,q:500,wrench:300,answer:8e3,target:1e3},tn=2e4,uo="the arm asked about",S="own",R=["rad","deg"],Qe={unit:R,first:["v","omega"],plane:["zy","yz","zx","xz"],pace:["even","rest"],lengths:["","m","cm","mm"],angles:["",...R],convention:["","standard","craig"]},L={ask:"jacobian",arm:"",table:"",q:"",unit:"rad",frame:"0",first:"v",wrench:"",answer:"",columns:"",lengths:"",angles:"",convention:"",target:"",radius:"0.1",plane:"zy",period:"5",steps:"",pace:"even"};function et(e){let t=Object.entries(e).filter(([n,r])=>r!==L[n]||n==="ask"||n==="arm");return`#${new URLSearchParams(t)}`}function tt(e,t){let n=e.replace(/^#/,"");if(!/^ask=/.test(n))return{question:null,words:""};let r=i=>({question:null,words:`The link could not be read: ${i}.`});if(n.length>en)return r(`it has ${n.length} characters; ${en} are the most`);let o=new URLSearchParams(n),s={...L};for(let[i,c]of o){if(!Object.hasOwn(L,i))return r(`it has a field “${i.slice(0,40)}”`);if(c.length>(lo[i]??40))return r(`its ${i} is too long`);s[i]=c}if(!Object.hasOwn(y,s.ask))return r("it asks what is not judged here");if(s.arm!==S&&!t.includes(s.arm))return r(`there is no arm called “${s.arm}” here`);let a=Object.keys(Qe).find(i=>!Qe[i].includes(s[i]));return a?r(`its ${a} is none`):/^\d{1,2}$/.test(s.frame)?{question:s,words:""}:r("its frame is none")}function nt(e,t){if(e.arm!==S)return t.find(({key:o})=>o===e.arm);if(!e.table.trim())throw new h("Type the table of your arm: a row for each joint, a α d θ.");let n=G(e.table).filter((o,s)=>s||!o.some(a=>/^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(a))).map((o,s)=>fo(o.length===5?o.slice(1):o,s+1,e.unit)),r=Ee(n);if(r)throw new h(`${r}.`);return{...Oe(n,{name:"",home:[],rows:[]}),name:uo}}var mo=["a","alpha","d","theta"],po=/^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;function fo(e,t,n){if(e.length!==4)throw new h(`Row ${t} of the table has ${e.length} entries; expected four: a α d θ.`);let r=e.map((u,m)=>k(u||"0",`row ${t}, ${mo[m]}`)),o=r.map(u=>[...T(u)]),s=o.flatMap((u,m)=>u.filter(d=>m<2||!po.test(d)));if(s.length)throw new h(`Row ${t} of the table: no value for ${s[0]}; write numbers, and a variable such as q1.`);let[a,i,c,l]=r.map((u,m)=>{let d=n==="deg"&&m%2&&!/deg|°|pi|π/.test(e[m]);return _(u,()=>0)*(d?Math.PI/180:1)});return{kind:o[2].length?"prismatic":"revolute",a,alpha:i,d:c,theta:l}}function rt(e,t){try{let n=nt(e,t),r=ho(e,n);if(r)return{error:r,arm:n};let o=nn(e)?Ke(e.q,n,e.unit).values:void 0;if(!e.answer.trim())return{error:"Type or paste your answer.",arm:n,q:o};let s=y[e.ask].longest??tn;if(e.answer.length>s)return{error:`The answer is longer than ${s} characters.`,arm:n,q:o};let a=ce(e.ask);return a?{report:a.verdict(e,n),arm:n,q:o}:{error:"The checker is being loaded.",waiting:!0,arm:n,q:o}}catch(n){if(n instanceof h)return{error:go(n.message)};throw n}}var nn=({ask:e})=>y[e].fields.includes("q"),ho=(e,t)=>nn(e)&&!e.q.trim()?`Type the pose: ${g(t).length} joint values.`:null,go=e=>e.slice(0,1).toUpperCase()+e.slice(1);function wo(e,t){let n=nt(e,t),[r,o]=e.arm===S?["arm",xo(n)]:[n.python,bo(n.python)],{call:s,imports:a=[]}=ce(e.ask),i=[...o,...a,"from helpers import checks",""];return e.arm===S&&i.push(...yo(n),""),i.push(`mine = ${we(e.answer)}`,`print(${s(e,r,n)})`),`${i.join(`
`)}
`}var bo=e=>[`from helpers.robots import ${/^\w+/.exec(e)[0]}`],rn={revolute:"revolute",prismatic:"prismatic",fixed:"fixed"},xo=e=>[`from helpers.arm import Arm, ${[...new Set(e.rows.map(({kind:t})=>rn[t]))].sort().join(", ")}`],yo=e=>["rows = [",...e.rows.map(({kind:t,a:n,alpha:r,d:o,theta:s})=>`    ${rn[t]}(a=${n}, alpha=${r}, d=${o}, theta=${s}),`),"]",`arm = Arm("${e.name}", rows)`];var it={};b(it,{MARKS:()=>at,better:()=>To,both:()=>on,cause:()=>vo,complete:()=>No,explain:()=>So,explainAll:()=>an,linesOf:()=>le,nameOf:()=>Mo,several:()=>ko,textOf:()=>_o,wordsOf:()=>sn});var $o=.6,jo=.85,st=.7,vo=(e,t={})=>({keys:[e],fields:[t]}),on=(e,t)=>({keys:[...e.keys,...t.keys],fields:[...e.fields,...t.fields]}),Mo=({keys:e,fields:t})=>e.map((n,r)=>Ao(n,t[r])).join(" + ");function Ao(e,t){if("_of"in t)return t._of;let n=Object.entries(t).filter(([r])=>!r.startsWith("_"));return[e,...n.map(([,r])=>r)].join(":")}function sn({keys:e,fields:t}){let[n,r]=e.map((o,s)=>x(o,t[s]));return r===void 0?n:x("and also",{first:n,second:V(r)})}var So=(e,t,n,r,o,s=st)=>an(e,t,[n],r.map((a,i)=>[[a],o[i]]),s)[0];function an(e,t,n,r,o=st){let s=n.map(i=>{let c=e.filter((u,m)=>Math.abs(u-t[m])>i[m]).length,l=[Math.max(3,$o*c),Math.max(4,jo*c)];return{band:i,count:c,least:l,named:[]}}),a=0;for(let[i,c]of r){let l=i.length>1?2:i[0].keys.length;for(let{band:u,count:m,least:d,named:w}of s){let $=Eo(e,c,u,m,d[l-1]);($?m-$>=d[l-1]:m>0)&&w.push({k:a,cost:l+o*$,parts:i,A:c})}a++}return s.map(i=>Oo(e,i))}function Eo(e,t,n,r,o){let s=0;for(let a=0;a<e.length;a++)if(!(Math.abs(e[a]-t[a])<=n[a])&&(s++,r-s<o))return s;return s}function Oo(e,{band:t,named:n}){if(!n.length)return null;let r=i=>Math.round(i*1e6);n.sort((i,c)=>r(i.cost)-r(c.cost)||i.k-c.k);let[{cost:o,A:s}]=n;return{causes:n.filter(i=>i.cost===o).map(({parts:i})=>i.reduce(on)),odd:e.map((i,c)=>!(Math.abs(i-s[c])<=t[c]))}}var No=e=>!!e&&!e.odd.includes(!0);function ko(e,t=3){let n=[...new Set(e.map(sn))].slice(0,e[0].keys.length===1?t:1);return n.length===1?n[0]:x("or",{first:n[0],others:he(n.slice(1).map(V),"or")})}function To(e,t=st){let n=r=>r.causes[0].keys.length+t*r.odd.filter(Boolean).length;return e.filter(Boolean).reduce((r,o)=>r&&n(r)<=n(o)?r:o,null)}var at={[te]:"✔",[F]:"◐",[ne]:"≈",wrong:"✘"},le=({headline:e,findings:t,taken:n,notes:r})=>[...t.filter(({what:o,words:s})=>o!=="cause"&&!e.includes(s.slice(1))).map(({words:o})=>o),...n.map(o=>`Taken as ${o}`),...r.map(o=>`Note: ${o}`)],_o=e=>[e.headline,...le(e).map(t=>`- ${t}`)].join(`
`);var ut={};b(ut,{matrixOf:()=>ln,namesOf:()=>cn,showRead:()=>ct,tell:()=>lt,typeset:()=>Z});var Ro={v:["vx","vy","vz","ωx","ωy","ωz"],omega:["ωx","ωy","ωz","vx","vy","vz"]},Lo=40;function cn({ask:e,first:t},n,[r,o]){let s=g(n).map(c=>c+1),a=c=>s.length===o?`joint ${s[c]}`:String(c+1),i={torques:r===1?["τ"]:[],jacobian:r===6?Ro[t]:[]}[e]??[];return{columns:Array.from({length:o},(c,l)=>a(l)),rows:Array.from({length:r},(c,l)=>i[l]??`row ${l+1}`)}}function ln(e,{report:t,arm:n}){let r=t?.typed;if(!r||r.shape.length!==2)return null;let o=e.ask==="torques"&&r.shape[1]===1,[s,a]=o?[1,r.values.length]:r.shape,i=t.wrong?.length===r.values.length?t.wrong:[];return{...cn(e,n,[s,a]),typed:r,wrong:i,shape:[s,a]}}function ct(e,t,n){let{table:r}=n.report??{},o=r?Io(r):zo(ln(t,n));if(e.hidden=!o,!o)return;let{columns:s,rows:a,cell:i}=o,c=p("tr",{},p("td"),s.map(m=>p("th",{scope:"col"},m))),l=a.slice(0,Lo).map((m,d)=>p("tr",{},p("th",{scope:"row"},m),s.map((w,$)=>i(d,$))));e.replaceChildren(p("table",{},p("caption",{},"How your answer is read"),p("thead",{},c),p("tbody",{},l)))}var Io=({cells:e,wrong:t})=>({columns:["a (m)","α","d (m)","θ"],rows:e.map((n,r)=>String(r+1)),cell:(n,r)=>un(Z(e[n][r].replaceAll("-","−")),t[n][r])}),zo=e=>e&&{...e,cell(t,n){let r=t*e.shape[1]+n;return un(Fo(e.typed,r),e.wrong[r])}};function Fo({values:e,units:t},n){let r=Math.min(6,t[n]?Math.max(0,Math.round(-Math.log10(t[n]))):4);return(Number(e[n].toFixed(r))+0).toFixed(r).replace("-","−")}var un=(e,t)=>t?p("td.off",{},p("span.unseen",{},"wrong: "),e):p("td",{},e);function lt(e,{report:t,error:n}){if(e.className=`verdict ${t?.grade??""}`,!t)return e.replaceChildren(p("p",{},Z(n)));let r=le(t).filter(a=>!t.headline.endsWith(a.slice(1))),o=r.length?[p("ul",{},r.map(a=>p("li",{},Z(a))))]:[],s=p("span",{"aria-hidden":"true"},`${at[t.grade]} `);return e.replaceChildren(p("p.headline",{},s,Z(t.headline)),...o)}var Co=/(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g,Po={theta:"θ",alpha:"α"};function Z(e){let t=[],n=0;for(let r of e.matchAll(Co)){let[o,s,a,i]=r;t.push(e.slice(n,r.index),p("i",{},Po[s]??s)),t.push(p("sub",{},(a??i).replace("-","−"))),n=r.index+o.length}return[...t,e.slice(n)]}var mn={"arm.js":Ne,"dom.js":ke,"kinematics.js":ve,"judge/ask.js":ot,"judge/digits.js":Ie,"judge/door.js":Je,"judge/formula.js":Ce,"judge/grid.js":Ue,"judge/judges.js":xe,"judge/ranking.js":it,"judge/registry.js":Xe,"judge/say.js":be,"judge/shown.js":ut};var pn=e=>[["","as it looks"],...e.map(t=>[t,t])],dn={spellcheck:"false",autocomplete:"off",autocapitalize:"off"},Do={table:{label:"Table",rows:6,whole:!0,hint:"A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen."},q:{label:"Pose q",hint:"",whole:!0},unit:{label:"Angles in",choices:R.map(e=>[e,e])},frame:{label:"Rows in the axes of",choices:[]},first:{label:"Order of the rows",choices:[["v","v, then ω"],["omega","ω, then v"]]},wrench:{label:"Wrench on the tool, by the world",whole:!0,hint:"Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down."},columns:{label:"Order of the columns",hint:"As in “theta d a alpha”; guessed where it is empty."},lengths:{label:"Lengths in",choices:pn(["m","cm","mm"])},angles:{label:"Angles in",choices:pn(R)},convention:{label:"Convention",choices:[["","as it looks"],["standard","standard"],["craig","modified (Craig)"]]},target:{label:"Where the tip should be",rows:4,whole:!0,hint:"A point x, y, z in m, or a pose: its three or four rows, in base axes."},radius:{label:"Radius of the circle below the tip, in m"},plane:{label:"Its plane",choices:[["zy","towards +y first"],["yz","towards −y"],["zx","towards +x"],["xz","towards −x"]]},period:{label:"Time for it, in s"},steps:{label:"Steps",hint:"Empty: as many as your answer has."},pace:{label:"Pace",choices:[["even","even"],["rest","from rest to rest"]]},answer:{label:"Your answer",hint:"",rows:8,whole:!0}},Bo={jacobian:"Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",table:"A row for each link, with heads or without: lists, Link(…) lines, MATLAB, LaTeX, Markdown, CSV or cells.",branches:"A row for each answer, angles in the joints' order; names such as theta1 = may stand before them.",pose:"One value for each joint, in the joints' order; names such as theta1 = may stand before them.",trace:"A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",torques:"One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet."},qo=["frame","first","columns","lengths","angles","convention"],hn=([e,t])=>p("option",{value:e},t);function Uo({choices:e,rows:t,hint:n},r,o){let s=n===void 0?{}:{"aria-describedby":[`${r}-hint`,...o].join(" ")},a={id:r,...s};return e?p("select",a,e.map(hn)):t?p("textarea",{rows:t,wrap:"off",...dn,...a}):p("input",{...dn,...a})}function Go(e,t,n){let r=p("label",{for:t},e.label),o=e.hint===void 0?[]:[p("p.about",{id:`${t}-hint`},e.hint)];return p(e.whole?"div.field.whole":"div.field",{},r,n,...o)}function gn(e,t,n){let r={ask:{label:"Question",choices:Object.entries(y).map(([l,{title:u}])=>[l,u])},arm:{label:"Arm",choices:[...t.map(({key:l,title:u})=>[l,u]),...t.length>1&&n?[]:[[S,"My own table"]]]},...Do},o=l=>`${e}-${l}`,s=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Uo(u,o(l),l==="answer"?[o("private")]:[])])),a=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,Go(u,o(l),s[l])]));for(let l of n?Ho(n,t):[])a[l]?.classList.add("given");let i=n?Wo(n,t):"";return n&&(s.answer.rows=6),{form:p("form",{"aria-label":`Check an answer${i&&`: ${i}`}`},i?p("p.asked",{},"Judged here: ",i):[],Object.values(a)),fields:s,boxes:a}}var Ho=(e,t)=>[...Object.keys(e),...qo,...t.length<2?["arm"]:[],..."q"in e?["unit"]:[]];function Wo({ask:e,q:t,wrench:n},r){let o=r.length===1?`, ${r[0].title}`:"";return[`${y[e].title}${o}`,t&&`q = (${t})`,n&&`wrench (${n})`].filter(Boolean).join(", ")}function wn({fields:e,boxes:t},n,r){let o=new Set(["ask","arm","answer",...y[n.ask].fields]);n.arm===S&&o.add("table");for(let[i,c]of Object.entries(t))c.hidden=!o.has(i);fn(t.answer,Bo[n.ask]??"");let s=r.find(({key:i})=>i===n.arm);fn(t.q,s?Ko(s):"One value for each joint, in the table's order.");let a=s?s.rows.length:16;if(e.frame.options.length!==a+1){let i=l=>l?`frame ${l}`:"the base",c=Array.from({length:a+1},(l,u)=>hn([String(u),i(u)]));e.frame.replaceChildren(...c),e.frame.value=n.frame}}var fn=(e,t)=>z(e.querySelector(".about"),t),Ko=e=>`${g(e).map(n=>`q_${n+1}`).join(", ")}${W(e).includes(!1)?"; m where a joint slides":""}`;var Zo=5e4,Jo=350,bn="Nothing that you type leaves this page: a script in it judges, without a network too.",Vo="It names the mistake and does not print the solution.",Yo=0;function xn(e){let{arms:t,examples:n=[],given:r}=JSON.parse(e.querySelector("script").textContent),o=`judge-${++Yo}`,s=gn(o,t,r),{form:a,fields:i}=s,c=Xo(o,r),l=[],u={...L,arm:t[0]?.key,...r??n[0]},m,d=0,w=f=>u[f].length>Zo?"":u[f],$=()=>{for(let[f,v]of Object.entries(i))v.value!==w(f)&&(v.value=w(f));wn(s,u,t)},J=f=>z(c.said,f),ue=()=>{clearTimeout(d),lt(c.verdict,m)},mt=()=>{pt(),ue()},pt=()=>{m=rt(u,t),m.waiting&&Ye(u.ask).then(mt,({message:f})=>J(f)),i.answer.setAttribute("aria-invalid",String(m.report?.grade==="wrong")),ct(c.taken,u,m);for(let f of l)f(u,m)},me=f=>{u={...u,...f},$(),mt()};a.addEventListener("input",({target:f,inputType:v})=>{let E=Object.keys(i).find(yn=>i[yn]===f);E&&(u={...u,[E]:f.value},E==="arm"&&(u.frame="0"),(E==="arm"||E==="ask")&&(u.q=Qo(u,n)?.q??u.q),$(),pt(),clearTimeout(d),v==="insertFromPaste"||v==="insertFromDrop"?ue():d=setTimeout(ue,Jo))}),a.addEventListener("submit",f=>f.preventDefault());let dt=()=>{let{question:f,words:v}=tt(location.hash,t.map(({key:E})=>E));(f||v)&&e.scrollIntoView({block:"start"}),J(v),f&&me(f)};return e.replaceChildren(a,...Object.values(c)),me({}),r||(addEventListener("hashchange",dt),dt()),{stub:e,arms:t,examples:n,given:r,...s,parts:c,...{question:()=>u,verdict:()=>m},put:me,follow:f=>{l.push(f),f(u,m)},say:J,links:{fragment:()=>et(u),open:()=>!0}}}function Xo(e,t){return{verdict:p("div.verdict",{role:"status","aria-live":"polite","aria-atomic":"true"}),taken:p("div.scroll",{role:"region",tabindex:"0","aria-label":"How your answer is read"}),tools:p("div.tools"),said:p("p.about",{role:"status"}),private:p("p.private",{id:`${e}-private`},t?bn:`${bn} ${Vo}`)}}var Qo=(e,t)=>t.find(n=>n.arm===e.arm&&n.ask===e.ask);document.head.append(Object.assign(document.createElement("style"),{textContent:ht}));for(let e of document.querySelectorAll(".arm-judge"))I.push(xn(e));if(I.some(({given:e})=>!e))K("page");else for(let{stub:e}of I)e.addEventListener("focusin",()=>K("page"),{once:!0});fe({"and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","unknown symbol":"{arm}: no value for {name}; known are {known}. Give values={'{name}': ...} if it is a length of yours","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what} holds NaN or infinity; expected {wanted}",ragged:"{what} has rows of {widths} entries; expected rows of one length","taken: counted on":"symbols numbered on past what does not move: 1, 2, 3 ... are joints {joints}","taken: from zero":"symbols numbered from 0: 0, 1, 2 ... are joints {joints}"});return An(es);})();
