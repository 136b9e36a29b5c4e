var Gt,rg,Pb,gr,Dd,fc,og,cc,ag,Ud,Nd,Ib,Ha=Symbol.for("pv"),pc={},mc=[],Lb=/^m(i|n|o|s|text|space)$/,Od=Array.isArray,lg=mc.slice,Zr=Object.assign;function Kr(n){n&&n.parentNode&&n.remove()}function uc(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Ha,__v:s||++rg,__i:-1,__u:0};return!s&&Gt.vnode&&Gt.vnode(r),r}function Tt(n){return n.children}function hc(n,e){this.props=n,this.context=e,this.__g=0}function _r(n,e){if(e==null)return n.__&&_r(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:_r(n)}function Db(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Zr({constructor:Ha},t)).__v=t.__v+1,Gt.vnode&&Gt.vnode(e),Fd(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||_r(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,pg(s,e,r),t.__=t.__e=null,e.__e!=i&&cg(e))}function cg(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),cg(n)}function ig(n){(8&n.__g||(n.__g|=8,gr.push(n),fc++))&&Dd==Gt.debounceRendering||((Dd=Gt.debounceRendering)||queueMicrotask)(ug)}function ug(){try{for(var n,e=1;gr.length;)gr.length>e&&gr.sort(og),n=gr.shift(),e=gr.length,8&n.__g&&Db(n)}finally{(fc=gr.length)&&(Dd||queueMicrotask)(ug)}}function hg(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,b,m,_=i.__k||mc,v=e.length;for(l=Nb(t,e,_,l,v),f=0;f<v;f++)(d=t.__k[f])!=null&&(h=~d.__i&&_[d.__i]||pc,d.__i=f,m=Fd(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&kd(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),b=b||p,4&d.__u?(l=dg(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&m!==void 0?l=m:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=b,l}function Nb(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,b=p,m=0,_=0,v=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=uc(null,o):Od(o)?o=v[r]=uc(Tt,{children:o}):o.constructor===Ha&&o.__b?o=v[r]=uc(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Ub(o,t,l,b))&&(b--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,_=1)):(~c||(s>p?m--:s<p&&m++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(_){for(u=[],f=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(m=0,h=u.length;m<h;)u[d=m+h>>1]<o.__i?m=d+1:h=d;u[m]=o.__i,f[r]=m+1}for(m=u.length;r--;)f[r]&&(f[r]==m?m--:v[r].__u|=4)}if(b)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=_r(a)),Bd(a,a));return i}function dg(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=dg(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=_r(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Ub(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function sg(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function lc(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||sg(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||sg(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Nd[e]||(Nd[e]=Ob(e)),(n.__a||(n.__a={}))[e]=Ud,r=e!=(e=e.replace(ag,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Ob(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[cc]==null)e[cc]=Ud++;else if(e[cc]<this.__a[n])return;return t(Gt.event?Gt.event(e):e)}}}function Fd(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,m,_,v,C,S,I,T,y,E,V,U,L,G=e.type;if(e.constructor!==Ha)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=dc(u,r):r.push(u),a=r[0]||a),(u=Gt.__b)&&u(e);e:if(typeof G=="function"){h=o.length;try{if(_=e.props,v=(u=G.prototype)&&u.render,C=(u=G.contextType)&&i[u.__c],S=u?C?C.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(v?e.__c=d=new G(_,S):(e.__c=d=new hc(_,S),d.constructor=G,d.render=kb),C&&C.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),v&&(d.__s||(d.__s=d.state),G.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Zr({},d.__s)),Zr(d.__s,G.getDerivedStateFromProps(_,d.__s)))),p=d.props,b=d.state,d.__v=e,t.__c){if(_!==p&&v&&!G.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(_,S),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(_,d.__s,S)===!1){e.__v!=t.__v&&(d.props=_,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(z){z&&(z.__=e)}),mc.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=_r(t);break e}d.componentWillUpdate&&d.componentWillUpdate(_,d.__s,S),v&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,b,m)})}else v&&!G.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),v&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=S,d.props=_,d.__P=n,d.__g&=-5,I=Gt.__r,T=v?25:0;do d.__g&=-9,I&&I(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++T<25);v&&(mc.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Zr({},i,d.getChildContext())),v&&t.__c&&d.getSnapshotBeforeUpdate&&(m=d.getSnapshotBeforeUpdate(p,b)),y=u&&u.type===Tt&&u.key==null?u.props.children:u,_.__P&&(u=a,s=(n=_.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(z){z&&Bd(z,z)}),t.__k=null),a=t.__k?_r(t,0):null),a=hg(n,Od(y)?y:[y],e,t,i,s,r,o,a,l,c),_.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(Kr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(z){if(o.length=h,e.__v=null,l||r)if(z&&z.then){if(e.__u|=128|l,r){for(~(U=r.indexOf(a||void 0))||(U=r.length);(L=r[U-1])&&L.nodeType==8;)U--;for(;U<r.length;U++)if(L=r[U])if(r[U]=null,E){if(L==V)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(V=dc(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=dc(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Kr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),z&&z.then||fg(e),Gt.__e(z,e,t)}}else a=e.__e=Fb(t.__e,e,t,i,s,r,o,l,c,n);return(u=Gt.diffed)&&u(e),a}function dc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function fg(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(fg))}function pg(n,e,t){for(var i=0;i<t.length;)kd(t[i++],t[i++],t[i++]);Gt.__c&&Gt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Gt.__e(r,s.__v)}})}function Fb(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,m,_,v=t.props||pc,C=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(S?p.localName==S:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(_=c.ownerDocument||document,!S)return _.createTextNode(C);n=_.createElementNS(s,S,C.is?C:c),a&&(Gt.__m&&Gt.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&C.defaultValue!=null?null:r&&lg.call(c.childNodes),!a&&r)for(v={},u=0;u<n.attributes.length;u++)v[(p=n.attributes[u]).name]=p.value;for(u in v)p=v[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in C||u=="value"&&"defaultValue"in C||u=="checked"&&"defaultChecked"in C||lc(n,u,null,p,s);for(u in C)p=C[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?b=p:u=="checked"?m=p:a&&typeof p!="function"||v[u]===p||lc(n,u,p,v[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Lb.test(S))&&(s="http://www.w3.org/1999/xhtml"),hg(c,Od(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&_r(t,0),a,l),r&&r.some(Kr)),a&&S!="textarea"||(u="value",S=="progress"&&b==null?n.removeAttribute(u):b==null||b===n[u]&&(S!="progress"||b)||lc(n,u,b,v[u],s),u="checked",m!=null&&m!=n[u]&&lc(n,u,m,v[u],s))}else v===C||a&&n.data==C||(n.data=C);return n}function kd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Gt.__e(s,t)}}function Bd(n,e,t){var i,s,r,o;if(Gt.unmount&&Gt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||kd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Gt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Bd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=dc(i,r=[]))&&(i==n.__e&&r.some(Kr),Kr(s),Kr(i)),t||Kr(n.__e),n.__e=n.__c=n.__=null}function kb(n,e,t){return this.constructor(n,t)}function zd(n,e){var t,i,s,r;Gt.__&&Gt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=uc(Tt,{children:[n]}),s=[],r=[],Fd(e,e.__k,i||pc,pc,e.namespaceURI,i?null:e.firstChild?lg.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),pg(s,e.__k,r),e.__k.props.children=null}Gt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw fc=0,n}},rg=0,Pb=function(n){return n!=null&&n.constructor===Ha},hc.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Zr({},this.state)),typeof n=="function"&&(n=n(Zr({},t),this.props)),n&&(Zr(t,n),this.__v&&(e&&this.__k.push(e),ig(this)))},hc.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),ig(this))},hc.prototype.render=Tt,gr=[],fc=0,og=function(n,e){return n.__v.__b-e.__v.__b},cc=Symbol(),ag=/(PointerCapture)$|Capture$/i,Ud=0,Nd={},Ib=0;var Wa,Pn,Vd,mg,Hd=Object.is,Xa=0,wg=[],Gd=[],wn=Gt,gg=wn.__b,_g=wn.__r,xg=wn.diffed,yg=wn.__c,vg=wn.unmount,bg=wn.__;function Xd(n,e){wn.__h&&wn.__h(Pn,n,Xa||e),Xa=0;var t=Pn.__H||(Pn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function et(n){return Xa=1,Bb(Eg,n)}function Bb(n,e,t){var i=Xd(Wa++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Eg(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Hd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Pn,!Pn.__f)){Pn.__f=!0;var s=Pn.shouldComponentUpdate;Pn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,Hd(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function qe(n,e){var t=Xd(Wa++,3);!wn.__s&&Tg(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Pn.__H.__h.push(t))}function Lt(n){return Xa=5,St(function(){return{current:n}},[])}function St(n,e){var t=Xd(Wa++,7);return Tg(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Ag(n,e){return Xa=8,St(function(){return n},e)}function zb(){var n;do{for(;n=Gd.shift();)try{Ga(n)}catch(t){wn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=wg.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ga),e.__h.some(Wd),e.__h=[]}catch(t){e.__h=[],wn.__e(t,n.__v)}}}while(Gd.length)}wn.__b=function(n){Pn=null,gg&&gg(n)},wn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),bg&&bg(n,e)},wn.__r=function(n){_g&&_g(n),Wa=0;var e=(Pn=n.__c).__H;e&&(Vd==Pn?Pn.__h=[]:(e.__h.some(Ga),e.__h.some(Wd),Wa=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),Vd=Pn},wn.diffed=function(n){xg&&xg(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Mg(wg.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),Vd=Pn=null},wn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ga),t.__h=t.__h.filter(function(i){return!i.__||Wd(i)})}catch(i){t.__h=[function(){throw i}]}}),yg&&yg(n,e)},wn.unmount=function(n){vg&&vg(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Mg(Gd.push(s))}else Ga(s)}catch(r){e=r}}),i.__H=void 0,e&&wn.__e(e,i.__v))};var Sg=typeof requestAnimationFrame=="function";function Vb(n){var e,t=function(){clearTimeout(i),Sg&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Sg&&(e=requestAnimationFrame(t))}function Mg(n){n!=1&&mg==wn.requestAnimationFrame||((mg=wn.requestAnimationFrame)||Vb)(zb)}function Ga(n){var e=Pn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Pn=e}function Wd(n){var e=Pn;n.__c=n.__(),Pn=e}function Tg(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Hd(t,n[i])})}function Eg(n,e){return typeof e=="function"?e(n):e}function Hb(n,e){switch(n){case"|u1":return new Uint8Array(e);case"<u4":return new Uint32Array(e);case"<f4":return new Float32Array(e);case"<f8":return new Float64Array(e);case"<u8":return Float64Array.from(new BigUint64Array(e),Number);default:throw new Error(`an NPY array of type ${n}, which this page does not know`)}}function Cg(n){let e=new Uint8Array(n);if(e.length<10||e[0]!==147||e[1]!==78||e[6]!==1)throw new Error("not an NPY array of format 1.0");let t=10+e[8]+256*e[9],i=new TextDecoder("latin1").decode(e.subarray(10,t)),s=/'descr':\s*'([^']+)'/.exec(i)?.[1]??"",r=(/'shape':\s*\(([^)]*)\)/.exec(i)?.[1]??"").split(",").filter(a=>a.trim()!=="").map(Number);if(/'fortran_order':\s*True/.test(i))throw new Error("an NPY array in Fortran order, which this page does not read");let o=Hb(s,n.slice(t));if(o.length!==r.reduce((a,l)=>a*l,1))throw new Error("an NPY array that is cut short");return{shape:r,values:o}}var Vi=class extends Error{constructor(t,i){super(i);this.status=t}status;get isBusy(){return this.status===503}},Gb=300;function _c(){return new Promise(n=>setTimeout(n,Gb))}var Rg="cdcluster.key",gc="";function Wb(){try{return localStorage.getItem(Rg)??gc}catch{return gc}}function $d(){let n=/^#key=([^&]*)&?(.*)$/.exec(location.hash);if(n){gc=n[1];try{localStorage.setItem(Rg,gc)}catch{}history.replaceState(null,"",`${location.pathname}#${n[2]}`)}}async function Xb(n){try{let e=await n.json();if(typeof e=="object"&&e!==null&&"error"in e)return String(e.error)}catch{}return`the server answered ${n.status}`}async function $b(n,e){let t=Wb(),i=t===""?{}:{Authorization:`Bearer ${t}`},s;try{s=await fetch(`api/v1/${n}`,{headers:i,credentials:"same-origin",...e?{signal:e}:{}})}catch(r){throw e?.aborted?r:new Vi(0,"the server does not answer: has it ended?")}if(!s.ok)throw new Vi(s.status,await Xb(s));return{bytes:await s.arrayBuffer(),cut:s.headers.get("X-Cut")==="true"}}var xc=$b;function Pg(n){xc=n}async function qd(n,e){return new TextDecoder().decode((await xc(n,e)).bytes)}async function Ri(n,e){return JSON.parse(await qd(n,e))}async function An(n,e){let{bytes:t,cut:i}=await xc(n,e);return{...Cg(t),cut:i}}async function Ig(n,e){return(await xc(n,e)).bytes}function Fs(n){return n instanceof DOMException&&n.name==="AbortError"}function ti(n){return n instanceof Error?n.message:String(n)}var vc=new Map,yc=[];function yi(n,e){return vc.set(n,e),()=>{vc.get(n)===e&&vc.delete(n)}}function Lg(){addEventListener("error",n=>yc.push(n.message)),addEventListener("unhandledrejection",n=>yc.push(String(n.reason))),document.addEventListener("securitypolicyviolation",n=>yc.push(`policy: ${n.violatedDirective} ${n.blockedURI}`)),window.cdcluster={facts:()=>Object.assign({ready:!1,errors:[...yc]},...[...vc.values()].map(n=>n()))}}async function qb(n){let e=atob(n),t=new Uint8Array(e.length);for(let s=0;s<e.length;++s)t[s]=e.charCodeAt(s);let i=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(i).arrayBuffer()}var bc=class n{constructor(e){this.blocks=e}blocks;static of(e){let i=Array.from(e.querySelectorAll("template[data-path]")).map(s=>[s.dataset.path??"",{base64:()=>s.content.textContent??"",cut:s.dataset.cut==="true"}]);return i.length===0?null:new n(new Map(i))}get scenarios(){return[...this.blocks.keys()].flatMap(e=>{let t=/^jobs\/[^/]+\/scenarios\/(\d+)$/.exec(e);return t?[Number(t[1])]:[]})}async answer(e){let t=this.blocks.get(e);if(!t)throw new Vi(404,"this report holds its worst scenarios only");return{bytes:await qb(t.base64()),cut:t.cut}}};function Yd(n){let[e,t]=n.replace(/^#/,"").split("?",2),i={screen:"none",job:"",scenario:0,query:new URLSearchParams(t??"")},s=e.split("/").filter(o=>o!=="");if(s.length===1&&(s[0]==="cluster"||s[0]==="jobs"))return{...i,screen:s[0]};if(s[0]!=="jobs"||s.length<2||s.length>3)return i;let r=Yb(s[1]);return s.length===2?{...i,screen:"job",job:r}:/^\d+$/.test(s[2])?{...i,screen:"viewer",job:r,scenario:Number(s[2])}:i}function Yb(n){try{return decodeURIComponent(n)}catch{return n}}function Dg(n){let e=new URLSearchParams(n).toString().replaceAll("%2C",",").replaceAll("%3A",":").replaceAll("%2F","/");return e===""?"":`?${e}`}function ks(n,e={}){return`#/jobs/${encodeURIComponent(n)}${Dg(e)}`}function mn(n,e,t={}){return`#/jobs/${encodeURIComponent(n)}/${e}${Dg(t)}`}var $a=null,Ng=0,Sc=null;function Bs(n){Ug(),location.hash=n}function Jd(){return $a=location.hash,Yd($a)}function qa(n){xr(),($a===null||location.hash===$a)&&(history.replaceState(null,"",n),$a=location.hash)}function Mc(n){xr(),Sc=n,Ng=window.setTimeout(Ug,200)}function Ug(){Sc&&qa(Sc())}function xr(){clearTimeout(Ng),Sc=null}var Og="cdcluster.theme",wc=new Set;function Fg(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:"system"}function kg(n){n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n;try{localStorage.setItem(Og,n)}catch{}wc.forEach(e=>e())}function Bg(){try{let n=localStorage.getItem(Og);(n==="light"||n==="dark")&&(document.documentElement.dataset.theme=n)}catch{}matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>wc.forEach(n=>n()))}function Ac(n){return wc.add(n),()=>wc.delete(n)}function Zi(n,e=document.documentElement){return getComputedStyle(e).getPropertyValue(n).trim()}function Re(n){return(n<0?"-":"")+String(Math.round(Math.abs(n))).replace(/\B(?=(\d{3})+$)/g," ")}function Et(n,e=4){return Number.isFinite(n)?String(Number(n.toPrecision(e))):n>0?"infinite":"-"}function gn(n){return Number.isFinite(n)?`${n>0&&n<.001?"< 0.1":Et(100*n,3)} %`:"-"}function Tc(n,e,t){let i=0;for(;Math.abs(n)>=e&&i+1<t.length;)n/=e,i+=1;let s=i===0?String(Math.round(n)):n.toPrecision(3);return t[i]===""?s:s+" "+t[i]}function zs(n){return Tc(n,1024,["B","KiB","MiB","GiB","TiB"])}function zg(n){return`${Tc(n,1e3,["B","kB","MB","GB"])}/s`}function Vg(n,e){if(n<.01*e)return`${zs(n)} of ${zs(e)}`;let[t,i]=zs(e).split(" ");return`${(n/(e/Number(t))).toPrecision(2)} of ${t} ${i}`}function yr(n){return`${Tc(n,1e3,["","k","M","G"])}/s`}function Kd(n){return Tc(n,1e3,["","k","M","G"])}function jr(n){if(!Number.isFinite(n))return"-";if(n<10)return`${Et(n,2)} s`;let e=Math.round(n),t=i=>String(i).padStart(2,"0");return e<3600?`${Math.floor(e/60)}:${t(e%60)}`:e<86400?`${Math.floor(e/3600)} h ${t(Math.floor(e%3600/60))}`:`${Math.floor(e/86400)} d ${Math.floor(e%86400/3600)} h`}function Ct(n,e){return`${Re(n)} ${e}${n===1?"":"s"}`}function Ya(n){return/^[\w./:@%+=,-]+$/.test(n)?n:`'${n.replaceAll("'","'\\''")}'`}function Vs(n){return n.split("/").pop()||n}var Jb="uplot",Kb="u-hz",Zb="u-vt",jb="u-title",Qb="u-wrap",eS="u-under",tS="u-over",nS="u-axis",to="u-off",iS="u-select",sS="u-cursor-x",rS="u-cursor-y",oS="u-cursor-pt",aS="u-legend",lS="u-live",cS="u-inline",uS="u-series",hS="u-marker",Hg="u-label",dS="u-value",Ka="width",Za="height";var Gg="bottom",Lo="left",Zd="right",mf="#000",Wg=mf+"0",jd="mousemove",Xg="mousedown",Qd="mouseup",$g="mouseenter",qg="mouseleave",Yg="dblclick",fS="resize",pS="scroll",Jg="change",Ic="dppxchange",gf="--",Bo=typeof window<"u",rf=Bo?document:null,No=Bo?window:null,mS=Bo?navigator:null,Dt,Ec;function of(){let n=devicePixelRatio;Dt!=n&&(Dt=n,Ec&&lf(Jg,Ec,of),Ec=matchMedia(`(min-resolution: ${Dt-.001}dppx) and (max-resolution: ${Dt+.001}dppx)`),no(Jg,Ec,of),No.dispatchEvent(new CustomEvent(Ic)))}function Pi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function af(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function en(n,e,t){n.style[e]=t+"px"}function ji(n,e,t,i){let s=rf.createElement(n);return e!=null&&Pi(s,e),t?.insertBefore(s,i),s}function Hi(n,e){return ji("div",n,e)}var Kg=new WeakMap;function vs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Kg.get(n);r!=o&&(n.style.transform=r,Kg.set(n,r),e<0||t<0||e>i||t>s?Pi(n,to):af(n,to))}var Zg=new WeakMap;function jg(n,e,t){let i=e+t,s=Zg.get(n);i!=s&&(Zg.set(n,i),n.style.background=e,n.style.borderColor=t)}var Qg=new WeakMap;function e0(n,e,t,i){let s=e+""+t,r=Qg.get(n);s!=r&&(Qg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var _f={passive:!0},gS={..._f,capture:!0};function no(n,e,t,i){e.addEventListener(n,t,i?gS:_f)}function lf(n,e,t,i){e.removeEventListener(n,t,_f)}Bo&&of();function Qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Ii((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function C0(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var R0=n=>n!=null,P0=n=>n!=null&&n>0,Nc=C0(R0),_S=C0(P0);function xS(n,e,t,i=0,s=!1){let r=s?_S:Nc,o=s?P0:R0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Yt,l??-Yt]}function Uc(n,e,t,i){let s=i0(n),r=i0(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Hs:I0,a=s==1?Ii:Gi,l=r==1?Gi:Ii,c=a(o(Ln(n))),u=l(o(Ln(e))),f=Uo(t,c),h=Uo(t,u);return t==10&&(c<0&&(f=Jt(f,-c)),u<0&&(h=Jt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=U0(n,f),e=Oc(e,h)),[n,e]}function xf(n,e,t,i){let s=Uc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var yf=.1,t0={mode:3,pad:yf},Qa={pad:0,soft:null,mode:0},yS={min:Qa,max:Qa};function Lc(n,e,t,i){return Fc(t)?n0(n,e,t):(Qa.pad=t,Qa.soft=i?0:null,Qa.mode=i?3:0,n0(n,e,yS))}function Rt(n,e){return n??e}function vS(n,e,t){for(e=Rt(e,0),t=Rt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function n0(n,e,t){let i=t.min,s=t.max,r=Rt(i.pad,0),o=Rt(s.pad,0),a=Rt(i.hard,-Yt),l=Rt(s.hard,Yt),c=Rt(i.soft,Yt),u=Rt(s.soft,-Yt),f=Rt(i.mode,0),h=Rt(s.mode,0),d=e-n,p=Hs(d),b=hi(Ln(n),Ln(e)),m=Hs(b),_=Ln(m-p);(d<1e-24||_>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Yt&&(r=0),h==2&&u!=-Yt&&(o=0)));let v=d||b||1e3,C=Hs(v),S=Uo(10,Ii(C)),I=v*(d==0?n==0?.1:1:r),T=Jt(U0(n-I,S/10),24),y=n>=c&&(f==1||f==3&&T<=c||f==2&&T>=c)?c:Yt,E=hi(a,T<y&&n>=y?y:es(y,T)),V=v*(d==0?e==0?.1:1:o),U=Jt(Oc(e+V,S/10),24),L=e<=u&&(h==1||h==3&&U>=u||h==2&&U<=u)?u:-Yt,G=es(l,U>L&&e<=L?L:hi(L,U));return E==G&&E==0&&(G=100),[E,G]}var bS=new Intl.NumberFormat(Bo?mS.language:"en-US"),vf=n=>bS.format(n),Li=Math,Pc=Li.PI,Ln=Li.abs,Ii=Li.floor,In=Li.round,Gi=Li.ceil,es=Li.min,hi=Li.max,Uo=Li.pow,i0=Li.sign,Hs=Li.log10,I0=Li.log2,SS=(n,e=1)=>Li.sinh(n)*e,ef=(n,e=1)=>Li.asinh(n/e),Yt=1/0;function s0(n){return(Hs((n^n>>31)-(n>>31))|0)+1}function cf(n,e,t){return es(hi(n,e),t)}function L0(n){return typeof n=="function"}function yt(n){return L0(n)?n:()=>n}var MS=()=>{},D0=n=>n,N0=(n,e)=>e,wS=n=>null,r0=n=>!0,o0=(n,e)=>n==e,AS=/\.\d*?(?=9{6,}|0{6,})/gm,io=n=>{if(F0(n)||br.has(n))return n;let e=`${n}`,t=e.match(AS);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${io(s)}e${r}`}return Jt(n,i)};function Qr(n,e){return io(Jt(io(n/e))*e)}function Oc(n,e){return io(Gi(io(n/e))*e)}function U0(n,e){return io(Ii(io(n/e))*e)}function Jt(n,e=0){if(F0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return In(i)/t}var br=new Map;function O0(n){return((""+n).split(".")[1]||"").length}function tl(n,e,t,i){let s=[],r=i.map(O0);for(let o=e;o<t;o++){let a=Ln(o),l=Jt(Uo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Jt(u,f);s.push(h),br.set(h,f)}}return s}var el={},bf=[],Oo=[null,null],vr=Array.isArray,F0=Number.isInteger,TS=n=>n===void 0;function a0(n){return typeof n=="string"}function Fc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function ES(n){return n!=null&&typeof n=="object"}var CS=Object.getPrototypeOf(Uint8Array),k0="__proto__";function Fo(n,e=Fc){let t;if(vr(n)){let i=n.find(s=>s!=null);if(vr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Fo(n[s],e)}else t=n.slice()}else if(n instanceof CS)t=n.slice();else if(e(n)){t={};for(let i in n)i!=k0&&(t[i]=Fo(n[i],e))}else t=n;return t}function Tn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=k0&&(Fc(n[s])?Tn(n[s],Fo(i[s])):n[s]=Fo(i[s]))}return n}var RS=0,PS=1,IS=2;function LS(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function DS(n,e){if(OS(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return FS(o[0])||(o=US(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:PS,d=[];for(let p=0;p<u.length;p++){let b=u[p],m=r.get(l[p]);b===null?h!=RS&&(f[m]=b,h==IS&&d.push(m)):f[m]=b}LS(f,d,s),i.push(f)}}return i}var NS=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function US(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function OS(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function FS(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=hi(1,Ii((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var B0=["January","February","March","April","May","June","July","August","September","October","November","December"],z0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function V0(n){return n.slice(0,3)}var kS=z0.map(V0),BS=B0.map(V0),zS={MMMM:B0,MMM:BS,WWWW:z0,WWW:kS};function Ja(n){return(n<10?"0":"")+n}function VS(n){return(n<10?"00":n<100?"0":"")+n}var HS={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ja(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ja(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ja(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ja(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ja(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>VS(n.getMilliseconds())};function Sf(n,e){e=e||zS;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?HS[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var GS=new Intl.DateTimeFormat().resolvedOptions().timeZone;function WS(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==GS?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var H0=n=>n%1==0,Dc=[1,2,2.5,5],XS=tl(10,-32,0,Dc),G0=tl(10,0,32,Dc),$S=G0.filter(H0),eo=XS.concat(G0),Mf=`
`,W0="{YYYY}",l0=Mf+W0,X0="{M}/{D}",ja=Mf+X0,Cc=ja+"/{YY}",$0="{aa}",qS="{h}:{mm}",Do=qS+$0,c0=Mf+Do,u0=":{ss}",Ot=null;function q0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?tl(10,0,3,Dc).filter(H0):tl(10,-3,0,Dc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,W0,Ot,Ot,Ot,Ot,Ot,Ot,1],[s*28,"{MMM}",l0,Ot,Ot,Ot,Ot,Ot,1],[s,X0,l0,Ot,Ot,Ot,Ot,Ot,1],[i,"{h}"+$0,Cc,Ot,ja,Ot,Ot,Ot,1],[t,Do,Cc,Ot,ja,Ot,Ot,Ot,1],[e,u0,Cc+" "+Do,Ot,ja+" "+Do,Ot,c0,Ot,1],[n,u0+".{fff}",Cc+" "+Do,Ot,ja+" "+Do,Ot,c0,Ot,1]];function u(f){return(h,d,p,b,m,_)=>{let v=[],C=m>=o,S=m>=r&&m<o,I=f(p),T=Jt(I*n,3),y=tf(I.getFullYear(),C?0:I.getMonth(),S||C?1:I.getDate()),E=Jt(y*n,3);if(S||C){let V=S?m/r:0,U=C?m/o:0,L=T==E?T:Jt(tf(y.getFullYear()+U,y.getMonth()+V,1)*n,3),G=new Date(In(L/n)),z=G.getFullYear(),N=G.getMonth();for(let W=0;L<=b;W++){let Y=tf(z+U*W,N+V*W,1),H=Y-f(Jt(Y*n,3));L=Jt((+Y+H)*n,3),L<=b&&v.push(L)}}else{let V=m>=s?s:m,U=Ii(p)-Ii(T),L=E+U+Oc(T-E,V);v.push(L);let G=f(L),z=G.getHours()+G.getMinutes()/t+G.getSeconds()/i,N=m/i,W=h.axes[d]._space,Y=_/W;for(;L=Jt(L+m,n==1?0:3),!(L>b);)if(N>1){let H=Ii(Jt(z+N,6))%24,$=f(L).getHours()-H;$>1&&($=-1),L-=$*i,z=(z+N)%24;let ee=v[v.length-1];Jt((L-ee)/m,3)*Y>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,u]}var[YS,JS,KS]=q0(1),[ZS,jS,QS]=q0(.001);tl(2,-53,53,[1]);function h0(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function d0(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let b=n(p),m=b.getFullYear(),_=b.getMonth(),v=b.getDate(),C=b.getHours(),S=b.getMinutes(),I=b.getSeconds(),T=m!=l&&a[2]||_!=c&&a[3]||v!=u&&a[4]||C!=f&&a[5]||S!=h&&a[6]||I!=d&&a[7]||a[1];return l=m,c=_,u=v,f=C,h=S,d=I,T(b)})}}function eM(n,e){let t=Sf(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function tf(n,e,t){return new Date(n,e,t)}function f0(n,e){return e(n)}var tM="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function p0(n,e){return(t,i,s,r)=>r==null?gf:e(n(i))}function nM(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function iM(n,e){return n.series[e].fill(n,e)}var sM={show:!0,live:!0,isolate:!1,mount:MS,markers:{show:!0,width:2,stroke:nM,fill:iM,dash:"solid"},idx:null,idxs:null,values:[]};function rM(n,e){let t=n.cursor.points,i=Hi(),s=t.size(n,e);en(i,Ka,s),en(i,Za,s);let r=s/-2;en(i,"marginLeft",r),en(i,"marginTop",r);let o=t.width(n,e,s);return o&&en(i,"borderWidth",o),i}function oM(n,e){let t=n.series[e].points;return t._fill||t._stroke}function aM(n,e){let t=n.series[e].points;return t._stroke||t._fill}function lM(n,e){return n.series[e].points.size}var nf=[0,0];function cM(n,e,t){return nf[0]=e,nf[1]=t,nf}function Rc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function sf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var uM={show:!0,x:!0,y:!0,lock:!1,move:cM,points:{one:!1,show:rM,size:lM,width:0,stroke:aM,fill:oM},bind:{mousedown:Rc,mouseup:Rc,click:Rc,dblclick:Rc,mousemove:sf,mouseleave:sf,mouseenter:sf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},Y0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},wf=Tn({},Y0,{filter:N0}),J0=Tn({},wf,{size:10}),K0=Tn({},Y0,{show:!1}),Af='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Z0="bold "+Af,j0=1.5,m0={show:!0,scale:"x",stroke:mf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Z0,side:2,grid:wf,ticks:J0,border:K0,font:Af,lineGap:j0,rotate:0},hM="Value",dM="Time",g0={show:!0,scale:"x",auto:!1,sorted:1,min:Yt,max:-Yt,idxs:[]};function fM(n,e,t,i,s){return e.map(r=>r==null?"":vf(r))}function pM(n,e,t,i,s,r,o){let a=[],l=br.get(s)||0;t=o?t:Jt(Oc(t,s),l);for(let c=t;c<=i;c=Jt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function uf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Hs:I0,u=Ii(c(t));s=Uo(l,u),l==10&&(s=eo[Qi(s,eo)]);let f=t,h=s*l;l==10&&(h=eo[Qi(h,eo)]);do a.push(f),f=f+s,l==10&&!br.has(f)&&(f=Jt(f,br.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=eo[Qi(h,eo)]));while(f<=i);return a}function mM(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?uf(n,e,hi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?uf(n,e,hi(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Q0=/./,gM=/[12357]/,_M=/[125]/,_0=/1/,hf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function xM(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?Q0:l(7,o)-u>=c?gM:l(5,o)-u>=c?_M:_0;if(f==_0){let h=Ln(l(1,o)-u);if(h<c)return hf(e.slice().reverse(),a.distr,f,Gi(c/h)).reverse()}return hf(e,a.distr,f,1)}function yM(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Ln(l(1,o)-l(2,o));return c<a?hf(e.slice().reverse(),3,Q0,Gi(a/c)).reverse():e}function vM(n,e,t,i){return i==null?gf:e==null?"":vf(e)}var x0={show:!0,scale:"y",stroke:mf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Z0,side:3,grid:wf,ticks:J0,border:K0,font:Af,lineGap:j0,rotate:0};function bM(n,e){let t=3+(n||1)*2;return Jt(t*e,3)}function SM(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Ln(o-r),l=n.series[e],c=a/(l.points.space*Dt);return i[1]-i[0]<=c}var y0={scale:null,auto:!0,sorted:0,min:Yt,max:-Yt},e_=(n,e,t,i,s)=>s,v0={show:!0,auto:!0,sorted:0,gaps:e_,alpha:1,facets:[Tn({},y0,{scale:"x"}),Tn({},y0,{scale:"y"})]},b0={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:e_,alpha:1,points:{show:SM,filter:null},values:null,min:Yt,max:-Yt,idxs:[],path:null,clip:null};function MM(n,e,t,i,s){return t/10}var t_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},wM=Tn({},t_,{time:!1,ori:1}),S0={};function n_(n,e){let t=S0[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(S0[n]=t)),t}var ko=1,df=2;function so(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,b=a.height,m=n.valToPosH,_=n.valToPosV;return u.ori==0?t(s,l,c,u,f,m,_,h,d,p,b,Bc,zo,Vc,s_,o_):t(s,l,c,u,f,_,m,d,h,b,p,zc,Vo,Cf,r_,a_)}function Tf(n,e){let t=0,i=0,s=Rt(n.bands,bf);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function AM(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Gs(n,e,t,i,s,r){return so(n,e,(o,a,l,c,u,f,h,d,p,b,m)=>{let _=o.pxRound,v=c.dir*(c.ori==0?1:-1),C=c.ori==0?zo:Vo,S,I;v==1?(S=t,I=i):(S=i,I=t);let T=_(f(a[S],c,b,d)),y=_(h(l[S],u,m,p)),E=_(f(a[I],c,b,d)),V=_(h(r==1?u.max:u.min,u,m,p)),U=new Path2D(s);return C(U,E,V),C(U,T,V),C(U,T,y),U})}function kc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?Vc:Cf,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function TM(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Ef(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),b=f-s;d=o<=0&&b>=0&&b<l?r(n[b]):d;let _=h+s;p=o>=0&&_>=0&&_<l?r(n[_]):p,p>=d&&a.push([d,p])}return a}function M0(n){return n==0?D0:n==1?In:e=>Qr(e,n)}function i_(n){let e=n==0?Bc:zc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=es(c,a/2,l/2),u=es(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Bc=(n,e,t)=>{n.moveTo(e,t)},zc=(n,e,t)=>{n.moveTo(t,e)},zo=(n,e,t)=>{n.lineTo(e,t)},Vo=(n,e,t)=>{n.lineTo(t,e)},Vc=i_(0),Cf=i_(1),s_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},r_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},o_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},a_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function l_(n){return(e,t,i,s,r)=>so(e,t,(o,a,l,c,u,f,h,d,p,b,m)=>{let{pxRound:_,points:v}=o,C,S;c.ori==0?(C=Bc,S=s_):(C=zc,S=r_);let I=Jt(v.width*Dt,3),T=(v.size-v.width)/2*Dt,y=Jt(T*2,3),E=new Path2D,V=new Path2D,{left:U,top:L,width:G,height:z}=e.bbox;Vc(V,U-y,L-y,G+y*2,z+y*2);let N=W=>{if(l[W]!=null){let Y=_(f(a[W],c,b,d)),H=_(h(l[W],u,m,p));C(E,Y+T,H),S(E,Y,H,T,0,Pc*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:I>0?E:null,fill:E,clip:V,flags:ko|df}})}function c_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var EM=c_(zo),CM=c_(Vo);function u_(n){let e=Rt(n?.alignGaps,0);return(t,i,s,r)=>so(t,i,(o,a,l,c,u,f,h,d,p,b,m)=>{[s,r]=Nc(l,s,r);let _=o.pxRound,v=z=>_(f(z,c,b,d)),C=z=>_(h(z,u,m,p)),S,I;c.ori==0?(S=zo,I=EM):(S=Vo,I=CM);let T=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ko},E=y.stroke,V=!1;if(r-s>=b*4){let z=de=>t.posToVal(de,c.key,!0),N=null,W=null,Y,H,ae,K=v(a[T==1?s:r]),$=v(a[s]),ee=v(a[r]),he=z(T==1?$+1:ee-1);for(let de=T==1?s:r;de>=s&&de<=r;de+=T){let te=a[de],ge=(T==1?te<he:te>he)?K:v(te),Me=l[de];ge==K?Me!=null?(H=Me,N==null?(S(E,ge,C(H)),Y=N=W=H):H<N?N=H:H>W&&(W=H)):Me===null&&(V=!0):(N!=null&&I(E,K,C(N),C(W),C(Y),C(H)),Me!=null?(H=Me,S(E,ge,C(H)),N=W=Y=H):(N=W=null,Me===null&&(V=!0)),K=ge,he=z(K+T))}N!=null&&N!=W&&ae!=K&&I(E,K,C(N),C(W),C(Y),C(H))}else for(let z=T==1?s:r;z>=s&&z<=r;z+=T){let N=l[z];N===null?V=!0:N!=null&&S(E,v(a[z]),C(N))}let[L,G]=Tf(t,i);if(o.fill!=null||L!=0){let z=y.fill=new Path2D(E),N=o.fillTo(t,i,o.min,o.max,L),W=C(N),Y=v(a[s]),H=v(a[r]);T==-1&&([H,Y]=[Y,H]),S(z,H,W),S(z,Y,W)}if(!o.spanGaps){let z=[];V&&z.push(...Ef(a,l,s,r,T,v,e)),y.gaps=z=o.gaps(t,i,s,r,z),y.clip=kc(z,c.ori,d,p,b,m)}return G!=0&&(y.band=G==2?[Gs(t,i,s,r,E,-1),Gs(t,i,s,r,E,1)]:Gs(t,i,s,r,E,G)),y})}function RM(n){let e=Rt(n.align,1),t=Rt(n.ascDesc,!1),i=Rt(n.alignGaps,0),s=Rt(n.extend,!1);return(r,o,a,l)=>so(r,o,(c,u,f,h,d,p,b,m,_,v,C)=>{[a,l]=Nc(f,a,l);let S=c.pxRound,{left:I,width:T}=r.bbox,y=$=>S(p($,h,v,m)),E=$=>S(b($,d,C,_)),V=h.ori==0?zo:Vo,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ko},L=U.stroke,G=h.dir*(h.ori==0?1:-1),z=E(f[G==1?a:l]),N=y(u[G==1?a:l]),W=N,Y=N;s&&e==-1&&(Y=I,V(L,Y,z)),V(L,N,z);for(let $=G==1?a:l;$>=a&&$<=l;$+=G){let ee=f[$];if(ee==null)continue;let he=y(u[$]),de=E(ee);e==1?V(L,he,z):V(L,W,de),V(L,he,de),z=de,W=he}let H=W;s&&e==1&&(H=I+T,V(L,H,z));let[ae,K]=Tf(r,o);if(c.fill!=null||ae!=0){let $=U.fill=new Path2D(L),ee=c.fillTo(r,o,c.min,c.max,ae),he=E(ee);V($,H,he),V($,Y,he)}if(!c.spanGaps){let $=[];$.push(...Ef(u,f,a,l,G,y,i));let ee=c.width*Dt/2,he=t||e==1?ee:-ee,de=t||e==-1?-ee:ee;$.forEach(te=>{te[0]+=he,te[1]+=de}),U.gaps=$=c.gaps(r,o,a,l,$),U.clip=kc($,h.ori,m,_,v,C)}return K!=0&&(U.band=K==2?[Gs(r,o,a,l,L,-1),Gs(r,o,a,l,L,1)]:Gs(r,o,a,l,L,K)),U})}function w0(n,e,t,i,s,r,o=Yt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Ln(n[l]-n[a]);u<c&&(c=u,o=Ln(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function PM(n){n=n||el;let e=Rt(n.size,[.6,Yt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=Rt(e[1],Yt),l=Rt(e[2],1),c=Rt(n.disp,el),u=Rt(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,b,m)=>so(d,p,(_,v,C,S,I,T,y,E,V,U,L)=>{let G=_.pxRound,z=t,N=i*Dt,W=a*Dt,Y=l*Dt,H,ae;S.ori==0?[H,ae]=r(d,p):[ae,H]=r(d,p);let K=S.dir*(S.ori==0?1:-1),$=S.ori==0?Vc:Cf,ee=S.ori==0?u:(Pe,Ze,ct,we,qt,We,Je)=>{u(Pe,Ze,ct,qt,we,Je,We)},he=Rt(d.bands,bf).find(Pe=>Pe.series[0]==p),de=he!=null?he.dir:0,te=_.fillTo(d,p,_.min,_.max,de),me=G(y(te,I,L,V)),ge,Me,be,Xe=U,rt=G(_.width*Dt),He=!1,ht=null,Ne=null,Ge=null,Bt=null;f!=null&&(rt==0||h!=null)&&(He=!0,ht=f.values(d,p,b,m),Ne=new Map,new Set(ht).forEach(Pe=>{Pe!=null&&Ne.set(Pe,new Path2D)}),rt>0&&(Ge=h.values(d,p,b,m),Bt=new Map,new Set(Ge).forEach(Pe=>{Pe!=null&&Bt.set(Pe,new Path2D)})));let{x0:Wt,size:xn}=c;if(Wt!=null&&xn!=null){z=1,v=Wt.values(d,p,b,m),Wt.unit==2&&(v=v.map(ct=>d.posToVal(E+ct*U,S.key,!0)));let Pe=xn.values(d,p,b,m);xn.unit==2?Me=Pe[0]*U:Me=T(Pe[0],S,U,E)-T(0,S,U,E),Xe=w0(v,C,T,S,U,E,Xe),be=Xe-Me+N}else Xe=w0(v,C,T,S,U,E,Xe),be=Xe*o+N,Me=Xe-be;be<1&&(be=0),rt>=Me/2&&(rt=0),be<5&&(G=D0);let Xt=be>0,Fn=Xe-be-(Xt?rt:0);Me=G(cf(Fn,Y,W)),ge=(z==0?Me/2:z==K?0:Me)-z*K*((z==0?N/2:0)+(Xt?rt/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Cn=He?null:new Path2D,an=null;if(he!=null)an=d.data[he.series[1]];else{let{y0:Pe,y1:Ze}=c;Pe!=null&&Ze!=null&&(C=Ze.values(d,p,b,m),an=Pe.values(d,p,b,m))}let yn=H*Me,F=ae*Me;for(let Pe=K==1?b:m;Pe>=b&&Pe<=m;Pe+=K){let Ze=C[Pe];if(Ze==null)continue;if(an!=null){let q=an[Pe]??0;if(Ze-q==0)continue;me=y(q,I,L,V)}let ct=S.distr!=2||c!=null?v[Pe]:Pe,we=T(ct,S,U,E),qt=y(Rt(Ze,te),I,L,V),We=G(we-ge),Je=G(hi(qt,me)),R=G(es(qt,me)),M=Je-R;if(Ze!=null){let q=Ze<0?F:yn,ue=Ze<0?yn:F;He?(rt>0&&Ge[Pe]!=null&&$(Bt.get(Ge[Pe]),We,R+Ii(rt/2),Me,hi(0,M-rt),q,ue),ht[Pe]!=null&&$(Ne.get(ht[Pe]),We,R+Ii(rt/2),Me,hi(0,M-rt),q,ue)):$(Cn,We,R+Ii(rt/2),Me,hi(0,M-rt),q,ue),ee(d,p,Pe,We-rt/2,R,Me+rt,M)}}return rt>0?bt.stroke=He?Bt:Cn:He||(bt._fill=_.width==0?_._fill:_._stroke??_._fill,bt.width=0),bt.fill=He?Ne:Cn,bt})}function IM(n,e){let t=Rt(e?.alignGaps,0);return(i,s,r,o)=>so(i,s,(a,l,c,u,f,h,d,p,b,m,_)=>{[r,o]=Nc(c,r,o);let v=a.pxRound,C=H=>v(h(H,u,m,p)),S=H=>v(d(H,f,_,b)),I,T,y;u.ori==0?(I=Bc,y=zo,T=o_):(I=zc,y=Vo,T=a_);let E=u.dir*(u.ori==0?1:-1),V=C(l[E==1?r:o]),U=V,L=[],G=[];for(let H=E==1?r:o;H>=r&&H<=o;H+=E)if(c[H]!=null){let K=l[H],$=C(K);L.push(U=$),G.push(S(c[H]))}let z={stroke:n(L,G,I,y,T,v),fill:null,clip:null,band:null,gaps:null,flags:ko},N=z.stroke,[W,Y]=Tf(i,s);if(a.fill!=null||W!=0){let H=z.fill=new Path2D(N),ae=a.fillTo(i,s,a.min,a.max,W),K=S(ae);y(H,U,K),y(H,V,K)}if(!a.spanGaps){let H=[];H.push(...Ef(l,c,r,o,E,C,t)),z.gaps=H=a.gaps(i,s,r,o,H),z.clip=kc(H,u.ori,p,b,m,_)}return Y!=0&&(z.band=Y==2?[Gs(i,s,r,o,N,-1),Gs(i,s,r,o,N,1)]:Gs(i,s,r,o,N,Y)),z})}function LM(n){return IM(DM,n)}function DM(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var ff=new Set;function A0(){for(let n of ff)n.syncRect(!0)}Bo&&(no(fS,No,A0),no(pS,No,A0,!0),no(Ic,No,()=>{Jn.pxRatio=Dt}));var NM=u_(),UM=l_();function T0(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>pf(r,o,e,t))}function OM(n,e){return n.map((t,i)=>i==0?{}:Tn({},e,t))}function pf(n,e,t,i){return Tn({},e==0?t:i,n)}function h_(n,e,t){return e==null?Oo:[e,t]}var FM=h_;function kM(n,e,t){return e==null?Oo:Lc(e,t,yf,!0)}function d_(n,e,t,i){return e==null?Oo:Uc(e,t,n.scales[i].log,!1)}var BM=d_;function f_(n,e,t,i){return e==null?Oo:xf(e,t,n.scales[i].log,!1)}var zM=f_;function VM(n,e,t,i,s){let r=hi(s0(n),s0(e)),o=e-n,a=Qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?br.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function E0(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=In((t=+s)*Dt))+"px"),[n,e,t]}function HM(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Jt(e[2]*Dt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Jn(n,e,t){let i={mode:Rt(n.mode,1)},s=i.mode;function r(x,w,P,D){let X=w.valToPct(x);return D+P*(w.dir==-1?1-X:X)}function o(x,w,P,D){let X=w.valToPct(x);return D+P*(w.dir==-1?X:1-X)}function a(x,w,P,D){return w.ori==0?r(x,w,P,D):o(x,w,P,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Hi(Jb);if(n.id!=null&&(c.id=n.id),Pi(c,n.class),n.title){let x=Hi(jb,c);x.textContent=n.title}let u=ji("canvas"),f=i.ctx=u.getContext("2d"),h=Hi(Qb,c);no("click",h,x=>{x.target===p&&(Zt!=Eo||nn!=Co)&&Yn.click(i,x)},!0);let d=i.under=Hi(eS,h);h.appendChild(u);let p=i.over=Hi(tS,h);n=Fo(n);let b=+Rt(n.pxAlign,1),m=M0(b);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let _=n.ms||.001,v=i.series=s==1?T0(n.series||[],g0,b0,!1):OM(n.series||[null],v0),C=i.axes=T0(n.axes||[],m0,x0,!0),S=i.scales={},I=i.bands=n.bands||[];I.forEach(x=>{x.fill=yt(x.fill||null),x.dir=Rt(x.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,y={axes:Us,series:gt},E=(n.drawOrder||["axes","series"]).map(x=>y[x]);function V(x){let w=x.distr==3?P=>Hs(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>ef(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let D=w(P),{_min:X,_max:j}=x,le=j-X;return(D-X)/le}}function U(x){let w=S[x];if(w==null){let P=(n.scales||el)[x]||el;if(P.from!=null){U(P.from);let D=Tn({},S[P.from],P,{key:x});D.valToPct=V(D),S[x]=D}else{w=S[x]=Tn({},x==T?t_:wM,P),w.key=x;let D=w.time,X=w.range,j=vr(X);if((x!=T||s==2&&!D)&&(j&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?t0:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?t0:{mode:1,hard:X[1],soft:X[1]}},j=!1),!j&&Fc(X))){let le=X;X=(fe,ve,Ue)=>ve==null?Oo:Lc(ve,Ue,le)}w.range=yt(X||(D?FM:x==T?w.distr==3?BM:w.distr==4?zM:h_:w.distr==3?d_:w.distr==4?f_:kM)),w.auto=yt(j?!1:w.auto),w.clamp=yt(w.clamp||MM),w._min=w._max=null,w.valToPct=V(w)}}}U("x"),U("y"),s==1&&v.forEach(x=>{U(x.scale)}),C.forEach(x=>{U(x.scale)});for(let x in n.scales)U(x);let L=S[T],G=L.distr,z,N;L.ori==0?(Pi(c,Kb),z=r,N=o):(Pi(c,Zb),z=o,N=r);let W={};for(let x in S){let w=S[x];(w.min!=null||w.max!=null)&&(W[x]={min:w.min,max:w.max},w.min=w.max=null)}let Y=n.tzDate||(x=>new Date(In(x/_))),H=n.fmtDate||Sf,ae=_==1?KS(Y):QS(Y),K=d0(Y,h0(_==1?JS:jS,H)),$=p0(Y,f0(tM,H)),ee=[],he=i.legend=Tn({},sM,n.legend),de=i.cursor=Tn({},uM,{drag:{y:s==2}},n.cursor),te=he.show,me=de.show,ge=he.markers;he.idxs=ee,ge.width=yt(ge.width),ge.dash=yt(ge.dash),ge.stroke=yt(ge.stroke),ge.fill=yt(ge.fill);let Me,be,Xe,rt=[],He=[],ht,Ne=!1,Ge={};if(he.live){let x=v[1]?v[1].values:null;Ne=x!=null,ht=Ne?x(i,1,0):{_:0};for(let w in ht)Ge[w]=gf}if(te)if(Me=ji("table",aS,c),Xe=ji("tbody",null,Me),he.mount(i,Me),Ne){be=ji("thead",null,Me,Xe);let x=ji("tr",null,be);ji("th",null,x);for(var Bt in ht)ji("th",Hg,x).textContent=Bt}else Pi(Me,cS),he.live&&Pi(Me,lS);let Wt={show:!0},xn={show:!1};function Xt(x,w){if(w==0&&(Ne||!he.live||s==2))return Oo;let P=[],D=ji("tr",uS,Xe,Xe.childNodes[w]);Pi(D,x.class),x.show||Pi(D,to);let X=ji("th",null,D);if(ge.show){let fe=Hi(hS,X);if(w>0){let ve=ge.width(i,w);ve&&(fe.style.border=ve+"px "+ge.dash(i,w)+" "+ge.stroke(i,w)),fe.style.background=ge.fill(i,w)}}let j=Hi(Hg,X);x.label instanceof HTMLElement?j.appendChild(x.label):j.textContent=x.label,w>0&&(ge.show||(j.style.color=x.width>0?ge.stroke(i,w):ge.fill(i,w)),bt("click",X,fe=>{if(de._lock)return;tt(fe);let ve=v.indexOf(x);if((fe.ctrlKey||fe.metaKey)!=he.isolate){let Ue=v.some((Oe,ke)=>ke>0&&ke!=ve&&Oe.show);v.forEach((Oe,ke)=>{ke>0&&gs(ke,Ue?ke==ve?Wt:xn:Wt,!0,Mn.setSeries)})}else gs(ve,{show:!x.show},!0,Mn.setSeries)},!1),nt&&bt($g,X,fe=>{de._lock||(tt(fe),gs(v.indexOf(x),Po,!0,Mn.setSeries))},!1));for(var le in ht){let fe=ji("td",dS,D);fe.textContent="--",P.push(fe)}return[D,P]}let Fn=new Map;function bt(x,w,P,D=!0){let X=Fn.get(w)||{},j=de.bind[x](i,w,P,D);j&&(no(x,w,X[x]=j),Fn.set(w,X))}function Cn(x,w,P){let D=Fn.get(w)||{};for(let X in D)(x==null||X==x)&&(lf(X,w,D[X]),delete D[X]);x==null&&Fn.delete(w)}let an=0,yn=0,F=0,Pe=0,Ze=0,ct=0,we=Ze,qt=ct,We=F,Je=Pe,R=0,M=0,q=0,ue=0;i.bbox={};let oe=!1,xe=!1,ye=!1,ne=!1,se=!1,pe=!1;function O(x,w,P){(P||x!=i.width||w!=i.height)&&re(x,w),ft(!1),ye=!0,xe=!0,ei()}function re(x,w){i.width=an=F=x,i.height=yn=Pe=w,Ze=ct=0,Se(),$e();let P=i.bbox;R=P.left=Qr(Ze*Dt,.5),M=P.top=Qr(ct*Dt,.5),q=P.width=Qr(F*Dt,.5),ue=P.height=Qr(Pe*Dt,.5)}let ie=3;function Ae(){let x=!1,w=0;for(;!x;){w++;let P=wo(w),D=ms(w);x=w==ie||P&&D,x||(re(i.width,i.height),xe=!0)}}function _e({width:x,height:w}){O(x,w)}i.setSize=_e;function Se(){let x=!1,w=!1,P=!1,D=!1;C.forEach((X,j)=>{if(X.show&&X._show){let{side:le,_size:fe}=X,ve=le%2,Ue=X.label!=null?X.labelSize:0,Oe=fe+Ue;Oe>0&&(ve?(F-=Oe,le==3?(Ze+=Oe,D=!0):P=!0):(Pe-=Oe,le==0?(ct+=Oe,x=!0):w=!0))}}),fs[0]=x,fs[1]=P,fs[2]=w,fs[3]=D,F-=Yi[1]+Yi[3],Ze+=Yi[3],Pe-=Yi[2]+Yi[0],ct+=Yi[0]}function $e(){let x=Ze+F,w=ct+Pe,P=Ze,D=ct;function X(j,le){switch(j){case 1:return x+=le,x-le;case 2:return w+=le,w-le;case 3:return P-=le,P+le;case 0:return D-=le,D+le}}C.forEach((j,le)=>{if(j.show&&j._show){let fe=j.side;j._pos=X(fe,j._size),j.label!=null&&(j._lpos=X(fe,j.labelSize))}})}if(de.dataIdx==null){let x=de.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let P=x.prox=yt(x.prox),D=x.bias??=0;de.dataIdx=(X,j,le,fe)=>{if(j==0)return le;let ve=le,Ue=P(X,j,le,fe)??Yt,Oe=Ue>=0&&Ue<Yt,ke=L.ori==0?F:Pe,at=de.left,It=e[0],At=e[j];if(w.has(At[le])){ve=null;let _t=null,Qe=null,Ye;if(D==0||D==-1)for(Ye=le;_t==null&&Ye-- >0;)w.has(At[Ye])||(_t=Ye);if(D==0||D==1)for(Ye=le;Qe==null&&Ye++<At.length;)w.has(At[Ye])||(Qe=Ye);if(_t!=null||Qe!=null)if(Oe){let Qt=_t==null?-1/0:z(It[_t],L,ke,0),un=Qe==null?1/0:z(It[Qe],L,ke,0),Vn=at-Qt,$t=un-at;Vn<=$t?Vn<=Ue&&(ve=_t):$t<=Ue&&(ve=Qe)}else ve=Qe==null?_t:_t==null?Qe:le-_t<=Qe-le?_t:Qe}else Oe&&Ln(at-z(It[le],L,ke,0))>Ue&&(ve=null);return ve}}let tt=x=>{de.event=x};de.idxs=ee,de._lock=!1;let ce=de.points;ce.show=yt(ce.show),ce.size=yt(ce.size),ce.stroke=yt(ce.stroke),ce.width=yt(ce.width),ce.fill=yt(ce.fill);let Be=i.focus=Tn({},n.focus||{alpha:.3},de.focus),nt=Be.prox>=0,Ce=nt&&ce.one,dt=[],Kt=[],oi=[];function Na(x,w){let P=ce.show(i,w);if(P instanceof HTMLElement)return Pi(P,oS),Pi(P,x.class),vs(P,-10,-10,F,Pe),p.insertBefore(P,dt[w]),P}function bo(x,w){if(s==1||w>0){let P=s==1&&S[x.scale].time,D=x.value;x.value=P?a0(D)?p0(Y,f0(D,H)):D||$:D||vM,x.label=x.label||(P?dM:hM)}if(Ce||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||NM||wS,x.fillTo=yt(x.fillTo||AM),x.pxAlign=+Rt(x.pxAlign,b),x.pxRound=M0(x.pxAlign),x.stroke=yt(x.stroke||null),x.fill=yt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=bM(hi(1,x.width),1),D=x.points=Tn({},{size:P,width:hi(1,P*.2),stroke:x.stroke,space:P*2,paths:UM,_stroke:null,_fill:null},x.points);D.show=yt(D.show),D.filter=yt(D.filter),D.fill=yt(D.fill),D.stroke=yt(D.stroke),D.paths=yt(D.paths),D.pxAlign=x.pxAlign}if(te){let P=Xt(x,w);rt.splice(w,0,P[0]),He.splice(w,0,P[1]),he.values.push(null)}if(me){ee.splice(w,0,null);let P=null;Ce?w==0&&(P=Na(x,w)):w>0&&(P=Na(x,w)),dt.splice(w,0,P),Kt.splice(w,0,0),oi.splice(w,0,0)}zn("addSeries",w)}function Md(x,w){w=w??v.length,x=s==1?pf(x,w,g0,b0):pf(x,w,{},v0),v.splice(w,0,x),bo(v[w],w)}i.addSeries=Md;function sc(x){if(v.splice(x,1),te){he.values.splice(x,1),He.splice(x,1);let w=rt.splice(x,1)[0];Cn(null,w.firstChild),w.remove()}me&&(ee.splice(x,1),dt.splice(x,1)[0].remove(),Kt.splice(x,1),oi.splice(x,1)),zn("delSeries",x)}i.delSeries=sc;let fs=[!1,!1,!1,!1];function Ls(x,w){if(x._show=x.show,x.show){let P=x.side%2,D=S[x.scale];D==null&&(x.scale=P?v[1].scale:T,D=S[x.scale]);let X=D.time;x.size=yt(x.size),x.space=yt(x.space),x.rotate=yt(x.rotate),vr(x.incrs)&&x.incrs.forEach(le=>{!br.has(le)&&br.set(le,O0(le))}),x.incrs=yt(x.incrs||(D.distr==2?$S:X?_==1?YS:ZS:eo)),x.splits=yt(x.splits||(X&&D.distr==1?ae:D.distr==3?uf:D.distr==4?mM:pM)),x.stroke=yt(x.stroke),x.grid.stroke=yt(x.grid.stroke),x.ticks.stroke=yt(x.ticks.stroke),x.border.stroke=yt(x.border.stroke);let j=x.values;x.values=vr(j)&&!vr(j[0])?yt(j):X?vr(j)?d0(Y,h0(j,H)):a0(j)?eM(Y,j):j||K:j||fM,x.filter=yt(x.filter||(D.distr>=3&&D.log==10?xM:D.distr==3&&D.log==2?yM:N0)),x.font=E0(x.font),x.labelFont=E0(x.labelFont),x._size=x.size(i,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(fs[w]=!0,x._el=Hi(nS,h))}}function Ds(x,w,P,D){let[X,j,le,fe]=P,ve=w%2,Ue=0;return ve==0&&(fe||j)&&(Ue=w==0&&!X||w==2&&!le?In(m0.size/3):0),ve==1&&(X||le)&&(Ue=w==1&&!j||w==3&&!fe?In(x0.size/2):0),Ue}let Ua=i.padding=(n.padding||[Ds,Ds,Ds,Ds]).map(x=>yt(Rt(x,Ds))),Yi=i._padding=Ua.map((x,w)=>x(i,w,fs,0)),ln,fn=null,pn=null,ps=s==1?v[0].idxs:null,Ai=null,ur=!1;function Oa(x,w){if(e=x??[],i.data=i._data=e,s==2){ln=0;for(let P=1;P<v.length;P++)ln+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Ai=e[0],ln=Ai.length;let P=e;if(G==2){P=e.slice();let D=P[0]=Array(ln);for(let X=0;X<ln;X++)D[X]=X}i._data=e=P}if(ft(!0),zn("setData"),G==2&&(ye=!0),w!==!1){let P=L;P.auto(i,ur)?Fa():fr(T,P.min,P.max),ne=ne||de.left>=0,pe=!0,ei()}}i.setData=Oa;function Fa(){ur=!0;let x,w;s==1&&(ln>0?(fn=ps[0]=0,pn=ps[1]=ln-1,x=e[0][fn],w=e[0][pn],G==2?(x=fn,w=pn):x==w&&(G==3?[x,w]=Uc(x,x,L.log,!1):G==4?[x,w]=xf(x,x,L.log,!1):L.time?w=x+In(86400/_):[x,w]=Lc(x,w,yf,!0))):(fn=ps[0]=x=null,pn=ps[1]=w=null)),fr(T,x,w)}let So,hr,Mo,A,B,Q,J,Z,Te,Le;function Ee(x,w,P,D,X,j){x??=Wg,P??=bf,D??="butt",X??=Wg,j??="round",x!=So&&(f.strokeStyle=So=x),X!=hr&&(f.fillStyle=hr=X),w!=Mo&&(f.lineWidth=Mo=w),j!=B&&(f.lineJoin=B=j),D!=Q&&(f.lineCap=Q=D),P!=A&&f.setLineDash(A=P)}function De(x,w,P,D){w!=hr&&(f.fillStyle=hr=w),x!=J&&(f.font=J=x),P!=Z&&(f.textAlign=Z=P),D!=Te&&(f.textBaseline=Te=D)}function Ve(x,w,P,D,X=0){if(D.length>0&&x.auto(i,ur)&&(w==null||w.min==null)){let j=Rt(fn,0),le=Rt(pn,D.length-1),fe=P.min==null?xS(D,j,le,X,x.distr==3):[P.min,P.max];x.min=es(x.min,P.min=fe[0]),x.max=hi(x.max,P.max=fe[1])}}let it={min:null,max:null};function mt(){for(let D in S){let X=S[D];W[D]==null&&(X.min==null||W[T]!=null&&X.auto(i,ur))&&(W[D]=it)}for(let D in S){let X=S[D];W[D]==null&&X.from!=null&&W[X.from]!=null&&(W[D]=it)}W[T]!=null&&ft(!0);let x={};for(let D in W){let X=W[D];if(X!=null){let j=x[D]=Fo(S[D],ES);if(X.min!=null)Tn(j,X);else if(D!=T||s==2)if(ln==0&&j.from==null){let le=j.range(i,null,null,D);j.min=le[0],j.max=le[1]}else j.min=Yt,j.max=-Yt}}if(ln>0){v.forEach((D,X)=>{if(s==1){let j=D.scale,le=W[j];if(le==null)return;let fe=x[j];if(X==0){let ve=fe.range(i,fe.min,fe.max,j);fe.min=ve[0],fe.max=ve[1],fn=Qi(fe.min,e[0]),pn=Qi(fe.max,e[0]),pn-fn>1&&(e[0][fn]<fe.min&&fn++,e[0][pn]>fe.max&&pn--),D.min=Ai[fn],D.max=Ai[pn]}else D.show&&D.auto&&Ve(fe,le,D,e[X],D.sorted);D.idxs[0]=fn,D.idxs[1]=pn}else if(X>0&&D.show&&D.auto){let[j,le]=D.facets,fe=j.scale,ve=le.scale,[Ue,Oe]=e[X],ke=x[fe],at=x[ve];ke!=null&&Ve(ke,W[fe],j,Ue,j.sorted),at!=null&&Ve(at,W[ve],le,Oe,le.sorted),D.min=le.min,D.max=le.max}});for(let D in x){let X=x[D],j=W[D];if(X.from==null&&(j==null||j.min==null)){let le=X.range(i,X.min==Yt?null:X.min,X.max==-Yt?null:X.max,D);X.min=le[0],X.max=le[1]}}}for(let D in x){let X=x[D];if(X.from!=null){let j=x[X.from];if(j.min==null)X.min=X.max=null;else{let le=X.range(i,j.min,j.max,D);X.min=le[0],X.max=le[1]}}}let w={},P=!1;for(let D in x){let X=x[D],j=S[D];if(j.min!=X.min||j.max!=X.max){j.min=X.min,j.max=X.max;let le=j.distr;j._min=le==3?Hs(j.min):le==4?ef(j.min,j.asinh):le==100?j.fwd(j.min):j.min,j._max=le==3?Hs(j.max):le==4?ef(j.max,j.asinh):le==100?j.fwd(j.max):j.max,w[D]=P=!0}}if(P){v.forEach((D,X)=>{s==2?X>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)ye=!0,zn("setScale",D);me&&de.left>=0&&(ne=pe=!0)}for(let D in W)W[D]=null}function ze(x){let w=cf(fn-1,0,ln-1),P=cf(pn+1,0,ln-1);for(;x[w]==null&&w>0;)w--;for(;x[P]==null&&P<ln-1;)P++;return[w,P]}function gt(){if(ln>0){let x=v.some(w=>w._focus)&&Le!=Be.alpha;x&&(f.globalAlpha=Le=Be.alpha),v.forEach((w,P)=>{if(P>0&&w.show&&(on(P,!1),on(P,!0),w._paths==null)){let D=Le;Le!=w.alpha&&(f.globalAlpha=Le=w.alpha);let X=s==2?[0,e[P][0].length-1]:ze(e[P]);w._paths=w.paths(i,P,X[0],X[1]),Le!=D&&(f.globalAlpha=Le=D)}}),v.forEach((w,P)=>{if(P>0&&w.show){let D=Le;Le!=w.alpha&&(f.globalAlpha=Le=w.alpha),w._paths!=null&&zt(P,!1);{let X=w._paths!=null?w._paths.gaps:null,j=w.points.show(i,P,fn,pn,X),le=w.points.filter(i,P,j,X);(j||le)&&(w.points._paths=w.points.paths(i,P,fn,pn,le),zt(P,!0))}Le!=D&&(f.globalAlpha=Le=D),zn("drawSeries",P)}}),x&&(f.globalAlpha=Le=1)}}function on(x,w){let P=w?v[x].points:v[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function zt(x,w){let P=w?v[x].points:v[x],{stroke:D,fill:X,clip:j,flags:le,_stroke:fe=P._stroke,_fill:ve=P._fill,_width:Ue=P.width}=P._paths;Ue=Jt(Ue*Dt,3);let Oe=null,ke=Ue%2/2;w&&ve==null&&(ve=Ue>0?"#fff":fe);let at=P.pxAlign==1&&ke>0;if(at&&f.translate(ke,ke),!w){let It=R-Ue/2,At=M-Ue/2,_t=q+Ue,Qe=ue+Ue;Oe=new Path2D,Oe.rect(It,At,_t,Qe)}w?Fe(fe,Ue,P.dash,P.cap,ve,D,X,le,j):Vt(x,fe,Ue,P.dash,P.cap,ve,D,X,le,Oe,j),at&&f.translate(-ke,-ke)}function Vt(x,w,P,D,X,j,le,fe,ve,Ue,Oe){let ke=!1;ve!=0&&I.forEach((at,It)=>{if(at.series[0]==x){let At=v[at.series[1]],_t=e[at.series[1]],Qe=(At._paths||el).band;vr(Qe)&&(Qe=at.dir==1?Qe[0]:Qe[1]);let Ye,Qt=null;At.show&&Qe&&vS(_t,fn,pn)?(Qt=at.fill(i,It)||j,Ye=At._paths.clip):Qe=null,Fe(w,P,D,X,Qt,le,fe,ve,Ue,Oe,Ye,Qe),ke=!0}}),ke||Fe(w,P,D,X,j,le,fe,ve,Ue,Oe)}let Rn=ko|df;function Fe(x,w,P,D,X,j,le,fe,ve,Ue,Oe,ke){Ee(x,w,P,D,X),(ve||Ue||ke)&&(f.save(),ve&&f.clip(ve),Ue&&f.clip(Ue)),ke?(fe&Rn)==Rn?(f.clip(ke),Oe&&f.clip(Oe),xt(X,le),vn(x,j,w)):fe&df?(xt(X,le),f.clip(ke),vn(x,j,w)):fe&ko&&(f.save(),f.clip(ke),Oe&&f.clip(Oe),xt(X,le),f.restore(),vn(x,j,w)):(xt(X,le),vn(x,j,w)),(ve||Ue||ke)&&f.restore()}function vn(x,w,P){P>0&&(w instanceof Map?w.forEach((D,X)=>{f.strokeStyle=So=X,f.stroke(D)}):w!=null&&x&&f.stroke(w))}function xt(x,w){w instanceof Map?w.forEach((P,D)=>{f.fillStyle=hr=D,f.fill(P)}):w!=null&&x&&f.fill(w)}function Ns(x,w,P,D){let X=C[x],j;if(D<=0)j=[0,0];else{let le=X._space=X.space(i,x,w,P,D),fe=X._incrs=X.incrs(i,x,w,P,D,le);j=VM(w,P,fe,D,le)}return X._found=j}function bn(x,w,P,D,X,j,le,fe,ve,Ue){let Oe=le%2/2;b==1&&f.translate(Oe,Oe),Ee(fe,le,ve,Ue,fe),f.beginPath();let ke,at,It,At,_t=X+(D==0||D==3?-j:j);P==0?(at=X,At=_t):(ke=X,It=_t);for(let Qe=0;Qe<x.length;Qe++)w[Qe]!=null&&(P==0?ke=It=x[Qe]:at=At=x[Qe],f.moveTo(ke,at),f.lineTo(It,At));f.stroke(),b==1&&f.translate(-Oe,-Oe)}function wo(x){let w=!0;return C.forEach((P,D)=>{if(!P.show)return;let X=S[P.scale];if(X.min==null){P._show&&(w=!1,P._show=!1,ft(!1));return}else P._show||(w=!1,P._show=!0,ft(!1));let j=P.side,le=j%2,{min:fe,max:ve}=X,[Ue,Oe]=Ns(D,fe,ve,le==0?F:Pe);if(Oe==0)return;let ke=X.distr==2,at=P._splits=P.splits(i,D,fe,ve,Ue,Oe,ke),It=X.distr==2?at.map(Ye=>Ai[Ye]):at,At=X.distr==2?Ai[at[1]]-Ai[at[0]]:Ue,_t=P._values=P.values(i,P.filter(i,It,D,Oe,At),D,Oe,At);P._rotate=j==2?P.rotate(i,_t,D,Oe):0;let Qe=P._size;P._size=Gi(P.size(i,_t,D,x)),Qe!=null&&P._size!=Qe&&(w=!1)}),w}function ms(x){let w=!0;return Ua.forEach((P,D)=>{let X=P(i,D,fs,x);X!=Yi[D]&&(w=!1),Yi[D]=X}),w}function Us(){for(let x=0;x<C.length;x++){let w=C[x];if(!w.show||!w._show)continue;let P=w.side,D=P%2,X,j,le=w.stroke(i,x),fe=P==0||P==3?-1:1,[ve,Ue]=w._found;if(w.label!=null){let ci=w.labelGap*fe,Ci=In((w._lpos+ci)*Dt);De(w.labelFont[0],le,"center",P==2?"top":Gg),f.save(),D==1?(X=j=0,f.translate(Ci,In(M+ue/2)),f.rotate((P==3?-Pc:Pc)/2)):(X=In(R+q/2),j=Ci);let Jr=L0(w.label)?w.label(i,x,ve,Ue):w.label;f.fillText(Jr,X,j),f.restore()}if(Ue==0)continue;let Oe=S[w.scale],ke=D==0?q:ue,at=D==0?R:M,It=w._splits,At=Oe.distr==2?It.map(ci=>Ai[ci]):It,_t=Oe.distr==2?Ai[It[1]]-Ai[It[0]]:ve,Qe=w.ticks,Ye=w.border,Qt=Qe.show?Qe.size:0,un=In(Qt*Dt),Vn=In((w.alignTo==2?w._size-Qt-w.gap:w.gap)*Dt),$t=w._rotate*-Pc/180,hn=m(w._pos*Dt),Ti=(un+Vn)*fe,li=hn+Ti;j=D==0?li:0,X=D==1?li:0;let Bi=w.font[0],Ji=w.align==1?Lo:w.align==2?Zd:$t>0?Lo:$t<0?Zd:D==0?"center":P==3?Zd:Lo,xs=$t||D==1?"middle":P==2?"top":Gg;De(Bi,le,Ji,xs);let Ei=w.font[1]*w.lineGap,zi=It.map(ci=>m(a(ci,Oe,ke,at))),Ki=w._values;for(let ci=0;ci<Ki.length;ci++){let Ci=Ki[ci];if(Ci!=null){D==0?X=zi[ci]:j=zi[ci],Ci=""+Ci;let Jr=Ci.indexOf(`
`)==-1?[Ci]:Ci.split(/\n/gm);for(let ui=0;ui<Jr.length;ui++){let ng=Jr[ui];$t?(f.save(),f.translate(X,j+ui*Ei),f.rotate($t),f.fillText(ng,0,0),f.restore()):f.fillText(ng,X,j+ui*Ei)}}}Qe.show&&bn(zi,Qe.filter(i,At,x,Ue,_t),D,P,hn,un,Jt(Qe.width*Dt,3),Qe.stroke(i,x),Qe.dash,Qe.cap);let ys=w.grid;ys.show&&bn(zi,ys.filter(i,At,x,Ue,_t),D,D==0?2:1,D==0?M:R,D==0?ue:q,Jt(ys.width*Dt,3),ys.stroke(i,x),ys.dash,ys.cap),Ye.show&&bn([hn],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:q,Jt(Ye.width*Dt,3),Ye.stroke(i,x),Ye.dash,Ye.cap)}zn("drawAxes")}function ft(x){v.forEach((w,P)=>{P>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let cn=!1,ai=!1,Ht=[];function Sn(){ai=!1;for(let x=0;x<Ht.length;x++)zn(...Ht[x]);Ht.length=0}function ei(){cn||(NS(km),cn=!0)}function rc(x,w=!1){cn=!0,ai=w,x(i),km(),w&&Ht.length>0&&queueMicrotask(Sn)}i.batch=rc;function km(){if(oe&&(mt(),oe=!1),ye&&(Ae(),ye=!1),xe){if(en(d,Lo,Ze),en(d,"top",ct),en(d,Ka,F),en(d,Za,Pe),en(p,Lo,Ze),en(p,"top",ct),en(p,Ka,F),en(p,Za,Pe),en(h,Ka,an),en(h,Za,yn),u.width=In(an*Dt),u.height=In(yn*Dt),C.forEach(({_el:x,_show:w,_size:P,_pos:D,side:X})=>{if(x!=null)if(w){let j=X===3||X===0?P:0,le=X%2==1;en(x,le?"left":"top",D-j),en(x,le?"width":"height",P),en(x,le?"top":"left",le?ct:Ze),en(x,le?"height":"width",le?Pe:F),af(x,to)}else Pi(x,to)}),So=hr=Mo=B=Q=J=Z=Te=A=null,Le=1,za(!0),Ze!=we||ct!=qt||F!=We||Pe!=Je){ft(!1);let x=F/We,w=Pe/Je;if(me&&!ne&&de.left>=0){de.left*=x,de.top*=w,Ao&&vs(Ao,In(de.left),0,F,Pe),To&&vs(To,0,In(de.top),F,Pe);for(let P=0;P<dt.length;P++){let D=dt[P];D!=null&&(Kt[P]*=x,oi[P]*=w,vs(D,Gi(Kt[P]),Gi(oi[P]),F,Pe))}}if(jt.show&&!se&&jt.left>=0&&jt.width>0){jt.left*=x,jt.width*=x,jt.top*=w,jt.height*=w;for(let P in Rd)en(Ro,P,jt[P])}we=Ze,qt=ct,We=F,Je=Pe}zn("setSize"),xe=!1}an>0&&yn>0&&(f.clearRect(0,0,u.width,u.height),zn("drawClear"),E.forEach(x=>x()),zn("draw")),jt.show&&se&&(oc(jt),se=!1),me&&ne&&(Yr(null,!0,!1),ne=!1),he.show&&he.live&&pe&&(Ed(),pe=!1),l||(l=!0,i.status=1,zn("ready")),ur=!1,cn=!1}i.redraw=(x,w)=>{ye=w||!1,x!==!1?fr(T,L.min,L.max):ei()};function wd(x,w){let P=S[x];if(P.from==null){if(ln==0){let D=P.range(i,w.min,w.max,x);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(ln>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==T&&P.distr==2&&ln>0&&(w.min=Qi(w.min,e[0]),w.max=Qi(w.max,e[0]),w.min==w.max&&w.max++),W[x]=w,oe=!0,ei()}}i.setScale=wd;let Ad,Td,Ao,To,Bm,zm,Eo,Co,Vm,Hm,Zt,nn,dr=!1,Yn=de.drag,kn=Yn.x,Bn=Yn.y;me&&(de.x&&(Ad=Hi(sS,p)),de.y&&(Td=Hi(rS,p)),L.ori==0?(Ao=Ad,To=Td):(Ao=Td,To=Ad),Zt=de.left,nn=de.top);let jt=i.select=Tn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),Ro=jt.show?Hi(iS,jt.over?p:d):null;function oc(x,w){if(jt.show){for(let P in x)jt[P]=x[P],P in Rd&&en(Ro,P,x[P]);w!==!1&&zn("setSelect")}}i.setSelect=oc;function xb(x){if(v[x].show)te&&af(rt[x],to);else if(te&&Pi(rt[x],to),me){let P=Ce?dt[0]:dt[x];P!=null&&vs(P,-10,-10,F,Pe)}}function fr(x,w,P){wd(x,{min:w,max:P})}function gs(x,w,P,D){w.focus!=null&&Mb(x),w.show!=null&&v.forEach((X,j)=>{j>0&&(x==j||x==null)&&(X.show=w.show,xb(j),s==2?(fr(X.facets[0].scale,null,null),fr(X.facets[1].scale,null,null)):fr(X.scale,null,null),ei())}),P!==!1&&zn("setSeries",x,w),D&&Va("setSeries",i,x,w)}i.setSeries=gs;function yb(x,w){Tn(I[x],w)}function vb(x,w){x.fill=yt(x.fill||null),x.dir=Rt(x.dir,-1),w=w??I.length,I.splice(w,0,x)}function bb(x){x==null?I.length=0:I.splice(x,1)}i.addBand=vb,i.setBand=yb,i.delBand=bb;function Sb(x,w){v[x].alpha=w,me&&dt[x]!=null&&(dt[x].style.opacity=w),te&&rt[x]&&(rt[x].style.opacity=w)}let Os,pr,qr,Po={focus:!0};function Mb(x){if(x!=qr){let w=x==null,P=Be.alpha!=1;v.forEach((D,X)=>{if(s==1||X>0){let j=w||X==0||X==x;D._focus=w?null:j,P&&Sb(X,j?1:Be.alpha)}}),qr=x,P&&ei()}}te&&nt&&bt(qg,Me,x=>{de._lock||(tt(x),qr!=null&&gs(null,Po,!0,Mn.setSeries))});function _s(x,w,P){let D=S[w];P&&(x=x/Dt-(D.ori==1?ct:Ze));let X=F;D.ori==1&&(X=Pe,x=X-x),D.dir==-1&&(x=X-x);let j=D._min,le=D._max,fe=x/X,ve=j+(le-j)*fe,Ue=D.distr;return Ue==3?Uo(10,ve):Ue==4?SS(ve,D.asinh):Ue==100?D.bwd(ve):ve}function wb(x,w){let P=_s(x,T,w);return Qi(P,e[0],fn,pn)}i.valToIdx=x=>Qi(x,e[0]),i.posToIdx=wb,i.posToVal=_s,i.valToPos=(x,w,P)=>S[w].ori==0?r(x,S[w],P?q:F,P?R:0):o(x,S[w],P?ue:Pe,P?M:0),i.setCursor=(x,w,P)=>{Zt=x.left,nn=x.top,Yr(null,w,P)};function Gm(x,w){en(Ro,Lo,jt.left=x),en(Ro,Ka,jt.width=w)}function Wm(x,w){en(Ro,"top",jt.top=x),en(Ro,Za,jt.height=w)}let ka=L.ori==0?Gm:Wm,Ba=L.ori==1?Gm:Wm;function Ab(){if(te&&he.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&Ne)continue;let w=he.values[x],P=0;for(let D in w)He[x][P++].firstChild.nodeValue=w[D]}}function Ed(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((P,D)=>{ee[D]=P}):TS(x.idx)||ee.fill(x.idx),he.idx=ee[0]),te&&he.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!Ne)&&Tb(P,ee[P]);Ab()}pe=!1,w!==!1&&zn("setLegend")}i.setLegend=Ed;function Tb(x,w){let P=v[x],D=x==0&&G==2?Ai:e[x],X;Ne?X=P.values(i,x,w)??Ge:(X=P.value(i,w==null?null:D[w],x,w),X=X==null?Ge:{_:X}),he.values[x]=X}function Yr(x,w,P){Vm=Zt,Hm=nn,[Zt,nn]=de.move(i,Zt,nn),de.left=Zt,de.top=nn,me&&(Ao&&vs(Ao,In(Zt),0,F,Pe),To&&vs(To,0,In(nn),F,Pe));let D,X=fn>pn;Os=Yt,pr=null;let j=L.ori==0?F:Pe,le=L.ori==1?F:Pe;if(Zt<0||ln==0||X){D=de.idx=null;for(let fe=0;fe<v.length;fe++){let ve=dt[fe];ve!=null&&vs(ve,-10,-10,F,Pe)}nt&&gs(null,Po,!0,x==null&&Mn.setSeries),he.live&&(ee.fill(D),pe=!0)}else{let fe,ve,Ue;s==1&&(fe=L.ori==0?Zt:nn,ve=_s(fe,T),D=de.idx=Qi(ve,e[0],fn,pn),Ue=z(e[0][D],L,j,0));let Oe=-10,ke=-10,at=0,It=0,At=!0,_t="",Qe="";for(let Ye=s==2?1:0;Ye<v.length;Ye++){let Qt=v[Ye],un=ee[Ye],Vn=un==null?null:s==1?e[Ye][un]:e[Ye][1][un],$t=de.dataIdx(i,Ye,D,ve),hn=$t==null?null:s==1?e[Ye][$t]:e[Ye][1][$t];if(pe=pe||hn!=Vn||$t!=un,ee[Ye]=$t,Ye>0&&Qt.show){let Ti=$t==null?-10:$t==D?Ue:z(s==1?e[0][$t]:e[Ye][0][$t],L,j,0),li=hn==null?-10:N(hn,s==1?S[Qt.scale]:S[Qt.facets[1].scale],le,0);if(nt&&hn!=null){let Bi=L.ori==1?Zt:nn,Ji=Ln(Be.dist(i,Ye,$t,li,Bi));if(Ji<Os){let xs=Be.bias;if(xs!=0){let Ei=_s(Bi,Qt.scale),zi=hn>=0?1:-1,Ki=Ei>=0?1:-1;Ki==zi&&(Ki==1?xs==1?hn>=Ei:hn<=Ei:xs==1?hn<=Ei:hn>=Ei)&&(Os=Ji,pr=Ye)}else Os=Ji,pr=Ye}}if(pe||Ce){let Bi,Ji;L.ori==0?(Bi=Ti,Ji=li):(Bi=li,Ji=Ti);let xs,Ei,zi,Ki,ys,ci,Ci=!0,Jr=ce.bbox;if(Jr!=null){Ci=!1;let ui=Jr(i,Ye);zi=ui.left,Ki=ui.top,xs=ui.width,Ei=ui.height}else zi=Bi,Ki=Ji,xs=Ei=ce.size(i,Ye);if(ci=ce.fill(i,Ye),ys=ce.stroke(i,Ye),Ce)Ye==pr&&Os<=Be.prox&&(Oe=zi,ke=Ki,at=xs,It=Ei,At=Ci,_t=ci,Qe=ys);else{let ui=dt[Ye];ui!=null&&(Kt[Ye]=zi,oi[Ye]=Ki,e0(ui,xs,Ei,Ci),jg(ui,ci,ys),vs(ui,Gi(zi),Gi(Ki),F,Pe))}}}}if(Ce){let Ye=Be.prox,Qt=qr==null?Os<=Ye:Os>Ye||pr!=qr;if(pe||Qt){let un=dt[0];un!=null&&(Kt[0]=Oe,oi[0]=ke,e0(un,at,It,At),jg(un,_t,Qe),vs(un,Gi(Oe),Gi(ke),F,Pe))}}}if(jt.show&&dr)if(x!=null){let[fe,ve]=Mn.scales,[Ue,Oe]=Mn.match,[ke,at]=x.cursor.sync.scales,It=x.cursor.drag;if(kn=It._x,Bn=It._y,kn||Bn){let{left:At,top:_t,width:Qe,height:Ye}=x.select,Qt=x.scales[ke].ori,un=x.posToVal,Vn,$t,hn,Ti,li,Bi=fe!=null&&Ue(fe,ke),Ji=ve!=null&&Oe(ve,at);Bi&&kn?(Qt==0?(Vn=At,$t=Qe):(Vn=_t,$t=Ye),hn=S[fe],Ti=z(un(Vn,ke),hn,j,0),li=z(un(Vn+$t,ke),hn,j,0),ka(es(Ti,li),Ln(li-Ti))):ka(0,j),Ji&&Bn?(Qt==1?(Vn=At,$t=Qe):(Vn=_t,$t=Ye),hn=S[ve],Ti=N(un(Vn,at),hn,le,0),li=N(un(Vn+$t,at),hn,le,0),Ba(es(Ti,li),Ln(li-Ti))):Ba(0,le)}else Pd()}else{let fe=Ln(Vm-Bm),ve=Ln(Hm-zm);if(L.ori==1){let at=fe;fe=ve,ve=at}kn=Yn.x&&fe>=Yn.dist,Bn=Yn.y&&ve>=Yn.dist;let Ue=Yn.uni;Ue!=null?kn&&Bn&&(kn=fe>=Ue,Bn=ve>=Ue,!kn&&!Bn&&(ve>fe?Bn=!0:kn=!0)):Yn.x&&Yn.y&&(kn||Bn)&&(kn=Bn=!0);let Oe,ke;kn&&(L.ori==0?(Oe=Eo,ke=Zt):(Oe=Co,ke=nn),ka(es(Oe,ke),Ln(ke-Oe)),Bn||Ba(0,le)),Bn&&(L.ori==1?(Oe=Eo,ke=Zt):(Oe=Co,ke=nn),Ba(es(Oe,ke),Ln(ke-Oe)),kn||ka(0,j)),!kn&&!Bn&&(ka(0,0),Ba(0,0))}if(Yn._x=kn,Yn._y=Bn,x==null){if(P){if(tg!=null){let[fe,ve]=Mn.scales;Mn.values[0]=fe!=null?_s(L.ori==0?Zt:nn,fe):null,Mn.values[1]=ve!=null?_s(L.ori==1?Zt:nn,ve):null}Va(jd,i,Zt,nn,F,Pe,D)}if(nt){let fe=P&&Mn.setSeries,ve=Be.prox;qr==null?Os<=ve&&gs(pr,Po,!0,fe):Os>ve?gs(null,Po,!0,fe):pr!=qr&&gs(pr,Po,!0,fe)}}pe&&(he.idx=D,Ed()),w!==!1&&zn("setCursor")}let mr=null;Object.defineProperty(i,"rect",{get(){return mr==null&&za(!1),mr}});function za(x=!1){x?mr=null:(mr=p.getBoundingClientRect(),zn("syncRect",mr))}function Xm(x,w,P,D,X,j,le){de._lock||dr&&x!=null&&x.movementX==0&&x.movementY==0||(Cd(x,w,P,D,X,j,le,!1,x!=null),x!=null?Yr(null,!0,!0):Yr(w,!0,!1))}function Cd(x,w,P,D,X,j,le,fe,ve){if(mr==null&&za(!1),tt(x),x!=null)P=x.clientX-mr.left,D=x.clientY-mr.top;else{if(P<0||D<0){Zt=-10,nn=-10;return}let[Ue,Oe]=Mn.scales,ke=w.cursor.sync,[at,It]=ke.values,[At,_t]=ke.scales,[Qe,Ye]=Mn.match,Qt=w.axes[0].side%2==1,un=L.ori==0?F:Pe,Vn=L.ori==1?F:Pe,$t=Qt?j:X,hn=Qt?X:j,Ti=Qt?D:P,li=Qt?P:D;if(At!=null?P=Qe(Ue,At)?a(at,S[Ue],un,0):-10:P=un*(Ti/$t),_t!=null?D=Ye(Oe,_t)?a(It,S[Oe],Vn,0):-10:D=Vn*(li/hn),L.ori==1){let Bi=P;P=D,D=Bi}}ve&&(w==null||w.cursor.event.type==jd)&&((P<=1||P>=F-1)&&(P=Qr(P,F)),(D<=1||D>=Pe-1)&&(D=Qr(D,Pe))),fe?(Bm=P,zm=D,[Eo,Co]=de.move(i,P,D)):(Zt=P,nn=D)}let Rd={width:0,height:0,left:0,top:0};function Pd(){oc(Rd,!1)}let $m,qm,Ym,Jm;function Km(x,w,P,D,X,j,le){dr=!0,kn=Bn=Yn._x=Yn._y=!1,Cd(x,w,P,D,X,j,le,!0,!1),x!=null&&(bt(Qd,rf,Zm,!1),Va(Xg,i,Eo,Co,F,Pe,null));let{left:fe,top:ve,width:Ue,height:Oe}=jt;$m=fe,qm=ve,Ym=Ue,Jm=Oe}function Zm(x,w,P,D,X,j,le){dr=Yn._x=Yn._y=!1,Cd(x,w,P,D,X,j,le,!1,!0);let{left:fe,top:ve,width:Ue,height:Oe}=jt,ke=Ue>0||Oe>0,at=$m!=fe||qm!=ve||Ym!=Ue||Jm!=Oe;if(ke&&at&&oc(jt),Yn.setScale&&ke&&at){let It=fe,At=Ue,_t=ve,Qe=Oe;if(L.ori==1&&(It=ve,At=Oe,_t=fe,Qe=Ue),kn&&fr(T,_s(It,T),_s(It+At,T)),Bn)for(let Ye in S){let Qt=S[Ye];Ye!=T&&Qt.from==null&&Qt.min!=Yt&&fr(Ye,_s(_t+Qe,Ye),_s(_t,Ye))}Pd()}else de.lock&&(de._lock=!de._lock,Yr(w,!0,x!=null));x!=null&&(Cn(Qd,rf),Va(Qd,i,Zt,nn,F,Pe,null))}function Eb(x,w,P,D,X,j,le){if(de._lock)return;tt(x);let fe=dr;if(dr){let ve=!0,Ue=!0,Oe=10,ke,at;L.ori==0?(ke=kn,at=Bn):(ke=Bn,at=kn),ke&&at&&(ve=Zt<=Oe||Zt>=F-Oe,Ue=nn<=Oe||nn>=Pe-Oe),ke&&ve&&(Zt=Zt<Eo?0:F),at&&Ue&&(nn=nn<Co?0:Pe),Yr(null,!0,!0),dr=!1}Zt=-10,nn=-10,ee.fill(null),Yr(null,!0,!0),fe&&(dr=fe)}function jm(x,w,P,D,X,j,le){de._lock||(tt(x),Fa(),Pd(),x!=null&&Va(Yg,i,Zt,nn,F,Pe,null))}function Qm(){C.forEach(HM),O(i.width,i.height,!0)}no(Ic,No,Qm);let Io={};Io.mousedown=Km,Io.mousemove=Xm,Io.mouseup=Zm,Io.dblclick=jm,Io.setSeries=(x,w,P,D)=>{let X=Mn.match[2];P=X(i,w,P),P!=-1&&gs(P,D,!0,!1)},me&&(bt(Xg,p,Km),bt(jd,p,Xm),bt($g,p,x=>{tt(x),za(!1)}),bt(qg,p,Eb),bt(Yg,p,jm),ff.add(i),i.syncRect=za);let ac=i.hooks=n.hooks||{};function zn(x,w,P){ai?Ht.push([x,w,P]):x in ac&&ac[x].forEach(D=>{D.call(null,i,w,P)})}(n.plugins||[]).forEach(x=>{for(let w in x.hooks)ac[w]=(ac[w]||[]).concat(x.hooks[w])});let eg=(x,w,P)=>P,Mn=Tn({key:null,setSeries:!1,filters:{pub:r0,sub:r0},scales:[T,v[1]?v[1].scale:null],match:[o0,o0,eg],values:[null,null]},de.sync);Mn.match.length==2&&Mn.match.push(eg),de.sync=Mn;let tg=Mn.key,Id=n_(tg);function Va(x,w,P,D,X,j,le){Mn.filters.pub(x,w,P,D,X,j,le)&&Id.pub(x,w,P,D,X,j,le)}Id.sub(i);function Cb(x,w,P,D,X,j,le){Mn.filters.sub(x,w,P,D,X,j,le)&&Io[x](null,w,P,D,X,j,le)}i.pub=Cb;function Rb(){Id.unsub(i),ff.delete(i),Fn.clear(),lf(Ic,No,Qm),c.remove(),Me?.remove(),zn("destroy")}i.destroy=Rb;function Ld(){zn("init",n,e),Oa(e||n.data,!1),W[T]?wd(T,W[T]):Fa(),se=jt.show&&(jt.width>0||jt.height>0),ne=pe=!0,O(n.width,n.height)}return v.forEach(bo),C.forEach(Ls),t?t instanceof HTMLElement?(t.appendChild(c),Ld()):t(i,Ld):Ld(),i}Jn.assign=Tn;Jn.fmtNum=vf;Jn.rangeNum=Lc;Jn.rangeLog=Uc;Jn.rangeAsinh=xf;Jn.orient=so;Jn.pxRatio=Dt;Jn.join=DS;Jn.fmtDate=Sf,Jn.tzDate=WS;Jn.sync=n_;{Jn.addGap=TM,Jn.clipGaps=kc;let n=Jn.paths={points:l_};n.linear=u_,n.stepped=RM,n.bars=PM,n.spline=LM}function Ws(n,e,t=()=>!0){let[i,s]=et({value:void 0,error:"",path:n});return qe(()=>{if(n===null)return;let r=new AbortController,o=0,a=async()=>{let l=!0;try{let c=await Ri(n,r.signal);l=t(c),s({value:c,error:"",path:n})}catch(c){if(Fs(c))return;s(u=>({...u,error:ti(c),path:n}))}l&&!r.signal.aborted&&(o=window.setTimeout(a,1e3*e))};return a(),()=>{r.abort(),clearTimeout(o)}},[n]),i.path===n?i:{value:void 0,error:""}}function Ho(){let[n,e]=et(0);return qe(()=>Ac(()=>e(t=>t+1)),[]),n}function Sr(n){qe(()=>{n!==null&&(document.title=n===""?"cdcluster":`${n} - cdcluster`)},[n])}var GM=4;function Mr(n,e,t){let[i,s]=et({value:null,error:"",key:null,version:null,rests:0}),[r,o]=et(0),a=Lt(!1),l=Lt({version:e,load:t});return l.current={version:e,load:t},qe(()=>{if(n===null)return;let c=new AbortController,u=l.current.version,f=performance.now();a.current=!0;let h=(d,p)=>{a.current=!1;let b=performance.now();s(m=>({value:d??(m.key===n?m.value:null),error:p,key:n,version:u,rests:b+GM*(b-f)}))};return l.current.load(c.signal).then(d=>c.signal.aborted||h(d,""),d=>Fs(d)||c.signal.aborted||h(null,ti(d))),()=>c.abort()},[n,r]),qe(()=>{if(i.key!==n||n===null||i.version===e||a.current)return;let c=setTimeout(()=>o(u=>u+1),Math.max(0,i.rests-performance.now()));return()=>clearTimeout(c)},[n,e,i]),i.key===n?i:{value:null,error:""}}var WM=Symbol.for("pv"),XM=0;function g(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:WM,__v:--XM,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Gt.vnode&&Gt.vnode(c),c}var p_=160;function $M(n,e,t){let i={stroke:Zi("--muted"),grid:{stroke:Zi("--line"),width:1},ticks:{stroke:Zi("--line"),width:1,size:4},font:"11px system-ui, sans-serif"};return{width:e,height:p_,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},hooks:{setCursor:[s=>t(s.cursor.idx??null)]},scales:{y:{range:(s,r,o)=>[0,Math.max(1.1*o,4)]}},axes:[{...i,size:28,space:70,values:"{HH}:{mm}:{ss}"},{...i,size:64,values:(s,r)=>r.map(o=>n.format(o))}],series:[{},...n.lines.map(s=>({stroke:Zi(s.colour),width:1.5,...s.dash?{dash:s.dash}:{},points:{show:!1}}))]}}function Rf(n){let e=Lt(null),t=Lt(null),[i,s]=et(null),r=Ho(),o=[n.times,...n.lines.map(u=>u.values)];qe(()=>{let u=e.current;if(!u)return;let f=new Jn($M(n,u.clientWidth||300,s),o,u);t.current=f;let h=new ResizeObserver(()=>f.setSize({width:u.clientWidth||300,height:p_}));return h.observe(u),()=>{h.disconnect(),f.destroy(),t.current=null}},[r]),qe(()=>t.current?.setData(o),[n.times,r]);let a=i!==null&&i<n.times.length?i:n.times.length-1,l=u=>n.format(u.values[a]??0),c=n.lines.map(u=>`${u.title} ${l(u)}`).join(", ");return g("figure",{class:"chart",children:[g("div",{ref:e,role:"img","aria-label":`${n.title}: ${c}`}),g("figcaption",{children:[n.lines.map(u=>g("span",{children:[g("svg",{viewBox:"0 0 18 4","aria-hidden":"true",children:g("line",{x1:0,x2:18,y1:2,y2:2,stroke:`var(${u.colour})`,"stroke-width":2,"stroke-dasharray":u.dash?.join(" ")??"none"})}),u.title," ",g("b",{children:l(u)})]},u.title)),g("span",{class:"note",children:i===null?"now":new Date(1e3*n.times[a]).toLocaleTimeString("en-GB")})]})]})}var Hc=["separate","touch","cross","inside","contact","undecided","failed","near"];var m_=[0,7,1,2,3,4,5,6],qM=[1,4,6,7,5,2,8,3];function nl(n){return n===255?0:qM[n]}function Pf(n){return n>=1&&n<=4}function g_(n){return Pf(n)||n===7}function ts(n){return n===255?"not tested yet":Hc[n]}function Go(n){let e=Hc.indexOf(n);return e<0?255:e}function __(n){return n===255?"-":"STXICUFN"[n]}var YM=[[92,168,128],[232,188,38],[206,58,50],[146,36,92],[214,82,54],[132,112,186],[60,64,70],[240,140,40]],JM=[150,155,160];function vi(n){return n===255?JM:YM[n]}function wr(n){let[e,t,i]=vi(n);return`rgb(${e} ${t} ${i})`}function x_(n){return n===255?.12:[.3,.6,1,.9,.8,.5,.7,.45][n]}function Mt({text:n}){return g("bdi",{class:"name",title:n.slice(0,2e3),children:n===""?"(no name)":n.length>400?`${n.slice(0,400)}…`:n})}function Xs({kind:n}){return g("span",{class:`mark mark-${ts(n).split(" ")[0]}`,style:{background:wr(n)},"aria-hidden":"true",children:__(n)})}function y_(n){return n.count===0&&!n.always?null:g("span",{class:`count ${n.count===0?"zero":""}`,children:[g(Xs,{kind:n.kind}),ts(n.kind)," ",g("b",{children:Re(n.count)})]})}function Pt(n){return g("div",{class:`notice ${n.kind}`,role:n.kind==="bad"?"alert":"status",children:n.children})}function Dn(n){return g("section",{class:`panel ${n.wide?"wide":""}`,"aria-label":n.title,children:[g("header",{children:[g("h2",{children:n.title}),n.note&&g("span",{class:"note",children:n.note})]}),n.children]})}function Gc({done:n,total:e}){let t=e===0?0:n/e;return g("span",{class:"progress",children:[g("progress",{max:1,value:t,"aria-label":`${Re(n)} of ${Re(e)}`}),g("span",{children:gn(t)})]})}function Wc({text:n}){let[e,t]=et("");return g("button",{type:"button",class:"command",title:"copy",onClick:()=>If(n,t),children:[g("code",{children:n}),g("span",{"aria-live":"polite",children:e||"copy"})]})}function If(n,e){let t=s=>{e(s),setTimeout(()=>e(""),2e3)};(navigator.clipboard?.writeText(n)??Promise.reject(new Error)).then(()=>t("copied"),()=>t("the browser did not allow it"))}function KM(n,e){return typeof n=="number"&&typeof e=="number"?n-e:String(n).localeCompare(String(e),"en",{numeric:!0})}function Wi(n){let[e,t]=et(null),i=n.columns.find(a=>a.key===e?.key),s=[...n.rows];i&&e?s.sort((a,l)=>(e.down?-1:1)*KM(i.value(a),i.value(l))):n.order&&s.sort(n.order);let r=a=>{let l=a.isNumber===!0;e?.key!==a.key?t({key:a.key,down:l}):t(e.down===l?{key:a.key,down:!l}:null)},o=a=>e?.key!==a.key?"none":e.down?"descending":"ascending";return g("div",{class:"table",tabIndex:0,role:"region","aria-label":n.caption,children:g("table",{children:[g("caption",{children:n.caption}),g("thead",{children:g("tr",{children:n.columns.map(a=>g("th",{scope:"col",class:a.isNumber?"number":"","aria-sort":o(a),children:g("button",{type:"button",onClick:()=>r(a),children:a.title})},a.key))})}),g("tbody",{children:[s.length===0&&g("tr",{children:g("td",{class:"empty",colSpan:n.columns.length,children:n.empty})}),s.map(a=>g("tr",{class:n.rowClass?.(a)??"",children:n.columns.map(l=>g("td",{class:l.isNumber?"number":"",children:l.cell(a)},l.key))},n.rowKey(a)))]})]})})}function v_(n){let e=n.scenarios_per_second??0;return n.state==="running"&&e>0?(n.scenarios-n.done)/e:NaN}var ZM=[{key:"job",title:"job",cell:n=>g("a",{href:ks(n.job),children:n.job}),value:n=>n.job},{key:"name",title:"name",cell:n=>g(Mt,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>g("span",{class:`state ${n.state==="failed"?"bad":n.state==="paused"?"warn":""}`,children:n.state}),value:n=>n.state},{key:"owner",title:"owner",cell:n=>g(Mt,{text:n.owner||"-"}),value:n=>n.owner??""},{key:"began",title:"began",cell:n=>(n.began??"").replace("T"," ").replace(/Z$/," UTC"),value:n=>n.began??""},{key:"scenarios",title:"scenarios",cell:n=>Re(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"done",title:"done",cell:n=>g(Gc,{done:n.done,total:n.scenarios}),value:n=>n.done/Math.max(1,n.scenarios),isNumber:!0},{key:"contact",title:"in contact",cell:n=>n.done===0?"-":gn(n.contact/n.done),value:n=>n.contact/Math.max(1,n.done),isNumber:!0},{key:"failed",title:"failed",cell:n=>g("span",{class:n.failed>0?"state bad":"",children:Re(n.failed)}),value:n=>n.failed,isNumber:!0},{key:"rate",title:"rate",cell:n=>yr(n.scenarios_per_second??0),value:n=>n.scenarios_per_second??0,isNumber:!0},{key:"eta",title:"ends in",cell:n=>jr(v_(n)),value:n=>v_(n)||0,isNumber:!0}];function Lf(n){return g(Wi,{caption:"jobs",columns:ZM,rows:n.jobs,rowKey:e=>e.job,...n.order?{order:n.order}:{},empty:"no job yet: cdctl run job.toml --master HOST:7600"})}function b_(){let{value:n,error:e}=Ws("jobs",2);return Sr("jobs"),qe(()=>yi("jobs",()=>({ready:n!==void 0,jobs:n?.jobs.map(t=>t.job)})),[n]),qe(()=>{n?.jobs.length===1&&n.jobs[0].job==="folder"&&Bs(ks("folder"))},[n]),n?g(Tt,{children:[e&&g(Pt,{kind:"bad",children:[e,"; below is what it said last"]}),g(Lf,{jobs:n.jobs})]}):e?g(Pt,{kind:"bad",children:e}):g("p",{class:"wait",children:"asking for the jobs…"})}function Xc(n){let e=["lost","silent","quarantined","draining"],t=e.indexOf(n.split(" ")[0]);return t<0?e.length:t}var S_=["bad","bad","warn","warn",""],jM=[{key:"worker",title:"worker",cell:n=>n.worker,value:n=>n.worker},{key:"name",title:"name",cell:n=>g(Mt,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>g("span",{class:`state ${S_[Xc(n.state)]}`,children:n.state}),value:n=>n.state},{key:"threads",title:"threads",cell:n=>Re(n.threads),value:n=>n.threads,isNumber:!0},{key:"working",title:"working",cell:n=>Re(n.working),value:n=>n.working,isNumber:!0},{key:"done",title:"done",cell:n=>Re(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"rate",title:"rate",cell:n=>yr(n.scenarios_per_second),value:n=>n.scenarios_per_second,isNumber:!0},{key:"cache",title:"cache",cell:n=>n.cache_bytes?Vg(n.cached_bytes,n.cache_bytes):zs(n.cached_bytes),value:n=>n.cached_bytes,isNumber:!0},{key:"hits",title:"hits",cell:n=>gn(n.cache_hit_share),value:n=>n.cache_hit_share,isNumber:!0},{key:"peers",title:"to peers",cell:n=>zs(n.uploaded_bytes??0),value:n=>n.uploaded_bytes??0,isNumber:!0},{key:"longest",title:"longest",cell:n=>n.longest?g("a",{href:mn(n.longest.job,n.longest.scenario),children:["#",n.longest.scenario," ",jr(n.longest.seconds)]}):"-",value:n=>n.longest?.seconds??0,isNumber:!0}];function QM({history:n}){let e=i=>{let s=n.columns.indexOf(i);return n.rows.map(r=>r[s]??0)},t=e("time");return g("div",{class:"two",children:[g(Dn,{title:"throughput",note:"scenarios a second, ten minutes",children:g(Rf,{title:"throughput",times:t,format:yr,lines:[{title:"scenarios",colour:"--accent",values:e("scenarios_per_second")}]})}),g(Dn,{title:"wire",note:"bytes a second, seen from the master",children:g(Rf,{title:"wire",times:t,format:zg,lines:[{title:"out",colour:"--accent",values:e("sent_per_second")},{title:"in",colour:"--second",values:e("received_per_second"),dash:[6,3]},{title:"peer to peer",colour:"--third",values:e("peer_per_second"),dash:[2,3]}]})})]})}function ew({cluster:n}){let e=n.workers.filter(r=>!r.state.startsWith("lost")),t=e.reduce((r,o)=>r+o.threads,0),i=e.reduce((r,o)=>r+o.scenarios_per_second,0),s=n.jobs.filter(r=>r.state==="running").length;return g("dl",{class:"numbers",children:[g("div",{children:[g("dt",{children:"scenarios"}),g("dd",{children:yr(i)})]}),g("div",{children:[g("dt",{children:e.length===1?"worker":"workers"}),g("dd",{children:Re(e.length)})]}),g("div",{children:[g("dt",{children:"threads"}),g("dd",{children:Re(t)})]}),g("div",{children:[g("dt",{children:s===1?"job runs":"jobs run"}),g("dd",{children:Re(s)})]}),g("div",{children:[g("dt",{children:"up"}),g("dd",{children:jr(n.uptime_seconds)})]}),g("div",{children:[g("dt",{children:"free on the disk"}),g("dd",{children:zs(n.state_bytes?.free??0)})]})]})}function M_(){let{value:n,error:e}=Ws("cluster",1),{value:t}=Ws("history",2);if(Sr("cluster"),qe(()=>yi("cluster",()=>({ready:n!==void 0,workers:n?.workers.map(r=>({name:r.name,state:r.state})),jobs:n?.jobs.map(r=>({job:r.job,done:r.done,state:r.state}))})),[n]),!n)return e?g(Pt,{kind:"bad",children:e}):g("p",{class:"wait",children:"asking the master…"});let i=(r,o)=>Xc(r.state)-Xc(o.state),s=(r,o)=>+(o.state==="running")-+(r.state==="running");return g(Tt,{children:[e&&g(Pt,{kind:"bad",children:[e,"; below is what it said last"]}),n.paused&&g(Pt,{kind:"bad",children:["jobs are paused: ",n.paused]}),n.alarms.map((r,o)=>g(Pt,{kind:"warn",children:[g("b",{children:"alarm"})," ",g(Mt,{text:r})]},o)),g(ew,{cluster:n}),g("p",{class:"line",children:[g("b",{children:"bottleneck"})," ",n.bottleneck,n.workers_lost>0&&g(Tt,{children:[" · ",Ct(n.workers_lost,"worker")," lost so far"]}),n.alarms.length===0&&g(Tt,{children:" · no alarms"})]}),t&&g(QM,{history:t}),g(Wi,{caption:"workers",columns:jM,rows:n.workers,rowKey:r=>r.worker,order:i,rowClass:r=>S_[Xc(r.state)],empty:"no worker is connected: start cdworker --master HOST:7600"}),g(Lf,{jobs:n.jobs,order:s})]})}function $c(n){return[n.bodies[0]?.name??"",n.bodies[1]?.name??""]}function $s(n){return n.question==="distance"}function w_(n){return n.question==="motion"}function Nt(n){return n.question==="shots"}function Kn(n){return Nt(n)&&(n.poses.axes??[]).length>0}function di(n){return Nt(n)?"hit":"pair"}function tw(n){let e=[];for(let t of n){if(t===0)continue;let i=31-Math.clz32(t);for(;e.length<=i;){let s=2**e.length;e.push({first:s,last:2*s-1,count:0})}e[i].count+=1}return e}function Df({bars:n,label:e}){let[t,i,s]=[480,150,18],r=Math.log1p(Math.max(...n.map(a=>a.count))),o=t/n.length;return g("svg",{class:"histogram",viewBox:`0 0 ${t} ${i+s}`,role:"img","aria-label":e,children:[n.map((a,l)=>{let c=Math.log1p(a.count)/r*(i-14);return g("g",{children:[g("title",{children:`${a.about}: ${Ct(a.count,"scenario")}`}),g("rect",{class:"hit",x:l*o,y:0,width:o,height:i}),g("rect",{class:"bar",x:l*o+1,y:i-c,width:o-2,height:c}),a.count>0&&g("text",{x:(l+.5)*o,y:i-c-3,children:Kd(a.count)}),(l%2===0||n.length<12)&&g("text",{x:(l+.5)*o,y:i+13,children:a.foot})]},a.about)}),g("line",{x1:0,x2:t,y1:i,y2:i})]})}function Nf({job:n,results:e}){let t=St(()=>e.counts?tw(e.counts):[],[e]);if(t.length===0)return null;let[i,s]=[di(n),Nt(n)?"bundle":"scenario"];return g(Dn,{title:`${i}s a ${s}`,note:`${s}s in contact${n.clearance===null?"":" or near"}, both axes logarithmic${e.isExact?"":", of the sample"}`,children:g(Df,{label:`histogram of ${i}s a ${s}`,bars:t.map(r=>({about:`${Re(r.first)} to ${Re(r.last)} ${i}s`,foot:Kd(r.first),count:r.count}))})})}var nw=10,il=20;function iw(n,e=nw){let t=[];return(n.distances??new Float64Array).forEach((i,s)=>{let r=t.length===e?n.distanceAt(t[e-1]):null;if(Number.isNaN(i)||r!==null&&i>=r)return;let o=t.findIndex(a=>i<(n.distanceAt(a)??1/0));t.splice(o<0?t.length:o,0,s),t.length=Math.min(t.length,e)}),t}function sw(n){let e=n.filter(s=>!Number.isNaN(s)),t=e.reduce((s,r)=>Math.max(s,r),0);if(e.length===0||t===0)return e.length===0?[]:[{from:0,to:0,count:e.length}];let i=Array.from({length:il},(s,r)=>({from:r/il*t,to:(r+1)/il*t,count:0}));return e.forEach(s=>{i[Math.min(il-1,Math.floor(s/t*il))].count+=1}),i}function A_({job:n,results:e}){let t=St(()=>iw(e),[e]),i=St(()=>sw(e.distances??new Float64Array),[e]),s=e.isExact?"":", of the sample";return g(Tt,{children:[g(Dn,{title:"least distances",note:`between the bodies' surfaces, in ${n.unit}${s}`,children:g(Wi,{caption:"least distances",rows:t,rowKey:r=>String(r),empty:"no scenario has a distance",columns:[{key:"scenario",title:"scenario",cell:r=>g("a",{href:mn(n.job,e.scenarioAt(r)),children:["#",Re(e.scenarioAt(r))]}),value:r=>e.scenarioAt(r),isNumber:!0},{key:"class",title:"class",cell:r=>g(Tt,{children:[g(Xs,{kind:e.classes[r]})," ",ts(e.classes[r])]}),value:r=>e.classes[r]},{key:"distance",title:`distance [${n.unit}]`,cell:r=>Et(e.distanceAt(r)??Number.NaN,6),value:r=>e.distanceAt(r)??1/0,isNumber:!0}]})}),i.length>0&&g(Dn,{title:"distances",note:`scenarios by distance in ${n.unit}; heights are logarithmic${s}`,children:g(Df,{label:"histogram of distances",bars:i.map(r=>({about:`${Et(r.from)} to ${Et(r.to)} ${n.unit}`,foot:Et(r.from,2),count:r.count}))})})]})}var Uf=1e3;function rw(n){let e=[],t=0,i=null;return n.classes.forEach((s,r)=>{g_(s)?i?(i.last=n.first+r,i.worst=n.isWorse(r,i.worst)?r:i.worst):(i={first:n.first+r,last:n.first+r,worst:r},t+=1,t<=Uf&&e.push(i)):i=null}),{count:t,listed:e}}function T_({job:n,results:e}){let t=n.poses.kind==="file"&&e.isExact,i=St(()=>t?rw(e):null,[e,t]);if(!i)return null;let s=n.clearance===null?"in contact":"in contact or near",r=o=>g("a",{href:mn(n.job,o),children:["#",Re(o)]});return g(Dn,{title:"episodes",note:`${Ct(i.count,"run")} of consecutive scenarios ${s}${i.count>Uf?`; the first ${Re(Uf)} are listed`:""}`,children:g(Wi,{caption:"episodes",rows:i.listed,rowKey:o=>String(o.first),empty:`no scenario is ${s}`,columns:[{key:"first",title:"first",cell:o=>r(o.first),value:o=>o.first,isNumber:!0},{key:"last",title:"last",cell:o=>r(o.last),value:o=>o.last,isNumber:!0},{key:"length",title:"scenarios",cell:o=>Re(o.last-o.first+1),value:o=>o.last-o.first,isNumber:!0},{key:"worst",title:"worst",cell:o=>g(Tt,{children:[g(Xs,{kind:e.classes[o.worst]})," ",r(e.scenarioAt(o.worst))]}),value:o=>e.countAt(o.worst),isNumber:!0},{key:"pairs",title:"pairs there",cell:o=>e.counts?Re(e.countAt(o.worst)):"-",value:o=>e.countAt(o.worst),isNumber:!0}]})})}function E_(n){return n.replaceAll(/[\\/*?[]/g,"\\$&")}function Of(n){return n.replaceAll(/\\(.)/gs,"$1")}function ow(n,e){let t=e.indexOf(n);return t>=0?t:["a","b"].indexOf(n)}function Wo(n,e,t){return`${t[n]!==""&&t[0]!==t[1]?E_(t[n]):"ab"[n]}/${E_(e)}`}function C_(n,e){let t=/^((?:\\.|[^\\/])*)\/(.*)$/s.exec(n),i=t?ow(Of(t[1]),e.bodies):-1;if(t&&i>=0)return{body:i,part:Of(t[2])};let s=Of(n);return{body:e.hasA(s)?0:1,part:s}}function aw(n,e){let i=n/e,s=i+1.959964*1.959964/(2*e),r=1.959964*Math.sqrt(i*(1-i)/e+1.959964*1.959964/(4*e*e)),o=1+1.959964*1.959964/e;return[Math.max(0,(s-r)/o),Math.min(1,(s+r)/o)]}function lw({group:n,job:e}){let t=e.poses.kind==="random"&&!e.poses.penetration&&e.done>0,[i,s]=t?aw(n.scenarios,e.done):[0,0];return g("span",{class:"share",children:[g("meter",{min:0,max:1,value:n.share}),g("span",{children:[gn(n.share),t&&g("small",{children:[" ",`${gn(i)} to ${gn(s)}`]})]})]})}function R_(n,{a:e,b:t,worst:i}){let s=$c(n);return mn(n.job,i,{part:Wo(0,e,s),with:Wo(1,t,s)})}var cw={key:"near",title:"near pairs",cell:n=>Re(n.near),value:n=>n.near,isNumber:!0};function uw(n){return[{key:"a",title:"part",cell:e=>g(Mt,{text:e.a}),value:e=>e.a},{key:"scenarios",title:"in bundles",cell:e=>Re(e.scenarios),value:e=>e.scenarios,isNumber:!0},{key:"pairs",title:"hits",cell:e=>Re(e.pairs),value:e=>e.pairs,isNumber:!0},{key:"worst",title:"most hits",cell:e=>g("a",{href:R_(n,e),children:["#",Re(e.worst)]}),value:e=>e.worst_pairs,isNumber:!0}]}function hw(n){return Nt(n)?uw(n):[{key:"a",title:"part of A",cell:e=>g(Mt,{text:e.a}),value:e=>e.a},{key:"b",title:"part of B",cell:e=>g(Mt,{text:e.b}),value:e=>e.b},{key:"scenarios",title:"in poses",cell:e=>Re(e.scenarios),value:e=>e.scenarios,isNumber:!0},{key:"share",title:"share",cell:e=>g(lw,{group:e,job:n}),value:e=>e.share,isNumber:!0},{key:"worst",title:"worst",cell:e=>g("a",{href:R_(n,e),children:[g(Xs,{kind:Go(e.class)})," #",Re(e.worst)]}),value:e=>e.worst_pairs+e.worst_near,isNumber:!0},...n.clearance===null?[]:[cw]]}function P_({job:n,groups:e}){let t=n.groups_total??e.length,i=t>e.length,s=Nt(n),r=s?"parts hit":n.clearance===null?"parts in contact":"parts in contact or near";return g(Dn,{title:r,note:i?`the ${Re(e.length)} in most ${s?"bundles":"poses"}, of ${Re(t)}`:"",children:g(Wi,{caption:r,columns:hw(n),rows:e,rowKey:o=>`${o.a}
${o.b}`,empty:`no part is ${s?"hit":n.clearance===null?"in contact":"in contact or near"}`})})}function dw(n){let e=(n??"").split(",").map(t=>/^(\w+):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(t));return Object.fromEntries(e.flatMap(t=>t&&Number.isFinite(Number(t[2]))?[[t[1],Number(t[2])]]:[]))}function fw(n,e){let t=r=>/^\d{1,15}$/.test(r??""),[i,s]=[Number(n),Number(e)];return t(n)&&t(e)&&i<=s?[i,s+1]:null}function Ff(n){return{x:n.get("x")??"",y:n.get("y")??"",at:dw(n.get("at")),window:fw(n.get("from"),n.get("to"))}}function I_(n){let e={};n.x&&n.y&&(e.x=n.x,e.y=n.y);let t=Object.entries(n.at);return t.length>0&&(e.at=t.map(([i,s])=>`${i}:${s}`).join(",")),n.window&&(e.from=String(n.window[0]),e.to=String(n.window[1]-1)),e}function qs(n,[e,t,i]){return[n[0]*e+n[1]*t+n[2]*i+n[3],n[4]*e+n[5]*t+n[6]*i+n[7],n[8]*e+n[9]*t+n[10]*i+n[11]]}function Ar(n){let e=[n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]],t=i=>-(e[i]*n[3]+e[i+1]*n[7]+e[i+2]*n[11]);return[e[0],e[1],e[2],t(0),e[3],e[4],e[5],t(3),e[6],e[7],e[8],t(6)]}function kf(n,e){let t=[];for(let i=0;i<12;i+=4)for(let s=0;s<4;++s)t.push(n[i]*e[s]+n[i+1]*e[s+4]+n[i+2]*e[s+8]+(s===3?n[i+3]:0));return t}function qc({pose_a:n,pose_b:e}){return kf(Ar(n),e)}var rl=["x","y","z","roll","pitch","yaw","distance"],ro=["azimuth","elevation"],sl=180/Math.PI;function Tr(n,e,t=0){switch(n){case"x":return e[t+3];case"y":return e[t+7];case"z":return e[t+11];case"roll":return Math.atan2(e[t+9],e[t+10])*sl;case"pitch":return Math.asin(Math.max(-1,Math.min(1,-e[t+8])))*sl;case"yaw":return Math.atan2(e[t+4],e[t])*sl;case"distance":return Math.hypot(e[t+3],e[t+7],e[t+11]);case"azimuth":{let i=Math.atan2(e[t+4],e[t])*sl;return i<-1e-9?i+360:Math.max(0,i)}case"elevation":return Math.asin(Math.max(-1,Math.min(1,e[t+8])))*sl}}function L_(n){return Object.fromEntries(rl.map(e=>[e,Tr(e,n)]))}function Ys(n){return["roll","pitch","yaw",...ro].includes(n)}var zf=4096,pw=1<<24,ns=65536,Xo=class{constructor(e,t,i,s,r=null,o=null){this.first=e;this.end=t;this.classes=i;this.counts=s;this.chosen=r;this.distances=o}first;end;classes;counts;chosen;distances;get isExact(){return this.classes.length===this.end-this.first}get isSample(){return!this.isExact&&this.chosen===null}scenarioAt(e){return this.chosen?this.chosen[e]:this.isExact?this.first+e:this.first+Math.floor(e*(this.end-this.first)/this.classes.length)}classOf(e){return this.isExact?this.classes[e-this.first]:void 0}isWorse(e,t){let i=nl(this.classes[e])-nl(this.classes[t])||this.countAt(e)-this.countAt(t);return i>0||i===0&&(this.distanceAt(e)??1/0)<(this.distanceAt(t)??1/0)}worst(){let e=0;for(let t=1;t<this.classes.length;++t)e=this.isWorse(t,e)?t:e;return this.classes.length===0?0:this.scenarioAt(e)}countAt(e){return this.counts?.[e]??0}distanceAt(e){let t=this.distances?.[e]??Number.NaN;return Number.isNaN(t)?null:t}};function mw(n){return n.kind==="folder"?1<<20:ns}function Vf(n){return n.kind==="folder"?pw:ns}async function Bf(n,e,t,i,s){for(let r=0;r<t.length;r+=i){let o=Math.min(i,t.length-r),a=await An(`${n}?first=${e+r}&count=${o}`,s);t.set(a.values,r)}return t}function Js(n,e){return`jobs/${encodeURIComponent(n.job)}/${e}`}async function Yc(n,e,t,i,s){if(!$o(n,t,i)){let r=["classes","counts",...$s(e)?["distances"]:[]],[o,a,l]=await Promise.all(r.map(c=>An(`${Js(e,c)}?sample=${zf}`,s)));return new Xo(0,e.scenarios,o.values,a.values,null,l?.values??null)}return D_(e,t,i-t,mw(n),s)}async function D_(n,e,t,i,s){let r=new Uint8Array(t).fill(255),o=await Bf(Js(n,"classes"),e,r,i,s),a=n.level==="any"?null:await Bf(Js(n,"counts"),e,new Uint32Array(t),i,s),l=$s(n)?await Bf(Js(n,"distances"),e,new Float64Array(t).fill(Number.NaN),i,s):null;return new Xo(e,e+t,o,a,null,l)}function N_(n,e,t,i){return D_(n,e,t,ns,i)}function $o(n,e,t){return t-e<=Vf(n)}var gw=10;function _w(n,e=gw){return Array.from(n.classes,(i,s)=>s).filter(i=>n.countAt(i)>0).sort((i,s)=>n.countAt(s)-n.countAt(i)||i-s).slice(0,e)}async function xw(n,e,t){let i=s=>An(`${Js(n,"poses")}?first=${s}&count=1`,t);return Promise.all(e.map(async s=>(await i(s)).values))}function U_({job:n,results:e}){let t=St(()=>_w(e),[e]),i=t.map(l=>e.scenarioAt(l)),s=Kn(n)&&i.length>0?i.join(" "):null,r=Mr(s,0,l=>xw(n,i,l)),o=t.map((l,c)=>({scenario:i[c],hits:e.countAt(l),pose:r.value?.[c]??null})),a=(Kn(n)?ro:[]).map(l=>({key:l,title:`${l} [°]`,cell:({pose:c})=>c?Et(Tr(l,c),5):"",value:({pose:c})=>c?Tr(l,c):0,isNumber:!0}));return g(Dn,{title:"most hits",note:e.isExact?"":"of the sample",children:[r.error&&g(Pt,{kind:"bad",children:r.error}),g(Wi,{caption:"most hits",rows:o,rowKey:l=>String(l.scenario),empty:"no line hits anything",columns:[{key:"scenario",title:"bundle",cell:l=>g("a",{href:mn(n.job,l.scenario),children:["#",Re(l.scenario)]}),value:l=>l.scenario,isNumber:!0},...a,{key:"hits",title:"hits",cell:l=>Re(l.hits),value:l=>l.hits,isNumber:!0}]})]})}function Jc(n,e,t,i,s){if(e===0||e===255||e===1){let r=s*(e===1?.85:e===0?.35:.15);n.moveTo(t+r,i),n.arc(t,i,r,0,2*Math.PI)}else if(e===2||e===4)n.moveTo(t-s,i-s),n.lineTo(t+s,i+s),e===2&&(n.moveTo(t+s,i-s),n.lineTo(t-s,i+s));else if(e===3)n.rect(t-s,i-s,2*s,2*s);else if(e===5)n.moveTo(t-s,i),n.lineTo(t+s,i);else if(e===7)for(let r of[-.5,.5])n.moveTo(t+r*s,i-s),n.lineTo(t+r*s,i+s);else n.moveTo(t,i-s),n.lineTo(t+s,i+s),n.lineTo(t-s,i+s),n.lineTo(t,i-s)}var yw=10,qo=class{constructor(e,t,i,s,r,o,a){this.results=e;this.x=t;this.y=i;this.columns=s;this.rows=r;this.showsShares=o;this.describe=a;let l=s*r;this.worst=new Int32Array(l).fill(-1),this.number=new Uint32Array(l),this.tested=new Uint32Array(l),this.contacts=new Uint32Array(l)}results;x;y;columns;rows;showsShares;describe;worst;number;tested;contacts;add(e,t,i){let s=t*this.columns+e,r=this.results.classes[i];this.number[s]+=1,this.tested[s]+=r===255?0:1,this.contacts[s]+=Pf(r)?1:0,(this.worst[s]<0||this.results.isWorse(i,this.worst[s]))&&(this.worst[s]=i)}colour(e){let t=this.results.classes[this.worst[e]];if(!this.showsShares||this.tested[e]===0)return vi(t);let i=this.contacts[e]/this.tested[e],[s,r]=[vi(0),vi(2)];return[0,1,2].map(o=>s[o]+(r[o]-s[o])*i)}draw(e,t,i){let s=new ImageData(this.columns,this.rows);for(let o=0;o<this.worst.length;++o){if(this.worst[o]<0)continue;let l=4*((this.rows-1-Math.floor(o/this.columns))*this.columns+o%this.columns);s.data.set([...this.colour(o),255],l)}let r=new OffscreenCanvas(this.columns,this.rows);r.getContext("2d")?.putImageData(s,0,0),e.imageSmoothingEnabled=!1,e.drawImage(r,0,0,t,i),this.drawGlyphs(e,t/this.columns,i/this.rows)}drawGlyphs(e,t,i){let s=Math.min(t,i);if(!(s<yw||this.showsShares)){e.strokeStyle="rgb(0 0 0 / 0.3)",e.lineWidth=Math.max(1,s/14),e.beginPath();for(let r=0;r<this.worst.length;++r)if(this.worst[r]>=0){let o=(r%this.columns+.5)*t,a=(this.rows-.5-Math.floor(r/this.columns))*i,l=this.results.classes[this.worst[r]];l!==0&&l!==255&&Jc(e,l,o,a,s*.2)}e.stroke()}}spot(e,t){let i=t*this.columns+e;return e<0||t<0||e>=this.columns||t>=this.rows||this.worst[i]<0?null:{scenario:this.results.scenarioAt(this.worst[i]),text:this.text(i),x:e/this.columns,y:t/this.rows,width:1/this.columns,height:1/this.rows}}text(e){let t=this.worst[e],i=this.results.scenarioAt(t),s=this.results.countAt(t),r=s>0?`, ${Re(s)} pairs`:"",o=`#${i} ${ts(this.results.classes[t])}${r}${this.describe(i)}`;if(this.number[e]===1)return o;let a=gn(this.contacts[e]/Math.max(1,this.tested[e]));return`${Re(this.number[e])} scenarios, ${a} in contact; the worst is ${o}`}at(e,t){return this.spot(Math.floor(e*this.columns),Math.floor(t*this.rows))}step(e,t,i){let s=e?Math.round(e.x*this.columns):Math.floor(this.columns/2)-t,r=e?Math.round(e.y*this.rows):Math.floor(this.rows/2)-i;for(;;){if(s+=t,r+=i,s<0||r<0||s>=this.columns||r>=this.rows)return e;let o=this.spot(s,r);if(o)return o}}};function Yo(n,e){return`${Et(e)}${n.unit}`}var vw=512,bw=40,Hf=class{constructor(e,t){this.axes=e;this.unit=t;this.strides=e.map((i,s)=>e.slice(s+1).reduce((r,o)=>r*o.count,1))}axes;unit;strides;varying(){return this.axes.flatMap((e,t)=>e.count>1?[t]:[])}value(e,t){let{first:i,last:s,count:r}=this.axes[e];return t===0?i:t===r-1?s:i+(s-i)*t/(r-1)}numberOf(e,t){return Math.floor(t/this.strides[e])%this.axes[e].count}unitOf(e){return Ys(this.axes[e].name)?"°":` ${this.unit}`}plotAxis(e){let{name:t,first:i,last:s}=this.axes[e];return{title:t,first:i,last:s,unit:this.unitOf(e)}}nearest(e,t){let{first:i,last:s,count:r}=this.axes[e],o=s===i?0:(t-i)/(s-i)*(r-1);return Math.min(r-1,Math.max(0,Math.round(o)))}brief(e,t){let i=this.value(e,t),s=[4,6,9,12].find(r=>this.nearest(e,Number(i.toPrecision(r)))===t);return s===void 0?i:Number(i.toPrecision(s))}varyingNamed(e){return this.varying().find(t=>this.axes[t].name===e)}valueText(e,t){return`${this.axes[e].name} ${Et(this.value(e,t))}${this.unitOf(e)}`}describe(e){let t=this.varying().map(i=>this.valueText(i,this.numberOf(i,e)));return t.length===0?"":` at ${t.join(", ")}`}};function O_(n,e,t,i,s){let r=e.isSample?bw:vw,o=Math.min(r,n.axes[t].count),a=Math.min(r,n.axes[i].count),l=new qo(e,n.plotAxis(t),n.plotAxis(i),o,a,!1,h=>n.describe(h)),c=h=>Math.floor(h*o/n.axes[t].count),u=h=>Math.floor(h*a/n.axes[i].count);if(!e.isExact){for(let h=0;h<e.classes.length;++h){let d=e.scenarioAt(h);l.add(c(n.numberOf(t,d)),u(n.numberOf(i,d)),h)}return l}let f=s.reduce((h,d,p)=>h+(p===t||p===i?0:d*n.strides[p]),0);for(let h=0;h<n.axes[t].count;++h)for(let d=0;d<(t===i?1:n.axes[i].count);++d){let p=f+h*n.strides[t]+(t===i?0:d*n.strides[i]);l.add(c(h),t===i?0:u(d),p-e.first)}return l}function F_(n){return n.poses.kind==="grid"&&n.poses.axes?new Hf(n.poses.axes,n.unit):null}var Sw={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function Mw(n,e,t,i){let[s,r]=[e.x*t,(1-e.y-e.height)*i];n.lineWidth=2*devicePixelRatio,n.strokeStyle=Zi("--ink"),n.beginPath(),e.width>0?n.rect(s-1,r-1,Math.max(4,e.width*t)+2,Math.max(4,e.height*i)+2):n.arc(s,r,6*devicePixelRatio,0,2*Math.PI),n.stroke()}function Gf(n){let{model:e}=n,t=Lt(null),i=Lt(null),[s,r]=et(null),[o,a]=et([0,0]),l=Ho();qe(()=>{let h=t.current;if(!h)return;let d=new ResizeObserver(()=>a([Math.round(h.clientWidth*devicePixelRatio),Math.round(h.clientHeight*devicePixelRatio)]));return d.observe(h),()=>d.disconnect()},[]),qe(()=>r(null),[e.x.title,e.y.title]),qe(()=>{let[h,d]=o;if(h>0&&d>0){i.current=new OffscreenCanvas(h,d);let p=i.current.getContext("2d");p&&e.draw(p,h,d)}},[e,o,l]),qe(()=>{let h=t.current?.getContext("2d"),[d,p]=o;!t.current||!h||!i.current||(t.current.width=d,t.current.height=p,h.drawImage(i.current,0,0),s&&Mw(h,s,d,p))},[e,s,o,l]);let c=h=>{let d=h.currentTarget.getBoundingClientRect(),p=(h.clientX-d.left)/d.width,b=1-(h.clientY-d.top)/d.height;return e.at(p,b,d.width,d.height)},u=h=>{let d=Sw[h.key];d?(r(e.step(s,...d)),h.preventDefault()):h.key==="Enter"&&s&&n.open(s.scenario)},f=h=>Yo(h,(h.first+h.last)/2);return g("div",{class:"plot",children:[g("div",{class:"y-axis","aria-hidden":"true",children:[g("span",{children:Yo(e.y,e.y.last)}),g("b",{children:e.y.title}),g("span",{children:Yo(e.y,e.y.first)})]}),g("canvas",{ref:t,tabIndex:0,role:"application","aria-label":`${e.x.title} against ${e.y.title}: arrows move, Enter opens. ${s?.text??""}`,onPointerMove:h=>r(c(h)),onPointerLeave:()=>r(null),onClick:h=>{let d=c(h);d&&n.open(d.scenario)},onKeyDown:u}),g("div",{class:"x-axis","aria-hidden":"true",children:[g("span",{children:Yo(e.x,e.x.first)}),g("span",{children:[g("b",{children:e.x.title})," ",f(e.x)]}),g("span",{children:Yo(e.x,e.x.last)})]}),g("p",{class:"readout","aria-live":"polite",children:s?s.text:"point at a place to read it; a click opens its worst scenario"})]})}var ww=1<<20;function Er(n){return Kn(n)?ro:rl}function k_(n,e,t,i){for(let s=0;s*t<e.length;++s){let[r,o]=[e,s*t];if(t===24){let a=Array.from({length:24},(l,c)=>e[24*s+c]);[r,o]=[kf(Ar(a.slice(0,12)),a.slice(12)),0]}for(let[a,l]of n)l[i+s]=Tr(a,r,o)}}function B_(n,e){return new Map(n.map(t=>[t,new Float64Array(e)]))}function z_(n){return n.poses.of_both_bodies?24:12}async function V_(n,e,t){let i=Math.min(zf,n.scenarios),s=await An(`${Js(n,"poses")}?sample=${i}`,t),r=B_(e,i);return k_(r,s.values,z_(n),0),r}function Wf(n){let[e,t]=[1/0,-1/0];for(let i of n)e=i<e?i:e,t=i>t?i:t;return e<t?[e,t]:[e-.5,e+.5]}function Xf(n){let e=r=>{let[o,a]=Wf(n.get(r)??new Float64Array(1));return(a-o)*(Ys(r)?1e-6:1)},t=[...n.keys()],[i,s]=t.filter(r=>r!=="distance").sort((r,o)=>e(o)-e(r));return t.indexOf(i)<t.indexOf(s)?[i,s]:[s,i]}async function H_(n,e){return Xf(await V_(n,Er(n),e))}function G_(n,e){return e.scenarios<=ww||!$o(n,0,e.scenarios)}async function W_(n,e,t,i,s){let r=e.scenarios;if(!$o(n,0,r))return V_(e,t,i);let o=B_(t,r);for(let a=0;a<r;a+=ns){let l=Math.min(ns,r-a),c=await An(`${Js(e,"poses")}?first=${a}&count=${l}`,i);k_(o,c.values,z_(e),a),s((a+l)/r)}return o}var Yf=5e4,$f=128,X_=14;function $_(n,e,t){let[i,s]=Wf(e),r=.03*(s-i);return{title:n,first:i-r,last:s+r,unit:Ys(n)?"°":` ${t}`}}var qf=class{constructor(e,t,i,s,r,o){this.results=e;this.px=t;this.py=i;this.x=s;this.y=r;this.noun=o;this.order=Uint32Array.from(t,(a,l)=>l).sort((a,l)=>this.rank(a)-this.rank(l)||a-l)}results;px;py;x;y;noun;order;rank(e){return nl(this.kind(e))+this.results.countAt(e)/2**32}kind(e){return this.results.classes[e]??255}draw(e,t,i){let s=this.px.length,r=(s>2e4?1.5:s>2e3?2.4:3.4)*devicePixelRatio;e.lineWidth=Math.max(1,.4*r);for(let o=0;o<s;){let a=this.kind(this.order[o]);for(e.beginPath();o<s&&this.kind(this.order[o])===a;++o){let f=this.order[o];Jc(e,a,this.px[f]*t,(1-this.py[f])*i,r)}let[l,c,u]=vi(a);e.strokeStyle=`rgb(${l} ${c} ${u} / ${a===0?.6:.9})`,e.stroke()}}spot(e){let t=this.results.scenarioAt(e),i=this.results.countAt(e),s=[this.x,this.y].map((o,a)=>{let l=a===0?this.px[e]:this.py[e];return`${o.title} ${Et(o.first+l*(o.last-o.first))}${o.unit}`}),r=i>0?`, ${Re(i)} ${this.noun}s`:"";return{scenario:t,text:`#${t} ${ts(this.kind(e))}${r} at ${s.join(", ")}`,x:this.px[e],y:this.py[e],width:0,height:0}}at(e,t,i,s){let r=-1,o=X_*X_;for(let a=0;a<this.px.length;++a){let l=(this.px[a]-e)*i,c=(this.py[a]-t)*s,u=l*l+c*c;(u<o||u===o&&r>=0&&this.rank(a)>this.rank(r))&&(o=u,r=a)}return r<0?null:this.spot(r)}step(e,t,i){let s=e??{x:.5,y:.5},r=-1,o=1/0;for(let a=0;a<this.px.length;++a){let[l,c]=[this.px[a]-s.x,this.py[a]-s.y],u=l*t+c*i,f=l*l+c*c;u>0&&2*u*u>=f&&f<o&&(o=f,r=a)}return r<0?e:this.spot(r)}};function q_(n,[e,t],[i,s],r,o="pair"){let[a,l]=[$_(e,t,r),$_(i,s,r)],c=(d,p)=>(p-d.first)/(d.last-d.first),u=Math.min(t.length,n.classes.length);if(u<=Yf){let d=(p,b)=>b.subarray(0,u).map(m=>c(p,m));return new qf(n,d(a,t),d(l,s),a,l,o)}let f=new qo(n,a,l,$f,$f,!0,()=>""),h=(d,p)=>Math.floor(c(d,p)*$f);for(let d=0;d<u;++d)f.add(h(a,t[d]),h(l,s[d]),d);return f}var Kc=16;function Y_(n,e,t,i){let s=[...new Set([e,t])].sort((a,l)=>n.strides[l]-n.strides[a]);if(s.reduce((a,l)=>a*n.axes[l].count,1)>Kc*ns)return null;let o=Float64Array.of(i.reduce((a,l,c)=>a+(s.includes(c)?0:l*n.strides[c]),0));for(let a of s){let[l,c,u]=[o,n.axes[a].count,n.strides[a]];o=Float64Array.from({length:l.length*c},(f,h)=>l[Math.floor(h/c)]+h%c*u)}return o}function J_(n){let e=[];for(let t of n){let i=e.at(-1);if(i&&t<i.first+ns)i.count=t-i.first+1;else{if(e.length===Kc)return null;e.push({first:t,count:1})}}return e}async function K_(n,e,t,i){let s=new Uint8Array(e.length),r=new Uint32Array(e.length),o=0;for(let{first:a,count:l}of t){let c=await N_(n,a,l,i);for(;o<e.length&&e[o]<a+l;++o)s[o]=c.classes[e[o]-a],r[o]=c.counts?.[e[o]-a]??0}return new Xo(0,n.scenarios,s,r,e)}var Aw=150;function j_(n){qe(()=>yi("pose space",()=>{let e=n?.step(null,1,0)??null;return{poseSpace:e&&{...e,axes:[n?.x.title,n?.y.title]}}}),[n])}function Zc(n){return g("label",{children:[n.label," ",g("select",{value:n.value,onChange:e=>n.choose(e.currentTarget.value),children:n.all.map(e=>g("option",{value:e,children:e},e))})]})}function Tw(n,e){let[t=0,i=t]=n.varying(),[s,r]=[n.varyingNamed(e.x),n.varyingNamed(e.y)];return s!==void 0&&r!==void 0&&(s!==r||t===i)?[s,r]:[t,i]}function Ew(n,e,t,i,s){let{job:r,results:o}=n,a=o.isExact?null:[t,i,...s].join(" "),l=St(()=>a===null?null:Y_(e,t,i,s),[a]),c=St(()=>l&&J_(l),[l]);return{...Mr(c&&a,o,async f=>(await new Promise(h=>setTimeout(h,Aw)),K_(r,l??new Float64Array,c??[],f))),isTooScattered:a!==null&&c===null}}function Cw(n,e){if(n.isExact||e.value)return"";let t=e.isTooScattered?`: this slice lies in more than ${Kc} windows of ${Re(ns)}`:"; reading the slice…";return`a sample of ${Re(n.classes.length)}, other axes folded${t}`}function Rw(n){let{job:e,grid:t,results:i,view:s,change:r}=n,[o,a]=Tw(t,s),l=t.axes.map(({name:v},C)=>v in s.at?t.nearest(C,s.at[v]):0),c=v=>v!==o&&v!==a,u=St(()=>l.map((v,C)=>c(C)?v:0),[o,a,...l]),f=Ew(n,t,o,a,u),h=f.value??i,d=St(()=>O_(t,h,o,a,u),[t,h,o,a,u]);j_(d);let p=t.varying(),b=v=>t.axes[v].name,m=p.map(b),_=(v,C)=>{let S=t.varyingNamed(C)??o,[I,T]=v==="x"?[o,a]:[a,o],y=S===T?I:T,[E,V]=v==="x"?[S,y]:[y,S];r({x:b(E),y:b(V)})};return g(Dn,{title:"pose space",note:Cw(i,f),children:[f.error&&g(Pt,{kind:"bad",children:f.error}),g("div",{class:"controls",children:[p.length>1&&g(Tt,{children:[g(Zc,{label:"across",value:b(o),all:m,choose:v=>_("x",v)}),g(Zc,{label:"up",value:b(a),all:m,choose:v=>_("y",v)})]}),!f.isTooScattered&&p.filter(c).map(v=>g("label",{class:"slider",children:[g("input",{type:"range",min:0,max:t.axes[v].count-1,value:u[v],onInput:C=>{let S=t.brief(v,Number(C.currentTarget.value));r({at:{...s.at,[b(v)]:S}})}})," ",t.valueText(v,u[v])]},v))]}),g(Gf,{model:d,open:v=>Bs(mn(e.job,v))})]})}function Z_(n,e){return e.includes(n)}function Pw({source:n,job:e,view:t},i){let s=Z_(t.x,Er(e))&&Z_(t.y,Er(e))?[t.x,t.y]:null,r=G_(n,e),o=Mr(s||r?null:e.job,0,f=>H_(e,f)),a=r?Er(e):s??o.value,l=Mr(a&&a.join(" "),0,f=>W_(n,e,a??[],f,i)),c=l.value,u=St(()=>r?c&&Xf(c):o.value,[c,o.value]);return{drawn:s??u,all:c,error:o.error||l.error}}function Iw(n){let{job:e,results:t,change:i}=n,[s,r]=et(0),{drawn:o,all:a,error:l}=Pw(n,r),[c,u]=o??Er(e),[f,h]=[a?.get(c),a?.get(u)],d=St(()=>f&&h?q_(t,[c,f],[u,h],e.unit,di(e)):null,[t,c,u,f,h]);j_(d);let p=[t.isExact?"":`a sample of ${Re(t.classes.length)}`,t.classes.length>Yf?"share of contacts in each cell":"",e.poses.penetration?"poses pushed to contact":""];return g(Dn,{title:Kn(e)?"directions":"pose space",note:p.filter(b=>b!=="").join(", "),children:[l&&g(Pt,{kind:"bad",children:l}),g("div",{class:"controls",children:[g(Zc,{label:"across",value:c,all:Er(e),choose:b=>i({x:b,y:u})}),g(Zc,{label:"up",value:u,all:Er(e),choose:b=>i({x:c,y:b})}),g("span",{class:"note",children:Kn(e)?"where the lines come from":"of B in A's frame"})]}),d?g(Gf,{model:d,open:b=>Bs(mn(e.job,b))}):g("p",{class:"wait",children:["reading the poses… ",s>0&&gn(s)]})]})}function Q_(n){let e=St(()=>F_(n.job),[n.job.job]);return Nt(n.job)&&!Kn(n.job)?null:e?g(Rw,{...n,grid:e}):g(Iw,{...n})}var Lw=1024;function Dw(n,e){return n&&n[0]<e?[n[0],Math.min(e,n[1])]:[0,e]}function Nw(n){return`windows of at most ${Re(Vf(n))} are exact`}function Uw(n,e){return e.reduce((t,i)=>t+(i>=0&&n.classes[i]!==255?1:0),0)}function Ow(n,e,t){let i=Math.min(Lw,t-e),s=new Int32Array(i).fill(-1);for(let r=0;r<n.classes.length;++r){let o=n.scenarioAt(r);if(o<e||o>=t)continue;let a=Math.floor((o-e)*i/(t-e));(s[a]<0||n.isWorse(r,s[a]))&&(s[a]=r)}return s}function Fw(n,e,t,{bin:i,drag:s}){let r=Math.round(n.clientWidth*devicePixelRatio),o=Math.round(n.clientHeight*devicePixelRatio),a=n.getContext("2d");if(!a||r===0)return;n.width=r,n.height=o;let l=c=>[c,c+1].map(u=>Math.round(u*r/t.length));if(t.forEach((c,u)=>{if(c<0)return;let f=e.classes[c],[h,d]=l(u),p=o*x_(f),b=d-h>4*devicePixelRatio?devicePixelRatio:0;a.fillStyle=wr(f),a.fillRect(h,o-p,Math.max(1,d-h-b),p)}),a.fillStyle=Zi("--accent"),i>=0){let[c,u]=l(i);a.fillRect(c,0,Math.max(2*devicePixelRatio,u-c),3*devicePixelRatio)}if(s){let[c,u]=[Math.min(...s)*r,Math.max(...s)*r];a.globalAlpha=.25,a.fillRect(c,0,u-c,o)}}function kw([n,e],t,i,s){let r=Math.max(1,Math.min(s,i?Math.ceil((e-n)/2):2*(e-n))),o=(t-n)/(e-n),a=Math.min(s-r,Math.max(0,Math.floor(t)-Math.floor(o*r)));return[a,a+r]}function Bw([n,e],t,i){let s=e-n,r=Math.min(i-s,Math.max(0,Math.round(t-s/2)));return t>=n&&t<e?[n,e]:[r,r+s]}function zw(n,e,t,[i,s]){let r=!t.isExact&&$o(n,i,s),o=Mr(r?`${i} ${s}`:null,t,a=>Yc(n,e,i,s,a));return{results:o.value??t,error:o.error}}function ex(n){let{source:e,job:t}=n,i=t.scenarios,s=Lt(null),[r,o]=et(null),[a,l]=et(-1),[c,u]=et(0),f=Ho(),h=Dw(n.view.window,i),[d,p]=h,{results:b,error:m}=zw(e,t,n.results,h),_=St(()=>Ow(b,d,p),[b,d,p]),v=_.length,C=$=>Math.floor(($-d)*v/(p-d)),S=a>=d&&a<p?C(a):-1,I=$=>d+Math.ceil($*(p-d)/v);qe(()=>{let $=s.current;if(!$)return;let ee=new ResizeObserver(()=>u($.clientWidth));return ee.observe($),()=>ee.disconnect()},[]),qe(()=>{s.current&&Fw(s.current,b,_,{bin:S,drag:r})},[b,_,S,r,c,f]),qe(()=>yi("strip",()=>({strip:{first:d,end:p,mark:a,isExact:b.isExact,shown:Uw(b,_)}})),[b,_,a]);let T=([$,ee])=>n.change({window:$===0&&ee===i?null:[$,ee]}),y=$=>{let ee=$.currentTarget.getBoundingClientRect();return Math.min(1,Math.max(0,($.clientX-ee.left)/ee.width))},E=$=>I(Math.min(v-1,Math.floor($*v))),V=$=>{_[$]>=0&&Bs(mn(t.job,b.scenarioAt(_[$])))},U=()=>{if(!r)return;let[$,ee]=[Math.min(...r),Math.max(...r)];if(o(null),ee-$<.005){V(Math.min(v-1,Math.floor($*v)));return}let he=Math.floor(d+$*(p-d));T([he,Math.max(he+1,Math.ceil(d+ee*(p-d)))]),l(-1)},L=$=>{let ee=S<0?$>0?d:p-1:$>0?I(S+1):I(S)-1,he=Math.min(i-1,Math.max(0,ee));l(he),T(Bw(h,he,i))},G=$=>T(kw(h,S<0?(d+p)/2:a,$,i)),z={ArrowRight:()=>L(1),ArrowLeft:()=>L(-1),"+":()=>G(!0),"-":()=>G(!1),Enter:()=>V(S),Escape:()=>T([0,i])},N=$=>{let ee=$.ctrlKey||$.altKey||$.metaKey?void 0:z[$.key];ee&&(ee(),$.preventDefault())},W=S>=0?_[S]:-1,Y=W>=0?b.distanceAt(W):null,H=Y===null?"":`, ${Et(Y,6)} ${t.unit} apart`,ae=W>=0&&Nt(t)?`, ${Ct(b.countAt(W),"hit")}`:"",K=W>=0?`#${b.scenarioAt(W)} ${ts(b.classes[W])}${H}${ae}, the ${ae?"most":"worst"} of this bin`:"drag to zoom, click to open";return g(Dn,{title:"scenarios in order",wide:!0,note:b.isExact?"":`a sample of ${Re(b.classes.length)}; ${Nw(e)}`,children:[m&&g(Pt,{kind:"bad",children:m}),g("canvas",{ref:s,class:"strip",tabIndex:0,role:"application","aria-label":`scenarios ${d} to ${p-1}: arrows move, plus and minus zoom, Enter opens, Escape shows all. ${K}`,onPointerDown:$=>{$.currentTarget.setPointerCapture($.pointerId),o([y($),y($)])},onPointerMove:$=>{l(E(y($))),o(r&&[r[0],y($)])},onPointerUp:U,onPointerCancel:()=>o(null),onPointerLeave:()=>r||l(-1),onKeyDown:N}),g("div",{class:"x-axis",children:[g("span",{children:["#",Re(d)]}),g("span",{class:"readout",children:K}),g("span",{children:[n.view.window&&g("button",{type:"button",class:"quiet",onClick:()=>T([0,i]),children:"show all"})," ","#",Re(p-1)]})]})]})}var Vw=3e3;function tx(n,e){let[t,i]=et({results:null,error:"",done:-1,at:0}),[s,r]=et(0);return qe(()=>{if(!e)return;let o=new AbortController,a=(l,c)=>i(u=>({results:l??u.results,error:c,done:e.done,at:performance.now()}));return Yc(n,e,0,e.scenarios,o.signal).then(l=>a(l,""),l=>Fs(l)||a(null,ti(l))),()=>o.abort()},[e?.job,s]),qe(()=>{if(!e||t.done<0||e.done===t.done)return;let o=Math.max(0,t.at+Vw-performance.now()),a=setTimeout(()=>r(l=>l+1),o);return()=>clearTimeout(a)},[e?.done,t]),t}var Hw=[["n, p","next and previous scenario in contact, or what else is chosen"],["← →","previous and next scenario"],["esc","end a search for the next contact"]],Gw=[["space","play, stop"],["h","heat map, contacts"],["g","ghost: A, B, none"],["x","contacts through walls"],["l","segments and points, or the path of a motion"],["s","section plane"],["[ ]","move the section plane"],["f","fit all into view"],["c","go to the contact"],["e","in a motion: the time of the event"],["shift ← → ↑ ↓","turn"],["shift W A S D","move up, left, down, right"],["+ −","nearer, farther"],["enter","in the picture: pick the triangle in its middle; with shift: of the ghost"],["drag, wheel","turn, zoom; with the right button or two fingers: move"],["click","pick a triangle; with shift: of the ghost"]];function nx(n){return[...Hw,...n?Gw:[],["?","these keys"]]}var ix=[["tab","from one part of the page to the next"],["← → ↑ ↓","in the pose space: the next place"],["← →","in the scenarios in order: the next bar; beyond the edge, further scenarios"],["+ −","there: half as many scenarios about the mark, or twice as many"],["enter","open the scenario at the mark"],["esc","all scenarios in order"],["?","these keys"]];function jc({title:n,keys:e,close:t}){let i=Lt(null);return qe(()=>i.current?.showModal(),[]),g("dialog",{ref:i,class:"keys",onClose:t,onClick:()=>i.current?.close(),children:[g("h2",{children:n}),g("table",{children:g("tbody",{children:e.map(([s,r])=>g("tr",{children:[g("th",{scope:"row",children:g("kbd",{children:s})}),g("td",{children:r})]},r))})}),g("button",{type:"button",children:"close"})]})}function Qc(n,e=document){let t=Lt(n);t.current=n,qe(()=>{let i=s=>{if(!(s instanceof KeyboardEvent))return;let r=s.shiftKey&&s.key.startsWith("Arrow"),o=t.current[r?`Shift+${s.key}`:s.key];o&&!Ww(s)&&(o(),s.preventDefault())};return e.addEventListener("keydown",i),()=>e.removeEventListener("keydown",i)},[e])}function Ww(n){let e=n.target;if(n.ctrlKey||n.altKey||n.metaKey)return!0;if(e instanceof HTMLInputElement){let s=e.type==="range"||e.type==="radio";return e.type==="number"||s&&n.key.startsWith("Arrow")}let t=e instanceof HTMLButtonElement&&n.key===" ",i=e instanceof Element?e.getRootNode():document;return t||e instanceof HTMLSelectElement||i.querySelector("dialog[open]")!==null}function sx(n){return n.state!=="running"&&n.state!=="paused"}function Xw(n){return n.touch+n.cross+n.inside+n.contact}function $w(n){if(n.clearance===null)return"";let e=`at most ${Et(n.clearance,6)} ${n.unit} apart`;return` In ${Ct(n.near,"scenario")} without contact the bodies are ${e}, with ${Ct(n.near_pairs,"near pair")}.`}function qw(n){let e=Xw(n),t=Nt(n)?"bundle":"scenario",i=n.done===n.scenarios?"":` tested so far, of ${Re(n.scenarios)}`,s=gn(e/Math.max(1,n.done)),r=e===1?"is":"are",o=`${Ct(n.done,t)}${i}`;if(Nt(n)){let l=n.first_hits?`${Ct(n.pairs,"line")} that cross A`:Ct(n.pairs,"hit");return e===0?`No line hits anything in ${o}.`:`${Re(e)} of ${o} ${r} hit (${s}), with ${l}.`}let a=$s(n)?"":`, with ${Ct(n.pairs,"pair")} of triangles`;return e===0?`No contact in ${o}.`:`${Re(e)} of ${o} ${r} in contact (${s})${a}.`}function Yw({job:n}){return g("div",{class:"verdict",children:[g("h1",{children:[g(Mt,{text:n.name||n.job}),g("span",{class:`state ${n.state==="failed"?"bad":""}`,children:n.state}),!sx(n)&&g(Gc,{done:n.done,total:n.scenarios})]}),g("p",{class:"sentence",children:[qw(n),$w(n)]}),g("p",{class:"counts",children:[m_.map(e=>{let t=Hc[e],i=Nt(n)?"contact":"cross",s=t==="separate"||t===i||t==="failed";return g(y_,{kind:e,count:n[t],always:s||e===7&&n.clearance!==null},t)}),n.digest&&g("span",{class:"count",children:["digest ",g("code",{title:n.digest,children:n.digest.slice(0,16)})]})]})]})}function Jw({job:n}){let e=[];return n.surfaces_only>0&&e.push(`Containment was not tested in ${Ct(n.surfaces_only,"scenario")}: a body is open.`),n.insides_skipped>0&&e.push(`Containment was not tested in ${Ct(n.insides_skipped,"scenario")}: triangles are ignored, and the rest of a body is open.`),n.cut>0&&e.push(`The list of ${di(n)}s ends at ${Re(n.limit_pairs)} in ${Ct(n.cut,"scenario")}; counts are true.`),n.map_pairs>0&&e.push(`The heat map counts the first ${Re(n.map_pairs)} ${di(n)}s of a scenario.`),e.length===0?null:g("p",{class:"caveats",children:e.join(" ")})}function Kw({body:n,letter:e,unit:t}){let i=n.closed===null?"":n.closed?", closed":", open";return g("div",{class:"card",children:[g("b",{class:"letter",children:e}),g("div",{children:[g(Mt,{text:Vs(n.file)}),n.name.toLowerCase()!==e.toLowerCase()&&g("span",{class:"note",children:[" ","called ",g(Mt,{text:n.name})]}),g("div",{class:"note",children:[Ct(n.triangles,"triangle"),", ",Ct(n.parts,"part"),i]}),g("div",{class:"note",children:[n.size.map(s=>Et(s)).join(" × ")," ",t," · ",n.precision]})]})]})}function Zw({job:n,body:e}){let t=(n.poses.axes??[]).map(i=>`${i.name} ${Re(i.count)}`);return g("div",{class:"card",children:[g("b",{class:"letter",children:"B"}),g("div",{children:[g(Mt,{text:e.name}),g("div",{class:"note",children:[Ct(e.triangles,"line"),Kn(n)?" a bundle":""]}),g("div",{class:"note",children:Kn(n)?`directions ${t.join(" × ")}`:`file ${Vs(n.poses.file??"")}`})]})]})}function jw(n){let{poses:e}=n;return e.kind==="shots"?Kn(n)?"bundles of lines":"lines of a file":e.kind==="grid"?`grid ${(e.axes??[]).filter(i=>i.count>1).map(i=>`${i.name} ${Re(i.count)}`).join(" × ")}`:e.kind==="random"?`random, seed ${e.seed??"-"}${e.penetration?`, pushed ${e.penetration.map(t=>gn(t)).join(" to ")} into contact`:""}`:`file ${Vs(e.file??"")}`}function Qw({job:n}){return g("div",{class:"card",children:[g("b",{class:"letter",children:"×"}),g("div",{children:[g("span",{children:Ct(n.poses.count,"pose")}),g("div",{class:"note",children:[jw(n),n.poses.of_both_bodies?", of both bodies":""]}),g("div",{class:"note",children:["level ",$s(n)?"distance":n.level,n.first_hits&&", the first hit of each line",typeof n.up_to=="number"&&`, up to ${Et(n.up_to,6)} ${n.unit}`,n.clearance!==null&&`, clearance ${Et(n.clearance,6)} ${n.unit}`,n.ignored>0&&`, ${Ct(n.ignored,"range")} ignored`]})]})]})}function e1({job:n}){let e=[["where",n.where],["instructions",n.simd],["time",n.seconds>0?`${jr(n.seconds)}, ${yr(n.scenarios_per_second)}`:""],["owner",n.owner],["started",n.started||n.began],["ended",n.ended],["command",n.command],["program",[n.program,n.commit].filter(s=>s!=="").join(", commit ")],["digest",n.digest??""],...n.bodies.map(s=>[`mesh ${s.name}`,`${s.sha256} (${zs(s.bytes)}), ${s.file}`])],t=n.folder?Ya(n.folder):n.job,i=(n.formats??[]).length>0?`the folder has ${n.formats?.join(", ")}; more:`:"";return g("details",{class:"how",children:[g("summary",{children:"how it ran, and exports"}),g("dl",{children:e.filter(([,s])=>s).map(([s,r])=>g("div",{children:[g("dt",{children:s}),g("dd",{children:g("bdi",{children:r})})]},s))}),g("p",{class:"note",children:[i," ",g(Wc,{text:`cdctl results ${t}${n.folder?"":" --out out"} --formats csv,npz`})]})]})}function t1(n,e){qe(()=>yi("job",()=>({ready:n!==void 0&&e!==null,job:n?.job,done:n?.done,isExact:e?.isExact,tested:e?.classes.reduce((t,i)=>t+(i===255?0:1),0)})),[n,e])}function n1(n){let[e,t]=et(()=>Ff(n.query));return qe(()=>t(Ff(n.query)),[n]),qe(()=>(Mc(()=>ks(n.job,I_(e))),xr),[e]),[e,i=>t(s=>({...s,...i}))]}function rx({source:n,route:e}){let t=e.job,[i,s]=n1(e),[r,o]=et(!1),{value:a,error:l}=Ws(`jobs/${encodeURIComponent(t)}`,1,h=>!sx(h)),{results:c,error:u}=tx(n,a),f=St(()=>c?.worst()??0,[c]);return Sr(a&&a.name||t),t1(a,c),Qc({"?":()=>o(!0)}),a?g(Tt,{children:[(l||u)&&g(Pt,{kind:"bad",children:l||u}),a.failure&&g(Pt,{kind:"bad",children:["failed: ",g(Mt,{text:a.failure})]}),a.paused&&g(Pt,{kind:"warn",children:["paused: ",a.paused]}),g(Yw,{job:a}),g("div",{class:"cards",children:[a.bodies.map((h,d)=>Nt(a)&&d===1?g(Zw,{job:a,body:h},d):g(Kw,{body:h,letter:d===0?"A":d===1?"B":String(d),unit:a.unit},d)),g(Qw,{job:a}),g("a",{class:"card go",href:mn(a.job,f),children:"see it in 3D"})]}),g(Jw,{job:a}),c?g(Tt,{children:[g("div",{class:"two",children:[g(Q_,{source:n,job:a,results:c,view:i,change:s}),a.groups?g(P_,{job:a,groups:a.groups}):g(Nf,{job:a,results:c})]}),g(ex,{source:n,job:a,results:c,view:i,change:s}),$s(a)&&g("div",{class:"two",children:g(A_,{job:a,results:c})}),Nt(a)&&g("div",{class:"two",children:g(U_,{job:a,results:c})}),g("div",{class:"two",children:[a.groups&&g(Nf,{job:a,results:c}),g(T_,{job:a,results:c})]})]}):g("p",{class:"wait",children:"reading the results…"}),g(e1,{job:a}),g("button",{type:"button",class:"quiet",onClick:()=>o(!0),children:"keys of this page"}),r&&g(jc,{title:"Keys of a job's page",keys:ix,close:()=>o(!1)})]}):l?g(Pt,{kind:"bad",children:l}):g("p",{class:"wait",children:["asking for ",t,"…"]})}var Jf=class{constructor(e,t){this.names=e;this.runs=t}names;runs;runOf(e){let t=0,i=this.runs.length/2;for(;i-t>1;){let s=t+i>>1;this.runs[2*s]<=e?t=s:i=s}return t}partOf(e){return this.runs[2*this.runOf(e)+1]}nameOf(e){return this.names[this.partOf(e)]??""}isOf(e,t){return t===""||this.nameOf(e)===t}placeOf(e){let t=this.runOf(e),i=e-this.runs[2*t];for(let s=0;s<t;++s)this.runs[2*s+1]===this.runs[2*t+1]&&(i+=this.runs[2*s+2]-this.runs[2*s]);return i}};async function ox(n,e){return(await An(`jobs/${encodeURIComponent(n)}/parts/${e}/closed`)).values}async function Jo(n,e){let t=`jobs/${encodeURIComponent(n)}/parts/${e}`,[i,s]=await Promise.all([An(t),Ri(`${t}/names`)]);return new Jf(s,i.values)}var i1=[150,155,160],s1=[214,216,219],[r1,o1]=[2,5];function Kf(n,e){return{free:i1,open:vi(o1),event:vi(e?7:r1),unknown:s1}[n]}function Zf(n,e){let[t,i,s]=Kf(n,e);return`rgb(${t} ${i} ${s})`}var a1=65;function Qf(n,e,t){return(1-t)*n+t*e}function l1([n,e,t,i],[s,r,o]){let a=2/(n*n+e*e+t*t+i*i);return[1-a*(t*t+i*i),a*(e*t-n*i),a*(e*i+n*t),s,a*(e*t+n*i),1-a*(e*e+i*i),a*(t*i-n*e),r,a*(e*i-n*t),a*(t*i+n*e),1-a*(e*e+t*t),o]}function jf(n,e,t){let s=n.slice(0,4).reduce((o,a,l)=>o+a*e[l],0)>0?1:-1,r=o=>Qf(n[o],o<4?s*e[o]:e[o],t);return l1([r(0),r(1),r(2),r(3)],[r(4),r(5),r(6)])}function c1({from:n,to:e},t){return{pose_a:jf(n.a,e.a,t),pose_b:jf(n.b,e.b,t)}}function u1({from:n,to:e},t){let i=s=>Qf(n.b[s],e.b[s],t);return qs(Ar(jf(n.a,e.a,t)),[i(4),i(5),i(6)])}function Ko(n,e){return e/2**n.depth}function Zo(n){return n.event===null?null:Ko(n,n.event)}function jo(n){return Zo(n)??0}function ep({pose_a:n,pose_b:e,motion:t},i){return t?c1(t,i??jo(t)):{pose_a:n,pose_b:e}}function eu(n,e){return qc(ep(n,e))}function Qo({class:n}){return n==="near"||n==="inside"}function ax({motion:n},e){return!n||e===null||e===jo(n)}function oo(n){let e=[],t=(s,r,o)=>{(s<r||o==="event")&&e.push({from:Ko(n,s),to:Ko(n,r),kind:o})};for(let{state:s,first:r,count:o,event_first:a,event_last:l}of n.runs){if(a===null||l===null){t(r,r+o,s);continue}t(r,a,"open"),t(a,l,"event"),t(l,r+o,"open")}let i=n.runs.at(-1);return t(i?i.first+i.count:0,2**n.depth,"unknown"),e}function h1(n,e){let t=n.filter(({from:i,to:s})=>i<=e&&e<=s).map(({kind:i})=>i);return["event","open","free"].find(i=>t.includes(i))??"unknown"}function lx(n){return oo(n).map(({from:e,to:t,kind:i})=>{let s=e===t?0:Math.max(1,Math.ceil((t-e)*(a1-1)));return{points:Array.from({length:s+1},(o,a)=>u1(n,s===0?e:Qf(e,t,a/s))),kind:i}})}function cx(n){return String(Number(n.toPrecision(6)))}function ux(n,e){let[t,i]=[n.t0,n.t1].map(r=>cx(Ko(n,r))),s=e?"near":"in contact";return n.until==="free"&&n.end==="free"?`free from ${i} of the way on`:n.end==="limit"&&n.event===null?`known up to ${i} of the way`:n.event===null?n.runs.some(({state:r})=>r==="open")?"not decided where open":"free throughout":n.until==="free"?`${s} at ${t} of the way, not free up to ${i}`:t===i?`${s} at ${i} of the way`:`first ${s} between ${t} and ${i} of the way`}function hx(n,e,t){let i=h1(oo(n),t),s={free:"free",open:"open: not decided",event:e?"near":"in contact",unknown:"not searched"}[i],r=Zo(n),o=r===null?"no contacts to draw":t===r?"the event, contacts are drawn":"contacts are drawn at the event only";return`at ${cx(t)} of the way: ${s}; ${o}`}var[ao,tu]=[1e3,14],d1=4,f1=2**-10;function p1({motion:n,isNear:e,tau:t}){let i=[...new Set([n.t0,n.t1])].map(o=>ao*Ko(n,o)),s=oo(n),r=[...s.filter(o=>o.kind!=="event"),...s.filter(o=>o.kind==="event")];return g("svg",{viewBox:`0 -6 ${ao} ${tu+12}`,preserveAspectRatio:"none","aria-hidden":"true",children:[r.map(({from:o,to:a,kind:l})=>{let c=Math.max(ao*(a-o),l==="event"?d1:0),u=Math.min(ao*o,ao-c);return g("rect",{class:l,x:u,y:0,width:c,height:tu,fill:Zf(l,e)},`${o} ${l}`)}),i.map(o=>g("line",{class:"bracket",x1:o,x2:o,y1:-6,y2:tu+6},o)),g("line",{class:"now",x1:ao*t,x2:ao*t,y1:-2,y2:tu+2})]})}function m1({motion:n,isNear:e}){let t={free:"free",open:"open",event:e?"near":"in contact",unknown:"not searched"},i=new Set(oo(n).map(({kind:s})=>s));return g("span",{class:"time-legend note",children:Object.keys(t).filter(s=>i.has(s)).map(s=>g("span",{children:[g("i",{style:{background:Zf(s,e)}})," ",t[s]]},s))})}function dx(n){let{motion:e,choose:t}=n,i=Qo(n.scenario),s=n.tau??jo(e),r=hx(e,i,s);return g("section",{class:"time-line","aria-label":"time of the motion",children:[g(p1,{motion:e,isNear:i,tau:s}),g("div",{children:[g("input",{type:"range","aria-label":"time","aria-valuetext":r,min:0,max:1,step:Math.max(f1,2**-e.depth),value:s,onInput:o=>t(Number(o.currentTarget.value))}),g("button",{type:"button",disabled:Zo(e)===null,onClick:()=>t(null),title:"e",children:"event"})]}),g("output",{children:r}),g(m1,{motion:e,isNear:i})]})}function fx(n){return g("fieldset",{class:"radio",children:[g("legend",{children:n.title}),n.all.map(([e,t])=>g("label",{children:[g("input",{type:"radio",name:n.name,checked:n.value===e,onChange:()=>n.choose(e)}),g("span",{children:t})]},e))]})}function nu(n){return g("label",{class:"check",children:[g("input",{type:"checkbox",checked:n.isOn,onChange:e=>n.turn(e.currentTarget.checked)}),n.text]})}function g1(n){let{clip:e}=n.state,[t,i]=n.bounds[e?.axis??"x"],s=r=>(n.bounds[r][0]+n.bounds[r][1])/2;return g("div",{class:"section-plane",children:[g(nu,{text:"section",isOn:e!==null,turn:r=>n.change({clip:r?{axis:"x",at:s("x")}:null})}),e&&g(Tt,{children:[g("select",{"aria-label":"axis of the section plane",value:e.axis,onChange:r=>{let o=r.currentTarget.value;n.change({clip:{axis:o,at:s(o)}})},children:["x","y","z"].map(r=>g("option",{children:r},r))}),g("input",{type:"range","aria-label":"place of the section plane",min:t,max:i,step:(i-t)/500||1,value:e.at,onInput:r=>n.change({clip:{axis:e.axis,at:Number(r.currentTarget.value)}})}),g("output",{children:Number(e.at.toPrecision(4))})]})]})}function px(n){let{state:e,change:t}=n,i=[["contacts","contacts"]];n.hasMap&&i.push(["heat","heat map"]);let s=[["a","A"],["b","B"],["none","none"]];return g("section",{class:"view-controls","aria-label":"view",children:[g(fx,{title:"show",name:"mode",value:e.mode,all:i,choose:r=>t({mode:r})}),g(fx,{title:"ghost",name:"ghost",value:e.ghost,all:s,choose:r=>t({ghost:r})}),g(nu,{text:"through walls",isOn:e.throughWalls,turn:r=>t({throughWalls:r})}),n.lines.hasAllHits&&g(nu,{text:"first hits only",isOn:e.onlyFirst,turn:r=>t({onlyFirst:r})}),g(nu,{text:n.lines.name,isOn:e.lines,turn:r=>t({lines:r})}),g(g1,{state:e,bounds:n.bounds,change:t}),g("div",{class:"buttons",children:[g("button",{type:"button",onClick:n.fit,title:"f",children:"fit"}),g("button",{type:"button",onClick:n.goToContact,title:"c",children:["go to the ",n.lines.areDrawn?"hits":"contact"]})]})]})}function mx({address:n}){let[e,t]=et("");return g("button",{type:"button",onClick:()=>If(n(),t),children:e||"copy link"})}var ol=[[68,1,84],[71,45,123],[59,82,139],[44,114,142],[33,145,140],[40,174,128],[94,201,98],[173,220,48],[253,231,37]];function tp(n){let e=Math.min(1,Math.max(0,n))*(ol.length-1),t=Math.min(ol.length-2,Math.floor(e)),i=e-t;return[0,1,2].map(s=>Math.round(ol[t][s]+(ol[t+1][s]-ol[t][s])*i))}function gx(n){let e=new Uint8Array(1024);for(let t=0;t<256;++t)e.set([...t===0?n:tp((t-1)/254),255],4*t);return e}function _1(n,e){return n===0?0:e<=1?255:1+Math.round(254*Math.log(n)/Math.log(e))}function _x(n,e){let t=new Float64Array(e);for(let i=0;i+1<n.length;i+=2)t[n[i]]=n[i+1];return t}function xx(n,e){let t=new Uint8Array(3*n.length);for(let i=0;i<n.length;++i)t.fill(_1(n[i],e),3*i,3*i+3);return t}var iu=48;function x1(n){let e=[1];for(let t=10;t<n/2;t*=10)e.push(t);return n>1?[...e,n]:e}function yx(n){return n.clearance===null?"in contact":"in contact or near"}function vx({heat:n,job:e}){if(n.most===0)return g("p",{class:"note",children:["no triangle was ",Nt(e)?"crossed":yx(e)]});let[t,i]=[264,10],s=o=>n.most<=1?0:Math.log(o)/Math.log(n.most)*t,r=x1(n.most);return g("figure",{class:"legend",children:[g("svg",{viewBox:`0 0 ${t} 42`,role:"img","aria-label":"colours of the heat map",children:[Array.from({length:iu},(o,a)=>{let[l,c,u]=tp(a/(iu-1));return g("rect",{x:a*t/iu,y:0,width:t/iu+.5,height:i,fill:`rgb(${l},${c},${u})`},a)}),r.map((o,a)=>g("g",{children:[g("line",{x1:s(o),x2:s(o),y1:i,y2:i+3}),g("text",{x:s(o),y:i+14,class:a===0?"begin":a===r.length-1?"end":"",children:Re(o)}),g("text",{x:s(o),y:i+27,class:a===0?"begin":a===r.length-1?"end":"",children:Nt(e)?"":gn(o/Math.max(1,e.done))})]},o))]}),g("figcaption",{class:"note",children:[Nt(e)?"how often lines cross a triangle":`scenarios in which a triangle is ${yx(e)}`,", logarithmic",e.map_pairs>0&&`, of the first ${Re(e.map_pairs)} pairs`,"; plain: never"]})]})}function bx(n){return $s(n)?"the nearest triangles: the line joins their nearest points":n.clearance===null?"":"near: the line joins the nearest points"}function Sx({near:n}){return g("ul",{class:"legend plain",children:[g("li",{children:[g("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:g("path",{d:"M1 11 7 1l6 10z",fill:wr(2)})}),"proper: goes through the other"]}),g("li",{children:[g("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:g("path",{d:"M1 11 7 1l6 10z",fill:wr(1),class:"outlined"})}),"touch or coplanar: outlined"]}),g("li",{children:[g("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:[g("path",{d:"M1 9 11 4",class:"thick"}),g("circle",{cx:12,cy:4,r:2})]}),"what they share"]}),n&&g("li",{children:[g("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:g("path",{d:"M1 11 7 1l6 10z",fill:wr(7),class:"outlined"})}),n]})]})}var Mx=["enters","leaves","grazes"],al=class{constructor(e,t){this.pairs=e;this.rows=t;for(let i=0;i<this.count;++i){let s=this.lineOf(i),r=this.byLine.get(s);r?r.push(i):this.byLine.set(s,[i])}this.byLine.forEach(i=>i.sort((s,r)=>this.compare(s,r)))}pairs;rows;byLine=new Map;get count(){return Math.min(this.rows.length,this.pairs.length)/3}triangleOf(e){return this.pairs[3*e]}lineOf(e){return this.pairs[3*e+1]}depthOf(e){return this.rows[3*e]}doesCross(e){return(this.rows[3*e+1]&1)!==0}kindOf(e){return this.doesCross(e)?(this.rows[3*e+1]&4)!==0?"leaves":"enters":"grazes"}compare(e,t){let i=s=>(this.rows[3*s+1]&4)===0?1:0;return this.depthOf(e)-this.depthOf(t)||this.rows[3*e+2]-this.rows[3*t+2]||i(e)-i(t)||this.triangleOf(e)-this.triangleOf(t)}get lines(){return[...this.byLine.keys()]}ofLine(e){return this.byLine.get(e)??[]}shown(e){return[...this.byLine.values()].flatMap(t=>e?t.filter(i=>this.doesCross(i)).slice(0,1):t)}};function wx(n,e,t,i){let s=[],r=new Map;for(let o of n.ofLine(e).filter(a=>n.doesCross(a))){let a=t(n.triangleOf(o)),l=r.get(a);if(l){l.out=o,r.delete(a);continue}let c={part:a,in:o,out:null};s.push(c),i(a)&&r.set(a,c)}return s}function su(n,e){let t=i=>{let s=3*n.triangles[3*e+i];return Array.from(n.vertices.subarray(s,s+3))};return[t(0),t(1)]}function Ax([n,e],t){let i=Math.hypot(...e.map((s,r)=>s-n[r]));return n.map((s,r)=>s+(e[r]-s)/i*t)}function Tx(n,e,t,i){let s=[1/0,1/0,1/0],r=[-1/0,-1/0,-1/0];for(let o=0;o<e.triangles.length;++o)if(t.partOf(Math.floor(o/3))===i)for(let a=0;a<3;++a){let l=e.vertices[3*e.triangles[o]+a];s[a]=Math.min(s[a],l),r[a]=Math.max(r[a],l)}return!n.some(o=>o.every((a,l)=>a>=s[l]&&a<=r[l]))}var Vr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Hr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},oy=0,Lp=1,ay=2;var Vl=1,ly=2,Ta=3,Gr=0,_i=1,Si=2,fo=0,Ea=1,Dp=2,Np=3,Up=4,cy=5;var po=100,uy=101,hy=102,dy=103,fy=104,py=200,my=201,gy=202,_y=203,Op=204,Fp=205,xy=206,yy=207,vy=208,by=209,Sy=210,My=211,wy=212,Ay=213,Ty=214,Lu=0,Du=1,Nu=2,Nr=3,Uu=4,Ou=5,Fu=6,ku=7,hh=0,Ey=1,Cy=2,Es=0,kp=1,Bp=2,zp=3,Vp=4,Hp=5,Gp=6,Wp=7;var Xp=300,mo=301,Ca=302,dh=303,fh=304,Bu=1e3,Ms=1001,zu=1002,_n=1003,Ry=1004;var Hl=1005;var gi=1006,ph=1007;var or=1008;var Mi=1009,$p=1010,qp=1011,Ra=1012,mh=1013,us=1014,hs=1015,ds=1016,gh=1017,_h=1018,go=1020,Yp=35902,Jp=35899,Kp=1021,Zp=1022,ki=1023,nr=1026,ar=1027,jp=1028,xh=1029,Wr=1030,yh=1031;var vh=1033,Gl=33776,Wl=33777,Xl=33778,$l=33779,bh=35840,Sh=35841,Mh=35842,wh=35843,Ah=36196,Th=37492,Eh=37496,Ch=37488,Rh=37489,ql=37490,Ph=37491,Ih=37808,Lh=37809,Dh=37810,Nh=37811,Uh=37812,Oh=37813,Fh=37814,kh=37815,Bh=37816,zh=37817,Vh=37818,Hh=37819,Gh=37820,Wh=37821,Xh=36492,$h=36494,qh=36495,Yh=36283,Jh=36284,Yl=36285,Kh=36286;var gl=2300,Vu=2301,Pu=2302,wp=2303,Ap=2400,Tp=2401,Ep=2402;var Py=3200;var Zh=0,Iy=1,lr="",dn="srgb",_l="srgb-linear",xl="linear",Ft="srgb";var Iu=7680;var Ly=519,Dy=512,Ny=513,Uy=514,Qp=515,Oy=516,Fy=517,em=518,tm=519,nm=35044;var im="300 es",$i=2e3,ga=2001;function y1(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function v1(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function yl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function ky(){let n=yl("canvas");return n.style.display="block",n}var Ex={},_a=null;function vl(...n){let e="THREE."+n.shift();_a?_a("log",e,...n):console.log(e,...n)}function By(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ke(...n){n=By(n);let e="THREE."+n.shift();if(_a)_a("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function st(...n){n=By(n);let e="THREE."+n.shift();if(_a)_a("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function fl(...n){let e=n.join(" ");e in Ex||(Ex[e]=!0,Ke(...n))}function zy(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Vy={[Lu]:Lu,[Nu]:Fu,[Uu]:Uu,[Nr]:Ou,[Du]:Du,[Fu]:Nu,[ku]:ku,[Ou]:Nr},as=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},ni=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Cx=1234567,pl=Math.PI/180,xa=180/Math.PI;function Xr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(ni[n&255]+ni[n>>8&255]+ni[n>>16&255]+ni[n>>24&255]+"-"+ni[e&255]+ni[e>>8&255]+"-"+ni[e>>16&15|64]+ni[e>>24&255]+"-"+ni[t&63|128]+ni[t>>8&255]+"-"+ni[t>>16&255]+ni[t>>24&255]+ni[i&255]+ni[i>>8&255]+ni[i>>16&255]+ni[i>>24&255]).toLowerCase()}function ut(n,e,t){return Math.max(e,Math.min(t,n))}function sm(n,e){return(n%e+e)%e}function b1(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function S1(n,e,t){return n!==e?(t-n)/(e-n):0}function ml(n,e,t){return(1-t)*n+t*e}function M1(n,e,t,i){return ml(n,e,1-Math.exp(-t*i))}function w1(n,e=1){return e-Math.abs(sm(n,e*2)-e)}function A1(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function T1(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function E1(n,e){return n+Math.floor(Math.random()*(e-n+1))}function C1(n,e){return n+Math.random()*(e-n)}function R1(n){return n*(.5-Math.random())}function P1(n){n!==void 0&&(Cx=n);let e=Cx+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function I1(n){return n*pl}function L1(n){return n*xa}function D1(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function N1(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function rm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function U1(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:Ke("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function jh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function om(n,e){if(e.constructor===Float32Array)return n;let t=jh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function am(n,e){if(e.constructor===Float32Array)return n;let t=jh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Jl={DEG2RAD:pl,RAD2DEG:xa,generateUUID:Xr,clamp:ut,euclideanModulo:sm,mapLinear:b1,inverseLerp:S1,lerp:ml,damp:M1,pingpong:w1,smoothstep:A1,smootherstep:T1,randInt:E1,randFloat:C1,randFloatSpread:R1,seededRandom:P1,degToRad:I1,radToDeg:L1,isPowerOfTwo:D1,ceilPowerOfTwo:N1,floorPowerOfTwo:rm,setQuaternionFromProperEuler:U1,normalize:am,denormalize:om},je=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ui=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],b=r[o+3];if(f!==b||l!==h||c!==d||u!==p){let m=l*h+c*d+u*p+f*b;m<0&&(h=-h,d=-d,p=-p,b=-b,m=-m);let _=1-a;if(m<.9995){let v=Math.acos(m),C=Math.sin(v);_=Math.sin(_*v)/C,a=Math.sin(a*v)/C,l=l*_+h*a,c=c*_+d*a,u=u*_+p*a,f=f*_+b*a}else{l=l*_+h*a,c=c*_+d*a,u=u*_+p*a,f=f*_+b*a;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:Ke("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ut(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},k=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(Rx.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(Rx.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return np.copy(this).projectOnVector(e),this.sub(np)}reflect(e){return this.sub(np.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},np=new k,Rx=new Ui,ot=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],b=s[0],m=s[3],_=s[6],v=s[1],C=s[4],S=s[7],I=s[2],T=s[5],y=s[8];return r[0]=o*b+a*v+l*I,r[3]=o*m+a*C+l*T,r[6]=o*_+a*S+l*y,r[1]=c*b+u*v+f*I,r[4]=c*m+u*C+f*T,r[7]=c*_+u*S+f*y,r[2]=h*b+d*v+p*I,r[5]=h*m+d*C+p*T,r[8]=h*_+d*S+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/p;return e[0]=f*b,e[1]=(s*c-u*i)*b,e[2]=(a*i-s*o)*b,e[3]=h*b,e[4]=(u*t-s*l)*b,e[5]=(s*r-a*t)*b,e[6]=d*b,e[7]=(i*l-c*t)*b,e[8]=(o*t-i*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return fl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(ip.makeScale(e,t)),this}rotate(e){return fl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(ip.makeRotation(-e)),this}translate(e,t){return fl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(ip.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},ip=new ot,Px=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ix=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function O1(){let n={enabled:!0,workingColorSpace:_l,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Ft&&(s.r=tr(s.r),s.g=tr(s.g),s.b=tr(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Ft&&(s.r=ma(s.r),s.g=ma(s.g),s.b=ma(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===lr?xl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[_l]:{primaries:e,whitePoint:i,transfer:xl,toXYZ:Px,fromXYZ:Ix,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:dn},outputColorSpaceConfig:{drawingBufferColorSpace:dn}},[dn]:{primaries:e,whitePoint:i,transfer:Ft,toXYZ:Px,fromXYZ:Ix,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:dn}}}),n}var vt=O1();function tr(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ma(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ea,Hu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ea===void 0&&(ea=yl("canvas")),ea.width=e.width,ea.height=e.height;let s=ea.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=ea}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=yl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=tr(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(tr(t[i]/255)*255):t[i]=tr(t[i]);return{data:t,width:e.width,height:e.height}}else return Ke("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},F1=0,ya=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:F1++}),this.uuid=Xr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(sp(s[o].image)):r.push(sp(s[o]))}else r=sp(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function sp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Hu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ke("Texture: Unable to serialize Texture."),{})}var k1=0,rp=new k,bi=class n extends as{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Ms,s=Ms,r=gi,o=or,a=ki,l=Mi,c=n.DEFAULT_ANISOTROPY,u=lr){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:k1++}),this.uuid=Xr(),this.name="",this.source=new ya(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new je(0,0),this.repeat=new je(1,1),this.center=new je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(rp).x}get height(){return this.source.getSize(rp).y}get depth(){return this.source.getSize(rp).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ke(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Xp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case Bu:e.x=e.x-Math.floor(e.x);break;case Ms:e.x=e.x<0?0:1;break;case zu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case Bu:e.y=e.y-Math.floor(e.y);break;case Ms:e.y=e.y<0?0:1;break;case zu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};bi.DEFAULT_IMAGE=null;bi.DEFAULT_MAPPING=Xp;bi.DEFAULT_ANISOTROPY=1;var kt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],b=l[2],m=l[6],_=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-b)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+b)<.1&&Math.abs(p+m)<.1&&Math.abs(c+d+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,S=(d+1)/2,I=(_+1)/2,T=(u+h)/4,y=(f+b)/4,E=(p+m)/4;return C>S&&C>I?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=T/i,r=y/i):S>I?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=T/s,r=E/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=y/r,s=E/r),this.set(i,s,r,t),this}let v=Math.sqrt((m-p)*(m-p)+(f-b)*(f-b)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(f-b)/v,this.z=(h-u)/v,this.w=Math.acos((c+d+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this.w=ut(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this.w=ut(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Gu=class extends as{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:gi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new kt(0,0,e,t),this.scissorTest=!1,this.viewport=new kt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new bi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:gi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new ya(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Oi=class extends Gu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},bl=class extends bi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=Ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Wu=class extends bi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=_n,this.minFilter=_n,this.wrapR=Ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var wt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m){let _=this.elements;return _[0]=e,_[4]=t,_[8]=i,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=f,_[14]=h,_[3]=d,_[7]=p,_[11]=b,_[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/ta.setFromMatrixColumn(e,0).length(),r=1/ta.setFromMatrixColumn(e,1).length(),o=1/ta.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-b*c,t[9]=-a*l,t[2]=b-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h+b*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=b+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h-b*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=b-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+b,t[1]=l*f,t[5]=b*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=b-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-b*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+b,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=b*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(B1,e,z1)}lookAt(e,t,i){let s=this.elements;return Di.subVectors(e,t),Di.lengthSq()===0&&(Di.z=1),Di.normalize(),Cr.crossVectors(i,Di),Cr.lengthSq()===0&&(Math.abs(i.z)===1?Di.x+=1e-4:Di.z+=1e-4,Di.normalize(),Cr.crossVectors(i,Di)),Cr.normalize(),ru.crossVectors(Di,Cr),s[0]=Cr.x,s[4]=ru.x,s[8]=Di.x,s[1]=Cr.y,s[5]=ru.y,s[9]=Di.y,s[2]=Cr.z,s[6]=ru.z,s[10]=Di.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],b=i[6],m=i[10],_=i[14],v=i[3],C=i[7],S=i[11],I=i[15],T=s[0],y=s[4],E=s[8],V=s[12],U=s[1],L=s[5],G=s[9],z=s[13],N=s[2],W=s[6],Y=s[10],H=s[14],ae=s[3],K=s[7],$=s[11],ee=s[15];return r[0]=o*T+a*U+l*N+c*ae,r[4]=o*y+a*L+l*W+c*K,r[8]=o*E+a*G+l*Y+c*$,r[12]=o*V+a*z+l*H+c*ee,r[1]=u*T+f*U+h*N+d*ae,r[5]=u*y+f*L+h*W+d*K,r[9]=u*E+f*G+h*Y+d*$,r[13]=u*V+f*z+h*H+d*ee,r[2]=p*T+b*U+m*N+_*ae,r[6]=p*y+b*L+m*W+_*K,r[10]=p*E+b*G+m*Y+_*$,r[14]=p*V+b*z+m*H+_*ee,r[3]=v*T+C*U+S*N+I*ae,r[7]=v*y+C*L+S*W+I*K,r[11]=v*E+C*G+S*Y+I*$,r[15]=v*V+C*z+S*H+I*ee,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],b=e[7],m=e[11],_=e[15],v=l*d-c*h,C=a*d-c*f,S=a*h-l*f,I=o*d-c*u,T=o*h-l*u,y=o*f-a*u;return t*(b*v-m*C+_*S)-i*(p*v-m*I+_*T)+s*(p*C-b*I+_*y)-r*(p*S-b*T+m*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],b=e[13],m=e[14],_=e[15],v=t*a-i*o,C=t*l-s*o,S=t*c-r*o,I=i*l-s*a,T=i*c-r*a,y=s*c-r*l,E=u*b-f*p,V=u*m-h*p,U=u*_-d*p,L=f*m-h*b,G=f*_-d*b,z=h*_-d*m,N=v*z-C*G+S*L+I*U-T*V+y*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*z-l*G+c*L)*W,e[1]=(s*G-i*z-r*L)*W,e[2]=(b*y-m*T+_*I)*W,e[3]=(h*T-f*y-d*I)*W,e[4]=(l*U-o*z-c*V)*W,e[5]=(t*z-s*U+r*V)*W,e[6]=(m*S-p*y-_*C)*W,e[7]=(u*y-h*S+d*C)*W,e[8]=(o*G-a*U+c*E)*W,e[9]=(i*U-t*G-r*E)*W,e[10]=(p*T-b*S+_*v)*W,e[11]=(f*S-u*T-d*v)*W,e[12]=(a*V-o*L-l*E)*W,e[13]=(t*L-i*V+s*E)*W,e[14]=(b*C-p*I-m*v)*W,e[15]=(u*I-f*C+h*v)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,b=o*u,m=o*f,_=a*f,v=l*c,C=l*u,S=l*f,I=i.x,T=i.y,y=i.z;return s[0]=(1-(b+_))*I,s[1]=(d+S)*I,s[2]=(p-C)*I,s[3]=0,s[4]=(d-S)*T,s[5]=(1-(h+_))*T,s[6]=(m+v)*T,s[7]=0,s[8]=(p+C)*y,s[9]=(m-v)*y,s[10]=(1-(h+b))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=ta.set(s[0],s[1],s[2]).length(),a=ta.set(s[4],s[5],s[6]).length(),l=ta.set(s[8],s[9],s[10]).length();r<0&&(o=-o),ss.copy(this);let c=1/o,u=1/a,f=1/l;return ss.elements[0]*=c,ss.elements[1]*=c,ss.elements[2]*=c,ss.elements[4]*=u,ss.elements[5]*=u,ss.elements[6]*=u,ss.elements[8]*=f,ss.elements[9]*=f,ss.elements[10]*=f,t.setFromRotationMatrix(ss),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=$i,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,b;if(l)p=r/(o-r),b=o*r/(o-r);else if(a===$i)p=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===ga)p=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=$i,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,b;if(l)p=1/(o-r),b=o/(o-r);else if(a===$i)p=-2/(o-r),b=-(o+r)/(o-r);else if(a===ga)p=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ta=new k,ss=new wt,B1=new k(0,0,0),z1=new k(1,1,1),Cr=new k,ru=new k,Di=new k,Lx=new wt,Dx=new Ui,ir=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ut(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ut(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ut(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ut(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ut(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ut(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Ke("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Lx.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Lx,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Dx.setFromEuler(this),this.setFromQuaternion(Dx,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ir.DEFAULT_ORDER="XYZ";var Sl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},V1=0,Nx=new k,na=new Ui,Ks=new wt,ou=new k,ll=new k,H1=new k,G1=new Ui,Ux=new k(1,0,0),Ox=new k(0,1,0),Fx=new k(0,0,1),kx={type:"added"},W1={type:"removed"},ia={type:"childadded",child:null},op={type:"childremoved",child:null},Xn=class n extends as{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:V1++}),this.uuid=Xr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new k,t=new ir,i=new Ui,s=new k(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new wt},normalMatrix:{value:new ot}}),this.matrix=new wt,this.matrixWorld=new wt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Sl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return na.setFromAxisAngle(e,t),this.quaternion.multiply(na),this}rotateOnWorldAxis(e,t){return na.setFromAxisAngle(e,t),this.quaternion.premultiply(na),this}rotateX(e){return this.rotateOnAxis(Ux,e)}rotateY(e){return this.rotateOnAxis(Ox,e)}rotateZ(e){return this.rotateOnAxis(Fx,e)}translateOnAxis(e,t){return Nx.copy(e).applyQuaternion(this.quaternion),this.position.add(Nx.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Ux,e)}translateY(e){return this.translateOnAxis(Ox,e)}translateZ(e){return this.translateOnAxis(Fx,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ks.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?ou.copy(e):ou.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),ll.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ks.lookAt(ll,ou,this.up):Ks.lookAt(ou,ll,this.up),this.quaternion.setFromRotationMatrix(Ks),s&&(Ks.extractRotation(s.matrixWorld),na.setFromRotationMatrix(Ks),this.quaternion.premultiply(na.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(st("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(kx),ia.child=e,this.dispatchEvent(ia),ia.child=null):st("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(W1),op.child=e,this.dispatchEvent(op),op.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ks.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ks.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ks),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(kx),ia.child=e,this.dispatchEvent(ia),ia.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ll,e,H1),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(ll,G1,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Xn.DEFAULT_UP=new k(0,1,0);Xn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Xn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Gn=class extends Xn{constructor(){super(),this.isGroup=!0,this.type="Group"}},X1={type:"move"},va=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Gn,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Gn,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new k,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new k),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Gn,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new k,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new k,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,i),_=this._getHandJoint(c,b);m!==null&&(_.matrix.fromArray(m.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=m.radius),_.visible=m!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(X1)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Gn;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Hy={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Rr={h:0,s:0,l:0},au={h:0,s:0,l:0};function ap(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var lt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=dn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=vt.workingColorSpace){if(e=sm(e,1),t=ut(t,0,1),i=ut(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=ap(o,r,e+1/3),this.g=ap(o,r,e),this.b=ap(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=dn){function i(r){r!==void 0&&parseFloat(r)<1&&Ke("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ke("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ke("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=dn){let i=Hy[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ke("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=tr(e.r),this.g=tr(e.g),this.b=tr(e.b),this}copyLinearToSRGB(e){return this.r=ma(e.r),this.g=ma(e.g),this.b=ma(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=dn){return vt.workingToColorSpace(ii.copy(this),e),Math.round(ut(ii.r*255,0,255))*65536+Math.round(ut(ii.g*255,0,255))*256+Math.round(ut(ii.b*255,0,255))}getHexString(e=dn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(ii.copy(this),t);let i=ii.r,s=ii.g,r=ii.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(ii.copy(this),t),e.r=ii.r,e.g=ii.g,e.b=ii.b,e}getStyle(e=dn){vt.workingToColorSpace(ii.copy(this),e);let t=ii.r,i=ii.g,s=ii.b;return e!==dn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Rr),this.setHSL(Rr.h+e,Rr.s+t,Rr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Rr),e.getHSL(au);let i=ml(Rr.h,au.h,t),s=ml(Rr.s,au.s,t),r=ml(Rr.l,au.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ii=new lt;lt.NAMES=Hy;var Ml=class extends Xn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ir,this.environmentIntensity=1,this.environmentRotation=new ir,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},rs=new k,Zs=new k,lp=new k,js=new k,sa=new k,ra=new k,Bx=new k,cp=new k,up=new k,hp=new k,dp=new kt,fp=new kt,pp=new kt,Dr=class n{constructor(e=new k,t=new k,i=new k){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),rs.subVectors(e,t),s.cross(rs);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){rs.subVectors(s,t),Zs.subVectors(i,t),lp.subVectors(e,t);let o=rs.dot(rs),a=rs.dot(Zs),l=rs.dot(lp),c=Zs.dot(Zs),u=Zs.dot(lp),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,js)===null?!1:js.x>=0&&js.y>=0&&js.x+js.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,js)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,js.x),l.addScaledVector(o,js.y),l.addScaledVector(a,js.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return dp.setScalar(0),fp.setScalar(0),pp.setScalar(0),dp.fromBufferAttribute(e,t),fp.fromBufferAttribute(e,i),pp.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(dp,r.x),o.addScaledVector(fp,r.y),o.addScaledVector(pp,r.z),o}static isFrontFacing(e,t,i,s){return rs.subVectors(i,t),Zs.subVectors(e,t),rs.cross(Zs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return rs.subVectors(this.c,this.b),Zs.subVectors(this.a,this.b),rs.cross(Zs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;sa.subVectors(s,i),ra.subVectors(r,i),cp.subVectors(e,i);let l=sa.dot(cp),c=ra.dot(cp);if(l<=0&&c<=0)return t.copy(i);up.subVectors(e,s);let u=sa.dot(up),f=ra.dot(up);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(sa,o);hp.subVectors(e,r);let d=sa.dot(hp),p=ra.dot(hp);if(p>=0&&d<=p)return t.copy(r);let b=d*c-l*p;if(b<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(ra,a);let m=u*p-d*f;if(m<=0&&f-u>=0&&d-p>=0)return Bx.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(Bx,a);let _=1/(m+b+h);return o=b*_,a=h*_,t.copy(i).addScaledVector(sa,o).addScaledVector(ra,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},si=class{constructor(e=new k(1/0,1/0,1/0),t=new k(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(os.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(os.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=os.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,os):os.fromBufferAttribute(r,o),os.applyMatrix4(e.matrixWorld),this.expandByPoint(os);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),lu.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),lu.copy(i.boundingBox)),lu.applyMatrix4(e.matrixWorld),this.union(lu)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,os),os.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(cl),cu.subVectors(this.max,cl),oa.subVectors(e.a,cl),aa.subVectors(e.b,cl),la.subVectors(e.c,cl),Pr.subVectors(aa,oa),Ir.subVectors(la,aa),lo.subVectors(oa,la);let t=[0,-Pr.z,Pr.y,0,-Ir.z,Ir.y,0,-lo.z,lo.y,Pr.z,0,-Pr.x,Ir.z,0,-Ir.x,lo.z,0,-lo.x,-Pr.y,Pr.x,0,-Ir.y,Ir.x,0,-lo.y,lo.x,0];return!mp(t,oa,aa,la,cu)||(t=[1,0,0,0,1,0,0,0,1],!mp(t,oa,aa,la,cu))?!1:(uu.crossVectors(Pr,Ir),t=[uu.x,uu.y,uu.z],mp(t,oa,aa,la,cu))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,os).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(os).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Qs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Qs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Qs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Qs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Qs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Qs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Qs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Qs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Qs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Qs=[new k,new k,new k,new k,new k,new k,new k,new k],os=new k,lu=new si,oa=new k,aa=new k,la=new k,Pr=new k,Ir=new k,lo=new k,cl=new k,cu=new k,uu=new k,co=new k;function mp(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){co.fromArray(n,r);let a=s.x*Math.abs(co.x)+s.y*Math.abs(co.y)+s.z*Math.abs(co.z),l=e.dot(co),c=t.dot(co),u=i.dot(co);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var En=new k,hu=new je,$1=0,sn=class extends as{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:$1++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=nm,this.updateRanges=[],this.gpuType=hs,this.version=0,this._normalizationScale=e!==void 0?jh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)hu.fromBufferAttribute(this,t),hu.applyMatrix3(e),this.setXY(t,hu.x,hu.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)En.fromBufferAttribute(this,t),En.applyMatrix3(e),this.setXYZ(t,En.x,En.y,En.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)En.fromBufferAttribute(this,t),En.applyMatrix4(e),this.setXYZ(t,En.x,En.y,En.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)En.fromBufferAttribute(this,t),En.applyNormalMatrix(e),this.setXYZ(t,En.x,En.y,En.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)En.fromBufferAttribute(this,t),En.transformDirection(e),this.setXYZ(t,En.x,En.y,En.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):om(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):am(e,this.array)}};var wl=class extends sn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Al=class extends sn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Wn=class extends sn{constructor(e,t,i){super(new Float32Array(e),t,i)}},q1=new si,ul=new k,gp=new k,$n=class{constructor(e=new k,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):q1.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;ul.subVectors(e,this.center);let t=ul.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(ul,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(gp.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(ul.copy(e.center).add(gp)),this.expandByPoint(ul.copy(e.center).sub(gp))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Y1=0,Xi=new wt,_p=new Xn,ca=new k,Ni=new si,hl=new si,Hn=new k,rn=class n extends as{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Y1++}),this.uuid=Xr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(y1(e)?Al:wl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ot().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Xi.makeRotationFromQuaternion(e),this.applyMatrix4(Xi),this}rotateX(e){return Xi.makeRotationX(e),this.applyMatrix4(Xi),this}rotateY(e){return Xi.makeRotationY(e),this.applyMatrix4(Xi),this}rotateZ(e){return Xi.makeRotationZ(e),this.applyMatrix4(Xi),this}translate(e,t,i){return Xi.makeTranslation(e,t,i),this.applyMatrix4(Xi),this}scale(e,t,i){return Xi.makeScale(e,t,i),this.applyMatrix4(Xi),this}lookAt(e){return _p.lookAt(e),_p.updateMatrix(),this.applyMatrix4(_p.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(ca).negate(),this.translate(ca.x,ca.y,ca.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Wn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ke("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new si);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new k(-1/0,-1/0,-1/0),new k(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ni.setFromBufferAttribute(r),this.morphTargetsRelative?(Hn.addVectors(this.boundingBox.min,Ni.min),this.boundingBox.expandByPoint(Hn),Hn.addVectors(this.boundingBox.max,Ni.max),this.boundingBox.expandByPoint(Hn)):(this.boundingBox.expandByPoint(Ni.min),this.boundingBox.expandByPoint(Ni.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&st('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new $n);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new k,1/0);return}if(e){let i=this.boundingSphere.center;if(Ni.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];hl.setFromBufferAttribute(a),this.morphTargetsRelative?(Hn.addVectors(Ni.min,hl.min),Ni.expandByPoint(Hn),Hn.addVectors(Ni.max,hl.max),Ni.expandByPoint(Hn)):(Ni.expandByPoint(hl.min),Ni.expandByPoint(hl.max))}Ni.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Hn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Hn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Hn.fromBufferAttribute(a,c),l&&(ca.fromBufferAttribute(e,c),Hn.add(ca)),s=Math.max(s,i.distanceToSquared(Hn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&st('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){st("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new sn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let V=0;V<i.count;V++)a[V]=new k,l[V]=new k;let u=new k,f=new k,h=new k,d=new je,p=new je,b=new je,m=new k,_=new k;function v(V,U,L){c[V]=c[U]=c[L]=1,u.fromBufferAttribute(i,V),f.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,V),p.fromBufferAttribute(r,U),b.fromBufferAttribute(r,L),f.sub(u),h.sub(u),p.sub(d),b.sub(d);let G=1/(p.x*b.y-b.x*p.y);isFinite(G)&&(m.copy(f).multiplyScalar(b.y).addScaledVector(h,-p.y).multiplyScalar(G),_.copy(h).multiplyScalar(p.x).addScaledVector(f,-b.x).multiplyScalar(G),a[V].add(m),a[U].add(m),a[L].add(m),l[V].add(_),l[U].add(_),l[L].add(_))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let V=0,U=C.length;V<U;++V){let L=C[V],G=L.start,z=L.count;for(let N=G,W=G+z;N<W;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new k,I=new k,T=new k,y=new k;function E(V){T.fromBufferAttribute(s,V),y.copy(T);let U=a[V];S.copy(U),S.sub(T.multiplyScalar(T.dot(U))).normalize(),I.crossVectors(y,U);let G=I.dot(l[V])<0?-1:1;o.setXYZW(V,S.x,S.y,S.z,G)}for(let V=0,U=i.count;V<U;++V)c[V]&&E(V);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new sn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new k,r=new k,o=new k,a=new k,l=new k,c=new k,u=new k,f=new k;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),b=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,m),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Hn.fromBufferAttribute(e,t),Hn.normalize(),e.setXYZ(t,Hn.x,Hn.y,Hn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let b=0,m=l.length;b<m;b++){a.isInterleavedBufferAttribute?d=l[b]*a.data.stride+a.offset:d=l[b]*u;for(let _=0;_<u;_++)h[p++]=c[d++]}return new sn(h,u,f)}if(this.index===null)return Ke("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Xu=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=nm,this.updateRanges=[],this.version=0,this.uuid=Xr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=zx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=zx(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function zx(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Xr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var fi=new k,ls=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?jh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)fi.fromBufferAttribute(this,t),fi.applyMatrix4(e),this.setXYZ(t,fi.x,fi.y,fi.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)fi.fromBufferAttribute(this,t),fi.applyNormalMatrix(e),this.setXYZ(t,fi.x,fi.y,fi.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)fi.fromBufferAttribute(this,t),fi.transformDirection(e),this.setXYZ(t,fi.x,fi.y,fi.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){vl("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new sn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){vl("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):om(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):am(e,this.data.array)}},xp=new k,J1=new k,K1=new ot,pi=class{constructor(e=new k(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=xp.subVectors(i,t).cross(J1.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(xp),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||K1.getNormalMatrix(e),s=this.coplanarPoint(xp).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Z1=0,ws=class extends as{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Z1++}),this.uuid=Xr(),this.name="",this.type="Material",this.blending=Ea,this.side=Gr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Op,this.blendDst=Fp,this.blendEquation=po,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new lt(0,0,0),this.blendAlpha=0,this.depthFunc=Nr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Ly,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Iu,this.stencilZFail=Iu,this.stencilZPass=Iu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ke(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ke(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new lt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new pi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new je().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new je().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var er=new k,yp=new k,du=new k,fu=new k,Ur=class{constructor(e=new k,t=new k(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,er)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=er.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(er.copy(this.origin).addScaledVector(this.direction,t),er.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){yp.copy(e).add(t).multiplyScalar(.5),du.copy(t).sub(e).normalize(),fu.copy(this.origin).sub(yp);let r=e.distanceTo(t)*.5,o=-this.direction.dot(du),a=fu.dot(this.direction),l=-fu.dot(du),c=fu.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let b=1/u;f*=b,h*=b,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(yp).addScaledVector(du,h),d}intersectSphere(e,t){if(e.radius<0)return null;er.subVectors(e.center,this.origin);let i=er.dot(this.direction),s=er.dot(er)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,er)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,b=t.y-o.y,m=t.z-o.z,_=i.x-o.x,v=i.y-o.y,C=i.z-o.z,S=Math.abs(l),I=Math.abs(c),T=Math.abs(u),y,E,V,U,L,G,z,N,W,Y,H,ae;if(S>=I&&S>=T?(V=l,G=f,W=p,ae=_,l>=0?(y=c,E=u,U=h,L=d,z=b,N=m,Y=v,H=C):(y=u,E=c,U=d,L=h,z=m,N=b,Y=C,H=v)):I>=T?(V=c,G=h,W=b,ae=v,c>=0?(y=u,E=l,U=d,L=f,z=m,N=p,Y=C,H=_):(y=l,E=u,U=f,L=d,z=p,N=m,Y=_,H=C)):(V=u,G=d,W=m,ae=C,u>=0?(y=l,E=c,U=f,L=h,z=p,N=b,Y=_,H=v):(y=c,E=l,U=h,L=f,z=b,N=p,Y=v,H=_)),V===0)return null;let K=y/V,$=E/V,ee=1/V,he=U-K*G,de=L-$*G,te=z-K*W,me=N-$*W,ge=Y-K*ae,Me=H-$*ae,be=ge*me-Me*te,Xe=he*Me-de*ge,rt=te*de-me*he;if(s){if(be<0||Xe<0||rt<0)return null}else if((be<0||Xe<0||rt<0)&&(be>0||Xe>0||rt>0))return null;let He=be+Xe+rt;if(He===0)return null;let ht=ee*(be*G+Xe*W+rt*ae);return(He>0?ht<0:ht>0)?null:this.at(ht/He,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},ba=class extends ws{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new lt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ir,this.combine=hh,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},Vx=new wt,uo=new Ur,pu=new $n,Hx=new k,mu=new k,gu=new k,_u=new k,vp=new k,xu=new k,Gx=new k,yu=new k,qn=class extends Xn{constructor(e=new rn,t=new ba){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){xu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(vp.fromBufferAttribute(f,e),o?xu.addScaledVector(vp,u):xu.addScaledVector(vp.sub(t),u))}t.add(xu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),pu.copy(i.boundingSphere),pu.applyMatrix4(r),uo.copy(e.ray).recast(e.near),!(pu.containsPoint(uo.origin)===!1&&(uo.intersectSphere(pu,Hx)===null||uo.origin.distanceToSquared(Hx)>(e.far-e.near)**2))&&(Vx.copy(r).invert(),uo.copy(e.ray).applyMatrix4(Vx),!(i.boundingBox!==null&&uo.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,uo)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let m=h[p],_=o[m.materialIndex],v=Math.max(m.start,d.start),C=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let S=v,I=C;S<I;S+=3){let T=a.getX(S),y=a.getX(S+1),E=a.getX(S+2);s=vu(this,_,e,i,c,u,f,T,y,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(a.count,d.start+d.count);for(let m=p,_=b;m<_;m+=3){let v=a.getX(m),C=a.getX(m+1),S=a.getX(m+2);s=vu(this,o,e,i,c,u,f,v,C,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let m=h[p],_=o[m.materialIndex],v=Math.max(m.start,d.start),C=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let S=v,I=C;S<I;S+=3){let T=S,y=S+1,E=S+2;s=vu(this,_,e,i,c,u,f,T,y,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let m=p,_=b;m<_;m+=3){let v=m,C=m+1,S=m+2;s=vu(this,o,e,i,c,u,f,v,C,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function j1(n,e,t,i,s,r,o,a){let l;if(e.side===_i?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Gr,a),l===null)return null;yu.copy(a),yu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(yu);return c<t.near||c>t.far?null:{distance:c,point:yu.clone(),object:n}}function vu(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,mu),n.getVertexPosition(l,gu),n.getVertexPosition(c,_u);let u=j1(n,e,t,i,mu,gu,_u,Gx);if(u){let f=new k;Dr.getBarycoord(Gx,mu,gu,_u,f),s&&(u.uv=Dr.getInterpolatedAttribute(s,a,l,c,f,new je)),r&&(u.uv1=Dr.getInterpolatedAttribute(r,a,l,c,f,new je)),o&&(u.normal=Dr.getInterpolatedAttribute(o,a,l,c,f,new k),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new k,materialIndex:0};Dr.getNormal(mu,gu,_u,h.normal),u.face=h,u.barycoord=f}return u}var Sa=class extends bi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=_n,u=_n,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var ho=new $n,Q1=new je(.5,.5),bu=new k,Or=class{constructor(e=new pi,t=new pi,i=new pi,s=new pi,r=new pi,o=new pi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=$i,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],b=r[9],m=r[10],_=r[11],v=r[12],C=r[13],S=r[14],I=r[15];if(s[0].setComponents(c-o,d-u,_-p,I-v).normalize(),s[1].setComponents(c+o,d+u,_+p,I+v).normalize(),s[2].setComponents(c+a,d+f,_+b,I+C).normalize(),s[3].setComponents(c-a,d-f,_-b,I-C).normalize(),i)s[4].setComponents(l,h,m,S).normalize(),s[5].setComponents(c-l,d-h,_-m,I-S).normalize();else if(s[4].setComponents(c-l,d-h,_-m,I-S).normalize(),t===$i)s[5].setComponents(c+l,d+h,_+m,I+S).normalize();else if(t===ga)s[5].setComponents(l,h,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),ho.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),ho.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(ho)}intersectsSprite(e){ho.center.set(0,0,0);let t=Q1.distanceTo(e.center);return ho.radius=.7071067811865476+t,ho.applyMatrix4(e.matrixWorld),this.intersectsSphere(ho)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(bu.x=s.normal.x>0?e.max.x:e.min.x,bu.y=s.normal.y>0?e.max.y:e.min.y,bu.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(bu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Wx=new wt,$u=class n{constructor(){this.coordinateSystem=$i,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];Wx.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new Or),i[s].setFromProjectionMatrix(Wx,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new Or),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var cs=class extends ws{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new lt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},qu=new k,Yu=new k,Xx=new wt,dl=new Ur,Su=new $n,bp=new k,$x=new k,Ju=class extends Xn{constructor(e=new rn,t=new cs){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)qu.fromBufferAttribute(t,s-1),Yu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=qu.distanceTo(Yu);e.setAttribute("lineDistance",new Wn(i,1))}else Ke("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Su.copy(i.boundingSphere),Su.applyMatrix4(s),Su.radius+=r,e.ray.intersectsSphere(Su)===!1)return;Xx.copy(s).invert(),dl.copy(e.ray).applyMatrix4(Xx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let _=u.getX(b),v=u.getX(b+1),C=Mu(this,e,dl,l,_,v,b);C&&t.push(C)}if(this.isLineLoop){let b=u.getX(p-1),m=u.getX(d),_=Mu(this,e,dl,l,b,m,p-1);_&&t.push(_)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let _=Mu(this,e,dl,l,b,b+1,b);_&&t.push(_)}if(this.isLineLoop){let b=Mu(this,e,dl,l,p-1,d,p-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Mu(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(qu.fromBufferAttribute(a,s),Yu.fromBufferAttribute(a,r),t.distanceSqToSegment(qu,Yu,bp,$x)>i)return;bp.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(bp);if(!(c<e.near||c>e.far))return{distance:c,point:$x.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var qx=new k,Yx=new k,As=class extends Ju{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)qx.fromBufferAttribute(t,s),Yx.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+qx.distanceTo(Yx);e.setAttribute("lineDistance",new Wn(i,1))}else Ke("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ts=class extends ws{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new lt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},Jx=new wt,Cp=new Ur,wu=new $n,Au=new k,sr=class extends Xn{constructor(e=new rn,t=new Ts){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),wu.copy(i.boundingSphere),wu.applyMatrix4(s),wu.radius+=r,e.ray.intersectsSphere(wu)===!1)return;Jx.copy(s).invert(),Cp.copy(e.ray).applyMatrix4(Jx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,f=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let p=h,b=d;p<b;p++){let m=c.getX(p);Au.fromBufferAttribute(f,m),Kx(Au,m,l,s,e,t,this)}}else{let h=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let p=h,b=d;p<b;p++)Au.fromBufferAttribute(f,p),Kx(Au,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Kx(n,e,t,i,s,r,o){let a=Cp.distanceSqToPoint(n);if(a<t){let l=new k;Cp.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var Tl=class extends bi{constructor(e=[],t=mo,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var rr=class extends bi{constructor(e,t,i=us,s,r,o,a=_n,l=_n,c,u=nr,f=1){if(u!==nr&&u!==ar)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new ya(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},El=class extends rr{constructor(e,t=us,i=mo,s,r,o=_n,a=_n,l,c=nr){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},Cl=class extends bi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Ma=class n extends rn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Wn(c,3)),this.setAttribute("normal",new Wn(u,3)),this.setAttribute("uv",new Wn(f,2));function p(b,m,_,v,C,S,I,T,y,E,V){let U=S/y,L=I/E,G=S/2,z=I/2,N=T/2,W=y+1,Y=E+1,H=0,ae=0,K=new k;for(let $=0;$<Y;$++){let ee=$*L-z;for(let he=0;he<W;he++){let de=he*U-G;K[b]=de*v,K[m]=ee*C,K[_]=N,c.push(K.x,K.y,K.z),K[b]=0,K[m]=0,K[_]=T>0?1:-1,u.push(K.x,K.y,K.z),f.push(he/y),f.push(1-$/E),H+=1}}for(let $=0;$<E;$++)for(let ee=0;ee<y;ee++){let he=h+ee+W*$,de=h+ee+W*($+1),te=h+(ee+1)+W*($+1),me=h+(ee+1)+W*$;l.push(he,de,me),l.push(de,te,me),ae+=6}a.addGroup(d,ae,V),d+=ae,h+=H}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var Rl=class n extends rn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],b=[],m=[];for(let _=0;_<u;_++){let v=_*h-o;for(let C=0;C<c;C++){let S=C*f-r;p.push(S,-v,0),b.push(0,0,1),m.push(C/a),m.push(1-_/l)}}for(let _=0;_<l;_++)for(let v=0;v<a;v++){let C=v+c*_,S=v+c*(_+1),I=v+1+c*(_+1),T=v+1+c*_;d.push(C,S,T),d.push(S,I,T)}this.setIndex(d),this.setAttribute("position",new Wn(p,3)),this.setAttribute("normal",new Wn(b,3)),this.setAttribute("uv",new Wn(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var Pl=class extends rn{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new k,r=new k;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let f=l[c],h=f.start,d=f.count;for(let p=h,b=h+d;p<b;p+=3)for(let m=0;m<3;m++){let _=a.getX(p+m),v=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,_),r.fromBufferAttribute(o,v),Zx(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,f=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,f),Zx(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Wn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function Zx(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function _o(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(jx(s))s.isRenderTargetTexture?(Ke("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(jx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function ri(n){let e={};for(let t=0;t<n.length;t++){let i=_o(n[t]);for(let s in i)e[s]=i[s]}return e}function jx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function eA(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function lm(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var Kl={clone:_o,merge:ri},tA=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,nA=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,qi=class extends ws{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=tA,this.fragmentShader=nA,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=_o(e.uniforms),this.uniformsGroups=eA(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new lt().setHex(s.value);break;case"v2":this.uniforms[i].value=new je().fromArray(s.value);break;case"v3":this.uniforms[i].value=new k().fromArray(s.value);break;case"v4":this.uniforms[i].value=new kt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ot().fromArray(s.value);break;case"m4":this.uniforms[i].value=new wt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ku=class extends qi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Il=class extends ws{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new lt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new lt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Zh,this.normalScale=new je(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ir,this.combine=hh,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Zu=class extends ws{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Py,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},ju=class extends ws{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function ua(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Tu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Fr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Qu=class extends Fr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ap,endingEnd:Ap}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Tp:r=e,a=2*t-i;break;case Ep:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Tp:o=e,l=2*i-t;break;case Ep:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),b=p*p,m=b*p,_=-h*m+2*h*b-h*p,v=(1+h)*m+(-1.5-2*h)*b+(-.5+h)*p+1,C=(-1-d)*m+(1.5+d)*b+.5*p,S=d*m-d*b;for(let I=0;I!==a;++I)r[I]=_*o[u+I]+v*o[c+I]+C*o[l+I]+S*o[f+I];return r}},eh=class extends Fr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},th=class extends Fr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},nh=class extends Fr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),b=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*b+o[l+m]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let b=o[c+p],m=o[l+p],_=d*h+p*2,v=f[_],C=f[_+1],S=e*h+p*2,I=u[S],T=u[S+1],y=sA(i,t,v,I,s);r[p]=Gy(y,b,C,T,m)}return r}};function Gy(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function iA(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function sA(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=Gy(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=iA(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Fi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=ua(t,this.TimeBufferType),this.values=ua(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:ua(e.times,Array),values:ua(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Tu(e.settings)&&(i.settings={inTangents:ua(e.settings.inTangents,Array),outTangents:ua(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new th(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new eh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Qu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new nh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case gl:t=this.InterpolantFactoryMethodDiscrete;break;case Vu:t=this.InterpolantFactoryMethodLinear;break;case Pu:t=this.InterpolantFactoryMethodSmooth;break;case wp:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ke("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return gl;case this.InterpolantFactoryMethodLinear:return Vu;case this.InterpolantFactoryMethodSmooth:return Pu;case this.InterpolantFactoryMethodBezier:return wp}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Tu(this.settings)&&(Qx(this.settings.inTangents,e),Qx(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Tu(this.settings)&&(ey(this.settings.inTangents,e),ey(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(st("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(st("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){st("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){st("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&v1(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){st("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===Pu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let b=t[f+p];if(b!==t[h+p]||b!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Tu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function Qx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function ey(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Fi.prototype.ValueTypeName="";Fi.prototype.TimeBufferType=Float32Array;Fi.prototype.ValueBufferType=Float32Array;Fi.prototype.DefaultInterpolation=Vu;var kr=class extends Fi{constructor(e,t,i){super(e,t,i)}};kr.prototype.ValueTypeName="bool";kr.prototype.ValueBufferType=Array;kr.prototype.DefaultInterpolation=gl;kr.prototype.InterpolantFactoryMethodLinear=void 0;kr.prototype.InterpolantFactoryMethodSmooth=void 0;var ih=class extends Fi{constructor(e,t,i,s){super(e,t,i,s)}};ih.prototype.ValueTypeName="color";var sh=class extends Fi{constructor(e,t,i,s){super(e,t,i,s)}};sh.prototype.ValueTypeName="number";var rh=class extends Fr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ui.slerpFlat(r,0,o,c-a,o,c,l);return r}},Ll=class extends Fi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new rh(this.times,this.values,this.getValueSize(),e)}};Ll.prototype.ValueTypeName="quaternion";Ll.prototype.InterpolantFactoryMethodSmooth=void 0;var Br=class extends Fi{constructor(e,t,i){super(e,t,i)}};Br.prototype.ValueTypeName="string";Br.prototype.ValueBufferType=Array;Br.prototype.DefaultInterpolation=gl;Br.prototype.InterpolantFactoryMethodLinear=void 0;Br.prototype.InterpolantFactoryMethodSmooth=void 0;var oh=class extends Fi{constructor(e,t,i,s){super(e,t,i,s)}};oh.prototype.ValueTypeName="vector";var ah=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Wy=new ah,lh=class{constructor(e){this.manager=e!==void 0?e:Wy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};lh.DEFAULT_MATERIAL_NAME="__DEFAULT";var Dl=class extends Xn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new lt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},Nl=class extends Dl{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Xn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new lt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Sp=new wt,ty=new k,ny=new k,ch=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new je(512,512),this.mapType=Mi,this.map=null,this.mapPass=null,this.matrix=new wt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Or,this._frameExtents=new je(1,1),this._viewportCount=1,this._viewports=[new kt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;ty.setFromMatrixPosition(e.matrixWorld),t.position.copy(ty),ny.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(ny),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Sp.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Sp,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===ga||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Sp)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Eu=new k,Cu=new Ui,Ss=new k,Ul=class extends Xn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new wt,this.projectionMatrix=new wt,this.projectionMatrixInverse=new wt,this.coordinateSystem=$i,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Eu,Cu,Ss),Ss.x===1&&Ss.y===1&&Ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Eu,Cu,Ss.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Eu,Cu,Ss),Ss.x===1&&Ss.y===1&&Ss.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Eu,Cu,Ss.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Lr=new k,iy=new je,sy=new je,mi=class extends Ul{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=xa*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(pl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return xa*2*Math.atan(Math.tan(pl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Lr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Lr.x,Lr.y).multiplyScalar(-e/Lr.z),Lr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Lr.x,Lr.y).multiplyScalar(-e/Lr.z)}getViewSize(e,t){return this.getViewBounds(e,iy,sy),t.subVectors(sy,iy)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(pl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var Ol=class extends Ul{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Rp=class extends ch{constructor(){super(new Ol(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},Fl=class extends Dl{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Xn.DEFAULT_UP),this.updateMatrix(),this.target=new Xn,this.shadow=new Rp}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var kl=class extends rn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var ha=-90,da=1,wa=class extends Xn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new mi(ha,da,e,t);s.layers=this.layers,this.add(s);let r=new mi(ha,da,e,t);r.layers=this.layers,this.add(r);let o=new mi(ha,da,e,t);o.layers=this.layers,this.add(o);let a=new mi(ha,da,e,t);a.layers=this.layers,this.add(a);let l=new mi(ha,da,e,t);l.layers=this.layers,this.add(l);let c=new mi(ha,da,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===$i)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ga)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},uh=class extends mi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var cm="\\[\\]\\.:\\/",rA=new RegExp("["+cm+"]","g"),um="[^"+cm+"]",oA="[^"+cm.replace("\\.","")+"]",aA=/((?:WC+[\/:])*)/.source.replace("WC",um),lA=/(WCOD+)?/.source.replace("WCOD",oA),cA=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",um),uA=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",um),hA=new RegExp("^"+aA+lA+cA+uA+"$"),dA=["material","materials","bones","map"],Pp=class{constructor(e,t,i){let s=i||tn.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},tn=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(rA,"")}static parseTrackName(e){let t=hA.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);dA.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ke("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){st("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){st("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){st("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){st("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){st("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;st("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};tn.Composite=Pp;tn.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};tn.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};tn.prototype.GetterByBindingType=[tn.prototype._getValue_direct,tn.prototype._getValue_array,tn.prototype._getValue_arrayElement,tn.prototype._getValue_toArray];tn.prototype.SetterByBindingTypeAndVersioning=[[tn.prototype._setValue_direct,tn.prototype._setValue_direct_setNeedsUpdate,tn.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_array,tn.prototype._setValue_array_setNeedsUpdate,tn.prototype._setValue_array_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_arrayElement,tn.prototype._setValue_arrayElement_setNeedsUpdate,tn.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[tn.prototype._setValue_fromArray,tn.prototype._setValue_fromArray_setNeedsUpdate,tn.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var rD=new Float32Array(1);var zr=class extends Xu{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var Aa=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ut(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ut(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Ip=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var ry=new k,Ru=new k,fa=new k,pa=new k,Mp=new k,fA=new k,pA=new k,Bl=class{constructor(e=new k,t=new k){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){ry.subVectors(e,this.start),Ru.subVectors(this.end,this.start);let i=Ru.dot(Ru);if(i===0)return 0;let r=Ru.dot(ry)/i;return t&&(r=ut(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=fA,i=pA){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;fa.subVectors(c,a),pa.subVectors(u,l),Mp.subVectors(a,l);let f=fa.dot(fa),h=pa.dot(pa),d=pa.dot(Mp);if(f<=s&&h<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(f<=s)r=0,o=d/h,o=ut(o,0,1);else{let p=fa.dot(Mp);if(h<=s)o=0,r=ut(-p/f,0,1);else{let b=fa.dot(pa),m=f*h-b*b;m!==0?r=ut((b*d-p*h)/m,0,1):r=0,o=(b*r+d)/h,o<0?(o=0,r=ut(-p/f,0,1)):o>1&&(o=1,r=ut((b-p)/f,0,1))}}return t.copy(a).addScaledVector(fa,r),i.copy(l).addScaledVector(pa,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var zl=class extends as{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function hm(n,e,t,i){let s=mA(i);switch(t){case Kp:return n*e;case jp:return n*e/s.components*s.byteLength;case xh:return n*e/s.components*s.byteLength;case Wr:return n*e*2/s.components*s.byteLength;case yh:return n*e*2/s.components*s.byteLength;case Zp:return n*e*3/s.components*s.byteLength;case ki:return n*e*4/s.components*s.byteLength;case vh:return n*e*4/s.components*s.byteLength;case Gl:case Wl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Xl:case $l:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Sh:case wh:return Math.max(n,16)*Math.max(e,8)/4;case bh:case Mh:return Math.max(n,8)*Math.max(e,8)/2;case Ah:case Th:case Ch:case Rh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Eh:case ql:case Ph:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Lh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case Dh:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case Nh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case Uh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case Oh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case Fh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case kh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case Bh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case zh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Vh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Hh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case Gh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Wh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Xh:case $h:case qh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Yh:case Jh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Yl:case Kh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function mA(n){switch(n){case Mi:case $p:return{byteLength:1,components:1};case Ra:case qp:case ds:return{byteLength:2,components:1};case gh:case _h:return{byteLength:2,components:4};case us:case mh:case hs:return{byteLength:4,components:1};case Yp:case Jp:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ke("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function dv(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function _A(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],b=f[d];b.start<=p.start+p.count+1?p.count=Math.max(p.count,b.start+b.count-p.start):(++h,f[h]=b)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let b=f[d];n.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var xA=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,yA=`#ifdef USE_ALPHAHASH
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
#endif`,vA=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,bA=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,SA=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,MA=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,wA=`#ifdef USE_AOMAP
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
#endif`,AA=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,TA=`#ifdef USE_BATCHING
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
#endif`,EA=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,CA=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,RA=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,PA=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,IA=`#ifdef USE_IRIDESCENCE
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
#endif`,LA=`#ifdef USE_BUMPMAP
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
#endif`,DA=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,NA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,UA=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,OA=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,FA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,kA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,BA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,zA=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,VA=`#define PI 3.141592653589793
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
} // validated`,HA=`vec3 transformedNormal = objectNormal;
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
#endif`,GA=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,WA=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,XA=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,$A=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,qA="gl_FragColor = linearToOutputTexel( gl_FragColor );",YA=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,JA=`#ifdef USE_ENVMAP
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
#endif`,KA=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,ZA=`#ifdef USE_ENVMAP
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
#endif`,jA=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,QA=`#ifdef USE_ENVMAP
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
#endif`,eT=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,tT=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,nT=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,iT=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,sT=`#ifdef USE_GRADIENTMAP
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
}`,rT=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,oT=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,aT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,lT=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,cT=`#ifdef USE_ENVMAP
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
#endif`,uT=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,hT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,dT=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,fT=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,pT=`PhysicalMaterial material;
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
#endif`,mT=`uniform sampler2D dfgLUT;
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
}`,gT=`
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
#endif`,_T=`#if defined( RE_IndirectDiffuse )
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
#endif`,xT=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,yT=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,vT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,bT=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,ST=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,MT=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,wT=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,AT=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,TT=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,ET=`#if defined( USE_POINTS_UV )
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
#endif`,CT=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,RT=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,PT=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,IT=`#if defined( USE_MORPHCOLORS )
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
#endif`,LT=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,DT=`#ifdef USE_MORPHTARGETS
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
#endif`,NT=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,UT=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,OT=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,FT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,kT=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,BT=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,zT=`#ifdef USE_NORMALMAP
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
#endif`,VT=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,HT=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,GT=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,WT=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,XT=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,$T=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,qT=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,YT=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,JT=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,KT=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,ZT=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,jT=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,QT=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,eE=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,tE=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,nE=`float getShadowMask() {
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
}`,iE=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,sE=`#ifdef USE_SKINNING
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
#endif`,rE=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,oE=`#ifdef USE_SKINNING
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
#endif`,aE=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,lE=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,cE=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,uE=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,hE=`#ifdef USE_TRANSMISSION
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
#endif`,dE=`#ifdef USE_TRANSMISSION
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
#endif`,fE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,pE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,mE=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,gE=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,_E=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,xE=`uniform sampler2D t2D;
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
}`,yE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,vE=`uniform float backgroundBlurriness;
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
}`,bE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,SE=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ME=`#include <common>
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
}`,wE=`#if DEPTH_PACKING == 3200
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
}`,AE=`#define DISTANCE
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
}`,TE=`#define DISTANCE
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
}`,EE=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,CE=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,RE=`uniform float scale;
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
}`,PE=`uniform vec3 diffuse;
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
}`,IE=`#include <common>
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
}`,LE=`uniform vec3 diffuse;
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
}`,DE=`#define LAMBERT
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
}`,NE=`#define LAMBERT
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
}`,UE=`#define MATCAP
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
}`,OE=`#define MATCAP
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
}`,FE=`#define NORMAL
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
}`,kE=`#define NORMAL
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
}`,BE=`#define PHONG
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
}`,zE=`#define PHONG
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
}`,VE=`#define STANDARD
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
}`,HE=`#define STANDARD
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
}`,GE=`#define TOON
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
}`,WE=`#define TOON
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
}`,XE=`uniform float size;
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
}`,$E=`uniform vec3 diffuse;
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
}`,qE=`#include <common>
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
}`,YE=`uniform vec3 color;
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
}`,JE=`uniform float rotation;
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
}`,KE=`uniform vec3 diffuse;
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
}`,pt={alphahash_fragment:xA,alphahash_pars_fragment:yA,alphamap_fragment:vA,alphamap_pars_fragment:bA,alphatest_fragment:SA,alphatest_pars_fragment:MA,aomap_fragment:wA,aomap_pars_fragment:AA,batching_pars_vertex:TA,batching_vertex:EA,begin_vertex:CA,beginnormal_vertex:RA,bsdfs:PA,iridescence_fragment:IA,bumpmap_pars_fragment:LA,clipping_planes_fragment:DA,clipping_planes_pars_fragment:NA,clipping_planes_pars_vertex:UA,clipping_planes_vertex:OA,color_fragment:FA,color_pars_fragment:kA,color_pars_vertex:BA,color_vertex:zA,common:VA,defaultnormal_vertex:HA,displacementmap_pars_vertex:GA,displacementmap_vertex:WA,emissivemap_fragment:XA,emissivemap_pars_fragment:$A,colorspace_fragment:qA,colorspace_pars_fragment:YA,envmap_fragment:JA,envmap_common_pars_fragment:KA,envmap_pars_fragment:ZA,envmap_pars_vertex:jA,envmap_physical_pars_fragment:cT,envmap_vertex:QA,fog_vertex:eT,fog_pars_vertex:tT,fog_fragment:nT,fog_pars_fragment:iT,gradientmap_pars_fragment:sT,lightmap_pars_fragment:rT,lights_lambert_fragment:oT,lights_lambert_pars_fragment:aT,lights_pars_begin:lT,lights_toon_fragment:uT,lights_toon_pars_fragment:hT,lights_phong_fragment:dT,lights_phong_pars_fragment:fT,lights_physical_fragment:pT,lights_physical_pars_fragment:mT,lights_fragment_begin:gT,lights_fragment_maps:_T,lights_fragment_end:xT,lightprobes_pars_fragment:yT,logdepthbuf_fragment:vT,logdepthbuf_pars_fragment:bT,logdepthbuf_pars_vertex:ST,logdepthbuf_vertex:MT,map_fragment:wT,map_pars_fragment:AT,map_particle_fragment:TT,map_particle_pars_fragment:ET,metalnessmap_fragment:CT,metalnessmap_pars_fragment:RT,morphinstance_vertex:PT,morphcolor_vertex:IT,morphnormal_vertex:LT,morphtarget_pars_vertex:DT,morphtarget_vertex:NT,normal_fragment_begin:UT,normal_fragment_maps:OT,normal_pars_fragment:FT,normal_pars_vertex:kT,normal_vertex:BT,normalmap_pars_fragment:zT,clearcoat_normal_fragment_begin:VT,clearcoat_normal_fragment_maps:HT,clearcoat_pars_fragment:GT,iridescence_pars_fragment:WT,opaque_fragment:XT,packing:$T,premultiplied_alpha_fragment:qT,project_vertex:YT,dithering_fragment:JT,dithering_pars_fragment:KT,roughnessmap_fragment:ZT,roughnessmap_pars_fragment:jT,shadowmap_pars_fragment:QT,shadowmap_pars_vertex:eE,shadowmap_vertex:tE,shadowmask_pars_fragment:nE,skinbase_vertex:iE,skinning_pars_vertex:sE,skinning_vertex:rE,skinnormal_vertex:oE,specularmap_fragment:aE,specularmap_pars_fragment:lE,tonemapping_fragment:cE,tonemapping_pars_fragment:uE,transmission_fragment:hE,transmission_pars_fragment:dE,uv_pars_fragment:fE,uv_pars_vertex:pE,uv_vertex:mE,worldpos_vertex:gE,background_vert:_E,background_frag:xE,backgroundCube_vert:yE,backgroundCube_frag:vE,cube_vert:bE,cube_frag:SE,depth_vert:ME,depth_frag:wE,distance_vert:AE,distance_frag:TE,equirect_vert:EE,equirect_frag:CE,linedashed_vert:RE,linedashed_frag:PE,meshbasic_vert:IE,meshbasic_frag:LE,meshlambert_vert:DE,meshlambert_frag:NE,meshmatcap_vert:UE,meshmatcap_frag:OE,meshnormal_vert:FE,meshnormal_frag:kE,meshphong_vert:BE,meshphong_frag:zE,meshphysical_vert:VE,meshphysical_frag:HE,meshtoon_vert:GE,meshtoon_frag:WE,points_vert:XE,points_frag:$E,shadow_vert:qE,shadow_frag:YE,sprite_vert:JE,sprite_frag:KE},Ie={common:{diffuse:{value:new lt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new lt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new lt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new lt(16777215)},opacity:{value:1},center:{value:new je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},xi={basic:{uniforms:ri([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:ri([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new lt(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:ri([Ie.common,Ie.specularmap,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,Ie.lights,{emissive:{value:new lt(0)},specular:{value:new lt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:ri([Ie.common,Ie.envmap,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.roughnessmap,Ie.metalnessmap,Ie.fog,Ie.lights,{emissive:{value:new lt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:ri([Ie.common,Ie.aomap,Ie.lightmap,Ie.emissivemap,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.gradientmap,Ie.fog,Ie.lights,{emissive:{value:new lt(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:ri([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,Ie.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:ri([Ie.points,Ie.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:ri([Ie.common,Ie.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:ri([Ie.common,Ie.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:ri([Ie.common,Ie.bumpmap,Ie.normalmap,Ie.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:ri([Ie.sprite,Ie.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:ri([Ie.common,Ie.displacementmap,{referencePosition:{value:new k},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:ri([Ie.lights,Ie.fog,{color:{value:new lt(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};xi.physical={uniforms:ri([xi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ot},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new lt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new lt(0)},specularColor:{value:new lt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var Qh={r:0,b:0,g:0},ZE=new wt,fv=new ot;fv.set(-1,0,0,0,1,0,0,0,1);function jE(n,e,t,i,s,r){let o=new lt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(v){let C=v.isScene===!0?v.background:null;if(C&&C.isTexture){let S=v.backgroundBlurriness>0;C=e.get(C,S)}return C}function p(v){let C=!1,S=d(v);S===null?m(o,a):S&&S.isColor&&(m(S,1),C=!0);let I=n.xr.getEnvironmentBlendMode();I==="additive"?t.buffers.color.setClear(0,0,0,1,r):I==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(v,C){let S=d(C);S&&S.isCubeTexture?(c===void 0&&(c=new qn(new Ma(1,1,1),new qi({name:"BackgroundCubeMaterial",uniforms:_o(xi.backgroundCube.uniforms),vertexShader:xi.backgroundCube.vertexShader,fragmentShader:xi.backgroundCube.fragmentShader,side:_i,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(I,T,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(ZE.makeRotationFromEuler(C.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(fv),c.material.toneMapped=vt.getTransfer(S.colorSpace)!==Ft,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new qn(new Rl(2,2),new qi({name:"BackgroundMaterial",uniforms:_o(xi.background.uniforms),vertexShader:xi.background.vertexShader,fragmentShader:xi.background.fragmentShader,side:Gr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=vt.getTransfer(S.colorSpace)!==Ft,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,C){v.getRGB(Qh,lm(n)),t.buffers.color.setClear(Qh.r,Qh.g,Qh.b,C,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,C=1){o.set(v),a=C,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:b,dispose:_}}function QE(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,G,z,N,W){let Y=!1,H=f(L,N,z,G);r!==H&&(r=H,c(r.object)),Y=d(L,N,z,W),Y&&p(L,N,z,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(Y||o)&&(o=!1,S(L,G,z,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,G,z,N){let W=N.wireframe===!0,Y=i[G.id];Y===void 0&&(Y={},i[G.id]=Y);let H=L.isInstancedMesh===!0?L.id:0,ae=Y[H];ae===void 0&&(ae={},Y[H]=ae);let K=ae[z.id];K===void 0&&(K={},ae[z.id]=K);let $=K[W];return $===void 0&&($=h(l()),K[W]=$),$}function h(L){let G=[],z=[],N=[];for(let W=0;W<t;W++)G[W]=0,z[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:z,attributeDivisors:N,object:L,attributes:{},index:null}}function d(L,G,z,N){let W=r.attributes,Y=G.attributes,H=0,ae=z.getAttributes();for(let K in ae)if(ae[K].location>=0){let ee=W[K],he=Y[K];if(he===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(he=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(he=L.instanceColor)),ee===void 0||ee.attribute!==he||he&&ee.data!==he.data)return!0;H++}return r.attributesNum!==H||r.index!==N}function p(L,G,z,N){let W={},Y=G.attributes,H=0,ae=z.getAttributes();for(let K in ae)if(ae[K].location>=0){let ee=Y[K];ee===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor));let he={};he.attribute=ee,ee&&ee.data&&(he.data=ee.data),W[K]=he,H++}r.attributes=W,r.attributesNum=H,r.index=N}function b(){let L=r.newAttributes;for(let G=0,z=L.length;G<z;G++)L[G]=0}function m(L){_(L,0)}function _(L,G){let z=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;z[L]=1,N[L]===0&&(n.enableVertexAttribArray(L),N[L]=1),W[L]!==G&&(n.vertexAttribDivisor(L,G),W[L]=G)}function v(){let L=r.newAttributes,G=r.enabledAttributes;for(let z=0,N=G.length;z<N;z++)G[z]!==L[z]&&(n.disableVertexAttribArray(z),G[z]=0)}function C(L,G,z,N,W,Y,H){H===!0?n.vertexAttribIPointer(L,G,z,W,Y):n.vertexAttribPointer(L,G,z,N,W,Y)}function S(L,G,z,N){b();let W=N.attributes,Y=z.getAttributes(),H=G.defaultAttributeValues;for(let ae in Y){let K=Y[ae];if(K.location>=0){let $=W[ae];if($===void 0&&(ae==="instanceMatrix"&&L.instanceMatrix&&($=L.instanceMatrix),ae==="instanceColor"&&L.instanceColor&&($=L.instanceColor)),$!==void 0){let ee=$.normalized,he=$.itemSize,de=e.get($);if(de===void 0)continue;let te=de.buffer,me=de.type,ge=de.bytesPerElement,Me=me===n.INT||me===n.UNSIGNED_INT||$.gpuType===mh;if($.isInterleavedBufferAttribute){let be=$.data,Xe=be.isInterleavedBuffer===!0?be.stride:be.itemSize,rt=$.offset;if(be.isInstancedInterleavedBuffer||be.isInstancedBufferAttribute){for(let He=0;He<K.locationSize;He++)_(K.location+He,be.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=be.meshPerAttribute*be.count)}else for(let He=0;He<K.locationSize;He++)m(K.location+He);n.bindBuffer(n.ARRAY_BUFFER,te);for(let He=0;He<K.locationSize;He++)C(K.location+He,he/K.locationSize,me,ee,Xe*ge,(rt+he/K.locationSize*He)*ge,Me)}else{if($.isInstancedBufferAttribute){for(let be=0;be<K.locationSize;be++)_(K.location+be,$.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=$.meshPerAttribute*$.count)}else for(let be=0;be<K.locationSize;be++)m(K.location+be);n.bindBuffer(n.ARRAY_BUFFER,te);for(let be=0;be<K.locationSize;be++)C(K.location+be,he/K.locationSize,me,ee,he*ge,he/K.locationSize*be*ge,Me)}}else if(H!==void 0){let ee=H[ae];if(ee!==void 0)switch(ee.length){case 2:n.vertexAttrib2fv(K.location,ee);break;case 3:n.vertexAttrib3fv(K.location,ee);break;case 4:n.vertexAttrib4fv(K.location,ee);break;default:n.vertexAttrib1fv(K.location,ee)}}}}v()}function I(){V();for(let L in i){let G=i[L];for(let z in G){let N=G[z];for(let W in N){let Y=N[W];for(let H in Y)u(Y[H].object),delete Y[H];delete N[W]}}delete i[L]}}function T(L){if(i[L.id]===void 0)return;let G=i[L.id];for(let z in G){let N=G[z];for(let W in N){let Y=N[W];for(let H in Y)u(Y[H].object),delete Y[H];delete N[W]}}delete i[L.id]}function y(L){for(let G in i){let z=i[G];for(let N in z){let W=z[N];if(W[L.id]===void 0)continue;let Y=W[L.id];for(let H in Y)u(Y[H].object),delete Y[H];delete W[L.id]}}}function E(L){for(let G in i){let z=i[G],N=L.isInstancedMesh===!0?L.id:0,W=z[N];if(W!==void 0){for(let Y in W){let H=W[Y];for(let ae in H)u(H[ae].object),delete H[ae];delete W[Y]}delete z[N],Object.keys(z).length===0&&delete i[G]}}}function V(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:V,resetDefaultState:U,dispose:I,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:y,initAttributes:b,enableAttribute:m,disableUnusedAttributes:v}}function eC(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function tC(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==ki&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let E=y===ds&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==Mi&&y!==hs&&!E&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ke("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Ke("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Ke("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),_=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:b,maxCubemapSize:m,maxAttributes:_,maxVertexUniforms:v,maxVaryings:C,maxFragmentUniforms:S,maxSamples:I,samples:T}}function nC(n){let e=this,t=null,i=0,s=!1,r=!1,o=new pi,a=new ot,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,b=f.clipIntersection,m=f.clipShadows,_=n.get(f);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let v=r?0:i,C=v*4,S=_.clippingState||null;l.value=S,S=u(p,h,C,d);for(let I=0;I!==C;++I)S[I]=t[I];_.clippingState=S,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let b=f!==null?f.length:0,m=null;if(b!==0){if(m=l.value,p!==!0||m===null){let _=d+b*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<_)&&(m=new Float32Array(_));for(let C=0,S=d;C!==b;++C,S+=4)o.copy(f[C]).applyMatrix4(v,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var Ql=class extends Oi{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new Tl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Ma(5,5,5),r=new qi({name:"CubemapFromEquirect",uniforms:_o(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:_i,blending:fo});r.uniforms.tEquirect.value=t;let o=new qn(s,r),a=t.minFilter;return t.minFilter===or&&(t.minFilter=gi),new wa(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Xy=256,iC=3,sC=20,pv=256,mv=16,rC=3,oC=new k,aC=new lt,td=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new wa(1,10,null),this._boxMesh=new qn(new Ma(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=oC}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(aC));let m=new wa(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Yy(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=qy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Xy,rm(e))}_fromTexture(e,t){e.mapping===mo||e.mapping===Ca?this._setSize(e.image.length===0?Xy:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=$y(e,!1,!1),i=Math.log2(e)-iC;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=$y(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===mo||e.mapping===Ca?(this._cubemapMaterial===null&&(this._cubemapMaterial=Yy()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=qy()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=lC(),this._integrationMaterial=cC());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/mv);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-rC)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(pv*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=uC());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function $y(n,e,t){return new Ql(n,{minFilter:or,generateMipmaps:e,type:ds,colorSpace:_l,depthBuffer:t})}function ec(n,e,t){return new qi({name:n,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:_i,blending:fo,depthTest:!1,depthWrite:!1})}function lC(){return ec("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${pv}u

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
	`)}function cC(){return ec("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:mv}},`

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
	`)}function uC(){return ec("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${sC}
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
	`)}function qy(){return ec("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Yy(){return ec("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function hC(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===dh||d===fh)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let b=new Ql(p.height);return b.fromEquirectangularTexture(n,h),e.set(h,b),h.addEventListener("dispose",c),a(b.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===dh||d===fh,b=d===mo||d===Ca;if(p||b){let m=t.get(h),_=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==_)return i===null&&(i=new td(n)),m=p?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;{let v=h.image;return p&&v&&v.height>0||b&&v&&l(v)?(i===null&&(i=new td(n)),m=p?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,d){return d===dh?h.mapping=mo:d===fh&&(h.mapping=Ca),h}function l(h){let d=0,p=6;for(let b=0;b<p;b++)h[b]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function dC(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&fl("WebGLRenderer: "+i+" extension not supported."),s}}}function fC(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let b=r.get(p);b&&(e.remove(b),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function u(p){let b=p.attributes;for(let m in b)e.update(b[m],n.ARRAY_BUFFER)}function f(p){let b=p.index,m=p.attributes.position,_=0;if(m===void 0)return;let v=b!==null?b.array.length:m.array.length/3-1,C=m.count>=65535?Al:wl,S=new C(Math.ceil(v/3)*6,1),I=S.array;if(b!==null){let y=b.array;_=b.version;for(let E=0,V=0;E<v;E+=3){let U=y[E+0],L=y[E+1],G=y[E+2];I[V++]=U,I[V++]=L,I[V++]=L,I[V++]=G,I[V++]=G,I[V++]=U}}else{_=m.version;for(let y=0,E=0;y<v;y+=3){let V=y+0,U=y+1,L=y+2;I[E++]=V,I[E++]=U,I[E++]=U,I[E++]=L,I[E++]=L,I[E++]=V}}S.version=_;let T=r.get(p);T&&e.remove(T),r.set(p,S)}function h(p){let b=r.get(p);if(b){let m=p.index;m!==null&&b.version<m.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let b=s[p].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function pC(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let b=0;for(let m=0;m<d;m++)b+=h[m];t.update(b,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function mC(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:st("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function gC(n,e,t){let i=new WeakMap,s=new kt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let V=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",V)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],C=0;d===!0&&(C=1),p===!0&&(C=2),b===!0&&(C=3);let S=a.attributes.position.count*C,I=1;S>e.maxTextureSize&&(I=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let T=new Float32Array(S*I*4*f),y=new bl(T,S,I,f);y.type=hs,y.needsUpdate=!0;let E=C*4;for(let U=0;U<f;U++){let L=m[U],G=_[U],z=v[U],N=S*I*4*U;for(let W=0;W<L.count;W++){let Y=W*E;d===!0&&(s.fromBufferAttribute(L,W),T[N+Y+0]=s.x,T[N+Y+1]=s.y,T[N+Y+2]=s.z,T[N+Y+3]=0),p===!0&&(s.fromBufferAttribute(G,W),T[N+Y+4]=s.x,T[N+Y+5]=s.y,T[N+Y+6]=s.z,T[N+Y+7]=0),b===!0&&(s.fromBufferAttribute(z,W),T[N+Y+8]=s.x,T[N+Y+9]=s.y,T[N+Y+10]=s.z,T[N+Y+11]=z.itemSize===4?s.w:1)}}h={count:f,texture:y,size:new je(S,I)},i.set(a,h),a.addEventListener("dispose",V)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function _C(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var xC={[kp]:"LINEAR_TONE_MAPPING",[Bp]:"REINHARD_TONE_MAPPING",[zp]:"CINEON_TONE_MAPPING",[Vp]:"ACES_FILMIC_TONE_MAPPING",[Gp]:"AGX_TONE_MAPPING",[Wp]:"NEUTRAL_TONE_MAPPING",[Hp]:"CUSTOM_TONE_MAPPING"};function yC(n,e,t,i,s,r){let o=new Oi(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new rn;u.setAttribute("position",new Wn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Wn([0,2,0,0,2,0],2));let f=new Ku({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new qn(u,f),d=new Ol(-1,1,1,-1,0,1),p=null,b=null,m=!1,_,v=null,C=[],S=!1;this.setSize=function(I,T){o.setSize(I,T),a!==null&&a.setSize(I,T),l!==null&&l.setSize(I,T);for(let y=0;y<C.length;y++){let E=C[y];E.setSize&&E.setSize(I,T)}},this.setEffects=function(I){C=I,S=C.length>0&&C[0].isRenderPass===!0;let T=o.width,y=o.height;C.length>0&&a===null&&(a=new Oi(T,y,{type:ds,depthBuffer:!1,stencilBuffer:!1}),l=new Oi(T,y,{type:ds,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&C.some(V=>V.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new rr(T,y),r===!0&&(c.format=ar,c.type=go)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let V=0;V<C.length;V++){let U=C[V];U.setSize&&U.setSize(T,y),E&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(I,T){if(m||I.toneMapping===Es&&C.length===0)return!1;if(v=T,T!==null){let y=T.width,E=T.height;(o.width!==y||o.height!==E)&&this.setSize(y,E)}return S===!1&&I.setRenderTarget(o),_=I.toneMapping,I.toneMapping=Es,!0},this.hasRenderPass=function(){return S},this.end=function(I,T){I.toneMapping=_,m=!0;let y=o,E=a;for(let V=0;V<C.length;V++){let U=C[V];U.enabled!==!1&&(U.render(I,E,y,T),U.needsSwap!==!1&&(y=E,E=E===a?l:a))}if(p!==I.outputColorSpace||b!==I.toneMapping){p=I.outputColorSpace,b=I.toneMapping,f.defines={},vt.getTransfer(p)===Ft&&(f.defines.SRGB_TRANSFER="");let V=xC[b];V&&(f.defines[V]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=y.texture,I.setRenderTarget(v),I.render(h,d),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var gv=new bi,_v=new rr(1,1),xv=new El(1),yv=new bl,vv=new Wu,bv=new Tl,Jy=[],Ky=[],Zy=new Float32Array(16),jy=new Float32Array(9),Qy=new Float32Array(4);function Ia(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Jy[s];if(r===void 0&&(r=new Float32Array(s),Jy[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Nn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Un(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function id(n,e){let t=Ky[e];t===void 0&&(t=new Int32Array(e),Ky[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function vC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function bC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nn(t,e))return;n.uniform2fv(this.addr,e),Un(t,e)}}function SC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Nn(t,e))return;n.uniform3fv(this.addr,e),Un(t,e)}}function MC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nn(t,e))return;n.uniform4fv(this.addr,e),Un(t,e)}}function wC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Un(t,e)}else{if(Nn(t,i))return;Qy.set(i),n.uniformMatrix2fv(this.addr,!1,Qy),Un(t,i)}}function AC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Un(t,e)}else{if(Nn(t,i))return;jy.set(i),n.uniformMatrix3fv(this.addr,!1,jy),Un(t,i)}}function TC(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Nn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Un(t,e)}else{if(Nn(t,i))return;Zy.set(i),n.uniformMatrix4fv(this.addr,!1,Zy),Un(t,i)}}function EC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function CC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nn(t,e))return;n.uniform2iv(this.addr,e),Un(t,e)}}function RC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Nn(t,e))return;n.uniform3iv(this.addr,e),Un(t,e)}}function PC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nn(t,e))return;n.uniform4iv(this.addr,e),Un(t,e)}}function IC(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function LC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Nn(t,e))return;n.uniform2uiv(this.addr,e),Un(t,e)}}function DC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Nn(t,e))return;n.uniform3uiv(this.addr,e),Un(t,e)}}function NC(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Nn(t,e))return;n.uniform4uiv(this.addr,e),Un(t,e)}}function sd(n){return n.version===0&&(n.compareFunction=tm,n.needsUpdate=!0),n}function UC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=sd(_v):r=gv,t.setTexture2D(e||r,s)}function OC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||vv,s)}function FC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=sd(xv):r=bv,t.setTextureCube(e||r,s)}function kC(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||yv,s)}function BC(n){switch(n){case 5126:return vC;case 35664:return bC;case 35665:return SC;case 35666:return MC;case 35674:return wC;case 35675:return AC;case 35676:return TC;case 5124:case 35670:return EC;case 35667:case 35671:return CC;case 35668:case 35672:return RC;case 35669:case 35673:return PC;case 5125:return IC;case 36294:return LC;case 36295:return DC;case 36296:return NC;case 35678:case 36198:case 36298:case 36306:case 35682:return UC;case 35679:case 36299:case 36307:return OC;case 35680:case 36300:case 36308:case 36293:return FC;case 36289:case 36303:case 36311:case 36292:return kC}}function zC(n,e){n.uniform1fv(this.addr,e)}function VC(n,e){let t=Ia(e,this.size,2);n.uniform2fv(this.addr,t)}function HC(n,e){let t=Ia(e,this.size,3);n.uniform3fv(this.addr,t)}function GC(n,e){let t=Ia(e,this.size,4);n.uniform4fv(this.addr,t)}function WC(n,e){let t=Ia(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function XC(n,e){let t=Ia(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function $C(n,e){let t=Ia(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function qC(n,e){n.uniform1iv(this.addr,e)}function YC(n,e){n.uniform2iv(this.addr,e)}function JC(n,e){n.uniform3iv(this.addr,e)}function KC(n,e){n.uniform4iv(this.addr,e)}function ZC(n,e){n.uniform1uiv(this.addr,e)}function jC(n,e){n.uniform2uiv(this.addr,e)}function QC(n,e){n.uniform3uiv(this.addr,e)}function eR(n,e){n.uniform4uiv(this.addr,e)}function tR(n,e,t){let i=this.cache,s=e.length,r=id(t,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=sd(_v):o=gv;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function nR(n,e,t){let i=this.cache,s=e.length,r=id(t,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||vv,r[o])}function iR(n,e,t){let i=this.cache,s=e.length,r=id(t,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=sd(xv):o=bv;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function sR(n,e,t){let i=this.cache,s=e.length,r=id(t,s);Nn(i,r)||(n.uniform1iv(this.addr,r),Un(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||yv,r[o])}function rR(n){switch(n){case 5126:return zC;case 35664:return VC;case 35665:return HC;case 35666:return GC;case 35674:return WC;case 35675:return XC;case 35676:return $C;case 5124:case 35670:return qC;case 35667:case 35671:return YC;case 35668:case 35672:return JC;case 35669:case 35673:return KC;case 5125:return ZC;case 36294:return jC;case 36295:return QC;case 36296:return eR;case 35678:case 36198:case 36298:case 36306:case 35682:return tR;case 35679:case 36299:case 36307:return nR;case 35680:case 36300:case 36308:case 36293:return iR;case 36289:case 36303:case 36311:case 36292:return sR}}var pm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=BC(t.type)}},mm=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=rR(t.type)}},gm=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},dm=/(\w+)(\])?(\[|\.)?/g;function ev(n,e){n.seq.push(e),n.map[e.id]=e}function oR(n,e,t){let i=n.name,s=i.length;for(dm.lastIndex=0;;){let r=dm.exec(i),o=dm.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){ev(t,c===void 0?new pm(a,n,e):new mm(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new gm(a),ev(t,f)),t=f}}}var Pa=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);oR(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function tv(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var aR=37297,lR=0;function cR(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var nv=new ot;function uR(n){vt._getMatrix(nv,vt.workingColorSpace,n);let e=`mat3( ${nv.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case xl:return[e,"LinearTransferOETF"];case Ft:return[e,"sRGBTransferOETF"];default:return Ke("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function iv(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+cR(n.getShaderSource(e),a)}else return r}function hR(n,e){let t=uR(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var dR={[kp]:"Linear",[Bp]:"Reinhard",[zp]:"Cineon",[Vp]:"ACESFilmic",[Gp]:"AgX",[Wp]:"Neutral",[Hp]:"Custom"};function fR(n,e){let t=dR[e];return t===void 0?(Ke("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var ed=new k;function pR(){vt.getLuminanceCoefficients(ed);let n=ed.x.toFixed(4),e=ed.y.toFixed(4),t=ed.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function mR(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(jl).join(`
`)}function gR(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function _R(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function jl(n){return n!==""}function sv(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function rv(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var xR=/^[ \t]*#include +<([\w\d./]+)>/gm;function _m(n){return n.replace(xR,yR)}function yR(n,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return _m(t)}var vR=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function ov(n){return n.replace(vR,bR)}function bR(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function av(n){let e=`precision ${n.precision} float;
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
	`;return n.precision==="highp"?e+=`
#define HIGH_PRECISION`:n.precision==="mediump"?e+=`
#define MEDIUM_PRECISION`:n.precision==="lowp"&&(e+=`
#define LOW_PRECISION`),e}var SR={[Vl]:"SHADOWMAP_TYPE_PCF",[Ta]:"SHADOWMAP_TYPE_VSM"};function MR(n){return SR[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var wR={[Ca]:"ENVMAP_MODE_REFRACTION"};function AR(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":wR[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var TR={[hh]:"ENVMAP_BLENDING_MULTIPLY",[Ey]:"ENVMAP_BLENDING_MIX",[Cy]:"ENVMAP_BLENDING_ADD"};function ER(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":TR[n.combine]||"ENVMAP_BLENDING_NONE"}function CR(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=MR(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=AR(t),f=ER(t),h=mR(t),d=gR(r),p=s.createProgram(),b,m,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(jl).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(jl).join(`
`),m.length>0&&(m+=`
`)):(b=[av(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(jl).join(`
`),m=[av(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==Es?"#define TONE_MAPPING":"",t.toneMapping!==Es?pt.tonemapping_pars_fragment:"",t.toneMapping!==Es?fR("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,hR("linearToOutputTexel",t.outputColorSpace),pR(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(jl).join(`
`)),o=_m(o),o=sv(o,t),o=rv(o,t),a=_m(a),a=sv(a,t),a=rv(a,t),o=ov(o),a=ov(a),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,b=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===im?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===im?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=_+b+o,C=_+m+a,S=tv(s,s.VERTEX_SHADER,v),I=tv(s,s.FRAGMENT_SHADER,C);s.attachShader(p,S),s.attachShader(p,I),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(U){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",G=s.getShaderInfoLog(S)||"",z=s.getShaderInfoLog(I)||"",N=L.trim(),W=G.trim(),Y=z.trim(),H=!0,ae=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,I);else{let K=iv(s,S,"vertex"),$=iv(s,I,"fragment");st("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+N+`
`+K+`
`+$)}else N!==""?Ke("WebGLProgram: Program Info Log:",N):(W===""||Y==="")&&(ae=!1);ae&&(U.diagnostics={runnable:H,programLog:N,vertexShader:{log:W,prefix:b},fragmentShader:{log:Y,prefix:m}})}s.deleteShader(S),s.deleteShader(I),y=new Pa(s,p),E=_R(s,p)}let y;this.getUniforms=function(){return y===void 0&&T(this),y};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let V=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return V===!1&&(V=s.getProgramParameter(p,aR)),V},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=lR++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=I,this}var RR=0,xm=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new ym(e),t.set(e,i)),i}},ym=class{constructor(e){this.id=RR++,this.code=e,this.usedTimes=0}};function PR(n){return n===Wr||n===ql||n===Yl}function IR(n,e,t,i,s,r){let o=new Sl,a=new xm,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,E,V,U,L,G){let z=U.fog,N=L.geometry,W=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?U.environment:null,Y=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,H=e.get(y.envMap||W,Y),ae=h[y.type],K=i.precision;y.precision!==null&&(K=i.getMaxPrecision(y.precision),K!==y.precision&&Ke("WebGLProgram.getParameters:",y.precision,"not supported, using",K,"instead."));let $=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ee=$!==void 0?$.length:0,he=0;N.morphAttributes.position!==void 0&&(he=1),N.morphAttributes.normal!==void 0&&(he=2),N.morphAttributes.color!==void 0&&(he=3);let de,te,me,ge;if(ae){let Ce=xi[ae];de=Ce.vertexShader,te=Ce.fragmentShader}else{de=y.vertexShader,te=y.fragmentShader;let Ce=a.getVertexShaderStage(y),dt=a.getFragmentShaderStage(y);a.update(y,Ce,dt),me=Ce.id,ge=dt.id}let Me=n.getRenderTarget(),be=n.state.buffers.depth.getReversed(),Xe=L.isInstancedMesh===!0,rt=L.isBatchedMesh===!0,He=!!y.map,ht=!!y.matcap,Ne=!!H,Ge=Ne&&H.isPMREMTexture===!0,Bt=!!y.aoMap,Wt=!!y.lightMap,xn=!!y.bumpMap&&y.wireframe===!1,Xt=!!y.normalMap,Fn=!!y.displacementMap,bt=!!y.emissiveMap,Cn=!!y.metalnessMap,an=!!y.roughnessMap,yn=y.anisotropy>0,F=y.clearcoat>0,Pe=y.diffuseRoughness>0,Ze=y.dispersion>0,ct=y.retroreflectivity>0,we=y.iridescence>0,qt=y.sheen>0,We=y.transmission>0,Je=yn&&!!y.anisotropyMap,R=F&&!!y.clearcoatMap,M=F&&!!y.clearcoatNormalMap,q=F&&!!y.clearcoatRoughnessMap,ue=Pe&&!!y.diffuseRoughnessMap,oe=we&&!!y.iridescenceMap,xe=we&&!!y.iridescenceThicknessMap,ye=qt&&!!y.sheenColorMap,ne=qt&&!!y.sheenRoughnessMap,se=!!y.specularMap,pe=!!y.specularColorMap,O=!!y.specularIntensityMap,re=We&&!!y.transmissionMap,ie=We&&!!y.thicknessMap,Ae=!!y.gradientMap,_e=!!y.alphaMap,Se=y.alphaTest>0,$e=!!y.alphaHash,tt=!!y.extensions,ce=Es;y.toneMapped&&(Me===null||Me.isXRRenderTarget===!0)&&(ce=n.toneMapping);let Be=Ge?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,nt={shaderID:ae,shaderType:y.type,shaderName:y.name,vertexShader:de,fragmentShader:te,defines:y.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:K,batching:rt,batchingColor:rt&&L._colorsTexture!==null,instancing:Xe,instancingColor:Xe&&L.instanceColor!==null,instancingMorph:Xe&&L.morphTexture!==null,outputColorSpace:Me===null?n.outputColorSpace:Me.isXRRenderTarget===!0?Me.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:He,matcap:ht,envMap:Ne,envMapMode:Ne&&H.mapping,envMapPMREM:Ge,envMapMaxLod:Ge?Be.length-1:null,envMapSize:Ge?Be[0].width:null,aoMap:Bt,lightMap:Wt,bumpMap:xn,normalMap:Xt,displacementMap:Fn,emissiveMap:bt,normalMapObjectSpace:Xt&&y.normalMapType===Iy,normalMapTangentSpace:Xt&&y.normalMapType===Zh,packedNormalMap:Xt&&y.normalMapType===Zh&&PR(y.normalMap.format),metalnessMap:Cn,roughnessMap:an,anisotropy:yn,anisotropyMap:Je,clearcoat:F,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:q,diffuseRoughness:Pe,diffuseRoughnessMap:ue,dispersion:Ze,retroreflection:ct,iridescence:we,iridescenceMap:oe,iridescenceThicknessMap:xe,sheen:qt,sheenColorMap:ye,sheenRoughnessMap:ne,specularMap:se,specularColorMap:pe,specularIntensityMap:O,transmission:We,transmissionMap:re,thicknessMap:ie,gradientMap:Ae,opaque:y.transparent===!1&&y.blending===Ea&&y.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:$e,combine:y.combine,mapUv:He&&d(y.map.channel),aoMapUv:Bt&&d(y.aoMap.channel),lightMapUv:Wt&&d(y.lightMap.channel),bumpMapUv:xn&&d(y.bumpMap.channel),normalMapUv:Xt&&d(y.normalMap.channel),displacementMapUv:Fn&&d(y.displacementMap.channel),emissiveMapUv:bt&&d(y.emissiveMap.channel),metalnessMapUv:Cn&&d(y.metalnessMap.channel),roughnessMapUv:an&&d(y.roughnessMap.channel),anisotropyMapUv:Je&&d(y.anisotropyMap.channel),clearcoatMapUv:R&&d(y.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(y.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(y.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&d(y.iridescenceThicknessMap.channel),sheenColorMapUv:ye&&d(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&d(y.sheenRoughnessMap.channel),specularMapUv:se&&d(y.specularMap.channel),specularColorMapUv:pe&&d(y.specularColorMap.channel),specularIntensityMapUv:O&&d(y.specularIntensityMap.channel),transmissionMapUv:re&&d(y.transmissionMap.channel),thicknessMapUv:ie&&d(y.thicknessMap.channel),alphaMapUv:_e&&d(y.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Xt||yn),vertexNormals:!!N.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!N.attributes.uv&&(He||_e),fog:!!z,useFog:y.fog===!0,fogExp2:!!z&&z.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||N.attributes.normal===void 0&&Xt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:be,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ee,morphTextureStride:he,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&V.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:He&&y.map.isVideoTexture===!0&&vt.getTransfer(y.map.colorSpace)===Ft,decodeVideoTextureEmissive:bt&&y.emissiveMap.isVideoTexture===!0&&vt.getTransfer(y.emissiveMap.colorSpace)===Ft,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===Si,flipSided:y.side===_i,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:tt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&y.extensions.multiDraw===!0||rt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function b(y){let E=[];if(y.shaderID?E.push(y.shaderID):(E.push(y.customVertexShaderID),E.push(y.customFragmentShaderID)),y.defines!==void 0)for(let V in y.defines)E.push(V),E.push(y.defines[V]);return y.isRawShaderMaterial===!1&&(m(E,y),_(E,y),E.push(n.outputColorSpace)),E.push(y.customProgramCacheKey),E.join()}function m(y,E){y.push(E.precision),y.push(E.outputColorSpace),y.push(E.envMapMode),y.push(E.envMapPMREM),y.push(E.envMapMaxLod),y.push(E.envMapSize),y.push(E.mapUv),y.push(E.alphaMapUv),y.push(E.lightMapUv),y.push(E.aoMapUv),y.push(E.bumpMapUv),y.push(E.normalMapUv),y.push(E.displacementMapUv),y.push(E.emissiveMapUv),y.push(E.metalnessMapUv),y.push(E.roughnessMapUv),y.push(E.anisotropyMapUv),y.push(E.clearcoatMapUv),y.push(E.clearcoatNormalMapUv),y.push(E.clearcoatRoughnessMapUv),y.push(E.diffuseRoughnessMapUv),y.push(E.iridescenceMapUv),y.push(E.iridescenceThicknessMapUv),y.push(E.sheenColorMapUv),y.push(E.sheenRoughnessMapUv),y.push(E.specularMapUv),y.push(E.specularColorMapUv),y.push(E.specularIntensityMapUv),y.push(E.transmissionMapUv),y.push(E.thicknessMapUv),y.push(E.combine),y.push(E.fogExp2),y.push(E.sizeAttenuation),y.push(E.morphTargetsCount),y.push(E.numSunLights),y.push(E.numDirLights),y.push(E.numPointLights),y.push(E.numSpotLights),y.push(E.numSpotLightMaps),y.push(E.numHemiLights),y.push(E.numRectAreaLights),y.push(E.numSunLightShadows),y.push(E.numDirLightShadows),y.push(E.numPointLightShadows),y.push(E.numSpotLightShadows),y.push(E.numSpotLightShadowsWithMaps),y.push(E.numLightProbes),y.push(E.numLightProbeGrids),y.push(E.shadowMapType),y.push(E.toneMapping),y.push(E.numClippingPlanes),y.push(E.numClipIntersection),y.push(E.depthPacking)}function _(y,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function v(y){let E=h[y.type],V;if(E){let U=xi[E];V=Kl.clone(U.uniforms)}else V=y.uniforms;return V}function C(y,E){let V=u.get(E);return V!==void 0?++V.usedTimes:(V=new CR(n,E,y,s),c.push(V),u.set(E,V)),V}function S(y){if(--y.usedTimes===0){let E=c.indexOf(y);c[E]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function I(y){a.remove(y)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:b,getUniforms:v,acquireProgram:C,releaseProgram:S,releaseShaderCache:I,programs:c,dispose:T}}function LR(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function DR(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function lv(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function cv(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,b,m,_){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:b,renderOrder:h.renderOrder,z:m,group:_},n[e]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=p,v.materialVariant=o(h),v.groupOrder=b,v.renderOrder=h.renderOrder,v.z=m,v.group=_),e++,v}function l(h,d,p,b,m,_,v){v.reversedDepth===!0&&(m=-m);let C=a(h,d,p,b,m,_);p.transmission>0?i.push(C):p.transparent===!0?s.push(C):t.push(C)}function c(h,d,p,b,m,_){let v=a(h,d,p,b,m,_);p.transmission>0?i.unshift(v):p.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||DR),i.length>1&&i.sort(d||lv),s.length>1&&s.sort(d||lv)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function NR(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new cv,n.set(i,[o])):s>=r.length?(o=new cv,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function UR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new k,color:new lt};break;case"SpotLight":t={position:new k,direction:new k,color:new lt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new k,color:new lt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new k,skyColor:new lt,groundColor:new lt};break;case"RectAreaLight":t={color:new lt,position:new k,halfWidth:new k,halfHeight:new k};break}return n[e.id]=t,t}}}function OR(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var FR=0;function kR(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function BR(n){let e=new UR,t=OR(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new k);let s=new k,r=new wt,o=new wt;function a(c){let u=0,f=0,h=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let d=0,p=0,b=0,m=0,_=0,v=0,C=0,S=0,I=0,T=0,y=0,E=0,V=0,U=0;c.sort(kR);for(let G=0,z=c.length;G<z;G++){let N=c[G],W=N.color,Y=N.intensity,H=N.distance,ae=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Wr?ae=N.shadow.map.texture:ae=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*Y,f+=W.g*Y,h+=W.b*Y;else if(N.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(N.sh.coefficients[K],Y);U++}else if(N.isSunLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let $=N.shadow,ee=t.get(N);ee.shadowIntensity=$.intensity,ee.shadowBias=$.bias,ee.shadowNormalBias=$.normalBias,ee.shadowRadius=$.radius,ee.shadowMapSize.copy($.mapSize).multiply($.getFrameExtents()),i.sunShadow[p]=ee,i.sunShadowMap[p]=ae;let he=$.getViewportCount();for(let de=0;de<he;de++)i.sunShadowMatrix[b+de]=$.getMatrix(de),i.sunShadowCascade[b+de]=$._cascadeData[de];b+=he,p++}i.sun[d]=K,d++}else if(N.isDirectionalLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let $=N.shadow,ee=t.get(N);ee.shadowIntensity=$.intensity,ee.shadowBias=$.bias,ee.shadowNormalBias=$.normalBias,ee.shadowRadius=$.radius,ee.shadowMapSize=$.mapSize,i.directionalShadow[m]=ee,i.directionalShadowMap[m]=ae,i.directionalShadowMatrix[m]=N.shadow.matrix,I++}i.directional[m]=K,m++}else if(N.isSpotLight){let K=e.get(N);K.position.setFromMatrixPosition(N.matrixWorld),K.color.copy(W).multiplyScalar(Y),K.distance=H,K.coneCos=Math.cos(N.angle),K.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),K.decay=N.decay,i.spot[v]=K;let $=N.shadow;if(N.map&&(i.spotLightMap[E]=N.map,E++,$.updateMatrices(N),N.castShadow&&V++),i.spotLightMatrix[v]=$.matrix,N.castShadow){let ee=t.get(N);ee.shadowIntensity=$.intensity,ee.shadowBias=$.bias,ee.shadowNormalBias=$.normalBias,ee.shadowRadius=$.radius,ee.shadowMapSize=$.mapSize,i.spotShadow[v]=ee,i.spotShadowMap[v]=ae,y++}v++}else if(N.isRectAreaLight){let K=e.get(N);K.color.copy(W).multiplyScalar(Y),K.halfWidth.set(N.width*.5,0,0),K.halfHeight.set(0,N.height*.5,0),i.rectArea[C]=K,C++}else if(N.isPointLight){let K=e.get(N);if(K.color.copy(N.color).multiplyScalar(N.intensity),K.distance=N.distance,K.decay=N.decay,N.castShadow){let $=N.shadow,ee=t.get(N);ee.shadowIntensity=$.intensity,ee.shadowBias=$.bias,ee.shadowNormalBias=$.normalBias,ee.shadowRadius=$.radius,ee.shadowMapSize=$.mapSize,ee.shadowCameraNear=$.camera.near,ee.shadowCameraFar=$.camera.far,i.pointShadow[_]=ee,i.pointShadowMap[_]=ae,i.pointShadowMatrix[_]=N.shadow.matrix,T++}i.point[_]=K,_++}else if(N.isHemisphereLight){let K=e.get(N);K.skyColor.copy(N.color).multiplyScalar(Y),K.groundColor.copy(N.groundColor).multiplyScalar(Y),i.hemi[S]=K,S++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Ie.LTC_FLOAT_1,i.rectAreaLTC2=Ie.LTC_FLOAT_2):(i.rectAreaLTC1=Ie.LTC_HALF_1,i.rectAreaLTC2=Ie.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let L=i.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==_||L.spotLength!==v||L.rectAreaLength!==C||L.hemiLength!==S||L.numSunShadows!==p||L.numDirectionalShadows!==I||L.numPointShadows!==T||L.numSpotShadows!==y||L.numSpotMaps!==E||L.numLightProbes!==U)&&(i.sun.length=d,i.directional.length=m,i.spot.length=v,i.rectArea.length=C,i.point.length=_,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=I,i.directionalShadowMap.length=I,i.directionalShadowMatrix.length=I,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+E-V,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=V,i.numLightProbes=U,L.sunLength=d,L.directionalLength=m,L.pointLength=_,L.spotLength=v,L.rectAreaLength=C,L.hemiLength=S,L.numSunShadows=p,L.numDirectionalShadows=I,L.numPointShadows=T,L.numSpotShadows=y,L.numSpotMaps=E,L.numLightProbes=U,i.version=FR++)}function l(c,u){let f=0,h=0,d=0,p=0,b=0,m=0,_=u.matrixWorldInverse;for(let v=0,C=c.length;v<C;v++){let S=c[v];if(S.isSunLight){let I=i.sun[f];I.direction.setFromMatrixPosition(S.matrixWorld),I.direction.transformDirection(_),f++}else if(S.isDirectionalLight){let I=i.directional[h];I.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(_),h++}else if(S.isSpotLight){let I=i.spot[p];I.position.setFromMatrixPosition(S.matrixWorld),I.position.applyMatrix4(_),I.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(_),p++}else if(S.isRectAreaLight){let I=i.rectArea[b];I.position.setFromMatrixPosition(S.matrixWorld),I.position.applyMatrix4(_),o.identity(),r.copy(S.matrixWorld),r.premultiply(_),o.extractRotation(r),I.halfWidth.set(S.width*.5,0,0),I.halfHeight.set(0,S.height*.5,0),I.halfWidth.applyMatrix4(o),I.halfHeight.applyMatrix4(o),b++}else if(S.isPointLight){let I=i.point[d];I.position.setFromMatrixPosition(S.matrixWorld),I.position.applyMatrix4(_),d++}else if(S.isHemisphereLight){let I=i.hemi[m];I.direction.setFromMatrixPosition(S.matrixWorld),I.direction.transformDirection(_),m++}}}return{setup:a,setupView:l,state:i}}function uv(n){let e=new BR(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function zR(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new uv(n),e.set(s,[a])):r>=o.length?(a=new uv(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var VR=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,HR=`uniform sampler2D shadow_pass;
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
}`,GR=[new k(1,0,0),new k(-1,0,0),new k(0,1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1)],WR=[new k(0,-1,0),new k(0,-1,0),new k(0,0,1),new k(0,0,-1),new k(0,-1,0),new k(0,-1,0)],hv=new wt,Zl=new k,fm=new k;function XR(n,e,t){let i=new Or,s=new je,r=new je,o=new kt,a=new Zu,l=new ju,c={},u=t.maxTextureSize,f={[Gr]:_i,[_i]:Gr,[Si]:Si},h=new qi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new je},radius:{value:4}},vertexShader:VR,fragmentShader:HR}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new rn;p.setAttribute("position",new sn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new qn(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Vl;let _=this.type;this.render=function(T,y,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===ly&&(Ke("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Vl);let V=n.getRenderTarget(),U=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),G=n.state;G.setBlending(fo),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let z=_!==this.type;z&&y.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=T.length;N<W;N++){let Y=T[N],H=Y.shadow;if(H===void 0){Ke("WebGLShadowMap:",Y,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let ae=H.getFrameExtents();s.multiply(ae),r.copy(H.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ae.x),s.x=r.x*ae.x,H.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ae.y),s.y=r.y*ae.y,H.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(H.camera._reversedDepth=K,H.map===null||z===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===Ta){if(Y.isPointLight){Ke("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new Oi(s.x,s.y,{format:Wr,type:ds,minFilter:gi,magFilter:gi,generateMipmaps:!1}),H.map.texture.name=Y.name+".shadowMap",H.map.depthTexture=new rr(s.x,s.y,hs),H.map.depthTexture.name=Y.name+".shadowMapDepth",H.map.depthTexture.format=nr,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=_n,H.map.depthTexture.magFilter=_n}else Y.isPointLight?(H.map=new Ql(s.x),H.map.depthTexture=new El(s.x,us)):(H.map=new Oi(s.x,s.y),H.map.depthTexture=new rr(s.x,s.y,us)),H.map.depthTexture.name=Y.name+".shadowMap",H.map.depthTexture.format=nr,this.type===Vl?(H.map.depthTexture.compareFunction=K?em:Qp,H.map.depthTexture.minFilter=gi,H.map.depthTexture.magFilter=gi):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=_n,H.map.depthTexture.magFilter=_n);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let $=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();Y.isPointLight!==!0&&H.updateMatrices(Y,E);let ee=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:E.layers;for(let he=0;he<$;he++){let de=H.getCamera(he);if(Y.isPointLight){let te=H.camera,me=H.matrix,ge=Y.distance||te.far;ge!==te.far&&(te.far=ge,te.updateProjectionMatrix()),Zl.setFromMatrixPosition(Y.matrixWorld),te.position.copy(Zl),fm.copy(te.position),fm.add(GR[he]),te.up.copy(WR[he]),te.lookAt(fm),te.updateMatrixWorld(),me.makeTranslation(-Zl.x,-Zl.y,-Zl.z),hv.multiplyMatrices(te.projectionMatrix,te.matrixWorldInverse),H._frustum.setFromProjectionMatrix(hv,te.coordinateSystem,te.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)n.setRenderTarget(H.map,he),n.clear();else{he===0&&(n.setRenderTarget(H.map),n.clear());let te=H.getViewport(he);o.set(r.x*te.x,r.y*te.y,r.x*te.z,r.y*te.w),G.viewport(o)}i=H.getFrustum(he),S(y,E,de,Y,ee,this.type)}H.isPointLightShadow!==!0&&this.type===Ta&&v(H,E),H.needsUpdate=!1}_=this.type,m.needsUpdate=!1,n.setRenderTarget(V,U,L)};function v(T,y){let E=e.update(b);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,d.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),T.mapPass===null?T.mapPass=new Oi(s.x,s.y,{format:Wr,type:ds}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value.set(T.map.width,T.map.height),h.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(y,null,E,h,b,null),d.uniforms.shadow_pass.value=T.mapPass.texture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(y,null,E,d,b,null)}function C(T,y,E,V){let U=null,L=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(L!==void 0)U=L;else if(U=E.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let G=U.uuid,z=y.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let W=N[z];W===void 0&&(W=U.clone(),N[z]=W,y.addEventListener("dispose",I)),U=W}if(U.visible=y.visible,U.wireframe=y.wireframe,V===Ta?U.side=y.shadowSide!==null?y.shadowSide:y.side:U.side=y.shadowSide!==null?y.shadowSide:f[y.side],U.alphaMap=y.alphaMap,U.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,U.map=y.map,U.clipShadows=y.clipShadows,U.clippingPlanes=y.clippingPlanes,U.clipIntersection=y.clipIntersection,U.displacementMap=y.displacementMap,U.displacementScale=y.displacementScale,U.displacementBias=y.displacementBias,U.wireframeLinewidth=y.wireframeLinewidth,U.linewidth=y.linewidth,E.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let G=n.properties.get(U);G.light=E}return U}function S(T,y,E,V,U,L){if(T.visible===!1)return;if(T.layers.test(U)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&L===Ta)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let N=e.update(T),W=T.material;if(Array.isArray(W)){let Y=N.groups;for(let H=0,ae=Y.length;H<ae;H++){let K=Y[H],$=W[K.materialIndex];if($&&$.visible){let ee=C(T,$,V,L);T.onBeforeShadow(n,T,y,E,N,ee,K),n.renderBufferDirect(E,null,N,ee,T,K),T.onAfterShadow(n,T,y,E,N,ee,K)}}}else if(W.visible){let Y=C(T,W,V,L);T.onBeforeShadow(n,T,y,E,N,Y,null),n.renderBufferDirect(E,null,N,Y,T,null),T.onAfterShadow(n,T,y,E,N,Y,null)}}let z=T.children;for(let N=0,W=z.length;N<W;N++)S(z[N],y,E,V,U,L)}function I(T){T.target.removeEventListener("dispose",I);for(let E in c){let V=c[E],U=T.target.uuid;U in V&&(V[U].dispose(),delete V[U])}}}function $R(n,e){function t(){let O=!1,re=new kt,ie=null,Ae=new kt(0,0,0,0);return{setMask:function(_e){ie!==_e&&!O&&(n.colorMask(_e,_e,_e,_e),ie=_e)},setLocked:function(_e){O=_e},setClear:function(_e,Se,$e,tt,ce){ce===!0&&(_e*=tt,Se*=tt,$e*=tt),re.set(_e,Se,$e,tt),Ae.equals(re)===!1&&(n.clearColor(_e,Se,$e,tt),Ae.copy(re))},reset:function(){O=!1,ie=null,Ae.set(-1,0,0,0)}}}function i(){let O=!1,re=!1,ie=null,Ae=null,_e=null;return{setReversed:function(Se){if(re!==Se){let $e=e.get("EXT_clip_control");Se?$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.ZERO_TO_ONE_EXT):$e.clipControlEXT($e.LOWER_LEFT_EXT,$e.NEGATIVE_ONE_TO_ONE_EXT),re=Se;let tt=_e;_e=null,this.setClear(tt)}},getReversed:function(){return re},setTest:function(Se){Se?be(n.DEPTH_TEST):Xe(n.DEPTH_TEST)},setMask:function(Se){ie!==Se&&!O&&(n.depthMask(Se),ie=Se)},setFunc:function(Se){if(re&&(Se=Vy[Se]),Ae!==Se){switch(Se){case Lu:n.depthFunc(n.NEVER);break;case Du:n.depthFunc(n.ALWAYS);break;case Nu:n.depthFunc(n.LESS);break;case Nr:n.depthFunc(n.LEQUAL);break;case Uu:n.depthFunc(n.EQUAL);break;case Ou:n.depthFunc(n.GEQUAL);break;case Fu:n.depthFunc(n.GREATER);break;case ku:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=Se}},setLocked:function(Se){O=Se},setClear:function(Se){_e!==Se&&(_e=Se,re&&(Se=1-Se),n.clearDepth(Se))},reset:function(){O=!1,ie=null,Ae=null,_e=null,re=!1}}}function s(){let O=!1,re=null,ie=null,Ae=null,_e=null,Se=null,$e=null,tt=null,ce=null;return{setTest:function(Be){O||(Be?be(n.STENCIL_TEST):Xe(n.STENCIL_TEST))},setMask:function(Be){re!==Be&&!O&&(n.stencilMask(Be),re=Be)},setFunc:function(Be,nt,Ce){(ie!==Be||Ae!==nt||_e!==Ce)&&(n.stencilFunc(Be,nt,Ce),ie=Be,Ae=nt,_e=Ce)},setOp:function(Be,nt,Ce){(Se!==Be||$e!==nt||tt!==Ce)&&(n.stencilOp(Be,nt,Ce),Se=Be,$e=nt,tt=Ce)},setLocked:function(Be){O=Be},setClear:function(Be){ce!==Be&&(n.clearStencil(Be),ce=Be)},reset:function(){O=!1,re=null,ie=null,Ae=null,_e=null,Se=null,$e=null,tt=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],b=null,m=!1,_=null,v=null,C=null,S=null,I=null,T=null,y=null,E=new lt(0,0,0),V=0,U=!1,L=null,G=null,z=null,N=null,W=null,Y=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,ae=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(ae=parseFloat(/^WebGL (\d)/.exec(K)[1]),H=ae>=1):K.indexOf("OpenGL ES")!==-1&&(ae=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),H=ae>=2);let $=null,ee={},he=n.getParameter(n.SCISSOR_BOX),de=n.getParameter(n.VIEWPORT),te=new kt().fromArray(he),me=new kt().fromArray(de);function ge(O,re,ie,Ae){let _e=new Uint8Array(4),Se=n.createTexture();n.bindTexture(O,Se),n.texParameteri(O,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(O,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let $e=0;$e<ie;$e++)O===n.TEXTURE_3D||O===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(re+$e,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Se}let Me={};Me[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Me[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Me[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Me[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),be(n.DEPTH_TEST),o.setFunc(Nr),xn(!1),Xt(Lp),be(n.CULL_FACE),Bt(fo);function be(O){u[O]!==!0&&(n.enable(O),u[O]=!0)}function Xe(O){u[O]!==!1&&(n.disable(O),u[O]=!1)}function rt(O,re){return h[O]!==re?(n.bindFramebuffer(O,re),h[O]=re,O===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),O===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function He(O,re){let ie=p,Ae=!1;if(O){ie=d.get(re),ie===void 0&&(ie=[],d.set(re,ie));let _e=O.textures;if(ie.length!==_e.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,$e=_e.length;Se<$e;Se++)ie[Se]=n.COLOR_ATTACHMENT0+Se;ie.length=_e.length,Ae=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(ie)}function ht(O){return b!==O?(n.useProgram(O),b=O,!0):!1}let Ne={[po]:n.FUNC_ADD,[uy]:n.FUNC_SUBTRACT,[hy]:n.FUNC_REVERSE_SUBTRACT};Ne[dy]=n.MIN,Ne[fy]=n.MAX;let Ge={[py]:n.ZERO,[my]:n.ONE,[gy]:n.SRC_COLOR,[Op]:n.SRC_ALPHA,[Sy]:n.SRC_ALPHA_SATURATE,[vy]:n.DST_COLOR,[xy]:n.DST_ALPHA,[_y]:n.ONE_MINUS_SRC_COLOR,[Fp]:n.ONE_MINUS_SRC_ALPHA,[by]:n.ONE_MINUS_DST_COLOR,[yy]:n.ONE_MINUS_DST_ALPHA,[My]:n.CONSTANT_COLOR,[wy]:n.ONE_MINUS_CONSTANT_COLOR,[Ay]:n.CONSTANT_ALPHA,[Ty]:n.ONE_MINUS_CONSTANT_ALPHA};function Bt(O,re,ie,Ae,_e,Se,$e,tt,ce,Be){if(O===fo){m===!0&&(Xe(n.BLEND),m=!1);return}if(m===!1&&(be(n.BLEND),m=!0),O!==cy){if(O!==_||Be!==U){if((v!==po||I!==po)&&(n.blendEquation(n.FUNC_ADD),v=po,I=po),Be)switch(O){case Ea:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dp:n.blendFunc(n.ONE,n.ONE);break;case Np:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Up:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:st("WebGLState: Invalid blending: ",O);break}else switch(O){case Ea:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Dp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Np:st("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Up:st("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:st("WebGLState: Invalid blending: ",O);break}C=null,S=null,T=null,y=null,E.set(0,0,0),V=0,_=O,U=Be}return}_e=_e||re,Se=Se||ie,$e=$e||Ae,(re!==v||_e!==I)&&(n.blendEquationSeparate(Ne[re],Ne[_e]),v=re,I=_e),(ie!==C||Ae!==S||Se!==T||$e!==y)&&(n.blendFuncSeparate(Ge[ie],Ge[Ae],Ge[Se],Ge[$e]),C=ie,S=Ae,T=Se,y=$e),(tt.equals(E)===!1||ce!==V)&&(n.blendColor(tt.r,tt.g,tt.b,ce),E.copy(tt),V=ce),_=O,U=!1}function Wt(O,re){O.side===Si?Xe(n.CULL_FACE):be(n.CULL_FACE);let ie=O.side===_i;re&&(ie=!ie),xn(ie),O.blending===Ea&&O.transparent===!1?Bt(fo):Bt(O.blending,O.blendEquation,O.blendSrc,O.blendDst,O.blendEquationAlpha,O.blendSrcAlpha,O.blendDstAlpha,O.blendColor,O.blendAlpha,O.premultipliedAlpha),o.setFunc(O.depthFunc),o.setTest(O.depthTest),o.setMask(O.depthWrite),r.setMask(O.colorWrite);let Ae=O.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(O.stencilWriteMask),a.setFunc(O.stencilFunc,O.stencilRef,O.stencilFuncMask),a.setOp(O.stencilFail,O.stencilZFail,O.stencilZPass)),bt(O.polygonOffset,O.polygonOffsetFactor,O.polygonOffsetUnits),O.alphaToCoverage===!0?be(n.SAMPLE_ALPHA_TO_COVERAGE):Xe(n.SAMPLE_ALPHA_TO_COVERAGE)}function xn(O){L!==O&&(O?n.frontFace(n.CW):n.frontFace(n.CCW),L=O)}function Xt(O){O!==oy?(be(n.CULL_FACE),O!==G&&(O===Lp?n.cullFace(n.BACK):O===ay?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Xe(n.CULL_FACE),G=O}function Fn(O){O!==z&&(H&&n.lineWidth(O),z=O)}function bt(O,re,ie){O?(be(n.POLYGON_OFFSET_FILL),(N!==re||W!==ie)&&(N=re,W=ie,o.getReversed()&&(re=-re,ie=-ie),n.polygonOffset(re,ie))):Xe(n.POLYGON_OFFSET_FILL)}function Cn(O){O?be(n.SCISSOR_TEST):Xe(n.SCISSOR_TEST)}function an(O){O===void 0&&(O=n.TEXTURE0+Y-1),$!==O&&(n.activeTexture(O),$=O)}function yn(O,re,ie){ie===void 0&&($===null?ie=n.TEXTURE0+Y-1:ie=$);let Ae=ee[ie];Ae===void 0&&(Ae={type:void 0,texture:void 0},ee[ie]=Ae),(Ae.type!==O||Ae.texture!==re)&&($!==ie&&(n.activeTexture(ie),$=ie),n.bindTexture(O,re||Me[O]),Ae.type=O,Ae.texture=re)}function F(){let O=ee[$];O!==void 0&&O.type!==void 0&&(n.bindTexture(O.type,null),O.type=void 0,O.texture=void 0)}function Pe(){try{n.compressedTexImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function ct(){try{n.texSubImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function we(){try{n.texSubImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function qt(){try{n.compressedTexSubImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function We(){try{n.compressedTexSubImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function Je(){try{n.texStorage2D(...arguments)}catch(O){st("WebGLState:",O)}}function R(){try{n.texStorage3D(...arguments)}catch(O){st("WebGLState:",O)}}function M(){try{n.texImage2D(...arguments)}catch(O){st("WebGLState:",O)}}function q(){try{n.texImage3D(...arguments)}catch(O){st("WebGLState:",O)}}function ue(O){return f[O]!==void 0?f[O]:n.getParameter(O)}function oe(O,re){f[O]!==re&&(n.pixelStorei(O,re),f[O]=re)}function xe(O){te.equals(O)===!1&&(n.scissor(O.x,O.y,O.z,O.w),te.copy(O))}function ye(O){me.equals(O)===!1&&(n.viewport(O.x,O.y,O.z,O.w),me.copy(O))}function ne(O,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let Ae=ie.get(O);Ae===void 0&&(Ae=n.getUniformBlockIndex(re,O.name),n.uniformBlockBinding(re,Ae,Ae),ie.set(O,Ae))}function se(O,re,ie){let _e=c.get(re).get(O);l[_e]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ie),l[_e]=ie)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},$=null,ee={},h={},l={},d=new WeakMap,p=[],b=null,m=!1,_=null,v=null,C=null,S=null,I=null,T=null,y=null,E=new lt(0,0,0),V=0,U=!1,L=null,G=null,z=null,N=null,W=null,te.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:be,disable:Xe,bindFramebuffer:rt,drawBuffers:He,useProgram:ht,setBlending:Bt,setMaterial:Wt,setFlipSided:xn,setCullFace:Xt,setLineWidth:Fn,setPolygonOffset:bt,setScissorTest:Cn,activeTexture:an,bindTexture:yn,unbindTexture:F,compressedTexImage2D:Pe,compressedTexImage3D:Ze,texImage2D:M,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:Je,texStorage3D:R,texSubImage2D:ct,texSubImage3D:we,compressedTexSubImage2D:qt,compressedTexSubImage3D:We,scissor:xe,viewport:ye,reset:pe}}function qR(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new je,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,b=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(R,M){return m?new OffscreenCanvas(R,M):yl("canvas")}function v(R,M,q){let ue=1,oe=Je(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let xe=Math.floor(ue*oe.width),ye=Math.floor(ue*oe.height);h===void 0&&(h=_(xe,ye));let ne=M?_(xe,ye):h;return ne.width=xe,ne.height=ye,ne.getContext("2d").drawImage(R,0,0,xe,ye),Ke("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+xe+"x"+ye+")."),ne}else return"data"in R&&Ke("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function C(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function I(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(R,M,q,ue,oe,xe=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ke("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ye;ue&&(ye=e.get("EXT_texture_norm16"),ye||Ke("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=M;if(M===n.RED&&(q===n.FLOAT&&(ne=n.R32F),q===n.HALF_FLOAT&&(ne=n.R16F),q===n.UNSIGNED_BYTE&&(ne=n.R8),q===n.UNSIGNED_SHORT&&ye&&(ne=ye.R16_EXT),q===n.SHORT&&ye&&(ne=ye.R16_SNORM_EXT)),M===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.R8UI),q===n.UNSIGNED_SHORT&&(ne=n.R16UI),q===n.UNSIGNED_INT&&(ne=n.R32UI),q===n.BYTE&&(ne=n.R8I),q===n.SHORT&&(ne=n.R16I),q===n.INT&&(ne=n.R32I)),M===n.RG&&(q===n.FLOAT&&(ne=n.RG32F),q===n.HALF_FLOAT&&(ne=n.RG16F),q===n.UNSIGNED_BYTE&&(ne=n.RG8),q===n.UNSIGNED_SHORT&&ye&&(ne=ye.RG16_EXT),q===n.SHORT&&ye&&(ne=ye.RG16_SNORM_EXT)),M===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RG8UI),q===n.UNSIGNED_SHORT&&(ne=n.RG16UI),q===n.UNSIGNED_INT&&(ne=n.RG32UI),q===n.BYTE&&(ne=n.RG8I),q===n.SHORT&&(ne=n.RG16I),q===n.INT&&(ne=n.RG32I)),M===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),q===n.UNSIGNED_INT&&(ne=n.RGB32UI),q===n.BYTE&&(ne=n.RGB8I),q===n.SHORT&&(ne=n.RGB16I),q===n.INT&&(ne=n.RGB32I)),M===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),q===n.UNSIGNED_INT&&(ne=n.RGBA32UI),q===n.BYTE&&(ne=n.RGBA8I),q===n.SHORT&&(ne=n.RGBA16I),q===n.INT&&(ne=n.RGBA32I)),M===n.RGB&&(q===n.UNSIGNED_SHORT&&ye&&(ne=ye.RGB16_EXT),q===n.SHORT&&ye&&(ne=ye.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),M===n.RGBA){let se=xe?xl:vt.getTransfer(oe);q===n.FLOAT&&(ne=n.RGBA32F),q===n.HALF_FLOAT&&(ne=n.RGBA16F),q===n.UNSIGNED_BYTE&&(ne=se===Ft?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&ye&&(ne=ye.RGBA16_EXT),q===n.SHORT&&ye&&(ne=ye.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(R,M){let q;return R?M===null||M===us||M===go?q=n.DEPTH24_STENCIL8:M===hs?q=n.DEPTH32F_STENCIL8:M===Ra&&(q=n.DEPTH24_STENCIL8,Ke("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===us||M===go?q=n.DEPTH_COMPONENT24:M===hs?q=n.DEPTH_COMPONENT32F:M===Ra&&(q=n.DEPTH_COMPONENT16),q}function E(R,M){return C(R)===!0||R.isFramebufferTexture&&R.minFilter!==_n&&R.minFilter!==gi?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function V(R){let M=new WeakRef(R);i.get(R).__ref=M,p.add(M),b.register(R,M,M)}function U(R){let M=i.get(R).__ref;M!==void 0&&(p.delete(M),b.unregister(M))}function L(R){z(R.target)}function G(R){N(R.target)}function z(R){R.removeEventListener("dispose",L),U(R),Y(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function N(R){R.removeEventListener("dispose",G),U(R),ae(R)}function W(){for(let R of p){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):z(M))}p.clear(),f.clear()}function Y(R){let M=i.get(R);if(M.__webglInit===void 0)return;let q=R.source,ue=d.get(q);if(ue){let oe=ue[M.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&H(R),Object.keys(ue).length===0&&d.delete(q)}i.remove(R)}function H(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let q=R.source,ue=d.get(q);delete ue[M.__cacheKey],o.memory.textures--}function ae(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&z(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(M.__webglFramebuffer[oe]))for(let xe=0;xe<M.__webglFramebuffer[oe].length;xe++)n.deleteFramebuffer(M.__webglFramebuffer[oe][xe]);else n.deleteFramebuffer(M.__webglFramebuffer[oe]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[oe])}else{if(Array.isArray(M.__webglFramebuffer))for(let oe=0;oe<M.__webglFramebuffer.length;oe++)n.deleteFramebuffer(M.__webglFramebuffer[oe]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let oe=0;oe<M.__webglColorRenderbuffer.length;oe++)M.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[oe]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,xe=ue.length;oe<xe;oe++){let ye=i.get(ue[oe]);ye.__webglTexture&&(n.deleteTexture(ye.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let K=0;function $(){K=0}function ee(){return K}function he(R){K=R}function de(){let R=K;return R>=s.maxTextures&&Ke("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,R}function te(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let q=i.get(R);if(R.isVideoTexture&&qt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Ke("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Ke("WebGLRenderer: Texture marked for update but image is incomplete");else{Wt(q,R,M);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+M)}function ge(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Wt(q,R,M);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+M)}function Me(R,M){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Wt(q,R,M);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+M)}function be(R,M){let q=i.get(R);if(R.version>0&&q.__version!==R.version){xn(q,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+M)}let Xe={[Bu]:n.REPEAT,[Ms]:n.CLAMP_TO_EDGE,[zu]:n.MIRRORED_REPEAT},rt={[_n]:n.NEAREST,[Ry]:n.NEAREST_MIPMAP_NEAREST,[Hl]:n.NEAREST_MIPMAP_LINEAR,[gi]:n.LINEAR,[ph]:n.LINEAR_MIPMAP_NEAREST,[or]:n.LINEAR_MIPMAP_LINEAR},He={[Dy]:n.NEVER,[tm]:n.ALWAYS,[Ny]:n.LESS,[Qp]:n.LEQUAL,[Uy]:n.EQUAL,[em]:n.GEQUAL,[Oy]:n.GREATER,[Fy]:n.NOTEQUAL};function ht(R,M){if(M.type===hs&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===gi||M.magFilter===ph||M.magFilter===Hl||M.magFilter===or||M.minFilter===gi||M.minFilter===ph||M.minFilter===Hl||M.minFilter===or)&&Ke("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Xe[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Xe[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Xe[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,rt[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,rt[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,He[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===_n||M.minFilter!==Hl&&M.minFilter!==or||M.type===hs&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function Ne(R,M){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),V(M));let ue=M.source,oe=d.get(ue);oe===void 0&&(oe={},d.set(ue,oe));let xe=te(M);if(xe!==R.__cacheKey){oe[xe]===void 0&&(oe[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[xe].usedTimes++;let ye=oe[R.__cacheKey];ye!==void 0&&(oe[R.__cacheKey].usedTimes--,ye.usedTimes===0&&H(M)),R.__cacheKey=xe,R.__webglTexture=oe[xe].texture}return q}function Ge(R,M,q){return Math.floor(Math.floor(R/q)/M)}function Bt(R,M,q,ue){let xe=R.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,q,ue,M.data);else{xe.sort((O,re)=>O.start-re.start);let ye=0;for(let O=1;O<xe.length;O++){let re=xe[ye],ie=xe[O],Ae=re.start+re.count,_e=Ge(ie.start,M.width,4),Se=Ge(re.start,M.width,4);ie.start<=Ae+1&&_e===Se&&Ge(ie.start+ie.count-1,M.width,4)===_e?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++ye,xe[ye]=ie)}xe.length=ye+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let O=0,re=xe.length;O<re;O++){let ie=xe[O],Ae=Math.floor(ie.start/4),_e=Math.ceil(ie.count/4),Se=Ae%M.width,$e=Math.floor(Ae/M.width),tt=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,$e),t.texSubImage2D(n.TEXTURE_2D,0,Se,$e,tt,ce,q,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Wt(R,M,q){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=Ne(R,M),xe=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(xe);if(xe.version!==ye.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=vt.getPrimaries(vt.workingColorSpace),Be=M.colorSpace===lr?null:vt.getPrimaries(M.colorSpace),nt=M.colorSpace===lr||ce===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let se=v(M.image,!1,s.maxTextureSize);se=We(M,se);let pe=r.convert(M.format,M.colorSpace),O=r.convert(M.type),re=T(M.internalFormat,pe,O,M.normalized,M.colorSpace,M.isVideoTexture);ht(ue,M);let ie,Ae=M.mipmaps,_e=M.isVideoTexture!==!0,Se=ye.__version===void 0||oe===!0,$e=xe.dataReady,tt=E(M,se);if(M.isDepthTexture)re=y(M.format===ar,M.type),Se&&(_e?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,null));else if(M.isDataTexture)if(Ae.length>0){_e&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,re,Ae[0].width,Ae[0].height);for(let ce=0,Be=Ae.length;ce<Be;ce++)ie=Ae[ce],_e?$e&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,ce,re,ie.width,ie.height,0,pe,O,ie.data);M.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(n.TEXTURE_2D,tt,re,se.width,se.height),$e&&Bt(M,se,pe,O)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,O,se.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,re,Ae[0].width,Ae[0].height,se.depth);for(let ce=0,Be=Ae.length;ce<Be;ce++)if(ie=Ae[ce],M.format!==ki)if(pe!==null)if(_e){if($e)if(M.layerUpdates.size>0){let nt=hm(ie.width,ie.height,M.format,M.type);for(let Ce of M.layerUpdates){let dt=ie.data.subarray(Ce*nt/ie.data.BYTES_PER_ELEMENT,(Ce+1)*nt/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ie.width,ie.height,1,pe,dt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,pe,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?$e&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ie.width,ie.height,se.depth,pe,O,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ie.width,ie.height,se.depth,0,pe,O,ie.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(n.TEXTURE_2D,tt,re,Ae[0].width,Ae[0].height);for(let ce=0,Be=Ae.length;ce<Be;ce++)ie=Ae[ce],M.format!==ki?pe!==null?_e?$e&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,pe,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ie.width,ie.height,0,ie.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?$e&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ie.width,ie.height,pe,O,ie.data):t.texImage2D(n.TEXTURE_2D,ce,re,ie.width,ie.height,0,pe,O,ie.data)}else if(M.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,re,se.width,se.height,se.depth),$e)if(M.layerUpdates.size>0){let ce=hm(se.width,se.height,M.format,M.type);for(let Be of M.layerUpdates){let nt=se.data.subarray(Be*ce/se.data.BYTES_PER_ELEMENT,(Be+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,se.width,se.height,1,pe,O,nt)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(M.isData3DTexture)_e?(Se&&t.texStorage3D(n.TEXTURE_3D,tt,re,se.width,se.height,se.depth),$e&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,O,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,O,se.data);else if(M.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(n.TEXTURE_2D,tt,re,se.width,se.height);else{let ce=se.width,Be=se.height;for(let nt=0;nt<tt;nt++)t.texImage2D(n.TEXTURE_2D,nt,re,ce,Be,0,pe,O,null),ce>>=1,Be>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),f.add(M),ce.onpaint=Be=>{let nt=Be.changedElements;for(let Ce of f)nt.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let nt=n.RGBA,Ce=n.RGBA,dt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,nt,Ce,dt,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(_e&&Se){let ce=Je(Ae[0]);t.texStorage2D(n.TEXTURE_2D,tt,re,ce.width,ce.height)}for(let ce=0,Be=Ae.length;ce<Be;ce++)ie=Ae[ce],_e?$e&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,O,ie):t.texImage2D(n.TEXTURE_2D,ce,re,pe,O,ie);M.generateMipmaps=!1}else if(_e){if(Se){let ce=Je(se);t.texStorage2D(n.TEXTURE_2D,tt,re,ce.width,ce.height)}$e&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,O,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,O,se);C(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ye.__version=xe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function xn(R,M,q){if(M.image.length!==6)return;let ue=Ne(R,M),oe=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let xe=i.get(oe);if(oe.version!==xe.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let ye=vt.getPrimaries(vt.workingColorSpace),ne=M.colorSpace===lr?null:vt.getPrimaries(M.colorSpace),se=M.colorSpace===lr||ye===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,O=M.image[0]&&M.image[0].isDataTexture,re=[];for(let Ce=0;Ce<6;Ce++)!pe&&!O?re[Ce]=v(M.image[Ce],!0,s.maxCubemapSize):re[Ce]=O?M.image[Ce].image:M.image[Ce],re[Ce]=We(M,re[Ce]);let ie=re[0],Ae=r.convert(M.format,M.colorSpace),_e=r.convert(M.type),Se=T(M.internalFormat,Ae,_e,M.normalized,M.colorSpace),$e=M.isVideoTexture!==!0,tt=xe.__version===void 0||ue===!0,ce=oe.dataReady,Be=E(M,ie);ht(n.TEXTURE_CUBE_MAP,M);let nt;if(M.isDepthTexture){if(Se=y(M.format===ar,M.type),tt)if($e)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ie.width,ie.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,ie.width,ie.height,0,Ae,_e,null)}else if(pe){$e&&tt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,ie.width,ie.height);for(let Ce=0;Ce<6;Ce++){nt=re[Ce].mipmaps;for(let dt=0;dt<nt.length;dt++){let Kt=nt[dt];M.format!==ki?Ae!==null?$e?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt,0,0,Kt.width,Kt.height,Ae,Kt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt,Se,Kt.width,Kt.height,0,Kt.data):Ke("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt,0,0,Kt.width,Kt.height,Ae,_e,Kt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt,Se,Kt.width,Kt.height,0,Ae,_e,Kt.data)}}}else{if(nt=M.mipmaps,$e&&tt){nt.length>0&&Be++;let Ce=Je(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(O){$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,re[Ce].width,re[Ce].height,Ae,_e,re[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,re[Ce].width,re[Ce].height,0,Ae,_e,re[Ce].data);for(let dt=0;dt<nt.length;dt++){let oi=nt[dt].image[Ce].image;$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt+1,0,0,oi.width,oi.height,Ae,_e,oi.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt+1,Se,oi.width,oi.height,0,Ae,_e,oi.data)}}else{$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ae,_e,re[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,Ae,_e,re[Ce]);for(let dt=0;dt<nt.length;dt++){let Kt=nt[dt];$e?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt+1,0,0,Ae,_e,Kt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,dt+1,Se,Ae,_e,Kt.image[Ce])}}}C(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=oe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Xt(R,M,q,ue,oe,xe){let ye=r.convert(q.format,q.colorSpace),ne=r.convert(q.type),se=T(q.internalFormat,ye,ne,q.normalized,q.colorSpace),pe=i.get(M),O=i.get(q);if(O.__renderTarget=M,!pe.__hasExternalTextures){let re=Math.max(1,M.width>>xe),ie=Math.max(1,M.height>>xe);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,xe,se,re,ie,M.depth,0,ye,ne,null):t.texImage2D(oe,xe,se,re,ie,0,ye,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,O.__webglTexture,0,ct(M)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,O.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Fn(R,M,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,xe=y(M.stencilBuffer,oe),ye=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(M),xe,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(M),xe,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,xe,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ye,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let oe=0;oe<ue.length;oe++){let xe=ue[oe],ye=r.convert(xe.format,xe.colorSpace),ne=r.convert(xe.type),se=T(xe.internalFormat,ye,ne,xe.normalized,xe.colorSpace);we(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(M),se,M.width,M.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(M),se,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,se,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(R,M,q){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(M.depthTexture);oe.__renderTarget=M;let xe=ue?M.depthTexture.image[0]:M.depthTexture.image;(!oe.__webglTexture||xe.width!==M.width||xe.height!==M.height)&&(xe.width=M.width,xe.height=M.height,M.depthTexture.needsUpdate=!0),ue?be(M.depthTexture,0):me(M.depthTexture,0);let ye=oe.__webglTexture,ne=ct(M),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=M.depthTexture.format===ar?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===nr)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else if(M.depthTexture.format===ar)we(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ye,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ye,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Cn(R){let M=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let oe=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),M.__depthDisposeCallback=oe}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)bt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?bt(M.__webglFramebuffer[0],R,0):bt(M.__webglFramebuffer,R,0);else if(q){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),Fn(M.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),Fn(M.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function an(R,M,q){let ue=i.get(R);M!==void 0&&Xt(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Cn(R)}function yn(R){let M=R.texture,q=i.get(R),ue=i.get(M);R.addEventListener("dispose",G),V(R);let oe=R.textures,xe=R.isWebGLCubeRenderTarget===!0,ye=oe.length>1;if(ye||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),xe){q.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(M.mipmaps.length>0){q.__webglFramebuffer[ne]=[];for(let se=0;se<M.mipmaps.length;se++)q.__webglFramebuffer[ne][se]=n.createFramebuffer()}else q.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(M.mipmaps.length>0){q.__webglFramebuffer=[];for(let ne=0;ne<M.mipmaps.length;ne++)q.__webglFramebuffer[ne]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(ye)for(let ne=0,se=oe.length;ne<se;ne++){let pe=i.get(oe[ne]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let ne=0;ne<oe.length;ne++){let se=oe[ne];q.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[ne]);let pe=r.convert(se.format,se.colorSpace),O=r.convert(se.type),re=T(se.internalFormat,pe,O,se.normalized,se.colorSpace,R.isXRRenderTarget===!0),ie=ct(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,q.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Fn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),ht(n.TEXTURE_CUBE_MAP,M);for(let ne=0;ne<6;ne++)if(M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Xt(q.__webglFramebuffer[ne][se],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Xt(q.__webglFramebuffer[ne],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);C(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ye){for(let ne=0,se=oe.length;ne<se;ne++){let pe=oe[ne],O=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,O.__webglTexture),ht(re,pe),Xt(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+ne,re,0),C(pe)&&S(re)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ne=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,ue.__webglTexture),ht(ne,M),M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Xt(q.__webglFramebuffer[se],R,M,n.COLOR_ATTACHMENT0,ne,se);else Xt(q.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,ne,0);C(M)?S(ne):M.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Cn(R)}function F(R){let M=R.textures;for(let q=0,ue=M.length;q<ue;q++){let oe=M[q];if(C(oe)&&oe.mipmapsAutoUpdate===!0){let xe=I(R),ye=i.get(oe).__webglTexture;t.bindTexture(xe,ye),S(xe),t.unbindTexture()}}}let Pe=[];function Ze(R){if(R.samples>0){if(we(R)===!1){let M=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,xe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=i.get(R),ne=M.length>1;if(ne)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ye.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,O,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Pe.length=0,Pe.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Pe.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Pe))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ye.__webglColorRenderbuffer[pe]);let O=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ye.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,O,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ye.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function ct(R){return Math.min(s.maxSamples,R.samples)}function we(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function qt(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function We(R,M){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==_l&&q!==lr&&(vt.getTransfer(q)===Ft?(ue!==ki||oe!==Mi)&&Ke("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):st("WebGLTextures: Unsupported texture color space:",q)),M}function Je(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=de,this.resetTextureUnits=$,this.getTextureUnits=ee,this.setTextureUnits=he,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Me,this.setTextureCube=be,this.rebindTextures=an,this.setupRenderTarget=yn,this.updateRenderTargetMipmap=F,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Cn,this.setupFrameBufferTexture=Xt,this.useMultisampledRTT=we,this.dispose=W}function YR(n,e){function t(i,s=lr){let r,o=vt.getTransfer(s);if(i===Mi)return n.UNSIGNED_BYTE;if(i===gh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===_h)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Yp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Jp)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===$p)return n.BYTE;if(i===qp)return n.SHORT;if(i===Ra)return n.UNSIGNED_SHORT;if(i===mh)return n.INT;if(i===us)return n.UNSIGNED_INT;if(i===hs)return n.FLOAT;if(i===ds)return n.HALF_FLOAT;if(i===Kp)return n.ALPHA;if(i===Zp)return n.RGB;if(i===ki)return n.RGBA;if(i===nr)return n.DEPTH_COMPONENT;if(i===ar)return n.DEPTH_STENCIL;if(i===jp)return n.RED;if(i===xh)return n.RED_INTEGER;if(i===Wr)return n.RG;if(i===yh)return n.RG_INTEGER;if(i===vh)return n.RGBA_INTEGER;if(i===Gl||i===Wl||i===Xl||i===$l)if(o===Ft)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===Gl)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Wl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Xl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===$l)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===Gl)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Wl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Xl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===$l)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===bh||i===Sh||i===Mh||i===wh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===bh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Sh)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Mh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===wh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ah||i===Th||i===Eh||i===Ch||i===Rh||i===ql||i===Ph)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ah||i===Th)return o===Ft?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Eh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===Ch)return r.COMPRESSED_R11_EAC;if(i===Rh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===ql)return r.COMPRESSED_RG11_EAC;if(i===Ph)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===Ih||i===Lh||i===Dh||i===Nh||i===Uh||i===Oh||i===Fh||i===kh||i===Bh||i===zh||i===Vh||i===Hh||i===Gh||i===Wh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===Ih)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===Lh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===Dh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===Nh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===Uh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===Oh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===Fh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===kh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===Bh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===zh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Vh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Hh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===Gh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Wh)return o===Ft?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Xh||i===$h||i===qh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Xh)return o===Ft?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===$h)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===qh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Yh||i===Jh||i===Yl||i===Kh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Yh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Jh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Yl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Kh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===go?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var JR=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,KR=`
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

}`,vm=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new Cl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new qi({vertexShader:JR,fragmentShader:KR,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new qn(new Rl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},bm=class extends as{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,b=typeof XRWebGLBinding<"u",m=new vm,_={},v=t.getContextAttributes(),C=null,S=null,I=[],T=[],y=new je,E=null,V=null,U=new mi;U.viewport=new kt;let L=new mi;L.viewport=new kt;let G=[U,L],z=new uh,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let me=I[te];return me===void 0&&(me=new va,I[te]=me),me.getTargetRaySpace()},this.getControllerGrip=function(te){let me=I[te];return me===void 0&&(me=new va,I[te]=me),me.getGripSpace()},this.getHand=function(te){let me=I[te];return me===void 0&&(me=new va,I[te]=me),me.getHandSpace()};function Y(te){let me=T.indexOf(te.inputSource);if(me===-1)return;let ge=I[me];ge!==void 0&&(ge.update(te.inputSource,te.frame,c||o),ge.dispatchEvent({type:te.type,data:te.inputSource}))}function H(){s.removeEventListener("select",Y),s.removeEventListener("selectstart",Y),s.removeEventListener("selectend",Y),s.removeEventListener("squeeze",Y),s.removeEventListener("squeezestart",Y),s.removeEventListener("squeezeend",Y),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",ae);for(let te=0;te<I.length;te++){let me=T[te];me!==null&&(T[te]=null,I[te].disconnect(me))}N=null,W=null,m.reset();for(let te in _)delete _[te];if(e.setRenderTarget(C),d=null,h=null,f=null,s=null,S=null,de.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(y.width,y.height,!1),V!==null){let te=V.camera;te.fov=V.fov,te.zoom=V.zoom,te.updateProjectionMatrix(),V=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){r=te,i.isPresenting===!0&&Ke("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,i.isPresenting===!0&&Ke("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(te){c=te},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&b&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(te){if(s=te,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",Y),s.addEventListener("selectstart",Y),s.addEventListener("selectend",Y),s.addEventListener("squeeze",Y),s.addEventListener("squeezestart",Y),s.addEventListener("squeezeend",Y),s.addEventListener("end",H),s.addEventListener("inputsourceschange",ae),v.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(y),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Me=null,be=null;v.depth&&(be=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=v.stencil?ar:nr,Me=v.stencil?go:us);let Xe={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Xe),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new Oi(h.textureWidth,h.textureHeight,{format:ki,type:Mi,depthTexture:new rr(h.textureWidth,h.textureHeight,Me,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ge={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new Oi(d.framebufferWidth,d.framebufferHeight,{format:ki,type:Mi,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),de.setContext(s),de.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ae(te){for(let me=0;me<te.removed.length;me++){let ge=te.removed[me],Me=T.indexOf(ge);Me>=0&&(T[Me]=null,I[Me].disconnect(ge))}for(let me=0;me<te.added.length;me++){let ge=te.added[me],Me=T.indexOf(ge);if(Me===-1){for(let Xe=0;Xe<I.length;Xe++)if(Xe>=T.length){T.push(ge),Me=Xe;break}else if(T[Xe]===null){T[Xe]=ge,Me=Xe;break}if(Me===-1)break}let be=I[Me];be&&be.connect(ge)}}function K(te,me){me===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(me.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(s===null)return;let me=te.near,ge=te.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(ge=m.depthFar)),z.near=L.near=U.near=me,z.far=L.far=U.far=ge,(N!==z.near||W!==z.far)&&(s.updateRenderState({depthNear:z.near,depthFar:z.far}),N=z.near,W=z.far),z.layers.mask=te.layers.mask|6,U.layers.mask=z.layers.mask&-5,L.layers.mask=z.layers.mask&-3;let Me=te.parent,be=z.cameras;K(z,Me);for(let Xe=0;Xe<be.length;Xe++)K(be[Xe],Me);z.projectionMatrix.copy(U.projectionMatrix),z.projectionMatrixInverse.copy(U.projectionMatrixInverse),V===null&&te.isPerspectiveCamera&&(V={camera:te,fov:te.fov,zoom:te.zoom}),$(te,z,Me)};function $(te,me,ge){ge===null?te.matrix.copy(me.matrixWorld):(te.matrix.copy(ge.matrixWorld),te.matrix.invert(),te.matrix.multiply(me.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(me.projectionMatrix),te.projectionMatrixInverse.copy(me.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=xa*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return z},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(te){l=te,h!==null&&(h.fixedFoveation=te),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=te)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(z)},this.getCameraTexture=function(te){return _[te]};let ee=null;function he(te,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ge=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Me=!1;ge.length!==z.cameras.length&&(z.cameras.length=0,Me=!0);for(let He=0;He<ge.length;He++){let ht=ge[He],Ne=null;if(d!==null)Ne=d.getViewport(ht);else{let Bt=f.getViewSubImage(h,ht);Ne=Bt.viewport,He===0&&(e.setRenderTargetTextures(S,Bt.colorTexture,Bt.depthStencilTexture),e.setRenderTarget(S))}let Ge=G[He];Ge===void 0&&(Ge=new mi,Ge.layers.enable(He),Ge.viewport=new kt,G[He]=Ge),Ge.matrix.fromArray(ht.transform.matrix),Ge.matrix.decompose(Ge.position,Ge.quaternion,Ge.scale),Ge.projectionMatrix.fromArray(ht.projectionMatrix),Ge.projectionMatrixInverse.copy(Ge.projectionMatrix).invert(),Ge.viewport.set(Ne.x,Ne.y,Ne.width,Ne.height),He===0&&(z.matrix.copy(Ge.matrix),z.matrix.decompose(z.position,z.quaternion,z.scale)),Me===!0&&z.cameras.push(Ge)}let be=s.enabledFeatures;if(be&&be.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){f=i.getBinding();let He=f.getDepthInformation(ge[0]);He&&He.isValid&&He.texture&&m.init(He,s.renderState)}if(be&&be.includes("camera-access")&&b){e.state.unbindTexture(),f=i.getBinding();for(let He=0;He<ge.length;He++){let ht=ge[He].camera;if(ht){let Ne=_[ht];Ne||(Ne=new Cl,_[ht]=Ne);let Ge=f.getCameraImage(ht);Ne.sourceTexture=Ge}}}}for(let ge=0;ge<I.length;ge++){let Me=T[ge],be=I[ge];Me!==null&&be!==void 0&&be.update(Me,me,c||o)}ee&&ee(te,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let de=new dv;de.setAnimationLoop(he),this.setAnimationLoop=function(te){ee=te},this.dispose=function(){}}},ZR=new wt,Sv=new ot;Sv.set(-1,0,0,0,1,0,0,0,1);function jR(n,e){function t(m,_){m.matrixAutoUpdate===!0&&m.updateMatrix(),_.value.copy(m.matrix)}function i(m,_){_.color.getRGB(m.fogColor.value,lm(n)),_.isFog?(m.fogNear.value=_.near,m.fogFar.value=_.far):_.isFogExp2&&(m.fogDensity.value=_.density)}function s(m,_,v,C,S){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(m,_):_.isMeshLambertMaterial?(r(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(m,_),f(m,_)):_.isMeshPhongMaterial?(r(m,_),u(m,_),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(m,_),h(m,_),_.isMeshPhysicalMaterial&&d(m,_,S)):_.isMeshMatcapMaterial?(r(m,_),p(m,_)):_.isMeshDepthMaterial?r(m,_):_.isMeshDistanceMaterial?(r(m,_),b(m,_)):_.isMeshNormalMaterial?r(m,_):_.isLineBasicMaterial?(o(m,_),_.isLineDashedMaterial&&a(m,_)):_.isPointsMaterial?l(m,_,v,C):_.isSpriteMaterial?c(m,_):_.isShadowMaterial?(m.color.value.copy(_.color),m.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(m,_){m.opacity.value=_.opacity,_.color&&m.diffuse.value.copy(_.color),_.emissive&&m.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(m.map.value=_.map,t(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.bumpMap&&(m.bumpMap.value=_.bumpMap,t(_.bumpMap,m.bumpMapTransform),m.bumpScale.value=_.bumpScale,_.side===_i&&(m.bumpScale.value*=-1)),_.normalMap&&(m.normalMap.value=_.normalMap,t(_.normalMap,m.normalMapTransform),m.normalScale.value.copy(_.normalScale),_.side===_i&&m.normalScale.value.negate()),_.displacementMap&&(m.displacementMap.value=_.displacementMap,t(_.displacementMap,m.displacementMapTransform),m.displacementScale.value=_.displacementScale,m.displacementBias.value=_.displacementBias),_.emissiveMap&&(m.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,m.emissiveMapTransform)),_.specularMap&&(m.specularMap.value=_.specularMap,t(_.specularMap,m.specularMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest);let v=e.get(_),C=v.envMap,S=v.envMapRotation;C&&(m.envMap.value=C,m.envMapRotation.value.setFromMatrix4(ZR.makeRotationFromEuler(S)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Sv),m.reflectivity.value=_.reflectivity,m.ior.value=_.ior,m.refractionRatio.value=_.refractionRatio),_.lightMap&&(m.lightMap.value=_.lightMap,m.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,m.lightMapTransform)),_.aoMap&&(m.aoMap.value=_.aoMap,m.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,m.aoMapTransform))}function o(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,_.map&&(m.map.value=_.map,t(_.map,m.mapTransform))}function a(m,_){m.dashSize.value=_.dashSize,m.totalSize.value=_.dashSize+_.gapSize,m.scale.value=_.scale}function l(m,_,v,C){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.size.value=_.size*v,m.scale.value=C*.5,_.map&&(m.map.value=_.map,t(_.map,m.uvTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function c(m,_){m.diffuse.value.copy(_.color),m.opacity.value=_.opacity,m.rotation.value=_.rotation,_.map&&(m.map.value=_.map,t(_.map,m.mapTransform)),_.alphaMap&&(m.alphaMap.value=_.alphaMap,t(_.alphaMap,m.alphaMapTransform)),_.alphaTest>0&&(m.alphaTest.value=_.alphaTest)}function u(m,_){m.specular.value.copy(_.specular),m.shininess.value=Math.max(_.shininess,1e-4)}function f(m,_){_.gradientMap&&(m.gradientMap.value=_.gradientMap)}function h(m,_){m.metalness.value=_.metalness,_.metalnessMap&&(m.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,m.metalnessMapTransform)),m.roughness.value=_.roughness,_.roughnessMap&&(m.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,m.roughnessMapTransform)),_.envMap&&(m.envMapIntensity.value=_.envMapIntensity)}function d(m,_,v){m.ior.value=_.ior,_.diffuseRoughness>0&&(m.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),_.sheen>0&&(m.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),m.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(m.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,m.sheenColorMapTransform)),_.sheenRoughnessMap&&(m.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,m.sheenRoughnessMapTransform))),_.clearcoat>0&&(m.clearcoat.value=_.clearcoat,m.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(m.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,m.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(m.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===_i&&m.clearcoatNormalScale.value.negate())),_.dispersion>0&&(m.dispersion.value=_.dispersion),_.retroreflectivity>0&&(m.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(m.iridescence.value=_.iridescence,m.iridescenceIOR.value=_.iridescenceIOR,m.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(m.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,m.iridescenceMapTransform)),_.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),_.transmission>0&&(m.transmission.value=_.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),_.transmissionMap&&(m.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,m.transmissionMapTransform)),m.thickness.value=_.thickness,_.thicknessMap&&(m.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=_.attenuationDistance,m.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(m.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(m.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=_.specularIntensity,m.specularColor.value.copy(_.specularColor),_.specularColorMap&&(m.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,m.specularColorMapTransform)),_.specularIntensityMap&&(m.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,_){_.matcap&&(m.matcap.value=_.matcap)}function b(m,_){let v=e.get(_).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function QR(n,e,t,i){let s={},r={};function o(v,C){let S=C.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,C){let S=s[v.id];S===void 0&&(p(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",m));let I=C.program;i.updateUBOMapping(v,I);let T=e.render.frame;r[v.id]!==T&&(c(v),r[v.id]=T)}function l(v){let C=n.createBuffer(),S=v.__size,I=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,S,I),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(v){let C=s[v.id],S=v.uniforms,I=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let T=0,y=S.length;T<y;T++){let E=S[T];if(Array.isArray(E))for(let V=0,U=E.length;V<U;V++)u(E[V],T,V,I);else u(E,T,0,I)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,C,S,I){if(h(v,C,S,I)===!0){let T=v.__offset,y=v.value;if(Array.isArray(y)){let E=0;for(let V=0;V<y.length;V++){let U=y[V],L=b(U,!0);f(U,v.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(y,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,v.__data)}}function f(v,C,S){typeof v=="number"||typeof v=="boolean"?C[S]=v:v.isMatrix3?(C[S]=v.elements[0],C[S+1]=v.elements[1],C[S+2]=v.elements[2],C[S+3]=0,C[S+4]=v.elements[3],C[S+5]=v.elements[4],C[S+6]=v.elements[5],C[S+7]=0,C[S+8]=v.elements[6],C[S+9]=v.elements[7],C[S+10]=v.elements[8],C[S+11]=0):ArrayBuffer.isView(v)?C.set(v.subarray(0,C.length-S),S):v.toArray(C,S)}function h(v,C,S,I){let T=v.value,y=C+"_"+S;if(Array.isArray(T)){I[y]===void 0&&(I[y]=[]);let E=I[y],V=!1;for(let U=0;U<T.length;U++)d(T[U],E,U)===!0&&(V=!0);return V}return d(T,I,y)}function d(v,C,S){if(C[S]===void 0)return typeof v=="number"||typeof v=="boolean"?C[S]=v:ArrayBuffer.isView(v)?C[S]=v.slice():C[S]=v.clone(),!0;{let I=C[S];if(typeof v=="number"||typeof v=="boolean"){if(I!==v)return C[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(I.equals(v)===!1)return I.copy(v),!0}}return!1}function p(v){let C=v.uniforms,S=0,I=16;for(let y=0,E=C.length;y<E;y++){let V=Array.isArray(C[y])?C[y]:[C[y]];for(let U=0,L=V.length;U<L;U++){let G=V[U],z=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(C[y])||Array.isArray(G.value),W=S;for(let H=0,ae=z.length;H<ae;H++){let K=z[H],$=b(K,N),ee=S%I,he=ee%$.boundary,de=ee+he;S+=he,de!==0&&I-de<$.storage&&(S+=I-de),H===0&&(W=S),S+=$.storage}let Y=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new Y((S-W)/Float32Array.BYTES_PER_ELEMENT),G.__offset=W}}let T=S%I;return T>0&&(S+=I-T),v.__size=S,v.__cache={},this}function b(v,C){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Ke("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Ke("WebGLRenderer: Unsupported uniform value type.",v),C===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let C=v.target;C.removeEventListener("dispose",m),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function _(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:_}}var eP=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Cs=null;function tP(){return Cs===null&&(Cs=new Sa(eP,16,16,Wr,ds),Cs.name="DFG_LUT",Cs.minFilter=gi,Cs.magFilter=gi,Cs.wrapS=Ms,Cs.wrapT=Ms,Cs.generateMipmaps=!1,Cs.needsUpdate=!0),Cs}var nd=class{constructor(e={}){let{canvas:t=ky(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=Mi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let b=d,m=new Set([vh,yh,xh]),_=new Set([Mi,us,Ra,go,gh,_h]),v=new Uint32Array(4),C=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},I=null,T=null,y=[],E=[],V=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=Es,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,L=!1,G=null,z=null,N=null,W=null;this._outputColorSpace=dn;let Y=0,H=0,ae=null,K=-1,$=null,ee=new kt,he=new kt,de=null,te=new lt(0),me=0,ge=t.width,Me=t.height,be=1,Xe=null,rt=null,He=new kt(0,0,ge,Me),ht=new kt(0,0,ge,Me),Ne=!1,Ge=new Or,Bt=new $u,Wt=!1,xn=!1,Xt=new wt,Fn=new k,bt=new kt,Cn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},an=!1;function yn(){return ae===null?be:1}let F=i;function Pe(A,B){return t.getContext(A,B)}let Ze,ct,we,qt,We,Je,R,M,q,ue,oe,xe,ye,ne,se,pe,O,re,ie,Ae,_e,Se,$e;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),F===null){let B="webgl2";if(F=Pe(B,A),F===null)throw Pe(B)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(A){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),st("WebGLRenderer: "+A.message),A}function tt(){Ze=new dC(F),Ze.init(),_e=new YR(F,Ze),ct=new tC(F,Ze,e,_e),we=new $R(F,Ze),ct.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),z=F.createFramebuffer(),N=F.createFramebuffer(),W=F.createFramebuffer(),qt=new mC(F),We=new LR,Je=new qR(F,Ze,we,We,ct,_e,qt),R=new hC(U),M=new _A(F),Se=new QE(F,M),q=new fC(F,M,qt,Se),ue=new _C(F,q,M,Se,qt),re=new gC(F,ct,Je),se=new nC(We),oe=new IR(U,R,Ze,ct,Se,se),xe=new jR(U,We),ye=new NR,ne=new zR(Ze),O=new jE(U,R,we,ue,p,l),pe=new XR(U,ue,ct),$e=new QR(F,qt,ct,we),ie=new eC(F,Ze,qt),Ae=new pC(F,Ze,qt),qt.programs=oe.programs,U.capabilities=ct,U.extensions=Ze,U.properties=We,U.renderLists=ye,U.shadowMap=pe,U.state=we,U.info=qt}b!==Mi&&(V=new yC(b,t.width,t.height,a,s,r));let ce=new bm(U,F);this.xr=ce,this.getContext=function(){return F},this.getContextAttributes=function(){return F.getContextAttributes()},this.forceContextLoss=function(){let A=Ze.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ze.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(A){A!==void 0&&(be=A,this.setSize(ge,Me,!1))},this.getSize=function(A){return A.set(ge,Me)},this.setSize=function(A,B,Q=!0){if(ce.isPresenting){Ke("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=A,Me=B,t.width=Math.floor(A*be),t.height=Math.floor(B*be),Q===!0&&(t.style.width=A+"px",t.style.height=B+"px"),V!==null&&V.setSize(t.width,t.height),this.setViewport(0,0,A,B)},this.getDrawingBufferSize=function(A){return A.set(ge*be,Me*be).floor()},this.setDrawingBufferSize=function(A,B,Q){ge=A,Me=B,be=Q,t.width=Math.floor(A*Q),t.height=Math.floor(B*Q),this.setViewport(0,0,A,B)},this.setEffects=function(A){if(b===Mi){st("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let B=0;B<A.length;B++)if(A[B].isOutputPass===!0){Ke("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}V.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ee)},this.getViewport=function(A){return A.copy(He)},this.setViewport=function(A,B,Q,J){A.isVector4?He.set(A.x,A.y,A.z,A.w):He.set(A,B,Q,J),we.viewport(ee.copy(He).multiplyScalar(yn()).round())},this.getScissor=function(A){return A.copy(ht)},this.setScissor=function(A,B,Q,J){A.isVector4?ht.set(A.x,A.y,A.z,A.w):ht.set(A,B,Q,J),we.scissor(he.copy(ht).multiplyScalar(yn()).round())},this.getScissorTest=function(){return Ne},this.setScissorTest=function(A){we.setScissorTest(Ne=A)},this.setOpaqueSort=function(A){Xe=A},this.setTransparentSort=function(A){rt=A},this.getClearColor=function(A){return A.copy(O.getClearColor())},this.setClearColor=function(){O.setClearColor(...arguments)},this.getClearAlpha=function(){return O.getClearAlpha()},this.setClearAlpha=function(){O.setClearAlpha(...arguments)},this.clear=function(A=!0,B=!0,Q=!0){let J=0;if(A){let Z=!1;if(ae!==null){let Te=ae.texture.format;Z=m.has(Te)}if(Z){let Te=ae.texture.type,Le=_.has(Te),Ee=O.getClearColor(),De=O.getClearAlpha(),Ve=Ee.r,it=Ee.g,mt=Ee.b;Le?(v[0]=Ve,v[1]=it,v[2]=mt,v[3]=De,F.clearBufferuiv(F.COLOR,0,v)):(C[0]=Ve,C[1]=it,C[2]=mt,C[3]=De,F.clearBufferiv(F.COLOR,0,C))}else J|=F.COLOR_BUFFER_BIT}B&&(J|=F.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(J|=F.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&F.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),G=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),O.dispose(),ye.dispose(),ne.dispose(),Je.dispose(),We.dispose(),R.dispose(),ue.dispose(),q.dispose(),Se.dispose(),$e.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",sc),ce.removeEventListener("sessionend",fs),Ls.stop()};function Be(A){A.preventDefault(),vl("WebGLRenderer: Context Lost."),L=!0}function nt(){vl("WebGLRenderer: Context Restored."),L=!1;let A=qt.autoReset,B=pe.enabled,Q=pe.autoUpdate,J=pe.needsUpdate,Z=pe.type;tt(),qt.autoReset=A,pe.enabled=B,pe.autoUpdate=Q,pe.needsUpdate=J,pe.type=Z}function Ce(A){st("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function dt(A){let B=A.target;B.removeEventListener("dispose",dt),Kt(B)}function Kt(A){oi(A),We.remove(A)}function oi(A){let B=We.get(A).programs;B!==void 0&&(B.forEach(function(Q){oe.releaseProgram(Q)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,B,Q,J,Z,Te){B===null&&(B=Cn);let Le=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Ee=Fa(A,B,Q,J,Z);we.setMaterial(J,Le);let De=Q.index,Ve=1;if(J.wireframe===!0){if(De=q.getWireframeAttribute(Q),De===void 0)return;Ve=2}let it=Q.drawRange,mt=Q.attributes.position,ze=it.start*Ve,gt=(it.start+it.count)*Ve;Te!==null&&(ze=Math.max(ze,Te.start*Ve),gt=Math.min(gt,(Te.start+Te.count)*Ve)),De!==null?(ze=Math.max(ze,0),gt=Math.min(gt,De.count)):mt!=null&&(ze=Math.max(ze,0),gt=Math.min(gt,mt.count));let on=gt-ze;if(on<0||on===1/0)return;Se.setup(Z,J,Ee,Q,De);let zt,Vt=ie;if(De!==null&&(zt=M.get(De),Vt=Ae,Vt.setIndex(zt)),Z.isMesh)J.wireframe===!0?(we.setLineWidth(J.wireframeLinewidth*yn()),Vt.setMode(F.LINES)):Vt.setMode(F.TRIANGLES);else if(Z.isLine){let Rn=J.linewidth;Rn===void 0&&(Rn=1),we.setLineWidth(Rn*yn()),Z.isLineSegments?Vt.setMode(F.LINES):Z.isLineLoop?Vt.setMode(F.LINE_LOOP):Vt.setMode(F.LINE_STRIP)}else Z.isPoints?Vt.setMode(F.POINTS):Z.isSprite&&Vt.setMode(F.TRIANGLES);if(Z.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Vt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let Rn=Z._multiDrawStarts,Fe=Z._multiDrawCounts,vn=Z._multiDrawCount,xt=De?M.get(De).bytesPerElement:1,Ns=We.get(J).currentProgram.getUniforms();for(let bn=0;bn<vn;bn++)Ns.setValue(F,"_gl_DrawID",bn),Vt.render(Rn[bn]/xt,Fe[bn])}else if(Z.isInstancedMesh)Vt.renderInstances(ze,on,Z.count);else if(Q.isInstancedBufferGeometry){let Rn=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Fe=Math.min(Q.instanceCount,Rn);Vt.renderInstances(ze,on,Fe)}else Vt.render(ze,on)};function Na(A,B,Q,J){G!==null&&A.isNodeMaterial&&G.setObject(J,A),Wt===!0&&se.setState(A,Q,!1),A.transparent===!0&&A.side===Si&&A.forceSinglePass===!1?(A.side=_i,A.needsUpdate=!0,ps(A,B,J),A.side=Gr,A.needsUpdate=!0,ps(A,B,J),A.side=Si):ps(A,B,J)}this.compile=function(A,B,Q=null){Q===null&&(Q=A),G!==null&&G.renderStart(A,B,Q),T=ne.get(Q),T.init(B),E.push(T),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(B.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),A!==Q&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(B.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),xn=this.localClippingEnabled,Wt=se.init(this.clippingPlanes,xn),Wt===!0&&se.setGlobalState(this.clippingPlanes,B),G!==null&&pe.render(T.state.shadowsArray,Q,B);let J=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Te=Z.material;if(Te)if(Array.isArray(Te))for(let Le=0;Le<Te.length;Le++){let Ee=Te[Le];Na(Ee,Q,B,Z),J.add(Ee)}else Na(Te,Q,B,Z),J.add(Te)}),T=E.pop(),G!==null&&G.renderEnd(),J},this.compileAsync=function(A,B,Q=null){let J=this.compile(A,B,Q);return new Promise(Z=>{function Te(){if(J.forEach(function(Le){let De=We.get(Le).currentProgram;(De===void 0||De.isReady())&&J.delete(Le)}),J.size===0){Z(A);return}setTimeout(Te,10)}Ze.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let bo=null;function Md(A){bo&&bo(A)}function sc(){Ls.stop()}function fs(){Ls.start()}let Ls=new dv;Ls.setAnimationLoop(Md),typeof self<"u"&&Ls.setContext(self),this.setAnimationLoop=function(A){bo=A,ce.setAnimationLoop(A),A===null?Ls.stop():Ls.start()},ce.addEventListener("sessionstart",sc),ce.addEventListener("sessionend",fs),this.render=function(A,B){if(B!==void 0&&B.isCamera!==!0){st("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(A,B);let Q=ce.enabled===!0&&ce.isPresenting===!0,J=V!==null&&(ae===null||Q)&&V.begin(U,ae);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),B.parent===null&&B.matrixWorldAutoUpdate===!0&&B.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(V===null||V.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(B),B=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(U,A,B,ae),T=ne.get(A,E.length),T.init(B),T.state.textureUnits=Je.getTextureUnits(),E.push(T),Xt.multiplyMatrices(B.projectionMatrix,B.matrixWorldInverse),B.isArrayCamera?Bt.setFromArrayCamera(B):Ge.setFromProjectionMatrix(Xt,$i,B.reversedDepth),xn=this.localClippingEnabled,Wt=se.init(this.clippingPlanes,xn),I=ye.get(A,y.length),I.init(),y.push(I),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Le=U.xr.getDepthSensingMesh();Le!==null&&Ds(Le,B,-1/0,U.sortObjects)}Ds(A,B,0,U.sortObjects),I.finish(),G!==null&&G.updateLights(T.state.lightsArray),U.sortObjects===!0&&I.sort(Xe,rt),an=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,an&&O.addToRenderList(I,A),this.info.autoReset===!0&&this.info.reset(),Wt===!0&&se.beginShadows();let Z=T.state.shadowsArray;if(pe.render(Z,A,B),Wt===!0&&se.endShadows(),(J&&V.hasRenderPass())===!1){let Le=I.opaque,Ee=I.transmissive;if(T.setupLights(),B.isArrayCamera){let De=B.cameras;if(Ee.length>0)for(let Ve=0,it=De.length;Ve<it;Ve++){let mt=De[Ve];Yi(Le,Ee,A,mt)}an&&O.render(A);for(let Ve=0,it=De.length;Ve<it;Ve++){let mt=De[Ve];Ua(I,A,mt,mt.viewport)}}else Ee.length>0&&Yi(Le,Ee,A,B),an&&O.render(A),Ua(I,A,B)}ae!==null&&H===0&&(Je.updateMultisampleRenderTarget(ae),Je.updateRenderTargetMipmap(ae)),J&&V.end(U),A.isScene===!0&&A.onAfterRender(U,A,B),Se.resetDefaultState(),K=-1,$=null,E.pop(),E.length>0?(T=E[E.length-1],Je.setTextureUnits(T.state.textureUnits),Wt===!0&&se.setGlobalState(U.clippingPlanes,T.state.camera)):T=null,y.pop(),y.length>0?I=y[y.length-1]:I=null,G!==null&&G.renderEnd()};function Ds(A,B,Q,J){if(A.visible===!1)return;if(A.layers.test(B.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(B);else if(A.isLight)T.pushLight(A),A.castShadow&&T.pushShadow(A);else if(A.isSprite){let Le=B.isArrayCamera?Bt:Ge;if(!A.frustumCulled||A.intersectsFrustum(Le)){J&&bt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Xt);let Ee=ue.update(A),De=A.material;De.visible&&I.push(A,Ee,De,Q,bt.z,null,B)}}else if(A.isMesh||A.isLine||A.isPoints){let Le=B.isArrayCamera?Bt:Ge;if(!A.frustumCulled||A.intersectsFrustum(Le)){let Ee=ue.update(A),De=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),bt.copy(A.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),bt.copy(Ee.boundingSphere.center)),bt.applyMatrix4(A.matrixWorld).applyMatrix4(Xt)),Array.isArray(De)){let Ve=Ee.groups;for(let it=0,mt=Ve.length;it<mt;it++){let ze=Ve[it],gt=De[ze.materialIndex];gt&&gt.visible&&I.push(A,Ee,gt,Q,bt.z,ze,B)}}else De.visible&&I.push(A,Ee,De,Q,bt.z,null,B)}}}let Te=A.children;for(let Le=0,Ee=Te.length;Le<Ee;Le++)Ds(Te[Le],B,Q,J)}function Ua(A,B,Q,J){let{opaque:Z,transmissive:Te,transparent:Le}=A;T.setupLightsView(Q),Wt===!0&&se.setGlobalState(U.clippingPlanes,Q),J&&we.viewport(ee.copy(J)),Z.length>0&&ln(Z,B,Q),Te.length>0&&ln(Te,B,Q),Le.length>0&&ln(Le,B,Q),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function Yi(A,B,Q,J){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[J.id]===void 0){let ze=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[J.id]=new Oi(1,1,{generateMipmaps:!0,type:ze?ds:Mi,minFilter:or,samples:Math.max(4,ct.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Te=T.state.transmissionRenderTarget[J.id],Le=J.viewport||ee;Te.setSize(Le.z*U.transmissionResolutionScale,Le.w*U.transmissionResolutionScale);let Ee=U.getRenderTarget(),De=U.getActiveCubeFace(),Ve=U.getActiveMipmapLevel();U.setRenderTarget(Te),U.getClearColor(te),me=U.getClearAlpha(),me<1&&U.setClearColor(16777215,.5),U.clear(),an&&O.render(Q);let it=U.toneMapping;U.toneMapping=Es;let mt=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),T.setupLightsView(J),Wt===!0&&se.setGlobalState(U.clippingPlanes,J),ln(A,Q,J),Je.updateMultisampleRenderTarget(Te),Je.updateRenderTargetMipmap(Te),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let gt=0,on=B.length;gt<on;gt++){let zt=B[gt],{object:Vt,geometry:Rn,material:Fe,group:vn}=zt;if(Fe.side===Si&&Vt.layers.test(J.layers)){let xt=Fe.side;Fe.side=_i,Fe.needsUpdate=!0,fn(Vt,Q,J,Rn,Fe,vn),Fe.side=xt,Fe.needsUpdate=!0,ze=!0}}ze===!0&&(Je.updateMultisampleRenderTarget(Te),Je.updateRenderTargetMipmap(Te))}U.setRenderTarget(Ee,De,Ve),U.setClearColor(te,me),mt!==void 0&&(J.viewport=mt),U.toneMapping=it}function ln(A,B,Q){let J=B.isScene===!0?B.overrideMaterial:null;for(let Z=0,Te=A.length;Z<Te;Z++){let Le=A[Z],{object:Ee,geometry:De,group:Ve}=Le,it=Le.material;it.allowOverride===!0&&J!==null&&(it=J),Ee.layers.test(Q.layers)&&fn(Ee,B,Q,De,it,Ve)}}function fn(A,B,Q,J,Z,Te){G!==null&&Z.isNodeMaterial&&G.setObject(A,Z),A.onBeforeRender(U,B,Q,J,Z,Te),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(U,B,Q,J,A,Te),Z.transparent===!0&&Z.side===Si&&Z.forceSinglePass===!1?(Z.side=_i,Z.needsUpdate=!0,U.renderBufferDirect(Q,B,J,Z,A,Te),Z.side=Gr,Z.needsUpdate=!0,U.renderBufferDirect(Q,B,J,Z,A,Te),Z.side=Si):U.renderBufferDirect(Q,B,J,Z,A,Te),A.onAfterRender(U,B,Q,J,Z,Te)}function pn(A){let B=0;for(let Q of A)Q.texture!==null&&B++;return B}function ps(A,B,Q){B.isScene!==!0&&(B=Cn);let J=We.get(A),Z=T.state.lights,Te=T.state.shadowsArray,Le=Z.state.version,Ee=oe.getParameters(A,Z.state,Te,B,Q,T.state.lightProbeGridArray),De=oe.getProgramCacheKey(Ee),Ve=J.programs;J.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?B.environment:null,J.fog=B.fog;let it=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;J.envMap=R.get(A.envMap||J.environment,it),J.envMapRotation=J.environment!==null&&A.envMap===null?B.environmentRotation:A.envMapRotation,Ve===void 0&&(A.addEventListener("dispose",dt),Ve=new Map,J.programs=Ve,J.programVariants=new Map);let mt=Ve.get(De);if(mt!==void 0){if(J.currentProgram===mt&&J.lightsStateVersion===Le)return Oa(A,Ee),mt}else Ee.uniforms=oe.getUniforms(A),G!==null&&A.isNodeMaterial&&G.build(A,Q,Ee),A.onBeforeCompile(Ee,U),mt=oe.acquireProgram(Ee,De),Ve.set(De,mt),J.uniforms=Ee.uniforms;let ze=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(ze.clippingPlanes=se.uniform),Oa(A,Ee),J.needsLights=hr(A),J.lightsStateVersion=Le,J.needsLights&&(ze.ambientLightColor.value=Z.state.ambient,ze.lightProbe.value=Z.state.probe,ze.sunLights.value=Z.state.sun,ze.sunLightShadows.value=Z.state.sunShadow,ze.directionalLights.value=Z.state.directional,ze.directionalLightShadows.value=Z.state.directionalShadow,ze.spotLights.value=Z.state.spot,ze.spotLightShadows.value=Z.state.spotShadow,ze.rectAreaLights.value=Z.state.rectArea,ze.ltc_1.value=Z.state.rectAreaLTC1,ze.ltc_2.value=Z.state.rectAreaLTC2,ze.pointLights.value=Z.state.point,ze.pointLightShadows.value=Z.state.pointShadow,ze.hemisphereLights.value=Z.state.hemi,ze.sunShadowMatrix.value=Z.state.sunShadowMatrix,ze.sunShadowCascade.value=Z.state.sunShadowCascade,ze.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,ze.spotLightMatrix.value=Z.state.spotLightMatrix,ze.spotLightMap.value=Z.state.spotLightMap,ze.pointShadowMatrix.value=Z.state.pointShadowMatrix),J.numLightProbeGrids=pn(T.state.lightProbeGridArray),J.currentProgram=mt,J.uniformsList=null,mt}function Ai(A,B,Q,J,Z){let Te=We.get(A),Le=Te.currentProgram.id+","+J+","+Z,Ee=Te.programVariants.get(Le);return Ee===void 0?(Ee=ps(A,B,Q),Te.programVariants.set(Le,Ee)):(Te.currentProgram=Ee,Te.uniformsList=null,Te.outputColorSpace=J,Te.toneMapping=Z),Ee}function ur(A){if(A.uniformsList===null){let B=A.currentProgram.getUniforms();A.uniformsList=Pa.seqWithValue(B.seq,A.uniforms)}return A.uniformsList}function Oa(A,B){let Q=We.get(A);Q.outputColorSpace=B.outputColorSpace,Q.batching=B.batching,Q.batchingColor=B.batchingColor,Q.instancing=B.instancing,Q.instancingColor=B.instancingColor,Q.instancingMorph=B.instancingMorph,Q.skinning=B.skinning,Q.morphTargets=B.morphTargets,Q.morphNormals=B.morphNormals,Q.morphColors=B.morphColors,Q.morphTargetsCount=B.morphTargetsCount,Q.numClippingPlanes=B.numClippingPlanes,Q.numIntersection=B.numClipIntersection,Q.vertexAlphas=B.vertexAlphas,Q.vertexTangents=B.vertexTangents,Q.toneMapping=B.toneMapping}function Fa(A,B,Q,J,Z){B.isScene!==!0&&(B=Cn),Je.resetTextureUnits();let Te=B.fog,Le=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?B.environment:null,Ee=ae===null?U.outputColorSpace:ae.isXRRenderTarget===!0?ae.texture.colorSpace:vt.workingColorSpace,De=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,Ve=R.get(J.envMap||Le,De),it=J.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,mt=!!Q.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),ze=!!Q.morphAttributes.position,gt=!!Q.morphAttributes.normal,on=!!Q.morphAttributes.color,zt=Es;J.toneMapped&&(ae===null||ae.isXRRenderTarget===!0)&&(zt=U.toneMapping);let Vt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,Rn=Vt!==void 0?Vt.length:0,Fe=We.get(J),vn=T.state.lights;if(Wt===!0&&(xn===!0||A!==$)){let Ht=A===$&&J.id===K;se.setState(J,A,Ht)}let xt=!1,Ns=!1;J.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==vn.state.version||Z.isBatchedMesh&&Fe.batching===!1||!Z.isBatchedMesh&&Fe.batching===!0||Z.isBatchedMesh&&Fe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Fe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Fe.instancing===!1||!Z.isInstancedMesh&&Fe.instancing===!0||Z.isSkinnedMesh&&Fe.skinning===!1||!Z.isSkinnedMesh&&Fe.skinning===!0||Z.isInstancedMesh&&Fe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Fe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Fe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Fe.instancingMorph===!1&&Z.morphTexture!==null||Fe.envMap!==Ve||J.fog===!0&&Fe.fog!==Te||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==it||Fe.vertexTangents!==mt||Fe.morphTargets!==ze||Fe.morphNormals!==gt||Fe.morphColors!==on||Fe.morphTargetsCount!==Rn||Fe.numLightProbeGrids!==pn(T.state.lightProbeGridArray)?xt=!0:(Fe.outputColorSpace!==Ee||Fe.toneMapping!==zt)&&(Ns=!0):(xt=!0,Fe.__version=J.version);let bn=Fe.currentProgram;(xt===!0||Ns===!0)&&(bn=Ns===!0?Ai(J,B,Z,Ee,zt):ps(J,B,Z),G&&J.isNodeMaterial&&G.onUpdateProgram(J,bn,Fe));let wo=!1,ms=!1,Us=!1,ft=bn.getUniforms(),cn=Fe.uniforms;if(we.useProgram(bn.program)&&(wo=!0,ms=!0,Us=!0),J.id!==K&&(K=J.id,ms=!0),wo||$!==A){we.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ft.setValue(F,"projectionMatrix",A.projectionMatrix),ft.setValue(F,"viewMatrix",A.matrixWorldInverse);let Sn=ft.map.cameraPosition;Sn!==void 0&&Sn.setValue(F,Fn.setFromMatrixPosition(A.matrixWorld)),ct.logarithmicDepthBuffer&&ft.setValue(F,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&ft.setValue(F,"isOrthographic",A.isOrthographicCamera===!0),$!==A&&($=A,ms=!0,Us=!0)}if(Fe.needsLights&&(vn.state.sunShadowMap.length>0&&ft.setValue(F,"sunShadowMap",vn.state.sunShadowMap,Je),vn.state.directionalShadowMap.length>0&&ft.setValue(F,"directionalShadowMap",vn.state.directionalShadowMap,Je),vn.state.spotShadowMap.length>0&&ft.setValue(F,"spotShadowMap",vn.state.spotShadowMap,Je),vn.state.pointShadowMap.length>0&&ft.setValue(F,"pointShadowMap",vn.state.pointShadowMap,Je)),Z.isSkinnedMesh){ft.setOptional(F,Z,"bindMatrix"),ft.setOptional(F,Z,"bindMatrixInverse");let Ht=Z.skeleton;Ht&&(Ht.boneTexture===null&&Ht.computeBoneTexture(),ft.setValue(F,"boneTexture",Ht.boneTexture,Je))}Z.isBatchedMesh&&(ft.setOptional(F,Z,"batchingTexture"),ft.setValue(F,"batchingTexture",Z._matricesTexture,Je),ft.setOptional(F,Z,"batchingIdTexture"),ft.setValue(F,"batchingIdTexture",Z._indirectTexture,Je),ft.setOptional(F,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ft.setValue(F,"batchingColorTexture",Z._colorsTexture,Je));let ai=Q.morphAttributes;if((ai.position!==void 0||ai.normal!==void 0||ai.color!==void 0)&&re.update(Z,Q,bn),(ms||Fe.receiveShadow!==Z.receiveShadow)&&(Fe.receiveShadow=Z.receiveShadow,ft.setValue(F,"receiveShadow",Z.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&B.environment!==null&&(cn.envMapIntensity.value=B.environmentIntensity),cn.dfgLUT!==void 0&&(cn.dfgLUT.value=tP()),ms){if(ft.setValue(F,"toneMappingExposure",U.toneMappingExposure),Fe.needsLights&&So(cn,Us),Te&&J.fog===!0&&xe.refreshFogUniforms(cn,Te),xe.refreshMaterialUniforms(cn,J,be,Me,T.state.transmissionRenderTarget[A.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Ht=S,Sn=0;for(let ei of T.state.lightProbeGridArray)ei.texture!==null&&(Ht.textures[Sn]=ei.texture,Ht.min[Sn]=ei.boundingBox.min,Ht.max[Sn]=ei.boundingBox.max,Ht.resolution[Sn]=ei.resolution,Sn++);for(let ei in Ht)Ht[ei].length=Sn;cn.probesSH.value=Ht.textures,cn.probesMin.value=Ht.min,cn.probesMax.value=Ht.max,cn.probesResolution.value=Ht.resolution}Pa.upload(F,ur(Fe),cn,Je)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&(Pa.upload(F,ur(Fe),cn,Je),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&ft.setValue(F,"center",Z.center),ft.setValue(F,"modelViewMatrix",Z.modelViewMatrix),ft.setValue(F,"normalMatrix",Z.normalMatrix),ft.setValue(F,"modelMatrix",Z.matrixWorld),J.uniformsGroups!==void 0){let Ht=J.uniformsGroups;for(let Sn=0,ei=Ht.length;Sn<ei;Sn++){let rc=Ht[Sn];$e.update(rc,bn),$e.bind(rc,bn)}}return bn}function So(A,B){A.ambientLightColor.needsUpdate=B,A.lightProbe.needsUpdate=B,A.sunLights.needsUpdate=B,A.sunLightShadows.needsUpdate=B,A.directionalLights.needsUpdate=B,A.directionalLightShadows.needsUpdate=B,A.pointLights.needsUpdate=B,A.pointLightShadows.needsUpdate=B,A.spotLights.needsUpdate=B,A.spotLightShadows.needsUpdate=B,A.rectAreaLights.needsUpdate=B,A.hemisphereLights.needsUpdate=B}function hr(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return Y},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return ae},this.setRenderTargetTextures=function(A,B,Q){let J=We.get(A);J.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),We.get(A.texture).__webglTexture=B,We.get(A.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:Q,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,B){let Q=We.get(A);Q.__webglFramebuffer=B,Q.__useDefaultFramebuffer=B===void 0},this.setRenderTarget=function(A,B=0,Q=0){ae=A,Y=B,H=Q;let J=null,Z=!1,Te=!1;if(A){let Ee=We.get(A);if(Ee.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(F.FRAMEBUFFER,Ee.__webglFramebuffer),ee.copy(A.viewport),he.copy(A.scissor),de=A.scissorTest,we.viewport(ee),we.scissor(he),we.setScissorTest(de),K=-1;return}else if(Ee.__webglFramebuffer===void 0)Je.setupRenderTarget(A);else if(Ee.__hasExternalTextures)Je.rebindTextures(A,We.get(A.texture).__webglTexture,We.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let it=A.depthTexture;if(Ee.__boundDepthTexture!==it){if(it!==null&&We.has(it)&&(A.width!==it.image.width||A.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Je.setupDepthRenderbuffer(A)}}let De=A.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Te=!0);let Ve=We.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Ve[B])?J=Ve[B][Q]:J=Ve[B],Z=!0):A.samples>0&&Je.useMultisampledRTT(A)===!1?J=We.get(A).__webglMultisampledFramebuffer:Array.isArray(Ve)?J=Ve[Q]:J=Ve,ee.copy(A.viewport),he.copy(A.scissor),de=A.scissorTest}else ee.copy(He).multiplyScalar(be).floor(),he.copy(ht).multiplyScalar(be).floor(),de=Ne;if(Q!==0&&(J=z),we.bindFramebuffer(F.FRAMEBUFFER,J)&&we.drawBuffers(A,J),we.viewport(ee),we.scissor(he),we.setScissorTest(de),Z){let Ee=We.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_CUBE_MAP_POSITIVE_X+B,Ee.__webglTexture,Q)}else if(Te){let Ee=B;for(let De=0;De<A.textures.length;De++){let Ve=We.get(A.textures[De]);F.framebufferTextureLayer(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0+De,Ve.__webglTexture,Q,Ee)}}else if(A!==null&&Q!==0){let Ee=We.get(A.texture);F.framebufferTexture2D(F.FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,Ee.__webglTexture,Q)}K=-1};function Mo(A){let B=We.get(A);return(B.__readFormat!==A.format||B.__readType!==A.type)&&(B.__readFormat=A.format,B.__readType=A.type,B.__formatReadable=ct.textureFormatReadable(A.format),B.__typeReadable=ct.textureTypeReadable(A.type)),B}this.readRenderTargetPixels=function(A,B,Q,J,Z,Te,Le,Ee=0){if(!(A&&A.isWebGLRenderTarget)){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De){we.bindFramebuffer(F.FRAMEBUFFER,De);try{let Ve=A.textures[Ee],it=Ve.format,mt=Ve.type;A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ee);let ze=Mo(Ve);if(ze.__formatReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}B>=0&&B<=A.width-J&&Q>=0&&Q<=A.height-Z&&F.readPixels(B,Q,J,Z,_e.convert(it),_e.convert(mt),Te)}finally{let Ve=ae!==null?We.get(ae).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(A,B,Q,J,Z,Te,Le,Ee=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=We.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Le!==void 0&&(De=De[Le],Array.isArray(De)&&(De=De[0])),De)if(B>=0&&B<=A.width-J&&Q>=0&&Q<=A.height-Z){we.bindFramebuffer(F.FRAMEBUFFER,De);let Ve=A.textures[Ee],it=Ve.format,mt=Ve.type;A.textures.length>1&&F.readBuffer(F.COLOR_ATTACHMENT0+Ee);let ze=Mo(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=F.createBuffer();F.bindBuffer(F.PIXEL_PACK_BUFFER,gt),F.bufferData(F.PIXEL_PACK_BUFFER,Te.byteLength,F.STREAM_READ),F.readPixels(B,Q,J,Z,_e.convert(it),_e.convert(mt),0),F.bindBuffer(F.PIXEL_PACK_BUFFER,null);let on=ae!==null?We.get(ae).__webglFramebuffer:null;we.bindFramebuffer(F.FRAMEBUFFER,on);let zt=F.fenceSync(F.SYNC_GPU_COMMANDS_COMPLETE,0);return F.flush(),await zy(F,zt,4),F.bindBuffer(F.PIXEL_PACK_BUFFER,gt),F.getBufferSubData(F.PIXEL_PACK_BUFFER,0,Te),F.bindBuffer(F.PIXEL_PACK_BUFFER,null),F.deleteBuffer(gt),F.deleteSync(zt),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,B=null,Q=0){let J=Math.pow(2,-Q),Z=Math.floor(A.image.width*J),Te=Math.floor(A.image.height*J),Le=B!==null?B.x:0,Ee=B!==null?B.y:0;Je.setTexture2D(A,0),F.copyTexSubImage2D(F.TEXTURE_2D,Q,0,0,Le,Ee,Z,Te),we.unbindTexture()},this.copyTextureToTexture=function(A,B,Q=null,J=null,Z=0,Te=0){let Le,Ee,De,Ve,it,mt,ze,gt,on,zt=A.isCompressedTexture?A.mipmaps[Te]:A.image;if(Q!==null)Le=Q.max.x-Q.min.x,Ee=Q.max.y-Q.min.y,De=Q.isBox3?Q.max.z-Q.min.z:1,Ve=Q.min.x,it=Q.min.y,mt=Q.isBox3?Q.min.z:0;else{let ft=Math.pow(2,-Z);Le=Math.floor(zt.width*ft),Ee=Math.floor(zt.height*ft),A.isDataArrayTexture?De=zt.depth:A.isData3DTexture?De=Math.floor(zt.depth*ft):De=1,Ve=0,it=0,mt=0}J!==null?(ze=J.x,gt=J.y,on=J.z):(ze=0,gt=0,on=0);let Vt=_e.convert(B.format),Rn=_e.convert(B.type),Fe;B.isData3DTexture?(Je.setTexture3D(B,0),Fe=F.TEXTURE_3D):B.isDataArrayTexture||B.isCompressedArrayTexture?(Je.setTexture2DArray(B,0),Fe=F.TEXTURE_2D_ARRAY):(Je.setTexture2D(B,0),Fe=F.TEXTURE_2D),we.activeTexture(F.TEXTURE0),we.pixelStorei(F.UNPACK_FLIP_Y_WEBGL,B.flipY),we.pixelStorei(F.UNPACK_PREMULTIPLY_ALPHA_WEBGL,B.premultiplyAlpha),we.pixelStorei(F.UNPACK_ALIGNMENT,B.unpackAlignment);let vn=we.getParameter(F.UNPACK_ROW_LENGTH),xt=we.getParameter(F.UNPACK_IMAGE_HEIGHT),Ns=we.getParameter(F.UNPACK_SKIP_PIXELS),bn=we.getParameter(F.UNPACK_SKIP_ROWS),wo=we.getParameter(F.UNPACK_SKIP_IMAGES);we.pixelStorei(F.UNPACK_ROW_LENGTH,zt.width),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,zt.height),we.pixelStorei(F.UNPACK_SKIP_PIXELS,Ve),we.pixelStorei(F.UNPACK_SKIP_ROWS,it),we.pixelStorei(F.UNPACK_SKIP_IMAGES,mt);let ms=A.isDataArrayTexture||A.isData3DTexture,Us=B.isDataArrayTexture||B.isData3DTexture;if(A.isDepthTexture){let ft=We.get(A),cn=We.get(B),ai=We.get(ft.__renderTarget),Ht=We.get(cn.__renderTarget);we.bindFramebuffer(F.READ_FRAMEBUFFER,ai.__webglFramebuffer),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,Ht.__webglFramebuffer);for(let Sn=0;Sn<De;Sn++)ms&&(F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,We.get(A).__webglTexture,Z,mt+Sn),F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,We.get(B).__webglTexture,Te,on+Sn)),F.blitFramebuffer(Ve,it,Ve+Le,it+Ee,ze,gt,ze+Le,gt+Ee,F.DEPTH_BUFFER_BIT,F.NEAREST);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||We.has(A)){let ft=We.get(A),cn=We.get(B);we.bindFramebuffer(F.READ_FRAMEBUFFER,N),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,W);for(let ai=0;ai<De;ai++)ms?F.framebufferTextureLayer(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,ft.__webglTexture,Z,mt+ai):F.framebufferTexture2D(F.READ_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,ft.__webglTexture,Z),Us?F.framebufferTextureLayer(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,cn.__webglTexture,Te,on+ai):F.framebufferTexture2D(F.DRAW_FRAMEBUFFER,F.COLOR_ATTACHMENT0,F.TEXTURE_2D,cn.__webglTexture,Te),Z!==0?F.blitFramebuffer(Ve,it,Ve+Le,it+Ee,ze,gt,ze+Le,gt+Ee,F.COLOR_BUFFER_BIT,F.NEAREST):Us?F.copyTexSubImage3D(Fe,Te,ze,gt,on+ai,Ve,it,Le,Ee):F.copyTexSubImage2D(Fe,Te,ze,gt,Ve,it,Le,Ee);we.bindFramebuffer(F.READ_FRAMEBUFFER,null),we.bindFramebuffer(F.DRAW_FRAMEBUFFER,null)}else Us?A.isDataTexture||A.isData3DTexture?F.texSubImage3D(Fe,Te,ze,gt,on,Le,Ee,De,Vt,Rn,zt.data):B.isCompressedArrayTexture?F.compressedTexSubImage3D(Fe,Te,ze,gt,on,Le,Ee,De,Vt,zt.data):F.texSubImage3D(Fe,Te,ze,gt,on,Le,Ee,De,Vt,Rn,zt):A.isDataTexture?F.texSubImage2D(F.TEXTURE_2D,Te,ze,gt,Le,Ee,Vt,Rn,zt.data):A.isCompressedTexture?F.compressedTexSubImage2D(F.TEXTURE_2D,Te,ze,gt,zt.width,zt.height,Vt,zt.data):F.texSubImage2D(F.TEXTURE_2D,Te,ze,gt,Le,Ee,Vt,Rn,zt);we.pixelStorei(F.UNPACK_ROW_LENGTH,vn),we.pixelStorei(F.UNPACK_IMAGE_HEIGHT,xt),we.pixelStorei(F.UNPACK_SKIP_PIXELS,Ns),we.pixelStorei(F.UNPACK_SKIP_ROWS,bn),we.pixelStorei(F.UNPACK_SKIP_IMAGES,wo),Te===0&&B.generateMipmaps===!0&&B.mipmapsAutoUpdate===!0&&F.generateMipmap(Fe),we.unbindTexture()},this.initRenderTarget=function(A){We.get(A).__webglFramebuffer===void 0&&Je.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Je.setTextureCube(A,0):A.isData3DTexture?Je.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Je.setTexture2DArray(A,0):Je.setTexture2D(A,0),we.unbindTexture()},this.resetState=function(){Y=0,H=0,ae=null,we.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return $i}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var Mv={enters:[16,132,74],leaves:[190,44,132],grazes:[232,188,38]};function wv(n){let[e,t,i]=Mv[n];return`rgb(${e} ${t} ${i})`}function Sm(n){return new rn().setAttribute("position",new sn(new Float32Array(n),3))}var rd=class{constructor(e){this.bundle=e;for(let t of Mx){let[i,s,r]=Mv[t].map(a=>a/255),o=new lt().setRGB(i,s,r,dn);this.dots.set(t,new Ts({color:o,size:6,sizeAttenuation:!1}))}}bundle;group=new Gn;points=[];lines=[0,0];hitting=new cs({color:2844356,transparent:!0,opacity:.75});missing=new cs({color:9081242,transparent:!0,opacity:.2});dots=new Map;get materials(){return[this.hitting,this.missing,...this.dots.values()]}add(e,t){e.frustumCulled=!1,e.renderOrder=t,this.group.add(e)}clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){this.clear();let s=Array.from({length:this.bundle.triangles.length/3},(l,c)=>su(this.bundle,c)),r=l=>s[l].flatMap(c=>i(c)),o=new Set(t.map(l=>e.lineOf(l))),a=s.flatMap((l,c)=>o.has(c)?[]:[c]);this.lines=[s.length,o.size],this.add(new As(Sm(a.flatMap(r)),this.missing),3),this.add(new As(Sm([...o].flatMap(r)),this.hitting),4),this.points=t.map(l=>({hit:l,at:i(Ax(s[e.lineOf(l)],e.depthOf(l)))}));for(let[l,c]of this.dots){let u=this.points.filter(({hit:f})=>e.kindOf(f)===l);this.add(new sr(Sm(u.flatMap(({at:f})=>f)),c),5)}}clip(e){for(let t of this.materials)t.clippingPlanes=e}dispose(){this.clear(),this.materials.forEach(e=>e.dispose())}};function nP(n,e,t,i){let{hits:s}=t,r=e.parts[0],o=!t.isCut&&n.first_hits!==!0,a=su(e.meshes[1],i);return s?wx(s,i,c=>r.partOf(c),c=>o&&e.closed?.[c]===1&&(Kn(n)||Tx(a,e.meshes[0],r,c))):[]}function Av(n){let{line:e,job:t,model:i,contacts:s}=n,r=e<i.meshes[1].triangles.length/3,o=St(()=>r?nP(t,i,s,e):[],[e,i,s]),{hits:a}=s,l=(a?.ofLine(e)??[]).filter(h=>a?.kindOf(h)==="grazes"),c=h=>i.parts[0].nameOf(a?.triangleOf(h)??0),u=h=>a&&h!==null?Et(a.depthOf(h),6):"",f=({in:h,out:d})=>a&&d!==null?Et(a.depthOf(d)-a.depthOf(h),6):"";return g("section",{"aria-label":"picked line","aria-live":"polite",children:[g("h2",{children:["line ",Re(e)," ",g("button",{type:"button",class:"link",onClick:n.drop,children:"drop"})]}),!r&&g("p",{children:["the bundle has no line ",Re(e)]}),r&&o.length+l.length===0&&g("p",{children:"it hits nothing"}),o.length>0&&g("table",{class:"line-hits",children:[g("caption",{class:"note",children:["from the line's start, in ",t.unit]}),g("thead",{children:g("tr",{children:[g("th",{scope:"col",children:"part"}),g("th",{scope:"col",children:"in"}),g("th",{scope:"col",children:"out"}),g("th",{scope:"col",children:"thickness"})]})}),g("tbody",{children:o.map(h=>g("tr",{children:[g("td",{children:g(Mt,{text:c(h.in)})}),g("td",{children:u(h.in)}),g("td",{children:u(h.out)}),g("td",{children:f(h)})]},h.in))})]}),l.map(h=>g("p",{class:"note",children:["grazes ",g(Mt,{text:c(h)})," at ",u(h)]},h))]})}function Tv(){return g("ul",{class:"legend plain",children:[[["enters","the line enters"],["leaves","the line leaves"],["grazes","the line only grazes the surface"]].map(([e,t])=>g("li",{children:[g("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:g("rect",{x:3,y:2,width:8,height:8,fill:wv(e)})}),t]},e)),g("li",{class:"note",children:"faint lines hit nothing; a click on a hit picks its line"})]})}var iP=[0,67,68,77,69,83,72,49],Mm=29;async function sP(n,e){if(!globalThis.crypto?.subtle)return null;let t=new Uint8Array(await crypto.subtle.digest("SHA-256",n));return Array.from(t,i=>i.toString(16).padStart(2,"0")).join("")===e}function rP(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i+=3)for(let s=0;s<3;++s){let r=n[i+s];e[s]=r<e[s]?r:e[s],t[s]=r>t[s]?r:t[s]}return n.length===0?[[0,0,0],[0,0,0]]:[e,t]}function oP(n,e,t){let i=new DataView(n);if(n.byteLength<Mm||iP.some((p,b)=>i.getUint8(b)!==p))throw new Error("the server's mesh is not in canonical form");let s=i.getUint8(8)===1,r=Number(i.getBigUint64(9,!0)),o=Number(i.getBigUint64(17,!0)),a=Mm+r*3*(s?8:4),l=a+o*12;if(l>n.byteLength)throw new Error("the server's mesh is cut short");let c=n.slice(Mm,a),u=s?new Float64Array(c):new Float32Array(c),f=new Uint32Array(n.slice(a,l)),[h,d]=rP(u);return{sha256:e,checked:t,bytes:n.byteLength,vertices:u,triangles:f,min:h,max:d,centre:[0,1,2].map(p=>(h[p]+d[p])/2)}}async function wm(n,e){let t=await Ig(`meshes/${n}`,e),i=await sP(t,n);try{return oP(t,n,i)}catch(s){throw i===!1?new Error(`not the tested geometry: ${ti(s)}`):s}}function Ev(n){let{vertices:e,triangles:t,centre:i}=n,[s,r,o]=i,a=new Float32Array(3*t.length);for(let l=0;l<t.length;++l){let c=3*t[l];a[3*l]=e[c]-s,a[3*l+1]=e[c+1]-r,a[3*l+2]=e[c+2]-o}return a}var tc=8e6,od=null;async function aP(n){let e=performance.now(),[t,i]=n.bodies.map(l=>l.sha256),s=wm(t),r=Promise.all([Jo(n.job,0),Jo(n.job,1)]),o=await Promise.all([s,t===i?s:wm(i)]),a=Nt(n)?await ox(n.job,0):null;return{meshes:o,parts:await r,closed:a,milliseconds:performance.now()-e}}function Cv(n){let e=[n.job,...n.bodies.map(t=>t.sha256)].join(" ");if(od?.key!==e){let t=aP(n);od={key:e,model:t},t.catch(()=>{od=null})}return od.model}async function Rv(n,e){try{let i=(await Promise.all([0,1].map(r=>An(`jobs/${encodeURIComponent(n.job)}/map/${r}`)))).map((r,o)=>_x(r.values,e.meshes[o].triangles.length/3)),s=i.reduce((r,o)=>o.reduce((a,l)=>Math.max(a,l),r),0);return{counts:i,most:s}}catch(t){if(t instanceof Vi&&t.status===404)return null;throw t}}var ad=class{constructor(e,t,i,s){this.job=e;this.hasLines=t;this.show=i;this.fail=s}job;hasLines;show;fail;wanted=null;isLoading=!1;stop=new AbortController;want(e){this.wanted=e,this.isLoading||this.run()}close(){this.wanted=null,this.stop.abort()}async run(){for(this.isLoading=!0;this.wanted!==null;){let e=this.wanted;try{let t=await this.load(e);this.wanted=this.wanted===e?null:this.wanted,this.show(t)}catch(t){if(Fs(t)||this.stop.signal.aborted)break;t instanceof Vi&&t.isBusy?await _c():(this.wanted=this.wanted===e?null:this.wanted,this.fail(e,t))}}this.isLoading=!1}async load(e){let t=`jobs/${encodeURIComponent(this.job)}/scenarios/${e}`,i=this.stop.signal,s=await Ri(t,i);if(s.class===null||s.exact_pairs===0){let l=new Uint32Array,c=this.hasLines?new al(l,new Float64Array):null;return{scenario:s,pairs:l,points:new Float64Array,hits:c,isCut:!1}}let r=await An(`${t}/pairs`,i),o=r.values;if(this.hasLines){let l=await An(`${t}/hits`,i),c=new al(o,l.values);return{scenario:s,pairs:o,points:new Float64Array,hits:c,isCut:r.cut}}let a=await An(`${t}/points`,i);return{scenario:s,pairs:o,points:a.values,hits:null,isCut:r.cut||a.cut}}};Ie.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new je},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};xi.line={uniforms:Kl.merge([Ie.common,Ie.fog,Ie.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var cr=class extends qi{constructor(e){super({type:"LineMaterial",uniforms:Kl.clone(xi.line.uniforms),vertexShader:xi.line.vertexShader,fragmentShader:xi.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Pv=new si,ld=new k,$r=class extends kl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Wn(e,3)),this.setAttribute("uv",new Wn(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new zr(t,6,1);return this.setAttribute("instanceStart",new ls(i,3,0)),this.setAttribute("instanceEnd",new ls(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new zr(t,6,1);return this.setAttribute("instanceColorStart",new ls(i,3,0)),this.setAttribute("instanceColorEnd",new ls(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new Pl(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new si);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Pv.setFromBufferAttribute(t),this.boundingBox.union(Pv))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new $n),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)ld.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(ld)),ld.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(ld));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Am=new kt,Iv=new k,Lv=new k,Zn=new kt,jn=new kt,Rs=new kt,Tm=new k,Em=new wt,Qn=new Bl,Dv=new k,cd=new si,ud=new $n,Ps=new kt,Is,xo;function Nv(n,e,t){return Ps.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),Ps.multiplyScalar(1/Ps.w),Ps.x=xo/t.width,Ps.y=xo/t.height,Ps.applyMatrix4(n.projectionMatrixInverse),Ps.multiplyScalar(1/Ps.w),Math.abs(Math.max(Ps.x,Ps.y))}function lP(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Qn.start.fromBufferAttribute(s,a),Qn.end.fromBufferAttribute(r,a),Qn.applyMatrix4(t);let c=new k,u=new k;Is.distanceSqToSegment(Qn.start,Qn.end,u,c),u.distanceTo(c)<xo*.5&&e.push({point:u,pointOnLine:c,distance:Is.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function cP(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),f=-e.near;Is.at(1,Rs),Rs.w=1,Rs.applyMatrix4(e.matrixWorldInverse),Rs.applyMatrix4(i),Rs.multiplyScalar(1/Rs.w),Rs.x*=r.x/2,Rs.y*=r.y/2,Rs.z=0,Tm.copy(Rs),Em.multiplyMatrices(e.matrixWorldInverse,o);for(let h=0,d=u;h<d;h++){if(Zn.fromBufferAttribute(l,h),jn.fromBufferAttribute(c,h),Zn.w=1,jn.w=1,Zn.applyMatrix4(Em),jn.applyMatrix4(Em),Zn.z>f&&jn.z>f)continue;if(Zn.z>f){let C=Zn.z-jn.z,S=(Zn.z-f)/C;Zn.lerp(jn,S)}else if(jn.z>f){let C=jn.z-Zn.z,S=(jn.z-f)/C;jn.lerp(Zn,S)}Zn.applyMatrix4(i),jn.applyMatrix4(i),Zn.multiplyScalar(1/Zn.w),jn.multiplyScalar(1/jn.w),Zn.x*=r.x/2,Zn.y*=r.y/2,jn.x*=r.x/2,jn.y*=r.y/2,Qn.start.copy(Zn),Qn.start.z=0,Qn.end.copy(jn),Qn.end.z=0;let b=Qn.closestPointToPointParameter(Tm,!0);Qn.at(b,Dv);let m=Jl.lerp(Zn.z,jn.z,b),_=m>=-1&&m<=1,v=Tm.distanceTo(Dv)<xo*.5;if(_&&v){Qn.start.fromBufferAttribute(l,h),Qn.end.fromBufferAttribute(c,h),Qn.start.applyMatrix4(o),Qn.end.applyMatrix4(o);let C=new k,S=new k;Is.distanceSqToSegment(Qn.start,Qn.end,S,C),t.push({point:S,pointOnLine:C,distance:Is.origin.distanceTo(S),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var La=class extends qn{constructor(e=new $r,t=new cr({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Iv.fromBufferAttribute(t,o),Lv.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Iv.distanceTo(Lv);let r=new zr(s,2,1);return e.setAttribute("instanceDistanceStart",new ls(r,1,0)),e.setAttribute("instanceDistanceEnd",new ls(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Is=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;xo=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),ud.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=xo*.5;else{let f=Math.max(s.near,ud.distanceToPoint(Is.origin));c=Nv(s,f,l.resolution)}if(ud.radius+=c,Is.intersectsSphere(ud)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),cd.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=xo*.5;else{let f=Math.max(s.near,cd.distanceToPoint(Is.origin));u=Nv(s,f,l.resolution)}cd.expandByScalar(u),Is.intersectsBox(cd)!==!1&&(i?lP(this,t):cP(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Am),this.material.uniforms.resolution.value.set(Am.z,Am.w))}};var uP=["free","open","event","unknown"],hd=class{group=new Gn;points=[];lines=new Map;dot=new Ts({size:10,sizeAttenuation:!1});constructor(){for(let e of uP)this.lines.set(e,new cr({linewidth:3}))}clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){this.clear();let s=o=>o.map((a,l)=>a-t[l]),r=e.map(({points:o,kind:a})=>({points:o.map(s),kind:a}));this.points=r.flatMap(({points:o})=>o);for(let[o,a]of this.lines)a.color=Uv(o,i);this.dot.color=Uv("event",i),r.forEach(o=>this.add(o))}add({points:e,kind:t}){let i=this.lines.get(t);if(e.length===1||!i){let r=new sn(new Float32Array(e.flat()),3);this.place(new sr(new rn().setAttribute("position",r),this.dot),5);return}let s=e.slice(1).flatMap((r,o)=>[...e[o],...r]);this.place(new La(new $r().setPositions(new Float32Array(s)),i),4)}place(e,t){e.frustumCulled=!1,e.renderOrder=t,this.group.add(e)}clip(e){for(let t of[...this.lines.values(),this.dot])t.clippingPlanes=e}dispose(){this.clear(),[...this.lines.values(),this.dot].forEach(e=>e.dispose())}};function Uv(n,e){let[t,i,s]=Kf(n,e).map(r=>r/255);return new lt().setRGB(t,i,s,dn)}var hP=.28;function yo(n){let e=new Il({flatShading:!0,side:Si});return e.color.setRGB(n[0]/255,n[1]/255,n[2]/255,dn),e}function dP(n,e,t){n.onBeforeCompile=i=>{i.uniforms.heatTable={value:e},i.uniforms.showsHeat=t,i.vertexShader=i.vertexShader.replace("#include <common>",`#include <common>
attribute float heat;
varying float vHeat;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vHeat = heat;`),i.fragmentShader=i.fragmentShader.replace("#include <common>",`#include <common>
uniform sampler2D heatTable;
uniform bool showsHeat;
varying float vHeat;`).replace("#include <color_fragment>",`#include <color_fragment>
                if (showsHeat) {
                    float at = (floor(vHeat * 255.0 + 0.5) + 0.5) / 256.0;
                    diffuseColor.rgb = texture2D(heatTable, vec2(at, 0.5)).rgb;
                }`)}}var nc=class{constructor(e,t){this.mesh=e;this.corners=Ev(e),this.radius=Math.hypot(...e.max.map((o,a)=>o-e.min[a]))/2,this.geometry.setAttribute("position",new sn(this.corners,3)),this.setHeat(new Uint8Array(this.corners.length/3)),this.geometry.boundingSphere=new $n(new k,this.radius),this.table=new Sa(gx(t),256,1,ki),this.table.colorSpace=dn,this.table.minFilter=_n,this.table.magFilter=_n,this.table.needsUpdate=!0;let i=yo(t),s=yo(t),r=yo(t);for(let o of[i,s,r])o.polygonOffset=!0,o.polygonOffsetFactor=1,o.polygonOffsetUnits=1,dP(o,this.table,this.showsHeat);s.colorWrite=!1,r.polygonOffset=!1,r.transparent=!0,r.opacity=hP,r.depthWrite=!1,r.depthFunc=Nr,this.materials=[i,s,r],this.solid=this.make(i,0),this.ghost.add(this.make(s,1),this.make(r,2))}mesh;corners;solid;ghost=new Gn;radius;geometry=new rn;materials;showsHeat={value:!1};table;make(e,t){let i=new qn(this.geometry,e);return i.matrixAutoUpdate=!1,i.renderOrder=t,i}get triangles(){return this.corners.length/9}setHeat(e){this.geometry.setAttribute("heat",new sn(e,1,!0))}showHeat(e){this.showsHeat.value=e}showAs(e){this.solid.visible=e==="solid",this.ghost.visible=e==="ghost"}clip(e){for(let t of this.materials)t.clippingPlanes=e}place(e,t){let i=qs(e,this.mesh.centre),s=new wt().set(e[0],e[1],e[2],i[0]-t[0],e[4],e[5],e[6],i[1]-t[1],e[8],e[9],e[10],i[2]-t[2],0,0,0,1);for(let r of[this.solid,...this.ghost.children])r.matrix.copy(s),r.matrixWorldNeedsUpdate=!0;return s}boxCorners(e){let t=this.mesh.max.map((s,r)=>s-this.mesh.centre[r]),i=[-1,1];return i.flatMap(s=>i.flatMap(r=>i.map(o=>new k(s*t[0],r*t[1],o*t[2]).applyMatrix4(e).toArray())))}dispose(){this.geometry.dispose(),this.table.dispose(),this.materials.forEach(e=>e.dispose())}};var Cm=3,vo=4;function Ov(n){return n===vo?0:n}function Fv(n,e){let t=[new Map,new Map];for(let i=0;i+2<n.length;i+=3)e(n[i],n[i+1])&&t.forEach((s,r)=>{let o=n[i+r],a=s.get(o);(a===void 0||Ov(n[i+2])>Ov(a))&&s.set(o,n[i+2])});return t}var fP=["near","touch","proper"];function pP(n){return n===Cm?"proper":n===vo?"near":"touch"}function mP(n,e){return[...n].flatMap(([t,i])=>pP(i)===e?[t]:[])}function gP(n,e){let t=new Float32Array(9*e.length);return e.forEach((i,s)=>t.set(n.subarray(9*i,9*i+9),9*s)),t}function Rm(n){let e=new Float32Array(2*n.length);for(let t=0;t<n.length;t+=9){let[i,s,r]=[0,3,6].map(o=>n.subarray(t+o,t+o+3));[i,s,s,r,r,i].forEach((o,a)=>e.set(o,2*t+3*a))}return e}function _P(n,e,t){let i={segments:[],points:[],gaps:[]};for(let s=0;s<n.length;){let r=n[s],o=s,a=[];for(;o<n.length&&n[o]===r;o+=4)a.push(e([n[o+1],n[o+2],n[o+3]]));s=o;let l=t(r);if(l===null)continue;if(l===vo){i.gaps.push(...a.flat());continue}a.length===1&&i.points.push(...a[0]);let c=a.length>2?a.length:a.length-1;for(let u=0;u<c;++u)i.segments.push(...a[u],...a[(u+1)%a.length])}return i}var dd=class{group=new Gn;lines=new Gn;red;yellow;orange;outline=new cs({color:5915904});segment=new cr({color:0,linewidth:2.5});gap=new cr({color:11030016,linewidth:3.5});dot=new Ts({color:0,size:7,sizeAttenuation:!1});constructor(){this.red=yo(vi(2)),this.yellow=yo(vi(1)),this.orange=yo(vi(7)),this.red.emissive.copy(this.red.color).multiplyScalar(.45),this.yellow.emissive.copy(this.yellow.color).multiplyScalar(.35),this.orange.emissive.copy(this.orange.color).multiplyScalar(.35),this.group.add(this.lines)}get materials(){return[this.red,this.yellow,this.orange,this.outline,this.segment,this.gap,this.dot]}clear(){for(let e of[...this.group.children,...this.lines.children])e!==this.lines&&(e.geometry.dispose(),e.removeFromParent())}addBody(e,t,i){let s={near:this.orange,touch:this.yellow,proper:this.red};for(let r of fP){let o=gP(e,mP(t,r));if(o.length===0)continue;let a=new rn().setAttribute("position",new sn(o,3));if(this.addPlaced(new qn(a,s[r]),i),r!=="proper"){let l=new rn().setAttribute("position",new sn(Rm(o),3));this.addPlaced(new As(l,this.outline),i)}}}addPlaced(e,t){e.matrixAutoUpdate=!1,e.matrix.copy(t),e.frustumCulled=!1,this.group.add(e)}show(e,t,i){this.clear(),e.forEach((s,r)=>this.addBody(s,t[r],i[r]))}addLines(e,t){if(e.length===0)return;let i=new $r().setPositions(new Float32Array(e)),s=new La(i,t);s.frustumCulled=!1,s.renderOrder=4,this.lines.add(s)}addPoints(e,t,i,s){let o=_P(e,a=>qs(t,a).map((l,c)=>l-i[c]),s);if(this.addLines(o.segments,this.segment),this.addLines(o.gaps,this.gap),o.points.length>0){let a=new sn(new Float32Array(o.points),3),l=new sr(new rn().setAttribute("position",a),this.dot);l.frustumCulled=!1,l.renderOrder=5,this.lines.add(l)}return o.gaps.length/6}clip(e){for(let t of this.materials)t.clippingPlanes=e}dispose(){this.clear(),this.materials.forEach(e=>e.dispose())}};function kv(n,{origin:[e,t,i],direction:[s,r,o]},a){let l=null,c=1/0;for(let u=0;u<n.length;u+=9){let f=n[u],h=n[u+1],d=n[u+2],p=n[u+3]-f,b=n[u+4]-h,m=n[u+5]-d,_=n[u+6]-f,v=n[u+7]-h,C=n[u+8]-d,S=r*C-o*v,I=o*_-s*C,T=s*v-r*_,y=p*S+b*I+m*T;if(y===0)continue;let E=e-f,V=t-h,U=i-d,L=(E*S+V*I+U*T)/y;if(!(L>=0&&L<=1))continue;let G=V*m-U*b,z=U*p-E*m,N=E*b-V*p,W=(s*G+r*z+o*N)/y;if(!(W>=0&&L+W<=1))continue;let Y=(_*G+v*z+C*N)/y;Y>0&&Y<c&&!a(Y)&&(c=Y,l={triangle:u/9,distance:Y})}return l}var fd=class{group=new Gn;face=new ba({color:2068479,side:Si,transparent:!0,opacity:.55});edge=new cs({color:675742});clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){if(this.clear(),!e||!t||9*t.triangle>=e.length)return;let s=e.slice(9*t.triangle,9*t.triangle+9),r=a=>new rn().setAttribute("position",new sn(a,3)),o=[new qn(r(s),this.face),new As(r(Rm(s)),this.edge)];for(let a of o)a.matrixAutoUpdate=!1,a.matrix.copy(i[t.body]),a.frustumCulled=!1,this.group.add(a)}dispose(){this.clear(),this.face.dispose(),this.edge.dispose()}};var Bv={type:"change"},Im={type:"start"},Vv={type:"end"},pd=new Ur,zv=new pi,xP=Math.cos(70*Jl.DEG2RAD),On=new k,wi=2*Math.PI,Ut={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Pm=1e-6,md=class extends zl{constructor(e,t=null){super(e,t),this.state=Ut.NONE,this.target=new k,this.cursor=new k,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Vr.ROTATE,MIDDLE:Vr.DOLLY,RIGHT:Vr.PAN},this.touches={ONE:Hr.ROTATE,TWO:Hr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new k,this._lastQuaternion=new Ui,this._lastTargetPosition=new k,this._quat=new Ui().setFromUnitVectors(e.up,new k(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new Aa,this._sphericalDelta=new Aa,this._scale=1,this._panOffset=new k,this._rotateStart=new je,this._rotateEnd=new je,this._rotateDelta=new je,this._panStart=new je,this._panEnd=new je,this._panDelta=new je,this._dollyStart=new je,this._dollyEnd=new je,this._dollyDelta=new je,this._dollyDirection=new k,this._mouse=new je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=vP.bind(this),this._onPointerDown=yP.bind(this),this._onPointerUp=bP.bind(this),this._onContextMenu=CP.bind(this),this._onMouseWheel=wP.bind(this),this._onKeyDown=AP.bind(this),this._onTouchStart=TP.bind(this),this._onTouchMove=EP.bind(this),this._onMouseDown=SP.bind(this),this._onMouseMove=MP.bind(this),this._interceptControlDown=RP.bind(this),this._interceptControlUp=PP.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ut.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Bv),this.update(),this.state=Ut.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;On.copy(t).sub(this.target),On.applyQuaternion(this._quat),this._spherical.setFromVector3(On),this.autoRotate&&this.state===Ut.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=wi:i>Math.PI&&(i-=wi),s<-Math.PI?s+=wi:s>Math.PI&&(s-=wi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(On.setFromSpherical(this._spherical),On.applyQuaternion(this._quatInverse),t.copy(this.target).add(On),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=On.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new k(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new k(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=On.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(pd.origin.copy(this.object.position),pd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(pd.direction))<xP?this.object.lookAt(this.target):(zv.setFromNormalAndCoplanarPoint(this.object.up,this.target),pd.intersectPlane(zv,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Pm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Pm||this._lastTargetPosition.distanceToSquared(this.target)>Pm?(this.dispatchEvent(Bv),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?wi/60*this.autoRotateSpeed*e:wi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){On.setFromMatrixColumn(t,0),On.multiplyScalar(-e),this._panOffset.add(On)}_panUp(e,t){this.screenSpacePanning===!0?On.setFromMatrixColumn(t,1):(On.setFromMatrixColumn(t,0),On.crossVectors(this.object.up,On)),On.multiplyScalar(e),this._panOffset.add(On)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;On.copy(s).sub(this.target);let r=On.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(wi*this._rotateDelta.x/t.clientHeight),this._rotateUp(wi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-wi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(wi*this._rotateDelta.x/t.clientHeight),this._rotateUp(wi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function yP(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function vP(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function bP(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(Vv),this.state=Ut.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function SP(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Vr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ut.DOLLY;break;case Vr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}break;case Vr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ut.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ut.PAN}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(Im)}function MP(n){switch(this.state){case Ut.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ut.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ut.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function wP(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ut.NONE||(n.preventDefault(),this.dispatchEvent(Im),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(Vv))}function AP(n){this.enabled!==!1&&this._handleKeyDown(n)}function TP(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Hr.ROTATE:if(this.enableRotate===!1){this.state=Ut.NONE;break}this._handleTouchStartRotate(n),this.state=Ut.TOUCH_ROTATE;break;case Hr.PAN:if(this.enablePan===!1){this.state=Ut.NONE;break}this._handleTouchStartPan(n),this.state=Ut.TOUCH_PAN;break;default:this.state=Ut.NONE}break;case 2:switch(this.touches.TWO){case Hr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ut.TOUCH_DOLLY_PAN;break;case Hr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ut.TOUCH_DOLLY_ROTATE;break;default:this.state=Ut.NONE}break;default:this.state=Ut.NONE}this.state!==Ut.NONE&&this.dispatchEvent(Im)}function EP(n){switch(this._trackPointer(n),this.state){case Ut.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ut.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ut.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ut.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ut.NONE}}function CP(n){this.enabled!==!1&&n.preventDefault()}function RP(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function PP(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var IP=1.08,Hv=new k(.75,-1,.6).normalize();function LP(){let n=new Ml;return n.add(new Nl(16777215,10133670,1.9)),n}var gd=class{constructor(e,t,i){this.canvas=e;this.moved=t;this.drawn=i;this.renderer=new nd({canvas:e,antialias:!0}),this.renderer.outputColorSpace=dn,this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.camera.up.set(0,0,1),this.controls=new md(this.camera,e),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.addEventListener("change",this.change),e.addEventListener("webglcontextrestored",this.draw),this.watcher=new ResizeObserver(()=>this.resize()),this.watcher.observe(e),this.resize()}canvas;moved;drawn;frames=0;renderer;camera=new mi(35,1,.01,1e3);controls;lamp=new Fl(16777215,2.3);layers=[];watcher;isWaiting=!1;isPlacing=!1;radius=1;change=()=>{this.draw(),this.isPlacing||this.moved()};draw=()=>{this.isWaiting||(this.isWaiting=!0,requestAnimationFrame(()=>{this.isWaiting=!1,this.render(),this.drawn()}))};resize(){let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];e>0&&t>0&&(this.renderer.setPixelRatio(Math.min(2,devicePixelRatio)),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.draw())}setBackground(e){this.renderer.setClearColor(new lt(e)),this.draw()}setLayers(e){this.layers=e.map(({objects:t,forgetsDepth:i})=>{let s=LP();return s.add(...t),{scene:s,forgetsDepth:i}}),this.draw()}render(){let e=this.camera.position.distanceTo(this.controls.target),t=this.camera.position.length()+this.radius;this.camera.near=Math.max(e/500,(t-2*this.radius)/2,t/1e5),this.camera.near=Math.min(this.camera.near,e/2),this.camera.far=2*t,this.camera.updateProjectionMatrix(),this.lamp.position.copy(this.camera.position),this.lamp.target.position.copy(this.controls.target),this.renderer.clear();for(let{scene:i,forgetsDepth:s}of this.layers)s&&this.renderer.clearDepth(),i.add(this.lamp,this.lamp.target),this.renderer.render(i,this.camera);this.frames+=1}fit(e,t,i){let s=new k(...e),r=i?Hv.clone():this.camera.position.clone().sub(this.controls.target).normalize(),o=new k().crossVectors(this.camera.up,r).normalize(),a=new k().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360),c=l*this.camera.aspect,u=1e-9;for(let f of t){let h=new k(...f).sub(s),d=Math.max(Math.abs(h.dot(o))/c,Math.abs(h.dot(a))/l);u=Math.max(u,d+h.dot(r))}this.look(s.clone().addScaledVector(r,IP*u),s)}get isAtStart(){return this.camera.position.clone().sub(this.controls.target).normalize().distanceTo(Hv)<1e-6}look(e,t){this.isPlacing=!0,this.controls.target.copy(t),this.camera.position.copy(e),this.controls.update(),this.isPlacing=!1,this.draw()}turn(e,t){let i=this.controls.target,s=this.camera.position.clone().sub(i),r=s.length(),o=Math.atan2(s.y,s.x)+e,a=Math.min(Math.PI-.01,Math.max(.01,Math.acos(s.z/r)-t)),l=r*Math.sin(a);s.set(l*Math.cos(o),l*Math.sin(o),r*Math.cos(a)),this.look(s.add(i),i.clone()),this.moved()}approach(e){let t=this.controls.target,i=this.camera.position.clone().sub(t).multiplyScalar(e);this.look(i.add(t),t.clone()),this.moved()}move(e,t){let i=this.controls.target,s=this.camera.position.distanceTo(i);this.camera.updateMatrix();let r=new k().addScaledVector(new k().setFromMatrixColumn(this.camera.matrix,0),e*s).addScaledVector(new k().setFromMatrixColumn(this.camera.matrix,1),t*s);this.look(this.camera.position.clone().add(r),i.clone().add(r)),this.moved()}setRadius(e){this.radius=e}get view(){return[...this.camera.position.toArray(),...this.controls.target.toArray()]}set view(e){this.look(new k().fromArray(e,0),new k().fromArray(e,3))}rayAt(e,t){let i=new je(2*e/this.canvas.clientWidth-1,1-2*t/this.canvas.clientHeight),s=this.camera;s.updateMatrixWorld();let o=new k(i.x,i.y,.5).unproject(s).sub(this.camera.position).normalize();return{origin:this.camera.position.toArray(),direction:o.toArray()}}pixelOf(e){this.camera.updateMatrixWorld();let t=new k(...e).project(this.camera);return[(t.x+1)/2*this.canvas.clientWidth,(1-t.y)/2*this.canvas.clientHeight]}picture(){return this.render(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}async save(e){let t=await this.picture();if(t){let i=document.createElement("a");i.href=URL.createObjectURL(t),i.download=`${e}.png`.replaceAll(/[^\w.-]+/g,"_"),i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e3)}}dispose(){this.watcher.disconnect(),this.controls.dispose(),this.canvas.removeEventListener("webglcontextrestored",this.draw),this.renderer.dispose(),this.renderer.forceContextLoss()}};function Gv(n,e){let t=new k(n==="x"?-1:0,n==="y"?-1:0,n==="z"?-1:0);return new pi(t,e)}var Lm={mode:"contacts",ghost:"b",throughWalls:!0,lines:!0,clip:null,camera:null,partA:"",partB:"",pick:null,seek:"contact",onlyFirst:!1,tau:null};function DP(n,e){let t=(n??"").split(",").map(Number);return t.length===e&&t.every(Number.isFinite)&&n?t:null}function NP(n){let e=/^([xyz]):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(n??"");return e&&Number.isFinite(Number(e[2]))?{axis:e[1],at:Number(e[2])}:null}function UP(n){let e=/^([ab]):(\d+)$/.exec(n??"");return e?{body:e[1]==="a"?0:1,triangle:Number(e[2])}:null}function OP(n){let e=Number(n);return n&&e>=0&&e<=1?e:null}function Dm(n,e){let t=["",""];for(let i of[n.get("part"),n.get("with")])if(i){let{body:s,part:r}=C_(i,{...e,hasA:o=>t[0]===""&&e.hasA(o)});t[s]=r}return t}function Xv(n,e){return Object.entries(n).every(([t,i])=>t==="camera"||i===e[t])}function Nm(n,e){let t=n.get("ghost"),i=n.get("seek"),[s,r]=Dm(n,e);return{mode:n.get("mode")==="heat"?"heat":"contacts",ghost:t==="a"||t==="none"?t:"b",throughWalls:n.get("walls")!=="0",lines:n.get("lines")!=="0",clip:NP(n.get("clip")),camera:DP(n.get("cam"),6),partA:s,partB:r,pick:UP(n.get("pick")),seek:i==="near"||i==="either"?i:"contact",onlyFirst:n.get("first")==="1",tau:OP(n.get("tau"))}}function Wv(n){return String(Number(n.toPrecision(6)))}function $v(n,e){let t={};return n.mode!==Lm.mode&&(t.mode=n.mode),n.camera&&(t.cam=n.camera.map(Wv).join(",")),n.ghost!==Lm.ghost&&(t.ghost=n.ghost),n.throughWalls||(t.walls="0"),n.lines||(t.lines="0"),n.partA&&(t.part=Wo(0,n.partA,e)),n.partB&&(t[n.partA?"with":"part"]=Wo(1,n.partB,e)),n.clip&&(t.clip=`${n.clip.axis}:${Wv(n.clip.at)}`),n.pick&&(t.pick=`${n.pick.body===0?"a":"b"}:${n.pick.triangle}`),n.seek!==Lm.seek&&(t.seek=n.seek),n.onlyFirst&&(t.first="1"),n.tau!==null&&(t.tau=String(n.tau)),t}var FP=[186,190,196],kP=[100,138,186],BP=8,zP=[1,0,0,0,0,1,0,0,0,0,1,0],_d=class{constructor(e,{meshes:t,parts:i,closed:s},r,o){this.canvas=e;this.stage=new gd(e,r,o),this.parts=i,this.bodies=[new nc(t[0],FP),new nc(t[1],kP)],this.origin=t[0].centre,this.shotsView=s?new rd(t[1]):null,this.refreshTheme()}canvas;stage;bodies;gaps=0;contactsView=new dd;shotsView;pathView=new hd;mark=new fd;origin;parts;matrices=[new wt,new wt];highlights=[new Map,new Map];contacts=null;state=null;fitted=null;freshAt=-1;refreshTheme(){this.stage.setBackground(Zi("--stage",this.canvas))}show(e,t){this.contacts=e,this.placeBodies(e,t),this.showPath(e),this.stage.setRadius(this.reachOfB()+this.bodies[1].radius+this.bodies[0].radius),this.refreshContacts(t),this.state=t,this.applyState(t),!t.camera&&!this.isInView()&&this.fit(this.fitted===null)}placeBodies({scenario:e},t){this.matrices=[this.bodies[0].place(zP,this.origin),this.bodies[1].place(eu(e,t.tau),this.origin)]}showPath({scenario:e}){let t=e.motion?lx(e.motion):[];this.pathView.show(t,this.origin,Qo(e))}reachOfB(){let e=Math.hypot(...this.bodies[1].mesh.centre),t=this.pathView.points.map(i=>Math.hypot(...i)+e);return Math.max(this.centreOfB().length(),...t)}centreOfB(){return new k().setFromMatrixPosition(this.matrices[1])}isShown(e,t,i){return this.parts[0].isOf(t,e.partA)&&this.parts[1].isOf(i,e.partB)}refreshContacts(e){if(!this.contacts)return;let{pairs:t,points:i,scenario:s}=this.contacts;if(this.contacts.hits&&this.shotsView){this.refreshHits(this.contacts,this.contacts.hits,this.shotsView,e);return}let r=ax(s,e.tau),o=(l,c)=>r&&this.isShown(e,l,c);this.highlights=Fv(t,o);let a=[this.bodies[0].corners,this.bodies[1].corners];this.contactsView.show(a,this.highlights,this.matrices),this.gaps=this.contactsView.addPoints(i,Ar(s.pose_a),this.origin,l=>o(t[3*l],t[3*l+1])?t[3*l+2]:null)}refreshHits({scenario:e},t,i,s){let r=t.shown(s.onlyFirst).filter(a=>this.isShown(s,t.triangleOf(a),t.lineOf(a)));this.highlights=[new Map(r.map(a=>[t.triangleOf(a),Cm])),new Map];let o=qc(e);i.show(t,r,a=>qs(o,a).map((l,c)=>l-this.origin[c]))}setState(e){let t=this.state;this.state=e,!(t&&Xv(t,e))&&(t&&t.tau!==e.tau&&this.contacts&&(this.placeBodies(this.contacts,e),this.refreshContacts(e)),t&&(t.partA!==e.partA||t.partB!==e.partB||t.onlyFirst!==e.onlyFirst)&&this.refreshContacts(e),this.applyState(e))}applyState(e){let[t,i]=this.bodies;t.showAs(e.ghost==="a"?"ghost":"solid"),i.showAs(e.ghost==="b"?"ghost":"solid"),this.bodies.forEach(o=>o.showHeat(e.mode==="heat"));let s=e.clip?"xyz".indexOf(e.clip.axis):0,r=e.clip?[Gv(e.clip.axis,e.clip.at-this.origin[s])]:[];this.bodies.forEach(o=>o.clip(r)),this.contactsView.clip(r),this.contactsView.group.visible=e.mode==="contacts",this.contactsView.lines.visible=e.lines,this.pathView.clip(r),this.pathView.group.visible=e.lines,this.shotsView&&(this.shotsView.clip(r),this.shotsView.group.visible=e.mode==="contacts"&&e.lines),this.mark.show(e.pick&&this.bodies[e.pick.body].corners,e.pick,this.matrices),this.arrange(e)}isShowing(e){return this.state===e}arrange(e){let[t,i]=this.bodies,s={objects:[t.solid,i.solid],forgetsDepth:!1},r={objects:[this.contactsView.group,this.pathView.group,...this.shotsView?[this.shotsView.group]:[]],forgetsDepth:e.throughWalls},o={objects:[t.ghost,i.ghost],forgetsDepth:!1},a={objects:[this.mark.group],forgetsDepth:!0};this.stage.setLayers(e.throughWalls?[s,o,r,a]:[s,r,o,a])}setHeat(e,t){e.forEach((i,s)=>this.bodies[s].setHeat(xx(i,t))),this.stage.draw()}ballAround(){let e=new $n(new k,this.bodies[0].radius);return this.pathView.points.forEach(t=>e.expandByPoint(new k(...t))),this.shotsView?e:e.union(new $n(this.centreOfB(),this.bodies[1].radius))}isInView(){let e=this.ballAround(),t=this.fitted;return t!==null&&t.center.distanceTo(e.center)+e.radius<=t.radius*1.001}fit(e){this.fitted=this.ballAround();let i=[...(this.shotsView?this.bodies.slice(0,1):this.bodies).flatMap((r,o)=>r.boxCorners(this.matrices[o])),...this.pathView.points],s=new si().setFromPoints(i.map(r=>new k(...r)));this.stage.fit(s.getCenter(new k).toArray(),i,e),this.freshAt=this.stage.isAtStart?this.contacts?.scenario.index??-1:-1}goToContact(){let e=this.bodies[0].corners,t=new k;for(let l of this.highlights[0].keys())t.add(this.middleOf(e,l));let i=this.highlights[0].size;if(i===0){this.fit(!1);return}t.divideScalar(i);let s=0;for(let l of this.highlights[0].keys())s=Math.max(s,this.middleOf(e,l).distanceTo(t));let r=Math.min(this.bodies[0].radius,this.bodies[1].radius)/12,o=new $n(t,Math.max(s,r)).getBoundingBox(new si),a=[o.min,o.max].flatMap(({x:l,z:c})=>[o.min,o.max].map(({y:u})=>[l,u,c]));this.stage.fit(t.toArray(),a,!1)}middleOf(e,t){let[i,s,r]=[0,3,6].map(o=>new k().fromArray(e,9*t+o));return i.add(s).add(r).divideScalar(3)}get view(){return this.stage.view.map((e,t)=>e+this.origin[t%3])}get ownView(){return this.contacts?.scenario.index===this.freshAt?null:this.view}set view(e){this.stage.view=e.map((t,i)=>t-this.origin[i%3])}pickMiddle(e){return this.pickAt(this.canvas.clientWidth/2,this.canvas.clientHeight/2,e)}pickAt(e,t,i){let s=this.lineAt(e,t);if(s!==null)return{body:1,triangle:s};let r=this.stage.rayAt(e,t),o=[0,1].filter(c=>this.bodies[c].ghost.visible),a=[0,1].filter(c=>this.bodies[c].solid.visible);return i?this.pickAmong(r,o)??this.pickAmong(r,a):(this.state?.throughWalls&&this.state.mode==="contacts"?this.pickAmong(r,[0,1],!0):null)??this.pickAmong(r,a)??this.pickAmong(r,o)}lineAt(e,t){let i=this.contacts?.hits;if(!i||!this.shotsView?.group.visible)return null;let s=BP,r=null;for(let{hit:o,at:a}of this.shotsView.points){let[l,c]=this.stage.pixelOf(a),u=Math.hypot(l-e,c-t);u<s&&([s,r]=[u,i.lineOf(o)])}return r}pickAmong(e,t,i=!1){let s=1/0,r=null;for(let o of t){let a=i?[...this.highlights[o].keys()]:null,l=this.hit(e,o,a);l&&l.distance<s&&(s=l.distance,r={body:o,triangle:a?a[l.triangle]:l.triangle})}return r}hit(e,t,i){let s=this.matrices[t].clone().invert(),r=new k(...e.origin).applyMatrix4(s),o=new k(...e.direction).transformDirection(s),a=this.bodies[t].corners;if(i){let f=new Float32Array(9*i.length);i.forEach((h,d)=>f.set(a.subarray(9*h,9*h+9),9*d)),a=f}let l=this.state?.clip,c=l?"xyz".indexOf(l.axis):0,u=l?l.at-this.origin[c]:1/0;return kv(a,{origin:r.toArray(),direction:o.toArray()},f=>e.origin[c]+f*e.direction[c]>u)}get lines(){return this.shotsView?.lines??[0,0]}hitPixels(e){let t=this.contacts?.hits;return(t?this.shotsView?.points.slice(0,e)??[]:[]).map(({hit:i,at:s})=>({line:t?.lineOf(i)??-1,kind:t?.kindOf(i)??"grazes",pixel:this.stage.pixelOf(s)}))}get motion(){let e=this.centreOfB().toArray();return{pieces:this.pathView.group.children.length,centre:e.map((t,i)=>t+this.origin[i])}}get highlighted(){return this.highlights.map(e=>[...e.keys()].sort((t,i)=>t-i))}pixelOf(e){return this.stage.pixelOf(e.map((t,i)=>t-this.origin[i]))}pixelOfWorld(e){let t=this.contacts?.scenario;return this.pixelOf(t?qs(Ar(t.pose_a),e):e)}dispose(){this.bodies.forEach(e=>e.dispose()),this.contactsView.dispose(),this.shotsView?.dispose(),this.pathView.dispose(),this.mark.dispose(),this.stage.dispose()}};function Da(n){return n.bodies.reduce((e,t)=>e+t.triangles,0)}function qv(n){let[e,t]=et({value:null,error:""});return qe(()=>{let i=!0;return n&&Da(n)<=tc&&Cv(n).then(s=>i&&t({value:s,error:""}),s=>i&&t({value:null,error:ti(s)})),()=>{i=!1}},[n?.job]),e}function Yv(n,e,t){let[i,s]=et({value:null,error:""}),r=Lt(!1);return qe(()=>{n&&e&&t&&!r.current&&(r.current=!0,Rv(n,e).then(o=>s({value:o,error:o?"":"this job has no heat map"}),o=>s({value:null,error:ti(o)})))},[n,e,t]),i}function Jv(n,e){let[t,i]=et(null),[s,r]=et({scenario:-1,error:""}),o=Lt(null);return qe(()=>{if(n)return o.current=new ad(n.job,Nt(n),i,(a,l)=>r({scenario:a,error:ti(l)})),()=>o.current?.close()},[n?.job]),qe(()=>o.current?.want(e),[n?.job,e]),{contacts:t,error:s.scenario===e?s.error:""}}function Kv(n,e,t,i,s,r){let[o,a]=et(null),[l,c]=et(""),u=Lt(0),f=Lt(-1),h=Lt(-1),d=Lt(r);return d.current=r,qe(()=>{if(!n.current||!e)return;let p=performance.now(),b;try{b=new _d(n.current,e,()=>d.current(b.view),()=>{f.current=h.current,u.current===0&&h.current>=0&&(u.current=performance.now()-p)})}catch(_){c(`this browser draws no 3D (WebGL 2): ${ti(_)}. All else on this page works.`);return}a(b);let m=Ac(()=>b.refreshTheme());return()=>{m(),b.dispose()}},[e]),qe(()=>{o&&t&&(o.show(t,i),h.current=t.scenario.index)},[o,t]),qe(()=>o?.setState(i),[o,i]),qe(()=>{o&&s&&o.setHeat(s.counts,s.most)},[o,s]),{viewer:o,error:l,firstFrame:u,drawn:f}}var VP=4;function Zv({job:n,scenario:e,contacts:t,canvas:i,viewer:s,waits:r,root:o,pick:a}){let l=Lt([0,0]),c=f=>{let h=Math.hypot(f.clientX-l.current[0],f.clientY-l.current[1]);s&&h<VP&&a(s.pickAt(f.offsetX,f.offsetY,f.shiftKey))};return g("div",{class:"stage",onWheelCapture:f=>{o&&o.getRootNode().activeElement!==i.current&&f.stopPropagation()},children:[g("canvas",{ref:i,tabIndex:0,role:"img","aria-label":`scenario ${e}: ${t?.scenario.class??""}, ${t?.scenario.count??0} ${di(n)}s${t?.scenario.near_count?`, ${t.scenario.near_count} near`:""}`,onKeyDown:f=>{f.key==="Enter"&&a(s?.pickMiddle(f.shiftKey)??null)},onPointerDown:f=>{l.current=[f.clientX,f.clientY]},onClick:c}),g("span",{class:"cross-hair","aria-hidden":"true"}),r&&g("p",{class:"wait over",children:["reading ",Re(Da(n))," triangles…"]}),g("div",{class:"corner",children:[g("span",{class:"swatch a"})," A ",g(Mt,{text:Vs(n.bodies[0].file)})," ",g("span",{class:"swatch b"})," B"," ",g(Mt,{text:Nt(n)?n.bodies[1].name:Vs(n.bodies[1].file)}),g("span",{class:"note",children:"drawn in single precision"})]})]})}var Um=100;function HP(n,e){let t=new Map;for(let i=0;i+2<n.length;i+=3){let[s,r]=[0,1].map(c=>e[c].nameOf(n[i+c])),o=`${s.length}:${s}${r}`,a=t.get(o),l=n[i+2]===vo?1:0;a?(a.count+=1,a.near+=l):t.set(o,{a:s,b:r,count:1,near:l})}return[...t.values()].sort((i,s)=>s.count-i.count)}function jv(n){let{state:e}=n,t=St(()=>HP(n.contacts.pairs,n.model.parts),[n.contacts,n.model]);if(t.length===0&&!e.partA&&!e.partB)return null;let i=n.contacts.hits!==null,s=i?"parts hit here":t.some(o=>o.near>0)?"parts in contact or near here":"parts in contact here",r=o=>e.partA===o.a&&e.partB===o.b;return g("section",{"aria-label":s,children:[g("h2",{children:s}),g("ul",{class:"pairs",children:t.slice(0,Um).map(o=>g("li",{children:g("button",{type:"button","aria-pressed":r(o),onClick:()=>r(o)?n.choose("",""):n.choose(o.a,o.b),children:[g("span",{children:[g(Mt,{text:o.a}),!i&&g(Tt,{children:[" ",g("i",{children:"×"})," ",g(Mt,{text:o.b})]})]}),g("b",{children:[Re(o.count),o.near>0&&g("i",{children:[" (",Re(o.near)," near)"]})]})]})},`${o.a}
${o.b}`))}),t.length>Um&&g("p",{class:"note",children:["and ",Ct(t.length-Um,"pair")," of parts more"]}),(e.partA||e.partB)&&g("p",{class:"note",children:["only ",g(Mt,{text:e.partA||"all of A"})," × ",g(Mt,{text:e.partB||"all of B"}),";"," ",g("button",{type:"button",class:"link",onClick:()=>n.choose("",""),children:"show all"})]})]})}function Qv(n){let{pick:e,job:t}=n,i=n.model.meshes[e.body],s=n.model.parts[e.body],r=e.triangle<i.triangles.length/3,o=St(()=>{let l=0,c=n.contacts?.pairs??new Uint32Array;for(let u=e.body;u<c.length;u+=3)l+=c[u]===e.triangle?1:0;return l},[n.contacts,e]),a=n.heat?.counts[e.body][e.triangle];return g("section",{"aria-label":"picked triangle","aria-live":"polite",children:[g("h2",{children:["picked"," ",g("button",{type:"button",class:"link",onClick:n.drop,children:"drop"})]}),r?g("p",{children:[e.body===0?"A":"B"," triangle ",g("b",{children:Re(e.triangle)}),", ",g(Mt,{text:s.nameOf(e.triangle)})," ",Re(s.placeOf(e.triangle)),"; in ",Ct(o,di(t))," here",a!==void 0&&(Nt(t)?`; crossed ${Ct(a,"time")} in all`:`; in ${Re(a)} of ${Ct(t.done,"pose")} (${gn(a/Math.max(1,t.done))})`)]}):g("p",{children:["the mesh has no triangle ",Re(e.triangle)]})]})}function Om({pose:n,title:e}){let t=[n.slice(0,4),n.slice(4,8),n.slice(8,12),[0,0,0,1]];return g("table",{class:"matrix",children:[g("caption",{children:e}),g("tbody",{children:t.map((i,s)=>g("tr",{children:i.map((r,o)=>g("td",{children:String(r)},o))},s))})]})}function GP(n){return ro.map(e=>`${e} ${Et(Tr(e,n),5)}°`).join("  ")}function eb({job:n,contacts:e,tau:t}){let i=eu(e.scenario,t);if(Kn(n))return g("section",{"aria-label":"direction",children:[g("h2",{children:"where the lines come from"}),g("p",{children:GP(i)}),g("details",{children:[g("summary",{children:"matrix"}),g(Om,{pose:i,title:"the bundle in A's frame"})]})]});let s=L_(i),r=rl.filter(l=>l!=="distance"&&(!Ys(l)||Math.abs(s[l])>1e-9)).map(l=>`${l} ${Et(s[l],5)}${Ys(l)?"°":""}`),{pose_a:o,pose_b:a}=ep(e.scenario,t);return g("section",{"aria-label":"pose",children:[g("h2",{children:"B in A's frame"}),g("p",{children:[r.join("  ")," ",g("span",{class:"note",children:["lengths in ",n.unit]})]}),g("details",{children:[g("summary",{children:"matrix"}),n.poses.of_both_bodies&&g(Om,{pose:o,title:"A in the world"}),g(Om,{pose:n.poses.of_both_bodies?a:i,title:n.poses.of_both_bodies?"B in the world":"B in A's frame"})]})]})}function tb({model:n,contacts:e}){let t=n?.meshes.filter(r=>r.checked===!1)??[],i=n?.meshes.some(r=>r.checked===null)??!1,s=e?.scenario;return g(Tt,{children:[t.length>0&&g(Pt,{kind:"bad",children:["not the tested geometry: the bytes of ",Ct(t.length,"mesh").replace("meshs","meshes")," do not have the SHA-256 of the run (",t.map(r=>r.sha256.slice(0,16)).join(", "),")"]}),t.length===0&&i&&g(Pt,{kind:"warn",children:"the geometry is not checked: this browser computes SHA-256 on 127.0.0.1 or over TLS only"}),s?.verified===!1&&g(Pt,{kind:"bad",children:["this scenario, run again, gives another record than the stored one: ",s.verify_note]}),s&&s.draw_note!==""&&g(Pt,{kind:"warn",children:["nothing is drawn: ",s.draw_note]}),s&&s.failure!==""&&g(Pt,{kind:"bad",children:["failed: ",g(Mt,{text:s.failure})]})]})}function WP(n,e){let t=i=>`${Et(i,6)} ${n.unit} apart`;return typeof e.distance=="number"?`the bodies are ${t(e.distance)}`:e.distance===null?e.class==="separate"&&typeof n.up_to=="number"?`more than ${t(n.up_to)}`:"":e.least_distance===null?"":`nearest triangles ${t(e.least_distance)}`}function nb({job:n,contacts:e}){let{scenario:t}=e,i=Go(t.class),s=t.class!==null&&t.count>0?Ct(t.count,di(n)):"",r=t.near_count>0?Ct(t.near_count,"near pair"):"",o=[WP(n,t),t.motion?ux(t.motion,Qo(t)):"",n.first_hits?"the first hit of each line":"",i===3?"one body is inside the other: g changes the ghost":"",t.id!==null?`id ${t.id}`:"",t.time!==null?`t ${Et(t.time,6)}`:"",e.isCut?`drawn: the first ${Re(e.pairs.length/3)} ${di(n)}s`:"",t.cut?`list of ${di(n)}s cut at ${Re(t.listed)}`:"",t.surfaces_only?"surfaces only: a body is open":"",t.insides_skipped?"containment not tested: triangles are ignored":"",t.distance_bound!==null&&t.distance_bound>0?`at most ${Et(t.distance_bound)} ${n.unit} apart`:""].filter(a=>a!=="");return g("span",{class:"scenario-status",children:[g("span",{children:[g(Xs,{kind:i}),g("b",{children:t.class??"no result yet"}),s&&`, ${s}`,r&&`, ${r}`]}),t.verified===!0&&g("span",{class:"verified",title:"run again, the record has the same bytes",children:"✓ verified"}),t.verified===null&&g("span",{class:"note",title:t.verify_note,children:["not verified",t.verify_note&&`: ${t.verify_note}`]}),o.length>0&&g("span",{class:"note",children:o.join(" · ")})]})}function ib(n){let{job:e,scenarios:t}=n,i=g(Mt,{text:e.name||e.job}),s=r=>n.move(t.placeOf(Math.round(Number(r))||0));return g("div",{class:"viewer-head",children:[g("h1",{children:[n.isInReport?i:g("a",{href:ks(e.job),children:i})," ",g("span",{class:"note",children:"›"})," ",g("label",{class:"number",children:["#",g("input",{type:"number","aria-label":"scenario",min:t.at(0),max:t.at(t.count-1),value:n.scenario,onChange:r=>s(r.currentTarget.value)})]})]}),n.contacts&&g(nb,{job:e,contacts:n.contacts})]})}function xd(n){return{contact:"contact",near:"near scenario",either:"contact or near scenario"}[n]}function XP({seek:n,choose:e}){return g("select",{"aria-label":"what previous and next find",value:n,onChange:t=>e(t.currentTarget.value),children:[g("option",{value:"contact",children:"contacts"}),g("option",{value:"near",children:"near"}),g("option",{value:"either",children:"both"})]})}function sb(n){let{scenarios:e,search:t,isPlaying:i,play:s}=n,r=e.count-1;return g("div",{class:"scrub",children:[g("button",{type:"button",onClick:()=>t.start(-1),title:"p",children:["‹ previous ",xd(n.seek)]}),g("button",{type:"button",onClick:()=>t.start(1),title:"n",children:["next ",xd(n.seek)," ›"]}),n.chooseSeek&&g(XP,{seek:n.seek,choose:n.chooseSeek}),g("input",{type:"range","aria-label":n.isInReport?"scenarios of this report":`scenario, 0 to ${r}`,min:0,max:r,value:n.place,onInput:o=>n.move(Number(o.currentTarget.value))}),s&&g("button",{type:"button",onClick:()=>s(!i),title:"space","aria-pressed":i,children:i?"stop":"play"}),n.children,g("span",{class:"note","aria-live":"polite",children:t.said})]})}var yd=class{constructor(e,t){this.total=e;this.chosen=t?[...t].sort((i,s)=>i-s):null}total;chosen;get count(){return this.chosen?.length??this.total}at(e){let t=Math.min(this.count-1,Math.max(0,e));return this.chosen?this.chosen[t]:t}placeOf(e){if(!this.chosen)return Math.min(this.total-1,Math.max(0,e));let t=this.chosen.map(i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}};var ab=({partA:n,partB:e})=>!n&&!e;function ic(n,e){return`jobs/${encodeURIComponent(n)}/scenarios/${e}`}async function rb({job:n,from:e,step:t,signal:i,tell:s},r){let o=new URLSearchParams({from:String(e),step:String(t)});for(r.seek!=="contact"&&o.set("class",r.seek),r.partA&&o.set("part_a",r.partA),r.partB&&o.set("part_b",r.partB);;){let a=await Ri(ic(n.job,`next?${o}`),i);if(a.index!==null||a.searched_to===null)return a.index;s(a.searched_to),o.set("from",String(a.searched_to))}}function lb(n,{partA:e,partB:t,seek:i},s){for(let r=0;r+2<n.length;r+=3)if((i==="either"||n[r+2]===vo==(i==="near"))&&s[0].isOf(n[r],e)&&s[1].isOf(n[r+1],t))return!0;return!1}async function ob(n){for(;;)try{return await n()}catch(e){if(!(e instanceof Vi&&e.isBusy))throw e;await _c()}}async function $P({job:n,signal:e},t,i,s){let r=await ob(()=>Ri(ic(n.job,String(t)),e));if(r.exact_pairs===0)return r.draw_note!=="";let o=await ob(()=>An(ic(n.job,`${t}/pairs`),e));return o.cut||lb(o.values,i,s)}async function cb(n,e,t){let{level:i}=n.job;if(ab(e)||i==="pairs"||i==="contacts")return rb(n,e);let s=await t();[e.partA,e.partB].forEach((r,o)=>{if(r&&!s[o].names.includes(r))throw new Error(`the body has no part '${r}'`)});for(let r=n.from;;n.tell(r)){let o=await rb({...n,from:r},{...e,partA:"",partB:""});if(o===null||await $P(n,o,e,s))return o;r=o}}async function qP(n,e,{seek:t}){if(n.clearance===null||t==="either")return!0;let i=await Ri(ic(n.job,String(e)));return Go(i.class)===7==(t==="near")}async function ub({job:n,from:e,step:t},i,s,r){let o=i.filter(a=>(a-e)*t>0).sort((a,l)=>(a-l)*t);for(let a of o)if(await qP(n,a,s)&&(ab(s)||lb((await An(ic(n.job,`${a}/pairs`))).values,s,r)))return a;return null}function hb(n,e,t,i,s){let[r,o]=et(""),a=Lt(null),l=()=>{a.current&&(a.current.stop.abort(),a.current=null,o(u=>u.replace("searching","stopped")))},c=async u=>{if(a.current?.by===u)return;l(),o("");let f={by:u,stop:new AbortController};a.current=f;try{let h=await n(u,f.stop.signal,d=>{a.current===f&&o(`searching, at #${Re(d)}`)});if(a.current!==f)return;a.current=null,h!==null?(o(""),e(h)):o(`no ${i} ${u>0?"after":"before"} this scenario${t?"":" so far"}`)}catch(h){a.current===f&&(a.current=null,o(Fs(h)?"":ti(h)))}};return qe(()=>()=>{l(),o("")},s),{said:r,start:u=>{c(u)},stop:l}}function db(n){let e=Lt(n);e.current=n,qe(()=>yi("viewer",()=>{let{model:t,contacts:i,state:s,drawing:r,scenario:o,canvas:a}=e.current,l=r.viewer,c=a.current?.getBoundingClientRect(),u=([d,p])=>[d+(c?.left??0),p+(c?.top??0)],f=i?.points??new Float64Array,h=Array.from({length:Math.min(8,f.length/4)},(d,p)=>Array.from(f.subarray(4*p+1,4*p+4)));return{ready:l?.isShowing(s)===!0&&r.drawn.current===o,scenario:i?.scenario.index,class:i?.scenario.class,verified:i?.scenario.verified,mode:s.mode,ghost:s.ghost,throughWalls:s.throughWalls,clip:s.clip,camera:l?.view,parts:[s.partA,s.partB],pick:s.pick,trianglesDrawn:l?.bodies.map(d=>d.triangles)??[0,0],highlighted:l?.highlighted??[[],[]],gaps:l?.gaps??0,lines:l?.lines??[0,0],motion:i?.scenario.motion&&{tau:s.tau??jo(i.scenario.motion),event:Zo(i.scenario.motion),intervals:oo(i.scenario.motion),...l?.motion},hits:(l?.hitPixels(64)??[]).map(d=>({...d,pixel:u(d.pixel)})),shaChecked:t?.meshes.map(d=>d.checked),meshMilliseconds:t?.milliseconds,firstFrameMilliseconds:r.firstFrame.current,frames:l?.stage.frames,pointPixels:l?h.map(d=>u(l.pixelOfWorld(d))):[]}}),[])}var YP=60,vd=Math.PI/24,bd=.05;function JP(n,e){let t=e.bodies[1]?.size??[0,0,0],i=Math.hypot(t[0],t[1],t[2])/2,s=n?.meshes[0],r=o=>s?[s.min[o]-i,s.max[o]+i]:[-1,1];return{x:r(0),y:r(1),z:r(2)}}function Fm(n){let e=n.route.job,{value:t,error:i}=Ws(`jobs/${encodeURIComponent(e)}`,1,()=>!1);return t?g(KP,{...n,job:t}):i?g(Pt,{kind:"bad",children:i}):g("p",{class:"wait",children:["asking for ",e,"…"]})}function KP({source:n,route:e,report:t,job:i}){let{value:s,error:r}=qv(i),o=St(()=>({bodies:$c(i),hasA:Ne=>s?.parts[0].names.includes(Ne)??!0}),[s]),[a,l]=et(e.scenario),[c,u]=et(()=>Nm(e.query,o)),{contacts:f,error:h}=Jv(i,a),{value:d,error:p}=Yv(i,s,c.mode==="heat"||c.pick!==null&&i.maps),b=Lt(null),[m,_]=et(!1),[v,C]=et(!1),S=Ag(Ne=>u(Ge=>({...Ge,...Ne})),[]),I=Kv(b,s,f,c,d,Ne=>S({camera:Ne})),{viewer:T}=I,y=St(()=>JP(s,i),[s,i]);Sr(t?null:`#${a} ${i.name}`),db({model:s,contacts:f,state:c,drawing:I,scenario:a,canvas:b});let E=()=>{T&&c.camera&&(T.view=c.camera)},[V,U]=et(0);qe(()=>{l(e.scenario),u(Nm(e.query,o)),U(Ne=>Ne+1)},[e]),qe(E,[T,V]),qe(()=>{if(s){let[Ne,Ge]=Dm(e.query,o);S({partA:Ne,partB:Ge})}},[s]);let L=(Ne,Ge)=>mn(e.job,Ne,$v({...c,camera:Ge,tau:Ne===a?c.tau:null},o.bodies)),G=()=>L(a,c.camera??T?.ownView??null),z=Nt(i),N=z&&c.pick?.body===1?c.pick.triangle:null,W=z?"as files":"as a case of its own",Y=Da(i)>tc,H=!Y&&I.error==="";qe(()=>((s||Y)&&Mc(G),xr),[a,c,f,s]);let ae=St(()=>new yd(i.scenarios,t?.scenarios),[i,t]),K=ae.placeOf(a),$=Ne=>{l(ae.at(Ne)),S({tau:null})};qe(()=>{if(!m||f?.scenario.index!==a)return;if(K+1>=ae.count){_(!1);return}let Ne=setTimeout(()=>$(K+1),YP);return()=>clearTimeout(Ne)},[m,f,a]);let ee=async()=>s?.parts??Promise.all([Jo(i.job,0),Jo(i.job,1)]),te=hb((Ne,Ge,Bt)=>t&&s?ub({job:i,from:a,step:Ne},t.scenarios,c,s.parts):cb({job:i,from:a,step:Ne,signal:Ge,tell:Bt},c,ee),Ne=>{qa(G()),Bs(L(Ne,c.camera))},i.done===i.scenarios,xd(c.seek),[e,a,c,m]),me=()=>{S({camera:null}),T?.fit(!1)},ge=()=>{T?.goToContact(),S({camera:T?.view??null})},Me=Ne=>{if(c.clip){let[Ge,Bt]=y[c.clip.axis],Wt=Math.min(Bt,Math.max(Ge,c.clip.at+Ne*(Bt-Ge)/100));S({clip:{...c.clip,at:Wt}})}},Xe={n:()=>te.start(1),p:()=>te.start(-1),ArrowRight:()=>$(K+1),ArrowLeft:()=>$(K-1),...H?{" ":()=>_(!m),h:()=>S({mode:c.mode==="heat"||!i.maps?"contacts":"heat"}),g:()=>S({ghost:c.ghost==="a"?"b":c.ghost==="b"?"none":"a"}),x:()=>S({throughWalls:!c.throughWalls}),l:()=>S({lines:!c.lines}),s:()=>S({clip:c.clip?null:{axis:"x",at:(y.x[0]+y.x[1])/2}}),"[":()=>Me(-1),"]":()=>Me(1),f:me,c:ge,e:()=>S({tau:null}),"Shift+ArrowRight":()=>T?.stage.turn(vd,0),"Shift+ArrowLeft":()=>T?.stage.turn(-vd,0),"Shift+ArrowUp":()=>T?.stage.turn(0,vd),"Shift+ArrowDown":()=>T?.stage.turn(0,-vd),W:()=>T?.stage.move(0,bd),S:()=>T?.stage.move(0,-bd),A:()=>T?.stage.move(-bd,0),D:()=>T?.stage.move(bd,0),"+":()=>T?.stage.approach(.85),"-":()=>T?.stage.approach(1/.85)}:{},Escape:te.stop,"?":()=>C(!0)},rt=Ne=>u(Ge=>Ne===null&&Ge.pick===null?Ge:{...Ge,pick:Ne});Qc(Xe,t?.root);let He=i.folder?Ya(i.folder):n.kind==="folder"?Ya(n.name):i.job,ht=r||I.error||h||(c.mode==="heat"?p:"");return g("div",{class:"viewer",children:[g(ib,{job:i,isInReport:t!==void 0,scenario:a,scenarios:ae,contacts:f,move:$}),g(tb,{model:s,contacts:f}),ht&&g(Pt,{kind:"bad",children:ht}),g(sb,{scenarios:ae,isInReport:t!==void 0,place:K,move:$,search:te,seek:c.seek,chooseSeek:i.clearance===null?null:Ne=>S({seek:Ne}),isPlaying:m,play:H?_:null,children:[g(mx,{address:()=>location.href.split("#")[0]+L(a,T?.view??c.camera)}),H&&g("button",{type:"button",onClick:()=>{T?.stage.save(`${i.name||e.job}-${a}`)},disabled:!T,children:"PNG"}),g("button",{type:"button",class:"quiet",onClick:()=>C(!0),title:"keys",children:"?"})]}),g("div",{class:"stage-row",children:[Y?g("div",{class:"stage",children:g("p",{class:"wait",children:[Re(Da(i))," triangles: above ",Re(tc)," this page does not draw. The exports have it all:"," ",g("code",{children:["cdctl extract ",He," ",String(a)," --out ",z?"scene --as vtp":"case"]})]})}):g("div",{class:"stage-column",children:[g(Zv,{job:i,scenario:a,contacts:f,canvas:b,viewer:T,waits:!T&&!ht,root:t?.root,pick:rt}),f?.scenario.motion&&g(dx,{scenario:f.scenario,motion:f.scenario.motion,tau:c.tau,choose:Ne=>S({tau:Ne})})]}),g("aside",{class:"side",children:[H&&g(Tt,{children:[g(px,{state:c,bounds:y,hasMap:i.maps,lines:{areDrawn:z,hasAllHits:z&&i.first_hits!==!0,name:w_(i)?"path, segments and points":z?"lines and hits":"segments and points"},change:S,fit:me,goToContact:ge}),c.mode==="heat"&&d?g(vx,{heat:d,job:i}):z?g(Tv,{}):g(Sx,{near:bx(i)})]}),N!==null&&s&&f&&g(Av,{line:N,job:i,model:s,contacts:f,drop:()=>S({pick:null})}),c.pick&&N===null&&s&&g(Qv,{pick:c.pick,model:s,contacts:f,heat:d,job:i,drop:()=>S({pick:null})}),f&&s&&g(jv,{contacts:f,model:s,state:c,choose:(Ne,Ge)=>S({partA:Ne,partB:Ge})}),f&&g(eb,{job:i,contacts:f,tau:c.tau}),g("section",{"aria-label":W,children:[g("h2",{children:W}),g(Wc,{text:`cdctl extract ${He} ${a} --out ${z?"scene --as vtp":"case"}`})]})]})]}),v&&g(jc,{title:"Keys of the viewer",keys:nx(H),close:()=>C(!1)})]})}var fb={system:"light",light:"dark",dark:"system"};function ZP(){let[n,e]=et(Fg());return g("button",{type:"button",class:"quiet",onClick:()=>{kg(fb[n]),e(fb[n])},title:"light, dark, or as the system says",children:[{system:"◐",light:"○",dark:"●"}[n]," ",n]})}function pb(n){let{source:e,screen:t}=n,i=e.job===null,s=(r,o,a)=>g("a",{href:`#/${r}`,...a?{"aria-current":"page"}:{},children:o});return g(Tt,{children:[g("header",{class:"bar",children:[g("a",{class:"brand",href:"#/",children:[g("img",{src:"icon.svg",alt:"",width:20,height:20}),"cdcluster"]}),g("nav",{"aria-label":"screens",children:[i&&s("cluster","cluster",t==="cluster"),i&&s("jobs","jobs",t==="jobs"),e.job!==null&&s(`jobs/${e.job}`,"job",t==="job")]}),g("span",{class:"where",title:`${e.program} ${e.name}`,children:[e.kind==="folder"?"folder ":"master ",g(Mt,{text:e.kind==="folder"?Vs(e.name):e.name}),e.tls&&" · TLS"]}),g(ZP,{})]}),g("main",{children:n.children})]})}function mb(n){return n.job===null?"#/cluster":ks(n.job)}function _b(){let[n,e]=et(Jd),t=()=>e(Jd()),i=Lt(location.hash);return qe(()=>{location.hash!==i.current&&t();let s=()=>{xr(),$d(),t()};return addEventListener("hashchange",s),()=>removeEventListener("hashchange",s)},[]),[n,t]}function jP({source:n}){let[e,t]=_b();qe(()=>yi("route",()=>({screen:e.screen,link:location.hash})),[e]);let i=location.hash.replace(/^#\/?/,"")==="";return qe(()=>{i&&(qa(mb(n)),t())},[i]),g(pb,{source:n,screen:e.screen,children:e.screen==="none"&&!i?g(Pt,{kind:"warn",children:["this address names nothing here; ",g("a",{href:mb(n),children:"go to the start"})]}):g(QP,{source:n,route:e})})}function QP({source:n,route:e}){switch(e.screen){case"cluster":return g(M_,{});case"jobs":return g(b_,{});case"job":return g(rx,{source:n,route:e},e.job);case"viewer":return g(Fm,{source:n,route:e},e.job);default:return null}}function e2(){let[n,e]=et(null),[t,i]=et("");return qe(()=>{Ri("source").then(e,s=>i(ti(s)))},[]),n?g(jP,{source:n}):t?g(Pt,{kind:"bad",children:t}):null}function t2({source:n,report:e}){let[t]=_b(),i=St(()=>Yd(mn(n.job??"",e.scenarios[0])),[]);return g(Fm,{source:n,route:t.screen==="viewer"?t:i,report:e})}async function n2(n,e){Pg(o=>e.answer(o));let t=await Ri("source"),i=new CSSStyleSheet;i.replaceSync(await qd("app.css"));let s=n.attachShadow({mode:"open"});s.adoptedStyleSheets=[i];let r=s.appendChild(document.createElement("div"));zd(g(t2,{source:t,report:{scenarios:e.scenarios,root:r}}),r)}Lg();var Sd=document.getElementById("page"),gb=bc.of(document);Sd&&gb?n2(Sd,gb):Sd&&(Bg(),$d(),zd(g(e2,{}),Sd));
