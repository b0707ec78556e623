(()=>{var _t=Object.create;var ze=Object.defineProperty;var Nt=Object.getOwnPropertyDescriptor;var Rt=Object.getOwnPropertyNames;var Ft=Object.getPrototypeOf,It=Object.prototype.hasOwnProperty;var _=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(o){throw e=0,o}};var Pt=(t,e,o,s)=>{if(e&&typeof e=="object"||typeof e=="function")for(let r of Rt(e))!It.call(t,r)&&r!==o&&ze(t,r,{get:()=>e[r],enumerable:!(s=Nt(e,r))||s.enumerable});return t};var k=(t,e,o)=>(o=t!=null?_t(Ft(t)):{},Pt(e||!t||!t.__esModule?ze(o,"default",{value:t,enumerable:!0}):o,t));var oe=_((eo,Ae)=>{Ae.exports=ArmExplorer.kit["dom.js"]});var Ee=_((to,je)=>{je.exports=ArmExplorer.kit["jobs.js"]});var H=_((oo,Me)=>{Me.exports=ArmExplorer.kit["kinematics.js"]});var Se=_((ro,qe)=>{qe.exports=ArmExplorer.kit["linear.js"]});var Te=_((ao,Ce)=>{Ce.exports=ArmExplorer.kit["motion.js"]});var re=_((no,Oe)=>{Oe.exports=ArmExplorer.kit["scene.js"]});var he=_((so,_e)=>{_e.exports=ArmExplorer.kit["shapes.js"]});var ae=_((io,Ne)=>{Ne.exports=ArmExplorer.kit["text.js"]});var me=_((lo,Re)=>{Re.exports=ArmExplorer.kit["verdicts.js"]});var Pe=_((co,Ie)=>{Ie.exports=ArmExplorer.kit["arm.js"]});var Le=_((uo,De)=>{De.exports=ArmExplorer.kit["grab.js"]});var We=_((ho,Be)=>{Be.exports=ArmExplorer.kit["rail.js"]});var Ke=_((mo,Je)=>{Je.exports=ArmExplorer.kit["state.js"]});var Ve=_((fo,Ue)=>{Ue.exports=ArmExplorer.kit["still.js"]});var He=_((wo,Ge)=>{Ge.exports=ArmExplorer.kit["theme.js"]});var ht=_(($o,ut)=>{ut.exports=ArmExplorer.kit["same.js"]});var ft=_((zo,mt)=>{mt.exports=ArmExplorer.kit["renderer.js"]});var Ct=_((qo,St)=>{St.exports=ArmExplorer.kit["figures.js"]});var b=k(oe(),1),xe=k(Ee(),1),$=k(H(),1),et=k(Se(),1),tt=k(Te(),1),be=k(re(),1),de=k(he(),1),M=k(ae(),1),ce=k(me(),1);var Fe=`:host {
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
`;var ne=k(Pe(),1),A=k(oe(),1),se=k(Le(),1),Ye=k(H(),1),we=k(We(),1),Qe=k(re(),1),ie=k(Ke(),1),X=k(Ve(),1),le=k(ae(),1),Xe=k(He(),1),Ze=k(me(),1);var fe=[{name:"Panda",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.0825,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.054982,.066502,.039252]},{kind:"revolute",a:-.0825,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.029330000000000002,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"Panda (homework)",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.060481999999999994,.066502,.039252]},{kind:"revolute",a:-.088,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.03482999999999999,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"UR10e",home:[0,-1.5707963267948966,0,-1.5707963267948966,0,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1807,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[7.369,.021,0,.027]},{kind:"revolute",a:-.6127,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[13.051,.38,0,.158]},{kind:"revolute",a:-.57155,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150,body:[3.989,.24,0,.068]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.17415,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[2.1,0,.007,.018]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.11985,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[1.98,0,.007,.018]},{kind:"revolute",a:0,alpha:0,d:.21655000000000002,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[.615,0,0,-.126]}]},{name:"UR10e (homework)",home:[0,0,0,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.128,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.6127,alpha:3.141592653589793,d:0,theta:-1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.5716,alpha:3.141592653589793,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1639,theta:1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.1157,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:0,d:.1922,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56}]},{name:"Stanford arm",home:[0,0,.5,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.154,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"prismatic",a:0,alpha:0,d:0,theta:0,lower:.1,upper:1,speed:null,effort:null},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:0,d:.263,theta:0,lower:null,upper:null,speed:null,effort:null}]},{name:"Elbow arm",home:[0,.7853981633974483,-1.5707963267948966],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.5,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.4,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.3,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null}]}];var ge=t=>fe.find(e=>e.name===t)??fe[0],Bt=0;function D(t,e,{state:o={},hold:s=!0,words:r,side:a=[]}){let l=new AbortController,{signal:n}=l,c=ge(e.arm),m=new ie.Store((0,ie.startingState)({arm:c,q:e.q??(0,ne.homeOf)(c),...o})),f=t.shadowRoot??t.attachShadow({mode:"open"}),u=(0,A.h)("div.labels",{"aria-hidden":"true"}),w=(0,A.h)("button.grip",{type:"button","aria-label":"Tip: drag it, or move it by arrow keys",hidden:!s,onkeydown:g=>y&&(0,se.moveTipByKey)(y,m,g)}),h=(0,A.h)("div.stage",{role:"group","aria-label":`The ${c.name}`},u,w),p=(0,A.h)("p.words"),i=(0,A.h)("p.why",{hidden:!0}),v=(e.joints??[]).map(g=>L(g)),C=(0,A.h)("figure.live",{},h,(0,A.h)("div.side",{},...a,...v.map(g=>g.root),p,i));f.replaceChildren((0,A.h)("style",{},Fe),C,(0,A.h)("div.paper",{},(0,A.h)("slot")));let y=null;try{y=new Qe.ArmPicture(h,u,{onPlace:([g,F])=>w.style.transform=`translate(${g}px, ${F}px)`}),s&&(0,se.makeGrabbable)(y,m,{grip:w,goTo:g=>m.dispatch({type:"glide",q:g})})}catch{w.hidden=!0}function L(g){let F=(0,Ye.joints)(c).indexOf(g-1),K=c.rows[g-1],[J,ue]=(0,ne.range)(K),V=(x,O=null)=>{m.dispatch({type:"move",q:m.state.q.map((E,N)=>N===F?x:E),gesture:O})},G=(0,A.h)("input",{type:"range",min:J,max:ue,step:"any","aria-label":`Joint ${g}`,oninput:x=>V(Number(x.target.value),`keys ${g}`)}),z=(0,A.h)("div.rail",{},G),q=null;(0,we.relativeRail)(z,G,{start:()=>q=`lever ${++Bt}`,put:x=>V(x,q),signal:n});let T=(0,A.h)("output"),S=({q:x,unit:O})=>{G.value=String(x[F]),G.setAttribute("aria-valuetext",(0,le.spokenJoint)(K,x[F],O)),(0,A.write)(T,(0,le.jointText)(K,x[F],O))};return{root:(0,A.h)("div.lever",{},(0,A.h)("span",{},(0,A.indexed)("q",g)),z,T),show:S}}let B="light",Y=[];function W(){let{state:g,derived:F}=m;for(let J of v)J.show(g);(0,A.write)(p,r(g,F));let K=g.hold?.target&&!g.hold.moving?(0,Ze.stopVerdict)(g.hold):"";(0,A.write)(i,K),i.hidden=!K,y?y.draw(g,F,B):h.replaceChildren((0,X.stillSvg)(g.arm,F.frames,(0,X.poseText)(g.arm,g.q)));for(let J of Y)J(g,F);h.setAttribute("aria-label",(0,X.poseText)(g.arm,g.q))}return(0,Xe.watchTheme)(g=>{B=g,C.dataset.theme=g,W()},n),m.listen(W,n),{store:m,picture:y,card:C,signal:n,refresh:W,follow:g=>(Y.push(g),W()),dispose(){l.abort(),y?.dispose(),f.replaceChildren()}}}function Z(t,[e,o],s,{put:r,text:a,signal:l}){let n=(0,A.h)("input",{type:"range",min:e,max:o,step:"any",value:s,"aria-label":t}),c=(0,A.h)("output",{},a(s)),m=u=>{n.value=String(u),n.setAttribute("aria-valuetext",a(u)),(0,A.write)(c,a(u)),r(u)};n.addEventListener("input",()=>m(Number(n.value)),{signal:l});let f=(0,A.h)("div.rail",{},n);return(0,we.relativeRail)(f,n,{put:m,signal:l}),{root:(0,A.h)("div.lever",{},(0,A.h)("span",{},t),f,c),move:m}}var Wt="only the entries with its angle move; the last column goes round on a circle of radius a.",Jt=t=>t.map(e=>(0,M.fixed)(1e3*e,0)).join(", "),pe=t=>`${(0,M.fixed)(t*180/Math.PI,0)}°`;function ot(t,e){let o=(s,{frames:r})=>`${e.words??"Drag a link, or the tip."} The tip is at (${Jt(r.at(-1).o)}) mm.`;return D(t,e,{state:{frames:e.frames??"ends"},words:o}).dispose}function rt(t,e){let o=["turn by θ about z","slide by d along z","slide by a along x","turn by α about x"],s=new AbortController,r=4,a=D(t,e,{hold:!1,state:{frames:"all"},words:({arm:f})=>{let{theta:u,d:w,a:h,alpha:p}=f.rows[0],i=[pe(u),`${(0,M.fixed)(1e3*w,0)} mm`,`${(0,M.fixed)(1e3*h,0)} mm`,pe(p)],v=o.slice(0,Math.ceil(r)).map((C,y)=>`${C} (${i[y]})`);return v.length?`${v.join(", then ")}.`:"The frame before the row."}}),n=a.store.state.arm.rows[(e.row??1)-1],m=Z("motions",[0,4],4,{put:f=>{r=f;let u=v=>Math.min(1,Math.max(0,f-v)),w=n.theta+(n.kind==="revolute"?e.angle??.7:0),h=n.d+(n.kind==="prismatic"?e.slide??.3:0),p={kind:"fixed",theta:u(0)*w,d:u(1)*h,a:u(2)*n.a,alpha:u(3)*n.alpha},i={name:`Row ${e.row??1}`,home:[],rows:[p]};a.store.dispatch({type:"select",arm:i,q:[]})},text:f=>`${(0,M.fixed)(f,1)} of 4`,signal:s.signal});return a.card.querySelector(".side").prepend(m.root),m.move(4),a.picture?.fit(),()=>(s.abort(),a.dispose())}function at(t,e){let o=e.row??1,s=Array.from({length:4},()=>Array.from({length:4},()=>(0,b.h)("td"))),r=(0,b.h)("table",{"aria-label":`A ${o}`},s.map(n=>(0,b.h)("tr",{},n))),a=(0,b.h)("span",{},(0,b.indexed)("A",o)," ="),l=D(t,{...e,joints:[o]},{state:{frames:"all"},side:[(0,b.h)("div.row",{},a,(0,b.h)("div.scroll",{},r))],words:()=>e.words??`Turn joint ${o}: ${Wt}`});return l.follow(n=>{let c=(0,$.linkFrames)({rows:[n.arm.rows[o-1]]},[n.q[(0,$.joints)(n.arm).indexOf(o-1)]]);(0,$.matrix)(c[1]).forEach((m,f)=>m.forEach((u,w)=>(0,b.write)(s[f][w],f===3?String(u):(0,M.sparse)(u,3))))}),l.dispose}function nt(t,e){let o=0,s=(0,b.h)("tr"),r=(0,b.h)("tbody"),a=(0,b.h)("table",{"aria-label":"Jacobian of the tip"},(0,b.h)("thead",{},s),r),l=D(t,e,{side:[(0,b.h)("div.scroll",{},a)],words:({arm:h})=>{let p=(0,$.joints)(h)[o],i=h.rows[p].kind==="revolute"?"turns about its axis":"slides";return`Column ${o+1}: the tip moves along the arrow when joint ${p+1} ${i} alone.`}}),{store:n,picture:c}=l,m=c&&new de.Arrow(c.force.shaft.material),f=h=>()=>{o=h,n.dispatch({type:"show",lit:(0,$.joints)(n.state.arm)[h]}),l.refresh()},u=(0,$.joints)(n.state.arm).map((h,p)=>(0,b.h)("button",{type:"button","aria-pressed":"false",onpointerenter:f(p),onfocus:f(p),onclick:f(p)},(0,b.indexed)("J",h+1)));s.replaceChildren((0,b.h)("th"),...u.map(h=>(0,b.h)("th",{},h)));let w=["vx","vy","vz","ωx","ωy","ωz"].map(h=>[h,u.map(()=>(0,b.h)("td"))]);return r.replaceChildren(...w.map(([h,p])=>(0,b.h)("tr",{},(0,b.h)("th",{},(0,b.indexed)(h[0],h[1])),p))),l.follow((h,p)=>{if(w.forEach(([,v],C)=>v.forEach((y,L)=>{(0,b.write)(y,(0,M.sparse)(p.columns[L][C],2)),y.classList.toggle("on",L===o)})),u.forEach((v,C)=>v.setAttribute("aria-pressed",String(C===o))),!m||!c.world)return;m.parent!==c.world&&c.world.add(m);let i=(0,$.scaled)(.3,p.columns[o].slice(0,3));m.point(p.frames.at(-1).o,i,.008*c.size)}),f(e.column?e.column-1:0)(),l.dispose}function st(t,e){return D(t,e,{state:{view:"jacobian"},words:(s,r)=>`Half axes ${r.linear.values.map(l=>(0,M.fixed)(l,2)).join(", ")}. ${(0,ce.rankVerdict)(r).text}`}).dispose}function it(t,e){let o=(0,b.h)("div.bars"),s=D(t,e,{state:{view:e.push?"torque":"pose",wrench:e.wrench??[0,0,0,0,0,0]},side:[o],words:(a,{torque:l})=>{let n=l.reduce((m,f,u)=>Math.abs(f)>Math.abs(l[m])?u:m,0),c=`joint ${(0,$.joints)(a.arm)[n]+1}: ${(0,M.fixed)(l[n],1)} N m`;return`${e.words??"Move the arm."} The most is asked of ${c}.`}}),r=(0,$.joints)(s.store.state.arm).map(a=>{let[l,n]=[(0,b.h)("span.fill"),(0,b.h)("span")];return{fill:l,value:n,root:(0,b.h)("div.bar",{},(0,b.h)("span",{},(0,b.indexed)("τ",a+1)),(0,b.h)("span.track",{},l),n)}});return o.replaceChildren(...r.map(a=>a.root)),s.follow((a,{torque:l})=>{let n=Math.max(...(0,$.joints)(a.arm).map(c=>a.arm.rows[c].effort??50));r.forEach(({fill:c,value:m},f)=>{let u=Math.max(-1,Math.min(1,l[f]/n));Object.assign(c.style,{left:`${50+50*Math.min(0,u)}%`,width:`${50*Math.abs(u)}%`}),(0,b.write)(m,`${(0,M.fixed)(l[f],1)} N m`)})}),s.dispose}function lt(t,e){let o=new AbortController,s=D(t,e,{words:u=>`The tip stays; ${(0,$.joints)(u.arm).map((h,p)=>`q${h+1} ${(0,M.jointText)(u.arm.rows[h],u.q[p],"deg")}`).join(", ")}.`}),{store:r}=s,a=r.derived.frames.at(-1);r.dispatch({type:"show",hold:{pinned:a,turns:!0,free:1}});let l=Kt(r.state.arm,r.state.q,a),n=l.findIndex(u=>u===r.state.q),c=u=>{let w=l[Math.max(0,Math.min(l.length-1,Math.round(u)))];r.dispatch({type:"move",q:w,hold:r.state.hold,gesture:"swing"})},m=u=>pe(l[Math.round(u)]?.[2]-l[n][2]),f=Z("elbow",[0,l.length-1],n,{put:c,text:m,signal:o.signal});return s.card.querySelector(".side").prepend(f.root),()=>(o.abort(),s.dispose())}function Kt(t,e,o){let s=(0,$.joints)(t).map(a=>[t.rows[a].lower??-1/0,t.rows[a].upper??1/0]),r=a=>{let l=[],[n,c]=[e,null];for(let m=0;m<80;m++){let f=Ut(t,n),[u]=(0,et.rightNull)(f);if(!u)break;let w=c?u.reduce((i,v,C)=>i+v*c[C],0):a*u[2],h=u.map(i=>w<0?-i:i),p=(0,tt.reach)(t,n.map((i,v)=>i+.03*h[v]),o).q;if(p.some((i,v)=>i<s[v][0]||i>s[v][1]))break;l.push(p),[n,c]=[p,h]}return l};return[...r(-1).reverse(),e,...r(1)]}function Ut(t,e){let o=(0,$.linkFrames)(t,e),s=o.at(-1).o;return(0,$.joints)(t).map(r=>{let{z:a,o:l}=o[r],n=(0,$.minus)(s,l);return[...[a[1]*n[2]-a[2]*n[1],a[2]*n[0]-a[0]*n[2],a[0]*n[1]-a[1]*n[0]],...a]})}function pt(t,e){let o=new AbortController,[s,r,a,l]=[null,0,e.radius??.1,0],n=D(t,e,{hold:!1,state:{view:"trace",lit:e.lit?e.lit-1:null},words:({arm:i})=>{if(!s)return"Computing …";let v=`Radius ${(0,M.fixed)(100*a,1)} cm`;if(s.largest>1e-4)return`${v}: no run gets round; the arm would have to pass a singular pose.`;let C=(0,$.joints)(i).flatMap((y,L)=>Math.abs(s.wound[L])>.9?[`joint ${y+1}`]:[]);return`${v}: ${C.length?`${(0,M.listed)(C)} wind once round`:"the joints swing and come back"}.`}}),{store:c}=n,m=c.state.q,f=()=>{let{path:i}=s,v=Math.round(r*(i.length-1));c.dispatch({type:"set",trace:i,q:i[v]})},u=async()=>{let i=++l,{arm:v}=c.state,C=await(0,xe.ask)("run",{arm:v,q:m,run:{method:"exact",steps:180,radius:a}});i!==l||o.signal.aborted||(s=C,f(),n.refresh())},w={signal:o.signal},h=Z("round",[0,1],0,{...w,put:i=>(r=i,s&&f()),text:i=>`${(0,M.fixed)(100*i,0)} %`}),p=Z("radius",[.01,.1],a,{...w,put:i=>(a=i,u()),text:i=>`${(0,M.fixed)(100*i,1)} cm`});return n.card.querySelector(".side").prepend(...e.fixed?[h.root]:[p.root,h.root]),u(),()=>(o.abort(),n.dispose())}function dt(t,e){let o=(0,b.h)("div.row",{role:"radiogroup","aria-label":"Ways"}),s=D(t,e,{state:{view:"branches"},side:[o],words:({arm:l,ways:n})=>n?(0,ce.waysVerdict)(l,n):"Computing …"}),{store:r}=s,a=!1;return(0,xe.ask)("ways",{arm:r.state.arm,q:r.state.q}).then(l=>{a||(r.dispatch({type:"ways",arm:r.state.arm,ways:l}),o.replaceChildren(...l.list.map(({q:n},c)=>(0,b.h)("button",{type:"button",role:"radio","aria-label":`Way ${c+1}`,style:`border-left: 6px solid ${(0,be.branchColour)(c)}`,onclick:()=>r.dispatch({type:"glide",q:n})},String(c+1)))),s.refresh())}),s.follow(({q:l,ways:n})=>{[...o.children].forEach((c,m)=>{let f=n?.list[m]?.q.every((u,w)=>Math.abs(u-l[w])<.001);c.setAttribute("aria-checked",String(!!f))})}),()=>(a=!0,s.dispose())}function ct(t,e){let o=D(t,{arm:"Elbow arm",...e},{words:({arm:a,q:l},{frames:n})=>{let[c,m]=[n[1].o,n.at(-1).o],f=(0,$.norm)((0,$.minus)(m,c)),[u,w]=[a.rows[1].a,a.rows[2].a],h=(f*f-u*u-w*w)/(2*u*w);return`${`Shoulder to tip ${(0,M.fixed)(1e3*f,0)} mm`}, so D = ${(0,M.fixed)(h,3)} and θ₃ = ${pe(l[2])}; its cosine is D.`}}),{picture:s}=o,r=[];return o.follow((a,{frames:l})=>{if(!s?.world)return;for(let p of r)p.traverse(i=>{i.material?.dispose(),i.geometry?.dispose()}),p.removeFromParent();let[n,c,m]=l.slice(1).map(p=>p.o),f=[m[0],m[1],n[2]],u=(p,i)=>[p,(0,$.plus)((0,$.scaled)(.5,p),(0,$.scaled)(.5,i)),i],w=.003*s.size;r=[[n,m,0],[n,f,2],[f,m,2],[n,c,1],[c,m,1]].filter(([p,i])=>(0,$.norm)((0,$.minus)(p,i))>.001).map(([p,i,v])=>(0,de.tube)(u(p,i),w,(0,be.branchColour)(v))),r.forEach(p=>s.world.add(p))}),o.dispose}var j=k(oe(),1),jt=k(H(),1),Et=k(ht(),1),$e=k(re(),1),Mt=k(ft(),1),R=k(he(),1),ee=k(ae(),1),I=k(H(),1);var d=k(H(),1),ve=1e-6,wt=t=>(0,d.scaled)(1/(0,d.norm)(t),t),gt=(t,e,o)=>Math.atan2((0,d.dot)(t,(0,d.cross)(e,o)),(0,d.dot)(e,o)),Vt=(t,e)=>t.every(o=>(0,d.norm)((0,d.minus)(e,o))>1e-4);function bt(t){let e=(0,d.joints)(t).map((r,a)=>t.rows[r].kind==="prismatic"?Math.max(.3,t.home[a]||0):0),o=(0,d.linkFrames)(t,e),s=(0,d.joints)(t).map(r=>({z:o[r].z,o:o[r].o,row:r}));return{q:e,frames:o,axes:s,base:o[0],end:o.at(-1)}}function xt(t,e,o,s){let r=(0,d.minus)(o,t),a=(0,d.cross)(e,s),l=(0,d.dot)(a,a);return l<ve?[t,(0,d.plus)(o,(0,d.scaled)(-(0,d.dot)(s,r),s))]:[(0,d.plus)(t,(0,d.scaled)((0,d.dot)((0,d.cross)(r,s),a)/l,e)),(0,d.plus)(o,(0,d.scaled)((0,d.dot)((0,d.cross)(r,e),a)/l,s))]}function ye(t,e){let o=e.length,s=e[o-1],r=o===t.axes.length,a=r?{z:s.z,o:t.end.o}:t.axes[o],[,l]=xt(s.o,s.z,a.o,a.z),n=t.axes[o+1],c=[],m=r?[t.end.o]:[l,a.o,...n?[xt(a.o,a.z,n.o,n.z)[0]]:[]];for(let f of m)Vt(c,f)&&c.push(f);if(!r)for(let f of[...c])c.length<3&&c.push((0,d.plus)(f,(0,d.scaled)(.12,a.z)));return{zs:[a.z,(0,d.scaled)(-1,a.z)],points:c.slice(0,4),axis:a}}function vt(t,e,o){let s=(0,d.cross)(t.z,e);(0,d.norm)(s)<ve&&(s=(0,d.minus)((0,d.minus)(o,t.o),(0,d.scaled)((0,d.dot)((0,d.minus)(o,t.o),t.z),t.z))),(0,d.norm)(s)<ve&&(s=t.x),s=wt(s);let r=wt((0,d.cross)(e,s));return[s,(0,d.scaled)(-1,s),r,(0,d.scaled)(-1,r)]}function yt(t,{x:e,z:o,o:s},r){if(Math.abs((0,d.dot)(e,o))>1e-4)return`x_${r} is not at a right angle to z_${r}.`;if(Math.abs((0,d.dot)(e,t.z))>1e-4)return`x_${r} is not at a right angle to z_${r-1}: no α about x_${r} can then turn z_${r-1} into z_${r}.`;let a=(0,d.minus)(s,t.o),l=(0,d.minus)((0,d.minus)(a,(0,d.scaled)((0,d.dot)(a,t.z),t.z)),(0,d.scaled)((0,d.dot)(a,e),e));return(0,d.norm)(l)>1e-4?`The line of x_${r} does not meet the axis z_${r-1}: no slide a along x_${r} can then bring o_${r} there.`:null}function Gt(t,e,o,s){let r=(0,d.minus)(e.o,t.o),a=(0,d.dot)(r,t.z);return{kind:o,a:(0,d.dot)(r,e.x),alpha:gt(e.x,t.z,e.z),d:o==="prismatic"?a-s:a,theta:gt(t.z,t.x,e.x)}}var kt=(t,e,o)=>({x:e,y:(0,d.cross)(t,e),z:t,o});function ke(t,e,o){return o.slice(1).map((s,r)=>{let{row:a}=e.axes[r],l=Math.sign((0,d.dot)(o[r].z,e.axes[r].z));return Gt(o[r],s,t.rows[a].kind,l*e.q[r])})}function $t(t=Math.random){let e=r=>r[Math.floor(t()*r.length)],o=e([3,4,5]),s=Array.from({length:o},(r,a)=>{let l=a===o-1,n=e(l?[.15,.2]:[0,.2,.3]),c=a===0?.3:e(n?[0,0,.15]:[.2,.25]),m=a>0&&!l&&t()<.2?"prismatic":"revolute",f=e([0,Math.PI/2,-Math.PI/2]);return{kind:m,a:n,alpha:l?0:f,d:c,theta:0,...{lower:null,upper:null,speed:null,effort:null}}});return{name:"An arm of its own",home:s.map(r=>r.kind==="prismatic"?.3:0),rows:s}}var Ht=22,zt="An arm of its own",Yt="A table of this arm; the book chose other directions or zeros, which are free.",Qt={z:t=>`Frame ${t}: which way shall z point along its axis?`,o:t=>`Frame ${t}: where on that axis is its origin?`,x:t=>`Frame ${t}: and which way does x point?`};function qt(t,e){let o=["UR10e (homework)","Panda (homework)","Stanford arm","Elbow arm",zt],s=(0,j.h)("select",{"aria-label":"Arm to place frames on",onchange:z=>L(z.target.value)},o.map(z=>(0,j.h)("option",{value:z,selected:z===e.arm},z))),r=(0,j.h)("p.words",{"aria-live":"polite"}),a=(0,j.h)("div.row",{role:"group","aria-label":"Choices"}),l=(0,j.h)("button",{type:"button",onclick:()=>K()},"Back"),n=(0,j.h)("p.why",{hidden:!0,"aria-live":"polite"}),c=(0,j.h)("tbody"),m=["i","a (m)","α (°)","d (m)","θ (°)"].map(z=>(0,j.h)("th",{scope:"col"},z)),f=(0,j.h)("table",{"aria-label":"The table so far"},(0,j.h)("thead",{},(0,j.h)("tr",{},m)),c),u=[(0,j.h)("div.row",{},s,l),r,a,n,(0,j.h)("div.scroll",{},f)],w,h,p,i,v=D(t,{arm:e.arm??o[3]},{hold:!1,side:u,words:()=>""}),{store:C,picture:y}=v;function L(z){w=z===zt?$t():ge(z),h=bt(w),p=[h.base],i={},C.dispatch({type:"select",arm:w,q:h.q});let q=h.axes.flatMap(({z:T,o:S})=>[-1,1].map(x=>(0,I.plus)(S,(0,I.scaled)(x*1.3*g(),T))));y?.figure.fit([...q,h.end.o,(0,I.plus)(h.end.o,[0,0,g()]),[0,0,0]]),J()}let B=()=>i.z?i.o?"x":"o":"z",Y=()=>p.length>h.axes.length;function W(){if(Y())return[];let z=p.at(-1),{zs:q,points:T,axis:S}=ye(h,p);return B()==="z"?q.map(x=>({value:x,at:(0,I.plus)(S.o,(0,I.scaled)(g(),x)),label:At(x)})):B()==="o"?T.map((x,O)=>({value:x,at:x,label:"ABCD"[O]})):vt(z,i.z,i.o).map(x=>({value:x,at:(0,I.plus)(i.o,(0,I.scaled)(g(),x)),label:At(x)}))}let g=()=>.16*(y?.size??1);function F({value:z}){if(i={...i,[B()]:z},n.hidden=!0,i.x){let q=kt(i.z,i.x,i.o),T=yt(p.at(-1),q,p.length);if(T){let{z:S,o:x}=i;i=/does not meet/.test(T)?{z:S}:{z:S,o:x},(0,j.write)(n,T.replaceAll(/_(\d+)/g,(O,E)=>[...E].map(N=>"₀₁₂₃₄₅₆₇₈₉"[N]).join(""))),n.hidden=!1}else p=[...p,q],i={}}J()}function K(){i.o?i={z:i.z}:i.z?i={}:p.length>1&&(p=p.slice(0,-1)),n.hidden=!0,J()}function J(){let q=W().map(S=>(0,j.h)("button",{type:"button",onclick:()=>F(S)},S.label));a.replaceChildren(...q),(0,j.write)(r,Y()?ue():Qt[B()](p.length)),l.disabled=p.length===1&&!i.z;let T=ke(w,h,p);c.replaceChildren(...T.map((S,x)=>{let O=S.kind==="revolute"?"theta":"d",E=(P,Ot)=>(0,j.h)("td",{},Ot,...P===O?[" + ",...(0,j.indexed)("q",x+1)]:[]),N=P=>(0,ee.entryText)(P,!0,"deg"),U=P=>E(P,(0,ee.entryText)(S[P],!1,"deg")),Q=P=>E(P,N(S[P])),te=[U("a"),Q("alpha"),U("d"),Q("theta")];return(0,j.h)("tr",{},(0,j.h)("th",{scope:"row"},String(x+1)),te)})),v.refresh()}function ue(){let z={lower:null,upper:null,speed:null,effort:null},q=ke(w,h,p).map(x=>({...z,...x}));return(0,Et.sameArm)({name:"yours",home:[],rows:q},w)?(0,jt.joints)(w).every((x,O)=>{let E=w.rows[x];return["a","alpha","d","theta"].every(N=>Math.abs(q[O][N]-E[N])<1e-6)})?"A table of this arm, and the book’s own.":Yt:"The table is valid row by row, and yet not this arm: go back and look at the last frame."}let V=[];v.follow(()=>G());function G(){if(!y?.world||!h)return;y.triads.visible=!1,y.labels.set([]),V.forEach(Mt.freed);let{size:z}=y,q=(0,R.paint)((0,$e.branchColour)(7));y.body.visible=!1;let T=new R.ArmShape(w,{link:q,joint:q,ghost:!0,girth:.2});T.pose(h.frames);let S=h.axes.map(({z:E,o:N})=>{let U=(0,R.rod)(q);return(0,R.along)(U,(0,I.plus)(N,(0,I.scaled)(-.2*z,E)),(0,I.plus)(N,(0,I.scaled)(.2*z,E)),.002*z),U}),x=new R.Triads(y.dark,p.length);x.pose(p,.1*z);let O=W().map(({at:E,value:N})=>{let U=(0,R.paint)((0,$e.branchColour)(1)),Q=B()==="o"?null:B()==="z"?ye(h,p).axis.o:i.o;if(!Q){let P=(0,R.ball)(U);return P.position.fromArray(E),P.scale.setScalar(.014*z),P}let te=new R.Arrow(U);return te.point(Q,(0,I.scaled)(g(),N),.005*z),te});V=[T,...S,x,...O],V.forEach(E=>y.world.add(E)),y.labels.set(W().map(({at:E,label:N})=>({tip:E,letter:N,index:"",tone:"y"})))}return y?.figure.listen(y.figure.canvas,"click",z=>{let[q,T]=y.figure.place(z),x=W().map(O=>{let[E,N]=y.figure.pixel(O.at);return{one:O,gap:Math.hypot(E-q,N-T)}}).sort((O,E)=>O.gap-E.gap)[0];x&&x.gap<Ht&&F(x.one)}),L(e.arm??o[3]),v.dispose}function At(t){let e=t.findIndex(o=>Math.abs(Math.abs(o)-1)<1e-6);return e<0?`(${t.map(o=>(0,ee.fixed)(o,2)).join(", ")})`:e===2?t[2]>0?"up":"down":`${t[e]>0?"+":"−"}${"xy"[e]}`}var Tt=k(Ct(),1),Xt={columns:nt,ellipsoid:st,hand:ot,loads:it,matrix:at,row:rt,swing:lt,trainer:qt,triangles:ct,ways:dt,winds:pt};for(let[t,e]of Object.entries(Xt))(0,Tt.registerFigure)(t,e);})();
