(()=>{var tt=Object.create;var ae=Object.defineProperty;var rt=Object.getOwnPropertyDescriptor;var ot=Object.getOwnPropertyNames;var at=Object.getPrototypeOf,nt=Object.prototype.hasOwnProperty;var j=(r,t)=>()=>{try{return t||r((t={exports:{}}).exports,t),t.exports}catch(o){throw t=0,o}};var st=(r,t,o,l)=>{if(t&&typeof t=="object"||typeof t=="function")for(let i of ot(t))!nt.call(r,i)&&i!==o&&ae(r,i,{get:()=>t[i],enumerable:!(l=rt(t,i))||l.enumerable});return r};var y=(r,t,o)=>(o=r!=null?tt(at(r)):{},st(t||!r||!r.__esModule?ae(o,"default",{value:r,enumerable:!0}):o,r));var V=j((bt,ne)=>{ne.exports=ArmExplorer.kit["dom.js"]});var ie=j((xt,se)=>{se.exports=ArmExplorer.kit["jobs.js"]});var B=j((gt,le)=>{le.exports=ArmExplorer.kit["kinematics.js"]});var de=j((vt,pe)=>{pe.exports=ArmExplorer.kit["linear.js"]});var ce=j((yt,ue)=>{ue.exports=ArmExplorer.kit["motion.js"]});var G=j((kt,he)=>{he.exports=ArmExplorer.kit["scene.js"]});var fe=j(($t,me)=>{me.exports=ArmExplorer.kit["shapes.js"]});var U=j((jt,we)=>{we.exports=ArmExplorer.kit["text.js"]});var _=j((At,be)=>{be.exports=ArmExplorer.kit["verdicts.js"]});var ve=j((Mt,ge)=>{ge.exports=ArmExplorer.kit["arm.js"]});var ke=j((zt,ye)=>{ye.exports=ArmExplorer.kit["grab.js"]});var je=j((qt,$e)=>{$e.exports=ArmExplorer.kit["rail.js"]});var Ee=j((St,Ae)=>{Ae.exports=ArmExplorer.kit["state.js"]});var ze=j((Ct,Me)=>{Me.exports=ArmExplorer.kit["still.js"]});var Se=j((Tt,qe)=>{qe.exports=ArmExplorer.kit["theme.js"]});var Ke=j((It,He)=>{He.exports=ArmExplorer.kit["figures.js"]});var f=y(V(),1),Q=y(ie(),1),b=y(B(),1),Le=y(de(),1),Pe=y(ce(),1),X=y(G(),1),J=y(fe(),1),k=y(U(),1),W=y(_(),1);var xe=`:host {
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
@media print {
  .live {
    display: none;
  }
}
`;var P=y(ve(),1),v=y(V(),1),Ce=y(ke(),1),Te=y(B(),1),K=y(je(),1),Oe=y(G(),1),D=y(Ee(),1),T=y(ze(),1),I=y(U(),1),Re=y(Se(),1),Ne=y(_(),1);var H=[{name:"Panda",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.0825,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.054982,.066502,.039252]},{kind:"revolute",a:-.0825,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.029330000000000002,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"Panda (homework)",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.060481999999999994,.066502,.039252]},{kind:"revolute",a:-.088,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.03482999999999999,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"UR10e",home:[0,-1.5707963267948966,0,-1.5707963267948966,0,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1807,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[7.369,.021,0,.027]},{kind:"revolute",a:-.6127,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[13.051,.38,0,.158]},{kind:"revolute",a:-.57155,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150,body:[3.989,.24,0,.068]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.17415,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[2.1,0,.007,.018]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.11985,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[1.98,0,.007,.018]},{kind:"revolute",a:0,alpha:0,d:.21655000000000002,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[.615,0,0,-.126]}]},{name:"UR10e (homework)",home:[0,0,0,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.128,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.6127,alpha:3.141592653589793,d:0,theta:-1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.5716,alpha:3.141592653589793,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1639,theta:1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.1157,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:0,d:.1922,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56}]},{name:"Stanford arm",home:[0,0,.5,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.154,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"prismatic",a:0,alpha:0,d:0,theta:0,lower:.1,upper:1,speed:null,effort:null},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:0,d:.263,theta:0,lower:null,upper:null,speed:null,effort:null}]},{name:"Elbow arm",home:[0,.7853981633974483,-1.5707963267948966],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.5,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.4,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.3,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null}]}];var pt=r=>H.find(t=>t.name===r)??H[0],dt=0;function M(r,t,{state:o={},hold:l=!0,words:i,side:a=[]}){let n=new AbortController,{signal:e}=n,d=pt(t.arm),u=new D.Store((0,D.startingState)({arm:d,q:t.q??(0,P.homeOf)(d),...o})),h=r.shadowRoot??r.attachShadow({mode:"open"}),s=(0,v.h)("div.labels",{"aria-hidden":"true"}),x=(0,v.h)("button.grip",{type:"button","aria-label":"Tip: drag it",tabindex:"-1",hidden:!l}),m=(0,v.h)("div.stage",{role:"img","aria-label":`The ${d.name}`},s,x),c=(0,v.h)("p.words"),p=(0,v.h)("p.why",{hidden:!0}),g=(t.joints??[]).map(w=>q(w)),$=(0,v.h)("figure.live",{},m,(0,v.h)("div.side",{},...a,...g.map(w=>w.root),c,p));h.replaceChildren((0,v.h)("style",{},xe),$);let A=null;try{A=new Oe.ArmPicture(m,s,{onPlace:([w,E])=>x.style.transform=`translate(${w}px, ${E}px)`}),l&&(0,Ce.makeGrabbable)(A,u,{grip:x,goTo:w=>u.dispatch({type:"glide",q:w})})}catch{x.hidden=!0}function q(w){let E=(0,Te.joints)(d).indexOf(w-1),S=d.rows[w-1],[C,Xe]=(0,P.range)(S),ee=(z,L=null)=>{u.dispatch({type:"move",q:u.state.q.map((Ze,et)=>et===E?z:Ze),gesture:L})},N=(0,v.h)("input",{type:"range",min:C,max:Xe,step:"any","aria-label":`Joint ${w}`,oninput:z=>ee(Number(z.target.value),`keys ${w}`)}),te=(0,v.h)("div.rail",{},N),re=null;(0,K.relativeRail)(te,N,{start:()=>re=`lever ${++dt}`,put:z=>ee(z,re),signal:e});let oe=(0,v.h)("output"),Ye=({q:z,unit:L})=>{N.value=String(z[E]),N.setAttribute("aria-valuetext",(0,I.spokenJoint)(S,z[E],L)),(0,v.write)(oe,(0,I.jointText)(S,z[E],L))};return{root:(0,v.h)("div.lever",{},(0,v.h)("span",{},(0,v.indexed)("q",w)),te,oe),show:Ye}}let Y="light",Z=[];function R(){let{state:w,derived:E}=u;for(let C of g)C.show(w);(0,v.write)(c,i(w,E));let S=w.hold?.target&&!w.hold.moving?(0,Ne.stopVerdict)(w.hold):"";(0,v.write)(p,S),p.hidden=!S;for(let C of Z)C(w,E);A?A.draw(w,E,Y):m.replaceChildren((0,T.stillSvg)(w.arm,E.frames,(0,T.poseText)(w.arm,w.q))),m.setAttribute("aria-label",(0,T.poseText)(w.arm,w.q))}return(0,Re.watchTheme)(w=>{Y=w,$.dataset.theme=w,R()},e),u.listen(R,e),{store:u,picture:A,card:$,signal:e,refresh:R,follow:w=>(Z.push(w),R()),dispose(){n.abort(),A?.dispose(),h.replaceChildren()}}}function O(r,[t,o],l,{put:i,text:a,signal:n}){let e=(0,v.h)("input",{type:"range",min:t,max:o,step:"any",value:l,"aria-label":r}),d=(0,v.h)("output",{},a(l)),u=s=>{e.value=String(s),e.setAttribute("aria-valuetext",a(s)),(0,v.write)(d,a(s)),i(s)};e.addEventListener("input",()=>u(Number(e.value)),{signal:n});let h=(0,v.h)("div.rail",{},e);return(0,K.relativeRail)(h,e,{put:u,signal:n}),{root:(0,v.h)("div.lever",{},(0,v.h)("span",{},r),h,d),move:u}}var ut="only the entries with its angle move; the last column goes round on a circle of radius a.",ct=r=>r.map(t=>(0,k.fixed)(1e3*t,0)).join(", "),F=r=>`${(0,k.fixed)(r*180/Math.PI,0)}°`;function De(r,t){let o=(l,{frames:i})=>`${t.words??"Drag a link, or the tip."} The tip is at (${ct(i.at(-1).o)}) mm.`;return M(r,t,{state:{frames:t.frames??"ends"},words:o}).dispose}function Ie(r,t){let o=["turn by θ about z","slide by d along z","slide by a along x","turn by α about x"],l=new AbortController,i=4,a=M(r,t,{hold:!1,state:{frames:"all"},words:({arm:h})=>{let{theta:s,d:x,a:m,alpha:c}=h.rows[0],p=[F(s),`${(0,k.fixed)(1e3*x,0)} mm`,`${(0,k.fixed)(1e3*m,0)} mm`,F(c)],g=o.slice(0,Math.ceil(i)).map(($,A)=>`${$} (${p[A]})`);return g.length?`${g.join(", then ")}.`:"The frame before the row."}}),e=a.store.state.arm.rows[(t.row??1)-1],u=O("motions",[0,4],4,{put:h=>{i=h;let s=g=>Math.min(1,Math.max(0,h-g)),x=e.theta+(e.kind==="revolute"?t.angle??.7:0),m=e.d+(e.kind==="prismatic"?t.slide??.3:0),c={kind:"fixed",theta:s(0)*x,d:s(1)*m,a:s(2)*e.a,alpha:s(3)*e.alpha},p={name:`Row ${t.row??1}`,home:[],rows:[c]};a.store.dispatch({type:"select",arm:p,q:[]})},text:h=>`${(0,k.fixed)(h,1)} of 4`,signal:l.signal});return a.card.querySelector(".side").prepend(u.root),u.move(4),a.picture?.fit(),()=>(l.abort(),a.dispose())}function Fe(r,t){let o=t.row??1,l=Array.from({length:4},()=>Array.from({length:4},()=>(0,f.h)("td"))),i=(0,f.h)("table",{"aria-label":`A ${o}`},l.map(e=>(0,f.h)("tr",{},e))),a=(0,f.h)("span",{},(0,f.indexed)("A",o)," ="),n=M(r,{...t,joints:[o]},{state:{frames:"all"},side:[(0,f.h)("div.row",{},a,(0,f.h)("div.scroll",{},i))],words:()=>t.words??`Turn joint ${o}: ${ut}`});return n.follow(e=>{let d=(0,b.linkFrames)({rows:[e.arm.rows[o-1]]},[e.q[(0,b.joints)(e.arm).indexOf(o-1)]]);(0,b.matrix)(d[1]).forEach((u,h)=>u.forEach((s,x)=>(0,f.write)(l[h][x],h===3?String(s):(0,k.sparse)(s,3))))}),n.dispose}function Je(r,t){let o=0,l=(0,f.h)("tr"),i=(0,f.h)("tbody"),a=(0,f.h)("table",{"aria-label":"Jacobian of the tip"},(0,f.h)("thead",{},l),i),n=M(r,t,{side:[(0,f.h)("div.scroll",{},a)],words:({arm:m})=>{let c=(0,b.joints)(m)[o],p=m.rows[c].kind==="revolute"?"turns about its axis":"slides";return`Column ${o+1}: the tip moves along the arrow when joint ${c+1} ${p} alone.`}}),{store:e,picture:d}=n,u=d&&new J.Arrow(d.force.shaft.material),h=m=>()=>{o=m,e.dispatch({type:"show",lit:(0,b.joints)(e.state.arm)[m]}),n.refresh()},s=(0,b.joints)(e.state.arm).map((m,c)=>(0,f.h)("button",{type:"button","aria-pressed":"false",onpointerenter:h(c),onfocus:h(c),onclick:h(c)},(0,f.indexed)("J",m+1)));l.replaceChildren((0,f.h)("th"),...s.map(m=>(0,f.h)("th",{},m)));let x=["vx","vy","vz","ωx","ωy","ωz"].map(m=>[m,s.map(()=>(0,f.h)("td"))]);return i.replaceChildren(...x.map(([m,c])=>(0,f.h)("tr",{},(0,f.h)("th",{},(0,f.indexed)(m[0],m[1])),c))),n.follow((m,c)=>{if(x.forEach(([,g],$)=>g.forEach((A,q)=>{(0,f.write)(A,(0,k.sparse)(c.columns[q][$],2)),A.classList.toggle("on",q===o)})),s.forEach((g,$)=>g.setAttribute("aria-pressed",String($===o))),!u||!d.world)return;u.parent!==d.world&&d.world.add(u);let p=(0,b.scaled)(.3,c.columns[o].slice(0,3));u.point(c.frames.at(-1).o,p,.008*d.size)}),h(t.column?t.column-1:0)(),n.dispose}function We(r,t){return M(r,t,{state:{view:"jacobian"},words:(l,i)=>`Half axes ${i.linear.values.map(n=>(0,k.fixed)(n,2)).join(", ")}. ${(0,W.rankVerdict)(i).text}`}).dispose}function Ve(r,t){let o=(0,f.h)("div.bars"),l=M(r,t,{state:{view:t.push?"torque":"pose",wrench:t.wrench??[0,0,0,0,0,0]},side:[o],words:(a,{torque:n})=>{let e=n.reduce((u,h,s)=>Math.abs(h)>Math.abs(n[u])?s:u,0),d=`joint ${(0,b.joints)(a.arm)[e]+1}: ${(0,k.fixed)(n[e],1)} N m`;return`${t.words??"Move the arm."} The most is asked of ${d}.`}}),i=(0,b.joints)(l.store.state.arm).map(a=>{let[n,e]=[(0,f.h)("span.fill"),(0,f.h)("span")];return{fill:n,value:e,root:(0,f.h)("div.bar",{},(0,f.h)("span",{},(0,f.indexed)("τ",a+1)),(0,f.h)("span.track",{},n),e)}});return o.replaceChildren(...i.map(a=>a.root)),l.follow((a,{torque:n})=>{let e=Math.max(...(0,b.joints)(a.arm).map(d=>a.arm.rows[d].effort??50));i.forEach(({fill:d,value:u},h)=>{let s=Math.max(-1,Math.min(1,n[h]/e));Object.assign(d.style,{left:`${50+50*Math.min(0,s)}%`,width:`${50*Math.abs(s)}%`}),(0,f.write)(u,`${(0,k.fixed)(n[h],1)} N m`)})}),l.dispose}function Be(r,t){let o=new AbortController,l=M(r,t,{words:s=>`The tip stays; ${(0,b.joints)(s.arm).map((m,c)=>`q${m+1} ${(0,k.jointText)(s.arm.rows[m],s.q[c],"deg")}`).join(", ")}.`}),{store:i}=l,a=i.derived.frames.at(-1);i.dispatch({type:"show",hold:{pinned:a,turns:!0,free:1}});let n=ht(i.state.arm,i.state.q,a),e=n.findIndex(s=>s===i.state.q),d=s=>{let x=n[Math.max(0,Math.min(n.length-1,Math.round(s)))];i.dispatch({type:"move",q:x,hold:i.state.hold,gesture:"swing"})},u=s=>F(n[Math.round(s)]?.[2]-n[e][2]),h=O("elbow",[0,n.length-1],e,{put:d,text:u,signal:o.signal});return l.card.querySelector(".side").prepend(h.root),()=>(o.abort(),l.dispose())}function ht(r,t,o){let l=(0,b.joints)(r).map(a=>[r.rows[a].lower??-1/0,r.rows[a].upper??1/0]),i=a=>{let n=[],[e,d]=[t,null];for(let u=0;u<80;u++){let h=mt(r,e),[s]=(0,Le.rightNull)(h);if(!s)break;let x=d?s.reduce((p,g,$)=>p+g*d[$],0):a*s[2],m=s.map(p=>x<0?-p:p),c=(0,Pe.reach)(r,e.map((p,g)=>p+.03*m[g]),o).q;if(c.some((p,g)=>p<l[g][0]||p>l[g][1]))break;n.push(c),[e,d]=[c,m]}return n};return[...i(-1).reverse(),t,...i(1)]}function mt(r,t){let o=(0,b.linkFrames)(r,t),l=o.at(-1).o;return(0,b.joints)(r).map(i=>{let{z:a,o:n}=o[i],e=(0,b.minus)(l,n);return[...[a[1]*e[2]-a[2]*e[1],a[2]*e[0]-a[0]*e[2],a[0]*e[1]-a[1]*e[0]],...a]})}function Ge(r,t){let o=new AbortController,[l,i,a,n]=[null,0,t.radius??.1,0],e=M(r,t,{hold:!1,state:{view:"trace",lit:t.lit?t.lit-1:null},words:({arm:p})=>{if(!l)return"Computing …";let g=`Radius ${(0,k.fixed)(100*a,1)} cm`;if(l.largest>1e-4)return`${g}: no run gets round; the arm would have to pass a singular pose.`;let $=(0,b.joints)(p).flatMap((A,q)=>Math.abs(l.wound[q])>.9?[`joint ${A+1}`]:[]);return`${g}: ${$.length?`${(0,k.listed)($)} wind once round`:"the joints swing and come back"}.`}}),{store:d}=e,u=d.state.q,h=()=>{let{path:p}=l,g=Math.round(i*(p.length-1));d.dispatch({type:"set",trace:p,q:p[g]})},s=async()=>{let p=++n,{arm:g}=d.state,$=await(0,Q.ask)("run",{arm:g,q:u,run:{method:"exact",steps:180,radius:a}});p!==n||o.signal.aborted||(l=$,h(),e.refresh())},x={signal:o.signal},m=O("round",[0,1],0,{...x,put:p=>(i=p,l&&h()),text:p=>`${(0,k.fixed)(100*p,0)} %`}),c=O("radius",[.01,.1],a,{...x,put:p=>(a=p,s()),text:p=>`${(0,k.fixed)(100*p,1)} cm`});return e.card.querySelector(".side").prepend(...t.fixed?[m.root]:[c.root,m.root]),s(),()=>(o.abort(),e.dispose())}function Ue(r,t){let o=(0,f.h)("div.row",{role:"radiogroup","aria-label":"Ways"}),l=M(r,t,{state:{view:"branches"},side:[o],words:({arm:n,ways:e})=>e?(0,W.waysVerdict)(n,e):"Computing …"}),{store:i}=l,a=!1;return(0,Q.ask)("ways",{arm:i.state.arm,q:i.state.q}).then(n=>{a||(i.dispatch({type:"ways",arm:i.state.arm,ways:n}),o.replaceChildren(...n.list.map(({q:e},d)=>(0,f.h)("button",{type:"button",role:"radio","aria-label":`Way ${d+1}`,style:`border-left: 6px solid ${(0,X.branchColour)(d)}`,onclick:()=>i.dispatch({type:"glide",q:e})},String(d+1)))),l.refresh())}),l.follow(({q:n,ways:e})=>{[...o.children].forEach((d,u)=>{let h=e?.list[u]?.q.every((s,x)=>Math.abs(s-n[x])<.001);d.setAttribute("aria-checked",String(!!h))})}),()=>(a=!0,l.dispose())}function _e(r,t){let o=M(r,{arm:"Elbow arm",...t},{words:({arm:a,q:n},{frames:e})=>{let[d,u]=[e[1].o,e.at(-1).o],h=(0,b.norm)((0,b.minus)(u,d)),[s,x]=[a.rows[1].a,a.rows[2].a],m=(h*h-s*s-x*x)/(2*s*x);return`${`Shoulder to tip ${(0,k.fixed)(1e3*h,0)} mm`}, so D = ${(0,k.fixed)(m,3)} and θ₃ = ${F(n[2])}; its cosine is D.`}}),{picture:l}=o,i=[];return o.follow((a,{frames:n})=>{if(!l?.world)return;for(let c of i)c.traverse(p=>{p.material?.dispose(),p.geometry?.dispose()}),c.removeFromParent();let[e,d,u]=n.slice(1).map(c=>c.o),h=[u[0],u[1],e[2]],s=(c,p)=>[c,(0,b.plus)((0,b.scaled)(.5,c),(0,b.scaled)(.5,p)),p],x=.003*l.size;i=[[e,u,0],[e,h,2],[h,u,2],[e,d,1],[d,u,1]].filter(([c,p])=>(0,b.norm)((0,b.minus)(c,p))>.001).map(([c,p,g])=>(0,J.tube)(s(c,p),x,(0,X.branchColour)(g))),i.forEach(c=>l.world.add(c))}),o.dispose}var Qe=y(Ke(),1),ft={columns:Je,ellipsoid:We,hand:De,loads:Ve,matrix:Fe,row:Ie,swing:Be,triangles:_e,ways:Ue,winds:Ge};for(let[r,t]of Object.entries(ft))(0,Qe.registerFigure)(r,t);})();
