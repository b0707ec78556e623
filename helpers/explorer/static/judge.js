var ArmJudge=(()=>{var ue=Object.defineProperty;var hn=Object.getOwnPropertyDescriptor;var gn=Object.getOwnPropertyNames;var wn=Object.prototype.hasOwnProperty;var b=(e,t)=>{for(var n in t)ue(e,n,{get:t[n],enumerable:!0})},bn=(e,t,n,r)=>{if(t&&typeof t=="object"||typeof t=="function")for(let o of gn(t))!wn.call(e,o)&&o!==n&&ue(e,o,{get:()=>t[o],enumerable:!(r=hn(t,o))||r.enumerable});return e};var xn=e=>bn(ue({},"__esModule",{value:!0}),e);var To={};b(To,{kit:()=>on});var we={};b(we,{ArmError:()=>h,learn:()=>de,listed:()=>pe,lower:()=>J,quoted:()=>ge,say:()=>x,shown:()=>V,size:()=>yn,spelled:()=>fe,tuple:()=>he});var me={},de=e=>{me={...me,...e}};function x(e,t={}){let n=me[e];for(let[r,o]of Object.entries(t))n=n.replaceAll(`{${r}}`,()=>String(o));return n}var h=class extends Error{},pe=(e,t="and")=>e.length===1?e[0]:`${e.slice(0,-1).join(", ")} ${t} ${e.at(-1)}`,J=e=>/^.(\p{Lu}|_)/su.test(e)?e:e.slice(0,1).toLowerCase()+e.slice(1);function yn(e,t=3){if(!Number.isFinite(e))return Number.isNaN(e)?"nan":e>0?"inf":"-inf";if(e===0)return"0";let[n,r]=jn(e,t).split("e"),o=Number(r),s=a=>a.includes(".")?a.replace(/\.?0+$/,""):a;return o<-4||o>=t?`${s(n)}e${dt(o)}`:s((+`${n}e${r}`).toFixed(Math.max(0,t-1-o)))}function jn(e,t){let n=e.toExponential(t-1),[r,o]=e.toExponential(t+25).split("e"),s=t===1?r.indexOf("."):r.indexOf(".")+t,a=r.slice(s).replace(".",""),i=r.slice(0,s);return/^50*$/.test(a)&&"02468".includes(i.at(-1))?`${i}e${o}`:n}var dt=e=>`${e<0?"-":"+"}${String(Math.abs(e)).padStart(2,"0")}`;function fe(e){let[t,n]=e.toExponential().split("e"),r=Number(n);if(e!==0&&(r<-4||r>=16))return`${t}e${dt(r)}`;let o=BigInt(Math.trunc(e)).toString();return r>20?o:String(e).includes("e")?e.toFixed(20).replace(/0+$/,""):String(e)}function V(e){let t=e.includes("'")&&!e.includes('"')?'"':"'",n={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},r=[...e].map(s=>n[s]??$n(s)).join(""),o=[...`${t}${r}${t}`];return o.length<=80?o.join(""):`${o.slice(0,77).join("")}...`}function $n(e){let t=e.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(e)||e===" "?e:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var he=e=>e.length===1?`(${e[0]},)`:`(${e.join(", ")})`;function ge(e){return e.includes(`
`)&&!/"""|["\\]$/.test(e)&&!/[\r\0]/.test(e)?`r"""${e}"""`:JSON.stringify(e)}var pt=`.arm-judge {
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
`;var be={};b(be,{judges:()=>I});var I=[];var Ne={};b(Ne,{KINDS:()=>ht,LARGEST:()=>Ae,LONGEST:()=>Me,MOST_ROWS:()=>ve,TYPED:()=>gt,carriedOver:()=>xt,fits:()=>yt,homeOf:()=>Ln,limited:()=>Fn,outside:()=>zn,range:()=>In,reachOf:()=>Cn,rowsFault:()=>Oe,sameRow:()=>bt,typedArm:()=>Se});var $e={};b($e,{GRAVITY:()=>Mn,cosSin:()=>xe,cross:()=>je,dot:()=>An,gravityTorque:()=>kn,jacobianColumns:()=>En,joints:()=>g,linkFrames:()=>Sn,matrix:()=>Nn,minus:()=>ye,norm:()=>On,plus:()=>Y,scaled:()=>ft,wrenchTorque:()=>_n});var Mn=9.81,An=(e,t)=>e[0]*t[0]+e[1]*t[1]+e[2]*t[2],ft=(e,t)=>[e*t[0],e*t[1],e*t[2]],Y=(e,t)=>[e[0]+t[0],e[1]+t[1],e[2]+t[2]],ye=(e,t)=>[e[0]-t[0],e[1]-t[1],e[2]-t[2]],je=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]],On=e=>Math.sqrt(e.reduce((t,n)=>t+n*n,0)),N=(e,t,n,r)=>[e*t[0]+n*r[0],e*t[1]+n*r[1],e*t[2]+n*r[2]];function xe(e){let t=e/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(e),Math.sin(e)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var g=e=>e.rows.flatMap((t,n)=>t.kind==="fixed"?[]:[n]);function Sn(e,t){let[n,r,o,s]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:n,y:r,z:o,o:s}],i=0;for(let c of e.rows){let l=c.kind==="fixed"?0:t[i++],[u,m]=xe(c.kind==="revolute"?c.theta+l:c.theta),[p,w]=xe(c.alpha),j=c.kind==="prismatic"?c.d+l:c.d;[n,r]=[N(u,n,m,r),N(u,r,-m,n)],s=Y(N(j,o,c.a,n),s),[r,o]=[N(p,r,w,o),N(p,o,-w,r)],a.push({x:n,y:r,z:o,o:s})}return a}var Nn=({x:e,y:t,z:n,o:r})=>[0,1,2].map(o=>[e[o],t[o],n[o],r[o]]).concat([[0,0,0,1]]);function En(e,t,n=t.at(-1).o){return g(e).map(r=>{let{z:o,o:s}=t[r];return e.rows[r].kind==="revolute"?[...je(o,ye(n,s)),...o]:[...o,0,0,0]})}function kn(e,t,n=9.81){let r=e.rows.flatMap((o,s)=>o.body?[Tn(o.body,t[s+1],s)]:[]);return g(e).map(o=>{let{z:s,o:a}=t[o],i=c=>e.rows[o].kind==="revolute"?je(s,ye(c,a))[2]:s[2];return r.reduce((c,{mass:l,centre:u,row:m})=>c+(m<o?0:l*n*i(u)),0)})}function Tn([e,...t],{x:n,y:r,z:o,o:s},a){return{mass:e,row:a,centre:Y(s,Y(N(t[0],n,t[1],r),ft(t[2],o)))}}var _n=(e,t)=>e.map(n=>n.reduce((r,o,s)=>r+o*t[s],0));var ht=["revolute","prismatic","fixed"],ve=16,Me=100,Ae=1e3,gt="Your arm",wt=[["a",Me],["alpha",Ae],["d",Me],["theta",Ae]];function Oe(e){if(!Array.isArray(e)||!e.length)return"the table has no rows";if(e.length>ve)return`the table has ${e.length} rows; ${ve} are the most`;for(let[t,n]of e.entries()){if(!ht.includes(n?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[r,o]of wt){if(!Number.isFinite(n[r]))return`row ${t+1} has no number for ${r}`;if(Math.abs(n[r])>o)return`row ${t+1} has ${n[r]} for ${r}; ${o} is the most`}}return null}var Rn=({kind:e,a:t,alpha:n,d:r,theta:o})=>({kind:e,a:t,alpha:n,d:r,theta:o,lower:null,upper:null,speed:null,effort:null}),bt=(e,t)=>e.kind===t.kind&&wt.every(([n])=>Math.abs(e[n]-t[n])<1e-12);function Se(e,t){if(e.length===t.rows.length&&e.every((r,o)=>bt(r,t.rows[o])))return t;let n={name:gt,home:[],rows:e.map(Rn)};return{...n,home:xt(t,t.home,n,r=>r)}}function xt(e,t,n,r){let o=new Map(g(e).map((s,a)=>[s,[e.rows[s].kind,t[a]??0]]));return g(n).map(s=>{let[a,i]=o.get(r(s))??[];return a===n.rows[s].kind?i:0})}var Ln=e=>yt(e,e.home)?[...e.home]:g(e).map(()=>0),yt=(e,t)=>Array.isArray(t)&&t.length===g(e).length&&t.every(Number.isFinite);function In(e){let t=e.kind==="revolute"?Math.PI:1;return[e.lower??-t,e.upper??t]}var zn=(e,t)=>t<(e.lower??-1/0)-1e-9||t>(e.upper??1/0)+1e-9,Fn=e=>g(e).some(t=>e.rows[t].lower!==null||e.rows[t].upper!==null),Cn=e=>e.rows.reduce((t,n)=>t+Math.abs(n.a)+Math.abs(n.d)+(n.kind==="prismatic"?Math.abs(n.upper??.3):0),0)||.3;var Ee={};b(Ee,{attribute:()=>qn,calm:()=>Bn,h:()=>d,indexed:()=>Hn,svg:()=>Pn,whereNew:()=>Dn,write:()=>z});function d(e,t={},...n){let[r,...o]=e.split("."),s=document.createElement(r);o.length&&(s.className=o.join(" "));for(let[a,i]of Object.entries(t))a.startsWith("on")?s.addEventListener(a.slice(2),i):i!==void 0&&i!==!1&&s.setAttribute(a,i===!0?"":i);return s.append(...n.flat()),s}function Pn(e,t={},...n){let r=document.createElementNS("http://www.w3.org/2000/svg",e);for(let[o,s]of Object.entries(t))r.setAttribute(o,s);return r.append(...n),r}function z(e,t){e.textContent!==t&&(e.textContent=t)}function qn(e,t,n){e.getAttribute(t)!==n&&e.setAttribute(t,n)}function Dn(e,t){let n=[];return r=>{let o=e(r);n.length&&o.every((s,a)=>s===n[a])||(n=o,t(r))}}var Hn=(e,t)=>[d("i",{},e),d("sub",{},String(t))],Bn=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var nt={};b(nt,{ASKED:()=>y,CHOICES:()=>Ze,EMPTY:()=>L,LONGEST_ANSWER:()=>Vt,OWN:()=>O,UNITS:()=>R,armOf:()=>et,asPython:()=>Kr,fromFragment:()=>Qe,judge:()=>tt,toFragment:()=>Xe});var y={jacobian:{title:"Jacobian at a pose",fields:["q","unit","frame","first"],script:"jacobian"},torques:{title:"Joint torques at a pose",fields:["q","unit","wrench"],script:"jacobian"},table:{title:"Denavit-Hartenberg table",fields:["columns","lengths","angles","convention"],script:"table"},branches:{title:"All joint angles for a target",fields:["target","unit"],script:"motion"},pose:{title:"Joint angles for one pose",fields:["target","unit"],script:"motion"},trace:{title:"Joints along a circle",fields:["q","unit","radius","plane","period","steps","pace"],script:"motion",longest:5e6}};var Ke={};b(Ke,{eachJoint:()=>We,inRadians:()=>Kt,lookup:()=>kr,numbered:()=>Be,numbers:()=>Ut,pose:()=>Ge,poseFault:()=>Gt,turning:()=>oe,variables:()=>Ue});var Le={};b(Le,{HALF:()=>vt,HAND:()=>Mt,RIGHT:()=>X,ROUNDED:()=>Q,SO_FAR:()=>F,TELLING:()=>At,WRONG:()=>Te,bands:()=>Zn,beyond:()=>Qn,decimalsOf:()=>Vn,farthest:()=>Re,generous:()=>Ot,graded:()=>Xn,margins:()=>Yn,units:()=>ee});var[X,F,Q,Te]=["right","so far","rounded","wrong"],vt=.51,Mt=3,Un=1e-6,Wn=.001,At=.0021,Gn=13,jt=-12,Kn=/^[+-]?\s*(\d*)\.?(\d*)(?:[eE]([+-]?\d+))?$/,$t=e=>+`1e${e}`;function Jn(e){let t=Kn.exec(e.trim());if(!t||!(t[1]||t[2]))return null;let n=(t[1]+t[2]).replace(/^0+/,"").length,r=t[2].length-Number(t[3]??0);return{decimals:r,digits:n,first:n-1-r}}function ee(e){let t=e.map(Jn),n=t.filter(i=>i&&i.digits&&i.first>jt),r=i=>n.reduce((c,l)=>Math.max(c,l[i]),n.length?-1/0:0),[o,s]=[r("decimals"),r("digits")];if(s>=Gn||t.includes(null)&&o<=0)return e.map(()=>0);let a=n.every(i=>i.decimals<=s-1-i.first)&&n.some(i=>i.digits===s&&i.decimals<o);return t.map(i=>i?!a||!i.digits||i.first<=jt?$t(-o):$t(Math.max(-o,i.first-s+1)):0)}function Vn(e){let t=e.filter(n=>n>0);return t.length?Math.max(0,Math.round(-Math.log10(Math.min(...t)))):null}function Yn(e,t,n=null,r=null){let o=t.map(l=>Un*l),s=e.map(()=>0);if(r!==null){let l=o.map(u=>Math.max(r,u*.001));return{allowed:l,band:l,loose:l,units:s,slop:s}}let a=e.map((l,u)=>Math.max(vt*l,o[u])),i=e.map((l,u)=>Math.max(Mt*l,o[u])),c=i.map((l,u)=>Math.max(l,Wn*t[u]));return{allowed:a,band:i,loose:c,units:e,slop:n??s}}var _e=(e,t,n)=>e.map((r,o)=>r+n*t[o]),Re=({loose:e,band:t,slop:n})=>_e(t,n,2).map((r,o)=>Math.max(r,e[o])),Ot=({allowed:e,slop:t})=>_e(e,t,1);function Zn(e){let t=e.slop.some(Boolean)?[_e(e.band,e.slop,2)]:[];return[e.band,...t,Re(e),e.allowed]}var ke=(e,t,n)=>e.every((r,o)=>Math.abs(r-t[o])<=n[o]),Z=(e,t)=>e.reduce((n,r,o)=>Math.max(n,Math.abs(r-t[o])),0);function Xn(e,t,n,r){let o=r.filter(a=>Z(a,t)>At);for(let a of[n.allowed,Ot(n)]){let i=o.some(c=>ke(e,c,a));if(ke(e,t,a)){let c=Math.max(0,...n.units),l=o.reduce((u,m)=>Math.min(u,Z(m,t)),1/0);return i||c>l/2.1?F:X}if(i)return Te}if(!ke(e,t,Re(n)))return Te;let s=Z(e,t);return o.some(a=>Z(e,a)<=s)?F:Q}function Qn(e,t,{band:n,allowed:r}){let o=a=>e.map((i,c)=>Math.abs(i-t[c])>a[c]),s=o(n);return s.includes(!0)?s:o(r)}var Fe={};b(Fe,{number:()=>D,parse:()=>k,plain:()=>E,symbols:()=>T,value:()=>_});var St=2e4,Et=60,C=Math.PI/180,kt={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:e=>e*C,deg2rad:e=>e*C,degrees:e=>e*(180/Math.PI),rad2deg:e=>e*(180/Math.PI),sind:e=>Math.sin(e*C),cosd:e=>Math.cos(e*C),float:e=>e,Float:e=>e,Integer:e=>e},Tt={pi:Math.PI,deg:C,rad:1},er=e=>Object.hasOwn(kt,e),_t=e=>Object.hasOwn(Tt,e),$=(e,t)=>[...e].map(n=>[n,t]),tr="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),nr=new Map([...$("−–—‐‑‒﹣－","-"),...$("×⋅·∙∗","*"),...$("÷∕⁄","/"),...$("       　"," "),...$("​⁡⁢\uFEFF",""),...$("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((e,t)=>$(e,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((e,t)=>$(e,` ${tr[t]}`)),...$("π𝜋"," pi "),...$("°º"," deg"),["²","^2"],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),rr=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)\b/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text|mathit|mathbf|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)\b/g," deg"],[/\\(?:cdot|times|ast)\b/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/\\d?t?frac\s*(\d)\s*(\d)/g,"(($1)/($2))"]],or=/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,sr=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,ar=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,Ie=new RegExp(String.raw`\s*(?:(${sr})|(${ar})|(\*\*|[-+*/^()]))`,"y"),ir=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,cr=/[cs]_?(?:\d|\{[\d+-]+\})+/g;function E(e){e=[...e].map(t=>nr.get(t)??t).join("");for(let[t,n]of rr)e=e.replace(t,n);for(let t="";t!==e;)[t,e]=[e,e.replace(or,"(($1)/($2))")];return e=e.replace(/\\([A-Za-z]+)/g," $1 "),e=e.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),e=e.replace(/(?<=\w)\s*\(t\)/g,""),e=e.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),e=e.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),e=e.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),e.replace(/[ \t]+/g," ").trim()}function k(e,t="the formula"){if(e.length>St)throw new h(`${t} has ${e.length} characters; expected at most ${St}`);let n=ur(E(e));if(!n)throw new h(`${t} is ${V(e)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let r=lr(n);if(r?.[1]!==n.length)throw new h(`${t} is ${V(e)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return r[0]}var M=class extends Error{};function lr(e){try{return Rt(e,0,0)}catch(t){if(t instanceof M)return null;throw t}}function ur(e){let t=[];for(let n=0;n<e.length;n=Ie.lastIndex){Ie.lastIndex=n;let r=Ie.exec(e);if(!r)return e.slice(n).trim()?null:t;let[,o,s,a]=r;if(o!==void 0)t.push(["num",o]);else if(a!==void 0)t.push(["sign",a==="**"?"^":a]);else for(let i of ir.test(s)?s.match(cr):[s])t.push(["name",i])}return t}function te(e,t){if(t>=e.length)throw new M;return e[t]}function Rt(e,t,n){if(n>Et)throw new M;let[r,o]=Nt(e,t,n);for(;o<e.length&&["+","-"].includes(e[o][1]);){let[s,a]=Nt(e,o+1,n);[r,o]=[[e[o][1],r,s],a]}return[r,o]}function Nt(e,t,n){let[r,o]=q(e,t,n);for(;o<e.length;){let[s,a]=e[o];if(a==="*"||a==="/"){let[i,c]=q(e,o+1,n);[r,o]=[[a,r,i],c]}else if(a==="("||s!=="sign"){let[i,c]=Lt(e,o,n);[r,o]=[["*",r,i],c]}else break}return[r,o]}function q(e,t,n){if(n>Et)throw new M;let r=te(e,t)[1];if(r==="-"){let[o,s]=q(e,t+1,n+1);return[["neg",o],s]}return r==="+"?q(e,t+1,n+1):Lt(e,t,n)}function Lt(e,t,n){let[r,o]=ze(e,t,n);if(o>=e.length||e[o][1]!=="^")return[r,o];let[s,a]=q(e,o+1,n+1);return[["^",r,s],a]}function ze(e,t,n){let[r,o]=te(e,t);if(r==="num")return[["num",Number(o)],t+1];if(r==="name"&&er(o)&&t+1<e.length){let[i,c]=mr(e,t+1,n);return[["call",o,i],c]}if(r==="name")return[["name",o],t+1];if(o!=="(")throw new M;let[s,a]=Rt(e,t+1,n+1);if(te(e,a)[1]!==")")throw new M;return[s,a+1]}function mr(e,t,n){if(te(e,t)[1]!=="-")return ze(e,t,n);let[r,o]=ze(e,t+1,n);return[["neg",r],o]}function T(e,t=new Set){if(e[0]==="name")return _t(e[1])?t:t.add(e[1]);for(let n of e.slice(1))Array.isArray(n)&&T(n,t);return t}function _(e,t){let n=P(e,t);if(!Number.isFinite(n))throw new h("a formula divides by zero or is too large; expected a finite value");return n}function P(e,t){let[n,r,o]=e;if(n==="num")return r;if(n==="name"){let c=_t(r)?Tt[r]:t(r);if(c===void 0)throw new h(`no value for ${r}`);return c}if(n==="neg")return-P(r,t);if(n==="call")return kt[r](P(o,t));let[s,a]=[P(r,t),P(o,t)];if(n==="+")return s+a;if(n==="-")return s-a;if(n==="*")return s*a;if(n==="/")return a===0?NaN:s/a;let i=s**a;return Number.isFinite(i)||!Number.isFinite(s)?i:NaN}function D(e){try{return _(k(e),()=>{})}catch(t){if(t instanceof h)return null;throw t}}var He={};b(He,{cells:()=>B,withoutHeader:()=>De});var It=5e6,Pt=String.raw`[\p{L}\p{N}_.]`,dr=String.raw`^\s*(?:${Pt}+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*)?`,pr="Matrix|array|asarray|matrix|tensor|vpa|simplify|round|double|sym",zt=new RegExp(String.raw`${dr}(?:${Pt}*(?:${pr})\s*\(\s*)+`,"u"),fr=/(?:,\s*(?:dtype\s*=\s*[\p{L}\p{N}_.']+|\d+)\s*)?\)+\s*;?\s*$/u,hr=/^\s*[\p{L}\p{N}_.]+\s*(?:\([\p{L}\p{N}_]+\))?\s*=\s*(?=[[({\n\d-]|$)/u,gr=/\\begin\{(?:[a-zA-Z]*matrix\*?|array|tabular|aligned)\}(?:\[[^\]]*\])?(?:\{[^{}]*\})?/g,wr=/\\end\{[^{}]*\}(?:_\{[^{}]*\})?(?:\s*\\right\s*[\]).|])?|\\(?:hline|toprule|midrule|bottomrule|nonumber)\b/g,Ft=/^\s*(1(?:\.0+)?e[+-]?\d+)\s*\*\s*$/m,Ct=/^\s*Columns?\s+\d+(?:\s+(?:through|to|and)\s+\d+)?\s*:?\s*$/im,br=/^\s*\|?[\s:|+=_-]*[-=_]{2,}[\s:|+=_-]*\|?\s*$/,qt=e=>{let t=e.split(/\r\n|[\n\r\v\f\x1c-\x1e\x85\u2028\u2029]/);return t.at(-1)===""&&t.pop(),t},Ce=(e,t)=>{let[n,r]=[0,e.length];for(;n<r&&t.includes(e[n]);)n++;for(;r>n&&t.includes(e[r-1]);)r--;return e.slice(n,r)},H=(e,t)=>{let n=e.length;for(;n>0&&t.includes(e[n-1]);)n--;return e.slice(0,n)};function B(e){if(e.length>It)throw new h(`the text has ${e.length} characters; expected at most ${It}`);let t=xr(Ce(e.trim(),"`$").trim()).filter(n=>n.some(r=>r.trim())).map(n=>n.map(r=>r.trim()));if(!t.length)throw new h("the text is empty; expected rows of numbers or formulas");return t}function xr(e){if(e.includes("\\begin{")||e.includes("\\\\"))return yr(e);if(e.split("|").length>2&&!e.split("|")[0].includes("["))return jr(e);let t=zt.test(e)?e.replace(zt,"").replace(fr,""):e;return t=H(t.replace(hr,"").trim(),";").trim(),t&&"[({".includes(t[0])?Dt(t):vr(t)}function yr(e){return e=e.replace(/\\left\s*[[(.|]\s*(?=\\begin)/g," ").replace(gr," ").replace(wr," ").replace(/^\s*[A-Za-z_][\p{L}\p{N}_]*(?:\([^()]*\))?\s*=/u,"").replace(/\\\\\s*\[[^\]]*\]/g,"\\\\").replaceAll("$"," ").replaceAll("\\["," ").replaceAll("\\]"," "),e.split(/\\\\|\\cr\b/).map(t=>t.split("&"))}var jr=e=>qt(e).map(t=>t.trim()).filter(t=>t.includes("|")&&!/^[\s:|+=_-]*[-=_][\s:|+=_-]*$/.test(t)).map(t=>t.replace(/^\||\|$/g,"").replaceAll("$"," ").split("|"));function Dt(e){let t=ne(e);if(t.length===1&&!A(t[0]))return[t];if(t.every(A)){let r=t.map(ne);if(!r.some(a=>a.some(A)))return r;let o=a=>A(a)&&ne(a).length===1?ne(a)[0]:a,s=r.map(a=>a.map(o));return s.some(a=>a.some(A))?t.flatMap(Dt):s}let n=A(e)?e.trim().slice(1,-1):e;return A(e)&&/[;\n]/.test(n)&&!n.includes("[")?n.replace(/\.\.\.[^\n]*\n/g," ").split(/[;\n]/).map(re):[t]}function A(e){return e=e.trim(),!e||!"[({".includes(e[0])||!Ht(e)?!1:e[0]!=="("||qe(e.slice(1,-1))}var Pe=e=>"[({".includes(e)?1:"])}".includes(e)?-1:0;function Ht(e){let t=0;for(let n=0;n<e.length;n++)if(t+=Pe(e[n]),!t)return n===e.length-1;return!1}function qe(e){let t=0;for(let n=0;n<e.length;n++)if(t+=Pe(e[n]),e[n]===","&&!t)return!0;return!1}function ne(e){return e=H(e.trim(),","),re(A(e)||e[0]==="["&&Ht(e)?e.slice(1,-1):e)}function re(e){let t=[],[n,r]=[0,""],o=qe(e);for(let s=0;s<e.length;s++){let a=e[s];n+=Pe(a),(o?a===",":/\s/.test(a)&&!$r(e,s))&&!n?(t.push(r),r=""):r+=a,!o&&!n&&a==="]"&&(t.push(r),r="")}return t.push(r),t.filter(s=>s.trim()).map(s=>Ce(s.trim(),`'"`))}function $r(e,t){let[n,r]=[e.slice(0,t).trimEnd(),e.slice(t).trimStart()];return!n||!r||"+-*/^=(".includes(n.at(-1))||"*/^)=".includes(r[0])?!0:"+-".includes(r[0])&&r.length>1&&/\s/.test(r[1])||r.startsWith("deg")||r[0]==="°"}function vr(e){let t=Ft.exec(e);e=e.replace(new RegExp(Ft,"gm"),"");let r=(Ct.test(e)?e.split(new RegExp(Ct,"gim")).filter(s=>s.trim()):[e]).map(Mr),o=r[0];return r.length>1&&r.every(s=>s.length===o.length)&&(o=o.map((s,a)=>r.flatMap(i=>i[a]))),t?o.map(s=>s.map(a=>D(a)?`${a}*${t[1]}`:a)):o}function Mr(e){let t=qt(e).filter(o=>o.trim()&&!br.test(o)).filter(o=>!/^\s*[\p{L}\p{N}_]+\s*=\s*$/u.test(o)),n=o=>t.some(s=>H(s.trim(),";").includes(o)),r=["	",";"].find(n);if(r){let o=s=>H(Ce(s,`\r
 `),r);return t.map(s=>o(s).split(r).map(Or))}return t.some(qe)?Ar(t):t.map(o=>re(o.replace(/^\s*[[|⎡⎢⎣]+|[\]|⎤⎥⎦]+\s*$/g,"")))}function Ar(e){let t=e.every(n=>/^\s*(?:-?\d+(?:,\d+)?(?:\s+|$)){2,}$/.test(n));return e.map(n=>re(t?n.replaceAll(",","."):H(n,",")))}var Or=e=>e.split(",").length===2&&!e.includes("(")?e.replace(/(?<=\d),(?=\d)/g,"."):e,Sr=e=>e.every(t=>t.every(n=>D(n)!==null));function De(e){let[t,...n]=e,r=t.map(E).filter(Boolean);return n.length>0&&r.every(s=>D(s)===null)&&Sr(n)?n:e}var Nr=/^(q|th|theta|tht|thetha|t|phi|joint|j|x|d|u)(\d{1,2})$/,Bt=/^([cs])((?:[+-]?\d)+)$/i,Er=/^(.*?)\*(1(?:\.0+)?e[+-]?\d+)$/,Be=e=>g(e).map(t=>t+1),oe=e=>g(e).map(t=>e.rows[t].kind==="revolute"),Ue=e=>Be(e).map(t=>`q_${t}`);function kr(e,t){let n=[];return{known:o=>{let[s,a]=Lr([...o].sort(),e,t);for(let i of a)n.includes(i)||n.push(i);return s},said:n}}var Tr=e=>{if(e.size)throw new h(x("symbols for numbers",{names:[...e].sort().join(", ")}));return new Map};function Ut(e,t,n=Tr,r="numbers"){if(typeof e=="string")return _r(e,t,n);let o=Wt(e),s=e.flat(1/0);if(!s.every(Number.isFinite))throw new h(x("not finite",{what:t,wanted:r}));return{values:s,units:ee(s.map(fe)),shape:o,symbolic:!1}}var Wt=e=>Array.isArray(e)?[e.length,...e.length?Wt(e[0]):[]]:[];function _r(e,t,n){let r=De(B(e)),o=[...new Set(r.map(p=>p.length))].sort((p,w)=>p-w);if(o.length>1)throw new h(x("ragged",{what:t,widths:o.join(", ")}));let s=r.flat().map(E),a=s.map(p=>k(p,`an entry of ${t}`)),i=new Set;for(let p of a)T(p,i);let c=n(i),l=a.map(p=>_(p,w=>c.get(w))),u=s.map(Rr),m=ee(u.map(([p])=>p)).map((p,w)=>p*u[w][1]);return{values:l,units:m,shape:[r.length,o[0]],symbolic:i.size>0}}function Rr(e){let t=Er.exec(e);return t?[t[1],Number(t[2])]:[e,1]}var We=e=>`one value for each of ${Ue(e).join(", ")}`;function Ge(e,t,n="rad"){let r=Ut(e,`${t.name}: q`,void 0,We(t)),o=typeof e=="string"?[r.values.length]:r.shape,s=g(t).length;if(o.length!==1||o[0]!==s)throw new h(Gt(t,o,`one pose, (${s},)`));return Kt(r,t,n)}function Gt(e,t,n){let r=he(t);return`${e.name}: q has shape ${r}; expected ${n}, ${We(e)}`}function Kt(e,t,n){let r=oe(t),o=s=>n==="deg"&&r[s%r.length]?Math.PI/180:1;return{...e,values:e.values.map((s,a)=>s*o(a)),units:e.units.map((s,a)=>s*o(a))}}var U=e=>e.replace(/\(t\)|[_{}'*^\\ ]/g,"").replace(/[ϑθ]/g,"theta").toLowerCase();function Lr(e,t,n){let r=new Map((t.values??[]).map(([c,l])=>[U(c),l])),o=new Map(e.filter(c=>r.has(U(c))).map(c=>[c,r.get(U(c))])),s=new Map(e.filter(c=>!o.has(c)).map(c=>[c,Ir(c)])),[a,i]=zr([...new Set([...s.values()].flatMap(c=>c??[]))],t);for(let[c,l]of s){let u=(l??[]).map(m=>a.get(m));if(!u.length||u.includes(void 0)){let m=[...Ue(t),...(t.values??[]).map(([p])=>p)].join(", ");throw new h(x("unknown symbol",{arm:t.name,name:c,known:m}))}o.set(c,Fr(U(c),u.map(m=>n[m])))}return[o,i]}function Ir(e){let t=U(e),n=Nr.exec(t);if(n)return[Number(n[2])];let r=Bt.exec(t);return r?[...r[2].matchAll(/\d/g)].map(Number):null}function zr(e,t){let n=Be(t),r=new Map(n.map((a,i)=>[a,i])),o=a=>e.every(i=>i>=a&&i<a+n.length);if(e.every(a=>r.has(a)))return[r,[]];let s=a=>new Map(n.map((i,c)=>[c+a,c]));return o(1)?[s(1),[x("taken: counted on",{joints:n.join(", ")})]]:o(0)?[s(0),[x("taken: from zero",{joints:n.join(", ")})]]:[r,[]]}function Fr(e,t){let n=Bt.exec(e);if(!n)return t[0];let r=[...n[2].matchAll(/([+-]?)\d/g)].map(([,s])=>s==="-"?-1:1),o=t.reduce((s,a,i)=>s+r[i]*a,0);return e[0]==="c"?Math.cos(o):Math.sin(o)}var Ye={};b(Ye,{checkerOf:()=>ae,load:()=>W,ready:()=>Ve,register:()=>Pr});var Je=new Map,se=new Map,Cr=typeof document>"u"?null:document.currentScript?.src,Pr=(e,t)=>{Je.set(e,t)},ae=e=>Je.get(e),Ve=e=>Je.has(e)?Promise.resolve():W(y[e].script);function W(e){return se.has(e)||se.set(e,qr(e)),se.get(e)}function qr(e){return new Promise((t,n)=>{let r=()=>{se.delete(e),n(new Error(`The script judge-${e}.js could not be loaded.`))},o=new URL(`judge-${e}.js`,Cr).href;document.head.append(Object.assign(document.createElement("script"),{src:o,onload:()=>t(),onerror:r}))})}var Jt=12e3,Dr={table:2e3,q:500,wrench:300,answer:8e3,target:1e3},Vt=2e4,O="own",R=["rad","deg"],Ze={unit:R,first:["v","omega"],plane:["zy","yz","zx","xz"],pace:["even","rest"],lengths:["","m","cm","mm"],angles:["",...R],convention:["","standard","craig"]},L={ask:"jacobian",arm:"",table:"",q:"",unit:"rad",frame:"0",first:"v",wrench:"",answer:"",columns:"",lengths:"",angles:"",convention:"",target:"",radius:"0.1",plane:"zy",period:"5",steps:"",pace:"even"};function Xe(e){let t=Object.entries(e).filter(([n,r])=>r!==L[n]||n==="ask"||n==="arm");return`#${new URLSearchParams(t)}`}function Qe(e,t){let n=e.replace(/^#/,"");if(!/^ask=/.test(n))return{question:null,words:""};let r=i=>({question:null,words:`The link could not be read: ${i}.`});if(n.length>Jt)return r(`it has ${n.length} characters; ${Jt} are the most`);let o=new URLSearchParams(n),s={...L};for(let[i,c]of o){if(!Object.hasOwn(L,i))return r(`it has a field “${i.slice(0,40)}”`);if(c.length>(Dr[i]??40))return r(`its ${i} is too long`);s[i]=c}if(!Object.hasOwn(y,s.ask))return r("it asks what is not judged here");if(s.arm!==O&&!t.includes(s.arm))return r(`there is no arm called “${s.arm}” here`);let a=Object.keys(Ze).find(i=>!Ze[i].includes(s[i]));return a?r(`its ${a} is none`):/^\d{1,2}$/.test(s.frame)?{question:s,words:""}:r("its frame is none")}function et(e,t){if(e.arm!==O)return t.find(({key:o})=>o===e.arm);if(!e.table.trim())throw new h("Type the table of your arm: a row for each joint, a α d θ.");let n=B(e.table).filter((o,s)=>s||!o.some(a=>/^\W*(a|alpha|α|d|theta|θ)(_?\{?i.*)?\W*$/i.test(a))).map((o,s)=>Ur(o.length===5?o.slice(1):o,s+1,e.unit)),r=Oe(n);if(r)throw new h(`${r}.`);return Se(n,{name:"",home:[],rows:[]})}var Hr=["a","alpha","d","theta"],Br=/^(q|th|theta|phi|d|s|x)_?\{?\d{1,2}\}?$/;function Ur(e,t,n){if(e.length!==4)throw new h(`Row ${t} of the table has ${e.length} entries; expected four: a α d θ.`);let r=e.map((u,m)=>k(u||"0",`row ${t}, ${Hr[m]}`)),o=r.map(u=>[...T(u)]),s=o.flatMap((u,m)=>u.filter(p=>m<2||!Br.test(p)));if(s.length)throw new h(`Row ${t} of the table: no value for ${s[0]}; write numbers, and a variable such as q1.`);let[a,i,c,l]=r.map((u,m)=>{let p=n==="deg"&&m%2&&!/deg|°|pi|π/.test(e[m]);return _(u,()=>0)*(p?Math.PI/180:1)});return{kind:o[2].length?"prismatic":"revolute",a,alpha:i,d:c,theta:l}}function tt(e,t){try{let n=et(e,t),r=Wr(e,n);if(r)return{error:r,arm:n};let o=Yt(e)?Ge(e.q,n,e.unit).values:void 0;if(!e.answer.trim())return{error:"Type or paste your answer.",arm:n,q:o};let s=y[e.ask].longest??Vt;if(e.answer.length>s)return{error:`The answer is longer than ${s} characters.`,arm:n,q:o};let a=ae(e.ask);return a?{report:a.verdict(e,n),arm:n,q:o}:{error:"The checker is being loaded.",waiting:!0,arm:n,q:o}}catch(n){if(n instanceof h)return{error:Gr(n.message)};throw n}}var Yt=({ask:e})=>y[e].fields.includes("q"),Wr=(e,t)=>Yt(e)&&!e.q.trim()?`Type the pose: ${g(t).length} joint values.`:null,Gr=e=>e.slice(0,1).toUpperCase()+e.slice(1);function Kr(e,t){let n=et(e,t),[r,o]=e.arm===O?["arm",Vr(n)]:[n.python,Jr(n.python)],{call:s,imports:a=[]}=ae(e.ask),i=[...o,...a,"from helpers import checks",""];return e.arm===O&&i.push(...Yr(n),""),i.push(`mine = ${ge(e.answer)}`,`print(${s(e,r,n)})`),`${i.join(`
`)}
`}var Jr=e=>[`from helpers.robots import ${/^\w+/.exec(e)[0]}`],Zt={revolute:"revolute",prismatic:"prismatic",fixed:"fixed"},Vr=e=>[`from helpers.arm import Arm, ${[...new Set(e.rows.map(({kind:t})=>Zt[t]))].sort().join(", ")}`],Yr=e=>["rows = [",...e.rows.map(({kind:t,a:n,alpha:r,d:o,theta:s})=>`    ${Zt[t]}(a=${n}, alpha=${r}, d=${o}, theta=${s}),`),"]",`arm = Arm("${e.name}", rows)`];var st={};b(st,{MARKS:()=>ot,better:()=>io,both:()=>Xt,cause:()=>Qr,complete:()=>so,explain:()=>no,explainAll:()=>en,linesOf:()=>ie,nameOf:()=>eo,several:()=>ao,textOf:()=>co,wordsOf:()=>Qt});var Zr=.6,Xr=.85,rt=.7,Qr=(e,t={})=>({keys:[e],fields:[t]}),Xt=(e,t)=>({keys:[...e.keys,...t.keys],fields:[...e.fields,...t.fields]}),eo=({keys:e,fields:t})=>e.map((n,r)=>to(n,t[r])).join(" + ");function to(e,t){if("_of"in t)return t._of;let n=Object.entries(t).filter(([r])=>!r.startsWith("_"));return[e,...n.map(([,r])=>r)].join(":")}function Qt({keys:e,fields:t}){let[n,r]=e.map((o,s)=>x(o,t[s]));return r===void 0?n:x("and also",{first:n,second:J(r)})}var no=(e,t,n,r,o,s=rt)=>en(e,t,[n],r.map((a,i)=>[[a],o[i]]),s)[0];function en(e,t,n,r,o=rt){let s=n.map(i=>{let c=e.filter((u,m)=>Math.abs(u-t[m])>i[m]).length,l=[Math.max(3,Zr*c),Math.max(4,Xr*c)];return{band:i,count:c,least:l,named:[]}}),a=0;for(let[i,c]of r){let l=i.length>1?2:i[0].keys.length;for(let{band:u,count:m,least:p,named:w}of s){let j=ro(e,c,u,m,p[l-1]);(j?m-j>=p[l-1]:m>0)&&w.push({k:a,cost:l+o*j,parts:i,A:c})}a++}return s.map(i=>oo(e,i))}function ro(e,t,n,r,o){let s=0;for(let a=0;a<e.length;a++)if(!(Math.abs(e[a]-t[a])<=n[a])&&(s++,r-s<o))return s;return s}function oo(e,{band:t,named:n}){if(!n.length)return null;let r=i=>Math.round(i*1e6);n.sort((i,c)=>r(i.cost)-r(c.cost)||i.k-c.k);let[{cost:o,A:s}]=n;return{causes:n.filter(i=>i.cost===o).map(({parts:i})=>i.reduce(Xt)),odd:e.map((i,c)=>!(Math.abs(i-s[c])<=t[c]))}}var so=e=>!!e&&!e.odd.includes(!0);function ao(e,t=3){let n=[...new Set(e.map(Qt))].slice(0,e[0].keys.length===1?t:1);return n.length===1?n[0]:x("or",{first:n[0],others:pe(n.slice(1).map(J),"or")})}function io(e,t=rt){let n=r=>r.causes[0].keys.length+t*r.odd.filter(Boolean).length;return e.filter(Boolean).reduce((r,o)=>r&&n(r)<=n(o)?r:o,null)}var ot={[X]:"✔",[F]:"◐",[Q]:"≈",wrong:"✘"},ie=({findings:e,taken:t,notes:n})=>[...e.filter(({what:r})=>r!=="cause").map(({words:r})=>r),...t.map(r=>`Taken as ${r}`),...n.map(r=>`Note: ${r}`)],co=e=>[e.headline,...ie(e).map(t=>`- ${t}`)].join(`
`);var ct={};b(ct,{matrixOf:()=>nn,namesOf:()=>tn,showRead:()=>at,tell:()=>it,typeset:()=>G});var lo={v:["vx","vy","vz","ωx","ωy","ωz"],omega:["ωx","ωy","ωz","vx","vy","vz"]},uo=40;function tn({ask:e,first:t},n,[r,o]){let s=g(n).map(c=>c+1),a=c=>s.length===o?`joint ${s[c]}`:String(c+1),i={torques:r===1?["τ"]:[],jacobian:r===6?lo[t]:[]}[e]??[];return{columns:Array.from({length:o},(c,l)=>a(l)),rows:Array.from({length:r},(c,l)=>i[l]??`row ${l+1}`)}}function nn(e,{report:t,arm:n}){let r=t?.typed;if(!r||r.shape.length!==2)return null;let o=e.ask==="torques"&&r.shape[1]===1,[s,a]=o?[1,r.values.length]:r.shape,i=t.wrong?.length===r.values.length?t.wrong:[];return{...tn(e,n,[s,a]),typed:r,wrong:i,shape:[s,a]}}function at(e,t,n){let{table:r}=n.report??{},o=r?mo(r):po(nn(t,n));if(e.hidden=!o,!o)return;let{columns:s,rows:a,cell:i}=o,c=d("tr",{},d("td"),s.map(m=>d("th",{scope:"col"},m))),l=a.slice(0,uo).map((m,p)=>d("tr",{},d("th",{scope:"row"},m),s.map((w,j)=>i(p,j))));e.replaceChildren(d("table",{},d("caption",{},"How your answer is read"),d("thead",{},c),d("tbody",{},l)))}var mo=({cells:e,wrong:t})=>({columns:["a (m)","α","d (m)","θ"],rows:e.map((n,r)=>String(r+1)),cell:(n,r)=>rn(G(e[n][r].replaceAll("-","−")),t[n][r])}),po=e=>e&&{...e,cell(t,n){let r=t*e.shape[1]+n;return rn(fo(e.typed,r),e.wrong[r])}};function fo({values:e,units:t},n){let r=Math.min(6,t[n]?Math.max(0,Math.round(-Math.log10(t[n]))):4);return(Number(e[n].toFixed(r))+0).toFixed(r).replace("-","−")}var rn=(e,t)=>t?d("td.off",{},d("span.unseen",{},"wrong: "),e):d("td",{},e);function it(e,{report:t,error:n}){if(e.className=`verdict ${t?.grade??""}`,!t)return e.replaceChildren(d("p",{},G(n)));let r=ie(t).filter(a=>!t.headline.endsWith(a.slice(1))),o=r.length?[d("ul",{},r.map(a=>d("li",{},G(a))))]:[],s=d("span",{"aria-hidden":"true"},`${ot[t.grade]} `);return e.replaceChildren(d("p.headline",{},s,G(t.headline)),...o)}var ho=/(?<!\w)([A-Za-z]|theta|alpha)_(?:\{([^}]+)\}|(\w+))(?![\w=])/g,go={theta:"θ",alpha:"α"};function G(e){let t=[],n=0;for(let r of e.matchAll(ho)){let[o,s,a,i]=r;t.push(e.slice(n,r.index),d("i",{},go[s]??s)),t.push(d("sub",{},(a??i).replace("-","−"))),n=r.index+o.length}return[...t,e.slice(n)]}var on={"arm.js":Ne,"dom.js":Ee,"kinematics.js":$e,"judge/ask.js":nt,"judge/digits.js":Le,"judge/door.js":Ke,"judge/formula.js":Fe,"judge/grid.js":He,"judge/judges.js":be,"judge/ranking.js":st,"judge/registry.js":Ye,"judge/say.js":we,"judge/shown.js":ct};var sn=e=>[["","as it looks"],...e.map(t=>[t,t])],an={spellcheck:"false",autocomplete:"off",autocapitalize:"off"},wo={table:{label:"Table",rows:6,whole:!0,hint:"A row for each joint: a, α, d, θ, with θ or d as “q1” or “θ1 + π/2”. In m; angles as chosen."},q:{label:"Pose q",hint:"",whole:!0},unit:{label:"Angles in",choices:R.map(e=>[e,e])},frame:{label:"Rows in the axes of",choices:[]},first:{label:"Order of the rows",choices:[["v","v, then ω"],["omega","ω, then v"]]},wrench:{label:"Wrench on the tool, by the world",whole:!0,hint:"Fx, Fy, Fz in N, Mx, My, Mz in N m, in base axes; empty for none. Gravity is 9.81 m/s² down."},columns:{label:"Order of the columns",hint:"As in “theta d a alpha”; guessed where it is empty."},lengths:{label:"Lengths in",choices:sn(["m","cm","mm"])},angles:{label:"Angles in",choices:sn(R)},convention:{label:"Convention",choices:[["","as it looks"],["standard","standard"],["craig","modified (Craig)"]]},target:{label:"Where the tip should be",rows:4,whole:!0,hint:"A point x, y, z in m, or a pose: its three or four rows, in base axes."},radius:{label:"Radius of the circle below the tip, in m"},plane:{label:"Its plane",choices:[["zy","towards +y first"],["yz","towards −y"],["zx","towards +x"],["xz","towards −x"]]},period:{label:"Time for it, in s"},steps:{label:"Steps",hint:"Empty: as many as your answer has."},pace:{label:"Pace",choices:[["even","even"],["rest","from rest to rest"]]},answer:{label:"Your answer",hint:"",rows:8,whole:!0}},bo={jacobian:"Numbers or formulas in q_1, c_1, s_23, …: NumPy, MATLAB, LaTeX, Markdown, CSV or spreadsheet cells.",table:"A row for each link, with heads or without: lists, Link(…) lines, MATLAB, LaTeX, Markdown, CSV or cells.",branches:"A row for each answer, angles in the joints' order; names such as theta1 = may stand before them.",pose:"One value for each joint, in the joints' order; names such as theta1 = may stand before them.",trace:"A row for each time, one value for each joint, from CSV, MATLAB, NumPy or a spreadsheet.",torques:"One torque for each joint in N m (N where it slides), from NumPy, MATLAB, LaTeX, CSV or a spreadsheet."},xo=["frame","first","columns","lengths","angles","convention"],ln=([e,t])=>d("option",{value:e},t);function yo({choices:e,rows:t,hint:n},r,o){let s=n===void 0?{}:{"aria-describedby":[`${r}-hint`,...o].join(" ")},a={id:r,...s};return e?d("select",a,e.map(ln)):t?d("textarea",{rows:t,wrap:"off",...an,...a}):d("input",{...an,...a})}function jo(e,t,n){let r=d("label",{for:t},e.label),o=e.hint===void 0?[]:[d("p.about",{id:`${t}-hint`},e.hint)];return d(e.whole?"div.field.whole":"div.field",{},r,n,...o)}function un(e,t,n){let r={ask:{label:"Question",choices:Object.entries(y).map(([l,{title:u}])=>[l,u])},arm:{label:"Arm",choices:[...t.map(({key:l,title:u})=>[l,u]),...t.length>1&&n?[]:[[O,"My own table"]]]},...wo},o=l=>`${e}-${l}`,s=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,yo(u,o(l),l==="answer"?[o("private")]:[])])),a=Object.fromEntries(Object.entries(r).map(([l,u])=>[l,jo(u,o(l),s[l])]));for(let l of n?$o(n,t):[])a[l]?.classList.add("given");let i=n?vo(n,t):"";return n&&(s.answer.rows=6),{form:d("form",{"aria-label":`Check an answer${i&&`: ${i}`}`},i?d("p.asked",{},"Judged here: ",i):[],Object.values(a)),fields:s,boxes:a}}var $o=(e,t)=>[...Object.keys(e),...xo,...t.length<2?["arm"]:[],..."q"in e?["unit"]:[]];function vo({ask:e,q:t,wrench:n},r){let o=r.length===1?`, ${r[0].title}`:"";return[`${y[e].title}${o}`,t&&`q = (${t})`,n&&`wrench (${n})`].filter(Boolean).join(", ")}function mn({fields:e,boxes:t},n,r){let o=new Set(["ask","arm","answer",...y[n.ask].fields]);n.arm===O&&o.add("table");for(let[i,c]of Object.entries(t))c.hidden=!o.has(i);cn(t.answer,bo[n.ask]??"");let s=r.find(({key:i})=>i===n.arm);cn(t.q,s?Mo(s):"One value for each joint, in the table's order.");let a=s?s.rows.length:16;if(e.frame.options.length!==a+1){let i=l=>l?`frame ${l}`:"the base",c=Array.from({length:a+1},(l,u)=>ln([String(u),i(u)]));e.frame.replaceChildren(...c),e.frame.value=n.frame}}var cn=(e,t)=>z(e.querySelector(".about"),t),Mo=e=>`${g(e).map(n=>`q_${n+1}`).join(", ")}${oe(e).includes(!1)?"; m where a joint slides":""}`;var Ao=5e4,Oo=350,dn="Nothing that you type leaves this page: a script in it judges, without a network too.",So="It names the mistake and does not print the solution.",No=0;function pn(e){let{arms:t,examples:n=[],given:r}=JSON.parse(e.querySelector("script").textContent),o=`judge-${++No}`,s=un(o,t,r),{form:a,fields:i}=s,c=Eo(o,r),l=[],u={...L,arm:t[0]?.key,...r??n[0]},m,p=0,w=f=>u[f].length>Ao?"":u[f],j=()=>{for(let[f,v]of Object.entries(i))v.value!==w(f)&&(v.value=w(f));mn(s,u,t)},K=f=>z(c.said,f),ce=()=>{clearTimeout(p),it(c.verdict,m)},lt=()=>{ut(),ce()},ut=()=>{m=tt(u,t),m.waiting&&Ve(u.ask).then(lt,({message:f})=>K(f)),i.answer.setAttribute("aria-invalid",String(m.report?.grade==="wrong")),at(c.taken,u,m);for(let f of l)f(u,m)},le=f=>{u={...u,...f},j(),lt()};a.addEventListener("input",({target:f,inputType:v})=>{let S=Object.keys(i).find(fn=>i[fn]===f);S&&(u={...u,[S]:f.value},S==="arm"&&(u.frame="0"),(S==="arm"||S==="ask")&&(u.q=ko(u,n)?.q??u.q),j(),ut(),clearTimeout(p),v==="insertFromPaste"||v==="insertFromDrop"?ce():p=setTimeout(ce,Oo))}),a.addEventListener("submit",f=>f.preventDefault());let mt=()=>{let{question:f,words:v}=Qe(location.hash,t.map(({key:S})=>S));(f||v)&&e.scrollIntoView({block:"start"}),K(v),f&&le(f)};return e.replaceChildren(a,...Object.values(c)),le({}),r||(addEventListener("hashchange",mt),mt()),{stub:e,arms:t,examples:n,given:r,...s,parts:c,...{question:()=>u,verdict:()=>m},put:le,follow:f=>{l.push(f),f(u,m)},say:K,links:{fragment:()=>Xe(u),open:()=>!0}}}function Eo(e,t){return{verdict:d("div.verdict",{role:"status","aria-live":"polite","aria-atomic":"true"}),taken:d("div.scroll",{role:"region",tabindex:"0","aria-label":"How your answer is read"}),tools:d("div.tools"),said:d("p.about",{role:"status"}),private:d("p.private",{id:`${e}-private`},t?dn:`${dn} ${So}`)}}var ko=(e,t)=>t.find(n=>n.arm===e.arm&&n.ask===e.ask);document.head.append(Object.assign(document.createElement("style"),{textContent:pt}));for(let e of document.querySelectorAll(".arm-judge"))I.push(pn(e));if(I.some(({given:e})=>!e))W("page");else for(let{stub:e}of I)e.addEventListener("focusin",()=>W("page"),{once:!0});de({"and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","unknown symbol":"{arm}: no value for {name}; known are {known}. Give values={'{name}': ...} if it is a length of yours","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what} holds NaN or infinity; expected {wanted}",ragged:"{what} has rows of {widths} entries; expected rows of one length","taken: counted on":"symbols numbered on past what does not move: 1, 2, 3 ... are joints {joints}","taken: from zero":"symbols numbered from 0: 0, 1, 2 ... are joints {joints}"});return xn(To);})();
