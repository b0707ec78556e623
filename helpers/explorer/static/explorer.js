var ArmExplorer=(()=>{var sh=Object.defineProperty;var kx=Object.getOwnPropertyDescriptor;var Bx=Object.getOwnPropertyNames;var zx=Object.prototype.hasOwnProperty;var Di=(n,t)=>{for(var e in t)sh(n,e,{get:t[e],enumerable:!0})},Gx=(n,t,e,i)=>{if(t&&typeof t=="object"||typeof t=="function")for(let s of Bx(t))!zx.call(n,s)&&s!==e&&sh(n,s,{get:()=>t[s],enumerable:!(i=kx(t,s))||i.enumerable});return n};var Vx=n=>Gx(sh({},"__esModule",{value:!0}),n);var JC={};Di(JC,{figureWidget:()=>YC,inUse:()=>Mg,loseContext:()=>wg,mount:()=>GC,widget:()=>qC});var he=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Ut=(n,t)=>[n*t[0],n*t[1],n*t[2]],Yt=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],Rt=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],Me=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Xt=n=>Math.sqrt(n.reduce((t,e)=>t+e*e,0)),Es=(n,t,e,i)=>[n*t[0]+e*i[0],n*t[1]+e*i[1],n*t[2]+e*i[2]];function rh(n){let t=n/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(n),Math.sin(n)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var dt=n=>n.rows.flatMap((t,e)=>t.kind==="fixed"?[]:[e]);var af=n=>dt(n).map(t=>n.rows[t].kind==="revolute");function Ot(n,t){let[e,i,s,r]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],o=[{x:e,y:i,z:s,o:r}],a=0;for(let l of n.rows){let c=l.kind==="fixed"?0:t[a++],[h,u]=rh(l.kind==="revolute"?l.theta+c:l.theta),[d,p]=rh(l.alpha),f=l.kind==="prismatic"?l.d+c:l.d;[e,i]=[Es(h,e,u,i),Es(h,i,-u,e)],r=Yt(Es(f,s,l.a,e),r),[i,s]=[Es(d,i,p,s),Es(d,s,-p,i)],o.push({x:e,y:i,z:s,o:r})}return o}var lf=({x:n,y:t,z:e,o:i})=>[0,1,2].map(s=>[n[s],t[s],e[s],i[s]]).concat([[0,0,0,1]]);function We(n,t,e=t.at(-1).o){return dt(n).map(i=>{let{z:s,o:r}=t[i];return n.rows[i].kind==="revolute"?[...Me(s,Rt(e,r)),...s]:[...s,0,0,0]})}function Xo(n,t,e=9.81){let i=hf(n,t);return dt(n).map(s=>{let{z:r,o}=t[s],a=l=>n.rows[s].kind==="revolute"?Me(r,Rt(l,o))[2]:r[2];return i.reduce((l,{mass:c,centre:h,row:u})=>l+(u<s?0:c*e*a(h)),0)})}var cf=(n,t,e=9.81)=>hf(n,t).reduce((i,{mass:s,centre:r})=>i+s*e*r[2],0),hf=(n,t)=>n.rows.flatMap((e,i)=>e.body?[Hx(e.body,t[i+1],i)]:[]);function Hx([n,...t],{x:e,y:i,z:s,o:r},o){return{mass:n,row:o,centre:Yt(r,Yt(Es(t[0],e,t[1],i),Ut(t[2],s)))}}var qo=(n,t)=>n.map(e=>e.reduce((i,s,r)=>i+s*t[r],0));var oh=["revolute","prismatic","fixed"],jo=16,Yo=100,uf=1e3,ah="Your arm",df=[["a",Yo],["alpha",uf],["d",Yo],["theta",uf]];function As(n){if(!Array.isArray(n)||!n.length)return"the table has no rows";if(n.length>jo)return`the table has ${n.length} rows; ${jo} are the most`;for(let[t,e]of n.entries()){if(!oh.includes(e?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[i,s]of df){if(!Number.isFinite(e[i]))return`row ${t+1} has no number for ${i}`;if(Math.abs(e[i])>s)return`row ${t+1} has ${e[i]} for ${i}; ${s} is the most`}}return null}var Wx=({kind:n,a:t,alpha:e,d:i,theta:s})=>({kind:n,a:t,alpha:e,d:i,theta:s,lower:null,upper:null,speed:null,effort:null}),lh=(n,t)=>n.kind===t.kind&&df.every(([e])=>Math.abs(n[e]-t[e])<1e-12);function Jo(n,t){if(n.length===t.rows.length&&n.every((i,s)=>lh(i,t.rows[s])))return t;let e={name:ah,home:[],rows:n.map(Wx)};return{...e,home:ch(t,t.home,e,i=>i)}}function ch(n,t,e,i){let s=new Map(dt(n).map((r,o)=>[r,[n.rows[r].kind,t[o]??0]]));return dt(e).map(r=>{let[o,a]=s.get(i(r))??[];return o===e.rows[r].kind?a:0})}var Oi=n=>an(n,n.home)?[...n.home]:dt(n).map(()=>0),an=(n,t)=>Array.isArray(t)&&t.length===dt(n).length&&t.every(Number.isFinite);function Rn(n){let t=n.kind==="revolute"?Math.PI:1;return[n.lower??-t,n.upper??t]}var Qn=(n,t)=>t<(n.lower??-1/0)-1e-9||t>(n.upper??1/0)+1e-9,ff=n=>dt(n).some(t=>n.rows[t].lower!==null||n.rows[t].upper!==null),Rs=n=>n.rows.reduce((t,e)=>t+Math.abs(e.a)+Math.abs(e.d)+(e.kind==="prismatic"?Math.abs(e.upper??.3):0),0)||.3;function C(n,t={},...e){let[i,...s]=n.split("."),r=document.createElement(i);i==="button"&&(r.type="button"),s.length&&(r.className=s.join(" "));for(let[o,a]of Object.entries(t))o.startsWith("on")?r.addEventListener(o.slice(2),a):a!==void 0&&a!==!1&&r.setAttribute(o,a===!0?"":a);return r.append(...e.flat()),r}function mn(n,t={},...e){let i=document.createElementNS("http://www.w3.org/2000/svg",n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}var Gn=(n,[t,e],i={})=>C("input",{type:"range",min:t,max:e,step:"any","aria-label":n,...i});function Pt(n,t){n.textContent!==t&&(n.textContent=t)}function oe(n,t,e){n.getAttribute(t)!==e&&n.setAttribute(t,e)}var Se=(n,t)=>[C("i",{},n),C("sub",{},String(t))];async function Zo(n){try{return await navigator.clipboard.writeText(n),!0}catch{return!1}}var Cs=(n,t)=>C("div.scroll",{tabindex:0,role:"region","aria-label":n},t),Ko=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;function Fi(n,t,e){let i=Object.entries(t).map(([s,r])=>C("option",{value:s},r));return C("select",{"aria-label":n,onchange:s=>e(s.target.value)},i)}var pf=(n,t)=>({rows:n.rows,q:t,at:dt(n),turns:af(n),dof:t.length});function mf(n,t,e={}){let{axis:i=n.at,origin:s=n.at,subtracted:r=!0,point:o=t.length-1,slides:a=!0,crossed:l=!0}=e,c=t[o].o,h=new Array(6*n.dof);return n.at.forEach((u,d)=>{let[p,f]=[t[i[d]].z,t[s[d]].o],x=n.turns[d]||!a,m=r?Rt(c,f):c,g=x?l?Me(p,m):m:p;for(let y=0;y<3;y++)h[y*n.dof+d]=g[y],h[(y+3)*n.dof+d]=x?p[y]:0}),h}var gf=(n,t)=>[...n.slice(0,n.length/2),...t.slice(t.length/2)];function ln(n,t=6){let e=Array.from({length:t},(r,o)=>n.map(a=>a[o])),i=Array.from({length:t},(r,o)=>Array.from({length:t},(a,l)=>+(o===l)));for(let r=0,o=!0;o&&r<30;r++){o=!1;for(let a=0;a<t;a++)for(let l=a+1;l<t;l++)o=$x(e,i,a,l)||o}let s=e.map((r,o)=>[Math.hypot(...r),o]).sort((r,o)=>o[0]-r[0]);return{values:s.map(([r])=>r),vectors:s.map(([,r])=>i[r])}}function $x(n,t,e,i){let[s,r,o]=[0,0,0];for(let h=0;h<n[e].length;h++)s+=n[e][h]*n[e][h],r+=n[i][h]*n[i][h],o+=n[e][h]*n[i][h];if(Math.abs(o)<=1e-15*Math.sqrt(s*r)||o*o<1e-60)return!1;let a=(r-s)/(2*o),l=(a<0?-1:1)/(Math.abs(a)+Math.sqrt(1+a*a)),c=1/Math.sqrt(1+l*l);for(let h of[n,t])for(let u=0;u<h[e].length;u++){let[d,p]=[h[e][u],h[i][u]];h[e][u]=c*(d-l*p),h[i][u]=c*(l*d+p)}return!0}function xf(n){let t=n.length;if(n.some(s=>s.length!==t))return null;let e=n.map(s=>[...s]),i=1;for(let s=0;s<t;s++){let r=hh(e,s,s);if(e[r][s]===0)return 0;r!==s&&([e[r],e[s],i]=[e[s],e[r],-i]),i*=e[s][s];for(let o=s+1;o<t;o++)uh(e[o],e[s],s)}return i}function _f(n,t){let e=n.map((s,r)=>[...s,t[r]]),i=e.length;for(let s=0;s<i;s++){let r=hh(e,s,s);[e[r],e[s]]=[e[s],e[r]];for(let o=0;o<i;o++)o!==s&&uh(e[o],e[s],s)}return e.map((s,r)=>s[i]/s[r])}function yf(n){let t=n.map(i=>[...i]),e=0;for(let i=0;i<6&&e<t.length;i++){let s=hh(t,e,i);if(!(Math.abs(t[s][i])<1e-6)){[t[s],t[e]]=[t[e],t[s]];for(let r=0;r<t.length;r++)r!==e&&uh(t[r],t[e],i);e++}}return t.map(i=>i.map(s=>s/Math.hypot(...i)))}function hh(n,t,e){let i=t;for(let s=t;s<n.length;s++)Math.abs(n[s][e])>Math.abs(n[i][e])&&(i=s);return i}function uh(n,t,e){let i=n[e]/t[e];for(let s=0;s<n.length;s++)n[s]-=i*t[s]}function ti(n,t=-1){let e=n.map((a,l)=>l).filter(a=>a!==t);if(!e.length)return[];let i=n[0].map((a,l)=>e.map(c=>n[c][l])),{values:s,vectors:r}=ln(i,e.length),o=1e-5*Math.max(s[0],1e-12);return r.filter((a,l)=>s[l]<=o).map(a=>n.map((l,c)=>c===t?0:a[e.indexOf(c)]))}var Xx=[[1,0,0],[0,1,0],[0,0,1]];function vf({centre:n,radius:t,plane:e,period:i,steps:s,phase:r=0}){let[o,a]=[...e].map(h=>Xx["xyz".indexOf(h)]),l=2*Math.PI/i,c=h=>{let u=r+l*h;return[Math.cos(u),Math.sin(u)]};return{times:Array.from({length:s+1},(h,u)=>u===s?i:u*(i/s)),position:h=>{let[u,d]=c(h);return n.map((p,f)=>p+t*(u*o[f]+d*a[f]))},velocity:h=>{let[u,d]=c(h);return n.map((p,f)=>t*l*(u*a[f]-d*o[f]))},normal:Me(o,a)}}function At(n,t){return(Math.abs(n)<.5*10**-t?0:n).toFixed(t).replace("-","−")}var wr=(n,t)=>n.toExponential(t).replaceAll("-","−"),Ps=(n,t)=>`${At(n*180/Math.PI,t)}°`,Qo=(n,t)=>Math.abs(n)<1e-12?"0":At(n,t),fi=n=>n.kind!=="prismatic",bf=n=>fi(n)?"angle":"length";function gn(n,t,e){return fi(n)?e==="deg"?Ps(t,1):`${At(t,3)} rad`:`${At(t,3)} m`}function ta(n,t,e){if(!fi(n))return`${At(t,3)} metres`;let[i,s]=e==="deg"?[At(t*180/Math.PI,1),"degrees"]:[At(t,3),"radians"];return`${i.replace("−","minus ")} ${s}`}var Mf=(n,t,e)=>fi(n)&&e==="deg"?Ps(t,0):`${di(t,2)} ${fi(n)?"rad":"m"}`;function ea(n,t,e){if(!t)return di(n,6);if(e==="deg")return di(n*180/Math.PI,4);let i=n*12/Math.PI;if(n===0||Math.abs(i-Math.round(i))>1e-9)return di(n,6);let s=Math.round(i),r=[12,6,4,3,2,1].find(c=>s%c===0),[o,a]=[s/r,12/r],l=Math.abs(o)===1?`${o<0?"-":""}π`:`${o}π`;return(a===1?l:`${l}/${a}`).replace("-","−")}var di=(n,t)=>String(Number(n.toFixed(t))+0).replace("-","−"),qx=["move along","turn about"].flatMap(n=>[..."xyz"].map(t=>`${n} ${t}`));function dh(n){let t=n.flatMap((i,s)=>Math.abs(i)>.02?[[i,qx[s]]]:[]);if(t.length===1)return t[0][1];let e=Math.sign(t[0][0]);return t.map(([i,s])=>`${At(e*i,2)} ${s.replace("move ","").replace("turn ","")}`).join(", ")}function wf({rows:n}){let t=r=>String(Number(r.toFixed(9))+0),e=r=>{let o=ea(r,!0,"rad").replace("−","-").replace("π","pi");return o.includes("pi")?o.replace(/(\d)pi/,"$1*pi"):t(r)},i=(r,o)=>o==="0"?`q${r}`:`q${r} + ${o}`.replace("+ -","- ");return["i	a (m)	alpha (rad)	d (m)	theta (rad)",...n.map(({kind:r,a:o,alpha:a,d:l,theta:c},h)=>{let[u,d]=[t(l),e(c)],p=[t(o),e(a),u,d];return r==="prismatic"&&(p[2]=i(h+1,u)),r==="revolute"&&(p[3]=i(h+1,d)),[h+1,...p].join("	")}),""].join(`
`)}var xn=(n,t,e)=>n.map((i,s)=>s===t?e:i),fh=n=>n.replace(" (homework)",", homework’s lengths");function Sf(n,t=0){let e=Math.round(n/(Math.PI/2))*Math.PI/2;return Math.abs(n-e)<Math.max(1e-4,.51*t)?e:n}var Tf=n=>n.map(t=>({...t,alpha:Sf(t.alpha),theta:Sf(t.theta)}));var ei=1e-9,ia=-1;function Cf(n){let t=dt(n),e=t.flatMap((o,a)=>n.rows[o].kind==="prismatic"?[a]:[]),i=t.map(()=>0);if(!e.length)return na(n,i);let s=Ef(na(n,i)),r=e.map(o=>{let a=t.map((c,h)=>+(h===o));return Ef(na(n,a)).map((c,h)=>Math.abs(c-s[h])<ei?0:c-s[h])});return jx(r,s).forEach((o,a)=>i[e[a]]=-o),na(n,i)}function jx(n,t){let e=t.map((a,l)=>n.map(c=>c[l])),{values:i,vectors:s}=ln(e,n.length),r=n.map(a=>a.reduce((l,c,h)=>l+c*t[h],0)),o=n.map(()=>0);return i.forEach((a,l)=>{if(a<=ei*i[0])return;let c=s[l].reduce((h,u,d)=>h+u*r[d],0)/(a*a);s[l].forEach((h,u)=>o[u]+=c*h)}),o}var Ef=n=>[...n.flatMap(({normal:t})=>t),...n.flatMap(({offset:t,fromBase:e})=>t===null||e?[]:[t])];function na(n,t){let e=Ot(n,t),i=dt(n),s=i.length,r=i.map(f=>e[f].z),o=i.map(f=>e[f].o),a=i.flatMap((f,x)=>n.rows[f].kind==="revolute"?[x]:[]),l=[...a,s],c=(f,x)=>Array.from({length:Math.max(0,Math.min(x+1,s)-f)},(m,g)=>f+g),h={offset:null,bunch:[],fromBase:!0,toTip:!1},u=[Af(r,c(0,l[0]),[0,0,0],h)],d=a.length?Rf([0,0,0],[0,0,1],o[l[0]],r[l[0]])[1]:[0,0,0],p=[];return a.forEach((f,x)=>{let m=l[x+1],g=m===s;p.length||(d=mh(o[f],r[f],d));let[y,S]=g?[e.at(-1).o,null]:[o[m],r[m]],[w,A]=Rf(d,r[f],y,S);p=[...p,f];let E=!g&&Pf(r[f],r[m]),_=E?null:he(r[f],Rt(w,d)),M=p[0]===a[0];u.push(Af(r,c(f,m),Rt(A,w),{offset:_,bunch:p,fromBase:M,toTip:g})),d=A,E||(p=[])}),u}function ph(n,t){return t?n.flatMap((e,i)=>ph(n.slice(i+1),t-1).map(s=>[e,...s])):[[]]}function Af(n,t,e,i){let s=Xt(e),r=new Map(t.map(a=>[a,n[a]]));s>ei&&r.set(ia,Ut(1/s,e));let o=new Map;for(let[a,l]of ph(t,2))o.set(`${[a,l]}`,he(n[a],n[l]));for(let a of ph([...r.keys()],3)){let[l,c,h]=a.map(u=>r.get(u));o.set(`${a}`,he(Me(l,c),h))}return{joints:t,normal:e,length:s,shape:o,...i}}var mh=(n,t,e)=>Yt(n,Ut(he(t,Rt(e,n)),t));function Rf(n,t,e,i){if(!i)return[mh(n,t,e),e];if(Pf(t,i))return[n,mh(e,i,n)];let s=Rt(e,n),r=he(t,i),o=1-r*r,a=(he(t,s)-r*he(i,s))/o,l=(r*he(t,s)-he(i,s))/o;return[Yt(n,Ut(a,t)),Yt(e,Ut(l,i))]}var Pf=(n,t)=>Xt(Me(n,t))<ei;function If(n){let t=dt({rows:n}),e=t.map(i=>i+1);return{rows:n,joints:e,gaps:Cf({rows:n}),tilt:Jx({rows:n},t),...Yx(n,t[0])}}function Yx(n,t){let{z:e,o:i}=Ot({rows:n.slice(0,t)},[]).at(-1),s=Me([0,0,1],e),r=Xt(s)>ei?Math.abs(he(i,s))/Xt(s):Math.hypot(i[0],i[1]);return{foot:[n[t].kind==="revolute"?r:0,sa(Math.abs(e[2]))],axis:e,up:e[2]<-ei?-1:1}}function Jx(n,t){let e=Ot(n,t.map(()=>0));return he(e[t.at(-1)].z,e.at(-1).z)}function Zx(n,t,e=1e-6,i=1e-4){let s=n_(n,t);if(s.length)return{differences:s,signs:[],baseHigher:0,upsideDown:!1,tilts:[0,0]};let r=i_(n,t,e,i),o=r.reduce((f,x)=>f+Math.abs(x.mine-x.reference),0),a=new Map([1,-1].map(f=>[f,{cost:[r.length,o,0],signs:[f],found:r}])),l={mine:n,reference:t,within:{length:e,angle:i}};for(let f of n.gaps.keys())a=Qx(l,f,a);let c=[...a].map(([f,{cost:x,signs:m,found:g}])=>{let y=[sa(n.tilt),sa(f*t.tilt)],S=+(ra(...y)>i),w=m.reduce((A,E)=>A+E,0);return{cost:[x[0],x[1],x[2]+S,-w],signs:m,differences:g,tilts:y}}),{signs:h,differences:u,tilts:d}=c.reduce((f,x)=>Ff(x.cost,f.cost)?x:f),p={baseHigher:e_(n,t,h),upsideDown:Df(n,t,h)};return{differences:u,signs:h,...p,tilts:d}}function Nf(n,t){let[e,i]=[n,t].map(Tf);return!Zx(If(e),If(i)).differences.length}var Df=(n,t,e)=>!Of(n)&&e[0]*n.up*t.up<0,Of=({axis:n})=>Math.abs(n[2])<ei;function Ff(n,t){let e=n.findIndex((i,s)=>i!==t[s]);return e>=0&&n[e]<t[e]}var Kx=n=>Array.from({length:2**n},(t,e)=>Array.from({length:n},(i,s)=>e>>n-1-s&1?-1:1));function Qx(n,t,e){let{joints:i}=n.mine.gaps[t],s=new Map;for(let r of Kx(i.length)){let o=t_(n,t,r,e.get(r[0])),a=r.at(-1);(!s.has(a)||Ff(o.cost,s.get(a).cost))&&s.set(a,o)}return s}function t_({mine:n,reference:t,within:e},i,s,{cost:r,signs:o,found:a}){let[l,c]=[n.gaps[i],t.gaps[i]],h=new Map(l.joints.map((g,y)=>[g,s[y]])),d=xh(l)&&xh(c)&&`${l.bunch}`==`${c.bunch}`&&Math.abs(Uf(l,c,s[0]))>e.length,p=Df(n,t,o)||Of(n)&&o[0]*he(n.axis,t.axis)<0,f=s_(n,l,c,h,e),x=f.reduce((g,y)=>g+Math.abs(y.mine-y.reference),r[1]),m=r[2]+Number(d)+Number(p);return{cost:[r[0]+f.length,Number(x.toFixed(9)),m],signs:[...o,...s.slice(1)],found:[...a,...f]}}var pi=(n,[t,e],[i,s],r=[0,0])=>({key:n,row:t,entry:e,mine:i,reference:s,ends:r}),xh=({fromBase:n,offset:t,bunch:e,joints:i,toTip:s})=>n&&t!==null&&e.every((r,o)=>r===o)&&i.length+Number(s)===2,Uf=(n,t,e)=>e*(t.offset??0)-(n.offset??0);function e_(n,t,e){let[i,s]=[n,t].map(a=>a.gaps.find(xh));if(!i||!s||`${i.bunch}`!=`${s.bunch}`)return 0;let o=n.gaps.slice(1,i.bunch.length).reduce((a,l)=>a*l.shape.get(`${l.joints}`),1);return n.up*Math.round(o)*Uf(i,s,e[i.bunch.at(-1)])}function n_(n,t){let[e,i]=[n.joints,t.joints];if(e.length!==i.length){let s=e[Math.min(e.length,i.length)-1];return[pi("table count",[s,"joints"],[e.length,i.length])]}return e.flatMap((s,r)=>{let[o,a]=[n.rows[s-1].kind,t.rows[i[r]-1].kind];return o===a?[]:[pi("table kind",[s,"joint"],[o,a])]})}function i_(n,t,e,i){let[[s,r],[o,a]]=[n.foot,t.foot],l=[0,n.joints[0]],c=[];return Math.abs(r-a)>i&&c.push(pi("table lean",[1,"alpha"],[r,a],l)),Math.abs(s-o)>e&&c.push(pi("table foot",[1,"a"],[s,o],l)),c}function s_(n,t,e,i,{length:s,angle:r}){let o=[],a=n.joints[t.joints[0]];if(Math.abs(t.length-e.length)>s){let h=t.toTip?0:n.joints[t.joints.at(-1)];o.push(pi("table distance",[a,"a"],[t.length,e.length],[a,h]))}let l=r_(n,t,e,i,r);if(o.push(...l.length?l:o_(n,t,e,i,r)),t.fromBase||`${t.bunch}`!=`${e.bunch}`||t.offset===null||e.offset===null)return o;let c=i.get(t.joints[0])*e.offset;if(Math.abs(t.offset-c)>s){let h=[n.joints[t.bunch[0]],n.joints[t.bunch.at(-1)]];o.push(pi("table along",[h[1],"d"],[t.offset,c],h))}return o}function r_(n,t,e,i,s){return t.joints.slice(1).flatMap((r,o)=>{let a=[t.joints[o],r],l=`${[...a,ia]}`,c=t.joints.length===2&&t.shape.has(l)&&e.shape.has(l),[h,u]=[Lf(t,a,c,new Map),Lf(e,a,c,i)];if(ra(h,u)<=s)return[];let d=a.map(p=>n.joints[p]);return[pi("table between",[d[0],"alpha"],[h,u],d)]})}function Lf(n,t,e,i){let s=Sr(n,t,i);return e?Math.atan2(Sr(n,[...t,ia],i),s):sa(s)}var Sr=(n,t,e)=>t.reduce((i,s)=>i*(e.get(s)??1),n.shape.get(`${t}`));function o_(n,t,e,i,s){let o=t.joints.some(u=>n.rows[n.joints[u]-1].kind==="prismatic")?[...t.shape.keys()].filter(u=>e.shape.has(u)):[],a=u=>Math.abs(t.shape.get(u)-Sr(e,u.split(",").map(Number),i));if(o.every(u=>a(u)<=s))return[];let l=a_(n,t,e,i).find(([,u,d])=>ra(u,d)>s);if(l)return[pi("table held",[l[0],"theta"],l.slice(1))];let[c,h]=[0,-1].map(u=>n.joints[t.joints.at(u)]);return[pi("table side",[c,"a"],[0,Math.PI],[c,t.toTip?0:h])]}function a_(n,t,e,i){let s=(...r)=>1-t.shape.get(`${r}`)**2>ei;return t.joints.slice(1,-1).flatMap(r=>{let o=t.joints.filter(d=>d<r&&s(d,r)).at(-1),a=t.joints.find(d=>d>r&&s(r,d));if(o===void 0||a===void 0)return[];let[l,c]=[[o,r,a],n.joints[r]],u=ra(gh(t,l,new Map,1),n.rows[c-1].theta)>2?-1:1;return[[c,gh(t,l,new Map,u),gh(e,l,i,u)]]})}function gh(n,t,e,i){let[s,r,o]=t,[a,l,c]=[[s,r],[r,o],[s,o]].map(u=>Sr(n,u,e)),h=Math.atan2(i*Sr(n,t,e),i*(a*l-c));return h<ei-Math.PI?Math.PI:h}var sa=n=>Math.acos(Math.max(-1,Math.min(1,n)));function ra(n,t){let e=2*Math.PI,i=(n-t+Math.PI)%e;return Math.abs((i<0?i+e:i)-Math.PI)}var kf={"too long":"{what} has {count} characters; at most 2 000 000 are read: paste the numbers alone",empty:"{what} is empty; paste or type your numbers","no block":"I find no numbers in {what}; write {wanted}, a row on each line","no fit":"I find {found} numbers, at {line}; asked is {wanted}: write a row on each line, with blanks or commas between",which:"I find several answers that differ, at {blocks}; say which is meant","no solution":"You say that there is no solution; write the joint values that you found","doubtful sign":"A ~ stands before a number; write - if it is a minus sign, or delete it",complex:"I find complex numbers; joint values and torques are real: look at what is under the root","no text":"This is no text that I can read; paste the numbers as text","set aside":"set aside: {texts}","taken: by names":"in the order that your names say","taken: linear millimetres":"linear rows in mm","taken: newton millimetres":"torques in N mm","taken: radians":"angles in radians","and also":"{first}; and besides, {second}",or:"{first}; or {others}, which gives the same numbers here","cut print":"the print was cut: dots stand where numbers should; print all of it (NumPy: np.set_printoptions(threshold=sys.maxsize))","arm.other":"This is right for {other}, whose lengths are {others} mm; asked was {arm}, with {lengths} mm.","leave out":"; leave out {joints}, which is locked","at this pose":" at this pose",column:"column {column}",joint:"joint {joint}",entry:"entry ({row}, {column})",answer:"answer {number}",cut:"your digits are cut where the next one would round them up. That counts; round them next time","to your digits":", to the digits you gave","two signs":"± stands for two numbers; expected one in each entry, so write out each sign, or leave out how far a number may be off","no masses":"{arm} has no masses; expected a mass and a centre of mass for each of its {rows} rows","each joint":"one value for each of {joints}","joint zero":"{arm}: {name} is no joint, for joints count from 1 here; write {first} for it and so on, each number one higher","unknown symbol":"{arm}: no value for {name}; known are {known}","symbols for numbers":"there is no value for {names}; expected numbers","not finite":"{what}: NaN or infinity stands among the numbers; expected {wanted}","no numbers":"{what} is {given}; expected {wanted}","no matrix":"{what} has {given}; expected a matrix of finite numbers","ragged list":"{what} has rows of unequal length; expected rows of one length","function failed":"{what}: your function failed ({error}); it was called with q of {dof} values. Wrap it, as in lambda q: f(q, ...)","arm is read":"mine is an Arm, in metres and radians, and needs no {given}; expected rows or text with it","J needs q":"numbers are a Jacobian at one pose; expected its q too","no table":"the table is {given}; expected rows or text","two angles":"the table holds {one} and {other}, an angle in degrees and one in radians; write all of them in one unit, or say which is meant","no link matrix":"A_{i} is no link matrix: its entry in row {row}, column {column} does not fit the others. Multiply out Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha) of its row","table.transposed":"The rotation of A_{i} is transposed: its first column is (cos theta, sin theta, 0)","table.frames":"These are the frames T_0i, each seen from the base: give A_i = T_(i-1)i, each seen from the one before it","table.names":"Row {row} moves by {name}, out of turn: row i of the table is moved by joint i","row torn":"the line {line} stands beside the rows and is none of four entries like them; write each entry as a number, a symbol or 0","no rows":"the table is {given}; expected rows of four entries","no entries":"the table is {given}; expected lists such as 'a': [...], or entries such as 'd1': 0.3","link sigma":"in {given}: expected theta, d, a, alpha, then 0 for a joint that turns or 1 for one that slides, then its offset","uneven lists":"the table's lists have {counts} entries; expected as many in each","no columns":"columns are {given}; expected the four of 'theta d a alpha' in your order","many rows":"the table has {count} rows; expected at most {most}","row width":"the table's rows have {widths} entries; expected four, a alpha d theta in some order","row widths":"the table's rows have {widths} entries; expected four, a alpha d theta in some order (row {row} has {count}; an empty cell is written 0)","row symbol":"row {row}: no value for {name}","row slope":"row {row}: {name} grows by {rate} with its joint; expected the joint's value itself, added or taken away","taken: columns":"columns {columns}","taken: millimetres":"lengths in millimetres","taken: degrees":"angles in degrees","taken: craig":"the modified (Craig) convention, turned into the standard one","taken: backwards":"joints counted backwards in {rows}, which is a free choice","taken: fixed":"not moving: {rows}, for the joints are used up",row:"row {row}",rows:"rows {rows}","taken: matrices":"4 x 4 matrices A_i","taken: links":"Link lines","taken: angular first":"rows (omega, v)","taken: half":"the three {half} rows","taken: locked":"all joints; {joints} is locked, so its {values} is set aside","J right":"The Jacobian of {arm} is right{where}{precision}.","J half right":"The {half} rows of the Jacobian of {arm} are right{where}{precision}; the {other} ones are missing.","J half missing":"Add the three {other} rows.","J so far":"The Jacobian of {arm} is right so far{where}. With these digits the right answer and a common mistake look alike: give two more.","J rounded":"The Jacobian of {arm} is right{where} but for a last digit in {places}, which is one off: round only at the end.","J wrong":"The Jacobian of {arm} is not right: {cause}","J wrong everywhere":"The Jacobian of {arm} is not right in any column, and I know no mistake that explains it. Begin with column 1: {question}","J turns":"which axis does joint {joint} turn about, and how far from it is the tip?","J slides":"along which axis does joint {joint} slide?","J zero":"Every entry is 0: fill it in.","J wrong places":"The Jacobian of {arm} is not right in {places}.","J hidden":"{count} of {all} usual mistakes leave the Jacobian as it is at this pose: try another pose too","J column":"Column {column} (joint {joint}): {words}.","J.entry signs":"turn the sign of {rows}","J.entries":"look again at {rows}","J.column of":"The column of joint {i} is a copy of that of joint {joint}","J.other column":"this is the column of joint {joint}","J.shape":"Its shape is {shape}; give 6x{dof}: rows vx, vy, vz, wx, wy, wz, and a column for each free joint","J.row for column":"You deleted a row where a column should go: locking a joint removes its column, and all six rows stay","J.locked column kept":"Delete the column of the locked joint: the rest is right","J.transposed":"It is transposed: give one column for each joint, six rows","J.halves":"Linear and angular rows are exchanged","J.wx and wy":"The rows wx and wy are exchanged","J.cross":"The cross product is the wrong way round: take z x (o_n - o), not (o_n - o) x z","J.all signs":"Every sign is reversed","J.angular sign":"The angular rows have the wrong sign: a joint that turns contributes +z_{i-1}","J.angular zero":"The angular rows are zero: a joint that turns contributes its axis z_{i-1}","J.linear zero":"The linear rows are zero: a joint that turns contributes z_{i-1} x (o_n - o_{i-1})","J.millimetres":"The linear rows are in millimetres: use metres","J.per degree":"The columns are per degree: use radians","J.degrees":"You took q in degrees where radians are meant, or radians where degrees are: sine and cosine want radians","J.z_i angular":"The angular rows have z_i: put z_{i-1} there, for joint i turns about the axis of the frame before it","J.z_0 angular":"Every angular column is z_0: column i needs its own joint's axis, z_{i-1}","J.one frame late":"Axes and origins are one frame too far: joint i has z_{i-1} and o_{i-1}, not z_i and o_i","J.z_i":"The axes are one frame too far: joint i turns about z_{i-1}, not z_i","J.origin late":"The lever arm starts at o_i: start it at o_{i-1}, a point on the joint's axis","J.lever tip":"The lever arm is o_n alone: subtract o_{i-1}, the point on the joint's axis","J.no cross":"The linear rows hold the lever arm itself: cross it, z_{i-1} x (o_n - o_{i-1})","J.rows of T":"You read axes and origins from the rows of T: they are its columns","J.point":"The linear rows are the velocity of o_{k}, not of the tip: take o_n","J.slide turns":"A joint that slides is treated as one that turns: its column is z over 0","J.slide angular":"The angular rows of a joint that slides hold its axis: they are 0","J.wrong column deleted":"Column {column} is deleted in place of the locked joint's","J.reversed order":"The columns run from the tip to the base: put joint 1 first","J.columns exchanged":"The columns of joints {i} and {j} are exchanged","J.frame":"The rows are in the axes of {_name}: turn them into those of {_wanted}","table.pen":"The pen is forgotten: the tip is l_pen farther out","table.pen sign":"The pen is taken away where it is added: the tip is l_pen farther out","table.offsets":"The offsets of theta are forgotten: q_i is added to them","table.offset":"The offset of theta in row {row} is forgotten","table.offset sign":"The offset of theta in row {row} has the wrong sign","table.twist":"The twist alpha in row {row} has the wrong sign","table.no twist":"The twist alpha in row {row} is missing","table.locked row":"The locked joint's row is deleted from the table: it still carries the arm, so keep it, with its fixed angle","table.craig rows":"Rows of a Craig table, with a_{i-1} and alpha_{i-1}, stand in the standard matrix: use one convention throughout","table.a exchanged":"a in rows {i} and {j} is exchanged","table.sign":"{column} in row {row} has the wrong sign","table.missing":"{column} in row {row} is missing","table.length":"{name} is taken as long as {other}","table.too much":"{column} in row {row} should be nothing","table.angle":"{column} in row {row} is {_off}° off","table.number":"{column} in row {row} is {_off} mm {_way}","table.robot":"The lengths are those of the {name}, another robot of nearly the same name; take them from the data sheet of yours","table.alpha and theta":"The alpha and theta columns are exchanged","table.a and d":"The a and d columns are exchanged","table.a and d in row":"a and d of row {row} are exchanged","table.craig":"The rows are in the modified (Craig) convention; convert them","table.into craig":"The a and alpha columns stand one row too high","table.rows exchanged":"Rows {i} and {j} are exchanged","your table":"Your table","own joints":"{arm}, in your joints","table same":"{mine} describes the same arm as {reference}.","table other zeros":"{mine} is the same arm as {reference} with other zeros, another base or another tool: at the homework's start, q = {home}, your tip is {away} m away{turned}.","table other entries":"{mine} takes the tip elsewhere: at the homework's start, q = {home}, it is {away} m away{turned}; {cause}.","table tool turned":", with the tool turned by {degrees}°","table rounded":"{mine} describes the same arm as {reference} but for the last digit of its lengths.","table other arm":"{mine} is another arm than {reference}.","table wrong":"{mine} is another arm than {reference}: {cause}.","and what remains":"; something remains besides",perhaps:"perhaps {cause}",map:"the same q is another pose. The reference counts its joints otherwise: {equations}","map joint":"its q_{joint} is your q_{mine}{tail}","map back":"its q_{joint} is -(your q_{mine}){tail}","map unknown":"the same q may be another pose: no map between the joints was found","base upside down":"your z_0 points the other way along axis 1; that is a free choice, but heights in the two base frames have opposite signs",base:"your base frame stands {height} mm {way} on axis 1 (d in row {row}) than the reference's. That is a free choice, but positions in the two base frames differ by it",higher:"higher",lower:"lower",tool:"the last frame's z axis stands at {mine}° to the last joint axis in yours and at {reference}° in the reference. The tip's place does not depend on it, the tool's orientation does","write right angle":"{column} in row {row}, {typed}, is taken as {wanted}; write it so","table entry":"{words} (you have {typed}).","table at":"Row {row}, {entry}: {words}.","the tip":"the tip",axis:"axis {i}","parallel axes":"the parallel axes {i} to {j}, added up,","table distance what":"the distance from axis {start} to {end}","table lean what":"the angle from z_0 to axis {j}","table foot what":"the distance from z_0 to axis {j}","table between what":"the twist from axis {start} to axis {j}","table held what":"the angle about the slide, from the common normal before it to the one after it,","table side what":"the shortest way from axis {start} to {end}","table along what":"the offset along {along}","table count words":"The number of joints is {mine} in yours and {reference} in the reference: each joint needs a row with its variable. Where one is locked on purpose, compare with the arm that has it locked.","table kind what":"the joint","table other":"{what} is {mine} in yours and {reference} in the reference","table angle":"{what} is {mine}° in yours and {reference}° in the reference: {off}° off","table side":"{what} points another way than in the reference: look at the signs here and in the rows beside it","table other way":"{what} is {mine} m in yours and {reference} m in the reference: it goes the other way, so a sign is wrong here or in a row beside it","table length":"{what} is {mine} m in yours and {reference} m in the reference: {off} mm {way}",long:"too long",off:"off",short:"too short","taken: list per joint":"a list per joint, turned round: a row per pose","taken: masses":"links of {masses} kg under g = {g} m/s²","tau right":"The torques of {arm} are right{precision}.","tau so far":"The torques of {arm} are right so far. With these digits the right answer and a common mistake look alike: give two more.","tau rounded":"The torques of {arm} are right but for a last digit at {places}, which is one off: round only at the end.","tau wrong":"The torques of {arm} are not right: {cause}","tau wrong places":"The torques of {arm} are not right at {places}.","tau other way":"Joint {joint}: turn its sign.","tau off":"Joint {joint}: off by {most}{off} {unit}.","up to":"up to ","tau.energy":"One number for a pose is the potential energy: torques are its derivatives, one for each joint.","tau.shape":"Its shape is {shape}; give {wanted}, one torque for each of {dof} joints.","tau.degrees":"You took q in degrees where radians are meant, or radians where degrees are: sine and cosine want radians","tau.weight missing":"The weight is missing: tau = g - J^T F","tau.weight sign":"The weight has the wrong sign: g(q) = dP/dq, and P grows with height","tau.gravity":"You seem to have used g = {g}; here it is 9.81","tau.grams":"The masses are in grams: use kilograms","tau.paper centres":"The centres of mass are the paper's own numbers, in the paper's frames: convert them into the frames of your table","tau.centres at origins":"The centres of mass are at the frames' origins: put each where its link's is","tau.lumped":"Links 2 and 3 are lumped into one uniform bar, as in the Panda report: here each has its own mass and centre","tau.report":"This is the Panda report's own model, links 2 and 3 lumped and g = 9.8: here each link has its own mass and centre, and g is 9.81","slip 8":'the report takes g = 9.8 "for simplicity", slip 8; it changes every torque by 0.1 %',"tau zero":"Every torque is 0: fill them in, or add the load you forgot.","tau.own link":"Each joint carries its own link alone: it carries all links behind it too","tau.masses moved":"The masses are moved by one link: put each at its own","tau.mass missing":"The mass of link {link} is missing","tau.masses exchanged":"The masses of links {i} and {j} are exchanged","tau.centres other length":"The centres of mass are converted with {other} for {name}","tau.robot":"The masses are those of the {name}, another robot of nearly the same name: take them from the data sheet of yours","tau.force sign":"The force has the wrong sign: F is on the tool, by the world, and tau = g - J^T F","tau.force missing":"The force is missing: tau = g - J^T F","tau.force in tool":"The force is in the tool's axes: turn it into the base's first","tau.J for J^T":"The force goes through J: it takes the transpose, J^T F","tau.all signs":"Every sign is reversed","tau.makers signs":"Joints 2, 4 and 7 count the other way, as the maker has them: turn their signs","tau.reversed order":"The torques run from the tip to the base: put joint 1 first","one target":"{arm}: found holds {count} targets; expected the branches of one","one answer":"{arm}: there are {count} answers; expected one","pose shape":"{what} has {given}; expected {wanted}","a pose":"the three or four rows of a pose","a point or a pose":"a point x, y, z, or the three or four rows of a pose","taken: answer per column":"an answer per column","ik right":"Your joint angles for {arm} are right and complete.","ik rounded":"Your joint angles for {arm} are right and complete but for a last digit: round only at the end.","ik so far":"Your joint angles for {arm} are right so far: {count} of {all} branches.","ik so far digits":"Your joint angles for {arm} are right so far. With these digits a common mistake would look the same: give two more.","ik wrong":"Your joint angles for {arm} are not right: {cause}.","ik some wrong":"Your joint angles for {arm} are not all right: {count} of {all} branches are found.","ik none":"No joint angles of {arm} reach this target.","ik one side":"All your answers face the same way. Turn joint 1 by 180° and solve θ2 and θ3 again.","ik twice":"Answers {numbers} are the same, whole turns aside","ik missing":"Missing: {names}.","ik together":"the {all} branches are only {count} here, for some have become one","ik free":"{joint} is free here: any value of it will do, if the others follow. So there are infinitely many answers, and one stands for them","ik out of range":"what is missing lies beyond the range of {joints}, where the arm cannot go","ik no branch":"Answer {number} cannot be right: no joint angles reach this target.","ik unlisted":"Answer {number} reaches the target by joint angles that are not in the list compared with.","ik off":"misses the target by {millimetres} mm{turn}","ik turn":" and {degrees}°","ik answer":"Answer {number} {off}: {words}.","ik found":"Found: {name}.","ik mixed":"branches are mixed: {joints} would be right in '{other}', the rest belongs to '{most}'","ik in no branch":"{joints} agree with no branch","ik one in no branch":"{joints} agrees with no branch","ik.degrees":"The angles are in degrees: write radians","ik.makers signs":"Joints 2, 4 and 7 have the wrong sign, as the maker counts them: your table counts them the other way","ik.reversed order":"The joints run from the tip to the base: put joint 1 first","ik.sign":"{joint} has the wrong sign","ik.exchanged":"{first} and {second} are exchanged","ik.half turn":"{joint} is half a turn off: use atan2, not atan","ik.other axis":"{joint} is measured from the other axis (pi/2 less it): take y/x, not x/y","ik.supplement":"{joint} is the inner angle (pi less it): mind the sign in the law of cosines","ik.offset":"{joint} is a quarter turn off: mind the offset of theta in its row","ik.quarter turn":"theta_1 = +-pi/2 is from the case on the axis: with an offset d it has two other values, one for each side of the shoulder","ik.plus for minus":"In θ2 you added the second atan2; subtract it","ik.mixed":"The joints belong to different branches: turning the shoulder or the elbow over changes the joints after it too","ik.shoulder":"The shoulder is turned over alone: θ2 and θ3 belong to the other side, so solve them again for the turned θ1","ik.one sign":"All your answers have {joint} of one sign: acos and the square root have two, so take the other as well.","pose right":"The joints take the tip of {arm} there.","pose rounded":"The joints take the tip of {arm} there but for a last digit: round only at the end.","pose so far":"The joints may take the tip of {arm} there. With these digits a common mistake would look the same: give two more.","pose wrong":"The joints do not take the tip of {arm} there: it {off}.","pose cause":"The joints do not take the tip of {arm} there, it {off}: {cause}.","pose.millimetres":"The target is in millimetres: write metres","pose.half turn":"The target's frame is turned by 180° about its z axis: two of its axes are reversed","pose.entry":"Entry ({row}, {column}) of T is off.","pose.coordinate":"The {axis} coordinate of the point is off.","pose.transposed":"The rotation of the target is transposed","beyond limits":"{joints} would be beyond the real arm's range","taken: times":"joints behind a leading column of times","trace right":"{arm} draws the path.","trace wrong":"{arm} does not draw the path: {cause}","trace where":"The tip is up to {error} mm from where it should be, at step {step} of {steps}; at the start it is {start} off.",already:"already","trace leans":"The tool leans by up to {degrees} degrees.","trace spins":"The tool turns about its own axis by up to {degrees} degrees.","joint by":"joint {joint} by {by} {unit}","trace beyond range":"beyond the real arm's range: {joints}","trace beyond speed":"beyond the real arm's speed: {joints}","trace.shape":"Its shape is {shape}; expected {rows}x{dof}, one row for each of the path's times.","trace.degrees":"The joints are in degrees: write radians","trace.one more":"There is one step too many: N steps are i = 0 ... N - 1, and with the start they give N + 1 rows.","trace.jump":"From step {step} to {to} joint {joint} jumps by {by} (such steps: {count}): another branch was taken, or a singular pose is near; stay on the branch nearest to the step before.","trace jump off":"From step {step} to {to} joint {joint} jumps by {by} (such steps: {count}): look at J and at the velocity there.","trace whole turn":"from step {step} to {to} joint {joint} jumps by a whole turn (such steps: {count}). It is counted on here, for the pose is the same; an arm would turn all round, so count on in yours too, as unwrap does","trace.backwards":"The path is drawn the other way round: look at the sign of the velocity","trace.other side":"The path is drawn on the other side of its start: look at the sign of the velocity","trace.centre":"The centre is left out in {axes}: the circle's formulas are relative to it, so add its coordinates","trace.millimetres":"The velocities are in mm/s and the Jacobian in metres: write m/s","trace.no inverse":"At step {step} the Jacobian has rank {_rank} of {_rows}, so it has no inverse there, and joint {_joint} jumps by {_by}: take the pseudo-inverse, or begin beside that pose","trace.displaced":"The whole path is displaced by {_by} mm: look at the centre, or at where you start","trace.fraction":"{_share} % of the path's length is drawn in its time: velocity and time step belong to different durations, by a factor of {_over}","trace.open":"The circle does not close: the angle grows by 2 pi/(N + 1) a step, N steps need 2 pi/N","trace.scaled":"The path is {_scale} times as large as it should be: look at the radius, or at velocities for one duration T with time steps of another","trace.axes exchanged":"The {first} and {second} coordinates are exchanged","trace.next velocity":"Each step takes the velocity of the step after it: J(q_k) goes with the velocity at t_k","trace.jacobian held":"The Jacobian of the start is used all along: compute it anew at each step","trace.position only":"Only the position is controlled: the angular rows of the Jacobian, with omega = 0, hold the tool"};function se(n,t={}){let e=kf[n];for(let[i,s]of Object.entries(t))e=e.replaceAll(`{${i}}`,()=>String(s));return e}var Jt=class extends Error{constructor(t,e=[]){super(t),this.advice=e}};function _h(n){try{return n()}catch(t){if(t instanceof Jt)return null;throw t}}var je=(n,t="and")=>n.length<2?n.join(""):`${n.slice(0,-1).join(", ")} ${t} ${n.at(-1)}`,oa=n=>n.slice(0,1).toUpperCase()+n.slice(1);var as=(n,t=3)=>String(Number(n.toPrecision(t))),Bf=75;function Vn(n){let t=[...n.replace(/[\p{C}\s]+/gu," ").trim()],e=t.includes("'")&&!t.includes('"')?'"':"'",i=t.length>Bf?[...t.slice(0,Bf),"..."]:t;return`${e}${i.join("")}${e}`}var c_=1e-6,Ae=n=>dt(n).length<6?3:6,yh=n=>Ae(n)<6?"place":"pose",Hf=n=>n.filter(t=>t>c_*n[0]).length,la=n=>Math.min(Ae(n),dt(n).length);function Tr({arm:n,rank:t,lost:e}){let[i,s]=[la(n),Ae(n)],r=t<i;return r?{singular:r,text:`Singular: rank ${t} of ${i}. ${u_(e,i<s)}`}:{singular:r,text:h_(t,i,dt(n).length)}}function h_(n,t,e){return e?t===6?"Rank 6: the tip can move along and turn about every direction.":t<3?`Rank ${n}, the most that ${e>1?`${e} joints`:"one joint"} can have.`:"Rank 3: the tip can move along every direction; with fewer than six joints it cannot be turned at will as well.":"No joint moves this arm."}var zf=n=>n.filter(t=>Math.abs(t)>.02).length;function u_(n,t){if(!n.length||t)return"";let e=n.filter(s=>zf(s)===1).map(dh),i=n.filter(s=>zf(s)>1).map(s=>`make the motion ${dh(s)}`);return`Here the tip cannot ${je([...e,...i],"nor")}.`}var d_="No One Two Three Four Five Six Seven Eight".split(" "),Gf=n=>`${d_[n]??n} ${n===1?"way":"ways"}`,Vf=(n,t)=>je(t.map(e=>`joint ${dt(n)[e]+1}`));function ca(n,{list:t,families:e=[],lockedJoint:i=-1,hasOrientation:s=!0}){let r=s?"pose":"place, whatever the tool’s direction",o=t.length-e.length,a=i<0?"":` with joint ${dt(n)[i]+1} held where it is; free, it makes them infinitely many`;if(!e.length)return`${Gf(t.length)} to this ${r}${a}.`;let l=e[0].moving,c=l.length===1?`${Vf(n,l)} is free`:`${Vf(n,l)} are free to move together`,h=e.length>1?`, in ${e.length} families`:"",u=o?` and ${Gf(o).toLowerCase()} more`:"",d=i<0?"":`, joint ${dt(n)[i]+1} held`,p=`one of each is shown${u}${d}`;return`Infinitely many ways to this ${r}: ${c}${h}; ${p}.`}var vh=(n,t)=>dt(n).flatMap((e,i)=>t(e,i)?[`joint ${e+1}`]:[]),ha=(n,t)=>vh(n,(e,i)=>t.some(s=>Qn(n.rows[e],s[i])));function bh({stops:n=[],short:t=0}){if(t<.002)return"";let e=n.length?je(n):"out of reach";return`${oa(e)}: ${At(1e3*t,0)} mm short.`}function Mh(n){if(!n?.target)return"";let t=n.moving?"":bh(n);if(t||!n.fading?.length)return t;let e=n.fading.length>1?"the arrows":"the arrow";return n.fading.every(({share:s})=>s<.001)?`Singular: the tip cannot move along ${e}.`:`Nearly singular along ${e}.`}var f_="Type into any entry: 0.333, −90°, pi/2, or paste a whole table. The arm follows, and the first one stays as a ghost.";function Wf({arm:n,reference:t,q:e},{frames:i}){if(n===t)return f_;let s=[n,t].map(d=>dt(d).length);if(s[0]!==s[1])return`Yours has ${s[0]} joints, the ${t.name} ${s[1]}.`;let[r,o]=[i.at(-1),Ot(t,e).at(-1)],a=(he(r.x,o.x)+he(r.y,o.y)+he(r.z,o.z)-1)/2,l=Math.acos(Math.max(-1,Math.min(1,a)))*180/Math.PI,c=1e3*Xt(Rt(r.o,o.o)),u=`at these joint values its tip is ${`${At(c,1)} mm and ${At(l,1)}°`} away from the ghost’s`;return p_(n,t)?c<.05&&l<.05?`The same arm as the ${t.name}: ${u}.`:`The same arm as the ${t.name}, with another zero, direction or frame that is free to choose: ${u}, but other joint values bring it there.`:`Another arm than the ${t.name}: ${u}.`}var aa={arm:null,reference:null,is:!1};function p_(n,t){return(aa.arm!==n||aa.reference!==t)&&(aa={arm:n,reference:t,is:Nf(n.rows,t.rows)}),aa.is}var m_=n=>Math.max(0,dt(n).length-Ae(n));function Is(n,t){let e=["x","y","z"].reduce((i,s)=>Yt(i,Me(n[s],t[s])),[0,0,0]);return[...Rt(t.o,n.o),...Ut(.5,e)]}var mi=(n,t)=>n.reduce((e,i,s)=>e+i*t[s],0),Er=(n,t,e)=>_f(n.map((i,s)=>n.map((r,o)=>mi(i,r)+(s===o?e:0))),t);function gi(n,t,e,{lockedJoint:i=-1,rows:s=Ae(n),steps:r=60}={}){let o=[...t];for(let a=0;;a++){let l=Ot(n,o),c=Is(l.at(-1),e).slice(0,s),h=Xt(c);if(h<1e-11||a===r||!o.length)return{q:o,error:h};let u=We(n,l).map((x,m)=>x.slice(0,s).map(g=>m===i?0:g)),d=u.map(x=>mi(x,c)),p=Er(u,d,.02*h*h+1e-12),f=Math.max(1e-12,...p.map(Math.abs));o=o.map((x,m)=>x+p[m]*Math.min(1,.6/f))}}var g_={x:["zy",1],y:["zx",-1],z:["yx",1]};function Ui(n,{normal:t="x",radius:e=.1,seconds:i=1},s){let[r,o]=g_[t],a=n.map((h,u)=>h-("xyz"[u]===r[0]?e:0)),l=vf({centre:a,radius:e,plane:r,period:o*i,steps:1}),c=s*i;return{o:l.position(c),v:l.velocity(c)}}var $f=.05;function wh(n,t,e){let i=n;for(let s of t.keys())for(let r of[$f,-$f]){let o=e(xn(t,s,t[s]+r));o.error<.98*i.error&&(i=o)}return i}function jf(n,t,e,i){let s=a=>gi(n,a,e,i),r=s(t);return r.error>1e-6&&ls(r.q,t)?wh(r,t,s):r}function x_(n){return()=>(n=Math.imul(n,1664525)+1013904223>>>0)/2**32}function Sh(n,t=Math.random){return dt(n).map(e=>{let[i,s]=Rn(n.rows[e]);return i+(s-i)*t()})}var __=16;function Yf(n,t,e=300){let i=Ot(n,t).at(-1),s=Ae(n)===6;if(!an(n,t)||!t.length)return{list:[],families:[],lockedJoint:-1,target:i,hasOrientation:s};let r=m_(n)?2:-1,o=x_(1),a=[],l=[],c=h=>{if(a.some(d=>v_(n,d,h))||l.some(d=>Th(n,d,h)<.001))return;let u=y_(n,h,i,r);l.push(h),u.length&&a.push({moving:u,q:h})};c(qf(n,t));for(let h=0;h<e&&l.length<__;h++){let u=Sh(n,o).map((f,x)=>x===r?t[x]:f),{q:d,error:p}=gi(n,u,i,{lockedJoint:r});p<1e-9&&c(qf(n,d))}return{list:l.map(h=>({q:h})),families:a,lockedJoint:r,target:i,hasOrientation:s}}var Xf=.1;function y_(n,t,e,i=-1){let s=Ae(n),r=We(n,Ot(n,t)).map((c,h)=>c.slice(0,s).map(u=>h===i?0:u)),{values:o}=ln(r,s),a=dt(n).length-(i<0?0:1);if(o.filter(c=>c>1e-5*o[0]).length>=Math.min(s,a))return[];let l=new Set;for(let c of ti(r,i)){let h=t.map((d,p)=>d+Xf*c[p]),u=gi(n,h,e,{lockedJoint:i,steps:200});u.error>1e-9||Th(n,u.q,t)<.3*Xf||u.q.forEach((d,p)=>Math.abs(d-t[p])>.001&&l.add(p))}return[...l].sort((c,h)=>c-h)}function v_(n,{moving:t,q:e},i){let s=i.map((r,o)=>t.includes(o)?e[o]:r);return Th(n,e,s)<.001}function qf(n,t){return dt(n).map((e,i)=>{if(n.rows[e].kind!=="revolute")return t[i];let[s,r]=Rn(n.rows[e]),o=Math.atan2(Math.sin(t[i]),Math.cos(t[i]));return[o,o+2*Math.PI,o-2*Math.PI].find(a=>a>=s&&a<=r)??o})}function Th(n,t,e){let i=(s,r)=>n.rows[s].kind==="revolute"?2*Math.sin((t[r]-e[r])/2):t[r]-e[r];return Math.max(...dt(n).map((s,r)=>Math.abs(i(s,r))))}var ls=(n,t)=>n.length===t.length&&n.every((e,i)=>Math.abs(e-t[i])<1e-4);var Ar={method:"euler",rates:"inverse",steps:1e3,seconds:5,radius:.1,normal:"x",gain:0,cutoff:1e-9,damping:.02,locked:2,mistake:""};function b_(n,t,e,i){let s=pf(n,t),r=s.at.map(c=>c+1),o=c=>mf(s,e,c),l={angular:()=>gf(o({}),o({axis:r})),z_i:()=>o({axis:r,origin:r}),o_i:()=>o({origin:r})}[i]?.()??o({});return t.map((c,h)=>[0,1,2,3,4,5].map(u=>l[u*s.dof+h]))}var ua=class extends Error{},Jf=(n,t)=>n.map((e,i)=>i).filter(e=>e!==t),Zf=n=>n[Math.min(5,n.length-1)]<=1e-9*n[0];function M_(n,t,e){let i=We(n,Ot(n,t));return Zf(ln(Jf(i,e).map(s=>i[s])).values)}function w_(n,t,{rates:e,cutoff:i,damping:s,locked:r}){let o=Jf(n,r),{values:a,vectors:l}=ln(o.map(u=>n[u])),c=e==="pseudo"?i*a[0]:0;if(e==="inverse"&&Zf(a))throw new ua;let h=n.map(()=>0);return a.forEach((u,d)=>{if(u<=c||u<1e-14)return;let p=u**2+(e==="damped"?s**2:0),f=mi(l[d],t)/p;for(let x of o)h[x]+=f*mi(n[x],l[d])}),{solution:h,smallestSigma:a[Math.min(5,o.length-1)]}}var S_=181,T_=.001,Eh=class{constructor(t,e,i){this.arm=t,this.run=i,this.q=[...e],this.first=Ot(t,e).at(-1),this.every=Math.max(1,Math.ceil(i.steps/(S_-1))),this.kept={path:[e],errors:[0],at:[0]},this.worst={smallestSigma:1/0,largestError:0,fastestRate:0,largestTilt:0}}rates(t,e){let{arm:i,run:s,first:r,worst:o}=this,a=Ot(i,e),{o:l,v:c}=Ui(r.o,s,t),h=s.gain?Is(a.at(-1),{...r,o:l}):[0,0,0,0,0,0],u=[...c,0,0,0].map((f,x)=>f+s.gain*h[x]),{solution:d,smallestSigma:p}=w_(b_(i,e,a,s.mistake),u,s);return o.smallestSigma=Math.min(o.smallestSigma,p),s.mistake==="sign"?d.map(f=>-f):d}stepped(t,e){let{arm:i,run:s,first:r,q:o,worst:a}=this,l=this.rates(s.mistake==="next"?e:t,o);if(a.fastestRate=Math.max(a.fastestRate,...l.map(Math.abs)),s.method==="exact"){let x={...r,o:Ui(r.o,s,e).o};return jf(i,o,x,{lockedJoint:s.locked}).q}let c=s.seconds/s.steps,h=(x,m)=>o.map((g,y)=>g+m*x[y]);if(s.method==="euler")return h(l,c);let u=t+.5/s.steps,d=this.rates(u,h(l,c/2)),p=this.rates(u,h(d,c/2)),f=this.rates(e,h(p,c));return o.map((x,m)=>x+c/6*(l[m]+2*d[m]+2*p[m]+f[m]))}go(t){let{arm:e,run:i,first:s,worst:r,kept:o}=this,a=(t+1)/i.steps;try{this.q=this.stepped(t/i.steps,a)}catch(p){if(p instanceof ua)return!1;throw p}let l=Ot(e,this.q).at(-1),c={...s,o:Ui(s.o,i,a).o},h=Xt(Rt(l.o,c.o)),u=Math.atan2(Xt(Me(l.z,s.z)),he(l.z,s.z));r.largestTilt=Math.max(r.largestTilt,u),r.largestError=Math.max(r.largestError,h);let d=Xt(Is(l,c).slice(0,Ae(e)));return i.method==="exact"&&d>T_?!1:(((t+1)%this.every===0||t+1===i.steps)&&(o.path.push(this.q),o.errors.push(h),o.at.push(a)),Number.isFinite(h))}};function Rh(n,t,e={}){let i={...Ar,...e};i.method==="exact"&&(i.rates="pseudo");let s=new Eh(n,t,i),r=0;for(;r<i.steps&&s.go(r);)r++;let o=dt(n).map(h=>n.rows[h].kind==="revolute"?2*Math.PI:0),a=s.q.map((h,u)=>o[u]?(h-t[u])/o[u]:0),l=r<i.steps?r:null,c=l!==null&&M_(n,s.q,i.locked);return{...s.kept,run:i,...s.worst,failedStep:l,isSingular:c,windings:a}}function Kf(n,t,e={}){let{o:i}=Ot(n,t).at(-1),{path:s}=Rh(n,t,{method:"exact",steps:180,locked:-1,...e});return s.length===1&&s.push(t),{path:s,wantedPath:Array.from({length:181},(r,o)=>Ui(i,e,o/180).o)}}var Qf=(n,t,e)=>t.map(i=>{let s=Ot(n,i),r=qo(We(n,s),e);return Xo(n,s).map((o,a)=>o-r[a])}),E_={method:["euler","rk4","exact"],rates:["inverse","pseudo","damped"],normal:["x","y"],mistake:["","angular","z_i","o_i","sign","next"]},Ch={steps:[10,1e4],seconds:[1,60],radius:[.01,.1],gain:[0,20],cutoff:[1e-9,.1],damping:[.001,.2],locked:[-1,15]},A_=["steps","locked"],Ah=Object.keys(Ar),tp=n=>Ah.map(t=>n[t]).join("_");function ep(n){let t=n.replace(/_([zo])_i$/,"_$1-i").split("_");if(t.length!==Ah.length)return null;let e=Ah.map((i,s)=>[i,R_(i,t[s].replace("-i","_i"))]);return e.some(([,i])=>i===null)?null:Object.fromEntries(e)}function R_(n,t){let e=E_[n];if(e)return e.includes(t)?t:null;let[i,s]=Ch[n],r=t.trim()?Number(t):NaN;return A_.includes(n)&&!Number.isInteger(r)?null:r>=i&&r<=s?r:null}var np=4e3,ip=Object.fromEntries(oh.map(n=>[n[0].toUpperCase(),n])),C_=1e5,P_=8,fa=n=>n?n.split(",").map(t=>t.trim()?Number(t):NaN):[],da=n=>n.map(t=>Number(t.toFixed(6))+0).join(",");function sp({arm:n,base:t,q:e,wrench:i,unit:s,view:r,frames:o,mark:a,runs:l=[]}){let c={arm:t.name,q:da(e),view:r,unit:s,frames:o};if(i.some(Boolean)&&(c.wrench=da(i)),n!==t){let h=u=>`${u.kind[0].toUpperCase()},${da([u.a,u.alpha,u.d,u.theta])}`;c.rows=n.rows.map(h).join(";")}return a&&(c.mark=da(a)),r==="homework"&&l.length&&(c.runs=l.map(tp).join(";")),`#${new URLSearchParams(c)}`}function I_(n,t,e){let i=n.replace(/^#/,"");if(!i||!/(^|&)arm=/.test(i))return{patch:{},message:""};if(i.length>np)return Ph(`it has ${i.length} characters; ${np} are the most`);let s=new URLSearchParams(i),r=t.find(d=>d.name===s.get("arm"));if(!r)return Ph(`there is no arm called “${s.get("arm").slice(0,40)}” here`);let o=U_(s.get("rows")),a=o&&As(o),l=o&&!a?Jo(o,r):r,c=[{patch:{arm:l,base:r,reference:r},fault:a},L_(s,l,!!a),N_(s),D_(s),O_(s),{patch:F_(s,e)}],h=Object.assign({},...c.map(d=>d.patch)),u=c.flatMap(d=>d.fault||[]);return u.length?{...Ph(u.join("; ")),patch:h}:{patch:h,message:""}}function L_(n,t,e){let i=fa(n.get("q"));if(an(t,i))return{patch:{q:i}};let r=n.has("q")&&!e&&`${t.name} has ${dt(t).length} joint values`;return{patch:{q:Oi(t)},fault:r}}function N_(n){if(!n.has("wrench"))return{};let t=fa(n.get("wrench"));return t.length===6&&t.every(i=>Math.abs(i)<=C_)?{patch:{wrench:t}}:{fault:"its wrench is not six numbers in N and N m"}}function D_(n){if(!n.has("mark"))return{patch:{mark:null}};let t=fa(n.get("mark")),e=t.length===3&&t.every(i=>Math.abs(i)<=Yo);return{patch:{mark:e?t:null},fault:!e&&"its mark is no place in metres"}}function O_(n){if(!n.has("runs"))return{};let t=n.get("runs").split(";").map(ep);return t.length<=P_&&!t.includes(null)?{patch:{runs:t}}:{fault:"its runs are none that the homework could make"}}function F_(n,t){let e={view:t,unit:["deg","rad"],frames:["all","ends"]},i=Object.keys(e).filter(s=>e[s].includes(n.get(s)));return Object.fromEntries(i.map(s=>[s,n.get(s)]))}var Ph=n=>({patch:{},message:`Part of the link was left out: ${n}.`});function U_(n){return n===null?null:n.split(";").map(t=>{let[e,...i]=t.split(","),[s,r,o,a]=i.length===4?fa(i.join(",")):[];return{kind:Object.hasOwn(ip,e)?ip[e]:null,a:s,alpha:r,d:o,theta:a}})}function rp(n,t,e,i,s){let r=()=>{let{patch:a,message:l}=I_(location.hash,t,e);n.dispatch({type:"replaceState",...a},"link"),i(l)},o;return r(),addEventListener("hashchange",r,{signal:s}),n.listen((a,l)=>{n.state.dragging||(clearTimeout(o),l!=="link"&&(o=setTimeout(()=>history.replaceState(null,"",sp(n.state)),400)))},s),s.addEventListener("abort",()=>clearTimeout(o)),{copy(){return history.replaceState(null,"",sp(n.state)),Zo(location.href)}}}var op={branches:({arm:n,q:t})=>Yf(n,t),circle:({arm:n,q:t,circle:e})=>Kf(n,t,e),run:({arm:n,q:t,run:e})=>Rh(n,t,e)};var ap="";function lp(n,t,e){let i=()=>e(op[n](t));try{ap||=URL.createObjectURL(new Blob(['(()=>{var j=(t,n)=>t[0]*n[0]+t[1]*n[1]+t[2]*n[2],P=(t,n)=>[t*n[0],t*n[1],t*n[2]],R=(t,n)=>[t[0]+n[0],t[1]+n[1],t[2]+n[2]],b=(t,n)=>[t[0]-n[0],t[1]-n[1],t[2]-n[2]],w=(t,n)=>[t[1]*n[2]-t[2]*n[1],t[2]*n[0]-t[0]*n[2],t[0]*n[1]-t[1]*n[0]],$=t=>Math.sqrt(t.reduce((n,e)=>n+e*e,0)),N=(t,n,e,s)=>[t*n[0]+e*s[0],t*n[1]+e*s[1],t*n[2]+e*s[2]];function F(t){let n=t/(Math.PI/2);return Math.abs(n-Math.round(n))>1e-12?[Math.cos(t),Math.sin(t)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(n)%4+4)%4]}var g=t=>t.rows.flatMap((n,e)=>n.kind==="fixed"?[]:[e]);var D=t=>g(t).map(n=>t.rows[n].kind==="revolute");function x(t,n){let[e,s,o,r]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],a=[{x:e,y:s,z:o,o:r}],l=0;for(let c of t.rows){let p=c.kind==="fixed"?0:n[l++],[i,u]=F(c.kind==="revolute"?c.theta+p:c.theta),[f,h]=F(c.alpha),d=c.kind==="prismatic"?c.d+p:c.d;[e,s]=[N(i,e,u,s),N(i,s,-u,e)],r=R(N(d,o,c.a,e),r),[s,o]=[N(f,s,h,o),N(f,o,-h,s)],a.push({x:e,y:s,z:o,o:r})}return a}function S(t,n,e=n.at(-1).o){return g(t).map(s=>{let{z:o,o:r}=n[s];return t.rows[s].kind==="revolute"?[...w(o,b(e,r)),...o]:[...o,0,0,0]})}var G=(t,n)=>Array.isArray(n)&&n.length===g(t).length&&n.every(Number.isFinite);function z(t){let n=t.kind==="revolute"?Math.PI:1;return[t.lower??-n,t.upper??n]}function k(t,n=6){let e=Array.from({length:n},(r,a)=>t.map(l=>l[a])),s=Array.from({length:n},(r,a)=>Array.from({length:n},(l,c)=>+(a===c)));for(let r=0,a=!0;a&&r<30;r++){a=!1;for(let l=0;l<n;l++)for(let c=l+1;c<n;c++)a=at(e,s,l,c)||a}let o=e.map((r,a)=>[Math.hypot(...r),a]).sort((r,a)=>a[0]-r[0]);return{values:o.map(([r])=>r),vectors:o.map(([,r])=>s[r])}}function at(t,n,e,s){let[o,r,a]=[0,0,0];for(let i=0;i<t[e].length;i++)o+=t[e][i]*t[e][i],r+=t[s][i]*t[s][i],a+=t[e][i]*t[s][i];if(Math.abs(a)<=1e-15*Math.sqrt(o*r)||a*a<1e-60)return!1;let l=(r-o)/(2*a),c=(l<0?-1:1)/(Math.abs(l)+Math.sqrt(1+l*l)),p=1/Math.sqrt(1+c*c);for(let i of[t,n])for(let u=0;u<i[e].length;u++){let[f,h]=[i[e][u],i[s][u]];i[e][u]=p*(f-c*h),i[s][u]=p*(c*f+h)}return!0}function H(t,n){let e=t.map((o,r)=>[...o,n[r]]),s=e.length;for(let o=0;o<s;o++){let r=it(e,o,o);[e[r],e[o]]=[e[o],e[r]];for(let a=0;a<s;a++)a!==o&&ct(e[a],e[o],o)}return e.map((o,r)=>o[s]/o[r])}function it(t,n,e){let s=n;for(let o=n;o<t.length;o++)Math.abs(t[o][e])>Math.abs(t[s][e])&&(s=o);return s}function ct(t,n,e){let s=t[e]/n[e];for(let o=0;o<t.length;o++)t[o]-=s*n[o]}function q(t,n=-1){let e=t.map((l,c)=>c).filter(l=>l!==n);if(!e.length)return[];let s=t[0].map((l,c)=>e.map(p=>t[p][c])),{values:o,vectors:r}=k(s,e.length),a=1e-5*Math.max(o[0],1e-12);return r.filter((l,c)=>o[c]<=a).map(l=>t.map((c,p)=>p===n?0:l[e.indexOf(p)]))}var lt=[[1,0,0],[0,1,0],[0,0,1]];function U({centre:t,radius:n,plane:e,period:s,steps:o,phase:r=0}){let[a,l]=[...e].map(i=>lt["xyz".indexOf(i)]),c=2*Math.PI/s,p=i=>{let u=r+c*i;return[Math.cos(u),Math.sin(u)]};return{times:Array.from({length:o+1},(i,u)=>u===o?s:u*(s/o)),position:i=>{let[u,f]=p(i);return t.map((h,d)=>h+n*(u*a[d]+f*l[d]))},velocity:i=>{let[u,f]=p(i);return t.map((h,d)=>n*c*(u*l[d]-f*a[d]))},normal:w(a,l)}}var _t=["move along","turn about"].flatMap(t=>[..."xyz"].map(n=>`${t} ${n}`));var J=(t,n,e)=>t.map((s,o)=>o===n?e:s);var v=t=>g(t).length<6?3:6;var en="No One Two Three Four Five Six Seven Eight".split(" ");var ut=t=>Math.max(0,g(t).length-v(t));function I(t,n){let e=["x","y","z"].reduce((s,o)=>R(s,w(t[o],n[o])),[0,0,0]);return[...b(n.o,t.o),...P(.5,e)]}var E=(t,n)=>t.reduce((e,s,o)=>e+s*n[o],0),pt=(t,n,e)=>H(t.map((s,o)=>t.map((r,a)=>E(s,r)+(o===a?e:0))),n);function L(t,n,e,{lockedJoint:s=-1,rows:o=v(t),steps:r=60}={}){let a=[...n];for(let l=0;;l++){let c=x(t,a),p=I(c.at(-1),e).slice(0,o),i=$(p);if(i<1e-11||l===r||!a.length)return{q:a,error:i};let u=S(t,c).map((m,M)=>m.slice(0,o).map(A=>M===s?0:A)),f=u.map(m=>E(m,p)),h=pt(u,f,.02*i*i+1e-12),d=Math.max(1e-12,...h.map(Math.abs));a=a.map((m,M)=>m+h[M]*Math.min(1,.6/d))}}var ft={x:["zy",1],y:["zx",-1],z:["yx",1]};function _(t,{normal:n="x",radius:e=.1,seconds:s=1},o){let[r,a]=ft[n],l=t.map((i,u)=>i-("xyz"[u]===r[0]?e:0)),c=U({centre:l,radius:e,plane:r,period:a*s,steps:1}),p=o*s;return{o:c.position(p),v:c.velocity(p)}}var X=.05;function ht(t,n,e){let s=t;for(let o of n.keys())for(let r of[X,-X]){let a=e(J(n,o,n[o]+r));a.error<.98*s.error&&(s=a)}return s}function K(t,n,e,s){let o=l=>L(t,l,e,s),r=o(n);return r.error>1e-6&&wt(r.q,n)?ht(r,n,o):r}function mt(t){return()=>(t=Math.imul(t,1664525)+1013904223>>>0)/2**32}function dt(t,n=Math.random){return g(t).map(e=>{let[s,o]=z(t.rows[e]);return s+(o-s)*n()})}var gt=16;function W(t,n,e=300){let s=x(t,n).at(-1),o=v(t)===6;if(!G(t,n)||!n.length)return{list:[],families:[],lockedJoint:-1,target:s,hasOrientation:o};let r=ut(t)?2:-1,a=mt(1),l=[],c=[],p=i=>{if(l.some(f=>Mt(t,f,i))||c.some(f=>C(t,f,i)<.001))return;let u=xt(t,i,s,r);c.push(i),u.length&&l.push({moving:u,q:i})};p(V(t,n));for(let i=0;i<e&&c.length<gt;i++){let u=dt(t,a).map((d,m)=>m===r?n[m]:d),{q:f,error:h}=L(t,u,s,{lockedJoint:r});h<1e-9&&p(V(t,f))}return{list:c.map(i=>({q:i})),families:l,lockedJoint:r,target:s,hasOrientation:o}}var Y=.1;function xt(t,n,e,s=-1){let o=v(t),r=S(t,x(t,n)).map((p,i)=>p.slice(0,o).map(u=>i===s?0:u)),{values:a}=k(r,o),l=g(t).length-(s<0?0:1);if(a.filter(p=>p>1e-5*a[0]).length>=Math.min(o,l))return[];let c=new Set;for(let p of q(r,s)){let i=n.map((f,h)=>f+Y*p[h]),u=L(t,i,e,{lockedJoint:s,steps:200});u.error>1e-9||C(t,u.q,n)<.3*Y||u.q.forEach((f,h)=>Math.abs(f-n[h])>.001&&c.add(h))}return[...c].sort((p,i)=>p-i)}function Mt(t,{moving:n,q:e},s){let o=s.map((r,a)=>n.includes(a)?e[a]:r);return C(t,e,o)<.001}function V(t,n){return g(t).map((e,s)=>{if(t.rows[e].kind!=="revolute")return n[s];let[o,r]=z(t.rows[e]),a=Math.atan2(Math.sin(n[s]),Math.cos(n[s]));return[a,a+2*Math.PI,a-2*Math.PI].find(l=>l>=o&&l<=r)??a})}function C(t,n,e){let s=(o,r)=>t.rows[o].kind==="revolute"?2*Math.sin((n[r]-e[r])/2):n[r]-e[r];return Math.max(...g(t).map((o,r)=>Math.abs(s(o,r))))}var wt=(t,n)=>t.length===n.length&&t.every((e,s)=>Math.abs(e-n[s])<1e-4);var Q=(t,n)=>({rows:t.rows,q:n,at:g(t),turns:D(t),dof:n.length});function Z(t,n,e={}){let{axis:s=t.at,origin:o=t.at,subtracted:r=!0,point:a=n.length-1,slides:l=!0,crossed:c=!0}=e,p=n[a].o,i=new Array(6*t.dof);return t.at.forEach((u,f)=>{let[h,d]=[n[s[f]].z,n[o[f]].o],m=t.turns[f]||!l,M=r?b(p,d):p,A=m?c?w(h,M):M:h;for(let y=0;y<3;y++)i[y*t.dof+f]=A[y],i[(y+3)*t.dof+f]=m?h[y]:0}),i}var tt=(t,n)=>[...t.slice(0,t.length/2),...n.slice(n.length/2)];var nt={method:"euler",rates:"inverse",steps:1e3,seconds:5,radius:.1,normal:"x",gain:0,cutoff:1e-9,damping:.02,locked:2,mistake:""};function bt(t,n,e,s){let o=Q(t,n),r=o.at.map(p=>p+1),a=p=>Z(o,e,p),c={angular:()=>tt(a({}),a({axis:r})),z_i:()=>a({axis:r,origin:r}),o_i:()=>a({origin:r})}[s]?.()??a({});return n.map((p,i)=>[0,1,2,3,4,5].map(u=>c[u*o.dof+i]))}var T=class extends Error{},ot=(t,n)=>t.map((e,s)=>s).filter(e=>e!==n),et=t=>t[Math.min(5,t.length-1)]<=1e-9*t[0];function $t(t,n,e){let s=S(t,x(t,n));return et(k(ot(s,e).map(o=>s[o])).values)}function yt(t,n,{rates:e,cutoff:s,damping:o,locked:r}){let a=ot(t,r),{values:l,vectors:c}=k(a.map(u=>t[u])),p=e==="pseudo"?s*l[0]:0;if(e==="inverse"&&et(l))throw new T;let i=t.map(()=>0);return l.forEach((u,f)=>{if(u<=p||u<1e-14)return;let h=u**2+(e==="damped"?o**2:0),d=E(c[f],n)/h;for(let m of a)i[m]+=d*E(t[m],c[f])}),{solution:i,smallestSigma:l[Math.min(5,a.length-1)]}}var kt=181,vt=.001,O=class{constructor(n,e,s){this.arm=n,this.run=s,this.q=[...e],this.first=x(n,e).at(-1),this.every=Math.max(1,Math.ceil(s.steps/(kt-1))),this.kept={path:[e],errors:[0],at:[0]},this.worst={smallestSigma:1/0,largestError:0,fastestRate:0,largestTilt:0}}rates(n,e){let{arm:s,run:o,first:r,worst:a}=this,l=x(s,e),{o:c,v:p}=_(r.o,o,n),i=o.gain?I(l.at(-1),{...r,o:c}):[0,0,0,0,0,0],u=[...p,0,0,0].map((d,m)=>d+o.gain*i[m]),{solution:f,smallestSigma:h}=yt(bt(s,e,l,o.mistake),u,o);return a.smallestSigma=Math.min(a.smallestSigma,h),o.mistake==="sign"?f.map(d=>-d):f}stepped(n,e){let{arm:s,run:o,first:r,q:a,worst:l}=this,c=this.rates(o.mistake==="next"?e:n,a);if(l.fastestRate=Math.max(l.fastestRate,...c.map(Math.abs)),o.method==="exact"){let m={...r,o:_(r.o,o,e).o};return K(s,a,m,{lockedJoint:o.locked}).q}let p=o.seconds/o.steps,i=(m,M)=>a.map((A,y)=>A+M*m[y]);if(o.method==="euler")return i(c,p);let u=n+.5/o.steps,f=this.rates(u,i(c,p/2)),h=this.rates(u,i(f,p/2)),d=this.rates(e,i(h,p));return a.map((m,M)=>m+p/6*(c[M]+2*f[M]+2*h[M]+d[M]))}go(n){let{arm:e,run:s,first:o,worst:r,kept:a}=this,l=(n+1)/s.steps;try{this.q=this.stepped(n/s.steps,l)}catch(h){if(h instanceof T)return!1;throw h}let c=x(e,this.q).at(-1),p={...o,o:_(o.o,s,l).o},i=$(b(c.o,p.o)),u=Math.atan2($(w(c.z,o.z)),j(c.z,o.z));r.largestTilt=Math.max(r.largestTilt,u),r.largestError=Math.max(r.largestError,i);let f=$(I(c,p).slice(0,v(e)));return s.method==="exact"&&f>vt?!1:(((n+1)%this.every===0||n+1===s.steps)&&(a.path.push(this.q),a.errors.push(i),a.at.push(l)),Number.isFinite(i))}};function B(t,n,e={}){let s={...nt,...e};s.method==="exact"&&(s.rates="pseudo");let o=new O(t,n,s),r=0;for(;r<s.steps&&o.go(r);)r++;let a=g(t).map(i=>t.rows[i].kind==="revolute"?2*Math.PI:0),l=o.q.map((i,u)=>a[u]?(i-n[u])/a[u]:0),c=r<s.steps?r:null,p=c!==null&&$t(t,o.q,s.locked);return{...o.kept,run:s,...o.worst,failedStep:c,isSingular:p,windings:l}}function st(t,n,e={}){let{o:s}=x(t,n).at(-1),{path:o}=B(t,n,{method:"exact",steps:180,locked:-1,...e});return o.length===1&&o.push(n),{path:o,wantedPath:Array.from({length:181},(r,a)=>_(s,e,a/180).o)}}var kn=Object.keys(nt);var rt={branches:({arm:t,q:n})=>W(t,n),circle:({arm:t,q:n,circle:e})=>st(t,n,e),run:({arm:t,q:n,run:e})=>B(t,n,e)};onmessage=({data:{job:t,input:n}})=>postMessage(rt[t](n));})();\n'],{type:"text/javascript"}));let s=new Worker(ap);return s.onerror=i,s.onmessage=({data:r})=>{s.terminate(),e(r)},s.postMessage({job:n,input:t}),()=>s.terminate()}catch{return i(),()=>{}}}var pa=(n,t)=>new Promise(e=>lp(n,t,e));function Ls(n){let t=()=>{};return(e,i)=>{t(),t=lp(n,e,i)}}var Ji={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Zi={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Vp=0,cu=1,Hp=2;var ms=1,Wp=2,rr=3,Ki=0,sn=1,rn=2,gs=0,or=1,hu=2,uu=3,du=4,$p=5;var xs=100,Xp=101,qp=102,jp=103,Yp=104,Jp=200,Zp=201,Kp=202,Qp=203,fu=204,pu=205,tm=206,em=207,nm=208,im=209,sm=210,rm=211,om=212,am=213,lm=214,za=0,Ga=1,Va=2,js=3,Ha=4,Wa=5,$a=6,Xa=7,mu=0,cm=1,hm=2,oi=0,gu=1,xu=2,_u=3,yu=4,vu=5,bu=6,Mu=7;var wu=300,_s=301,ar=302,Tl=303,El=304,qa=1e3,ii=1001,ja=1002,ze=1003,um=1004;var go=1005;var en=1006,Al=1007;var Ai=1008;var dn=1009,Su=1010,Tu=1011,lr=1012,Rl=1013,jn=1014,Nn=1015,Yn=1016,Cl=1017,Pl=1018,ys=1020,Eu=35902,Au=35899,Ru=1021,Cu=1022,Jn=1023,wi=1026,Ri=1027,Il=1028,Ll=1029,Qi=1030,Nl=1031;var Dl=1033,xo=33776,_o=33777,yo=33778,vo=33779,Ol=35840,Fl=35841,Ul=35842,kl=35843,Bl=36196,zl=37492,Gl=37496,Vl=37488,Hl=37489,bo=37490,Wl=37491,$l=37808,Xl=37809,ql=37810,jl=37811,Yl=37812,Jl=37813,Zl=37814,Kl=37815,Ql=37816,tc=37817,ec=37818,nc=37819,ic=37820,sc=37821,rc=36492,oc=36494,ac=36495,lc=36283,cc=36284,Mo=36285,hc=36286;var zr=2300,Ya=2301,ka=2302,eu=2303,nu=2400,iu=2401,su=2402;var dm=3200;var uc=0,fm=1,Ci="",vn="srgb",Gr="srgb-linear",Vr="linear",ae="srgb";var Ba=7680;var pm=519,mm=512,gm=513,xm=514,Pu=515,_m=516,ym=517,Iu=518,Lu=519,vm=35044,Nu=35048;var Du="300 es",Pn=2e3,Ys=2001;function k_(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function B_(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Hr(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function bm(){let n=Hr("canvas");return n.style.display="block",n}var cp={},Js=null;function Ou(...n){let t="THREE."+n.shift();Js?Js("log",t,...n):console.log(t,...n)}function Mm(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function It(...n){n=Mm(n);let t="THREE."+n.shift();if(Js)Js("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Ft(...n){n=Mm(n);let t="THREE."+n.shift();if(Js)Js("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Or(...n){let t=n.join(" ");t in cp||(cp[t]=!0,It(...n))}function wm(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Sm={[za]:za,[Va]:$a,[Ha]:Ha,[js]:Wa,[Ga]:Ga,[$a]:Va,[Xa]:Xa,[Wa]:js},qn=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},Ye=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],hp=1234567,Fr=Math.PI/180,Zs=180/Math.PI;function cr(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Ye[n&255]+Ye[n>>8&255]+Ye[n>>16&255]+Ye[n>>24&255]+"-"+Ye[t&255]+Ye[t>>8&255]+"-"+Ye[t>>16&15|64]+Ye[t>>24&255]+"-"+Ye[e&63|128]+Ye[e>>8&255]+"-"+Ye[e>>16&255]+Ye[e>>24&255]+Ye[i&255]+Ye[i>>8&255]+Ye[i>>16&255]+Ye[i>>24&255]).toLowerCase()}function qt(n,t,e){return Math.max(t,Math.min(e,n))}function Fu(n,t){return(n%t+t)%t}function z_(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function G_(n,t,e){return n!==t?(e-n)/(t-n):0}function Ur(n,t,e){return(1-e)*n+e*t}function V_(n,t,e,i){return Ur(n,t,1-Math.exp(-e*i))}function H_(n,t=1){return t-Math.abs(Fu(n,t*2)-t)}function W_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function $_(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function X_(n,t){return n+Math.floor(Math.random()*(t-n+1))}function q_(n,t){return n+Math.random()*(t-n)}function j_(n){return n*(.5-Math.random())}function Y_(n){n!==void 0&&(hp=n);let t=hp+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function J_(n){return n*Fr}function Z_(n){return n*Zs}function K_(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function Q_(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Uu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ty(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),d=o((t-i)/2),p=r((i-t)/2),f=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*d,a*c);break;case"YZY":n.set(l*d,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*d,a*h,a*c);break;case"XZX":n.set(a*h,l*f,l*p,a*c);break;case"YXY":n.set(l*p,a*h,l*f,a*c);break;case"ZYZ":n.set(l*f,l*p,a*h,a*c);break;default:It("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function ku(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Tm(n,t){if(t.constructor===Float32Array)return n;let e=ku(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Em(n,t){if(t.constructor===Float32Array)return n;let e=ku(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Bu={DEG2RAD:Fr,RAD2DEG:Zs,generateUUID:cr,clamp:qt,euclideanModulo:Fu,mapLinear:z_,inverseLerp:G_,lerp:Ur,damp:V_,pingpong:H_,smoothstep:W_,smootherstep:$_,randInt:X_,randFloat:q_,randFloatSpread:j_,seededRandom:Y_,degToRad:J_,radToDeg:Z_,isPowerOfTwo:K_,ceilPowerOfTwo:Q_,floorPowerOfTwo:Uu,setQuaternionFromProperEuler:ty,normalize:Em,denormalize:Tm},yt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},nn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],p=r[o+1],f=r[o+2],x=r[o+3];if(u!==x||l!==d||c!==p||h!==f){let m=l*d+c*p+h*f+u*x;m<0&&(d=-d,p=-p,f=-f,x=-x,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),S=Math.sin(y);g=Math.sin(g*y)/S,a=Math.sin(a*y)/S,l=l*g+d*a,c=c*g+p*a,h=h*g+f*a,u=u*g+x*a}else{l=l*g+d*a,c=c*g+p*a,h=h*g+f*a,u=u*g+x*a;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],d=r[o+1],p=r[o+2],f=r[o+3];return t[e]=a*f+h*u+l*p-c*d,t[e+1]=l*f+h*d+c*u-a*p,t[e+2]=c*f+h*p+a*d-l*u,t[e+3]=h*f-a*u-l*d-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),d=l(i/2),p=l(s/2),f=l(r/2);switch(o){case"XYZ":this._x=d*h*u+c*p*f,this._y=c*p*u-d*h*f,this._z=c*h*f+d*p*u,this._w=c*h*u-d*p*f;break;case"YXZ":this._x=d*h*u+c*p*f,this._y=c*p*u-d*h*f,this._z=c*h*f-d*p*u,this._w=c*h*u+d*p*f;break;case"ZXY":this._x=d*h*u-c*p*f,this._y=c*p*u+d*h*f,this._z=c*h*f+d*p*u,this._w=c*h*u-d*p*f;break;case"ZYX":this._x=d*h*u-c*p*f,this._y=c*p*u+d*h*f,this._z=c*h*f-d*p*u,this._w=c*h*u+d*p*f;break;case"YZX":this._x=d*h*u+c*p*f,this._y=c*p*u+d*h*f,this._z=c*h*f-d*p*u,this._w=c*h*u-d*p*f;break;case"XZY":this._x=d*h*u-c*p*f,this._y=c*p*u-d*h*f,this._z=c*h*f+d*p*u,this._w=c*h*u+d*p*f;break;default:It("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let p=.5/Math.sqrt(d+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>u){let p=2*Math.sqrt(1+i-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>u){let p=2*Math.sqrt(1+a-i-u);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+u-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(qt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(up.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(up.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this.z=qt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this.z=qt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Ih.copy(this).projectOnVector(t),this.sub(Ih)}reflect(t){return this.sub(Ih.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Ih=new I,up=new nn,Bt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],d=i[2],p=i[5],f=i[8],x=s[0],m=s[3],g=s[6],y=s[1],S=s[4],w=s[7],A=s[2],E=s[5],_=s[8];return r[0]=o*x+a*y+l*A,r[3]=o*m+a*S+l*E,r[6]=o*g+a*w+l*_,r[1]=c*x+h*y+u*A,r[4]=c*m+h*S+u*E,r[7]=c*g+h*w+u*_,r[2]=d*x+p*y+f*A,r[5]=d*m+p*S+f*E,r[8]=d*g+p*w+f*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,d=a*l-h*r,p=c*r-o*l,f=e*u+i*d+s*p;if(f===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/f;return t[0]=u*x,t[1]=(s*c-h*i)*x,t[2]=(a*i-s*o)*x,t[3]=d*x,t[4]=(h*e-s*l)*x,t[5]=(s*r-a*e)*x,t[6]=p*x,t[7]=(i*l-c*e)*x,t[8]=(o*e-i*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return Or("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Lh.makeScale(t,e)),this}rotate(t){return Or("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Lh.makeRotation(-t)),this}translate(t,e){return Or("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Lh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Lh=new Bt,dp=new Bt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),fp=new Bt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function ey(){let n={enabled:!0,workingColorSpace:Gr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ae&&(s.r=Mi(s.r),s.g=Mi(s.g),s.b=Mi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ae&&(s.r=qs(s.r),s.g=qs(s.g),s.b=qs(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ci?Vr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Gr]:{primaries:t,whitePoint:i,transfer:Vr,toXYZ:dp,fromXYZ:fp,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:vn},outputColorSpaceConfig:{drawingBufferColorSpace:vn}},[vn]:{primaries:t,whitePoint:i,transfer:ae,toXYZ:dp,fromXYZ:fp,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:vn}}}),n}var te=ey();function Mi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function qs(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Ns,Ja=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Ns===void 0&&(Ns=Hr("canvas")),Ns.width=t.width,Ns.height=t.height;let s=Ns.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Ns}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Hr("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Mi(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Mi(e[i]/255)*255):e[i]=Mi(e[i]);return{data:e,width:t.width,height:t.height}}else return It("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},ny=0,Ks=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:ny++}),this.uuid=cr(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Nh(s[o].image)):r.push(Nh(s[o]))}else r=Nh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Nh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ja.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(It("Texture: Unable to serialize Texture."),{})}var iy=0,Dh=new I,cn=class n extends qn{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=ii,s=ii,r=en,o=Ai,a=Jn,l=dn,c=n.DEFAULT_ANISOTROPY,h=Ci){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:iy++}),this.uuid=cr(),this.name="",this.source=new Ks(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new yt(0,0),this.repeat=new yt(1,1),this.center=new yt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Bt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Dh).x}get height(){return this.source.getSize(Dh).y}get depth(){return this.source.getSize(Dh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){It(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){It(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==wu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case qa:t.x=t.x-Math.floor(t.x);break;case ii:t.x=t.x<0?0:1;break;case ja:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case qa:t.y=t.y-Math.floor(t.y);break;case ii:t.y=t.y<0?0:1;break;case ja:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};cn.DEFAULT_IMAGE=null;cn.DEFAULT_MAPPING=wu;cn.DEFAULT_ANISOTROPY=1;var _e=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],d=l[1],p=l[5],f=l[9],x=l[2],m=l[6],g=l[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(f-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(f+m)<.1&&Math.abs(c+p+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(c+1)/2,w=(p+1)/2,A=(g+1)/2,E=(h+d)/4,_=(u+x)/4,M=(f+m)/4;return S>w&&S>A?S<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(S),s=E/i,r=_/i):w>A?w<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(w),i=E/s,r=M/s):A<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),i=_/r,s=M/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-f)*(m-f)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(m-f)/y,this.y=(u-x)/y,this.z=(d-h)/y,this.w=Math.acos((c+p+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=qt(this.x,t.x,e.x),this.y=qt(this.y,t.y,e.y),this.z=qt(this.z,t.z,e.z),this.w=qt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=qt(this.x,t,e),this.y=qt(this.y,t,e),this.z=qt(this.z,t,e),this.w=qt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Za=class extends qn{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:en,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new _e(0,0,t,e),this.scissorTest=!1,this.viewport=new _e(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new cn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:en,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Ks(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},bn=class extends Za{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Wr=class extends cn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ze,this.minFilter=ze,this.wrapR=ii,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Ka=class extends cn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=ze,this.minFilter=ze,this.wrapR=ii,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ne=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,u,d,p,f,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,d,p,f,x,m)}set(t,e,i,s,r,o,a,l,c,h,u,d,p,f,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=h,g[10]=u,g[14]=d,g[3]=p,g[7]=f,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Ds.setFromMatrixColumn(t,0).length(),r=1/Ds.setFromMatrixColumn(t,1).length(),o=1/Ds.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,p=o*u,f=a*h,x=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=p+f*c,e[5]=d-x*c,e[9]=-a*l,e[2]=x-d*c,e[6]=f+p*c,e[10]=o*l}else if(t.order==="YXZ"){let d=l*h,p=l*u,f=c*h,x=c*u;e[0]=d+x*a,e[4]=f*a-p,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=p*a-f,e[6]=x+d*a,e[10]=o*l}else if(t.order==="ZXY"){let d=l*h,p=l*u,f=c*h,x=c*u;e[0]=d-x*a,e[4]=-o*u,e[8]=f+p*a,e[1]=p+f*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let d=o*h,p=o*u,f=a*h,x=a*u;e[0]=l*h,e[4]=f*c-p,e[8]=d*c+x,e[1]=l*u,e[5]=x*c+d,e[9]=p*c-f,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let d=o*l,p=o*c,f=a*l,x=a*c;e[0]=l*h,e[4]=x-d*u,e[8]=f*u+p,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=p*u+f,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*l,p=o*c,f=a*l,x=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=d*u+x,e[5]=o*h,e[9]=p*u-f,e[2]=f*u-p,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(sy,t,ry)}lookAt(t,e,i){let s=this.elements;return _n.subVectors(t,e),_n.lengthSq()===0&&(_n.z=1),_n.normalize(),ki.crossVectors(i,_n),ki.lengthSq()===0&&(Math.abs(i.z)===1?_n.x+=1e-4:_n.z+=1e-4,_n.normalize(),ki.crossVectors(i,_n)),ki.normalize(),ma.crossVectors(_n,ki),s[0]=ki.x,s[4]=ma.x,s[8]=_n.x,s[1]=ki.y,s[5]=ma.y,s[9]=_n.y,s[2]=ki.z,s[6]=ma.z,s[10]=_n.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],d=i[9],p=i[13],f=i[2],x=i[6],m=i[10],g=i[14],y=i[3],S=i[7],w=i[11],A=i[15],E=s[0],_=s[4],M=s[8],O=s[12],N=s[1],F=s[5],B=s[9],W=s[13],P=s[2],H=s[6],q=s[10],V=s[14],nt=s[3],X=s[7],Q=s[11],tt=s[15];return r[0]=o*E+a*N+l*P+c*nt,r[4]=o*_+a*F+l*H+c*X,r[8]=o*M+a*B+l*q+c*Q,r[12]=o*O+a*W+l*V+c*tt,r[1]=h*E+u*N+d*P+p*nt,r[5]=h*_+u*F+d*H+p*X,r[9]=h*M+u*B+d*q+p*Q,r[13]=h*O+u*W+d*V+p*tt,r[2]=f*E+x*N+m*P+g*nt,r[6]=f*_+x*F+m*H+g*X,r[10]=f*M+x*B+m*q+g*Q,r[14]=f*O+x*W+m*V+g*tt,r[3]=y*E+S*N+w*P+A*nt,r[7]=y*_+S*F+w*H+A*X,r[11]=y*M+S*B+w*q+A*Q,r[15]=y*O+S*W+w*V+A*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],d=t[10],p=t[14],f=t[3],x=t[7],m=t[11],g=t[15],y=l*p-c*d,S=a*p-c*u,w=a*d-l*u,A=o*p-c*h,E=o*d-l*h,_=o*u-a*h;return e*(x*y-m*S+g*w)-i*(f*y-m*A+g*E)+s*(f*S-x*A+g*_)-r*(f*w-x*E+m*_)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],d=t[10],p=t[11],f=t[12],x=t[13],m=t[14],g=t[15],y=e*a-i*o,S=e*l-s*o,w=e*c-r*o,A=i*l-s*a,E=i*c-r*a,_=s*c-r*l,M=h*x-u*f,O=h*m-d*f,N=h*g-p*f,F=u*m-d*x,B=u*g-p*x,W=d*g-p*m,P=y*W-S*B+w*F+A*N-E*O+_*M;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/P;return t[0]=(a*W-l*B+c*F)*H,t[1]=(s*B-i*W-r*F)*H,t[2]=(x*_-m*E+g*A)*H,t[3]=(d*E-u*_-p*A)*H,t[4]=(l*N-o*W-c*O)*H,t[5]=(e*W-s*N+r*O)*H,t[6]=(m*w-f*_-g*S)*H,t[7]=(h*_-d*w+p*S)*H,t[8]=(o*B-a*N+c*M)*H,t[9]=(i*N-e*B-r*M)*H,t[10]=(f*E-x*w+g*y)*H,t[11]=(u*w-h*E-p*y)*H,t[12]=(a*O-o*F-l*M)*H,t[13]=(e*F-i*O+s*M)*H,t[14]=(x*S-f*A-m*y)*H,t[15]=(h*A-u*S+d*y)*H,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,d=r*c,p=r*h,f=r*u,x=o*h,m=o*u,g=a*u,y=l*c,S=l*h,w=l*u,A=i.x,E=i.y,_=i.z;return s[0]=(1-(x+g))*A,s[1]=(p+w)*A,s[2]=(f-S)*A,s[3]=0,s[4]=(p-w)*E,s[5]=(1-(d+g))*E,s[6]=(m+y)*E,s[7]=0,s[8]=(f+S)*_,s[9]=(m-y)*_,s[10]=(1-(d+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Ds.set(s[0],s[1],s[2]).length(),a=Ds.set(s[4],s[5],s[6]).length(),l=Ds.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Hn.copy(this);let c=1/o,h=1/a,u=1/l;return Hn.elements[0]*=c,Hn.elements[1]*=c,Hn.elements[2]*=c,Hn.elements[4]*=h,Hn.elements[5]*=h,Hn.elements[6]*=h,Hn.elements[8]*=u,Hn.elements[9]*=u,Hn.elements[10]*=u,e.setFromRotationMatrix(Hn),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Pn,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),p=(i+s)/(i-s),f,x;if(l)f=r/(o-r),x=o*r/(o-r);else if(a===Pn)f=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===Ys)f=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=d,c[12]=0,c[1]=0,c[5]=u,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=f,c[14]=x,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Pn,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),p=-(i+s)/(i-s),f,x;if(l)f=1/(o-r),x=o/(o-r);else if(a===Pn)f=-2/(o-r),x=-(o+r)/(o-r);else if(a===Ys)f=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=d,c[1]=0,c[5]=u,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=f,c[14]=x,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Ds=new I,Hn=new ne,sy=new I(0,0,0),ry=new I(1,1,1),ki=new I,ma=new I,_n=new I,pp=new ne,mp=new nn,Si=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],d=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(qt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,c),this._z=0);break;case"YXZ":this._x=Math.asin(-qt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(qt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-qt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(qt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-qt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:It("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return pp.makeRotationFromQuaternion(t),this.setFromRotationMatrix(pp,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return mp.setFromEuler(this),this.setFromQuaternion(mp,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Si.DEFAULT_ORDER="XYZ";var Qs=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},oy=0,gp=new I,Os=new nn,xi=new ne,ga=new I,Rr=new I,ay=new I,ly=new nn,xp=new I(1,0,0),_p=new I(0,1,0),yp=new I(0,0,1),vp={type:"added"},cy={type:"removed"},Fs={type:"childadded",child:null},Oh={type:"childremoved",child:null},$e=class n extends qn{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:oy++}),this.uuid=cr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new I,e=new Si,i=new nn,s=new I(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ne},normalMatrix:{value:new Bt}}),this.matrix=new ne,this.matrixWorld=new ne,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Qs,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Os.setFromAxisAngle(t,e),this.quaternion.multiply(Os),this}rotateOnWorldAxis(t,e){return Os.setFromAxisAngle(t,e),this.quaternion.premultiply(Os),this}rotateX(t){return this.rotateOnAxis(xp,t)}rotateY(t){return this.rotateOnAxis(_p,t)}rotateZ(t){return this.rotateOnAxis(yp,t)}translateOnAxis(t,e){return gp.copy(t).applyQuaternion(this.quaternion),this.position.add(gp.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(xp,t)}translateY(t){return this.translateOnAxis(_p,t)}translateZ(t){return this.translateOnAxis(yp,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(xi.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?ga.copy(t):ga.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Rr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?xi.lookAt(Rr,ga,this.up):xi.lookAt(ga,Rr,this.up),this.quaternion.setFromRotationMatrix(xi),s&&(xi.extractRotation(s.matrixWorld),Os.setFromRotationMatrix(xi),this.quaternion.premultiply(Os.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Ft("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(vp),Fs.child=t,this.dispatchEvent(Fs),Fs.child=null):Ft("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(cy),Oh.child=t,this.dispatchEvent(Oh),Oh.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),xi.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),xi.multiply(t.parent.matrixWorld)),t.applyMatrix4(xi),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(vp),Fs.child=t,this.dispatchEvent(Fs),Fs.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Rr,t,ay),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Rr,ly,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),p=o(t.animations),f=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),p.length>0&&(i.animations=p),f.length>0&&(i.nodes=f)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};$e.DEFAULT_UP=new I(0,1,0);$e.DEFAULT_MATRIX_AUTO_UPDATE=!0;$e.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ce=class extends $e{constructor(){super(),this.isGroup=!0,this.type="Group"}},hy={type:"move"},tr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ce,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ce,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ce,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,i),g=this._getHandJoint(c,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],d=h.position.distanceTo(u.position),p=.02,f=.005;c.inputState.pinching&&d>p+f?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&d<=p-f&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(hy)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ce;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Am={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Bi={h:0,s:0,l:0},xa={h:0,s:0,l:0};function Fh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var kt=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=vn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,te.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=te.workingColorSpace){return this.r=t,this.g=e,this.b=i,te.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=te.workingColorSpace){if(t=Fu(t,1),e=qt(e,0,1),i=qt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=Fh(o,r,t+1/3),this.g=Fh(o,r,t),this.b=Fh(o,r,t-1/3)}return te.colorSpaceToWorking(this,s),this}setStyle(t,e=vn){function i(r){r!==void 0&&parseFloat(r)<1&&It("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:It("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);It("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=vn){let i=Am[t.toLowerCase()];return i!==void 0?this.setHex(i,e):It("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Mi(t.r),this.g=Mi(t.g),this.b=Mi(t.b),this}copyLinearToSRGB(t){return this.r=qs(t.r),this.g=qs(t.g),this.b=qs(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=vn){return te.workingToColorSpace(Je.copy(this),t),Math.round(qt(Je.r*255,0,255))*65536+Math.round(qt(Je.g*255,0,255))*256+Math.round(qt(Je.b*255,0,255))}getHexString(t=vn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=te.workingColorSpace){te.workingToColorSpace(Je.copy(this),e);let i=Je.r,s=Je.g,r=Je.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=te.workingColorSpace){return te.workingToColorSpace(Je.copy(this),e),t.r=Je.r,t.g=Je.g,t.b=Je.b,t}getStyle(t=vn){te.workingToColorSpace(Je.copy(this),t);let e=Je.r,i=Je.g,s=Je.b;return t!==vn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(Bi),this.setHSL(Bi.h+t,Bi.s+e,Bi.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(Bi),t.getHSL(xa);let i=Ur(Bi.h,xa.h,e),s=Ur(Bi.s,xa.s,e),r=Ur(Bi.l,xa.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Je=new kt;kt.NAMES=Am;var $r=class extends $e{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Si,this.environmentIntensity=1,this.environmentRotation=new Si,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Wn=new I,_i=new I,Uh=new I,yi=new I,Us=new I,ks=new I,bp=new I,kh=new I,Bh=new I,zh=new I,Gh=new _e,Vh=new _e,Hh=new _e,Hi=class n{constructor(t=new I,e=new I,i=new I){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Wn.subVectors(t,e),s.cross(Wn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Wn.subVectors(s,e),_i.subVectors(i,e),Uh.subVectors(t,e);let o=Wn.dot(Wn),a=Wn.dot(_i),l=Wn.dot(Uh),c=_i.dot(_i),h=_i.dot(Uh),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,p=(c*l-a*h)*d,f=(o*h-a*l)*d;return r.set(1-p-f,f,p)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,yi)===null?!1:yi.x>=0&&yi.y>=0&&yi.x+yi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,yi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,yi.x),l.addScaledVector(o,yi.y),l.addScaledVector(a,yi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return Gh.setScalar(0),Vh.setScalar(0),Hh.setScalar(0),Gh.fromBufferAttribute(t,e),Vh.fromBufferAttribute(t,i),Hh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(Gh,r.x),o.addScaledVector(Vh,r.y),o.addScaledVector(Hh,r.z),o}static isFrontFacing(t,e,i,s){return Wn.subVectors(i,e),_i.subVectors(t,e),Wn.cross(_i).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Wn.subVectors(this.c,this.b),_i.subVectors(this.a,this.b),Wn.cross(_i).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Us.subVectors(s,i),ks.subVectors(r,i),kh.subVectors(t,i);let l=Us.dot(kh),c=ks.dot(kh);if(l<=0&&c<=0)return e.copy(i);Bh.subVectors(t,s);let h=Us.dot(Bh),u=ks.dot(Bh);if(h>=0&&u<=h)return e.copy(s);let d=l*u-h*c;if(d<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(Us,o);zh.subVectors(t,r);let p=Us.dot(zh),f=ks.dot(zh);if(f>=0&&p<=f)return e.copy(r);let x=p*c-l*f;if(x<=0&&c>=0&&f<=0)return a=c/(c-f),e.copy(i).addScaledVector(ks,a);let m=h*f-p*u;if(m<=0&&u-h>=0&&p-f>=0)return bp.subVectors(r,s),a=(u-h)/(u-h+(p-f)),e.copy(s).addScaledVector(bp,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(i).addScaledVector(Us,o).addScaledVector(ks,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Mn=class{constructor(t=new I(1/0,1/0,1/0),e=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint($n.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint($n.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=$n.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,$n):$n.fromBufferAttribute(r,o),$n.applyMatrix4(t.matrixWorld),this.expandByPoint($n);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),_a.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),_a.copy(i.boundingBox)),_a.applyMatrix4(t.matrixWorld),this.union(_a)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,$n),$n.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Cr),ya.subVectors(this.max,Cr),Bs.subVectors(t.a,Cr),zs.subVectors(t.b,Cr),Gs.subVectors(t.c,Cr),zi.subVectors(zs,Bs),Gi.subVectors(Gs,zs),cs.subVectors(Bs,Gs);let e=[0,-zi.z,zi.y,0,-Gi.z,Gi.y,0,-cs.z,cs.y,zi.z,0,-zi.x,Gi.z,0,-Gi.x,cs.z,0,-cs.x,-zi.y,zi.x,0,-Gi.y,Gi.x,0,-cs.y,cs.x,0];return!Wh(e,Bs,zs,Gs,ya)||(e=[1,0,0,0,1,0,0,0,1],!Wh(e,Bs,zs,Gs,ya))?!1:(va.crossVectors(zi,Gi),e=[va.x,va.y,va.z],Wh(e,Bs,zs,Gs,ya))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,$n).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize($n).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(vi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),vi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),vi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),vi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),vi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),vi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),vi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),vi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(vi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},vi=[new I,new I,new I,new I,new I,new I,new I,new I],$n=new I,_a=new Mn,Bs=new I,zs=new I,Gs=new I,zi=new I,Gi=new I,cs=new I,Cr=new I,ya=new I,va=new I,hs=new I;function Wh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){hs.fromArray(n,r);let a=s.x*Math.abs(hs.x)+s.y*Math.abs(hs.y)+s.z*Math.abs(hs.z),l=t.dot(hs),c=e.dot(hs),h=i.dot(hs);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var Re=new I,ba=new yt,uy=0,Xn=class extends qn{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:uy++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=vm,this.updateRanges=[],this.gpuType=Nn,this.version=0,this._normalizationScale=t!==void 0?ku(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)ba.fromBufferAttribute(this,e),ba.applyMatrix3(t),this.setXY(e,ba.x,ba.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Re.fromBufferAttribute(this,e),Re.applyMatrix3(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Re.fromBufferAttribute(this,e),Re.applyMatrix4(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Re.fromBufferAttribute(this,e),Re.applyNormalMatrix(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Re.fromBufferAttribute(this,e),Re.transformDirection(t),this.setXYZ(e,Re.x,Re.y,Re.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Tm(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Em(t,this.array)}};var Xr=class extends Xn{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var qr=class extends Xn{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var we=class extends Xn{constructor(t,e,i){super(new Float32Array(t),e,i)}},dy=new Mn,Pr=new I,$h=new I,Ti=class{constructor(t=new I,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):dy.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Pr.subVectors(t,this.center);let e=Pr.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Pr,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):($h.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Pr.copy(t.center).add($h)),this.expandByPoint(Pr.copy(t.center).sub($h))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},fy=0,Cn=new ne,Xh=new $e,Vs=new I,yn=new Mn,Ir=new Mn,Be=new I,hn=class n extends qn{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:fy++}),this.uuid=cr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(k_(t)?qr:Xr)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Bt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Cn.makeRotationFromQuaternion(t),this.applyMatrix4(Cn),this}rotateX(t){return Cn.makeRotationX(t),this.applyMatrix4(Cn),this}rotateY(t){return Cn.makeRotationY(t),this.applyMatrix4(Cn),this}rotateZ(t){return Cn.makeRotationZ(t),this.applyMatrix4(Cn),this}translate(t,e,i){return Cn.makeTranslation(t,e,i),this.applyMatrix4(Cn),this}scale(t,e,i){return Cn.makeScale(t,e,i),this.applyMatrix4(Cn),this}lookAt(t){return Xh.lookAt(t),Xh.updateMatrix(),this.applyMatrix4(Xh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Vs).negate(),this.translate(Vs.x,Vs.y,Vs.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new we(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&It("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Mn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ft("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];yn.setFromBufferAttribute(r),this.morphTargetsRelative?(Be.addVectors(this.boundingBox.min,yn.min),this.boundingBox.expandByPoint(Be),Be.addVectors(this.boundingBox.max,yn.max),this.boundingBox.expandByPoint(Be)):(this.boundingBox.expandByPoint(yn.min),this.boundingBox.expandByPoint(yn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ft('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Ti);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ft("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(t){let i=this.boundingSphere.center;if(yn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Ir.setFromBufferAttribute(a),this.morphTargetsRelative?(Be.addVectors(yn.min,Ir.min),yn.expandByPoint(Be),Be.addVectors(yn.max,Ir.max),yn.expandByPoint(Be)):(yn.expandByPoint(Ir.min),yn.expandByPoint(Ir.max))}yn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Be.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Be));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Be.fromBufferAttribute(a,c),l&&(Vs.fromBufferAttribute(t,c),Be.add(Vs)),s=Math.max(s,i.distanceToSquared(Be))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ft('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Ft("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Xn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let O=0;O<i.count;O++)a[O]=new I,l[O]=new I;let h=new I,u=new I,d=new I,p=new yt,f=new yt,x=new yt,m=new I,g=new I;function y(O,N,F){c[O]=c[N]=c[F]=1,h.fromBufferAttribute(i,O),u.fromBufferAttribute(i,N),d.fromBufferAttribute(i,F),p.fromBufferAttribute(r,O),f.fromBufferAttribute(r,N),x.fromBufferAttribute(r,F),u.sub(h),d.sub(h),f.sub(p),x.sub(p);let B=1/(f.x*x.y-x.x*f.y);isFinite(B)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-f.y).multiplyScalar(B),g.copy(d).multiplyScalar(f.x).addScaledVector(u,-x.x).multiplyScalar(B),a[O].add(m),a[N].add(m),a[F].add(m),l[O].add(g),l[N].add(g),l[F].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let O=0,N=S.length;O<N;++O){let F=S[O],B=F.start,W=F.count;for(let P=B,H=B+W;P<H;P+=3)y(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let w=new I,A=new I,E=new I,_=new I;function M(O){E.fromBufferAttribute(s,O),_.copy(E);let N=a[O];w.copy(N),w.sub(E.multiplyScalar(E.dot(N))).normalize(),A.crossVectors(_,N);let B=A.dot(l[O])<0?-1:1;o.setXYZW(O,w.x,w.y,w.z,B)}for(let O=0,N=i.count;O<N;++O)c[O]&&M(O);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new Xn(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,p=i.count;d<p;d++)i.setXYZ(d,0,0,0);let s=new I,r=new I,o=new I,a=new I,l=new I,c=new I,h=new I,u=new I;if(t)for(let d=0,p=t.count;d<p;d+=3){let f=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,f),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,f),l.fromBufferAttribute(i,x),c.fromBufferAttribute(i,m),a.add(h),l.add(h),c.add(h),i.setXYZ(f,a.x,a.y,a.z),i.setXYZ(x,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let d=0,p=e.count;d<p;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Be.fromBufferAttribute(t,e),Be.normalize(),t.setXYZ(e,Be.x,Be.y,Be.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,d=new c.constructor(l.length*h),p=0,f=0;for(let x=0,m=l.length;x<m;x++){a.isInterleavedBufferAttribute?p=l[x]*a.data.stride+a.offset:p=l[x]*h;for(let g=0;g<h;g++)d[f++]=c[p++]}return new Xn(d,h,u)}if(this.index===null)return It("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let d=c[h],p=t(d,i);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,d=c.length;u<d;u++){let p=c[u];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let d=0,p=u.length;d<p;d++)h.push(u[d].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var qh=new I,py=new I,my=new Bt,Qe=class{constructor(t=new I(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=qh.subVectors(i,e).cross(py.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(qh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||my.getNormalMatrix(t),s=this.coplanarPoint(qh).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},gy=0,si=class extends qn{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:gy++}),this.uuid=cr(),this.name="",this.type="Material",this.blending=or,this.side=Ki,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=fu,this.blendDst=pu,this.blendEquation=xs,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new kt(0,0,0),this.blendAlpha=0,this.depthFunc=js,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=pm,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ba,this.stencilZFail=Ba,this.stencilZPass=Ba,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){It(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){It(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new kt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Qe().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new yt().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new yt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var bi=new I,jh=new I,Ma=new I,wa=new I,Wi=class{constructor(t=new I,e=new I(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,bi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=bi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(bi.copy(this.origin).addScaledVector(this.direction,e),bi.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){jh.copy(t).add(e).multiplyScalar(.5),Ma.copy(e).sub(t).normalize(),wa.copy(this.origin).sub(jh);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Ma),a=wa.dot(this.direction),l=-wa.dot(Ma),c=wa.lengthSq(),h=Math.abs(1-o*o),u,d,p,f;if(h>0)if(u=o*l-a,d=o*a-l,f=r*h,u>=0)if(d>=-f)if(d<=f){let x=1/h;u*=x,d*=x,p=u*(u+o*d+2*a)+d*(o*u+d+2*l)+c}else d=r,u=Math.max(0,-(o*d+a)),p=-u*u+d*(d+2*l)+c;else d=-r,u=Math.max(0,-(o*d+a)),p=-u*u+d*(d+2*l)+c;else d<=-f?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-l),r),p=-u*u+d*(d+2*l)+c):d<=f?(u=0,d=Math.min(Math.max(-r,-l),r),p=d*(d+2*l)+c):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-l),r),p=-u*u+d*(d+2*l)+c);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),p=-u*u+d*(d+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(jh).addScaledVector(Ma,d),p}intersectSphere(t,e){if(t.radius<0)return null;bi.subVectors(t.center,this.origin);let i=bi.dot(this.direction),s=bi.dot(bi)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return c>=0?(i=(t.min.x-d.x)*c,s=(t.max.x-d.x)*c):(i=(t.max.x-d.x)*c,s=(t.min.x-d.x)*c),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,l=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,l=(t.min.z-d.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,bi)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,p=t.z-o.z,f=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=i.x-o.x,y=i.y-o.y,S=i.z-o.z,w=Math.abs(l),A=Math.abs(c),E=Math.abs(h),_,M,O,N,F,B,W,P,H,q,V,nt;if(w>=A&&w>=E?(O=l,B=u,H=f,nt=g,l>=0?(_=c,M=h,N=d,F=p,W=x,P=m,q=y,V=S):(_=h,M=c,N=p,F=d,W=m,P=x,q=S,V=y)):A>=E?(O=c,B=d,H=x,nt=y,c>=0?(_=h,M=l,N=p,F=u,W=m,P=f,q=S,V=g):(_=l,M=h,N=u,F=p,W=f,P=m,q=g,V=S)):(O=h,B=p,H=m,nt=S,h>=0?(_=l,M=c,N=u,F=d,W=f,P=x,q=g,V=y):(_=c,M=l,N=d,F=u,W=x,P=f,q=y,V=g)),O===0)return null;let X=_/O,Q=M/O,tt=1/O,St=N-X*B,Gt=F-Q*B,J=W-X*H,gt=P-Q*H,bt=q-X*nt,Lt=V-Q*nt,xt=bt*gt-Lt*J,Ht=St*Lt-Gt*bt,Te=J*Gt-gt*St;if(s){if(xt<0||Ht<0||Te<0)return null}else if((xt<0||Ht<0||Te<0)&&(xt>0||Ht>0||Te>0))return null;let Dt=xt+Ht+Te;if(Dt===0)return null;let le=tt*(xt*B+Ht*H+Te*nt);return(Dt>0?le<0:le>0)?null:this.at(le/Dt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},un=class extends si{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new kt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Si,this.combine=mu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Mp=new ne,us=new Wi,Sa=new Ti,wp=new I,Ta=new I,Ea=new I,Aa=new I,Yh=new I,Ra=new I,Sp=new I,Ca=new I,Pe=class extends $e{constructor(t=new hn,e=new un){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){Ra.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Yh.fromBufferAttribute(u,t),o?Ra.addScaledVector(Yh,h):Ra.addScaledVector(Yh.sub(e),h))}e.add(Ra)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Sa.copy(i.boundingSphere),Sa.applyMatrix4(r),us.copy(t.ray).recast(t.near),!(Sa.containsPoint(us.origin)===!1&&(us.intersectSphere(Sa,wp)===null||us.origin.distanceToSquared(wp)>(t.far-t.near)**2))&&(Mp.copy(r).invert(),us.copy(t.ray).applyMatrix4(Mp),!(i.boundingBox!==null&&us.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,us)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let f=0,x=d.length;f<x;f++){let m=d[f],g=o[m.materialIndex],y=Math.max(m.start,p.start),S=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let w=y,A=S;w<A;w+=3){let E=a.getX(w),_=a.getX(w+1),M=a.getX(w+2);s=Pa(this,g,t,i,c,h,u,E,_,M),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let f=Math.max(0,p.start),x=Math.min(a.count,p.start+p.count);for(let m=f,g=x;m<g;m+=3){let y=a.getX(m),S=a.getX(m+1),w=a.getX(m+2);s=Pa(this,o,t,i,c,h,u,y,S,w),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let f=0,x=d.length;f<x;f++){let m=d[f],g=o[m.materialIndex],y=Math.max(m.start,p.start),S=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let w=y,A=S;w<A;w+=3){let E=w,_=w+1,M=w+2;s=Pa(this,g,t,i,c,h,u,E,_,M),s&&(s.faceIndex=Math.floor(w/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let f=Math.max(0,p.start),x=Math.min(l.count,p.start+p.count);for(let m=f,g=x;m<g;m+=3){let y=m,S=m+1,w=m+2;s=Pa(this,o,t,i,c,h,u,y,S,w),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function xy(n,t,e,i,s,r,o,a){let l;if(t.side===sn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Ki,a),l===null)return null;Ca.copy(a),Ca.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Ca);return c<e.near||c>e.far?null:{distance:c,point:Ca.clone(),object:n}}function Pa(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,Ta),n.getVertexPosition(l,Ea),n.getVertexPosition(c,Aa);let h=xy(n,t,e,i,Ta,Ea,Aa,Sp);if(h){let u=new I;Hi.getBarycoord(Sp,Ta,Ea,Aa,u),s&&(h.uv=Hi.getInterpolatedAttribute(s,a,l,c,u,new yt)),r&&(h.uv1=Hi.getInterpolatedAttribute(r,a,l,c,u,new yt)),o&&(h.normal=Hi.getInterpolatedAttribute(o,a,l,c,u,new I),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:l,c,normal:new I,materialIndex:0};Hi.getNormal(Ta,Ea,Aa,d.normal),h.face=d,h.barycoord=u}return h}var jr=class extends cn{constructor(t=null,e=1,i=1,s,r,o,a,l,c=ze,h=ze,u,d){super(null,o,a,l,c,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Yr=class extends Xn{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Hs=new ne,Tp=new ne,Ia=[],Ep=new Mn,_y=new ne,Lr=new Pe,Nr=new Ti,Jr=class extends Pe{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Yr(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,_y)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new Mn),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Hs),Ep.copy(t.boundingBox).applyMatrix4(Hs),this.boundingBox.union(Ep)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new Ti),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Hs),Nr.copy(t.boundingSphere).applyMatrix4(Hs),this.boundingSphere.union(Nr)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(Lr.geometry=this.geometry,Lr.material=this.material,Lr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Nr.copy(this.boundingSphere),Nr.applyMatrix4(i),t.ray.intersectsSphere(Nr)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Hs),Tp.multiplyMatrices(i,Hs),Lr.matrixWorld=Tp,Lr.raycast(t,Ia);for(let o=0,a=Ia.length;o<a;o++){let l=Ia[o];l.instanceId=r,l.object=this,e.push(l)}Ia.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Yr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new jr(new Float32Array(s*this.count),s,this.count,Il,Nn));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*t;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},ds=new Ti,yy=new yt(.5,.5),La=new I,$i=class{constructor(t=new Qe,e=new Qe,i=new Qe,s=new Qe,r=new Qe,o=new Qe){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Pn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],d=r[6],p=r[7],f=r[8],x=r[9],m=r[10],g=r[11],y=r[12],S=r[13],w=r[14],A=r[15];if(s[0].setComponents(c-o,p-h,g-f,A-y).normalize(),s[1].setComponents(c+o,p+h,g+f,A+y).normalize(),s[2].setComponents(c+a,p+u,g+x,A+S).normalize(),s[3].setComponents(c-a,p-u,g-x,A-S).normalize(),i)s[4].setComponents(l,d,m,w).normalize(),s[5].setComponents(c-l,p-d,g-m,A-w).normalize();else if(s[4].setComponents(c-l,p-d,g-m,A-w).normalize(),e===Pn)s[5].setComponents(c+l,p+d,g+m,A+w).normalize();else if(e===Ys)s[5].setComponents(l,d,m,w).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),ds.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),ds.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(ds)}intersectsSprite(t){ds.center.set(0,0,0);let e=yy.distanceTo(t.center);return ds.radius=.7071067811865476+e,ds.applyMatrix4(t.matrixWorld),this.intersectsSphere(ds)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(La.x=s.normal.x>0?t.max.x:t.min.x,La.y=s.normal.y>0?t.max.y:t.min.y,La.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(La)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Ap=new ne,Qa=class n{constructor(){this.coordinateSystem=Pn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Ap.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new $i),i[s].setFromProjectionMatrix(Ap,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new $i),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var er=class extends si{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new kt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},tl=new I,el=new I,Rp=new ne,Dr=new Wi,Na=new Ti,Jh=new I,Cp=new I,nl=class extends $e{constructor(t=new hn,e=new er){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)tl.fromBufferAttribute(e,s-1),el.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=tl.distanceTo(el);t.setAttribute("lineDistance",new we(i,1))}else It("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Na.copy(i.boundingSphere),Na.applyMatrix4(s),Na.radius+=r,t.ray.intersectsSphere(Na)===!1)return;Rp.copy(s).invert(),Dr.copy(t.ray).applyMatrix4(Rp);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let p=Math.max(0,o.start),f=Math.min(h.count,o.start+o.count);for(let x=p,m=f-1;x<m;x+=c){let g=h.getX(x),y=h.getX(x+1),S=Da(this,t,Dr,l,g,y,x);S&&e.push(S)}if(this.isLineLoop){let x=h.getX(f-1),m=h.getX(p),g=Da(this,t,Dr,l,x,m,f-1);g&&e.push(g)}}else{let p=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let x=p,m=f-1;x<m;x+=c){let g=Da(this,t,Dr,l,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=Da(this,t,Dr,l,f-1,p,f-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Da(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(tl.fromBufferAttribute(a,s),el.fromBufferAttribute(a,r),e.distanceSqToSegment(tl,el,Jh,Cp)>i)return;Jh.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Jh);if(!(c<t.near||c>t.far))return{distance:c,point:Cp.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Zr=class extends nl{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Kr=class extends cn{constructor(t=[],e=_s,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Ei=class extends cn{constructor(t,e,i=jn,s,r,o,a=ze,l=ze,c,h=wi,u=1){if(h!==wi&&h!==Ri)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Ks(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Qr=class extends Ei{constructor(t,e=jn,i=_s,s,r,o=ze,a=ze,l,c=wi){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},to=class extends cn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Xi=class n extends hn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],d=0,p=0;f("z","y","x",-1,-1,i,e,t,o,r,0),f("z","y","x",1,-1,i,e,-t,o,r,1),f("x","z","y",1,1,t,i,e,s,o,2),f("x","z","y",1,-1,t,i,-e,s,o,3),f("x","y","z",1,-1,t,e,i,s,r,4),f("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new we(c,3)),this.setAttribute("normal",new we(h,3)),this.setAttribute("uv",new we(u,2));function f(x,m,g,y,S,w,A,E,_,M,O){let N=w/_,F=A/M,B=w/2,W=A/2,P=E/2,H=_+1,q=M+1,V=0,nt=0,X=new I;for(let Q=0;Q<q;Q++){let tt=Q*F-W;for(let St=0;St<H;St++){let Gt=St*N-B;X[x]=Gt*y,X[m]=tt*S,X[g]=P,c.push(X.x,X.y,X.z),X[x]=0,X[m]=0,X[g]=E>0?1:-1,h.push(X.x,X.y,X.z),u.push(St/_),u.push(1-Q/M),V+=1}}for(let Q=0;Q<M;Q++)for(let tt=0;tt<_;tt++){let St=d+tt+H*Q,Gt=d+tt+H*(Q+1),J=d+(tt+1)+H*(Q+1),gt=d+(tt+1)+H*Q;l.push(St,Gt,gt),l.push(Gt,J,gt),nt+=6}a.addGroup(p,nt,O),p+=nt,d+=V}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var fs=class n extends hn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],p=[],f=0,x=[],m=i/2,g=0;y(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new we(u,3)),this.setAttribute("normal",new we(d,3)),this.setAttribute("uv",new we(p,2));function y(){let w=new I,A=new I,E=0,_=(e-t)/i;for(let M=0;M<=r;M++){let O=[],N=M/r,F=N*(e-t)+t;for(let B=0;B<=s;B++){let W=B/s,P=W*l+a,H=Math.sin(P),q=Math.cos(P);A.x=F*H,A.y=-N*i+m,A.z=F*q,u.push(A.x,A.y,A.z),w.set(H,_,q).normalize(),d.push(w.x,w.y,w.z),p.push(W,1-N),O.push(f++)}x.push(O)}for(let M=0;M<s;M++)for(let O=0;O<r;O++){let N=x[O][M],F=x[O+1][M],B=x[O+1][M+1],W=x[O][M+1];(t>0||O!==0)&&(h.push(N,F,W),E+=3),(e>0||O!==r-1)&&(h.push(F,B,W),E+=3)}c.addGroup(g,E,0),g+=E}function S(w){let A=f,E=new yt,_=new I,M=0,O=w===!0?t:e,N=w===!0?1:-1;for(let B=1;B<=s;B++)u.push(0,m*N,0),d.push(0,N,0),p.push(.5,.5),f++;let F=f;for(let B=0;B<=s;B++){let P=B/s*l+a,H=Math.cos(P),q=Math.sin(P);_.x=O*q,_.y=m*N,_.z=O*H,u.push(_.x,_.y,_.z),d.push(0,N,0),E.x=H*.5+.5,E.y=q*.5*N+.5,p.push(E.x,E.y),f++}for(let B=0;B<s;B++){let W=A+B,P=F+B;w===!0?h.push(P,P+1,W):h.push(P+1,P,W),M+=3}c.addGroup(g,M,w===!0?1:2),g+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},eo=class n extends fs{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var In=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){It("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)i=this.getPoint(o/t),r+=i.distanceTo(s),e.push(r),s=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),s=0,r=i.length,o;e?o=e:o=t*i[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=i[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,i[s]===o)return s/(r-1);let h=i[s],d=i[s+1]-h,p=(o-h)/d;return(s+p)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new yt:new I);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new I,s=[],r=[],o=[],a=new I,l=new ne;for(let p=0;p<=t;p++){let f=p/t;s[p]=this.getTangentAt(f,new I)}r[0]=new I,o[0]=new I;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=c&&(c=h,i.set(1,0,0)),u<=c&&(c=u,i.set(0,1,0)),d<=c&&i.set(0,0,1),a.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let p=1;p<=t;p++){if(r[p]=r[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(s[p-1],s[p]),a.length()>Number.EPSILON){a.normalize();let f=Math.acos(qt(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(a,f))}o[p].crossVectors(s[p],r[p])}if(e===!0){let p=Math.acos(qt(r[0].dot(r[t]),-1,1));p/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(p=-p);for(let f=1;f<=t;f++)r[f].applyMatrix4(l.makeRotationAxis(s[f],p*f)),o[f].crossVectors(s[f],r[f])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},no=class extends In{constructor(t=0,e=0,i=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new yt){let i=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=l-this.aX,p=c-this.aY;l=d*h-p*u+this.aX,c=d*u+p*h+this.aY}return i.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},il=class extends no{constructor(t,e,i,s,r,o){super(t,e,i,i,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function zu(){let n=0,t=0,e=0,i=0;function s(r,o,a,l){n=r,t=a,e=-3*r+3*o-2*a-l,i=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let d=(o-r)/c-(a-r)/(c+h)+(a-o)/h,p=(a-o)/h-(l-o)/(h+u)+(l-a)/u;d*=h,p*=h,s(o,a,d,p)},calc:function(r){let o=r*r,a=o*r;return n+t*r+e*o+i*a}}}var Pp=new I,Ip=new I,Zh=new zu,Kh=new zu,Qh=new zu,nr=class extends In{constructor(t=[],e=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=s}getPoint(t,e=new I){let i=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(Ip.subVectors(s[0],s[1]).add(s[0]),c=Ip);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(Pp.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Pp),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,f=Math.pow(c.distanceToSquared(u),p),x=Math.pow(u.distanceToSquared(d),p),m=Math.pow(d.distanceToSquared(h),p);x<1e-4&&(x=1),f<1e-4&&(f=x),m<1e-4&&(m=x),Zh.initNonuniformCatmullRom(c.x,u.x,d.x,h.x,f,x,m),Kh.initNonuniformCatmullRom(c.y,u.y,d.y,h.y,f,x,m),Qh.initNonuniformCatmullRom(c.z,u.z,d.z,h.z,f,x,m)}else this.curveType==="catmullrom"&&(Zh.initCatmullRom(c.x,u.x,d.x,h.x,this.tension),Kh.initCatmullRom(c.y,u.y,d.y,h.y,this.tension),Qh.initCatmullRom(c.z,u.z,d.z,h.z,this.tension));return i.set(Zh.calc(l),Kh.calc(l),Qh.calc(l)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new I().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Lp(n,t,e,i,s){let r=(i-t)*.5,o=(s-e)*.5,a=n*n,l=n*a;return(2*e-2*i+r+o)*l+(-3*e+3*i-2*r-o)*a+r*n+e}function vy(n,t){let e=1-n;return e*e*t}function by(n,t){return 2*(1-n)*n*t}function My(n,t){return n*n*t}function kr(n,t,e,i){return vy(n,t)+by(n,e)+My(n,i)}function wy(n,t){let e=1-n;return e*e*e*t}function Sy(n,t){let e=1-n;return 3*e*e*n*t}function Ty(n,t){return 3*(1-n)*n*n*t}function Ey(n,t){return n*n*n*t}function Br(n,t,e,i,s){return wy(n,t)+Sy(n,e)+Ty(n,i)+Ey(n,s)}var sl=class extends In{constructor(t=new yt,e=new yt,i=new yt,s=new yt){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new yt){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(Br(t,s.x,r.x,o.x,a.x),Br(t,s.y,r.y,o.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},rl=class extends In{constructor(t=new I,e=new I,i=new I,s=new I){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new I){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(Br(t,s.x,r.x,o.x,a.x),Br(t,s.y,r.y,o.y,a.y),Br(t,s.z,r.z,o.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},ol=class extends In{constructor(t=new yt,e=new yt){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new yt){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new yt){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},al=class extends In{constructor(t=new I,e=new I){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new I){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new I){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ll=class extends In{constructor(t=new yt,e=new yt,i=new yt){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new yt){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(kr(t,s.x,r.x,o.x),kr(t,s.y,r.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},io=class extends In{constructor(t=new I,e=new I,i=new I){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new I){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(kr(t,s.x,r.x,o.x),kr(t,s.y,r.y,o.y),kr(t,s.z,r.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},cl=class extends In{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new yt){let i=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return i.set(Lp(a,l.x,c.x,h.x,u.x),Lp(a,l.y,c.y,h.y,u.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new yt().fromArray(s))}return this}},Ay=Object.freeze({__proto__:null,ArcCurve:il,CatmullRomCurve3:nr,CubicBezierCurve:sl,CubicBezierCurve3:rl,EllipseCurve:no,LineCurve:ol,LineCurve3:al,QuadraticBezierCurve:ll,QuadraticBezierCurve3:io,SplineCurve:cl});var ps=class n extends hn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,d=e/l,p=[],f=[],x=[],m=[];for(let g=0;g<h;g++){let y=g*d-o;for(let S=0;S<c;S++){let w=S*u-r;f.push(w,-y,0),x.push(0,0,1),m.push(S/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let y=0;y<a;y++){let S=y+c*g,w=y+c*(g+1),A=y+1+c*(g+1),E=y+1+c*g;p.push(S,w,E),p.push(w,A,E)}this.setIndex(p),this.setAttribute("position",new we(f,3)),this.setAttribute("normal",new we(x,3)),this.setAttribute("uv",new we(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var so=class n extends hn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new I,d=new I,p=[],f=[],x=[],m=[];for(let g=0;g<=i;g++){let y=[],S=g/i,w=o+S*a,A=t*Math.cos(w),E=Math.sqrt(t*t-A*A),_=0;g===0&&o===0?_=.5/e:g===i&&l===Math.PI&&(_=-.5/e);for(let M=0;M<=e;M++){let O=M/e,N=s+O*r;u.x=-E*Math.cos(N),u.y=A,u.z=E*Math.sin(N),f.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),m.push(O+_,1-S),y.push(c++)}h.push(y)}for(let g=0;g<i;g++)for(let y=0;y<e;y++){let S=h[g][y+1],w=h[g][y],A=h[g+1][y],E=h[g+1][y+1];(g!==0||o>0)&&p.push(S,w,E),(g!==i-1||l<Math.PI)&&p.push(w,A,E)}this.setIndex(p),this.setAttribute("position",new we(f,3)),this.setAttribute("normal",new we(x,3)),this.setAttribute("uv",new we(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var ro=class n extends hn{constructor(t=new io(new I(-1,-1,0),new I(-1,1,0),new I(1,1,0)),e=64,i=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:i,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new I,l=new I,c=new yt,h=new I,u=[],d=[],p=[],f=[];x(),this.setIndex(f),this.setAttribute("position",new we(u,3)),this.setAttribute("normal",new we(d,3)),this.setAttribute("uv",new we(p,2));function x(){for(let S=0;S<e;S++)m(S);m(r===!1?e:0),y(),g()}function m(S){h=t.getPointAt(S/e,h);let w=o.normals[S],A=o.binormals[S];for(let E=0;E<=s;E++){let _=E/s*Math.PI*2,M=Math.sin(_),O=-Math.cos(_);l.x=O*w.x+M*A.x,l.y=O*w.y+M*A.y,l.z=O*w.z+M*A.z,l.normalize(),d.push(l.x,l.y,l.z),a.x=h.x+i*l.x,a.y=h.y+i*l.y,a.z=h.z+i*l.z,u.push(a.x,a.y,a.z)}}function g(){for(let S=1;S<=e;S++)for(let w=1;w<=s;w++){let A=(s+1)*(S-1)+(w-1),E=(s+1)*S+(w-1),_=(s+1)*S+w,M=(s+1)*(S-1)+w;f.push(A,E,M),f.push(E,_,M)}}function y(){for(let S=0;S<=e;S++)for(let w=0;w<=s;w++)c.x=S/e,c.y=w/s,p.push(c.x,c.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new n(new Ay[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}};var oo=class extends si{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new kt(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function vs(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Np(s))s.isRenderTargetTexture?(It("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Np(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function Ze(n){let t={};for(let e=0;e<n.length;e++){let i=vs(n[e]);for(let s in i)t[s]=i[s]}return t}function Np(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Ry(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Gu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:te.workingColorSpace}var Rm={clone:vs,merge:Ze},Cy=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,Py=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Ln=class extends si{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Cy,this.fragmentShader=Py,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=vs(t.uniforms),this.uniformsGroups=Ry(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new kt().setHex(s.value);break;case"v2":this.uniforms[i].value=new yt().fromArray(s.value);break;case"v3":this.uniforms[i].value=new I().fromArray(s.value);break;case"v4":this.uniforms[i].value=new _e().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Bt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ne().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},hl=class extends Ln{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},ri=class extends si{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new kt(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new kt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=uc,this.normalScale=new yt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Si,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var ul=class extends si{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=dm,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},dl=class extends si{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ws(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Oa(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var qi=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},fl=class extends qi{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:nu,endingEnd:nu}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case iu:r=t,a=2*e-i;break;case su:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case iu:o=t,l=2*i-e;break;case su:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,p=this._weightNext,f=(i-e)/(s-e),x=f*f,m=x*f,g=-d*m+2*d*x-d*f,y=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*f+1,S=(-1-p)*m+(1.5+p)*x+.5*f,w=p*m-p*x;for(let A=0;A!==a;++A)r[A]=g*o[h+A]+y*o[c+A]+S*o[l+A]+w*o[u+A];return r}},pl=class extends qi{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[c+d]*u+o[l+d]*h;return r}},ml=class extends qi{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},gl=class extends qi{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let f=(i-e)/(s-e),x=1-f;for(let m=0;m!==a;++m)r[m]=o[c+m]*x+o[l+m]*f;return r}let d=a*2,p=t-1;for(let f=0;f!==a;++f){let x=o[c+f],m=o[l+f],g=p*d+f*2,y=u[g],S=u[g+1],w=t*d+f*2,A=h[w],E=h[w+1],_=Ly(i,e,y,A,s);r[f]=Cm(_,x,S,E,m)}return r}};function Cm(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function Iy(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function Ly(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=Cm(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=Iy(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var wn=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ws(e,this.TimeBufferType),this.values=Ws(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Ws(t.times,Array),values:Ws(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Oa(t.settings)&&(i.settings={inTangents:Ws(t.settings.inTangents,Array),outTangents:Ws(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new ml(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new pl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new fl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new gl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case zr:e=this.InterpolantFactoryMethodDiscrete;break;case Ya:e=this.InterpolantFactoryMethodLinear;break;case ka:e=this.InterpolantFactoryMethodSmooth;break;case eu:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return It("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return zr;case this.InterpolantFactoryMethodLinear:return Ya;case this.InterpolantFactoryMethodSmooth:return ka;case this.InterpolantFactoryMethodBezier:return eu}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Oa(this.settings)&&(Dp(this.settings.inTangents,t),Dp(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Oa(this.settings)&&(Op(this.settings.inTangents,t),Op(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Ft("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Ft("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Ft("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Ft("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&B_(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Ft("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===ka,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,d=u-i,p=u+i;for(let f=0;f!==i;++f){let x=e[u+f];if(x!==e[d+f]||x!==e[p+f]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let p=0;p!==i;++p)e[d+p]=e[u+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Oa(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Dp(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function Op(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}wn.prototype.ValueTypeName="";wn.prototype.TimeBufferType=Float32Array;wn.prototype.ValueBufferType=Float32Array;wn.prototype.DefaultInterpolation=Ya;var ji=class extends wn{constructor(t,e,i){super(t,e,i)}};ji.prototype.ValueTypeName="bool";ji.prototype.ValueBufferType=Array;ji.prototype.DefaultInterpolation=zr;ji.prototype.InterpolantFactoryMethodLinear=void 0;ji.prototype.InterpolantFactoryMethodSmooth=void 0;var xl=class extends wn{constructor(t,e,i,s){super(t,e,i,s)}};xl.prototype.ValueTypeName="color";var _l=class extends wn{constructor(t,e,i,s){super(t,e,i,s)}};_l.prototype.ValueTypeName="number";var yl=class extends qi{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)nn.slerpFlat(r,0,o,c-a,o,c,l);return r}},ao=class extends wn{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new yl(this.times,this.values,this.getValueSize(),t)}};ao.prototype.ValueTypeName="quaternion";ao.prototype.InterpolantFactoryMethodSmooth=void 0;var Yi=class extends wn{constructor(t,e,i){super(t,e,i)}};Yi.prototype.ValueTypeName="string";Yi.prototype.ValueBufferType=Array;Yi.prototype.DefaultInterpolation=zr;Yi.prototype.InterpolantFactoryMethodLinear=void 0;Yi.prototype.InterpolantFactoryMethodSmooth=void 0;var vl=class extends wn{constructor(t,e,i,s){super(t,e,i,s)}};vl.prototype.ValueTypeName="vector";var bl=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=c.length;u<d;u+=2){let p=c[u],f=c[u+1];if(p.global&&(p.lastIndex=0),p.test(h))return f}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Pm=new bl,Ml=class{constructor(t){this.manager=t!==void 0?t:Pm,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ml.DEFAULT_MATERIAL_NAME="__DEFAULT";var lo=class extends $e{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new kt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},co=class extends lo{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy($e.DEFAULT_UP),this.updateMatrix(),this.groundColor=new kt(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},tu=new ne,Fp=new I,Up=new I,wl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new yt(512,512),this.mapType=dn,this.map=null,this.mapPass=null,this.matrix=new ne,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new $i,this._frameExtents=new yt(1,1),this._viewportCount=1,this._viewports=[new _e(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;Fp.setFromMatrixPosition(t.matrixWorld),e.position.copy(Fp),Up.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Up),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){tu.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(tu,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===Ys||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(tu)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Fa=new I,Ua=new nn,ni=new I,ho=class extends $e{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ne,this.projectionMatrix=new ne,this.projectionMatrixInverse=new ne,this.coordinateSystem=Pn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Fa,Ua,ni),ni.x===1&&ni.y===1&&ni.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fa,Ua,ni.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(Fa,Ua,ni),ni.x===1&&ni.y===1&&ni.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fa,Ua,ni.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Vi=new I,kp=new yt,Bp=new yt,tn=class extends ho{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Zs*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Fr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Zs*2*Math.atan(Math.tan(Fr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Vi.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Vi.x,Vi.y).multiplyScalar(-t/Vi.z),Vi.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Vi.x,Vi.y).multiplyScalar(-t/Vi.z)}getViewSize(t,e){return this.getViewBounds(t,kp,Bp),e.subVectors(Bp,kp)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Fr*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var uo=class extends ho{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},ru=class extends wl{constructor(){super(new uo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},fo=class extends lo{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy($e.DEFAULT_UP),this.updateMatrix(),this.target=new $e,this.shadow=new ru}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var $s=-90,Xs=1,ir=class extends $e{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new tn($s,Xs,t,e);s.layers=this.layers,this.add(s);let r=new tn($s,Xs,t,e);r.layers=this.layers,this.add(r);let o=new tn($s,Xs,t,e);o.layers=this.layers,this.add(o);let a=new tn($s,Xs,t,e);a.layers=this.layers,this.add(a);let l=new tn($s,Xs,t,e);l.layers=this.layers,this.add(l);let c=new tn($s,Xs,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Pn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===Ys)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),f=t.xr.enabled;t.xr.enabled=!1;let x=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=x,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,p),t.xr.enabled=f,i.texture.needsPMREMUpdate=!0}},Sl=class extends tn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Vu="\\[\\]\\.:\\/",Ny=new RegExp("["+Vu+"]","g"),Hu="[^"+Vu+"]",Dy="[^"+Vu.replace("\\.","")+"]",Oy=/((?:WC+[\/:])*)/.source.replace("WC",Hu),Fy=/(WCOD+)?/.source.replace("WCOD",Dy),Uy=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Hu),ky=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Hu),By=new RegExp("^"+Oy+Fy+Uy+ky+"$"),zy=["material","materials","bones","map"],ou=class{constructor(t,e,i){let s=i||pe.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},pe=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(Ny,"")}static parseTrackName(t){let e=By.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);zy.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){It("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Ft("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ft("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ft("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ft("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ft("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Ft("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Ft("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Ft("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Ft("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ft("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};pe.Composite=ou;pe.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};pe.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};pe.prototype.GetterByBindingType=[pe.prototype._getValue_direct,pe.prototype._getValue_array,pe.prototype._getValue_arrayElement,pe.prototype._getValue_toArray];pe.prototype.SetterByBindingTypeAndVersioning=[[pe.prototype._setValue_direct,pe.prototype._setValue_direct_setNeedsUpdate,pe.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[pe.prototype._setValue_array,pe.prototype._setValue_array_setNeedsUpdate,pe.prototype._setValue_array_setMatrixWorldNeedsUpdate],[pe.prototype._setValue_arrayElement,pe.prototype._setValue_arrayElement_setNeedsUpdate,pe.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[pe.prototype._setValue_fromArray,pe.prototype._setValue_fromArray_setNeedsUpdate,pe.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var YP=new Float32Array(1);var zp=new ne,po=class{constructor(t,e,i=0,s=1/0){this.ray=new Wi(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Qs,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Ft("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return zp.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(zp),this}intersectObject(t,e=!0,i=[]){return au(t,this,i,e),i.sort(Gp),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)au(t[s],this,i,e);return i.sort(Gp),i}};function Gp(n,t){return n.distance-t.distance}function au(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)au(r[o],t,e,!0)}}var sr=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=qt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(qt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var lu=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var mo=class extends qn{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Wu(n,t,e,i){let s=Gy(i);switch(e){case Ru:return n*t;case Il:return n*t/s.components*s.byteLength;case Ll:return n*t/s.components*s.byteLength;case Qi:return n*t*2/s.components*s.byteLength;case Nl:return n*t*2/s.components*s.byteLength;case Cu:return n*t*3/s.components*s.byteLength;case Jn:return n*t*4/s.components*s.byteLength;case Dl:return n*t*4/s.components*s.byteLength;case xo:case _o:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case yo:case vo:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Fl:case kl:return Math.max(n,16)*Math.max(t,8)/4;case Ol:case Ul:return Math.max(n,8)*Math.max(t,8)/2;case Bl:case zl:case Vl:case Hl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Gl:case bo:case Wl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case $l:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Xl:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case ql:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case jl:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case Yl:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case Jl:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Zl:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Kl:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Ql:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case tc:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case ec:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case nc:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case ic:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case sc:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case rc:case oc:case ac:return Math.ceil(n/4)*Math.ceil(t/4)*16;case lc:case cc:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Mo:case hc:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Gy(n){switch(n){case dn:case Su:return{byteLength:1,components:1};case lr:case Tu:case Yn:return{byteLength:2,components:1};case Cl:case Pl:return{byteLength:2,components:4};case jn:case Rl:case Nn:return{byteLength:4,components:1};case Eu:case Au:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?It("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Km(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Hy(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,d=n.createBuffer();n.bindBuffer(l,d),n.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:d,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((p,f)=>p.start-f.start);let d=0;for(let p=1;p<u.length;p++){let f=u[d],x=u[p];x.start<=f.start+f.count+1?f.count=Math.max(f.count,x.start+x.count-f.start):(++d,u[d]=x)}u.length=d+1;for(let p=0,f=u.length;p<f;p++){let x=u[p];n.bufferSubData(c,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Wy=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,$y=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,Xy=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,qy=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,jy=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Yy=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Jy=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,Zy=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,Ky=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,Qy=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,tv=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ev=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,nv=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,iv=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,sv=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,rv=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,ov=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,av=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,lv=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,cv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,hv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,uv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,dv=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,fv=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,pv=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,mv=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,gv=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,xv=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,_v=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,yv="gl_FragColor = linearToOutputTexel( gl_FragColor );",vv=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,bv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Mv=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,wv=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Sv=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Tv=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Ev=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Av=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Rv=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Cv=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Pv=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,Iv=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Lv=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Nv=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Dv=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Ov=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,Fv=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Uv=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,kv=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Bv=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,zv=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Gv=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Vv=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,Hv=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Wv=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,$v=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,Xv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,qv=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,jv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Yv=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Jv=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,Zv=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Kv=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,Qv=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,tb=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,eb=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,nb=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,ib=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,sb=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,rb=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,ob=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,ab=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,lb=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,cb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,hb=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ub=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,db=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,fb=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,pb=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,mb=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,gb=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,xb=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,_b=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,yb=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,vb=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,bb=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,Mb=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,wb=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,Sb=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,Tb=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,Eb=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,Ab=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,Rb=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,Cb=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,Pb=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,Ib=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,Lb=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,Nb=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,Db=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,Ob=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Fb=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,Ub=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,kb=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Bb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,zb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Gb=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,Vb=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Hb=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Wb=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,$b=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Xb=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,qb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,jb=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Yb=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,Jb=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,Zb=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,Kb=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,Qb=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,tM=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eM=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,nM=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,iM=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,sM=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,rM=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,oM=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,aM=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,lM=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,cM=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,hM=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,uM=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,dM=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,fM=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,pM=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,mM=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,gM=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,xM=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,_M=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,yM=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,vM=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,bM=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,MM=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,jt={alphahash_fragment:Wy,alphahash_pars_fragment:$y,alphamap_fragment:Xy,alphamap_pars_fragment:qy,alphatest_fragment:jy,alphatest_pars_fragment:Yy,aomap_fragment:Jy,aomap_pars_fragment:Zy,batching_pars_vertex:Ky,batching_vertex:Qy,begin_vertex:tv,beginnormal_vertex:ev,bsdfs:nv,iridescence_fragment:iv,bumpmap_pars_fragment:sv,clipping_planes_fragment:rv,clipping_planes_pars_fragment:ov,clipping_planes_pars_vertex:av,clipping_planes_vertex:lv,color_fragment:cv,color_pars_fragment:hv,color_pars_vertex:uv,color_vertex:dv,common:fv,defaultnormal_vertex:pv,displacementmap_pars_vertex:mv,displacementmap_vertex:gv,emissivemap_fragment:xv,emissivemap_pars_fragment:_v,colorspace_fragment:yv,colorspace_pars_fragment:vv,envmap_fragment:bv,envmap_common_pars_fragment:Mv,envmap_pars_fragment:wv,envmap_pars_vertex:Sv,envmap_physical_pars_fragment:Ov,envmap_vertex:Tv,fog_vertex:Ev,fog_pars_vertex:Av,fog_fragment:Rv,fog_pars_fragment:Cv,gradientmap_pars_fragment:Pv,lightmap_pars_fragment:Iv,lights_lambert_fragment:Lv,lights_lambert_pars_fragment:Nv,lights_pars_begin:Dv,lights_toon_fragment:Fv,lights_toon_pars_fragment:Uv,lights_phong_fragment:kv,lights_phong_pars_fragment:Bv,lights_physical_fragment:zv,lights_physical_pars_fragment:Gv,lights_fragment_begin:Vv,lights_fragment_maps:Hv,lights_fragment_end:Wv,lightprobes_pars_fragment:$v,logdepthbuf_fragment:Xv,logdepthbuf_pars_fragment:qv,logdepthbuf_pars_vertex:jv,logdepthbuf_vertex:Yv,map_fragment:Jv,map_pars_fragment:Zv,map_particle_fragment:Kv,map_particle_pars_fragment:Qv,metalnessmap_fragment:tb,metalnessmap_pars_fragment:eb,morphinstance_vertex:nb,morphcolor_vertex:ib,morphnormal_vertex:sb,morphtarget_pars_vertex:rb,morphtarget_vertex:ob,normal_fragment_begin:ab,normal_fragment_maps:lb,normal_pars_fragment:cb,normal_pars_vertex:hb,normal_vertex:ub,normalmap_pars_fragment:db,clearcoat_normal_fragment_begin:fb,clearcoat_normal_fragment_maps:pb,clearcoat_pars_fragment:mb,iridescence_pars_fragment:gb,opaque_fragment:xb,packing:_b,premultiplied_alpha_fragment:yb,project_vertex:vb,dithering_fragment:bb,dithering_pars_fragment:Mb,roughnessmap_fragment:wb,roughnessmap_pars_fragment:Sb,shadowmap_pars_fragment:Tb,shadowmap_pars_vertex:Eb,shadowmap_vertex:Ab,shadowmask_pars_fragment:Rb,skinbase_vertex:Cb,skinning_pars_vertex:Pb,skinning_vertex:Ib,skinnormal_vertex:Lb,specularmap_fragment:Nb,specularmap_pars_fragment:Db,tonemapping_fragment:Ob,tonemapping_pars_fragment:Fb,transmission_fragment:Ub,transmission_pars_fragment:kb,uv_pars_fragment:Bb,uv_pars_vertex:zb,uv_vertex:Gb,worldpos_vertex:Vb,background_vert:Hb,background_frag:Wb,backgroundCube_vert:$b,backgroundCube_frag:Xb,cube_vert:qb,cube_frag:jb,depth_vert:Yb,depth_frag:Jb,distance_vert:Zb,distance_frag:Kb,equirect_vert:Qb,equirect_frag:tM,linedashed_vert:eM,linedashed_frag:nM,meshbasic_vert:iM,meshbasic_frag:sM,meshlambert_vert:rM,meshlambert_frag:oM,meshmatcap_vert:aM,meshmatcap_frag:lM,meshnormal_vert:cM,meshnormal_frag:hM,meshphong_vert:uM,meshphong_frag:dM,meshphysical_vert:fM,meshphysical_frag:pM,meshtoon_vert:mM,meshtoon_frag:gM,points_vert:xM,points_frag:_M,shadow_vert:yM,shadow_frag:vM,sprite_vert:bM,sprite_frag:MM},mt={common:{diffuse:{value:new kt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Bt},alphaMap:{value:null},alphaMapTransform:{value:new Bt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Bt}},envmap:{envMap:{value:null},envMapRotation:{value:new Bt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Bt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Bt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Bt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Bt},normalScale:{value:new yt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Bt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Bt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Bt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Bt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new kt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new kt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Bt},alphaTest:{value:0},uvTransform:{value:new Bt}},sprite:{diffuse:{value:new kt(16777215)},opacity:{value:1},center:{value:new yt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Bt},alphaMap:{value:null},alphaMapTransform:{value:new Bt},alphaTest:{value:0}}},li={basic:{uniforms:Ze([mt.common,mt.specularmap,mt.envmap,mt.aomap,mt.lightmap,mt.fog]),vertexShader:jt.meshbasic_vert,fragmentShader:jt.meshbasic_frag},lambert:{uniforms:Ze([mt.common,mt.specularmap,mt.envmap,mt.aomap,mt.lightmap,mt.emissivemap,mt.bumpmap,mt.normalmap,mt.displacementmap,mt.fog,mt.lights,{emissive:{value:new kt(0)},envMapIntensity:{value:1}}]),vertexShader:jt.meshlambert_vert,fragmentShader:jt.meshlambert_frag},phong:{uniforms:Ze([mt.common,mt.specularmap,mt.envmap,mt.aomap,mt.lightmap,mt.emissivemap,mt.bumpmap,mt.normalmap,mt.displacementmap,mt.fog,mt.lights,{emissive:{value:new kt(0)},specular:{value:new kt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:jt.meshphong_vert,fragmentShader:jt.meshphong_frag},standard:{uniforms:Ze([mt.common,mt.envmap,mt.aomap,mt.lightmap,mt.emissivemap,mt.bumpmap,mt.normalmap,mt.displacementmap,mt.roughnessmap,mt.metalnessmap,mt.fog,mt.lights,{emissive:{value:new kt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:jt.meshphysical_vert,fragmentShader:jt.meshphysical_frag},toon:{uniforms:Ze([mt.common,mt.aomap,mt.lightmap,mt.emissivemap,mt.bumpmap,mt.normalmap,mt.displacementmap,mt.gradientmap,mt.fog,mt.lights,{emissive:{value:new kt(0)}}]),vertexShader:jt.meshtoon_vert,fragmentShader:jt.meshtoon_frag},matcap:{uniforms:Ze([mt.common,mt.bumpmap,mt.normalmap,mt.displacementmap,mt.fog,{matcap:{value:null}}]),vertexShader:jt.meshmatcap_vert,fragmentShader:jt.meshmatcap_frag},points:{uniforms:Ze([mt.points,mt.fog]),vertexShader:jt.points_vert,fragmentShader:jt.points_frag},dashed:{uniforms:Ze([mt.common,mt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:jt.linedashed_vert,fragmentShader:jt.linedashed_frag},depth:{uniforms:Ze([mt.common,mt.displacementmap]),vertexShader:jt.depth_vert,fragmentShader:jt.depth_frag},normal:{uniforms:Ze([mt.common,mt.bumpmap,mt.normalmap,mt.displacementmap,{opacity:{value:1}}]),vertexShader:jt.meshnormal_vert,fragmentShader:jt.meshnormal_frag},sprite:{uniforms:Ze([mt.sprite,mt.fog]),vertexShader:jt.sprite_vert,fragmentShader:jt.sprite_frag},background:{uniforms:{uvTransform:{value:new Bt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:jt.background_vert,fragmentShader:jt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Bt}},vertexShader:jt.backgroundCube_vert,fragmentShader:jt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:jt.cube_vert,fragmentShader:jt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:jt.equirect_vert,fragmentShader:jt.equirect_frag},distance:{uniforms:Ze([mt.common,mt.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:jt.distance_vert,fragmentShader:jt.distance_frag},shadow:{uniforms:Ze([mt.lights,mt.fog,{color:{value:new kt(0)},opacity:{value:1}}]),vertexShader:jt.shadow_vert,fragmentShader:jt.shadow_frag}};li.physical={uniforms:Ze([li.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Bt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Bt},clearcoatNormalScale:{value:new yt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Bt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Bt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Bt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Bt},sheen:{value:0},sheenColor:{value:new kt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Bt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Bt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Bt},transmissionSamplerSize:{value:new yt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Bt},attenuationDistance:{value:0},attenuationColor:{value:new kt(0)},specularColor:{value:new kt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Bt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Bt},anisotropyVector:{value:new yt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Bt}}]),vertexShader:jt.meshphysical_vert,fragmentShader:jt.meshphysical_frag};var dc={r:0,b:0,g:0},wM=new ne,Qm=new Bt;Qm.set(-1,0,0,0,1,0,0,0,1);function SM(n,t,e,i,s,r){let o=new kt(0),a=s===!0?0:1,l,c,h=null,u=0,d=null;function p(y){let S=y.isScene===!0?y.background:null;if(S&&S.isTexture){let w=y.backgroundBlurriness>0;S=t.get(S,w)}return S}function f(y){let S=!1,w=p(y);w===null?m(o,a):w&&w.isColor&&(m(w,1),S=!0);let A=n.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||S)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function x(y,S){let w=p(S);w&&w.isCubeTexture?(c===void 0&&(c=new Pe(new Xi(1,1,1),new Ln({name:"BackgroundCubeMaterial",uniforms:vs(li.backgroundCube.uniforms),vertexShader:li.backgroundCube.vertexShader,fragmentShader:li.backgroundCube.fragmentShader,side:sn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(A,E,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=w,c.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(wM.makeRotationFromEuler(S.backgroundRotation)).transpose(),w.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Qm),c.material.toneMapped=te.getTransfer(w.colorSpace)!==ae,(h!==w||u!==w.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=w,u=w.version,d=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):w&&w.isTexture&&(l===void 0&&(l=new Pe(new ps(2,2),new Ln({name:"BackgroundMaterial",uniforms:vs(li.background.uniforms),vertexShader:li.background.vertexShader,fragmentShader:li.background.fragmentShader,side:Ki,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=w,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.toneMapped=te.getTransfer(w.colorSpace)!==ae,w.matrixAutoUpdate===!0&&w.updateMatrix(),l.material.uniforms.uvTransform.value.copy(w.matrix),(h!==w||u!==w.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=w,u=w.version,d=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,S){y.getRGB(dc,Gu(n)),e.buffers.color.setClear(dc.r,dc.g,dc.b,S,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,S=1){o.set(y),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:f,addToRenderList:x,dispose:g}}function TM(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(F,B,W,P,H){let q=!1,V=u(F,P,W,B);r!==V&&(r=V,c(r.object)),q=p(F,P,W,H),q&&f(F,P,W,H),H!==null&&t.update(H,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,w(F,B,W,P),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function l(){return n.createVertexArray()}function c(F){return n.bindVertexArray(F)}function h(F){return n.deleteVertexArray(F)}function u(F,B,W,P){let H=P.wireframe===!0,q=i[B.id];q===void 0&&(q={},i[B.id]=q);let V=F.isInstancedMesh===!0?F.id:0,nt=q[V];nt===void 0&&(nt={},q[V]=nt);let X=nt[W.id];X===void 0&&(X={},nt[W.id]=X);let Q=X[H];return Q===void 0&&(Q=d(l()),X[H]=Q),Q}function d(F){let B=[],W=[],P=[];for(let H=0;H<e;H++)B[H]=0,W[H]=0,P[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:B,enabledAttributes:W,attributeDivisors:P,object:F,attributes:{},index:null}}function p(F,B,W,P){let H=r.attributes,q=B.attributes,V=0,nt=W.getAttributes();for(let X in nt)if(nt[X].location>=0){let tt=H[X],St=q[X];if(St===void 0&&(X==="instanceMatrix"&&F.instanceMatrix&&(St=F.instanceMatrix),X==="instanceColor"&&F.instanceColor&&(St=F.instanceColor)),tt===void 0||tt.attribute!==St||St&&tt.data!==St.data)return!0;V++}return r.attributesNum!==V||r.index!==P}function f(F,B,W,P){let H={},q=B.attributes,V=0,nt=W.getAttributes();for(let X in nt)if(nt[X].location>=0){let tt=q[X];tt===void 0&&(X==="instanceMatrix"&&F.instanceMatrix&&(tt=F.instanceMatrix),X==="instanceColor"&&F.instanceColor&&(tt=F.instanceColor));let St={};St.attribute=tt,tt&&tt.data&&(St.data=tt.data),H[X]=St,V++}r.attributes=H,r.attributesNum=V,r.index=P}function x(){let F=r.newAttributes;for(let B=0,W=F.length;B<W;B++)F[B]=0}function m(F){g(F,0)}function g(F,B){let W=r.newAttributes,P=r.enabledAttributes,H=r.attributeDivisors;W[F]=1,P[F]===0&&(n.enableVertexAttribArray(F),P[F]=1),H[F]!==B&&(n.vertexAttribDivisor(F,B),H[F]=B)}function y(){let F=r.newAttributes,B=r.enabledAttributes;for(let W=0,P=B.length;W<P;W++)B[W]!==F[W]&&(n.disableVertexAttribArray(W),B[W]=0)}function S(F,B,W,P,H,q,V){V===!0?n.vertexAttribIPointer(F,B,W,H,q):n.vertexAttribPointer(F,B,W,P,H,q)}function w(F,B,W,P){x();let H=P.attributes,q=W.getAttributes(),V=B.defaultAttributeValues;for(let nt in q){let X=q[nt];if(X.location>=0){let Q=H[nt];if(Q===void 0&&(nt==="instanceMatrix"&&F.instanceMatrix&&(Q=F.instanceMatrix),nt==="instanceColor"&&F.instanceColor&&(Q=F.instanceColor)),Q!==void 0){let tt=Q.normalized,St=Q.itemSize,Gt=t.get(Q);if(Gt===void 0)continue;let J=Gt.buffer,gt=Gt.type,bt=Gt.bytesPerElement,Lt=gt===n.INT||gt===n.UNSIGNED_INT||Q.gpuType===Rl;if(Q.isInterleavedBufferAttribute){let xt=Q.data,Ht=xt.isInterleavedBuffer===!0?xt.stride:xt.itemSize,Te=Q.offset;if(xt.isInstancedInterleavedBuffer||xt.isInstancedBufferAttribute){for(let Dt=0;Dt<X.locationSize;Dt++)g(X.location+Dt,xt.meshPerAttribute);F.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=xt.meshPerAttribute*xt.count)}else for(let Dt=0;Dt<X.locationSize;Dt++)m(X.location+Dt);n.bindBuffer(n.ARRAY_BUFFER,J);for(let Dt=0;Dt<X.locationSize;Dt++)S(X.location+Dt,St/X.locationSize,gt,tt,Ht*bt,(Te+St/X.locationSize*Dt)*bt,Lt)}else{if(Q.isInstancedBufferAttribute){for(let xt=0;xt<X.locationSize;xt++)g(X.location+xt,Q.meshPerAttribute);F.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let xt=0;xt<X.locationSize;xt++)m(X.location+xt);n.bindBuffer(n.ARRAY_BUFFER,J);for(let xt=0;xt<X.locationSize;xt++)S(X.location+xt,St/X.locationSize,gt,tt,St*bt,St/X.locationSize*xt*bt,Lt)}}else if(V!==void 0){let tt=V[nt];if(tt!==void 0)switch(tt.length){case 2:n.vertexAttrib2fv(X.location,tt);break;case 3:n.vertexAttrib3fv(X.location,tt);break;case 4:n.vertexAttrib4fv(X.location,tt);break;default:n.vertexAttrib1fv(X.location,tt)}}}}y()}function A(){O();for(let F in i){let B=i[F];for(let W in B){let P=B[W];for(let H in P){let q=P[H];for(let V in q)h(q[V].object),delete q[V];delete P[H]}}delete i[F]}}function E(F){if(i[F.id]===void 0)return;let B=i[F.id];for(let W in B){let P=B[W];for(let H in P){let q=P[H];for(let V in q)h(q[V].object),delete q[V];delete P[H]}}delete i[F.id]}function _(F){for(let B in i){let W=i[B];for(let P in W){let H=W[P];if(H[F.id]===void 0)continue;let q=H[F.id];for(let V in q)h(q[V].object),delete q[V];delete H[F.id]}}}function M(F){for(let B in i){let W=i[B],P=F.isInstancedMesh===!0?F.id:0,H=W[P];if(H!==void 0){for(let q in H){let V=H[q];for(let nt in V)h(V[nt].object),delete V[nt];delete H[q]}delete W[P],Object.keys(W).length===0&&delete i[B]}}}function O(){N(),o=!0,r!==s&&(r=s,c(r.object))}function N(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:O,resetDefaultState:N,dispose:A,releaseStatesOfGeometry:E,releaseStatesOfObject:M,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:y}}function EM(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let d=0;for(let p=0;p<h;p++)d+=c[p];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function AM(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Jn&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let M=_===Yn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==dn&&_!==Nn&&!M&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(It("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&It("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&It("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),f=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),S=n.getParameter(n.MAX_VARYING_VECTORS),w=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),A=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:p,maxVertexTextures:f,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:S,maxFragmentUniforms:w,maxSamples:A,samples:E}}function RM(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Qe,a=new Bt,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let p=u.length!==0||d||i!==0||s;return s=d,i=u.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,p){let f=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=n.get(u);if(!s||f===null||f.length===0||r&&!m)r?h(null):c();else{let y=r?0:i,S=y*4,w=g.clippingState||null;l.value=w,w=h(f,d,S,p);for(let A=0;A!==S;++A)w[A]=e[A];g.clippingState=w,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,p,f){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=l.value,f!==!0||m===null){let g=p+x*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let S=0,w=p;S!==x;++S,w+=4)o.copy(u[S]).applyMatrix4(y,a),o.normal.toArray(m,w),m[w+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var To=class extends bn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Kr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Xi(5,5,5),r=new Ln({name:"CubemapFromEquirect",uniforms:vs(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:sn,blending:gs});r.uniforms.tEquirect.value=e;let o=new Pe(s,r),a=e.minFilter;return e.minFilter===Ai&&(e.minFilter=en),new ir(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Im=256,CM=3,PM=20,tg=256,eg=16,IM=3,LM=new I,NM=new kt,pc=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ir(1,10,null),this._boxMesh=new Pe(new Xi(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=LM}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,d=l.autoClearColor,p=l.autoClearDepth,f=l.autoClearStencil,x=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,x===null&&(t.background=l.getClearColor(NM));let m=new ir(i,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=d,l.autoClearDepth=p,l.autoClearStencil=f,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Dm(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Nm(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Im,Uu(t))}_fromTexture(t,e){t.mapping===_s||t.mapping===ar?this._setSize(t.image.length===0?Im:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Lm(t,!1,!1),i=Math.log2(t)-CM;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Lm(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===_s||t.mapping===ar?(this._cubemapMaterial===null&&(this._cubemapMaterial=Dm()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Nm()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=DM(),this._integrationMaterial=OM());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/eg);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-IM)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(tg*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=FM());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Lm(n,t,e){return new To(n,{minFilter:Ai,generateMipmaps:t,type:Yn,colorSpace:Gr,depthBuffer:e})}function Eo(n,t,e){return new Ln({name:n,uniforms:t,vertexShader:jt.cube_vert,fragmentShader:e,side:sn,blending:gs,depthTest:!1,depthWrite:!1})}function DM(){return Eo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${tg}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function OM(){return Eo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:eg}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function FM(){return Eo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${PM}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function Nm(){return Eo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function Dm(){return Eo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function UM(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,p=!1){return d==null?null:p?o(d):r(d)}function r(d){if(d&&d.isTexture){let p=d.mapping;if(p===Tl||p===El)if(t.has(d)){let f=t.get(d).texture;return a(f,d.mapping)}else{let f=d.image;if(f&&f.height>0){let x=new To(f.height);return x.fromEquirectangularTexture(n,d),t.set(d,x),d.addEventListener("dispose",c),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let p=d.mapping,f=p===Tl||p===El,x=p===_s||p===ar;if(f||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return i===null&&(i=new pc(n)),m=f?i.fromEquirectangular(d,m):i.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return f&&y&&y.height>0||x&&y&&l(y)?(i===null&&(i=new pc(n)),m=f?i.fromEquirectangular(d):i.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,p){return p===Tl?d.mapping=_s:p===El&&(d.mapping=ar),d}function l(d){let p=0,f=6;for(let x=0;x<f;x++)d[x]!==void 0&&p++;return p===f}function c(d){let p=d.target;p.removeEventListener("dispose",c);let f=t.get(p);f!==void 0&&(t.delete(p),f.dispose())}function h(d){let p=d.target;p.removeEventListener("dispose",h);let f=e.get(p);f!==void 0&&(e.delete(p),f.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function kM(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Or("WebGLRenderer: "+i+" extension not supported."),s}}}function BM(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(f=>delete s[f]);function a(f){l(f.target)}function l(f){f.index!==null&&t.remove(f.index);for(let m in f.attributes)t.remove(f.attributes[m]);f.removeEventListener("dispose",a),delete s[f.id],o.unregister(f);let x=r.get(f);x&&(t.remove(x),r.delete(f)),i.releaseStatesOfGeometry(f),f.isInstancedBufferGeometry===!0&&delete f._maxInstanceCount,e.memory.geometries--}function c(f,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(f){let x=f.attributes;for(let m in x)t.update(x[m],n.ARRAY_BUFFER)}function u(f){let x=f.index,m=f.attributes.position,g=0;if(m===void 0)return;let y=x!==null?x.array.length:m.array.length/3-1,S=m.count>=65535?qr:Xr,w=new S(Math.ceil(y/3)*6,1),A=w.array;if(x!==null){let _=x.array;g=x.version;for(let M=0,O=0;M<y;M+=3){let N=_[M+0],F=_[M+1],B=_[M+2];A[O++]=N,A[O++]=F,A[O++]=F,A[O++]=B,A[O++]=B,A[O++]=N}}else{g=m.version;for(let _=0,M=0;_<y;_+=3){let O=_+0,N=_+1,F=_+2;A[M++]=O,A[M++]=N,A[M++]=N,A[M++]=F,A[M++]=F,A[M++]=O}}w.version=g;let E=r.get(f);E&&t.remove(E),r.set(f,w)}function d(f){let x=r.get(f);if(x){let m=f.index;m!==null&&x.version<m.version&&u(f)}else u(f);return r.get(f)}function p(){for(let f in s){let x=s[f].deref();x!==void 0&&l(x)}}return{get:c,update:h,getWireframeAttribute:d,dispose:p}}function zM(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,d){n.drawElements(i,d,r,u*o),e.update(d,i,1)}function c(u,d,p){p!==0&&(n.drawElementsInstanced(i,d,r,u*o,p),e.update(d,i,p))}function h(u,d,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,p);let x=0;for(let m=0;m<p;m++)x+=d[m];e.update(x,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function GM(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Ft("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function VM(n,t,e){let i=new WeakMap,s=new _e;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let O=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",O)};d!==void 0&&d.texture.dispose();let p=a.morphAttributes.position!==void 0,f=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],S=0;p===!0&&(S=1),f===!0&&(S=2),x===!0&&(S=3);let w=a.attributes.position.count*S,A=1;w>t.maxTextureSize&&(A=Math.ceil(w/t.maxTextureSize),w=t.maxTextureSize);let E=new Float32Array(w*A*4*u),_=new Wr(E,w,A,u);_.type=Nn,_.needsUpdate=!0;let M=S*4;for(let N=0;N<u;N++){let F=m[N],B=g[N],W=y[N],P=w*A*4*N;for(let H=0;H<F.count;H++){let q=H*M;p===!0&&(s.fromBufferAttribute(F,H),E[P+q+0]=s.x,E[P+q+1]=s.y,E[P+q+2]=s.z,E[P+q+3]=0),f===!0&&(s.fromBufferAttribute(B,H),E[P+q+4]=s.x,E[P+q+5]=s.y,E[P+q+6]=s.z,E[P+q+7]=0),x===!0&&(s.fromBufferAttribute(W,H),E[P+q+8]=s.x,E[P+q+9]=s.y,E[P+q+10]=s.z,E[P+q+11]=W.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new yt(w,A)},i.set(a,d),a.addEventListener("dispose",O)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let p=0;for(let x=0;x<c.length;x++)p+=c[x];let f=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",f),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function HM(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,d=t.get(c,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return d}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var WM={[gu]:"LINEAR_TONE_MAPPING",[xu]:"REINHARD_TONE_MAPPING",[_u]:"CINEON_TONE_MAPPING",[yu]:"ACES_FILMIC_TONE_MAPPING",[bu]:"AGX_TONE_MAPPING",[Mu]:"NEUTRAL_TONE_MAPPING",[vu]:"CUSTOM_TONE_MAPPING"};function $M(n,t,e,i,s,r){let o=new bn(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new hn;h.setAttribute("position",new we([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new we([0,2,0,0,2,0],2));let u=new hl({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new Pe(h,u),p=new uo(-1,1,1,-1,0,1),f=null,x=null,m=!1,g,y=null,S=[],w=!1;this.setSize=function(A,E){o.setSize(A,E),a!==null&&a.setSize(A,E),l!==null&&l.setSize(A,E);for(let _=0;_<S.length;_++){let M=S[_];M.setSize&&M.setSize(A,E)}},this.setEffects=function(A){S=A,w=S.length>0&&S[0].isRenderPass===!0;let E=o.width,_=o.height;S.length>0&&a===null&&(a=new bn(E,_,{type:Yn,depthBuffer:!1,stencilBuffer:!1}),l=new bn(E,_,{type:Yn,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&S.some(O=>O.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&c===null&&(c=new Ei(E,_),r===!0&&(c.format=Ri,c.type=ys)),o.dispose(),o.depthTexture=M?c:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let O=0;O<S.length;O++){let N=S[O];N.setSize&&N.setSize(E,_),M&&N.needsDepthTexture===!0&&N.setDepthTexture&&N.setDepthTexture(c)}},this.begin=function(A,E){if(m||A.toneMapping===oi&&S.length===0)return!1;if(y=E,E!==null){let _=E.width,M=E.height;(o.width!==_||o.height!==M)&&this.setSize(_,M)}return w===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=oi,!0},this.hasRenderPass=function(){return w},this.end=function(A,E){A.toneMapping=g,m=!0;let _=o,M=a;for(let O=0;O<S.length;O++){let N=S[O];N.enabled!==!1&&(N.render(A,M,_,E),N.needsSwap!==!1&&(_=M,M=M===a?l:a))}if(f!==A.outputColorSpace||x!==A.toneMapping){f=A.outputColorSpace,x=A.toneMapping,u.defines={},te.getTransfer(f)===ae&&(u.defines.SRGB_TRANSFER="");let O=WM[x];O&&(u.defines[O]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(y),A.render(d,p),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var ng=new cn,ig=new Ei(1,1),sg=new Qr(1),rg=new Wr,og=new Ka,ag=new Kr,Om=[],Fm=[],Um=new Float32Array(16),km=new Float32Array(9),Bm=new Float32Array(4);function ur(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=Om[s];if(r===void 0&&(r=new Float32Array(s),Om[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Ne(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function De(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function gc(n,t){let e=Fm[t];e===void 0&&(e=new Int32Array(t),Fm[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function XM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function qM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ne(e,t))return;n.uniform2fv(this.addr,t),De(e,t)}}function jM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Ne(e,t))return;n.uniform3fv(this.addr,t),De(e,t)}}function YM(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ne(e,t))return;n.uniform4fv(this.addr,t),De(e,t)}}function JM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ne(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),De(e,t)}else{if(Ne(e,i))return;Bm.set(i),n.uniformMatrix2fv(this.addr,!1,Bm),De(e,i)}}function ZM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ne(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),De(e,t)}else{if(Ne(e,i))return;km.set(i),n.uniformMatrix3fv(this.addr,!1,km),De(e,i)}}function KM(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Ne(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),De(e,t)}else{if(Ne(e,i))return;Um.set(i),n.uniformMatrix4fv(this.addr,!1,Um),De(e,i)}}function QM(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function tw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ne(e,t))return;n.uniform2iv(this.addr,t),De(e,t)}}function ew(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ne(e,t))return;n.uniform3iv(this.addr,t),De(e,t)}}function nw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ne(e,t))return;n.uniform4iv(this.addr,t),De(e,t)}}function iw(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function sw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Ne(e,t))return;n.uniform2uiv(this.addr,t),De(e,t)}}function rw(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Ne(e,t))return;n.uniform3uiv(this.addr,t),De(e,t)}}function ow(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Ne(e,t))return;n.uniform4uiv(this.addr,t),De(e,t)}}function xc(n){return n.version===0&&(n.compareFunction=Lu,n.needsUpdate=!0),n}function aw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=xc(ig):r=ng,e.setTexture2D(t||r,s)}function lw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||og,s)}function cw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=xc(sg):r=ag,e.setTextureCube(t||r,s)}function hw(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||rg,s)}function uw(n){switch(n){case 5126:return XM;case 35664:return qM;case 35665:return jM;case 35666:return YM;case 35674:return JM;case 35675:return ZM;case 35676:return KM;case 5124:case 35670:return QM;case 35667:case 35671:return tw;case 35668:case 35672:return ew;case 35669:case 35673:return nw;case 5125:return iw;case 36294:return sw;case 36295:return rw;case 36296:return ow;case 35678:case 36198:case 36298:case 36306:case 35682:return aw;case 35679:case 36299:case 36307:return lw;case 35680:case 36300:case 36308:case 36293:return cw;case 36289:case 36303:case 36311:case 36292:return hw}}function dw(n,t){n.uniform1fv(this.addr,t)}function fw(n,t){let e=ur(t,this.size,2);n.uniform2fv(this.addr,e)}function pw(n,t){let e=ur(t,this.size,3);n.uniform3fv(this.addr,e)}function mw(n,t){let e=ur(t,this.size,4);n.uniform4fv(this.addr,e)}function gw(n,t){let e=ur(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function xw(n,t){let e=ur(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function _w(n,t){let e=ur(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function yw(n,t){n.uniform1iv(this.addr,t)}function vw(n,t){n.uniform2iv(this.addr,t)}function bw(n,t){n.uniform3iv(this.addr,t)}function Mw(n,t){n.uniform4iv(this.addr,t)}function ww(n,t){n.uniform1uiv(this.addr,t)}function Sw(n,t){n.uniform2uiv(this.addr,t)}function Tw(n,t){n.uniform3uiv(this.addr,t)}function Ew(n,t){n.uniform4uiv(this.addr,t)}function Aw(n,t,e){let i=this.cache,s=t.length,r=gc(e,s);Ne(i,r)||(n.uniform1iv(this.addr,r),De(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=xc(ig):o=ng;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Rw(n,t,e){let i=this.cache,s=t.length,r=gc(e,s);Ne(i,r)||(n.uniform1iv(this.addr,r),De(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||og,r[o])}function Cw(n,t,e){let i=this.cache,s=t.length,r=gc(e,s);Ne(i,r)||(n.uniform1iv(this.addr,r),De(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=xc(sg):o=ag;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function Pw(n,t,e){let i=this.cache,s=t.length,r=gc(e,s);Ne(i,r)||(n.uniform1iv(this.addr,r),De(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||rg,r[o])}function Iw(n){switch(n){case 5126:return dw;case 35664:return fw;case 35665:return pw;case 35666:return mw;case 35674:return gw;case 35675:return xw;case 35676:return _w;case 5124:case 35670:return yw;case 35667:case 35671:return vw;case 35668:case 35672:return bw;case 35669:case 35673:return Mw;case 5125:return ww;case 36294:return Sw;case 36295:return Tw;case 36296:return Ew;case 35678:case 36198:case 36298:case 36306:case 35682:return Aw;case 35679:case 36299:case 36307:return Rw;case 35680:case 36300:case 36308:case 36293:return Cw;case 36289:case 36303:case 36311:case 36292:return Pw}}var qu=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=uw(e.type)}},ju=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=Iw(e.type)}},Yu=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},$u=/(\w+)(\])?(\[|\.)?/g;function zm(n,t){n.seq.push(t),n.map[t.id]=t}function Lw(n,t,e){let i=n.name,s=i.length;for($u.lastIndex=0;;){let r=$u.exec(i),o=$u.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){zm(e,c===void 0?new qu(a,n,t):new ju(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new Yu(a),zm(e,u)),e=u}}}var hr=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);Lw(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Gm(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var Nw=37297,Dw=0;function Ow(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Vm=new Bt;function Fw(n){te._getMatrix(Vm,te.workingColorSpace,n);let t=`mat3( ${Vm.elements.map(e=>e.toFixed(4))} )`;switch(te.getTransfer(n)){case Vr:return[t,"LinearTransferOETF"];case ae:return[t,"sRGBTransferOETF"];default:return It("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Hm(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Ow(n.getShaderSource(t),a)}else return r}function Uw(n,t){let e=Fw(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var kw={[gu]:"Linear",[xu]:"Reinhard",[_u]:"Cineon",[yu]:"ACESFilmic",[bu]:"AgX",[Mu]:"Neutral",[vu]:"Custom"};function Bw(n,t){let e=kw[t];return e===void 0?(It("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var fc=new I;function zw(){te.getLuminanceCoefficients(fc);let n=fc.x.toFixed(4),t=fc.y.toFixed(4),e=fc.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Gw(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(So).join(`
`)}function Vw(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function Hw(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function So(n){return n!==""}function Wm(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function $m(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Ww=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ju(n){return n.replace(Ww,$w)}function $w(n,t){let e=jt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Ju(e)}var Xw=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Xm(n){return n.replace(Xw,qw)}function qw(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function qm(n){let t=`precision ${n.precision} float;
	precision ${n.precision} int;
	precision ${n.precision} sampler2D;
	precision ${n.precision} samplerCube;
	precision ${n.precision} sampler3D;
	precision ${n.precision} sampler2DArray;
	precision ${n.precision} sampler2DShadow;
	precision ${n.precision} samplerCubeShadow;
	precision ${n.precision} sampler2DArrayShadow;
	precision ${n.precision} isampler2D;
	precision ${n.precision} isampler3D;
	precision ${n.precision} isamplerCube;
	precision ${n.precision} isampler2DArray;
	precision ${n.precision} usampler2D;
	precision ${n.precision} usampler3D;
	precision ${n.precision} usamplerCube;
	precision ${n.precision} usampler2DArray;
	`;return n.precision==="highp"?t+=`
#define HIGH_PRECISION`:n.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var jw={[ms]:"SHADOWMAP_TYPE_PCF",[rr]:"SHADOWMAP_TYPE_VSM"};function Yw(n){return jw[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var Jw={[ar]:"ENVMAP_MODE_REFRACTION"};function Zw(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":Jw[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var Kw={[mu]:"ENVMAP_BLENDING_MULTIPLY",[cm]:"ENVMAP_BLENDING_MIX",[hm]:"ENVMAP_BLENDING_ADD"};function Qw(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":Kw[n.combine]||"ENVMAP_BLENDING_NONE"}function tS(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=Yw(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=Zw(e),u=Qw(e),d=Gw(e),p=Vw(r),f=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(So).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(So).join(`
`),m.length>0&&(m+=`
`)):(x=[qm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(So).join(`
`),m=[qm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==oi?"#define TONE_MAPPING":"",e.toneMapping!==oi?jt.tonemapping_pars_fragment:"",e.toneMapping!==oi?Bw("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",jt.colorspace_pars_fragment,Uw("linearToOutputTexel",e.outputColorSpace),zw(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(So).join(`
`)),o=Ju(o),o=Wm(o,e),o=$m(o,e),a=Ju(a),a=Wm(a,e),a=$m(a,e),o=Xm(o),a=Xm(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===Du?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Du?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+x+o,S=g+m+a,w=Gm(s,s.VERTEX_SHADER,y),A=Gm(s,s.FRAGMENT_SHADER,S);s.attachShader(f,w),s.attachShader(f,A),e.index0AttributeName!==void 0?s.bindAttribLocation(f,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(f,0,"position"),s.linkProgram(f);function E(N){if(n.debug.checkShaderErrors){let F=s.getProgramInfoLog(f)||"",B=s.getShaderInfoLog(w)||"",W=s.getShaderInfoLog(A)||"",P=F.trim(),H=B.trim(),q=W.trim(),V=!0,nt=!0;if(s.getProgramParameter(f,s.LINK_STATUS)===!1)if(V=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,f,w,A);else{let X=Hm(s,w,"vertex"),Q=Hm(s,A,"fragment");Ft("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(f,s.VALIDATE_STATUS)+`

Material Name: `+N.name+`
Material Type: `+N.type+`

Program Info Log: `+P+`
`+X+`
`+Q)}else P!==""?It("WebGLProgram: Program Info Log:",P):(H===""||q==="")&&(nt=!1);nt&&(N.diagnostics={runnable:V,programLog:P,vertexShader:{log:H,prefix:x},fragmentShader:{log:q,prefix:m}})}s.deleteShader(w),s.deleteShader(A),_=new hr(s,f),M=Hw(s,f)}let _;this.getUniforms=function(){return _===void 0&&E(this),_};let M;this.getAttributes=function(){return M===void 0&&E(this),M};let O=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return O===!1&&(O=s.getProgramParameter(f,Nw)),O},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(f),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Dw++,this.cacheKey=t,this.usedTimes=1,this.program=f,this.vertexShader=w,this.fragmentShader=A,this}var eS=0,Zu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Ku(t),e.set(t,i)),i}},Ku=class{constructor(t){this.id=eS++,this.code=t,this.usedTimes=0}};function nS(n){return n===Qi||n===bo||n===Mo}function iS(n,t,e,i,s,r){let o=new Qs,a=new Zu,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(_){return l.add(_),_===0?"uv":`uv${_}`}function f(_,M,O,N,F,B){let W=N.fog,P=F.geometry,H=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?N.environment:null,q=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,V=t.get(_.envMap||H,q),nt=d[_.type],X=i.precision;_.precision!==null&&(X=i.getMaxPrecision(_.precision),X!==_.precision&&It("WebGLProgram.getParameters:",_.precision,"not supported, using",X,"instead."));let Q=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,tt=Q!==void 0?Q.length:0,St=0;P.morphAttributes.position!==void 0&&(St=1),P.morphAttributes.normal!==void 0&&(St=2),P.morphAttributes.color!==void 0&&(St=3);let Gt,J,gt,bt;if(nt){let pt=li[nt];Gt=pt.vertexShader,J=pt.fragmentShader}else{Gt=_.vertexShader,J=_.fragmentShader;let pt=a.getVertexShaderStage(_),ce=a.getFragmentShaderStage(_);a.update(_,pt,ce),gt=pt.id,bt=ce.id}let Lt=n.getRenderTarget(),xt=n.state.buffers.depth.getReversed(),Ht=F.isInstancedMesh===!0,Te=F.isBatchedMesh===!0,Dt=!!_.map,le=!!_.matcap,ue=!!V,Zt=ue&&V.isPMREMTexture===!0,Ve=!!_.aoMap,Ie=!!_.lightMap,on=!!_.bumpMap&&_.wireframe===!1,ve=!!_.normalMap,Kn=!!_.displacementMap,Fe=!!_.emissiveMap,Sn=!!_.metalnessMap,Tn=!!_.roughnessMap,En=_.anisotropy>0,D=_.clearcoat>0,An=_.diffuseRoughness>0,ge=_.dispersion>0,xe=_.retroreflectivity>0,ft=_.iridescence>0,Le=_.sheen>0,Nt=_.transmission>0,zt=En&&!!_.anisotropyMap,T=D&&!!_.clearcoatMap,v=D&&!!_.clearcoatNormalMap,k=D&&!!_.clearcoatRoughnessMap,et=An&&!!_.diffuseRoughnessMap,K=ft&&!!_.iridescenceMap,rt=ft&&!!_.iridescenceThicknessMap,ht=Le&&!!_.sheenColorMap,j=Le&&!!_.sheenRoughnessMap,Y=!!_.specularMap,at=!!_.specularColorMap,R=!!_.specularIntensityMap,Z=Nt&&!!_.transmissionMap,$=Nt&&!!_.thicknessMap,lt=!!_.gradientMap,st=!!_.alphaMap,ot=_.alphaTest>0,Et=!!_.alphaHash,$t=!!_.extensions,it=oi;_.toneMapped&&(Lt===null||Lt.isXRRenderTarget===!0)&&(it=n.toneMapping);let Ct=Zt?V.isCompressedCubeTexture?V.image[0].mipmaps:V.mipmaps:null,Wt={shaderID:nt,shaderType:_.type,shaderName:_.name,vertexShader:Gt,fragmentShader:J,defines:_.defines,customVertexShaderID:gt,customFragmentShaderID:bt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:X,batching:Te,batchingColor:Te&&F._colorsTexture!==null,instancing:Ht,instancingColor:Ht&&F.instanceColor!==null,instancingMorph:Ht&&F.morphTexture!==null,outputColorSpace:Lt===null?n.outputColorSpace:Lt.isXRRenderTarget===!0?Lt.texture.colorSpace:te.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Dt,matcap:le,envMap:ue,envMapMode:ue&&V.mapping,envMapPMREM:Zt,envMapMaxLod:Zt?Ct.length-1:null,envMapSize:Zt?Ct[0].width:null,aoMap:Ve,lightMap:Ie,bumpMap:on,normalMap:ve,displacementMap:Kn,emissiveMap:Fe,normalMapObjectSpace:ve&&_.normalMapType===fm,normalMapTangentSpace:ve&&_.normalMapType===uc,packedNormalMap:ve&&_.normalMapType===uc&&nS(_.normalMap.format),metalnessMap:Sn,roughnessMap:Tn,anisotropy:En,anisotropyMap:zt,clearcoat:D,clearcoatMap:T,clearcoatNormalMap:v,clearcoatRoughnessMap:k,diffuseRoughness:An,diffuseRoughnessMap:et,dispersion:ge,retroreflection:xe,iridescence:ft,iridescenceMap:K,iridescenceThicknessMap:rt,sheen:Le,sheenColorMap:ht,sheenRoughnessMap:j,specularMap:Y,specularColorMap:at,specularIntensityMap:R,transmission:Nt,transmissionMap:Z,thicknessMap:$,gradientMap:lt,opaque:_.transparent===!1&&_.blending===or&&_.alphaToCoverage===!1,alphaMap:st,alphaTest:ot,alphaHash:Et,combine:_.combine,mapUv:Dt&&p(_.map.channel),aoMapUv:Ve&&p(_.aoMap.channel),lightMapUv:Ie&&p(_.lightMap.channel),bumpMapUv:on&&p(_.bumpMap.channel),normalMapUv:ve&&p(_.normalMap.channel),displacementMapUv:Kn&&p(_.displacementMap.channel),emissiveMapUv:Fe&&p(_.emissiveMap.channel),metalnessMapUv:Sn&&p(_.metalnessMap.channel),roughnessMapUv:Tn&&p(_.roughnessMap.channel),anisotropyMapUv:zt&&p(_.anisotropyMap.channel),clearcoatMapUv:T&&p(_.clearcoatMap.channel),clearcoatNormalMapUv:v&&p(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:k&&p(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:et&&p(_.diffuseRoughnessMap.channel),iridescenceMapUv:K&&p(_.iridescenceMap.channel),iridescenceThicknessMapUv:rt&&p(_.iridescenceThicknessMap.channel),sheenColorMapUv:ht&&p(_.sheenColorMap.channel),sheenRoughnessMapUv:j&&p(_.sheenRoughnessMap.channel),specularMapUv:Y&&p(_.specularMap.channel),specularColorMapUv:at&&p(_.specularColorMap.channel),specularIntensityMapUv:R&&p(_.specularIntensityMap.channel),transmissionMapUv:Z&&p(_.transmissionMap.channel),thicknessMapUv:$&&p(_.thicknessMap.channel),alphaMapUv:st&&p(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(ve||En),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:F.isPoints===!0&&!!P.attributes.uv&&(Dt||st),fog:!!W,useFog:_.fog===!0,fogExp2:!!W&&W.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&ve===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:xt,skinning:F.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:St,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:B.filter(pt=>pt.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&O.length>0,shadowMapType:n.shadowMap.type,toneMapping:it,decodeVideoTexture:Dt&&_.map.isVideoTexture===!0&&te.getTransfer(_.map.colorSpace)===ae,decodeVideoTextureEmissive:Fe&&_.emissiveMap.isVideoTexture===!0&&te.getTransfer(_.emissiveMap.colorSpace)===ae,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===rn,flipSided:_.side===sn,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:$t&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:($t&&_.extensions.multiDraw===!0||Te)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Wt.vertexUv1s=l.has(1),Wt.vertexUv2s=l.has(2),Wt.vertexUv3s=l.has(3),l.clear(),Wt}function x(_){let M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(let O in _.defines)M.push(O),M.push(_.defines[O]);return _.isRawShaderMaterial===!1&&(m(M,_),g(M,_),M.push(n.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function m(_,M){_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapPMREM),_.push(M.envMapMaxLod),_.push(M.envMapSize),_.push(M.mapUv),_.push(M.alphaMapUv),_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.diffuseRoughnessMapUv),_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),_.push(M.numSunLights),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),_.push(M.numSunLightShadows),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(M.numLightProbes),_.push(M.numLightProbeGrids),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.depthPacking)}function g(_,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let M=d[_.type],O;if(M){let N=li[M];O=Rm.clone(N.uniforms)}else O=_.uniforms;return O}function S(_,M){let O=h.get(M);return O!==void 0?++O.usedTimes:(O=new tS(n,M,_,s),c.push(O),h.set(M,O)),O}function w(_){if(--_.usedTimes===0){let M=c.indexOf(_);c[M]=c[c.length-1],c.pop(),h.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function E(){a.dispose()}return{getParameters:f,getProgramCacheKey:x,getUniforms:y,acquireProgram:S,releaseProgram:w,releaseShaderCache:A,programs:c,dispose:E}}function sS(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function rS(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function jm(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Ym(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let p=0;return d.isInstancedMesh&&(p+=2),d.isSkinnedMesh&&(p+=1),p}function a(d,p,f,x,m,g){let y=n[t];return y===void 0?(y={id:d.id,object:d,geometry:p,material:f,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},n[t]=y):(y.id=d.id,y.object=d,y.geometry=p,y.material=f,y.materialVariant=o(d),y.groupOrder=x,y.renderOrder=d.renderOrder,y.z=m,y.group=g),t++,y}function l(d,p,f,x,m,g,y){y.reversedDepth===!0&&(m=-m);let S=a(d,p,f,x,m,g);f.transmission>0?i.push(S):f.transparent===!0?s.push(S):e.push(S)}function c(d,p,f,x,m,g){let y=a(d,p,f,x,m,g);f.transmission>0?i.unshift(y):f.transparent===!0?s.unshift(y):e.unshift(y)}function h(d,p){e.length>1&&e.sort(d||rS),i.length>1&&i.sort(p||jm),s.length>1&&s.sort(p||jm)}function u(){for(let d=t,p=n.length;d<p;d++){let f=n[d];if(f.id===null)break;f.id=null,f.object=null,f.geometry=null,f.material=null,f.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function oS(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Ym,n.set(i,[o])):s>=r.length?(o=new Ym,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function aS(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new I,color:new kt};break;case"SpotLight":e={position:new I,direction:new I,color:new kt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new I,color:new kt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new I,skyColor:new kt,groundColor:new kt};break;case"RectAreaLight":e={color:new kt,position:new I,halfWidth:new I,halfHeight:new I};break}return n[t.id]=e,e}}}function lS(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new yt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new yt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new yt,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var cS=0;function hS(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function uS(n){let t=new aS,e=lS(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new I);let s=new I,r=new ne,o=new ne;function a(c){let h=0,u=0,d=0;for(let B=0;B<9;B++)i.probe[B].set(0,0,0);let p=0,f=0,x=0,m=0,g=0,y=0,S=0,w=0,A=0,E=0,_=0,M=0,O=0,N=0;c.sort(hS);for(let B=0,W=c.length;B<W;B++){let P=c[B],H=P.color,q=P.intensity,V=P.distance,nt=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===Qi?nt=P.shadow.map.texture:nt=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=H.r*q,u+=H.g*q,d+=H.b*q;else if(P.isLightProbe){for(let X=0;X<9;X++)i.probe[X].addScaledVector(P.sh.coefficients[X],q);N++}else if(P.isSunLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,tt=e.get(P);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[f]=tt,i.sunShadowMap[f]=nt;let St=Q.getViewportCount();for(let Gt=0;Gt<St;Gt++)i.sunShadowMatrix[x+Gt]=Q.getMatrix(Gt),i.sunShadowCascade[x+Gt]=Q._cascadeData[Gt];x+=St,f++}i.sun[p]=X,p++}else if(P.isDirectionalLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,tt=e.get(P);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.directionalShadow[m]=tt,i.directionalShadowMap[m]=nt,i.directionalShadowMatrix[m]=P.shadow.matrix,A++}i.directional[m]=X,m++}else if(P.isSpotLight){let X=t.get(P);X.position.setFromMatrixPosition(P.matrixWorld),X.color.copy(H).multiplyScalar(q),X.distance=V,X.coneCos=Math.cos(P.angle),X.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),X.decay=P.decay,i.spot[y]=X;let Q=P.shadow;if(P.map&&(i.spotLightMap[M]=P.map,M++,Q.updateMatrices(P),P.castShadow&&O++),i.spotLightMatrix[y]=Q.matrix,P.castShadow){let tt=e.get(P);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.spotShadow[y]=tt,i.spotShadowMap[y]=nt,_++}y++}else if(P.isRectAreaLight){let X=t.get(P);X.color.copy(H).multiplyScalar(q),X.halfWidth.set(P.width*.5,0,0),X.halfHeight.set(0,P.height*.5,0),i.rectArea[S]=X,S++}else if(P.isPointLight){let X=t.get(P);if(X.color.copy(P.color).multiplyScalar(P.intensity),X.distance=P.distance,X.decay=P.decay,P.castShadow){let Q=P.shadow,tt=e.get(P);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,i.pointShadow[g]=tt,i.pointShadowMap[g]=nt,i.pointShadowMatrix[g]=P.shadow.matrix,E++}i.point[g]=X,g++}else if(P.isHemisphereLight){let X=t.get(P);X.skyColor.copy(P.color).multiplyScalar(q),X.groundColor.copy(P.groundColor).multiplyScalar(q),i.hemi[w]=X,w++}}S>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=mt.LTC_FLOAT_1,i.rectAreaLTC2=mt.LTC_FLOAT_2):(i.rectAreaLTC1=mt.LTC_HALF_1,i.rectAreaLTC2=mt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let F=i.hash;(F.sunLength!==p||F.directionalLength!==m||F.pointLength!==g||F.spotLength!==y||F.rectAreaLength!==S||F.hemiLength!==w||F.numSunShadows!==f||F.numDirectionalShadows!==A||F.numPointShadows!==E||F.numSpotShadows!==_||F.numSpotMaps!==M||F.numLightProbes!==N)&&(i.sun.length=p,i.directional.length=m,i.spot.length=y,i.rectArea.length=S,i.point.length=g,i.hemi.length=w,i.sunShadow.length=f,i.sunShadowMap.length=f,i.sunShadowMatrix.length=x,i.sunShadowCascade.length=x,i.directionalShadow.length=A,i.directionalShadowMap.length=A,i.directionalShadowMatrix.length=A,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+M-O,i.spotLightMap.length=M,i.numSpotLightShadowsWithMaps=O,i.numLightProbes=N,F.sunLength=p,F.directionalLength=m,F.pointLength=g,F.spotLength=y,F.rectAreaLength=S,F.hemiLength=w,F.numSunShadows=f,F.numDirectionalShadows=A,F.numPointShadows=E,F.numSpotShadows=_,F.numSpotMaps=M,F.numLightProbes=N,i.version=cS++)}function l(c,h){let u=0,d=0,p=0,f=0,x=0,m=0,g=h.matrixWorldInverse;for(let y=0,S=c.length;y<S;y++){let w=c[y];if(w.isSunLight){let A=i.sun[u];A.direction.setFromMatrixPosition(w.matrixWorld),A.direction.transformDirection(g),u++}else if(w.isDirectionalLight){let A=i.directional[d];A.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(w.isSpotLight){let A=i.spot[f];A.position.setFromMatrixPosition(w.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(w.matrixWorld),s.setFromMatrixPosition(w.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),f++}else if(w.isRectAreaLight){let A=i.rectArea[x];A.position.setFromMatrixPosition(w.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(w.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(w.width*.5,0,0),A.halfHeight.set(0,w.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(w.isPointLight){let A=i.point[p];A.position.setFromMatrixPosition(w.matrixWorld),A.position.applyMatrix4(g),p++}else if(w.isHemisphereLight){let A=i.hemi[m];A.direction.setFromMatrixPosition(w.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Jm(n){let t=new uS(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function dS(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Jm(n),t.set(s,[a])):r>=o.length?(a=new Jm(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var fS=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,pS=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,mS=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],gS=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],Zm=new ne,wo=new I,Xu=new I;function xS(n,t,e){let i=new $i,s=new yt,r=new yt,o=new _e,a=new ul,l=new dl,c={},h=e.maxTextureSize,u={[Ki]:sn,[sn]:Ki,[rn]:rn},d=new Ln({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new yt},radius:{value:4}},vertexShader:fS,fragmentShader:pS}),p=d.clone();p.defines.HORIZONTAL_PASS=1;let f=new hn;f.setAttribute("position",new Xn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new Pe(f,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ms;let g=this.type;this.render=function(E,_,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===Wp&&(It("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ms);let O=n.getRenderTarget(),N=n.getActiveCubeFace(),F=n.getActiveMipmapLevel(),B=n.state;B.setBlending(gs),B.buffers.depth.getReversed()===!0?B.buffers.color.setClear(0,0,0,0):B.buffers.color.setClear(1,1,1,1),B.buffers.depth.setTest(!0),B.setScissorTest(!1);let W=g!==this.type;W&&_.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(H=>H.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,H=E.length;P<H;P++){let q=E[P],V=q.shadow;if(V===void 0){It("WebGLShadowMap:",q,"has no shadow.");continue}if(V.autoUpdate===!1&&V.needsUpdate===!1)continue;s.copy(V.mapSize);let nt=V.getFrameExtents();s.multiply(nt),r.copy(V.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/nt.x),s.x=r.x*nt.x,V.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/nt.y),s.y=r.y*nt.y,V.mapSize.y=r.y));let X=n.state.buffers.depth.getReversed();if(V.camera._reversedDepth=X,V.map===null||W===!0){if(V.map!==null&&(V.map.depthTexture!==null&&(V.map.depthTexture.dispose(),V.map.depthTexture=null),V.map.dispose()),this.type===rr){if(q.isPointLight){It("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}V.map=new bn(s.x,s.y,{format:Qi,type:Yn,minFilter:en,magFilter:en,generateMipmaps:!1}),V.map.texture.name=q.name+".shadowMap",V.map.depthTexture=new Ei(s.x,s.y,Nn),V.map.depthTexture.name=q.name+".shadowMapDepth",V.map.depthTexture.format=wi,V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=ze,V.map.depthTexture.magFilter=ze}else q.isPointLight?(V.map=new To(s.x),V.map.depthTexture=new Qr(s.x,jn)):(V.map=new bn(s.x,s.y),V.map.depthTexture=new Ei(s.x,s.y,jn)),V.map.depthTexture.name=q.name+".shadowMap",V.map.depthTexture.format=wi,this.type===ms?(V.map.depthTexture.compareFunction=X?Iu:Pu,V.map.depthTexture.minFilter=en,V.map.depthTexture.magFilter=en):(V.map.depthTexture.compareFunction=null,V.map.depthTexture.minFilter=ze,V.map.depthTexture.magFilter=ze);V.camera.updateProjectionMatrix()}V.map.isWebGLCubeRenderTarget!==!0&&(V.map.width!==s.x||V.map.height!==s.y)&&V.map.setSize(s.x,s.y);let Q=V.map.isWebGLCubeRenderTarget?6:V.getViewportCount();q.isPointLight!==!0&&V.updateMatrices(q,M);let tt=(V.camera.layers.mask&4294967294)!==0?V.camera.layers:M.layers;for(let St=0;St<Q;St++){let Gt=V.getCamera(St);if(q.isPointLight){let J=V.camera,gt=V.matrix,bt=q.distance||J.far;bt!==J.far&&(J.far=bt,J.updateProjectionMatrix()),wo.setFromMatrixPosition(q.matrixWorld),J.position.copy(wo),Xu.copy(J.position),Xu.add(mS[St]),J.up.copy(gS[St]),J.lookAt(Xu),J.updateMatrixWorld(),gt.makeTranslation(-wo.x,-wo.y,-wo.z),Zm.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),V._frustum.setFromProjectionMatrix(Zm,J.coordinateSystem,J.reversedDepth)}if(V.map.isWebGLCubeRenderTarget)n.setRenderTarget(V.map,St),n.clear();else{St===0&&(n.setRenderTarget(V.map),n.clear());let J=V.getViewport(St);o.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),B.viewport(o)}i=V.getFrustum(St),w(_,M,Gt,q,tt,this.type)}V.isPointLightShadow!==!0&&this.type===rr&&y(V,M),V.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(O,N,F)};function y(E,_){let M=t.update(x);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,p.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,p.needsUpdate=!0),E.mapPass===null?E.mapPass=new bn(s.x,s.y,{format:Qi,type:Yn}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(_,null,M,d,x,null),p.uniforms.shadow_pass.value=E.mapPass.texture,p.uniforms.resolution.value.set(E.map.width,E.map.height),p.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(_,null,M,p,x,null)}function S(E,_,M,O){let N=null,F=M.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(F!==void 0)N=F;else if(N=M.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let B=N.uuid,W=_.uuid,P=c[B];P===void 0&&(P={},c[B]=P);let H=P[W];H===void 0&&(H=N.clone(),P[W]=H,_.addEventListener("dispose",A)),N=H}if(N.visible=_.visible,N.wireframe=_.wireframe,O===rr?N.side=_.shadowSide!==null?_.shadowSide:_.side:N.side=_.shadowSide!==null?_.shadowSide:u[_.side],N.alphaMap=_.alphaMap,N.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,N.map=_.map,N.clipShadows=_.clipShadows,N.clippingPlanes=_.clippingPlanes,N.clipIntersection=_.clipIntersection,N.displacementMap=_.displacementMap,N.displacementScale=_.displacementScale,N.displacementBias=_.displacementBias,N.wireframeLinewidth=_.wireframeLinewidth,N.linewidth=_.linewidth,M.isPointLight===!0&&N.isMeshDistanceMaterial===!0){let B=n.properties.get(N);B.light=M}return N}function w(E,_,M,O,N,F){if(E.visible===!1)return;if(E.layers.test(N)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&F===rr)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,E.matrixWorld);let P=t.update(E),H=E.material;if(Array.isArray(H)){let q=P.groups;for(let V=0,nt=q.length;V<nt;V++){let X=q[V],Q=H[X.materialIndex];if(Q&&Q.visible){let tt=S(E,Q,O,F);E.onBeforeShadow(n,E,_,M,P,tt,X),n.renderBufferDirect(M,null,P,tt,E,X),E.onAfterShadow(n,E,_,M,P,tt,X)}}}else if(H.visible){let q=S(E,H,O,F);E.onBeforeShadow(n,E,_,M,P,q,null),n.renderBufferDirect(M,null,P,q,E,null),E.onAfterShadow(n,E,_,M,P,q,null)}}let W=E.children;for(let P=0,H=W.length;P<H;P++)w(W[P],_,M,O,N,F)}function A(E){E.target.removeEventListener("dispose",A);for(let M in c){let O=c[M],N=E.target.uuid;N in O&&(O[N].dispose(),delete O[N])}}}function _S(n,t){function e(){let R=!1,Z=new _e,$=null,lt=new _e(0,0,0,0);return{setMask:function(st){$!==st&&!R&&(n.colorMask(st,st,st,st),$=st)},setLocked:function(st){R=st},setClear:function(st,ot,Et,$t,it){it===!0&&(st*=$t,ot*=$t,Et*=$t),Z.set(st,ot,Et,$t),lt.equals(Z)===!1&&(n.clearColor(st,ot,Et,$t),lt.copy(Z))},reset:function(){R=!1,$=null,lt.set(-1,0,0,0)}}}function i(){let R=!1,Z=!1,$=null,lt=null,st=null;return{setReversed:function(ot){if(Z!==ot){let Et=t.get("EXT_clip_control");ot?Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.ZERO_TO_ONE_EXT):Et.clipControlEXT(Et.LOWER_LEFT_EXT,Et.NEGATIVE_ONE_TO_ONE_EXT),Z=ot;let $t=st;st=null,this.setClear($t)}},getReversed:function(){return Z},setTest:function(ot){ot?xt(n.DEPTH_TEST):Ht(n.DEPTH_TEST)},setMask:function(ot){$!==ot&&!R&&(n.depthMask(ot),$=ot)},setFunc:function(ot){if(Z&&(ot=Sm[ot]),lt!==ot){switch(ot){case za:n.depthFunc(n.NEVER);break;case Ga:n.depthFunc(n.ALWAYS);break;case Va:n.depthFunc(n.LESS);break;case js:n.depthFunc(n.LEQUAL);break;case Ha:n.depthFunc(n.EQUAL);break;case Wa:n.depthFunc(n.GEQUAL);break;case $a:n.depthFunc(n.GREATER);break;case Xa:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}lt=ot}},setLocked:function(ot){R=ot},setClear:function(ot){st!==ot&&(st=ot,Z&&(ot=1-ot),n.clearDepth(ot))},reset:function(){R=!1,$=null,lt=null,st=null,Z=!1}}}function s(){let R=!1,Z=null,$=null,lt=null,st=null,ot=null,Et=null,$t=null,it=null;return{setTest:function(Ct){R||(Ct?xt(n.STENCIL_TEST):Ht(n.STENCIL_TEST))},setMask:function(Ct){Z!==Ct&&!R&&(n.stencilMask(Ct),Z=Ct)},setFunc:function(Ct,Wt,pt){($!==Ct||lt!==Wt||st!==pt)&&(n.stencilFunc(Ct,Wt,pt),$=Ct,lt=Wt,st=pt)},setOp:function(Ct,Wt,pt){(ot!==Ct||Et!==Wt||$t!==pt)&&(n.stencilOp(Ct,Wt,pt),ot=Ct,Et=Wt,$t=pt)},setLocked:function(Ct){R=Ct},setClear:function(Ct){it!==Ct&&(n.clearStencil(Ct),it=Ct)},reset:function(){R=!1,Z=null,$=null,lt=null,st=null,ot=null,Et=null,$t=null,it=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},u={},d={},p=new WeakMap,f=[],x=null,m=!1,g=null,y=null,S=null,w=null,A=null,E=null,_=null,M=new kt(0,0,0),O=0,N=!1,F=null,B=null,W=null,P=null,H=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),V=!1,nt=0,X=n.getParameter(n.VERSION);X.indexOf("WebGL")!==-1?(nt=parseFloat(/^WebGL (\d)/.exec(X)[1]),V=nt>=1):X.indexOf("OpenGL ES")!==-1&&(nt=parseFloat(/^OpenGL ES (\d)/.exec(X)[1]),V=nt>=2);let Q=null,tt={},St=n.getParameter(n.SCISSOR_BOX),Gt=n.getParameter(n.VIEWPORT),J=new _e().fromArray(St),gt=new _e().fromArray(Gt);function bt(R,Z,$,lt){let st=new Uint8Array(4),ot=n.createTexture();n.bindTexture(R,ot),n.texParameteri(R,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(R,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Et=0;Et<$;Et++)R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY?n.texImage3D(Z,0,n.RGBA,1,1,lt,0,n.RGBA,n.UNSIGNED_BYTE,st):n.texImage2D(Z+Et,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,st);return ot}let Lt={};Lt[n.TEXTURE_2D]=bt(n.TEXTURE_2D,n.TEXTURE_2D,1),Lt[n.TEXTURE_CUBE_MAP]=bt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Lt[n.TEXTURE_2D_ARRAY]=bt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Lt[n.TEXTURE_3D]=bt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),xt(n.DEPTH_TEST),o.setFunc(js),on(!1),ve(cu),xt(n.CULL_FACE),Ve(gs);function xt(R){h[R]!==!0&&(n.enable(R),h[R]=!0)}function Ht(R){h[R]!==!1&&(n.disable(R),h[R]=!1)}function Te(R,Z){return d[R]!==Z?(n.bindFramebuffer(R,Z),d[R]=Z,R===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=Z),R===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=Z),!0):!1}function Dt(R,Z){let $=f,lt=!1;if(R){$=p.get(Z),$===void 0&&($=[],p.set(Z,$));let st=R.textures;if($.length!==st.length||$[0]!==n.COLOR_ATTACHMENT0){for(let ot=0,Et=st.length;ot<Et;ot++)$[ot]=n.COLOR_ATTACHMENT0+ot;$.length=st.length,lt=!0}}else $[0]!==n.BACK&&($[0]=n.BACK,lt=!0);lt&&n.drawBuffers($)}function le(R){return x!==R?(n.useProgram(R),x=R,!0):!1}let ue={[xs]:n.FUNC_ADD,[Xp]:n.FUNC_SUBTRACT,[qp]:n.FUNC_REVERSE_SUBTRACT};ue[jp]=n.MIN,ue[Yp]=n.MAX;let Zt={[Jp]:n.ZERO,[Zp]:n.ONE,[Kp]:n.SRC_COLOR,[fu]:n.SRC_ALPHA,[sm]:n.SRC_ALPHA_SATURATE,[nm]:n.DST_COLOR,[tm]:n.DST_ALPHA,[Qp]:n.ONE_MINUS_SRC_COLOR,[pu]:n.ONE_MINUS_SRC_ALPHA,[im]:n.ONE_MINUS_DST_COLOR,[em]:n.ONE_MINUS_DST_ALPHA,[rm]:n.CONSTANT_COLOR,[om]:n.ONE_MINUS_CONSTANT_COLOR,[am]:n.CONSTANT_ALPHA,[lm]:n.ONE_MINUS_CONSTANT_ALPHA};function Ve(R,Z,$,lt,st,ot,Et,$t,it,Ct){if(R===gs){m===!0&&(Ht(n.BLEND),m=!1);return}if(m===!1&&(xt(n.BLEND),m=!0),R!==$p){if(R!==g||Ct!==N){if((y!==xs||A!==xs)&&(n.blendEquation(n.FUNC_ADD),y=xs,A=xs),Ct)switch(R){case or:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hu:n.blendFunc(n.ONE,n.ONE);break;case uu:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case du:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Ft("WebGLState: Invalid blending: ",R);break}else switch(R){case or:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case hu:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case uu:Ft("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case du:Ft("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ft("WebGLState: Invalid blending: ",R);break}S=null,w=null,E=null,_=null,M.set(0,0,0),O=0,g=R,N=Ct}return}st=st||Z,ot=ot||$,Et=Et||lt,(Z!==y||st!==A)&&(n.blendEquationSeparate(ue[Z],ue[st]),y=Z,A=st),($!==S||lt!==w||ot!==E||Et!==_)&&(n.blendFuncSeparate(Zt[$],Zt[lt],Zt[ot],Zt[Et]),S=$,w=lt,E=ot,_=Et),($t.equals(M)===!1||it!==O)&&(n.blendColor($t.r,$t.g,$t.b,it),M.copy($t),O=it),g=R,N=!1}function Ie(R,Z){R.side===rn?Ht(n.CULL_FACE):xt(n.CULL_FACE);let $=R.side===sn;Z&&($=!$),on($),R.blending===or&&R.transparent===!1?Ve(gs):Ve(R.blending,R.blendEquation,R.blendSrc,R.blendDst,R.blendEquationAlpha,R.blendSrcAlpha,R.blendDstAlpha,R.blendColor,R.blendAlpha,R.premultipliedAlpha),o.setFunc(R.depthFunc),o.setTest(R.depthTest),o.setMask(R.depthWrite),r.setMask(R.colorWrite);let lt=R.stencilWrite;a.setTest(lt),lt&&(a.setMask(R.stencilWriteMask),a.setFunc(R.stencilFunc,R.stencilRef,R.stencilFuncMask),a.setOp(R.stencilFail,R.stencilZFail,R.stencilZPass)),Fe(R.polygonOffset,R.polygonOffsetFactor,R.polygonOffsetUnits),R.alphaToCoverage===!0?xt(n.SAMPLE_ALPHA_TO_COVERAGE):Ht(n.SAMPLE_ALPHA_TO_COVERAGE)}function on(R){F!==R&&(R?n.frontFace(n.CW):n.frontFace(n.CCW),F=R)}function ve(R){R!==Vp?(xt(n.CULL_FACE),R!==B&&(R===cu?n.cullFace(n.BACK):R===Hp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Ht(n.CULL_FACE),B=R}function Kn(R){R!==W&&(V&&n.lineWidth(R),W=R)}function Fe(R,Z,$){R?(xt(n.POLYGON_OFFSET_FILL),(P!==Z||H!==$)&&(P=Z,H=$,o.getReversed()&&(Z=-Z,$=-$),n.polygonOffset(Z,$))):Ht(n.POLYGON_OFFSET_FILL)}function Sn(R){R?xt(n.SCISSOR_TEST):Ht(n.SCISSOR_TEST)}function Tn(R){R===void 0&&(R=n.TEXTURE0+q-1),Q!==R&&(n.activeTexture(R),Q=R)}function En(R,Z,$){$===void 0&&(Q===null?$=n.TEXTURE0+q-1:$=Q);let lt=tt[$];lt===void 0&&(lt={type:void 0,texture:void 0},tt[$]=lt),(lt.type!==R||lt.texture!==Z)&&(Q!==$&&(n.activeTexture($),Q=$),n.bindTexture(R,Z||Lt[R]),lt.type=R,lt.texture=Z)}function D(){let R=tt[Q];R!==void 0&&R.type!==void 0&&(n.bindTexture(R.type,null),R.type=void 0,R.texture=void 0)}function An(){try{n.compressedTexImage2D(...arguments)}catch(R){Ft("WebGLState:",R)}}function ge(){try{n.compressedTexImage3D(...arguments)}catch(R){Ft("WebGLState:",R)}}function xe(){try{n.texSubImage2D(...arguments)}catch(R){Ft("WebGLState:",R)}}function ft(){try{n.texSubImage3D(...arguments)}catch(R){Ft("WebGLState:",R)}}function Le(){try{n.compressedTexSubImage2D(...arguments)}catch(R){Ft("WebGLState:",R)}}function Nt(){try{n.compressedTexSubImage3D(...arguments)}catch(R){Ft("WebGLState:",R)}}function zt(){try{n.texStorage2D(...arguments)}catch(R){Ft("WebGLState:",R)}}function T(){try{n.texStorage3D(...arguments)}catch(R){Ft("WebGLState:",R)}}function v(){try{n.texImage2D(...arguments)}catch(R){Ft("WebGLState:",R)}}function k(){try{n.texImage3D(...arguments)}catch(R){Ft("WebGLState:",R)}}function et(R){return u[R]!==void 0?u[R]:n.getParameter(R)}function K(R,Z){u[R]!==Z&&(n.pixelStorei(R,Z),u[R]=Z)}function rt(R){J.equals(R)===!1&&(n.scissor(R.x,R.y,R.z,R.w),J.copy(R))}function ht(R){gt.equals(R)===!1&&(n.viewport(R.x,R.y,R.z,R.w),gt.copy(R))}function j(R,Z){let $=c.get(Z);$===void 0&&($=new WeakMap,c.set(Z,$));let lt=$.get(R);lt===void 0&&(lt=n.getUniformBlockIndex(Z,R.name),n.uniformBlockBinding(Z,lt,lt),$.set(R,lt))}function Y(R,Z,$){let st=c.get(Z).get(R);l[st]!==$&&(n.bindBufferBase(n.UNIFORM_BUFFER,st,$),l[st]=$)}function at(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,tt={},d={},l={},p=new WeakMap,f=[],x=null,m=!1,g=null,y=null,S=null,w=null,A=null,E=null,_=null,M=new kt(0,0,0),O=0,N=!1,F=null,B=null,W=null,P=null,H=null,J.set(0,0,n.canvas.width,n.canvas.height),gt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:xt,disable:Ht,bindFramebuffer:Te,drawBuffers:Dt,useProgram:le,setBlending:Ve,setMaterial:Ie,setFlipSided:on,setCullFace:ve,setLineWidth:Kn,setPolygonOffset:Fe,setScissorTest:Sn,activeTexture:Tn,bindTexture:En,unbindTexture:D,compressedTexImage2D:An,compressedTexImage3D:ge,texImage2D:v,texImage3D:k,pixelStorei:K,getParameter:et,updateUBOMapping:j,uniformBlockBinding:Y,texStorage2D:zt,texStorage3D:T,texSubImage2D:xe,texSubImage3D:ft,compressedTexSubImage2D:Le,compressedTexSubImage3D:Nt,scissor:rt,viewport:ht,reset:at}}function yS(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new yt,h=new WeakMap,u=new Set,d,p=new WeakMap,f=new Set,x=new FinalizationRegistry(T=>f.delete(T)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(T,v){return m?new OffscreenCanvas(T,v):Hr("canvas")}function y(T,v,k){let et=1,K=zt(T);if((K.width>k||K.height>k)&&(et=k/Math.max(K.width,K.height)),et<1)if(typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&T instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&T instanceof ImageBitmap||typeof VideoFrame<"u"&&T instanceof VideoFrame){let rt=Math.floor(et*K.width),ht=Math.floor(et*K.height);d===void 0&&(d=g(rt,ht));let j=v?g(rt,ht):d;return j.width=rt,j.height=ht,j.getContext("2d").drawImage(T,0,0,rt,ht),It("WebGLRenderer: Texture has been resized from ("+K.width+"x"+K.height+") to ("+rt+"x"+ht+")."),j}else return"data"in T&&It("WebGLRenderer: Image in DataTexture is too big ("+K.width+"x"+K.height+")."),T;return T}function S(T){return T.generateMipmaps}function w(T){n.generateMipmap(T)}function A(T){return T.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:T.isWebGL3DRenderTarget?n.TEXTURE_3D:T.isWebGLArrayRenderTarget||T.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(T,v,k,et,K,rt=!1){if(T!==null){if(n[T]!==void 0)return n[T];It("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+T+"'")}let ht;et&&(ht=t.get("EXT_texture_norm16"),ht||It("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let j=v;if(v===n.RED&&(k===n.FLOAT&&(j=n.R32F),k===n.HALF_FLOAT&&(j=n.R16F),k===n.UNSIGNED_BYTE&&(j=n.R8),k===n.UNSIGNED_SHORT&&ht&&(j=ht.R16_EXT),k===n.SHORT&&ht&&(j=ht.R16_SNORM_EXT)),v===n.RED_INTEGER&&(k===n.UNSIGNED_BYTE&&(j=n.R8UI),k===n.UNSIGNED_SHORT&&(j=n.R16UI),k===n.UNSIGNED_INT&&(j=n.R32UI),k===n.BYTE&&(j=n.R8I),k===n.SHORT&&(j=n.R16I),k===n.INT&&(j=n.R32I)),v===n.RG&&(k===n.FLOAT&&(j=n.RG32F),k===n.HALF_FLOAT&&(j=n.RG16F),k===n.UNSIGNED_BYTE&&(j=n.RG8),k===n.UNSIGNED_SHORT&&ht&&(j=ht.RG16_EXT),k===n.SHORT&&ht&&(j=ht.RG16_SNORM_EXT)),v===n.RG_INTEGER&&(k===n.UNSIGNED_BYTE&&(j=n.RG8UI),k===n.UNSIGNED_SHORT&&(j=n.RG16UI),k===n.UNSIGNED_INT&&(j=n.RG32UI),k===n.BYTE&&(j=n.RG8I),k===n.SHORT&&(j=n.RG16I),k===n.INT&&(j=n.RG32I)),v===n.RGB_INTEGER&&(k===n.UNSIGNED_BYTE&&(j=n.RGB8UI),k===n.UNSIGNED_SHORT&&(j=n.RGB16UI),k===n.UNSIGNED_INT&&(j=n.RGB32UI),k===n.BYTE&&(j=n.RGB8I),k===n.SHORT&&(j=n.RGB16I),k===n.INT&&(j=n.RGB32I)),v===n.RGBA_INTEGER&&(k===n.UNSIGNED_BYTE&&(j=n.RGBA8UI),k===n.UNSIGNED_SHORT&&(j=n.RGBA16UI),k===n.UNSIGNED_INT&&(j=n.RGBA32UI),k===n.BYTE&&(j=n.RGBA8I),k===n.SHORT&&(j=n.RGBA16I),k===n.INT&&(j=n.RGBA32I)),v===n.RGB&&(k===n.UNSIGNED_SHORT&&ht&&(j=ht.RGB16_EXT),k===n.SHORT&&ht&&(j=ht.RGB16_SNORM_EXT),k===n.UNSIGNED_INT_5_9_9_9_REV&&(j=n.RGB9_E5),k===n.UNSIGNED_INT_10F_11F_11F_REV&&(j=n.R11F_G11F_B10F)),v===n.RGBA){let Y=rt?Vr:te.getTransfer(K);k===n.FLOAT&&(j=n.RGBA32F),k===n.HALF_FLOAT&&(j=n.RGBA16F),k===n.UNSIGNED_BYTE&&(j=Y===ae?n.SRGB8_ALPHA8:n.RGBA8),k===n.UNSIGNED_SHORT&&ht&&(j=ht.RGBA16_EXT),k===n.SHORT&&ht&&(j=ht.RGBA16_SNORM_EXT),k===n.UNSIGNED_SHORT_4_4_4_4&&(j=n.RGBA4),k===n.UNSIGNED_SHORT_5_5_5_1&&(j=n.RGB5_A1)}return(j===n.R16F||j===n.R32F||j===n.RG16F||j===n.RG32F||j===n.RGBA16F||j===n.RGBA32F)&&t.get("EXT_color_buffer_float"),j}function _(T,v){let k;return T?v===null||v===jn||v===ys?k=n.DEPTH24_STENCIL8:v===Nn?k=n.DEPTH32F_STENCIL8:v===lr&&(k=n.DEPTH24_STENCIL8,It("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===jn||v===ys?k=n.DEPTH_COMPONENT24:v===Nn?k=n.DEPTH_COMPONENT32F:v===lr&&(k=n.DEPTH_COMPONENT16),k}function M(T,v){return S(T)===!0||T.isFramebufferTexture&&T.minFilter!==ze&&T.minFilter!==en?Math.log2(Math.max(v.width,v.height))+1:T.mipmaps.length>0?T.mipmaps.length:T.isCompressedTexture&&Array.isArray(T.image)?v.mipmaps.length:1}function O(T){let v=new WeakRef(T);i.get(T).__ref=v,f.add(v),x.register(T,v,v)}function N(T){let v=i.get(T).__ref;v!==void 0&&(f.delete(v),x.unregister(v))}function F(T){W(T.target)}function B(T){P(T.target)}function W(T){T.removeEventListener("dispose",F),N(T),q(T),T.isVideoTexture&&h.delete(T),T.isHTMLTexture&&u.delete(T)}function P(T){T.removeEventListener("dispose",B),N(T),nt(T)}function H(){for(let T of f){let v=T.deref();v!==void 0&&(v.isRenderTarget===!0?P(v):W(v))}f.clear(),u.clear()}function q(T){let v=i.get(T);if(v.__webglInit===void 0)return;let k=T.source,et=p.get(k);if(et){let K=et[v.__cacheKey];K.usedTimes--,K.usedTimes===0&&V(T),Object.keys(et).length===0&&p.delete(k)}i.remove(T)}function V(T){let v=i.get(T);n.deleteTexture(v.__webglTexture);let k=T.source,et=p.get(k);delete et[v.__cacheKey],o.memory.textures--}function nt(T){let v=i.get(T);v.__depthDisposeCallback&&v.__depthDisposeCallback();let k=T.depthTexture;if(k&&k.renderTarget===T&&W(k),T.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(v.__webglFramebuffer[K]))for(let rt=0;rt<v.__webglFramebuffer[K].length;rt++)n.deleteFramebuffer(v.__webglFramebuffer[K][rt]);else n.deleteFramebuffer(v.__webglFramebuffer[K]);v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer[K])}else{if(Array.isArray(v.__webglFramebuffer))for(let K=0;K<v.__webglFramebuffer.length;K++)n.deleteFramebuffer(v.__webglFramebuffer[K]);else n.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&n.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let K=0;K<v.__webglColorRenderbuffer.length;K++)v.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(v.__webglColorRenderbuffer[K]);v.__webglDepthRenderbuffer&&n.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let et=T.textures;for(let K=0,rt=et.length;K<rt;K++){let ht=i.get(et[K]);ht.__webglTexture&&(n.deleteTexture(ht.__webglTexture),o.memory.textures--),i.remove(et[K])}i.remove(T)}let X=0;function Q(){X=0}function tt(){return X}function St(T){X=T}function Gt(){let T=X;return T>=s.maxTextures&&It("WebGLTextures: Trying to use "+(T+1)+" texture units while this GPU supports only "+s.maxTextures),X+=1,T}function J(T){let v=[];return v.push(T.wrapS),v.push(T.wrapT),v.push(T.wrapR||0),v.push(T.magFilter),v.push(T.minFilter),v.push(T.anisotropy),v.push(T.internalFormat),v.push(T.format),v.push(T.type),v.push(T.generateMipmaps),v.push(T.mipmapsAutoUpdate),v.push(T.premultiplyAlpha),v.push(T.flipY),v.push(T.unpackAlignment),v.push(T.colorSpace),v.join()}function gt(T,v){let k=i.get(T);if(T.isVideoTexture&&Le(T),T.isRenderTargetTexture===!1&&T.isExternalTexture!==!0&&T.version>0&&k.__version!==T.version){let et=T.image;if(et===null)It("WebGLRenderer: Texture marked for update but no image data found.");else if(et.complete===!1)It("WebGLRenderer: Texture marked for update but image is incomplete");else{Ie(k,T,v);return}}else T.isExternalTexture&&(k.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,k.__webglTexture,n.TEXTURE0+v)}function bt(T,v){let k=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&k.__version!==T.version){Ie(k,T,v);return}else T.isExternalTexture&&(k.__webglTexture=T.sourceTexture?T.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,k.__webglTexture,n.TEXTURE0+v)}function Lt(T,v){let k=i.get(T);if(T.isRenderTargetTexture===!1&&T.version>0&&k.__version!==T.version){Ie(k,T,v);return}e.bindTexture(n.TEXTURE_3D,k.__webglTexture,n.TEXTURE0+v)}function xt(T,v){let k=i.get(T);if(T.version>0&&k.__version!==T.version){on(k,T,v);return}e.bindTexture(n.TEXTURE_CUBE_MAP,k.__webglTexture,n.TEXTURE0+v)}let Ht={[qa]:n.REPEAT,[ii]:n.CLAMP_TO_EDGE,[ja]:n.MIRRORED_REPEAT},Te={[ze]:n.NEAREST,[um]:n.NEAREST_MIPMAP_NEAREST,[go]:n.NEAREST_MIPMAP_LINEAR,[en]:n.LINEAR,[Al]:n.LINEAR_MIPMAP_NEAREST,[Ai]:n.LINEAR_MIPMAP_LINEAR},Dt={[mm]:n.NEVER,[Lu]:n.ALWAYS,[gm]:n.LESS,[Pu]:n.LEQUAL,[xm]:n.EQUAL,[Iu]:n.GEQUAL,[_m]:n.GREATER,[ym]:n.NOTEQUAL};function le(T,v){if(v.type===Nn&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===en||v.magFilter===Al||v.magFilter===go||v.magFilter===Ai||v.minFilter===en||v.minFilter===Al||v.minFilter===go||v.minFilter===Ai)&&It("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(T,n.TEXTURE_WRAP_S,Ht[v.wrapS]),n.texParameteri(T,n.TEXTURE_WRAP_T,Ht[v.wrapT]),(T===n.TEXTURE_3D||T===n.TEXTURE_2D_ARRAY)&&n.texParameteri(T,n.TEXTURE_WRAP_R,Ht[v.wrapR]),n.texParameteri(T,n.TEXTURE_MAG_FILTER,Te[v.magFilter]),n.texParameteri(T,n.TEXTURE_MIN_FILTER,Te[v.minFilter]),v.compareFunction&&(n.texParameteri(T,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(T,n.TEXTURE_COMPARE_FUNC,Dt[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===ze||v.minFilter!==go&&v.minFilter!==Ai||v.type===Nn&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||i.get(v).__currentAnisotropy){let k=t.get("EXT_texture_filter_anisotropic");n.texParameterf(T,k.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),i.get(v).__currentAnisotropy=v.anisotropy}}}function ue(T,v){let k=!1;T.__webglInit===void 0&&(T.__webglInit=!0,v.addEventListener("dispose",F),O(v));let et=v.source,K=p.get(et);K===void 0&&(K={},p.set(et,K));let rt=J(v);if(rt!==T.__cacheKey){K[rt]===void 0&&(K[rt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,k=!0),K[rt].usedTimes++;let ht=K[T.__cacheKey];ht!==void 0&&(K[T.__cacheKey].usedTimes--,ht.usedTimes===0&&V(v)),T.__cacheKey=rt,T.__webglTexture=K[rt].texture}return k}function Zt(T,v,k){return Math.floor(Math.floor(T/k)/v)}function Ve(T,v,k,et){let rt=T.updateRanges;if(rt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,v.width,v.height,k,et,v.data);else{rt.sort((R,Z)=>R.start-Z.start);let ht=0;for(let R=1;R<rt.length;R++){let Z=rt[ht],$=rt[R],lt=Z.start+Z.count,st=Zt($.start,v.width,4),ot=Zt(Z.start,v.width,4);$.start<=lt+1&&st===ot&&Zt($.start+$.count-1,v.width,4)===st?Z.count=Math.max(Z.count,$.start+$.count-Z.start):(++ht,rt[ht]=$)}rt.length=ht+1;let j=e.getParameter(n.UNPACK_ROW_LENGTH),Y=e.getParameter(n.UNPACK_SKIP_PIXELS),at=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,v.width);for(let R=0,Z=rt.length;R<Z;R++){let $=rt[R],lt=Math.floor($.start/4),st=Math.ceil($.count/4),ot=lt%v.width,Et=Math.floor(lt/v.width),$t=st,it=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,ot),e.pixelStorei(n.UNPACK_SKIP_ROWS,Et),e.texSubImage2D(n.TEXTURE_2D,0,ot,Et,$t,it,k,et,v.data)}T.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,j),e.pixelStorei(n.UNPACK_SKIP_PIXELS,Y),e.pixelStorei(n.UNPACK_SKIP_ROWS,at)}}function Ie(T,v,k){let et=n.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(et=n.TEXTURE_2D_ARRAY),v.isData3DTexture&&(et=n.TEXTURE_3D);let K=ue(T,v),rt=v.source;e.bindTexture(et,T.__webglTexture,n.TEXTURE0+k);let ht=i.get(rt);if(rt.version!==ht.__version||K===!0){if(e.activeTexture(n.TEXTURE0+k),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let it=te.getPrimaries(te.workingColorSpace),Ct=v.colorSpace===Ci?null:te.getPrimaries(v.colorSpace),Wt=v.colorSpace===Ci||it===Ct?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Wt)}e.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment);let Y=y(v.image,!1,s.maxTextureSize);Y=Nt(v,Y);let at=r.convert(v.format,v.colorSpace),R=r.convert(v.type),Z=E(v.internalFormat,at,R,v.normalized,v.colorSpace,v.isVideoTexture);le(et,v);let $,lt=v.mipmaps,st=v.isVideoTexture!==!0,ot=ht.__version===void 0||K===!0,Et=rt.dataReady,$t=M(v,Y);if(v.isDepthTexture)Z=_(v.format===Ri,v.type),ot&&(st?e.texStorage2D(n.TEXTURE_2D,1,Z,Y.width,Y.height):e.texImage2D(n.TEXTURE_2D,0,Z,Y.width,Y.height,0,at,R,null));else if(v.isDataTexture)if(lt.length>0){st&&ot&&e.texStorage2D(n.TEXTURE_2D,$t,Z,lt[0].width,lt[0].height);for(let it=0,Ct=lt.length;it<Ct;it++)$=lt[it],st?Et&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,$.width,$.height,at,R,$.data):e.texImage2D(n.TEXTURE_2D,it,Z,$.width,$.height,0,at,R,$.data);v.generateMipmaps=!1}else st?(ot&&e.texStorage2D(n.TEXTURE_2D,$t,Z,Y.width,Y.height),Et&&Ve(v,Y,at,R)):e.texImage2D(n.TEXTURE_2D,0,Z,Y.width,Y.height,0,at,R,Y.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){st&&ot&&e.texStorage3D(n.TEXTURE_2D_ARRAY,$t,Z,lt[0].width,lt[0].height,Y.depth);for(let it=0,Ct=lt.length;it<Ct;it++)if($=lt[it],v.format!==Jn)if(at!==null)if(st){if(Et)if(v.layerUpdates.size>0){let Wt=Wu($.width,$.height,v.format,v.type);for(let pt of v.layerUpdates){let ce=$.data.subarray(pt*Wt/$.data.BYTES_PER_ELEMENT,(pt+1)*Wt/$.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,pt,$.width,$.height,1,at,ce)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,0,$.width,$.height,Y.depth,at,$.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,it,Z,$.width,$.height,Y.depth,0,$.data,0,0);else It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else st?Et&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,0,$.width,$.height,Y.depth,at,R,$.data):e.texImage3D(n.TEXTURE_2D_ARRAY,it,Z,$.width,$.height,Y.depth,0,at,R,$.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{st&&ot&&e.texStorage2D(n.TEXTURE_2D,$t,Z,lt[0].width,lt[0].height);for(let it=0,Ct=lt.length;it<Ct;it++)$=lt[it],v.format!==Jn?at!==null?st?Et&&e.compressedTexSubImage2D(n.TEXTURE_2D,it,0,0,$.width,$.height,at,$.data):e.compressedTexImage2D(n.TEXTURE_2D,it,Z,$.width,$.height,0,$.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):st?Et&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,$.width,$.height,at,R,$.data):e.texImage2D(n.TEXTURE_2D,it,Z,$.width,$.height,0,at,R,$.data)}else if(v.isDataArrayTexture)if(st){if(ot&&e.texStorage3D(n.TEXTURE_2D_ARRAY,$t,Z,Y.width,Y.height,Y.depth),Et)if(v.layerUpdates.size>0){let it=Wu(Y.width,Y.height,v.format,v.type);for(let Ct of v.layerUpdates){let Wt=Y.data.subarray(Ct*it/Y.data.BYTES_PER_ELEMENT,(Ct+1)*it/Y.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ct,Y.width,Y.height,1,at,R,Wt)}v.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,at,R,Y.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Z,Y.width,Y.height,Y.depth,0,at,R,Y.data);else if(v.isData3DTexture)st?(ot&&e.texStorage3D(n.TEXTURE_3D,$t,Z,Y.width,Y.height,Y.depth),Et&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,at,R,Y.data)):e.texImage3D(n.TEXTURE_3D,0,Z,Y.width,Y.height,Y.depth,0,at,R,Y.data);else if(v.isFramebufferTexture){if(ot)if(st)e.texStorage2D(n.TEXTURE_2D,$t,Z,Y.width,Y.height);else{let it=Y.width,Ct=Y.height;for(let Wt=0;Wt<$t;Wt++)e.texImage2D(n.TEXTURE_2D,Wt,Z,it,Ct,0,at,R,null),it>>=1,Ct>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in n){let it=n.canvas;if(it.hasAttribute("layoutsubtree")||it.setAttribute("layoutsubtree","true"),Y.parentNode!==it){it.appendChild(Y),u.add(v),it.onpaint=Ct=>{let Wt=Ct.changedElements;for(let pt of u)Wt.includes(pt.image)&&(pt.needsUpdate=!0)},it.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Y);else{let Wt=n.RGBA,pt=n.RGBA,ce=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Wt,pt,ce,Y)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(lt.length>0){if(st&&ot){let it=zt(lt[0]);e.texStorage2D(n.TEXTURE_2D,$t,Z,it.width,it.height)}for(let it=0,Ct=lt.length;it<Ct;it++)$=lt[it],st?Et&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,at,R,$):e.texImage2D(n.TEXTURE_2D,it,Z,at,R,$);v.generateMipmaps=!1}else if(st){if(ot){let it=zt(Y);e.texStorage2D(n.TEXTURE_2D,$t,Z,it.width,it.height)}Et&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,at,R,Y)}else e.texImage2D(n.TEXTURE_2D,0,Z,at,R,Y);S(v)&&v.mipmapsAutoUpdate===!0&&w(et),ht.__version=rt.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function on(T,v,k){if(v.image.length!==6)return;let et=ue(T,v),K=v.source;e.bindTexture(n.TEXTURE_CUBE_MAP,T.__webglTexture,n.TEXTURE0+k);let rt=i.get(K);if(K.version!==rt.__version||et===!0){e.activeTexture(n.TEXTURE0+k);let ht=te.getPrimaries(te.workingColorSpace),j=v.colorSpace===Ci?null:te.getPrimaries(v.colorSpace),Y=v.colorSpace===Ci||ht===j?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);let at=v.isCompressedTexture||v.image[0].isCompressedTexture,R=v.image[0]&&v.image[0].isDataTexture,Z=[];for(let pt=0;pt<6;pt++)!at&&!R?Z[pt]=y(v.image[pt],!0,s.maxCubemapSize):Z[pt]=R?v.image[pt].image:v.image[pt],Z[pt]=Nt(v,Z[pt]);let $=Z[0],lt=r.convert(v.format,v.colorSpace),st=r.convert(v.type),ot=E(v.internalFormat,lt,st,v.normalized,v.colorSpace),Et=v.isVideoTexture!==!0,$t=rt.__version===void 0||et===!0,it=K.dataReady,Ct=M(v,$);le(n.TEXTURE_CUBE_MAP,v);let Wt;if(v.isDepthTexture){if(ot=_(v.format===Ri,v.type),$t)if(Et)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,ot,$.width,$.height);else for(let pt=0;pt<6;pt++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,ot,$.width,$.height,0,lt,st,null)}else if(at){Et&&$t&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ct,ot,$.width,$.height);for(let pt=0;pt<6;pt++){Wt=Z[pt].mipmaps;for(let ce=0;ce<Wt.length;ce++){let Ue=Wt[ce];v.format!==Jn?lt!==null?Et?it&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce,0,0,Ue.width,Ue.height,lt,Ue.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce,ot,Ue.width,Ue.height,0,Ue.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Et?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce,0,0,Ue.width,Ue.height,lt,st,Ue.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce,ot,Ue.width,Ue.height,0,lt,st,Ue.data)}}}else{if(Wt=v.mipmaps,Et&&$t){Wt.length>0&&Ct++;let pt=zt(Z[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ct,ot,pt.width,pt.height)}for(let pt=0;pt<6;pt++)if(R){Et?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,0,0,Z[pt].width,Z[pt].height,lt,st,Z[pt].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,ot,Z[pt].width,Z[pt].height,0,lt,st,Z[pt].data);for(let ce=0;ce<Wt.length;ce++){let Li=Wt[ce].image[pt].image;Et?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce+1,0,0,Li.width,Li.height,lt,st,Li.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce+1,ot,Li.width,Li.height,0,lt,st,Li.data)}}else{Et?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,0,0,lt,st,Z[pt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,0,ot,lt,st,Z[pt]);for(let ce=0;ce<Wt.length;ce++){let Ue=Wt[ce];Et?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce+1,0,0,lt,st,Ue.image[pt]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+pt,ce+1,ot,lt,st,Ue.image[pt])}}}S(v)&&v.mipmapsAutoUpdate===!0&&w(n.TEXTURE_CUBE_MAP),rt.__version=K.version,v.onUpdate&&v.onUpdate(v)}T.__version=v.version}function ve(T,v,k,et,K,rt){let ht=r.convert(k.format,k.colorSpace),j=r.convert(k.type),Y=E(k.internalFormat,ht,j,k.normalized,k.colorSpace),at=i.get(v),R=i.get(k);if(R.__renderTarget=v,!at.__hasExternalTextures){let Z=Math.max(1,v.width>>rt),$=Math.max(1,v.height>>rt);K===n.TEXTURE_3D||K===n.TEXTURE_2D_ARRAY?e.texImage3D(K,rt,Y,Z,$,v.depth,0,ht,j,null):e.texImage2D(K,rt,Y,Z,$,0,ht,j,null)}e.bindFramebuffer(n.FRAMEBUFFER,T),ft(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,et,K,R.__webglTexture,0,xe(v)):(K===n.TEXTURE_2D||K>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&K<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,et,K,R.__webglTexture,rt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function Kn(T,v,k){if(n.bindRenderbuffer(n.RENDERBUFFER,T),v.depthBuffer){let et=v.depthTexture,K=et&&et.isDepthTexture?et.type:null,rt=_(v.stencilBuffer,K),ht=v.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;ft(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,xe(v),rt,v.width,v.height):k?n.renderbufferStorageMultisample(n.RENDERBUFFER,xe(v),rt,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,rt,v.width,v.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ht,n.RENDERBUFFER,T)}else{let et=v.textures;for(let K=0;K<et.length;K++){let rt=et[K],ht=r.convert(rt.format,rt.colorSpace),j=r.convert(rt.type),Y=E(rt.internalFormat,ht,j,rt.normalized,rt.colorSpace);ft(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,xe(v),Y,v.width,v.height):k?n.renderbufferStorageMultisample(n.RENDERBUFFER,xe(v),Y,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,Y,v.width,v.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Fe(T,v,k){let et=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,T),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let K=i.get(v.depthTexture);K.__renderTarget=v;let rt=et?v.depthTexture.image[0]:v.depthTexture.image;(!K.__webglTexture||rt.width!==v.width||rt.height!==v.height)&&(rt.width=v.width,rt.height=v.height,v.depthTexture.needsUpdate=!0),et?xt(v.depthTexture,0):gt(v.depthTexture,0);let ht=K.__webglTexture,j=xe(v),Y=et?n.TEXTURE_CUBE_MAP_POSITIVE_X+k:n.TEXTURE_2D,at=v.depthTexture.format===Ri?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(v.depthTexture.format===wi)ft(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,at,Y,ht,0,j):n.framebufferTexture2D(n.FRAMEBUFFER,at,Y,ht,0);else if(v.depthTexture.format===Ri)ft(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,at,Y,ht,0,j):n.framebufferTexture2D(n.FRAMEBUFFER,at,Y,ht,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Sn(T){let v=i.get(T),k=T.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==T.depthTexture){let et=T.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),et){let K=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,et.removeEventListener("dispose",K)};et.addEventListener("dispose",K),v.__depthDisposeCallback=K}v.__boundDepthTexture=et}if(T.depthTexture&&!v.__autoAllocateDepthBuffer)if(k)for(let et=0;et<6;et++)Fe(v.__webglFramebuffer[et],T,et);else T.texture.mipmaps.length>0?Fe(v.__webglFramebuffer[0],T,0):Fe(v.__webglFramebuffer,T,0);else if(k){v.__webglDepthbuffer=[];for(let et=0;et<6;et++)if(e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[et]),v.__webglDepthbuffer[et]===void 0)v.__webglDepthbuffer[et]=n.createRenderbuffer(),Kn(v.__webglDepthbuffer[et],T,!1);else{let K=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,rt=v.__webglDepthbuffer[et];n.bindRenderbuffer(n.RENDERBUFFER,rt),n.framebufferRenderbuffer(n.FRAMEBUFFER,K,n.RENDERBUFFER,rt)}}else if(T.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=n.createRenderbuffer(),Kn(v.__webglDepthbuffer,T,!1);else{let K=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,rt=v.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,rt),n.framebufferRenderbuffer(n.FRAMEBUFFER,K,n.RENDERBUFFER,rt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function Tn(T,v,k){let et=i.get(T);v!==void 0&&ve(et.__webglFramebuffer,T,T.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),k!==void 0&&Sn(T)}function En(T){let v=T.texture,k=i.get(T),et=i.get(v);T.addEventListener("dispose",B),O(T);let K=T.textures,rt=T.isWebGLCubeRenderTarget===!0,ht=K.length>1;if(ht||(et.__webglTexture===void 0&&(et.__webglTexture=n.createTexture()),et.__version=v.version,o.memory.textures++),rt){k.__webglFramebuffer=[];for(let j=0;j<6;j++)if(v.mipmaps.length>0){k.__webglFramebuffer[j]=[];for(let Y=0;Y<v.mipmaps.length;Y++)k.__webglFramebuffer[j][Y]=n.createFramebuffer()}else k.__webglFramebuffer[j]=n.createFramebuffer()}else{if(v.mipmaps.length>0){k.__webglFramebuffer=[];for(let j=0;j<v.mipmaps.length;j++)k.__webglFramebuffer[j]=n.createFramebuffer()}else k.__webglFramebuffer=n.createFramebuffer();if(ht)for(let j=0,Y=K.length;j<Y;j++){let at=i.get(K[j]);at.__webglTexture===void 0&&(at.__webglTexture=n.createTexture(),o.memory.textures++)}if(T.samples>0&&ft(T)===!1){k.__webglMultisampledFramebuffer=n.createFramebuffer(),k.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,k.__webglMultisampledFramebuffer);for(let j=0;j<K.length;j++){let Y=K[j];k.__webglColorRenderbuffer[j]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,k.__webglColorRenderbuffer[j]);let at=r.convert(Y.format,Y.colorSpace),R=r.convert(Y.type),Z=E(Y.internalFormat,at,R,Y.normalized,Y.colorSpace,T.isXRRenderTarget===!0),$=xe(T);n.renderbufferStorageMultisample(n.RENDERBUFFER,$,Z,T.width,T.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+j,n.RENDERBUFFER,k.__webglColorRenderbuffer[j])}n.bindRenderbuffer(n.RENDERBUFFER,null),T.depthBuffer&&(k.__webglDepthRenderbuffer=n.createRenderbuffer(),Kn(k.__webglDepthRenderbuffer,T,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(rt){e.bindTexture(n.TEXTURE_CUBE_MAP,et.__webglTexture),le(n.TEXTURE_CUBE_MAP,v);for(let j=0;j<6;j++)if(v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)ve(k.__webglFramebuffer[j][Y],T,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+j,Y);else ve(k.__webglFramebuffer[j],T,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+j,0);S(v)?w(n.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(ht){for(let j=0,Y=K.length;j<Y;j++){let at=K[j],R=i.get(at),Z=n.TEXTURE_2D;(T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(Z=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(Z,R.__webglTexture),le(Z,at),ve(k.__webglFramebuffer,T,at,n.COLOR_ATTACHMENT0+j,Z,0),S(at)&&w(Z)}e.unbindTexture()}else{let j=n.TEXTURE_2D;if((T.isWebGL3DRenderTarget||T.isWebGLArrayRenderTarget)&&(j=T.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(j,et.__webglTexture),le(j,v),v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)ve(k.__webglFramebuffer[Y],T,v,n.COLOR_ATTACHMENT0,j,Y);else ve(k.__webglFramebuffer,T,v,n.COLOR_ATTACHMENT0,j,0);S(v)?w(j):v.mipmaps.length>0&&n.texParameteri(j,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}T.depthBuffer&&Sn(T)}function D(T){let v=T.textures;for(let k=0,et=v.length;k<et;k++){let K=v[k];if(S(K)&&K.mipmapsAutoUpdate===!0){let rt=A(T),ht=i.get(K).__webglTexture;e.bindTexture(rt,ht),w(rt),e.unbindTexture()}}}let An=[];function ge(T){if(T.samples>0){if(ft(T)===!1){let v=T.textures,k=T.width,et=T.height,K=n.COLOR_BUFFER_BIT,rt=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ht=i.get(T),j=v.length>1;if(j)for(let at=0;at<v.length;at++)e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,ht.__webglMultisampledFramebuffer),T.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,ht.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,ht.__webglFramebuffer);for(let at=0;at<v.length;at++){if(T.resolveDepthBuffer&&(T.depthBuffer&&(K|=n.DEPTH_BUFFER_BIT),T.stencilBuffer&&T.resolveStencilBuffer&&(K|=n.STENCIL_BUFFER_BIT)),j){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ht.__webglColorRenderbuffer[at]);let R=i.get(v[at]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,R,0)}n.blitFramebuffer(0,0,k,et,0,0,k,et,K,n.NEAREST),l===!0&&(An.length=0,An.push(n.COLOR_ATTACHMENT0+at),T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&An.push(rt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,An))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),j)for(let at=0;at<v.length;at++){e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.RENDERBUFFER,ht.__webglColorRenderbuffer[at]);let R=i.get(v[at]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.TEXTURE_2D,R,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,ht.__webglMultisampledFramebuffer)}else if(T.depthBuffer&&T.storeMultisampledDepthBuffer===!1&&l){let v=T.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[v])}}}function xe(T){return Math.min(s.maxSamples,T.samples)}function ft(T){let v=i.get(T);return T.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function Le(T){let v=o.render.frame;h.get(T)!==v&&(h.set(T,v),T.update())}function Nt(T,v){let k=T.colorSpace,et=T.format,K=T.type;return T.isCompressedTexture===!0||T.isVideoTexture===!0||k!==Gr&&k!==Ci&&(te.getTransfer(k)===ae?(et!==Jn||K!==dn)&&It("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ft("WebGLTextures: Unsupported texture color space:",k)),v}function zt(T){return typeof HTMLImageElement<"u"&&T instanceof HTMLImageElement?(c.width=T.naturalWidth||T.width,c.height=T.naturalHeight||T.height):typeof VideoFrame<"u"&&T instanceof VideoFrame?(c.width=T.displayWidth,c.height=T.displayHeight):(c.width=T.width,c.height=T.height),c}this.allocateTextureUnit=Gt,this.resetTextureUnits=Q,this.getTextureUnits=tt,this.setTextureUnits=St,this.setTexture2D=gt,this.setTexture2DArray=bt,this.setTexture3D=Lt,this.setTextureCube=xt,this.rebindTextures=Tn,this.setupRenderTarget=En,this.updateRenderTargetMipmap=D,this.updateMultisampleRenderTarget=ge,this.setupDepthRenderbuffer=Sn,this.setupFrameBufferTexture=ve,this.useMultisampledRTT=ft,this.dispose=H}function vS(n,t){function e(i,s=Ci){let r,o=te.getTransfer(s);if(i===dn)return n.UNSIGNED_BYTE;if(i===Cl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Pl)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Eu)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Au)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Su)return n.BYTE;if(i===Tu)return n.SHORT;if(i===lr)return n.UNSIGNED_SHORT;if(i===Rl)return n.INT;if(i===jn)return n.UNSIGNED_INT;if(i===Nn)return n.FLOAT;if(i===Yn)return n.HALF_FLOAT;if(i===Ru)return n.ALPHA;if(i===Cu)return n.RGB;if(i===Jn)return n.RGBA;if(i===wi)return n.DEPTH_COMPONENT;if(i===Ri)return n.DEPTH_STENCIL;if(i===Il)return n.RED;if(i===Ll)return n.RED_INTEGER;if(i===Qi)return n.RG;if(i===Nl)return n.RG_INTEGER;if(i===Dl)return n.RGBA_INTEGER;if(i===xo||i===_o||i===yo||i===vo)if(o===ae)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===xo)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===_o)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===yo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===vo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===xo)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===_o)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===yo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===vo)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ol||i===Fl||i===Ul||i===kl)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ol)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Fl)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ul)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===kl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Bl||i===zl||i===Gl||i===Vl||i===Hl||i===bo||i===Wl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Bl||i===zl)return o===ae?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Gl)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Vl)return r.COMPRESSED_R11_EAC;if(i===Hl)return r.COMPRESSED_SIGNED_R11_EAC;if(i===bo)return r.COMPRESSED_RG11_EAC;if(i===Wl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===$l||i===Xl||i===ql||i===jl||i===Yl||i===Jl||i===Zl||i===Kl||i===Ql||i===tc||i===ec||i===nc||i===ic||i===sc)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===$l)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Xl)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ql)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===jl)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Yl)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Jl)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Zl)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Kl)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Ql)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===tc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===ec)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===nc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===ic)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===sc)return o===ae?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===rc||i===oc||i===ac)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===rc)return o===ae?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===oc)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===ac)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===lc||i===cc||i===Mo||i===hc)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===lc)return r.COMPRESSED_RED_RGTC1_EXT;if(i===cc)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Mo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===hc)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===ys?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var bS=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,MS=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Qu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new to(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Ln({vertexShader:bS,fragmentShader:MS,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Pe(new ps(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},td=class extends qn{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,d=null,p=null,f=null,x=typeof XRWebGLBinding<"u",m=new Qu,g={},y=e.getContextAttributes(),S=null,w=null,A=[],E=[],_=new yt,M=null,O=null,N=new tn;N.viewport=new _e;let F=new tn;F.viewport=new _e;let B=[N,F],W=new Sl,P=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let gt=A[J];return gt===void 0&&(gt=new tr,A[J]=gt),gt.getTargetRaySpace()},this.getControllerGrip=function(J){let gt=A[J];return gt===void 0&&(gt=new tr,A[J]=gt),gt.getGripSpace()},this.getHand=function(J){let gt=A[J];return gt===void 0&&(gt=new tr,A[J]=gt),gt.getHandSpace()};function q(J){let gt=E.indexOf(J.inputSource);if(gt===-1)return;let bt=A[gt];bt!==void 0&&(bt.update(J.inputSource,J.frame,c||o),bt.dispatchEvent({type:J.type,data:J.inputSource}))}function V(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",V),s.removeEventListener("inputsourceschange",nt);for(let J=0;J<A.length;J++){let gt=E[J];gt!==null&&(E[J]=null,A[J].disconnect(gt))}P=null,H=null,m.reset();for(let J in g)delete g[J];if(t.setRenderTarget(S),p=null,d=null,u=null,s=null,w=null,Gt.stop(),i.isPresenting=!1,t.setPixelRatio(M),t.setSize(_.width,_.height,!1),O!==null){let J=O.camera;J.fov=O.fov,J.zoom=O.zoom,J.updateProjectionMatrix(),O=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,i.isPresenting===!0&&It("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){a=J,i.isPresenting===!0&&It("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(J){c=J},this.getBaseLayer=function(){return d!==null?d:p},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return f},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",V),s.addEventListener("inputsourceschange",nt),y.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let bt=null,Lt=null,xt=null;y.depth&&(xt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,bt=y.stencil?Ri:wi,Lt=y.stencil?ys:jn);let Ht={colorFormat:e.RGBA8,depthFormat:xt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Ht),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),w=new bn(d.textureWidth,d.textureHeight,{format:Jn,type:dn,depthTexture:new Ei(d.textureWidth,d.textureHeight,Lt,void 0,void 0,void 0,void 0,void 0,void 0,bt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let bt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,bt),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),w=new bn(p.framebufferWidth,p.framebufferHeight,{format:Jn,type:dn,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}w.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Gt.setContext(s),Gt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function nt(J){for(let gt=0;gt<J.removed.length;gt++){let bt=J.removed[gt],Lt=E.indexOf(bt);Lt>=0&&(E[Lt]=null,A[Lt].disconnect(bt))}for(let gt=0;gt<J.added.length;gt++){let bt=J.added[gt],Lt=E.indexOf(bt);if(Lt===-1){for(let Ht=0;Ht<A.length;Ht++)if(Ht>=E.length){E.push(bt),Lt=Ht;break}else if(E[Ht]===null){E[Ht]=bt,Lt=Ht;break}if(Lt===-1)break}let xt=A[Lt];xt&&xt.connect(bt)}}function X(J,gt){gt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(gt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let gt=J.near,bt=J.far;m.texture!==null&&(m.depthNear>0&&(gt=m.depthNear),m.depthFar>0&&(bt=m.depthFar)),W.near=F.near=N.near=gt,W.far=F.far=N.far=bt,(P!==W.near||H!==W.far)&&(s.updateRenderState({depthNear:W.near,depthFar:W.far}),P=W.near,H=W.far),W.layers.mask=J.layers.mask|6,N.layers.mask=W.layers.mask&-5,F.layers.mask=W.layers.mask&-3;let Lt=J.parent,xt=W.cameras;X(W,Lt);for(let Ht=0;Ht<xt.length;Ht++)X(xt[Ht],Lt);W.projectionMatrix.copy(N.projectionMatrix),W.projectionMatrixInverse.copy(N.projectionMatrixInverse),O===null&&J.isPerspectiveCamera&&(O={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,W,Lt)};function Q(J,gt,bt){bt===null?J.matrix.copy(gt.matrixWorld):(J.matrix.copy(bt.matrixWorld),J.matrix.invert(),J.matrix.multiply(gt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(gt.projectionMatrix),J.projectionMatrixInverse.copy(gt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Zs*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return W},this.getFoveation=function(){if(!(d===null&&p===null))return l},this.setFoveation=function(J){l=J,d!==null&&(d.fixedFoveation=J),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=J)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(W)},this.getCameraTexture=function(J){return g[J]};let tt=null;function St(J,gt){if(h=gt.getViewerPose(c||o),f=gt,h!==null){let bt=h.views;p!==null&&(t.setRenderTargetFramebuffer(w,p.framebuffer),t.setRenderTarget(w));let Lt=!1;bt.length!==W.cameras.length&&(W.cameras.length=0,Lt=!0);for(let Dt=0;Dt<bt.length;Dt++){let le=bt[Dt],ue=null;if(p!==null)ue=p.getViewport(le);else{let Ve=u.getViewSubImage(d,le);ue=Ve.viewport,Dt===0&&(t.setRenderTargetTextures(w,Ve.colorTexture,Ve.depthStencilTexture),t.setRenderTarget(w))}let Zt=B[Dt];Zt===void 0&&(Zt=new tn,Zt.layers.enable(Dt),Zt.viewport=new _e,B[Dt]=Zt),Zt.matrix.fromArray(le.transform.matrix),Zt.matrix.decompose(Zt.position,Zt.quaternion,Zt.scale),Zt.projectionMatrix.fromArray(le.projectionMatrix),Zt.projectionMatrixInverse.copy(Zt.projectionMatrix).invert(),Zt.viewport.set(ue.x,ue.y,ue.width,ue.height),Dt===0&&(W.matrix.copy(Zt.matrix),W.matrix.decompose(W.position,W.quaternion,W.scale)),Lt===!0&&W.cameras.push(Zt)}let xt=s.enabledFeatures;if(xt&&xt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=i.getBinding();let Dt=u.getDepthInformation(bt[0]);Dt&&Dt.isValid&&Dt.texture&&m.init(Dt,s.renderState)}if(xt&&xt.includes("camera-access")&&x){t.state.unbindTexture(),u=i.getBinding();for(let Dt=0;Dt<bt.length;Dt++){let le=bt[Dt].camera;if(le){let ue=g[le];ue||(ue=new to,g[le]=ue);let Zt=u.getCameraImage(le);ue.sourceTexture=Zt}}}}for(let bt=0;bt<A.length;bt++){let Lt=E[bt],xt=A[bt];Lt!==null&&xt!==void 0&&xt.update(Lt,gt,c||o)}tt&&tt(J,gt),gt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:gt}),f=null}let Gt=new Km;Gt.setAnimationLoop(St),this.setAnimationLoop=function(J){tt=J},this.dispose=function(){}}},wS=new ne,lg=new Bt;lg.set(-1,0,0,0,1,0,0,0,1);function SS(n,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Gu(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,S,w){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&p(m,g,w)):g.isMeshMatcapMaterial?(r(m,g),f(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,y,S):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===sn&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===sn&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=t.get(g),S=y.envMap,w=y.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(wS.makeRotationFromEuler(w)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(lg),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,y,S){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=S*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function p(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===sn&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function f(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let y=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function TS(n,t,e,i){let s={},r={};function o(y,S){let w=S.program;i.uniformBlockBinding(y,w,s[y.id])}function a(y,S){let w=s[y.id];w===void 0&&(f(y),w=l(y),s[y.id]=w,y.addEventListener("dispose",m));let A=S.program;i.updateUBOMapping(y,A);let E=t.render.frame;r[y.id]!==E&&(c(y),r[y.id]=E)}function l(y){let S=n.createBuffer(),w=y.__size,A=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,S),n.bufferData(n.UNIFORM_BUFFER,w,A),n.bindBuffer(n.UNIFORM_BUFFER,null),S}function c(y){let S=s[y.id],w=y.uniforms,A=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,S);for(let E=0,_=w.length;E<_;E++){let M=w[E];if(Array.isArray(M))for(let O=0,N=M.length;O<N;O++)h(M[O],E,O,A);else h(M,E,0,A)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(y,S,w,A){if(d(y,S,w,A)===!0){let E=y.__offset,_=y.value;if(Array.isArray(_)){let M=0;for(let O=0;O<_.length;O++){let N=_[O],F=x(N,!0);u(N,y.__data,M),M+=F.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,y.__data)}}function u(y,S,w){typeof y=="number"||typeof y=="boolean"?S[w]=y:y.isMatrix3?(S[w]=y.elements[0],S[w+1]=y.elements[1],S[w+2]=y.elements[2],S[w+3]=0,S[w+4]=y.elements[3],S[w+5]=y.elements[4],S[w+6]=y.elements[5],S[w+7]=0,S[w+8]=y.elements[6],S[w+9]=y.elements[7],S[w+10]=y.elements[8],S[w+11]=0):ArrayBuffer.isView(y)?S.set(y.subarray(0,S.length-w),w):y.toArray(S,w)}function d(y,S,w,A){let E=y.value,_=S+"_"+w;if(Array.isArray(E)){A[_]===void 0&&(A[_]=[]);let M=A[_],O=!1;for(let N=0;N<E.length;N++)p(E[N],M,N)===!0&&(O=!0);return O}return p(E,A,_)}function p(y,S,w){if(S[w]===void 0)return typeof y=="number"||typeof y=="boolean"?S[w]=y:ArrayBuffer.isView(y)?S[w]=y.slice():S[w]=y.clone(),!0;{let A=S[w];if(typeof y=="number"||typeof y=="boolean"){if(A!==y)return S[w]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(A.equals(y)===!1)return A.copy(y),!0}}return!1}function f(y){let S=y.uniforms,w=0,A=16;for(let _=0,M=S.length;_<M;_++){let O=Array.isArray(S[_])?S[_]:[S[_]];for(let N=0,F=O.length;N<F;N++){let B=O[N],W=Array.isArray(B.value)?B.value:[B.value],P=Array.isArray(S[_])||Array.isArray(B.value),H=w;for(let V=0,nt=W.length;V<nt;V++){let X=W[V],Q=x(X,P),tt=w%A,St=tt%Q.boundary,Gt=tt+St;w+=St,Gt!==0&&A-Gt<Q.storage&&(w+=A-Gt),V===0&&(H=w),w+=Q.storage}let q=B.type==="int"?Int32Array:B.type==="uint"?Uint32Array:Float32Array;B.__data=new q((w-H)/Float32Array.BYTES_PER_ELEMENT),B.__offset=H}}let E=w%A;return E>0&&(w+=A-E),y.__size=w,y.__cache={},this}function x(y,S){let w={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(w.boundary=4,w.storage=4):y.isVector2?(w.boundary=8,w.storage=8):y.isVector3||y.isColor?(w.boundary=16,w.storage=12):y.isVector4?(w.boundary=16,w.storage=16):y.isMatrix3?(w.boundary=16,w.storage=48):y.isMatrix4?(w.boundary=16,w.storage=64):y.isTexture?It("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(w.boundary=16,w.storage=y.byteLength):It("WebGLRenderer: Unsupported uniform value type.",y),S===!0&&(w.boundary=16,w.storage=Math.ceil(w.storage/16)*16),w}function m(y){let S=y.target;S.removeEventListener("dispose",m),n.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function g(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var ES=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),ai=null;function AS(){return ai===null&&(ai=new jr(ES,16,16,Qi,Yn),ai.name="DFG_LUT",ai.minFilter=en,ai.magFilter=en,ai.wrapS=ii,ai.wrapT=ii,ai.generateMipmaps=!1,ai.needsUpdate=!0),ai}var mc=class{constructor(t={}){let{canvas:e=bm(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:p=dn}=t;this.isWebGLRenderer=!0;let f;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");f=i.getContextAttributes().alpha}else f=o;let x=p,m=new Set([Dl,Nl,Ll]),g=new Set([dn,jn,lr,ys,Cl,Pl]),y=new Uint32Array(4),S=new Int32Array(4),w={textures:[],min:[],max:[],resolution:[]},A=null,E=null,_=[],M=[],O=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=oi,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let N=this,F=!1,B=null,W=null,P=null,H=null;this._outputColorSpace=vn;let q=0,V=0,nt=null,X=-1,Q=null,tt=new _e,St=new _e,Gt=null,J=new kt(0),gt=0,bt=e.width,Lt=e.height,xt=1,Ht=null,Te=null,Dt=new _e(0,0,bt,Lt),le=new _e(0,0,bt,Lt),ue=!1,Zt=new $i,Ve=new Qa,Ie=!1,on=!1,ve=new ne,Kn=new I,Fe=new _e,Sn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Tn=!1;function En(){return nt===null?xt:1}let D=i;function An(b,L){return e.getContext(b,L)}let ge,xe,ft,Le,Nt,zt,T,v,k,et,K,rt,ht,j,Y,at,R,Z,$,lt,st,ot,Et;try{let b={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ct,!1),e.addEventListener("webglcontextrestored",Wt,!1),e.addEventListener("webglcontextcreationerror",pt,!1),D===null){let L="webgl2";if(D=An(L,b),D===null)throw An(L)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}$t()}catch(b){throw e.removeEventListener("webglcontextlost",Ct,!1),e.removeEventListener("webglcontextrestored",Wt,!1),e.removeEventListener("webglcontextcreationerror",pt,!1),Ft("WebGLRenderer: "+b.message),b}function $t(){ge=new kM(D),ge.init(),st=new vS(D,ge),xe=new AM(D,ge,t,st),ft=new _S(D,ge),xe.reversedDepthBuffer&&d&&ft.buffers.depth.setReversed(!0),W=D.createFramebuffer(),P=D.createFramebuffer(),H=D.createFramebuffer(),Le=new GM(D),Nt=new sS,zt=new yS(D,ge,ft,Nt,xe,st,Le),T=new UM(N),v=new Hy(D),ot=new TM(D,v),k=new BM(D,v,Le,ot),et=new HM(D,k,v,ot,Le),Z=new VM(D,xe,zt),Y=new RM(Nt),K=new iS(N,T,ge,xe,ot,Y),rt=new SS(N,Nt),ht=new oS,j=new dS(ge),R=new SM(N,T,ft,et,f,l),at=new xS(N,et,xe),Et=new TS(D,Le,xe,ft),$=new EM(D,ge,Le),lt=new zM(D,ge,Le),Le.programs=K.programs,N.capabilities=xe,N.extensions=ge,N.properties=Nt,N.renderLists=ht,N.shadowMap=at,N.state=ft,N.info=Le}x!==dn&&(O=new $M(x,e.width,e.height,a,s,r));let it=new td(N,D);this.xr=it,this.getContext=function(){return D},this.getContextAttributes=function(){return D.getContextAttributes()},this.forceContextLoss=function(){let b=ge.get("WEBGL_lose_context");b&&b.loseContext()},this.forceContextRestore=function(){let b=ge.get("WEBGL_lose_context");b&&b.restoreContext()},this.getPixelRatio=function(){return xt},this.setPixelRatio=function(b){b!==void 0&&(xt=b,this.setSize(bt,Lt,!1))},this.getSize=function(b){return b.set(bt,Lt)},this.setSize=function(b,L,G=!0){if(it.isPresenting){It("WebGLRenderer: Can't change size while VR device is presenting.");return}bt=b,Lt=L,e.width=Math.floor(b*xt),e.height=Math.floor(L*xt),G===!0&&(e.style.width=b+"px",e.style.height=L+"px"),O!==null&&O.setSize(e.width,e.height),this.setViewport(0,0,b,L)},this.getDrawingBufferSize=function(b){return b.set(bt*xt,Lt*xt).floor()},this.setDrawingBufferSize=function(b,L,G){bt=b,Lt=L,xt=G,e.width=Math.floor(b*G),e.height=Math.floor(L*G),this.setViewport(0,0,b,L)},this.setEffects=function(b){if(x===dn){Ft("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(b){for(let L=0;L<b.length;L++)if(b[L].isOutputPass===!0){It("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}O.setEffects(b||[])},this.getCurrentViewport=function(b){return b.copy(tt)},this.getViewport=function(b){return b.copy(Dt)},this.setViewport=function(b,L,G,U){b.isVector4?Dt.set(b.x,b.y,b.z,b.w):Dt.set(b,L,G,U),ft.viewport(tt.copy(Dt).multiplyScalar(En()).round())},this.getScissor=function(b){return b.copy(le)},this.setScissor=function(b,L,G,U){b.isVector4?le.set(b.x,b.y,b.z,b.w):le.set(b,L,G,U),ft.scissor(St.copy(le).multiplyScalar(En()).round())},this.getScissorTest=function(){return ue},this.setScissorTest=function(b){ft.setScissorTest(ue=b)},this.setOpaqueSort=function(b){Ht=b},this.setTransparentSort=function(b){Te=b},this.getClearColor=function(b){return b.copy(R.getClearColor())},this.setClearColor=function(){R.setClearColor(...arguments)},this.getClearAlpha=function(){return R.getClearAlpha()},this.setClearAlpha=function(){R.setClearAlpha(...arguments)},this.clear=function(b=!0,L=!0,G=!0){let U=0;if(b){let z=!1;if(nt!==null){let ut=nt.texture.format;z=m.has(ut)}if(z){let ut=nt.texture.type,vt=g.has(ut),ct=R.getClearColor(),_t=R.getClearAlpha(),Tt=ct.r,Vt=ct.g,Kt=ct.b;vt?(y[0]=Tt,y[1]=Vt,y[2]=Kt,y[3]=_t,D.clearBufferuiv(D.COLOR,0,y)):(S[0]=Tt,S[1]=Vt,S[2]=Kt,S[3]=_t,D.clearBufferiv(D.COLOR,0,S))}else U|=D.COLOR_BUFFER_BIT}L&&(U|=D.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),G&&(U|=D.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),U!==0&&D.clear(U)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(b){b.setRenderer(this),B=b},this.dispose=function(){e.removeEventListener("webglcontextlost",Ct,!1),e.removeEventListener("webglcontextrestored",Wt,!1),e.removeEventListener("webglcontextcreationerror",pt,!1),R.dispose(),ht.dispose(),j.dispose(),zt.dispose(),Nt.dispose(),T.dispose(),et.dispose(),k.dispose(),ot.dispose(),Et.dispose(),K.dispose(),it.dispose(),it.removeEventListener("sessionstart",Jd),it.removeEventListener("sessionend",Zd),ss.stop()};function Ct(b){b.preventDefault(),Ou("WebGLRenderer: Context Lost."),F=!0}function Wt(){Ou("WebGLRenderer: Context Restored."),F=!1;let b=Le.autoReset,L=at.enabled,G=at.autoUpdate,U=at.needsUpdate,z=at.type;$t(),Le.autoReset=b,at.enabled=L,at.autoUpdate=G,at.needsUpdate=U,at.type=z}function pt(b){Ft("WebGLRenderer: A WebGL context could not be created. Reason: ",b.statusMessage)}function ce(b){let L=b.target;L.removeEventListener("dispose",ce),Ue(L)}function Ue(b){Li(b),Nt.remove(b)}function Li(b){let L=Nt.get(b).programs;L!==void 0&&(L.forEach(function(G){K.releaseProgram(G)}),b.isShaderMaterial&&K.releaseShaderCache(b))}this.renderBufferDirect=function(b,L,G,U,z,ut){L===null&&(L=Sn);let vt=z.isMesh&&z.matrixWorld.determinantAffine()<0,ct=Ox(b,L,G,U,z);ft.setMaterial(U,vt);let _t=G.index,Tt=1;if(U.wireframe===!0){if(_t=k.getWireframeAttribute(G),_t===void 0)return;Tt=2}let Vt=G.drawRange,Kt=G.attributes.position,Mt=Vt.start*Tt,Qt=(Vt.start+Vt.count)*Tt;ut!==null&&(Mt=Math.max(Mt,ut.start*Tt),Qt=Math.min(Qt,(ut.start+ut.count)*Tt)),_t!==null?(Mt=Math.max(Mt,0),Qt=Math.min(Qt,_t.count)):Kt!=null&&(Mt=Math.max(Mt,0),Qt=Math.min(Qt,Kt.count));let Ee=Qt-Mt;if(Ee<0||Ee===1/0)return;ot.setup(z,U,ct,G,_t);let fe,de=$;if(_t!==null&&(fe=v.get(_t),de=lt,de.setIndex(fe)),z.isMesh)U.wireframe===!0?(ft.setLineWidth(U.wireframeLinewidth*En()),de.setMode(D.LINES)):de.setMode(D.TRIANGLES);else if(z.isLine){let Xe=U.linewidth;Xe===void 0&&(Xe=1),ft.setLineWidth(Xe*En()),z.isLineSegments?de.setMode(D.LINES):z.isLineLoop?de.setMode(D.LINE_LOOP):de.setMode(D.LINE_STRIP)}else z.isPoints?de.setMode(D.POINTS):z.isSprite&&de.setMode(D.TRIANGLES);if(z.isBatchedMesh)if(ge.get("WEBGL_multi_draw"))de.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let Xe=z._multiDrawStarts,wt=z._multiDrawCounts,Ke=z._multiDrawCount,ie=_t?v.get(_t).bytesPerElement:1,rs=Nt.get(U).currentProgram.getUniforms();for(let qe=0;qe<Ke;qe++)rs.setValue(D,"_gl_DrawID",qe),de.render(Xe[qe]/ie,wt[qe])}else if(z.isInstancedMesh)de.renderInstances(Mt,Ee,z.count);else if(G.isInstancedBufferGeometry){let Xe=G._maxInstanceCount!==void 0?G._maxInstanceCount:1/0,wt=Math.min(G.instanceCount,Xe);de.renderInstances(Mt,Ee,wt)}else de.render(Mt,Ee)};function Yd(b,L,G,U){B!==null&&b.isNodeMaterial&&B.setObject(U,b),Ie===!0&&Y.setState(b,G,!1),b.transparent===!0&&b.side===rn&&b.forceSinglePass===!1?(b.side=sn,b.needsUpdate=!0,Mr(b,L,U),b.side=Ki,b.needsUpdate=!0,Mr(b,L,U),b.side=rn):Mr(b,L,U)}this.compile=function(b,L,G=null){G===null&&(G=b),B!==null&&B.renderStart(b,L,G),E=j.get(G),E.init(L),M.push(E),G.traverseVisible(function(z){z.isLight&&z.layers.test(L.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),b!==G&&b.traverseVisible(function(z){z.isLight&&z.layers.test(L.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),B!==null&&B.updateLights(E.state.lightsArray),on=this.localClippingEnabled,Ie=Y.init(this.clippingPlanes,on),Ie===!0&&Y.setGlobalState(this.clippingPlanes,L),B!==null&&at.render(E.state.shadowsArray,G,L);let U=new Set;return b.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let ut=z.material;if(ut)if(Array.isArray(ut))for(let vt=0;vt<ut.length;vt++){let ct=ut[vt];Yd(ct,G,L,z),U.add(ct)}else Yd(ut,G,L,z),U.add(ut)}),E=M.pop(),B!==null&&B.renderEnd(),U},this.compileAsync=function(b,L,G=null){let U=this.compile(b,L,G);return new Promise(z=>{function ut(){if(U.forEach(function(vt){let _t=Nt.get(vt).currentProgram;(_t===void 0||_t.isReady())&&U.delete(vt)}),U.size===0){z(b);return}setTimeout(ut,10)}ge.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let nh=null;function Nx(b){nh&&nh(b)}function Jd(){ss.stop()}function Zd(){ss.start()}let ss=new Km;ss.setAnimationLoop(Nx),typeof self<"u"&&ss.setContext(self),this.setAnimationLoop=function(b){nh=b,it.setAnimationLoop(b),b===null?ss.stop():ss.start()},it.addEventListener("sessionstart",Jd),it.addEventListener("sessionend",Zd),this.render=function(b,L){if(L!==void 0&&L.isCamera!==!0){Ft("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(F===!0)return;B!==null&&B.renderStart(b,L);let G=it.enabled===!0&&it.isPresenting===!0,U=O!==null&&(nt===null||G)&&O.begin(N,nt);if(b.matrixWorldAutoUpdate===!0&&b.updateMatrixWorld(),L.parent===null&&L.matrixWorldAutoUpdate===!0&&L.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(O===null||O.isCompositing()===!1)&&(it.cameraAutoUpdate===!0&&it.updateCamera(L),L=it.getCamera()),b.isScene===!0&&b.onBeforeRender(N,b,L,nt),E=j.get(b,M.length),E.init(L),E.state.textureUnits=zt.getTextureUnits(),M.push(E),ve.multiplyMatrices(L.projectionMatrix,L.matrixWorldInverse),L.isArrayCamera?Ve.setFromArrayCamera(L):Zt.setFromProjectionMatrix(ve,Pn,L.reversedDepth),on=this.localClippingEnabled,Ie=Y.init(this.clippingPlanes,on),A=ht.get(b,_.length),A.init(),_.push(A),this.info.render.frame++,it.enabled===!0&&it.isPresenting===!0){let vt=N.xr.getDepthSensingMesh();vt!==null&&ih(vt,L,-1/0,N.sortObjects)}ih(b,L,0,N.sortObjects),A.finish(),B!==null&&B.updateLights(E.state.lightsArray),N.sortObjects===!0&&A.sort(Ht,Te),Tn=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,Tn&&R.addToRenderList(A,b),this.info.autoReset===!0&&this.info.reset(),Ie===!0&&Y.beginShadows();let z=E.state.shadowsArray;if(at.render(z,b,L),Ie===!0&&Y.endShadows(),(U&&O.hasRenderPass())===!1){let vt=A.opaque,ct=A.transmissive;if(E.setupLights(),L.isArrayCamera){let _t=L.cameras;if(ct.length>0)for(let Tt=0,Vt=_t.length;Tt<Vt;Tt++){let Kt=_t[Tt];Qd(vt,ct,b,Kt)}Tn&&R.render(b);for(let Tt=0,Vt=_t.length;Tt<Vt;Tt++){let Kt=_t[Tt];Kd(A,b,Kt,Kt.viewport)}}else ct.length>0&&Qd(vt,ct,b,L),Tn&&R.render(b),Kd(A,b,L)}nt!==null&&V===0&&(zt.updateMultisampleRenderTarget(nt),zt.updateRenderTargetMipmap(nt)),U&&O.end(N),b.isScene===!0&&b.onAfterRender(N,b,L),ot.resetDefaultState(),X=-1,Q=null,M.pop(),M.length>0?(E=M[M.length-1],zt.setTextureUnits(E.state.textureUnits),Ie===!0&&Y.setGlobalState(N.clippingPlanes,E.state.camera)):E=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,B!==null&&B.renderEnd()};function ih(b,L,G,U){if(b.visible===!1)return;if(b.layers.test(L.layers)){if(b.isGroup)G=b.renderOrder;else if(b.isLOD)b.autoUpdate===!0&&b.update(L);else if(b.isLight)E.pushLight(b),b.castShadow&&E.pushShadow(b);else if(b.isSprite){let vt=L.isArrayCamera?Ve:Zt;if(!b.frustumCulled||b.intersectsFrustum(vt)){U&&Fe.setFromMatrixPosition(b.matrixWorld).applyMatrix4(ve);let ct=et.update(b),_t=b.material;_t.visible&&A.push(b,ct,_t,G,Fe.z,null,L)}}else if(b.isMesh||b.isLine||b.isPoints){let vt=L.isArrayCamera?Ve:Zt;if(!b.frustumCulled||b.intersectsFrustum(vt)){let ct=et.update(b),_t=b.material;if(U&&(b.boundingSphere!==void 0?(b.boundingSphere===null&&b.computeBoundingSphere(),Fe.copy(b.boundingSphere.center)):(ct.boundingSphere===null&&ct.computeBoundingSphere(),Fe.copy(ct.boundingSphere.center)),Fe.applyMatrix4(b.matrixWorld).applyMatrix4(ve)),Array.isArray(_t)){let Tt=ct.groups;for(let Vt=0,Kt=Tt.length;Vt<Kt;Vt++){let Mt=Tt[Vt],Qt=_t[Mt.materialIndex];Qt&&Qt.visible&&A.push(b,ct,Qt,G,Fe.z,Mt,L)}}else _t.visible&&A.push(b,ct,_t,G,Fe.z,null,L)}}}let ut=b.children;for(let vt=0,ct=ut.length;vt<ct;vt++)ih(ut[vt],L,G,U)}function Kd(b,L,G,U){let{opaque:z,transmissive:ut,transparent:vt}=b;E.setupLightsView(G),Ie===!0&&Y.setGlobalState(N.clippingPlanes,G),U&&ft.viewport(tt.copy(U)),z.length>0&&Wo(z,L,G),ut.length>0&&Wo(ut,L,G),vt.length>0&&Wo(vt,L,G),ft.buffers.depth.setTest(!0),ft.buffers.depth.setMask(!0),ft.buffers.color.setMask(!0),ft.setPolygonOffset(!1)}function Qd(b,L,G,U){if((G.isScene===!0?G.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[U.id]===void 0){let Mt=ge.has("EXT_color_buffer_half_float")||ge.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[U.id]=new bn(1,1,{generateMipmaps:!0,type:Mt?Yn:dn,minFilter:Ai,samples:Math.max(4,xe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:te.workingColorSpace})}let ut=E.state.transmissionRenderTarget[U.id],vt=U.viewport||tt;ut.setSize(vt.z*N.transmissionResolutionScale,vt.w*N.transmissionResolutionScale);let ct=N.getRenderTarget(),_t=N.getActiveCubeFace(),Tt=N.getActiveMipmapLevel();N.setRenderTarget(ut),N.getClearColor(J),gt=N.getClearAlpha(),gt<1&&N.setClearColor(16777215,.5),N.clear(),Tn&&R.render(G);let Vt=N.toneMapping;N.toneMapping=oi;let Kt=U.viewport;if(U.viewport!==void 0&&(U.viewport=void 0),E.setupLightsView(U),Ie===!0&&Y.setGlobalState(N.clippingPlanes,U),Wo(b,G,U),zt.updateMultisampleRenderTarget(ut),zt.updateRenderTargetMipmap(ut),ge.has("WEBGL_multisampled_render_to_texture")===!1){let Mt=!1;for(let Qt=0,Ee=L.length;Qt<Ee;Qt++){let fe=L[Qt],{object:de,geometry:Xe,material:wt,group:Ke}=fe;if(wt.side===rn&&de.layers.test(U.layers)){let ie=wt.side;wt.side=sn,wt.needsUpdate=!0,tf(de,G,U,Xe,wt,Ke),wt.side=ie,wt.needsUpdate=!0,Mt=!0}}Mt===!0&&(zt.updateMultisampleRenderTarget(ut),zt.updateRenderTargetMipmap(ut))}N.setRenderTarget(ct,_t,Tt),N.setClearColor(J,gt),Kt!==void 0&&(U.viewport=Kt),N.toneMapping=Vt}function Wo(b,L,G){let U=L.isScene===!0?L.overrideMaterial:null;for(let z=0,ut=b.length;z<ut;z++){let vt=b[z],{object:ct,geometry:_t,group:Tt}=vt,Vt=vt.material;Vt.allowOverride===!0&&U!==null&&(Vt=U),ct.layers.test(G.layers)&&tf(ct,L,G,_t,Vt,Tt)}}function tf(b,L,G,U,z,ut){B!==null&&z.isNodeMaterial&&B.setObject(b,z),b.onBeforeRender(N,L,G,U,z,ut),b.modelViewMatrix.multiplyMatrices(G.matrixWorldInverse,b.matrixWorld),b.normalMatrix.getNormalMatrix(b.modelViewMatrix),z.onBeforeRender(N,L,G,U,b,ut),z.transparent===!0&&z.side===rn&&z.forceSinglePass===!1?(z.side=sn,z.needsUpdate=!0,N.renderBufferDirect(G,L,U,z,b,ut),z.side=Ki,z.needsUpdate=!0,N.renderBufferDirect(G,L,U,z,b,ut),z.side=rn):N.renderBufferDirect(G,L,U,z,b,ut),b.onAfterRender(N,L,G,U,z,ut)}function ef(b){let L=0;for(let G of b)G.texture!==null&&L++;return L}function Mr(b,L,G){L.isScene!==!0&&(L=Sn);let U=Nt.get(b),z=E.state.lights,ut=E.state.shadowsArray,vt=z.state.version,ct=K.getParameters(b,z.state,ut,L,G,E.state.lightProbeGridArray),_t=K.getProgramCacheKey(ct),Tt=U.programs;U.environment=b.isMeshStandardMaterial||b.isMeshLambertMaterial||b.isMeshPhongMaterial?L.environment:null,U.fog=L.fog;let Vt=b.isMeshStandardMaterial||b.isMeshLambertMaterial&&!b.envMap||b.isMeshPhongMaterial&&!b.envMap;U.envMap=T.get(b.envMap||U.environment,Vt),U.envMapRotation=U.environment!==null&&b.envMap===null?L.environmentRotation:b.envMapRotation,Tt===void 0&&(b.addEventListener("dispose",ce),Tt=new Map,U.programs=Tt,U.programVariants=new Map);let Kt=Tt.get(_t);if(Kt!==void 0){if(U.currentProgram===Kt&&U.lightsStateVersion===vt)return sf(b,ct),Kt}else ct.uniforms=K.getUniforms(b),B!==null&&b.isNodeMaterial&&B.build(b,G,ct),b.onBeforeCompile(ct,N),Kt=K.acquireProgram(ct,_t),Tt.set(_t,Kt),U.uniforms=ct.uniforms;let Mt=U.uniforms;return(!b.isShaderMaterial&&!b.isRawShaderMaterial||b.clipping===!0)&&(Mt.clippingPlanes=Y.uniform),sf(b,ct),U.needsLights=Ux(b),U.lightsStateVersion=vt,U.needsLights&&(Mt.ambientLightColor.value=z.state.ambient,Mt.lightProbe.value=z.state.probe,Mt.sunLights.value=z.state.sun,Mt.sunLightShadows.value=z.state.sunShadow,Mt.directionalLights.value=z.state.directional,Mt.directionalLightShadows.value=z.state.directionalShadow,Mt.spotLights.value=z.state.spot,Mt.spotLightShadows.value=z.state.spotShadow,Mt.rectAreaLights.value=z.state.rectArea,Mt.ltc_1.value=z.state.rectAreaLTC1,Mt.ltc_2.value=z.state.rectAreaLTC2,Mt.pointLights.value=z.state.point,Mt.pointLightShadows.value=z.state.pointShadow,Mt.hemisphereLights.value=z.state.hemi,Mt.sunShadowMatrix.value=z.state.sunShadowMatrix,Mt.sunShadowCascade.value=z.state.sunShadowCascade,Mt.directionalShadowMatrix.value=z.state.directionalShadowMatrix,Mt.spotLightMatrix.value=z.state.spotLightMatrix,Mt.spotLightMap.value=z.state.spotLightMap,Mt.pointShadowMatrix.value=z.state.pointShadowMatrix),U.numLightProbeGrids=ef(E.state.lightProbeGridArray),U.currentProgram=Kt,U.uniformsList=null,Kt}function Dx(b,L,G,U,z){let ut=Nt.get(b),vt=ut.currentProgram.id+","+U+","+z,ct=ut.programVariants.get(vt);return ct===void 0?(ct=Mr(b,L,G),ut.programVariants.set(vt,ct)):(ut.currentProgram=ct,ut.uniformsList=null,ut.outputColorSpace=U,ut.toneMapping=z),ct}function nf(b){if(b.uniformsList===null){let L=b.currentProgram.getUniforms();b.uniformsList=hr.seqWithValue(L.seq,b.uniforms)}return b.uniformsList}function sf(b,L){let G=Nt.get(b);G.outputColorSpace=L.outputColorSpace,G.batching=L.batching,G.batchingColor=L.batchingColor,G.instancing=L.instancing,G.instancingColor=L.instancingColor,G.instancingMorph=L.instancingMorph,G.skinning=L.skinning,G.morphTargets=L.morphTargets,G.morphNormals=L.morphNormals,G.morphColors=L.morphColors,G.morphTargetsCount=L.morphTargetsCount,G.numClippingPlanes=L.numClippingPlanes,G.numIntersection=L.numClipIntersection,G.vertexAlphas=L.vertexAlphas,G.vertexTangents=L.vertexTangents,G.toneMapping=L.toneMapping}function Ox(b,L,G,U,z){L.isScene!==!0&&(L=Sn),zt.resetTextureUnits();let ut=L.fog,vt=U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial?L.environment:null,ct=nt===null?N.outputColorSpace:nt.isXRRenderTarget===!0?nt.texture.colorSpace:te.workingColorSpace,_t=U.isMeshStandardMaterial||U.isMeshLambertMaterial&&!U.envMap||U.isMeshPhongMaterial&&!U.envMap,Tt=T.get(U.envMap||vt,_t),Vt=U.vertexColors===!0&&!!G.attributes.color&&G.attributes.color.itemSize===4,Kt=!!G.attributes.tangent&&(!!U.normalMap||U.anisotropy>0),Mt=!!G.morphAttributes.position,Qt=!!G.morphAttributes.normal,Ee=!!G.morphAttributes.color,fe=oi;U.toneMapped&&(nt===null||nt.isXRRenderTarget===!0)&&(fe=N.toneMapping);let de=G.morphAttributes.position||G.morphAttributes.normal||G.morphAttributes.color,Xe=de!==void 0?de.length:0,wt=Nt.get(U),Ke=E.state.lights;if(Ie===!0&&(on===!0||b!==Q)){let be=b===Q&&U.id===X;Y.setState(U,b,be)}let ie=!1,rs=!1;U.version===wt.__version?wt.needsLights&&wt.lightsStateVersion!==Ke.state.version||z.isBatchedMesh&&wt.batching===!1||!z.isBatchedMesh&&wt.batching===!0||z.isBatchedMesh&&wt.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&wt.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&wt.instancing===!1||!z.isInstancedMesh&&wt.instancing===!0||z.isSkinnedMesh&&wt.skinning===!1||!z.isSkinnedMesh&&wt.skinning===!0||z.isInstancedMesh&&wt.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&wt.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&wt.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&wt.instancingMorph===!1&&z.morphTexture!==null||wt.envMap!==Tt||U.fog===!0&&wt.fog!==ut||wt.numClippingPlanes!==void 0&&(wt.numClippingPlanes!==Y.numPlanes||wt.numIntersection!==Y.numIntersection)||wt.vertexAlphas!==Vt||wt.vertexTangents!==Kt||wt.morphTargets!==Mt||wt.morphNormals!==Qt||wt.morphColors!==Ee||wt.morphTargetsCount!==Xe||wt.numLightProbeGrids!==ef(E.state.lightProbeGridArray)?ie=!0:(wt.outputColorSpace!==ct||wt.toneMapping!==fe)&&(rs=!0):(ie=!0,wt.__version=U.version);let qe=wt.currentProgram;(ie===!0||rs===!0)&&(qe=rs===!0?Dx(U,L,z,ct,fe):Mr(U,L,z),B&&U.isNodeMaterial&&B.onUpdateProgram(U,qe,wt));let $o=!1,Ni=!1,os=!1,ee=qe.getUniforms(),He=wt.uniforms;if(ft.useProgram(qe.program)&&($o=!0,Ni=!0,os=!0),U.id!==X&&(X=U.id,Ni=!0),$o||Q!==b){ft.buffers.depth.getReversed()&&b.reversedDepth!==!0&&(b._reversedDepth=!0,b.updateProjectionMatrix()),ee.setValue(D,"projectionMatrix",b.projectionMatrix),ee.setValue(D,"viewMatrix",b.matrixWorldInverse);let ke=ee.map.cameraPosition;ke!==void 0&&ke.setValue(D,Kn.setFromMatrixPosition(b.matrixWorld)),xe.logarithmicDepthBuffer&&ee.setValue(D,"logDepthBufFC",2/(Math.log(b.far+1)/Math.LN2)),(U.isMeshPhongMaterial||U.isMeshToonMaterial||U.isMeshLambertMaterial||U.isMeshBasicMaterial||U.isMeshStandardMaterial||U.isShaderMaterial)&&ee.setValue(D,"isOrthographic",b.isOrthographicCamera===!0),Q!==b&&(Q=b,Ni=!0,os=!0)}if(wt.needsLights&&(Ke.state.sunShadowMap.length>0&&ee.setValue(D,"sunShadowMap",Ke.state.sunShadowMap,zt),Ke.state.directionalShadowMap.length>0&&ee.setValue(D,"directionalShadowMap",Ke.state.directionalShadowMap,zt),Ke.state.spotShadowMap.length>0&&ee.setValue(D,"spotShadowMap",Ke.state.spotShadowMap,zt),Ke.state.pointShadowMap.length>0&&ee.setValue(D,"pointShadowMap",Ke.state.pointShadowMap,zt)),z.isSkinnedMesh){ee.setOptional(D,z,"bindMatrix"),ee.setOptional(D,z,"bindMatrixInverse");let be=z.skeleton;be&&(be.boneTexture===null&&be.computeBoneTexture(),ee.setValue(D,"boneTexture",be.boneTexture,zt))}z.isBatchedMesh&&(ee.setOptional(D,z,"batchingTexture"),ee.setValue(D,"batchingTexture",z._matricesTexture,zt),ee.setOptional(D,z,"batchingIdTexture"),ee.setValue(D,"batchingIdTexture",z._indirectTexture,zt),ee.setOptional(D,z,"batchingColorTexture"),z._colorsTexture!==null&&ee.setValue(D,"batchingColorTexture",z._colorsTexture,zt));let zn=G.morphAttributes;if((zn.position!==void 0||zn.normal!==void 0||zn.color!==void 0)&&Z.update(z,G,qe),(Ni||wt.receiveShadow!==z.receiveShadow)&&(wt.receiveShadow=z.receiveShadow,ee.setValue(D,"receiveShadow",z.receiveShadow)),(U.isMeshStandardMaterial||U.isMeshLambertMaterial||U.isMeshPhongMaterial)&&U.envMap===null&&L.environment!==null&&(He.envMapIntensity.value=L.environmentIntensity),He.dfgLUT!==void 0&&(He.dfgLUT.value=AS()),Ni){if(ee.setValue(D,"toneMappingExposure",N.toneMappingExposure),wt.needsLights&&Fx(He,os),ut&&U.fog===!0&&rt.refreshFogUniforms(He,ut),rt.refreshMaterialUniforms(He,U,xt,Lt,E.state.transmissionRenderTarget[b.id]),wt.needsLights&&wt.numLightProbeGrids>0){let be=w,ke=0;for(let ui of E.state.lightProbeGridArray)ui.texture!==null&&(be.textures[ke]=ui.texture,be.min[ke]=ui.boundingBox.min,be.max[ke]=ui.boundingBox.max,be.resolution[ke]=ui.resolution,ke++);for(let ui in be)be[ui].length=ke;He.probesSH.value=be.textures,He.probesMin.value=be.min,He.probesMax.value=be.max,He.probesResolution.value=be.resolution}hr.upload(D,nf(wt),He,zt)}if(U.isShaderMaterial&&U.uniformsNeedUpdate===!0&&(hr.upload(D,nf(wt),He,zt),U.uniformsNeedUpdate=!1),U.isSpriteMaterial&&ee.setValue(D,"center",z.center),ee.setValue(D,"modelViewMatrix",z.modelViewMatrix),ee.setValue(D,"normalMatrix",z.normalMatrix),ee.setValue(D,"modelMatrix",z.matrixWorld),U.uniformsGroups!==void 0){let be=U.uniformsGroups;for(let ke=0,ui=be.length;ke<ui;ke++){let of=be[ke];Et.update(of,qe),Et.bind(of,qe)}}return qe}function Fx(b,L){b.ambientLightColor.needsUpdate=L,b.lightProbe.needsUpdate=L,b.sunLights.needsUpdate=L,b.sunLightShadows.needsUpdate=L,b.directionalLights.needsUpdate=L,b.directionalLightShadows.needsUpdate=L,b.pointLights.needsUpdate=L,b.pointLightShadows.needsUpdate=L,b.spotLights.needsUpdate=L,b.spotLightShadows.needsUpdate=L,b.rectAreaLights.needsUpdate=L,b.hemisphereLights.needsUpdate=L}function Ux(b){return b.isMeshLambertMaterial||b.isMeshToonMaterial||b.isMeshPhongMaterial||b.isMeshStandardMaterial||b.isShadowMaterial||b.isShaderMaterial&&b.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return V},this.getRenderTarget=function(){return nt},this.setRenderTargetTextures=function(b,L,G){let U=Nt.get(b);U.__autoAllocateDepthBuffer=b.resolveDepthBuffer===!1,U.__autoAllocateDepthBuffer===!1&&(U.__useRenderToTexture=!1),Nt.get(b.texture).__webglTexture=L,Nt.get(b.depthTexture).__webglTexture=U.__autoAllocateDepthBuffer?void 0:G,U.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(b,L){let G=Nt.get(b);G.__webglFramebuffer=L,G.__useDefaultFramebuffer=L===void 0},this.setRenderTarget=function(b,L=0,G=0){nt=b,q=L,V=G;let U=null,z=!1,ut=!1;if(b){let ct=Nt.get(b);if(ct.__useDefaultFramebuffer!==void 0){ft.bindFramebuffer(D.FRAMEBUFFER,ct.__webglFramebuffer),tt.copy(b.viewport),St.copy(b.scissor),Gt=b.scissorTest,ft.viewport(tt),ft.scissor(St),ft.setScissorTest(Gt),X=-1;return}else if(ct.__webglFramebuffer===void 0)zt.setupRenderTarget(b);else if(ct.__hasExternalTextures)zt.rebindTextures(b,Nt.get(b.texture).__webglTexture,Nt.get(b.depthTexture).__webglTexture);else if(b.depthBuffer){let Vt=b.depthTexture;if(ct.__boundDepthTexture!==Vt){if(Vt!==null&&Nt.has(Vt)&&(b.width!==Vt.image.width||b.height!==Vt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");zt.setupDepthRenderbuffer(b)}}let _t=b.texture;(_t.isData3DTexture||_t.isDataArrayTexture||_t.isCompressedArrayTexture)&&(ut=!0);let Tt=Nt.get(b).__webglFramebuffer;b.isWebGLCubeRenderTarget?(Array.isArray(Tt[L])?U=Tt[L][G]:U=Tt[L],z=!0):b.samples>0&&zt.useMultisampledRTT(b)===!1?U=Nt.get(b).__webglMultisampledFramebuffer:Array.isArray(Tt)?U=Tt[G]:U=Tt,tt.copy(b.viewport),St.copy(b.scissor),Gt=b.scissorTest}else tt.copy(Dt).multiplyScalar(xt).floor(),St.copy(le).multiplyScalar(xt).floor(),Gt=ue;if(G!==0&&(U=W),ft.bindFramebuffer(D.FRAMEBUFFER,U)&&ft.drawBuffers(b,U),ft.viewport(tt),ft.scissor(St),ft.setScissorTest(Gt),z){let ct=Nt.get(b.texture);D.framebufferTexture2D(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_CUBE_MAP_POSITIVE_X+L,ct.__webglTexture,G)}else if(ut){let ct=L;for(let _t=0;_t<b.textures.length;_t++){let Tt=Nt.get(b.textures[_t]);D.framebufferTextureLayer(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0+_t,Tt.__webglTexture,G,ct)}}else if(b!==null&&G!==0){let ct=Nt.get(b.texture);D.framebufferTexture2D(D.FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,ct.__webglTexture,G)}X=-1};function rf(b){let L=Nt.get(b);return(L.__readFormat!==b.format||L.__readType!==b.type)&&(L.__readFormat=b.format,L.__readType=b.type,L.__formatReadable=xe.textureFormatReadable(b.format),L.__typeReadable=xe.textureTypeReadable(b.type)),L}this.readRenderTargetPixels=function(b,L,G,U,z,ut,vt,ct=0){if(!(b&&b.isWebGLRenderTarget)){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let _t=Nt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&vt!==void 0&&(_t=_t[vt],Array.isArray(_t)&&(_t=_t[0])),_t){ft.bindFramebuffer(D.FRAMEBUFFER,_t);try{let Tt=b.textures[ct],Vt=Tt.format,Kt=Tt.type;b.textures.length>1&&D.readBuffer(D.COLOR_ATTACHMENT0+ct);let Mt=rf(Tt);if(Mt.__formatReadable===!1){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Mt.__typeReadable===!1){Ft("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}L>=0&&L<=b.width-U&&G>=0&&G<=b.height-z&&D.readPixels(L,G,U,z,st.convert(Vt),st.convert(Kt),ut)}finally{let Tt=nt!==null?Nt.get(nt).__webglFramebuffer:null;ft.bindFramebuffer(D.FRAMEBUFFER,Tt)}}},this.readRenderTargetPixelsAsync=async function(b,L,G,U,z,ut,vt,ct=0){if(!(b&&b.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let _t=Nt.get(b).__webglFramebuffer;if(b.isWebGLCubeRenderTarget&&vt!==void 0&&(_t=_t[vt],Array.isArray(_t)&&(_t=_t[0])),_t)if(L>=0&&L<=b.width-U&&G>=0&&G<=b.height-z){ft.bindFramebuffer(D.FRAMEBUFFER,_t);let Tt=b.textures[ct],Vt=Tt.format,Kt=Tt.type;b.textures.length>1&&D.readBuffer(D.COLOR_ATTACHMENT0+ct);let Mt=rf(Tt);if(Mt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Mt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Qt=D.createBuffer();D.bindBuffer(D.PIXEL_PACK_BUFFER,Qt),D.bufferData(D.PIXEL_PACK_BUFFER,ut.byteLength,D.STREAM_READ),D.readPixels(L,G,U,z,st.convert(Vt),st.convert(Kt),0),D.bindBuffer(D.PIXEL_PACK_BUFFER,null);let Ee=nt!==null?Nt.get(nt).__webglFramebuffer:null;ft.bindFramebuffer(D.FRAMEBUFFER,Ee);let fe=D.fenceSync(D.SYNC_GPU_COMMANDS_COMPLETE,0);return D.flush(),await wm(D,fe,4),D.bindBuffer(D.PIXEL_PACK_BUFFER,Qt),D.getBufferSubData(D.PIXEL_PACK_BUFFER,0,ut),D.bindBuffer(D.PIXEL_PACK_BUFFER,null),D.deleteBuffer(Qt),D.deleteSync(fe),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(b,L=null,G=0){let U=Math.pow(2,-G),z=Math.floor(b.image.width*U),ut=Math.floor(b.image.height*U),vt=L!==null?L.x:0,ct=L!==null?L.y:0;zt.setTexture2D(b,0),D.copyTexSubImage2D(D.TEXTURE_2D,G,0,0,vt,ct,z,ut),ft.unbindTexture()},this.copyTextureToTexture=function(b,L,G=null,U=null,z=0,ut=0){let vt,ct,_t,Tt,Vt,Kt,Mt,Qt,Ee,fe=b.isCompressedTexture?b.mipmaps[ut]:b.image;if(G!==null)vt=G.max.x-G.min.x,ct=G.max.y-G.min.y,_t=G.isBox3?G.max.z-G.min.z:1,Tt=G.min.x,Vt=G.min.y,Kt=G.isBox3?G.min.z:0;else{let ee=Math.pow(2,-z);vt=Math.floor(fe.width*ee),ct=Math.floor(fe.height*ee),b.isDataArrayTexture?_t=fe.depth:b.isData3DTexture?_t=Math.floor(fe.depth*ee):_t=1,Tt=0,Vt=0,Kt=0}U!==null?(Mt=U.x,Qt=U.y,Ee=U.z):(Mt=0,Qt=0,Ee=0);let de=st.convert(L.format),Xe=st.convert(L.type),wt;L.isData3DTexture?(zt.setTexture3D(L,0),wt=D.TEXTURE_3D):L.isDataArrayTexture||L.isCompressedArrayTexture?(zt.setTexture2DArray(L,0),wt=D.TEXTURE_2D_ARRAY):(zt.setTexture2D(L,0),wt=D.TEXTURE_2D),ft.activeTexture(D.TEXTURE0),ft.pixelStorei(D.UNPACK_FLIP_Y_WEBGL,L.flipY),ft.pixelStorei(D.UNPACK_PREMULTIPLY_ALPHA_WEBGL,L.premultiplyAlpha),ft.pixelStorei(D.UNPACK_ALIGNMENT,L.unpackAlignment);let Ke=ft.getParameter(D.UNPACK_ROW_LENGTH),ie=ft.getParameter(D.UNPACK_IMAGE_HEIGHT),rs=ft.getParameter(D.UNPACK_SKIP_PIXELS),qe=ft.getParameter(D.UNPACK_SKIP_ROWS),$o=ft.getParameter(D.UNPACK_SKIP_IMAGES);ft.pixelStorei(D.UNPACK_ROW_LENGTH,fe.width),ft.pixelStorei(D.UNPACK_IMAGE_HEIGHT,fe.height),ft.pixelStorei(D.UNPACK_SKIP_PIXELS,Tt),ft.pixelStorei(D.UNPACK_SKIP_ROWS,Vt),ft.pixelStorei(D.UNPACK_SKIP_IMAGES,Kt);let Ni=b.isDataArrayTexture||b.isData3DTexture,os=L.isDataArrayTexture||L.isData3DTexture;if(b.isDepthTexture){let ee=Nt.get(b),He=Nt.get(L),zn=Nt.get(ee.__renderTarget),be=Nt.get(He.__renderTarget);ft.bindFramebuffer(D.READ_FRAMEBUFFER,zn.__webglFramebuffer),ft.bindFramebuffer(D.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let ke=0;ke<_t;ke++)Ni&&(D.framebufferTextureLayer(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,Nt.get(b).__webglTexture,z,Kt+ke),D.framebufferTextureLayer(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,Nt.get(L).__webglTexture,ut,Ee+ke)),D.blitFramebuffer(Tt,Vt,Tt+vt,Vt+ct,Mt,Qt,Mt+vt,Qt+ct,D.DEPTH_BUFFER_BIT,D.NEAREST);ft.bindFramebuffer(D.READ_FRAMEBUFFER,null),ft.bindFramebuffer(D.DRAW_FRAMEBUFFER,null)}else if(z!==0||b.isRenderTargetTexture||Nt.has(b)){let ee=Nt.get(b),He=Nt.get(L);ft.bindFramebuffer(D.READ_FRAMEBUFFER,P),ft.bindFramebuffer(D.DRAW_FRAMEBUFFER,H);for(let zn=0;zn<_t;zn++)Ni?D.framebufferTextureLayer(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,ee.__webglTexture,z,Kt+zn):D.framebufferTexture2D(D.READ_FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,ee.__webglTexture,z),os?D.framebufferTextureLayer(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,He.__webglTexture,ut,Ee+zn):D.framebufferTexture2D(D.DRAW_FRAMEBUFFER,D.COLOR_ATTACHMENT0,D.TEXTURE_2D,He.__webglTexture,ut),z!==0?D.blitFramebuffer(Tt,Vt,Tt+vt,Vt+ct,Mt,Qt,Mt+vt,Qt+ct,D.COLOR_BUFFER_BIT,D.NEAREST):os?D.copyTexSubImage3D(wt,ut,Mt,Qt,Ee+zn,Tt,Vt,vt,ct):D.copyTexSubImage2D(wt,ut,Mt,Qt,Tt,Vt,vt,ct);ft.bindFramebuffer(D.READ_FRAMEBUFFER,null),ft.bindFramebuffer(D.DRAW_FRAMEBUFFER,null)}else os?b.isDataTexture||b.isData3DTexture?D.texSubImage3D(wt,ut,Mt,Qt,Ee,vt,ct,_t,de,Xe,fe.data):L.isCompressedArrayTexture?D.compressedTexSubImage3D(wt,ut,Mt,Qt,Ee,vt,ct,_t,de,fe.data):D.texSubImage3D(wt,ut,Mt,Qt,Ee,vt,ct,_t,de,Xe,fe):b.isDataTexture?D.texSubImage2D(D.TEXTURE_2D,ut,Mt,Qt,vt,ct,de,Xe,fe.data):b.isCompressedTexture?D.compressedTexSubImage2D(D.TEXTURE_2D,ut,Mt,Qt,fe.width,fe.height,de,fe.data):D.texSubImage2D(D.TEXTURE_2D,ut,Mt,Qt,vt,ct,de,Xe,fe);ft.pixelStorei(D.UNPACK_ROW_LENGTH,Ke),ft.pixelStorei(D.UNPACK_IMAGE_HEIGHT,ie),ft.pixelStorei(D.UNPACK_SKIP_PIXELS,rs),ft.pixelStorei(D.UNPACK_SKIP_ROWS,qe),ft.pixelStorei(D.UNPACK_SKIP_IMAGES,$o),ut===0&&L.generateMipmaps===!0&&L.mipmapsAutoUpdate===!0&&D.generateMipmap(wt),ft.unbindTexture()},this.initRenderTarget=function(b){Nt.get(b).__webglFramebuffer===void 0&&zt.setupRenderTarget(b)},this.initTexture=function(b){b.isCubeTexture?zt.setTextureCube(b,0):b.isData3DTexture?zt.setTexture3D(b,0):b.isDataArrayTexture||b.isCompressedArrayTexture?zt.setTexture2DArray(b,0):zt.setTexture2D(b,0),ft.unbindTexture()},this.resetState=function(){q=0,V=0,nt=null,ft.reset(),ot.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Pn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=te._getDrawingBufferColorSpace(t),e.unpackColorSpace=te._getUnpackColorSpace()}};var cg={type:"change"},nd={type:"start"},ug={type:"end"},_c=new Wi,hg=new Qe,RS=Math.cos(70*Bu.DEG2RAD),Oe=new I,fn=2*Math.PI,re={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},ed=1e-6,yc=class extends mo{constructor(t,e=null){super(t,e),this.state=re.NONE,this.target=new I,this.cursor=new I,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Ji.ROTATE,MIDDLE:Ji.DOLLY,RIGHT:Ji.PAN},this.touches={ONE:Zi.ROTATE,TWO:Zi.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new I,this._lastQuaternion=new nn,this._lastTargetPosition=new I,this._quat=new nn().setFromUnitVectors(t.up,new I(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new sr,this._sphericalDelta=new sr,this._scale=1,this._panOffset=new I,this._rotateStart=new yt,this._rotateEnd=new yt,this._rotateDelta=new yt,this._panStart=new yt,this._panEnd=new yt,this._panDelta=new yt,this._dollyStart=new yt,this._dollyEnd=new yt,this._dollyDelta=new yt,this._dollyDirection=new I,this._mouse=new yt,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=PS.bind(this),this._onPointerDown=CS.bind(this),this._onPointerUp=IS.bind(this),this._onContextMenu=kS.bind(this),this._onMouseWheel=DS.bind(this),this._onKeyDown=OS.bind(this),this._onTouchStart=FS.bind(this),this._onTouchMove=US.bind(this),this._onMouseDown=LS.bind(this),this._onMouseMove=NS.bind(this),this._interceptControlDown=BS.bind(this),this._interceptControlUp=zS.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=re.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(cg),this.update(),this.state=re.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Oe.copy(e).sub(this.target),Oe.applyQuaternion(this._quat),this._spherical.setFromVector3(Oe),this.autoRotate&&this.state===re.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=fn:i>Math.PI&&(i-=fn),s<-Math.PI?s+=fn:s>Math.PI&&(s-=fn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Oe.setFromSpherical(this._spherical),Oe.applyQuaternion(this._quatInverse),e.copy(this.target).add(Oe),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Oe.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new I(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new I(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Oe.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(_c.origin.copy(this.object.position),_c.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(_c.direction))<RS?this.object.lookAt(this.target):(hg.setFromNormalAndCoplanarPoint(this.object.up,this.target),_c.intersectPlane(hg,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>ed||8*(1-this._lastQuaternion.dot(this.object.quaternion))>ed||this._lastTargetPosition.distanceToSquared(this.target)>ed?(this.dispatchEvent(cg),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?fn/60*this.autoRotateSpeed*t:fn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Oe.setFromMatrixColumn(e,0),Oe.multiplyScalar(-t),this._panOffset.add(Oe)}_panUp(t,e){this.screenSpacePanning===!0?Oe.setFromMatrixColumn(e,1):(Oe.setFromMatrixColumn(e,0),Oe.crossVectors(this.object.up,Oe)),Oe.multiplyScalar(t),this._panOffset.add(Oe)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Oe.copy(s).sub(this.target);let r=Oe.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(fn*this._rotateDelta.x/e.clientHeight),this._rotateUp(fn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(fn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-fn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(fn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-fn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(fn*this._rotateDelta.x/e.clientHeight),this._rotateUp(fn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new yt,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function CS(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function PS(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function IS(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(ug),this.state=re.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function LS(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Ji.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=re.DOLLY;break;case Ji.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}break;case Ji.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=re.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=re.PAN}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(nd)}function NS(n){switch(this.state){case re.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case re.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case re.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function DS(n){this.enabled===!1||this.enableZoom===!1||this.state!==re.NONE||(n.preventDefault(),this.dispatchEvent(nd),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(ug))}function OS(n){this.enabled!==!1&&this._handleKeyDown(n)}function FS(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Zi.ROTATE:if(this.enableRotate===!1){this.state=re.NONE;break}this._handleTouchStartRotate(n),this.state=re.TOUCH_ROTATE;break;case Zi.PAN:if(this.enablePan===!1){this.state=re.NONE;break}this._handleTouchStartPan(n),this.state=re.TOUCH_PAN;break;default:this.state=re.NONE}break;case 2:switch(this.touches.TWO){case Zi.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=re.TOUCH_DOLLY_PAN;break;case Zi.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=re.TOUCH_DOLLY_ROTATE;break;default:this.state=re.NONE}break;default:this.state=re.NONE}this.state!==re.NONE&&this.dispatchEvent(nd)}function US(n){switch(this._trackPointer(n),this.state){case re.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case re.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case re.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case re.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=re.NONE}}function kS(n){this.enabled!==!1&&n.preventDefault()}function BS(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function zS(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var GS=new I(0,1,0),dg=new fs(1,1,1,28,1,!0),Co=new fs(1,1,1,36),Mc=new so(1,28,18),fg=new Xi(1,1,1),id=new eo(1,1,24),pg=new ps(1,1),VS=[["x",0],["x",Math.PI/2],["y",Math.PI/2]],mg=new hn().setFromPoints(Array.from({length:64},(n,t)=>new I(Math.cos(t*Math.PI/32),Math.sin(t*Math.PI/32),0))),HS=new Set([dg,Co,Mc,fg,id,pg,mg]),gg=n=>HS.has(n),wc=n=>new Pe(Mc,n),sd=n=>new Pe(Co,n);function Po(n,t){let e=new Pe(pg,t);return e.scale.setScalar(n),e}var ts=n=>new I().fromArray(n),WS=[0,0,0],$S=new kt(1,1,1),Ao=class extends Jr{constructor(t,e,i){super(t,e,i),this.frustumCulled=!1,this.instanceMatrix.setUsage(Nu);for(let s=0;s<i;s++)this.hide(s)}put(t,e,i,s,r){[e,i,s,r].forEach((o,a)=>this.instanceMatrix.array.set(o,16*t+4*a)),this.instanceMatrix.array[16*t+15]=1,this.instanceMatrix.needsUpdate=!0}between(t,e,i,s,r=null){let o=Rt(i,e),a=Xt(o);if(!(a>1e-6))return this.hide(t),!1;let c=r??XS(o,a),h=s/Xt(c);return this.put(t,Ut(h,c),o,Ut(h/a,Me(c,o)),Yt(e,Ut(.5,o))),!0}ball(t,e,i){this.put(t,[i,0,0],[0,i,0],[0,0,i],e)}hide(t){this.ball(t,WS,0)}colour(t){for(let e=0;e<this.count;e++)this.setColorAt(e,t(e));this.instanceColor.needsUpdate=!0}};function XS(n,t){return Me(n,Math.abs(n[2])<.7*t?[0,0,1]:[1,0,0])}function Ro(n,t,e,i){let s=ts(Rt(e,t)),r=s.length();n.visible=r>1e-6,n.visible&&(n.position.copy(ts(t)).addScaledVector(s,.5),n.quaternion.copy(new nn().setFromUnitVectors(GS,s.divideScalar(r))),n.scale.set(i,r,i))}var dr=class extends Ce{constructor(t,{link:e,joint:i,ghost:s=!1,hue:r=null}){super(),this.arm=t,this.size=Rs(t),this.ghost=s,this.hue=r;let o=t.rows.length,a=(l,c,h)=>{let u=new Ao(l,c,h);return u.castShadow=u.receiveShadow=!s,this.add(u),u};if(this.rods=a(dg,e,2*o),this.balls=a(Mc,e,2*o),this.barrels=a(Co,i,o+1),this.boxes=t.rows.some(l=>l.kind==="prismatic")?a(fg,i,o):null,s||this.barrels.between(o,[0,0,-.004*this.size],[0,0,.012*this.size],.05*this.size),!!r){for(let l of[this.rods,this.balls])l.colour(()=>$S);this.tint(()=>null)}}tint(t){let e=i=>t(i)??this.hue;this.barrels.colour(e),this.boxes?.colour(e)}pose(t,e=this.ghost?.97:1){this.girth=e*this.size,this.arm.rows.forEach((i,s)=>{let[r,o]=[t[s],t[s+1]],a=Rt(o.o,Ut(i.a,o.x)),l=this.radius(s),c=i.kind==="prismatic",h=this.rods.between(2*s,r.o,a,c?.6*l:l),u=this.rods.between(2*s+1,a,o.o,l),d=[a,o.o],p=[c?.6:1,s===this.arm.rows.length-1?.8:1];d.forEach((f,x)=>{h||u?this.balls.ball(2*s+x,f,p[x]*l):this.balls.hide(2*s+x)}),i.kind!=="fixed"&&this.joint(s,r,l,c)})}joint(t,{o:e,x:i,z:s},r,o){let a=Ut(o?2.2*r:1.45*r,s),[l,c]=[Rt(e,a),Yt(e,a)];o?this.boxes.between(t,l,c,2*r,i):this.barrels.between(t,l,c,1.28*r)}radius(t){let e=this.arm.rows.length;return this.girth*(t===e-1?.008:.021-.008*t/e)}},bs=class extends Ce{constructor(t){super(),this.shaft=new Pe(Co,t),this.head=new Pe(id,t),this.add(this.shaft,this.head)}point(t,e,i){let s=Xt(e);if(this.visible=s>1e-9,!this.visible)return;let r=Math.max(0,s-5*i);Ro(this.shaft,t,Yt(t,Ut(r/s,e)),i),Ro(this.head,Yt(t,Ut(r/s,e)),Yt(t,e),2.4*i)}},qS={x:"#D55E00",y:"#009E73",z:"#0072B2"},jS={x:"#F58A3C",y:"#3CC79B",z:"#5AB4EC"},vc=class extends Ce{constructor(t,e){super();let i=Object.values(t?jS:qS).map(s=>new kt(s));this.shafts=new Ao(Co,new un,3*e),this.heads=new Ao(id,new un,3*e);for(let s of[this.shafts,this.heads])s.colour(r=>i[r%3]);this.add(this.shafts,this.heads)}pose(t,e,i){let s=.022*e;t.forEach((r,o)=>["x","y","z"].forEach((a,l)=>{let[c,h]=[e-5*s,e].map(u=>Yt(r.o,Ut(u,r[a])));for(let[u,d,p,f]of[[this.shafts,r.o,c,s],[this.heads,c,h,2.4*s]])i[o]?u.between(3*o+l,d,p,f):u.hide(3*o+l)}))}},bc=class extends Ce{constructor(t){super();let e=new ri({color:t,transparent:!0,opacity:.2,depthWrite:!1,side:rn});this.add(new Pe(Mc,e));for(let[i,s]of VS){let r=new Zr(mg,new er({color:t}));r.rotation[i]=s,this.add(r)}this.matrixAutoUpdate=!1}pose(t,{values:e,vectors:i},s,r){let o=i.map((h,u)=>ts(Ut(Math.max(s*e[u],r),h))),[a,l,c]=o;this.matrix.makeBasis(a,l,c).premultiply(new ne().makeTranslation(ts(t)))}};function fr(n,t,e){let s=n.filter((o,a)=>a===0||Xt(Rt(o,n[a-1]))>1e-7);if(s.length<2)return new Ce;let r=new nr(s.map(ts));return new Pe(new ro(r,Math.min(400,s.length*2),t,8),new un({color:e}))}function xg(n,t){let e=n.length,i=Ut(1/e,n.reduce(Yt)),[s,r]=[n[0],n[Math.floor(e/4)]].map(u=>ts(Rt(u,i))),o=s.clone().cross(r).normalize(),a=Math.max(...n.map(u=>Xt(Rt(u,i)))),l=n.every(u=>Math.abs(ts(Rt(u,i)).dot(o))<.02*a);if(!(a>1e-6&&o.length()>.5&&l))return null;let c=Po(3.4*a,t);c.position.copy(ts(i));let h=Math.abs(o.z)>.9?new I(0,1,0):new I(0,0,1);return c.quaternion.setFromRotationMatrix(new ne().lookAt(o,new I,h)),c}function _g(n,t,e){let i=n>1.2?.2:n>.4?.1:.05,s=new Ln({transparent:!0,depthWrite:!1,side:rn,uniforms:{colour:{value:new kt(t)},size:{value:n},step:{value:i},strength:{value:e}},vertexShader:`
      varying vec2 p; uniform float size;
      void main() {
        p = 2.0 * size * position.xy;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,fragmentShader:`
      varying vec2 p; uniform vec3 colour;
      uniform float size; uniform float step; uniform float strength;
      void main() {
        vec2 g = abs(fract(p / step - 0.5) - 0.5) / fwidth(p / step);
        float line = 1.0 - min(min(g.x, g.y), 1.0);
        gl_FragColor = vec4(colour, strength * line * smoothstep(1.0, 0.2, length(p) / size));
      }`});return Po(2*n,s)}function yg(n,t){return new ri({color:n,transparent:!0,opacity:t,depthWrite:!1,roughness:.7})}var ye=null,Io=null,Ms=new Set;function YS(){return ye||(ye=new mc({antialias:!0,alpha:!0,powerPreference:"low-power"}),ye.setPixelRatio(1),ye.setScissorTest(!0),ye.shadowMap.enabled=!0,ye.shadowMap.type=ms,ye.domElement.addEventListener("webglcontextlost",()=>Ms.forEach(n=>n.onLost(!0))),ye.domElement.addEventListener("webglcontextrestored",()=>{Ms.forEach(n=>{n.onLost(!1),n.request()})}),ye)}var Mg=()=>({...ye?.info.memory,calls:ye?.info.render.calls,programs:ye?.info.programs?.length,figures:Ms.size}),wg=()=>ye?.getContext().getExtension("WEBGL_lose_context"),Lo=new Set;function rd(n){Lo.add(n),Io??=requestAnimationFrame(ad)}var od=n=>Lo.delete(n);function ad(){let n=[...Lo];Lo.clear();try{if(n.forEach(t=>t()),!ye||ye.getContext().isContextLost())return;for(let t of Ms)t.dirty&&t.visible&&t.width&&t.draw(ye)}finally{Io=Lo.size?requestAnimationFrame(ad):null}}var vg=typeof IntersectionObserver>"u"?null:new IntersectionObserver(n=>{for(let{target:t,isIntersecting:e}of n){let i=t.figure;i&&(i.visible=e,e&&i.request())}},{rootMargin:"200px"}),JS=new I,bg=new po,ZS=new I(.687,-.639,.344),Sc=class{constructor(t,{onDraw:e,onLost:i=s=>{}}){YS(),this.host=t,this.size=1,this.onDraw=e,this.onLost=i,this.dirty=!0,this.visible=!0,this.abort=new AbortController,this.points=null,this.width=0,this.height=0,this.foot=()=>0,this.canvas=document.createElement("canvas"),this.canvas.figure=this,this.context=this.canvas.getContext("2d"),t.prepend(this.canvas),this.scene=new $r,this.camera=new tn(32,1,.01,100),this.camera.up.set(0,0,1),this.controls=new yc(this.camera,this.canvas),this.controls.addEventListener("change",()=>this.request()),this.controls.enableZoom=!1,this.controls.enablePan=!1,this.canvas.style.touchAction="pan-y",this.listen(t,"focusin",()=>this.controls.enableZoom=!0),this.listen(t,"focusout",()=>this.controls.enableZoom=!1),this.lights(),Ms.add(this),vg?.observe(this.canvas),this.resizes=new ResizeObserver(()=>this.resize()),this.resizes.observe(t)}get signal(){return this.abort.signal}listen(t,e,i,s={}){t.addEventListener(e,i,{...s,signal:this.signal})}lights(){this.sky=new co("#ffffff","#8d95a1",2),this.sky.position.set(0,0,1),this.sun=new fo("#ffffff",2),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=5,this.sun.shadow.bias=-.002,this.scene.add(this.sky,this.sun,this.sun.target),this.resetLights()}resetLights({size:t=this.size,sky:e=2.1,sun:i=1.5}={}){this.size=t,this.sky.intensity=e,this.sun.intensity=i,this.sun.position.set(.55*t,-.75*t,2*t);let{camera:s}=this.sun.shadow;Object.assign(s,{left:-t,right:t,top:t,bottom:-t,near:.05*t,far:4*t}),s.updateProjectionMatrix()}request(){this.dirty=!0,Io??=requestAnimationFrame(ad)}resize(){let{clientWidth:t,clientHeight:e}=this.host;if(Object.assign(this,{width:t,height:e}),!t||!e)return;let i=Math.min(devicePixelRatio,2),[s,r]=[Math.round(t*i),Math.round(e*i)];this.canvas.width===s&&this.canvas.height===r||(Object.assign(this.canvas,{width:s,height:r}),Object.assign(this.canvas.style,{width:`${t}px`,height:`${e}px`}),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.points&&!(Math.abs(this.fitted-this.camera.aspect)<.01)&&this.fit(this.points),this.dirty=!0,ye&&!ye.getContext().isContextLost()?this.draw(ye):this.request())}draw(t){let{width:e,height:i}=this.canvas,s=t.getSize(new yt);(e>s.x||i>s.y)&&t.setSize(Math.max(e,s.x),Math.max(i,s.y),!1),t.setViewport(0,0,e,i),t.setScissor(0,0,e,i),t.render(this.scene,this.camera),this.dirty=!1,this.context.clearRect(0,0,e,i);let r=t.domElement.height-i;this.context.drawImage(t.domElement,0,r,e,i,0,0,e,i),this.onDraw(this)}fit(t){if(this.points=t,!this.height)return;let{camera:e,controls:i,size:s}=this;this.fitted=e.aspect;let r=Math.min(.3,this.foot()/this.height),o=t.map(a=>new I(...a));new Mn().setFromPoints(o).getCenter(i.target),e.position.copy(i.target).addScaledVector(ZS,3*s),Object.assign(e,{near:s/50,far:s*40}),e.updateProjectionMatrix();for(let a=0;a<4;a++){i.update(),e.updateMatrixWorld();let{min:l,max:c}=new Mn().setFromPoints(o.map(g=>g.clone().project(e))),h=e.position.clone().sub(i.target),u=Math.max(0,Math.min(r,(c.y-l.y)/2-1+2*r)),d=h.length()*Math.tan(e.fov*Math.PI/360),[p,f]=[0,1].map(g=>new I().setFromMatrixColumn(e.matrixWorld,g));i.target.addScaledVector(p,(l.x+c.x)/2*d*e.aspect),i.target.addScaledVector(f,((l.y+c.y)/2-u)*d);let[x,m]=[(c.x-l.x)/2/.81,(c.y-l.y)/2/Math.min(.81,.96-r)];h.multiplyScalar(Math.max(x,m)),e.position.copy(i.target).add(h)}i.update(),this.request()}orbit(t,e,i=1){this.controls.rotateLeft(-t),this.controls.rotateUp(-e),this.controls.dollyIn(i)}pixel(t){let e=JS.fromArray(t).project(this.camera);return[(e.x+1)*this.width/2,(1-e.y)*this.height/2]}place({clientX:t,clientY:e}){let i=this.canvas.getBoundingClientRect();return[t-i.left,e-i.top]}onFacingPlane([t,e],i){let s=new yt(2*t/this.width-1,1-2*e/this.height);bg.setFromCamera(s,this.camera);let r=this.camera.getWorldDirection(new I),o=new Qe().setFromNormalAndCoplanarPoint(r,new I(...i));return bg.ray.intersectPlane(o,new I)?.toArray()??null}dispose(){this.abort.abort(),vg?.unobserve(this.canvas),this.resizes.disconnect(),this.controls.dispose(),ws(this.scene),this.sun.dispose(),this.sky.dispose(),this.canvas.figure=null,this.canvas.remove(),Ms.delete(this),!(Ms.size||!ye)&&(cancelAnimationFrame(Io),Io=null,ye.dispose(),ye.forceContextLoss(),ye=null)}};function ws(n){n.traverse(t=>{t.material?.dispose(),t.isInstancedMesh&&t.dispose(),t.geometry&&!gg(t.geometry)&&t.geometry.dispose()}),n.removeFromParent()}var Tc=n=>[...n.children].forEach(ws);var Tg={light:{highlight:"#E69F00",link:"#e9edf2",joint:"#34506b",grid:"#8793a3",gridStrength:.34,shadow:.16,sky:2.1,sun:1.5,path:"#D55E00",wanted:"#7a8290",force:"#C77E00",ghost:"#0072B2",ellipsoid:"#9a4f86",bad:"#c0392b"},dark:{highlight:"#F0B429",link:"#c3ccd8",joint:"#5f86ad",grid:"#93a1b5",gridStrength:.26,shadow:.28,sky:1.15,sun:1.7,path:"#F58A3C",wanted:"#a3adba",force:"#F0B429",ghost:"#56B4E9",ellipsoid:"#d79bc3",bad:"#ff8a6b"}},Sg=["#0072B2","#D55E00","#009E73","#E69F00","#CC79A7","#56B4E9","#882255","#7a8290"],Dn=n=>Sg[n%Sg.length];var ld={};Di(ld,{build:()=>t1,makeHeatTable:()=>Ec,title:()=>KS});var KS="Jacobian",Ag=[..."vω"].flatMap(n=>[..."xyz"].map(t=>[n,t])),QS="The ellipsoid at the tip holds every velocity that joint rates of unit length give it; where it is flat, the tip cannot go.";function t1(n,{point:t}){let e=Ec(t),i=C("p.verdict"),s=C("dl.facts"),r=C("p.words",{},QS),o=C("div.jacobian",{},e.root,C("div",{},i,s,r));function a(l,c){e.update(l,c.columns);let{singular:h,text:u}=Tr(c);oe(i,"class",h?"verdict warning":"verdict"),Pt(i,u),s.replaceChildren(...i1(c))}return{root:o,update:a,summary:(l,c)=>Tr(c).text}}function Ec(n){let t=C("tr"),e=C("tbody"),s=C("table.heat",{"aria-label":"Jacobian of the tip: one column for each joint"},C("thead",{},t),e),[r,o,a]=[[],[],null];function l(h){a=h;let u=dt(h);r=u.map(p=>C("button",Eg(p,n),Se("q",p+1)));let d=r.map(p=>C("th",{scope:"col"},p));t.replaceChildren(C("th",{},C("span.hidden",{},"row")),...d),o=Ag.map(()=>u.map(p=>C("td",Eg(p,n)))),e.replaceChildren(...o.map(e1))}function c({arm:h,highlightedRow:u},d){a!==h&&l(h);let p=dt(h).indexOf(u);r.forEach((x,m)=>oe(x,"aria-pressed",String(m===p)));let f=[0,3].map(x=>Math.max(1e-9,...d.flatMap(m=>m.slice(x,x+3).map(Math.abs))));o.forEach((x,m)=>x.forEach((g,y)=>n1(g,d[y][m],f[m<3?0:1])))}return{root:Cs("Jacobian",s),update:c}}function e1(n,t){let e=C("th",{scope:"row"},Se(...Ag[t]));return C(t===3?"tr.second":"tr",{},e,n)}function n1(n,t,e){let i=Math.abs(t)/e;Pt(n,Qo(t,3)),oe(n,"class",i<5e-4?"nought":t>0?"plus":"minus"),n.style.setProperty("--share",i.toFixed(2))}function Eg(n,t){let[e,i]=[()=>t(n),()=>t(null)];return{onpointerenter:e,onpointerleave:i,onfocus:e,onblur:i,onclick:e}}function i1(n){let{arm:t,determinant:e,manipulability:i,values:s,linear:r}=n,o=d=>Math.abs(d)<5e-7?"0":Math.abs(d)<.001?wr(d,2):At(d,5),a=(d,p)=>[C("dt",{},d),C("dd",{},p)],l=Ae(t)===3,c=["det ",C("i",{},"J"),...l?[C("sub",{},"v")]:[]],h=e===null?[]:a(c,o(e)),u=la(t)?a("smallest σ",o(s[la(t)-1])):[];return[...h,...a("manipulability",o(i)),...u,...a("half axes",r.values.map(d=>At(d,2)).join(", "))]}var _d={};Di(_d,{build:()=>Z1,makeMatrix:()=>Fc,title:()=>Y1});var On=Math.PI/180,w3=180/Math.PI;var pn=(n,t)=>[...n].map(e=>[e,t]),Cg=new Map([...pn("−–—‐‑‒﹣－","-"),...pn("       　"," "),...pn("​\uFEFF⁡⁢",""),...pn("“”„‟`‘’‚",'"'),...pn("│┃║","|"),["，",","],["（","("],["）",")"],...[..."０１２３４５６７８９"].flatMap((n,t)=>pn(n,`${t}`))]),s1=new RegExp(`[${[...Cg.keys()].join("")}]`,"g"),r1=/\\(?:left|right|[bB]ig[lr]?|displaystyle|q?quad)(?![A-Za-z])\.?|\\[[\],;:! ]|\$|~(?! *[\d.])/g,cd=n=>n.replace(s1,t=>Cg.get(t)),hd=n=>n.replace(r1," "),Rg=String.raw`(?:\w*matrix\*?|array|tabular\*?)`,o1=n=>`${n.trim()}_`,a1=[[/\r\n?|[\v\f]/g,`
`],[/\+?[⎛-⎭─-╬]+\+?/g," "],[/\b(?:Sin|Cos|Sqrt|Pi)(?![a-z])/g,n=>n.toLowerCase()],[/\b(?:wrist|joint|column|link|sol(?:ution)?|lösung)[ \t]+(?=\d)/gi,o1],[/(?<![\p{L}\p{N}])(τ|θ|tau|theta|q)[ \t]+(?=\d[ \t]*=)/gu,"$1_"],[/\\pm\b/g,"±"],[/\.\.\.[ \t]*\n/g,"\v"],[/(\.\d{12,15})(?=-\d)/g,"$1 "],[/\[(?:\d{1,3},|,\d{1,3})\]/g," "],[new RegExp(String.raw`\\begin\{${Rg}\}(?:\[[^\]\n]{0,9}\])?(?:\{[lcr|\s]{0,60}\})?`,"g"),"["],[new RegExp(String.raw`\\end\{${Rg}\}`,"g"),"]"],[/\\(?:begin|end)\{[a-z]{1,20}\*?\}/g,"␞"],[/\\(?:hline|(?:top|mid|bottom)rule|c(?:line|midrule)\{[^{}\n]{0,20}\})/g," "],[/\\\\(?:\[[^\]\n]{0,9}\])?/g,"␞"],[/:=\s*<<[^:]*>>/g,n=>n.replaceAll("<","[").replaceAll(">","]")],[/<\/t[dh]>\s*<t[dh][^<>\n]{0,60}>/gi," | "],[/<\/?(?:table|tr|t[dh])\b[^<>\n]{0,60}>/gi," "],[/^[ \t]*(?:In|Out)[ \t]?\[\d{1,4}\]:?/gm,""],[/(?<=\d)\*\^(?=-?\d)/g,"e"],[/(?<=\d)\{,\}(?=\d)/g,","]],l1=/■\(([^■]*)\)/g,c1=/^[ \t]*- +(?=[-[{])/m,h1=/^[ \t]*- +/gm;function pr(n){let t=a1.reduce((i,[s,r])=>i.replace(s,r),cd(n)),e=hd(t).replace(l1,(i,s)=>`(${s.replaceAll("@","␞")})`);return c1.test(e)?e.replace(h1,""):e}var Ac=n=>n.split(/\r\n?|[\n\v\f]/);var Pg=2e4,u1=10,Dg=60,Og={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,radians:n=>n*On,deg2rad:n=>n*On,float64:n=>n},Ig={"+":(n,t)=>n+t,"-":(n,t)=>n-t,"*":(n,t)=>n*t,"/":(n,t)=>t===0?NaN:n/t,"^":d1},Fg={pi:Math.PI,deg:On,rad:1},mr=n=>Object.hasOwn(Og,n),Ug=n=>Object.hasOwn(Fg,n);function d1(n,t){let e=n**t;return Number.isFinite(e)||!Number.isFinite(n)?e:NaN}var f1="alpha beta gamma delta theta theta phi phi psi omega lambda theta".split(" "),p1=new Map([...pn("×⋅·∙∗","*"),...pn("÷∕⁄","/"),...pn("′","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((n,t)=>pn(n,`_${t}`)),...[..."αβγδθϑφϕψωλΘ"].flatMap((n,t)=>pn(n,` ${f1[t]}`)),...pn("π𝜋"," pi "),...pn("°º˚◦∘"," deg"),["√"," sqrt "]]),m1=[[/\\(?:math(?:rm|bf|it)|text(?:bf|it|rm)?|boldsymbol)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*\\circ\s*\}?|\\degree(?![A-Za-z])/g," deg"],[/\\(?:cdot|times)(?![A-Za-z])/g,"*"],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"]],g1=[[/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,"(($1)/($2))"],[/(\\(?:sqrt|sin|cos|tan)|\^)\s*\{([^{}]*)\}/g,"$1($2)"]],kg="⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹",x1=new RegExp(`[${kg}]+`,"g"),_1=/(?<![A-Za-z_])(q|theta) *[[(] *([0-9]{1,2}) *[\])]/g,y1=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,v1=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,ud=new RegExp(String.raw`\s*(?:(${y1})|(${v1})|(\*\*|[-+*/^()]))`,"y"),b1=/^(?:[acdlsCS]_?(?:\d|\{[\d+-]+\})+){2,}$/,M1=/[acdlsCS]_?(?:\d|\{[\d+-]+\})+/g,w1=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,gr=n=>w1.test(n),xr=n=>/\d[.,]\d/.test(n);function Ge(n){if(gr(n))return n;n=hd(cd(n)),n=n.replace(/([₀-₉])(?=[A-Za-zα-ω])/g,"$1*"),n=n.replace(x1,t=>`^${[...t].map(e=>"+-0123456789"[kg.indexOf(e)]).join("")}`),n=[...n].map(t=>p1.get(t)??t).join("");for(let[t,e]of m1)n=n.replace(t,e);for(let t="";t!==n;){t=n;for(let[e,i]of g1)n=n.replace(e,i)}return n=n.replace(/\\([A-Za-z]+)/g," $1 "),n=n.replace(/\b(?:np|math|sp|sym)\./g,""),n=n.replace(/\.(?=[*/^])/g,""),n=n.replace(/(?<=\w)\s*\(t\)/g,""),n=n.replace(_1,"$1_$2"),n=n.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),n=n.replace(/(?<![_\w])\{/g,"("),n=n.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),n.replace(/[ \t]+/g," ").trim()}var Fn=n=>Ge(n).replace(/[_{}'*^\\\s]/g,"").toLowerCase();function es(n,t="the formula"){if(n.length>Pg)throw new Jt(`${t} has ${n.length} characters; expected at most ${Pg}`);if(!n.trim())throw new Jt(`${t} is empty; expected a number or a formula, or 0`);let e=Ge(n),i=T1(e);if(!i)throw new Jt(`${t} is ${Vn(n)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let s=S1(i);if(s?.[1]!==i.length)throw new Jt(`${t} is ${Vn(n)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return s[0]}var Zn=class extends Error{};function S1(n){try{return Bg(n,0,0)}catch(t){if(t instanceof Zn)return null;throw t}}function T1(n){let t=[];for(let e=0;e<n.length;e=ud.lastIndex){ud.lastIndex=e;let i=ud.exec(n);if(!i)return null;let[,s,r,o]=i;if(s!==void 0)t.push(["num",s]);else if(o!==void 0)t.push(["sign",o==="**"?"^":o]);else for(let a of b1.test(r)?r.match(M1):[r])t.push(["name",a])}return t}function Rc(n,t){if(t>=n.length)throw new Zn;return n[t]}function Bg(n,t,e){let[i,s]=Lg(n,t,e);for(;s<n.length&&["+","-"].includes(n[s][1]);){let[r,o]=Lg(n,s+1,e);[i,s]=[[n[s][1],i,r],o]}return[i,s]}function Lg(n,t,e){let[i,s]=No(n,t,e);for(;s<n.length;){let[r,o]=n[s];if(o==="*"||o==="/"){let[a,l]=No(n,s+1,e);[i,s]=[[o,i,a],l]}else if(o==="("||r!=="sign"){if(r==="num"&&n[s-1][0]==="num")throw new Zn;let[a,l]=zg(n,s,e);[i,s]=[["*",i,a],l]}else break}return[i,s]}function No(n,t,e){if(e>Dg)throw new Zn;let i=Rc(n,t)[1];if(i==="-"){let[s,r]=No(n,t+1,e+1);return[["neg",s],r]}return i==="+"?No(n,t+1,e+1):zg(n,t,e)}function zg(n,t,e){let[i,s]=Cc(n,t,e);if(s>=n.length||n[s][1]!=="^")return[i,s];let[r,o]=No(n,s+1,e+1),a=r[0]==="num"&&r[1]===0;if(i[0]==="num"&&i[1]>u1&&a)throw new Zn;return[["^",i,r],o]}function Cc(n,t,e){let[i,s]=Rc(n,t);if(i==="num")return[["num",Number(s),A1(s)],t+1];if(i==="name"&&mr(s)&&t+1<n.length){if(n[t+1][1]==="^"){let[c,h]=Cc(n,t+2,e+1);if(c[0]!=="num")throw new Zn;let[u,d]=Ng(n,h,e+1);return[["^",["call",s,u],c],d]}let[a,l]=Ng(n,t+1,e+1);return[["call",s,a],l]}if(i==="name")return[["name",s],t+1];if(s!=="(")throw new Zn;let[r,o]=Bg(n,t+1,e+1);if(Rc(n,o)[1]!==")")throw new Zn;return[r,o+1]}function Ng(n,t,e){if(e>Dg)throw new Zn;if(Rc(n,t)[1]!=="-")return Cc(n,t,e);let[i,s]=Cc(n,t+1,e);return[["neg",i],s]}function Do(n,t=new Set){for(let e=[n];e.length;){let[i,...s]=e.pop();i==="name"&&!Ug(s[0])&&t.add(s[0]),e.push(...s.filter(Array.isArray).reverse())}return t}function Pi(n,t){let e=Pc(n,t);if(!Number.isFinite(e))throw new Jt("a formula divides by zero or is too large; expected a finite value");return e}function Pc(n,t){let e=[];for(;Object.hasOwn(Ig,n[0]);n=n[1])e.push(n);let i=E1(n,t);return e.reduceRight((s,[r,,o])=>Ig[r](s,Pc(o,t)),i)}function E1([n,t,e],i){if(n==="num")return t;if(n==="neg")return-Pc(t,i);if(n==="call")return Og[t](Pc(e,i));let s=Ug(t)?Fg[t]:i(t);if(s===void 0)throw new Jt(`no value for ${t}`);return s}function A1(n){let[t,e="0"]=n.toLowerCase().split("e"),i=t.split(".")[1];return i?.5*10**(Number(e)-i.length):0}var Un=n=>_h(()=>Pi(es(n),()=>{})),Ic=n=>_h(()=>[...Do(es(n))]);var dd=200,Gg={angle:{units:{deg:On,rad:1},most:1e3,of:"an angle",such:"90°, pi/2 or 1.571 rad"},length:{units:{m:1,cm:.01,mm:.001},bare:"m",most:100,of:"a length",such:"metres, as 0.333"},force:{units:{N:1,kN:1e3},bare:"N",most:1e5,of:"a force",such:"newtons, as −5"},moment:{units:{Nm:1,Nmm:.001},bare:"Nm",most:1e5,of:"a moment",such:"newton metres, as 0.5"}},R1=new Set(Object.values(Gg).flatMap(({units:n})=>Object.keys(n))),C1=["radians","deg2rad","asin","acos","atan"],P1=/\bN\s*[*·⋅]?\s*(m{1,2})\b/g,I1=/^([^,]*\d|[^,\d]*),(\d+[^,]*)$/,L1=/([A-Za-z_]\w*)\s*(\(|\s(?=[A-Za-z_]))/g,Lc=class extends Error{};function ci(n=""){throw new Lc(n)}function N1(n){let t=n.includes(".")?n:n.trim().replace(I1,"$1.$2"),e=Ge(t).replace(P1,"N$1");for(let[,i,s]of e.matchAll(L1))i!=="pi"&&!(s==="("&&mr(i))&&ci();try{return es(e)}catch(i){throw i instanceof Jt&&ci(),i}}var Vg=([n,t])=>n==="name"&&R1.has(t),D1=([,...n])=>n.filter(Array.isArray);function Nc(n){let[t,e,i]=n;if(t==="call"||t==="^")return{units:[],names:[]};if(t==="name")return{units:[],names:[e]};let s=t==="*"&&Vg(i),r=(s?[e]:D1(n)).map(Nc);return{units:[...r.flatMap(({units:o})=>o),...s?[i[1]]:[]],names:r.flatMap(({names:o})=>o)}}function Hg(n,t,e){let[i,s,r]=n,o=l=>Vg(l)?t[l[1]]:Hg(l,t,e);if(i==="name")return t[s];if(i==="num"||i==="^")return Pi(n,()=>ci());if(i==="call")return Pi(n,()=>ci())*(C1.includes(s)?e:1);let a=(i==="neg"?[s]:[s,r]).map(l=>["num",o(l)]);return Pi([i,...a],()=>ci())}var O1=1e-9;function F1(n,t,e){let i=Nc(n),s="rad"in t,r=s&&i.names.includes("pi")&&!i.units.includes("rad"),[o,a,l]=[1,2,3].map(d=>{let p=Object.fromEntries(Object.entries(t).map(([f,x])=>[f,x*d]));return Hg(n,{...p,pi:Math.PI*(r?d:1)},s?d:1)}),c=d=>Math.abs(d)<=O1*Math.max(Math.abs(o),Math.abs(a));c(l-2*a+o)||ci("has two units");let[h,u]=[a-o,2*o-a];return c(u)?o:c(h)?o*(e?t[e]:1):((r||i.units.some(d=>d!==e))&&ci("mixes numbers with and without a unit; say the unit of each"),u*t[e]+h)}function U1(n,t){n.length>dd&&ci();let e=N1(n),i=Nc(e).units.find(s=>!(s in t));return i&&ci(`has the unit ${i==="deg"?"°":i}`),e}function Dc(n,t,e){let{units:i,bare:s,most:r,of:o,such:a}=Gg[t],l=e&&e in i?e:s??"rad",c=`“${n.trim().slice(0,40)}${n.trim().length>40?"…":""}”`;if(!n.trim())return{error:"is empty; write 0 for none"};if(n.length>dd)return{error:`has ${n.length} characters; ${dd} are the most`};try{let h=U1(n,i);Nc(h).names.some(d=>d!=="pi")&&ci();let u=F1(h,i,l);return Math.abs(u)>r?{error:`${c} is too large for ${o} here`}:{value:u+0}}catch(h){return{error:`${c} ${k1(h,{of:o,such:a})}`}}}function k1(n,{of:t,such:e}){if(n instanceof Jt)return"divides by zero or is too large";if(!(n instanceof Lc))throw n;return n.message?`${n.message}; ${t} is asked for: ${e}`:`is no number; write ${e}`}var Wg=n=>/^\s*$|[-+*/(.,eE−–πp]\s*$/.test(n)||/^[\s\d.,]*$/.test(n);function fd(n,t,e){let i=t&&(e||!Wg(n.value))?t:"";return oe(n,"aria-invalid",String(!!i)),i}function ns(n,t,{unit:e,whole:i}){let{value:s,error:r}=Dc(n.value,t,e);return{value:s,message:fd(n,r,i)}}var hi=(n,t,e={})=>C("input",{type:"text",spellcheck:"false",autocomplete:"off","aria-label":n,oninput:i=>t(i.target,!1),onchange:i=>t(i.target,!0),...e});function is(n,t){n.getRootNode().activeElement!==n&&n.value!==t&&(n.value=t)}var qg=n=>dt(n).map(t=>Rn(n.rows[t])),Oc=(n,[t,e])=>Math.min(e,Math.max(t,n)),jg=({x:n,y:t,z:e,o:i},s)=>Yt(i,Yt(Yt(Ut(s[0],n),Ut(s[1],t)),Ut(s[2],e))),Yg=({x:n,y:t,z:e,o:i},s)=>[n,t,e].map(r=>he(r,Rt(s,i))),Jg=30,pd=1e-4;function Zg(n,t,e){let[i,s]=[n(t),n(Yt(t,Ut(pd,e)))];return{at:i,rate:[(s[0]-i[0])/pd,(s[1]-i[1])/pd]}}function Kg(n,t,{row:e,local:i,to:s,joint:r,pixel:o}){let a=dt(n)[r],l=n.rows[a].kind==="revolute",c=Rn(n.rows[a]),h=[...t];for(let u=0;u<4;u++){let d=Ot(n,h),p=jg(d[e+1],i),{z:f,o:x}=d[a],{at:m,rate:g}=Zg(o,p,l?Me(f,Rt(p,x)):f),[y]=Er([g],[mi(g,[s[0]-m[0],s[1]-m[1]])],Jg**2);h[r]+=Oc(y,[-.2,.2])}return h[r]=Oc(h[r],[Math.min(c[0],t[r]),Math.max(c[1],t[r])]),h}var B1=.3,$g=(n,t)=>t?n.map((e,i)=>i<3?e:B1*e):n.slice(0,3),Qg=.12,md=1e-4;function t0(n,t,e,i,{turns:s=!1}={}){let r=qg(n).map(([h,u],d)=>[Math.min(h,t[d]),Math.max(u,t[d])]),o={arm:n,target:e,rest:i,turns:s,limits:r},a=Xg(o,t);ls(a.q,t)&&Xt(Rt(e.o,a.frames.at(-1).o))>.002&&(a=wh(a,a.q,h=>Xg(o,h)));let l=Math.max(1e-12,...a.q.map((h,u)=>Math.abs(h-t[u]))),c=Math.min(1,Qg/l);return{q:t.map((h,u)=>h+c*(a.q[u]-h)),arrived:c===1}}function Xg({arm:n,target:t,rest:e,turns:i,limits:s},r){let o=d=>$g(Is(d.at(-1),t),i),a=(d,p)=>Xt(o(d))**2+md*p.reduce((f,x,m)=>f+(x-e[m])**2,0),[l,c]=[r.map((d,p)=>Oc(d,s[p])),.001],h=Ot(n,l),u=a(h,l);for(let d=0;d<12;d++){let p=o(h),f=We(n,h).map(M=>$g(M,i)),x=f.map((M,O)=>mi(M,p)-md*(l[O]-e[O])),m=[...l.keys()].filter(M=>!(l[M]<=s[M][0]&&x[M]<0)&&!(l[M]>=s[M][1]&&x[M]>0)),[g,y]=[f,x].map(M=>m.map(O=>M[O])),S=Er(g,y,md+c),w=[...l];m.forEach((M,O)=>w[M]=Oc(l[M]+S[O],s[M]));let A=Ot(n,w),E=a(A,w);if(E>=u){c*=6;continue}let _=u-E;if([l,h,u,c]=[w,A,E,Math.max(1e-5,c/4)],_<1e-10)break}return{q:l,frames:h,error:u}}function e0(n,t,e){let i=Ot(n,t),s=i.at(-1).o,r=Rt(e,s),o=Xt(r),a=[];if(o<.002||!t.length)return{short:o,stops:a};let l=dt(n),c=We(n,i).map(y=>y.slice(0,3)),h=l.map(y=>[n.rows[y].lower??-1/0,n.rows[y].upper??1/0]),u=c.map(y=>he(y,r)/o),d=t.map((y,S)=>y<=h[S][0]+1e-6&&u[S]<-.001||y>=h[S][1]-1e-6&&u[S]>.001);d.forEach((y,S)=>y&&a.push(`joint ${l[S]+1} at its limit`));let p=z1(n,t,i),{values:f,vectors:x}=ln(c.filter((y,S)=>!d[S]),3),g=x.filter((y,S)=>!(f[S]>.05*f[0])).reduce((y,S)=>y+(he(S,r)/o)**2,0);return g>.5&&p?a.push(p):g>.5&&a.push("no joint moves the tip that way here"),{short:o,stops:a}}var n0=.1;function i0(n,t=!1){let e=t?ti(n.map(o=>o.slice(3))).map(o=>o.reduce((a,l,c)=>Yt(a,Ut(l,n[c])),[0,0,0])):n.map(o=>o.slice(0,3));if(e.length<3)return[];let{values:i,vectors:s}=ln(e,3),r=i.map(o=>o/i[0]);return s.flatMap((o,a)=>r[a]<n0?[{direction:o,share:r[a]}]:[])}var s0=({share:n})=>1-n/n0;function z1(n,t,e){let i=dt(n),s=e[i[1]??0].o,r=c=>Xt(Rt(Ot(n,c).at(-1).o,s)),o=r(t),[a,l]=[.01*Math.max(o,.1),null];return t.forEach((c,h)=>{if(h===0||n.rows[i[h]].kind!=="revolute")return;let[u,d]=[-.4,.4].map(f=>r(t.map((x,m)=>m===h?x+f:x))-o),p=Math.min(Math.abs(u),Math.abs(d));Math.sign(u)!==Math.sign(d)||p<a||([a,l]=[p,u<0?`joint ${i[h]+1} straight`:`joint ${i[h]+1} folded`])}),l}function r0(n,t,e,i,{turns:s=!0}={}){let r=qg(n),o=(c,h)=>c>=Math.min(r[h][0],t[h])-1e-9&&c<=Math.max(r[h][1],t[h])+1e-9,a=t,l=0;for(let c=0;c<4;c++){let h=Ot(n,a),u=ti(We(n,h).map(x=>x.slice(0,s?6:3)));if(l=u.length,!l)break;let d=G1(a,V1(n,h,u,e)),{q:p,error:f}=gi(n,d,i,{rows:s?6:3});if(!p.every(o)||f>1e-4)break;a=p}return{q:a,free:l}}var G1=(n,t)=>n.map((e,i)=>e+t[i]);function V1(n,t,e,{row:i,local:s,to:r,pixel:o}){let a=jg(t[i+1],s),l=dt(n),c=We(n,t,a).filter((x,m)=>l[m]<=i),h=e.map(x=>{let m=c.reduce((g,y,S)=>Yt(g,Ut(x[S],y)),[0,0,0]);return Zg(o,a,m)}),u=Rt([...r,0],[...h[0].at,0]).slice(0,2),d=h.map(({rate:x})=>x),p=Er(d,d.map(x=>mi(x,u)),Jg**2),f=Math.min(1,Qg/Math.max(1e-12,...p.map(Math.abs)));return l.map((x,m)=>e.reduce((g,y,S)=>g+f*p[S]*y[m],0))}var H1=22,o0={mouse:11,touch:20,pen:16},W1=4,$1=0;function a0(n,t,{grip:e,goTo:i}){let s=new gd(n,t,i),{figure:r}=n,{canvas:o}=r,a=c=>s.takes(c);r.listen(o,"pointerdown",a,{capture:!0}),r.listen(e,"pointerdown",c=>{c.button||s.begin(c,{kind:"tip"})});for(let c of[o,e])r.listen(c,"pointermove",h=>s.move(h)),r.listen(c,"pointerup",h=>s.release(h)),r.listen(c,"pointercancel",h=>s.release(h));r.listen(o,"pointerleave",()=>s.drag||s.hover(null));let l=c=>{let[{clientX:h,clientY:u}]=c.touches;c.touches.length===1&&s.under({clientX:h,clientY:u,pointerType:"touch"})&&c.preventDefault()};r.listen(o,"touchstart",l,{passive:!1}),r.signal.addEventListener("abort",()=>od(s.step))}var gd=class{constructor(t,e,i){this.picture=t,this.figure=t.figure,this.store=e,this.goTo=i,this.drag=null,this.down=null,this.step=()=>{this.drag&&!this.follow()&&rd(this.step)}}ballAt(t){let{handle:e}=this.picture;if(!e?.visible)return!1;let[i,s]=this.figure.pixel(e.position.toArray());return Math.hypot(i-t[0],s-t[1])<H1}under(t){let{picture:e,store:i}=this,s=this.figure.place(t),{state:r,derived:o}=i;if(this.ballAt(s))return{kind:"force"};let a=r.view==="branches"?e.findBranchAt(s):null;if(a!==null)return{kind:"branch",branch:a};let l=e.findLinkAt(s,o0[t.pointerType]??o0.touch,e.grips());if(!l)return null;let{frames:c}=o,h={row:l.row,local:Yg(c[l.row+1],l.point)};if(r.hold?.pinned)return{kind:"elbow",...h};let u=X1(r.arm,c,l,.02*e.size);return u===null?null:{kind:"link",highlightedRow:u,...h}}takes(t){if(t.button)return;let e=this.under(t);this.down=[t.clientX,t.clientY,e],!(!e||e.kind==="branch")&&(t.stopImmediatePropagation(),this.begin(t,e))}begin(t,e){let{figure:i,store:s}=this,r=i.place(t),o=s.derived.frames.at(-1);this.drag={...e,id:t.pointerId,at:t,gesture:`drag ${++$1}`,rest:s.state.q,tip:o,point:o.o},e.kind==="tip"&&(this.drag.from=i.onFacingPlane(r,o.o)),t.target.setPointerCapture(t.pointerId);let a=e.highlightedRow===void 0?{}:{highlightedRow:e.highlightedRow};s.dispatch({type:"setFields",dragging:!0,...a}),i.canvas.classList.add("held")}follow(){let{drag:t,store:e}=this;return t.to=this.figure.place(t.at),this[t.kind](e.state)}force(){let{picture:t,figure:e,store:i,drag:s}=this,r=e.onFacingPlane(s.to,t.handle.position.toArray()),o=r&&[...t.forceFrom(r),...i.state.wrench.slice(3)];return o&&i.dispatch({type:"setWrench",wrench:o,gesture:s.gesture}),!0}link({arm:t,q:e}){let{row:i,local:s,to:r,highlightedRow:o,gesture:a}=this.drag,l=dt(t).indexOf(o),h=Kg(t,e,{row:i,local:s,to:r,joint:l,pixel:u=>this.figure.pixel(u)});return this.store.dispatch({type:"moveJoints",q:h,gesture:a}),!0}elbow({arm:t,q:e,hold:i}){let{row:s,local:r,to:o,gesture:a}=this.drag,l={row:s,local:r,to:o,pixel:u=>this.figure.pixel(u)},{q:c,free:h}=r0(t,e,l,i.pinned,{turns:i.turns});return this.store.dispatch({type:"moveJoints",q:c,hold:{...i,free:h},gesture:a}),!0}tip(t){let{to:e,from:i,point:s,tip:r,rest:o,gesture:a}=this.drag,l=this.figure.onFacingPlane(e,s);if(!l)return!0;let c=r.o.map((h,u)=>h+l[u]-i[u]);return l0(this.store,t,{...r,o:c},{rest:o,gesture:a})}move(t){let{drag:e,figure:i}=this;e&&t.pointerId===e.id?(e.at=t,rd(this.step)):!e&&t.buttons===0&&t.target===i.canvas&&this.hover(this.under(t))}hover(t){let{store:e}=this;this.figure.canvas.style.cursor=t?"pointer":"grab";let i=t?.kind==="link"?t.highlightedRow:null;e.state.highlightedRow!==i&&e.dispatch({type:"setFields",highlightedRow:i});let s=t?.kind==="branch"?t.branch:null;e.state.highlightedBranch!==s&&e.dispatch({type:"setFields",highlightedBranch:s})}release(t){let{drag:e,down:i,store:s}=this;if(e&&t.pointerId!==e.id)return;if(i&&Math.hypot(t.clientX-i[0],t.clientY-i[1])<W1&&i[2]?.kind==="branch"&&this.goTo(s.state.branches.list[i[2].branch].q),e){od(this.step)&&this.follow();let o=s.state.hold?.pinned?s.state.hold:null;s.dispatch({type:"setFields",dragging:!1,highlightedRow:null,hold:o})}[this.drag,this.down]=[null,null],this.figure.canvas.classList.remove("held")}};function X1(n,t,{row:e,point:i},s){let r=dt(n).filter(a=>a<=e),o=a=>{let{z:l,o:c}=t[a];return n.rows[a].kind==="prismatic"||Xt(Me(l,Rt(i,c)))>s};return r.reverse().find(o)??null}function l0(n,{arm:t,q:e,keepOrientation:i},s,{rest:r,gesture:o}){let{q:a,arrived:l}=t0(t,e,s,r,{turns:i}),c=a.every((f,x)=>Math.abs(f-e[x])<1e-5),h=l||c,u=h?e0(t,a,s.o):{stops:[],short:0},d=i0(We(t,Ot(t,a)),i),p={kind:"tip",target:s.o,moving:!h,fading:d,...u};return n.dispatch({type:"moveJoints",q:a,hold:p,gesture:o}),h}function xd(n,t,e=null){let i=n.state.q,s={...n.derived.frames.at(-1),o:t};for(let r=0;r<60&&!l0(n,n.state,s,{rest:i,gesture:e});r++);}var q1={ArrowLeft:[-1,0,0],ArrowRight:[1,0,0],ArrowUp:[0,1,0],ArrowDown:[0,-1,0],PageUp:[0,0,-1],PageDown:[0,0,1]},j1=.01;function c0(n,t,e){let i=q1[e.key];if(!i)return!1;e.preventDefault(),e.stopPropagation();let s=j1*(e.shiftKey?.1:1),r=n.cameraAxes(),{o}=t.derived.frames.at(-1);return xd(t,o.map((a,l)=>a+s*i.reduce((c,h,u)=>c+h*r[u][l],0)),"tip keys"),!0}var Y1="Pose",J1="The first three columns are the tip’s axes, the fourth its place, in the base frame and in metres.";function Z1(n,{announce:t}){let e=Fc("T","Pose of the tip, a four by four matrix"),i=K1(n,t),s=C("p.words");return{root:C("div.pose",{},e.root,C("div",{},i.root,i.error,s)),update:(a,{frames:l})=>{let{o:c}=l.at(-1);e.update(`0,${a.arm.rows.length}`,l.at(-1)),i.update(c);let[h,u,d]=c.map(p=>At(1e3*p,1));Pt(s,`Tip at (${h}, ${u}, ${d}) mm. ${J1}${Q1(a.mark,c)}`)},summary:()=>i.error.textContent}}function Fc(n,t){let e=[0,1,2,3].map(()=>[0,1,2,3].map(()=>C("td"))),[i,s]=Se(n,""),r=e.map(c=>C("tr",{},c)),o=C("table.matrix",{"aria-label":t},r),a=(c,h)=>{Pt(s,c),lf(h).forEach((u,d)=>u.forEach((p,f)=>{Pt(e[d][f],d===3?String(p):Qo(p,4)),e[d][f].classList.toggle("nought",Math.abs(p)<5e-5)}))},l=C("span",{},i,s);return{root:C("div.equation",{},l,C("span",{},"="),o),update:a}}function K1(n,t){let e=C("p.error"),i=()=>n.derived.frames.at(-1).o,s=(c,h,u)=>{let{value:d,message:p}=ns(h,"length",{whole:u});Pt(e,p&&`${"xyz"[c]} ${p}.`),p&&t(()=>e.textContent),u&&(d!==void 0&&(xd(n,xn(i(),c,d)),Pt(e,bh(n.state.hold??{stops:[],short:0}))),oe(h,"aria-invalid","false"),h.value=At(i()[c],4))},r=["x","y","z"].map((c,h)=>hi(`Tip ${c}, typed`,(...u)=>s(h,...u),{class:"small"})),o=r.map((c,h)=>C("label",{},C("i",{},"xyz"[h])," ",c," m"));return{root:C("fieldset.wrench",{},C("legend",{},"Bring the tip to"),o),error:e,update:c=>r.forEach((h,u)=>is(h,At(c[u],4)))}}function Q1(n,t){if(!n)return"";let e=n.map(i=>At(i,3)).join(", ");return` It is ${At(1e3*Xt(Rt(t,n)),2)} mm from the mark at (${e}) m.`}var h0=`:host {
  margin: 1.2rem 0;
}
.live {
  margin: 0;
  display: grid;
}
.stage {
  position: relative;
  height: 260px;
  overflow: hidden;
}
.grip {
  border-color: color-mix(in srgb, var(--accent) 55%, transparent);
}
.side {
  padding: 12px 14px;
  display: grid;
  gap: 9px;
  align-content: center;
  border-top: 1px solid var(--line);
}
.rail {
  display: grid;
  align-items: center;
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
`;var Uc=`/* What the instrument and the small figures have in common: colours, controls, the picture. */
:host {
  display: block;
  container-type: inline-size;
}
.explorer,
.live {
  --ink: light-dark(#1f2933, #e4e8ed);
  --soft: light-dark(#5b6775, #a3adba);
  --line: light-dark(#dde2e8, #38404a);
  --ground: light-dark(#ffffff, #171b21);
  --raised: light-dark(#f6f8fa, #1f252d);
  --accent: light-dark(#24618c, #7fb8e2);
  --on-accent: light-dark(#fff, #10202c);
  --plus: light-dark(rgb(230 159 0), rgb(240 180 41));
  --minus: light-dark(rgb(0 114 178), rgb(86 180 233));
  --bad: light-dark(#a83a08, #ffab7a);
  --bad-ground: light-dark(#fdf0e8, #3a2417);
  --good: light-dark(#1a7f4b, #6fcf97);
  --rail: light-dark(#d4dae1, #434d59);
  --x: light-dark(#b94f00, #f58a3c);
  --z: light-dark(#005e94, #5ab4ec);
  color: var(--ink);
  background: var(--ground);
  border: 1px solid var(--line);
  border-radius: 12px;
  overflow: clip;
  font-family: var(--pst-font-family-base, system-ui, sans-serif);
  font-size: 14px;
  line-height: 1.45;
  text-align: left;
  font-variant-numeric: tabular-nums;
}
[data-theme="dark"] {
  color-scheme: dark;
}
[data-theme="light"] {
  color-scheme: light;
}
*,
::before,
::after {
  box-sizing: border-box;
}
sub {
  font-size: 0.72em;
  line-height: 0;
}
i {
  font-family: Georgia, "Times New Roman", serif;
}
.hidden {
  position: absolute;
  width: 1px;
  height: 1px;
  overflow: hidden;
  clip-path: inset(50%);
  white-space: nowrap;
}
[hidden] {
  display: none !important;
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
  will-change: transform;
}
.axis-x {
  color: var(--x);
}
.axis-z {
  color: var(--z);
}
:focus-visible {
  outline: 2px solid var(--accent);
  outline-offset: 2px;
}
.stage canvas {
  display: block;
  position: absolute;
  inset: 0;
  cursor: grab;
  outline: none;
}
.stage canvas.held {
  cursor: grabbing;
}
.rail input {
  pointer-events: none;
}
input[type="range"] {
  --track: linear-gradient(
    to right,
    var(--rail) var(--low, 0%),
    var(--accent) var(--low, 0%) var(--high, 0%),
    var(--rail) var(--high, 0%)
  );
  appearance: none;
  width: 100%;
  height: 18px;
  margin: 0;
  background: none;
  cursor: pointer;
  display: block;
  border-radius: 6px;
}
input[type="range"]::-webkit-slider-runnable-track {
  height: 4px;
  border-radius: 2px;
  background: var(--track);
}
input[type="range"]::-moz-range-track {
  height: 4px;
  border-radius: 2px;
  background: var(--track);
}
input[type="range"]::-webkit-slider-thumb {
  appearance: none;
  width: 16px;
  height: 16px;
  margin-top: -6px;
  border-radius: 50%;
  background: var(--ground);
  border: 2px solid var(--accent);
  box-shadow: 0 1px 2px rgb(0 0 0 / 0.18);
}
input[type="range"]::-moz-range-thumb {
  width: 12px;
  height: 12px;
  border-radius: 50%;
  background: var(--ground);
  border: 2px solid var(--accent);
}
p,
figure {
  margin: 0;
  padding: 0;
}
button,
select,
input[type="text"] {
  font: inherit;
  font-size: 13px;
  color: var(--ink);
  background: var(--ground);
  border: 1px solid var(--line);
  border-radius: 7px;
  padding: 3px 9px;
  min-height: 28px;
}
button {
  cursor: pointer;
}
button[aria-pressed="true"],
button[aria-checked="true"] {
  background: color-mix(in srgb, var(--accent) 16%, var(--ground));
  border-color: var(--accent);
}
/* A bar to both sides of its middle. */
.track {
  position: relative;
  height: 10px;
  border-radius: 3px;
  background:
    linear-gradient(
      to right,
      transparent calc(50% - 0.5px),
      var(--soft) 0 calc(50% + 0.5px),
      transparent 0
    ),
    var(--raised);
  overflow: hidden;
}
.fill {
  position: absolute;
  inset-block: 1px;
  background: var(--accent);
  border-radius: 2px;
}
.rail {
  min-height: 30px;
  touch-action: pan-y;
  cursor: pointer;
}
.row {
  display: flex;
  flex-wrap: wrap;
  align-items: center;
  gap: 8px 12px;
}
.scroll {
  position: relative;
  overflow-x: auto;
  border-radius: 6px;
}
.lever {
  display: grid;
  grid-template-columns: 74px minmax(0, 1fr) 76px;
  align-items: center;
  gap: 8px;
}
.lever output {
  text-align: right;
  color: var(--ink);
}
.words {
  font-size: 13.5px;
}
/* Tables of numbers */
table {
  border-collapse: separate;
  border-spacing: 0;
  font-size: 13px;
}
th {
  font-weight: 500;
  color: var(--soft);
  text-align: left;
  padding: 2px 8px;
  white-space: nowrap;
}
td {
  padding: 2px 8px;
  text-align: right;
  white-space: nowrap;
}
.nought {
  color: var(--soft);
  opacity: 0.75;
}
.equation {
  white-space: nowrap;
  display: flex;
  align-items: center;
  gap: 9px;
  font-size: 16px;
}
.matrix {
  border-inline: 1.5px solid var(--soft);
  border-radius: 7px;
  padding: 2px 2px;
}
.matrix td {
  min-width: 62px;
  padding: 2px 7px;
}
.matrix tr:not(:last-child) td:last-child {
  color: var(--accent);
  font-weight: 600;
}
.heat {
  border-spacing: 2px;
  font-size: 12.5px;
}
.heat th {
  text-align: center;
  color: var(--ink);
  padding: 1px 3px;
  font-size: 14px;
}
.heat td {
  min-width: 42px;
  padding: 3px 2px;
  border-radius: 4px;
}
.heat td.plus {
  background: rgb(from var(--plus) r g b / calc(0.1 + 0.38 * var(--share)));
}
.heat td.minus {
  background: rgb(from var(--minus) r g b / calc(0.1 + 0.36 * var(--share)));
}
.heat td.nought {
  background: var(--raised);
}
.heat tr.second > * {
  border-top: 6px solid transparent;
  background-clip: padding-box;
}
.heat th button {
  padding: 1px 6px;
}
/* Under a finger */
@media (pointer: coarse) {
  button,
  select,
  .rail,
  input[type="text"] {
    min-height: 44px;
    min-width: 44px;
  }
  .grip {
    --size: 44px;
  }
}
.grip {
  position: absolute;
  left: 0;
  top: 0;
  width: var(--size, 30px);
  height: var(--size, 30px);
  margin: calc(var(--size, 30px) / -2);
  padding: 0;
  min-height: 0;
  border: 1.5px dashed transparent;
  border-radius: 50%;
  background: none;
  touch-action: none;
  cursor: grab;
}
.paper {
  position: absolute;
  inset: 0;
}
.still {
  display: block;
  width: 100%;
  height: 100%;
}
.paper slot {
  display: none;
}
.drawn .paper,
.stage:not(.drawn) :is(.labels, .grip) {
  visibility: hidden; /* one picture at a time */
}
.why,
.lost {
  position: absolute;
  left: 10px;
  top: 8px;
  max-width: calc(100% - 20px);
  padding: 3px 9px;
  border-radius: 7px;
  background: var(--bad-ground);
  color: var(--bad);
  font-size: 13px;
  font-weight: 600;
  pointer-events: none;
}
.lost {
  top: auto;
  bottom: 8px;
}
/* Where nothing can be touched, the still picture alone. */
@media print, (scripting: none) {
  .explorer,
  .live {
    display: block !important;
    border: 0;
    background: none;
    color-scheme: light;
  }
  :is(header, .notice, .sliders, .views, .side),
  .stage > :not(.paper) {
    display: none !important;
  }
  .stage {
    all: unset !important;
    display: block !important;
  }
  .paper {
    position: static;
    visibility: visible !important;
    max-width: 480px;
    margin: auto;
    break-inside: avoid;
  }
  .paper slot {
    display: block;
  }
}
`;var u0=[22,15],nT=[[0,0],[0,-14],[0,14],[16,0],[-16,0],[14,-13],[-14,13],[14,13],[-14,-13],[0,-26],[0,26]],kc=class{constructor(t){this.host=t,this.tags=[]}set(t){for(this.tags=t;this.host.children.length<t.length;)this.host.append(C("span",{},C("i"),C("sub")));t.forEach(({letter:e,index:i},s)=>{let r=this.host.children[s];oe(r,"class",`axis-${e}`),Pt(r.children[0],e),Pt(r.children[1],i)})}place(t,e,i){let s=[],r=this.tags.map(({tip:o,index:a})=>{let[l,c]=t(o),h=[u0[0]+4*Math.max(0,a.length-1),u0[1]],u=([m,g])=>s.every(([y,S,w])=>Math.abs(y-l-m)>(h[0]+w)/2||Math.abs(S-c-g)>h[1]),p=l>-20&&c>-20&&l<e+20&&c<i+20&&nT.find(u);if(!p)return null;let[f,x]=[l+p[0],c+p[1]];return s.push([f,x,h[0]]),`translate(${f.toFixed(1)}px, ${x.toFixed(1)}px) translate(-50%, -50%)`});[...this.host.children].forEach((o,a)=>{o.hidden=!r[a],r[a]&&(o.style.transform=r[a])})}dispose(){this.host.replaceChildren()}};var _r=(n,t)=>n.rows.flatMap((e,i)=>{let[s,r]=[t[i].o,t[i+1].o],o=Rt(r,Ut(e.a,t[i+1].x));return[{row:i,from:s,to:o},{row:i,from:o,to:r}]});function d0(n,t,e,i){let s=null;for(let{row:r,from:o,to:a}of n){let{share:l,gap:c}=iT(t,i(o),i(a));c>e||s&&c>=s.gap-.5||(s={row:r,gap:c,point:Yt(o,Ut(l,Rt(a,o)))})}return s}function iT(n,t,e){let[i,s]=n,[r,o]=[e[0]-t[0],e[1]-t[1]],a=r*r+o*o,l=((i-t[0])*r+(s-t[1])*o)/a,c=a<1?1:Math.min(1,Math.max(0,l));return{share:c,gap:Math.hypot(t[0]+c*r-i,t[1]+c*o-s)}}var vd={trace:null,wantedPath:null,tipPaths:null,progress:0,playing:!1,branches:null,highlightedBranch:null,highlightedRow:null,hold:null,mark:null},f0=["wantedPath","progress","playing"],sT={arm:Object.keys(vd),circle:["trace",...f0],trace:f0,branches:["highlightedBranch"],view:["playing","highlightedBranch","highlightedRow"]},yd=["arm","base","reference","q","wrench"],rT=200,oT={selectArm:(n,{arm:t,q:e,reference:i=t})=>cT(n,t,e,i),editTable:(n,{rows:t,q:e,rowBefore:i})=>hT(n,t,e,i),moveJoints:(n,{q:t,hold:e=null})=>an(n.arm,t)?{q:t,hold:e,playing:!1}:null,glide:(n,{q:t})=>an(n.arm,t)?{q:t}:null,seek:(n,{progress:t})=>uT(n,t),setPlaying:(n,{on:t})=>t&&!n.trace?null:{playing:t},setWrench:(n,{wrench:t})=>t.length===6&&t.every(Number.isFinite)?{wrench:t}:null,setCircle:(n,{type:t,...e})=>({circle:{...n.circle,...e}}),setTrace:(n,{arm:t,circle:e,path:i,wantedPath:s})=>t===n.arm&&e===n.circle?{trace:i,wantedPath:s,progress:0,q:i[0]}:null,setBranches:(n,{arm:t,branches:e})=>t===n.arm?{branches:e}:null,setFields:(n,{type:t,...e})=>e,replaceState:(n,{type:t,...e})=>an(e.arm??n.arm,e.q??n.q)?e:null,undo:n=>p0(n,"past","future"),redo:n=>p0(n,"future","past")};function aT(n,t){let e=oT[t.type](n,t);if(!e)return n;let i=Object.keys(e).filter(o=>e[o]!==n[o]);if(!i.length)return n;let s=i.flatMap(o=>sT[o]??[]).filter(o=>!(o in e)),r={...n,...Object.fromEntries(s.map(o=>[o,vd[o]])),...e};return lT(n,r,t)}function lT(n,t,{type:e,gesture:i=null}){if(["undo","redo","seek"].includes(e)||yd.every(r=>n[r]===t[r]))return t;if(i!==null&&n.past.at(-1)?.gesture===i)return t.future=[],t;let s={gesture:i,...Object.fromEntries(yd.map(r=>[r,n[r]]))};return{...t,past:[...n.past,s].slice(-rT),future:[]}}function p0(n,t,e){let i=n[t].at(-1);if(!i)return null;let{gesture:s,...r}=i,o={gesture:null,...Object.fromEntries(yd.map(a=>[a,n[a]]))};return{...r,playing:!1,[t]:n[t].slice(0,-1),[e]:[...n[e],o]}}function cT(n,t,e,i){return{arm:t,base:t,reference:i,q:an(t,e)?e:Oi(t)}}function hT(n,t,e,i=s=>s){if(As(t))return null;let{rows:s}=n.arm;if(t.length===s.length&&t.every((o,a)=>lh(o,s[a])))return null;let r=Jo(t,n.base);return{arm:r,q:an(r,e)?e:ch(n.arm,n.q,r,i)}}function uT({trace:n,arm:t},e){if(!n||!n.every(r=>r.length===n[0].length)||!an(t,n[0]))return null;let i=Math.min(n.length-2,Math.floor(e*(n.length-1))),s=e*(n.length-1)-i;return{progress:e,q:n[i].map((r,o)=>r+s*(n[i+1][o]-r))}}var zc=n=>({base:n.arm,reference:n.arm,wrench:[0,0,0,0,0,0],unit:"deg",view:"pose",frames:"ends",circle:{normal:"x",radius:.1},keepOrientation:!1,dragging:!1,runs:[],past:[],future:[],...vd,...n}),Bc=class{#e=new Map;constructor(t,e,i){this.arm=t,this.q=e,this.wrench=i}#t(t,e){return this.#e.has(t)||this.#e.set(t,e()),this.#e.get(t)}get frames(){return this.#t("frames",()=>Ot(this.arm,this.q))}get columns(){return this.#t("columns",()=>We(this.arm,this.frames))}rows(t){return this.columns.map(e=>e.slice(0,t))}get task(){let t=Ae(this.arm);return this.#t("task",()=>ln(this.rows(t),t))}get linear(){return this.#t("linear",()=>ln(this.rows(3),3))}get values(){return this.task.values}get rank(){return Hf(this.values)}get lost(){return this.#t("lost",()=>yf(this.task.vectors.slice(this.rank).map(t=>[...t,0,0,0].slice(0,6))))}get determinant(){let t=Ae(this.arm);return this.#t("determinant",()=>xf(this.rows(t)))}get manipulability(){let{values:t,columns:e}=this;return t.slice(0,Math.min(t.length,e.length)).reduce((i,s)=>i*s,1)}get gravity(){return this.#t("gravity",()=>Xo(this.arm,this.frames))}get energy(){return cf(this.arm,this.frames)}get push(){return this.#t("push",()=>qo(this.columns,this.wrench))}get torque(){return this.gravity.map((t,e)=>t-this.push[e])}};function Gc({branches:n},{frames:t}){if(!n)return null;let{x:e,y:i,z:s,o:r}=t.at(-1),o=Xt(Rt(r,n.target.o)),a=n.hasOrientation?Math.max(...Object.entries({x:e,y:i,z:s}).map(([l,c])=>Xt(Rt(c,n.target[l])))):0;return o>5e-4||a>.002?{far:o,turned:a}:null}var Ss=class{#e=new Set;constructor(t){this.state=t,this.derived=new Bc(t.arm,t.q,t.wrench)}dispatch(t,e="reader"){let i=this.state,s=aT(i,t);if(s===i)return!1;let r=new Set(Object.keys(s).filter(o=>s[o]!==i[o]));this.state=s,["arm","q","wrench"].some(o=>r.has(o))&&(this.derived=new Bc(s.arm,s.q,s.wrench));for(let o of[...this.#e])o(r,e);return!0}listen(t,e){this.#e.add(t),e?.addEventListener("abort",()=>this.#e.delete(t),{once:!0})}};var bd=10,Md=.36,Vc=class{constructor(t,e,i={}){this.figure=new Sc(t,{onDraw:()=>this.place(),onLost:i.onLost}),this.labels=new kc(e),this.onPlace=i.onPlace??(()=>{}),this.world=null,this.arm=null,this.frames=null,this.drawn=[],this.first=i.first??0,this.shown={}}build(t,e){let i=Tg[e?"dark":"light"];this.world&&ws(this.world),this.arm=t,this.dark=e,this.look=i,this.size=Rs(t),this.shown={},this.tints={highlight:new kt(i.highlight),bad:new kt(i.bad)},this.body=dT(t,i),this.axis=sd(new un({color:i.highlight,transparent:!0,opacity:.75})),this.triads=new vc(e,t.rows.length+1),this.barrier=pT(this.size,i),this.path=new Ce,this.ghosts=new Ce,this.reference=new Ce,this.world=new Ce,this.world.add(this.body,_g(this.size,i.grid,i.gridStrength),fT(this.size,i),this.triads,this.axis,...this.marks(i),this.barrier,this.path,this.ghosts,this.reference),this.figure.scene.add(this.world),this.figure.resetLights({size:this.size,sky:i.sky,sun:i.sun})}marks(t){let e=new un({color:t.force}),i=new un({color:t.bad});this.ellipsoid=new bc(t.ellipsoid),this.force=new bs(e),this.handle=wc(e),this.handle.scale.setScalar(.022*this.size),this.spot=wc(i),this.spot.scale.setScalar(.014*this.size),this.fading=new Ce;for(let s=0;s<6;s++)this.fading.add(new bs(i));return[this.ellipsoid,this.force,this.handle,this.spot,this.fading]}draw(t,e,i){let s=i==="dark",r=!this.body;(this.arm!==t.arm||this.dark!==s)&&this.build(t.arm,s);let{frames:a}=e;if(this.frames=a,this.body.pose(a),this.tintJoints(t),this.drawAxis(a[t.highlightedRow]),this.drawFrames(a,t.frames),this.ellipsoid.visible=t.view==="jacobian",this.ellipsoid.visible){let l=.15*this.size/Math.max(e.linear.values[0],1e-6);this.ellipsoid.pose(a.at(-1).o,e.linear,l,.003*this.size)}this.drawForce(a.at(-1).o,t),this.drawPath(t),this.drawGhosts(t,e),this.drawReference(t),this.drawBarrier(a.at(-1).o,t.hold),this.drawFading(a.at(-1).o,t.hold?.fading??[]),this.drawMark(t.mark),r&&this.fit(),this.figure.request()}tintJoints({highlightedRow:t,q:e,arm:i}){let s=dt(i).filter((o,a)=>Qn(i.rows[o],e[a])),r=[t,...s].join();this.shown.tinted!==r&&(this.shown.tinted=r,this.body.tint(o=>o===t?this.tints.highlight:s.includes(o)?this.tints.bad:null))}drawAxis(t){let e=t?Ut(.16*this.size,t.z):[0,0,0],[i,s]=t?[Rt(t.o,e),Yt(t.o,e)]:[e,e];Ro(this.axis,i,s,.0025*this.size)}drawFrames(t,e){let i=.1*this.size,s=new Map;this.drawn=t.map((r,o)=>e==="all"||o===0||o===t.length-1),this.triads.pose(t,i,this.drawn),t.forEach((r,o)=>{if(this.drawn[o])for(let a of["x","z"]){let l=Yt(r.o,Ut(1.22*i,r[a])),c=a+l.map(u=>Math.round(u/this.size*500)).join(),h=[...s.get(c)?.indices??[],o+this.first];s.set(c,{tip:l,root:r.o,letter:a,index:h.join(",")})}}),this.labels.set([...s.values()].reverse())}drawForce(t,{view:e,wrench:i}){let s=i.slice(0,3),r=e==="torque",o=Xt(s),a=o?Ut(Md*this.size/(o+bd),s):[0,0,0];this.force.point(Rt(t,a),a,.007*this.size),this.force.visible&&=r,this.handle.visible=r,this.handle.position.fromArray(Rt(t,a)),this.tip=t,r&&!this.shown.force&&this.fit(),this.shown.force=r}forceFrom(t){let e=Rt(this.tip,t),i=Math.min(Xt(e),Md*this.size*(100/(100+bd)));if(i<.015*this.size)return[0,0,0];let s=bd*i/(Md*this.size-i);return Ut(s/Xt(e),e)}drawPath(t){let{view:e,trace:i}=t,s=["trace","torque","homework"].includes(e)?i:null,r=e==="homework"?t.tipPaths:null;this.shown.path===s&&this.shown.tipPaths===r||(Object.assign(this.shown,{path:s,tipPaths:r}),Tc(this.path),(s||r)&&this.path.add(...this.waysOfTip(t,s,r)))}waysOfTip({arm:t,wantedPath:e},i,s){let{size:r,look:o}=this,a=i?.map(h=>Ot(t,h).at(-1).o)??s[0]?.points??[],l=s?s.map(h=>fr(h.points,.003*r,h.colour)):[fr(a,.0035*r,o.path)];e?.length>i?.length&&l.push(fr(e,.0018*r,o.wantedPath));let c=m0(o.ghost,this.dark?.16:.1);return a.length>2&&l.push(xg(e??a,c)),l.filter(Boolean)}drawGhosts(t,e){let{view:i,branches:s,q:r,highlightedBranch:o}=t,a=Gc(t,e)&&o===null,l=i==="branches"&&!a?s:null;this.shown.branches!==l&&this.ghostArms(t.arm,l),this.ghosts.children.forEach((c,h)=>{c.visible=!ls(l.list[h].q,r),c.pose(c.userData,h===o?.97:.3)})}ghostArms(t,e){Tc(this.ghosts),(e?.list??[]).forEach(({q:i},s)=>{let r=new ri({color:Dn(s),roughness:.7}),o=new dr(t,{link:r,joint:r,ghost:!0});o.userData=Ot(t,i),this.ghosts.add(o)}),this.shown.branches=e,e&&!this.shown.fitted&&this.fit(),this.shown.fitted=!!e}drawReference({view:t,reference:e,q:i,arm:s}){let o=t==="table"&&e&&e!==s&&dt(e).length===i.length?e:null;if(this.shown.reference!==o&&(Tc(this.reference),this.shown.reference=o,o)){let a=yg(this.look.ghost,.26);this.reference.add(new dr(o,{link:a,joint:a,ghost:!0}))}o&&this.reference.children[0].pose(Ot(o,i))}drawFading(t,e){this.fading.children.forEach((i,s)=>{let r=e[Math.floor(s/2)],o=s%2?-this.size:this.size,a=r?Ut(o*(.04+.1*s0(r)),r.way):[0,0,0];i.point(r?Yt(t,Ut(.03*o,r.way)):t,a,.004*this.size)})}drawMark(t){this.spot.visible=!!t,this.shown.mark!==t&&(this.shown.mark=t,t&&this.spot.position.fromArray(t),t&&this.fit())}drawBarrier(t,e){let i=e?.target?Xt(Rt(e.target,t)):0,{barrier:s}=this;if(s.visible=i>.004*this.size&&!e.moving,!s.visible)return;let r=new I(...Rt(e.target,t)).normalize();Ro(s.way,t,e.target,.002*this.size),s.spot.position.set(...e.target),s.wallPart.position.set(...Yt(t,Ut(.006*this.size,r.toArray()))),s.wallPart.quaternion.setFromUnitVectors(new I(0,0,1),r)}fit(){let t=.13*this.size,e=this.frames.flatMap(({x:r,z:o,o:a})=>[a,...[r,o].map(l=>Yt(a,Ut(t,l)))]),i=(this.shown.branches?.list??[]).flatMap(({q:r})=>Ot(this.arm,r).map(o=>o.o)),s=[this.handle,this.spot].filter(r=>r.visible).map(r=>r.position.toArray());this.figure.fit([...e,...i,...s,[0,0,0],[0,0,.3*this.size]])}cameraAxes(){return[0,1,2].map(t=>new I().setFromMatrixColumn(this.figure.camera.matrixWorld,t).toArray())}place(){let{width:t,height:e}=this.figure;this.labels.host.hidden=!1,this.labels.place(i=>this.figure.pixel(i),t,e),this.frames&&this.onPlace(this.figure.pixel(this.frames.at(-1).o))}grips(){return[...this.frames.flatMap(({o:e,x:i},s)=>{if(!this.drawn[s]||s===0)return[];let[r,o]=[.05,.1].map(a=>Yt(e,Ut(a*this.size,i)));return[{row:s-1,from:r,to:o}]}),..._r(this.arm,this.frames)]}findLinkAt(t,e=14,i=_r(this.arm,this.frames)){return d0(i,t,e,s=>this.figure.pixel(s))}findBranchAt(t){return this.ghosts.children.flatMap(({visible:i,userData:s},r)=>{let o=i&&this.findLinkAt(t,7,_r(this.arm,s));return o?[{way:r,gap:o.gap}]:[]}).sort((i,s)=>i.gap-s.gap)[0]?.way??null}dispose(){this.labels.dispose(),this.world&&ws(this.world),this.figure.dispose()}};function dT(n,t){let e=new ri({color:t.link,roughness:.45,metalness:.02}),i=new ri({roughness:.4,metalness:.1});return new dr(n,{link:e,joint:i,hue:new kt(t.joint)})}function fT(n,t){let e=Po(4*n,new oo({opacity:t.shadow}));return e.receiveShadow=!0,e.position.z=-.001*n,e}function pT(n,t){let e=new Ce,i=new un({color:t.bad}),s=Po(.16*n,m0(t.bad,.3)),[r,o]=[sd(i),wc(i)];return o.scale.setScalar(.01*n),Object.assign(e,{wallPart:s,way:r,spot:o,visible:!1}),e.add(s,r,o),e}var m0=(n,t)=>new un({color:n,transparent:!0,opacity:t,side:rn,depthWrite:!1});var[wd,x0]=[480,320],mT=.81,gT=[.6816,.7317,0],xT=[-.2514,.2342,.9391],g0={x:"#D55E00",y:"#009E73",z:"#0072B2"};function _0({arm:n,trace:t,frames:e},{frames:i},s){let r=Rs(n),a=i.filter((f,x)=>e==="all"||x===0||x===i.length-1).flatMap(f=>Object.entries(g0).map(([x,m])=>{let g=Yt(f.o,Ut(.1*r,f[x]));return{points:[f.o,g],width:2.5,colour:m}})),l=_r(n,i).map(({from:f,to:x})=>[f,x]),c=dt(n).map(f=>{let x=Ut(.05*r,i[f].z);return[Rt(i[f].o,x),Yt(i[f].o,x)]}),h=t?.map(f=>Ot(n,f).at(-1).o)??[],u=_T([...l.flat(),...a.flatMap(({points:f})=>f),...h]),d=(f,x,m="currentColor",g="round")=>f.map(y=>yT(y.map(u),{width:x,colour:m,ends:g})),p=(f,x)=>mn("g",{opacity:f},...x);return mn("svg",{viewBox:`0 0 ${wd} ${x0}`,width:wd,class:"still",role:"img","aria-label":s},p(.35,d(l,10)),p(.75,d(c,12,"currentColor","butt")),...d(h.length?[h]:[],2.5,g0.x),...a.flatMap(({points:f,width:x,colour:m})=>d([f],x,m)))}function _T(n){let t=a=>[he(gT,a),-he(xT,a)],e=n.map(t),i=[0,1].map(a=>{let l=e.map(c=>c[a]);return[Math.min(...l),Math.max(...l)]}),s=[wd,x0],r=i.map(([a,l],c)=>mT*s[c]/Math.max(l-a,1e-9)),o=Math.min(...r);return a=>t(a).map((l,c)=>s[c]/2+o*(l-(i[c][0]+i[c][1])/2))}function yT(n,{width:t,colour:e,ends:i}){let s=n.map(o=>o.map(a=>a.toFixed(1)).join(",")).join(" ");return mn("polyline",{points:s,...{fill:"none",stroke:e,"stroke-width":t,"stroke-linecap":i,"stroke-linejoin":"round"}})}var vT="Picture of the arm. Arrow keys turn the view, plus and minus bring it nearer and farther, 0 fits it. The button at the tip moves the tip; the sliders turn the joints.",bT="Arrow keys move the tip across the picture, Page keys to and fro.",MT="The browser took the picture’s graphics away; it comes back when it can.",wT="No WebGL in this browser: a drawing follows.",ST={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.1],ArrowDown:[0,.1],"+":[0,0,.9],"=":[0,0,.9],"-":[0,0,1.1]},TT=.06;function Hc(n,t){let{goTo:e,id:i,announce:s=()=>{},signal:r}=t,{isGrabbable:o=!0,hasTipBar:a=!0,first:l=0}=t,c=y=>{!m||!c0(m,n,y)||s(()=>Mh(n.state.hold))},h=AT(i,IT(n,a),c),{paper:u,grip:d,hold:p,why:f}=h,x=C("div.stage",{tabindex:0,role:"application","aria-label":vT});x.append(...Object.values({...h,hold:p.root}));let m=CT(x,h,l);m&&o&&a0(m,n,{grip:d,goTo:e}),x.addEventListener("dblclick",()=>m?.fit()),x.addEventListener("keydown",y=>{y.target===x&&PT(m,y.key)&&y.preventDefault()});let g=()=>ET(u,n);return g(),m&&addEventListener("beforeprint",g,{signal:r}),{root:x,picture:m,draw(y,S,w){m?m.draw(y,S,w):g()},update(y){p.update(y);let S=y.view!=="torque"||y.wrench.slice(0,3).some(Boolean);d.hidden=!o||!m||!dt(y.arm).length||!S;let w=Mh(y.hold);Pt(f,w),f.hidden=!w},fit:()=>m?.fit(),dispose:()=>m?.dispose()}}function ET(n,{state:t,derived:e}){n.replaceChildren(_0(t,e,RT(t)),C("slot"))}var AT=(n,t,e)=>({paper:C("div.paper"),labels:C("div.labels",{"aria-hidden":"true",hidden:!0}),grip:C("button.grip",{"aria-label":"Tip","aria-describedby":`${n}-grip`,onkeydown:e,title:"Drag the tip: the joints follow. Arrow keys move it too."}),help:C("span.hidden",{id:`${n}-grip`},bT),hold:t,why:C("p.why",{"aria-hidden":"true"}),lost:C("p.lost",{hidden:!0},MT)});function RT({arm:n,q:t,unit:e}){let i=dt(n).map((s,r)=>`q_${s+1} = ${gn(n.rows[s],t[r],e)}`);return`Still picture of the ${n.name}${i.length?` at ${i.join(", ")}`:""}.`}function CT(n,{labels:t,grip:e,hold:i,lost:s},r){try{let o=new Vc(n,t,{first:r,onLost:a=>s.hidden=!a,onPlace:([a,l])=>{e.style.transform=`translate(${a}px, ${l}px)`,n.classList.add("drawn")}});return o.figure.foot=()=>i.root.offsetHeight+40,o}catch{return n.setAttribute("role","group"),n.setAttribute("aria-label","Picture of the arm"),n.removeAttribute("tabindex"),i.root.hidden=!0,Pt(s,wT),s.hidden=!document.defaultView,null}}function PT(n,t){let e=ST[t];return t==="0"?n?.fit():e&&n?.figure.orbit(...e),t==="0"||!!e}function IT(n,t){let e=(c,h,u)=>C("button",{title:h,onclick:u},c),i=e("Keep direction","A dragged tip keeps the direction of the tool too",()=>n.dispatch({type:"setFields",keepOrientation:!n.state.keepOrientation})),r=e("Pin the tip","Hold the tip where it is, and drag the elbow through what is left",()=>LT(n)),o=[-1,1].map(c=>{let d={"aria-label":`Swing ${c<0?"one":"the other"} way`,onclick:()=>OT(n,c)};return C("button.swing",d,c<0?"↺":"↻")}),a=C("div.hold",{role:"group","aria-label":"The tip"},i,r,o);a.hidden=!t;function l({keepOrientation:c,hold:h,arm:u}){let d=!!h?.pinned;oe(i,"aria-pressed",String(c)),i.hidden=Ae(u)<6,oe(r,"aria-pressed",String(d)),Pt(r,d?NT(h):"Pin the tip"),o.forEach(p=>p.hidden=!d||!h.free)}return{root:a,update:l}}function LT(n){let{state:t,derived:e}=n,i=dt(t.arm).length>6||t.keepOrientation&&Ae(t.arm)===6,s={pinned:e.frames.at(-1),turns:i,free:DT(n,i)};n.dispatch({type:"setFields",hold:t.hold?.pinned?null:s})}var NT=({free:n,turns:t})=>{let e=t?"place and direction":"place";return n?`Tip pinned (${e}): drag the elbow`:`Tip pinned (${e}): nothing is free`},y0=({derived:n},t)=>n.columns.map(e=>e.slice(0,t?6:3)),DT=(n,t)=>ti(y0(n,t)).length;function OT(n,t){let{arm:e,q:i,hold:s}=n.state;if(!s?.pinned)return;let[r]=ti(y0(n,s.turns));if(!r)return;let[o]=[...r].sort((h,u)=>Math.abs(u)-Math.abs(h)),a=t*Math.sign(o),l=i.map((h,u)=>h+a*TT*r[u]),c=gi(e,l,s.pinned,{rows:s.turns?6:3});n.dispatch({type:"moveJoints",q:c.q,hold:s,gesture:"swing"})}var FT=6,v0=0;function Wc(n,t,e,...i){let s=C("div.rail",{},n,...i),r=(u,d,p)=>u.addEventListener(d,p,{signal:e});r(n,"input",()=>t(Number(n.value),`keys ${n.ariaLabel}`));let o=null,a=()=>Number(n.max)-Number(n.min),l=()=>Math.max(1,s.clientWidth-16),c=u=>t(Math.min(Number(n.max),Math.max(Number(n.min),u)),`drag ${v0}`),h=u=>{v0+=1,Object.assign(o,{on:!0,x:u.clientX}),s.setPointerCapture(u.pointerId)};return r(s,"pointerdown",u=>{if(u.button||o||(o={id:u.pointerId,x:u.clientX,from:Number(n.value),on:!1},n.focus({preventScroll:!0}),u.pointerType!=="mouse"))return;u.preventDefault(),h(u);let d=(u.clientX-s.getBoundingClientRect().left-8)/l(),p=(o.from-Number(n.min))/a();Math.abs(d-p)*l()<11||(o.from=Number(n.min)+d*a(),c(o.from))}),r(s,"pointermove",u=>{u.pointerId===o?.id&&(!o.on&&Math.abs(u.clientX-o.x)<FT||(o.on||h(u),c(o.from+a()*(u.clientX-o.x)/l())))}),r(s,"pointerup",()=>o=null),r(s,"pointercancel",()=>{o?.on&&c(o.from),o=null}),s}var b0=typeof matchMedia>"u"?null:matchMedia("(prefers-color-scheme: dark)");function UT(){let{dataset:n}=document.documentElement;if(n.theme)return n.theme==="dark"?"dark":"light";let t=document.body.dataset.jpThemeLight;if(t)return t==="true"?"light":"dark";let{classList:e}=document.body;return e.contains("vscode-dark")||e.contains("vscode-high-contrast")?"dark":e.contains("vscode-light")||!b0?.matches?"light":"dark"}function $c(n,t){let e,i=()=>{let r=UT();r!==e&&n(e=r)},s=new MutationObserver(i);s.observe(document.documentElement,{attributes:!0,attributeFilter:["data-theme"]}),s.observe(document.body,{attributes:!0,attributeFilter:["class","data-jp-theme-light"]}),b0?.addEventListener("change",i,{signal:t}),t.addEventListener("abort",()=>s.disconnect()),i()}var yr=n=>Ps(n,0),kT=0;function kn(n,t,e){let{state:i={},isGrabbable:s=!0,message:r,side:o=[],first:a=0}=e,l=new AbortController,{signal:c}=l,{arm:h}=t,u=new Ss(zc({arm:h,q:t.q??Oi(h),...i})),d=n.shadowRoot??n.attachShadow({mode:"open"}),p=Hc(u,{signal:c,first:a,isGrabbable:s,hasTipBar:!1,id:`figure-${++kT}`,goTo:M=>u.dispatch({type:"glide",q:M})}),f=C("p.words"),x=(t.joints??[]).map(M=>BT(u,M,c)),m=C("div.side",{},...o,...x.map(M=>M.root),f),g=C("figure.live",{},p.root,m);d.replaceChildren(C("style",{},Uc,h0),g);let y="light",S=[];function w(){let{state:M,derived:O}=u;for(let N of x)N.show(M);Pt(f,r(M,O)),p.draw(M,O,y),p.update(M);for(let N of S)N(M,O)}$c(M=>{y=M,g.dataset.theme=M,w()},c),u.listen(w,c);let{picture:A}=p;return{store:u,picture:A,card:g,signal:c,refresh:w,follow:M=>(S.push(M),w()),dispose:()=>(l.abort(),p.dispose(),d.replaceChildren())}}function BT(n,t,e){let{arm:i}=n.state,s=dt(i).indexOf(t-1),r=i.rows[t-1],o=(h,u)=>n.dispatch({type:"moveJoints",q:xn(n.state.q,s,h),gesture:u}),a=Gn(`Joint ${t}`,Rn(r)),{root:l,show:c}=M0(Se("q",t),a,o,e);return{root:l,show:({q:h,unit:u})=>c(h[s],gn(r,h[s],u),ta(r,h[s],u))}}function Oo(n,t,e,{put:i,text:s,signal:r}){let o=Gn(n,t),{root:a,show:l}=M0(n,o,h=>c(h),r),c=h=>(l(h,s(h)),i(h));return l(e,s(e)),{root:a,move:c}}function M0(n,t,e,i){let s=C("output"),r=(o,a,l=a)=>{t.value=String(o),oe(t,"aria-valuetext",l),Pt(s,a)};return{root:C("div.lever",{},C("span",{},n),Wc(t,e,i),s),show:r}}function w0(n,t){let e=kn(n,t,{message:u=>`The tip stays; ${dt(u.arm).map((p,f)=>`q${p+1} ${gn(u.arm.rows[p],u.q[f],"deg")}`).join(", ")}.`}),{store:i}=e,s=i.derived.frames.at(-1);i.dispatch({type:"setFields",hold:{pinned:s,turns:!0,free:1}});let r=zT(i.state.arm,i.state.q,s),o=r.findIndex(u=>u===i.state.q),a=u=>{let d=r[Math.max(0,Math.min(r.length-1,Math.round(u)))];i.dispatch({type:"moveJoints",q:d,hold:i.state.hold,gesture:"swing"})},l=u=>yr(r[Math.round(u)]?.[2]-r[o][2]),{signal:c}=e,h=Oo("elbow",[0,r.length-1],o,{put:a,text:l,signal:c});return e.card.querySelector(".side").prepend(h.root),e.dispose}function zT(n,t,e){let i=s=>{let r=[],[o,a]=[t,null];for(let l=0;l<80;l++){let[c]=ti(We(n,Ot(n,o)));if(!c)break;let h=a?c.reduce((f,x,m)=>f+x*a[m],0):s*c[2],u=c.map(f=>h<0?-f:f),d=o.map((f,x)=>f+.03*u[x]),p=gi(n,d,e).q;if(dt(n).some((f,x)=>Qn(n.rows[f],p[x])))break;r.push(p),[o,a]=[p,u]}return r};return[...i(-1).reverse(),t,...i(1)]}var GT="only the entries with its angle move; the last column goes round on a circle of radius a.",VT=n=>n.map(t=>At(1e3*t,0)).join(", ");function HT(n,t){let e=(i,{frames:s})=>{let r=`The tip is at (${VT(s.at(-1).o)}) mm.`;return`${t.words??"Drag a link, or the tip."} ${r}`};return kn(n,t,{state:{frames:t.frames??"ends"},message:e}).dispose}function WT(n,t){let e=t.row??1,i=4,s=kn(n,t,{isGrabbable:!1,first:e-1,state:{frames:"all"},message:({arm:c})=>$T(c.rows[0],i)}),r=s.store.state.arm.rows[e-1],l=Oo("motions",[0,4],4,{put:c=>{i=c;let h=[XT(r,c,t)];s.store.dispatch({type:"selectArm",arm:{name:`Row ${e}`,home:[],rows:h},q:[]})},text:c=>`${At(c,1)} of 4`,signal:s.signal});return s.card.querySelector(".side").prepend(l.root),l.move(4),s.picture?.fit(),s.dispose}function $T({theta:n,d:t,a:e,alpha:i},s){let r=[t,e].map(a=>`${At(1e3*a,0)} mm`),o=[`turn by θ about z (${yr(n)})`,`slide by d along z (${r[0]})`,`slide by a along x (${r[1]})`,`turn by α about x (${yr(i)})`].slice(0,Math.ceil(s));return o.length?`${o.join(", then ")}.`:"The frame before the row."}function XT(n,t,{angle:e=.7}){let i=a=>Math.min(1,Math.max(0,t-a)),s=n.theta+(n.kind==="revolute"?e:0),r=n.d+(n.kind==="prismatic"?.3:0);return{kind:"fixed",...{theta:i(0)*s,alpha:i(3)*n.alpha},d:i(1)*r,a:i(2)*n.a}}function qT(n,t){let e=t.row??1,i=Fc("A",`A ${e}`),s=kn(n,{...t,joints:[e]},{state:{frames:"all"},side:[C("div.scroll",{},i.root)],message:()=>`Turn joint ${e}: ${GT}`});return s.follow(({arm:r,q:o})=>{let a=o[dt(r).indexOf(e-1)];i.update(e,Ot({rows:[r.rows[e-1]]},[a])[1])}),s.dispose}function jT(n,t){let e=dt(t.arm)[(t.column??1)-1],i=Ec(c=>c!==null&&a(c)),s=kn(n,t,{side:[i.root],message:({arm:c})=>{let h=c.rows[e].kind==="revolute"?"turns about its axis":"slides",u=`when joint ${e+1} ${h} alone`;return`Column ${dt(c).indexOf(e)+1}: the tip moves along the arrow ${u}.`}}),{store:r,picture:o}=s,a=c=>{e=c,r.dispatch({type:"setFields",highlightedRow:c}),s.refresh()},l=o&&new bs(o.force.shaft.material);return s.follow(({arm:c},h)=>{if(i.update({arm:c,highlightedRow:e},h.columns),!l||!o.world)return;l.parent!==o.world&&o.world.add(l);let u=h.columns[dt(c).indexOf(e)],d=Ut(.3,u.slice(0,3));l.point(h.frames.at(-1).o,d,.008*o.size)}),a(e),s.dispose}function YT(n,t){return kn(n,t,{state:{view:"jacobian"},message:(i,s)=>`Half axes ${s.linear.values.map(o=>At(o,2)).join(", ")}. ${Tr(s).text}`}).dispose}function JT(n,t){let e=C("div.bars"),i=kn(n,t,{state:{view:t.push?"torque":"pose",wrench:t.wrench??[0,0,0,0,0,0]},side:[e],message:({arm:r},{torque:o})=>{let a=o.map(Math.abs),l=a.indexOf(Math.max(...a)),c=`${At(o[l],1)} N m`,h=`joint ${dt(r)[l]+1}: ${c}`;return`${t.words??"Move the arm."} The most is asked of ${h}.`}}),s=dt(i.store.state.arm).map(ZT);return e.replaceChildren(...s.map(r=>r.root)),i.follow(({arm:r},{torque:o})=>{let a=Math.max(...dt(r).map(l=>r.rows[l].effort??50));s.forEach((l,c)=>l.show(o[c],a))}),i.dispose}function ZT(n){let[t,e]=[C("span.fill"),C("span")],i=C("span",{},Se("τ",n+1)),s=(r,o)=>{let a=Math.max(-1,Math.min(1,r/o)),[l,c]=[50+50*Math.min(0,a),50*Math.abs(a)];Object.assign(t.style,{left:`${l}%`,width:`${c}%`}),Pt(e,`${At(r,1)} N m`)};return{root:C("div.bar",{},i,C("span.track",{},t),e),show:s}}function KT(n,t){let[e,i,s]=[null,0,.1],r=kn(n,t,{isGrabbable:!1,state:{view:"trace",highlightedRow:t.lit?t.lit-1:null},message:({arm:m})=>e?QT(m,e,s):"Computing …"}),{store:o}=r,a=o.state.q,l=()=>{let{path:m}=e,g=Math.round(i*(m.length-1));o.dispatch({type:"replaceState",trace:m,q:m[g]})},c=Ls("run"),h=()=>c({arm:o.state.arm,q:a,run:{method:"exact",steps:180,radius:s}},m=>{r.signal.aborted||(e=m,l(),r.refresh())}),u=(m,g,y,S,w)=>Oo(m,g,y,{put:S,text:w,signal:r.signal}).root,p=u("round",[0,1],0,m=>(i=m,e&&l()),m=>`${At(100*m,0)} %`),x=u("radius",[.01,.1],s,m=>(s=m,h()),m=>`${At(100*m,1)} cm`);return r.card.querySelector(".side").prepend(...t.fixed?[p]:[x,p]),h(),r.dispose}function QT(n,{failedStep:t,windings:e},i){let s=`Radius ${At(100*i,1)} cm`;if(t!==null)return`${s}: no run gets round; the arm would have to pass a singular pose.`;let r=dt(n).flatMap((a,l)=>Math.abs(e[l])>.9?[`joint ${a+1}`]:[]);return`${s}: ${r.length?`${je(r)} wind once round`:"the joints swing and come back"}.`}function tE(n,t){let e=C("div.row",{role:"radiogroup","aria-label":"Ways"}),i=kn(n,t,{state:{view:"branches"},side:[e],message:({arm:o,branches:a})=>a?ca(o,a):"Computing …"}),{store:s}=i,r=!1;return pa("branches",{arm:s.state.arm,q:s.state.q}).then(o=>{if(r)return;s.dispatch({type:"setBranches",arm:s.state.arm,branches:o});let a=({q:l},c)=>{let h=`border-left: 6px solid ${Dn(c)}`,u=()=>s.dispatch({type:"glide",q:l});return C("button",{role:"radio","aria-label":`Way ${c+1}`,style:h,onclick:u},`${c+1}`)};e.replaceChildren(...o.list.map(a)),i.refresh()}),i.follow(({q:o,branches:a})=>{[...e.children].forEach((l,c)=>{let h=a?.list[c]?.q.every((u,d)=>Math.abs(u-o[d])<.001);l.setAttribute("aria-checked",String(!!h))})}),()=>(r=!0,i.dispose())}function eE(n,t){let i=kn(n,t,{message:({arm:o,q:a},{frames:l})=>{let c=Xt(Rt(l.at(-1).o,l[1].o)),[h,u]=[o.rows[1].a,o.rows[2].a],d=(c*c-h*h-u*u)/(2*h*u),p=`Shoulder to tip ${At(1e3*c,0)} mm`,f=yr(a[2]);return`${p}, so D = ${At(d,3)} and θ₃ = ${f}; its cosine is D.`}}),{picture:s}=i,r=[];return i.follow((o,{frames:a})=>{s?.world&&(r.forEach(ws),r=nE(a.slice(1).map(l=>l.o)).filter(([l,c])=>Xt(Rt(l,c))>.001).map(([l,c,h])=>{let u=Yt(Ut(.5,l),Ut(.5,c));return fr([l,u,c],.003*s.size,Dn(h))}),r.forEach(l=>s.world.add(l)))}),i.dispose}function nE([n,t,e]){let i=[e[0],e[1],n[2]];return[[n,e,0],[n,i,2],[i,e,2],[n,t,1],[t,e,1]]}var Sd={columns:jT,ellipsoid:YT,hand:HT,loads:JT,matrix:qT,row:WT,swing:w0,triangles:eE,ways:tE,winds:KT};var S0=`:host {
  margin: 1.6rem 0;
}
dl,
dd,
ol {
  margin: 0;
  padding: 0;
}
/* Head */
header {
  display: flex;
  flex-wrap: wrap;
  align-items: center;
  gap: 6px 12px;
  padding: 9px 12px 9px 16px;
  border-bottom: 1px solid var(--line);
}
.name {
  font-size: 15px;
  font-weight: 600;
  color: var(--ink);
}
select.name {
  margin-left: -8px;
  min-width: 0;
  max-width: 17rem;
  text-overflow: ellipsis;
}
.buttons {
  display: flex;
  flex-wrap: wrap;
  gap: 4px;
  margin-left: auto;
}
.pair {
  display: flex;
}
.pair button {
  border-radius: 7px 0 0 7px;
}
.pair button + button {
  border-radius: 0 7px 7px 0;
  margin-left: -1px;
}
button:hover:not(:disabled) {
  background: var(--raised);
  border-color: var(--soft);
}
button:disabled {
  opacity: 0.4;
  cursor: default;
}
button.main {
  background: var(--accent);
  border-color: var(--accent);
  color: var(--on-accent);
  font-weight: 600;
  padding-inline: 14px;
}
button.main:hover:not(:disabled) {
  background: color-mix(in srgb, var(--accent) 86%, var(--ink));
}
[aria-invalid="true"] {
  border-color: var(--bad) !important;
  background: var(--bad-ground) !important;
}
/* Picture and sliders */
.notice {
  padding: 8px 16px;
  background: var(--bad-ground);
  color: var(--bad);
  border-bottom: 1px solid var(--line);
}
.bench {
  display: contents;
}
.stage {
  position: sticky;
  top: 56px;
  z-index: 2;
  height: clamp(210px, 38vh, 420px);
  overflow: hidden;
  background: radial-gradient(120% 90% at 50% 35%, var(--ground) 30%, var(--raised));
}
.stage:focus-visible {
  outline-offset: -3px;
}
.grip:hover:not(:disabled),
.grip:active {
  background: color-mix(in srgb, var(--accent) 14%, transparent);
  border-color: var(--accent);
}
.stage:hover .grip,
.stage:focus-within .grip {
  border-color: color-mix(in srgb, var(--accent) 60%, transparent);
}
.hold {
  position: absolute;
  left: 10px;
  bottom: 8px;
  display: flex;
  flex-wrap: wrap;
  gap: 4px;
}
.hold button {
  font-size: 12px;
  padding: 1px 8px;
  background: color-mix(in srgb, var(--ground) 82%, transparent);
}
.hold button[aria-pressed="true"] {
  background: color-mix(in srgb, var(--accent) 22%, var(--ground));
}
.sliders {
  display: flex;
  flex-direction: column;
  gap: 5px;
  padding: 12px 14px;
  border-top: 1px solid var(--line);
}
.joint {
  display: grid;
  grid-template-columns: 24px minmax(0, 1fr) 92px;
  align-items: start;
  gap: 8px;
  padding: 1px 4px;
  border-radius: 7px;
}
.joint.lit {
  background: color-mix(in srgb, var(--accent) 11%, transparent);
}
.joint .label {
  line-height: 28px;
  font-size: 16px;
}
.rail {
  padding-top: 5px;
}
.bounds {
  display: flex;
  justify-content: space-between;
  font-size: 10.5px;
  line-height: 1.2;
  color: var(--soft);
  min-height: 13px;
}
.past .bounds .past {
  color: var(--bad);
  font-weight: 600;
}
.joint .value {
  width: 92px;
  text-align: right;
  padding: 0 7px;
}
.joint.past .value {
  color: var(--bad);
  border-color: var(--bad);
}
/* Tabs */
.views {
  border-top: 1px solid var(--line);
}
.tabs {
  display: flex;
  overflow-x: auto;
  padding: 0 8px;
  border-bottom: 1px solid var(--line);
  background: var(--raised);
  scrollbar-width: thin;
}
.tabs button {
  flex: none;
  border: 0;
  border-bottom: 2px solid transparent;
  border-radius: 0;
  background: none;
  padding: 8px 10px 7px;
  color: var(--soft);
  white-space: nowrap;
}
.tabs button:hover {
  color: var(--ink);
  background: none;
}
.tabs button[aria-selected="true"] {
  color: var(--ink);
  font-weight: 600;
  border-bottom-color: var(--accent);
}
.tabs button:focus-visible {
  outline-offset: -4px;
}
.view {
  padding: 14px 16px 16px;
}
.view > div > * + .row,
.row + *,
.scroll + *,
.error + * {
  margin-top: 10px;
}
.right {
  margin-left: auto;
}
.words {
  color: var(--soft);
}
.verdict,
.error {
  font-size: 13.5px;
}
.verdict.warning,
.error {
  color: var(--bad);
  font-weight: 600;
}
.error:empty {
  display: none;
}
/* Pose */
.pose {
  display: flex;
  flex-wrap: wrap;
  align-items: center;
  gap: 12px 28px;
}
.pose .words {
  flex: 1 1 220px;
}
.pose .wrench label {
  display: flex;
  align-items: center;
  gap: 5px;
}
.pose .wrench input {
  width: 74px;
}
/* Jacobian */
.jacobian {
  display: grid;
  gap: 14px 20px;
  grid-template-columns: minmax(0, 1fr);
}
.facts {
  display: grid;
  grid-template-columns: auto auto;
  justify-content: start;
  gap: 1px 14px;
  margin-block: 8px;
  font-size: 13px;
}
.facts dt {
  color: var(--soft);
}
/* Torque */
.wrench {
  display: flex;
  flex-wrap: wrap;
  align-items: end;
  gap: 6px 8px;
  border: 0;
  padding: 0;
  margin: 0 0 8px;
  min-width: 0;
}
.wrench legend {
  padding: 0;
  margin-bottom: 4px;
  font-size: 13px;
  color: var(--soft);
}
.wrench label {
  display: grid;
  gap: 1px;
}
.wrench input {
  width: 66px;
  text-align: right;
  padding-inline: 6px;
}
.bars {
  width: 100%;
}
.bars th,
.bars td {
  padding-block: 3px;
  border-bottom: 1px solid var(--line);
}
.bars tr:last-child > * {
  border-bottom: 0;
}
.bars thead th {
  text-align: right;
  font-size: 12px;
}
.bars thead th:first-child,
.bars thead th:last-child {
  text-align: left;
}
.bars tbody th {
  color: var(--ink);
  font-size: 15px;
}
.bars .total {
  font-weight: 600;
}
.bars .bar {
  width: 52%;
  min-width: 190px;
  text-align: left;
}
.track {
  display: inline-block;
  vertical-align: middle;
  width: calc(100% - 112px);
}
.fill {
  left: var(--from);
  width: var(--width);
}
.over .fill {
  background: var(--bad);
}
.over .total,
.over .share {
  color: var(--bad);
}
.share {
  display: inline-block;
  width: 104px;
  padding-left: 10px;
  font-size: 12px;
  color: var(--soft);
}
/* Trace */
.transport {
  flex-wrap: nowrap;
}
.transport input {
  flex: 1;
}
.place {
  min-width: 44px;
  text-align: right;
  color: var(--soft);
}
input.small {
  width: 56px;
  text-align: right;
}
.trace label {
  color: var(--soft);
  font-size: 13px;
}
.plots {
  display: grid;
  grid-template-columns: repeat(auto-fill, minmax(190px, 1fr));
  gap: 10px 18px;
  margin-top: 10px;
}
.plots figure {
  min-width: 0;
}
.plots figcaption {
  display: flex;
  gap: 8px;
  align-items: baseline;
  font-size: 12.5px;
  color: var(--ink);
}
.plots b {
  font-size: 14px;
  font-weight: 500;
}
.plots .span {
  margin-left: auto;
  font-size: 11px;
  color: var(--soft);
  white-space: nowrap;
}
.plots svg {
  display: block;
  width: 100%;
  height: 54px;
  background: var(--raised);
  border-radius: 4px;
}
.plots polyline {
  fill: none;
  stroke: var(--accent);
  stroke-width: 1.7;
  vector-effect: non-scaling-stroke;
}
.plots .past polyline {
  stroke: var(--bad);
}
.plots .beyond {
  fill: rgb(213 94 0 / 0.16);
}
.plots .cursor {
  stroke: var(--soft);
  stroke-width: 1;
  vector-effect: non-scaling-stroke;
}
/* Branches */
.left .ways {
  opacity: 0.62;
}
.ways {
  list-style: none;
  display: grid;
  grid-template-columns: 28px auto 1fr auto;
  row-gap: 6px;
  margin-top: 10px;
}
.ways li,
.ways button {
  display: grid;
  grid-column: 1 / -1;
  grid-template-columns: subgrid;
}
.ways button {
  align-items: center;
  gap: 4px 12px;
  width: 100%;
  text-align: left;
  padding: 6px 10px;
}
.ways button[aria-current="true"] {
  border-color: var(--accent);
  box-shadow: inset 0 0 0 1px var(--accent);
}
.swatch {
  width: 12px;
  height: 12px;
  border-radius: 50%;
  opacity: 0.85;
}
.ways .name {
  font-size: 13px;
}
.values {
  display: flex;
  flex-wrap: wrap;
  gap: 1px 12px;
  color: var(--soft);
  font-size: 12.5px;
}
.note {
  font-size: 12px;
  color: var(--good);
}
.note.past {
  color: var(--bad);
}
/* Table */
.entries :is(th, td) {
  padding: 2px 4px;
  text-align: left;
}
.entries input {
  width: 86px;
}
.entries tbody th {
  width: 26px;
}
.moves span {
  padding-left: 5px;
  color: var(--soft);
  white-space: nowrap;
}
.remove {
  border-color: transparent;
  padding: 0 8px;
  color: var(--soft);
}
/* Homework */
.runs {
  display: grid;
  gap: 5px;
}
.runs button {
  display: flex;
  align-items: center;
  gap: 7px;
}
.runs button[aria-checked="true"] {
  border-color: var(--accent);
  box-shadow: inset 0 0 0 1px var(--accent);
}
.levers {
  display: grid;
  grid-template-columns: repeat(auto-fill, minmax(230px, 1fr));
  gap: 6px 16px;
  align-items: center;
  font-size: 13px;
  color: var(--soft);
}
.wall svg {
  display: block;
  width: 100%;
  max-width: 300px;
  background: var(--raised);
  border-radius: 6px;
}
.wall polyline {
  fill: none;
  stroke-width: 1.8;
}
.wall .asked {
  stroke: var(--soft);
  stroke-width: 1;
  stroke-dasharray: 4 4;
}
.wall figcaption {
  font-size: 12.5px;
  color: var(--soft);
}
.homework > div {
  display: grid;
  gap: 10px;
}
.homework > div > * {
  margin-top: 0;
}
.wall {
  max-width: 300px;
}
.homework .verdict {
  min-height: 4.4em; /* what is said of a run, when it has come */
}
.homework summary {
  cursor: pointer;
  font-size: 13px;
  color: var(--soft);
}
@container (min-width: 560px) {
  .bench {
    display: grid;
    grid-template-columns: minmax(0, 1fr) minmax(250px, 40%);
  }
  .stage {
    position: relative;
    top: auto;
    height: auto;
    min-height: clamp(300px, 100vh - 440px, 520px);
  }
  .sliders {
    border-top: 0;
    border-left: 1px solid var(--line);
    justify-content: center;
    gap: 3px;
  }
}
@container (min-width: 650px) {
  .jacobian {
    grid-template-columns: auto minmax(180px, 1fr);
  }
}
/* The whole width: the picture at the left, always in view, everything else beside it. */
@container (min-width: 1060px) {
  .explorer {
    display: grid;
    grid-template: auto auto auto 1fr / minmax(0, 1.2fr) minmax(440px, 1fr);
  }
  header,
  .notice {
    grid-column: 1 / -1;
  }
  .bench {
    display: contents;
  }
  .stage {
    position: sticky;
    top: 64px;
    grid-column: 1;
    grid-row: 3 / span 2;
    align-self: start;
    height: clamp(420px, 100vh - 150px, 900px);
  }
  .sliders {
    grid-column: 2;
    grid-row: 3;
    justify-content: start;
  }
  .views {
    grid-column: 2;
    grid-row: 4;
    border-left: 1px solid var(--line);
  }
}
@media (pointer: coarse) {
  .joint .label {
    line-height: 44px;
  }
  .rail {
    padding-top: 10px;
  }
}
@container (max-width: 430px) {
  .view {
    padding-inline: 12px;
  }
  .ways {
    grid-template-columns: 28px 1fr auto;
  }
  .values {
    grid-column: 2 / -1;
    grid-row: 2;
  }
  .buttons {
    margin-left: 0;
  }
  header {
    padding-left: 12px;
    column-gap: 6px;
  }
  header button {
    font-size: 12px;
    padding-inline: 7px;
  }
  header .spare,
  .limit {
    display: none; /* a double tap fits, a phone is small enough */
  }
  select.name {
    flex: 1 0 9rem; /* beside the buttons it would have no width left */
  }
  .wrench label {
    flex: 1 1 40px;
  }
  .wrench input {
    width: 100%;
    padding-inline: 4px;
  }
  .bars th,
  .bars td {
    padding-inline: 4px;
  }
  .bars .bar {
    min-width: 0;
    width: auto;
  }
  .track {
    width: 62px;
  }
  .share {
    width: 38px;
    padding-left: 5px;
  }
  .entries input {
    width: 52px;
    padding-inline: 2px;
  }
  .entries td:nth-child(odd) input {
    width: 71px;
  }
  .entries select {
    width: 62px;
    padding-inline: 2px;
  }
  .entries th,
  .entries td {
    padding-inline: 1px;
  }
  .entries tbody th {
    width: 14px;
  }
  .entries thead th:first-child {
    font-size: 0;
  }
  .entries .moves span {
    display: none;
  }
  .remove {
    padding: 0;
    width: 24px;
  }
  .heat {
    font-size: 11.5px;
  }
  .matrix td {
    min-width: 54px;
    padding-inline: 5px;
  }
}
@media (prefers-reduced-motion: no-preference) {
  button {
    transition:
      background 0.12s,
      border-color 0.12s;
  }
}
`;function T0(n,{arms:t,link:e,goTo:i,stage:s,card:r,announce:o}){let a=t.length>1?rE(n,t,s):sE(),l=oE(n),c=aE(n),h=lE(n),u=[c.root,Ts("Home","Where this arm stands first",()=>i(Oi(n.state.arm))),Ts("Random","Somewhere within its limits",()=>i(Sh(n.state.arm))),cE(s),h.root,...e?[hE(e,o)]:[]];r.addEventListener("keydown",f=>{!(f.ctrlKey||f.metaKey)||f.key.toLowerCase()!=="z"||f.target.matches("input[type=text], textarea")&&!f.target.dataset.cell||(f.preventDefault(),n.dispatch({type:f.shiftKey?"redo":"undo"}))});let d=C("div.buttons",{role:"group","aria-label":"Settings"},u),p=[a,l,c,h];return{root:C("header",{},a.root,l.root,d),update:f=>p.forEach(x=>x.update(f))}}var Ts=(n,t,e)=>C("button",{title:t,onclick:e},n),E0=(n,t)=>oe(n,"aria-pressed",String(t));function sE(){let n=C("span.name");return{root:n,update:({arm:t})=>Pt(n,fh(t.name))}}function rE(n,t,e){let i=l=>{l&&(n.dispatch({type:"selectArm",arm:l}),e.fit())},s=C("select.name",{"aria-label":"Arm",onchange:()=>i(t[s.selectedIndex])}),r=null;function o({arm:l,base:c}){let h=l===c?null:l.name;if(r===h&&s.options.length)return;r=h;let u=t.map(d=>C("option",{value:d.name},fh(d.name)));s.replaceChildren(...u,...h?[C("option",{},h)]:[])}function a(l){let{arm:c,base:h}=l;o(l);let u=c===h?t.findIndex(d=>d.name===c.name):t.length;s.selectedIndex!==u&&(s.selectedIndex=u)}return{root:s,update:a}}function oE(n){let t=Object.entries({deg:"degrees",rad:"radians"}).map(([e,i])=>C("button",{title:i,"data-unit":e,onclick:()=>n.dispatch({type:"setFields",unit:e})},e));return{root:C("span.pair",{role:"group","aria-label":"Unit of angles"},t),update:({unit:e})=>t.forEach(i=>E0(i,i.dataset.unit===e))}}function aE(n){let t="Draw the frame of every link, or the first and the last only",e=()=>n.state.frames==="all"?"ends":"all",i=Ts("Frames",t,()=>n.dispatch({type:"setFields",frames:e()}));return{root:i,update:({frames:s})=>E0(i,s==="all")}}function lE(n){let t=Ts("↶","Undo (Ctrl+Z)",()=>n.dispatch({type:"undo"})),e=Ts("↷","Redo (Ctrl+Shift+Z)",()=>n.dispatch({type:"redo"}));return t.setAttribute("aria-label","Undo"),e.setAttribute("aria-label","Redo"),{root:C("span.pair",{role:"group","aria-label":"Undo and redo"},t,e),update({past:i,future:s}){t.disabled=!i.length,e.disabled=!s.length}}}function cE(n){let t=Ts("Fit","The whole arm into the picture",()=>n.fit());return t.className="spare",t}var hE=(n,t)=>Ts("Copy link","An address that opens this arm in this place",async({target:e})=>{e.textContent=await n.copy()?"Copied":"In the address bar",t(()=>e.textContent),setTimeout(()=>e.textContent="Copy link",1600)});var A0={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10};function R0(n,{announce:t,signal:e}){let i=C("div.sliders",{role:"group","aria-label":"Joints"}),s=C("p.error"),r=[],o={},a=uE(n,s,t);function l({arm:h,unit:u}){o.abort?.abort();let d=new AbortController;e.addEventListener("abort",()=>d.abort(),{signal:d.signal}),r=dt(h).map((f,x)=>dE(h.rows[f],{index:f,i:x,unit:u,signal:d.signal},a));let p=C("p.words",{},"No joint moves this arm.");i.replaceChildren(...r.length?r.map(f=>f.root):[p],s),o={rows:h.rows,unit:u,abort:d}}function c(h){(o.rows!==h.arm.rows||o.unit!==h.unit)&&l(h),r.forEach((u,d)=>mE(u,h.q[d],h))}return{root:i,update:c}}function uE(n,t,e){let i={put:(s,r,o=null)=>n.dispatch({type:"moveJoints",q:xn(n.state.q,s,r),gesture:o}),typed:(s,r,o,a)=>{let{unit:l,q:c}=n.state,{value:h,message:u}=ns(o,bf(r),{unit:l,whole:a});Pt(t,u&&`${o.dataset.joint} ${u}.`),u&&e(()=>t.textContent),a&&(h!==void 0&&i.put(s,h),o.value=gn(r,h??c[s],l),o.setAttribute("aria-invalid","false"))},nudge:(s,r,o)=>{let a=pE(s,r,n.state.q[o]);a!==null&&(s.preventDefault(),i.put(o,a,`keys ${o}`))},light:s=>n.state.highlightedRow!==s&&n.dispatch({type:"setFields",highlightedRow:s})};return i}function dE(n,{index:t,i:e,unit:i,signal:s},{put:r,typed:o,nudge:a,light:l}){let c=`Joint ${t+1}, ${n.kind==="revolute"?"angle":"slide"}`,h=Gn(c,Rn(n),{"data-joint":t+1,onkeydown:y=>a(y,n,e)}),u=hi(`${c}, typed`,(...y)=>o(e,n,...y),{class:"value","data-joint":c}),d=C("span.past"),p=Wc(h,(...y)=>r(e,...y),s,fE(n,d,i)),[f,x]=[()=>l(t),()=>l(null)],m={onpointerenter:f,onpointerleave:x,onfocusin:f,onfocusout:x},g=C("span.label",{},Se("q",t+1));return{root:C("div.joint",m,g,p,u),thumb:h,field:u,past:d,row:n,index:t}}function fE(n,t,e){let i=s=>C("span",{},(s??null)===null?"":Mf(n,s,e));return C("span.bounds",{},i(n.lower),t,i(n.upper))}function pE({key:n,shiftKey:t},e,i){let[s,r]=Rn(e);if(n==="Home")return s;if(n==="End")return r;if(!A0[n])return null;let o=(fi(e)?Math.PI/180:.005)*(t?.1:1);return Math.min(r,Math.max(s,i+A0[n]*o))}function mE({root:n,thumb:t,field:e,past:i,row:s,index:r},o,{highlightedRow:a,unit:l}){let[c,h]=Rn(s);n.classList.toggle("lit",a===r),t.value=String(o),oe(t,"aria-valuetext",ta(s,o,l));let[u,d]=[o,0].map(f=>100*Math.min(1,Math.max(0,(f-c)/(h-c||1))));t.style.setProperty("--low",`${Math.min(u,d).toFixed(2)}%`),t.style.setProperty("--high",`${Math.max(u,d).toFixed(2)}%`),is(e,gn(s,o,l));let p=Qn(s,o);n.classList.toggle("past",p),Pt(i,p?"past its limit":"")}var Td={};Di(Td,{build:()=>xE,title:()=>gE});var gE="IK branches",C0=({arm:n})=>`Find the ways to this ${yh(n)}`;function xE(n,{goTo:t,announce:e}){let i=C("p.verdict"),s=C("ol.ways"),r=C("button.main",{onclick:c}),o=C("div.branches",{},C("div.row",{},r),i,s),a=Ls("branches"),l;function c(){let{arm:u,q:d}=n.state;r.textContent="Looking …",a({arm:u,q:d},p=>{r.textContent=C0(n.state),n.dispatch({type:"setBranches",arm:u,branches:p}),e(()=>i.textContent,!0)})}function h(u,d){let{branches:p,unit:f,arm:x}=u;if(l?.branches!==p||l.unit!==f||l.arm!==x){let g=S=>n.dispatch({type:"setFields",highlightedBranch:S}),y=(p?.list??[]).map((S,w)=>_E(S,w,u,{goTo:t,light:g}));l?.arm!==x&&(r.textContent=C0(u)),s.replaceChildren(...y.map(S=>C("li",{},S))),l={branches:p,unit:f,arm:x,buttons:y}}let m=Gc(u,d);o.classList.toggle("left",!!m),Pt(i,vE(u,m)),l.buttons.forEach((g,y)=>{oe(g,"aria-current",String(ls(p.list[y].q,u.q)))})}return{root:o,update:h,summary:()=>i.textContent}}function _E({q:n,label:t},e,{arm:i,unit:s},{goTo:r,light:o}){let a=dt(i),l=a.flatMap((f,x)=>Qn(i.rows[f],n[x])?[f+1]:[]),c=ff(i)?"within limits":"",h=a.map((f,x)=>C("span",{},Se("q",f+1),` ${gn(i.rows[f],n[x],s)}`)),[u,d]=[()=>o(e),()=>o(null)];return C("button",{onclick:()=>r(n),...{onpointerenter:u,onpointerleave:d,onfocus:u,onblur:d}},C("span.swatch",{style:`background:${Dn(e)}`,"aria-hidden":"true"}),C("span.name",{},t?yE(t):`way ${e+1}`),C("span.values",{},h),l.length?C("span.note.past",{},`past the limit of joint ${l.join(", ")}`):C("span.note",{},c))}var yE=n=>n.split(/\b([a-z]_\d+)\b/).map((t,e)=>e%2?C("span",{},Se(...t.split("_"))):t.replace(/-$/,"−"));function vE({branches:n,arm:t},e){let i=yh(t);if(!n)return`Each way that the same ${i} can be reached is shown in a colour of its own; choose one to go there.`;let s=n.list.length>1?" Choose one, here or in the picture, to go there.":"";if(!e)return ca(t,n)+s;let r=e.far>5e-4?`${At(1e3*e.far,0)} mm from there`:"turned away from it",o=`Choose one to go back, or find the ways to this ${i}.`;return`These lead to the ${i} where the tip was before; it is now ${r}. ${o}`}var Cd={};Di(Cd,{build:()=>kE,title:()=>FE});var Fo={euler:"Euler",rk4:"Runge-Kutta 4",exact:"exact inverse kinematics",inverse:"J⁻¹",pseudo:"pseudo-inverse",damped:"damped"},Ed={"":"none",angular:"z_i in the angular rows",z_i:"z_i and o_i throughout",o_i:"o_i instead of o_i−1",sign:"rates with the wrong sign",next:"velocity of the next step"};function P0(n,t){return/^Panda/.test(t.name)&&dt(n).length===7?{...Ar}:!/^UR10e/.test(t.name)||dt(n).length!==6?null:{...Ar,locked:-1,normal:"y",seconds:20,rates:"pseudo"}}function Ad(n){return n<1e-12?"under 1e−9 mm":n<1e-5?`${wr(1e3*n,1)} mm`:`${At(1e3*n,n<.01?3:1)} mm`}var Xc=({method:n,rates:t,steps:e,gain:i,mistake:s})=>(n==="exact"?Fo.exact:`${Fo[n]}, ${Fo[t]}, N = ${e}`)+(i?`, gain ${At(i,1)}`:"")+(s?`, ${Ed[s]}`:"");function bE({failedStep:n,isSingular:t,run:e}){let i=n?`at step ${n} of ${e.steps}`:"where the run starts";return t?`J has no inverse ${i}, where the arm is singular: choose another of the rates.`:e.mistake?`With this mistake the matrix has no inverse ${i}, though the arm could go on.`:e.method==="exact"?`The circle is out of reach ${i}.`:`The run leaves all bounds ${i}.`}function ME(n){return n<1e-9?"0":n<1e-4?wr(n,1):At(n,4)}function I0(n,t){if(!n)return"Computing …";if(n.failedStep!==null)return bE(n);let e=vh(t,(h,u)=>Math.abs(n.windings[u])>.9),i=ha(t,n.path),s=e.length?` Once round: ${je(e)}.`:"",r=i.length?` Past its limits: ${je(i)}.`:"",o=`Largest error ${Ad(n.largestError)}`,a=n.run.method==="exact"?"":`, fastest joint ${At(n.fastestRate,2)} rad/s`,l=n.largestTilt>.001?`, the tool tilts by ${Ps(n.largestTilt,1)}`:"",c=`Smallest σ on the way: ${ME(n.smallestSigma)}.`;return`${o}${l}${a}. ${c}${s}${r}`}var wE=[["steps","N",!0,String,Math.round],["seconds","T",!1,n=>`${At(n,0)} s`,Math.round],["radius","Radius",!1,n=>`${At(100*n,1)} cm`,n=>Number(n.toFixed(3))],["gain","Feedback",!1,n=>`${At(n,1)} /s`,n=>Number(n.toFixed(1))]];function L0(n){let t=(f,x,m)=>Fi(f,m,g=>n({[x]:g})),e=f=>Object.fromEntries(f.map(x=>[x,Fo[x]])),i=t("Method","method",e(["euler","rk4","exact"])),s=t("Rates","rates",e(["inverse","pseudo","damped"])),r=t("Mistake","mistake",Ed),[o,a,l]=[i,s,r].map(f=>C("label",{},`${f.getAttribute("aria-label")} `,f)),c=wE.map(f=>TE(f,n)),h=C("summary"),u=[o,a,...c.map(({root:f})=>f)];function d(f){if(!f)return;i.value=f.method,s.value=f.rates,r.value=f.mistake;let x=`radius ${At(100*f.radius,1)} cm`;Pt(h,`${Xc(f)}, ${x} in ${At(f.seconds,0)} s`);for(let{key:m,root:g,show:y}of c)y(f[m]),g.hidden=SE(m,f);for(let m of[a,l])m.hidden=f.method==="exact"}let p=C("details",{},h,C("div.levers",{},u));return{mistake:l,root:p,update:d}}var SE=(n,{method:t})=>t==="exact"&&n==="gain";function TE([n,t,e,i,s],r){let o=Ch[n].map(u=>e?Math.log10(u):u),a=u=>s(e?10**Number(u.value):Number(u.value)),l=C("output"),c=Gn(t,o,{oninput:u=>Pt(l,i(a(u.target))),onchange:u=>r({[n]:a(u.target)})}),h=u=>{c.value=String(e?Math.log10(u):u),c.setAttribute("aria-valuetext",i(u)),Pt(l,i(u))};return{key:n,root:C("label.lever",{},`${t} `,c,l),show:h}}var Uo=260,EE=Array.from({length:73},(n,t)=>t/72);function N0(n){let t=30,e={role:"img","aria-label":"The wall with the runs on it"},i=mn("svg",{viewBox:`0 0 ${Uo} ${Uo}`,...e}),s=Gn("Magnify the errors",[0,3],{value:Math.log10(t),oninput:l=>(t=10**Number(l.target.value),n())}),r=C("output"),o=C("figcaption",{},C("label",{},"Errors magnified ",s,r));function a(l,c,h){Pt(r,`× ${At(t,t<10?1:0)}`);let u=Ot(l,c).at(-1).o,d=Math.max(...h.map(({run:x})=>x.radius)),p=Uo/(2.6*d),f=h.map((x,m)=>AE(x,m,{arm:l,top:u,scale:p,magnify:t}));i.replaceChildren(...f.flat())}return{root:C("figure.wall",{},i,o),draw:a}}function AE({run:n,result:t},e,{arm:i,top:s,scale:r,magnify:o}){let a=u=>{let d=Rt(u,s),p=n.normal==="x"?d[1]:-d[0],[f,x]=[Uo/2+r*p,.13*Uo-r*d[2]];return`${f.toFixed(1)},${x.toFixed(1)}`},l=EE.map(u=>a(Ui(s,n,u).o)),c=mn("polyline",{points:l.join(" "),class:"asked"});if(!t)return[c];let h=t.path.map((u,d)=>{let p=Ui(s,n,t.at[d]).o,f=Ot(i,u).at(-1).o;return a(p.map((x,m)=>x+o*(f[m]-x)))});return[c,mn("polyline",{points:h.join(" "),stroke:Dn(e)})]}var[Bo,ko]=[220,54],RE={joint:"joint values",torque:"static torques"};function qc(n){let t=Fi("What the plots show",RE,()=>o(n.state)),e=C("div.plots"),[i,s]=[[],[]];function r({arm:a,trace:l,unit:c,wrench:h}){let u=t.value==="torque",d=l&&(u?Qf(a,l,h):l),p=(x,m)=>IE(x,d.map(g=>g[m]),u?CE(a.rows[x]):PE(a.rows[x],c)),f=d?dt(a).map(p):[];i=f.map(({cursor:x})=>x),e.replaceChildren(...f.map(({figure:x})=>x))}function o(a){let{arm:l,trace:c,unit:h,wrench:u,progress:d}=a,p=[l,c,h,u,t.value];p.some((f,x)=>f!==s[x])&&r(a),s=p;for(let{line:f,value:x,textAt:m}of i)oe(f,"x1",String(d*Bo)),oe(f,"x2",String(d*Bo)),Pt(x,m(d))}return{root:e,choice:C("label.right",{},"Plots ",t),update:o}}var CE=({kind:n,effort:t})=>({letter:"τ",text:e=>`${At(e,2)} ${n==="revolute"?"N m":"N"}`,limits:[-(t??1/0),t??1/0],least:.5}),PE=(n,t)=>({letter:"q",text:e=>gn(n,e,t),limits:[n.lower??-1/0,n.upper??1/0],least:fi(n)?.1:.02});function IE(n,t,{letter:e,text:i,limits:s,least:r}){let[o,a]=s,[l,c]=[Math.min(...t),Math.max(...t)],h=Math.max((c-l)/2,r)*1.15,u=_=>ko*(.5-(_-(l+c)/2)/(2*h)),d=t.length-1,p=t.map((_,M)=>`${(M*Bo/d).toFixed(1)},${u(_).toFixed(1)}`),f=mn("line",{y1:0,y2:ko,x1:0,x2:0,class:"cursor"}),x=[...a<1/0?[D0(-1,u(a))]:[],...o>-1/0?[D0(u(o),ko)]:[]],m={viewBox:`0 0 ${Bo} ${ko}`,preserveAspectRatio:"none","aria-hidden":"true"},g=mn("svg",m,...x,mn("polyline",{points:p.join(" ")}),f),y=C("span.now"),S=C("b",{},Se(e,n+1)),w=C("span.span",{},`${i(l)} … ${i(c)}`),A=t.some(_=>_<o-1e-9||_>a+1e-9),E=C("figcaption",{},S,y,w);return{cursor:{line:f,value:y,textAt:_=>i(t[Math.round(_*d)])},figure:C(A?"figure.past":"figure",{},E,g)}}function D0(n,t){let e=Math.max(0,n),i=Math.max(0,Math.min(ko,t)-e);return mn("rect",{x:0,width:Bo,y:e,height:i,class:"beyond"})}var LE=8;function jc(n,{signal:t,makeTrace:e}){let i=d=>n.dispatch({type:"setPlaying",on:d}),s=C("button.main",{onclick:()=>DE(n,i,e)},"Play"),r=OE(d=>(i(!1),n.dispatch({type:"seek",progress:d}))),o=C("output.place"),a=C("div.row.transport",{},s,r,o),l=null,c=0;t.addEventListener("abort",()=>cancelAnimationFrame(l));function h(d){l=null;let{playing:p,progress:f}=n.state;if(!p||!a.isConnected)return;let x=1e3*LE*(Ko()?2:1),m=Math.min(1,f+Math.max(0,Math.min(100,d-c))/x);c=d,l=requestAnimationFrame(h),n.dispatch({type:"seek",progress:m}),m===1&&i(!1)}function u({playing:d,trace:p,progress:f}){Pt(s,d?"Pause":"Play"),r.disabled=!p,NE({scrub:r,place:o},f),!(!d||l)&&(c=performance.now(),l=requestAnimationFrame(h))}return{root:a,update:u}}function NE({scrub:n,place:t},e){n.value=String(Math.round(1e3*e)),n.style.setProperty("--high",`${(100*e).toFixed(1)}%`),oe(n,"aria-valuetext",`${Math.round(100*e)} percent`),Pt(t,`${Math.round(100*e)} %`)}function DE(n,t,e){let{trace:i,playing:s,progress:r}=n.state;return s?t(!1):i?(r>=1&&n.dispatch({type:"seek",progress:0}),t(!0)):e(()=>t(!0))}var OE=n=>Gn("Place along the path",[0,1e3],{step:1,value:0,oninput:t=>n(t.target.value/1e3)});var FE="Play the homework",UE="The homework’s circle is drawn by the Panda and the UR10e: choose one of them above.",kE=(n,t)=>new Rd(n,t),Rd=class{constructor(t,{announce:e,signal:i}){this.store=t,this.announce=e,this.signal=i,this.chosen=0,this.start=t.state.q,this.results=new Map,this.shown={},this.list=C("div.runs",{role:"radiogroup","aria-label":"Runs"}),this.verdict=C("p.verdict"),this.wall=N0(()=>this.drawWall()),this.plots=qc(t),this.transport=jc(t,{signal:i,makeTrace:()=>this.show()}),this.fields=L0(s=>this.edit(s)),this.root=this.laidOut()}laidOut(){return this.played=C("div",{},this.list,C("div.row",{},this.fields.mistake,this.plots.choice),this.transport.root,this.verdict,this.fields.root,this.wall.root,this.plots.root),this.others=C("p.words",{},UE),C("div.homework",{},this.played,this.others)}put(t){this.store.dispatch({type:"setFields",runs:t})}edit(t){let{runs:e}=this.store.state;this.put(e.map((i,s)=>s===this.chosen?{...i,...t}:i))}key(...t){return JSON.stringify([this.store.state.arm.rows,this.start,...t])}resultOf(t){return this.results.get(this.key(t))}async compute(){let{store:t,results:e,start:i}=this,{arm:s,runs:r}=t.state;for(let o of r.filter(a=>!e.has(this.key(a)))){let a=this.key(o);if(e.set(a,null),e.set(a,await pa("run",{arm:s,q:i,run:o})),this.signal.aborted||t.state.arm!==s)return;r===t.state.runs&&this.show()}this.show()}show(){let{store:t}=this,{runs:e,arm:i,circle:s}=t.state,r=e.map(c=>this.resultOf(c)),o=({path:c})=>c.map(h=>Ot(i,h).at(-1).o),a=r.flatMap((c,h)=>c?[{points:o(c),colour:Dn(h)}]:[]);t.dispatch({type:"setFields",tipPaths:a});let l=r[this.chosen]?.path;l?.length<2?t.dispatch({type:"setFields",trace:null}):l&&t.state.trace!==l&&t.dispatch({type:"setTrace",arm:i,circle:s,path:l,wantedPath:null}),this.lay(),this.announce(()=>this.verdict.textContent)}lay(){let{runs:t,arm:e}=this.store.state,i=t[this.chosen];this.played.hidden=!i,this.others.hidden=!!i,this.list.hidden=t.length<2,this.list.replaceChildren(...t.map((s,r)=>this.line(s,r))),this.fields.update(i),Pt(this.verdict,i?I0(this.resultOf(i),e):""),i&&this.drawWall()}line(t,e){let i={role:"radio","aria-checked":String(e===this.chosen),onclick:()=>(this.chosen=e,this.compute())},s={style:`background:${Dn(e)}`,"aria-hidden":"true"},r=`${Xc(t)}: ${BE(this.resultOf(t))}`;return C("button",i,C("span.swatch",s),C("span",{},r))}drawWall(){let{runs:t,arm:e}=this.store.state,i=t.map(s=>({run:s,result:this.resultOf(s)}));this.wall.draw(e,this.start,i)}update(t){if(this.shown.arm!==t.arm){let e=!this.shown.arm;if(this.start=t.q,this.chosen=0,this.results.clear(),this.shown={arm:t.arm},!t.runs.length||!e)return this.put([P0(t.arm,t.base)??[]].flat())}return this.shown.runs!==t.runs&&(this.shown.runs=t.runs,this.chosen=Math.max(0,Math.min(this.chosen,t.runs.length-1)),this.lay(),this.compute()),this.plots.update(this.store.state),this.transport.update(this.store.state)}summary(){return this.verdict.textContent}};function BE(n){return n?n.failedStep===null?Ad(n.largestError):"no inverse":"…"}var Vd={};Di(Vd,{build:()=>oC,title:()=>nC});var zE=["vx","vy","vz","wx","wy","wz"],GE={ẋ:"vx",ẏ:"vy",ż:"vz"},VE=/^(?:q|th(?:eta)?|tau|τ|[tgjalc]|(?:panda)?joint|link|column)$/,HE=["first","second","third","fourth","fifth","sixth","seventh"],WE=new Map([["base","shoulderpan"],["shoulder","shoulderlift"],["elbow"],["wrist1"],["wrist2"],["wrist3"]].flatMap((n,t)=>n.map(e=>[e,t+1])));function $E(n){let t=XE(n),e=zE.indexOf(t.replace("omega","w"));if(e>=0)return{kind:"row",at:e};let i=WE.get(t.replace(/joint$/,"")),s=HE.findIndex(a=>t.replace(/^the/,"").startsWith(a));if(i||s>=0)return{kind:"joint",at:i??s+1};let[,r,o]=/^(\D*)(\d{1,5})$/.exec(t)??[];return o===void 0?null:{kind:VE.test(r)?"joint":"count",at:Number(o)}}var XE=n=>Ge([...n].map(t=>GE[t]??t).join("")).toLowerCase().replace(/\(t\)|[([](?:deg|rad|nm|m)[^)\]]*[)\]]|\/(?:s|rad)$/g,"").replace(/[\s"'{}^\\*#:=()[\]|.,&_-]/g,"").replace(/deg$/,""),qE=8;function zo(n){let t=Math.max(0,n.length-qE),e=n.slice(t).flatMap((i,s)=>$E(n.slice(t+s).join(" "))??[]);return e.find(({kind:i})=>i!=="count")??e[0]??null}var Yc="[({",F0="])}",YE=`,;&|	
${"␞"}`,JE=/([A-Za-z]\w*)$/,U0=6;function ZE(n){let t=new Map,e=[];for(let i=0;i<n.length;i++){let s=n[i];if(Yc.includes(s))e.push({at:i,sign:s,parted:!1,leaf:!0});else if(F0.includes(s)&&e.length){let r=e.pop(),o=KE(n,r,i)?r.leaf?"leaf":"list":"group";t.set(r.at,o).set(i,o),e.length&&o!=="group"&&(e.at(-1).leaf=!1)}else e.length&&YE.includes(s)&&(e.at(-1).parted=!0)}return t}function KE(n,{at:t,sign:e,parted:i,leaf:s},r){let o=n[t-1]??" ",a=JE.exec(n.slice(Math.max(0,t-12),t))?.[1]??"";return a&&mr(a.toLowerCase())?!1:e==="{"?!/[\w^}]/.test(o):e==="["?!/[\w})]/.test(o)||r-t>U0:QE(n,{at:t,parted:i,leaf:s},r,o)}function QE(n,{at:t,parted:e,leaf:i},s,r){return/\w/.test(r)&&s-t<=U0?!1:e||!i||/[\s=]/.test(r)&&tA.test(n.slice(t+1,s))}var tA=/^\s*[-+]?[\d.]+(?:\s+[-+]?[\d.]+)+\s*$/;function k0(n,t,e){let i=nA(t,e),s=ZE(n),[r,o]=[0,0];for(let a=0;a<n.length;a++){let l=s.get(a);l==="group"&&(o+=Yc.includes(n[a])?1:-1);let c=l?l!=="group":eA(n[a],i);o||!c||(O0(n.slice(r,a),i),r=a+1,l?iA(i,l,Yc.includes(n[a])?1:-1):sA(i,n[a]))}return O0(n.slice(r),i),i.runs}var eA=(n,{leaves:t})=>n===`
`||n==="␞"||n===";"&&t>0,nA=(n,t)=>({isEntry:n,way:t,runs:[],run:null,words:[],above:[],name:"",named:-1,scale:"",line:0,part:0,depth:0,leaves:0});function iA(n,t,e){n.run=null,n.depth+=e,t==="leaf"&&(n.leaves+=e)}function sA(n,t){t===`
`&&n.line++,!(t!=="␞"&&n.way.wrapped&&n.leaves)&&(n.run=null,t===`
`&&aA(n))}var Pd="·factor·",B0="·columns·",z0=n=>n.replace(rA,(t,e)=>Pd+e).replace(oA,B0),rA=/^[ \t]*(1(?:\.0+)?e[+-]?\d+)[ \t]*\*[ \t]*$/gim,oA=/^[ \t]*Columns?[ \t]+\d+(?:[ \t]+(?:through|and)[ \t]+\d+)?:?[ \t]*$/gim;function aA(n){let t=n.words.join(" ");t.startsWith(Pd)&&(n.scale=`*${t.slice(Pd.length)}`),t===B0&&n.part++,t&&(n.above=n.words),n.words=[]}var lA=["	","&","|",";"],cA=/^\s*[-+]?\d+,\d+\s*$/;function O0(n,t){let{way:e}=t,i=t.line;if(t.line+=n.split("\v").length-1,!n.trim())return;let s=lA.filter(o=>n.includes(o)),r=s.length?Id(n,s):Id(n,e.decimal?[]:[","]);for(let o of r){if(!o.trim())continue;let a=s.length&&cA.test(o)?{...e,decimal:!0}:e;for(let l of r.length>1?hA(o,a,t):W0(o,a))MA(l,i,t)}}function hA(n,t,{isEntry:e}){let i=W0(n,t),s=H0(n,t),r=!i.every(gr)&&e(s)?[s]:i;return r.some(o=>Go(o)||e(o))?r:[n.trim()]}function G0(n,t){let e=[],[i,s]=[0,0];for(let r=0;r<n.length;r++){Yc.includes(n[r])?i++:F0.includes(n[r])&&(i=Math.max(0,i-1));let o=i?"":t(r);o&&(e.push(n.slice(s,r)),Go(o)&&e.push(o),r+=o.length-1,s=r+1)}return[...e,n.slice(s)]}var Id=(n,t)=>G0(n,e=>t.includes(n[e])?n[e]:""),uA=/^\d{9,}\.\d+$|^\d{4}-\d\d-\d\d|^\d{1,2}[/.]\d{1,2}[/.]\d{2,4}$|^\d{1,2}:\d\d/,dA=new Map(Object.entries({m:"",N:"",Nm:"",rad:"",radians:"",deg:" deg",degrees:" deg","°":" deg",mm:"*1e-3",cm:"*1e-2",Nmm:"*1e-3"})),V0=n=>dA.get(n.replace(/[·*⋅. \0]/g,"")),fA=/^([-+]? ?[\d.,]+(?:e[-+]?\d+)?)\s*([A-Za-z°][A-Za-z°·*⋅. ]{0,9})$/;function H0(n,t){let e=n.trim().replace(/^"|"$|"?[.,;]$/g,"");t.decimal&&(e=e.replace(/(?<=\d),(?=\d)/g,".")),e.includes("[")&&(e=e.replaceAll("[","(").replaceAll("]",")"));let[,i,s=""]=fA.exec(e)??[],r=V0(s);return r===void 0?e:`${i}${r}`}function W0(n,t){let e=t.decimal?n:Id(n,[","]).join(`${Ld} `);return(t.gaps?e.trim().split(/[ ]{2,}/):gA(pA(e))).map(s=>H0(s.replaceAll(Ld,""),t)).filter(Boolean)}var Ld="\0",$0=[":=","<<","->",":","="],Go=n=>$0.includes(n),pA=n=>G0(n,t=>/\s/.test(n[t])?n[t]:mA(n,t)).filter(Boolean);function mA(n,t){if(!"=:<-".includes(n[t]))return"";let e=$0.find(i=>n.startsWith(i,t))??"";return e===":"&&/^\d:\d/.test(n.slice(t-1,t+2))?"":e}function gA(n){let t=[];for(let e of n)t.length&&yA(t.at(-1),e)?t.push(`${t.pop()} ${e}`):t.push(e);return t}var xA=/[*/^]$|(?:^|\s)[-+±~≈]$/,_A=/^[*/^]|^[-+±]$/;function yA(n,t){return n.endsWith(Ld)||Go(n)||Go(t)?!1:xA.test(n)||_A.test(t)||mr(n.replace(/^[-+]+/,""))?!0:V0(t)!==void 0&&/[\d.)](?: N)?$/.test(n)}function vA(n){if(!n.run)return;let{cells:t,words:e}=n.run,i=t.pop();t.length||(n.runs.pop(),n.words=e),n.words.push(i)}function bA(n,t){vA(t);let e=n==="="&&t.name&&t.named===t.line;t.name=e?t.name:t.words.at(-1)??"",t.named=n==="="?t.line:-1,t.scale="",t.run=null}function MA(n,t,e){if(!(n==="and"&&e.run)){if(Go(n)){bA(n,e);return}if(n.startsWith("·")||uA.test(n)||!e.isEntry(n)){if(e.run&&!/[\p{L}\d]/u.test(n)||!/[\p{L}\d#<>]/u.test(n))return;e.words.push(n),e.run=null;return}if(!e.run){let{words:i,name:s,scale:r,part:o,above:a}=e,l=e.depth>0;e.run={cells:[],words:i,name:s,line:t,last:t,scale:r,part:o,above:a,listed:l},e.runs.push(e.run),e.words=[],e.name=""}e.run.cells.push(n),e.run.last=e.line}}var wA=[!1,!0].flatMap(n=>[!0,!1].flatMap(t=>[!1,!0].map(e=>({gaps:n,decimal:t,wrapped:e}))));function Nd(n,{isEntry:t,names:e=/(?!)/,given:i=[]}){let s=z0(pr(n)),r=new Map,o=l=>(r.has(l)||r.set(l,t(l)),r.get(l));return wA.filter(({decimal:l})=>!l||/\d,\d/.test(s)).map(l=>SA(()=>TA(k0(s,o,l),e,i)))}function SA(n){let t=null;return()=>t??=n()}function TA(n,t,e){let i=n.filter(({cells:r})=>!e.some(o=>AA(r,o)));return[...RA(i,t),...PA(i),...IA(i),...NA(i)].map(r=>({...r,beside:()=>EA(r,i)}))}function EA({from:n,to:t,runs:e},i){let s=new Set(e),r=i.filter(a=>a.line>=n&&a.line<=t&&!s.has(a)),o=e.flatMap(a=>a.words.filter(l=>xr(l)));return[r.map(({cells:a})=>a),o.map(a=>[a])].filter(({length:a})=>e.length<2||a%e.length).flat(2)}var AA=(n,t)=>n.length===t.length&&t.length>1&&t.some(Boolean)&&n.every((e,i)=>{let s=e.replace(/ ?deg$/,""),r=.51*10**-(s.split(".")[1]?.length??0),o=Un(s);return[t[i],t[i]/On].some(a=>o!==null&&Math.abs(o-a)<=r)}),X0=(n,t)=>n?t.test(n.replace(/^"|\W$/g,"")):null;function RA(n,t){let e=[];for(let i of new Set(n.map(({cells:s})=>s.length))){let s=[],r=-1;n.forEach((o,a)=>{if(o.cells.length!==i)return;let l=n[r],c=n.slice(r+1,a);l&&l.part===o.part&&l.listed===o.listed&&c.every(({line:u})=>u===l.line||u===o.line)&&(!o.name||!s[0].name||X0(o.name,t)===X0(s[0].name,t))?s.push(o):e.push(s=[o]),r=a})}return[...e.map(Jc),...CA(e)]}function Jc(n){let t=({cells:e,scale:i})=>i?e.map(s=>`${s}${i}`):e;return{rows:n.map(t),labels:n.map(({words:e})=>e),heads:n[0].above,name:n[0].name||n[0].words.at(-1)||"",from:n[0].line,to:n.at(-1).last,runs:n}}function CA(n){let t=n.filter(([s])=>s.part>0).sort(([s],[r])=>s.part-r.part).map(Jc);if(t.length<2||t.some(({rows:s})=>s.length!==t[0].rows.length))return[];let e=t[0].rows.map((s,r)=>t.flatMap(o=>o.rows[r])),i=t.flatMap(s=>s.runs);return[{...t[0],rows:e,heads:[],to:t.at(-1).to,runs:i}]}function PA(n){let t=new Map;for(let e of n){let i=`${e.cells.length} ${e.words.join(" ")}`;!e.words.length||e.cells.length<2||(t.has(i)||t.set(i,[]),t.get(i).push(e))}return[...t.values()].filter(e=>e.length>2).map(Jc)}function IA(n){let t=n.flatMap(h=>{let u=h.cells.length===1?zo(h.words):null;return u&&u.kind!=="count"?[{run:h,label:u}]:[]}),e=[];for(let h of t){let u=e.at(-1)?.some(({label:d})=>d.at===h.label.at);(!e.length||u)&&e.push([]),e.at(-1).push(h)}let i=e[0]?.length;if(!i||i<2||e.some(h=>h.length!==i))return[];let s=e.map(h=>Jc(h.map(({run:u})=>u)).rows.flat()),r=e[0].map(({run:h})=>h.words.join(" ")),[o,a]=[t[0].run,t.at(-1).run],l=s.map(()=>[]),c=t.map(({run:h})=>h);return[{rows:s,labels:l,heads:r,name:o.name,from:o.line,to:a.last,runs:c}]}var LA=/[[({](\d{1,2})\s*,\s*(\d{1,2})[\])}]$/;function NA(n){let t=n.flatMap(u=>{let d=u.cells.length===1&&LA.exec(u.words.at(-1)??"");return d?[{run:u,i:Number(d[1]),j:Number(d[2])}]:[]});if(t.length<2)return[];let e=u=>Math.min(...t.map(d=>d[u])),i=u=>Math.max(...t.map(d=>d[u]))-e(u)+1;if(i("i")*i("j")!==t.length)return[];let s=Array.from({length:i("i")},()=>Array(i("j")));for(let{run:u,i:d,j:p}of t)s[d-e("i")][p-e("j")]=u.cells[0];let[r,o]=[t[0].run,t.at(-1).run],a=s.map(()=>[]),l=t.map(({run:u})=>u),{name:c,line:h}=r;return[{rows:s,labels:a,heads:[],name:c,from:h,to:o.last,runs:l}]}function q0(n,{from:t,to:e,beside:i,labels:s,heads:r}){let a=Ac(n).filter((h,u)=>u<t||u>e),l=a.filter(h=>/[\p{L}\d]/u.test(pr(h)));return{context:[...a,...s.flat(),...r].join(`
`),left:[...l.map(h=>h.trim()),...i()]}}var me=["a","alpha","d","theta"],Dd={m:1,cm:.01,mm:.001},DA=/^(?:q|th|theta|t|phi)\d+$/,vr=/^(?:var(?:iable)?|[-*?qd]|th(?:eta)?)\*?$/i,OA=/\s*\((?:locked|fixed)[^()]*\)\s*$/i,Qc=n=>n.replace(/^['"]|['"]$/g,"").replace(/^[^=]*=\s*/,"").replace(OA,"").replace(/(?<=.)\^?\{?\*+\}?(?=\s*(?:[-+]|$))|(?<=.)[¹²³†‡]+$/g,"").trim();function Ii(n){let t=Ge(n);return vr.test(t)?!0:Ic(t)?.some(e=>DA.test(Fn(e)))??!1}function Y0(n,t,e){let i=Kc(f=>(FA.has(f)?UA(t[f]):t[f]).trim()),s=kA(i),r=Kc(f=>zA(s[f].replace(j0,""),f,n,e)),o=f=>!e.has(Fn(f)),a=Kc(f=>[...Do(r[f])].filter(o).sort()),l=a.theta.length?"theta":a.d.length?"d":null,c=VA(n,a,l),h=(f,x)=>Pi(r[f],m=>a[f].includes(m)?x:e.get(Fn(m))),u=Kc(f=>h(f,0)),d=l!==null&&HA(h(l,1)-u[l],n,l)<0,p=f=>/\b(?:pi|deg|rad)\b/.test(Ge(t[f]));return{kind:l===null?"unknown":BA[l],numbers:u,texts:i,backwards:d,joint:c,radians:new Set(me.filter(p)),metres:new Set(me.filter(f=>j0.test(i[f]))),trees:r}}var FA=new Set(["a","d"]),j0=/ m$/;function UA(n){let[,t,e,i,s]=/^([-+−]?)\s*(\d*\.?\d*)(?:\*1e-([23])|\s*(mm|cm|m))$/.exec(n.trim())??[];if(!e)return n;let r=i?Number(i):{mm:3,cm:2,m:0}[s],o=(e.split(".")[1]??"").length+r;return`${t}${(Number(e)/10**r).toFixed(o)} m`}var Zc=n=>["-","–","—"].includes(n);function kA(n){let{a:t,alpha:e,d:i,theta:s}=n,r=a=>Zc(a)?"0":a,o=Zc(s)&&!Ii(r(i));return{a:r(t),alpha:r(e),d:Zc(i)&&(o||Ii(s)&&!Zc(s))?"0":i,theta:o?s:r(s)}}var BA={theta:"revolute",d:"prismatic"},Kc=n=>Object.fromEntries(me.map(t=>[t,n(t)]));function zA(n,t,e,i){let s=Ge(n),o=(t==="theta"||t==="d")&&vr.test(s)&&!i.has(Fn(s));return es(o?`q_${e}`:s||"0",`${t} in row ${e}`)}function GA(n){let[t]=/\d+/.exec(n??"")??[];return t===void 0?null:{name:n,number:Number(t)}}function VA(n,t,e){let i=e===null?[]:t[e],s=i.find(a=>/^(?:q|th|phi)/.test(a))??i[0],r=a=>l=>a!==e||l!==s,[o]=me.flatMap(a=>t[a].filter(r(a)));if(o===void 0)return GA(s);throw new Jt(se("row symbol",{row:n,name:o}),[{field:"values",value:o}])}function HA(n,t,e){let i=s=>Math.abs(Math.abs(n)-s)>1e-6;if(i(1)&&i(On))throw new Jt(se("row slope",{row:t,name:e,rate:as(n)}));return n>0?1:-1}var Ho=(n,t)=>n.split(" ").map(e=>[e,t]),Od=new Map([...Ho("theta th q jointangle angle","theta"),...Ho("d offset linkoffset","d"),...Ho("a r linklength length aprev","a"),...Ho("alpha twist linktwist al alphaprev","alpha"),...Ho("i link joint j n frame row # no k","i")]),WA=80;function Bn(n){if(n.length>WA)return;let t=Ge(n.replace(/-\s*1/g,"")).replaceAll("*",""),e=t.replace(/\([^)]*\)|\[[^\]]*\]?|\bin\b.*|[,/].*|_(?:mm|deg)$/g,"").replace(/[\s_{}$\\^'"().]/g,"").toLowerCase(),i=t.split(/\s+/).at(-1).toLowerCase();return Od.get(e)??Od.get(e.replace(/[ijkn]$/,""))??Od.get(i)}function Z0(n){let t=n.join(" "),[,e=null]=/[[(/_ ]\s?(mm|cm|m)(?!\w)/.exec(t)??[],i=/deg|°/i.test(t)?"deg":/(?:\b|_)rad/.test(t)?"rad":null;return{lengths:e,angles:i,convention:/-\s*1|prev/.test(t)?"craig":null}}var J0=["a alpha d theta","theta d a alpha","alpha a d theta","alpha a theta d","d theta a alpha","d a alpha theta"].map(n=>n.split(" "));function K0({cells:n,heads:t}){let e=t.map(Bn),i=$A(n.map(a=>Ge(a[0])));if(n.every(a=>a.length===t.length-1)&&!i&&!me.includes(e[0]))return{cells:n,heads:t.slice(1)};let r=e.indexOf("i"),o=a=>a.filter((l,c)=>c!==r);return r>=0?{cells:n.map(o),heads:o(t)}:!i||n.some(a=>a.length<=4)?{cells:n,heads:t}:{cells:n.map(a=>a.slice(1)),heads:t.length>4?t.slice(1):t}}var $A=n=>!n.some(Ii)&&[0,1].some(t=>n.every((e,i)=>zo([e])?.at===i+t)),Q0=(n,t,e)=>(e?XA(n,e):qA(n,t))??jA(n);function XA(n,t){let i=t.trim().split(/[\s,;|]+/).map(Bn);if([...i].sort().join()!==me.join())throw new Jt(se("no columns",{given:Vn(t)}));return ex(n),{orders:[i],sure:!0,rows:n}}function qA(n,t){let e=h=>h.toLowerCase().includes("offset"),i=t.map(Bn),s=i.filter(h=>h==="d").length>1,r=i.map((h,u)=>s&&e(t[u])?"":h),o=me.map(h=>r.indexOf(h)),a=n.every(h=>[0,1].includes(t.length-h.length));if(o.includes(-1)||!a)return null;let l=t.findIndex((h,u)=>e(h)&&!o.includes(u)),c=n.map((h,u)=>{let d=o.map(x=>h[x]??"0"),p=h[l]??"0";return["","-"].includes(p.trim())||Un(p)===0?d:YA(u+1,d,p)});return{orders:[me],sure:!0,rows:c}}function jA(n){ex(n);let t=n.map(s=>s.map(JA)),i=[...new Map([...J0,...tx(me)].map(s=>[s.join(),s])).values()].filter(s=>ZA(t,s));return{orders:i.length?i:[J0[0]],sure:!1,rows:n}}function YA(n,t,e){let[i,s]=[2,3].map(a=>Un(t[a]||"0")===null),r=i&&!s?2:3,o=vr.test(Ge(t[r]))?`q_${n}`:t[r]||"0";return t.map((a,l)=>l===r?`${o} + (${e})`:a)}var tx=n=>n.length<2?[n]:n.flatMap((t,e)=>tx(n.filter((i,s)=>s!==e)).map(i=>[t,...i]));function ex(n){let t=[...new Set(n.map(i=>i.length))].sort((i,s)=>i-s),e=t.join(", ");if(t.length>1){let i=n.findIndex(s=>s.length!==4);throw new Jt(se("row widths",{widths:e,row:i+1,count:n[i].length}))}if(t[0]!==4)throw new Jt(se("row width",{widths:e}))}function JA(n){return{variable:Ii(n),angular:/pi|deg|°|π/.test(n),number:Un(n)}}function ZA(n,t){let[e,i,s]=me.map(r=>n.map(o=>o[t.indexOf(r)]));return[...e,...i].some(({variable:r})=>r)||[...e,...s].some(({angular:r})=>r)?!1:i.every(r=>r.number===null||KA(r.number))}function KA(n){let t=n/(Math.PI/12);return Math.abs(n)<=2*Math.PI+.01&&Math.abs(t-Math.round(t))<.02||n%15===0&&Math.abs(n)<=360}var sx=9;function rx(n,t){let e=oR(eR(pr(n))),s=Nd(e.text,{isEntry:pR(t)}).flatMap(h=>h().reverse()),r=e.text.split(`
`),a=Ac(n).filter((h,u)=>r[u]?.includes(th)).map(h=>h.trim()),l=s.map(iR).flatMap(h=>sR(h,r,e.found)),c=({heads:h,cells:u})=>(h.length?100:0)+u.length;return l.filter(({cells:[h=[]]})=>h.length>=4&&h.length<=sx).sort((h,u)=>c(u)-c(h)).map(({block:h,...u})=>{let{context:d,left:p}=q0(n,h),f=p.filter(x=>!a.includes(x)||xr(x));return{...u,context:d,left:f,torn:nR(h,r)}})}var QA=/((?:[A-Za-zθϑφ]|\\[a-z]+)_?\{?\d*\}?)\^?\{?\*\}?(?=\s)/g,tR=/(?<=\s)\*(?=[ \t]*$)/gm,eR=n=>n.replace(QA,"$1").replace(tR,"?"),nR=({from:n,to:t},e)=>[e[n-1],e[t+1]].find((i="")=>{let s=i.split(/[|&;,\s[\](){}]+/).filter(Boolean),r=s.filter(gr),a=r.every((l,c)=>Number(l)===Number(r[0])+c)&&r.length<s.length;return r.length>1&&2*r.length>=s.length&&!a});function iR(n){let t=n.rows.map(i=>i.every(s=>s==="-")),e=i=>i.filter((s,r)=>!t[r]);return{...n,rows:e(n.rows),labels:e(n.labels)}}function sR(n,t,e){let{rows:i,labels:s,from:r}=n;if(!i.length)return[];let o=s.map(c=>nx(c,e)?.[0]),a=o.flatMap((c,h)=>c?[h]:[]);if(new Set(a.map(c=>Bn(o[c]))).size<3){let c=t.slice(Math.max(0,r-rR),r+1).reverse(),h=nx(c.join(" ").split(" "),e)??[];return[{block:n,cells:i,heads:h}]}let l=i[0].map((c,h)=>a.map(u=>i[u][h]));return[{block:n,cells:l,heads:a.map(c=>o[c])}]}var rR=3,th="·heads·",nx=(n,t)=>{let e=n.find(i=>i.startsWith(th));return e?t[Number(e.slice(th.length))]:null};function oR(n){let t=[],e=n.split(new RegExp(`(
|${"␞"})`)),i=(o,a,l)=>{let[c]=/^[\s[({|]*/.exec(e[o]);e[o]=`${c.replaceAll("|"," ")} ${th}${t.push(a)-1} ${l}`},s=e.flatMap((o,a)=>a%2?[]:[a]),r=s.filter(o=>ix(e[o]));for(let o of r){for(let a of s)a>o&&(e[a]=aR(e[a],e[o]));i(o,ix(e[o]),"")}for(let o of r.length?[]:s){let[a,l]=lR.exec(Fd(e[o]))??[];l&&me.includes(Bn(l))&&i(o,[l],Fd(e[o]).slice(a.length))}return{text:e.join(""),found:t}}var Fd=n=>n.replace(/^[\s[({|]+/,"");function aR(n,t){let e=["	",";",",","|","&"].find(r=>t.includes(r))??`
`,[i,s]=[n,t].map(r=>r.split(e));return i.length!==s.length||i.length<4||!n.trim()?n:i.map((r,o)=>r.trim()||!s[o].trim()?r:"0").join(e)}var lR=new RegExp(String.raw`^([^|&\t;:=\d-]{1,24}?(?:\s?[[(][^\])]{1,8}[\])])?)`+String.raw`\s*(?:[|&\t;:,]|\s(?=[-+]?[.\d]))`),cR=[/[|&\t;]/,/\s{2,}/,/,/,/\s+/];function ix(n){let t=Fd(n).replace(/^(?:#|%|\/\/)+\s*(?![|&\t;,])|[|\s\])}]+$/g,e=>e.replace(/[|\s#%/]/g,""));for(let e of cR){let i=t.split(e);if(i.length>2*sx)continue;let s=hR(i.map(o=>o.trim().replace(/^"|"$/g,""))),r=s.map(Bn).filter(o=>me.includes(o));if(new Set(r).size>=3&&s.length<=r.length+4)return s}return null}function hR(n){let t=[];for(let e of n)t.length&&/^[([].*[)\]]$/.test(e)?t.push(`${t.pop()} ${e}`):t.push(e);return t}var uR=/^(?:joint|link|row|frame)_?\d+$/i,dR=/^(?:[a-z]+_?\{?\d+\}?'?|[a-z]_\{?\w+\}?|[adlhrbe])$/i,fR=/^(?:r|p|revolute|prismatic|fixed|base|tool)$/i;function pR(n){let t=e=>!uR.test(e)&&(dR.test(e)||n.has(Fn(e)));return e=>{let i=Qc(e);return gr(i)||vr.test(Ge(i))||fR.test(i)?!0:Ic(i)?.every(t)??!1}}function Ud(n){let t=e=>e.every((i,s)=>Un(i)===(s===3?1:0));return n.length<8||n.length%4||!n.every(e=>e.length===4)||!n.every((e,i)=>i%4!==3||t(e))?null:Array.from({length:n.length/4},(e,i)=>n.slice(4*i,4*i+4))}function lx(n,t,e){let i=t.map(x=>x.map(m=>es(m,`A_${n}`))),s=[...Do(["all",...i.flat()])].filter(x=>!e.has(Fn(x))),r=x=>{let m=g=>s.includes(g)?mR(g,x):e.get(Fn(g));return i.map(g=>g.map(y=>Pi(y,m)))},[o,a]=[r(0),r(.5)],l=kd(o),c=a[2][3]-o[2][3],h=Math.abs(c)>1e-9,u=Math.sin(Math.atan2(a[1][0],a[0][0])-l.theta),d=Object.fromEntries(me.map(x=>[x,as(l[x],6)]));ox(n,o,l),ox(n,a,l);let p=h?"prismatic":s.length?"revolute":"unknown",f=(h?c:u)<0;return{kind:p,numbers:l,texts:d,backwards:f,radians:new Set,metres:new Set}}function mR(n,t){let e=/^([cs])_?\d+$/i.exec(n);return e?e[1].toLowerCase()==="c"?Math.cos(t):Math.sin(t):t}var gR=.02,kd=n=>({a:n[0][3]*n[0][0]+n[1][3]*n[1][0],alpha:Math.atan2(n[2][1],n[2][2]),d:n[2][3],theta:Math.atan2(n[1][0],n[0][0])}),br=class extends Jt{constructor(t,e={}){super(se(t,e)),this.causes=t.includes(".")?[t]:[]}};function ox(n,t,e){let i=ax(t,e);if(!i)return;let s=t.map((o,a)=>o.map((l,c)=>a<3&&c<3?t[c][a]:l)),r=ax(s,kd(s))?"no link matrix":"table.transposed";throw new br(r,{i:n,row:i[0],column:i[1]})}function ax(n,{a:t,alpha:e}){let{d:i,theta:s}=kd(n),[r,o,a,l]=[s,e].flatMap(u=>[Math.cos(u),Math.sin(u)]),c=[[r,-o*a,o*l,t*r],[o,r*a,-r*l,t*o],[0,l,a,i]],h=Math.max(1,Math.abs(t));for(let[u,d]of c.entries())for(let[p,f]of d.entries())if(Math.abs(n[u][p]-f)>gR*h)return[u+1,p+1];return null}var cx=32,zd=(n,t,e=me)=>({cells:n,parts:t,heads:e,said:[]}),dx=n=>n.trim().replace(/^['"]+|['"]+$/g,"");function fx(n){let t=n.replace(/[“”„‟‘’]/g,'"'),e=_R(t),i=CR(e)??MR(t,e)??AR(e);return i&&{...i,...yR(t,i)}}var xR=40;function _R(n){let[t,e]=[[],[]];for(let i=0;i<n.length;i++){let s=n[i];if("[({".includes(s))e.push({from:i,sign:s,marked:!1,within:!1});else if("=:".includes(s)&&e.length)e.at(-1).marked=!0;else if("])}".includes(s)&&e.length){let{from:r,sign:o,marked:a,within:l}=e.pop(),c=n.slice(Math.max(0,r-xR),r);e.length&&(a||l)&&(e.at(-1).within=!0);let h=a&&!l;t.push({from:r,to:i+1,sign:o,before:c,body:n.slice(r+1,i),pairs:h})}}return t.sort((i,s)=>i.from-s.from)}function yR(n,{parts:t,cells:e,entries:i=e.flat()}){let s=(f,x)=>n.slice(f,x).replace(/[^\n]+/g,Bd),r=[0,...t.flat(),n.length],a=r.slice(1).map((f,x)=>x%2?s(r[x],f):n.slice(r[x],f)).join("").split(`
`),l=a.filter(f=>!f.includes(Bd)),c=new Set(i.join(" ").match(hx)),h=f=>f.flatMap(x=>x.match(hx)??[]),u=h(t.map(([f,x])=>n.slice(f,x))).filter(f=>!c.has(f)),d=l.map(f=>f.trim()).filter(f=>/[\p{L}\d]{2}/u.test(f)),p=a.filter(f=>f.includes(Bd));return{context:l.join(`
`),left:[...d,...h(p),...u]}}var Bd="\0",hx=/(?<!\d)\d*\.\d+/g,vR=String.raw`_?[({]?(?:i(?: ?- ?1)?|(\d{1,2})|deg|rad|mm|cm|m)?[)}]?`,bR=new RegExp(String.raw`['"]?(?<![A-Za-zαθ])([A-Za-zαθ]+${vR})['"]?\s*[:=]\s*`,"g");function MR(n,t){let e=t.filter(({sign:c,before:h,pairs:u})=>u&&(c==="{"||h.endsWith("dict"))),i=e.length?e:wR(n),s=new Map;i.forEach(({body:c,from:h,to:u},d)=>{let p=SR(c),f=e.length&&c.match(/[:=]/g)?.length===p.length;for(let{entry:x,name:m,i:g,x:y}of p){let S=f&&!g?1:3,w=s.get(g??i[d])??{entries:new Map,parts:[],fewest:S};s.set(g??i[d],w),w.entries.set(x,{name:m,x:y}),w.parts.push([h,u])}});let r=[...s.values()].filter(({entries:c,fewest:h})=>c.size>=h);if(r.length<2)return null;let o=me.map(c=>r[0].entries.get(c)?.name??c),a=r.map(({entries:c},h)=>me.map(u=>c.get(u)?.x??TR(u,h+1))),l=new Map(r.flatMap(c=>c.parts).map(c=>[c[0],c]));return zd(a,[...l.values()].sort(([c],[h])=>c-h),o)}function wR(n){let t=0;return n.split(`
`).map(e=>{let i=t+e.length,s={body:e,from:t,to:i};return t=i+1,s})}function SR(n){let t=[...n.matchAll(bR)];return t.flatMap(({0:e,1:i,2:s,index:r},o)=>{let a=n.slice(r+e.length,t[o+1]?.index),l=dx(a.split(/[,;[]/)[0]),c=Bn(s?i.replace(s,""):i);return me.includes(c)&&l?[{entry:c,name:s?c:i,i:s,x:l}]:[]})}var TR=(n,t)=>n==="theta"?`q_${t}`:"0",ER=/([\p{L}_][\p{L}\p{N}_]*)['"]?\s*[=:]\s*(?:(?:np\.array|Matrix)?\s*\(\s*)?$/u;function AR(n){let t=n.flatMap(({sign:a,before:l,body:c,from:h,to:u})=>{let d=a==="("?null:ER.exec(l);return d?[{entry:Bn(d[1])??"",body:c,part:[h-d[0].length,u]}]:[]});if(t.length<3||!t.every(({entry:a})=>me.includes(a)))return null;let e=new Map(t.map(({entry:a,body:l})=>[a,px(l)])),i=[...e.values()],s=[...new Set(i.map(a=>a.length))].sort((a,l)=>a-l);if(s.length!==1)throw new Jt(se("uneven lists",{counts:s.join(", ")}));let r=i[0].map((a,l)=>i.map(c=>c[l])),o=t.map(({part:a})=>a);return zd(r,o,[...e.keys()])}function px(n){let t=n.trim().split(/[,;\n]+/);return(t.length>1?t:n.trim().split(/\s+/)).map(dx).filter(Boolean)}var RR=/(?<!\p{L})(?:(?:DH)?Link|(?:Revolute|Prismatic)[\p{L}\d_]*)\s*$/u;function CR(n){let t=n.flatMap(({sign:r,before:o,body:a,from:l,to:c})=>{let[h]=r==="("&&RR.exec(o)||[""];return h?[{...IR(h,a),part:[l-h.length,c]}]:[]});if(!t.length)return null;let e=t.map(({row:r,slides:o},a)=>{let l=o?"d":"theta",c=Un(r[l])?r[l]:r.offset;return me.map(h=>h===l?`q_${a+1} + (${c})`:r[h])}),i=t.flatMap(({given:r})=>Object.values(r)),s=t.map(({part:r})=>r);return{...zd(e,s),said:[se("taken: links")],entries:i}}var ux=["theta","d","a","alpha","sigma","offset"],PR=/['"]?(?<![\p{L}\p{N}_])(a|alpha|d|theta|offset|sigma)['"]?\s*[,=]\s*([^,]+)/gu;function IR(n,t){let e={a:"0",alpha:"0",d:"0",theta:"0",offset:"0"},i=t.trim().startsWith("[")?px(t.trim().slice(1).split("]")[0]):[],s=i.length?ux.slice(0,i.length).map((l,c)=>[l,i[c]]):[...t.matchAll(PR)].map(([,l,c])=>[l,c.trim()]),r=Object.fromEntries(s),o=Un(r.sigma??"0");if(i.length>ux.length||o!==0&&o!==1)throw new Jt(se("link sigma",{given:Vn(`${n}(${t})`)}));let a=`${n}${t}`.toLowerCase().includes("prismatic")||o===1||"theta"in r&&!("d"in r);return{row:{...e,...r},slides:a,given:r}}function Gd(n){if(n>cx)throw new Jt(se("many rows",{count:n,most:cx}))}var LR=10,NR=2*Math.PI+.1,DR={alpha:"theta",theta:"alpha"};function OR(n,{columns:t,...e}={},i=[]){UR(n);let s=kR(n),r=new Map([...i,...s].map(([l,c])=>[Fn(l),c])),o=fx(n);if(o)return mx(o,{columns:t,options:e,known:r});let a=null;for(let l of rx(n,r))try{return FR(l,n),mx({...l,said:[]},{columns:t,options:e,known:r})}catch(c){if(!(c instanceof Jt)||c instanceof br)throw c;a??=c}throw a||new Jt(se("no rows",{given:Vn(n)}))}function FR({torn:n,cells:t},e){if(n)throw new Jt(se("row torn",{line:Vn(n.trim())}));if(Ud(t)&&GR.test(e))throw new br("table.frames")}function UR(n){let t=se("your table");if(n.length>BR)throw new Jt(se("too long",{what:t,count:n.length}));if(!n.trim())throw new Jt(se("empty",{what:t}))}function kR(n){return[...n.matchAll(zR)].map(([,e,i,s])=>[Ge(e),Number(i)*Dd[s??"m"]]).filter(([e])=>!Bn(e)&&!Ii(e))}var BR=1e5,zR=new RegExp(String.raw`(?<![\p{L}\p{N}_.])([A-Za-z](?:_?\{?\w{1,4}\}?)?)\s*:?=`+String.raw`\s*(-?\d+(?:\.\d+)?)\s*(mm|cm|m)?(?![\w.*/+^°])`,"gu");function mx(n,{columns:t,options:e,known:i}){let s={...n,cells:n.cells.map(d=>d.map(Qc))},r=Ud(s.cells);if(r)return[{...HR(r,i,e),left:s.left}];let{cells:o,heads:a}=K0(s);Gd(o.length);let l=Q0(o,a,t),c=vx(e,VR(Z0(a),s.context)),h=l.rows.flat().join(" & "),u=s.cells.flat().filter(d=>xr(d)&&!h.includes(d));return WR(l,i).map(d=>({...c,...d,left:s.entries?s.left:[...s.left,...u],said:[...s.said,...d.said]}))}var GR=/\bT_?\{?0_?[2-9]|\b0_?T_?[2-9]|\bT_?\{?[2-9]\}?\^\{?0/,VR=(n,t)=>/\bcraig\b|\bmodified\b/i.test(t)&&!/\bstandard\b|\bspong\b/i.test(t)?{...n,convention:"craig"}:n,vx=({lengths:n,angles:t,convention:e},i={})=>({lengths:n||(i.lengths??null),angles:t||(i.angles??null),convention:e||(i.convention??null)});function HR(n,t,e){Gd(n.length);let i=n.map((s,r)=>lx(r+1,s,t));return{...vx(e),rows:i,said:[se("taken: matrices")]}}function WR({orders:n,sure:t,rows:e},i){let s=n.map(l=>gx(e,l,i,t)),r=s.filter(l=>l.rows);if(r.length)return r;if(!t||!$R(e,n[0]))throw s[0].error;let o=n[0].map(l=>DR[l]??l),a=gx(e,o,i,t);if(!a.rows)throw a.error;return[{...a,exchanged:!0}]}function $R(n,t){let[e,i]=["alpha","theta"].map(s=>n.map(r=>r[t.indexOf(s)]));return e.some(Ii)&&!i.some(Ii)}var XR=({lengths:n,rows:t})=>n===null&&t.some(({numbers:e,metres:i})=>["a","d"].some(s=>!i.has(s)&&Math.abs(e[s])>=LR));function gx(n,t,e,i){try{let s=n.map((o,a)=>{let l=Object.fromEntries(t.map((c,h)=>[c,o[h]]));return Y0(a+1,l,e)}),r=i?[]:[se("taken: columns",{columns:t.join(" ")})];return{rows:s,said:r,guessed:!i}}catch(s){if(s instanceof Jt)return{error:s};throw s}}function qR(n,t){let e=XR(n),i=jR(n).map(Math.abs),s=n.angles===null&&Math.max(...i)>NR,r=s&&i.find(YR);if(r)throw new Jt(se("two angles",{one:as(Math.max(...i),4),other:as(r,6)}),[{field:"angles",value:"deg"}]);let o=Dd[e?"mm":n.lengths??"m"],a=s||n.angles==="deg"?On:1,l=n.convention==="craig",c=JR(n,t,o,a),h=[...n.said,...e?[se("taken: millimetres")]:[],...s?[se("taken: degrees")]:[],...xx("taken: fixed",ZR(n,t)),...l?[se("taken: craig")]:[],...xx("taken: backwards",Mx(n.rows,({backwards:u})=>u))];return{rows:l?tC(c):c,said:h,length:o,angle:a}}var bx=["alpha","theta"],jR=({rows:n})=>n.flatMap(({numbers:t,radians:e})=>bx.map(i=>e.has(i)?0:t[i])),YR=n=>[Math.PI/2,Math.PI].some(t=>!Number.isInteger(n)&&Math.abs(n-t)<.005);function JR(n,t,e,i){let s=QR(n,t);return n.rows.map(({numbers:r,radians:o,metres:a},l)=>{let[c,h]=bx.map(p=>r[p]*(o.has(p)?1:i)),[u,d]=["a","d"].map(p=>r[p]*(a.has(p)?1:e));return{kind:s[l],a:u,alpha:c,d,theta:h}})}var Mx=(n,t)=>n.flatMap((e,i)=>t(e,i)?[i+1]:[]),ZR=({rows:n},t)=>t.length&&n.every(wx)?Mx(n,(e,i)=>i>=t.length):[],xx=(n,t)=>t.length?[se(n,{rows:KR(t)})]:[],KR=n=>n.length===1?se("row",{row:n[0]}):se("rows",{rows:je(n.map(String))}),wx=({kind:n})=>n==="unknown";function QR({rows:n},t){let e=t.length?"fixed":"revolute";return n.every(wx)?n.map((i,s)=>t[s]??e):n.map(({kind:i})=>i==="unknown"?"fixed":i)}var _x={kind:"fixed",a:0,alpha:0,d:0,theta:0},yx=n=>n.kind==="fixed"&&me.every(t=>n[t]===0);function tC(n){let t=n.map((i,s)=>{let{a:r,alpha:o}=n[s+1]??_x;return{...i,a:r,alpha:o}});t.length>1&&yx(t.at(-1))&&t.pop();let e={..._x,a:n[0].a,alpha:n[0].alpha};return yx(e)?t:[e,...t]}function Sx(n,t,e=[],i=null){let s=se("taken: columns",{columns:"a alpha d theta"}),r=OR(n,{},e),o=r.find(({said:u})=>u.includes(s))??r[0],a=o.angles??(t==="deg"||i?t:null),{rows:l,said:c}=qR({...o,lengths:o.lengths??i,angles:a},[]),h=o.guessed&&!o.said.includes(s);return{rows:l,said:c.filter(u=>u!==s),guessed:h}}var eC=/[\n\t;&|]|\]\s*,|,\s*\[|\d +[-\d]/;function Tx(n,t){try{if(!eC.test(n.trim()))return null;let e=Sx(n,t),i=As(e.rows);return i?{error:`${i}.`}:e}catch(e){if(e instanceof Jt)return{error:`${e.message}.`};throw e}}var nC="DH table",Ex=[["a","a",!1],["alpha","α",!0],["d","d",!1],["theta","θ",!0]],iC={revolute:"turns",prismatic:"slides",fixed:"fixed"},sC={revolute:"theta",prismatic:"d"},rC={kind:"revolute",a:.2,alpha:0,d:0,theta:0};function oC(n,{announce:t}){let e=C("p.error"),i=C("p.verdict"),s=(p,f,x=null)=>n.dispatch({type:"editTable",rows:p,rowBefore:f,gesture:x}),o=lC(n,{change:s,complain:p=>{e.textContent=p?`${p} The last good arm stays.`:"",p&&t(()=>e.textContent)},announce:t}),a=(p,f)=>C("button",{onclick:f},p),l=a("Add a row",()=>s([...n.state.arm.rows,rC])),c=a("Back to the first table",()=>s(n.state.base.rows)),h=C("div.row",{},l,c,aC(n,t));return{root:C("div.dh",{},o.root,e,h,i),update:(p,f)=>{o.update(p),l.disabled=p.arm.rows.length>=jo,Pt(i,Wf(p,f))},summary:()=>e.textContent||i.textContent}}function aC(n,t){let e="Copy the table",i=C("button.right",{onclick:s},e);async function s(){let r=wf(n.state.arm),o=await Zo(r);o||pC(r,"table.tsv"),i.textContent=o?"Copied":"Saved",t(()=>`The table is ${o?"copied":"saved"}.`,!0),setTimeout(()=>i.textContent=e,1600)}return i}function lC(n,{change:t,complain:e,announce:i}){let s=C("tr"),r=C("tbody",{onpaste:u=>cC(u,n,{change:t,complain:e,announce:i})}),a=C("table.entries",{"aria-label":"Denavit-Hartenberg table, standard convention"},C("thead",{},s),r),l={};function c(u,[d,p,f],x,m){let{unit:g,arm:y}=n.state,{value:S,message:w}=ns(x,f?"angle":"length",{unit:g,whole:m});e(w&&`Row ${u+1}, ${p} ${w}.`),S!==void 0&&(t(xn(y.rows,u,{...y.rows[u],[d]:S}),void 0,`cell ${u} ${d}`),m&&(x.value=ea(S,f,g)))}function h({arm:u,unit:d}){let p=r.getRootNode(),f=r.contains(p.activeElement)&&p.activeElement.matches("input");!(l.rows?.length!==u.rows.length||l.unit!==d)&&(l.rows===u.rows||f)||(s.replaceChildren(...hC(d)),r.replaceChildren(...u.rows.map((m,g)=>uC(g,u,d,{change:t,typed:c}))),l={rows:u.rows,unit:d})}return{root:Cs("Denavit-Hartenberg table",a),update:h}}function cC(n,t,{change:e,complain:i,announce:s}){let{currentTarget:r,target:o}=n,a=n.clipboardData?.getData("text/plain")??"",l=Tx(a,t.state.unit);l&&(n.preventDefault(),i("error"in l?`What was pasted is not read: ${l.error}`:""),!("error"in l)&&(e(l.rows),r.querySelector(`[data-cell="${o.dataset.cell}"]`)?.focus({preventScroll:!0}),l.said.length&&s(()=>`Taken as ${l.said.join("; ")}`,!0)))}var hC=n=>[...["row","joint"].map(t=>C("th",{scope:"col"},t)),...Ex.map(([,t,e])=>{let i=C("small",{},e?` (${n==="deg"?"°":"rad"})`:" (m)");return C("th",{scope:"col"},C("i",{},t),i)}),C("th",{},C("span.hidden",{},"remove"))];function uC(n,t,e,{change:i,typed:s}){let r=t.rows[n],o=h=>i(xn(t.rows,n,fC(r,h))),a=Fi(`Row ${n+1}, kind of joint`,iC,o);a.value=r.kind;let l=()=>t.rows.filter((h,u)=>u!==n),c=C("button.remove",{"aria-label":`Remove row ${n+1}`,title:`Remove row ${n+1}`,disabled:t.rows.length===1,onclick:()=>i(l(),h=>h<n?h:h+1)},"×");return C("tr",{},C("th",{scope:"row"},String(n+1)),C("td",{},a),Ex.map(h=>dC(n,h,r,{unit:e,typed:s})),C("td",{},c))}function dC(n,t,e,{unit:i,typed:s}){let[r,o,a]=t,l=hi(`Row ${n+1}, ${o}`,(...c)=>s(n,t,...c),{value:ea(e[r],a,i),"data-cell":`${n+1}-${r}`});return r!==sC[e.kind]?C("td",{},l):C("td.moves",{},l,C("span",{},"+ ",Se("q",n+1)))}var fC=(n,t)=>({...n,kind:t,lower:null,upper:null,speed:null,effort:null});function pC(n,t){let e=URL.createObjectURL(new Blob([n],{type:"text/plain"}));C("a",{href:e,download:t}).click(),URL.revokeObjectURL(e)}var Wd={};Di(Wd,{build:()=>xC,title:()=>mC});var mC="Static torque",Hd=["F","M"].flatMap(n=>["x","y","z"].map(t=>[n,t,n==="F"?"N":"N m"])),gC=["joint","gravity","−Jᵀ F","torque","share of the limit"];function xC(n,{point:t,announce:e}){let i=_C(n,e),s=yC(t),r=C("p.verdict"),o=C("p.words"),a=C("div.torque",{},i.root,i.error,s.root,r,o);function l(c,h){let{arm:u}=c;i.update(c.wrench);let d=s.update(u,h);r.classList.toggle("warning",d.length>0),Pt(r,MC(u,d,h.gravity));let p=`${At(h.energy,1)} J here.`,f=u.rows.some(x=>x.body);Pt(o,f?`Gravity’s torques are the slopes of one energy, ${p}`:"")}return{root:a,update:l,summary:()=>r.textContent}}function _C(n,t){let e=C("p.error"),i=(h,u,d)=>{let{value:p,message:f}=ns(u,h<3?"force":"moment",{whole:d}),[x,m]=Hd[h];Pt(e,f&&`${x}${m} ${f}. The last good wrench stays.`),f&&t(()=>e.textContent),p!==void 0&&s(xn(n.state.wrench,h,p),`wrench ${h}`),d&&(oe(u,"aria-invalid","false"),u.value=di(n.state.wrench[h],2))},s=(h,u)=>n.dispatch({type:"setWrench",wrench:h,gesture:u}),r=Hd.map(([h,u,d],p)=>hi(`${h} ${u}, ${d}`,(...f)=>i(p,...f))),o=C("button",{onclick:()=>s([0,0,0,0,0,0])},"No load"),a=Hd.map(([h,u],d)=>C("label",{},C("span",{},Se(h,u)),r[d])),l=C("legend",{},"Wrench on the tool, by the world, at the tip (N, N m)"),c=h=>r.forEach((u,d)=>is(u,di(h[d],2)));return{root:C("fieldset.wrench",{},l,a,o),error:e,update:c}}function yC(n){let t=C("tbody"),e=gC.map(l=>C("th",{scope:"col"},l)),s=C("table.bars",{"aria-label":"Static torque of each joint"},C("thead",{},C("tr",{},e)),t),[r,o]=[[],null];function a(l,{gravity:c,push:h,torque:u}){o!==l&&(o=l,r=dt(l).map(f=>vC(f,n)),t.replaceChildren(...r.map(({line:f})=>f)));let d=Math.max(1e-9,...u.map(Math.abs));return r.forEach((f,x)=>{[c[x],-h[x],u[x]].forEach((m,g)=>Pt(f.cells[g],At(m,2))),bC(f,l.rows[f.row],u[x],d)}),r.filter(({line:f})=>f.classList.contains("over")).map(({row:f})=>`joint ${f+1}`)}return{root:Cs("Torques",s),update:a}}function vC(n,t){let e=["gravity","push","total"].map(l=>C(`td.${l}`)),i=C("span.fill"),[s,r]=[C("span"),C("span.limit")],o=C("span.track",{"aria-hidden":!0},i),a=C("tr",{onpointerenter:()=>t(n),onpointerleave:()=>t(null)},C("th",{scope:"row"},Se("τ",n+1)),e,C("td.bar",{},o,C("span.share",{},s,r)));return{row:n,cells:e,fill:i,part:s,limit:r,line:a}}function bC({fill:n,part:t,limit:e,line:i},{effort:s,kind:r},o,a){let l=r==="revolute"?"N m":"N",c=o/(s??a);n.style.setProperty("--from",`${50+50*Math.max(-1,Math.min(0,c))}%`),n.style.setProperty("--width",`${50*Math.min(1,Math.abs(c))}%`),i.classList.toggle("over",!!s&&Math.abs(c)>1),Pt(t,s?`${At(100*Math.abs(c),0)} %`:""),Pt(e,s?` of ${s} ${l}`:l)}function MC(n,t,e){if(t.length)return`Too much for ${je(t)}.`;if(!n.rows.some(r=>r.body))return"No masses are known of this arm, so only the push on the tool shows.";let i=n.rows.every(r=>r.kind==="fixed"||r.effort)?"Every joint can hold this. ":"",s=e.every(r=>r===0)?" Gravity asks nothing here.":"";return`${i}Drag the ball at the tip to push on the tool.${s}`}var $d={};Di($d,{build:()=>SC,title:()=>wC});var wC="Circle trace",Ax=5;function SC(n,{announce:t,signal:e}){let i=C("p.verdict"),s=EC(n,t),r=qc(n),o=TC(n,s,()=>t(()=>i.textContent,!0)),a=jc(n,{signal:e,makeTrace:o.draw}),l=C("div.row",{},s.labels,o.root,r.choice),c=C("div.trace",{},a.root,l,s.error,i,r.root);function h(u){Pt(i,RC(u)),r.update(u),s.update(u.circle),a.update(u)}return{root:c,update:h,summary:()=>i.textContent}}function TC(n,t,e){let i=C("button",{onclick:()=>r()},"Draw a circle from here"),s=Ls("circle");function r(o=()=>{}){if(!t.sized())return;let{arm:a,q:l,circle:c}=n.state;s({arm:a,q:l,circle:c},({path:h,wantedPath:u})=>{n.dispatch({type:"setTrace",arm:a,circle:c,path:h,wantedPath:u}),e(),o()})}return{root:i,draw:r}}function EC(n,t){let e=C("p.error"),r=Fi("Plane of the circle",{x:"x = const",y:"y = const",z:"z = const"},u=>n.dispatch({type:"setCircle",normal:u})),a=hi("Radius of the circle, m",(u,d)=>l(d),{class:"small"});function l(u=!0){let{value:d,error:p}=Dc(a.value,"length"),f=d>0&&d<=Ax,x=`“${a.value}” is no length above 0 and up to ${Ax} m`,m=fd(a,f?"":p??x,u);return Pt(e,m&&`The radius ${m}.`),m&&t(()=>e.textContent),f&&d!==n.state.circle.radius&&n.dispatch({type:"setCircle",radius:d}),f}function c(u){r.value=u.normal,e.textContent||is(a,di(u.radius,4))}return{labels:[C("label",{},"Plane ",r),C("label",{},"Radius ",a," m")],error:e,sized:l,update:c}}var AC="Play draws a circle of this radius from where the tip is now; the tool keeps its orientation.";function RC({arm:n,trace:t,wantedPath:e}){if(!t)return AC;if(e&&t.length<e.length)return`The whole circle is not within reach: the arm stops after ${Math.floor(100*(t.length-1)/(e.length-1))} % of it.`;let i=ha(n,t);if(!i.length)return"All joints stay within their limits.";let s=i.length>1?"their limits":"its limit",r=`${je(i)} would have to pass ${s} (tinted).`;return oa(r)}var Xd={table:Vd,pose:_d,jacobian:ld,trace:$d,torque:Wd,branches:Td,homework:Cd};function Rx(n,t,e){let i=new Map,s=t.length>1,r=t.map(f=>CC(f,e.id));r.forEach((f,x)=>{f.addEventListener("click",()=>o(x)),f.addEventListener("keydown",m=>{let g=PC(m.key,x,t.length);g!==null&&(m.preventDefault(),o(g),r[g].focus())})});let o=f=>n.dispatch({type:"setFields",view:t[f]}),a=s?{role:"tabpanel"}:{},l=C("div.view",{id:`${e.id}-panel`,...a}),c=s?C("div.tabs",{role:"tablist","aria-label":"Views"},r):[];function h(f,x){l.replaceChildren(x.root),s&&l.setAttribute("aria-labelledby",`${e.id}-${f}`),r.forEach((m,g)=>{m.setAttribute("aria-selected",String(t[g]===f)),m.tabIndex=t[g]===f?0:-1})}function u(f,x){let m=f.view;i.has(m)||i.set(m,Xd[m].build(n,e));let g=i.get(m);l.firstChild!==g.root&&h(m,g),g.update(f,x)}let d=(f,x)=>i.get(f.view)?.summary?.(f,x)??"",p=()=>i.forEach(f=>f.dispose?.());return{root:C("div.views",{},c,l),update:u,summary:d,dispose:p}}var CC=(n,t)=>C("button",{role:"tab",id:`${t}-${n}`,"aria-controls":`${t}-panel`},Xd[n].title);function PC(n,t,e){let i={ArrowRight:t+1,ArrowLeft:t-1,Home:0,End:e-1}[n];return i===void 0?null:(i+e)%e}var IC=1e3,LC=400;function Cx(n,t){let e=C("p.hidden",{role:"status","aria-live":"polite"}),i=null,s=null,r=()=>n.activeElement!==null&&document.hasFocus();function o(a,l=!1){clearTimeout(i),i=setTimeout(()=>{!l&&!r()||(e.textContent=a(),clearTimeout(s),s=setTimeout(()=>e.textContent="",LC+60*e.textContent.length))},IC)}return t.addEventListener("abort",()=>{clearTimeout(i),clearTimeout(s)}),{region:e,announce:o}}var NC=450,DC=100,OC=["q","arm","wrench","branches","trace","dragging"],FC=0;function qd(n,t,{views:e,arms:i,makeLink:s}){let r=n.shadowRoot??n.attachShadow({mode:"open"}),o=new AbortController,{signal:a}=o,{region:l,announce:c}=Cx(r,a),h=UC(),u={id:`explorer-${++FC}`,goTo:zC(t,a),announce:c,signal:a,notify:h.notify,point:S=>t.dispatch({type:"setFields",highlightedRow:S})},d=s?.(h.notify,a),p=Hc(t,u),f=R0(t,u),x=Rx(t,e,u),m=C("section.explorer"),g=T0(t,{...u,arms:i,link:d,stage:p,card:m}),y=C("div.bench",{},p.root,f.root);return m.append(g.root,h.root,y,x.root,l),r.replaceChildren(C("style",{},Uc,S0),m),kC(t,{card:m,head:g,stage:p,sliders:f,tabs:x},{announce:c,signal:a}),()=>{o.abort(),p.dispose(),x.dispose(),r.replaceChildren()}}function UC(){let n=C("p.notice",{role:"status",hidden:!0});return{root:n,notify:e=>{n.hidden=!e,n.textContent=e}}}function kC(n,{card:t,head:e,stage:i,sliders:s,tabs:r},{announce:o,signal:a}){let l="light",c=null,h=()=>i.draw(n.state,n.derived,l),u=()=>{clearTimeout(c),c=null;let{state:d,derived:p}=n,f=`Explorer of the ${d.arm.name}`.replace("the Your","your");oe(t,"aria-label",f);for(let x of[e,i,s,r])x.update(d,p)};a.addEventListener("abort",()=>clearTimeout(c)),$c(d=>{l=d,t.dataset.theme=d,h()},a),n.listen(d=>{if(h(),n.state.dragging&&!d.has("dragging")){c??=setTimeout(u,DC);return}u(),OC.some(p=>d.has(p))&&!n.state.playing&&o(()=>BC(n,r))},a),u()}function BC({state:n,derived:t},e){let[i,s,r]=t.frames.at(-1).o.map(o=>At(o,3).replace("−","minus "));return`Tip at x ${i}, y ${s}, z ${r} metres. ${e.summary(n,t)}`.trim()}function zC(n,t){let e=null,i=()=>{e&&cancelAnimationFrame(e),e=null};return t.addEventListener("abort",i),n.listen((s,r)=>r!=="glide"&&(s.has("q")||s.has("arm"))&&i(),t),s=>{i();let{q:r,arm:o}=n.state,a=`glide ${performance.now()}`,l=u=>n.dispatch({type:"glide",q:u,gesture:a},"glide");if(Ko()||s.length!==r.length)return l(s);let c=performance.now(),h=u=>{if(e=null,n.state.arm!==o)return;let d=Math.min(1,Math.max(0,u-c)/NC),p=d*d*(3-2*d);l(d===1?s:r.map((f,x)=>f+p*(s[x]-f))),d<1&&(e=requestAnimationFrame(h))};return e=requestAnimationFrame(h),!0}}function Px(n,t){if(!t)return null;let e=t.filter(({q:s})=>an(n,s)),i=Ot(n,e[0]?.q??n.rows.map(()=>0)).at(-1);return{list:e,families:[],lockedJoint:-1,target:i,hasOrientation:Ae(n)===6}}function Ix(n){let[t]=n.arms;return zc({arm:t,reference:n.reference??t,q:n.q,wrench:n.wrench,unit:n.unit,view:n.views[0],frames:n.views[0]==="table"?"all":"ends",trace:n.trace,branches:Px(t,n.branches)})}function GC(n){return n.explorer??=VC(n),n.explorer}function VC(n){let{figure:t}=n.dataset,e=JSON.parse(n.querySelector("script").textContent);if(t)return{dispose:Sd[t](n,e)};let i=new Ss(Ix(e)),s=e.link?(o,a)=>rp(i,e.arms,e.views,o,a):void 0,r=qd(n,i,{...e,makeLink:s});return{store:i,dispose:r}}var jd={q:{from:n=>n.q,field:"q"},wrench:{from:n=>n.wrench,field:"wrench"},trace:{from:n=>n.trace,field:"trace"},branches:{from:n=>n.branches?.list??null,field:"branches"},arm_name:{from:n=>n.base.name,field:"arm"},rows:{from:n=>n.arm===n.base?[]:n.arm.rows,field:"arm"}},HC=50;function WC(n,t){let{arms:e}=n.get("_spec"),i=e.find(h=>h.name===n.get("arm_name"))??t.base,s=t.base.name===i.name,r=n.get("rows"),o=r.length?$C(r,t.arm):s?t.base:i,a=n.get("branches"),l=eh(a,t.branches?.list??null)&&t.arm===o,c=n.get("trace");return{arm:o,base:s?t.base:i,reference:s?t.reference:i,q:[...n.get("q")],wrench:[...n.get("wrench")],trace:eh(c,t.trace)?t.trace:c,branches:l?t.branches:Px(o,a)}}var $C=(n,t)=>XC(n,t.rows)?t:{name:ah,home:[],rows:n},eh=(n,t)=>JSON.stringify(n)===JSON.stringify(t),XC=(n,t)=>n===t||eh(n,t);function qC(){let n=null;function t({model:i}){let s=i.get("_spec"),r=Object.fromEntries(["q","wrench","trace","branches"].map(o=>[o,i.get(o)]));return n=new Ss(Ix({...s,...r})),jC(i,n)}function e({model:i,el:s}){let r=Lx(s),o=qd(r,n,i.get("_spec"));return()=>{o(),r.remove()}}return{initialize:t,render:e}}function Lx(n){let t=document.createElement("div");return t.dataset.lmSuppressShortcuts="true",n.append(t),t}function jC(n,t){let e=new Set(Object.values(jd).map(({field:h})=>h)),i=new AbortController,[s,r,o]=[null,null,!1],a=()=>{s=null,o=!0;for(let[h,{from:u}]of Object.entries(jd)){let d=u(t.state);eh(n.get(h),d)||n.set(h,d)}o=!1,n.save_changes()};t.listen((h,u)=>{u!=="python"&&[...h].some(d=>e.has(d))&&(s??=setTimeout(a,HC))},i.signal);let l=()=>{o||(r??=setTimeout(()=>{r=null,t.dispatch({type:"replaceState",...WC(n,t.state)},"python")}))},c=Object.keys(jd).map(h=>`change:${h}`);for(let h of c)n.on(h,l);return()=>{i.abort(),clearTimeout(s),clearTimeout(r);for(let h of c)n.off(h,l)}}var YC=()=>({render({model:n,el:t}){let e=Lx(t),i=n.get("_spec"),s=Sd[i.figure](e,i);return()=>{s(),e.remove()}}});return Vx(JC);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
