(()=>{var Oo=Object.create;var Wt=Object.defineProperty;var To=Object.getOwnPropertyDescriptor;var No=Object.getOwnPropertyNames;var _o=Object.getPrototypeOf,Ro=Object.prototype.hasOwnProperty;var W=(t,e)=>()=>{try{return e||t((e={exports:{}}).exports,e),e.exports}catch(o){throw e=0,o}},Fo=(t,e)=>{for(var o in e)Wt(t,o,{get:e[o],enumerable:!0})},Po=(t,e,o,n)=>{if(e&&typeof e=="object"||typeof e=="function")for(let r of No(e))!Ro.call(t,r)&&r!==o&&Wt(t,r,{get:()=>e[r],enumerable:!(n=To(e,r))||n.enumerable});return t};var b=(t,e,o)=>(o=t!=null?Oo(_o(t)):{},Po(e||!t||!t.__esModule?Wt(o,"default",{value:t,enumerable:!0}):o,t));var wt=W((br,se)=>{se.exports=ArmExplorer.kit["dom.js"]});var pt=W((xr,ie)=>{ie.exports=ArmExplorer.kit["kinematics.js"]});var Bt=W((vr,le)=>{le.exports=ArmExplorer.kit["renderer.js"]});var At=W((kr,ce)=>{ce.exports=ArmExplorer.kit["shapes.js"]});var gt=W((yr,pe)=>{pe.exports=ArmExplorer.kit["text.js"]});var Jt=W((zr,fe)=>{fe.exports=ArmExplorer.kit["arm.js"]});var ge=W((Ar,we)=>{we.exports=ArmExplorer.kit["grab.js"]});var xe=W((jr,be)=>{be.exports=ArmExplorer.kit["rail.js"]});var yt=W((Er,ve)=>{ve.exports=ArmExplorer.kit["scene.js"]});var ye=W((qr,ke)=>{ke.exports=ArmExplorer.kit["state.js"]});var Me=W((Sr,$e)=>{$e.exports=ArmExplorer.kit["still.js"]});var Ae=W((Cr,ze)=>{ze.exports=ArmExplorer.kit["theme.js"]});var Ut=W((Or,je)=>{je.exports=ArmExplorer.kit["verdicts.js"]});var Xt=W((Lr,_e)=>{_e.exports=ArmExplorer.kit["jobs.js"]});var Fe=W((Dr,Re)=>{Re.exports=ArmExplorer.kit["linear.js"]});var Ie=W((Wr,Pe)=>{Pe.exports=ArmExplorer.kit["motion.js"]});var Ze=W((Ur,Qe)=>{Qe.exports=ArmExplorer.kit["same.js"]});var wo=W((Xr,fo)=>{fo.exports=ArmExplorer.kit["figures.js"]});var bo=W((Yr,go)=>{go.exports=ArmExplorer.kit["runs.js"]});var vo=W((Qr,xo)=>{xo.exports=ArmExplorer.kit["views/plots.js"]});var yo=W((Zr,ko)=>{ko.exports=ArmExplorer.kit["views/transport.js"]});var bt=b(wt(),1),nt=b(pt(),1),Te=b(Bt(),1),V=b(At(),1);var T=b(pt(),1),kt=b(gt(),1),Io=.5,Lo=.15,jt=(t,e)=>[t[1]*e[2]-t[2]*e[1],t[2]*e[0]-t[0]*e[2],t[0]*e[1]-t[1]*e[0]];function Do(t,e){let o=(0,T.norm)(t);if(o<1e-9)return e;let n=jt(t,e),[r,a]=[Math.sin(o)/o,(1-Math.cos(o))/o**2];return(0,T.plus)(e,(0,T.plus)((0,T.scaled)(r,n),(0,T.scaled)(a,jt(t,n))))}function Wo(t,e){let o=(0,T.norm)(t);if(o<1e-9)return e;let n=jt(t,e),[r,a]=[(1-Math.cos(o))/o**2,(o-Math.sin(o))/o**3];return(0,T.plus)(e,(0,T.plus)((0,T.scaled)(r,n),(0,T.scaled)(a,jt(t,n))))}function Bo({x:t,y:e,z:o,o:n},r,a){let[i,s]=[(0,T.scaled)(a,r.slice(0,3)),(0,T.scaled)(a,r.slice(3))],[c,h,u]=[t,e,o].map(w=>Do(s,w));return{x:c,y:h,z:u,o:(0,T.plus)(n,Wo(s,i))}}function Et(t,e,{k:o,twist:n},r){let a=t.rows[(0,T.joints)(t)[o]],i=r*(a.kind==="prismatic"?Lo:Io),s=e.map((h,u)=>u===o?h+i:h),c=(0,T.linkFrames)(t,e).at(-1);return{by:i,row:a,q:s,tip:c,truly:(0,T.linkFrames)(t,s).at(-1),claimed:Bo(c,n,i)}}var ue=["x","y","z"];function de(t){let e=t.reduce((o,n,r)=>Math.abs(n)>Math.abs(t[o])?r:o,0);return`${(0,kt.fixed)(1e3*(0,T.norm)(t),0)} mm, mostly along ${t[e]<0?"−":"+"}${ue[e]}`}function Jo(t,e){let o=ue.reduce((n,r)=>n+t[r].reduce((a,i,s)=>a+i*e[r][s],0),0);return 180/Math.PI*Math.acos(Math.min(1,Math.max(-1,(o-1)/2)))}function me({by:t,row:e,tip:o,truly:n,claimed:r},a){let[i,s]=[r,n].map(({o:d})=>(0,T.minus)(d,o.o)),c=e.kind==="prismatic"?`Joint ${a} slid by ${(0,kt.fixed)(1e3*t,0)} mm`:`Joint ${a} turned by ${(0,kt.fixed)(180/Math.PI*t,0)}°`,h=d=>(0,T.norm)(d)<.001,u=(0,T.norm)((0,T.minus)(i,s))<.001?"your column takes the tip where the arm takes it":`your column ${h(i)?"leaves the tip where it is":`takes the tip ${de(i)}`}; the arm ${h(s)?"leaves it there":`takes it ${de(s)}`}`,w=Jo(r,n),l=w>.5?` The tool would end turned by ${(0,kt.fixed)(w,0)}° from where it does.`:"";return`${c}: ${u}.${l}`}var he=`:host {
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
`;var qt=b(Jt(),1),O=b(wt(),1),St=b(ge(),1),Ee=b(pt(),1),Vt=b(xe(),1),qe=b(yt(),1),Ct=b(ye(),1),$t=b(Me(),1),Ot=b(gt(),1),Se=b(Ae(),1),Ce=b(Ut(),1);var Kt=[{name:"Panda",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.0825,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.054982,.066502,.039252]},{kind:"revolute",a:-.0825,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.029330000000000002,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"Panda (homework)",home:[0,0,0,1.5707963267948966,0,3.141592653589793,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.333,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[4.970684,.003875,-.04762,-.002081]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:-1.7628,upper:1.7628,speed:2.175,effort:87,body:[.646926,-.003141,.003495,.02872]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:.316,theta:0,lower:-2.8973,upper:2.8973,speed:2.175,effort:87,body:[3.228604,-.060481999999999994,.066502,.039252]},{kind:"revolute",a:-.088,alpha:1.5707963267948966,d:0,theta:0,lower:.0698,upper:3.0718,speed:2.175,effort:87,body:[3.587895,.03482999999999999,-.027454,.104419]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.384,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[1.225946,-.011953,-.038437,-.041065]},{kind:"revolute",a:.088,alpha:-1.5707963267948966,d:0,theta:0,lower:-.0175,upper:3.7525,speed:2.61,effort:12,body:[1.666555,-.027850999999999994,.010517,-.014117]},{kind:"revolute",a:0,alpha:0,d:-.20700000000000002,theta:0,lower:-2.8973,upper:2.8973,speed:2.61,effort:12,body:[.735522,.010517,.004252,.145403]}]},{name:"UR10e",home:[0,-1.5707963267948966,0,-1.5707963267948966,0,0],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1807,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[7.369,.021,0,.027]},{kind:"revolute",a:-.6127,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330,body:[13.051,.38,0,.158]},{kind:"revolute",a:-.57155,alpha:0,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150,body:[3.989,.24,0,.068]},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.17415,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[2.1,0,.007,.018]},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.11985,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[1.98,0,.007,.018]},{kind:"revolute",a:0,alpha:0,d:.21655000000000002,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56,body:[.615,0,0,-.126]}]},{name:"UR10e (homework)",home:[0,0,0,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.128,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.6127,alpha:3.141592653589793,d:0,theta:-1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:2.0943951023931953,effort:330},{kind:"revolute",a:.5716,alpha:3.141592653589793,d:0,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:150},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.1639,theta:1.5707963267948966,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:.1157,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56},{kind:"revolute",a:0,alpha:0,d:.1922,theta:0,lower:-6.283185307179586,upper:6.283185307179586,speed:3.141592653589793,effort:56}]},{name:"Stanford arm",home:[0,0,.5,0,0,0],rows:[{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:.154,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"prismatic",a:0,alpha:0,d:0,theta:0,lower:.1,upper:1,speed:null,effort:null},{kind:"revolute",a:0,alpha:-1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:1.5707963267948966,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:0,alpha:0,d:.263,theta:0,lower:null,upper:null,speed:null,effort:null}]},{name:"Elbow arm",home:[0,.7853981633974483,-1.5707963267948966],rows:[{kind:"revolute",a:0,alpha:1.5707963267948966,d:.5,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.4,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null},{kind:"revolute",a:.3,alpha:0,d:0,theta:0,lower:null,upper:null,speed:null,effort:null}]}];var Gt=t=>Kt.find(e=>e.name===t)??Kt[0],Vo=0;function Q(t,e,{state:o={},hold:n=!0,words:r,side:a=[]}){let i=new AbortController,{signal:s}=i,c=typeof e.arm=="object"?e.arm:Gt(e.arm),h=new Ct.Store((0,Ct.startingState)({arm:c,q:e.q??(0,qt.homeOf)(c),...o})),u=t.shadowRoot??t.attachShadow({mode:"open"}),w=(0,O.h)("div.labels",{"aria-hidden":"true"}),l=(0,O.h)("button.grip",{type:"button","aria-label":"Tip: drag it, or move it by arrow keys",hidden:!n,onkeydown:M=>k&&(0,St.moveTipByKey)(k,h,M)}),d=(0,O.h)("div.stage",{role:"group","aria-label":`The ${c.name}`},w,l),p=(0,O.h)("p.words"),m=(0,O.h)("p.why",{hidden:!0}),v=(e.joints??[]).map(M=>J(M)),y=(0,O.h)("figure.live",{},d,(0,O.h)("div.side",{},...a,...v.map(M=>M.root),p,m));u.replaceChildren((0,O.h)("style",{},he),y,(0,O.h)("div.paper",{},(0,O.h)("slot")));let k=null;try{k=new qe.ArmPicture(d,w,{onPlace:([M,G])=>l.style.transform=`translate(${M}px, ${G}px)`}),n&&(0,St.makeGrabbable)(k,h,{grip:l,goTo:M=>h.dispatch({type:"glide",q:M})})}catch{l.hidden=!0}function J(M){let G=(0,Ee.joints)(c).indexOf(M-1),it=c.rows[M-1],[et,mt]=(0,qt.range)(it),lt=($,D=null)=>{h.dispatch({type:"move",q:h.state.q.map((_,K)=>K===G?$:_),gesture:D})},at=(0,O.h)("input",{type:"range",min:et,max:mt,step:"any","aria-label":`Joint ${M}`,oninput:$=>lt(Number($.target.value),`keys ${M}`)}),E=(0,O.h)("div.rail",{},at),R=null;(0,Vt.relativeRail)(E,at,{start:()=>R=`lever ${++Vo}`,put:$=>lt($,R),signal:s});let P=(0,O.h)("output"),N=({q:$,unit:D})=>{at.value=String($[G]),at.setAttribute("aria-valuetext",(0,Ot.spokenJoint)(it,$[G],D)),(0,O.write)(P,(0,Ot.jointText)(it,$[G],D))};return{root:(0,O.h)("div.lever",{},(0,O.h)("span",{},(0,O.indexed)("q",M)),E,P),show:N}}let L="light",U=[];function S(){let{state:M,derived:G}=h;for(let et of v)et.show(M);(0,O.write)(p,r(M,G));let it=(0,Ce.holdVerdict)(M.hold);(0,O.write)(m,it),m.hidden=!it,k?k.draw(M,G,L):d.replaceChildren((0,$t.stillSvg)(M.arm,G.frames,(0,$t.poseText)(M.arm,M.q)));for(let et of U)et(M,G);d.setAttribute("aria-label",(0,$t.poseText)(M.arm,M.q))}return(0,Se.watchTheme)(M=>{L=M,y.dataset.theme=M,S()},s),h.listen(S,s),{store:h,picture:k,card:y,signal:s,refresh:S,follow:M=>(U.push(M),S()),dispose(){i.abort(),k?.dispose(),u.replaceChildren()}}}function ut(t,[e,o],n,{put:r,text:a,signal:i}){let s=(0,O.h)("input",{type:"range",min:e,max:o,step:"any",value:n,"aria-label":t}),c=(0,O.h)("output",{},a(n)),h=w=>{s.value=String(w),s.setAttribute("aria-valuetext",a(w)),(0,O.write)(c,a(w)),r(w)};s.addEventListener("input",()=>h(Number(s.value)),{signal:i});let u=(0,O.h)("div.rail",{},s);return(0,Vt.relativeRail)(u,s,{put:h,signal:i}),{root:(0,O.h)("div.lever",{},(0,O.h)("span",{},t),u,c),move:h}}var Oe=24,Go=[0,0,0,0,0,0],Ho=1600;function Ne(t){let e=new AbortController,o=t.answer,[n,r,a]=[null,0,0],i=ut("how far",[-1,1],0,{put:y=>(cancelAnimationFrame(a),p(y)),text:y=>`${Math.round(100*y)} %`,signal:e.signal}),s=(0,bt.h)("div.row",{role:"group","aria-label":"See a column at work"}),c=(0,bt.h)("div",{},s,i.root),h=Q(t,{arm:o.arm,q:o.q},{hold:!1,side:[c],words:()=>n&&r?me(Et(o.arm,o.q,n,r),d(n)):o.words}),{store:u,picture:w}=h,l=w&&new Ht(w),d=({k:y})=>(0,nt.joints)(o.arm)[y]+1;function p(y){r=y,u.dispatch({type:"set",q:n?Et(o.arm,o.q,n,r).q:o.q}),h.refresh()}function m(y){cancelAnimationFrame(a),n=y;let k=performance.now(),J=L=>{let U=(0,bt.calm)()?1:Math.max(0,Math.min(1,(L-k)/Ho));i.move((1-Math.cos(Math.PI*U))/2),U<1&&(a=requestAnimationFrame(J))};J(k)}function v(){cancelAnimationFrame(a);let{arm:y,q:k,wrench:J=Go,claims:L}=o;n=L[0]??null,y!==u.state.arm&&u.dispatch({type:"select",arm:y,q:k}),u.dispatch({type:"set",wrench:J,view:J.some(Boolean)?"torque":"pose"}),c.hidden=!n,s.replaceChildren(...L.map(U=>{let S=y.rows[(0,nt.joints)(y)[U.k]].kind==="prismatic"?"Slide":"Turn";return(0,bt.h)("button",{type:"button",onclick:()=>m(U)},`${S} joint ${d(U)}`)})),i.move(0)}return h.follow(()=>l?.draw(o,n,r)),t.addEventListener("answer",()=>(o=t.answer,v()),{signal:e.signal}),v(),()=>(cancelAnimationFrame(a),e.abort(),h.dispose())}var Ht=class{constructor(e){this.picture=e,this.drawn=[],this.made=[]}draw(e,o,n){let{picture:r}=this;if(!r.world)return;r.body.tint(i=>e.axes.includes(i)||e.links.includes(i)?r.tints.bad:null);let a=[e,o,n,r.world];if(!a.every((i,s)=>i===this.drawn[s])){this.drawn=a,this.made.forEach(Te.freed),this.made=this.pieces(e,o,n);for(let i of this.made)r.world.add(i);r.figure.request()}}pieces(e,o,n){let{picture:r}=this,[a,i]=[r.look.bad,r.look.ghost],s=r.frames,c=e.axes.map(h=>this.line(Xo(s[h],.3*r.size),.004,a));c.push(...e.links.map(h=>this.line(Yo(s,h),.02,a)));for(let{arm:h,q:u}of e.ghosts){let w=(0,V.ghostMaterial)(a,.4),l=new V.ArmShape(h,{link:w,joint:w,ghost:!0});l.pose((0,nt.linkFrames)(h,u)),c.push(l)}return e.path&&c.push((0,V.tube)(e.path,.003*r.size,a)),o&&n?[...c,...this.claim(e,o,n,a,i)]:c}claim({arm:e,q:o},n,r,a,i){let{picture:s}=this,c=Array.from({length:Oe+1},(l,d)=>Et(e,o,n,r*d/Oe)),h=new V.Triads(s.dark,1);h.pose([c.at(-1).claimed],.1*s.size);let u=(0,V.ball)((0,V.paint)(a));u.scale.setScalar(.016*s.size),u.position.fromArray(c.at(-1).claimed.o);let w=.005*s.size;return[h,u,(0,V.tube)(c.map(({claimed:l})=>l.o),w,a),(0,V.tube)(c.map(({truly:l})=>l.o),w,i)]}line({start:e,end:o},n,r){let a=(0,V.rod)((0,V.paint)(r));return(0,V.along)(a,e,o,n*this.picture.size),a}},Xo=({o:t,z:e},o)=>({start:(0,nt.minus)(t,(0,nt.scaled)(o,e)),end:(0,nt.plus)(t,(0,nt.scaled)(o,e))}),Yo=(t,e)=>({start:t[e].o,end:t[e+1].o});var j=b(wt(),1),Yt=b(Xt(),1),q=b(pt(),1),Le=b(Fe(),1),De=b(Ie(),1),Qt=b(yt(),1),Nt=b(At(),1),B=b(gt(),1),_t=b(Ut(),1);var Qo="only the entries with its angle move; the last column goes round on a circle of radius a.",Zo=t=>t.map(e=>(0,B.fixed)(1e3*e,0)).join(", "),Tt=t=>`${(0,B.fixed)(t*180/Math.PI,0)}°`;function We(t,e){let o=(n,{frames:r})=>`${e.words??"Drag a link, or the tip."} The tip is at (${Zo(r.at(-1).o)}) mm.`;return Q(t,e,{state:{frames:e.frames??"ends"},words:o}).dispose}function Be(t,e){let o=["turn by θ about z","slide by d along z","slide by a along x","turn by α about x"],n=new AbortController,r=4,a=Q(t,e,{hold:!1,state:{frames:"all"},words:({arm:u})=>{let{theta:w,d:l,a:d,alpha:p}=u.rows[0],m=[Tt(w),`${(0,B.fixed)(1e3*l,0)} mm`,`${(0,B.fixed)(1e3*d,0)} mm`,Tt(p)],v=o.slice(0,Math.ceil(r)).map((y,k)=>`${y} (${m[k]})`);return v.length?`${v.join(", then ")}.`:"The frame before the row."}}),s=a.store.state.arm.rows[(e.row??1)-1],h=ut("motions",[0,4],4,{put:u=>{r=u;let w=v=>Math.min(1,Math.max(0,u-v)),l=s.theta+(s.kind==="revolute"?e.angle??.7:0),d=s.d+(s.kind==="prismatic"?e.slide??.3:0),p={kind:"fixed",theta:w(0)*l,d:w(1)*d,a:w(2)*s.a,alpha:w(3)*s.alpha},m={name:`Row ${e.row??1}`,home:[],rows:[p]};a.store.dispatch({type:"select",arm:m,q:[]})},text:u=>`${(0,B.fixed)(u,1)} of 4`,signal:n.signal});return a.card.querySelector(".side").prepend(h.root),h.move(4),a.picture?.fit(),()=>(n.abort(),a.dispose())}function Je(t,e){let o=e.row??1,n=Array.from({length:4},()=>Array.from({length:4},()=>(0,j.h)("td"))),r=(0,j.h)("table",{"aria-label":`A ${o}`},n.map(s=>(0,j.h)("tr",{},s))),a=(0,j.h)("span",{},(0,j.indexed)("A",o)," ="),i=Q(t,{...e,joints:[o]},{state:{frames:"all"},side:[(0,j.h)("div.row",{},a,(0,j.h)("div.scroll",{},r))],words:()=>e.words??`Turn joint ${o}: ${Qo}`});return i.follow(s=>{let c=(0,q.linkFrames)({rows:[s.arm.rows[o-1]]},[s.q[(0,q.joints)(s.arm).indexOf(o-1)]]);(0,q.matrix)(c[1]).forEach((h,u)=>h.forEach((w,l)=>(0,j.write)(n[u][l],u===3?String(w):(0,B.sparse)(w,3))))}),i.dispose}function Ue(t,e){let o=0,n=(0,j.h)("tr"),r=(0,j.h)("tbody"),a=(0,j.h)("table",{"aria-label":"Jacobian of the tip"},(0,j.h)("thead",{},n),r),i=Q(t,e,{side:[(0,j.h)("div.scroll",{},a)],words:({arm:d})=>{let p=(0,q.joints)(d)[o],m=d.rows[p].kind==="revolute"?"turns about its axis":"slides";return`Column ${o+1}: the tip moves along the arrow when joint ${p+1} ${m} alone.`}}),{store:s,picture:c}=i,h=c&&new Nt.Arrow(c.force.shaft.material),u=d=>()=>{o=d,s.dispatch({type:"show",lit:(0,q.joints)(s.state.arm)[d]}),i.refresh()},w=(0,q.joints)(s.state.arm).map((d,p)=>(0,j.h)("button",{type:"button","aria-pressed":"false",onpointerenter:u(p),onfocus:u(p),onclick:u(p)},(0,j.indexed)("J",d+1)));n.replaceChildren((0,j.h)("th"),...w.map(d=>(0,j.h)("th",{},d)));let l=["vx","vy","vz","ωx","ωy","ωz"].map(d=>[d,w.map(()=>(0,j.h)("td"))]);return r.replaceChildren(...l.map(([d,p])=>(0,j.h)("tr",{},(0,j.h)("th",{},(0,j.indexed)(d[0],d[1])),p))),i.follow((d,p)=>{if(l.forEach(([,v],y)=>v.forEach((k,J)=>{(0,j.write)(k,(0,B.sparse)(p.columns[J][y],2)),k.classList.toggle("on",J===o)})),w.forEach((v,y)=>v.setAttribute("aria-pressed",String(y===o))),!h||!c.world)return;h.parent!==c.world&&c.world.add(h);let m=(0,q.scaled)(.3,p.columns[o].slice(0,3));h.point(p.frames.at(-1).o,m,.008*c.size)}),u(e.column?e.column-1:0)(),i.dispose}function Ke(t,e){return Q(t,e,{state:{view:"jacobian"},words:(n,r)=>`Half axes ${r.linear.values.map(i=>(0,B.fixed)(i,2)).join(", ")}. ${(0,_t.rankVerdict)(r).text}`}).dispose}function Ve(t,e){let o=(0,j.h)("div.bars"),n=Q(t,e,{state:{view:e.push?"torque":"pose",wrench:e.wrench??[0,0,0,0,0,0]},side:[o],words:(a,{torque:i})=>{let s=i.reduce((h,u,w)=>Math.abs(u)>Math.abs(i[h])?w:h,0),c=`joint ${(0,q.joints)(a.arm)[s]+1}: ${(0,B.fixed)(i[s],1)} N m`;return`${e.words??"Move the arm."} The most is asked of ${c}.`}}),r=(0,q.joints)(n.store.state.arm).map(a=>{let[i,s]=[(0,j.h)("span.fill"),(0,j.h)("span")];return{fill:i,value:s,root:(0,j.h)("div.bar",{},(0,j.h)("span",{},(0,j.indexed)("τ",a+1)),(0,j.h)("span.track",{},i),s)}});return o.replaceChildren(...r.map(a=>a.root)),n.follow((a,{torque:i})=>{let s=Math.max(...(0,q.joints)(a.arm).map(c=>a.arm.rows[c].effort??50));r.forEach(({fill:c,value:h},u)=>{let w=Math.max(-1,Math.min(1,i[u]/s));Object.assign(c.style,{left:`${50+50*Math.min(0,w)}%`,width:`${50*Math.abs(w)}%`}),(0,j.write)(h,`${(0,B.fixed)(i[u],1)} N m`)})}),n.dispose}function Ge(t,e){let o=new AbortController,n=Q(t,e,{words:w=>`The tip stays; ${(0,q.joints)(w.arm).map((d,p)=>`q${d+1} ${(0,B.jointText)(w.arm.rows[d],w.q[p],"deg")}`).join(", ")}.`}),{store:r}=n,a=r.derived.frames.at(-1);r.dispatch({type:"show",hold:{pinned:a,turns:!0,free:1}});let i=tr(r.state.arm,r.state.q,a),s=i.findIndex(w=>w===r.state.q),c=w=>{let l=i[Math.max(0,Math.min(i.length-1,Math.round(w)))];r.dispatch({type:"move",q:l,hold:r.state.hold,gesture:"swing"})},h=w=>Tt(i[Math.round(w)]?.[2]-i[s][2]),u=ut("elbow",[0,i.length-1],s,{put:c,text:h,signal:o.signal});return n.card.querySelector(".side").prepend(u.root),()=>(o.abort(),n.dispose())}function tr(t,e,o){let n=(0,q.joints)(t).map(a=>[t.rows[a].lower??-1/0,t.rows[a].upper??1/0]),r=a=>{let i=[],[s,c]=[e,null];for(let h=0;h<80;h++){let u=er(t,s),[w]=(0,Le.rightNull)(u);if(!w)break;let l=c?w.reduce((m,v,y)=>m+v*c[y],0):a*w[2],d=w.map(m=>l<0?-m:m),p=(0,De.reach)(t,s.map((m,v)=>m+.03*d[v]),o).q;if(p.some((m,v)=>m<n[v][0]||m>n[v][1]))break;i.push(p),[s,c]=[p,d]}return i};return[...r(-1).reverse(),e,...r(1)]}function er(t,e){let o=(0,q.linkFrames)(t,e),n=o.at(-1).o;return(0,q.joints)(t).map(r=>{let{z:a,o:i}=o[r],s=(0,q.minus)(n,i);return[...[a[1]*s[2]-a[2]*s[1],a[2]*s[0]-a[0]*s[2],a[0]*s[1]-a[1]*s[0]],...a]})}function He(t,e){let o=new AbortController,[n,r,a,i]=[null,0,e.radius??.1,0],s=Q(t,e,{hold:!1,state:{view:"trace",lit:e.lit?e.lit-1:null},words:({arm:m})=>{if(!n)return"Computing …";let v=`Radius ${(0,B.fixed)(100*a,1)} cm`;if(n.largest>1e-4)return`${v}: no run gets round; the arm would have to pass a singular pose.`;let y=(0,q.joints)(m).flatMap((k,J)=>Math.abs(n.wound[J])>.9?[`joint ${k+1}`]:[]);return`${v}: ${y.length?`${(0,B.listed)(y)} wind once round`:"the joints swing and come back"}.`}}),{store:c}=s,h=c.state.q,u=()=>{let{path:m}=n,v=Math.round(r*(m.length-1));c.dispatch({type:"set",trace:m,q:m[v]})},w=async()=>{let m=++i,{arm:v}=c.state,y=await(0,Yt.ask)("run",{arm:v,q:h,run:{method:"exact",steps:180,radius:a}});m!==i||o.signal.aborted||(n=y,u(),s.refresh())},l={signal:o.signal},d=ut("round",[0,1],0,{...l,put:m=>(r=m,n&&u()),text:m=>`${(0,B.fixed)(100*m,0)} %`}),p=ut("radius",[.01,.1],a,{...l,put:m=>(a=m,w()),text:m=>`${(0,B.fixed)(100*m,1)} cm`});return s.card.querySelector(".side").prepend(...e.fixed?[d.root]:[p.root,d.root]),w(),()=>(o.abort(),s.dispose())}function Xe(t,e){let o=(0,j.h)("div.row",{role:"radiogroup","aria-label":"Ways"}),n=Q(t,e,{state:{view:"branches"},side:[o],words:({arm:i,ways:s})=>s?(0,_t.waysVerdict)(i,s):"Computing …"}),{store:r}=n,a=!1;return(0,Yt.ask)("ways",{arm:r.state.arm,q:r.state.q}).then(i=>{a||(r.dispatch({type:"ways",arm:r.state.arm,ways:i}),o.replaceChildren(...i.list.map(({q:s},c)=>(0,j.h)("button",{type:"button",role:"radio","aria-label":`Way ${c+1}`,style:`border-left: 6px solid ${(0,Qt.branchColour)(c)}`,onclick:()=>r.dispatch({type:"glide",q:s})},String(c+1)))),n.refresh())}),n.follow(({q:i,ways:s})=>{[...o.children].forEach((c,h)=>{let u=s?.list[h]?.q.every((w,l)=>Math.abs(w-i[l])<.001);c.setAttribute("aria-checked",String(!!u))})}),()=>(a=!0,n.dispose())}function Ye(t,e){let o=Q(t,{arm:"Elbow arm",...e},{words:({arm:a,q:i},{frames:s})=>{let[c,h]=[s[1].o,s.at(-1).o],u=(0,q.norm)((0,q.minus)(h,c)),[w,l]=[a.rows[1].a,a.rows[2].a],d=(u*u-w*w-l*l)/(2*w*l);return`${`Shoulder to tip ${(0,B.fixed)(1e3*u,0)} mm`}, so D = ${(0,B.fixed)(d,3)} and θ₃ = ${Tt(i[2])}; its cosine is D.`}}),{picture:n}=o,r=[];return o.follow((a,{frames:i})=>{if(!n?.world)return;for(let p of r)p.traverse(m=>{m.material?.dispose(),m.geometry?.dispose()}),p.removeFromParent();let[s,c,h]=i.slice(1).map(p=>p.o),u=[h[0],h[1],s[2]],w=(p,m)=>[p,(0,q.plus)((0,q.scaled)(.5,p),(0,q.scaled)(.5,m)),m],l=.003*n.size;r=[[s,h,0],[s,u,2],[u,h,2],[s,c,1],[c,h,1]].filter(([p,m])=>(0,q.norm)((0,q.minus)(p,m))>.001).map(([p,m,v])=>(0,Nt.tube)(w(p,m),l,(0,Qt.branchColour)(v))),r.forEach(p=>n.world.add(p))}),o.dispose}var F=b(wt(),1),po=b(pt(),1),uo=b(Ze(),1),oe=b(yt(),1),mo=b(Bt(),1),Z=b(At(),1),Mt=b(gt(),1),ot=b(pt(),1);var g=b(pt(),1),Zt=1e-6,to=t=>(0,g.scaled)(1/(0,g.norm)(t),t),eo=(t,e,o)=>Math.atan2((0,g.dot)(t,(0,g.cross)(e,o)),(0,g.dot)(e,o)),or=(t,e)=>t.every(o=>(0,g.norm)((0,g.minus)(e,o))>1e-4);function ro(t){let e=(0,g.joints)(t).map((r,a)=>t.rows[r].kind==="prismatic"?Math.max(.3,t.home[a]||0):0),o=(0,g.linkFrames)(t,e),n=(0,g.joints)(t).map(r=>({z:o[r].z,o:o[r].o,row:r}));return{q:e,frames:o,axes:n,base:o[0],end:o.at(-1)}}function oo(t,e,o,n){let r=(0,g.minus)(o,t),a=(0,g.cross)(e,n),i=(0,g.dot)(a,a);return i<Zt?[t,(0,g.plus)(o,(0,g.scaled)(-(0,g.dot)(n,r),n))]:[(0,g.plus)(t,(0,g.scaled)((0,g.dot)((0,g.cross)(r,n),a)/i,e)),(0,g.plus)(o,(0,g.scaled)((0,g.dot)((0,g.cross)(r,e),a)/i,n))]}function te(t,e){let o=e.length,n=e[o-1],r=o===t.axes.length,a=r?{z:n.z,o:t.end.o}:t.axes[o],[,i]=oo(n.o,n.z,a.o,a.z),s=t.axes[o+1],c=[],h=r?[t.end.o]:[i,a.o,...s?[oo(a.o,a.z,s.o,s.z)[0]]:[]];for(let u of h)or(c,u)&&c.push(u);if(!r)for(let u of[...c])c.length<3&&c.push((0,g.plus)(u,(0,g.scaled)(.12,a.z)));return{zs:[a.z,(0,g.scaled)(-1,a.z)],points:c.slice(0,4),axis:a}}function no(t,e,o){let n=(0,g.cross)(t.z,e);(0,g.norm)(n)<Zt&&(n=(0,g.minus)((0,g.minus)(o,t.o),(0,g.scaled)((0,g.dot)((0,g.minus)(o,t.o),t.z),t.z))),(0,g.norm)(n)<Zt&&(n=t.x),n=to(n);let r=to((0,g.cross)(e,n));return[n,(0,g.scaled)(-1,n),r,(0,g.scaled)(-1,r)]}function ao(t,{x:e,z:o,o:n},r){if(Math.abs((0,g.dot)(e,o))>1e-4)return`x_${r} is not at a right angle to z_${r}.`;if(Math.abs((0,g.dot)(e,t.z))>1e-4)return`x_${r} is not at a right angle to z_${r-1}: no α about x_${r} can then turn z_${r-1} into z_${r}.`;let a=(0,g.minus)(n,t.o),i=(0,g.minus)((0,g.minus)(a,(0,g.scaled)((0,g.dot)(a,t.z),t.z)),(0,g.scaled)((0,g.dot)(a,e),e));return(0,g.norm)(i)>1e-4?`The line of x_${r} does not meet the axis z_${r-1}: no slide a along x_${r} can then bring o_${r} there.`:null}function rr(t,e,o,n){let r=(0,g.minus)(e.o,t.o),a=(0,g.dot)(r,t.z);return{kind:o,a:(0,g.dot)(r,e.x),alpha:eo(e.x,t.z,e.z),d:o==="prismatic"?a-n:a,theta:eo(t.z,t.x,e.x)}}var so=(t,e,o)=>({x:e,y:(0,g.cross)(t,e),z:t,o});function ee(t,e,o){return o.slice(1).map((n,r)=>{let{row:a}=e.axes[r],i=Math.sign((0,g.dot)(o[r].z,e.axes[r].z));return rr(o[r],n,t.rows[a].kind,i*e.q[r])})}function io(t=Math.random){let e=r=>r[Math.floor(t()*r.length)],o=e([3,4,5]),n=Array.from({length:o},(r,a)=>{let i=a===o-1,s=e(i?[.15,.2]:[0,.2,.3]),c=a===0?.3:e(s?[0,0,.15]:[.2,.25]),h=a>0&&!i&&t()<.2?"prismatic":"revolute",u=e([0,Math.PI/2,-Math.PI/2]);return{kind:h,a:s,alpha:i?0:u,d:c,theta:0,...{lower:null,upper:null,speed:null,effort:null}}});return{name:"An arm of its own",home:n.map(r=>r.kind==="prismatic"?.3:0),rows:n}}var nr=22,lo="An arm of its own",ar="A table of this arm; the book chose other directions or zeros, which are free.",sr={z:t=>`Frame ${t}: which way shall z point along its axis?`,o:t=>`Frame ${t}: where on that axis is its origin?`,x:t=>`Frame ${t}: and which way does x point?`};function ho(t,e){let o=["UR10e (homework)","Panda (homework)","Stanford arm","Elbow arm",lo],n=(0,F.h)("select",{"aria-label":"Arm to place frames on",onchange:E=>J(E.target.value)},o.map(E=>(0,F.h)("option",{value:E,selected:E===e.arm},E))),r=(0,F.h)("p.words",{"aria-live":"polite"}),a=(0,F.h)("div.row",{role:"group","aria-label":"Choices"}),i=(0,F.h)("button",{type:"button",onclick:()=>it()},"Back"),s=(0,F.h)("p.why",{hidden:!0,"aria-live":"polite"}),c=(0,F.h)("tbody"),h=["i","a (m)","α (°)","d (m)","θ (°)"].map(E=>(0,F.h)("th",{scope:"col"},E)),u=(0,F.h)("table",{"aria-label":"The table so far"},(0,F.h)("thead",{},(0,F.h)("tr",{},h)),c),w=[(0,F.h)("div.row",{},n,i),r,a,s,(0,F.h)("div.scroll",{},u)],l,d,p,m,v=Q(t,{arm:e.arm??o[3]},{hold:!1,side:w,words:()=>""}),{store:y,picture:k}=v;function J(E){l=E===lo?io():Gt(E),d=ro(l),p=[d.base],m={},y.dispatch({type:"select",arm:l,q:d.q});let R=d.axes.flatMap(({z:P,o:N})=>[-1,1].map($=>(0,ot.plus)(N,(0,ot.scaled)($*1.3*M(),P))));k?.figure.fit([...R,d.end.o,(0,ot.plus)(d.end.o,[0,0,M()]),[0,0,0]]),et()}let L=()=>m.z?m.o?"x":"o":"z",U=()=>p.length>d.axes.length;function S(){if(U())return[];let E=p.at(-1),{zs:R,points:P,axis:N}=te(d,p);return L()==="z"?R.map($=>({value:$,at:(0,ot.plus)(N.o,(0,ot.scaled)(M(),$)),label:co($)})):L()==="o"?P.map(($,D)=>({value:$,at:$,label:"ABCD"[D]})):no(E,m.z,m.o).map($=>({value:$,at:(0,ot.plus)(m.o,(0,ot.scaled)(M(),$)),label:co($)}))}let M=()=>.16*(k?.size??1);function G({value:E}){if(m={...m,[L()]:E},s.hidden=!0,m.x){let R=so(m.z,m.x,m.o),P=ao(p.at(-1),R,p.length);if(P){let{z:N,o:$}=m;m=/does not meet/.test(P)?{z:N}:{z:N,o:$},(0,F.write)(s,P.replaceAll(/_(\d+)/g,(D,_)=>[..._].map(K=>"₀₁₂₃₄₅₆₇₈₉"[K]).join(""))),s.hidden=!1}else p=[...p,R],m={}}et()}function it(){m.o?m={z:m.z}:m.z?m={}:p.length>1&&(p=p.slice(0,-1)),s.hidden=!0,et()}function et(){let R=S().map(N=>(0,F.h)("button",{type:"button",onclick:()=>G(N)},N.label));a.replaceChildren(...R),(0,F.write)(r,U()?mt():sr[L()](p.length)),i.disabled=p.length===1&&!m.z;let P=ee(l,d,p);c.replaceChildren(...P.map((N,$)=>{let D=N.kind==="revolute"?"theta":"d",_=(A,H)=>(0,F.h)("td",{},H,...A===D?[" + ",...(0,F.indexed)("q",$+1)]:[]),K=A=>(0,Mt.entryText)(A,!0,"deg"),f=A=>_(A,(0,Mt.entryText)(N[A],!1,"deg")),z=A=>_(A,K(N[A])),C=[f("a"),z("alpha"),f("d"),z("theta")];return(0,F.h)("tr",{},(0,F.h)("th",{scope:"row"},String($+1)),C)})),v.refresh()}function mt(){let E={lower:null,upper:null,speed:null,effort:null},R=ee(l,d,p).map($=>({...E,...$}));return(0,uo.sameArm)({name:"yours",home:[],rows:R},l)?(0,po.joints)(l).every(($,D)=>{let _=l.rows[$];return["a","alpha","d","theta"].every(K=>Math.abs(R[D][K]-_[K])<1e-6)})?"A table of this arm, and the book’s own.":ar:"The table is valid row by row, and yet not this arm: go back and look at the last frame."}let lt=[];v.follow(()=>at());function at(){if(!k?.world||!d)return;k.triads.visible=!1,k.labels.set([]),lt.forEach(mo.freed);let{size:E}=k,R=(0,Z.paint)((0,oe.branchColour)(7));k.body.visible=!1;let P=new Z.ArmShape(l,{link:R,joint:R,ghost:!0,girth:.2});P.pose(d.frames);let N=d.axes.map(({z:_,o:K})=>{let f=(0,Z.rod)(R);return(0,Z.along)(f,(0,ot.plus)(K,(0,ot.scaled)(-.2*E,_)),(0,ot.plus)(K,(0,ot.scaled)(.2*E,_)),.002*E),f}),$=new Z.Triads(k.dark,p.length);$.pose(p,.1*E);let D=S().map(({at:_,value:K})=>{let f=(0,Z.paint)((0,oe.branchColour)(1)),z=L()==="o"?null:L()==="z"?te(d,p).axis.o:m.o;if(!z){let A=(0,Z.ball)(f);return A.position.fromArray(_),A.scale.setScalar(.014*E),A}let C=new Z.Arrow(f);return C.point(z,(0,ot.scaled)(M(),K),.005*E),C});lt=[P,...N,$,...D],lt.forEach(_=>k.world.add(_)),k.labels.set(S().map(({at:_,label:K})=>({tip:_,letter:K,index:"",tone:"y"})))}return k?.figure.listen(k.figure.canvas,"click",E=>{let[R,P]=k.figure.place(E),$=S().map(D=>{let[_,K]=k.figure.pixel(D.at);return{one:D,gap:Math.hypot(_-R,K-P)}}).sort((D,_)=>D.gap-_.gap)[0];$&&$.gap<nr&&G($.one)}),J(e.arm??o[3]),v.dispose}function co(t){let e=t.findIndex(o=>Math.abs(Math.abs(o)-1)<1e-6);return e<0?`(${t.map(o=>(0,Mt.fixed)(o,2)).join(", ")})`:e===2?t[2]>0?"up":"down":`${t[e]>0?"+":"−"}${"xy"[e]}`}var Lt=b(wo(),1);var ne={};Fo(ne,{build:()=>pr});var $o=b(Jt(),1),x=b(wt(),1),It=b(Xt(),1),ct=b(pt(),1),rt=b(bo(),1),Rt=b(yt(),1),tt=b(gt(),1),Mo=b(vo(),1),zo=b(yo(),1),Ft={euler:"Euler",rk4:"Runge-Kutta 4",exact:"exact inverse kinematics",inverse:"J⁻¹",pseudo:"pseudo-inverse",damped:"damped"},Ao={"":"none",angular:"z_i in the angular rows",z_i:"z_i and o_i throughout",o_i:"o_i instead of o_i−1",sign:"rates with the wrong sign",next:"velocity of the next step"},ir={"":"none",wrench:"wrong sign of F",centres:"centres of mass not converted"},zt=260,re=[260,120],lr=8,cr="Over the circle’s radius: whole turns of a joint (bars; red where no run gets round), and the smallest σ (line). Click to choose one.";function pr(t,{say:e,signal:o}){let[n,r,a]=[0,30,""],i={},s=new Map,c=t.state.q,h=(0,x.h)("div.runs",{role:"radiogroup","aria-label":"Runs"}),u=(0,x.h)("p.verdict"),w=(0,x.svg)("svg",{viewBox:`0 0 ${zt} ${zt}`,role:"img","aria-label":"The wall with the runs on it"}),l=(0,x.svg)("svg",{viewBox:`0 0 ${re[0]} ${re[1]}`,role:"img"}),d=(0,Mo.makePlots)(),p=(0,zo.makeTransport)(t,{signal:o,begin:()=>P()}),m=Pt("What the plots show",{joint:"joint values",torque:"static torques"},()=>N()),v=Pt("Mistake in the torques",ir,f=>(a=f,N())),y=fr(f=>mt(f)),k=(f,z)=>(0,x.h)("button",{type:"button",onclick:z},f),J=(0,x.h)("input",{type:"range",min:0,max:3,step:"any",value:Math.log10(r),"aria-label":"Magnify the errors",oninput:f=>(r=10**Number(f.target.value),D())}),L=(0,x.h)("output"),U=k("Add a run",()=>{let{runs:f}=t.state;n=f.length,et([...f,{...f.at(-1),method:f.at(-1).method==="euler"?"rk4":"euler"}])}),S=k("Remove it",()=>{let f=t.state.runs.filter((z,C)=>C!==n);n=Math.max(0,n-1),et(f)}),M=k("Start where the arm stands",()=>(c=t.state.q,s.clear(),E())),G=(0,x.h)("div.homework",{},(0,x.h)("div.row",{},h,U,S,M),y.root,u,p.root,(0,x.h)("div.walls",{},(0,x.h)("figure",{},w,(0,x.h)("figcaption",{},(0,x.h)("label",{},"Errors magnified ",J,L))),(0,x.h)("figure",{},l,(0,x.h)("figcaption",{},cr))),(0,x.h)("div.row",{},(0,x.h)("label",{},"Plots ",m),(0,x.h)("label",{},"Mistake in the torques ",v)),d.root),it=(0,It.latest)("winding");l.addEventListener("click",f=>{let z=l.getBoundingClientRect(),C=Math.min(1,Math.max(0,(f.clientX-z.left)/z.width));mt({radius:Number((.01+.09*C).toFixed(3))})});let et=f=>t.dispatch({type:"show",runs:f}),mt=f=>et(t.state.runs.map((z,C)=>C===n?{...z,...f}:z)),lt=f=>JSON.stringify([t.state.arm.rows,c,f]),at=f=>s.get(lt(f));async function E(){let{arm:f,runs:z}=t.state,C=z.filter(I=>!s.has(lt(I)));for(let I of C){let st=lt(I);s.set(st,null);let X=await(0,It.ask)("run",{arm:f,q:c,run:I});if(s.set(st,X),o.aborted||t.state.arm!==f)return;z===t.state.runs&&P()}P();let A=z[n];if(!A||i.winding===R(A))return;i.winding=R(A);let H={arm:f,q:c,run:{normal:A.normal,locked:A.locked}};it(H,I=>(i.curve=I,_()))}let R=f=>JSON.stringify([t.state.arm.rows,c,f.normal,f.locked]);function P(){let{runs:f,arm:z,circle:C}=t.state,A=f.map(at),H=A.flatMap((st,X)=>st?[{points:st.path.map(dt=>(0,ct.linkFrames)(z,dt).at(-1).o),colour:(0,Rt.branchColour)(X)}]:[]);t.dispatch({type:"show",paths:H});let I=A[n];I&&I.path.length>1&&t.state.trace!==I.path?t.dispatch({type:"traced",arm:z,circle:C,path:I.path,stray:0,wanted:null}):I&&I.path.length<2&&t.dispatch({type:"show",trace:null}),N(),e(()=>u.textContent)}function N(){let{runs:f,arm:z,wrench:C,trace:A}=t.state;h.replaceChildren(...f.map((I,st)=>$(I,st))),y.update(f[n],z),(0,x.write)(u,f[n]?mr(f[n],at(f[n]),z):""),S.disabled=f.length<2,U.disabled=f.length>=lr;let H=m.value==="torque";v.options[2].disabled=!(0,rt.isPanda)(z),A?d.lay(t.state,H?(0,rt.torquesAlong)(z,A,C,a):A,H):d.clear(),d.mark(t.state.at),D(),_()}function $(f,z){let C=at(f),A=C?C.failed===null?` ${jo(C.largest)}`:" no inverse":" …",H={type:"button",role:"radio","aria-checked":String(z===n),onclick:()=>(n=z,E())},I=(0,x.h)("span.swatch",{style:`background:${(0,Rt.branchColour)(z)}`,"aria-hidden":"true"});return(0,x.h)("button",H,I,(0,x.h)("span",{},`${ur(f)}:${A}`))}function D(){let{runs:f,arm:z}=t.state;(0,x.write)(L,`× ${(0,tt.fixed)(r,r<10?1:0)}`);let C=(0,ct.linkFrames)(z,c).at(-1).o,A=Math.max(...f.map(X=>X.radius),.01),H=zt/(2.6*A),I=(X,dt)=>{let Y=(0,ct.minus)(dt,C);return[zt/2+H*(X.normal==="x"?Y[1]:-Y[0]),.13*zt-H*Y[2]]},st=f.flatMap((X,dt)=>{let Y=at(X),ht=ft=>(0,rt.onCircle)(C,X,ft).o,Dt=(0,rt.radiiTo)(1,73).map((ft,vt)=>I(X,ht(vt/72))),xt=(0,x.svg)("polyline",{points:Dt.join(" "),class:"asked"});if(!Y)return[xt];let Eo=Y.path.map((ft,vt)=>{let[qo,So]=[(0,ct.linkFrames)(z,ft).at(-1).o,ht(Y.at[vt])];return I(X,So.map((ae,Co)=>ae+r*(qo[Co]-ae)))});return[xt,(0,x.svg)("polyline",{points:Eo.map(ft=>ft.map(vt=>vt.toFixed(1))).join(" "),stroke:(0,Rt.branchColour)(dt)})]});w.replaceChildren(...st)}function _(){let f=i.curve;if(!f?.length)return l.replaceChildren();let[z,C]=re,A=Y=>z*(Y-.01)/.09,H=Math.max(...f.map(({least:Y})=>Y),1e-6),I=f.map(({radius:Y,least:ht})=>`${A(Y).toFixed(1)},${(C-8-(C-16)*ht/H).toFixed(1)}`),st=f.map(({radius:Y,turns:ht,reached:Dt})=>{let xt=Math.min(3,Math.abs(ht))*18;return(0,x.svg)("rect",{x:A(Y)-3,y:C-4-xt,width:6,height:xt+4,class:Dt?"turns":"broken"})}),X=t.state.runs[n]?.radius??.1,dt=(0,x.svg)("line",{x1:A(X),x2:A(X),y1:0,y2:C,class:"cursor"});l.replaceChildren(...st,(0,x.svg)("polyline",{points:I.join(" "),class:"least"}),dt),(0,x.attribute)(l,"aria-label",hr(f))}function K(f){if(i.arm!==f.arm){let z=!i.arm;if(c=f.q,n=0,s.clear(),i={arm:f.arm},!f.runs.length||!z)return et([dr(f.arm)])}i.runs!==f.runs?(i.runs=f.runs,n=Math.min(n,f.runs.length-1),N(),E()):(i.unit!==f.unit||i.wrench!==f.wrench)&&N(),Object.assign(i,{unit:f.unit,wrench:f.wrench}),d.mark(f.at),p.update(f)}return{root:G,update:K,summary:()=>u.textContent}}function Pt(t,e,o){let n=Object.entries(e).map(([r,a])=>(0,x.h)("option",{value:r},a));return(0,x.h)("select",{"aria-label":t,onchange:r=>o(r.target.value)},n)}var dr=t=>(0,ct.joints)(t).length===7?{...rt.HOMEWORK}:{...rt.HOMEWORK,locked:-1,normal:/UR10e/.test(t.name)?"y":"x",seconds:/UR10e/.test(t.name)?20:5,rates:"pseudo"};function jo(t){return t<1e-12?"under 1e−9 mm":`${t<1e-5?(1e3*t).toExponential(1).replace("-","−"):(0,tt.fixed)(1e3*t,t<.001?3:1)} mm`}var ur=({method:t,rates:e,steps:o,gain:n,slip:r})=>(t==="exact"?Ft.exact:`${Ft[t]}, ${Ft[e]}, N = ${o}`)+(n?`, gain ${(0,tt.fixed)(n,1)}`:"")+(r?`, ${Ao[r]}`:"");function mr(t,e,o){if(!e)return"Computing …";if(e.failed!==null)return e.failed===0?"The Jacobian has no inverse where the run starts: the pose is singular. Choose the pseudo-inverse or damped rates.":`The run breaks at step ${e.failed} of ${t.steps}: no inverse there.`;let n=l=>(0,ct.joints)(o).flatMap((d,p)=>l(d,p)?[`joint ${d+1}`]:[]),r=n((l,d)=>Math.abs(e.wound[d])>.9),a=n((l,d)=>e.path.some(p=>(0,$o.outside)(o.rows[l],p[d]))),i=r.length?` Once round: ${(0,tt.listed)(r)}.`:"",s=a.length?` Past its limits: ${(0,tt.listed)(a)}.`:"",c=e.least<1e-4?e.least.toExponential(1).replace("-","−"):(0,tt.fixed)(e.least,4),h=`Largest error ${jo(e.largest)}`,u=e.run.method==="exact"?"":`, fastest joint ${(0,tt.fixed)(e.fastest,2)} rad/s`,w=e.tilt>.001?`, the tool tilts by ${(0,tt.fixed)(e.tilt*180/Math.PI,1)}°`:"";return`${h}${w}${u}. Smallest σ on the way: ${c}.${i}${s}`}function hr(t){let e=t.filter(({reached:a})=>!a),o=t.filter(({turns:a,reached:i})=>i&&a),n=a=>`${(0,tt.fixed)(100*a.radius,1)} cm`,r=[];return o.length&&r.push(`a joint winds once round from ${n(o[0])} on`),e.length&&r.push(`no run from ${n(e[0])} to ${n(e.at(-1))}`),`Radius from 1 to 10 cm: ${r.join("; ")||"the joints only swing"}.`}function fr(t){let e=(l,d)=>[l,Pt(l,Object.fromEntries(d.map(p=>[p,Ft[p]])),p=>t({[l==="Method"?"method":"rates"]:p}))],[o,n]=[e("Method",["euler","rk4","exact"]),e("Rates",["inverse","pseudo","damped"])],r=["Mistake",Pt("Mistake",Ao,l=>t({slip:l}))],a=[u("steps","N",!0,l=>String(l),Math.round),u("seconds","T",!1,l=>`${(0,tt.fixed)(l,0)} s`,Math.round),u("radius","Radius",!1,l=>`${(0,tt.fixed)(100*l,1)} cm`,l=>Number(l.toFixed(3))),u("gain","Feedback",!1,l=>`${(0,tt.fixed)(l,1)} /s`,l=>Number(l.toFixed(1))),u("cutoff","Cut-off",!0,l=>l.toExponential(0).replace("-","−"),l=>Number(l.toPrecision(1))),u("damping","Damping",!0,l=>(0,tt.fixed)(l,3),l=>Number(l.toPrecision(2)))],i=(0,x.h)("input",{type:"checkbox",onchange:l=>t({locked:l.target.checked?2:-1})}),s=(0,x.h)("label.check",{},i," joint 3 locked"),c=[o,n,r].map(([l,d])=>(0,x.h)("label",{},`${l} `,d)),h=(0,x.h)("div.levers",{},c,s,a.map(({root:l})=>l));function u(l,d,p,m,v){let[y,k]=rt.BOUNDS[l].map(S=>p?Math.log10(S):S),J=S=>v(p?10**Number(S.value):Number(S.value)),L=(0,x.h)("input",{type:"range",min:y,max:k,step:"any","aria-label":d,oninput:S=>(0,x.write)(U,m(J(S.target))),onchange:S=>t({[l]:J(S.target)})}),U=(0,x.h)("output");return{key:l,root:(0,x.h)("label.lever",{},`${d} `,L,U),show:S=>{L.value=String(p?Math.log10(S):S),L.setAttribute("aria-valuetext",m(S)),(0,x.write)(U,m(S))}}}function w(l,d){if(l){o[1].value=l.method,n[1].value=l.rates,r[1].value=l.slip,i.checked=l.locked===2,s.hidden=(0,ct.joints)(d).length<7;for(let{key:p,root:m,show:v}of a){v(l[p]);let y=l.method==="exact"&&!["radius","steps","seconds"].includes(p);m.hidden=y||p==="cutoff"&&l.rates!=="pseudo"||p==="damping"&&l.rates!=="damped"}c[1].hidden=l.method==="exact",c[2].hidden=l.method==="exact"}}return{root:h,update:w}}var wr={answer:Ne,columns:Ue,ellipsoid:Ke,hand:We,loads:Ve,matrix:Je,row:Be,swing:Ge,trainer:ho,triangles:Ye,ways:Xe,winds:He};for(let[t,e]of Object.entries(wr))(0,Lt.registerFigure)(t,e);(0,Lt.registerView)("homework",ne);})();
