var ArmExplorer=(()=>{var Ku=Object.defineProperty;var rM=Object.getOwnPropertyDescriptor;var oM=Object.getOwnPropertyNames;var aM=Object.prototype.hasOwnProperty;var ns=(n,t)=>{for(var e in t)Ku(n,e,{get:t[e],enumerable:!0})},cM=(n,t,e,i)=>{if(t&&typeof t=="object"||typeof t=="function")for(let s of oM(t))!aM.call(n,s)&&s!==e&&Ku(n,s,{get:()=>t[s],enumerable:!(i=rM(t,s))||i.enumerable});return n};var lM=n=>cM(Ku({},"__esModule",{value:!0}),n);var dB={};ns(dB,{figureWidget:()=>uB,getContextLoser:()=>p_,getUsage:()=>f_,mount:()=>iB,widget:()=>cB});var Gm=[0,0,-9.81],ot=(n,t)=>n[0]*t[0]+n[1]*t[1]+n[2]*t[2],Mt=(n,t)=>[n*t[0],n*t[1],n*t[2]],Dt=(n,t)=>[n[0]+t[0],n[1]+t[1],n[2]+t[2]],nt=(n,t)=>[n[0]-t[0],n[1]-t[1],n[2]-t[2]],kt=(n,t)=>[n[1]*t[2]-n[2]*t[1],n[2]*t[0]-n[0]*t[2],n[0]*t[1]-n[1]*t[0]],Ct=n=>Math.sqrt(n.reduce((t,e)=>t+e*e,0)),Vm=({x:n,y:t,z:e},i)=>[i[0]*n[0]+i[1]*t[0]+i[2]*e[0],i[0]*n[1]+i[1]*t[1]+i[2]*e[1],i[0]*n[2]+i[1]*t[2]+i[2]*e[2]],tc=({x:n,y:t,z:e},i)=>[ot(n,i),ot(t,i),ot(e,i)],go=(n,t)=>Dt(Vm(n,t),n.o),Hm=(n,t)=>tc(n,nt(t,n.o)),mo=(n,t,e,i)=>[n*t[0]+e*i[0],n*t[1]+e*i[1],n*t[2]+e*i[2]],hM=[[1,0],[0,1],[-1,0],[0,-1]];function Ka(n){let t=n/(Math.PI/2);return Math.abs(t-Math.round(t))>1e-12?[Math.cos(n),Math.sin(n)]:hM[(Math.round(t)%4+4)%4]}function ec(n){let t=new WeakMap;return({rows:e})=>{let i=t.get(e);return i||t.set(e,i=n(e)),i}}var et=ec(n=>n.flatMap(({kind:t},e)=>t==="fixed"?[]:[e])),pB=ec(n=>n.flatMap(({kind:t},e)=>t==="fixed"?[e]:[])),mB=ec(n=>et({rows:n}).map(t=>t+1)),nc=ec(n=>et({rows:n}).map(t=>n[t].kind==="revolute"));function It(n,t){let[e,i,s,r]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],o=[{x:e,y:i,z:s,o:r}],a=0;for(let c of n.rows){let l=c.kind==="fixed"?0:t[a++],[h,u]=Ka(c.kind==="revolute"?c.theta+l:c.theta),[d,f]=Ka(c.alpha),p=c.kind==="prismatic"?c.d+l:c.d;[e,i]=[mo(h,e,u,i),mo(h,i,-u,e)],r=Dt(mo(p,s,c.a,e),r),[i,s]=[mo(d,i,f,s),mo(d,s,-f,i)],o.push({x:e,y:i,z:s,o:r})}return o}var Qa=({x:n,y:t,z:e,o:i})=>[0,1,2].map(s=>[n[s],t[s],e[s],i[s]]).concat([[0,0,0,1]]);function Ie(n,t,e=t.at(-1).o){return et(n).map(i=>{let{z:s,o:r}=t[i];return n.rows[i].kind==="revolute"?[...kt(s,nt(e,r)),...s]:[...s,0,0,0]})}function ic(n,t){let e=$m(n,t);return et(n).map(i=>{let{z:s,o:r}=t[i],o=a=>n.rows[i].kind==="revolute"?kt(s,nt(a,r)):s;return e.reduce((a,{mass:c,centre:l,row:h})=>h<i?a:a-c*ot(Gm,o(l)),0)})}var Wm=(n,t)=>$m(n,t).reduce((e,{mass:i,centre:s})=>e-i*ot(Gm,s),0),$m=(n,t)=>n.rows.flatMap(({body:e},i)=>{if(!e)return[];let[s,...r]=e;return[{mass:s,row:i,centre:go(t[i+1],r)}]}),sc=(n,t)=>n.map(e=>e.reduce((i,s,r)=>i+s*t[r],0));function qm(n,t){let[e,i]=[Qa(n),Qa(t)],s=(a,c)=>e[0][a]*i[0][c]+e[1][a]*i[1][c]+e[2][a]*i[2][c],r=[0,1,2].map(a=>[0,1,2].map(c=>s(a,c))),o=Ct([r[2][1]-r[1][2],r[0][2]-r[2][0],r[1][0]-r[0][1]]);return Math.atan2(o,r[0][0]+r[1][1]+r[2][2]-1)}var Qu=["revolute","prismatic","fixed"],rc=16,oc=100,Xm=1e3,td="Your arm",jm=[["a",oc],["alpha",Xm],["d",oc],["theta",Xm]];function zs(n){if(!Array.isArray(n)||!n.length)return"the table has no rows";if(n.length>rc)return`the table has ${n.length} rows; ${rc} are the most`;for(let[t,e]of n.entries()){if(!Qu.includes(e?.kind))return`row ${t+1} neither turns, slides nor is fixed`;for(let[i,s]of jm){if(!Number.isFinite(e[i]))return`row ${t+1} has no number for ${i}`;if(Math.abs(e[i])>s)return`row ${t+1} has ${e[i]} for ${i}; ${s} is the most`}}return null}var ac={lower:null,upper:null,speed:null,effort:null},uM=({kind:n,a:t,alpha:e,d:i,theta:s},{lower:r,upper:o,speed:a,effort:c})=>({kind:n,a:t,alpha:e,d:i,theta:s,lower:r,upper:o,speed:a,effort:c}),cc=(n,t)=>n.kind===t.kind&&jm.every(([e])=>Math.abs(n[e]-t[e])<1e-12),dM=(n,t)=>t&&cc({...n,a:t.a,d:n.kind==="prismatic"?n.d:t.d},t);function fM(n,t){for(let e=0;e<=n.length-t.length;e++){let i=(s,r)=>dM(s,t[r-e])||!t[r-e]&&s.kind==="fixed";if(n.every(i))return e}return-1}function Gs(n,t){if(n.length===t.rows.length&&n.every((o,a)=>cc(o,t.rows[a])))return t;let e=fM(n,t.rows),i=o=>e<0?ac:t.rows[o-e]??ac,s=n.map((o,a)=>uM(o,i(a))),r={name:td,home:[],rows:s};return{...r,home:ed(t,t.home,r,o=>o-Math.max(0,e))}}function ed(n,t,e,i){let s=new Map(et(n).map((r,o)=>[r,[n.rows[r].kind,t[o]??0]]));return et(e).map(r=>{let[o,a]=s.get(i(r))??[];return o===e.rows[r].kind?a:0})}var is=n=>yn(n,n.home)?[...n.home]:et(n).map(()=>0),yn=(n,t)=>Array.isArray(t)&&t.length===et(n).length&&t.every(Number.isFinite);function Hn(n){let t=n.kind==="revolute"?Math.PI:1;return[n.lower??-t,n.upper??t]}var mi=(n,t)=>t<(n.lower??-1/0)-1e-9||t>(n.upper??1/0)+1e-9,xo=n=>et(n).some(t=>n.rows[t].lower!==null||n.rows[t].upper!==null),mr=n=>n.rows.reduce((t,e)=>t+Math.abs(e.a)+Math.abs(e.d)+(e.kind==="prismatic"?Math.abs(e.upper??.3):0),0)||.3;var pM=1e-12,mM=[.37,.81].map(n=>Array.from({length:16},(t,e)=>n+Math.sin(1+2.3*e))),nd=new WeakMap;function Li(n){if(!nd.has(n.rows)){let t=mM.flatMap(i=>Ie(n,It(n,i))),e=i=>t.some(s=>Math.abs(s[i])>pM);nd.set(n.rows,[0,1,2,3,4,5].filter(e))}return nd.get(n.rows)}var id=n=>Li(n).filter(t=>t<3),gM={"0,1,5":[0,-.05,1],"0,2,4":[0,-1,.05],"1,2,3":[1,0,.05]},sd=n=>gM[Li(n).join()]??null,lc=n=>sd(n)!==null;function cn(n){let t=Li(n);if(t.length<=et(n).length)return t;let e=id(n);return e.length<3&&e.length<=et(n).length?e:[0,1,2]}var Vs=n=>cn(n).some(t=>t>=3),vn=(n,t)=>t.map(e=>n[e]);var hc=(n,t)=>n.rows.length===t.rows.length&&n.rows.every(({kind:e},i)=>e===t.rows[i].kind);function uc({base:n,reference:t},e,i){let s=e.map((r,o)=>xM(t.rows[o],r,i));return{arm:Gs(s,n),blended:i<1?{rows:e,share:i}:null}}function xM(n,t,e){if(e===1)return t;let i=(r,o=0)=>n[r]+e*(t[r]-n[r]-2*Math.PI*o),s=r=>i(r,Math.round((t[r]-n[r])/(2*Math.PI)));return{...t,a:i("a"),alpha:s("alpha"),d:i("d"),theta:s("theta")}}function R(n,t={},...e){let[i,...s]=n.split("."),r=document.createElement(i);i==="button"&&(r.type="button"),s.length&&(r.className=s.join(" "));for(let[o,a]of Object.entries(t))o.startsWith("on")?r.addEventListener(o.slice(2),a):a!==void 0&&a!==!1&&r.setAttribute(o,a===!0?"":a);return r.append(...e.flat()),r}function Pe(n,t={},...e){let i=document.createElementNS("http://www.w3.org/2000/svg",n);for(let[s,r]of Object.entries(t))i.setAttribute(s,r);return i.append(...e),i}var Rn=(n,[t,e],i={})=>R("input",{type:"range",min:t,max:e,step:"any","aria-label":n,...i});function Ot(n,t){n.textContent!==t&&(n.textContent=t)}function oe(n,t,e){n.getAttribute(t)!==e&&n.setAttribute(t,e)}var Te=(n,t)=>[R("i",{},n),R("sub",{},String(t))];async function dc(n){try{return await navigator.clipboard.writeText(n),!0}catch{return!1}}var gr=(n,t)=>R("div.scroll",{tabindex:0,role:"region","aria-label":n},t),fc=()=>matchMedia("(prefers-reduced-motion: reduce)").matches;function ss(n,t,e){let i=Object.entries(t).map(([s,r])=>R("option",{value:s},r));return R("select",{"aria-label":n,onchange:s=>e(s.target.value)},i)}var gi=n=>n.map(t=>Number(t.toFixed(6))+0).join(","),Ym=n=>n.map(({kind:t,a:e,alpha:i,d:s,theta:r})=>`${t[0].toUpperCase()},${gi([e,i,s,r])}`).join(";");var Jm=(n,t)=>({rows:n.rows,q:t,at:et(n),turns:nc(n),dof:t.length});function Zm(n,t,e={}){let{axis:i=n.at,origin:s=n.at,subtracted:r=!0,point:o=t.length-1,slides:a=!0,crossed:c=!0}=e,l=t[o].o,h=new Array(6*n.dof);return n.at.forEach((u,d)=>{let[f,p]=[t[i[d]].z,t[s[d]].o],m=n.turns[d]||!a,g=r?nt(l,p):l,x=m?c?kt(f,g):g:f;for(let _=0;_<3;_++)h[_*n.dof+d]=x[_],h[(_+3)*n.dof+d]=m?f[_]:0}),h}var Km=(n,t)=>[...n.slice(0,n.length/2),...t.slice(t.length/2)];function nn(n,t=6){let e=Array.from({length:t},(r,o)=>n.map(a=>a[o])),i=Array.from({length:t},(r,o)=>Array.from({length:t},(a,c)=>+(o===c)));for(let r=0,o=!0;o&&r<30;r++){o=!1;for(let a=0;a<t;a++)for(let c=a+1;c<t;c++)o=_M(e,i,a,c)||o}let s=e.map((r,o)=>[Math.hypot(...r),o]).sort((r,o)=>o[0]-r[0]);return{values:s.map(([r])=>r),vectors:s.map(([,r])=>i[r])}}function _M(n,t,e,i){let[s,r,o]=[0,0,0];for(let h=0;h<n[e].length;h++)s+=n[e][h]*n[e][h],r+=n[i][h]*n[i][h],o+=n[e][h]*n[i][h];if(Math.abs(o)<=1e-15*Math.sqrt(s*r)||o*o<1e-60)return!1;let a=(r-s)/(2*o),c=(a<0?-1:1)/(Math.abs(a)+Math.sqrt(1+a*a)),l=1/Math.sqrt(1+c*c);for(let h of[n,t])for(let u=0;u<h[e].length;u++){let[d,f]=[h[e][u],h[i][u]];h[e][u]=l*(d-c*f),h[i][u]=l*(c*d+f)}return!0}function Qm(n){let t=n.length;if(n.some(s=>s.length!==t))return null;let e=n.map(s=>[...s]),i=1;for(let s=0;s<t;s++){let r=od(e,s,s);if(e[r][s]===0)return 0;r!==s&&([e[r],e[s],i]=[e[s],e[r],-i]),i*=e[s][s];for(let o=s+1;o<t;o++)ad(e[o],e[s],s)}return i}var rd=(n,t)=>n.map((e,i)=>e-t[i]);function xr(n,t){let e=n.map((s,r)=>[...s,t[r]]),i=e.length;for(let s=0;s<i;s++){let r=od(e,s,s);[e[r],e[s]]=[e[s],e[r]];for(let o=0;o<i;o++)o!==s&&ad(e[o],e[s],s)}return e.map((s,r)=>s[i]/s[r])}function tg(n){let t=n.map(i=>[...i]),e=0;for(let i=0;i<6&&e<t.length;i++){let s=od(t,e,i);if(!(Math.abs(t[s][i])<1e-6)){[t[s],t[e]]=[t[e],t[s]];for(let r=0;r<t.length;r++)r!==e&&ad(t[r],t[e],i);e++}}return t.map(i=>i.map(s=>s/Math.hypot(...i)))}function od(n,t,e){let i=t;for(let s=t;s<n.length;s++)Math.abs(n[s][e])>Math.abs(n[i][e])&&(i=s);return i}function ad(n,t,e){let i=n[e]/t[e];for(let s=0;s<n.length;s++)n[s]-=i*t[s]}function xi(n,t=-1){let e=n.map((a,c)=>c).filter(a=>a!==t);if(!e.length)return[];let i=n[0].map((a,c)=>e.map(l=>n[l][c])),{values:s,vectors:r}=nn(i,e.length),o=1e-5*Math.max(s[0],1e-12);return r.filter((a,c)=>s[c]<=o).map(a=>n.map((c,l)=>l===t?0:a[e.indexOf(l)]))}var eg={"too long":"{what} has {count} characters, and at most 2 000 000 are read: paste the numbers alone","many numbers":"{what}: I find {count} numbers; expected: {wanted}. Write your answer alone","many lines":"{what}: the text has {count} lines; expected: {wanted}. Write your answer alone",empty:"{what} is empty; paste or type your numbers","no block":"{what}: I find no list of numbers there; write {wanted}","shape beside":"{what}: I read {shape} numbers where {wanted} are asked for, and other numbers stand beside them; write your answer alone",unfilled:"{what}: {line} has no number yet; write it, or delete the missing entries at the end; expected: {wanted}","other quantity":"{what}: the numbers at {line} are called another quantity; write your answer under its own name","two units":"{text} has two values that differ, so I give no verdict; leave one of them",computed:"{what}: '{text}' beside your numbers would change them, and I do not compute it; write the final numbers","misfit unit":"{what}: '{text}' has a unit that joint {joint} cannot have; write angles in rad or deg, lengths in m or mm, torques in N m, forces in N","joint twice":"Joint {joint} is named more often than another joint; name each joint once","contrary value":"{quoted} gives {name} another value than the question; delete it, or write your answer in numbers","contrary order":"The columns do not fit your words {quoted}, so I give no verdict; delete these words, or write the columns in their order",words:"I do not use the words {words} in line {line}, and they may change what your numbers mean, so I give no verdict; write the numbers as you mean them and delete these words, or choose the fitting setting beside the form","mixed units":"{what}: {text} has no unit, and other angles are in degrees; write one unit for all angles","other unit":"{what}: I do not convert the unit '{unit}'; write angles in rad or deg, lengths in m or mm, torques in N m",unread:"I cannot read {word} in line {line}{where} of {what}, so I give no verdict; write a plain number there, or put # before it if it is no entry of your answer","unfilled row":"{line} stands in place of a row of numbers; type its numbers, or only the rows before it","rows in two units":"Some lines are in rad and some in deg, as {line}; write your answer in one unit","no fit":"I find {found}, {numbers}, at {line}; expected: {wanted}. Write a row on each line, with blanks or commas between","old answer":"{what}: I can read one list only, at {line}, and the words before it call it an old one. Write your answer as plain numbers","drawn formula":"{what}: in line {line}, {quoted}, a power, a root or a fraction is drawn over several lines, which I cannot read; print the numbers on one line each, as evalf() gives them",which:"I find several answers that differ, at {blocks}; choose one of them, or delete the others",commas:"'{pair}' may be {decimal}, or {first} and {second}, and I cannot tell which; write a point in decimal numbers, or a blank between two numbers","no solution":"Your text says that there is no solution; write the joint values that you found","doubtful sign":"A ~ stands before a number; write - if it is a minus sign, or delete it",complex:"I find complex numbers, but joint values and torques are real; check what is under the root",unclaimed:"I cannot tell what {word} in line {line}{where} of {what} belongs to, so I give no verdict; put # before it if it is no entry of your answer, or write your answer alone","no text":"I cannot read this as text; paste the numbers as plain text","set aside":"lines set aside: {texts}","taken: by names":"in the order that your names say","taken: decimal":"numbers with decimal commas","taken: separators":"numbers with commas between them","taken: linear rows":"linear rows in {unit}","taken: moments":"torques in {unit}","taken: radians":"angles in radians","more than a turn":"{joint} = {value} rad is more than a whole turn. Is it in degrees?","and also":"{first}; also, {second}",or:"{first}; or {others}, which gives the same numbers here","cut print":"the print was cut: dots stand where numbers should; print all of it (NumPy: np.set_printoptions(threshold=sys.maxsize))","arm.other":"This is right for {other}, whose lengths are {others} mm. The question asks for {arm}, with {lengths} mm.","at configuration":" at q = ({q})",column:"column {column}",joint:"joint {joint}",entry:"entry ({row}, {column})",answer:"answer {number}",cut:"some of your numbers are cut off where they should be rounded up. This counts as right; round them next time","to your digits":", to the digits you gave","two signs":"± stands before a number, and each entry must be one number: write each solution on its own line, or delete the ± and the tolerance after it","no load":"{arm} has no masses and no wrench, so every torque is 0; give the force and the moment on its tool","each joint":"one value for each of {joints}","joint zero":"{arm}: joints count from 1 here, so there is no {name}; write {first} for it, and raise the number of every other joint by one","unknown symbol":"{arm}: no value for {name}; known are {known}","unknown joint":"{arm}: no value for {name}; known are {known}. Joints are numbered by their rows, and row 1 is fixed","symbols for numbers":"{names} has no value here; write numbers","not finite":"{what}: one of the numbers is NaN or infinite; expected {wanted}","no numbers":"{what} is {given}; expected {wanted}","no matrix":"{what} has {given}; expected a matrix of finite numbers","ragged list":"{what} has rows of unequal length; expected rows of one length","J needs q":"your Jacobian has numbers, which belong to one configuration only; give its q too","unknown column":"I do not know the column {header}, and a table needs a, alpha, d and theta; name these four columns","stated degrees":"your text says that angles are in degrees, and the table holds {angle}; write all angles in one unit","stated radians":"your text says that angles are in radians, and the table holds {angle}; write all angles in one unit","two angles":"the table holds {one} and {other}, one in degrees and one in radians; write all angles in one unit, or choose the unit","no link matrix":"A_{i} is no link matrix: its entry in row {row}, column {column} does not fit the others. Multiply out Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha) again","table.transposed":"The rotation of A_{i} is transposed: its first column is (cos theta, sin theta, 0)","table.names":"Row {row} has the variable {name}: write the variable of joint i in row i","row torn":"the line {line} stands among the rows, and I read {count} entries there: {entries}; a row has {width}, so write each entry as a number, a symbol or 0","no rows":"I find no rows of four entries in {given}; write a line for each joint with its a, alpha, d and theta, and commas or blanks between","link sigma":"in {given}: expected theta, d, a, alpha, then 0 for a joint that turns or 1 for one that slides, then its offset","link order":"in {given}: the order of the arguments is not the same in all programs; write their names, as in {call}(d=0.3, a=0, alpha=pi/2)","uneven lists":"the table's lists have {counts} entries; expected as many in each","no columns":"columns are {given}; expected the four of 'theta d a alpha' in your order","many branches":"I find {count} joint vectors; expected: one for each branch, at most {most}","table size":"at most {most} rows of four entries","many rows":"the table has {count} rows; expected at most {most}","row width":"the table's rows have {widths} entries; expected four, a alpha d theta in some order","two tables":"your text holds two tables, one below the other: the joints of the first stand in the second once more; delete one of them","names in two units":"{what}: some names or headers say degrees and others radians; write all angles in one unit","two statements":"your text states two {what}, {given}; leave one of them","half craig":"of the column headers {headers} one has the index i-1 and the other has not; write both with i-1 for Craig's convention, or both with i","half order":"{quoted} names three of the four columns; name all four, in their order","unit seen":"your text shows the unit {unit}, and I cannot tell which lengths it belongs to; write the unit in the column headers, as a [{unit}], or choose the unit of lengths","short rows":"{headers} column headers stand above rows of {count} entries that I can read; write an entry below each header, q_i for a joint's variable","cell lines":"the table has each cell on a line of its own: {columns} column headers and below them {count} cells{behind}, which is no whole number of rows; write each row on one line, and 0 in empty cells","two factors":"{one} and {other} give the same name two values, so I give no verdict; delete one of them","two lengths":"{name} has two values in {what}: {one} in line {line}, {other} in line {otherLine}; delete one of them","row two values":"row {row} has two values for {name}: {one} and {other}; write one","two lists":"the table has two lists of {name}: {one} and {other}; delete one of them","row lacks":"row {row} has no {name}, but another row has one; write 0 where it is 0","rows reversed":"the rows of your table are numbered from {count} down to 1; write them from row 1 on","row number":"{text} stands in the column that numbers the rows of your table; write a whole number there, or a name","row symbol":"row {row}: no value for {name}","row slope":"row {row}: {name} changes by {rate} times its joint's value; expected the joint's value itself, added or subtracted","taken: columns":"columns {columns}","order of columns":"are these the {taken}? Write a row with the names of its columns first, such as a, alpha (deg), d (mm), theta","taken: millimetres":"lengths in millimetres","taken: degrees":"angles in degrees","taken: empty":"empty cells as 0","taken: lengths":"lengths in {unit}","taken: standard":"the standard convention","taken: craig":"the modified (Craig) convention, turned into the standard one","joints renumbered":"your {names} {is} {numbers} here, since joints are numbered by their rows","joints renumbered by fixed rows":"your {names} {is} {numbers} here, since row {rows} is fixed","is one":"is","are many":"are","likely craig":"row 1 has a = 0 and alpha = 0, as in Craig's convention; write convention='craig' if a and alpha are those of the link before (a_(i-1)), else convention='standard'","left out: columns":"columns left out: {columns}","taken: backwards":"joints that count backwards in {rows}, which is your free choice","taken: fixed":"{rows} without a joint of its own, since every joint has its row already",row:"row {row}",rows:"rows {rows}","taken: matrices":"4 x 4 matrices A_i","taken: links":"Link lines","taken: no theta":"each theta as the joint's own angle, since there is no list of theta","taken: angular first":"rows (omega, v)","taken: half":"the three {half} rows","taken: planar rows":"rows {names} of a planar arm","taken: movable rows":"rows {names}, the motions that this arm has","taken: locked":"all joints; {joints} is locked, so its {values} is set aside","J right":"The Jacobian of {arm} is right{where}{precision}.","J half right":"The {half} rows of the Jacobian of {arm} are right{where}{precision}; the {other} ones are missing.","still missing":"Still missing: {missing}.","J first rows":"The Jacobian of {arm} is right so far: {count} of {all} rows.","J first columns":"The Jacobian of {arm} is right so far: {count} of {all} columns.","J half missing":"Add the three {other} rows.","J so far":"The Jacobian of {arm} is right so far{where}. With these digits the right answer and a common mistake look alike: give two more.","J rounded":"The Jacobian of {arm} is right{where} except for the last digit in {places}, which is one off: round only at the end.","J wrong":"The Jacobian of {arm} is not right: {cause}.","J wrong everywhere":"The Jacobian of {arm} is not right in any column, and I know no mistake that explains it. Begin with column 1: {question}","J turns":"which axis does joint {joint} turn about, and how far from it is the tip?","J slides":"along which axis does joint {joint} slide?","J zero":"Every entry is 0: fill it in.","J wrong places":"The Jacobian of {arm} is not right in {places}.","J hidden":"at this configuration {count} of {all} usual mistakes would not change the Jacobian{other}","J try":": try q = ({q}) too","J column":"Column {column} (joint {joint}): {words}.","J.entry signs":"the sign of {rows} is wrong","J.entries":"check {rows}","J.column of":"The column of joint {i} is a copy of that of joint {joint}","J.other column":"this is the column of joint {joint}","J.shape":"Its shape is {shape}; give 6x{dof}: rows vx, vy, vz, wx, wy, wz, and a column for each free joint","J.row for column":"You deleted a row where you should delete a column: a locked joint has no column, and all six rows stay","J.locked column kept":"Delete the column of the locked joint; all other columns are right","J.transposed":"It is transposed: give one column for each joint, six rows","J.halves":"Linear and angular rows are exchanged","J.space":"This is the space Jacobian: its linear rows are the velocity of the tool's point at the base's origin. For the tip add omega x o_n","J.cross":"The factors of the cross product are in the wrong order: take z x (o_n - o), not (o_n - o) x z","J.all signs":"Every sign is reversed","J.angular zero":"The angular rows are zero: a joint that turns contributes its axis z_{i-1}","J.linear zero":"The linear rows are zero: a joint that turns contributes z_{i-1} x (o_n - o_{i-1})","J.millimetres":"The linear rows are in millimetres: use metres","J.degrees":"Degrees and radians of q are mixed up: sine and cosine take radians, so write q in radians, or choose the unit that it has","J.not summed":"The angles of parallel joints are not added up: on axes 1 and 2 the second link stands at q_1 + q_2 (s_12), not at q_2 (s_2)","J.z_i angular":"The angular rows have z_i: put z_{i-1} there, for joint i turns about the axis of the frame before it","J.z_0 angular":"Every angular column is z_0: column i needs its own joint's axis, z_{i-1}","J.one frame late":"Axes and origins are taken one frame too late: joint i has z_{i-1} and o_{i-1}, not z_i and o_i","J.z_i":"The axes are taken one frame too late: joint i turns about z_{i-1}, not z_i","J.origin late":"The lever arm starts at o_i: start it at o_{i-1}, a point on the joint's axis","J.lever tip":"The lever arm is o_n alone: subtract o_{i-1}, the point on the joint's axis","J.no cross":"The linear rows hold the lever arm itself: cross it, z_{i-1} x (o_n - o_{i-1})","J.rows of T":"You read axes and origins from the rows of T: they stand in its columns","J.point":"The linear rows are the velocity of o_{k}, not of the tip: take o_n","J.slide angular":"The angular rows of a joint that slides hold its axis: they should be 0","J.wrong column deleted":"You deleted column {column} instead of the locked joint's column","J.reversed order":"The columns run from the tip to the base: put joint 1 first","J.columns exchanged":"The columns of joints {i} and {j} are exchanged","J.frame":"The rows are in the axes of {_name}: transform them into those of {_wanted}","table.pen":"The pen is forgotten: the tip is l_pen farther out","table.pen sign":"The pen's length has the wrong sign: the tip is l_pen farther out","table.offsets":"The offsets of theta are forgotten: add q_i to them","table.offset":"The offset of theta in row {row} is forgotten","table.twist":"The twist alpha in row {row} has the wrong sign","table.no twist":"The twist alpha in row {row} is missing","table.craig rows":"Rows of a Craig table, with a_{i-1} and alpha_{i-1}, stand in the standard matrix: use one convention throughout","table.a exchanged":"The lengths a of rows {i} and {j} are exchanged","table.d exchanged":"The lengths d of rows {i} and {j} are exchanged","table.sign":"{column} in row {row} has the wrong sign","table.missing":"{column} in row {row} is missing","table.length":"{name} is taken as long as {other}","table too much":"{column} in row {row} should be 0","table entry angle":"{column} in row {row} is {off}° off","table number":"{column} in row {row} is {off} mm {way}","table.robot":"The lengths are those of the {name}, another robot of nearly the same name; take them from the data sheet of yours","table.alpha and theta":"The alpha and theta columns are exchanged","table.a and d":"The a and d columns are exchanged","table.a and d in row":"a and d of row {row} are exchanged","table.craig":"The rows are in the modified (Craig) convention; convert them","table.into craig":"The a and alpha columns stand one row too high","table.rows exchanged":"Rows {i} and {j} are exchanged","your table":"Your table","own joints":"{arm}, in your joints","course.tip millimetres":"The position is in millimetres: use metres","course.tip transposed":"The rotation is transposed: its columns are the tip's axes, seen from the base","course.entry":"{column} in row {row} is wrong, and all other entries are right","table same":"{mine} describes the same arm as {reference}.","table right by map":"{mine} describes the same arm as {reference}, with other zeros or directions of its joints.","table other base":"{mine} has the joint axes of {reference}, but {fault}.","table other base because":"{mine} has the joint axes of {reference}, but {fault}: {cause}.","table tool turned":", with the tool turned by {degrees}°","table first rows":"{mine} is right so far: its rows describe the first joints of {reference}.","table rounded":"{mine} describes the same arm as {reference} but for the last digit of its lengths.","table other arm":"{mine} does not describe the same arm as {reference}.","table wrong":"{mine} does not describe the same arm as {reference}: {cause}.","and what remains":"; something else is wrong as well",perhaps:"perhaps {cause}",map:"The reference counts these joints differently: {equations}","map start":"at the start, your joint values are ({start})","map mistake":"if you meant the zeros and directions of the reference, {cause}","map rounded":"the last digit of a length differs","map table reference":"joint of the reference","map table own":"in your joints","map table start":"its start value","map table own start":"your start value","map joint":"its q_{joint} is your q_{mine}{tail}","map back":"its q_{joint} is -(your q_{mine}){tail}","no joint map":"no choice of zeros and directions of its joints makes its tip move like the reference's","base upside down":"your z_0 points the other way along axis 1, so the arm hangs from its base",base:"the base frame of your table is {height} mm {way} along axis 1 than the reference's (see d in row {row})","start configuration":"the question says where the tool is at q = {start}, and the tip of your table is {away} m away from there{turned}",higher:"higher",lower:"lower",tool:"the angle between the last joint axis and the last frame's z axis is {mine}° in yours and {reference}° in the reference (alpha in row {row})","tool turned":"where the tips meet, your last frame is turned by {degrees}° about its z axis","tool reversed":"the z axis of your last frame points the other way along the last joint axis","right angle":"{column} in {rows}, {typed}, is taken as {wanted}","write right angle":"{angles}; write it so","write right angles":"{angles}; write them so","table entry":"{words} (you have {typed}).","table at":"Row {row}, {entry}: {words}.","the tip":"the tip",axis:"axis {i}","parallel axes":"the parallel axes {i} to {j}, added up,","table distance what":"the distance from axis {start} to {end}","table lean what":"the angle from z_0 to axis {j}","table foot what":"the distance from z_0 to axis {j}","table between what":"the twist from axis {start} to axis {j}","table along what":"the offset along {along}","table count words":"The number of joints is {mine} in yours and {reference} in the reference: each joint needs a row with its variable. If you locked one on purpose, compare with the arm that has it locked.","table kind what":"the joint","table other":"{what} is {mine} in yours and {reference} in the reference","table angle":"{what} is {mine}° in yours and {reference}° in the reference: {off}° off","table slide":"the axes before and after the slide lie otherwise about it than in the reference: check theta here, and the signs in the rows beside it","table other way":"{what} is {mine} m in yours and {reference} m in the reference: it has the opposite direction, so a sign is wrong here or in a row beside it","table length":"{what} is {mine} m in yours and {reference} m in the reference: {off} mm {way}",long:"too long",off:"off",short:"too short","taken: list per joint":"one list for each joint, transposed into one row for each configuration","taken: masses":"links of {masses} kg under g = {g} m/s²","taken: no masses":"links without masses, so that the wrench alone loads the joints","tau right":"The torques of {arm} are right{precision}.","tau so far":"The torques of {arm} are right so far. With these digits the right answer and a common mistake look alike: give two more.","tau first joints":"The torques of {arm} are right so far: {count} of {all} joints.","tau rounded":"The torques of {arm} are right except for the last digit at {places}, which is one off: round only at the end.","tau wrong":"The torques of {arm} are not right: {cause}.","tau wrong places":"The torques of {arm} are not right at {places}.","tau other way":"Joint {joint}: the sign is wrong.","tau off":"Joint {joint}: off by {most}{off} {unit}.","up to":"up to ","tau.energy":"Your list has one number for each configuration, as the potential energy has: the torques are its derivatives, one for each joint.","tau.shape":"Its shape is {shape}; give {wanted}, one torque for each of {dof} joints.","tau.degrees":"Degrees and radians of q are mixed up: sine and cosine take radians, so write q in radians, or choose the unit that it has","tau.weight missing":"The weight is missing: tau = g - J^T F","tau.weight sign":"The weight has the wrong sign: g(q) = dP/dq, and P grows with height","tau.gravity":"You seem to have used g = {g}; here it is {_here}","tau.paper centres":"The centres of mass are those that the paper prints, in the paper's frames: transform them into the frames of your table","tau.lumped":"Links {_links} are lumped into one uniform bar, as in {_report}: here each link has its own mass and centre","tau.report":"This is the model of {_report}, with links {_links} lumped and g = {_g}: here each link has its own mass and centre, and g is {_here}","tau zero":"Every torque is 0: fill them in, or add the load you forgot.","tau.own link":"In your model each joint carries only its own link: it has to carry all links after it too","tau.masses moved":"The masses are shifted by one link: use each link's own mass","tau.mass missing":"The mass of link {link} is missing","tau.masses exchanged":"The masses of links {i} and {j} are exchanged","tau.exchanged":"The torques of joints {i} and {j} are exchanged","tau.robot":"The masses are those of the {name}, another robot of nearly the same name: take them from the data sheet of yours","tau.force sign":"The force has the wrong sign: F is the force of the world on the tool, so tau = g - J^T F","tau.force missing":"The force is missing: tau = g - J^T F","tau.force in tool":"The force is in the tool's axes: transform it into base axes first","tau.J for J^T":"You multiplied the force by J: multiply it by the transpose, J^T F","tau.all signs":"Every sign is reversed","tau.makers signs":"The signs at joints {_joints} are the maker's, who counts these joints in the other direction: change them","tau.reversed order":"The torques run from the tip to the base: put joint 1 first","one answer":"{arm}: there are {count} answers; expected one","pose shape":"{what} has {given}; expected {wanted}","a pose":"the three or four rows of a pose","a point or a pose":"a point x, y, z, or the three or four rows of a pose","taken: answer per column":"one answer in each column","ik right":"Your joint angles for {arm} are right and complete.","ik rounded":"Your joint angles for {arm} are right and complete except for a last digit: round only at the end.","ik so far":"Your joint angles for {arm} are right so far: {count} of {all} branches.","ik first joints":"Your joint values for {arm} are right so far: {count} of {all} joints.","ik so far digits":"Your joint angles for {arm} are right so far. With these digits a common mistake would look the same: give two more.","ik wrong":"Your joint angles for {arm} are not right: {cause}.","ik some wrong":"Your joint angles for {arm} are not all right: {count} of {all} branches are found.","ik none":"No joint angles of {arm} reach this target.","ik one side":"All your answers have the shoulder on one side. Turn joint 1 by 180° and solve θ2 and θ3 again.","ik twice":"Answers {numbers} are the same up to whole turns","ik missing":"Missing: {names}.","ik together":"here only {count} of the {all} branches differ, since some coincide","ik free":"{joint} is free here: it may have any value, and the other joints follow. So there are infinitely many answers, and one of them counts for all","ik out of range":"the missing branches are beyond the range of {joints}, where the arm cannot go","ik no branch":"Answer {number} cannot be right: no joint angles reach this target.","ik unlisted":"Answer {number} reaches the target, but it is none of the branches in the list of solutions.","ik off":"misses the target by {millimetres} mm{turn}","ik turn":" and {degrees}°","ik answer":"Answer {number} {off}: {words}.","ik found":"Found: {name}.","ik mixed":"two branches are mixed: {joints} from '{other}', all others from '{most}'","ik in no branch":"{joints} belong to no branch","ik one in no branch":"{joints} belongs to no branch","ik.degrees":"The angles are in degrees: write radians","ik.radians":"The angles are in radians: write degrees","ik.makers signs":"The signs of joints {_joints} are the maker's, who counts them in the other direction: change them","ik.reversed order":"The joints run from the tip to the base: put joint 1 first","ik.sign":"{joint} has the wrong sign","ik.joint degrees":"{joint} is in degrees: write radians","ik.joint millimetres":"{joint} is in millimetres: write metres","pose joint":"Only {joint} is wrong, by about {off} {unit}.","ik.exchanged":"{first} and {second} are exchanged","ik.half turn":"{joint} is half a turn off: use atan2, not atan","ik.other axis":"{joint} is pi/2 minus the right angle: take atan2(y, x), not atan2(x, y)","ik.supplement":"{joint} is pi minus the right angle: check the sign in the law of cosines","ik.offset":"{joint} is a quarter turn off: check the offset of theta in its row","ik.quarter turn":"θ1 = ±π/2 holds only for a target on axis 1 and an arm without an offset d. With d, θ1 has two other values, one for each side of the shoulder","ik.plus for minus":"In the formula for θ2 you added the second atan2: subtract it","ik.mixed":"The joints belong to different branches: if you change the side of the shoulder or elbow, the joints after it change too","ik.shoulder":"θ1 belongs to one side of the shoulder, and θ2 and θ3 to the other: take all from one side","ik.one sign":"All your answers have {joint} with the same sign: acos and the square root have two signs, so take the other as well.","pose right":"These joints take the tip of {arm} to the target.","pose rounded":"These joints take the tip of {arm} to the target except for a last digit: round only at the end.","pose so far":"These joints may take the tip of {arm} to the target. With these digits a common mistake would look the same: give two more.","pose wrong":"With these joints the tip of {arm} {off}.","pose cause":"With these joints the tip of {arm} {off}: {cause}.","pose.millimetres":"The target is in millimetres: write metres","pose.half turn":"The target's frame is turned by 180° about its z axis: two of its axes are reversed","pose entry":"Entry ({row}, {column}) of T is wrong.","pose coordinate":"The {axis} coordinate of the point is wrong.","pose.transposed":"The rotation of the target is transposed","beyond limits":"{joints} would be beyond the range of the real arm","taken: times":"joint values after a first column of times","trace right":"{arm} draws the path.","trace right by euler":"{arm} draws the path, up to the error of Euler's method.","trace euler drift":"the tip is up to {error} mm off the path. That is the drift of Euler's method with {steps} steps: twice the steps halve it","trace so far":"{arm} draws the path so far: {count} of {all} rows.","trace rows left out":"I find {count} rows, and the path has {all} times: rows between them are left out; type a row for each time, or only the first rows","trace wrong":"{arm} does not draw the path: {cause}.","trace where":"The tip is up to {error} mm from where it should be, at step {step} of {steps}; at the start it is {start} off.",already:"already","trace leans":"The tool leans by up to {degrees} degrees.","trace spins":"The tool turns about its own axis by up to {degrees} degrees.","joint by":"joint {joint} by {by} {unit}","trace beyond range":"beyond the real arm's range: {joints}","trace beyond speed":"beyond the real arm's speed: {joints}","trace.shape":"Its shape is {shape}; expected {rows}x{dof}, one row for each of the path's times.","trace.degrees":"The joints are in degrees: write radians","trace.radians":"The joints are in radians: write degrees","trace.one more":"There is one step too many: N steps are i = 0 ... N - 1, and with the start they give N + 1 rows.","trace.jump":"From step {step} to {to} joint {joint} jumps by {by} (such steps: {count}): the solution changes its branch, or a singular configuration is near. Stay on the branch nearest to the step before.","trace jump off":"From step {step} to {to} joint {joint} jumps by {by} (such steps: {count}): check J and the velocity there.","trace whole turn":"from step {step} to {to} joint {joint} jumps by a whole turn (such steps: {count}). The pose is the same, so the jump is removed here; a real arm would turn all the way round, so remove it too, as the function unwrap does","trace.backwards":"The path is drawn in the opposite direction: check the sign of the velocity","trace.other side":"The path is drawn on the other side of its start: check the sign of the velocity","trace.centre":"The centre is left out in {axes}: the circle's formulas are relative to it, so add its coordinates","trace.millimetres":"The velocities are in mm/s and the Jacobian in metres: write m/s","trace.no inverse":"At step {step} the Jacobian has rank {_rank} of {_rows}, so it has no inverse there, and joint {_joint} jumps by {_by}: take the pseudo-inverse, or start from a configuration near it","trace.displaced":"The whole path is displaced by {_by} mm: check the centre, and where you start","trace.fraction":"In its time the tip draws {_share} % of the path: velocity and time step belong to durations that differ by a factor of {_over}","trace.open":"The circle does not close: the angle must grow by 2π/N in each of N steps, and yours grows by 2π/(N + 1)","trace.short":"The circle closes one step too soon: the angle must grow by 2π/N in each of N steps, and yours grows by 2π/(N - 1), as N points from start to end do: take N + 1 points","trace.scaled":"The path is {_scale} times as large as it should be: check the radius, and whether velocities and time steps belong to the same duration T","trace.axes exchanged":"The {first} and {second} coordinates are exchanged","trace.next velocity":"Each step uses the velocity of the next step: J(q_k) goes with the velocity at t_k","trace.jacobian held":"The Jacobian of the start is used at every step: compute it anew at each step","trace number":"Only step {step} is wrong: joint {joint} is off by about {off} {unit} there, and all other steps are right.","trace row":"Only step {step} is wrong: its tip {miss}, and all other steps are right.","trace.position only":"You control only the position: add the angular rows of the Jacobian with omega = 0, which keep the tool's direction"};function at(n,t={}){let e=eg[n];for(let[i,s]of Object.entries(t))e=e.replaceAll(`{${i}}`,()=>String(s));return e}var xt=class extends Error{constructor(t,e=[],i=void 0,s=void 0){super(t),this.advice=e,this.tokens=i,this.text=s,this.answers=void 0}};function ei(n){try{return n()}catch(t){if(t instanceof xt)return null;throw t}}var Je=(n,t="and")=>n.length<2?n.join(""):`${n.slice(0,-1).join(", ")} ${t} ${n.at(-1)}`,ig=n=>n.length===1?at("row",{row:n[0]}):at("rows",{rows:Je(n)}),pc=n=>n.slice(0,1).toUpperCase()+n.slice(1);var _i=(n,t=3)=>String(Number(n.toPrecision(t))),ng=75;function ee(n){let t=[...n.replace(/[\p{C}\s]+/gu," ").trim()],e=t.includes("'")&&!t.includes('"')?'"':"'",i=t.length>ng?[...t.slice(0,ng),"..."]:t;return`${e}${i.join("")}${e}`}var _o=1e-12,cd=1e-11;function yi(n,t,e){let[i,s]=[Math.cos(t),Math.sin(t)],r=Dt(Mt(i,e),Mt(s,kt(n,e)));return Dt(r,Mt((1-i)*ot(n,e),n))}var yo=(n,t,e)=>n.turns?Dt(n.point,yi(n.direction,t,nt(e,n.point))):Dt(e,Mt(t,n.direction)),sg=(n,t,e)=>n.turns?yi(n.direction,t,e):e,_r=(n,t)=>nt(t,Mt(ot(n,t),n));function Hs(n,t,e,i,s){let r=Math.hypot(n,t),o=r-Math.abs(e);if(Math.abs(o)<_o*i&&(o=0),r<cd*i)return{values:[s],equal:!0,free:!0};let a=Math.atan2(Math.sqrt(Math.max(o,0)),Math.sqrt(r+Math.abs(e))),c=Math.atan2(t,n),l=2*(e<0?Math.PI/2-a:a);return hd(c+l,c-l,o<=0)}function ld(n,t,e,i){if(Math.abs(t)<_o/i)return{values:[Math.abs(n)<cd?NaN:e/n],equal:!0,free:!1};let s=n*n+4*t*e;Math.abs(s)<4*Math.abs(t)*_o*i&&(s=0);let r=Math.sqrt(Math.max(s,0));return hd((-n+r)/(2*t),(-n-r)/(2*t),s<=0)}var hd=(n,t,e)=>({values:e?[n]:[n,t],equal:e,free:!1});function Ni(n,t,e,i,s){let[r,o]=[_r(n,t),_r(n,e)];return Math.min(Ct(r),Ct(o))<cd*i?{value:s,free:!0}:{value:Math.atan2(ot(n,kt(r,o)),ot(r,o)),free:!1}}function gc(n,t,e,i){let s=(f,p)=>Math.atan2(Ct(kt(f,p)),ot(f,p)),[r,o]=[s(n,e),s(n,t)],a=s(e,i),c=(r+o+a)/2,l=mc(c-r)*mc(c-o),h=mc(c)*mc(c-a),u=2*Math.atan2(Math.sqrt(Math.max(l,0)),Math.sqrt(Math.max(h,0))),{value:d}=Ni(n,t,e,1,0);return hd(d+u,d-u,l<=0||h<=0)}var mc=n=>Math.abs(n)>_o&&Math.abs(Math.PI-n)>_o?Math.sin(n):0;var Ws=(n,t)=>n[0]*t[0]+n[1]*t[1];function rg(n,{A:t,turns:e},i,s,r){let[o,a]=[0,1].map(c=>Ws(n,[t[0][c],t[1][c]]));return e?Hs(o,a,i,s,r):ld(o,a,i,s)}var ud=({across:n},t,e,i,s)=>rg(n,e,Ws(n,rd(t.b,e.b)),i,s);function dd({along:n},[t,e],i,s,r){let[o,a]=e.turns?[Math.cos(i),Math.sin(i)]:[i,i*i],l=e.A.map(h=>h[0]*o+h[1]*a).map((h,u)=>h+e.b[u]-t.b[u]);return rg(n,t,Ws(n,l),s,r)}function og(n,t,e){let[[i,s],[r,o]]=t.A,a=i*o-s*r,c=([m,g])=>[(o*m-s*g)/a,(i*g-r*m)/a],[l,h]=[0,1].map(m=>c([n.A[0][m],n.A[1][m]])),u=c(rd(n.b,t.b)),d=m=>{let[g,x]=n.turns?[Math.cos(m),Math.sin(m)]:[m,m*m];return[l[0]*g+h[0]*x+u[0],l[1]*g+h[1]*x+u[1]]};if(!n.turns)return{roots:ld(2*l[0]*u[0]-l[1],l[0]**2-h[1],u[1]-u[0]**2,1),getThird:g=>d(g)[0]};let f=1-Ws(u,u)-Ws(l,l);return{roots:Hs(2*Ws(l,u),2*Ws(h,u),f,1,e),getThird:m=>Math.atan2(d(m)[1],d(m)[0])}}var ag=1e-9,vM=1e-6,bM=.01;function lg(n,t,e,i){let s=t?vM:bM,[r,o]=[i,cg(n,e,i)];for(let a=0;a<4;a++){let c=xc(o);if(c<ag/1e3||c>=s)break;let l=wM(n,r,o);if(xc(l)>.1)break;let h=r.map((d,f)=>d+l[f]),u=cg(n,e,h);if(!(xc(u)<c))break;[r,o]=[h,u]}return xc(o)<ag?r:null}var xc=n=>Math.max(...n.map(Math.abs));function wM(n,t,e){let i=Ie(n,It(n,t)).map(o=>o.slice(0,e.length)),s=e.map((o,a)=>e.map((c,l)=>i.reduce((h,u)=>h+u[a]*u[l],a===l?1e-12:0))),r=xr(s,e);return i.map(o=>o.reduce((a,c,l)=>a+c*r[l],0))}function cg(n,t,e){let{x:i,y:s,z:r,o}=It(n,e).at(-1);if(Array.isArray(t))return nt(t,o);let a=Dt(Dt(kt(i,t.x),kt(s,t.y)),kt(r,t.z)),c=ot(i,t.x)+ot(s,t.y)+ot(r,t.z)<0?1:0;return[...nt(t.o,o),...a.map(l=>l/2+c)]}var $s=1e-4,ug=1e-10,MM=[.86,1.11,.99,.5,.57,1.08],fd=new WeakMap;function yc(n){return fd.has(n)||fd.set(n,SM(TM(n))),fd.get(n)??null}function SM(n){let{axes:t,size:e}=n,i=t.map(r=>r.turns),s=t.length>1&&vo(t)<$s;if(t.length===6)return EM(n);if(i.filter(Boolean).length===3&&t.length<5&&s)return{kind:"planar",...n,gap:vo(t)};if(t.length===3){let r=dg(t,e);return r<$s?{kind:"position",...n,gap:r}:null}return t.length===2&&i.every(Boolean)&&s?{kind:"two links",...n,gap:vo(t)}:null}function EM(n){let{axes:t,size:e}=n,i=[{kind:"wrist",three:t.slice(3),placing:t.slice(0,3)},{kind:"first three meet",three:t.slice(0,3),placing:t.slice(3).reverse()}];for(let{kind:s,three:r,placing:o}of i){let a=_c(r,e),c=dg(o,e);if(a&&c<$s)return{kind:s,...n,centre:a.point,gap:Math.max(a.gap,c)}}if(!t.every(s=>s.turns))return null;for(let s=0;s<4;s++){let r=vo(t.slice(s,s+3)),o=[0,1,2].map(c=>(s+3+c)%6),a=[0,1].flatMap(c=>o[c+1]!==o[c]+1?[]:_c([t[o[c]],t[o[c+1]]],e)?.gap??[]);if(r<$s&&a.length)return{kind:"parallel",...n,first:s,gap:Math.max(r,Math.min(...a))}}return null}function TM(n){let t=et(n),e=t.map((c,l)=>MM[l%6]),i=It(n,e),[s,r]=[i[0].o,0],o=t.map(c=>{let{z:l,o:h}=i[c],u=Dt(h,Mt(ot(l,nt(s,h)),l));return r+=Ct(nt(u,s)),s=u,{direction:l,point:u,turns:n.rows[c].kind==="revolute"}}),a=i.at(-1);return{axes:o,size:r+Ct(nt(a.o,s)),reference:e,tip:a}}function _c(n,t){if(!n.every(c=>c.turns))return null;for(let c=1;c<n.length;c++)if(Ct(kt(n[c-1].direction,n[c].direction))<$s)return null;let e=n.map(({direction:c})=>c.map((l,h)=>c.map((u,d)=>+(h===d)-l*u))),i=[0,1,2].map(c=>[0,1,2].map(l=>hg(e.map(h=>h[c][l])))),s=[0,1,2].map(c=>hg(n.map(({point:l},h)=>ot(e[h][c],l)))),r=xr(i,s),o=n.map(c=>Ct(kt(c.direction,nt(r,c.point)))),a=Math.max(...o)/t;return a<$s?{point:r,gap:a}:null}var hg=n=>n.reduce((t,e)=>t+e,0),vo=n=>Math.max(...n.slice(1).map((t,e)=>Ct(kt(n[e].direction,t.direction))));function dg([n,t,e],i){if(!n.turns&&!e.turns)return 0;let s=[n,e].map(r=>gd(r,t,i).width);return!t.turns&&n.turns&&e.turns&&s.push(vo([n,e])),Math.min(...s)}function qs(n,t){if(!n.turns)return{centre:t,X:n.direction,Y:[0,0,0],turns:!1};let e=nt(t,n.point),i=nt(e,Mt(ot(n.direction,e),n.direction));return{centre:nt(t,i),X:i,Y:kt(n.direction,i),turns:!0}}function pd(n,{centre:t,X:e,Y:i,turns:s},r){let o=n.direction;if(!n.turns){let u=md(o),d=[u,kt(o,u)].map(f=>[ot(f,e),ot(f,i),ot(f,t)]);return{A:d.map(f=>f.slice(0,2)),b:d.map(f=>f[2]),turns:s}}let a=nt(t,n.point),c=s?ot(a,i):ot(e,e)/2,l=ot(a,a)+(s?ot(e,e):0);return{A:[[ot(o,e),ot(o,i)],[ot(a,e)/r,c/r]],b:[ot(o,a),l/(2*r)],turns:s}}function md(n){let t=n.map(Math.abs).indexOf(Math.min(...n.map(Math.abs))),e=kt(n,[0,1,2].map(i=>+(i===t)));return Mt(1/Ct(e),e)}function gd(n,t,e){let i=Dt(n.point,Mt(e,[.3,-.7,.5])),{A:s}=pd(t,qs(n,i),e),r=[0,1].map(h=>[s[0][h],s[1][h]]),{values:o,vectors:a}=nn(r,2),[c,l]=[0,1].map(h=>{let[u,d]=a[h];return(Math.abs(u)>1e-6?u:d)<0?[-u,-d]:[u,d]});return{along:c,across:l,width:o[0]>0?o[1]/o[0]:0}}var xd=({width:n})=>n<$s;function _d(n,t){let e=yc(n),i=nc(n),s=e.reference.map(r=>-r);return AM(e,t,s).flatMap(r=>{let a=r.motions.map((d,f)=>e.reference[f]+d).map((d,f)=>i[f]?d-2*Math.PI*Math.round(d/(2*Math.PI)):d),c=a.every(Number.isFinite)?lg(n,e.gap<ug,t,a):null;if(!c)return[];let{names:l,free:h,times:u}=r;return[{name:l.join(", ")||"the only one",q:c,free:h,times:u,uncertainty:0}]})}function AM(n,t,e){let{kind:i,axes:s,size:r,tip:o,centre:a}=n;if(i==="position")return mg(s,o.o,t,r,e);if(i==="two links")return UM(n,t,e);let c=RM(o,t);if(i==="wrist")return fg(s,a,c,r,e);if(i==="parallel")return PM(n,c,e);if(i==="planar")return OM(n,c,e);let l=e.map(u=>-u).reverse();return fg([...s].reverse(),a,pg(c),r,l).map(u=>({...u,motions:u.motions.map(d=>-d).reverse(),free:[...u.free].reverse()}))}function RM(n,t){let e=[0,1,2].map(i=>[0,1,2].map(s=>t.x[i]*n.x[s]+t.y[i]*n.y[s]+t.z[i]*n.z[s]));return{R:e,shift:nt(t.o,Xs(e,n.o))}}var Xs=(n,t)=>n.map(e=>ot(e,t)),yr=({R:n,shift:t},e)=>Dt(Xs(n,e),t);function pg({R:n,shift:t}){let e=[0,1,2].map(i=>n.map(s=>s[i]));return{R:e,shift:Mt(-1,Xs(e,t))}}var ni=(n,{values:t,equal:e},i)=>t.flatMap((s,r)=>i(s).map(o=>({...o,names:e?o.names:[`${n} ${r?"-":"+"}`,...o.names],times:e?2*o.times:o.times}))),bo=(n,t)=>[{motions:n,free:t,names:[],times:1}];function mg([n,t,e],i,s,r,o){let[a,c]=[qs(n,s),qs(e,i)].map(g=>pd(t,g,r)),[l,h]=[n,e].map(g=>gd(g,t,r)),[u,d]=[n.turns?"shoulder":"rod",e.turns?"elbow":"rod"],f=(g,x,_,b)=>{let[M,T]=[yo(e,_,i),yo(n,g,s)],E=CM(t,M,T,r,o[1]);return bo([-g,E.value,_],[x,E.free,b])};if(xd(h)){let g=ud(h,c,a,r,-o[0]);return ni(u,g,x=>{let _=dd(h,[c,a],x,r,o[2]);return ni(d,_,b=>f(x,g.free,b,_.free))})}if(xd(l)){let g=ud(l,a,c,r,o[2]);return ni(d,g,x=>{let _=dd(l,[a,c],x,r,-o[0]);return ni(u,_,b=>f(b,_.free,x,g.free))})}let{roots:p,getThird:m}=og(a,c,-o[0]);return ni(u,p,g=>f(g,p.free,m(g),!1))}function CM({direction:n,point:t,turns:e},i,s,r,o){return e?Ni(n,nt(i,t),nt(s,t),r,o):{value:ot(n,nt(s,i)),free:!1}}function fg(n,t,e,i,s){let[r,o,a]=n.slice(3).map(c=>c.direction);return mg(n.slice(0,3),t,yr(e,t),i,s).flatMap(c=>{let l=m=>c.motions.reduce((g,x,_)=>sg(n[_],-x,g),m),h=l(Xs(e.R,a)),u=kt(a,o),d=l(Xs(e.R,u)),f=gc(o,a,r,h);return ni("wrist",f,m=>{let g=Ni(r,yi(o,m,a),h,1,s[3]),x=yi(o,-m,yi(r,-g.value,d)),_=Ni(a,u,x,1,s[5]);return bo([g.value,m,_.value],[g.free,!1,!1])}).map(m=>IM(c,m))})}var IM=(n,t)=>({motions:[...n.motions,...t.motions],free:[...n.free,...t.free],names:[...n.names,...t.names],times:n.times*t.times});function PM({axes:n,first:t,size:e},i,s){let r=n.slice(t,t+3),o=pg(i),a=[0,1,2].map(m=>(t+3+m)%6),c=a.map(m=>m<t?LM(o,n[m]):n[m]),l=m=>a[m+1]===a[m]+1,h=m=>{let g=[n[a[m]],n[a[m+1]]],x=l(m)&&_c(g,e);return x&&(a[m]<t?yr(o,x.point):x.point)},u=r[0].direction,d={h:u,hBack:Xs(o.R,u),motion:i,size:e,start:a.map(m=>s[m])},f=h(0);return(f?NM(d,c,f):DM(d,c,h(1))).flatMap(m=>{let g=_=>yr(i,m.motions.reduce((b,M,T)=>yo(c[T],-M,b),_)),x=s.slice(t,t+3);return yd(r,g,e,x).map(_=>{let b=new Array(6),M=new Array(6);for(let E of[0,1,2])[b[t+E],M[t+E]]=[_.motions[E],_.free[E]],[b[a[E]],M[a[E]]]=[m.motions[E],m.free[E]];let T=[...m.names,..._.names];return{motions:b,free:M,names:T,times:m.times*_.times}})})}var LM=(n,t)=>({direction:Xs(n.R,t.direction),point:yr(n,t.point),turns:t.turns});function NM({h:n,hBack:t,motion:e,size:i,start:s},[r,o,a],c){let{centre:l,X:h,Y:u}=qs(a,c),d=ot(n,c)-ot(n,e.shift)-ot(t,l),f=Hs(ot(t,h),ot(t,u),d,i,-s[2]);return ni("shoulder",f,p=>{let m=yi(a.direction,-p,t);return ni("wrist",gc(o.direction,m,r.direction,n),g=>{let x=Ni(r.direction,yi(o.direction,g,m),n,1,s[0]);return bo([x.value,g,-p],[x.free,!1,f.free])})})}function DM({h:n,hBack:t,motion:e,size:i,start:s},[r,o,a],c){let{centre:l,X:h,Y:u}=qs(r,c),d=ot(n,yr(e,c))-ot(n,l),f=Hs(ot(n,h),ot(n,u),d,i,s[0]);return ni("shoulder",f,p=>{let m=yi(r.direction,-p,n),g=gc(a.direction,t,o.direction,m);return ni("wrist",g,x=>{let _=yi(a.direction,x,t),b=Ni(o.direction,_,m,1,s[1]);return bo([p,b.value,x],[f.free,b.free,!1])})})}function yd([n,t,e],i,s,r){let o=n.direction,a=_r(o,nt(i(e.point),n.point)),{centre:c,X:l,Y:h}=qs(t,e.point),u=_r(o,nt(c,n.point)),d=(ot(a,a)-ot(u,u)-ot(l,l))/s,f=Hs(2*ot(u,l)/s,2*ot(u,h)/s,d,s,r[1]),p=md(o),m=nt(i(Dt(e.point,p)),i(e.point)),g=Ni(o,p,m,1,r[2]).value;return ni("elbow",f,x=>{let _=_r(o,nt(yo(t,x,e.point),n.point)),b=Ni(o,_,a,s,r[0]),M=ot(t.direction,o),T=ot(e.direction,o)*(g-b.value-M*x);return bo([b.value,x,T],[b.free,f.free,!1])})}function OM({axes:n,size:t},e,i){let s=n.flatMap((c,l)=>c.turns?[l]:[]),r=s.map(c=>n[c]),o=s.map(c=>i[c]),a=c=>yr(e,c);return yd(r,a,t,o).map(c=>{let[l,h]=[[],[]];return n.forEach(({direction:u,point:d,turns:f},p)=>{let m=s.indexOf(p);l.push(f?c.motions[m]:ot(u,nt(a(d),d))),h.push(f&&c.free[m])}),{...c,motions:l,free:h}})}function UM({axes:n,size:t,tip:e},i,s){let r={direction:n[0].direction,point:e.o,turns:!0};return yd([...n,r],()=>i,t,[...s,s[0]]).map(a=>({...a,motions:a.motions.slice(0,2),free:a.free.slice(0,2)}))}var Cn=1e-12,vc=1e-11,vr=1e-15,wo=["front","back"],bc=["q_5 > 0","q_5 < 0"];function FM(n){let t=Math.round(n);return t-n===.5&&t%2?t-1:t}var Di=n=>FM(n*(.5/Math.PI))*(-2*Math.PI)+n,Wn=(n,t)=>t?Di(n-t):n,ln=(n,t,e)=>Math.min(Math.max(n,t),e);function vi(n){let[t,e]=Ka(n.alpha);return{...n,ca:t,sa:e}}function Mo(n,t,e){let[i,s,r]=e,o=n.sa*t,a=i*i+s*s-o*o,c=Math.max(2*Math.abs(o)*Cn,Cn**2),l=Math.abs(a)<=c,h=Math.sqrt(a>c?a:0),u=[h,-h],d=l&&o===0,f=[n.theta,n.theta+Math.PI];return{phi:u.map((p,m)=>d?f[m]:Math.atan2(s*p+i*o,i*p-s*o)),x:u,y:n.sa*(r-n.d),exists:a>=-c,isDouble:l,free:d,uncertainty:l?0:vr/Math.max(h,Cn)}}var wc=({upper:n,fore:t})=>Math.abs(n)+Math.abs(t),Mc=({upper:n,fore:t})=>Math.abs(Math.abs(n)-Math.abs(t));function Sc(n,[t,e],i,s,r=0){let{upper:o,fore:a}=n,[c,l,h]=[wc(n),Mc(n),t*t+e*e],u=Math.sqrt(h),d=Math.min(Math.abs(u-c),Math.abs(u-l)),f=d<=Cn+r,p=ln((h-(o**2+a**2))*(.5/(o*a)),-1,1),m=d<=Cn?Math.round(p):p,g=Math.sqrt(1-m*m),[x,_]=[o+a*m,i*(a*g)],b=f&&u<=Cn,M=f||l<u&&u<c;return{phi2:b?s:Math.atan2(e*x-t*_,t*x+e*_),phi3:i*Math.atan2(g,m),exists:M,isDouble:f,free:b,uncertainty:f||!M?0:vr*c/(Math.abs(o*a)*g)}}function Ec(n,{x:t,y:e,z:i,o:s}){let[r,o]=[n.ca,n.sa],a={x:t,y:Dt(Mt(r,e),Mt(-o,i)),z:Dt(Mt(o,e),Mt(r,i))},c=nt(s,Mt(n.d,a.z));return{...a,centre:n.a?nt(c,Mt(n.a,t)):c}}function br(n,t,e=[],i=[]){if(!n.length){let o=t(...i),a=o?kM(o.merged,i):0;return a?[{name:e.join(", "),times:a,...o}]:[]}let[s,...r]=n;return s.flatMap((o,a)=>br(r,t,[...e,o],[...i,a]))}var kM=(n,t)=>n.some((e,i)=>e&&t[i])?0:2**n.filter(Boolean).length;var BM=["elbow +","elbow -"];function gg(n,t){let e=n.rows.map(vi),[,i,s,r]=e,o=i.ca*s.ca,a=i.d+i.ca*s.d+o*r.d,c={upper:i.a,fore:s.a},l={rows:e,links:c,side:-r.sa*o},h=Ec(e[5],t),u=Mo(e[0],a,h.centre),d=[0,1].map(f=>zM(l,u,h,f));return br([wo,bc,BM],(f,p,m)=>{let{phi5:g,phi6:x,u:_,singular:b,uncertainty:M}=d[f][p],T=xg(l,u.x[f],u.y,_),E=Sc(c,T,m?-1:1,i.theta,M);if(!u.exists||!E.exists)return null;let y=Math.atan2(_[1],_[0]),S=[Wn(u.phi[f],e[0].theta),Wn(E.phi2,i.theta),Wn(i.ca*E.phi3,s.theta),Di(o*(y-E.phi2-E.phi3)-r.theta),Wn(g,e[4].theta),Wn(x,e[5].theta)],D=b&&!_g(l,u.x[f],u.y),L=[u.free,E.free,!1,!1,!1,D];return{q:S,free:L,merged:[u.isDouble,b,E.isDouble]}})}function zM(n,t,e,i){let{rows:s}=n,[r,o]=[Math.cos(t.phi[i]),Math.sin(t.phi[i])],{sa:a}=s[0],c=[e.x,e.y,e.z].map(([G,I])=>a*(o*G-r*I)),l=([G,I,H])=>[r*G+o*I,a*H],[h,u,d]=[e.x,e.y,e.z].map(l),f=Math.sqrt(c[0]*c[0]+c[1]*c[1]),p=n.side*s[4].sa*c[2],m=f<vc+t.uncertainty,g=m?0:f,x=m?0:(vr+t.uncertainty)/g,_=Math.abs(s[4].d)*x,b=n.side/(m?1:g),[M,T]=[-b*c[0],b*c[1]],E=m?s[5].theta:Math.atan2(T,M);m&&([M,T]=[Math.cos(E),Math.sin(E)]);let y=s[4].sa*g,S=[0,1].map(G=>y*d[G]+p*(M*h[G]-T*u[G])),D=Math.atan2(g,p),L=E<0||Object.is(E,-0)?-Math.PI:Math.PI,U=[{phi5:D,phi6:E,u:S,singular:m,uncertainty:_},{phi5:-D,phi6:m?E:E-L,u:m?S:S.map(G=>-G),singular:m,uncertainty:_}];return m||x>Cn?U.map(G=>GM(n,t.x[i],t.y,G)):U}function xg({side:n,rows:t},e,i,s){let r=n*t[4].d;return[e+r*s[1],i-r*s[0]]}function _g({rows:n,links:t},e,i){let[s,r]=[Math.hypot(e,i),Math.abs(n[4].d)],[o,a]=[Math.abs(s-r),s+r];return(o>=wc(t)-2*Cn||a<=Mc(t)+2*Cn)&&Math.min(s,r)>Cn}function GM(n,t,e,i){let{rows:s,links:r,side:o}=n,a=Math.abs(s[4].d),[c,l]=i.u,[h,u]=xg(n,t,e,i.u),[d,f]=[Math.hypot(t,e),Math.hypot(h,u)],p=ln(f,Mc(r),wc(r)),m=_g(n,t,e),[g,x]=[t-h,e-u],_=Math.atan2(t*x-e*g,t*g+e*x),b=(d**2+a**2-p**2)/Math.max(2*d*a,1e-300),M=Math.acos(ln(m?Math.round(b):b,-1,1)),T=(_<0||Object.is(_,-0)?-M:M)-_,E=Math.max(Math.abs(f-p),a*Math.abs(T)/2);if(!(i.singular?m||f!==p:E<=i.uncertainty))return{...i,phi6:Di(i.phi6)};let[S,D]=[Math.cos(T),Math.sin(T)],L=o*s[4].sa*Math.cos(i.phi5);return{...i,u:[S*c-D*l,D*c+S*l],phi6:Di(i.phi6-Math.sign(L)*T)}}var VM=["elbow up","elbow down"],HM=["rod out","rod through"];function yg(n,t){let[e,i,s,r]=n.rows.map(vi),o=Tg(i,s,r?.d??0),a=Mo(e,o.offset,t);return br([wo,VM],(c,l)=>{let h=e.sa*(c===l?-1:1),u=Sc(o,[a.x[c],a.y],h,i.theta);if(!a.exists||!u.exists)return null;let d=[Wn(a.phi[c],e.theta),Wn(u.phi2,i.theta),Wn(i.ca*u.phi3,o.beta+s.theta)],f=[a.free,u.free,!1],p=a.uncertainty+u.uncertainty;return{q:d,free:f,merged:[a.isDouble,u.isDouble],uncertainty:p}})}function Tg(n,t,e){let i=-e*t.sa;return{upper:n.a,fore:Math.hypot(t.a,i),beta:Math.atan2(i,t.a),offset:n.d+n.ca*(t.d+e*t.ca)}}function vg(n,t){let[e,i,s,r]=n.rows.map(vi),o=Mo(e,i.d,t);return br([wo,HM],(a,c)=>{if(!o.exists)return null;let l=c?-1:1,h=l*Math.hypot(o.x[a],o.y),u=i.sa*l,d=Math.abs(h)<Cn,f=Math.atan2(u*o.x[a],-u*o.y),p=[Wn(o.phi[a],e.theta),d?0:Wn(f,i.theta),h-s.d-(r?.d??0)],m=vr+Math.hypot(t[0],t[1])*o.uncertainty,g=o.uncertainty+(d?0:m/Math.abs(h)),x=[o.free,d,!1];return{q:p,free:x,merged:[o.isDouble,d],uncertainty:g}})}var vd=n=>({...n,rows:[...n.rows.slice(0,3),{kind:"fixed",a:0,alpha:0,d:n.rows[3].d,theta:0}]});function bg(n,t,e){let i=t.rows.map(vi),s=Ec(i[5],e),r=vd(t);return n(r,s.centre).flatMap(({name:o,q:a,free:c,times:l,uncertainty:h})=>{let u=It(r,a).at(-1),[d,f]=[s.x,s.z].map(g=>tc(u,g)),{pairs:p,singular:m}=WM(i,d,f,h);return bc.slice(0,m?1:2).map((g,x)=>({name:`${o}, ${g}`,times:m?2*l:l,q:[...a,...p.map((_,b)=>Di(_[x]-i[3+b].theta))],free:[...c,m,!1,!1]}))})}function WM(n,t,e,i){let[s,r]=[n[3].sa,n[4].sa],o=-s*r*e[2],a=Math.hypot(e[0],e[1])<vc+i,c=a?0:Math.hypot(e[0],e[1]),l=a?n[3].theta:Math.atan2(r*e[1],r*e[0]),[h,u]=[Math.cos(l),Math.sin(l)],[d,f]=[h*t[0]+u*t[1],h*t[1]-u*t[0]],p=Math.atan2(c,o),m=Math.atan2(-s*r*f,o*d+s*c*t[2]),g=a?0:Math.PI;return{pairs:[[l,l+g],[p,-p],[m,m+g]],singular:a}}var Tc=n=>n.map(({kind:t})=>t[0]).join("");function wg({rows:n}){if(!["rrr","rrrf"].includes(Tc(n)))return!1;let[t,e,i,s]=n.map(vi);return t.a===0&&t.ca===0&&e.sa===0&&e.a!==0&&Tg(e,i,s?.d??0).fore>0&&!s?.a}function Mg({rows:n}){if(!["rrp","rrpf"].includes(Tc(n)))return!1;let[t,e,i]=n.map(vi);return t.ca===0&&e.ca===0&&i.sa===0&&i.ca===1&&n.every(({a:r})=>r===0)}function Sg({rows:n}){if(n.length!==6||Tc(n.slice(3))!=="rrr")return!1;let[t,e]=n.slice(3).map(vi);return t.a===0&&e.a===0&&e.d===0&&t.ca===0&&e.ca===0}function $M({rows:n}){if(Tc(n)!=="rrrrrr")return!1;let[t,e,i,s,r]=n.map(vi);return[t,s,r].every(({a,ca:c})=>a===0&&c===0)&&e.sa===0&&i.sa===0&&e.a*i.a!==0}var So={elbow:{fits:wg,solve:yg,pose:!1},rod:{fits:Mg,solve:vg,pose:!1},stanford:{fits:n=>Sg(n)&&Mg(vd(n)),solve:(n,t)=>bg(vg,n,t),pose:!0},spherical_wrist:{fits:n=>Sg(n)&&wg(vd(n)),solve:(n,t)=>bg(yg,n,t),pose:!0},ur:{fits:$M,solve:gg,pose:!0},solutions:{fits:n=>Eg(n)===!0,solve:_d,pose:!0},positions:{fits:n=>Eg(n)===!1,solve:_d,pose:!1}};function Eg(n){let t=yc(n);return t&&!["position","two links"].includes(t.kind)}var bd=n=>Object.keys(So).find(t=>So[t].fits(n))??null,wd=n=>So[n].pose;function Md(n,t,e){return So[t].pose&&XM(n,e),So[t].solve(n,e)}var qM=1e-6;function XM(n,{x:t,y:e,z:i}){let s=[...nt(kt(t,e),i),...[t,e,i].map(o=>ot(o,o)-1)],r=Math.max(...s.map(Math.abs));if(r>qM)throw new xt(`${n.name}: a target is no rigid transform, by ${_i(r,2)}; expected a rotation and a position over (0, 0, 0, 1)`)}var jM=[[1,0,0],[0,1,0],[0,0,1]];function Ag({centre:n,radius:t,plane:e,period:i,steps:s,phase:r=0}){let[o,a]=[...e].map(h=>jM["xyz".indexOf(h)]),c=2*Math.PI/i,l=h=>{let u=r+c*h;return[Math.cos(u),Math.sin(u)]};return{times:Array.from({length:s+1},(h,u)=>u===s?i:u*(i/s)),position:h=>{let[u,d]=l(h);return n.map((f,p)=>f+t*(u*o[p]+d*a[p]))},velocity:h=>{let[u,d]=l(h);return n.map((f,p)=>t*c*(u*a[p]-d*o[p]))},normal:kt(o,a)}}function Nt(n,t){return(Math.abs(n)<.5*10**-t?0:n).toFixed(t).replace("-","−")}var Eo=(n,t)=>n.toExponential(t).replaceAll("-","−"),wr=(n,t)=>`${Nt(n*180/Math.PI,t)}°`,To=(n,t)=>Math.abs(n)<1e-12?"0":Nt(n,t),Oi=n=>n.kind!=="prismatic",Rg=n=>Oi(n)?"angle":"length";function In(n,t,e){return Oi(n)?e==="deg"?wr(t,1):`${Nt(t,3)} rad`:`${Nt(t,3)} m`}function Ac(n,t,e){if(!Oi(n))return`${Nt(t,3)} metres`;let[i,s]=e==="deg"?[Nt(t*180/Math.PI,1),"degrees"]:[Nt(t,3),"radians"];return`${i.replace("−","minus ")} ${s}`}var Cg=(n,t,e)=>Oi(n)&&e==="deg"?wr(t,0):`${hn(t,2)} ${Oi(n)?"rad":"m"}`;function Rc(n,t,e){if(!t)return hn(n,6);if(e==="deg")return hn(n*180/Math.PI,4);let i=n*12/Math.PI;if(n===0||Math.abs(i-Math.round(i))>1e-9)return hn(n,6);let s=Math.round(i),r=[12,6,4,3,2,1].find(l=>s%l===0),[o,a]=[s/r,12/r],c=Math.abs(o)===1?`${o<0?"-":""}π`:`${o}π`;return(a===1?c:`${c}/${a}`).replace("-","−")}var hn=(n,t)=>String(Number(n.toFixed(t))+0).replace("-","−"),YM=["move along","turn about"].flatMap(n=>[..."xyz"].map(t=>`${n} ${t}`));function Sd(n){let t=n.flatMap((i,s)=>Math.abs(i)>.02?[[i,YM[s]]]:[]);if(t.length===1)return t[0][1];let e=Math.sign(t[0][0]);return t.map(([i,s])=>`${Nt(e*i,2)} ${s.replace("move ","").replace("turn ","")}`).join(", ")}function Ig({rows:n}){let t=r=>String(Number(r.toFixed(9))+0),e=r=>{let o=Rc(r,!0,"rad").replace("−","-").replace("π","pi");return o.includes("pi")?o.replace(/(\d)pi/,"$1*pi"):t(r)},i=(r,o)=>o==="0"?`q${r}`:`q${r} + ${o}`.replace("+ -","- ");return["i	a (m)	alpha (rad)	d (m)	theta (rad)",...n.map(({kind:r,a:o,alpha:a,d:c,theta:l},h)=>{let[u,d]=[t(c),e(l)],f=[t(o),e(a),u,d];return r==="prismatic"&&(f[2]=i(h+1,u)),r==="revolute"&&(f[3]=i(h+1,d)),[h+1,...f].join("	")}),""].join(`
`)}var un=(n,t,e)=>n.map((i,s)=>s===t?e:i),Ed=n=>n.replace(" (homework)",", homework’s lengths");var JM=n=>Math.max(0,et(n).length-cn(n).length);function Mr(n,t){let e=["x","y","z"].reduce((i,s)=>Dt(i,kt(n[s],t[s])),[0,0,0]);return[...nt(t.o,n.o),...Mt(.5,e)]}var Ui=(n,t)=>n.reduce((e,i,s)=>e+i*t[s],0),Ro=(n,t,e)=>xr(n.map((i,s)=>n.map((r,o)=>Ui(i,r)+(s===o?e:0))),t);function Fi(n,t,e,{lockedJoint:i=-1,rows:s=cn(n),steps:r=60}={}){let o=[...t];for(let a=0;;a++){let c=It(n,o),l=vn(Mr(c.at(-1),e),s),h=Ct(l);if(h<1e-11||a===r||!o.length)return{q:o,error:h};let u=Ie(n,c).map((m,g)=>vn(m,s).map(x=>g===i?0:x)),d=u.map(m=>Ui(m,l)),f=Ro(u,d,.02*h*h+1e-12),p=Math.max(1e-12,...f.map(Math.abs));o=o.map((m,g)=>m+f[g]*Math.min(1,.6/p))}}var ZM={x:["zy",1],y:["zx",-1],z:["yx",1]};function rs(n,{normal:t="x",radius:e=.1,seconds:i=1},s){let[r,o]=ZM[t],a=n.map((h,u)=>h-("xyz"[u]===r[0]?e:0)),c=Ag({centre:a,radius:e,plane:r,period:o*i,steps:1}),l=s*i;return{o:c.position(l),v:c.velocity(l)}}var Pg=.05;function Ad(n,t,e){let i=n;for(let s of t.keys())for(let r of[Pg,-Pg]){let o=e(un(t,s,t[s]+r));o.error<.98*i.error&&(i=o)}return i}function Ng(n,t,e,i){let s=a=>Fi(n,a,e,i),r=s(t);return r.error>1e-6&&Cd(r.q,t)?Ad(r,t,s):r}function KM(n){return()=>(n=Math.imul(n,1664525)+1013904223>>>0)/2**32}function Rd(n,t=Math.random){return et(n).map(e=>{let[i,s]=Hn(n.rows[e]);return i+(s-i)*t()})}var QM=16,tS=300;function Dg(n,t){let e=It(n,t).at(-1),i=Vs(n);if(!yn(n,t)||!t.length)return{list:[],families:[],lockedJoint:-1,target:e,hasOrientation:i};let s=JM(n)?2:-1,r=KM(1),o=[],a=[],c=(d,f)=>{if(o.some(m=>iS(n,m,d))||a.some(({q:m})=>Ao(n,m,d)<.001))return;let p=nS(n,d,e,s);a.push(f?{q:d,label:f}:{q:d}),p.length&&o.push({moving:p,q:d})},l=eS(n,e,i);for(let{q:d,name:f}of l)c(Td(n,d),f);c(Td(n,t));for(let d=0;!l.length&&d<tS&&a.length<QM;d++){let f=Rd(n,r).map((g,x)=>x===s?t[x]:g),{q:p,error:m}=Fi(n,f,e,{lockedJoint:s});m<1e-9&&c(Td(n,p))}let h=({q:d})=>Ao(n,d,t);return{list:[...a].sort((d,f)=>h(d)-h(f)),families:o,lockedJoint:s,target:e,hasOrientation:i}}function eS(n,t,e){let i=bd(n);return!i||wd(i)!==e?[]:Md(n,i,e?t:t.o)}var Lg=.1;function nS(n,t,e,i){let s=cn(n),r=Ie(n,It(n,t)).map((l,h)=>vn(l,s).map(u=>h===i?0:u)),{values:o}=nn(r,s.length),a=et(n).length-(i<0?0:1);if(o.filter(l=>l>1e-5*o[0]).length>=Math.min(s.length,a))return[];let c=new Set;for(let l of xi(r,i)){let h=t.map((d,f)=>d+Lg*l[f]),u=Fi(n,h,e,{lockedJoint:i,steps:200});u.error>1e-9||Ao(n,u.q,t)<.3*Lg||u.q.forEach((d,f)=>Math.abs(d-t[f])>.001&&c.add(f))}return[...c].sort((l,h)=>l-h)}function iS(n,{moving:t,q:e},i){let s=i.map((r,o)=>t.includes(o)?e[o]:r);return Ao(n,e,s)<.001}function Td(n,t){return et(n).map((e,i)=>{if(n.rows[e].kind!=="revolute")return t[i];let[s,r]=Hn(n.rows[e]),o=Di(t[i]);return[o,o+2*Math.PI,o-2*Math.PI].find(a=>a>=s&&a<=r)??o})}function Ao(n,t,e){let i=(s,r)=>n.rows[s].kind==="revolute"?2*Math.sin((t[r]-e[r])/2):t[r]-e[r];return Math.max(...et(n).map((s,r)=>Math.abs(i(s,r))))}var Og=1e-4,Cd=(n,t)=>n.length===t.length&&n.every((e,i)=>Math.abs(e-t[i])<Og),Cc=(n,t,e)=>t.length===e.length&&Ao(n,t,e)<Og;var Pc={method:"euler",rates:"inverse",steps:1e3,seconds:5,radius:.1,normal:"x",gain:0,cutoff:1e-9,damping:.02,locked:-1,mistake:""};function sS(n,t,e,i){let s=Jm(n,t),r=s.at.map(l=>l+1),o=l=>Zm(s,e,l),c={angular:()=>Km(o({}),o({axis:r})),z_i:()=>o({axis:r,origin:r}),o_i:()=>o({origin:r})}[i]?.()??o({});return t.map((l,h)=>[0,1,2,3,4,5].map(u=>c[u*s.dof+h]))}var Ic=class extends Error{},Ug=(n,t)=>n.map((e,i)=>i).filter(e=>e!==t),Fg=n=>n[Math.min(5,n.length-1)]<=1e-9*n[0];function rS(n,t,e){let i=Ie(n,It(n,t));return Fg(nn(Ug(i,e).map(s=>i[s])).values)}function oS(n,t,{rates:e,cutoff:i,damping:s,locked:r}){let o=Ug(n,r),{values:a,vectors:c}=nn(o.map(u=>n[u])),l=e==="pseudo"?i*a[0]:0;if(e==="inverse"&&Fg(a))throw new Ic;let h=n.map(()=>0);return a.forEach((u,d)=>{if(u<=l||u<1e-14)return;let f=u**2+(e==="damped"?s**2:0),p=Ui(c[d],t)/f;for(let m of o)h[m]+=p*Ui(n[m],c[d])}),{solution:h,smallestSigma:a[Math.min(5,o.length-1)]}}var aS=181,cS=.001,Id=class{constructor(t,e,i){this.arm=t,this.run=i,this.q=[...e],this.first=It(t,e).at(-1),this.every=Math.max(1,Math.ceil(i.steps/(aS-1))),this.kept={path:[e],errors:[0],at:[0]},this.worst={smallestSigma:1/0,largestError:0,fastestRate:0,largestTilt:0}}computeRates(t,e){let{arm:i,run:s,first:r,worst:o}=this,a=It(i,e),{o:c,v:l}=rs(r.o,s,t),h=s.gain?Mr(a.at(-1),{...r,o:c}):[0,0,0,0,0,0],u=[...l,0,0,0].map((p,m)=>p+s.gain*h[m]),{solution:d,smallestSigma:f}=oS(sS(i,e,a,s.mistake),u,s);return o.smallestSigma=Math.min(o.smallestSigma,f),s.mistake==="sign"?d.map(p=>-p):d}computeNextJoints(t,e){let{arm:i,run:s,first:r,q:o,worst:a}=this,c=this.computeRates(s.mistake==="next"?e:t,o);if(a.fastestRate=Math.max(a.fastestRate,...c.map(Math.abs)),s.method==="exact"){let m={...r,o:rs(r.o,s,e).o};return Ng(i,o,m,{lockedJoint:s.locked}).q}let l=s.seconds/s.steps,h=(m,g)=>o.map((x,_)=>x+g*m[_]);if(s.method==="euler")return h(c,l);let u=t+.5/s.steps,d=this.computeRates(u,h(c,l/2)),f=this.computeRates(u,h(d,l/2)),p=this.computeRates(e,h(f,l));return o.map((m,g)=>m+l/6*(c[g]+2*d[g]+2*f[g]+p[g]))}makeStep(t){let{arm:e,run:i,first:s,worst:r,kept:o}=this,a=(t+1)/i.steps;try{this.q=this.computeNextJoints(t/i.steps,a)}catch(f){if(f instanceof Ic)return!1;throw f}let c=It(e,this.q).at(-1),l={...s,o:rs(s.o,i,a).o},h=Ct(nt(c.o,l.o)),u=Math.atan2(Ct(kt(c.z,s.z)),ot(c.z,s.z));r.largestTilt=Math.max(r.largestTilt,u),r.largestError=Math.max(r.largestError,h);let d=Ct(vn(Mr(c,l),cn(e)));return i.method==="exact"&&d>cS?!1:(((t+1)%this.every===0||t+1===i.steps)&&(o.path.push(this.q),o.errors.push(h),o.at.push(a)),Number.isFinite(h))}};function Ld(n,t,e={}){let i={...Pc,...e};i.method==="exact"&&(i.rates="pseudo");let s=new Id(n,t,i),r=0;for(;r<i.steps&&s.makeStep(r);)r++;let o=et(n).map(h=>n.rows[h].kind==="revolute"?2*Math.PI:0),a=s.q.map((h,u)=>o[u]?(h-t[u])/o[u]:0),c=r<i.steps?r:null,l=c!==null&&rS(n,s.q,i.locked);return{...s.kept,run:i,...s.worst,failedStep:c,isSingular:l,windings:a}}function kg(n,t,e={}){let{o:i}=It(n,t).at(-1),{path:s}=Ld(n,t,{method:"exact",steps:180,...e});return s.length===1&&s.push(t),{path:s,wantedPath:Array.from({length:181},(r,o)=>rs(i,e,o/180).o)}}var Bg=(n,t,e)=>t.map(i=>{let s=It(n,i),r=sc(Ie(n,s),e);return ic(n,s).map((o,a)=>o-r[a])}),lS={method:["euler","rk4","exact"],rates:["inverse","pseudo","damped"],normal:["x","y"],mistake:["","angular","z_i","o_i","sign","next"]},Nd={steps:[10,1e4],seconds:[1,60],radius:[.01,.1],gain:[0,20],cutoff:[1e-9,.1],damping:[.001,.2],locked:[-1,15]},hS=["steps","locked"],Pd=Object.keys(Pc),zg=n=>Pd.map(t=>n[t]).join("_");function Gg(n){let t=n.replace(/_([zo])_i$/,"_$1-i").split("_");if(t.length!==Pd.length)return null;let e=Pd.map((i,s)=>[i,uS(i,t[s].replace("-i","_i"))]);return e.some(([,i])=>i===null)?null:Object.fromEntries(e)}function uS(n,t){let e=lS[n];if(e)return e.includes(t)?t:null;let[i,s]=Nd[n],r=t.trim()?Number(t):NaN;return hS.includes(n)&&!Number.isInteger(r)?null:r>=i&&r<=s?r:null}var Vg=4e3,Hg=Object.fromEntries(Qu.map(n=>[n[0].toUpperCase(),n])),dS=1e5,fS=8,js=n=>n?n.split(",").map(t=>t.trim()?Number(t):NaN):[];function Wg(n){let{arm:t,base:e,q:i,wrench:s,unit:r,view:o,frames:a,mark:c,answer:l,blended:h}=n,u={arm:e.name,q:gi(i),view:o,unit:r,frames:a};return s.some(Boolean)&&(u.wrench=gi(s)),(h||t!==e)&&(u.rows=Ym((h??t).rows)),h&&(u.blend=gi([h.share])),c&&(u.mark=gi(c)),l&&(u.answer=gi(l)),o==="homework"&&Object.assign(u,pS(n)),`#${new URLSearchParams(u)}`}function pS({q:n,runs:t,chosenRun:e,runStart:i}){let s={};return t.length&&(s.runs=t.map(zg).join(";")),e&&(s.run=String(e+1)),i&&gi(i)!==gi(n)&&(s.start=gi(i)),s}function mS(n,t,e){let i=n.replace(/^#/,"");if(!i||!/(^|&)arm=/.test(i))return{patch:{},message:""};if(i.length>Vg)return Dd(`it has ${i.length} characters; ${Vg} are the most`);let s=new URLSearchParams(i),r=t.find(d=>d.name===s.get("arm"));if(!r)return Dd(`there is no arm called “${s.get("arm").slice(0,40)}” here`);let o=SS(s.get("rows")),a=o&&zs(o),c=o&&!a?Gs(o,r):r,l=[{patch:{arm:c,base:r,reference:r},fault:a},gS(s,c,!!a),xS(s),_S(s,c,r),yS(s),vS(s,c),bS(s),wS(s,c),{patch:MS(s,e)}],h=Object.assign({},...l.map(d=>d.patch)),u=l.flatMap(d=>d.fault||[]);return u.length?{...Dd(u.join("; ")),patch:h}:{patch:h,message:""}}function gS(n,t,e){let i=js(n.get("q"));if(yn(t,i))return{patch:{q:i}};let r=n.has("q")&&!e&&`${t.name} has ${et(t).length} joint values`;return{patch:{q:is(t)},fault:r}}function xS(n){if(!n.has("wrench"))return{};let t=js(n.get("wrench"));return t.length===6&&t.every(i=>Math.abs(i)<=dS)?{patch:{wrench:t}}:{fault:"its wrench is not six numbers in N and N m"}}function _S(n,t,e){if(!n.has("blend"))return{patch:{blended:null}};let[i]=js(n.get("blend"));return hc(t,e)&&i>=0&&i<=1?{patch:uc({base:e,reference:e},t.rows,i)}:{patch:{blended:null},fault:"its tables have no arm between them at its blend"}}function yS(n){if(!n.has("mark"))return{patch:{mark:null}};let t=js(n.get("mark")),e=t.length===3&&t.every(s=>Math.abs(s)<=oc);return{patch:{mark:e?t:null},fault:!e&&"its mark is not three coordinates in metres"}}function vS(n,t){if(!n.has("answer"))return{patch:{answer:null}};let e=js(n.get("answer")),i=et(t).length,s=[i,6*i].includes(e.length)&&e.every(Number.isFinite),r=!s&&`its answer is neither ${i} torques nor a Jacobian of 6x${i} numbers`;return{patch:{answer:s?e:null},fault:r}}function bS(n){if(!n.has("runs"))return{};let t=n.get("runs").split(";").map(Gg);if(!(t.length<=fS&&!t.includes(null)))return{fault:"its runs cannot come from the homework"};let i=Number(n.get("run")??1)-1;return t[i]?{patch:{runs:t,chosenRun:i}}:{patch:{runs:t,chosenRun:0},fault:"it plays a run that it does not have"}}function wS(n,t){if(!n.has("start"))return{};let e=js(n.get("start"));return yn(t,e)?{patch:{runStart:e}}:{fault:`its runs begin at joint values that the ${t.name} does not have`}}function MS(n,t){let e={view:t,unit:["deg","rad"],frames:["all","ends"]},i=Object.keys(e).filter(s=>e[s].includes(n.get(s)));return Object.fromEntries(i.map(s=>[s,n.get(s)]))}var Dd=n=>({patch:{},message:`Part of the link was left out: ${n}.`});function SS(n){return n===null?null:n.split(";").map(t=>{let[e,...i]=t.split(","),[s,r,o,a]=i.length===4?js(i.join(",")):[];return{kind:Object.hasOwn(Hg,e)?Hg[e]:null,a:s,alpha:r,d:o,theta:a}})}function $g(n,t,e,i,s){let r=()=>{let{patch:a,message:c}=mS(location.hash,t,e);n.dispatch({type:"replaceState",...a},"link"),i(c)},o;return r(),n.dispatch({type:"setFields",past:[]},"link"),addEventListener("hashchange",r,{signal:s}),n.listen((a,c)=>{n.state.dragging||(clearTimeout(o),c!=="link"&&(o=setTimeout(()=>history.replaceState(null,"",Wg(n.state)),400)))},s),s.addEventListener("abort",()=>clearTimeout(o)),{copy(){return history.replaceState(null,"",Wg(n.state)),dc(location.href)}}}var qg={branches:({arm:n,q:t})=>Dg(n,t),circle:({arm:n,q:t,circle:e})=>kg(n,t,e),run:({arm:n,q:t,run:e})=>Ld(n,t,e)};var Xg="";function jg(n,t,e){let i=()=>e(qg[n](t));try{Xg||=URL.createObjectURL(new Blob(['(()=>{var x=(t,n)=>t[0]*n[0]+t[1]*n[1]+t[2]*n[2],A=(t,n)=>[t*n[0],t*n[1],t*n[2]],I=(t,n)=>[t[0]+n[0],t[1]+n[1],t[2]+n[2]],w=(t,n)=>[t[0]-n[0],t[1]-n[1],t[2]-n[2]],y=(t,n)=>[t[1]*n[2]-t[2]*n[1],t[2]*n[0]-t[0]*n[2],t[0]*n[1]-t[1]*n[0]],_=t=>Math.sqrt(t.reduce((n,o)=>n+o*o,0));var Ct=({x:t,y:n,z:o},e)=>[x(t,e),x(n,e),x(o,e)];var ot=(t,n,o,e)=>[t*n[0]+o*e[0],t*n[1]+o*e[1],t*n[2]+o*e[2]],Jn=[[1,0],[0,1],[-1,0],[0,-1]];function ht(t){let n=t/(Math.PI/2);return Math.abs(n-Math.round(n))>1e-12?[Math.cos(t),Math.sin(t)]:Jn[(Math.round(n)%4+4)%4]}function mt(t){let n=new WeakMap;return({rows:o})=>{let e=n.get(o);return e||n.set(o,e=t(o)),e}}var E=mt(t=>t.flatMap(({kind:n},o)=>n==="fixed"?[]:[o])),Ko=mt(t=>t.flatMap(({kind:n},o)=>n==="fixed"?[o]:[])),Qo=mt(t=>E({rows:t}).map(n=>n+1)),dt=mt(t=>E({rows:t}).map(n=>t[n].kind==="revolute"));function k(t,n){let[o,e,s,c]=[[1,0,0],[0,1,0],[0,0,1],[0,0,0]],r=[{x:o,y:e,z:s,o:c}],i=0;for(let a of t.rows){let l=a.kind==="fixed"?0:n[i++],[p,u]=ht(a.kind==="revolute"?a.theta+l:a.theta),[h,m]=ht(a.alpha),M=a.kind==="prismatic"?a.d+l:a.d;[o,e]=[ot(p,o,u,e),ot(p,e,-u,o)],c=I(ot(M,s,a.a,o),c),[e,s]=[ot(h,e,m,s),ot(h,s,-m,e)],r.push({x:o,y:e,z:s,o:c})}return r}function $(t,n,o=n.at(-1).o){return E(t).map(e=>{let{z:s,o:c}=n[e];return t.rows[e].kind==="revolute"?[...y(s,w(o,c)),...s]:[...s,0,0,0]})}var on=(t,n)=>Array.isArray(n)&&n.length===E(t).length&&n.every(Number.isFinite);function Pt(t){let n=t.kind==="revolute"?Math.PI:1;return[t.lower??-n,t.upper??n]}var Mt=class extends Error{constructor(n,o=[],e=void 0,s=void 0){super(n),this.advice=o,this.tokens=e,this.text=s,this.answers=void 0}};var en=(t,n=3)=>String(Number(t.toPrecision(n)));var et=1e-12,Lt=1e-11;function P(t,n,o){let[e,s]=[Math.cos(n),Math.sin(n)],c=I(A(e,o),A(s,y(t,o)));return I(c,A((1-e)*x(t,o),t))}var st=(t,n,o)=>t.turns?I(t.point,P(t.direction,n,w(o,t.point))):I(o,A(n,t.direction)),sn=(t,n,o)=>t.turns?P(t.direction,n,o):o,J=(t,n)=>w(n,A(x(t,n),t));function z(t,n,o,e,s){let c=Math.hypot(t,n),r=c-Math.abs(o);if(Math.abs(r)<et*e&&(r=0),c<Lt*e)return{values:[s],equal:!0,free:!0};let i=Math.atan2(Math.sqrt(Math.max(r,0)),Math.sqrt(c+Math.abs(o))),a=Math.atan2(n,t),l=2*(o<0?Math.PI/2-i:i);return Bt(a+l,a-l,r<=0)}function $t(t,n,o,e){if(Math.abs(n)<et/e)return{values:[Math.abs(t)<Lt?NaN:o/t],equal:!0,free:!1};let s=t*t+4*n*o;Math.abs(s)<4*Math.abs(n)*et*e&&(s=0);let c=Math.sqrt(Math.max(s,0));return Bt((-t+c)/(2*n),(-t-c)/(2*n),s<=0)}var Bt=(t,n,o)=>({values:o?[t]:[t,n],equal:o,free:!1});function B(t,n,o,e,s){let[c,r]=[J(t,n),J(t,o)];return Math.min(_(c),_(r))<Lt*e?{value:s,free:!0}:{value:Math.atan2(x(t,y(c,r)),x(c,r)),free:!1}}function xt(t,n,o,e){let s=(m,M)=>Math.atan2(_(y(m,M)),x(m,M)),[c,r]=[s(t,o),s(t,n)],i=s(o,e),a=(c+r+i)/2,l=gt(a-c)*gt(a-r),p=gt(a)*gt(a-i),u=2*Math.atan2(Math.sqrt(Math.max(l,0)),Math.sqrt(Math.max(p,0))),{value:h}=B(t,n,o,1,0);return Bt(h+u,h-u,l<=0||p<=0)}var gt=t=>Math.abs(t)>et&&Math.abs(Math.PI-t)>et?Math.sin(t):0;function j(t,n=6){let o=Array.from({length:n},(c,r)=>t.map(i=>i[r])),e=Array.from({length:n},(c,r)=>Array.from({length:n},(i,a)=>+(r===a)));for(let c=0,r=!0;r&&c<30;c++){r=!1;for(let i=0;i<n;i++)for(let a=i+1;a<n;a++)r=Xn(o,e,i,a)||r}let s=o.map((c,r)=>[Math.hypot(...c),r]).sort((c,r)=>r[0]-c[0]);return{values:s.map(([c])=>c),vectors:s.map(([,c])=>e[c])}}function Xn(t,n,o,e){let[s,c,r]=[0,0,0];for(let p=0;p<t[o].length;p++)s+=t[o][p]*t[o][p],c+=t[e][p]*t[e][p],r+=t[o][p]*t[e][p];if(Math.abs(r)<=1e-15*Math.sqrt(s*c)||r*r<1e-60)return!1;let i=(c-s)/(2*r),a=(i<0?-1:1)/(Math.abs(i)+Math.sqrt(1+i*i)),l=1/Math.sqrt(1+a*a);for(let p of[t,n])for(let u=0;u<p[o].length;u++){let[h,m]=[p[o][u],p[e][u]];p[o][u]=l*(h-a*m),p[e][u]=l*(a*h+m)}return!0}var Dt=(t,n)=>t.map((o,e)=>o-n[e]);function X(t,n){let o=t.map((s,c)=>[...s,n[c]]),e=o.length;for(let s=0;s<e;s++){let c=Kn(o,s,s);[o[c],o[s]]=[o[s],o[c]];for(let r=0;r<e;r++)r!==s&&Qn(o[r],o[s],s)}return o.map((s,c)=>s[e]/s[c])}function Kn(t,n,o){let e=n;for(let s=n;s<t.length;s++)Math.abs(t[s][o])>Math.abs(t[e][o])&&(e=s);return e}function Qn(t,n,o){let e=t[o]/n[o];for(let s=0;s<t.length;s++)t[s]-=e*n[s]}function rn(t,n=-1){let o=t.map((i,a)=>a).filter(i=>i!==n);if(!o.length)return[];let e=t[0].map((i,a)=>o.map(l=>t[l][a])),{values:s,vectors:c}=j(e,o.length),r=1e-5*Math.max(s[0],1e-12);return c.filter((i,a)=>s[a]<=r).map(i=>t.map((a,l)=>l===n?0:i[o.indexOf(l)]))}var G=(t,n)=>t[0]*n[0]+t[1]*n[1];function cn(t,{A:n,turns:o},e,s,c){let[r,i]=[0,1].map(a=>G(t,[n[0][a],n[1][a]]));return o?z(r,i,e,s,c):$t(r,i,e,s)}var Ut=({across:t},n,o,e,s)=>cn(t,o,G(t,Dt(n.b,o.b)),e,s);function jt({along:t},[n,o],e,s,c){let[r,i]=o.turns?[Math.cos(e),Math.sin(e)]:[e,e*e],l=o.A.map(p=>p[0]*r+p[1]*i).map((p,u)=>p+o.b[u]-n.b[u]);return cn(t,n,G(t,l),s,c)}function an(t,n,o){let[[e,s],[c,r]]=n.A,i=e*r-s*c,a=([f,d])=>[(r*f-s*d)/i,(e*d-c*f)/i],[l,p]=[0,1].map(f=>a([t.A[0][f],t.A[1][f]])),u=a(Dt(t.b,n.b)),h=f=>{let[d,g]=t.turns?[Math.cos(f),Math.sin(f)]:[f,f*f];return[l[0]*d+p[0]*g+u[0],l[1]*d+p[1]*g+u[1]]};if(!t.turns)return{roots:$t(2*l[0]*u[0]-l[1],l[0]**2-p[1],u[1]-u[0]**2,1),getThird:d=>h(d)[0]};let m=1-G(u,u)-G(l,l);return{roots:z(2*G(l,u),2*G(p,u),m,1,o),getThird:f=>Math.atan2(h(f)[1],h(f)[0])}}var un=1e-9,Zn=1e-6,to=.01;function pn(t,n,o,e){let s=n?Zn:to,[c,r]=[e,ln(t,o,e)];for(let i=0;i<4;i++){let a=bt(r);if(a<un/1e3||a>=s)break;let l=no(t,c,r);if(bt(l)>.1)break;let p=c.map((h,m)=>h+l[m]),u=ln(t,o,p);if(!(bt(u)<a))break;[c,r]=[p,u]}return bt(r)<un?c:null}var bt=t=>Math.max(...t.map(Math.abs));function no(t,n,o){let e=$(t,k(t,n)).map(r=>r.slice(0,o.length)),s=o.map((r,i)=>o.map((a,l)=>e.reduce((p,u)=>p+u[i]*u[l],i===l?1e-12:0))),c=X(s,o);return e.map(r=>r.reduce((i,a,l)=>i+a*c[l],0))}function ln(t,n,o){let{x:e,y:s,z:c,o:r}=k(t,o).at(-1);if(Array.isArray(n))return w(n,r);let i=I(I(y(e,n.x),y(s,n.y)),y(c,n.z)),a=x(e,n.x)+x(s,n.y)+x(c,n.z)<0?1:0;return[...w(n.o,r),...i.map(l=>l/2+a)]}var W=1e-4,hn=1e-10,oo=[.86,1.11,.99,.5,.57,1.08],qt=new WeakMap;function vt(t){return qt.has(t)||qt.set(t,eo(ro(t))),qt.get(t)??null}function eo(t){let{axes:n,size:o}=t,e=n.map(c=>c.turns),s=n.length>1&&rt(n)<W;if(n.length===6)return so(t);if(e.filter(Boolean).length===3&&n.length<5&&s)return{kind:"planar",...t,gap:rt(n)};if(n.length===3){let c=mn(n,o);return c<W?{kind:"position",...t,gap:c}:null}return n.length===2&&e.every(Boolean)&&s?{kind:"two links",...t,gap:rt(n)}:null}function so(t){let{axes:n,size:o}=t,e=[{kind:"wrist",three:n.slice(3),placing:n.slice(0,3)},{kind:"first three meet",three:n.slice(0,3),placing:n.slice(3).reverse()}];for(let{kind:s,three:c,placing:r}of e){let i=wt(c,o),a=mn(r,o);if(i&&a<W)return{kind:s,...t,centre:i.point,gap:Math.max(i.gap,a)}}if(!n.every(s=>s.turns))return null;for(let s=0;s<4;s++){let c=rt(n.slice(s,s+3)),r=[0,1,2].map(a=>(s+3+a)%6),i=[0,1].flatMap(a=>r[a+1]!==r[a]+1?[]:wt([n[r[a]],n[r[a+1]]],o)?.gap??[]);if(c<W&&i.length)return{kind:"parallel",...t,first:s,gap:Math.max(c,Math.min(...i))}}return null}function ro(t){let n=E(t),o=n.map((a,l)=>oo[l%6]),e=k(t,o),[s,c]=[e[0].o,0],r=n.map(a=>{let{z:l,o:p}=e[a],u=I(p,A(x(l,w(s,p)),l));return c+=_(w(u,s)),s=u,{direction:l,point:u,turns:t.rows[a].kind==="revolute"}}),i=e.at(-1);return{axes:r,size:c+_(w(i.o,s)),reference:o,tip:i}}function wt(t,n){if(!t.every(a=>a.turns))return null;for(let a=1;a<t.length;a++)if(_(y(t[a-1].direction,t[a].direction))<W)return null;let o=t.map(({direction:a})=>a.map((l,p)=>a.map((u,h)=>+(p===h)-l*u))),e=[0,1,2].map(a=>[0,1,2].map(l=>fn(o.map(p=>p[a][l])))),s=[0,1,2].map(a=>fn(t.map(({point:l},p)=>x(o[p][a],l)))),c=X(e,s),r=t.map(a=>_(y(a.direction,w(c,a.point)))),i=Math.max(...r)/n;return i<W?{point:c,gap:i}:null}var fn=t=>t.reduce((n,o)=>n+o,0),rt=t=>Math.max(...t.slice(1).map((n,o)=>_(y(t[o].direction,n.direction))));function mn([t,n,o],e){if(!t.turns&&!o.turns)return 0;let s=[t,o].map(c=>Wt(c,n,e).width);return!n.turns&&t.turns&&o.turns&&s.push(rt([t,o])),Math.min(...s)}function V(t,n){if(!t.turns)return{centre:n,X:t.direction,Y:[0,0,0],turns:!1};let o=w(n,t.point),e=w(o,A(x(t.direction,o),t.direction));return{centre:w(n,e),X:e,Y:y(t.direction,e),turns:!0}}function zt(t,{centre:n,X:o,Y:e,turns:s},c){let r=t.direction;if(!t.turns){let u=Gt(r),h=[u,y(r,u)].map(m=>[x(m,o),x(m,e),x(m,n)]);return{A:h.map(m=>m.slice(0,2)),b:h.map(m=>m[2]),turns:s}}let i=w(n,t.point),a=s?x(i,e):x(o,o)/2,l=x(i,i)+(s?x(o,o):0);return{A:[[x(r,o),x(r,e)],[x(i,o)/c,a/c]],b:[x(r,i),l/(2*c)],turns:s}}function Gt(t){let n=t.map(Math.abs).indexOf(Math.min(...t.map(Math.abs))),o=y(t,[0,1,2].map(e=>+(e===n)));return A(1/_(o),o)}function Wt(t,n,o){let e=I(t.point,A(o,[.3,-.7,.5])),{A:s}=zt(n,V(t,e),o),c=[0,1].map(p=>[s[0][p],s[1][p]]),{values:r,vectors:i}=j(c,2),[a,l]=[0,1].map(p=>{let[u,h]=i[p];return(Math.abs(u)>1e-6?u:h)<0?[-u,-h]:[u,h]});return{along:a,across:l,width:r[0]>0?r[1]/r[0]:0}}var Vt=({width:t})=>t<W;function Yt(t,n){let o=vt(t),e=dt(t),s=o.reference.map(c=>-c);return co(o,n,s).flatMap(c=>{let i=c.motions.map((h,m)=>o.reference[m]+h).map((h,m)=>e[m]?h-2*Math.PI*Math.round(h/(2*Math.PI)):h),a=i.every(Number.isFinite)?pn(t,o.gap<hn,n,i):null;if(!a)return[];let{names:l,free:p,times:u}=c;return[{name:l.join(", ")||"the only one",q:a,free:p,times:u,uncertainty:0}]})}function co(t,n,o){let{kind:e,axes:s,size:c,tip:r,centre:i}=t;if(e==="position")return gn(s,r.o,n,c,o);if(e==="two links")return Mo(t,n,o);let a=ao(r,n);if(e==="wrist")return dn(s,i,a,c,o);if(e==="parallel")return lo(t,a,o);if(e==="planar")return mo(t,a,o);let l=o.map(u=>-u).reverse();return dn([...s].reverse(),i,Mn(a),c,l).map(u=>({...u,motions:u.motions.map(h=>-h).reverse(),free:[...u.free].reverse()}))}function ao(t,n){let o=[0,1,2].map(e=>[0,1,2].map(s=>n.x[e]*t.x[s]+n.y[e]*t.y[s]+n.z[e]*t.z[s]));return{R:o,shift:w(n.o,Y(o,t.o))}}var Y=(t,n)=>t.map(o=>x(o,n)),K=({R:t,shift:n},o)=>I(Y(t,o),n);function Mn({R:t,shift:n}){let o=[0,1,2].map(e=>t.map(s=>s[e]));return{R:o,shift:A(-1,Y(o,n))}}var C=(t,{values:n,equal:o},e)=>n.flatMap((s,c)=>e(s).map(r=>({...r,names:o?r.names:[`${t} ${c?"-":"+"}`,...r.names],times:o?2*r.times:r.times}))),ct=(t,n)=>[{motions:t,free:n,names:[],times:1}];function gn([t,n,o],e,s,c,r){let[i,a]=[V(t,s),V(o,e)].map(d=>zt(n,d,c)),[l,p]=[t,o].map(d=>Wt(d,n,c)),[u,h]=[t.turns?"shoulder":"rod",o.turns?"elbow":"rod"],m=(d,g,b,v)=>{let[S,N]=[st(o,b,e),st(t,d,s)],R=io(n,S,N,c,r[1]);return ct([-d,R.value,b],[g,R.free,v])};if(Vt(p)){let d=Ut(p,a,i,c,-r[0]);return C(u,d,g=>{let b=jt(p,[a,i],g,c,r[2]);return C(h,b,v=>m(g,d.free,v,b.free))})}if(Vt(l)){let d=Ut(l,i,a,c,r[2]);return C(h,d,g=>{let b=jt(l,[i,a],g,c,-r[0]);return C(u,b,v=>m(v,b.free,g,d.free))})}let{roots:M,getThird:f}=an(i,a,-r[0]);return C(u,M,d=>m(d,M.free,f(d),!1))}function io({direction:t,point:n,turns:o},e,s,c,r){return o?B(t,w(e,n),w(s,n),c,r):{value:x(t,w(s,e)),free:!1}}function dn(t,n,o,e,s){let[c,r,i]=t.slice(3).map(a=>a.direction);return gn(t.slice(0,3),n,K(o,n),e,s).flatMap(a=>{let l=f=>a.motions.reduce((d,g,b)=>sn(t[b],-g,d),f),p=l(Y(o.R,i)),u=y(i,r),h=l(Y(o.R,u)),m=xt(r,i,c,p);return C("wrist",m,f=>{let d=B(c,P(r,f,i),p,1,s[3]),g=P(r,-f,P(c,-d.value,h)),b=B(i,u,g,1,s[5]);return ct([d.value,f,b.value],[d.free,!1,!1])}).map(f=>uo(a,f))})}var uo=(t,n)=>({motions:[...t.motions,...n.motions],free:[...t.free,...n.free],names:[...t.names,...n.names],times:t.times*n.times});function lo({axes:t,first:n,size:o},e,s){let c=t.slice(n,n+3),r=Mn(e),i=[0,1,2].map(f=>(n+3+f)%6),a=i.map(f=>f<n?po(r,t[f]):t[f]),l=f=>i[f+1]===i[f]+1,p=f=>{let d=[t[i[f]],t[i[f+1]]],g=l(f)&&wt(d,o);return g&&(i[f]<n?K(r,g.point):g.point)},u=c[0].direction,h={h:u,hBack:Y(r.R,u),motion:e,size:o,start:i.map(f=>s[f])},m=p(0);return(m?fo(h,a,m):ho(h,a,p(1))).flatMap(f=>{let d=b=>K(e,f.motions.reduce((v,S,N)=>st(a[N],-S,v),b)),g=s.slice(n,n+3);return Ht(c,d,o,g).map(b=>{let v=new Array(6),S=new Array(6);for(let R of[0,1,2])[v[n+R],S[n+R]]=[b.motions[R],b.free[R]],[v[i[R]],S[i[R]]]=[f.motions[R],f.free[R]];let N=[...f.names,...b.names];return{motions:v,free:S,names:N,times:f.times*b.times}})})}var po=(t,n)=>({direction:Y(t.R,n.direction),point:K(t,n.point),turns:n.turns});function fo({h:t,hBack:n,motion:o,size:e,start:s},[c,r,i],a){let{centre:l,X:p,Y:u}=V(i,a),h=x(t,a)-x(t,o.shift)-x(n,l),m=z(x(n,p),x(n,u),h,e,-s[2]);return C("shoulder",m,M=>{let f=P(i.direction,-M,n);return C("wrist",xt(r.direction,f,c.direction,t),d=>{let g=B(c.direction,P(r.direction,d,f),t,1,s[0]);return ct([g.value,d,-M],[g.free,!1,m.free])})})}function ho({h:t,hBack:n,motion:o,size:e,start:s},[c,r,i],a){let{centre:l,X:p,Y:u}=V(c,a),h=x(t,K(o,a))-x(t,l),m=z(x(t,p),x(t,u),h,e,s[0]);return C("shoulder",m,M=>{let f=P(c.direction,-M,t),d=xt(i.direction,n,r.direction,f);return C("wrist",d,g=>{let b=P(i.direction,g,n),v=B(r.direction,b,f,1,s[1]);return ct([M,v.value,g],[m.free,v.free,!1])})})}function Ht([t,n,o],e,s,c){let r=t.direction,i=J(r,w(e(o.point),t.point)),{centre:a,X:l,Y:p}=V(n,o.point),u=J(r,w(a,t.point)),h=(x(i,i)-x(u,u)-x(l,l))/s,m=z(2*x(u,l)/s,2*x(u,p)/s,h,s,c[1]),M=Gt(r),f=w(e(I(o.point,M)),e(o.point)),d=B(r,M,f,1,c[2]).value;return C("elbow",m,g=>{let b=J(r,w(st(n,g,o.point),t.point)),v=B(r,b,i,s,c[0]),S=x(n.direction,r),N=x(o.direction,r)*(d-v.value-S*g);return ct([v.value,g,N],[v.free,m.free,!1])})}function mo({axes:t,size:n},o,e){let s=t.flatMap((a,l)=>a.turns?[l]:[]),c=s.map(a=>t[a]),r=s.map(a=>e[a]),i=a=>K(o,a);return Ht(c,i,n,r).map(a=>{let[l,p]=[[],[]];return t.forEach(({direction:u,point:h,turns:m},M)=>{let f=s.indexOf(M);l.push(m?a.motions[f]:x(u,w(i(h),h))),p.push(m&&a.free[f])}),{...a,motions:l,free:p}})}function Mo({axes:t,size:n,tip:o},e,s){let c={direction:t[0].direction,point:o.o,turns:!0};return Ht([...t,c],()=>e,n,[...s,s[0]]).map(i=>({...i,motions:i.motions.slice(0,2),free:i.free.slice(0,2)}))}var F=1e-12,Rt=1e-11,Q=1e-15,at=["front","back"],yt=["q_5 > 0","q_5 < 0"];function go(t){let n=Math.round(t);return n-t===.5&&n%2?n-1:n}var D=t=>go(t*(.5/Math.PI))*(-2*Math.PI)+t,O=(t,n)=>n?D(t-n):t,At=(t,n,o)=>Math.min(Math.max(t,n),o);function L(t){let[n,o]=ht(t.alpha);return{...t,ca:n,sa:o}}function it(t,n,o){let[e,s,c]=o,r=t.sa*n,i=e*e+s*s-r*r,a=Math.max(2*Math.abs(r)*F,F**2),l=Math.abs(i)<=a,p=Math.sqrt(i>a?i:0),u=[p,-p],h=l&&r===0,m=[t.theta,t.theta+Math.PI];return{phi:u.map((M,f)=>h?m[f]:Math.atan2(s*M+e*r,e*M-s*r)),x:u,y:t.sa*(c-t.d),exists:i>=-a,isDouble:l,free:h,uncertainty:l?0:Q/Math.max(p,F)}}var St=({upper:t,fore:n})=>Math.abs(t)+Math.abs(n),kt=({upper:t,fore:n})=>Math.abs(Math.abs(t)-Math.abs(n));function It(t,[n,o],e,s,c=0){let{upper:r,fore:i}=t,[a,l,p]=[St(t),kt(t),n*n+o*o],u=Math.sqrt(p),h=Math.min(Math.abs(u-a),Math.abs(u-l)),m=h<=F+c,M=At((p-(r**2+i**2))*(.5/(r*i)),-1,1),f=h<=F?Math.round(M):M,d=Math.sqrt(1-f*f),[g,b]=[r+i*f,e*(i*d)],v=m&&u<=F,S=m||l<u&&u<a;return{phi2:v?s:Math.atan2(o*g-n*b,n*g+o*b),phi3:e*Math.atan2(d,f),exists:S,isDouble:m,free:v,uncertainty:m||!S?0:Q*a/(Math.abs(r*i)*d)}}function Et(t,{x:n,y:o,z:e,o:s}){let[c,r]=[t.ca,t.sa],i={x:n,y:I(A(c,o),A(-r,e)),z:I(A(r,o),A(c,e))},a=w(s,A(t.d,i.z));return{...i,centre:t.a?w(a,A(t.a,n)):a}}function Z(t,n,o=[],e=[]){if(!t.length){let r=n(...e),i=r?xo(r.merged,e):0;return i?[{name:o.join(", "),times:i,...r}]:[]}let[s,...c]=t;return s.flatMap((r,i)=>Z(c,n,[...o,r],[...e,i]))}var xo=(t,n)=>t.some((o,e)=>o&&n[e])?0:2**t.filter(Boolean).length;var bo=["elbow +","elbow -"];function xn(t,n){let o=t.rows.map(L),[,e,s,c]=o,r=e.ca*s.ca,i=e.d+e.ca*s.d+r*c.d,a={upper:e.a,fore:s.a},l={rows:o,links:a,side:-c.sa*r},p=Et(o[5],n),u=it(o[0],i,p.centre),h=[0,1].map(m=>wo(l,u,p,m));return Z([at,yt,bo],(m,M,f)=>{let{phi5:d,phi6:g,u:b,singular:v,uncertainty:S}=h[m][M],N=bn(l,u.x[m],u.y,b),R=It(a,N,f?-1:1,e.theta,S);if(!u.exists||!R.exists)return null;let ft=Math.atan2(b[1],b[0]),U=[O(u.phi[m],o[0].theta),O(R.phi2,e.theta),O(e.ca*R.phi3,s.theta),D(r*(ft-R.phi2-R.phi3)-c.theta),O(d,o[4].theta),O(g,o[5].theta)],q=v&&!wn(l,u.x[m],u.y),nt=[u.free,R.free,!1,!1,!1,q];return{q:U,free:nt,merged:[u.isDouble,v,R.isDouble]}})}function wo(t,n,o,e){let{rows:s}=t,[c,r]=[Math.cos(n.phi[e]),Math.sin(n.phi[e])],{sa:i}=s[0],a=[o.x,o.y,o.z].map(([T,Tt])=>i*(r*T-c*Tt)),l=([T,Tt,Hn])=>[c*T+r*Tt,i*Hn],[p,u,h]=[o.x,o.y,o.z].map(l),m=Math.sqrt(a[0]*a[0]+a[1]*a[1]),M=t.side*s[4].sa*a[2],f=m<Rt+n.uncertainty,d=f?0:m,g=f?0:(Q+n.uncertainty)/d,b=Math.abs(s[4].d)*g,v=t.side/(f?1:d),[S,N]=[-v*a[0],v*a[1]],R=f?s[5].theta:Math.atan2(N,S);f&&([S,N]=[Math.cos(R),Math.sin(R)]);let ft=s[4].sa*d,U=[0,1].map(T=>ft*h[T]+M*(S*p[T]-N*u[T])),q=Math.atan2(d,M),nt=R<0||Object.is(R,-0)?-Math.PI:Math.PI,nn=[{phi5:q,phi6:R,u:U,singular:f,uncertainty:b},{phi5:-q,phi6:f?R:R-nt,u:f?U:U.map(T=>-T),singular:f,uncertainty:b}];return f||g>F?nn.map(T=>vo(t,n.x[e],n.y,T)):nn}function bn({side:t,rows:n},o,e,s){let c=t*n[4].d;return[o+c*s[1],e-c*s[0]]}function wn({rows:t,links:n},o,e){let[s,c]=[Math.hypot(o,e),Math.abs(t[4].d)],[r,i]=[Math.abs(s-c),s+c];return(r>=St(n)-2*F||i<=kt(n)+2*F)&&Math.min(s,c)>F}function vo(t,n,o,e){let{rows:s,links:c,side:r}=t,i=Math.abs(s[4].d),[a,l]=e.u,[p,u]=bn(t,n,o,e.u),[h,m]=[Math.hypot(n,o),Math.hypot(p,u)],M=At(m,kt(c),St(c)),f=wn(t,n,o),[d,g]=[n-p,o-u],b=Math.atan2(n*g-o*d,n*d+o*g),v=(h**2+i**2-M**2)/Math.max(2*h*i,1e-300),S=Math.acos(At(f?Math.round(v):v,-1,1)),N=(b<0||Object.is(b,-0)?-S:S)-b,R=Math.max(Math.abs(m-M),i*Math.abs(N)/2);if(!(e.singular?f||m!==M:R<=e.uncertainty))return{...e,phi6:D(e.phi6)};let[U,q]=[Math.cos(N),Math.sin(N)],nt=r*s[4].sa*Math.cos(e.phi5);return{...e,u:[U*a-q*l,q*a+U*l],phi6:D(e.phi6-Math.sign(nt)*N)}}var Ro=["elbow up","elbow down"],yo=["rod out","rod through"];function vn(t,n){let[o,e,s,c]=t.rows.map(L),r=En(e,s,c?.d??0),i=it(o,r.offset,n);return Z([at,Ro],(a,l)=>{let p=o.sa*(a===l?-1:1),u=It(r,[i.x[a],i.y],p,e.theta);if(!i.exists||!u.exists)return null;let h=[O(i.phi[a],o.theta),O(u.phi2,e.theta),O(e.ca*u.phi3,r.beta+s.theta)],m=[i.free,u.free,!1],M=i.uncertainty+u.uncertainty;return{q:h,free:m,merged:[i.isDouble,u.isDouble],uncertainty:M}})}function En(t,n,o){let e=-o*n.sa;return{upper:t.a,fore:Math.hypot(n.a,e),beta:Math.atan2(e,n.a),offset:t.d+t.ca*(n.d+o*n.ca)}}function Rn(t,n){let[o,e,s,c]=t.rows.map(L),r=it(o,e.d,n);return Z([at,yo],(i,a)=>{if(!r.exists)return null;let l=a?-1:1,p=l*Math.hypot(r.x[i],r.y),u=e.sa*l,h=Math.abs(p)<F,m=Math.atan2(u*r.x[i],-u*r.y),M=[O(r.phi[i],o.theta),h?0:O(m,e.theta),p-s.d-(c?.d??0)],f=Q+Math.hypot(n[0],n[1])*r.uncertainty,d=r.uncertainty+(h?0:f/Math.abs(p)),g=[r.free,h,!1];return{q:M,free:g,merged:[r.isDouble,h],uncertainty:d}})}var Jt=t=>({...t,rows:[...t.rows.slice(0,3),{kind:"fixed",a:0,alpha:0,d:t.rows[3].d,theta:0}]});function yn(t,n,o){let e=n.rows.map(L),s=Et(e[5],o),c=Jt(n);return t(c,s.centre).flatMap(({name:r,q:i,free:a,times:l,uncertainty:p})=>{let u=k(c,i).at(-1),[h,m]=[s.x,s.z].map(d=>Ct(u,d)),{pairs:M,singular:f}=Ao(e,h,m,p);return yt.slice(0,f?1:2).map((d,g)=>({name:`${r}, ${d}`,times:f?2*l:l,q:[...i,...M.map((b,v)=>D(b[g]-e[3+v].theta))],free:[...a,f,!1,!1]}))})}function Ao(t,n,o,e){let[s,c]=[t[3].sa,t[4].sa],r=-s*c*o[2],i=Math.hypot(o[0],o[1])<Rt+e,a=i?0:Math.hypot(o[0],o[1]),l=i?t[3].theta:Math.atan2(c*o[1],c*o[0]),[p,u]=[Math.cos(l),Math.sin(l)],[h,m]=[p*n[0]+u*n[1],p*n[1]-u*n[0]],M=Math.atan2(a,r),f=Math.atan2(-s*c*m,r*h+s*a*n[2]),d=i?0:Math.PI;return{pairs:[[l,l+d],[M,-M],[f,f+d]],singular:i}}var Nt=t=>t.map(({kind:n})=>n[0]).join("");function An({rows:t}){if(!["rrr","rrrf"].includes(Nt(t)))return!1;let[n,o,e,s]=t.map(L);return n.a===0&&n.ca===0&&o.sa===0&&o.a!==0&&En(o,e,s?.d??0).fore>0&&!s?.a}function Sn({rows:t}){if(!["rrp","rrpf"].includes(Nt(t)))return!1;let[n,o,e]=t.map(L);return n.ca===0&&o.ca===0&&e.sa===0&&e.ca===1&&t.every(({a:c})=>c===0)}function kn({rows:t}){if(t.length!==6||Nt(t.slice(3))!=="rrr")return!1;let[n,o]=t.slice(3).map(L);return n.a===0&&o.a===0&&o.d===0&&n.ca===0&&o.ca===0}function So({rows:t}){if(Nt(t)!=="rrrrrr")return!1;let[n,o,e,s,c]=t.map(L);return[n,s,c].every(({a:i,ca:a})=>i===0&&a===0)&&o.sa===0&&e.sa===0&&o.a*e.a!==0}var ut={elbow:{fits:An,solve:vn,pose:!1},rod:{fits:Sn,solve:Rn,pose:!1},stanford:{fits:t=>kn(t)&&Sn(Jt(t)),solve:(t,n)=>yn(Rn,t,n),pose:!0},spherical_wrist:{fits:t=>kn(t)&&An(Jt(t)),solve:(t,n)=>yn(vn,t,n),pose:!0},ur:{fits:So,solve:xn,pose:!0},solutions:{fits:t=>In(t)===!0,solve:Yt,pose:!0},positions:{fits:t=>In(t)===!1,solve:Yt,pose:!1}};function In(t){let n=vt(t);return n&&!["position","two links"].includes(n.kind)}var Nn=t=>Object.keys(ut).find(n=>ut[n].fits(t))??null,_n=t=>ut[t].pose;function Fn(t,n,o){return ut[n].pose&&Io(t,o),ut[n].solve(t,o)}var ko=1e-6;function Io(t,{x:n,y:o,z:e}){let s=[...w(y(n,o),e),...[n,o,e].map(r=>x(r,r)-1)],c=Math.max(...s.map(Math.abs));if(c>ko)throw new Mt(`${t.name}: a target is no rigid transform, by ${en(c,2)}; expected a rotation and a position over (0, 0, 0, 1)`)}var Eo=[[1,0,0],[0,1,0],[0,0,1]];function On({centre:t,radius:n,plane:o,period:e,steps:s,phase:c=0}){let[r,i]=[...o].map(p=>Eo["xyz".indexOf(p)]),a=2*Math.PI/e,l=p=>{let u=c+a*p;return[Math.cos(u),Math.sin(u)]};return{times:Array.from({length:s+1},(p,u)=>u===s?e:u*(e/s)),position:p=>{let[u,h]=l(p);return t.map((m,M)=>m+n*(u*r[M]+h*i[M]))},velocity:p=>{let[u,h]=l(p);return t.map((m,M)=>n*a*(u*i[M]-h*r[M]))},normal:y(r,i)}}var No=1e-12,_o=[.37,.81].map(t=>Array.from({length:16},(n,o)=>t+Math.sin(1+2.3*o))),Xt=new WeakMap;function Tn(t){if(!Xt.has(t.rows)){let n=_o.flatMap(e=>$(t,k(t,e))),o=e=>n.some(s=>Math.abs(s[e])>No);Xt.set(t.rows,[0,1,2,3,4,5].filter(o))}return Xt.get(t.rows)}var Fo=t=>Tn(t).filter(n=>n<3);function H(t){let n=Tn(t);if(n.length<=E(t).length)return n;let o=Fo(t);return o.length<3&&o.length<=E(t).length?o:[0,1,2]}var Cn=t=>H(t).some(n=>n>=3),tt=(t,n)=>n.map(o=>t[o]);var Le=["move along","turn about"].flatMap(t=>[..."xyz"].map(n=>`${t} ${n}`));var Pn=(t,n,o)=>t.map((e,s)=>s===n?o:e);var Oo=t=>Math.max(0,E(t).length-H(t).length);function Ft(t,n){let o=["x","y","z"].reduce((e,s)=>I(e,y(t[s],n[s])),[0,0,0]);return[...w(n.o,t.o),...A(.5,o)]}var lt=(t,n)=>t.reduce((o,e,s)=>o+e*n[s],0),To=(t,n,o)=>X(t.map((e,s)=>t.map((c,r)=>lt(e,c)+(s===r?o:0))),n);function Qt(t,n,o,{lockedJoint:e=-1,rows:s=H(t),steps:c=60}={}){let r=[...n];for(let i=0;;i++){let a=k(t,r),l=tt(Ft(a.at(-1),o),s),p=_(l);if(p<1e-11||i===c||!r.length)return{q:r,error:p};let u=$(t,a).map((f,d)=>tt(f,s).map(g=>d===e?0:g)),h=u.map(f=>lt(f,l)),m=To(u,h,.02*p*p+1e-12),M=Math.max(1e-12,...m.map(Math.abs));r=r.map((f,d)=>f+m[d]*Math.min(1,.6/M))}}var Co={x:["zy",1],y:["zx",-1],z:["yx",1]};function pt(t,{normal:n="x",radius:o=.1,seconds:e=1},s){let[c,r]=Co[n],i=t.map((p,u)=>p-("xyz"[u]===c[0]?o:0)),a=On({centre:i,radius:o,plane:c,period:r*e,steps:1}),l=s*e;return{o:a.position(l),v:a.velocity(l)}}var Ln=.05;function Po(t,n,o){let e=t;for(let s of n.keys())for(let c of[Ln,-Ln]){let r=o(Pn(n,s,n[s]+c));r.error<.98*e.error&&(e=r)}return e}function Bn(t,n,o,e){let s=i=>Qt(t,i,o,e),c=s(n);return c.error>1e-6&&Go(c.q,n)?Po(c,n,s):c}function Lo(t){return()=>(t=Math.imul(t,1664525)+1013904223>>>0)/2**32}function $o(t,n=Math.random){return E(t).map(o=>{let[e,s]=Pt(t.rows[o]);return e+(s-e)*n()})}var Bo=16,Do=300;function Dn(t,n){let o=k(t,n).at(-1),e=Cn(t);if(!on(t,n)||!n.length)return{list:[],families:[],lockedJoint:-1,target:o,hasOrientation:e};let s=Oo(t)?2:-1,c=Lo(1),r=[],i=[],a=(h,m)=>{if(r.some(f=>qo(t,f,h))||i.some(({q:f})=>_t(t,f,h)<.001))return;let M=jo(t,h,o,s);i.push(m?{q:h,label:m}:{q:h}),M.length&&r.push({moving:M,q:h})},l=Uo(t,o,e);for(let{q:h,name:m}of l)a(Kt(t,h),m);a(Kt(t,n));for(let h=0;!l.length&&h<Do&&i.length<Bo;h++){let m=$o(t,c).map((d,g)=>g===s?n[g]:d),{q:M,error:f}=Qt(t,m,o,{lockedJoint:s});f<1e-9&&a(Kt(t,M))}let p=({q:h})=>_t(t,h,n);return{list:[...i].sort((h,m)=>p(h)-p(m)),families:r,lockedJoint:s,target:o,hasOrientation:e}}function Uo(t,n,o){let e=Nn(t);return!e||_n(e)!==o?[]:Fn(t,e,o?n:n.o)}var $n=.1;function jo(t,n,o,e){let s=H(t),c=$(t,k(t,n)).map((l,p)=>tt(l,s).map(u=>p===e?0:u)),{values:r}=j(c,s.length),i=E(t).length-(e<0?0:1);if(r.filter(l=>l>1e-5*r[0]).length>=Math.min(s.length,i))return[];let a=new Set;for(let l of rn(c,e)){let p=n.map((h,m)=>h+$n*l[m]),u=Qt(t,p,o,{lockedJoint:e,steps:200});u.error>1e-9||_t(t,u.q,n)<.3*$n||u.q.forEach((h,m)=>Math.abs(h-n[m])>.001&&a.add(m))}return[...a].sort((l,p)=>l-p)}function qo(t,{moving:n,q:o},e){let s=e.map((c,r)=>n.includes(r)?o[r]:c);return _t(t,o,s)<.001}function Kt(t,n){return E(t).map((o,e)=>{if(t.rows[o].kind!=="revolute")return n[e];let[s,c]=Pt(t.rows[o]),r=D(n[e]);return[r,r+2*Math.PI,r-2*Math.PI].find(i=>i>=s&&i<=c)??r})}function _t(t,n,o){let e=(s,c)=>t.rows[s].kind==="revolute"?2*Math.sin((n[c]-o[c])/2):n[c]-o[c];return Math.max(...E(t).map((s,c)=>Math.abs(e(s,c))))}var zo=1e-4,Go=(t,n)=>t.length===n.length&&t.every((o,e)=>Math.abs(o-n[e])<zo);var Un=(t,n)=>({rows:t.rows,q:n,at:E(t),turns:dt(t),dof:n.length});function jn(t,n,o={}){let{axis:e=t.at,origin:s=t.at,subtracted:c=!0,point:r=n.length-1,slides:i=!0,crossed:a=!0}=o,l=n[r].o,p=new Array(6*t.dof);return t.at.forEach((u,h)=>{let[m,M]=[n[e[h]].z,n[s[h]].o],f=t.turns[h]||!i,d=c?w(l,M):l,g=f?a?y(m,d):d:m;for(let b=0;b<3;b++)p[b*t.dof+h]=g[b],p[(b+3)*t.dof+h]=f?m[b]:0}),p}var qn=(t,n)=>[...t.slice(0,t.length/2),...n.slice(n.length/2)];var zn={method:"euler",rates:"inverse",steps:1e3,seconds:5,radius:.1,normal:"x",gain:0,cutoff:1e-9,damping:.02,locked:-1,mistake:""};function Wo(t,n,o,e){let s=Un(t,n),c=s.at.map(l=>l+1),r=l=>jn(s,o,l),a={angular:()=>qn(r({}),r({axis:c})),z_i:()=>r({axis:c,origin:c}),o_i:()=>r({origin:c})}[e]?.()??r({});return n.map((l,p)=>[0,1,2,3,4,5].map(u=>a[u*s.dof+p]))}var Ot=class extends Error{},Gn=(t,n)=>t.map((o,e)=>e).filter(o=>o!==n),Wn=t=>t[Math.min(5,t.length-1)]<=1e-9*t[0];function Vo(t,n,o){let e=$(t,k(t,n));return Wn(j(Gn(e,o).map(s=>e[s])).values)}function Yo(t,n,{rates:o,cutoff:e,damping:s,locked:c}){let r=Gn(t,c),{values:i,vectors:a}=j(r.map(u=>t[u])),l=o==="pseudo"?e*i[0]:0;if(o==="inverse"&&Wn(i))throw new Ot;let p=t.map(()=>0);return i.forEach((u,h)=>{if(u<=l||u<1e-14)return;let m=u**2+(o==="damped"?s**2:0),M=lt(a[h],n)/m;for(let f of r)p[f]+=M*lt(t[f],a[h])}),{solution:p,smallestSigma:i[Math.min(5,r.length-1)]}}var Ho=181,Jo=.001,Zt=class{constructor(n,o,e){this.arm=n,this.run=e,this.q=[...o],this.first=k(n,o).at(-1),this.every=Math.max(1,Math.ceil(e.steps/(Ho-1))),this.kept={path:[o],errors:[0],at:[0]},this.worst={smallestSigma:1/0,largestError:0,fastestRate:0,largestTilt:0}}computeRates(n,o){let{arm:e,run:s,first:c,worst:r}=this,i=k(e,o),{o:a,v:l}=pt(c.o,s,n),p=s.gain?Ft(i.at(-1),{...c,o:a}):[0,0,0,0,0,0],u=[...l,0,0,0].map((M,f)=>M+s.gain*p[f]),{solution:h,smallestSigma:m}=Yo(Wo(e,o,i,s.mistake),u,s);return r.smallestSigma=Math.min(r.smallestSigma,m),s.mistake==="sign"?h.map(M=>-M):h}computeNextJoints(n,o){let{arm:e,run:s,first:c,q:r,worst:i}=this,a=this.computeRates(s.mistake==="next"?o:n,r);if(i.fastestRate=Math.max(i.fastestRate,...a.map(Math.abs)),s.method==="exact"){let f={...c,o:pt(c.o,s,o).o};return Bn(e,r,f,{lockedJoint:s.locked}).q}let l=s.seconds/s.steps,p=(f,d)=>r.map((g,b)=>g+d*f[b]);if(s.method==="euler")return p(a,l);let u=n+.5/s.steps,h=this.computeRates(u,p(a,l/2)),m=this.computeRates(u,p(h,l/2)),M=this.computeRates(o,p(m,l));return r.map((f,d)=>f+l/6*(a[d]+2*h[d]+2*m[d]+M[d]))}makeStep(n){let{arm:o,run:e,first:s,worst:c,kept:r}=this,i=(n+1)/e.steps;try{this.q=this.computeNextJoints(n/e.steps,i)}catch(m){if(m instanceof Ot)return!1;throw m}let a=k(o,this.q).at(-1),l={...s,o:pt(s.o,e,i).o},p=_(w(a.o,l.o)),u=Math.atan2(_(y(a.z,s.z)),x(a.z,s.z));c.largestTilt=Math.max(c.largestTilt,u),c.largestError=Math.max(c.largestError,p);let h=_(tt(Ft(a,l),H(o)));return e.method==="exact"&&h>Jo?!1:(((n+1)%this.every===0||n+1===e.steps)&&(r.path.push(this.q),r.errors.push(p),r.at.push(i)),Number.isFinite(p))}};function tn(t,n,o={}){let e={...zn,...o};e.method==="exact"&&(e.rates="pseudo");let s=new Zt(t,n,e),c=0;for(;c<e.steps&&s.makeStep(c);)c++;let r=E(t).map(p=>t.rows[p].kind==="revolute"?2*Math.PI:0),i=s.q.map((p,u)=>r[u]?(p-n[u])/r[u]:0),a=c<e.steps?c:null,l=a!==null&&Vo(t,s.q,e.locked);return{...s.kept,run:e,...s.worst,failedStep:a,isSingular:l,windings:i}}function Vn(t,n,o={}){let{o:e}=k(t,n).at(-1),{path:s}=tn(t,n,{method:"exact",steps:180,...o});return s.length===1&&s.push(n),{path:s,wantedPath:Array.from({length:181},(c,r)=>pt(e,o,r/180).o)}}var ss=Object.keys(zn);var Yn={branches:({arm:t,q:n})=>Dn(t,n),circle:({arm:t,q:n,circle:o})=>Vn(t,n,o),run:({arm:t,q:n,run:o})=>tn(t,n,o)};onmessage=({data:{job:t,input:n}})=>postMessage(Yn[t](n));})();\n'],{type:"text/javascript"}));let s=new Worker(Xg);return s.onerror=i,s.onmessage=({data:r})=>{s.terminate(),e(r)},s.postMessage({job:n,input:t}),()=>s.terminate()}catch{return i(),()=>{}}}var Lc=(n,t)=>new Promise(e=>jg(n,t,e));function Sr(n){let t=()=>{};return(e,i)=>{t(),t=jg(n,e,i)}}var _s={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},ys={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},R0=0,pf=1,C0=2;var er=1,I0=2,Zr=3,vs=0,gn=1,Mn=2,nr=0,Kr=1,mf=2,gf=3,xf=4,P0=5;var ir=100,L0=101,N0=102,D0=103,O0=104,U0=200,F0=201,k0=202,B0=203,_f=204,yf=205,z0=206,G0=207,V0=208,H0=209,W0=210,$0=211,q0=212,X0=213,j0=214,sl=0,rl=1,ol=2,zr=3,al=4,cl=5,ll=6,hl=7,vf=0,Y0=1,J0=2,Ei=0,bf=1,wf=2,Mf=3,Sf=4,Ef=5,Tf=6,Af=7;var Rf=300,sr=301,Qr=302,Hl=303,Wl=304,ul=1e3,wi=1001,dl=1002,qe=1003,Z0=1004;var ga=1005;var pn=1006,$l=1007;var ji=1008;var Sn=1009,Cf=1010,If=1011,to=1012,ql=1013,ci=1014,Yn=1015,li=1016,Xl=1017,jl=1018,rr=1020,Pf=35902,Lf=35899,Nf=1021,Df=1022,hi=1023,Wi=1026,Yi=1027,Yl=1028,Jl=1029,bs=1030,Zl=1031;var Kl=1033,xa=33776,_a=33777,ya=33778,va=33779,Ql=35840,th=35841,eh=35842,nh=35843,ih=36196,sh=37492,rh=37496,oh=37488,ah=37489,ba=37490,ch=37491,lh=37808,hh=37809,uh=37810,dh=37811,fh=37812,ph=37813,mh=37814,gh=37815,xh=37816,_h=37817,yh=37818,vh=37819,bh=37820,wh=37821,Mh=36492,Sh=36494,Eh=36495,Th=36283,Ah=36284,wa=36285,Rh=36286;var Go=2300,fl=2301,nl=2302,of=2303,af=2400,cf=2401,lf=2402;var K0=3200;var Ch=0,Q0=1,Ji="",Nn="srgb",Vo="srgb-linear",Ho="linear",ue="srgb";var il=7680;var tx=519,ex=512,nx=513,ix=514,Of=515,sx=516,rx=517,Uf=518,Ff=519,ox=35044,kf=35048;var Bf="300 es",qn=2e3,Gr=2001;function ES(n){for(let t=n.length-1;t>=0;--t)if(n[t]>=65535)return!0;return!1}function TS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Wo(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function ax(){let n=Wo("canvas");return n.style.display="block",n}var Yg={},Vr=null;function zf(...n){let t="THREE."+n.shift();Vr?Vr("log",t,...n):console.log(t,...n)}function cx(n){let t=n[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=n[1];e&&e.isStackTrace?n[0]+=" "+e.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Bt(...n){n=cx(n);let t="THREE."+n.shift();if(Vr)Vr("warn",t,...n);else{let e=n[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...n)}}function Wt(...n){n=cx(n);let t="THREE."+n.shift();if(Vr)Vr("error",t,...n);else{let e=n[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...n)}}function Uo(...n){let t=n.join(" ");t in Yg||(Yg[t]=!0,Bt(...n))}function lx(n,t,e){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(t,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:i()}}setTimeout(r,e)})}var hx={[sl]:sl,[ol]:ll,[al]:al,[zr]:cl,[rl]:rl,[ll]:ol,[hl]:hl,[cl]:zr},ai=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[t]===void 0&&(i[t]=[]),i[t].indexOf(e)===-1&&i[t].push(e)}hasEventListener(t,e){let i=this._listeners;return i===void 0?!1:i[t]!==void 0&&i[t].indexOf(e)!==-1}removeEventListener(t,e){let i=this._listeners;if(i===void 0)return;let s=i[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let i=e[t.type];if(i!==void 0){t.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},sn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Jg=1234567,Fo=Math.PI/180,Hr=180/Math.PI;function eo(){let n=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(sn[n&255]+sn[n>>8&255]+sn[n>>16&255]+sn[n>>24&255]+"-"+sn[t&255]+sn[t>>8&255]+"-"+sn[t>>16&15|64]+sn[t>>24&255]+"-"+sn[e&63|128]+sn[e>>8&255]+"-"+sn[e>>16&255]+sn[e>>24&255]+sn[i&255]+sn[i>>8&255]+sn[i>>16&255]+sn[i>>24&255]).toLowerCase()}function Qt(n,t,e){return Math.max(t,Math.min(e,n))}function Gf(n,t){return(n%t+t)%t}function AS(n,t,e,i,s){return i+(n-t)*(s-i)/(e-t)}function RS(n,t,e){return n!==t?(e-n)/(t-n):0}function ko(n,t,e){return(1-e)*n+e*t}function CS(n,t,e,i){return ko(n,t,1-Math.exp(-e*i))}function IS(n,t=1){return t-Math.abs(Gf(n,t*2)-t)}function PS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*(3-2*n))}function LS(n,t,e){return n<=t?0:n>=e?1:(n=(n-t)/(e-t),n*n*n*(n*(n*6-15)+10))}function NS(n,t){return n+Math.floor(Math.random()*(t-n+1))}function DS(n,t){return n+Math.random()*(t-n)}function OS(n){return n*(.5-Math.random())}function US(n){n!==void 0&&(Jg=n);let t=Jg+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function FS(n){return n*Fo}function kS(n){return n*Hr}function BS(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function zS(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Vf(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function GS(n,t,e,i,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+i)/2),h=o((t+i)/2),u=r((t-i)/2),d=o((t-i)/2),f=r((i-t)/2),p=o((i-t)/2);switch(s){case"XYX":n.set(a*h,c*u,c*d,a*l);break;case"YZY":n.set(c*d,a*h,c*u,a*l);break;case"ZXZ":n.set(c*u,c*d,a*h,a*l);break;case"XZX":n.set(a*h,c*p,c*f,a*l);break;case"YXY":n.set(c*f,a*h,c*p,a*l);break;case"ZYZ":n.set(c*p,c*f,a*h,a*l);break;default:Bt("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Hf(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function ux(n,t){if(t.constructor===Float32Array)return n;let e=Hf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/e,-1)}function dx(n,t){if(t.constructor===Float32Array)return n;let e=Hf(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*e)}var Wf={DEG2RAD:Fo,RAD2DEG:Hr,generateUUID:eo,clamp:Qt,euclideanModulo:Gf,mapLinear:AS,inverseLerp:RS,lerp:ko,damp:CS,pingpong:IS,smoothstep:PS,smootherstep:LS,randInt:NS,randFloat:DS,randFloatSpread:OS,seededRandom:US,degToRad:FS,radToDeg:kS,isPowerOfTwo:BS,ceilPowerOfTwo:zS,floorPowerOfTwo:Vf,setQuaternionFromProperEuler:GS,normalize:dx,denormalize:ux},St=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,i=this.y,s=t.elements;return this.x=s[0]*e+s[3]*i+s[6],this.y=s[1]*e+s[4]*i+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Qt(this.x,t.x,e.x),this.y=Qt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Qt(this.x,t,e),this.y=Qt(this.y,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y;return e*e+i*i}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let i=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*i-o*s+t.x,this.y=r*s+o*i+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},mn=class{constructor(t=0,e=0,i=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=i,this._w=s}static slerpFlat(t,e,i,s,r,o,a){let c=i[s+0],l=i[s+1],h=i[s+2],u=i[s+3],d=r[o+0],f=r[o+1],p=r[o+2],m=r[o+3];if(u!==m||c!==d||l!==f||h!==p){let g=c*d+l*f+h*p+u*m;g<0&&(d=-d,f=-f,p=-p,m=-m,g=-g);let x=1-a;if(g<.9995){let _=Math.acos(g),b=Math.sin(_);x=Math.sin(x*_)/b,a=Math.sin(a*_)/b,c=c*x+d*a,l=l*x+f*a,h=h*x+p*a,u=u*x+m*a}else{c=c*x+d*a,l=l*x+f*a,h=h*x+p*a,u=u*x+m*a;let _=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=_,l*=_,h*=_,u*=_}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,i,s,r,o){let a=i[s],c=i[s+1],l=i[s+2],h=i[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+c*f-l*d,t[e+1]=c*p+h*d+l*u-a*f,t[e+2]=l*p+h*f+a*d-c*u,t[e+3]=h*p-a*u-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,i,s){return this._x=t,this._y=e,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let i=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(i/2),h=a(s/2),u=a(r/2),d=c(i/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"YZX":this._x=d*h*u+l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u-d*f*p;break;case"XZY":this._x=d*h*u-l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u+d*f*p;break;default:Bt("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let i=e/2,s=Math.sin(i);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,i=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10],d=i+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(i>a&&i>u){let f=2*Math.sqrt(1+i-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-i-u);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-i-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let i=t.dot(e)+1;return i<1e-8?(i=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=i):(this._x=0,this._y=-t.z,this._z=t.y,this._w=i)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=i),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Qt(this.dot(t),-1,1)))}rotateTowards(t,e){let i=this.angleTo(t);if(i===0)return this;let s=Math.min(1,e/i);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=i*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-i*l,this._z=r*h+o*l+i*c-s*a,this._w=o*h-i*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let i=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+i*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,i){return this.copy(t).slerp(e,i)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},P=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,i=0){this.x=t,this.y=e,this.z=i}set(t,e,i){return i===void 0&&(i=this.z),this.x=t,this.y=e,this.z=i,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Zg.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Zg.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*i+r[6]*s,this.y=r[1]*e+r[4]*i+r[7]*s,this.z=r[2]*e+r[5]*i+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,i=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*i),h=2*(a*e-r*s),u=2*(r*i-o*e);return this.x=e+c*l+o*u-a*h,this.y=i+c*h+a*l-r*u,this.z=s+c*u+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,i=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*i+r[8]*s,this.y=r[1]*e+r[5]*i+r[9]*s,this.z=r[2]*e+r[6]*i+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Qt(this.x,t.x,e.x),this.y=Qt(this.y,t.y,e.y),this.z=Qt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Qt(this.x,t,e),this.y=Qt(this.y,t,e),this.z=Qt(this.z,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let i=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-i*c,this.z=i*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let i=t.dot(this)/e;return this.copy(t).multiplyScalar(i)}projectOnPlane(t){return Od.copy(this).projectOnVector(t),this.sub(Od)}reflect(t){return this.sub(Od.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let i=this.dot(t)/e;return Math.acos(Qt(i,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,i=this.y-t.y,s=this.z-t.z;return e*e+i*i+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,i){let s=Math.sin(e)*t;return this.x=s*Math.sin(i),this.y=Math.cos(e)*t,this.z=s*Math.cos(i),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,i){return this.x=t*Math.sin(e),this.y=i,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),i=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=i,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,i=Math.sqrt(1-e*e);return this.x=i*Math.cos(t),this.y=e,this.z=i*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Od=new P,Zg=new mn,qt=class{static{this.prototype.isMatrix3=!0}constructor(t,e,i,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l)}set(t,e,i,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=i,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],this}extractBasis(t,e,i){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[3],c=i[6],l=i[1],h=i[4],u=i[7],d=i[2],f=i[5],p=i[8],m=s[0],g=s[3],x=s[6],_=s[1],b=s[4],M=s[7],T=s[2],E=s[5],y=s[8];return r[0]=o*m+a*_+c*T,r[3]=o*g+a*b+c*E,r[6]=o*x+a*M+c*y,r[1]=l*m+h*_+u*T,r[4]=l*g+h*b+u*E,r[7]=l*x+h*M+u*y,r[2]=d*m+f*_+p*T,r[5]=d*g+f*b+p*E,r[8]=d*x+f*M+p*y,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-i*r*h+i*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,p=e*u+i*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let m=1/p;return t[0]=u*m,t[1]=(s*l-h*i)*m,t[2]=(a*i-s*o)*m,t[3]=d*m,t[4]=(h*e-s*c)*m,t[5]=(s*r-a*e)*m,t[6]=f*m,t[7]=(i*c-l*e)*m,t[8]=(o*e-i*r)*m,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,i,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(i*c,i*l,-i*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return Uo("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Ud.makeScale(t,e)),this}rotate(t){return Uo("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Ud.makeRotation(-t)),this}translate(t,e){return Uo("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Ud.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,i,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<9;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<9;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t}clone(){return new this.constructor().fromArray(this.elements)}},Ud=new qt,Kg=new qt().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Qg=new qt().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function VS(){let n={enabled:!0,workingColorSpace:Vo,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===ue&&(s.r=Hi(s.r),s.g=Hi(s.g),s.b=Hi(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===ue&&(s.r=Br(s.r),s.g=Br(s.g),s.b=Br(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Ji?Ho:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Vo]:{primaries:t,whitePoint:i,transfer:Ho,toXYZ:Kg,fromXYZ:Qg,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:Nn},outputColorSpaceConfig:{drawingBufferColorSpace:Nn}},[Nn]:{primaries:t,whitePoint:i,transfer:ue,toXYZ:Kg,fromXYZ:Qg,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:Nn}}}),n}var re=VS();function Hi(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Br(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Er,pl=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let i;if(t instanceof HTMLCanvasElement)i=t;else{Er===void 0&&(Er=Wo("canvas")),Er.width=t.width,Er.height=t.height;let s=Er.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),i=Er}return i.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=Wo("canvas");e.width=t.width,e.height=t.height;let i=e.getContext("2d");i.drawImage(t,0,0,t.width,t.height);let s=i.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Hi(r[o]/255)*255;return i.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let i=0;i<e.length;i++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[i]=Math.floor(Hi(e[i]/255)*255):e[i]=Hi(e[i]);return{data:e,width:t.width,height:t.height}}else return Bt("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},HS=0,Wr=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:HS++}),this.uuid=eo(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Fd(s[o].image)):r.push(Fd(s[o]))}else r=Fd(s);i.url=r}return e||(t.images[this.uuid]=i),i}};function Fd(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?pl.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Bt("Texture: Unable to serialize Texture."),{})}var WS=0,kd=new P,bn=class n extends ai{constructor(t=n.DEFAULT_IMAGE,e=n.DEFAULT_MAPPING,i=wi,s=wi,r=pn,o=ji,a=hi,c=Sn,l=n.DEFAULT_ANISOTROPY,h=Ji){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:WS++}),this.uuid=eo(),this.name="",this.source=new Wr(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new St(0,0),this.repeat=new St(1,1),this.center=new St(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new qt,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(kd).x}get height(){return this.source.getSize(kd).y}get depth(){return this.source.getSize(kd).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let i=t[e];if(i===void 0){Bt(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Bt(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),e||(t.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==Rf)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case ul:t.x=t.x-Math.floor(t.x);break;case wi:t.x=t.x<0?0:1;break;case dl:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case ul:t.y=t.y-Math.floor(t.y);break;case wi:t.y=t.y<0?0:1;break;case dl:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};bn.DEFAULT_IMAGE=null;bn.DEFAULT_MAPPING=Rf;bn.DEFAULT_ANISOTROPY=1;var be=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,i=0,s=1){this.x=t,this.y=e,this.z=i,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,i,s){return this.x=t,this.y=e,this.z=i,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,i=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*i+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,i,s,r,c=t.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],p=c[9],m=c[2],g=c[6],x=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-m)<.01&&Math.abs(p-g)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+m)<.1&&Math.abs(p+g)<.1&&Math.abs(l+f+x-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let b=(l+1)/2,M=(f+1)/2,T=(x+1)/2,E=(h+d)/4,y=(u+m)/4,S=(p+g)/4;return b>M&&b>T?b<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(b),s=E/i,r=y/i):M>T?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=E/s,r=S/s):T<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(T),i=y/r,s=S/r),this.set(i,s,r,e),this}let _=Math.sqrt((g-p)*(g-p)+(u-m)*(u-m)+(d-h)*(d-h));return Math.abs(_)<.001&&(_=1),this.x=(g-p)/_,this.y=(u-m)/_,this.z=(d-h)/_,this.w=Math.acos((l+f+x-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Qt(this.x,t.x,e.x),this.y=Qt(this.y,t.y,e.y),this.z=Qt(this.z,t.z,e.z),this.w=Qt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Qt(this.x,t,e),this.y=Qt(this.y,t,e),this.z=Qt(this.z,t,e),this.w=Qt(this.w,t,e),this}clampLength(t,e){let i=this.length();return this.divideScalar(i||1).multiplyScalar(Qt(i,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,i){return this.x=t.x+(e.x-t.x)*i,this.y=t.y+(e.y-t.y)*i,this.z=t.z+(e.z-t.z)*i,this.w=t.w+(e.w-t.w)*i,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},ml=class extends ai{constructor(t=1,e=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:pn,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=i.depth,this.scissor=new be(0,0,t,e),this.scissorTest=!1,this.viewport=new be(0,0,t,e),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new bn({width:t,height:e,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:pn,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,i=1){if(this.width!==t||this.height!==e||this.depth!==i){this.width=t,this.height=e,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,i=t.textures.length;e<i;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new Wr(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Dn=class extends ml{constructor(t=1,e=1,i={}){super(t,e,i),this.isWebGLRenderTarget=!0}},$o=class extends bn{constructor(t=null,e=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=qe,this.minFilter=qe,this.wrapR=wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var gl=class extends bn{constructor(t=null,e=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:i,depth:s},this.magFilter=qe,this.minFilter=qe,this.wrapR=wi,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var ce=class n{static{this.prototype.isMatrix4=!0}constructor(t,e,i,s,r,o,a,c,l,h,u,d,f,p,m,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,i,s,r,o,a,c,l,h,u,d,f,p,m,g)}set(t,e,i,s,r,o,a,c,l,h,u,d,f,p,m,g){let x=this.elements;return x[0]=t,x[4]=e,x[8]=i,x[12]=s,x[1]=r,x[5]=o,x[9]=a,x[13]=c,x[2]=l,x[6]=h,x[10]=u,x[14]=d,x[3]=f,x[7]=p,x[11]=m,x[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(t){let e=this.elements,i=t.elements;return e[0]=i[0],e[1]=i[1],e[2]=i[2],e[3]=i[3],e[4]=i[4],e[5]=i[5],e[6]=i[6],e[7]=i[7],e[8]=i[8],e[9]=i[9],e[10]=i[10],e[11]=i[11],e[12]=i[12],e[13]=i[13],e[14]=i[14],e[15]=i[15],this}copyPosition(t){let e=this.elements,i=t.elements;return e[12]=i[12],e[13]=i[13],e[14]=i[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,i){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),i.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(t,e,i){return this.set(t.x,e.x,i.x,0,t.y,e.y,i.y,0,t.z,e.z,i.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,i=t.elements,s=1/Tr.setFromMatrixColumn(t,0).length(),r=1/Tr.setFromMatrixColumn(t,1).length(),o=1/Tr.setFromMatrixColumn(t,2).length();return e[0]=i[0]*s,e[1]=i[1]*s,e[2]=i[2]*s,e[3]=0,e[4]=i[4]*r,e[5]=i[5]*r,e[6]=i[6]*r,e[7]=0,e[8]=i[8]*o,e[9]=i[9]*o,e[10]=i[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,i=t.x,s=t.y,r=t.z,o=Math.cos(i),a=Math.sin(i),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,m=a*u;e[0]=c*h,e[4]=-c*u,e[8]=l,e[1]=f+p*l,e[5]=d-m*l,e[9]=-a*c,e[2]=m-d*l,e[6]=p+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*h,f=c*u,p=l*h,m=l*u;e[0]=d+m*a,e[4]=p*a-f,e[8]=o*l,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=m+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*h,f=c*u,p=l*h,m=l*u;e[0]=d-m*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=m-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,m=a*u;e[0]=c*h,e[4]=p*l-f,e[8]=d*l+m,e[1]=c*u,e[5]=m*l+d,e[9]=f*l-p,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,p=a*c,m=a*l;e[0]=c*h,e[4]=m-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*u+p,e[10]=d-m*u}else if(t.order==="XZY"){let d=o*c,f=o*l,p=a*c,m=a*l;e[0]=c*h,e[4]=-u,e[8]=l*h,e[1]=d*u+m,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=m*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose($S,t,qS)}lookAt(t,e,i){let s=this.elements;return Pn.subVectors(t,e),Pn.lengthSq()===0&&(Pn.z=1),Pn.normalize(),os.crossVectors(i,Pn),os.lengthSq()===0&&(Math.abs(i.z)===1?Pn.x+=1e-4:Pn.z+=1e-4,Pn.normalize(),os.crossVectors(i,Pn)),os.normalize(),Nc.crossVectors(Pn,os),s[0]=os.x,s[4]=Nc.x,s[8]=Pn.x,s[1]=os.y,s[5]=Nc.y,s[9]=Pn.y,s[2]=os.z,s[6]=Nc.z,s[10]=Pn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let i=t.elements,s=e.elements,r=this.elements,o=i[0],a=i[4],c=i[8],l=i[12],h=i[1],u=i[5],d=i[9],f=i[13],p=i[2],m=i[6],g=i[10],x=i[14],_=i[3],b=i[7],M=i[11],T=i[15],E=s[0],y=s[4],S=s[8],D=s[12],L=s[1],U=s[5],k=s[9],G=s[13],I=s[2],H=s[6],X=s[10],W=s[14],st=s[3],q=s[7],Q=s[11],tt=s[15];return r[0]=o*E+a*L+c*I+l*st,r[4]=o*y+a*U+c*H+l*q,r[8]=o*S+a*k+c*X+l*Q,r[12]=o*D+a*G+c*W+l*tt,r[1]=h*E+u*L+d*I+f*st,r[5]=h*y+u*U+d*H+f*q,r[9]=h*S+u*k+d*X+f*Q,r[13]=h*D+u*G+d*W+f*tt,r[2]=p*E+m*L+g*I+x*st,r[6]=p*y+m*U+g*H+x*q,r[10]=p*S+m*k+g*X+x*Q,r[14]=p*D+m*G+g*W+x*tt,r[3]=_*E+b*L+M*I+T*st,r[7]=_*y+b*U+M*H+T*q,r[11]=_*S+b*k+M*X+T*Q,r[15]=_*D+b*G+M*W+T*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],m=t[7],g=t[11],x=t[15],_=c*f-l*d,b=a*f-l*u,M=a*d-c*u,T=o*f-l*h,E=o*d-c*h,y=o*u-a*h;return e*(m*_-g*b+x*M)-i*(p*_-g*T+x*E)+s*(p*b-m*T+x*y)-r*(p*M-m*E+g*y)}determinantAffine(){let t=this.elements,e=t[0],i=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-i*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,i){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=i),this}invert(){let t=this.elements,e=t[0],i=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],m=t[13],g=t[14],x=t[15],_=e*a-i*o,b=e*c-s*o,M=e*l-r*o,T=i*c-s*a,E=i*l-r*a,y=s*l-r*c,S=h*m-u*p,D=h*g-d*p,L=h*x-f*p,U=u*g-d*m,k=u*x-f*m,G=d*x-f*g,I=_*G-b*k+M*U+T*L-E*D+y*S;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let H=1/I;return t[0]=(a*G-c*k+l*U)*H,t[1]=(s*k-i*G-r*U)*H,t[2]=(m*y-g*E+x*T)*H,t[3]=(d*E-u*y-f*T)*H,t[4]=(c*L-o*G-l*D)*H,t[5]=(e*G-s*L+r*D)*H,t[6]=(g*M-p*y-x*b)*H,t[7]=(h*y-d*M+f*b)*H,t[8]=(o*k-a*L+l*S)*H,t[9]=(i*L-e*k-r*S)*H,t[10]=(p*E-m*M+x*_)*H,t[11]=(u*M-h*E-f*_)*H,t[12]=(a*D-o*U-c*S)*H,t[13]=(e*U-i*D+s*S)*H,t[14]=(m*b-p*T-g*_)*H,t[15]=(h*T-u*b+d*_)*H,this}scale(t){let e=this.elements,i=t.x,s=t.y,r=t.z;return e[0]*=i,e[4]*=s,e[8]*=r,e[1]*=i,e[5]*=s,e[9]*=r,e[2]*=i,e[6]*=s,e[10]*=r,e[3]*=i,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],i=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,i,s))}makeTranslation(t,e,i){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,i,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),i=Math.sin(t);return this.set(1,0,0,0,0,e,-i,0,0,i,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,0,i,0,0,1,0,0,-i,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),i=Math.sin(t);return this.set(e,-i,0,0,i,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let i=Math.cos(e),s=Math.sin(e),r=1-i,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+i,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+i,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+i,0,0,0,0,1),this}makeScale(t,e,i){return this.set(t,0,0,0,0,e,0,0,0,0,i,0,0,0,0,1),this}makeShear(t,e,i,s,r,o){return this.set(1,i,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,i){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,p=r*u,m=o*h,g=o*u,x=a*u,_=c*l,b=c*h,M=c*u,T=i.x,E=i.y,y=i.z;return s[0]=(1-(m+x))*T,s[1]=(f+M)*T,s[2]=(p-b)*T,s[3]=0,s[4]=(f-M)*E,s[5]=(1-(d+x))*E,s[6]=(g+_)*E,s[7]=0,s[8]=(p+b)*y,s[9]=(g-_)*y,s[10]=(1-(d+m))*y,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,i){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),e.identity(),this;let o=Tr.set(s[0],s[1],s[2]).length(),a=Tr.set(s[4],s[5],s[6]).length(),c=Tr.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ii.copy(this);let l=1/o,h=1/a,u=1/c;return ii.elements[0]*=l,ii.elements[1]*=l,ii.elements[2]*=l,ii.elements[4]*=h,ii.elements[5]*=h,ii.elements[6]*=h,ii.elements[8]*=u,ii.elements[9]*=u,ii.elements[10]*=u,e.setFromRotationMatrix(ii),i.x=o,i.y=a,i.z=c,this}makePerspective(t,e,i,s,r,o,a=qn,c=!1){let l=this.elements,h=2*r/(e-t),u=2*r/(i-s),d=(e+t)/(e-t),f=(i+s)/(i-s),p,m;if(c)p=r/(o-r),m=o*r/(o-r);else if(a===qn)p=-(o+r)/(o-r),m=-2*o*r/(o-r);else if(a===Gr)p=-o/(o-r),m=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=m,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,i,s,r,o,a=qn,c=!1){let l=this.elements,h=2/(e-t),u=2/(i-s),d=-(e+t)/(e-t),f=-(i+s)/(i-s),p,m;if(c)p=1/(o-r),m=o/(o-r);else if(a===qn)p=-2/(o-r),m=-(o+r)/(o-r);else if(a===Gr)p=-1/(o-r),m=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=m,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,i=t.elements;for(let s=0;s<16;s++)if(e[s]!==i[s])return!1;return!0}fromArray(t,e=0){for(let i=0;i<16;i++)this.elements[i]=t[i+e];return this}toArray(t=[],e=0){let i=this.elements;return t[e]=i[0],t[e+1]=i[1],t[e+2]=i[2],t[e+3]=i[3],t[e+4]=i[4],t[e+5]=i[5],t[e+6]=i[6],t[e+7]=i[7],t[e+8]=i[8],t[e+9]=i[9],t[e+10]=i[10],t[e+11]=i[11],t[e+12]=i[12],t[e+13]=i[13],t[e+14]=i[14],t[e+15]=i[15],t}},Tr=new P,ii=new ce,$S=new P(0,0,0),qS=new P(1,1,1),os=new P,Nc=new P,Pn=new P,t0=new ce,e0=new mn,$i=class n{constructor(t=0,e=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=i,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,i,s=this._order){return this._x=t,this._y=e,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,i=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Qt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Qt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Qt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Qt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Qt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Qt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:Bt("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,i===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,i){return t0.makeRotationFromQuaternion(t),this.setFromRotationMatrix(t0,e,i)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return e0.setFromEuler(this),this.setFromQuaternion(e0,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};$i.DEFAULT_ORDER="XYZ";var $r=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},XS=0,n0=new P,Ar=new mn,ki=new ce,Dc=new P,Co=new P,jS=new P,YS=new mn,i0=new P(1,0,0),s0=new P(0,1,0),r0=new P(0,0,1),o0={type:"added"},JS={type:"removed"},Rr={type:"childadded",child:null},Bd={type:"childremoved",child:null},Ze=class n extends ai{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:XS++}),this.uuid=eo(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let t=new P,e=new $i,i=new mn,s=new P(1,1,1);function r(){i.setFromEuler(e,!1)}function o(){e.setFromQuaternion(i,void 0,!1)}e._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new ce},normalMatrix:{value:new qt}}),this.matrix=new ce,this.matrixWorld=new ce,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new $r,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Ar.setFromAxisAngle(t,e),this.quaternion.multiply(Ar),this}rotateOnWorldAxis(t,e){return Ar.setFromAxisAngle(t,e),this.quaternion.premultiply(Ar),this}rotateX(t){return this.rotateOnAxis(i0,t)}rotateY(t){return this.rotateOnAxis(s0,t)}rotateZ(t){return this.rotateOnAxis(r0,t)}translateOnAxis(t,e){return n0.copy(t).applyQuaternion(this.quaternion),this.position.add(n0.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(i0,t)}translateY(t){return this.translateOnAxis(s0,t)}translateZ(t){return this.translateOnAxis(r0,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(ki.copy(this.matrixWorld).invert())}lookAt(t,e,i){t.isVector3?Dc.copy(t):Dc.set(t,e,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Co.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ki.lookAt(Co,Dc,this.up):ki.lookAt(Dc,Co,this.up),this.quaternion.setFromRotationMatrix(ki),s&&(ki.extractRotation(s.matrixWorld),Ar.setFromRotationMatrix(ki),this.quaternion.premultiply(Ar.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Wt("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(o0),Rr.child=t,this.dispatchEvent(Rr),Rr.child=null):Wt("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(JS),Bd.child=t,this.dispatchEvent(Bd),Bd.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),ki.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),ki.multiply(t.parent.matrixWorld)),t.applyMatrix4(ki),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(o0),Rr.child=t,this.dispatchEvent(Rr),Rr.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,i=[]){this[t]===e&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,i);return i}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Co,t,jS),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Co,YS,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,i=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*i-r[8]*s,r[13]+=i-r[1]*e-r[5]*i-r[9]*s,r[14]+=s-r[2]*e-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let i=0,s=e.length;i<s;i++)e[i].updateMatrixWorld(t)}updateWorldMatrix(t,e,i=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(t){let e=t===void 0||typeof t=="string",i={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(t.shapes,u)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(i.geometries=a),c.length>0&&(i.materials=c),l.length>0&&(i.textures=l),h.length>0&&(i.images=h),u.length>0&&(i.shapes=u),d.length>0&&(i.skeletons=d),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let i=0;i<t.children.length;i++){let s=t.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Ze.DEFAULT_UP=new P(0,1,0);Ze.DEFAULT_MATRIX_AUTO_UPDATE=!0;Ze.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ae=class extends Ze{constructor(){super(),this.isGroup=!0,this.type="Group"}},ZS={type:"move"},qr=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ae,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ae,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new P,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new P),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ae,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new P,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new P,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let i of t.hand.values())this._getHandJoint(e,i)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,i){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let m of t.hand.values()){let g=e.getJointPose(m,i),x=this._getHandJoint(l,m);g!==null&&(x.matrix.fromArray(g.transform.matrix),x.matrix.decompose(x.position,x.quaternion,x.scale),x.matrixWorldNeedsUpdate=!0,x.jointRadius=g.radius),x.visible=g!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;l.inputState.pinching&&d>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,i),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(ZS)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let i=new Ae;i.matrixAutoUpdate=!1,i.visible=!1,t.joints[e.jointName]=i,t.add(i)}return t.joints[e.jointName]}},fx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},as={h:0,s:0,l:0},Oc={h:0,s:0,l:0};function zd(n,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?n+(t-n)*6*e:e<1/2?t:e<2/3?n+(t-n)*6*(2/3-e):n}var $t=class{constructor(t,e,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,i)}set(t,e,i){if(e===void 0&&i===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,i);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=Nn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,re.colorSpaceToWorking(this,e),this}setRGB(t,e,i,s=re.workingColorSpace){return this.r=t,this.g=e,this.b=i,re.colorSpaceToWorking(this,s),this}setHSL(t,e,i,s=re.workingColorSpace){if(t=Gf(t,1),e=Qt(e,0,1),i=Qt(i,0,1),e===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+e):i+e-i*e,o=2*i-r;this.r=zd(o,r,t+1/3),this.g=zd(o,r,t),this.b=zd(o,r,t-1/3)}return re.colorSpaceToWorking(this,s),this}setStyle(t,e=Nn){function i(r){r!==void 0&&parseFloat(r)<1&&Bt("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:Bt("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);Bt("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=Nn){let i=fx[t.toLowerCase()];return i!==void 0?this.setHex(i,e):Bt("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Hi(t.r),this.g=Hi(t.g),this.b=Hi(t.b),this}copyLinearToSRGB(t){return this.r=Br(t.r),this.g=Br(t.g),this.b=Br(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=Nn){return re.workingToColorSpace(rn.copy(this),t),Math.round(Qt(rn.r*255,0,255))*65536+Math.round(Qt(rn.g*255,0,255))*256+Math.round(Qt(rn.b*255,0,255))}getHexString(t=Nn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=re.workingColorSpace){re.workingToColorSpace(rn.copy(this),e);let i=rn.r,s=rn.g,r=rn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case i:c=(s-r)/u+(s<r?6:0);break;case s:c=(r-i)/u+2;break;case r:c=(i-s)/u+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=re.workingColorSpace){return re.workingToColorSpace(rn.copy(this),e),t.r=rn.r,t.g=rn.g,t.b=rn.b,t}getStyle(t=Nn){re.workingToColorSpace(rn.copy(this),t);let e=rn.r,i=rn.g,s=rn.b;return t!==Nn?`color(${t} ${e.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(t,e,i){return this.getHSL(as),this.setHSL(as.h+t,as.s+e,as.l+i)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,i){return this.r=t.r+(e.r-t.r)*i,this.g=t.g+(e.g-t.g)*i,this.b=t.b+(e.b-t.b)*i,this}lerpHSL(t,e){this.getHSL(as),t.getHSL(Oc);let i=ko(as.h,Oc.h,e),s=ko(as.s,Oc.s,e),r=ko(as.l,Oc.l,e);return this.setHSL(i,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,i=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*i+r[6]*s,this.g=r[1]*e+r[4]*i+r[7]*s,this.b=r[2]*e+r[5]*i+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},rn=new $t;$t.NAMES=fx;var qo=class extends Ze{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new $i,this.environmentIntensity=1,this.environmentRotation=new $i,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},si=new P,Bi=new P,Gd=new P,zi=new P,Cr=new P,Ir=new P,a0=new P,Vd=new P,Hd=new P,Wd=new P,$d=new be,qd=new be,Xd=new be,us=class n{constructor(t=new P,e=new P,i=new P){this.a=t,this.b=e,this.c=i}static getNormal(t,e,i,s){s.subVectors(i,e),si.subVectors(t,e),s.cross(si);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,i,s,r){si.subVectors(s,e),Bi.subVectors(i,e),Gd.subVectors(t,e);let o=si.dot(si),a=si.dot(Bi),c=si.dot(Gd),l=Bi.dot(Bi),h=Bi.dot(Gd),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,p=(o*h-a*c)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,i,s){return this.getBarycoord(t,e,i,s,zi)===null?!1:zi.x>=0&&zi.y>=0&&zi.x+zi.y<=1}static getInterpolation(t,e,i,s,r,o,a,c){return this.getBarycoord(t,e,i,s,zi)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,zi.x),c.addScaledVector(o,zi.y),c.addScaledVector(a,zi.z),c)}static getInterpolatedAttribute(t,e,i,s,r,o){return $d.setScalar(0),qd.setScalar(0),Xd.setScalar(0),$d.fromBufferAttribute(t,e),qd.fromBufferAttribute(t,i),Xd.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector($d,r.x),o.addScaledVector(qd,r.y),o.addScaledVector(Xd,r.z),o}static isFrontFacing(t,e,i,s){return si.subVectors(i,e),Bi.subVectors(t,e),si.cross(Bi).dot(s)<0}set(t,e,i){return this.a.copy(t),this.b.copy(e),this.c.copy(i),this}setFromPointsAndIndices(t,e,i,s){return this.a.copy(t[e]),this.b.copy(t[i]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,i,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,i),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return si.subVectors(this.c,this.b),Bi.subVectors(this.a,this.b),si.cross(Bi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return n.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return n.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,i,s,r){return n.getInterpolation(t,this.a,this.b,this.c,e,i,s,r)}containsPoint(t){return n.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return n.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let i=this.a,s=this.b,r=this.c,o,a;Cr.subVectors(s,i),Ir.subVectors(r,i),Vd.subVectors(t,i);let c=Cr.dot(Vd),l=Ir.dot(Vd);if(c<=0&&l<=0)return e.copy(i);Hd.subVectors(t,s);let h=Cr.dot(Hd),u=Ir.dot(Hd);if(h>=0&&u<=h)return e.copy(s);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(i).addScaledVector(Cr,o);Wd.subVectors(t,r);let f=Cr.dot(Wd),p=Ir.dot(Wd);if(p>=0&&f<=p)return e.copy(r);let m=f*l-c*p;if(m<=0&&l>=0&&p<=0)return a=l/(l-p),e.copy(i).addScaledVector(Ir,a);let g=h*p-f*u;if(g<=0&&u-h>=0&&f-p>=0)return a0.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(a0,a);let x=1/(g+m+d);return o=m*x,a=d*x,e.copy(i).addScaledVector(Cr,o).addScaledVector(Ir,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},On=class{constructor(t=new P(1/0,1/0,1/0),e=new P(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e+=3)this.expandByPoint(ri.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,i=t.count;e<i;e++)this.expandByPoint(ri.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,i=t.length;e<i;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let i=ri.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(i),this.max.copy(t).add(i),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let i=t.geometry;if(i!==void 0){let r=i.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,ri):ri.fromBufferAttribute(r,o),ri.applyMatrix4(t.matrixWorld),this.expandByPoint(ri);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),Uc.copy(t.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Uc.copy(i.boundingBox)),Uc.applyMatrix4(t.matrixWorld),this.union(Uc)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,ri),ri.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,i;return t.normal.x>0?(e=t.normal.x*this.min.x,i=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,i=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,i+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,i+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,i+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,i+=t.normal.z*this.min.z),e<=-t.constant&&i>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter(Io),Fc.subVectors(this.max,Io),Pr.subVectors(t.a,Io),Lr.subVectors(t.b,Io),Nr.subVectors(t.c,Io),cs.subVectors(Lr,Pr),ls.subVectors(Nr,Lr),Ys.subVectors(Pr,Nr);let e=[0,-cs.z,cs.y,0,-ls.z,ls.y,0,-Ys.z,Ys.y,cs.z,0,-cs.x,ls.z,0,-ls.x,Ys.z,0,-Ys.x,-cs.y,cs.x,0,-ls.y,ls.x,0,-Ys.y,Ys.x,0];return!jd(e,Pr,Lr,Nr,Fc)||(e=[1,0,0,0,1,0,0,0,1],!jd(e,Pr,Lr,Nr,Fc))?!1:(kc.crossVectors(cs,ls),e=[kc.x,kc.y,kc.z],jd(e,Pr,Lr,Nr,Fc))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,ri).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(ri).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Gi[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Gi[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Gi[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Gi[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Gi[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Gi[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Gi[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Gi[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Gi),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Gi=[new P,new P,new P,new P,new P,new P,new P,new P],ri=new P,Uc=new On,Pr=new P,Lr=new P,Nr=new P,cs=new P,ls=new P,Ys=new P,Io=new P,Fc=new P,kc=new P,Js=new P;function jd(n,t,e,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Js.fromArray(n,r);let a=s.x*Math.abs(Js.x)+s.y*Math.abs(Js.y)+s.z*Math.abs(Js.z),c=t.dot(Js),l=e.dot(Js),h=i.dot(Js);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Oe=new P,Bc=new St,KS=0,oi=class extends ai{constructor(t,e,i=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:KS++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=i,this.usage=ox,this.updateRanges=[],this.gpuType=Yn,this.version=0,this._normalizationScale=t!==void 0?Hf(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,i){t*=this.itemSize,i*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[i+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,i=this.count;e<i;e++)Bc.fromBufferAttribute(this,e),Bc.applyMatrix3(t),this.setXY(e,Bc.x,Bc.y);else if(this.itemSize===3)for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.applyMatrix3(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}applyMatrix4(t){for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.applyMatrix4(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}applyNormalMatrix(t){for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.applyNormalMatrix(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}transformDirection(t){for(let e=0,i=this.count;e<i;e++)Oe.fromBufferAttribute(this,e),Oe.transformDirection(t),this.setXYZ(e,Oe.x,Oe.y,Oe.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let i=this.array[t*this.itemSize+e];return this.normalized&&(i=this._denormalize(i)),i}setComponent(t,e,i){return this.normalized&&(i=this._normalize(i)),this.array[t*this.itemSize+e]=i,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,i){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i)),this.array[t+0]=e,this.array[t+1]=i,this}setXYZ(t,e,i,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this}setXYZW(t,e,i,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=i,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):ux(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):dx(t,this.array)}};var Xo=class extends oi{constructor(t,e,i){super(new Uint16Array(t),e,i)}};var jo=class extends oi{constructor(t,e,i){super(new Uint32Array(t),e,i)}};var Re=class extends oi{constructor(t,e,i){super(new Float32Array(t),e,i)}},QS=new On,Po=new P,Yd=new P,qi=class{constructor(t=new P,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let i=this.center;e!==void 0?i.copy(e):QS.setFromPoints(t).getCenter(i);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,i.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let i=this.center.distanceToSquared(t);return e.copy(t),i>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Po.subVectors(t,this.center);let e=Po.lengthSq();if(e>this.radius*this.radius){let i=Math.sqrt(e),s=(i-this.radius)*.5;this.center.addScaledVector(Po,s/i),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(Yd.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Po.copy(t.center).add(Yd)),this.expandByPoint(Po.copy(t.center).sub(Yd))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},t1=0,$n=new ce,Jd=new Ze,Dr=new P,Ln=new On,Lo=new On,$e=new P,wn=class n extends ai{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:t1++}),this.uuid=eo(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(ES(t)?jo:Xo)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,i=0){this.groups.push({start:t,count:e,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new qt().getNormalMatrix(t);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return $n.makeRotationFromQuaternion(t),this.applyMatrix4($n),this}rotateX(t){return $n.makeRotationX(t),this.applyMatrix4($n),this}rotateY(t){return $n.makeRotationY(t),this.applyMatrix4($n),this}rotateZ(t){return $n.makeRotationZ(t),this.applyMatrix4($n),this}translate(t,e,i){return $n.makeTranslation(t,e,i),this.applyMatrix4($n),this}scale(t,e,i){return $n.makeScale(t,e,i),this.applyMatrix4($n),this}lookAt(t){return Jd.lookAt(t),Jd.updateMatrix(),this.applyMatrix4(Jd.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Dr).negate(),this.translate(Dr.x,Dr.y,Dr.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let i=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Re(i,3))}else{let i=Math.min(t.length,e.count);for(let s=0;s<i;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&Bt("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new On);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Wt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new P(-1/0,-1/0,-1/0),new P(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let i=0,s=e.length;i<s;i++){let r=e[i];Ln.setFromBufferAttribute(r),this.morphTargetsRelative?($e.addVectors(this.boundingBox.min,Ln.min),this.boundingBox.expandByPoint($e),$e.addVectors(this.boundingBox.max,Ln.max),this.boundingBox.expandByPoint($e)):(this.boundingBox.expandByPoint(Ln.min),this.boundingBox.expandByPoint(Ln.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Wt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new qi);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Wt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new P,1/0);return}if(t){let i=this.boundingSphere.center;if(Ln.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Lo.setFromBufferAttribute(a),this.morphTargetsRelative?($e.addVectors(Ln.min,Lo.min),Ln.expandByPoint($e),$e.addVectors(Ln.max,Lo.max),Ln.expandByPoint($e)):(Ln.expandByPoint(Lo.min),Ln.expandByPoint(Lo.max))}Ln.getCenter(i);let s=0;for(let r=0,o=t.count;r<o;r++)$e.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared($e));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)$e.fromBufferAttribute(a,l),c&&(Dr.fromBufferAttribute(t,l),$e.add(Dr)),s=Math.max(s,i.distanceToSquared($e))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Wt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Wt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new oi(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(i.count);for(let D=0;D<i.count;D++)a[D]=new P,c[D]=new P;let h=new P,u=new P,d=new P,f=new St,p=new St,m=new St,g=new P,x=new P;function _(D,L,U){l[D]=l[L]=l[U]=1,h.fromBufferAttribute(i,D),u.fromBufferAttribute(i,L),d.fromBufferAttribute(i,U),f.fromBufferAttribute(r,D),p.fromBufferAttribute(r,L),m.fromBufferAttribute(r,U),u.sub(h),d.sub(h),p.sub(f),m.sub(f);let k=1/(p.x*m.y-m.x*p.y);isFinite(k)&&(g.copy(u).multiplyScalar(m.y).addScaledVector(d,-p.y).multiplyScalar(k),x.copy(d).multiplyScalar(p.x).addScaledVector(u,-m.x).multiplyScalar(k),a[D].add(g),a[L].add(g),a[U].add(g),c[D].add(x),c[L].add(x),c[U].add(x))}let b=this.groups;b.length===0&&(b=[{start:0,count:t.count}]);for(let D=0,L=b.length;D<L;++D){let U=b[D],k=U.start,G=U.count;for(let I=k,H=k+G;I<H;I+=3)_(t.getX(I+0),t.getX(I+1),t.getX(I+2))}let M=new P,T=new P,E=new P,y=new P;function S(D){E.fromBufferAttribute(s,D),y.copy(E);let L=a[D];M.copy(L),M.sub(E.multiplyScalar(E.dot(L))).normalize(),T.crossVectors(y,L);let k=T.dot(c[D])<0?-1:1;o.setXYZW(D,M.x,M.y,M.z,k)}for(let D=0,L=i.count;D<L;++D)l[D]&&S(D);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==e.count)i=new oi(new Float32Array(e.count*3),3),this.setAttribute("normal",i);else for(let d=0,f=i.count;d<f;d++)i.setXYZ(d,0,0,0);let s=new P,r=new P,o=new P,a=new P,c=new P,l=new P,h=new P,u=new P;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),m=t.getX(d+1),g=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,m),o.fromBufferAttribute(e,g),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(i,p),c.fromBufferAttribute(i,m),l.fromBufferAttribute(i,g),a.add(h),c.add(h),l.add(h),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(m,c.x,c.y,c.z),i.setXYZ(g,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),i.setXYZ(d+0,h.x,h.y,h.z),i.setXYZ(d+1,h.x,h.y,h.z),i.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,i=t.count;e<i;e++)$e.fromBufferAttribute(t,e),$e.normalize(),t.setXYZ(e,$e.x,$e.y,$e.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,p=0;for(let m=0,g=c.length;m<g;m++){a.isInterleavedBufferAttribute?f=c[m]*a.data.stride+a.offset:f=c[m]*h;for(let x=0;x<h;x++)d[p++]=l[f++]}return new oi(d,h,u)}if(this.index===null)return Bt("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new n,i=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,i);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=t(d,i);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let i=this.attributes;for(let c in i){let l=i[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let i=t.index;i!==null&&this.setIndex(i.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}};var Zd=new P,e1=new P,n1=new qt,dn=class{constructor(t=new P(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,i,s){return this.normal.set(t,e,i),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,i){let s=Zd.subVectors(i,e).cross(e1.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,i=!0){let s=t.delta(Zd),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),i=this.distanceToPoint(t.end);return e<0&&i>0||i<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let i=e||n1.getNormalMatrix(t),s=this.coplanarPoint(Zd).applyMatrix4(t),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},i1=0,Mi=class extends ai{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:i1++}),this.uuid=eo(),this.name="",this.type="Material",this.blending=Kr,this.side=vs,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=_f,this.blendDst=yf,this.blendEquation=ir,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new $t(0,0,0),this.blendAlpha=0,this.depthFunc=zr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=tx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=il,this.stencilZFail=il,this.stencilZPass=il,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let i=t[e];if(i===void 0){Bt(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){Bt(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[e]=i}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(t).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(t).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(t).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(t).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(t).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new $t().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(i=>new dn().fromJSON(i))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let i=t.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new St().fromArray(i)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new St().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,i=null;if(e!==null){let s=e.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=e[r].clone()}return this.clippingPlanes=i,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Vi=new P,Kd=new P,zc=new P,Gc=new P,ds=class{constructor(t=new P,e=new P(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Vi)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let i=e.dot(this.direction);return i<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Vi.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Vi.copy(this.origin).addScaledVector(this.direction,e),Vi.distanceToSquared(t))}distanceSqToSegment(t,e,i,s){Kd.copy(t).add(e).multiplyScalar(.5),zc.copy(e).sub(t).normalize(),Gc.copy(this.origin).sub(Kd);let r=t.distanceTo(e)*.5,o=-this.direction.dot(zc),a=Gc.dot(this.direction),c=-Gc.dot(zc),l=Gc.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*c-a,d=o*a-c,p=r*h,u>=0)if(d>=-p)if(d<=p){let m=1/h;u*=m,d*=m,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=p?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return i&&i.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Kd).addScaledVector(zc,d),f}intersectSphere(t,e){if(t.radius<0)return null;Vi.subVectors(t.center,this.origin);let i=Vi.dot(this.direction),s=Vi.dot(Vi)-i*i,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,c=i+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(t.normal)+t.constant)/e;return i>=0?i:null}intersectPlane(t,e){let i=this.distanceToPlane(t);return i===null?null:this.at(i,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let i,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(i=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(i=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,c=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,c=(t.min.z-d.z)*u),i>c||a>s)||((a>i||i!==i)&&(i=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(i>=0?i:s,e)}intersectsBox(t){return this.intersectBox(t,Vi)!==null}intersectTriangle(t,e,i,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,m=e.y-o.y,g=e.z-o.z,x=i.x-o.x,_=i.y-o.y,b=i.z-o.z,M=Math.abs(c),T=Math.abs(l),E=Math.abs(h),y,S,D,L,U,k,G,I,H,X,W,st;if(M>=T&&M>=E?(D=c,k=u,H=p,st=x,c>=0?(y=l,S=h,L=d,U=f,G=m,I=g,X=_,W=b):(y=h,S=l,L=f,U=d,G=g,I=m,X=b,W=_)):T>=E?(D=l,k=d,H=m,st=_,l>=0?(y=h,S=c,L=f,U=u,G=g,I=p,X=b,W=x):(y=c,S=h,L=u,U=f,G=p,I=g,X=x,W=b)):(D=h,k=f,H=g,st=b,h>=0?(y=c,S=l,L=u,U=d,G=p,I=m,X=x,W=_):(y=l,S=c,L=d,U=u,G=m,I=p,X=_,W=x)),D===0)return null;let q=y/D,Q=S/D,tt=1/D,Pt=L-q*k,jt=U-Q*k,J=G-q*H,vt=I-Q*H,Tt=X-q*st,zt=W-Q*st,bt=Tt*vt-zt*J,Jt=Pt*zt-jt*Tt,Ne=J*jt-vt*Pt;if(s){if(bt<0||Jt<0||Ne<0)return null}else if((bt<0||Jt<0||Ne<0)&&(bt>0||Jt>0||Ne>0))return null;let Vt=bt+Jt+Ne;if(Vt===0)return null;let fe=tt*(bt*k+Jt*H+Ne*st);return(Vt>0?fe<0:fe>0)?null:this.at(fe/Vt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ke=class extends Mi{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new $t(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new $i,this.combine=vf,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},c0=new ce,Zs=new ds,Vc=new qi,l0=new P,Hc=new P,Wc=new P,$c=new P,Qd=new P,qc=new P,h0=new P,Xc=new P,Ue=class extends Ze{constructor(t=new wn,e=new Ke){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){qc.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(Qd.fromBufferAttribute(u,t),o?qc.addScaledVector(Qd,h):qc.addScaledVector(Qd.sub(e),h))}e.add(qc)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Vc.copy(i.boundingSphere),Vc.applyMatrix4(r),Zs.copy(t.ray).recast(t.near),!(Vc.containsPoint(Zs.origin)===!1&&(Zs.intersectSphere(Vc,l0)===null||Zs.origin.distanceToSquared(l0)>(t.far-t.near)**2))&&(c0.copy(r).invert(),Zs.copy(t.ray).applyMatrix4(c0),!(i.boundingBox!==null&&Zs.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(t,e,Zs)))}_computeIntersections(t,e,i){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,m=d.length;p<m;p++){let g=d[p],x=o[g.materialIndex],_=Math.max(g.start,f.start),b=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let M=_,T=b;M<T;M+=3){let E=a.getX(M),y=a.getX(M+1),S=a.getX(M+2);s=jc(this,x,t,i,l,h,u,E,y,S),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),m=Math.min(a.count,f.start+f.count);for(let g=p,x=m;g<x;g+=3){let _=a.getX(g),b=a.getX(g+1),M=a.getX(g+2);s=jc(this,o,t,i,l,h,u,_,b,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,m=d.length;p<m;p++){let g=d[p],x=o[g.materialIndex],_=Math.max(g.start,f.start),b=Math.min(c.count,Math.min(g.start+g.count,f.start+f.count));for(let M=_,T=b;M<T;M+=3){let E=M,y=M+1,S=M+2;s=jc(this,x,t,i,l,h,u,E,y,S),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),m=Math.min(c.count,f.start+f.count);for(let g=p,x=m;g<x;g+=3){let _=g,b=g+1,M=g+2;s=jc(this,o,t,i,l,h,u,_,b,M),s&&(s.faceIndex=Math.floor(g/3),e.push(s))}}}};function s1(n,t,e,i,s,r,o,a){let c;if(t.side===gn?c=i.intersectTriangle(o,r,s,!0,a):c=i.intersectTriangle(s,r,o,t.side===vs,a),c===null)return null;Xc.copy(a),Xc.applyMatrix4(n.matrixWorld);let l=e.ray.origin.distanceTo(Xc);return l<e.near||l>e.far?null:{distance:l,point:Xc.clone(),object:n}}function jc(n,t,e,i,s,r,o,a,c,l){n.getVertexPosition(a,Hc),n.getVertexPosition(c,Wc),n.getVertexPosition(l,$c);let h=s1(n,t,e,i,Hc,Wc,$c,h0);if(h){let u=new P;us.getBarycoord(h0,Hc,Wc,$c,u),s&&(h.uv=us.getInterpolatedAttribute(s,a,c,l,u,new St)),r&&(h.uv1=us.getInterpolatedAttribute(r,a,c,l,u,new St)),o&&(h.normal=us.getInterpolatedAttribute(o,a,c,l,u,new P),h.normal.dot(i.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new P,materialIndex:0};us.getNormal(Hc,Wc,$c,d.normal),h.face=d,h.barycoord=u}return h}var Yo=class extends bn{constructor(t=null,e=1,i=1,s,r,o,a,c,l=qe,h=qe,u,d){super(null,o,a,c,l,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Jo=class extends oi{constructor(t,e,i,s=1){super(t,e,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},Or=new ce,u0=new ce,Yc=[],d0=new On,r1=new ce,No=new Ue,Do=new qi,Zo=class extends Ue{constructor(t,e,i){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new Jo(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,r1)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new On),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Or),d0.copy(t.boundingBox).applyMatrix4(Or),this.boundingBox.union(d0)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new qi),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<e;i++)this.getMatrixAt(i,Or),Do.copy(t.boundingSphere).applyMatrix4(Or),this.boundingSphere.union(Do)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let i=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=t*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(t,e){let i=this.matrixWorld,s=this.count;if(No.geometry=this.geometry,No.material=this.material,No.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Do.copy(this.boundingSphere),Do.applyMatrix4(i),t.ray.intersectsSphere(Do)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,Or),u0.multiplyMatrices(i,Or),No.matrixWorld=u0,No.raycast(t,Yc);for(let o=0,a=Yc.length;o<a;o++){let c=Yc[o];c.instanceId=r,c.object=this,e.push(c)}Yc.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new Jo(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let i=e.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Yo(new Float32Array(s*this.count),s,this.count,Yl,Yn));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<i.length;l++)o+=i[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(i,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ks=new qi,o1=new St(.5,.5),Jc=new P,fs=class{constructor(t=new dn,e=new dn,i=new dn,s=new dn,r=new dn,o=new dn){this.planes=[t,e,i,s,r,o]}set(t,e,i,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let i=0;i<6;i++)e[i].copy(t.planes[i]);return this}setFromProjectionMatrix(t,e=qn,i=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],m=r[9],g=r[10],x=r[11],_=r[12],b=r[13],M=r[14],T=r[15];if(s[0].setComponents(l-o,f-h,x-p,T-_).normalize(),s[1].setComponents(l+o,f+h,x+p,T+_).normalize(),s[2].setComponents(l+a,f+u,x+m,T+b).normalize(),s[3].setComponents(l-a,f-u,x-m,T-b).normalize(),i)s[4].setComponents(c,d,g,M).normalize(),s[5].setComponents(l-c,f-d,x-g,T-M).normalize();else if(s[4].setComponents(l-c,f-d,x-g,T-M).normalize(),e===qn)s[5].setComponents(l+c,f+d,x+g,T+M).normalize();else if(e===Gr)s[5].setComponents(c,d,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ks.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ks.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ks)}intersectsSprite(t){Ks.center.set(0,0,0);let e=o1.distanceTo(t.center);return Ks.radius=.7071067811865476+e,Ks.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ks)}intersectsSphere(t){let e=this.planes,i=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let i=0;i<6;i++){let s=e[i];if(Jc.x=s.normal.x>0?t.max.x:t.min.x,Jc.y=s.normal.y>0?t.max.y:t.min.y,Jc.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Jc)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let i=0;i<6;i++)if(e[i].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},f0=new ce,xl=class n{constructor(){this.coordinateSystem=qn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,i=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];f0.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new fs),i[s].setFromProjectionMatrix(f0,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let i=0;i<this._count;i++)if(e[i].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,i=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new fs),e[s].copy(i[s]);return this._count=t._count,this}clone(){return new n().copy(this)}};var Xr=class extends Mi{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new $t(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},_l=new P,yl=new P,p0=new ce,Oo=new ds,Zc=new qi,tf=new P,m0=new P,vl=class extends Ze{constructor(t=new wn,e=new Xr){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,i=[0];for(let s=1,r=e.count;s<r;s++)_l.fromBufferAttribute(e,s-1),yl.fromBufferAttribute(e,s),i[s]=i[s-1],i[s]+=_l.distanceTo(yl);t.setAttribute("lineDistance",new Re(i,1))}else Bt("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let i=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Zc.copy(i.boundingSphere),Zc.applyMatrix4(s),Zc.radius+=r,t.ray.intersectsSphere(Zc)===!1)return;p0.copy(s).invert(),Oo.copy(t.ray).applyMatrix4(p0);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=i.index,d=i.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let m=f,g=p-1;m<g;m+=l){let x=h.getX(m),_=h.getX(m+1),b=Kc(this,t,Oo,c,x,_,m);b&&e.push(b)}if(this.isLineLoop){let m=h.getX(p-1),g=h.getX(f),x=Kc(this,t,Oo,c,m,g,p-1);x&&e.push(x)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let m=f,g=p-1;m<g;m+=l){let x=Kc(this,t,Oo,c,m,m+1,m);x&&e.push(x)}if(this.isLineLoop){let m=Kc(this,t,Oo,c,p-1,f,p-1);m&&e.push(m)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,i=Object.keys(e);if(i.length>0){let s=e[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Kc(n,t,e,i,s,r,o){let a=n.geometry.attributes.position;if(_l.fromBufferAttribute(a,s),yl.fromBufferAttribute(a,r),e.distanceSqToSegment(_l,yl,tf,m0)>i)return;tf.applyMatrix4(n.matrixWorld);let l=t.ray.origin.distanceTo(tf);if(!(l<t.near||l>t.far))return{distance:l,point:m0.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var Ko=class extends vl{constructor(t,e){super(t,e),this.isLineLoop=!0,this.type="LineLoop"}};var Qo=class extends bn{constructor(t=[],e=sr,i,s,r,o,a,c,l,h){super(t,e,i,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Xi=class extends bn{constructor(t,e,i=ci,s,r,o,a=qe,c=qe,l,h=Wi,u=1){if(h!==Wi&&h!==Yi)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,c,h,i,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new Wr(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},ta=class extends Xi{constructor(t,e=ci,i=sr,s,r,o=qe,a=qe,c,l=Wi){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,i,s,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},ea=class extends bn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},ps=class n extends wn{constructor(t=1,e=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,i,e,t,o,r,0),p("z","y","x",1,-1,i,e,-t,o,r,1),p("x","z","y",1,1,t,i,e,s,o,2),p("x","z","y",1,-1,t,i,-e,s,o,3),p("x","y","z",1,-1,t,e,i,s,r,4),p("x","y","z",-1,-1,t,e,-i,s,r,5),this.setIndex(c),this.setAttribute("position",new Re(l,3)),this.setAttribute("normal",new Re(h,3)),this.setAttribute("uv",new Re(u,2));function p(m,g,x,_,b,M,T,E,y,S,D){let L=M/y,U=T/S,k=M/2,G=T/2,I=E/2,H=y+1,X=S+1,W=0,st=0,q=new P;for(let Q=0;Q<X;Q++){let tt=Q*U-G;for(let Pt=0;Pt<H;Pt++){let jt=Pt*L-k;q[m]=jt*_,q[g]=tt*b,q[x]=I,l.push(q.x,q.y,q.z),q[m]=0,q[g]=0,q[x]=E>0?1:-1,h.push(q.x,q.y,q.z),u.push(Pt/y),u.push(1-Q/S),W+=1}}for(let Q=0;Q<S;Q++)for(let tt=0;tt<y;tt++){let Pt=d+tt+H*Q,jt=d+tt+H*(Q+1),J=d+(tt+1)+H*(Q+1),vt=d+(tt+1)+H*Q;c.push(Pt,jt,vt),c.push(jt,J,vt),st+=6}a.addGroup(f,st,D),f+=st,d+=W}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Qs=class n extends wn{constructor(t=1,e=1,i=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:i,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,m=[],g=i/2,x=0;_(),o===!1&&(t>0&&b(!0),e>0&&b(!1)),this.setIndex(h),this.setAttribute("position",new Re(u,3)),this.setAttribute("normal",new Re(d,3)),this.setAttribute("uv",new Re(f,2));function _(){let M=new P,T=new P,E=0,y=(e-t)/i;for(let S=0;S<=r;S++){let D=[],L=S/r,U=L*(e-t)+t;for(let k=0;k<=s;k++){let G=k/s,I=G*c+a,H=Math.sin(I),X=Math.cos(I);T.x=U*H,T.y=-L*i+g,T.z=U*X,u.push(T.x,T.y,T.z),M.set(H,y,X).normalize(),d.push(M.x,M.y,M.z),f.push(G,1-L),D.push(p++)}m.push(D)}for(let S=0;S<s;S++)for(let D=0;D<r;D++){let L=m[D][S],U=m[D+1][S],k=m[D+1][S+1],G=m[D][S+1];(t>0||D!==0)&&(h.push(L,U,G),E+=3),(e>0||D!==r-1)&&(h.push(U,k,G),E+=3)}l.addGroup(x,E,0),x+=E}function b(M){let T=p,E=new St,y=new P,S=0,D=M===!0?t:e,L=M===!0?1:-1;for(let k=1;k<=s;k++)u.push(0,g*L,0),d.push(0,L,0),f.push(.5,.5),p++;let U=p;for(let k=0;k<=s;k++){let I=k/s*c+a,H=Math.cos(I),X=Math.sin(I);y.x=D*X,y.y=g*L,y.z=D*H,u.push(y.x,y.y,y.z),d.push(0,L,0),E.x=H*.5+.5,E.y=X*.5*L+.5,f.push(E.x,E.y),p++}for(let k=0;k<s;k++){let G=T+k,I=U+k;M===!0?h.push(I,I+1,G):h.push(I+1,I,G),S+=3}l.addGroup(x,S,M===!0?1:2),x+=S}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},na=class n extends Qs{constructor(t=1,e=1,i=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,i,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:i,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new n(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}};var Xn=class{constructor(){this.type="Curve",this.arcLengthDivisions=200,this.needsUpdate=!1,this.cacheArcLengths=null}getPoint(){Bt("Curve: .getPoint() not implemented.")}getPointAt(t,e){let i=this.getUtoTmapping(t);return this.getPoint(i,e)}getPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPoint(i/t));return e}getSpacedPoints(t=5){let e=[];for(let i=0;i<=t;i++)e.push(this.getPointAt(i/t));return e}getLength(){let t=this.getLengths();return t[t.length-1]}getLengths(t=this.arcLengthDivisions){if(this.cacheArcLengths&&this.cacheArcLengths.length===t+1&&!this.needsUpdate)return this.cacheArcLengths;this.needsUpdate=!1;let e=[],i,s=this.getPoint(0),r=0;e.push(0);for(let o=1;o<=t;o++)i=this.getPoint(o/t),r+=i.distanceTo(s),e.push(r),s=i;return this.cacheArcLengths=e,e}updateArcLengths(){this.needsUpdate=!0,this.getLengths()}getUtoTmapping(t,e=null){let i=this.getLengths(),s=0,r=i.length,o;e?o=e:o=t*i[r-1];let a=0,c=r-1,l;for(;a<=c;)if(s=Math.floor(a+(c-a)/2),l=i[s]-o,l<0)a=s+1;else if(l>0)c=s-1;else{c=s;break}if(s=c,i[s]===o)return s/(r-1);let h=i[s],d=i[s+1]-h,f=(o-h)/d;return(s+f)/(r-1)}getTangent(t,e){let s=t-1e-4,r=t+1e-4;s<0&&(s=0),r>1&&(r=1);let o=this.getPoint(s),a=this.getPoint(r),c=e||(o.isVector2?new St:new P);return c.copy(a).sub(o).normalize(),c}getTangentAt(t,e){let i=this.getUtoTmapping(t);return this.getTangent(i,e)}computeFrenetFrames(t,e=!1){let i=new P,s=[],r=[],o=[],a=new P,c=new ce;for(let f=0;f<=t;f++){let p=f/t;s[f]=this.getTangentAt(p,new P)}r[0]=new P,o[0]=new P;let l=Number.MAX_VALUE,h=Math.abs(s[0].x),u=Math.abs(s[0].y),d=Math.abs(s[0].z);h<=l&&(l=h,i.set(1,0,0)),u<=l&&(l=u,i.set(0,1,0)),d<=l&&i.set(0,0,1),a.crossVectors(s[0],i).normalize(),r[0].crossVectors(s[0],a),o[0].crossVectors(s[0],r[0]);for(let f=1;f<=t;f++){if(r[f]=r[f-1].clone(),o[f]=o[f-1].clone(),a.crossVectors(s[f-1],s[f]),a.length()>Number.EPSILON){a.normalize();let p=Math.acos(Qt(s[f-1].dot(s[f]),-1,1));r[f].applyMatrix4(c.makeRotationAxis(a,p))}o[f].crossVectors(s[f],r[f])}if(e===!0){let f=Math.acos(Qt(r[0].dot(r[t]),-1,1));f/=t,s[0].dot(a.crossVectors(r[0],r[t]))>0&&(f=-f);for(let p=1;p<=t;p++)r[p].applyMatrix4(c.makeRotationAxis(s[p],f*p)),o[p].crossVectors(s[p],r[p])}return{tangents:s,normals:r,binormals:o}}clone(){return new this.constructor().copy(this)}copy(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}toJSON(){let t={metadata:{version:4.7,type:"Curve",generator:"Curve.toJSON"}};return t.arcLengthDivisions=this.arcLengthDivisions,t.type=this.type,t}fromJSON(t){return this.arcLengthDivisions=t.arcLengthDivisions,this.cacheArcLengths=null,this}},ia=class extends Xn{constructor(t=0,e=0,i=1,s=1,r=0,o=Math.PI*2,a=!1,c=0){super(),this.isEllipseCurve=!0,this.type="EllipseCurve",this.aX=t,this.aY=e,this.xRadius=i,this.yRadius=s,this.aStartAngle=r,this.aEndAngle=o,this.aClockwise=a,this.aRotation=c}getPoint(t,e=new St){let i=e,s=Math.PI*2,r=this.aEndAngle-this.aStartAngle,o=Math.abs(r)<Number.EPSILON;for(;r<0;)r+=s;for(;r>s;)r-=s;r<Number.EPSILON&&(o?r=0:r=s),this.aClockwise===!0&&!o&&(r===s?r=-s:r=r-s);let a=this.aStartAngle+t*r,c=this.aX+this.xRadius*Math.cos(a),l=this.aY+this.yRadius*Math.sin(a);if(this.aRotation!==0){let h=Math.cos(this.aRotation),u=Math.sin(this.aRotation),d=c-this.aX,f=l-this.aY;c=d*h-f*u+this.aX,l=d*u+f*h+this.aY}return i.set(c,l)}copy(t){return super.copy(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}toJSON(){let t=super.toJSON();return t.aX=this.aX,t.aY=this.aY,t.xRadius=this.xRadius,t.yRadius=this.yRadius,t.aStartAngle=this.aStartAngle,t.aEndAngle=this.aEndAngle,t.aClockwise=this.aClockwise,t.aRotation=this.aRotation,t}fromJSON(t){return super.fromJSON(t),this.aX=t.aX,this.aY=t.aY,this.xRadius=t.xRadius,this.yRadius=t.yRadius,this.aStartAngle=t.aStartAngle,this.aEndAngle=t.aEndAngle,this.aClockwise=t.aClockwise,this.aRotation=t.aRotation,this}},bl=class extends ia{constructor(t,e,i,s,r,o){super(t,e,i,i,s,r,o),this.isArcCurve=!0,this.type="ArcCurve"}};function $f(){let n=0,t=0,e=0,i=0;function s(r,o,a,c){n=r,t=a,e=-3*r+3*o-2*a-c,i=2*r-2*o+a+c}return{initCatmullRom:function(r,o,a,c,l){s(o,a,l*(a-r),l*(c-o))},initNonuniformCatmullRom:function(r,o,a,c,l,h,u){let d=(o-r)/l-(a-r)/(l+h)+(a-o)/h,f=(a-o)/h-(c-o)/(h+u)+(c-a)/u;d*=h,f*=h,s(o,a,d,f)},calc:function(r){let o=r*r,a=o*r;return n+t*r+e*o+i*a}}}var g0=new P,x0=new P,ef=new $f,nf=new $f,sf=new $f,jr=class extends Xn{constructor(t=[],e=!1,i="centripetal",s=.5){super(),this.isCatmullRomCurve3=!0,this.type="CatmullRomCurve3",this.points=t,this.closed=e,this.curveType=i,this.tension=s}getPoint(t,e=new P){let i=e,s=this.points,r=s.length,o=(r-(this.closed?0:1))*t,a=Math.floor(o),c=o-a;this.closed?a+=a>0?0:(Math.floor(Math.abs(a)/r)+1)*r:c===0&&a===r-1&&(a=r-2,c=1);let l,h;this.closed||a>0?l=s[(a-1)%r]:(x0.subVectors(s[0],s[1]).add(s[0]),l=x0);let u=s[a%r],d=s[(a+1)%r];if(this.closed||a+2<r?h=s[(a+2)%r]:(g0.subVectors(s[r-1],s[r-2]).add(s[r-1]),h=g0),this.curveType==="centripetal"||this.curveType==="chordal"){let f=this.curveType==="chordal"?.5:.25,p=Math.pow(l.distanceToSquared(u),f),m=Math.pow(u.distanceToSquared(d),f),g=Math.pow(d.distanceToSquared(h),f);m<1e-4&&(m=1),p<1e-4&&(p=m),g<1e-4&&(g=m),ef.initNonuniformCatmullRom(l.x,u.x,d.x,h.x,p,m,g),nf.initNonuniformCatmullRom(l.y,u.y,d.y,h.y,p,m,g),sf.initNonuniformCatmullRom(l.z,u.z,d.z,h.z,p,m,g)}else this.curveType==="catmullrom"&&(ef.initCatmullRom(l.x,u.x,d.x,h.x,this.tension),nf.initCatmullRom(l.y,u.y,d.y,h.y,this.tension),sf.initCatmullRom(l.z,u.z,d.z,h.z,this.tension));return i.set(ef.calc(c),nf.calc(c),sf.calc(c)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t.closed=this.closed,t.curveType=this.curveType,t.tension=this.tension,t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new P().fromArray(s))}return this.closed=t.closed,this.curveType=t.curveType,this.tension=t.tension,this}};function _0(n,t,e,i,s){let r=(i-t)*.5,o=(s-e)*.5,a=n*n,c=n*a;return(2*e-2*i+r+o)*c+(-3*e+3*i-2*r-o)*a+r*n+e}function a1(n,t){let e=1-n;return e*e*t}function c1(n,t){return 2*(1-n)*n*t}function l1(n,t){return n*n*t}function Bo(n,t,e,i){return a1(n,t)+c1(n,e)+l1(n,i)}function h1(n,t){let e=1-n;return e*e*e*t}function u1(n,t){let e=1-n;return 3*e*e*n*t}function d1(n,t){return 3*(1-n)*n*n*t}function f1(n,t){return n*n*n*t}function zo(n,t,e,i,s){return h1(n,t)+u1(n,e)+d1(n,i)+f1(n,s)}var wl=class extends Xn{constructor(t=new St,e=new St,i=new St,s=new St){super(),this.isCubicBezierCurve=!0,this.type="CubicBezierCurve",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new St){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(zo(t,s.x,r.x,o.x,a.x),zo(t,s.y,r.y,o.y,a.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Ml=class extends Xn{constructor(t=new P,e=new P,i=new P,s=new P){super(),this.isCubicBezierCurve3=!0,this.type="CubicBezierCurve3",this.v0=t,this.v1=e,this.v2=i,this.v3=s}getPoint(t,e=new P){let i=e,s=this.v0,r=this.v1,o=this.v2,a=this.v3;return i.set(zo(t,s.x,r.x,o.x,a.x),zo(t,s.y,r.y,o.y,a.y),zo(t,s.z,r.z,o.z,a.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this.v3.copy(t.v3),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t.v3=this.v3.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this.v3.fromArray(t.v3),this}},Sl=class extends Xn{constructor(t=new St,e=new St){super(),this.isLineCurve=!0,this.type="LineCurve",this.v1=t,this.v2=e}getPoint(t,e=new St){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new St){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},El=class extends Xn{constructor(t=new P,e=new P){super(),this.isLineCurve3=!0,this.type="LineCurve3",this.v1=t,this.v2=e}getPoint(t,e=new P){let i=e;return t===1?i.copy(this.v2):(i.copy(this.v2).sub(this.v1),i.multiplyScalar(t).add(this.v1)),i}getPointAt(t,e){return this.getPoint(t,e)}getTangent(t,e=new P){return e.subVectors(this.v2,this.v1).normalize()}getTangentAt(t,e){return this.getTangent(t,e)}copy(t){return super.copy(t),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Tl=class extends Xn{constructor(t=new St,e=new St,i=new St){super(),this.isQuadraticBezierCurve=!0,this.type="QuadraticBezierCurve",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new St){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(Bo(t,s.x,r.x,o.x),Bo(t,s.y,r.y,o.y)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},sa=class extends Xn{constructor(t=new P,e=new P,i=new P){super(),this.isQuadraticBezierCurve3=!0,this.type="QuadraticBezierCurve3",this.v0=t,this.v1=e,this.v2=i}getPoint(t,e=new P){let i=e,s=this.v0,r=this.v1,o=this.v2;return i.set(Bo(t,s.x,r.x,o.x),Bo(t,s.y,r.y,o.y),Bo(t,s.z,r.z,o.z)),i}copy(t){return super.copy(t),this.v0.copy(t.v0),this.v1.copy(t.v1),this.v2.copy(t.v2),this}toJSON(){let t=super.toJSON();return t.v0=this.v0.toArray(),t.v1=this.v1.toArray(),t.v2=this.v2.toArray(),t}fromJSON(t){return super.fromJSON(t),this.v0.fromArray(t.v0),this.v1.fromArray(t.v1),this.v2.fromArray(t.v2),this}},Al=class extends Xn{constructor(t=[]){super(),this.isSplineCurve=!0,this.type="SplineCurve",this.points=t}getPoint(t,e=new St){let i=e,s=this.points,r=(s.length-1)*t,o=Math.floor(r),a=r-o,c=s[o===0?o:o-1],l=s[o],h=s[o>s.length-2?s.length-1:o+1],u=s[o>s.length-3?s.length-1:o+2];return i.set(_0(a,c.x,l.x,h.x,u.x),_0(a,c.y,l.y,h.y,u.y)),i}copy(t){super.copy(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(s.clone())}return this}toJSON(){let t=super.toJSON();t.points=[];for(let e=0,i=this.points.length;e<i;e++){let s=this.points[e];t.points.push(s.toArray())}return t}fromJSON(t){super.fromJSON(t),this.points=[];for(let e=0,i=t.points.length;e<i;e++){let s=t.points[e];this.points.push(new St().fromArray(s))}return this}},p1=Object.freeze({__proto__:null,ArcCurve:bl,CatmullRomCurve3:jr,CubicBezierCurve:wl,CubicBezierCurve3:Ml,EllipseCurve:ia,LineCurve:Sl,LineCurve3:El,QuadraticBezierCurve:Tl,QuadraticBezierCurve3:sa,SplineCurve:Al});var tr=class n extends wn{constructor(t=1,e=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:i,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(i),c=Math.floor(s),l=a+1,h=c+1,u=t/a,d=e/c,f=[],p=[],m=[],g=[];for(let x=0;x<h;x++){let _=x*d-o;for(let b=0;b<l;b++){let M=b*u-r;p.push(M,-_,0),m.push(0,0,1),g.push(b/a),g.push(1-x/c)}}for(let x=0;x<c;x++)for(let _=0;_<a;_++){let b=_+l*x,M=_+l*(x+1),T=_+1+l*(x+1),E=_+1+l*x;f.push(b,M,E),f.push(M,T,E)}this.setIndex(f),this.setAttribute("position",new Re(p,3)),this.setAttribute("normal",new Re(m,3)),this.setAttribute("uv",new Re(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.width,t.height,t.widthSegments,t.heightSegments)}};var ra=class n extends wn{constructor(t=1,e=32,i=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:i,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),i=Math.max(2,Math.floor(i));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new P,d=new P,f=[],p=[],m=[],g=[];for(let x=0;x<=i;x++){let _=[],b=x/i,M=o+b*a,T=t*Math.cos(M),E=Math.sqrt(t*t-T*T),y=0;x===0&&o===0?y=.5/e:x===i&&c===Math.PI&&(y=-.5/e);for(let S=0;S<=e;S++){let D=S/e,L=s+D*r;u.x=-E*Math.cos(L),u.y=T,u.z=E*Math.sin(L),p.push(u.x,u.y,u.z),d.copy(u).normalize(),m.push(d.x,d.y,d.z),g.push(D+y,1-b),_.push(l++)}h.push(_)}for(let x=0;x<i;x++)for(let _=0;_<e;_++){let b=h[x][_+1],M=h[x][_],T=h[x+1][_],E=h[x+1][_+1];(x!==0||o>0)&&f.push(b,M,E),(x!==i-1||c<Math.PI)&&f.push(M,T,E)}this.setIndex(f),this.setAttribute("position",new Re(p,3)),this.setAttribute("normal",new Re(m,3)),this.setAttribute("uv",new Re(g,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new n(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var oa=class n extends wn{constructor(t=new sa(new P(-1,-1,0),new P(-1,1,0),new P(1,1,0)),e=64,i=1,s=8,r=!1){super(),this.type="TubeGeometry",this.parameters={path:t,tubularSegments:e,radius:i,radialSegments:s,closed:r};let o=t.computeFrenetFrames(e,r);this.tangents=o.tangents,this.normals=o.normals,this.binormals=o.binormals;let a=new P,c=new P,l=new St,h=new P,u=[],d=[],f=[],p=[];m(),this.setIndex(p),this.setAttribute("position",new Re(u,3)),this.setAttribute("normal",new Re(d,3)),this.setAttribute("uv",new Re(f,2));function m(){for(let b=0;b<e;b++)g(b);g(r===!1?e:0),_(),x()}function g(b){h=t.getPointAt(b/e,h);let M=o.normals[b],T=o.binormals[b];for(let E=0;E<=s;E++){let y=E/s*Math.PI*2,S=Math.sin(y),D=-Math.cos(y);c.x=D*M.x+S*T.x,c.y=D*M.y+S*T.y,c.z=D*M.z+S*T.z,c.normalize(),d.push(c.x,c.y,c.z),a.x=h.x+i*c.x,a.y=h.y+i*c.y,a.z=h.z+i*c.z,u.push(a.x,a.y,a.z)}}function x(){for(let b=1;b<=e;b++)for(let M=1;M<=s;M++){let T=(s+1)*(b-1)+(M-1),E=(s+1)*b+(M-1),y=(s+1)*b+M,S=(s+1)*(b-1)+M;p.push(T,E,S),p.push(E,y,S)}}function _(){for(let b=0;b<=e;b++)for(let M=0;M<=s;M++)l.x=b/e,l.y=M/s,f.push(l.x,l.y)}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}toJSON(){let t=super.toJSON();return t.path=this.parameters.path.toJSON(),t}static fromJSON(t){return new n(new p1[t.path.type]().fromJSON(t.path),t.tubularSegments,t.radius,t.radialSegments,t.closed)}};var aa=class extends Mi{constructor(t){super(),this.isShadowMaterial=!0,this.type="ShadowMaterial",this.color=new $t(0),this.transparent=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.fog=t.fog,this}};function or(n){let t={};for(let e in n){t[e]={};for(let i in n[e]){let s=n[e][i];if(y0(s))s.isRenderTargetTexture?(Bt("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][i]=null):t[e][i]=s.clone();else if(Array.isArray(s))if(y0(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][i]=r}else t[e][i]=s.slice();else t[e][i]=s}}return t}function on(n){let t={};for(let e=0;e<n.length;e++){let i=or(n[e]);for(let s in i)t[s]=i[s]}return t}function y0(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function m1(n){let t=[];for(let e=0;e<n.length;e++)t.push(n[e].clone());return t}function qf(n){let t=n.getRenderTarget();return t===null?n.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:re.workingColorSpace}var px={clone:or,merge:on},g1=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,x1=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,jn=class extends Mi{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=g1,this.fragmentShader=x1,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=or(t.uniforms),this.uniformsGroups=m1(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(e.extensions=i),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let i in t.uniforms){let s=t.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=e[s.value]||null;break;case"c":this.uniforms[i].value=new $t().setHex(s.value);break;case"v2":this.uniforms[i].value=new St().fromArray(s.value);break;case"v3":this.uniforms[i].value=new P().fromArray(s.value);break;case"v4":this.uniforms[i].value=new be().fromArray(s.value);break;case"m3":this.uniforms[i].value=new qt().fromArray(s.value);break;case"m4":this.uniforms[i].value=new ce().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let i in t.extensions)this.extensions[i]=t.extensions[i];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},Rl=class extends jn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}},Si=class extends Mi{constructor(t){super(),this.isMeshStandardMaterial=!0,this.type="MeshStandardMaterial",this.defines={STANDARD:""},this.color=new $t(16777215),this.roughness=1,this.metalness=0,this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new $t(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ch,this.normalScale=new St(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.roughnessMap=null,this.metalnessMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new $i,this.envMapIntensity=1,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.defines={STANDARD:""},this.color.copy(t.color),this.roughness=t.roughness,this.metalness=t.metalness,this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.roughnessMap=t.roughnessMap,this.metalnessMap=t.metalnessMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.envMapIntensity=t.envMapIntensity,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}};var Cl=class extends Mi{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=K0,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},Il=class extends Mi{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Ur(n,t){return!n||n.constructor===t?n:typeof t.BYTES_PER_ELEMENT=="number"?new t(n):Array.prototype.slice.call(n)}function Qc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var ms=class{constructor(t,e,i,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(i),this.sampleValues=e,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,i=this._cachedIndex,s=e[i],r=e[i-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=i+2;;){if(s===void 0){if(t<r)break i;return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=e[++i],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(i=2,r=a);for(let c=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===c)break;if(s=r,r=e[--i-1],t>=r)break t}o=i,i=0;break e}break n}for(;i<o;){let a=i+o>>>1;t<e[a]?o=a:i=a+1}if(s=e[i],r=e[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=e.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=i[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Pl=class extends ms{constructor(t,e,i,s){super(t,e,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:af,endingEnd:af}}intervalChanged_(t,e,i){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case cf:r=t,a=2*e-i;break;case lf:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=i}if(c===void 0)switch(this.getSettings_().endingEnd){case cf:o=t,c=2*i-e;break;case lf:o=1,c=i+s[1]-s[0];break;default:o=t-1,c=e}let l=(i-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-i),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(i-e)/(s-e),m=p*p,g=m*p,x=-d*g+2*d*m-d*p,_=(1+d)*g+(-1.5-2*d)*m+(-.5+d)*p+1,b=(-1-f)*g+(1.5+f)*m+.5*p,M=f*g-f*m;for(let T=0;T!==a;++T)r[T]=x*o[h+T]+_*o[l+T]+b*o[c+T]+M*o[u+T];return r}},Ll=class extends ms{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(i-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},Nl=class extends ms{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t){return this.copySampleValue_(t-1)}},Dl=class extends ms{interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(i-e)/(s-e),m=1-p;for(let g=0;g!==a;++g)r[g]=o[l+g]*m+o[c+g]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let m=o[l+p],g=o[c+p],x=f*d+p*2,_=u[x],b=u[x+1],M=t*d+p*2,T=h[M],E=h[M+1],y=y1(i,e,_,T,s);r[p]=mx(y,m,b,E,g)}return r}};function mx(n,t,e,i,s){let r=1-n;return r*r*r*t+3*r*r*n*e+3*r*n*n*i+n*n*n*s}function _1(n,t,e,i,s){let r=1-n;return 3*r*r*(e-t)+6*r*n*(i-e)+3*n*n*(s-i)}function y1(n,t,e,i,s){let r=(n-t)/(s-t);for(let o=0;o<8;o++){let a=mx(r,t,e,i,s)-n;if(Math.abs(a)<1e-10)break;let c=_1(r,t,e,i,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Un=class{constructor(t,e,i,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Ur(e,this.TimeBufferType),this.values=Ur(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,i;if(e.toJSON!==this.toJSON)i=e.toJSON(t);else{i={name:t.name,times:Ur(t.times,Array),values:Ur(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(i.interpolation=s),Qc(t.settings)&&(i.settings={inTangents:Ur(t.settings.inTangents,Array),outTangents:Ur(t.settings.outTangents,Array)})}return i.type=t.ValueTypeName,i}InterpolantFactoryMethodDiscrete(t){return new Nl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new Ll(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new Pl(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new Dl(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case Go:e=this.InterpolantFactoryMethodDiscrete;break;case fl:e=this.InterpolantFactoryMethodLinear;break;case nl:e=this.InterpolantFactoryMethodSmooth;break;case of:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Bt("KeyframeTrack:",i),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Go;case this.InterpolantFactoryMethodLinear:return fl;case this.InterpolantFactoryMethodSmooth:return nl;case this.InterpolantFactoryMethodBezier:return of}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]+=t;Qc(this.settings)&&(v0(this.settings.inTangents,t),v0(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let i=0,s=e.length;i!==s;++i)e[i]*=t;Qc(this.settings)&&(b0(this.settings.inTangents,t),b0(this.settings.outTangents,t))}return this}trim(t,e){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<t;)++r;for(;o!==-1&&i[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Wt("KeyframeTrack: Invalid value size in track.",this),t=!1);let i=this.times,s=this.values,r=i.length;r===0&&(Wt("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=i[a];if(typeof c=="number"&&isNaN(c)){Wt("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){Wt("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&TS(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){Wt("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===nl,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let u=a*i,d=u-i,f=u+i;for(let p=0;p!==i;++p){let m=e[u+p];if(m!==e[d+p]||m!==e[f+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let u=a*i,d=o*i;for(let f=0;f!==i;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*i,c=o*i,l=0;l!==i;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*i)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),i=this.constructor,s=new i(this.name,t,e);return s.createInterpolant=this.createInterpolant,Qc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function v0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]+=t}function b0(n,t){for(let e=0,i=n.length;e!==i;e+=2)n[e]*=t}Un.prototype.ValueTypeName="";Un.prototype.TimeBufferType=Float32Array;Un.prototype.ValueBufferType=Float32Array;Un.prototype.DefaultInterpolation=fl;var gs=class extends Un{constructor(t,e,i){super(t,e,i)}};gs.prototype.ValueTypeName="bool";gs.prototype.ValueBufferType=Array;gs.prototype.DefaultInterpolation=Go;gs.prototype.InterpolantFactoryMethodLinear=void 0;gs.prototype.InterpolantFactoryMethodSmooth=void 0;var Ol=class extends Un{constructor(t,e,i,s){super(t,e,i,s)}};Ol.prototype.ValueTypeName="color";var Ul=class extends Un{constructor(t,e,i,s){super(t,e,i,s)}};Ul.prototype.ValueTypeName="number";var Fl=class extends ms{constructor(t,e,i,s){super(t,e,i,s)}interpolate_(t,e,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(i-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)mn.slerpFlat(r,0,o,l-a,o,l,c);return r}},ca=class extends Un{constructor(t,e,i,s){super(t,e,i,s)}InterpolantFactoryMethodLinear(t){return new Fl(this.times,this.values,this.getValueSize(),t)}};ca.prototype.ValueTypeName="quaternion";ca.prototype.InterpolantFactoryMethodSmooth=void 0;var xs=class extends Un{constructor(t,e,i){super(t,e,i)}};xs.prototype.ValueTypeName="string";xs.prototype.ValueBufferType=Array;xs.prototype.DefaultInterpolation=Go;xs.prototype.InterpolantFactoryMethodLinear=void 0;xs.prototype.InterpolantFactoryMethodSmooth=void 0;var kl=class extends Un{constructor(t,e,i,s){super(t,e,i,s)}};kl.prototype.ValueTypeName="vector";var Bl=class{constructor(t,e,i){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=i,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],p=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},gx=new Bl,zl=class{constructor(t){this.manager=t!==void 0?t:gx,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let i=this;return new Promise(function(s,r){i.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};zl.DEFAULT_MATERIAL_NAME="__DEFAULT";var la=class extends Ze{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new $t(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}},ha=class extends la{constructor(t,e,i){super(t,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Ze.DEFAULT_UP),this.updateMatrix(),this.groundColor=new $t(e)}copy(t,e){return super.copy(t,e),this.groundColor.copy(t.groundColor),this}toJSON(t){let e=super.toJSON(t);return e.object.groundColor=this.groundColor.getHex(),e}},rf=new ce,w0=new P,M0=new P,Gl=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new St(512,512),this.mapType=Sn,this.map=null,this.mapPass=null,this.matrix=new ce,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new fs,this._frameExtents=new St(1,1),this._viewportCount=1,this._viewports=[new be(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;w0.setFromMatrixPosition(t.matrixWorld),e.position.copy(w0),M0.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(M0),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,i,s){rf.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),i.setFromProjectionMatrix(rf,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===Gr||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(rf)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},tl=new P,el=new mn,bi=new P,ua=class extends Ze{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new ce,this.projectionMatrix=new ce,this.projectionMatrixInverse=new ce,this.coordinateSystem=qn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(tl,el,bi),bi.x===1&&bi.y===1&&bi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tl,el,bi.set(1,1,1)).invert()}updateWorldMatrix(t,e,i=!1){super.updateWorldMatrix(t,e,i),this.matrixWorld.decompose(tl,el,bi),bi.x===1&&bi.y===1&&bi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tl,el,bi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},hs=new P,S0=new St,E0=new St,fn=class extends ua{constructor(t=50,e=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=Hr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(Fo*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return Hr*2*Math.atan(Math.tan(Fo*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,i){hs.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(hs.x,hs.y).multiplyScalar(-t/hs.z),hs.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(hs.x,hs.y).multiplyScalar(-t/hs.z)}getViewSize(t,e){return this.getViewBounds(t,S0,E0),e.subVectors(E0,S0)}setViewOffset(t,e,i,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(Fo*.5*this.fov)/this.zoom,i=2*e,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*i/l,s*=o.width/c,i*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-i,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var da=class extends ua{constructor(t=-1,e=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-t,o=i+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},hf=class extends Gl{constructor(){super(new da(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},fa=class extends la{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Ze.DEFAULT_UP),this.updateMatrix(),this.target=new Ze,this.shadow=new hf}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}};var Fr=-90,kr=1,Yr=class extends Ze{constructor(t,e,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new fn(Fr,kr,t,e);s.layers=this.layers,this.add(s);let r=new fn(Fr,kr,t,e);r.layers=this.layers,this.add(r);let o=new fn(Fr,kr,t,e);o.layers=this.layers,this.add(o);let a=new fn(Fr,kr,t,e);a.layers=this.layers,this.add(a);let c=new fn(Fr,kr,t,e);c.layers=this.layers,this.add(c);let l=new fn(Fr,kr,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[i,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===qn)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===Gr)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let m=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;t.isWebGLRenderer===!0?g=t.state.buffers.depth.getReversed():g=t.reversedDepthBuffer,t.setRenderTarget(i,0,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(i,1,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(i,2,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(i,3,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(i,4,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),i.texture.mipmapsAutoUpdate=m,t.setRenderTarget(i,5,s),g&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Vl=class extends fn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var Xf="\\[\\]\\.:\\/",v1=new RegExp("["+Xf+"]","g"),jf="[^"+Xf+"]",b1="[^"+Xf.replace("\\.","")+"]",w1=/((?:WC+[\/:])*)/.source.replace("WC",jf),M1=/(WCOD+)?/.source.replace("WCOD",b1),S1=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",jf),E1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",jf),T1=new RegExp("^"+w1+M1+S1+E1+"$"),A1=["material","materials","bones","map"],uf=class{constructor(t,e,i){let s=i||_e.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(t,e)}setValue(t,e){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,i=t.length;e!==i;++e)t[e].unbind()}},_e=class n{constructor(t,e,i){this.path=e,this.parsedPath=i||n.parseTrackName(e),this.node=n.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,i){return t&&t.isAnimationObjectGroup?new n.Composite(t,e,i):new n(t,e,i)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(v1,"")}static parseTrackName(t){let e=T1.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let i={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);A1.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return i}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let i=t.skeleton.getBoneByName(e);if(i!==void 0)return i}if(t.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=i(a.children);if(c)return c}return null},s=i(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)t[e++]=i[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,i=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=n.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){Bt("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let l=e.objectIndex;switch(i){case"materials":if(!t.material){Wt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Wt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Wt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Wt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Wt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[i]===void 0){Wt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[i]}if(l!==void 0){if(t[l]===void 0){Wt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;Wt("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Wt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Wt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};_e.Composite=uf;_e.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};_e.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};_e.prototype.GetterByBindingType=[_e.prototype._getValue_direct,_e.prototype._getValue_array,_e.prototype._getValue_arrayElement,_e.prototype._getValue_toArray];_e.prototype.SetterByBindingTypeAndVersioning=[[_e.prototype._setValue_direct,_e.prototype._setValue_direct_setNeedsUpdate,_e.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_array,_e.prototype._setValue_array_setNeedsUpdate,_e.prototype._setValue_array_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_arrayElement,_e.prototype._setValue_arrayElement_setNeedsUpdate,_e.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_fromArray,_e.prototype._setValue_fromArray_setNeedsUpdate,_e.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var Oz=new Float32Array(1);var T0=new ce,pa=class{constructor(t,e,i=0,s=1/0){this.ray=new ds(t,e),this.near=i,this.far=s,this.camera=null,this.layers=new $r,this.params={Mesh:{},Line:{threshold:1},LOD:{},Points:{threshold:1},Sprite:{}}}set(t,e){this.ray.set(t,e)}setFromCamera(t,e){e.isPerspectiveCamera?(this.ray.origin.setFromMatrixPosition(e.matrixWorld),this.ray.direction.set(t.x,t.y,.5).unproject(e).sub(this.ray.origin).normalize(),this.camera=e):e.isOrthographicCamera?(this.ray.origin.set(t.x,t.y,e.projectionMatrix.elements[14]).unproject(e),this.ray.direction.set(0,0,-1).transformDirection(e.matrixWorld),this.camera=e):Wt("Raycaster: Unsupported camera type: "+e.type)}setFromXRController(t){return T0.identity().extractRotation(t.matrixWorld),this.ray.origin.setFromMatrixPosition(t.matrixWorld),this.ray.direction.set(0,0,-1).applyMatrix4(T0),this}intersectObject(t,e=!0,i=[]){return df(t,this,i,e),i.sort(A0),i}intersectObjects(t,e=!0,i=[]){for(let s=0,r=t.length;s<r;s++)df(t[s],this,i,e);return i.sort(A0),i}};function A0(n,t){return n.distance-t.distance}function df(n,t,e,i){let s=!0;if(n.layers.test(t.layers)&&n.raycast(t,e)===!1&&(s=!1),s===!0&&i===!0){let r=n.children;for(let o=0,a=r.length;o<a;o++)df(r[o],t,e,!0)}}var Jr=class{constructor(t=1,e=0,i=0){this.radius=t,this.phi=e,this.theta=i}set(t,e,i){return this.radius=t,this.phi=e,this.theta=i,this}copy(t){return this.radius=t.radius,this.phi=t.phi,this.theta=t.theta,this}makeSafe(){return this.phi=Qt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(t){return this.setFromCartesianCoords(t.x,t.y,t.z)}setFromCartesianCoords(t,e,i){return this.radius=Math.sqrt(t*t+e*e+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(t,i),this.phi=Math.acos(Qt(e/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ff=class{static{this.prototype.isMatrix2=!0}constructor(t,e,i,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let i=0;i<4;i++)this.elements[i]=t[i+e];return this}set(t,e,i,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=i,r[3]=s,this}};var ma=class extends ai{constructor(t,e=null){super(),this.object=t,this.domElement=e,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(t){this.domElement!==null&&this.disconnect(),this.domElement=t}disconnect(){}dispose(){}update(){}};function Yf(n,t,e,i){let s=R1(i);switch(e){case Nf:return n*t;case Yl:return n*t/s.components*s.byteLength;case Jl:return n*t/s.components*s.byteLength;case bs:return n*t*2/s.components*s.byteLength;case Zl:return n*t*2/s.components*s.byteLength;case Df:return n*t*3/s.components*s.byteLength;case hi:return n*t*4/s.components*s.byteLength;case Kl:return n*t*4/s.components*s.byteLength;case xa:case _a:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case ya:case va:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case th:case nh:return Math.max(n,16)*Math.max(t,8)/4;case Ql:case eh:return Math.max(n,8)*Math.max(t,8)/2;case ih:case sh:case oh:case ah:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*8;case rh:case ba:case ch:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case lh:return Math.floor((n+3)/4)*Math.floor((t+3)/4)*16;case hh:return Math.floor((n+4)/5)*Math.floor((t+3)/4)*16;case uh:return Math.floor((n+4)/5)*Math.floor((t+4)/5)*16;case dh:return Math.floor((n+5)/6)*Math.floor((t+4)/5)*16;case fh:return Math.floor((n+5)/6)*Math.floor((t+5)/6)*16;case ph:return Math.floor((n+7)/8)*Math.floor((t+4)/5)*16;case mh:return Math.floor((n+7)/8)*Math.floor((t+5)/6)*16;case gh:return Math.floor((n+7)/8)*Math.floor((t+7)/8)*16;case xh:return Math.floor((n+9)/10)*Math.floor((t+4)/5)*16;case _h:return Math.floor((n+9)/10)*Math.floor((t+5)/6)*16;case yh:return Math.floor((n+9)/10)*Math.floor((t+7)/8)*16;case vh:return Math.floor((n+9)/10)*Math.floor((t+9)/10)*16;case bh:return Math.floor((n+11)/12)*Math.floor((t+9)/10)*16;case wh:return Math.floor((n+11)/12)*Math.floor((t+11)/12)*16;case Mh:case Sh:case Eh:return Math.ceil(n/4)*Math.ceil(t/4)*16;case Th:case Ah:return Math.ceil(n/4)*Math.ceil(t/4)*8;case wa:case Rh:return Math.ceil(n/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function R1(n){switch(n){case Sn:case Cf:return{byteLength:1,components:1};case to:case If:case li:return{byteLength:2,components:1};case Xl:case jl:return{byteLength:2,components:4};case ci:case ql:case Yn:return{byteLength:4,components:1};case Pf:case Lf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Bt("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function kx(){let n=null,t=!1,e=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&n!==null&&(i=n.requestAnimationFrame(s),t=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){n=r}}}function I1(n){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=n.createBuffer();n.bindBuffer(c,d),n.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=n.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=n.SHORT;else if(l instanceof Uint32Array)f=n.UNSIGNED_INT;else if(l instanceof Int32Array)f=n.INT;else if(l instanceof Int8Array)f=n.BYTE;else if(l instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function i(a,c,l){let h=c.array,u=c.updateRanges;if(n.bindBuffer(l,a),u.length===0)n.bufferSubData(l,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],m=u[f];m.start<=p.start+p.count+1?p.count=Math.max(p.count,m.start+m.count-p.start):(++d,u[d]=m)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let m=u[f];n.bufferSubData(l,m.start*h.BYTES_PER_ELEMENT,h,m.start,m.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(n.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var P1=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,L1=`#ifdef USE_ALPHAHASH
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
#endif`,N1=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,D1=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,O1=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,U1=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,F1=`#ifdef USE_AOMAP
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
#endif`,k1=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,B1=`#ifdef USE_BATCHING
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
#endif`,z1=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,G1=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,V1=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,H1=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,W1=`#ifdef USE_IRIDESCENCE
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
#endif`,$1=`#ifdef USE_BUMPMAP
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
#endif`,q1=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,X1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,j1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,Y1=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,J1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,Z1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,K1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Q1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,tE=`#define PI 3.141592653589793
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
} // validated`,eE=`vec3 transformedNormal = objectNormal;
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
#endif`,nE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,iE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,sE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,rE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,oE="gl_FragColor = linearToOutputTexel( gl_FragColor );",aE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,cE=`#ifdef USE_ENVMAP
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
#endif`,lE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,hE=`#ifdef USE_ENVMAP
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
#endif`,uE=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,dE=`#ifdef USE_ENVMAP
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
#endif`,fE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,pE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,mE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,gE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,xE=`#ifdef USE_GRADIENTMAP
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
}`,_E=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,yE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,vE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,bE=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,wE=`#ifdef USE_ENVMAP
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
#endif`,ME=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,SE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,EE=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,TE=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,AE=`PhysicalMaterial material;
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
#endif`,RE=`uniform sampler2D dfgLUT;
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
}`,CE=`
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
#endif`,IE=`#if defined( RE_IndirectDiffuse )
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
#endif`,PE=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,LE=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,NE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,DE=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,OE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,UE=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,FE=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,kE=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,BE=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,zE=`#if defined( USE_POINTS_UV )
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
#endif`,GE=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,VE=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,HE=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,WE=`#if defined( USE_MORPHCOLORS )
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
#endif`,$E=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,qE=`#ifdef USE_MORPHTARGETS
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
#endif`,XE=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,jE=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,YE=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,JE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,ZE=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,KE=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,QE=`#ifdef USE_NORMALMAP
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
#endif`,tT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,eT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,nT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,iT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,sT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,rT=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,oT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,aT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,cT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,lT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,hT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,uT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,dT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,fT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,pT=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,mT=`float getShadowMask() {
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
}`,gT=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,xT=`#ifdef USE_SKINNING
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
#endif`,_T=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,yT=`#ifdef USE_SKINNING
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
#endif`,vT=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,bT=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,wT=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,MT=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,ST=`#ifdef USE_TRANSMISSION
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
#endif`,ET=`#ifdef USE_TRANSMISSION
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
#endif`,TT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,AT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,RT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,CT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,IT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,PT=`uniform sampler2D t2D;
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
}`,LT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,NT=`uniform float backgroundBlurriness;
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
}`,DT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,OT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,UT=`#include <common>
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
}`,FT=`#if DEPTH_PACKING == 3200
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
}`,kT=`#define DISTANCE
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
}`,BT=`#define DISTANCE
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
}`,zT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,GT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,VT=`uniform float scale;
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
}`,HT=`uniform vec3 diffuse;
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
}`,WT=`#include <common>
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
}`,$T=`uniform vec3 diffuse;
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
}`,qT=`#define LAMBERT
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
}`,XT=`#define LAMBERT
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
}`,jT=`#define MATCAP
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
}`,YT=`#define MATCAP
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
}`,JT=`#define NORMAL
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
}`,ZT=`#define NORMAL
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
}`,KT=`#define PHONG
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
}`,QT=`#define PHONG
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
}`,tA=`#define STANDARD
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
}`,eA=`#define STANDARD
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
}`,nA=`#define TOON
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
}`,iA=`#define TOON
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
}`,sA=`uniform float size;
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
}`,rA=`uniform vec3 diffuse;
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
}`,oA=`#include <common>
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
}`,aA=`uniform vec3 color;
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
}`,cA=`uniform float rotation;
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
}`,lA=`uniform vec3 diffuse;
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
}`,te={alphahash_fragment:P1,alphahash_pars_fragment:L1,alphamap_fragment:N1,alphamap_pars_fragment:D1,alphatest_fragment:O1,alphatest_pars_fragment:U1,aomap_fragment:F1,aomap_pars_fragment:k1,batching_pars_vertex:B1,batching_vertex:z1,begin_vertex:G1,beginnormal_vertex:V1,bsdfs:H1,iridescence_fragment:W1,bumpmap_pars_fragment:$1,clipping_planes_fragment:q1,clipping_planes_pars_fragment:X1,clipping_planes_pars_vertex:j1,clipping_planes_vertex:Y1,color_fragment:J1,color_pars_fragment:Z1,color_pars_vertex:K1,color_vertex:Q1,common:tE,defaultnormal_vertex:eE,displacementmap_pars_vertex:nE,displacementmap_vertex:iE,emissivemap_fragment:sE,emissivemap_pars_fragment:rE,colorspace_fragment:oE,colorspace_pars_fragment:aE,envmap_fragment:cE,envmap_common_pars_fragment:lE,envmap_pars_fragment:hE,envmap_pars_vertex:uE,envmap_physical_pars_fragment:wE,envmap_vertex:dE,fog_vertex:fE,fog_pars_vertex:pE,fog_fragment:mE,fog_pars_fragment:gE,gradientmap_pars_fragment:xE,lightmap_pars_fragment:_E,lights_lambert_fragment:yE,lights_lambert_pars_fragment:vE,lights_pars_begin:bE,lights_toon_fragment:ME,lights_toon_pars_fragment:SE,lights_phong_fragment:EE,lights_phong_pars_fragment:TE,lights_physical_fragment:AE,lights_physical_pars_fragment:RE,lights_fragment_begin:CE,lights_fragment_maps:IE,lights_fragment_end:PE,lightprobes_pars_fragment:LE,logdepthbuf_fragment:NE,logdepthbuf_pars_fragment:DE,logdepthbuf_pars_vertex:OE,logdepthbuf_vertex:UE,map_fragment:FE,map_pars_fragment:kE,map_particle_fragment:BE,map_particle_pars_fragment:zE,metalnessmap_fragment:GE,metalnessmap_pars_fragment:VE,morphinstance_vertex:HE,morphcolor_vertex:WE,morphnormal_vertex:$E,morphtarget_pars_vertex:qE,morphtarget_vertex:XE,normal_fragment_begin:jE,normal_fragment_maps:YE,normal_pars_fragment:JE,normal_pars_vertex:ZE,normal_vertex:KE,normalmap_pars_fragment:QE,clearcoat_normal_fragment_begin:tT,clearcoat_normal_fragment_maps:eT,clearcoat_pars_fragment:nT,iridescence_pars_fragment:iT,opaque_fragment:sT,packing:rT,premultiplied_alpha_fragment:oT,project_vertex:aT,dithering_fragment:cT,dithering_pars_fragment:lT,roughnessmap_fragment:hT,roughnessmap_pars_fragment:uT,shadowmap_pars_fragment:dT,shadowmap_pars_vertex:fT,shadowmap_vertex:pT,shadowmask_pars_fragment:mT,skinbase_vertex:gT,skinning_pars_vertex:xT,skinning_vertex:_T,skinnormal_vertex:yT,specularmap_fragment:vT,specularmap_pars_fragment:bT,tonemapping_fragment:wT,tonemapping_pars_fragment:MT,transmission_fragment:ST,transmission_pars_fragment:ET,uv_pars_fragment:TT,uv_pars_vertex:AT,uv_vertex:RT,worldpos_vertex:CT,background_vert:IT,background_frag:PT,backgroundCube_vert:LT,backgroundCube_frag:NT,cube_vert:DT,cube_frag:OT,depth_vert:UT,depth_frag:FT,distance_vert:kT,distance_frag:BT,equirect_vert:zT,equirect_frag:GT,linedashed_vert:VT,linedashed_frag:HT,meshbasic_vert:WT,meshbasic_frag:$T,meshlambert_vert:qT,meshlambert_frag:XT,meshmatcap_vert:jT,meshmatcap_frag:YT,meshnormal_vert:JT,meshnormal_frag:ZT,meshphong_vert:KT,meshphong_frag:QT,meshphysical_vert:tA,meshphysical_frag:eA,meshtoon_vert:nA,meshtoon_frag:iA,points_vert:sA,points_frag:rA,shadow_vert:oA,shadow_frag:aA,sprite_vert:cA,sprite_frag:lA},yt={common:{diffuse:{value:new $t(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new qt},alphaMap:{value:null},alphaMapTransform:{value:new qt},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new qt}},envmap:{envMap:{value:null},envMapRotation:{value:new qt},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new qt}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new qt}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new qt},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new qt},normalScale:{value:new St(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new qt},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new qt}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new qt}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new qt}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new $t(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new $t(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new qt},alphaTest:{value:0},uvTransform:{value:new qt}},sprite:{diffuse:{value:new $t(16777215)},opacity:{value:1},center:{value:new St(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new qt},alphaMap:{value:null},alphaMapTransform:{value:new qt},alphaTest:{value:0}}},Ai={basic:{uniforms:on([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.fog]),vertexShader:te.meshbasic_vert,fragmentShader:te.meshbasic_frag},lambert:{uniforms:on([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,yt.lights,{emissive:{value:new $t(0)},envMapIntensity:{value:1}}]),vertexShader:te.meshlambert_vert,fragmentShader:te.meshlambert_frag},phong:{uniforms:on([yt.common,yt.specularmap,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,yt.lights,{emissive:{value:new $t(0)},specular:{value:new $t(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:te.meshphong_vert,fragmentShader:te.meshphong_frag},standard:{uniforms:on([yt.common,yt.envmap,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.roughnessmap,yt.metalnessmap,yt.fog,yt.lights,{emissive:{value:new $t(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:te.meshphysical_vert,fragmentShader:te.meshphysical_frag},toon:{uniforms:on([yt.common,yt.aomap,yt.lightmap,yt.emissivemap,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.gradientmap,yt.fog,yt.lights,{emissive:{value:new $t(0)}}]),vertexShader:te.meshtoon_vert,fragmentShader:te.meshtoon_frag},matcap:{uniforms:on([yt.common,yt.bumpmap,yt.normalmap,yt.displacementmap,yt.fog,{matcap:{value:null}}]),vertexShader:te.meshmatcap_vert,fragmentShader:te.meshmatcap_frag},points:{uniforms:on([yt.points,yt.fog]),vertexShader:te.points_vert,fragmentShader:te.points_frag},dashed:{uniforms:on([yt.common,yt.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:te.linedashed_vert,fragmentShader:te.linedashed_frag},depth:{uniforms:on([yt.common,yt.displacementmap]),vertexShader:te.depth_vert,fragmentShader:te.depth_frag},normal:{uniforms:on([yt.common,yt.bumpmap,yt.normalmap,yt.displacementmap,{opacity:{value:1}}]),vertexShader:te.meshnormal_vert,fragmentShader:te.meshnormal_frag},sprite:{uniforms:on([yt.sprite,yt.fog]),vertexShader:te.sprite_vert,fragmentShader:te.sprite_frag},background:{uniforms:{uvTransform:{value:new qt},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:te.background_vert,fragmentShader:te.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new qt}},vertexShader:te.backgroundCube_vert,fragmentShader:te.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:te.cube_vert,fragmentShader:te.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:te.equirect_vert,fragmentShader:te.equirect_frag},distance:{uniforms:on([yt.common,yt.displacementmap,{referencePosition:{value:new P},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:te.distance_vert,fragmentShader:te.distance_frag},shadow:{uniforms:on([yt.lights,yt.fog,{color:{value:new $t(0)},opacity:{value:1}}]),vertexShader:te.shadow_vert,fragmentShader:te.shadow_frag}};Ai.physical={uniforms:on([Ai.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new qt},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new qt},clearcoatNormalScale:{value:new St(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new qt},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new qt},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new qt},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new qt},sheen:{value:0},sheenColor:{value:new $t(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new qt},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new qt},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new qt},transmissionSamplerSize:{value:new St},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new qt},attenuationDistance:{value:0},attenuationColor:{value:new $t(0)},specularColor:{value:new $t(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new qt},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new qt},anisotropyVector:{value:new St},anisotropyMap:{value:null},anisotropyMapTransform:{value:new qt}}]),vertexShader:te.meshphysical_vert,fragmentShader:te.meshphysical_frag};var Ih={r:0,b:0,g:0},hA=new ce,Bx=new qt;Bx.set(-1,0,0,0,1,0,0,0,1);function uA(n,t,e,i,s,r){let o=new $t(0),a=s===!0?0:1,c,l,h=null,u=0,d=null;function f(_){let b=_.isScene===!0?_.background:null;if(b&&b.isTexture){let M=_.backgroundBlurriness>0;b=t.get(b,M)}return b}function p(_){let b=!1,M=f(_);M===null?g(o,a):M&&M.isColor&&(g(M,1),b=!0);let T=n.xr.getEnvironmentBlendMode();T==="additive"?e.buffers.color.setClear(0,0,0,1,r):T==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(n.autoClear||b)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function m(_,b){let M=f(b);M&&M.isCubeTexture?(l===void 0&&(l=new Ue(new ps(1,1,1),new jn({name:"BackgroundCubeMaterial",uniforms:or(Ai.backgroundCube.uniforms),vertexShader:Ai.backgroundCube.vertexShader,fragmentShader:Ai.backgroundCube.fragmentShader,side:gn,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(T,E,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(l)),l.material.uniforms.envMap.value=M,l.material.uniforms.backgroundBlurriness.value=b.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(hA.makeRotationFromEuler(b.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(Bx),l.material.toneMapped=re.getTransfer(M.colorSpace)!==ue,(h!==M||u!==M.version||d!==n.toneMapping)&&(l.material.needsUpdate=!0,h=M,u=M.version,d=n.toneMapping),l.layers.enableAll(),_.unshift(l,l.geometry,l.material,0,0,null)):M&&M.isTexture&&(c===void 0&&(c=new Ue(new tr(2,2),new jn({name:"BackgroundMaterial",uniforms:or(Ai.background.uniforms),vertexShader:Ai.background.vertexShader,fragmentShader:Ai.background.fragmentShader,side:vs,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(c)),c.material.uniforms.t2D.value=M,c.material.uniforms.backgroundIntensity.value=b.backgroundIntensity,c.material.toneMapped=re.getTransfer(M.colorSpace)!==ue,M.matrixAutoUpdate===!0&&M.updateMatrix(),c.material.uniforms.uvTransform.value.copy(M.matrix),(h!==M||u!==M.version||d!==n.toneMapping)&&(c.material.needsUpdate=!0,h=M,u=M.version,d=n.toneMapping),c.layers.enableAll(),_.unshift(c,c.geometry,c.material,0,0,null))}function g(_,b){_.getRGB(Ih,qf(n)),e.buffers.color.setClear(Ih.r,Ih.g,Ih.b,b,r)}function x(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(_,b=1){o.set(_),a=b,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(_){a=_,g(o,a)},render:p,addToRenderList:m,dispose:x}}function dA(n,t){let e=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=d(null),r=s,o=!1;function a(U,k,G,I,H){let X=!1,W=u(U,I,G,k);r!==W&&(r=W,l(r.object)),X=f(U,I,G,H),X&&p(U,I,G,H),H!==null&&t.update(H,n.ELEMENT_ARRAY_BUFFER),(X||o)&&(o=!1,M(U,k,G,I),H!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,t.get(H).buffer))}function c(){return n.createVertexArray()}function l(U){return n.bindVertexArray(U)}function h(U){return n.deleteVertexArray(U)}function u(U,k,G,I){let H=I.wireframe===!0,X=i[k.id];X===void 0&&(X={},i[k.id]=X);let W=U.isInstancedMesh===!0?U.id:0,st=X[W];st===void 0&&(st={},X[W]=st);let q=st[G.id];q===void 0&&(q={},st[G.id]=q);let Q=q[H];return Q===void 0&&(Q=d(c()),q[H]=Q),Q}function d(U){let k=[],G=[],I=[];for(let H=0;H<e;H++)k[H]=0,G[H]=0,I[H]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:k,enabledAttributes:G,attributeDivisors:I,object:U,attributes:{},index:null}}function f(U,k,G,I){let H=r.attributes,X=k.attributes,W=0,st=G.getAttributes();for(let q in st)if(st[q].location>=0){let tt=H[q],Pt=X[q];if(Pt===void 0&&(q==="instanceMatrix"&&U.instanceMatrix&&(Pt=U.instanceMatrix),q==="instanceColor"&&U.instanceColor&&(Pt=U.instanceColor)),tt===void 0||tt.attribute!==Pt||Pt&&tt.data!==Pt.data)return!0;W++}return r.attributesNum!==W||r.index!==I}function p(U,k,G,I){let H={},X=k.attributes,W=0,st=G.getAttributes();for(let q in st)if(st[q].location>=0){let tt=X[q];tt===void 0&&(q==="instanceMatrix"&&U.instanceMatrix&&(tt=U.instanceMatrix),q==="instanceColor"&&U.instanceColor&&(tt=U.instanceColor));let Pt={};Pt.attribute=tt,tt&&tt.data&&(Pt.data=tt.data),H[q]=Pt,W++}r.attributes=H,r.attributesNum=W,r.index=I}function m(){let U=r.newAttributes;for(let k=0,G=U.length;k<G;k++)U[k]=0}function g(U){x(U,0)}function x(U,k){let G=r.newAttributes,I=r.enabledAttributes,H=r.attributeDivisors;G[U]=1,I[U]===0&&(n.enableVertexAttribArray(U),I[U]=1),H[U]!==k&&(n.vertexAttribDivisor(U,k),H[U]=k)}function _(){let U=r.newAttributes,k=r.enabledAttributes;for(let G=0,I=k.length;G<I;G++)k[G]!==U[G]&&(n.disableVertexAttribArray(G),k[G]=0)}function b(U,k,G,I,H,X,W){W===!0?n.vertexAttribIPointer(U,k,G,H,X):n.vertexAttribPointer(U,k,G,I,H,X)}function M(U,k,G,I){m();let H=I.attributes,X=G.getAttributes(),W=k.defaultAttributeValues;for(let st in X){let q=X[st];if(q.location>=0){let Q=H[st];if(Q===void 0&&(st==="instanceMatrix"&&U.instanceMatrix&&(Q=U.instanceMatrix),st==="instanceColor"&&U.instanceColor&&(Q=U.instanceColor)),Q!==void 0){let tt=Q.normalized,Pt=Q.itemSize,jt=t.get(Q);if(jt===void 0)continue;let J=jt.buffer,vt=jt.type,Tt=jt.bytesPerElement,zt=vt===n.INT||vt===n.UNSIGNED_INT||Q.gpuType===ql;if(Q.isInterleavedBufferAttribute){let bt=Q.data,Jt=bt.isInterleavedBuffer===!0?bt.stride:bt.itemSize,Ne=Q.offset;if(bt.isInstancedInterleavedBuffer||bt.isInstancedBufferAttribute){for(let Vt=0;Vt<q.locationSize;Vt++)x(q.location+Vt,bt.meshPerAttribute);U.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=bt.meshPerAttribute*bt.count)}else for(let Vt=0;Vt<q.locationSize;Vt++)g(q.location+Vt);n.bindBuffer(n.ARRAY_BUFFER,J);for(let Vt=0;Vt<q.locationSize;Vt++)b(q.location+Vt,Pt/q.locationSize,vt,tt,Jt*Tt,(Ne+Pt/q.locationSize*Vt)*Tt,zt)}else{if(Q.isInstancedBufferAttribute){for(let bt=0;bt<q.locationSize;bt++)x(q.location+bt,Q.meshPerAttribute);U.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let bt=0;bt<q.locationSize;bt++)g(q.location+bt);n.bindBuffer(n.ARRAY_BUFFER,J);for(let bt=0;bt<q.locationSize;bt++)b(q.location+bt,Pt/q.locationSize,vt,tt,Pt*Tt,Pt/q.locationSize*bt*Tt,zt)}}else if(W!==void 0){let tt=W[st];if(tt!==void 0)switch(tt.length){case 2:n.vertexAttrib2fv(q.location,tt);break;case 3:n.vertexAttrib3fv(q.location,tt);break;case 4:n.vertexAttrib4fv(q.location,tt);break;default:n.vertexAttrib1fv(q.location,tt)}}}}_()}function T(){D();for(let U in i){let k=i[U];for(let G in k){let I=k[G];for(let H in I){let X=I[H];for(let W in X)h(X[W].object),delete X[W];delete I[H]}}delete i[U]}}function E(U){if(i[U.id]===void 0)return;let k=i[U.id];for(let G in k){let I=k[G];for(let H in I){let X=I[H];for(let W in X)h(X[W].object),delete X[W];delete I[H]}}delete i[U.id]}function y(U){for(let k in i){let G=i[k];for(let I in G){let H=G[I];if(H[U.id]===void 0)continue;let X=H[U.id];for(let W in X)h(X[W].object),delete X[W];delete H[U.id]}}}function S(U){for(let k in i){let G=i[k],I=U.isInstancedMesh===!0?U.id:0,H=G[I];if(H!==void 0){for(let X in H){let W=H[X];for(let st in W)h(W[st].object),delete W[st];delete H[X]}delete G[I],Object.keys(G).length===0&&delete i[k]}}}function D(){L(),o=!0,r!==s&&(r=s,l(r.object))}function L(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:D,resetDefaultState:L,dispose:T,releaseStatesOfGeometry:E,releaseStatesOfObject:S,releaseStatesOfProgram:y,initAttributes:m,enableAttribute:g,disableUnusedAttributes:_}}function fA(n,t,e){let i;function s(c){i=c}function r(c,l){n.drawArrays(i,c,l),e.update(l,i,1)}function o(c,l,h){h!==0&&(n.drawArraysInstanced(i,c,l,h),e.update(l,i,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];e.update(d,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function pA(n,t,e,i){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let y=t.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==hi&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let S=y===li&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(y!==Sn&&y!==Yn&&!S&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function c(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(Bt("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&Bt("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&Bt("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),m=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),x=n.getParameter(n.MAX_VERTEX_ATTRIBS),_=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),b=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),T=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:m,maxCubemapSize:g,maxAttributes:x,maxVertexUniforms:_,maxVaryings:b,maxFragmentUniforms:M,maxSamples:T,samples:E}}function mA(n){let t=this,e=null,i=0,s=!1,r=!1,o=new dn,a=new qt,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||i!==0||s;return s=d,i=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,m=u.clipIntersection,g=u.clipShadows,x=n.get(u);if(!s||p===null||p.length===0||r&&!g)r?h(null):l();else{let _=r?0:i,b=_*4,M=x.clippingState||null;c.value=M,M=h(p,d,b,f);for(let T=0;T!==b;++T)M[T]=e[T];x.clippingState=M,this.numIntersection=m?this.numPlanes:0,this.numPlanes+=_}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=i>0),t.numPlanes=i,t.numIntersection=0}function h(u,d,f,p){let m=u!==null?u.length:0,g=null;if(m!==0){if(g=c.value,p!==!0||g===null){let x=f+m*4,_=d.matrixWorldInverse;a.getNormalMatrix(_),(g===null||g.length<x)&&(g=new Float32Array(x));for(let b=0,M=f;b!==m;++b,M+=4)o.copy(u[b]).applyMatrix4(_,a),o.normal.toArray(g,M),g[M+3]=o.constant}c.value=g,c.needsUpdate=!0}return t.numPlanes=m,t.numIntersection=0,g}}var Ea=class extends Dn{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let i={width:t,height:t,depth:1},s=[i,i,i,i,i,i];this.texture=new Qo(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ps(5,5,5),r=new jn({name:"CubemapFromEquirect",uniforms:or(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:gn,blending:nr});r.uniforms.tEquirect.value=e;let o=new Ue(s,r),a=e.minFilter;return e.minFilter===ji&&(e.minFilter=pn),new Yr(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,i=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,i,s);t.setRenderTarget(r)}},xx=256,gA=3,xA=20,zx=256,Gx=16,_A=3,yA=new P,vA=new $t,Lh=class n{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Yr(1,10,null),this._boxMesh=new Ue(new ps(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,i=.1,s=100,r={}){let{size:o=256,position:a=yA}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,m=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,m===null&&(t.background=c.getClearColor(vA));let g=new Yr(i,s,h);return g.position.copy(a),g.update(c,t),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=p,t.background=m,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=vx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=yx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(xx,Vf(t))}_fromTexture(t,e){t.mapping===sr||t.mapping===Qr?this._setSize(t.image.length===0?xx:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let i=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(i),i}_allocateTarget(){let t=this._cubeSize,e=_x(t,!1,!1),i=Math.log2(t)-gA;for(let s=0;s<=i;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==e||t&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=_x(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===sr||t.mapping===Qr?(this._cubemapMaterial===null&&(this._cubemapMaterial=vx()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=yx()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=bA(),this._integrationMaterial=wA());let e=this._cubeSize,i=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Gx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-_A)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(zx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=MA());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,i),s.envMap.value=t.texture,this._renderCube(r,0,i)}};function _x(n,t,e){return new Ea(n,{minFilter:ji,generateMipmaps:t,type:li,colorSpace:Vo,depthBuffer:e})}function Ta(n,t,e){return new jn({name:n,uniforms:t,vertexShader:te.cube_vert,fragmentShader:e,side:gn,blending:nr,depthTest:!1,depthWrite:!1})}function bA(){return Ta("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${zx}u

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
	`)}function wA(){return Ta("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Gx}},`

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
	`)}function MA(){return Ta("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${xA}
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
	`)}function yx(){return Ta("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function vx(){return Ta("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function SA(n){let t=new WeakMap,e=new WeakMap,i=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Hl||f===Wl)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let m=new Ea(p.height);return m.fromEquirectangularTexture(n,d),t.set(d,m),d.addEventListener("dispose",l),a(m.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Hl||f===Wl,m=f===sr||f===Qr;if(p||m){let g=e.get(d),x=g!==void 0?g.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==x)return i===null&&(i=new Lh(n)),g=p?i.fromEquirectangular(d,g):i.fromCubemap(d,g),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),g.texture;if(g!==void 0)return g.texture;{let _=d.image;return p&&_&&_.height>0||m&&_&&c(_)?(i===null&&(i=new Lh(n)),g=p?i.fromEquirectangular(d):i.fromCubemap(d),g.texture.pmremVersion=d.pmremVersion,e.set(d,g),d.addEventListener("dispose",h),g.texture):null}}}return d}function a(d,f){return f===Hl?d.mapping=sr:f===Wl&&(d.mapping=Qr),d}function c(d){let f=0,p=6;for(let m=0;m<p;m++)d[m]!==void 0&&f++;return f===p}function l(d){let f=d.target;f.removeEventListener("dispose",l);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:u}}function EA(n){let t={};function e(i){if(t[i]!==void 0)return t[i];let s=n.getExtension(i);return t[i]=s,s}return{has:function(i){return e(i)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(i){let s=e(i);return s===null&&Uo("WebGLRenderer: "+i+" extension not supported."),s}}}function TA(n,t,e,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let g in p.attributes)t.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let m=r.get(p);m&&(t.remove(m),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function l(p,m){return s[m.id]!==void 0||(m.addEventListener("dispose",a),s[m.id]=new WeakRef(m),o.register(m,m.id,m),e.memory.geometries++),m}function h(p){let m=p.attributes;for(let g in m)t.update(m[g],n.ARRAY_BUFFER)}function u(p){let m=p.index,g=p.attributes.position,x=0;if(g===void 0)return;let _=m!==null?m.array.length:g.array.length/3-1,b=g.count>=65535?jo:Xo,M=new b(Math.ceil(_/3)*6,1),T=M.array;if(m!==null){let y=m.array;x=m.version;for(let S=0,D=0;S<_;S+=3){let L=y[S+0],U=y[S+1],k=y[S+2];T[D++]=L,T[D++]=U,T[D++]=U,T[D++]=k,T[D++]=k,T[D++]=L}}else{x=g.version;for(let y=0,S=0;y<_;y+=3){let D=y+0,L=y+1,U=y+2;T[S++]=D,T[S++]=L,T[S++]=L,T[S++]=U,T[S++]=U,T[S++]=D}}M.version=x;let E=r.get(p);E&&t.remove(E),r.set(p,M)}function d(p){let m=r.get(p);if(m){let g=p.index;g!==null&&m.version<g.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let m=s[p].deref();m!==void 0&&c(m)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function AA(n,t,e){let i;function s(u){i=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){n.drawElements(i,d,r,u*o),e.update(d,i,1)}function l(u,d,f){f!==0&&(n.drawElementsInstanced(i,d,r,u*o,f),e.update(d,i,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,d,0,r,u,0,f);let m=0;for(let g=0;g<f;g++)m+=d[g];e.update(m,i,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function RA(n){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(e.calls++,o){case n.TRIANGLES:e.triangles+=a*(r/3);break;case n.LINES:e.lines+=a*(r/2);break;case n.LINE_STRIP:e.lines+=a*(r-1);break;case n.LINE_LOOP:e.lines+=a*r;break;case n.POINTS:e.points+=a*r;break;default:Wt("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:i}}function CA(n,t,e){let i=new WeakMap,s=new be;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=i.get(a);if(d===void 0||d.count!==u){let D=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",D)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,m=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],x=a.morphAttributes.normal||[],_=a.morphAttributes.color||[],b=0;f===!0&&(b=1),p===!0&&(b=2),m===!0&&(b=3);let M=a.attributes.position.count*b,T=1;M>t.maxTextureSize&&(T=Math.ceil(M/t.maxTextureSize),M=t.maxTextureSize);let E=new Float32Array(M*T*4*u),y=new $o(E,M,T,u);y.type=Yn,y.needsUpdate=!0;let S=b*4;for(let L=0;L<u;L++){let U=g[L],k=x[L],G=_[L],I=M*T*4*L;for(let H=0;H<U.count;H++){let X=H*S;f===!0&&(s.fromBufferAttribute(U,H),E[I+X+0]=s.x,E[I+X+1]=s.y,E[I+X+2]=s.z,E[I+X+3]=0),p===!0&&(s.fromBufferAttribute(k,H),E[I+X+4]=s.x,E[I+X+5]=s.y,E[I+X+6]=s.z,E[I+X+7]=0),m===!0&&(s.fromBufferAttribute(G,H),E[I+X+8]=s.x,E[I+X+9]=s.y,E[I+X+10]=s.z,E[I+X+11]=G.itemSize===4?s.w:1)}}d={count:u,texture:y,size:new St(M,T)},i.set(a,d),a.addEventListener("dispose",D)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(n,"morphTexture",o.morphTexture,e);else{let f=0;for(let m=0;m<l.length;m++)f+=l[m];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(n,"morphTargetBaseInfluence",p),c.getUniforms().setValue(n,"morphTargetInfluences",l)}c.getUniforms().setValue(n,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(n,"morphTargetsTextureSize",d.size)}return{update:r}}function IA(n,t,e,i,s){let r=new WeakMap;function o(l){let h=s.render.frame,u=l.geometry,d=t.get(l,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,n.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,n.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),i.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var PA={[bf]:"LINEAR_TONE_MAPPING",[wf]:"REINHARD_TONE_MAPPING",[Mf]:"CINEON_TONE_MAPPING",[Sf]:"ACES_FILMIC_TONE_MAPPING",[Tf]:"AGX_TONE_MAPPING",[Af]:"NEUTRAL_TONE_MAPPING",[Ef]:"CUSTOM_TONE_MAPPING"};function LA(n,t,e,i,s,r){let o=new Dn(t,e,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new wn;h.setAttribute("position",new Re([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new Re([0,2,0,0,2,0],2));let u=new Rl({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),d=new Ue(h,u),f=new da(-1,1,1,-1,0,1),p=null,m=null,g=!1,x,_=null,b=[],M=!1;this.setSize=function(T,E){o.setSize(T,E),a!==null&&a.setSize(T,E),c!==null&&c.setSize(T,E);for(let y=0;y<b.length;y++){let S=b[y];S.setSize&&S.setSize(T,E)}},this.setEffects=function(T){b=T,M=b.length>0&&b[0].isRenderPass===!0;let E=o.width,y=o.height;b.length>0&&a===null&&(a=new Dn(E,y,{type:li,depthBuffer:!1,stencilBuffer:!1}),c=new Dn(E,y,{type:li,depthBuffer:!1,stencilBuffer:!1}));let S=s===!0&&b.some(D=>D.needsDepthTexture===!0);S!==(o.depthTexture!==null)&&(S===!0&&l===null&&(l=new Xi(E,y),r===!0&&(l.format=Yi,l.type=rr)),o.dispose(),o.depthTexture=S?l:null,o.resolveDepthBuffer=S,o.storeMultisampledDepthBuffer=S);for(let D=0;D<b.length;D++){let L=b[D];L.setSize&&L.setSize(E,y),S&&L.needsDepthTexture===!0&&L.setDepthTexture&&L.setDepthTexture(l)}},this.begin=function(T,E){if(g||T.toneMapping===Ei&&b.length===0)return!1;if(_=E,E!==null){let y=E.width,S=E.height;(o.width!==y||o.height!==S)&&this.setSize(y,S)}return M===!1&&T.setRenderTarget(o),x=T.toneMapping,T.toneMapping=Ei,!0},this.hasRenderPass=function(){return M},this.end=function(T,E){T.toneMapping=x,g=!0;let y=o,S=a;for(let D=0;D<b.length;D++){let L=b[D];L.enabled!==!1&&(L.render(T,S,y,E),L.needsSwap!==!1&&(y=S,S=S===a?c:a))}if(p!==T.outputColorSpace||m!==T.toneMapping){p=T.outputColorSpace,m=T.toneMapping,u.defines={},re.getTransfer(p)===ue&&(u.defines.SRGB_TRANSFER="");let D=PA[m];D&&(u.defines[D]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=y.texture,T.setRenderTarget(_),T.render(d,f),_=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var Vx=new bn,Hx=new Xi(1,1),Wx=new ta(1),$x=new $o,qx=new gl,Xx=new Qo,bx=[],wx=[],Mx=new Float32Array(16),Sx=new Float32Array(9),Ex=new Float32Array(4);function io(n,t,e){let i=n[0];if(i<=0||i>0)return n;let s=t*e,r=bx[s];if(r===void 0&&(r=new Float32Array(s),bx[s]=r),t!==0){i.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,n[o].toArray(r,a)}return r}function Be(n,t){if(n.length!==t.length)return!1;for(let e=0,i=n.length;e<i;e++)if(n[e]!==t[e])return!1;return!0}function ze(n,t){for(let e=0,i=t.length;e<i;e++)n[e]=t[e]}function Dh(n,t){let e=wx[t];e===void 0&&(e=new Int32Array(t),wx[t]=e);for(let i=0;i!==t;++i)e[i]=n.allocateTextureUnit();return e}function NA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1f(this.addr,t),e[0]=t)}function DA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;n.uniform2fv(this.addr,t),ze(e,t)}}function OA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(n.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Be(e,t))return;n.uniform3fv(this.addr,t),ze(e,t)}}function UA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;n.uniform4fv(this.addr,t),ze(e,t)}}function FA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;n.uniformMatrix2fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;Ex.set(i),n.uniformMatrix2fv(this.addr,!1,Ex),ze(e,i)}}function kA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;n.uniformMatrix3fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;Sx.set(i),n.uniformMatrix3fv(this.addr,!1,Sx),ze(e,i)}}function BA(n,t){let e=this.cache,i=t.elements;if(i===void 0){if(Be(e,t))return;n.uniformMatrix4fv(this.addr,!1,t),ze(e,t)}else{if(Be(e,i))return;Mx.set(i),n.uniformMatrix4fv(this.addr,!1,Mx),ze(e,i)}}function zA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1i(this.addr,t),e[0]=t)}function GA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;n.uniform2iv(this.addr,t),ze(e,t)}}function VA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Be(e,t))return;n.uniform3iv(this.addr,t),ze(e,t)}}function HA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;n.uniform4iv(this.addr,t),ze(e,t)}}function WA(n,t){let e=this.cache;e[0]!==t&&(n.uniform1ui(this.addr,t),e[0]=t)}function $A(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(n.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Be(e,t))return;n.uniform2uiv(this.addr,t),ze(e,t)}}function qA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(n.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Be(e,t))return;n.uniform3uiv(this.addr,t),ze(e,t)}}function XA(n,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(n.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Be(e,t))return;n.uniform4uiv(this.addr,t),ze(e,t)}}function Oh(n){return n.version===0&&(n.compareFunction=Ff,n.needsUpdate=!0),n}function jA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Oh(Hx):r=Vx,e.setTexture2D(t||r,s)}function YA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture3D(t||qx,s)}function JA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Oh(Wx):r=Xx,e.setTextureCube(t||r,s)}function ZA(n,t,e){let i=this.cache,s=e.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),e.setTexture2DArray(t||$x,s)}function KA(n){switch(n){case 5126:return NA;case 35664:return DA;case 35665:return OA;case 35666:return UA;case 35674:return FA;case 35675:return kA;case 35676:return BA;case 5124:case 35670:return zA;case 35667:case 35671:return GA;case 35668:case 35672:return VA;case 35669:case 35673:return HA;case 5125:return WA;case 36294:return $A;case 36295:return qA;case 36296:return XA;case 35678:case 36198:case 36298:case 36306:case 35682:return jA;case 35679:case 36299:case 36307:return YA;case 35680:case 36300:case 36308:case 36293:return JA;case 36289:case 36303:case 36311:case 36292:return ZA}}function QA(n,t){n.uniform1fv(this.addr,t)}function tR(n,t){let e=io(t,this.size,2);n.uniform2fv(this.addr,e)}function eR(n,t){let e=io(t,this.size,3);n.uniform3fv(this.addr,e)}function nR(n,t){let e=io(t,this.size,4);n.uniform4fv(this.addr,e)}function iR(n,t){let e=io(t,this.size,4);n.uniformMatrix2fv(this.addr,!1,e)}function sR(n,t){let e=io(t,this.size,9);n.uniformMatrix3fv(this.addr,!1,e)}function rR(n,t){let e=io(t,this.size,16);n.uniformMatrix4fv(this.addr,!1,e)}function oR(n,t){n.uniform1iv(this.addr,t)}function aR(n,t){n.uniform2iv(this.addr,t)}function cR(n,t){n.uniform3iv(this.addr,t)}function lR(n,t){n.uniform4iv(this.addr,t)}function hR(n,t){n.uniform1uiv(this.addr,t)}function uR(n,t){n.uniform2uiv(this.addr,t)}function dR(n,t){n.uniform3uiv(this.addr,t)}function fR(n,t){n.uniform4uiv(this.addr,t)}function pR(n,t,e){let i=this.cache,s=t.length,r=Dh(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Oh(Hx):o=Vx;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function mR(n,t,e){let i=this.cache,s=t.length,r=Dh(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||qx,r[o])}function gR(n,t,e){let i=this.cache,s=t.length,r=Dh(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Oh(Wx):o=Xx;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function xR(n,t,e){let i=this.cache,s=t.length,r=Dh(e,s);Be(i,r)||(n.uniform1iv(this.addr,r),ze(i,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||$x,r[o])}function _R(n){switch(n){case 5126:return QA;case 35664:return tR;case 35665:return eR;case 35666:return nR;case 35674:return iR;case 35675:return sR;case 35676:return rR;case 5124:case 35670:return oR;case 35667:case 35671:return aR;case 35668:case 35672:return cR;case 35669:case 35673:return lR;case 5125:return hR;case 36294:return uR;case 36295:return dR;case 36296:return fR;case 35678:case 36198:case 36298:case 36306:case 35682:return pR;case 35679:case 36299:case 36307:return mR;case 35680:case 36300:case 36308:case 36293:return gR;case 36289:case 36303:case 36311:case 36292:return xR}}var Kf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.setValue=KA(e.type)}},Qf=class{constructor(t,e,i){this.id=t,this.addr=i,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=_R(e.type)}},tp=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],i)}}},Jf=/(\w+)(\])?(\[|\.)?/g;function Tx(n,t){n.seq.push(t),n.map[t.id]=t}function yR(n,t,e){let i=n.name,s=i.length;for(Jf.lastIndex=0;;){let r=Jf.exec(i),o=Jf.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){Tx(e,l===void 0?new Kf(a,n,t):new Qf(a,n,t));break}else{let u=e.map[a];u===void 0&&(u=new tp(a),Tx(e,u)),e=u}}}var no=class{constructor(t,e){this.seq=[],this.map={};let i=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);yR(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,i,s){let r=this.map[e];r!==void 0&&r.setValue(t,i,s)}setOptional(t,e,i){let s=e[i];s!==void 0&&this.setValue(t,i,s)}static upload(t,e,i,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=i[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let i=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&i.push(o)}return i}};function Ax(n,t,e){let i=n.createShader(t);return n.shaderSource(i,e),n.compileShader(i),i}var vR=37297,bR=0;function wR(n,t){let e=n.split(`
`),i=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return i.join(`
`)}var Rx=new qt;function MR(n){re._getMatrix(Rx,re.workingColorSpace,n);let t=`mat3( ${Rx.elements.map(e=>e.toFixed(4))} )`;switch(re.getTransfer(n)){case Ho:return[t,"LinearTransferOETF"];case ue:return[t,"sRGBTransferOETF"];default:return Bt("WebGLProgram: Unsupported color space: ",n),[t,"LinearTransferOETF"]}}function Cx(n,t,e){let i=n.getShaderParameter(t,n.COMPILE_STATUS),r=(n.getShaderInfoLog(t)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+wR(n.getShaderSource(t),a)}else return r}function SR(n,t){let e=MR(t);return[`vec4 ${n}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var ER={[bf]:"Linear",[wf]:"Reinhard",[Mf]:"Cineon",[Sf]:"ACESFilmic",[Tf]:"AgX",[Af]:"Neutral",[Ef]:"Custom"};function TR(n,t){let e=ER[t];return e===void 0?(Bt("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var Ph=new P;function AR(){re.getLuminanceCoefficients(Ph);let n=Ph.x.toFixed(4),t=Ph.y.toFixed(4),e=Ph.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function RR(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Sa).join(`
`)}function CR(n){let t=[];for(let e in n){let i=n[e];i!==!1&&t.push("#define "+e+" "+i)}return t.join(`
`)}function IR(n,t){let e={},i=n.getProgramParameter(t,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(t,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:n.getAttribLocation(t,o),locationSize:a}}return e}function Sa(n){return n!==""}function Ix(n,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function Px(n,t){return n.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var PR=/^[ \t]*#include +<([\w\d./]+)>/gm;function ep(n){return n.replace(PR,LR)}function LR(n,t){let e=te[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return ep(e)}var NR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Lx(n){return n.replace(NR,DR)}function DR(n,t,e,i){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Nx(n){let t=`precision ${n.precision} float;
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
#define LOW_PRECISION`),t}var OR={[er]:"SHADOWMAP_TYPE_PCF",[Zr]:"SHADOWMAP_TYPE_VSM"};function UR(n){return OR[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var FR={[Qr]:"ENVMAP_MODE_REFRACTION"};function kR(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":FR[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var BR={[vf]:"ENVMAP_BLENDING_MULTIPLY",[Y0]:"ENVMAP_BLENDING_MIX",[J0]:"ENVMAP_BLENDING_ADD"};function zR(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":BR[n.combine]||"ENVMAP_BLENDING_NONE"}function GR(n,t,e,i){let s=n.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=UR(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=kR(e),u=zR(e),d=RR(e),f=CR(r),p=s.createProgram(),m,g,x=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Sa).join(`
`),m.length>0&&(m+=`
`),g=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Sa).join(`
`),g.length>0&&(g+=`
`)):(m=[Nx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Sa).join(`
`),g=[Nx(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==Ei?"#define TONE_MAPPING":"",e.toneMapping!==Ei?te.tonemapping_pars_fragment:"",e.toneMapping!==Ei?TR("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",te.colorspace_pars_fragment,SR("linearToOutputTexel",e.outputColorSpace),AR(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Sa).join(`
`)),o=ep(o),o=Ix(o,e),o=Px(o,e),a=ep(a),a=Ix(a,e),a=Px(a,e),o=Lx(o),a=Lx(a),e.isRawShaderMaterial!==!0&&(x=`#version 300 es
`,m=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+m,g=["#define varying in",e.glslVersion===Bf?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===Bf?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let _=x+m+o,b=x+g+a,M=Ax(s,s.VERTEX_SHADER,_),T=Ax(s,s.FRAGMENT_SHADER,b);s.attachShader(p,M),s.attachShader(p,T),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(L){if(n.debug.checkShaderErrors){let U=s.getProgramInfoLog(p)||"",k=s.getShaderInfoLog(M)||"",G=s.getShaderInfoLog(T)||"",I=U.trim(),H=k.trim(),X=G.trim(),W=!0,st=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(W=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,M,T);else{let q=Cx(s,M,"vertex"),Q=Cx(s,T,"fragment");Wt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+L.name+`
Material Type: `+L.type+`

Program Info Log: `+I+`
`+q+`
`+Q)}else I!==""?Bt("WebGLProgram: Program Info Log:",I):(H===""||X==="")&&(st=!1);st&&(L.diagnostics={runnable:W,programLog:I,vertexShader:{log:H,prefix:m},fragmentShader:{log:X,prefix:g}})}s.deleteShader(M),s.deleteShader(T),y=new no(s,p),S=IR(s,p)}let y;this.getUniforms=function(){return y===void 0&&E(this),y};let S;this.getAttributes=function(){return S===void 0&&E(this),S};let D=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return D===!1&&(D=s.getProgramParameter(p,vR)),D},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=bR++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=M,this.fragmentShader=T,this}var VR=0,np=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,i){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let i of e)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,i=e.get(t);return i===void 0&&(i=new Set,e.set(t,i)),i}_getShaderStage(t){let e=this.shaderCache,i=e.get(t);return i===void 0&&(i=new ip(t),e.set(t,i)),i}},ip=class{constructor(t){this.id=VR++,this.code=t,this.usedTimes=0}};function HR(n){return n===bs||n===ba||n===wa}function WR(n,t,e,i,s,r){let o=new $r,a=new np,c=new Set,l=[],h=new Map,u=i.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return c.add(y),y===0?"uv":`uv${y}`}function p(y,S,D,L,U,k){let G=L.fog,I=U.geometry,H=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?L.environment:null,X=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,W=t.get(y.envMap||H,X),st=d[y.type],q=i.precision;y.precision!==null&&(q=i.getMaxPrecision(y.precision),q!==y.precision&&Bt("WebGLProgram.getParameters:",y.precision,"not supported, using",q,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,tt=Q!==void 0?Q.length:0,Pt=0;I.morphAttributes.position!==void 0&&(Pt=1),I.morphAttributes.normal!==void 0&&(Pt=2),I.morphAttributes.color!==void 0&&(Pt=3);let jt,J,vt,Tt;if(st){let _t=Ai[st];jt=_t.vertexShader,J=_t.fragmentShader}else{jt=y.vertexShader,J=y.fragmentShader;let _t=a.getVertexShaderStage(y),pe=a.getFragmentShaderStage(y);a.update(y,_t,pe),vt=_t.id,Tt=pe.id}let zt=n.getRenderTarget(),bt=n.state.buffers.depth.getReversed(),Jt=U.isInstancedMesh===!0,Ne=U.isBatchedMesh===!0,Vt=!!y.map,fe=!!y.matcap,me=!!W,ne=me&&W.isPMREMTexture===!0,je=!!y.aoMap,Fe=!!y.lightMap,_n=!!y.bumpMap&&y.wireframe===!1,Se=!!y.normalMap,pi=!!y.displacementMap,Ve=!!y.emissiveMap,Bn=!!y.metalnessMap,zn=!!y.roughnessMap,Gn=y.anisotropy>0,O=y.clearcoat>0,Vn=y.diffuseRoughness>0,ye=y.dispersion>0,ve=y.retroreflectivity>0,gt=y.iridescence>0,ke=y.sheen>0,Gt=y.transmission>0,Xt=Gn&&!!y.anisotropyMap,A=O&&!!y.clearcoatMap,v=O&&!!y.clearcoatNormalMap,B=O&&!!y.clearcoatRoughnessMap,it=Vn&&!!y.diffuseRoughnessMap,K=gt&&!!y.iridescenceMap,lt=gt&&!!y.iridescenceThicknessMap,pt=ke&&!!y.sheenColorMap,j=ke&&!!y.sheenRoughnessMap,Y=!!y.specularMap,ut=!!y.specularColorMap,C=!!y.specularIntensityMap,Z=Gt&&!!y.transmissionMap,$=Gt&&!!y.thicknessMap,dt=!!y.gradientMap,ct=!!y.alphaMap,ht=y.alphaTest>0,Ut=!!y.alphaHash,Kt=!!y.extensions,rt=Ei;y.toneMapped&&(zt===null||zt.isXRRenderTarget===!0)&&(rt=n.toneMapping);let Ft=ne?W.isCompressedCubeTexture?W.image[0].mipmaps:W.mipmaps:null,Zt={shaderID:st,shaderType:y.type,shaderName:y.name,vertexShader:jt,fragmentShader:J,defines:y.defines,customVertexShaderID:vt,customFragmentShaderID:Tt,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:q,batching:Ne,batchingColor:Ne&&U._colorsTexture!==null,instancing:Jt,instancingColor:Jt&&U.instanceColor!==null,instancingMorph:Jt&&U.morphTexture!==null,outputColorSpace:zt===null?n.outputColorSpace:zt.isXRRenderTarget===!0?zt.texture.colorSpace:re.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Vt,matcap:fe,envMap:me,envMapMode:me&&W.mapping,envMapPMREM:ne,envMapMaxLod:ne?Ft.length-1:null,envMapSize:ne?Ft[0].width:null,aoMap:je,lightMap:Fe,bumpMap:_n,normalMap:Se,displacementMap:pi,emissiveMap:Ve,normalMapObjectSpace:Se&&y.normalMapType===Q0,normalMapTangentSpace:Se&&y.normalMapType===Ch,packedNormalMap:Se&&y.normalMapType===Ch&&HR(y.normalMap.format),metalnessMap:Bn,roughnessMap:zn,anisotropy:Gn,anisotropyMap:Xt,clearcoat:O,clearcoatMap:A,clearcoatNormalMap:v,clearcoatRoughnessMap:B,diffuseRoughness:Vn,diffuseRoughnessMap:it,dispersion:ye,retroreflection:ve,iridescence:gt,iridescenceMap:K,iridescenceThicknessMap:lt,sheen:ke,sheenColorMap:pt,sheenRoughnessMap:j,specularMap:Y,specularColorMap:ut,specularIntensityMap:C,transmission:Gt,transmissionMap:Z,thicknessMap:$,gradientMap:dt,opaque:y.transparent===!1&&y.blending===Kr&&y.alphaToCoverage===!1,alphaMap:ct,alphaTest:ht,alphaHash:Ut,combine:y.combine,mapUv:Vt&&f(y.map.channel),aoMapUv:je&&f(y.aoMap.channel),lightMapUv:Fe&&f(y.lightMap.channel),bumpMapUv:_n&&f(y.bumpMap.channel),normalMapUv:Se&&f(y.normalMap.channel),displacementMapUv:pi&&f(y.displacementMap.channel),emissiveMapUv:Ve&&f(y.emissiveMap.channel),metalnessMapUv:Bn&&f(y.metalnessMap.channel),roughnessMapUv:zn&&f(y.roughnessMap.channel),anisotropyMapUv:Xt&&f(y.anisotropyMap.channel),clearcoatMapUv:A&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:v&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:B&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:it&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:K&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:lt&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:pt&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:j&&f(y.sheenRoughnessMap.channel),specularMapUv:Y&&f(y.specularMap.channel),specularColorMapUv:ut&&f(y.specularColorMap.channel),specularIntensityMapUv:C&&f(y.specularIntensityMap.channel),transmissionMapUv:Z&&f(y.transmissionMap.channel),thicknessMapUv:$&&f(y.thicknessMap.channel),alphaMapUv:ct&&f(y.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Se||Gn),vertexNormals:!!I.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:U.isPoints===!0&&!!I.attributes.uv&&(Vt||ct),fog:!!G,useFog:y.fog===!0,fogExp2:!!G&&G.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||I.attributes.normal===void 0&&Se===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:bt,skinning:U.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:Pt,numSunLights:S.sun.length,numDirLights:S.directional.length,numPointLights:S.point.length,numSpotLights:S.spot.length,numSpotLightMaps:S.spotLightMap.length,numRectAreaLights:S.rectArea.length,numHemiLights:S.hemi.length,numSunLightShadows:S.sunShadowMap.length,numDirLightShadows:S.directionalShadowMap.length,numPointLightShadows:S.pointShadowMap.length,numSpotLightShadows:S.spotShadowMap.length,numSpotLightShadowsWithMaps:S.numSpotLightShadowsWithMaps,numLightProbes:S.numLightProbes,numLightProbeGrids:k.filter(_t=>_t.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&D.length>0,shadowMapType:n.shadowMap.type,toneMapping:rt,decodeVideoTexture:Vt&&y.map.isVideoTexture===!0&&re.getTransfer(y.map.colorSpace)===ue,decodeVideoTextureEmissive:Ve&&y.emissiveMap.isVideoTexture===!0&&re.getTransfer(y.emissiveMap.colorSpace)===ue,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Mn,flipSided:y.side===gn,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:Kt&&y.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(Kt&&y.extensions.multiDraw===!0||Ne)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return Zt.vertexUv1s=c.has(1),Zt.vertexUv2s=c.has(2),Zt.vertexUv3s=c.has(3),c.clear(),Zt}function m(y){let S=[];if(y.shaderID?S.push(y.shaderID):(S.push(y.customVertexShaderID),S.push(y.customFragmentShaderID)),y.defines!==void 0)for(let D in y.defines)S.push(D),S.push(y.defines[D]);return y.isRawShaderMaterial===!1&&(g(S,y),x(S,y),S.push(n.outputColorSpace)),S.push(y.customProgramCacheKey),S.join()}function g(y,S){y.push(S.precision),y.push(S.outputColorSpace),y.push(S.envMapMode),y.push(S.envMapPMREM),y.push(S.envMapMaxLod),y.push(S.envMapSize),y.push(S.mapUv),y.push(S.alphaMapUv),y.push(S.lightMapUv),y.push(S.aoMapUv),y.push(S.bumpMapUv),y.push(S.normalMapUv),y.push(S.displacementMapUv),y.push(S.emissiveMapUv),y.push(S.metalnessMapUv),y.push(S.roughnessMapUv),y.push(S.anisotropyMapUv),y.push(S.clearcoatMapUv),y.push(S.clearcoatNormalMapUv),y.push(S.clearcoatRoughnessMapUv),y.push(S.diffuseRoughnessMapUv),y.push(S.iridescenceMapUv),y.push(S.iridescenceThicknessMapUv),y.push(S.sheenColorMapUv),y.push(S.sheenRoughnessMapUv),y.push(S.specularMapUv),y.push(S.specularColorMapUv),y.push(S.specularIntensityMapUv),y.push(S.transmissionMapUv),y.push(S.thicknessMapUv),y.push(S.combine),y.push(S.fogExp2),y.push(S.sizeAttenuation),y.push(S.morphTargetsCount),y.push(S.numSunLights),y.push(S.numDirLights),y.push(S.numPointLights),y.push(S.numSpotLights),y.push(S.numSpotLightMaps),y.push(S.numHemiLights),y.push(S.numRectAreaLights),y.push(S.numSunLightShadows),y.push(S.numDirLightShadows),y.push(S.numPointLightShadows),y.push(S.numSpotLightShadows),y.push(S.numSpotLightShadowsWithMaps),y.push(S.numLightProbes),y.push(S.numLightProbeGrids),y.push(S.shadowMapType),y.push(S.toneMapping),y.push(S.numClippingPlanes),y.push(S.numClipIntersection),y.push(S.depthPacking)}function x(y,S){o.disableAll(),S.instancing&&o.enable(0),S.instancingColor&&o.enable(1),S.instancingMorph&&o.enable(2),S.matcap&&o.enable(3),S.envMap&&o.enable(4),S.normalMapObjectSpace&&o.enable(5),S.normalMapTangentSpace&&o.enable(6),S.clearcoat&&o.enable(7),S.iridescence&&o.enable(8),S.alphaTest&&o.enable(9),S.vertexColors&&o.enable(10),S.vertexAlphas&&o.enable(11),S.vertexUv1s&&o.enable(12),S.vertexUv2s&&o.enable(13),S.vertexUv3s&&o.enable(14),S.vertexTangents&&o.enable(15),S.anisotropy&&o.enable(16),S.alphaHash&&o.enable(17),S.batching&&o.enable(18),S.dispersion&&o.enable(19),S.retroreflection&&o.enable(24),S.diffuseRoughness&&o.enable(25),S.batchingColor&&o.enable(20),S.gradientMap&&o.enable(21),S.packedNormalMap&&o.enable(22),S.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),S.fog&&o.enable(0),S.useFog&&o.enable(1),S.flatShading&&o.enable(2),S.logarithmicDepthBuffer&&o.enable(3),S.reversedDepthBuffer&&o.enable(4),S.skinning&&o.enable(5),S.morphTargets&&o.enable(6),S.morphNormals&&o.enable(7),S.morphColors&&o.enable(8),S.premultipliedAlpha&&o.enable(9),S.shadowMapEnabled&&o.enable(10),S.doubleSided&&o.enable(11),S.flipSided&&o.enable(12),S.useDepthPacking&&o.enable(13),S.dithering&&o.enable(14),S.transmission&&o.enable(15),S.sheen&&o.enable(16),S.opaque&&o.enable(17),S.pointsUvs&&o.enable(18),S.decodeVideoTexture&&o.enable(19),S.decodeVideoTextureEmissive&&o.enable(20),S.alphaToCoverage&&o.enable(21),S.numLightProbeGrids>0&&o.enable(22),S.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function _(y){let S=d[y.type],D;if(S){let L=Ai[S];D=px.clone(L.uniforms)}else D=y.uniforms;return D}function b(y,S){let D=h.get(S);return D!==void 0?++D.usedTimes:(D=new GR(n,S,y,s),l.push(D),h.set(S,D)),D}function M(y){if(--y.usedTimes===0){let S=l.indexOf(y);l[S]=l[l.length-1],l.pop(),h.delete(y.cacheKey),y.destroy()}}function T(y){a.remove(y)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:m,getUniforms:_,acquireProgram:b,releaseProgram:M,releaseShaderCache:T,programs:l,dispose:E}}function $R(){let n=new WeakMap;function t(o){return n.has(o)}function e(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,c){n.get(o)[a]=c}function r(){n=new WeakMap}return{has:t,get:e,remove:i,update:s,dispose:r}}function qR(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.material.id!==t.material.id?n.material.id-t.material.id:n.materialVariant!==t.materialVariant?n.materialVariant-t.materialVariant:n.z!==t.z?n.z-t.z:n.id-t.id}function Dx(n,t){return n.groupOrder!==t.groupOrder?n.groupOrder-t.groupOrder:n.renderOrder!==t.renderOrder?n.renderOrder-t.renderOrder:n.z!==t.z?t.z-n.z:n.id-t.id}function Ox(){let n=[],t=0,e=[],i=[],s=[];function r(){t=0,e.length=0,i.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,m,g,x){let _=n[t];return _===void 0?(_={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:m,renderOrder:d.renderOrder,z:g,group:x},n[t]=_):(_.id=d.id,_.object=d,_.geometry=f,_.material=p,_.materialVariant=o(d),_.groupOrder=m,_.renderOrder=d.renderOrder,_.z=g,_.group=x),t++,_}function c(d,f,p,m,g,x,_){_.reversedDepth===!0&&(g=-g);let b=a(d,f,p,m,g,x);p.transmission>0?i.push(b):p.transparent===!0?s.push(b):e.push(b)}function l(d,f,p,m,g,x){let _=a(d,f,p,m,g,x);p.transmission>0?i.unshift(_):p.transparent===!0?s.unshift(_):e.unshift(_)}function h(d,f){e.length>1&&e.sort(d||qR),i.length>1&&i.sort(f||Dx),s.length>1&&s.sort(f||Dx)}function u(){for(let d=t,f=n.length;d<f;d++){let p=n[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:i,transparent:s,init:r,push:c,unshift:l,finish:u,sort:h}}function XR(){let n=new WeakMap;function t(i,s){let r=n.get(i),o;return r===void 0?(o=new Ox,n.set(i,[o])):s>=r.length?(o=new Ox,r.push(o)):o=r[s],o}function e(){n=new WeakMap}return{get:t,dispose:e}}function jR(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new P,color:new $t};break;case"SpotLight":e={position:new P,direction:new P,color:new $t,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new P,color:new $t,distance:0,decay:0};break;case"HemisphereLight":e={direction:new P,skyColor:new $t,groundColor:new $t};break;case"RectAreaLight":e={color:new $t,position:new P,halfWidth:new P,halfHeight:new P};break}return n[t.id]=e,e}}}function YR(){let n={};return{get:function(t){if(n[t.id]!==void 0)return n[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new St};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new St};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new St,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[t.id]=e,e}}}var JR=0;function ZR(n,t){return(t.castShadow?2:0)-(n.castShadow?2:0)+(t.map?1:0)-(n.map?1:0)}function KR(n){let t=new jR,e=YR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)i.probe.push(new P);let s=new P,r=new ce,o=new ce;function a(l){let h=0,u=0,d=0;for(let k=0;k<9;k++)i.probe[k].set(0,0,0);let f=0,p=0,m=0,g=0,x=0,_=0,b=0,M=0,T=0,E=0,y=0,S=0,D=0,L=0;l.sort(ZR);for(let k=0,G=l.length;k<G;k++){let I=l[k],H=I.color,X=I.intensity,W=I.distance,st=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===bs?st=I.shadow.map.texture:st=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)h+=H.r*X,u+=H.g*X,d+=H.b*X;else if(I.isLightProbe){for(let q=0;q<9;q++)i.probe[q].addScaledVector(I.sh.coefficients[q],X);L++}else if(I.isSunLight){let q=t.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,tt=e.get(I);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=tt,i.sunShadowMap[p]=st;let Pt=Q.getViewportCount();for(let jt=0;jt<Pt;jt++)i.sunShadowMatrix[m+jt]=Q.getMatrix(jt),i.sunShadowCascade[m+jt]=Q._cascadeData[jt];m+=Pt,p++}i.sun[f]=q,f++}else if(I.isDirectionalLight){let q=t.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,tt=e.get(I);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.directionalShadow[g]=tt,i.directionalShadowMap[g]=st,i.directionalShadowMatrix[g]=I.shadow.matrix,T++}i.directional[g]=q,g++}else if(I.isSpotLight){let q=t.get(I);q.position.setFromMatrixPosition(I.matrixWorld),q.color.copy(H).multiplyScalar(X),q.distance=W,q.coneCos=Math.cos(I.angle),q.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),q.decay=I.decay,i.spot[_]=q;let Q=I.shadow;if(I.map&&(i.spotLightMap[S]=I.map,S++,Q.updateMatrices(I),I.castShadow&&D++),i.spotLightMatrix[_]=Q.matrix,I.castShadow){let tt=e.get(I);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,i.spotShadow[_]=tt,i.spotShadowMap[_]=st,y++}_++}else if(I.isRectAreaLight){let q=t.get(I);q.color.copy(H).multiplyScalar(X),q.halfWidth.set(I.width*.5,0,0),q.halfHeight.set(0,I.height*.5,0),i.rectArea[b]=q,b++}else if(I.isPointLight){let q=t.get(I);if(q.color.copy(I.color).multiplyScalar(I.intensity),q.distance=I.distance,q.decay=I.decay,I.castShadow){let Q=I.shadow,tt=e.get(I);tt.shadowIntensity=Q.intensity,tt.shadowBias=Q.bias,tt.shadowNormalBias=Q.normalBias,tt.shadowRadius=Q.radius,tt.shadowMapSize=Q.mapSize,tt.shadowCameraNear=Q.camera.near,tt.shadowCameraFar=Q.camera.far,i.pointShadow[x]=tt,i.pointShadowMap[x]=st,i.pointShadowMatrix[x]=I.shadow.matrix,E++}i.point[x]=q,x++}else if(I.isHemisphereLight){let q=t.get(I);q.skyColor.copy(I.color).multiplyScalar(X),q.groundColor.copy(I.groundColor).multiplyScalar(X),i.hemi[M]=q,M++}}b>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=yt.LTC_FLOAT_1,i.rectAreaLTC2=yt.LTC_FLOAT_2):(i.rectAreaLTC1=yt.LTC_HALF_1,i.rectAreaLTC2=yt.LTC_HALF_2)),i.ambient[0]=h,i.ambient[1]=u,i.ambient[2]=d;let U=i.hash;(U.sunLength!==f||U.directionalLength!==g||U.pointLength!==x||U.spotLength!==_||U.rectAreaLength!==b||U.hemiLength!==M||U.numSunShadows!==p||U.numDirectionalShadows!==T||U.numPointShadows!==E||U.numSpotShadows!==y||U.numSpotMaps!==S||U.numLightProbes!==L)&&(i.sun.length=f,i.directional.length=g,i.spot.length=_,i.rectArea.length=b,i.point.length=x,i.hemi.length=M,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=m,i.sunShadowCascade.length=m,i.directionalShadow.length=T,i.directionalShadowMap.length=T,i.directionalShadowMatrix.length=T,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+S-D,i.spotLightMap.length=S,i.numSpotLightShadowsWithMaps=D,i.numLightProbes=L,U.sunLength=f,U.directionalLength=g,U.pointLength=x,U.spotLength=_,U.rectAreaLength=b,U.hemiLength=M,U.numSunShadows=p,U.numDirectionalShadows=T,U.numPointShadows=E,U.numSpotShadows=y,U.numSpotMaps=S,U.numLightProbes=L,i.version=JR++)}function c(l,h){let u=0,d=0,f=0,p=0,m=0,g=0,x=h.matrixWorldInverse;for(let _=0,b=l.length;_<b;_++){let M=l[_];if(M.isSunLight){let T=i.sun[u];T.direction.setFromMatrixPosition(M.matrixWorld),T.direction.transformDirection(x),u++}else if(M.isDirectionalLight){let T=i.directional[d];T.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(x),d++}else if(M.isSpotLight){let T=i.spot[p];T.position.setFromMatrixPosition(M.matrixWorld),T.position.applyMatrix4(x),T.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),T.direction.sub(s),T.direction.transformDirection(x),p++}else if(M.isRectAreaLight){let T=i.rectArea[m];T.position.setFromMatrixPosition(M.matrixWorld),T.position.applyMatrix4(x),o.identity(),r.copy(M.matrixWorld),r.premultiply(x),o.extractRotation(r),T.halfWidth.set(M.width*.5,0,0),T.halfHeight.set(0,M.height*.5,0),T.halfWidth.applyMatrix4(o),T.halfHeight.applyMatrix4(o),m++}else if(M.isPointLight){let T=i.point[f];T.position.setFromMatrixPosition(M.matrixWorld),T.position.applyMatrix4(x),f++}else if(M.isHemisphereLight){let T=i.hemi[g];T.direction.setFromMatrixPosition(M.matrixWorld),T.direction.transformDirection(x),g++}}}return{setup:a,setupView:c,state:i}}function Ux(n){let t=new KR(n),e=[],i=[],s=[];function r(u){h.camera=u,e.length=0,i.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){i.push(u)}function c(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function QR(n){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new Ux(n),t.set(s,[a])):r>=o.length?(a=new Ux(n),o.push(a)):a=o[r],a}function i(){t=new WeakMap}return{get:e,dispose:i}}var tC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,eC=`uniform sampler2D shadow_pass;
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
}`,nC=[new P(1,0,0),new P(-1,0,0),new P(0,1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1)],iC=[new P(0,-1,0),new P(0,-1,0),new P(0,0,1),new P(0,0,-1),new P(0,-1,0),new P(0,-1,0)],Fx=new ce,Ma=new P,Zf=new P;function sC(n,t,e){let i=new fs,s=new St,r=new St,o=new be,a=new Cl,c=new Il,l={},h=e.maxTextureSize,u={[vs]:gn,[gn]:vs,[Mn]:Mn},d=new jn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new St},radius:{value:4}},vertexShader:tC,fragmentShader:eC}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new wn;p.setAttribute("position",new oi(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let m=new Ue(p,d),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=er;let x=this.type;this.render=function(E,y,S){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||E.length===0)return;this.type===I0&&(Bt("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=er);let D=n.getRenderTarget(),L=n.getActiveCubeFace(),U=n.getActiveMipmapLevel(),k=n.state;k.setBlending(nr),k.buffers.depth.getReversed()===!0?k.buffers.color.setClear(0,0,0,0):k.buffers.color.setClear(1,1,1,1),k.buffers.depth.setTest(!0),k.setScissorTest(!1);let G=x!==this.type;G&&y.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(H=>H.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,H=E.length;I<H;I++){let X=E[I],W=X.shadow;if(W===void 0){Bt("WebGLShadowMap:",X,"has no shadow.");continue}if(W.autoUpdate===!1&&W.needsUpdate===!1)continue;s.copy(W.mapSize);let st=W.getFrameExtents();s.multiply(st),r.copy(W.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/st.x),s.x=r.x*st.x,W.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/st.y),s.y=r.y*st.y,W.mapSize.y=r.y));let q=n.state.buffers.depth.getReversed();if(W.camera._reversedDepth=q,W.map===null||G===!0){if(W.map!==null&&(W.map.depthTexture!==null&&(W.map.depthTexture.dispose(),W.map.depthTexture=null),W.map.dispose()),this.type===Zr){if(X.isPointLight){Bt("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}W.map=new Dn(s.x,s.y,{format:bs,type:li,minFilter:pn,magFilter:pn,generateMipmaps:!1}),W.map.texture.name=X.name+".shadowMap",W.map.depthTexture=new Xi(s.x,s.y,Yn),W.map.depthTexture.name=X.name+".shadowMapDepth",W.map.depthTexture.format=Wi,W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=qe,W.map.depthTexture.magFilter=qe}else X.isPointLight?(W.map=new Ea(s.x),W.map.depthTexture=new ta(s.x,ci)):(W.map=new Dn(s.x,s.y),W.map.depthTexture=new Xi(s.x,s.y,ci)),W.map.depthTexture.name=X.name+".shadowMap",W.map.depthTexture.format=Wi,this.type===er?(W.map.depthTexture.compareFunction=q?Uf:Of,W.map.depthTexture.minFilter=pn,W.map.depthTexture.magFilter=pn):(W.map.depthTexture.compareFunction=null,W.map.depthTexture.minFilter=qe,W.map.depthTexture.magFilter=qe);W.camera.updateProjectionMatrix()}W.map.isWebGLCubeRenderTarget!==!0&&(W.map.width!==s.x||W.map.height!==s.y)&&W.map.setSize(s.x,s.y);let Q=W.map.isWebGLCubeRenderTarget?6:W.getViewportCount();X.isPointLight!==!0&&W.updateMatrices(X,S);let tt=(W.camera.layers.mask&4294967294)!==0?W.camera.layers:S.layers;for(let Pt=0;Pt<Q;Pt++){let jt=W.getCamera(Pt);if(X.isPointLight){let J=W.camera,vt=W.matrix,Tt=X.distance||J.far;Tt!==J.far&&(J.far=Tt,J.updateProjectionMatrix()),Ma.setFromMatrixPosition(X.matrixWorld),J.position.copy(Ma),Zf.copy(J.position),Zf.add(nC[Pt]),J.up.copy(iC[Pt]),J.lookAt(Zf),J.updateMatrixWorld(),vt.makeTranslation(-Ma.x,-Ma.y,-Ma.z),Fx.multiplyMatrices(J.projectionMatrix,J.matrixWorldInverse),W._frustum.setFromProjectionMatrix(Fx,J.coordinateSystem,J.reversedDepth)}if(W.map.isWebGLCubeRenderTarget)n.setRenderTarget(W.map,Pt),n.clear();else{Pt===0&&(n.setRenderTarget(W.map),n.clear());let J=W.getViewport(Pt);o.set(r.x*J.x,r.y*J.y,r.x*J.z,r.y*J.w),k.viewport(o)}i=W.getFrustum(Pt),M(y,S,jt,X,tt,this.type)}W.isPointLightShadow!==!0&&this.type===Zr&&_(W,S),W.needsUpdate=!1}x=this.type,g.needsUpdate=!1,n.setRenderTarget(D,L,U)};function _(E,y){let S=t.update(m);d.defines.VSM_SAMPLES!==E.blurSamples&&(d.defines.VSM_SAMPLES=E.blurSamples,f.defines.VSM_SAMPLES=E.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),E.mapPass===null?E.mapPass=new Dn(s.x,s.y,{format:bs,type:li}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),d.uniforms.shadow_pass.value=E.map.depthTexture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(y,null,S,d,m,null),f.uniforms.shadow_pass.value=E.mapPass.texture,f.uniforms.resolution.value.set(E.map.width,E.map.height),f.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(y,null,S,f,m,null)}function b(E,y,S,D){let L=null,U=S.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(U!==void 0)L=U;else if(L=S.isPointLight===!0?c:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let k=L.uuid,G=y.uuid,I=l[k];I===void 0&&(I={},l[k]=I);let H=I[G];H===void 0&&(H=L.clone(),I[G]=H,y.addEventListener("dispose",T)),L=H}if(L.visible=y.visible,L.wireframe=y.wireframe,D===Zr?L.side=y.shadowSide!==null?y.shadowSide:y.side:L.side=y.shadowSide!==null?y.shadowSide:u[y.side],L.alphaMap=y.alphaMap,L.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,L.map=y.map,L.clipShadows=y.clipShadows,L.clippingPlanes=y.clippingPlanes,L.clipIntersection=y.clipIntersection,L.displacementMap=y.displacementMap,L.displacementScale=y.displacementScale,L.displacementBias=y.displacementBias,L.wireframeLinewidth=y.wireframeLinewidth,L.linewidth=y.linewidth,S.isPointLight===!0&&L.isMeshDistanceMaterial===!0){let k=n.properties.get(L);k.light=S}return L}function M(E,y,S,D,L,U){if(E.visible===!1)return;if(E.layers.test(L)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&U===Zr)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(S.matrixWorldInverse,E.matrixWorld);let I=t.update(E),H=E.material;if(Array.isArray(H)){let X=I.groups;for(let W=0,st=X.length;W<st;W++){let q=X[W],Q=H[q.materialIndex];if(Q&&Q.visible){let tt=b(E,Q,D,U);E.onBeforeShadow(n,E,y,S,I,tt,q),n.renderBufferDirect(S,null,I,tt,E,q),E.onAfterShadow(n,E,y,S,I,tt,q)}}}else if(H.visible){let X=b(E,H,D,U);E.onBeforeShadow(n,E,y,S,I,X,null),n.renderBufferDirect(S,null,I,X,E,null),E.onAfterShadow(n,E,y,S,I,X,null)}}let G=E.children;for(let I=0,H=G.length;I<H;I++)M(G[I],y,S,D,L,U)}function T(E){E.target.removeEventListener("dispose",T);for(let S in l){let D=l[S],L=E.target.uuid;L in D&&(D[L].dispose(),delete D[L])}}}function rC(n,t){function e(){let C=!1,Z=new be,$=null,dt=new be(0,0,0,0);return{setMask:function(ct){$!==ct&&!C&&(n.colorMask(ct,ct,ct,ct),$=ct)},setLocked:function(ct){C=ct},setClear:function(ct,ht,Ut,Kt,rt){rt===!0&&(ct*=Kt,ht*=Kt,Ut*=Kt),Z.set(ct,ht,Ut,Kt),dt.equals(Z)===!1&&(n.clearColor(ct,ht,Ut,Kt),dt.copy(Z))},reset:function(){C=!1,$=null,dt.set(-1,0,0,0)}}}function i(){let C=!1,Z=!1,$=null,dt=null,ct=null;return{setReversed:function(ht){if(Z!==ht){let Ut=t.get("EXT_clip_control");ht?Ut.clipControlEXT(Ut.LOWER_LEFT_EXT,Ut.ZERO_TO_ONE_EXT):Ut.clipControlEXT(Ut.LOWER_LEFT_EXT,Ut.NEGATIVE_ONE_TO_ONE_EXT),Z=ht;let Kt=ct;ct=null,this.setClear(Kt)}},getReversed:function(){return Z},setTest:function(ht){ht?bt(n.DEPTH_TEST):Jt(n.DEPTH_TEST)},setMask:function(ht){$!==ht&&!C&&(n.depthMask(ht),$=ht)},setFunc:function(ht){if(Z&&(ht=hx[ht]),dt!==ht){switch(ht){case sl:n.depthFunc(n.NEVER);break;case rl:n.depthFunc(n.ALWAYS);break;case ol:n.depthFunc(n.LESS);break;case zr:n.depthFunc(n.LEQUAL);break;case al:n.depthFunc(n.EQUAL);break;case cl:n.depthFunc(n.GEQUAL);break;case ll:n.depthFunc(n.GREATER);break;case hl:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}dt=ht}},setLocked:function(ht){C=ht},setClear:function(ht){ct!==ht&&(ct=ht,Z&&(ht=1-ht),n.clearDepth(ht))},reset:function(){C=!1,$=null,dt=null,ct=null,Z=!1}}}function s(){let C=!1,Z=null,$=null,dt=null,ct=null,ht=null,Ut=null,Kt=null,rt=null;return{setTest:function(Ft){C||(Ft?bt(n.STENCIL_TEST):Jt(n.STENCIL_TEST))},setMask:function(Ft){Z!==Ft&&!C&&(n.stencilMask(Ft),Z=Ft)},setFunc:function(Ft,Zt,_t){($!==Ft||dt!==Zt||ct!==_t)&&(n.stencilFunc(Ft,Zt,_t),$=Ft,dt=Zt,ct=_t)},setOp:function(Ft,Zt,_t){(ht!==Ft||Ut!==Zt||Kt!==_t)&&(n.stencilOp(Ft,Zt,_t),ht=Ft,Ut=Zt,Kt=_t)},setLocked:function(Ft){C=Ft},setClear:function(Ft){rt!==Ft&&(n.clearStencil(Ft),rt=Ft)},reset:function(){C=!1,Z=null,$=null,dt=null,ct=null,ht=null,Ut=null,Kt=null,rt=null}}}let r=new e,o=new i,a=new s,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],m=null,g=!1,x=null,_=null,b=null,M=null,T=null,E=null,y=null,S=new $t(0,0,0),D=0,L=!1,U=null,k=null,G=null,I=null,H=null,X=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),W=!1,st=0,q=n.getParameter(n.VERSION);q.indexOf("WebGL")!==-1?(st=parseFloat(/^WebGL (\d)/.exec(q)[1]),W=st>=1):q.indexOf("OpenGL ES")!==-1&&(st=parseFloat(/^OpenGL ES (\d)/.exec(q)[1]),W=st>=2);let Q=null,tt={},Pt=n.getParameter(n.SCISSOR_BOX),jt=n.getParameter(n.VIEWPORT),J=new be().fromArray(Pt),vt=new be().fromArray(jt);function Tt(C,Z,$,dt){let ct=new Uint8Array(4),ht=n.createTexture();n.bindTexture(C,ht),n.texParameteri(C,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(C,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Ut=0;Ut<$;Ut++)C===n.TEXTURE_3D||C===n.TEXTURE_2D_ARRAY?n.texImage3D(Z,0,n.RGBA,1,1,dt,0,n.RGBA,n.UNSIGNED_BYTE,ct):n.texImage2D(Z+Ut,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ct);return ht}let zt={};zt[n.TEXTURE_2D]=Tt(n.TEXTURE_2D,n.TEXTURE_2D,1),zt[n.TEXTURE_CUBE_MAP]=Tt(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),zt[n.TEXTURE_2D_ARRAY]=Tt(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),zt[n.TEXTURE_3D]=Tt(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),bt(n.DEPTH_TEST),o.setFunc(zr),_n(!1),Se(pf),bt(n.CULL_FACE),je(nr);function bt(C){h[C]!==!0&&(n.enable(C),h[C]=!0)}function Jt(C){h[C]!==!1&&(n.disable(C),h[C]=!1)}function Ne(C,Z){return d[C]!==Z?(n.bindFramebuffer(C,Z),d[C]=Z,C===n.DRAW_FRAMEBUFFER&&(d[n.FRAMEBUFFER]=Z),C===n.FRAMEBUFFER&&(d[n.DRAW_FRAMEBUFFER]=Z),!0):!1}function Vt(C,Z){let $=p,dt=!1;if(C){$=f.get(Z),$===void 0&&($=[],f.set(Z,$));let ct=C.textures;if($.length!==ct.length||$[0]!==n.COLOR_ATTACHMENT0){for(let ht=0,Ut=ct.length;ht<Ut;ht++)$[ht]=n.COLOR_ATTACHMENT0+ht;$.length=ct.length,dt=!0}}else $[0]!==n.BACK&&($[0]=n.BACK,dt=!0);dt&&n.drawBuffers($)}function fe(C){return m!==C?(n.useProgram(C),m=C,!0):!1}let me={[ir]:n.FUNC_ADD,[L0]:n.FUNC_SUBTRACT,[N0]:n.FUNC_REVERSE_SUBTRACT};me[D0]=n.MIN,me[O0]=n.MAX;let ne={[U0]:n.ZERO,[F0]:n.ONE,[k0]:n.SRC_COLOR,[_f]:n.SRC_ALPHA,[W0]:n.SRC_ALPHA_SATURATE,[V0]:n.DST_COLOR,[z0]:n.DST_ALPHA,[B0]:n.ONE_MINUS_SRC_COLOR,[yf]:n.ONE_MINUS_SRC_ALPHA,[H0]:n.ONE_MINUS_DST_COLOR,[G0]:n.ONE_MINUS_DST_ALPHA,[$0]:n.CONSTANT_COLOR,[q0]:n.ONE_MINUS_CONSTANT_COLOR,[X0]:n.CONSTANT_ALPHA,[j0]:n.ONE_MINUS_CONSTANT_ALPHA};function je(C,Z,$,dt,ct,ht,Ut,Kt,rt,Ft){if(C===nr){g===!0&&(Jt(n.BLEND),g=!1);return}if(g===!1&&(bt(n.BLEND),g=!0),C!==P0){if(C!==x||Ft!==L){if((_!==ir||T!==ir)&&(n.blendEquation(n.FUNC_ADD),_=ir,T=ir),Ft)switch(C){case Kr:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case mf:n.blendFunc(n.ONE,n.ONE);break;case gf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case xf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:Wt("WebGLState: Invalid blending: ",C);break}else switch(C){case Kr:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case mf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case gf:Wt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case xf:Wt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Wt("WebGLState: Invalid blending: ",C);break}b=null,M=null,E=null,y=null,S.set(0,0,0),D=0,x=C,L=Ft}return}ct=ct||Z,ht=ht||$,Ut=Ut||dt,(Z!==_||ct!==T)&&(n.blendEquationSeparate(me[Z],me[ct]),_=Z,T=ct),($!==b||dt!==M||ht!==E||Ut!==y)&&(n.blendFuncSeparate(ne[$],ne[dt],ne[ht],ne[Ut]),b=$,M=dt,E=ht,y=Ut),(Kt.equals(S)===!1||rt!==D)&&(n.blendColor(Kt.r,Kt.g,Kt.b,rt),S.copy(Kt),D=rt),x=C,L=!1}function Fe(C,Z){C.side===Mn?Jt(n.CULL_FACE):bt(n.CULL_FACE);let $=C.side===gn;Z&&($=!$),_n($),C.blending===Kr&&C.transparent===!1?je(nr):je(C.blending,C.blendEquation,C.blendSrc,C.blendDst,C.blendEquationAlpha,C.blendSrcAlpha,C.blendDstAlpha,C.blendColor,C.blendAlpha,C.premultipliedAlpha),o.setFunc(C.depthFunc),o.setTest(C.depthTest),o.setMask(C.depthWrite),r.setMask(C.colorWrite);let dt=C.stencilWrite;a.setTest(dt),dt&&(a.setMask(C.stencilWriteMask),a.setFunc(C.stencilFunc,C.stencilRef,C.stencilFuncMask),a.setOp(C.stencilFail,C.stencilZFail,C.stencilZPass)),Ve(C.polygonOffset,C.polygonOffsetFactor,C.polygonOffsetUnits),C.alphaToCoverage===!0?bt(n.SAMPLE_ALPHA_TO_COVERAGE):Jt(n.SAMPLE_ALPHA_TO_COVERAGE)}function _n(C){U!==C&&(C?n.frontFace(n.CW):n.frontFace(n.CCW),U=C)}function Se(C){C!==R0?(bt(n.CULL_FACE),C!==k&&(C===pf?n.cullFace(n.BACK):C===C0?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Jt(n.CULL_FACE),k=C}function pi(C){C!==G&&(W&&n.lineWidth(C),G=C)}function Ve(C,Z,$){C?(bt(n.POLYGON_OFFSET_FILL),(I!==Z||H!==$)&&(I=Z,H=$,o.getReversed()&&(Z=-Z,$=-$),n.polygonOffset(Z,$))):Jt(n.POLYGON_OFFSET_FILL)}function Bn(C){C?bt(n.SCISSOR_TEST):Jt(n.SCISSOR_TEST)}function zn(C){C===void 0&&(C=n.TEXTURE0+X-1),Q!==C&&(n.activeTexture(C),Q=C)}function Gn(C,Z,$){$===void 0&&(Q===null?$=n.TEXTURE0+X-1:$=Q);let dt=tt[$];dt===void 0&&(dt={type:void 0,texture:void 0},tt[$]=dt),(dt.type!==C||dt.texture!==Z)&&(Q!==$&&(n.activeTexture($),Q=$),n.bindTexture(C,Z||zt[C]),dt.type=C,dt.texture=Z)}function O(){let C=tt[Q];C!==void 0&&C.type!==void 0&&(n.bindTexture(C.type,null),C.type=void 0,C.texture=void 0)}function Vn(){try{n.compressedTexImage2D(...arguments)}catch(C){Wt("WebGLState:",C)}}function ye(){try{n.compressedTexImage3D(...arguments)}catch(C){Wt("WebGLState:",C)}}function ve(){try{n.texSubImage2D(...arguments)}catch(C){Wt("WebGLState:",C)}}function gt(){try{n.texSubImage3D(...arguments)}catch(C){Wt("WebGLState:",C)}}function ke(){try{n.compressedTexSubImage2D(...arguments)}catch(C){Wt("WebGLState:",C)}}function Gt(){try{n.compressedTexSubImage3D(...arguments)}catch(C){Wt("WebGLState:",C)}}function Xt(){try{n.texStorage2D(...arguments)}catch(C){Wt("WebGLState:",C)}}function A(){try{n.texStorage3D(...arguments)}catch(C){Wt("WebGLState:",C)}}function v(){try{n.texImage2D(...arguments)}catch(C){Wt("WebGLState:",C)}}function B(){try{n.texImage3D(...arguments)}catch(C){Wt("WebGLState:",C)}}function it(C){return u[C]!==void 0?u[C]:n.getParameter(C)}function K(C,Z){u[C]!==Z&&(n.pixelStorei(C,Z),u[C]=Z)}function lt(C){J.equals(C)===!1&&(n.scissor(C.x,C.y,C.z,C.w),J.copy(C))}function pt(C){vt.equals(C)===!1&&(n.viewport(C.x,C.y,C.z,C.w),vt.copy(C))}function j(C,Z){let $=l.get(Z);$===void 0&&($=new WeakMap,l.set(Z,$));let dt=$.get(C);dt===void 0&&(dt=n.getUniformBlockIndex(Z,C.name),n.uniformBlockBinding(Z,dt,dt),$.set(C,dt))}function Y(C,Z,$){let ct=l.get(Z).get(C);c[ct]!==$&&(n.bindBufferBase(n.UNIFORM_BUFFER,ct,$),c[ct]=$)}function ut(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),h={},u={},Q=null,tt={},d={},c={},f=new WeakMap,p=[],m=null,g=!1,x=null,_=null,b=null,M=null,T=null,E=null,y=null,S=new $t(0,0,0),D=0,L=!1,U=null,k=null,G=null,I=null,H=null,J.set(0,0,n.canvas.width,n.canvas.height),vt.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:bt,disable:Jt,bindFramebuffer:Ne,drawBuffers:Vt,useProgram:fe,setBlending:je,setMaterial:Fe,setFlipSided:_n,setCullFace:Se,setLineWidth:pi,setPolygonOffset:Ve,setScissorTest:Bn,activeTexture:zn,bindTexture:Gn,unbindTexture:O,compressedTexImage2D:Vn,compressedTexImage3D:ye,texImage2D:v,texImage3D:B,pixelStorei:K,getParameter:it,updateUBOMapping:j,uniformBlockBinding:Y,texStorage2D:Xt,texStorage3D:A,texSubImage2D:ve,texSubImage3D:gt,compressedTexSubImage2D:ke,compressedTexSubImage3D:Gt,scissor:lt,viewport:pt,reset:ut}}function oC(n,t,e,i,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new St,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,m=new FinalizationRegistry(A=>p.delete(A)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function x(A,v){return g?new OffscreenCanvas(A,v):Wo("canvas")}function _(A,v,B){let it=1,K=Xt(A);if((K.width>B||K.height>B)&&(it=B/Math.max(K.width,K.height)),it<1)if(typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&A instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&A instanceof ImageBitmap||typeof VideoFrame<"u"&&A instanceof VideoFrame){let lt=Math.floor(it*K.width),pt=Math.floor(it*K.height);d===void 0&&(d=x(lt,pt));let j=v?x(lt,pt):d;return j.width=lt,j.height=pt,j.getContext("2d").drawImage(A,0,0,lt,pt),Bt("WebGLRenderer: Texture has been resized from ("+K.width+"x"+K.height+") to ("+lt+"x"+pt+")."),j}else return"data"in A&&Bt("WebGLRenderer: Image in DataTexture is too big ("+K.width+"x"+K.height+")."),A;return A}function b(A){return A.generateMipmaps}function M(A){n.generateMipmap(A)}function T(A){return A.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:A.isWebGL3DRenderTarget?n.TEXTURE_3D:A.isWebGLArrayRenderTarget||A.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(A,v,B,it,K,lt=!1){if(A!==null){if(n[A]!==void 0)return n[A];Bt("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+A+"'")}let pt;it&&(pt=t.get("EXT_texture_norm16"),pt||Bt("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let j=v;if(v===n.RED&&(B===n.FLOAT&&(j=n.R32F),B===n.HALF_FLOAT&&(j=n.R16F),B===n.UNSIGNED_BYTE&&(j=n.R8),B===n.UNSIGNED_SHORT&&pt&&(j=pt.R16_EXT),B===n.SHORT&&pt&&(j=pt.R16_SNORM_EXT)),v===n.RED_INTEGER&&(B===n.UNSIGNED_BYTE&&(j=n.R8UI),B===n.UNSIGNED_SHORT&&(j=n.R16UI),B===n.UNSIGNED_INT&&(j=n.R32UI),B===n.BYTE&&(j=n.R8I),B===n.SHORT&&(j=n.R16I),B===n.INT&&(j=n.R32I)),v===n.RG&&(B===n.FLOAT&&(j=n.RG32F),B===n.HALF_FLOAT&&(j=n.RG16F),B===n.UNSIGNED_BYTE&&(j=n.RG8),B===n.UNSIGNED_SHORT&&pt&&(j=pt.RG16_EXT),B===n.SHORT&&pt&&(j=pt.RG16_SNORM_EXT)),v===n.RG_INTEGER&&(B===n.UNSIGNED_BYTE&&(j=n.RG8UI),B===n.UNSIGNED_SHORT&&(j=n.RG16UI),B===n.UNSIGNED_INT&&(j=n.RG32UI),B===n.BYTE&&(j=n.RG8I),B===n.SHORT&&(j=n.RG16I),B===n.INT&&(j=n.RG32I)),v===n.RGB_INTEGER&&(B===n.UNSIGNED_BYTE&&(j=n.RGB8UI),B===n.UNSIGNED_SHORT&&(j=n.RGB16UI),B===n.UNSIGNED_INT&&(j=n.RGB32UI),B===n.BYTE&&(j=n.RGB8I),B===n.SHORT&&(j=n.RGB16I),B===n.INT&&(j=n.RGB32I)),v===n.RGBA_INTEGER&&(B===n.UNSIGNED_BYTE&&(j=n.RGBA8UI),B===n.UNSIGNED_SHORT&&(j=n.RGBA16UI),B===n.UNSIGNED_INT&&(j=n.RGBA32UI),B===n.BYTE&&(j=n.RGBA8I),B===n.SHORT&&(j=n.RGBA16I),B===n.INT&&(j=n.RGBA32I)),v===n.RGB&&(B===n.UNSIGNED_SHORT&&pt&&(j=pt.RGB16_EXT),B===n.SHORT&&pt&&(j=pt.RGB16_SNORM_EXT),B===n.UNSIGNED_INT_5_9_9_9_REV&&(j=n.RGB9_E5),B===n.UNSIGNED_INT_10F_11F_11F_REV&&(j=n.R11F_G11F_B10F)),v===n.RGBA){let Y=lt?Ho:re.getTransfer(K);B===n.FLOAT&&(j=n.RGBA32F),B===n.HALF_FLOAT&&(j=n.RGBA16F),B===n.UNSIGNED_BYTE&&(j=Y===ue?n.SRGB8_ALPHA8:n.RGBA8),B===n.UNSIGNED_SHORT&&pt&&(j=pt.RGBA16_EXT),B===n.SHORT&&pt&&(j=pt.RGBA16_SNORM_EXT),B===n.UNSIGNED_SHORT_4_4_4_4&&(j=n.RGBA4),B===n.UNSIGNED_SHORT_5_5_5_1&&(j=n.RGB5_A1)}return(j===n.R16F||j===n.R32F||j===n.RG16F||j===n.RG32F||j===n.RGBA16F||j===n.RGBA32F)&&t.get("EXT_color_buffer_float"),j}function y(A,v){let B;return A?v===null||v===ci||v===rr?B=n.DEPTH24_STENCIL8:v===Yn?B=n.DEPTH32F_STENCIL8:v===to&&(B=n.DEPTH24_STENCIL8,Bt("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):v===null||v===ci||v===rr?B=n.DEPTH_COMPONENT24:v===Yn?B=n.DEPTH_COMPONENT32F:v===to&&(B=n.DEPTH_COMPONENT16),B}function S(A,v){return b(A)===!0||A.isFramebufferTexture&&A.minFilter!==qe&&A.minFilter!==pn?Math.log2(Math.max(v.width,v.height))+1:A.mipmaps.length>0?A.mipmaps.length:A.isCompressedTexture&&Array.isArray(A.image)?v.mipmaps.length:1}function D(A){let v=new WeakRef(A);i.get(A).__ref=v,p.add(v),m.register(A,v,v)}function L(A){let v=i.get(A).__ref;v!==void 0&&(p.delete(v),m.unregister(v))}function U(A){G(A.target)}function k(A){I(A.target)}function G(A){A.removeEventListener("dispose",U),L(A),X(A),A.isVideoTexture&&h.delete(A),A.isHTMLTexture&&u.delete(A)}function I(A){A.removeEventListener("dispose",k),L(A),st(A)}function H(){for(let A of p){let v=A.deref();v!==void 0&&(v.isRenderTarget===!0?I(v):G(v))}p.clear(),u.clear()}function X(A){let v=i.get(A);if(v.__webglInit===void 0)return;let B=A.source,it=f.get(B);if(it){let K=it[v.__cacheKey];K.usedTimes--,K.usedTimes===0&&W(A),Object.keys(it).length===0&&f.delete(B)}i.remove(A)}function W(A){let v=i.get(A);n.deleteTexture(v.__webglTexture);let B=A.source,it=f.get(B);delete it[v.__cacheKey],o.memory.textures--}function st(A){let v=i.get(A);v.__depthDisposeCallback&&v.__depthDisposeCallback();let B=A.depthTexture;if(B&&B.renderTarget===A&&G(B),A.isWebGLCubeRenderTarget)for(let K=0;K<6;K++){if(Array.isArray(v.__webglFramebuffer[K]))for(let lt=0;lt<v.__webglFramebuffer[K].length;lt++)n.deleteFramebuffer(v.__webglFramebuffer[K][lt]);else n.deleteFramebuffer(v.__webglFramebuffer[K]);v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer[K])}else{if(Array.isArray(v.__webglFramebuffer))for(let K=0;K<v.__webglFramebuffer.length;K++)n.deleteFramebuffer(v.__webglFramebuffer[K]);else n.deleteFramebuffer(v.__webglFramebuffer);if(v.__webglDepthbuffer&&n.deleteRenderbuffer(v.__webglDepthbuffer),v.__webglMultisampledFramebuffer&&n.deleteFramebuffer(v.__webglMultisampledFramebuffer),v.__webglColorRenderbuffer)for(let K=0;K<v.__webglColorRenderbuffer.length;K++)v.__webglColorRenderbuffer[K]&&n.deleteRenderbuffer(v.__webglColorRenderbuffer[K]);v.__webglDepthRenderbuffer&&n.deleteRenderbuffer(v.__webglDepthRenderbuffer)}let it=A.textures;for(let K=0,lt=it.length;K<lt;K++){let pt=i.get(it[K]);pt.__webglTexture&&(n.deleteTexture(pt.__webglTexture),o.memory.textures--),i.remove(it[K])}i.remove(A)}let q=0;function Q(){q=0}function tt(){return q}function Pt(A){q=A}function jt(){let A=q;return A>=s.maxTextures&&Bt("WebGLTextures: Trying to use "+(A+1)+" texture units while this GPU supports only "+s.maxTextures),q+=1,A}function J(A){let v=[];return v.push(A.wrapS),v.push(A.wrapT),v.push(A.wrapR||0),v.push(A.magFilter),v.push(A.minFilter),v.push(A.anisotropy),v.push(A.internalFormat),v.push(A.format),v.push(A.type),v.push(A.generateMipmaps),v.push(A.mipmapsAutoUpdate),v.push(A.premultiplyAlpha),v.push(A.flipY),v.push(A.unpackAlignment),v.push(A.colorSpace),v.join()}function vt(A,v){let B=i.get(A);if(A.isVideoTexture&&ke(A),A.isRenderTargetTexture===!1&&A.isExternalTexture!==!0&&A.version>0&&B.__version!==A.version){let it=A.image;if(it===null)Bt("WebGLRenderer: Texture marked for update but no image data found.");else if(it.complete===!1)Bt("WebGLRenderer: Texture marked for update but image is incomplete");else{Fe(B,A,v);return}}else A.isExternalTexture&&(B.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D,B.__webglTexture,n.TEXTURE0+v)}function Tt(A,v){let B=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&B.__version!==A.version){Fe(B,A,v);return}else A.isExternalTexture&&(B.__webglTexture=A.sourceTexture?A.sourceTexture:null);e.bindTexture(n.TEXTURE_2D_ARRAY,B.__webglTexture,n.TEXTURE0+v)}function zt(A,v){let B=i.get(A);if(A.isRenderTargetTexture===!1&&A.version>0&&B.__version!==A.version){Fe(B,A,v);return}e.bindTexture(n.TEXTURE_3D,B.__webglTexture,n.TEXTURE0+v)}function bt(A,v){let B=i.get(A);if(A.version>0&&B.__version!==A.version){_n(B,A,v);return}e.bindTexture(n.TEXTURE_CUBE_MAP,B.__webglTexture,n.TEXTURE0+v)}let Jt={[ul]:n.REPEAT,[wi]:n.CLAMP_TO_EDGE,[dl]:n.MIRRORED_REPEAT},Ne={[qe]:n.NEAREST,[Z0]:n.NEAREST_MIPMAP_NEAREST,[ga]:n.NEAREST_MIPMAP_LINEAR,[pn]:n.LINEAR,[$l]:n.LINEAR_MIPMAP_NEAREST,[ji]:n.LINEAR_MIPMAP_LINEAR},Vt={[ex]:n.NEVER,[Ff]:n.ALWAYS,[nx]:n.LESS,[Of]:n.LEQUAL,[ix]:n.EQUAL,[Uf]:n.GEQUAL,[sx]:n.GREATER,[rx]:n.NOTEQUAL};function fe(A,v){if(v.type===Yn&&t.has("OES_texture_float_linear")===!1&&(v.magFilter===pn||v.magFilter===$l||v.magFilter===ga||v.magFilter===ji||v.minFilter===pn||v.minFilter===$l||v.minFilter===ga||v.minFilter===ji)&&Bt("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(A,n.TEXTURE_WRAP_S,Jt[v.wrapS]),n.texParameteri(A,n.TEXTURE_WRAP_T,Jt[v.wrapT]),(A===n.TEXTURE_3D||A===n.TEXTURE_2D_ARRAY)&&n.texParameteri(A,n.TEXTURE_WRAP_R,Jt[v.wrapR]),n.texParameteri(A,n.TEXTURE_MAG_FILTER,Ne[v.magFilter]),n.texParameteri(A,n.TEXTURE_MIN_FILTER,Ne[v.minFilter]),v.compareFunction&&(n.texParameteri(A,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(A,n.TEXTURE_COMPARE_FUNC,Vt[v.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(v.magFilter===qe||v.minFilter!==ga&&v.minFilter!==ji||v.type===Yn&&t.has("OES_texture_float_linear")===!1)return;if(v.anisotropy>1||i.get(v).__currentAnisotropy){let B=t.get("EXT_texture_filter_anisotropic");n.texParameterf(A,B.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(v.anisotropy,s.getMaxAnisotropy())),i.get(v).__currentAnisotropy=v.anisotropy}}}function me(A,v){let B=!1;A.__webglInit===void 0&&(A.__webglInit=!0,v.addEventListener("dispose",U),D(v));let it=v.source,K=f.get(it);K===void 0&&(K={},f.set(it,K));let lt=J(v);if(lt!==A.__cacheKey){K[lt]===void 0&&(K[lt]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,B=!0),K[lt].usedTimes++;let pt=K[A.__cacheKey];pt!==void 0&&(K[A.__cacheKey].usedTimes--,pt.usedTimes===0&&W(v)),A.__cacheKey=lt,A.__webglTexture=K[lt].texture}return B}function ne(A,v,B){return Math.floor(Math.floor(A/B)/v)}function je(A,v,B,it){let lt=A.updateRanges;if(lt.length===0)e.texSubImage2D(n.TEXTURE_2D,0,0,0,v.width,v.height,B,it,v.data);else{lt.sort((C,Z)=>C.start-Z.start);let pt=0;for(let C=1;C<lt.length;C++){let Z=lt[pt],$=lt[C],dt=Z.start+Z.count,ct=ne($.start,v.width,4),ht=ne(Z.start,v.width,4);$.start<=dt+1&&ct===ht&&ne($.start+$.count-1,v.width,4)===ct?Z.count=Math.max(Z.count,$.start+$.count-Z.start):(++pt,lt[pt]=$)}lt.length=pt+1;let j=e.getParameter(n.UNPACK_ROW_LENGTH),Y=e.getParameter(n.UNPACK_SKIP_PIXELS),ut=e.getParameter(n.UNPACK_SKIP_ROWS);e.pixelStorei(n.UNPACK_ROW_LENGTH,v.width);for(let C=0,Z=lt.length;C<Z;C++){let $=lt[C],dt=Math.floor($.start/4),ct=Math.ceil($.count/4),ht=dt%v.width,Ut=Math.floor(dt/v.width),Kt=ct,rt=1;e.pixelStorei(n.UNPACK_SKIP_PIXELS,ht),e.pixelStorei(n.UNPACK_SKIP_ROWS,Ut),e.texSubImage2D(n.TEXTURE_2D,0,ht,Ut,Kt,rt,B,it,v.data)}A.clearUpdateRanges(),e.pixelStorei(n.UNPACK_ROW_LENGTH,j),e.pixelStorei(n.UNPACK_SKIP_PIXELS,Y),e.pixelStorei(n.UNPACK_SKIP_ROWS,ut)}}function Fe(A,v,B){let it=n.TEXTURE_2D;(v.isDataArrayTexture||v.isCompressedArrayTexture)&&(it=n.TEXTURE_2D_ARRAY),v.isData3DTexture&&(it=n.TEXTURE_3D);let K=me(A,v),lt=v.source;e.bindTexture(it,A.__webglTexture,n.TEXTURE0+B);let pt=i.get(lt);if(lt.version!==pt.__version||K===!0){if(e.activeTexture(n.TEXTURE0+B),(typeof ImageBitmap<"u"&&v.image instanceof ImageBitmap)===!1){let rt=re.getPrimaries(re.workingColorSpace),Ft=v.colorSpace===Ji?null:re.getPrimaries(v.colorSpace),Zt=v.colorSpace===Ji||rt===Ft?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Zt)}e.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment);let Y=_(v.image,!1,s.maxTextureSize);Y=Gt(v,Y);let ut=r.convert(v.format,v.colorSpace),C=r.convert(v.type),Z=E(v.internalFormat,ut,C,v.normalized,v.colorSpace,v.isVideoTexture);fe(it,v);let $,dt=v.mipmaps,ct=v.isVideoTexture!==!0,ht=pt.__version===void 0||K===!0,Ut=lt.dataReady,Kt=S(v,Y);if(v.isDepthTexture)Z=y(v.format===Yi,v.type),ht&&(ct?e.texStorage2D(n.TEXTURE_2D,1,Z,Y.width,Y.height):e.texImage2D(n.TEXTURE_2D,0,Z,Y.width,Y.height,0,ut,C,null));else if(v.isDataTexture)if(dt.length>0){ct&&ht&&e.texStorage2D(n.TEXTURE_2D,Kt,Z,dt[0].width,dt[0].height);for(let rt=0,Ft=dt.length;rt<Ft;rt++)$=dt[rt],ct?Ut&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,$.width,$.height,ut,C,$.data):e.texImage2D(n.TEXTURE_2D,rt,Z,$.width,$.height,0,ut,C,$.data);v.generateMipmaps=!1}else ct?(ht&&e.texStorage2D(n.TEXTURE_2D,Kt,Z,Y.width,Y.height),Ut&&je(v,Y,ut,C)):e.texImage2D(n.TEXTURE_2D,0,Z,Y.width,Y.height,0,ut,C,Y.data);else if(v.isCompressedTexture)if(v.isCompressedArrayTexture){ct&&ht&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Kt,Z,dt[0].width,dt[0].height,Y.depth);for(let rt=0,Ft=dt.length;rt<Ft;rt++)if($=dt[rt],v.format!==hi)if(ut!==null)if(ct){if(Ut)if(v.layerUpdates.size>0){let Zt=Yf($.width,$.height,v.format,v.type);for(let _t of v.layerUpdates){let pe=$.data.subarray(_t*Zt/$.data.BYTES_PER_ELEMENT,(_t+1)*Zt/$.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,_t,$.width,$.height,1,ut,pe)}}else e.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,0,$.width,$.height,Y.depth,ut,$.data)}else e.compressedTexImage3D(n.TEXTURE_2D_ARRAY,rt,Z,$.width,$.height,Y.depth,0,$.data,0,0);else Bt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ct?Ut&&e.texSubImage3D(n.TEXTURE_2D_ARRAY,rt,0,0,0,$.width,$.height,Y.depth,ut,C,$.data):e.texImage3D(n.TEXTURE_2D_ARRAY,rt,Z,$.width,$.height,Y.depth,0,ut,C,$.data);v.layerUpdates.size>0&&v.clearLayerUpdates()}else{ct&&ht&&e.texStorage2D(n.TEXTURE_2D,Kt,Z,dt[0].width,dt[0].height);for(let rt=0,Ft=dt.length;rt<Ft;rt++)$=dt[rt],v.format!==hi?ut!==null?ct?Ut&&e.compressedTexSubImage2D(n.TEXTURE_2D,rt,0,0,$.width,$.height,ut,$.data):e.compressedTexImage2D(n.TEXTURE_2D,rt,Z,$.width,$.height,0,$.data):Bt("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ct?Ut&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,$.width,$.height,ut,C,$.data):e.texImage2D(n.TEXTURE_2D,rt,Z,$.width,$.height,0,ut,C,$.data)}else if(v.isDataArrayTexture)if(ct){if(ht&&e.texStorage3D(n.TEXTURE_2D_ARRAY,Kt,Z,Y.width,Y.height,Y.depth),Ut)if(v.layerUpdates.size>0){let rt=Yf(Y.width,Y.height,v.format,v.type);for(let Ft of v.layerUpdates){let Zt=Y.data.subarray(Ft*rt/Y.data.BYTES_PER_ELEMENT,(Ft+1)*rt/Y.data.BYTES_PER_ELEMENT);e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Ft,Y.width,Y.height,1,ut,C,Zt)}v.clearLayerUpdates()}else e.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,Y.width,Y.height,Y.depth,ut,C,Y.data)}else e.texImage3D(n.TEXTURE_2D_ARRAY,0,Z,Y.width,Y.height,Y.depth,0,ut,C,Y.data);else if(v.isData3DTexture)ct?(ht&&e.texStorage3D(n.TEXTURE_3D,Kt,Z,Y.width,Y.height,Y.depth),Ut&&e.texSubImage3D(n.TEXTURE_3D,0,0,0,0,Y.width,Y.height,Y.depth,ut,C,Y.data)):e.texImage3D(n.TEXTURE_3D,0,Z,Y.width,Y.height,Y.depth,0,ut,C,Y.data);else if(v.isFramebufferTexture){if(ht)if(ct)e.texStorage2D(n.TEXTURE_2D,Kt,Z,Y.width,Y.height);else{let rt=Y.width,Ft=Y.height;for(let Zt=0;Zt<Kt;Zt++)e.texImage2D(n.TEXTURE_2D,Zt,Z,rt,Ft,0,ut,C,null),rt>>=1,Ft>>=1}}else if(v.isHTMLTexture){if("texElementImage2D"in n){let rt=n.canvas;if(rt.hasAttribute("layoutsubtree")||rt.setAttribute("layoutsubtree","true"),Y.parentNode!==rt){rt.appendChild(Y),u.add(v),rt.onpaint=Ft=>{let Zt=Ft.changedElements;for(let _t of u)Zt.includes(_t.image)&&(_t.needsUpdate=!0)},rt.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,Y);else{let Zt=n.RGBA,_t=n.RGBA,pe=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,Zt,_t,pe,Y)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(dt.length>0){if(ct&&ht){let rt=Xt(dt[0]);e.texStorage2D(n.TEXTURE_2D,Kt,Z,rt.width,rt.height)}for(let rt=0,Ft=dt.length;rt<Ft;rt++)$=dt[rt],ct?Ut&&e.texSubImage2D(n.TEXTURE_2D,rt,0,0,ut,C,$):e.texImage2D(n.TEXTURE_2D,rt,Z,ut,C,$);v.generateMipmaps=!1}else if(ct){if(ht){let rt=Xt(Y);e.texStorage2D(n.TEXTURE_2D,Kt,Z,rt.width,rt.height)}Ut&&e.texSubImage2D(n.TEXTURE_2D,0,0,0,ut,C,Y)}else e.texImage2D(n.TEXTURE_2D,0,Z,ut,C,Y);b(v)&&v.mipmapsAutoUpdate===!0&&M(it),pt.__version=lt.version,v.onUpdate&&v.onUpdate(v)}A.__version=v.version}function _n(A,v,B){if(v.image.length!==6)return;let it=me(A,v),K=v.source;e.bindTexture(n.TEXTURE_CUBE_MAP,A.__webglTexture,n.TEXTURE0+B);let lt=i.get(K);if(K.version!==lt.__version||it===!0){e.activeTexture(n.TEXTURE0+B);let pt=re.getPrimaries(re.workingColorSpace),j=v.colorSpace===Ji?null:re.getPrimaries(v.colorSpace),Y=v.colorSpace===Ji||pt===j?n.NONE:n.BROWSER_DEFAULT_WEBGL;e.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,v.flipY),e.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,v.premultiplyAlpha),e.pixelStorei(n.UNPACK_ALIGNMENT,v.unpackAlignment),e.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,Y);let ut=v.isCompressedTexture||v.image[0].isCompressedTexture,C=v.image[0]&&v.image[0].isDataTexture,Z=[];for(let _t=0;_t<6;_t++)!ut&&!C?Z[_t]=_(v.image[_t],!0,s.maxCubemapSize):Z[_t]=C?v.image[_t].image:v.image[_t],Z[_t]=Gt(v,Z[_t]);let $=Z[0],dt=r.convert(v.format,v.colorSpace),ct=r.convert(v.type),ht=E(v.internalFormat,dt,ct,v.normalized,v.colorSpace),Ut=v.isVideoTexture!==!0,Kt=lt.__version===void 0||it===!0,rt=K.dataReady,Ft=S(v,$);fe(n.TEXTURE_CUBE_MAP,v);let Zt;if(v.isDepthTexture){if(ht=y(v.format===Yi,v.type),Kt)if(Ut)e.texStorage2D(n.TEXTURE_CUBE_MAP,1,ht,$.width,$.height);else for(let _t=0;_t<6;_t++)e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,ht,$.width,$.height,0,dt,ct,null)}else if(ut){Ut&&Kt&&e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,ht,$.width,$.height);for(let _t=0;_t<6;_t++){Zt=Z[_t].mipmaps;for(let pe=0;pe<Zt.length;pe++){let He=Zt[pe];v.format!==hi?dt!==null?Ut?rt&&e.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe,0,0,He.width,He.height,dt,He.data):e.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe,ht,He.width,He.height,0,He.data):Bt("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ut?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe,0,0,He.width,He.height,dt,ct,He.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe,ht,He.width,He.height,0,dt,ct,He.data)}}}else{if(Zt=v.mipmaps,Ut&&Kt){Zt.length>0&&Ft++;let _t=Xt(Z[0]);e.texStorage2D(n.TEXTURE_CUBE_MAP,Ft,ht,_t.width,_t.height)}for(let _t=0;_t<6;_t++)if(C){Ut?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,0,0,Z[_t].width,Z[_t].height,dt,ct,Z[_t].data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,ht,Z[_t].width,Z[_t].height,0,dt,ct,Z[_t].data);for(let pe=0;pe<Zt.length;pe++){let ts=Zt[pe].image[_t].image;Ut?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe+1,0,0,ts.width,ts.height,dt,ct,ts.data):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe+1,ht,ts.width,ts.height,0,dt,ct,ts.data)}}else{Ut?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,0,0,dt,ct,Z[_t]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,ht,dt,ct,Z[_t]);for(let pe=0;pe<Zt.length;pe++){let He=Zt[pe];Ut?rt&&e.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe+1,0,0,dt,ct,He.image[_t]):e.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+_t,pe+1,ht,dt,ct,He.image[_t])}}}b(v)&&v.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),lt.__version=K.version,v.onUpdate&&v.onUpdate(v)}A.__version=v.version}function Se(A,v,B,it,K,lt){let pt=r.convert(B.format,B.colorSpace),j=r.convert(B.type),Y=E(B.internalFormat,pt,j,B.normalized,B.colorSpace),ut=i.get(v),C=i.get(B);if(C.__renderTarget=v,!ut.__hasExternalTextures){let Z=Math.max(1,v.width>>lt),$=Math.max(1,v.height>>lt);K===n.TEXTURE_3D||K===n.TEXTURE_2D_ARRAY?e.texImage3D(K,lt,Y,Z,$,v.depth,0,pt,j,null):e.texImage2D(K,lt,Y,Z,$,0,pt,j,null)}e.bindFramebuffer(n.FRAMEBUFFER,A),gt(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,it,K,C.__webglTexture,0,ve(v)):(K===n.TEXTURE_2D||K>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&K<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,it,K,C.__webglTexture,lt),e.bindFramebuffer(n.FRAMEBUFFER,null)}function pi(A,v,B){if(n.bindRenderbuffer(n.RENDERBUFFER,A),v.depthBuffer){let it=v.depthTexture,K=it&&it.isDepthTexture?it.type:null,lt=y(v.stencilBuffer,K),pt=v.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;gt(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ve(v),lt,v.width,v.height):B?n.renderbufferStorageMultisample(n.RENDERBUFFER,ve(v),lt,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,lt,v.width,v.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,pt,n.RENDERBUFFER,A)}else{let it=v.textures;for(let K=0;K<it.length;K++){let lt=it[K],pt=r.convert(lt.format,lt.colorSpace),j=r.convert(lt.type),Y=E(lt.internalFormat,pt,j,lt.normalized,lt.colorSpace);gt(v)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ve(v),Y,v.width,v.height):B?n.renderbufferStorageMultisample(n.RENDERBUFFER,ve(v),Y,v.width,v.height):n.renderbufferStorage(n.RENDERBUFFER,Y,v.width,v.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function Ve(A,v,B){let it=v.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(n.FRAMEBUFFER,A),!(v.depthTexture&&v.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let K=i.get(v.depthTexture);K.__renderTarget=v;let lt=it?v.depthTexture.image[0]:v.depthTexture.image;(!K.__webglTexture||lt.width!==v.width||lt.height!==v.height)&&(lt.width=v.width,lt.height=v.height,v.depthTexture.needsUpdate=!0),it?bt(v.depthTexture,0):vt(v.depthTexture,0);let pt=K.__webglTexture,j=ve(v),Y=it?n.TEXTURE_CUBE_MAP_POSITIVE_X+B:n.TEXTURE_2D,ut=v.depthTexture.format===Yi?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(v.depthTexture.format===Wi)gt(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,Y,pt,0,j):n.framebufferTexture2D(n.FRAMEBUFFER,ut,Y,pt,0);else if(v.depthTexture.format===Yi)gt(v)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ut,Y,pt,0,j):n.framebufferTexture2D(n.FRAMEBUFFER,ut,Y,pt,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Bn(A){let v=i.get(A),B=A.isWebGLCubeRenderTarget===!0;if(v.__boundDepthTexture!==A.depthTexture){let it=A.depthTexture;if(v.__depthDisposeCallback&&v.__depthDisposeCallback(),it){let K=()=>{delete v.__boundDepthTexture,delete v.__depthDisposeCallback,it.removeEventListener("dispose",K)};it.addEventListener("dispose",K),v.__depthDisposeCallback=K}v.__boundDepthTexture=it}if(A.depthTexture&&!v.__autoAllocateDepthBuffer)if(B)for(let it=0;it<6;it++)Ve(v.__webglFramebuffer[it],A,it);else A.texture.mipmaps.length>0?Ve(v.__webglFramebuffer[0],A,0):Ve(v.__webglFramebuffer,A,0);else if(B){v.__webglDepthbuffer=[];for(let it=0;it<6;it++)if(e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[it]),v.__webglDepthbuffer[it]===void 0)v.__webglDepthbuffer[it]=n.createRenderbuffer(),pi(v.__webglDepthbuffer[it],A,!1);else{let K=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,lt=v.__webglDepthbuffer[it];n.bindRenderbuffer(n.RENDERBUFFER,lt),n.framebufferRenderbuffer(n.FRAMEBUFFER,K,n.RENDERBUFFER,lt)}}else if(A.texture.mipmaps.length>0?e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer[0]):e.bindFramebuffer(n.FRAMEBUFFER,v.__webglFramebuffer),v.__webglDepthbuffer===void 0)v.__webglDepthbuffer=n.createRenderbuffer(),pi(v.__webglDepthbuffer,A,!1);else{let K=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,lt=v.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,lt),n.framebufferRenderbuffer(n.FRAMEBUFFER,K,n.RENDERBUFFER,lt)}e.bindFramebuffer(n.FRAMEBUFFER,null)}function zn(A,v,B){let it=i.get(A);v!==void 0&&Se(it.__webglFramebuffer,A,A.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),B!==void 0&&Bn(A)}function Gn(A){let v=A.texture,B=i.get(A),it=i.get(v);A.addEventListener("dispose",k),D(A);let K=A.textures,lt=A.isWebGLCubeRenderTarget===!0,pt=K.length>1;if(pt||(it.__webglTexture===void 0&&(it.__webglTexture=n.createTexture()),it.__version=v.version,o.memory.textures++),lt){B.__webglFramebuffer=[];for(let j=0;j<6;j++)if(v.mipmaps.length>0){B.__webglFramebuffer[j]=[];for(let Y=0;Y<v.mipmaps.length;Y++)B.__webglFramebuffer[j][Y]=n.createFramebuffer()}else B.__webglFramebuffer[j]=n.createFramebuffer()}else{if(v.mipmaps.length>0){B.__webglFramebuffer=[];for(let j=0;j<v.mipmaps.length;j++)B.__webglFramebuffer[j]=n.createFramebuffer()}else B.__webglFramebuffer=n.createFramebuffer();if(pt)for(let j=0,Y=K.length;j<Y;j++){let ut=i.get(K[j]);ut.__webglTexture===void 0&&(ut.__webglTexture=n.createTexture(),o.memory.textures++)}if(A.samples>0&&gt(A)===!1){B.__webglMultisampledFramebuffer=n.createFramebuffer(),B.__webglColorRenderbuffer=[],e.bindFramebuffer(n.FRAMEBUFFER,B.__webglMultisampledFramebuffer);for(let j=0;j<K.length;j++){let Y=K[j];B.__webglColorRenderbuffer[j]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,B.__webglColorRenderbuffer[j]);let ut=r.convert(Y.format,Y.colorSpace),C=r.convert(Y.type),Z=E(Y.internalFormat,ut,C,Y.normalized,Y.colorSpace,A.isXRRenderTarget===!0),$=ve(A);n.renderbufferStorageMultisample(n.RENDERBUFFER,$,Z,A.width,A.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+j,n.RENDERBUFFER,B.__webglColorRenderbuffer[j])}n.bindRenderbuffer(n.RENDERBUFFER,null),A.depthBuffer&&(B.__webglDepthRenderbuffer=n.createRenderbuffer(),pi(B.__webglDepthRenderbuffer,A,!0)),e.bindFramebuffer(n.FRAMEBUFFER,null)}}if(lt){e.bindTexture(n.TEXTURE_CUBE_MAP,it.__webglTexture),fe(n.TEXTURE_CUBE_MAP,v);for(let j=0;j<6;j++)if(v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)Se(B.__webglFramebuffer[j][Y],A,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+j,Y);else Se(B.__webglFramebuffer[j],A,v,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+j,0);b(v)?M(n.TEXTURE_CUBE_MAP):v.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}else if(pt){for(let j=0,Y=K.length;j<Y;j++){let ut=K[j],C=i.get(ut),Z=n.TEXTURE_2D;(A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(Z=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(Z,C.__webglTexture),fe(Z,ut),Se(B.__webglFramebuffer,A,ut,n.COLOR_ATTACHMENT0+j,Z,0),b(ut)&&M(Z)}e.unbindTexture()}else{let j=n.TEXTURE_2D;if((A.isWebGL3DRenderTarget||A.isWebGLArrayRenderTarget)&&(j=A.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),e.bindTexture(j,it.__webglTexture),fe(j,v),v.mipmaps.length>0)for(let Y=0;Y<v.mipmaps.length;Y++)Se(B.__webglFramebuffer[Y],A,v,n.COLOR_ATTACHMENT0,j,Y);else Se(B.__webglFramebuffer,A,v,n.COLOR_ATTACHMENT0,j,0);b(v)?M(j):v.mipmaps.length>0&&n.texParameteri(j,n.TEXTURE_MAX_LEVEL,v.mipmaps.length-1),e.unbindTexture()}A.depthBuffer&&Bn(A)}function O(A){let v=A.textures;for(let B=0,it=v.length;B<it;B++){let K=v[B];if(b(K)&&K.mipmapsAutoUpdate===!0){let lt=T(A),pt=i.get(K).__webglTexture;e.bindTexture(lt,pt),M(lt),e.unbindTexture()}}}let Vn=[];function ye(A){if(A.samples>0){if(gt(A)===!1){let v=A.textures,B=A.width,it=A.height,K=n.COLOR_BUFFER_BIT,lt=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,pt=i.get(A),j=v.length>1;if(j)for(let ut=0;ut<v.length;ut++)e.bindFramebuffer(n.FRAMEBUFFER,pt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.RENDERBUFFER,null),e.bindFramebuffer(n.FRAMEBUFFER,pt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.TEXTURE_2D,null,0);e.bindFramebuffer(n.READ_FRAMEBUFFER,pt.__webglMultisampledFramebuffer),A.texture.mipmaps.length>0?e.bindFramebuffer(n.DRAW_FRAMEBUFFER,pt.__webglFramebuffer[0]):e.bindFramebuffer(n.DRAW_FRAMEBUFFER,pt.__webglFramebuffer);for(let ut=0;ut<v.length;ut++){if(A.resolveDepthBuffer&&(A.depthBuffer&&(K|=n.DEPTH_BUFFER_BIT),A.stencilBuffer&&A.resolveStencilBuffer&&(K|=n.STENCIL_BUFFER_BIT)),j){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,pt.__webglColorRenderbuffer[ut]);let C=i.get(v[ut]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,C,0)}n.blitFramebuffer(0,0,B,it,0,0,B,it,K,n.NEAREST),c===!0&&(Vn.length=0,Vn.push(n.COLOR_ATTACHMENT0+ut),A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&Vn.push(lt),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Vn))}if(e.bindFramebuffer(n.READ_FRAMEBUFFER,null),e.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),j)for(let ut=0;ut<v.length;ut++){e.bindFramebuffer(n.FRAMEBUFFER,pt.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.RENDERBUFFER,pt.__webglColorRenderbuffer[ut]);let C=i.get(v[ut]).__webglTexture;e.bindFramebuffer(n.FRAMEBUFFER,pt.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ut,n.TEXTURE_2D,C,0)}e.bindFramebuffer(n.DRAW_FRAMEBUFFER,pt.__webglMultisampledFramebuffer)}else if(A.depthBuffer&&A.storeMultisampledDepthBuffer===!1&&c){let v=A.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[v])}}}function ve(A){return Math.min(s.maxSamples,A.samples)}function gt(A){let v=i.get(A);return A.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&v.__useRenderToTexture!==!1}function ke(A){let v=o.render.frame;h.get(A)!==v&&(h.set(A,v),A.update())}function Gt(A,v){let B=A.colorSpace,it=A.format,K=A.type;return A.isCompressedTexture===!0||A.isVideoTexture===!0||B!==Vo&&B!==Ji&&(re.getTransfer(B)===ue?(it!==hi||K!==Sn)&&Bt("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Wt("WebGLTextures: Unsupported texture color space:",B)),v}function Xt(A){return typeof HTMLImageElement<"u"&&A instanceof HTMLImageElement?(l.width=A.naturalWidth||A.width,l.height=A.naturalHeight||A.height):typeof VideoFrame<"u"&&A instanceof VideoFrame?(l.width=A.displayWidth,l.height=A.displayHeight):(l.width=A.width,l.height=A.height),l}this.allocateTextureUnit=jt,this.resetTextureUnits=Q,this.getTextureUnits=tt,this.setTextureUnits=Pt,this.setTexture2D=vt,this.setTexture2DArray=Tt,this.setTexture3D=zt,this.setTextureCube=bt,this.rebindTextures=zn,this.setupRenderTarget=Gn,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=ye,this.setupDepthRenderbuffer=Bn,this.setupFrameBufferTexture=Se,this.useMultisampledRTT=gt,this.dispose=H}function aC(n,t){function e(i,s=Ji){let r,o=re.getTransfer(s);if(i===Sn)return n.UNSIGNED_BYTE;if(i===Xl)return n.UNSIGNED_SHORT_4_4_4_4;if(i===jl)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Pf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Lf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Cf)return n.BYTE;if(i===If)return n.SHORT;if(i===to)return n.UNSIGNED_SHORT;if(i===ql)return n.INT;if(i===ci)return n.UNSIGNED_INT;if(i===Yn)return n.FLOAT;if(i===li)return n.HALF_FLOAT;if(i===Nf)return n.ALPHA;if(i===Df)return n.RGB;if(i===hi)return n.RGBA;if(i===Wi)return n.DEPTH_COMPONENT;if(i===Yi)return n.DEPTH_STENCIL;if(i===Yl)return n.RED;if(i===Jl)return n.RED_INTEGER;if(i===bs)return n.RG;if(i===Zl)return n.RG_INTEGER;if(i===Kl)return n.RGBA_INTEGER;if(i===xa||i===_a||i===ya||i===va)if(o===ue)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===xa)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===_a)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===va)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===xa)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===_a)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===ya)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===va)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ql||i===th||i===eh||i===nh)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ql)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===th)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===eh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===nh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===ih||i===sh||i===rh||i===oh||i===ah||i===ba||i===ch)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(i===ih||i===sh)return o===ue?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===rh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===oh)return r.COMPRESSED_R11_EAC;if(i===ah)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ba)return r.COMPRESSED_RG11_EAC;if(i===ch)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===lh||i===hh||i===uh||i===dh||i===fh||i===ph||i===mh||i===gh||i===xh||i===_h||i===yh||i===vh||i===bh||i===wh)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(i===lh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===hh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===uh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===dh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===fh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===ph)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===mh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===gh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===xh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===_h)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===yh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===vh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===bh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===wh)return o===ue?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Mh||i===Sh||i===Eh)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(i===Mh)return o===ue?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Sh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Eh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Th||i===Ah||i===wa||i===Rh)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(i===Th)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ah)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===wa)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Rh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===rr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:e}}var cC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,lC=`
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

}`,sp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let i=new ea(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=i}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,i=new jn({vertexShader:cC,fragmentShader:lC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new Ue(new tr(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},rp=class extends ai{constructor(t,e){super();let i=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,p=null,m=typeof XRWebGLBinding<"u",g=new sp,x={},_=e.getContextAttributes(),b=null,M=null,T=[],E=[],y=new St,S=null,D=null,L=new fn;L.viewport=new be;let U=new fn;U.viewport=new be;let k=[L,U],G=new Vl,I=null,H=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(J){let vt=T[J];return vt===void 0&&(vt=new qr,T[J]=vt),vt.getTargetRaySpace()},this.getControllerGrip=function(J){let vt=T[J];return vt===void 0&&(vt=new qr,T[J]=vt),vt.getGripSpace()},this.getHand=function(J){let vt=T[J];return vt===void 0&&(vt=new qr,T[J]=vt),vt.getHandSpace()};function X(J){let vt=E.indexOf(J.inputSource);if(vt===-1)return;let Tt=T[vt];Tt!==void 0&&(Tt.update(J.inputSource,J.frame,l||o),Tt.dispatchEvent({type:J.type,data:J.inputSource}))}function W(){s.removeEventListener("select",X),s.removeEventListener("selectstart",X),s.removeEventListener("selectend",X),s.removeEventListener("squeeze",X),s.removeEventListener("squeezestart",X),s.removeEventListener("squeezeend",X),s.removeEventListener("end",W),s.removeEventListener("inputsourceschange",st);for(let J=0;J<T.length;J++){let vt=E[J];vt!==null&&(E[J]=null,T[J].disconnect(vt))}I=null,H=null,g.reset();for(let J in x)delete x[J];if(t.setRenderTarget(b),f=null,d=null,u=null,s=null,M=null,jt.stop(),i.isPresenting=!1,t.setPixelRatio(S),t.setSize(y.width,y.height,!1),D!==null){let J=D.camera;J.fov=D.fov,J.zoom=D.zoom,J.updateProjectionMatrix(),D=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(J){r=J,i.isPresenting===!0&&Bt("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(J){a=J,i.isPresenting===!0&&Bt("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(J){l=J},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&m&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(J){if(s=J,s!==null){if(b=t.getRenderTarget(),s.addEventListener("select",X),s.addEventListener("selectstart",X),s.addEventListener("selectend",X),s.addEventListener("squeeze",X),s.addEventListener("squeezestart",X),s.addEventListener("squeezeend",X),s.addEventListener("end",W),s.addEventListener("inputsourceschange",st),_.xrCompatible!==!0&&await e.makeXRCompatible(),S=t.getPixelRatio(),t.getSize(y),m&&"createProjectionLayer"in XRWebGLBinding.prototype){let Tt=null,zt=null,bt=null;_.depth&&(bt=_.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,Tt=_.stencil?Yi:Wi,zt=_.stencil?rr:ci);let Jt={colorFormat:e.RGBA8,depthFormat:bt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Jt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),M=new Dn(d.textureWidth,d.textureHeight,{format:hi,type:Sn,depthTexture:new Xi(d.textureWidth,d.textureHeight,zt,void 0,void 0,void 0,void 0,void 0,void 0,Tt),stencilBuffer:_.stencil,colorSpace:t.outputColorSpace,samples:_.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let Tt={antialias:_.antialias,alpha:!0,depth:_.depth,stencil:_.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,Tt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new Dn(f.framebufferWidth,f.framebufferHeight,{format:hi,type:Sn,colorSpace:t.outputColorSpace,stencilBuffer:_.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),jt.setContext(s),jt.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function st(J){for(let vt=0;vt<J.removed.length;vt++){let Tt=J.removed[vt],zt=E.indexOf(Tt);zt>=0&&(E[zt]=null,T[zt].disconnect(Tt))}for(let vt=0;vt<J.added.length;vt++){let Tt=J.added[vt],zt=E.indexOf(Tt);if(zt===-1){for(let Jt=0;Jt<T.length;Jt++)if(Jt>=E.length){E.push(Tt),zt=Jt;break}else if(E[Jt]===null){E[Jt]=Tt,zt=Jt;break}if(zt===-1)break}let bt=T[zt];bt&&bt.connect(Tt)}}function q(J,vt){vt===null?J.matrixWorld.copy(J.matrix):J.matrixWorld.multiplyMatrices(vt.matrixWorld,J.matrix),J.matrixWorldInverse.copy(J.matrixWorld).invert()}this.updateCamera=function(J){if(s===null)return;let vt=J.near,Tt=J.far;g.texture!==null&&(g.depthNear>0&&(vt=g.depthNear),g.depthFar>0&&(Tt=g.depthFar)),G.near=U.near=L.near=vt,G.far=U.far=L.far=Tt,(I!==G.near||H!==G.far)&&(s.updateRenderState({depthNear:G.near,depthFar:G.far}),I=G.near,H=G.far),G.layers.mask=J.layers.mask|6,L.layers.mask=G.layers.mask&-5,U.layers.mask=G.layers.mask&-3;let zt=J.parent,bt=G.cameras;q(G,zt);for(let Jt=0;Jt<bt.length;Jt++)q(bt[Jt],zt);G.projectionMatrix.copy(L.projectionMatrix),G.projectionMatrixInverse.copy(L.projectionMatrixInverse),D===null&&J.isPerspectiveCamera&&(D={camera:J,fov:J.fov,zoom:J.zoom}),Q(J,G,zt)};function Q(J,vt,Tt){Tt===null?J.matrix.copy(vt.matrixWorld):(J.matrix.copy(Tt.matrixWorld),J.matrix.invert(),J.matrix.multiply(vt.matrixWorld)),J.matrix.decompose(J.position,J.quaternion,J.scale),J.updateMatrixWorld(!0),J.projectionMatrix.copy(vt.projectionMatrix),J.projectionMatrixInverse.copy(vt.projectionMatrixInverse),J.isPerspectiveCamera&&(J.fov=Hr*2*Math.atan(1/J.projectionMatrix.elements[5]),J.zoom=1)}this.getCamera=function(){return G},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(J){c=J,d!==null&&(d.fixedFoveation=J),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=J)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(G)},this.getCameraTexture=function(J){return x[J]};let tt=null;function Pt(J,vt){if(h=vt.getViewerPose(l||o),p=vt,h!==null){let Tt=h.views;f!==null&&(t.setRenderTargetFramebuffer(M,f.framebuffer),t.setRenderTarget(M));let zt=!1;Tt.length!==G.cameras.length&&(G.cameras.length=0,zt=!0);for(let Vt=0;Vt<Tt.length;Vt++){let fe=Tt[Vt],me=null;if(f!==null)me=f.getViewport(fe);else{let je=u.getViewSubImage(d,fe);me=je.viewport,Vt===0&&(t.setRenderTargetTextures(M,je.colorTexture,je.depthStencilTexture),t.setRenderTarget(M))}let ne=k[Vt];ne===void 0&&(ne=new fn,ne.layers.enable(Vt),ne.viewport=new be,k[Vt]=ne),ne.matrix.fromArray(fe.transform.matrix),ne.matrix.decompose(ne.position,ne.quaternion,ne.scale),ne.projectionMatrix.fromArray(fe.projectionMatrix),ne.projectionMatrixInverse.copy(ne.projectionMatrix).invert(),ne.viewport.set(me.x,me.y,me.width,me.height),Vt===0&&(G.matrix.copy(ne.matrix),G.matrix.decompose(G.position,G.quaternion,G.scale)),zt===!0&&G.cameras.push(ne)}let bt=s.enabledFeatures;if(bt&&bt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&m){u=i.getBinding();let Vt=u.getDepthInformation(Tt[0]);Vt&&Vt.isValid&&Vt.texture&&g.init(Vt,s.renderState)}if(bt&&bt.includes("camera-access")&&m){t.state.unbindTexture(),u=i.getBinding();for(let Vt=0;Vt<Tt.length;Vt++){let fe=Tt[Vt].camera;if(fe){let me=x[fe];me||(me=new ea,x[fe]=me);let ne=u.getCameraImage(fe);me.sourceTexture=ne}}}}for(let Tt=0;Tt<T.length;Tt++){let zt=E[Tt],bt=T[Tt];zt!==null&&bt!==void 0&&bt.update(zt,vt,l||o)}tt&&tt(J,vt),vt.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:vt}),p=null}let jt=new kx;jt.setAnimationLoop(Pt),this.setAnimationLoop=function(J){tt=J},this.dispose=function(){}}},hC=new ce,jx=new qt;jx.set(-1,0,0,0,1,0,0,0,1);function uC(n,t){function e(g,x){g.matrixAutoUpdate===!0&&g.updateMatrix(),x.value.copy(g.matrix)}function i(g,x){x.color.getRGB(g.fogColor.value,qf(n)),x.isFog?(g.fogNear.value=x.near,g.fogFar.value=x.far):x.isFogExp2&&(g.fogDensity.value=x.density)}function s(g,x,_,b,M){x.isNodeMaterial?x.uniformsNeedUpdate=!1:x.isMeshBasicMaterial?r(g,x):x.isMeshLambertMaterial?(r(g,x),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)):x.isMeshToonMaterial?(r(g,x),u(g,x)):x.isMeshPhongMaterial?(r(g,x),h(g,x),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)):x.isMeshStandardMaterial?(r(g,x),d(g,x),x.isMeshPhysicalMaterial&&f(g,x,M)):x.isMeshMatcapMaterial?(r(g,x),p(g,x)):x.isMeshDepthMaterial?r(g,x):x.isMeshDistanceMaterial?(r(g,x),m(g,x)):x.isMeshNormalMaterial?r(g,x):x.isLineBasicMaterial?(o(g,x),x.isLineDashedMaterial&&a(g,x)):x.isPointsMaterial?c(g,x,_,b):x.isSpriteMaterial?l(g,x):x.isShadowMaterial?(g.color.value.copy(x.color),g.opacity.value=x.opacity):x.isShaderMaterial&&(x.uniformsNeedUpdate=!1)}function r(g,x){g.opacity.value=x.opacity,x.color&&g.diffuse.value.copy(x.color),x.emissive&&g.emissive.value.copy(x.emissive).multiplyScalar(x.emissiveIntensity),x.map&&(g.map.value=x.map,e(x.map,g.mapTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,e(x.alphaMap,g.alphaMapTransform)),x.bumpMap&&(g.bumpMap.value=x.bumpMap,e(x.bumpMap,g.bumpMapTransform),g.bumpScale.value=x.bumpScale,x.side===gn&&(g.bumpScale.value*=-1)),x.normalMap&&(g.normalMap.value=x.normalMap,e(x.normalMap,g.normalMapTransform),g.normalScale.value.copy(x.normalScale),x.side===gn&&g.normalScale.value.negate()),x.displacementMap&&(g.displacementMap.value=x.displacementMap,e(x.displacementMap,g.displacementMapTransform),g.displacementScale.value=x.displacementScale,g.displacementBias.value=x.displacementBias),x.emissiveMap&&(g.emissiveMap.value=x.emissiveMap,e(x.emissiveMap,g.emissiveMapTransform)),x.specularMap&&(g.specularMap.value=x.specularMap,e(x.specularMap,g.specularMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest);let _=t.get(x),b=_.envMap,M=_.envMapRotation;b&&(g.envMap.value=b,g.envMapRotation.value.setFromMatrix4(hC.makeRotationFromEuler(M)).transpose(),b.isCubeTexture&&b.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(jx),g.reflectivity.value=x.reflectivity,g.ior.value=x.ior,g.refractionRatio.value=x.refractionRatio),x.lightMap&&(g.lightMap.value=x.lightMap,g.lightMapIntensity.value=x.lightMapIntensity,e(x.lightMap,g.lightMapTransform)),x.aoMap&&(g.aoMap.value=x.aoMap,g.aoMapIntensity.value=x.aoMapIntensity,e(x.aoMap,g.aoMapTransform))}function o(g,x){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,x.map&&(g.map.value=x.map,e(x.map,g.mapTransform))}function a(g,x){g.dashSize.value=x.dashSize,g.totalSize.value=x.dashSize+x.gapSize,g.scale.value=x.scale}function c(g,x,_,b){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,g.size.value=x.size*_,g.scale.value=b*.5,x.map&&(g.map.value=x.map,e(x.map,g.uvTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,e(x.alphaMap,g.alphaMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest)}function l(g,x){g.diffuse.value.copy(x.color),g.opacity.value=x.opacity,g.rotation.value=x.rotation,x.map&&(g.map.value=x.map,e(x.map,g.mapTransform)),x.alphaMap&&(g.alphaMap.value=x.alphaMap,e(x.alphaMap,g.alphaMapTransform)),x.alphaTest>0&&(g.alphaTest.value=x.alphaTest)}function h(g,x){g.specular.value.copy(x.specular),g.shininess.value=Math.max(x.shininess,1e-4)}function u(g,x){x.gradientMap&&(g.gradientMap.value=x.gradientMap)}function d(g,x){g.metalness.value=x.metalness,x.metalnessMap&&(g.metalnessMap.value=x.metalnessMap,e(x.metalnessMap,g.metalnessMapTransform)),g.roughness.value=x.roughness,x.roughnessMap&&(g.roughnessMap.value=x.roughnessMap,e(x.roughnessMap,g.roughnessMapTransform)),x.envMap&&(g.envMapIntensity.value=x.envMapIntensity)}function f(g,x,_){g.ior.value=x.ior,x.diffuseRoughness>0&&(g.diffuseRoughness.value=x.diffuseRoughness,x.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=x.diffuseRoughnessMap,e(x.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),x.sheen>0&&(g.sheenColor.value.copy(x.sheenColor).multiplyScalar(x.sheen),g.sheenRoughness.value=x.sheenRoughness,x.sheenColorMap&&(g.sheenColorMap.value=x.sheenColorMap,e(x.sheenColorMap,g.sheenColorMapTransform)),x.sheenRoughnessMap&&(g.sheenRoughnessMap.value=x.sheenRoughnessMap,e(x.sheenRoughnessMap,g.sheenRoughnessMapTransform))),x.clearcoat>0&&(g.clearcoat.value=x.clearcoat,g.clearcoatRoughness.value=x.clearcoatRoughness,x.clearcoatMap&&(g.clearcoatMap.value=x.clearcoatMap,e(x.clearcoatMap,g.clearcoatMapTransform)),x.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=x.clearcoatRoughnessMap,e(x.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),x.clearcoatNormalMap&&(g.clearcoatNormalMap.value=x.clearcoatNormalMap,e(x.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(x.clearcoatNormalScale),x.side===gn&&g.clearcoatNormalScale.value.negate())),x.dispersion>0&&(g.dispersion.value=x.dispersion),x.retroreflectivity>0&&(g.retroreflectivity.value=x.retroreflectivity),x.iridescence>0&&(g.iridescence.value=x.iridescence,g.iridescenceIOR.value=x.iridescenceIOR,g.iridescenceThicknessMinimum.value=x.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=x.iridescenceThicknessMaximum,x.iridescenceMap&&(g.iridescenceMap.value=x.iridescenceMap,e(x.iridescenceMap,g.iridescenceMapTransform)),x.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=x.iridescenceThicknessMap,e(x.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),x.transmission>0&&(g.transmission.value=x.transmission,g.transmissionSamplerMap.value=_.texture,g.transmissionSamplerSize.value.set(_.width,_.height),x.transmissionMap&&(g.transmissionMap.value=x.transmissionMap,e(x.transmissionMap,g.transmissionMapTransform)),g.thickness.value=x.thickness,x.thicknessMap&&(g.thicknessMap.value=x.thicknessMap,e(x.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=x.attenuationDistance,g.attenuationColor.value.copy(x.attenuationColor)),x.anisotropy>0&&(g.anisotropyVector.value.set(x.anisotropy*Math.cos(x.anisotropyRotation),x.anisotropy*Math.sin(x.anisotropyRotation)),x.anisotropyMap&&(g.anisotropyMap.value=x.anisotropyMap,e(x.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=x.specularIntensity,g.specularColor.value.copy(x.specularColor),x.specularColorMap&&(g.specularColorMap.value=x.specularColorMap,e(x.specularColorMap,g.specularColorMapTransform)),x.specularIntensityMap&&(g.specularIntensityMap.value=x.specularIntensityMap,e(x.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,x){x.matcap&&(g.matcap.value=x.matcap)}function m(g,x){let _=t.get(x).light;g.referencePosition.value.setFromMatrixPosition(_.matrixWorld),g.nearDistance.value=_.shadow.camera.near,g.farDistance.value=_.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function dC(n,t,e,i){let s={},r={};function o(_,b){let M=b.program;i.uniformBlockBinding(_,M,s[_.id])}function a(_,b){let M=s[_.id];M===void 0&&(p(_),M=c(_),s[_.id]=M,_.addEventListener("dispose",g));let T=b.program;i.updateUBOMapping(_,T);let E=t.render.frame;r[_.id]!==E&&(l(_),r[_.id]=E)}function c(_){let b=n.createBuffer(),M=_.__size,T=_.usage;return n.bindBuffer(n.UNIFORM_BUFFER,b),n.bufferData(n.UNIFORM_BUFFER,M,T),n.bindBuffer(n.UNIFORM_BUFFER,null),b}function l(_){let b=s[_.id],M=_.uniforms,T=_.__cache;n.bindBuffer(n.UNIFORM_BUFFER,b);for(let E=0,y=M.length;E<y;E++){let S=M[E];if(Array.isArray(S))for(let D=0,L=S.length;D<L;D++)h(S[D],E,D,T);else h(S,E,0,T)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function h(_,b,M,T){if(d(_,b,M,T)===!0){let E=_.__offset,y=_.value;if(Array.isArray(y)){let S=0;for(let D=0;D<y.length;D++){let L=y[D],U=m(L,!0);u(L,_.__data,S),S+=U.storage/Float32Array.BYTES_PER_ELEMENT}}else u(y,_.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,_.__data)}}function u(_,b,M){typeof _=="number"||typeof _=="boolean"?b[M]=_:_.isMatrix3?(b[M]=_.elements[0],b[M+1]=_.elements[1],b[M+2]=_.elements[2],b[M+3]=0,b[M+4]=_.elements[3],b[M+5]=_.elements[4],b[M+6]=_.elements[5],b[M+7]=0,b[M+8]=_.elements[6],b[M+9]=_.elements[7],b[M+10]=_.elements[8],b[M+11]=0):ArrayBuffer.isView(_)?b.set(_.subarray(0,b.length-M),M):_.toArray(b,M)}function d(_,b,M,T){let E=_.value,y=b+"_"+M;if(Array.isArray(E)){T[y]===void 0&&(T[y]=[]);let S=T[y],D=!1;for(let L=0;L<E.length;L++)f(E[L],S,L)===!0&&(D=!0);return D}return f(E,T,y)}function f(_,b,M){if(b[M]===void 0)return typeof _=="number"||typeof _=="boolean"?b[M]=_:ArrayBuffer.isView(_)?b[M]=_.slice():b[M]=_.clone(),!0;{let T=b[M];if(typeof _=="number"||typeof _=="boolean"){if(T!==_)return b[M]=_,!0}else{if(ArrayBuffer.isView(_))return!0;if(T.equals(_)===!1)return T.copy(_),!0}}return!1}function p(_){let b=_.uniforms,M=0,T=16;for(let y=0,S=b.length;y<S;y++){let D=Array.isArray(b[y])?b[y]:[b[y]];for(let L=0,U=D.length;L<U;L++){let k=D[L],G=Array.isArray(k.value)?k.value:[k.value],I=Array.isArray(b[y])||Array.isArray(k.value),H=M;for(let W=0,st=G.length;W<st;W++){let q=G[W],Q=m(q,I),tt=M%T,Pt=tt%Q.boundary,jt=tt+Pt;M+=Pt,jt!==0&&T-jt<Q.storage&&(M+=T-jt),W===0&&(H=M),M+=Q.storage}let X=k.type==="int"?Int32Array:k.type==="uint"?Uint32Array:Float32Array;k.__data=new X((M-H)/Float32Array.BYTES_PER_ELEMENT),k.__offset=H}}let E=M%T;return E>0&&(M+=T-E),_.__size=M,_.__cache={},this}function m(_,b){let M={boundary:0,storage:0};return typeof _=="number"||typeof _=="boolean"?(M.boundary=4,M.storage=4):_.isVector2?(M.boundary=8,M.storage=8):_.isVector3||_.isColor?(M.boundary=16,M.storage=12):_.isVector4?(M.boundary=16,M.storage=16):_.isMatrix3?(M.boundary=16,M.storage=48):_.isMatrix4?(M.boundary=16,M.storage=64):_.isTexture?Bt("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(_)?(M.boundary=16,M.storage=_.byteLength):Bt("WebGLRenderer: Unsupported uniform value type.",_),b===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(_){let b=_.target;b.removeEventListener("dispose",g),n.deleteBuffer(s[b.id]),delete s[b.id],delete r[b.id]}function x(){for(let _ in s)n.deleteBuffer(s[_]);s={},r={}}return{bind:o,update:a,dispose:x}}var fC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Ti=null;function pC(){return Ti===null&&(Ti=new Yo(fC,16,16,bs,li),Ti.name="DFG_LUT",Ti.minFilter=pn,Ti.magFilter=pn,Ti.wrapS=wi,Ti.wrapT=wi,Ti.generateMipmaps=!1,Ti.needsUpdate=!0),Ti}var Nh=class{constructor(t={}){let{canvas:e=ax(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=Sn}=t;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let m=f,g=new Set([Kl,Zl,Jl]),x=new Set([Sn,ci,to,rr,Xl,jl]),_=new Uint32Array(4),b=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},T=null,E=null,y=[],S=[],D=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Ei,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let L=this,U=!1,k=null,G=null,I=null,H=null;this._outputColorSpace=Nn;let X=0,W=0,st=null,q=-1,Q=null,tt=new be,Pt=new be,jt=null,J=new $t(0),vt=0,Tt=e.width,zt=e.height,bt=1,Jt=null,Ne=null,Vt=new be(0,0,Tt,zt),fe=new be(0,0,Tt,zt),me=!1,ne=new fs,je=new xl,Fe=!1,_n=!1,Se=new ce,pi=new P,Ve=new be,Bn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},zn=!1;function Gn(){return st===null?bt:1}let O=i;function Vn(w,N){return e.getContext(w,N)}let ye,ve,gt,ke,Gt,Xt,A,v,B,it,K,lt,pt,j,Y,ut,C,Z,$,dt,ct,ht,Ut;try{let w={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Ft,!1),e.addEventListener("webglcontextrestored",Zt,!1),e.addEventListener("webglcontextcreationerror",_t,!1),O===null){let N="webgl2";if(O=Vn(N,w),O===null)throw Vn(N)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}Kt()}catch(w){throw e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Zt,!1),e.removeEventListener("webglcontextcreationerror",_t,!1),Wt("WebGLRenderer: "+w.message),w}function Kt(){ye=new EA(O),ye.init(),ct=new aC(O,ye),ve=new pA(O,ye,t,ct),gt=new rC(O,ye),ve.reversedDepthBuffer&&d&&gt.buffers.depth.setReversed(!0),G=O.createFramebuffer(),I=O.createFramebuffer(),H=O.createFramebuffer(),ke=new RA(O),Gt=new $R,Xt=new oC(O,ye,gt,Gt,ve,ct,ke),A=new SA(L),v=new I1(O),ht=new dA(O,v),B=new TA(O,v,ke,ht),it=new IA(O,B,v,ht,ke),Z=new CA(O,ve,Xt),Y=new mA(Gt),K=new WR(L,A,ye,ve,ht,Y),lt=new uC(L,Gt),pt=new XR,j=new QR(ye),C=new uA(L,A,gt,it,p,c),ut=new sC(L,it,ve),Ut=new dC(O,ke,ve,gt),$=new fA(O,ye,ke),dt=new AA(O,ye,ke),ke.programs=K.programs,L.capabilities=ve,L.extensions=ye,L.properties=Gt,L.renderLists=pt,L.shadowMap=ut,L.state=gt,L.info=ke}m!==Sn&&(D=new LA(m,e.width,e.height,a,s,r));let rt=new rp(L,O);this.xr=rt,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let w=ye.get("WEBGL_lose_context");w&&w.loseContext()},this.forceContextRestore=function(){let w=ye.get("WEBGL_lose_context");w&&w.restoreContext()},this.getPixelRatio=function(){return bt},this.setPixelRatio=function(w){w!==void 0&&(bt=w,this.setSize(Tt,zt,!1))},this.getSize=function(w){return w.set(Tt,zt)},this.setSize=function(w,N,V=!0){if(rt.isPresenting){Bt("WebGLRenderer: Can't change size while VR device is presenting.");return}Tt=w,zt=N,e.width=Math.floor(w*bt),e.height=Math.floor(N*bt),V===!0&&(e.style.width=w+"px",e.style.height=N+"px"),D!==null&&D.setSize(e.width,e.height),this.setViewport(0,0,w,N)},this.getDrawingBufferSize=function(w){return w.set(Tt*bt,zt*bt).floor()},this.setDrawingBufferSize=function(w,N,V){Tt=w,zt=N,bt=V,e.width=Math.floor(w*V),e.height=Math.floor(N*V),this.setViewport(0,0,w,N)},this.setEffects=function(w){if(m===Sn){Wt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(w){for(let N=0;N<w.length;N++)if(w[N].isOutputPass===!0){Bt("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}D.setEffects(w||[])},this.getCurrentViewport=function(w){return w.copy(tt)},this.getViewport=function(w){return w.copy(Vt)},this.setViewport=function(w,N,V,F){w.isVector4?Vt.set(w.x,w.y,w.z,w.w):Vt.set(w,N,V,F),gt.viewport(tt.copy(Vt).multiplyScalar(Gn()).round())},this.getScissor=function(w){return w.copy(fe)},this.setScissor=function(w,N,V,F){w.isVector4?fe.set(w.x,w.y,w.z,w.w):fe.set(w,N,V,F),gt.scissor(Pt.copy(fe).multiplyScalar(Gn()).round())},this.getScissorTest=function(){return me},this.setScissorTest=function(w){gt.setScissorTest(me=w)},this.setOpaqueSort=function(w){Jt=w},this.setTransparentSort=function(w){Ne=w},this.getClearColor=function(w){return w.copy(C.getClearColor())},this.setClearColor=function(){C.setClearColor(...arguments)},this.getClearAlpha=function(){return C.getClearAlpha()},this.setClearAlpha=function(){C.setClearAlpha(...arguments)},this.clear=function(w=!0,N=!0,V=!0){let F=0;if(w){let z=!1;if(st!==null){let mt=st.texture.format;z=g.has(mt)}if(z){let mt=st.texture.type,Et=x.has(mt),ft=C.getClearColor(),wt=C.getClearAlpha(),Lt=ft.r,Yt=ft.g,ie=ft.b;Et?(_[0]=Lt,_[1]=Yt,_[2]=ie,_[3]=wt,O.clearBufferuiv(O.COLOR,0,_)):(b[0]=Lt,b[1]=Yt,b[2]=ie,b[3]=wt,O.clearBufferiv(O.COLOR,0,b))}else F|=O.COLOR_BUFFER_BIT}N&&(F|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),V&&(F|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),F!==0&&O.clear(F)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(w){w.setRenderer(this),k=w},this.dispose=function(){e.removeEventListener("webglcontextlost",Ft,!1),e.removeEventListener("webglcontextrestored",Zt,!1),e.removeEventListener("webglcontextcreationerror",_t,!1),C.dispose(),pt.dispose(),j.dispose(),Xt.dispose(),Gt.dispose(),A.dispose(),it.dispose(),B.dispose(),ht.dispose(),Ut.dispose(),K.dispose(),rt.dispose(),rt.removeEventListener("sessionstart",Pm),rt.removeEventListener("sessionend",Lm),Fs.stop()};function Ft(w){w.preventDefault(),zf("WebGLRenderer: Context Lost."),U=!0}function Zt(){zf("WebGLRenderer: Context Restored."),U=!1;let w=ke.autoReset,N=ut.enabled,V=ut.autoUpdate,F=ut.needsUpdate,z=ut.type;Kt(),ke.autoReset=w,ut.enabled=N,ut.autoUpdate=V,ut.needsUpdate=F,ut.type=z}function _t(w){Wt("WebGLRenderer: A WebGL context could not be created. Reason: ",w.statusMessage)}function pe(w){let N=w.target;N.removeEventListener("dispose",pe),He(N)}function He(w){ts(w),Gt.remove(w)}function ts(w){let N=Gt.get(w).programs;N!==void 0&&(N.forEach(function(V){K.releaseProgram(V)}),w.isShaderMaterial&&K.releaseShaderCache(w))}this.renderBufferDirect=function(w,N,V,F,z,mt){N===null&&(N=Bn);let Et=z.isMesh&&z.matrixWorld.determinantAffine()<0,ft=nM(w,N,V,F,z);gt.setMaterial(F,Et);let wt=V.index,Lt=1;if(F.wireframe===!0){if(wt=B.getWireframeAttribute(V),wt===void 0)return;Lt=2}let Yt=V.drawRange,ie=V.attributes.position,At=Yt.start*Lt,se=(Yt.start+Yt.count)*Lt;mt!==null&&(At=Math.max(At,mt.start*Lt),se=Math.min(se,(mt.start+mt.count)*Lt)),wt!==null?(At=Math.max(At,0),se=Math.min(se,wt.count)):ie!=null&&(At=Math.max(At,0),se=Math.min(se,ie.count));let De=se-At;if(De<0||De===1/0)return;ht.setup(z,F,ft,V,wt);let xe,ge=$;if(wt!==null&&(xe=v.get(wt),ge=dt,ge.setIndex(xe)),z.isMesh)F.wireframe===!0?(gt.setLineWidth(F.wireframeLinewidth*Gn()),ge.setMode(O.LINES)):ge.setMode(O.TRIANGLES);else if(z.isLine){let tn=F.linewidth;tn===void 0&&(tn=1),gt.setLineWidth(tn*Gn()),z.isLineSegments?ge.setMode(O.LINES):z.isLineLoop?ge.setMode(O.LINE_LOOP):ge.setMode(O.LINE_STRIP)}else z.isPoints?ge.setMode(O.POINTS):z.isSprite&&ge.setMode(O.TRIANGLES);if(z.isBatchedMesh)if(ye.get("WEBGL_multi_draw"))ge.renderMultiDraw(z._multiDrawStarts,z._multiDrawCounts,z._multiDrawCount);else{let tn=z._multiDrawStarts,Rt=z._multiDrawCounts,an=z._multiDrawCount,le=wt?v.get(wt).bytesPerElement:1,ks=Gt.get(F).currentProgram.getUniforms();for(let en=0;en<an;en++)ks.setValue(O,"_gl_DrawID",en),ge.render(tn[en]/le,Rt[en])}else if(z.isInstancedMesh)ge.renderInstances(At,De,z.count);else if(V.isInstancedBufferGeometry){let tn=V._maxInstanceCount!==void 0?V._maxInstanceCount:1/0,Rt=Math.min(V.instanceCount,tn);ge.renderInstances(At,De,Rt)}else ge.render(At,De)};function Im(w,N,V,F){k!==null&&w.isNodeMaterial&&k.setObject(F,w),Fe===!0&&Y.setState(w,V,!1),w.transparent===!0&&w.side===Mn&&w.forceSinglePass===!1?(w.side=gn,w.needsUpdate=!0,po(w,N,F),w.side=vs,w.needsUpdate=!0,po(w,N,F),w.side=Mn):po(w,N,F)}this.compile=function(w,N,V=null){V===null&&(V=w),k!==null&&k.renderStart(w,N,V),E=j.get(V),E.init(N),S.push(E),V.traverseVisible(function(z){z.isLight&&z.layers.test(N.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),w!==V&&w.traverseVisible(function(z){z.isLight&&z.layers.test(N.layers)&&(E.pushLight(z),z.castShadow&&E.pushShadow(z))}),E.setupLights(),k!==null&&k.updateLights(E.state.lightsArray),_n=this.localClippingEnabled,Fe=Y.init(this.clippingPlanes,_n),Fe===!0&&Y.setGlobalState(this.clippingPlanes,N),k!==null&&ut.render(E.state.shadowsArray,V,N);let F=new Set;return w.traverse(function(z){if(!(z.isMesh||z.isPoints||z.isLine||z.isSprite))return;let mt=z.material;if(mt)if(Array.isArray(mt))for(let Et=0;Et<mt.length;Et++){let ft=mt[Et];Im(ft,V,N,z),F.add(ft)}else Im(mt,V,N,z),F.add(mt)}),E=S.pop(),k!==null&&k.renderEnd(),F},this.compileAsync=function(w,N,V=null){let F=this.compile(w,N,V);return new Promise(z=>{function mt(){if(F.forEach(function(Et){let wt=Gt.get(Et).currentProgram;(wt===void 0||wt.isReady())&&F.delete(Et)}),F.size===0){z(w);return}setTimeout(mt,10)}ye.get("KHR_parallel_shader_compile")!==null?mt():setTimeout(mt,10)})};let Ju=null;function tM(w){Ju&&Ju(w)}function Pm(){Fs.stop()}function Lm(){Fs.start()}let Fs=new kx;Fs.setAnimationLoop(tM),typeof self<"u"&&Fs.setContext(self),this.setAnimationLoop=function(w){Ju=w,rt.setAnimationLoop(w),w===null?Fs.stop():Fs.start()},rt.addEventListener("sessionstart",Pm),rt.addEventListener("sessionend",Lm),this.render=function(w,N){if(N!==void 0&&N.isCamera!==!0){Wt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(U===!0)return;k!==null&&k.renderStart(w,N);let V=rt.enabled===!0&&rt.isPresenting===!0,F=D!==null&&(st===null||V)&&D.begin(L,st);if(w.matrixWorldAutoUpdate===!0&&w.updateMatrixWorld(),N.parent===null&&N.matrixWorldAutoUpdate===!0&&N.updateMatrixWorld(),rt.enabled===!0&&rt.isPresenting===!0&&(D===null||D.isCompositing()===!1)&&(rt.cameraAutoUpdate===!0&&rt.updateCamera(N),N=rt.getCamera()),w.isScene===!0&&w.onBeforeRender(L,w,N,st),E=j.get(w,S.length),E.init(N),E.state.textureUnits=Xt.getTextureUnits(),S.push(E),Se.multiplyMatrices(N.projectionMatrix,N.matrixWorldInverse),N.isArrayCamera?je.setFromArrayCamera(N):ne.setFromProjectionMatrix(Se,qn,N.reversedDepth),_n=this.localClippingEnabled,Fe=Y.init(this.clippingPlanes,_n),T=pt.get(w,y.length),T.init(),y.push(T),this.info.render.frame++,rt.enabled===!0&&rt.isPresenting===!0){let Et=L.xr.getDepthSensingMesh();Et!==null&&Zu(Et,N,-1/0,L.sortObjects)}Zu(w,N,0,L.sortObjects),T.finish(),k!==null&&k.updateLights(E.state.lightsArray),L.sortObjects===!0&&T.sort(Jt,Ne),zn=rt.enabled===!1||rt.isPresenting===!1||rt.hasDepthSensing()===!1,zn&&C.addToRenderList(T,w),this.info.autoReset===!0&&this.info.reset(),Fe===!0&&Y.beginShadows();let z=E.state.shadowsArray;if(ut.render(z,w,N),Fe===!0&&Y.endShadows(),(F&&D.hasRenderPass())===!1){let Et=T.opaque,ft=T.transmissive;if(E.setupLights(),N.isArrayCamera){let wt=N.cameras;if(ft.length>0)for(let Lt=0,Yt=wt.length;Lt<Yt;Lt++){let ie=wt[Lt];Dm(Et,ft,w,ie)}zn&&C.render(w);for(let Lt=0,Yt=wt.length;Lt<Yt;Lt++){let ie=wt[Lt];Nm(T,w,ie,ie.viewport)}}else ft.length>0&&Dm(Et,ft,w,N),zn&&C.render(w),Nm(T,w,N)}st!==null&&W===0&&(Xt.updateMultisampleRenderTarget(st),Xt.updateRenderTargetMipmap(st)),F&&D.end(L),w.isScene===!0&&w.onAfterRender(L,w,N),ht.resetDefaultState(),q=-1,Q=null,S.pop(),S.length>0?(E=S[S.length-1],Xt.setTextureUnits(E.state.textureUnits),Fe===!0&&Y.setGlobalState(L.clippingPlanes,E.state.camera)):E=null,y.pop(),y.length>0?T=y[y.length-1]:T=null,k!==null&&k.renderEnd()};function Zu(w,N,V,F){if(w.visible===!1)return;if(w.layers.test(N.layers)){if(w.isGroup)V=w.renderOrder;else if(w.isLOD)w.autoUpdate===!0&&w.update(N);else if(w.isLight)E.pushLight(w),w.castShadow&&E.pushShadow(w);else if(w.isSprite){let Et=N.isArrayCamera?je:ne;if(!w.frustumCulled||w.intersectsFrustum(Et)){F&&Ve.setFromMatrixPosition(w.matrixWorld).applyMatrix4(Se);let ft=it.update(w),wt=w.material;wt.visible&&T.push(w,ft,wt,V,Ve.z,null,N)}}else if(w.isMesh||w.isLine||w.isPoints){let Et=N.isArrayCamera?je:ne;if(!w.frustumCulled||w.intersectsFrustum(Et)){let ft=it.update(w),wt=w.material;if(F&&(w.boundingSphere!==void 0?(w.boundingSphere===null&&w.computeBoundingSphere(),Ve.copy(w.boundingSphere.center)):(ft.boundingSphere===null&&ft.computeBoundingSphere(),Ve.copy(ft.boundingSphere.center)),Ve.applyMatrix4(w.matrixWorld).applyMatrix4(Se)),Array.isArray(wt)){let Lt=ft.groups;for(let Yt=0,ie=Lt.length;Yt<ie;Yt++){let At=Lt[Yt],se=wt[At.materialIndex];se&&se.visible&&T.push(w,ft,se,V,Ve.z,At,N)}}else wt.visible&&T.push(w,ft,wt,V,Ve.z,null,N)}}}let mt=w.children;for(let Et=0,ft=mt.length;Et<ft;Et++)Zu(mt[Et],N,V,F)}function Nm(w,N,V,F){let{opaque:z,transmissive:mt,transparent:Et}=w;E.setupLightsView(V),Fe===!0&&Y.setGlobalState(L.clippingPlanes,V),F&&gt.viewport(tt.copy(F)),z.length>0&&Ja(z,N,V),mt.length>0&&Ja(mt,N,V),Et.length>0&&Ja(Et,N,V),gt.buffers.depth.setTest(!0),gt.buffers.depth.setMask(!0),gt.buffers.color.setMask(!0),gt.setPolygonOffset(!1)}function Dm(w,N,V,F){if((V.isScene===!0?V.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[F.id]===void 0){let At=ye.has("EXT_color_buffer_half_float")||ye.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[F.id]=new Dn(1,1,{generateMipmaps:!0,type:At?li:Sn,minFilter:ji,samples:Math.max(4,ve.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:re.workingColorSpace})}let mt=E.state.transmissionRenderTarget[F.id],Et=F.viewport||tt;mt.setSize(Et.z*L.transmissionResolutionScale,Et.w*L.transmissionResolutionScale);let ft=L.getRenderTarget(),wt=L.getActiveCubeFace(),Lt=L.getActiveMipmapLevel();L.setRenderTarget(mt),L.getClearColor(J),vt=L.getClearAlpha(),vt<1&&L.setClearColor(16777215,.5),L.clear(),zn&&C.render(V);let Yt=L.toneMapping;L.toneMapping=Ei;let ie=F.viewport;if(F.viewport!==void 0&&(F.viewport=void 0),E.setupLightsView(F),Fe===!0&&Y.setGlobalState(L.clippingPlanes,F),Ja(w,V,F),Xt.updateMultisampleRenderTarget(mt),Xt.updateRenderTargetMipmap(mt),ye.has("WEBGL_multisampled_render_to_texture")===!1){let At=!1;for(let se=0,De=N.length;se<De;se++){let xe=N[se],{object:ge,geometry:tn,material:Rt,group:an}=xe;if(Rt.side===Mn&&ge.layers.test(F.layers)){let le=Rt.side;Rt.side=gn,Rt.needsUpdate=!0,Om(ge,V,F,tn,Rt,an),Rt.side=le,Rt.needsUpdate=!0,At=!0}}At===!0&&(Xt.updateMultisampleRenderTarget(mt),Xt.updateRenderTargetMipmap(mt))}L.setRenderTarget(ft,wt,Lt),L.setClearColor(J,vt),ie!==void 0&&(F.viewport=ie),L.toneMapping=Yt}function Ja(w,N,V){let F=N.isScene===!0?N.overrideMaterial:null;for(let z=0,mt=w.length;z<mt;z++){let Et=w[z],{object:ft,geometry:wt,group:Lt}=Et,Yt=Et.material;Yt.allowOverride===!0&&F!==null&&(Yt=F),ft.layers.test(V.layers)&&Om(ft,N,V,wt,Yt,Lt)}}function Om(w,N,V,F,z,mt){k!==null&&z.isNodeMaterial&&k.setObject(w,z),w.onBeforeRender(L,N,V,F,z,mt),w.modelViewMatrix.multiplyMatrices(V.matrixWorldInverse,w.matrixWorld),w.normalMatrix.getNormalMatrix(w.modelViewMatrix),z.onBeforeRender(L,N,V,F,w,mt),z.transparent===!0&&z.side===Mn&&z.forceSinglePass===!1?(z.side=gn,z.needsUpdate=!0,L.renderBufferDirect(V,N,F,z,w,mt),z.side=vs,z.needsUpdate=!0,L.renderBufferDirect(V,N,F,z,w,mt),z.side=Mn):L.renderBufferDirect(V,N,F,z,w,mt),w.onAfterRender(L,N,V,F,z,mt)}function Um(w){let N=0;for(let V of w)V.texture!==null&&N++;return N}function po(w,N,V){N.isScene!==!0&&(N=Bn);let F=Gt.get(w),z=E.state.lights,mt=E.state.shadowsArray,Et=z.state.version,ft=K.getParameters(w,z.state,mt,N,V,E.state.lightProbeGridArray),wt=K.getProgramCacheKey(ft),Lt=F.programs;F.environment=w.isMeshStandardMaterial||w.isMeshLambertMaterial||w.isMeshPhongMaterial?N.environment:null,F.fog=N.fog;let Yt=w.isMeshStandardMaterial||w.isMeshLambertMaterial&&!w.envMap||w.isMeshPhongMaterial&&!w.envMap;F.envMap=A.get(w.envMap||F.environment,Yt),F.envMapRotation=F.environment!==null&&w.envMap===null?N.environmentRotation:w.envMapRotation,Lt===void 0&&(w.addEventListener("dispose",pe),Lt=new Map,F.programs=Lt,F.programVariants=new Map);let ie=Lt.get(wt);if(ie!==void 0){if(F.currentProgram===ie&&F.lightsStateVersion===Et)return km(w,ft),ie}else ft.uniforms=K.getUniforms(w),k!==null&&w.isNodeMaterial&&k.build(w,V,ft),w.onBeforeCompile(ft,L),ie=K.acquireProgram(ft,wt),Lt.set(wt,ie),F.uniforms=ft.uniforms;let At=F.uniforms;return(!w.isShaderMaterial&&!w.isRawShaderMaterial||w.clipping===!0)&&(At.clippingPlanes=Y.uniform),km(w,ft),F.needsLights=sM(w),F.lightsStateVersion=Et,F.needsLights&&(At.ambientLightColor.value=z.state.ambient,At.lightProbe.value=z.state.probe,At.sunLights.value=z.state.sun,At.sunLightShadows.value=z.state.sunShadow,At.directionalLights.value=z.state.directional,At.directionalLightShadows.value=z.state.directionalShadow,At.spotLights.value=z.state.spot,At.spotLightShadows.value=z.state.spotShadow,At.rectAreaLights.value=z.state.rectArea,At.ltc_1.value=z.state.rectAreaLTC1,At.ltc_2.value=z.state.rectAreaLTC2,At.pointLights.value=z.state.point,At.pointLightShadows.value=z.state.pointShadow,At.hemisphereLights.value=z.state.hemi,At.sunShadowMatrix.value=z.state.sunShadowMatrix,At.sunShadowCascade.value=z.state.sunShadowCascade,At.directionalShadowMatrix.value=z.state.directionalShadowMatrix,At.spotLightMatrix.value=z.state.spotLightMatrix,At.spotLightMap.value=z.state.spotLightMap,At.pointShadowMatrix.value=z.state.pointShadowMatrix),F.numLightProbeGrids=Um(E.state.lightProbeGridArray),F.currentProgram=ie,F.uniformsList=null,ie}function eM(w,N,V,F,z){let mt=Gt.get(w),Et=mt.currentProgram.id+","+F+","+z,ft=mt.programVariants.get(Et);return ft===void 0?(ft=po(w,N,V),mt.programVariants.set(Et,ft)):(mt.currentProgram=ft,mt.uniformsList=null,mt.outputColorSpace=F,mt.toneMapping=z),ft}function Fm(w){if(w.uniformsList===null){let N=w.currentProgram.getUniforms();w.uniformsList=no.seqWithValue(N.seq,w.uniforms)}return w.uniformsList}function km(w,N){let V=Gt.get(w);V.outputColorSpace=N.outputColorSpace,V.batching=N.batching,V.batchingColor=N.batchingColor,V.instancing=N.instancing,V.instancingColor=N.instancingColor,V.instancingMorph=N.instancingMorph,V.skinning=N.skinning,V.morphTargets=N.morphTargets,V.morphNormals=N.morphNormals,V.morphColors=N.morphColors,V.morphTargetsCount=N.morphTargetsCount,V.numClippingPlanes=N.numClippingPlanes,V.numIntersection=N.numClipIntersection,V.vertexAlphas=N.vertexAlphas,V.vertexTangents=N.vertexTangents,V.toneMapping=N.toneMapping}function nM(w,N,V,F,z){N.isScene!==!0&&(N=Bn),Xt.resetTextureUnits();let mt=N.fog,Et=F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial?N.environment:null,ft=st===null?L.outputColorSpace:st.isXRRenderTarget===!0?st.texture.colorSpace:re.workingColorSpace,wt=F.isMeshStandardMaterial||F.isMeshLambertMaterial&&!F.envMap||F.isMeshPhongMaterial&&!F.envMap,Lt=A.get(F.envMap||Et,wt),Yt=F.vertexColors===!0&&!!V.attributes.color&&V.attributes.color.itemSize===4,ie=!!V.attributes.tangent&&(!!F.normalMap||F.anisotropy>0),At=!!V.morphAttributes.position,se=!!V.morphAttributes.normal,De=!!V.morphAttributes.color,xe=Ei;F.toneMapped&&(st===null||st.isXRRenderTarget===!0)&&(xe=L.toneMapping);let ge=V.morphAttributes.position||V.morphAttributes.normal||V.morphAttributes.color,tn=ge!==void 0?ge.length:0,Rt=Gt.get(F),an=E.state.lights;if(Fe===!0&&(_n===!0||w!==Q)){let Ee=w===Q&&F.id===q;Y.setState(F,w,Ee)}let le=!1,ks=!1;F.version===Rt.__version?Rt.needsLights&&Rt.lightsStateVersion!==an.state.version||z.isBatchedMesh&&Rt.batching===!1||!z.isBatchedMesh&&Rt.batching===!0||z.isBatchedMesh&&Rt.batchingColor===!0&&z._colorsTexture===null||z.isBatchedMesh&&Rt.batchingColor===!1&&z._colorsTexture!==null||z.isInstancedMesh&&Rt.instancing===!1||!z.isInstancedMesh&&Rt.instancing===!0||z.isSkinnedMesh&&Rt.skinning===!1||!z.isSkinnedMesh&&Rt.skinning===!0||z.isInstancedMesh&&Rt.instancingColor===!0&&z.instanceColor===null||z.isInstancedMesh&&Rt.instancingColor===!1&&z.instanceColor!==null||z.isInstancedMesh&&Rt.instancingMorph===!0&&z.morphTexture===null||z.isInstancedMesh&&Rt.instancingMorph===!1&&z.morphTexture!==null||Rt.envMap!==Lt||F.fog===!0&&Rt.fog!==mt||Rt.numClippingPlanes!==void 0&&(Rt.numClippingPlanes!==Y.numPlanes||Rt.numIntersection!==Y.numIntersection)||Rt.vertexAlphas!==Yt||Rt.vertexTangents!==ie||Rt.morphTargets!==At||Rt.morphNormals!==se||Rt.morphColors!==De||Rt.morphTargetsCount!==tn||Rt.numLightProbeGrids!==Um(E.state.lightProbeGridArray)?le=!0:(Rt.outputColorSpace!==ft||Rt.toneMapping!==xe)&&(ks=!0):(le=!0,Rt.__version=F.version);let en=Rt.currentProgram;(le===!0||ks===!0)&&(en=ks===!0?eM(F,N,z,ft,xe):po(F,N,z),k&&F.isNodeMaterial&&k.onUpdateProgram(F,en,Rt));let Za=!1,es=!1,Bs=!1,ae=en.getUniforms(),Ye=Rt.uniforms;if(gt.useProgram(en.program)&&(Za=!0,es=!0,Bs=!0),F.id!==q&&(q=F.id,es=!0),Za||Q!==w){gt.buffers.depth.getReversed()&&w.reversedDepth!==!0&&(w._reversedDepth=!0,w.updateProjectionMatrix()),ae.setValue(O,"projectionMatrix",w.projectionMatrix),ae.setValue(O,"viewMatrix",w.matrixWorldInverse);let We=ae.map.cameraPosition;We!==void 0&&We.setValue(O,pi.setFromMatrixPosition(w.matrixWorld)),ve.logarithmicDepthBuffer&&ae.setValue(O,"logDepthBufFC",2/(Math.log(w.far+1)/Math.LN2)),(F.isMeshPhongMaterial||F.isMeshToonMaterial||F.isMeshLambertMaterial||F.isMeshBasicMaterial||F.isMeshStandardMaterial||F.isShaderMaterial)&&ae.setValue(O,"isOrthographic",w.isOrthographicCamera===!0),Q!==w&&(Q=w,es=!0,Bs=!0)}if(Rt.needsLights&&(an.state.sunShadowMap.length>0&&ae.setValue(O,"sunShadowMap",an.state.sunShadowMap,Xt),an.state.directionalShadowMap.length>0&&ae.setValue(O,"directionalShadowMap",an.state.directionalShadowMap,Xt),an.state.spotShadowMap.length>0&&ae.setValue(O,"spotShadowMap",an.state.spotShadowMap,Xt),an.state.pointShadowMap.length>0&&ae.setValue(O,"pointShadowMap",an.state.pointShadowMap,Xt)),z.isSkinnedMesh){ae.setOptional(O,z,"bindMatrix"),ae.setOptional(O,z,"bindMatrixInverse");let Ee=z.skeleton;Ee&&(Ee.boneTexture===null&&Ee.computeBoneTexture(),ae.setValue(O,"boneTexture",Ee.boneTexture,Xt))}z.isBatchedMesh&&(ae.setOptional(O,z,"batchingTexture"),ae.setValue(O,"batchingTexture",z._matricesTexture,Xt),ae.setOptional(O,z,"batchingIdTexture"),ae.setValue(O,"batchingIdTexture",z._indirectTexture,Xt),ae.setOptional(O,z,"batchingColorTexture"),z._colorsTexture!==null&&ae.setValue(O,"batchingColorTexture",z._colorsTexture,Xt));let ti=V.morphAttributes;if((ti.position!==void 0||ti.normal!==void 0||ti.color!==void 0)&&Z.update(z,V,en),(es||Rt.receiveShadow!==z.receiveShadow)&&(Rt.receiveShadow=z.receiveShadow,ae.setValue(O,"receiveShadow",z.receiveShadow)),(F.isMeshStandardMaterial||F.isMeshLambertMaterial||F.isMeshPhongMaterial)&&F.envMap===null&&N.environment!==null&&(Ye.envMapIntensity.value=N.environmentIntensity),Ye.dfgLUT!==void 0&&(Ye.dfgLUT.value=pC()),es){if(ae.setValue(O,"toneMappingExposure",L.toneMappingExposure),Rt.needsLights&&iM(Ye,Bs),mt&&F.fog===!0&&lt.refreshFogUniforms(Ye,mt),lt.refreshMaterialUniforms(Ye,F,bt,zt,E.state.transmissionRenderTarget[w.id]),Rt.needsLights&&Rt.numLightProbeGrids>0){let Ee=M,We=0;for(let Pi of E.state.lightProbeGridArray)Pi.texture!==null&&(Ee.textures[We]=Pi.texture,Ee.min[We]=Pi.boundingBox.min,Ee.max[We]=Pi.boundingBox.max,Ee.resolution[We]=Pi.resolution,We++);for(let Pi in Ee)Ee[Pi].length=We;Ye.probesSH.value=Ee.textures,Ye.probesMin.value=Ee.min,Ye.probesMax.value=Ee.max,Ye.probesResolution.value=Ee.resolution}no.upload(O,Fm(Rt),Ye,Xt)}if(F.isShaderMaterial&&F.uniformsNeedUpdate===!0&&(no.upload(O,Fm(Rt),Ye,Xt),F.uniformsNeedUpdate=!1),F.isSpriteMaterial&&ae.setValue(O,"center",z.center),ae.setValue(O,"modelViewMatrix",z.modelViewMatrix),ae.setValue(O,"normalMatrix",z.normalMatrix),ae.setValue(O,"modelMatrix",z.matrixWorld),F.uniformsGroups!==void 0){let Ee=F.uniformsGroups;for(let We=0,Pi=Ee.length;We<Pi;We++){let zm=Ee[We];Ut.update(zm,en),Ut.bind(zm,en)}}return en}function iM(w,N){w.ambientLightColor.needsUpdate=N,w.lightProbe.needsUpdate=N,w.sunLights.needsUpdate=N,w.sunLightShadows.needsUpdate=N,w.directionalLights.needsUpdate=N,w.directionalLightShadows.needsUpdate=N,w.pointLights.needsUpdate=N,w.pointLightShadows.needsUpdate=N,w.spotLights.needsUpdate=N,w.spotLightShadows.needsUpdate=N,w.rectAreaLights.needsUpdate=N,w.hemisphereLights.needsUpdate=N}function sM(w){return w.isMeshLambertMaterial||w.isMeshToonMaterial||w.isMeshPhongMaterial||w.isMeshStandardMaterial||w.isShadowMaterial||w.isShaderMaterial&&w.lights===!0}this.getActiveCubeFace=function(){return X},this.getActiveMipmapLevel=function(){return W},this.getRenderTarget=function(){return st},this.setRenderTargetTextures=function(w,N,V){let F=Gt.get(w);F.__autoAllocateDepthBuffer=w.resolveDepthBuffer===!1,F.__autoAllocateDepthBuffer===!1&&(F.__useRenderToTexture=!1),Gt.get(w.texture).__webglTexture=N,Gt.get(w.depthTexture).__webglTexture=F.__autoAllocateDepthBuffer?void 0:V,F.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(w,N){let V=Gt.get(w);V.__webglFramebuffer=N,V.__useDefaultFramebuffer=N===void 0},this.setRenderTarget=function(w,N=0,V=0){st=w,X=N,W=V;let F=null,z=!1,mt=!1;if(w){let ft=Gt.get(w);if(ft.__useDefaultFramebuffer!==void 0){gt.bindFramebuffer(O.FRAMEBUFFER,ft.__webglFramebuffer),tt.copy(w.viewport),Pt.copy(w.scissor),jt=w.scissorTest,gt.viewport(tt),gt.scissor(Pt),gt.setScissorTest(jt),q=-1;return}else if(ft.__webglFramebuffer===void 0)Xt.setupRenderTarget(w);else if(ft.__hasExternalTextures)Xt.rebindTextures(w,Gt.get(w.texture).__webglTexture,Gt.get(w.depthTexture).__webglTexture);else if(w.depthBuffer){let Yt=w.depthTexture;if(ft.__boundDepthTexture!==Yt){if(Yt!==null&&Gt.has(Yt)&&(w.width!==Yt.image.width||w.height!==Yt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Xt.setupDepthRenderbuffer(w)}}let wt=w.texture;(wt.isData3DTexture||wt.isDataArrayTexture||wt.isCompressedArrayTexture)&&(mt=!0);let Lt=Gt.get(w).__webglFramebuffer;w.isWebGLCubeRenderTarget?(Array.isArray(Lt[N])?F=Lt[N][V]:F=Lt[N],z=!0):w.samples>0&&Xt.useMultisampledRTT(w)===!1?F=Gt.get(w).__webglMultisampledFramebuffer:Array.isArray(Lt)?F=Lt[V]:F=Lt,tt.copy(w.viewport),Pt.copy(w.scissor),jt=w.scissorTest}else tt.copy(Vt).multiplyScalar(bt).floor(),Pt.copy(fe).multiplyScalar(bt).floor(),jt=me;if(V!==0&&(F=G),gt.bindFramebuffer(O.FRAMEBUFFER,F)&&gt.drawBuffers(w,F),gt.viewport(tt),gt.scissor(Pt),gt.setScissorTest(jt),z){let ft=Gt.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+N,ft.__webglTexture,V)}else if(mt){let ft=N;for(let wt=0;wt<w.textures.length;wt++){let Lt=Gt.get(w.textures[wt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+wt,Lt.__webglTexture,V,ft)}}else if(w!==null&&V!==0){let ft=Gt.get(w.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ft.__webglTexture,V)}q=-1};function Bm(w){let N=Gt.get(w);return(N.__readFormat!==w.format||N.__readType!==w.type)&&(N.__readFormat=w.format,N.__readType=w.type,N.__formatReadable=ve.textureFormatReadable(w.format),N.__typeReadable=ve.textureTypeReadable(w.type)),N}this.readRenderTargetPixels=function(w,N,V,F,z,mt,Et,ft=0){if(!(w&&w.isWebGLRenderTarget)){Wt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let wt=Gt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Et!==void 0&&(wt=wt[Et],Array.isArray(wt)&&(wt=wt[0])),wt){gt.bindFramebuffer(O.FRAMEBUFFER,wt);try{let Lt=w.textures[ft],Yt=Lt.format,ie=Lt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ft);let At=Bm(Lt);if(At.__formatReadable===!1){Wt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(At.__typeReadable===!1){Wt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}N>=0&&N<=w.width-F&&V>=0&&V<=w.height-z&&O.readPixels(N,V,F,z,ct.convert(Yt),ct.convert(ie),mt)}finally{let Lt=st!==null?Gt.get(st).__webglFramebuffer:null;gt.bindFramebuffer(O.FRAMEBUFFER,Lt)}}},this.readRenderTargetPixelsAsync=async function(w,N,V,F,z,mt,Et,ft=0){if(!(w&&w.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let wt=Gt.get(w).__webglFramebuffer;if(w.isWebGLCubeRenderTarget&&Et!==void 0&&(wt=wt[Et],Array.isArray(wt)&&(wt=wt[0])),wt)if(N>=0&&N<=w.width-F&&V>=0&&V<=w.height-z){gt.bindFramebuffer(O.FRAMEBUFFER,wt);let Lt=w.textures[ft],Yt=Lt.format,ie=Lt.type;w.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ft);let At=Bm(Lt);if(At.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(At.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let se=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,se),O.bufferData(O.PIXEL_PACK_BUFFER,mt.byteLength,O.STREAM_READ),O.readPixels(N,V,F,z,ct.convert(Yt),ct.convert(ie),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let De=st!==null?Gt.get(st).__webglFramebuffer:null;gt.bindFramebuffer(O.FRAMEBUFFER,De);let xe=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await lx(O,xe,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,se),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,mt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(se),O.deleteSync(xe),mt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(w,N=null,V=0){let F=Math.pow(2,-V),z=Math.floor(w.image.width*F),mt=Math.floor(w.image.height*F),Et=N!==null?N.x:0,ft=N!==null?N.y:0;Xt.setTexture2D(w,0),O.copyTexSubImage2D(O.TEXTURE_2D,V,0,0,Et,ft,z,mt),gt.unbindTexture()},this.copyTextureToTexture=function(w,N,V=null,F=null,z=0,mt=0){let Et,ft,wt,Lt,Yt,ie,At,se,De,xe=w.isCompressedTexture?w.mipmaps[mt]:w.image;if(V!==null)Et=V.max.x-V.min.x,ft=V.max.y-V.min.y,wt=V.isBox3?V.max.z-V.min.z:1,Lt=V.min.x,Yt=V.min.y,ie=V.isBox3?V.min.z:0;else{let ae=Math.pow(2,-z);Et=Math.floor(xe.width*ae),ft=Math.floor(xe.height*ae),w.isDataArrayTexture?wt=xe.depth:w.isData3DTexture?wt=Math.floor(xe.depth*ae):wt=1,Lt=0,Yt=0,ie=0}F!==null?(At=F.x,se=F.y,De=F.z):(At=0,se=0,De=0);let ge=ct.convert(N.format),tn=ct.convert(N.type),Rt;N.isData3DTexture?(Xt.setTexture3D(N,0),Rt=O.TEXTURE_3D):N.isDataArrayTexture||N.isCompressedArrayTexture?(Xt.setTexture2DArray(N,0),Rt=O.TEXTURE_2D_ARRAY):(Xt.setTexture2D(N,0),Rt=O.TEXTURE_2D),gt.activeTexture(O.TEXTURE0),gt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,N.flipY),gt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,N.premultiplyAlpha),gt.pixelStorei(O.UNPACK_ALIGNMENT,N.unpackAlignment);let an=gt.getParameter(O.UNPACK_ROW_LENGTH),le=gt.getParameter(O.UNPACK_IMAGE_HEIGHT),ks=gt.getParameter(O.UNPACK_SKIP_PIXELS),en=gt.getParameter(O.UNPACK_SKIP_ROWS),Za=gt.getParameter(O.UNPACK_SKIP_IMAGES);gt.pixelStorei(O.UNPACK_ROW_LENGTH,xe.width),gt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,xe.height),gt.pixelStorei(O.UNPACK_SKIP_PIXELS,Lt),gt.pixelStorei(O.UNPACK_SKIP_ROWS,Yt),gt.pixelStorei(O.UNPACK_SKIP_IMAGES,ie);let es=w.isDataArrayTexture||w.isData3DTexture,Bs=N.isDataArrayTexture||N.isData3DTexture;if(w.isDepthTexture){let ae=Gt.get(w),Ye=Gt.get(N),ti=Gt.get(ae.__renderTarget),Ee=Gt.get(Ye.__renderTarget);gt.bindFramebuffer(O.READ_FRAMEBUFFER,ti.__webglFramebuffer),gt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ee.__webglFramebuffer);for(let We=0;We<wt;We++)es&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Gt.get(w).__webglTexture,z,ie+We),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Gt.get(N).__webglTexture,mt,De+We)),O.blitFramebuffer(Lt,Yt,Lt+Et,Yt+ft,At,se,At+Et,se+ft,O.DEPTH_BUFFER_BIT,O.NEAREST);gt.bindFramebuffer(O.READ_FRAMEBUFFER,null),gt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(z!==0||w.isRenderTargetTexture||Gt.has(w)){let ae=Gt.get(w),Ye=Gt.get(N);gt.bindFramebuffer(O.READ_FRAMEBUFFER,I),gt.bindFramebuffer(O.DRAW_FRAMEBUFFER,H);for(let ti=0;ti<wt;ti++)es?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,ae.__webglTexture,z,ie+ti):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ae.__webglTexture,z),Bs?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Ye.__webglTexture,mt,De+ti):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Ye.__webglTexture,mt),z!==0?O.blitFramebuffer(Lt,Yt,Lt+Et,Yt+ft,At,se,At+Et,se+ft,O.COLOR_BUFFER_BIT,O.NEAREST):Bs?O.copyTexSubImage3D(Rt,mt,At,se,De+ti,Lt,Yt,Et,ft):O.copyTexSubImage2D(Rt,mt,At,se,Lt,Yt,Et,ft);gt.bindFramebuffer(O.READ_FRAMEBUFFER,null),gt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Bs?w.isDataTexture||w.isData3DTexture?O.texSubImage3D(Rt,mt,At,se,De,Et,ft,wt,ge,tn,xe.data):N.isCompressedArrayTexture?O.compressedTexSubImage3D(Rt,mt,At,se,De,Et,ft,wt,ge,xe.data):O.texSubImage3D(Rt,mt,At,se,De,Et,ft,wt,ge,tn,xe):w.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,mt,At,se,Et,ft,ge,tn,xe.data):w.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,mt,At,se,xe.width,xe.height,ge,xe.data):O.texSubImage2D(O.TEXTURE_2D,mt,At,se,Et,ft,ge,tn,xe);gt.pixelStorei(O.UNPACK_ROW_LENGTH,an),gt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,le),gt.pixelStorei(O.UNPACK_SKIP_PIXELS,ks),gt.pixelStorei(O.UNPACK_SKIP_ROWS,en),gt.pixelStorei(O.UNPACK_SKIP_IMAGES,Za),mt===0&&N.generateMipmaps===!0&&N.mipmapsAutoUpdate===!0&&O.generateMipmap(Rt),gt.unbindTexture()},this.initRenderTarget=function(w){Gt.get(w).__webglFramebuffer===void 0&&Xt.setupRenderTarget(w)},this.initTexture=function(w){w.isCubeTexture?Xt.setTextureCube(w,0):w.isData3DTexture?Xt.setTexture3D(w,0):w.isDataArrayTexture||w.isCompressedArrayTexture?Xt.setTexture2DArray(w,0):Xt.setTexture2D(w,0),gt.unbindTexture()},this.resetState=function(){X=0,W=0,st=null,gt.reset(),ht.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return qn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=re._getDrawingBufferColorSpace(t),e.unpackColorSpace=re._getUnpackColorSpace()}};var Yx={type:"change"},ap={type:"start"},Zx={type:"end"},Uh=new ds,Jx=new dn,mC=Math.cos(70*Wf.DEG2RAD),Ge=new P,En=2*Math.PI,he={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},op=1e-6,Fh=class extends ma{constructor(t,e=null){super(t,e),this.state=he.NONE,this.target=new P,this.cursor=new P,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:_s.ROTATE,MIDDLE:_s.DOLLY,RIGHT:_s.PAN},this.touches={ONE:ys.ROTATE,TWO:ys.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new P,this._lastQuaternion=new mn,this._lastTargetPosition=new P,this._quat=new mn().setFromUnitVectors(t.up,new P(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Jr,this._sphericalDelta=new Jr,this._scale=1,this._panOffset=new P,this._rotateStart=new St,this._rotateEnd=new St,this._rotateDelta=new St,this._panStart=new St,this._panEnd=new St,this._panDelta=new St,this._dollyStart=new St,this._dollyEnd=new St,this._dollyDelta=new St,this._dollyDirection=new P,this._mouse=new St,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=xC.bind(this),this._onPointerDown=gC.bind(this),this._onPointerUp=_C.bind(this),this._onContextMenu=EC.bind(this),this._onMouseWheel=bC.bind(this),this._onKeyDown=wC.bind(this),this._onTouchStart=MC.bind(this),this._onTouchMove=SC.bind(this),this._onMouseDown=yC.bind(this),this._onMouseMove=vC.bind(this),this._interceptControlDown=TC.bind(this),this._interceptControlUp=AC.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(t){this._cursorStyle=t,t==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(t){super.connect(t),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=he.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(t){t.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=t}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Yx),this.update(),this.state=he.NONE}pan(t,e){this._pan(t,e),this.update()}dollyIn(t){this._dollyIn(t),this.update()}dollyOut(t){this._dollyOut(t),this.update()}rotateLeft(t){this._rotateLeft(t),this.update()}rotateUp(t){this._rotateUp(t),this.update()}update(t=null){let e=this.object.position;Ge.copy(e).sub(this.target),Ge.applyQuaternion(this._quat),this._spherical.setFromVector3(Ge),this.autoRotate&&this.state===he.NONE&&this._rotateLeft(this._getAutoRotationAngle(t)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=En:i>Math.PI&&(i-=En),s<-Math.PI?s+=En:s>Math.PI&&(s-=En),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ge.setFromSpherical(this._spherical),Ge.applyQuaternion(this._quatInverse),e.copy(this.target).add(Ge),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ge.length();o=this._clampDistance(a*this._scale);let c=a-o;this.object.position.addScaledVector(this._dollyDirection,c),this.object.updateMatrixWorld(),r=!!c}else if(this.object.isOrthographicCamera){let a=new P(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let c=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=c!==this.object.zoom;let l=new P(this._mouse.x,this._mouse.y,0);l.unproject(this.object),this.object.position.sub(l).add(a),this.object.updateMatrixWorld(),o=Ge.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Uh.origin.copy(this.object.position),Uh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Uh.direction))<mC?this.object.lookAt(this.target):(Jx.setFromNormalAndCoplanarPoint(this.object.up,this.target),Uh.intersectPlane(Jx,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>op||8*(1-this._lastQuaternion.dot(this.object.quaternion))>op||this._lastTargetPosition.distanceToSquared(this.target)>op?(this.dispatchEvent(Yx),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(t){return t!==null?En/60*this.autoRotateSpeed*t:En/60/60*this.autoRotateSpeed}_getZoomScale(t){let e=Math.abs(t*.01);return Math.pow(.95,this.zoomSpeed*e)}_rotateLeft(t){this._sphericalDelta.theta-=t}_rotateUp(t){this._sphericalDelta.phi-=t}_panLeft(t,e){Ge.setFromMatrixColumn(e,0),Ge.multiplyScalar(-t),this._panOffset.add(Ge)}_panUp(t,e){this.screenSpacePanning===!0?Ge.setFromMatrixColumn(e,1):(Ge.setFromMatrixColumn(e,0),Ge.crossVectors(this.object.up,Ge)),Ge.multiplyScalar(t),this._panOffset.add(Ge)}_pan(t,e){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ge.copy(s).sub(this.target);let r=Ge.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*t*r/i.clientHeight,this.object.matrix),this._panUp(2*e*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(t*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(e*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(t){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=t:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(t,e){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=t-i.left,r=e-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(t){return Math.max(this.minDistance,Math.min(this.maxDistance,t))}_handleMouseDownRotate(t){this._rotateStart.set(t.clientX,t.clientY)}_handleMouseDownDolly(t){this._updateZoomParameters(t.clientX,t.clientY),this._dollyStart.set(t.clientX,t.clientY)}_handleMouseDownPan(t){this._panStart.set(t.clientX,t.clientY)}_handleMouseMoveRotate(t){this._rotateEnd.set(t.clientX,t.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(En*this._rotateDelta.x/e.clientHeight),this._rotateUp(En*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(t){this._dollyEnd.set(t.clientX,t.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(t){this._panEnd.set(t.clientX,t.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(t){this._updateZoomParameters(t.clientX,t.clientY),t.deltaY<0?this._dollyIn(this._getZoomScale(t.deltaY)):t.deltaY>0&&this._dollyOut(this._getZoomScale(t.deltaY)),this.update()}_handleKeyDown(t){let e=!1;switch(t.code){case this.keys.UP:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(En*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),e=!0;break;case this.keys.BOTTOM:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateUp(-En*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),e=!0;break;case this.keys.LEFT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(En*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),e=!0;break;case this.keys.RIGHT:t.ctrlKey||t.metaKey||t.shiftKey?this.enableRotate&&this._rotateLeft(-En*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),e=!0;break}e&&(t.preventDefault(),this.update())}_handleTouchStartRotate(t){if(this._pointers.length===1)this._rotateStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(t){if(this._pointers.length===1)this._panStart.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panStart.set(i,s)}}_handleTouchStartDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enablePan&&this._handleTouchStartPan(t)}_handleTouchStartDollyRotate(t){this.enableZoom&&this._handleTouchStartDolly(t),this.enableRotate&&this._handleTouchStartRotate(t)}_handleTouchMoveRotate(t){if(this._pointers.length==1)this._rotateEnd.set(t.pageX,t.pageY);else{let i=this._getSecondPointerPosition(t),s=.5*(t.pageX+i.x),r=.5*(t.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let e=this.domElement;this._rotateLeft(En*this._rotateDelta.x/e.clientHeight),this._rotateUp(En*this._rotateDelta.y/e.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(t){if(this._pointers.length===1)this._panEnd.set(t.pageX,t.pageY);else{let e=this._getSecondPointerPosition(t),i=.5*(t.pageX+e.x),s=.5*(t.pageY+e.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(t){let e=this._getSecondPointerPosition(t),i=t.pageX-e.x,s=t.pageY-e.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(t.pageX+e.x)*.5,a=(t.pageY+e.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enablePan&&this._handleTouchMovePan(t)}_handleTouchMoveDollyRotate(t){this.enableZoom&&this._handleTouchMoveDolly(t),this.enableRotate&&this._handleTouchMoveRotate(t)}_addPointer(t){this._pointers.push(t.pointerId)}_removePointer(t){delete this._pointerPositions[t.pointerId];for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId){this._pointers.splice(e,1);return}}_isTrackingPointer(t){for(let e=0;e<this._pointers.length;e++)if(this._pointers[e]==t.pointerId)return!0;return!1}_trackPointer(t){let e=this._pointerPositions[t.pointerId];e===void 0&&(e=new St,this._pointerPositions[t.pointerId]=e),e.set(t.pageX,t.pageY)}_getSecondPointerPosition(t){let e=t.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[e]}_customWheelEvent(t){let e=t.deltaMode,i={clientX:t.clientX,clientY:t.clientY,deltaY:t.deltaY};switch(e){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return t.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function gC(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function xC(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function _C(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Zx),this.state=he.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let t=this._pointers[0],e=this._pointerPositions[t];this._onTouchStart({pointerId:t,pageX:e.x,pageY:e.y});break}}function yC(n){let t;switch(n.button){case 0:t=this.mouseButtons.LEFT;break;case 1:t=this.mouseButtons.MIDDLE;break;case 2:t=this.mouseButtons.RIGHT;break;default:t=-1}switch(t){case _s.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=he.DOLLY;break;case _s.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=he.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=he.ROTATE}break;case _s.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=he.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=he.PAN}break;default:this.state=he.NONE}this.state!==he.NONE&&this.dispatchEvent(ap)}function vC(n){switch(this.state){case he.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case he.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case he.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function bC(n){this.enabled===!1||this.enableZoom===!1||this.state!==he.NONE||(n.preventDefault(),this.dispatchEvent(ap),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Zx))}function wC(n){this.enabled!==!1&&this._handleKeyDown(n)}function MC(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case ys.ROTATE:if(this.enableRotate===!1){this.state=he.NONE;break}this._handleTouchStartRotate(n),this.state=he.TOUCH_ROTATE;break;case ys.PAN:if(this.enablePan===!1){this.state=he.NONE;break}this._handleTouchStartPan(n),this.state=he.TOUCH_PAN;break;default:this.state=he.NONE}break;case 2:switch(this.touches.TWO){case ys.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=he.TOUCH_DOLLY_PAN;break;case ys.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=he.TOUCH_DOLLY_ROTATE;break;default:this.state=he.NONE}break;default:this.state=he.NONE}this.state!==he.NONE&&this.dispatchEvent(ap)}function SC(n){switch(this._trackPointer(n),this.state){case he.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case he.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case he.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case he.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=he.NONE}}function EC(n){this.enabled!==!1&&n.preventDefault()}function TC(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function AC(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var Qx={light:{highlight:"#E69F00",link:"#e9edf2",joint:"#34506b",grid:"#8793a3",gridStrength:.34,shadow:.16,sky:2.1,sun:1.5,path:"#D55E00",wantedPath:"#7a8290",force:"#C77E00",ghost:"#0072B2",ellipsoid:"#9a4f86",bad:"#c0392b"},dark:{highlight:"#F0B429",link:"#c3ccd8",joint:"#5f86ad",grid:"#93a1b5",gridStrength:.26,shadow:.28,sky:1.15,sun:1.7,path:"#F58A3C",wantedPath:"#a3adba",force:"#F0B429",ghost:"#56B4E9",ellipsoid:"#d79bc3",bad:"#ff8a6b"}},Aa={light:{x:"#D55E00",y:"#009E73",z:"#0072B2"},dark:{x:"#F58A3C",y:"#3CC79B",z:"#5AB4EC"}},Kx=["#0072B2","#D55E00","#009E73","#E69F00","#CC79A7","#56B4E9","#882255","#7a8290"],Tn=n=>Kx[n%Kx.length];var RC=new P(0,1,0),t_=new Qs(1,1,1,28,1,!0),Ca=new Qs(1,1,1,36),zh=new ra(1,28,18),e_=new ps(1,1,1),cp=new na(1,1,24),n_=new tr(1,1),CC=[["x",0],["x",Math.PI/2],["y",Math.PI/2]],i_=new wn().setFromPoints(Array.from({length:64},(n,t)=>new P(Math.cos(t*Math.PI/32),Math.sin(t*Math.PI/32),0))),IC=new Set([t_,Ca,zh,e_,cp,n_,i_]),s_=n=>IC.has(n),Ia=n=>new Ue(zh,n),Gh=n=>new Ue(Ca,n);function Pa(n,t){let e=new Ue(n_,t);return e.scale.setScalar(n),e}function r_(n,t){let e=Pa(4*n,new aa({opacity:t.shadow}));return e.receiveShadow=!0,e.position.z=-.001*n,e}var ws=n=>new P().fromArray(n),PC=[0,0,0],LC=new $t(1,1,1),Ra=class extends Zo{constructor(t,e,i){super(t,e,i),this.frustumCulled=!1,this.instanceMatrix.setUsage(kf);for(let s=0;s<i;s++)this.hide(s)}placeByAxes(t,e,i,s,r){[e,i,s,r].forEach((o,a)=>this.instanceMatrix.array.set(o,16*t+4*a)),this.instanceMatrix.array[16*t+15]=1,this.instanceMatrix.needsUpdate=!0}placeBetween(t,e,i,s,r=null){let o=nt(i,e),a=Ct(o);if(a<=1e-6)return this.hide(t),!1;let c=r??NC(o,a),l=s/Ct(c);return this.placeByAxes(t,Mt(l,c),o,Mt(l/a,kt(c,o)),Dt(e,Mt(.5,o))),!0}placeBall(t,e,i){this.placeByAxes(t,[i,0,0],[0,i,0],[0,0,i],e)}hide(t){this.placeBall(t,PC,0)}setColours(t){for(let e=0;e<this.count;e++)this.setColorAt(e,t(e));this.instanceColor.needsUpdate=!0}};function NC(n,t){return kt(n,Math.abs(n[2])<.7*t?[0,0,1]:[1,0,0])}function so(n,t,e,i){let s=ws(nt(e,t)),r=s.length();n.visible=r>1e-6,n.visible&&(n.position.copy(ws(t)).addScaledVector(s,.5),n.quaternion.copy(new mn().setFromUnitVectors(RC,s.divideScalar(r))),n.scale.set(i,r,i))}var lp=.021,ro=class extends Ae{constructor(t,{link:e,joint:i,ghost:s=!1,jointColour:r=null}){super(),this.arm=t,this.size=mr(t),this.ghost=s,this.jointColour=r;let o=t.rows.length,a=(c,l,h)=>{let u=new Ra(c,l,h);return u.castShadow=u.receiveShadow=!s,this.add(u),u};if(this.rods=a(t_,e,2*o),this.balls=a(zh,e,2*o),this.barrels=a(Ca,i,o+1),this.boxes=t.rows.some(c=>c.kind==="prismatic")?a(e_,i,o):null,s||this.barrels.placeBetween(o,[0,0,-.004*this.size],[0,0,.012*this.size],.05*this.size),!!r){for(let c of[this.rods,this.balls])c.setColours(()=>LC);this.tintJoints(()=>null)}}tintJoints(t){let e=i=>t(i)??this.jointColour;this.barrels.setColours(e),this.boxes?.setColours(e)}placeAtFrames(t,e=this.ghost?.97:1){this.radiusScale=e*this.size,this.arm.rows.forEach((i,s)=>{let[r,o]=[t[s],t[s+1]],a=nt(o.o,Mt(i.a,o.x)),c=this.getLinkRadius(s),l=i.kind==="prismatic",h=this.rods.placeBetween(2*s,r.o,a,l?.6*c:c),u=this.rods.placeBetween(2*s+1,a,o.o,c),d=[a,o.o],f=[l?.6:1,s===this.arm.rows.length-1?.8:1];d.forEach((p,m)=>{h||u?this.balls.placeBall(2*s+m,p,f[m]*c):this.balls.hide(2*s+m)}),i.kind!=="fixed"&&this.placeJoint(s,r,c,l)})}placeJoint(t,{o:e,x:i,z:s},r,o){let a=Mt(o?2.2*r:1.45*r,s),[c,l]=[nt(e,a),Dt(e,a)];o?this.boxes.placeBetween(t,c,l,2*r,i):this.barrels.placeBetween(t,c,l,1.28*r)}getLinkRadius(t){let e=this.arm.rows.length;return this.radiusScale*(t===e-1?.008:lp-.008*t/e)}},Jn=class extends Ae{constructor(t){super(),this.shaft=new Ue(Ca,t),this.head=new Ue(cp,t),this.add(this.shaft,this.head)}placeAlong(t,e,i){let s=Ct(e);if(this.visible=s>1e-9,!this.visible)return;let r=Math.max(0,s-5*i);so(this.shaft,t,Dt(t,Mt(r/s,e)),i),so(this.head,Dt(t,Mt(r/s,e)),Dt(t,e),2.4*i)}},kh=class extends Ae{constructor(t,e){super();let i=Object.values(Aa[t?"dark":"light"]).map(s=>new $t(s));this.shafts=new Ra(Ca,new Ke,3*e),this.heads=new Ra(cp,new Ke,3*e);for(let s of[this.shafts,this.heads])s.setColours(r=>i[r%3]);this.add(this.shafts,this.heads)}placeAtFrames(t,e,i){let s=.022*e;t.forEach((r,o)=>["x","y","z"].forEach((a,c)=>{let[l,h]=[e-5*s,e].map(u=>Dt(r.o,Mt(u,r[a])));for(let[u,d,f,p]of[[this.shafts,r.o,l,s],[this.heads,l,h,2.4*s]])i[o]?u.placeBetween(3*o+c,d,f,p):u.hide(3*o+c)}))}},Bh=class extends Ae{constructor(t){super();let e=new Si({color:t,transparent:!0,opacity:.2,depthWrite:!1,side:Mn});this.add(new Ue(zh,e));for(let[i,s]of CC){let r=new Ko(i_,new Xr({color:t}));r.rotation[i]=s,this.add(r)}this.matrixAutoUpdate=!1}placeAt(t,{values:e,vectors:i},s,r){let o=i.map((h,u)=>ws(Mt(Math.max(s*e[u],r),h))),[a,c,l]=o;this.matrix.makeBasis(a,c,l).premultiply(new ce().makeTranslation(ws(t)))}};function oo(n,t,e){let s=n.filter((o,a)=>a===0||Ct(nt(o,n[a-1]))>1e-7);if(s.length<2)return new Ae;let r=new jr(s.map(ws));return new Ue(new oa(r,Math.min(400,s.length*2),t,8),new Ke({color:e}))}function o_(n,t){let i=Ct(nt(n[0],n.at(-1)))<Ct(nt(n[0],n[1]))?n.slice(1):n,s=i.length,r=Mt(1/s,i.reduce(Dt)),[o,a]=[i[0],i[Math.floor(s/4)]].map(f=>ws(nt(f,r))),c=o.clone().cross(a).normalize(),l=Math.max(...n.map(f=>Ct(nt(f,r)))),h=n.every(f=>Math.abs(ws(nt(f,r)).dot(c))<.02*l);if(!(l>1e-6&&c.length()>.5&&h))return null;let u=Pa(3.4*l,t);u.position.copy(ws(r));let d=Math.abs(c.z)>.9?new P(0,1,0):new P(0,0,1);return u.quaternion.setFromRotationMatrix(new ce().lookAt(c,new P,d)),{wall:u,centre:r,radius:l,normal:c.toArray()}}function a_(n,t,e){let i=n>1.2?.2:n>.4?.1:.05,s=new jn({transparent:!0,depthWrite:!1,side:Mn,uniforms:{colour:{value:new $t(t)},size:{value:n},step:{value:i},strength:{value:e}},vertexShader:`
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
      }`});return Pa(2*n,s)}function c_(n){return new Si({color:n,transparent:!0,opacity:.45,depthWrite:!1,roughness:.7})}var Vh=(n,t)=>new Ke({color:n,transparent:!0,opacity:t,side:Mn,depthWrite:!1});var Le=null,La=null,Ms=new Set;function DC(){return Le||(Le=new Nh({antialias:!0,alpha:!0,powerPreference:"low-power"}),Le.setPixelRatio(1),Le.setScissorTest(!0),Le.shadowMap.enabled=!0,Le.shadowMap.type=er,Le.domElement.addEventListener("webglcontextlost",()=>Ms.forEach(n=>n.onContextChange(!0))),Le.domElement.addEventListener("webglcontextrestored",()=>{Ms.forEach(n=>{n.onContextChange(!1),n.requestDrawing()})}),Le)}function OC(){try{return DC()}catch{for(let n of[...Ms])n.onUnavailable();return null}}var f_=()=>({...Le?.info.memory,calls:Le?.info.render.calls,programs:Le?.info.programs?.length,figures:Ms.size}),p_=()=>Le?.getContext().getExtension("WEBGL_lose_context"),Na=new Set;function hp(n){Na.add(n),La??=requestAnimationFrame(dp)}var up=n=>Na.delete(n);function dp(){let n=[...Na];Na.clear();try{n.forEach(e=>e());let t=OC();if(!t||t.getContext().isContextLost())return;for(let e of Ms)e.needsDrawing&&e.isNearWindow&&e.width&&e.render(t)}finally{La=Na.size?requestAnimationFrame(dp):null}}var l_=typeof IntersectionObserver>"u"?null:new IntersectionObserver(n=>{for(let{target:t,isIntersecting:e}of n){let i=t.figure;i&&(i.isNearWindow=e,e&&i.requestDrawing())}},{rootMargin:"200px"}),h_=new P,u_=new pa,d_=.82,fp=[.687,-.639,.344],Hh=class{constructor(t,{onDraw:e,onResize:i,onContextChange:s,onUnavailable:r}){if(typeof WebGL2RenderingContext>"u")throw new Error("no WebGL");this.host=t,this.size=1,this.onDraw=e,this.onResize=i,this.onContextChange=s,this.onUnavailable=r,this.needsDrawing=!0,this.isNearWindow=!0,this.abortController=new AbortController,this.fittedPoints=null,this.viewDirection=fp,this.width=0,this.height=0,this.getFootHeight=()=>0,this.canvas=document.createElement("canvas"),this.canvas.figure=this,this.context=this.canvas.getContext("2d"),t.prepend(this.canvas),this.scene=new qo,this.camera=new fn(32,1,.01,100),this.camera.up.set(0,0,1),this.controls=new Fh(this.camera,this.canvas),this.controls.addEventListener("change",()=>this.requestDrawing()),this.controls.enableZoom=!1,this.controls.enablePan=!1,this.canvas.style.touchAction="pan-y",this.addListener(t,"focusin",()=>this.controls.enableZoom=!0),this.addListener(t,"focusout",()=>this.controls.enableZoom=!1),this.addLights(),Ms.add(this),l_?.observe(this.canvas),this.resizeObserver=new ResizeObserver(()=>this.fitCanvasToHost()),this.resizeObserver.observe(t)}get signal(){return this.abortController.signal}addListener(t,e,i,s={}){t.addEventListener(e,i,{...s,signal:this.signal})}addLights(){this.sky=new ha("#ffffff","#8d95a1"),this.sky.position.set(0,0,1),this.sun=new fa("#ffffff"),this.sun.castShadow=!0,this.sun.shadow.mapSize.set(1024,1024),this.sun.shadow.radius=5,this.sun.shadow.bias=-.002,this.scene.add(this.sky,this.sun,this.sun.target)}setLights(t,{sky:e,sun:i}){this.size=t,this.sky.intensity=e,this.sun.intensity=i,this.sun.position.set(.55*t,-.75*t,2*t);let{camera:s}=this.sun.shadow;Object.assign(s,{left:-t,right:t,top:t,bottom:-t,near:.05*t,far:4*t}),s.updateProjectionMatrix()}requestDrawing(){this.needsDrawing=!0,La??=requestAnimationFrame(dp)}fitCanvasToHost(){let{clientWidth:t,clientHeight:e}=this.host;if(Object.assign(this,{width:t,height:e}),!t||!e)return;let i=Math.min(devicePixelRatio,2),[s,r]=[Math.round(t*i),Math.round(e*i)];this.canvas.width===s&&this.canvas.height===r||(Object.assign(this.canvas,{width:s,height:r}),Object.assign(this.canvas.style,{width:`${t}px`,height:`${e}px`}),this.camera.aspect=t/e,this.camera.updateProjectionMatrix(),this.fittedPoints&&!(Math.abs(this.fittedAspect-this.camera.aspect)<.01)&&this.fitView(this.fittedPoints),this.needsDrawing=!0,Le&&!Le.getContext().isContextLost()?this.render(Le):(this.requestDrawing(),this.onResize()))}render(t){let{width:e,height:i}=this.canvas,s=t.getSize(new St);(e>s.x||i>s.y)&&t.setSize(Math.max(e,s.x),Math.max(i,s.y),!1),t.setViewport(0,0,e,i),t.setScissor(0,0,e,i),t.render(this.scene,this.camera),this.needsDrawing=!1,this.context.clearRect(0,0,e,i);let r=t.domElement.height-i;this.context.drawImage(t.domElement,0,r,e,i,0,0,e,i),this.onDraw(this)}fitView(t,e=this.viewDirection){if(this.fittedPoints=t,this.viewDirection=e,!this.height)return;let{camera:i,controls:s,size:r}=this;this.fittedAspect=i.aspect;let o=Math.min(.3,this.getFootHeight()/this.height),a=t.map(c=>new P(...c));new On().setFromPoints(a).getCenter(s.target),i.position.copy(s.target).addScaledVector(new P(...e),3*r),Object.assign(i,{near:r/50,far:r*40}),i.updateProjectionMatrix();for(let c=0;c<4;c++){s.update(),i.updateMatrixWorld();let{min:l,max:h}=new On().setFromPoints(a.map(g=>g.clone().project(i))),u=Math.max(0,Math.min(o,(h.y-l.y)/2-1+2*o)),[d,f]=[(h.x-l.x)/2/.81,(h.y-l.y)/2/Math.min(.81,.96-o)],[p,m]=[(l.x+h.x)/2,(l.y+h.y)/2-u];this.moveView(p,m,Math.max(d,f))}this.requestDrawing()}widenView(t){if(this.height)for(let e=0;e<8;e++){let{x:i,y:s}=new P(...t).project(this.camera),r=[i,s].map(c=>c-ln(c,-d_,d_)),[o,a]=r.map(c=>ln(c/2,-.5,.5));if(!o&&!a)return;this.moveView(o,a,1+Math.max(Math.abs(o),Math.abs(a)))}}moveView(t,e,i){let{camera:s,controls:r}=this,o=s.position.clone().sub(r.target),a=o.length()*Math.tan(s.fov*Math.PI/360),[c,l]=[0,1].map(h=>new P().setFromMatrixColumn(s.matrixWorld,h));r.target.addScaledVector(c,t*a*s.aspect),r.target.addScaledVector(l,e*a),s.position.copy(r.target).addScaledVector(o,i),r.update(),s.updateMatrixWorld()}isInView(t){let[e,i]=this.projectToPixel(t);return e>=0&&e<=this.width&&i>=0&&i<=this.height}turnView(t,e,i=1){this.controls.rotateLeft(-t),this.controls.rotateUp(-e),this.controls.dollyIn(i)}projectToPixel(t){let e=h_.fromArray(t).project(this.camera);return[(e.x+1)*this.width/2,(1-e.y)*this.height/2]}measurePixels(t,e){let s=this.camera.position.distanceTo(h_.fromArray(e))*Math.tan(this.camera.fov*Math.PI/360);return t*this.height/(2*s)}getPointerPixel({clientX:t,clientY:e}){let i=this.canvas.getBoundingClientRect();return[t-i.left,e-i.top]}projectToFacingPlane([t,e],i){let s=new St(2*t/this.width-1,1-2*e/this.height);u_.setFromCamera(s,this.camera);let r=this.camera.getWorldDirection(new P),o=new dn().setFromNormalAndCoplanarPoint(r,new P(...i));return u_.ray.intersectPlane(o,new P)?.toArray()??null}dispose(){this.abortController.abort(),l_?.unobserve(this.canvas),this.resizeObserver.disconnect(),this.controls.dispose(),ar(this.scene),this.sun.dispose(),this.sky.dispose(),this.canvas.figure=null,this.canvas.remove(),Ms.delete(this),!(Ms.size||!Le)&&(cancelAnimationFrame(La),La=null,Le.dispose(),Le.forceContextLoss(),Le=null)}};function ar(n){n.traverse(t=>{t.material?.dispose(),t.isInstancedMesh&&t.dispose(),t.geometry&&!s_(t.geometry)&&t.geometry.dispose()}),n.removeFromParent()}var Wh=n=>[...n.children].forEach(ar);var g_=n=>({revolute:"theta",prismatic:"d"})[n];function m_(n,t=0){let e=Math.round(n/(Math.PI/2))*Math.PI/2;return Math.abs(n-e)<Math.max(1e-4,.51*t)?e:n}var x_=n=>n.map(t=>({...t,alpha:m_(t.alpha),theta:m_(t.theta)}));var Ss=1e-9,qh=-1;function b_(n){let t=et(n),e=t.flatMap((o,a)=>n.rows[o].kind==="prismatic"?[a]:[]),i=t.map(()=>0);if(!e.length)return $h(n,i);let s=__($h(n,i)),r=e.map(o=>{let a=t.map((l,h)=>+(h===o));return __($h(n,a)).map((l,h)=>Math.abs(l-s[h])<Ss?0:l-s[h])});return UC(r,s).forEach((o,a)=>i[e[a]]=-o),$h(n,i)}function UC(n,t){let e=t.map((a,c)=>n.map(l=>l[c])),{values:i,vectors:s}=nn(e,n.length),r=n.map(a=>a.reduce((c,l,h)=>c+l*t[h],0)),o=n.map(()=>0);return i.forEach((a,c)=>{if(a<=Ss*i[0])return;let l=s[c].reduce((h,u,d)=>h+u*r[d],0)/(a*a);s[c].forEach((h,u)=>o[u]+=l*h)}),o}var __=n=>[...n.flatMap(({normal:t})=>t),...n.flatMap(({offset:t,fromBase:e})=>t===null||e?[]:[t])];function $h(n,t){let e=It(n,t),i=et(n),s=i.length,r=i.map(m=>e[m].z),o=i.map(m=>e[m].o),a=i.flatMap((m,g)=>n.rows[m].kind==="revolute"?[g]:[]),c=[...a,s],l=(m,g)=>Array.from({length:Math.max(0,Math.min(g+1,s)-m)},(x,_)=>m+_),h={offset:null,parallelJoints:[],fromBase:!0,toTip:!1},u=[y_(r,l(0,c[0]),[0,0,0],h)],d=[0,0,0],f=a.length?v_(d,[0,0,1],o[c[0]],r[c[0]])[1]:d,p=[];return a.forEach((m,g)=>{let x=c[g+1],_=x===s;p.length||(f=mp(o[m],r[m],f));let[b,M]=_?[e.at(-1).o,null]:[o[x],r[x]],[T,E]=v_(f,r[m],b,M);p=[...p,m];let y=!_&&w_(r[m],r[x]),S=y?null:ot(r[m],nt(T,f)),D=p[0]===a[0];u.push(y_(r,l(m,x),nt(E,T),{offset:S,parallelJoints:p,fromBase:D,toTip:_})),f=E,y||(p=[])}),u}function pp(n,t){return t?n.flatMap((e,i)=>pp(n.slice(i+1),t-1).map(s=>[e,...s])):[[]]}function y_(n,t,e,i){let s=Ct(e),r=new Map(t.map(a=>[a,n[a]]));s>Ss&&r.set(qh,Mt(1/s,e));let o=new Map;for(let[a,c]of pp(t,2))o.set(`${[a,c]}`,ot(n[a],n[c]));for(let a of pp([...r.keys()],3)){let[c,l,h]=a.map(u=>r.get(u));o.set(`${a}`,ot(kt(c,l),h))}return{joints:t,normal:e,length:s,shape:o,...i}}var mp=(n,t,e)=>Dt(n,Mt(ot(t,nt(e,n)),t));function v_(n,t,e,i){if(!i)return[mp(n,t,e),e];if(w_(t,i))return[n,mp(e,i,n)];let s=nt(e,n),r=ot(t,i),o=1-r*r,a=(ot(t,s)-r*ot(i,s))/o,c=(r*ot(t,s)-ot(i,s))/o;return[Dt(n,Mt(a,t)),Dt(e,Mt(c,i))]}var w_=(n,t)=>Ct(kt(n,t))<Ss;function FC(n){let t=et({rows:n}),e=t.map(i=>i+1);return{rows:n,joints:e,gaps:b_({rows:n}),toolCosine:BC({rows:n},t),...kC(n,t[0])}}function kC(n,t){let{z:e,o:i}=It({rows:n.slice(0,t)},[]).at(-1),s=kt([0,0,1],e),r=Ct(s)>Ss?Math.abs(ot(i,s))/Ct(s):Math.hypot(i[0],i[1]);return{axis1Distance:n[t].kind==="revolute"?r:0,axis1Angle:Xh(Math.abs(e[2])),axis1:e,up:e[2]<-Ss?-1:1}}function BC(n,t){let e=It(n,t.map(()=>0));return ot(e[t.at(-1)].z,e.at(-1).z)}function zC(n,t,e=1e-6,i=1e-4){let s=qC(n,t);if(s.length)return{differences:s,signs:[],...{baseHigher:0,upsideDown:!1},toolAngles:[0,0]};let r=XC(n,t,e,i),o=[r.length,S_(r),0],a=new Map([1,-1].map(f=>[f,{cost:o,signs:[f],differences:r}])),c={mine:n,reference:t,tolerances:{length:e,angle:i}};for(let f of n.gaps.keys())a=HC(c,f,a);let l=[...a].map(([f,p])=>GC(c,f,p)),{signs:h,differences:u,toolAngles:d}=l.reduce((f,p)=>R_(p.cost,f.cost)?p:f);return{differences:u,signs:h,baseHigher:$C(n,t,h),upsideDown:T_(n,t,h),toolAngles:d}}function GC({mine:n,reference:t,tolerances:e},i,{cost:s,signs:r,differences:o}){let a=[Xh(n.toolCosine),Xh(i*t.toolCosine)],c=s[2]+ +(I_(...a)>e.angle),l=r.reduce((h,u)=>h+u,0);return{cost:[s[0],s[1],c,-l],signs:r,differences:o,toolAngles:a}}var S_=(n,t=0)=>n.reduce((e,i)=>e+Math.abs(i.mine-i.reference),t);function E_(n,t){let[e,i]=[n,t].map(s=>FC(x_(s)));return!zC(e,i).differences.length}var T_=(n,t,e)=>!A_(n)&&e[0]*n.up*t.up<0,A_=({axis1:n})=>Math.abs(n[2])<Ss;function R_(n,t){let e=n.findIndex((i,s)=>i!==t[s]);return e>=0&&n[e]<t[e]}var VC=n=>Array.from({length:2**n},(t,e)=>Array.from({length:n},(i,s)=>e>>n-1-s&1?-1:1));function HC(n,t,e){let i=new Map;for(let s of VC(n.mine.gaps[t].joints.length)){let r=WC(n,t,s,e.get(s[0])),o=s.at(-1);(!i.has(o)||R_(r.cost,i.get(o).cost))&&i.set(o,r)}return i}function WC({mine:n,reference:t,tolerances:e},i,s,r){let[o,a]=[n.gaps[i],t.gaps[i]],c=new Map(o.joints.map((m,g)=>[m,s[g]])),h=gp(o)&&gp(a)&&_p(o,a)&&Math.abs(C_(o,a,s[0]))>e.length,u=T_(n,t,r.signs)||A_(n)&&r.signs[0]*ot(n.axis1,t.axis1)<0,d=jC(n,o,a,c,e),f=S_(d,r.cost[1]),p=r.cost[2]+Number(h)+Number(u);return{cost:[r.cost[0]+d.length,Number(f.toFixed(9)),p],signs:[...r.signs,...s.slice(1)],differences:[...r.differences,...d]}}var _p=(n,t)=>`${n.parallelJoints}`==`${t.parallelJoints}`,Es=(n,[t,e],[i,s],r=[0,0])=>({key:n,row:t,entry:e,mine:i,reference:s,ends:r}),gp=({fromBase:n,offset:t,parallelJoints:e,joints:i,toTip:s})=>n&&t!==null&&e.every((r,o)=>r===o)&&i.length+Number(s)===2,C_=(n,t,e)=>e*(t.offset??0)-(n.offset??0);function $C(n,t,e){let[i,s]=[n,t].map(({gaps:a})=>a.find(gp));if(!i||!s||!_p(i,s))return 0;let o=n.gaps.slice(1,i.parallelJoints.length).reduce((a,c)=>a*c.shape.get(`${c.joints}`),1);return n.up*Math.round(o)*C_(i,s,e[i.parallelJoints.at(-1)])}function qC(n,t){let[e,i]=[n.joints,t.joints],s=[e.length,i.length];if(s[0]!==s[1]){let r=e[Math.min(...s)-1];return[Es("table count",[r,"joints"],s)]}return e.flatMap((r,o)=>{let a=n.rows[r-1].kind,c=t.rows[i[o]-1].kind;return a===c?[]:[Es("table kind",[r,"joint"],[a,c])]})}function XC(n,t,e,i){let s=[0,n.joints[0]],r=[],o=[n.axis1Angle,t.axis1Angle];Math.abs(o[0]-o[1])>i&&r.push(Es("table lean",[1,"alpha"],o,s));let a=[n.axis1Distance,t.axis1Distance];return Math.abs(a[0]-a[1])>e&&r.push(Es("table foot",[1,"a"],a,s)),r}function jC(n,t,e,i,{length:s,angle:r}){let o=[],a=n.joints[t.joints[0]];if(Math.abs(t.length-e.length)>s){let h=t.toTip?0:n.joints[t.joints.at(-1)];o.push(Es("table distance",[a,"a"],[t.length,e.length],[a,h]))}let c=YC(n,t,e,i,r);if(o.push(...c.length?c:JC(n,t,e,i,r)),t.fromBase||!_p(t,e)||t.offset===null||e.offset===null)return o;let l=i.get(t.joints[0])*e.offset;if(Math.abs(t.offset-l)>s){let h=[n.joints[t.parallelJoints[0]],n.joints[t.parallelJoints.at(-1)]];o.push(Es("table along",[h[1],"d"],[t.offset,l],h))}return o}function YC(n,t,e,i,s){return t.joints.slice(1).flatMap((r,o)=>{let a=[t.joints[o],r],c=`${[...a,qh]}`,l=t.joints.length===2&&t.shape.has(c)&&e.shape.has(c),h=M_(t,a,l,new Map),u=M_(e,a,l,i);if(I_(h,u)<=s)return[];let d=a.map(f=>n.joints[f]);return[Es("table between",[d[0],"alpha"],[h,u],d)]})}function M_(n,t,e,i){let s=xp(n,t,i);return e?Math.atan2(xp(n,[...t,qh],i),s):Xh(s)}var xp=(n,t,e)=>t.reduce((i,s)=>i*(e.get(s)??1),n.shape.get(`${t}`));function JC(n,t,e,i,s){let r=t.joints.find(c=>n.rows[n.joints[c]-1].kind==="prismatic");if(r===void 0)return[];let o=[...t.shape.keys()].filter(c=>e.shape.has(c)).map(c=>t.shape.get(c)-xp(e,c.split(",").map(Number),i)),a=Math.max(...o.map(Math.abs));return a<=s?[]:[Es("table slide",[n.joints[r],"theta"],[a,0])]}var Xh=n=>Math.acos(Math.max(-1,Math.min(1,n)));function I_(n,t){let e=2*Math.PI,i=(n-t+Math.PI)%e;return Math.abs((i<0?i+e:i)-Math.PI)}var ZC=1e-6,yp=n=>Vs(n)?"pose":"position",D_=n=>n.filter(t=>t>ZC*n[0]).length,Yh=n=>Math.min(cn(n).length,et(n).length);function Da({arm:n,rank:t,lostMotions:e}){let[i,s]=[Yh(n),cn(n).length],r=t<i;return r?{singular:r,text:`Singular: rank ${t} of ${i}. ${tI(e,i<s)}`}:{singular:r,text:KC(n,t,i)}}function KC(n,t,e){let i=et(n).length;return i?e===6?"Rank 6: the tip can move along and turn about every direction.":lc(n)&&e>1?QC(n,t):Li(n).length<=i?`Rank ${t}: the tip can make every motion that these joints allow.`:e<3?`Rank ${t}, the most that ${i>1?`${i} joints`:"one joint"} can have.`:"Rank 3: the tip can move along every direction; with fewer than six joints it cannot be turned at will as well.":"No joint moves this arm."}function QC(n,t){let e=Vs(n)?" and turn in it":", but not turn at will as well";return`Rank ${t}: the tip can move along every direction of its plane${e}.`}var P_=n=>n.filter(t=>Math.abs(t)>.02).length;function tI(n,t){if(!n.length||t)return"";let e=n.filter(s=>P_(s)===1).map(Sd),i=n.filter(s=>P_(s)>1).map(s=>`make the motion ${Sd(s)}`);return`Here the tip cannot ${Je([...e,...i],"nor")}.`}var eI="No One Two Three Four Five Six Seven Eight".split(" "),L_=n=>`${eI[n]??n} ${n===1?"solution":"solutions"}`,N_=(n,t)=>Je(t.map(e=>`joint ${et(n)[e]+1}`));function Jh(n,{list:t,families:e,lockedJoint:i,hasOrientation:s}){let r=s?"pose":"position, whatever the tool’s direction",o=t.length-e.length,a=i<0?"":` with joint ${et(n)[i]+1} held where it is; free, it makes them infinitely many`;if(!e.length)return`${L_(t.length)} for this ${r}${a}.`;let c=e[0].moving,l=c.length===1?`${N_(n,c)} is free`:`${N_(n,c)} are free to move together`,h=e.length>1?`, in ${e.length} families`:"",u=o?` and ${L_(o).toLowerCase()} more`:"",d=i<0?"":`, joint ${et(n)[i]+1} held`,f=`one of each is shown${u}${d}`;return`Infinitely many solutions for this ${r}: ${l}${h}; ${f}.`}var Oa=(n,t)=>et(n).flatMap((e,i)=>t(e,i)?[`joint ${e+1}`]:[]),Zh=(n,t)=>Oa(n,(e,i)=>t.some(s=>mi(n.rows[e],s[i])));function vp({stops:n=[],short:t=0}){if(t<.002)return"";let e=n.length?Je(n):"out of reach";return`${pc(e)}: ${Nt(1e3*t,0)} mm short.`}function bp(n){if(!n?.target)return"";let t=n.moving?"":vp(n);if(t||!n.fading?.length)return t;let e=n.fading.length>1?"the arrows":"the arrow";return n.fading.every(({share:s})=>s<.001)?`Singular: the tip cannot move along ${e}.`:`Nearly singular along ${e}.`}var nI="Type into any entry: 0.333, −90°, pi/2, or paste a whole table. The arm follows, and the first one stays as a ghost.";function O_(n,{frames:t}){let{arm:e,base:i=e,reference:s}=n;return e===s?nI:[sI(n,t),iI(e,i)].join(" ").trim()}function iI(n,t){return n===t||!xo(t)?"":xo(n)?`Its joints keep the limits of the ${t.name}.`:`The limits of the ${t.name} are not those of this table: its joints move freely.`}function sI({arm:n,reference:t,q:e},i){let s=[et(n).length,et(t).length];if(s[0]!==s[1])return`Yours has ${s[0]} joints, the ${t.name} ${s[1]}.`;let[r,o]=[i.at(-1),It(t,e).at(-1)],a=qm(r,o)*180/Math.PI,c=1e3*Ct(nt(r.o,o.o)),h=`at these joint values its tip is ${`${Nt(c,1)} mm and ${Nt(a,1)}°`} away from the ghost’s`;return rI(n,t)?c<.05&&a<.05?`The same arm as the ${t.name}: ${h}.`:`The same arm as the ${t.name}, with another zero, direction or frame that is free to choose: ${h}, but other joint values bring it there.`:`Not the same arm as the ${t.name}: ${h}.`}var jh={arm:null,reference:null,isSame:!1};function rI(n,t){return(jh.arm!==n||jh.reference!==t)&&(jh={arm:n,reference:t,isSame:E_(n.rows,t.rows)}),jh.isSame}var wp={};ns(wp,{build:()=>cI,makeHeatTable:()=>tu,title:()=>oI});var Kh=.001,F_=(n,t)=>Math.abs(n-t)>Kh;function Qh({arm:n,answer:t,highlightedRow:e},i){if(t?.length!==6*i.length)return null;let s=i.map((d,f)=>[0,1,2,3,4,5].map(p=>t[p*i.length+f])),r=i.map((d,f)=>[0,3].map(p=>{let[m,g]=[d,s[f]].map(x=>x.slice(p,p+3));return{right:m,typed:g,size:Ct(nt(m,g)),isTurn:p===3}})),o=r.map(d=>Math.max(...d.map(({size:f})=>f))),a=et(n).indexOf(e??-1),c=a<0?o.indexOf(Math.max(...o)):a,[l,h]=r[c];return{...l.size>Kh||h.size<=Kh?l:h,joint:et(n)[c]+1}}var U_=n=>`(${n.map(t=>Nt(t,3)).join(", ")})`;function k_(n){if(!n)return"";let{joint:t,right:e,typed:i,size:s,isTurn:r}=n,a=`When joint ${t} moves alone, the tip has the ${r?"angular velocity":"velocity"} ${U_(e)}`;return s<=Kh?`${a}; the typed column says the same.`:`${a}; the typed column says ${U_(i)}, the red arrow.`}var oI="Jacobian",z_=[..."vω"].flatMap(n=>[..."xyz"].map(t=>[n,t])),aI="The ellipsoid at the tip holds every velocity that joint rates of unit length give it; where it is flat, the tip cannot go.";function cI(n,{point:t}){let e=tu(t),i=R("p.verdict"),s=R("dl.facts"),r=R("p.words",{},aI),o=R("p.verdict",{hidden:!0}),a=R("div.jacobian",{},e.root,R("div",{},o,i,s,r));function c(h,u){e.update(h,u.columns),Ot(o,k_(Qh(h,u.columns))),o.hidden=!o.textContent;let{singular:d,text:f}=Da(u);oe(i,"class",d?"verdict warning":"verdict"),Ot(i,f),s.replaceChildren(...dI(u))}return{root:a,update:c,summary:(h,u)=>[o.textContent,Da(u).text].filter(Boolean).join(" ")}}function tu(n){let t=R("tr"),e=R("tbody"),s=R("table.heat",{"aria-label":"Jacobian of the tip: one column for each joint"},R("thead",{},t),e),[r,o,a,c]=[[],[],[],null];function l(u){c=u;let d=et(u);r=d.map(p=>R("button",B_(p,n),Te("q",p+1)));let f=r.map(p=>R("th",{scope:"col"},p));t.replaceChildren(R("th",{},R("span.hidden",{},"row")),...f),a=lc(u)?Li(u):z_.map((p,m)=>m),o=a.map(()=>d.map(p=>R("td",B_(p,n)))),e.replaceChildren(...o.map((p,m)=>lI(p,a[m],a.length)))}function h({arm:u,highlightedRow:d,answer:f=null},p){c!==u&&l(u);let m=et(u).indexOf(d);r.forEach((_,b)=>oe(_,"aria-pressed",String(b===m)));let g=[0,3].map(_=>Math.max(1e-9,...p.flatMap(b=>b.slice(_,_+3).map(Math.abs)))),x=f?.length===6*p.length;o.forEach((_,b)=>_.forEach((M,T)=>{hI(M,p[T][a[b]],g[a[b]<3?0:1]),x&&uI(M,f[a[b]*p.length+T],p[T][a[b]])}))}return{root:gr("Jacobian",s),update:h}}function lI(n,t,e){let i=e<6&&t>=3,s=i?R("i",{},"φ"):Te(...z_[t]);return R(t===3||i?"tr.second":"tr",{},R("th",{scope:"row"},s),n)}function hI(n,t,e){let i=Math.abs(t)/e;Ot(n,To(t,3)),oe(n,"class",i<5e-4?"nought":t>0?"plus":"minus"),n.style.setProperty("--share",i.toFixed(2))}function uI(n,t,e){F_(t,e)&&n.append(R("span.typed",{},R("span.hidden",{},"typed: "),To(t,3)))}function B_(n,t){let[e,i]=[()=>t(n),()=>t(null)];return{onpointerenter:e,onpointerleave:i,onfocus:e,onblur:i,onclick:e}}function dI(n){let{arm:t,determinant:e,manipulability:i,singularValues:s,linearAxes:r}=n,o=d=>Math.abs(d)<5e-7?"0":Math.abs(d)<.001?Eo(d,2):Nt(d,5),a=(d,f)=>[R("dt",{},d),R("dd",{},f)],c=cn(t).every(d=>d<3),l=["det ",R("i",{},"J"),...c?[R("sub",{},"v")]:[]],h=e===null?[]:a(l,o(e)),u=Yh(t)?a("smallest σ",o(s[Yh(t)-1])):[];return[...h,...a("manipulability",o(i)),...u,...a("half axes",r.values.map(d=>Nt(d,2)).join(", "))]}var Up={};ns(Up,{build:()=>IP,makeMatrix:()=>lu,title:()=>RP});var Xe=Math.PI/180,NH=180/Math.PI;var Qe=(n,t)=>[...n].map(e=>[e,t]),V_=new Map([...Qe("−–—‐‑‒﹣－","-"),...Qe("       　"," "),...Qe("​\uFEFF⁡⁢",""),...Qe("“”„‟`‘’‚",'"'),...Qe("│┃║","|"),...Qe("º˚","°"),...Qe("⋅∙","·"),["≅","≈"],...Object.entries({"，":",","、":",","；":";","：":":","＝":"=","．":".","。":".","٫":".","（":"(","）":")"}),...[..."０１２３４５６７８９"].flatMap((n,t)=>Qe(n,`${t}`)),...[..."٠١٢٣٤٥٦٧٨٩"].flatMap((n,t)=>Qe(n,`${t}`))]),fI=new RegExp(`[${[...V_.keys()].join("")}]`,"g"),pI={"&pi;":"π","&theta;":"θ","&alpha;":"α","&tau;":"τ","&omega;":"ω","&deg;":"°","&minus;":"-","&nbsp;":" ","&times;":"*","&middot;":"·","\\times":"*","\\cdot":"*","\\pm":"±","\\approx":"≈","\\checkmark":"✓","\\degree":"°","\\circ":"°","\\radian":"rad","\\newton":"N","\\metre":"m","\\meter":"m","\\milli":"m","\\centi":"c","\\kilo":"k"},mI=/&[a-z]+;|\\[a-z]+/gi,H_="⁻⁺⁰¹²³⁴⁵⁶⁷⁸⁹",gI=new RegExp(`[⁻⁺]?[${H_.slice(2)}]+`,"g"),xI=n=>`^${[...n].map(t=>"-+0123456789"[H_.indexOf(t)]).join("")}`,Zn=n=>n.replace(fI,t=>V_.get(t)),ao=n=>n.replace(/&#8722;|(?<![\p{L}\d)] ?)minus +(?=[.\d])/gu,"-").replace(mI,t=>pI[t]??t).replace(gI,xI),_I=/\\(?:left|right|[bB]ig[lr]?|displaystyle|q?quad)(?![A-Za-z])\.?|\\[[\],;:! ()]|\$|~(?! *[\d.])/g,eu=n=>n.replace(_I," "),yI=String.raw`\\(begin|end)\{(?:\w*matrix\*?|array|tabular\*?)\}`+String.raw`(?:\[[^\]\n]{0,9}\])?(?:\{[lcr|\s]{0,60}\})?`,vI=new RegExp(String.raw`${"␞"}(?<=\[[^[\]&=]{0,200}${"␞"})(?=[^[\]&=]{0,200}\])`,"g"),bI="wrist|joint|step|column|link|angle|torque|axis|branch|sol(?:ution)?|lösung",wI=n=>`${n.trim()}_`,G_=String.raw`\{((?:[^{}]|\{(?:[^{}]|\{[^{}]*\})*\})*)\}`,MI=new RegExp(String.raw`\\(?:under|over)brace${G_}(?:[_^]${G_})?`,"g"),SI=[[/<(?<=(?:^|[=:])[ \t]{0,9}<)(?=\S[^<>\n]{0,500}[,|][^<>\n]{0,500}>)/gm,"["],[/>(?<=(?:^|[=:])[ \t]{0,9}\[[^<>[\]\n]{1,500}[,|][^<>[\]\n]{1,500}>)/gm,"]"]],EI=[[/\(\/(?=[^()]{0,2000}\/\))/g,"["],[/\/\)(?<=\[[^()[\]]{0,2000}\/\))/g,"]"]],TI=[[MI,"$1"],[/\r\n?|[\v\f]/g,`
`],[/\+?[⎛-⎭─-╬]+\+?/g," "],[/\b(?:Sin|Cos|Pi)(?![a-z])/g,n=>n.toLowerCase()],[new RegExp(String.raw`\b(?:${bI})[ \t]+(?=\d)`,"gi"),wI],[/(?<=[A-Za-z]\w*\[\d{1,2})\]\[(?=\d{1,2}\])/g,","],[/(?<=[\p{L}\p{N}_})\]][ \t]+)(?:is|equals)(?=[ \t]+[-+≈~]?[ ]?[.\d])/gu,"="],[/\.\.\.[ \t]*\n/g,"\v"],[/(\.\d{12,15})(?=-\d)/g,"$1 "],[new RegExp(yI,"g"),(n,t)=>t==="begin"?"[":"]"],[/\\(?:hline|cline\{[^{}\n]{0,20}\}|[a-z]+rule)/g," "],[/\\\\(?:\[[^\]\n]{0,9}\])?/g,"␞"],[vI,";"],[/:=\s*<<[^:]*>>/g,n=>n.replaceAll("<","[").replaceAll(">","]")],[/\bMatrix\(\s*\d{1,2}\s*,\s*\d{1,2}\s*,(?=\s*\[)/g,"("],...SI,...EI,[/^[ \t]*(?:(?:In|Out)[ \t]?\[\d{1,4}\]:?|octave:\d{1,4}>)/gm,""],[/(?<=\d)\*\^(?=-?\d)/g,"e"],[/(?<!\^)\{([-,*])\}/g,"$1"],[/\b(?:Fraction|Rational)\(\s*(-?\d+)\s*,\s*(\d+)\s*\)/g,"$1/$2"],[/(?<=\d\.\d{0,20})[dD](?=[-+]?\d{1,3}(?![\d.]))/g,"e"],[/(?<=\d\.\d{1,20})f(?:0|32|64)?(?!\w)/g,""]],AI=/(?<![\d.·])0·\d/,RI=/(?<=(?<![\d.·])\d{1,20})·(?=\d{1,20}(?![\d.·^]))/g,W_=/(?<=\S[ \t])\/(?=[ \t]\S)/g,CI=/^\s*[^\s,;|&]+(?:\s[-+]\s[^\s,;|&]+)*\s*$/;function II(n){let e=n.split(`
`).map(s=>s.split(W_)).filter(({length:s})=>s>1),i=s=>s.length>3&&s.slice(1).every(r=>CI.test(r));return e.length>0&&e.every(i)}var PI=/■\(([^■]*)\)/g,LI=/^[ \t]*- +(?=[-[{]|np\.float)|^[A-Za-z]\w*:[ \t]*(?:\n- \d[\d.]*[ \t]*){2}/m,NI=/^[ \t]*- +/gm;function Mp(n){let t=TI.reduce((o,[a,c])=>o.replace(a,c),n),e=AI.test(t.text)?t.replace(RI,"."):t,i=II(e.text)?e.replace(W_,"|"):e,r=eu(i).replace(PI,(o,a)=>`(${a.replaceAll("@","␞")})`);return LI.test(r.text)?r.replace(NI,""):r}var Zi=n=>n.split(/\r\n?|[\n\v\f]/);function $_(n,t,e){let i=o=>/[\p{L}\d]/u.test(o),s=n.findLastIndex((o,a)=>a<t&&i(o)),r=n.findIndex((o,a)=>a>e&&i(o));return[s,r].filter(o=>o>=0)}var q_=2e4,J_=60,DI=10,Z_={sin:Math.sin,cos:Math.cos,tan:Math.tan,sqrt:Math.sqrt,asin:Math.asin,acos:Math.acos,atan:Math.atan,radians:n=>n*Xe,deg2rad:n=>n*Xe,float64:n=>n},X_={"+":(n,t)=>n+t,"-":(n,t)=>n-t,"*":(n,t)=>n*t,"/":(n,t)=>t===0?NaN:n/t,"^":OI},K_={pi:Math.PI,deg:Xe,rad:1},Ts=n=>Object.hasOwn(Z_,n),Ep=n=>Object.hasOwn(K_,n);function OI(n,t){let e=n**t;return Number.isFinite(e)?e:NaN}var UI="alpha beta gamma delta theta theta phi phi psi omega lambda theta".split(" "),FI=new Map([...Qe("×·∗","*"),...Qe("÷∕⁄","/"),...Qe("′","'"),...[..."₀₁₂₃₄₅₆₇₈₉"].flatMap((n,t)=>Qe(n,`_${t}`)),...[..."αβγδθϑφϕψωλΘ"].flatMap((n,t)=>Qe(n,` ${UI[t]}`)),...Qe("π𝜋"," pi "),...Qe("°◦∘"," deg"),["√"," sqrt "],["½","(1/2)"],["¼","(1/4)"],["¾","(3/4)"]]),kI=[[/\\var(?=theta|phi)/g,"\\"],[/\\(?:boldsymbol|(?:math|text)[a-z]*)\s*\{([^{}]*)\}/g,"$1"],[/\^\s*\{?\s*°\s*\}?/g,"°"],[/(?=deg)(?<=[\d.)]\s*)deg(?:rees?|\.)(?!\s*[\w(])/g," deg"],[/_\s*\{\s*(\w+)\s*\}/g,"_$1"]],BI=[[/\\[dt]?frac\s*\{([^{}]*)\}\s*\{([^{}]*)\}/g,"(($1)/($2))"],[/(\\(?:sqrt|sin|cos|tan)|\^)\s*\{([^{}]*)\}/g,"$1($2)"]],zI=/(?<![A-Za-z_\d])([A-Za-z]+) *[[(] *([0-9]{1,2}) *[\])]/g,GI=String.raw`\d+(?:\.\d*)?(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?`,VI=String.raw`[A-Za-z][A-Za-z0-9_]*'?(?:\{[\w+-]*\})?`,Sp=new RegExp(String.raw`\s*(?:(${GI})|(${VI})|(\*\*|[-+*/^()]))`,"y"),HI=/^(?:[acdlsCS]_?\d+){2,}$/,WI=/[acdlsCS]_?\d+/g,$I=/^[+-]?(?:[0-9]+(?:\.[0-9]*)?|\.[0-9]+)(?:[eE][+-]?[0-9]+)?$/,co=n=>$I.test(n),qI=/^(?!\w*P[Ii])[A-Za-z]\w*$/,XI=/(?<![\w.\\])(?:[A-Za-z_]\w*(?:\.|::))+(?=[A-Za-z])/g,jI=/(?<![A-Za-z\d_])(?:M_)?P[Ii](?:_([24]))?(?![A-Za-z\d_])/g,Ki=n=>/\d[.,]\d/.test(n),YI=5e3,Ua=new Map;function Ce(n){return co(n)||qI.test(n)?n:(Ua.has(n)||(Ua.size>=YI&&Ua.clear(),Ua.set(n,JI(n))),Ua.get(n))}function JI(n){n=eu(ao(Zn(n))),n=n.replace(/([₀-₉])(?=[A-Za-zα-ω])/g,"$1*");for(let[t,e]of kI)n=n.replace(t,e);n=[...n].map(t=>FI.get(t)??t).join("");for(let t="";t!==n;){t=n;for(let[e,i]of BI)n=n.replace(e,i)}return n=n.replace(/\\([A-Za-z]+)/g," $1 "),n=n.replace(XI,""),n=n.replace(jI,(t,e)=>e?`(pi/${e})`:"pi"),n=n.replace(/\.(?=[*/^])/g,""),n=n.replace(/(?<=\w)\s*\(t\)/g,""),n=n.replace(zI,(t,e,i)=>Ts(e)||Ep(e)?t:`${e}_${i}`),n=n.replace(/(\b[a-z]+) +_(?=[\w{])/g,"$1_"),n=n.replace(/(?<![_\w])\{/g,"("),n=n.replace(/\{[\w+-]*\}|\}/g,t=>t==="}"?")":t),n.replace(/[ \t]+/g," ").trim()}var de=n=>Ce(n).replace(/[_{}'*^\\\s]/g,"").toLowerCase();function ui(n,t="the formula"){if(n.length>q_)throw new xt(`${t} has ${n.length} characters; expected at most ${q_}`);if(!n.trim())throw new xt(`${t} is empty; expected a number or a formula, or 0`);let e=KI(Ce(n));if(!e)throw new xt(`${t} is ${ee(n)}; expected numbers, symbols, pi, sin, cos and + - * / ^ ( )`);let[i,s]=ZI(e)??[];if(s!==e.length)throw new xt(`${t} is ${ee(n)}; expected one formula, such as '-pi/2' or 'd_6 + l_pen'`);return i}var Ri=class extends Error{};function ZI(n){try{return Q_(n,0,0)}catch(t){if(t instanceof Ri)return null;throw t}}function KI(n){let t=[];for(let e=0;e<n.length;e=Sp.lastIndex){Sp.lastIndex=e;let i=Sp.exec(n);if(!i)return null;let[,s,r,o]=i;s!==void 0?t.push(["num",s]):o!==void 0?t.push(["sign",o==="**"?"^":o]):t.push(...QI(r).map(a=>["name",a]))}return t}var QI=n=>HI.test(n)?n.match(WI):[n];function nu(n,t){if(t>=n.length)throw new Ri;return n[t]}function Q_(n,t,e){let[i,s]=j_(n,t,e);for(;s<n.length&&["+","-"].includes(n[s][1]);){let[r,o]=j_(n,s+1,e);[i,s]=[[n[s][1],i,r],o]}return[i,s]}function j_(n,t,e){let[i,s]=Fa(n,t,e);for(;s<n.length;){let[r,o]=n[s];if(o==="*"||o==="/"){let[a,c]=Fa(n,s+1,e);[i,s]=[[o,i,a],c]}else if(o==="("||r!=="sign"){if(r==="num"&&n[s-1][0]!=="sign")throw new Ri;let[a,c]=ty(n,s,e);[i,s]=[["*",i,a],c]}else break}return[i,s]}function Fa(n,t,e){if(e>J_)throw new Ri;let i=nu(n,t)[1];if(i==="-"){let[s,r]=Fa(n,t+1,e+1);return[["neg",s],r]}return i==="+"?Fa(n,t+1,e+1):ty(n,t,e)}function ty(n,t,e){let[i,s]=iu(n,t,e);if(s>=n.length||n[s][1]!=="^")return[i,s];let[r,o]=Fa(n,s+1,e+1);if(i[1]>DI&&r[1]===0)throw new Ri;return[["^",i,r],o]}function iu(n,t,e){let[i,s]=nu(n,t);if(i==="num")return[["num",Number(s),eP(s)],t+1];let r=s==="radians"?n[t+1]?.[1]==="(":t+1<n.length;if(Ts(s)&&r){if(n[t+1][1]==="^"){let[h,u]=iu(n,t+2,e+1);if(h[0]!=="num")throw new Ri;let[d,f]=Y_(n,u,e+1);return[["^",["call",s,d],h],f]}let[c,l]=Y_(n,t+1,e+1);return[["call",s,c],l]}if(i==="name")return[["name",s],t+1];if(s!=="(")throw new Ri;let[o,a]=Q_(n,t+1,e+1);return nu(n,a),[o,a+1]}function Y_(n,t,e){if(e>J_)throw new Ri;if(nu(n,t)[1]!=="-")return iu(n,t,e);let[i,s]=iu(n,t+1,e);return[["neg",i],s]}function As(n,t=new Set){for(let e=[n];e.length;){let[i,...s]=e.pop();i==="name"&&!Ep(s[0])&&t.add(s[0]),e.push(...s.filter(Array.isArray).reverse())}return t}function Fn(n,t){let e=su(n,t);if(!Number.isFinite(e))throw new xt("a formula divides by zero or is too large; expected a finite value");return e}function su(n,t){let e=[];for(;Object.hasOwn(X_,n[0]);n=n[1])e.push(n);return e.reduceRight((i,[s,,r])=>X_[s](i,su(r,t)),tP(n,t))}function tP([n,t,e],i){if(n==="num")return t;if(n==="neg")return-su(t,i);if(n==="call")return Z_[t](su(e,i));let s=Ep(t)?K_[t]:i(t);if(s===void 0)throw new xt(`no value for ${t}`);return s}function eP(n){let[t,e="0"]=n.toLowerCase().split("e"),i=t.split(".")[1];return i?.5*10**(Number(e)-i.length):0}var kn=n=>ei(()=>Fn(ui(n),()=>{})),di=n=>ei(()=>[...As(ui(n))]);var fi={mm:.001,cm:.01,m:1},we="[cm]?m";var Ap=String.raw`(?: ?[-·*×x] ?|[ .])?`,Rp="[km]?N",Cp=`${Rp}${Ap}${we}|Newton[- ]?met(?:er|re)s?`,iy="deg(?:rees?)?|Grad|°",sy=`rad(?:ians?)?|${iy}`,Kn=`(?:${Cp}|${Rp}|${we}|${sy})`,lo=n=>{let t=new RegExp(`^(?:${n})$`);return e=>t.test(e)},nP=lo(Kn),VH=lo(sy),HH=lo(we),WH=lo(Rp),$H=lo(Cp),Ip=lo(iy),ey={m:.001,c:.01,k:1e3},iP=new RegExp(`^(?:([km])?N)?(?:${Ap}([cm])?m)?$`);function ry(n){if(!nP(n)||Ip(n))return;let[,t,e]=iP.exec(n)??[];return(ey[t]??1)*(ey[e]??1)}var oy=n=>Object.keys(fi).find(t=>fi[t]===n),ru=(n,t)=>n/Math.round(1/t);var qH=new RegExp(String.raw`^[ \t\])]*((?:${Kn}|kg|m?s|Hz)(?: ?\/ ?(?:${Kn}|m?s))?)`+String.raw`(?![*·]?\p{L}|[\d_^/([]|[ \t]*[=:])`,"u");var sP=String.raw`deg(?:rees?)?(?!\p{L})|degr[ée]s?(?!\p{L})|grad[io]s?(?!\p{L})|`+String.raw`graus|градус|度|°`,XH=new RegExp(String.raw`(?<!\d\s?|\p{L})(?:${sP})`,"iu");var jH=new RegExp(String.raw`(?<![\d.]\s?|[\p{L}\d]|\bN${Ap})[cm]m(?![\p{L}\d])`,"u"),YH=new RegExp(String.raw`(?<!\p{L})(?:${Cp})(?!\p{L})`,"gu");var Tp=String.raw`10(?:\^\s*[({]?[-\u2212+]?\d+[)}]?|[⁻⁺⁰¹²³⁴-⁹]+)`,ny="(?:turn|rev(?:olution)?)s?",rP=new RegExp([String.raw`(?<=\d ?°\s?\d{1,2} ?)['′’]`,String.raw`(?<!\p{L})(?:mrad|milliradians?|gon|grads|gradians?|arcmin)(?!\p{L})`,String.raw`(?<=\d[.,]\d{1,20}\s?)${ny}(?!\p{L})`,String.raw`(?<=[[(]\s?|\bin )${ny}(?=\s?[\]):])`,String.raw`(?<!\p{L})(?:lbf?[ ·*-]?(?:ft|in)|(?:ft|in)[ ·*-]?lbf?)(?!\p{L})`,String.raw`(?<!\p{L})(?:kg[·*]?cm|kg ?[·*]? ?m(?![²^\d])|kgf ?[·*]?c?m)(?![\p{L}_])`,String.raw`(?<!\p{L})(?:inch(?:es)?|feet)(?!\p{L})`,String.raw`[([]\s*(?:[×x]\s*${Tp}|${Tp}\s*\p{L})[^()\n]{0,9}[)\]]`,String.raw`^[ \t\u00a0]*[×x]\s*${Tp}`].join("|"),"imu"),oP=/(?<!\p{L})grad(?!\p{L})/u,ay=n=>(rP.exec(n)??oP.exec(n))?.[0]??null;var cy=200,hy={angle:{units:{deg:Xe,rad:1},most:1e3,of:"an angle",such:"90°, pi/2 or 1.571 rad"},length:{units:fi,bare:"m",most:100,of:"a length",such:"metres, as 0.333"},force:{units:{N:1,kN:1e3},bare:"N",most:1e5,of:"a force",such:"newtons, as −5"},moment:{units:{Nm:1,Nmm:.001},bare:"Nm",most:1e5,of:"a moment",such:"newton metres, as 0.5"}},aP=new Set(Object.values(hy).flatMap(({units:n})=>Object.keys(n))),cP=["radians","deg2rad","asin","acos","atan"],lP=/\bN\s*\*?\s*(m{1,2})\b/g,hP=/^([^,]*),(\d[^,]*)$/,uP=/([A-Za-z_]\w*)\s*(\(|\s(?=[A-Za-z_]))/g,ou=class extends Error{};function Qi(n=""){throw new ou(n)}function dP(n){let t=n.includes(".")?n:n.trim().replace(hP,"$1.$2"),e=Ce(t).replace(lP,"N$1");for(let[,i,s]of e.matchAll(uP))i!=="pi"&&!(s==="("&&Ts(i))&&Qi();return ei(()=>ui(e))??Qi()}var ly=([n,,t])=>n==="*"&&aP.has(t[1]),fP=([,...n])=>n.filter(Array.isArray);function au(n){let[t,e,i]=n;if(t==="call")return{units:[],names:[]};if(t==="name")return{units:[],names:[e]};let s=(ly(n)?[e]:fP(n)).map(au);return{units:[...s.flatMap(({units:r})=>r),...ly(n)?[i[1]]:[]],names:s.flatMap(({names:r})=>r)}}function uy(n,t,e){let[i,s,r]=n;if(i==="name")return t[s];if(i==="num"||i==="^")return Fn(n,()=>Qi());if(i==="call")return Fn(n,()=>Qi())*(cP.includes(s)?e:1);let a=(i==="neg"?[s]:[s,r]).map(c=>["num",uy(c,t,e)]);return Fn([i,...a],()=>Qi())}var pP=1e-9;function mP(n,t,e){let i=au(n),s="rad"in t,r=s&&i.names.includes("pi")&&!i.units.includes("rad"),[o,a,c]=[1,2,3].map(d=>{let f=Object.fromEntries(Object.entries(t).map(([m,g])=>[m,g*d])),p=Math.PI*(r?d:1);return uy(n,{...f,pi:p},s?d:1)}),l=d=>Math.abs(d)<=pP*Math.max(Math.abs(o),Math.abs(a));l(c-2*a+o)||Qi("has two units");let[h,u]=[a-o,2*o-a];return l(u)?o:l(h)?o*t[e]:((r||i.units.some(d=>d!==e))&&Qi("mixes numbers with and without a unit; say the unit of each"),u*t[e]+h)}function gP(n,t){let e=dP(n),i=au(e).units.find(s=>!(s in t));return i&&Qi(`has the unit ${i==="deg"?"°":i}`),e}function ho(n,t,e=""){let{units:i,bare:s,most:r,of:o,such:a}=hy[t],c=e in i?e:s??"rad",l=`“${n.trim()}”`;if(!n.trim())return{error:"is empty; write 0 for none"};if(n.length>cy)return{error:`has ${n.length} characters; ${cy} are the most`};try{let h=gP(n,i);au(h).names.some(d=>d!=="pi")&&Qi();let u=mP(h,i,c);return Math.abs(u)>r?{error:`${l} is too large for ${o} here`}:{value:u+0}}catch(h){return{error:`${l} ${xP(h,{of:o,such:a})}`}}}function xP(n,{of:t,such:e}){if(n instanceof xt)return"divides by zero or is too large";if(!(n instanceof ou))throw n;return n.message?`${n.message}; ${t} is asked for: ${e}`:`is no number; write ${e}`}var dy=n=>/[-+*/(.,eE−–πp]\s*$/.test(n)||/^[\s\d.,]*$/.test(n);function Pp(n,t,e){let i=t&&(e||!dy(n.value))?t:"";return oe(n,"aria-invalid",String(!!i)),i}function Rs(n,t,{unit:e,whole:i}){let{value:s,error:r}=ho(n.value,t,e);return{value:s,message:Pp(n,r,i)}}var Ci=(n,t,e={})=>R("input",{type:"text",spellcheck:"false",autocomplete:"off","aria-label":n,oninput:i=>t(i.target,!1),onchange:i=>t(i.target,!0),...e});function Cs(n,t){n.getRootNode().activeElement!==n&&n.value!==t&&(n.value=t)}var my=n=>et(n).map(t=>Hn(n.rows[t])),gy=30,Lp=1e-4;function xy(n,t,e){let[i,s]=[n(t),n(Dt(t,Mt(Lp,e)))];return{at:i,rate:[(s[0]-i[0])/Lp,(s[1]-i[1])/Lp]}}function _y(n,t,{row:e,local:i,to:s,joint:r,pixel:o}){let a=et(n)[r],c=n.rows[a].kind==="revolute",l=Hn(n.rows[a]),h=[...t];for(let u=0;u<4;u++){let d=It(n,h),f=go(d[e+1],i),{z:p,o:m}=d[a],{at:g,rate:x}=xy(o,f,c?kt(p,nt(f,m)):p),[_]=Ro([x],[Ui(x,[s[0]-g[0],s[1]-g[1]])],gy**2);h[r]+=ln(_,-.2,.2)}return h[r]=ln(h[r],Math.min(l[0],t[r]),Math.max(l[1],t[r])),h}var _P=.3,fy=(n,t)=>t?n.map((e,i)=>i<3?e:_P*e):n.slice(0,3),yy=.12,Np=1e-4;function vy(n,t,e,i,{turns:s=!1}={}){let r=my(n).map(([h,u],d)=>[Math.min(h,t[d]),Math.max(u,t[d])]),o={arm:n,target:e,rest:i,turns:s,limits:r},a=py(o,t);Cd(a.q,t)&&Ct(nt(e.o,a.frames.at(-1).o))>.002&&(a=Ad(a,a.q,h=>py(o,h)));let c=Math.max(1e-12,...a.q.map((h,u)=>Math.abs(h-t[u]))),l=Math.min(1,yy/c);return{q:t.map((h,u)=>h+l*(a.q[u]-h)),arrived:l===1}}function py({arm:n,target:t,rest:e,turns:i,limits:s},r){let o=d=>fy(Mr(d.at(-1),t),i),a=(d,f)=>Ct(o(d))**2+Np*f.reduce((p,m,g)=>p+(m-e[g])**2,0),[c,l]=[r.map((d,f)=>ln(d,...s[f])),.001],h=It(n,c),u=a(h,c);for(let d=0;d<12;d++){let f=o(h),p=Ie(n,h).map(S=>fy(S,i)),m=p.map((S,D)=>Ui(S,f)-Np*(c[D]-e[D])),g=[...c.keys()].filter(S=>!(c[S]<=s[S][0]&&m[S]<0)&&!(c[S]>=s[S][1]&&m[S]>0)),[x,_]=[p,m].map(S=>g.map(D=>S[D])),b=Ro(x,_,Np+l),M=[...c];g.forEach((S,D)=>M[S]=ln(c[S]+b[D],...s[S]));let T=It(n,M),E=a(T,M);if(E>=u){l*=6;continue}let y=u-E;if([c,h,u,l]=[M,T,E,Math.max(1e-5,l/4)],y<1e-10)break}return{q:c,frames:h,error:u}}function by(n,t,e){let i=It(n,t),s=i.at(-1).o,r=nt(e,s),o=Ct(r),a=[];if(o<.002||!t.length)return{short:o,stops:a};let c=et(n),l=Ie(n,i).map(_=>_.slice(0,3)),h=c.map(_=>[n.rows[_].lower??-1/0,n.rows[_].upper??1/0]),u=l.map(_=>ot(_,r)/o),d=t.map((_,b)=>_<=h[b][0]+1e-6&&u[b]<-.001||_>=h[b][1]-1e-6&&u[b]>.001);d.forEach((_,b)=>_&&a.push(`joint ${c[b]+1} at its limit`));let f=yP(n,t,i),{values:p,vectors:m}=nn(l.filter((_,b)=>!d[b]),3),x=m.filter((_,b)=>!(p[b]>.05*p[0])).reduce((_,b)=>_+(ot(b,r)/o)**2,0);return x>.5&&f?a.push(f):x>.5&&a.push("no joint moves the tip that way here"),{short:o,stops:a}}var wy=.1;function My(n,t=!1,e=[0,1,2]){let i=t?xi(n.map(l=>l.slice(3))).map(l=>l.reduce((h,u,d)=>Dt(h,Mt(u,n[d])),[0,0,0])):n.map(l=>l.slice(0,3));if(i.length<e.length)return[];let s=i.map(l=>vn(l,e)),{values:r,vectors:o}=nn(s,e.length),a=r.map(l=>l/r[0]),c=l=>[0,1,2].map(h=>l[e.indexOf(h)]??0);return o.flatMap((l,h)=>a[h]<wy?[{direction:c(l),share:a[h]}]:[])}var Sy=({share:n})=>1-n/wy;function yP(n,t,e){let i=et(n),s=e[i[1]??0].o,r=l=>Ct(nt(It(n,l).at(-1).o,s)),o=r(t),[a,c]=[.01*Math.max(o,.1),null];return t.forEach((l,h)=>{if(h===0||n.rows[i[h]].kind!=="revolute")return;let[u,d]=[-.4,.4].map(p=>r(t.map((m,g)=>g===h?m+p:m))-o),f=Math.min(Math.abs(u),Math.abs(d));Math.sign(u)!==Math.sign(d)||f<a||([a,c]=[f,`joint ${i[h]+1} ${u<0?"straight":"folded"}, in line with joint ${i[1]+1} and the tip`])}),c}var cu=n=>n?[0,1,2,3,4,5]:[0,1,2];function Ey(n,t,e,i,{turns:s=!0}={}){let r=my(n),o=(h,u)=>h>=Math.min(r[u][0],t[u])-1e-9&&h<=Math.max(r[u][1],t[u])+1e-9,a=cu(s),c=t,l=0;for(let h=0;h<4;h++){let u=It(n,c),d=xi(Ie(n,u).map(g=>vn(g,a)));if(l=d.length,!l)break;let f=vP(c,bP(n,u,d,e)),{q:p,error:m}=Fi(n,f,i,{rows:a});if(!p.every(o)||m>1e-4)break;c=p}return{q:c,free:l}}var vP=(n,t)=>n.map((e,i)=>e+t[i]);function bP(n,t,e,{row:i,local:s,to:r,pixel:o}){let a=go(t[i+1],s),c=et(n),l=Ie(n,t,a).filter((m,g)=>c[g]<=i),h=e.map(m=>{let g=l.reduce((x,_,b)=>Dt(x,Mt(m[b],_)),[0,0,0]);return xy(o,a,g)}),u=nt([...r,0],[...h[0].at,0]).slice(0,2),d=h.map(({rate:m})=>m),f=Ro(d,d.map(m=>Ui(m,u)),gy**2),p=Math.min(1,yy/Math.max(1e-12,...f.map(Math.abs)));return c.map((m,g)=>e.reduce((x,_,b)=>x+p*f[b]*_[g],0))}var wP=22,Ty={mouse:11,touch:20,pen:16},MP=4,SP=0;function Ay(n,t,{grip:e,goTo:i}){let s=new Dp(n,t,i),{figure:r}=n,{canvas:o}=r,a=l=>s.handlePointerDown(l);r.addListener(o,"pointerdown",a,{capture:!0}),r.addListener(e,"pointerdown",l=>{l.button||s.startDrag(l,{kind:"tip"})});for(let l of[o,e])r.addListener(l,"pointermove",h=>s.handlePointerMove(h)),r.addListener(l,"pointerup",h=>s.handlePointerUp(h)),r.addListener(l,"pointercancel",h=>s.handlePointerUp(h));r.addListener(o,"pointerleave",()=>s.drag||s.highlightPart(null));let c=l=>{let[{clientX:h,clientY:u}]=l.touches;l.touches.length===1&&s.findPartUnder({clientX:h,clientY:u,pointerType:"touch"})&&l.preventDefault()};r.addListener(o,"touchstart",c,{passive:!1}),r.signal.addEventListener("abort",()=>up(s.step))}var Dp=class{constructor(t,e,i){this.picture=t,this.figure=t.figure,this.store=e,this.goTo=i,this.drag=null,this.press=null,this.step=()=>{this.drag&&!this.dragOneFrame()&&hp(this.step)}}isOnForceBall(t){let{forceBall:e}=this.picture;if(!e?.visible)return!1;let[i,s]=this.figure.projectToPixel(e.position.toArray());return Math.hypot(i-t[0],s-t[1])<wP}findPartUnder(t){let{picture:e,store:i}=this,s=this.figure.getPointerPixel(t),{state:r,derived:o}=i;if(this.isOnForceBall(s))return{kind:"force"};let a=r.view==="branches"?e.findBranchAt(s):null;if(a!==null)return{kind:"branch",branch:a};let c=Ty[t.pointerType]??Ty.touch,l=e.findLinkAt(s,c,e.listGrabbableSegments());if(!l)return null;let{frames:h}=o,u={row:l.row,local:Hm(h[l.row+1],l.point)};if(r.tipHold?.pinned)return{kind:"elbow",...u};let d=EP(r.arm,h,l,.02*e.size);return d===null?null:{kind:"link",highlightedRow:d,...u}}handlePointerDown(t){if(t.button)return;let e=this.findPartUnder(t);this.press={x:t.clientX,y:t.clientY,part:e},!(!e||e.kind==="branch")&&(t.stopImmediatePropagation(),this.startDrag(t,e))}startDrag(t,e){let{figure:i,store:s}=this,r=s.derived.frames.at(-1);this.drag={...e,id:t.pointerId,event:t,offset:[0,0],gesture:`drag ${++SP}`,rest:s.state.q,tip:r},e.kind==="tip"&&(this.drag.from=i.projectToFacingPlane(i.getPointerPixel(t),r.o)),t.target.setPointerCapture(t.pointerId);let{highlightedRow:o}=e,a=o===void 0?{}:{highlightedRow:o};s.dispatch({type:"setFields",dragging:!0,...a}),i.canvas.classList.add("held")}dragOneFrame(){let{drag:t,figure:e}=this,[i,s]=e.getPointerPixel(t.event);t.pixel=[i+t.offset[0],s+t.offset[1]];let r=e.projectToFacingPlane(t.pixel,t.tip.o),o=this.dragPart(),[a,c]=r?e.projectToPixel(r):t.pixel;return t.offset=[a-i,c-s],o}dragPart(){let{drag:t,store:e}=this;return t.kind==="tip"?this.dragTip(e.state):(t.kind==="force"&&this.dragForce(),t.kind==="link"&&this.dragLink(e.state),t.kind==="elbow"&&this.dragElbow(e.state),!0)}dragForce(){let{picture:t,figure:e,store:i,drag:s}=this,r=e.projectToFacingPlane(s.pixel,t.forceBall.position.toArray()),o=r&&[...t.computeForceFrom(r),...i.state.wrench.slice(3)];o&&i.dispatch({type:"setWrench",wrench:o,gesture:s.gesture})}dragLink({arm:t,q:e}){let{row:i,local:s,pixel:r,highlightedRow:o,gesture:a}=this.drag,c=et(t).indexOf(o),h=_y(t,e,{row:i,local:s,to:r,joint:c,pixel:u=>this.figure.projectToPixel(u)});this.store.dispatch({type:"moveJoints",q:h,gesture:a})}dragElbow({arm:t,q:e,tipHold:i}){let{row:s,local:r,pixel:o,gesture:a}=this.drag,c={row:s,local:r,to:o,pixel:u=>this.figure.projectToPixel(u)},{q:l,free:h}=Ey(t,e,c,i.pinned,{turns:i.turns});this.store.dispatch({type:"moveJoints",q:l,tipHold:{...i,free:h},gesture:a})}dragTip(t){let{pixel:e,from:i,tip:s,rest:r,gesture:o}=this.drag,a=this.figure.projectToFacingPlane(e,s.o);if(!a)return!0;let c=s.o.map((l,h)=>l+a[h]-i[h]);return Ry(this.store,t,{...s,o:c},{rest:r,gesture:o})}handlePointerMove(t){let{drag:e,figure:i}=this;e&&t.pointerId===e.id?(e.event=t,hp(this.step)):!e&&t.buttons===0&&t.target===i.canvas&&this.highlightPart(this.findPartUnder(t))}highlightPart(t){let{store:e}=this;this.figure.canvas.style.cursor=t?"pointer":"grab";let i=t?.kind==="link"?t.highlightedRow:null,s=t?.kind==="branch"?t.branch:null;e.dispatch({type:"setFields",highlightedRow:i,highlightedBranch:s})}handlePointerUp(t){let{drag:e,press:i,store:s}=this;if(e&&t.pointerId!==e.id)return;if(i&&Math.hypot(t.clientX-i.x,t.clientY-i.y)<MP&&i.part?.kind==="branch"&&this.goTo(s.state.branches.list[i.part.branch].q),e){up(this.step)&&this.dragOneFrame();let o=s.state.tipHold?.pinned?s.state.tipHold:null;s.dispatch({type:"setFields",dragging:!1,highlightedRow:null,tipHold:o})}[this.drag,this.press]=[null,null],this.figure.canvas.classList.remove("held")}};function EP(n,t,{row:e,point:i},s){let r=et(n).filter(a=>a<=e),o=a=>{let{z:c,o:l}=t[a];return n.rows[a].kind==="prismatic"||Ct(kt(c,nt(i,l)))>s};return r.reverse().find(o)??null}function Ry(n,{arm:t,q:e,keepOrientation:i},s,{rest:r,gesture:o}){let{q:a,arrived:c}=vy(t,e,s,r,{turns:i}),l=a.every((m,g)=>Math.abs(m-e[g])<1e-5),h=c||l,u=h?by(t,a,s.o):{stops:[],short:0},d=Ie(t,It(t,a)),f=My(d,i,id(t)),p={target:s.o,moving:!h,fading:f,...u};return n.dispatch({type:"moveJoints",q:a,tipHold:p,gesture:o}),h}function Op(n,t,e=null){let i=n.state.q,s={...n.derived.frames.at(-1),o:t};for(let r=0;r<60&&!Ry(n,n.state,s,{rest:i,gesture:e});r++);}var TP={ArrowLeft:[-1,0,0],ArrowRight:[1,0,0],ArrowUp:[0,1,0],ArrowDown:[0,-1,0],PageUp:[0,0,-1],PageDown:[0,0,1]},AP=.01;function Cy(n,t,e){let i=TP[e.key];if(!i)return!1;e.preventDefault(),e.stopPropagation();let s=AP*(e.shiftKey?.1:1),r=n.getCameraAxes(),{o}=t.derived.frames.at(-1);return Op(t,o.map((a,c)=>a+s*i.reduce((l,h,u)=>l+h*r[u][c],0)),"tip keys"),!0}var RP="Pose",CP="The first three columns are the tip’s axes, the fourth its place, in the base frame and in metres.";function IP(n,{announce:t}){let e=lu("T","Pose of the tip, a four by four matrix"),i=PP(n,t),s=R("p.words");return{root:R("div.pose",{},e.root,R("div",{},i.root,i.error,s)),update:(a,{frames:c})=>{let{o:l}=c.at(-1);e.update(`0,${a.arm.rows.length}`,c.at(-1)),i.update(l);let[h,u,d]=l.map(f=>Nt(1e3*f,1));Ot(s,`Tip at (${h}, ${u}, ${d}) mm. ${CP}${LP(a.mark,l)}`)},summary:()=>i.error.textContent}}function lu(n,t){let e=[0,1,2,3].map(()=>[0,1,2,3].map(()=>R("td"))),[i,s]=Te(n,""),r=e.map(l=>R("tr",{},l)),o=R("table.matrix",{"aria-label":t},r),a=(l,h)=>{Ot(s,l),Qa(h).forEach((u,d)=>u.forEach((f,p)=>{Ot(e[d][p],d===3?String(f):To(f,4)),e[d][p].classList.toggle("nought",Math.abs(f)<5e-5)}))},c=R("span",{},i,s);return{root:R("div.equation",{},c,R("span",{},"="),o),update:a}}function PP(n,t){let e=R("p.error"),i=()=>n.derived.frames.at(-1).o,s=(l,h,u)=>{let{value:d,message:f}=Rs(h,"length",{whole:u});Ot(e,f&&`${"xyz"[l]} ${f}.`),f&&t(()=>e.textContent),u&&(d!==void 0&&(Op(n,un(i(),l,d)),Ot(e,vp(n.state.tipHold??{stops:[],short:0}))),oe(h,"aria-invalid","false"),h.value=Nt(i()[l],4))},r=["x","y","z"].map((l,h)=>Ci(`Tip ${l}, typed`,(...u)=>s(h,...u),{class:"small"})),o=r.map((l,h)=>R("label",{},R("i",{},"xyz"[h])," ",l," m"));return{root:R("fieldset.wrench",{},R("legend",{},"Bring the tip to"),o),error:e,update:l=>r.forEach((h,u)=>Cs(h,Nt(l[u],4)))}}function LP(n,t){if(!n)return"";let e=n.map(i=>Nt(i,3)).join(", ");return` It is ${Nt(1e3*Ct(nt(t,n)),2)} mm from the mark at (${e}) m.`}var kp={};ns(kp,{build:()=>UP,setBar:()=>ka,title:()=>NP});var NP="Static torque",Fp=["F","M"].flatMap(n=>["x","y","z"].map(t=>[n,t,n==="F"?"N":"N m"])),DP=.01,OP=["joint","gravity","−Jᵀ F","torque","share of the limit"];function UP(n,{point:t,announce:e}){let i=FP(n,e),s=kP(t),r=R("p.verdict"),o=R("p.words"),a=R("div.torque",{},i.root,i.error,s.root,r,o);function c(l,h){let{arm:u}=l;i.update(l.wrench);let d=s.update(l,h);r.classList.toggle("warning",d.length>0),Ot(r,VP(u,d,h.gravityTorques));let f=`${Nt(h.potentialEnergy,1)} J here.`,p=u.rows.some(m=>m.body);Ot(o,p?`Gravity’s torques are the slopes of one energy, ${f}`:"")}return{root:a,update:c,summary:()=>r.textContent}}function FP(n,t){let e=R("p.error"),i=(h,u,d)=>{let{value:f,message:p}=Rs(u,h<3?"force":"moment",{whole:d}),[m,g]=Fp[h];Ot(e,p&&`${m}${g} ${p}. The last good wrench stays.`),p&&t(()=>e.textContent),f!==void 0&&s(un(n.state.wrench,h,f),`wrench ${h}`),d&&(oe(u,"aria-invalid","false"),u.value=hn(n.state.wrench[h],2))},s=(h,u)=>n.dispatch({type:"setWrench",wrench:h,gesture:u}),r=Fp.map(([h,u,d],f)=>Ci(`${h} ${u}, ${d}`,(...p)=>i(f,...p))),o=R("button",{onclick:()=>s([0,0,0,0,0,0])},"No load"),a=Fp.map(([h,u],d)=>R("label",{},R("span",{},Te(h,u)),r[d])),c=R("legend",{},"Wrench on the tool, by the world, at the tip (N, N m)"),l=h=>r.forEach((u,d)=>Cs(u,hn(h[d],2)));return{root:R("fieldset.wrench",{},c,a,o),error:e,update:l}}function kP(n){let t=R("tbody"),e=OP.map(l=>R("th",{scope:"col"},l)),i={"aria-label":"Static torque of each joint"},s=R("th",{scope:"col",hidden:!0},"typed");e.splice(-1,0,s);let r=R("table.bars",i,R("thead",{},R("tr",{},e)),t),[o,a]=[[],null];function c({arm:l,answer:h},{gravityTorques:u,wrenchTorques:d,torques:f}){a!==l&&(a=l,o=et(l).map(x=>BP(x,n)),t.replaceChildren(...o.map(({line:x})=>x)));let p=h?.length===f.length?h:null;s.hidden=!p;let m=Math.max(1e-9,...f.map(Math.abs),...(p??[]).map(Math.abs));return o.forEach((x,_)=>{[u[_],-d[_],f[_]].forEach((b,M)=>Ot(x.cells[M],Nt(b,2))),zP(x,l.rows[x.row],f[_],m),GP(x,p?.[_],f[_],l.rows[x.row].effort??m)}),o.filter(({line:x})=>x.classList.contains("over")).map(({row:x})=>`joint ${x+1}`)}return{root:gr("Torques",r),update:c}}function BP(n,t){let e=["gravity","push","total"].map(h=>R(`td.${h}`)),[i,s]=[R("span.fill"),R("span.fill.typed",{hidden:!0})],r=R("td.typed",{hidden:!0}),[o,a]=[R("span"),R("span.limit")],c=R("span.track",{"aria-hidden":!0},i,s),l=R("tr",{onpointerenter:()=>t(n),onpointerleave:()=>t(null)},R("th",{scope:"row"},Te("τ",n+1)),e,r,R("td.bar",{},c,R("span.share",{},o,a)));return{row:n,cells:e,fill:i,typed:r,typedFill:s,part:o,limit:a,line:l}}function zP({fill:n,part:t,limit:e,line:i},{effort:s,kind:r},o,a){let c=r==="revolute"?"N m":"N",l=o/(s??a);ka(n,l),i.classList.toggle("over",!!s&&Math.abs(l)>1),Ot(t,s?`${Nt(100*Math.abs(l),0)} %`:""),Ot(e,s?` of ${s} ${c}`:c)}function ka(n,t){n.style.setProperty("--from",`${50+50*Math.max(-1,Math.min(0,t))}%`),n.style.setProperty("--width",`${50*Math.min(1,Math.abs(t))}%`)}function GP({typed:n,typedFill:t},e,i,s){if(n.hidden=t.hidden=e===void 0,n.hidden)return;let r=Math.abs(e-i)>DP;Ot(n,`${Nt(e,2)}${r?" ✘":""}`),ka(t,e/s)}function VP(n,t,e){if(t.length)return`Too much for ${Je(t)}.`;if(!n.rows.some(r=>r.body))return"No masses are known of this arm, so only the push on the tool shows.";let i=n.rows.every(r=>r.kind==="fixed"||r.effort)?"Every joint can hold this. ":"",s=e.every(r=>r===0)?" Gravity asks nothing here.":"";return`${i}Drag the ball at the tip to push on the tool.${s}`}var Iy=180;function HP({z:n,o:t},e,i){let s=nt(i,t),[r,o]=[Math.cos(e),Math.sin(e)],a=Mt((1-r)*ot(n,s),n);return Dt(t,Dt(Dt(Mt(r,s),Mt(o,kt(n,s))),a))}function Py(n,t){let e=et(n),[i,s]=e.map(a=>It(n,[0,0,0])[a]),r=a=>{let c=nt(a,s.o);return[ot(s.z,c),ot(c,c)]},o=Array.from({length:Iy+1},(a,c)=>2*Math.PI*c/Iy);return[o.map(a=>r(HP(i,-a,t))),o.map(a=>r(It(n,[0,0,a]).at(-1).o))]}function Ly(n,t){let e=[];for(let i=0;i+1<n.length;i++)for(let s=0;s+1<t.length;s++){let[r,o]=[n[i],[n[i+1][0]-n[i][0],n[i+1][1]-n[i][1]]],[a,c]=[t[s],[t[s+1][0]-t[s][0],t[s+1][1]-t[s][1]]],l=o[0]*c[1]-o[1]*c[0];if(Math.abs(l)<1e-15)continue;let h=[a[0]-r[0],a[1]-r[1]],u=(h[0]*c[1]-h[1]*c[0])/l,d=(h[0]*o[1]-h[1]*o[0])/l;u>=0&&u<1&&d>=0&&d<1&&e.push([r[0]+u*o[0],r[1]+u*o[1]])}return e}var Ny=`:host {
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
`;var hu=`/* Styles shared by the explorer and the small figures: colours, controls, the picture. */
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
  --y: light-dark(#00775a, #3cc79b);
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
.labels > span {
  position: absolute;
  font-size: 12.5px;
  line-height: 1;
  -webkit-text-stroke: 4px var(--ground);
  paint-order: stroke fill;
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
.legend {
  position: absolute;
  right: 12px;
  bottom: 12px;
  display: flex;
  gap: 10px;
  font-size: 13px;
  line-height: 1.2;
  pointer-events: none;
}
.legend span::before {
  content: "";
  display: inline-block;
  width: 14px;
  margin-right: 4px;
  border-top: 3px solid;
  vertical-align: middle;
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
  height: 24px; /* the smallest target that WCAG 2.2 allows */
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
/* A bar that grows from its middle to either side. */
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
  left: var(--from);
  width: var(--width);
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
/* Touch screens */
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
  border: 1.5px dashed color-mix(in srgb, var(--accent) 60%, transparent);
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
.stage:not(.drawn) .labels {
  visibility: hidden; /* one picture at a time */
}
/* The still picture can be grabbed: the live one begins with the drag. */
.stage:not(.drawn) .paper {
  pointer-events: none;
}
.stage:not(.drawn) .grip {
  opacity: 0; /* the still picture has another scale */
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
@media print {
  .explorer,
  .live {
    color-scheme: light;
  }
}
/* Only the still picture is shown where nothing can be touched, as on paper. */
@media print, (scripting: none) {
  .explorer,
  .live {
    display: block !important;
    border: 0;
    background: none;
  }
  :is(header, .notice, .sliders, .views, .side),
  .stage > :not(.paper, .legend) {
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
  .explorer,
  .live {
    break-inside: avoid;
  }
  .legend {
    position: static;
    justify-content: center;
  }
}
`;var uu=class extends Ae{constructor(t,e){super(),this.size=t;let i=new Ke({color:e.bad});this.wall=Pa(.16*t,Vh(e.bad,.3)),this.rod=Gh(i),this.ball=Ia(i),this.ball.scale.setScalar(.01*t),this.visible=!1,this.add(this.wall,this.rod,this.ball)}placeBetween(t,e){let i=new P(...nt(e,t)).normalize();so(this.rod,t,e,.002*this.size),this.ball.position.fromArray(e),this.wall.position.fromArray(t).addScaledVector(i,.006*this.size),this.wall.quaternion.setFromUnitVectors(new P(0,0,1),i)}};var qP=.25,XP=.007,Dy=[0,0,0],du=class extends Ae{constructor(t,e){super(),this.add(new Jn(t),new Jn(e))}place(t,e,i,s){let r=e.view==="jacobian"?Qh(e,i):null,o=r?[r.right,r.typed]:[Dy,Dy],a=qP*s/Math.max(...o.map(Ct),1e-9);return this.children.forEach((c,l)=>c.placeAlong(t,Mt(a,o[l]),XP*s)),r?o.map(c=>Dt(t,Mt(a,c))):[]}};var cr=(n,t)=>n.rows.flatMap((e,i)=>{let[s,r]=[t[i].o,t[i+1].o],o=nt(r,Mt(e.a,t[i+1].x));return[{row:i,from:s,to:o},{row:i,from:o,to:r}]}),fu=(n,t,e)=>et(n).map(i=>{let s=Mt(.05*e,t[i].z);return{row:i,from:nt(t[i].o,s),to:Dt(t[i].o,s)}});function Oy(n,t,e,i){let s=null;for(let{row:r,from:o,to:a}of n){let{share:c,gap:l}=Fy(t,i(o),i(a));l>e||s&&l>=s.gap-.5||(s={row:r,gap:l,point:Dt(o,Mt(c,nt(a,o)))})}return s}var Uy=(n,t,e)=>Fy(n,t,e).gap;function Fy(n,t,e){let[i,s]=n,[r,o]=[e[0]-t[0],e[1]-t[1]],a=r*r+o*o,c=((i-t[0])*r+(s-t[1])*o)/a,l=a<1?1:Math.min(1,Math.max(0,c));return{share:l,gap:Math.hypot(t[0]+l*r-i,t[1]+l*o-s)}}var ky=[22,15],jP=9,YP=[[0,-1],[0,1],[1,0],[-1,0],[.8,-.8],[-.8,.8],[.8,.8],[-.8,-.8]],JP=[[0,0],...[15,22,30].flatMap(n=>YP.map(([t,e])=>[n*t,n*e]))];function ZP([n,t],e,i,s,r){let o=([l,h])=>i.every(({spot:u,width:d})=>Math.abs(u[0]-l)>(e+d)/2||Math.abs(u[1]-h)>ky[1]),a=l=>s.every(({from:h,to:u})=>Uy(l,h,u)>r+jP),c=JP.map(([l,h])=>[n+l,t+h]).filter(o);return c.find(a)??c[0]??null}var pu=class{constructor(t){this.host=t,this.labels=[]}setLabels(t){for(this.labels=t;this.host.children.length<t.length;)this.host.append(R("span",{},R("i"),R("sub"),R("span")));t.forEach(({letter:e,index:i="",length:s=""},r)=>{let o=this.host.children[r];oe(o,"class",`axis-${e}`),Ot(o.children[0],e),Ot(o.children[1],i),Ot(o.children[2],s&&`: ${s}`)})}placeLabels(t,{width:e,height:i},s,r){let o=[],a=this.labels.map(({end:c,index:l="",length:h=""})=>{let[u,d]=t(c),f=u>-20&&d>-20&&u<e+20&&d<i+20,p=ky[0]+4*Math.max(0,l.length-1)+8*h.length,m=f&&ZP([u,d],p,o,s,r);if(!m)return null;o.push({spot:m,width:p});let[g,x]=m.map(_=>_.toFixed(1));return`translate(${g}px, ${x}px) translate(-50%, -50%)`});[...this.host.children].forEach((c,l)=>{c.hidden=!a[l],a[l]&&(c.style.transform=a[l])})}dispose(){this.host.replaceChildren()}};var Bp={trace:null,wantedPath:null,tipPaths:null,progress:0,playing:!1,branches:null,highlightedBranch:null,highlightedRow:null,tipHold:null,mark:null,answer:null,blended:null,runs:[],chosenRun:0,runStart:null},By=["wantedPath","progress","playing"],KP={arm:Object.keys(Bp),q:["answer"],wrench:["answer"],circle:["trace",...By],trace:By,branches:["highlightedBranch"],view:["playing","highlightedBranch","highlightedRow"]},Vy=["arm","base","reference","q","wrench","runs","chosenRun"],QP=200,tL={selectArm:(n,{arm:t,q:e})=>iL(t,e),editTable:(n,{rows:t,rowBefore:e})=>sL(n,t,e),replaceTable:(n,{rows:t})=>rL(n,t),blendTables:(n,{rows:t,share:e})=>uc(n,t,e),moveJoints:(n,{q:t,tipHold:e=null})=>yn(n.arm,t)?{q:t,tipHold:e,playing:!1}:null,glide:(n,{q:t})=>yn(n.arm,t)?{q:t}:null,seek:(n,{progress:t})=>oL(n,t),setPlaying:(n,{on:t})=>t&&!n.trace?null:{playing:t},setWrench:(n,{wrench:t})=>t.length===6&&t.every(Number.isFinite)?{wrench:t}:null,setCircle:(n,{type:t,...e})=>({circle:{...n.circle,...e}}),setTrace:(n,{arm:t,circle:e,path:i,wantedPath:s})=>t===n.arm&&e===n.circle?{trace:i,wantedPath:s,progress:0,q:i[0]}:null,setBranches:(n,{arm:t,branches:e})=>t===n.arm?{branches:e}:null,setFields:(n,{type:t,gesture:e,...i})=>zy(n,i),replaceState:(n,{type:t,...e})=>yn(e.arm??n.arm,e.q??n.q)?zy(n,e):null,undo:n=>Gy(n,"past","future"),redo:n=>Gy(n,"future","past")};function zy(n,t){let e=Object.keys(t).filter(s=>!Object.hasOwn(n,s));if(!e.length)return t;let i=Object.keys(n).join(", ");throw new Error(`the state has no field ${e.join(", ")}; expected some of ${i}`)}function eL(n,t){let e=tL[t.type](n,t);if(!e)return n;let i=Object.keys(e).filter(o=>e[o]!==n[o]);if(!i.length)return n;let s=i.flatMap(o=>KP[o]??[]).filter(o=>!(o in e)),r={...n,...Object.fromEntries(s.map(o=>[o,Bp[o]])),...e};return nL(n,Hy(r),t)}var Hy=n=>n.view==="homework"&&!n.runStart?{...n,runStart:n.q}:n;function nL(n,t,{type:e,gesture:i=null}){if(["undo","redo","seek","setTrace"].includes(e)||Vy.every(r=>n[r]===t[r]))return t;if(i!==null&&n.past.at(-1)?.gesture===i)return t.future=[],t;let s=[...n.past,Wy(n,i)].slice(-QP);return{...t,past:s,future:[]}}var Wy=(n,t)=>({gesture:t,...Object.fromEntries(Vy.map(e=>[e,n[e]]))});function Gy(n,t,e){let i=n[t].at(-1);if(!i)return null;let{gesture:s,...r}=i;return{...r,playing:!1,[t]:n[t].slice(0,-1),[e]:[...n[e],Wy(n,null)]}}function iL(n,t){let e=yn(n,t)?t:is(n);return{arm:n,base:n,reference:n,q:e}}function sL(n,t,e=i=>i){if(zs(t))return null;let{rows:i}=n.arm;if(t.length===i.length&&t.every((r,o)=>cc(r,i[o])))return null;let s=Gs(t,n.base);return{arm:s,q:ed(n.arm,n.q,s,e)}}function rL({base:n},t){if(zs(t))return null;let e=Gs(t,n),i=e===n?n:{...e,home:[]};return{arm:i,q:et(i).map(()=>0)}}function oL({trace:n,arm:t},e){if(!n||!n.every(r=>r.length===n[0].length)||!yn(t,n[0]))return null;let i=Math.min(n.length-2,Math.floor(e*(n.length-1))),s=e*(n.length-1)-i;return{progress:e,q:n[i].map((r,o)=>r+s*(n[i+1][o]-r))}}var gu=n=>Hy({base:n.arm,reference:n.arm,wrench:[0,0,0,0,0,0],unit:"deg",view:"pose",frames:"ends",circle:{normal:"x",radius:.1},keepOrientation:!1,dragging:!1,past:[],future:[],...Bp,...n}),mu=class{#t=new Map;constructor(t,e,i){this.arm=t,this.q=e,this.wrench=i}#e(t,e){return this.#t.has(t)||this.#t.set(t,e()),this.#t.get(t)}get frames(){return this.#e("frames",()=>It(this.arm,this.q))}get columns(){return this.#e("columns",()=>Ie(this.arm,this.frames))}get taskAxes(){return this.#e("taskAxes",()=>{let t=cn(this.arm),e=this.columns.map(o=>vn(o,t)),{values:i,vectors:s}=nn(e,t.length),r=o=>[0,1,2,3,4,5].map(a=>o[t.indexOf(a)]??0);return{values:i,vectors:s.map(r)}})}get linearAxes(){let t=()=>this.columns.map(e=>e.slice(0,3));return this.#e("linearAxes",()=>nn(t(),3))}get singularValues(){return this.taskAxes.values}get rank(){return D_(this.singularValues)}get lostMotions(){return this.#e("lostMotions",()=>tg(this.taskAxes.vectors.slice(this.rank)))}get determinant(){let t=cn(this.arm),e=()=>this.columns.map(i=>vn(i,t));return this.#e("determinant",()=>Qm(e()))}get manipulability(){let{singularValues:t,columns:e}=this,i=Math.min(t.length,e.length);return t.slice(0,i).reduce((s,r)=>s*r,1)}get gravityTorques(){return this.#e("gravityTorques",()=>ic(this.arm,this.frames))}get potentialEnergy(){return Wm(this.arm,this.frames)}get wrenchTorques(){return this.#e("wrenchTorques",()=>sc(this.columns,this.wrench))}get torques(){return this.gravityTorques.map((t,e)=>t-this.wrenchTorques[e])}};function xu({branches:n},{frames:t}){if(!n)return null;let{x:e,y:i,z:s,o:r}=t.at(-1),o=Ct(nt(r,n.target.o)),a=n.hasOrientation?Math.max(...Object.entries({x:e,y:i,z:s}).map(([c,l])=>Ct(nt(l,n.target[c])))):0;return o>5e-4||a>.002?{distance:o,turn:a}:null}var lr=class{#t=new Set;constructor(t){this.state=t,this.derived=new mu(t.arm,t.q,t.wrench)}dispatch(t,e="reader"){let i=this.state,s=eL(i,t);if(s===i)return!1;let r=new Set(Object.keys(s).filter(o=>s[o]!==i[o]));this.state=s,["arm","q","wrench"].some(o=>r.has(o))&&(this.derived=new mu(s.arm,s.q,s.wrench));for(let o of[...this.#t])o(r,e);return!0}listen(t,e){this.#t.add(t),e?.addEventListener("abort",()=>this.#t.delete(t),{once:!0})}};function $y({arm:n,trace:t,wantedPath:e,tipPaths:i},{size:s,look:r,dark:o}){let a=t?.map(f=>It(n,f).at(-1).o)??i?.[0]?.points??[],c=i?i.map(({points:f,colour:p})=>oo(f,.003*s,p)):[oo(a,.0035*s,r.path)];e?.length>t?.length&&c.push(oo(e,.0018*s,r.wantedPath));let l=Vh(r.ghost,o?.16:.1),h=a.length>2?o_(e??a,l):null;if(!h)return{parts:c,labels:[]};let u=aL(h),d=new Ke({color:r.wantedPath});for(let{start:f,vector:p}of u){let m=new Jn(d);m.placeAlong(f,p,.0022*s),c.push(m)}return{parts:[h.wall,...c],labels:u.map(({label:f})=>f)}}function aL({centre:n,radius:t,normal:e}){let i=[0,1,2].filter(r=>Math.abs(e[r])<.02),s=n.map((r,o)=>i.includes(o)?r-1.5*t:r);return i.map(r=>{let o=[0,1,2].map(c=>c===r?t:0),a=`${hn(t,3)} m`;return{start:s,vector:o,label:{end:Dt(s,Mt(1.2,o)),letter:"xyz"[r],length:a}}})}var zp=10,Gp=.36,_u=class{constructor(t,e,i){let s=()=>this.placeOverlays();this.figure=new Hh(t,{...i,onDraw:s,onResize:()=>this.placeGrip()}),this.labels=new pu(e),this.options=i,this.world=null,this.arm=null,this.frames=null,this.hasDrawnAxes=[],this.lastDrawn={},this.pathLabels=[]}buildWorld(t,e){let i=Qx[e?"dark":"light"];this.world&&ar(this.world),this.arm=t,this.dark=e,this.look=i,this.size=mr(t),this.lastDrawn={},this.tints={highlight:new $t(i.highlight),bad:new $t(i.bad)},this.body=cL(t,i),this.jointAxis=Gh(new Ke({color:i.highlight,transparent:!0,opacity:.75})),this.triads=new kh(e,t.rows.length+1),this.barrier=new uu(this.size,i),this.pathGroup=new Ae,this.ghostGroup=new Ae,this.referenceGroup=new Ae,this.world=new Ae,this.world.add(this.body,a_(this.size,i.grid,i.gridStrength),r_(this.size,i),this.triads,this.jointAxis,...this.makeMarkers(i),this.barrier,this.pathGroup,this.ghostGroup,this.referenceGroup),this.figure.scene.add(this.world),this.figure.setLights(this.size,i)}makeMarkers(t){let e=new Ke({color:t.force}),i=new Ke({color:t.bad});this.ellipsoid=new Bh(t.ellipsoid),this.forceArrow=new Jn(e),this.forceBall=Ia(e),this.forceBall.scale.setScalar(.022*this.size),this.comparedArrows=new du(e,i),this.pointMarker=Ia(i),this.pointMarker.scale.setScalar(.014*this.size),this.fadingArrows=new Ae;for(let s=0;s<6;s++)this.fadingArrows.add(new Jn(i));return[this.ellipsoid,this.forceArrow,this.forceBall,this.pointMarker,this.fadingArrows,this.comparedArrows]}draw(t,e,i){let s=i==="dark",[r,o]=[!this.body,this.arm],a=o!==t.arm,c=this.frames&&this.figure.isInView(this.frames.at(-1).o);(a||this.dark!==s)&&this.buildWorld(t.arm,s);let{frames:l}=e,h=l.at(-1).o;if(this.frames=l,this.body.placeAtFrames(l),this.tintJoints(t),this.drawAxis(l[t.highlightedRow]),this.ellipsoid.visible=t.view==="jacobian",this.ellipsoid.visible){let d=.15*this.size/Math.max(e.linearAxes.values[0],1e-6);this.ellipsoid.placeAt(h,e.linearAxes,d,.003*this.size)}this.drawComparison(h,t,e.columns),this.drawForce(h,t),this.drawPath(t),this.drawFrames(l,t.frames),this.drawGhosts(t,e),this.drawReference(t),this.drawBarrier(h,t.tipHold),this.drawFading(h,t.tipHold?.fading??[]),this.drawMark(t.mark);let u=a&&et(o??t.arm).length!==et(t.arm).length;r||u||a&&!c?this.fitView():c&&this.figure.widenView(h),this.figure.requestDrawing()}tintJoints({highlightedRow:t,q:e,arm:i}){let s=et(i).filter((o,a)=>mi(i.rows[o],e[a])),r=[t,...s].join();this.lastDrawn.tinted!==r&&(this.lastDrawn.tinted=r,this.body.tintJoints(o=>o===t?this.tints.highlight:s.includes(o)?this.tints.bad:null))}drawAxis(t){let e=t?Mt(.16*this.size,t.z):[0,0,0],[i,s]=t?[nt(t.o,e),Dt(t.o,e)]:[e,e];so(this.jointAxis,i,s,.0025*this.size)}drawFrames(t,e){let i=.1*this.size,s=new Map;this.hasDrawnAxes=t.map((r,o)=>e==="all"||o===0||o===t.length-1),this.triads.placeAtFrames(t,i,this.hasDrawnAxes),t.forEach((r,o)=>{if(this.hasDrawnAxes[o])for(let a of["x","z"]){let c=Dt(r.o,Mt(1.22*i,r[a])),l=a+c.map(u=>Math.round(u/this.size*500)).join(),h=[...s.get(l)?.indices??[],o+this.options.firstFrame];s.set(l,{end:c,letter:a,index:h.join(",")})}}),this.labels.setLabels([...this.pathLabels,...[...s.values()].reverse()])}drawComparison(t,e,i){this.comparedEnds=this.comparedArrows.place(t,e,i,this.size);let s=this.comparedEnds.length>0;s&&!this.lastDrawn.compared&&this.fitView(),this.lastDrawn.compared=s}drawForce(t,{view:e,wrench:i}){let s=i.slice(0,3),r=e==="torque",o=Ct(s),a=o?Mt(Gp*this.size/(o+zp),s):[0,0,0];this.forceArrow.placeAlong(nt(t,a),a,.007*this.size),this.forceArrow.visible&&=r,this.forceBall.visible=r,this.forceBall.position.fromArray(nt(t,a)),this.tip=t,r&&!this.lastDrawn.force&&this.fitView(),this.lastDrawn.force=r}computeForceFrom(t){let e=nt(this.tip,t),i=Math.min(Ct(e),Gp*this.size*(100/(100+zp)));if(i<.015*this.size)return[0,0,0];let s=zp*i/(Gp*this.size-i);return Mt(s/Ct(e),e)}drawPath(t){let{view:e,trace:i}=t,s=["trace","torque","homework"].includes(e)?i:null,r=e==="homework"?t.tipPaths:null;if(this.lastDrawn.path===s&&this.lastDrawn.tipPaths===r||(Object.assign(this.lastDrawn,{path:s,tipPaths:r}),Wh(this.pathGroup),this.pathLabels=[],!s&&!r?.length))return;let{parts:o,labels:a}=$y({...t,trace:s,tipPaths:r},this);this.pathGroup.add(...o),this.pathLabels=a}drawGhosts(t,e){let{view:i,branches:s,q:r,highlightedBranch:o}=t,a=xu(t,e)&&o===null,c=i==="branches"&&!a?s:null;this.lastDrawn.branches!==c&&this.makeGhosts(t.arm,c),this.ghostGroup.children.forEach((l,h)=>{l.visible=!Cc(t.arm,c.list[h].q,r),l.placeAtFrames(l.userData,h===o?.97:.3)})}makeGhosts(t,e){Wh(this.ghostGroup),(e?.list??[]).forEach(({q:i},s)=>{let r=new Si({color:Tn(s),roughness:.7}),o=new ro(t,{link:r,joint:r,ghost:!0});o.userData=It(t,i),this.ghostGroup.add(o)}),this.lastDrawn.branches=e,e&&!this.lastDrawn.hasBranches&&this.fitView(),this.lastDrawn.hasBranches=!!e}drawReference({view:t,reference:e,q:i,arm:s}){let o=t==="table"&&e&&e!==s&&et(e).length===i.length?e:null;if(this.lastDrawn.reference!==o&&(Wh(this.referenceGroup),this.lastDrawn.reference=o,o)){let c=c_(this.look.ghost);this.referenceGroup.add(new ro(o,{link:c,joint:c,ghost:!0}))}if(!o)return;let a=this.referenceGroup.children[0];a.placeAtFrames(It(o,i),.97*this.size/a.size)}drawFading(t,e){this.fadingArrows.children.forEach((i,s)=>{let r=e[Math.floor(s/2)],o=s%2?-this.size:this.size,a=r?Mt(o*(.04+.1*Sy(r)),r.direction):[0,0,0];i.placeAlong(r?Dt(t,Mt(.03*o,r.direction)):t,a,.004*this.size)})}drawMark(t){this.pointMarker.visible=!!t,this.lastDrawn.mark!==t&&(this.lastDrawn.mark=t,t&&this.pointMarker.position.fromArray(t),t&&this.fitView())}drawBarrier(t,e){let s=(e?.target?Ct(nt(e.target,t)):0)>.004*this.size&&!e.moving;this.barrier.visible=s,s&&this.barrier.placeBetween(t,e.target)}fitView(){let t=.13*this.size,e=this.frames.flatMap(({x:a,z:c,o:l})=>[l,...[a,c].map(h=>Dt(l,Mt(t,h)))]),i=(this.lastDrawn.branches?.list??[]).flatMap(({q:a})=>It(this.arm,a).map(c=>c.o)),s=[this.forceBall,this.pointMarker].filter(({visible:a})=>a).map(({position:a})=>a.toArray()),r=sd(this.arm),o=r?[]:[[0,0,.3*this.size]];this.figure.fitView([...e,...i,...s,...this.comparedEnds,[0,0,0],...o],r??fp)}getCameraAxes(){return[0,1,2].map(t=>new P().setFromMatrixColumn(this.figure.camera.matrixWorld,t).toArray())}placeOverlays(){let t=r=>this.figure.projectToPixel(r),i=[...cr(this.arm,this.frames),...fu(this.arm,this.frames,this.size)].map(({from:r,to:o})=>({from:t(r),to:t(o)})),s=this.figure.measurePixels(lp*this.size,this.frames[0].o);this.labels.host.hidden=!1,this.labels.placeLabels(t,this.figure,i,s),this.placeGrip(),this.options.onDrawn()}placeGrip(){this.frames&&this.options.onPlace(this.figure.projectToPixel(this.frames.at(-1).o))}listGrabbableSegments(){return[...this.frames.flatMap(({o:e,x:i},s)=>{if(!this.hasDrawnAxes[s]||s===0)return[];let[r,o]=[.05,.1].map(a=>Dt(e,Mt(a*this.size,i)));return[{row:s-1,from:r,to:o}]}),...cr(this.arm,this.frames)]}findLinkAt(t,e=14,i=cr(this.arm,this.frames)){return Oy(i,t,e,s=>this.figure.projectToPixel(s))}findBranchAt(t){return this.ghostGroup.children.flatMap(({visible:i,userData:s},r)=>{let o=i&&this.findLinkAt(t,7,cr(this.arm,s));return o?[{i:r,gap:o.gap}]:[]}).sort((i,s)=>i.gap-s.gap)[0]?.i??null}dispose(){this.labels.dispose(),this.world&&ar(this.world),this.figure.dispose()}};function cL(n,t){let e=new Si({color:t.link,roughness:.45,metalness:.02}),i=new Si({roughness:.4,metalness:.1});return new ro(n,{link:e,joint:i,jointColour:new $t(t.joint)})}function qy(n,t,e){let i=t.map((c,l)=>{let h=n.map(u=>u[l]);return[Math.min(...h),Math.max(...h)]}),s=i.map(([c,l],h)=>e*t[h]/Math.max(l-c,1e-9)),r=Math.min(...s),[o,a]=i.map(([c,l])=>(c+l)/2);return([c,l])=>[t[0]/2+r*(c-o),t[1]/2-r*(l-a)]}var[Vp,Xy]=[480,320],lL=.81,hL=[.6816,.7317,0],uL=[-.2514,.2342,.9391];function jy({arm:n,trace:t,frames:e},{frames:i},s){let r=mr(n),a=i.filter((x,_)=>e==="all"||_===0||_===i.length-1).flatMap(x=>Object.entries(Aa.light).map(([_,b])=>{let M=Dt(x.o,Mt(.1*r,x[_]));return{points:[x.o,M],width:2.5,colour:b}})),c=cr(n,i).map(({from:x,to:_})=>[x,_]),l=fu(n,i,r).map(({from:x,to:_})=>[x,_]),h=t?.map(x=>It(n,x).at(-1).o)??[],u=x=>[ot(hL,x),ot(uL,x)],d=[...c.flat(),...a.flatMap(({points:x})=>x),...h].map(u),f=qy(d,[Vp,Xy],lL),p=x=>f(u(x)),m=(x,_,b="currentColor",M="round")=>x.map(T=>dL(T.map(p),{width:_,colour:b,ends:M})),g=(x,_)=>Pe("g",{opacity:x},..._);return Pe("svg",{viewBox:`0 0 ${Vp} ${Xy}`,width:Vp,class:"still",role:"img","aria-label":s},g(.35,m(c,10)),g(.75,m(l,12,"currentColor","butt")),...m(h.length?[h]:[],2.5,Aa.light.x),...a.flatMap(({points:x,width:_,colour:b})=>m([x],_,b)))}function dL(n,{width:t,colour:e,ends:i}){let s=n.map(o=>o.map(a=>a.toFixed(1)).join(",")).join(" ");return Pe("polyline",{points:s,...{fill:"none",stroke:e,"stroke-width":t,"stroke-linecap":i,"stroke-linejoin":"round"}})}var fL="Picture of the arm. Arrow keys turn the view, plus and minus bring it nearer and farther, 0 fits it. The button at the tip moves the tip; the sliders turn the joints.",pL="Arrow keys move the tip across the picture, Page keys to and fro.",mL="The browser took the picture’s graphics away; it comes back when it can.",gL="No WebGL in this browser: a drawing follows.",xL={ArrowLeft:[-.12,0],ArrowRight:[.12,0],ArrowUp:[0,-.1],ArrowDown:[0,.1],"+":[0,0,.9],"=":[0,0,.9],"-":[0,0,1.1]},_L=.06;function yu(n,t){let{goTo:e,id:i,announce:s=()=>{},signal:r,isGrabbable:o=!0,hasTipBar:a=!0}=t,c=g=>{!m.picture||!Cy(m.picture,n,g)||s(()=>bp(n.state.tipHold))},l=wL(i,AL(n,a),c),{paper:h,grip:u,tipButtons:d}=l,f=R("div.stage",{tabindex:0,role:"application","aria-label":fL});f.append(...Object.values({...l,tipButtons:d.root}));let p=()=>bL(h,n);p();let m=vL(f,l,t.firstFrame??0,p);return m.picture&&o&&Ay(m.picture,n,{grip:u,goTo:e}),f.addEventListener("dblclick",()=>m.picture?.fitView()),f.addEventListener("keydown",g=>{g.target===f&&TL(m.picture,g.key)&&g.preventDefault()}),m.picture&&addEventListener("beforeprint",p,{signal:r}),{root:f,get picture(){return m.picture},draw(g,x,_){m.picture?m.picture.draw(g,x,_):p()},update(g){yL(l,g,o&&!!m.picture)},fit:()=>m.picture?.fitView(),dispose:()=>m.picture?.dispose()}}function yL({tipButtons:n,grip:t,why:e},i,s){n.update(i);let r=i.view!=="torque"||i.wrench.slice(0,3).some(Boolean);t.hidden=!s||!et(i.arm).length||!r;let o=bp(i.tipHold);Ot(e,o),e.hidden=!o}function vL(n,t,e,i){let r={picture:EL(n,t,{firstFrame:e,onUnavailable:()=>{r.picture?.dispose(),r.picture=null,t.grip.hidden=!0,i(),Yy(n,t)}})};return r}function bL(n,{state:t,derived:e}){n.replaceChildren(jy(t,e,SL(t)),R("slot"))}var wL=(n,t,e)=>({paper:R("div.paper"),labels:R("div.labels",{"aria-hidden":"true",hidden:!0}),legend:ML(),grip:R("button.grip",{"aria-label":"Tip","aria-describedby":`${n}-grip`,onkeydown:e,title:"Drag the tip: the joints follow. Arrow keys move it too."}),help:R("span.hidden",{id:`${n}-grip`},pL),tipButtons:t,why:R("p.why",{"aria-hidden":"true"}),lost:R("p.lost",{hidden:!0},mL)}),ML=()=>R("p.legend",{"aria-hidden":"true"},[..."xyz"].map(n=>R(`span.axis-${n}`,{},R("i",{},n))));function SL({arm:n,q:t,unit:e}){let i=et(n).map((s,r)=>`q_${s+1} = ${In(n.rows[s],t[r],e)}`);return`Still picture of the ${n.name}${i.length?` at ${i.join(", ")}`:""}.`}function EL(n,t,{firstFrame:e,onUnavailable:i}){let{labels:s,grip:r,tipButtons:o,lost:a}=t;try{let c=new _u(n,s,{firstFrame:e,onUnavailable:i,onContextChange:l=>a.hidden=!l,onPlace:([l,h])=>r.style.transform=`translate(${l}px, ${h}px)`,onDrawn:()=>n.classList.add("drawn")});return c.figure.getFootHeight=()=>o.root.offsetHeight+40,c}catch{return Yy(n,t),null}}function Yy(n,{tipButtons:t,lost:e}){n.setAttribute("role","group"),n.setAttribute("aria-label","Picture of the arm"),n.removeAttribute("tabindex"),t.root.hidden=!0,Ot(e,gL),e.hidden=!document.defaultView}function TL(n,t){let e=xL[t];return t==="0"?n?.fitView():e&&n?.figure.turnView(...e),t==="0"||!!e}function AL(n,t){let e=(l,h,u)=>R("button",{title:h,onclick:u},l),i=e("Keep direction","A dragged tip keeps the direction of the tool too",()=>n.dispatch({type:"setFields",keepOrientation:!n.state.keepOrientation})),r=e("Pin the tip","Hold the tip where it is, and drag the elbow through what is left",()=>RL(n)),o=[-1,1].map(l=>{let d={"aria-label":`Swing ${l<0?"one":"the other"} way`,onclick:()=>PL(n,l)};return R("button.swing",d,l<0?"↺":"↻")}),a=R("div.tip-buttons",{role:"group","aria-label":"The tip"},i,r,o);a.hidden=!t;function c({keepOrientation:l,tipHold:h,arm:u}){let d=!!h?.pinned;oe(i,"aria-pressed",String(l)),i.hidden=!Jy(u),oe(r,"aria-pressed",String(d)),Ot(r,d?CL(h):"Pin the tip"),o.forEach(f=>f.hidden=!d||!h.free)}return{root:a,update:c}}var Jy=n=>et(n).length>=6&&Li(n).length===6;function RL(n){let{state:t,derived:e}=n,i=et(t.arm).length>6||t.keepOrientation&&Jy(t.arm),s={pinned:e.frames.at(-1),turns:i,free:IL(n,i)};n.dispatch({type:"setFields",tipHold:t.tipHold?.pinned?null:s})}var CL=({free:n,turns:t})=>{let e=t?"place and direction":"place";return n?`Tip pinned (${e}): drag the elbow`:`Tip pinned (${e}): nothing is free`},Zy=({derived:n},t)=>n.columns.map(e=>vn(e,cu(t))),IL=(n,t)=>xi(Zy(n,t)).length;function PL(n,t){let{arm:e,q:i,tipHold:s}=n.state;if(!s?.pinned)return;let[r]=xi(Zy(n,s.turns));if(!r)return;let[o]=[...r].sort((h,u)=>Math.abs(u)-Math.abs(h)),a=t*Math.sign(o),c=i.map((h,u)=>h+a*_L*r[u]),l=Fi(e,c,s.pinned,{rows:cu(s.turns)});n.dispatch({type:"moveJoints",q:l.q,tipHold:s,gesture:"swing"})}var LL=6,Ky=0;function vu(n,t,e,...i){let s=R("div.rail",{},n,...i),r=(u,d,f)=>u.addEventListener(d,f,{signal:e});r(n,"input",()=>t(Number(n.value),`keys ${n.ariaLabel}`));let o=null,a=()=>Number(n.max)-Number(n.min),c=()=>Math.max(1,s.clientWidth-16),l=u=>t(Math.min(Number(n.max),Math.max(Number(n.min),u)),`drag ${Ky}`),h=u=>{Ky+=1,Object.assign(o,{on:!0,x:u.clientX}),s.setPointerCapture(u.pointerId)};return r(s,"pointerdown",u=>{if(u.button||o||(o={id:u.pointerId,x:u.clientX,from:Number(n.value),on:!1},n.focus({preventScroll:!0}),u.pointerType!=="mouse"))return;u.preventDefault(),h(u);let d=(u.clientX-s.getBoundingClientRect().left-8)/c(),f=(o.from-Number(n.min))/a();Math.abs(d-f)*c()<11||(o.from=Number(n.min)+d*a(),l(o.from))}),r(s,"pointermove",u=>{u.pointerId===o?.id&&(!o.on&&Math.abs(u.clientX-o.x)<LL||(o.on||h(u),l(o.from+a()*(u.clientX-o.x)/c())))}),r(s,"pointerup",()=>o=null),r(s,"pointercancel",()=>{o?.on&&l(o.from),o=null}),s}var Qy=typeof matchMedia>"u"?null:matchMedia("(prefers-color-scheme: dark)");function NL(){let{dataset:n}=document.documentElement;if(n.theme)return n.theme==="dark"?"dark":"light";let t=document.body.dataset.jpThemeLight;if(t)return t==="true"?"light":"dark";let{classList:e}=document.body;return e.contains("vscode-dark")||e.contains("vscode-high-contrast")?"dark":e.contains("vscode-light")||!Qy?.matches?"light":"dark"}function bu(n,t){let e,i=()=>{let r=NL();r!==e&&n(e=r)},s=new MutationObserver(i);s.observe(document.documentElement,{attributes:!0,attributeFilter:["data-theme"]}),s.observe(document.body,{attributes:!0,attributeFilter:["class","data-jp-theme-light"]}),Qy?.addEventListener("change",i,{signal:t}),t.addEventListener("abort",()=>s.disconnect()),i()}var Is=n=>wr(n,0),DL=0;function An(n,t,e){let{state:i={},isGrabbable:s=!0,message:r,side:o=[],firstFrame:a=0}=e,c=new AbortController,{signal:l}=c,{arm:h}=t,u=new lr(gu({arm:h,q:t.q??is(h),...i})),d=n.shadowRoot??n.attachShadow({mode:"open"}),f=yu(u,{signal:l,firstFrame:a,isGrabbable:s,hasTipBar:!1,id:`figure-${++DL}`,goTo:S=>u.dispatch({type:"glide",q:S})}),p=R("p.words"),m=(t.joints??[]).map(S=>OL(u,S,l)),g=R("div.side",{},...o,...m.map(S=>S.root),p),x=R("figure.live",{},f.root,g);d.replaceChildren(R("style",{},hu,Ny),x);let _="light",b=[];function M(){let{state:S,derived:D}=u;for(let L of m)L.show(S);Ot(p,r(S,D)),f.draw(S,D,_),f.update(S);for(let L of b)L(S,D)}bu(S=>{_=S,x.dataset.theme=S,M()},l),u.listen(M,l);let{picture:T}=f;return{store:u,picture:T,card:x,signal:l,refresh:M,follow:S=>(b.push(S),M()),dispose:()=>(c.abort(),f.dispose(),d.replaceChildren())}}function OL(n,t,e){let{arm:i}=n.state,s=et(i).indexOf(t-1),r=i.rows[t-1],o=(h,u)=>n.dispatch({type:"moveJoints",q:un(n.state.q,s,h),gesture:u}),a=Rn(`Joint ${t}`,Hn(r)),{root:c,show:l}=tv(Te("q",t),a,o,e);return{root:c,show:({q:h,unit:u})=>l(h[s],In(r,h[s],u),Ac(r,h[s],u))}}function hr(n,t,e,{put:i,text:s,signal:r}){let o=Rn(n,t),{root:a,show:c}=tv(n,o,h=>l(h),r),l=h=>(c(h,s(h)),i(h));return c(e,s(e)),{root:a,move:l}}function tv(n,t,e,i){let s=R("output"),r=(o,a,c=a)=>{t.value=String(o),oe(t,"aria-valuetext",c),Ot(s,a)};return{root:R("div.lever",{},R("span",{},n),vu(t,e,i),s),show:r}}var[Hp,Ba,wu]=[300,220,22];function UL(n){let t=[0,1].map(i=>{let s=n.map(o=>o[i]),r=Math.min(...s);return[r,Math.max(1e-9,Math.max(...s)-r)]}),e=(i,s)=>(i[s]-t[s][0])/t[s][1];return i=>[wu+(Hp-2*wu)*e(i,0),Ba-wu-(Ba-2*wu)*e(i,1)]}function FL(n,t,e){let i=n.map(r=>t(r).map(o=>o.toFixed(1))),s={fill:"none",stroke:e,"stroke-width":2.5};return Pe("polyline",{points:i.join(" "),...s})}function ev(n,t){return Pe("text",{"font-size":11,fill:"currentColor",...t},n)}function kL(){let n="Two ellipses: height along axis 2, squared distance from a point of it",t=`0 0 ${Hp} ${Ba}`,e=Pe("svg",{viewBox:t,role:"img","aria-label":n}),i=Ba/2+70,s=[ev("height along axis 2",{x:Hp/2-55,y:Ba-4}),ev("distance² from a point of it",{x:12,y:i,transform:`rotate(-90 12 ${i})`})];function r(o,a){let c=UL(o.flat()),l=a.map(u=>{let[d,f]=c(u);return Pe("circle",{cx:d,cy:f,r:4.5,fill:"currentColor"})}),h=o.map((u,d)=>FL(u,c,Tn(d)));e.replaceChildren(...h,...l,...s)}return{root:e,update:r}}function BL(n,t){let e=Math.abs(Math.sin(n.rows[1].alpha))<1e-9,i=`${t} ${t===1?"solution":"solutions"} for this position`;return e?`Axes 2 and 3 are parallel: the ellipse of joint 3 is a segment, gone through twice. Each crossing counts twice, elbow up and elbow down: ${i}.`:`The ellipses of joints 1 and 3 cross ${t} times: ${i}.`}function nv(n,t){let e=kL(),i=R("p.words",{},"Blue: joint 1, undone. Orange: joint 3. Drag the tip."),s=(d,f)=>{let p=Py(d,f.at(-1).o);return{ellipses:p,crossings:Ly(p[0],p[1])}},r=({arm:d},{frames:f})=>BL(d,s(d,f).crossings.length),o=An(n,t,{side:[e.root,i],message:r}),{rows:a}=o.store.state.arm,c=d=>{let f={...t.arm,rows:un(a,1,{...a[1],alpha:d})};o.store.dispatch({type:"selectArm",arm:f,q:o.store.state.q})},l=a[1].alpha,h={put:c,text:Is,signal:o.signal},u=hr(Te("α",2),[0,l||1],l,h);return o.card.querySelector(".side").prepend(u.root),o.follow(({arm:d},{frames:f})=>{let{ellipses:p,crossings:m}=s(d,f);e.update(p,m)}),o.dispose}function iv(n,t){let e=An(n,t,{message:u=>`The tip stays; ${et(u.arm).map((f,p)=>`q${f+1} ${In(u.arm.rows[f],u.q[p],"deg")}`).join(", ")}.`}),{store:i}=e,s=i.derived.frames.at(-1);i.dispatch({type:"setFields",tipHold:{pinned:s,turns:!0,free:1}});let r=zL(i.state.arm,i.state.q,s),o=r.findIndex(u=>u===i.state.q),a=u=>{let d=r[Math.max(0,Math.min(r.length-1,Math.round(u)))];i.dispatch({type:"moveJoints",q:d,tipHold:i.state.tipHold,gesture:"swing"})},c=u=>Is(r[Math.round(u)]?.[2]-r[o][2]),{signal:l}=e,h=hr("elbow",[0,r.length-1],o,{put:a,text:c,signal:l});return e.card.querySelector(".side").prepend(h.root),e.dispose}function zL(n,t,e){let i=s=>{let r=[],[o,a]=[t,null];for(let c=0;c<80;c++){let[l]=xi(Ie(n,It(n,o)));if(!l)break;let h=a?l.reduce((p,m,g)=>p+m*a[g],0):s*l[2],u=l.map(p=>h<0?-p:p),d=o.map((p,m)=>p+.03*u[m]),f=Fi(n,d,e).q;if(et(n).some((p,m)=>mi(n.rows[p],f[m])))break;r.push(f),[o,a]=[f,u]}return r};return[...i(-1).reverse(),t,...i(1)]}var GL="only the entries with its angle move; the last column goes round on a circle of radius a.",VL=n=>n.map(t=>Nt(1e3*t,0)).join(", ");function HL(n,t){let e=(i,{frames:s})=>{let r=`The tip is at (${VL(s.at(-1).o)}) mm.`;return`${t.words??"Drag a link, or the tip."} ${r}`};return An(n,t,{state:{frames:t.frames??"ends"},message:e}).dispose}function WL(n,t){let e=t.row??1,i=4,s=An(n,t,{isGrabbable:!1,firstFrame:e-1,state:{frames:"all"},message:({arm:l})=>$L(l.rows[0],i)}),r=s.store.state.arm.rows[e-1],c=hr("motions",[0,4],4,{put:l=>{i=l;let h=[qL(r,l,t)];s.store.dispatch({type:"selectArm",arm:{name:`Row ${e}`,home:[],rows:h},q:[]})},text:l=>`${Nt(l,1)} of 4`,signal:s.signal});return s.card.querySelector(".side").prepend(c.root),c.move(4),s.picture?.fitView(),s.dispose}function $L({theta:n,d:t,a:e,alpha:i},s){let r=[t,e].map(a=>`${Nt(1e3*a,0)} mm`),o=[`turn by θ about z (${Is(n)})`,`slide by d along z (${r[0]})`,`slide by a along x (${r[1]})`,`turn by α about x (${Is(i)})`].slice(0,Math.ceil(s));return o.length?`${o.join(", then ")}.`:"The frame before the row."}function qL(n,t,{angle:e=.7}){let i=a=>Math.min(1,Math.max(0,t-a)),s=n.theta+(n.kind==="revolute"?e:0),r=n.d+(n.kind==="prismatic"?.3:0);return{kind:"fixed",...{theta:i(0)*s,alpha:i(3)*n.alpha},d:i(1)*r,a:i(2)*n.a}}function XL(n,t){let e=t.row??1,i=lu("A",`A ${e}`),s=An(n,{...t,joints:[e]},{state:{frames:"all"},side:[R("div.scroll",{},i.root)],message:()=>`Turn joint ${e}: ${GL}`});return s.follow(({arm:r,q:o})=>{let a=o[et(r).indexOf(e-1)];i.update(e,It({rows:[r.rows[e-1]]},[a])[1])}),s.dispose}function jL(n,t){let e=et(t.arm)[(t.column??1)-1],i=tu(l=>l!==null&&a(l)),s=An(n,t,{side:[i.root],message:({arm:l})=>{let h=l.rows[e].kind==="revolute"?"turns about its axis":"slides",u=`when joint ${e+1} ${h} alone`;return`Column ${et(l).indexOf(e)+1}: the tip moves along the arrow ${u}.`}}),{store:r,picture:o}=s,a=l=>{e=l,r.dispatch({type:"setFields",highlightedRow:l}),s.refresh()},c=o&&new Jn(o.forceArrow.shaft.material);return s.follow(({arm:l},h)=>{if(i.update({arm:l,highlightedRow:e},h.columns),!c||!o.world)return;c.parent!==o.world&&o.world.add(c);let u=h.columns[et(l).indexOf(e)],d=Mt(.3,u.slice(0,3));c.placeAlong(h.frames.at(-1).o,d,.008*o.size)}),a(e),s.dispose}function YL(n,t){return An(n,t,{state:{view:"jacobian"},message:(i,s)=>`Half axes ${s.linearAxes.values.map(o=>Nt(o,2)).join(", ")}. ${Da(s).text}`}).dispose}function JL(n,t){let e=R("div.bars"),i=An(n,t,{state:{view:t.push?"torque":"pose",wrench:t.wrench??[0,0,0,0,0,0]},side:[e],message:({arm:r},{torques:o})=>{let a=o.map(Math.abs),c=a.indexOf(Math.max(...a)),l=`${Nt(o[c],1)} N m`,h=`joint ${et(r)[c]+1}: ${l}`;return`${t.words??"Move the arm."} The most is asked of ${h}.`}}),s=et(i.store.state.arm).map(ZL);return e.replaceChildren(...s.map(r=>r.root)),i.follow(({arm:r},{torques:o})=>{let a=Math.max(...et(r).map(c=>r.rows[c].effort??50));s.forEach((c,l)=>c.show(o[l],a))}),i.dispose}function ZL(n){let[t,e]=[R("span.fill"),R("span")],i=R("span",{},Te("τ",n+1)),s=(r,o)=>{ka(t,r/o),Ot(e,`${Nt(r,1)} N m`)};return{root:R("div.bar",{},i,R("span.track",{},t),e),show:s}}function KL(n,t){let[e,i,s]=[null,0,.1],r=An(n,t,{isGrabbable:!1,state:{view:"trace",highlightedRow:t.lit?t.lit-1:null},message:({arm:g})=>e?QL(g,e,s):"Computing …"}),{store:o}=r,a=o.state.q,c=()=>{let{path:g}=e,x=Math.round(i*(g.length-1));o.dispatch({type:"replaceState",trace:g,q:g[x]})},l=Sr("run"),h=()=>l({arm:o.state.arm,q:a,run:{method:"exact",steps:180,radius:s}},g=>{r.signal.aborted||(e=g,c(),r.refresh())}),u=(g,x,_,b,M)=>hr(g,x,_,{put:b,text:M,signal:r.signal}).root,f=u("round",[0,1],0,g=>(i=g,e&&c()),g=>`${Nt(100*g,0)} %`),m=u("radius",[.01,.1],s,g=>(s=g,h()),g=>`${Nt(100*g,1)} cm`);return r.card.querySelector(".side").prepend(...t.fixed?[f]:[m,f]),h(),r.dispose}function QL(n,{failedStep:t,windings:e},i){let s=`Radius ${Nt(100*i,1)} cm`;if(t!==null)return`${s}: no run gets round; the arm would have to pass a singular configuration.`;let r=Oa(n,(a,c)=>Math.abs(e[c])>.9);return`${s}: ${r.length?`${Je(r)} wind once round`:"the joints swing and come back"}.`}function tN(n,t){let e=R("div.row",{role:"radiogroup","aria-label":"Solutions"}),i=An(n,t,{state:{view:"branches"},side:[e],message:({arm:o,branches:a})=>a?Jh(o,a):"Computing …"}),{store:s}=i,r=!1;return Lc("branches",{arm:s.state.arm,q:s.state.q}).then(o=>{if(r)return;s.dispatch({type:"setBranches",arm:s.state.arm,branches:o});let a=({q:c},l)=>{let h=`border-left: 6px solid ${Tn(l)}`,u=()=>s.dispatch({type:"glide",q:c});return R("button",{role:"radio","aria-label":`Way ${l+1}`,style:h,onclick:u},`${l+1}`)};e.replaceChildren(...o.list.map(a)),i.refresh()}),i.follow(({q:o,branches:a})=>{[...e.children].forEach((c,l)=>{let h=a?.list[l]?.q.every((u,d)=>Math.abs(u-o[d])<.001);c.setAttribute("aria-checked",String(!!h))})}),()=>(r=!0,i.dispose())}function eN(n,t){let i=An(n,t,{message:({arm:o,q:a},{frames:c})=>{let l=Ct(nt(c.at(-1).o,c[1].o)),[h,u]=[o.rows[1].a,o.rows[2].a],d=(l*l-h*h-u*u)/(2*h*u),f=`Shoulder to tip ${Nt(1e3*l,0)} mm`,p=Is(a[2]);return`${f}, so D = ${Nt(d,3)} and θ₃ = ${p}; its cosine is D.`}}),{picture:s}=i,r=[];return i.follow((o,{frames:a})=>{s?.world&&(r.forEach(ar),r=nN(a.slice(1).map(c=>c.o)).filter(([c,l])=>Ct(nt(c,l))>.001).map(([c,l,h])=>{let u=Dt(Mt(.5,c),Mt(.5,l));return oo([c,u,l],.003*s.size,Tn(h))}),r.forEach(c=>s.world.add(c)))}),i.dispose}function nN([n,t,e]){let i=[e[0],e[1],n[2]];return[[n,e,0],[n,i,2],[i,e,2],[n,t,1],[t,e,1]]}var Wp={columns:jL,ellipses:nv,ellipsoid:YL,hand:HL,loads:JL,matrix:XL,row:WL,swing:iv,triangles:eN,ways:tN,winds:KL};var sv=`:host {
  margin: 1.6rem 0;
}
dl,
dd,
ol {
  margin: 0;
  padding: 0;
}
/* Header */
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
button:hover:not(:disabled, [aria-disabled="true"]) {
  background: var(--raised);
  border-color: var(--soft);
}
button:is(:disabled, [aria-disabled="true"]) {
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
.explorer {
  --stage-height: clamp(210px, 38vh, 420px);
}
.bench {
  display: contents;
}
/* A control with the focus is scrolled out from under the picture that stays. */
:is(.sliders, .views) * {
  scroll-margin-top: calc(64px + var(--stage-height));
}
.stage {
  position: sticky;
  top: 56px;
  z-index: 2;
  height: var(--stage-height);
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
.tip-buttons {
  position: absolute;
  left: 10px;
  right: 112px; /* leaves room for the legend */
  bottom: 8px;
  display: flex;
  flex-wrap: wrap;
  gap: 4px;
}
.tip-buttons button {
  font-size: 12px;
  padding: 1px 8px;
  background: color-mix(in srgb, var(--ground) 82%, transparent);
}
.tip-buttons button[aria-pressed="true"] {
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
  padding-top: 2px;
}
.bounds {
  margin-top: -3px;
  display: flex;
  justify-content: space-between;
  font-size: 12px;
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
  container-type: inline-size; /* a view is laid out for its column, which may be narrow */
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
.mounts + *,
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
.dh th small {
  font-size: 12px;
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
  font-size: 12px;
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
.ticks {
  display: flex;
  justify-content: space-between;
  font-size: 12px;
  line-height: 1.3;
  color: var(--soft);
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
.left .solutions {
  opacity: 0.62;
}
.solutions {
  list-style: none;
  display: grid;
  grid-template-columns: 28px auto 1fr auto;
  row-gap: 6px;
  margin-top: 10px;
}
.solutions li,
.solutions button {
  display: grid;
  grid-column: 1 / -1;
  grid-template-columns: subgrid;
}
.solutions button {
  align-items: center;
  gap: 4px 12px;
  width: 100%;
  text-align: left;
  padding: 6px 10px;
}
.solutions button[aria-current="true"] {
  border-color: var(--accent);
  background: color-mix(in srgb, var(--accent) 6%, var(--ground));
  box-shadow: inset 5px 0 0 var(--accent);
}
.swatch {
  width: 12px;
  height: 12px;
  border-radius: 50%;
  opacity: 0.85;
}
.solutions .name {
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
.wall .axes {
  stroke: var(--soft);
  stroke-width: 1;
}
.wall text {
  fill: var(--ink);
  font-size: 12.5px;
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
  min-height: 4.4em; /* the description of a run, once its result is there */
}
.homework summary {
  cursor: pointer;
  padding-block: 4px;
  font-size: 13px;
  color: var(--soft);
}
@container (min-width: 560px) {
  .bench {
    display: grid;
    grid-template-columns: minmax(0, 1fr) minmax(250px, 40%);
  }
  :is(.sliders, .views) * {
    scroll-margin-top: 0;
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
/* Full width: the picture stays in view on the left, everything else is on the right. */
@container (min-width: 1060px) {
  .explorer {
    display: grid;
    grid-template: auto auto auto 1fr / minmax(0, 1.2fr) minmax(530px, 1fr);
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
    padding-top: 7px;
  }
}
@container (max-width: 600px) {
  .entries input {
    width: 64px;
    padding-inline: 4px;
  }
  .entries td:nth-child(odd) input {
    width: 78px; /* lengths in mm have more digits than angles */
  }
  .entries :is(th, td) {
    padding-inline: 2px;
  }
}
@container (max-width: 430px) {
  .view {
    padding-inline: 12px;
  }
  .solutions {
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
    display: none; /* on a phone a double tap fits the view, so the button is left out */
  }
  select.name {
    flex: 1 0 9rem; /* next to the buttons it would have no width left */
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
    padding-inline: 3px;
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
    font-size: 12px;
  }
  .heat td {
    min-width: 40px;
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

.heat .typed {
  display: block;
  color: var(--bad);
  font-size: 0.85em;
}
.heat .typed::before {
  content: "✘ ";
}
.bars .fill.typed {
  top: auto;
  bottom: 0;
  height: 30%;
  background: var(--bad);
}
/* The slider stays in the window, so that the picture can be seen beside it. */
.blend:not([hidden]) {
  position: sticky;
  bottom: 0;
  display: flex;
  gap: 0.6rem;
  align-items: center;
  margin-top: 6px;
  padding-block: 4px;
  background: var(--ground);
}
.blend input {
  flex: 1;
  min-width: 0;
}
.mounts summary {
  cursor: pointer;
  padding-block: 2px;
  margin-block: 0.6rem;
}

.mounts .row input {
  flex: 1 1 14rem;
  min-width: 0;
}
`;function rv(n,{arms:t,link:e,goTo:i,stage:s,card:r,announce:o}){let a=t.length>1?oN(n,t,s):rN(),c=aN(n),l=cN(n),h=lN(n),u=[l.root,ur("Home","Where this arm stands first",()=>i(is(n.state.arm))),ur("Random","Somewhere within its limits",()=>i(Rd(n.state.arm))),hN(s),h.root,...e?[uN(e,o)]:[]];r.addEventListener("keydown",p=>{let m=sN(p);m&&(p.target.matches("input[type=text], textarea")&&!p.target.dataset.cell||(p.preventDefault(),n.dispatch({type:m}),h.keepFocus()))});let d=R("div.buttons",{role:"group","aria-label":"Settings"},u),f=[a,c,l,h];return{root:R("header",{},a.root,c.root,d),update:p=>f.forEach(m=>m.update(p))}}function sN({key:n,ctrlKey:t,metaKey:e,shiftKey:i}){return!t&&!e?null:n.toLowerCase()==="y"?"redo":n.toLowerCase()!=="z"?null:i?"redo":"undo"}var ur=(n,t,e)=>R("button",{title:t,onclick:e},n),ov=(n,t)=>oe(n,"aria-pressed",String(t));function rN(){let n=R("span.name");return{root:n,update:({arm:t})=>Ot(n,Ed(t.name))}}function oN(n,t,e){let s=R("select.name",{"aria-label":"Arm",onchange:()=>{n.dispatch({type:"selectArm",arm:t[s.selectedIndex]}),e.fit()}}),r=null;function o({arm:c,base:l}){let h=c===l?null:c.name;if(r===h&&s.options.length)return;r=h;let u=t.map(d=>R("option",{value:d.name},Ed(d.name)));s.replaceChildren(...u,...h?[R("option",{},h)]:[])}function a(c){let{arm:l,base:h}=c;o(c);let u=l===h?t.findIndex(d=>d.name===l.name):t.length;s.selectedIndex!==u&&(s.selectedIndex=u)}return{root:s,update:a}}function aN(n){let t=Object.entries({deg:"degrees",rad:"radians"}).map(([e,i])=>R("button",{title:i,"data-unit":e,onclick:()=>n.dispatch({type:"setFields",unit:e})},e));return{root:R("span.pair",{role:"group","aria-label":"Unit of angles"},t),update:({unit:e})=>t.forEach(i=>ov(i,i.dataset.unit===e))}}function cN(n){let t="Draw the frame of every link, or the first and the last only",e=()=>n.state.frames==="all"?"ends":"all",i=ur("Frames",t,()=>n.dispatch({type:"setFields",frames:e()}));return{root:i,update:({frames:s})=>ov(i,s==="all")}}function lN(n){let t=ur("↶","Undo (Ctrl+Z)",()=>n.dispatch({type:"undo"})),i=ur("↷","Redo (Ctrl+Y or Ctrl+Shift+Z)",()=>n.dispatch({type:"redo"}));t.setAttribute("aria-label","Undo"),i.setAttribute("aria-label","Redo");let s=R("span.pair",{role:"group","aria-label":"Undo and redo"},t,i);return{root:s,update({past:r,future:o}){oe(t,"aria-disabled",String(!r.length)),oe(i,"aria-disabled",String(!o.length))},keepFocus(){let{activeElement:r}=s.getRootNode();r||t.focus({preventScroll:!0})}}}function hN(n){let t=ur("Fit","The whole arm into the picture",()=>n.fit());return t.className="spare",t}var uN=(n,t)=>ur("Copy link","An address that opens this arm in this place",async({target:e})=>{e.textContent=await n.copy()?"Copied":"In the address bar",t(()=>e.textContent),setTimeout(()=>e.textContent="Copy link",1600)});var av={ArrowLeft:-1,ArrowDown:-1,ArrowRight:1,ArrowUp:1,PageUp:10,PageDown:-10};function cv(n,{announce:t,point:e,signal:i}){let s=R("div.sliders",{role:"group","aria-label":"Joints"}),r=R("p.error"),o=[],a={},c={...dN(n,r,t),point:e};function l({arm:u,unit:d}){a.abort?.abort();let f=new AbortController;i.addEventListener("abort",()=>f.abort(),{signal:f.signal}),o=et(u).map((m,g)=>fN(u.rows[m],{index:m,i:g,unit:d,signal:f.signal},c));let p=R("p.words",{},"No joint moves this arm.");s.replaceChildren(...o.length?o.map(m=>m.root):[p],r),a={rows:u.rows,unit:d,abort:f}}function h(u){(a.rows!==u.arm.rows||a.unit!==u.unit)&&l(u),o.forEach((d,f)=>gN(d,u.q[f],u))}return{root:s,update:h}}function dN(n,t,e){let i={setValue:(s,r,o=null)=>n.dispatch({type:"moveJoints",q:un(n.state.q,s,r),gesture:o}),readTyped:(s,r,o,a)=>{let{unit:c,q:l}=n.state,{value:h,message:u}=Rs(o,Rg(r),{unit:c,whole:a});Ot(t,u&&`${o.dataset.joint} ${u}.`),u&&e(()=>t.textContent),a&&(h!==void 0&&i.setValue(s,h),o.value=In(r,h??l[s],c),o.setAttribute("aria-invalid","false"))},handleKey:(s,r,o)=>{let a=mN(s,r,n.state.q[o]);a!==null&&(s.preventDefault(),i.setValue(o,a,`keys ${o}`))}};return i}function fN(n,{index:t,i:e,unit:i,signal:s},{setValue:r,readTyped:o,handleKey:a,point:c}){let l=`Joint ${t+1}, ${n.kind==="revolute"?"angle":"slide"}`,h=Rn(l,Hn(n),{"data-joint":t+1,onkeydown:_=>a(_,n,e)}),u=Ci(`${l}, typed`,(..._)=>o(e,n,..._),{class:"value","data-joint":l}),d=R("span.past"),f=vu(h,(..._)=>r(e,..._),s,pN(n,d,i)),[p,m]=[()=>c(t),()=>c(null)],g={onpointerenter:p,onpointerleave:m,onfocusin:p,onfocusout:m},x=R("span.label",{},Te("q",t+1));return{root:R("div.joint",g,x,f,u),thumb:h,field:u,past:d,row:n,index:t}}function pN(n,t,e){let i=s=>R("span",{},(s??null)===null?"":Cg(n,s,e));return R("span.bounds",{},i(n.lower),t,i(n.upper))}function mN({key:n,shiftKey:t},e,i){let[s,r]=Hn(e);if(n==="Home")return s;if(n==="End")return r;if(!av[n])return null;let o=(Oi(e)?Math.PI/180:.005)*(t?.1:1);return ln(i+av[n]*o,s,r)}function gN({root:n,thumb:t,field:e,past:i,row:s,index:r},o,{highlightedRow:a,unit:c}){let[l,h]=Hn(s);n.classList.toggle("lit",a===r),t.value=String(o),oe(t,"aria-valuetext",Ac(s,o,c));let[u,d]=[o,0].map(p=>100*ln((p-l)/(h-l||1),0,1));t.style.setProperty("--low",`${Math.min(u,d).toFixed(2)}%`),t.style.setProperty("--high",`${Math.max(u,d).toFixed(2)}%`),Cs(e,In(s,o,c));let f=mi(s,o);n.classList.toggle("past",f),Ot(i,f?"past its limit":"")}var $p={};ns($p,{build:()=>_N,title:()=>xN});var xN="IK branches",lv=({arm:n})=>`Find the solutions for this ${yp(n)}`;function _N(n,{goTo:t,announce:e}){let i=R("p.verdict"),s=R("ol.solutions"),r=R("button.main",{onclick:l}),o=R("div.branches",{},R("div.row",{},r),i,s),a=Sr("branches"),c;function l(){let{arm:u,q:d}=n.state;r.textContent="Looking …",a({arm:u,q:d},f=>{r.textContent=lv(n.state),n.dispatch({type:"setBranches",arm:u,branches:f}),e(()=>i.textContent,!0)})}function h(u,d){let{branches:f,unit:p,arm:m}=u;if(c?.branches!==f||c.unit!==p||c.arm!==m){let x=b=>n.dispatch({type:"setFields",highlightedBranch:b}),_=(f?.list??[]).map((b,M)=>yN(b,M,u,{goTo:t,light:x}));c?.arm!==m&&(r.textContent=lv(u)),s.replaceChildren(..._.map(b=>R("li",{},b))),c={branches:f,unit:p,arm:m,buttons:_}}let g=xu(u,d);o.classList.toggle("left",!!g),Ot(i,bN(u,g)),c.buttons.forEach((x,_)=>{let b=Cc(m,f.list[_].q,u.q);oe(x,"aria-current",String(b))})}return{root:o,update:h,summary:()=>i.textContent}}function yN({q:n,label:t},e,{arm:i,unit:s},{goTo:r,light:o}){let a=et(i),c=a.flatMap((p,m)=>mi(i.rows[p],n[m])?[p+1]:[]),l=xo(i)?"within limits":"",h=a.map((p,m)=>R("span",{},Te("q",p+1),` ${In(i.rows[p],n[m],s)}`)),[u,d]=[()=>o(e),()=>o(null)];return R("button",{onclick:()=>r(n),...{onpointerenter:u,onpointerleave:d,onfocus:u,onblur:d}},R("span.swatch",{style:`background:${Tn(e)}`,"aria-hidden":"true"}),R("span.name",{},t?vN(t):`solution ${e+1}`),R("span.values",{},h),c.length?R("span.note.past",{},`past the limit of joint ${c.join(", ")}`):R("span.note",{},l))}var vN=n=>n.split(/\b([a-z]_\d+)\b/).map((t,e)=>e%2?R("span",{},Te(...t.split("_"))):t.replace(/-$/,"−"));function bN({branches:n,arm:t},e){let i=yp(t);if(!n)return`Each solution that takes the tip to this ${i} is shown in a colour of its own; choose one to go there.`;let s=n.list.length>1?" Choose one, here or in the picture, to go there.":"";if(!e)return Jh(t,n)+s;let r=e.distance>5e-4?`${Nt(1e3*e.distance,0)} mm from there`:"turned away from it",o=`Choose one to go back, or find the solutions for this ${i}.`;return`${`These solutions are for the ${i} at which the tip was before`}; it is now ${r}. ${o}`}var Yp={};ns(Yp,{build:()=>zN,title:()=>BN});var za={euler:"Euler",rk4:"Runge-Kutta 4",exact:"exact inverse kinematics",inverse:"J⁻¹",pseudo:"pseudo-inverse",damped:"damped"},qp={"":"none",angular:"z_i in the angular rows",z_i:"z_i and o_i throughout",o_i:"o_i instead of o_i−1",sign:"rates with the wrong sign",next:"velocity of the next step"};function hv(n,t){let e=et(n).length===et(t).length;return t.circle&&e?{...Pc,...t.circle}:null}function uv(n){let t=n.filter(({circle:e})=>e).map(({name:e})=>`the ${e}`);return t.length?`The homework’s circle is drawn by ${Je(t,"or")}: choose one of them above.`:"No homework asks this arm for a circle."}function Xp(n){return n<1e-12?"under 1e−9 mm":n<1e-5?`${Eo(1e3*n,1)} mm`:`${Nt(1e3*n,n<.01?3:1)} mm`}var Mu=({method:n,rates:t,steps:e,gain:i,mistake:s})=>(n==="exact"?za.exact:`${za[n]}, ${za[t]}, N = ${e}`)+(i?`, gain ${Nt(i,1)}`:"")+(s?`, ${qp[s]}`:"");function wN({failedStep:n,isSingular:t,run:e}){let i=n?`at step ${n} of ${e.steps}`:"where the run starts";return t?`J has no inverse ${i}, where the arm is singular: choose another of the rates.`:e.mistake?`With this mistake the matrix has no inverse ${i}, though the arm could go on.`:e.method==="exact"?`The circle is out of reach ${i}.`:`The run leaves all bounds ${i}.`}function MN(n){return n<1e-9?"0":n<1e-4?Eo(n,1):Nt(n,4)}function dv(n,t){if(!n)return"Computing …";if(n.failedStep!==null)return wN(n);let e=Oa(t,(h,u)=>Math.abs(n.windings[u])>.9),i=Zh(t,n.path),s=e.length?` Once round: ${Je(e)}.`:"",r=i.length?` Past its limits: ${Je(i)}.`:"",o=`Largest error ${Xp(n.largestError)}`,a=n.run.method==="exact"?"":`, fastest joint ${Nt(n.fastestRate,2)} rad/s`,c=n.largestTilt>.001?`, the tool tilts by ${wr(n.largestTilt,1)}`:"",l=`Smallest σ on the way: ${MN(n.smallestSigma)}.`;return`${o}${c}${a}. ${l}${s}${r}`}var SN=[["steps","N",!0,String,Math.round],["seconds","T",!1,n=>`${Nt(n,0)} s`,Math.round],["radius","Radius",!1,n=>`${Nt(100*n,1)} cm`,n=>Number(n.toFixed(3))],["gain","Feedback",!1,n=>`${Nt(n,1)} /s`,n=>Number(n.toFixed(1))]];function fv(n){let t=(p,m,g)=>ss(p,g,x=>n({[m]:x})),e=p=>Object.fromEntries(p.map(m=>[m,za[m]])),i=t("Method","method",e(["euler","rk4","exact"])),s=t("Rates","rates",e(["inverse","pseudo","damped"])),r=t("Mistake","mistake",qp),[o,a,c]=[i,s,r].map(p=>R("label",{},`${p.getAttribute("aria-label")} `,p)),l=SN.map(p=>TN(p,n)),h=R("summary"),u=[o,a,...l.map(({root:p})=>p)];function d(p){if(!p)return;i.value=p.method,s.value=p.rates,r.value=p.mistake;let m=`radius ${Nt(100*p.radius,1)} cm`;Ot(h,`${Mu(p)}, ${m} in ${Nt(p.seconds,0)} s`);for(let{key:g,root:x,show:_}of l)_(p[g]),x.hidden=EN(g,p);for(let g of[a,c])g.hidden=p.method==="exact"}let f=R("details",{},h,R("div.levers",{},u));return{mistake:c,root:f,update:d}}var EN=(n,{method:t})=>t==="exact"&&n==="gain";function TN([n,t,e,i,s],r){let o=Nd[n].map(u=>e?Math.log10(u):u),a=u=>s(e?10**Number(u.value):Number(u.value)),c=R("output"),l=Rn(t,o,{oninput:u=>Ot(c,i(a(u.target))),onchange:u=>r({[n]:a(u.target)})}),h=u=>{l.value=String(e?Math.log10(u):u),l.setAttribute("aria-valuetext",i(u)),Ot(c,i(u))};return{key:n,root:R("label.lever",{},`${t} `,l,c),show:h}}var dr=260,AN=Array.from({length:73},(n,t)=>t/72);function pv(n){let t=30,e={role:"img","aria-label":"The wall with the runs on it"},i=Pe("svg",{viewBox:`0 0 ${dr} ${dr}`,...e}),s=Rn("Magnify the errors",[0,3],{value:Math.log10(t),oninput:c=>(t=10**Number(c.target.value),n())}),r=R("output"),o=R("figcaption",{},R("label",{},"Errors magnified ",s,r));function a(c,l,h){Ot(r,`× ${Nt(t,t<10?1:0)}`);let u=It(c,l).at(-1).o,d=Math.max(...h.map(({run:m})=>m.radius)),f=dr/(2.6*d),p=h.map((m,g)=>CN(m,g,{arm:c,top:u,scale:f,magnify:t}));i.replaceChildren(...p.flat(),...RN(h[0].run,f))}return{root:R("figure.wall",{},i,o),draw:a}}function RN({normal:n,radius:t},e){let i=e*t,[s,r]=[dr/2,.13*dr+i],o=n==="x"?1:-1,a=n==="x"?"y":"x";return[Pe("polyline",{points:`${s+o*i},${r} ${s},${r} ${s},${r-i}`,class:"axes"}),Pe("text",{x:s+o*.5*i,y:r+16,"text-anchor":"middle"},`${a}: ${hn(t,3)} m`),Pe("text",{x:s+6,y:r-.5*i},"z")]}function CN({run:n,result:t},e,{arm:i,top:s,scale:r,magnify:o}){let a=u=>{let d=nt(u,s),f=n.normal==="x"?d[1]:-d[0],[p,m]=[dr/2+r*f,.13*dr-r*d[2]];return`${p.toFixed(1)},${m.toFixed(1)}`},c=AN.map(u=>a(rs(s,n,u).o)),l=Pe("polyline",{points:c.join(" "),class:"asked"});if(!t)return[l];let h=t.path.map((u,d)=>{let f=rs(s,n,t.at[d]).o,p=It(i,u).at(-1).o;return a(f.map((m,g)=>m+o*(p[g]-m)))});return[l,Pe("polyline",{points:h.join(" "),stroke:Tn(e)})]}var[Va,Ga]=[220,54],IN={joint:"joint values",torque:"static torques"};function Su(n,t){let e=ss("What the plots show",IN,()=>a(n.state)),i=R("div.plots"),[s,r]=[[],[]];function o({arm:c,trace:l,unit:h,wrench:u}){let d=e.value==="torque",f=l&&(d?Bg(c,l,u):l),p=(g,x)=>NN(g,f.map(_=>_[x]),d?PN(c.rows[g]):LN(c.rows[g],h)),m=f?et(c).map(p):[];s=m.map(({cursor:g})=>g);for(let{figure:g}of m)g.append(DN(t()));i.replaceChildren(...m.map(({figure:g})=>g))}function a(c){let{arm:l,trace:h,unit:u,wrench:d,progress:f}=c,p=[l,h,u,d,e.value];p.some((m,g)=>m!==r[g])&&o(c),r=p;for(let{line:m,value:g,textAt:x}of s)oe(m,"x1",String(f*Va)),oe(m,"x2",String(f*Va)),Ot(g,x(f))}return{root:i,choice:R("label.right",{},"Plots ",e),update:a}}var PN=({kind:n,effort:t})=>({letter:"τ",text:e=>`${Nt(e,2)} ${n==="revolute"?"N m":"N"}`,limits:[-(t??1/0),t??1/0],least:.5}),LN=(n,t)=>({letter:"q",text:e=>In(n,e,t),limits:[n.lower??-1/0,n.upper??1/0],least:Oi(n)?.1:.02});function NN(n,t,{letter:e,text:i,limits:s,least:r}){let[o,a]=s,[c,l]=[Math.min(...t),Math.max(...t)],h=Math.max((l-c)/2,r)*1.15,u=y=>Ga*(.5-(y-(c+l)/2)/(2*h)),d=t.length-1,f=t.map((y,S)=>`${(S*Va/d).toFixed(1)},${u(y).toFixed(1)}`),p=Pe("line",{y1:0,y2:Ga,x1:0,x2:0,class:"cursor"}),m=[...a<1/0?[mv(-1,u(a))]:[],...o>-1/0?[mv(u(o),Ga)]:[]],g={viewBox:`0 0 ${Va} ${Ga}`,preserveAspectRatio:"none","aria-hidden":"true"},x=Pe("svg",g,...m,Pe("polyline",{points:f.join(" ")}),p),_=R("span.now"),b=R("b",{},Te(e,n+1)),M=R("span.span",{},`${i(c)} … ${i(l)}`),T=t.some(y=>y<o-1e-9||y>a+1e-9),E=R("figcaption",{},b,_,M);return{cursor:{line:p,value:_,textAt:y=>i(t[Math.round(y*d)])},figure:R(T?"figure.past":"figure",{},E,x)}}var DN=n=>R("div.ticks",{"aria-hidden":"true"},n.map(t=>R("span",{},t)));function gv(n){let t=e=>hn(e,e<1?2:1);return["0",`t = ${t(n/2)} s`,`${t(n)} s`]}var xv=["0 %","50 % of the path","100 %"];function mv(n,t){let e=Math.max(0,n),i=Math.max(0,Math.min(Ga,t)-e);return Pe("rect",{x:0,width:Va,y:e,height:i,class:"beyond"})}var ON=8;function Eu(n,{signal:t,makeTrace:e}){let i=d=>n.dispatch({type:"setPlaying",on:d}),s=R("button.main",{onclick:()=>FN(n,i,e)},"Play"),r=kN(d=>(i(!1),n.dispatch({type:"seek",progress:d}))),o=R("output.place"),a=R("div.row.transport",{},s,r,o),c=null,l=0;t.addEventListener("abort",()=>cancelAnimationFrame(c));function h(d){c=null;let{playing:f,progress:p}=n.state;if(!f||!a.isConnected)return;let m=1e3*ON*(fc()?2:1),g=Math.min(1,p+Math.max(0,Math.min(100,d-l))/m);l=d,c=requestAnimationFrame(h),n.dispatch({type:"seek",progress:g}),g===1&&i(!1)}function u({playing:d,trace:f,progress:p}){Ot(s,d?"Pause":"Play"),r.disabled=!f,UN({scrub:r,place:o},p),!(!d||c)&&(l=performance.now(),c=requestAnimationFrame(h))}return{root:a,update:u}}function UN({scrub:n,place:t},e){n.value=String(Math.round(1e3*e)),n.style.setProperty("--high",`${(100*e).toFixed(1)}%`),oe(n,"aria-valuetext",`${Math.round(100*e)} percent`),Ot(t,`${Math.round(100*e)} %`)}function FN(n,t,e){let{trace:i,playing:s,progress:r}=n.state;return s?t(!1):i?(r>=1&&n.dispatch({type:"seek",progress:0}),t(!0)):e(()=>t(!0))}var kN=n=>Rn("Place along the path",[0,1e3],{step:1,value:0,oninput:t=>n(t.target.value/1e3)});var BN="Play the homework",zN=(n,t)=>new jp(n,t),jp=class{constructor(t,{announce:e,arms:i,signal:s}){this.store=t,this.arms=i,this.announce=e,this.signal=s,this.results=new Map,this.listedFields=[],this.list=R("div.runs",{role:"radiogroup","aria-label":"Runs"}),this.verdict=R("p.verdict"),this.wall=pv(()=>this.drawWall()),this.plots=Su(t,()=>this.getTicks()),this.transport=Eu(t,{signal:s,makeTrace:()=>this.showResults()}),this.fields=fv(r=>this.editChosenRun(r)),this.root=this.makeLayout()}makeLayout(){return this.player=R("div",{},this.list,R("div.row",{},this.fields.mistake,this.plots.choice),this.transport.root,this.verdict,this.fields.root,this.wall.root,this.plots.root),this.circleArms=R("p.words",{},uv(this.arms)),R("div.homework",{},this.player,this.circleArms)}get runs(){let{runs:t,arm:e,base:i}=this.store.state;return t.length?t:[hv(e,i)??[]].flat()}editChosenRun(t){let{chosenRun:e}=this.store.state,i=this.runs.map((r,o)=>o===e?{...r,...t}:r),s=`run ${e} ${Object.keys(t)}`;this.store.dispatch({type:"setFields",runs:i,gesture:s})}getResultKey(t){let{arm:e,runStart:i}=this.store.state;return JSON.stringify([e.rows,i,t])}getResult(t){return this.results.get(this.getResultKey(t))}async computeResults(){let{store:t,results:e,runs:i}=this,{state:s}=t,{arm:r,runStart:o}=s,a=()=>["arm","runStart","runs"].every(c=>t.state[c]===s[c]);for(let c of i){let l=this.getResultKey(c);if(!e.has(l)&&(e.set(l,null),e.set(l,await Lc("run",{arm:r,q:o,run:c})),this.signal.aborted||(this.showResults(),!a())))return}this.showResults()}showResults(){let{store:t,runs:e}=this,{arm:i,circle:s,chosenRun:r}=t.state,o=e.map(h=>this.getResult(h)),a=({path:h})=>h.map(u=>It(i,u).at(-1).o),c=o.flatMap((h,u)=>h?[{points:a(h),colour:Tn(u)}]:[]);t.dispatch({type:"setFields",tipPaths:c});let l=o[r]?.path;l?.length<2?t.dispatch({type:"setFields",trace:null}):l&&t.state.trace!==l&&t.dispatch({type:"setTrace",arm:i,circle:s,path:l,wantedPath:null}),this.showRuns(),this.announce(()=>this.verdict.textContent)}showRuns(){let{runs:t}=this,{arm:e,chosenRun:i}=this.store.state,s=t[i];this.player.hidden=!s,this.circleArms.hidden=!!s,this.list.hidden=t.length<2,this.listRuns(t,i),this.fields.update(s),Ot(this.verdict,s?dv(this.getResult(s),e):""),s&&this.drawWall()}getTicks(){let t=this.runs[this.store.state.chosenRun],e=t&&this.getResult(t);return gv(e?e.at.at(-1)*t.seconds:0)}listRuns(t,e){let{activeElement:i}=this.list.getRootNode(),s=!!i&&this.list.contains(i);this.list.replaceChildren(...t.map((r,o)=>this.makeRunButton(r,o))),s&&this.list.children[e].focus()}makeRunButton(t,e){let i={role:"radio","aria-checked":String(e===this.store.state.chosenRun),onclick:()=>this.store.dispatch({type:"setFields",chosenRun:e})},s={style:`background:${Tn(e)}`,"aria-hidden":"true"},r=`${Mu(t)}: ${GN(this.getResult(t))}`;return R("button",i,R("span.swatch",s),R("span",{},r))}drawWall(){let{arm:t,runStart:e}=this.store.state,i=this.runs.map(s=>({run:s,result:this.getResult(s)}));this.wall.draw(t,e,i)}update(t){let e=["arm","runs","runStart","chosenRun"].map(i=>t[i]);return e.some((i,s)=>i!==this.listedFields[s])&&(this.listedFields=e,this.showRuns(),this.computeResults()),this.plots.update(this.store.state),this.transport.update(this.store.state)}summary(){return this.verdict.textContent}};function GN(n){return n?n.failedStep===null?Xp(n.largestError):"no inverse":"…"}var Em={};ns(Em,{build:()=>Tk,title:()=>Mk});var VN=.02;function _v(n){let t=(i,s,r)=>Math.abs(ot(i,s)-r)>VN,e=n.map(i=>i.slice(0,3));if(e.some((i,s)=>e.some((r,o)=>t(i,r,+(s===o)))))return n;for(let i=0;i<6;i++){let[s,r,o]=e,a=ot(s,kt(r,o)),c=[kt(r,o),kt(o,s),kt(s,r)];e=e.map((l,h)=>l.map((u,d)=>(u+c[h][d]/a)/2))}return n.map((i,s)=>[...e[s],i[3]])}var Ha=1e-12,yv=1e-6,HN=[3,4,5,6,7],WN="expected x, y, z, roll, pitch, yaw, or the rows of a 4 x 4 pose";function vv(n,t){let e=n.split(/[\s,;|&[\]()]+/).filter(Boolean);if(e.length!==6&&e.length!==16)return{error:`has ${e.length} numbers; ${WN}`};let i=e.length===16,s=c=>!i&&c>2,r=e.map((c,l)=>ho(c,s(l)?"angle":"length",t)),o=r.find(({error:c})=>c);if(o)return{error:o.error};let a=r.map(({value:c})=>c);return i?$N(a):{pose:XN(a)}}function $N(n){let[t,e,i,s]=[0,1,2,3].map(l=>[0,1,2].map(h=>n[4*h+l])),r=n.slice(12).map((l,h)=>l-(h===3?1:0)),o=[...nt(kt(t,e),i),Ct(t)-1,Ct(e)-1,...r];if(Math.max(...o.map(Math.abs))<=yv)return{pose:{x:t,y:e,z:i,o:s}};let c=[0,1,2].map(l=>n.slice(4*l,4*l+4));return qN(c,r)??{error:"is no rigid pose, even if its numbers are rounded to three decimals or more"}}function qN(n,t){let e=n.flatMap(f=>f.slice(0,3)),i=f=>e.every(p=>Math.abs(p-Number(p.toFixed(f)))<Ha),s=HN.find(i),r=_v(n),o=Math.hypot(...r.flatMap((f,p)=>f.map((m,g)=>m-n[p][g])));if(!(o>0&&s&&o<=1.5*10**-s)||Math.max(...t.map(Math.abs))>yv)return null;let[c,l,h,u]=[0,1,2,3].map(f=>r.map(p=>p[f])),d=`has only ${s} decimals; the nearest rotation was taken`;return{pose:{x:c,y:l,z:h,o:u},note:d}}function XN([n,t,e,i,s,r]){let[o,a,c,l]=[Math.cos(i),Math.sin(i),Math.cos(s),Math.sin(s)],[h,u]=[Math.cos(r),Math.sin(r)],d=[h*c,u*c,-l],f=[h*l*a-u*o,u*l*a+h*o,c*a];return{x:d,y:f,z:kt(d,f),o:[n,t,e]}}var Tu=n=>Math.abs(n)<Ha?0:n,Jp=(n,t,e,i)=>({kind:"fixed",a:Tu(n),alpha:Tu(t),d:Tu(e),theta:Tu(i)});function bv({x:n,z:t,o:e}){let s=Math.hypot(t[0],t[1])<Ha,r=s?Math.atan2(e[1],e[0]):Math.atan2(t[0],-t[1]);s&&Math.hypot(e[0],e[1])<Ha&&(r=0),Math.abs(r)>Math.PI/2+Ha&&(r-=Math.sign(r)*Math.PI);let[o,a]=[Math.cos(r),Math.sin(r)],[c,l]=[[o,a,0],[-a,o,0]],h=s?0:ot(e,l)/ot(t,l),u=nt(e,Mt(h,t)),d=Math.atan2(ot(n,kt(t,c)),ot(n,c)),f=Jp(ot(e,c),Math.atan2(-ot(l,t),t[2]),u[2],r),p=Jp(0,0,h,d);return!f.a&&!f.alpha?[Jp(0,0,f.d+p.d,r+d)]:p.d||p.theta?[f,p]:[f]}var Ps=String.raw`[-+]?\d+(?:[.,]\d+)?`,Ls=String.raw`(?:[ \t]|\\[,;: ])*`,Au=String.raw`${Ls}(?:\^?°|\^\{°\}|deg(?:rees?)?\b)`,Ru=String.raw`${Ls}rad(?:ians?)?\b`,wv=String.raw`${Ls}[=≈/]${Ls}`,Mv=String.raw`${Ls}[[(]${Ls}[=≈]?${Ls}`,Sv=String.raw`${Ls}[\])]`,jN=String.raw`(?<=[.,]\d{1,20})`,YN=String.raw`(?<![\p{L}\d_.,*/^])`,JN=[[`(${Ps})(?:${Ru}|${jN})${Mv}(${Ps}${Au})${Sv}`,!1],[`(${Ps})${Ru}${wv}(${Ps}${Au})`,!1],[`(${Ps}${Au})${Mv}(${Ps})${Ru}${Sv}`,!0],[`(${Ps}${Au})${wv}(${Ps})${Ru}`,!0]].map(([n,t])=>[new RegExp(YN+n,"gu"),!!t]),Zp=n=>JN.reduce((t,[e,i])=>t.replace(e,(s,r,o)=>{let[a,c]=i?[r,o]:[o,r];if(Ev(c,a))return a;throw new xt(at("two units",{text:ee(s)}))}),n);function Ev(n,t){let[e,i]=[n,t].map(r=>parseFloat(r.replace(",","."))),s=r=>10**-(/[.,](\d*)/.exec(r)?.[1].length??0);return Math.abs(e-i*Xe)<=.51*(s(n)+s(t)*Xe)}var ZN=String.raw`[-+]?(?:\d+(?:[.,]\d*)?|[.,]\d+)(?:[eE][-+]?\d+)?`,KN=String.raw`${ZN}(?: ?(?:${Kn}|π|pi))?`,QN=String.raw`(?<![^\s|&,;:=[({>$])`,t2=String.raw`(?![^\s|&,;:.\])}<$])`,e2=`\\*{1,3}|_{1,2}|"|'`,n2=.001;function i2(n,t="",e="",i,s){let r=Math.max(n2,t.length>1?20*10**-t.length:0);return Number((i??s).replace(",","."))<=r?e:n}var s2=String.raw`(?<=[.,](\d{1,20})|\d)((?: ?π)?(?: ?${Kn})?)`+String.raw`\s*(?:(?:±|\+\/-)\s*(\d*[.,]\d+)(?:\2)?`+String.raw`|\(\s*(?:±|\+\/?-)\s*(\d*[.,]\d+)\s*\))`,r2="(?:math|text)(?:bf|it|rm)?|boldsymbol|boxed|underline|num",o2=String.raw`(?:\\(?:${r2}|textcolor\{\w+\})\{|\{\\color\{\w+\}\s*)`+String.raw`((?:[^{}\n]|\{[^{}\n]{0,60}\}){0,80})\}`,a2=String.raw`\((?!(?:${Kn}|pi) ?\))(?![^()\n]*(?:[A-Za-z]\d|\d\s+[-+]?[\d.]))`+String.raw`[A-Za-z][^()\n*/+^_{}=]{0,30}\)(?! ?[*/^+-])`,c2=String.raw`[A-Za-z]_?\d{1,2}(?=\()`,l2=String.raw`(?<=[A-Za-zθ]_?\d) *\((?:locked|fixed)\b`,h2=String.raw`(?<![\p{L}_]\d{1,2} ?)(?<=(?:[.,]\d{1,22}|(?<![\d.])0)`+String.raw`(?:e[-+]?\d{1,2})? ?π?)`,u2=String.raw`(?<=[\d\])}°mπ])(?:[*!]|[ ]*<-+)`+String.raw`(?=[ ]*(?:$|[,;\t|&"\]])|[ ]{2,}|[ ]and\b|\.\s|[ ]?${Kn}(?![\w.]))`,d2=String.raw`(?<=[\w°π)}*])(?:(?:\\[,;:! ])?[ ]*[✓✔✅☑†‡§](?!\w)|\[\^\w{1,3}\]|\^\{\*\}|`+String.raw`(?<=\d)\^(?:\{?\(?[a-d]\)?\}?(?!\w)|\{\(\d\)\})|<sup>\s*[\w*†‡]\s*<\/sup>)`,f2=/<\/?(?:tr|thead|tbody|table|b|i|u|em|strong|code|span|mark|sub|p|div|br)\b[^<>\n]{0,80}>/gi,p2=[[/(?<=10)<sup>\s*([-+]?\d{1,2})\s*<\/sup>/gi,"^$1"],[new RegExp(d2,"g"),""],[/<\/?t[dh]\b[^<>\n]{0,80}>/gi," | "],[/<\/tr>/gi,"␞"],[f2,""],[/\\ang\{([^{}\n;]*)\}/g,"$1 deg"],[/\\(?:SI|qty)\{([^{}\n]*)\}\{([^{}\n]*)\}/g,"$1 $2"],[new RegExp(o2,"g"),"$1"],[/(?<=\d)[ \t]*[×·*x][ \t]*10[ \t]*\^\s*[({]?[ \t]*([-+]?\d{1,2})(?:[ \t]*[)}])?(?!\.?\d)/g,"e$1"],[/≈\s*(?=[-+]?(?:[\p{L}\d.\\]|,\d))/gu," "],[new RegExp(s2,"g"),i2],[new RegExp(String.raw`(?<=\d\.\d{1,18}|(?<![A-Za-z])\d[ ]?${Kn})\(\d{1,2}\)(?!\s*[*/^])`,"g"),""],[/(?<=[\d)][ \t]+)-(?=[ \t]*$)/gm,""],[new RegExp(`${QN}(${e2}) ?(${KN}) ?\\1${t2}`,"g"),"$2"],[/(?<=[|&][ \t]*)(\*{1,3}|_)([^*|&\n]{1,40}\*?)\1(?=[ \t]*[|&])/g,"$2"],[new RegExp(u2,"gm"),""],[new RegExp(String.raw`(?<=\d(?:[ ]?[*·]?[ ]?(?:${Kn}|π|pi))?)(?<!${c2})(?!${l2}) *${a2}`,"g"),""],[/(?<![\w.])[-+]?\d{1,9}[.,]\d{1,20}\s*(?:→|->)\s*(?=[-+]?[\d.θ])/g,""],[new RegExp(String.raw`${h2}[ \t]*\[\s*(${Kn})\s*\]`,"gu")," $1"],[/(?<=\p{L})[ ][[(][-1][\])](?=[ ]*[\t|&])/gu,""],[new RegExp(String.raw`(?<=[\p{L}\p{N})\]}$])[ \t]*[[(]\s*(${Kn})\s*[\])]`,"gu"),"_($1)"]];function Av(n){let t=i=>p2.reduce((s,[r,o])=>s.replace(r,o),i),e=t(Zp(g2(n)));return Zp(t(e))}var m2=/(?<![^\s|&,;:=[({~])-\s?[\d.]/,g2=n=>m2.test(n.text)?n.replace(/~[ ]?(?=[-+]?[\d.])/g," "):n,x2=/^(?:[ \t]*>(?!>)[ \t]?)+/gm,_2=String.raw`[\w, \t]{1,80}=[ \t]*(?:\w+\.)?symbols\([^()\n]*\)`,y2=new RegExp(String.raw`^[ \t]*(?:syms[ \t][\w \t]{1,200}|${_2})[ \t]*;?[ \t]*$`,"gm"),Rv=n=>b2(n.replace(x2,"").replace(y2,"")),v2=new RegExp(String.raw`^[ \t]*([A-Za-z]{2,9})[ \t]*=[ \t]*`+String.raw`((?:\w{1,9}\.)?pi ?\/ ?180(?:\.0)?|\d[\d.e-]{0,9})[ \t]*;?[ \t]*$`,"gm");function Cv(n){let t=[...n.text.matchAll(v2)];return t.reduce((e,[i,s,r])=>{let o=e.replace(new RegExp(String.raw`(?<=\d ?\* ?)${s}(?!\w)`,"g"),`(${r})`),a=t.find(l=>l[1]===s&&l[2]!==r);if(o===e||!a)return o;let c=[i,a[0]].map(l=>ee(l.trim()));throw new xt(at("two factors",{one:c[0],other:c[1]}))},n)}var Tv=/^[ \t]*(\d{1,3})(?:[ \t]*[|:] ?|\t| {2}|$)/gm;function b2(n){let t=n.text.split(`
`).filter(s=>s.trim()),e=w2(n,Tv),i=e.length===t.length&&e[0]===1&&M2(e);return t.length>2&&i?n.replace(Tv,""):n}var w2=({text:n},t)=>[...n.matchAll(t)].map(e=>Number(e.filter(Boolean).at(-1))),M2=n=>n.every((t,e)=>t===n[0]+e);var Iv=/~~[^~\n]{1,300}~~|<s>[^<>\n]{1,300}<\/s>|\\(?:phantom|cancel)\{[^{}\n]*\}/g,S2=[/(?<=[\d)°m*][ ]*)#[ ]?[a-z]{2,12}(?=[ ]*(?:[\t|&;,]|$))/gm,Iv,/^[ \t>]*(?:(?:page|p\.)[ \t]*\d{1,3}(?:[ \t]*of[ \t]*\d{1,3})?|- \d{1,3} -)[ \t]*$/gim,/^[ \t]*(?:def \w+\(|return ).*$/gm,/^[ \t]*(?:#(?!\d)|%|\/\/).*\d[.,]\d.*$/gm,/(?<=(?:[\d\])},;:°m*π]|rad|deg)[ \t]+)(?:#(?!\d)|%|\/\/|<-(?!-*[ ]*[,;|&\t°]|\.?\d)).*$/gm],Pv=n=>n.replace(/[^\n]/g," "),E2=/([^\S\r\n]{200})[^\S\r\n]+/g,T2=/(([^\p{L}\p{N}\s][ \t]?)\2{199})\2+/gu,Kp=n=>n.replace(Iv,Pv).replace(E2,"$1").replace(T2,"$1");function Cu(n){let t=Zn(n),e=S2.reduce((i,s)=>i.replace(s,Pv),t);return e===t?null:e}var Wa="[({",Qp="])}";function tm(n,t,e,i){let s=[],[r,o]=[0,t];for(let a=t;a<e;a++){Wa.includes(n[a])?r++:Qp.includes(n[a])&&(r=Math.max(0,r-1));let c=r?"":i(a);c&&(s.push({from:o,to:a}),uo(c)&&s.push({from:a,to:a+c.length}),a+=c.length-1,o=a+1)}return s.push({from:o,to:e}),s}var A2=[/^\d{9,}\.\d+$/,/^\d{4}-\d\d-\d\d/,/^\d{1,2}[/.]\d{1,2}[/.]\d{2,4}$/],Lv=n=>A2.some(t=>t.test(n));function Nv(n){let t=n.replace(/[-·*. ]/g,"");if(Ip(t))return" deg";let e=ry(t);return e===1?"":e&&`*1e${Math.round(Math.log10(e))}`}var em=n=>Nv(n)!==void 0,R2=/^([-+]? ?[\d.,]+(?:e[-+]?\d+)?(?: ?(?:π|pi\b))?)\s*([A-Za-z°][-A-Za-z°·*⋅. ]{0,12})$/;function C2(n,{decimal:t}){let e=n.trim().replace(/^"|"$|"?[.,;]$/g,"");t&&(e=e.replace(/(?<=\d|^[-+]?),(?=\d)/g,".")),e.includes("[")&&(e=e.replaceAll("[","(").replaceAll("]",")"));let[,i,s=""]=R2.exec(e)??[],r=Nv(s);return r===void 0?e:`${i}${r}`}function nm({from:n,to:t},e,i){let s=i.text.slice(n,t),[r,o]=[n+s.length-s.trimStart().length,n+s.trimEnd().length],a=C2(s.replace(/\s+/g," "),e),c=i.span(r,Math.max(r,o));return{text:a,...c,stretches:i.stretches(r,o)}}function im({from:n,to:t},e,i){return(e.gaps?I2(i.text,n,t):O2(L2(i.text,n,t,e),i.text)).map(r=>nm(r,e,i)).filter(({text:r})=>r)}function I2(n,t,e){let i=[],s=t;for(let r of n.slice(t,e).matchAll(/, +|[ \t\v]{2,}/g))i.push({from:s,to:t+r.index}),s=t+r.index+r[0].length;return[...i,{from:s,to:e}].flatMap(r=>P2(r,n))}function P2(n,t){let[e]=/(?<=\S\s*)=(?=\s*$)/.exec(t.slice(n.from,n.to))??[];if(!e)return[n];let i=t.lastIndexOf(e,n.to-1);return[{from:n.from,to:i},{from:i,to:i+1}]}var Dv=[":=","<<","->",":","="],uo=n=>Dv.includes(n);function L2(n,t,e,{decimal:i}){return tm(n,t,e,r=>/\s/.test(n[r])||n[r]===","&&!i?n[r]:N2(n,r)).filter(r=>r.to>r.from).map(r=>({...r,closed:n[r.to]===","&&!i}))}function N2(n,t){if(!"=:<-".includes(n[t]))return"";let e=Dv.find(i=>n.startsWith(i,t))??"";return e===":"&&D2.test(n.slice(Math.max(0,t-3),t+4))?"":e}var D2=/(?:^|[^\p{L}\d_])\d{1,2}:\d\d(?![.\d])|:\d\d:\d/u;function O2(n,t){let e=[];for(let i of n){let s=e.at(-1);s&&z2(s,i,t)?e[e.length-1]={...i,from:s.from}:e.push(i)}return e}var U2=/[*/^]$|(?:^|\s)[-+±~]$/,F2=/^[*/^]|^[-+±]$/,k2=/^ *(?:rad|[\t\n|&;,]|$)/,B2=40;function z2(n,t,e){let i=e.slice(Math.max(n.from,n.to-B2),n.to),s=e.slice(t.from,t.to);return n.closed||uo(i)||uo(s)?!1:U2.test(i)||F2.test(s)||Ts(i.replace(/^[-+]+/,""))?!0:/^(?:π|pi)$/.test(s)&&t.from===n.to+1?/\d[.,]\d+$/.test(i)&&k2.test(e.slice(t.to)):em(s)&&/[\d.)](?: [km]?N)?$/.test(i)}var G2=["vx","vy","vz","wx","wy","wz"],V2={ẋ:"vx",ẏ:"vy",ż:"vz"},H2=/^(?:q|d|th(?:eta)?|tau|τ|[tgjalc]|[\p{L}\d]*joint|link|column|angle|torque|axis|motor)$/u,W2=["first","second","third","fourth","fifth","sixth","seventh"],$2=new Map([["base","shoulderpan"],["shoulder","shoulderlift"],["elbow"],["wrist1"],["wrist2"],["wrist3"]].flatMap((n,t)=>n.map(e=>[e,t+1]))),q2=/[[({]\d{1,2}, ?:[\])}] ?=?$|^\p{L}+\^\{?\(\d{1,2}\)/u;function X2(n){if(Ki(n))return null;let t=Y2(n),e=G2.indexOf(t.replace("omega","w").replace(/^([xyz])dot$/,"v$1"));if(e>=0)return{kind:"row",number:e};let i=$2.get(t.replace(/joint$/,"")),s=t.replace(/^the/,""),r=W2.findIndex(l=>s.startsWith(l));if(i||r>=0)return{kind:"joint",number:i??r+1};let[,o,a]=/^(\D*|[\p{L}\d]*joint)(\d{1,5})$/u.exec(t)??[];return a===void 0?null:{kind:H2.test(o)&&!q2.test(n)?"joint":"count",number:Number(a)}}var j2=/(?:1\/s|(?:deg(?:rees?)?|rad(?:ians?)?|nm|mm?)(?:\/(?:s|rad))?|\/rad)$/,Y2=n=>Ce([...n.normalize("NFKC")].map(t=>V2[t]??t).join("")).toLowerCase().replace(/(?<=\p{L}[_{]*\d[\d}]*)\^?\{?\(\d\)\}?$/u,"").replace(/[\s"'{}^\\*#:=()[\]|.,&_-]/g,"").replace(j2,""),J2=8;function xn(n){let t=n.slice(-J2).map(({text:i})=>i),e=t.flatMap((i,s)=>X2(t.slice(s).join(" "))??[]);return e.find(({kind:i})=>i!=="count")??e[0]??null}function Ov({words:n,name:t,isAssigned:e}){let i=e&&n.at(-1)?.text!==t;return xn(i?[{text:t}]:n)}function Uv(n){let t=n[0].above.filter(i=>xn([i])?.kind==="row");return t.length===n.length&&n[0].above.some(({text:i})=>/^(?:rows?|order)$/i.test(i))?{labels:t.map(i=>[i]),headers:[]}:{labels:n.map(({words:i})=>i),headers:n[0].above}}function Ii(n){let t=0;return n.split(`
`).map(e=>{let i={from:t,to:t+e.length,text:e};return t=i.to+1,i})}var Ns=class n{constructor(t,e=null,i=null){this.text=t,this.starts=e,this.ends=i}span(t,e){return this.starts?t>=e?{from:this.starts[t]??0,to:this.starts[t]??0}:{from:this.starts[t],to:this.ends[e-1]}:{from:t,to:e}}stretches(t,e){let i=[];for(let s=t;s<e;s++){let r=this.span(s,s+1),o=i.at(-1);o&&r.from>=o.from&&r.from<=o.to?o.to=Math.max(o.to,r.to):r.to>r.from&&i.push(r)}return i}replace(t,e){let i=[],[s,r]=[[],[]],o=0;for(let a of this.text.matchAll(t)){this.#t(o,a.index,i,s,r),o=a.index+a[0].length;let c=Z2(a,e);i.push(c),this.#e(a,c,s,r)}return i.length?(this.#t(o,this.text.length,i,s,r),new n(i.join(""),s,r)):this}edit(t){let e=[],[i,s]=[[],[]],r=0;for(let{from:o,to:a,text:c}of t){this.#t(r,o,e,i,s),r=a,e.push(c);let l=this.span(o,a);for(let h=0;h<c.length;h++)i.push(l.from),s.push(l.to)}return this.#t(r,this.text.length,e,i,s),new n(e.join(""),i,s)}assemble(t){let e=[],[i,s]=[[],[]];for(let r of t)if(typeof r!="string")this.#t(r.from,r.to,e,i,s);else{e.push(r);let o=s.at(-1)??0;for(let a=0;a<r.length;a++)i.push(o),s.push(o)}return new n(e.join(""),i,s)}#t(t,e,i,s,r){i.push(this.text.slice(t,e));for(let o=t;o<e;o++)s.push(this.starts?this.starts[o]:o),r.push(this.ends?this.ends[o]:o+1)}#e(t,e,i,s){let r=t[0].indexOf(e),o=this.span(t.index,t.index+t[0].length);for(let a=0;a<e.length;a++){let c=t.index+r+a,l=r<0?o:this.span(c,c+1);i.push(l.from),s.push(r<0&&/\s/.test(e[a])?l.from:l.to)}}};function Z2(n,t){return typeof t=="function"?t(...n):t.replace(/\$(\d)/g,(e,i)=>n[Number(i)]??"")}var K2=String.raw`(?:\.T|\^\{?(?:T|\\top)\}?|ᵀ)`,n8=new RegExp(String.raw`(?:${K2}|'|(?<!\p{L})transposed?)(?:\([^()]*\))?$`,"iu");var tD=n=>n.map(({text:t})=>t),Fv=n=>{let t=tD(n).map(e=>e.replace(/[():.]/g,""));return t.every((e,i)=>/^\d$/.test(e)&&(!i||e>t[i-1]))};var eD=/^(?:[fFgmp]|FK|tip|errors?|residual|limits?|F_?ext|[adhlLmr](?:_?\{?\d\}?|_\w+))$/,nD=/\b(?:mass(?:es)?|wrench|force|target|given|lengths?|at q|for F|norm|elapsed time)\b/i;function Ds({name:n,words:t}){let e=t.slice(-4).map(({text:i})=>i);return eD.test(n.split(" ").at(-1))||nD.test([...e,n].join(" "))}var Bv="old|previous|earlier|first (?:try|attempt|run)",iD=new RegExp(String.raw`\b(?:${Bv}|wrong|before I)\b`,"i"),sD=new RegExp(String.raw`^\W*(?:my )?(?:${Bv})(?:\W+\w+){0,2}\W*$`,"i"),kv=n=>n.map(({text:t})=>t).join(" "),sm=({name:n,words:t,above:e})=>iD.test(`${kv(t)} ${n}`)||sD.test(kv(e));function zv(n,t){if(n.depth)return!0;if(n.line===t.line)return!n.name==!t.name;let[e,i]=[xn(n.words),xn(t.words)];return!e&&n.words.length&&!n.isAssigned&&!t.words.length?!1:e?.kind===i?.kind}var rD="a name or a sentence",oD="another list",aD=/[0-9０-９٠-٩]+(?:[.．٫][0-9０-９٠-٩]*)?(?:[eE][-+−]?\d+)?|\.\d+(?:[eE][-+−]?\d+)?/g,cD=/\r\n?|[\n\v\f]/g,$a=class{constructor(t){let e=[...t.matchAll(cD)].map(s=>s.index+s[0].length),i=0;this.list=[...t.matchAll(aD)].map(({0:s,index:r})=>{for(;e[i]<=r;)i++;return{text:s,from:r,to:r+s.length,line:i,owner:""}})}within({from:t,to:e}){let[i,s]=[0,this.list.length];for(;i<s;){let o=i+s>>1;this.list[o].from<t?i=o+1:s=o}let r=i;for(;r<this.list.length&&this.list[r].from<e;)r++;return this.list.slice(i,r)}claim(t,e,i={}){for(let s of this.within(t))s.owner||Object.assign(s,{owner:e,...i})}};function Wv(n,t){let e=new $a(n),i=vD(t);t.rows.forEach((s,r)=>s.forEach((o,a)=>{let c=i.has(r)?"unread":"entry",l=r*s.length+a;for(let h of o.stretches??[o])e.claim(h,c,{row:r,column:a,index:l})}));for(let s of lD(t.labels))e.claim(s,"unread");for(let s of[...t.labels.flat(),...t.headers])bD(e,s,"label");for(let{cells:s}of t.sources)for(let r of s)e.claim(r,"label",{reason:"another column"});for(let{cells:s}of t.lines.given)for(let r of s)e.claim(r,"given");TD(e,t,SD(n,t));for(let s of e.list)s.owner||Object.assign(s,yD(n,s)?{owner:"label"}:{owner:"context",reason:"markup or comment"});return uD(n,e.list),t.rows.length===1&&hD(n,e.list),e.list}var lD=n=>{let t=n.map(e=>e.filter(({text:i})=>Ki(i)));return t.every(({length:e})=>e>0)?[]:t.flat()};function hD(n,t){let e=t.findIndex(({owner:o})=>o==="entry"),i=t[e-1];if(i?.owner!=="label"||i.line!==t[e].line)return;let s=/[[({][ \t]*[-+\u2212]?$/.test(n.slice(0,i.from)),r=/^[ \t]+[-+\u2212]?$/.test(n.slice(i.to,t[e].from));s&&r&&(i.owner="unread")}function uD(n,t){for(let e of xD(n,t))e.owner="unread";for(let e of _D(n,t))if(e.filter(({owner:s})=>s==="entry").length===1)for(let s of e)s.owner="unread"}var dD=/^[^#%\n]{0,60}(?<!\p{L})(?:or|oder|ou|bzw\.?|oppure|или|或) {0,2}[-+\u2212]?$/iu,fD=/(?:i\.e\.|d\. ?h\.),? {0,2}[-+\u2212]?$/i,pD=/<[^<>\n]*>/g,mD=/#|%|\/\//,gD=[1,Xe,1/Xe,.001,1e3],xD=(n,t)=>t.filter((e,i)=>{let s=t[i-1];if(e.owner==="entry"||s?.line!==e.line)return!1;let r=n.slice(s.to,e.from).replace(pD,""),o=fD.test(r);if(!o&&!dD.test(r))return!1;let a=t.filter(({owner:u})=>u==="entry"),c=a.filter(({line:u,from:d})=>u===e.line&&d<e.from);if(!c.length||mD.test(n.slice(c.at(-1).to,e.from)))return!1;let l=Gv(n,e),h=u=>gD.some(d=>Math.abs(l/Gv(n,u)/d-1)<.02);return!(o?a:c).some(h)}),Gv=(n,{text:t,from:e})=>Number(t.replace(",","."))*(/[-\u2212\u2013] ?$/.test(n.slice(Math.max(0,e-2),e))?-1:1),$v=(n,{from:t})=>/(?:^|\n)[ \t]*$/.test(n.slice(Math.max(0,t-20),t));function _D(n,t){return t.flatMap((e,i)=>{let s=t[i+1];return n[e.to]!==","||s?.from!==e.to+1?[]:/,[-+−]?$/.test(n.slice(0,e.from).slice(-2))||/^,\S/.test(n.slice(s.to,s.to+2))?[]:$v(n,e)?[]:/^\d+$/.test(e.text)&&/^\d+$/.test(s.text)?[[e,s]]:[]})}var yD=(n,t)=>$v(n,t)&&/^[ \t]*[|:.)\t]/.test(n.slice(t.to,t.to+4));function vD({labels:n}){let t=n.map(i=>xn(i)?.kind==="row"),e=t.flatMap((i,s)=>i?[]:[s]);return new Set(t.includes(!0)?e:[])}var bD=(n,t,e)=>{qv(t.text)||n.claim(t,e)},wD=[/\d:\d\d|(?<![\d.])\d{1,3}\.\d{1,3}\.\d{1,4}(?![\d.])/,/^\[?\d{9,}\.\d|^(?:\d+m)?[\d.]+ ?m?s$|\d\.{2,3}[-+−]?[\d.]/],Iu=n=>wD.some(t=>t.test(n)),MD=/^[-+]?\d+[lIOo]\d*$|^[-+]?[OoIl][.,]\d|^[-+]?\d+[!?*~†‡§]/,qv=n=>{let t=n.includes("(")?[n]:n.split(","),e=i=>Ki(i)&&!Iu(i)&&!/^[\p{L}·\\_]/u.test(i);return MD.test(n)||t.some(e)},Xv=n=>/^[-+]?[.,]?\d|^[-+]?[OoIl][.,]/.test(n)&&!Iu(n);function SD(n,{firstLine:t,lastLine:e}){let i=Zi(n);return new Set($_(i,t,e).filter(s=>ED(i[s])))}function ED(n){return/^[^\d=:]*\p{L}[^=:\n]{0,30}[=:]/u.test(n)?!1:(n.match(/\p{L}[\p{L}-]{2,}/gu)??[]).filter(e=>!em(e)).length<2}function TD(n,t,e){let{firstLine:i,lastLine:s,sources:r,lines:o}=t,a=new Map(r.flatMap(({line:d,last:f,cells:[p]})=>[d,f].map(m=>[m,p.from]))),c=d=>d>=i&&d<=s;AD(n,t,e);let l=({line:d,cells:f})=>f[0].from<a.get(d),h=o.all.filter(l).length%r.length===0,u=new Set(r.map(Vv));for(let d of o.all){let f=d.cells.length>1&&d.words.length&&u.has(Vv(d)),p=c(d.line)?ID(d,h&&l(d),f):PD(d,t,e);for(let m of d.cells)n.claim(m,p,{reason:oD})}}function AD(n,t,e){let{firstLine:i,lastLine:s,lines:r}=t,o=RD(t,n);for(let a of r.words){let[c]=n.within(a);if(!c)continue;let{line:l}=c,u=(l>=i&&l<=s||e.has(l))&&qv(a.text)||o(l)&&Xv(a.text);n.claim(a,u?"unread":"context",{reason:rD})}}function RD({rows:n,lines:t},e){let i=n[0].length;if(i<Zv)return()=>!1;let s=new Map,r=(o,a)=>s.set(o,(s.get(o)??0)+a);for(let o of t.all)r(o.line,o.cells.length);for(let o of t.words)Xv(o.text)&&r(e.within(o)[0]?.line,1);return o=>s.get(o)===i}var Vv=({words:n})=>n.map(({text:t})=>t.replace(/\d+/g,"#")).join(" "),CD=({words:n})=>n.some(({text:t})=>/\p{L}{2}/u.test(t)),jv=({cells:n})=>n.some(({text:t})=>Ki(t));function ID(n,t,e){return e?"unread":n.name||CD(n)?"context":t&&n.cells.length===1?"label":jv(n)?"unread":"context"}function Yv({cells:n}){let t=n.filter(({text:e})=>Number.isFinite(Number(e)));return t.length>1&&!Fv(t)}function PD(n,t,e){let i=Yv(n)||jv(n)&&Jv(t)<3;return e.has(n.line)&&i&&!n.name||LD(n,t)?"unread":"context"}var Jv=({sources:n})=>Math.max(...n.map(({cells:t})=>t.length));function LD(n,{rows:t,sources:e}){let{length:i}=n.cells;return t.length<2||i<Zv||i!==Jv({sources:e})||!Yv(n)||t.some(s=>Hv(s)===Hv(n.cells))?!1:!/\p{L}/u.test(n.name)&&!Ds(n)}var Hv=n=>n.map(({text:t})=>t).join(),Zv=3;function Kv(n,t,e){let i=t.find(({owner:h})=>h==="unread");if(!i)return;let s=t[t.indexOf(i)+1],r=n[i.to]===","&&s?.from===i.to+1,o=ND(n,{from:i.from,to:r?s.to:i.to}),a=DD(n,i),c={what:Qv(e),word:ee(o),line:i.line+1,where:a},l=tb.test(o)?"unclaimed":"unread";throw new xt(at(l,c),[],t,n)}function pr(n,t,{from:e,to:i},s){for(let c of t)c.from>=e&&c.to<=i&&(c.owner="unread");let r=Zi(n.slice(0,e)).length,o=ee(n.slice(e,i).trim()),a={what:Qv(s),word:o,line:r,where:""};throw new xt(at("unread",a),[],t,n)}var Qv=n=>n.slice(n.lastIndexOf(": ")+1).trim(),tb=/^[-+−–]?\d*(?:[.,]\d*)?(?:e[-+−–]?\d+)?$/i;function ND(n,{from:t,to:e}){let i=/[^\s|&;[\],]*$/.exec(n.slice(Math.max(0,t-20),t))[0],s=/^[^\s|&;[\],]*/.exec(n.slice(e,e+20))[0],r=i+n.slice(t,e)+s,o=r.replace(/^[({]+|[)}]+$/g,"");return tb.test(o)?o:r}function DD(n,{from:t}){let e=Math.max(n.lastIndexOf(`
`,t),t-60)+1,i=n.slice(e,t).split(/[\s|&,;:=]+/).filter(Boolean),s=xn(i.map(o=>({text:o})));if(!s||s.kind==="row")return"";let r=s.kind==="joint"?"joint":"row";return` (${at(r,{[r]:s.number})})`}var w8=new RegExp(String.raw`^(.*\d) ?(${we})$`);var OD=n=>/^(?:\([^()]*\)|[^()\]])*/.exec(n)[0].replace(/[.\s]+$/,""),eb=String.raw`\p{L}+_?\{?\d{1,2}\}?`,UD=new RegExp(String.raw`(?<![\p{L}\d_.\\])(${eb}(?: *, *${eb})*)(?: *\([^()\n=]{0,30}\))? *:?= *`+String.raw`([^\s=][^\n=,;]{0,40})`,"gu");function nb(n,{typedCells:t=[],tokens:e=[]},i){let s=new Set(t.flatMap(r=>di(r)??[]).map(de));for(let{0:r,1:o,2:a,index:c}of n.matchAll(UD)){let l={from:c,to:c+r.trimEnd().length},h=({from:d,to:f})=>d<l.to&&f>l.from,u=d=>d.owner==="entry"&&h(d);o.split(",").some(d=>s.has(de(d.trim())))&&(i.some(h)||e.some(u)||kD(a,FD.test(de(o)))&&pr(n,e,l,at("your table")))}}var FD=/^(?:q|th|theta|phi)\d+$/;function kD(n,t){let e=OD(n),i=di(e);return t?i!==null&&i.length>0&&/[-+*/]/.test(e):/^[-+(]?\s*[.\d]/.test(e)||!!i?.every(s=>/\d$/.test(s))}var ib=n=>n.replace(/^[^\p{L}]+|_\([^()]*\)$/gu,"");var Pu=({cells:n,scale:t})=>t?n.map(e=>({...e,text:`${e.text}${t}`})):n;function Lu(n){return{rows:n.map(Pu),...Uv(n),name:n[0].name||n[0].words.at(-1)?.text||"",firstLine:n[0].line,lastLine:n.at(-1).last,sources:n}}var zD=`,;&|	
${"␞"}`,GD=/([A-Za-z]\w*)$/,rb=6;function VD(n){let t=new Map,e=[];for(let i=0;i<n.length;i++){let s=n[i];if(Wa.includes(s))e.push({at:i,character:s,isSplit:!1,leaf:!0});else if(Qp.includes(s)&&e.length){let r=e.pop(),o=$D(n,r,i)?"list":"group";t.set(r.at,o).set(i,o),e.length&&o==="list"&&(e.at(-1).leaf=!1)}else e.length&&zD.includes(s)&&(e.at(-1).isSplit=!0)}return t}var HD=/^(?:arc|a)tan2$/i,WD=/^\s*(?:[\w.]*array\(|\[)/;function $D(n,{at:t,character:e,isSplit:i,leaf:s},r){let o=n[t-1]??" ",a=GD.exec(n.slice(Math.max(0,t-12),t))?.[1]??"";return HD.test(a)?!1:Ts(a.toLowerCase())?WD.test(n.slice(t+1,t+20))||/rad/.test(a)&&n[t+1]==="(":e==="{"?!/[\w^}]/.test(o)||i&&/[^\W_]/.test(o):e==="["?!/[\w})]/.test(o)||r-t>rb:qD(n,{at:t,isSplit:i,leaf:s},r,o)}function qD(n,{at:t,isSplit:e,leaf:i},s,r){return/\w/.test(r)&&s-t<=rb?!1:e||!i||XD.test(n.slice(t+1,s))}var XD=/^\s*[-+]?[\d.]+(?:\s+[-+]?[\d.]+)+\s*$/;function ob(n,t,e){let{text:i}=n,s=YD(n,t,e),r=VD(i),[o,a]=[0,0];for(let c=0;c<i.length;c++){let l=r.get(c);l==="group"&&(a+=Wa.includes(i[c])?1:-1);let h=l?l==="list":jD(i[c],s);a||!h||(sb(o,c,s),o=c+1,l?JD(s,Wa.includes(i[c])?1:-1,c):ZD(s,i[c]))}return sb(o,i.length,s),{rows:s.rows,words:s.allWords}}var jD=(n,{depth:t})=>n===`
`||n==="␞"||n===";"&&t>0,YD=(n,t,e)=>({plain:n,text:n.text,isEntry:t,splitting:e,rows:[],row:null,words:[],above:[],allWords:[],name:"",nameLine:-1,wordsAtMark:-1,scale:"",line:0,part:0,depth:0,list:-1});function JD(n,t,e){n.row=null,n.depth||(n.list=e),n.depth+=t,n.depth||(n.list=-1)}function ZD(n,t){t===`
`&&n.line++;let e=t!=="␞"&&n.splitting.wrapped&&n.depth>0;e&&t===";"&&n.row&&(n.row.isColumn=!n.splitting.decimal),!e&&(n.row=null,t===`
`&&t3(n))}var rm="·factor·",ab="·columns·",KD=/^[ \t]*(1(?:\.0+)?e[+-]?\d+)[ \t]*\*[ \t]*$/gim,QD=/^[ \t]*Columns?[ \t_]+\d+(?:[ \t]+(?:through|and)[ \t]+\d+)?:?[ \t]*$/gim,cb=n=>n.replace(KD,(t,e)=>rm+e).replace(QD,ab);function t3(n){let t=n.words.map(({text:e})=>e).join(" ");t.startsWith(rm)&&(n.scale=`*${t.slice(rm.length)}`),t===ab&&n.part++,t&&(n.above=n.words),/^\d{1,3}$/.test(n.name)&&(n.name=""),Object.assign(n,{words:[],wordsAtMark:-1})}var e3=["	","&","|",";"],n3=/^\s*[-+]?\d*,\d+[^,\d]*$/;function sb(n,t,e){let{splitting:i,text:s}=e,r=e.line,o=s.slice(n,t);e.line+=o.split("\v").length-1;let a=e3.filter(h=>o.includes(h)),c=a.length?a:i.decimal?[]:[","],l=tm(s,n,t,h=>c.includes(s[h])?s[h]:"");for(let h of l){let u=s.slice(h.from,h.to);if(!u.trim())continue;let f=a.length&&n3.test(u)?{...i,decimal:!0}:i,p=l.length>1?i3(h,f,e):im(h,f,e.plain);for(let m of p)o3(m,r,e)}}function i3(n,t,e){let i=im(n,t,e.plain),s=nm(n,t,e.plain),o=!i.every(({text:a})=>co(a))&&e.isEntry(s.text)?[s]:i;return o.some(({text:a})=>uo(a)||e.isEntry(a))||o.every(a=>xn([a])?.kind==="row")?o:[{...s,text:e.text.slice(n.from,n.to).trim()}]}function s3(n){if(!n.row)return;let{cells:t,words:e,name:i}=n.row,s=t.pop();t.length||(n.rows.pop(),Object.assign(n,{words:e,name:i})),n.words.push(s),n.allWords.push(s)}function r3(n,t){s3(t);let e=n==="="&&t.name&&t.nameLine===t.line;t.name=e?t.name:t.words.at(-1)?.text??"",t.nameLine=n==="="?t.line:-1,Object.assign(t,{scale:"",row:null,wordsAtMark:t.words.length})}function o3(n,t,e){let{text:i}=n;if(!(i==="and"&&e.row)){if(uo(i)){r3(i,e);return}if(Lv(i)||!e.isEntry(i)){a3(n,e);return}if(!e.row){let{words:s,name:r,scale:o,part:a,above:c,depth:l,list:h,wordsAtMark:u}=e,d=s.length===u,f={line:t,last:t,part:a,depth:l,list:h};e.row={cells:[],words:s,name:r,scale:o,above:c,...f,isAssigned:d,tail:0},e.rows.push(e.row),e.words=[],e.name=""}e.row.cells.push(n),e.row.tail=0,e.row.last=e.line}}function a3(n,t){if(t.row&&!/[\p{L}\d°]/u.test(n.text)){t.row.tail++;return}if(!/[\p{L}\d#<>°]/u.test(n.text))return;let e={...n,line:t.line};t.words.push(e),t.allWords.push(e),t.row&&t.row.tail++,t.row=null}function lb(n){let t=n.flatMap(a=>{let c=a.cells.length===1?Ov(a):null;return c&&c.kind!=="count"?[{row:a,label:c}]:[]}),e=t.filter((a,c)=>{let l=[t[c-1],t[c+1]].filter(Boolean);return!Ds(a.row)||l.some(h=>c3(a,h))}),i=[];for(let a of e){let c=i.at(-1)?.some(({label:l})=>l.number===a.label.number);(!i.length||c)&&i.push([]),i.at(-1).push(a)}if(!i.length||i.some(a=>a.length!==i[0].length))return[];let s=i[0].map(({row:a,label:c})=>({...l3(a.words),label:c})),[r,o]=[e[0].row,e.at(-1).row];return[{rows:i.map(a=>a.flatMap(({row:c})=>Pu(c))),labels:i.map(()=>[]),headers:s,name:r.name,firstLine:r.line,lastLine:o.last,sources:e.map(({row:a})=>a)}]}var c3=({label:n},t)=>Math.abs(n.number-t.label.number)===1&&!Ds(t.row),l3=n=>({text:n.map(({text:t})=>t).join(" "),from:n[0].from,to:n.at(-1).to});function hb(n,t){let e=h3(n,t),s=e.flatMap((h,u)=>h.row&&e[u-1]?.row===null?[u3(e,u)]:[]).filter(({cells:h})=>!db(h.map(({text:u})=>u))),r=s.length===1?d3(s[0],e):s;if(r.length<2)return[];let o=r[0].cells.length;if(r.some(({cells:h})=>h.length!==o))return[];let a=r.flatMap(h=>h.rows),c=e.findIndex(({cell:h})=>h===r[0].label),l=ub(e,c);return[{rows:r.map(({cells:h})=>h),labels:r.map(({label:h})=>[h]),headers:e.slice(Math.max(l,c-o-1),c).map(({cell:h})=>h),name:"",firstLine:a[0].line,lastLine:a.at(-1).last,sources:a}]}function ub(n,t){let e=t;for(;n[e-1]?.row===null&&n[e-1].line===n[e].line-1;)e--;return e}function h3(n,t){let i=[...n.flatMap(r=>Pu(r).map(o=>({line:r.line,cell:o,row:r}))),...t.map(r=>({line:r.line,cell:r,row:null}))],s=new Map;for(let{line:r}of i)s.set(r,(s.get(r)??0)+1);return i.filter(({line:r})=>s.get(r)===1).sort((r,o)=>r.line-o.line)}function u3(n,t){let e=t+1;for(;n[e]?.row&&n[e].line===n[e-1].line+1;)e++;let i=n.slice(t,e);return{label:n[t-1].cell,cells:i.map(({cell:s})=>s),rows:i.map(({row:s})=>s)}}function d3({cells:n,rows:t},e){let i=e.findIndex(({row:o})=>o===t[0]),s=i-ub(e,i)+1,r=[s,s-1].filter(o=>o>2);for(let o of r){let a=Array.from({length:Math.floor(n.length/o)},(c,l)=>l*o);if(!(n.length%o||!db(a.map(c=>n[c].text))))return a.map(c=>({label:n[c],cells:n.slice(c+1,c+o),rows:t.slice(c,c+o)}))}return[]}var db=n=>n.every((t,e)=>Number(t)===e+1),f3=/[[({](\d{1,2})\s*,\s*(\d{1,2})[\])}]$/;function fb(n){let t=n.flatMap(a=>{let c=a.cells.length===1&&f3.exec(a.words.at(-1)?.text??"");return c?[{row:a,i:Number(c[1]),j:Number(c[2])}]:[]}),e=a=>Math.min(...t.map(c=>c[a])),i=a=>Math.max(...t.map(c=>c[a]))-e(a)+1;if(i("i")*i("j")!==t.length)return[];let s=Array.from({length:i("i")},()=>Array(i("j")));for(let{row:a,i:c,j:l}of t)[s[c-e("i")][l-e("j")]]=a.cells;if(s.some(a=>a.includes(void 0)))return[];let[r,o]=[t[0].row,t.at(-1).row];return[{rows:s,labels:s.map(()=>[]),headers:[],name:r.name,firstLine:r.line,lastLine:o.last,sources:t.map(({row:a})=>a)}]}var p3=[!1,!0].flatMap(n=>[!0,!1].flatMap(t=>[!1,!0].map(e=>({gaps:n,decimal:t,wrapped:e})))),pb=n=>Mp(Av(ao(Zn(n))));function mb(n,{isEntry:t,names:e,given:i=[],commas:s}){let r=cb(n),o=new Map,a=u=>(o.has(u)||o.set(u,!x3.test(u)&&t(u)),o.get(u)),c=m3.test(r.text),l=/[[({]/.test(r.text);return p3.filter(({decimal:u,wrapped:d})=>(!u||c)&&(!d||l)&&(!s||u===(s==="decimal"))).map(u=>{let d=c&&!u.decimal&&!g3.test(r.text),f=am(()=>_3(ob(r,a,u),i)),p=x=>am(()=>{let _=y3(f(),e,x);return d?_.map(b=>({...b,splitsCommas:d})):_}),[m,g]=[p(!0),p(!1)];return(x=!1)=>x&&f().given.size>0?m():g()})}var m3=/,\d/,g3=/\d\.\d+,[-+]?\d/,x3=/^\(\d{1,2}\)$|\d\.\d*\s+[-+]\d*\.\d/;function am(n){let t=null;return()=>t??=n()}function _3({rows:n,words:t},e){let i=e.filter(r=>r.length>1&&r.some(Boolean)),s=({cells:r,words:o})=>{if(xn(o)?.kind==="row")return!1;let a=am(()=>r.map(b3));return i.some(c=>c.length===r.length&&v3(a(),c))};return{all:n,words:t,given:new Set(n.filter(s))}}function y3(n,t,e){let{all:i,words:s,given:r}=n,o=e?i:i.filter(c=>!r.has(c));return[...w3(o,t),...A3(o),...lb(o),...fb(o),...hb(o,s)].map(c=>({...c,lines:n}))}var v3=(n,t)=>n.every(({value:e,half:i},s)=>Math.abs(e-t[s])<=i||Math.abs(e-t[s]/Xe)<=i);function b3({text:n}){let t=n.replace(/ ?deg$/,""),[e,i=1]=t.split("*"),s=.51*10**-(e.split(".")[1]?.length??0)*Number(i);return{value:kn(t)??NaN,half:s}}var om=(n,t)=>t?.test(ib(n))??!1;function w3(n,t){let e=[];for(let r of new Set(n.map(({cells:o})=>o.length))){let o=[],a=-1;n.forEach((c,l)=>{if(c.cells.length!==r)return;let h=n.slice(a+1,l);a>=0&&M3(c,n[a],h)&&E3(c,o[0],t)?o.push(c):e.push(o=[c]),a=l})}let i=T3(e);return[...(i.length?e.filter(([r])=>!r.part):e).map(Lu),...i]}var M3=(n,t,e)=>t.part===n.part&&t.depth===n.depth&&e.every(({line:i})=>i===t.line||i===n.line)&&sm(n)===sm(t)&&(n.cells.length>1?S3(n,t)||Ds(n)===Ds(t):zv(n,t)),S3=(n,t)=>n.list>=0&&n.list===t.list,E3=(n,t,e)=>n.name?t.name?om(n.name,e)===om(t.name,e):!e||om(n.name,e)||!/\p{L}/u.test(n.name):!0;function T3(n){let t=n.filter(([s])=>s.part>0).sort(([s],[r])=>s.line-r.line).filter(([s],r,o)=>s.part!==o[r-1]?.[0].part).map(Lu);if(t.length<2||t.some(({rows:s})=>s.length!==t[0].rows.length))return[];let e=t[0].rows.map((s,r)=>t.flatMap(o=>o.rows[r])),i=t.flatMap(s=>s.sources);return[{...t[0],rows:e,headers:[],lastLine:t.at(-1).lastLine,sources:i}]}function A3(n){let t=new Map;for(let e of n){let i=e.words.map(({text:r})=>r).join(" "),s=`${e.cells.length} ${i.replace(/\d+/g,"#")}`;!e.words.length||e.cells.length<2||(t.has(s)||t.set(s,[]),t.get(s).push(e))}return[...t.values()].filter(({length:e})=>e>2).map(Lu)}var xb=/\\\/|╲╱/g,R3=/^_{3,}/,_b=/[⎛-⎭]/g,C3=/(?<![^\s[(⎛-⎭])(?:─+|-+)(?![^\s\]),⎛-⎭])/g,yb=/^(?=.*[\dπp])(?:[-+*·\d. √π()]|pi)+$/,I3=/[\s⎛-⎭[\](),]/g,P3=/[⎛-⎭[]/,L3=/\\\/|╲╱|[⎛-⎭].*─/,N3=/√\(|\)\/\(/;function vb(n,t){let e=gb(gb(n,D3),O3),i=[_b,xb].some(c=>n.text.search(c)>=0);if(e===n&&!i)return n;let[s,r]=[n,e].map(({text:c})=>c.split(`
`)),o=F3(s,r);if(o<0)return e;let a=ee(s[o].trim());throw new xt(at("drawn formula",{what:t,line:o+1,quoted:a}))}function gb(n,t){let e=Ii(n.text),i=e.flatMap((r,o)=>t(e,o));if(!i.length)return n;i.sort((r,o)=>r.from-o.from);let s=i.flatMap(({from:r,parts:o},a)=>[{from:i[a-1]?.to??0,to:r},...o]);return n.assemble([...s,{from:i.at(-1).to,to:n.text.length}])}var cm=({from:n,to:t})=>({from:n,to:t,parts:[" ".repeat(t-n)]});function D3(n,t){let{text:e,from:i}=n[t],s=n[t-1]??{text:"",from:0};return[...e.matchAll(xb)].flatMap(({index:r})=>{let o=r+2,a=R3.exec(s.text.slice(o))?.[0].length??0,c=Math.min(o+a-1,e.length);return!yb.test(e.slice(o,c))||e[c]?.trim()?[]:[cm({from:s.from+o,to:s.from+o+a}),{from:i+r,to:i+o,parts:["√("]},{from:i+c,to:i+Math.min(c+1,e.length),parts:[")"]}]})}function O3(n,t){let{text:e,from:i}=n[t];return[...e.matchAll(C3)].flatMap(({0:{length:s},index:r})=>{let o=r+s,[a,c]=[n[t-1],n[t+1]].map(d=>U3(d,r,o));if(!a||!c||c.text.includes("."))return[];let l=s-Math.max(a.text.length,c.text.length),h=/[-+] $/.test(e.slice(0,r))||/^ [-+] /.test(e.slice(o));if(l>1||!(h||/[√π]|pi/.test(a.text+c.text)))return[];let u=["(",a,")/(",c,")"];return[cm(a),{from:i+r,to:i+o,parts:u},cm(c)]})}function U3(n,t,e){let i=n?.text.slice(t,e)??"",s=i.trim();if(!yb.test(s))return null;let r=n.from+t+i.indexOf(s);return{from:r,to:r+s.length,text:s}}function F3(n,t){return t.findIndex((e,i)=>{let[s,r=""]=n.slice(i,i+2);return L3.test(e)||k3(s,r)||B3(s,r)?!0:N3.test(e)?![0,2].includes(e.match(_b)?.length??0)||Nu(t[i-1])||Nu(t[i+1]):!1})}var Nu=(n="")=>n.replace(I3,"")&&!/\p{L}{3}|[:=]\s*$/u.test(n),k3=(n,t)=>Nu(t)&&[...n.matchAll(/[^\s⎛-⎭[\](),]+/g)].some(({0:e,index:i})=>/\d/.test(e)&&!t.slice(i,i+e.length).trim()&&/[\p{L})]/u.test(t[i-1]??""));function B3(n,t){let[e,i]=[n,t].map(r=>r.search(P3));if(e<0||i<0||e===i)return!1;let s=[n.slice(e),t.slice(i)];return s.every(r=>Nu(r))&&/[\p{L}√]/u.test(s.join(""))}var Ht=["a","alpha","d","theta"],z3=/^(?:q|th|theta|t|phi)\d+$/,Os=/^(?:var(?:iab(?:le|el))?|[-*?qd]|th(?:eta)?)\*?$/i,G3=/\s*\(locked[^()]*\)\s*$/i,Uu=n=>n.replace(/^['"]|['"]$/g,"").replace(/^[^=]*=\s*/,"").replace(G3,(t,e,i)=>Qn(i.slice(0,e))?t:"").replace(/(?<=.)\^?\{?\*+\}?(?=\s*(?:[-+]|$))/g,"").trim();function Qn(n){let t=Ce(n);return Os.test(t)?!0:di(t)?.some(e=>z3.test(de(e)))??!1}function wb(n,t,e){let i=Du(m=>(W3.has(m)?Mb(t[m]):t[m]).trim()),s=q3(i),r=Du(m=>j3(s[m].replace(Ou,""),m,n,e)),o=m=>!e.has(de(m)),a=Du(m=>[...As(r[m])].filter(o).sort()),c=a.theta.length?"theta":a.d.length?"d":null,l=K3(n,a,c,i.theta),h=(m,g)=>Fn(r[m],x=>a[m].includes(x)?g:e.get(de(x))),u=Du(m=>h(m,0)),d=c!==null&&Q3(h(c,1)-u[c],n,c)<0,f=m=>H3(g=>Fn(r[m],x=>a[m].includes(x)?0:g*e.get(de(x)))),p=m=>/\b(?:pi|deg|rad)\b/.test(Ce(t[m]));return{kind:c===null?"unknown":X3[c],numbers:u,symbolMetres:{a:f("a"),d:f("d")},texts:i,backwards:d,joint:l,radians:new Set(Ht.filter(p)),metres:new Set(Ht.filter(m=>Ou.test(i[m]))),trees:r}}var V3=10;function H3(n){let[t,e,i]=[0,1,2].map(n);return Math.abs(i-2*e+t)<=1e-9*Math.max(1,Math.abs(i))&&Math.abs(e-t)<V3?e-t:0}var W3=new Set(["a","d"]),Ou=/ m$/,$3=new RegExp(String.raw`^([-+−]?)\s*(\d*\.?\d*)(?:\*1e-(\d)|\s*(${we}))$`);function Mb(n){let t=n.trim().match(/[-+−]?[^-+−]+/g)??[];if(t.length>1&&!n.includes("e-")){let c=t.map(Mb);return c.every(l=>Ou.test(l))?`${c.map(l=>l.replace(Ou,"")).join("")} m`:n}let[,e,i,s,r]=$3.exec(n.trim())??[];if(!i)return n;let o=Number(s??Math.round(-Math.log10(fi[r]))),a=(i.split(".")[1]??"").length+o;return`${e}${(Number(i)/10**o).toFixed(a)} m`}var bb=n=>["-","–","—"].includes(n);function q3(n){let{a:t,alpha:e,d:i,theta:s}=n,r=o=>bb(o)?"0":o;return{a:r(t),alpha:r(e),d:bb(i)&&Qn(s)?"0":i,theta:Qn(r(i))?r(s):s}}var X3={theta:"revolute",d:"prismatic"},Du=n=>Object.fromEntries(Ht.map(t=>[t,n(t)]));function j3(n,t,e,i){let s=Ce(n),o=(t==="theta"||t==="d")&&Os.test(s)&&!i.has(de(s));return ui(o?`q_${e}`:s,`${t} in row ${e}`)}function Y3(n){let[t]=/\d+/.exec(n??"")??[];return t===void 0?null:{name:n,number:Number(t)}}var J3=/^(?:[dqstx]|phi)/i,Z3=/^[A-Za-z]+[[(]\d{1,2}[\])]/;function K3(n,t,e,i){let s=e===null?[]:t[e],r=s.find(l=>/^[qt]/.test(l))??s[0],o=l=>J3.test(l)||e==="theta"&&Z3.test(i),a=l=>h=>l!==e||h!==r||!o(h),[c]=Ht.flatMap(l=>t[l].filter(a(l)));if(c===void 0)return Y3(r);throw new xt(at("row symbol",{row:n,name:c}),[{field:"values",value:c}])}function Q3(n,t,e){let i=s=>Math.abs(Math.abs(n)-s)>1e-6;if(i(1)&&i(Xe))throw new xt(at("row slope",{row:t,name:e,rate:_i(n)}));return n>0?1:-1}var qa=(n,t)=>n.split(" ").map(e=>[e,t]),Sb=new Map([...qa("theta th q jointangle angle thetaoffset jointoffset theta0 q0","theta"),...qa("d offset linkoffset","d"),...qa("a r linklength length aprev","a"),...qa("alpha twist linktwist al alphaprev","alpha"),...qa("i link joint j row # k","i")]),tO=80,eO=new RegExp(String.raw`\([^)]*\)?|\[[^\]]*\]?|\bin\b.*|[,/].*|_(?:${we}|deg|rad)$`,"g");function Me(n){if(n.length>tO)return;let e=Ce(lm(n).replace(/-\s*1/g,"")).replaceAll("*","").toLowerCase().replace(eO,""),i=e.trim().split(/\s+/).at(-1);return Eb(e)??Eb(i)}function Eb(n){let t=n.replace(/[\s_{}$\\^'"().]/g,"");return Sb.get(t)??Sb.get(t.replace(/[ijkn]$/,""))}var lm=n=>n.replace(/[ᵢⱼₖₙ₋₁]/g,t=>"ijkn-1"["ᵢⱼₖₙ₋₁".indexOf(t)]).replace(/[⍺∝]/g,"α"),Fu={alpha:"theta",theta:"alpha"},Rb=n=>n.toLowerCase().includes("offset");function ku(n,t="theta"){let e=n.map(Me),i=e.filter(s=>s==="d").length>1;return e.map((s,r)=>i&&Rb(n[r])?t:s)}var Tb=["a alpha d theta","theta d a alpha","alpha a d theta","alpha a theta d","d theta a alpha","d a alpha theta"].map(n=>n.split(" "));function Cb(n){let t=nO(n);return!t.cells.every(({length:i})=>[4,t.headers.length].includes(i))&&Bu(t.headers)!==null&&Ib(n.headers.length,n.cells[0].length),t}function nO({cells:n,headers:t}){let e=t.map(Me),i=Ab(n.map(a=>Ce(a[0]))),s=n.every(a=>a.length===t.length-1);if(s&&!i&&!Ht.includes(e[0]))return{cells:n,headers:t.slice(1)};s&&i&&t.length===5&&Ib(5,4);let r=e.indexOf("i"),o=a=>a.filter((c,l)=>l!==r);if(r>=0)return iO(n.map(a=>a[r])),{cells:n.map(o),headers:o(t)};if(n.some(a=>a.length<=4))return{cells:n,headers:t};if(n.length>1&&Ab(n.map(a=>Ce(a[0])).reverse()))throw new xt(at("rows reversed",{count:n.length}));return i?{cells:n.map(a=>a.slice(1)),headers:t.length>4?t.slice(1):t}:{cells:n,headers:t}}function iO(n){let t=n.find(Ki);if(t)throw new xt(at("row number",{text:ee(t)}))}function Ib(n,t){throw new xt(at("short rows",{headers:n,count:t}))}var Ab=n=>!n.some(Qn)&&[0,1].some(t=>n.every((e,i)=>xn([{text:e}])?.number===i+t)),Pb=(n,t,e)=>(e?sO(n,e):rO(n,t))??oO(n,t);function sO(n,t){let i=t.trim().split(/[\s,;|]+/).map(Me);if([...i].sort().join()!==Ht.join())throw new xt(at("no columns",{given:ee(t)}));return Nb(n),{orders:[i],isStated:!0,rows:n}}function Bu(n){let t=ku(n,""),e=Ht.map(s=>t.indexOf(s));if(e.includes(-1))return null;let i=n.findIndex((s,r)=>Rb(s)&&!e.includes(r));return n.map((s,r)=>r===i?"offset":e.includes(r)||t[r]==="i"?t[r]:void 0)}function rO(n,t){let e=Bu(t);if(!e||n.some(a=>a.length!==t.length))return null;let i=Ht.map(a=>e.indexOf(a)),s=e.indexOf("offset"),r=n.map((a,c)=>{let l=i.map(d=>a[d]??"0"),h=a[s]??"0";return["","-"].includes(h.trim())||kn(h)===0?l:cO(c+1,l,h)}),o=e.filter(a=>Ht.includes(a));return{orders:[Ht],isStated:!0,rows:r,typedOrder:o}}function oO(n,t){Nb(n);let e=t.length===4?ku(t):[];aO(e,t);let i=a=>e.every((c,l)=>!Ht.includes(c)||a[l]===c),s=n.map(a=>a.map(lO)),o=[...new Map([...Tb,...Lb(Ht)].map(a=>[a.join(),a])).values()].filter(a=>i(a)&&hO(s,a));return{orders:o.length?o:[Tb[0]],isStated:!1,rows:n}}function aO(n,t){let e=new Set(n.filter(s=>Ht.includes(s))),i=t[n.findIndex(s=>!Ht.includes(s))];if(e.size===3&&/\p{L}{3}/u.test(i??""))throw new xt(at("unknown column",{header:ee(i)}))}function cO(n,t,e){let[i,s]=[2,3].map(a=>kn(t[a])===null),r=i&&!s?2:3,o=Os.test(Ce(t[r]))?`q_${n}`:t[r];return t.map((a,c)=>c===r?`${o} + (${e})`:a)}var Lb=n=>n.length<2?[n]:n.flatMap((t,e)=>Lb(n.filter((i,s)=>s!==e)).map(i=>[t,...i]));function Nb(n){let t=n.find(({length:e})=>e!==4);if(t)throw new xt(at("row width",{widths:t.length}))}function lO(n){return{variable:Qn(n),angular:/pi|deg/.test(Ce(n)),number:kn(n)}}function hO(n,t){let[e,i,s]=Ht.map(r=>n.map(o=>o[t.indexOf(r)]));return[...e,...s].some(({angular:r})=>r)||[...e,...i].some(({variable:r})=>r)?!1:i.every(r=>r.number===null||uO(r.number))}function uO(n){let t=n/(Math.PI/12);return Math.abs(n)<=2*Math.PI+.01&&Math.abs(t-Math.round(t))<.02||n%15===0&&Math.abs(n)<=360}var Db=n=>[...n].sort().join()===Ht.join(),dO=n=>n.length===3&&new Set(n).size===3&&n.every(t=>Ht.includes(t)),fO=/[[(]([^[\]()\n]*)[\])]|"([^"\n]*)"/g,pO=[/[,|&;\t]/,/\s+/];function um(n){let t=[...n.matchAll(fO)].map(([,i,s])=>i??s),e=null;for(let i of[...t,n.replace(/^[^:]*:/,""),n])for(let s of pO){let r=i.split(s).map(c=>c.trim()),o=r.filter(Boolean).map(Me),a=o.findIndex((c,l)=>Db(o.slice(l,l+4)));if(a>=0)return r.filter(Boolean).slice(a,a+4);dO(o)&&(e??=r.filter(Boolean))}return e}var mO=/(?:#(?!\d)|%|\/\/)(.*)/,gO=/^\s*(?:def|function)\s/,xO=/\b(?:columns?|order|spalten|reihenfolge)\b/i;function _O(n){return n.split(`
`).flatMap(t=>{if(gO.test(t))return[];let[,e]=mO.exec(t)??[],i=um(e??t),s=e!==void 0||xO.test(t);return i?[{line:t.trim(),order:i.map(Me),headers:i,isFirm:s}]:[]})}function Ob(n,t){if(!n.every(({isOrderGuessed:e})=>e))return n;for(let{line:e,order:i,headers:s,isFirm:r}of _O(t)){let o=n.filter(h=>h.order.join()===i.join()),{convention:a}=Ub(s);if(o.length)return o.map(h=>({...h,isOrderGuessed:!1,convention:h.convention??a,assumptions:h.assumptions.filter(u=>u!==yO(h))}));if(!r)continue;let c=Db(i)?"contrary order":"half order",l=at(c,{quoted:ee(e)});throw new xt(l,[],n[0].tokens,t)}return n}var yO=({order:n})=>at("taken: columns",{columns:n.join(" ")}),vO=new RegExp(String.raw`[[(/_]\s?(${we})(?!\w)`,"g"),bO=new RegExp(String.raw`[[(/_ ]\s?(${we})(?!\w)`),hm=/-\s*1|prev/i,wO=/[_{(]\s*[ijkn]|(?<=^\W*(?:a|alpha|α))[ijkn](?![\p{L}])/u;function Ub(n){let t=n.map(lm),e=t.join(" "),i=new Set([...e.matchAll(vO)].map(([,a])=>a));zu("units of length",i);let s=[.../deg|°/i.test(e)?["deg"]:[],.../(?:\b|_)rad/.test(e)?["rad"]:[]];zu("units of angles",new Set(s));let r=t.filter(a=>["a","alpha"].includes(Me(a))),o=a=>wO.test(a)&&!hm.test(a);if(r.some(o)&&r.some(a=>hm.test(a)))throw new xt(at("half craig",{headers:ee(r.join(", "))}));return{lengths:bO.exec(e)?.[1]??null,angles:s[0]??null,convention:hm.test(e)?"craig":null}}function zu(n,t){let e=[...t].join(", ");if(t.size>1)throw new xt(at("two statements",{what:n,given:e}))}var MO=new RegExp(String.raw`\b(?:lengths?|distances?|dimensions)(?: (?:are|all|given|measured|taken))*`+String.raw`(?: in|:| \() ?(${we}|milli|centi|met)(?:met)?(?:ers?|res?)?\b`,"gi"),SO=new RegExp(String.raw`(?:\bunits?(?: are| in|:) ?|\bin |^[ \t]*[[(])(${we})`+String.raw`(?:, ?| and )(?:deg|rad|°)`,"gim"),EO=new RegExp(String.raw`\bangles?(?: (?:are|all|given|measured|taken))*(?: in|:| \() ?`+"(?:(rad)(?:ians?)?|deg(?:rees)?|°)","i"),TO={milli:"mm",centi:"cm",met:"m"};function AO(n){let e=[MO,SO].flatMap(r=>[...n.matchAll(r)]).map(([,r])=>r.toLowerCase()),i=new Set(e.map(r=>TO[r]??r));zu("units of length",i);let s=EO.exec(n);return{lengths:[...i][0]??null,angles:s&&(s[1]?"rad":"deg")}}function RO(n){return/\bstandard\b|\bspong\b/i.test(n)?"standard":/\b(?:craig|modified|m-?dh|khalil)\b|\bmod\./i.test(n)?"craig":null}function Gu({headers:n,context:t,convention:e},i){let[s,r]=[Ub(n),AO(t)],o=RO(t),a=e??s.convention;return!i.convention&&o&&a&&zu("conventions",new Set([o,a].map(c=>CO[c]))),{lengths:i.lengths||(s.lengths??r.lengths),angles:i.angles||(s.angles??r.angles),convention:i.convention||(a??(o==="craig"?o:null))}}var CO={craig:"Craig's convention",standard:"the standard convention"},IO=/(?<![\d.]\s?|[\p{L}\d_\\]|N[ ·.*-]?)cm(?![\p{L}\d])|[[(,]\s?m\s?[\]),]/gu,PO=new RegExp(String.raw`^ ?(${we})(?![\p{L}\p{N}])`,"u");function Fb(n,t){let e=t.match(IO)??[],i=n.filter(({owner:s})=>s==="entry").map(({to:s})=>PO.exec(t.slice(s,s+5))?.[1]);return[...e,...i].find(s=>s&&s!=="mm")?.replace(/[^cm]/g,"")}function Vb(n,t,e=new Ns(n)){let i=vb(e,at("your table")),s=pb(Rv(i)).replace(DO,""),r=HO(BO(FO(s))),o=mb(r.plain,{isEntry:Vu(t)}),a=Zi(r.plain.text),c=({headers:l,cells:h})=>(l.length?100:0)+h.length;return o.flatMap(l=>l().reverse()).map(zO).flatMap(l=>GO(l,a,r.headers)).filter(({cells:[l=[]]})=>l.length>=4).sort((l,h)=>c(h)-c(l)).map(l=>({...l,context:Zn(n),plainLines:a}))}var LO=String.raw`(?!al|th|q)[a-z]\w{0,6}[ \t]*=[ \t]*-?[\d.]{1,12}(?:[ \t]*m{1,2})?`,NO=String.raw`[a-z]\w?(?:[ \t]*,[ \t]*[a-z]\w?){1,20}[ \t]*=[ \t]*[-\d., \t]+`,DO=new RegExp(String.raw`^[ \t]*(?:(?:${LO}[ \t]*(?:[,;][ \t]*|$)){2,}|${NO})$`,"gim"),OO=/([A-Za-zθϑφ]_?\{?[\d₀-₉]*\}?)\^?\{?(?:[*∗⋆]|\\(?:ast|star))\}?(?!\S)/g,UO=/(?<=\s)\*(?=[ \t]*$)/gm,FO=n=>n.replace(OO,"$1").replace(UO,"?"),kO=/^([ \t|]*)(?:T|EE|TCP|flange)(?=(?:[ \t|&;,]+[-+−]?[\d.][^\s|&;,]*){4}[\s|&;,\\]*(?![\s\S]))/gm,BO=n=>n.replace(kO,"$1tool");function zO(n){let t=n.rows.map(i=>i.every(({text:s})=>s==="-")),e=i=>i.filter((s,r)=>!t[r]);return{...n,rows:e(n.rows),labels:e(n.labels)}}function GO(n,t,e){let{rows:i,labels:s,firstLine:r}=n,o=s.map(l=>Bb(kb(l),e)?.[0]),a=o.flatMap((l,h)=>l?[h]:[]);if(new Set(a.map(l=>Me(o[l]))).size<3){let l=t.slice(Math.max(0,r-VO),r+1).reverse(),h=Bb(l.join(" ").split(" "),e)??[];return[{block:n,cells:i.map(kb),headers:h}]}let c=i[0].map((l,h)=>a.map(u=>i[u][h].text));return[{block:n,cells:c,headers:a.map(l=>o[l]),isTurned:!0}]}var kb=n=>n.map(({text:t})=>t),VO=3,dm="·headers·",Bb=(n,t)=>{let e=n.find(i=>i.startsWith(dm));return e?t[Number(e.slice(dm.length))]:null};function HO(n){let t=[],e=[],i=[...n.text.matchAll(WO)].map(({0:c,index:l})=>({text:c,from:l})),s=({text:c,from:l},h,u)=>{let[d]=/^[\s[({|]*/.exec(c),f=`${d.replaceAll("|"," ")} ${dm}${t.push(h)-1} `;e.push({from:l,to:l+u,text:f})},r=i.filter(({text:c})=>zb(c)),o=[];for(let c of r){let l=zb(c.text),h=i.slice(i.indexOf(c)+1).find(({text:f})=>/[\p{L}\d]/u.test(f)),u=h?QO(h.text,l.length):null,d=u?l.map((f,p)=>`${f} ${u[p]}`):l;s(c,d,c.text.length),u&&s(h,d,h.text.length),u&&o.push(h)}for(let c of i)!o.includes(c)&&!r.includes(c)&&e.push(...$O(c,r));let a=r.length?[]:i.flatMap(jO);if(new Set(a.map(({header:c})=>Me(c))).size>=qO)for(let{line:c,header:l,length:h}of a)s(c,[l],h);return e.sort((c,l)=>c.from-l.from),{plain:n.edit(e),headers:t}}var WO=new RegExp(`[^
${"␞"}]+`,"g"),fm=n=>n.replace(/^[\s[({|]+/,"");function $O(n,t){if(!n.text.trim())return[];for(let e of t){let i=["	",";",",","|","&"].find(a=>e.text.includes(a)),[s,r]=[n,e].map(({text:a})=>a.split(i));if(s.length!==r.length)continue;let o=n.from;return s.flatMap((a,c)=>{let l=o;o+=a.length+1;let h=r[c].trim(),u=!a.trim()&&h!=="",d=Me(h)==="i"&&/^\p{L}\D*$/u.test(a.trim()),f=u?"0":"tool";return u||d?[{from:l,to:l+a.length,text:f}]:[]})}return[]}var qO=3,XO=new RegExp(String.raw`^([^|&\t;:=\d-]{1,24}?(?:\s?[[(][^\])]{1,8}[\])]|_\{?i ?- ?1\}?)?)`+String.raw`\s*(?:[|&\t;:,=]|\s(?=[-+]?[.\d]|(?:q|θ|th)[\w]*\d))`);function jO(n){let t=fm(n.text),[e,i]=XO.exec(t)??[];return!i||!Ht.includes(Me(i))?[]:[{line:n,header:i,length:n.text.length-t.length+e.length}]}var Hb=[/\| {2}\||[|&\t;]/,/\s{2,}/,/,/,/\s+/];function zb(n){let[,t]=YO.exec(n)??[],[,e=""]=JO.exec(n)??[],i=a=>Ht.every(c=>a?.map(Me).includes(c)),s=Gb(n),r=[Gb(e),s].find(i)??s;if(i(r)||!t)return r;let o=um(t)??[];return o.length===Ht.length?o:r}function Gb(n){let t=fm(n).replace(/^(?:%|\/\/)+\s*|[|\s\])}]+$/g,i=>i.replace(/[|\s%/]/g,"")),e=i=>Me(i)==="i";for(let i of Hb){let s=t.split(i),r=ZO(s.map(a=>a.trim())).filter((a,c,l)=>!c||!e(a)||!e(l[c-1])),o=r.map(Me).filter(a=>Ht.includes(a));if(!r.some(co)&&new Set(o).size>=3&&r.length<=o.length+4)return r}return null}var YO=/^[^\p{N}]*(?:#|%|\/\/)(.*)/u,JO=/^\W*\p{L}[^#%]*(?:#|%|\/\/)(.*)/u;function ZO(n){let t=[];for(let e of n)/^[([].*[)\]]$/.test(e)?t.push(`${t.pop()??""} ${e}`):t.push(e);return t}var KO=new RegExp(`^[[(]?(?:${we}|deg|rad|°|-)?[\\])]?$`);function QO(n,t){for(let e of Hb){let s=fm(`|${n.replace(/_\(([^()]*)\)/g," $1")}`).replace(/[|\s]+$/,"").split(e).map(o=>o.trim()),r=s.filter(o=>/\p{L}|°/u.test(o));if(!(s.length!==t||!r.length||!s.every(o=>KO.test(o))))return s.map(o=>/\p{L}|°/u.test(o)?`(${o.replace(/[^\p{L}°]/gu,"")})`:"")}return null}var tU=/^\d{1,2} ?- ?\d{1,2}$/,eU=/^[-+−–]\s*[-+−–]\s*[^-+−–\s]/,nU=/^[-+−–]?\s*\d+\(\d\)$/,iU=/^(?:deg|rad)$/,sU=/^(?:joint|link|row|frame)_?\d+$/i,rU=/^(?:[a-z]+_?\{?\d+\}?'?|[a-z]_\{?\w+\}?|[adlhrbeq])$/i,oU=/^(?:p|revolute|prismatic|fixed|base|tool)$/i;function Vu(n){let t=e=>!sU.test(e)&&(rU.test(e)||n.has(de(e)));return e=>{if([tU,nU,iU,eU].some(s=>s.test(e)))return!1;let i=Uu(e);return co(i)||Os.test(Ce(i))||oU.test(i)?!0:di(i)?.every(t)??!1}}var $b=/^[([]\D+[)\]]$/,aU=/^(?:[\p{L}#]+[ _]?)?\d{1,2}(?: ?[-–→] ?\d{1,2})?$/u;function qb(n,t){let e=Ii(n).filter(d=>d.text.trim()),i=e.findIndex((d,f)=>Wb(e.slice(f,f+20)));if(i<0)return n;let s=i+Wb(e.slice(i,i+20)),r=e.slice(i,s),o=cU(e.slice(s),t),a=r.filter(d=>!$b.test(d.text.trim())),c=lU(a,o,e[s+o.length]),l=o.filter((d,f)=>(f+1)%c===0),h=new Set([r.at(-1),...l]),u=n.split("");return e.slice(i,s+o.length-1).forEach((d,f)=>{let p=d.from+d.text.trimEnd().length;u.fill(" ",p,e[i+f+1].from),u[d.to]=h.has(d)?`
`:"|"}),u.join("")}function Wb(n){let t=new Set,e=0;for(let{text:i}of n){let s=i.trim(),r=Me(s),o=/offset/i.test(s);if(!$b.test(s)){if(r===void 0||/[=:]/.test(s)||t.has(r)&&!o)break;t.add(r)}e++}return Ht.every(i=>t.has(i))?e:0}function cU(n,t){let e=({text:s})=>t(s.trim())||aU.test(s.trim()),i=n.findIndex(s=>!e(s));return i<0?n:n.slice(0,i)}function lU(n,t,e){let{length:i}=n,s=n.some(l=>Me(l.text.trim())==="i"),o=t.every(({text:l},h)=>h%(i+1)>0||Number(/\d+/.exec(l))===h/(i+1)+1)&&!s?i+1:i;if(t.length%o===0)return o;let a={columns:i,count:t.length},c=e?` before ${ee(e.text.trim())}`:"";throw new xt(at("cell lines",{...a,behind:c}))}var hU=10,Hu=2*Math.PI+.1,Jb=["alpha","theta"],mm=["a","d"];function Zb(n,t){let e=uU(n);if(e&&n.otherUnit)throw new xt(at("unit seen",{unit:n.otherUnit}));let i=Kb(n).map(Math.abs),s=n.angles===null&&Math.max(...i)>Hu;s&&fU(i),pU(n,i);let r=fi[e?"mm":n.lengths??"m"],o=s||n.angles==="deg"?Xe:1,a=n.convention==="craig",c=mU(n,t,r,o),l=[...n.assumptions,...e?[at("taken: millimetres")]:[],...s?[at("taken: degrees")]:[],...Xb("taken: fixed",(h,u)=>gU(n,t,u),n),...a?[at("taken: craig")]:[],...Xb("taken: backwards",({backwards:h})=>h,n)];return{rows:a?_U(c):c,assumptions:l,length:r,angle:o}}var uU=({lengths:n,rows:t})=>n===null&&t.some(e=>mm.some(i=>Math.abs(gm(e,i))>=hU)),gm=({numbers:n,symbolMetres:t},e)=>n[e]-(t?.[e]??0),dU=(n,t,e)=>ru(gm(n,t),n.metres.has(t)?1:e)+(n.symbolMetres?.[t]??0),Kb=({rows:n})=>n.flatMap(({numbers:t,radians:e})=>Jb.map(i=>e.has(i)?0:t[i]));function fU(n){let t=n.find(Qb);if(!t)return;let e={one:_i(Math.max(...n),4),other:_i(t,6)};throw new xt(at("two angles",e),[{field:"angles",value:"deg"}])}function pU({angles:n,isOrderGuessed:t},e){let[i,s]=n==="rad"?[a=>a>Hu,"deg"]:[Qb,"rad"],r=n&&!t?e.find(i):void 0;if(r===void 0)return;let o=n==="rad"?"stated radians":"stated degrees";throw new xt(at(o,{angle:_i(r,6)}),[{field:"angles",value:s}])}var Qb=n=>[Math.PI/2,Math.PI].some(t=>Math.abs(n-t)<.005);function mU(n,t,e,i){let s=xU(n,t);return n.rows.map((r,o)=>{let{numbers:a,radians:c}=r,[l,h]=Jb.map(f=>a[f]*(c.has(f)?1:i)),[u,d]=mm.map(f=>dU(r,f,e));return{kind:s[o],a:u,alpha:l,d,theta:h}})}var pm=({kind:n})=>n==="unknown",gU=({rows:n},t,e)=>t.length>0&&e>=t.length&&n.every(pm);function Xb(n,t,{rows:e}){let i=e.flatMap((s,r)=>t(s,r)?[r+1]:[]);return i.length?[at(n,{rows:ig(i)})]:[]}function xU({rows:n},t){return n.every(pm)?n.map((e,i)=>t[i]??(t.length?"fixed":"revolute")):n.map(e=>pm(e)?"fixed":e.kind)}var jb={kind:"fixed",a:0,alpha:0,d:0,theta:0},Yb=n=>n.kind==="fixed"&&Ht.every(t=>n[t]===0);function _U(n){let t=n.map((i,s)=>{let{a:r,alpha:o}=n[s+1]??jb;return{...i,a:r,alpha:o}});t.length>1&&Yb(t.at(-1))&&t.pop();let e={...jb,a:n[0].a,alpha:n[0].alpha};return Yb(e)?t:[e,...t]}function tw(n,{assumptions:t,length:e,angle:i}){let{rows:s,order:r=[],convention:o}=n,a=r.map(m=>yU[m]).join(" "),c=oy(e),l=s.some(m=>mm.some(g=>gm(m,g)!==0&&!m.metres.has(g))),h=Kb(n).some(Boolean),u=[...a?[at("taken: columns",{columns:a})]:[],at(o==="craig"?"taken: craig":"taken: standard"),...l?[at("taken: lengths",{unit:c})]:[],...h?[at(i===1?"taken: radians":"taken: degrees")]:[]],d=["taken: millimetres","taken: degrees","taken: craig"].map(m=>at(m)),f=at("taken: columns",{columns:r.join(" ")}),p=t.filter(m=>m!==f&&!d.includes(m));return[...u,...p].join("; ")}var yU={a:"a",alpha:"α",d:"d",theta:"θ"};function iw(n){let t=e=>e.every((i,s)=>kn(i)===(s===3?1:0));return n.length%4>0||!n.every((e,i)=>i%4!==3||t(e))?null:Array.from({length:n.length/4},(e,i)=>n.slice(4*i,4*i+4))}function sw(n,t,e){let i=t.map(m=>m.map(g=>ui(g,`A_${n}`))),s=[...As(["all",...i.flat()])].filter(m=>!e.has(de(m))),r=m=>{let g=x=>s.includes(x)?vU(x,m):e.get(de(x));return i.map(x=>x.map(_=>Fn(_,g)))},[o,a]=[r(0),r(.5)],c=xm(o),l=a[2][3]-o[2][3],h=Math.abs(l)>1e-9,u=Math.sin(Math.atan2(a[1][0],a[0][0])-c.theta),d=Object.fromEntries(Ht.map(m=>[m,_i(c[m],6)]));ew(n,o,c),ew(n,a,c);let f=h?"prismatic":s.length?"revolute":"unknown",p=l+u<0;return{kind:f,numbers:c,texts:d,backwards:p,radians:new Set,metres:new Set}}function vU(n,t){let e=/^([cs])_?\d+$/i.exec(n);return e?e[1].toLowerCase()==="c"?Math.cos(t):Math.sin(t):t}var bU=.02,xm=n=>({a:n[0][3]*n[0][0]+n[1][3]*n[1][0],alpha:Math.atan2(n[2][1],n[2][2]),d:n[2][3],theta:Math.atan2(n[1][0],n[0][0])}),wU=[["theta","","","a"],["theta","","","a"],["","alpha","alpha","d"]],rw=([n,t])=>wU[n]?.[t]??"",Xa=class extends xt{constructor(t,e={}){super(at(t,e)),this.causes=t.includes(".")?[t]:[]}};function ew(n,t,e){let i=nw(t,e);if(!i)return;let s=t.map((o,a)=>o.map((c,l)=>l<3?t[l][a]:c)),r=nw(s,xm(s))?"no link matrix":"table.transposed";throw new Xa(r,{i:n,row:i[0],column:i[1]})}function nw(n,{a:t,alpha:e}){let{d:i,theta:s}=xm(n),[r,o,a,c]=[s,e].flatMap(u=>[Math.cos(u),Math.sin(u)]),l=[[r,-o*a,o*c,t*r],[o,r*a,-r*c,t*o],[0,c,a,i]],h=Math.max(1,Math.abs(t));for(let[u,d]of l.entries())for(let[f,p]of d.entries())if(Math.abs(n[u][f]-p)>bU*h)return[u+1,f+1];return null}var ym="part of a name",MU=/(?:[\p{L}_]\{?|(?<!\p{L})(?:q|θ|theta)[[(])$/u;function vm(n,t){let e=t.slice(Math.max(0,n.from-7),n.from);return MU.test(e)?_m(n,"label",ym):n}var _m=({text:n,from:t,to:e,line:i},s,r=void 0)=>({text:n,from:t,to:e,line:i,owner:s,reason:r});function ow(n,{cells:t,headers:e,isTurned:i=!1},s,r){let o=SU(e,s.order),a=c=>s.isExchanged?Fu[c]??c:c;return n.map(c=>{if(c.owner!=="entry")return c;let[l,h]=i?[c.column,c.row]:[c.row,c.column],d=(t[l].length===s.order.length?s.order:o).map(a),f=h-(t[l].length-d.length),p=Ht.indexOf(d[f]==="offset"?EU(s,l):d[f]);return p>=0?vm({...c,row:l,column:p},r):f in e&&d[f]===void 0?_m(c,"context",`column ${e[f].trim()}`):_m(c,"label")})}function SU(n,t){let e=Bu(n);return e?.filter(s=>Ht.includes(s))?.join()===t.join()?e:t}var EU=({rows:n},t)=>n[t].kind==="prismatic"?"d":"theta",bm=(n,t)=>n.map(e=>{if(e.owner!=="entry")return e;let[i,s]=[Math.floor(e.row/4),[e.row%4,e.column]],r=Ht.indexOf(rw(s));return vm({...e,row:i,matrix:s,column:r<0?void 0:r},t)});function aw(n,t,{sources:e,parts:i}){let s=new $a(t);for(let{from:r,to:o,row:a,column:c}of e)s.claim(n.span(r,o),"entry",{row:a,column:c});for(let{from:r,to:o}of i)s.claim(n.span(r,o),"label",{reason:"not an entry of the table"});for(let r of s.list)r.owner||Object.assign(r,{owner:"context",reason:"outside the table"});return s.list.map(r=>r.owner==="context"?r:vm(r,t))}var TU="value of a symbol",Wu=String.raw`(?:\d+(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?`,AU=String.raw`\d+,\d+`,RU=String.raw`\p{L}(?:_?\{?\w{1,4}\}?|[₀-₉]{1,2})?`,CU=String.raw`_\{?(?!\d{1,2}(?!\w))\w{1,4}\}?`,fo=String.raw`\p{L}{1,3}(?:_?\{?\d{1,2}\}?|[₀-₉]{1,2}|${CU})`,IU=new RegExp(`^${fo}$`,"u"),PU=String.raw`\\?sqrt[ ]?[({]${Wu}[)}]`,cw=`(?:${PU}|${AU}|${Wu}|${fo})`,LU=String.raw`(?:[ ]?[-+*/·×∗][ ]?|\s*=\s*[-+]?)`,NU=`[-+]?${cw}(?:${LU}${cw}){0,20}`,DU=String.raw`[ \t]*(?:([[(])[ ]?(?:in )?)?(${we})(?![\p{L}\p{N}])[ ]?[\])]?`,uw=String.raw`(?![\p{L}\p{N}°(]|[.,]\d|[ ]?[-+*/^=·×∗⋅%]|[ ]+(?:x[ ])?[.\d]|`+String.raw`[ ]*\([^()\n]{0,40}\)[ ]*[-+*/^·×∗⋅])`,OU=String.raw`(?=[ \t]*(?:,(?!\d)|[;)\]}$]|\.?[ \t]*$))`,dw=String.raw`["'$]*\s*:?={1,2}\s*`,UU=String.raw`["'$]*[ ]*(?:->|:(?!=))[ ]*`,$u=String.raw`(?<![\p{L}\p{N}_.\\])`,lw=`(${NU})(?:${DU})?`,FU=[new RegExp(`${$u}(${RU})(${dw})${lw}${uw}`,"gu"),new RegExp(`${$u}(${fo})(${UU})${lw}${OU}`,"gmu")],kU=String.raw`\(?${fo}(?:[ ]?,[ ]?${fo}){1,9}\)?`,BU=String.raw`[[(]?-?${Wu}(?:[ ]?,[ ]?-?${Wu}){1,9}[\])]?`,zU=String.raw`(?![ ]*[\])]|[ ]*[[(]?(?:mm|cm)(?!\p{L})|[ ]*;[ ]*[.\d])`,GU=new RegExp(`(?<![=+*/-][ ]?)${$u}(${kU})(${dw})(${BU})${uw}${zU}`,"gu"),VU=new RegExp(String.raw`(?<![=+*/-][ ]?)${$u}${fo}\$?[ ]?,[ ]?\$?$`,"u");function fw(n,t=new Map){let e=hw(Zn(n)),i=Cu(n),s=i?hw(i):e,r=new Set(s.map(({name:a})=>de(a))),o=[...s,...e.filter(({name:a})=>!r.has(de(a)))];return o.flatMap(({unit:a,...c})=>{let l=pw(c.value,a,o,t);return l===null?[]:[{...c,length:l}]})}function hw(n){let{text:t}=n,e=(r,o,a,c,{0:l,index:h})=>{let{from:u,to:d}=n.span(h,h+l.length),f=n.span(c,c+1).from;return{from:u,to:d,name:Ce(r),text:l.trim(),valueFrom:f,value:o,unit:a}},i=FU.flatMap(r=>[...t.matchAll(r)]).flatMap(r=>{let[,o,a,c,l,h]=r;if(VU.test(t.slice(Math.max(0,r.index-12),r.index)))return[];let u=r.index+o.length+a.length,d=t.lastIndexOf(`
`,r.index),f=c.split("=").map(g=>g.trim()),p=g=>IU.test(g)&&g!==f.at(-1),m=f.filter(g=>!p(g)).join("=");return[o,...f.filter(p)].map(g=>({...e(g,m,h,u,r),lineStart:d,isBracketed:!!l}))}),s=[...t.matchAll(GU)].flatMap(r=>{let[,o,a,c]=r,[l,h]=[o,c].map(d=>d.replace(/[()[\]]/g,"").split(",")),u=r.index+o.length+a.length;return l.length!==h.length?[]:l.map((d,f)=>e(d.trim(),h[f],void 0,u,r))});return[...HU(i),...s]}function HU(n){let t=new Map;for(let e of n.filter(({isBracketed:i})=>i))t.set(e.lineStart,[...t.get(e.lineStart)??[],e]);return n.map(({isBracketed:e,lineStart:i,...s})=>{let r=({from:a})=>a>s.from,o=s.unit??t.get(i)?.find(r)?.unit;return{...s,unit:o}})}var WU=50;function pw(n,t="m",e,i,s=new Map){let r=l=>{let h=de(l),u=e.find(m=>de(m.name)===h);if(!u)return i.get(h);if(s.size===WU||s.has(h))return s.get(h);s.set(h,void 0);let{value:d,unit:f}=u,p=pw(d,f,e,i,s);return s.set(h,p??void 0),p??void 0},o=n.split("=").map(l=>{let h=ei(()=>ui(l.replace(/(\d),(\d)/g,"$1.$2"))),u=h&&t!=="m"&&As(h).size>0;return h&&!u?ei(()=>Fn(h,r)):null}),a=o.at(-1);return o.every(l=>l!==null&&Math.abs(l-a)<$U)?ru(a,fi[t]):null}var $U=1e-9;function mw(n,t){let e=i=>Me(i)?t.has(de(i)):!Qn(i);return n.filter(({name:i})=>e(i)).map(({name:i,length:s})=>[i,s])}function gw(n,t,e){let i=({from:a,to:c})=>e.some(l=>l.owner==="entry"&&l.from>=a&&l.to<=c),s=n.filter(a=>!i(a)),r=new Set,o=a=>{let c=a.flatMap(u=>di(u)??[]).map(de),l=c.some(u=>!r.has(u));c.forEach(u=>r.add(u));let h=s.filter(({name:u})=>r.has(de(u)));return l?o(h.map(({value:u})=>u)):h};return o(t)}function xw(n,t,e){for(let i of n){let s=n.find(({name:u,length:d})=>de(u)===de(i.name)&&d!==i.length);if(!s)continue;let r=yw([i,s],t,{owner:"unread"}),o=({text:u,from:d})=>({quoted:ee(u),line:e.slice(0,d).split(`
`).length}),[a,c]=[i,s].map(o),l={name:i.name,one:a.quoted,line:a.line},h={other:c.quoted,otherLine:c.line,what:at("your table")};throw new xt(at("two lengths",{...l,...h}),[],r,e)}}var _w=(n,t)=>yw(n,t,{owner:"label",reason:TU}),yw=(n,t,e)=>t.map(i=>{let s=n.find(({from:h,to:u})=>i.from>=h&&i.to<=u);if(!s)return i;let{text:r,from:o,to:a,line:c}=i,l=o<s.valueFrom?{owner:"label",reason:ym}:e;return{text:r,from:o,to:a,line:c,...l}});function vw(n){let[t,e]=[[],[]];for(let i=0;i<n.length;i++){let s=n[i];"[({".includes(s)?e.push({from:i,open:s,hasSign:!1,isOuter:!1}):"=:".includes(s)&&e.length>0&&(e.at(-1).hasSign=!0);let r="[({"["])}".indexOf(s)],o=r?e.findLastIndex(({open:a})=>a===r):-1;if(o>=0){let[{from:a,open:c,hasSign:l,isOuter:h}]=e.splice(o),u=n.slice(Math.max(0,a-40),a);e.length&&(l||h)&&(e.at(-1).isOuter=!0);let[d,f]=[a+1,n.slice(a+1,i)];t.push({from:a,to:i+1,open:c,before:u,body:f,start:d,hasPairs:l&&!h})}}return t.sort((i,s)=>i.from-s.from)}function ja(n,t){let e=n.trim().replace(/^['"]+|['"]+$/g,""),i=t+n.indexOf(e);return{text:e,spans:[{from:i,to:i+e.length}]}}var Us=n=>({text:n,spans:[]});function Ya(n,t){let e=/[,;\n]/.test(n.trim())?/[^,;\n]+/g:/\S+/g;return[...n.matchAll(e)].map(({0:i,index:s})=>ja(i,t+s)).filter(({text:i})=>i)}var qU=String.raw`_?[({]?(?:i(?: ?- ?1)?|(\d{1,2})|deg|rad|${we})?[)}]?`,XU=new RegExp(String.raw`['"]?(?<![A-Za-zαθ/])([A-Za-zαθ]+${qU})['"]?\s*[:=]\s*`,"g"),jU=new RegExp(String.raw`[:=]\s*["']?(?:${we}|deg|rad)\w*["']?\s*$`),YU=n=>n.split(",").every(t=>jU.test(t));function bw(n,t){let e=t.filter(({open:f,before:p,hasPairs:m,body:g})=>m&&(f==="{"||p.endsWith("dict"))&&!YU(g)),i=e.length>0,s=i?e:JU(n),r=s.map(ww),o=nF(r.flat()),a=ZU(s,o?r.map(f=>f.map(iF)):r,i),c=KU(a);if(!c)return null;let l=c.map(({pairs:f},p)=>tF(f,p+1));(c.some(({pairs:f})=>f.some(({index:p})=>p!==void 0))||!i)&&eF(l);let u=l.some(f=>f.has(qu))?[...Ht,qu]:Ht,d={rows:l.map((f,p)=>u.map(m=>f.get(m)?.entry??sF(m,p+1))),headers:u.map(f=>l[0].get(f)?.name??f),parts:c.flatMap(({parts:f})=>f)};return o?{...d,convention:"craig"}:d}function JU(n){let t=Ii(n).map(r=>({...r,body:r.text,start:r.from})),e=t.map(r=>ww(r).map(({index:o,column:a})=>o??a)),i=[],s=[];for(let[r,o]of t.entries())if(e[r].length>0&&e[r].every(c=>Ht.includes(c))&&s.length>0&&!e[r].some(c=>s.includes(c))){let{from:c}=i.at(-1);i[i.length-1]={from:c,to:o.to,body:n.slice(c,o.to),start:c},s.push(...e[r])}else i.push(o),s=[...e[r]];return i}function ZU(n,t,e){let i=new Map;return n.forEach((s,r)=>{let o=e&&s.body.match(/[:=]/g)?.length===t[r].length;for(let a of t[r]){let c=o&&!a.index?1:3,l=i.get(a.index??r)??{pairs:[],parts:[],body:s,fewest:c};i.set(a.index??r,l),l.pairs.push(a),l.parts.push({from:s.from,to:s.to})}}),i}function KU(n){let t=[...n].filter(([,{pairs:r,fewest:o}])=>QU(r)>=o);if(t.length<2)return null;let e=t.every(([r])=>typeof r=="string"),i=[...n].filter(([r])=>typeof r=="string");return(e?i.sort(([r],[o])=>Number(r)-Number(o)):t).map(([,r])=>r)}var qu="offset",QU=n=>new Set(n.map(({column:t})=>t)).size;function tF(n,t){let e=n.some(({name:s})=>s==="d"),i=new Map;for(let s of n){let r=e&&s.name===qu?qu:s.column,o=i.get(r)?.entry.text;if(o!==void 0&&o!==s.entry.text){let a=[o,s.entry.text].map(ee),c={row:t,name:r,one:a[0],other:a[1]};throw new xt(at("row two values",c))}i.set(r,s)}return i}function eF(n){for(let t of Ht){let e=n.findIndex(i=>!i.has(t));if(e>=0&&n.some(i=>i.has(t)))throw new xt(at("row lacks",{row:e+1,name:t}))}}var wm=({column:n})=>n==="a"||n==="alpha";function nF(n){let t=i=>Math.min(...i.map(({index:s})=>Number(s??1/0))),e=n.filter(i=>!wm(i));return t(n.filter(wm))===0&&t(e)===1}var iF=n=>wm(n)&&n.index!==void 0?{...n,index:String(Number(n.index)+1)}:n;function ww({body:n,start:t}){let e=[...n.matchAll(XU)];return e.flatMap(({0:i,1:s,2:r,index:o},a)=>{let c=o+i.length,[l]=n.slice(c,e[a+1]?.index).split(/,(?!\d)|[;[]/),h=ja(l,t+c),u={...h,text:h.text.replace(/(?<=\d),(?=\d)/g,".")},d=Me(s.replace(/\d+/,""));return!Ht.includes(d)||!u.text?[]:[{column:d,name:r?d:s,index:r,entry:u}]})}var sF=(n,t)=>Us(n==="theta"?`q_${t}`:"0");var rF=/(?<!\p{L})(?:(?:DH)?Link|DHParam|(?:Revolute|Prismatic)[\p{L}\d_]*)\s*$/u;function Sw(n,t){let e=t.flatMap(s=>{let r=s.open==="("?rF.exec(s.before):null;return r?[hF(r[0],s)]:[]});if(!e.length)return null;let i={rows:e.map(({values:s,slides:r},o)=>{let a=r?"d":"theta",c=oF(o+1,a,s[a],s.offset);return Ht.map(l=>l===a?c:s[l]??Us("0"))}),headers:Ht,parts:e.map(({part:s})=>s),assumptions:[at("taken: links")],unread:e.map(({unread:s})=>s).find(Boolean)};return e.some(({call:s})=>cF.test(s))?{...i,convention:"craig"}:i}function oF(n,t,e=Us("0"),i=Us("0")){let s=[...e.spans,...i.spans];if(aF(e.text))return{text:`${e.text} + (${i.text})`,spans:s};if(!kn(e.text))return{text:`q_${n} + (${i.text})`,spans:s};if(kn(i.text)!==0){let[r,o]=[e,i].map(({text:a})=>ee(a));throw new xt(at("row two values",{row:n,name:t,one:r,other:o}))}return{text:`q_${n} + (${e.text})`,spans:s}}var aF=n=>Qn(n)&&!Os.test(Ce(n)),cF=/MDH\b|\bmodified\b|\bmdh['"]?\s*[=,]\s*[T1]/,Mw=["d","a","alpha","offset"],lF=["theta","d","a","alpha","sigma","offset"],Mm=/['"]?(?<![\p{L}\p{N}_])(a|alpha|d|theta|offset|sigma)['"]?\s*[,=]\s*([^,]+)/gu;function hF(n,{body:t,start:e,from:i,to:s}){let r=`${n}(${t})`,o=fF(t,e)??pF(t,e)??mF(n,t,e),a=Object.fromEntries(o.map(h=>[h.name,h.entry])),c=kn(a.sigma?.text??"0");if(""in a||c!==0&&c!==1)throw new xt(at("link sigma",{given:ee(r)}));let l=r.toLowerCase().includes("prismatic")||c===1;return{values:a,slides:l||!!(a.theta&&!a.d),call:r,part:{from:i-n.length,to:s},unread:t.search(Mm)<0?void 0:dF(t,e)}}var uF=new RegExp(String.raw`['"]?(?<![\p{L}\d_])(?:[mrIGB]|Jm|Tc|qlim|name|mdh|joint_?type)['"]?\s*[,=]\s*`+String.raw`(?:\[[^\]]*\]|[^,]+)|`+String.raw`['"]?(?<![\p{L}\d_])(?:revolute|prismatic|standard|modified)(?![\p{L}\d_])['"]?`,"giu");function dF(n,t){let e=o=>" ".repeat(o.length),i=n.replace(Mm,e).replace(uF,e),[s]=/[^\s,][^,]*[\p{L}\d][^,]*/u.exec(i)??[],r=t+i.indexOf(s??"");return s===void 0?void 0:{from:r,to:r+s.length}}var Sm=(n,t)=>({name:n,entry:t});function fF(n,t){let[,e]=/^\s*\[([^\]]*)/.exec(n)??[],i=e?Ya(e,t+n.indexOf(e)):[];return i.length?i.map((s,r)=>Sm(lF[r]??"",s)):null}function pF(n,t){let e=[...n.matchAll(Mm)].map(({0:i,1:s,2:r,index:o})=>{let a=t+o+i.length;return Sm(s,ja(r,a-r.length))});return e.length>0?e:null}function mF(n,t,e){let i=Ya(t,e).filter(({text:r})=>!r.includes("=")),s=/prismatic/i.test(n)?["theta",...Mw.slice(1)]:Mw;if(!/^(?:revolute|prismatic)/i.test(n)||i.length>s.length)throw new xt(at("link order",{given:ee(`${n}(${t})`),call:n.trim()}));return i.map((r,o)=>Sm(s[o],r))}var gF=500,xF=600,_F=/(?<![\p{L}\d_.]|_\{)\d/gu;function Ew(n,t,{what:e,wanted:i}){let s=n.match(_F)?.length??0;if(s>t+gF)throw new xt(at("many numbers",{what:e,count:s,wanted:i}));let r=Zi(n).length;if(r>Math.max(t,xF))throw new xt(at("many lines",{what:e,count:r,wanted:i}))}var Xu=32;function Tw(n){let t=n.replace(/[“”„‟‘’]/g,'"'),e=vw(t),i=Sw(t,e)??bw(t,e)??SF(t,e);if(!i)return null;let{rows:s,headers:r,parts:o,assumptions:a=[],convention:c}=i;ju(s.length);let l=ku(r),h=s.flatMap((p,m)=>p.flatMap(({spans:g},x)=>{let _=Ht.indexOf(l[x]);return g.map(b=>({...b,row:m,column:_}))})),u=s.map(p=>p.map(m=>m.text)),d=i.unread??bF(t,o),f=wF(t,o);return{cells:u,headers:r,assumptions:a,sources:h,parts:o,unread:d,convention:c,context:f}}var yF=/(?<!\S)(?:#|%|\/\/).*|(?:joint|link|row):? ?\d+|^\s*\d+[.:)]|[\p{L}_]\w*(?:[[({]\d+[\])}])?/gimu,vF=new RegExp(String.raw`(?:\.(?:a|d|alpha|theta|offset|tool|base)|(?<![\w.])(?:a|r|d|alpha|theta|offset)`+String.raw` ?[[(]\d{1,2}[\])]) ?=(?!=)[^\n]*[1-9π]|^[ \t]*(?:tool|base):[ \t]*\n[^\n]*[1-9π]`,"gm");function bF(n,t){let e=({from:f})=>t.every(p=>f<p.from||f>=p.to),i=[...n.matchAll(vF)].map(({0:f,index:p})=>({from:p,to:p+f.length})).find(e);if(i)return i;let s=[...t].sort((f,p)=>f.from-p.from),r=n.lastIndexOf(`
`,s[0].from)+1,o=`${n}
`.indexOf(`
`,s.at(-1).to),a=[r,...s.map(({to:f})=>f)],c=[...s.map(({from:f})=>f),o].map((f,p)=>({from:a[p],to:f})),l=({from:f,to:p})=>/\d/.test(n.slice(f,p).replace(yF,"")),h=c.find(l);if(!h)return null;let u=n.slice(h.from,h.to).replace(/^[\s,;)]+|[\s,;]+$/g,""),d=n.indexOf(u,h.from);return{from:d,to:d+u.length}}function wF(n,t){let e=({from:s,to:r})=>t.some(o=>o.from<r&&o.to>s);return Ii(n).filter(s=>!e(s)).map(s=>s.text.trim()).join(`
`)}var MF=/([\p{L}_][\p{L}\p{N}_]*)['"]?\s*[=:]\s*(?:(?:np\.array|Matrix)?\s*\(\s*)?$/u;function SF(n,t){let e=t.flatMap(({open:o,before:a,body:c,start:l,from:h,to:u})=>{let d=o==="("?null:MF.exec(a);if(!d)return[];let f={from:h-d[0].length,to:u};return[{column:EF(d[1]),entries:Ya(c,l),part:f}]});if(e.length<3||!e.every(({column:o})=>Ht.includes(o)))return null;let i=new Map(e.map(({column:o,entries:a})=>[o,a]));TF(e);let s=[...new Set([...i.values()].map(({length:o})=>o))];if(s.length!==1)throw new xt(at("uneven lists",{counts:s.sort((o,a)=>o-a).join(", ")}));let r={rows:Array.from({length:s[0]},(o,a)=>[...i.values()].map(c=>c[a])),headers:[...i.keys()],parts:e.map(({part:o})=>o)};return i.has("theta")?r:AF(r,i.get("d"))}function EF(n){return[n,...n.split("_")].map(Me).find(e=>Ht.includes(e))??""}function TF(n){let t=new Map;for(let{column:e,entries:i}of n){let s=i.map(({text:o})=>o).join(", "),r=t.get(e)??s;if(r!==s){let o={name:e,one:ee(r),other:ee(s)};throw new xt(at("two lists",o))}t.set(e,s)}}function AF(n,t){let e=t.map(({text:i},s)=>Us(Qn(i)?"0":`q_${s+1}`));return{...n,rows:n.rows.map((i,s)=>[...i,e[s]]),headers:[...n.headers,"theta"],assumptions:[at("taken: no theta")]}}function ju(n){if(n>Xu)throw new xt(at("many rows",{count:n,most:Xu}))}var RF=1e5,CF=16;function Aw(n){let t=at("your table");if(n.length>RF)throw new xt(at("too long",{what:t,count:n.length}));if(!n.trim())throw new xt(at("empty",{what:t}));let e=at("table size",{most:Xu});Ew(n,Xu*CF,{what:t,wanted:e})}var IF=/^(?:\?+|…|⋮|\.{2,}|\\[lcdv]?dots|tbd|todo|nan|none|null|xx+)$/i,PF=/^[-–—_]+$/,LF=n=>IF.test(n),Rw=n=>LF(n)||PF.test(n);var Rq=new RegExp(String.raw`(?<![\p{L}\p{M}\d_])(\p{L}[\p{L}\p{M}_{}]{0,12}[\d₀-₉]{1,2}\}?) ?[=:] ?`+String.raw`((?:[-+−–] (?=[\d.]))?[^\s,;|&$)}\]]*)`,"gu");var Pw=String.raw`(?:\p{L}+[ _]*)?\d{1,2}[.):]?`,NF=new RegExp(String.raw`^[ \t|&,]*${Pw}(?=[ \t|&,;])`,"u"),DF=/\\\\[ \t]*$/,OF=String.raw`\$?\\?\p{L}+_?\{?[\d₀-₉]{1,2}\}?\$?`,Cw=new RegExp(String.raw`^[ ]*\|?(?:[ ]*${Pw}[ ]*)?(?:[|&\t;][ ]*){3,}${OF}[ ]*\|?(?:\\\\)?[ \t]*$`,"u"),UF=/[|&;\t][ ]*(?=[|&;\t])/;function Iw(n){let e=n.replace(NF,"").replace(DF,"").split(/[ \t|&,;]+/).filter(Boolean);return e.length>0&&e.every(Rw)}function Lw(n){let t=n.split(`
`),e=t.findLastIndex(r=>/\d/.test(r)&&!Iw(r)&&!Cw.test(r));if(e<0)return n;let i=t.slice(0,e+1).some(r=>/\d/.test(r)&&UF.test(r)),s=r=>Iw(r)||!i&&Cw.test(r);return t.map((r,o)=>o>e&&s(r)?r.replace(/./g," "):r).join(`
`)}var Nw=2,FF=3,Dw="·";function Ow(n,t,e){let{sources:i}=n.block;return zF(t,i)??$F(t,i)??qF(t,i)??kF(n,t,e)}function kF(n,t,e){let{block:i,plainLines:s}=n,{sources:r}=i,o=tk(i,e),a=m=>/[\p{L}\d]/u.test(s[m]),c=m=>ik(n,m),l=[...o.keys()].filter(m=>a(m)&&!c(m)).sort((m,g)=>m-g),h=JF(l,n),u=new Map(r.map(({line:m,cells:[g]})=>[m,g.from])),d=Fw(s[r[0].line]),f=Ii(t),p=ok(t,r);for(let m of l){let[g,x]=[o.get(m),s[m]],[_]=[...g.candidates,...g.words],b=KF(g,p,t);if(b)return{line:m,cell:b};if(u.has(m)){let M=YF(g,m,u.get(m));if(M)return M}else if(h(m)){if(!ck(x,r)&&rk(g,x)||Bw(x,d))return{line:m,cell:_};if(BF(f[m].text,x,d))return{line:m,cell:f[m]}}}return null}var BF=(n,t,e)=>!t.includes(Dw)&&Bw(n,e);function zF(n,t){for(let{line:e,cells:i}of t)for(let[s,{from:r,to:o}]of i.entries()){if(r===o)continue;let a=n.slice(Math.max(i[s-1]?.to??0,r-GF),r),c=WF.exec(a.replace(VF,HF));if(c)return{line:e,cell:{from:r-c[0].length,to:o}}}return null}var GF=20,VF=/\\h?phantom\{[^}]*\}|-+>/g,HF=n=>" ".repeat(n.length),WF=/\S*[-−–—][^\p{L}\d\n|&;,\t-]*$/u;function $F(n,t){let e=t.flatMap(({line:r,cells:o})=>o.map(a=>({line:r,cell:a,entry:n.slice(a.from,a.to)}))),i=({entry:r})=>jF.test(r);return e.some(r=>/\d,\d/.test(r.entry)&&!i(r))?void 0:e.find(i)}function qF(n,t){for(let{line:e,cells:i}of t)for(let s of i){let[,r]=XF.exec(n.slice(s.from,s.to))??[];if(Number(r)>Hu)return{line:e,cell:s}}return null}var XF=/^[-+−]?\s*([\d.]+)\s*rad/,jF=/^[-+−]?[1-9]\d{0,2},\d{3}(?![\d,])/;function YF({rows:n,words:t,candidates:e},i,s){let r=e.find(({from:o})=>o>s);return!r&&!n.some(ZF)?null:{line:i,cell:r??e[0]??t[0]}}function JF(n,{block:{firstLine:t,lastLine:e},isTurned:i}){if(i)return()=>!1;let s=n.findLast(o=>o<t)??t,r=n.find(o=>o>e)??e;return o=>o>=s&&o<=r}var ZF=({cells:n,name:t})=>n.length>=Nw&&!t,KF=({words:n},t,e)=>t&&n.find(i=>ak(i,t)&&!QF(i,e)),QF=({to:n},t)=>/^\s*=/.test(t.slice(n,n+9));function tk({sources:n,lines:t},e){let i=new Map,s=o=>(i.has(o)||i.set(o,{rows:[],words:[],entries:[],candidates:[]}),i.get(o)),r=new Set(n);for(let o of t.all)r.has(o)||(s(o.line).rows.push(o),s(o.line).entries.push(...o.cells));for(let o of t.words){if(o.line===void 0||Iu(o.text))continue;let{words:a,candidates:c}=s(o.line);o.text.startsWith(Dw)||(a.push(o),(e(sk(o.text))||/\d/.test(o.text))&&c.push(o))}return i}var ek=/(?<![\p{L}\d_\\])\p{L}{3,}(?![\p{L}\d_(])/gu,nk=3,ik=({headers:n,block:t,plainLines:e},i)=>!n.length&&i<t.firstLine&&!/\d/.test(e[i]),sk=n=>n.replace(/^[^\p{L}\d.+-]+|[^\p{L}\d]+$/gu,""),Uw=n=>(n.match(ek)??[]).length>=nk;function rk({entries:n,words:t,candidates:e},i){let s=n.length+e.length;return!Uw(i)&&s>=Nw&&2*s>=n.length+t.length}var Fw=(n="")=>kw.map(t=>n.trim().split(t).length-1),kw=["|","&","	",";",",",/ {2,}/];function Bw(n,t){let e=Fw(n),i=t.findIndex(s=>s>=FF);return kw[i]===","&&Uw(n)?!1:i>=0&&e[i]===t[i]}function ok(n,t){let[e,i]=[t[0].cells[0].from,t.at(-1).cells.at(-1).to];return["[]","{}"].flatMap(([r,o])=>{let a=[];for(let c=0;c<n.length;c++)if(n[c]===r)a.push(c);else if(n[c]===o&&a.length){let l=a.pop();if(l<e&&c>=i)return[{from:l,to:c}]}return[]})[0]??null}var ak=({from:n,to:t},e)=>n>=e.from&&t<=e.to,ck=(n,t)=>/^[^=:]*\p{L}[^=:]*[=:]/u.test(n)&&(n.split("=").length>2||!t.some(({name:e})=>e)),lk=new RegExp(String.raw`^ ?(?:(${we})|rad|deg|°)(?![\p{L}\p{N}])`,"u");function zw({tokens:n,isOrderGuessed:t},e){for(let i of t?[]:n){let[s,r]=lk.exec(e.slice(i.to,i.to+9))??[];if(s===void 0||i.owner!=="entry"||["a","d"].includes(Ht[i.column])===(r!==void 0))continue;let a={from:i.from,to:i.to+s.length};pr(e,n,a,at("your table"))}}function hk(n,t={},e=[]){Aw(n),fk(n);let i=Lw(n),s=new Map(e.map(([h,u])=>[de(h),u])),r=fw(Kp(new Ns(i)),s),o=mw(r,new Set(e.map(([h])=>de(h)))),a=new Map(o.map(([h,u])=>[de(h),u])),c={options:t,known:new Map([...s,...a])},l=dk(i,c);return Ob(l,i).map(h=>uk(h,r,i))}function uk(n,t,e){let{tokens:i,typedCells:s}=n;yk(n,e),zw(n,e);let r=gw(t,s,i);return xw(r,i,e),n.order&&nb(e,n,t),{...n,otherUnit:Fb(i,e),tokens:_w(r,i)}}function dk(n,t){let{known:e}=t,i=qb(n,Vu(e)),s=Cv(Kp(new Ns(i))),r=Cu(s);for(let a of[r,s]){let c=a&&Tw(a.text);if(!c)continue;let l=aw(a,i,c),{unread:h}=c;if(h){let u=a.span(h.from,h.to);pr(i,l,u,at("your table"))}return Hw(c,t).map(u=>({...u,tokens:l}))}let o=a=>pk(i,Vb(i,e,a),t);return(r&&ei(()=>o(r)))??o(s)}function fk(n){let t=ay(n);if(t)throw new xt(at("other unit",{what:at("your table"),unit:t}))}function pk(n,t,e){let i=null,s=0;for(let r of t){if(r.cells.length<s)break;let o=[];try{o=gk(r,n,e);let a=mk(r)?[at("taken: empty")]:[];return Hw({...r,assumptions:a},e).map(c=>({...c,tokens:c.order?ow(o,r,c,n):bm(o,n)}))}catch(a){if(!(a instanceof xt))throw a;if(a instanceof Xa)throw a.tokens=bm(o,n),a;i??=a,a.tokens&&(s||=r.cells.length)}}throw i??new xt(at("no rows",{given:ee(n)}))}var mk=({block:{sources:n}})=>n.some(({cells:t})=>t.some(({from:e,to:i})=>e===i));function gk(n,t,{known:e}){let i=Wv(t,n.block),s=at("your table"),r=Ow(n,t,Vu(e));if(r?.cell&&pr(t,i,r.cell,s),r)throw xk(n,_k(n,r.line),i,t);return Kv(t,i,s),i}function xk({block:{lines:n,rows:t}},e,i,s){let r=n.all.filter(({line:a})=>a===e).flatMap(({cells:a})=>a),o={line:ee(Zi(s)[e].trim()),count:r.length,entries:Je(r.map(a=>ee(s.slice(a.from,a.to)))),width:t[0].length};return new xt(at("row torn",o),[],i,s)}function _k({block:{lines:n,firstLine:t,rows:e}},i){let s=n.all.find(({line:o})=>o===i)?.cells.length??0;return n.all.filter(({cells:o})=>o.length===s).length>e.length?t:i}function yk({rows:n,tokens:t},e){let i=n.length/2,s=n.map(({joint:o})=>o?.number),r=(o,a)=>o!==void 0&&o===s[i+a];if(i>1&&s.slice(0,i).every(r))throw new xt(at("two tables"),[],t,e)}function Hw(n,{options:t,known:e}){let i=n.cells.map(h=>h.map(Uu)),s=i.flat(),r=iw(i);if(r){let u=s.some(f=>di(f)?.some(p=>e.has(de(p))))?"":n.context;return[{...vk(r,e,t,u),typedCells:s}]}let{cells:o,headers:a}=Cb({cells:i,headers:n.headers});ju(o.length);let c=Pb(o,a,t.columns),l=Gu({...n,headers:a},t);return bk(c,e).map(h=>({...l,...h,order:c.typedOrder??h.order,typedCells:s,assumptions:[...n.assumptions,...h.assumptions]}))}function vk(n,t,e,i){ju(n.length);let s=n.map((a,c)=>sw(c+1,a,t)),r=Gu({headers:[],context:""},e),{lengths:o}=Gu({headers:[],context:i},e);return{...r,lengths:o,rows:s,assumptions:[at("taken: matrices")]}}function bk({orders:n,isStated:t,rows:e},i){let s=n.map(c=>Gw(e,c,i,t)),r=s.filter(c=>c.rows);if(r.length)return r;let o=n[0].map(c=>Fu[c]??c),a=Gw(e,o,i,t);if(!t||!a.rows)throw s[0].error;return[{...a,isExchanged:!0}]}function Gw(n,t,e,i){try{let s=n.map((o,a)=>{let c=Object.fromEntries(t.map((l,h)=>[l,o[h]]));return wb(a+1,c,e)}),r=at("taken: columns",{columns:t.join(" ")});return{rows:s,assumptions:i?[]:[r],order:t,isOrderGuessed:!i}}catch(s){if(s instanceof xt)return{error:s};throw s}}function Ww(n,t=[]){let e=hk(n,{},t),i=e.find(Vw)??e[0];if(i.isOrderGuessed&&!Vw(i))throw new xt(at("order of columns",{taken:i.assumptions[0]}));let s=Zb(i,[]);return{rows:s.rows,reading:tw(i,s)}}var Vw=({assumptions:n})=>n.includes(at("taken: columns",{columns:"a alpha d theta"}));var wk=/[\n\t;&|]|\]\s*,|,\s*\[|\d +[-\d]/;function $w(n){try{if(!wk.test(n.trim()))return null;let{rows:t,reading:e}=Ww(n),i=zs(t);return i?{error:`${i}.`}:{rows:t,reading:e}}catch(t){if(t instanceof xt)return{error:`${t.message}.`};throw t}}var Mk="DH table",Xw=[["a","a",!1],["alpha","α",!0],["d","d",!1],["theta","θ",!0]],Sk={revolute:"turns",prismatic:"slides",fixed:"fixed"},Ek={kind:"revolute",a:.2,alpha:0,d:0,theta:0};function Tk(n,{announce:t,fit:e}){let i=R("p.error"),s=R("p.verdict"),r=Ck(),o=(b,M,T=null)=>n.dispatch({type:"editTable",rows:b,rowBefore:M,gesture:T}),a=b=>{i.textContent=b?`${b} The last good arm stays.`:"",b&&t(()=>i.textContent)},l=Pk(n,{change:o,replace:({rows:b,reading:M})=>{n.dispatch({type:"replaceTable",rows:b}),r.show(`Read with ${M}.`,n.state.arm),e()},complain:a}),h=(b,M)=>R("button",{onclick:M},b),u=h("Add a row",()=>o([...n.state.arm.rows,Ek])),d=h("Back to the first table",()=>o(n.state.base.rows)),f=R("div.row",{},u,d,Ik(n,t)),p=Rk(n),m=Ak(n,{change:o,complain:a,fit:e,reading:r});return{root:R("div.dh",{},l.root,i,r.root,f,m,s,p.root),update:(b,M)=>{l.update(b),r.update(b),p.update(b),u.disabled=b.arm.rows.length>=rc,Ot(s,O_(b,M))},summary:()=>i.textContent||[r.root.textContent,s.textContent].filter(Boolean).join(" ")}}function Ak(n,{change:t,complain:e,fit:i,reading:s}){let r=(l,h,u)=>{let d=vv(h.value,n.state.unit);e("error"in d?`${l}: this ${d.error}.`:""),!("error"in d)&&(u(bv(d.pose)),d.note&&s.show(`${l}: this pose ${d.note}.`,n.state.arm),i())},o=l=>t([...l,...n.state.arm.rows],h=>h-l.length),a=l=>t([...n.state.arm.rows,...l]),c=[qw("Base","Base: its pose in the world",o,r),qw("Tool","Tool: its pose in the last frame",a,r)];return R("details.mounts",{},R("summary",{},"Base and tool"),...c)}function qw(n,t,e,i){let s=R("input",{type:"text",spellcheck:"false",autocomplete:"off","aria-label":t,placeholder:"x, y, z, roll, pitch, yaw, or a 4 x 4 matrix",onkeydown:o=>o.key==="Enter"&&i(n,s,e)}),r=R("button",{onclick:()=>i(n,s,e)},"Add as rows");return R("div.row",{},R("span",{},t),s,r)}function Rk(n){let t=Rn("From the ghost's table to this one",[0,1],{oninput:i}),e=R("label.blend",{hidden:!0},"the ghost",t,"this table");function i(){let r=n.state.blended?.rows??n.state.arm.rows;n.dispatch({type:"blendTables",rows:r,share:Number(t.value),gesture:"blend"})}function s({arm:r,reference:o,blended:a}){e.hidden=r===o&&!a||!hc(r,o);let c=a?.share??1;t.value=String(c),oe(t,"aria-valuetext",`${Math.round(100*c)} % of the way`)}return{root:e,update:s}}function Ck(){let n=R("p.words",{hidden:!0}),t=null;return{root:n,show(e,i){t=i,Ot(n,e),n.hidden=!1},update(e){e.arm!==t&&(Ot(n,""),n.hidden=!0)}}}function Ik(n,t){let e="Copy the table",i=R("button.right",{onclick:s},e);async function s(){let r=Ig(n.state.arm),o=await dc(r);o||Fk(r,"table.tsv"),i.textContent=o?"Copied":"Saved",t(()=>`The table is ${o?"copied":"saved"}.`,!0),setTimeout(()=>i.textContent=e,1600)}return i}function Pk(n,{change:t,replace:e,complain:i}){let s=R("tr"),r=R("tbody",{onpaste:d=>Nk(d,n,{replace:e,complain:i})}),a=R("table.entries",{"aria-label":"Denavit-Hartenberg table, standard convention"},R("thead",{},s),r),c={},l=!1;function h(d,[f,p,m],g,x){let{unit:_,arm:b}=n.state,{value:M,message:T}=Rs(g,m?"angle":"length",{unit:_,whole:x});i(T&&`Row ${d+1}, ${p} ${T}.`),M!==void 0&&(l=!0,t(un(b.rows,d,{...b.rows[d],[f]:M}),void 0,`cell ${d} ${f}`),l=!1,x&&(g.value=Rc(M,m,_)))}function u({arm:d,unit:f}){let p=c.rows===d.rows||l,m=c;if(c={rows:d.rows,unit:f},p&&m.unit===f)return;let g=Lk(r);s.replaceChildren(...Dk(f)),r.replaceChildren(...d.rows.map((x,_)=>Ok(_,d,f,{change:t,typed:h}))),r.querySelector(`[data-cell="${g}"]`)?.focus({preventScroll:!0})}return{root:gr("Denavit-Hartenberg table",a),update:u}}function Lk(n){let{activeElement:t}=n.getRootNode(),e=t;return n.contains(e)?e.dataset.cell:void 0}function Nk(n,t,{replace:e,complain:i}){let s=n.clipboardData?.getData("text/plain")??"",r=$w(s);r&&(n.preventDefault(),i("error"in r?`What was pasted is not read: ${r.error}`:""),"error"in r||e(r))}var Dk=n=>[...["row","joint"].map(t=>R("th",{scope:"col"},t)),...Xw.map(([,t,e])=>{let i=R("small",{},e?` (${n==="deg"?"°":"rad"})`:" (m)");return R("th",{scope:"col"},R("i",{},t),i)}),R("th",{},R("span.hidden",{},"remove"))];function Ok(n,t,e,{change:i,typed:s}){let r=t.rows[n],o=h=>i(un(t.rows,n,{...r,kind:h,...ac})),a=ss(`Row ${n+1}, kind of joint`,Sk,o);a.value=r.kind;let c=()=>t.rows.filter((h,u)=>u!==n),l=R("button.remove",{"aria-label":`Remove row ${n+1}`,title:`Remove row ${n+1}`,disabled:t.rows.length===1,onclick:()=>i(c(),h=>h<n?h:h+1)},"×");return R("tr",{},R("th",{scope:"row"},String(n+1)),R("td",{},a),Xw.map(h=>Uk(n,h,r,{unit:e,typed:s})),R("td",{},l))}function Uk(n,t,e,{unit:i,typed:s}){let[r,o,a]=t,c=Ci(`Row ${n+1}, ${o}`,(...l)=>s(n,t,...l),{value:Rc(e[r],a,i),"data-cell":`${n+1}-${r}`});return r!==g_(e.kind)?R("td",{},c):R("td.moves",{},c,R("span",{},"+ ",Te("q",n+1)))}function Fk(n,t){let e=URL.createObjectURL(new Blob([n],{type:"text/plain"}));R("a",{href:e,download:t}).click(),URL.revokeObjectURL(e)}var Tm={};ns(Tm,{build:()=>Bk,title:()=>kk});var kk="Circle trace",jw=5;function Bk(n,{announce:t,signal:e}){let i=R("p.verdict"),s=Gk(n,t),r=Su(n,()=>xv),o=zk(n,s,()=>t(()=>i.textContent,!0)),a=Eu(n,{signal:e,makeTrace:o.draw}),c=R("div.row",{},s.labels,o.root,r.choice),l=R("div.trace",{},a.root,c,s.error,i,r.root);function h(u){Ot(i,Hk(u)),r.update(u),s.update(u.circle),a.update(u)}return{root:l,update:h,summary:()=>i.textContent}}function zk(n,t,e){let i=R("button",{onclick:()=>r()},"Draw a circle from here"),s=Sr("circle");function r(o=()=>{}){if(!t.sized())return;let{arm:a,q:c,circle:l}=n.state;s({arm:a,q:c,circle:l},({path:h,wantedPath:u})=>{n.dispatch({type:"setTrace",arm:a,circle:l,path:h,wantedPath:u}),e(),o()})}return{root:i,draw:r}}function Gk(n,t){let e=R("p.error"),r=ss("Plane of the circle",{x:"x = const",y:"y = const",z:"z = const"},u=>n.dispatch({type:"setCircle",normal:u})),a=Ci("Radius of the circle, m",(u,d)=>c(d),{class:"small"});function c(u=!0){let{value:d,error:f}=ho(a.value,"length"),p=d>0&&d<=jw,m=`“${a.value}” is no length above 0 and up to ${jw} m`,g=Pp(a,p?"":f??m,u);return Ot(e,g&&`The radius ${g}.`),g&&t(()=>e.textContent),p&&d!==n.state.circle.radius&&n.dispatch({type:"setCircle",radius:d}),p}function l(u){r.value=u.normal,e.textContent||Cs(a,hn(u.radius,4))}return{labels:[R("label",{},"Plane ",r),R("label",{},"Radius ",a," m")],error:e,sized:c,update:l}}var Vk="Play draws a circle of this radius from where the tip is now; the tool keeps its orientation.";function Hk({arm:n,trace:t,wantedPath:e}){if(!t)return Vk;if(e&&t.length<e.length)return`The whole circle is not within reach: the arm stops after ${Math.floor(100*(t.length-1)/(e.length-1))} % of it.`;let i=Zh(n,t);if(!i.length)return"All joints stay within their limits.";let s=i.length>1?"their limits":"its limit",r=`${Je(i)} would have to pass ${s} (tinted).`;return pc(r)}var Am={table:Em,pose:Up,jacobian:wp,trace:Tm,torque:kp,branches:$p,homework:Yp};function Yw(n,t,e){let i=new Map,s=t.length>1,r=t.map(f=>Wk(f,e.id));r.forEach((f,p)=>{f.addEventListener("click",()=>o(p)),f.addEventListener("keydown",m=>{let g=$k(m.key,p,t.length);g!==null&&(m.preventDefault(),o(g),r[g].focus())})});let o=f=>n.dispatch({type:"setFields",view:t[f]}),a=s?{role:"tabpanel"}:{},c=R("div.view",{id:`${e.id}-panel`,...a}),l=s?R("div.tabs",{role:"tablist","aria-label":"Views"},r):[];function h(f,p){c.replaceChildren(p.root),s&&c.setAttribute("aria-labelledby",`${e.id}-${f}`),r.forEach((m,g)=>{m.setAttribute("aria-selected",String(t[g]===f)),m.tabIndex=t[g]===f?0:-1})}function u(f,p){let m=f.view;i.has(m)||i.set(m,Am[m].build(n,e));let g=i.get(m);c.firstChild!==g.root&&h(m,g),g.update(f,p)}let d=(f,p)=>i.get(f.view)?.summary?.(f,p)??"";return{root:R("div.views",{},l,c),update:u,summary:d}}var Wk=(n,t)=>R("button",{role:"tab",id:`${t}-${n}`,"aria-controls":`${t}-panel`},Am[n].title);function $k(n,t,e){let i={ArrowRight:t+1,ArrowLeft:t-1,Home:0,End:e-1}[n];return i===void 0?null:(i+e)%e}var qk=1e3,Xk=400;function Jw(n,t){let e=R("p.hidden",{role:"status","aria-live":"polite"}),i=null,s=null,r=()=>n.activeElement!==null&&document.hasFocus();function o(a,c=!1){clearTimeout(i),i=setTimeout(()=>{!c&&!r()||(e.textContent=a(),clearTimeout(s),s=setTimeout(()=>e.textContent="",Xk+60*e.textContent.length))},qk)}return t.addEventListener("abort",()=>{clearTimeout(i),clearTimeout(s)}),{region:e,announce:o}}var jk=450,Yk=100,Jk=["q","arm","wrench","branches","trace","dragging"],Zk=0;function Rm(n,t,{views:e,arms:i,makeLink:s}){let r=n.shadowRoot??n.attachShadow({mode:"open"}),o=new AbortController,{signal:a}=o,{region:c,announce:l}=Jw(r,a),h=Qk(),u={id:`explorer-${++Zk}`,goTo:nB(t,a),announce:l,signal:a,notify:h.notify,point:b=>t.dispatch({type:"setFields",highlightedRow:b})},d=s?.(h.notify,a),f=yu(t,u),p=cv(t,u),m=Yw(t,e,{...u,arms:i,fit:f.fit}),g=R("section.explorer"),x=rv(t,{...u,arms:i,link:d,stage:f,card:g}),_=R("div.bench",{},f.root,p.root);return g.append(x.root,h.root,_,m.root,c),r.replaceChildren(R("style",{},hu,sv),g),tB(t,{card:g,head:x,stage:f,sliders:p,tabs:m},{announce:l,signal:a}),d&&Kk(t.state)&&m.root.scrollIntoView({block:"nearest"}),()=>{o.abort(),f.dispose(),r.replaceChildren()}}var Kk=({answer:n,arm:t,base:e})=>!!n||t!==e;function Qk(){let n=R("p.notice",{role:"status",hidden:!0});return{root:n,notify:e=>{n.hidden=!e,n.textContent=e}}}function tB(n,{card:t,head:e,stage:i,sliders:s,tabs:r},{announce:o,signal:a}){let c="light",l=null,h=()=>i.draw(n.state,n.derived,c),u=()=>{clearTimeout(l),l=null;let{state:d,derived:f}=n,p=`Explorer of the ${d.arm.name}`.replace("the Your","your");oe(t,"aria-label",p);for(let m of[e,i,s,r])m.update(d,f)};a.addEventListener("abort",()=>clearTimeout(l)),bu(d=>{c=d,t.dataset.theme=d,h()},a),n.listen(d=>{if(h(),n.state.dragging&&!d.has("dragging")){l??=setTimeout(u,Yk);return}u(),Jk.some(f=>d.has(f))&&!n.state.playing&&o(()=>eB(n,r))},a),u()}function eB({state:n,derived:t},e){let[i,s,r]=t.frames.at(-1).o.map(o=>Nt(o,3).replace("−","minus "));return`Tip at x ${i}, y ${s}, z ${r} metres. ${e.summary(n,t)}`.trim()}function nB(n,t){let e=null,i=()=>{e&&cancelAnimationFrame(e),e=null};return t.addEventListener("abort",i),n.listen((s,r)=>r!=="glide"&&(s.has("q")||s.has("arm"))&&i(),t),s=>{i();let{q:r,arm:o}=n.state,a=`glide ${performance.now()}`,c=u=>n.dispatch({type:"glide",q:u,gesture:a},"glide");if(fc()||s.length!==r.length){c(s);return}let l=performance.now(),h=u=>{if(e=null,n.state.arm!==o)return;let d=Math.min(1,Math.max(0,u-l)/jk),f=d*d*(3-2*d);c(d===1?s:r.map((p,m)=>p+f*(s[m]-p))),d<1&&(e=requestAnimationFrame(h))};e=requestAnimationFrame(h)}}function Zw(n,t){if(!t)return null;let e=t.filter(({q:s})=>yn(n,s)),i=It(n,e[0]?.q??n.rows.map(()=>0)).at(-1);return{list:e,families:[],lockedJoint:-1,target:i,hasOrientation:Vs(n)}}function Kw(n){let[t]=n.arms;return gu({arm:t,reference:n.reference??t,q:n.q,wrench:n.wrench,unit:n.unit,view:n.views[0],frames:n.views[0]==="table"?"all":"ends",trace:n.trace,branches:Zw(t,n.branches)})}function iB(n){return n.explorer??=sB(n),n.explorer}function sB(n){let{figure:t}=n.dataset,e=JSON.parse(n.querySelector("script").textContent);if(t)return{dispose:Wp[t](n,e)};let i=new lr(Kw(e)),s=e.link?(o,a)=>$g(i,e.arms,e.views,o,a):void 0,r=Rm(n,i,{...e,makeLink:s});return{store:i,dispose:r}}var Cm={q:{from:n=>n.q,field:"q"},wrench:{from:n=>n.wrench,field:"wrench"},trace:{from:n=>n.trace,field:"trace"},branches:{from:n=>n.branches?.list??null,field:"branches"},arm_name:{from:n=>n.base.name,field:"arm"},rows:{from:n=>n.arm===n.base?[]:n.arm.rows,field:"arm"}},rB=50;function oB(n,t){let{arms:e}=n.get("_spec"),i=e.find(h=>h.name===n.get("arm_name"))??t.base,s=t.base.name===i.name,r=n.get("rows"),o=r.length?aB(r,t.arm):s?t.base:i,a=n.get("branches"),c=Yu(a,t.branches?.list??null)&&t.arm===o,l=n.get("trace");return{arm:o,base:s?t.base:i,reference:s?t.reference:i,q:[...n.get("q")],wrench:[...n.get("wrench")],trace:Yu(l,t.trace)?t.trace:l,branches:c?t.branches:Zw(o,a)}}var aB=(n,t)=>Yu(n,t.rows)?t:{name:td,home:[],rows:n},Yu=(n,t)=>JSON.stringify(n)===JSON.stringify(t);function cB(){let n=null;function t({model:i}){let s=i.get("_spec"),r=Object.fromEntries(["q","wrench","trace","branches"].map(o=>[o,i.get(o)]));return n=new lr(Kw({...s,...r})),hB(i,n)}return{initialize:t,render:({model:i,el:s})=>Qw(s,r=>Rm(r,n,i.get("_spec")))}}function Qw(n,t){let e=document.createElement("div");e.dataset.lmSuppressShortcuts="true",n.append(e);let i=lB(n),s=t(e);return()=>{i(),s(),e.remove()}}function lB(n){let t=null,e=requestAnimationFrame(function i(){n.isConnected?(t=n.closest(".jp-OutputArea-child")?.previousElementSibling,t?.querySelector(".jp-RenderedSVG")||(t=null),t?.style.setProperty("display","none")):e=requestAnimationFrame(i)});return()=>{cancelAnimationFrame(e),t?.style.removeProperty("display")}}function hB(n,t){let e=new Set(Object.values(Cm).map(({field:h})=>h)),i=new AbortController,[s,r,o]=[null,null,!1],a=()=>{s=null,o=!0;for(let[h,{from:u}]of Object.entries(Cm)){let d=u(t.state);Yu(n.get(h),d)||n.set(h,d)}o=!1,n.save_changes()};t.listen((h,u)=>{u!=="python"&&[...h].some(d=>e.has(d))&&(s??=setTimeout(a,rB))},i.signal);let c=()=>{o||(r??=setTimeout(()=>{r=null,t.dispatch({type:"replaceState",...oB(n,t.state)},"python")}))},l=Object.keys(Cm).map(h=>`change:${h}`);for(let h of l)n.on(h,c);return()=>{i.abort(),clearTimeout(s),clearTimeout(r);for(let h of l)n.off(h,c)}}var uB=()=>({render({model:n,el:t}){let e=n.get("_spec");return Qw(t,i=>Wp[e.figure](i,e))}});return lM(dB);})();
/*! Bundled license information:

three/build/three.core.js:
three/build/three.module.js:
  (**
   * @license
   * Copyright 2010-2026 Three.js Authors
   * SPDX-License-Identifier: MIT
   *)
*/
