(()=>{var Ct=Object.create;var ze=Object.defineProperty;var Tt=Object.getOwnPropertyDescriptor;var Ot=Object.getOwnPropertyNames;var _t=Object.getPrototypeOf,Nt=Object.prototype.hasOwnProperty;var N=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(o){throw e=0,o}};var Rt=(t,e,o,s)=>{if(e&&typeof e=="object"||typeof e=="function")for(let r of Ot(e))!Nt.call(t,r)&&r!==o&&ze(t,r,{get:()=>e[r],enumerable:!(s=Tt(e,r))||s.enumerable});return t};var z=(t,e,o)=>(o=t!=null?Ct(_t(t)):{},Rt(e||!t||!t.__esModule?ze(o,"default",{value:t,enumerable:!0}):o,t));var oe=N((Qt,Ae)=>{Ae.exports=ArmExplorer.kit["dom.js"]});var Ee=N((Xt,je)=>{je.exports=ArmExplorer.kit["jobs.js"]});var H=N((Zt,Me)=>{Me.exports=ArmExplorer.kit["kinematics.js"]});var Se=N((eo,qe)=>{qe.exports=ArmExplorer.kit["linear.js"]});var Te=N((to,Ce)=>{Ce.exports=ArmExplorer.kit["motion.js"]});var re=N((oo,Oe)=>{Oe.exports=ArmExplorer.kit["scene.js"]});var me=N((ro,_e)=>{_e.exports=ArmExplorer.kit["shapes.js"]});var ae=N((ao,Ne)=>{Ne.exports=ArmExplorer.kit["text.js"]});var he=N((no,Re)=>{Re.exports=ArmExplorer.kit["verdicts.js"]});var Ie=N((io,Pe)=>{Pe.exports=ArmExplorer.kit["arm.js"]});var Le=N((lo,De)=>{De.exports=ArmExplorer.kit["grab.js"]});var We=N((po,Be)=>{Be.exports=ArmExplorer.kit["rail.js"]});var Ke=N((co,Je)=>{Je.exports=ArmExplorer.kit["state.js"]});var Ve=N((uo,Ue)=>{Ue.exports=ArmExplorer.kit["still.js"]});var He=N((mo,Ge)=>{Ge.exports=ArmExplorer.kit["theme.js"]});var mt=N((vo,ut)=>{ut.exports=ArmExplorer.kit["same.js"]});var Mt=N((Ao,Et)=>{Et.exports=ArmExplorer.kit["figures.js"]});var b=z(oe(),1),xe=z(Ee(),1),k=z(H(),1),et=z(Se(),1),tt=z(Te(),1),be=z(re(),1),de=z(me(),1),q=z(ae(),1),ce=z(he(),1);var Fe=`:host {
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
`;var ne=z(Ie(),1),j=z(oe(),1),se=z(Le(),1),Ye=z(H(),1),we=z(We(),1),Qe=z(re(),1),ie=z(Ke(),1),X=z(Ve(),1),le=z(ae(),1),Xe=z(He(),1),Ze=z(he(),1);var fe=[{name:"Panda",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.0825,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.054982,.066502,.039252]},{kind:"revolute",a:-.0825,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.029330000000000002,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"Panda (homework)",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.060481999999999994,.066502,.039252]},{kind:"revolute",a:-.088,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.03482999999999999,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"UR10e",home:[0,-1.5707963267948966,0,-1.5707963267948966,0,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1807,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[7.369,.021,0,.027]},{kind:"revolute",a:-.6127,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[13.051,.38,0,.158]},{kind:"revolute",a:-.57155,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150,body:[3.989,.24,0,.068]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.17415,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[2.1,0,.007,.018]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.11985,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[1.98,0,.007,.018]},{kind:"revolute",a:0,alpha:0,d:.21655000000000002,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[.615,0,0,-.126]}]},{name:"UR10e (homework)",home:[0,0,0,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.128,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.6127,alpha:3.141592653589793,d:0,theta:-1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.5716,alpha:3.141592653589793,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1639,theta:1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.1157,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:0,d:.1922,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56}]},{name:"Stanford arm",home:[0,0,.5,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.154,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"prismatic",a:0,alpha:0,d:0,theta:0,lower:.1,upper:1,speed:null,effort:null},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:0,d:.263,theta:0,lower:null,upper:null,speed:null,effort:null}]},{name:"Elbow arm",home:[0,.7853981633974483,-1.5707963267948966],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.5,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.4,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.3,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null}]}];var ge=t=>fe.find(e=>e.name===t)??fe[0],It=0;function D(t,e,{state:o={},hold:s=!0,words:r,side:a=[]}){let l=new AbortController,{signal:n}=l,c=ge(e.arm),h=new ie.Store((0,ie.startingState)({arm:c,q:e.q??(0,ne.homeOf)(c),...o})),f=t.shadowRoot??t.attachShadow({mode:"open"}),u=(0,j.h)("div.labels",{"aria-hidden":"true"}),w=(0,j.h)("button.grip",{type:"button","aria-label":"Tip: drag it, or move it by arrow keys",hidden:!s,onkeydown:g=>y&&(0,se.moveTipByKey)(y,h,g)}),m=(0,j.h)("div.stage",{role:"group","aria-label":`The ${c.name}`},u,w),d=(0,j.h)("p.words"),i=(0,j.h)("p.why",{hidden:!0}),v=(e.joints??[]).map(g=>L(g)),T=(0,j.h)("figure.live",{},m,(0,j.h)("div.side",{},...a,...v.map(g=>g.root),d,i));f.replaceChildren((0,j.h)("style",{},Fe),T,(0,j.h)("div.paper",{},(0,j.h)("slot")));let y=null;try{y=new Qe.ArmPicture(m,u,{onPlace:([g,F])=>w.style.transform=`translate(${g}px, ${F}px)`}),s&&(0,se.makeGrabbable)(y,h,{grip:w,goTo:g=>h.dispatch({type:"glide",q:g})})}catch{w.hidden=!0}function L(g){let F=(0,Ye.joints)(c).indexOf(g-1),K=c.rows[g-1],[J,ue]=(0,ne.range)(K),V=(x,_=null)=>{h.dispatch({type:"move",q:h.state.q.map((A,M)=>M===F?x:A),gesture:_})},G=(0,j.h)("input",{type:"range",min:J,max:ue,step:"any","aria-label":`Joint ${g}`,oninput:x=>V(Number(x.target.value),`keys ${g}`)}),$=(0,j.h)("div.rail",{},G),S=null;(0,we.relativeRail)($,G,{start:()=>S=`lever ${++It}`,put:x=>V(x,S),signal:n});let O=(0,j.h)("output"),C=({q:x,unit:_})=>{G.value=String(x[F]),G.setAttribute("aria-valuetext",(0,le.spokenJoint)(K,x[F],_)),(0,j.write)(O,(0,le.jointText)(K,x[F],_))};return{root:(0,j.h)("div.lever",{},(0,j.h)("span",{},(0,j.indexed)("q",g)),$,O),show:C}}let B="light",Y=[];function W(){let{state:g,derived:F}=h;for(let J of v)J.show(g);(0,j.write)(d,r(g,F));let K=g.hold?.target&&!g.hold.moving?(0,Ze.stopVerdict)(g.hold):"";(0,j.write)(i,K),i.hidden=!K,y?y.draw(g,F,B):m.replaceChildren((0,X.stillSvg)(g.arm,F.frames,(0,X.poseText)(g.arm,g.q)));for(let J of Y)J(g,F);m.setAttribute("aria-label",(0,X.poseText)(g.arm,g.q))}return(0,Xe.watchTheme)(g=>{B=g,T.dataset.theme=g,W()},n),h.listen(W,n),{store:h,picture:y,card:T,signal:n,refresh:W,follow:g=>(Y.push(g),W()),dispose(){l.abort(),y?.dispose(),f.replaceChildren()}}}function Z(t,[e,o],s,{put:r,text:a,signal:l}){let n=(0,j.h)("input",{type:"range",min:e,max:o,step:"any",value:s,"aria-label":t}),c=(0,j.h)("output",{},a(s)),h=u=>{n.value=String(u),n.setAttribute("aria-valuetext",a(u)),(0,j.write)(c,a(u)),r(u)};n.addEventListener("input",()=>h(Number(n.value)),{signal:l});let f=(0,j.h)("div.rail",{},n);return(0,we.relativeRail)(f,n,{put:h,signal:l}),{root:(0,j.h)("div.lever",{},(0,j.h)("span",{},t),f,c),move:h}}var Dt="only the entries with its angle move; the last column goes round on a circle of radius a.",Lt=t=>t.map(e=>(0,q.fixed)(1e3*e,0)).join(", "),pe=t=>`${(0,q.fixed)(t*180/Math.PI,0)}°`;function ot(t,e){let o=(s,{frames:r})=>`${e.words??"Drag a link, or the tip."} The tip is at (${Lt(r.at(-1).o)}) mm.`;return D(t,e,{state:{frames:e.frames??"ends"},words:o}).dispose}function rt(t,e){let o=["turn by θ about z","slide by d along z","slide by a along x","turn by α about x"],s=new AbortController,r=4,a=D(t,e,{hold:!1,state:{frames:"all"},words:({arm:f})=>{let{theta:u,d:w,a:m,alpha:d}=f.rows[0],i=[pe(u),`${(0,q.fixed)(1e3*w,0)} mm`,`${(0,q.fixed)(1e3*m,0)} mm`,pe(d)],v=o.slice(0,Math.ceil(r)).map((T,y)=>`${T} (${i[y]})`);return v.length?`${v.join(", then ")}.`:"The frame before the row."}}),n=a.store.state.arm.rows[(e.row??1)-1],h=Z("motions",[0,4],4,{put:f=>{r=f;let u=v=>Math.min(1,Math.max(0,f-v)),w=n.theta+(n.kind==="revolute"?e.angle??.7:0),m=n.d+(n.kind==="prismatic"?e.slide??.3:0),d={kind:"fixed",theta:u(0)*w,d:u(1)*m,a:u(2)*n.a,alpha:u(3)*n.alpha},i={name:`Row ${e.row??1}`,home:[],rows:[d]};a.store.dispatch({type:"select",arm:i,q:[]})},text:f=>`${(0,q.fixed)(f,1)} of 4`,signal:s.signal});return a.card.querySelector(".side").prepend(h.root),h.move(4),a.picture?.fit(),()=>(s.abort(),a.dispose())}function at(t,e){let o=e.row??1,s=Array.from({length:4},()=>Array.from({length:4},()=>(0,b.h)("td"))),r=(0,b.h)("table",{"aria-label":`A ${o}`},s.map(n=>(0,b.h)("tr",{},n))),a=(0,b.h)("span",{},(0,b.indexed)("A",o)," ="),l=D(t,{...e,joints:[o]},{state:{frames:"all"},side:[(0,b.h)("div.row",{},a,(0,b.h)("div.scroll",{},r))],words:()=>e.words??`Turn joint ${o}: ${Dt}`});return l.follow(n=>{let c=(0,k.linkFrames)({rows:[n.arm.rows[o-1]]},[n.q[(0,k.joints)(n.arm).indexOf(o-1)]]);(0,k.matrix)(c[1]).forEach((h,f)=>h.forEach((u,w)=>(0,b.write)(s[f][w],f===3?String(u):(0,q.sparse)(u,3))))}),l.dispose}function nt(t,e){let o=0,s=(0,b.h)("tr"),r=(0,b.h)("tbody"),a=(0,b.h)("table",{"aria-label":"Jacobian of the tip"},(0,b.h)("thead",{},s),r),l=D(t,e,{side:[(0,b.h)("div.scroll",{},a)],words:({arm:m})=>{let d=(0,k.joints)(m)[o],i=m.rows[d].kind==="revolute"?"turns about its axis":"slides";return`Column ${o+1}: the tip moves along the arrow when joint ${d+1} ${i} alone.`}}),{store:n,picture:c}=l,h=c&&new de.Arrow(c.force.shaft.material),f=m=>()=>{o=m,n.dispatch({type:"show",lit:(0,k.joints)(n.state.arm)[m]}),l.refresh()},u=(0,k.joints)(n.state.arm).map((m,d)=>(0,b.h)("button",{type:"button","aria-pressed":"false",onpointerenter:f(d),onfocus:f(d),onclick:f(d)},(0,b.indexed)("J",m+1)));s.replaceChildren((0,b.h)("th"),...u.map(m=>(0,b.h)("th",{},m)));let w=["vx","vy","vz","ωx","ωy","ωz"].map(m=>[m,u.map(()=>(0,b.h)("td"))]);return r.replaceChildren(...w.map(([m,d])=>(0,b.h)("tr",{},(0,b.h)("th",{},(0,b.indexed)(m[0],m[1])),d))),l.follow((m,d)=>{if(w.forEach(([,v],T)=>v.forEach((y,L)=>{(0,b.write)(y,(0,q.sparse)(d.columns[L][T],2)),y.classList.toggle("on",L===o)})),u.forEach((v,T)=>v.setAttribute("aria-pressed",String(T===o))),!h||!c.world)return;h.parent!==c.world&&c.world.add(h);let i=(0,k.scaled)(.3,d.columns[o].slice(0,3));h.point(d.frames.at(-1).o,i,.008*c.size)}),f(e.column?e.column-1:0)(),l.dispose}function st(t,e){return D(t,e,{state:{view:"jacobian"},words:(s,r)=>`Half axes ${r.linear.values.map(l=>(0,q.fixed)(l,2)).join(", ")}. ${(0,ce.rankVerdict)(r).text}`}).dispose}function it(t,e){let o=(0,b.h)("div.bars"),s=D(t,e,{state:{view:e.push?"torque":"pose",wrench:e.wrench??[0,0,0,0,0,0]},side:[o],words:(a,{torque:l})=>{let n=l.reduce((h,f,u)=>Math.abs(f)>Math.abs(l[h])?u:h,0),c=`joint ${(0,k.joints)(a.arm)[n]+1}: ${(0,q.fixed)(l[n],1)} N m`;return`${e.words??"Move the arm."} The most is asked of ${c}.`}}),r=(0,k.joints)(s.store.state.arm).map(a=>{let[l,n]=[(0,b.h)("span.fill"),(0,b.h)("span")];return{fill:l,value:n,root:(0,b.h)("div.bar",{},(0,b.h)("span",{},(0,b.indexed)("τ",a+1)),(0,b.h)("span.track",{},l),n)}});return o.replaceChildren(...r.map(a=>a.root)),s.follow((a,{torque:l})=>{let n=Math.max(...(0,k.joints)(a.arm).map(c=>a.arm.rows[c].effort??50));r.forEach(({fill:c,value:h},f)=>{let u=Math.max(-1,Math.min(1,l[f]/n));Object.assign(c.style,{left:`${50+50*Math.min(0,u)}%`,width:`${50*Math.abs(u)}%`}),(0,b.write)(h,`${(0,q.fixed)(l[f],1)} N m`)})}),s.dispose}function lt(t,e){let o=new AbortController,s=D(t,e,{words:u=>`The tip stays; ${(0,k.joints)(u.arm).map((m,d)=>`q${m+1} ${(0,q.jointText)(u.arm.rows[m],u.q[d],"deg")}`).join(", ")}.`}),{store:r}=s,a=r.derived.frames.at(-1);r.dispatch({type:"show",hold:{pinned:a,turns:!0,free:1}});let l=Bt(r.state.arm,r.state.q,a),n=l.findIndex(u=>u===r.state.q),c=u=>{let w=l[Math.max(0,Math.min(l.length-1,Math.round(u)))];r.dispatch({type:"move",q:w,hold:r.state.hold,gesture:"swing"})},h=u=>pe(l[Math.round(u)]?.[2]-l[n][2]),f=Z("elbow",[0,l.length-1],n,{put:c,text:h,signal:o.signal});return s.card.querySelector(".side").prepend(f.root),()=>(o.abort(),s.dispose())}function Bt(t,e,o){let s=(0,k.joints)(t).map(a=>[t.rows[a].lower??-1/0,t.rows[a].upper??1/0]),r=a=>{let l=[],[n,c]=[e,null];for(let h=0;h<80;h++){let f=Wt(t,n),[u]=(0,et.rightNull)(f);if(!u)break;let w=c?u.reduce((i,v,T)=>i+v*c[T],0):a*u[2],m=u.map(i=>w<0?-i:i),d=(0,tt.reach)(t,n.map((i,v)=>i+.03*m[v]),o).q;if(d.some((i,v)=>i<s[v][0]||i>s[v][1]))break;l.push(d),[n,c]=[d,m]}return l};return[...r(-1).reverse(),e,...r(1)]}function Wt(t,e){let o=(0,k.linkFrames)(t,e),s=o.at(-1).o;return(0,k.joints)(t).map(r=>{let{z:a,o:l}=o[r],n=(0,k.minus)(s,l);return[...[a[1]*n[2]-a[2]*n[1],a[2]*n[0]-a[0]*n[2],a[0]*n[1]-a[1]*n[0]],...a]})}function pt(t,e){let o=new AbortController,[s,r,a,l]=[null,0,e.radius??.1,0],n=D(t,e,{hold:!1,state:{view:"trace",lit:e.lit?e.lit-1:null},words:({arm:i})=>{if(!s)return"Computing …";let v=`Radius ${(0,q.fixed)(100*a,1)} cm`;if(s.largest>1e-4)return`${v}: no run gets round; the arm would have to pass a singular pose.`;let T=(0,k.joints)(i).flatMap((y,L)=>Math.abs(s.wound[L])>.9?[`joint ${y+1}`]:[]);return`${v}: ${T.length?`${(0,q.listed)(T)} wind once round`:"the joints swing and come back"}.`}}),{store:c}=n,h=c.state.q,f=()=>{let{path:i}=s,v=Math.round(r*(i.length-1));c.dispatch({type:"set",trace:i,q:i[v]})},u=async()=>{let i=++l,{arm:v}=c.state,T=await(0,xe.ask)("run",{arm:v,q:h,run:{method:"exact",steps:180,radius:a}});i!==l||o.signal.aborted||(s=T,f(),n.refresh())},w={signal:o.signal},m=Z("round",[0,1],0,{...w,put:i=>(r=i,s&&f()),text:i=>`${(0,q.fixed)(100*i,0)} %`}),d=Z("radius",[.01,.1],a,{...w,put:i=>(a=i,u()),text:i=>`${(0,q.fixed)(100*i,1)} cm`});return n.card.querySelector(".side").prepend(...e.fixed?[m.root]:[d.root,m.root]),u(),()=>(o.abort(),n.dispose())}function dt(t,e){let o=(0,b.h)("div.row",{role:"radiogroup","aria-label":"Ways"}),s=D(t,e,{state:{view:"branches"},side:[o],words:({arm:l,ways:n})=>n?(0,ce.waysVerdict)(l,n):"Computing …"}),{store:r}=s,a=!1;return(0,xe.ask)("ways",{arm:r.state.arm,q:r.state.q}).then(l=>{a||(r.dispatch({type:"ways",arm:r.state.arm,ways:l}),o.replaceChildren(...l.list.map(({q:n},c)=>(0,b.h)("button",{type:"button",role:"radio","aria-label":`Way ${c+1}`,style:`border-left: 6px solid ${(0,be.branchColour)(c)}`,onclick:()=>r.dispatch({type:"glide",q:n})},String(c+1)))),s.refresh())}),s.follow(({q:l,ways:n})=>{[...o.children].forEach((c,h)=>{let f=n?.list[h]?.q.every((u,w)=>Math.abs(u-l[w])<.001);c.setAttribute("aria-checked",String(!!f))})}),()=>(a=!0,s.dispose())}function ct(t,e){let o=D(t,{arm:"Elbow arm",...e},{words:({arm:a,q:l},{frames:n})=>{let[c,h]=[n[1].o,n.at(-1).o],f=(0,k.norm)((0,k.minus)(h,c)),[u,w]=[a.rows[1].a,a.rows[2].a],m=(f*f-u*u-w*w)/(2*u*w);return`${`Shoulder to tip ${(0,q.fixed)(1e3*f,0)} mm`}, so D = ${(0,q.fixed)(m,3)} and θ₃ = ${pe(l[2])}; its cosine is D.`}}),{picture:s}=o,r=[];return o.follow((a,{frames:l})=>{if(!s?.world)return;for(let d of r)d.traverse(i=>{i.material?.dispose(),i.geometry?.dispose()}),d.removeFromParent();let[n,c,h]=l.slice(1).map(d=>d.o),f=[h[0],h[1],n[2]],u=(d,i)=>[d,(0,k.plus)((0,k.scaled)(.5,d),(0,k.scaled)(.5,i)),i],w=.003*s.size;r=[[n,h,0],[n,f,2],[f,h,2],[n,c,1],[c,h,1]].filter(([d,i])=>(0,k.norm)((0,k.minus)(d,i))>.001).map(([d,i,v])=>(0,de.tube)(u(d,i),w,(0,be.branchColour)(v))),r.forEach(d=>s.world.add(d))}),o.dispose}var E=z(oe(),1),zt=z(H(),1),At=z(mt(),1),$e=z(re(),1),R=z(me(),1),ee=z(ae(),1),P=z(H(),1);var p=z(H(),1),ve=1e-6,ht=t=>(0,p.scaled)(1/(0,p.norm)(t),t),ft=(t,e,o)=>Math.atan2((0,p.dot)(t,(0,p.cross)(e,o)),(0,p.dot)(e,o)),Jt=(t,e)=>t.every(o=>(0,p.norm)((0,p.minus)(e,o))>1e-4);function gt(t){let e=(0,p.joints)(t).map((r,a)=>t.rows[r].kind==="prismatic"?Math.max(.3,t.home[a]||0):0),o=(0,p.linkFrames)(t,e),s=(0,p.joints)(t).map(r=>({z:o[r].z,o:o[r].o,row:r}));return{q:e,frames:o,axes:s,base:o[0],end:o.at(-1)}}function wt(t,e,o,s){let r=(0,p.minus)(o,t),a=(0,p.cross)(e,s),l=(0,p.dot)(a,a);return l<ve?[t,(0,p.plus)(o,(0,p.scaled)(-(0,p.dot)(s,r),s))]:[(0,p.plus)(t,(0,p.scaled)((0,p.dot)((0,p.cross)(r,s),a)/l,e)),(0,p.plus)(o,(0,p.scaled)((0,p.dot)((0,p.cross)(r,e),a)/l,s))]}function ye(t,e){let o=e.length,s=e[o-1],r=o===t.axes.length,a=r?{z:s.z,o:t.end.o}:t.axes[o],[,l]=wt(s.o,s.z,a.o,a.z),n=t.axes[o+1],c=[],h=r?[t.end.o]:[l,a.o,...n?[wt(a.o,a.z,n.o,n.z)[0]]:[]];for(let f of h)Jt(c,f)&&c.push(f);if(!r)for(let f of[...c])c.length<3&&c.push((0,p.plus)(f,(0,p.scaled)(.12,a.z)));return{zs:[a.z,(0,p.scaled)(-1,a.z)],points:c.slice(0,4),axis:a}}function xt(t,e,o){let s=(0,p.cross)(t.z,e);(0,p.norm)(s)<ve&&(s=(0,p.minus)((0,p.minus)(o,t.o),(0,p.scaled)((0,p.dot)((0,p.minus)(o,t.o),t.z),t.z))),(0,p.norm)(s)<ve&&(s=t.x),s=ht(s);let r=ht((0,p.cross)(e,s));return[s,(0,p.scaled)(-1,s),r,(0,p.scaled)(-1,r)]}function bt(t,{x:e,z:o,o:s},r){if(Math.abs((0,p.dot)(e,o))>1e-4)return`x_${r} is not at a right angle to z_${r}.`;if(Math.abs((0,p.dot)(e,t.z))>1e-4)return`x_${r} is not at a right angle to z_${r-1}: no α about x_${r} can then turn z_${r-1} into z_${r}.`;let a=(0,p.minus)(s,t.o),l=(0,p.minus)((0,p.minus)(a,(0,p.scaled)((0,p.dot)(a,t.z),t.z)),(0,p.scaled)((0,p.dot)(a,e),e));return(0,p.norm)(l)>1e-4?`The line of x_${r} does not meet the axis z_${r-1}: no slide a along x_${r} can then bring o_${r} there.`:null}function Kt(t,e,o,s){let r=(0,p.minus)(e.o,t.o),a=(0,p.dot)(r,t.z);return{kind:o,a:(0,p.dot)(r,e.x),alpha:ft(e.x,t.z,e.z),d:o==="prismatic"?a-s:a,theta:ft(t.z,t.x,e.x)}}var vt=(t,e,o)=>({x:e,y:(0,p.cross)(t,e),z:t,o});function ke(t,e,o){return o.slice(1).map((s,r)=>{let{row:a}=e.axes[r],l=Math.sign((0,p.dot)(o[r].z,e.axes[r].z));return Kt(o[r],s,t.rows[a].kind,l*e.q[r])})}function yt(t=Math.random){let e=r=>r[Math.floor(t()*r.length)],o=e([3,4,5]),s=Array.from({length:o},(r,a)=>{let l=a===o-1,n=e(l?[.15,.2]:[0,.2,.3]),c=a===0?.3:e(n?[0,0,.15]:[.2,.25]),h=a>0&&!l&&t()<.2?"prismatic":"revolute",f=e([0,Math.PI/2,-Math.PI/2]);return{kind:h,a:n,alpha:l?0:f,d:c,theta:0,...{lower:null,upper:null,speed:null,effort:null}}});return{name:"An arm of its own",home:s.map(r=>r.kind==="prismatic"?.3:0),rows:s}}var Ut=22,kt="An arm of its own",Vt="A table of this arm; the book chose other directions or zeros, which are free.",Gt={z:t=>`Frame ${t}: which way shall z point along its axis?`,o:t=>`Frame ${t}: where on that axis is its origin?`,x:t=>`Frame ${t}: and which way does x point?`};function jt(t,e){let o=["UR10e (homework)","Panda (homework)","Stanford arm","Elbow arm",kt],s=(0,E.h)("select",{"aria-label":"Arm to place frames on",onchange:$=>L($.target.value)},o.map($=>(0,E.h)("option",{value:$,selected:$===e.arm},$))),r=(0,E.h)("p.words",{"aria-live":"polite"}),a=(0,E.h)("div.row",{role:"group","aria-label":"Choices"}),l=(0,E.h)("button",{type:"button",onclick:()=>K()},"Back"),n=(0,E.h)("p.why",{hidden:!0,"aria-live":"polite"}),c=(0,E.h)("tbody"),h=["i","a (m)","α (°)","d (m)","θ (°)"].map($=>(0,E.h)("th",{scope:"col"},$)),f=(0,E.h)("table",{"aria-label":"The table so far"},(0,E.h)("thead",{},(0,E.h)("tr",{},h)),c),u=[(0,E.h)("div.row",{},s,l),r,a,n,(0,E.h)("div.scroll",{},f)],w,m,d,i,v=D(t,{arm:e.arm??o[3]},{hold:!1,side:u,words:()=>""}),{store:T,picture:y}=v;function L($){w=$===kt?yt():ge($),m=gt(w),d=[m.base],i={},T.dispatch({type:"select",arm:w,q:m.q});let S=m.axes.flatMap(({z:O,o:C})=>[-1,1].map(x=>(0,P.plus)(C,(0,P.scaled)(x*1.3*g(),O))));y?.figure.fit([...S,m.end.o,(0,P.plus)(m.end.o,[0,0,g()]),[0,0,0]]),J()}let B=()=>i.z?i.o?"x":"o":"z",Y=()=>d.length>m.axes.length;function W(){if(Y())return[];let $=d.at(-1),{zs:S,points:O,axis:C}=ye(m,d);return B()==="z"?S.map(x=>({value:x,at:(0,P.plus)(C.o,(0,P.scaled)(g(),x)),label:$t(x)})):B()==="o"?O.map((x,_)=>({value:x,at:x,label:"ABCD"[_]})):xt($,i.z,i.o).map(x=>({value:x,at:(0,P.plus)(i.o,(0,P.scaled)(g(),x)),label:$t(x)}))}let g=()=>.16*(y?.size??1);function F({value:$}){if(i={...i,[B()]:$},n.hidden=!0,i.x){let S=vt(i.z,i.x,i.o),O=bt(d.at(-1),S,d.length);if(O){let{z:C,o:x}=i;i=/does not meet/.test(O)?{z:C}:{z:C,o:x},(0,E.write)(n,O.replaceAll(/_(\d+)/g,(_,A)=>[...A].map(M=>"₀₁₂₃₄₅₆₇₈₉"[M]).join(""))),n.hidden=!1}else d=[...d,S],i={}}J()}function K(){i.o?i={z:i.z}:i.z?i={}:d.length>1&&(d=d.slice(0,-1)),n.hidden=!0,J()}function J(){let S=W().map(C=>(0,E.h)("button",{type:"button",onclick:()=>F(C)},C.label));a.replaceChildren(...S),(0,E.write)(r,Y()?ue():Gt[B()](d.length)),l.disabled=d.length===1&&!i.z;let O=ke(w,m,d);c.replaceChildren(...O.map((C,x)=>{let _=C.kind==="revolute"?"theta":"d",A=(I,St)=>(0,E.h)("td",{},St,...I===_?[" + ",...(0,E.indexed)("q",x+1)]:[]),M=I=>(0,ee.entryText)(I,!0,"deg"),U=I=>A(I,(0,ee.entryText)(C[I],!1,"deg")),Q=I=>A(I,M(C[I])),te=[U("a"),Q("alpha"),U("d"),Q("theta")];return(0,E.h)("tr",{},(0,E.h)("th",{scope:"row"},String(x+1)),te)})),v.refresh()}function ue(){let $={lower:null,upper:null,speed:null,effort:null},S=ke(w,m,d).map(x=>({...$,...x}));return(0,At.sameArm)({name:"yours",home:[],rows:S},w)?(0,zt.joints)(w).every((x,_)=>{let A=w.rows[x];return["a","alpha","d","theta"].every(M=>Math.abs(S[_][M]-A[M])<1e-6)})?"A table of this arm, and the book’s own.":Vt:"The table is valid row by row, and yet not this arm: go back and look at the last frame."}let V=null;v.follow(()=>G());function G(){if(!y?.world||!m)return;for(let A of y.triads)A.visible=!1;y.labels.set([]),V&&V.forEach(A=>(A.traverse(M=>M.material?.dispose()),A.removeFromParent()));let{size:$}=y,S=(0,R.paint)((0,$e.branchColour)(7));y.body.visible=!1;let O=new R.ArmShape(w,{link:S,joint:S,ghost:!0,girth:.2});O.pose(m.frames);let C=m.axes.map(({z:A,o:M})=>{let U=(0,R.rod)(S);return(0,R.along)(U,(0,P.plus)(M,(0,P.scaled)(-.2*$,A)),(0,P.plus)(M,(0,P.scaled)(.2*$,A)),.002*$),U}),x=d.map(A=>{let M=new R.Triad(y.dark);return M.pose(A,.1*$),M}),_=W().map(({at:A,value:M})=>{let U=(0,R.paint)((0,$e.branchColour)(1)),Q=B()==="o"?null:B()==="z"?ye(m,d).axis.o:i.o;if(!Q){let I=(0,R.ball)(U);return I.position.fromArray(A),I.scale.setScalar(.014*$),I}let te=new R.Arrow(U);return te.point(Q,(0,P.scaled)(g(),M),.005*$),te});V=[O,...C,...x,..._],V.forEach(A=>y.world.add(A)),y.labels.set(W().map(({at:A,label:M})=>({tip:A,letter:M,index:"",tone:"y"})))}return y?.figure.listen(y.figure.canvas,"click",$=>{let[S,O]=y.figure.place($),x=W().map(_=>{let[A,M]=y.figure.pixel(_.at);return{one:_,gap:Math.hypot(A-S,M-O)}}).sort((_,A)=>_.gap-A.gap)[0];x&&x.gap<Ut&&F(x.one)}),L(e.arm??o[3]),v.dispose}function $t(t){let e=t.findIndex(o=>Math.abs(Math.abs(o)-1)<1e-6);return e<0?`(${t.map(o=>(0,ee.fixed)(o,2)).join(", ")})`:e===2?t[2]>0?"up":"down":`${t[e]>0?"+":"−"}${"xy"[e]}`}var qt=z(Mt(),1),Ht={columns:nt,ellipsoid:st,hand:ot,loads:it,matrix:at,row:rt,swing:lt,trainer:jt,triangles:ct,ways:dt,winds:pt};for(let[t,e]of Object.entries(Ht))(0,qt.registerFigure)(t,e);})();
