(()=>{var Ge=Object.create;var Ot=Object.defineProperty;var Ye=Object.getOwnPropertyDescriptor;var He=Object.getOwnPropertyNames;var Xe=Object.getPrototypeOf,Qe=Object.prototype.hasOwnProperty;var N=(e,t)=>()=>{try{return t||e((t={exports:{}}).exports,t),t.exports}catch(o){throw t=0,o}};var Ze=(e,t,o,a)=>{if(t&&typeof t=="object"||typeof t=="function")for(let r of He(t))!Qe.call(e,r)&&r!==o&&Ot(e,r,{get:()=>t[r],enumerable:!(a=Ye(t,r))||a.enumerable});return e};var x=(e,t,o)=>(o=e!=null?Ge(Xe(e)):{},Ze(t||!e||!e.__esModule?Ot(o,"default",{value:e,enumerable:!0}):o,e));var rt=N((Ao,_t)=>{_t.exports=ArmExplorer.kit["dom.js"]});var X=N((Mo,Ft)=>{Ft.exports=ArmExplorer.kit["kinematics.js"]});var yt=N((jo,Nt)=>{Nt.exports=ArmExplorer.kit["renderer.js"]});var pt=N((Eo,Pt)=>{Pt.exports=ArmExplorer.kit["shapes.js"]});var nt=N((qo,It)=>{It.exports=ArmExplorer.kit["text.js"]});var Jt=N((Co,Wt)=>{Wt.exports=ArmExplorer.kit["arm.js"]});var Kt=N((Oo,Ut)=>{Ut.exports=ArmExplorer.kit["grab.js"]});var Gt=N((_o,Vt)=>{Vt.exports=ArmExplorer.kit["rail.js"]});var ut=N((Fo,Yt)=>{Yt.exports=ArmExplorer.kit["scene.js"]});var Xt=N((No,Ht)=>{Ht.exports=ArmExplorer.kit["state.js"]});var Zt=N((Po,Qt)=>{Qt.exports=ArmExplorer.kit["still.js"]});var ee=N((Io,te)=>{te.exports=ArmExplorer.kit["theme.js"]});var kt=N((Ro,oe)=>{oe.exports=ArmExplorer.kit["verdicts.js"]});var de=N((Vo,ce)=>{ce.exports=ArmExplorer.kit["jobs.js"]});var me=N((Go,ue)=>{ue.exports=ArmExplorer.kit["linear.js"]});var fe=N((Yo,he)=>{he.exports=ArmExplorer.kit["motion.js"]});var qe=N((Qo,Ee)=>{Ee.exports=ArmExplorer.kit["same.js"]});var Ue=N((rr,Je)=>{Je.exports=ArmExplorer.kit["figures.js"]});var et=x(rt(),1),K=x(X(),1),le=x(yt(),1),O=x(pt(),1);var j=x(X(),1),at=x(nt(),1),to=.5,eo=.15,ct=(e,t)=>[e[1]*t[2]-e[2]*t[1],e[2]*t[0]-e[0]*t[2],e[0]*t[1]-e[1]*t[0]];function oo(e,t){let o=(0,j.norm)(e);if(o<1e-9)return t;let a=ct(e,t),[r,n]=[Math.sin(o)/o,(1-Math.cos(o))/o**2];return(0,j.plus)(t,(0,j.plus)((0,j.scaled)(r,a),(0,j.scaled)(n,ct(e,a))))}function ro(e,t){let o=(0,j.norm)(e);if(o<1e-9)return t;let a=ct(e,t),[r,n]=[(1-Math.cos(o))/o**2,(o-Math.sin(o))/o**3];return(0,j.plus)(t,(0,j.plus)((0,j.scaled)(r,a),(0,j.scaled)(n,ct(e,a))))}function no({x:e,y:t,z:o,o:a},r,n){let[i,s]=[(0,j.scaled)(n,r.slice(0,3)),(0,j.scaled)(n,r.slice(3))],[l,p,u]=[e,t,o].map(d=>oo(s,d));return{x:l,y:p,z:u,o:(0,j.plus)(a,ro(s,i))}}function dt(e,t,{k:o,twist:a},r){let n=e.rows[(0,j.joints)(e)[o]],i=r*(n.kind==="prismatic"?eo:to),s=t.map((p,u)=>u===o?p+i:p),l=(0,j.linkFrames)(e,t).at(-1);return{by:i,row:n,q:s,tip:l,truly:(0,j.linkFrames)(e,s).at(-1),claimed:no(l,a,i)}}var Lt=["x","y","z"];function Rt(e){let t=e.reduce((o,a,r)=>Math.abs(a)>Math.abs(e[o])?r:o,0);return`${(0,at.fixed)(1e3*(0,j.norm)(e),0)} mm, mostly along ${e[t]<0?"−":"+"}${Lt[t]}`}function ao(e,t){let o=Lt.reduce((a,r)=>a+e[r].reduce((n,i,s)=>n+i*t[r][s],0),0);return 180/Math.PI*Math.acos(Math.min(1,Math.max(-1,(o-1)/2)))}function Dt({by:e,row:t,tip:o,truly:a,claimed:r},n){let[i,s]=[r,a].map(({o:f})=>(0,j.minus)(f,o.o)),l=t.kind==="prismatic"?`Joint ${n} slid by ${(0,at.fixed)(1e3*e,0)} mm`:`Joint ${n} turned by ${(0,at.fixed)(180/Math.PI*e,0)}°`,p=f=>(0,j.norm)(f)<.001,u=(0,j.norm)((0,j.minus)(i,s))<.001?"your column takes the tip where the arm takes it":`your column ${p(i)?"leaves the tip where it is":`takes the tip ${Rt(i)}`}; the arm ${p(s)?"leaves it there":`takes it ${Rt(s)}`}`,d=ao(r,a),w=d>.5?` The tool would end turned by ${(0,at.fixed)(d,0)}° from where it does.`:"";return`${l}: ${u}.${w}`}var Bt=`:host {
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
`;var mt=x(Jt(),1),M=x(rt(),1),ht=x(Kt(),1),re=x(X(),1),zt=x(Gt(),1),ne=x(ut(),1),ft=x(Xt(),1),st=x(Zt(),1),wt=x(nt(),1),ae=x(ee(),1),se=x(kt(),1);var $t=[{name:"Panda",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.0825,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.054982,.066502,.039252]},{kind:"revolute",a:-.0825,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.029330000000000002,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"Panda (homework)",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.060481999999999994,.066502,.039252]},{kind:"revolute",a:-.088,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.03482999999999999,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"UR10e",home:[0,-1.5707963267948966,0,-1.5707963267948966,0,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1807,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[7.369,.021,0,.027]},{kind:"revolute",a:-.6127,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[13.051,.38,0,.158]},{kind:"revolute",a:-.57155,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150,body:[3.989,.24,0,.068]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.17415,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[2.1,0,.007,.018]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.11985,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[1.98,0,.007,.018]},{kind:"revolute",a:0,alpha:0,d:.21655000000000002,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[.615,0,0,-.126]}]},{name:"UR10e (homework)",home:[0,0,0,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.128,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.6127,alpha:3.141592653589793,d:0,theta:-1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.5716,alpha:3.141592653589793,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1639,theta:1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.1157,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:0,d:.1922,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56}]},{name:"Stanford arm",home:[0,0,.5,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.154,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"prismatic",a:0,alpha:0,d:0,theta:0,lower:.1,upper:1,speed:null,effort:null},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:0,d:.263,theta:0,lower:null,upper:null,speed:null,effort:null}]},{name:"Elbow arm",home:[0,.7853981633974483,-1.5707963267948966],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.5,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.4,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.3,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null}]}];var At=e=>$t.find(t=>t.name===e)??$t[0],lo=0;function R(e,t,{state:o={},hold:a=!0,words:r,side:n=[]}){let i=new AbortController,{signal:s}=i,l=typeof t.arm=="object"?t.arm:At(t.arm),p=new ft.Store((0,ft.startingState)({arm:l,q:t.q??(0,mt.homeOf)(l),...o})),u=e.shadowRoot??e.attachShadow({mode:"open"}),d=(0,M.h)("div.labels",{"aria-hidden":"true"}),w=(0,M.h)("button.grip",{type:"button","aria-label":"Tip: drag it, or move it by arrow keys",hidden:!a,onkeydown:g=>y&&(0,ht.moveTipByKey)(y,p,g)}),f=(0,M.h)("div.stage",{role:"group","aria-label":`The ${l.name}`},d,w),m=(0,M.h)("p.words"),c=(0,M.h)("p.why",{hidden:!0}),v=(t.joints??[]).map(g=>I(g)),$=(0,M.h)("figure.live",{},f,(0,M.h)("div.side",{},...n,...v.map(g=>g.root),m,c));u.replaceChildren((0,M.h)("style",{},Bt),$,(0,M.h)("div.paper",{},(0,M.h)("slot")));let y=null;try{y=new ne.ArmPicture(f,d,{onPlace:([g,B])=>w.style.transform=`translate(${g}px, ${B}px)`}),a&&(0,ht.makeGrabbable)(y,p,{grip:w,goTo:g=>p.dispatch({type:"glide",q:g})})}catch{w.hidden=!0}function I(g){let B=(0,re.joints)(l).indexOf(g-1),Y=l.rows[g-1],[G,vt]=(0,mt.range)(Y),Z=(b,F=null)=>{p.dispatch({type:"move",q:p.state.q.map((q,P)=>P===B?b:q),gesture:F})},tt=(0,M.h)("input",{type:"range",min:G,max:vt,step:"any","aria-label":`Joint ${g}`,oninput:b=>Z(Number(b.target.value),`keys ${g}`)}),A=(0,M.h)("div.rail",{},tt),T=null;(0,zt.relativeRail)(A,tt,{start:()=>T=`lever ${++lo}`,put:b=>Z(b,T),signal:s});let _=(0,M.h)("output"),C=({q:b,unit:F})=>{tt.value=String(b[B]),tt.setAttribute("aria-valuetext",(0,wt.spokenJoint)(Y,b[B],F)),(0,M.write)(_,(0,wt.jointText)(Y,b[B],F))};return{root:(0,M.h)("div.lever",{},(0,M.h)("span",{},(0,M.indexed)("q",g)),A,_),show:C}}let D="light",U=[];function V(){let{state:g,derived:B}=p;for(let G of v)G.show(g);(0,M.write)(m,r(g,B));let Y=g.hold?.target&&!g.hold.moving?(0,se.stopVerdict)(g.hold):"";(0,M.write)(c,Y),c.hidden=!Y,y?y.draw(g,B,D):f.replaceChildren((0,st.stillSvg)(g.arm,B.frames,(0,st.poseText)(g.arm,g.q)));for(let G of U)G(g,B);f.setAttribute("aria-label",(0,st.poseText)(g.arm,g.q))}return(0,ae.watchTheme)(g=>{D=g,$.dataset.theme=g,V()},s),p.listen(V,s),{store:p,picture:y,card:$,signal:s,refresh:V,follow:g=>(U.push(g),V()),dispose(){i.abort(),y?.dispose(),u.replaceChildren()}}}function Q(e,[t,o],a,{put:r,text:n,signal:i}){let s=(0,M.h)("input",{type:"range",min:t,max:o,step:"any",value:a,"aria-label":e}),l=(0,M.h)("output",{},n(a)),p=d=>{s.value=String(d),s.setAttribute("aria-valuetext",n(d)),(0,M.write)(l,n(d)),r(d)};s.addEventListener("input",()=>p(Number(s.value)),{signal:i});let u=(0,M.h)("div.rail",{},s);return(0,zt.relativeRail)(u,s,{put:p,signal:i}),{root:(0,M.h)("div.lever",{},(0,M.h)("span",{},e),u,l),move:p}}var ie=24,po=[0,0,0,0,0,0],co=1600;function pe(e){let t=new AbortController,o=e.answer,[a,r,n]=[null,0,0],i=Q("how far",[-1,1],0,{put:$=>(cancelAnimationFrame(n),m($)),text:$=>`${Math.round(100*$)} %`,signal:t.signal}),s=(0,et.h)("div.row",{role:"group","aria-label":"See a column at work"}),l=(0,et.h)("div",{},s,i.root),p=R(e,{arm:o.arm,q:o.q},{hold:!1,side:[l],words:()=>a&&r?Dt(dt(o.arm,o.q,a,r),f(a)):o.words}),{store:u,picture:d}=p,w=d&&new Mt(d),f=({k:$})=>(0,K.joints)(o.arm)[$]+1;function m($){r=$,u.dispatch({type:"set",q:a?dt(o.arm,o.q,a,r).q:o.q}),p.refresh()}function c($){cancelAnimationFrame(n),a=$;let y=performance.now(),I=D=>{let U=(0,et.calm)()?1:Math.max(0,Math.min(1,(D-y)/co));i.move((1-Math.cos(Math.PI*U))/2),U<1&&(n=requestAnimationFrame(I))};I(y)}function v(){cancelAnimationFrame(n);let{arm:$,q:y,wrench:I=po,claims:D}=o;a=D[0]??null,$!==u.state.arm&&u.dispatch({type:"select",arm:$,q:y}),u.dispatch({type:"set",wrench:I,view:I.some(Boolean)?"torque":"pose"}),l.hidden=!a,s.replaceChildren(...D.map(U=>{let V=$.rows[(0,K.joints)($)[U.k]].kind==="prismatic"?"Slide":"Turn";return(0,et.h)("button",{type:"button",onclick:()=>c(U)},`${V} joint ${f(U)}`)})),i.move(0)}return p.follow(()=>w?.draw(o,a,r)),e.addEventListener("answer",()=>(o=e.answer,v()),{signal:t.signal}),v(),()=>(cancelAnimationFrame(n),t.abort(),p.dispose())}var Mt=class{constructor(t){this.picture=t,this.drawn=[],this.made=[]}draw(t,o,a){let{picture:r}=this;if(!r.world)return;r.body.tint(i=>t.axes.includes(i)||t.links.includes(i)?r.tints.bad:null);let n=[t,o,a,r.world];if(!n.every((i,s)=>i===this.drawn[s])){this.drawn=n,this.made.forEach(le.freed),this.made=this.pieces(t,o,a);for(let i of this.made)r.world.add(i);r.figure.request()}}pieces(t,o,a){let{picture:r}=this,[n,i]=[r.look.bad,r.look.ghost],s=r.frames,l=t.axes.map(p=>this.line(uo(s[p],.3*r.size),.004,n));l.push(...t.links.map(p=>this.line(mo(s,p),.02,n)));for(let{arm:p,q:u}of t.ghosts){let d=(0,O.ghostMaterial)(n,.4),w=new O.ArmShape(p,{link:d,joint:d,ghost:!0});w.pose((0,K.linkFrames)(p,u)),l.push(w)}return t.path&&l.push((0,O.tube)(t.path,.003*r.size,n)),o&&a?[...l,...this.claim(t,o,a,n,i)]:l}claim({arm:t,q:o},a,r,n,i){let{picture:s}=this,l=Array.from({length:ie+1},(w,f)=>dt(t,o,a,r*f/ie)),p=new O.Triads(s.dark,1);p.pose([l.at(-1).claimed],.1*s.size);let u=(0,O.ball)((0,O.paint)(n));u.scale.setScalar(.016*s.size),u.position.fromArray(l.at(-1).claimed.o);let d=.005*s.size;return[p,u,(0,O.tube)(l.map(({claimed:w})=>w.o),d,n),(0,O.tube)(l.map(({truly:w})=>w.o),d,i)]}line({start:t,end:o},a,r){let n=(0,O.rod)((0,O.paint)(r));return(0,O.along)(n,t,o,a*this.picture.size),n}},uo=({o:e,z:t},o)=>({start:(0,K.minus)(e,(0,K.scaled)(o,t)),end:(0,K.plus)(e,(0,K.scaled)(o,t))}),mo=(e,t)=>({start:e[t].o,end:e[t+1].o});var k=x(rt(),1),jt=x(de(),1),z=x(X(),1),we=x(me(),1),ge=x(fe(),1),Et=x(ut(),1),bt=x(pt(),1),S=x(nt(),1),xt=x(kt(),1);var ho="only the entries with its angle move; the last column goes round on a circle of radius a.",fo=e=>e.map(t=>(0,S.fixed)(1e3*t,0)).join(", "),gt=e=>`${(0,S.fixed)(e*180/Math.PI,0)}°`;function be(e,t){let o=(a,{frames:r})=>`${t.words??"Drag a link, or the tip."} The tip is at (${fo(r.at(-1).o)}) mm.`;return R(e,t,{state:{frames:t.frames??"ends"},words:o}).dispose}function xe(e,t){let o=["turn by θ about z","slide by d along z","slide by a along x","turn by α about x"],a=new AbortController,r=4,n=R(e,t,{hold:!1,state:{frames:"all"},words:({arm:u})=>{let{theta:d,d:w,a:f,alpha:m}=u.rows[0],c=[gt(d),`${(0,S.fixed)(1e3*w,0)} mm`,`${(0,S.fixed)(1e3*f,0)} mm`,gt(m)],v=o.slice(0,Math.ceil(r)).map(($,y)=>`${$} (${c[y]})`);return v.length?`${v.join(", then ")}.`:"The frame before the row."}}),s=n.store.state.arm.rows[(t.row??1)-1],p=Q("motions",[0,4],4,{put:u=>{r=u;let d=v=>Math.min(1,Math.max(0,u-v)),w=s.theta+(s.kind==="revolute"?t.angle??.7:0),f=s.d+(s.kind==="prismatic"?t.slide??.3:0),m={kind:"fixed",theta:d(0)*w,d:d(1)*f,a:d(2)*s.a,alpha:d(3)*s.alpha},c={name:`Row ${t.row??1}`,home:[],rows:[m]};n.store.dispatch({type:"select",arm:c,q:[]})},text:u=>`${(0,S.fixed)(u,1)} of 4`,signal:a.signal});return n.card.querySelector(".side").prepend(p.root),p.move(4),n.picture?.fit(),()=>(a.abort(),n.dispose())}function ve(e,t){let o=t.row??1,a=Array.from({length:4},()=>Array.from({length:4},()=>(0,k.h)("td"))),r=(0,k.h)("table",{"aria-label":`A ${o}`},a.map(s=>(0,k.h)("tr",{},s))),n=(0,k.h)("span",{},(0,k.indexed)("A",o)," ="),i=R(e,{...t,joints:[o]},{state:{frames:"all"},side:[(0,k.h)("div.row",{},n,(0,k.h)("div.scroll",{},r))],words:()=>t.words??`Turn joint ${o}: ${ho}`});return i.follow(s=>{let l=(0,z.linkFrames)({rows:[s.arm.rows[o-1]]},[s.q[(0,z.joints)(s.arm).indexOf(o-1)]]);(0,z.matrix)(l[1]).forEach((p,u)=>p.forEach((d,w)=>(0,k.write)(a[u][w],u===3?String(d):(0,S.sparse)(d,3))))}),i.dispose}function ye(e,t){let o=0,a=(0,k.h)("tr"),r=(0,k.h)("tbody"),n=(0,k.h)("table",{"aria-label":"Jacobian of the tip"},(0,k.h)("thead",{},a),r),i=R(e,t,{side:[(0,k.h)("div.scroll",{},n)],words:({arm:f})=>{let m=(0,z.joints)(f)[o],c=f.rows[m].kind==="revolute"?"turns about its axis":"slides";return`Column ${o+1}: the tip moves along the arrow when joint ${m+1} ${c} alone.`}}),{store:s,picture:l}=i,p=l&&new bt.Arrow(l.force.shaft.material),u=f=>()=>{o=f,s.dispatch({type:"show",lit:(0,z.joints)(s.state.arm)[f]}),i.refresh()},d=(0,z.joints)(s.state.arm).map((f,m)=>(0,k.h)("button",{type:"button","aria-pressed":"false",onpointerenter:u(m),onfocus:u(m),onclick:u(m)},(0,k.indexed)("J",f+1)));a.replaceChildren((0,k.h)("th"),...d.map(f=>(0,k.h)("th",{},f)));let w=["vx","vy","vz","ωx","ωy","ωz"].map(f=>[f,d.map(()=>(0,k.h)("td"))]);return r.replaceChildren(...w.map(([f,m])=>(0,k.h)("tr",{},(0,k.h)("th",{},(0,k.indexed)(f[0],f[1])),m))),i.follow((f,m)=>{if(w.forEach(([,v],$)=>v.forEach((y,I)=>{(0,k.write)(y,(0,S.sparse)(m.columns[I][$],2)),y.classList.toggle("on",I===o)})),d.forEach((v,$)=>v.setAttribute("aria-pressed",String($===o))),!p||!l.world)return;p.parent!==l.world&&l.world.add(p);let c=(0,z.scaled)(.3,m.columns[o].slice(0,3));p.point(m.frames.at(-1).o,c,.008*l.size)}),u(t.column?t.column-1:0)(),i.dispose}function ke(e,t){return R(e,t,{state:{view:"jacobian"},words:(a,r)=>`Half axes ${r.linear.values.map(i=>(0,S.fixed)(i,2)).join(", ")}. ${(0,xt.rankVerdict)(r).text}`}).dispose}function $e(e,t){let o=(0,k.h)("div.bars"),a=R(e,t,{state:{view:t.push?"torque":"pose",wrench:t.wrench??[0,0,0,0,0,0]},side:[o],words:(n,{torque:i})=>{let s=i.reduce((p,u,d)=>Math.abs(u)>Math.abs(i[p])?d:p,0),l=`joint ${(0,z.joints)(n.arm)[s]+1}: ${(0,S.fixed)(i[s],1)} N m`;return`${t.words??"Move the arm."} The most is asked of ${l}.`}}),r=(0,z.joints)(a.store.state.arm).map(n=>{let[i,s]=[(0,k.h)("span.fill"),(0,k.h)("span")];return{fill:i,value:s,root:(0,k.h)("div.bar",{},(0,k.h)("span",{},(0,k.indexed)("τ",n+1)),(0,k.h)("span.track",{},i),s)}});return o.replaceChildren(...r.map(n=>n.root)),a.follow((n,{torque:i})=>{let s=Math.max(...(0,z.joints)(n.arm).map(l=>n.arm.rows[l].effort??50));r.forEach(({fill:l,value:p},u)=>{let d=Math.max(-1,Math.min(1,i[u]/s));Object.assign(l.style,{left:`${50+50*Math.min(0,d)}%`,width:`${50*Math.abs(d)}%`}),(0,k.write)(p,`${(0,S.fixed)(i[u],1)} N m`)})}),a.dispose}function ze(e,t){let o=new AbortController,a=R(e,t,{words:d=>`The tip stays; ${(0,z.joints)(d.arm).map((f,m)=>`q${f+1} ${(0,S.jointText)(d.arm.rows[f],d.q[m],"deg")}`).join(", ")}.`}),{store:r}=a,n=r.derived.frames.at(-1);r.dispatch({type:"show",hold:{pinned:n,turns:!0,free:1}});let i=wo(r.state.arm,r.state.q,n),s=i.findIndex(d=>d===r.state.q),l=d=>{let w=i[Math.max(0,Math.min(i.length-1,Math.round(d)))];r.dispatch({type:"move",q:w,hold:r.state.hold,gesture:"swing"})},p=d=>gt(i[Math.round(d)]?.[2]-i[s][2]),u=Q("elbow",[0,i.length-1],s,{put:l,text:p,signal:o.signal});return a.card.querySelector(".side").prepend(u.root),()=>(o.abort(),a.dispose())}function wo(e,t,o){let a=(0,z.joints)(e).map(n=>[e.rows[n].lower??-1/0,e.rows[n].upper??1/0]),r=n=>{let i=[],[s,l]=[t,null];for(let p=0;p<80;p++){let u=go(e,s),[d]=(0,we.rightNull)(u);if(!d)break;let w=l?d.reduce((c,v,$)=>c+v*l[$],0):n*d[2],f=d.map(c=>w<0?-c:c),m=(0,ge.reach)(e,s.map((c,v)=>c+.03*f[v]),o).q;if(m.some((c,v)=>c<a[v][0]||c>a[v][1]))break;i.push(m),[s,l]=[m,f]}return i};return[...r(-1).reverse(),t,...r(1)]}function go(e,t){let o=(0,z.linkFrames)(e,t),a=o.at(-1).o;return(0,z.joints)(e).map(r=>{let{z:n,o:i}=o[r],s=(0,z.minus)(a,i);return[...[n[1]*s[2]-n[2]*s[1],n[2]*s[0]-n[0]*s[2],n[0]*s[1]-n[1]*s[0]],...n]})}function Ae(e,t){let o=new AbortController,[a,r,n,i]=[null,0,t.radius??.1,0],s=R(e,t,{hold:!1,state:{view:"trace",lit:t.lit?t.lit-1:null},words:({arm:c})=>{if(!a)return"Computing …";let v=`Radius ${(0,S.fixed)(100*n,1)} cm`;if(a.largest>1e-4)return`${v}: no run gets round; the arm would have to pass a singular pose.`;let $=(0,z.joints)(c).flatMap((y,I)=>Math.abs(a.wound[I])>.9?[`joint ${y+1}`]:[]);return`${v}: ${$.length?`${(0,S.listed)($)} wind once round`:"the joints swing and come back"}.`}}),{store:l}=s,p=l.state.q,u=()=>{let{path:c}=a,v=Math.round(r*(c.length-1));l.dispatch({type:"set",trace:c,q:c[v]})},d=async()=>{let c=++i,{arm:v}=l.state,$=await(0,jt.ask)("run",{arm:v,q:p,run:{method:"exact",steps:180,radius:n}});c!==i||o.signal.aborted||(a=$,u(),s.refresh())},w={signal:o.signal},f=Q("round",[0,1],0,{...w,put:c=>(r=c,a&&u()),text:c=>`${(0,S.fixed)(100*c,0)} %`}),m=Q("radius",[.01,.1],n,{...w,put:c=>(n=c,d()),text:c=>`${(0,S.fixed)(100*c,1)} cm`});return s.card.querySelector(".side").prepend(...t.fixed?[f.root]:[m.root,f.root]),d(),()=>(o.abort(),s.dispose())}function Me(e,t){let o=(0,k.h)("div.row",{role:"radiogroup","aria-label":"Ways"}),a=R(e,t,{state:{view:"branches"},side:[o],words:({arm:i,ways:s})=>s?(0,xt.waysVerdict)(i,s):"Computing …"}),{store:r}=a,n=!1;return(0,jt.ask)("ways",{arm:r.state.arm,q:r.state.q}).then(i=>{n||(r.dispatch({type:"ways",arm:r.state.arm,ways:i}),o.replaceChildren(...i.list.map(({q:s},l)=>(0,k.h)("button",{type:"button",role:"radio","aria-label":`Way ${l+1}`,style:`border-left: 6px solid ${(0,Et.branchColour)(l)}`,onclick:()=>r.dispatch({type:"glide",q:s})},String(l+1)))),a.refresh())}),a.follow(({q:i,ways:s})=>{[...o.children].forEach((l,p)=>{let u=s?.list[p]?.q.every((d,w)=>Math.abs(d-i[w])<.001);l.setAttribute("aria-checked",String(!!u))})}),()=>(n=!0,a.dispose())}function je(e,t){let o=R(e,{arm:"Elbow arm",...t},{words:({arm:n,q:i},{frames:s})=>{let[l,p]=[s[1].o,s.at(-1).o],u=(0,z.norm)((0,z.minus)(p,l)),[d,w]=[n.rows[1].a,n.rows[2].a],f=(u*u-d*d-w*w)/(2*d*w);return`${`Shoulder to tip ${(0,S.fixed)(1e3*u,0)} mm`}, so D = ${(0,S.fixed)(f,3)} and θ₃ = ${gt(i[2])}; its cosine is D.`}}),{picture:a}=o,r=[];return o.follow((n,{frames:i})=>{if(!a?.world)return;for(let m of r)m.traverse(c=>{c.material?.dispose(),c.geometry?.dispose()}),m.removeFromParent();let[s,l,p]=i.slice(1).map(m=>m.o),u=[p[0],p[1],s[2]],d=(m,c)=>[m,(0,z.plus)((0,z.scaled)(.5,m),(0,z.scaled)(.5,c)),c],w=.003*a.size;r=[[s,p,0],[s,u,2],[u,p,2],[s,l,1],[l,p,1]].filter(([m,c])=>(0,z.norm)((0,z.minus)(m,c))>.001).map(([m,c,v])=>(0,bt.tube)(d(m,c),w,(0,Et.branchColour)(v))),r.forEach(m=>a.world.add(m))}),o.dispose}var E=x(rt(),1),Le=x(X(),1),De=x(qe(),1),Ct=x(ut(),1),Be=x(yt(),1),L=x(pt(),1),it=x(nt(),1),W=x(X(),1);var h=x(X(),1),qt=1e-6,Se=e=>(0,h.scaled)(1/(0,h.norm)(e),e),Te=(e,t,o)=>Math.atan2((0,h.dot)(e,(0,h.cross)(t,o)),(0,h.dot)(t,o)),bo=(e,t)=>e.every(o=>(0,h.norm)((0,h.minus)(t,o))>1e-4);function Oe(e){let t=(0,h.joints)(e).map((r,n)=>e.rows[r].kind==="prismatic"?Math.max(.3,e.home[n]||0):0),o=(0,h.linkFrames)(e,t),a=(0,h.joints)(e).map(r=>({z:o[r].z,o:o[r].o,row:r}));return{q:t,frames:o,axes:a,base:o[0],end:o.at(-1)}}function Ce(e,t,o,a){let r=(0,h.minus)(o,e),n=(0,h.cross)(t,a),i=(0,h.dot)(n,n);return i<qt?[e,(0,h.plus)(o,(0,h.scaled)(-(0,h.dot)(a,r),a))]:[(0,h.plus)(e,(0,h.scaled)((0,h.dot)((0,h.cross)(r,a),n)/i,t)),(0,h.plus)(o,(0,h.scaled)((0,h.dot)((0,h.cross)(r,t),n)/i,a))]}function St(e,t){let o=t.length,a=t[o-1],r=o===e.axes.length,n=r?{z:a.z,o:e.end.o}:e.axes[o],[,i]=Ce(a.o,a.z,n.o,n.z),s=e.axes[o+1],l=[],p=r?[e.end.o]:[i,n.o,...s?[Ce(n.o,n.z,s.o,s.z)[0]]:[]];for(let u of p)bo(l,u)&&l.push(u);if(!r)for(let u of[...l])l.length<3&&l.push((0,h.plus)(u,(0,h.scaled)(.12,n.z)));return{zs:[n.z,(0,h.scaled)(-1,n.z)],points:l.slice(0,4),axis:n}}function _e(e,t,o){let a=(0,h.cross)(e.z,t);(0,h.norm)(a)<qt&&(a=(0,h.minus)((0,h.minus)(o,e.o),(0,h.scaled)((0,h.dot)((0,h.minus)(o,e.o),e.z),e.z))),(0,h.norm)(a)<qt&&(a=e.x),a=Se(a);let r=Se((0,h.cross)(t,a));return[a,(0,h.scaled)(-1,a),r,(0,h.scaled)(-1,r)]}function Fe(e,{x:t,z:o,o:a},r){if(Math.abs((0,h.dot)(t,o))>1e-4)return`x_${r} is not at a right angle to z_${r}.`;if(Math.abs((0,h.dot)(t,e.z))>1e-4)return`x_${r} is not at a right angle to z_${r-1}: no α about x_${r} can then turn z_${r-1} into z_${r}.`;let n=(0,h.minus)(a,e.o),i=(0,h.minus)((0,h.minus)(n,(0,h.scaled)((0,h.dot)(n,e.z),e.z)),(0,h.scaled)((0,h.dot)(n,t),t));return(0,h.norm)(i)>1e-4?`The line of x_${r} does not meet the axis z_${r-1}: no slide a along x_${r} can then bring o_${r} there.`:null}function xo(e,t,o,a){let r=(0,h.minus)(t.o,e.o),n=(0,h.dot)(r,e.z);return{kind:o,a:(0,h.dot)(r,t.x),alpha:Te(t.x,e.z,t.z),d:o==="prismatic"?n-a:n,theta:Te(e.z,e.x,t.x)}}var Ne=(e,t,o)=>({x:t,y:(0,h.cross)(e,t),z:e,o});function Tt(e,t,o){return o.slice(1).map((a,r)=>{let{row:n}=t.axes[r],i=Math.sign((0,h.dot)(o[r].z,t.axes[r].z));return xo(o[r],a,e.rows[n].kind,i*t.q[r])})}function Pe(e=Math.random){let t=r=>r[Math.floor(e()*r.length)],o=t([3,4,5]),a=Array.from({length:o},(r,n)=>{let i=n===o-1,s=t(i?[.15,.2]:[0,.2,.3]),l=n===0?.3:t(s?[0,0,.15]:[.2,.25]),p=n>0&&!i&&e()<.2?"prismatic":"revolute",u=t([0,Math.PI/2,-Math.PI/2]);return{kind:p,a:s,alpha:i?0:u,d:l,theta:0,...{lower:null,upper:null,speed:null,effort:null}}});return{name:"An arm of its own",home:a.map(r=>r.kind==="prismatic"?.3:0),rows:a}}var vo=22,Ie="An arm of its own",yo="A table of this arm; the book chose other directions or zeros, which are free.",ko={z:e=>`Frame ${e}: which way shall z point along its axis?`,o:e=>`Frame ${e}: where on that axis is its origin?`,x:e=>`Frame ${e}: and which way does x point?`};function We(e,t){let o=["UR10e (homework)","Panda (homework)","Stanford arm","Elbow arm",Ie],a=(0,E.h)("select",{"aria-label":"Arm to place frames on",onchange:A=>I(A.target.value)},o.map(A=>(0,E.h)("option",{value:A,selected:A===t.arm},A))),r=(0,E.h)("p.words",{"aria-live":"polite"}),n=(0,E.h)("div.row",{role:"group","aria-label":"Choices"}),i=(0,E.h)("button",{type:"button",onclick:()=>Y()},"Back"),s=(0,E.h)("p.why",{hidden:!0,"aria-live":"polite"}),l=(0,E.h)("tbody"),p=["i","a (m)","α (°)","d (m)","θ (°)"].map(A=>(0,E.h)("th",{scope:"col"},A)),u=(0,E.h)("table",{"aria-label":"The table so far"},(0,E.h)("thead",{},(0,E.h)("tr",{},p)),l),d=[(0,E.h)("div.row",{},a,i),r,n,s,(0,E.h)("div.scroll",{},u)],w,f,m,c,v=R(e,{arm:t.arm??o[3]},{hold:!1,side:d,words:()=>""}),{store:$,picture:y}=v;function I(A){w=A===Ie?Pe():At(A),f=Oe(w),m=[f.base],c={},$.dispatch({type:"select",arm:w,q:f.q});let T=f.axes.flatMap(({z:_,o:C})=>[-1,1].map(b=>(0,W.plus)(C,(0,W.scaled)(b*1.3*g(),_))));y?.figure.fit([...T,f.end.o,(0,W.plus)(f.end.o,[0,0,g()]),[0,0,0]]),G()}let D=()=>c.z?c.o?"x":"o":"z",U=()=>m.length>f.axes.length;function V(){if(U())return[];let A=m.at(-1),{zs:T,points:_,axis:C}=St(f,m);return D()==="z"?T.map(b=>({value:b,at:(0,W.plus)(C.o,(0,W.scaled)(g(),b)),label:Re(b)})):D()==="o"?_.map((b,F)=>({value:b,at:b,label:"ABCD"[F]})):_e(A,c.z,c.o).map(b=>({value:b,at:(0,W.plus)(c.o,(0,W.scaled)(g(),b)),label:Re(b)}))}let g=()=>.16*(y?.size??1);function B({value:A}){if(c={...c,[D()]:A},s.hidden=!0,c.x){let T=Ne(c.z,c.x,c.o),_=Fe(m.at(-1),T,m.length);if(_){let{z:C,o:b}=c;c=/does not meet/.test(_)?{z:C}:{z:C,o:b},(0,E.write)(s,_.replaceAll(/_(\d+)/g,(F,q)=>[...q].map(P=>"₀₁₂₃₄₅₆₇₈₉"[P]).join(""))),s.hidden=!1}else m=[...m,T],c={}}G()}function Y(){c.o?c={z:c.z}:c.z?c={}:m.length>1&&(m=m.slice(0,-1)),s.hidden=!0,G()}function G(){let T=V().map(C=>(0,E.h)("button",{type:"button",onclick:()=>B(C)},C.label));n.replaceChildren(...T),(0,E.write)(r,U()?vt():ko[D()](m.length)),i.disabled=m.length===1&&!c.z;let _=Tt(w,f,m);l.replaceChildren(..._.map((C,b)=>{let F=C.kind==="revolute"?"theta":"d",q=(J,Ve)=>(0,E.h)("td",{},Ve,...J===F?[" + ",...(0,E.indexed)("q",b+1)]:[]),P=J=>(0,it.entryText)(J,!0,"deg"),H=J=>q(J,(0,it.entryText)(C[J],!1,"deg")),ot=J=>q(J,P(C[J])),lt=[H("a"),ot("alpha"),H("d"),ot("theta")];return(0,E.h)("tr",{},(0,E.h)("th",{scope:"row"},String(b+1)),lt)})),v.refresh()}function vt(){let A={lower:null,upper:null,speed:null,effort:null},T=Tt(w,f,m).map(b=>({...A,...b}));return(0,De.sameArm)({name:"yours",home:[],rows:T},w)?(0,Le.joints)(w).every((b,F)=>{let q=w.rows[b];return["a","alpha","d","theta"].every(P=>Math.abs(T[F][P]-q[P])<1e-6)})?"A table of this arm, and the book’s own.":yo:"The table is valid row by row, and yet not this arm: go back and look at the last frame."}let Z=[];v.follow(()=>tt());function tt(){if(!y?.world||!f)return;y.triads.visible=!1,y.labels.set([]),Z.forEach(Be.freed);let{size:A}=y,T=(0,L.paint)((0,Ct.branchColour)(7));y.body.visible=!1;let _=new L.ArmShape(w,{link:T,joint:T,ghost:!0,girth:.2});_.pose(f.frames);let C=f.axes.map(({z:q,o:P})=>{let H=(0,L.rod)(T);return(0,L.along)(H,(0,W.plus)(P,(0,W.scaled)(-.2*A,q)),(0,W.plus)(P,(0,W.scaled)(.2*A,q)),.002*A),H}),b=new L.Triads(y.dark,m.length);b.pose(m,.1*A);let F=V().map(({at:q,value:P})=>{let H=(0,L.paint)((0,Ct.branchColour)(1)),ot=D()==="o"?null:D()==="z"?St(f,m).axis.o:c.o;if(!ot){let J=(0,L.ball)(H);return J.position.fromArray(q),J.scale.setScalar(.014*A),J}let lt=new L.Arrow(H);return lt.point(ot,(0,W.scaled)(g(),P),.005*A),lt});Z=[_,...C,b,...F],Z.forEach(q=>y.world.add(q)),y.labels.set(V().map(({at:q,label:P})=>({tip:q,letter:P,index:"",tone:"y"})))}return y?.figure.listen(y.figure.canvas,"click",A=>{let[T,_]=y.figure.place(A),b=V().map(F=>{let[q,P]=y.figure.pixel(F.at);return{one:F,gap:Math.hypot(q-T,P-_)}}).sort((F,q)=>F.gap-q.gap)[0];b&&b.gap<vo&&B(b.one)}),I(t.arm??o[3]),v.dispose}function Re(e){let t=e.findIndex(o=>Math.abs(Math.abs(o)-1)<1e-6);return t<0?`(${e.map(o=>(0,it.fixed)(o,2)).join(", ")})`:t===2?e[2]>0?"up":"down":`${e[t]>0?"+":"−"}${"xy"[t]}`}var Ke=x(Ue(),1),$o={answer:pe,columns:ye,ellipsoid:ke,hand:be,loads:$e,matrix:ve,row:xe,swing:ze,trainer:We,triangles:je,ways:Me,winds:Ae};for(let[e,t]of Object.entries($o))(0,Ke.registerFigure)(e,t);})();
