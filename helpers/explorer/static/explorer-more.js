(()=>{var Ce=Object.create;var $t=Object.defineProperty;var Te=Object.getOwnPropertyDescriptor;var Oe=Object.getOwnPropertyNames;var _e=Object.getPrototypeOf,Ne=Object.prototype.hasOwnProperty;var N=(e,t)=>()=>{try{return t||e((t={exports:{}}).exports,t),t.exports}catch(o){throw t=0,o}};var Re=(e,t,o,s)=>{if(t&&typeof t=="object"||typeof t=="function")for(let r of Oe(t))!Ne.call(e,r)&&r!==o&&$t(e,r,{get:()=>t[r],enumerable:!(s=Te(t,r))||s.enumerable});return e};var $=(e,t,o)=>(o=e!=null?Ce(_e(e)):{},Re(t||!e||!e.__esModule?$t(o,"default",{value:e,enumerable:!0}):o,e));var ot=N((Qe,zt)=>{zt.exports=ArmExplorer.kit["dom.js"]});var jt=N((Xe,At)=>{At.exports=ArmExplorer.kit["jobs.js"]});var H=N((Ze,Et)=>{Et.exports=ArmExplorer.kit["kinematics.js"]});var qt=N((to,Mt)=>{Mt.exports=ArmExplorer.kit["linear.js"]});var Ct=N((eo,St)=>{St.exports=ArmExplorer.kit["motion.js"]});var rt=N((oo,Tt)=>{Tt.exports=ArmExplorer.kit["scene.js"]});var ut=N((ro,Ot)=>{Ot.exports=ArmExplorer.kit["shapes.js"]});var at=N((ao,_t)=>{_t.exports=ArmExplorer.kit["text.js"]});var ht=N((no,Nt)=>{Nt.exports=ArmExplorer.kit["verdicts.js"]});var Pt=N((io,Ft)=>{Ft.exports=ArmExplorer.kit["arm.js"]});var Dt=N((lo,It)=>{It.exports=ArmExplorer.kit["grab.js"]});var Bt=N((po,Lt)=>{Lt.exports=ArmExplorer.kit["rail.js"]});var Jt=N((co,Wt)=>{Wt.exports=ArmExplorer.kit["state.js"]});var Vt=N((uo,Ut)=>{Ut.exports=ArmExplorer.kit["still.js"]});var Kt=N((ho,Gt)=>{Gt.exports=ArmExplorer.kit["theme.js"]});var he=N((vo,ue)=>{ue.exports=ArmExplorer.kit["same.js"]});var Me=N((Ao,Ee)=>{Ee.exports=ArmExplorer.kit["figures.js"]});var b=$(ot(),1),xt=$(jt(),1),y=$(H(),1),te=$(qt(),1),ee=$(Ct(),1),gt=$(rt(),1),pt=$(ut(),1),q=$(at(),1),dt=$(ht(),1);var Rt=`:host {
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
`;var nt=$(Pt(),1),j=$(ot(),1),Ht=$(Dt(),1),Yt=$(H(),1),ft=$(Bt(),1),Qt=$(rt(),1),st=$(Jt(),1),X=$(Vt(),1),it=$(at(),1),Xt=$(Kt(),1),Zt=$(ht(),1);var mt=[{name:"Panda",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.0825,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.054982,.066502,.039252]},{kind:"revolute",a:-.0825,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.029330000000000002,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"Panda (homework)",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.060481999999999994,.066502,.039252]},{kind:"revolute",a:-.088,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.03482999999999999,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"UR10e",home:[0,-1.5707963267948966,0,-1.5707963267948966,0,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1807,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[7.369,.021,0,.027]},{kind:"revolute",a:-.6127,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[13.051,.38,0,.158]},{kind:"revolute",a:-.57155,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150,body:[3.989,.24,0,.068]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.17415,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[2.1,0,.007,.018]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.11985,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[1.98,0,.007,.018]},{kind:"revolute",a:0,alpha:0,d:.21655000000000002,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[.615,0,0,-.126]}]},{name:"UR10e (homework)",home:[0,0,0,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.128,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.6127,alpha:3.141592653589793,d:0,theta:-1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.5716,alpha:3.141592653589793,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1639,theta:1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.1157,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:0,d:.1922,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56}]},{name:"Stanford arm",home:[0,0,.5,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.154,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"prismatic",a:0,alpha:0,d:0,theta:0,lower:.1,upper:1,speed:null,effort:null},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:0,d:.263,theta:0,lower:null,upper:null,speed:null,effort:null}]},{name:"Elbow arm",home:[0,.7853981633974483,-1.5707963267948966],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.5,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.4,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.3,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null}]}];var wt=e=>mt.find(t=>t.name===e)??mt[0],Ie=0;function D(e,t,{state:o={},hold:s=!0,words:r,side:a=[]}){let l=new AbortController,{signal:n}=l,c=wt(t.arm),f=new st.Store((0,st.startingState)({arm:c,q:t.q??(0,nt.homeOf)(c),...o})),m=e.shadowRoot??e.attachShadow({mode:"open"}),u=(0,j.h)("div.labels",{"aria-hidden":"true"}),w=(0,j.h)("button.grip",{type:"button","aria-label":"Tip: drag it",tabindex:"-1",hidden:!s}),h=(0,j.h)("div.stage",{role:"img","aria-label":`The ${c.name}`},u,w),d=(0,j.h)("p.words"),i=(0,j.h)("p.why",{hidden:!0}),v=(t.joints??[]).map(x=>L(x)),T=(0,j.h)("figure.live",{},h,(0,j.h)("div.side",{},...a,...v.map(x=>x.root),d,i));m.replaceChildren((0,j.h)("style",{},Rt),T);let z=null;try{z=new Qt.ArmPicture(h,u,{onPlace:([x,F])=>w.style.transform=`translate(${x}px, ${F}px)`}),s&&(0,Ht.makeGrabbable)(z,f,{grip:w,goTo:x=>f.dispatch({type:"glide",q:x})})}catch{w.hidden=!0}function L(x){let F=(0,Yt.joints)(c).indexOf(x-1),U=c.rows[x-1],[J,ct]=(0,nt.range)(U),G=(g,_=null)=>{f.dispatch({type:"move",q:f.state.q.map((A,M)=>M===F?g:A),gesture:_})},K=(0,j.h)("input",{type:"range",min:J,max:ct,step:"any","aria-label":`Joint ${x}`,oninput:g=>G(Number(g.target.value),`keys ${x}`)}),k=(0,j.h)("div.rail",{},K),S=null;(0,ft.relativeRail)(k,K,{start:()=>S=`lever ${++Ie}`,put:g=>G(g,S),signal:n});let O=(0,j.h)("output"),C=({q:g,unit:_})=>{K.value=String(g[F]),K.setAttribute("aria-valuetext",(0,it.spokenJoint)(U,g[F],_)),(0,j.write)(O,(0,it.jointText)(U,g[F],_))};return{root:(0,j.h)("div.lever",{},(0,j.h)("span",{},(0,j.indexed)("q",x)),k,O),show:C}}let B="light",Y=[];function W(){let{state:x,derived:F}=f;for(let J of v)J.show(x);(0,j.write)(d,r(x,F));let U=x.hold?.target&&!x.hold.moving?(0,Zt.stopVerdict)(x.hold):"";(0,j.write)(i,U),i.hidden=!U,z?z.draw(x,F,B):h.replaceChildren((0,X.stillSvg)(x.arm,F.frames,(0,X.poseText)(x.arm,x.q)));for(let J of Y)J(x,F);h.setAttribute("aria-label",(0,X.poseText)(x.arm,x.q))}return(0,Xt.watchTheme)(x=>{B=x,T.dataset.theme=x,W()},n),f.listen(W,n),{store:f,picture:z,card:T,signal:n,refresh:W,follow:x=>(Y.push(x),W()),dispose(){l.abort(),z?.dispose(),m.replaceChildren()}}}function Z(e,[t,o],s,{put:r,text:a,signal:l}){let n=(0,j.h)("input",{type:"range",min:t,max:o,step:"any",value:s,"aria-label":e}),c=(0,j.h)("output",{},a(s)),f=u=>{n.value=String(u),n.setAttribute("aria-valuetext",a(u)),(0,j.write)(c,a(u)),r(u)};n.addEventListener("input",()=>f(Number(n.value)),{signal:l});let m=(0,j.h)("div.rail",{},n);return(0,ft.relativeRail)(m,n,{put:f,signal:l}),{root:(0,j.h)("div.lever",{},(0,j.h)("span",{},e),m,c),move:f}}var De="only the entries with its angle move; the last column goes round on a circle of radius a.",Le=e=>e.map(t=>(0,q.fixed)(1e3*t,0)).join(", "),lt=e=>`${(0,q.fixed)(e*180/Math.PI,0)}°`;function oe(e,t){let o=(s,{frames:r})=>`${t.words??"Drag a link, or the tip."} The tip is at (${Le(r.at(-1).o)}) mm.`;return D(e,t,{state:{frames:t.frames??"ends"},words:o}).dispose}function re(e,t){let o=["turn by θ about z","slide by d along z","slide by a along x","turn by α about x"],s=new AbortController,r=4,a=D(e,t,{hold:!1,state:{frames:"all"},words:({arm:m})=>{let{theta:u,d:w,a:h,alpha:d}=m.rows[0],i=[lt(u),`${(0,q.fixed)(1e3*w,0)} mm`,`${(0,q.fixed)(1e3*h,0)} mm`,lt(d)],v=o.slice(0,Math.ceil(r)).map((T,z)=>`${T} (${i[z]})`);return v.length?`${v.join(", then ")}.`:"The frame before the row."}}),n=a.store.state.arm.rows[(t.row??1)-1],f=Z("motions",[0,4],4,{put:m=>{r=m;let u=v=>Math.min(1,Math.max(0,m-v)),w=n.theta+(n.kind==="revolute"?t.angle??.7:0),h=n.d+(n.kind==="prismatic"?t.slide??.3:0),d={kind:"fixed",theta:u(0)*w,d:u(1)*h,a:u(2)*n.a,alpha:u(3)*n.alpha},i={name:`Row ${t.row??1}`,home:[],rows:[d]};a.store.dispatch({type:"select",arm:i,q:[]})},text:m=>`${(0,q.fixed)(m,1)} of 4`,signal:s.signal});return a.card.querySelector(".side").prepend(f.root),f.move(4),a.picture?.fit(),()=>(s.abort(),a.dispose())}function ae(e,t){let o=t.row??1,s=Array.from({length:4},()=>Array.from({length:4},()=>(0,b.h)("td"))),r=(0,b.h)("table",{"aria-label":`A ${o}`},s.map(n=>(0,b.h)("tr",{},n))),a=(0,b.h)("span",{},(0,b.indexed)("A",o)," ="),l=D(e,{...t,joints:[o]},{state:{frames:"all"},side:[(0,b.h)("div.row",{},a,(0,b.h)("div.scroll",{},r))],words:()=>t.words??`Turn joint ${o}: ${De}`});return l.follow(n=>{let c=(0,y.linkFrames)({rows:[n.arm.rows[o-1]]},[n.q[(0,y.joints)(n.arm).indexOf(o-1)]]);(0,y.matrix)(c[1]).forEach((f,m)=>f.forEach((u,w)=>(0,b.write)(s[m][w],m===3?String(u):(0,q.sparse)(u,3))))}),l.dispose}function ne(e,t){let o=0,s=(0,b.h)("tr"),r=(0,b.h)("tbody"),a=(0,b.h)("table",{"aria-label":"Jacobian of the tip"},(0,b.h)("thead",{},s),r),l=D(e,t,{side:[(0,b.h)("div.scroll",{},a)],words:({arm:h})=>{let d=(0,y.joints)(h)[o],i=h.rows[d].kind==="revolute"?"turns about its axis":"slides";return`Column ${o+1}: the tip moves along the arrow when joint ${d+1} ${i} alone.`}}),{store:n,picture:c}=l,f=c&&new pt.Arrow(c.force.shaft.material),m=h=>()=>{o=h,n.dispatch({type:"show",lit:(0,y.joints)(n.state.arm)[h]}),l.refresh()},u=(0,y.joints)(n.state.arm).map((h,d)=>(0,b.h)("button",{type:"button","aria-pressed":"false",onpointerenter:m(d),onfocus:m(d),onclick:m(d)},(0,b.indexed)("J",h+1)));s.replaceChildren((0,b.h)("th"),...u.map(h=>(0,b.h)("th",{},h)));let w=["vx","vy","vz","ωx","ωy","ωz"].map(h=>[h,u.map(()=>(0,b.h)("td"))]);return r.replaceChildren(...w.map(([h,d])=>(0,b.h)("tr",{},(0,b.h)("th",{},(0,b.indexed)(h[0],h[1])),d))),l.follow((h,d)=>{if(w.forEach(([,v],T)=>v.forEach((z,L)=>{(0,b.write)(z,(0,q.sparse)(d.columns[L][T],2)),z.classList.toggle("on",L===o)})),u.forEach((v,T)=>v.setAttribute("aria-pressed",String(T===o))),!f||!c.world)return;f.parent!==c.world&&c.world.add(f);let i=(0,y.scaled)(.3,d.columns[o].slice(0,3));f.point(d.frames.at(-1).o,i,.008*c.size)}),m(t.column?t.column-1:0)(),l.dispose}function se(e,t){return D(e,t,{state:{view:"jacobian"},words:(s,r)=>`Half axes ${r.linear.values.map(l=>(0,q.fixed)(l,2)).join(", ")}. ${(0,dt.rankVerdict)(r).text}`}).dispose}function ie(e,t){let o=(0,b.h)("div.bars"),s=D(e,t,{state:{view:t.push?"torque":"pose",wrench:t.wrench??[0,0,0,0,0,0]},side:[o],words:(a,{torque:l})=>{let n=l.reduce((f,m,u)=>Math.abs(m)>Math.abs(l[f])?u:f,0),c=`joint ${(0,y.joints)(a.arm)[n]+1}: ${(0,q.fixed)(l[n],1)} N m`;return`${t.words??"Move the arm."} The most is asked of ${c}.`}}),r=(0,y.joints)(s.store.state.arm).map(a=>{let[l,n]=[(0,b.h)("span.fill"),(0,b.h)("span")];return{fill:l,value:n,root:(0,b.h)("div.bar",{},(0,b.h)("span",{},(0,b.indexed)("τ",a+1)),(0,b.h)("span.track",{},l),n)}});return o.replaceChildren(...r.map(a=>a.root)),s.follow((a,{torque:l})=>{let n=Math.max(...(0,y.joints)(a.arm).map(c=>a.arm.rows[c].effort??50));r.forEach(({fill:c,value:f},m)=>{let u=Math.max(-1,Math.min(1,l[m]/n));Object.assign(c.style,{left:`${50+50*Math.min(0,u)}%`,width:`${50*Math.abs(u)}%`}),(0,b.write)(f,`${(0,q.fixed)(l[m],1)} N m`)})}),s.dispose}function le(e,t){let o=new AbortController,s=D(e,t,{words:u=>`The tip stays; ${(0,y.joints)(u.arm).map((h,d)=>`q${h+1} ${(0,q.jointText)(u.arm.rows[h],u.q[d],"deg")}`).join(", ")}.`}),{store:r}=s,a=r.derived.frames.at(-1);r.dispatch({type:"show",hold:{pinned:a,turns:!0,free:1}});let l=Be(r.state.arm,r.state.q,a),n=l.findIndex(u=>u===r.state.q),c=u=>{let w=l[Math.max(0,Math.min(l.length-1,Math.round(u)))];r.dispatch({type:"move",q:w,hold:r.state.hold,gesture:"swing"})},f=u=>lt(l[Math.round(u)]?.[2]-l[n][2]),m=Z("elbow",[0,l.length-1],n,{put:c,text:f,signal:o.signal});return s.card.querySelector(".side").prepend(m.root),()=>(o.abort(),s.dispose())}function Be(e,t,o){let s=(0,y.joints)(e).map(a=>[e.rows[a].lower??-1/0,e.rows[a].upper??1/0]),r=a=>{let l=[],[n,c]=[t,null];for(let f=0;f<80;f++){let m=We(e,n),[u]=(0,te.rightNull)(m);if(!u)break;let w=c?u.reduce((i,v,T)=>i+v*c[T],0):a*u[2],h=u.map(i=>w<0?-i:i),d=(0,ee.reach)(e,n.map((i,v)=>i+.03*h[v]),o).q;if(d.some((i,v)=>i<s[v][0]||i>s[v][1]))break;l.push(d),[n,c]=[d,h]}return l};return[...r(-1).reverse(),t,...r(1)]}function We(e,t){let o=(0,y.linkFrames)(e,t),s=o.at(-1).o;return(0,y.joints)(e).map(r=>{let{z:a,o:l}=o[r],n=(0,y.minus)(s,l);return[...[a[1]*n[2]-a[2]*n[1],a[2]*n[0]-a[0]*n[2],a[0]*n[1]-a[1]*n[0]],...a]})}function pe(e,t){let o=new AbortController,[s,r,a,l]=[null,0,t.radius??.1,0],n=D(e,t,{hold:!1,state:{view:"trace",lit:t.lit?t.lit-1:null},words:({arm:i})=>{if(!s)return"Computing …";let v=`Radius ${(0,q.fixed)(100*a,1)} cm`;if(s.largest>1e-4)return`${v}: no run gets round; the arm would have to pass a singular pose.`;let T=(0,y.joints)(i).flatMap((z,L)=>Math.abs(s.wound[L])>.9?[`joint ${z+1}`]:[]);return`${v}: ${T.length?`${(0,q.listed)(T)} wind once round`:"the joints swing and come back"}.`}}),{store:c}=n,f=c.state.q,m=()=>{let{path:i}=s,v=Math.round(r*(i.length-1));c.dispatch({type:"set",trace:i,q:i[v]})},u=async()=>{let i=++l,{arm:v}=c.state,T=await(0,xt.ask)("run",{arm:v,q:f,run:{method:"exact",steps:180,radius:a}});i!==l||o.signal.aborted||(s=T,m(),n.refresh())},w={signal:o.signal},h=Z("round",[0,1],0,{...w,put:i=>(r=i,s&&m()),text:i=>`${(0,q.fixed)(100*i,0)} %`}),d=Z("radius",[.01,.1],a,{...w,put:i=>(a=i,u()),text:i=>`${(0,q.fixed)(100*i,1)} cm`});return n.card.querySelector(".side").prepend(...t.fixed?[h.root]:[d.root,h.root]),u(),()=>(o.abort(),n.dispose())}function de(e,t){let o=(0,b.h)("div.row",{role:"radiogroup","aria-label":"Ways"}),s=D(e,t,{state:{view:"branches"},side:[o],words:({arm:l,ways:n})=>n?(0,dt.waysVerdict)(l,n):"Computing …"}),{store:r}=s,a=!1;return(0,xt.ask)("ways",{arm:r.state.arm,q:r.state.q}).then(l=>{a||(r.dispatch({type:"ways",arm:r.state.arm,ways:l}),o.replaceChildren(...l.list.map(({q:n},c)=>(0,b.h)("button",{type:"button",role:"radio","aria-label":`Way ${c+1}`,style:`border-left: 6px solid ${(0,gt.branchColour)(c)}`,onclick:()=>r.dispatch({type:"glide",q:n})},String(c+1)))),s.refresh())}),s.follow(({q:l,ways:n})=>{[...o.children].forEach((c,f)=>{let m=n?.list[f]?.q.every((u,w)=>Math.abs(u-l[w])<.001);c.setAttribute("aria-checked",String(!!m))})}),()=>(a=!0,s.dispose())}function ce(e,t){let o=D(e,{arm:"Elbow arm",...t},{words:({arm:a,q:l},{frames:n})=>{let[c,f]=[n[1].o,n.at(-1).o],m=(0,y.norm)((0,y.minus)(f,c)),[u,w]=[a.rows[1].a,a.rows[2].a],h=(m*m-u*u-w*w)/(2*u*w);return`${`Shoulder to tip ${(0,q.fixed)(1e3*m,0)} mm`}, so D = ${(0,q.fixed)(h,3)} and θ₃ = ${lt(l[2])}; its cosine is D.`}}),{picture:s}=o,r=[];return o.follow((a,{frames:l})=>{if(!s?.world)return;for(let d of r)d.traverse(i=>{i.material?.dispose(),i.geometry?.dispose()}),d.removeFromParent();let[n,c,f]=l.slice(1).map(d=>d.o),m=[f[0],f[1],n[2]],u=(d,i)=>[d,(0,y.plus)((0,y.scaled)(.5,d),(0,y.scaled)(.5,i)),i],w=.003*s.size;r=[[n,f,0],[n,m,2],[m,f,2],[n,c,1],[c,f,1]].filter(([d,i])=>(0,y.norm)((0,y.minus)(d,i))>.001).map(([d,i,v])=>(0,pt.tube)(u(d,i),w,(0,gt.branchColour)(v))),r.forEach(d=>s.world.add(d))}),o.dispose}var E=$(ot(),1),ze=$(H(),1),Ae=$(he(),1),kt=$(rt(),1),R=$(ut(),1),tt=$(at(),1),P=$(H(),1);var p=$(H(),1),bt=1e-6,me=e=>(0,p.scaled)(1/(0,p.norm)(e),e),fe=(e,t,o)=>Math.atan2((0,p.dot)(e,(0,p.cross)(t,o)),(0,p.dot)(t,o)),Je=(e,t)=>e.every(o=>(0,p.norm)((0,p.minus)(t,o))>1e-4);function xe(e){let t=(0,p.joints)(e).map((r,a)=>e.rows[r].kind==="prismatic"?Math.max(.3,e.home[a]||0):0),o=(0,p.linkFrames)(e,t),s=(0,p.joints)(e).map(r=>({z:o[r].z,o:o[r].o,row:r}));return{q:t,frames:o,axes:s,base:o[0],end:o.at(-1)}}function we(e,t,o,s){let r=(0,p.minus)(o,e),a=(0,p.cross)(t,s),l=(0,p.dot)(a,a);return l<bt?[e,(0,p.plus)(o,(0,p.scaled)(-(0,p.dot)(s,r),s))]:[(0,p.plus)(e,(0,p.scaled)((0,p.dot)((0,p.cross)(r,s),a)/l,t)),(0,p.plus)(o,(0,p.scaled)((0,p.dot)((0,p.cross)(r,t),a)/l,s))]}function vt(e,t){let o=t.length,s=t[o-1],r=o===e.axes.length,a=r?{z:s.z,o:e.end.o}:e.axes[o],[,l]=we(s.o,s.z,a.o,a.z),n=e.axes[o+1],c=[],f=r?[e.end.o]:[l,a.o,...n?[we(a.o,a.z,n.o,n.z)[0]]:[]];for(let m of f)Je(c,m)&&c.push(m);if(!r)for(let m of[...c])c.length<3&&c.push((0,p.plus)(m,(0,p.scaled)(.12,a.z)));return{zs:[a.z,(0,p.scaled)(-1,a.z)],points:c.slice(0,4),axis:a}}function ge(e,t,o){let s=(0,p.cross)(e.z,t);(0,p.norm)(s)<bt&&(s=(0,p.minus)((0,p.minus)(o,e.o),(0,p.scaled)((0,p.dot)((0,p.minus)(o,e.o),e.z),e.z))),(0,p.norm)(s)<bt&&(s=e.x),s=me(s);let r=me((0,p.cross)(t,s));return[s,(0,p.scaled)(-1,s),r,(0,p.scaled)(-1,r)]}function be(e,{x:t,z:o,o:s},r){if(Math.abs((0,p.dot)(t,o))>1e-4)return`x_${r} is not at a right angle to z_${r}.`;if(Math.abs((0,p.dot)(t,e.z))>1e-4)return`x_${r} is not at a right angle to z_${r-1}: no α about x_${r} can then turn z_${r-1} into z_${r}.`;let a=(0,p.minus)(s,e.o),l=(0,p.minus)((0,p.minus)(a,(0,p.scaled)((0,p.dot)(a,e.z),e.z)),(0,p.scaled)((0,p.dot)(a,t),t));return(0,p.norm)(l)>1e-4?`The line of x_${r} does not meet the axis z_${r-1}: no slide a along x_${r} can then bring o_${r} there.`:null}function Ue(e,t,o,s){let r=(0,p.minus)(t.o,e.o),a=(0,p.dot)(r,e.z);return{kind:o,a:(0,p.dot)(r,t.x),alpha:fe(t.x,e.z,t.z),d:o==="prismatic"?a-s:a,theta:fe(e.z,e.x,t.x)}}var ve=(e,t,o)=>({x:t,y:(0,p.cross)(e,t),z:e,o});function yt(e,t,o){return o.slice(1).map((s,r)=>{let{row:a}=t.axes[r],l=Math.sign((0,p.dot)(o[r].z,t.axes[r].z));return Ue(o[r],s,e.rows[a].kind,l*t.q[r])})}function ye(e=Math.random){let t=r=>r[Math.floor(e()*r.length)],o=t([3,4,5]),s=Array.from({length:o},(r,a)=>{let l=a===o-1,n=t(l?[.15,.2]:[0,.2,.3]),c=a===0?.3:t(n?[0,0,.15]:[.2,.25]),f=a>0&&!l&&e()<.2?"prismatic":"revolute",m=t([0,Math.PI/2,-Math.PI/2]);return{kind:f,a:n,alpha:l?0:m,d:c,theta:0,...{lower:null,upper:null,speed:null,effort:null}}});return{name:"An arm of its own",home:s.map(r=>r.kind==="prismatic"?.3:0),rows:s}}var Ve=22,ke="An arm of its own",Ge="A table of this arm; the book chose other directions or zeros, which are free.",Ke={z:e=>`Frame ${e}: which way shall z point along its axis?`,o:e=>`Frame ${e}: where on that axis is its origin?`,x:e=>`Frame ${e}: and which way does x point?`};function je(e,t){let o=["UR10e (homework)","Panda (homework)","Stanford arm","Elbow arm",ke],s=(0,E.h)("select",{"aria-label":"Arm to place frames on",onchange:k=>L(k.target.value)},o.map(k=>(0,E.h)("option",{value:k,selected:k===t.arm},k))),r=(0,E.h)("p.words",{"aria-live":"polite"}),a=(0,E.h)("div.row",{role:"group","aria-label":"Choices"}),l=(0,E.h)("button",{type:"button",onclick:()=>U()},"Back"),n=(0,E.h)("p.why",{hidden:!0,"aria-live":"polite"}),c=(0,E.h)("tbody"),f=["i","a (m)","α (°)","d (m)","θ (°)"].map(k=>(0,E.h)("th",{scope:"col"},k)),m=(0,E.h)("table",{"aria-label":"The table so far"},(0,E.h)("thead",{},(0,E.h)("tr",{},f)),c),u=[(0,E.h)("div.row",{},s,l),r,a,n,(0,E.h)("div.scroll",{},m)],w,h,d,i,v=D(e,{arm:t.arm??o[3]},{hold:!1,side:u,words:()=>""}),{store:T,picture:z}=v;function L(k){w=k===ke?ye():wt(k),h=xe(w),d=[h.base],i={},T.dispatch({type:"select",arm:w,q:h.q});let S=h.axes.flatMap(({z:O,o:C})=>[-1,1].map(g=>(0,P.plus)(C,(0,P.scaled)(g*1.3*x(),O))));z?.figure.fit([...S,h.end.o,(0,P.plus)(h.end.o,[0,0,x()]),[0,0,0]]),J()}let B=()=>i.z?i.o?"x":"o":"z",Y=()=>d.length>h.axes.length;function W(){if(Y())return[];let k=d.at(-1),{zs:S,points:O,axis:C}=vt(h,d);return B()==="z"?S.map(g=>({value:g,at:(0,P.plus)(C.o,(0,P.scaled)(x(),g)),label:$e(g)})):B()==="o"?O.map((g,_)=>({value:g,at:g,label:"ABCD"[_]})):ge(k,i.z,i.o).map(g=>({value:g,at:(0,P.plus)(i.o,(0,P.scaled)(x(),g)),label:$e(g)}))}let x=()=>.16*(z?.size??1);function F({value:k}){if(i={...i,[B()]:k},n.hidden=!0,i.x){let S=ve(i.z,i.x,i.o),O=be(d.at(-1),S,d.length);if(O){let{z:C,o:g}=i;i=/does not meet/.test(O)?{z:C}:{z:C,o:g},(0,E.write)(n,O.replaceAll(/_(\d+)/g,(_,A)=>[...A].map(M=>"₀₁₂₃₄₅₆₇₈₉"[M]).join(""))),n.hidden=!1}else d=[...d,S],i={}}J()}function U(){i.o?i={z:i.z}:i.z?i={}:d.length>1&&(d=d.slice(0,-1)),n.hidden=!0,J()}function J(){let S=W().map(C=>(0,E.h)("button",{type:"button",onclick:()=>F(C)},C.label));a.replaceChildren(...S),(0,E.write)(r,Y()?ct():Ke[B()](d.length)),l.disabled=d.length===1&&!i.z;let O=yt(w,h,d);c.replaceChildren(...O.map((C,g)=>{let _=C.kind==="revolute"?"theta":"d",A=(I,Se)=>(0,E.h)("td",{},Se,...I===_?[" + ",...(0,E.indexed)("q",g+1)]:[]),M=I=>(0,tt.entryText)(I,!0,"deg"),V=I=>A(I,(0,tt.entryText)(C[I],!1,"deg")),Q=I=>A(I,M(C[I])),et=[V("a"),Q("alpha"),V("d"),Q("theta")];return(0,E.h)("tr",{},(0,E.h)("th",{scope:"row"},String(g+1)),et)})),v.refresh()}function ct(){let k={lower:null,upper:null,speed:null,effort:null},S=yt(w,h,d).map(g=>({...k,...g}));return(0,Ae.sameArm)({name:"yours",home:[],rows:S},w)?(0,ze.joints)(w).every((g,_)=>{let A=w.rows[g];return["a","alpha","d","theta"].every(M=>Math.abs(S[_][M]-A[M])<1e-6)})?"A table of this arm, and the book’s own.":Ge:"The table is valid row by row, and yet not this arm: go back and look at the last frame."}let G=null;v.follow(()=>K());function K(){if(!z?.world||!h)return;for(let A of z.triads)A.visible=!1;z.labels.set([]),G&&G.forEach(A=>(A.traverse(M=>M.material?.dispose()),A.removeFromParent()));let{size:k}=z,S=(0,R.paint)((0,kt.branchColour)(7));z.body.visible=!1;let O=new R.ArmShape(w,{link:S,joint:S,ghost:!0,girth:.2});O.pose(h.frames);let C=h.axes.map(({z:A,o:M})=>{let V=(0,R.rod)(S);return(0,R.along)(V,(0,P.plus)(M,(0,P.scaled)(-.2*k,A)),(0,P.plus)(M,(0,P.scaled)(.2*k,A)),.002*k),V}),g=d.map(A=>{let M=new R.Triad(z.dark);return M.pose(A,.1*k),M}),_=W().map(({at:A,value:M})=>{let V=(0,R.paint)((0,kt.branchColour)(1)),Q=B()==="o"?null:B()==="z"?vt(h,d).axis.o:i.o;if(!Q){let I=(0,R.ball)(V);return I.position.fromArray(A),I.scale.setScalar(.014*k),I}let et=new R.Arrow(V);return et.point(Q,(0,P.scaled)(x(),M),.005*k),et});G=[O,...C,...g,..._],G.forEach(A=>z.world.add(A)),z.labels.set(W().map(({at:A,label:M})=>({tip:A,letter:M,index:"",tone:"y"})))}return z?.figure.listen(z.figure.canvas,"click",k=>{let[S,O]=z.figure.place(k),g=W().map(_=>{let[A,M]=z.figure.pixel(_.at);return{one:_,gap:Math.hypot(A-S,M-O)}}).sort((_,A)=>_.gap-A.gap)[0];g&&g.gap<Ve&&F(g.one)}),L(t.arm??o[3]),v.dispose}function $e(e){let t=e.findIndex(o=>Math.abs(Math.abs(o)-1)<1e-6);return t<0?`(${e.map(o=>(0,tt.fixed)(o,2)).join(", ")})`:t===2?e[2]>0?"up":"down":`${e[t]>0?"+":"−"}${"xy"[t]}`}var qe=$(Me(),1),He={columns:ne,ellipsoid:se,hand:oe,loads:ie,matrix:ae,row:re,swing:le,trainer:je,triangles:ce,ways:de,winds:pe};for(let[e,t]of Object.entries(He))(0,qe.registerFigure)(e,t);})();
