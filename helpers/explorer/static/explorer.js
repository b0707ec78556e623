var ArmExplorer=(()=>{var mc=Object.defineProperty;var kg=Object.getOwnPropertyDescriptor;var zg=Object.getOwnPropertyNames;var Gg=Object.prototype.hasOwnProperty;var oe=(n,t)=>{for(var e in t)mc(n,e,{get:t[e],enumerable:!0})},Vg=(n,t,e,i)=>{if(t&&typeof t=="object"||typeof t=="function")for(let s of zg(t))!Gg.call(n,s)&&s!==e&&mc(n,s,{get:()=>t[s],enumerable:!(i=kg(t,s))||i.enumerable});return n};var Hg=n=>Vg(mc({},"__esModule",{value:!0}),n);var Zw={};oe(Zw,{Figure:()=>rs,derive:()=>mo,figureWidget:()=>jw,inUse:()=>Vu,kinematics:()=>js,kit:()=>rg,loseContext:()=>Hu,mount:()=>Hw,registerFigure:()=>nh,widget:()=>Yw});var Mc={};oe(Mc,{KINDS:()=>ls,LARGEST:()=>yc,LONGEST:()=>Js,MOST_ROWS:()=>Zs,TYPED:()=>Eo,carriedOver:()=>Ao,fits:()=>Je,homeOf:()=>Vi,limited:()=>vc,outside:()=>ti,range:()=>Tn,reachOf:()=>tr,rowsFault:()=>Ks,sameRow:()=>To,typedArm:()=>Qs});var js={};oe(js,{GRAVITY:()=>Wg,cosSin:()=>gc,cross:()=>ve,dot:()=>pe,gravityTorque:()=>qs,jacobianColumns:()=>ze,joints:()=>yt,liftedEnergy:()=>_c,linkFrames:()=>qt,matrix:()=>xc,minus:()=>At,norm:()=>$t,plus:()=>Gt,scaled:()=>Ct,wrenchTorque:()=>Ys});var Wg=9.81,pe=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Ct=(n,t)=>[n*t[0],n*t[1],n*t[2]],Gt=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],At=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],ve=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],$t=n=>Math.sqrt(n.reduce((t,e)=>t+e*e,0)),as=(n,t,e,i)=>[n*t[0]+e*i[0],n*t[1]+e*i[1],n*t[2]+e*i[2]];function gc(n){let t=n/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(n),Math.sin(n)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(t)%4+4)%4]}var yt=n=>n.rows.flatMap((t,e)=>t.kind==="fixed"?[]:[e]);function qt(n,t){let[e,i,s,r]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],o=[{x:e,y:i,z:s,o:r}],a=0;for(let l of n.rows){let c=l.kind==="fixed"?0:t[a++],[h,u]=gc(l.kind==="revolute"?l.theta+c:l.theta),[f,p]=gc(l.alpha),g=l.kind==="prismatic"?l.d+c:l.d;[e,i]=[as(h,e,u,i),as(h,i,-u,e)],r=Gt(as(g,s,l.a,e),r),[i,s]=[as(f,i,p,s),as(f,s,-p,i)],o.push({x:e,y:i,z:s,o:r})}return o}var xc=({x:n,y:t,z:e,o:i})=>[0,1,2].map(s=>[n[s],t[s],e[s],i[s]]).concat([[0,0,0,1]]);function ze(n,t,e=t.at(-1).o){return yt(n).map(i=>{let{z:s,o:r}=t[i];return n.rows[i].kind==="revolute"?[...ve(s,At(e,r)),...s]:[...s,0,0,0]})}function qs(n,t,e=9.81){let i=Xd(n,t);return yt(n).map(s=>{let{z:r,o}=t[s],a=l=>n.rows[s].kind==="revolute"?ve(r,At(l,o))[2]:r[2];return i.reduce((l,{mass:c,centre:h,row:u})=>l+(u<s?0:c*e*a(h)),0)})}var _c=(n,t,e=9.81)=>Xd(n,t).reduce((i,{mass:s,centre:r})=>i+s*e*r[2],0),Xd=(n,t)=>n.rows.flatMap((e,i)=>e.body?[Xg(e.body,t[i+1],i)]:[]);function Xg([n,...t],{x:e,y:i,z:s,o:r},o){return{mass:n,row:o,centre:Gt(r,Gt(as(t[0],e,t[1],i),Ct(t[2],s)))}}var Ys=(n,t)=>n.map(e=>e.reduce((i,s,r)=>i+s*t[r],0));var ls=["revolute","prismatic","fixed"],Zs=16,Js=100,yc=1e3,Eo="Your arm",$d=[["a",Js],["alpha",yc],["d",Js],["theta",yc]];function Ks(n){if(!Array.isArray(n)||!n.length)return"the table has no rows";if(n.length>Zs)return`the table has ${n.length} rows; ${Zs} are the most`;for(let[t,e]of n.entries()){if(!ls.includes(e?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[i,s]of $d){if(!Number.isFinite(e[i]))return`row ${t+1} has no number for ${i}`;if(Math.abs(e[i])>s)return`row ${t+1} has ${e[i]} for ${i}; ${s} is the most`}}return null}var $g=({kind:n,a:t,alpha:e,d:i,theta:s})=>({kind:n,a:t,alpha:e,d:i,theta:s,lower:null,upper:null,speed:null,effort:null}),To=(n,t)=>n.kind===t.kind&&$d.every(([e])=>Math.abs(n[e]-t[e])<1e-12);function Qs(n,t){if(n.length===t.rows.length&&n.every((i,s)=>To(i,t.rows[s])))return t;let e={name:Eo,home:[],rows:n.map($g)};return{...e,home:Ao(t,t.home,e,i=>i)}}function Ao(n,t,e,i){let s=new Map(yt(n).map((r,o)=>[r,[n.rows[r].kind,t[o]??0]]));return yt(e).map(r=>{let[o,a]=s.get(i(r))??[];return o===e.rows[r].kind?a:0})}var Vi=n=>Je(n,n.home)?[...n.home]:yt(n).map(()=>0),Je=(n,t)=>Array.isArray(t)&&t.length===yt(n).length&&t.every(Number.isFinite);function Tn(n){let t=n.kind==="revolute"?Math.PI:1;return[n.lower??-t,n.upper??t]}var ti=(n,t)=>t<(n.lower??-1/0)-1e-9||t>(n.upper??1/0)+1e-9,vc=n=>yt(n).some(t=>n.rows[t].lower!==null||n.rows[t].upper!==null),tr=n=>n.rows.reduce((t,e)=>t+Math.abs(e.a)+Math.abs(e.d)+(e.kind==="prismatic"?Math.abs(e.upper??.3):0),0)||.3;var Jc={};oe(Jc,{BOUNDS:()=>$c,HOMEWORK:()=>uf,isPanda:()=>ff,onCircle:()=>Bo,radiiTo:()=>df,runCircle:()=>zo,runFrom:()=>Zc,runText:()=>jc,torquesAlong:()=>Yc,windingByRadius:()=>qc});var Ac={};oe(Ac,{determinant:()=>bc,plainBasis:()=>wc,rightNull:()=>ei,singular:()=>rn,solve:()=>Sc,solvePositive:()=>Ro});function rn(n,t=6){let e=Array.from({length:t},(r,o)=>n.map(a=>a[o])),i=Array.from({length:t},(r,o)=>Array.from({length:t},(a,l)=>+(o===l)));for(let r=0,o=!0;o&&r<30;r++){o=!1;for(let a=0;a<t;a++)for(let l=a+1;l<t;l++)o=qg(e,i,a,l)||o}let s=e.map((r,o)=>[Math.hypot(...r),o]).sort((r,o)=>o[0]-r[0]);return{values:s.map(([r])=>r),vectors:s.map(([,r])=>i[r])}}function qg(n,t,e,i){let[s,r,o]=[0,0,0];for(let h=0;h<n[e].length;h++)s+=n[e][h]*n[e][h],r+=n[i][h]*n[i][h],o+=n[e][h]*n[i][h];if(Math.abs(o)<=1e-15*Math.sqrt(s*r)||o*o<1e-60)return!1;let a=(r-s)/(2*o),l=(a<0?-1:1)/(Math.abs(a)+Math.sqrt(1+a*a)),c=1/Math.sqrt(1+l*l);for(let h of[n,t])for(let u=0;u<h[e].length;u++){let[f,p]=[h[e][u],h[i][u]];h[e][u]=c*(f-l*p),h[i][u]=c*(l*f+p)}return!0}function bc(n){let t=n.length;if(n.some(s=>s.length!==t))return null;let e=n.map(s=>[...s]),i=1;for(let s=0;s<t;s++){let r=Ec(e,s,s);if(e[r][s]===0)return 0;r!==s&&([e[r],e[s],i]=[e[s],e[r],-i]),i*=e[s][s];for(let o=s+1;o<t;o++)Tc(e[o],e[s],s)}return i}function Sc(n,t){let e=n.map((s,r)=>[...s,t[r]]),i=e.length;for(let s=0;s<i;s++){let r=Ec(e,s,s);[e[r],e[s]]=[e[s],e[r]];for(let o=0;o<i;o++)o!==s&&Tc(e[o],e[s],s)}return e.map((s,r)=>s[i]/s[r])}function wc(n){let t=n.map(i=>[...i]),e=0;for(let i=0;i<6&&e<t.length;i++){let s=Ec(t,e,i);if(!(Math.abs(t[s][i])<1e-6)){[t[s],t[e]]=[t[e],t[s]];for(let r=0;r<t.length;r++)r!==e&&Tc(t[r],t[e],i);e++}}return t.map(i=>i.map(s=>s/Math.hypot(...i)))}function Ec(n,t,e){let i=t;for(let s=t;s<n.length;s++)Math.abs(n[s][e])>Math.abs(n[i][e])&&(i=s);return i}function Tc(n,t,e){let i=n[e]/t[e];for(let s=0;s<n.length;s++)n[s]-=i*t[s]}function Ro(n,t){let e=t.length;for(let i=0;i<e;i++)for(let s=0;s<=i;s++){let r=n[i][s];for(let o=0;o<s;o++)r-=n[i][o]*n[s][o];n[i][s]=i===s?Math.sqrt(r):r/n[s][s]}for(let i=0;i<e;i++){for(let s=0;s<i;s++)t[i]-=n[i][s]*t[s];t[i]/=n[i][i]}for(let i=e-1;i>=0;i--){for(let s=i+1;s<e;s++)t[i]-=n[s][i]*t[s];t[i]/=n[i][i]}return t}function ei(n,t=-1){let e=n.map((a,l)=>l).filter(a=>a!==t);if(!e.length)return[];let i=n[0].map((a,l)=>e.map(c=>n[c][l])),{values:s,vectors:r}=rn(i,e.length),o=1e-5*Math.max(s[0],1e-12);return r.filter((a,l)=>s[l]<=o).map(a=>n.map((l,c)=>c===t?0:a[e.indexOf(c)]))}var Wc={};oe(Wc,{circlePoints:()=>lf,freeJoints:()=>cf,isThere:()=>rr,otherWays:()=>Vc,randomPose:()=>Oo,reach:()=>An,spareJoints:()=>af,traceCircle:()=>Gc});var zc={};oe(zc,{asked:()=>Re,fullRank:()=>sr,holdVerdict:()=>Fo,rankOf:()=>Oc,rankVerdict:()=>Do,stopVerdict:()=>Uo,tableVerdict:()=>kc,waysVerdict:()=>Bc});var Lc={};oe(Lc,{sameArm:()=>Ic});var Hi=1e-9,Po=-1;function Zd(n){let t=yt(n),e=t.flatMap((o,a)=>n.rows[o].kind==="prismatic"?[a]:[]),i=t.map(()=>0);if(!e.length)return Co(n,i);let s=qd(Co(n,i)),r=e.map(o=>{let a=t.map((c,h)=>+(h===o));return qd(Co(n,a)).map((c,h)=>Math.abs(c-s[h])<Hi?0:c-s[h])});return Yg(r,s).forEach((o,a)=>i[e[a]]=-o),Co(n,i)}function Yg(n,t){let e=t.map((a,l)=>n.map(c=>c[l])),{values:i,vectors:s}=rn(e,n.length),r=n.map(a=>a.reduce((l,c,h)=>l+c*t[h],0)),o=n.map(()=>0);return i.forEach((a,l)=>{if(a<=Hi*i[0])return;let c=s[l].reduce((h,u,f)=>h+u*r[f],0)/(a*a);s[l].forEach((h,u)=>o[u]+=c*h)}),o}var qd=n=>[...n.flatMap(({normal:t})=>t),...n.flatMap(({offset:t,fromBase:e})=>t===null||e?[]:[t])];function Co(n,t){let e=qt(n,t),i=yt(n),s=i.length,r=i.map(g=>e[g].z),o=i.map(g=>e[g].o),a=i.flatMap((g,_)=>n.rows[g].kind==="revolute"?[_]:[]),l=[...a,s],c=(g,_)=>Array.from({length:Math.max(0,Math.min(_+1,s)-g)},(m,d)=>g+d),h={offset:null,bunch:[],fromBase:!0,toTip:!1},u=[Yd(r,c(0,l[0]),[0,0,0],h)],f=a.length?jd([0,0,0],[0,0,1],o[l[0]],r[l[0]])[1]:[0,0,0],p=[];return a.forEach((g,_)=>{let m=l[_+1],d=m===s;p.length||(f=Cc(o[g],r[g],f));let[y,w]=d?[e.at(-1).o,null]:[o[m],r[m]],[M,E]=jd(f,r[g],y,w);p=[...p,g];let T=!d&&Jd(r[g],r[m]),x=T?null:pe(r[g],At(M,f)),v=p[0]===a[0];u.push(Yd(r,c(g,m),At(E,M),{offset:x,bunch:p,fromBase:v,toTip:d})),f=E,T||(p=[])}),u}function Rc(n,t){return t?n.flatMap((e,i)=>Rc(n.slice(i+1),t-1).map(s=>[e,...s])):[[]]}function Yd(n,t,e,i){let s=$t(e),r=new Map(t.map(a=>[a,n[a]]));s>Hi&&r.set(Po,Ct(1/s,e));let o=new Map;for(let[a,l]of Rc(t,2))o.set(`${[a,l]}`,pe(n[a],n[l]));for(let a of Rc([...r.keys()],3)){let[l,c,h]=a.map(u=>r.get(u));o.set(`${a}`,pe(ve(l,c),h))}return{joints:t,normal:e,length:s,shape:o,...i}}var Cc=(n,t,e)=>Gt(n,Ct(pe(t,At(e,n)),t));function jd(n,t,e,i){if(!i)return[Cc(n,t,e),e];if(Jd(t,i))return[n,Cc(e,i,n)];let s=At(e,n),r=pe(t,i),o=1-r*r,a=(pe(t,s)-r*pe(i,s))/o,l=(r*pe(t,s)-pe(i,s))/o;return[Gt(n,Ct(a,t)),Gt(e,Ct(l,i))]}var Jd=(n,t)=>$t(ve(n,t))<Hi;function Kd(n){let t=yt({rows:n}),e=t.map(i=>i+1);return{rows:n,joints:e,gaps:Zd({rows:n}),tilt:Zg({rows:n},t),...jg(n,t[0])}}function jg(n,t){let{z:e,o:i}=qt({rows:n.slice(0,t)},[]).at(-1),s=ve([0,0,1],e),r=$t(s)>Hi?Math.abs(pe(i,s))/$t(s):Math.hypot(i[0],i[1]);return{foot:[n[t].kind==="revolute"?r:0,Io(Math.abs(e[2]))],axis:e,up:e[2]<-Hi?-1:1}}function Zg(n,t){let e=qt(n,t.map(()=>0));return pe(e[t.at(-1)].z,e.at(-1).z)}var Io=n=>Math.acos(Math.max(-1,Math.min(1,n)));var Jg=1e-6,Pc=1e-4;function Ic(n,t){let e=o=>yt(o).map(a=>o.rows[a].kind).join();if(!yt(n).length||e(n)!==e(t))return!1;let[i,s]=[n,t].map(({rows:o})=>Kd(o.map(Kg)));if(!er(i.foot[0],s.foot[0])||!er(i.foot[1],s.foot[1],Pc))return!1;let r=[[]];return i.gaps.forEach((o,a)=>{for(let l of o.joints)r=r.flatMap(c=>c[l]?[c]:[1,-1].map(h=>Object.assign([...c],{[l]:h})));r=r.filter(l=>Qg(o,s.gaps[a],l))}),r.length>0}var er=(n,t,e=Jg)=>Math.abs(n-t)<=e,Kg=n=>({...n,alpha:Qd(n.alpha),theta:Qd(n.theta)});function Qd(n){let t=Math.round(n/(Math.PI/2))*Math.PI/2;return Math.abs(n-t)<Pc?t:n}function Qg(n,t,e){if(!er(n.length,t.length))return!1;for(let[i,s]of n.shape){if(!t.shape.has(i))continue;let r=i.split(",").map(Number),o=r.reduce((c,h)=>c*(h===Po?1:e[h]),t.shape.get(i)),[a,l]=r.length===2?[Io(s),Io(o)]:[s,o];if(!er(a,l,Pc))return!1}return n.fromBase||n.offset===null||t.offset===null?n.offset===null==(t.offset===null):er(n.offset,e[n.joints[0]]*t.offset)}var Fc={};oe(Fc,{entryText:()=>ir,fixed:()=>Kt,isAngle:()=>Vn,jointText:()=>_i,limitText:()=>Uc,listed:()=>ni,motionText:()=>Lo,quantityOf:()=>Nc,short:()=>Gn,sparse:()=>nr,spokenJoint:()=>Dc});function Kt(n,t){return(Math.abs(n)<.5*10**-t?0:n).toFixed(t).replace("-","−")}var nr=(n,t)=>Math.abs(n)<1e-12?"0":Kt(n,t),Vn=n=>n.kind!=="prismatic",Nc=n=>Vn(n)?"angle":"length";function _i(n,t,e){return Vn(n)?e==="deg"?`${Kt(t*180/Math.PI,1)}°`:`${Kt(t,3)} rad`:`${Kt(t,3)} m`}function Dc(n,t,e){if(!Vn(n))return`${Kt(t,3)} metres`;let[i,s]=e==="deg"?[Kt(t*180/Math.PI,1),"degrees"]:[Kt(t,3),"radians"];return`${i.replace("−","minus ")} ${s}`}var Uc=(n,t,e)=>Vn(n)&&e==="deg"?`${Kt(t*180/Math.PI,0)}°`:`${Gn(t,2)} ${Vn(n)?"rad":"m"}`;function ir(n,t,e){if(!t)return Gn(n,6);if(e==="deg")return Gn(n*180/Math.PI,4);let i=n*12/Math.PI;if(n===0||Math.abs(i-Math.round(i))>1e-9)return Gn(n,6);let s=Math.round(i),r=[12,6,4,3,2,1].find(c=>s%c===0),[o,a]=[s/r,12/r],l=Math.abs(o)===1?`${o<0?"-":""}π`:`${o}π`;return(a===1?l:`${l}/${a}`).replace("-","−")}var Gn=(n,t)=>String(Number(n.toFixed(t))+0).replace("-","−"),t0=["move along x","move along y","move along z","turn about x","turn about y","turn about z"];function Lo(n){let t=n.flatMap((i,s)=>Math.abs(i)>.02?[[i,t0[s]]]:[]);if(t.length===1)return t[0][1];let e=Math.sign(t[0][0]);return t.map(([i,s])=>`${Kt(e*i,2)} ${s.replace("move ","").replace("turn ","")}`).join(", ")}function ni(n,t="and"){return n.length<2?n.join(""):`${n.slice(0,-1).join(", ")} ${t} ${n.at(-1)}`}var e0=1e-6,Re=n=>yt(n).length<6?3:6,Oc=n=>n.filter(t=>t>e0*n[0]).length,sr=n=>Math.min(Re(n),yt(n).length);function Do({arm:n,rank:t,lost:e}){let[i,s,r]=[sr(n),Re(n),yt(n).length];return r?t<i?{singular:!0,text:`Singular: rank ${t} of ${i}. ${n0(e,i<s)}`}:i===6?{singular:!1,text:"Rank 6: the tip can move along and turn about every direction."}:i<3?{singular:!1,text:`Rank ${t}, the most that ${r===1?"one joint":`${r} joints`} can have.`}:{singular:!1,text:"Rank 3: the tip can move along every direction; with fewer than six joints it cannot be turned at will as well."}:{singular:!1,text:"No joint moves this arm."}}var tf=n=>n.filter(t=>Math.abs(t)>.02).length;function n0(n,t){if(!n.length||t)return"";let e=n.filter(s=>tf(s)===1).map(Lo),i=n.filter(s=>tf(s)>1).map(s=>`make the motion ${Lo(s)}`);return`Here the tip cannot ${ni([...e,...i],"nor")}.`}var i0=["No way","One way","Two ways","Three ways","Four ways","Five ways","Six ways","Seven ways","Eight ways"],ef=n=>i0[n]??`${n} ways`,nf=(n,t)=>ni(t.map(e=>`joint ${yt(n)[e]+1}`));function Bc(n,{list:t,families:e=[],held:i=-1,whole:s=!0}){let r=s?"pose":"place, whatever the tool’s direction",o=t.length-e.length,a=i<0?"":` with joint ${yt(n)[i]+1} held where it is; free, it makes them infinitely many`;if(!e.length)return`${ef(t.length)} to this ${r}${a}.`;let l=e[0].moving,c=l.length===1?`${nf(n,l)} is free`:`${nf(n,l)} are free to move together`,h=e.length>1?`, in ${e.length} families`:"",u=o?` and ${ef(o).toLowerCase()} more`:"",f=i<0?"":`, joint ${yt(n)[i]+1} held`;return`Infinitely many ways to this ${r}: ${c}${h}; one of each is shown${u}${f}.`}function Uo({stops:n=[],short:t=0}){if(t<.002)return"";let e=n.length?ni(n):"out of reach";return`${e[0].toUpperCase()}${e.slice(1)}: ${Kt(1e3*t,0)} mm short.`}function Fo(n){if(!n?.target)return"";let t=n.moving?"":Uo(n);if(t||!n.fading?.length)return t;let e=n.fading.length>1?"the arrows":"the arrow";return n.fading.every(({share:s})=>s<.001)?`Singular: the tip cannot move along ${e}.`:`Nearly singular along ${e}.`}var s0="Type into any entry: 0.333, −90°, pi/2, or paste a whole table. The arm follows, and the first one stays as a ghost.";function kc({arm:n,reference:t,q:e},{frames:i}){if(n===t)return s0;let s=[n,t].map(f=>yt(f).length);if(s[0]!==s[1])return`Yours has ${s[0]} joints, the ${t.name} ${s[1]}.`;let[r,o]=[i.at(-1),qt(t,e).at(-1)],a=(pe(r.x,o.x)+pe(r.y,o.y)+pe(r.z,o.z)-1)/2,l=Math.acos(Math.max(-1,Math.min(1,a)))*180/Math.PI,c=1e3*$t(At(r.o,o.o)),u=`at these joint values its tip is ${`${Kt(c,1)} mm and ${Kt(l,1)}°`} away from the ghost’s`;return r0(n,t)?c<.05&&l<.05?`The same arm as the ${t.name}: ${u}.`:`The same arm as the ${t.name}, with another zero, direction or frame that is free to choose: ${u}, but other joint values bring it there.`:`Another arm than the ${t.name}: ${u}.`}var No={arm:null,reference:null,is:!1};function r0(n,t){return(No.arm!==n||No.reference!==t)&&(No={arm:n,reference:t,is:Ic(n,t)}),No.is}var af=n=>Math.max(0,yt(n).length-Re(n));function o0(n,t){let e=["x","y","z"].reduce((i,s)=>Gt(i,ve(n[s],t[s])),[0,0,0]);return[...At(t.o,n.o),...Ct(.5,e)]}function An(n,t,e,{held:i=-1,steps:s=60}={}){let r=[...t],o=Re(n);for(let a=0;;a++){let l=qt(n,r),c=o0(l.at(-1),e).slice(0,o),h=$t(c);if(h<1e-11||a===s||!r.length)return{q:r,error:h};let u=ze(n,l).map((d,y)=>y===i?d.map(()=>0):d),f=.02*h*h+1e-12,p=c.map((d,y)=>c.map((w,M)=>u.reduce((E,T)=>E+T[y]*T[M],y===M?f:0))),g=Sc(p,c),_=u.map(d=>g.reduce((y,w,M)=>y+d[M]*w,0)),m=Math.max(1e-12,..._.map(Math.abs));r=r.map((d,y)=>d+_[y]*Math.min(1,.6/m))}}var a0={x:[[0,1,0],[0,0,1]],y:[[1,0,0],[0,0,1]],z:[[1,0,0],[0,1,0]]};function lf(n,{normal:t="x",radius:e=.1,count:i=181}={}){let[s,r]=a0[t],o=At(n,Ct(e,r));return Array.from({length:i},(a,l)=>{let c=2*Math.PI*l/(i-1);return Gt(o,Gt(Ct(e*Math.sin(c),s),Ct(e*Math.cos(c),r)))})}var sf=.05;function l0(n,t,e,i){let s=An(n,t,e,i);if(s.error<1e-6)return s;let r=s.q.every((o,a)=>Math.abs(o-t[a])<1e-6);for(let o of r?t.keys():[])for(let a of[sf,-sf]){let l=An(n,t.map((c,h)=>h===o?c+a:c),e,i);l.error<.98*s.error&&(s=l)}return s}function Gc(n,t,e={}){let i=qt(n,t).at(-1),s=lf(i.o,e),r=[],[o,a]=[t,0];for(let l of s)o=l0(n,o,{...i,o:l},{steps:40}).q,a=Math.max(a,$t(At(qt(n,o).at(-1).o,l))),r.push(o);return{path:r,stray:a,wanted:s}}function c0(n){return()=>(n=Math.imul(n,1664525)+1013904223>>>0)/2**32}function Oo(n,t=Math.random){return yt(n).map(e=>{let[i,s]=Tn(n.rows[e]);return i+(s-i)*t()})}var h0=16;function Vc(n,t,e=300){let i=qt(n,t).at(-1),s=Re(n)===6;if(!Je(n,t)||!t.length)return{list:[],families:[],held:-1,target:i,whole:s};let r=af(n)?2:-1,o=c0(1),a=[],l=[],c=h=>{if(a.some(f=>u0(n,f,h))||l.some(f=>Hc(n,f,h)<.001))return;let u=cf(n,h,i,r);l.push(h),u.length&&a.push({moving:u,q:h})};c(of(n,t));for(let h=0;h<e&&l.length<h0;h++){let u=Oo(n,o).map((g,_)=>_===r?t[_]:g),{q:f,error:p}=An(n,u,i,{held:r});p<1e-9&&c(of(n,f))}return{list:l.map(h=>({q:h})),families:a,held:r,target:i,whole:s}}var rf=.1;function cf(n,t,e,i=-1){let s=Re(n),r=ze(n,qt(n,t)).map((c,h)=>h===i?c.map(()=>0):c),{values:o}=rn(r.map(c=>c.slice(0,s)),s),a=yt(n).length-(i<0?0:1);if(o.filter(c=>c>1e-5*o[0]).length>=Math.min(s,a))return[];let l=new Set;for(let c of ei(r.map(h=>h.slice(0,s)),i)){let h=An(n,t.map((u,f)=>u+rf*c[f]),e,{held:i,steps:200});h.error>1e-9||Hc(n,h.q,t)<.3*rf||h.q.forEach((u,f)=>Math.abs(u-t[f])>.001&&l.add(f))}return[...l].sort((c,h)=>c-h)}var u0=(n,{moving:t,q:e},i)=>Hc(n,e,i.map((s,r)=>t.includes(r)?e[r]:s))<.001;function of(n,t){return yt(n).map((e,i)=>{if(n.rows[e].kind!=="revolute")return t[i];let[s,r]=Tn(n.rows[e]),o=Math.atan2(Math.sin(t[i]),Math.cos(t[i]));return[o,o+2*Math.PI,o-2*Math.PI].find(a=>a>=s&&a<=r)??o})}function Hc(n,t,e){let i=(s,r)=>n.rows[s].kind==="revolute"?2*Math.sin((t[r]-e[r])/2):t[r]-e[r];return Math.max(...yt(n).map((s,r)=>Math.abs(i(s,r))))}var rr=(n,t)=>n.length===t.length&&n.every((e,i)=>Math.abs(e-t[i])<1e-4);var uf={method:"euler",rates:"inverse",steps:1e3,seconds:5,radius:.1,normal:"x",gain:0,cutoff:1e-9,damping:.02,locked:2,slip:""},hf={x:[0,1,0],y:[-1,0,0]},Xc=[0,0,1];function Bo(n,{radius:t,normal:e,seconds:i},s){let r=2*Math.PI*s,o=At(n,Ct(t,Xc)),[a,l]=[Math.sin(r),Math.cos(r)],c=2*Math.PI*t/i;return{o:Gt(o,Gt(Ct(t*a,hf[e]),Ct(t*l,Xc))),v:Gt(Ct(c*l,hf[e]),Ct(-c*a,Xc))}}function d0(n,t,e){if(e==="angular"){let s=yt(n).map(r=>n.rows[r].kind==="revolute"?t[r+1].z:[0,0,0]);return ze(n,t).map((r,o)=>[...r.slice(0,3),...s[o]])}if(e!=="z_i"&&e!=="o_i")return ze(n,t);let i=t.at(-1).o;return yt(n).map(s=>{let{z:r}=t[e==="z_i"?s+1:s],{o}=t[s+1];return n.rows[s].kind==="revolute"?[...ve(r,At(i,o)),...r]:[...r,0,0,0]})}var ko=class extends Error{};function f0(n,t,{rates:e,cutoff:i,damping:s,locked:r}){let o=n.map((u,f)=>f).filter(u=>u!==r),{values:a,vectors:l}=rn(o.map(u=>n[u])),c=e==="pseudo"?i*a[0]:0;if(e==="inverse"&&a[Math.min(5,o.length-1)]<=1e-9*a[0])throw new ko;let h=n.map(()=>0);return a.forEach((u,f)=>{if(u<=c||u<1e-14)return;let g=l[f].reduce((_,m,d)=>_+m*t[d],0)/(e==="damped"?u*u+s*s:u*u);for(let _ of o)h[_]+=g*n[_].reduce((m,d,y)=>m+d*l[f][y],0)}),{found:h,least:a[Math.min(5,o.length-1)]}}function p0(n,t,e){let i=["x","y","z"].reduce((s,r)=>Gt(s,ve(n[r],e[r])),[0,0,0]);return[...At(t,n.o),...Ct(.5,i)]}var m0=181;function zo(n,t,e={}){let i={...uf,...e};i.method==="exact"&&(i.rates="pseudo");let s=qt(n,t).at(-1),r=i.seconds/i.steps,o=Math.max(1,Math.ceil(i.steps/(m0-1))),a={path:[t],errors:[0],at:[0]},[l,c,h,u,f,p]=[[...t],1/0,0,0,null,0],g=(m,d)=>{let y=qt(n,d),{o:w,v:M}=Bo(s.o,i,m),E=i.gain?p0(y.at(-1),w,s):[0,0,0,0,0,0],T=[...M,0,0,0].map((C,R)=>C+i.gain*E[R]),{found:x,least:v}=f0(d0(n,y,i.slip),T,i);return c=Math.min(c,v),i.slip==="sign"?x.map(C=>-C):x},_=(m,d,y)=>m.map((w,M)=>w+y*d[M]);for(let m=0;m<i.steps&&f===null;m++){let[d,y]=[m/i.steps,(m+1)/i.steps];try{let E=g(i.slip==="next"?y:d,l);if(u=Math.max(u,...E.map(Math.abs)),i.method==="exact")l=An(n,l,{...s,o:Bo(s.o,i,y).o},{held:i.locked,steps:40}).q;else if(i.method==="rk4"){let T=g(d+.5/i.steps,_(l,E,r/2)),x=g(d+.5/i.steps,_(l,T,r/2)),v=g(y,_(l,x,r));l=l.map((C,R)=>C+r/6*(E[R]+2*T[R]+2*x[R]+v[R]))}else l=_(l,E,r)}catch(E){if(!(E instanceof ko))throw E;f=m;break}let w=qt(n,l).at(-1),M=$t(At(w.o,Bo(s.o,i,y).o));p=Math.max(p,Math.atan2($t(ve(w.z,s.z)),pe(w.z,s.z))),Number.isFinite(M)||(f=m),h=Math.max(h,M),((m+1)%o===0||m+1===i.steps)&&(a.path.push(l),a.errors.push(M),a.at.push(y))}return{...a,run:i,largest:h,least:c,fastest:u,failed:f,tilt:p,wound:l.map((m,d)=>n.rows[yt(n)[d]].kind==="revolute"?(m-t[d])/(2*Math.PI):0)}}function qc(n,t,e={},i=df(.1)){return i.map(s=>{let{wound:r,least:o,largest:a}=zo(n,t,{...e,method:"exact",steps:90,radius:s}),l=r.reduce((c,h)=>Math.abs(h)>Math.abs(c)?h:c,0);return{radius:s,turns:Math.round(l),least:o,reached:a<1e-6}})}var df=(n,t=37)=>Array.from({length:t},(e,i)=>.01+(n-.01)*i/(t-1));function Yc(n,t,e,i=""){let s=i==="centres"?x0(n):n,r=i==="wrench"?-1:1;return t.map(o=>{let a=qt(n,o),l=Ys(ze(n,a),e);return qs(s,a).map((c,h)=>c-r*l[h])})}var g0=[[.003875,.002081,-.04762],[-.003141,-.02872,.003495],[.027518,.039252,-.066502],[-.05317,.104419,.027454],[-.011953,.041065,-.038437],[.060149,-.014117,-.010517],[.010517,-.004252,.061597]],ff=({name:n,rows:t})=>n.startsWith("Panda")&&t.length===7&&t.every(e=>e.body),x0=n=>ff(n)?{...n,rows:n.rows.map((t,e)=>({...t,body:[t.body[0],...g0[e]]}))}:n,_0={method:["euler","rk4","exact"],rates:["inverse","pseudo","damped"],normal:["x","y"],slip:["","angular","z_i","o_i","sign","next"]},$c={steps:[10,1e4],seconds:[1,60],radius:[.01,.1],gain:[0,20],cutoff:[1e-9,.1],damping:[.001,.2],locked:[-1,15]},or=["method","rates","steps","seconds","radius","normal","gain","cutoff","damping","locked","slip"],jc=n=>or.map(t=>n[t]).join("_");function Zc(n){let t=n.split("_");if(t.length>or.length&&t.at(-2)==="z"&&t.splice(-2,2,"z_i"),t.length>or.length&&t.at(-2)==="o"&&t.splice(-2,2,"o_i"),t.length!==or.length)return null;let e={};for(let[i,s]of or.entries()){let r=_0[s];if(e[s]=r?t[i]:t[i].trim()?Number(t[i]):NaN,r&&!r.includes(t[i])||!r&&!(e[s]>=$c[s][0]&&e[s]<=$c[s][1]))return null}for(let i of["steps","locked"])if(!Number.isInteger(e[i]))return null;return e}var pf=4e3,mf=Object.fromEntries(ls.map(n=>[n[0].toUpperCase(),n])),y0=1e5,v0=8,Vo=n=>n?n.split(",").map(t=>t.trim()?Number(t):NaN):[],Go=n=>n.map(t=>Number(t.toFixed(6))+0).join(","),Kc=(n,t)=>t.includes(n)?n:null;function gf({arm:n,base:t,q:e,wrench:i,unit:s,view:r,frames:o,mark:a,runs:l=[]}){let c={arm:t.name,q:Go(e),view:r,unit:s,frames:o};if(i.some(Boolean)&&(c.wrench=Go(i)),n!==t){let h=u=>`${u.kind[0].toUpperCase()},${Go([u.a,u.alpha,u.d,u.theta])}`;c.rows=n.rows.map(h).join(";")}return a&&(c.mark=Go(a)),r==="homework"&&l.length&&(c.runs=l.map(jc).join(";")),`#${new URLSearchParams(c)}`}function M0(n,t,e){let i=n.replace(/^#/,"");if(!i||!/(^|&)arm=/.test(i))return{patch:{},words:""};if(i.length>pf)return Qc(`it has ${i.length} characters; ${pf} are the most`);let s=new URLSearchParams(i),r=t.find(m=>m.name===s.get("arm"));if(!r)return Qc(`there is no arm called “${s.get("arm").slice(0,40)}” here`);let o=b0(s.get("rows")),a=o&&Ks(o),l=o&&!a?Qs(o,r):r,c=a?[a]:[],h={arm:l,base:r,reference:r},u=Vo(s.get("q"));h.q=Je(l,u)?u:Vi(l),s.has("q")&&h.q!==u&&!a&&c.push(`${l.name} has ${yt(l).length} joint values`);let f=Vo(s.get("wrench"));f.length===6&&f.every(m=>Math.abs(m)<=y0)?h.wrench=f:s.has("wrench")&&c.push("its wrench is not six numbers in N and N m");let p=Vo(s.get("mark"));h.mark=p.length===3&&p.every(m=>Math.abs(m)<=Js)?p:null,!h.mark&&s.has("mark")&&c.push("its mark is no place in metres");let g=(s.get("runs")?.split(";")??[]).map(Zc);g.length>v0||g.includes(null)?c.push("its runs are none that the homework could make"):g.length&&(h.runs=g);let _={view:Kc(s.get("view"),e),unit:Kc(s.get("unit"),["deg","rad"]),frames:Kc(s.get("frames"),["all","ends"])};for(let[m,d]of Object.entries(_))d&&(h[m]=d);return c.length?{...Qc(c.join("; ")),patch:h}:{patch:h,words:""}}var Qc=n=>({patch:{},words:`Part of the link was left out: ${n}.`});function b0(n){return n===null?null:n.split(";").map(t=>{let[e,...i]=t.split(","),[s,r,o,a]=i.length===4?Vo(i.join(",")):[];return{kind:Object.hasOwn(mf,e)?mf[e]:null,a:s,alpha:r,d:o,theta:a}})}function xf(n,t,e,i,s){let r=()=>{let{patch:a,words:l}=M0(location.hash,t,e);n.dispatch({type:"set",...a},"link"),i(l)},o;return r(),addEventListener("hashchange",r,{signal:s}),n.listen((a,l)=>{n.state.dragging||(clearTimeout(o),l!=="link"&&(o=setTimeout(()=>history.replaceState(null,"",gf(n.state)),400)))},s),s.addEventListener("abort",()=>clearTimeout(o)),{async copy(){return history.replaceState(null,"",gf(n.state)),await navigator.clipboard?.writeText(location.href).then(()=>!0,()=>!1)??!1}}}var oh={};oe(oh,{lateReader:()=>sh,lateView:()=>ih,mountFigure:()=>Wo,registerFigure:()=>nh,registerReader:()=>w0,registerView:()=>S0});var Ho={},th={},yf=typeof document>"u"?null:document.currentScript?.src,vf="explorer-more.js",_f={},eh=null;function nh(n,t){Ho[n]=t}function S0(n,t){th[n]=t}async function ih(n){return Object.hasOwn(th,n)||await rh(vf),th[n]}var w0=n=>{eh=n};async function sh(){return eh||await rh("explorer-table.js"),eh}function rh(n){return _f[n]??=new Promise((t,e)=>{let i=new URL(n,yf).href,s=()=>t();document.head.append(Object.assign(document.createElement("script"),{src:i,onload:s,onerror:e}))}),_f[n]}function Wo(n,t){let e=!1,i=()=>{},s=()=>{!e&&Object.hasOwn(Ho,t.figure)&&(i=Ho[t.figure](n,t))};return Object.hasOwn(Ho,t.figure)?s():yf&&rh(vf).then(s,()=>{}),()=>{e=!0,i()}}var lh={};oe(lh,{common:()=>ah});var Mf=`/* What the instrument and the small figures have in common: colours, controls, the picture. */
.explorer,
.live {
  --ink: #1f2933;
  --soft: #5b6775;
  --line: #dde2e8;
  --ground: #ffffff;
  --raised: #f6f8fa;
  --accent: #24618c;
  --on-accent: #fff;
  --plus: 230 159 0;
  --minus: 0 114 178;
  --bad: #a83a08;
  --bad-ground: #fdf0e8;
  --good: #1a7f4b;
  --rail: #d4dae1;
  --x: #b94f00;
  --y: #007a5a;
  --z: #005e94;
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
.explorer[data-theme="dark"],
.live[data-theme="dark"] {
  --ink: #e4e8ed;
  --soft: #a3adba;
  --line: #38404a;
  --ground: #171b21;
  --raised: #1f252d;
  --accent: #7fb8e2;
  --on-accent: #10202c;
  --plus: 240 180 41;
  --minus: 86 180 233;
  --bad: #ffab7a;
  --bad-ground: #3a2417;
  --good: #6fcf97;
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
.axis-y {
  color: var(--y);
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
  background: linear-gradient(
    to right,
    var(--rail) var(--low, 0%),
    var(--accent) var(--low, 0%) var(--high, 0%),
    var(--rail) var(--high, 0%)
  );
}
input[type="range"]::-moz-range-track {
  height: 4px;
  border-radius: 2px;
  background: linear-gradient(
    to right,
    var(--rail) var(--low, 0%),
    var(--accent) var(--low, 0%) var(--high, 0%),
    var(--rail) var(--high, 0%)
  );
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
.rail {
  touch-action: pan-y;
  cursor: pointer;
}
.grip {
  position: absolute;
  left: 0;
  top: 0;
  width: 30px;
  height: 30px;
  margin: -15px;
  padding: 0;
  min-height: 0;
  border: 1.5px dashed transparent;
  border-radius: 50%;
  background: none;
  touch-action: none;
  cursor: grab;
}
.paper {
  display: none;
}
@media print {
  .explorer,
  .live {
    display: none !important;
  }
  .paper {
    display: block;
  }
}
`;var ah=Mf;var ch={};oe(ch,{attribute:()=>me,calm:()=>lr,h:()=>U,indexed:()=>Xe,svg:()=>ii,whereNew:()=>ar,write:()=>ae});function U(n,t={},...e){let[i,...s]=n.split("."),r=document.createElement(i);s.length&&(r.className=s.join(" "));for(let[o,a]of Object.entries(t))o.startsWith("on")?r.addEventListener(o.slice(2),a):a!==void 0&&a!==!1&&r.setAttribute(o,a===!0?"":a);return r.append(...e.flat()),r}function ii(n,t={},...e){let i=document.createElementNS("http://www.w3.org/2000/svg",n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}function ae(n,t){n.textContent!==t&&(n.textContent=t)}function me(n,t,e){n.getAttribute(t)!==e&&n.setAttribute(t,e)}function ar(n,t){let e=[];return i=>{let s=n(i);e.length&&s.every((r,o)=>r===e[o])||(e=s,t(i))}}var Xe=(n,t)=>[U("i",{},n),U("sub",{},String(t))],lr=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;var Ku={};oe(Ku,{followTip:()=>Zu,makeGrabbable:()=>ju,moveTip:()=>ec,moveTipByKey:()=>Ju});var Xu={};oe(Xu,{Figure:()=>rs,beforeDrawing:()=>Kl,emptied:()=>uo,forget:()=>Ql,freed:()=>ho,inUse:()=>Vu,loseContext:()=>Hu});var Li={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Ni={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},Qf=0,Vh=1,tp=2;var Ji=1,ep=2,Ds=3,Di=0,nn=1,Ye=2,Ki=0,Us=1,Hh=2,Wh=3,Xh=4,np=5;var Qi=100,ip=101,sp=102,rp=103,op=104,ap=200,lp=201,cp=202,hp=203,$h=204,qh=205,up=206,dp=207,fp=208,pp=209,mp=210,gp=211,xp=212,_p=213,yp=214,ma=0,ga=1,xa=2,Ss=3,_a=4,ya=5,va=6,Ma=7,Yh=0,vp=1,Mp=2,qn=0,jh=1,Zh=2,Jh=3,Kh=4,Qh=5,tu=6,eu=7;var nu=300,ts=301,Fs=302,el=303,nl=304,ba=1e3,Wn=1001,Sa=1002,Oe=1003,bp=1004;var Xr=1005;var tn=1006,il=1007;var fi=1008;var ln=1009,iu=1010,su=1011,Os=1012,sl=1013,Dn=1014,Un=1015,Fn=1016,rl=1017,ol=1018,es=1020,ru=35902,ou=35899,au=1021,lu=1022,On=1023,hi=1026,pi=1027,cu=1028,al=1029,Ui=1030,ll=1031;var cl=1033,$r=33776,qr=33777,Yr=33778,jr=33779,hl=35840,ul=35841,dl=35842,fl=35843,pl=36196,ml=37492,gl=37496,xl=37488,_l=37489,Zr=37490,yl=37491,vl=37808,Ml=37809,bl=37810,Sl=37811,wl=37812,El=37813,Tl=37814,Al=37815,Rl=37816,Cl=37817,Pl=37818,Il=37819,Ll=37820,Nl=37821,Dl=36492,Ul=36494,Fl=36495,Ol=36283,Bl=36284,Jr=36285,kl=36286;var yr=2300,wa=2301,fa=2302,Dh=2303,Uh=2400,Fh=2401,Oh=2402;var Sp=3200;var zl=0,wp=1,mi="",fn="srgb",vr="srgb-linear",Mr="linear",ne="srgb";var pa=7680;var Ep=519,Tp=512,Ap=513,Rp=514,hu=515,Cp=516,Pp=517,uu=518,du=519,Ip=35044,fu=35048;var pu="300 es",Mn=2e3,ws=2001;function T0(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function A0(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function br(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Lp(){let n=br("canvas");return n.style.display="block",n}var bf={},Es=null;function mu(...n){let t="THREE."+n.shift();Es?Es("log",t,...n):console.log(t,...n)}function Np(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Pt(...n){n=Np(n);let t="THREE."+n.shift();if(Es)Es("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Dt(...n){n=Np(n);let t="THREE."+n.shift();if(Es)Es("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function pr(...n){let t=n.join(" ");t in bf||(bf[t]=!0,Pt(...n))}function Dp(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var Up={[ma]:ma,[xa]:va,[_a]:_a,[Ss]:ya,[ga]:ga,[va]:xa,[Ma]:Ma,[ya]:Ss},Ln=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},$e=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Sf=1234567,mr=Math.PI/180,Ts=180/Math.PI;function Bs(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return($e[n&255]+$e[n>>8&255]+$e[n>>16&255]+$e[n>>24&255]+"-"+$e[t&255]+$e[t>>8&255]+"-"+$e[t>>16&15|64]+$e[t>>24&255]+"-"+$e[e&63|128]+$e[e>>8&255]+"-"+$e[e>>16&255]+$e[e>>24&255]+$e[i&255]+$e[i>>8&255]+$e[i>>16&255]+$e[i>>24&255]).toLowerCase()}function Wt(n,t,e){return Math.max(t,Math.min(e,n))}function gu(n,t){return(n%t+t)%t}function R0(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function C0(n,t,e){return n!==t?(e-n)/(t-n):0}function gr(n,t,e){return(1-e)*n+e*t}function P0(n,t,e,i){return gr(n,t,1-Math.exp(-e*i))}function I0(n,t=1){return t-Math.abs(gu(n,t*2)-t)}function L0(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function N0(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function D0(n,t){return n+Math.floor(Math.random()*(t-n+1))}function U0(n,t){return n+Math.random()*(t-n)}function F0(n){return n*(.5-Math.random())}function O0(n){n!==void 0&&(Sf=n);let t=Sf+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function B0(n){return n*mr}function k0(n){return n*Ts}function z0(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function G0(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function xu(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function V0(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),l=o(e/2),c=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),f=o((t-i)/2),p=r((i-t)/2),g=o((i-t)/2);switch(s){case"XYX":n.set(a*h,l*u,l*f,a*c);break;case"YZY":n.set(l*f,a*h,l*u,a*c);break;case"ZXZ":n.set(l*u,l*f,a*h,a*c);break;case"XZX":n.set(a*h,l*g,l*p,a*c);break;case"YXY":n.set(l*p,a*h,l*g,a*c);break;case"ZYZ":n.set(l*g,l*p,a*h,a*c);break;default:Pt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function _u(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Fp(n,t){if(t.constructor===Float32Array)return n;let e=_u(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function Op(n,t){if(t.constructor===Float32Array)return n;let e=_u(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var yu={DEG2RAD:mr,RAD2DEG:Ts,generateUUID:Bs,clamp:Wt,euclideanModulo:gu,mapLinear:R0,inverseLerp:C0,lerp:gr,damp:P0,pingpong:I0,smoothstep:L0,smootherstep:N0,randInt:D0,randFloat:U0,randFloatSpread:F0,seededRandom:O0,degToRad:B0,radToDeg:k0,isPowerOfTwo:z0,ceilPowerOfTwo:G0,floorPowerOfTwo:xu,setQuaternionFromProperEuler:V0,normalize:Op,denormalize:Fp},_t=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Wt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},en=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let l=i[s+0],c=i[s+1],h=i[s+2],u=i[s+3],f=r[o+0],p=r[o+1],g=r[o+2],_=r[o+3];if(u!==_||l!==f||c!==p||h!==g){let m=l*f+c*p+h*g+u*_;m<0&&(f=-f,p=-p,g=-g,_=-_,m=-m);let d=1-a;if(m<.9995){let y=Math.acos(m),w=Math.sin(y);d=Math.sin(d*y)/w,a=Math.sin(a*y)/w,l=l*d+f*a,c=c*d+p*a,h=h*d+g*a,u=u*d+_*a}else{l=l*d+f*a,c=c*d+p*a,h=h*d+g*a,u=u*d+_*a;let y=1/Math.sqrt(l*l+c*c+h*h+u*u);l*=y,c*=y,h*=y,u*=y}}t[e]=l,t[e+1]=c,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],h=i[s+3],u=r[o],f=r[o+1],p=r[o+2],g=r[o+3];return t[e]=a*g+h*u+l*p-c*f,t[e+1]=l*g+h*f+c*u-a*p,t[e+2]=c*g+h*p+a*f-l*u,t[e+3]=h*g-a*u-l*f-c*p,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,l=Math.sin,c=a(i/2),h=a(s/2),u=a(r/2),f=l(i/2),p=l(s/2),g=l(r/2);switch(o){case"XYZ":this._x=f*h*u+c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u-f*p*g;break;case"YXZ":this._x=f*h*u+c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u+f*p*g;break;case"ZXY":this._x=f*h*u-c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u-f*p*g;break;case"ZYX":this._x=f*h*u-c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u+f*p*g;break;case"YZX":this._x=f*h*u+c*p*g,this._y=c*p*u+f*h*g,this._z=c*h*g-f*p*u,this._w=c*h*u-f*p*g;break;case"XZY":this._x=f*h*u-c*p*g,this._y=c*p*u-f*h*g,this._z=c*h*g+f*p*u,this._w=c*h*u+f*p*g;break;default:Pt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],l=e[9],c=e[2],h=e[6],u=e[10],f=i+a+u;if(f>0){let p=.5/Math.sqrt(f+1);this._w=.25/p,this._x=(h-l)*p,this._y=(r-c)*p,this._z=(o-s)*p}else if(i>a&&i>u){let p=2*Math.sqrt(1+i-a-u);this._w=(h-l)/p,this._x=.25*p,this._y=(s+o)/p,this._z=(r+c)/p}else if(a>u){let p=2*Math.sqrt(1+a-i-u);this._w=(r-c)/p,this._x=(s+o)/p,this._y=.25*p,this._z=(l+h)/p}else{let p=2*Math.sqrt(1+u-i-a);this._w=(o-s)/p,this._x=(r+c)/p,this._y=(l+h)/p,this._z=.25*p}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Wt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,l=e._y,c=e._z,h=e._w;return this._x=i*h+o*a+s*c-r*l,this._y=s*h+o*l+r*a-i*c,this._z=r*h+o*c+i*l-s*a,this._w=o*h-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-e;if(a<.9995){let c=Math.acos(a),h=Math.sin(c);l=Math.sin(l*c)/h,e=Math.sin(e*c)/h,this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this._onChangeCallback()}else this._x=this._x*l+i*e,this._y=this._y*l+s*e,this._z=this._z*l+r*e,this._w=this._w*l+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},N=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(wf.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(wf.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,l=t.w,c=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+l*c+o*u-a*h,this.y=i+l*h+a*c-r*u,this.z=s+l*u+r*h-o*c,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,l=e.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return hh.copy(this).projectOnVector(t),this.sub(hh)}reflect(t){return this.sub(hh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Wt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},hh=new N,wf=new en,Ft=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c)}set(t,e,i,s,r,o,a,l,c){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=l,h[6]=i,h[7]=o,h[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],h=i[4],u=i[7],f=i[2],p=i[5],g=i[8],_=s[0],m=s[3],d=s[6],y=s[1],w=s[4],M=s[7],E=s[2],T=s[5],x=s[8];return r[0]=o*_+a*y+l*E,r[3]=o*m+a*w+l*T,r[6]=o*d+a*M+l*x,r[1]=c*_+h*y+u*E,r[4]=c*m+h*w+u*T,r[7]=c*d+h*M+u*x,r[2]=f*_+p*y+g*E,r[5]=f*m+p*w+g*T,r[8]=f*d+p*M+g*x,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8];return e*o*h-e*a*c-i*r*h+i*a*l+s*r*c-s*o*l}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=h*o-a*c,f=a*l-h*r,p=c*r-o*l,g=e*u+i*f+s*p;if(g===0)return this.set(0,0,0,0,0,0,0,0,0);let _=1/g;return t[0]=u*_,t[1]=(s*c-h*i)*_,t[2]=(a*i-s*o)*_,t[3]=f*_,t[4]=(h*e-s*l)*_,t[5]=(s*r-a*e)*_,t[6]=p*_,t[7]=(i*l-c*e)*_,t[8]=(o*e-i*r)*_,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+t,-s*c,s*l,-s*(-c*o+l*a)+a+e,0,0,1),this}scale(t,e){return pr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(uh.makeScale(t,e)),this}rotate(t){return pr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(uh.makeRotation(-t)),this}translate(t,e){return pr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(uh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},uh=new Ft,Ef=new Ft().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Tf=new Ft().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function H0(){let n={enabled:!0,workingColorSpace:vr,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ne&&(s.r=ci(s.r),s.g=ci(s.g),s.b=ci(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ne&&(s.r=bs(s.r),s.g=bs(s.g),s.b=bs(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===mi?Mr:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[vr]:{primaries:t,whitePoint:i,transfer:Mr,toXYZ:Ef,fromXYZ:Tf,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:fn},outputColorSpaceConfig:{drawingBufferColorSpace:fn}},[fn]:{primaries:t,whitePoint:i,transfer:ne,toXYZ:Ef,fromXYZ:Tf,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:fn}}}),n}var Jt=H0();function ci(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function bs(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var cs,Ea=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{cs===void 0&&(cs=br("canvas")),cs.width=t.width,cs.height=t.height;let s=cs.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=cs}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=br("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ci(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(ci(e[i]/255)*255):e[i]=ci(e[i]);return{data:e,width:t.width,height:t.height}}else return Pt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},W0=0,As=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:W0++}),this.uuid=Bs(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(dh(s[o].image)):r.push(dh(s[o]))}else r=dh(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function dh(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Ea.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Pt("Texture: Unable to serialize Texture."),{})}var X0=0,fh=new N,on=class n extends Ln{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=Wn,s=Wn,r=tn,o=fi,a=On,l=ln,c=n.DEFAULT_ANISOTROPY,h=mi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:X0++}),this.uuid=Bs(),this.name="",this.source=new As(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new _t(0,0),this.repeat=new _t(1,1),this.center=new _t(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ft,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fh).x}get height(){return this.source.getSize(fh).y}get depth(){return this.source.getSize(fh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Pt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Pt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==nu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ba:t.x=t.x-Math.floor(t.x);break;case Wn:t.x=t.x<0?0:1;break;case Sa:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ba:t.y=t.y-Math.floor(t.y);break;case Wn:t.y=t.y<0?0:1;break;case Sa:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};on.DEFAULT_IMAGE=null;on.DEFAULT_MAPPING=nu;on.DEFAULT_ANISOTROPY=1;var ge=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,l=t.elements,c=l[0],h=l[4],u=l[8],f=l[1],p=l[5],g=l[9],_=l[2],m=l[6],d=l[10];if(Math.abs(h-f)<.01&&Math.abs(u-_)<.01&&Math.abs(g-m)<.01){if(Math.abs(h+f)<.1&&Math.abs(u+_)<.1&&Math.abs(g+m)<.1&&Math.abs(c+p+d-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let w=(c+1)/2,M=(p+1)/2,E=(d+1)/2,T=(h+f)/4,x=(u+_)/4,v=(g+m)/4;return w>M&&w>E?w<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(w),s=T/i,r=x/i):M>E?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=T/s,r=v/s):E<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(E),i=x/r,s=v/r),this.set(i,s,r,e),this}let y=Math.sqrt((m-g)*(m-g)+(u-_)*(u-_)+(f-h)*(f-h));return Math.abs(y)<.001&&(y=1),this.x=(m-g)/y,this.y=(u-_)/y,this.z=(f-h)/y,this.w=Math.acos((c+p+d-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Wt(this.x,t.x,e.x),this.y=Wt(this.y,t.y,e.y),this.z=Wt(this.z,t.z,e.z),this.w=Wt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Wt(this.x,t,e),this.y=Wt(this.y,t,e),this.z=Wt(this.z,t,e),this.w=Wt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Wt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Ta=class extends Ln{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:tn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new ge(0,0,t,e),this.scissorTest=!1,this.viewport=new ge(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new on({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:tn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new As(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},pn=class extends Ta{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},Sr=class extends on{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Oe,this.minFilter=Oe,this.wrapR=Wn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var Aa=class extends on{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=Oe,this.minFilter=Oe,this.wrapR=Wn,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ie=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,l,c,h,u,f,p,g,_,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,l,c,h,u,f,p,g,_,m)}set(t,e,i,s,r,o,a,l,c,h,u,f,p,g,_,m){let d=this.elements;return d[0]=t,d[4]=e,d[8]=i,d[12]=s,d[1]=r,d[5]=o,d[9]=a,d[13]=l,d[2]=c,d[6]=h,d[10]=u,d[14]=f,d[3]=p,d[7]=g,d[11]=_,d[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/hs.setFromMatrixColumn(t,0).length(),r=1/hs.setFromMatrixColumn(t,1).length(),o=1/hs.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let f=o*h,p=o*u,g=a*h,_=a*u;e[0]=l*h,e[4]=-l*u,e[8]=c,e[1]=p+g*c,e[5]=f-_*c,e[9]=-a*l,e[2]=_-f*c,e[6]=g+p*c,e[10]=o*l}else if(t.order==="YXZ"){let f=l*h,p=l*u,g=c*h,_=c*u;e[0]=f+_*a,e[4]=g*a-p,e[8]=o*c,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=p*a-g,e[6]=_+f*a,e[10]=o*l}else if(t.order==="ZXY"){let f=l*h,p=l*u,g=c*h,_=c*u;e[0]=f-_*a,e[4]=-o*u,e[8]=g+p*a,e[1]=p+g*a,e[5]=o*h,e[9]=_-f*a,e[2]=-o*c,e[6]=a,e[10]=o*l}else if(t.order==="ZYX"){let f=o*h,p=o*u,g=a*h,_=a*u;e[0]=l*h,e[4]=g*c-p,e[8]=f*c+_,e[1]=l*u,e[5]=_*c+f,e[9]=p*c-g,e[2]=-c,e[6]=a*l,e[10]=o*l}else if(t.order==="YZX"){let f=o*l,p=o*c,g=a*l,_=a*c;e[0]=l*h,e[4]=_-f*u,e[8]=g*u+p,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-c*h,e[6]=p*u+g,e[10]=f-_*u}else if(t.order==="XZY"){let f=o*l,p=o*c,g=a*l,_=a*c;e[0]=l*h,e[4]=-u,e[8]=c*h,e[1]=f*u+_,e[5]=o*h,e[9]=p*u-g,e[2]=g*u-p,e[6]=a*h,e[10]=_*u+f}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose($0,t,q0)}lookAt(t,e,i){let s=this.elements;return un.subVectors(t,e),un.lengthSq()===0&&(un.z=1),un.normalize(),yi.crossVectors(i,un),yi.lengthSq()===0&&(Math.abs(i.z)===1?un.x+=1e-4:un.z+=1e-4,un.normalize(),yi.crossVectors(i,un)),yi.normalize(),Xo.crossVectors(un,yi),s[0]=yi.x,s[4]=Xo.x,s[8]=un.x,s[1]=yi.y,s[5]=Xo.y,s[9]=un.y,s[2]=yi.z,s[6]=Xo.z,s[10]=un.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],h=i[1],u=i[5],f=i[9],p=i[13],g=i[2],_=i[6],m=i[10],d=i[14],y=i[3],w=i[7],M=i[11],E=i[15],T=s[0],x=s[4],v=s[8],C=s[12],R=s[1],I=s[5],F=s[9],H=s[13],P=s[2],B=s[6],V=s[10],W=s[14],tt=s[3],$=s[7],Q=s[11],et=s[15];return r[0]=o*T+a*R+l*P+c*tt,r[4]=o*x+a*I+l*B+c*$,r[8]=o*v+a*F+l*V+c*Q,r[12]=o*C+a*H+l*W+c*et,r[1]=h*T+u*R+f*P+p*tt,r[5]=h*x+u*I+f*B+p*$,r[9]=h*v+u*F+f*V+p*Q,r[13]=h*C+u*H+f*W+p*et,r[2]=g*T+_*R+m*P+d*tt,r[6]=g*x+_*I+m*B+d*$,r[10]=g*v+_*F+m*V+d*Q,r[14]=g*C+_*H+m*W+d*et,r[3]=y*T+w*R+M*P+E*tt,r[7]=y*x+w*I+M*B+E*$,r[11]=y*v+w*F+M*V+E*Q,r[15]=y*C+w*H+M*W+E*et,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],l=t[9],c=t[13],h=t[2],u=t[6],f=t[10],p=t[14],g=t[3],_=t[7],m=t[11],d=t[15],y=l*p-c*f,w=a*p-c*u,M=a*f-l*u,E=o*p-c*h,T=o*f-l*h,x=o*u-a*h;return e*(_*y-m*w+d*M)-i*(g*y-m*E+d*T)+s*(g*w-_*E+d*x)-r*(g*M-_*T+m*x)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],l=t[2],c=t[6],h=t[10];return e*(o*h-a*c)-i*(r*h-a*l)+s*(r*c-o*l)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],l=t[6],c=t[7],h=t[8],u=t[9],f=t[10],p=t[11],g=t[12],_=t[13],m=t[14],d=t[15],y=e*a-i*o,w=e*l-s*o,M=e*c-r*o,E=i*l-s*a,T=i*c-r*a,x=s*c-r*l,v=h*_-u*g,C=h*m-f*g,R=h*d-p*g,I=u*m-f*_,F=u*d-p*_,H=f*d-p*m,P=y*H-w*F+M*I+E*R-T*C+x*v;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/P;return t[0]=(a*H-l*F+c*I)*B,t[1]=(s*F-i*H-r*I)*B,t[2]=(_*x-m*T+d*E)*B,t[3]=(f*T-u*x-p*E)*B,t[4]=(l*R-o*H-c*C)*B,t[5]=(e*H-s*R+r*C)*B,t[6]=(m*M-g*x-d*w)*B,t[7]=(h*x-f*M+p*w)*B,t[8]=(o*F-a*R+c*v)*B,t[9]=(i*R-e*F-r*v)*B,t[10]=(g*T-_*M+d*y)*B,t[11]=(u*M-h*T-p*y)*B,t[12]=(a*C-o*I-l*v)*B,t[13]=(e*I-i*C+s*v)*B,t[14]=(_*w-g*E-m*y)*B,t[15]=(h*E-u*w+f*y)*B,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,l=t.z,c=r*o,h=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,h*a+i,h*l-s*o,0,c*l-s*a,h*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,l=e._w,c=r+r,h=o+o,u=a+a,f=r*c,p=r*h,g=r*u,_=o*h,m=o*u,d=a*u,y=l*c,w=l*h,M=l*u,E=i.x,T=i.y,x=i.z;return s[0]=(1-(_+d))*E,s[1]=(p+M)*E,s[2]=(g-w)*E,s[3]=0,s[4]=(p-M)*T,s[5]=(1-(f+d))*T,s[6]=(m+y)*T,s[7]=0,s[8]=(g+w)*x,s[9]=(m-y)*x,s[10]=(1-(f+_))*x,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=hs.set(s[0],s[1],s[2]).length(),a=hs.set(s[4],s[5],s[6]).length(),l=hs.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Rn.copy(this);let c=1/o,h=1/a,u=1/l;return Rn.elements[0]*=c,Rn.elements[1]*=c,Rn.elements[2]*=c,Rn.elements[4]*=h,Rn.elements[5]*=h,Rn.elements[6]*=h,Rn.elements[8]*=u,Rn.elements[9]*=u,Rn.elements[10]*=u,e.setFromRotationMatrix(Rn),i.x=o,i.y=a,i.z=l,this}makePerspective(t,e,i,s,r,o,a=Mn,l=!1){let c=this.elements,h=2*r/(e-t),u=2*r/(i-s),f=(e+t)/(e-t),p=(i+s)/(i-s),g,_;if(l)g=r/(o-r),_=o*r/(o-r);else if(a===Mn)g=-(o+r)/(o-r),_=-2*o*r/(o-r);else if(a===ws)g=-o/(o-r),_=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=f,c[12]=0,c[1]=0,c[5]=u,c[9]=p,c[13]=0,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=Mn,l=!1){let c=this.elements,h=2/(e-t),u=2/(i-s),f=-(e+t)/(e-t),p=-(i+s)/(i-s),g,_;if(l)g=1/(o-r),_=o/(o-r);else if(a===Mn)g=-2/(o-r),_=-(o+r)/(o-r);else if(a===ws)g=-1/(o-r),_=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=h,c[4]=0,c[8]=0,c[12]=f,c[1]=0,c[5]=u,c[9]=0,c[13]=p,c[2]=0,c[6]=0,c[10]=g,c[14]=_,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},hs=new N,Rn=new ie,$0=new N(0,0,0),q0=new N(1,1,1),yi=new N,Xo=new N,un=new N,Af=new ie,Rf=new en,ui=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],h=s[9],u=s[2],f=s[6],p=s[10];switch(e){case"XYZ":this._y=Math.asin(Wt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,p),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(f,c),this._z=0);break;case"YXZ":this._x=Math.asin(-Wt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,p),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Wt(f,-1,1)),Math.abs(f)<.9999999?(this._y=Math.atan2(-u,p),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-Wt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(f,p),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(Wt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-h,c),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,p));break;case"XZY":this._z=Math.asin(-Wt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(f,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,p),this._y=0);break;default:Pt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return Af.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Af,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Rf.setFromEuler(this),this.setFromQuaternion(Rf,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ui.DEFAULT_ORDER="XYZ";var Rs=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},Y0=0,Cf=new N,us=new en,si=new ie,$o=new N,cr=new N,j0=new N,Z0=new en,Pf=new N(1,0,0),If=new N(0,1,0),Lf=new N(0,0,1),Nf={type:"added"},J0={type:"removed"},ds={type:"childadded",child:null},ph={type:"childremoved",child:null},Ge=class n extends Ln{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Y0++}),this.uuid=Bs(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new N,e=new ui,i=new en,s=new N(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ie},normalMatrix:{value:new Ft}}),this.matrix=new ie,this.matrixWorld=new ie,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Rs,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return us.setFromAxisAngle(t,e),this.quaternion.multiply(us),this}rotateOnWorldAxis(t,e){return us.setFromAxisAngle(t,e),this.quaternion.premultiply(us),this}rotateX(t){return this.rotateOnAxis(Pf,t)}rotateY(t){return this.rotateOnAxis(If,t)}rotateZ(t){return this.rotateOnAxis(Lf,t)}translateOnAxis(t,e){return Cf.copy(t).applyQuaternion(this.quaternion),this.position.add(Cf.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(Pf,t)}translateY(t){return this.translateOnAxis(If,t)}translateZ(t){return this.translateOnAxis(Lf,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(si.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?$o.copy(t):$o.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),cr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?si.lookAt(cr,$o,this.up):si.lookAt($o,cr,this.up),this.quaternion.setFromRotationMatrix(si),s&&(si.extractRotation(s.matrixWorld),us.setFromRotationMatrix(si),this.quaternion.premultiply(us.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Dt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Nf),ds.child=t,this.dispatchEvent(ds),ds.child=null):Dt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(J0),ph.child=t,this.dispatchEvent(ph),ph.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),si.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),si.multiply(t.parent.matrixWorld)),t.applyMatrix4(si),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Nf),ds.child=t,this.dispatchEvent(ds),ds.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cr,t,j0),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(cr,Z0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(t)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,h=l.length;c<h;c++){let u=l[c];r(t.shapes,u)}else r(t.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(t.materials,this.material[l]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(t.animations,l))}}if(e){let a=o(t.geometries),l=o(t.materials),c=o(t.textures),h=o(t.images),u=o(t.shapes),f=o(t.skeletons),p=o(t.animations),g=o(t.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),f.length>0&&(i.skeletons=f),p.length>0&&(i.animations=p),g.length>0&&(i.nodes=g)}return i.object=s,i;function o(a){let l=[];for(let c in a){let h=a[c];delete h.metadata,l.push(h)}return l}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ge.DEFAULT_UP=new N(0,1,0);Ge.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ge.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ee=class extends Ge{constructor(){super(),this.isGroup=!0,this.type="Group"}},K0={type:"move"},Cs=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ee,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ee,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new N,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new N),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ee,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new N,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new N,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(c&&t.hand){o=!0;for(let _ of t.hand.values()){let m=e.getJointPose(_,i),d=this._getHandJoint(c,_);m!==null&&(d.matrix.fromArray(m.transform.matrix),d.matrix.decompose(d.position,d.quaternion,d.scale),d.matrixWorldNeedsUpdate=!0,d.jointRadius=m.radius),d.visible=m!==null}let h=c.joints["index-finger-tip"],u=c.joints["thumb-tip"],f=h.position.distanceTo(u.position),p=.02,g=.005;c.inputState.pinching&&f>p+g?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!c.inputState.pinching&&f<=p-g&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else l!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(K0)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ee;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},Bp={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},vi={h:0,s:0,l:0},qo={h:0,s:0,l:0};function mh(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var Ut=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=fn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Jt.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=Jt.workingColorSpace){return this.r=t,this.g=e,this.b=i,Jt.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=Jt.workingColorSpace){if(t=gu(t,1),e=Wt(e,0,1),i=Wt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=mh(o,r,t+1/3),this.g=mh(o,r,t),this.b=mh(o,r,t-1/3)}return Jt.colorSpaceToWorking(this,s),this}setStyle(t,e=fn){function i(r){r!==void 0&&parseFloat(r)<1&&Pt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Pt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Pt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=fn){let i=Bp[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Pt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=ci(t.r),this.g=ci(t.g),this.b=ci(t.b),this}copyLinearToSRGB(t){return this.r=bs(t.r),this.g=bs(t.g),this.b=bs(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=fn){return Jt.workingToColorSpace(qe.copy(this),t),Math.round(Wt(qe.r*255,0,255))*65536+Math.round(Wt(qe.g*255,0,255))*256+Math.round(Wt(qe.b*255,0,255))}getHexString(t=fn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Jt.workingColorSpace){Jt.workingToColorSpace(qe.copy(this),e);let i=qe.r,s=qe.g,r=qe.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,h=(a+o)/2;if(a===o)l=0,c=0;else{let u=o-a;switch(c=h<=.5?u/(o+a):u/(2-o-a),o){case i:l=(s-r)/u+(s<r?6:0);break;case s:l=(r-i)/u+2;break;case r:l=(i-s)/u+4;break}l/=6}return t.h=l,t.s=c,t.l=h,t}getRGB(t,e=Jt.workingColorSpace){return Jt.workingToColorSpace(qe.copy(this),e),t.r=qe.r,t.g=qe.g,t.b=qe.b,t}getStyle(t=fn){Jt.workingToColorSpace(qe.copy(this),t);let e=qe.r,i=qe.g,s=qe.b;return t!==fn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(vi),this.setHSL(vi.h+t,vi.s+e,vi.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(vi),t.getHSL(qo);let i=gr(vi.h,qo.h,e),s=gr(vi.s,qo.s,e),r=gr(vi.l,qo.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},qe=new Ut;Ut.NAMES=Bp;var wr=class extends Ge{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ui,this.environmentIntensity=1,this.environmentRotation=new ui,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Cn=new N,ri=new N,gh=new N,oi=new N,fs=new N,ps=new N,Df=new N,xh=new N,_h=new N,yh=new N,vh=new ge,Mh=new ge,bh=new ge,wi=class n{constructor(t=new N,e=new N,i=new N){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),Cn.subVectors(t,e),s.cross(Cn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){Cn.subVectors(s,e),ri.subVectors(i,e),gh.subVectors(t,e);let o=Cn.dot(Cn),a=Cn.dot(ri),l=Cn.dot(gh),c=ri.dot(ri),h=ri.dot(gh),u=o*c-a*a;if(u===0)return r.set(0,0,0),null;let f=1/u,p=(c*l-a*h)*f,g=(o*h-a*l)*f;return r.set(1-p-g,g,p)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,oi)===null?!1:oi.x>=0&&oi.y>=0&&oi.x+oi.y<=1}static getInterpolation(t,e,i,s,r,o,a,l){return this.getBarycoord(t,e,i,s,oi)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,oi.x),l.addScaledVector(o,oi.y),l.addScaledVector(a,oi.z),l)}static getInterpolatedAttribute(t,e,i,s,r,o){return vh.setScalar(0),Mh.setScalar(0),bh.setScalar(0),vh.fromBufferAttribute(t,e),Mh.fromBufferAttribute(t,i),bh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(vh,r.x),o.addScaledVector(Mh,r.y),o.addScaledVector(bh,r.z),o}static isFrontFacing(t,e,i,s){return Cn.subVectors(i,e),ri.subVectors(t,e),Cn.cross(ri).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Cn.subVectors(this.c,this.b),ri.subVectors(this.a,this.b),Cn.cross(ri).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;fs.subVectors(s,i),ps.subVectors(r,i),xh.subVectors(t,i);let l=fs.dot(xh),c=ps.dot(xh);if(l<=0&&c<=0)return e.copy(i);_h.subVectors(t,s);let h=fs.dot(_h),u=ps.dot(_h);if(h>=0&&u<=h)return e.copy(s);let f=l*u-h*c;if(f<=0&&l>=0&&h<=0&&l-h>0)return o=l/(l-h),e.copy(i).addScaledVector(fs,o);yh.subVectors(t,r);let p=fs.dot(yh),g=ps.dot(yh);if(g>=0&&p<=g)return e.copy(r);let _=p*c-l*g;if(_<=0&&c>=0&&g<=0)return a=c/(c-g),e.copy(i).addScaledVector(ps,a);let m=h*g-p*u;if(m<=0&&u-h>=0&&p-g>=0)return Df.subVectors(r,s),a=(u-h)/(u-h+(p-g)),e.copy(s).addScaledVector(Df,a);let d=1/(m+_+f);return o=_*d,a=f*d,e.copy(i).addScaledVector(fs,o).addScaledVector(ps,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},Nn=class{constructor(t=new N(1/0,1/0,1/0),e=new N(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(Pn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(Pn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=Pn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Pn):Pn.fromBufferAttribute(r,o),Pn.applyMatrix4(t.matrixWorld),this.expandByPoint(Pn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Yo.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Yo.copy(i.boundingBox)),Yo.applyMatrix4(t.matrixWorld),this.union(Yo)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Pn),Pn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(hr),jo.subVectors(this.max,hr),ms.subVectors(t.a,hr),gs.subVectors(t.b,hr),xs.subVectors(t.c,hr),Mi.subVectors(gs,ms),bi.subVectors(xs,gs),Wi.subVectors(ms,xs);let e=[0,-Mi.z,Mi.y,0,-bi.z,bi.y,0,-Wi.z,Wi.y,Mi.z,0,-Mi.x,bi.z,0,-bi.x,Wi.z,0,-Wi.x,-Mi.y,Mi.x,0,-bi.y,bi.x,0,-Wi.y,Wi.x,0];return!Sh(e,ms,gs,xs,jo)||(e=[1,0,0,0,1,0,0,0,1],!Sh(e,ms,gs,xs,jo))?!1:(Zo.crossVectors(Mi,bi),e=[Zo.x,Zo.y,Zo.z],Sh(e,ms,gs,xs,jo))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Pn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Pn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(ai[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),ai[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),ai[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),ai[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),ai[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),ai[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),ai[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),ai[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(ai),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},ai=[new N,new N,new N,new N,new N,new N,new N,new N],Pn=new N,Yo=new Nn,ms=new N,gs=new N,xs=new N,Mi=new N,bi=new N,Wi=new N,hr=new N,jo=new N,Zo=new N,Xi=new N;function Sh(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Xi.fromArray(n,r);let a=s.x*Math.abs(Xi.x)+s.y*Math.abs(Xi.y)+s.z*Math.abs(Xi.z),l=t.dot(Xi),c=e.dot(Xi),h=i.dot(Xi);if(Math.max(-Math.max(l,c,h),Math.min(l,c,h))>a)return!1}return!0}var we=new N,Jo=new _t,Q0=0,In=class extends Ln{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Q0++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=Ip,this.updateRanges=[],this.gpuType=Un,this.version=0,this._normalizationScale=t!==void 0?_u(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Jo.fromBufferAttribute(this,e),Jo.applyMatrix3(t),this.setXY(e,Jo.x,Jo.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)we.fromBufferAttribute(this,e),we.applyMatrix3(t),this.setXYZ(e,we.x,we.y,we.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)we.fromBufferAttribute(this,e),we.applyMatrix4(t),this.setXYZ(e,we.x,we.y,we.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)we.fromBufferAttribute(this,e),we.applyNormalMatrix(t),this.setXYZ(e,we.x,we.y,we.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)we.fromBufferAttribute(this,e),we.transformDirection(t),this.setXYZ(e,we.x,we.y,we.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):Fp(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):Op(t,this.array)}};var Er=class extends In{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var Tr=class extends In{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Me=class extends In{constructor(t,e,i){super(new Float32Array(t),e,i)}},tx=new Nn,ur=new N,wh=new N,Yi=class{constructor(t=new N,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):tx.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;ur.subVectors(t,this.center);let e=ur.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(ur,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(wh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(ur.copy(t.center).add(wh)),this.expandByPoint(ur.copy(t.center).sub(wh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},ex=0,vn=new ie,Eh=new Ge,_s=new N,dn=new Nn,dr=new Nn,Fe=new N,an=class n extends Ln{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:ex++}),this.uuid=Bs(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(T0(t)?Tr:Er)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new Ft().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return vn.makeRotationFromQuaternion(t),this.applyMatrix4(vn),this}rotateX(t){return vn.makeRotationX(t),this.applyMatrix4(vn),this}rotateY(t){return vn.makeRotationY(t),this.applyMatrix4(vn),this}rotateZ(t){return vn.makeRotationZ(t),this.applyMatrix4(vn),this}translate(t,e,i){return vn.makeTranslation(t,e,i),this.applyMatrix4(vn),this}scale(t,e,i){return vn.makeScale(t,e,i),this.applyMatrix4(vn),this}lookAt(t){return Eh.lookAt(t),Eh.updateMatrix(),this.applyMatrix4(Eh.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(_s).negate(),this.translate(_s.x,_s.y,_s.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Me(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Pt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Nn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Dt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new N(-1/0,-1/0,-1/0),new N(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];dn.setFromBufferAttribute(r),this.morphTargetsRelative?(Fe.addVectors(this.boundingBox.min,dn.min),this.boundingBox.expandByPoint(Fe),Fe.addVectors(this.boundingBox.max,dn.max),this.boundingBox.expandByPoint(Fe)):(this.boundingBox.expandByPoint(dn.min),this.boundingBox.expandByPoint(dn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Dt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Yi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Dt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new N,1/0);return}if(t){let i=this.boundingSphere.center;if(dn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];dr.setFromBufferAttribute(a),this.morphTargetsRelative?(Fe.addVectors(dn.min,dr.min),dn.expandByPoint(Fe),Fe.addVectors(dn.max,dr.max),dn.expandByPoint(Fe)):(dn.expandByPoint(dr.min),dn.expandByPoint(dr.max))}dn.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)Fe.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Fe));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],l=this.morphTargetsRelative;for(let c=0,h=a.count;c<h;c++)Fe.fromBufferAttribute(a,c),l&&(_s.fromBufferAttribute(t,c),Fe.add(_s)),s=Math.max(s,i.distanceToSquared(Fe))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Dt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Dt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new In(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let C=0;C<i.count;C++)a[C]=new N,l[C]=new N;let h=new N,u=new N,f=new N,p=new _t,g=new _t,_=new _t,m=new N,d=new N;function y(C,R,I){c[C]=c[R]=c[I]=1,h.fromBufferAttribute(i,C),u.fromBufferAttribute(i,R),f.fromBufferAttribute(i,I),p.fromBufferAttribute(r,C),g.fromBufferAttribute(r,R),_.fromBufferAttribute(r,I),u.sub(h),f.sub(h),g.sub(p),_.sub(p);let F=1/(g.x*_.y-_.x*g.y);isFinite(F)&&(m.copy(u).multiplyScalar(_.y).addScaledVector(f,-g.y).multiplyScalar(F),d.copy(f).multiplyScalar(g.x).addScaledVector(u,-_.x).multiplyScalar(F),a[C].add(m),a[R].add(m),a[I].add(m),l[C].add(d),l[R].add(d),l[I].add(d))}let w=this.groups;w.length===0&&(w=[{start:0,count:t.count}]);for(let C=0,R=w.length;C<R;++C){let I=w[C],F=I.start,H=I.count;for(let P=F,B=F+H;P<B;P+=3)y(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let M=new N,E=new N,T=new N,x=new N;function v(C){T.fromBufferAttribute(s,C),x.copy(T);let R=a[C];M.copy(R),M.sub(T.multiplyScalar(T.dot(R))).normalize(),E.crossVectors(x,R);let F=E.dot(l[C])<0?-1:1;o.setXYZW(C,M.x,M.y,M.z,F)}for(let C=0,R=i.count;C<R;++C)c[C]&&v(C);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new In(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let f=0,p=i.count;f<p;f++)i.setXYZ(f,0,0,0);let s=new N,r=new N,o=new N,a=new N,l=new N,c=new N,h=new N,u=new N;if(t)for(let f=0,p=t.count;f<p;f+=3){let g=t.getX(f+0),_=t.getX(f+1),m=t.getX(f+2);s.fromBufferAttribute(e,g),r.fromBufferAttribute(e,_),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,g),l.fromBufferAttribute(i,_),c.fromBufferAttribute(i,m),a.add(h),l.add(h),c.add(h),i.setXYZ(g,a.x,a.y,a.z),i.setXYZ(_,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let f=0,p=e.count;f<p;f+=3)s.fromBufferAttribute(e,f+0),r.fromBufferAttribute(e,f+1),o.fromBufferAttribute(e,f+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(f+0,h.x,h.y,h.z),i.setXYZ(f+1,h.x,h.y,h.z),i.setXYZ(f+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)Fe.fromBufferAttribute(t,e),Fe.normalize(),t.setXYZ(e,Fe.x,Fe.y,Fe.z)}toNonIndexed(){function t(a,l){let c=a.array,h=a.itemSize,u=a.normalized,f=new c.constructor(l.length*h),p=0,g=0;for(let _=0,m=l.length;_<m;_++){a.isInterleavedBufferAttribute?p=l[_]*a.data.stride+a.offset:p=l[_]*h;for(let d=0;d<h;d++)f[g++]=c[p++]}return new In(f,h,u)}if(this.index===null)return Pt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=t(l,i);e.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let h=0,u=c.length;h<u;h++){let f=c[h],p=t(f,i);l.push(p)}e.morphAttributes[a]=l}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];e.addGroup(c.start,c.count,c.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(t[c]=l[c]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let l in i){let c=i[l];t.data.attributes[l]=c.toJSON(t.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],h=[];for(let u=0,f=c.length;u<f;u++){let p=c[u];h.push(p.toJSON(t.data))}h.length>0&&(s[l]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let c in s){let h=s[c];this.setAttribute(c,h.clone(e))}let r=t.morphAttributes;for(let c in r){let h=[],u=r[c];for(let f=0,p=u.length;f<p;f++)h.push(u[f].clone(e));this.morphAttributes[c]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let c=0,h=o.length;c<h;c++){let u=o[c];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=t.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Th=new N,nx=new N,ix=new Ft,Ke=class{constructor(t=new N(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Th.subVectors(i,e).cross(nx.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Th),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||ix.getNormalMatrix(t),s=this.coplanarPoint(Th).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},sx=0,Xn=class extends Ln{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:sx++}),this.uuid=Bs(),this.name="",this.type="Material",this.blending=Us,this.side=Di,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=$h,this.blendDst=qh,this.blendEquation=Qi,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new Ut(0,0,0),this.blendAlpha=0,this.depthFunc=Ss,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ep,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=pa,this.stencilZFail=pa,this.stencilZPass=pa,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Pt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Pt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new Ut().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new Ke().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new _t().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new _t().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var li=new N,Ah=new N,Ko=new N,Qo=new N,Ei=class{constructor(t=new N,e=new N(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,li)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=li.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(li.copy(this.origin).addScaledVector(this.direction,e),li.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Ah.copy(t).add(e).multiplyScalar(.5),Ko.copy(e).sub(t).normalize(),Qo.copy(this.origin).sub(Ah);let r=t.distanceTo(e)*.5,o=-this.direction.dot(Ko),a=Qo.dot(this.direction),l=-Qo.dot(Ko),c=Qo.lengthSq(),h=Math.abs(1-o*o),u,f,p,g;if(h>0)if(u=o*l-a,f=o*a-l,g=r*h,u>=0)if(f>=-g)if(f<=g){let _=1/h;u*=_,f*=_,p=u*(u+o*f+2*a)+f*(o*u+f+2*l)+c}else f=r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f=-r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;else f<=-g?(u=Math.max(0,-(-o*r+a)),f=u>0?-r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c):f<=g?(u=0,f=Math.min(Math.max(-r,-l),r),p=f*(f+2*l)+c):(u=Math.max(0,-(o*r+a)),f=u>0?r:Math.min(Math.max(-r,-l),r),p=-u*u+f*(f+2*l)+c);else f=o>0?-r:r,u=Math.max(0,-(o*f+a)),p=-u*u+f*(f+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Ah).addScaledVector(Ko,f),p}intersectSphere(t,e){if(t.radius<0)return null;li.subVectors(t.center,this.origin);let i=li.dot(this.direction),s=li.dot(li)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,l,c=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,f=this.origin;return c>=0?(i=(t.min.x-f.x)*c,s=(t.max.x-f.x)*c):(i=(t.max.x-f.x)*c,s=(t.min.x-f.x)*c),h>=0?(r=(t.min.y-f.y)*h,o=(t.max.y-f.y)*h):(r=(t.max.y-f.y)*h,o=(t.min.y-f.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-f.z)*u,l=(t.max.z-f.z)*u):(a=(t.max.z-f.z)*u,l=(t.min.z-f.z)*u),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,li)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,h=a.z,u=t.x-o.x,f=t.y-o.y,p=t.z-o.z,g=e.x-o.x,_=e.y-o.y,m=e.z-o.z,d=i.x-o.x,y=i.y-o.y,w=i.z-o.z,M=Math.abs(l),E=Math.abs(c),T=Math.abs(h),x,v,C,R,I,F,H,P,B,V,W,tt;if(M>=E&&M>=T?(C=l,F=u,B=g,tt=d,l>=0?(x=c,v=h,R=f,I=p,H=_,P=m,V=y,W=w):(x=h,v=c,R=p,I=f,H=m,P=_,V=w,W=y)):E>=T?(C=c,F=f,B=_,tt=y,c>=0?(x=h,v=l,R=p,I=u,H=m,P=g,V=w,W=d):(x=l,v=h,R=u,I=p,H=g,P=m,V=d,W=w)):(C=h,F=p,B=m,tt=w,h>=0?(x=l,v=c,R=u,I=f,H=g,P=_,V=d,W=y):(x=c,v=l,R=f,I=u,H=_,P=g,V=y,W=d)),C===0)return null;let $=x/C,Q=v/C,et=1/C,wt=R-$*F,Bt=I-Q*F,Z=H-$*B,mt=P-Q*B,Mt=V-$*tt,It=W-Q*tt,gt=Mt*mt-It*Z,zt=wt*It-Bt*Mt,be=Z*Bt-mt*wt;if(s){if(gt<0||zt<0||be<0)return null}else if((gt<0||zt<0||be<0)&&(gt>0||zt>0||be>0))return null;let Nt=gt+zt+be;if(Nt===0)return null;let se=et*(gt*F+zt*B+be*tt);return(Nt>0?se<0:se>0)?null:this.at(se/Nt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ve=class extends Xn{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new Ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ui,this.combine=Yh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},Uf=new ie,$i=new Ei,ta=new Yi,Ff=new N,ea=new N,na=new N,ia=new N,Rh=new N,sa=new N,Of=new N,ra=new N,Ce=class extends Ge{constructor(t=new an,e=new Ve){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){sa.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let h=a[l],u=r[l];h!==0&&(Rh.fromBufferAttribute(u,t),o?sa.addScaledVector(Rh,h):sa.addScaledVector(Rh.sub(e),h))}e.add(sa)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),ta.copy(i.boundingSphere),ta.applyMatrix4(r),$i.copy(t.ray).recast(t.near),!(ta.containsPoint($i.origin)===!1&&($i.intersectSphere(ta,Ff)===null||$i.origin.distanceToSquared(Ff)>(t.far-t.near)**2))&&(Uf.copy(r).invert(),$i.copy(t.ray).applyMatrix4(Uf),!(i.boundingBox!==null&&$i.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,$i)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,f=r.groups,p=r.drawRange;if(a!==null)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let m=f[g],d=o[m.materialIndex],y=Math.max(m.start,p.start),w=Math.min(a.count,Math.min(m.start+m.count,p.start+p.count));for(let M=y,E=w;M<E;M+=3){let T=a.getX(M),x=a.getX(M+1),v=a.getX(M+2);s=oa(this,d,t,i,c,h,u,T,x,v),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(a.count,p.start+p.count);for(let m=g,d=_;m<d;m+=3){let y=a.getX(m),w=a.getX(m+1),M=a.getX(m+2);s=oa(this,o,t,i,c,h,u,y,w,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let g=0,_=f.length;g<_;g++){let m=f[g],d=o[m.materialIndex],y=Math.max(m.start,p.start),w=Math.min(l.count,Math.min(m.start+m.count,p.start+p.count));for(let M=y,E=w;M<E;M+=3){let T=M,x=M+1,v=M+2;s=oa(this,d,t,i,c,h,u,T,x,v),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let g=Math.max(0,p.start),_=Math.min(l.count,p.start+p.count);for(let m=g,d=_;m<d;m+=3){let y=m,w=m+1,M=m+2;s=oa(this,o,t,i,c,h,u,y,w,M),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function rx(n,t,e,i,s,r,o,a){let l;if(t.side===nn?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,t.side===Di,a),l===null)return null;ra.copy(a),ra.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(ra);return c<e.near||c>e.far?null:{distance:c,point:ra.clone(),object:n}}function oa(n,t,e,i,s,r,o,a,l,c){n.getVertexPosition(a,ea),n.getVertexPosition(l,na),n.getVertexPosition(c,ia);let h=rx(n,t,e,i,ea,na,ia,Of);if(h){let u=new N;wi.getBarycoord(Of,ea,na,ia,u),s&&(h.uv=wi.getInterpolatedAttribute(s,a,l,c,u,new _t)),r&&(h.uv1=wi.getInterpolatedAttribute(r,a,l,c,u,new _t)),o&&(h.normal=wi.getInterpolatedAttribute(o,a,l,c,u,new N),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let f={a,b:l,c,normal:new N,materialIndex:0};wi.getNormal(ea,na,ia,f.normal),h.face=f,h.barycoord=u}return h}var Ra=class extends on{constructor(t=null,e=1,i=1,s,r,o,a,l,c=Oe,h=Oe,u,f){super(null,o,a,l,c,h,s,r,u,f),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Ps=class extends In{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}};var qi=new Yi,ox=new _t(.5,.5),aa=new N,Ti=class{constructor(t=new Ke,e=new Ke,i=new Ke,s=new Ke,r=new Ke,o=new Ke){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=Mn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],l=r[2],c=r[3],h=r[4],u=r[5],f=r[6],p=r[7],g=r[8],_=r[9],m=r[10],d=r[11],y=r[12],w=r[13],M=r[14],E=r[15];if(s[0].setComponents(c-o,p-h,d-g,E-y).normalize(),s[1].setComponents(c+o,p+h,d+g,E+y).normalize(),s[2].setComponents(c+a,p+u,d+_,E+w).normalize(),s[3].setComponents(c-a,p-u,d-_,E-w).normalize(),i)s[4].setComponents(l,f,m,M).normalize(),s[5].setComponents(c-l,p-f,d-m,E-M).normalize();else if(s[4].setComponents(c-l,p-f,d-m,E-M).normalize(),e===Mn)s[5].setComponents(c+l,p+f,d+m,E+M).normalize();else if(e===ws)s[5].setComponents(l,f,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),qi.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),qi.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(qi)}intersectsSprite(t){qi.center.set(0,0,0);let e=ox.distanceTo(t.center);return qi.radius=.7071067811865476+e,qi.applyMatrix4(t.matrixWorld),this.intersectsSphere(qi)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(aa.x=s.normal.x>0?t.max.x:t.min.x,aa.y=s.normal.y>0?t.max.y:t.min.y,aa.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(aa)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Bf=new ie,Ca=class n{constructor(){this.coordinateSystem=Mn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Bf.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Ti),i[s].setFromProjectionMatrix(Bf,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ti),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Is=class extends Xn{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new Ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},Pa=new N,Ia=new N,kf=new ie,fr=new Ei,la=new Yi,Ch=new N,zf=new N,La=class extends Ge{constructor(t=new an,e=new Is){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)Pa.fromBufferAttribute(e,s-1),Ia.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=Pa.distanceTo(Ia);t.setAttribute("lineDistance",new Me(i,1))}else Pt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),la.copy(i.boundingSphere),la.applyMatrix4(s),la.radius+=r,t.ray.intersectsSphere(la)===!1)return;kf.copy(s).invert(),fr.copy(t.ray).applyMatrix4(kf);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,h=i.index,f=i.attributes.position;if(h!==null){let p=Math.max(0,o.start),g=Math.min(h.count,o.start+o.count);for(let _=p,m=g-1;_<m;_+=c){let d=h.getX(_),y=h.getX(_+1),w=ca(this,t,fr,l,d,y,_);w&&e.push(w)}if(this.isLineLoop){let _=h.getX(g-1),m=h.getX(p),d=ca(this,t,fr,l,_,m,g-1);d&&e.push(d)}}else{let p=Math.max(0,o.start),g=Math.min(f.count,o.start+o.count);for(let _=p,m=g-1;_<m;_+=c){let d=ca(this,t,fr,l,_,_+1,_);d&&e.push(d)}if(this.isLineLoop){let _=ca(this,t,fr,l,g-1,p,g-1);_&&e.push(_)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ca(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(Pa.fromBufferAttribute(a,s),Ia.fromBufferAttribute(a,r),e.distanceSqToSegment(Pa,Ia,Ch,zf)>i)return;Ch.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Ch);if(!(c<t.near||c>t.far))return{distance:c,point:zf.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Ar=class extends La{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Rr=class extends on{constructor(t=[],e=ts,i,s,r,o,a,l,c,h){super(t,e,i,s,r,o,a,l,c,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var di=class extends on{constructor(t,e,i=Dn,s,r,o,a=Oe,l=Oe,c,h=hi,u=1){if(h!==hi&&h!==pi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let f={width:t,height:e,depth:u};super(f,s,r,o,a,l,h,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new As(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},Cr=class extends di{constructor(t,e=Dn,i=ts,s,r,o=Oe,a=Oe,l,c=hi){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,l,c),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},Pr=class extends on{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ai=class n extends an{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],h=[],u=[],f=0,p=0;g("z","y","x",-1,-1,i,e,t,o,r,0),g("z","y","x",1,-1,i,e,-t,o,r,1),g("x","z","y",1,1,t,i,e,s,o,2),g("x","z","y",1,-1,t,i,-e,s,o,3),g("x","y","z",1,-1,t,e,i,s,r,4),g("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Me(c,3)),this.setAttribute("normal",new Me(h,3)),this.setAttribute("uv",new Me(u,2));function g(_,m,d,y,w,M,E,T,x,v,C){let R=M/x,I=E/v,F=M/2,H=E/2,P=T/2,B=x+1,V=v+1,W=0,tt=0,$=new N;for(let Q=0;Q<V;Q++){let et=Q*I-H;for(let wt=0;wt<B;wt++){let Bt=wt*R-F;$[_]=Bt*y,$[m]=et*w,$[d]=P,c.push($.x,$.y,$.z),$[_]=0,$[m]=0,$[d]=T>0?1:-1,h.push($.x,$.y,$.z),u.push(wt/x),u.push(1-Q/v),W+=1}}for(let Q=0;Q<v;Q++)for(let et=0;et<x;et++){let wt=f+et+B*Q,Bt=f+et+B*(Q+1),Z=f+(et+1)+B*(Q+1),mt=f+(et+1)+B*Q;l.push(wt,Bt,mt),l.push(Bt,Z,mt),tt+=6}a.addGroup(p,tt,C),p+=tt,f+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var ji=class n extends an{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,l=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:l};let c=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],f=[],p=[],g=0,_=[],m=i/2,d=0;y(),o===!1&&(t>0&&w(!0),e>0&&w(!1)),this.setIndex(h),this.setAttribute("position",new Me(u,3)),this.setAttribute("normal",new Me(f,3)),this.setAttribute("uv",new Me(p,2));function y(){let M=new N,E=new N,T=0,x=(e-t)/i;for(let v=0;v<=r;v++){let C=[],R=v/r,I=R*(e-t)+t;for(let F=0;F<=s;F++){let H=F/s,P=H*l+a,B=Math.sin(P),V=Math.cos(P);E.x=I*B,E.y=-R*i+m,E.z=I*V,u.push(E.x,E.y,E.z),M.set(B,x,V).normalize(),f.push(M.x,M.y,M.z),p.push(H,1-R),C.push(g++)}_.push(C)}for(let v=0;v<s;v++)for(let C=0;C<r;C++){let R=_[C][v],I=_[C+1][v],F=_[C+1][v+1],H=_[C][v+1];(t>0||C!==0)&&(h.push(R,I,H),T+=3),(e>0||C!==r-1)&&(h.push(I,F,H),T+=3)}c.addGroup(d,T,0),d+=T}function w(M){let E=g,T=new _t,x=new N,v=0,C=M===!0?t:e,R=M===!0?1:-1;for(let F=1;F<=s;F++)u.push(0,m*R,0),f.push(0,R,0),p.push(.5,.5),g++;let I=g;for(let F=0;F<=s;F++){let P=F/s*l+a,B=Math.cos(P),V=Math.sin(P);x.x=C*V,x.y=m*R,x.z=C*B,u.push(x.x,x.y,x.z),f.push(0,R,0),T.x=B*.5+.5,T.y=V*.5*R+.5,p.push(T.x,T.y),g++}for(let F=0;F<s;F++){let H=E+F,P=I+F;M===!0?h.push(P,P+1,H):h.push(P+1,P,H),v+=3}c.addGroup(d,v,M===!0?1:2),d+=v}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Ir=class n extends ji{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var bn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Pt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)i=this.getPoint(o/t),r+=i.distanceTo(s),e.push(r),s=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),s=0,r=i.length,o;e?o=e:o=t*i[r-1];let a=0,l=r-1,c;for(;a<=l;)if(s=Math.floor(a+(l-a)/2),c=i[s]-o,c<0)a=s+1;else if(c>0)l=s-1;else{l=s;break}if(s=l,i[s]===o)return s/(r-1);let h=i[s],f=i[s+1]-h,p=(o-h)/f;return(s+p)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),l=e||(o.isVector2?new _t:new N);return l.copy(a).sub(o).normalize(),l}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new N,s=[],r=[],o=[],a=new N,l=new ie;for(let p=0;p<=t;p++){let g=p/t;s[p]=this.getTangentAt(g,new N)}r[0]=new N,o[0]=new N;let c=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),f=Math.abs(s[0].z);h<=c&&(c=h,i.set(1,0,0)),u<=c&&(c=u,i.set(0,1,0)),f<=c&&i.set(0,0,1),a.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let p=1;p<=t;p++){if(r[p]=r[p-1].clone(),o[p]=o[p-1].clone(),a.crossVectors(s[p-1],s[p]),a.length()>Number.EPSILON){a.normalize();let g=Math.acos(Wt(s[p-1].dot(s[p]),-1,1));r[p].applyMatrix4(l.makeRotationAxis(a,g))}o[p].crossVectors(s[p],r[p])}if(e===!0){let p=Math.acos(Wt(r[0].dot(r[t]),-1,1));p/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(p=-p);for(let g=1;g<=t;g++)r[g].applyMatrix4(l.makeRotationAxis(s[g],p*g)),o[g].crossVectors(s[g],r[g])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},Lr=class extends bn{constructor(t=0,e=0,i=1,s=1,r=0,o=Math.PI*2,a=!1,l=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=l}getPoint(t,e=new _t){let i=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,l=this.aX+this.xRadius*Math.cos(a),c=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),f=l-this.aX,p=c-this.aY;l=f*h-p*u+this.aX,c=f*u+p*h+this.aY}return i.set(l,c)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},Na=class extends Lr{constructor(t,e,i,s,r,o){super(t,e,i,i,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function vu(){let n=0,t=0,e=0,i=0;function s(r,o,a,l){n=r,t=a,e=-3*r+3*o-2*a-l,i=2*r-2*o+a+l}return{initCatmullRom:function(r,o,a,l,c){s(o,a,c*(a-r),c*(l-o))},initNonuniformCatmullRom:function(r,o,a,l,c,h,u){let f=(o-r)/c-(a-r)/(c+h)+(a-o)/h,p=(a-o)/h-(l-o)/(h+u)+(l-a)/u;f*=h,p*=h,s(o,a,f,p)},calc:function(r){let o=r*r,a=o*r;return n+t*r+e*o+i*a}}}var Gf=new N,Vf=new N,Ph=new vu,Ih=new vu,Lh=new vu,Ls=class extends bn{constructor(t=[],e=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=s}getPoint(t,e=new N){let i=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),l=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:l===0&&a===r-1&&(a=r-2,l=1);let c,h;this.closed||a>0?c=s[(a-1)%r]:(Vf.subVectors(s[0],s[1]).add(s[0]),c=Vf);let u=s[a%r],f=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(Gf.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=Gf),this.curveType==="centripetal"||this.curveType==="chordal"){let p=this.curveType==="chordal"?.5:.25,g=Math.pow(c.distanceToSquared(u),p),_=Math.pow(u.distanceToSquared(f),p),m=Math.pow(f.distanceToSquared(h),p);_<1e-4&&(_=1),g<1e-4&&(g=_),m<1e-4&&(m=_),Ph.initNonuniformCatmullRom(c.x,u.x,f.x,h.x,g,_,m),Ih.initNonuniformCatmullRom(c.y,u.y,f.y,h.y,g,_,m),Lh.initNonuniformCatmullRom(c.z,u.z,f.z,h.z,g,_,m)}else this.curveType==="catmullrom"&&(Ph.initCatmullRom(c.x,u.x,f.x,h.x,this.tension),Ih.initCatmullRom(c.y,u.y,f.y,h.y,this.tension),Lh.initCatmullRom(c.z,u.z,f.z,h.z,this.tension));return i.set(Ph.calc(l),Ih.calc(l),Lh.calc(l)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new N().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function Hf(n,t,e,i,s){let r=(i-t)*.5,o=(s-e)*.5,a=n*n,l=n*a;return(2*e-2*i+r+o)*l+(-3*e+3*i-2*r-o)*a+r*n+e}function ax(n,t){let e=1-n;return e*e*t}function lx(n,t){return 2*(1-n)*n*t}function cx(n,t){return n*n*t}function xr(n,t,e,i){return ax(n,t)+lx(n,e)+cx(n,i)}function hx(n,t){let e=1-n;return e*e*e*t}function ux(n,t){let e=1-n;return 3*e*e*n*t}function dx(n,t){return 3*(1-n)*n*n*t}function fx(n,t){return n*n*n*t}function _r(n,t,e,i,s){return hx(n,t)+ux(n,e)+dx(n,i)+fx(n,s)}var Da=class extends bn{constructor(t=new _t,e=new _t,i=new _t,s=new _t){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new _t){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(_r(t,s.x,r.x,o.x,a.x),_r(t,s.y,r.y,o.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ua=class extends bn{constructor(t=new N,e=new N,i=new N,s=new N){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new N){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(_r(t,s.x,r.x,o.x,a.x),_r(t,s.y,r.y,o.y,a.y),_r(t,s.z,r.z,o.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Fa=class extends bn{constructor(t=new _t,e=new _t){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new _t){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new _t){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Oa=class extends bn{constructor(t=new N,e=new N){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new N){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new N){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Ba=class extends bn{constructor(t=new _t,e=new _t,i=new _t){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new _t){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(xr(t,s.x,r.x,o.x),xr(t,s.y,r.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Nr=class extends bn{constructor(t=new N,e=new N,i=new N){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new N){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(xr(t,s.x,r.x,o.x),xr(t,s.y,r.y,o.y),xr(t,s.z,r.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},ka=class extends bn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new _t){let i=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,l=s[o===0?o:o-1],c=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return i.set(Hf(a,l.x,c.x,h.x,u.x),Hf(a,l.y,c.y,h.y,u.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new _t().fromArray(s))}return this}},px=Object.freeze({__proto__:null,ArcCurve:Na,CatmullRomCurve3:Ls,CubicBezierCurve:Da,CubicBezierCurve3:Ua,EllipseCurve:Lr,LineCurve:Fa,LineCurve3:Oa,QuadraticBezierCurve:Ba,QuadraticBezierCurve3:Nr,SplineCurve:ka});var Zi=class n extends an{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),l=Math.floor(s),c=a+1,h=l+1,u=t/a,f=e/l,p=[],g=[],_=[],m=[];for(let d=0;d<h;d++){let y=d*f-o;for(let w=0;w<c;w++){let M=w*u-r;g.push(M,-y,0),_.push(0,0,1),m.push(w/a),m.push(1-d/l)}}for(let d=0;d<l;d++)for(let y=0;y<a;y++){let w=y+c*d,M=y+c*(d+1),E=y+1+c*(d+1),T=y+1+c*d;p.push(w,M,T),p.push(M,E,T)}this.setIndex(p),this.setAttribute("position",new Me(g,3)),this.setAttribute("normal",new Me(_,3)),this.setAttribute("uv",new Me(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var Dr=class n extends an{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let l=Math.min(o+a,Math.PI),c=0,h=[],u=new N,f=new N,p=[],g=[],_=[],m=[];for(let d=0;d<=i;d++){let y=[],w=d/i,M=o+w*a,E=t*Math.cos(M),T=Math.sqrt(t*t-E*E),x=0;d===0&&o===0?x=.5/e:d===i&&l===Math.PI&&(x=-.5/e);for(let v=0;v<=e;v++){let C=v/e,R=s+C*r;u.x=-T*Math.cos(R),u.y=E,u.z=T*Math.sin(R),g.push(u.x,u.y,u.z),f.copy(u).normalize(),_.push(f.x,f.y,f.z),m.push(C+x,1-w),y.push(c++)}h.push(y)}for(let d=0;d<i;d++)for(let y=0;y<e;y++){let w=h[d][y+1],M=h[d][y],E=h[d+1][y],T=h[d+1][y+1];(d!==0||o>0)&&p.push(w,M,T),(d!==i-1||l<Math.PI)&&p.push(M,E,T)}this.setIndex(p),this.setAttribute("position",new Me(g,3)),this.setAttribute("normal",new Me(_,3)),this.setAttribute("uv",new Me(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var Ur=class n extends an{constructor(t=new Nr(new N(-1,-1,0),new N(-1,1,0),new N(1,1,0)),e=64,i=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:i,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new N,l=new N,c=new _t,h=new N,u=[],f=[],p=[],g=[];_(),this.setIndex(g),this.setAttribute("position",new Me(u,3)),this.setAttribute("normal",new Me(f,3)),this.setAttribute("uv",new Me(p,2));function _(){for(let w=0;w<e;w++)m(w);m(r===!1?e:0),y(),d()}function m(w){h=t.getPointAt(w/e,h);let M=o.normals[w],E=o.binormals[w];for(let T=0;T<=s;T++){let x=T/s*Math.PI*2,v=Math.sin(x),C=-Math.cos(x);l.x=C*M.x+v*E.x,l.y=C*M.y+v*E.y,l.z=C*M.z+v*E.z,l.normalize(),f.push(l.x,l.y,l.z),a.x=h.x+i*l.x,a.y=h.y+i*l.y,a.z=h.z+i*l.z,u.push(a.x,a.y,a.z)}}function d(){for(let w=1;w<=e;w++)for(let M=1;M<=s;M++){let E=(s+1)*(w-1)+(M-1),T=(s+1)*w+(M-1),x=(s+1)*w+M,v=(s+1)*(w-1)+M;g.push(E,T,v),g.push(T,x,v)}}function y(){for(let w=0;w<=e;w++)for(let M=0;M<=s;M++)c.x=w/e,c.y=M/s,p.push(c.x,c.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new n(new px[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}};var Fr=class extends Xn{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new Ut(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function ns(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(Wf(s))s.isRenderTargetTexture?(Pt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(Wf(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function je(n){let t={};for(let e=0;e<n.length;e++){let i=ns(n[e]);for(let s in i)t[s]=i[s]}return t}function Wf(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function mx(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function Mu(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Jt.workingColorSpace}var kp={clone:ns,merge:je},gx=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,xx=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Sn=class extends Xn{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=gx,this.fragmentShader=xx,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=ns(t.uniforms),this.uniformsGroups=mx(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new Ut().setHex(s.value);break;case"v2":this.uniforms[i].value=new _t().fromArray(s.value);break;case"v3":this.uniforms[i].value=new N().fromArray(s.value);break;case"v4":this.uniforms[i].value=new ge().fromArray(s.value);break;case"m3":this.uniforms[i].value=new Ft().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ie().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},za=class extends Sn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},$n=class extends Xn{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new Ut(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new Ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=zl,this.normalScale=new _t(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ui,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Ga=class extends Xn{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Sp,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Va=class extends Xn{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function ys(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function ha(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Ri=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Ha=class extends Ri{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Uh,endingEnd:Uh}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Fh:r=t,a=2*e-i;break;case Oh:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Fh:o=t,l=2*i-e;break;case Oh:o=1,l=i+s[1]-s[0];break;default:o=t-1,l=e}let c=(i-e)*.5,h=this.valueSize;this._weightPrev=c/(e-a),this._weightNext=c/(l-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this._offsetPrev,u=this._offsetNext,f=this._weightPrev,p=this._weightNext,g=(i-e)/(s-e),_=g*g,m=_*g,d=-f*m+2*f*_-f*g,y=(1+f)*m+(-1.5-2*f)*_+(-.5+f)*g+1,w=(-1-p)*m+(1.5+p)*_+.5*g,M=p*m-p*_;for(let E=0;E!==a;++E)r[E]=d*o[h+E]+y*o[c+E]+w*o[l+E]+M*o[u+E];return r}},Wa=class extends Ri{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=(i-e)/(s-e),u=1-h;for(let f=0;f!==a;++f)r[f]=o[c+f]*u+o[l+f]*h;return r}},Xa=class extends Ri{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},$a=class extends Ri{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=t*a,c=l-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let g=(i-e)/(s-e),_=1-g;for(let m=0;m!==a;++m)r[m]=o[c+m]*_+o[l+m]*g;return r}let f=a*2,p=t-1;for(let g=0;g!==a;++g){let _=o[c+g],m=o[l+g],d=p*f+g*2,y=u[d],w=u[d+1],M=t*f+g*2,E=h[M],T=h[M+1],x=yx(i,e,y,E,s);r[g]=zp(x,_,w,T,m)}return r}};function zp(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function _x(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function yx(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=zp(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let l=_x(r,t,e,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var mn=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=ys(e,this.TimeBufferType),this.values=ys(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:ys(t.times,Array),values:ys(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),ha(t.settings)&&(i.settings={inTangents:ys(t.settings.inTangents,Array),outTangents:ys(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Xa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Wa(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Ha(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new $a(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case yr:e=this.InterpolantFactoryMethodDiscrete;break;case wa:e=this.InterpolantFactoryMethodLinear;break;case fa:e=this.InterpolantFactoryMethodSmooth;break;case Dh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Pt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return yr;case this.InterpolantFactoryMethodLinear:return wa;case this.InterpolantFactoryMethodSmooth:return fa;case this.InterpolantFactoryMethodBezier:return Dh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;ha(this.settings)&&(Xf(this.settings.inTangents,t),Xf(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;ha(this.settings)&&($f(this.settings.inTangents,t),$f(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Dt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Dt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){Dt("KeyframeTrack: Time is not a valid number.",this,a,l),t=!1;break}if(o!==null&&o>l){Dt("KeyframeTrack: Out of order keys.",this,a,l,o),t=!1;break}o=l}if(s!==void 0&&A0(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){Dt("KeyframeTrack: Value is not a valid number.",this,a,c),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===fa,r=t.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=t[a],h=t[a+1];if(c!==h&&(a!==1||c!==t[0]))if(s)l=!0;else{let u=a*i,f=u-i,p=u+i;for(let g=0;g!==i;++g){let _=e[u+g];if(_!==e[f+g]||_!==e[p+g]){l=!0;break}}}if(l){if(a!==o){t[o]=t[a];let u=a*i,f=o*i;for(let p=0;p!==i;++p)e[f+p]=e[u+p]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)e[l+c]=e[a+c];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,ha(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Xf(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function $f(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}mn.prototype.ValueTypeName="";mn.prototype.TimeBufferType=Float32Array;mn.prototype.ValueBufferType=Float32Array;mn.prototype.DefaultInterpolation=wa;var Ci=class extends mn{constructor(t,e,i){super(t,e,i)}};Ci.prototype.ValueTypeName="bool";Ci.prototype.ValueBufferType=Array;Ci.prototype.DefaultInterpolation=yr;Ci.prototype.InterpolantFactoryMethodLinear=void 0;Ci.prototype.InterpolantFactoryMethodSmooth=void 0;var qa=class extends mn{constructor(t,e,i,s){super(t,e,i,s)}};qa.prototype.ValueTypeName="color";var Ya=class extends mn{constructor(t,e,i,s){super(t,e,i,s)}};Ya.prototype.ValueTypeName="number";var ja=class extends Ri{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-e)/(s-e),c=t*a;for(let h=c+a;c!==h;c+=4)en.slerpFlat(r,0,o,c-a,o,c,l);return r}},Or=class extends mn{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new ja(this.times,this.values,this.getValueSize(),t)}};Or.prototype.ValueTypeName="quaternion";Or.prototype.InterpolantFactoryMethodSmooth=void 0;var Pi=class extends mn{constructor(t,e,i){super(t,e,i)}};Pi.prototype.ValueTypeName="string";Pi.prototype.ValueBufferType=Array;Pi.prototype.DefaultInterpolation=yr;Pi.prototype.InterpolantFactoryMethodLinear=void 0;Pi.prototype.InterpolantFactoryMethodSmooth=void 0;var Za=class extends mn{constructor(t,e,i,s){super(t,e,i,s)}};Za.prototype.ValueTypeName="vector";var Ja=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),l?l(h):h},this.setURLModifier=function(h){return l=h,this},this.addHandler=function(h,u){return c.push(h,u),this},this.removeHandler=function(h){let u=c.indexOf(h);return u!==-1&&c.splice(u,2),this},this.getHandler=function(h){for(let u=0,f=c.length;u<f;u+=2){let p=c[u],g=c[u+1];if(p.global&&(p.lastIndex=0),p.test(h))return g}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Gp=new Ja,Ka=class{constructor(t){this.manager=t!==void 0?t:Gp,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};Ka.DEFAULT_MATERIAL_NAME="__DEFAULT";var Br=class extends Ge{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new Ut(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},kr=class extends Br{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ge.DEFAULT_UP),this.updateMatrix(),this.groundColor=new Ut(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},Nh=new ie,qf=new N,Yf=new N,Qa=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new _t(512,512),this.mapType=ln,this.map=null,this.mapPass=null,this.matrix=new ie,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ti,this._frameExtents=new _t(1,1),this._viewportCount=1,this._viewports=[new ge(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;qf.setFromMatrixPosition(t.matrixWorld),e.position.copy(qf),Yf.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(Yf),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){Nh.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(Nh,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;t.coordinateSystem===ws||t.reversedDepth?e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),e.multiply(Nh)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},ua=new N,da=new en,Hn=new N,zr=class extends Ge{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ie,this.projectionMatrix=new ie,this.projectionMatrixInverse=new ie,this.coordinateSystem=Mn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(ua,da,Hn),Hn.x===1&&Hn.y===1&&Hn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ua,da,Hn.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(ua,da,Hn),Hn.x===1&&Hn.y===1&&Hn.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ua,da,Hn.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Si=new N,jf=new _t,Zf=new _t,Qe=class extends zr{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Ts*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(mr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Ts*2*Math.atan(Math.tan(mr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){Si.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Si.x,Si.y).multiplyScalar(-t/Si.z),Si.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Si.x,Si.y).multiplyScalar(-t/Si.z)}getViewSize(t,e){return this.getViewBounds(t,jf,Zf),e.subVectors(Zf,jf)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(mr*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,e-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var Gr=class extends zr{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,l=s-e;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=h*this.view.offsetY,l=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Bh=class extends Qa{constructor(){super(new Gr(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Vr=class extends Br{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ge.DEFAULT_UP),this.updateMatrix(),this.target=new Ge,this.shadow=new Bh}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var vs=-90,Ms=1,Ns=class extends Ge{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new Qe(vs,Ms,t,e);s.layers=this.layers,this.add(s);let r=new Qe(vs,Ms,t,e);r.layers=this.layers,this.add(r);let o=new Qe(vs,Ms,t,e);o.layers=this.layers,this.add(o);let a=new Qe(vs,Ms,t,e);a.layers=this.layers,this.add(a);let l=new Qe(vs,Ms,t,e);l.layers=this.layers,this.add(l);let c=new Qe(vs,Ms,t,e);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,l]=e;for(let c of e)this.remove(c);if(t===Mn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(t===ws)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let c of e)this.add(c),c.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,h]=this.children,u=t.getRenderTarget(),f=t.getActiveCubeFace(),p=t.getActiveMipmapLevel(),g=t.xr.enabled;t.xr.enabled=!1;let _=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),t.setRenderTarget(i,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),i.texture.mipmapsAutoUpdate=_,t.setRenderTarget(i,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,f,p),t.xr.enabled=g,i.texture.needsPMREMUpdate=!0}},tl=class extends Qe{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var bu="\\[\\]\\.:\\/",vx=new RegExp("["+bu+"]","g"),Su="[^"+bu+"]",Mx="[^"+bu.replace("\\.","")+"]",bx=/((?:WC+[\/:])*)/.source.replace("WC",Su),Sx=/(WCOD+)?/.source.replace("WCOD",Mx),wx=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",Su),Ex=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",Su),Tx=new RegExp("^"+bx+Sx+wx+Ex+"$"),Ax=["material","materials","bones","map"],kh=class{constructor(t,e,i){let s=i||ue.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},ue=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(vx,"")}static parseTrackName(t){let e=Tx.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);Ax.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let l=i(a.children);if(l)return l}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Pt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=e.objectIndex;switch(i){case"materials":if(!t.material){Dt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Dt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Dt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===c){c=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Dt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Dt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Dt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(c!==void 0){if(t[c]===void 0){Dt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[c]}}let o=t[s];if(o===void 0){let c=e.nodeName;Dt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Dt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Dt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ue.Composite=kh;ue.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ue.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ue.prototype.GetterByBindingType=[ue.prototype._getValue_direct,ue.prototype._getValue_array,ue.prototype._getValue_arrayElement,ue.prototype._getValue_toArray];ue.prototype.SetterByBindingTypeAndVersioning=[[ue.prototype._setValue_direct,ue.prototype._setValue_direct_setNeedsUpdate,ue.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ue.prototype._setValue_array,ue.prototype._setValue_array_setNeedsUpdate,ue.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ue.prototype._setValue_arrayElement,ue.prototype._setValue_arrayElement_setNeedsUpdate,ue.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ue.prototype._setValue_fromArray,ue.prototype._setValue_fromArray_setNeedsUpdate,ue.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var E1=new Float32Array(1);var Jf=new ie,Hr=class{constructor(t,e,i=0,s=1/0){this.ray=new Ei(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new Rs,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Dt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return Jf.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(Jf),this}intersectObject(t,e=!0,i=[]){return zh(t,this,i,e),i.sort(Kf),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)zh(t[s],this,i,e);return i.sort(Kf),i}};function Kf(n,t){return n.distance-t.distance}function zh(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)zh(r[o],t,e,!0)}}var Ii=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Wt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Wt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Gh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var Wr=class extends Ln{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function wu(n,t,e,i){let s=Rx(i);switch(e){case au:return n*t;case cu:return n*t/s.components*s.byteLength;case al:return n*t/s.components*s.byteLength;case Ui:return n*t*2/s.components*s.byteLength;case ll:return n*t*2/s.components*s.byteLength;case lu:return n*t*3/s.components*s.byteLength;case On:return n*t*4/s.components*s.byteLength;case cl:return n*t*4/s.components*s.byteLength;case $r:case qr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case Yr:case jr:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case ul:case fl:return Math.max(n,16)*Math.max(t,8)/4;case hl:case dl:return Math.max(n,8)*Math.max(t,8)/2;case pl:case ml:case xl:case _l:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case gl:case Zr:case yl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case vl:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case Ml:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case bl:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case Sl:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case wl:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case El:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case Tl:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case Al:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case Rl:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case Cl:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case Pl:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case Il:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case Ll:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case Nl:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Dl:case Ul:case Fl:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Ol:case Bl:return Math.ceil(n/4)*Math.ceil(t/4)*8;case Jr:case kl:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function Rx(n){switch(n){case ln:case iu:return{byteLength:1,components:1};case Os:case su:case Fn:return{byteLength:2,components:1};case rl:case ol:return{byteLength:2,components:4};case Dn:case sl:case Un:return{byteLength:4,components:1};case ru:case ou:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Pt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function cm(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function Px(n){let t=new WeakMap;function e(a,l){let c=a.array,h=a.usage,u=c.byteLength,f=n.createBuffer();n.bindBuffer(l,f),n.bufferData(l,c,h),a.onUploadCallback();let p;if(c instanceof Float32Array)p=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)p=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?p=n.HALF_FLOAT:p=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)p=n.SHORT;else if(c instanceof Uint32Array)p=n.UNSIGNED_INT;else if(c instanceof Int32Array)p=n.INT;else if(c instanceof Int8Array)p=n.BYTE;else if(c instanceof Uint8Array)p=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)p=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:f,type:p,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,l,c){let h=l.array,u=l.updateRanges;if(n.bindBuffer(c,a),u.length===0)n.bufferSubData(c,0,h);else{u.sort((p,g)=>p.start-g.start);let f=0;for(let p=1;p<u.length;p++){let g=u[f],_=u[p];_.start<=g.start+g.count+1?g.count=Math.max(g.count,_.start+_.count-g.start):(++f,u[f]=_)}u.length=f+1;for(let p=0,g=u.length;p<g;p++){let _=u[p];n.bufferSubData(c,_.start*h.BYTES_PER_ELEMENT,h,_.start,_.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=t.get(a);l&&(n.deleteBuffer(l.buffer),t.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=t.get(a);if(c===void 0)t.set(a,e(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var Ix=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,Lx=`#ifdef USE_ALPHAHASH
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
#endif`,Nx=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,Dx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,Ux=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,Fx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,Ox=`#ifdef USE_AOMAP
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
#endif`,Bx=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,kx=`#ifdef USE_BATCHING
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
#endif`,zx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,Gx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,Vx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,Hx=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,Wx=`#ifdef USE_IRIDESCENCE
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
#endif`,Xx=`#ifdef USE_BUMPMAP
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
#endif`,$x=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,qx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,Yx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,jx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,Zx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Jx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,Kx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Qx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,t_=`#define PI 3.141592653589793
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
} // validated`,e_=`vec3 transformedNormal = objectNormal;
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
#endif`,n_=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,i_=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,s_=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,r_=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,o_="gl_FragColor = linearToOutputTexel( gl_FragColor );",a_=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,l_=`#ifdef USE_ENVMAP
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
#endif`,c_=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,h_=`#ifdef USE_ENVMAP
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
#endif`,u_=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,d_=`#ifdef USE_ENVMAP
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
#endif`,f_=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,p_=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,m_=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,g_=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,x_=`#ifdef USE_GRADIENTMAP
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
}`,__=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,y_=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,v_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,M_=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,b_=`#ifdef USE_ENVMAP
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
#endif`,S_=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,w_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,E_=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,T_=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,A_=`PhysicalMaterial material;
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
#endif`,R_=`uniform sampler2D dfgLUT;
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
}`,C_=`
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
#endif`,P_=`#if defined( RE_IndirectDiffuse )
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
#endif`,I_=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,L_=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,N_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,D_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,U_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,F_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,O_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,B_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,k_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,z_=`#if defined( USE_POINTS_UV )
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
#endif`,G_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,V_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,H_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,W_=`#if defined( USE_MORPHCOLORS )
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
#endif`,X_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,$_=`#ifdef USE_MORPHTARGETS
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
#endif`,q_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,Y_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,j_=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,Z_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,J_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,K_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,Q_=`#ifdef USE_NORMALMAP
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
#endif`,ty=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,ey=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,ny=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iy=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,sy=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,ry=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,oy=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,ay=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,ly=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,cy=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hy=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uy=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,dy=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fy=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,py=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,my=`float getShadowMask() {
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
}`,gy=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,xy=`#ifdef USE_SKINNING
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
#endif`,_y=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,yy=`#ifdef USE_SKINNING
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
#endif`,vy=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,My=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,by=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,Sy=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,wy=`#ifdef USE_TRANSMISSION
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
#endif`,Ey=`#ifdef USE_TRANSMISSION
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
#endif`,Ty=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ay=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Ry=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,Cy=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Py=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Iy=`uniform sampler2D t2D;
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
}`,Ly=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Ny=`uniform float backgroundBlurriness;
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
}`,Dy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Uy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Fy=`#include <common>
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
}`,Oy=`#if DEPTH_PACKING == 3200
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
}`,By=`#define DISTANCE
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
}`,ky=`#define DISTANCE
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
}`,zy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,Gy=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Vy=`uniform float scale;
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
}`,Hy=`uniform vec3 diffuse;
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
}`,Wy=`#include <common>
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
}`,Xy=`uniform vec3 diffuse;
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
}`,$y=`#define LAMBERT
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
}`,qy=`#define LAMBERT
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
}`,Yy=`#define MATCAP
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
}`,jy=`#define MATCAP
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
}`,Zy=`#define NORMAL
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
}`,Jy=`#define NORMAL
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
}`,Ky=`#define PHONG
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
}`,Qy=`#define PHONG
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
}`,tv=`#define STANDARD
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
}`,ev=`#define STANDARD
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
}`,nv=`#define TOON
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
}`,iv=`#define TOON
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
}`,sv=`uniform float size;
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
}`,rv=`uniform vec3 diffuse;
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
}`,ov=`#include <common>
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
}`,av=`uniform vec3 color;
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
}`,lv=`uniform float rotation;
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
}`,cv=`uniform vec3 diffuse;
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
}`,Xt={alphahash_fragment:Ix,alphahash_pars_fragment:Lx,alphamap_fragment:Nx,alphamap_pars_fragment:Dx,alphatest_fragment:Ux,alphatest_pars_fragment:Fx,aomap_fragment:Ox,aomap_pars_fragment:Bx,batching_pars_vertex:kx,batching_vertex:zx,begin_vertex:Gx,beginnormal_vertex:Vx,bsdfs:Hx,iridescence_fragment:Wx,bumpmap_pars_fragment:Xx,clipping_planes_fragment:$x,clipping_planes_pars_fragment:qx,clipping_planes_pars_vertex:Yx,clipping_planes_vertex:jx,color_fragment:Zx,color_pars_fragment:Jx,color_pars_vertex:Kx,color_vertex:Qx,common:t_,defaultnormal_vertex:e_,displacementmap_pars_vertex:n_,displacementmap_vertex:i_,emissivemap_fragment:s_,emissivemap_pars_fragment:r_,colorspace_fragment:o_,colorspace_pars_fragment:a_,envmap_fragment:l_,envmap_common_pars_fragment:c_,envmap_pars_fragment:h_,envmap_pars_vertex:u_,envmap_physical_pars_fragment:b_,envmap_vertex:d_,fog_vertex:f_,fog_pars_vertex:p_,fog_fragment:m_,fog_pars_fragment:g_,gradientmap_pars_fragment:x_,lightmap_pars_fragment:__,lights_lambert_fragment:y_,lights_lambert_pars_fragment:v_,lights_pars_begin:M_,lights_toon_fragment:S_,lights_toon_pars_fragment:w_,lights_phong_fragment:E_,lights_phong_pars_fragment:T_,lights_physical_fragment:A_,lights_physical_pars_fragment:R_,lights_fragment_begin:C_,lights_fragment_maps:P_,lights_fragment_end:I_,lightprobes_pars_fragment:L_,logdepthbuf_fragment:N_,logdepthbuf_pars_fragment:D_,logdepthbuf_pars_vertex:U_,logdepthbuf_vertex:F_,map_fragment:O_,map_pars_fragment:B_,map_particle_fragment:k_,map_particle_pars_fragment:z_,metalnessmap_fragment:G_,metalnessmap_pars_fragment:V_,morphinstance_vertex:H_,morphcolor_vertex:W_,morphnormal_vertex:X_,morphtarget_pars_vertex:$_,morphtarget_vertex:q_,normal_fragment_begin:Y_,normal_fragment_maps:j_,normal_pars_fragment:Z_,normal_pars_vertex:J_,normal_vertex:K_,normalmap_pars_fragment:Q_,clearcoat_normal_fragment_begin:ty,clearcoat_normal_fragment_maps:ey,clearcoat_pars_fragment:ny,iridescence_pars_fragment:iy,opaque_fragment:sy,packing:ry,premultiplied_alpha_fragment:oy,project_vertex:ay,dithering_fragment:ly,dithering_pars_fragment:cy,roughnessmap_fragment:hy,roughnessmap_pars_fragment:uy,shadowmap_pars_fragment:dy,shadowmap_pars_vertex:fy,shadowmap_vertex:py,shadowmask_pars_fragment:my,skinbase_vertex:gy,skinning_pars_vertex:xy,skinning_vertex:_y,skinnormal_vertex:yy,specularmap_fragment:vy,specularmap_pars_fragment:My,tonemapping_fragment:by,tonemapping_pars_fragment:Sy,transmission_fragment:wy,transmission_pars_fragment:Ey,uv_pars_fragment:Ty,uv_pars_vertex:Ay,uv_vertex:Ry,worldpos_vertex:Cy,background_vert:Py,background_frag:Iy,backgroundCube_vert:Ly,backgroundCube_frag:Ny,cube_vert:Dy,cube_frag:Uy,depth_vert:Fy,depth_frag:Oy,distance_vert:By,distance_frag:ky,equirect_vert:zy,equirect_frag:Gy,linedashed_vert:Vy,linedashed_frag:Hy,meshbasic_vert:Wy,meshbasic_frag:Xy,meshlambert_vert:$y,meshlambert_frag:qy,meshmatcap_vert:Yy,meshmatcap_frag:jy,meshnormal_vert:Zy,meshnormal_frag:Jy,meshphong_vert:Ky,meshphong_frag:Qy,meshphysical_vert:tv,meshphysical_frag:ev,meshtoon_vert:nv,meshtoon_frag:iv,points_vert:sv,points_frag:rv,shadow_vert:ov,shadow_frag:av,sprite_vert:lv,sprite_frag:cv},pt={common:{diffuse:{value:new Ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ft}},envmap:{envMap:{value:null},envMapRotation:{value:new Ft},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ft}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ft}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ft},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ft},normalScale:{value:new _t(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ft},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ft}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ft}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ft}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new Ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new Ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0},uvTransform:{value:new Ft}},sprite:{diffuse:{value:new Ut(16777215)},opacity:{value:1},center:{value:new _t(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ft},alphaMap:{value:null},alphaMapTransform:{value:new Ft},alphaTest:{value:0}}},jn={basic:{uniforms:je([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.fog]),vertexShader:Xt.meshbasic_vert,fragmentShader:Xt.meshbasic_frag},lambert:{uniforms:je([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,pt.lights,{emissive:{value:new Ut(0)},envMapIntensity:{value:1}}]),vertexShader:Xt.meshlambert_vert,fragmentShader:Xt.meshlambert_frag},phong:{uniforms:je([pt.common,pt.specularmap,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,pt.lights,{emissive:{value:new Ut(0)},specular:{value:new Ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Xt.meshphong_vert,fragmentShader:Xt.meshphong_frag},standard:{uniforms:je([pt.common,pt.envmap,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.roughnessmap,pt.metalnessmap,pt.fog,pt.lights,{emissive:{value:new Ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Xt.meshphysical_vert,fragmentShader:Xt.meshphysical_frag},toon:{uniforms:je([pt.common,pt.aomap,pt.lightmap,pt.emissivemap,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.gradientmap,pt.fog,pt.lights,{emissive:{value:new Ut(0)}}]),vertexShader:Xt.meshtoon_vert,fragmentShader:Xt.meshtoon_frag},matcap:{uniforms:je([pt.common,pt.bumpmap,pt.normalmap,pt.displacementmap,pt.fog,{matcap:{value:null}}]),vertexShader:Xt.meshmatcap_vert,fragmentShader:Xt.meshmatcap_frag},points:{uniforms:je([pt.points,pt.fog]),vertexShader:Xt.points_vert,fragmentShader:Xt.points_frag},dashed:{uniforms:je([pt.common,pt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Xt.linedashed_vert,fragmentShader:Xt.linedashed_frag},depth:{uniforms:je([pt.common,pt.displacementmap]),vertexShader:Xt.depth_vert,fragmentShader:Xt.depth_frag},normal:{uniforms:je([pt.common,pt.bumpmap,pt.normalmap,pt.displacementmap,{opacity:{value:1}}]),vertexShader:Xt.meshnormal_vert,fragmentShader:Xt.meshnormal_frag},sprite:{uniforms:je([pt.sprite,pt.fog]),vertexShader:Xt.sprite_vert,fragmentShader:Xt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ft},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Xt.background_vert,fragmentShader:Xt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ft}},vertexShader:Xt.backgroundCube_vert,fragmentShader:Xt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Xt.cube_vert,fragmentShader:Xt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Xt.equirect_vert,fragmentShader:Xt.equirect_frag},distance:{uniforms:je([pt.common,pt.displacementmap,{referencePosition:{value:new N},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Xt.distance_vert,fragmentShader:Xt.distance_frag},shadow:{uniforms:je([pt.lights,pt.fog,{color:{value:new Ut(0)},opacity:{value:1}}]),vertexShader:Xt.shadow_vert,fragmentShader:Xt.shadow_frag}};jn.physical={uniforms:je([jn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ft},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ft},clearcoatNormalScale:{value:new _t(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ft},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ft},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ft},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ft},sheen:{value:0},sheenColor:{value:new Ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ft},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ft},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ft},transmissionSamplerSize:{value:new _t},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ft},attenuationDistance:{value:0},attenuationColor:{value:new Ut(0)},specularColor:{value:new Ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ft},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ft},anisotropyVector:{value:new _t},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ft}}]),vertexShader:Xt.meshphysical_vert,fragmentShader:Xt.meshphysical_frag};var Gl={r:0,b:0,g:0},hv=new ie,hm=new Ft;hm.set(-1,0,0,0,1,0,0,0,1);function uv(n,t,e,i,s,r){let o=new Ut(0),a=s===!0?0:1,l,c,h=null,u=0,f=null;function p(y){let w=y.isScene===!0?y.background:null;if(w&&w.isTexture){let M=y.backgroundBlurriness>0;w=t.get(w,M)}return w}function g(y){let w=!1,M=p(y);M===null?m(o,a):M&&M.isColor&&(m(M,1),w=!0);let E=n.xr.getEnvironmentBlendMode();E==="additive"?e.buffers.color.setClear(0,0,0,1,r):E==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||w)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function _(y,w){let M=p(w);M&&M.isCubeTexture?(c===void 0&&(c=new Ce(new Ai(1,1,1),new Sn({name:"BackgroundCubeMaterial",uniforms:ns(jn.backgroundCube.uniforms),vertexShader:jn.backgroundCube.vertexShader,fragmentShader:jn.backgroundCube.fragmentShader,side:nn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(E,T,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=w.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(hv.makeRotationFromEuler(w.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(hm),c.material.toneMapped=Jt.getTransfer(M.colorSpace)!==ne,(h!==M||u!==M.version||f!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,f=n.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Ce(new Zi(2,2),new Sn({name:"BackgroundMaterial",uniforms:ns(jn.background.uniforms),vertexShader:jn.background.vertexShader,fragmentShader:jn.background.fragmentShader,side:Di,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=w.backgroundIntensity,l.material.toneMapped=Jt.getTransfer(M.colorSpace)!==ne,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||f!==n.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,f=n.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null))}function m(y,w){y.getRGB(Gl,Mu(n)),e.buffers.color.setClear(Gl.r,Gl.g,Gl.b,w,r)}function d(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,w=1){o.set(y),a=w,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:g,addToRenderList:_,dispose:d}}function dv(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=f(null),r=s,o=!1;function a(I,F,H,P,B){let V=!1,W=u(I,P,H,F);r!==W&&(r=W,c(r.object)),V=p(I,P,H,B),V&&g(I,P,H,B),B!==null&&t.update(B,n.ELEMENT_ARRAY_BUFFER),(V||o)&&(o=!1,M(I,F,H,P),B!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(B).buffer))}function l(){return n.createVertexArray()}function c(I){return n.bindVertexArray(I)}function h(I){return n.deleteVertexArray(I)}function u(I,F,H,P){let B=P.wireframe===!0,V=i[F.id];V===void 0&&(V={},i[F.id]=V);let W=I.isInstancedMesh===!0?I.id:0,tt=V[W];tt===void 0&&(tt={},V[W]=tt);let $=tt[H.id];$===void 0&&($={},tt[H.id]=$);let Q=$[B];return Q===void 0&&(Q=f(l()),$[B]=Q),Q}function f(I){let F=[],H=[],P=[];for(let B=0;B<e;B++)F[B]=0,H[B]=0,P[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:F,enabledAttributes:H,attributeDivisors:P,object:I,attributes:{},index:null}}function p(I,F,H,P){let B=r.attributes,V=F.attributes,W=0,tt=H.getAttributes();for(let $ in tt)if(tt[$].location>=0){let et=B[$],wt=V[$];if(wt===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(wt=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(wt=I.instanceColor)),et===void 0||et.attribute!==wt||wt&&et.data!==wt.data)return!0;W++}return r.attributesNum!==W||r.index!==P}function g(I,F,H,P){let B={},V=F.attributes,W=0,tt=H.getAttributes();for(let $ in tt)if(tt[$].location>=0){let et=V[$];et===void 0&&($==="instanceMatrix"&&I.instanceMatrix&&(et=I.instanceMatrix),$==="instanceColor"&&I.instanceColor&&(et=I.instanceColor));let wt={};wt.attribute=et,et&&et.data&&(wt.data=et.data),B[$]=wt,W++}r.attributes=B,r.attributesNum=W,r.index=P}function _(){let I=r.newAttributes;for(let F=0,H=I.length;F<H;F++)I[F]=0}function m(I){d(I,0)}function d(I,F){let H=r.newAttributes,P=r.enabledAttributes,B=r.attributeDivisors;H[I]=1,P[I]===0&&(n.enableVertexAttribArray(I),P[I]=1),B[I]!==F&&(n.vertexAttribDivisor(I,F),B[I]=F)}function y(){let I=r.newAttributes,F=r.enabledAttributes;for(let H=0,P=F.length;H<P;H++)F[H]!==I[H]&&(n.disableVertexAttribArray(H),F[H]=0)}function w(I,F,H,P,B,V,W){W===!0?n.vertexAttribIPointer(I,F,H,B,V):n.vertexAttribPointer(I,F,H,P,B,V)}function M(I,F,H,P){_();let B=P.attributes,V=H.getAttributes(),W=F.defaultAttributeValues;for(let tt in V){let $=V[tt];if($.location>=0){let Q=B[tt];if(Q===void 0&&(tt==="instanceMatrix"&&I.instanceMatrix&&(Q=I.instanceMatrix),tt==="instanceColor"&&I.instanceColor&&(Q=I.instanceColor)),Q!==void 0){let et=Q.normalized,wt=Q.itemSize,Bt=t.get(Q);if(Bt===void 0)continue;let Z=Bt.buffer,mt=Bt.type,Mt=Bt.bytesPerElement,It=mt===n.INT||mt===n.UNSIGNED_INT||Q.gpuType===sl;if(Q.isInterleavedBufferAttribute){let gt=Q.data,zt=gt.isInterleavedBuffer===!0?gt.stride:gt.itemSize,be=Q.offset;if(gt.isInstancedInterleavedBuffer||gt.isInstancedBufferAttribute){for(let Nt=0;Nt<$.locationSize;Nt++)d($.location+Nt,gt.meshPerAttribute);I.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=gt.meshPerAttribute*gt.count)}else for(let Nt=0;Nt<$.locationSize;Nt++)m($.location+Nt);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let Nt=0;Nt<$.locationSize;Nt++)w($.location+Nt,wt/$.locationSize,mt,et,zt*Mt,(be+wt/$.locationSize*Nt)*Mt,It)}else{if(Q.isInstancedBufferAttribute){for(let gt=0;gt<$.locationSize;gt++)d($.location+gt,Q.meshPerAttribute);I.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let gt=0;gt<$.locationSize;gt++)m($.location+gt);n.bindBuffer(n.ARRAY_BUFFER,Z);for(let gt=0;gt<$.locationSize;gt++)w($.location+gt,wt/$.locationSize,mt,et,wt*Mt,wt/$.locationSize*gt*Mt,It)}}else if(W!==void 0){let et=W[tt];if(et!==void 0)switch(et.length){case 2:n.vertexAttrib2fv($.location,et);break;case 3:n.vertexAttrib3fv($.location,et);break;case 4:n.vertexAttrib4fv($.location,et);break;default:n.vertexAttrib1fv($.location,et)}}}}y()}function E(){C();for(let I in i){let F=i[I];for(let H in F){let P=F[H];for(let B in P){let V=P[B];for(let W in V)h(V[W].object),delete V[W];delete P[B]}}delete i[I]}}function T(I){if(i[I.id]===void 0)return;let F=i[I.id];for(let H in F){let P=F[H];for(let B in P){let V=P[B];for(let W in V)h(V[W].object),delete V[W];delete P[B]}}delete i[I.id]}function x(I){for(let F in i){let H=i[F];for(let P in H){let B=H[P];if(B[I.id]===void 0)continue;let V=B[I.id];for(let W in V)h(V[W].object),delete V[W];delete B[I.id]}}}function v(I){for(let F in i){let H=i[F],P=I.isInstancedMesh===!0?I.id:0,B=H[P];if(B!==void 0){for(let V in B){let W=B[V];for(let tt in W)h(W[tt].object),delete W[tt];delete B[V]}delete H[P],Object.keys(H).length===0&&delete i[F]}}}function C(){R(),o=!0,r!==s&&(r=s,c(r.object))}function R(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:C,resetDefaultState:R,dispose:E,releaseStatesOfGeometry:T,releaseStatesOfObject:v,releaseStatesOfProgram:x,initAttributes:_,enableAttribute:m,disableUnusedAttributes:y}}function fv(n,t,e){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),e.update(c,i,1)}function o(l,c,h){h!==0&&(n.drawArraysInstanced(i,l,c,h),e.update(c,i,h))}function a(l,c,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,h);let f=0;for(let p=0;p<h;p++)f+=c[p];e.update(f,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function pv(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let x=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==On&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let v=x===Fn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(x!==ln&&x!==Un&&!v&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=e.precision!==void 0?e.precision:"highp",h=l(c);h!==c&&(Pt("WebGLRenderer:",c,"not supported, using",h,"instead."),c=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),f=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Pt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Pt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let p=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),g=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),_=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),d=n.getParameter(n.MAX_VERTEX_ATTRIBS),y=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),w=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),E=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:f,reversedDepthBuffer:u,maxTextures:p,maxVertexTextures:g,maxTextureSize:_,maxCubemapSize:m,maxAttributes:d,maxVertexUniforms:y,maxVaryings:w,maxFragmentUniforms:M,maxSamples:E,samples:T}}function mv(n){let t=this,e=null,i=0,s=!1,r=!1,o=new Ke,a=new Ft,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(u,f){let p=u.length!==0||f||i!==0||s;return s=f,i=u.length,p},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,f){e=h(u,f,0)},this.setState=function(u,f,p){let g=u.clippingPlanes,_=u.clipIntersection,m=u.clipShadows,d=n.get(u);if(!s||g===null||g.length===0||r&&!m)r?h(null):c();else{let y=r?0:i,w=y*4,M=d.clippingState||null;l.value=M,M=h(g,f,w,p);for(let E=0;E!==w;++E)M[E]=e[E];d.clippingState=M,this.numIntersection=_?this.numPlanes:0,this.numPlanes+=y}};function c(){l.value!==e&&(l.value=e,l.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,f,p,g){let _=u!==null?u.length:0,m=null;if(_!==0){if(m=l.value,g!==!0||m===null){let d=p+_*4,y=f.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<d)&&(m=new Float32Array(d));for(let w=0,M=p;w!==_;++w,M+=4)o.copy(u[w]).applyMatrix4(y,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return t.numPlanes=_,t.numIntersection=0,m}}var to=class extends pn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Rr(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ai(5,5,5),r=new Sn({name:"CubemapFromEquirect",uniforms:ns(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:nn,blending:Ki});r.uniforms.tEquirect.value=e;let o=new Ce(s,r),a=e.minFilter;return e.minFilter===fi&&(e.minFilter=tn),new Ns(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},Vp=256,gv=3,xv=20,um=256,dm=16,_v=3,yv=new N,vv=new Ut,Hl=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ns(1,10,null),this._boxMesh=new Ce(new Ai(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=yv}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=l.autoClear,f=l.autoClearColor,p=l.autoClearDepth,g=l.autoClearStencil,_=t.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,_===null&&(t.background=l.getClearColor(vv));let m=new Ns(i,s,h);return m.position.copy(a),m.update(l,t),l.autoClear=u,l.autoClearColor=f,l.autoClearDepth=p,l.autoClearStencil=g,t.background=_,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(c,e)),this._applyPMREM(c),c}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Xp(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Wp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(Vp,xu(t))}_fromTexture(t,e){t.mapping===ts||t.mapping===Fs?this._setSize(t.image.length===0?Vp:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=Hp(t,!1,!1),i=Math.log2(t)-gv;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Hp(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===ts||t.mapping===Fs?(this._cubemapMaterial===null&&(this._cubemapMaterial=Xp()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Wp()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Mv(),this._integrationMaterial=bv());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/dm);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-_v)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let l=a>0?Math.log2(e)+.5*Math.log2(6/(um*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=Sv());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function Hp(n,t,e){return new to(n,{minFilter:fi,generateMipmaps:t,type:Fn,colorSpace:vr,depthBuffer:e})}function eo(n,t,e){return new Sn({name:n,uniforms:t,vertexShader:Xt.cube_vert,fragmentShader:e,side:nn,blending:Ki,depthTest:!1,depthWrite:!1})}function Mv(){return eo("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${um}u

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
	`)}function bv(){return eo("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:dm}},`

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
	`)}function Sv(){return eo("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${xv}
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
	`)}function Wp(){return eo("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Xp(){return eo("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function wv(n){let t=new WeakMap,e=new WeakMap,i=null;function s(f,p=!1){return f==null?null:p?o(f):r(f)}function r(f){if(f&&f.isTexture){let p=f.mapping;if(p===el||p===nl)if(t.has(f)){let g=t.get(f).texture;return a(g,f.mapping)}else{let g=f.image;if(g&&g.height>0){let _=new to(g.height);return _.fromEquirectangularTexture(n,f),t.set(f,_),f.addEventListener("dispose",c),a(_.texture,f.mapping)}else return null}}return f}function o(f){if(f&&f.isTexture&&f.isPMREMTexture!==!0){let p=f.mapping,g=p===el||p===nl,_=p===ts||p===Fs;if(g||_){let m=e.get(f),d=m!==void 0?m.texture.pmremVersion:0;if(f.isRenderTargetTexture&&f.pmremVersion!==d)return i===null&&(i=new Hl(n)),m=g?i.fromEquirectangular(f,m):i.fromCubemap(f,m),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),m.texture;if(m!==void 0)return m.texture;{let y=f.image;return g&&y&&y.height>0||_&&y&&l(y)?(i===null&&(i=new Hl(n)),m=g?i.fromEquirectangular(f):i.fromCubemap(f),m.texture.pmremVersion=f.pmremVersion,e.set(f,m),f.addEventListener("dispose",h),m.texture):null}}}return f}function a(f,p){return p===el?f.mapping=ts:p===nl&&(f.mapping=Fs),f}function l(f){let p=0,g=6;for(let _=0;_<g;_++)f[_]!==void 0&&p++;return p===g}function c(f){let p=f.target;p.removeEventListener("dispose",c);let g=t.get(p);g!==void 0&&(t.delete(p),g.dispose())}function h(f){let p=f.target;p.removeEventListener("dispose",h);let g=e.get(p);g!==void 0&&(e.delete(p),g.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function Ev(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&pr("WebGLRenderer: "+i+" extension not supported."),s}}}function Tv(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(g=>delete s[g]);function a(g){l(g.target)}function l(g){g.index!==null&&t.remove(g.index);for(let m in g.attributes)t.remove(g.attributes[m]);g.removeEventListener("dispose",a),delete s[g.id],o.unregister(g);let _=r.get(g);_&&(t.remove(_),r.delete(g)),i.releaseStatesOfGeometry(g),g.isInstancedBufferGeometry===!0&&delete g._maxInstanceCount,e.memory.geometries--}function c(g,_){return s[_.id]!==void 0||(_.addEventListener("dispose",a),s[_.id]=new WeakRef(_),o.register(_,_.id,_),e.memory.geometries++),_}function h(g){let _=g.attributes;for(let m in _)t.update(_[m],n.ARRAY_BUFFER)}function u(g){let _=g.index,m=g.attributes.position,d=0;if(m===void 0)return;let y=_!==null?_.array.length:m.array.length/3-1,w=m.count>=65535?Tr:Er,M=new w(Math.ceil(y/3)*6,1),E=M.array;if(_!==null){let x=_.array;d=_.version;for(let v=0,C=0;v<y;v+=3){let R=x[v+0],I=x[v+1],F=x[v+2];E[C++]=R,E[C++]=I,E[C++]=I,E[C++]=F,E[C++]=F,E[C++]=R}}else{d=m.version;for(let x=0,v=0;x<y;x+=3){let C=x+0,R=x+1,I=x+2;E[v++]=C,E[v++]=R,E[v++]=R,E[v++]=I,E[v++]=I,E[v++]=C}}M.version=d;let T=r.get(g);T&&t.remove(T),r.set(g,M)}function f(g){let _=r.get(g);if(_){let m=g.index;m!==null&&_.version<m.version&&u(g)}else u(g);return r.get(g)}function p(){for(let g in s){let _=s[g].deref();_!==void 0&&l(_)}}return{get:c,update:h,getWireframeAttribute:f,dispose:p}}function Av(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function l(u,f){n.drawElements(i,f,r,u*o),e.update(f,i,1)}function c(u,f,p){p!==0&&(n.drawElementsInstanced(i,f,r,u*o,p),e.update(f,i,p))}function h(u,f,p){if(p===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,f,0,r,u,0,p);let _=0;for(let m=0;m<p;m++)_+=f[m];e.update(_,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=h}function Rv(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Dt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function Cv(n,t,e){let i=new WeakMap,s=new ge;function r(o,a,l){let c=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,f=i.get(a);if(f===void 0||f.count!==u){let C=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",C)};f!==void 0&&f.texture.dispose();let p=a.morphAttributes.position!==void 0,g=a.morphAttributes.normal!==void 0,_=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],d=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],w=0;p===!0&&(w=1),g===!0&&(w=2),_===!0&&(w=3);let M=a.attributes.position.count*w,E=1;M>t.maxTextureSize&&(E=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let T=new Float32Array(M*E*4*u),x=new Sr(T,M,E,u);x.type=Un,x.needsUpdate=!0;let v=w*4;for(let R=0;R<u;R++){let I=m[R],F=d[R],H=y[R],P=M*E*4*R;for(let B=0;B<I.count;B++){let V=B*v;p===!0&&(s.fromBufferAttribute(I,B),T[P+V+0]=s.x,T[P+V+1]=s.y,T[P+V+2]=s.z,T[P+V+3]=0),g===!0&&(s.fromBufferAttribute(F,B),T[P+V+4]=s.x,T[P+V+5]=s.y,T[P+V+6]=s.z,T[P+V+7]=0),_===!0&&(s.fromBufferAttribute(H,B),T[P+V+8]=s.x,T[P+V+9]=s.y,T[P+V+10]=s.z,T[P+V+11]=H.itemSize===4?s.w:1)}}f={count:u,texture:x,size:new _t(M,E)},i.set(a,f),a.addEventListener("dispose",C)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let p=0;for(let _=0;_<c.length;_++)p+=c[_];let g=a.morphTargetsRelative?1:1-p;l.getUniforms().setValue(n,"morphTargetBaseInfluence",g),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",f.texture,e),l.getUniforms().setValue(n,"morphTargetsTextureSize",f.size)}return{update:r}}function Pv(n,t,e,i,s){let r=new WeakMap;function o(c){let h=s.render.frame,u=c.geometry,f=t.get(c,u);if(r.get(f)!==h&&(t.update(f),r.set(f,h)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==h&&(e.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&e.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,h))),c.isSkinnedMesh){let p=c.skeleton;r.get(p)!==h&&(p.update(),r.set(p,h))}return f}function a(){r=new WeakMap}function l(c){let h=c.target;h.removeEventListener("dispose",l),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Iv={[jh]:"LINEAR_TONE_MAPPING",[Zh]:"REINHARD_TONE_MAPPING",[Jh]:"CINEON_TONE_MAPPING",[Kh]:"ACES_FILMIC_TONE_MAPPING",[tu]:"AGX_TONE_MAPPING",[eu]:"NEUTRAL_TONE_MAPPING",[Qh]:"CUSTOM_TONE_MAPPING"};function Lv(n,t,e,i,s,r){let o=new pn(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,h=new an;h.setAttribute("position",new Me([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Me([0,2,0,0,2,0],2));let u=new za({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),f=new Ce(h,u),p=new Gr(-1,1,1,-1,0,1),g=null,_=null,m=!1,d,y=null,w=[],M=!1;this.setSize=function(E,T){o.setSize(E,T),a!==null&&a.setSize(E,T),l!==null&&l.setSize(E,T);for(let x=0;x<w.length;x++){let v=w[x];v.setSize&&v.setSize(E,T)}},this.setEffects=function(E){w=E,M=w.length>0&&w[0].isRenderPass===!0;let T=o.width,x=o.height;w.length>0&&a===null&&(a=new pn(T,x,{type:Fn,depthBuffer:!1,stencilBuffer:!1}),l=new pn(T,x,{type:Fn,depthBuffer:!1,stencilBuffer:!1}));let v=s===!0&&w.some(C=>C.needsDepthTexture===!0);v!==(o.depthTexture!==null)&&(v===!0&&c===null&&(c=new di(T,x),r===!0&&(c.format=pi,c.type=es)),o.dispose(),o.depthTexture=v?c:null,o.resolveDepthBuffer=v,o.storeMultisampledDepthBuffer=v);for(let C=0;C<w.length;C++){let R=w[C];R.setSize&&R.setSize(T,x),v&&R.needsDepthTexture===!0&&R.setDepthTexture&&R.setDepthTexture(c)}},this.begin=function(E,T){if(m||E.toneMapping===qn&&w.length===0)return!1;if(y=T,T!==null){let x=T.width,v=T.height;(o.width!==x||o.height!==v)&&this.setSize(x,v)}return M===!1&&E.setRenderTarget(o),d=E.toneMapping,E.toneMapping=qn,!0},this.hasRenderPass=function(){return M},this.end=function(E,T){E.toneMapping=d,m=!0;let x=o,v=a;for(let C=0;C<w.length;C++){let R=w[C];R.enabled!==!1&&(R.render(E,v,x,T),R.needsSwap!==!1&&(x=v,v=v===a?l:a))}if(g!==E.outputColorSpace||_!==E.toneMapping){g=E.outputColorSpace,_=E.toneMapping,u.defines={},Jt.getTransfer(g)===ne&&(u.defines.SRGB_TRANSFER="");let C=Iv[_];C&&(u.defines[C]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=x.texture,E.setRenderTarget(y),E.render(f,p),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),h.dispose(),u.dispose()}}var fm=new on,pm=new di(1,1),mm=new Cr(1),gm=new Sr,xm=new Aa,_m=new Rr,$p=[],qp=[],Yp=new Float32Array(16),jp=new Float32Array(9),Zp=new Float32Array(4);function zs(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=$p[s];if(r===void 0&&(r=new Float32Array(s),$p[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Pe(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function Ie(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Xl(n,t){let e=qp[t];e===void 0&&(e=new Int32Array(t),qp[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function Nv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function Dv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pe(e,t))return;n.uniform2fv(this.addr,t),Ie(e,t)}}function Uv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Pe(e,t))return;n.uniform3fv(this.addr,t),Ie(e,t)}}function Fv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pe(e,t))return;n.uniform4fv(this.addr,t),Ie(e,t)}}function Ov(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pe(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),Ie(e,t)}else{if(Pe(e,i))return;Zp.set(i),n.uniformMatrix2fv(this.addr,!1,Zp),Ie(e,i)}}function Bv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pe(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),Ie(e,t)}else{if(Pe(e,i))return;jp.set(i),n.uniformMatrix3fv(this.addr,!1,jp),Ie(e,i)}}function kv(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Pe(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),Ie(e,t)}else{if(Pe(e,i))return;Yp.set(i),n.uniformMatrix4fv(this.addr,!1,Yp),Ie(e,i)}}function zv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function Gv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pe(e,t))return;n.uniform2iv(this.addr,t),Ie(e,t)}}function Vv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Pe(e,t))return;n.uniform3iv(this.addr,t),Ie(e,t)}}function Hv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pe(e,t))return;n.uniform4iv(this.addr,t),Ie(e,t)}}function Wv(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function Xv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Pe(e,t))return;n.uniform2uiv(this.addr,t),Ie(e,t)}}function $v(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Pe(e,t))return;n.uniform3uiv(this.addr,t),Ie(e,t)}}function qv(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Pe(e,t))return;n.uniform4uiv(this.addr,t),Ie(e,t)}}function $l(n){return n.version===0&&(n.compareFunction=du,n.needsUpdate=!0),n}function Yv(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=$l(pm):r=fm,e.setTexture2D(t||r,s)}function jv(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||xm,s)}function Zv(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=$l(mm):r=_m,e.setTextureCube(t||r,s)}function Jv(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||gm,s)}function Kv(n){switch(n){case 5126:return Nv;case 35664:return Dv;case 35665:return Uv;case 35666:return Fv;case 35674:return Ov;case 35675:return Bv;case 35676:return kv;case 5124:case 35670:return zv;case 35667:case 35671:return Gv;case 35668:case 35672:return Vv;case 35669:case 35673:return Hv;case 5125:return Wv;case 36294:return Xv;case 36295:return $v;case 36296:return qv;case 35678:case 36198:case 36298:case 36306:case 35682:return Yv;case 35679:case 36299:case 36307:return jv;case 35680:case 36300:case 36308:case 36293:return Zv;case 36289:case 36303:case 36311:case 36292:return Jv}}function Qv(n,t){n.uniform1fv(this.addr,t)}function tM(n,t){let e=zs(t,this.size,2);n.uniform2fv(this.addr,e)}function eM(n,t){let e=zs(t,this.size,3);n.uniform3fv(this.addr,e)}function nM(n,t){let e=zs(t,this.size,4);n.uniform4fv(this.addr,e)}function iM(n,t){let e=zs(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function sM(n,t){let e=zs(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function rM(n,t){let e=zs(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function oM(n,t){n.uniform1iv(this.addr,t)}function aM(n,t){n.uniform2iv(this.addr,t)}function lM(n,t){n.uniform3iv(this.addr,t)}function cM(n,t){n.uniform4iv(this.addr,t)}function hM(n,t){n.uniform1uiv(this.addr,t)}function uM(n,t){n.uniform2uiv(this.addr,t)}function dM(n,t){n.uniform3uiv(this.addr,t)}function fM(n,t){n.uniform4uiv(this.addr,t)}function pM(n,t,e){let i=this.cache,s=t.length,r=Xl(e,s);Pe(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=$l(pm):o=fm;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function mM(n,t,e){let i=this.cache,s=t.length,r=Xl(e,s);Pe(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||xm,r[o])}function gM(n,t,e){let i=this.cache,s=t.length,r=Xl(e,s);Pe(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=$l(mm):o=_m;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function xM(n,t,e){let i=this.cache,s=t.length,r=Xl(e,s);Pe(i,r)||(n.uniform1iv(this.addr,r),Ie(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||gm,r[o])}function _M(n){switch(n){case 5126:return Qv;case 35664:return tM;case 35665:return eM;case 35666:return nM;case 35674:return iM;case 35675:return sM;case 35676:return rM;case 5124:case 35670:return oM;case 35667:case 35671:return aM;case 35668:case 35672:return lM;case 35669:case 35673:return cM;case 5125:return hM;case 36294:return uM;case 36295:return dM;case 36296:return fM;case 35678:case 36198:case 36298:case 36306:case 35682:return pM;case 35679:case 36299:case 36307:return mM;case 35680:case 36300:case 36308:case 36293:return gM;case 36289:case 36303:case 36311:case 36292:return xM}}var Au=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=Kv(e.type)}},Ru=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=_M(e.type)}},Cu=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Eu=/(\w+)(\])?(\[|\.)?/g;function Jp(n,t){n.seq.push(t),n.map[t.id]=t}function yM(n,t,e){let i=n.name,s=i.length;for(Eu.lastIndex=0;;){let r=Eu.exec(i),o=Eu.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Jp(e,c===void 0?new Au(a,n,t):new Ru(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new Cu(a),Jp(e,u)),e=u}}}var ks=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),l=t.getUniformLocation(e,a.name);yM(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(t,l.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Kp(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var vM=37297,MM=0;function bM(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Qp=new Ft;function SM(n){Jt._getMatrix(Qp,Jt.workingColorSpace,n);let t=`mat3( ${Qp.elements.map(e=>e.toFixed(4))} )`;switch(Jt.getTransfer(n)){case Mr:return[t,"LinearTransferOETF"];case ne:return[t,"sRGBTransferOETF"];default:return Pt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function tm(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+bM(n.getShaderSource(t),a)}else return r}function wM(n,t){let e=SM(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var EM={[jh]:"Linear",[Zh]:"Reinhard",[Jh]:"Cineon",[Kh]:"ACESFilmic",[tu]:"AgX",[eu]:"Neutral",[Qh]:"Custom"};function TM(n,t){let e=EM[t];return e===void 0?(Pt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Vl=new N;function AM(){Jt.getLuminanceCoefficients(Vl);let n=Vl.x.toFixed(4),t=Vl.y.toFixed(4),e=Vl.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function RM(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Qr).join(`
`)}function CM(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function PM(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Qr(n){return n!==""}function em(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function nm(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var IM=/^[ \t]*#include +<([\w\d./]+)>/gm;function Pu(n){return n.replace(IM,LM)}function LM(n,t){let e=Xt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Pu(e)}var NM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function im(n){return n.replace(NM,DM)}function DM(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function sm(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var UM={[Ji]:"SHADOWMAP_TYPE_PCF",[Ds]:"SHADOWMAP_TYPE_VSM"};function FM(n){return UM[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var OM={[Fs]:"ENVMAP_MODE_REFRACTION"};function BM(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":OM[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var kM={[Yh]:"ENVMAP_BLENDING_MULTIPLY",[vp]:"ENVMAP_BLENDING_MIX",[Mp]:"ENVMAP_BLENDING_ADD"};function zM(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":kM[n.combine]||"ENVMAP_BLENDING_NONE"}function GM(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,l=FM(e),c=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=BM(e),u=zM(e),f=RM(e),p=CM(r),g=s.createProgram(),_,m,d=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(_=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Qr).join(`
`),_.length>0&&(_+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p].filter(Qr).join(`
`),m.length>0&&(m+=`
`)):(_=[sm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Qr).join(`
`),m=[sm(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,p,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+c:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+l:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==qn?"#define TONE_MAPPING":"",e.toneMapping!==qn?Xt.tonemapping_pars_fragment:"",e.toneMapping!==qn?TM("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Xt.colorspace_pars_fragment,wM("linearToOutputTexel",e.outputColorSpace),AM(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Qr).join(`
`)),o=Pu(o),o=em(o,e),o=nm(o,e),a=Pu(a),a=em(a,e),a=nm(a,e),o=im(o),a=im(a),e.isRawShaderMaterial!==!0&&(d=`#version 300 es
`,_=[f,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+_,m=["#define varying in",e.glslVersion===pu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===pu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=d+_+o,w=d+m+a,M=Kp(s,s.VERTEX_SHADER,y),E=Kp(s,s.FRAGMENT_SHADER,w);s.attachShader(g,M),s.attachShader(g,E),e.index0AttributeName!==void 0?s.bindAttribLocation(g,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(g,0,"position"),s.linkProgram(g);function T(R){if(n.debug.checkShaderErrors){let I=s.getProgramInfoLog(g)||"",F=s.getShaderInfoLog(M)||"",H=s.getShaderInfoLog(E)||"",P=I.trim(),B=F.trim(),V=H.trim(),W=!0,tt=!0;if(s.getProgramParameter(g,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,g,M,E);else{let $=tm(s,M,"vertex"),Q=tm(s,E,"fragment");Dt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(g,s.VALIDATE_STATUS)+`

Material Name: `+R.name+`
Material Type: `+R.type+`

Program Info Log: `+P+`
`+$+`
`+Q)}else P!==""?Pt("WebGLProgram: Program Info Log:",P):(B===""||V==="")&&(tt=!1);tt&&(R.diagnostics={runnable:W,programLog:P,vertexShader:{log:B,prefix:_},fragmentShader:{log:V,prefix:m}})}s.deleteShader(M),s.deleteShader(E),x=new ks(s,g),v=PM(s,g)}let x;this.getUniforms=function(){return x===void 0&&T(this),x};let v;this.getAttributes=function(){return v===void 0&&T(this),v};let C=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return C===!1&&(C=s.getProgramParameter(g,vM)),C},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(g),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=MM++,this.cacheKey=t,this.usedTimes=1,this.program=g,this.vertexShader=M,this.fragmentShader=E,this}var VM=0,Iu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new Lu(t),e.set(t,i)),i}},Lu=class{constructor(t){this.id=VM++,this.code=t,this.usedTimes=0}};function HM(n){return n===Ui||n===Zr||n===Jr}function WM(n,t,e,i,s,r){let o=new Rs,a=new Iu,l=new Set,c=[],h=new Map,u=i.logarithmicDepthBuffer,f={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function p(x){return l.add(x),x===0?"uv":`uv${x}`}function g(x,v,C,R,I,F){let H=R.fog,P=I.geometry,B=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?R.environment:null,V=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,W=t.get(x.envMap||B,V),tt=f[x.type],$=i.precision;x.precision!==null&&($=i.getMaxPrecision(x.precision),$!==x.precision&&Pt("WebGLProgram.getParameters:",x.precision,"not supported, using",$,"instead."));let Q=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,et=Q!==void 0?Q.length:0,wt=0;P.morphAttributes.position!==void 0&&(wt=1),P.morphAttributes.normal!==void 0&&(wt=2),P.morphAttributes.color!==void 0&&(wt=3);let Bt,Z,mt,Mt;if(tt){let ft=jn[tt];Bt=ft.vertexShader,Z=ft.fragmentShader}else{Bt=x.vertexShader,Z=x.fragmentShader;let ft=a.getVertexShaderStage(x),re=a.getFragmentShaderStage(x);a.update(x,ft,re),mt=ft.id,Mt=re.id}let It=n.getRenderTarget(),gt=n.state.buffers.depth.getReversed(),zt=I.isInstancedMesh===!0,be=I.isBatchedMesh===!0,Nt=!!x.map,se=!!x.matcap,le=!!W,Yt=le&&W.isPMREMTexture===!0,Be=!!x.aoMap,Te=!!x.lightMap,sn=!!x.bumpMap&&x.wireframe===!1,_e=!!x.normalMap,zn=!!x.displacementMap,Ne=!!x.emissiveMap,gn=!!x.metalnessMap,xn=!!x.roughnessMap,_n=x.anisotropy>0,O=x.clearcoat>0,yn=x.diffuseRoughness>0,de=x.dispersion>0,fe=x.retroreflectivity>0,dt=x.iridescence>0,Ae=x.sheen>0,Lt=x.transmission>0,Ot=_n&&!!x.anisotropyMap,A=O&&!!x.clearcoatMap,b=O&&!!x.clearcoatNormalMap,z=O&&!!x.clearcoatRoughnessMap,nt=yn&&!!x.diffuseRoughnessMap,K=dt&&!!x.iridescenceMap,rt=dt&&!!x.iridescenceThicknessMap,ht=Ae&&!!x.sheenColorMap,Y=Ae&&!!x.sheenRoughnessMap,j=!!x.specularMap,at=!!x.specularColorMap,L=!!x.specularIntensityMap,J=Lt&&!!x.transmissionMap,q=Lt&&!!x.thicknessMap,lt=!!x.gradientMap,st=!!x.alphaMap,ot=x.alphaTest>0,Tt=!!x.alphaHash,Ht=!!x.extensions,it=qn;x.toneMapped&&(It===null||It.isXRRenderTarget===!0)&&(it=n.toneMapping);let Rt=Yt?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,Vt={shaderID:tt,shaderType:x.type,shaderName:x.name,vertexShader:Bt,fragmentShader:Z,defines:x.defines,customVertexShaderID:mt,customFragmentShaderID:Mt,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:$,batching:be,batchingColor:be&&I._colorsTexture!==null,instancing:zt,instancingColor:zt&&I.instanceColor!==null,instancingMorph:zt&&I.morphTexture!==null,outputColorSpace:It===null?n.outputColorSpace:It.isXRRenderTarget===!0?It.texture.colorSpace:Jt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Nt,matcap:se,envMap:le,envMapMode:le&&W.mapping,envMapPMREM:Yt,envMapMaxLod:Yt?Rt.length-1:null,envMapSize:Yt?Rt[0].width:null,aoMap:Be,lightMap:Te,bumpMap:sn,normalMap:_e,displacementMap:zn,emissiveMap:Ne,normalMapObjectSpace:_e&&x.normalMapType===wp,normalMapTangentSpace:_e&&x.normalMapType===zl,packedNormalMap:_e&&x.normalMapType===zl&&HM(x.normalMap.format),metalnessMap:gn,roughnessMap:xn,anisotropy:_n,anisotropyMap:Ot,clearcoat:O,clearcoatMap:A,clearcoatNormalMap:b,clearcoatRoughnessMap:z,diffuseRoughness:yn,diffuseRoughnessMap:nt,dispersion:de,retroreflection:fe,iridescence:dt,iridescenceMap:K,iridescenceThicknessMap:rt,sheen:Ae,sheenColorMap:ht,sheenRoughnessMap:Y,specularMap:j,specularColorMap:at,specularIntensityMap:L,transmission:Lt,transmissionMap:J,thicknessMap:q,gradientMap:lt,opaque:x.transparent===!1&&x.blending===Us&&x.alphaToCoverage===!1,alphaMap:st,alphaTest:ot,alphaHash:Tt,combine:x.combine,mapUv:Nt&&p(x.map.channel),aoMapUv:Be&&p(x.aoMap.channel),lightMapUv:Te&&p(x.lightMap.channel),bumpMapUv:sn&&p(x.bumpMap.channel),normalMapUv:_e&&p(x.normalMap.channel),displacementMapUv:zn&&p(x.displacementMap.channel),emissiveMapUv:Ne&&p(x.emissiveMap.channel),metalnessMapUv:gn&&p(x.metalnessMap.channel),roughnessMapUv:xn&&p(x.roughnessMap.channel),anisotropyMapUv:Ot&&p(x.anisotropyMap.channel),clearcoatMapUv:A&&p(x.clearcoatMap.channel),clearcoatNormalMapUv:b&&p(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:z&&p(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:nt&&p(x.diffuseRoughnessMap.channel),iridescenceMapUv:K&&p(x.iridescenceMap.channel),iridescenceThicknessMapUv:rt&&p(x.iridescenceThicknessMap.channel),sheenColorMapUv:ht&&p(x.sheenColorMap.channel),sheenRoughnessMapUv:Y&&p(x.sheenRoughnessMap.channel),specularMapUv:j&&p(x.specularMap.channel),specularColorMapUv:at&&p(x.specularColorMap.channel),specularIntensityMapUv:L&&p(x.specularIntensityMap.channel),transmissionMapUv:J&&p(x.transmissionMap.channel),thicknessMapUv:q&&p(x.thicknessMap.channel),alphaMapUv:st&&p(x.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(_e||_n),vertexNormals:!!P.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:I.isPoints===!0&&!!P.attributes.uv&&(Nt||st),fog:!!H,useFog:x.fog===!0,fogExp2:!!H&&H.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||P.attributes.normal===void 0&&_e===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:gt,skinning:I.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:et,morphTextureStride:wt,numSunLights:v.sun.length,numDirLights:v.directional.length,numPointLights:v.point.length,numSpotLights:v.spot.length,numSpotLightMaps:v.spotLightMap.length,numRectAreaLights:v.rectArea.length,numHemiLights:v.hemi.length,numSunLightShadows:v.sunShadowMap.length,numDirLightShadows:v.directionalShadowMap.length,numPointLightShadows:v.pointShadowMap.length,numSpotLightShadows:v.spotShadowMap.length,numSpotLightShadowsWithMaps:v.numSpotLightShadowsWithMaps,numLightProbes:v.numLightProbes,numLightProbeGrids:F.filter(ft=>ft.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&C.length>0,shadowMapType:n.shadowMap.type,toneMapping:it,decodeVideoTexture:Nt&&x.map.isVideoTexture===!0&&Jt.getTransfer(x.map.colorSpace)===ne,decodeVideoTextureEmissive:Ne&&x.emissiveMap.isVideoTexture===!0&&Jt.getTransfer(x.emissiveMap.colorSpace)===ne,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===Ye,flipSided:x.side===nn,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:Ht&&x.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Ht&&x.extensions.multiDraw===!0||be)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return Vt.vertexUv1s=l.has(1),Vt.vertexUv2s=l.has(2),Vt.vertexUv3s=l.has(3),l.clear(),Vt}function _(x){let v=[];if(x.shaderID?v.push(x.shaderID):(v.push(x.customVertexShaderID),v.push(x.customFragmentShaderID)),x.defines!==void 0)for(let C in x.defines)v.push(C),v.push(x.defines[C]);return x.isRawShaderMaterial===!1&&(m(v,x),d(v,x),v.push(n.outputColorSpace)),v.push(x.customProgramCacheKey),v.join()}function m(x,v){x.push(v.precision),x.push(v.outputColorSpace),x.push(v.envMapMode),x.push(v.envMapPMREM),x.push(v.envMapMaxLod),x.push(v.envMapSize),x.push(v.mapUv),x.push(v.alphaMapUv),x.push(v.lightMapUv),x.push(v.aoMapUv),x.push(v.bumpMapUv),x.push(v.normalMapUv),x.push(v.displacementMapUv),x.push(v.emissiveMapUv),x.push(v.metalnessMapUv),x.push(v.roughnessMapUv),x.push(v.anisotropyMapUv),x.push(v.clearcoatMapUv),x.push(v.clearcoatNormalMapUv),x.push(v.clearcoatRoughnessMapUv),x.push(v.diffuseRoughnessMapUv),x.push(v.iridescenceMapUv),x.push(v.iridescenceThicknessMapUv),x.push(v.sheenColorMapUv),x.push(v.sheenRoughnessMapUv),x.push(v.specularMapUv),x.push(v.specularColorMapUv),x.push(v.specularIntensityMapUv),x.push(v.transmissionMapUv),x.push(v.thicknessMapUv),x.push(v.combine),x.push(v.fogExp2),x.push(v.sizeAttenuation),x.push(v.morphTargetsCount),x.push(v.numSunLights),x.push(v.numDirLights),x.push(v.numPointLights),x.push(v.numSpotLights),x.push(v.numSpotLightMaps),x.push(v.numHemiLights),x.push(v.numRectAreaLights),x.push(v.numSunLightShadows),x.push(v.numDirLightShadows),x.push(v.numPointLightShadows),x.push(v.numSpotLightShadows),x.push(v.numSpotLightShadowsWithMaps),x.push(v.numLightProbes),x.push(v.numLightProbeGrids),x.push(v.shadowMapType),x.push(v.toneMapping),x.push(v.numClippingPlanes),x.push(v.numClipIntersection),x.push(v.depthPacking)}function d(x,v){o.disableAll(),v.instancing&&o.enable(0),v.instancingColor&&o.enable(1),v.instancingMorph&&o.enable(2),v.matcap&&o.enable(3),v.envMap&&o.enable(4),v.normalMapObjectSpace&&o.enable(5),v.normalMapTangentSpace&&o.enable(6),v.clearcoat&&o.enable(7),v.iridescence&&o.enable(8),v.alphaTest&&o.enable(9),v.vertexColors&&o.enable(10),v.vertexAlphas&&o.enable(11),v.vertexUv1s&&o.enable(12),v.vertexUv2s&&o.enable(13),v.vertexUv3s&&o.enable(14),v.vertexTangents&&o.enable(15),v.anisotropy&&o.enable(16),v.alphaHash&&o.enable(17),v.batching&&o.enable(18),v.dispersion&&o.enable(19),v.retroreflection&&o.enable(24),v.diffuseRoughness&&o.enable(25),v.batchingColor&&o.enable(20),v.gradientMap&&o.enable(21),v.packedNormalMap&&o.enable(22),v.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),v.fog&&o.enable(0),v.useFog&&o.enable(1),v.flatShading&&o.enable(2),v.logarithmicDepthBuffer&&o.enable(3),v.reversedDepthBuffer&&o.enable(4),v.skinning&&o.enable(5),v.morphTargets&&o.enable(6),v.morphNormals&&o.enable(7),v.morphColors&&o.enable(8),v.premultipliedAlpha&&o.enable(9),v.shadowMapEnabled&&o.enable(10),v.doubleSided&&o.enable(11),v.flipSided&&o.enable(12),v.useDepthPacking&&o.enable(13),v.dithering&&o.enable(14),v.transmission&&o.enable(15),v.sheen&&o.enable(16),v.opaque&&o.enable(17),v.pointsUvs&&o.enable(18),v.decodeVideoTexture&&o.enable(19),v.decodeVideoTextureEmissive&&o.enable(20),v.alphaToCoverage&&o.enable(21),v.numLightProbeGrids>0&&o.enable(22),v.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function y(x){let v=f[x.type],C;if(v){let R=jn[v];C=kp.clone(R.uniforms)}else C=x.uniforms;return C}function w(x,v){let C=h.get(v);return C!==void 0?++C.usedTimes:(C=new GM(n,v,x,s),c.push(C),h.set(v,C)),C}function M(x){if(--x.usedTimes===0){let v=c.indexOf(x);c[v]=c[c.length-1],c.pop(),h.delete(x.cacheKey),x.destroy()}}function E(x){a.remove(x)}function T(){a.dispose()}return{getParameters:g,getProgramCacheKey:_,getUniforms:y,acquireProgram:w,releaseProgram:M,releaseShaderCache:E,programs:c,dispose:T}}function XM(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function $M(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function rm(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function om(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(f){let p=0;return f.isInstancedMesh&&(p+=2),f.isSkinnedMesh&&(p+=1),p}function a(f,p,g,_,m,d){let y=n[t];return y===void 0?(y={id:f.id,object:f,geometry:p,material:g,materialVariant:o(f),groupOrder:_,renderOrder:f.renderOrder,z:m,group:d},n[t]=y):(y.id=f.id,y.object=f,y.geometry=p,y.material=g,y.materialVariant=o(f),y.groupOrder=_,y.renderOrder=f.renderOrder,y.z=m,y.group=d),t++,y}function l(f,p,g,_,m,d,y){y.reversedDepth===!0&&(m=-m);let w=a(f,p,g,_,m,d);g.transmission>0?i.push(w):g.transparent===!0?s.push(w):e.push(w)}function c(f,p,g,_,m,d){let y=a(f,p,g,_,m,d);g.transmission>0?i.unshift(y):g.transparent===!0?s.unshift(y):e.unshift(y)}function h(f,p){e.length>1&&e.sort(f||$M),i.length>1&&i.sort(p||rm),s.length>1&&s.sort(p||rm)}function u(){for(let f=t,p=n.length;f<p;f++){let g=n[f];if(g.id===null)break;g.id=null,g.object=null,g.geometry=null,g.material=null,g.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:u,sort:h}}function qM(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new om,n.set(i,[o])):s>=r.length?(o=new om,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function YM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new N,color:new Ut};break;case"SpotLight":e={position:new N,direction:new N,color:new Ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new N,color:new Ut,distance:0,decay:0};break;case"HemisphereLight":e={direction:new N,skyColor:new Ut,groundColor:new Ut};break;case"RectAreaLight":e={color:new Ut,position:new N,halfWidth:new N,halfHeight:new N};break}return n[t.id]=e,e}}}function jM(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new _t,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var ZM=0;function JM(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function KM(n){let t=new YM,e=jM(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new N);let s=new N,r=new ie,o=new ie;function a(c){let h=0,u=0,f=0;for(let F=0;F<9;F++)i.probe[F].set(0,0,0);let p=0,g=0,_=0,m=0,d=0,y=0,w=0,M=0,E=0,T=0,x=0,v=0,C=0,R=0;c.sort(JM);for(let F=0,H=c.length;F<H;F++){let P=c[F],B=P.color,V=P.intensity,W=P.distance,tt=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===Ui?tt=P.shadow.map.texture:tt=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=B.r*V,u+=B.g*V,f+=B.b*V;else if(P.isLightProbe){for(let $=0;$<9;$++)i.probe[$].addScaledVector(P.sh.coefficients[$],V);R++}else if(P.isSunLight){let $=t.get(P);if($.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,et=e.get(P);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[g]=et,i.sunShadowMap[g]=tt;let wt=Q.getViewportCount();for(let Bt=0;Bt<wt;Bt++)i.sunShadowMatrix[_+Bt]=Q.getMatrix(Bt),i.sunShadowCascade[_+Bt]=Q._cascadeData[Bt];_+=wt,g++}i.sun[p]=$,p++}else if(P.isDirectionalLight){let $=t.get(P);if($.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Q=P.shadow,et=e.get(P);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.directionalShadow[m]=et,i.directionalShadowMap[m]=tt,i.directionalShadowMatrix[m]=P.shadow.matrix,E++}i.directional[m]=$,m++}else if(P.isSpotLight){let $=t.get(P);$.position.setFromMatrixPosition(P.matrixWorld),$.color.copy(B).multiplyScalar(V),$.distance=W,$.coneCos=Math.cos(P.angle),$.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),$.decay=P.decay,i.spot[y]=$;let Q=P.shadow;if(P.map&&(i.spotLightMap[v]=P.map,v++,Q.updateMatrices(P),P.castShadow&&C++),i.spotLightMatrix[y]=Q.matrix,P.castShadow){let et=e.get(P);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,i.spotShadow[y]=et,i.spotShadowMap[y]=tt,x++}y++}else if(P.isRectAreaLight){let $=t.get(P);$.color.copy(B).multiplyScalar(V),$.halfWidth.set(P.width*.5,0,0),$.halfHeight.set(0,P.height*.5,0),i.rectArea[w]=$,w++}else if(P.isPointLight){let $=t.get(P);if($.color.copy(P.color).multiplyScalar(P.intensity),$.distance=P.distance,$.decay=P.decay,P.castShadow){let Q=P.shadow,et=e.get(P);et.shadowIntensity=Q.intensity,et.shadowBias=Q.bias,et.shadowNormalBias=Q.normalBias,et.shadowRadius=Q.radius,et.shadowMapSize=Q.mapSize,et.shadowCameraNear=Q.camera.near,et.shadowCameraFar=Q.camera.far,i.pointShadow[d]=et,i.pointShadowMap[d]=tt,i.pointShadowMatrix[d]=P.shadow.matrix,T++}i.point[d]=$,d++}else if(P.isHemisphereLight){let $=t.get(P);$.skyColor.copy(P.color).multiplyScalar(V),$.groundColor.copy(P.groundColor).multiplyScalar(V),i.hemi[M]=$,M++}}w>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=pt.LTC_FLOAT_1,i.rectAreaLTC2=pt.LTC_FLOAT_2):(i.rectAreaLTC1=pt.LTC_HALF_1,i.rectAreaLTC2=pt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=f;let I=i.hash;(I.sunLength!==p||I.directionalLength!==m||I.pointLength!==d||I.spotLength!==y||I.rectAreaLength!==w||I.hemiLength!==M||I.numSunShadows!==g||I.numDirectionalShadows!==E||I.numPointShadows!==T||I.numSpotShadows!==x||I.numSpotMaps!==v||I.numLightProbes!==R)&&(i.sun.length=p,i.directional.length=m,i.spot.length=y,i.rectArea.length=w,i.point.length=d,i.hemi.length=M,i.sunShadow.length=g,i.sunShadowMap.length=g,i.sunShadowMatrix.length=_,i.sunShadowCascade.length=_,i.directionalShadow.length=E,i.directionalShadowMap.length=E,i.directionalShadowMatrix.length=E,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+v-C,i.spotLightMap.length=v,i.numSpotLightShadowsWithMaps=C,i.numLightProbes=R,I.sunLength=p,I.directionalLength=m,I.pointLength=d,I.spotLength=y,I.rectAreaLength=w,I.hemiLength=M,I.numSunShadows=g,I.numDirectionalShadows=E,I.numPointShadows=T,I.numSpotShadows=x,I.numSpotMaps=v,I.numLightProbes=R,i.version=ZM++)}function l(c,h){let u=0,f=0,p=0,g=0,_=0,m=0,d=h.matrixWorldInverse;for(let y=0,w=c.length;y<w;y++){let M=c[y];if(M.isSunLight){let E=i.sun[u];E.direction.setFromMatrixPosition(M.matrixWorld),E.direction.transformDirection(d),u++}else if(M.isDirectionalLight){let E=i.directional[f];E.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(d),f++}else if(M.isSpotLight){let E=i.spot[g];E.position.setFromMatrixPosition(M.matrixWorld),E.position.applyMatrix4(d),E.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),E.direction.sub(s),E.direction.transformDirection(d),g++}else if(M.isRectAreaLight){let E=i.rectArea[_];E.position.setFromMatrixPosition(M.matrixWorld),E.position.applyMatrix4(d),o.identity(),r.copy(M.matrixWorld),r.premultiply(d),o.extractRotation(r),E.halfWidth.set(M.width*.5,0,0),E.halfHeight.set(0,M.height*.5,0),E.halfWidth.applyMatrix4(o),E.halfHeight.applyMatrix4(o),_++}else if(M.isPointLight){let E=i.point[p];E.position.setFromMatrixPosition(M.matrixWorld),E.position.applyMatrix4(d),p++}else if(M.isHemisphereLight){let E=i.hemi[m];E.direction.setFromMatrixPosition(M.matrixWorld),E.direction.transformDirection(d),m++}}}return{setup:a,setupView:l,state:i}}function am(n){let t=new KM(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function l(){t.setup(e),s.sort((u,f)=>u.priority-f.priority||u.id-f.id)}function c(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function QM(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new am(n),t.set(s,[a])):r>=o.length?(a=new am(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var tb=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,eb=`uniform sampler2D shadow_pass;
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
}`,nb=[new N(1,0,0),new N(-1,0,0),new N(0,1,0),new N(0,-1,0),new N(0,0,1),new N(0,0,-1)],ib=[new N(0,-1,0),new N(0,-1,0),new N(0,0,1),new N(0,0,-1),new N(0,-1,0),new N(0,-1,0)],lm=new ie,Kr=new N,Tu=new N;function sb(n,t,e){let i=new Ti,s=new _t,r=new _t,o=new ge,a=new Ga,l=new Va,c={},h=e.maxTextureSize,u={[Di]:nn,[nn]:Di,[Ye]:Ye},f=new Sn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new _t},radius:{value:4}},vertexShader:tb,fragmentShader:eb}),p=f.clone();p.defines.HORIZONTAL_PASS=1;let g=new an;g.setAttribute("position",new In(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let _=new Ce(g,f),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ji;let d=this.type;this.render=function(T,x,v){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===ep&&(Pt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ji);let C=n.getRenderTarget(),R=n.getActiveCubeFace(),I=n.getActiveMipmapLevel(),F=n.state;F.setBlending(Ki),F.buffers.depth.getReversed()===!0?F.buffers.color.setClear(0,0,0,0):F.buffers.color.setClear(1,1,1,1),F.buffers.depth.setTest(!0),F.setScissorTest(!1);let H=d!==this.type;H&&x.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(B=>B.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,B=T.length;P<B;P++){let V=T[P],W=V.shadow;if(W===void 0){Pt("WebGLShadowMap:",V,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let tt=W.getFrameExtents();s.multiply(tt),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/tt.x),s.x=r.x*tt.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/tt.y),s.y=r.y*tt.y,W.mapSize.y=r.y));let $=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=$,W.map===null||H===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===Ds){if(V.isPointLight){Pt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new pn(s.x,s.y,{format:Ui,type:Fn,minFilter:tn,magFilter:tn,generateMipmaps:!1}),W.map.texture.name=V.name+".shadowMap",W.map.depthTexture=new di(s.x,s.y,Un),W.map.depthTexture.name=V.name+".shadowMapDepth",W.map.depthTexture.format=hi,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Oe,W.map.depthTexture.magFilter=Oe}else V.isPointLight?(W.map=new to(s.x),W.map.depthTexture=new Cr(s.x,Dn)):(W.map=new pn(s.x,s.y),W.map.depthTexture=new di(s.x,s.y,Dn)),W.map.depthTexture.name=V.name+".shadowMap",W.map.depthTexture.format=hi,this.type===Ji?(W.map.depthTexture.compareFunction=$?uu:hu,W.map.depthTexture.minFilter=tn,W.map.depthTexture.magFilter=tn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=Oe,W.map.depthTexture.magFilter=Oe);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();V.isPointLight!==!0&&W.updateMatrices(V,v);let et=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:v.layers;for(let wt=0;wt<Q;wt++){let Bt=W.getCamera(wt);if(V.isPointLight){let Z=W.camera,mt=W.matrix,Mt=V.distance||Z.far;Mt!==Z.far&&(Z.far=Mt,Z.updateProjectionMatrix()),Kr.setFromMatrixPosition(V.matrixWorld),Z.position.copy(Kr),Tu.copy(Z.position),Tu.add(nb[wt]),Z.up.copy(ib[wt]),Z.lookAt(Tu),Z.updateMatrixWorld(),mt.makeTranslation(-Kr.x,-Kr.y,-Kr.z),lm.multiplyMatrices(Z.projectionMatrix,Z.matrixWorldInverse),W._frustum.setFromProjectionMatrix(lm,Z.coordinateSystem,Z.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,wt),n.clear();else{wt===0&&(n.setRenderTarget(W.map),n.clear());let Z=W.getViewport(wt);o.set(r.x*Z.x,r.y*Z.y,r.x*Z.z,r.y*Z.w),F.viewport(o)}i=W.getFrustum(wt),M(x,v,Bt,V,et,this.type)}W.isPointLightShadow!==!0&&this.type===Ds&&y(W,v),W.needsUpdate=!1}d=this.type,m.needsUpdate=!1,n.setRenderTarget(C,R,I)};function y(T,x){let v=t.update(_);f.defines.VSM_SAMPLES!==T.blurSamples&&(f.defines.VSM_SAMPLES=T.blurSamples,p.defines.VSM_SAMPLES=T.blurSamples,f.needsUpdate=!0,p.needsUpdate=!0),T.mapPass===null?T.mapPass=new pn(s.x,s.y,{format:Ui,type:Fn}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),f.uniforms.shadow_pass.value=T.map.depthTexture,f.uniforms.resolution.value.set(T.map.width,T.map.height),f.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(x,null,v,f,_,null),p.uniforms.shadow_pass.value=T.mapPass.texture,p.uniforms.resolution.value.set(T.map.width,T.map.height),p.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(x,null,v,p,_,null)}function w(T,x,v,C){let R=null,I=v.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(I!==void 0)R=I;else if(R=v.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let F=R.uuid,H=x.uuid,P=c[F];P===void 0&&(P={},c[F]=P);let B=P[H];B===void 0&&(B=R.clone(),P[H]=B,x.addEventListener("dispose",E)),R=B}if(R.visible=x.visible,R.wireframe=x.wireframe,C===Ds?R.side=x.shadowSide!==null?x.shadowSide:x.side:R.side=x.shadowSide!==null?x.shadowSide:u[x.side],R.alphaMap=x.alphaMap,R.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,R.map=x.map,R.clipShadows=x.clipShadows,R.clippingPlanes=x.clippingPlanes,R.clipIntersection=x.clipIntersection,R.displacementMap=x.displacementMap,R.displacementScale=x.displacementScale,R.displacementBias=x.displacementBias,R.wireframeLinewidth=x.wireframeLinewidth,R.linewidth=x.linewidth,v.isPointLight===!0&&R.isMeshDistanceMaterial===!0){let F=n.properties.get(R);F.light=v}return R}function M(T,x,v,C,R,I){if(T.visible===!1)return;if(T.layers.test(R)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&I===Ds)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(v.matrixWorldInverse,T.matrixWorld);let P=t.update(T),B=T.material;if(Array.isArray(B)){let V=P.groups;for(let W=0,tt=V.length;W<tt;W++){let $=V[W],Q=B[$.materialIndex];if(Q&&Q.visible){let et=w(T,Q,C,I);T.onBeforeShadow(n,T,x,v,P,et,$),n.renderBufferDirect(v,null,P,et,T,$),T.onAfterShadow(n,T,x,v,P,et,$)}}}else if(B.visible){let V=w(T,B,C,I);T.onBeforeShadow(n,T,x,v,P,V,null),n.renderBufferDirect(v,null,P,V,T,null),T.onAfterShadow(n,T,x,v,P,V,null)}}let H=T.children;for(let P=0,B=H.length;P<B;P++)M(H[P],x,v,C,R,I)}function E(T){T.target.removeEventListener("dispose",E);for(let v in c){let C=c[v],R=T.target.uuid;R in C&&(C[R].dispose(),delete C[R])}}}function rb(n,t){function e(){let L=!1,J=new ge,q=null,lt=new ge(0,0,0,0);return{setMask:function(st){q!==st&&!L&&(n.colorMask(st,st,st,st),q=st)},setLocked:function(st){L=st},setClear:function(st,ot,Tt,Ht,it){it===!0&&(st*=Ht,ot*=Ht,Tt*=Ht),J.set(st,ot,Tt,Ht),lt.equals(J)===!1&&(n.clearColor(st,ot,Tt,Ht),lt.copy(J))},reset:function(){L=!1,q=null,lt.set(-1,0,0,0)}}}function i(){let L=!1,J=!1,q=null,lt=null,st=null;return{setReversed:function(ot){if(J!==ot){let Tt=t.get("EXT_clip_control");ot?Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.ZERO_TO_ONE_EXT):Tt.clipControlEXT(Tt.LOWER_LEFT_EXT,Tt.NEGATIVE_ONE_TO_ONE_EXT),J=ot;let Ht=st;st=null,this.setClear(Ht)}},getReversed:function(){return J},setTest:function(ot){ot?gt(n.DEPTH_TEST):zt(n.DEPTH_TEST)},setMask:function(ot){q!==ot&&!L&&(n.depthMask(ot),q=ot)},setFunc:function(ot){if(J&&(ot=Up[ot]),lt!==ot){switch(ot){case ma:n.depthFunc(n.NEVER);break;case ga:n.depthFunc(n.ALWAYS);break;case xa:n.depthFunc(n.LESS);break;case Ss:n.depthFunc(n.LEQUAL);break;case _a:n.depthFunc(n.EQUAL);break;case ya:n.depthFunc(n.GEQUAL);break;case va:n.depthFunc(n.GREATER);break;case Ma:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}lt=ot}},setLocked:function(ot){L=ot},setClear:function(ot){st!==ot&&(st=ot,J&&(ot=1-ot),n.clearDepth(ot))},reset:function(){L=!1,q=null,lt=null,st=null,J=!1}}}function s(){let L=!1,J=null,q=null,lt=null,st=null,ot=null,Tt=null,Ht=null,it=null;return{setTest:function(Rt){L||(Rt?gt(n.STENCIL_TEST):zt(n.STENCIL_TEST))},setMask:function(Rt){J!==Rt&&!L&&(n.stencilMask(Rt),J=Rt)},setFunc:function(Rt,Vt,ft){(q!==Rt||lt!==Vt||st!==ft)&&(n.stencilFunc(Rt,Vt,ft),q=Rt,lt=Vt,st=ft)},setOp:function(Rt,Vt,ft){(ot!==Rt||Tt!==Vt||Ht!==ft)&&(n.stencilOp(Rt,Vt,ft),ot=Rt,Tt=Vt,Ht=ft)},setLocked:function(Rt){L=Rt},setClear:function(Rt){it!==Rt&&(n.clearStencil(Rt),it=Rt)},reset:function(){L=!1,J=null,q=null,lt=null,st=null,ot=null,Tt=null,Ht=null,it=null}}}let r=new e,o=new i,a=new s,l={},c=new WeakMap,h={},u={},f={},p=new WeakMap,g=[],_=null,m=!1,d=null,y=null,w=null,M=null,E=null,T=null,x=null,v=new Ut(0,0,0),C=0,R=!1,I=null,F=null,H=null,P=null,B=null,V=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,tt=0,$=n.getParameter(n.VERSION);$.indexOf("WebGL")!==-1?(tt=parseFloat(/^WebGL (\d)/.exec($)[1]),W=tt>=1):$.indexOf("OpenGL ES")!==-1&&(tt=parseFloat(/^OpenGL ES (\d)/.exec($)[1]),W=tt>=2);let Q=null,et={},wt=n.getParameter(n.SCISSOR_BOX),Bt=n.getParameter(n.VIEWPORT),Z=new ge().fromArray(wt),mt=new ge().fromArray(Bt);function Mt(L,J,q,lt){let st=new Uint8Array(4),ot=n.createTexture();n.bindTexture(L,ot),n.texParameteri(L,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(L,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Tt=0;Tt<q;Tt++)L===n.TEXTURE_3D||L===n.TEXTURE_2D_ARRAY?n.texImage3D(J,0,n.RGBA,1,1,lt,0,n.RGBA,n.UNSIGNED_BYTE,st):n.texImage2D(J+Tt,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,st);return ot}let It={};It[n.TEXTURE_2D]=Mt(n.TEXTURE_2D,n.TEXTURE_2D,1),It[n.TEXTURE_CUBE_MAP]=Mt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),It[n.TEXTURE_2D_ARRAY]=Mt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),It[n.TEXTURE_3D]=Mt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),gt(n.DEPTH_TEST),o.setFunc(Ss),sn(!1),_e(Vh),gt(n.CULL_FACE),Be(Ki);function gt(L){h[L]!==!0&&(n.enable(L),h[L]=!0)}function zt(L){h[L]!==!1&&(n.disable(L),h[L]=!1)}function be(L,J){return f[L]!==J?(n.bindFramebuffer(L,J),f[L]=J,L===n.DRAW_FRAMEBUFFER&&(f[n.FRAMEBUFFER]=J),L===n.FRAMEBUFFER&&(f[n.DRAW_FRAMEBUFFER]=J),!0):!1}function Nt(L,J){let q=g,lt=!1;if(L){q=p.get(J),q===void 0&&(q=[],p.set(J,q));let st=L.textures;if(q.length!==st.length||q[0]!==n.COLOR_ATTACHMENT0){for(let ot=0,Tt=st.length;ot<Tt;ot++)q[ot]=n.COLOR_ATTACHMENT0+ot;q.length=st.length,lt=!0}}else q[0]!==n.BACK&&(q[0]=n.BACK,lt=!0);lt&&n.drawBuffers(q)}function se(L){return _!==L?(n.useProgram(L),_=L,!0):!1}let le={[Qi]:n.FUNC_ADD,[ip]:n.FUNC_SUBTRACT,[sp]:n.FUNC_REVERSE_SUBTRACT};le[rp]=n.MIN,le[op]=n.MAX;let Yt={[ap]:n.ZERO,[lp]:n.ONE,[cp]:n.SRC_COLOR,[$h]:n.SRC_ALPHA,[mp]:n.SRC_ALPHA_SATURATE,[fp]:n.DST_COLOR,[up]:n.DST_ALPHA,[hp]:n.ONE_MINUS_SRC_COLOR,[qh]:n.ONE_MINUS_SRC_ALPHA,[pp]:n.ONE_MINUS_DST_COLOR,[dp]:n.ONE_MINUS_DST_ALPHA,[gp]:n.CONSTANT_COLOR,[xp]:n.ONE_MINUS_CONSTANT_COLOR,[_p]:n.CONSTANT_ALPHA,[yp]:n.ONE_MINUS_CONSTANT_ALPHA};function Be(L,J,q,lt,st,ot,Tt,Ht,it,Rt){if(L===Ki){m===!0&&(zt(n.BLEND),m=!1);return}if(m===!1&&(gt(n.BLEND),m=!0),L!==np){if(L!==d||Rt!==R){if((y!==Qi||E!==Qi)&&(n.blendEquation(n.FUNC_ADD),y=Qi,E=Qi),Rt)switch(L){case Us:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hh:n.blendFunc(n.ONE,n.ONE);break;case Wh:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Xh:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Dt("WebGLState: Invalid blending: ",L);break}else switch(L){case Us:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Hh:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Wh:Dt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Xh:Dt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Dt("WebGLState: Invalid blending: ",L);break}w=null,M=null,T=null,x=null,v.set(0,0,0),C=0,d=L,R=Rt}return}st=st||J,ot=ot||q,Tt=Tt||lt,(J!==y||st!==E)&&(n.blendEquationSeparate(le[J],le[st]),y=J,E=st),(q!==w||lt!==M||ot!==T||Tt!==x)&&(n.blendFuncSeparate(Yt[q],Yt[lt],Yt[ot],Yt[Tt]),w=q,M=lt,T=ot,x=Tt),(Ht.equals(v)===!1||it!==C)&&(n.blendColor(Ht.r,Ht.g,Ht.b,it),v.copy(Ht),C=it),d=L,R=!1}function Te(L,J){L.side===Ye?zt(n.CULL_FACE):gt(n.CULL_FACE);let q=L.side===nn;J&&(q=!q),sn(q),L.blending===Us&&L.transparent===!1?Be(Ki):Be(L.blending,L.blendEquation,L.blendSrc,L.blendDst,L.blendEquationAlpha,L.blendSrcAlpha,L.blendDstAlpha,L.blendColor,L.blendAlpha,L.premultipliedAlpha),o.setFunc(L.depthFunc),o.setTest(L.depthTest),o.setMask(L.depthWrite),r.setMask(L.colorWrite);let lt=L.stencilWrite;a.setTest(lt),lt&&(a.setMask(L.stencilWriteMask),a.setFunc(L.stencilFunc,L.stencilRef,L.stencilFuncMask),a.setOp(L.stencilFail,L.stencilZFail,L.stencilZPass)),Ne(L.polygonOffset,L.polygonOffsetFactor,L.polygonOffsetUnits),L.alphaToCoverage===!0?gt(n.SAMPLE_ALPHA_TO_COVERAGE):zt(n.SAMPLE_ALPHA_TO_COVERAGE)}function sn(L){I!==L&&(L?n.frontFace(n.CW):n.frontFace(n.CCW),I=L)}function _e(L){L!==Qf?(gt(n.CULL_FACE),L!==F&&(L===Vh?n.cullFace(n.BACK):L===tp?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):zt(n.CULL_FACE),F=L}function zn(L){L!==H&&(W&&n.lineWidth(L),H=L)}function Ne(L,J,q){L?(gt(n.POLYGON_OFFSET_FILL),(P!==J||B!==q)&&(P=J,B=q,o.getReversed()&&(J=-J,q=-q),n.polygonOffset(J,q))):zt(n.POLYGON_OFFSET_FILL)}function gn(L){L?gt(n.SCISSOR_TEST):zt(n.SCISSOR_TEST)}function xn(L){L===void 0&&(L=n.TEXTURE0+V-1),Q!==L&&(n.activeTexture(L),Q=L)}function _n(L,J,q){q===void 0&&(Q===null?q=n.TEXTURE0+V-1:q=Q);let lt=et[q];lt===void 0&&(lt={type:void 0,texture:void 0},et[q]=lt),(lt.type!==L||lt.texture!==J)&&(Q!==q&&(n.activeTexture(q),Q=q),n.bindTexture(L,J||It[L]),lt.type=L,lt.texture=J)}function O(){let L=et[Q];L!==void 0&&L.type!==void 0&&(n.bindTexture(L.type,null),L.type=void 0,L.texture=void 0)}function yn(){try{n.compressedTexImage2D(...arguments)}catch(L){Dt("WebGLState:",L)}}function de(){try{n.compressedTexImage3D(...arguments)}catch(L){Dt("WebGLState:",L)}}function fe(){try{n.texSubImage2D(...arguments)}catch(L){Dt("WebGLState:",L)}}function dt(){try{n.texSubImage3D(...arguments)}catch(L){Dt("WebGLState:",L)}}function Ae(){try{n.compressedTexSubImage2D(...arguments)}catch(L){Dt("WebGLState:",L)}}function Lt(){try{n.compressedTexSubImage3D(...arguments)}catch(L){Dt("WebGLState:",L)}}function Ot(){try{n.texStorage2D(...arguments)}catch(L){Dt("WebGLState:",L)}}function A(){try{n.texStorage3D(...arguments)}catch(L){Dt("WebGLState:",L)}}function b(){try{n.texImage2D(...arguments)}catch(L){Dt("WebGLState:",L)}}function z(){try{n.texImage3D(...arguments)}catch(L){Dt("WebGLState:",L)}}function nt(L){return u[L]!==void 0?u[L]:n.getParameter(L)}function K(L,J){u[L]!==J&&(n.pixelStorei(L,J),u[L]=J)}function rt(L){Z.equals(L)===!1&&(n.scissor(L.x,L.y,L.z,L.w),Z.copy(L))}function ht(L){mt.equals(L)===!1&&(n.viewport(L.x,L.y,L.z,L.w),mt.copy(L))}function Y(L,J){let q=c.get(J);q===void 0&&(q=new WeakMap,c.set(J,q));let lt=q.get(L);lt===void 0&&(lt=n.getUniformBlockIndex(J,L.name),n.uniformBlockBinding(J,lt,lt),q.set(L,lt))}function j(L,J,q){let st=c.get(J).get(L);l[st]!==q&&(n.bindBufferBase(n.UNIFORM_BUFFER,st,q),l[st]=q)}function at(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,et={},f={},l={},p=new WeakMap,g=[],_=null,m=!1,d=null,y=null,w=null,M=null,E=null,T=null,x=null,v=new Ut(0,0,0),C=0,R=!1,I=null,F=null,H=null,P=null,B=null,Z.set(0,0,n.canvas.width,n.canvas.height),mt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:gt,disable:zt,bindFramebuffer:be,drawBuffers:Nt,useProgram:se,setBlending:Be,setMaterial:Te,setFlipSided:sn,setCullFace:_e,setLineWidth:zn,setPolygonOffset:Ne,setScissorTest:gn,activeTexture:xn,bindTexture:_n,unbindTexture:O,compressedTexImage2D:yn,compressedTexImage3D:de,texImage2D:b,texImage3D:z,pixelStorei:K,getParameter:nt,updateUBOMapping:Y,uniformBlockBinding:j,texStorage2D:Ot,texStorage3D:A,texSubImage2D:fe,texSubImage3D:dt,compressedTexSubImage2D:Ae,compressedTexSubImage3D:Lt,scissor:rt,viewport:ht,reset:at}}function ob(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new _t,h=new WeakMap,u=new Set,f,p=new WeakMap,g=new Set,_=new FinalizationRegistry(A=>g.delete(A)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function d(A,b){return m?new OffscreenCanvas(A,b):br("canvas")}function y(A,b,z){let nt=1,K=Ot(A);if((K.width>z||K.height>z)&&(nt=z/Math.max(K.width,K.height)),nt<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let rt=Math.floor(nt*K.width),ht=Math.floor(nt*K.height);f===void 0&&(f=d(rt,ht));let Y=b?d(rt,ht):f;return Y.width=rt,Y.height=ht,Y.getContext("2d").drawImage(A,0,0,rt,ht),Pt("WebGLRenderer: Texture has been resized from ("+K.width+"x"+K.height+") to ("+rt+"x"+ht+")."),Y}else return"data"in A&&Pt("WebGLRenderer: Image in DataTexture is too big ("+K.width+"x"+K.height+")."),A;return A}function w(A){return A.generateMipmaps}function M(A){n.generateMipmap(A)}function E(A){return A.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?n.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(A,b,z,nt,K,rt=!1){if(A!==null){if(n[A]!==void 0)return n[A];Pt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let ht;nt&&(ht=t.get("EXT_texture_norm16"),ht||Pt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Y=b;if(b===n.RED&&(z===n.FLOAT&&(Y=n.R32F),z===n.HALF_FLOAT&&(Y=n.R16F),z===n.UNSIGNED_BYTE&&(Y=n.R8),z===n.UNSIGNED_SHORT&&ht&&(Y=ht.R16_EXT),z===n.SHORT&&ht&&(Y=ht.R16_SNORM_EXT)),b===n.RED_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.R8UI),z===n.UNSIGNED_SHORT&&(Y=n.R16UI),z===n.UNSIGNED_INT&&(Y=n.R32UI),z===n.BYTE&&(Y=n.R8I),z===n.SHORT&&(Y=n.R16I),z===n.INT&&(Y=n.R32I)),b===n.RG&&(z===n.FLOAT&&(Y=n.RG32F),z===n.HALF_FLOAT&&(Y=n.RG16F),z===n.UNSIGNED_BYTE&&(Y=n.RG8),z===n.UNSIGNED_SHORT&&ht&&(Y=ht.RG16_EXT),z===n.SHORT&&ht&&(Y=ht.RG16_SNORM_EXT)),b===n.RG_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.RG8UI),z===n.UNSIGNED_SHORT&&(Y=n.RG16UI),z===n.UNSIGNED_INT&&(Y=n.RG32UI),z===n.BYTE&&(Y=n.RG8I),z===n.SHORT&&(Y=n.RG16I),z===n.INT&&(Y=n.RG32I)),b===n.RGB_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.RGB8UI),z===n.UNSIGNED_SHORT&&(Y=n.RGB16UI),z===n.UNSIGNED_INT&&(Y=n.RGB32UI),z===n.BYTE&&(Y=n.RGB8I),z===n.SHORT&&(Y=n.RGB16I),z===n.INT&&(Y=n.RGB32I)),b===n.RGBA_INTEGER&&(z===n.UNSIGNED_BYTE&&(Y=n.RGBA8UI),z===n.UNSIGNED_SHORT&&(Y=n.RGBA16UI),z===n.UNSIGNED_INT&&(Y=n.RGBA32UI),z===n.BYTE&&(Y=n.RGBA8I),z===n.SHORT&&(Y=n.RGBA16I),z===n.INT&&(Y=n.RGBA32I)),b===n.RGB&&(z===n.UNSIGNED_SHORT&&ht&&(Y=ht.RGB16_EXT),z===n.SHORT&&ht&&(Y=ht.RGB16_SNORM_EXT),z===n.UNSIGNED_INT_5_9_9_9_REV&&(Y=n.RGB9_E5),z===n.UNSIGNED_INT_10F_11F_11F_REV&&(Y=n.R11F_G11F_B10F)),b===n.RGBA){let j=rt?Mr:Jt.getTransfer(K);z===n.FLOAT&&(Y=n.RGBA32F),z===n.HALF_FLOAT&&(Y=n.RGBA16F),z===n.UNSIGNED_BYTE&&(Y=j===ne?n.SRGB8_ALPHA8:n.RGBA8),z===n.UNSIGNED_SHORT&&ht&&(Y=ht.RGBA16_EXT),z===n.SHORT&&ht&&(Y=ht.RGBA16_SNORM_EXT),z===n.UNSIGNED_SHORT_4_4_4_4&&(Y=n.RGBA4),z===n.UNSIGNED_SHORT_5_5_5_1&&(Y=n.RGB5_A1)}return(Y===n.R16F||Y===n.R32F||Y===n.RG16F||Y===n.RG32F||Y===n.RGBA16F||Y===n.RGBA32F)&&t.get("EXT_color_buffer_float"),Y}function x(A,b){let z;return A?b===null||b===Dn||b===es?z=n.DEPTH24_STENCIL8:b===Un?z=n.DEPTH32F_STENCIL8:b===Os&&(z=n.DEPTH24_STENCIL8,Pt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===Dn||b===es?z=n.DEPTH_COMPONENT24:b===Un?z=n.DEPTH_COMPONENT32F:b===Os&&(z=n.DEPTH_COMPONENT16),z}function v(A,b){return w(A)===!0||A.isFramebufferTexture&&A.minFilter!==Oe&&A.minFilter!==tn?Math.log2(Math.max(b.width,b.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?b.mipmaps.length:1}function C(A){let b=new WeakRef(A);i.get(A).__ref=b,g.add(b),_.register(A,b,b)}function R(A){let b=i.get(A).__ref;b!==void 0&&(g.delete(b),_.unregister(b))}function I(A){H(A.target)}function F(A){P(A.target)}function H(A){A.removeEventListener("dispose",I),R(A),V(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&u.delete(A)}function P(A){A.removeEventListener("dispose",F),R(A),tt(A)}function B(){for(let A of g){let b=A.deref();b!==void 0&&(b.isRenderTarget===!0?P(b):H(b))}g.clear(),u.clear()}function V(A){let b=i.get(A);if(b.__webglInit===void 0)return;let z=A.source,nt=p.get(z);if(nt){let K=nt[b.__cacheKey];K.usedTimes--,K.usedTimes===0&&W(A),Object.keys(nt).length===0&&p.delete(z)}i.remove(A)}function W(A){let b=i.get(A);n.deleteTexture(b.__webglTexture);let z=A.source,nt=p.get(z);delete nt[b.__cacheKey],o.memory.textures--}function tt(A){let b=i.get(A);b.__depthDisposeCallback&&b.__depthDisposeCallback();let z=A.depthTexture;if(z&&z.renderTarget===A&&H(z),A.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(b.__webglFramebuffer[K]))for(let rt=0;rt<b.__webglFramebuffer[K].length;rt++)n.deleteFramebuffer(b.__webglFramebuffer[K][rt]);else n.deleteFramebuffer(b.__webglFramebuffer[K]);b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer[K])}else{if(Array.isArray(b.__webglFramebuffer))for(let K=0;K<b.__webglFramebuffer.length;K++)n.deleteFramebuffer(b.__webglFramebuffer[K]);else n.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&n.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&n.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let K=0;K<b.__webglColorRenderbuffer.length;K++)b.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(b.__webglColorRenderbuffer[K]);b.__webglDepthRenderbuffer&&n.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let nt=A.textures;for(let K=0,rt=nt.length;K<rt;K++){let ht=i.get(nt[K]);ht.__webglTexture&&(n.deleteTexture(ht.__webglTexture),o.memory.textures--),i.remove(nt[K])}i.remove(A)}let $=0;function Q(){$=0}function et(){return $}function wt(A){$=A}function Bt(){let A=$;return A>=s.maxTextures&&Pt("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),$+=1,A}function Z(A){let b=[];return b.push(A.wrapS),b.push(A.wrapT),b.push(A.wrapR||0),b.push(A.magFilter),b.push(A.minFilter),b.push(A.anisotropy),b.push(A.internalFormat),b.push(A.format),b.push(A.type),b.push(A.generateMipmaps),b.push(A.mipmapsAutoUpdate),b.push(A.premultiplyAlpha),b.push(A.flipY),b.push(A.unpackAlignment),b.push(A.colorSpace),b.join()}function mt(A,b){let z=i.get(A);if(A.isVideoTexture&&Ae(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&z.__version!==A.version){let nt=A.image;if(nt===null)Pt("WebGLRenderer: Texture marked for update but no image data found.");else if(nt.complete===!1)Pt("WebGLRenderer: Texture marked for update but image is incomplete");else{Te(z,A,b);return}}else A.isExternalTexture&&(z.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,z.__webglTexture,n.TEXTURE0+b)}function Mt(A,b){let z=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&z.__version!==A.version){Te(z,A,b);return}else A.isExternalTexture&&(z.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,z.__webglTexture,n.TEXTURE0+b)}function It(A,b){let z=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&z.__version!==A.version){Te(z,A,b);return}e.bindTexture(n.TEXTURE_3D,z.__webglTexture,n.TEXTURE0+b)}function gt(A,b){let z=i.get(A);if(A.version>0&&z.__version!==A.version){sn(z,A,b);return}e.bindTexture(n.TEXTURE_CUBE_MAP,z.__webglTexture,n.TEXTURE0+b)}let zt={[ba]:n.REPEAT,[Wn]:n.CLAMP_TO_EDGE,[Sa]:n.MIRRORED_REPEAT},be={[Oe]:n.NEAREST,[bp]:n.NEAREST_MIPMAP_NEAREST,[Xr]:n.NEAREST_MIPMAP_LINEAR,[tn]:n.LINEAR,[il]:n.LINEAR_MIPMAP_NEAREST,[fi]:n.LINEAR_MIPMAP_LINEAR},Nt={[Tp]:n.NEVER,[du]:n.ALWAYS,[Ap]:n.LESS,[hu]:n.LEQUAL,[Rp]:n.EQUAL,[uu]:n.GEQUAL,[Cp]:n.GREATER,[Pp]:n.NOTEQUAL};function se(A,b){if(b.type===Un&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===tn||b.magFilter===il||b.magFilter===Xr||b.magFilter===fi||b.minFilter===tn||b.minFilter===il||b.minFilter===Xr||b.minFilter===fi)&&Pt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(A,n.TEXTURE_WRAP_S,zt[b.wrapS]),n.texParameteri(A,n.TEXTURE_WRAP_T,zt[b.wrapT]),(A===n.TEXTURE_3D||A===n.TEXTURE_2D_ARRAY)&&n.texParameteri(A,n.TEXTURE_WRAP_R,zt[b.wrapR]),n.texParameteri(A,n.TEXTURE_MAG_FILTER,be[b.magFilter]),n.texParameteri(A,n.TEXTURE_MIN_FILTER,be[b.minFilter]),b.compareFunction&&(n.texParameteri(A,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(A,n.TEXTURE_COMPARE_FUNC,Nt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===Oe||b.minFilter!==Xr&&b.minFilter!==fi||b.type===Un&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||i.get(b).__currentAnisotropy){let z=t.get("EXT_texture_filter_anisotropic");n.texParameterf(A,z.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),i.get(b).__currentAnisotropy=b.anisotropy}}}function le(A,b){let z=!1;A.__webglInit===void 0&&(A.__webglInit=!0,b.addEventListener("dispose",I),C(b));let nt=b.source,K=p.get(nt);K===void 0&&(K={},p.set(nt,K));let rt=Z(b);if(rt!==A.__cacheKey){K[rt]===void 0&&(K[rt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,z=!0),K[rt].usedTimes++;let ht=K[A.__cacheKey];ht!==void 0&&(K[A.__cacheKey].usedTimes--,ht.usedTimes===0&&W(b)),A.__cacheKey=rt,A.__webglTexture=K[rt].texture}return z}function Yt(A,b,z){return Math.floor(Math.floor(A/z)/b)}function Be(A,b,z,nt){let rt=A.updateRanges;if(rt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,b.width,b.height,z,nt,b.data);else{rt.sort((L,J)=>L.start-J.start);let ht=0;for(let L=1;L<rt.length;L++){let J=rt[ht],q=rt[L],lt=J.start+J.count,st=Yt(q.start,b.width,4),ot=Yt(J.start,b.width,4);q.start<=lt+1&&st===ot&&Yt(q.start+q.count-1,b.width,4)===st?J.count=Math.max(J.count,q.start+q.count-J.start):(++ht,rt[ht]=q)}rt.length=ht+1;let Y=e.getParameter(n.UNPACK_ROW_LENGTH),j=e.getParameter(n.UNPACK_SKIP_PIXELS),at=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,b.width);for(let L=0,J=rt.length;L<J;L++){let q=rt[L],lt=Math.floor(q.start/4),st=Math.ceil(q.count/4),ot=lt%b.width,Tt=Math.floor(lt/b.width),Ht=st,it=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,ot),e.pixelStorei(n.UNPACK_SKIP_ROWS,Tt),e.texSubImage2D(n.TEXTURE_2D,0,ot,Tt,Ht,it,z,nt,b.data)}A.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,Y),e.pixelStorei(n.UNPACK_SKIP_PIXELS,j),e.pixelStorei(n.UNPACK_SKIP_ROWS,at)}}function Te(A,b,z){let nt=n.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(nt=n.TEXTURE_2D_ARRAY),b.isData3DTexture&&(nt=n.TEXTURE_3D);let K=le(A,b),rt=b.source;e.bindTexture(nt,A.__webglTexture,n.TEXTURE0+z);let ht=i.get(rt);if(rt.version!==ht.__version||K===!0){if(e.activeTexture(n.TEXTURE0+z),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let it=Jt.getPrimaries(Jt.workingColorSpace),Rt=b.colorSpace===mi?null:Jt.getPrimaries(b.colorSpace),Vt=b.colorSpace===mi||it===Rt?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Vt)}e.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment);let j=y(b.image,!1,s.maxTextureSize);j=Lt(b,j);let at=r.convert(b.format,b.colorSpace),L=r.convert(b.type),J=T(b.internalFormat,at,L,b.normalized,b.colorSpace,b.isVideoTexture);se(nt,b);let q,lt=b.mipmaps,st=b.isVideoTexture!==!0,ot=ht.__version===void 0||K===!0,Tt=rt.dataReady,Ht=v(b,j);if(b.isDepthTexture)J=x(b.format===pi,b.type),ot&&(st?e.texStorage2D(n.TEXTURE_2D,1,J,j.width,j.height):e.texImage2D(n.TEXTURE_2D,0,J,j.width,j.height,0,at,L,null));else if(b.isDataTexture)if(lt.length>0){st&&ot&&e.texStorage2D(n.TEXTURE_2D,Ht,J,lt[0].width,lt[0].height);for(let it=0,Rt=lt.length;it<Rt;it++)q=lt[it],st?Tt&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,q.width,q.height,at,L,q.data):e.texImage2D(n.TEXTURE_2D,it,J,q.width,q.height,0,at,L,q.data);b.generateMipmaps=!1}else st?(ot&&e.texStorage2D(n.TEXTURE_2D,Ht,J,j.width,j.height),Tt&&Be(b,j,at,L)):e.texImage2D(n.TEXTURE_2D,0,J,j.width,j.height,0,at,L,j.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){st&&ot&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Ht,J,lt[0].width,lt[0].height,j.depth);for(let it=0,Rt=lt.length;it<Rt;it++)if(q=lt[it],b.format!==On)if(at!==null)if(st){if(Tt)if(b.layerUpdates.size>0){let Vt=wu(q.width,q.height,b.format,b.type);for(let ft of b.layerUpdates){let re=q.data.subarray(ft*Vt/q.data.BYTES_PER_ELEMENT,(ft+1)*Vt/q.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,ft,q.width,q.height,1,at,re)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,0,q.width,q.height,j.depth,at,q.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,it,J,q.width,q.height,j.depth,0,q.data,0,0);else Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else st?Tt&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,it,0,0,0,q.width,q.height,j.depth,at,L,q.data):e.texImage3D(n.TEXTURE_2D_ARRAY,it,J,q.width,q.height,j.depth,0,at,L,q.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{st&&ot&&e.texStorage2D(n.TEXTURE_2D,Ht,J,lt[0].width,lt[0].height);for(let it=0,Rt=lt.length;it<Rt;it++)q=lt[it],b.format!==On?at!==null?st?Tt&&e.compressedTexSubImage2D(n.TEXTURE_2D,it,0,0,q.width,q.height,at,q.data):e.compressedTexImage2D(n.TEXTURE_2D,it,J,q.width,q.height,0,q.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):st?Tt&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,q.width,q.height,at,L,q.data):e.texImage2D(n.TEXTURE_2D,it,J,q.width,q.height,0,at,L,q.data)}else if(b.isDataArrayTexture)if(st){if(ot&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Ht,J,j.width,j.height,j.depth),Tt)if(b.layerUpdates.size>0){let it=wu(j.width,j.height,b.format,b.type);for(let Rt of b.layerUpdates){let Vt=j.data.subarray(Rt*it/j.data.BYTES_PER_ELEMENT,(Rt+1)*it/j.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Rt,j.width,j.height,1,at,L,Vt)}b.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,j.width,j.height,j.depth,at,L,j.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,J,j.width,j.height,j.depth,0,at,L,j.data);else if(b.isData3DTexture)st?(ot&&e.texStorage3D(n.TEXTURE_3D,Ht,J,j.width,j.height,j.depth),Tt&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,j.width,j.height,j.depth,at,L,j.data)):e.texImage3D(n.TEXTURE_3D,0,J,j.width,j.height,j.depth,0,at,L,j.data);else if(b.isFramebufferTexture){if(ot)if(st)e.texStorage2D(n.TEXTURE_2D,Ht,J,j.width,j.height);else{let it=j.width,Rt=j.height;for(let Vt=0;Vt<Ht;Vt++)e.texImage2D(n.TEXTURE_2D,Vt,J,it,Rt,0,at,L,null),it>>=1,Rt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in n){let it=n.canvas;if(it.hasAttribute("layoutsubtree")||it.setAttribute("layoutsubtree","true"),j.parentNode!==it){it.appendChild(j),u.add(b),it.onpaint=Rt=>{let Vt=Rt.changedElements;for(let ft of u)Vt.includes(ft.image)&&(ft.needsUpdate=!0)},it.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,j);else{let Vt=n.RGBA,ft=n.RGBA,re=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Vt,ft,re,j)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(lt.length>0){if(st&&ot){let it=Ot(lt[0]);e.texStorage2D(n.TEXTURE_2D,Ht,J,it.width,it.height)}for(let it=0,Rt=lt.length;it<Rt;it++)q=lt[it],st?Tt&&e.texSubImage2D(n.TEXTURE_2D,it,0,0,at,L,q):e.texImage2D(n.TEXTURE_2D,it,J,at,L,q);b.generateMipmaps=!1}else if(st){if(ot){let it=Ot(j);e.texStorage2D(n.TEXTURE_2D,Ht,J,it.width,it.height)}Tt&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,at,L,j)}else e.texImage2D(n.TEXTURE_2D,0,J,at,L,j);w(b)&&b.mipmapsAutoUpdate===!0&&M(nt),ht.__version=rt.version,b.onUpdate&&b.onUpdate(b)}A.__version=b.version}function sn(A,b,z){if(b.image.length!==6)return;let nt=le(A,b),K=b.source;e.bindTexture(n.TEXTURE_CUBE_MAP,A.__webglTexture,n.TEXTURE0+z);let rt=i.get(K);if(K.version!==rt.__version||nt===!0){e.activeTexture(n.TEXTURE0+z);let ht=Jt.getPrimaries(Jt.workingColorSpace),Y=b.colorSpace===mi?null:Jt.getPrimaries(b.colorSpace),j=b.colorSpace===mi||ht===Y?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,j);let at=b.isCompressedTexture||b.image[0].isCompressedTexture,L=b.image[0]&&b.image[0].isDataTexture,J=[];for(let ft=0;ft<6;ft++)!at&&!L?J[ft]=y(b.image[ft],!0,s.maxCubemapSize):J[ft]=L?b.image[ft].image:b.image[ft],J[ft]=Lt(b,J[ft]);let q=J[0],lt=r.convert(b.format,b.colorSpace),st=r.convert(b.type),ot=T(b.internalFormat,lt,st,b.normalized,b.colorSpace),Tt=b.isVideoTexture!==!0,Ht=rt.__version===void 0||nt===!0,it=K.dataReady,Rt=v(b,q);se(n.TEXTURE_CUBE_MAP,b);let Vt;if(b.isDepthTexture){if(ot=x(b.format===pi,b.type),Ht)if(Tt)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,ot,q.width,q.height);else for(let ft=0;ft<6;ft++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,ot,q.width,q.height,0,lt,st,null)}else if(at){Tt&&Ht&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Rt,ot,q.width,q.height);for(let ft=0;ft<6;ft++){Vt=J[ft].mipmaps;for(let re=0;re<Vt.length;re++){let De=Vt[re];b.format!==On?lt!==null?Tt?it&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re,0,0,De.width,De.height,lt,De.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re,ot,De.width,De.height,0,De.data):Pt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re,0,0,De.width,De.height,lt,st,De.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re,ot,De.width,De.height,0,lt,st,De.data)}}}else{if(Vt=b.mipmaps,Tt&&Ht){Vt.length>0&&Rt++;let ft=Ot(J[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Rt,ot,ft.width,ft.height)}for(let ft=0;ft<6;ft++)if(L){Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,0,0,J[ft].width,J[ft].height,lt,st,J[ft].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,ot,J[ft].width,J[ft].height,0,lt,st,J[ft].data);for(let re=0;re<Vt.length;re++){let gi=Vt[re].image[ft].image;Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re+1,0,0,gi.width,gi.height,lt,st,gi.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re+1,ot,gi.width,gi.height,0,lt,st,gi.data)}}else{Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,0,0,lt,st,J[ft]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,0,ot,lt,st,J[ft]);for(let re=0;re<Vt.length;re++){let De=Vt[re];Tt?it&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re+1,0,0,lt,st,De.image[ft]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+ft,re+1,ot,lt,st,De.image[ft])}}}w(b)&&b.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),rt.__version=K.version,b.onUpdate&&b.onUpdate(b)}A.__version=b.version}function _e(A,b,z,nt,K,rt){let ht=r.convert(z.format,z.colorSpace),Y=r.convert(z.type),j=T(z.internalFormat,ht,Y,z.normalized,z.colorSpace),at=i.get(b),L=i.get(z);if(L.__renderTarget=b,!at.__hasExternalTextures){let J=Math.max(1,b.width>>rt),q=Math.max(1,b.height>>rt);K===n.TEXTURE_3D||K===n.TEXTURE_2D_ARRAY?e.texImage3D(K,rt,j,J,q,b.depth,0,ht,Y,null):e.texImage2D(K,rt,j,J,q,0,ht,Y,null)}e.bindFramebuffer(n.FRAMEBUFFER,A),dt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,nt,K,L.__webglTexture,0,fe(b)):(K===n.TEXTURE_2D||K>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&K<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,nt,K,L.__webglTexture,rt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function zn(A,b,z){if(n.bindRenderbuffer(n.RENDERBUFFER,A),b.depthBuffer){let nt=b.depthTexture,K=nt&&nt.isDepthTexture?nt.type:null,rt=x(b.stencilBuffer,K),ht=b.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;dt(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(b),rt,b.width,b.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(b),rt,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,rt,b.width,b.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ht,n.RENDERBUFFER,A)}else{let nt=b.textures;for(let K=0;K<nt.length;K++){let rt=nt[K],ht=r.convert(rt.format,rt.colorSpace),Y=r.convert(rt.type),j=T(rt.internalFormat,ht,Y,rt.normalized,rt.colorSpace);dt(b)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,fe(b),j,b.width,b.height):z?n.renderbufferStorageMultisample(n.RENDERBUFFER,fe(b),j,b.width,b.height):n.renderbufferStorage(n.RENDERBUFFER,j,b.width,b.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ne(A,b,z){let nt=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,A),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let K=i.get(b.depthTexture);K.__renderTarget=b;let rt=nt?b.depthTexture.image[0]:b.depthTexture.image;(!K.__webglTexture||rt.width!==b.width||rt.height!==b.height)&&(rt.width=b.width,rt.height=b.height,b.depthTexture.needsUpdate=!0),nt?gt(b.depthTexture,0):mt(b.depthTexture,0);let ht=K.__webglTexture,Y=fe(b),j=nt?n.TEXTURE_CUBE_MAP_POSITIVE_X+z:n.TEXTURE_2D,at=b.depthTexture.format===pi?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(b.depthTexture.format===hi)dt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,at,j,ht,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,at,j,ht,0);else if(b.depthTexture.format===pi)dt(b)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,at,j,ht,0,Y):n.framebufferTexture2D(n.FRAMEBUFFER,at,j,ht,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function gn(A){let b=i.get(A),z=A.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==A.depthTexture){let nt=A.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),nt){let K=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,nt.removeEventListener("dispose",K)};nt.addEventListener("dispose",K),b.__depthDisposeCallback=K}b.__boundDepthTexture=nt}if(A.depthTexture&&!b.__autoAllocateDepthBuffer)if(z)for(let nt=0;nt<6;nt++)Ne(b.__webglFramebuffer[nt],A,nt);else A.texture.mipmaps.length>0?Ne(b.__webglFramebuffer[0],A,0):Ne(b.__webglFramebuffer,A,0);else if(z){b.__webglDepthbuffer=[];for(let nt=0;nt<6;nt++)if(e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[nt]),b.__webglDepthbuffer[nt]===void 0)b.__webglDepthbuffer[nt]=n.createRenderbuffer(),zn(b.__webglDepthbuffer[nt],A,!1);else{let K=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,rt=b.__webglDepthbuffer[nt];n.bindRenderbuffer(n.RENDERBUFFER,rt),n.framebufferRenderbuffer(n.FRAMEBUFFER,K,n.RENDERBUFFER,rt)}}else if(A.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=n.createRenderbuffer(),zn(b.__webglDepthbuffer,A,!1);else{let K=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,rt=b.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,rt),n.framebufferRenderbuffer(n.FRAMEBUFFER,K,n.RENDERBUFFER,rt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function xn(A,b,z){let nt=i.get(A);b!==void 0&&_e(nt.__webglFramebuffer,A,A.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),z!==void 0&&gn(A)}function _n(A){let b=A.texture,z=i.get(A),nt=i.get(b);A.addEventListener("dispose",F),C(A);let K=A.textures,rt=A.isWebGLCubeRenderTarget===!0,ht=K.length>1;if(ht||(nt.__webglTexture===void 0&&(nt.__webglTexture=n.createTexture()),nt.__version=b.version,o.memory.textures++),rt){z.__webglFramebuffer=[];for(let Y=0;Y<6;Y++)if(b.mipmaps.length>0){z.__webglFramebuffer[Y]=[];for(let j=0;j<b.mipmaps.length;j++)z.__webglFramebuffer[Y][j]=n.createFramebuffer()}else z.__webglFramebuffer[Y]=n.createFramebuffer()}else{if(b.mipmaps.length>0){z.__webglFramebuffer=[];for(let Y=0;Y<b.mipmaps.length;Y++)z.__webglFramebuffer[Y]=n.createFramebuffer()}else z.__webglFramebuffer=n.createFramebuffer();if(ht)for(let Y=0,j=K.length;Y<j;Y++){let at=i.get(K[Y]);at.__webglTexture===void 0&&(at.__webglTexture=n.createTexture(),o.memory.textures++)}if(A.samples>0&&dt(A)===!1){z.__webglMultisampledFramebuffer=n.createFramebuffer(),z.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,z.__webglMultisampledFramebuffer);for(let Y=0;Y<K.length;Y++){let j=K[Y];z.__webglColorRenderbuffer[Y]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,z.__webglColorRenderbuffer[Y]);let at=r.convert(j.format,j.colorSpace),L=r.convert(j.type),J=T(j.internalFormat,at,L,j.normalized,j.colorSpace,A.isXRRenderTarget===!0),q=fe(A);n.renderbufferStorageMultisample(n.RENDERBUFFER,q,J,A.width,A.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+Y,n.RENDERBUFFER,z.__webglColorRenderbuffer[Y])}n.bindRenderbuffer(n.RENDERBUFFER,null),A.depthBuffer&&(z.__webglDepthRenderbuffer=n.createRenderbuffer(),zn(z.__webglDepthRenderbuffer,A,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(rt){e.bindTexture(n.TEXTURE_CUBE_MAP,nt.__webglTexture),se(n.TEXTURE_CUBE_MAP,b);for(let Y=0;Y<6;Y++)if(b.mipmaps.length>0)for(let j=0;j<b.mipmaps.length;j++)_e(z.__webglFramebuffer[Y][j],A,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,j);else _e(z.__webglFramebuffer[Y],A,b,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+Y,0);w(b)?M(n.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(ht){for(let Y=0,j=K.length;Y<j;Y++){let at=K[Y],L=i.get(at),J=n.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(J=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(J,L.__webglTexture),se(J,at),_e(z.__webglFramebuffer,A,at,n.COLOR_ATTACHMENT0+Y,J,0),w(at)&&M(J)}e.unbindTexture()}else{let Y=n.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(Y=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(Y,nt.__webglTexture),se(Y,b),b.mipmaps.length>0)for(let j=0;j<b.mipmaps.length;j++)_e(z.__webglFramebuffer[j],A,b,n.COLOR_ATTACHMENT0,Y,j);else _e(z.__webglFramebuffer,A,b,n.COLOR_ATTACHMENT0,Y,0);w(b)?M(Y):b.mipmaps.length>0&&n.texParameteri(Y,n.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}A.depthBuffer&&gn(A)}function O(A){let b=A.textures;for(let z=0,nt=b.length;z<nt;z++){let K=b[z];if(w(K)&&K.mipmapsAutoUpdate===!0){let rt=E(A),ht=i.get(K).__webglTexture;e.bindTexture(rt,ht),M(rt),e.unbindTexture()}}}let yn=[];function de(A){if(A.samples>0){if(dt(A)===!1){let b=A.textures,z=A.width,nt=A.height,K=n.COLOR_BUFFER_BIT,rt=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ht=i.get(A),Y=b.length>1;if(Y)for(let at=0;at<b.length;at++)e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,ht.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,ht.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,ht.__webglFramebuffer);for(let at=0;at<b.length;at++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(K|=n.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(K|=n.STENCIL_BUFFER_BIT)),Y){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ht.__webglColorRenderbuffer[at]);let L=i.get(b[at]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,L,0)}n.blitFramebuffer(0,0,z,nt,0,0,z,nt,K,n.NEAREST),l===!0&&(yn.length=0,yn.push(n.COLOR_ATTACHMENT0+at),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&yn.push(rt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,yn))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),Y)for(let at=0;at<b.length;at++){e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.RENDERBUFFER,ht.__webglColorRenderbuffer[at]);let L=i.get(b[at]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,ht.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+at,n.TEXTURE_2D,L,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,ht.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&l){let b=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[b])}}}function fe(A){return Math.min(s.maxSamples,A.samples)}function dt(A){let b=i.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Ae(A){let b=o.render.frame;h.get(A)!==b&&(h.set(A,b),A.update())}function Lt(A,b){let z=A.colorSpace,nt=A.format,K=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||z!==vr&&z!==mi&&(Jt.getTransfer(z)===ne?(nt!==On||K!==ln)&&Pt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Dt("WebGLTextures: Unsupported texture color space:",z)),b}function Ot(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(c.width=A.naturalWidth||A.width,c.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(c.width=A.displayWidth,c.height=A.displayHeight):(c.width=A.width,c.height=A.height),c}this.allocateTextureUnit=Bt,this.resetTextureUnits=Q,this.getTextureUnits=et,this.setTextureUnits=wt,this.setTexture2D=mt,this.setTexture2DArray=Mt,this.setTexture3D=It,this.setTextureCube=gt,this.rebindTextures=xn,this.setupRenderTarget=_n,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=de,this.setupDepthRenderbuffer=gn,this.setupFrameBufferTexture=_e,this.useMultisampledRTT=dt,this.dispose=B}function ab(n,t){function e(i,s=mi){let r,o=Jt.getTransfer(s);if(i===ln)return n.UNSIGNED_BYTE;if(i===rl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ol)return n.UNSIGNED_SHORT_5_5_5_1;if(i===ru)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ou)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===iu)return n.BYTE;if(i===su)return n.SHORT;if(i===Os)return n.UNSIGNED_SHORT;if(i===sl)return n.INT;if(i===Dn)return n.UNSIGNED_INT;if(i===Un)return n.FLOAT;if(i===Fn)return n.HALF_FLOAT;if(i===au)return n.ALPHA;if(i===lu)return n.RGB;if(i===On)return n.RGBA;if(i===hi)return n.DEPTH_COMPONENT;if(i===pi)return n.DEPTH_STENCIL;if(i===cu)return n.RED;if(i===al)return n.RED_INTEGER;if(i===Ui)return n.RG;if(i===ll)return n.RG_INTEGER;if(i===cl)return n.RGBA_INTEGER;if(i===$r||i===qr||i===Yr||i===jr)if(o===ne)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===$r)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===qr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Yr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===jr)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===$r)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===qr)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Yr)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===jr)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===hl||i===ul||i===dl||i===fl)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===hl)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ul)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===dl)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===fl)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===pl||i===ml||i===gl||i===xl||i===_l||i===Zr||i===yl)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===pl||i===ml)return o===ne?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===gl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===xl)return r.COMPRESSED_R11_EAC;if(i===_l)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Zr)return r.COMPRESSED_RG11_EAC;if(i===yl)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===vl||i===Ml||i===bl||i===Sl||i===wl||i===El||i===Tl||i===Al||i===Rl||i===Cl||i===Pl||i===Il||i===Ll||i===Nl)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===vl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Ml)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===bl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Sl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===wl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===El)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Tl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===Al)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Rl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===Cl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Pl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Il)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Ll)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Nl)return o===ne?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Dl||i===Ul||i===Fl)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Dl)return o===ne?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ul)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Fl)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Ol||i===Bl||i===Jr||i===kl)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Ol)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Bl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Jr)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===kl)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===es?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var lb=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,cb=`
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

}`,Nu=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new Pr(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new Sn({vertexShader:lb,fragmentShader:cb,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ce(new Zi(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Du=class extends Ln{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,h=null,u=null,f=null,p=null,g=null,_=typeof XRWebGLBinding<"u",m=new Nu,d={},y=e.getContextAttributes(),w=null,M=null,E=[],T=[],x=new _t,v=null,C=null,R=new Qe;R.viewport=new ge;let I=new Qe;I.viewport=new ge;let F=[R,I],H=new tl,P=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Z){let mt=E[Z];return mt===void 0&&(mt=new Cs,E[Z]=mt),mt.getTargetRaySpace()},this.getControllerGrip=function(Z){let mt=E[Z];return mt===void 0&&(mt=new Cs,E[Z]=mt),mt.getGripSpace()},this.getHand=function(Z){let mt=E[Z];return mt===void 0&&(mt=new Cs,E[Z]=mt),mt.getHandSpace()};function V(Z){let mt=T.indexOf(Z.inputSource);if(mt===-1)return;let Mt=E[mt];Mt!==void 0&&(Mt.update(Z.inputSource,Z.frame,c||o),Mt.dispatchEvent({type:Z.type,data:Z.inputSource}))}function W(){s.removeEventListener("select",V),s.removeEventListener("selectstart",V),s.removeEventListener("selectend",V),s.removeEventListener("squeeze",V),s.removeEventListener("squeezestart",V),s.removeEventListener("squeezeend",V),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",tt);for(let Z=0;Z<E.length;Z++){let mt=T[Z];mt!==null&&(T[Z]=null,E[Z].disconnect(mt))}P=null,B=null,m.reset();for(let Z in d)delete d[Z];if(t.setRenderTarget(w),p=null,f=null,u=null,s=null,M=null,Bt.stop(),i.isPresenting=!1,t.setPixelRatio(v),t.setSize(x.width,x.height,!1),C!==null){let Z=C.camera;Z.fov=C.fov,Z.zoom=C.zoom,Z.updateProjectionMatrix(),C=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Z){r=Z,i.isPresenting===!0&&Pt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Z){a=Z,i.isPresenting===!0&&Pt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Z){c=Z},this.getBaseLayer=function(){return f!==null?f:p},this.getBinding=function(){return u===null&&_&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return g},this.getSession=function(){return s},this.setSession=async function(Z){if(s=Z,s!==null){if(w=t.getRenderTarget(),s.addEventListener("select",V),s.addEventListener("selectstart",V),s.addEventListener("selectend",V),s.addEventListener("squeeze",V),s.addEventListener("squeezestart",V),s.addEventListener("squeezeend",V),s.addEventListener("end",W),s.addEventListener("inputsourceschange",tt),y.xrCompatible!==!0&&await e.makeXRCompatible(),v=t.getPixelRatio(),t.getSize(x),_&&"createProjectionLayer"in XRWebGLBinding.prototype){let Mt=null,It=null,gt=null;y.depth&&(gt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Mt=y.stencil?pi:hi,It=y.stencil?es:Dn);let zt={colorFormat:e.RGBA8,depthFormat:gt,scaleFactor:r};u=this.getBinding(),f=u.createProjectionLayer(zt),s.updateRenderState({layers:[f]}),t.setPixelRatio(1),t.setSize(f.textureWidth,f.textureHeight,!1),M=new pn(f.textureWidth,f.textureHeight,{format:On,type:ln,depthTexture:new di(f.textureWidth,f.textureHeight,It,void 0,void 0,void 0,void 0,void 0,void 0,Mt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}else{let Mt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};p=new XRWebGLLayer(s,e,Mt),s.updateRenderState({baseLayer:p}),t.setPixelRatio(1),t.setSize(p.framebufferWidth,p.framebufferHeight,!1),M=new pn(p.framebufferWidth,p.framebufferHeight,{format:On,type:ln,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:p.ignoreDepthValues===!1,resolveStencilBuffer:p.ignoreDepthValues===!1,storeMultisampledDepthBuffer:p.ignoreDepthValues===!1,storeMultisampledStencilBuffer:p.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),Bt.setContext(s),Bt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function tt(Z){for(let mt=0;mt<Z.removed.length;mt++){let Mt=Z.removed[mt],It=T.indexOf(Mt);It>=0&&(T[It]=null,E[It].disconnect(Mt))}for(let mt=0;mt<Z.added.length;mt++){let Mt=Z.added[mt],It=T.indexOf(Mt);if(It===-1){for(let zt=0;zt<E.length;zt++)if(zt>=T.length){T.push(Mt),It=zt;break}else if(T[zt]===null){T[zt]=Mt,It=zt;break}if(It===-1)break}let gt=E[It];gt&&gt.connect(Mt)}}function $(Z,mt){mt===null?Z.matrixWorld.copy(Z.matrix):Z.matrixWorld.multiplyMatrices(mt.matrixWorld,Z.matrix),Z.matrixWorldInverse.copy(Z.matrixWorld).invert()}this.updateCamera=function(Z){if(s===null)return;let mt=Z.near,Mt=Z.far;m.texture!==null&&(m.depthNear>0&&(mt=m.depthNear),m.depthFar>0&&(Mt=m.depthFar)),H.near=I.near=R.near=mt,H.far=I.far=R.far=Mt,(P!==H.near||B!==H.far)&&(s.updateRenderState({depthNear:H.near,depthFar:H.far}),P=H.near,B=H.far),H.layers.mask=Z.layers.mask|6,R.layers.mask=H.layers.mask&-5,I.layers.mask=H.layers.mask&-3;let It=Z.parent,gt=H.cameras;$(H,It);for(let zt=0;zt<gt.length;zt++)$(gt[zt],It);H.projectionMatrix.copy(R.projectionMatrix),H.projectionMatrixInverse.copy(R.projectionMatrixInverse),C===null&&Z.isPerspectiveCamera&&(C={camera:Z,fov:Z.fov,zoom:Z.zoom}),Q(Z,H,It)};function Q(Z,mt,Mt){Mt===null?Z.matrix.copy(mt.matrixWorld):(Z.matrix.copy(Mt.matrixWorld),Z.matrix.invert(),Z.matrix.multiply(mt.matrixWorld)),Z.matrix.decompose(Z.position,Z.quaternion,Z.scale),Z.updateMatrixWorld(!0),Z.projectionMatrix.copy(mt.projectionMatrix),Z.projectionMatrixInverse.copy(mt.projectionMatrixInverse),Z.isPerspectiveCamera&&(Z.fov=Ts*2*Math.atan(1/Z.projectionMatrix.elements[5]),Z.zoom=1)}this.getCamera=function(){return H},this.getFoveation=function(){if(!(f===null&&p===null))return l},this.setFoveation=function(Z){l=Z,f!==null&&(f.fixedFoveation=Z),p!==null&&p.fixedFoveation!==void 0&&(p.fixedFoveation=Z)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(H)},this.getCameraTexture=function(Z){return d[Z]};let et=null;function wt(Z,mt){if(h=mt.getViewerPose(c||o),g=mt,h!==null){let Mt=h.views;p!==null&&(t.setRenderTargetFramebuffer(M,p.framebuffer),t.setRenderTarget(M));let It=!1;Mt.length!==H.cameras.length&&(H.cameras.length=0,It=!0);for(let Nt=0;Nt<Mt.length;Nt++){let se=Mt[Nt],le=null;if(p!==null)le=p.getViewport(se);else{let Be=u.getViewSubImage(f,se);le=Be.viewport,Nt===0&&(t.setRenderTargetTextures(M,Be.colorTexture,Be.depthStencilTexture),t.setRenderTarget(M))}let Yt=F[Nt];Yt===void 0&&(Yt=new Qe,Yt.layers.enable(Nt),Yt.viewport=new ge,F[Nt]=Yt),Yt.matrix.fromArray(se.transform.matrix),Yt.matrix.decompose(Yt.position,Yt.quaternion,Yt.scale),Yt.projectionMatrix.fromArray(se.projectionMatrix),Yt.projectionMatrixInverse.copy(Yt.projectionMatrix).invert(),Yt.viewport.set(le.x,le.y,le.width,le.height),Nt===0&&(H.matrix.copy(Yt.matrix),H.matrix.decompose(H.position,H.quaternion,H.scale)),It===!0&&H.cameras.push(Yt)}let gt=s.enabledFeatures;if(gt&&gt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&_){u=i.getBinding();let Nt=u.getDepthInformation(Mt[0]);Nt&&Nt.isValid&&Nt.texture&&m.init(Nt,s.renderState)}if(gt&&gt.includes("camera-access")&&_){t.state.unbindTexture(),u=i.getBinding();for(let Nt=0;Nt<Mt.length;Nt++){let se=Mt[Nt].camera;if(se){let le=d[se];le||(le=new Pr,d[se]=le);let Yt=u.getCameraImage(se);le.sourceTexture=Yt}}}}for(let Mt=0;Mt<E.length;Mt++){let It=T[Mt],gt=E[Mt];It!==null&&gt!==void 0&&gt.update(It,mt,c||o)}et&&et(Z,mt),mt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:mt}),g=null}let Bt=new cm;Bt.setAnimationLoop(wt),this.setAnimationLoop=function(Z){et=Z},this.dispose=function(){}}},hb=new ie,ym=new Ft;ym.set(-1,0,0,0,1,0,0,0,1);function ub(n,t){function e(m,d){m.matrixAutoUpdate===!0&&m.updateMatrix(),d.value.copy(m.matrix)}function i(m,d){d.color.getRGB(m.fogColor.value,Mu(n)),d.isFog?(m.fogNear.value=d.near,m.fogFar.value=d.far):d.isFogExp2&&(m.fogDensity.value=d.density)}function s(m,d,y,w,M){d.isNodeMaterial?d.uniformsNeedUpdate=!1:d.isMeshBasicMaterial?r(m,d):d.isMeshLambertMaterial?(r(m,d),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)):d.isMeshToonMaterial?(r(m,d),u(m,d)):d.isMeshPhongMaterial?(r(m,d),h(m,d),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)):d.isMeshStandardMaterial?(r(m,d),f(m,d),d.isMeshPhysicalMaterial&&p(m,d,M)):d.isMeshMatcapMaterial?(r(m,d),g(m,d)):d.isMeshDepthMaterial?r(m,d):d.isMeshDistanceMaterial?(r(m,d),_(m,d)):d.isMeshNormalMaterial?r(m,d):d.isLineBasicMaterial?(o(m,d),d.isLineDashedMaterial&&a(m,d)):d.isPointsMaterial?l(m,d,y,w):d.isSpriteMaterial?c(m,d):d.isShadowMaterial?(m.color.value.copy(d.color),m.opacity.value=d.opacity):d.isShaderMaterial&&(d.uniformsNeedUpdate=!1)}function r(m,d){m.opacity.value=d.opacity,d.color&&m.diffuse.value.copy(d.color),d.emissive&&m.emissive.value.copy(d.emissive).multiplyScalar(d.emissiveIntensity),d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.bumpMap&&(m.bumpMap.value=d.bumpMap,e(d.bumpMap,m.bumpMapTransform),m.bumpScale.value=d.bumpScale,d.side===nn&&(m.bumpScale.value*=-1)),d.normalMap&&(m.normalMap.value=d.normalMap,e(d.normalMap,m.normalMapTransform),m.normalScale.value.copy(d.normalScale),d.side===nn&&m.normalScale.value.negate()),d.displacementMap&&(m.displacementMap.value=d.displacementMap,e(d.displacementMap,m.displacementMapTransform),m.displacementScale.value=d.displacementScale,m.displacementBias.value=d.displacementBias),d.emissiveMap&&(m.emissiveMap.value=d.emissiveMap,e(d.emissiveMap,m.emissiveMapTransform)),d.specularMap&&(m.specularMap.value=d.specularMap,e(d.specularMap,m.specularMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest);let y=t.get(d),w=y.envMap,M=y.envMapRotation;w&&(m.envMap.value=w,m.envMapRotation.value.setFromMatrix4(hb.makeRotationFromEuler(M)).transpose(),w.isCubeTexture&&w.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(ym),m.reflectivity.value=d.reflectivity,m.ior.value=d.ior,m.refractionRatio.value=d.refractionRatio),d.lightMap&&(m.lightMap.value=d.lightMap,m.lightMapIntensity.value=d.lightMapIntensity,e(d.lightMap,m.lightMapTransform)),d.aoMap&&(m.aoMap.value=d.aoMap,m.aoMapIntensity.value=d.aoMapIntensity,e(d.aoMap,m.aoMapTransform))}function o(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform))}function a(m,d){m.dashSize.value=d.dashSize,m.totalSize.value=d.dashSize+d.gapSize,m.scale.value=d.scale}function l(m,d,y,w){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.size.value=d.size*y,m.scale.value=w*.5,d.map&&(m.map.value=d.map,e(d.map,m.uvTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function c(m,d){m.diffuse.value.copy(d.color),m.opacity.value=d.opacity,m.rotation.value=d.rotation,d.map&&(m.map.value=d.map,e(d.map,m.mapTransform)),d.alphaMap&&(m.alphaMap.value=d.alphaMap,e(d.alphaMap,m.alphaMapTransform)),d.alphaTest>0&&(m.alphaTest.value=d.alphaTest)}function h(m,d){m.specular.value.copy(d.specular),m.shininess.value=Math.max(d.shininess,1e-4)}function u(m,d){d.gradientMap&&(m.gradientMap.value=d.gradientMap)}function f(m,d){m.metalness.value=d.metalness,d.metalnessMap&&(m.metalnessMap.value=d.metalnessMap,e(d.metalnessMap,m.metalnessMapTransform)),m.roughness.value=d.roughness,d.roughnessMap&&(m.roughnessMap.value=d.roughnessMap,e(d.roughnessMap,m.roughnessMapTransform)),d.envMap&&(m.envMapIntensity.value=d.envMapIntensity)}function p(m,d,y){m.ior.value=d.ior,d.diffuseRoughness>0&&(m.diffuseRoughness.value=d.diffuseRoughness,d.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=d.diffuseRoughnessMap,e(d.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),d.sheen>0&&(m.sheenColor.value.copy(d.sheenColor).multiplyScalar(d.sheen),m.sheenRoughness.value=d.sheenRoughness,d.sheenColorMap&&(m.sheenColorMap.value=d.sheenColorMap,e(d.sheenColorMap,m.sheenColorMapTransform)),d.sheenRoughnessMap&&(m.sheenRoughnessMap.value=d.sheenRoughnessMap,e(d.sheenRoughnessMap,m.sheenRoughnessMapTransform))),d.clearcoat>0&&(m.clearcoat.value=d.clearcoat,m.clearcoatRoughness.value=d.clearcoatRoughness,d.clearcoatMap&&(m.clearcoatMap.value=d.clearcoatMap,e(d.clearcoatMap,m.clearcoatMapTransform)),d.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=d.clearcoatRoughnessMap,e(d.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),d.clearcoatNormalMap&&(m.clearcoatNormalMap.value=d.clearcoatNormalMap,e(d.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(d.clearcoatNormalScale),d.side===nn&&m.clearcoatNormalScale.value.negate())),d.dispersion>0&&(m.dispersion.value=d.dispersion),d.retroreflectivity>0&&(m.retroreflectivity.value=d.retroreflectivity),d.iridescence>0&&(m.iridescence.value=d.iridescence,m.iridescenceIOR.value=d.iridescenceIOR,m.iridescenceThicknessMinimum.value=d.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=d.iridescenceThicknessMaximum,d.iridescenceMap&&(m.iridescenceMap.value=d.iridescenceMap,e(d.iridescenceMap,m.iridescenceMapTransform)),d.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=d.iridescenceThicknessMap,e(d.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),d.transmission>0&&(m.transmission.value=d.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),d.transmissionMap&&(m.transmissionMap.value=d.transmissionMap,e(d.transmissionMap,m.transmissionMapTransform)),m.thickness.value=d.thickness,d.thicknessMap&&(m.thicknessMap.value=d.thicknessMap,e(d.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=d.attenuationDistance,m.attenuationColor.value.copy(d.attenuationColor)),d.anisotropy>0&&(m.anisotropyVector.value.set(d.anisotropy*Math.cos(d.anisotropyRotation),d.anisotropy*Math.sin(d.anisotropyRotation)),d.anisotropyMap&&(m.anisotropyMap.value=d.anisotropyMap,e(d.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=d.specularIntensity,m.specularColor.value.copy(d.specularColor),d.specularColorMap&&(m.specularColorMap.value=d.specularColorMap,e(d.specularColorMap,m.specularColorMapTransform)),d.specularIntensityMap&&(m.specularIntensityMap.value=d.specularIntensityMap,e(d.specularIntensityMap,m.specularIntensityMapTransform))}function g(m,d){d.matcap&&(m.matcap.value=d.matcap)}function _(m,d){let y=t.get(d).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function db(n,t,e,i){let s={},r={};function o(y,w){let M=w.program;i.uniformBlockBinding(y,M,s[y.id])}function a(y,w){let M=s[y.id];M===void 0&&(g(y),M=l(y),s[y.id]=M,y.addEventListener("dispose",m));let E=w.program;i.updateUBOMapping(y,E);let T=t.render.frame;r[y.id]!==T&&(c(y),r[y.id]=T)}function l(y){let w=n.createBuffer(),M=y.__size,E=y.usage;return n.bindBuffer(n.UNIFORM_BUFFER,w),n.bufferData(n.UNIFORM_BUFFER,M,E),n.bindBuffer(n.UNIFORM_BUFFER,null),w}function c(y){let w=s[y.id],M=y.uniforms,E=y.__cache;n.bindBuffer(n.UNIFORM_BUFFER,w);for(let T=0,x=M.length;T<x;T++){let v=M[T];if(Array.isArray(v))for(let C=0,R=v.length;C<R;C++)h(v[C],T,C,E);else h(v,T,0,E)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(y,w,M,E){if(f(y,w,M,E)===!0){let T=y.__offset,x=y.value;if(Array.isArray(x)){let v=0;for(let C=0;C<x.length;C++){let R=x[C],I=_(R,!0);u(R,y.__data,v),v+=I.storage/Float32Array.BYTES_PER_ELEMENT}}else u(x,y.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,y.__data)}}function u(y,w,M){typeof y=="number"||typeof y=="boolean"?w[M]=y:y.isMatrix3?(w[M]=y.elements[0],w[M+1]=y.elements[1],w[M+2]=y.elements[2],w[M+3]=0,w[M+4]=y.elements[3],w[M+5]=y.elements[4],w[M+6]=y.elements[5],w[M+7]=0,w[M+8]=y.elements[6],w[M+9]=y.elements[7],w[M+10]=y.elements[8],w[M+11]=0):ArrayBuffer.isView(y)?w.set(y.subarray(0,w.length-M),M):y.toArray(w,M)}function f(y,w,M,E){let T=y.value,x=w+"_"+M;if(Array.isArray(T)){E[x]===void 0&&(E[x]=[]);let v=E[x],C=!1;for(let R=0;R<T.length;R++)p(T[R],v,R)===!0&&(C=!0);return C}return p(T,E,x)}function p(y,w,M){if(w[M]===void 0)return typeof y=="number"||typeof y=="boolean"?w[M]=y:ArrayBuffer.isView(y)?w[M]=y.slice():w[M]=y.clone(),!0;{let E=w[M];if(typeof y=="number"||typeof y=="boolean"){if(E!==y)return w[M]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(E.equals(y)===!1)return E.copy(y),!0}}return!1}function g(y){let w=y.uniforms,M=0,E=16;for(let x=0,v=w.length;x<v;x++){let C=Array.isArray(w[x])?w[x]:[w[x]];for(let R=0,I=C.length;R<I;R++){let F=C[R],H=Array.isArray(F.value)?F.value:[F.value],P=Array.isArray(w[x])||Array.isArray(F.value),B=M;for(let W=0,tt=H.length;W<tt;W++){let $=H[W],Q=_($,P),et=M%E,wt=et%Q.boundary,Bt=et+wt;M+=wt,Bt!==0&&E-Bt<Q.storage&&(M+=E-Bt),W===0&&(B=M),M+=Q.storage}let V=F.type==="int"?Int32Array:F.type==="uint"?Uint32Array:Float32Array;F.__data=new V((M-B)/Float32Array.BYTES_PER_ELEMENT),F.__offset=B}}let T=M%E;return T>0&&(M+=E-T),y.__size=M,y.__cache={},this}function _(y,w){let M={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(M.boundary=4,M.storage=4):y.isVector2?(M.boundary=8,M.storage=8):y.isVector3||y.isColor?(M.boundary=16,M.storage=12):y.isVector4?(M.boundary=16,M.storage=16):y.isMatrix3?(M.boundary=16,M.storage=48):y.isMatrix4?(M.boundary=16,M.storage=64):y.isTexture?Pt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(M.boundary=16,M.storage=y.byteLength):Pt("WebGLRenderer: Unsupported uniform value type.",y),w===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(y){let w=y.target;w.removeEventListener("dispose",m),n.deleteBuffer(s[w.id]),delete s[w.id],delete r[w.id]}function d(){for(let y in s)n.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:d}}var fb=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Yn=null;function pb(){return Yn===null&&(Yn=new Ra(fb,16,16,Ui,Fn),Yn.name="DFG_LUT",Yn.minFilter=tn,Yn.magFilter=tn,Yn.wrapS=Wn,Yn.wrapT=Wn,Yn.generateMipmaps=!1,Yn.needsUpdate=!0),Yn}var Wl=class{constructor(t={}){let{canvas:e=Lp(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:f=!1,outputBufferType:p=ln}=t;this.isWebGLRenderer=!0;let g;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");g=i.getContextAttributes().alpha}else g=o;let _=p,m=new Set([cl,ll,al]),d=new Set([ln,Dn,Os,es,rl,ol]),y=new Uint32Array(4),w=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},E=null,T=null,x=[],v=[],C=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=qn,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let R=this,I=!1,F=null,H=null,P=null,B=null;this._outputColorSpace=fn;let V=0,W=0,tt=null,$=-1,Q=null,et=new ge,wt=new ge,Bt=null,Z=new Ut(0),mt=0,Mt=e.width,It=e.height,gt=1,zt=null,be=null,Nt=new ge(0,0,Mt,It),se=new ge(0,0,Mt,It),le=!1,Yt=new Ti,Be=new Ca,Te=!1,sn=!1,_e=new ie,zn=new N,Ne=new ge,gn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},xn=!1;function _n(){return tt===null?gt:1}let O=i;function yn(S,D){return e.getContext(S,D)}let de,fe,dt,Ae,Lt,Ot,A,b,z,nt,K,rt,ht,Y,j,at,L,J,q,lt,st,ot,Tt;try{let S={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Rt,!1),e.addEventListener("webglcontextrestored",Vt,!1),e.addEventListener("webglcontextcreationerror",ft,!1),O===null){let D="webgl2";if(O=yn(D,S),O===null)throw yn(D)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Ht()}catch(S){throw e.removeEventListener("webglcontextlost",Rt,!1),e.removeEventListener("webglcontextrestored",Vt,!1),e.removeEventListener("webglcontextcreationerror",ft,!1),Dt("WebGLRenderer: "+S.message),S}function Ht(){de=new Ev(O),de.init(),st=new ab(O,de),fe=new pv(O,de,t,st),dt=new rb(O,de),fe.reversedDepthBuffer&&f&&dt.buffers.depth.setReversed(!0),H=O.createFramebuffer(),P=O.createFramebuffer(),B=O.createFramebuffer(),Ae=new Rv(O),Lt=new XM,Ot=new ob(O,de,dt,Lt,fe,st,Ae),A=new wv(R),b=new Px(O),ot=new dv(O,b),z=new Tv(O,b,Ae,ot),nt=new Pv(O,z,b,ot,Ae),J=new Cv(O,fe,Ot),j=new mv(Lt),K=new WM(R,A,de,fe,ot,j),rt=new ub(R,Lt),ht=new qM,Y=new QM(de),L=new uv(R,A,dt,nt,g,l),at=new sb(R,nt,fe),Tt=new db(O,Ae,fe,dt),q=new fv(O,de,Ae),lt=new Av(O,de,Ae),Ae.programs=K.programs,R.capabilities=fe,R.extensions=de,R.properties=Lt,R.renderLists=ht,R.shadowMap=at,R.state=dt,R.info=Ae}_!==ln&&(C=new Lv(_,e.width,e.height,a,s,r));let it=new Du(R,O);this.xr=it,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let S=de.get("WEBGL_lose_context");S&&S.loseContext()},this.forceContextRestore=function(){let S=de.get("WEBGL_lose_context");S&&S.restoreContext()},this.getPixelRatio=function(){return gt},this.setPixelRatio=function(S){S!==void 0&&(gt=S,this.setSize(Mt,It,!1))},this.getSize=function(S){return S.set(Mt,It)},this.setSize=function(S,D,X=!0){if(it.isPresenting){Pt("WebGLRenderer: Can't change size while VR device is presenting.");return}Mt=S,It=D,e.width=Math.floor(S*gt),e.height=Math.floor(D*gt),X===!0&&(e.style.width=S+"px",e.style.height=D+"px"),C!==null&&C.setSize(e.width,e.height),this.setViewport(0,0,S,D)},this.getDrawingBufferSize=function(S){return S.set(Mt*gt,It*gt).floor()},this.setDrawingBufferSize=function(S,D,X){Mt=S,It=D,gt=X,e.width=Math.floor(S*X),e.height=Math.floor(D*X),this.setViewport(0,0,S,D)},this.setEffects=function(S){if(_===ln){Dt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(S){for(let D=0;D<S.length;D++)if(S[D].isOutputPass===!0){Pt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}C.setEffects(S||[])},this.getCurrentViewport=function(S){return S.copy(et)},this.getViewport=function(S){return S.copy(Nt)},this.setViewport=function(S,D,X,k){S.isVector4?Nt.set(S.x,S.y,S.z,S.w):Nt.set(S,D,X,k),dt.viewport(et.copy(Nt).multiplyScalar(_n()).round())},this.getScissor=function(S){return S.copy(se)},this.setScissor=function(S,D,X,k){S.isVector4?se.set(S.x,S.y,S.z,S.w):se.set(S,D,X,k),dt.scissor(wt.copy(se).multiplyScalar(_n()).round())},this.getScissorTest=function(){return le},this.setScissorTest=function(S){dt.setScissorTest(le=S)},this.setOpaqueSort=function(S){zt=S},this.setTransparentSort=function(S){be=S},this.getClearColor=function(S){return S.copy(L.getClearColor())},this.setClearColor=function(){L.setClearColor(...arguments)},this.getClearAlpha=function(){return L.getClearAlpha()},this.setClearAlpha=function(){L.setClearAlpha(...arguments)},this.clear=function(S=!0,D=!0,X=!0){let k=0;if(S){let G=!1;if(tt!==null){let ut=tt.texture.format;G=m.has(ut)}if(G){let ut=tt.texture.type,vt=d.has(ut),ct=L.getClearColor(),xt=L.getClearAlpha(),Et=ct.r,kt=ct.g,jt=ct.b;vt?(y[0]=Et,y[1]=kt,y[2]=jt,y[3]=xt,O.clearBufferuiv(O.COLOR,0,y)):(w[0]=Et,w[1]=kt,w[2]=jt,w[3]=xt,O.clearBufferiv(O.COLOR,0,w))}else k|=O.COLOR_BUFFER_BIT}D&&(k|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),X&&(k|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),k!==0&&O.clear(k)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(S){S.setRenderer(this),F=S},this.dispose=function(){e.removeEventListener("webglcontextlost",Rt,!1),e.removeEventListener("webglcontextrestored",Vt,!1),e.removeEventListener("webglcontextcreationerror",ft,!1),L.dispose(),ht.dispose(),Y.dispose(),Ot.dispose(),Lt.dispose(),A.dispose(),nt.dispose(),z.dispose(),ot.dispose(),Tt.dispose(),K.dispose(),it.dispose(),it.removeEventListener("sessionstart",Ud),it.removeEventListener("sessionend",Fd),ki.stop()};function Rt(S){S.preventDefault(),mu("WebGLRenderer: Context Lost."),I=!0}function Vt(){mu("WebGLRenderer: Context Restored."),I=!1;let S=Ae.autoReset,D=at.enabled,X=at.autoUpdate,k=at.needsUpdate,G=at.type;Ht(),Ae.autoReset=S,at.enabled=D,at.autoUpdate=X,at.needsUpdate=k,at.type=G}function ft(S){Dt("WebGLRenderer: A WebGL context could not be created. Reason: ",S.statusMessage)}function re(S){let D=S.target;D.removeEventListener("dispose",re),De(D)}function De(S){gi(S),Lt.remove(S)}function gi(S){let D=Lt.get(S).programs;D!==void 0&&(D.forEach(function(X){K.releaseProgram(X)}),S.isShaderMaterial&&K.releaseShaderCache(S))}this.renderBufferDirect=function(S,D,X,k,G,ut){D===null&&(D=gn);let vt=G.isMesh&&G.matrixWorld.determinantAffine()<0,ct=Fg(S,D,X,k,G);dt.setMaterial(k,vt);let xt=X.index,Et=1;if(k.wireframe===!0){if(xt=z.getWireframeAttribute(X),xt===void 0)return;Et=2}let kt=X.drawRange,jt=X.attributes.position,bt=kt.start*Et,Zt=(kt.start+kt.count)*Et;ut!==null&&(bt=Math.max(bt,ut.start*Et),Zt=Math.min(Zt,(ut.start+ut.count)*Et)),xt!==null?(bt=Math.max(bt,0),Zt=Math.min(Zt,xt.count)):jt!=null&&(bt=Math.max(bt,0),Zt=Math.min(Zt,jt.count));let Se=Zt-bt;if(Se<0||Se===1/0)return;ot.setup(G,k,ct,X,xt);let he,ce=q;if(xt!==null&&(he=b.get(xt),ce=lt,ce.setIndex(he)),G.isMesh)k.wireframe===!0?(dt.setLineWidth(k.wireframeLinewidth*_n()),ce.setMode(O.LINES)):ce.setMode(O.TRIANGLES);else if(G.isLine){let He=k.linewidth;He===void 0&&(He=1),dt.setLineWidth(He*_n()),G.isLineSegments?ce.setMode(O.LINES):G.isLineLoop?ce.setMode(O.LINE_LOOP):ce.setMode(O.LINE_STRIP)}else G.isPoints?ce.setMode(O.POINTS):G.isSprite&&ce.setMode(O.TRIANGLES);if(G.isBatchedMesh)if(de.get("WEBGL_multi_draw"))ce.renderMultiDraw(G._multiDrawStarts,G._multiDrawCounts,G._multiDrawCount);else{let He=G._multiDrawStarts,St=G._multiDrawCounts,Ze=G._multiDrawCount,te=xt?b.get(xt).bytesPerElement:1,zi=Lt.get(k).currentProgram.getUniforms();for(let We=0;We<Ze;We++)zi.setValue(O,"_gl_DrawID",We),ce.render(He[We]/te,St[We])}else if(G.isInstancedMesh)ce.renderInstances(bt,Se,G.count);else if(X.isInstancedBufferGeometry){let He=X._maxInstanceCount!==void 0?X._maxInstanceCount:1/0,St=Math.min(X.instanceCount,He);ce.renderInstances(bt,Se,St)}else ce.render(bt,Se)};function Dd(S,D,X,k){F!==null&&S.isNodeMaterial&&F.setObject(k,S),Te===!0&&j.setState(S,X,!1),S.transparent===!0&&S.side===Ye&&S.forceSinglePass===!1?(S.side=nn,S.needsUpdate=!0,$s(S,D,k),S.side=Di,S.needsUpdate=!0,$s(S,D,k),S.side=Ye):$s(S,D,k)}this.compile=function(S,D,X=null){X===null&&(X=S),F!==null&&F.renderStart(S,D,X),T=Y.get(X),T.init(D),v.push(T),X.traverseVisible(function(G){G.isLight&&G.layers.test(D.layers)&&(T.pushLight(G),G.castShadow&&T.pushShadow(G))}),S!==X&&S.traverseVisible(function(G){G.isLight&&G.layers.test(D.layers)&&(T.pushLight(G),G.castShadow&&T.pushShadow(G))}),T.setupLights(),F!==null&&F.updateLights(T.state.lightsArray),sn=this.localClippingEnabled,Te=j.init(this.clippingPlanes,sn),Te===!0&&j.setGlobalState(this.clippingPlanes,D),F!==null&&at.render(T.state.shadowsArray,X,D);let k=new Set;return S.traverse(function(G){if(!(G.isMesh||G.isPoints||G.isLine||G.isSprite))return;let ut=G.material;if(ut)if(Array.isArray(ut))for(let vt=0;vt<ut.length;vt++){let ct=ut[vt];Dd(ct,X,D,G),k.add(ct)}else Dd(ut,X,D,G),k.add(ut)}),T=v.pop(),F!==null&&F.renderEnd(),k},this.compileAsync=function(S,D,X=null){let k=this.compile(S,D,X);return new Promise(G=>{function ut(){if(k.forEach(function(vt){let xt=Lt.get(vt).currentProgram;(xt===void 0||xt.isReady())&&k.delete(vt)}),k.size===0){G(S);return}setTimeout(ut,10)}de.get("KHR_parallel_shader_compile")!==null?ut():setTimeout(ut,10)})};let fc=null;function Dg(S){fc&&fc(S)}function Ud(){ki.stop()}function Fd(){ki.start()}let ki=new cm;ki.setAnimationLoop(Dg),typeof self<"u"&&ki.setContext(self),this.setAnimationLoop=function(S){fc=S,it.setAnimationLoop(S),S===null?ki.stop():ki.start()},it.addEventListener("sessionstart",Ud),it.addEventListener("sessionend",Fd),this.render=function(S,D){if(D!==void 0&&D.isCamera!==!0){Dt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(I===!0)return;F!==null&&F.renderStart(S,D);let X=it.enabled===!0&&it.isPresenting===!0,k=C!==null&&(tt===null||X)&&C.begin(R,tt);if(S.matrixWorldAutoUpdate===!0&&S.updateMatrixWorld(),D.parent===null&&D.matrixWorldAutoUpdate===!0&&D.updateMatrixWorld(),it.enabled===!0&&it.isPresenting===!0&&(C===null||C.isCompositing()===!1)&&(it.cameraAutoUpdate===!0&&it.updateCamera(D),D=it.getCamera()),S.isScene===!0&&S.onBeforeRender(R,S,D,tt),T=Y.get(S,v.length),T.init(D),T.state.textureUnits=Ot.getTextureUnits(),v.push(T),_e.multiplyMatrices(D.projectionMatrix,D.matrixWorldInverse),D.isArrayCamera?Be.setFromArrayCamera(D):Yt.setFromProjectionMatrix(_e,Mn,D.reversedDepth),sn=this.localClippingEnabled,Te=j.init(this.clippingPlanes,sn),E=ht.get(S,x.length),E.init(),x.push(E),this.info.render.frame++,it.enabled===!0&&it.isPresenting===!0){let vt=R.xr.getDepthSensingMesh();vt!==null&&pc(vt,D,-1/0,R.sortObjects)}pc(S,D,0,R.sortObjects),E.finish(),F!==null&&F.updateLights(T.state.lightsArray),R.sortObjects===!0&&E.sort(zt,be),xn=it.enabled===!1||it.isPresenting===!1||it.hasDepthSensing()===!1,xn&&L.addToRenderList(E,S),this.info.autoReset===!0&&this.info.reset(),Te===!0&&j.beginShadows();let G=T.state.shadowsArray;if(at.render(G,S,D),Te===!0&&j.endShadows(),(k&&C.hasRenderPass())===!1){let vt=E.opaque,ct=E.transmissive;if(T.setupLights(),D.isArrayCamera){let xt=D.cameras;if(ct.length>0)for(let Et=0,kt=xt.length;Et<kt;Et++){let jt=xt[Et];Bd(vt,ct,S,jt)}xn&&L.render(S);for(let Et=0,kt=xt.length;Et<kt;Et++){let jt=xt[Et];Od(E,S,jt,jt.viewport)}}else ct.length>0&&Bd(vt,ct,S,D),xn&&L.render(S),Od(E,S,D)}tt!==null&&W===0&&(Ot.updateMultisampleRenderTarget(tt),Ot.updateRenderTargetMipmap(tt)),k&&C.end(R),S.isScene===!0&&S.onAfterRender(R,S,D),ot.resetDefaultState(),$=-1,Q=null,v.pop(),v.length>0?(T=v[v.length-1],Ot.setTextureUnits(T.state.textureUnits),Te===!0&&j.setGlobalState(R.clippingPlanes,T.state.camera)):T=null,x.pop(),x.length>0?E=x[x.length-1]:E=null,F!==null&&F.renderEnd()};function pc(S,D,X,k){if(S.visible===!1)return;if(S.layers.test(D.layers)){if(S.isGroup)X=S.renderOrder;else if(S.isLOD)S.autoUpdate===!0&&S.update(D);else if(S.isLight)T.pushLight(S),S.castShadow&&T.pushShadow(S);else if(S.isSprite){let vt=D.isArrayCamera?Be:Yt;if(!S.frustumCulled||S.intersectsFrustum(vt)){k&&Ne.setFromMatrixPosition(S.matrixWorld).applyMatrix4(_e);let ct=nt.update(S),xt=S.material;xt.visible&&E.push(S,ct,xt,X,Ne.z,null,D)}}else if(S.isMesh||S.isLine||S.isPoints){let vt=D.isArrayCamera?Be:Yt;if(!S.frustumCulled||S.intersectsFrustum(vt)){let ct=nt.update(S),xt=S.material;if(k&&(S.boundingSphere!==void 0?(S.boundingSphere===null&&S.computeBoundingSphere(),Ne.copy(S.boundingSphere.center)):(ct.boundingSphere===null&&ct.computeBoundingSphere(),Ne.copy(ct.boundingSphere.center)),Ne.applyMatrix4(S.matrixWorld).applyMatrix4(_e)),Array.isArray(xt)){let Et=ct.groups;for(let kt=0,jt=Et.length;kt<jt;kt++){let bt=Et[kt],Zt=xt[bt.materialIndex];Zt&&Zt.visible&&E.push(S,ct,Zt,X,Ne.z,bt,D)}}else xt.visible&&E.push(S,ct,xt,X,Ne.z,null,D)}}}let ut=S.children;for(let vt=0,ct=ut.length;vt<ct;vt++)pc(ut[vt],D,X,k)}function Od(S,D,X,k){let{opaque:G,transmissive:ut,transparent:vt}=S;T.setupLightsView(X),Te===!0&&j.setGlobalState(R.clippingPlanes,X),k&&dt.viewport(et.copy(k)),G.length>0&&So(G,D,X),ut.length>0&&So(ut,D,X),vt.length>0&&So(vt,D,X),dt.buffers.depth.setTest(!0),dt.buffers.depth.setMask(!0),dt.buffers.color.setMask(!0),dt.setPolygonOffset(!1)}function Bd(S,D,X,k){if((X.isScene===!0?X.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[k.id]===void 0){let bt=de.has("EXT_color_buffer_half_float")||de.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[k.id]=new pn(1,1,{generateMipmaps:!0,type:bt?Fn:ln,minFilter:fi,samples:Math.max(4,fe.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Jt.workingColorSpace})}let ut=T.state.transmissionRenderTarget[k.id],vt=k.viewport||et;ut.setSize(vt.z*R.transmissionResolutionScale,vt.w*R.transmissionResolutionScale);let ct=R.getRenderTarget(),xt=R.getActiveCubeFace(),Et=R.getActiveMipmapLevel();R.setRenderTarget(ut),R.getClearColor(Z),mt=R.getClearAlpha(),mt<1&&R.setClearColor(16777215,.5),R.clear(),xn&&L.render(X);let kt=R.toneMapping;R.toneMapping=qn;let jt=k.viewport;if(k.viewport!==void 0&&(k.viewport=void 0),T.setupLightsView(k),Te===!0&&j.setGlobalState(R.clippingPlanes,k),So(S,X,k),Ot.updateMultisampleRenderTarget(ut),Ot.updateRenderTargetMipmap(ut),de.has("WEBGL_multisampled_render_to_texture")===!1){let bt=!1;for(let Zt=0,Se=D.length;Zt<Se;Zt++){let he=D[Zt],{object:ce,geometry:He,material:St,group:Ze}=he;if(St.side===Ye&&ce.layers.test(k.layers)){let te=St.side;St.side=nn,St.needsUpdate=!0,kd(ce,X,k,He,St,Ze),St.side=te,St.needsUpdate=!0,bt=!0}}bt===!0&&(Ot.updateMultisampleRenderTarget(ut),Ot.updateRenderTargetMipmap(ut))}R.setRenderTarget(ct,xt,Et),R.setClearColor(Z,mt),jt!==void 0&&(k.viewport=jt),R.toneMapping=kt}function So(S,D,X){let k=D.isScene===!0?D.overrideMaterial:null;for(let G=0,ut=S.length;G<ut;G++){let vt=S[G],{object:ct,geometry:xt,group:Et}=vt,kt=vt.material;kt.allowOverride===!0&&k!==null&&(kt=k),ct.layers.test(X.layers)&&kd(ct,D,X,xt,kt,Et)}}function kd(S,D,X,k,G,ut){F!==null&&G.isNodeMaterial&&F.setObject(S,G),S.onBeforeRender(R,D,X,k,G,ut),S.modelViewMatrix.multiplyMatrices(X.matrixWorldInverse,S.matrixWorld),S.normalMatrix.getNormalMatrix(S.modelViewMatrix),G.onBeforeRender(R,D,X,k,S,ut),G.transparent===!0&&G.side===Ye&&G.forceSinglePass===!1?(G.side=nn,G.needsUpdate=!0,R.renderBufferDirect(X,D,k,G,S,ut),G.side=Di,G.needsUpdate=!0,R.renderBufferDirect(X,D,k,G,S,ut),G.side=Ye):R.renderBufferDirect(X,D,k,G,S,ut),S.onAfterRender(R,D,X,k,G,ut)}function zd(S){let D=0;for(let X of S)X.texture!==null&&D++;return D}function $s(S,D,X){D.isScene!==!0&&(D=gn);let k=Lt.get(S),G=T.state.lights,ut=T.state.shadowsArray,vt=G.state.version,ct=K.getParameters(S,G.state,ut,D,X,T.state.lightProbeGridArray),xt=K.getProgramCacheKey(ct),Et=k.programs;k.environment=S.isMeshStandardMaterial||S.isMeshLambertMaterial||S.isMeshPhongMaterial?D.environment:null,k.fog=D.fog;let kt=S.isMeshStandardMaterial||S.isMeshLambertMaterial&&!S.envMap||S.isMeshPhongMaterial&&!S.envMap;k.envMap=A.get(S.envMap||k.environment,kt),k.envMapRotation=k.environment!==null&&S.envMap===null?D.environmentRotation:S.envMapRotation,Et===void 0&&(S.addEventListener("dispose",re),Et=new Map,k.programs=Et,k.programVariants=new Map);let jt=Et.get(xt);if(jt!==void 0){if(k.currentProgram===jt&&k.lightsStateVersion===vt)return Vd(S,ct),jt}else ct.uniforms=K.getUniforms(S),F!==null&&S.isNodeMaterial&&F.build(S,X,ct),S.onBeforeCompile(ct,R),jt=K.acquireProgram(ct,xt),Et.set(xt,jt),k.uniforms=ct.uniforms;let bt=k.uniforms;return(!S.isShaderMaterial&&!S.isRawShaderMaterial||S.clipping===!0)&&(bt.clippingPlanes=j.uniform),Vd(S,ct),k.needsLights=Bg(S),k.lightsStateVersion=vt,k.needsLights&&(bt.ambientLightColor.value=G.state.ambient,bt.lightProbe.value=G.state.probe,bt.sunLights.value=G.state.sun,bt.sunLightShadows.value=G.state.sunShadow,bt.directionalLights.value=G.state.directional,bt.directionalLightShadows.value=G.state.directionalShadow,bt.spotLights.value=G.state.spot,bt.spotLightShadows.value=G.state.spotShadow,bt.rectAreaLights.value=G.state.rectArea,bt.ltc_1.value=G.state.rectAreaLTC1,bt.ltc_2.value=G.state.rectAreaLTC2,bt.pointLights.value=G.state.point,bt.pointLightShadows.value=G.state.pointShadow,bt.hemisphereLights.value=G.state.hemi,bt.sunShadowMatrix.value=G.state.sunShadowMatrix,bt.sunShadowCascade.value=G.state.sunShadowCascade,bt.directionalShadowMatrix.value=G.state.directionalShadowMatrix,bt.spotLightMatrix.value=G.state.spotLightMatrix,bt.spotLightMap.value=G.state.spotLightMap,bt.pointShadowMatrix.value=G.state.pointShadowMatrix),k.numLightProbeGrids=zd(T.state.lightProbeGridArray),k.currentProgram=jt,k.uniformsList=null,jt}function Ug(S,D,X,k,G){let ut=Lt.get(S),vt=ut.currentProgram.id+","+k+","+G,ct=ut.programVariants.get(vt);return ct===void 0?(ct=$s(S,D,X),ut.programVariants.set(vt,ct)):(ut.currentProgram=ct,ut.uniformsList=null,ut.outputColorSpace=k,ut.toneMapping=G),ct}function Gd(S){if(S.uniformsList===null){let D=S.currentProgram.getUniforms();S.uniformsList=ks.seqWithValue(D.seq,S.uniforms)}return S.uniformsList}function Vd(S,D){let X=Lt.get(S);X.outputColorSpace=D.outputColorSpace,X.batching=D.batching,X.batchingColor=D.batchingColor,X.instancing=D.instancing,X.instancingColor=D.instancingColor,X.instancingMorph=D.instancingMorph,X.skinning=D.skinning,X.morphTargets=D.morphTargets,X.morphNormals=D.morphNormals,X.morphColors=D.morphColors,X.morphTargetsCount=D.morphTargetsCount,X.numClippingPlanes=D.numClippingPlanes,X.numIntersection=D.numClipIntersection,X.vertexAlphas=D.vertexAlphas,X.vertexTangents=D.vertexTangents,X.toneMapping=D.toneMapping}function Fg(S,D,X,k,G){D.isScene!==!0&&(D=gn),Ot.resetTextureUnits();let ut=D.fog,vt=k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial?D.environment:null,ct=tt===null?R.outputColorSpace:tt.isXRRenderTarget===!0?tt.texture.colorSpace:Jt.workingColorSpace,xt=k.isMeshStandardMaterial||k.isMeshLambertMaterial&&!k.envMap||k.isMeshPhongMaterial&&!k.envMap,Et=A.get(k.envMap||vt,xt),kt=k.vertexColors===!0&&!!X.attributes.color&&X.attributes.color.itemSize===4,jt=!!X.attributes.tangent&&(!!k.normalMap||k.anisotropy>0),bt=!!X.morphAttributes.position,Zt=!!X.morphAttributes.normal,Se=!!X.morphAttributes.color,he=qn;k.toneMapped&&(tt===null||tt.isXRRenderTarget===!0)&&(he=R.toneMapping);let ce=X.morphAttributes.position||X.morphAttributes.normal||X.morphAttributes.color,He=ce!==void 0?ce.length:0,St=Lt.get(k),Ze=T.state.lights;if(Te===!0&&(sn===!0||S!==Q)){let ye=S===Q&&k.id===$;j.setState(k,S,ye)}let te=!1,zi=!1;k.version===St.__version?St.needsLights&&St.lightsStateVersion!==Ze.state.version||G.isBatchedMesh&&St.batching===!1||!G.isBatchedMesh&&St.batching===!0||G.isBatchedMesh&&St.batchingColor===!0&&G._colorsTexture===null||G.isBatchedMesh&&St.batchingColor===!1&&G._colorsTexture!==null||G.isInstancedMesh&&St.instancing===!1||!G.isInstancedMesh&&St.instancing===!0||G.isSkinnedMesh&&St.skinning===!1||!G.isSkinnedMesh&&St.skinning===!0||G.isInstancedMesh&&St.instancingColor===!0&&G.instanceColor===null||G.isInstancedMesh&&St.instancingColor===!1&&G.instanceColor!==null||G.isInstancedMesh&&St.instancingMorph===!0&&G.morphTexture===null||G.isInstancedMesh&&St.instancingMorph===!1&&G.morphTexture!==null||St.envMap!==Et||k.fog===!0&&St.fog!==ut||St.numClippingPlanes!==void 0&&(St.numClippingPlanes!==j.numPlanes||St.numIntersection!==j.numIntersection)||St.vertexAlphas!==kt||St.vertexTangents!==jt||St.morphTargets!==bt||St.morphNormals!==Zt||St.morphColors!==Se||St.morphTargetsCount!==He||St.numLightProbeGrids!==zd(T.state.lightProbeGridArray)?te=!0:(St.outputColorSpace!==ct||St.toneMapping!==he)&&(zi=!0):(te=!0,St.__version=k.version);let We=St.currentProgram;(te===!0||zi===!0)&&(We=zi===!0?Ug(k,D,G,ct,he):$s(k,D,G),F&&k.isNodeMaterial&&F.onUpdateProgram(k,We,St));let wo=!1,xi=!1,Gi=!1,Qt=We.getUniforms(),ke=St.uniforms;if(dt.useProgram(We.program)&&(wo=!0,xi=!0,Gi=!0),k.id!==$&&($=k.id,xi=!0),wo||Q!==S){dt.buffers.depth.getReversed()&&S.reversedDepth!==!0&&(S._reversedDepth=!0,S.updateProjectionMatrix()),Qt.setValue(O,"projectionMatrix",S.projectionMatrix),Qt.setValue(O,"viewMatrix",S.matrixWorldInverse);let Ue=Qt.map.cameraPosition;Ue!==void 0&&Ue.setValue(O,zn.setFromMatrixPosition(S.matrixWorld)),fe.logarithmicDepthBuffer&&Qt.setValue(O,"logDepthBufFC",2/(Math.log(S.far+1)/Math.LN2)),(k.isMeshPhongMaterial||k.isMeshToonMaterial||k.isMeshLambertMaterial||k.isMeshBasicMaterial||k.isMeshStandardMaterial||k.isShaderMaterial)&&Qt.setValue(O,"isOrthographic",S.isOrthographicCamera===!0),Q!==S&&(Q=S,xi=!0,Gi=!0)}if(St.needsLights&&(Ze.state.sunShadowMap.length>0&&Qt.setValue(O,"sunShadowMap",Ze.state.sunShadowMap,Ot),Ze.state.directionalShadowMap.length>0&&Qt.setValue(O,"directionalShadowMap",Ze.state.directionalShadowMap,Ot),Ze.state.spotShadowMap.length>0&&Qt.setValue(O,"spotShadowMap",Ze.state.spotShadowMap,Ot),Ze.state.pointShadowMap.length>0&&Qt.setValue(O,"pointShadowMap",Ze.state.pointShadowMap,Ot)),G.isSkinnedMesh){Qt.setOptional(O,G,"bindMatrix"),Qt.setOptional(O,G,"bindMatrixInverse");let ye=G.skeleton;ye&&(ye.boneTexture===null&&ye.computeBoneTexture(),Qt.setValue(O,"boneTexture",ye.boneTexture,Ot))}G.isBatchedMesh&&(Qt.setOptional(O,G,"batchingTexture"),Qt.setValue(O,"batchingTexture",G._matricesTexture,Ot),Qt.setOptional(O,G,"batchingIdTexture"),Qt.setValue(O,"batchingIdTexture",G._indirectTexture,Ot),Qt.setOptional(O,G,"batchingColorTexture"),G._colorsTexture!==null&&Qt.setValue(O,"batchingColorTexture",G._colorsTexture,Ot));let En=X.morphAttributes;if((En.position!==void 0||En.normal!==void 0||En.color!==void 0)&&J.update(G,X,We),(xi||St.receiveShadow!==G.receiveShadow)&&(St.receiveShadow=G.receiveShadow,Qt.setValue(O,"receiveShadow",G.receiveShadow)),(k.isMeshStandardMaterial||k.isMeshLambertMaterial||k.isMeshPhongMaterial)&&k.envMap===null&&D.environment!==null&&(ke.envMapIntensity.value=D.environmentIntensity),ke.dfgLUT!==void 0&&(ke.dfgLUT.value=pb()),xi){if(Qt.setValue(O,"toneMappingExposure",R.toneMappingExposure),St.needsLights&&Og(ke,Gi),ut&&k.fog===!0&&rt.refreshFogUniforms(ke,ut),rt.refreshMaterialUniforms(ke,k,gt,It,T.state.transmissionRenderTarget[S.id]),St.needsLights&&St.numLightProbeGrids>0){let ye=M,Ue=0;for(let Qn of T.state.lightProbeGridArray)Qn.texture!==null&&(ye.textures[Ue]=Qn.texture,ye.min[Ue]=Qn.boundingBox.min,ye.max[Ue]=Qn.boundingBox.max,ye.resolution[Ue]=Qn.resolution,Ue++);for(let Qn in ye)ye[Qn].length=Ue;ke.probesSH.value=ye.textures,ke.probesMin.value=ye.min,ke.probesMax.value=ye.max,ke.probesResolution.value=ye.resolution}ks.upload(O,Gd(St),ke,Ot)}if(k.isShaderMaterial&&k.uniformsNeedUpdate===!0&&(ks.upload(O,Gd(St),ke,Ot),k.uniformsNeedUpdate=!1),k.isSpriteMaterial&&Qt.setValue(O,"center",G.center),Qt.setValue(O,"modelViewMatrix",G.modelViewMatrix),Qt.setValue(O,"normalMatrix",G.normalMatrix),Qt.setValue(O,"modelMatrix",G.matrixWorld),k.uniformsGroups!==void 0){let ye=k.uniformsGroups;for(let Ue=0,Qn=ye.length;Ue<Qn;Ue++){let Wd=ye[Ue];Tt.update(Wd,We),Tt.bind(Wd,We)}}return We}function Og(S,D){S.ambientLightColor.needsUpdate=D,S.lightProbe.needsUpdate=D,S.sunLights.needsUpdate=D,S.sunLightShadows.needsUpdate=D,S.directionalLights.needsUpdate=D,S.directionalLightShadows.needsUpdate=D,S.pointLights.needsUpdate=D,S.pointLightShadows.needsUpdate=D,S.spotLights.needsUpdate=D,S.spotLightShadows.needsUpdate=D,S.rectAreaLights.needsUpdate=D,S.hemisphereLights.needsUpdate=D}function Bg(S){return S.isMeshLambertMaterial||S.isMeshToonMaterial||S.isMeshPhongMaterial||S.isMeshStandardMaterial||S.isShadowMaterial||S.isShaderMaterial&&S.lights===!0}this.getActiveCubeFace=function(){return V},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return tt},this.setRenderTargetTextures=function(S,D,X){let k=Lt.get(S);k.__autoAllocateDepthBuffer=S.resolveDepthBuffer===!1,k.__autoAllocateDepthBuffer===!1&&(k.__useRenderToTexture=!1),Lt.get(S.texture).__webglTexture=D,Lt.get(S.depthTexture).__webglTexture=k.__autoAllocateDepthBuffer?void 0:X,k.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(S,D){let X=Lt.get(S);X.__webglFramebuffer=D,X.__useDefaultFramebuffer=D===void 0},this.setRenderTarget=function(S,D=0,X=0){tt=S,V=D,W=X;let k=null,G=!1,ut=!1;if(S){let ct=Lt.get(S);if(ct.__useDefaultFramebuffer!==void 0){dt.bindFramebuffer(O.FRAMEBUFFER,ct.__webglFramebuffer),et.copy(S.viewport),wt.copy(S.scissor),Bt=S.scissorTest,dt.viewport(et),dt.scissor(wt),dt.setScissorTest(Bt),$=-1;return}else if(ct.__webglFramebuffer===void 0)Ot.setupRenderTarget(S);else if(ct.__hasExternalTextures)Ot.rebindTextures(S,Lt.get(S.texture).__webglTexture,Lt.get(S.depthTexture).__webglTexture);else if(S.depthBuffer){let kt=S.depthTexture;if(ct.__boundDepthTexture!==kt){if(kt!==null&&Lt.has(kt)&&(S.width!==kt.image.width||S.height!==kt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ot.setupDepthRenderbuffer(S)}}let xt=S.texture;(xt.isData3DTexture||xt.isDataArrayTexture||xt.isCompressedArrayTexture)&&(ut=!0);let Et=Lt.get(S).__webglFramebuffer;S.isWebGLCubeRenderTarget?(Array.isArray(Et[D])?k=Et[D][X]:k=Et[D],G=!0):S.samples>0&&Ot.useMultisampledRTT(S)===!1?k=Lt.get(S).__webglMultisampledFramebuffer:Array.isArray(Et)?k=Et[X]:k=Et,et.copy(S.viewport),wt.copy(S.scissor),Bt=S.scissorTest}else et.copy(Nt).multiplyScalar(gt).floor(),wt.copy(se).multiplyScalar(gt).floor(),Bt=le;if(X!==0&&(k=H),dt.bindFramebuffer(O.FRAMEBUFFER,k)&&dt.drawBuffers(S,k),dt.viewport(et),dt.scissor(wt),dt.setScissorTest(Bt),G){let ct=Lt.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+D,ct.__webglTexture,X)}else if(ut){let ct=D;for(let xt=0;xt<S.textures.length;xt++){let Et=Lt.get(S.textures[xt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+xt,Et.__webglTexture,X,ct)}}else if(S!==null&&X!==0){let ct=Lt.get(S.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ct.__webglTexture,X)}$=-1};function Hd(S){let D=Lt.get(S);return(D.__readFormat!==S.format||D.__readType!==S.type)&&(D.__readFormat=S.format,D.__readType=S.type,D.__formatReadable=fe.textureFormatReadable(S.format),D.__typeReadable=fe.textureTypeReadable(S.type)),D}this.readRenderTargetPixels=function(S,D,X,k,G,ut,vt,ct=0){if(!(S&&S.isWebGLRenderTarget)){Dt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let xt=Lt.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&vt!==void 0&&(xt=xt[vt],Array.isArray(xt)&&(xt=xt[0])),xt){dt.bindFramebuffer(O.FRAMEBUFFER,xt);try{let Et=S.textures[ct],kt=Et.format,jt=Et.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ct);let bt=Hd(Et);if(bt.__formatReadable===!1){Dt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(bt.__typeReadable===!1){Dt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}D>=0&&D<=S.width-k&&X>=0&&X<=S.height-G&&O.readPixels(D,X,k,G,st.convert(kt),st.convert(jt),ut)}finally{let Et=tt!==null?Lt.get(tt).__webglFramebuffer:null;dt.bindFramebuffer(O.FRAMEBUFFER,Et)}}},this.readRenderTargetPixelsAsync=async function(S,D,X,k,G,ut,vt,ct=0){if(!(S&&S.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let xt=Lt.get(S).__webglFramebuffer;if(S.isWebGLCubeRenderTarget&&vt!==void 0&&(xt=xt[vt],Array.isArray(xt)&&(xt=xt[0])),xt)if(D>=0&&D<=S.width-k&&X>=0&&X<=S.height-G){dt.bindFramebuffer(O.FRAMEBUFFER,xt);let Et=S.textures[ct],kt=Et.format,jt=Et.type;S.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ct);let bt=Hd(Et);if(bt.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(bt.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Zt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,Zt),O.bufferData(O.PIXEL_PACK_BUFFER,ut.byteLength,O.STREAM_READ),O.readPixels(D,X,k,G,st.convert(kt),st.convert(jt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Se=tt!==null?Lt.get(tt).__webglFramebuffer:null;dt.bindFramebuffer(O.FRAMEBUFFER,Se);let he=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await Dp(O,he,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,Zt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,ut),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(Zt),O.deleteSync(he),ut}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(S,D=null,X=0){let k=Math.pow(2,-X),G=Math.floor(S.image.width*k),ut=Math.floor(S.image.height*k),vt=D!==null?D.x:0,ct=D!==null?D.y:0;Ot.setTexture2D(S,0),O.copyTexSubImage2D(O.TEXTURE_2D,X,0,0,vt,ct,G,ut),dt.unbindTexture()},this.copyTextureToTexture=function(S,D,X=null,k=null,G=0,ut=0){let vt,ct,xt,Et,kt,jt,bt,Zt,Se,he=S.isCompressedTexture?S.mipmaps[ut]:S.image;if(X!==null)vt=X.max.x-X.min.x,ct=X.max.y-X.min.y,xt=X.isBox3?X.max.z-X.min.z:1,Et=X.min.x,kt=X.min.y,jt=X.isBox3?X.min.z:0;else{let Qt=Math.pow(2,-G);vt=Math.floor(he.width*Qt),ct=Math.floor(he.height*Qt),S.isDataArrayTexture?xt=he.depth:S.isData3DTexture?xt=Math.floor(he.depth*Qt):xt=1,Et=0,kt=0,jt=0}k!==null?(bt=k.x,Zt=k.y,Se=k.z):(bt=0,Zt=0,Se=0);let ce=st.convert(D.format),He=st.convert(D.type),St;D.isData3DTexture?(Ot.setTexture3D(D,0),St=O.TEXTURE_3D):D.isDataArrayTexture||D.isCompressedArrayTexture?(Ot.setTexture2DArray(D,0),St=O.TEXTURE_2D_ARRAY):(Ot.setTexture2D(D,0),St=O.TEXTURE_2D),dt.activeTexture(O.TEXTURE0),dt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,D.flipY),dt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,D.premultiplyAlpha),dt.pixelStorei(O.UNPACK_ALIGNMENT,D.unpackAlignment);let Ze=dt.getParameter(O.UNPACK_ROW_LENGTH),te=dt.getParameter(O.UNPACK_IMAGE_HEIGHT),zi=dt.getParameter(O.UNPACK_SKIP_PIXELS),We=dt.getParameter(O.UNPACK_SKIP_ROWS),wo=dt.getParameter(O.UNPACK_SKIP_IMAGES);dt.pixelStorei(O.UNPACK_ROW_LENGTH,he.width),dt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,he.height),dt.pixelStorei(O.UNPACK_SKIP_PIXELS,Et),dt.pixelStorei(O.UNPACK_SKIP_ROWS,kt),dt.pixelStorei(O.UNPACK_SKIP_IMAGES,jt);let xi=S.isDataArrayTexture||S.isData3DTexture,Gi=D.isDataArrayTexture||D.isData3DTexture;if(S.isDepthTexture){let Qt=Lt.get(S),ke=Lt.get(D),En=Lt.get(Qt.__renderTarget),ye=Lt.get(ke.__renderTarget);dt.bindFramebuffer(O.READ_FRAMEBUFFER,En.__webglFramebuffer),dt.bindFramebuffer(O.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let Ue=0;Ue<xt;Ue++)xi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Lt.get(S).__webglTexture,G,jt+Ue),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Lt.get(D).__webglTexture,ut,Se+Ue)),O.blitFramebuffer(Et,kt,Et+vt,kt+ct,bt,Zt,bt+vt,Zt+ct,O.DEPTH_BUFFER_BIT,O.NEAREST);dt.bindFramebuffer(O.READ_FRAMEBUFFER,null),dt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(G!==0||S.isRenderTargetTexture||Lt.has(S)){let Qt=Lt.get(S),ke=Lt.get(D);dt.bindFramebuffer(O.READ_FRAMEBUFFER,P),dt.bindFramebuffer(O.DRAW_FRAMEBUFFER,B);for(let En=0;En<xt;En++)xi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Qt.__webglTexture,G,jt+En):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Qt.__webglTexture,G),Gi?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ke.__webglTexture,ut,Se+En):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ke.__webglTexture,ut),G!==0?O.blitFramebuffer(Et,kt,Et+vt,kt+ct,bt,Zt,bt+vt,Zt+ct,O.COLOR_BUFFER_BIT,O.NEAREST):Gi?O.copyTexSubImage3D(St,ut,bt,Zt,Se+En,Et,kt,vt,ct):O.copyTexSubImage2D(St,ut,bt,Zt,Et,kt,vt,ct);dt.bindFramebuffer(O.READ_FRAMEBUFFER,null),dt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Gi?S.isDataTexture||S.isData3DTexture?O.texSubImage3D(St,ut,bt,Zt,Se,vt,ct,xt,ce,He,he.data):D.isCompressedArrayTexture?O.compressedTexSubImage3D(St,ut,bt,Zt,Se,vt,ct,xt,ce,he.data):O.texSubImage3D(St,ut,bt,Zt,Se,vt,ct,xt,ce,He,he):S.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,ut,bt,Zt,vt,ct,ce,He,he.data):S.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,ut,bt,Zt,he.width,he.height,ce,he.data):O.texSubImage2D(O.TEXTURE_2D,ut,bt,Zt,vt,ct,ce,He,he);dt.pixelStorei(O.UNPACK_ROW_LENGTH,Ze),dt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,te),dt.pixelStorei(O.UNPACK_SKIP_PIXELS,zi),dt.pixelStorei(O.UNPACK_SKIP_ROWS,We),dt.pixelStorei(O.UNPACK_SKIP_IMAGES,wo),ut===0&&D.generateMipmaps===!0&&D.mipmapsAutoUpdate===!0&&O.generateMipmap(St),dt.unbindTexture()},this.initRenderTarget=function(S){Lt.get(S).__webglFramebuffer===void 0&&Ot.setupRenderTarget(S)},this.initTexture=function(S){S.isCubeTexture?Ot.setTextureCube(S,0):S.isData3DTexture?Ot.setTexture3D(S,0):S.isDataArrayTexture||S.isCompressedArrayTexture?Ot.setTexture2DArray(S,0):Ot.setTexture2D(S,0),dt.unbindTexture()},this.resetState=function(){V=0,W=0,tt=null,dt.reset(),ot.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Mn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Jt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Jt._getUnpackColorSpace()}};var vm={type:"change"},Fu={type:"start"},bm={type:"end"},ql=new Ei,Mm=new Ke,mb=Math.cos(70*yu.DEG2RAD),Le=new N,cn=2*Math.PI,ee={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Uu=1e-6,Yl=class extends Wr{constructor(t,e=null){super(t,e),this.state=ee.NONE,this.target=new N,this.cursor=new N,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Li.ROTATE,MIDDLE:Li.DOLLY,RIGHT:Li.PAN},this.touches={ONE:Ni.ROTATE,TWO:Ni.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new N,this._lastQuaternion=new en,this._lastTargetPosition=new N,this._quat=new en().setFromUnitVectors(t.up,new N(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Ii,this._sphericalDelta=new Ii,this._scale=1,this._panOffset=new N,this._rotateStart=new _t,this._rotateEnd=new _t,this._rotateDelta=new _t,this._panStart=new _t,this._panEnd=new _t,this._panDelta=new _t,this._dollyStart=new _t,this._dollyEnd=new _t,this._dollyDelta=new _t,this._dollyDirection=new N,this._mouse=new _t,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=xb.bind(this),this._onPointerDown=gb.bind(this),this._onPointerUp=_b.bind(this),this._onContextMenu=Eb.bind(this),this._onMouseWheel=Mb.bind(this),this._onKeyDown=bb.bind(this),this._onTouchStart=Sb.bind(this),this._onTouchMove=wb.bind(this),this._onMouseDown=yb.bind(this),this._onMouseMove=vb.bind(this),this._interceptControlDown=Tb.bind(this),this._interceptControlUp=Ab.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=ee.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(vm),this.update(),this.state=ee.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Le.copy(e).sub(this.target),Le.applyQuaternion(this._quat),this._spherical.setFromVector3(Le),this.autoRotate&&this.state===ee.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=cn:i>Math.PI&&(i-=cn),s<-Math.PI?s+=cn:s>Math.PI&&(s-=cn),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Le.setFromSpherical(this._spherical),Le.applyQuaternion(this._quatInverse),e.copy(this.target).add(Le),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Le.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new N(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new N(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Le.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(ql.origin.copy(this.object.position),ql.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(ql.direction))<mb?this.object.lookAt(this.target):(Mm.setFromNormalAndCoplanarPoint(this.object.up,this.target),ql.intersectPlane(Mm,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Uu||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Uu||this._lastTargetPosition.distanceToSquared(this.target)>Uu?(this.dispatchEvent(vm),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?cn/60*this.autoRotateSpeed*t:cn/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Le.setFromMatrixColumn(e,0),Le.multiplyScalar(-t),this._panOffset.add(Le)}_panUp(t,e){this.screenSpacePanning===!0?Le.setFromMatrixColumn(e,1):(Le.setFromMatrixColumn(e,0),Le.crossVectors(this.object.up,Le)),Le.multiplyScalar(t),this._panOffset.add(Le)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Le.copy(s).sub(this.target);let r=Le.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(cn*this._rotateDelta.x/e.clientHeight),this._rotateUp(cn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-cn*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(cn*this._rotateDelta.x/e.clientHeight),this._rotateUp(cn*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new _t,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function gb(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function xb(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function _b(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(bm),this.state=ee.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function yb(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case Li.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=ee.DOLLY;break;case Li.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ee.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ee.ROTATE}break;case Li.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=ee.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=ee.PAN}break;default:this.state=ee.NONE}this.state!==ee.NONE&&this.dispatchEvent(Fu)}function vb(n){switch(this.state){case ee.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case ee.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case ee.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function Mb(n){this.enabled===!1||this.enableZoom===!1||this.state!==ee.NONE||(n.preventDefault(),this.dispatchEvent(Fu),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(bm))}function bb(n){this.enabled!==!1&&this._handleKeyDown(n)}function Sb(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Ni.ROTATE:if(this.enableRotate===!1){this.state=ee.NONE;break}this._handleTouchStartRotate(n),this.state=ee.TOUCH_ROTATE;break;case Ni.PAN:if(this.enablePan===!1){this.state=ee.NONE;break}this._handleTouchStartPan(n),this.state=ee.TOUCH_PAN;break;default:this.state=ee.NONE}break;case 2:switch(this.touches.TWO){case Ni.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=ee.TOUCH_DOLLY_PAN;break;case Ni.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=ee.TOUCH_DOLLY_ROTATE;break;default:this.state=ee.NONE}break;default:this.state=ee.NONE}this.state!==ee.NONE&&this.dispatchEvent(Fu)}function wb(n){switch(this._trackPointer(n),this.state){case ee.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case ee.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case ee.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case ee.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=ee.NONE}}function Eb(n){this.enabled!==!1&&n.preventDefault()}function Tb(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function Ab(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Gu={};oe(Gu,{AXES:()=>Am,ArmShape:()=>is,Arrow:()=>Vs,Ellipsoid:()=>so,Triads:()=>io,along:()=>Gs,ball:()=>oo,floor:()=>zu,ghostMaterial:()=>Jl,isShared:()=>Bu,paint:()=>Ib,rod:()=>Zl,square:()=>Hs,tube:()=>ao,wall:()=>ku});var Rb=new N(0,1,0),Sm=new ji(1,1,1,28,1,!0),ro=new ji(1,1,1,36),jl=new Dr(1,28,18),wm=new Ai(1,1,1),Ou=new Ir(1,1,24),Em=new Zi(1,1),Cb=[["x",0],["x",Math.PI/2],["y",Math.PI/2]],Tm=new an().setFromPoints(Array.from({length:64},(n,t)=>new N(Math.cos(t*Math.PI/32),Math.sin(t*Math.PI/32),0))),Pb=new Set([Sm,ro,jl,wm,Ou,Em,Tm]),Bu=n=>Pb.has(n),Ib=n=>new Ve({color:n}),oo=n=>new Ce(jl,n),Zl=n=>new Ce(ro,n);function Hs(n,t){let e=new Ce(Em,t);return e.scale.setScalar(n),e}var Fi=n=>new N().fromArray(n),Lb=[0,0,0],Nb=new Ut(1,1,1),no=class extends Ce{isInstancedMesh=!0;instanceColor=null;morphTexture=null;constructor(t,e,i){super(t,e),this.count=i,this.instanceMatrix=new Ps(new Float32Array(16*i),16),this.frustumCulled=!1,this.matrixAutoUpdate=!1,this.instanceMatrix.setUsage(fu);for(let s=0;s<i;s++)this.hide(s)}put(t,e,i,s,r){[e,i,s,r].forEach((o,a)=>this.instanceMatrix.array.set(o,16*t+4*a)),this.instanceMatrix.array[16*t+15]=1,this.instanceMatrix.needsUpdate=!0}between(t,e,i,s,r=null){let o=At(i,e),a=$t(o);if(!(a>1e-6))return this.hide(t),!1;let c=r??Db(o,a),h=s/$t(c);return this.put(t,Ct(h,c),o,Ct(h/a,ve(c,o)),Gt(e,Ct(.5,o))),!0}ball(t,e,i){this.put(t,[i,0,0],[0,i,0],[0,0,i],e)}hide(t){this.ball(t,Lb,0)}colour(t){this.instanceColor??=new Ps(new Float32Array(3*this.count),3);for(let e=0;e<this.count;e++)t(e).toArray(this.instanceColor.array,3*e);this.instanceColor.needsUpdate=!0}dispose(){this.dispatchEvent({type:"dispose"})}};function Db(n,t){return ve(n,Math.abs(n[2])<.7*t?[0,0,1]:[1,0,0])}function Gs(n,t,e,i){let s=Fi(At(e,t)),r=s.length();n.visible=r>1e-6,n.visible&&(n.position.copy(Fi(t)).addScaledVector(s,.5),n.quaternion.copy(new en().setFromUnitVectors(Rb,s.divideScalar(r))),n.scale.set(i,r,i))}var is=class extends Ee{constructor(t,{link:e,joint:i,ghost:s=!1,girth:r=s?.97:1,hue:o=null}){super(),this.arm=t,this.size=tr(t),this.girth=r*this.size,this.stands=!s,this.hue=o;let a=t.rows.length,l=(c,h,u)=>{let f=new no(c,h,u);return f.castShadow=f.receiveShadow=!s,this.add(f),f};if(this.rods=l(Sm,e,2*a),this.balls=l(jl,e,2*a),this.barrels=l(ro,i,a+1),this.boxes=t.rows.some(c=>c.kind==="prismatic")?l(wm,i,a):null,this.stands&&this.barrels.between(a,[0,0,-.004*this.size],[0,0,.012*this.size],.05*this.size),!!o){for(let c of[this.rods,this.balls])c.colour(()=>Nb);this.tint(()=>null)}}tint(t){let e=i=>t(i)??this.hue;this.barrels.colour(e),this.boxes?.colour(e)}pose(t){this.arm.rows.forEach((e,i)=>{let[s,r]=[t[i],t[i+1]],o=At(r.o,Ct(e.a,r.x)),a=this.radius(i),l=e.kind==="prismatic",c=this.rods.between(2*i,s.o,o,l?.6*a:a),h=this.rods.between(2*i+1,o,r.o,a),u=[o,r.o],f=[l?.6:1,i===this.arm.rows.length-1?.8:1];u.forEach((p,g)=>{c||h?this.balls.ball(2*i+g,p,f[g]*a):this.balls.hide(2*i+g)}),e.kind!=="fixed"&&this.joint(i,s,a,l)})}joint(t,{o:e,x:i,z:s},r,o){let a=Ct(o?2.2*r:1.45*r,s),[l,c]=[At(e,a),Gt(e,a)];o?this.boxes.between(t,l,c,2*r,i):this.barrels.between(t,l,c,1.28*r)}radius(t){let e=this.arm.rows.length;return this.girth*(t===e-1?.008:.021-.008*t/e)}},Vs=class extends Ee{constructor(t){super(),this.shaft=new Ce(ro,t),this.head=new Ce(Ou,t),this.add(this.shaft,this.head)}point(t,e,i){let s=$t(e);if(this.visible=s>1e-9,!this.visible)return;let r=Math.max(0,s-5*i);Gs(this.shaft,t,Gt(t,Ct(r/s,e)),i),Gs(this.head,Gt(t,Ct(r/s,e)),Gt(t,e),2.4*i)}},Am={x:"#D55E00",y:"#009E73",z:"#0072B2"},Ub={x:"#F58A3C",y:"#3CC79B",z:"#5AB4EC"},io=class extends Ee{constructor(t,e){super();let i=Object.values(t?Ub:Am).map(s=>new Ut(s));this.shafts=new no(ro,new Ve,3*e),this.heads=new no(Ou,new Ve,3*e);for(let s of[this.shafts,this.heads])s.colour(r=>i[r%3]);this.add(this.shafts,this.heads)}pose(t,e,i=null){let s=.022*e;t.forEach((r,o)=>["x","y","z"].forEach((a,l)=>{let[c,h]=[e-5*s,e].map(u=>Gt(r.o,Ct(u,r[a])));for(let[u,f,p,g]of[[this.shafts,r.o,c,s],[this.heads,c,h,2.4*s]])!i||i[o]?u.between(3*o+l,f,p,g):u.hide(3*o+l)}))}},so=class extends Ee{constructor(t){super();let e=new $n({color:t,transparent:!0,opacity:.2,depthWrite:!1,side:Ye});this.add(new Ce(jl,e));for(let[i,s]of Cb){let r=new Ar(Tm,new Is({color:t}));r.rotation[i]=s,this.add(r)}this.matrixAutoUpdate=!1}pose(t,{values:e,vectors:i},s,r){let o=i.map((h,u)=>Fi(Ct(Math.max(s*e[u],r),h))),[a,l,c]=o;this.matrix.makeBasis(a,l,c).premultiply(new ie().makeTranslation(Fi(t)))}};function ao(n,t,e){let s=n.filter((o,a)=>a===0||$t(At(o,n[a-1]))>1e-7);if(s.length<2)return new Ee;let r=new Ls(s.map(Fi));return new Ce(new Ur(r,Math.min(400,s.length*2),t,8),new Ve({color:e}))}function ku(n,t){let e=n.length,i=Ct(1/e,n.reduce(Gt)),[s,r]=[n[0],n[Math.floor(e/4)]].map(u=>Fi(At(u,i))),o=s.clone().cross(r).normalize(),a=Math.max(...n.map(u=>$t(At(u,i)))),l=n.every(u=>Math.abs(Fi(At(u,i)).dot(o))<.02*a);if(!(a>1e-6&&o.length()>.5&&l))return null;let c=Hs(3.4*a,t);c.position.copy(Fi(i));let h=Math.abs(o.z)>.9?new N(0,1,0):new N(0,0,1);return c.quaternion.setFromRotationMatrix(new ie().lookAt(o,new N,h)),c}function zu(n,t,e){let i=n>1.2?.2:n>.4?.1:.05,s=new Sn({transparent:!0,depthWrite:!1,side:Ye,uniforms:{colour:{value:new Ut(t)},size:{value:n},step:{value:i},strength:{value:e}},vertexShader:`
      varying vec2 p; uniform float size;
      void main() {
        p = 2.0 * size * position.xy;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,fragmentShader:`
      varying vec2 p; uniform vec3 colour; uniform float size; uniform float step; uniform float strength;
      void main() {
        vec2 g = abs(fract(p / step - 0.5) - 0.5) / fwidth(p / step);
        float line = 1.0 - min(min(g.x, g.y), 1.0);
        gl_FragColor = vec4(colour, strength * line * smoothstep(1.0, 0.2, length(p) / size));
      }`});return Hs(2*n,s)}function Jl(n,t){return new $n({color:n,transparent:!0,opacity:t,depthWrite:!1,roughness:.7})}var xe=null,lo=null,ss=new Set;function Fb(){return xe||(xe=new Wl({antialias:!0,alpha:!0,powerPreference:"low-power"}),xe.setPixelRatio(1),xe.setScissorTest(!0),xe.shadowMap.enabled=!0,xe.shadowMap.type=Ji,xe.domElement.addEventListener("webglcontextlost",()=>ss.forEach(n=>n.onLost(!0))),xe.domElement.addEventListener("webglcontextrestored",()=>{ss.forEach(n=>{n.onLost(!1),n.request()})}),xe)}var Vu=()=>({...xe?.info.memory,calls:xe?.info.render.calls,programs:xe?.info.programs?.length,figures:ss.size}),Hu=()=>xe?.getContext().getExtension("WEBGL_lose_context"),co=new Set;function Kl(n){co.add(n),lo??=requestAnimationFrame(Wu)}var Ql=n=>co.delete(n);function Wu(){let n=[...co];co.clear();try{if(n.forEach(t=>t()),!xe||xe.getContext().isContextLost())return;for(let t of ss)t.dirty&&t.visible&&t.draw(xe)}finally{lo=co.size?requestAnimationFrame(Wu):null}}var Rm=typeof IntersectionObserver>"u"?null:new IntersectionObserver(n=>{for(let{target:t,isIntersecting:e}of n){let i=t.figure;i&&(i.visible=e,e&&i.request())}},{rootMargin:"200px"}),Ob=new N,Bb=new _t,Cm=new Hr,kb=new N(.687,-.639,.344),rs=class{constructor(t,{size:e=1,look:i=kb,turns:s=!0,onDraw:r=a=>{},onLost:o=a=>{}}={}){Fb(),this.host=t,this.size=e,this.look=i,this.onDraw=r,this.onLost=o,this.dirty=!0,this.visible=!0,this.abort=new AbortController,this.points=null,this.width=0,this.height=0,this.foot=()=>0,this.canvas=document.createElement("canvas"),this.canvas.figure=this,this.context=this.canvas.getContext("2d"),t.prepend(this.canvas),this.scene=new wr,this.camera=new Qe(32,1,.01,100),this.camera.up.set(0,0,1),this.controls=new Yl(this.camera,this.canvas),this.controls.addEventListener("change",()=>this.request()),this.controls.enableZoom=!1,this.controls.enablePan=!1,this.controls.enabled=s,this.canvas.style.touchAction="pan-y",this.listen(t,"focusin",()=>this.controls.enableZoom=!0),this.listen(t,"focusout",()=>this.controls.enableZoom=!1),this.lights(),ss.add(this),Rm?.observe(this.canvas),this.resizes=new ResizeObserver(()=>this.resize()),this.resizes.observe(t)}get signal(){return this.abort.signal}listen(t,e,i,s={}){t.addEventListener(e,i,{...s,signal:this.signal})}lights(){this.sky=new kr("#ffffff","#8d95a1",2),this.sky.position.set(0,0,1),this.sun=new Vr("#ffffff",2),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=5,this.sun.shadow.bias=-.002,this.scene.add(this.sky,this.sun,this.sun.target),this.resetLights()}resetLights({size:t=this.size,sky:e=2.1,sun:i=1.5}={}){this.size=t,this.sky.intensity=e,this.sun.intensity=i,this.sun.position.set(.55*t,-.75*t,2*t);let{camera:s}=this.sun.shadow;Object.assign(s,{left:-t,right:t,top:t,bottom:-t,near:.05*t,far:4*t}),s.updateProjectionMatrix()}request(){this.dirty=!0,lo??=requestAnimationFrame(Wu)}resize(){let{clientWidth:t,clientHeight:e}=this.host;if(Object.assign(this,{width:t,height:e}),!t||!e)return;let i=Math.min(devicePixelRatio,2),[s,r]=[Math.round(t*i),Math.round(e*i)];this.canvas.width===s&&this.canvas.height===r||(Object.assign(this.canvas,{width:s,height:r}),Object.assign(this.canvas.style,{width:`${t}px`,height:`${e}px`}),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.points&&Math.abs(this.fitted-this.camera.aspect)>.01&&this.fit(this.points),this.dirty=!0,xe&&!xe.getContext().isContextLost()&&this.draw(xe))}draw(t){let{width:e,height:i}=this.canvas;if(!e||!i||!this.width)return;let s=t.getSize(new _t);(e>s.x||i>s.y)&&t.setSize(Math.max(e,s.x),Math.max(i,s.y),!1),t.setViewport(0,0,e,i),t.setScissor(0,0,e,i),t.render(this.scene,this.camera),this.context.clearRect(0,0,e,i);let r=t.domElement.height-i;this.context.drawImage(t.domElement,0,r,e,i,0,0,e,i),this.dirty=!1,this.onDraw(this)}fit(t){this.points=t,this.fitted=this.height?this.camera.aspect:0;let{camera:e,controls:i,size:s}=this,r=Math.min(.3,this.foot()/(this.height||1/0)),o=t.map(a=>new N(...a));new Nn().setFromPoints(o).getCenter(i.target),e.position.copy(i.target).addScaledVector(this.look,3*s),Object.assign(e,{near:s/50,far:s*40}),e.updateProjectionMatrix();for(let a=0;a<4;a++){i.update(),e.updateMatrixWorld();let{min:l,max:c}=new Nn().setFromPoints(o.map(d=>d.clone().project(e))),h=e.position.clone().sub(i.target),u=Math.max(0,Math.min(r,(c.y-l.y)/2-1+2*r)),f=h.length()*Math.tan(e.fov*Math.PI/360),[p,g]=[0,1].map(d=>new N().setFromMatrixColumn(e.matrixWorld,d));i.target.addScaledVector(p,(l.x+c.x)/2*f*e.aspect),i.target.addScaledVector(g,((l.y+c.y)/2-u)*f);let[_,m]=[(c.x-l.x)/2/.81,(c.y-l.y)/2/Math.min(.81,.96-r)];h.multiplyScalar(Math.max(_,m)),e.position.copy(i.target).add(h)}i.update(),this.request()}orbit(t,e,i=1){let s=this.camera.position.clone().sub(this.controls.target),r=new Ii().setFromVector3(new N(s.y,s.z,s.x));r.theta+=t,r.phi=Math.min(3.1,Math.max(.05,r.phi+e)),r.radius*=i;let o=new N().setFromSpherical(r);this.camera.position.copy(this.controls.target).add(new N(o.z,o.x,o.y)),this.controls.update(),this.request()}pixel(t){let e=Ob.fromArray(t).project(this.camera);return[(e.x+1)*this.width/2,(1-e.y)*this.height/2]}place({clientX:t,clientY:e},i=this.canvas.getBoundingClientRect()){return[t-i.left,e-i.top]}ray([t,e]){return Cm.setFromCamera(Bb.set(2*t/this.width-1,1-2*e/this.height),this.camera),Cm}onFacingPlane(t,e){let i=this.camera.getWorldDirection(new N),s=new Ke().setFromNormalAndCoplanarPoint(i,new N(...e));return this.ray(t).ray.intersectPlane(s,new N)?.toArray()??null}dispose(){this.abort.abort(),Rm?.unobserve(this.canvas),this.resizes.disconnect(),this.controls.dispose(),ho(this.scene),this.sun.dispose(),this.sky.dispose(),this.canvas.figure=null,this.canvas.remove(),ss.delete(this),!(ss.size||!xe)&&(cancelAnimationFrame(lo),lo=null,xe.dispose(),xe.forceContextLoss(),xe=null)}};function ho(n){n.traverse(t=>{t.material?.dispose(),t.isInstancedMesh&&t.dispose(),t.geometry&&!Bu(t.geometry)&&t.geometry.dispose()}),n.removeFromParent()}var uo=n=>[...n.children].forEach(ho);var Im=n=>yt(n).map(t=>Tn(n.rows[t])),qu=(n,[t,e])=>Math.min(e,Math.max(t,n)),Lm=({x:n,y:t,z:e,o:i},s)=>Gt(i,Gt(Gt(Ct(s[0],n),Ct(s[1],t)),Ct(s[2],e))),Nm=({x:n,y:t,z:e,o:i},s)=>[n,t,e].map(r=>pe(r,At(s,i))),Dm=30,$u=1e-4;function Um(n,t,e){let[i,s]=[n(t),n(Gt(t,Ct($u,e)))];return{at:i,rate:[(s[0]-i[0])/$u,(s[1]-i[1])/$u]}}function Fm(n,t,{row:e,local:i,to:s,joint:r,pixel:o}){let a=yt(n)[r],l=n.rows[a].kind==="revolute",c=Tn(n.rows[a]),h=[...t];for(let u=0;u<4;u++){let f=qt(n,h),p=Lm(f[e+1],i),{z:g,o:_}=f[a],{at:m,rate:d}=Um(o,p,l?ve(g,At(p,_)):g),y=(d[0]*(s[0]-m[0])+d[1]*(s[1]-m[1]))/(d[0]**2+d[1]**2+Dm**2);h[r]+=Math.max(-.2,Math.min(.2,y))}return h[r]=qu(h[r],[Math.min(c[0],t[r]),Math.max(c[1],t[r])]),h}var Om=.3;function Pm(n,t,e){let i=At(t.o,n.o);if(!e)return i;let s=["x","y","z"].reduce((r,o)=>Gt(r,ve(n[o],t[o])),[0,0,0]);return[...i,...Ct(.5*Om,s)]}var zb=(n,t)=>n.map(e=>t?[...e.slice(0,3),...e.slice(3).map(i=>Om*i)]:e.slice(0,3)),tc=(n,t)=>n.reduce((e,i,s)=>e+i*t[s],0);function Yu(n,t,e,i,s={}){let{turns:r=!1,steps:o=12,budget:a=.12,weight:l=1e-4,nudge:c=.05}=s,h=Im(n),u=t.map((d,y)=>[Math.min(h[y][0],d),Math.max(h[y][1],d)]),f={arm:n,target:e,rest:i,turns:r,weight:l,limits:u},p=Bm(f,t,o);p.q.every((d,y)=>Math.abs(d-t[y])<1e-4)&&$t(At(e.o,p.frames.at(-1).o))>.002&&(p=Gb(f,p,c));let _=Math.max(1e-12,...p.q.map((d,y)=>Math.abs(d-t[y]))),m=Math.min(1,a/_);return{q:t.map((d,y)=>d+m*(p.q[y]-d)),arrived:m===1}}function Bm({arm:n,target:t,rest:e,turns:i,weight:s,limits:r},o,a){let l=(p,g)=>$t(Pm(p.at(-1),t,i))**2+s*g.reduce((_,m,d)=>_+(m-e[d])**2,0),[c,h]=[[...o],.001],u=qt(n,c),f=l(u,c);for(let p=0;p<a;p++){let g=Pm(u.at(-1),t,i),_=zb(ze(n,u),i),m=_.map((v,C)=>tc(v,g)-s*(c[C]-e[C])),d=[...c.keys()].filter(v=>!(c[v]<=r[v][0]&&m[v]<0)&&!(c[v]>=r[v][1]&&m[v]>0));if(!d.length)break;let y=d.map(v=>d.map(C=>tc(_[v],_[C])+(v===C?s+h:0))),w=Ro(y,d.map(v=>m[v])),M=[...c];d.forEach((v,C)=>M[v]=qu(c[v]+w[C],r[v]));let E=qt(n,M),T=l(E,M);if(T>=f){h*=6;continue}let x=f-T;if([c,u,f,h]=[M,E,T,Math.max(1e-5,h/4)],x<1e-10)break}return{q:c,frames:u,cost:f}}function Gb(n,t,e){let i=t;for(let s of t.q.keys())for(let r of[e,-e]){let o=t.q.map((l,c)=>c===s?qu(l+r,n.limits[s]):l),a=Bm(n,o,6);a.cost<.98*i.cost&&(i=a)}return i}function km(n,t,e){let i=qt(n,t),s=i.at(-1).o,r=At(e,s),o=$t(r),a=[];if(o<.002||!t.length)return{short:o,stops:a};let l=yt(n),c=ze(n,i).map(y=>y.slice(0,3)),h=l.map(y=>[n.rows[y].lower??-1/0,n.rows[y].upper??1/0]),u=c.map(y=>pe(y,r)/o),f=t.map((y,w)=>y<=h[w][0]+1e-6&&u[w]<-.001||y>=h[w][1]-1e-6&&u[w]>.001);f.forEach((y,w)=>y&&a.push(`joint ${l[w]+1} at its limit`));let p=Vb(n,t,i),{values:g,vectors:_}=rn(c.filter((y,w)=>!f[w]),3),d=_.filter((y,w)=>!(g[w]>.05*g[0])).reduce((y,w)=>y+(pe(w,r)/o)**2,0);return d>.5&&p?a.push(p):d>.5&&a.push("no joint moves the tip that way here"),{short:o,stops:a}}var zm=.1;function Gm(n,t=!1){let e=t?ei(n.map(o=>o.slice(3))).map(o=>o.reduce((a,l,c)=>Gt(a,Ct(l,n[c])),[0,0,0])):n.map(o=>o.slice(0,3));if(e.length<3)return[];let{values:i,vectors:s}=rn(e,3),r=i.map(o=>o/i[0]);return s.flatMap((o,a)=>r[a]<zm?[{way:o,share:r[a]}]:[])}var Vm=({share:n})=>1-n/zm;function Vb(n,t,e){let i=yt(n),s=e[i[1]??0].o,r=c=>$t(At(qt(n,c).at(-1).o,s)),o=r(t),[a,l]=[.01*Math.max(o,.1),null];return t.forEach((c,h)=>{if(h===0||n.rows[i[h]].kind!=="revolute")return;let[u,f]=[-.4,.4].map(g=>r(t.map((_,m)=>m===h?_+g:_))-o),p=Math.min(Math.abs(u),Math.abs(f));Math.sign(u)!==Math.sign(f)||p<a||([a,l]=[p,u<0?`joint ${i[h]+1} straight`:`joint ${i[h]+1} folded`])}),l}function Hm(n,t,{row:e,local:i,to:s,pixel:r},o,{turns:a=!0}={}){let l=Im(n),c=yt(n),h=t,u=0;for(let f=0;f<4;f++){let p=qt(n,h),g=ze(n,p),_=ei(g.map(I=>I.slice(0,a?6:3)));if(u=_.length,!u)break;let m=Lm(p[e+1],i),d=ze(n,p,m),y=_.map(I=>{let F=d.reduce((H,P,B)=>c[B]<=e?Gt(H,Ct(I[B],P)):H,[0,0,0]);return Um(r,m,F)}),w=At([...s,0],[...y[0].at,0]),M=y.map((I,F)=>y.map((H,P)=>tc(I.rate,H.rate)+(F===P?Dm**2:0))),E=Ro(M,y.map(({rate:I})=>tc(I,w.slice(0,2)))),T=Math.max(1e-12,...E.map(Math.abs)),x=Math.min(1,.12/T),v=h.map((I,F)=>I+_.reduce((H,P,B)=>H+x*E[B]*P[F],0)),C=a?An(n,v,o,{steps:12}).q:Yu(n,v,o,v,{weight:1e-9,budget:1}).q;if(!C.every((I,F)=>I>=Math.min(l[F][0],t[F])-1e-9&&I<=Math.max(l[F][1],t[F])+1e-9)||$t(At(qt(n,C).at(-1).o,o.o))>1e-4)break;h=C}return{q:h,free:u}}var Hb=22,Wm={mouse:11,touch:20,pen:16},Wb=4,Xb=0;function ju(n,t,{grip:e,goTo:i}){let{figure:s}=n,{canvas:r}=s,o=null,a=null,l=d=>{if(!n.handle?.visible)return!1;let[y,w]=s.pixel(n.handle.position.toArray());return Math.hypot(y-d[0],w-d[1])<Hb};function c(d){let y=s.place(d),{state:w,derived:M}=t;if(l(y))return{kind:"force"};let E=w.view==="branches"?n.wayAt(y):null;if(E!==null)return{kind:"way",way:E};let T=n.linkAt(y,Wm[d.pointerType]??Wm.touch,n.grips());if(!T)return null;if(w.hold?.pinned)return{kind:"elbow",...h(T,M.frames)};let x=qb(w.arm,M.frames,T,.02*n.size);return x===null?null:{kind:"link",lit:x,...h(T,M.frames)}}let h=({row:d,point:y},w)=>({row:d,local:Nm(w[d+1],y)});function u(d,y){let w=s.place(d),{state:M,derived:E}=t,T=E.frames.at(-1);o={...y,id:d.pointerId,box:null,to:w,gesture:`drag ${++Xb}`,rest:M.q,tip:T,point:T.o},y.kind==="tip"&&(o.from=s.onFacingPlane(w,T.o)),d.target.setPointerCapture(d.pointerId),t.dispatch({type:"show",dragging:!0,...y.lit===void 0?{}:{lit:y.lit}}),r.classList.add("held")}function f(){o&&!p[o.kind](t.state)&&Kl(f)}let p={force:()=>{let d=s.onFacingPlane(o.to,n.handle.position.toArray()),y=d&&[...n.forceFrom(d),...t.state.wrench.slice(3)];return y&&t.dispatch({type:"push",wrench:y,gesture:o.gesture}),!0},link:({arm:d,q:y})=>{let{row:w,local:M,to:E,lit:T}=o,x=yt(d).indexOf(T),v=Fm(d,y,{row:w,local:M,to:E,joint:x,pixel:C=>s.pixel(C)});return t.dispatch({type:"move",q:v,gesture:o.gesture}),!0},elbow:({arm:d,q:y,hold:w})=>{let{row:M,local:E,to:T}=o,x={row:M,local:E,to:T,pixel:R=>s.pixel(R)},{q:v,free:C}=Hm(d,y,x,w.pinned,{turns:w.turns});return t.dispatch({type:"move",q:v,hold:{...w,free:C},gesture:o.gesture}),!0},tip:d=>{let y=s.onFacingPlane(o.to,o.point);if(!y)return!0;let w=o.tip.o.map((M,E)=>M+y[E]-o.from[E]);return Zu(t,d,{...o.tip,o:w},o.rest,o.gesture)}},g=d=>{o&&d.pointerId===o.id?(o.box??=r.getBoundingClientRect(),o.to=s.place(d,o.box),Kl(f)):!o&&d.buttons===0&&d.target===r&&_(c(d))};function _(d){r.style.cursor=d?"pointer":"grab";let y=d?.kind==="link"?d.lit:null;t.state.lit!==y&&t.dispatch({type:"show",lit:y});let w=d?.kind==="way"?d.way:null;t.state.highlighted!==w&&t.dispatch({type:"show",highlighted:w})}function m(d){if(o&&d.pointerId!==o.id)return;if(a&&Math.hypot(d.clientX-a[0],d.clientY-a[1])<Wb&&a[2]?.kind==="way"&&i(t.state.ways.list[a[2].way].q),o){Ql(f)&&p[o.kind](t.state);let{hold:w}=t.state;t.dispatch({type:"show",dragging:!1,lit:null,hold:w?.pinned?w:null})}[o,a]=[null,null],r.classList.remove("held")}s.listen(r,"pointerdown",d=>{if(d.button)return;let y=c(d);a=[d.clientX,d.clientY,y],!(!y||y.kind==="way")&&(d.stopImmediatePropagation(),u(d,y))},{capture:!0}),s.listen(e,"pointerdown",d=>{d.button||u(d,{kind:"tip"})});for(let d of[r,e])s.listen(d,"pointermove",g),s.listen(d,"pointerup",m),s.listen(d,"pointercancel",m);s.listen(window,"scroll",()=>o&&(o.box=null),{capture:!0}),s.listen(r,"pointerleave",()=>o||_(null)),s.listen(r,"touchstart",d=>{let y=d.touches[0];d.touches.length===1&&c({...$b(y),pointerType:"touch"})&&d.preventDefault()},{passive:!1}),s.signal.addEventListener("abort",()=>Ql(f))}var $b=({clientX:n,clientY:t})=>({clientX:n,clientY:t});function qb(n,t,{row:e,point:i},s){let r=yt(n).filter(a=>a<=e),o=a=>{let{z:l,o:c}=t[a];return n.rows[a].kind==="prismatic"||$t(ve(l,At(i,c)))>s};return r.reverse().find(o)??null}function Zu(n,{arm:t,q:e,keepTurn:i},s,r,o){let{q:a,arrived:l}=Yu(t,e,s,r,{turns:i}),c=a.every((g,_)=>Math.abs(g-e[_])<1e-5),h=l||c,u=h?km(t,a,s.o):{stops:[],short:0},f=Gm(ze(t,qt(t,a)),i),p={kind:"tip",target:s.o,moving:!h,fading:f,...u};return n.dispatch({type:"move",q:a,hold:p,gesture:o}),h}function ec(n,t,e=null){let i=n.state.q,s={...n.derived.frames.at(-1),o:t};for(let r=0;r<60&&!Zu(n,n.state,s,i,e);r++);}var Yb={ArrowLeft:[-1,0,0],ArrowRight:[1,0,0],ArrowUp:[0,1,0],ArrowDown:[0,-1,0],PageUp:[0,0,-1],PageDown:[0,0,1]},jb=.01;function Ju(n,t,e){let i=Yb[e.key];if(!i)return!1;e.preventDefault(),e.stopPropagation();let s=jb*(e.shiftKey?.1:1),r=n.cameraAxes(),{o}=t.derived.frames.at(-1);return ec(t,o.map((a,l)=>a+s*i.reduce((c,h,u)=>c+h*r[u][l],0)),"tip keys"),!0}var td={};oe(td,{ask:()=>qm,latest:()=>po});var Xm=`(()=>{var F=(t,n)=>t[0]*n[0]+t[1]*n[1]+t[2]*n[2],b=(t,n)=>[t*n[0],t*n[1],t*n[2]],T=(t,n)=>[t[0]+n[0],t[1]+n[1],t[2]+n[2]],k=(t,n)=>[t[0]-n[0],t[1]-n[1],t[2]-n[2]],N=(t,n)=>[t[1]*n[2]-t[2]*n[1],t[2]*n[0]-t[0]*n[2],t[0]*n[1]-t[1]*n[0]],v=t=>Math.sqrt(t.reduce((n,s)=>n+s*s,0)),R=(t,n,s,o)=>[t*n[0]+s*o[0],t*n[1]+s*o[1],t*n[2]+s*o[2]];function V(t){let n=t/(Math.PI/2);return Math.abs(n-Math.round(n))>1e-12?[Math.cos(t),Math.sin(t)]:[[1,0],[0,1],[-1,0],[0,-1]][(Math.round(n)%4+4)%4]}var m=t=>t.rows.flatMap((n,s)=>n.kind==="fixed"?[]:[s]);function y(t,n){let[s,o,e,r]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],c=[{x:s,y:o,z:e,o:r}],i=0;for(let a of t.rows){let f=a.kind==="fixed"?0:n[i++],[u,l]=V(a.kind==="revolute"?a.theta+f:a.theta),[h,M]=V(a.alpha),w=a.kind==="prismatic"?a.d+f:a.d;[s,o]=[R(u,s,l,o),R(u,o,-l,s)],r=T(R(w,e,a.a,s),r),[o,e]=[R(h,o,M,e),R(h,e,-M,o)],c.push({x:s,y:o,z:e,o:r})}return c}function O(t,n,s=n.at(-1).o){return m(t).map(o=>{let{z:e,o:r}=n[o];return t.rows[o].kind==="revolute"?[...N(e,k(s,r)),...e]:[...e,0,0,0]})}var J=(t,n)=>Array.isArray(n)&&n.length===m(t).length&&n.every(Number.isFinite);function L(t){let n=t.kind==="revolute"?Math.PI:1;return[t.lower??-n,t.upper??n]}function z(t,n=6){let s=Array.from({length:n},(r,c)=>t.map(i=>i[c])),o=Array.from({length:n},(r,c)=>Array.from({length:n},(i,a)=>+(c===a)));for(let r=0,c=!0;c&&r<30;r++){c=!1;for(let i=0;i<n;i++)for(let a=i+1;a<n;a++)c=st(s,o,i,a)||c}let e=s.map((r,c)=>[Math.hypot(...r),c]).sort((r,c)=>c[0]-r[0]);return{values:e.map(([r])=>r),vectors:e.map(([,r])=>o[r])}}function st(t,n,s,o){let[e,r,c]=[0,0,0];for(let u=0;u<t[s].length;u++)e+=t[s][u]*t[s][u],r+=t[o][u]*t[o][u],c+=t[s][u]*t[o][u];if(Math.abs(c)<=1e-15*Math.sqrt(e*r)||c*c<1e-60)return!1;let i=(r-e)/(2*c),a=(i<0?-1:1)/(Math.abs(i)+Math.sqrt(1+i*i)),f=1/Math.sqrt(1+a*a);for(let u of[t,n])for(let l=0;l<u[s].length;l++){let[h,M]=[u[s][l],u[o][l]];u[s][l]=f*(h-a*M),u[o][l]=f*(a*h+M)}return!0}function q(t,n){let s=t.map((e,r)=>[...e,n[r]]),o=s.length;for(let e=0;e<o;e++){let r=rt(s,e,e);[s[r],s[e]]=[s[e],s[r]];for(let c=0;c<o;c++)c!==e&&at(s[c],s[e],e)}return s.map((e,r)=>e[o]/e[r])}function rt(t,n,s){let o=n;for(let e=n;e<t.length;e++)Math.abs(t[e][s])>Math.abs(t[o][s])&&(o=e);return o}function at(t,n,s){let o=t[s]/n[s];for(let e=0;e<t.length;e++)t[e]-=o*n[e]}function K(t,n=-1){let s=t.map((i,a)=>a).filter(i=>i!==n);if(!s.length)return[];let o=t[0].map((i,a)=>s.map(f=>t[f][a])),{values:e,vectors:r}=z(o,s.length),c=1e-5*Math.max(e[0],1e-12);return r.filter((i,a)=>e[a]<=c).map(i=>t.map((a,f)=>f===n?0:i[s.indexOf(f)]))}var C=t=>m(t).length<6?3:6;var it=t=>Math.max(0,m(t).length-C(t));function ut(t,n){let s=["x","y","z"].reduce((o,e)=>T(o,N(t[e],n[e])),[0,0,0]);return[...k(n.o,t.o),...b(.5,s)]}function E(t,n,s,{held:o=-1,steps:e=60}={}){let r=[...n],c=C(t);for(let i=0;;i++){let a=y(t,r),f=ut(a.at(-1),s).slice(0,c),u=v(f);if(u<1e-11||i===e||!r.length)return{q:r,error:u};let l=O(t,a).map((p,d)=>d===o?p.map(()=>0):p),h=.02*u*u+1e-12,M=f.map((p,d)=>f.map((I,$)=>l.reduce((j,P)=>j+P[d]*P[$],d===$?h:0))),w=q(M,f),x=l.map(p=>w.reduce((d,I,$)=>d+p[$]*I,0)),g=Math.max(1e-12,...x.map(Math.abs));r=r.map((p,d)=>p+x[d]*Math.min(1,.6/g))}}var ft={x:[[0,1,0],[0,0,1]],y:[[1,0,0],[0,0,1]],z:[[1,0,0],[0,1,0]]};function lt(t,{normal:n="x",radius:s=.1,count:o=181}={}){let[e,r]=ft[n],c=k(t,b(s,r));return Array.from({length:o},(i,a)=>{let f=2*Math.PI*a/(o-1);return T(c,T(b(s*Math.sin(f),e),b(s*Math.cos(f),r)))})}var U=.05;function ht(t,n,s,o){let e=E(t,n,s,o);if(e.error<1e-6)return e;let r=e.q.every((c,i)=>Math.abs(c-n[i])<1e-6);for(let c of r?n.keys():[])for(let i of[U,-U]){let a=E(t,n.map((f,u)=>u===c?f+i:f),s,o);a.error<.98*e.error&&(e=a)}return e}function Z(t,n,s={}){let o=y(t,n).at(-1),e=lt(o.o,s),r=[],[c,i]=[n,0];for(let a of e)c=ht(t,c,{...o,o:a},{steps:40}).q,i=Math.max(i,v(k(y(t,c).at(-1).o,a))),r.push(c);return{path:r,stray:i,wanted:e}}function pt(t){return()=>(t=Math.imul(t,1664525)+1013904223>>>0)/2**32}function dt(t,n=Math.random){return m(t).map(s=>{let[o,e]=L(t.rows[s]);return o+(e-o)*n()})}var gt=16;function tt(t,n,s=300){let o=y(t,n).at(-1),e=C(t)===6;if(!J(t,n)||!n.length)return{list:[],families:[],held:-1,target:o,whole:e};let r=it(t)?2:-1,c=pt(1),i=[],a=[],f=u=>{if(i.some(h=>xt(t,h,u))||a.some(h=>Y(t,h,u)<.001))return;let l=mt(t,u,o,r);a.push(u),l.length&&i.push({moving:l,q:u})};f(X(t,n));for(let u=0;u<s&&a.length<gt;u++){let l=dt(t,c).map((w,x)=>x===r?n[x]:w),{q:h,error:M}=E(t,l,o,{held:r});M<1e-9&&f(X(t,h))}return{list:a.map(u=>({q:u})),families:i,held:r,target:o,whole:e}}var Q=.1;function mt(t,n,s,o=-1){let e=C(t),r=O(t,y(t,n)).map((f,u)=>u===o?f.map(()=>0):f),{values:c}=z(r.map(f=>f.slice(0,e)),e),i=m(t).length-(o<0?0:1);if(c.filter(f=>f>1e-5*c[0]).length>=Math.min(e,i))return[];let a=new Set;for(let f of K(r.map(u=>u.slice(0,e)),o)){let u=E(t,n.map((l,h)=>l+Q*f[h]),s,{held:o,steps:200});u.error>1e-9||Y(t,u.q,n)<.3*Q||u.q.forEach((l,h)=>Math.abs(l-n[h])>.001&&a.add(h))}return[...a].sort((f,u)=>f-u)}var xt=(t,{moving:n,q:s},o)=>Y(t,s,o.map((e,r)=>n.includes(r)?s[r]:e))<.001;function X(t,n){return m(t).map((s,o)=>{if(t.rows[s].kind!=="revolute")return n[o];let[e,r]=L(t.rows[s]),c=Math.atan2(Math.sin(n[o]),Math.cos(n[o]));return[c,c+2*Math.PI,c-2*Math.PI].find(i=>i>=e&&i<=r)??c})}function Y(t,n,s){let o=(e,r)=>t.rows[e].kind==="revolute"?2*Math.sin((n[r]-s[r])/2):n[r]-s[r];return Math.max(...m(t).map((e,r)=>Math.abs(o(e,r))))}var Mt={method:"euler",rates:"inverse",steps:1e3,seconds:5,radius:.1,normal:"x",gain:0,cutoff:1e-9,damping:.02,locked:2,slip:""},nt={x:[0,1,0],y:[-1,0,0]},W=[0,0,1];function D(t,{radius:n,normal:s,seconds:o},e){let r=2*Math.PI*e,c=k(t,b(n,W)),[i,a]=[Math.sin(r),Math.cos(r)],f=2*Math.PI*n/o;return{o:T(c,T(b(n*i,nt[s]),b(n*a,W))),v:T(b(f*a,nt[s]),b(-f*i,W))}}function bt(t,n,s){if(s==="angular"){let e=m(t).map(r=>t.rows[r].kind==="revolute"?n[r+1].z:[0,0,0]);return O(t,n).map((r,c)=>[...r.slice(0,3),...e[c]])}if(s!=="z_i"&&s!=="o_i")return O(t,n);let o=n.at(-1).o;return m(t).map(e=>{let{z:r}=n[s==="z_i"?e+1:e],{o:c}=n[e+1];return t.rows[e].kind==="revolute"?[...N(r,k(o,c)),...r]:[...r,0,0,0]})}var B=class extends Error{};function yt(t,n,{rates:s,cutoff:o,damping:e,locked:r}){let c=t.map((l,h)=>h).filter(l=>l!==r),{values:i,vectors:a}=z(c.map(l=>t[l])),f=s==="pseudo"?o*i[0]:0;if(s==="inverse"&&i[Math.min(5,c.length-1)]<=1e-9*i[0])throw new B;let u=t.map(()=>0);return i.forEach((l,h)=>{if(l<=f||l<1e-14)return;let w=a[h].reduce((x,g,p)=>x+g*n[p],0)/(s==="damped"?l*l+e*e:l*l);for(let x of c)u[x]+=w*t[x].reduce((g,p,d)=>g+p*a[h][d],0)}),{found:u,least:i[Math.min(5,c.length-1)]}}function wt(t,n,s){let o=["x","y","z"].reduce((e,r)=>T(e,N(t[r],s[r])),[0,0,0]);return[...k(n,t.o),...b(.5,o)]}var $t=181;function G(t,n,s={}){let o={...Mt,...s};o.method==="exact"&&(o.rates="pseudo");let e=y(t,n).at(-1),r=o.seconds/o.steps,c=Math.max(1,Math.ceil(o.steps/($t-1))),i={path:[n],errors:[0],at:[0]},[a,f,u,l,h,M]=[[...n],1/0,0,0,null,0],w=(g,p)=>{let d=y(t,p),{o:I,v:$}=D(e.o,o,g),j=o.gain?wt(d.at(-1),I,e):[0,0,0,0,0,0],P=[...$,0,0,0].map((A,_)=>A+o.gain*j[_]),{found:S,least:H}=yt(bt(t,d,o.slip),P,o);return f=Math.min(f,H),o.slip==="sign"?S.map(A=>-A):S},x=(g,p,d)=>g.map((I,$)=>I+d*p[$]);for(let g=0;g<o.steps&&h===null;g++){let[p,d]=[g/o.steps,(g+1)/o.steps];try{let j=w(o.slip==="next"?d:p,a);if(l=Math.max(l,...j.map(Math.abs)),o.method==="exact")a=E(t,a,{...e,o:D(e.o,o,d).o},{held:o.locked,steps:40}).q;else if(o.method==="rk4"){let P=w(p+.5/o.steps,x(a,j,r/2)),S=w(p+.5/o.steps,x(a,P,r/2)),H=w(d,x(a,S,r));a=a.map((A,_)=>A+r/6*(j[_]+2*P[_]+2*S[_]+H[_]))}else a=x(a,j,r)}catch(j){if(!(j instanceof B))throw j;h=g;break}let I=y(t,a).at(-1),$=v(k(I.o,D(e.o,o,d).o));M=Math.max(M,Math.atan2(v(N(I.z,e.z)),F(I.z,e.z))),Number.isFinite($)||(h=g),u=Math.max(u,$),((g+1)%c===0||g+1===o.steps)&&(i.path.push(a),i.errors.push($),i.at.push(d))}return{...i,run:o,largest:u,least:f,fastest:l,failed:h,tilt:M,wound:a.map((g,p)=>t.rows[m(t)[p]].kind==="revolute"?(g-n[p])/(2*Math.PI):0)}}function ot(t,n,s={},o=kt(.1)){return o.map(e=>{let{wound:r,least:c,largest:i}=G(t,n,{...s,method:"exact",steps:90,radius:e}),a=r.reduce((f,u)=>Math.abs(u)>Math.abs(f)?u:f,0);return{radius:e,turns:Math.round(a),least:c,reached:i<1e-6}})}var kt=(t,n=37)=>Array.from({length:n},(s,o)=>.01+(t-.01)*o/(n-1));var et={ways:({arm:t,q:n})=>tt(t,n),circle:({arm:t,q:n,circle:s})=>Z(t,n,s),run:({arm:t,q:n,run:s})=>G(t,n,s),winding:({arm:t,q:n,run:s})=>ot(t,n,s)};onmessage=({data:{id:t,job:n,given:s}})=>postMessage({id:t,answer:et[n](s)});})();
`;var Qu={ways:({arm:n,q:t})=>Vc(n,t),circle:({arm:n,q:t,circle:e})=>Gc(n,t,e),run:({arm:n,q:t,run:e})=>zo(n,t,e),winding:({arm:n,q:t,run:e})=>qc(n,t,e)};var Oi=null,$m=0,fo=new Map;function Jb(){let n=URL.createObjectURL(new Blob([Xm],{type:"text/javascript"}));Oi=new Worker(n),URL.revokeObjectURL(n),Oi.onmessage=({data:{id:t,answer:e}})=>{fo.get(t)?.done(e),fo.delete(t)},Oi.onerror=()=>{Oi=!1;for(let{job:t,given:e,done:i}of fo.values())i(Qu[t](e));fo.clear()}}function qm(n,t){if(Oi===null)try{Jb()}catch{Oi=!1}return Oi?new Promise(e=>{fo.set(++$m,{job:n,given:t,done:e}),Oi.postMessage({id:$m,job:n,given:t})}):Promise.resolve().then(()=>Qu[n](t))}function po(n){let t=0;return async(e,i)=>{let s=++t,r=await qm(n,e);s===t&&i(r)}}var nd={};oe(nd,{relativeRail:()=>ed});function ed(n,t,{start:e=()=>{},put:i,signal:s}){let r=null,o=()=>Number(t.max)-Number(t.min),a=u=>Math.min(Number(t.max),Math.max(Number(t.min),u)),l=()=>Math.max(1,n.clientWidth-16),c=u=>{e(),Object.assign(r,{on:!0,x:u.clientX}),n.setPointerCapture(u.pointerId)},h=(u,f)=>n.addEventListener(u,f,{signal:s});h("pointerdown",u=>{if(u.button||r||(r={id:u.pointerId,x:u.clientX,from:Number(t.value),on:!1},t.focus({preventScroll:!0}),u.pointerType!=="mouse"))return;u.preventDefault(),c(u);let f=(u.clientX-n.getBoundingClientRect().left-8)/l(),p=(r.from-Number(t.min))/o();Math.abs(f-p)*l()<11||(r.from=a(Number(t.min)+f*o()),i(r.from))}),h("pointermove",u=>{u.pointerId===r?.id&&(!r.on&&Math.abs(u.clientX-r.x)<6||(r.on||c(u),i(a(r.from+o()*(u.clientX-r.x)/l()))))}),h("pointerup",()=>r=null),h("pointercancel",()=>{r?.on&&i(r.from),r=null})}var hd={};oe(hd,{ArmPicture:()=>_o,LOOK:()=>Qm,branchColour:()=>xo});var Ym=[22,15],Kb=[[0,0],[0,-14],[0,14],[16,0],[-16,0],[14,-13],[-14,13],[14,13],[-14,-13],[0,-26],[0,26]],nc=class{#t=[];#e=[];#n=[];constructor(t){this.host=t,this.tags=[]}set(t){for(this.tags=t;this.#t.length<t.length;){let e=document.createElement("span");e.append(document.createElement("i"),document.createElement("sub")),this.#t.push(e),this.host.append(e)}this.#t.forEach((e,i)=>{let s=t[i];if(!s)return e.hidden=!0;e.hidden=!1;let r=`axis-${s.tone??s.letter}`,o=`${r}|${s.letter}|${s.index}`;this.#e[i]!==o&&(this.#e[i]=o,e.className=r,[e.children[0].textContent,e.children[1].textContent]=[s.letter,s.index])})}place(t,e,i){let s=[];this.tags.forEach(({tip:r,index:o},a)=>{let[l,c]=t(r),h=[Ym[0]+4*Math.max(0,o.length-1),Ym[1]],u=([m,d])=>s.every(([y,w,M])=>Math.abs(y-l-m)>(h[0]+M)/2||Math.abs(w-c-d)>h[1]),p=l>-20&&c>-20&&l<e+20&&c<i+20?Kb.find(u):null,[g,_]=p?[l+p[0],c+p[1]]:[];p&&s.push([g,_,h[0]]),this.#i(a,p?`translate(${g.toFixed(1)}px, ${_.toFixed(1)}px) translate(-50%, -50%)`:null)})}#i(t,e){let i=this.#n[t];if(i===e)return;this.#n[t]=e;let{style:s}=this.#t[t];(!i||!e)&&(s.visibility=e?"visible":"hidden"),e&&(s.transform=e)}dispose(){this.host.replaceChildren(),[this.#t,this.#e,this.#n,this.tags]=[[],[],[],[]]}};var ad={};oe(ad,{DROPS:()=>Zm,EMPTY:()=>rd,Store:()=>Ws,derive:()=>mo,leftBehind:()=>go,startingState:()=>od,transition:()=>Jm});var Zm={arm:["trace","stray","wanted","at","playing","paths","ways","highlighted","lit","hold","mark"],circle:["trace","stray","wanted","at","playing"],trace:["stray","wanted","at","playing"],ways:["highlighted"],view:["playing","highlighted","lit"]},rd={trace:null,stray:0,wanted:null,paths:null,at:0,playing:!1,ways:null,highlighted:null,lit:null,hold:null,mark:null},id=["arm","base","reference","q","wrench"],Qb=200,tS={select:(n,{arm:t,q:e,reference:i=t})=>nS(n,t,e,i),edit:(n,{rows:t,q:e,rowBefore:i})=>iS(n,t,e,i),move:(n,{q:t,hold:e=null})=>Je(n.arm,t)?{q:t,hold:e,playing:!1}:null,glide:(n,{q:t})=>Je(n.arm,t)?{q:t}:null,play:(n,{at:t})=>sS(n,t),playing:(n,{on:t})=>t&&!n.trace?null:{playing:t},push:(n,{wrench:t})=>t.length===6&&t.every(Number.isFinite)?{wrench:t}:null,circle:(n,{type:t,...e})=>({circle:{...n.circle,...e}}),traced:(n,{arm:t,circle:e,path:i,stray:s,wanted:r})=>t===n.arm&&e===n.circle?{trace:i,stray:s,wanted:r,at:0,q:i[0]}:null,ways:(n,{arm:t,ways:e})=>t===n.arm?{ways:e}:null,show:(n,{type:t,...e})=>e,set:(n,{type:t,...e})=>Je(e.arm??n.arm,e.q??n.q)?e:null,undo:n=>jm(n,"past","future"),redo:n=>jm(n,"future","past")};function Jm(n,t){let e=tS[t.type](n,t);if(!e)return n;let i=Object.keys(e).filter(o=>e[o]!==n[o]);if(!i.length)return n;let s=i.flatMap(o=>Zm[o]??[]).filter(o=>!(o in e)),r={...n,...Object.fromEntries(s.map(o=>[o,rd[o]])),...e};return eS(n,r,t)}function eS(n,t,{type:e,gesture:i=null}){if(["undo","redo","play"].includes(e)||id.every(r=>n[r]===t[r]))return t;if(i!==null&&n.past.at(-1)?.gesture===i)return t.future=[],t;let s={gesture:i,...Object.fromEntries(id.map(r=>[r,n[r]]))};return{...t,past:[...n.past,s].slice(-Qb),future:[]}}function jm(n,t,e){let i=n[t].at(-1);if(!i)return null;let{gesture:s,...r}=i,o={gesture:null,...Object.fromEntries(id.map(a=>[a,n[a]]))};return{...r,playing:!1,[t]:n[t].slice(0,-1),[e]:[...n[e],o]}}function nS(n,t,e,i){return{arm:t,base:t,reference:i,q:Je(t,e)?e:Vi(t)}}function iS(n,t,e,i=s=>s){if(Ks(t))return null;let{rows:s}=n.arm;if(t.length===s.length&&t.every((o,a)=>To(o,s[a])))return null;let r=Qs(t,n.base);return{arm:r,q:Je(r,e)?e:Ao(n.arm,n.q,r,i)}}function sS({trace:n,arm:t},e){if(!n||!n.every(r=>r.length===n[0].length)||!Je(t,n[0]))return null;let i=Math.min(n.length-2,Math.floor(e*(n.length-1))),s=e*(n.length-1)-i;return{at:e,q:n[i].map((r,o)=>r+s*(n[i+1][o]-r))}}var od=n=>({base:n.arm,reference:n.arm,wrench:[0,0,0,0,0,0],unit:"deg",view:"pose",frames:"ends",circle:{normal:"x",radius:.1},keepTurn:!1,dragging:!1,runs:[],past:[],future:[],...rd,...n}),sd=class{#t=new Map;constructor(t,e,i){this.arm=t,this.q=e,this.wrench=i}#e(t,e){return this.#t.has(t)||this.#t.set(t,e()),this.#t.get(t)}get frames(){return this.#e("frames",()=>qt(this.arm,this.q))}get columns(){return this.#e("columns",()=>ze(this.arm,this.frames))}get task(){return this.#e("task",()=>rn(this.columns.map(t=>t.slice(0,Re(this.arm))),Re(this.arm)))}get linear(){return this.#e("linear",()=>rn(this.columns.map(t=>t.slice(0,3)),3))}get values(){return this.task.values}get rank(){return Oc(this.values)}get lost(){return this.#e("lost",()=>wc(this.task.vectors.slice(this.rank).map(t=>[...t,0,0,0].slice(0,6))))}get determinant(){let t=Re(this.arm);return this.#e("determinant",()=>bc(this.columns.map(e=>e.slice(0,t))))}get manipulability(){let{values:t,columns:e}=this;return t.slice(0,Math.min(t.length,e.length)).reduce((i,s)=>i*s,1)}get gravity(){return this.#e("gravity",()=>qs(this.arm,this.frames))}get energy(){return _c(this.arm,this.frames)}get push(){return this.#e("push",()=>Ys(this.columns,this.wrench))}get torque(){return this.gravity.map((t,e)=>t-this.push[e])}},mo=(n,t,e=[0,0,0,0,0,0])=>new sd(n,t,e);function go({ways:n},{frames:t}){if(!n)return null;let{x:e,y:i,z:s,o:r}=t.at(-1),o=$t(At(r,n.target.o)),a=n.whole?Math.max(...Object.entries({x:e,y:i,z:s}).map(([l,c])=>$t(At(c,n.target[l])))):0;return o>5e-4||a>.002?{far:o,turned:a}:null}var Ws=class{#t=new Set;constructor(t){this.state=t,this.derived=mo(t.arm,t.q,t.wrench)}dispatch(t,e="reader"){let i=this.state,s=Jm(i,t);if(s===i)return!1;let r=new Set(Object.keys(s).filter(o=>s[o]!==i[o]));this.state=s,["arm","q","wrench"].some(o=>r.has(o))&&(this.derived=mo(s.arm,s.q,s.wrench));for(let o of[...this.#t])o(r,e);return!0}listen(t,e){this.#t.add(t),e?.addEventListener("abort",()=>this.#t.delete(t),{once:!0})}};var Qm={light:{lit:"#E69F00",link:"#e9edf2",joint:"#34506b",grid:"#8793a3",gridStrength:.34,shadow:.16,sky:2.1,sun:1.5,path:"#D55E00",wanted:"#7a8290",force:"#C77E00",ghost:"#0072B2",ellipsoid:"#9a4f86",bad:"#c0392b"},dark:{lit:"#F0B429",link:"#c3ccd8",joint:"#5f86ad",grid:"#93a1b5",gridStrength:.26,shadow:.28,sky:1.15,sun:1.7,path:"#F58A3C",wanted:"#a3adba",force:"#F0B429",ghost:"#56B4E9",ellipsoid:"#d79bc3",bad:"#ff8a6b"}},Km=["#0072B2","#D55E00","#009E73","#E69F00","#CC79A7","#56B4E9","#882255","#7a8290"],xo=n=>Km[n%Km.length],ld=10,cd=.36,_o=class{constructor(t,e,i={}){this.figure=new rs(t,{onDraw:()=>this.place(),onLost:i.onLost}),this.labels=new nc(e),this.onPlace=i.onPlace??(()=>{}),this.world=null,this.arm=null,this.frames=null,this.drawn=[],this.first=i.first??0,this.shown={}}build(t,e){let i=Qm[e?"dark":"light"];this.emptyWorld(),this.arm=t,this.dark=e,this.look=i,this.size=tr(t),this.world=new Ee,this.shown={};let{size:s}=this;this.figure.scene.add(this.world);let r=new $n({color:i.link,roughness:.45,metalness:.02}),o=new $n({roughness:.4,metalness:.1});this.body=new is(t,{link:r,joint:o,hue:new Ut(i.joint)}),this.tints={lit:new Ut(i.lit),bad:new Ut(i.bad)},this.axis=Zl(new Ve({color:i.lit,transparent:!0,opacity:.75})),this.shade=Hs(4*s,new Fr({opacity:i.shadow})),this.shade.receiveShadow=!0,this.shade.position.z=-.001*s,this.triads=new io(e,t.rows.length+1),this.ellipsoid=new so(i.ellipsoid);let a=new Ve({color:i.force});this.force=new Vs(a),this.handle=oo(a),this.handle.scale.setScalar(.022*s),this.spot=oo(new Ve({color:i.bad})),this.spot.scale.setScalar(.014*s),this.fading=new Ee;let l=new Ve({color:i.bad});for(let c=0;c<6;c++)this.fading.add(new Vs(l));this.barrier=this.makeBarrier(),this.path=new Ee,this.ghosts=new Ee,this.reference=new Ee,this.world.add(this.body,zu(s,i.grid,i.gridStrength),this.shade,this.triads,this.axis,this.ellipsoid,this.force,this.handle,this.spot,this.fading,this.barrier,this.path,this.ghosts,this.reference),this.figure.resetLights({size:s,sky:i.sky,sun:i.sun})}emptyWorld(){this.world&&ho(this.world)}makeBarrier(){let t=new Ee,e=new Ve({color:this.look.bad,transparent:!0,opacity:.3,side:Ye,depthWrite:!1}),i=new Ve({color:this.look.bad}),[s,r,o]=[Hs(.16*this.size,e),Zl(i),oo(i)];return o.scale.setScalar(.01*this.size),Object.assign(t,{wallPart:s,way:r,spot:o}),t.add(s,r,o),t.visible=!1,t}draw(t,e,i){let s=i==="dark",r=!this.body;(this.arm!==t.arm||this.dark!==s)&&this.build(t.arm,s);let{frames:a}=e;this.frames=a,this.body.pose(a),this.tintJoints(t),this.drawAxis(a[t.lit]),this.drawFrames(a,t.frames),this.ellipsoid.visible=t.view==="jacobian",this.ellipsoid.visible&&(this.scale=.15*this.size/Math.max(e.linear.values[0],1e-6),this.ellipsoid.pose(a.at(-1).o,e.linear,this.scale,.003*this.size)),this.drawForce(a.at(-1).o,t),this.drawPath(t),this.drawGhosts(t,e),this.drawReference(t),this.drawBarrier(a.at(-1).o,t.hold),this.drawFading(a.at(-1).o,t.hold?.fading??[]),this.drawMark(t.mark),r&&this.fit(),this.figure.request()}tintJoints({lit:t,q:e,arm:i}){let s=yt(i).filter((o,a)=>ti(i.rows[o],e[a])),r=[t,...s].join();this.shown.tinted!==r&&(this.shown.tinted=r,this.body.tint(o=>o===t?this.tints.lit:s.includes(o)?this.tints.bad:null))}drawAxis(t){let e=t?Ct(.16*this.size,t.z):[0,0,0],[i,s]=t?[At(t.o,e),Gt(t.o,e)]:[e,e];Gs(this.axis,i,s,.0025*this.size)}drawFrames(t,e){let i=.1*this.size,s=new Map;this.drawn=t.map((r,o)=>e==="all"||o===0||o===t.length-1),this.triads.pose(t,i,this.drawn),t.forEach((r,o)=>{if(this.drawn[o])for(let a of["x","z"]){let l=Gt(r.o,Ct(1.22*i,r[a])),c=a+l.map(u=>Math.round(u/this.size*500)).join(),h=[...s.get(c)?.indices??[],o+this.first];s.set(c,{tip:l,root:r.o,letter:a,index:h.join(",")})}}),this.labels.set([...s.values()].reverse())}drawForce(t,{view:e,wrench:i}){let s=i.slice(0,3),r=e==="torque",o=$t(s),a=o?Ct(cd*this.size/(o+ld),s):[0,0,0];this.force.point(At(t,a),a,.007*this.size),this.force.visible&&=r,this.handle.visible=r,this.handle.position.fromArray(At(t,a)),this.tip=t,r&&!this.shown.force&&this.fit(),this.shown.force=r}forceFrom(t){let e=At(this.tip,t),i=Math.min($t(e),cd*this.size*(100/(100+ld)));if(i<.015*this.size)return[0,0,0];let s=ld*i/(cd*this.size-i);return Ct(s/$t(e),e)}drawPath({view:t,trace:e,wanted:i,stray:s,arm:r,paths:o}){let a=["trace","torque","homework"].includes(t)?e:null,l=t==="homework"?o:null;if(this.shown.path===a&&this.shown.paths===l||(Object.assign(this.shown,{path:a,paths:l}),uo(this.path),!a&&!l))return;let c=a?.map(p=>qt(r,p).at(-1).o)??l[0]?.points??[],h=(l??[]).map(p=>ao(p.points,.003*this.size,p.colour));l||h.push(ao(c,.0035*this.size,this.look.path)),i&&s>.001&&h.push(ao(i,.0018*this.size,this.look.wanted));let u=this.dark?.16:.1,f=new Ve({color:this.look.ghost,transparent:!0,opacity:u,side:Ye,depthWrite:!1});c.length>2&&h.push(ku(i??c,f));for(let p of h.filter(Boolean))this.path.add(p)}drawGhosts(t,e){let{view:i,ways:s,arm:r,q:o,highlighted:a}=t,l=i==="branches"&&s&&!(go(t,e)&&a===null)?s:null;this.shown.ways!==l&&(uo(this.ghosts),(l?.list??[]).forEach((c,h)=>{let u=new $n({color:xo(h),roughness:.7}),f=Jl(xo(h),.45),p=qt(r,c.q);for(let{material:g,girth:_}of[{material:u,girth:.3},{material:f,girth:.97}]){let m=new is(r,{link:g,joint:g,ghost:!0,girth:_});m.pose(p),m.userData={way:h,full:_>.5},this.ghosts.add(m)}}),this.shown.ways=l,l&&!this.shown.fitted&&this.fit(),this.shown.fitted=!!l);for(let c of this.ghosts.children){let{way:h,full:u}=c.userData;c.visible=!rr(l.list[h].q,o)&&(!u||h===a)}}drawReference({view:t,reference:e,q:i,arm:s}){let o=t==="table"&&e&&e!==s&&yt(e).length===i.length?e:null;if(this.shown.reference!==o&&(uo(this.reference),this.shown.reference=o,o)){let a=Jl(this.look.ghost,.26);this.reference.add(new is(o,{link:a,joint:a,ghost:!0}))}o&&this.reference.children[0].pose(qt(o,i))}drawFading(t,e){this.fading.children.forEach((i,s)=>{let r=e[Math.floor(s/2)],o=s%2?-this.size:this.size,a=r?Ct(o*(.04+.1*Vm(r)),r.way):[0,0,0];i.point(r?Gt(t,Ct(.03*o,r.way)):t,a,.004*this.size)})}drawMark(t){this.spot.visible=!!t,this.shown.mark!==t&&(this.shown.mark=t,t&&this.spot.position.fromArray(t),t&&this.fit())}drawBarrier(t,e){let i=e?.target?$t(At(e.target,t)):0,{barrier:s}=this;if(s.visible=i>.004*this.size&&!e.moving,!s.visible)return;let r=new N(...At(e.target,t)).normalize();Gs(s.way,t,e.target,.002*this.size),s.spot.position.set(...e.target),s.wallPart.position.set(...Gt(t,Ct(.006*this.size,r.toArray()))),s.wallPart.quaternion.setFromUnitVectors(new N(0,0,1),r)}fit(){let t=.13*this.size,e=this.frames.flatMap(({x:r,z:o,o:a})=>[a,...[r,o].map(l=>Gt(a,Ct(t,l)))]),i=(this.shown.ways?.list??[]).flatMap(({q:r})=>qt(this.arm,r).map(o=>o.o)),s=[this.handle,this.spot].filter(r=>r.visible).map(r=>r.position.toArray());this.figure.fit([...e,...i,...s,[0,0,0],[0,0,.3*this.size]])}cameraAxes(){return[0,1,2].map(t=>new N().setFromMatrixColumn(this.figure.camera.matrixWorld,t).toArray())}place(){let{width:t,height:e}=this.figure;this.labels.place(i=>this.figure.pixel(i),t,e),this.frames&&this.onPlace(this.figure.pixel(this.frames.at(-1).o))}grips(){return[...this.frames.flatMap(({o:e,x:i},s)=>{if(!this.drawn[s]||s===0)return[];let[r,o]=[.05,.1].map(a=>Gt(e,Ct(a*this.size,i)));return[{row:s-1,from:r,to:o}]}),...this.pieces()]}pieces(t=this.arm,e=this.frames){return t.rows.flatMap((i,s)=>{let[r,o]=[e[s].o,e[s+1].o],a=At(o,Ct(i.a,e[s+1].x));return[{row:s,from:r,to:a},{row:s,from:a,to:o}]})}linkAt(t,e=14,i=this.pieces()){let s=null;for(let{row:r,from:o,to:a}of i){let[l,c]=[this.figure.pixel(o),this.figure.pixel(a)],[h,u]=[c[0]-l[0],c[1]-l[1]],f=h*h+u*u,p=f<1?1:Math.min(1,Math.max(0,((t[0]-l[0])*h+(t[1]-l[1])*u)/f)),g=Math.hypot(l[0]+p*h-t[0],l[1]+p*u-t[1]);g>e||s&&g>=s.gap-.5||(s={row:r,gap:g,point:Gt(o,Ct(p,At(a,o)))})}return s}wayAt(t){let s=(this.ghosts?.children.filter(r=>r.visible&&!r.userData.full)??[]).map(r=>{let{way:o}=r.userData,a=qt(this.arm,this.shown.ways.list[o].q);return{way:o,gap:this.linkAt(t,7,this.pieces(this.arm,a))?.gap??1/0}}).sort((r,o)=>r.gap-o.gap)[0];return s&&s.gap<1/0?s.way:null}dispose(){this.labels.dispose(),this.emptyWorld(),this.figure.dispose()}};var pd={};oe(pd,{poseText:()=>fd,stillShapes:()=>ig,stillSvg:()=>dd});var[ic,ud,tg]=[480,320,36],rS=[.6816,.7317,0],oS=[-.2514,.2342,.9391],aS={x:"#D55E00",y:"#009E73",z:"#0072B2"},eg=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],ng=n=>[eg(rS,n),-eg(oS,n)];function lS(n,t){let e=n.rows.flatMap((i,s)=>[At(t[s+1].o,Ct(i.a,t[s+1].x)),t[s+1].o]);return[t[0].o,...e]}function ig(n,t){let e=lS(n,t),i=[0,1,2].map(_=>Math.max(...e.map(m=>m[_]))-Math.min(...e.map(m=>m[_]))),s=.12*Math.max(...i),o=[t[0],t.at(-1)].flatMap(_=>["x","y","z"].map(m=>({n:m,o:_.o,tip:Gt(_.o,Ct(s,_[m]))}))),a=e.map(([_,m])=>[_,m,0]),l=[...e,...a,...o.map(({tip:_})=>_)].map(ng),[c,h]=[Math.min,Math.max].map(_=>[0,1].map(m=>_(...l.map(d=>d[m])))),u=[ic-2*tg,ud-2*tg],f=Math.min(...u.map((_,m)=>_/Math.max(h[m]-c[m],1e-9))),p=[ic,ud].map((_,m)=>_/2-f*(c[m]+h[m])/2),g=_=>ng(_).map((m,d)=>Math.round(10*(f*m+p[d]))/10+0);return{shadow:a.map(g),links:e.map(g),spots:t.slice(0,-1).map(({o:_})=>g(_)),axes:o.map(({n:_,o:m,tip:d})=>({n:_,from:g(m),to:g(d)}))}}function dd(n,t,e){let{shadow:i,links:s,spots:r,axes:o}=ig(n,t),a=(h,u)=>`<polyline points="${h.join(" ")}" fill="none" stroke="currentColor" stroke-width="8" stroke-linejoin="round" stroke-linecap="round" stroke-opacity="${u}"/>`,l=[a(i,.12),a(s,.5),...r.map(([h,u])=>`<circle cx="${h}" cy="${u}" r="7" fill="currentColor"/>`),...o.map(({n:h,from:u,to:f})=>`<line x1="${u[0]}" y1="${u[1]}" x2="${f[0]}" y2="${f[1]}" stroke="${aS[h]}" stroke-width="3"/>`)],c=new DOMParser().parseFromString(`<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${ic} ${ud}" width="${ic}" style="max-width:100%;height:auto" role="img">${l.join("")}</svg>`,"image/svg+xml").documentElement;return c.setAttribute("aria-label",e),document.importNode(c,!0)}var fd=(n,t)=>{let e=n.rows.flatMap((s,r)=>s.kind==="fixed"?[]:[r+1]),i=t.map((s,r)=>`q_${e[r]} = ${Number(s.toFixed(3))+0}`);return`${n.name} at ${i.join(", ")}.`};var gd={};oe(gd,{watchTheme:()=>md});var sg=typeof matchMedia>"u"?null:matchMedia("(prefers-color-scheme: dark)");function cS(){let{dataset:n}=document.documentElement;if(n.theme)return n.theme==="dark"?"dark":"light";let t=document.body.dataset.jpThemeLight;if(t)return t==="true"?"light":"dark";let{classList:e}=document.body;return e.contains("vscode-dark")||e.contains("vscode-high-contrast")?"dark":e.contains("vscode-light")||!sg?.matches?"light":"dark"}function md(n,t){let e,i=()=>{let r=cS();r!==e&&n(e=r)},s=new MutationObserver(i);s.observe(document.documentElement,{attributes:!0,attributeFilter:["data-theme"]}),s.observe(document.body,{attributes:!0,attributeFilter:["class","data-jp-theme-light"]}),sg?.addEventListener("change",i,{signal:t}),t.addEventListener("abort",()=>s.disconnect()),i()}var _d={};oe(_d,{makePlots:()=>xd});var[yo,vo]=[220,54];function xd(){let n=U("div.plots"),t=[];function e({arm:r,unit:o},a,l){t=[];let c=h=>a.map(u=>u[h]);n.replaceChildren(...yt(r).map((h,u)=>i(r.rows[h],h,c(u),l,o)))}function i(r,o,a,l,c){let h=P=>l?`${Kt(P,2)} ${r.kind==="revolute"?"N m":"N"}`:_i(r,P,c),u=r.effort??1/0,[f,p]=l?[-u,u]:[r.lower??-1/0,r.upper??1/0],[g,_]=[Math.min(...a),Math.max(...a)],m=l?.5:Vn(r)?.1:.02,d=(g+_)/2,y=Math.max((_-g)/2,m)*1.15,w=P=>vo*(.5-(P-d)/(2*y)),M=a.map((P,B)=>`${(B*yo/(a.length-1)).toFixed(1)},${w(P).toFixed(1)}`),E=(P,B)=>{let V=Math.max(0,P);return ii("rect",{x:0,width:yo,y:V,height:Math.max(0,Math.min(vo,B)-V),class:"beyond"})},T=ii("line",{y1:0,y2:vo,x1:0,x2:0,class:"cursor"}),x=[...p<1/0?[E(-1,w(p))]:[],...f>-1/0?[E(w(f),vo)]:[]],v={viewBox:`0 0 ${yo} ${vo}`,preserveAspectRatio:"none","aria-hidden":"true"},C=ii("svg",v,...x,ii("polyline",{points:M.join(" ")}),T),R=U("span.now");t.push({line:T,value:R,at:P=>h(a[Math.round(P*(a.length-1))])});let I=a.some(P=>P<f-1e-9||P>p+1e-9),F=U("b",{},Xe(l?"τ":"q",o+1)),H=U("figcaption",{},F,R,U("span.span",{},`${h(g)} … ${h(_)}`));return U(I?"figure.past":"figure",{},H,C)}function s(r){for(let{line:o,value:a,at:l}of t)me(o,"x1",String(r*yo)),me(o,"x2",String(r*yo)),ae(a,l(r))}return{root:n,lay:e,mark:s,clear:()=>(t=[],n.replaceChildren())}}var vd={};oe(vd,{makeTransport:()=>yd});var hS=8;function yd(n,{signal:t,begin:e}){let i=U("button.main",{type:"button",onclick:u},"Play"),s=U("input",{type:"range",min:0,max:1e3,value:0,"aria-label":"Place along the path",oninput:g=>h(g.target.value/1e3)}),r=U("output.place"),o=U("div.row.transport",{},i,s,r),a=null,l=0;t.addEventListener("abort",()=>cancelAnimationFrame(a));let c=()=>n.dispatch({type:"playing",on:!0});function h(g){n.dispatch({type:"playing",on:!1}),n.dispatch({type:"play",at:g})}function u(){let{trace:g,playing:_,at:m}=n.state;return _?n.dispatch({type:"playing",on:!1}):g?(m>=1&&n.dispatch({type:"play",at:0}),c()):e(c)}function f(g){a=null;let{playing:_,at:m}=n.state;if(!_||!o.isConnected)return;let d=1e3*hS*(lr()?2:1),y=Math.min(1,m+Math.max(0,Math.min(100,g-l))/d);l=g,a=requestAnimationFrame(f),n.dispatch({type:"play",at:y}),y===1&&n.dispatch({type:"playing",on:!1})}function p({playing:g,trace:_,at:m}){ae(i,g?"Pause":"Play"),s.disabled=!_,s.value=String(Math.round(1e3*m)),s.style.setProperty("--high",`${(100*m).toFixed(1)}%`),me(s,"aria-valuetext",`${Math.round(100*m)} percent`),ae(r,`${Math.round(100*m)} %`),!(!g||a)&&(l=performance.now(),a=requestAnimationFrame(f))}return{root:o,update:p}}var rg={"judge/geometry/arm.js":Mc,"judge/geometry/kinematics.js":js,"judge/geometry/linear.js":Ac,"page/src/common.js":lh,"page/src/dom.js":ch,"page/src/figures.js":oh,"page/src/grab.js":Ku,"page/src/jobs.js":td,"page/src/motion.js":Wc,"page/src/rail.js":nd,"page/src/renderer.js":Xu,"page/src/runs.js":Jc,"page/src/same_arm.js":Lc,"page/src/scene.js":hd,"page/src/shapes.js":Gu,"page/src/state.js":ad,"page/src/still.js":pd,"page/src/text.js":Fc,"page/src/theme.js":gd,"page/src/verdicts.js":zc,"page/src/views/plots.js":_d,"page/src/views/transport.js":vd};var og=`:host {
  display: block;
  margin: 1.6rem 0;
  container-type: inline-size;
}
:host(:fullscreen) {
  margin: 0;
  overflow: auto;
  background: Canvas;
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
}
.buttons {
  display: flex;
  flex-wrap: wrap;
  gap: 4px;
  margin-left: auto;
}
button svg {
  display: block;
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
.stage.flat {
  position: static;
  height: auto;
  padding: 12px 16px;
  text-align: center;
  color: var(--soft);
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
  min-height: 26px;
  padding: 1px 8px;
  background: color-mix(in srgb, var(--ground) 82%, transparent);
}
.hold button[aria-pressed="true"] {
  background: color-mix(in srgb, var(--accent) 22%, var(--ground));
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
.sliders {
  display: flex;
  flex-direction: column;
  gap: 5px;
  padding: 12px 14px;
  border-top: 1px solid var(--line);
}
.joint {
  display: grid;
  grid-template-columns: 24px minmax(0, 1fr) 84px;
  align-items: start;
  gap: 8px;
  padding: 1px 4px;
  border-radius: 7px;
}
.joint.lit {
  background: color-mix(in srgb, var(--accent) 11%, transparent);
}
.joint .label {
  line-height: 26px;
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
  width: 84px;
  height: 26px;
  min-height: 0;
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
.row {
  display: flex;
  flex-wrap: wrap;
  align-items: center;
  gap: 8px 12px;
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
.words,
.verdict,
.error {
  color: var(--soft);
  font-size: 13.5px;
}
.verdict {
  color: var(--ink);
}
.verdict.warning {
  color: var(--bad);
  font-weight: 600;
}
.error {
  color: var(--bad);
  font-weight: 600;
}
.error:empty {
  display: none;
}
.scroll {
  position: relative;
  overflow-x: auto;
  border-radius: 6px;
}
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
.equation {
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
[data-index] {
  white-space: nowrap;
}
.matrix tr:not(:last-child) td:last-child {
  color: var(--accent);
  font-weight: 600;
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
.heat {
  border-spacing: 2px;
  border-collapse: separate;
  font-size: 12.5px;
}
.heat th {
  text-align: center;
  color: var(--ink);
  padding: 1px 5px;
  font-size: 14px;
}
.heat td {
  min-width: 51px;
  padding: 3px 5px;
  border-radius: 4px;
  text-align: right;
}
.heat td.plus {
  background: rgb(var(--plus) / calc(0.1 + 0.38 * var(--share)));
}
[data-theme="dark"] .heat td.plus {
  background: rgb(var(--plus) / calc(0.1 + 0.28 * var(--share)));
}
.heat td.minus {
  background: rgb(var(--minus) / calc(0.1 + 0.36 * var(--share)));
}
.heat td.nought {
  background: var(--raised);
}
.heat tr.second > * {
  border-top: 6px solid transparent;
  background-clip: padding-box;
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
  width: 58px;
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
  position: relative;
  display: inline-block;
  vertical-align: middle;
  width: calc(100% - 112px);
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
  left: var(--from);
  width: var(--width);
  background: var(--accent);
  border-radius: 2px;
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
.entries th {
  padding: 2px 4px;
}
.entries td {
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
  min-height: 24px;
  padding: 0 8px;
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
@container (max-width: 559px) {
  .hold button {
    min-height: 30px;
  }
}
@media (pointer: coarse) {
  button,
  select,
  input[type="text"],
  .tabs button,
  .hold button,
  .entries select,
  .remove {
    min-height: 44px;
    min-width: 44px;
  }
  .joint .value {
    height: 44px;
  }
  .joint .label {
    line-height: 44px;
  }
  .rail {
    min-height: 44px;
    padding-top: 10px;
  }
  .grip {
    width: 44px;
    height: 44px;
    margin: -22px;
  }
  .ways button {
    min-height: 48px;
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
  }
  header button {
    font-size: 12px;
    padding-inline: 7px;
  }
  header .fit,
  .limit {
    display: none;
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
    padding-inline: 4px;
  }
  .entries td:nth-child(odd) input {
    width: 66px;
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
  .heat td {
    min-width: 42px;
    padding-inline: 2px;
  }
  .heat th {
    padding-inline: 3px;
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
`;function ag(n,{arms:t,link:e,goTo:i,stage:s,card:r,say:o}){let a=t.length>1,l=U("select.name",{"aria-label":"Arm",onchange:x=>M(x.target.selectedIndex)}),c=a?l:U("span.name"),h=null,u=(x,v,C)=>U("button",{type:"button",title:v,onclick:C},x),f=[["deg","degrees"],["rad","radians"]].map(([x,v])=>U("button",{type:"button",title:v,"data-unit":x,onclick:()=>n.dispatch({type:"show",unit:x})},x)),p=u("Frames","Draw the frame of every link, or the first and the last only",()=>{n.dispatch({type:"show",frames:n.state.frames==="all"?"ends":"all"})}),g=u("↶","Undo (Ctrl+Z)",()=>n.dispatch({type:"undo"})),_=u("↷","Redo (Ctrl+Shift+Z)",()=>n.dispatch({type:"redo"}));g.setAttribute("aria-label","Undo"),_.setAttribute("aria-label","Redo");let m=u("","Full screen",()=>dS(r));m.setAttribute("aria-label","Full screen");let y={d:"M1 5V1h4M9 1h4v4M13 9v4H9M5 13H1V9",fill:"none",stroke:"currentColor","stroke-width":1.6};m.append(ii("svg",{viewBox:"0 0 14 14",width:14,height:14,"aria-hidden":"true"},ii("path",y)));let w=[U("span.pair",{role:"group","aria-label":"Unit of angles"},f),p,u("Home","Where this arm stands first",()=>i(Vi(n.state.arm))),u("Random","Somewhere within its limits",()=>i(Oo(n.state.arm))),u("Fit","The whole arm into the picture",()=>s.fit()),U("span.pair",{role:"group","aria-label":"Undo and redo"},g,_)];document.fullscreenEnabled&&w.push(m),e&&w.push(u("Copy link","An address that opens this arm in this place",async x=>{let v=await e.copy();x.target.textContent=v?"Copied":"In the address bar",o(()=>x.target.textContent),setTimeout(()=>x.target.textContent="Copy link",1600)})),r.addEventListener("keydown",x=>{!(x.ctrlKey||x.metaKey)||x.key.toLowerCase()!=="z"||x.target.matches("input[type=text], textarea")&&!x.target.dataset.cell||(x.preventDefault(),n.dispatch({type:x.shiftKey?"redo":"undo"}))});function M(x){t[x]&&(n.dispatch({type:"select",arm:t[x]}),s.fit())}function E({arm:x,base:v}){let C=x===v?null:x.name;if(h===C&&l.options.length)return;h=C;let R=t.map(I=>U("option",{},I.name));l.replaceChildren(...R,...C?[U("option",{},C)]:[])}function T(x){if(f.forEach(C=>C.setAttribute("aria-pressed",String(C.dataset.unit===x.unit))),p.setAttribute("aria-pressed",String(x.frames==="all")),g.disabled=!x.past.length,_.disabled=!x.future.length,!a)return void(c.textContent=x.arm.name);E(x);let v=x.arm===x.base?t.findIndex(C=>C.name===x.arm.name):t.length;l.selectedIndex=Math.max(0,v)}return{root:U("header",{},c,U("div.buttons",{role:"group","aria-label":"Settings"},w)),update:ar(({unit:x,frames:v,past:C,future:R,arm:I,base:F})=>[x,v,!C.length,!R.length,I,F],T)}}function dS(n){let{host:t}=n.getRootNode();document.fullscreenElement===t?document.exitFullscreen():t.requestFullscreen().catch(()=>{})}var Bi=Math.PI/180,Md=180/Math.PI;var wn=class extends Error{};function bd(n){let t=n.includes("'")&&!n.includes('"')?'"':"'",e={"\n":"\\n","\r":"\\r","	":"\\t","\\":"\\\\",[t]:`\\${t}`},i=[...n].map(r=>e[r]??fS(r)).join(""),s=[...`${t}${i}${t}`];return s.length<=80?s.join(""):`${s.slice(0,77).join("")}...`}function fS(n){let t=n.codePointAt(0);return!/[\p{C}\p{Z}]/u.test(n)||n===" "?n:t<256?`\\x${t.toString(16).padStart(2,"0")}`:t<65536?`\\u${t.toString(16).padStart(4,"0")}`:`\\U${t.toString(16).padStart(8,"0")}`}var lg=2e4,pS=10,dg=60,fg={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,arcsin:Math.asin,arccos:Math.acos,arctan:Math.atan,abs:Math.abs,radians:n=>n*Bi,deg2rad:n=>n*Bi,degrees:n=>n*Md,rad2deg:n=>n*Md,sind:n=>Math.sin(n*Bi),cosd:n=>Math.cos(n*Bi),float:n=>n,Float:n=>n,Integer:n=>n,float64:n=>n,float32:n=>n,int64:n=>n},cg={"+":(n,t)=>n+t,"-":(n,t)=>n-t,"*":(n,t)=>n*t,"/":(n,t)=>t===0?NaN:n/t,"^":gS},pg={pi:Math.PI,deg:Bi,rad:1},wd=n=>Object.hasOwn(fg,n),mS=n=>Object.hasOwn(pg,n);function gS(n,t){let e=n**t;return Number.isFinite(e)||!Number.isFinite(n)?e:NaN}var Bn=(n,t)=>[...n].map(e=>[e,t]),xS="alpha beta gamma delta theta theta phi phi psi omega lambda".split(" "),_S=new Map([...Bn("−–—‐‑‒﹣－","-"),...Bn("×⋅·∙∗","*"),...Bn("÷∕⁄","/"),...Bn("       　"," "),...Bn("​⁡⁢\uFEFF",""),...Bn("′’‘","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((n,t)=>Bn(n,`_${t}`)),...[..."αβγδθϑφϕψωλ"].flatMap((n,t)=>Bn(n,` ${xS[t]}`)),...Bn("π𝜋"," pi "),...Bn("°º˚◦∘"," deg"),...[..."０１２３４５６７８９"].flatMap((n,t)=>Bn(n,`${t}`)),["$"," "],["√","sqrt"],["⅓","(1/3)"],["½","(1/2)"],["¼","(1/4)"],["∞"," inf "]]),yS=[[/\\(?:left|right|big|Big|displaystyle|quad|qquad|limits)(?![A-Za-z])/g," "],[/\\[,;:! ]|~|\\hspace\{[^{}]*\}/g," "],[/\\(?:mathrm|text(?:bf|it|rm)?|math(?:it|bf|sf)|operatorname|boldsymbol|bm)\s*\{([^{}]*)\}/g,"$1"],[/\\ang\s*\{([^{}]*)\}|\\(?:SI|qty)\s*\{([^{}]*)\}\s*\{\s*\\degree\s*\}/g,"($1$2 deg)"],[/\^\s*\{?\s*\\(?:circ|degree)\s*\}?|\\(?:degree|circ|textdegree)(?![A-Za-z])/g," deg"],[/\\(?:cdot|times|ast)(?![A-Za-z])/g,"*"],[/\^\s*\{?\s*(?:\*|\\ast|\\star)\s*\}?(?!\w)/g," "],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"],[/_\s*\{\s*([\w+-]+)\s*\}/g,"_{$1}"],[/(?<=[0-9])\^\s*\{?\s*o\s*\}?(?![A-Za-z0-9])/g," deg"],[/(\\[dt]?frac)\s*([0-9]|\\pi(?![A-Za-z]))/g,"$1{$2}"],[/(\\[dt]?frac\s*\{[^{}]*\})\s*([0-9]|\\pi(?![A-Za-z]))/g,"$1{$2}"],[/(?<=[0-9.)])\s*(deg|rad)(?:ree|ian)s?(?![A-Za-z0-9_]|\s*\()/g," $1"]],vS=[[/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,"(($1)/($2))"],[/(\\(?:sqrt|sin|cos|tan)|\^)\s*\{([^{}]*)\}/g,"$1($2)"]],mg="⁺⁻⁰¹²³⁴⁵⁶⁷⁸⁹",MS=new RegExp(`[${mg}]+`,"g"),bS=/√ ?([0-9]+(?:\.[0-9]+)?)/g,SS=/(?<![A-Za-z_])(q|th|theta) *(?:\[ *([0-9]{1,2}) *\]|\( *([0-9]{1,2}) *\))/g,wS=/(?<![A-Za-z0-9_.])([0-9]+) ?([⅓½¼])/g,ES=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,TS=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,Sd=new RegExp(String.raw`\s*(?:(${ES})|(${TS})|(\*\*|[-+*/^()]))`,"y"),AS=/^(?:[cs]_?(?:\d|\{[\d+-]+\})+){2,}$/,RS=/[cs]_?(?:\d|\{[\d+-]+\})+/g,CS=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,PS=n=>CS.test(n);function Ed(n){if(PS(n))return n;n=n.replace(MS,t=>`^${[...t].map(e=>"+-0123456789"[mg.indexOf(e)]).join("")}`),n=n.replace(wS,"($1+$2)").replace(bS,"sqrt($1)"),n=[...n].map(t=>_S.get(t)??t).join("");for(let[t,e]of yS)n=n.replace(t,e);for(let t="";t!==n;){t=n;for(let[e,i]of vS)n=n.replace(e,i)}return n=n.replace(/\\([A-Za-z]+)/g," $1 "),n=n.replace(/\b(?:np|numpy|math|cmath|sp|sympy|sym|sy|jnp|torch)\./g,""),n=n.replace(/\.(?=[*/^])/g,""),n=n.replace(/(?<=\w)\s*\(t\)/g,""),n=n.replace(SS,"$1_$2$3"),n=n.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),n=n.replace(/(?<![_\w])\{|(?<=[^\w+-])\{/g,"("),n=n.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),n.replace(/[ \t]+/g," ").trim()}function gg(n,t="the formula"){if(n.length>lg)throw new wn(`${t} has ${n.length} characters; expected at most ${lg}`);if(!n.trim())throw new wn(`${t} is empty; expected a number or a formula, or 0`);let e=LS(Ed(n));if(!e)throw new wn(`${t} is ${bd(n)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let i=IS(e);if(i?.[1]!==e.length)throw new wn(`${t} is ${bd(n)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return i[0]}var kn=class extends Error{};function IS(n){try{return xg(n,0,0)}catch(t){if(t instanceof kn)return null;throw t}}function LS(n){let t=[];for(let e=0;e<n.length;e=Sd.lastIndex){Sd.lastIndex=e;let i=Sd.exec(n);if(!i)return null;let[,s,r,o]=i;if(s!==void 0)t.push(["num",s]);else if(o!==void 0)t.push(["sign",o==="**"?"^":o]);else for(let a of AS.test(r)?r.match(RS):[r])t.push(["name",a])}return t}function sc(n,t){if(t>=n.length)throw new kn;return n[t]}function xg(n,t,e){let[i,s]=hg(n,t,e);for(;s<n.length&&["+","-"].includes(n[s][1]);){let[r,o]=hg(n,s+1,e);[i,s]=[[n[s][1],i,r],o]}return[i,s]}function hg(n,t,e){let[i,s]=Mo(n,t,e);for(;s<n.length;){let[r,o]=n[s];if(o==="*"||o==="/"){let[a,l]=Mo(n,s+1,e);[i,s]=[[o,i,a],l]}else if(o==="("||r!=="sign"){if(r==="num"&&n[s-1][0]==="num")throw new kn;let[a,l]=_g(n,s,e);[i,s]=[["*",i,a],l]}else break}return[i,s]}function Mo(n,t,e){if(e>dg)throw new kn;let i=sc(n,t)[1];if(i==="-"){let[s,r]=Mo(n,t+1,e+1);return[["neg",s],r]}return i==="+"?Mo(n,t+1,e+1):_g(n,t,e)}function _g(n,t,e){let[i,s]=rc(n,t,e);if(s>=n.length||n[s][1]!=="^")return[i,s];let[r,o]=Mo(n,s+1,e+1),a=r[0]==="num"&&r[1]===0;if(i[0]==="num"&&i[1]>pS&&a)throw new kn;return[["^",i,r],o]}function rc(n,t,e){let[i,s]=sc(n,t);if(i==="num")return[["num",Number(s)],t+1];if(i==="name"&&wd(s)&&t+1<n.length){if(n[t+1][1]==="^"){let[c,h]=rc(n,t+2,e+1);if(c[0]!=="num")throw new kn;let[u,f]=ug(n,h,e+1);return[["^",["call",s,u],c],f]}let[a,l]=ug(n,t+1,e+1);return[["call",s,a],l]}if(i==="name")return[["name",s],t+1];if(s!=="(")throw new kn;let[r,o]=xg(n,t+1,e+1);if(sc(n,o)[1]!==")")throw new kn;return[r,o+1]}function ug(n,t,e){if(e>dg)throw new kn;if(sc(n,t)[1]!=="-")return rc(n,t,e);let[i,s]=rc(n,t+1,e);return[["neg",i],s]}function Td(n,t){let e=oc(n,t);if(!Number.isFinite(e))throw new wn("a formula divides by zero or is too large; expected a finite value");return e}function oc(n,t){let e=[];for(;Object.hasOwn(cg,n[0]);n=n[1])e.push(n);let i=NS(n,t);return e.reduceRight((s,[r,,o])=>cg[r](s,oc(o,t)),i)}function NS([n,t,e],i){if(n==="num")return t;if(n==="neg")return-oc(t,i);if(n==="call")return fg[t](oc(e,i));let s=mS(t)?pg[t]:i(t);if(s===void 0)throw new wn(`no value for ${t}`);return s}var yg=200,vg={angle:{units:{deg:Bi,rad:1},most:1e3,of:"an angle",such:"90°, pi/2 or 1.571 rad"},length:{units:{m:1,cm:.01,mm:.001},bare:"m",most:100,of:"a length",such:"metres, as 0.333"},force:{units:{N:1,kN:1e3},bare:"N",most:1e5,of:"a force",such:"newtons, as −5"},moment:{units:{Nm:1,Nmm:.001},bare:"Nm",most:1e5,of:"a moment",such:"newton metres, as 0.5"}},DS=new Set(Object.values(vg).flatMap(({units:n})=>Object.keys(n))),US=["radians","deg2rad","asin","acos","atan","arcsin","arccos","arctan"],FS=[[/(?<=[\d.)])\s*(?:metres?|meters?)\b/gi," m"],[/(?<=[\d.)])\s*newtons?\b/gi," N"],[/\bN\s*[*·⋅]?\s*(m{1,2})\b/g,"N$1"]],OS=/^([^,]*\d|[^,\d]*),(\d+[^,]*)$/,BS=/([A-Za-z_]\w*)\s*(\(|\s(?=[A-Za-z_]))/g,ac=class extends Error{};function Zn(n=""){throw new ac(n)}function kS(n){let t=n.includes(".")?n:n.trim().replace(OS,"$1.$2"),e=FS.reduce((i,[s,r])=>i.replace(s,r),Ed(t));for(let[,i,s]of e.matchAll(BS))i!=="pi"&&!(s==="("&&wd(i))&&Zn();try{return gg(e)}catch(i){throw i instanceof wn&&Zn(),i}}function os(n,t){let[e,i,s]=n;if(e==="num")return zS(i);if(e==="name")return GS(i,t);if(e==="neg"){let r=os(i,t);return{...r,value:-r.value,text:`-${bo(r.text)}`}}return e==="call"||e==="^"?VS(n,t):e==="*"&&s[0]==="name"&&DS.has(s[1])?HS(i,s[1],t):e==="+"||e==="-"?WS(n,t):XS(n,t)}function zS(n){return Number.isFinite(n)||Zn(),{value:n,unit:!1,text:String(n)}}function GS(n,{angle:t,known:e}){if(n==="pi")return{value:Math.PI,unit:t,pi:t,text:"pi"};let i=e(n);return i===void 0&&Zn(),{value:i,unit:!1,free:!0,text:n}}function VS(n,t){let e=Td(n,()=>Zn());return{value:e,unit:t.angle&&US.includes(n[1]),text:String(e)}}function HS(n,t,e){t in e.units||Zn(`has the unit ${t==="deg"?"°":t}`);let i=os(n,e);i.unit&&!(i.pi&&t==="rad")&&Zn("has two units");let s=e.units[t];return{value:i.value*s,unit:!0,text:Mg(i.text,t)}}function Mg(n,t){let e=Number(n)/15;if(t==="deg"&&Number.isInteger(e)&&e){let s=[12,6,4,3,2,1].find(l=>e%l===0),[r,o]=[e/s,12/s],a=Math.abs(r)===1?`${r<0?"-":""}pi`:`${r}*pi`;return o===1?a:`${a}/${o}`}let i={deg:"*pi/180",cm:"/100",mm:"/1000"}[t]??"";return i?`${bo(n)}${i}`:n}function WS([n,t,e],i){let[s,r]=[os(t,i),os(e,i)],o={text:`${s.text} ${n} ${n==="-"?bo(r.text):r.text}`},a=(p,g)=>n==="+"?p+g:p-g,[l,c]=[s,r].map(({unit:p,free:g,value:_})=>p||g||_===0);if(l===c||s.free||r.free){let p=(s.unit||r.unit)&&l&&c;return{value:a(s.value,r.value),unit:p,free:s.free||r.free,...o}}let h=i.units[i.bare];h!==void 0&&e[0]==="*"&&e[2][1]===i.bare||Zn("mixes numbers with and without a unit; say the unit of each");let f=Mg(s.text,i.bare);return{value:a(s.value*h,r.value),unit:!0,text:`${f} ${n} ${r.text}`}}function XS([n,t,e],i){let[s,r]=[os(t,i),os(e,i)],o=r.pi&&(n==="/"||s.pi);return r.unit&&!o&&(n==="/"&&Zn("divides by a number with a unit"),s.unit&&Zn("multiplies two units")),{value:Td([n,["num",s.value],["num",r.value]],()=>{}),unit:s.unit||r.unit&&!o,pi:s.pi||r.pi,free:s.free||r.free,text:`${bo(s.text)}${n}${bo(r.text,!0)}`}}var bo=(n,t=!1)=>(t?/[-+*/ ]/:/[-+ ]/).test(n.replace(/e[-+]\d/g,""))?`(${n})`:n;function Jn(n,t,e){let i=vg[t],s=e&&e in i.units?e:i.bare??"rad",r=`“${n.trim().slice(0,40)}${n.trim().length>40?"…":""}”`;if(!n.trim())return{error:"is empty; write 0 for none"};if(n.length>yg)return{error:`has ${n.length} characters; ${yg} are the most`};try{let o={units:i.units,angle:t==="angle",bare:s,known:()=>{}},a=os(kS(n),o),l=a.unit?a.value:a.value*i.units[s];return Number.isFinite(l)?Math.abs(l)>i.most?{error:`${r} is too large for ${i.of} here`}:{value:l+0}:{error:`${r} divides by zero or is too large`}}catch(o){return{error:`${r} ${$S(o,i)}`}}}function $S(n,{of:t,such:e}){if(n instanceof wn)return"divides by zero or is too large";if(!(n instanceof ac))throw n;return n.message?`${n.message}; ${t} is asked for: ${e}`:`is no number; write ${e}`}var Kn=n=>/^\s*$|[-+*/(.,eE−–πp]\s*$/.test(n)||/^[\s\d.,]*$/.test(n);var qS=0;function bg(n,{say:t,signal:e}){let i=U("div.sliders",{role:"group","aria-label":"Joints"}),s=U("p.error"),r=[],o={},a=(p,g,_=null)=>{n.dispatch({type:"move",q:n.state.q.map((m,d)=>d===p?g:m),gesture:_})};function l(p,g,_,m){let{unit:d,q:y}=n.state,{value:w,error:M}=Jn(_.value,Nc(g),d),E=M&&(m||!Kn(_.value));me(_,"aria-invalid",String(!!E)),s.textContent=E?`${_.dataset.joint} ${M}.`:"",E&&t(()=>s.textContent),m&&(M||a(p,w),_.value=_i(g,M?y[p]:w,d),_.setAttribute("aria-invalid","false"))}function c({arm:p,unit:g}){o.abort?.abort();let _=new AbortController;e.addEventListener("abort",()=>_.abort(),{signal:_.signal}),r=yt(p).map((d,y)=>h(p.rows[d],d,y,g,_.signal));let m=U("p.words",{},"No joint moves this arm.");i.replaceChildren(...r.length?r.map(d=>d.root):[m],s),o={rows:p.rows,unit:g,abort:_}}function h(p,g,_,m,d){let[y,w]=Tn(p),M=`Joint ${g+1}, ${p.kind==="revolute"?"angle":"slide"}`,E=U("input",{type:"range",min:y,max:w,step:"any","aria-label":M,"data-joint":g+1,oninput:V=>a(_,Number(V.target.value),`slider ${g}`),onkeydown:V=>u(V,p,_)}),T=U("input.value",{type:"text",spellcheck:"false",autocomplete:"off","aria-label":`${M}, typed`,"data-joint":M,oninput:V=>l(_,p,V.target,!1),onchange:V=>l(_,p,V.target,!0)}),x=V=>U("span",{},(V??null)===null?"":Uc(p,V,m)),v=U("span.past"),C=U("span.bounds",{},x(p.lower),v,x(p.upper)),R=V=>()=>n.state.lit!==V&&n.dispatch({type:"show",lit:V}),I=U("div.rail",{},E,C),F=null;ed(I,E,{start:()=>F=`rail ${++qS}`,put:V=>a(_,V,F),signal:d});let P={onpointerenter:R(g),onpointerleave:R(null),onfocusin:R(g),onfocusout:R(null)};return{root:U("div.joint",P,U("span.label",{},Xe("q",g+1)),I,T),slider:E,field:T,past:v,row:p,index:g}}function u(p,g,_){let m={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10}[p.key],[d,y]=Tn(g),w={Home:d,End:y}[p.key];if(!m&&w===void 0)return;p.preventDefault();let M=(Vn(g)?Math.PI/180:.005)*(p.shiftKey?.1:1);a(_,w??Math.min(y,Math.max(d,n.state.q[_]+m*M)),`keys ${_}`)}function f(p){(o.rows!==p.arm.rows||o.unit!==p.unit)&&c(p),r.forEach(({root:g,slider:_,field:m,past:d,row:y,index:w},M)=>{g.classList.toggle("lit",p.lit===w);let E=p.q[M],[T,x]=Tn(y);_.value=String(E),me(_,"aria-valuetext",Dc(y,E,p.unit));let[v,C]=[E,0].map(I=>100*Math.min(1,Math.max(0,(I-T)/(x-T||1))));if(_.style.setProperty("--low",`${Math.min(v,C).toFixed(2)}%`),_.style.setProperty("--high",`${Math.max(v,C).toFixed(2)}%`),m.getRootNode().activeElement!==m){let I=_i(y,E,p.unit);m.value!==I&&(m.value=I)}let R=ti(y,E);g.classList.toggle("past",R),ae(d,R?"past its limit":"")})}return{root:i,update:f}}var YS="Picture of the arm. Arrow keys turn the view, plus and minus bring it nearer and farther, 0 fits it. The button at the tip moves the tip; the sliders turn the joints.",jS={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.1],ArrowDown:[0,.1],"+":[0,0,.9],"=":[0,0,.9],"-":[0,0,1.1]},ZS=.06;function Sg(n,{goTo:t,id:e,say:i}){let s=U("div.labels",{"aria-hidden":"true"}),r=U("button.grip",{type:"button","aria-label":"Tip","aria-describedby":`${e}-grip`,onkeydown:p,title:"Drag the tip: the joints follow. Arrow keys move it too."}),o=U("span.hidden",{id:`${e}-grip`},"Arrow keys move the tip across the picture, Page keys to and fro."),a=U("p.why",{"aria-hidden":"true"}),l=U("p.lost",{hidden:!0},"The browser took the picture’s graphics away; it comes back when it can."),c=JS(n),h=U("div.stage",{tabindex:0,role:"application","aria-label":YS,onkeydown:f,ondblclick:()=>u?.fit()},s,r,o,c.root,a,l),u=null;try{u=new _o(h,s,{onLost:g=>l.hidden=!g,onPlace:([g,_])=>r.style.transform=`translate(${g}px, ${_}px)`}),u.figure.foot=()=>c.root.offsetHeight+40,ju(u,n,{grip:r,goTo:t})}catch{u=null,h.classList.add("flat"),h.setAttribute("role","group"),h.setAttribute("aria-label","Still picture of the arm, which follows the sliders"),h.removeAttribute("tabindex"),h.replaceChildren(U("slot"),U("p",{},"This browser gives no WebGL, so the picture is a still one that follows."))}function f(g){if(g.target!==h)return;let[_,m,d]=jS[g.key]??[];if(g.key==="0")u?.fit();else{if(_===void 0)return;u?.figure.orbit(_,m,d)}g.preventDefault()}function p(g){u&&Ju(u,n,g)&&i(()=>Fo(n.state.hold))}return{root:h,draw(g,_,m){u?.draw(g,_,m)},update(g){c.update(g),r.hidden=!u||!yt(g.arm).length||g.view==="torque"&&!g.wrench.slice(0,3).some(Boolean);let _=Fo(g.hold);ae(a,_),a.hidden=!_},fit:()=>u?.fit(),scale:()=>u?.scale,dispose:()=>u?.dispose()}}function JS(n){let t=U("button",{type:"button",title:"A dragged tip keeps the direction of the tool too",onclick:()=>n.dispatch({type:"show",keepTurn:!n.state.keepTurn})},"Keep direction"),e=U("button",{type:"button",title:"Hold the tip where it is, and drag the elbow through what is left",onclick:r},"Pin the tip"),i=[-1,1].map(l=>U("button.swing",{type:"button","aria-label":`Swing ${l<0?"one":"the other"} way`,onclick:()=>tw(n,l)},l<0?"↺":"↻")),s=U("div.hold",{role:"group","aria-label":"The tip"},t,e,i);function r(){let{state:l,derived:c}=n,h=yt(l.arm).length>6||l.keepTurn&&Re(l.arm)===6,u=l.hold?.pinned?null:{pinned:c.frames.at(-1),turns:h,free:QS(n,h)};n.dispatch({type:"show",hold:u})}function o({keepTurn:l,hold:c,arm:h}){let u=!!c?.pinned;t.setAttribute("aria-pressed",String(l)),t.hidden=Re(h)<6,e.setAttribute("aria-pressed",String(u)),e.textContent=u?KS(c):"Pin the tip",i.forEach(f=>f.hidden=!u||!c.free)}return{root:s,update:ar(({keepTurn:l,hold:c,arm:h})=>[l,h,c?.pinned,c?.free,c?.turns],o)}}var KS=({free:n,turns:t})=>{let e=t?"place and direction":"place";return n?`Tip pinned (${e}): drag the elbow`:`Tip pinned (${e}): nothing is free`},wg=({derived:n},t)=>n.columns.map(e=>e.slice(0,t?6:3)),QS=(n,t)=>ei(wg(n,t)).length;function tw(n,t){let{arm:e,q:i,hold:s}=n.state;if(!s?.pinned)return;let[r]=ei(wg(n,s.turns));if(!r)return;let o=r.reduce((h,u,f)=>Math.abs(u)>Math.abs(r[h])?f:h,0),a=t*Math.sign(r[o]),l=i.map((h,u)=>h+a*ZS*r[u]),c=s.turns?An(e,l,s.pinned).q:l;n.dispatch({type:"move",q:c,hold:s,gesture:"swing"})}var Ad={};oe(Ad,{build:()=>nw,title:()=>ew});var ew="IK branches";function nw(n,{goTo:t,say:e}){let i=U("p.verdict"),s=U("ol.ways"),r=U("button.main",{type:"button",onclick:c},"Find the ways to this pose"),o=U("div.branches",{},U("div.row",{},r),i,s),a=po("ways"),l;async function c(){let{arm:f,q:p}=n.state;r.textContent="Looking …",await a({arm:f,q:p},g=>{n.dispatch({type:"ways",arm:f,ways:g}),e(()=>i.textContent,!0)}),r.textContent="Find the ways to this pose"}function h(f,p){(l?.ways!==f.ways||l.unit!==f.unit||l.arm!==f.arm)&&u(f);let g=go(f,p);o.classList.toggle("left",!!g),ae(i,sw(f,g)),l.buttons.forEach((_,m)=>{me(_,"aria-current",String(rr(f.ways.list[m].q,f.q)))})}function u({ways:f,arm:p,unit:g}){let _=yt(p),m=(f?.list??[]).map(({q:d,label:y},w)=>{let M=_.flatMap((C,R)=>ti(p.rows[C],d[R])?[C+1]:[]),E=C=>()=>n.dispatch({type:"show",highlighted:C?w:null}),T=M.length?`past the limit of joint ${M.join(", ")}`:vc(p)?"within limits":"",x=_.map((C,R)=>U("span",{},Xe("q",C+1),` ${_i(p.rows[C],d[R],g)}`)),v={onpointerenter:E(!0),onpointerleave:E(!1),onfocus:E(!0),onblur:E(!1)};return U("button",{type:"button",onclick:()=>t(d),...v},U("span.swatch",{style:`background:${xo(w)}`,"aria-hidden":"true"}),U("span.name",{},y?iw(y):`way ${w+1}`),U("span.values",{},x),U(M.length?"span.note.past":"span.note",{},T))});s.replaceChildren(...m.map(d=>U("li",{},d))),l={ways:f,unit:g,arm:p,buttons:m}}return{root:o,update:h,summary:()=>i.textContent}}var iw=n=>n.split(/\b([a-z]_\d+)\b/).map((t,e)=>e%2?U("span",{},Xe(...t.split("_"))):t.replace(/-$/,"−"));function sw({ways:n,arm:t},e){if(!n)return"Each way that the same pose can be reached is shown in a colour of its own; choose one to go there.";let i=n.list.length>1?" Choose one, here or in the picture, to go there.":"";return e?`These lead to the pose where the tip was before; it is now ${e.far>5e-4?`${Kt(1e3*e.far,0)} mm from there`:"turned away from it"}. Choose one to go back, or find the ways to this pose.`:Bc(t,n)+i}var Rd={};oe(Rd,{build:()=>ow,title:()=>rw});var rw="Jacobian",Eg=[["v","x"],["v","y"],["v","z"],["ω","x"],["ω","y"],["ω","z"]];function ow(n,{point:t}){let e=U("tr"),i=U("tbody"),s=U("table.heat",{"aria-label":"Jacobian of the tip: one column for each joint"},U("thead",{},e),i),r=U("p.verdict"),o=U("dl.facts"),a=U("p.words"),l=U("div.jacobian",{},U("div.scroll",{tabindex:0,role:"region","aria-label":"Jacobian"},s),U("div",{},r,o,a)),[c,h]=[[],null];function u(){h=n.state.arm;let p=yt(h);e.replaceChildren(U("th",{},U("span.hidden",{},"row")),...p.map(g=>U("th",{scope:"col"},Xe("q",g+1)))),c=Eg.map(()=>p.map(g=>U("td",{onpointerenter:()=>t(g),onpointerleave:()=>t(null)}))),i.replaceChildren(...c.map((g,_)=>U(_===3?"tr.second":"tr",{},U("th",{scope:"row"},Xe(...Eg[_])),g)))}function f(p,g,_){h!==p.arm&&u();let{columns:m}=g,d=[0,3].map(E=>Math.max(1e-9,...m.flatMap(T=>T.slice(E,E+3).map(Math.abs))));c.forEach((E,T)=>E.forEach((x,v)=>{let C=m[v][T],R=Math.abs(C)/d[T<3?0:1];ae(x,nr(C,3)),me(x,"class",R<5e-4?"nought":C>0?"plus":"minus"),x.style.setProperty("--share",R.toFixed(2))}));let{singular:y,text:w}=Do(g);me(r,"class",y?"verdict warning":"verdict"),ae(r,w),o.replaceChildren(...aw(g));let M=_?`, drawn at 1 : ${(1/_).toFixed(1).replace(".0","")}`:"";ae(a,`The ellipsoid at the tip holds every velocity that joint rates of unit length give it${M}; where it is flat, the tip cannot go.`)}return{root:l,update:f,summary:(p,g)=>Do(g).text}}function aw(n){let{arm:t,determinant:e,manipulability:i,values:s,linear:r}=n,o=f=>Math.abs(f)<5e-7?"0":Math.abs(f)<.001?f.toExponential(2).replaceAll("-","−"):Kt(f,5),a=(f,p)=>[U("dt",{},f),U("dd",{},p)],l=Re(t)===3,c=["det ",U("i",{},"J"),...l?[U("sub",{},"v")]:[]],h=e===null?[]:a(c,o(e)),u=sr(t)?a("smallest σ",o(s[sr(t)-1])):[];return[...h,...a("manipulability",o(i)),...u,...a("half axes",r.values.map(f=>Kt(f,2)).join(", "))]}var Tg=(n,t)=>({title:t,build(e,i){let s=U("p.words",{role:"status"},"Loading …"),r=U("div",{},s),o=null;return ih(n).then(a=>{i.signal.aborted||(o=a.build(e,i),r.replaceChildren(o.root),e.state.view===n&&o.update(e.state,e.derived))},()=>s.textContent="This part could not be loaded; opening the page anew tries again."),{root:r,update:(...a)=>o?.update(...a),summary:(...a)=>o?.summary(...a)??""}}});var Cd={};oe(Cd,{build:()=>cw,title:()=>lw});var lw="Pose";function cw(n,{say:t}){let e=(_,m)=>U("td",{"data-entry":`${_}${m}`}),i=[0,1,2,3].map(_=>[0,1,2,3].map(m=>e(_,m))),s=U("span"),r=i.map(_=>U("tr",{},_)),o=U("table.matrix",{"aria-label":"Pose of the tip, a four by four matrix"},r),a=U("p.words"),l=["x","y","z"].map((_,m)=>U("input.small",{type:"text",spellcheck:"false",autocomplete:"off","aria-label":`Tip ${_}, typed`,oninput:d=>p(m,d.target,!1),onchange:d=>p(m,d.target,!0)})),c=U("p.error"),h=l.map((_,m)=>U("label",{},U("i",{},"xyz"[m])," ",_," m")),u=U("fieldset.wrench",{},U("legend",{},"Bring the tip to"),h),f=U("div.pose",{},U("div.equation",{},s,U("span",{},"="),o),U("div",{},u,c,a));function p(_,m,d){let{value:y,error:w}=Jn(m.value,"length"),M=w&&(d||!Kn(m.value));if(me(m,"aria-invalid",String(!!M)),c.textContent=M?`${"xyz"[_]} ${w}.`:"",M&&t(()=>c.textContent),!!d){if(!w){let{o:E}=n.derived.frames.at(-1);ec(n,E.map((T,x)=>x===_?y:T)),c.textContent=Uo(n.state.hold??{stops:[],short:0})}me(m,"aria-invalid","false"),m.value=Kt(n.derived.frames.at(-1).o[_],4)}}function g(_,{frames:m}){let d=`0,${_.arm.rows.length}`;s.dataset.index!==d&&s.replaceChildren(...Xe("T",d)),s.dataset.index=d,xc(m.at(-1)).forEach((x,v)=>x.forEach((C,R)=>{ae(i[v][R],v===3?String(C):nr(C,4)),i[v][R].classList.toggle("nought",Math.abs(C)<5e-5)}));let{o:y}=m.at(-1);l.forEach((x,v)=>{x.getRootNode().activeElement!==x&&(x.value=Kt(y[v],4))});let[w,M,E]=y.map(x=>Kt(1e3*x,1));ae(a,`Tip at (${w}, ${M}, ${E}) mm. The first three columns are the tip’s axes, the fourth its place, in the base frame and in metres.${hw(_.mark,y)}`)}return{root:f,update:g,summary:()=>c.textContent}}function hw(n,t){if(!n)return"";let e=n.map(i=>Kt(i,3)).join(", ");return` It is ${Kt(1e3*$t(At(t,n)),2)} mm from the mark at (${e}) m.`}var Pd={};oe(Pd,{build:()=>Sw,title:()=>_w});var uw=n=>n.replaceAll("−","-").replaceAll("π","pi"),hn=n=>String(Number(n.toFixed(9))+0),lc=n=>{let t=uw(ir(n,!0,"rad"));return t.includes("pi")?t.replace(/(\d)pi/,"$1*pi"):hn(n)},dw=n=>n.replace(/[^A-Za-z0-9]+/g,"_").replace(/^_|_$/g,"").toLowerCase()||"arm",cc={python:{label:"Python",file:"arm.py"},matlab:{label:"MATLAB",file:"arm.m"},csv:{label:"CSV",file:"arm.csv"},urdf:{label:"URDF",file:"arm.urdf"}},fw={python:pw,matlab:mw,csv:gw,urdf:xw},Ag=(n,{arm:t,q:e})=>fw[n](t,e);function pw(n,t){let e=s=>s.includes("pi")?`"${s}"`:s,i=n.rows.map(s=>`    ${s.kind}(a=${hn(s.a)}, alpha=${e(lc(s.alpha))}, d=${hn(s.d)}, theta=${e(lc(s.theta))}),`);return["from helpers.arm import Arm, fixed, prismatic, revolute","",`arm = Arm(${JSON.stringify(n.name)}, (`,...i,"))",`q = [${t.map(hn).join(", ")}]`,""].join(`
`)}function mw(n,t){let e=n.rows.map(s=>`  ${hn(s.a)}  ${lc(s.alpha)}  ${hn(s.d)}  ${lc(s.theta)}  % ${s.kind}`),i=n.rows.map(s=>({revolute:"'R'",prismatic:"'P'",fixed:"'F'"})[s.kind]).join(" ");return[`% ${n.name}, standard convention: a (m), alpha (rad), d (m), theta (rad)`,"DH = [",...e,"];",`kind = [${i}];  % R turns, P slides, F is fixed`,`q = [${t.map(hn).join(" ")}];`,""].join(`
`)}function gw(n){return["a_m,alpha_rad,d_m,theta_rad,kind",...n.rows.map(e=>[e.a,e.alpha,e.d,e.theta].map(hn).concat(e.kind).join(",")),""].join(`
`)}function xw(n){let e=['<?xml version="1.0"?>',`<robot name="${dw(n.name)}">`,'  <link name="link_0"/>'],i=yt(n),s=(r,o,a,l,c,h="")=>`  <joint name="${r}" type="${o}">
    <parent link="${a}"/>
    <child link="${l}"/>
    <origin xyz="${c.slice(0,3).map(hn).join(" ")}" rpy="${c.slice(3).map(hn).join(" ")}"/>
${h}  </joint>`;return n.rows.forEach((r,o)=>{let a=`link_${o}`;if(i.includes(o)){let c=r.kind==="revolute",h=r.lower!==null&&r.lower!==void 0&&r.upper!==null&&r.upper!==void 0,[u,f]=h?[r.lower,r.upper]:[-1,1],p=c?h?"revolute":"continuous":"prismatic",g=`lower="${hn(u)}" upper="${hn(f)}" `,_=`effort="${hn(r.effort??0)}" velocity="${hn(r.speed??0)}"`,m=`    <axis xyz="0 0 1"/>
    <limit ${p==="continuous"?"":g}${_}/>
`;e.push(s(`joint_${o+1}`,p,a,`moved_${o+1}`,[0,0,0,0,0,0],m)),e.push(`  <link name="moved_${o+1}"/>`),a=`moved_${o+1}`}let l=[r.a*Math.cos(r.theta),r.a*Math.sin(r.theta),r.d];e.push(s(`row_${o+1}`,"fixed",a,`link_${o+1}`,[...l,r.alpha,0,r.theta])),e.push(`  <link name="link_${o+1}"/>`)}),[...e,"</robot>",""].join(`
`)}var _w="DH table",Rg=[["a","a",!1],["alpha","α",!0],["d","d",!1],["theta","θ",!0]],yw={revolute:"turns",prismatic:"slides",fixed:"fixed"},vw=ls.map(n=>[n,yw[n]]),Mw=/[\n\t;&|]|\]\s*,|,\s*\[/,bw={kind:"revolute",a:.2,alpha:0,d:0,theta:0};function Sw(n,{say:t}){let e=U("tr"),i=U("tbody",{onpaste:y}),s=U("p.error"),r=U("p.verdict"),o=U("button",{type:"button",onclick:()=>_([...n.state.arm.rows,bw])},"Add a row"),l=U("button",{type:"button",onclick:()=>_(n.state.base.rows)},"Back to the first table"),c=Object.entries(cc).map(([x,{label:v}])=>U("option",{value:x},v)),h=U("select",{"aria-label":"Format to copy"},c),u=U("button",{type:"button",onclick:w},"Copy as"),f=U("table.entries",{"aria-label":"Denavit-Hartenberg table, standard convention"},U("thead",{},e),i),p=U("div.dh",{},U("div.scroll",{tabindex:0,role:"region","aria-label":"Denavit-Hartenberg table"},f),s,U("div.row",{},o,l,U("span.right.pair",{},u,h)),r),g={},_=(x,v,C=null)=>n.dispatch({type:"edit",rows:x,rowBefore:v,gesture:C}),m=x=>{s.textContent=x?`${x} The last good arm stays.`:"",x&&t(()=>s.textContent)};function d(x,[v,C,R],I,F){let{value:H,error:P}=Jn(I.value,R?"angle":"length",n.state.unit),B=P&&(F||!Kn(I.value));if(me(I,"aria-invalid",String(!!B)),m(B?`Row ${x+1}, ${C} ${P}.`:""),P)return;let V=n.state.arm.rows.map((W,tt)=>tt===x?{...W,[v]:H}:W);_(V,void 0,`cell ${x} ${v}`)}async function y(x){let v=x.clipboardData?.getData("text/plain")??"";if(!Mw.test(v.trim()))return;x.preventDefault();let R=(await sh())(v,n.state.unit)??{error:"it is a single entry."};m("error"in R?`What was pasted is not read: ${R.error}`:""),!("error"in R)&&(_(R.rows),R.said.length&&t(()=>`Taken as ${R.said.join("; ")}`,!0))}async function w(){let x=Ag(h.value,n.state),v=await navigator.clipboard?.writeText(x).then(()=>!0,()=>!1);v||Ew(x,cc[h.value].file),u.textContent=v?"Copied":"Saved",t(()=>`${u.textContent} as ${cc[h.value].label}`,!0),setTimeout(()=>u.textContent="Copy as",1600)}function M({arm:x,unit:v}){let C=v==="deg"?"°":"rad";e.replaceChildren(...["row","joint"].map(R=>U("th",{scope:"col"},R)),...Rg.map(([,R,I])=>U("th",{scope:"col"},U("i",{},R),U("small",{},I?` (${C})`:" (m)"))),U("th",{},U("span.hidden",{},"remove"))),i.replaceChildren(...x.rows.map((R,I)=>E(R,I,x,v))),g={rows:x.rows,unit:v}}function E(x,v,C,R){let I=U("select",{"aria-label":`Row ${v+1}, kind of joint`,onchange:P=>_(C.rows.map((B,V)=>V===v?ww(B,P.target.value):B))},vw.map(([P,B])=>U("option",{value:P,selected:x.kind===P},B))),F=P=>{let[B,V,W]=P,tt=x.kind==="revolute"&&B==="theta"||x.kind==="prismatic"&&B==="d",$=U("input",{type:"text",spellcheck:"false",autocomplete:"off",value:ir(x[B],W,R),"aria-label":`Row ${v+1}, ${V}`,"data-cell":`${v+1}-${B}`,oninput:Q=>d(v,P,Q.target,!1),onchange:Q=>d(v,P,Q.target,!0)});return U(tt?"td.moves":"td",{},$,tt?U("span",{},"+ ",U("i",{},"q"),U("sub",{},String(v+1))):[])},H=U("button.remove",{type:"button","aria-label":`Remove row ${v+1}`,title:`Remove row ${v+1}`,disabled:C.rows.length===1,onclick:()=>_(C.rows.filter((P,B)=>B!==v),P=>P<v?P:P+1)},"×");return U("tr",{},U("th",{scope:"row"},String(v+1)),U("td",{},I),Rg.map(F),U("td",{},H))}function T(x,v){let C=i.contains(p.getRootNode().activeElement)&&p.getRootNode().activeElement.matches("input");(g.rows?.length!==x.arm.rows.length||g.unit!==x.unit||g.rows!==x.arm.rows&&!C)&&M(x),o.disabled=x.arm.rows.length>=Zs,ae(r,kc(x,v))}return{root:p,update:T,summary:()=>s.textContent||r.textContent}}var ww=(n,t)=>({...n,kind:t,lower:null,upper:null,speed:null,effort:null});function Ew(n,t){let e=URL.createObjectURL(new Blob([n],{type:"text/plain"}));U("a",{href:e,download:t}).click(),URL.revokeObjectURL(e)}var Id={};oe(Id,{build:()=>Aw,title:()=>Tw});var Tw="Static torque",hc=["F","M"].flatMap(n=>["x","y","z"].map(t=>[n,t,n==="F"?"N":"N m"]));function Aw(n,{point:t,say:e}){let i=hc.map(([_,m,d],y)=>U("input",{type:"text","aria-label":`${_} ${m}, ${d}`,spellcheck:"false",oninput:w=>f(y,w.target,!1),onchange:w=>f(y,w.target,!0)})),s=U("p.error"),r=U("tbody"),o=U("p.verdict"),a=U("p.words"),l=["joint","gravity","−Jᵀ F","torque","share of the limit"],c=U("div.torque",{},U("fieldset.wrench",{},U("legend",{},"Wrench on the tool, by the world, at the tip (N, N m)"),hc.map(([_,m],d)=>U("label",{},U("span",{},Xe(_,m)),i[d])),U("button",{type:"button",onclick:()=>n.dispatch({type:"push",wrench:[0,0,0,0,0,0]})},"No load")),s,U("div.scroll",{tabindex:0,role:"region","aria-label":"Torques"},U("table.bars",{"aria-label":"Static torque of each joint"},U("thead",{},U("tr",{},l.map(_=>U("th",{scope:"col"},_)))),r)),o,a),[h,u]=[[],null];function f(_,m,d){let{value:y,error:w}=Jn(m.value,_<3?"force":"moment"),M=w&&(d||!Kn(m.value));if(me(m,"aria-invalid",String(!!M)),s.textContent=M?`${hc[_][0]}${hc[_][1]} ${w}. The last good wrench stays.`:"",M&&e(()=>s.textContent),!w){let E=n.state.wrench.map((T,x)=>x===_?y:T);n.dispatch({type:"push",wrench:E,gesture:`wrench ${_}`})}d&&(me(m,"aria-invalid","false"),m.value=Gn(n.state.wrench[_],2))}function p(){u=n.state.arm,h=yt(u).map(_=>{let m=["gravity","push","total"].map(E=>U(`td.${E}`)),d=U("span.fill"),[y,w]=[U("span"),U("span.limit")],M=U("tr",{onpointerenter:()=>t(_),onpointerleave:()=>t(null)},U("th",{scope:"row"},Xe("τ",_+1)),m,U("td.bar",{},U("span.track",{"aria-hidden":!0},d),U("span.share",{},y,w)));return{row:_,cells:m,fill:d,part:y,limit:w,line:M}}),r.replaceChildren(...h.map(({line:_})=>_))}function g(_,{gravity:m,push:d,torque:y,energy:w}){u!==_.arm&&p(),i.forEach((x,v)=>{x.getRootNode().activeElement!==x&&(x.value=Gn(_.wrench[v],2))});let M=Math.max(1e-9,...y.map(Math.abs));h.forEach(({row:x,cells:v,fill:C,part:R,limit:I,line:F},H)=>{let{effort:P,kind:B}=u.rows[x],V=B==="revolute"?"N m":"N";[m[H],-d[H],y[H]].forEach(($,Q)=>ae(v[Q],Kt($,2)));let W=y[H]/(P??M);C.style.setProperty("--from",`${50+50*Math.max(-1,Math.min(0,W))}%`),C.style.setProperty("--width",`${50*Math.min(1,Math.abs(W))}%`),F.classList.toggle("over",!!P&&Math.abs(W)>1);let tt=P?`${Kt(100*Math.abs(W),0)} %`:"";ae(R,tt),ae(I,P?` of ${P} ${V}`:V)});let E=h.filter(({line:x})=>x.classList.contains("over")).map(({row:x})=>`joint ${x+1}`);o.classList.toggle("warning",E.length>0),ae(o,Rw(u,E,m));let T=u.rows.some(x=>x.body);ae(a,T?`Gravity’s torques are the slopes of one energy, ${Kt(w,1)} J here.`:"")}return{root:c,update:g,summary:()=>o.textContent}}function Rw(n,t,e){if(t.length)return`Too much for ${ni(t)}.`;if(!n.rows.some(r=>r.body))return"No masses are known of this arm, so only the push on the tool shows.";let i=n.rows.every(r=>r.kind==="fixed"||r.effort)?"Every joint can hold this. ":"",s=e.every(r=>r===0)?" Gravity asks nothing here.":"";return`${i}Drag the ball at the tip to push on the tool.${s}`}var Ld={};oe(Ld,{build:()=>Pw,title:()=>Cw});var Cw="Circle trace",Cg=5;function Pw(n,{say:t,signal:e}){let i=["x","y","z"].map(M=>U("option",{value:M},`${M} = const`)),s=M=>n.dispatch({type:"circle",normal:M}),r=U("select",{"aria-label":"Plane of the circle",onchange:M=>s(M.target.value)},i),o=U("input.small",{type:"text",spellcheck:"false",autocomplete:"off","aria-label":"Radius of the circle, m",oninput:M=>d(M.target,!1),onchange:M=>d(M.target,!0)}),a=U("select",{"aria-label":"What the plots show",onchange:()=>y()},U("option",{value:"joint"},"joint values"),U("option",{value:"torque"},"static torques")),l=U("button",{type:"button",onclick:()=>m()},"Draw a circle from here"),c=U("p.verdict"),h=U("p.error"),u=xd(),f=yd(n,{signal:e,begin:M=>m(M)}),p=U("div.trace",{},f.root,U("div.row",{},U("label",{},"Plane ",r),U("label",{},"Radius ",o," m"),l,U("label.right",{},"Plots ",a)),h,c,u.root),g=po("circle"),_=null;async function m(M=()=>{}){let{arm:E,q:T,circle:x}=n.state;d(o,!0)&&(l.disabled=!0,await g({arm:E,q:T,circle:x},({path:v,stray:C,wanted:R})=>{n.dispatch({type:"traced",arm:E,circle:x,path:v,stray:C,wanted:R}),t(()=>c.textContent,!0),M()}),l.disabled=!1)}function d(M,E){let{value:T,error:x}=Jn(M.value,"length"),v=!x&&!(T>0&&T<=Cg),C=x??(v?`“${M.value}” is no length above 0 and up to ${Cg} m`:""),R=C&&(E||!Kn(M.value));return me(M,"aria-invalid",String(!!R)),h.textContent=R?`The radius ${C}.`:"",R&&t(()=>h.textContent),!C&&T!==n.state.circle.radius&&n.dispatch({type:"circle",radius:T}),!C}function y(){let{arm:M,trace:E,unit:T,wrench:x}=n.state;if(_={arm:M,trace:E,unit:T,wrench:x},p.classList.toggle("empty",!E),ae(c,Iw(n.state)),!E)return u.clear();let v=a.value==="torque";return u.lay(n.state,v?Yc(M,E,x):E,v),u.mark(n.state.at)}function w(M){!_||["arm","trace","unit"].some(x=>_[x]!==M[x])||a.value==="torque"&&_.wrench!==M.wrench?y():M.trace&&u.mark(M.at),r.value=M.circle.normal,!(o.getRootNode().activeElement===o)&&!h.textContent&&(o.value=Gn(M.circle.radius,4)),f.update(M)}return{root:p,update:w,summary:()=>c.textContent}}function Iw({arm:n,trace:t,stray:e}){if(!t)return"Play draws a circle of this radius from where the tip is now; the tool keeps its orientation.";let i=yt(n).flatMap((r,o)=>t.some(a=>ti(n.rows[r],a[o]))?[`joint ${r+1}`]:[]),s=i.length?`${ni(i)} would have to pass ${i.length>1?"their limits":"its limit"} (tinted).`:"All joints stay within their limits.";return e>.001?`The whole circle is not within reach: the tip strays by up to ${Kt(1e3*e,0)} mm.`:s[0].toUpperCase()+s.slice(1)}var Xs={table:Pd,pose:Cd,jacobian:Rd,trace:Ld,torque:Id,branches:Ad,homework:Tg("homework","Play the homework")};function Pg(n,t,e){let i=new Map,s=g=>n.dispatch({type:"show",view:g}),r=t.length>1,o=t.map((g,_)=>U("button",{type:"button",role:"tab",id:`${e.id}-${g}`,"aria-controls":`${e.id}-panel`,onclick:()=>s(g),onkeydown:m=>h(m,_)},Xs[g].title)),a=U("div.view",{id:`${e.id}-panel`,...r?{role:"tabpanel"}:{}}),l=r?U("div.tabs",{role:"tablist","aria-label":"Views"},o):[],c=U("div.views",{},l,a);function h(g,_){let m={ArrowRight:_+1,ArrowLeft:_-1,Home:0,End:t.length-1}[g.key];if(m===void 0)return;g.preventDefault();let d=(m+t.length)%t.length;s(t[d]),o[d].focus()}function u(g,_,m){let d=g.view;i.has(d)||i.set(d,Xs[d].build(n,e));let y=i.get(d);a.firstChild!==y.root&&(a.replaceChildren(y.root),r&&a.setAttribute("aria-labelledby",`${e.id}-${d}`),o.forEach((w,M)=>{w.setAttribute("aria-selected",String(t[M]===d)),w.tabIndex=t[M]===d?0:-1})),y.update(g,_,m)}return{root:c,update:u,summary:(g,_)=>i.get(g.view)?.summary?.(g,_)??"",dispose:()=>i.forEach(g=>g.dispose?.())}}var Lw=1e3,Nw=400;function Ig(n,t){let e=U("p.hidden",{role:"status","aria-live":"polite"}),i=null,s=null,r=()=>n.activeElement!==null&&document.hasFocus();function o(a,l=!1){clearTimeout(i),i=setTimeout(()=>{!l&&!r()||(e.textContent=a(),clearTimeout(s),s=setTimeout(()=>e.textContent="",Nw+60*e.textContent.length))},Lw)}return t.addEventListener("abort",()=>{clearTimeout(i),clearTimeout(s)}),{region:e,say:o}}var Dw=450,Uw=300,Fw=100,Ow=["q","arm","wrench","ways","trace","dragging"],Bw=0;function Nd(n,t,{views:e,arms:i,wide:s=!1,makeLink:r=null}){let o=n.shadowRoot??n.attachShadow({mode:"open"}),a=new AbortController,{signal:l}=a,c=`explorer-${++Bw}`,{region:h,say:u}=Ig(o,l),f=Gw(t,l),p=U("p.notice",{role:"status",hidden:!0}),g=I=>{p.hidden=!I,p.textContent=I},_=r?.(g,l)??null,m={id:c,goTo:f,say:u,signal:l,tell:g,point:I=>t.dispatch({type:"show",lit:I})},d=Sg(t,m),y=bg(t,m),w=Pg(t,e,m),M=U("section.explorer"),E=ag(t,{...m,arms:i,link:_,stage:d,card:M});M.append(E.root,p,U("div.bench",{},d.root,y.root),w.root,h),M.classList.toggle("wide",s),o.replaceChildren(U("style",{},ah,og),M,U("div.paper",{},U("slot")));let T="light",x=()=>d.draw(t.state,t.derived,T),v=[({state:I})=>{M.setAttribute("aria-label",`Explorer of the ${I.arm.name}`.replace("the Your","your")),E.update(I),d.update(I)},({state:I})=>y.update(I),({state:I,derived:F})=>w.update(I,F,d.scale())],C=kw(Fw/v.length,l,v,t);md(I=>{T=I,M.dataset.theme=I,x()},l);let R=Vw(n,t,l);return t.listen(I=>{if(x(),t.state.dragging&&!I.has("dragging"))return C.soon();C.now(),R(),Ow.some(F=>I.has(F))&&!t.state.playing&&u(()=>zw(t,w))},l),x(),C.now(),()=>{a.abort(),d.dispose(),w.dispose(),o.replaceChildren()}}function kw(n,t,e,i){let s=null,r=0,o=0,a=()=>{clearTimeout(s),s=null},l=()=>{s=null,e[o](i),o=(o+1)%e.length,--r&&(s=setTimeout(l,n))};return t.addEventListener("abort",a),{now:()=>(a(),r=0,e.forEach(c=>c(i))),soon:()=>(r=e.length,s??=setTimeout(l,n))}}function zw({state:n,derived:t},e){let[i,s,r]=t.frames.at(-1).o.map(o=>Kt(o,3).replace("−","minus "));return`Tip at x ${i}, y ${s}, z ${r} metres. ${e.summary(n,t)}`.trim()}function Gw(n,t){let e=null,i=()=>{e&&cancelAnimationFrame(e),e=null};return t.addEventListener("abort",i),n.listen((s,r)=>r!=="glide"&&(s.has("q")||s.has("arm"))&&i(),t),s=>{i();let{q:r,arm:o}=n.state,a=`glide ${performance.now()}`,l=u=>n.dispatch({type:"glide",q:u,gesture:a},"glide");if(lr()||s.length!==r.length)return l(s);let c=performance.now(),h=u=>{if(e=null,n.state.arm!==o)return;let f=Math.min(1,Math.max(0,u-c)/Dw),p=f*f*(3-2*f);l(f===1?s:r.map((g,_)=>g+p*(s[_]-g))),f<1&&(e=requestAnimationFrame(h))};return e=requestAnimationFrame(h),!0}}function Vw(n,t,e){let i=null,s=()=>{clearTimeout(i),i=null;let{arm:r,q:o}=t.state,a=fd(r,o),l=dd(r,t.derived.frames,`Still picture of the ${a}`),c=n.querySelector(":scope > svg");c?c.replaceWith(l):n.prepend(l);let h=n.querySelector(":scope > .arm-explorer-caption");h&&(h.textContent=a)};return e.addEventListener("abort",()=>clearTimeout(i)),window.addEventListener("beforeprint",s,{signal:e}),()=>i??=setTimeout(s,Uw)}function Lg(n,t){if(!t)return null;let e=t.filter(({q:s})=>Je(n,s)),i=qt(n,e[0]?.q??n.rows.map(()=>0)).at(-1);return{list:e,families:[],held:-1,target:i,whole:Re(n)===6}}function Ng(n){let[t]=n.arms,e=n.views.filter(i=>Object.hasOwn(Xs,i));return od({arm:t,reference:n.reference??t,q:n.q,wrench:n.wrench,unit:n.unit,view:e[0],frames:e[0]==="table"?"all":"ends",trace:n.trace??null,ways:Lg(t,n.branches)})}function Hw(n){return n.explorer??=Ww(n),n.explorer}function Ww(n){let{figure:t,options:e}=n.dataset;if(t)return{dispose:Wo(n,{...JSON.parse(e??"{}"),figure:t})};let i=JSON.parse(n.querySelector("script[type='application/json']").textContent),s=new Ws(Ng(i)),r=i.link?(a,l)=>xf(s,i.arms,i.views,a,l):null,o=Nd(n,s,{...i,wide:i.link,makeLink:r});return{store:s,dispose:o}}var uc={q:{from:n=>n.q,field:"q"},wrench:{from:n=>n.wrench,field:"wrench"},trace:{from:n=>n.trace,field:"trace"},branches:{from:n=>n.ways?.list??null,field:"ways"},arm_name:{from:n=>n.base.name,field:"arm"},rows:{from:n=>n.arm===n.base?[]:n.arm.rows,field:"arm"}},Xw=50;function $w(n,t){let{arms:e}=n.get("_spec"),i=e.find(u=>u.name===n.get("arm_name"))??t.base,s=n.get("rows"),o=(s.length?qw(s,t.arm.rows)?t.arm:{name:Eo,home:[],rows:s}:null)??(t.base.name===i.name?t.base:i),a=t.base.name===i.name?t.reference:i,l=n.get("branches"),c=dc(l,t.ways?.list??null)&&t.arm===o,h=dc(n.get("trace"),t.trace)?t.trace:n.get("trace");return{arm:o,base:t.base.name===i.name?t.base:i,reference:a,q:[...n.get("q")],wrench:[...n.get("wrench")],trace:h,ways:c?t.ways:Lg(o,l)}}var dc=(n,t)=>JSON.stringify(n)===JSON.stringify(t),qw=(n,t)=>n===t||dc(n,t);function Yw(){let n=null;function t({model:i}){let s=i.get("_spec"),r=Object.fromEntries(["q","wrench","trace","branches"].map(p=>[p,i.get(p)]));n=new Ws(Ng({...s,...r}));let o=null,a=!1,l=()=>{o=null,a=!0;for(let[p,{from:g}]of Object.entries(uc)){let _=g(n.state);dc(i.get(p),_)||i.set(p,_)}a=!1,i.save_changes()},c=new Set(Object.values(uc).map(({field:p})=>p)),h=new AbortController;n.listen((p,g)=>{g!=="python"&&[...p].some(_=>c.has(_))&&(o??=setTimeout(l,Xw))},h.signal);let u=null,f=()=>{a||(u??=setTimeout(()=>{u=null,n.dispatch({type:"set",...$w(i,n.state)},"python")}))};for(let p of Object.keys(uc))i.on(`change:${p}`,f);return()=>{h.abort(),clearTimeout(o),clearTimeout(u);for(let p of Object.keys(uc))i.off(`change:${p}`,f)}}function e({model:i,el:s}){let r=document.createElement("div");r.dataset.lmSuppressShortcuts="true",s.append(r);let o=Nd(r,n,i.get("_spec"));return()=>{o(),r.remove()}}return{initialize:t,render:e}}var jw=()=>({render({model:n,el:t}){let e=document.createElement("div");e.dataset.lmSuppressShortcuts="true",t.append(e);let i=Wo(e,n.get("_spec"));return()=>{i(),e.remove()}}});return Hg(Zw);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
