(()=>{var Ve=Object.create;var Ct=Object.defineProperty;var Ge=Object.getOwnPropertyDescriptor;var Ye=Object.getOwnPropertyNames;var He=Object.getPrototypeOf,Xe=Object.prototype.hasOwnProperty;var I=(e,t)=>()=>{try{return t||e((t={exports:{}}).exports,t),t.exports}catch(o){throw t=0,o}};var Qe=(e,t,o,n)=>{if(t&&typeof t=="object"||typeof t=="function")for(let r of Ye(t))!Xe.call(e,r)&&r!==o&&Ct(e,r,{get:()=>t[r],enumerable:!(n=Ge(t,r))||n.enumerable});return e};var v=(e,t,o)=>(o=e!=null?Ve(He(e)):{},Qe(t||!e||!e.__esModule?Ct(o,"default",{value:e,enumerable:!0}):o,e));var rt=I((Ao,Ot)=>{Ot.exports=ArmExplorer.kit["dom.js"]});var H=I((Mo,Ft)=>{Ft.exports=ArmExplorer.kit["kinematics.js"]});var Pt=I((jo,_t)=>{_t.exports=ArmExplorer.kit["renderer.js"]});var pt=I((Eo,It)=>{It.exports=ArmExplorer.kit["shapes.js"]});var nt=I((qo,Nt)=>{Nt.exports=ArmExplorer.kit["text.js"]});var Jt=I((Co,Bt)=>{Bt.exports=ArmExplorer.kit["arm.js"]});var Kt=I((Oo,Ut)=>{Ut.exports=ArmExplorer.kit["grab.js"]});var Gt=I((Fo,Vt)=>{Vt.exports=ArmExplorer.kit["rail.js"]});var ut=I((_o,Yt)=>{Yt.exports=ArmExplorer.kit["scene.js"]});var Xt=I((Po,Ht)=>{Ht.exports=ArmExplorer.kit["state.js"]});var Zt=I((Io,Qt)=>{Qt.exports=ArmExplorer.kit["still.js"]});var ee=I((No,te)=>{te.exports=ArmExplorer.kit["theme.js"]});var yt=I((Ro,oe)=>{oe.exports=ArmExplorer.kit["verdicts.js"]});var de=I((Vo,ce)=>{ce.exports=ArmExplorer.kit["jobs.js"]});var me=I((Go,ue)=>{ue.exports=ArmExplorer.kit["linear.js"]});var fe=I((Yo,he)=>{he.exports=ArmExplorer.kit["motion.js"]});var qe=I((Qo,Ee)=>{Ee.exports=ArmExplorer.kit["same.js"]});var Je=I((rr,Be)=>{Be.exports=ArmExplorer.kit["figures.js"]});var Z=v(rt(),1),B=v(H(),1),le=v(Pt(),1),F=v(pt(),1);var j=v(H(),1),at=v(nt(),1),Ze=.5,to=.15,ct=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]];function eo(e,t){let o=(0,j.norm)(e);if(o<1e-9)return t;let n=ct(e,t),[r,a]=[Math.sin(o)/o,(1-Math.cos(o))/o**2];return(0,j.plus)(t,(0,j.plus)((0,j.scaled)(r,n),(0,j.scaled)(a,ct(e,n))))}function oo(e,t){let o=(0,j.norm)(e);if(o<1e-9)return t;let n=ct(e,t),[r,a]=[(1-Math.cos(o))/o**2,(o-Math.sin(o))/o**3];return(0,j.plus)(t,(0,j.plus)((0,j.scaled)(r,n),(0,j.scaled)(a,ct(e,n))))}function ro({x:e,y:t,z:o,o:n},r,a){let[i,s]=[(0,j.scaled)(a,r.slice(0,3)),(0,j.scaled)(a,r.slice(3))],[p,c,u]=[e,t,o].map(d=>eo(s,d));return{x:p,y:c,z:u,o:(0,j.plus)(n,oo(s,i))}}function dt(e,t,{k:o,twist:n},r){let a=e.rows[(0,j.joints)(e)[o]],i=r*(a.kind==="prismatic"?to:Ze),s=t.map((c,u)=>u===o?c+i:c),p=(0,j.linkFrames)(e,t).at(-1);return{by:i,row:a,q:s,tip:p,truly:(0,j.linkFrames)(e,s).at(-1),claimed:ro(p,n,i)}}var Lt=["x","y","z"];function Rt(e){let t=e.reduce((o,n,r)=>Math.abs(n)>Math.abs(e[o])?r:o,0);return`${(0,at.fixed)(1e3*(0,j.norm)(e),0)} mm, mostly along ${e[t]<0?"−":"+"}${Lt[t]}`}function no(e,t){let o=Lt.reduce((n,r)=>n+e[r].reduce((a,i,s)=>a+i*t[r][s],0),0);return 180/Math.PI*Math.acos(Math.min(1,Math.max(-1,(o-1)/2)))}function Dt({by:e,row:t,tip:o,truly:n,claimed:r},a){let[i,s]=[r,n].map(({o:f})=>(0,j.minus)(f,o.o)),p=t.kind==="prismatic"?`Joint ${a} slid by ${(0,at.fixed)(1e3*e,0)} mm`:`Joint ${a} turned by ${(0,at.fixed)(180/Math.PI*e,0)}°`,c=f=>(0,j.norm)(f)<.001,u=(0,j.norm)((0,j.minus)(i,s))<.001?"your column takes the tip where the arm takes it":`your column ${c(i)?"leaves the tip where it is":`takes the tip ${Rt(i)}`}; the arm ${c(s)?"leaves it there":`takes it ${Rt(s)}`}`,d=no(r,n),w=d>.5?` The tool would end turned by ${(0,at.fixed)(d,0)}° from where it does.`:"";return`${p}: ${u}.${w}`}var Wt=`:host {
  display: block;
  margin: 1.2rem 0;
  container-type: inline-size;
}
.live {
  --ink: #1f2933;
  --soft: #5b6775;
  --line: #dde2e8;
  --ground: #fff;
  --raised: #f6f8fa;
  --accent: #24618c;
  --bad: #a83a08;
  --bad-ground: #fdf0e8;
  --rail: #d4dae1;
  --x: #b94f00;
  --y: #007a5a;
  --z: #005e94;
  margin: 0;
  display: grid;
  color: var(--ink);
  background: var(--ground);
  border: 1px solid var(--line);
  border-radius: 12px;
  overflow: clip;
  font-family: var(--pst-font-family-base, system-ui, sans-serif);
  font-size: 14px;
  line-height: 1.45;
  font-variant-numeric: tabular-nums;
}
.live[data-theme="dark"] {
  --ink: #e4e8ed;
  --soft: #a3adba;
  --line: #38404a;
  --ground: #171b21;
  --raised: #1f252d;
  --accent: #7fb8e2;
  --bad: #ffab7a;
  --bad-ground: #3a2417;
  --rail: #434d59;
  --x: #f58a3c;
  --y: #3cc79b;
  --z: #5ab4ec;
  color-scheme: dark;
}
*,
::before,
::after {
  box-sizing: border-box;
}
[hidden] {
  display: none !important;
}
p {
  margin: 0;
}
i {
  font-family: Georgia, "Times New Roman", serif;
}
sub {
  font-size: 0.72em;
  line-height: 0;
}
.hidden {
  position: absolute;
  width: 1px;
  height: 1px;
  overflow: hidden;
  clip-path: inset(50%);
}
.stage {
  position: relative;
  height: 260px;
  overflow: hidden;
}
.stage canvas {
  position: absolute;
  inset: 0;
  cursor: grab;
}
.labels {
  position: absolute;
  inset: 0;
  pointer-events: none;
}
.labels span {
  position: absolute;
  font-size: 12.5px;
  line-height: 1;
  text-shadow:
    0 0 3px var(--ground),
    0 0 3px var(--ground);
}
.axis-x {
  color: var(--x);
}
.axis-y {
  color: var(--y);
}
.axis-z {
  color: var(--z);
}
.grip {
  position: absolute;
  left: 0;
  top: 0;
  width: 30px;
  height: 30px;
  margin: -15px;
  padding: 0;
  border-radius: 50%;
  border: 1.5px dashed color-mix(in srgb, var(--accent) 55%, transparent);
  background: none;
  touch-action: none;
  cursor: grab;
}
.side {
  padding: 12px 14px;
  display: grid;
  gap: 9px;
  align-content: center;
  border-top: 1px solid var(--line);
}
.words {
  font-size: 13.5px;
}
.why {
  color: var(--bad);
  font-weight: 600;
}
.lever {
  display: grid;
  grid-template-columns: 74px minmax(0, 1fr) 76px;
  align-items: center;
  gap: 8px;
}
.lever output {
  text-align: right;
}
.rail {
  touch-action: pan-y;
  min-height: 30px;
  display: grid;
  align-items: center;
  cursor: pointer;
}
.rail input {
  pointer-events: none;
  width: 100%;
  margin: 0;
  accent-color: var(--accent);
}
button {
  font: inherit;
  color: var(--ink);
  background: var(--ground);
  border: 1px solid var(--line);
  border-radius: 7px;
  padding: 3px 10px;
  cursor: pointer;
}
button[aria-pressed="true"],
button[aria-checked="true"] {
  background: color-mix(in srgb, var(--accent) 16%, var(--ground));
  border-color: var(--accent);
}
:focus-visible {
  outline: 2px solid var(--accent);
  outline-offset: 2px;
}
.row {
  display: flex;
  flex-wrap: wrap;
  gap: 6px;
}
.scroll {
  overflow-x: auto;
}
table {
  border-collapse: separate;
  border-spacing: 2px;
  font-size: 12.5px;
}
td,
th {
  padding: 2px 6px;
  text-align: right;
  font-weight: 400;
  border-radius: 4px;
}
th button {
  padding: 1px 8px;
}
td.on {
  background: color-mix(in srgb, var(--accent) 20%, transparent);
}
.bars {
  display: grid;
  gap: 4px;
}
.bar {
  display: grid;
  grid-template-columns: 30px minmax(0, 1fr) 78px;
  gap: 8px;
  align-items: center;
  font-size: 13px;
}
.bar span:last-child {
  text-align: right;
}
.track {
  height: 10px;
  background:
    linear-gradient(to right, transparent calc(50% - 0.5px), var(--soft) 0 calc(50% + 0.5px), transparent 0),
    var(--raised);
  position: relative;
}
.fill {
  position: absolute;
  inset-block: 1px;
  background: var(--accent);
}
@container (min-width: 560px) {
  .live {
    grid-template-columns: minmax(0, 1.15fr) minmax(0, 1fr);
  }
  .side {
    border-top: 0;
    border-left: 1px solid var(--line);
  }
  .stage {
    height: auto;
    min-height: 280px;
  }
}
@media (pointer: coarse) {
  button,
  .rail {
    min-height: 44px;
    min-width: 44px;
  }
  .grip {
    width: 44px;
    height: 44px;
    margin: -22px;
  }
}
.paper {
  display: none;
}
@media print {
  .live {
    display: none;
  }
  .paper {
    display: block;
  }
}
`;var mt=v(Jt(),1),M=v(rt(),1),ht=v(Kt(),1),re=v(H(),1),$t=v(Gt(),1),ne=v(ut(),1),ft=v(Xt(),1),st=v(Zt(),1),wt=v(nt(),1),ae=v(ee(),1),se=v(yt(),1);var kt=[{name:"Panda",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.0825,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.054982,.066502,.039252]},{kind:"revolute",a:-.0825,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.029330000000000002,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"Panda (homework)",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.060481999999999994,.066502,.039252]},{kind:"revolute",a:-.088,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.03482999999999999,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"UR10e",home:[0,-1.5707963267948966,0,-1.5707963267948966,0,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1807,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[7.369,.021,0,.027]},{kind:"revolute",a:-.6127,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[13.051,.38,0,.158]},{kind:"revolute",a:-.57155,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150,body:[3.989,.24,0,.068]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.17415,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[2.1,0,.007,.018]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.11985,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[1.98,0,.007,.018]},{kind:"revolute",a:0,alpha:0,d:.21655000000000002,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[.615,0,0,-.126]}]},{name:"UR10e (homework)",home:[0,0,0,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.128,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.6127,alpha:3.141592653589793,d:0,theta:-1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.5716,alpha:3.141592653589793,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1639,theta:1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.1157,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:0,d:.1922,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56}]},{name:"Stanford arm",home:[0,0,.5,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.154,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"prismatic",a:0,alpha:0,d:0,theta:0,lower:.1,upper:1,speed:null,effort:null},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:0,d:.263,theta:0,lower:null,upper:null,speed:null,effort:null}]},{name:"Elbow arm",home:[0,.7853981633974483,-1.5707963267948966],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.5,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.4,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.3,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null}]}];var zt=e=>kt.find(t=>t.name===e)??kt[0],io=0;function N(e,t,{state:o={},hold:n=!0,words:r,side:a=[]}){let i=new AbortController,{signal:s}=i,p=typeof t.arm=="object"?t.arm:zt(t.arm),c=new ft.Store((0,ft.startingState)({arm:p,q:t.q??(0,mt.homeOf)(p),...o})),u=e.shadowRoot??e.attachShadow({mode:"open"}),d=(0,M.h)("div.labels",{"aria-hidden":"true"}),w=(0,M.h)("button.grip",{type:"button","aria-label":"Tip: drag it, or move it by arrow keys",hidden:!n,onkeydown:g=>k&&(0,ht.moveTipByKey)(k,c,g)}),f=(0,M.h)("div.stage",{role:"group","aria-label":`The ${p.name}`},d,w),m=(0,M.h)("p.words"),l=(0,M.h)("p.why",{hidden:!0}),x=(t.joints??[]).map(g=>J(g)),E=(0,M.h)("figure.live",{},f,(0,M.h)("div.side",{},...a,...x.map(g=>g.root),m,l));u.replaceChildren((0,M.h)("style",{},Wt),E,(0,M.h)("div.paper",{},(0,M.h)("slot")));let k=null;try{k=new ne.ArmPicture(f,d,{onPlace:([g,L])=>w.style.transform=`translate(${g}px, ${L}px)`}),n&&(0,ht.makeGrabbable)(k,c,{grip:w,goTo:g=>c.dispatch({type:"glide",q:g})})}catch{w.hidden=!0}function J(g){let L=(0,re.joints)(p).indexOf(g-1),G=p.rows[g-1],[V,vt]=(0,mt.range)(G),X=(b,P=null)=>{c.dispatch({type:"move",q:c.state.q.map((A,S)=>S===L?b:A),gesture:P})},tt=(0,M.h)("input",{type:"range",min:V,max:vt,step:"any","aria-label":`Joint ${g}`,oninput:b=>X(Number(b.target.value),`keys ${g}`)}),z=(0,M.h)("div.rail",{},tt),C=null;(0,$t.relativeRail)(z,tt,{start:()=>C=`lever ${++io}`,put:b=>X(b,C),signal:s});let _=(0,M.h)("output"),O=({q:b,unit:P})=>{tt.value=String(b[L]),tt.setAttribute("aria-valuetext",(0,wt.spokenJoint)(G,b[L],P)),(0,M.write)(_,(0,wt.jointText)(G,b[L],P))};return{root:(0,M.h)("div.lever",{},(0,M.h)("span",{},(0,M.indexed)("q",g)),z,_),show:O}}let U="light",et=[];function K(){let{state:g,derived:L}=c;for(let V of x)V.show(g);(0,M.write)(m,r(g,L));let G=g.hold?.target&&!g.hold.moving?(0,se.stopVerdict)(g.hold):"";(0,M.write)(l,G),l.hidden=!G,k?k.draw(g,L,U):f.replaceChildren((0,st.stillSvg)(g.arm,L.frames,(0,st.poseText)(g.arm,g.q)));for(let V of et)V(g,L);f.setAttribute("aria-label",(0,st.poseText)(g.arm,g.q))}return(0,ae.watchTheme)(g=>{U=g,E.dataset.theme=g,K()},s),c.listen(K,s),{store:c,picture:k,card:E,signal:s,refresh:K,follow:g=>(et.push(g),K()),dispose(){i.abort(),k?.dispose(),u.replaceChildren()}}}function Q(e,[t,o],n,{put:r,text:a,signal:i}){let s=(0,M.h)("input",{type:"range",min:t,max:o,step:"any",value:n,"aria-label":e}),p=(0,M.h)("output",{},a(n)),c=d=>{s.value=String(d),s.setAttribute("aria-valuetext",a(d)),(0,M.write)(p,a(d)),r(d)};s.addEventListener("input",()=>c(Number(s.value)),{signal:i});let u=(0,M.h)("div.rail",{},s);return(0,$t.relativeRail)(u,s,{put:c,signal:i}),{root:(0,M.h)("div.lever",{},(0,M.h)("span",{},e),u,p),move:c}}var ie=24,lo=1600;function pe(e){let t=new AbortController,o=e.answer,[n,r]=[0,0],a=Q("further",[-1,1],0,{put:l=>(cancelAnimationFrame(r),w(l)),text:l=>`${Math.round(100*l)} %`,signal:t.signal}),i=(0,Z.h)("button",{type:"button",onclick:()=>f()},""),s=(0,Z.h)("div.row",{},i,a.root),p=N(e,{arm:o.arm,q:o.q},{hold:!1,state:{unit:"rad"},side:[s],words:()=>co(o,n)}),{store:c,picture:u}=p,d=u&&new At(u);function w(l){n=l,c.dispatch({type:"set",q:o.claim?dt(o.arm,o.q,o.claim,n).q:o.q}),p.refresh()}function f(){cancelAnimationFrame(r);let l=performance.now(),x=E=>{let k=(0,Z.calm)()?1:Math.min(1,(E-l)/lo);a.move((1-Math.cos(Math.PI*k))/2),k<1&&(r=requestAnimationFrame(x))};x(l)}function m(){cancelAnimationFrame(r);let{arm:l,wrench:x=[0,0,0,0,0,0],claim:E}=o;l!==c.state.arm&&c.dispatch({type:"select",arm:l,q:o.q}),c.dispatch({type:"set",wrench:x,view:x.some(Boolean)?"torque":"pose"}),s.hidden=!E,E&&(0,Z.write)(i,po(l,(0,B.joints)(l)[E.k])),a.move(0)}return p.follow(()=>d?.draw(o,n)),e.addEventListener("answer",()=>(o=e.answer,m()),{signal:t.signal}),m(),()=>(cancelAnimationFrame(r),t.abort(),p.dispose())}var po=(e,t)=>`${e.rows[t].kind==="prismatic"?"Slide":"Turn"} joint ${t+1}`;function co({arm:e,q:t,claim:o,words:n},r){return!o||!r?n:Dt(dt(e,t,o,r),(0,B.joints)(e)[o.k]+1)}var At=class{constructor(t){this.picture=t,this.drawn=[],this.made=[]}draw(t,o){let{picture:n}=this;n.world&&(n.body.tint(r=>t.axes.includes(r)||t.links.includes(r)?n.tints.bad:null),!(this.drawn[0]===t&&this.drawn[1]===o&&this.drawn[2]===n.world)&&(this.drawn=[t,o,n.world],this.made.forEach(le.freed),this.made=this.pieces(t,o),n.world.add(...this.made),n.figure.request()))}pieces(t,o){let{picture:n}=this,[r,a]=[n.look.bad,n.look.ghost],i=n.frames,s=t.axes.map(p=>this.line(uo(i[p],.3*n.size),.004,r));s.push(...t.links.map(p=>this.line(mo(i,p),.02,r)));for(let{arm:p,q:c}of t.ghosts){let u=(0,F.ghostMaterial)(r,.4),d=new F.ArmShape(p,{link:u,joint:u,ghost:!0});d.pose((0,B.linkFrames)(p,c)),s.push(d)}return t.path&&s.push((0,F.tube)(t.path,.003*n.size,r)),t.claim&&o?[...s,...this.claim(t,o,r,a)]:s}claim({arm:t,q:o,claim:n},r,a,i){let{picture:s}=this,p=Array.from({length:ie+1},(w,f)=>dt(t,o,n,r*f/ie)),c=new F.Triad(s.dark);c.pose(p.at(-1).claimed,.1*s.size);let u=(0,F.ball)((0,F.paint)(a));u.scale.setScalar(.016*s.size),u.position.fromArray(p.at(-1).claimed.o);let d=.005*s.size;return[c,u,(0,F.tube)(p.map(({claimed:w})=>w.o),d,a),(0,F.tube)(p.map(({truly:w})=>w.o),d,i)]}line({start:t,end:o},n,r){let a=(0,F.rod)((0,F.paint)(r));return(0,F.along)(a,t,o,n*this.picture.size),a}},uo=({o:e,z:t},o)=>({start:(0,B.minus)(e,(0,B.scaled)(o,t)),end:(0,B.plus)(e,(0,B.scaled)(o,t))}),mo=(e,t)=>({start:e[t].o,end:e[t+1].o});var y=v(rt(),1),Mt=v(de(),1),$=v(H(),1),we=v(me(),1),ge=v(fe(),1),jt=v(ut(),1),xt=v(pt(),1),T=v(nt(),1),bt=v(yt(),1);var ho="only the entries with its angle move; the last column goes round on a circle of radius a.",fo=e=>e.map(t=>(0,T.fixed)(1e3*t,0)).join(", "),gt=e=>`${(0,T.fixed)(e*180/Math.PI,0)}°`;function xe(e,t){let o=(n,{frames:r})=>`${t.words??"Drag a link, or the tip."} The tip is at (${fo(r.at(-1).o)}) mm.`;return N(e,t,{state:{frames:t.frames??"ends"},words:o}).dispose}function be(e,t){let o=["turn by θ about z","slide by d along z","slide by a along x","turn by α about x"],n=new AbortController,r=4,a=N(e,t,{hold:!1,state:{frames:"all"},words:({arm:u})=>{let{theta:d,d:w,a:f,alpha:m}=u.rows[0],l=[gt(d),`${(0,T.fixed)(1e3*w,0)} mm`,`${(0,T.fixed)(1e3*f,0)} mm`,gt(m)],x=o.slice(0,Math.ceil(r)).map((E,k)=>`${E} (${l[k]})`);return x.length?`${x.join(", then ")}.`:"The frame before the row."}}),s=a.store.state.arm.rows[(t.row??1)-1],c=Q("motions",[0,4],4,{put:u=>{r=u;let d=x=>Math.min(1,Math.max(0,u-x)),w=s.theta+(s.kind==="revolute"?t.angle??.7:0),f=s.d+(s.kind==="prismatic"?t.slide??.3:0),m={kind:"fixed",theta:d(0)*w,d:d(1)*f,a:d(2)*s.a,alpha:d(3)*s.alpha},l={name:`Row ${t.row??1}`,home:[],rows:[m]};a.store.dispatch({type:"select",arm:l,q:[]})},text:u=>`${(0,T.fixed)(u,1)} of 4`,signal:n.signal});return a.card.querySelector(".side").prepend(c.root),c.move(4),a.picture?.fit(),()=>(n.abort(),a.dispose())}function ve(e,t){let o=t.row??1,n=Array.from({length:4},()=>Array.from({length:4},()=>(0,y.h)("td"))),r=(0,y.h)("table",{"aria-label":`A ${o}`},n.map(s=>(0,y.h)("tr",{},s))),a=(0,y.h)("span",{},(0,y.indexed)("A",o)," ="),i=N(e,{...t,joints:[o]},{state:{frames:"all"},side:[(0,y.h)("div.row",{},a,(0,y.h)("div.scroll",{},r))],words:()=>t.words??`Turn joint ${o}: ${ho}`});return i.follow(s=>{let p=(0,$.linkFrames)({rows:[s.arm.rows[o-1]]},[s.q[(0,$.joints)(s.arm).indexOf(o-1)]]);(0,$.matrix)(p[1]).forEach((c,u)=>c.forEach((d,w)=>(0,y.write)(n[u][w],u===3?String(d):(0,T.sparse)(d,3))))}),i.dispose}function ye(e,t){let o=0,n=(0,y.h)("tr"),r=(0,y.h)("tbody"),a=(0,y.h)("table",{"aria-label":"Jacobian of the tip"},(0,y.h)("thead",{},n),r),i=N(e,t,{side:[(0,y.h)("div.scroll",{},a)],words:({arm:f})=>{let m=(0,$.joints)(f)[o],l=f.rows[m].kind==="revolute"?"turns about its axis":"slides";return`Column ${o+1}: the tip moves along the arrow when joint ${m+1} ${l} alone.`}}),{store:s,picture:p}=i,c=p&&new xt.Arrow(p.force.shaft.material),u=f=>()=>{o=f,s.dispatch({type:"show",lit:(0,$.joints)(s.state.arm)[f]}),i.refresh()},d=(0,$.joints)(s.state.arm).map((f,m)=>(0,y.h)("button",{type:"button","aria-pressed":"false",onpointerenter:u(m),onfocus:u(m),onclick:u(m)},(0,y.indexed)("J",f+1)));n.replaceChildren((0,y.h)("th"),...d.map(f=>(0,y.h)("th",{},f)));let w=["vx","vy","vz","ωx","ωy","ωz"].map(f=>[f,d.map(()=>(0,y.h)("td"))]);return r.replaceChildren(...w.map(([f,m])=>(0,y.h)("tr",{},(0,y.h)("th",{},(0,y.indexed)(f[0],f[1])),m))),i.follow((f,m)=>{if(w.forEach(([,x],E)=>x.forEach((k,J)=>{(0,y.write)(k,(0,T.sparse)(m.columns[J][E],2)),k.classList.toggle("on",J===o)})),d.forEach((x,E)=>x.setAttribute("aria-pressed",String(E===o))),!c||!p.world)return;c.parent!==p.world&&p.world.add(c);let l=(0,$.scaled)(.3,m.columns[o].slice(0,3));c.point(m.frames.at(-1).o,l,.008*p.size)}),u(t.column?t.column-1:0)(),i.dispose}function ke(e,t){return N(e,t,{state:{view:"jacobian"},words:(n,r)=>`Half axes ${r.linear.values.map(i=>(0,T.fixed)(i,2)).join(", ")}. ${(0,bt.rankVerdict)(r).text}`}).dispose}function $e(e,t){let o=(0,y.h)("div.bars"),n=N(e,t,{state:{view:t.push?"torque":"pose",wrench:t.wrench??[0,0,0,0,0,0]},side:[o],words:(a,{torque:i})=>{let s=i.reduce((c,u,d)=>Math.abs(u)>Math.abs(i[c])?d:c,0),p=`joint ${(0,$.joints)(a.arm)[s]+1}: ${(0,T.fixed)(i[s],1)} N m`;return`${t.words??"Move the arm."} The most is asked of ${p}.`}}),r=(0,$.joints)(n.store.state.arm).map(a=>{let[i,s]=[(0,y.h)("span.fill"),(0,y.h)("span")];return{fill:i,value:s,root:(0,y.h)("div.bar",{},(0,y.h)("span",{},(0,y.indexed)("τ",a+1)),(0,y.h)("span.track",{},i),s)}});return o.replaceChildren(...r.map(a=>a.root)),n.follow((a,{torque:i})=>{let s=Math.max(...(0,$.joints)(a.arm).map(p=>a.arm.rows[p].effort??50));r.forEach(({fill:p,value:c},u)=>{let d=Math.max(-1,Math.min(1,i[u]/s));Object.assign(p.style,{left:`${50+50*Math.min(0,d)}%`,width:`${50*Math.abs(d)}%`}),(0,y.write)(c,`${(0,T.fixed)(i[u],1)} N m`)})}),n.dispose}function ze(e,t){let o=new AbortController,n=N(e,t,{words:d=>`The tip stays; ${(0,$.joints)(d.arm).map((f,m)=>`q${f+1} ${(0,T.jointText)(d.arm.rows[f],d.q[m],"deg")}`).join(", ")}.`}),{store:r}=n,a=r.derived.frames.at(-1);r.dispatch({type:"show",hold:{pinned:a,turns:!0,free:1}});let i=wo(r.state.arm,r.state.q,a),s=i.findIndex(d=>d===r.state.q),p=d=>{let w=i[Math.max(0,Math.min(i.length-1,Math.round(d)))];r.dispatch({type:"move",q:w,hold:r.state.hold,gesture:"swing"})},c=d=>gt(i[Math.round(d)]?.[2]-i[s][2]),u=Q("elbow",[0,i.length-1],s,{put:p,text:c,signal:o.signal});return n.card.querySelector(".side").prepend(u.root),()=>(o.abort(),n.dispose())}function wo(e,t,o){let n=(0,$.joints)(e).map(a=>[e.rows[a].lower??-1/0,e.rows[a].upper??1/0]),r=a=>{let i=[],[s,p]=[t,null];for(let c=0;c<80;c++){let u=go(e,s),[d]=(0,we.rightNull)(u);if(!d)break;let w=p?d.reduce((l,x,E)=>l+x*p[E],0):a*d[2],f=d.map(l=>w<0?-l:l),m=(0,ge.reach)(e,s.map((l,x)=>l+.03*f[x]),o).q;if(m.some((l,x)=>l<n[x][0]||l>n[x][1]))break;i.push(m),[s,p]=[m,f]}return i};return[...r(-1).reverse(),t,...r(1)]}function go(e,t){let o=(0,$.linkFrames)(e,t),n=o.at(-1).o;return(0,$.joints)(e).map(r=>{let{z:a,o:i}=o[r],s=(0,$.minus)(n,i);return[...[a[1]*s[2]-a[2]*s[1],a[2]*s[0]-a[0]*s[2],a[0]*s[1]-a[1]*s[0]],...a]})}function Ae(e,t){let o=new AbortController,[n,r,a,i]=[null,0,t.radius??.1,0],s=N(e,t,{hold:!1,state:{view:"trace",lit:t.lit?t.lit-1:null},words:({arm:l})=>{if(!n)return"Computing …";let x=`Radius ${(0,T.fixed)(100*a,1)} cm`;if(n.largest>1e-4)return`${x}: no run gets round; the arm would have to pass a singular pose.`;let E=(0,$.joints)(l).flatMap((k,J)=>Math.abs(n.wound[J])>.9?[`joint ${k+1}`]:[]);return`${x}: ${E.length?`${(0,T.listed)(E)} wind once round`:"the joints swing and come back"}.`}}),{store:p}=s,c=p.state.q,u=()=>{let{path:l}=n,x=Math.round(r*(l.length-1));p.dispatch({type:"set",trace:l,q:l[x]})},d=async()=>{let l=++i,{arm:x}=p.state,E=await(0,Mt.ask)("run",{arm:x,q:c,run:{method:"exact",steps:180,radius:a}});l!==i||o.signal.aborted||(n=E,u(),s.refresh())},w={signal:o.signal},f=Q("round",[0,1],0,{...w,put:l=>(r=l,n&&u()),text:l=>`${(0,T.fixed)(100*l,0)} %`}),m=Q("radius",[.01,.1],a,{...w,put:l=>(a=l,d()),text:l=>`${(0,T.fixed)(100*l,1)} cm`});return s.card.querySelector(".side").prepend(...t.fixed?[f.root]:[m.root,f.root]),d(),()=>(o.abort(),s.dispose())}function Me(e,t){let o=(0,y.h)("div.row",{role:"radiogroup","aria-label":"Ways"}),n=N(e,t,{state:{view:"branches"},side:[o],words:({arm:i,ways:s})=>s?(0,bt.waysVerdict)(i,s):"Computing …"}),{store:r}=n,a=!1;return(0,Mt.ask)("ways",{arm:r.state.arm,q:r.state.q}).then(i=>{a||(r.dispatch({type:"ways",arm:r.state.arm,ways:i}),o.replaceChildren(...i.list.map(({q:s},p)=>(0,y.h)("button",{type:"button",role:"radio","aria-label":`Way ${p+1}`,style:`border-left: 6px solid ${(0,jt.branchColour)(p)}`,onclick:()=>r.dispatch({type:"glide",q:s})},String(p+1)))),n.refresh())}),n.follow(({q:i,ways:s})=>{[...o.children].forEach((p,c)=>{let u=s?.list[c]?.q.every((d,w)=>Math.abs(d-i[w])<.001);p.setAttribute("aria-checked",String(!!u))})}),()=>(a=!0,n.dispose())}function je(e,t){let o=N(e,{arm:"Elbow arm",...t},{words:({arm:a,q:i},{frames:s})=>{let[p,c]=[s[1].o,s.at(-1).o],u=(0,$.norm)((0,$.minus)(c,p)),[d,w]=[a.rows[1].a,a.rows[2].a],f=(u*u-d*d-w*w)/(2*d*w);return`${`Shoulder to tip ${(0,T.fixed)(1e3*u,0)} mm`}, so D = ${(0,T.fixed)(f,3)} and θ₃ = ${gt(i[2])}; its cosine is D.`}}),{picture:n}=o,r=[];return o.follow((a,{frames:i})=>{if(!n?.world)return;for(let m of r)m.traverse(l=>{l.material?.dispose(),l.geometry?.dispose()}),m.removeFromParent();let[s,p,c]=i.slice(1).map(m=>m.o),u=[c[0],c[1],s[2]],d=(m,l)=>[m,(0,$.plus)((0,$.scaled)(.5,m),(0,$.scaled)(.5,l)),l],w=.003*n.size;r=[[s,c,0],[s,u,2],[u,c,2],[s,p,1],[p,c,1]].filter(([m,l])=>(0,$.norm)((0,$.minus)(m,l))>.001).map(([m,l,x])=>(0,xt.tube)(d(m,l),w,(0,jt.branchColour)(x))),r.forEach(m=>n.world.add(m))}),o.dispose}var q=v(rt(),1),Le=v(H(),1),De=v(qe(),1),Tt=v(ut(),1),R=v(pt(),1),it=v(nt(),1),D=v(H(),1);var h=v(H(),1),Et=1e-6,Se=e=>(0,h.scaled)(1/(0,h.norm)(e),e),Te=(e,t,o)=>Math.atan2((0,h.dot)(e,(0,h.cross)(t,o)),(0,h.dot)(t,o)),xo=(e,t)=>e.every(o=>(0,h.norm)((0,h.minus)(t,o))>1e-4);function Oe(e){let t=(0,h.joints)(e).map((r,a)=>e.rows[r].kind==="prismatic"?Math.max(.3,e.home[a]||0):0),o=(0,h.linkFrames)(e,t),n=(0,h.joints)(e).map(r=>({z:o[r].z,o:o[r].o,row:r}));return{q:t,frames:o,axes:n,base:o[0],end:o.at(-1)}}function Ce(e,t,o,n){let r=(0,h.minus)(o,e),a=(0,h.cross)(t,n),i=(0,h.dot)(a,a);return i<Et?[e,(0,h.plus)(o,(0,h.scaled)(-(0,h.dot)(n,r),n))]:[(0,h.plus)(e,(0,h.scaled)((0,h.dot)((0,h.cross)(r,n),a)/i,t)),(0,h.plus)(o,(0,h.scaled)((0,h.dot)((0,h.cross)(r,t),a)/i,n))]}function qt(e,t){let o=t.length,n=t[o-1],r=o===e.axes.length,a=r?{z:n.z,o:e.end.o}:e.axes[o],[,i]=Ce(n.o,n.z,a.o,a.z),s=e.axes[o+1],p=[],c=r?[e.end.o]:[i,a.o,...s?[Ce(a.o,a.z,s.o,s.z)[0]]:[]];for(let u of c)xo(p,u)&&p.push(u);if(!r)for(let u of[...p])p.length<3&&p.push((0,h.plus)(u,(0,h.scaled)(.12,a.z)));return{zs:[a.z,(0,h.scaled)(-1,a.z)],points:p.slice(0,4),axis:a}}function Fe(e,t,o){let n=(0,h.cross)(e.z,t);(0,h.norm)(n)<Et&&(n=(0,h.minus)((0,h.minus)(o,e.o),(0,h.scaled)((0,h.dot)((0,h.minus)(o,e.o),e.z),e.z))),(0,h.norm)(n)<Et&&(n=e.x),n=Se(n);let r=Se((0,h.cross)(t,n));return[n,(0,h.scaled)(-1,n),r,(0,h.scaled)(-1,r)]}function _e(e,{x:t,z:o,o:n},r){if(Math.abs((0,h.dot)(t,o))>1e-4)return`x_${r} is not at a right angle to z_${r}.`;if(Math.abs((0,h.dot)(t,e.z))>1e-4)return`x_${r} is not at a right angle to z_${r-1}: no α about x_${r} can then turn z_${r-1} into z_${r}.`;let a=(0,h.minus)(n,e.o),i=(0,h.minus)((0,h.minus)(a,(0,h.scaled)((0,h.dot)(a,e.z),e.z)),(0,h.scaled)((0,h.dot)(a,t),t));return(0,h.norm)(i)>1e-4?`The line of x_${r} does not meet the axis z_${r-1}: no slide a along x_${r} can then bring o_${r} there.`:null}function bo(e,t,o,n){let r=(0,h.minus)(t.o,e.o),a=(0,h.dot)(r,e.z);return{kind:o,a:(0,h.dot)(r,t.x),alpha:Te(t.x,e.z,t.z),d:o==="prismatic"?a-n:a,theta:Te(e.z,e.x,t.x)}}var Pe=(e,t,o)=>({x:t,y:(0,h.cross)(e,t),z:e,o});function St(e,t,o){return o.slice(1).map((n,r)=>{let{row:a}=t.axes[r],i=Math.sign((0,h.dot)(o[r].z,t.axes[r].z));return bo(o[r],n,e.rows[a].kind,i*t.q[r])})}function Ie(e=Math.random){let t=r=>r[Math.floor(e()*r.length)],o=t([3,4,5]),n=Array.from({length:o},(r,a)=>{let i=a===o-1,s=t(i?[.15,.2]:[0,.2,.3]),p=a===0?.3:t(s?[0,0,.15]:[.2,.25]),c=a>0&&!i&&e()<.2?"prismatic":"revolute",u=t([0,Math.PI/2,-Math.PI/2]);return{kind:c,a:s,alpha:i?0:u,d:p,theta:0,...{lower:null,upper:null,speed:null,effort:null}}});return{name:"An arm of its own",home:n.map(r=>r.kind==="prismatic"?.3:0),rows:n}}var vo=22,Ne="An arm of its own",yo="A table of this arm; the book chose other directions or zeros, which are free.",ko={z:e=>`Frame ${e}: which way shall z point along its axis?`,o:e=>`Frame ${e}: where on that axis is its origin?`,x:e=>`Frame ${e}: and which way does x point?`};function We(e,t){let o=["UR10e (homework)","Panda (homework)","Stanford arm","Elbow arm",Ne],n=(0,q.h)("select",{"aria-label":"Arm to place frames on",onchange:z=>J(z.target.value)},o.map(z=>(0,q.h)("option",{value:z,selected:z===t.arm},z))),r=(0,q.h)("p.words",{"aria-live":"polite"}),a=(0,q.h)("div.row",{role:"group","aria-label":"Choices"}),i=(0,q.h)("button",{type:"button",onclick:()=>G()},"Back"),s=(0,q.h)("p.why",{hidden:!0,"aria-live":"polite"}),p=(0,q.h)("tbody"),c=["i","a (m)","α (°)","d (m)","θ (°)"].map(z=>(0,q.h)("th",{scope:"col"},z)),u=(0,q.h)("table",{"aria-label":"The table so far"},(0,q.h)("thead",{},(0,q.h)("tr",{},c)),p),d=[(0,q.h)("div.row",{},n,i),r,a,s,(0,q.h)("div.scroll",{},u)],w,f,m,l,x=N(e,{arm:t.arm??o[3]},{hold:!1,side:d,words:()=>""}),{store:E,picture:k}=x;function J(z){w=z===Ne?Ie():zt(z),f=Oe(w),m=[f.base],l={},E.dispatch({type:"select",arm:w,q:f.q});let C=f.axes.flatMap(({z:_,o:O})=>[-1,1].map(b=>(0,D.plus)(O,(0,D.scaled)(b*1.3*g(),_))));k?.figure.fit([...C,f.end.o,(0,D.plus)(f.end.o,[0,0,g()]),[0,0,0]]),V()}let U=()=>l.z?l.o?"x":"o":"z",et=()=>m.length>f.axes.length;function K(){if(et())return[];let z=m.at(-1),{zs:C,points:_,axis:O}=qt(f,m);return U()==="z"?C.map(b=>({value:b,at:(0,D.plus)(O.o,(0,D.scaled)(g(),b)),label:Re(b)})):U()==="o"?_.map((b,P)=>({value:b,at:b,label:"ABCD"[P]})):Fe(z,l.z,l.o).map(b=>({value:b,at:(0,D.plus)(l.o,(0,D.scaled)(g(),b)),label:Re(b)}))}let g=()=>.16*(k?.size??1);function L({value:z}){if(l={...l,[U()]:z},s.hidden=!0,l.x){let C=Pe(l.z,l.x,l.o),_=_e(m.at(-1),C,m.length);if(_){let{z:O,o:b}=l;l=/does not meet/.test(_)?{z:O}:{z:O,o:b},(0,q.write)(s,_.replaceAll(/_(\d+)/g,(P,A)=>[...A].map(S=>"₀₁₂₃₄₅₆₇₈₉"[S]).join(""))),s.hidden=!1}else m=[...m,C],l={}}V()}function G(){l.o?l={z:l.z}:l.z?l={}:m.length>1&&(m=m.slice(0,-1)),s.hidden=!0,V()}function V(){let C=K().map(O=>(0,q.h)("button",{type:"button",onclick:()=>L(O)},O.label));a.replaceChildren(...C),(0,q.write)(r,et()?vt():ko[U()](m.length)),i.disabled=m.length===1&&!l.z;let _=St(w,f,m);p.replaceChildren(..._.map((O,b)=>{let P=O.kind==="revolute"?"theta":"d",A=(W,Ke)=>(0,q.h)("td",{},Ke,...W===P?[" + ",...(0,q.indexed)("q",b+1)]:[]),S=W=>(0,it.entryText)(W,!0,"deg"),Y=W=>A(W,(0,it.entryText)(O[W],!1,"deg")),ot=W=>A(W,S(O[W])),lt=[Y("a"),ot("alpha"),Y("d"),ot("theta")];return(0,q.h)("tr",{},(0,q.h)("th",{scope:"row"},String(b+1)),lt)})),x.refresh()}function vt(){let z={lower:null,upper:null,speed:null,effort:null},C=St(w,f,m).map(b=>({...z,...b}));return(0,De.sameArm)({name:"yours",home:[],rows:C},w)?(0,Le.joints)(w).every((b,P)=>{let A=w.rows[b];return["a","alpha","d","theta"].every(S=>Math.abs(C[P][S]-A[S])<1e-6)})?"A table of this arm, and the book’s own.":yo:"The table is valid row by row, and yet not this arm: go back and look at the last frame."}let X=null;x.follow(()=>tt());function tt(){if(!k?.world||!f)return;for(let A of k.triads)A.visible=!1;k.labels.set([]),X&&X.forEach(A=>(A.traverse(S=>S.material?.dispose()),A.removeFromParent()));let{size:z}=k,C=(0,R.paint)((0,Tt.branchColour)(7));k.body.visible=!1;let _=new R.ArmShape(w,{link:C,joint:C,ghost:!0,girth:.2});_.pose(f.frames);let O=f.axes.map(({z:A,o:S})=>{let Y=(0,R.rod)(C);return(0,R.along)(Y,(0,D.plus)(S,(0,D.scaled)(-.2*z,A)),(0,D.plus)(S,(0,D.scaled)(.2*z,A)),.002*z),Y}),b=m.map(A=>{let S=new R.Triad(k.dark);return S.pose(A,.1*z),S}),P=K().map(({at:A,value:S})=>{let Y=(0,R.paint)((0,Tt.branchColour)(1)),ot=U()==="o"?null:U()==="z"?qt(f,m).axis.o:l.o;if(!ot){let W=(0,R.ball)(Y);return W.position.fromArray(A),W.scale.setScalar(.014*z),W}let lt=new R.Arrow(Y);return lt.point(ot,(0,D.scaled)(g(),S),.005*z),lt});X=[_,...O,...b,...P],X.forEach(A=>k.world.add(A)),k.labels.set(K().map(({at:A,label:S})=>({tip:A,letter:S,index:"",tone:"y"})))}return k?.figure.listen(k.figure.canvas,"click",z=>{let[C,_]=k.figure.place(z),b=K().map(P=>{let[A,S]=k.figure.pixel(P.at);return{one:P,gap:Math.hypot(A-C,S-_)}}).sort((P,A)=>P.gap-A.gap)[0];b&&b.gap<vo&&L(b.one)}),J(t.arm??o[3]),x.dispose}function Re(e){let t=e.findIndex(o=>Math.abs(Math.abs(o)-1)<1e-6);return t<0?`(${e.map(o=>(0,it.fixed)(o,2)).join(", ")})`:t===2?e[2]>0?"up":"down":`${e[t]>0?"+":"−"}${"xy"[t]}`}var Ue=v(Je(),1),$o={answer:pe,columns:ye,ellipsoid:ke,hand:xe,loads:$e,matrix:ve,row:be,swing:ze,trainer:We,triangles:je,ways:Me,winds:Ae};for(let[e,t]of Object.entries($o))(0,Ue.registerFigure)(e,t);})();
