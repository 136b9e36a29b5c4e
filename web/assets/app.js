var Ot,Pm,Ov,ir,hd,Zl,Im,$l,Lm,fd,dd,Fv,Ca=Symbol.for("pv"),Kl={},jl=[],Bv=/^m(i|n|o|s|text|space)$/,pd=Array.isArray,Dm=jl.slice,Or=Object.assign;function Ur(n){n&&n.parentNode&&n.remove()}function ql(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Ca,__v:s||++Pm,__i:-1,__u:0};return!s&&Ot.vnode&&Ot.vnode(r),r}function Vt(n){return n.children}function Yl(n,e){this.props=n,this.context=e,this.__g=0}function sr(n,e){if(e==null)return n.__&&sr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:sr(n)}function kv(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Or({constructor:Ca},t)).__v=t.__v+1,Ot.vnode&&Ot.vnode(e),md(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||sr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,km(s,e,r),t.__=t.__e=null,e.__e!=i&&Nm(e))}function Nm(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Nm(n)}function Cm(n){(8&n.__g||(n.__g|=8,ir.push(n),Zl++))&&hd==Ot.debounceRendering||((hd=Ot.debounceRendering)||queueMicrotask)(Um)}function Um(){try{for(var n,e=1;ir.length;)ir.length>e&&ir.sort(Im),n=ir.shift(),e=ir.length,8&n.__g&&kv(n)}finally{(Zl=ir.length)&&(hd||queueMicrotask)(Um)}}function Om(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,b,m,g=i.__k||jl,v=e.length;for(l=zv(t,e,g,l,v),f=0;f<v;f++)(d=t.__k[f])!=null&&(h=~d.__i&&g[d.__i]||Kl,d.__i=f,m=md(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&gd(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),b=b||p,4&d.__u?(l=Fm(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&m!==void 0?l=m:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=b,l}function zv(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,b=p,m=0,g=0,v=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=ql(null,o):pd(o)?o=v[r]=ql(Vt,{children:o}):o.constructor===Ca&&o.__b?o=v[r]=ql(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Vv(o,t,l,b))&&(b--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,g=1)):(~c||(s>p?m--:s<p&&m++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(g){for(u=[],f=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(m=0,h=u.length;m<h;)u[d=m+h>>1]<o.__i?m=d+1:h=d;u[m]=o.__i,f[r]=m+1}for(m=u.length;r--;)f[r]&&(f[r]==m?m--:v[r].__u|=4)}if(b)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=sr(a)),_d(a,a));return i}function Fm(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=Fm(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=sr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Vv(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Rm(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Xl(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Rm(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Rm(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=dd[e]||(dd[e]=Hv(e)),(n.__a||(n.__a={}))[e]=fd,r=e!=(e=e.replace(Lm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Hv(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[$l]==null)e[$l]=fd++;else if(e[$l]<this.__a[n])return;return t(Ot.event?Ot.event(e):e)}}}function md(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,m,g,v,C,S,I,T,x,E,H,U,L,G=e.type;if(e.constructor!==Ca)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=Jl(u,r):r.push(u),a=r[0]||a),(u=Ot.__b)&&u(e);e:if(typeof G=="function"){h=o.length;try{if(g=e.props,v=(u=G.prototype)&&u.render,C=(u=G.contextType)&&i[u.__c],S=u?C?C.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(v?e.__c=d=new G(g,S):(e.__c=d=new Yl(g,S),d.constructor=G,d.render=Wv),C&&C.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),v&&(d.__s||(d.__s=d.state),G.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Or({},d.__s)),Or(d.__s,G.getDerivedStateFromProps(g,d.__s)))),p=d.props,b=d.state,d.__v=e,t.__c){if(g!==p&&v&&!G.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(g,S),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(g,d.__s,S)===!1){e.__v!=t.__v&&(d.props=g,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),jl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=sr(t);break e}d.componentWillUpdate&&d.componentWillUpdate(g,d.__s,S),v&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,b,m)})}else v&&!G.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),v&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=S,d.props=g,d.__P=n,d.__g&=-5,I=Ot.__r,T=v?25:0;do d.__g&=-9,I&&I(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++T<25);v&&(jl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Or({},i,d.getChildContext())),v&&t.__c&&d.getSnapshotBeforeUpdate&&(m=d.getSnapshotBeforeUpdate(p,b)),x=u&&u.type===Vt&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&_d(V,V)}),t.__k=null),a=t.__k?sr(t,0):null),a=Om(n,pd(x)?x:[x],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(Ur),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(V){if(o.length=h,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(U=r.indexOf(a||void 0))||(U=r.length);(L=r[U-1])&&L.nodeType==8;)U--;for(;U<r.length;U++)if(L=r[U])if(r[U]=null,E){if(L==H)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(H=Jl(E=L))}}if(!E){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;E=a}(u=Jl(E=e.__c.__z||(e.__c.__z=E)))?(e.__e=E,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Ur);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||Bm(e),Ot.__e(V,e,t)}}else a=e.__e=Gv(t.__e,e,t,i,s,r,o,l,c,n);return(u=Ot.diffed)&&u(e),a}function Jl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function Bm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(Bm))}function km(n,e,t){for(var i=0;i<t.length;)gd(t[i++],t[i++],t[i++]);Ot.__c&&Ot.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Ot.__e(r,s.__v)}})}function Gv(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,m,g,v=t.props||Kl,C=e.props,S=e.type;if(S=="svg"?s="http://www.w3.org/2000/svg":S=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(S?p.localName==S:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!S)return g.createTextNode(C);n=g.createElementNS(s,S,C.is?C:c),a&&(Ot.__m&&Ot.__m(e,r),a=!1),r=null}if(S){if(c=S=="template"&&n.content||n,r=S=="textarea"&&C.defaultValue!=null?null:r&&Dm.call(c.childNodes),!a&&r)for(v={},u=0;u<n.attributes.length;u++)v[(p=n.attributes[u]).name]=p.value;for(u in v)p=v[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in C||u=="value"&&"defaultValue"in C||u=="checked"&&"defaultChecked"in C||Xl(n,u,null,p,s);for(u in C)p=C[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?b=p:u=="checked"?m=p:a&&typeof p!="function"||v[u]===p||Xl(n,u,p,v[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(S=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Bv.test(S))&&(s="http://www.w3.org/1999/xhtml"),Om(c,pd(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&sr(t,0),a,l),r&&r.some(Ur)),a&&S!="textarea"||(u="value",S=="progress"&&b==null?n.removeAttribute(u):b==null||b===n[u]&&(S!="progress"||b)||Xl(n,u,b,v[u],s),u="checked",m!=null&&m!=n[u]&&Xl(n,u,m,v[u],s))}else v===C||a&&n.data==C||(n.data=C);return n}function gd(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Ot.__e(s,t)}}function _d(n,e,t){var i,s,r,o;if(Ot.unmount&&Ot.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||gd(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Ot.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&_d(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Jl(i,r=[]))&&(i==n.__e&&r.some(Ur),Ur(s),Ur(i)),t||Ur(n.__e),n.__e=n.__c=n.__=null}function Wv(n,e,t){return this.constructor(n,t)}function xd(n,e){var t,i,s,r;Ot.__&&Ot.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=ql(Vt,{children:[n]}),s=[],r=[],md(e,e.__k,i||Kl,Kl,e.namespaceURI,i?null:e.firstChild?Dm.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),km(s,e.__k,r),e.__k.props.children=null}Ot={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Zl=0,n}},Pm=0,Ov=function(n){return n!=null&&n.constructor===Ca},Yl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Or({},this.state)),typeof n=="function"&&(n=n(Or({},t),this.props)),n&&(Or(t,n),this.__v&&(e&&this.__k.push(e),Cm(this)))},Yl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Cm(this))},Yl.prototype.render=Vt,ir=[],Zl=0,Im=function(n,e){return n.__v.__b-e.__v.__b},$l=Symbol(),Lm=/(PointerCapture)$|Capture$/i,fd=0,dd={},Fv=0;var Pa,An,yd,zm,vd=Object.is,Ia=0,Jm=[],bd=[],xn=Ot,Vm=xn.__b,Hm=xn.__r,Gm=xn.diffed,Wm=xn.__c,Xm=xn.unmount,$m=xn.__;function Md(n,e){xn.__h&&xn.__h(An,n,Ia||e),Ia=0;var t=An.__H||(An.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Qe(n){return Ia=1,Xv(jm,n)}function Xv(n,e,t){var i=Md(Pa++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):jm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);vd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=An,!An.__f)){An.__f=!0;var s=An.shouldComponentUpdate;An.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,vd(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function $e(n,e){var t=Md(Pa++,3);!xn.__s&&Km(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,An.__H.__h.push(t))}function Tt(n){return Ia=5,Ht(function(){return{current:n}},[])}function Ht(n,e){var t=Md(Pa++,7);return Km(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function Zm(n,e){return Ia=8,Ht(function(){return n},e)}function $v(){var n;do{for(;n=bd.shift();)try{Ra(n)}catch(t){xn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Jm.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(Ra),e.__h.some(Sd),e.__h=[]}catch(t){e.__h=[],xn.__e(t,n.__v)}}}while(bd.length)}xn.__b=function(n){An=null,Vm&&Vm(n)},xn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),$m&&$m(n,e)},xn.__r=function(n){Hm&&Hm(n),Pa=0;var e=(An=n.__c).__H;e&&(yd==An?An.__h=[]:(e.__h.some(Ra),e.__h.some(Sd),Pa=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),yd=An},xn.diffed=function(n){Gm&&Gm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&Ym(Jm.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),yd=An=null},xn.__c=function(n,e){e.some(function(t){try{t.__h.some(Ra),t.__h=t.__h.filter(function(i){return!i.__||Sd(i)})}catch(i){t.__h=[function(){throw i}]}}),Wm&&Wm(n,e)},xn.unmount=function(n){Xm&&Xm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,Ym(bd.push(s))}else Ra(s)}catch(r){e=r}}),i.__H=void 0,e&&xn.__e(e,i.__v))};var qm=typeof requestAnimationFrame=="function";function qv(n){var e,t=function(){clearTimeout(i),qm&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);qm&&(e=requestAnimationFrame(t))}function Ym(n){n!=1&&zm==xn.requestAnimationFrame||((zm=xn.requestAnimationFrame)||qv)($v)}function Ra(n){var e=An,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),An=e}function Sd(n){var e=An;n.__c=n.__(),An=e}function Km(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!vd(t,n[i])})}function jm(n,e){return typeof e=="function"?e(n):e}function Yv(n,e){switch(n){case"|u1":return new Uint8Array(e);case"<u4":return new Uint32Array(e);case"<f4":return new Float32Array(e);case"<f8":return new Float64Array(e);case"<u8":return Float64Array.from(new BigUint64Array(e),Number);default:throw new Error(`an NPY array of type ${n}, which this page does not know`)}}function Qm(n){let e=new Uint8Array(n);if(e.length<10||e[0]!==147||e[1]!==78||e[6]!==1)throw new Error("not an NPY array of format 1.0");let t=10+e[8]+256*e[9],i=new TextDecoder("latin1").decode(e.subarray(10,t)),s=/'descr':\s*'([^']+)'/.exec(i)?.[1]??"",r=(/'shape':\s*\(([^)]*)\)/.exec(i)?.[1]??"").split(",").filter(a=>a.trim()!=="").map(Number);if(/'fortran_order':\s*True/.test(i))throw new Error("an NPY array in Fortran order, which this page does not read");let o=Yv(s,n.slice(t));if(o.length!==r.reduce((a,l)=>a*l,1))throw new Error("an NPY array that is cut short");return{shape:r,values:o}}var Bi=class extends Error{constructor(t,i){super(i);this.status=t}status;get isBusy(){return this.status===503}},Jv=300;function ec(){return new Promise(n=>setTimeout(n,Jv))}var eg="cdcluster.key",Ql="";function Zv(){try{return localStorage.getItem(eg)??Ql}catch{return Ql}}function wd(){let n=/^#key=([^&]*)&?(.*)$/.exec(location.hash);if(n){Ql=n[1];try{localStorage.setItem(eg,Ql)}catch{}history.replaceState(null,"",`${location.pathname}#${n[2]}`)}}async function Kv(n){try{let e=await n.json();if(typeof e=="object"&&e!==null&&"error"in e)return String(e.error)}catch{}return`the server answered ${n.status}`}async function jv(n,e){let t=Zv(),i=t===""?{}:{Authorization:`Bearer ${t}`},s;try{s=await fetch(`api/v1/${n}`,{headers:i,credentials:"same-origin",...e?{signal:e}:{}})}catch(r){throw e?.aborted?r:new Bi(0,"the server does not answer: has it ended?")}if(!s.ok)throw new Bi(s.status,await Kv(s));return{bytes:await s.arrayBuffer(),cut:s.headers.get("X-Cut")==="true"}}var tc=jv;function tg(n){tc=n}async function Ad(n,e){return new TextDecoder().decode((await tc(n,e)).bytes)}async function Ai(n,e){return JSON.parse(await Ad(n,e))}async function Zn(n,e){let{bytes:t,cut:i}=await tc(n,e);return{...Qm(t),cut:i}}async function ng(n,e){return(await tc(n,e)).bytes}function Rs(n){return n instanceof DOMException&&n.name==="AbortError"}function Kn(n){return n instanceof Error?n.message:String(n)}var ic=new Map,nc=[];function pi(n,e){return ic.set(n,e),()=>{ic.get(n)===e&&ic.delete(n)}}function ig(){addEventListener("error",n=>nc.push(n.message)),addEventListener("unhandledrejection",n=>nc.push(String(n.reason))),document.addEventListener("securitypolicyviolation",n=>nc.push(`policy: ${n.violatedDirective} ${n.blockedURI}`)),window.cdcluster={facts:()=>Object.assign({ready:!1,errors:[...nc]},...[...ic.values()].map(n=>n()))}}async function Qv(n){let e=atob(n),t=new Uint8Array(e.length);for(let s=0;s<e.length;++s)t[s]=e.charCodeAt(s);let i=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(i).arrayBuffer()}var sc=class n{constructor(e){this.blocks=e}blocks;static of(e){let i=Array.from(e.querySelectorAll("template[data-path]")).map(s=>[s.dataset.path??"",{base64:()=>s.content.textContent??"",cut:s.dataset.cut==="true"}]);return i.length===0?null:new n(new Map(i))}get scenarios(){return[...this.blocks.keys()].flatMap(e=>{let t=/^jobs\/[^/]+\/scenarios\/(\d+)$/.exec(e);return t?[Number(t[1])]:[]})}async answer(e){let t=this.blocks.get(e);if(!t)throw new Bi(404,"this report holds its worst scenarios only");return{bytes:await Qv(t.base64()),cut:t.cut}}};function Td(n){let[e,t]=n.replace(/^#/,"").split("?",2),i={screen:"none",job:"",scenario:0,query:new URLSearchParams(t??"")},s=e.split("/").filter(o=>o!=="");if(s.length===1&&(s[0]==="cluster"||s[0]==="jobs"))return{...i,screen:s[0]};if(s[0]!=="jobs"||s.length<2||s.length>3)return i;let r=eb(s[1]);return s.length===2?{...i,screen:"job",job:r}:/^\d+$/.test(s[2])?{...i,screen:"viewer",job:r,scenario:Number(s[2])}:i}function eb(n){try{return decodeURIComponent(n)}catch{return n}}function sg(n){let e=new URLSearchParams(n).toString().replaceAll("%2C",",").replaceAll("%3A",":").replaceAll("%2F","/");return e===""?"":`?${e}`}function Ps(n,e={}){return`#/jobs/${encodeURIComponent(n)}${sg(e)}`}function Wn(n,e,t={}){return`#/jobs/${encodeURIComponent(n)}/${e}${sg(t)}`}var La=null,rg=0,rc=null;function Is(n){og(),location.hash=n}function Ed(){return La=location.hash,Td(La)}function Da(n){rr(),(La===null||location.hash===La)&&(history.replaceState(null,"",n),La=location.hash)}function oc(n){rr(),rc=n,rg=window.setTimeout(og,200)}function og(){rc&&Da(rc())}function rr(){clearTimeout(rg),rc=null}var ag="cdcluster.theme",ac=new Set;function lg(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:"system"}function cg(n){n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n;try{localStorage.setItem(ag,n)}catch{}ac.forEach(e=>e())}function ug(){try{let n=localStorage.getItem(ag);(n==="light"||n==="dark")&&(document.documentElement.dataset.theme=n)}catch{}matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>ac.forEach(n=>n()))}function lc(n){return ac.add(n),()=>ac.delete(n)}function qi(n,e=document.documentElement){return getComputedStyle(e).getPropertyValue(n).trim()}function Fe(n){return(n<0?"-":"")+String(Math.round(Math.abs(n))).replace(/\B(?=(\d{3})+$)/g," ")}function On(n,e=4){return Number.isFinite(n)?String(Number(n.toPrecision(e))):n>0?"infinite":"-"}function un(n){return Number.isFinite(n)?`${n>0&&n<.001?"< 0.1":On(100*n,3)} %`:"-"}function cc(n,e,t){let i=0;for(;Math.abs(n)>=e&&i+1<t.length;)n/=e,i+=1;let s=i===0?String(Math.round(n)):n.toPrecision(3);return t[i]===""?s:s+" "+t[i]}function Ls(n){return cc(n,1024,["B","KiB","MiB","GiB","TiB"])}function hg(n){return`${cc(n,1e3,["B","kB","MB","GB"])}/s`}function dg(n,e){if(n<.01*e)return`${Ls(n)} of ${Ls(e)}`;let[t,i]=Ls(e).split(" ");return`${(n/(e/Number(t))).toPrecision(2)} of ${t} ${i}`}function or(n){return`${cc(n,1e3,["","k","M","G"])}/s`}function Cd(n){return cc(n,1e3,["","k","M","G"])}function Fr(n){if(!Number.isFinite(n))return"-";if(n<10)return`${On(n,2)} s`;let e=Math.round(n),t=i=>String(i).padStart(2,"0");return e<3600?`${Math.floor(e/60)}:${t(e%60)}`:e<86400?`${Math.floor(e/3600)} h ${t(Math.floor(e%3600/60))}`:`${Math.floor(e/86400)} d ${Math.floor(e%86400/3600)} h`}function Gt(n,e){return`${Fe(n)} ${e}${n===1?"":"s"}`}function Na(n){return/^[\w./:@%+=,-]+$/.test(n)?n:`'${n.replaceAll("'","'\\''")}'`}function ar(n){return n.split("/").pop()||n}var tb="uplot",nb="u-hz",ib="u-vt",sb="u-title",rb="u-wrap",ob="u-under",ab="u-over",lb="u-axis",zr="u-off",cb="u-select",ub="u-cursor-x",hb="u-cursor-y",db="u-cursor-pt",fb="u-legend",pb="u-live",mb="u-inline",gb="u-series",_b="u-marker",fg="u-label",xb="u-value",Oa="width",Fa="height";var pg="bottom",_o="left",Rd="right",$d="#000",mg=$d+"0",Pd="mousemove",gg="mousedown",Id="mouseup",_g="mouseenter",xg="mouseleave",yg="dblclick",yb="resize",vb="scroll",vg="change",pc="dppxchange",qd="--",wo=typeof window<"u",Od=wo?document:null,yo=wo?window:null,bb=wo?navigator:null,Et,uc;function Fd(){let n=devicePixelRatio;Et!=n&&(Et=n,uc&&kd(vg,uc,Fd),uc=matchMedia(`(min-resolution: ${Et-.001}dppx) and (max-resolution: ${Et+.001}dppx)`),Vr(vg,uc,Fd),yo.dispatchEvent(new CustomEvent(pc)))}function Ti(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Bd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Kt(n,e,t){n.style[e]=t+"px"}function Yi(n,e,t,i){let s=Od.createElement(n);return e!=null&&Ti(s,e),t?.insertBefore(s,i),s}function ki(n,e){return Yi("div",n,e)}var bg=new WeakMap;function ps(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=bg.get(n);r!=o&&(n.style.transform=r,bg.set(n,r),e<0||t<0||e>i||t>s?Ti(n,zr):Bd(n,zr))}var Sg=new WeakMap;function Mg(n,e,t){let i=e+t,s=Sg.get(n);i!=s&&(Sg.set(n,i),n.style.background=e,n.style.borderColor=t)}var wg=new WeakMap;function Ag(n,e,t,i){let s=e+""+t,r=wg.get(n);s!=r&&(wg.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Yd={passive:!0},Sb={...Yd,capture:!0};function Vr(n,e,t,i){e.addEventListener(n,t,i?Sb:Yd)}function kd(n,e,t,i){e.removeEventListener(n,t,Yd)}wo&&Fd();function Ji(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:Ei((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Qg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var e0=n=>n!=null,t0=n=>n!=null&&n>0,_c=Qg(e0),Mb=Qg(t0);function wb(n,e,t,i=0,s=!1){let r=s?Mb:_c,o=s?t0:e0;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Wt,l??-Wt]}function xc(n,e,t,i){let s=Cg(n),r=Cg(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ds:n0,a=s==1?Ei:zi,l=r==1?zi:Ei,c=a(o(En(n))),u=l(o(En(e))),f=vo(t,c),h=vo(t,u);return t==10&&(c<0&&(f=Xt(f,-c)),u<0&&(h=Xt(h,-u))),i||t==2?(n=f*s,e=h*r):(n=o0(n,f),e=yc(e,h)),[n,e]}function Jd(n,e,t,i){let s=xc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Zd=.1,Tg={mode:3,pad:Zd},ka={pad:0,soft:null,mode:0},Ab={min:ka,max:ka};function mc(n,e,t,i){return vc(t)?Eg(n,e,t):(ka.pad=t,ka.soft=i?0:null,ka.mode=i?3:0,Eg(n,e,Ab))}function wt(n,e){return n??e}function Tb(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function Eg(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Wt),l=wt(s.hard,Wt),c=wt(i.soft,Wt),u=wt(s.soft,-Wt),f=wt(i.mode,0),h=wt(s.mode,0),d=e-n,p=Ds(d),b=ai(En(n),En(e)),m=Ds(b),g=En(m-p);(d<1e-24||g>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Wt&&(r=0),h==2&&u!=-Wt&&(o=0)));let v=d||b||1e3,C=Ds(v),S=vo(10,Ei(C)),I=v*(d==0?n==0?.1:1:r),T=Xt(o0(n-I,S/10),24),x=n>=c&&(f==1||f==3&&T<=c||f==2&&T>=c)?c:Wt,E=ai(a,T<x&&n>=x?x:Zi(x,T)),H=v*(d==0?e==0?.1:1:o),U=Xt(yc(e+H,S/10),24),L=e<=u&&(h==1||h==3&&U>=u||h==2&&U<=u)?u:-Wt,G=Zi(l,U>L&&e<=L?L:ai(L,U));return E==G&&E==0&&(G=100),[E,G]}var Eb=new Intl.NumberFormat(wo?bb.language:"en-US"),Kd=n=>Eb.format(n),Ci=Math,fc=Ci.PI,En=Ci.abs,Ei=Ci.floor,Tn=Ci.round,zi=Ci.ceil,Zi=Ci.min,ai=Ci.max,vo=Ci.pow,Cg=Ci.sign,Ds=Ci.log10,n0=Ci.log2,Cb=(n,e=1)=>Ci.sinh(n)*e,Ld=(n,e=1)=>Ci.asinh(n/e),Wt=1/0;function Rg(n){return(Ds((n^n>>31)-(n>>31))|0)+1}function zd(n,e,t){return Zi(ai(n,e),t)}function i0(n){return typeof n=="function"}function yt(n){return i0(n)?n:()=>n}var Rb=()=>{},s0=n=>n,r0=(n,e)=>e,Pb=n=>null,Pg=n=>!0,Ig=(n,e)=>n==e,Ib=/\.\d*?(?=9{6,}|0{6,})/gm,Hr=n=>{if(l0(n)||cr.has(n))return n;let e=`${n}`,t=e.match(Ib);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Hr(s)}e${r}`}return Xt(n,i)};function Br(n,e){return Hr(Xt(Hr(n/e))*e)}function yc(n,e){return Hr(zi(Hr(n/e))*e)}function o0(n,e){return Hr(Ei(Hr(n/e))*e)}function Xt(n,e=0){if(l0(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Tn(i)/t}var cr=new Map;function a0(n){return((""+n).split(".")[1]||"").length}function Va(n,e,t,i){let s=[],r=i.map(a0);for(let o=e;o<t;o++){let a=En(o),l=Xt(vo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Xt(u,f);s.push(h),cr.set(h,f)}}return s}var za={},jd=[],bo=[null,null],lr=Array.isArray,l0=Number.isInteger,Lb=n=>n===void 0;function Lg(n){return typeof n=="string"}function vc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Db(n){return n!=null&&typeof n=="object"}var Nb=Object.getPrototypeOf(Uint8Array),c0="__proto__";function So(n,e=vc){let t;if(lr(n)){let i=n.find(s=>s!=null);if(lr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=So(n[s],e)}else t=n.slice()}else if(n instanceof Nb)t=n.slice();else if(e(n)){t={};for(let i in n)i!=c0&&(t[i]=So(n[i],e))}else t=n;return t}function yn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=c0&&(vc(n[s])?yn(n[s],So(i[s])):n[s]=So(i[s]))}return n}var Ub=0,Ob=1,Fb=2;function Bb(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function kb(n,e){if(Hb(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Gb(o[0])||(o=Vb(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:Ob,d=[];for(let p=0;p<u.length;p++){let b=u[p],m=r.get(l[p]);b===null?h!=Ub&&(f[m]=b,h==Fb&&d.push(m)):f[m]=b}Bb(f,d,s),i.push(f)}}return i}var zb=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Vb(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Hb(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Gb(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=ai(1,Ei((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var u0=["January","February","March","April","May","June","July","August","September","October","November","December"],h0=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function d0(n){return n.slice(0,3)}var Wb=h0.map(d0),Xb=u0.map(d0),$b={MMMM:u0,MMM:Xb,WWWW:h0,WWW:Wb};function Ua(n){return(n<10?"0":"")+n}function qb(n){return(n<10?"00":n<100?"0":"")+n}var Yb={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ua(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ua(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ua(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ua(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ua(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>qb(n.getMilliseconds())};function Qd(n,e){e=e||$b;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Yb[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Jb=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Zb(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Jb?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var f0=n=>n%1==0,gc=[1,2,2.5,5],Kb=Va(10,-32,0,gc),p0=Va(10,0,32,gc),jb=p0.filter(f0),kr=Kb.concat(p0),ef=`
`,m0="{YYYY}",Dg=ef+m0,g0="{M}/{D}",Ba=ef+g0,hc=Ba+"/{YY}",_0="{aa}",Qb="{h}:{mm}",xo=Qb+_0,Ng=ef+xo,Ug=":{ss}",Rt=null;function x0(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Va(10,0,3,gc).filter(f0):Va(10,-3,0,gc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,m0,Rt,Rt,Rt,Rt,Rt,Rt,1],[s*28,"{MMM}",Dg,Rt,Rt,Rt,Rt,Rt,1],[s,g0,Dg,Rt,Rt,Rt,Rt,Rt,1],[i,"{h}"+_0,hc,Rt,Ba,Rt,Rt,Rt,1],[t,xo,hc,Rt,Ba,Rt,Rt,Rt,1],[e,Ug,hc+" "+xo,Rt,Ba+" "+xo,Rt,Ng,Rt,1],[n,Ug+".{fff}",hc+" "+xo,Rt,Ba+" "+xo,Rt,Ng,Rt,1]];function u(f){return(h,d,p,b,m,g)=>{let v=[],C=m>=o,S=m>=r&&m<o,I=f(p),T=Xt(I*n,3),x=Dd(I.getFullYear(),C?0:I.getMonth(),S||C?1:I.getDate()),E=Xt(x*n,3);if(S||C){let H=S?m/r:0,U=C?m/o:0,L=T==E?T:Xt(Dd(x.getFullYear()+U,x.getMonth()+H,1)*n,3),G=new Date(Tn(L/n)),V=G.getFullYear(),N=G.getMonth();for(let W=0;L<=b;W++){let q=Dd(V+U*W,N+H*W,1),O=q-f(Xt(q*n,3));L=Xt((+q+O)*n,3),L<=b&&v.push(L)}}else{let H=m>=s?s:m,U=Ei(p)-Ei(T),L=E+U+yc(T-E,H);v.push(L);let G=f(L),V=G.getHours()+G.getMinutes()/t+G.getSeconds()/i,N=m/i,W=h.axes[d]._space,q=g/W;for(;L=Xt(L+m,n==1?0:3),!(L>b);)if(N>1){let O=Ei(Xt(V+N,6))%24,ee=f(L).getHours()-O;ee>1&&(ee=-1),L-=ee*i,V=(V+N)%24;let ie=v[v.length-1];Xt((L-ie)/m,3)*q>=.7&&v.push(L)}else v.push(L)}return v}}return[l,c,u]}var[eS,tS,nS]=x0(1),[iS,sS,rS]=x0(.001);Va(2,-53,53,[1]);function Og(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function Fg(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let b=n(p),m=b.getFullYear(),g=b.getMonth(),v=b.getDate(),C=b.getHours(),S=b.getMinutes(),I=b.getSeconds(),T=m!=l&&a[2]||g!=c&&a[3]||v!=u&&a[4]||C!=f&&a[5]||S!=h&&a[6]||I!=d&&a[7]||a[1];return l=m,c=g,u=v,f=C,h=S,d=I,T(b)})}}function oS(n,e){let t=Qd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Dd(n,e,t){return new Date(n,e,t)}function Bg(n,e){return e(n)}var aS="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function kg(n,e){return(t,i,s,r)=>r==null?qd:e(n(i))}function lS(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function cS(n,e){return n.series[e].fill(n,e)}var uS={show:!0,live:!0,isolate:!1,mount:Rb,markers:{show:!0,width:2,stroke:lS,fill:cS,dash:"solid"},idx:null,idxs:null,values:[]};function hS(n,e){let t=n.cursor.points,i=ki(),s=t.size(n,e);Kt(i,Oa,s),Kt(i,Fa,s);let r=s/-2;Kt(i,"marginLeft",r),Kt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Kt(i,"borderWidth",o),i}function dS(n,e){let t=n.series[e].points;return t._fill||t._stroke}function fS(n,e){let t=n.series[e].points;return t._stroke||t._fill}function pS(n,e){return n.series[e].points.size}var Nd=[0,0];function mS(n,e,t){return Nd[0]=e,Nd[1]=t,Nd}function dc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function Ud(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var gS={show:!0,x:!0,y:!0,lock:!1,move:mS,points:{one:!1,show:hS,size:pS,width:0,stroke:fS,fill:dS},bind:{mousedown:dc,mouseup:dc,click:dc,dblclick:dc,mousemove:Ud,mouseleave:Ud,mouseenter:Ud},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},y0={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},tf=yn({},y0,{filter:r0}),v0=yn({},tf,{size:10}),b0=yn({},y0,{show:!1}),nf='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',S0="bold "+nf,M0=1.5,zg={show:!0,scale:"x",stroke:$d,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:S0,side:2,grid:tf,ticks:v0,border:b0,font:nf,lineGap:M0,rotate:0},_S="Value",xS="Time",Vg={show:!0,scale:"x",auto:!1,sorted:1,min:Wt,max:-Wt,idxs:[]};function yS(n,e,t,i,s){return e.map(r=>r==null?"":Kd(r))}function vS(n,e,t,i,s,r,o){let a=[],l=cr.get(s)||0;t=o?t:Xt(yc(t,s),l);for(let c=t;c<=i;c=Xt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Vd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ds:n0,u=Ei(c(t));s=vo(l,u),l==10&&(s=kr[Ji(s,kr)]);let f=t,h=s*l;l==10&&(h=kr[Ji(h,kr)]);do a.push(f),f=f+s,l==10&&!cr.has(f)&&(f=Xt(f,cr.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=kr[Ji(h,kr)]));while(f<=i);return a}function bS(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Vd(n,e,ai(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Vd(n,e,ai(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var w0=/./,SS=/[12357]/,MS=/[125]/,Hg=/1/,Hd=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function wS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?w0:l(7,o)-u>=c?SS:l(5,o)-u>=c?MS:Hg;if(f==Hg){let h=En(l(1,o)-u);if(h<c)return Hd(e.slice().reverse(),a.distr,f,zi(c/h)).reverse()}return Hd(e,a.distr,f,1)}function AS(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=En(l(1,o)-l(2,o));return c<a?Hd(e.slice().reverse(),3,w0,zi(a/c)).reverse():e}function TS(n,e,t,i){return i==null?qd:e==null?"":Kd(e)}var Gg={show:!0,scale:"y",stroke:$d,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:S0,side:3,grid:tf,ticks:v0,border:b0,font:nf,lineGap:M0,rotate:0};function ES(n,e){let t=3+(n||1)*2;return Xt(t*e,3)}function CS(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=En(o-r),l=n.series[e],c=a/(l.points.space*Et);return i[1]-i[0]<=c}var Wg={scale:null,auto:!0,sorted:0,min:Wt,max:-Wt},A0=(n,e,t,i,s)=>s,Xg={show:!0,auto:!0,sorted:0,gaps:A0,alpha:1,facets:[yn({},Wg,{scale:"x"}),yn({},Wg,{scale:"y"})]},$g={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:A0,alpha:1,points:{show:CS,filter:null},values:null,min:Wt,max:-Wt,idxs:[],path:null,clip:null};function RS(n,e,t,i,s){return t/10}var T0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},PS=yn({},T0,{time:!1,ori:1}),qg={};function E0(n,e){let t=qg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(qg[n]=t)),t}var Mo=1,Gd=2;function Gr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,b=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,f,m,g,h,d,p,b,Sc,Ao,wc,R0,I0):t(s,l,c,u,f,g,m,d,h,b,p,Mc,To,of,P0,L0)}function sf(n,e){let t=0,i=0,s=wt(n.bands,jd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function IS(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Ns(n,e,t,i,s,r){return Gr(n,e,(o,a,l,c,u,f,h,d,p,b,m)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),C=c.ori==0?Ao:To,S,I;v==1?(S=t,I=i):(S=i,I=t);let T=g(f(a[S],c,b,d)),x=g(h(l[S],u,m,p)),E=g(f(a[I],c,b,d)),H=g(h(r==1?u.max:u.min,u,m,p)),U=new Path2D(s);return C(U,E,H),C(U,T,H),C(U,T,x),U})}function bc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?wc:of,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function LS(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function rf(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),b=f-s;d=o<=0&&b>=0&&b<l?r(n[b]):d;let g=h+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=d&&a.push([d,p])}return a}function Yg(n){return n==0?s0:n==1?Tn:e=>Br(e,n)}function C0(n){let e=n==0?Sc:Mc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=Zi(c,a/2,l/2),u=Zi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var Sc=(n,e,t)=>{n.moveTo(e,t)},Mc=(n,e,t)=>{n.moveTo(t,e)},Ao=(n,e,t)=>{n.lineTo(e,t)},To=(n,e,t)=>{n.lineTo(t,e)},wc=C0(0),of=C0(1),R0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},P0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},I0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},L0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function D0(n){return(e,t,i,s,r)=>Gr(e,t,(o,a,l,c,u,f,h,d,p,b,m)=>{let{pxRound:g,points:v}=o,C,S;c.ori==0?(C=Sc,S=R0):(C=Mc,S=P0);let I=Xt(v.width*Et,3),T=(v.size-v.width)/2*Et,x=Xt(T*2,3),E=new Path2D,H=new Path2D,{left:U,top:L,width:G,height:V}=e.bbox;wc(H,U-x,L-x,G+x*2,V+x*2);let N=W=>{if(l[W]!=null){let q=g(f(a[W],c,b,d)),O=g(h(l[W],u,m,p));C(E,q+T,O),S(E,q,O,T,0,fc*2)}};if(r)r.forEach(N);else for(let W=i;W<=s;W++)N(W);return{stroke:I>0?E:null,fill:E,clip:H,flags:Mo|Gd}})}function N0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var DS=N0(Ao),NS=N0(To);function U0(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>Gr(t,i,(o,a,l,c,u,f,h,d,p,b,m)=>{[s,r]=_c(l,s,r);let g=o.pxRound,v=V=>g(f(V,c,b,d)),C=V=>g(h(V,u,m,p)),S,I;c.ori==0?(S=Ao,I=DS):(S=To,I=NS);let T=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},E=x.stroke,H=!1;if(r-s>=b*4){let V=he=>t.posToVal(he,c.key,!0),N=null,W=null,q,O,re,J=v(a[T==1?s:r]),ee=v(a[s]),ie=v(a[r]),de=V(T==1?ee+1:ie-1);for(let he=T==1?s:r;he>=s&&he<=r;he+=T){let Q=a[he],ge=(T==1?Q<de:Q>de)?J:v(Q),Ee=l[he];ge==J?Ee!=null?(O=Ee,N==null?(S(E,ge,C(O)),q=N=W=O):O<N?N=O:O>W&&(W=O)):Ee===null&&(H=!0):(N!=null&&I(E,J,C(N),C(W),C(q),C(O)),Ee!=null?(O=Ee,S(E,ge,C(O)),N=W=q=O):(N=W=null,Ee===null&&(H=!0)),J=ge,de=V(J+T))}N!=null&&N!=W&&re!=J&&I(E,J,C(N),C(W),C(q),C(O))}else for(let V=T==1?s:r;V>=s&&V<=r;V+=T){let N=l[V];N===null?H=!0:N!=null&&S(E,v(a[V]),C(N))}let[L,G]=sf(t,i);if(o.fill!=null||L!=0){let V=x.fill=new Path2D(E),N=o.fillTo(t,i,o.min,o.max,L),W=C(N),q=v(a[s]),O=v(a[r]);T==-1&&([O,q]=[q,O]),S(V,O,W),S(V,q,W)}if(!o.spanGaps){let V=[];H&&V.push(...rf(a,l,s,r,T,v,e)),x.gaps=V=o.gaps(t,i,s,r,V),x.clip=bc(V,c.ori,d,p,b,m)}return G!=0&&(x.band=G==2?[Ns(t,i,s,r,E,-1),Ns(t,i,s,r,E,1)]:Ns(t,i,s,r,E,G)),x})}function US(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>Gr(r,o,(c,u,f,h,d,p,b,m,g,v,C)=>{[a,l]=_c(f,a,l);let S=c.pxRound,{left:I,width:T}=r.bbox,x=ee=>S(p(ee,h,v,m)),E=ee=>S(b(ee,d,C,g)),H=h.ori==0?Ao:To,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:Mo},L=U.stroke,G=h.dir*(h.ori==0?1:-1),V=E(f[G==1?a:l]),N=x(u[G==1?a:l]),W=N,q=N;s&&e==-1&&(q=I,H(L,q,V)),H(L,N,V);for(let ee=G==1?a:l;ee>=a&&ee<=l;ee+=G){let ie=f[ee];if(ie==null)continue;let de=x(u[ee]),he=E(ie);e==1?H(L,de,V):H(L,W,he),H(L,de,he),V=he,W=de}let O=W;s&&e==1&&(O=I+T,H(L,O,V));let[re,J]=sf(r,o);if(c.fill!=null||re!=0){let ee=U.fill=new Path2D(L),ie=c.fillTo(r,o,c.min,c.max,re),de=E(ie);H(ee,O,de),H(ee,q,de)}if(!c.spanGaps){let ee=[];ee.push(...rf(u,f,a,l,G,x,i));let ie=c.width*Et/2,de=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;ee.forEach(Q=>{Q[0]+=de,Q[1]+=he}),U.gaps=ee=c.gaps(r,o,a,l,ee),U.clip=bc(ee,h.ori,m,g,v,C)}return J!=0&&(U.band=J==2?[Ns(r,o,a,l,L,-1),Ns(r,o,a,l,L,1)]:Ns(r,o,a,l,L,J)),U})}function Jg(n,e,t,i,s,r,o=Wt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=En(n[l]-n[a]);u<c&&(c=u,o=En(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function OS(n){n=n||za;let e=wt(n.size,[.6,Wt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=wt(e[1],Wt),l=wt(e[2],1),c=wt(n.disp,za),u=wt(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,b,m)=>Gr(d,p,(g,v,C,S,I,T,x,E,H,U,L)=>{let G=g.pxRound,V=t,N=i*Et,W=a*Et,q=l*Et,O,re;S.ori==0?[O,re]=r(d,p):[re,O]=r(d,p);let J=S.dir*(S.ori==0?1:-1),ee=S.ori==0?wc:of,ie=S.ori==0?u:(Re,Ze,lt,Me,zt,Ge,Ye)=>{u(Re,Ze,lt,zt,Me,Ye,Ge)},de=wt(d.bands,jd).find(Re=>Re.series[0]==p),he=de!=null?de.dir:0,Q=g.fillTo(d,p,g.min,g.max,he),me=G(x(Q,I,L,H)),ge,Ee,ye,We=U,Ne=G(g.width*Et),Le=!1,at=null,ut=null,rt=null,Qt=null;f!=null&&(Ne==0||h!=null)&&(Le=!0,at=f.values(d,p,b,m),ut=new Map,new Set(at).forEach(Re=>{Re!=null&&ut.set(Re,new Path2D)}),Ne>0&&(rt=h.values(d,p,b,m),Qt=new Map,new Set(rt).forEach(Re=>{Re!=null&&Qt.set(Re,new Path2D)})));let{x0:$t,size:dn}=c;if($t!=null&&dn!=null){V=1,v=$t.values(d,p,b,m),$t.unit==2&&(v=v.map(lt=>d.posToVal(E+lt*U,S.key,!0)));let Re=dn.values(d,p,b,m);dn.unit==2?Ee=Re[0]*U:Ee=T(Re[0],S,U,E)-T(0,S,U,E),We=Jg(v,C,T,S,U,E,We),ye=We-Ee+N}else We=Jg(v,C,T,S,U,E,We),ye=We*o+N,Ee=We-ye;ye<1&&(ye=0),Ne>=Ee/2&&(Ne=0),ye<5&&(G=s0);let Bt=ye>0,In=We-ye-(Bt?Ne:0);Ee=G(zd(In,q,W)),ge=(V==0?Ee/2:V==J?0:Ee)-V*J*((V==0?N/2:0)+(Bt?Ne/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Mn=Le?null:new Path2D,nn=null;if(de!=null)nn=d.data[de.series[1]];else{let{y0:Re,y1:Ze}=c;Re!=null&&Ze!=null&&(C=Ze.values(d,p,b,m),nn=Re.values(d,p,b,m))}let fn=O*Ee,B=re*Ee;for(let Re=J==1?b:m;Re>=b&&Re<=m;Re+=J){let Ze=C[Re];if(Ze==null)continue;if(nn!=null){let $=nn[Re]??0;if(Ze-$==0)continue;me=x($,I,L,H)}let lt=S.distr!=2||c!=null?v[Re]:Re,Me=T(lt,S,U,E),zt=x(wt(Ze,Q),I,L,H),Ge=G(Me-ge),Ye=G(ai(zt,me)),R=G(Zi(zt,me)),M=Ye-R;if(Ze!=null){let $=Ze<0?B:fn,ue=Ze<0?fn:B;Le?(Ne>0&&rt[Re]!=null&&ee(Qt.get(rt[Re]),Ge,R+Ei(Ne/2),Ee,ai(0,M-Ne),$,ue),at[Re]!=null&&ee(ut.get(at[Re]),Ge,R+Ei(Ne/2),Ee,ai(0,M-Ne),$,ue)):ee(Mn,Ge,R+Ei(Ne/2),Ee,ai(0,M-Ne),$,ue),ie(d,p,Re,Ge-Ne/2,R,Ee+Ne,M)}}return Ne>0?bt.stroke=Le?Qt:Mn:Le||(bt._fill=g.width==0?g._fill:g._stroke??g._fill,bt.width=0),bt.fill=Le?ut:Mn,bt})}function FS(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>Gr(i,s,(a,l,c,u,f,h,d,p,b,m,g)=>{[r,o]=_c(c,r,o);let v=a.pxRound,C=O=>v(h(O,u,m,p)),S=O=>v(d(O,f,g,b)),I,T,x;u.ori==0?(I=Sc,x=Ao,T=I0):(I=Mc,x=To,T=L0);let E=u.dir*(u.ori==0?1:-1),H=C(l[E==1?r:o]),U=H,L=[],G=[];for(let O=E==1?r:o;O>=r&&O<=o;O+=E)if(c[O]!=null){let J=l[O],ee=C(J);L.push(U=ee),G.push(S(c[O]))}let V={stroke:n(L,G,I,x,T,v),fill:null,clip:null,band:null,gaps:null,flags:Mo},N=V.stroke,[W,q]=sf(i,s);if(a.fill!=null||W!=0){let O=V.fill=new Path2D(N),re=a.fillTo(i,s,a.min,a.max,W),J=S(re);x(O,U,J),x(O,H,J)}if(!a.spanGaps){let O=[];O.push(...rf(l,c,r,o,E,C,t)),V.gaps=O=a.gaps(i,s,r,o,O),V.clip=bc(O,u.ori,p,b,m,g)}return q!=0&&(V.band=q==2?[Ns(i,s,r,o,N,-1),Ns(i,s,r,o,N,1)]:Ns(i,s,r,o,N,q)),V})}function BS(n){return FS(kS,n)}function kS(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var Wd=new Set;function Zg(){for(let n of Wd)n.syncRect(!0)}wo&&(Vr(yb,yo,Zg),Vr(vb,yo,Zg,!0),Vr(pc,yo,()=>{Xn.pxRatio=Et}));var zS=U0(),VS=D0();function Kg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Xd(r,o,e,t))}function HS(n,e){return n.map((t,i)=>i==0?{}:yn({},e,t))}function Xd(n,e,t,i){return yn({},e==0?t:i,n)}function O0(n,e,t){return e==null?bo:[e,t]}var GS=O0;function WS(n,e,t){return e==null?bo:mc(e,t,Zd,!0)}function F0(n,e,t,i){return e==null?bo:xc(e,t,n.scales[i].log,!1)}var XS=F0;function B0(n,e,t,i){return e==null?bo:Jd(e,t,n.scales[i].log,!1)}var $S=B0;function qS(n,e,t,i,s){let r=ai(Rg(n),Rg(e)),o=e-n,a=Ji(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?cr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function jg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Tn((t=+s)*Et))+"px"),[n,e,t]}function YS(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Xt(e[2]*Et,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Xn(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(_,w,P,D){let X=w.valToPct(_);return D+P*(w.dir==-1?1-X:X)}function o(_,w,P,D){let X=w.valToPct(_);return D+P*(w.dir==-1?X:1-X)}function a(_,w,P,D){return w.ori==0?r(_,w,P,D):o(_,w,P,D)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ki(tb);if(n.id!=null&&(c.id=n.id),Ti(c,n.class),n.title){let _=ki(sb,c);_.textContent=n.title}let u=Yi("canvas"),f=i.ctx=u.getContext("2d"),h=ki(rb,c);Vr("click",h,_=>{_.target===p&&(Yt!=ho||en!=fo)&&Gn.click(i,_)},!0);let d=i.under=ki(ob,h);h.appendChild(u);let p=i.over=ki(ab,h);n=So(n);let b=+wt(n.pxAlign,1),m=Yg(b);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let g=n.ms||.001,v=i.series=s==1?Kg(n.series||[],Vg,$g,!1):HS(n.series||[null],Xg),C=i.axes=Kg(n.axes||[],zg,Gg,!0),S=i.scales={},I=i.bands=n.bands||[];I.forEach(_=>{_.fill=yt(_.fill||null),_.dir=wt(_.dir,-1)});let T=s==2?v[1].facets[0].scale:v[0].scale,x={axes:Es,series:gt},E=(n.drawOrder||["axes","series"]).map(_=>x[_]);function H(_){let w=_.distr==3?P=>Ds(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>Ld(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let D=w(P),{_min:X,_max:K}=_,le=K-X;return(D-X)/le}}function U(_){let w=S[_];if(w==null){let P=(n.scales||za)[_]||za;if(P.from!=null){U(P.from);let D=yn({},S[P.from],P,{key:_});D.valToPct=H(D),S[_]=D}else{w=S[_]=yn({},_==T?T0:PS,P),w.key=_;let D=w.time,X=w.range,K=lr(X);if((_!=T||s==2&&!D)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?Tg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?Tg:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&vc(X))){let le=X;X=(fe,be,Ue)=>be==null?bo:mc(be,Ue,le)}w.range=yt(X||(D?GS:_==T?w.distr==3?XS:w.distr==4?$S:O0:w.distr==3?F0:w.distr==4?B0:WS)),w.auto=yt(K?!1:w.auto),w.clamp=yt(w.clamp||RS),w._min=w._max=null,w.valToPct=H(w)}}}U("x"),U("y"),s==1&&v.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in n.scales)U(_);let L=S[T],G=L.distr,V,N;L.ori==0?(Ti(c,nb),V=r,N=o):(Ti(c,ib),V=o,N=r);let W={};for(let _ in S){let w=S[_];(w.min!=null||w.max!=null)&&(W[_]={min:w.min,max:w.max},w.min=w.max=null)}let q=n.tzDate||(_=>new Date(Tn(_/g))),O=n.fmtDate||Qd,re=g==1?nS(q):rS(q),J=Fg(q,Og(g==1?tS:sS,O)),ee=kg(q,Bg(aS,O)),ie=[],de=i.legend=yn({},uS,n.legend),he=i.cursor=yn({},gS,{drag:{y:s==2}},n.cursor),Q=de.show,me=he.show,ge=de.markers;de.idxs=ie,ge.width=yt(ge.width),ge.dash=yt(ge.dash),ge.stroke=yt(ge.stroke),ge.fill=yt(ge.fill);let Ee,ye,We,Ne=[],Le=[],at,ut=!1,rt={};if(de.live){let _=v[1]?v[1].values:null;ut=_!=null,at=ut?_(i,1,0):{_:0};for(let w in at)rt[w]=qd}if(Q)if(Ee=Yi("table",fb,c),We=Yi("tbody",null,Ee),de.mount(i,Ee),ut){ye=Yi("thead",null,Ee,We);let _=Yi("tr",null,ye);Yi("th",null,_);for(var Qt in at)Yi("th",fg,_).textContent=Qt}else Ti(Ee,mb),de.live&&Ti(Ee,pb);let $t={show:!0},dn={show:!1};function Bt(_,w){if(w==0&&(ut||!de.live||s==2))return bo;let P=[],D=Yi("tr",gb,We,We.childNodes[w]);Ti(D,_.class),_.show||Ti(D,zr);let X=Yi("th",null,D);if(ge.show){let fe=ki(_b,X);if(w>0){let be=ge.width(i,w);be&&(fe.style.border=be+"px "+ge.dash(i,w)+" "+ge.stroke(i,w)),fe.style.background=ge.fill(i,w)}}let K=ki(fg,X);_.label instanceof HTMLElement?K.appendChild(_.label):K.textContent=_.label,w>0&&(ge.show||(K.style.color=_.width>0?ge.stroke(i,w):ge.fill(i,w)),bt("click",X,fe=>{if(he._lock)return;et(fe);let be=v.indexOf(_);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let Ue=v.some((Oe,ke)=>ke>0&&ke!=be&&Oe.show);v.forEach((Oe,ke)=>{ke>0&&us(ke,Ue?ke==be?$t:dn:$t,!0,_n.setSeries)})}else us(be,{show:!_.show},!0,_n.setSeries)},!1),tt&&bt(_g,X,fe=>{he._lock||(et(fe),us(v.indexOf(_),mo,!0,_n.setSeries))},!1));for(var le in at){let fe=Yi("td",xb,D);fe.textContent="--",P.push(fe)}return[D,P]}let In=new Map;function bt(_,w,P,D=!0){let X=In.get(w)||{},K=he.bind[_](i,w,P,D);K&&(Vr(_,w,X[_]=K),In.set(w,X))}function Mn(_,w,P){let D=In.get(w)||{};for(let X in D)(_==null||X==_)&&(kd(X,w,D[X]),delete D[X]);_==null&&In.delete(w)}let nn=0,fn=0,B=0,Re=0,Ze=0,lt=0,Me=Ze,zt=lt,Ge=B,Ye=Re,R=0,M=0,$=0,ue=0;i.bbox={};let ae=!1,xe=!1,ve=!1,te=!1,se=!1,pe=!1;function F(_,w,P){(P||_!=i.width||w!=i.height)&&oe(_,w),ft(!1),ve=!0,xe=!0,Jn()}function oe(_,w){i.width=nn=B=_,i.height=fn=Re=w,Ze=lt=0,Se(),Xe();let P=i.bbox;R=P.left=Br(Ze*Et,.5),M=P.top=Br(lt*Et,.5),$=P.width=Br(B*Et,.5),ue=P.height=Br(Re*Et,.5)}let ne=3;function we(){let _=!1,w=0;for(;!_;){w++;let P=lo(w),D=cs(w);_=w==ne||P&&D,_||(oe(i.width,i.height),xe=!0)}}function _e({width:_,height:w}){F(_,w)}i.setSize=_e;function Se(){let _=!1,w=!1,P=!1,D=!1;C.forEach((X,K)=>{if(X.show&&X._show){let{side:le,_size:fe}=X,be=le%2,Ue=X.label!=null?X.labelSize:0,Oe=fe+Ue;Oe>0&&(be?(B-=Oe,le==3?(Ze+=Oe,D=!0):P=!0):(Re-=Oe,le==0?(lt+=Oe,_=!0):w=!0))}}),as[0]=_,as[1]=P,as[2]=w,as[3]=D,B-=Wi[1]+Wi[3],Ze+=Wi[3],Re-=Wi[2]+Wi[0],lt+=Wi[0]}function Xe(){let _=Ze+B,w=lt+Re,P=Ze,D=lt;function X(K,le){switch(K){case 1:return _+=le,_-le;case 2:return w+=le,w-le;case 3:return P-=le,P+le;case 0:return D-=le,D+le}}C.forEach((K,le)=>{if(K.show&&K._show){let fe=K.side;K._pos=X(fe,K._size),K.label!=null&&(K._lpos=X(fe,K.labelSize))}})}if(he.dataIdx==null){let _=he.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let P=_.prox=yt(_.prox),D=_.bias??=0;he.dataIdx=(X,K,le,fe)=>{if(K==0)return le;let be=le,Ue=P(X,K,le,fe)??Wt,Oe=Ue>=0&&Ue<Wt,ke=L.ori==0?B:Re,ot=he.left,At=e[0],Mt=e[K];if(w.has(Mt[le])){be=null;let _t=null,je=null,qe;if(D==0||D==-1)for(qe=le;_t==null&&qe-- >0;)w.has(Mt[qe])||(_t=qe);if(D==0||D==1)for(qe=le;je==null&&qe++<Mt.length;)w.has(Mt[qe])||(je=qe);if(_t!=null||je!=null)if(Oe){let Zt=_t==null?-1/0:V(At[_t],L,ke,0),on=je==null?1/0:V(At[je],L,ke,0),Un=ot-Zt,kt=on-ot;Un<=kt?Un<=Ue&&(be=_t):kt<=Ue&&(be=je)}else be=je==null?_t:_t==null?je:le-_t<=je-le?_t:je}else Oe&&En(ot-V(At[le],L,ke,0))>Ue&&(be=null);return be}}let et=_=>{he.event=_};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=yt(ce.show),ce.size=yt(ce.size),ce.stroke=yt(ce.stroke),ce.width=yt(ce.width),ce.fill=yt(ce.fill);let ze=i.focus=yn({},n.focus||{alpha:.3},he.focus),tt=ze.prox>=0,Ce=tt&&ce.one,ht=[],qt=[],ni=[];function va(_,w){let P=ce.show(i,w);if(P instanceof HTMLElement)return Ti(P,db),Ti(P,_.class),ps(P,-10,-10,B,Re),p.insertBefore(P,ht[w]),P}function ro(_,w){if(s==1||w>0){let P=s==1&&S[_.scale].time,D=_.value;_.value=P?Lg(D)?kg(q,Bg(D,O)):D||ee:D||TS,_.label=_.label||(P?xS:_S)}if(Ce||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||zS||Pb,_.fillTo=yt(_.fillTo||IS),_.pxAlign=+wt(_.pxAlign,b),_.pxRound=Yg(_.pxAlign),_.stroke=yt(_.stroke||null),_.fill=yt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=ES(ai(1,_.width),1),D=_.points=yn({},{size:P,width:ai(1,P*.2),stroke:_.stroke,space:P*2,paths:VS,_stroke:null,_fill:null},_.points);D.show=yt(D.show),D.filter=yt(D.filter),D.fill=yt(D.fill),D.stroke=yt(D.stroke),D.paths=yt(D.paths),D.pxAlign=_.pxAlign}if(Q){let P=Bt(_,w);Ne.splice(w,0,P[0]),Le.splice(w,0,P[1]),de.values.push(null)}if(me){ie.splice(w,0,null);let P=null;Ce?w==0&&(P=va(_,w)):w>0&&(P=va(_,w)),ht.splice(w,0,P),qt.splice(w,0,0),ni.splice(w,0,0)}Nn("addSeries",w)}function td(_,w){w=w??v.length,_=s==1?Xd(_,w,Vg,$g):Xd(_,w,{},Xg),v.splice(w,0,_),ro(v[w],w)}i.addSeries=td;function Vl(_){if(v.splice(_,1),Q){de.values.splice(_,1),Le.splice(_,1);let w=Ne.splice(_,1)[0];Mn(null,w.firstChild),w.remove()}me&&(ie.splice(_,1),ht.splice(_,1)[0].remove(),qt.splice(_,1),ni.splice(_,1)),Nn("delSeries",_)}i.delSeries=Vl;let as=[!1,!1,!1,!1];function ws(_,w){if(_._show=_.show,_.show){let P=_.side%2,D=S[_.scale];D==null&&(_.scale=P?v[1].scale:T,D=S[_.scale]);let X=D.time;_.size=yt(_.size),_.space=yt(_.space),_.rotate=yt(_.rotate),lr(_.incrs)&&_.incrs.forEach(le=>{!cr.has(le)&&cr.set(le,a0(le))}),_.incrs=yt(_.incrs||(D.distr==2?jb:X?g==1?eS:iS:kr)),_.splits=yt(_.splits||(X&&D.distr==1?re:D.distr==3?Vd:D.distr==4?bS:vS)),_.stroke=yt(_.stroke),_.grid.stroke=yt(_.grid.stroke),_.ticks.stroke=yt(_.ticks.stroke),_.border.stroke=yt(_.border.stroke);let K=_.values;_.values=lr(K)&&!lr(K[0])?yt(K):X?lr(K)?Fg(q,Og(K,O)):Lg(K)?oS(q,K):K||J:K||yS,_.filter=yt(_.filter||(D.distr>=3&&D.log==10?wS:D.distr==3&&D.log==2?AS:r0)),_.font=jg(_.font),_.labelFont=jg(_.labelFont),_._size=_.size(i,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(as[w]=!0,_._el=ki(lb,h))}}function As(_,w,P,D){let[X,K,le,fe]=P,be=w%2,Ue=0;return be==0&&(fe||K)&&(Ue=w==0&&!X||w==2&&!le?Tn(zg.size/3):0),be==1&&(X||le)&&(Ue=w==1&&!K||w==3&&!fe?Tn(Gg.size/2):0),Ue}let ba=i.padding=(n.padding||[As,As,As,As]).map(_=>yt(wt(_,As))),Wi=i._padding=ba.map((_,w)=>_(i,w,as,0)),sn,ln=null,cn=null,ls=s==1?v[0].idxs:null,bi=null,Ks=!1;function Sa(_,w){if(e=_??[],i.data=i._data=e,s==2){sn=0;for(let P=1;P<v.length;P++)sn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),bi=e[0],sn=bi.length;let P=e;if(G==2){P=e.slice();let D=P[0]=Array(sn);for(let X=0;X<sn;X++)D[X]=X}i._data=e=P}if(ft(!0),Nn("setData"),G==2&&(ve=!0),w!==!1){let P=L;P.auto(i,Ks)?Ma():er(T,P.min,P.max),te=te||he.left>=0,pe=!0,Jn()}}i.setData=Sa;function Ma(){Ks=!0;let _,w;s==1&&(sn>0?(ln=ls[0]=0,cn=ls[1]=sn-1,_=e[0][ln],w=e[0][cn],G==2?(_=ln,w=cn):_==w&&(G==3?[_,w]=xc(_,_,L.log,!1):G==4?[_,w]=Jd(_,_,L.log,!1):L.time?w=_+Tn(86400/g):[_,w]=mc(_,w,Zd,!0))):(ln=ls[0]=_=null,cn=ls[1]=w=null)),er(T,_,w)}let oo,js,ao,A,k,j,Y,Z,Ae,Ie;function Te(_,w,P,D,X,K){_??=mg,P??=jd,D??="butt",X??=mg,K??="round",_!=oo&&(f.strokeStyle=oo=_),X!=js&&(f.fillStyle=js=X),w!=ao&&(f.lineWidth=ao=w),K!=k&&(f.lineJoin=k=K),D!=j&&(f.lineCap=j=D),P!=A&&f.setLineDash(A=P)}function De(_,w,P,D){w!=js&&(f.fillStyle=js=w),_!=Y&&(f.font=Y=_),P!=Z&&(f.textAlign=Z=P),D!=Ae&&(f.textBaseline=Ae=D)}function He(_,w,P,D,X=0){if(D.length>0&&_.auto(i,Ks)&&(w==null||w.min==null)){let K=wt(ln,0),le=wt(cn,D.length-1),fe=P.min==null?wb(D,K,le,X,_.distr==3):[P.min,P.max];_.min=Zi(_.min,P.min=fe[0]),_.max=ai(_.max,P.max=fe[1])}}let nt={min:null,max:null};function mt(){for(let D in S){let X=S[D];W[D]==null&&(X.min==null||W[T]!=null&&X.auto(i,Ks))&&(W[D]=nt)}for(let D in S){let X=S[D];W[D]==null&&X.from!=null&&W[X.from]!=null&&(W[D]=nt)}W[T]!=null&&ft(!0);let _={};for(let D in W){let X=W[D];if(X!=null){let K=_[D]=So(S[D],Db);if(X.min!=null)yn(K,X);else if(D!=T||s==2)if(sn==0&&K.from==null){let le=K.range(i,null,null,D);K.min=le[0],K.max=le[1]}else K.min=Wt,K.max=-Wt}}if(sn>0){v.forEach((D,X)=>{if(s==1){let K=D.scale,le=W[K];if(le==null)return;let fe=_[K];if(X==0){let be=fe.range(i,fe.min,fe.max,K);fe.min=be[0],fe.max=be[1],ln=Ji(fe.min,e[0]),cn=Ji(fe.max,e[0]),cn-ln>1&&(e[0][ln]<fe.min&&ln++,e[0][cn]>fe.max&&cn--),D.min=bi[ln],D.max=bi[cn]}else D.show&&D.auto&&He(fe,le,D,e[X],D.sorted);D.idxs[0]=ln,D.idxs[1]=cn}else if(X>0&&D.show&&D.auto){let[K,le]=D.facets,fe=K.scale,be=le.scale,[Ue,Oe]=e[X],ke=_[fe],ot=_[be];ke!=null&&He(ke,W[fe],K,Ue,K.sorted),ot!=null&&He(ot,W[be],le,Oe,le.sorted),D.min=le.min,D.max=le.max}});for(let D in _){let X=_[D],K=W[D];if(X.from==null&&(K==null||K.min==null)){let le=X.range(i,X.min==Wt?null:X.min,X.max==-Wt?null:X.max,D);X.min=le[0],X.max=le[1]}}}for(let D in _){let X=_[D];if(X.from!=null){let K=_[X.from];if(K.min==null)X.min=X.max=null;else{let le=X.range(i,K.min,K.max,D);X.min=le[0],X.max=le[1]}}}let w={},P=!1;for(let D in _){let X=_[D],K=S[D];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let le=K.distr;K._min=le==3?Ds(K.min):le==4?Ld(K.min,K.asinh):le==100?K.fwd(K.min):K.min,K._max=le==3?Ds(K.max):le==4?Ld(K.max,K.asinh):le==100?K.fwd(K.max):K.max,w[D]=P=!0}}if(P){v.forEach((D,X)=>{s==2?X>0&&w.y&&(D._paths=null):w[D.scale]&&(D._paths=null)});for(let D in w)ve=!0,Nn("setScale",D);me&&he.left>=0&&(te=pe=!0)}for(let D in W)W[D]=null}function Ve(_){let w=zd(ln-1,0,sn-1),P=zd(cn+1,0,sn-1);for(;_[w]==null&&w>0;)w--;for(;_[P]==null&&P<sn-1;)P++;return[w,P]}function gt(){if(sn>0){let _=v.some(w=>w._focus)&&Ie!=ze.alpha;_&&(f.globalAlpha=Ie=ze.alpha),v.forEach((w,P)=>{if(P>0&&w.show&&(tn(P,!1),tn(P,!0),w._paths==null)){let D=Ie;Ie!=w.alpha&&(f.globalAlpha=Ie=w.alpha);let X=s==2?[0,e[P][0].length-1]:Ve(e[P]);w._paths=w.paths(i,P,X[0],X[1]),Ie!=D&&(f.globalAlpha=Ie=D)}}),v.forEach((w,P)=>{if(P>0&&w.show){let D=Ie;Ie!=w.alpha&&(f.globalAlpha=Ie=w.alpha),w._paths!=null&&Dt(P,!1);{let X=w._paths!=null?w._paths.gaps:null,K=w.points.show(i,P,ln,cn,X),le=w.points.filter(i,P,K,X);(K||le)&&(w.points._paths=w.points.paths(i,P,ln,cn,le),Dt(P,!0))}Ie!=D&&(f.globalAlpha=Ie=D),Nn("drawSeries",P)}}),_&&(f.globalAlpha=Ie=1)}}function tn(_,w){let P=w?v[_].points:v[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function Dt(_,w){let P=w?v[_].points:v[_],{stroke:D,fill:X,clip:K,flags:le,_stroke:fe=P._stroke,_fill:be=P._fill,_width:Ue=P.width}=P._paths;Ue=Xt(Ue*Et,3);let Oe=null,ke=Ue%2/2;w&&be==null&&(be=Ue>0?"#fff":fe);let ot=P.pxAlign==1&&ke>0;if(ot&&f.translate(ke,ke),!w){let At=R-Ue/2,Mt=M-Ue/2,_t=$+Ue,je=ue+Ue;Oe=new Path2D,Oe.rect(At,Mt,_t,je)}w?Be(fe,Ue,P.dash,P.cap,be,D,X,le,K):Nt(_,fe,Ue,P.dash,P.cap,be,D,X,le,Oe,K),ot&&f.translate(-ke,-ke)}function Nt(_,w,P,D,X,K,le,fe,be,Ue,Oe){let ke=!1;be!=0&&I.forEach((ot,At)=>{if(ot.series[0]==_){let Mt=v[ot.series[1]],_t=e[ot.series[1]],je=(Mt._paths||za).band;lr(je)&&(je=ot.dir==1?je[0]:je[1]);let qe,Zt=null;Mt.show&&je&&Tb(_t,ln,cn)?(Zt=ot.fill(i,At)||K,qe=Mt._paths.clip):je=null,Be(w,P,D,X,Zt,le,fe,be,Ue,Oe,qe,je),ke=!0}}),ke||Be(w,P,D,X,K,le,fe,be,Ue,Oe)}let wn=Mo|Gd;function Be(_,w,P,D,X,K,le,fe,be,Ue,Oe,ke){Te(_,w,P,D,X),(be||Ue||ke)&&(f.save(),be&&f.clip(be),Ue&&f.clip(Ue)),ke?(fe&wn)==wn?(f.clip(ke),Oe&&f.clip(Oe),xt(X,le),pn(_,K,w)):fe&Gd?(xt(X,le),f.clip(ke),pn(_,K,w)):fe&Mo&&(f.save(),f.clip(ke),Oe&&f.clip(Oe),xt(X,le),f.restore(),pn(_,K,w)):(xt(X,le),pn(_,K,w)),(be||Ue||ke)&&f.restore()}function pn(_,w,P){P>0&&(w instanceof Map?w.forEach((D,X)=>{f.strokeStyle=oo=X,f.stroke(D)}):w!=null&&_&&f.stroke(w))}function xt(_,w){w instanceof Map?w.forEach((P,D)=>{f.fillStyle=js=D,f.fill(P)}):w!=null&&_&&f.fill(w)}function Ts(_,w,P,D){let X=C[_],K;if(D<=0)K=[0,0];else{let le=X._space=X.space(i,_,w,P,D),fe=X._incrs=X.incrs(i,_,w,P,D,le);K=qS(w,P,fe,D,le)}return X._found=K}function mn(_,w,P,D,X,K,le,fe,be,Ue){let Oe=le%2/2;b==1&&f.translate(Oe,Oe),Te(fe,le,be,Ue,fe),f.beginPath();let ke,ot,At,Mt,_t=X+(D==0||D==3?-K:K);P==0?(ot=X,Mt=_t):(ke=X,At=_t);for(let je=0;je<_.length;je++)w[je]!=null&&(P==0?ke=At=_[je]:ot=Mt=_[je],f.moveTo(ke,ot),f.lineTo(At,Mt));f.stroke(),b==1&&f.translate(-Oe,-Oe)}function lo(_){let w=!0;return C.forEach((P,D)=>{if(!P.show)return;let X=S[P.scale];if(X.min==null){P._show&&(w=!1,P._show=!1,ft(!1));return}else P._show||(w=!1,P._show=!0,ft(!1));let K=P.side,le=K%2,{min:fe,max:be}=X,[Ue,Oe]=Ts(D,fe,be,le==0?B:Re);if(Oe==0)return;let ke=X.distr==2,ot=P._splits=P.splits(i,D,fe,be,Ue,Oe,ke),At=X.distr==2?ot.map(qe=>bi[qe]):ot,Mt=X.distr==2?bi[ot[1]]-bi[ot[0]]:Ue,_t=P._values=P.values(i,P.filter(i,At,D,Oe,Mt),D,Oe,Mt);P._rotate=K==2?P.rotate(i,_t,D,Oe):0;let je=P._size;P._size=zi(P.size(i,_t,D,_)),je!=null&&P._size!=je&&(w=!1)}),w}function cs(_){let w=!0;return ba.forEach((P,D)=>{let X=P(i,D,as,_);X!=Wi[D]&&(w=!1),Wi[D]=X}),w}function Es(){for(let _=0;_<C.length;_++){let w=C[_];if(!w.show||!w._show)continue;let P=w.side,D=P%2,X,K,le=w.stroke(i,_),fe=P==0||P==3?-1:1,[be,Ue]=w._found;if(w.label!=null){let ri=w.labelGap*fe,wi=Tn((w._lpos+ri)*Et);De(w.labelFont[0],le,"center",P==2?"top":pg),f.save(),D==1?(X=K=0,f.translate(wi,Tn(M+ue/2)),f.rotate((P==3?-fc:fc)/2)):(X=Tn(R+$/2),K=wi);let Nr=i0(w.label)?w.label(i,_,be,Ue):w.label;f.fillText(Nr,X,K),f.restore()}if(Ue==0)continue;let Oe=S[w.scale],ke=D==0?$:ue,ot=D==0?R:M,At=w._splits,Mt=Oe.distr==2?At.map(ri=>bi[ri]):At,_t=Oe.distr==2?bi[At[1]]-bi[At[0]]:be,je=w.ticks,qe=w.border,Zt=je.show?je.size:0,on=Tn(Zt*Et),Un=Tn((w.alignTo==2?w._size-Zt-w.gap:w.gap)*Et),kt=w._rotate*-fc/180,an=m(w._pos*Et),Si=(on+Un)*fe,si=an+Si;K=D==0?si:0,X=D==1?si:0;let Oi=w.font[0],Xi=w.align==1?_o:w.align==2?Rd:kt>0?_o:kt<0?Rd:D==0?"center":P==3?Rd:_o,ds=kt||D==1?"middle":P==2?"top":pg;De(Oi,le,Xi,ds);let Mi=w.font[1]*w.lineGap,Fi=At.map(ri=>m(a(ri,Oe,ke,ot))),$i=w._values;for(let ri=0;ri<$i.length;ri++){let wi=$i[ri];if(wi!=null){D==0?X=Fi[ri]:K=Fi[ri],wi=""+wi;let Nr=wi.indexOf(`
`)==-1?[wi]:wi.split(/\n/gm);for(let oi=0;oi<Nr.length;oi++){let Em=Nr[oi];kt?(f.save(),f.translate(X,K+oi*Mi),f.rotate(kt),f.fillText(Em,0,0),f.restore()):f.fillText(Em,X,K+oi*Mi)}}}je.show&&mn(Fi,je.filter(i,Mt,_,Ue,_t),D,P,an,on,Xt(je.width*Et,3),je.stroke(i,_),je.dash,je.cap);let fs=w.grid;fs.show&&mn(Fi,fs.filter(i,Mt,_,Ue,_t),D,D==0?2:1,D==0?M:R,D==0?ue:$,Xt(fs.width*Et,3),fs.stroke(i,_),fs.dash,fs.cap),qe.show&&mn([an],[1],D==0?1:0,D==0?1:2,D==1?M:R,D==1?ue:$,Xt(qe.width*Et,3),qe.stroke(i,_),qe.dash,qe.cap)}Nn("drawAxes")}function ft(_){v.forEach((w,P)=>{P>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(D=>{D.min=null,D.max=null})))})}let rn=!1,ii=!1,Ut=[];function gn(){ii=!1;for(let _=0;_<Ut.length;_++)Nn(...Ut[_]);Ut.length=0}function Jn(){rn||(zb(cm),rn=!0)}function Hl(_,w=!1){rn=!0,ii=w,_(i),cm(),w&&Ut.length>0&&queueMicrotask(gn)}i.batch=Hl;function cm(){if(ae&&(mt(),ae=!1),ve&&(we(),ve=!1),xe){if(Kt(d,_o,Ze),Kt(d,"top",lt),Kt(d,Oa,B),Kt(d,Fa,Re),Kt(p,_o,Ze),Kt(p,"top",lt),Kt(p,Oa,B),Kt(p,Fa,Re),Kt(h,Oa,nn),Kt(h,Fa,fn),u.width=Tn(nn*Et),u.height=Tn(fn*Et),C.forEach(({_el:_,_show:w,_size:P,_pos:D,side:X})=>{if(_!=null)if(w){let K=X===3||X===0?P:0,le=X%2==1;Kt(_,le?"left":"top",D-K),Kt(_,le?"width":"height",P),Kt(_,le?"top":"left",le?lt:Ze),Kt(_,le?"height":"width",le?Re:B),Bd(_,zr)}else Ti(_,zr)}),oo=js=ao=k=j=Y=Z=Ae=A=null,Ie=1,Ta(!0),Ze!=Me||lt!=zt||B!=Ge||Re!=Ye){ft(!1);let _=B/Ge,w=Re/Ye;if(me&&!te&&he.left>=0){he.left*=_,he.top*=w,co&&ps(co,Tn(he.left),0,B,Re),uo&&ps(uo,0,Tn(he.top),B,Re);for(let P=0;P<ht.length;P++){let D=ht[P];D!=null&&(qt[P]*=_,ni[P]*=w,ps(D,zi(qt[P]),zi(ni[P]),B,Re))}}if(Jt.show&&!se&&Jt.left>=0&&Jt.width>0){Jt.left*=_,Jt.width*=_,Jt.top*=w,Jt.height*=w;for(let P in ad)Kt(po,P,Jt[P])}Me=Ze,zt=lt,Ge=B,Ye=Re}Nn("setSize"),xe=!1}nn>0&&fn>0&&(f.clearRect(0,0,u.width,u.height),Nn("drawClear"),E.forEach(_=>_()),Nn("draw")),Jt.show&&se&&(Gl(Jt),se=!1),me&&te&&(Dr(null,!0,!1),te=!1),de.show&&de.live&&pe&&(rd(),pe=!1),l||(l=!0,i.status=1,Nn("ready")),Ks=!1,rn=!1}i.redraw=(_,w)=>{ve=w||!1,_!==!1?er(T,L.min,L.max):Jn()};function nd(_,w){let P=S[_];if(P.from==null){if(sn==0){let D=P.range(i,w.min,w.max,_);w.min=D[0],w.max=D[1]}if(w.min>w.max){let D=w.min;w.min=w.max,w.max=D}if(sn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==T&&P.distr==2&&sn>0&&(w.min=Ji(w.min,e[0]),w.max=Ji(w.max,e[0]),w.min==w.max&&w.max++),W[_]=w,ae=!0,Jn()}}i.setScale=nd;let id,sd,co,uo,um,hm,ho,fo,dm,fm,Yt,en,Qs=!1,Gn=he.drag,Ln=Gn.x,Dn=Gn.y;me&&(he.x&&(id=ki(ub,p)),he.y&&(sd=ki(hb,p)),L.ori==0?(co=id,uo=sd):(co=sd,uo=id),Yt=he.left,en=he.top);let Jt=i.select=yn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),po=Jt.show?ki(cb,Jt.over?p:d):null;function Gl(_,w){if(Jt.show){for(let P in _)Jt[P]=_[P],P in ad&&Kt(po,P,_[P]);w!==!1&&Nn("setSelect")}}i.setSelect=Gl;function wv(_){if(v[_].show)Q&&Bd(Ne[_],zr);else if(Q&&Ti(Ne[_],zr),me){let P=Ce?ht[0]:ht[_];P!=null&&ps(P,-10,-10,B,Re)}}function er(_,w,P){nd(_,{min:w,max:P})}function us(_,w,P,D){w.focus!=null&&Rv(_),w.show!=null&&v.forEach((X,K)=>{K>0&&(_==K||_==null)&&(X.show=w.show,wv(K),s==2?(er(X.facets[0].scale,null,null),er(X.facets[1].scale,null,null)):er(X.scale,null,null),Jn())}),P!==!1&&Nn("setSeries",_,w),D&&Ea("setSeries",i,_,w)}i.setSeries=us;function Av(_,w){yn(I[_],w)}function Tv(_,w){_.fill=yt(_.fill||null),_.dir=wt(_.dir,-1),w=w??I.length,I.splice(w,0,_)}function Ev(_){_==null?I.length=0:I.splice(_,1)}i.addBand=Tv,i.setBand=Av,i.delBand=Ev;function Cv(_,w){v[_].alpha=w,me&&ht[_]!=null&&(ht[_].style.opacity=w),Q&&Ne[_]&&(Ne[_].style.opacity=w)}let Cs,tr,Lr,mo={focus:!0};function Rv(_){if(_!=Lr){let w=_==null,P=ze.alpha!=1;v.forEach((D,X)=>{if(s==1||X>0){let K=w||X==0||X==_;D._focus=w?null:K,P&&Cv(X,K?1:ze.alpha)}}),Lr=_,P&&Jn()}}Q&&tt&&bt(xg,Ee,_=>{he._lock||(et(_),Lr!=null&&us(null,mo,!0,_n.setSeries))});function hs(_,w,P){let D=S[w];P&&(_=_/Et-(D.ori==1?lt:Ze));let X=B;D.ori==1&&(X=Re,_=X-_),D.dir==-1&&(_=X-_);let K=D._min,le=D._max,fe=_/X,be=K+(le-K)*fe,Ue=D.distr;return Ue==3?vo(10,be):Ue==4?Cb(be,D.asinh):Ue==100?D.bwd(be):be}function Pv(_,w){let P=hs(_,T,w);return Ji(P,e[0],ln,cn)}i.valToIdx=_=>Ji(_,e[0]),i.posToIdx=Pv,i.posToVal=hs,i.valToPos=(_,w,P)=>S[w].ori==0?r(_,S[w],P?$:B,P?R:0):o(_,S[w],P?ue:Re,P?M:0),i.setCursor=(_,w,P)=>{Yt=_.left,en=_.top,Dr(null,w,P)};function pm(_,w){Kt(po,_o,Jt.left=_),Kt(po,Oa,Jt.width=w)}function mm(_,w){Kt(po,"top",Jt.top=_),Kt(po,Fa,Jt.height=w)}let wa=L.ori==0?pm:mm,Aa=L.ori==1?pm:mm;function Iv(){if(Q&&de.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&ut)continue;let w=de.values[_],P=0;for(let D in w)Le[_][P++].firstChild.nodeValue=w[D]}}function rd(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((P,D)=>{ie[D]=P}):Lb(_.idx)||ie.fill(_.idx),de.idx=ie[0]),Q&&de.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ut)&&Lv(P,ie[P]);Iv()}pe=!1,w!==!1&&Nn("setLegend")}i.setLegend=rd;function Lv(_,w){let P=v[_],D=_==0&&G==2?bi:e[_],X;ut?X=P.values(i,_,w)??rt:(X=P.value(i,w==null?null:D[w],_,w),X=X==null?rt:{_:X}),de.values[_]=X}function Dr(_,w,P){dm=Yt,fm=en,[Yt,en]=he.move(i,Yt,en),he.left=Yt,he.top=en,me&&(co&&ps(co,Tn(Yt),0,B,Re),uo&&ps(uo,0,Tn(en),B,Re));let D,X=ln>cn;Cs=Wt,tr=null;let K=L.ori==0?B:Re,le=L.ori==1?B:Re;if(Yt<0||sn==0||X){D=he.idx=null;for(let fe=0;fe<v.length;fe++){let be=ht[fe];be!=null&&ps(be,-10,-10,B,Re)}tt&&us(null,mo,!0,_==null&&_n.setSeries),de.live&&(ie.fill(D),pe=!0)}else{let fe,be,Ue;s==1&&(fe=L.ori==0?Yt:en,be=hs(fe,T),D=he.idx=Ji(be,e[0],ln,cn),Ue=V(e[0][D],L,K,0));let Oe=-10,ke=-10,ot=0,At=0,Mt=!0,_t="",je="";for(let qe=s==2?1:0;qe<v.length;qe++){let Zt=v[qe],on=ie[qe],Un=on==null?null:s==1?e[qe][on]:e[qe][1][on],kt=he.dataIdx(i,qe,D,be),an=kt==null?null:s==1?e[qe][kt]:e[qe][1][kt];if(pe=pe||an!=Un||kt!=on,ie[qe]=kt,qe>0&&Zt.show){let Si=kt==null?-10:kt==D?Ue:V(s==1?e[0][kt]:e[qe][0][kt],L,K,0),si=an==null?-10:N(an,s==1?S[Zt.scale]:S[Zt.facets[1].scale],le,0);if(tt&&an!=null){let Oi=L.ori==1?Yt:en,Xi=En(ze.dist(i,qe,kt,si,Oi));if(Xi<Cs){let ds=ze.bias;if(ds!=0){let Mi=hs(Oi,Zt.scale),Fi=an>=0?1:-1,$i=Mi>=0?1:-1;$i==Fi&&($i==1?ds==1?an>=Mi:an<=Mi:ds==1?an<=Mi:an>=Mi)&&(Cs=Xi,tr=qe)}else Cs=Xi,tr=qe}}if(pe||Ce){let Oi,Xi;L.ori==0?(Oi=Si,Xi=si):(Oi=si,Xi=Si);let ds,Mi,Fi,$i,fs,ri,wi=!0,Nr=ce.bbox;if(Nr!=null){wi=!1;let oi=Nr(i,qe);Fi=oi.left,$i=oi.top,ds=oi.width,Mi=oi.height}else Fi=Oi,$i=Xi,ds=Mi=ce.size(i,qe);if(ri=ce.fill(i,qe),fs=ce.stroke(i,qe),Ce)qe==tr&&Cs<=ze.prox&&(Oe=Fi,ke=$i,ot=ds,At=Mi,Mt=wi,_t=ri,je=fs);else{let oi=ht[qe];oi!=null&&(qt[qe]=Fi,ni[qe]=$i,Ag(oi,ds,Mi,wi),Mg(oi,ri,fs),ps(oi,zi(Fi),zi($i),B,Re))}}}}if(Ce){let qe=ze.prox,Zt=Lr==null?Cs<=qe:Cs>qe||tr!=Lr;if(pe||Zt){let on=ht[0];on!=null&&(qt[0]=Oe,ni[0]=ke,Ag(on,ot,At,Mt),Mg(on,_t,je),ps(on,zi(Oe),zi(ke),B,Re))}}}if(Jt.show&&Qs)if(_!=null){let[fe,be]=_n.scales,[Ue,Oe]=_n.match,[ke,ot]=_.cursor.sync.scales,At=_.cursor.drag;if(Ln=At._x,Dn=At._y,Ln||Dn){let{left:Mt,top:_t,width:je,height:qe}=_.select,Zt=_.scales[ke].ori,on=_.posToVal,Un,kt,an,Si,si,Oi=fe!=null&&Ue(fe,ke),Xi=be!=null&&Oe(be,ot);Oi&&Ln?(Zt==0?(Un=Mt,kt=je):(Un=_t,kt=qe),an=S[fe],Si=V(on(Un,ke),an,K,0),si=V(on(Un+kt,ke),an,K,0),wa(Zi(Si,si),En(si-Si))):wa(0,K),Xi&&Dn?(Zt==1?(Un=Mt,kt=je):(Un=_t,kt=qe),an=S[be],Si=N(on(Un,ot),an,le,0),si=N(on(Un+kt,ot),an,le,0),Aa(Zi(Si,si),En(si-Si))):Aa(0,le)}else ld()}else{let fe=En(dm-um),be=En(fm-hm);if(L.ori==1){let ot=fe;fe=be,be=ot}Ln=Gn.x&&fe>=Gn.dist,Dn=Gn.y&&be>=Gn.dist;let Ue=Gn.uni;Ue!=null?Ln&&Dn&&(Ln=fe>=Ue,Dn=be>=Ue,!Ln&&!Dn&&(be>fe?Dn=!0:Ln=!0)):Gn.x&&Gn.y&&(Ln||Dn)&&(Ln=Dn=!0);let Oe,ke;Ln&&(L.ori==0?(Oe=ho,ke=Yt):(Oe=fo,ke=en),wa(Zi(Oe,ke),En(ke-Oe)),Dn||Aa(0,le)),Dn&&(L.ori==1?(Oe=ho,ke=Yt):(Oe=fo,ke=en),Aa(Zi(Oe,ke),En(ke-Oe)),Ln||wa(0,K)),!Ln&&!Dn&&(wa(0,0),Aa(0,0))}if(Gn._x=Ln,Gn._y=Dn,_==null){if(P){if(Tm!=null){let[fe,be]=_n.scales;_n.values[0]=fe!=null?hs(L.ori==0?Yt:en,fe):null,_n.values[1]=be!=null?hs(L.ori==1?Yt:en,be):null}Ea(Pd,i,Yt,en,B,Re,D)}if(tt){let fe=P&&_n.setSeries,be=ze.prox;Lr==null?Cs<=be&&us(tr,mo,!0,fe):Cs>be?us(null,mo,!0,fe):tr!=Lr&&us(tr,mo,!0,fe)}}pe&&(de.idx=D,rd()),w!==!1&&Nn("setCursor")}let nr=null;Object.defineProperty(i,"rect",{get(){return nr==null&&Ta(!1),nr}});function Ta(_=!1){_?nr=null:(nr=p.getBoundingClientRect(),Nn("syncRect",nr))}function gm(_,w,P,D,X,K,le){he._lock||Qs&&_!=null&&_.movementX==0&&_.movementY==0||(od(_,w,P,D,X,K,le,!1,_!=null),_!=null?Dr(null,!0,!0):Dr(w,!0,!1))}function od(_,w,P,D,X,K,le,fe,be){if(nr==null&&Ta(!1),et(_),_!=null)P=_.clientX-nr.left,D=_.clientY-nr.top;else{if(P<0||D<0){Yt=-10,en=-10;return}let[Ue,Oe]=_n.scales,ke=w.cursor.sync,[ot,At]=ke.values,[Mt,_t]=ke.scales,[je,qe]=_n.match,Zt=w.axes[0].side%2==1,on=L.ori==0?B:Re,Un=L.ori==1?B:Re,kt=Zt?K:X,an=Zt?X:K,Si=Zt?D:P,si=Zt?P:D;if(Mt!=null?P=je(Ue,Mt)?a(ot,S[Ue],on,0):-10:P=on*(Si/kt),_t!=null?D=qe(Oe,_t)?a(At,S[Oe],Un,0):-10:D=Un*(si/an),L.ori==1){let Oi=P;P=D,D=Oi}}be&&(w==null||w.cursor.event.type==Pd)&&((P<=1||P>=B-1)&&(P=Br(P,B)),(D<=1||D>=Re-1)&&(D=Br(D,Re))),fe?(um=P,hm=D,[ho,fo]=he.move(i,P,D)):(Yt=P,en=D)}let ad={width:0,height:0,left:0,top:0};function ld(){Gl(ad,!1)}let _m,xm,ym,vm;function bm(_,w,P,D,X,K,le){Qs=!0,Ln=Dn=Gn._x=Gn._y=!1,od(_,w,P,D,X,K,le,!0,!1),_!=null&&(bt(Id,Od,Sm,!1),Ea(gg,i,ho,fo,B,Re,null));let{left:fe,top:be,width:Ue,height:Oe}=Jt;_m=fe,xm=be,ym=Ue,vm=Oe}function Sm(_,w,P,D,X,K,le){Qs=Gn._x=Gn._y=!1,od(_,w,P,D,X,K,le,!1,!0);let{left:fe,top:be,width:Ue,height:Oe}=Jt,ke=Ue>0||Oe>0,ot=_m!=fe||xm!=be||ym!=Ue||vm!=Oe;if(ke&&ot&&Gl(Jt),Gn.setScale&&ke&&ot){let At=fe,Mt=Ue,_t=be,je=Oe;if(L.ori==1&&(At=be,Mt=Oe,_t=fe,je=Ue),Ln&&er(T,hs(At,T),hs(At+Mt,T)),Dn)for(let qe in S){let Zt=S[qe];qe!=T&&Zt.from==null&&Zt.min!=Wt&&er(qe,hs(_t+je,qe),hs(_t,qe))}ld()}else he.lock&&(he._lock=!he._lock,Dr(w,!0,_!=null));_!=null&&(Mn(Id,Od),Ea(Id,i,Yt,en,B,Re,null))}function Dv(_,w,P,D,X,K,le){if(he._lock)return;et(_);let fe=Qs;if(Qs){let be=!0,Ue=!0,Oe=10,ke,ot;L.ori==0?(ke=Ln,ot=Dn):(ke=Dn,ot=Ln),ke&&ot&&(be=Yt<=Oe||Yt>=B-Oe,Ue=en<=Oe||en>=Re-Oe),ke&&be&&(Yt=Yt<ho?0:B),ot&&Ue&&(en=en<fo?0:Re),Dr(null,!0,!0),Qs=!1}Yt=-10,en=-10,ie.fill(null),Dr(null,!0,!0),fe&&(Qs=fe)}function Mm(_,w,P,D,X,K,le){he._lock||(et(_),Ma(),ld(),_!=null&&Ea(yg,i,Yt,en,B,Re,null))}function wm(){C.forEach(YS),F(i.width,i.height,!0)}Vr(pc,yo,wm);let go={};go.mousedown=bm,go.mousemove=gm,go.mouseup=Sm,go.dblclick=Mm,go.setSeries=(_,w,P,D)=>{let X=_n.match[2];P=X(i,w,P),P!=-1&&us(P,D,!0,!1)},me&&(bt(gg,p,bm),bt(Pd,p,gm),bt(_g,p,_=>{et(_),Ta(!1)}),bt(xg,p,Dv),bt(yg,p,Mm),Wd.add(i),i.syncRect=Ta);let Wl=i.hooks=n.hooks||{};function Nn(_,w,P){ii?Ut.push([_,w,P]):_ in Wl&&Wl[_].forEach(D=>{D.call(null,i,w,P)})}(n.plugins||[]).forEach(_=>{for(let w in _.hooks)Wl[w]=(Wl[w]||[]).concat(_.hooks[w])});let Am=(_,w,P)=>P,_n=yn({key:null,setSeries:!1,filters:{pub:Pg,sub:Pg},scales:[T,v[1]?v[1].scale:null],match:[Ig,Ig,Am],values:[null,null]},he.sync);_n.match.length==2&&_n.match.push(Am),he.sync=_n;let Tm=_n.key,cd=E0(Tm);function Ea(_,w,P,D,X,K,le){_n.filters.pub(_,w,P,D,X,K,le)&&cd.pub(_,w,P,D,X,K,le)}cd.sub(i);function Nv(_,w,P,D,X,K,le){_n.filters.sub(_,w,P,D,X,K,le)&&go[_](null,w,P,D,X,K,le)}i.pub=Nv;function Uv(){cd.unsub(i),Wd.delete(i),In.clear(),kd(pc,yo,wm),c.remove(),Ee?.remove(),Nn("destroy")}i.destroy=Uv;function ud(){Nn("init",n,e),Sa(e||n.data,!1),W[T]?nd(T,W[T]):Ma(),se=Jt.show&&(Jt.width>0||Jt.height>0),te=pe=!0,F(n.width,n.height)}return v.forEach(ro),C.forEach(ws),t?t instanceof HTMLElement?(t.appendChild(c),ud()):t(i,ud):ud(),i}Xn.assign=yn;Xn.fmtNum=Kd;Xn.rangeNum=mc;Xn.rangeLog=xc;Xn.rangeAsinh=Jd;Xn.orient=Gr;Xn.pxRatio=Et;Xn.join=kb;Xn.fmtDate=Qd,Xn.tzDate=Zb;Xn.sync=E0;{Xn.addGap=LS,Xn.clipGaps=bc;let n=Xn.paths={points:D0};n.linear=U0,n.stepped=US,n.bars=OS,n.spline=BS}function Us(n,e,t=()=>!0){let[i,s]=Qe({value:void 0,error:"",path:n});return $e(()=>{if(n===null)return;let r=new AbortController,o=0,a=async()=>{let l=!0;try{let c=await Ai(n,r.signal);l=t(c),s({value:c,error:"",path:n})}catch(c){if(Rs(c))return;s(u=>({...u,error:Kn(c),path:n}))}l&&!r.signal.aborted&&(o=window.setTimeout(a,1e3*e))};return a(),()=>{r.abort(),clearTimeout(o)}},[n]),i.path===n?i:{value:void 0,error:""}}function Eo(){let[n,e]=Qe(0);return $e(()=>lc(()=>e(t=>t+1)),[]),n}function ur(n){$e(()=>{n!==null&&(document.title=n===""?"cdcluster":`${n} - cdcluster`)},[n])}var JS=4;function Co(n,e,t){let[i,s]=Qe({value:null,error:"",key:null,version:null,rests:0}),[r,o]=Qe(0),a=Tt(!1),l=Tt({version:e,load:t});return l.current={version:e,load:t},$e(()=>{if(n===null)return;let c=new AbortController,u=l.current.version,f=performance.now();a.current=!0;let h=(d,p)=>{a.current=!1;let b=performance.now();s(m=>({value:d??(m.key===n?m.value:null),error:p,key:n,version:u,rests:b+JS*(b-f)}))};return l.current.load(c.signal).then(d=>c.signal.aborted||h(d,""),d=>Rs(d)||c.signal.aborted||h(null,Kn(d))),()=>c.abort()},[n,r]),$e(()=>{if(i.key!==n||n===null||i.version===e||a.current)return;let c=setTimeout(()=>o(u=>u+1),Math.max(0,i.rests-performance.now()));return()=>clearTimeout(c)},[n,e,i]),i.key===n?i:{value:null,error:""}}var ZS=Symbol.for("pv"),KS=0;function y(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:ZS,__v:--KS,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Ot.vnode&&Ot.vnode(c),c}var k0=160;function jS(n,e,t){let i={stroke:qi("--muted"),grid:{stroke:qi("--line"),width:1},ticks:{stroke:qi("--line"),width:1,size:4},font:"11px system-ui, sans-serif"};return{width:e,height:k0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},hooks:{setCursor:[s=>t(s.cursor.idx??null)]},scales:{y:{range:(s,r,o)=>[0,Math.max(1.1*o,4)]}},axes:[{...i,size:28,space:70,values:"{HH}:{mm}:{ss}"},{...i,size:64,values:(s,r)=>r.map(o=>n.format(o))}],series:[{},...n.lines.map(s=>({stroke:qi(s.colour),width:1.5,...s.dash?{dash:s.dash}:{},points:{show:!1}}))]}}function af(n){let e=Tt(null),t=Tt(null),[i,s]=Qe(null),r=Eo(),o=[n.times,...n.lines.map(u=>u.values)];$e(()=>{let u=e.current;if(!u)return;let f=new Xn(jS(n,u.clientWidth||300,s),o,u);t.current=f;let h=new ResizeObserver(()=>f.setSize({width:u.clientWidth||300,height:k0}));return h.observe(u),()=>{h.disconnect(),f.destroy(),t.current=null}},[r]),$e(()=>t.current?.setData(o),[n.times,r]);let a=i!==null&&i<n.times.length?i:n.times.length-1,l=u=>n.format(u.values[a]??0),c=n.lines.map(u=>`${u.title} ${l(u)}`).join(", ");return y("figure",{class:"chart",children:[y("div",{ref:e,role:"img","aria-label":`${n.title}: ${c}`}),y("figcaption",{children:[n.lines.map(u=>y("span",{children:[y("svg",{viewBox:"0 0 18 4","aria-hidden":"true",children:y("line",{x1:0,x2:18,y1:2,y2:2,stroke:`var(${u.colour})`,"stroke-width":2,"stroke-dasharray":u.dash?.join(" ")??"none"})}),u.title," ",y("b",{children:l(u)})]},u.title)),y("span",{class:"note",children:i===null?"now":new Date(1e3*n.times[a]).toLocaleTimeString("en-GB")})]})]})}var Ac=["separate","touch","cross","inside","contact","undecided","failed","near"];var z0=[0,7,1,2,3,4,5,6],QS=[1,4,6,7,5,2,8,3];function Ha(n){return n===255?0:QS[n]}function lf(n){return n>=1&&n<=4}function V0(n){return lf(n)||n===7}function Os(n){return n===255?"not tested yet":Ac[n]}function Ro(n){let e=Ac.indexOf(n);return e<0?255:e}function H0(n){return n===255?"-":"STXICUFN"[n]}var eM=[[92,168,128],[232,188,38],[206,58,50],[146,36,92],[214,82,54],[132,112,186],[60,64,70],[240,140,40]],tM=[150,155,160];function Ki(n){return n===255?tM:eM[n]}function hr(n){let[e,t,i]=Ki(n);return`rgb(${e} ${t} ${i})`}function G0(n){return n===255?.12:[.3,.6,1,.9,.8,.5,.7,.45][n]}function Ft({text:n}){return y("bdi",{class:"name",title:n.slice(0,2e3),children:n===""?"(no name)":n.length>400?`${n.slice(0,400)}…`:n})}function Wr({kind:n}){return y("span",{class:`mark mark-${Os(n).split(" ")[0]}`,style:{background:hr(n)},"aria-hidden":"true",children:H0(n)})}function W0(n){return n.count===0&&!n.always?null:y("span",{class:`count ${n.count===0?"zero":""}`,children:[y(Wr,{kind:n.kind}),Os(n.kind)," ",y("b",{children:Fe(n.count)})]})}function Pt(n){return y("div",{class:`notice ${n.kind}`,role:n.kind==="bad"?"alert":"status",children:n.children})}function mi(n){return y("section",{class:`panel ${n.wide?"wide":""}`,"aria-label":n.title,children:[y("header",{children:[y("h2",{children:n.title}),n.note&&y("span",{class:"note",children:n.note})]}),n.children]})}function Tc({done:n,total:e}){let t=e===0?0:n/e;return y("span",{class:"progress",children:[y("progress",{max:1,value:t,"aria-label":`${Fe(n)} of ${Fe(e)}`}),y("span",{children:un(t)})]})}function Ec({text:n}){let[e,t]=Qe("");return y("button",{type:"button",class:"command",title:"copy",onClick:()=>cf(n,t),children:[y("code",{children:n}),y("span",{"aria-live":"polite",children:e||"copy"})]})}function cf(n,e){let t=s=>{e(s),setTimeout(()=>e(""),2e3)};(navigator.clipboard?.writeText(n)??Promise.reject(new Error)).then(()=>t("copied"),()=>t("the browser did not allow it"))}function nM(n,e){return typeof n=="number"&&typeof e=="number"?n-e:String(n).localeCompare(String(e),"en",{numeric:!0})}function dr(n){let[e,t]=Qe(null),i=n.columns.find(a=>a.key===e?.key),s=[...n.rows];i&&e?s.sort((a,l)=>(e.down?-1:1)*nM(i.value(a),i.value(l))):n.order&&s.sort(n.order);let r=a=>{let l=a.isNumber===!0;e?.key!==a.key?t({key:a.key,down:l}):t(e.down===l?{key:a.key,down:!l}:null)},o=a=>e?.key!==a.key?"none":e.down?"descending":"ascending";return y("div",{class:"table",tabIndex:0,role:"region","aria-label":n.caption,children:y("table",{children:[y("caption",{children:n.caption}),y("thead",{children:y("tr",{children:n.columns.map(a=>y("th",{scope:"col",class:a.isNumber?"number":"","aria-sort":o(a),children:y("button",{type:"button",onClick:()=>r(a),children:a.title})},a.key))})}),y("tbody",{children:[s.length===0&&y("tr",{children:y("td",{class:"empty",colSpan:n.columns.length,children:n.empty})}),s.map(a=>y("tr",{class:n.rowClass?.(a)??"",children:n.columns.map(l=>y("td",{class:l.isNumber?"number":"",children:l.cell(a)},l.key))},n.rowKey(a)))]})]})})}function X0(n){let e=n.scenarios_per_second??0;return n.state==="running"&&e>0?(n.scenarios-n.done)/e:NaN}var iM=[{key:"job",title:"job",cell:n=>y("a",{href:Ps(n.job),children:n.job}),value:n=>n.job},{key:"name",title:"name",cell:n=>y(Ft,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>y("span",{class:`state ${n.state==="failed"?"bad":n.state==="paused"?"warn":""}`,children:n.state}),value:n=>n.state},{key:"owner",title:"owner",cell:n=>y(Ft,{text:n.owner||"-"}),value:n=>n.owner??""},{key:"began",title:"began",cell:n=>(n.began??"").replace("T"," ").replace(/Z$/," UTC"),value:n=>n.began??""},{key:"scenarios",title:"scenarios",cell:n=>Fe(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"done",title:"done",cell:n=>y(Tc,{done:n.done,total:n.scenarios}),value:n=>n.done/Math.max(1,n.scenarios),isNumber:!0},{key:"contact",title:"in contact",cell:n=>n.done===0?"-":un(n.contact/n.done),value:n=>n.contact/Math.max(1,n.done),isNumber:!0},{key:"failed",title:"failed",cell:n=>y("span",{class:n.failed>0?"state bad":"",children:Fe(n.failed)}),value:n=>n.failed,isNumber:!0},{key:"rate",title:"rate",cell:n=>or(n.scenarios_per_second??0),value:n=>n.scenarios_per_second??0,isNumber:!0},{key:"eta",title:"ends in",cell:n=>Fr(X0(n)),value:n=>X0(n)||0,isNumber:!0}];function uf(n){return y(dr,{caption:"jobs",columns:iM,rows:n.jobs,rowKey:e=>e.job,...n.order?{order:n.order}:{},empty:"no job yet: cdctl run job.toml --master HOST:7600"})}function $0(){let{value:n,error:e}=Us("jobs",2);return ur("jobs"),$e(()=>pi("jobs",()=>({ready:n!==void 0,jobs:n?.jobs.map(t=>t.job)})),[n]),$e(()=>{n?.jobs.length===1&&n.jobs[0].job==="folder"&&Is(Ps("folder"))},[n]),n?y(Vt,{children:[e&&y(Pt,{kind:"bad",children:[e,"; below is what it said last"]}),y(uf,{jobs:n.jobs})]}):e?y(Pt,{kind:"bad",children:e}):y("p",{class:"wait",children:"asking for the jobs…"})}function Cc(n){let e=["lost","silent","quarantined","draining"],t=e.indexOf(n.split(" ")[0]);return t<0?e.length:t}var q0=["bad","bad","warn","warn",""],sM=[{key:"worker",title:"worker",cell:n=>n.worker,value:n=>n.worker},{key:"name",title:"name",cell:n=>y(Ft,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>y("span",{class:`state ${q0[Cc(n.state)]}`,children:n.state}),value:n=>n.state},{key:"threads",title:"threads",cell:n=>Fe(n.threads),value:n=>n.threads,isNumber:!0},{key:"working",title:"working",cell:n=>Fe(n.working),value:n=>n.working,isNumber:!0},{key:"done",title:"done",cell:n=>Fe(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"rate",title:"rate",cell:n=>or(n.scenarios_per_second),value:n=>n.scenarios_per_second,isNumber:!0},{key:"cache",title:"cache",cell:n=>n.cache_bytes?dg(n.cached_bytes,n.cache_bytes):Ls(n.cached_bytes),value:n=>n.cached_bytes,isNumber:!0},{key:"hits",title:"hits",cell:n=>un(n.cache_hit_share),value:n=>n.cache_hit_share,isNumber:!0},{key:"peers",title:"to peers",cell:n=>Ls(n.uploaded_bytes??0),value:n=>n.uploaded_bytes??0,isNumber:!0},{key:"longest",title:"longest",cell:n=>n.longest?y("a",{href:Wn(n.longest.job,n.longest.scenario),children:["#",n.longest.scenario," ",Fr(n.longest.seconds)]}):"-",value:n=>n.longest?.seconds??0,isNumber:!0}];function rM({history:n}){let e=i=>{let s=n.columns.indexOf(i);return n.rows.map(r=>r[s]??0)},t=e("time");return y("div",{class:"two",children:[y(mi,{title:"throughput",note:"scenarios a second, ten minutes",children:y(af,{title:"throughput",times:t,format:or,lines:[{title:"scenarios",colour:"--accent",values:e("scenarios_per_second")}]})}),y(mi,{title:"wire",note:"bytes a second, seen from the master",children:y(af,{title:"wire",times:t,format:hg,lines:[{title:"out",colour:"--accent",values:e("sent_per_second")},{title:"in",colour:"--second",values:e("received_per_second"),dash:[6,3]},{title:"peer to peer",colour:"--third",values:e("peer_per_second"),dash:[2,3]}]})})]})}function oM({cluster:n}){let e=n.workers.filter(r=>!r.state.startsWith("lost")),t=e.reduce((r,o)=>r+o.threads,0),i=e.reduce((r,o)=>r+o.scenarios_per_second,0),s=n.jobs.filter(r=>r.state==="running").length;return y("dl",{class:"numbers",children:[y("div",{children:[y("dt",{children:"scenarios"}),y("dd",{children:or(i)})]}),y("div",{children:[y("dt",{children:e.length===1?"worker":"workers"}),y("dd",{children:Fe(e.length)})]}),y("div",{children:[y("dt",{children:"threads"}),y("dd",{children:Fe(t)})]}),y("div",{children:[y("dt",{children:s===1?"job runs":"jobs run"}),y("dd",{children:Fe(s)})]}),y("div",{children:[y("dt",{children:"up"}),y("dd",{children:Fr(n.uptime_seconds)})]}),y("div",{children:[y("dt",{children:"free on the disk"}),y("dd",{children:Ls(n.state_bytes?.free??0)})]})]})}function Y0(){let{value:n,error:e}=Us("cluster",1),{value:t}=Us("history",2);if(ur("cluster"),$e(()=>pi("cluster",()=>({ready:n!==void 0,workers:n?.workers.map(r=>({name:r.name,state:r.state})),jobs:n?.jobs.map(r=>({job:r.job,done:r.done,state:r.state}))})),[n]),!n)return e?y(Pt,{kind:"bad",children:e}):y("p",{class:"wait",children:"asking the master…"});let i=(r,o)=>Cc(r.state)-Cc(o.state),s=(r,o)=>+(o.state==="running")-+(r.state==="running");return y(Vt,{children:[e&&y(Pt,{kind:"bad",children:[e,"; below is what it said last"]}),n.paused&&y(Pt,{kind:"bad",children:["jobs are paused: ",n.paused]}),n.alarms.map((r,o)=>y(Pt,{kind:"warn",children:[y("b",{children:"alarm"})," ",y(Ft,{text:r})]},o)),y(oM,{cluster:n}),y("p",{class:"line",children:[y("b",{children:"bottleneck"})," ",n.bottleneck,n.workers_lost>0&&y(Vt,{children:[" · ",Gt(n.workers_lost,"worker")," lost so far"]}),n.alarms.length===0&&y(Vt,{children:" · no alarms"})]}),t&&y(rM,{history:t}),y(dr,{caption:"workers",columns:sM,rows:n.workers,rowKey:r=>r.worker,order:i,rowClass:r=>q0[Cc(r.state)],empty:"no worker is connected: start cdworker --master HOST:7600"}),y(uf,{jobs:n.jobs,order:s})]})}var hf=1e3;function aM(n){let e=[],t=0,i=null;return n.classes.forEach((s,r)=>{V0(s)?i?(i.last=n.first+r,i.worst=n.isWorse(r,i.worst)?r:i.worst):(i={first:n.first+r,last:n.first+r,worst:r},t+=1,t<=hf&&e.push(i)):i=null}),{count:t,listed:e}}function J0({job:n,results:e}){let t=n.poses.kind==="file"&&e.isExact,i=Ht(()=>t?aM(e):null,[e,t]);if(!i)return null;let s=n.clearance===null?"in contact":"in contact or near",r=o=>y("a",{href:Wn(n.job,o),children:["#",Fe(o)]});return y(mi,{title:"episodes",note:`${Gt(i.count,"run")} of consecutive scenarios ${s}${i.count>hf?`; the first ${Fe(hf)} are listed`:""}`,children:y(dr,{caption:"episodes",rows:i.listed,rowKey:o=>String(o.first),empty:`no scenario is ${s}`,columns:[{key:"first",title:"first",cell:o=>r(o.first),value:o=>o.first,isNumber:!0},{key:"last",title:"last",cell:o=>r(o.last),value:o=>o.last,isNumber:!0},{key:"length",title:"scenarios",cell:o=>Fe(o.last-o.first+1),value:o=>o.last-o.first,isNumber:!0},{key:"worst",title:"worst",cell:o=>y(Vt,{children:[y(Wr,{kind:e.classes[o.worst]})," ",r(e.scenarioAt(o.worst))]}),value:o=>e.countAt(o.worst),isNumber:!0},{key:"pairs",title:"pairs there",cell:o=>e.counts?Fe(e.countAt(o.worst)):"-",value:o=>e.countAt(o.worst),isNumber:!0}]})})}function Z0(n){return n.replaceAll(/[\\/*?[]/g,"\\$&")}function df(n){return n.replaceAll(/\\(.)/gs,"$1")}function lM(n,e){let t=e.indexOf(n);return t>=0?t:["a","b"].indexOf(n)}function Po(n,e,t){return`${t[n]!==""&&t[0]!==t[1]?Z0(t[n]):"ab"[n]}/${Z0(e)}`}function K0(n,e){let t=/^((?:\\.|[^\\/])*)\/(.*)$/s.exec(n),i=t?lM(df(t[1]),e.bodies):-1;if(t&&i>=0)return{body:i,part:df(t[2])};let s=df(n);return{body:e.hasA(s)?0:1,part:s}}function Rc(n){return[n.bodies[0]?.name??"",n.bodies[1]?.name??""]}function cM(n,e){let i=n/e,s=i+1.959964*1.959964/(2*e),r=1.959964*Math.sqrt(i*(1-i)/e+1.959964*1.959964/(4*e*e)),o=1+1.959964*1.959964/e;return[Math.max(0,(s-r)/o),Math.min(1,(s+r)/o)]}function uM({group:n,job:e}){let t=e.poses.kind==="random"&&!e.poses.penetration&&e.done>0,[i,s]=t?cM(n.scenarios,e.done):[0,0];return y("span",{class:"share",children:[y("meter",{min:0,max:1,value:n.share}),y("span",{children:[un(n.share),t&&y("small",{children:[" ",`${un(i)} to ${un(s)}`]})]})]})}function hM(n,{a:e,b:t,worst:i}){let s=Rc(n);return Wn(n.job,i,{part:Po(0,e,s),with:Po(1,t,s)})}var dM={key:"near",title:"near pairs",cell:n=>Fe(n.near),value:n=>n.near,isNumber:!0};function fM(n){return[{key:"a",title:"part of A",cell:e=>y(Ft,{text:e.a}),value:e=>e.a},{key:"b",title:"part of B",cell:e=>y(Ft,{text:e.b}),value:e=>e.b},{key:"scenarios",title:"in poses",cell:e=>Fe(e.scenarios),value:e=>e.scenarios,isNumber:!0},{key:"share",title:"share",cell:e=>y(uM,{group:e,job:n}),value:e=>e.share,isNumber:!0},{key:"worst",title:"worst",cell:e=>y("a",{href:hM(n,e),children:[y(Wr,{kind:Ro(e.class)})," #",Fe(e.worst)]}),value:e=>e.worst_pairs+e.worst_near,isNumber:!0},...n.clearance===null?[]:[dM]]}function j0({job:n,groups:e}){let t=n.groups_total??e.length,i=t>e.length,s=n.clearance===null?"parts in contact":"parts in contact or near";return y(mi,{title:s,note:i?`the ${Fe(e.length)} in most poses, of ${Fe(t)}`:"",children:y(dr,{caption:s,columns:fM(n),rows:e,rowKey:r=>`${r.a}
${r.b}`,empty:n.clearance===null?"no part is in contact":"no part is in contact or near"})})}function pM(n){let e=[];for(let t of n){if(t===0)continue;let i=31-Math.clz32(t);for(;e.length<=i;){let s=2**e.length;e.push({first:s,last:2*s-1,count:0})}e[i].count+=1}return e}function ff({job:n,results:e}){let t=Ht(()=>e.counts?pM(e.counts):[],[e]);if(t.length===0)return null;let[i,s,r]=[480,150,18],o=Math.log1p(Math.max(...t.map(l=>l.count))),a=i/t.length;return y(mi,{title:"pairs a scenario",note:`scenarios in contact${n.clearance===null?"":" or near"}, both axes logarithmic${e.isExact?"":", of the sample"}`,children:y("svg",{class:"histogram",viewBox:`0 0 ${i} ${s+r}`,role:"img","aria-label":"histogram of pairs a scenario",children:[t.map((l,c)=>{let u=Math.log1p(l.count)/o*(s-14);return y("g",{children:[y("title",{children:`${Fe(l.first)} to ${Fe(l.last)} pairs: ${Gt(l.count,"scenario")}`}),y("rect",{class:"hit",x:c*a,y:0,width:a,height:s}),y("rect",{class:"bar",x:c*a+1,y:s-u,width:a-2,height:u}),l.count>0&&y("text",{x:(c+.5)*a,y:s-u-3,children:Cd(l.count)}),(c%2===0||t.length<12)&&y("text",{x:(c+.5)*a,y:s+13,children:Cd(l.first)})]},l.first)}),y("line",{x1:0,x2:i,y1:s,y2:s})]})})}function mM(n){let e=(n??"").split(",").map(t=>/^(\w+):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(t));return Object.fromEntries(e.flatMap(t=>t&&Number.isFinite(Number(t[2]))?[[t[1],Number(t[2])]]:[]))}function gM(n,e){let t=r=>/^\d{1,15}$/.test(r??""),[i,s]=[Number(n),Number(e)];return t(n)&&t(e)&&i<=s?[i,s+1]:null}function pf(n){return{x:n.get("x")??"",y:n.get("y")??"",at:mM(n.get("at")),window:gM(n.get("from"),n.get("to"))}}function Q0(n){let e={};n.x&&n.y&&(e.x=n.x,e.y=n.y);let t=Object.entries(n.at);return t.length>0&&(e.at=t.map(([i,s])=>`${i}:${s}`).join(",")),n.window&&(e.from=String(n.window[0]),e.to=String(n.window[1]-1)),e}function Io(n,[e,t,i]){return[n[0]*e+n[1]*t+n[2]*i+n[3],n[4]*e+n[5]*t+n[6]*i+n[7],n[8]*e+n[9]*t+n[10]*i+n[11]]}function Lo(n){let e=[n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]],t=i=>-(e[i]*n[3]+e[i+1]*n[7]+e[i+2]*n[11]);return[e[0],e[1],e[2],t(0),e[3],e[4],e[5],t(3),e[6],e[7],e[8],t(6)]}function gf(n,e){let t=[];for(let i=0;i<12;i+=4)for(let s=0;s<4;++s)t.push(n[i]*e[s]+n[i+1]*e[s+4]+n[i+2]*e[s+8]+(s===3?n[i+3]:0));return t}function Pc({pose_a:n,pose_b:e}){return gf(Lo(n),e)}var Ri=["x","y","z","roll","pitch","yaw","distance"],mf=180/Math.PI;function _f(n,e,t=0){switch(n){case"x":return e[t+3];case"y":return e[t+7];case"z":return e[t+11];case"roll":return Math.atan2(e[t+9],e[t+10])*mf;case"pitch":return Math.asin(Math.max(-1,Math.min(1,-e[t+8])))*mf;case"yaw":return Math.atan2(e[t+4],e[t])*mf;case"distance":return Math.hypot(e[t+3],e[t+7],e[t+11])}}function e_(n){return Object.fromEntries(Ri.map(e=>[e,_f(e,n)]))}function Fs(n){return n==="roll"||n==="pitch"||n==="yaw"}function Ic(n,e,t,i,s){if(e===0||e===255||e===1){let r=s*(e===1?.85:e===0?.35:.15);n.moveTo(t+r,i),n.arc(t,i,r,0,2*Math.PI)}else if(e===2||e===4)n.moveTo(t-s,i-s),n.lineTo(t+s,i+s),e===2&&(n.moveTo(t+s,i-s),n.lineTo(t-s,i+s));else if(e===3)n.rect(t-s,i-s,2*s,2*s);else if(e===5)n.moveTo(t-s,i),n.lineTo(t+s,i);else if(e===7)for(let r of[-.5,.5])n.moveTo(t+r*s,i-s),n.lineTo(t+r*s,i+s);else n.moveTo(t,i-s),n.lineTo(t+s,i+s),n.lineTo(t-s,i+s),n.lineTo(t,i-s)}var _M=10,Do=class{constructor(e,t,i,s,r,o,a){this.results=e;this.x=t;this.y=i;this.columns=s;this.rows=r;this.showsShares=o;this.describe=a;let l=s*r;this.worst=new Int32Array(l).fill(-1),this.number=new Uint32Array(l),this.tested=new Uint32Array(l),this.contacts=new Uint32Array(l)}results;x;y;columns;rows;showsShares;describe;worst;number;tested;contacts;add(e,t,i){let s=t*this.columns+e,r=this.results.classes[i];this.number[s]+=1,this.tested[s]+=r===255?0:1,this.contacts[s]+=lf(r)?1:0,(this.worst[s]<0||this.results.isWorse(i,this.worst[s]))&&(this.worst[s]=i)}colour(e){let t=this.results.classes[this.worst[e]];if(!this.showsShares||this.tested[e]===0)return Ki(t);let i=this.contacts[e]/this.tested[e],[s,r]=[Ki(0),Ki(2)];return[0,1,2].map(o=>s[o]+(r[o]-s[o])*i)}draw(e,t,i){let s=new ImageData(this.columns,this.rows);for(let o=0;o<this.worst.length;++o){if(this.worst[o]<0)continue;let l=4*((this.rows-1-Math.floor(o/this.columns))*this.columns+o%this.columns);s.data.set([...this.colour(o),255],l)}let r=new OffscreenCanvas(this.columns,this.rows);r.getContext("2d")?.putImageData(s,0,0),e.imageSmoothingEnabled=!1,e.drawImage(r,0,0,t,i),this.drawGlyphs(e,t/this.columns,i/this.rows)}drawGlyphs(e,t,i){let s=Math.min(t,i);if(!(s<_M||this.showsShares)){e.strokeStyle="rgb(0 0 0 / 0.3)",e.lineWidth=Math.max(1,s/14),e.beginPath();for(let r=0;r<this.worst.length;++r)if(this.worst[r]>=0){let o=(r%this.columns+.5)*t,a=(this.rows-.5-Math.floor(r/this.columns))*i,l=this.results.classes[this.worst[r]];l!==0&&l!==255&&Ic(e,l,o,a,s*.2)}e.stroke()}}spot(e,t){let i=t*this.columns+e;return e<0||t<0||e>=this.columns||t>=this.rows||this.worst[i]<0?null:{scenario:this.results.scenarioAt(this.worst[i]),text:this.text(i),x:e/this.columns,y:t/this.rows,width:1/this.columns,height:1/this.rows}}text(e){let t=this.worst[e],i=this.results.scenarioAt(t),s=this.results.countAt(t),r=s>0?`, ${Fe(s)} pairs`:"",o=`#${i} ${Os(this.results.classes[t])}${r}${this.describe(i)}`;if(this.number[e]===1)return o;let a=un(this.contacts[e]/Math.max(1,this.tested[e]));return`${Fe(this.number[e])} scenarios, ${a} in contact; the worst is ${o}`}at(e,t){return this.spot(Math.floor(e*this.columns),Math.floor(t*this.rows))}step(e,t,i){let s=e?Math.round(e.x*this.columns):Math.floor(this.columns/2)-t,r=e?Math.round(e.y*this.rows):Math.floor(this.rows/2)-i;for(;;){if(s+=t,r+=i,s<0||r<0||s>=this.columns||r>=this.rows)return e;let o=this.spot(s,r);if(o)return o}}};function No(n,e){return`${On(e)}${n.unit}`}var xM=512,yM=40,xf=class{constructor(e,t){this.axes=e;this.unit=t;this.strides=e.map((i,s)=>e.slice(s+1).reduce((r,o)=>r*o.count,1))}axes;unit;strides;varying(){return this.axes.flatMap((e,t)=>e.count>1?[t]:[])}value(e,t){let{first:i,last:s,count:r}=this.axes[e];return t===0?i:t===r-1?s:i+(s-i)*t/(r-1)}numberOf(e,t){return Math.floor(t/this.strides[e])%this.axes[e].count}unitOf(e){return Fs(this.axes[e].name)?"°":` ${this.unit}`}plotAxis(e){let{name:t,first:i,last:s}=this.axes[e];return{title:t,first:i,last:s,unit:this.unitOf(e)}}nearest(e,t){let{first:i,last:s,count:r}=this.axes[e],o=s===i?0:(t-i)/(s-i)*(r-1);return Math.min(r-1,Math.max(0,Math.round(o)))}brief(e,t){let i=this.value(e,t),s=[4,6,9,12].find(r=>this.nearest(e,Number(i.toPrecision(r)))===t);return s===void 0?i:Number(i.toPrecision(s))}varyingNamed(e){return this.varying().find(t=>this.axes[t].name===e)}valueText(e,t){return`${this.axes[e].name} ${On(this.value(e,t))}${this.unitOf(e)}`}describe(e){let t=this.varying().map(i=>this.valueText(i,this.numberOf(i,e)));return t.length===0?"":` at ${t.join(", ")}`}};function t_(n,e,t,i,s){let r=e.isSample?yM:xM,o=Math.min(r,n.axes[t].count),a=Math.min(r,n.axes[i].count),l=new Do(e,n.plotAxis(t),n.plotAxis(i),o,a,!1,h=>n.describe(h)),c=h=>Math.floor(h*o/n.axes[t].count),u=h=>Math.floor(h*a/n.axes[i].count);if(!e.isExact){for(let h=0;h<e.classes.length;++h){let d=e.scenarioAt(h);l.add(c(n.numberOf(t,d)),u(n.numberOf(i,d)),h)}return l}let f=s.reduce((h,d,p)=>h+(p===t||p===i?0:d*n.strides[p]),0);for(let h=0;h<n.axes[t].count;++h)for(let d=0;d<(t===i?1:n.axes[i].count);++d){let p=f+h*n.strides[t]+(t===i?0:d*n.strides[i]);l.add(c(h),t===i?0:u(d),p-e.first)}return l}function n_(n){return n.poses.kind==="grid"&&n.poses.axes?new xf(n.poses.axes,n.unit):null}var vM={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function bM(n,e,t,i){let[s,r]=[e.x*t,(1-e.y-e.height)*i];n.lineWidth=2*devicePixelRatio,n.strokeStyle=qi("--ink"),n.beginPath(),e.width>0?n.rect(s-1,r-1,Math.max(4,e.width*t)+2,Math.max(4,e.height*i)+2):n.arc(s,r,6*devicePixelRatio,0,2*Math.PI),n.stroke()}function yf(n){let{model:e}=n,t=Tt(null),i=Tt(null),[s,r]=Qe(null),[o,a]=Qe([0,0]),l=Eo();$e(()=>{let h=t.current;if(!h)return;let d=new ResizeObserver(()=>a([Math.round(h.clientWidth*devicePixelRatio),Math.round(h.clientHeight*devicePixelRatio)]));return d.observe(h),()=>d.disconnect()},[]),$e(()=>r(null),[e.x.title,e.y.title]),$e(()=>{let[h,d]=o;if(h>0&&d>0){i.current=new OffscreenCanvas(h,d);let p=i.current.getContext("2d");p&&e.draw(p,h,d)}},[e,o,l]),$e(()=>{let h=t.current?.getContext("2d"),[d,p]=o;!t.current||!h||!i.current||(t.current.width=d,t.current.height=p,h.drawImage(i.current,0,0),s&&bM(h,s,d,p))},[e,s,o,l]);let c=h=>{let d=h.currentTarget.getBoundingClientRect(),p=(h.clientX-d.left)/d.width,b=1-(h.clientY-d.top)/d.height;return e.at(p,b,d.width,d.height)},u=h=>{let d=vM[h.key];d?(r(e.step(s,...d)),h.preventDefault()):h.key==="Enter"&&s&&n.open(s.scenario)},f=h=>No(h,(h.first+h.last)/2);return y("div",{class:"plot",children:[y("div",{class:"y-axis","aria-hidden":"true",children:[y("span",{children:No(e.y,e.y.last)}),y("b",{children:e.y.title}),y("span",{children:No(e.y,e.y.first)})]}),y("canvas",{ref:t,tabIndex:0,role:"application","aria-label":`${e.x.title} against ${e.y.title}: arrows move, Enter opens. ${s?.text??""}`,onPointerMove:h=>r(c(h)),onPointerLeave:()=>r(null),onClick:h=>{let d=c(h);d&&n.open(d.scenario)},onKeyDown:u}),y("div",{class:"x-axis","aria-hidden":"true",children:[y("span",{children:No(e.x,e.x.first)}),y("span",{children:[y("b",{children:e.x.title})," ",f(e.x)]}),y("span",{children:No(e.x,e.x.last)})]}),y("p",{class:"readout","aria-live":"polite",children:s?s.text:"point at a place to read it; a click opens its worst scenario"})]})}var vf=4096,SM=1<<24,ji=65536,Uo=class{constructor(e,t,i,s,r=null){this.first=e;this.end=t;this.classes=i;this.counts=s;this.chosen=r}first;end;classes;counts;chosen;get isExact(){return this.classes.length===this.end-this.first}get isSample(){return!this.isExact&&this.chosen===null}scenarioAt(e){return this.chosen?this.chosen[e]:this.isExact?this.first+e:this.first+Math.floor(e*(this.end-this.first)/this.classes.length)}classOf(e){return this.isExact?this.classes[e-this.first]:void 0}isWorse(e,t){let i=Ha(this.classes[e])-Ha(this.classes[t]);return i>0||i===0&&this.countAt(e)>this.countAt(t)}worst(){let e=0;for(let t=1;t<this.classes.length;++t)e=this.isWorse(t,e)?t:e;return this.classes.length===0?0:this.scenarioAt(e)}countAt(e){return this.counts?.[e]??0}};function MM(n){return n.kind==="folder"?1<<20:ji}function bf(n){return n.kind==="folder"?SM:ji}async function i_(n,e,t,i,s){for(let r=0;r<t.length;r+=i){let o=Math.min(i,t.length-r),a=await Zn(`${n}?first=${e+r}&count=${o}`,s);t.set(a.values,r)}return t}function Oo(n,e){return`jobs/${encodeURIComponent(n.job)}/${e}`}async function Lc(n,e,t,i,s){if(!Fo(n,t,i)){let[r,o]=await Promise.all(["classes","counts"].map(a=>Zn(`${Oo(e,a)}?sample=${vf}`,s)));return new Uo(0,e.scenarios,r.values,o.values)}return s_(e,t,i-t,MM(n),s)}async function s_(n,e,t,i,s){let r=new Uint8Array(t).fill(255),o=await i_(Oo(n,"classes"),e,r,i,s),a=n.level==="any"?null:await i_(Oo(n,"counts"),e,new Uint32Array(t),i,s);return new Uo(e,e+t,o,a)}function r_(n,e,t,i){return s_(n,e,t,ji,i)}function Fo(n,e,t){return t-e<=bf(n)}var wM=1<<20;function o_(n,e,t,i){for(let s=0;s*t<e.length;++s){let[r,o]=[e,s*t];if(t===24){let a=Array.from({length:24},(l,c)=>e[24*s+c]);[r,o]=[gf(Lo(a.slice(0,12)),a.slice(12)),0]}for(let[a,l]of n)l[i+s]=_f(a,r,o)}}function a_(n,e){return new Map(n.map(t=>[t,new Float64Array(e)]))}function l_(n){return n.poses.of_both_bodies?24:12}async function c_(n,e,t){let i=Math.min(vf,n.scenarios),s=await Zn(`${Oo(n,"poses")}?sample=${i}`,t),r=a_(e,i);return o_(r,s.values,l_(n),0),r}function Sf(n){let[e,t]=[1/0,-1/0];for(let i of n)e=i<e?i:e,t=i>t?i:t;return e<t?[e,t]:[e-.5,e+.5]}function Mf(n){let e=s=>{let[r,o]=Sf(n.get(s)??new Float64Array(1));return(o-r)*(Fs(s)?1e-6:1)},[t,i]=Ri.filter(s=>s!=="distance").sort((s,r)=>e(r)-e(s));return Ri.indexOf(t)<Ri.indexOf(i)?[t,i]:[i,t]}async function u_(n,e){return Mf(await c_(n,Ri,e))}function h_(n,e){return e.scenarios<=wM||!Fo(n,0,e.scenarios)}async function d_(n,e,t,i,s){let r=e.scenarios;if(!Fo(n,0,r))return c_(e,t,i);let o=a_(t,r);for(let a=0;a<r;a+=ji){let l=Math.min(ji,r-a),c=await Zn(`${Oo(e,"poses")}?first=${a}&count=${l}`,i);o_(o,c.values,l_(e),a),s((a+l)/r)}return o}var Tf=5e4,wf=128,f_=14;function p_(n,e,t){let[i,s]=Sf(e),r=.03*(s-i);return{title:n,first:i-r,last:s+r,unit:Fs(n)?"°":` ${t}`}}var Af=class{constructor(e,t,i,s,r){this.results=e;this.px=t;this.py=i;this.x=s;this.y=r;this.order=Uint32Array.from(t,(o,a)=>a).sort((o,a)=>this.rank(o)-this.rank(a)||o-a)}results;px;py;x;y;order;rank(e){return Ha(this.kind(e))}kind(e){return this.results.classes[e]??255}draw(e,t,i){let s=this.px.length,r=(s>2e4?1.5:s>2e3?2.4:3.4)*devicePixelRatio;e.lineWidth=Math.max(1,.4*r);for(let o=0;o<s;){let a=this.kind(this.order[o]);for(e.beginPath();o<s&&this.kind(this.order[o])===a;++o){let f=this.order[o];Ic(e,a,this.px[f]*t,(1-this.py[f])*i,r)}let[l,c,u]=Ki(a);e.strokeStyle=`rgb(${l} ${c} ${u} / ${a===0?.6:.9})`,e.stroke()}}spot(e){let t=this.results.scenarioAt(e),i=this.results.countAt(e),s=[this.x,this.y].map((o,a)=>{let l=a===0?this.px[e]:this.py[e];return`${o.title} ${On(o.first+l*(o.last-o.first))}${o.unit}`}),r=i>0?`, ${Fe(i)} pairs`:"";return{scenario:t,text:`#${t} ${Os(this.kind(e))}${r} at ${s.join(", ")}`,x:this.px[e],y:this.py[e],width:0,height:0}}at(e,t,i,s){let r=-1,o=f_*f_;for(let a=0;a<this.px.length;++a){let l=(this.px[a]-e)*i,c=(this.py[a]-t)*s,u=l*l+c*c;(u<o||u===o&&r>=0&&this.rank(a)>this.rank(r))&&(o=u,r=a)}return r<0?null:this.spot(r)}step(e,t,i){let s=e??{x:.5,y:.5},r=-1,o=1/0;for(let a=0;a<this.px.length;++a){let[l,c]=[this.px[a]-s.x,this.py[a]-s.y],u=l*t+c*i,f=l*l+c*c;u>0&&2*u*u>=f&&f<o&&(o=f,r=a)}return r<0?e:this.spot(r)}};function m_(n,[e,t],[i,s],r){let[o,a]=[p_(e,t,r),p_(i,s,r)],l=(h,d)=>(d-h.first)/(h.last-h.first),c=Math.min(t.length,n.classes.length);if(c<=Tf){let h=(d,p)=>p.subarray(0,c).map(b=>l(d,b));return new Af(n,h(o,t),h(a,s),o,a)}let u=new Do(n,o,a,wf,wf,!0,()=>""),f=(h,d)=>Math.floor(l(h,d)*wf);for(let h=0;h<c;++h)u.add(f(o,t[h]),f(a,s[h]),h);return u}var Dc=16;function g_(n,e,t,i){let s=[...new Set([e,t])].sort((a,l)=>n.strides[l]-n.strides[a]);if(s.reduce((a,l)=>a*n.axes[l].count,1)>Dc*ji)return null;let o=Float64Array.of(i.reduce((a,l,c)=>a+(s.includes(c)?0:l*n.strides[c]),0));for(let a of s){let[l,c,u]=[o,n.axes[a].count,n.strides[a]];o=Float64Array.from({length:l.length*c},(f,h)=>l[Math.floor(h/c)]+h%c*u)}return o}function __(n){let e=[];for(let t of n){let i=e.at(-1);if(i&&t<i.first+ji)i.count=t-i.first+1;else{if(e.length===Dc)return null;e.push({first:t,count:1})}}return e}async function x_(n,e,t,i){let s=new Uint8Array(e.length),r=new Uint32Array(e.length),o=0;for(let{first:a,count:l}of t){let c=await r_(n,a,l,i);for(;o<e.length&&e[o]<a+l;++o)s[o]=c.classes[e[o]-a],r[o]=c.counts?.[e[o]-a]??0}return new Uo(0,n.scenarios,s,r,e)}var AM=150;function v_(n){$e(()=>pi("pose space",()=>{let e=n?.step(null,1,0)??null;return{poseSpace:e&&{...e,axes:[n?.x.title,n?.y.title]}}}),[n])}function Nc(n){return y("label",{children:[n.label," ",y("select",{value:n.value,onChange:e=>n.choose(e.currentTarget.value),children:n.all.map(e=>y("option",{value:e,children:e},e))})]})}function TM(n,e){let[t=0,i=t]=n.varying(),[s,r]=[n.varyingNamed(e.x),n.varyingNamed(e.y)];return s!==void 0&&r!==void 0&&(s!==r||t===i)?[s,r]:[t,i]}function EM(n,e,t,i,s){let{job:r,results:o}=n,a=o.isExact?null:[t,i,...s].join(" "),l=Ht(()=>a===null?null:g_(e,t,i,s),[a]),c=Ht(()=>l&&__(l),[l]);return{...Co(c&&a,o,async f=>(await new Promise(h=>setTimeout(h,AM)),x_(r,l??new Float64Array,c??[],f))),isTooScattered:a!==null&&c===null}}function CM(n,e){if(n.isExact||e.value)return"";let t=e.isTooScattered?`: this slice lies in more than ${Dc} windows of ${Fe(ji)}`:"; reading the slice…";return`a sample of ${Fe(n.classes.length)}, other axes folded${t}`}function RM(n){let{job:e,grid:t,results:i,view:s,change:r}=n,[o,a]=TM(t,s),l=t.axes.map(({name:v},C)=>v in s.at?t.nearest(C,s.at[v]):0),c=v=>v!==o&&v!==a,u=Ht(()=>l.map((v,C)=>c(C)?v:0),[o,a,...l]),f=EM(n,t,o,a,u),h=f.value??i,d=Ht(()=>t_(t,h,o,a,u),[t,h,o,a,u]);v_(d);let p=t.varying(),b=v=>t.axes[v].name,m=p.map(b),g=(v,C)=>{let S=t.varyingNamed(C)??o,[I,T]=v==="x"?[o,a]:[a,o],x=S===T?I:T,[E,H]=v==="x"?[S,x]:[x,S];r({x:b(E),y:b(H)})};return y(mi,{title:"pose space",note:CM(i,f),children:[f.error&&y(Pt,{kind:"bad",children:f.error}),y("div",{class:"controls",children:[p.length>1&&y(Vt,{children:[y(Nc,{label:"across",value:b(o),all:m,choose:v=>g("x",v)}),y(Nc,{label:"up",value:b(a),all:m,choose:v=>g("y",v)})]}),!f.isTooScattered&&p.filter(c).map(v=>y("label",{class:"slider",children:[y("input",{type:"range",min:0,max:t.axes[v].count-1,value:u[v],onInput:C=>{let S=t.brief(v,Number(C.currentTarget.value));r({at:{...s.at,[b(v)]:S}})}})," ",t.valueText(v,u[v])]},v))]}),y(yf,{model:d,open:v=>Is(Wn(e.job,v))})]})}function y_(n){return Ri.includes(n)}function PM({source:n,job:e,view:t},i){let s=y_(t.x)&&y_(t.y)?[t.x,t.y]:null,r=h_(n,e),o=Co(s||r?null:e.job,0,f=>u_(e,f)),a=r?Ri:s??o.value,l=Co(a&&a.join(" "),0,f=>d_(n,e,a??[],f,i)),c=l.value,u=Ht(()=>r?c&&Mf(c):o.value,[c,o.value]);return{drawn:s??u,all:c,error:o.error||l.error}}function IM(n){let{job:e,results:t,change:i}=n,[s,r]=Qe(0),{drawn:o,all:a,error:l}=PM(n,r),[c,u]=o??["x","y"],[f,h]=[a?.get(c),a?.get(u)],d=Ht(()=>f&&h?m_(t,[c,f],[u,h],e.unit):null,[t,c,u,f,h]);v_(d);let p=[t.isExact?"":`a sample of ${Fe(t.classes.length)}`,t.classes.length>Tf?"share of contacts in each cell":"",e.poses.penetration?"poses pushed to contact":""];return y(mi,{title:"pose space",note:p.filter(b=>b!=="").join(", "),children:[l&&y(Pt,{kind:"bad",children:l}),y("div",{class:"controls",children:[y(Nc,{label:"across",value:c,all:Ri,choose:b=>i({x:b,y:u})}),y(Nc,{label:"up",value:u,all:Ri,choose:b=>i({x:c,y:b})}),y("span",{class:"note",children:"of B in A's frame"})]}),d?y(yf,{model:d,open:b=>Is(Wn(e.job,b))}):y("p",{class:"wait",children:["reading the poses… ",s>0&&un(s)]})]})}function b_(n){let e=Ht(()=>n_(n.job),[n.job.job]);return e?y(RM,{...n,grid:e}):y(IM,{...n})}var LM=1024;function DM(n,e){return n&&n[0]<e?[n[0],Math.min(e,n[1])]:[0,e]}function NM(n){return`windows of at most ${Fe(bf(n))} are exact`}function UM(n,e){return e.reduce((t,i)=>t+(i>=0&&n.classes[i]!==255?1:0),0)}function OM(n,e,t){let i=Math.min(LM,t-e),s=new Int32Array(i).fill(-1);for(let r=0;r<n.classes.length;++r){let o=n.scenarioAt(r);if(o<e||o>=t)continue;let a=Math.floor((o-e)*i/(t-e));(s[a]<0||n.isWorse(r,s[a]))&&(s[a]=r)}return s}function FM(n,e,t,{bin:i,drag:s}){let r=Math.round(n.clientWidth*devicePixelRatio),o=Math.round(n.clientHeight*devicePixelRatio),a=n.getContext("2d");if(!a||r===0)return;n.width=r,n.height=o;let l=c=>[c,c+1].map(u=>Math.round(u*r/t.length));if(t.forEach((c,u)=>{if(c<0)return;let f=e.classes[c],[h,d]=l(u),p=o*G0(f),b=d-h>4*devicePixelRatio?devicePixelRatio:0;a.fillStyle=hr(f),a.fillRect(h,o-p,Math.max(1,d-h-b),p)}),a.fillStyle=qi("--accent"),i>=0){let[c,u]=l(i);a.fillRect(c,0,Math.max(2*devicePixelRatio,u-c),3*devicePixelRatio)}if(s){let[c,u]=[Math.min(...s)*r,Math.max(...s)*r];a.globalAlpha=.25,a.fillRect(c,0,u-c,o)}}function BM([n,e],t,i,s){let r=Math.max(1,Math.min(s,i?Math.ceil((e-n)/2):2*(e-n))),o=(t-n)/(e-n),a=Math.min(s-r,Math.max(0,Math.floor(t)-Math.floor(o*r)));return[a,a+r]}function kM([n,e],t,i){let s=e-n,r=Math.min(i-s,Math.max(0,Math.round(t-s/2)));return t>=n&&t<e?[n,e]:[r,r+s]}function zM(n,e,t,[i,s]){let r=!t.isExact&&Fo(n,i,s),o=Co(r?`${i} ${s}`:null,t,a=>Lc(n,e,i,s,a));return{results:o.value??t,error:o.error}}function S_(n){let{source:e,job:t}=n,i=t.scenarios,s=Tt(null),[r,o]=Qe(null),[a,l]=Qe(-1),[c,u]=Qe(0),f=Eo(),h=DM(n.view.window,i),[d,p]=h,{results:b,error:m}=zM(e,t,n.results,h),g=Ht(()=>OM(b,d,p),[b,d,p]),v=g.length,C=O=>Math.floor((O-d)*v/(p-d)),S=a>=d&&a<p?C(a):-1,I=O=>d+Math.ceil(O*(p-d)/v);$e(()=>{let O=s.current;if(!O)return;let re=new ResizeObserver(()=>u(O.clientWidth));return re.observe(O),()=>re.disconnect()},[]),$e(()=>{s.current&&FM(s.current,b,g,{bin:S,drag:r})},[b,g,S,r,c,f]),$e(()=>pi("strip",()=>({strip:{first:d,end:p,mark:a,isExact:b.isExact,shown:UM(b,g)}})),[b,g,a]);let T=([O,re])=>n.change({window:O===0&&re===i?null:[O,re]}),x=O=>{let re=O.currentTarget.getBoundingClientRect();return Math.min(1,Math.max(0,(O.clientX-re.left)/re.width))},E=O=>I(Math.min(v-1,Math.floor(O*v))),H=O=>{g[O]>=0&&Is(Wn(t.job,b.scenarioAt(g[O])))},U=()=>{if(!r)return;let[O,re]=[Math.min(...r),Math.max(...r)];if(o(null),re-O<.005){H(Math.min(v-1,Math.floor(O*v)));return}let J=Math.floor(d+O*(p-d));T([J,Math.max(J+1,Math.ceil(d+re*(p-d)))]),l(-1)},L=O=>{let re=S<0?O>0?d:p-1:O>0?I(S+1):I(S)-1,J=Math.min(i-1,Math.max(0,re));l(J),T(kM(h,J,i))},G=O=>T(BM(h,S<0?(d+p)/2:a,O,i)),V={ArrowRight:()=>L(1),ArrowLeft:()=>L(-1),"+":()=>G(!0),"-":()=>G(!1),Enter:()=>H(S),Escape:()=>T([0,i])},N=O=>{let re=O.ctrlKey||O.altKey||O.metaKey?void 0:V[O.key];re&&(re(),O.preventDefault())},W=S>=0?g[S]:-1,q=W>=0?`#${b.scenarioAt(W)} ${Os(b.classes[W])}, the worst of this bin`:"drag to zoom, click to open";return y(mi,{title:"scenarios in order",wide:!0,note:b.isExact?"":`a sample of ${Fe(b.classes.length)}; ${NM(e)}`,children:[m&&y(Pt,{kind:"bad",children:m}),y("canvas",{ref:s,class:"strip",tabIndex:0,role:"application","aria-label":`scenarios ${d} to ${p-1}: arrows move, plus and minus zoom, Enter opens, Escape shows all. ${q}`,onPointerDown:O=>{O.currentTarget.setPointerCapture(O.pointerId),o([x(O),x(O)])},onPointerMove:O=>{l(E(x(O))),o(r&&[r[0],x(O)])},onPointerUp:U,onPointerCancel:()=>o(null),onPointerLeave:()=>r||l(-1),onKeyDown:N}),y("div",{class:"x-axis",children:[y("span",{children:["#",Fe(d)]}),y("span",{class:"readout",children:q}),y("span",{children:[n.view.window&&y("button",{type:"button",class:"quiet",onClick:()=>T([0,i]),children:"show all"})," ","#",Fe(p-1)]})]})]})}var VM=3e3;function M_(n,e){let[t,i]=Qe({results:null,error:"",done:-1,at:0}),[s,r]=Qe(0);return $e(()=>{if(!e)return;let o=new AbortController,a=(l,c)=>i(u=>({results:l??u.results,error:c,done:e.done,at:performance.now()}));return Lc(n,e,0,e.scenarios,o.signal).then(l=>a(l,""),l=>Rs(l)||a(null,Kn(l))),()=>o.abort()},[e?.job,s]),$e(()=>{if(!e||t.done<0||e.done===t.done)return;let o=Math.max(0,t.at+VM-performance.now()),a=setTimeout(()=>r(l=>l+1),o);return()=>clearTimeout(a)},[e?.done,t]),t}var HM=[["n, p","next and previous scenario in contact, or what else is chosen"],["← →","previous and next scenario"],["esc","end a search for the next contact"]],GM=[["space","play, stop"],["h","heat map, contacts"],["g","ghost: A, B, none"],["x","contacts through walls"],["l","segments and points"],["s","section plane"],["[ ]","move the section plane"],["f","fit all into view"],["c","go to the contact"],["shift ← → ↑ ↓","turn"],["shift W A S D","move up, left, down, right"],["+ −","nearer, farther"],["enter","in the picture: pick the triangle in its middle; with shift: of the ghost"],["drag, wheel","turn, zoom; with the right button or two fingers: move"],["click","pick a triangle; with shift: of the ghost"]];function w_(n){return[...HM,...n?GM:[],["?","these keys"]]}var A_=[["tab","from one part of the page to the next"],["← → ↑ ↓","in the pose space: the next place"],["← →","in the scenarios in order: the next bar; beyond the edge, further scenarios"],["+ −","there: half as many scenarios about the mark, or twice as many"],["enter","open the scenario at the mark"],["esc","all scenarios in order"],["?","these keys"]];function Uc({title:n,keys:e,close:t}){let i=Tt(null);return $e(()=>i.current?.showModal(),[]),y("dialog",{ref:i,class:"keys",onClose:t,onClick:()=>i.current?.close(),children:[y("h2",{children:n}),y("table",{children:y("tbody",{children:e.map(([s,r])=>y("tr",{children:[y("th",{scope:"row",children:y("kbd",{children:s})}),y("td",{children:r})]},r))})}),y("button",{type:"button",children:"close"})]})}function Oc(n,e=document){let t=Tt(n);t.current=n,$e(()=>{let i=s=>{if(!(s instanceof KeyboardEvent))return;let r=s.shiftKey&&s.key.startsWith("Arrow"),o=t.current[r?`Shift+${s.key}`:s.key];o&&!WM(s)&&(o(),s.preventDefault())};return e.addEventListener("keydown",i),()=>e.removeEventListener("keydown",i)},[e])}function WM(n){let e=n.target;if(n.ctrlKey||n.altKey||n.metaKey)return!0;if(e instanceof HTMLInputElement){let s=e.type==="range"||e.type==="radio";return e.type==="number"||s&&n.key.startsWith("Arrow")}let t=e instanceof HTMLButtonElement&&n.key===" ",i=e instanceof Element?e.getRootNode():document;return t||e instanceof HTMLSelectElement||i.querySelector("dialog[open]")!==null}function T_(n){return n.state!=="running"&&n.state!=="paused"}function XM(n){return n.touch+n.cross+n.inside+n.contact}function $M(n){if(n.clearance===null)return"";let e=`at most ${On(n.clearance,6)} ${n.unit} apart`;return` In ${Gt(n.near,"scenario")} without contact the bodies are ${e}, with ${Gt(n.near_pairs,"near pair")}.`}function qM({job:n}){let e=XM(n),t=n.done===n.scenarios?"":` tested so far, of ${Fe(n.scenarios)}`;return y("div",{class:"verdict",children:[y("h1",{children:[y(Ft,{text:n.name||n.job}),y("span",{class:`state ${n.state==="failed"?"bad":""}`,children:n.state}),!T_(n)&&y(Tc,{done:n.done,total:n.scenarios})]}),y("p",{class:"sentence",children:[e===0?`No contact in ${Gt(n.done,"scenario")}${t}.`:`${Fe(e)} of ${Gt(n.done,"scenario")}${t} ${e===1?"is":"are"} in contact (${un(e/Math.max(1,n.done))}), with ${Gt(n.pairs,"pair")} of triangles.`,$M(n)]}),y("p",{class:"counts",children:[z0.map(i=>{let s=Ac[i],r=s==="separate"||s==="cross"||s==="failed";return y(W0,{kind:i,count:n[s],always:r||i===7&&n.clearance!==null},s)}),n.digest&&y("span",{class:"count",children:["digest ",y("code",{title:n.digest,children:n.digest.slice(0,16)})]})]})]})}function YM({job:n}){let e=[];return n.surfaces_only>0&&e.push(`Containment was not tested in ${Gt(n.surfaces_only,"scenario")}: a body is open.`),n.insides_skipped>0&&e.push(`Containment was not tested in ${Gt(n.insides_skipped,"scenario")}: triangles are ignored, and the rest of a body is open.`),n.cut>0&&e.push(`The list of pairs ends at ${Fe(n.limit_pairs)} in ${Gt(n.cut,"scenario")}; counts are true.`),n.map_pairs>0&&e.push(`The heat map counts the first ${Fe(n.map_pairs)} pairs of a scenario.`),e.length===0?null:y("p",{class:"caveats",children:e.join(" ")})}function JM({body:n,letter:e,unit:t}){let i=n.closed===null?"":n.closed?", closed":", open";return y("div",{class:"card",children:[y("b",{class:"letter",children:e}),y("div",{children:[y(Ft,{text:ar(n.file)}),n.name.toLowerCase()!==e.toLowerCase()&&y("span",{class:"note",children:[" ","called ",y(Ft,{text:n.name})]}),y("div",{class:"note",children:[Gt(n.triangles,"triangle"),", ",Gt(n.parts,"part"),i]}),y("div",{class:"note",children:[n.size.map(s=>On(s)).join(" × ")," ",t," · ",n.precision]})]})]})}function ZM(n){let{poses:e}=n;return e.kind==="grid"?`grid ${(e.axes??[]).filter(i=>i.count>1).map(i=>`${i.name} ${Fe(i.count)}`).join(" × ")}`:e.kind==="random"?`random, seed ${e.seed??"-"}${e.penetration?`, pushed ${e.penetration.map(t=>un(t)).join(" to ")} into contact`:""}`:`file ${ar(e.file??"")}`}function KM({job:n}){return y("div",{class:"card",children:[y("b",{class:"letter",children:"×"}),y("div",{children:[y("span",{children:Gt(n.poses.count,"pose")}),y("div",{class:"note",children:[ZM(n),n.poses.of_both_bodies?", of both bodies":""]}),y("div",{class:"note",children:["level ",n.level,n.clearance!==null&&`, clearance ${On(n.clearance,6)} ${n.unit}`,n.ignored>0&&`, ${Gt(n.ignored,"range")} ignored`]})]})]})}function jM({job:n}){let e=[["where",n.where],["instructions",n.simd],["time",n.seconds>0?`${Fr(n.seconds)}, ${or(n.scenarios_per_second)}`:""],["owner",n.owner],["started",n.started||n.began],["ended",n.ended],["command",n.command],["program",[n.program,n.commit].filter(s=>s!=="").join(", commit ")],["digest",n.digest??""],...n.bodies.map(s=>[`mesh ${s.name}`,`${s.sha256} (${Ls(s.bytes)}), ${s.file}`])],t=n.folder?Na(n.folder):n.job,i=(n.formats??[]).length>0?`the folder has ${n.formats?.join(", ")}; more:`:"";return y("details",{class:"how",children:[y("summary",{children:"how it ran, and exports"}),y("dl",{children:e.filter(([,s])=>s).map(([s,r])=>y("div",{children:[y("dt",{children:s}),y("dd",{children:y("bdi",{children:r})})]},s))}),y("p",{class:"note",children:[i," ",y(Ec,{text:`cdctl results ${t}${n.folder?"":" --out out"} --formats csv,npz`})]})]})}function QM(n,e){$e(()=>pi("job",()=>({ready:n!==void 0&&e!==null,job:n?.job,done:n?.done,isExact:e?.isExact,tested:e?.classes.reduce((t,i)=>t+(i===255?0:1),0)})),[n,e])}function ew(n){let[e,t]=Qe(()=>pf(n.query));return $e(()=>t(pf(n.query)),[n]),$e(()=>(oc(()=>Ps(n.job,Q0(e))),rr),[e]),[e,i=>t(s=>({...s,...i}))]}function E_({source:n,route:e}){let t=e.job,[i,s]=ew(e),[r,o]=Qe(!1),{value:a,error:l}=Us(`jobs/${encodeURIComponent(t)}`,1,h=>!T_(h)),{results:c,error:u}=M_(n,a),f=Ht(()=>c?.worst()??0,[c]);return ur(a&&a.name||t),QM(a,c),Oc({"?":()=>o(!0)}),a?y(Vt,{children:[(l||u)&&y(Pt,{kind:"bad",children:l||u}),a.failure&&y(Pt,{kind:"bad",children:["failed: ",y(Ft,{text:a.failure})]}),a.paused&&y(Pt,{kind:"warn",children:["paused: ",a.paused]}),y(qM,{job:a}),y("div",{class:"cards",children:[a.bodies.map((h,d)=>y(JM,{body:h,letter:d===0?"A":d===1?"B":String(d),unit:a.unit},d)),y(KM,{job:a}),y("a",{class:"card go",href:Wn(a.job,f),children:"see it in 3D"})]}),y(YM,{job:a}),c?y(Vt,{children:[y("div",{class:"two",children:[y(b_,{source:n,job:a,results:c,view:i,change:s}),a.groups?y(j0,{job:a,groups:a.groups}):y(ff,{job:a,results:c})]}),y(S_,{source:n,job:a,results:c,view:i,change:s}),y("div",{class:"two",children:[a.groups&&y(ff,{job:a,results:c}),y(J0,{job:a,results:c})]})]}):y("p",{class:"wait",children:"reading the results…"}),y(jM,{job:a}),y("button",{type:"button",class:"quiet",onClick:()=>o(!0),children:"keys of this page"}),r&&y(Uc,{title:"Keys of a job's page",keys:A_,close:()=>o(!1)})]}):l?y(Pt,{kind:"bad",children:l}):y("p",{class:"wait",children:["asking for ",t,"…"]})}var Ef=class{constructor(e,t){this.names=e;this.runs=t}names;runs;runOf(e){let t=0,i=this.runs.length/2;for(;i-t>1;){let s=t+i>>1;this.runs[2*s]<=e?t=s:i=s}return t}nameOf(e){return this.names[this.runs[2*this.runOf(e)+1]]??""}isOf(e,t){return t===""||this.nameOf(e)===t}placeOf(e){let t=this.runOf(e),i=e-this.runs[2*t];for(let s=0;s<t;++s)this.runs[2*s+1]===this.runs[2*t+1]&&(i+=this.runs[2*s+2]-this.runs[2*s]);return i}};async function Bo(n,e){let t=`jobs/${encodeURIComponent(n)}/parts/${e}`,[i,s]=await Promise.all([Zn(t),Ai(`${t}/names`)]);return new Ef(s,i.values)}function C_(n){return y("fieldset",{class:"radio",children:[y("legend",{children:n.title}),n.all.map(([e,t])=>y("label",{children:[y("input",{type:"radio",name:n.name,checked:n.value===e,onChange:()=>n.choose(e)}),y("span",{children:t})]},e))]})}function Cf(n){return y("label",{class:"check",children:[y("input",{type:"checkbox",checked:n.isOn,onChange:e=>n.turn(e.currentTarget.checked)}),n.text]})}function tw(n){let{clip:e}=n.state,[t,i]=n.bounds[e?.axis??"x"],s=r=>(n.bounds[r][0]+n.bounds[r][1])/2;return y("div",{class:"section-plane",children:[y(Cf,{text:"section",isOn:e!==null,turn:r=>n.change({clip:r?{axis:"x",at:s("x")}:null})}),e&&y(Vt,{children:[y("select",{"aria-label":"axis of the section plane",value:e.axis,onChange:r=>{let o=r.currentTarget.value;n.change({clip:{axis:o,at:s(o)}})},children:["x","y","z"].map(r=>y("option",{children:r},r))}),y("input",{type:"range","aria-label":"place of the section plane",min:t,max:i,step:(i-t)/500||1,value:e.at,onInput:r=>n.change({clip:{axis:e.axis,at:Number(r.currentTarget.value)}})}),y("output",{children:Number(e.at.toPrecision(4))})]})]})}function R_(n){let{state:e,change:t}=n,i=[["contacts","contacts"]];n.hasMap&&i.push(["heat","heat map"]);let s=[["a","A"],["b","B"],["none","none"]];return y("section",{class:"view-controls","aria-label":"view",children:[y(C_,{title:"show",name:"mode",value:e.mode,all:i,choose:r=>t({mode:r})}),y(C_,{title:"ghost",name:"ghost",value:e.ghost,all:s,choose:r=>t({ghost:r})}),y(Cf,{text:"through walls",isOn:e.throughWalls,turn:r=>t({throughWalls:r})}),y(Cf,{text:"segments and points",isOn:e.lines,turn:r=>t({lines:r})}),y(tw,{state:e,bounds:n.bounds,change:t}),y("div",{class:"buttons",children:[y("button",{type:"button",onClick:n.fit,title:"f",children:"fit"}),y("button",{type:"button",onClick:n.goToContact,title:"c",children:"go to the contact"})]})]})}function P_({address:n}){let[e,t]=Qe("");return y("button",{type:"button",onClick:()=>cf(n(),t),children:e||"copy link"})}var Ga=[[68,1,84],[71,45,123],[59,82,139],[44,114,142],[33,145,140],[40,174,128],[94,201,98],[173,220,48],[253,231,37]];function Rf(n){let e=Math.min(1,Math.max(0,n))*(Ga.length-1),t=Math.min(Ga.length-2,Math.floor(e)),i=e-t;return[0,1,2].map(s=>Math.round(Ga[t][s]+(Ga[t+1][s]-Ga[t][s])*i))}function I_(n){let e=new Uint8Array(1024);for(let t=0;t<256;++t)e.set([...t===0?n:Rf((t-1)/254),255],4*t);return e}function nw(n,e){return n===0?0:e<=1?255:1+Math.round(254*Math.log(n)/Math.log(e))}function L_(n,e){let t=new Float64Array(e);for(let i=0;i+1<n.length;i+=2)t[n[i]]=n[i+1];return t}function D_(n,e){let t=new Uint8Array(3*n.length);for(let i=0;i<n.length;++i)t.fill(nw(n[i],e),3*i,3*i+3);return t}var Fc=48;function iw(n){let e=[1];for(let t=10;t<n/2;t*=10)e.push(t);return n>1?[...e,n]:e}function N_(n){return n.clearance===null?"in contact":"in contact or near"}function U_({heat:n,job:e}){if(n.most===0)return y("p",{class:"note",children:["no triangle was ",N_(e)]});let[t,i]=[264,10],s=o=>n.most<=1?0:Math.log(o)/Math.log(n.most)*t,r=iw(n.most);return y("figure",{class:"legend",children:[y("svg",{viewBox:`0 0 ${t} 42`,role:"img","aria-label":"colours of the heat map",children:[Array.from({length:Fc},(o,a)=>{let[l,c,u]=Rf(a/(Fc-1));return y("rect",{x:a*t/Fc,y:0,width:t/Fc+.5,height:i,fill:`rgb(${l},${c},${u})`},a)}),r.map((o,a)=>y("g",{children:[y("line",{x1:s(o),x2:s(o),y1:i,y2:i+3}),y("text",{x:s(o),y:i+14,class:a===0?"begin":a===r.length-1?"end":"",children:Fe(o)}),y("text",{x:s(o),y:i+27,class:a===0?"begin":a===r.length-1?"end":"",children:un(o/Math.max(1,e.done))})]},o))]}),y("figcaption",{class:"note",children:["scenarios in which a triangle is ",N_(e),", logarithmic",e.map_pairs>0&&`, of the first ${Fe(e.map_pairs)} pairs`,"; plain: never"]})]})}function O_({hasNear:n}){return y("ul",{class:"legend plain",children:[y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:y("path",{d:"M1 11 7 1l6 10z",fill:hr(2)})}),"proper: goes through the other"]}),y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:y("path",{d:"M1 11 7 1l6 10z",fill:hr(1),class:"outlined"})}),"touch or coplanar: outlined"]}),y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:[y("path",{d:"M1 9 11 4",class:"thick"}),y("circle",{cx:12,cy:4,r:2})]}),"what they share"]}),n&&y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:y("path",{d:"M1 11 7 1l6 10z",fill:hr(7),class:"outlined"})}),"near: the line joins the nearest points"]})]})}var sw=[0,67,68,77,69,83,72,49],Pf=29;async function rw(n,e){if(!globalThis.crypto?.subtle)return null;let t=new Uint8Array(await crypto.subtle.digest("SHA-256",n));return Array.from(t,i=>i.toString(16).padStart(2,"0")).join("")===e}function ow(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i+=3)for(let s=0;s<3;++s){let r=n[i+s];e[s]=r<e[s]?r:e[s],t[s]=r>t[s]?r:t[s]}return n.length===0?[[0,0,0],[0,0,0]]:[e,t]}function aw(n,e,t){let i=new DataView(n);if(n.byteLength<Pf||sw.some((p,b)=>i.getUint8(b)!==p))throw new Error("the server's mesh is not in canonical form");let s=i.getUint8(8)===1,r=Number(i.getBigUint64(9,!0)),o=Number(i.getBigUint64(17,!0)),a=Pf+r*3*(s?8:4),l=a+o*12;if(l>n.byteLength)throw new Error("the server's mesh is cut short");let c=n.slice(Pf,a),u=s?new Float64Array(c):new Float32Array(c),f=new Uint32Array(n.slice(a,l)),[h,d]=ow(u);return{sha256:e,checked:t,bytes:n.byteLength,vertices:u,triangles:f,min:h,max:d,centre:[0,1,2].map(p=>(h[p]+d[p])/2)}}async function If(n,e){let t=await ng(`meshes/${n}`,e),i=await rw(t,n);try{return aw(t,n,i)}catch(s){throw i===!1?new Error(`not the tested geometry: ${Kn(s)}`):s}}function F_(n){let{vertices:e,triangles:t,centre:i}=n,[s,r,o]=i,a=new Float32Array(3*t.length);for(let l=0;l<t.length;++l){let c=3*t[l];a[3*l]=e[c]-s,a[3*l+1]=e[c+1]-r,a[3*l+2]=e[c+2]-o}return a}var Wa=8e6,Bc=null;async function lw(n){let e=performance.now(),[t,i]=n.bodies.map(a=>a.sha256),s=If(t),r=Promise.all([Bo(n.job,0),Bo(n.job,1)]);return{meshes:await Promise.all([s,t===i?s:If(i)]),parts:await r,milliseconds:performance.now()-e}}function B_(n){let e=[n.job,...n.bodies.map(t=>t.sha256)].join(" ");if(Bc?.key!==e){let t=lw(n);Bc={key:e,model:t},t.catch(()=>{Bc=null})}return Bc.model}async function k_(n,e){try{let i=(await Promise.all([0,1].map(r=>Zn(`jobs/${encodeURIComponent(n.job)}/map/${r}`)))).map((r,o)=>L_(r.values,e.meshes[o].triangles.length/3)),s=i.reduce((r,o)=>o.reduce((a,l)=>Math.max(a,l),r),0);return{counts:i,most:s}}catch(t){if(t instanceof Bi&&t.status===404)return null;throw t}}var kc=class{constructor(e,t,i){this.job=e;this.show=t;this.fail=i}job;show;fail;wanted=null;isLoading=!1;stop=new AbortController;want(e){this.wanted=e,this.isLoading||this.run()}close(){this.wanted=null,this.stop.abort()}async run(){for(this.isLoading=!0;this.wanted!==null;){let e=this.wanted;try{let t=await this.load(e);this.wanted=this.wanted===e?null:this.wanted,this.show(t)}catch(t){if(Rs(t)||this.stop.signal.aborted)break;t instanceof Bi&&t.isBusy?await ec():(this.wanted=this.wanted===e?null:this.wanted,this.fail(e,t))}}this.isLoading=!1}async load(e){let t=`jobs/${encodeURIComponent(this.job)}/scenarios/${e}`,i=this.stop.signal,s=await Ai(t,i);if(s.class===null||s.exact_pairs===0)return{scenario:s,pairs:new Uint32Array,points:new Float64Array,isCut:!1};let r=await Zn(`${t}/pairs`,i),o=await Zn(`${t}/points`,i);return{scenario:s,pairs:r.values,points:o.values,isCut:r.cut||o.cut}}};var Er={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Cr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},yx=0,lp=1,vx=2;var Al=1,bx=2,da=3,Rr=0,di=1,xi=2,Zr=0,fa=1,cp=2,up=3,hp=4,Sx=5;var Kr=100,Mx=101,wx=102,Ax=103,Tx=104,Ex=200,Cx=201,Rx=202,Px=203,dp=204,fp=205,Ix=206,Lx=207,Dx=208,Nx=209,Ux=210,Ox=211,Fx=212,Bx=213,kx=214,fu=0,pu=1,mu=2,yr=3,gu=4,_u=5,xu=6,yu=7,$u=0,zx=1,Vx=2,ys=0,pp=1,mp=2,gp=3,_p=4,xp=5,yp=6,vp=7;var bp=300,jr=301,pa=302,qu=303,Yu=304,vu=1e3,_s=1001,bu=1002,hn=1003,Hx=1004;var Tl=1005;var hi=1006,Ju=1007;var Ys=1008;var yi=1009,Sp=1010,Mp=1011,ma=1012,Zu=1013,ss=1014,rs=1015,os=1016,Ku=1017,ju=1018,Qr=1020,wp=35902,Ap=35899,Tp=1021,Ep=1022,Ui=1023,Xs=1026,Js=1027,Cp=1028,Qu=1029,Pr=1030,eh=1031;var th=1033,El=33776,Cl=33777,Rl=33778,Pl=33779,nh=35840,ih=35841,sh=35842,rh=35843,oh=36196,ah=37492,lh=37496,ch=37488,uh=37489,Il=37490,hh=37491,dh=37808,fh=37809,ph=37810,mh=37811,gh=37812,_h=37813,xh=37814,yh=37815,vh=37816,bh=37817,Sh=37818,Mh=37819,wh=37820,Ah=37821,Th=36492,Eh=36494,Ch=36495,Rh=36283,Ph=36284,Ll=36285,Ih=36286;var Qa=2300,Su=2301,hu=2302,ep=2303,tp=2400,np=2401,ip=2402;var Gx=3200;var Lh=0,Wx=1,Zs="",Bn="srgb",el="srgb-linear",tl="linear",It="srgb";var du=7680;var Xx=519,$x=512,qx=513,Yx=514,Rp=515,Jx=516,Zx=517,Pp=518,Ip=519,Lp=35044;var Dp="300 es",Hi=2e3,ta=2001;function cw(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function uw(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function nl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function Kx(){let n=nl("canvas");return n.style.display="block",n}var z_={},na=null;function il(...n){let e="THREE."+n.shift();na?na("log",e,...n):console.log(e,...n)}function jx(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=jx(n);let e="THREE."+n.shift();if(na)na("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function it(...n){n=jx(n);let e="THREE."+n.shift();if(na)na("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function Za(...n){let e=n.join(" ");e in z_||(z_[e]=!0,Je(...n))}function Qx(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var ey={[fu]:fu,[mu]:xu,[gu]:gu,[yr]:_u,[pu]:pu,[xu]:mu,[yu]:yu,[_u]:yr},ns=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},jn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],V_=1234567,Ka=Math.PI/180,ia=180/Math.PI;function Ir(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(jn[n&255]+jn[n>>8&255]+jn[n>>16&255]+jn[n>>24&255]+"-"+jn[e&255]+jn[e>>8&255]+"-"+jn[e>>16&15|64]+jn[e>>24&255]+"-"+jn[t&63|128]+jn[t>>8&255]+"-"+jn[t>>16&255]+jn[t>>24&255]+jn[i&255]+jn[i>>8&255]+jn[i>>16&255]+jn[i>>24&255]).toLowerCase()}function ct(n,e,t){return Math.max(e,Math.min(t,n))}function Np(n,e){return(n%e+e)%e}function hw(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function dw(n,e,t){return n!==e?(t-n)/(e-n):0}function ja(n,e,t){return(1-t)*n+t*e}function fw(n,e,t,i){return ja(n,e,1-Math.exp(-t*i))}function pw(n,e=1){return e-Math.abs(Np(n,e*2)-e)}function mw(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function gw(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function _w(n,e){return n+Math.floor(Math.random()*(e-n+1))}function xw(n,e){return n+Math.random()*(e-n)}function yw(n){return n*(.5-Math.random())}function vw(n){n!==void 0&&(V_=n);let e=V_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function bw(n){return n*Ka}function Sw(n){return n*ia}function Mw(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function ww(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Up(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function Aw(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:Je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Dh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Op(n,e){if(e.constructor===Float32Array)return n;let t=Dh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Fp(n,e){if(e.constructor===Float32Array)return n;let t=Dh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Dl={DEG2RAD:Ka,RAD2DEG:ia,generateUUID:Ir,clamp:ct,euclideanModulo:Np,mapLinear:hw,inverseLerp:dw,lerp:ja,damp:fw,pingpong:pw,smoothstep:mw,smootherstep:gw,randInt:_w,randFloat:xw,randFloatSpread:yw,seededRandom:vw,degToRad:bw,radToDeg:Sw,isPowerOfTwo:Mw,ceilPowerOfTwo:ww,floorPowerOfTwo:Up,setQuaternionFromProperEuler:Aw,normalize:Fp,denormalize:Op},Ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Li=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],b=r[o+3];if(f!==b||l!==h||c!==d||u!==p){let m=l*h+c*d+u*p+f*b;m<0&&(h=-h,d=-d,p=-p,b=-b,m=-m);let g=1-a;if(m<.9995){let v=Math.acos(m),C=Math.sin(v);g=Math.sin(g*v)/C,a=Math.sin(a*v)/C,l=l*g+h*a,c=c*g+d*a,u=u*g+p*a,f=f*g+b*a}else{l=l*g+h*a,c=c*g+d*a,u=u*g+p*a,f=f*g+b*a;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ct(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(H_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(H_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return Lf.copy(this).projectOnVector(e),this.sub(Lf)}reflect(e){return this.sub(Lf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ct(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},Lf=new z,H_=new Li,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],b=s[0],m=s[3],g=s[6],v=s[1],C=s[4],S=s[7],I=s[2],T=s[5],x=s[8];return r[0]=o*b+a*v+l*I,r[3]=o*m+a*C+l*T,r[6]=o*g+a*S+l*x,r[1]=c*b+u*v+f*I,r[4]=c*m+u*C+f*T,r[7]=c*g+u*S+f*x,r[2]=h*b+d*v+p*I,r[5]=h*m+d*C+p*T,r[8]=h*g+d*S+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/p;return e[0]=f*b,e[1]=(s*c-u*i)*b,e[2]=(a*i-s*o)*b,e[3]=h*b,e[4]=(u*t-s*l)*b,e[5]=(s*r-a*t)*b,e[6]=d*b,e[7]=(i*l-c*t)*b,e[8]=(o*t-i*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return Za("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Df.makeScale(e,t)),this}rotate(e){return Za("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Df.makeRotation(-e)),this}translate(e,t){return Za("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Df.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Df=new st,G_=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),W_=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function Tw(){let n={enabled:!0,workingColorSpace:el,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===It&&(s.r=Ws(s.r),s.g=Ws(s.g),s.b=Ws(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===It&&(s.r=ea(s.r),s.g=ea(s.g),s.b=ea(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Zs?tl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[el]:{primaries:e,whitePoint:i,transfer:tl,toXYZ:G_,fromXYZ:W_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Bn},outputColorSpaceConfig:{drawingBufferColorSpace:Bn}},[Bn]:{primaries:e,whitePoint:i,transfer:It,toXYZ:G_,fromXYZ:W_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Bn}}}),n}var vt=Tw();function Ws(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function ea(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var ko,Mu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{ko===void 0&&(ko=nl("canvas")),ko.width=e.width,ko.height=e.height;let s=ko.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=ko}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=nl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ws(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Ws(t[i]/255)*255):t[i]=Ws(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},Ew=0,sa=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:Ew++}),this.uuid=Ir(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Nf(s[o].image)):r.push(Nf(s[o]))}else r=Nf(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Nf(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Mu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var Cw=0,Uf=new z,_i=class n extends ns{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=_s,s=_s,r=hi,o=Ys,a=Ui,l=yi,c=n.DEFAULT_ANISOTROPY,u=Zs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:Cw++}),this.uuid=Ir(),this.name="",this.source=new sa(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Uf).x}get height(){return this.source.getSize(Uf).y}get depth(){return this.source.getSize(Uf).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==bp)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case vu:e.x=e.x-Math.floor(e.x);break;case _s:e.x=e.x<0?0:1;break;case bu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case vu:e.y=e.y-Math.floor(e.y);break;case _s:e.y=e.y<0?0:1;break;case bu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};_i.DEFAULT_IMAGE=null;_i.DEFAULT_MAPPING=bp;_i.DEFAULT_ANISOTROPY=1;var Lt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],b=l[2],m=l[6],g=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-b)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+b)<.1&&Math.abs(p+m)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,S=(d+1)/2,I=(g+1)/2,T=(u+h)/4,x=(f+b)/4,E=(p+m)/4;return C>S&&C>I?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=T/i,r=x/i):S>I?S<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(S),i=T/s,r=E/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=x/r,s=E/r),this.set(i,s,r,t),this}let v=Math.sqrt((m-p)*(m-p)+(f-b)*(f-b)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(f-b)/v,this.z=(h-u)/v,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ct(this.x,e.x,t.x),this.y=ct(this.y,e.y,t.y),this.z=ct(this.z,e.z,t.z),this.w=ct(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ct(this.x,e,t),this.y=ct(this.y,e,t),this.z=ct(this.z,e,t),this.w=ct(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ct(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},wu=class extends ns{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:hi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Lt(0,0,e,t),this.scissorTest=!1,this.viewport=new Lt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new _i({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:hi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new sa(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Di=class extends wu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},sl=class extends _i{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=hn,this.minFilter=hn,this.wrapR=_s,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var Au=class extends _i{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=hn,this.minFilter=hn,this.wrapR=_s,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var St=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=f,g[14]=h,g[3]=d,g[7]=p,g[11]=b,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/zo.setFromMatrixColumn(e,0).length(),r=1/zo.setFromMatrixColumn(e,1).length(),o=1/zo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-b*c,t[9]=-a*l,t[2]=b-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h+b*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=b+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h-b*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=b-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+b,t[1]=l*f,t[5]=b*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=b-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-b*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+b,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=b*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(Rw,e,Pw)}lookAt(e,t,i){let s=this.elements;return Pi.subVectors(e,t),Pi.lengthSq()===0&&(Pi.z=1),Pi.normalize(),fr.crossVectors(i,Pi),fr.lengthSq()===0&&(Math.abs(i.z)===1?Pi.x+=1e-4:Pi.z+=1e-4,Pi.normalize(),fr.crossVectors(i,Pi)),fr.normalize(),zc.crossVectors(Pi,fr),s[0]=fr.x,s[4]=zc.x,s[8]=Pi.x,s[1]=fr.y,s[5]=zc.y,s[9]=Pi.y,s[2]=fr.z,s[6]=zc.z,s[10]=Pi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],b=i[6],m=i[10],g=i[14],v=i[3],C=i[7],S=i[11],I=i[15],T=s[0],x=s[4],E=s[8],H=s[12],U=s[1],L=s[5],G=s[9],V=s[13],N=s[2],W=s[6],q=s[10],O=s[14],re=s[3],J=s[7],ee=s[11],ie=s[15];return r[0]=o*T+a*U+l*N+c*re,r[4]=o*x+a*L+l*W+c*J,r[8]=o*E+a*G+l*q+c*ee,r[12]=o*H+a*V+l*O+c*ie,r[1]=u*T+f*U+h*N+d*re,r[5]=u*x+f*L+h*W+d*J,r[9]=u*E+f*G+h*q+d*ee,r[13]=u*H+f*V+h*O+d*ie,r[2]=p*T+b*U+m*N+g*re,r[6]=p*x+b*L+m*W+g*J,r[10]=p*E+b*G+m*q+g*ee,r[14]=p*H+b*V+m*O+g*ie,r[3]=v*T+C*U+S*N+I*re,r[7]=v*x+C*L+S*W+I*J,r[11]=v*E+C*G+S*q+I*ee,r[15]=v*H+C*V+S*O+I*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],b=e[7],m=e[11],g=e[15],v=l*d-c*h,C=a*d-c*f,S=a*h-l*f,I=o*d-c*u,T=o*h-l*u,x=o*f-a*u;return t*(b*v-m*C+g*S)-i*(p*v-m*I+g*T)+s*(p*C-b*I+g*x)-r*(p*S-b*T+m*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],b=e[13],m=e[14],g=e[15],v=t*a-i*o,C=t*l-s*o,S=t*c-r*o,I=i*l-s*a,T=i*c-r*a,x=s*c-r*l,E=u*b-f*p,H=u*m-h*p,U=u*g-d*p,L=f*m-h*b,G=f*g-d*b,V=h*g-d*m,N=v*V-C*G+S*L+I*U-T*H+x*E;if(N===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/N;return e[0]=(a*V-l*G+c*L)*W,e[1]=(s*G-i*V-r*L)*W,e[2]=(b*x-m*T+g*I)*W,e[3]=(h*T-f*x-d*I)*W,e[4]=(l*U-o*V-c*H)*W,e[5]=(t*V-s*U+r*H)*W,e[6]=(m*S-p*x-g*C)*W,e[7]=(u*x-h*S+d*C)*W,e[8]=(o*G-a*U+c*E)*W,e[9]=(i*U-t*G-r*E)*W,e[10]=(p*T-b*S+g*v)*W,e[11]=(f*S-u*T-d*v)*W,e[12]=(a*H-o*L-l*E)*W,e[13]=(t*L-i*H+s*E)*W,e[14]=(b*C-p*I-m*v)*W,e[15]=(u*I-f*C+h*v)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,b=o*u,m=o*f,g=a*f,v=l*c,C=l*u,S=l*f,I=i.x,T=i.y,x=i.z;return s[0]=(1-(b+g))*I,s[1]=(d+S)*I,s[2]=(p-C)*I,s[3]=0,s[4]=(d-S)*T,s[5]=(1-(h+g))*T,s[6]=(m+v)*T,s[7]=0,s[8]=(p+C)*x,s[9]=(m-v)*x,s[10]=(1-(h+b))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=zo.set(s[0],s[1],s[2]).length(),a=zo.set(s[4],s[5],s[6]).length(),l=zo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Qi.copy(this);let c=1/o,u=1/a,f=1/l;return Qi.elements[0]*=c,Qi.elements[1]*=c,Qi.elements[2]*=c,Qi.elements[4]*=u,Qi.elements[5]*=u,Qi.elements[6]*=u,Qi.elements[8]*=f,Qi.elements[9]*=f,Qi.elements[10]*=f,t.setFromRotationMatrix(Qi),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Hi,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,b;if(l)p=r/(o-r),b=o*r/(o-r);else if(a===Hi)p=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===ta)p=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Hi,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,b;if(l)p=1/(o-r),b=o/(o-r);else if(a===Hi)p=-2/(o-r),b=-(o+r)/(o-r);else if(a===ta)p=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},zo=new z,Qi=new St,Rw=new z(0,0,0),Pw=new z(1,1,1),fr=new z,zc=new z,Pi=new z,X_=new St,$_=new Li,$s=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ct(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ct(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ct(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ct(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ct(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ct(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return X_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(X_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return $_.setFromEuler(this),this.setFromQuaternion($_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};$s.DEFAULT_ORDER="XYZ";var rl=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},Iw=0,q_=new z,Vo=new Li,ks=new St,Vc=new z,Xa=new z,Lw=new z,Dw=new Li,Y_=new z(1,0,0),J_=new z(0,1,0),Z_=new z(0,0,1),K_={type:"added"},Nw={type:"removed"},Ho={type:"childadded",child:null},Of={type:"childremoved",child:null},zn=class n extends ns{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:Iw++}),this.uuid=Ir(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new z,t=new $s,i=new Li,s=new z(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new St},normalMatrix:{value:new st}}),this.matrix=new St,this.matrixWorld=new St,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new rl,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Vo.setFromAxisAngle(e,t),this.quaternion.multiply(Vo),this}rotateOnWorldAxis(e,t){return Vo.setFromAxisAngle(e,t),this.quaternion.premultiply(Vo),this}rotateX(e){return this.rotateOnAxis(Y_,e)}rotateY(e){return this.rotateOnAxis(J_,e)}rotateZ(e){return this.rotateOnAxis(Z_,e)}translateOnAxis(e,t){return q_.copy(e).applyQuaternion(this.quaternion),this.position.add(q_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Y_,e)}translateY(e){return this.translateOnAxis(J_,e)}translateZ(e){return this.translateOnAxis(Z_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(ks.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Vc.copy(e):Vc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Xa.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?ks.lookAt(Xa,Vc,this.up):ks.lookAt(Vc,Xa,this.up),this.quaternion.setFromRotationMatrix(ks),s&&(ks.extractRotation(s.matrixWorld),Vo.setFromRotationMatrix(ks),this.quaternion.premultiply(Vo.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(K_),Ho.child=e,this.dispatchEvent(Ho),Ho.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(Nw),Of.child=e,this.dispatchEvent(Of),Of.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),ks.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),ks.multiply(e.parent.matrixWorld)),e.applyMatrix4(ks),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(K_),Ho.child=e,this.dispatchEvent(Ho),Ho.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xa,e,Lw),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xa,Dw,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};zn.DEFAULT_UP=new z(0,1,0);zn.DEFAULT_MATRIX_AUTO_UPDATE=!0;zn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var gi=class extends zn{constructor(){super(),this.isGroup=!0,this.type="Group"}},Uw={type:"move"},ra=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new gi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new gi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new gi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,i),g=this._getHandJoint(c,b);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(Uw)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new gi;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},ty={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},pr={h:0,s:0,l:0},Hc={h:0,s:0,l:0};function Ff(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var dt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Bn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=vt.workingColorSpace){if(e=Np(e,1),t=ct(t,0,1),i=ct(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=Ff(o,r,e+1/3),this.g=Ff(o,r,e),this.b=Ff(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=Bn){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Bn){let i=ty[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Ws(e.r),this.g=Ws(e.g),this.b=Ws(e.b),this}copyLinearToSRGB(e){return this.r=ea(e.r),this.g=ea(e.g),this.b=ea(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Bn){return vt.workingToColorSpace(Qn.copy(this),e),Math.round(ct(Qn.r*255,0,255))*65536+Math.round(ct(Qn.g*255,0,255))*256+Math.round(ct(Qn.b*255,0,255))}getHexString(e=Bn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(Qn.copy(this),t);let i=Qn.r,s=Qn.g,r=Qn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(Qn.copy(this),t),e.r=Qn.r,e.g=Qn.g,e.b=Qn.b,e}getStyle(e=Bn){vt.workingToColorSpace(Qn.copy(this),e);let t=Qn.r,i=Qn.g,s=Qn.b;return e!==Bn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(pr),this.setHSL(pr.h+e,pr.s+t,pr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(pr),e.getHSL(Hc);let i=ja(pr.h,Hc.h,t),s=ja(pr.s,Hc.s,t),r=ja(pr.l,Hc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},Qn=new dt;dt.NAMES=ty;var ol=class extends zn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new $s,this.environmentIntensity=1,this.environmentRotation=new $s,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},es=new z,zs=new z,Bf=new z,Vs=new z,Go=new z,Wo=new z,j_=new z,kf=new z,zf=new z,Vf=new z,Hf=new Lt,Gf=new Lt,Wf=new Lt,xr=class n{constructor(e=new z,t=new z,i=new z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),es.subVectors(e,t),s.cross(es);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){es.subVectors(s,t),zs.subVectors(i,t),Bf.subVectors(e,t);let o=es.dot(es),a=es.dot(zs),l=es.dot(Bf),c=zs.dot(zs),u=zs.dot(Bf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Vs)===null?!1:Vs.x>=0&&Vs.y>=0&&Vs.x+Vs.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Vs)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Vs.x),l.addScaledVector(o,Vs.y),l.addScaledVector(a,Vs.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return Hf.setScalar(0),Gf.setScalar(0),Wf.setScalar(0),Hf.fromBufferAttribute(e,t),Gf.fromBufferAttribute(e,i),Wf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(Hf,r.x),o.addScaledVector(Gf,r.y),o.addScaledVector(Wf,r.z),o}static isFrontFacing(e,t,i,s){return es.subVectors(i,t),zs.subVectors(e,t),es.cross(zs).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return es.subVectors(this.c,this.b),zs.subVectors(this.a,this.b),es.cross(zs).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Go.subVectors(s,i),Wo.subVectors(r,i),kf.subVectors(e,i);let l=Go.dot(kf),c=Wo.dot(kf);if(l<=0&&c<=0)return t.copy(i);zf.subVectors(e,s);let u=Go.dot(zf),f=Wo.dot(zf);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Go,o);Vf.subVectors(e,r);let d=Go.dot(Vf),p=Wo.dot(Vf);if(p>=0&&d<=p)return t.copy(r);let b=d*c-l*p;if(b<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Wo,a);let m=u*p-d*f;if(m<=0&&f-u>=0&&d-p>=0)return j_.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(j_,a);let g=1/(m+b+h);return o=b*g,a=h*g,t.copy(i).addScaledVector(Go,o).addScaledVector(Wo,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},ei=class{constructor(e=new z(1/0,1/0,1/0),t=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(ts.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(ts.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=ts.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,ts):ts.fromBufferAttribute(r,o),ts.applyMatrix4(e.matrixWorld),this.expandByPoint(ts);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Gc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Gc.copy(i.boundingBox)),Gc.applyMatrix4(e.matrixWorld),this.union(Gc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,ts),ts.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter($a),Wc.subVectors(this.max,$a),Xo.subVectors(e.a,$a),$o.subVectors(e.b,$a),qo.subVectors(e.c,$a),mr.subVectors($o,Xo),gr.subVectors(qo,$o),Xr.subVectors(Xo,qo);let t=[0,-mr.z,mr.y,0,-gr.z,gr.y,0,-Xr.z,Xr.y,mr.z,0,-mr.x,gr.z,0,-gr.x,Xr.z,0,-Xr.x,-mr.y,mr.x,0,-gr.y,gr.x,0,-Xr.y,Xr.x,0];return!Xf(t,Xo,$o,qo,Wc)||(t=[1,0,0,0,1,0,0,0,1],!Xf(t,Xo,$o,qo,Wc))?!1:(Xc.crossVectors(mr,gr),t=[Xc.x,Xc.y,Xc.z],Xf(t,Xo,$o,qo,Wc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,ts).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(ts).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Hs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Hs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Hs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Hs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Hs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Hs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Hs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Hs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Hs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Hs=[new z,new z,new z,new z,new z,new z,new z,new z],ts=new z,Gc=new ei,Xo=new z,$o=new z,qo=new z,mr=new z,gr=new z,Xr=new z,$a=new z,Wc=new z,Xc=new z,$r=new z;function Xf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){$r.fromArray(n,r);let a=s.x*Math.abs($r.x)+s.y*Math.abs($r.y)+s.z*Math.abs($r.z),l=e.dot($r),c=t.dot($r),u=i.dot($r);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var vn=new z,$c=new Ke,Ow=0,bn=class extends ns{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:Ow++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Lp,this.updateRanges=[],this.gpuType=rs,this.version=0,this._normalizationScale=e!==void 0?Dh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)$c.fromBufferAttribute(this,t),$c.applyMatrix3(e),this.setXY(t,$c.x,$c.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix3(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyMatrix4(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.applyNormalMatrix(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)vn.fromBufferAttribute(this,t),vn.transformDirection(e),this.setXYZ(t,vn.x,vn.y,vn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Op(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Fp(e,this.array)}};var al=class extends bn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var ll=class extends bn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var kn=class extends bn{constructor(e,t,i){super(new Float32Array(e),t,i)}},Fw=new ei,qa=new z,$f=new z,Vn=class{constructor(e=new z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):Fw.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;qa.subVectors(e,this.center);let t=qa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(qa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):($f.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(qa.copy(e.center).add($f)),this.expandByPoint(qa.copy(e.center).sub($f))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},Bw=0,Vi=new St,qf=new zn,Yo=new z,Ii=new ei,Ya=new ei,Fn=new z,Sn=class n extends ns{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:Bw++}),this.uuid=Ir(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(cw(e)?ll:al)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new st().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Vi.makeRotationFromQuaternion(e),this.applyMatrix4(Vi),this}rotateX(e){return Vi.makeRotationX(e),this.applyMatrix4(Vi),this}rotateY(e){return Vi.makeRotationY(e),this.applyMatrix4(Vi),this}rotateZ(e){return Vi.makeRotationZ(e),this.applyMatrix4(Vi),this}translate(e,t,i){return Vi.makeTranslation(e,t,i),this.applyMatrix4(Vi),this}scale(e,t,i){return Vi.makeScale(e,t,i),this.applyMatrix4(Vi),this}lookAt(e){return qf.lookAt(e),qf.updateMatrix(),this.applyMatrix4(qf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Yo).negate(),this.translate(Yo.x,Yo.y,Yo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new kn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ei);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ii.setFromBufferAttribute(r),this.morphTargetsRelative?(Fn.addVectors(this.boundingBox.min,Ii.min),this.boundingBox.expandByPoint(Fn),Fn.addVectors(this.boundingBox.max,Ii.max),this.boundingBox.expandByPoint(Fn)):(this.boundingBox.expandByPoint(Ii.min),this.boundingBox.expandByPoint(Ii.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(e){let i=this.boundingSphere.center;if(Ii.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ya.setFromBufferAttribute(a),this.morphTargetsRelative?(Fn.addVectors(Ii.min,Ya.min),Ii.expandByPoint(Fn),Fn.addVectors(Ii.max,Ya.max),Ii.expandByPoint(Fn)):(Ii.expandByPoint(Ya.min),Ii.expandByPoint(Ya.max))}Ii.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Fn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Fn.fromBufferAttribute(a,c),l&&(Yo.fromBufferAttribute(e,c),Fn.add(Yo)),s=Math.max(s,i.distanceToSquared(Fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new bn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let H=0;H<i.count;H++)a[H]=new z,l[H]=new z;let u=new z,f=new z,h=new z,d=new Ke,p=new Ke,b=new Ke,m=new z,g=new z;function v(H,U,L){c[H]=c[U]=c[L]=1,u.fromBufferAttribute(i,H),f.fromBufferAttribute(i,U),h.fromBufferAttribute(i,L),d.fromBufferAttribute(r,H),p.fromBufferAttribute(r,U),b.fromBufferAttribute(r,L),f.sub(u),h.sub(u),p.sub(d),b.sub(d);let G=1/(p.x*b.y-b.x*p.y);isFinite(G)&&(m.copy(f).multiplyScalar(b.y).addScaledVector(h,-p.y).multiplyScalar(G),g.copy(h).multiplyScalar(p.x).addScaledVector(f,-b.x).multiplyScalar(G),a[H].add(m),a[U].add(m),a[L].add(m),l[H].add(g),l[U].add(g),l[L].add(g))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let H=0,U=C.length;H<U;++H){let L=C[H],G=L.start,V=L.count;for(let N=G,W=G+V;N<W;N+=3)v(e.getX(N+0),e.getX(N+1),e.getX(N+2))}let S=new z,I=new z,T=new z,x=new z;function E(H){T.fromBufferAttribute(s,H),x.copy(T);let U=a[H];S.copy(U),S.sub(T.multiplyScalar(T.dot(U))).normalize(),I.crossVectors(x,U);let G=I.dot(l[H])<0?-1:1;o.setXYZW(H,S.x,S.y,S.z,G)}for(let H=0,U=i.count;H<U;++H)c[H]&&E(H);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new bn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,f=new z;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),b=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,m),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Fn.fromBufferAttribute(e,t),Fn.normalize(),e.setXYZ(t,Fn.x,Fn.y,Fn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let b=0,m=l.length;b<m;b++){a.isInterleavedBufferAttribute?d=l[b]*a.data.stride+a.offset:d=l[b]*u;for(let g=0;g<u;g++)h[p++]=c[d++]}return new bn(h,u,f)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Tu=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Lp,this.updateRanges=[],this.version=0,this.uuid=Ir()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Q_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=Q_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function Q_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Ir()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var li=new z,is=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?Dh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)li.fromBufferAttribute(this,t),li.applyMatrix4(e),this.setXYZ(t,li.x,li.y,li.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)li.fromBufferAttribute(this,t),li.applyNormalMatrix(e),this.setXYZ(t,li.x,li.y,li.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)li.fromBufferAttribute(this,t),li.transformDirection(e),this.setXYZ(t,li.x,li.y,li.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){il("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new bn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){il("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Op(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Fp(e,this.data.array)}},Yf=new z,kw=new z,zw=new st,ci=class{constructor(e=new z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Yf.subVectors(i,t).cross(kw.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Yf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||zw.getNormalMatrix(e),s=this.coplanarPoint(Yf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},Vw=0,xs=class extends ns{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:Vw++}),this.uuid=Ir(),this.name="",this.type="Material",this.blending=fa,this.side=Rr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=dp,this.blendDst=fp,this.blendEquation=Kr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new dt(0,0,0),this.blendAlpha=0,this.depthFunc=yr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Xx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=du,this.stencilZFail=du,this.stencilZPass=du,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new dt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new ci().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Gs=new z,Jf=new z,qc=new z,Yc=new z,vr=class{constructor(e=new z,t=new z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Gs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Gs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Gs.copy(this.origin).addScaledVector(this.direction,t),Gs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Jf.copy(e).add(t).multiplyScalar(.5),qc.copy(t).sub(e).normalize(),Yc.copy(this.origin).sub(Jf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(qc),a=Yc.dot(this.direction),l=-Yc.dot(qc),c=Yc.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let b=1/u;f*=b,h*=b,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Jf).addScaledVector(qc,h),d}intersectSphere(e,t){if(e.radius<0)return null;Gs.subVectors(e.center,this.origin);let i=Gs.dot(this.direction),s=Gs.dot(Gs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Gs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,b=t.y-o.y,m=t.z-o.z,g=i.x-o.x,v=i.y-o.y,C=i.z-o.z,S=Math.abs(l),I=Math.abs(c),T=Math.abs(u),x,E,H,U,L,G,V,N,W,q,O,re;if(S>=I&&S>=T?(H=l,G=f,W=p,re=g,l>=0?(x=c,E=u,U=h,L=d,V=b,N=m,q=v,O=C):(x=u,E=c,U=d,L=h,V=m,N=b,q=C,O=v)):I>=T?(H=c,G=h,W=b,re=v,c>=0?(x=u,E=l,U=d,L=f,V=m,N=p,q=C,O=g):(x=l,E=u,U=f,L=d,V=p,N=m,q=g,O=C)):(H=u,G=d,W=m,re=C,u>=0?(x=l,E=c,U=f,L=h,V=p,N=b,q=g,O=v):(x=c,E=l,U=h,L=f,V=b,N=p,q=v,O=g)),H===0)return null;let J=x/H,ee=E/H,ie=1/H,de=U-J*G,he=L-ee*G,Q=V-J*W,me=N-ee*W,ge=q-J*re,Ee=O-ee*re,ye=ge*me-Ee*Q,We=de*Ee-he*ge,Ne=Q*he-me*de;if(s){if(ye<0||We<0||Ne<0)return null}else if((ye<0||We<0||Ne<0)&&(ye>0||We>0||Ne>0))return null;let Le=ye+We+Ne;if(Le===0)return null;let at=ie*(ye*G+We*W+Ne*re);return(Le>0?at<0:at>0)?null:this.at(at/Le,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},oa=class extends xs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new dt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new $s,this.combine=$u,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},ex=new St,qr=new vr,Jc=new Vn,tx=new z,Zc=new z,Kc=new z,jc=new z,Zf=new z,Qc=new z,nx=new z,eu=new z,Hn=class extends zn{constructor(e=new Sn,t=new oa){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Qc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(Zf.fromBufferAttribute(f,e),o?Qc.addScaledVector(Zf,u):Qc.addScaledVector(Zf.sub(t),u))}t.add(Qc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Jc.copy(i.boundingSphere),Jc.applyMatrix4(r),qr.copy(e.ray).recast(e.near),!(Jc.containsPoint(qr.origin)===!1&&(qr.intersectSphere(Jc,tx)===null||qr.origin.distanceToSquared(tx)>(e.far-e.near)**2))&&(ex.copy(r).invert(),qr.copy(e.ray).applyMatrix4(ex),!(i.boundingBox!==null&&qr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,qr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let m=h[p],g=o[m.materialIndex],v=Math.max(m.start,d.start),C=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let S=v,I=C;S<I;S+=3){let T=a.getX(S),x=a.getX(S+1),E=a.getX(S+2);s=tu(this,g,e,i,c,u,f,T,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(a.count,d.start+d.count);for(let m=p,g=b;m<g;m+=3){let v=a.getX(m),C=a.getX(m+1),S=a.getX(m+2);s=tu(this,o,e,i,c,u,f,v,C,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let m=h[p],g=o[m.materialIndex],v=Math.max(m.start,d.start),C=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let S=v,I=C;S<I;S+=3){let T=S,x=S+1,E=S+2;s=tu(this,g,e,i,c,u,f,T,x,E),s&&(s.faceIndex=Math.floor(S/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let m=p,g=b;m<g;m+=3){let v=m,C=m+1,S=m+2;s=tu(this,o,e,i,c,u,f,v,C,S),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function Hw(n,e,t,i,s,r,o,a){let l;if(e.side===di?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Rr,a),l===null)return null;eu.copy(a),eu.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(eu);return c<t.near||c>t.far?null:{distance:c,point:eu.clone(),object:n}}function tu(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Zc),n.getVertexPosition(l,Kc),n.getVertexPosition(c,jc);let u=Hw(n,e,t,i,Zc,Kc,jc,nx);if(u){let f=new z;xr.getBarycoord(nx,Zc,Kc,jc,f),s&&(u.uv=xr.getInterpolatedAttribute(s,a,l,c,f,new Ke)),r&&(u.uv1=xr.getInterpolatedAttribute(r,a,l,c,f,new Ke)),o&&(u.normal=xr.getInterpolatedAttribute(o,a,l,c,f,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new z,materialIndex:0};xr.getNormal(Zc,Kc,jc,h.normal),u.face=h,u.barycoord=f}return u}var aa=class extends _i{constructor(e=null,t=1,i=1,s,r,o,a,l,c=hn,u=hn,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Yr=new Vn,Gw=new Ke(.5,.5),nu=new z,br=class{constructor(e=new ci,t=new ci,i=new ci,s=new ci,r=new ci,o=new ci){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Hi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],b=r[9],m=r[10],g=r[11],v=r[12],C=r[13],S=r[14],I=r[15];if(s[0].setComponents(c-o,d-u,g-p,I-v).normalize(),s[1].setComponents(c+o,d+u,g+p,I+v).normalize(),s[2].setComponents(c+a,d+f,g+b,I+C).normalize(),s[3].setComponents(c-a,d-f,g-b,I-C).normalize(),i)s[4].setComponents(l,h,m,S).normalize(),s[5].setComponents(c-l,d-h,g-m,I-S).normalize();else if(s[4].setComponents(c-l,d-h,g-m,I-S).normalize(),t===Hi)s[5].setComponents(c+l,d+h,g+m,I+S).normalize();else if(t===ta)s[5].setComponents(l,h,m,S).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Yr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Yr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Yr)}intersectsSprite(e){Yr.center.set(0,0,0);let t=Gw.distanceTo(e.center);return Yr.radius=.7071067811865476+t,Yr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Yr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(nu.x=s.normal.x>0?e.max.x:e.min.x,nu.y=s.normal.y>0?e.max.y:e.min.y,nu.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(nu)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},ix=new St,Eu=class n{constructor(){this.coordinateSystem=Hi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];ix.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new br),i[s].setFromProjectionMatrix(ix,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new br),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Sr=class extends xs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new dt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Cu=new z,Ru=new z,sx=new St,Ja=new vr,iu=new Vn,Kf=new z,rx=new z,Pu=class extends zn{constructor(e=new Sn,t=new Sr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Cu.fromBufferAttribute(t,s-1),Ru.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Cu.distanceTo(Ru);e.setAttribute("lineDistance",new kn(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),iu.copy(i.boundingSphere),iu.applyMatrix4(s),iu.radius+=r,e.ray.intersectsSphere(iu)===!1)return;sx.copy(s).invert(),Ja.copy(e.ray).applyMatrix4(sx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let g=u.getX(b),v=u.getX(b+1),C=su(this,e,Ja,l,g,v,b);C&&t.push(C)}if(this.isLineLoop){let b=u.getX(p-1),m=u.getX(d),g=su(this,e,Ja,l,b,m,p-1);g&&t.push(g)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let g=su(this,e,Ja,l,b,b+1,b);g&&t.push(g)}if(this.isLineLoop){let b=su(this,e,Ja,l,p-1,d,p-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function su(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Cu.fromBufferAttribute(a,s),Ru.fromBufferAttribute(a,r),t.distanceSqToSegment(Cu,Ru,Kf,rx)>i)return;Kf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Kf);if(!(c<e.near||c>e.far))return{distance:c,point:rx.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var ox=new z,ax=new z,Jr=class extends Pu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)ox.fromBufferAttribute(t,s),ax.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+ox.distanceTo(ax);e.setAttribute("lineDistance",new kn(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var la=class extends xs{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new dt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},lx=new St,sp=new vr,ru=new Vn,ou=new z,cl=class extends zn{constructor(e=new Sn,t=new la){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),ru.copy(i.boundingSphere),ru.applyMatrix4(s),ru.radius+=r,e.ray.intersectsSphere(ru)===!1)return;lx.copy(s).invert(),sp.copy(e.ray).applyMatrix4(lx);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,f=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let p=h,b=d;p<b;p++){let m=c.getX(p);ou.fromBufferAttribute(f,m),cx(ou,m,l,s,e,t,this)}}else{let h=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let p=h,b=d;p<b;p++)ou.fromBufferAttribute(f,p),cx(ou,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function cx(n,e,t,i,s,r,o){let a=sp.distanceSqToPoint(n);if(a<t){let l=new z;sp.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var ul=class extends _i{constructor(e=[],t=jr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var qs=class extends _i{constructor(e,t,i=ss,s,r,o,a=hn,l=hn,c,u=Xs,f=1){if(u!==Xs&&u!==Js)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new sa(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},hl=class extends qs{constructor(e,t=ss,i=jr,s,r,o=hn,a=hn,l,c=Xs){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},dl=class extends _i{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ca=class n extends Sn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new kn(c,3)),this.setAttribute("normal",new kn(u,3)),this.setAttribute("uv",new kn(f,2));function p(b,m,g,v,C,S,I,T,x,E,H){let U=S/x,L=I/E,G=S/2,V=I/2,N=T/2,W=x+1,q=E+1,O=0,re=0,J=new z;for(let ee=0;ee<q;ee++){let ie=ee*L-V;for(let de=0;de<W;de++){let he=de*U-G;J[b]=he*v,J[m]=ie*C,J[g]=N,c.push(J.x,J.y,J.z),J[b]=0,J[m]=0,J[g]=T>0?1:-1,u.push(J.x,J.y,J.z),f.push(de/x),f.push(1-ee/E),O+=1}}for(let ee=0;ee<E;ee++)for(let ie=0;ie<x;ie++){let de=h+ie+W*ee,he=h+ie+W*(ee+1),Q=h+(ie+1)+W*(ee+1),me=h+(ie+1)+W*ee;l.push(de,he,me),l.push(he,Q,me),re+=6}a.addGroup(d,re,H),d+=re,h+=O}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var fl=class n extends Sn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],b=[],m=[];for(let g=0;g<u;g++){let v=g*h-o;for(let C=0;C<c;C++){let S=C*f-r;p.push(S,-v,0),b.push(0,0,1),m.push(C/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let C=v+c*g,S=v+c*(g+1),I=v+1+c*(g+1),T=v+1+c*g;d.push(C,S,T),d.push(S,I,T)}this.setIndex(d),this.setAttribute("position",new kn(p,3)),this.setAttribute("normal",new kn(b,3)),this.setAttribute("uv",new kn(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var pl=class extends Sn{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new z,r=new z;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let f=l[c],h=f.start,d=f.count;for(let p=h,b=h+d;p<b;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),v=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,v),ux(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,f=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,f),ux(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new kn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function ux(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function eo(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(hx(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(hx(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function ti(n){let e={};for(let t=0;t<n.length;t++){let i=eo(n[t]);for(let s in i)e[s]=i[s]}return e}function hx(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function Ww(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function Bp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var Nl={clone:eo,merge:ti},Xw=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,$w=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,Gi=class extends xs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=Xw,this.fragmentShader=$w,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=eo(e.uniforms),this.uniformsGroups=Ww(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new dt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[i].value=new z().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Lt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new st().fromArray(s.value);break;case"m4":this.uniforms[i].value=new St().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Iu=class extends Gi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var ml=class extends xs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new dt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new dt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Lh,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new $s,this.combine=$u,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Lu=class extends xs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Gx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Du=class extends xs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Jo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function au(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Mr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Nu=class extends Mr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:tp,endingEnd:tp}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case np:r=e,a=2*t-i;break;case ip:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case np:o=e,l=2*i-t;break;case ip:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),b=p*p,m=b*p,g=-h*m+2*h*b-h*p,v=(1+h)*m+(-1.5-2*h)*b+(-.5+h)*p+1,C=(-1-d)*m+(1.5+d)*b+.5*p,S=d*m-d*b;for(let I=0;I!==a;++I)r[I]=g*o[u+I]+v*o[c+I]+C*o[l+I]+S*o[f+I];return r}},Uu=class extends Mr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Ou=class extends Mr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Fu=class extends Mr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),b=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*b+o[l+m]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let b=o[c+p],m=o[l+p],g=d*h+p*2,v=f[g],C=f[g+1],S=e*h+p*2,I=u[S],T=u[S+1],x=Yw(i,t,v,I,s);r[p]=ny(x,b,C,T,m)}return r}};function ny(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function qw(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function Yw(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=ny(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=qw(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Ni=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Jo(t,this.TimeBufferType),this.values=Jo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Jo(e.times,Array),values:Jo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),au(e.settings)&&(i.settings={inTangents:Jo(e.settings.inTangents,Array),outTangents:Jo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Ou(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Uu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Nu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Fu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Qa:t=this.InterpolantFactoryMethodDiscrete;break;case Su:t=this.InterpolantFactoryMethodLinear;break;case hu:t=this.InterpolantFactoryMethodSmooth;break;case ep:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Qa;case this.InterpolantFactoryMethodLinear:return Su;case this.InterpolantFactoryMethodSmooth:return hu;case this.InterpolantFactoryMethodBezier:return ep}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;au(this.settings)&&(dx(this.settings.inTangents,e),dx(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;au(this.settings)&&(fx(this.settings.inTangents,e),fx(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&uw(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===hu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let b=t[f+p];if(b!==t[h+p]||b!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,au(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function dx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function fx(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Ni.prototype.ValueTypeName="";Ni.prototype.TimeBufferType=Float32Array;Ni.prototype.ValueBufferType=Float32Array;Ni.prototype.DefaultInterpolation=Su;var wr=class extends Ni{constructor(e,t,i){super(e,t,i)}};wr.prototype.ValueTypeName="bool";wr.prototype.ValueBufferType=Array;wr.prototype.DefaultInterpolation=Qa;wr.prototype.InterpolantFactoryMethodLinear=void 0;wr.prototype.InterpolantFactoryMethodSmooth=void 0;var Bu=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}};Bu.prototype.ValueTypeName="color";var ku=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}};ku.prototype.ValueTypeName="number";var zu=class extends Mr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Li.slerpFlat(r,0,o,c-a,o,c,l);return r}},gl=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new zu(this.times,this.values,this.getValueSize(),e)}};gl.prototype.ValueTypeName="quaternion";gl.prototype.InterpolantFactoryMethodSmooth=void 0;var Ar=class extends Ni{constructor(e,t,i){super(e,t,i)}};Ar.prototype.ValueTypeName="string";Ar.prototype.ValueBufferType=Array;Ar.prototype.DefaultInterpolation=Qa;Ar.prototype.InterpolantFactoryMethodLinear=void 0;Ar.prototype.InterpolantFactoryMethodSmooth=void 0;var Vu=class extends Ni{constructor(e,t,i,s){super(e,t,i,s)}};Vu.prototype.ValueTypeName="vector";var Hu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},iy=new Hu,Gu=class{constructor(e){this.manager=e!==void 0?e:iy,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Gu.DEFAULT_MATERIAL_NAME="__DEFAULT";var _l=class extends zn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new dt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},xl=class extends _l{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(zn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new dt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},jf=new St,px=new z,mx=new z,Wu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=yi,this.map=null,this.mapPass=null,this.matrix=new St,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new br,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Lt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;px.setFromMatrixPosition(e.matrixWorld),t.position.copy(px),mx.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(mx),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){jf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(jf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===ta||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(jf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},lu=new z,cu=new Li,gs=new z,yl=class extends zn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new St,this.projectionMatrix=new St,this.projectionMatrixInverse=new St,this.coordinateSystem=Hi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(lu,cu,gs),gs.x===1&&gs.y===1&&gs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(lu,cu,gs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(lu,cu,gs),gs.x===1&&gs.y===1&&gs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(lu,cu,gs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},_r=new z,gx=new Ke,_x=new Ke,ui=class extends yl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=ia*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Ka*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return ia*2*Math.atan(Math.tan(Ka*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){_r.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(_r.x,_r.y).multiplyScalar(-e/_r.z),_r.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(_r.x,_r.y).multiplyScalar(-e/_r.z)}getViewSize(e,t){return this.getViewBounds(e,gx,_x),t.subVectors(_x,gx)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Ka*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var vl=class extends yl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},rp=class extends Wu{constructor(){super(new vl(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},bl=class extends _l{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(zn.DEFAULT_UP),this.updateMatrix(),this.target=new zn,this.shadow=new rp}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var Sl=class extends Sn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Zo=-90,Ko=1,ua=class extends zn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ui(Zo,Ko,e,t);s.layers=this.layers,this.add(s);let r=new ui(Zo,Ko,e,t);r.layers=this.layers,this.add(r);let o=new ui(Zo,Ko,e,t);o.layers=this.layers,this.add(o);let a=new ui(Zo,Ko,e,t);a.layers=this.layers,this.add(a);let l=new ui(Zo,Ko,e,t);l.layers=this.layers,this.add(l);let c=new ui(Zo,Ko,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Hi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===ta)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Xu=class extends ui{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var kp="\\[\\]\\.:\\/",Jw=new RegExp("["+kp+"]","g"),zp="[^"+kp+"]",Zw="[^"+kp.replace("\\.","")+"]",Kw=/((?:WC+[\/:])*)/.source.replace("WC",zp),jw=/(WCOD+)?/.source.replace("WCOD",Zw),Qw=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",zp),e1=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",zp),t1=new RegExp("^"+Kw+jw+Qw+e1+"$"),n1=["material","materials","bones","map"],op=class{constructor(e,t,i){let s=i||jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(Jw,"")}static parseTrackName(e){let t=t1.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);n1.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};jt.Composite=op;jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};jt.prototype.GetterByBindingType=[jt.prototype._getValue_direct,jt.prototype._getValue_array,jt.prototype._getValue_arrayElement,jt.prototype._getValue_toArray];jt.prototype.SetterByBindingTypeAndVersioning=[[jt.prototype._setValue_direct,jt.prototype._setValue_direct_setNeedsUpdate,jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_array,jt.prototype._setValue_array_setNeedsUpdate,jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_arrayElement,jt.prototype._setValue_arrayElement_setNeedsUpdate,jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[jt.prototype._setValue_fromArray,jt.prototype._setValue_fromArray_setNeedsUpdate,jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var uI=new Float32Array(1);var Tr=class extends Tu{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var ha=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ct(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ct(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var ap=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var xx=new z,uu=new z,jo=new z,Qo=new z,Qf=new z,i1=new z,s1=new z,Ml=class{constructor(e=new z,t=new z){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){xx.subVectors(e,this.start),uu.subVectors(this.end,this.start);let i=uu.dot(uu);if(i===0)return 0;let r=uu.dot(xx)/i;return t&&(r=ct(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=i1,i=s1){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;jo.subVectors(c,a),Qo.subVectors(u,l),Qf.subVectors(a,l);let f=jo.dot(jo),h=Qo.dot(Qo),d=Qo.dot(Qf);if(f<=s&&h<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(f<=s)r=0,o=d/h,o=ct(o,0,1);else{let p=jo.dot(Qf);if(h<=s)o=0,r=ct(-p/f,0,1);else{let b=jo.dot(Qo),m=f*h-b*b;m!==0?r=ct((b*d-p*h)/m,0,1):r=0,o=(b*r+d)/h,o<0?(o=0,r=ct(-p/f,0,1)):o>1&&(o=1,r=ct((b-p)/f,0,1))}}return t.copy(a).addScaledVector(jo,r),i.copy(l).addScaledVector(Qo,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var wl=class extends ns{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function Vp(n,e,t,i){let s=r1(i);switch(t){case Tp:return n*e;case Cp:return n*e/s.components*s.byteLength;case Qu:return n*e/s.components*s.byteLength;case Pr:return n*e*2/s.components*s.byteLength;case eh:return n*e*2/s.components*s.byteLength;case Ep:return n*e*3/s.components*s.byteLength;case Ui:return n*e*4/s.components*s.byteLength;case th:return n*e*4/s.components*s.byteLength;case El:case Cl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Rl:case Pl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case ih:case rh:return Math.max(n,16)*Math.max(e,8)/4;case nh:case sh:return Math.max(n,8)*Math.max(e,8)/2;case oh:case ah:case ch:case uh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case lh:case Il:case hh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case dh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ph:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case mh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case gh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case _h:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case xh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case yh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case vh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case bh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Sh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Mh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case wh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Ah:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Th:case Eh:case Ch:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Rh:case Ph:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Ll:case Ih:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function r1(n){switch(n){case yi:case Sp:return{byteLength:1,components:1};case ma:case Mp:case os:return{byteLength:2,components:1};case Ku:case ju:return{byteLength:2,components:4};case ss:case Zu:case rs:return{byteLength:4,components:1};case wp:case Ap:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Ay(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function a1(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],b=f[d];b.start<=p.start+p.count+1?p.count=Math.max(p.count,b.start+b.count-p.start):(++h,f[h]=b)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let b=f[d];n.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var l1=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,c1=`#ifdef USE_ALPHAHASH
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
#endif`,u1=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,h1=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,d1=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,f1=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,p1=`#ifdef USE_AOMAP
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
#endif`,m1=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,g1=`#ifdef USE_BATCHING
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
#endif`,_1=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,x1=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,y1=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,v1=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,b1=`#ifdef USE_IRIDESCENCE
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
#endif`,S1=`#ifdef USE_BUMPMAP
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
#endif`,M1=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,w1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,A1=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,T1=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,E1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,C1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,R1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,P1=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,I1=`#define PI 3.141592653589793
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
} // validated`,L1=`vec3 transformedNormal = objectNormal;
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
#endif`,D1=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,N1=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,U1=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,O1=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,F1="gl_FragColor = linearToOutputTexel( gl_FragColor );",B1=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,k1=`#ifdef USE_ENVMAP
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
#endif`,z1=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,V1=`#ifdef USE_ENVMAP
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
#endif`,H1=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,G1=`#ifdef USE_ENVMAP
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
#endif`,W1=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,X1=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,$1=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,q1=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Y1=`#ifdef USE_GRADIENTMAP
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
}`,J1=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Z1=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,K1=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,j1=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Q1=`#ifdef USE_ENVMAP
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
#endif`,eA=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,tA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,nA=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,iA=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,sA=`PhysicalMaterial material;
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
#endif`,rA=`uniform sampler2D dfgLUT;
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
}`,oA=`
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
#endif`,aA=`#if defined( RE_IndirectDiffuse )
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
#endif`,lA=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,cA=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,uA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,hA=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,dA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,fA=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,pA=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,mA=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,gA=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,_A=`#if defined( USE_POINTS_UV )
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
#endif`,xA=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,yA=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,vA=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,bA=`#if defined( USE_MORPHCOLORS )
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
#endif`,SA=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,MA=`#ifdef USE_MORPHTARGETS
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
#endif`,wA=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,AA=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,TA=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,EA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,CA=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,RA=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,PA=`#ifdef USE_NORMALMAP
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
#endif`,IA=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,LA=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,DA=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,NA=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,UA=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,OA=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,FA=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,BA=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,kA=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,zA=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,VA=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,HA=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,GA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,WA=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,XA=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,$A=`float getShadowMask() {
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
}`,qA=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,YA=`#ifdef USE_SKINNING
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
#endif`,JA=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,ZA=`#ifdef USE_SKINNING
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
#endif`,KA=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,jA=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,QA=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,eT=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,tT=`#ifdef USE_TRANSMISSION
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
#endif`,nT=`#ifdef USE_TRANSMISSION
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
#endif`,iT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,sT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,rT=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,oT=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,aT=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,lT=`uniform sampler2D t2D;
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
}`,cT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,uT=`uniform float backgroundBlurriness;
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
}`,hT=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,dT=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,fT=`#include <common>
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
}`,pT=`#if DEPTH_PACKING == 3200
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
}`,mT=`#define DISTANCE
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
}`,gT=`#define DISTANCE
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
}`,_T=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,xT=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,yT=`uniform float scale;
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
}`,vT=`uniform vec3 diffuse;
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
}`,bT=`#include <common>
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
}`,ST=`uniform vec3 diffuse;
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
}`,MT=`#define LAMBERT
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
}`,wT=`#define LAMBERT
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
}`,AT=`#define MATCAP
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
}`,TT=`#define MATCAP
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
}`,ET=`#define NORMAL
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
}`,CT=`#define NORMAL
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
}`,RT=`#define PHONG
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
}`,PT=`#define PHONG
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
}`,IT=`#define STANDARD
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
}`,LT=`#define STANDARD
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
}`,DT=`#define TOON
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
}`,NT=`#define TOON
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
}`,UT=`uniform float size;
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
}`,OT=`uniform vec3 diffuse;
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
}`,FT=`#include <common>
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
}`,BT=`uniform vec3 color;
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
}`,kT=`uniform float rotation;
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
}`,zT=`uniform vec3 diffuse;
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
}`,pt={alphahash_fragment:l1,alphahash_pars_fragment:c1,alphamap_fragment:u1,alphamap_pars_fragment:h1,alphatest_fragment:d1,alphatest_pars_fragment:f1,aomap_fragment:p1,aomap_pars_fragment:m1,batching_pars_vertex:g1,batching_vertex:_1,begin_vertex:x1,beginnormal_vertex:y1,bsdfs:v1,iridescence_fragment:b1,bumpmap_pars_fragment:S1,clipping_planes_fragment:M1,clipping_planes_pars_fragment:w1,clipping_planes_pars_vertex:A1,clipping_planes_vertex:T1,color_fragment:E1,color_pars_fragment:C1,color_pars_vertex:R1,color_vertex:P1,common:I1,defaultnormal_vertex:L1,displacementmap_pars_vertex:D1,displacementmap_vertex:N1,emissivemap_fragment:U1,emissivemap_pars_fragment:O1,colorspace_fragment:F1,colorspace_pars_fragment:B1,envmap_fragment:k1,envmap_common_pars_fragment:z1,envmap_pars_fragment:V1,envmap_pars_vertex:H1,envmap_physical_pars_fragment:Q1,envmap_vertex:G1,fog_vertex:W1,fog_pars_vertex:X1,fog_fragment:$1,fog_pars_fragment:q1,gradientmap_pars_fragment:Y1,lightmap_pars_fragment:J1,lights_lambert_fragment:Z1,lights_lambert_pars_fragment:K1,lights_pars_begin:j1,lights_toon_fragment:eA,lights_toon_pars_fragment:tA,lights_phong_fragment:nA,lights_phong_pars_fragment:iA,lights_physical_fragment:sA,lights_physical_pars_fragment:rA,lights_fragment_begin:oA,lights_fragment_maps:aA,lights_fragment_end:lA,lightprobes_pars_fragment:cA,logdepthbuf_fragment:uA,logdepthbuf_pars_fragment:hA,logdepthbuf_pars_vertex:dA,logdepthbuf_vertex:fA,map_fragment:pA,map_pars_fragment:mA,map_particle_fragment:gA,map_particle_pars_fragment:_A,metalnessmap_fragment:xA,metalnessmap_pars_fragment:yA,morphinstance_vertex:vA,morphcolor_vertex:bA,morphnormal_vertex:SA,morphtarget_pars_vertex:MA,morphtarget_vertex:wA,normal_fragment_begin:AA,normal_fragment_maps:TA,normal_pars_fragment:EA,normal_pars_vertex:CA,normal_vertex:RA,normalmap_pars_fragment:PA,clearcoat_normal_fragment_begin:IA,clearcoat_normal_fragment_maps:LA,clearcoat_pars_fragment:DA,iridescence_pars_fragment:NA,opaque_fragment:UA,packing:OA,premultiplied_alpha_fragment:FA,project_vertex:BA,dithering_fragment:kA,dithering_pars_fragment:zA,roughnessmap_fragment:VA,roughnessmap_pars_fragment:HA,shadowmap_pars_fragment:GA,shadowmap_pars_vertex:WA,shadowmap_vertex:XA,shadowmask_pars_fragment:$A,skinbase_vertex:qA,skinning_pars_vertex:YA,skinning_vertex:JA,skinnormal_vertex:ZA,specularmap_fragment:KA,specularmap_pars_fragment:jA,tonemapping_fragment:QA,tonemapping_pars_fragment:eT,transmission_fragment:tT,transmission_pars_fragment:nT,uv_pars_fragment:iT,uv_pars_vertex:sT,uv_vertex:rT,worldpos_vertex:oT,background_vert:aT,background_frag:lT,backgroundCube_vert:cT,backgroundCube_frag:uT,cube_vert:hT,cube_frag:dT,depth_vert:fT,depth_frag:pT,distance_vert:mT,distance_frag:gT,equirect_vert:_T,equirect_frag:xT,linedashed_vert:yT,linedashed_frag:vT,meshbasic_vert:bT,meshbasic_frag:ST,meshlambert_vert:MT,meshlambert_frag:wT,meshmatcap_vert:AT,meshmatcap_frag:TT,meshnormal_vert:ET,meshnormal_frag:CT,meshphong_vert:RT,meshphong_frag:PT,meshphysical_vert:IT,meshphysical_frag:LT,meshtoon_vert:DT,meshtoon_frag:NT,points_vert:UT,points_frag:OT,shadow_vert:FT,shadow_frag:BT,sprite_vert:kT,sprite_frag:zT},Pe={common:{diffuse:{value:new dt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new dt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new dt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new dt(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},fi={basic:{uniforms:ti([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:ti([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new dt(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:ti([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new dt(0)},specular:{value:new dt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:ti([Pe.common,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.roughnessmap,Pe.metalnessmap,Pe.fog,Pe.lights,{emissive:{value:new dt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:ti([Pe.common,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.gradientmap,Pe.fog,Pe.lights,{emissive:{value:new dt(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:ti([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:ti([Pe.points,Pe.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:ti([Pe.common,Pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:ti([Pe.common,Pe.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:ti([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:ti([Pe.sprite,Pe.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:ti([Pe.common,Pe.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:ti([Pe.lights,Pe.fog,{color:{value:new dt(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};fi.physical={uniforms:ti([fi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new dt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new dt(0)},specularColor:{value:new dt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var Nh={r:0,b:0,g:0},VT=new St,Ty=new st;Ty.set(-1,0,0,0,1,0,0,0,1);function HT(n,e,t,i,s,r){let o=new dt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(v){let C=v.isScene===!0?v.background:null;if(C&&C.isTexture){let S=v.backgroundBlurriness>0;C=e.get(C,S)}return C}function p(v){let C=!1,S=d(v);S===null?m(o,a):S&&S.isColor&&(m(S,1),C=!0);let I=n.xr.getEnvironmentBlendMode();I==="additive"?t.buffers.color.setClear(0,0,0,1,r):I==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(v,C){let S=d(C);S&&S.isCubeTexture?(c===void 0&&(c=new Hn(new ca(1,1,1),new Gi({name:"BackgroundCubeMaterial",uniforms:eo(fi.backgroundCube.uniforms),vertexShader:fi.backgroundCube.vertexShader,fragmentShader:fi.backgroundCube.fragmentShader,side:di,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(I,T,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=S,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(VT.makeRotationFromEuler(C.backgroundRotation)).transpose(),S.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ty),c.material.toneMapped=vt.getTransfer(S.colorSpace)!==It,(u!==S||f!==S.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):S&&S.isTexture&&(l===void 0&&(l=new Hn(new fl(2,2),new Gi({name:"BackgroundMaterial",uniforms:eo(fi.background.uniforms),vertexShader:fi.background.vertexShader,fragmentShader:fi.background.fragmentShader,side:Rr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=S,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=vt.getTransfer(S.colorSpace)!==It,S.matrixAutoUpdate===!0&&S.updateMatrix(),l.material.uniforms.uvTransform.value.copy(S.matrix),(u!==S||f!==S.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=S,f=S.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,C){v.getRGB(Nh,Bp(n)),t.buffers.color.setClear(Nh.r,Nh.g,Nh.b,C,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,C=1){o.set(v),a=C,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:b,dispose:g}}function GT(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,G,V,N,W){let q=!1,O=f(L,N,V,G);r!==O&&(r=O,c(r.object)),q=d(L,N,V,W),q&&p(L,N,V,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,S(L,G,V,N),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function f(L,G,V,N){let W=N.wireframe===!0,q=i[G.id];q===void 0&&(q={},i[G.id]=q);let O=L.isInstancedMesh===!0?L.id:0,re=q[O];re===void 0&&(re={},q[O]=re);let J=re[V.id];J===void 0&&(J={},re[V.id]=J);let ee=J[W];return ee===void 0&&(ee=h(l()),J[W]=ee),ee}function h(L){let G=[],V=[],N=[];for(let W=0;W<t;W++)G[W]=0,V[W]=0,N[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:G,enabledAttributes:V,attributeDivisors:N,object:L,attributes:{},index:null}}function d(L,G,V,N){let W=r.attributes,q=G.attributes,O=0,re=V.getAttributes();for(let J in re)if(re[J].location>=0){let ie=W[J],de=q[J];if(de===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(de=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(de=L.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;O++}return r.attributesNum!==O||r.index!==N}function p(L,G,V,N){let W={},q=G.attributes,O=0,re=V.getAttributes();for(let J in re)if(re[J].location>=0){let ie=q[J];ie===void 0&&(J==="instanceMatrix"&&L.instanceMatrix&&(ie=L.instanceMatrix),J==="instanceColor"&&L.instanceColor&&(ie=L.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),W[J]=de,O++}r.attributes=W,r.attributesNum=O,r.index=N}function b(){let L=r.newAttributes;for(let G=0,V=L.length;G<V;G++)L[G]=0}function m(L){g(L,0)}function g(L,G){let V=r.newAttributes,N=r.enabledAttributes,W=r.attributeDivisors;V[L]=1,N[L]===0&&(n.enableVertexAttribArray(L),N[L]=1),W[L]!==G&&(n.vertexAttribDivisor(L,G),W[L]=G)}function v(){let L=r.newAttributes,G=r.enabledAttributes;for(let V=0,N=G.length;V<N;V++)G[V]!==L[V]&&(n.disableVertexAttribArray(V),G[V]=0)}function C(L,G,V,N,W,q,O){O===!0?n.vertexAttribIPointer(L,G,V,W,q):n.vertexAttribPointer(L,G,V,N,W,q)}function S(L,G,V,N){b();let W=N.attributes,q=V.getAttributes(),O=G.defaultAttributeValues;for(let re in q){let J=q[re];if(J.location>=0){let ee=W[re];if(ee===void 0&&(re==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),re==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor)),ee!==void 0){let ie=ee.normalized,de=ee.itemSize,he=e.get(ee);if(he===void 0)continue;let Q=he.buffer,me=he.type,ge=he.bytesPerElement,Ee=me===n.INT||me===n.UNSIGNED_INT||ee.gpuType===Zu;if(ee.isInterleavedBufferAttribute){let ye=ee.data,We=ye.isInterleavedBuffer===!0?ye.stride:ye.itemSize,Ne=ee.offset;if(ye.isInstancedInterleavedBuffer||ye.isInstancedBufferAttribute){for(let Le=0;Le<J.locationSize;Le++)g(J.location+Le,ye.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ye.meshPerAttribute*ye.count)}else for(let Le=0;Le<J.locationSize;Le++)m(J.location+Le);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let Le=0;Le<J.locationSize;Le++)C(J.location+Le,de/J.locationSize,me,ie,We*ge,(Ne+de/J.locationSize*Le)*ge,Ee)}else{if(ee.isInstancedBufferAttribute){for(let ye=0;ye<J.locationSize;ye++)g(J.location+ye,ee.meshPerAttribute);L.isInstancedMesh!==!0&&N._maxInstanceCount===void 0&&(N._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let ye=0;ye<J.locationSize;ye++)m(J.location+ye);n.bindBuffer(n.ARRAY_BUFFER,Q);for(let ye=0;ye<J.locationSize;ye++)C(J.location+ye,de/J.locationSize,me,ie,de*ge,de/J.locationSize*ye*ge,Ee)}}else if(O!==void 0){let ie=O[re];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(J.location,ie);break;case 3:n.vertexAttrib3fv(J.location,ie);break;case 4:n.vertexAttrib4fv(J.location,ie);break;default:n.vertexAttrib1fv(J.location,ie)}}}}v()}function I(){H();for(let L in i){let G=i[L];for(let V in G){let N=G[V];for(let W in N){let q=N[W];for(let O in q)u(q[O].object),delete q[O];delete N[W]}}delete i[L]}}function T(L){if(i[L.id]===void 0)return;let G=i[L.id];for(let V in G){let N=G[V];for(let W in N){let q=N[W];for(let O in q)u(q[O].object),delete q[O];delete N[W]}}delete i[L.id]}function x(L){for(let G in i){let V=i[G];for(let N in V){let W=V[N];if(W[L.id]===void 0)continue;let q=W[L.id];for(let O in q)u(q[O].object),delete q[O];delete W[L.id]}}}function E(L){for(let G in i){let V=i[G],N=L.isInstancedMesh===!0?L.id:0,W=V[N];if(W!==void 0){for(let q in W){let O=W[q];for(let re in O)u(O[re].object),delete O[re];delete W[q]}delete V[N],Object.keys(V).length===0&&delete i[G]}}}function H(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:H,resetDefaultState:U,dispose:I,releaseStatesOfGeometry:T,releaseStatesOfObject:E,releaseStatesOfProgram:x,initAttributes:b,enableAttribute:m,disableUnusedAttributes:v}}function WT(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function XT(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ui&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let E=x===os&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==yi&&x!==rs&&!E&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),S=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=n.getParameter(n.MAX_SAMPLES),T=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:b,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:C,maxFragmentUniforms:S,maxSamples:I,samples:T}}function $T(n){let e=this,t=null,i=0,s=!1,r=!1,o=new ci,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,b=f.clipIntersection,m=f.clipShadows,g=n.get(f);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let v=r?0:i,C=v*4,S=g.clippingState||null;l.value=S,S=u(p,h,C,d);for(let I=0;I!==C;++I)S[I]=t[I];g.clippingState=S,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let b=f!==null?f.length:0,m=null;if(b!==0){if(m=l.value,p!==!0||m===null){let g=d+b*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let C=0,S=d;C!==b;++C,S+=4)o.copy(f[C]).applyMatrix4(v,a),o.normal.toArray(m,S),m[S+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var Fl=class extends Di{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new ul(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ca(5,5,5),r=new Gi({name:"CubemapFromEquirect",uniforms:eo(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:di,blending:Zr});r.uniforms.tEquirect.value=t;let o=new Hn(s,r),a=t.minFilter;return t.minFilter===Ys&&(t.minFilter=hi),new ua(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},sy=256,qT=3,YT=20,Ey=256,Cy=16,JT=3,ZT=new z,KT=new dt,Oh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new ua(1,10,null),this._boxMesh=new Hn(new ca(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=ZT}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(KT));let m=new ua(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ay(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=oy(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(sy,Up(e))}_fromTexture(e,t){e.mapping===jr||e.mapping===pa?this._setSize(e.image.length===0?sy:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=ry(e,!1,!1),i=Math.log2(e)-qT;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ry(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===jr||e.mapping===pa?(this._cubemapMaterial===null&&(this._cubemapMaterial=ay()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=oy()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=jT(),this._integrationMaterial=QT());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Cy);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-JT)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Ey*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=eE());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function ry(n,e,t){return new Fl(n,{minFilter:Ys,generateMipmaps:e,type:os,colorSpace:el,depthBuffer:t})}function Bl(n,e,t){return new Gi({name:n,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:di,blending:Zr,depthTest:!1,depthWrite:!1})}function jT(){return Bl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Ey}u

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
	`)}function QT(){return Bl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Cy}},`

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
	`)}function eE(){return Bl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${YT}
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
	`)}function oy(){return Bl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function ay(){return Bl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function tE(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===qu||d===Yu)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let b=new Fl(p.height);return b.fromEquirectangularTexture(n,h),e.set(h,b),h.addEventListener("dispose",c),a(b.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===qu||d===Yu,b=d===jr||d===pa;if(p||b){let m=t.get(h),g=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==g)return i===null&&(i=new Oh(n)),m=p?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;{let v=h.image;return p&&v&&v.height>0||b&&v&&l(v)?(i===null&&(i=new Oh(n)),m=p?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,d){return d===qu?h.mapping=jr:d===Yu&&(h.mapping=pa),h}function l(h){let d=0,p=6;for(let b=0;b<p;b++)h[b]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function nE(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&Za("WebGLRenderer: "+i+" extension not supported."),s}}}function iE(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let b=r.get(p);b&&(e.remove(b),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function u(p){let b=p.attributes;for(let m in b)e.update(b[m],n.ARRAY_BUFFER)}function f(p){let b=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let v=b!==null?b.array.length:m.array.length/3-1,C=m.count>=65535?ll:al,S=new C(Math.ceil(v/3)*6,1),I=S.array;if(b!==null){let x=b.array;g=b.version;for(let E=0,H=0;E<v;E+=3){let U=x[E+0],L=x[E+1],G=x[E+2];I[H++]=U,I[H++]=L,I[H++]=L,I[H++]=G,I[H++]=G,I[H++]=U}}else{g=m.version;for(let x=0,E=0;x<v;x+=3){let H=x+0,U=x+1,L=x+2;I[E++]=H,I[E++]=U,I[E++]=U,I[E++]=L,I[E++]=L,I[E++]=H}}S.version=g;let T=r.get(p);T&&e.remove(T),r.set(p,S)}function h(p){let b=r.get(p);if(b){let m=p.index;m!==null&&b.version<m.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let b=s[p].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function sE(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let b=0;for(let m=0;m<d;m++)b+=h[m];t.update(b,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function rE(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function oE(n,e,t){let i=new WeakMap,s=new Lt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let H=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",H)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],C=0;d===!0&&(C=1),p===!0&&(C=2),b===!0&&(C=3);let S=a.attributes.position.count*C,I=1;S>e.maxTextureSize&&(I=Math.ceil(S/e.maxTextureSize),S=e.maxTextureSize);let T=new Float32Array(S*I*4*f),x=new sl(T,S,I,f);x.type=rs,x.needsUpdate=!0;let E=C*4;for(let U=0;U<f;U++){let L=m[U],G=g[U],V=v[U],N=S*I*4*U;for(let W=0;W<L.count;W++){let q=W*E;d===!0&&(s.fromBufferAttribute(L,W),T[N+q+0]=s.x,T[N+q+1]=s.y,T[N+q+2]=s.z,T[N+q+3]=0),p===!0&&(s.fromBufferAttribute(G,W),T[N+q+4]=s.x,T[N+q+5]=s.y,T[N+q+6]=s.z,T[N+q+7]=0),b===!0&&(s.fromBufferAttribute(V,W),T[N+q+8]=s.x,T[N+q+9]=s.y,T[N+q+10]=s.z,T[N+q+11]=V.itemSize===4?s.w:1)}}h={count:f,texture:x,size:new Ke(S,I)},i.set(a,h),a.addEventListener("dispose",H)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function aE(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var lE={[pp]:"LINEAR_TONE_MAPPING",[mp]:"REINHARD_TONE_MAPPING",[gp]:"CINEON_TONE_MAPPING",[_p]:"ACES_FILMIC_TONE_MAPPING",[yp]:"AGX_TONE_MAPPING",[vp]:"NEUTRAL_TONE_MAPPING",[xp]:"CUSTOM_TONE_MAPPING"};function cE(n,e,t,i,s,r){let o=new Di(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Sn;u.setAttribute("position",new kn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new kn([0,2,0,0,2,0],2));let f=new Iu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Hn(u,f),d=new vl(-1,1,1,-1,0,1),p=null,b=null,m=!1,g,v=null,C=[],S=!1;this.setSize=function(I,T){o.setSize(I,T),a!==null&&a.setSize(I,T),l!==null&&l.setSize(I,T);for(let x=0;x<C.length;x++){let E=C[x];E.setSize&&E.setSize(I,T)}},this.setEffects=function(I){C=I,S=C.length>0&&C[0].isRenderPass===!0;let T=o.width,x=o.height;C.length>0&&a===null&&(a=new Di(T,x,{type:os,depthBuffer:!1,stencilBuffer:!1}),l=new Di(T,x,{type:os,depthBuffer:!1,stencilBuffer:!1}));let E=s===!0&&C.some(H=>H.needsDepthTexture===!0);E!==(o.depthTexture!==null)&&(E===!0&&c===null&&(c=new qs(T,x),r===!0&&(c.format=Js,c.type=Qr)),o.dispose(),o.depthTexture=E?c:null,o.resolveDepthBuffer=E,o.storeMultisampledDepthBuffer=E);for(let H=0;H<C.length;H++){let U=C[H];U.setSize&&U.setSize(T,x),E&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(I,T){if(m||I.toneMapping===ys&&C.length===0)return!1;if(v=T,T!==null){let x=T.width,E=T.height;(o.width!==x||o.height!==E)&&this.setSize(x,E)}return S===!1&&I.setRenderTarget(o),g=I.toneMapping,I.toneMapping=ys,!0},this.hasRenderPass=function(){return S},this.end=function(I,T){I.toneMapping=g,m=!0;let x=o,E=a;for(let H=0;H<C.length;H++){let U=C[H];U.enabled!==!1&&(U.render(I,E,x,T),U.needsSwap!==!1&&(x=E,E=E===a?l:a))}if(p!==I.outputColorSpace||b!==I.toneMapping){p=I.outputColorSpace,b=I.toneMapping,f.defines={},vt.getTransfer(p)===It&&(f.defines.SRGB_TRANSFER="");let H=lE[b];H&&(f.defines[H]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,I.setRenderTarget(v),I.render(h,d),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Ry=new _i,Py=new qs(1,1),Iy=new hl(1),Ly=new sl,Dy=new Au,Ny=new ul,ly=[],cy=[],uy=new Float32Array(16),hy=new Float32Array(9),dy=new Float32Array(4);function _a(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=ly[s];if(r===void 0&&(r=new Float32Array(s),ly[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Cn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Rn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Bh(n,e){let t=cy[e];t===void 0&&(t=new Int32Array(e),cy[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function uE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function hE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2fv(this.addr,e),Rn(t,e)}}function dE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;n.uniform3fv(this.addr,e),Rn(t,e)}}function fE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4fv(this.addr,e),Rn(t,e)}}function pE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;dy.set(i),n.uniformMatrix2fv(this.addr,!1,dy),Rn(t,i)}}function mE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;hy.set(i),n.uniformMatrix3fv(this.addr,!1,hy),Rn(t,i)}}function gE(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;uy.set(i),n.uniformMatrix4fv(this.addr,!1,uy),Rn(t,i)}}function _E(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function xE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2iv(this.addr,e),Rn(t,e)}}function yE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3iv(this.addr,e),Rn(t,e)}}function vE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4iv(this.addr,e),Rn(t,e)}}function bE(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function SE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2uiv(this.addr,e),Rn(t,e)}}function ME(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3uiv(this.addr,e),Rn(t,e)}}function wE(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4uiv(this.addr,e),Rn(t,e)}}function kh(n){return n.version===0&&(n.compareFunction=Ip,n.needsUpdate=!0),n}function AE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=kh(Py):r=Ry,t.setTexture2D(e||r,s)}function TE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Dy,s)}function EE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=kh(Iy):r=Ny,t.setTextureCube(e||r,s)}function CE(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Ly,s)}function RE(n){switch(n){case 5126:return uE;case 35664:return hE;case 35665:return dE;case 35666:return fE;case 35674:return pE;case 35675:return mE;case 35676:return gE;case 5124:case 35670:return _E;case 35667:case 35671:return xE;case 35668:case 35672:return yE;case 35669:case 35673:return vE;case 5125:return bE;case 36294:return SE;case 36295:return ME;case 36296:return wE;case 35678:case 36198:case 36298:case 36306:case 35682:return AE;case 35679:case 36299:case 36307:return TE;case 35680:case 36300:case 36308:case 36293:return EE;case 36289:case 36303:case 36311:case 36292:return CE}}function PE(n,e){n.uniform1fv(this.addr,e)}function IE(n,e){let t=_a(e,this.size,2);n.uniform2fv(this.addr,t)}function LE(n,e){let t=_a(e,this.size,3);n.uniform3fv(this.addr,t)}function DE(n,e){let t=_a(e,this.size,4);n.uniform4fv(this.addr,t)}function NE(n,e){let t=_a(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function UE(n,e){let t=_a(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function OE(n,e){let t=_a(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function FE(n,e){n.uniform1iv(this.addr,e)}function BE(n,e){n.uniform2iv(this.addr,e)}function kE(n,e){n.uniform3iv(this.addr,e)}function zE(n,e){n.uniform4iv(this.addr,e)}function VE(n,e){n.uniform1uiv(this.addr,e)}function HE(n,e){n.uniform2uiv(this.addr,e)}function GE(n,e){n.uniform3uiv(this.addr,e)}function WE(n,e){n.uniform4uiv(this.addr,e)}function XE(n,e,t){let i=this.cache,s=e.length,r=Bh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=kh(Py):o=Ry;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function $E(n,e,t){let i=this.cache,s=e.length,r=Bh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Dy,r[o])}function qE(n,e,t){let i=this.cache,s=e.length,r=Bh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=kh(Iy):o=Ny;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function YE(n,e,t){let i=this.cache,s=e.length,r=Bh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Ly,r[o])}function JE(n){switch(n){case 5126:return PE;case 35664:return IE;case 35665:return LE;case 35666:return DE;case 35674:return NE;case 35675:return UE;case 35676:return OE;case 5124:case 35670:return FE;case 35667:case 35671:return BE;case 35668:case 35672:return kE;case 35669:case 35673:return zE;case 5125:return VE;case 36294:return HE;case 36295:return GE;case 36296:return WE;case 35678:case 36198:case 36298:case 36306:case 35682:return XE;case 35679:case 36299:case 36307:return $E;case 35680:case 36300:case 36308:case 36293:return qE;case 36289:case 36303:case 36311:case 36292:return YE}}var Wp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=RE(t.type)}},Xp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=JE(t.type)}},$p=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},Hp=/(\w+)(\])?(\[|\.)?/g;function fy(n,e){n.seq.push(e),n.map[e.id]=e}function ZE(n,e,t){let i=n.name,s=i.length;for(Hp.lastIndex=0;;){let r=Hp.exec(i),o=Hp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){fy(t,c===void 0?new Wp(a,n,e):new Xp(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new $p(a),fy(t,f)),t=f}}}var ga=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);ZE(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function py(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var KE=37297,jE=0;function QE(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var my=new st;function eC(n){vt._getMatrix(my,vt.workingColorSpace,n);let e=`mat3( ${my.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case tl:return[e,"LinearTransferOETF"];case It:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function gy(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+QE(n.getShaderSource(e),a)}else return r}function tC(n,e){let t=eC(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var nC={[pp]:"Linear",[mp]:"Reinhard",[gp]:"Cineon",[_p]:"ACESFilmic",[yp]:"AgX",[vp]:"Neutral",[xp]:"Custom"};function iC(n,e){let t=nC[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Uh=new z;function sC(){vt.getLuminanceCoefficients(Uh);let n=Uh.x.toFixed(4),e=Uh.y.toFixed(4),t=Uh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function rC(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Ol).join(`
`)}function oC(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function aC(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Ol(n){return n!==""}function _y(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function xy(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var lC=/^[ \t]*#include +<([\w\d./]+)>/gm;function qp(n){return n.replace(lC,cC)}function cC(n,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return qp(t)}var uC=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function yy(n){return n.replace(uC,hC)}function hC(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function vy(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var dC={[Al]:"SHADOWMAP_TYPE_PCF",[da]:"SHADOWMAP_TYPE_VSM"};function fC(n){return dC[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var pC={[pa]:"ENVMAP_MODE_REFRACTION"};function mC(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":pC[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var gC={[$u]:"ENVMAP_BLENDING_MULTIPLY",[zx]:"ENVMAP_BLENDING_MIX",[Vx]:"ENVMAP_BLENDING_ADD"};function _C(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":gC[n.combine]||"ENVMAP_BLENDING_NONE"}function xC(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=fC(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=mC(t),f=_C(t),h=rC(t),d=oC(r),p=s.createProgram(),b,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ol).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Ol).join(`
`),m.length>0&&(m+=`
`)):(b=[vy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Ol).join(`
`),m=[vy(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==ys?"#define TONE_MAPPING":"",t.toneMapping!==ys?pt.tonemapping_pars_fragment:"",t.toneMapping!==ys?iC("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,tC("linearToOutputTexel",t.outputColorSpace),sC(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Ol).join(`
`)),o=qp(o),o=_y(o,t),o=xy(o,t),a=qp(a),a=_y(a,t),a=xy(a,t),o=yy(o),a=yy(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,b=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===Dp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===Dp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+b+o,C=g+m+a,S=py(s,s.VERTEX_SHADER,v),I=py(s,s.FRAGMENT_SHADER,C);s.attachShader(p,S),s.attachShader(p,I),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function T(U){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",G=s.getShaderInfoLog(S)||"",V=s.getShaderInfoLog(I)||"",N=L.trim(),W=G.trim(),q=V.trim(),O=!0,re=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(O=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,S,I);else{let J=gy(s,S,"vertex"),ee=gy(s,I,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+N+`
`+J+`
`+ee)}else N!==""?Je("WebGLProgram: Program Info Log:",N):(W===""||q==="")&&(re=!1);re&&(U.diagnostics={runnable:O,programLog:N,vertexShader:{log:W,prefix:b},fragmentShader:{log:q,prefix:m}})}s.deleteShader(S),s.deleteShader(I),x=new ga(s,p),E=aC(s,p)}let x;this.getUniforms=function(){return x===void 0&&T(this),x};let E;this.getAttributes=function(){return E===void 0&&T(this),E};let H=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return H===!1&&(H=s.getProgramParameter(p,KE)),H},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=jE++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=S,this.fragmentShader=I,this}var yC=0,Yp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Jp(e),t.set(e,i)),i}},Jp=class{constructor(e){this.id=yC++,this.code=e,this.usedTimes=0}};function vC(n){return n===Pr||n===Il||n===Ll}function bC(n,e,t,i,s,r){let o=new rl,a=new Yp,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,E,H,U,L,G){let V=U.fog,N=L.geometry,W=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?U.environment:null,q=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,O=e.get(x.envMap||W,q),re=h[x.type],J=i.precision;x.precision!==null&&(J=i.getMaxPrecision(x.precision),J!==x.precision&&Je("WebGLProgram.getParameters:",x.precision,"not supported, using",J,"instead."));let ee=N.morphAttributes.position||N.morphAttributes.normal||N.morphAttributes.color,ie=ee!==void 0?ee.length:0,de=0;N.morphAttributes.position!==void 0&&(de=1),N.morphAttributes.normal!==void 0&&(de=2),N.morphAttributes.color!==void 0&&(de=3);let he,Q,me,ge;if(re){let Ce=fi[re];he=Ce.vertexShader,Q=Ce.fragmentShader}else{he=x.vertexShader,Q=x.fragmentShader;let Ce=a.getVertexShaderStage(x),ht=a.getFragmentShaderStage(x);a.update(x,Ce,ht),me=Ce.id,ge=ht.id}let Ee=n.getRenderTarget(),ye=n.state.buffers.depth.getReversed(),We=L.isInstancedMesh===!0,Ne=L.isBatchedMesh===!0,Le=!!x.map,at=!!x.matcap,ut=!!O,rt=ut&&O.isPMREMTexture===!0,Qt=!!x.aoMap,$t=!!x.lightMap,dn=!!x.bumpMap&&x.wireframe===!1,Bt=!!x.normalMap,In=!!x.displacementMap,bt=!!x.emissiveMap,Mn=!!x.metalnessMap,nn=!!x.roughnessMap,fn=x.anisotropy>0,B=x.clearcoat>0,Re=x.diffuseRoughness>0,Ze=x.dispersion>0,lt=x.retroreflectivity>0,Me=x.iridescence>0,zt=x.sheen>0,Ge=x.transmission>0,Ye=fn&&!!x.anisotropyMap,R=B&&!!x.clearcoatMap,M=B&&!!x.clearcoatNormalMap,$=B&&!!x.clearcoatRoughnessMap,ue=Re&&!!x.diffuseRoughnessMap,ae=Me&&!!x.iridescenceMap,xe=Me&&!!x.iridescenceThicknessMap,ve=zt&&!!x.sheenColorMap,te=zt&&!!x.sheenRoughnessMap,se=!!x.specularMap,pe=!!x.specularColorMap,F=!!x.specularIntensityMap,oe=Ge&&!!x.transmissionMap,ne=Ge&&!!x.thicknessMap,we=!!x.gradientMap,_e=!!x.alphaMap,Se=x.alphaTest>0,Xe=!!x.alphaHash,et=!!x.extensions,ce=ys;x.toneMapped&&(Ee===null||Ee.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ze=rt?O.isCompressedCubeTexture?O.image[0].mipmaps:O.mipmaps:null,tt={shaderID:re,shaderType:x.type,shaderName:x.name,vertexShader:he,fragmentShader:Q,defines:x.defines,customVertexShaderID:me,customFragmentShaderID:ge,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:J,batching:Ne,batchingColor:Ne&&L._colorsTexture!==null,instancing:We,instancingColor:We&&L.instanceColor!==null,instancingMorph:We&&L.morphTexture!==null,outputColorSpace:Ee===null?n.outputColorSpace:Ee.isXRRenderTarget===!0?Ee.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Le,matcap:at,envMap:ut,envMapMode:ut&&O.mapping,envMapPMREM:rt,envMapMaxLod:rt?ze.length-1:null,envMapSize:rt?ze[0].width:null,aoMap:Qt,lightMap:$t,bumpMap:dn,normalMap:Bt,displacementMap:In,emissiveMap:bt,normalMapObjectSpace:Bt&&x.normalMapType===Wx,normalMapTangentSpace:Bt&&x.normalMapType===Lh,packedNormalMap:Bt&&x.normalMapType===Lh&&vC(x.normalMap.format),metalnessMap:Mn,roughnessMap:nn,anisotropy:fn,anisotropyMap:Ye,clearcoat:B,clearcoatMap:R,clearcoatNormalMap:M,clearcoatRoughnessMap:$,diffuseRoughness:Re,diffuseRoughnessMap:ue,dispersion:Ze,retroreflection:lt,iridescence:Me,iridescenceMap:ae,iridescenceThicknessMap:xe,sheen:zt,sheenColorMap:ve,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:F,transmission:Ge,transmissionMap:oe,thicknessMap:ne,gradientMap:we,opaque:x.transparent===!1&&x.blending===fa&&x.alphaToCoverage===!1,alphaMap:_e,alphaTest:Se,alphaHash:Xe,combine:x.combine,mapUv:Le&&d(x.map.channel),aoMapUv:Qt&&d(x.aoMap.channel),lightMapUv:$t&&d(x.lightMap.channel),bumpMapUv:dn&&d(x.bumpMap.channel),normalMapUv:Bt&&d(x.normalMap.channel),displacementMapUv:In&&d(x.displacementMap.channel),emissiveMapUv:bt&&d(x.emissiveMap.channel),metalnessMapUv:Mn&&d(x.metalnessMap.channel),roughnessMapUv:nn&&d(x.roughnessMap.channel),anisotropyMapUv:Ye&&d(x.anisotropyMap.channel),clearcoatMapUv:R&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:M&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:$&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:xe&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:ve&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(x.sheenRoughnessMap.channel),specularMapUv:se&&d(x.specularMap.channel),specularColorMapUv:pe&&d(x.specularColorMap.channel),specularIntensityMapUv:F&&d(x.specularIntensityMap.channel),transmissionMapUv:oe&&d(x.transmissionMap.channel),thicknessMapUv:ne&&d(x.thicknessMap.channel),alphaMapUv:_e&&d(x.alphaMap.channel),vertexTangents:!!N.attributes.tangent&&(Bt||fn),vertexNormals:!!N.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!N.attributes.color&&N.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!N.attributes.uv&&(Le||_e),fog:!!V,useFog:x.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||N.attributes.normal===void 0&&Bt===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ye,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:N.attributes.position!==void 0,morphTargets:N.morphAttributes.position!==void 0,morphNormals:N.morphAttributes.normal!==void 0,morphColors:N.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:E.sun.length,numDirLights:E.directional.length,numPointLights:E.point.length,numSpotLights:E.spot.length,numSpotLightMaps:E.spotLightMap.length,numRectAreaLights:E.rectArea.length,numHemiLights:E.hemi.length,numSunLightShadows:E.sunShadowMap.length,numDirLightShadows:E.directionalShadowMap.length,numPointLightShadows:E.pointShadowMap.length,numSpotLightShadows:E.spotShadowMap.length,numSpotLightShadowsWithMaps:E.numSpotLightShadowsWithMaps,numLightProbes:E.numLightProbes,numLightProbeGrids:G.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&H.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:Le&&x.map.isVideoTexture===!0&&vt.getTransfer(x.map.colorSpace)===It,decodeVideoTextureEmissive:bt&&x.emissiveMap.isVideoTexture===!0&&vt.getTransfer(x.emissiveMap.colorSpace)===It,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===xi,flipSided:x.side===di,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||Ne)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function b(x){let E=[];if(x.shaderID?E.push(x.shaderID):(E.push(x.customVertexShaderID),E.push(x.customFragmentShaderID)),x.defines!==void 0)for(let H in x.defines)E.push(H),E.push(x.defines[H]);return x.isRawShaderMaterial===!1&&(m(E,x),g(E,x),E.push(n.outputColorSpace)),E.push(x.customProgramCacheKey),E.join()}function m(x,E){x.push(E.precision),x.push(E.outputColorSpace),x.push(E.envMapMode),x.push(E.envMapPMREM),x.push(E.envMapMaxLod),x.push(E.envMapSize),x.push(E.mapUv),x.push(E.alphaMapUv),x.push(E.lightMapUv),x.push(E.aoMapUv),x.push(E.bumpMapUv),x.push(E.normalMapUv),x.push(E.displacementMapUv),x.push(E.emissiveMapUv),x.push(E.metalnessMapUv),x.push(E.roughnessMapUv),x.push(E.anisotropyMapUv),x.push(E.clearcoatMapUv),x.push(E.clearcoatNormalMapUv),x.push(E.clearcoatRoughnessMapUv),x.push(E.diffuseRoughnessMapUv),x.push(E.iridescenceMapUv),x.push(E.iridescenceThicknessMapUv),x.push(E.sheenColorMapUv),x.push(E.sheenRoughnessMapUv),x.push(E.specularMapUv),x.push(E.specularColorMapUv),x.push(E.specularIntensityMapUv),x.push(E.transmissionMapUv),x.push(E.thicknessMapUv),x.push(E.combine),x.push(E.fogExp2),x.push(E.sizeAttenuation),x.push(E.morphTargetsCount),x.push(E.numSunLights),x.push(E.numDirLights),x.push(E.numPointLights),x.push(E.numSpotLights),x.push(E.numSpotLightMaps),x.push(E.numHemiLights),x.push(E.numRectAreaLights),x.push(E.numSunLightShadows),x.push(E.numDirLightShadows),x.push(E.numPointLightShadows),x.push(E.numSpotLightShadows),x.push(E.numSpotLightShadowsWithMaps),x.push(E.numLightProbes),x.push(E.numLightProbeGrids),x.push(E.shadowMapType),x.push(E.toneMapping),x.push(E.numClippingPlanes),x.push(E.numClipIntersection),x.push(E.depthPacking)}function g(x,E){o.disableAll(),E.instancing&&o.enable(0),E.instancingColor&&o.enable(1),E.instancingMorph&&o.enable(2),E.matcap&&o.enable(3),E.envMap&&o.enable(4),E.normalMapObjectSpace&&o.enable(5),E.normalMapTangentSpace&&o.enable(6),E.clearcoat&&o.enable(7),E.iridescence&&o.enable(8),E.alphaTest&&o.enable(9),E.vertexColors&&o.enable(10),E.vertexAlphas&&o.enable(11),E.vertexUv1s&&o.enable(12),E.vertexUv2s&&o.enable(13),E.vertexUv3s&&o.enable(14),E.vertexTangents&&o.enable(15),E.anisotropy&&o.enable(16),E.alphaHash&&o.enable(17),E.batching&&o.enable(18),E.dispersion&&o.enable(19),E.retroreflection&&o.enable(24),E.diffuseRoughness&&o.enable(25),E.batchingColor&&o.enable(20),E.gradientMap&&o.enable(21),E.packedNormalMap&&o.enable(22),E.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),E.fog&&o.enable(0),E.useFog&&o.enable(1),E.flatShading&&o.enable(2),E.logarithmicDepthBuffer&&o.enable(3),E.reversedDepthBuffer&&o.enable(4),E.skinning&&o.enable(5),E.morphTargets&&o.enable(6),E.morphNormals&&o.enable(7),E.morphColors&&o.enable(8),E.premultipliedAlpha&&o.enable(9),E.shadowMapEnabled&&o.enable(10),E.doubleSided&&o.enable(11),E.flipSided&&o.enable(12),E.useDepthPacking&&o.enable(13),E.dithering&&o.enable(14),E.transmission&&o.enable(15),E.sheen&&o.enable(16),E.opaque&&o.enable(17),E.pointsUvs&&o.enable(18),E.decodeVideoTexture&&o.enable(19),E.decodeVideoTextureEmissive&&o.enable(20),E.alphaToCoverage&&o.enable(21),E.numLightProbeGrids>0&&o.enable(22),E.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let E=h[x.type],H;if(E){let U=fi[E];H=Nl.clone(U.uniforms)}else H=x.uniforms;return H}function C(x,E){let H=u.get(E);return H!==void 0?++H.usedTimes:(H=new xC(n,E,x,s),c.push(H),u.set(E,H)),H}function S(x){if(--x.usedTimes===0){let E=c.indexOf(x);c[E]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function I(x){a.remove(x)}function T(){a.dispose()}return{getParameters:p,getProgramCacheKey:b,getUniforms:v,acquireProgram:C,releaseProgram:S,releaseShaderCache:I,programs:c,dispose:T}}function SC(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function MC(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function by(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Sy(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,b,m,g){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:b,renderOrder:h.renderOrder,z:m,group:g},n[e]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=p,v.materialVariant=o(h),v.groupOrder=b,v.renderOrder=h.renderOrder,v.z=m,v.group=g),e++,v}function l(h,d,p,b,m,g,v){v.reversedDepth===!0&&(m=-m);let C=a(h,d,p,b,m,g);p.transmission>0?i.push(C):p.transparent===!0?s.push(C):t.push(C)}function c(h,d,p,b,m,g){let v=a(h,d,p,b,m,g);p.transmission>0?i.unshift(v):p.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||MC),i.length>1&&i.sort(d||by),s.length>1&&s.sort(d||by)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function wC(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Sy,n.set(i,[o])):s>=r.length?(o=new Sy,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function AC(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new z,color:new dt};break;case"SpotLight":t={position:new z,direction:new z,color:new dt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new z,color:new dt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new z,skyColor:new dt,groundColor:new dt};break;case"RectAreaLight":t={color:new dt,position:new z,halfWidth:new z,halfHeight:new z};break}return n[e.id]=t,t}}}function TC(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var EC=0;function CC(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function RC(n){let e=new AC,t=TC(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);let s=new z,r=new St,o=new St;function a(c){let u=0,f=0,h=0;for(let G=0;G<9;G++)i.probe[G].set(0,0,0);let d=0,p=0,b=0,m=0,g=0,v=0,C=0,S=0,I=0,T=0,x=0,E=0,H=0,U=0;c.sort(CC);for(let G=0,V=c.length;G<V;G++){let N=c[G],W=N.color,q=N.intensity,O=N.distance,re=null;if(N.shadow&&N.shadow.map&&(N.shadow.map.texture.format===Pr?re=N.shadow.map.texture:re=N.shadow.map.depthTexture||N.shadow.map.texture),N.isAmbientLight)u+=W.r*q,f+=W.g*q,h+=W.b*q;else if(N.isLightProbe){for(let J=0;J<9;J++)i.probe[J].addScaledVector(N.sh.coefficients[J],q);U++}else if(N.isSunLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let ee=N.shadow,ie=t.get(N);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=re;let de=ee.getViewportCount();for(let he=0;he<de;he++)i.sunShadowMatrix[b+he]=ee.getMatrix(he),i.sunShadowCascade[b+he]=ee._cascadeData[he];b+=de,p++}i.sun[d]=J,d++}else if(N.isDirectionalLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),N.castShadow){let ee=N.shadow,ie=t.get(N);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize=ee.mapSize,i.directionalShadow[m]=ie,i.directionalShadowMap[m]=re,i.directionalShadowMatrix[m]=N.shadow.matrix,I++}i.directional[m]=J,m++}else if(N.isSpotLight){let J=e.get(N);J.position.setFromMatrixPosition(N.matrixWorld),J.color.copy(W).multiplyScalar(q),J.distance=O,J.coneCos=Math.cos(N.angle),J.penumbraCos=Math.cos(N.angle*(1-N.penumbra)),J.decay=N.decay,i.spot[v]=J;let ee=N.shadow;if(N.map&&(i.spotLightMap[E]=N.map,E++,ee.updateMatrices(N),N.castShadow&&H++),i.spotLightMatrix[v]=ee.matrix,N.castShadow){let ie=t.get(N);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize=ee.mapSize,i.spotShadow[v]=ie,i.spotShadowMap[v]=re,x++}v++}else if(N.isRectAreaLight){let J=e.get(N);J.color.copy(W).multiplyScalar(q),J.halfWidth.set(N.width*.5,0,0),J.halfHeight.set(0,N.height*.5,0),i.rectArea[C]=J,C++}else if(N.isPointLight){let J=e.get(N);if(J.color.copy(N.color).multiplyScalar(N.intensity),J.distance=N.distance,J.decay=N.decay,N.castShadow){let ee=N.shadow,ie=t.get(N);ie.shadowIntensity=ee.intensity,ie.shadowBias=ee.bias,ie.shadowNormalBias=ee.normalBias,ie.shadowRadius=ee.radius,ie.shadowMapSize=ee.mapSize,ie.shadowCameraNear=ee.camera.near,ie.shadowCameraFar=ee.camera.far,i.pointShadow[g]=ie,i.pointShadowMap[g]=re,i.pointShadowMatrix[g]=N.shadow.matrix,T++}i.point[g]=J,g++}else if(N.isHemisphereLight){let J=e.get(N);J.skyColor.copy(N.color).multiplyScalar(q),J.groundColor.copy(N.groundColor).multiplyScalar(q),i.hemi[S]=J,S++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Pe.LTC_FLOAT_1,i.rectAreaLTC2=Pe.LTC_FLOAT_2):(i.rectAreaLTC1=Pe.LTC_HALF_1,i.rectAreaLTC2=Pe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let L=i.hash;(L.sunLength!==d||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==v||L.rectAreaLength!==C||L.hemiLength!==S||L.numSunShadows!==p||L.numDirectionalShadows!==I||L.numPointShadows!==T||L.numSpotShadows!==x||L.numSpotMaps!==E||L.numLightProbes!==U)&&(i.sun.length=d,i.directional.length=m,i.spot.length=v,i.rectArea.length=C,i.point.length=g,i.hemi.length=S,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=I,i.directionalShadowMap.length=I,i.directionalShadowMatrix.length=I,i.pointShadow.length=T,i.pointShadowMap.length=T,i.pointShadowMatrix.length=T,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+E-H,i.spotLightMap.length=E,i.numSpotLightShadowsWithMaps=H,i.numLightProbes=U,L.sunLength=d,L.directionalLength=m,L.pointLength=g,L.spotLength=v,L.rectAreaLength=C,L.hemiLength=S,L.numSunShadows=p,L.numDirectionalShadows=I,L.numPointShadows=T,L.numSpotShadows=x,L.numSpotMaps=E,L.numLightProbes=U,i.version=EC++)}function l(c,u){let f=0,h=0,d=0,p=0,b=0,m=0,g=u.matrixWorldInverse;for(let v=0,C=c.length;v<C;v++){let S=c[v];if(S.isSunLight){let I=i.sun[f];I.direction.setFromMatrixPosition(S.matrixWorld),I.direction.transformDirection(g),f++}else if(S.isDirectionalLight){let I=i.directional[h];I.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(g),h++}else if(S.isSpotLight){let I=i.spot[p];I.position.setFromMatrixPosition(S.matrixWorld),I.position.applyMatrix4(g),I.direction.setFromMatrixPosition(S.matrixWorld),s.setFromMatrixPosition(S.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(g),p++}else if(S.isRectAreaLight){let I=i.rectArea[b];I.position.setFromMatrixPosition(S.matrixWorld),I.position.applyMatrix4(g),o.identity(),r.copy(S.matrixWorld),r.premultiply(g),o.extractRotation(r),I.halfWidth.set(S.width*.5,0,0),I.halfHeight.set(0,S.height*.5,0),I.halfWidth.applyMatrix4(o),I.halfHeight.applyMatrix4(o),b++}else if(S.isPointLight){let I=i.point[d];I.position.setFromMatrixPosition(S.matrixWorld),I.position.applyMatrix4(g),d++}else if(S.isHemisphereLight){let I=i.hemi[m];I.direction.setFromMatrixPosition(S.matrixWorld),I.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function My(n){let e=new RC(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function PC(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new My(n),e.set(s,[a])):r>=o.length?(a=new My(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var IC=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,LC=`uniform sampler2D shadow_pass;
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
}`,DC=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],NC=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],wy=new St,Ul=new z,Gp=new z;function UC(n,e,t){let i=new br,s=new Ke,r=new Ke,o=new Lt,a=new Lu,l=new Du,c={},u=t.maxTextureSize,f={[Rr]:di,[di]:Rr,[xi]:xi},h=new Gi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:IC,fragmentShader:LC}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new Sn;p.setAttribute("position",new bn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Hn(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Al;let g=this.type;this.render=function(T,x,E){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||T.length===0)return;this.type===bx&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Al);let H=n.getRenderTarget(),U=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),G=n.state;G.setBlending(Zr),G.buffers.depth.getReversed()===!0?G.buffers.color.setClear(0,0,0,0):G.buffers.color.setClear(1,1,1,1),G.buffers.depth.setTest(!0),G.setScissorTest(!1);let V=g!==this.type;V&&x.traverse(function(N){N.material&&(Array.isArray(N.material)?N.material.forEach(W=>W.needsUpdate=!0):N.material.needsUpdate=!0)});for(let N=0,W=T.length;N<W;N++){let q=T[N],O=q.shadow;if(O===void 0){Je("WebGLShadowMap:",q,"has no shadow.");continue}if(O.autoUpdate===!1&&O.needsUpdate===!1)continue;s.copy(O.mapSize);let re=O.getFrameExtents();s.multiply(re),r.copy(O.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/re.x),s.x=r.x*re.x,O.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/re.y),s.y=r.y*re.y,O.mapSize.y=r.y));let J=n.state.buffers.depth.getReversed();if(O.camera._reversedDepth=J,O.map===null||V===!0){if(O.map!==null&&(O.map.depthTexture!==null&&(O.map.depthTexture.dispose(),O.map.depthTexture=null),O.map.dispose()),this.type===da){if(q.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}O.map=new Di(s.x,s.y,{format:Pr,type:os,minFilter:hi,magFilter:hi,generateMipmaps:!1}),O.map.texture.name=q.name+".shadowMap",O.map.depthTexture=new qs(s.x,s.y,rs),O.map.depthTexture.name=q.name+".shadowMapDepth",O.map.depthTexture.format=Xs,O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=hn,O.map.depthTexture.magFilter=hn}else q.isPointLight?(O.map=new Fl(s.x),O.map.depthTexture=new hl(s.x,ss)):(O.map=new Di(s.x,s.y),O.map.depthTexture=new qs(s.x,s.y,ss)),O.map.depthTexture.name=q.name+".shadowMap",O.map.depthTexture.format=Xs,this.type===Al?(O.map.depthTexture.compareFunction=J?Pp:Rp,O.map.depthTexture.minFilter=hi,O.map.depthTexture.magFilter=hi):(O.map.depthTexture.compareFunction=null,O.map.depthTexture.minFilter=hn,O.map.depthTexture.magFilter=hn);O.camera.updateProjectionMatrix()}O.map.isWebGLCubeRenderTarget!==!0&&(O.map.width!==s.x||O.map.height!==s.y)&&O.map.setSize(s.x,s.y);let ee=O.map.isWebGLCubeRenderTarget?6:O.getViewportCount();q.isPointLight!==!0&&O.updateMatrices(q,E);let ie=(O.camera.layers.mask&4294967294)!==0?O.camera.layers:E.layers;for(let de=0;de<ee;de++){let he=O.getCamera(de);if(q.isPointLight){let Q=O.camera,me=O.matrix,ge=q.distance||Q.far;ge!==Q.far&&(Q.far=ge,Q.updateProjectionMatrix()),Ul.setFromMatrixPosition(q.matrixWorld),Q.position.copy(Ul),Gp.copy(Q.position),Gp.add(DC[de]),Q.up.copy(NC[de]),Q.lookAt(Gp),Q.updateMatrixWorld(),me.makeTranslation(-Ul.x,-Ul.y,-Ul.z),wy.multiplyMatrices(Q.projectionMatrix,Q.matrixWorldInverse),O._frustum.setFromProjectionMatrix(wy,Q.coordinateSystem,Q.reversedDepth)}if(O.map.isWebGLCubeRenderTarget)n.setRenderTarget(O.map,de),n.clear();else{de===0&&(n.setRenderTarget(O.map),n.clear());let Q=O.getViewport(de);o.set(r.x*Q.x,r.y*Q.y,r.x*Q.z,r.y*Q.w),G.viewport(o)}i=O.getFrustum(de),S(x,E,he,q,ie,this.type)}O.isPointLightShadow!==!0&&this.type===da&&v(O,E),O.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(H,U,L)};function v(T,x){let E=e.update(b);h.defines.VSM_SAMPLES!==T.blurSamples&&(h.defines.VSM_SAMPLES=T.blurSamples,d.defines.VSM_SAMPLES=T.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),T.mapPass===null?T.mapPass=new Di(s.x,s.y,{format:Pr,type:os}):(T.mapPass.width!==T.map.width||T.mapPass.height!==T.map.height)&&T.mapPass.setSize(T.map.width,T.map.height),h.uniforms.shadow_pass.value=T.map.depthTexture,h.uniforms.resolution.value.set(T.map.width,T.map.height),h.uniforms.radius.value=T.radius,n.setRenderTarget(T.mapPass),n.clear(),n.renderBufferDirect(x,null,E,h,b,null),d.uniforms.shadow_pass.value=T.mapPass.texture,d.uniforms.resolution.value.set(T.map.width,T.map.height),d.uniforms.radius.value=T.radius,n.setRenderTarget(T.map),n.clear(),n.renderBufferDirect(x,null,E,d,b,null)}function C(T,x,E,H){let U=null,L=E.isPointLight===!0?T.customDistanceMaterial:T.customDepthMaterial;if(L!==void 0)U=L;else if(U=E.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let G=U.uuid,V=x.uuid,N=c[G];N===void 0&&(N={},c[G]=N);let W=N[V];W===void 0&&(W=U.clone(),N[V]=W,x.addEventListener("dispose",I)),U=W}if(U.visible=x.visible,U.wireframe=x.wireframe,H===da?U.side=x.shadowSide!==null?x.shadowSide:x.side:U.side=x.shadowSide!==null?x.shadowSide:f[x.side],U.alphaMap=x.alphaMap,U.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,U.map=x.map,U.clipShadows=x.clipShadows,U.clippingPlanes=x.clippingPlanes,U.clipIntersection=x.clipIntersection,U.displacementMap=x.displacementMap,U.displacementScale=x.displacementScale,U.displacementBias=x.displacementBias,U.wireframeLinewidth=x.wireframeLinewidth,U.linewidth=x.linewidth,E.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let G=n.properties.get(U);G.light=E}return U}function S(T,x,E,H,U,L){if(T.visible===!1)return;if(T.layers.test(U)&&(T.isMesh||T.isLine||T.isPoints)&&(T.castShadow||T.receiveShadow&&L===da)&&(!T.frustumCulled||T.intersectsFrustum(i))){T.modelViewMatrix.multiplyMatrices(E.matrixWorldInverse,T.matrixWorld);let N=e.update(T),W=T.material;if(Array.isArray(W)){let q=N.groups;for(let O=0,re=q.length;O<re;O++){let J=q[O],ee=W[J.materialIndex];if(ee&&ee.visible){let ie=C(T,ee,H,L);T.onBeforeShadow(n,T,x,E,N,ie,J),n.renderBufferDirect(E,null,N,ie,T,J),T.onAfterShadow(n,T,x,E,N,ie,J)}}}else if(W.visible){let q=C(T,W,H,L);T.onBeforeShadow(n,T,x,E,N,q,null),n.renderBufferDirect(E,null,N,q,T,null),T.onAfterShadow(n,T,x,E,N,q,null)}}let V=T.children;for(let N=0,W=V.length;N<W;N++)S(V[N],x,E,H,U,L)}function I(T){T.target.removeEventListener("dispose",I);for(let E in c){let H=c[E],U=T.target.uuid;U in H&&(H[U].dispose(),delete H[U])}}}function OC(n,e){function t(){let F=!1,oe=new Lt,ne=null,we=new Lt(0,0,0,0);return{setMask:function(_e){ne!==_e&&!F&&(n.colorMask(_e,_e,_e,_e),ne=_e)},setLocked:function(_e){F=_e},setClear:function(_e,Se,Xe,et,ce){ce===!0&&(_e*=et,Se*=et,Xe*=et),oe.set(_e,Se,Xe,et),we.equals(oe)===!1&&(n.clearColor(_e,Se,Xe,et),we.copy(oe))},reset:function(){F=!1,ne=null,we.set(-1,0,0,0)}}}function i(){let F=!1,oe=!1,ne=null,we=null,_e=null;return{setReversed:function(Se){if(oe!==Se){let Xe=e.get("EXT_clip_control");Se?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),oe=Se;let et=_e;_e=null,this.setClear(et)}},getReversed:function(){return oe},setTest:function(Se){Se?ye(n.DEPTH_TEST):We(n.DEPTH_TEST)},setMask:function(Se){ne!==Se&&!F&&(n.depthMask(Se),ne=Se)},setFunc:function(Se){if(oe&&(Se=ey[Se]),we!==Se){switch(Se){case fu:n.depthFunc(n.NEVER);break;case pu:n.depthFunc(n.ALWAYS);break;case mu:n.depthFunc(n.LESS);break;case yr:n.depthFunc(n.LEQUAL);break;case gu:n.depthFunc(n.EQUAL);break;case _u:n.depthFunc(n.GEQUAL);break;case xu:n.depthFunc(n.GREATER);break;case yu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}we=Se}},setLocked:function(Se){F=Se},setClear:function(Se){_e!==Se&&(_e=Se,oe&&(Se=1-Se),n.clearDepth(Se))},reset:function(){F=!1,ne=null,we=null,_e=null,oe=!1}}}function s(){let F=!1,oe=null,ne=null,we=null,_e=null,Se=null,Xe=null,et=null,ce=null;return{setTest:function(ze){F||(ze?ye(n.STENCIL_TEST):We(n.STENCIL_TEST))},setMask:function(ze){oe!==ze&&!F&&(n.stencilMask(ze),oe=ze)},setFunc:function(ze,tt,Ce){(ne!==ze||we!==tt||_e!==Ce)&&(n.stencilFunc(ze,tt,Ce),ne=ze,we=tt,_e=Ce)},setOp:function(ze,tt,Ce){(Se!==ze||Xe!==tt||et!==Ce)&&(n.stencilOp(ze,tt,Ce),Se=ze,Xe=tt,et=Ce)},setLocked:function(ze){F=ze},setClear:function(ze){ce!==ze&&(n.clearStencil(ze),ce=ze)},reset:function(){F=!1,oe=null,ne=null,we=null,_e=null,Se=null,Xe=null,et=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],b=null,m=!1,g=null,v=null,C=null,S=null,I=null,T=null,x=null,E=new dt(0,0,0),H=0,U=!1,L=null,G=null,V=null,N=null,W=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),O=!1,re=0,J=n.getParameter(n.VERSION);J.indexOf("WebGL")!==-1?(re=parseFloat(/^WebGL (\d)/.exec(J)[1]),O=re>=1):J.indexOf("OpenGL ES")!==-1&&(re=parseFloat(/^OpenGL ES (\d)/.exec(J)[1]),O=re>=2);let ee=null,ie={},de=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),Q=new Lt().fromArray(de),me=new Lt().fromArray(he);function ge(F,oe,ne,we){let _e=new Uint8Array(4),Se=n.createTexture();n.bindTexture(F,Se),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ne;Xe++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,we,0,n.RGBA,n.UNSIGNED_BYTE,_e):n.texImage2D(oe+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,_e);return Se}let Ee={};Ee[n.TEXTURE_2D]=ge(n.TEXTURE_2D,n.TEXTURE_2D,1),Ee[n.TEXTURE_CUBE_MAP]=ge(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ee[n.TEXTURE_2D_ARRAY]=ge(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ee[n.TEXTURE_3D]=ge(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ye(n.DEPTH_TEST),o.setFunc(yr),dn(!1),Bt(lp),ye(n.CULL_FACE),Qt(Zr);function ye(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function We(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function Ne(F,oe){return h[F]!==oe?(n.bindFramebuffer(F,oe),h[F]=oe,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=oe),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function Le(F,oe){let ne=p,we=!1;if(F){ne=d.get(oe),ne===void 0&&(ne=[],d.set(oe,ne));let _e=F.textures;if(ne.length!==_e.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Se=0,Xe=_e.length;Se<Xe;Se++)ne[Se]=n.COLOR_ATTACHMENT0+Se;ne.length=_e.length,we=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,we=!0);we&&n.drawBuffers(ne)}function at(F){return b!==F?(n.useProgram(F),b=F,!0):!1}let ut={[Kr]:n.FUNC_ADD,[Mx]:n.FUNC_SUBTRACT,[wx]:n.FUNC_REVERSE_SUBTRACT};ut[Ax]=n.MIN,ut[Tx]=n.MAX;let rt={[Ex]:n.ZERO,[Cx]:n.ONE,[Rx]:n.SRC_COLOR,[dp]:n.SRC_ALPHA,[Ux]:n.SRC_ALPHA_SATURATE,[Dx]:n.DST_COLOR,[Ix]:n.DST_ALPHA,[Px]:n.ONE_MINUS_SRC_COLOR,[fp]:n.ONE_MINUS_SRC_ALPHA,[Nx]:n.ONE_MINUS_DST_COLOR,[Lx]:n.ONE_MINUS_DST_ALPHA,[Ox]:n.CONSTANT_COLOR,[Fx]:n.ONE_MINUS_CONSTANT_COLOR,[Bx]:n.CONSTANT_ALPHA,[kx]:n.ONE_MINUS_CONSTANT_ALPHA};function Qt(F,oe,ne,we,_e,Se,Xe,et,ce,ze){if(F===Zr){m===!0&&(We(n.BLEND),m=!1);return}if(m===!1&&(ye(n.BLEND),m=!0),F!==Sx){if(F!==g||ze!==U){if((v!==Kr||I!==Kr)&&(n.blendEquation(n.FUNC_ADD),v=Kr,I=Kr),ze)switch(F){case fa:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cp:n.blendFunc(n.ONE,n.ONE);break;case up:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case hp:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:it("WebGLState: Invalid blending: ",F);break}else switch(F){case fa:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case cp:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case up:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case hp:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",F);break}C=null,S=null,T=null,x=null,E.set(0,0,0),H=0,g=F,U=ze}return}_e=_e||oe,Se=Se||ne,Xe=Xe||we,(oe!==v||_e!==I)&&(n.blendEquationSeparate(ut[oe],ut[_e]),v=oe,I=_e),(ne!==C||we!==S||Se!==T||Xe!==x)&&(n.blendFuncSeparate(rt[ne],rt[we],rt[Se],rt[Xe]),C=ne,S=we,T=Se,x=Xe),(et.equals(E)===!1||ce!==H)&&(n.blendColor(et.r,et.g,et.b,ce),E.copy(et),H=ce),g=F,U=!1}function $t(F,oe){F.side===xi?We(n.CULL_FACE):ye(n.CULL_FACE);let ne=F.side===di;oe&&(ne=!ne),dn(ne),F.blending===fa&&F.transparent===!1?Qt(Zr):Qt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let we=F.stencilWrite;a.setTest(we),we&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),bt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?ye(n.SAMPLE_ALPHA_TO_COVERAGE):We(n.SAMPLE_ALPHA_TO_COVERAGE)}function dn(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function Bt(F){F!==yx?(ye(n.CULL_FACE),F!==G&&(F===lp?n.cullFace(n.BACK):F===vx?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):We(n.CULL_FACE),G=F}function In(F){F!==V&&(O&&n.lineWidth(F),V=F)}function bt(F,oe,ne){F?(ye(n.POLYGON_OFFSET_FILL),(N!==oe||W!==ne)&&(N=oe,W=ne,o.getReversed()&&(oe=-oe,ne=-ne),n.polygonOffset(oe,ne))):We(n.POLYGON_OFFSET_FILL)}function Mn(F){F?ye(n.SCISSOR_TEST):We(n.SCISSOR_TEST)}function nn(F){F===void 0&&(F=n.TEXTURE0+q-1),ee!==F&&(n.activeTexture(F),ee=F)}function fn(F,oe,ne){ne===void 0&&(ee===null?ne=n.TEXTURE0+q-1:ne=ee);let we=ie[ne];we===void 0&&(we={type:void 0,texture:void 0},ie[ne]=we),(we.type!==F||we.texture!==oe)&&(ee!==ne&&(n.activeTexture(ne),ee=ne),n.bindTexture(F,oe||Ee[F]),we.type=F,we.texture=oe)}function B(){let F=ie[ee];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function lt(){try{n.texSubImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function Me(){try{n.texSubImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function Ge(){try{n.compressedTexSubImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function Ye(){try{n.texStorage2D(...arguments)}catch(F){it("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){it("WebGLState:",F)}}function M(){try{n.texImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function $(){try{n.texImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function ue(F){return f[F]!==void 0?f[F]:n.getParameter(F)}function ae(F,oe){f[F]!==oe&&(n.pixelStorei(F,oe),f[F]=oe)}function xe(F){Q.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),Q.copy(F))}function ve(F){me.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),me.copy(F))}function te(F,oe){let ne=c.get(oe);ne===void 0&&(ne=new WeakMap,c.set(oe,ne));let we=ne.get(F);we===void 0&&(we=n.getUniformBlockIndex(oe,F.name),n.uniformBlockBinding(oe,we,we),ne.set(F,we))}function se(F,oe,ne){let _e=c.get(oe).get(F);l[_e]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,_e,ne),l[_e]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},ee=null,ie={},h={},l={},d=new WeakMap,p=[],b=null,m=!1,g=null,v=null,C=null,S=null,I=null,T=null,x=null,E=new dt(0,0,0),H=0,U=!1,L=null,G=null,V=null,N=null,W=null,Q.set(0,0,n.canvas.width,n.canvas.height),me.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ye,disable:We,bindFramebuffer:Ne,drawBuffers:Le,useProgram:at,setBlending:Qt,setMaterial:$t,setFlipSided:dn,setCullFace:Bt,setLineWidth:In,setPolygonOffset:bt,setScissorTest:Mn,activeTexture:nn,bindTexture:fn,unbindTexture:B,compressedTexImage2D:Re,compressedTexImage3D:Ze,texImage2D:M,texImage3D:$,pixelStorei:ae,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:Ye,texStorage3D:R,texSubImage2D:lt,texSubImage3D:Me,compressedTexSubImage2D:zt,compressedTexSubImage3D:Ge,scissor:xe,viewport:ve,reset:pe}}function FC(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,b=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,M){return m?new OffscreenCanvas(R,M):nl("canvas")}function v(R,M,$){let ue=1,ae=Ye(R);if((ae.width>$||ae.height>$)&&(ue=$/Math.max(ae.width,ae.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let xe=Math.floor(ue*ae.width),ve=Math.floor(ue*ae.height);h===void 0&&(h=g(xe,ve));let te=M?g(xe,ve):h;return te.width=xe,te.height=ve,te.getContext("2d").drawImage(R,0,0,xe,ve),Je("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+xe+"x"+ve+")."),te}else return"data"in R&&Je("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function C(R){return R.generateMipmaps}function S(R){n.generateMipmap(R)}function I(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function T(R,M,$,ue,ae,xe=!1){if(R!==null){if(n[R]!==void 0)return n[R];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ve;ue&&(ve=e.get("EXT_texture_norm16"),ve||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=M;if(M===n.RED&&($===n.FLOAT&&(te=n.R32F),$===n.HALF_FLOAT&&(te=n.R16F),$===n.UNSIGNED_BYTE&&(te=n.R8),$===n.UNSIGNED_SHORT&&ve&&(te=ve.R16_EXT),$===n.SHORT&&ve&&(te=ve.R16_SNORM_EXT)),M===n.RED_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.R8UI),$===n.UNSIGNED_SHORT&&(te=n.R16UI),$===n.UNSIGNED_INT&&(te=n.R32UI),$===n.BYTE&&(te=n.R8I),$===n.SHORT&&(te=n.R16I),$===n.INT&&(te=n.R32I)),M===n.RG&&($===n.FLOAT&&(te=n.RG32F),$===n.HALF_FLOAT&&(te=n.RG16F),$===n.UNSIGNED_BYTE&&(te=n.RG8),$===n.UNSIGNED_SHORT&&ve&&(te=ve.RG16_EXT),$===n.SHORT&&ve&&(te=ve.RG16_SNORM_EXT)),M===n.RG_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RG8UI),$===n.UNSIGNED_SHORT&&(te=n.RG16UI),$===n.UNSIGNED_INT&&(te=n.RG32UI),$===n.BYTE&&(te=n.RG8I),$===n.SHORT&&(te=n.RG16I),$===n.INT&&(te=n.RG32I)),M===n.RGB_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGB8UI),$===n.UNSIGNED_SHORT&&(te=n.RGB16UI),$===n.UNSIGNED_INT&&(te=n.RGB32UI),$===n.BYTE&&(te=n.RGB8I),$===n.SHORT&&(te=n.RGB16I),$===n.INT&&(te=n.RGB32I)),M===n.RGBA_INTEGER&&($===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),$===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),$===n.UNSIGNED_INT&&(te=n.RGBA32UI),$===n.BYTE&&(te=n.RGBA8I),$===n.SHORT&&(te=n.RGBA16I),$===n.INT&&(te=n.RGBA32I)),M===n.RGB&&($===n.UNSIGNED_SHORT&&ve&&(te=ve.RGB16_EXT),$===n.SHORT&&ve&&(te=ve.RGB16_SNORM_EXT),$===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),$===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),M===n.RGBA){let se=xe?tl:vt.getTransfer(ae);$===n.FLOAT&&(te=n.RGBA32F),$===n.HALF_FLOAT&&(te=n.RGBA16F),$===n.UNSIGNED_BYTE&&(te=se===It?n.SRGB8_ALPHA8:n.RGBA8),$===n.UNSIGNED_SHORT&&ve&&(te=ve.RGBA16_EXT),$===n.SHORT&&ve&&(te=ve.RGBA16_SNORM_EXT),$===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),$===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(R,M){let $;return R?M===null||M===ss||M===Qr?$=n.DEPTH24_STENCIL8:M===rs?$=n.DEPTH32F_STENCIL8:M===ma&&($=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):M===null||M===ss||M===Qr?$=n.DEPTH_COMPONENT24:M===rs?$=n.DEPTH_COMPONENT32F:M===ma&&($=n.DEPTH_COMPONENT16),$}function E(R,M){return C(R)===!0||R.isFramebufferTexture&&R.minFilter!==hn&&R.minFilter!==hi?Math.log2(Math.max(M.width,M.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?M.mipmaps.length:1}function H(R){let M=new WeakRef(R);i.get(R).__ref=M,p.add(M),b.register(R,M,M)}function U(R){let M=i.get(R).__ref;M!==void 0&&(p.delete(M),b.unregister(M))}function L(R){V(R.target)}function G(R){N(R.target)}function V(R){R.removeEventListener("dispose",L),U(R),q(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function N(R){R.removeEventListener("dispose",G),U(R),re(R)}function W(){for(let R of p){let M=R.deref();M!==void 0&&(M.isRenderTarget===!0?N(M):V(M))}p.clear(),f.clear()}function q(R){let M=i.get(R);if(M.__webglInit===void 0)return;let $=R.source,ue=d.get($);if(ue){let ae=ue[M.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&O(R),Object.keys(ue).length===0&&d.delete($)}i.remove(R)}function O(R){let M=i.get(R);n.deleteTexture(M.__webglTexture);let $=R.source,ue=d.get($);delete ue[M.__cacheKey],o.memory.textures--}function re(R){let M=i.get(R);M.__depthDisposeCallback&&M.__depthDisposeCallback();let $=R.depthTexture;if($&&$.renderTarget===R&&V($),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(M.__webglFramebuffer[ae]))for(let xe=0;xe<M.__webglFramebuffer[ae].length;xe++)n.deleteFramebuffer(M.__webglFramebuffer[ae][xe]);else n.deleteFramebuffer(M.__webglFramebuffer[ae]);M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer[ae])}else{if(Array.isArray(M.__webglFramebuffer))for(let ae=0;ae<M.__webglFramebuffer.length;ae++)n.deleteFramebuffer(M.__webglFramebuffer[ae]);else n.deleteFramebuffer(M.__webglFramebuffer);if(M.__webglDepthbuffer&&n.deleteRenderbuffer(M.__webglDepthbuffer),M.__webglMultisampledFramebuffer&&n.deleteFramebuffer(M.__webglMultisampledFramebuffer),M.__webglColorRenderbuffer)for(let ae=0;ae<M.__webglColorRenderbuffer.length;ae++)M.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(M.__webglColorRenderbuffer[ae]);M.__webglDepthRenderbuffer&&n.deleteRenderbuffer(M.__webglDepthRenderbuffer)}let ue=R.textures;for(let ae=0,xe=ue.length;ae<xe;ae++){let ve=i.get(ue[ae]);ve.__webglTexture&&(n.deleteTexture(ve.__webglTexture),o.memory.textures--),i.remove(ue[ae])}i.remove(R)}let J=0;function ee(){J=0}function ie(){return J}function de(R){J=R}function he(){let R=J;return R>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),J+=1,R}function Q(R){let M=[];return M.push(R.wrapS),M.push(R.wrapT),M.push(R.wrapR||0),M.push(R.magFilter),M.push(R.minFilter),M.push(R.anisotropy),M.push(R.internalFormat),M.push(R.format),M.push(R.type),M.push(R.generateMipmaps),M.push(R.mipmapsAutoUpdate),M.push(R.premultiplyAlpha),M.push(R.flipY),M.push(R.unpackAlignment),M.push(R.colorSpace),M.join()}function me(R,M){let $=i.get(R);if(R.isVideoTexture&&zt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&$.__version!==R.version){let ue=R.image;if(ue===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{$t($,R,M);return}}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,$.__webglTexture,n.TEXTURE0+M)}function ge(R,M){let $=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){$t($,R,M);return}else R.isExternalTexture&&($.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,$.__webglTexture,n.TEXTURE0+M)}function Ee(R,M){let $=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&$.__version!==R.version){$t($,R,M);return}t.bindTexture(n.TEXTURE_3D,$.__webglTexture,n.TEXTURE0+M)}function ye(R,M){let $=i.get(R);if(R.version>0&&$.__version!==R.version){dn($,R,M);return}t.bindTexture(n.TEXTURE_CUBE_MAP,$.__webglTexture,n.TEXTURE0+M)}let We={[vu]:n.REPEAT,[_s]:n.CLAMP_TO_EDGE,[bu]:n.MIRRORED_REPEAT},Ne={[hn]:n.NEAREST,[Hx]:n.NEAREST_MIPMAP_NEAREST,[Tl]:n.NEAREST_MIPMAP_LINEAR,[hi]:n.LINEAR,[Ju]:n.LINEAR_MIPMAP_NEAREST,[Ys]:n.LINEAR_MIPMAP_LINEAR},Le={[$x]:n.NEVER,[Ip]:n.ALWAYS,[qx]:n.LESS,[Rp]:n.LEQUAL,[Yx]:n.EQUAL,[Pp]:n.GEQUAL,[Jx]:n.GREATER,[Zx]:n.NOTEQUAL};function at(R,M){if(M.type===rs&&e.has("OES_texture_float_linear")===!1&&(M.magFilter===hi||M.magFilter===Ju||M.magFilter===Tl||M.magFilter===Ys||M.minFilter===hi||M.minFilter===Ju||M.minFilter===Tl||M.minFilter===Ys)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,We[M.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,We[M.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,We[M.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,Ne[M.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,Ne[M.minFilter]),M.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Le[M.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(M.magFilter===hn||M.minFilter!==Tl&&M.minFilter!==Ys||M.type===rs&&e.has("OES_texture_float_linear")===!1)return;if(M.anisotropy>1||i.get(M).__currentAnisotropy){let $=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,$.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(M.anisotropy,s.getMaxAnisotropy())),i.get(M).__currentAnisotropy=M.anisotropy}}}function ut(R,M){let $=!1;R.__webglInit===void 0&&(R.__webglInit=!0,M.addEventListener("dispose",L),H(M));let ue=M.source,ae=d.get(ue);ae===void 0&&(ae={},d.set(ue,ae));let xe=Q(M);if(xe!==R.__cacheKey){ae[xe]===void 0&&(ae[xe]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,$=!0),ae[xe].usedTimes++;let ve=ae[R.__cacheKey];ve!==void 0&&(ae[R.__cacheKey].usedTimes--,ve.usedTimes===0&&O(M)),R.__cacheKey=xe,R.__webglTexture=ae[xe].texture}return $}function rt(R,M,$){return Math.floor(Math.floor(R/$)/M)}function Qt(R,M,$,ue){let xe=R.updateRanges;if(xe.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,M.width,M.height,$,ue,M.data);else{xe.sort((F,oe)=>F.start-oe.start);let ve=0;for(let F=1;F<xe.length;F++){let oe=xe[ve],ne=xe[F],we=oe.start+oe.count,_e=rt(ne.start,M.width,4),Se=rt(oe.start,M.width,4);ne.start<=we+1&&_e===Se&&rt(ne.start+ne.count-1,M.width,4)===_e?oe.count=Math.max(oe.count,ne.start+ne.count-oe.start):(++ve,xe[ve]=ne)}xe.length=ve+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,M.width);for(let F=0,oe=xe.length;F<oe;F++){let ne=xe[F],we=Math.floor(ne.start/4),_e=Math.ceil(ne.count/4),Se=we%M.width,Xe=Math.floor(we/M.width),et=_e,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Se),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Se,Xe,et,ce,$,ue,M.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function $t(R,M,$){let ue=n.TEXTURE_2D;(M.isDataArrayTexture||M.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),M.isData3DTexture&&(ue=n.TEXTURE_3D);let ae=ut(R,M),xe=M.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+$);let ve=i.get(xe);if(xe.version!==ve.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+$),(typeof ImageBitmap<"u"&&M.image instanceof ImageBitmap)===!1){let ce=vt.getPrimaries(vt.workingColorSpace),ze=M.colorSpace===Zs?null:vt.getPrimaries(M.colorSpace),tt=M.colorSpace===Zs||ce===ze?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment);let se=v(M.image,!1,s.maxTextureSize);se=Ge(M,se);let pe=r.convert(M.format,M.colorSpace),F=r.convert(M.type),oe=T(M.internalFormat,pe,F,M.normalized,M.colorSpace,M.isVideoTexture);at(ue,M);let ne,we=M.mipmaps,_e=M.isVideoTexture!==!0,Se=ve.__version===void 0||ae===!0,Xe=xe.dataReady,et=E(M,se);if(M.isDepthTexture)oe=x(M.format===Js,M.type),Se&&(_e?t.texStorage2D(n.TEXTURE_2D,1,oe,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,oe,se.width,se.height,0,pe,F,null));else if(M.isDataTexture)if(we.length>0){_e&&Se&&t.texStorage2D(n.TEXTURE_2D,et,oe,we[0].width,we[0].height);for(let ce=0,ze=we.length;ce<ze;ce++)ne=we[ce],_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ne.width,ne.height,0,pe,F,ne.data);M.generateMipmaps=!1}else _e?(Se&&t.texStorage2D(n.TEXTURE_2D,et,oe,se.width,se.height),Xe&&Qt(M,se,pe,F)):t.texImage2D(n.TEXTURE_2D,0,oe,se.width,se.height,0,pe,F,se.data);else if(M.isCompressedTexture)if(M.isCompressedArrayTexture){_e&&Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,oe,we[0].width,we[0].height,se.depth);for(let ce=0,ze=we.length;ce<ze;ce++)if(ne=we[ce],M.format!==Ui)if(pe!==null)if(_e){if(Xe)if(M.layerUpdates.size>0){let tt=Vp(ne.width,ne.height,M.format,M.type);for(let Ce of M.layerUpdates){let ht=ne.data.subarray(Ce*tt/ne.data.BYTES_PER_ELEMENT,(Ce+1)*tt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Ce,ne.width,ne.height,1,pe,ht)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ne.width,ne.height,se.depth,0,ne.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else _e?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,F,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,oe,ne.width,ne.height,se.depth,0,pe,F,ne.data);M.layerUpdates.size>0&&M.clearLayerUpdates()}else{_e&&Se&&t.texStorage2D(n.TEXTURE_2D,et,oe,we[0].width,we[0].height);for(let ce=0,ze=we.length;ce<ze;ce++)ne=we[ce],M.format!==Ui?pe!==null?_e?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,oe,ne.width,ne.height,0,ne.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,oe,ne.width,ne.height,0,pe,F,ne.data)}else if(M.isDataArrayTexture)if(_e){if(Se&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,oe,se.width,se.height,se.depth),Xe)if(M.layerUpdates.size>0){let ce=Vp(se.width,se.height,M.format,M.type);for(let ze of M.layerUpdates){let tt=se.data.subarray(ze*ce/se.data.BYTES_PER_ELEMENT,(ze+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ze,se.width,se.height,1,pe,F,tt)}M.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,F,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,se.width,se.height,se.depth,0,pe,F,se.data);else if(M.isData3DTexture)_e?(Se&&t.texStorage3D(n.TEXTURE_3D,et,oe,se.width,se.height,se.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,F,se.data)):t.texImage3D(n.TEXTURE_3D,0,oe,se.width,se.height,se.depth,0,pe,F,se.data);else if(M.isFramebufferTexture){if(Se)if(_e)t.texStorage2D(n.TEXTURE_2D,et,oe,se.width,se.height);else{let ce=se.width,ze=se.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,oe,ce,ze,0,pe,F,null),ce>>=1,ze>>=1}}else if(M.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),f.add(M),ce.onpaint=ze=>{let tt=ze.changedElements;for(let Ce of f)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let tt=n.RGBA,Ce=n.RGBA,ht=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Ce,ht,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(we.length>0){if(_e&&Se){let ce=Ye(we[0]);t.texStorage2D(n.TEXTURE_2D,et,oe,ce.width,ce.height)}for(let ce=0,ze=we.length;ce<ze;ce++)ne=we[ce],_e?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,F,ne):t.texImage2D(n.TEXTURE_2D,ce,oe,pe,F,ne);M.generateMipmaps=!1}else if(_e){if(Se){let ce=Ye(se);t.texStorage2D(n.TEXTURE_2D,et,oe,ce.width,ce.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,F,se)}else t.texImage2D(n.TEXTURE_2D,0,oe,pe,F,se);C(M)&&M.mipmapsAutoUpdate===!0&&S(ue),ve.__version=xe.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function dn(R,M,$){if(M.image.length!==6)return;let ue=ut(R,M),ae=M.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+$);let xe=i.get(ae);if(ae.version!==xe.__version||ue===!0){t.activeTexture(n.TEXTURE0+$);let ve=vt.getPrimaries(vt.workingColorSpace),te=M.colorSpace===Zs?null:vt.getPrimaries(M.colorSpace),se=M.colorSpace===Zs||ve===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,M.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,M.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,M.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=M.isCompressedTexture||M.image[0].isCompressedTexture,F=M.image[0]&&M.image[0].isDataTexture,oe=[];for(let Ce=0;Ce<6;Ce++)!pe&&!F?oe[Ce]=v(M.image[Ce],!0,s.maxCubemapSize):oe[Ce]=F?M.image[Ce].image:M.image[Ce],oe[Ce]=Ge(M,oe[Ce]);let ne=oe[0],we=r.convert(M.format,M.colorSpace),_e=r.convert(M.type),Se=T(M.internalFormat,we,_e,M.normalized,M.colorSpace),Xe=M.isVideoTexture!==!0,et=xe.__version===void 0||ue===!0,ce=ae.dataReady,ze=E(M,ne);at(n.TEXTURE_CUBE_MAP,M);let tt;if(M.isDepthTexture){if(Se=x(M.format===Js,M.type),et)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Se,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,ne.width,ne.height,0,we,_e,null)}else if(pe){Xe&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){tt=oe[Ce].mipmaps;for(let ht=0;ht<tt.length;ht++){let qt=tt[ht];M.format!==Ui?we!==null?Xe?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,qt.width,qt.height,we,qt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,qt.width,qt.height,0,qt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,0,0,qt.width,qt.height,we,_e,qt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht,Se,qt.width,qt.height,0,we,_e,qt.data)}}}else{if(tt=M.mipmaps,Xe&&et){tt.length>0&&ze++;let Ce=Ye(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ze,Se,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(F){Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,oe[Ce].width,oe[Ce].height,we,_e,oe[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,oe[Ce].width,oe[Ce].height,0,we,_e,oe[Ce].data);for(let ht=0;ht<tt.length;ht++){let ni=tt[ht].image[Ce].image;Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,ni.width,ni.height,we,_e,ni.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,ni.width,ni.height,0,we,_e,ni.data)}}else{Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,we,_e,oe[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Se,we,_e,oe[Ce]);for(let ht=0;ht<tt.length;ht++){let qt=tt[ht];Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,0,0,we,_e,qt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ht+1,Se,we,_e,qt.image[Ce])}}}C(M)&&M.mipmapsAutoUpdate===!0&&S(n.TEXTURE_CUBE_MAP),xe.__version=ae.version,M.onUpdate&&M.onUpdate(M)}R.__version=M.version}function Bt(R,M,$,ue,ae,xe){let ve=r.convert($.format,$.colorSpace),te=r.convert($.type),se=T($.internalFormat,ve,te,$.normalized,$.colorSpace),pe=i.get(M),F=i.get($);if(F.__renderTarget=M,!pe.__hasExternalTextures){let oe=Math.max(1,M.width>>xe),ne=Math.max(1,M.height>>xe);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,xe,se,oe,ne,M.depth,0,ve,te,null):t.texImage2D(ae,xe,se,oe,ne,0,ve,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,ae,F.__webglTexture,0,lt(M)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,ae,F.__webglTexture,xe),t.bindFramebuffer(n.FRAMEBUFFER,null)}function In(R,M,$){if(n.bindRenderbuffer(n.RENDERBUFFER,R),M.depthBuffer){let ue=M.depthTexture,ae=ue&&ue.isDepthTexture?ue.type:null,xe=x(M.stencilBuffer,ae),ve=M.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),xe,M.width,M.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),xe,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,xe,M.width,M.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,ve,n.RENDERBUFFER,R)}else{let ue=M.textures;for(let ae=0;ae<ue.length;ae++){let xe=ue[ae],ve=r.convert(xe.format,xe.colorSpace),te=r.convert(xe.type),se=T(xe.internalFormat,ve,te,xe.normalized,xe.colorSpace);Me(M)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,lt(M),se,M.width,M.height):$?n.renderbufferStorageMultisample(n.RENDERBUFFER,lt(M),se,M.width,M.height):n.renderbufferStorage(n.RENDERBUFFER,se,M.width,M.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(R,M,$){let ue=M.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(M.depthTexture&&M.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(M.depthTexture);ae.__renderTarget=M;let xe=ue?M.depthTexture.image[0]:M.depthTexture.image;(!ae.__webglTexture||xe.width!==M.width||xe.height!==M.height)&&(xe.width=M.width,xe.height=M.height,M.depthTexture.needsUpdate=!0),ue?ye(M.depthTexture,0):me(M.depthTexture,0);let ve=ae.__webglTexture,te=lt(M),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+$:n.TEXTURE_2D,pe=M.depthTexture.format===Js?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(M.depthTexture.format===Xs)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ve,0);else if(M.depthTexture.format===Js)Me(M)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,ve,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,ve,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Mn(R){let M=i.get(R),$=R.isWebGLCubeRenderTarget===!0;if(M.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(M.__depthDisposeCallback&&M.__depthDisposeCallback(),ue){let ae=()=>{delete M.__boundDepthTexture,delete M.__depthDisposeCallback,ue.removeEventListener("dispose",ae)};ue.addEventListener("dispose",ae),M.__depthDisposeCallback=ae}M.__boundDepthTexture=ue}if(R.depthTexture&&!M.__autoAllocateDepthBuffer)if($)for(let ue=0;ue<6;ue++)bt(M.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?bt(M.__webglFramebuffer[0],R,0):bt(M.__webglFramebuffer,R,0);else if($){M.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[ue]),M.__webglDepthbuffer[ue]===void 0)M.__webglDepthbuffer[ue]=n.createRenderbuffer(),In(M.__webglDepthbuffer[ue],R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,M.__webglFramebuffer),M.__webglDepthbuffer===void 0)M.__webglDepthbuffer=n.createRenderbuffer(),In(M.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,xe=M.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,xe),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,xe)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function nn(R,M,$){let ue=i.get(R);M!==void 0&&Bt(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),$!==void 0&&Mn(R)}function fn(R){let M=R.texture,$=i.get(R),ue=i.get(M);R.addEventListener("dispose",G),H(R);let ae=R.textures,xe=R.isWebGLCubeRenderTarget===!0,ve=ae.length>1;if(ve||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=M.version,o.memory.textures++),xe){$.__webglFramebuffer=[];for(let te=0;te<6;te++)if(M.mipmaps.length>0){$.__webglFramebuffer[te]=[];for(let se=0;se<M.mipmaps.length;se++)$.__webglFramebuffer[te][se]=n.createFramebuffer()}else $.__webglFramebuffer[te]=n.createFramebuffer()}else{if(M.mipmaps.length>0){$.__webglFramebuffer=[];for(let te=0;te<M.mipmaps.length;te++)$.__webglFramebuffer[te]=n.createFramebuffer()}else $.__webglFramebuffer=n.createFramebuffer();if(ve)for(let te=0,se=ae.length;te<se;te++){let pe=i.get(ae[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Me(R)===!1){$.__webglMultisampledFramebuffer=n.createFramebuffer(),$.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,$.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let se=ae[te];$.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,$.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),F=r.convert(se.type),oe=T(se.internalFormat,pe,F,se.normalized,se.colorSpace,R.isXRRenderTarget===!0),ne=lt(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,oe,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,$.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&($.__webglDepthRenderbuffer=n.createRenderbuffer(),In($.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(xe){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),at(n.TEXTURE_CUBE_MAP,M);for(let te=0;te<6;te++)if(M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Bt($.__webglFramebuffer[te][se],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Bt($.__webglFramebuffer[te],R,M,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(M)?S(n.TEXTURE_CUBE_MAP):M.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}else if(ve){for(let te=0,se=ae.length;te<se;te++){let pe=ae[te],F=i.get(pe),oe=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(oe=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,F.__webglTexture),at(oe,pe),Bt($.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,oe,0),C(pe)&&S(oe)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),at(te,M),M.mipmaps.length>0)for(let se=0;se<M.mipmaps.length;se++)Bt($.__webglFramebuffer[se],R,M,n.COLOR_ATTACHMENT0,te,se);else Bt($.__webglFramebuffer,R,M,n.COLOR_ATTACHMENT0,te,0);C(M)?S(te):M.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,M.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Mn(R)}function B(R){let M=R.textures;for(let $=0,ue=M.length;$<ue;$++){let ae=M[$];if(C(ae)&&ae.mipmapsAutoUpdate===!0){let xe=I(R),ve=i.get(ae).__webglTexture;t.bindTexture(xe,ve),S(xe),t.unbindTexture()}}}let Re=[];function Ze(R){if(R.samples>0){if(Me(R)===!1){let M=R.textures,$=R.width,ue=R.height,ae=n.COLOR_BUFFER_BIT,xe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=i.get(R),te=M.length>1;if(te)for(let pe=0;pe<M.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,ve.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglFramebuffer);for(let pe=0;pe<M.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,$,ue,0,0,$,ue,ae,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(xe),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<M.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,ve.__webglColorRenderbuffer[pe]);let F=i.get(M[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,ve.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,ve.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let M=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[M])}}}function lt(R){return Math.min(s.maxSamples,R.samples)}function Me(R){let M=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&M.__useRenderToTexture!==!1}function zt(R){let M=o.render.frame;u.get(R)!==M&&(u.set(R,M),R.update())}function Ge(R,M){let $=R.colorSpace,ue=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||$!==el&&$!==Zs&&(vt.getTransfer($)===It?(ue!==Ui||ae!==yi)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",$)),M}function Ye(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=ee,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=me,this.setTexture2DArray=ge,this.setTexture3D=Ee,this.setTextureCube=ye,this.rebindTextures=nn,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Mn,this.setupFrameBufferTexture=Bt,this.useMultisampledRTT=Me,this.dispose=W}function BC(n,e){function t(i,s=Zs){let r,o=vt.getTransfer(s);if(i===yi)return n.UNSIGNED_BYTE;if(i===Ku)return n.UNSIGNED_SHORT_4_4_4_4;if(i===ju)return n.UNSIGNED_SHORT_5_5_5_1;if(i===wp)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Ap)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Sp)return n.BYTE;if(i===Mp)return n.SHORT;if(i===ma)return n.UNSIGNED_SHORT;if(i===Zu)return n.INT;if(i===ss)return n.UNSIGNED_INT;if(i===rs)return n.FLOAT;if(i===os)return n.HALF_FLOAT;if(i===Tp)return n.ALPHA;if(i===Ep)return n.RGB;if(i===Ui)return n.RGBA;if(i===Xs)return n.DEPTH_COMPONENT;if(i===Js)return n.DEPTH_STENCIL;if(i===Cp)return n.RED;if(i===Qu)return n.RED_INTEGER;if(i===Pr)return n.RG;if(i===eh)return n.RG_INTEGER;if(i===th)return n.RGBA_INTEGER;if(i===El||i===Cl||i===Rl||i===Pl)if(o===It)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===El)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===Cl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===Rl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===Pl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===El)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===Cl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===Rl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===Pl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===nh||i===ih||i===sh||i===rh)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===nh)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===ih)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===sh)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===rh)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===oh||i===ah||i===lh||i===ch||i===uh||i===Il||i===hh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===oh||i===ah)return o===It?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===lh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ch)return r.COMPRESSED_R11_EAC;if(i===uh)return r.COMPRESSED_SIGNED_R11_EAC;if(i===Il)return r.COMPRESSED_RG11_EAC;if(i===hh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===xh||i===yh||i===vh||i===bh||i===Sh||i===Mh||i===wh||i===Ah)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===dh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===fh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ph)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===mh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===gh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===_h)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===xh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===yh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===vh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===bh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Sh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Mh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===wh)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ah)return o===It?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Th||i===Eh||i===Ch)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Th)return o===It?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Eh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Ch)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Rh||i===Ph||i===Ll||i===Ih)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Rh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Ph)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Ll)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Ih)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Qr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var kC=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,zC=`
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

}`,Zp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new dl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new Gi({vertexShader:kC,fragmentShader:zC,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Hn(new fl(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Kp=class extends ns{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,b=typeof XRWebGLBinding<"u",m=new Zp,g={},v=t.getContextAttributes(),C=null,S=null,I=[],T=[],x=new Ke,E=null,H=null,U=new ui;U.viewport=new Lt;let L=new ui;L.viewport=new Lt;let G=[U,L],V=new Xu,N=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(Q){let me=I[Q];return me===void 0&&(me=new ra,I[Q]=me),me.getTargetRaySpace()},this.getControllerGrip=function(Q){let me=I[Q];return me===void 0&&(me=new ra,I[Q]=me),me.getGripSpace()},this.getHand=function(Q){let me=I[Q];return me===void 0&&(me=new ra,I[Q]=me),me.getHandSpace()};function q(Q){let me=T.indexOf(Q.inputSource);if(me===-1)return;let ge=I[me];ge!==void 0&&(ge.update(Q.inputSource,Q.frame,c||o),ge.dispatchEvent({type:Q.type,data:Q.inputSource}))}function O(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",O),s.removeEventListener("inputsourceschange",re);for(let Q=0;Q<I.length;Q++){let me=T[Q];me!==null&&(T[Q]=null,I[Q].disconnect(me))}N=null,W=null,m.reset();for(let Q in g)delete g[Q];if(e.setRenderTarget(C),d=null,h=null,f=null,s=null,S=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(E),e.setSize(x.width,x.height,!1),H!==null){let Q=H.camera;Q.fov=H.fov,Q.zoom=H.zoom,Q.updateProjectionMatrix(),H=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(Q){r=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(Q){a=Q,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(Q){c=Q},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&b&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(Q){if(s=Q,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",O),s.addEventListener("inputsourceschange",re),v.xrCompatible!==!0&&await t.makeXRCompatible(),E=e.getPixelRatio(),e.getSize(x),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let ge=null,Ee=null,ye=null;v.depth&&(ye=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,ge=v.stencil?Js:Xs,Ee=v.stencil?Qr:ss);let We={colorFormat:t.RGBA8,depthFormat:ye,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(We),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),S=new Di(h.textureWidth,h.textureHeight,{format:Ui,type:yi,depthTexture:new qs(h.textureWidth,h.textureHeight,Ee,void 0,void 0,void 0,void 0,void 0,void 0,ge),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let ge={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,ge),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),S=new Di(d.framebufferWidth,d.framebufferHeight,{format:Ui,type:yi,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}S.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function re(Q){for(let me=0;me<Q.removed.length;me++){let ge=Q.removed[me],Ee=T.indexOf(ge);Ee>=0&&(T[Ee]=null,I[Ee].disconnect(ge))}for(let me=0;me<Q.added.length;me++){let ge=Q.added[me],Ee=T.indexOf(ge);if(Ee===-1){for(let We=0;We<I.length;We++)if(We>=T.length){T.push(ge),Ee=We;break}else if(T[We]===null){T[We]=ge,Ee=We;break}if(Ee===-1)break}let ye=I[Ee];ye&&ye.connect(ge)}}function J(Q,me){me===null?Q.matrixWorld.copy(Q.matrix):Q.matrixWorld.multiplyMatrices(me.matrixWorld,Q.matrix),Q.matrixWorldInverse.copy(Q.matrixWorld).invert()}this.updateCamera=function(Q){if(s===null)return;let me=Q.near,ge=Q.far;m.texture!==null&&(m.depthNear>0&&(me=m.depthNear),m.depthFar>0&&(ge=m.depthFar)),V.near=L.near=U.near=me,V.far=L.far=U.far=ge,(N!==V.near||W!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),N=V.near,W=V.far),V.layers.mask=Q.layers.mask|6,U.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let Ee=Q.parent,ye=V.cameras;J(V,Ee);for(let We=0;We<ye.length;We++)J(ye[We],Ee);V.projectionMatrix.copy(U.projectionMatrix),V.projectionMatrixInverse.copy(U.projectionMatrixInverse),H===null&&Q.isPerspectiveCamera&&(H={camera:Q,fov:Q.fov,zoom:Q.zoom}),ee(Q,V,Ee)};function ee(Q,me,ge){ge===null?Q.matrix.copy(me.matrixWorld):(Q.matrix.copy(ge.matrixWorld),Q.matrix.invert(),Q.matrix.multiply(me.matrixWorld)),Q.matrix.decompose(Q.position,Q.quaternion,Q.scale),Q.updateMatrixWorld(!0),Q.projectionMatrix.copy(me.projectionMatrix),Q.projectionMatrixInverse.copy(me.projectionMatrixInverse),Q.isPerspectiveCamera&&(Q.fov=ia*2*Math.atan(1/Q.projectionMatrix.elements[5]),Q.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(Q){l=Q,h!==null&&(h.fixedFoveation=Q),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=Q)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(V)},this.getCameraTexture=function(Q){return g[Q]};let ie=null;function de(Q,me){if(u=me.getViewerPose(c||o),p=me,u!==null){let ge=u.views;d!==null&&(e.setRenderTargetFramebuffer(S,d.framebuffer),e.setRenderTarget(S));let Ee=!1;ge.length!==V.cameras.length&&(V.cameras.length=0,Ee=!0);for(let Le=0;Le<ge.length;Le++){let at=ge[Le],ut=null;if(d!==null)ut=d.getViewport(at);else{let Qt=f.getViewSubImage(h,at);ut=Qt.viewport,Le===0&&(e.setRenderTargetTextures(S,Qt.colorTexture,Qt.depthStencilTexture),e.setRenderTarget(S))}let rt=G[Le];rt===void 0&&(rt=new ui,rt.layers.enable(Le),rt.viewport=new Lt,G[Le]=rt),rt.matrix.fromArray(at.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(at.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ut.x,ut.y,ut.width,ut.height),Le===0&&(V.matrix.copy(rt.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ee===!0&&V.cameras.push(rt)}let ye=s.enabledFeatures;if(ye&&ye.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){f=i.getBinding();let Le=f.getDepthInformation(ge[0]);Le&&Le.isValid&&Le.texture&&m.init(Le,s.renderState)}if(ye&&ye.includes("camera-access")&&b){e.state.unbindTexture(),f=i.getBinding();for(let Le=0;Le<ge.length;Le++){let at=ge[Le].camera;if(at){let ut=g[at];ut||(ut=new dl,g[at]=ut);let rt=f.getCameraImage(at);ut.sourceTexture=rt}}}}for(let ge=0;ge<I.length;ge++){let Ee=T[ge],ye=I[ge];Ee!==null&&ye!==void 0&&ye.update(Ee,me,c||o)}ie&&ie(Q,me),me.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:me}),p=null}let he=new Ay;he.setAnimationLoop(de),this.setAnimationLoop=function(Q){ie=Q},this.dispose=function(){}}},VC=new St,Uy=new st;Uy.set(-1,0,0,0,1,0,0,0,1);function HC(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,Bp(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,v,C,S){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),f(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),h(m,g),g.isMeshPhysicalMaterial&&d(m,g,S)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),b(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,v,C):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===di&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===di&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=e.get(g),C=v.envMap,S=v.envMapRotation;C&&(m.envMap.value=C,m.envMapRotation.value.setFromMatrix4(VC.makeRotationFromEuler(S)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Uy),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,v,C){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=C*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function f(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function h(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function d(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===di&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function b(m,g){let v=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function GC(n,e,t,i){let s={},r={};function o(v,C){let S=C.program;i.uniformBlockBinding(v,S,s[v.id])}function a(v,C){let S=s[v.id];S===void 0&&(p(v),S=l(v),s[v.id]=S,v.addEventListener("dispose",m));let I=C.program;i.updateUBOMapping(v,I);let T=e.render.frame;r[v.id]!==T&&(c(v),r[v.id]=T)}function l(v){let C=n.createBuffer(),S=v.__size,I=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,S,I),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(v){let C=s[v.id],S=v.uniforms,I=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let T=0,x=S.length;T<x;T++){let E=S[T];if(Array.isArray(E))for(let H=0,U=E.length;H<U;H++)u(E[H],T,H,I);else u(E,T,0,I)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,C,S,I){if(h(v,C,S,I)===!0){let T=v.__offset,x=v.value;if(Array.isArray(x)){let E=0;for(let H=0;H<x.length;H++){let U=x[H],L=b(U,!0);f(U,v.__data,E),E+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,T,v.__data)}}function f(v,C,S){typeof v=="number"||typeof v=="boolean"?C[S]=v:v.isMatrix3?(C[S]=v.elements[0],C[S+1]=v.elements[1],C[S+2]=v.elements[2],C[S+3]=0,C[S+4]=v.elements[3],C[S+5]=v.elements[4],C[S+6]=v.elements[5],C[S+7]=0,C[S+8]=v.elements[6],C[S+9]=v.elements[7],C[S+10]=v.elements[8],C[S+11]=0):ArrayBuffer.isView(v)?C.set(v.subarray(0,C.length-S),S):v.toArray(C,S)}function h(v,C,S,I){let T=v.value,x=C+"_"+S;if(Array.isArray(T)){I[x]===void 0&&(I[x]=[]);let E=I[x],H=!1;for(let U=0;U<T.length;U++)d(T[U],E,U)===!0&&(H=!0);return H}return d(T,I,x)}function d(v,C,S){if(C[S]===void 0)return typeof v=="number"||typeof v=="boolean"?C[S]=v:ArrayBuffer.isView(v)?C[S]=v.slice():C[S]=v.clone(),!0;{let I=C[S];if(typeof v=="number"||typeof v=="boolean"){if(I!==v)return C[S]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(I.equals(v)===!1)return I.copy(v),!0}}return!1}function p(v){let C=v.uniforms,S=0,I=16;for(let x=0,E=C.length;x<E;x++){let H=Array.isArray(C[x])?C[x]:[C[x]];for(let U=0,L=H.length;U<L;U++){let G=H[U],V=Array.isArray(G.value)?G.value:[G.value],N=Array.isArray(C[x])||Array.isArray(G.value),W=S;for(let O=0,re=V.length;O<re;O++){let J=V[O],ee=b(J,N),ie=S%I,de=ie%ee.boundary,he=ie+de;S+=de,he!==0&&I-he<ee.storage&&(S+=I-he),O===0&&(W=S),S+=ee.storage}let q=G.type==="int"?Int32Array:G.type==="uint"?Uint32Array:Float32Array;G.__data=new q((S-W)/Float32Array.BYTES_PER_ELEMENT),G.__offset=W}}let T=S%I;return T>0&&(S+=I-T),v.__size=S,v.__cache={},this}function b(v,C){let S={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(S.boundary=4,S.storage=4):v.isVector2?(S.boundary=8,S.storage=8):v.isVector3||v.isColor?(S.boundary=16,S.storage=12):v.isVector4?(S.boundary=16,S.storage=16):v.isMatrix3?(S.boundary=16,S.storage=48):v.isMatrix4?(S.boundary=16,S.storage=64):v.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(S.boundary=16,S.storage=v.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",v),C===!0&&(S.boundary=16,S.storage=Math.ceil(S.storage/16)*16),S}function m(v){let C=v.target;C.removeEventListener("dispose",m),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function g(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var WC=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),vs=null;function XC(){return vs===null&&(vs=new aa(WC,16,16,Pr,os),vs.name="DFG_LUT",vs.minFilter=hi,vs.magFilter=hi,vs.wrapS=_s,vs.wrapT=_s,vs.generateMipmaps=!1,vs.needsUpdate=!0),vs}var Fh=class{constructor(e={}){let{canvas:t=Kx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=yi}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let b=d,m=new Set([th,eh,Qu]),g=new Set([yi,ss,ma,Qr,Ku,ju]),v=new Uint32Array(4),C=new Int32Array(4),S={textures:[],min:[],max:[],resolution:[]},I=null,T=null,x=[],E=[],H=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ys,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,L=!1,G=null,V=null,N=null,W=null;this._outputColorSpace=Bn;let q=0,O=0,re=null,J=-1,ee=null,ie=new Lt,de=new Lt,he=null,Q=new dt(0),me=0,ge=t.width,Ee=t.height,ye=1,We=null,Ne=null,Le=new Lt(0,0,ge,Ee),at=new Lt(0,0,ge,Ee),ut=!1,rt=new br,Qt=new Eu,$t=!1,dn=!1,Bt=new St,In=new z,bt=new Lt,Mn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},nn=!1;function fn(){return re===null?ye:1}let B=i;function Re(A,k){return t.getContext(A,k)}let Ze,lt,Me,zt,Ge,Ye,R,M,$,ue,ae,xe,ve,te,se,pe,F,oe,ne,we,_e,Se,Xe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ze,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let k="webgl2";if(B=Re(k,A),B===null)throw Re(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(A){throw t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),it("WebGLRenderer: "+A.message),A}function et(){Ze=new nE(B),Ze.init(),_e=new BC(B,Ze),lt=new XT(B,Ze,e,_e),Me=new OC(B,Ze),lt.reversedDepthBuffer&&h&&Me.buffers.depth.setReversed(!0),V=B.createFramebuffer(),N=B.createFramebuffer(),W=B.createFramebuffer(),zt=new rE(B),Ge=new SC,Ye=new FC(B,Ze,Me,Ge,lt,_e,zt),R=new tE(U),M=new a1(B),Se=new GT(B,M),$=new iE(B,M,zt,Se),ue=new aE(B,$,M,Se,zt),oe=new oE(B,lt,Ye),se=new $T(Ge),ae=new bC(U,R,Ze,lt,Se,se),xe=new HC(U,Ge),ve=new wC,te=new PC(Ze),F=new HT(U,R,Me,ue,p,l),pe=new UC(U,ue,lt),Xe=new GC(B,zt,lt,Me),ne=new WT(B,Ze,zt),we=new sE(B,Ze,zt),zt.programs=ae.programs,U.capabilities=lt,U.extensions=Ze,U.properties=Ge,U.renderLists=ve,U.shadowMap=pe,U.state=Me,U.info=zt}b!==yi&&(H=new cE(b,t.width,t.height,a,s,r));let ce=new Kp(U,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Ze.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ze.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return ye},this.setPixelRatio=function(A){A!==void 0&&(ye=A,this.setSize(ge,Ee,!1))},this.getSize=function(A){return A.set(ge,Ee)},this.setSize=function(A,k,j=!0){if(ce.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}ge=A,Ee=k,t.width=Math.floor(A*ye),t.height=Math.floor(k*ye),j===!0&&(t.style.width=A+"px",t.style.height=k+"px"),H!==null&&H.setSize(t.width,t.height),this.setViewport(0,0,A,k)},this.getDrawingBufferSize=function(A){return A.set(ge*ye,Ee*ye).floor()},this.setDrawingBufferSize=function(A,k,j){ge=A,Ee=k,ye=j,t.width=Math.floor(A*j),t.height=Math.floor(k*j),this.setViewport(0,0,A,k)},this.setEffects=function(A){if(b===yi){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let k=0;k<A.length;k++)if(A[k].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}H.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ie)},this.getViewport=function(A){return A.copy(Le)},this.setViewport=function(A,k,j,Y){A.isVector4?Le.set(A.x,A.y,A.z,A.w):Le.set(A,k,j,Y),Me.viewport(ie.copy(Le).multiplyScalar(fn()).round())},this.getScissor=function(A){return A.copy(at)},this.setScissor=function(A,k,j,Y){A.isVector4?at.set(A.x,A.y,A.z,A.w):at.set(A,k,j,Y),Me.scissor(de.copy(at).multiplyScalar(fn()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(A){Me.setScissorTest(ut=A)},this.setOpaqueSort=function(A){We=A},this.setTransparentSort=function(A){Ne=A},this.getClearColor=function(A){return A.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(A=!0,k=!0,j=!0){let Y=0;if(A){let Z=!1;if(re!==null){let Ae=re.texture.format;Z=m.has(Ae)}if(Z){let Ae=re.texture.type,Ie=g.has(Ae),Te=F.getClearColor(),De=F.getClearAlpha(),He=Te.r,nt=Te.g,mt=Te.b;Ie?(v[0]=He,v[1]=nt,v[2]=mt,v[3]=De,B.clearBufferuiv(B.COLOR,0,v)):(C[0]=He,C[1]=nt,C[2]=mt,C[3]=De,B.clearBufferiv(B.COLOR,0,C))}else Y|=B.COLOR_BUFFER_BIT}k&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),G=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ze,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),F.dispose(),ve.dispose(),te.dispose(),Ye.dispose(),Ge.dispose(),R.dispose(),ue.dispose(),$.dispose(),Se.dispose(),Xe.dispose(),ae.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Vl),ce.removeEventListener("sessionend",as),ws.stop()};function ze(A){A.preventDefault(),il("WebGLRenderer: Context Lost."),L=!0}function tt(){il("WebGLRenderer: Context Restored."),L=!1;let A=zt.autoReset,k=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,Z=pe.type;et(),zt.autoReset=A,pe.enabled=k,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=Z}function Ce(A){it("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ht(A){let k=A.target;k.removeEventListener("dispose",ht),qt(k)}function qt(A){ni(A),Ge.remove(A)}function ni(A){let k=Ge.get(A).programs;k!==void 0&&(k.forEach(function(j){ae.releaseProgram(j)}),A.isShaderMaterial&&ae.releaseShaderCache(A))}this.renderBufferDirect=function(A,k,j,Y,Z,Ae){k===null&&(k=Mn);let Ie=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Te=Ma(A,k,j,Y,Z);Me.setMaterial(Y,Ie);let De=j.index,He=1;if(Y.wireframe===!0){if(De=$.getWireframeAttribute(j),De===void 0)return;He=2}let nt=j.drawRange,mt=j.attributes.position,Ve=nt.start*He,gt=(nt.start+nt.count)*He;Ae!==null&&(Ve=Math.max(Ve,Ae.start*He),gt=Math.min(gt,(Ae.start+Ae.count)*He)),De!==null?(Ve=Math.max(Ve,0),gt=Math.min(gt,De.count)):mt!=null&&(Ve=Math.max(Ve,0),gt=Math.min(gt,mt.count));let tn=gt-Ve;if(tn<0||tn===1/0)return;Se.setup(Z,Y,Te,j,De);let Dt,Nt=ne;if(De!==null&&(Dt=M.get(De),Nt=we,Nt.setIndex(Dt)),Z.isMesh)Y.wireframe===!0?(Me.setLineWidth(Y.wireframeLinewidth*fn()),Nt.setMode(B.LINES)):Nt.setMode(B.TRIANGLES);else if(Z.isLine){let wn=Y.linewidth;wn===void 0&&(wn=1),Me.setLineWidth(wn*fn()),Z.isLineSegments?Nt.setMode(B.LINES):Z.isLineLoop?Nt.setMode(B.LINE_LOOP):Nt.setMode(B.LINE_STRIP)}else Z.isPoints?Nt.setMode(B.POINTS):Z.isSprite&&Nt.setMode(B.TRIANGLES);if(Z.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Nt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let wn=Z._multiDrawStarts,Be=Z._multiDrawCounts,pn=Z._multiDrawCount,xt=De?M.get(De).bytesPerElement:1,Ts=Ge.get(Y).currentProgram.getUniforms();for(let mn=0;mn<pn;mn++)Ts.setValue(B,"_gl_DrawID",mn),Nt.render(wn[mn]/xt,Be[mn])}else if(Z.isInstancedMesh)Nt.renderInstances(Ve,tn,Z.count);else if(j.isInstancedBufferGeometry){let wn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Be=Math.min(j.instanceCount,wn);Nt.renderInstances(Ve,tn,Be)}else Nt.render(Ve,tn)};function va(A,k,j,Y){G!==null&&A.isNodeMaterial&&G.setObject(Y,A),$t===!0&&se.setState(A,j,!1),A.transparent===!0&&A.side===xi&&A.forceSinglePass===!1?(A.side=di,A.needsUpdate=!0,ls(A,k,Y),A.side=Rr,A.needsUpdate=!0,ls(A,k,Y),A.side=xi):ls(A,k,Y)}this.compile=function(A,k,j=null){j===null&&(j=A),G!==null&&G.renderStart(A,k,j),T=te.get(j),T.init(k),E.push(T),j.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),A!==j&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(k.layers)&&(T.pushLight(Z),Z.castShadow&&T.pushShadow(Z))}),T.setupLights(),G!==null&&G.updateLights(T.state.lightsArray),dn=this.localClippingEnabled,$t=se.init(this.clippingPlanes,dn),$t===!0&&se.setGlobalState(this.clippingPlanes,k),G!==null&&pe.render(T.state.shadowsArray,j,k);let Y=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Ae=Z.material;if(Ae)if(Array.isArray(Ae))for(let Ie=0;Ie<Ae.length;Ie++){let Te=Ae[Ie];va(Te,j,k,Z),Y.add(Te)}else va(Ae,j,k,Z),Y.add(Ae)}),T=E.pop(),G!==null&&G.renderEnd(),Y},this.compileAsync=function(A,k,j=null){let Y=this.compile(A,k,j);return new Promise(Z=>{function Ae(){if(Y.forEach(function(Ie){let De=Ge.get(Ie).currentProgram;(De===void 0||De.isReady())&&Y.delete(Ie)}),Y.size===0){Z(A);return}setTimeout(Ae,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ae():setTimeout(Ae,10)})};let ro=null;function td(A){ro&&ro(A)}function Vl(){ws.stop()}function as(){ws.start()}let ws=new Ay;ws.setAnimationLoop(td),typeof self<"u"&&ws.setContext(self),this.setAnimationLoop=function(A){ro=A,ce.setAnimationLoop(A),A===null?ws.stop():ws.start()},ce.addEventListener("sessionstart",Vl),ce.addEventListener("sessionend",as),this.render=function(A,k){if(k!==void 0&&k.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;G!==null&&G.renderStart(A,k);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=H!==null&&(re===null||j)&&H.begin(U,re);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(H===null||H.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(k),k=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(U,A,k,re),T=te.get(A,E.length),T.init(k),T.state.textureUnits=Ye.getTextureUnits(),E.push(T),Bt.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Qt.setFromArrayCamera(k):rt.setFromProjectionMatrix(Bt,Hi,k.reversedDepth),dn=this.localClippingEnabled,$t=se.init(this.clippingPlanes,dn),I=ve.get(A,x.length),I.init(),x.push(I),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let Ie=U.xr.getDepthSensingMesh();Ie!==null&&As(Ie,k,-1/0,U.sortObjects)}As(A,k,0,U.sortObjects),I.finish(),G!==null&&G.updateLights(T.state.lightsArray),U.sortObjects===!0&&I.sort(We,Ne),nn=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,nn&&F.addToRenderList(I,A),this.info.autoReset===!0&&this.info.reset(),$t===!0&&se.beginShadows();let Z=T.state.shadowsArray;if(pe.render(Z,A,k),$t===!0&&se.endShadows(),(Y&&H.hasRenderPass())===!1){let Ie=I.opaque,Te=I.transmissive;if(T.setupLights(),k.isArrayCamera){let De=k.cameras;if(Te.length>0)for(let He=0,nt=De.length;He<nt;He++){let mt=De[He];Wi(Ie,Te,A,mt)}nn&&F.render(A);for(let He=0,nt=De.length;He<nt;He++){let mt=De[He];ba(I,A,mt,mt.viewport)}}else Te.length>0&&Wi(Ie,Te,A,k),nn&&F.render(A),ba(I,A,k)}re!==null&&O===0&&(Ye.updateMultisampleRenderTarget(re),Ye.updateRenderTargetMipmap(re)),Y&&H.end(U),A.isScene===!0&&A.onAfterRender(U,A,k),Se.resetDefaultState(),J=-1,ee=null,E.pop(),E.length>0?(T=E[E.length-1],Ye.setTextureUnits(T.state.textureUnits),$t===!0&&se.setGlobalState(U.clippingPlanes,T.state.camera)):T=null,x.pop(),x.length>0?I=x[x.length-1]:I=null,G!==null&&G.renderEnd()};function As(A,k,j,Y){if(A.visible===!1)return;if(A.layers.test(k.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(k);else if(A.isLight)T.pushLight(A),A.castShadow&&T.pushShadow(A);else if(A.isSprite){let Ie=k.isArrayCamera?Qt:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){Y&&bt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Bt);let Te=ue.update(A),De=A.material;De.visible&&I.push(A,Te,De,j,bt.z,null,k)}}else if(A.isMesh||A.isLine||A.isPoints){let Ie=k.isArrayCamera?Qt:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){let Te=ue.update(A),De=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),bt.copy(A.boundingSphere.center)):(Te.boundingSphere===null&&Te.computeBoundingSphere(),bt.copy(Te.boundingSphere.center)),bt.applyMatrix4(A.matrixWorld).applyMatrix4(Bt)),Array.isArray(De)){let He=Te.groups;for(let nt=0,mt=He.length;nt<mt;nt++){let Ve=He[nt],gt=De[Ve.materialIndex];gt&&gt.visible&&I.push(A,Te,gt,j,bt.z,Ve,k)}}else De.visible&&I.push(A,Te,De,j,bt.z,null,k)}}}let Ae=A.children;for(let Ie=0,Te=Ae.length;Ie<Te;Ie++)As(Ae[Ie],k,j,Y)}function ba(A,k,j,Y){let{opaque:Z,transmissive:Ae,transparent:Ie}=A;T.setupLightsView(j),$t===!0&&se.setGlobalState(U.clippingPlanes,j),Y&&Me.viewport(ie.copy(Y)),Z.length>0&&sn(Z,k,j),Ae.length>0&&sn(Ae,k,j),Ie.length>0&&sn(Ie,k,j),Me.buffers.depth.setTest(!0),Me.buffers.depth.setMask(!0),Me.buffers.color.setMask(!0),Me.setPolygonOffset(!1)}function Wi(A,k,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(T.state.transmissionRenderTarget[Y.id]===void 0){let Ve=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");T.state.transmissionRenderTarget[Y.id]=new Di(1,1,{generateMipmaps:!0,type:Ve?os:yi,minFilter:Ys,samples:Math.max(4,lt.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ae=T.state.transmissionRenderTarget[Y.id],Ie=Y.viewport||ie;Ae.setSize(Ie.z*U.transmissionResolutionScale,Ie.w*U.transmissionResolutionScale);let Te=U.getRenderTarget(),De=U.getActiveCubeFace(),He=U.getActiveMipmapLevel();U.setRenderTarget(Ae),U.getClearColor(Q),me=U.getClearAlpha(),me<1&&U.setClearColor(16777215,.5),U.clear(),nn&&F.render(j);let nt=U.toneMapping;U.toneMapping=ys;let mt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),T.setupLightsView(Y),$t===!0&&se.setGlobalState(U.clippingPlanes,Y),sn(A,j,Y),Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let Ve=!1;for(let gt=0,tn=k.length;gt<tn;gt++){let Dt=k[gt],{object:Nt,geometry:wn,material:Be,group:pn}=Dt;if(Be.side===xi&&Nt.layers.test(Y.layers)){let xt=Be.side;Be.side=di,Be.needsUpdate=!0,ln(Nt,j,Y,wn,Be,pn),Be.side=xt,Be.needsUpdate=!0,Ve=!0}}Ve===!0&&(Ye.updateMultisampleRenderTarget(Ae),Ye.updateRenderTargetMipmap(Ae))}U.setRenderTarget(Te,De,He),U.setClearColor(Q,me),mt!==void 0&&(Y.viewport=mt),U.toneMapping=nt}function sn(A,k,j){let Y=k.isScene===!0?k.overrideMaterial:null;for(let Z=0,Ae=A.length;Z<Ae;Z++){let Ie=A[Z],{object:Te,geometry:De,group:He}=Ie,nt=Ie.material;nt.allowOverride===!0&&Y!==null&&(nt=Y),Te.layers.test(j.layers)&&ln(Te,k,j,De,nt,He)}}function ln(A,k,j,Y,Z,Ae){G!==null&&Z.isNodeMaterial&&G.setObject(A,Z),A.onBeforeRender(U,k,j,Y,Z,Ae),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(U,k,j,Y,A,Ae),Z.transparent===!0&&Z.side===xi&&Z.forceSinglePass===!1?(Z.side=di,Z.needsUpdate=!0,U.renderBufferDirect(j,k,Y,Z,A,Ae),Z.side=Rr,Z.needsUpdate=!0,U.renderBufferDirect(j,k,Y,Z,A,Ae),Z.side=xi):U.renderBufferDirect(j,k,Y,Z,A,Ae),A.onAfterRender(U,k,j,Y,Z,Ae)}function cn(A){let k=0;for(let j of A)j.texture!==null&&k++;return k}function ls(A,k,j){k.isScene!==!0&&(k=Mn);let Y=Ge.get(A),Z=T.state.lights,Ae=T.state.shadowsArray,Ie=Z.state.version,Te=ae.getParameters(A,Z.state,Ae,k,j,T.state.lightProbeGridArray),De=ae.getProgramCacheKey(Te),He=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?k.environment:null,Y.fog=k.fog;let nt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=R.get(A.envMap||Y.environment,nt),Y.envMapRotation=Y.environment!==null&&A.envMap===null?k.environmentRotation:A.envMapRotation,He===void 0&&(A.addEventListener("dispose",ht),He=new Map,Y.programs=He,Y.programVariants=new Map);let mt=He.get(De);if(mt!==void 0){if(Y.currentProgram===mt&&Y.lightsStateVersion===Ie)return Sa(A,Te),mt}else Te.uniforms=ae.getUniforms(A),G!==null&&A.isNodeMaterial&&G.build(A,j,Te),A.onBeforeCompile(Te,U),mt=ae.acquireProgram(Te,De),He.set(De,mt),Y.uniforms=Te.uniforms;let Ve=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ve.clippingPlanes=se.uniform),Sa(A,Te),Y.needsLights=js(A),Y.lightsStateVersion=Ie,Y.needsLights&&(Ve.ambientLightColor.value=Z.state.ambient,Ve.lightProbe.value=Z.state.probe,Ve.sunLights.value=Z.state.sun,Ve.sunLightShadows.value=Z.state.sunShadow,Ve.directionalLights.value=Z.state.directional,Ve.directionalLightShadows.value=Z.state.directionalShadow,Ve.spotLights.value=Z.state.spot,Ve.spotLightShadows.value=Z.state.spotShadow,Ve.rectAreaLights.value=Z.state.rectArea,Ve.ltc_1.value=Z.state.rectAreaLTC1,Ve.ltc_2.value=Z.state.rectAreaLTC2,Ve.pointLights.value=Z.state.point,Ve.pointLightShadows.value=Z.state.pointShadow,Ve.hemisphereLights.value=Z.state.hemi,Ve.sunShadowMatrix.value=Z.state.sunShadowMatrix,Ve.sunShadowCascade.value=Z.state.sunShadowCascade,Ve.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Ve.spotLightMatrix.value=Z.state.spotLightMatrix,Ve.spotLightMap.value=Z.state.spotLightMap,Ve.pointShadowMatrix.value=Z.state.pointShadowMatrix),Y.numLightProbeGrids=cn(T.state.lightProbeGridArray),Y.currentProgram=mt,Y.uniformsList=null,mt}function bi(A,k,j,Y,Z){let Ae=Ge.get(A),Ie=Ae.currentProgram.id+","+Y+","+Z,Te=Ae.programVariants.get(Ie);return Te===void 0?(Te=ls(A,k,j),Ae.programVariants.set(Ie,Te)):(Ae.currentProgram=Te,Ae.uniformsList=null,Ae.outputColorSpace=Y,Ae.toneMapping=Z),Te}function Ks(A){if(A.uniformsList===null){let k=A.currentProgram.getUniforms();A.uniformsList=ga.seqWithValue(k.seq,A.uniforms)}return A.uniformsList}function Sa(A,k){let j=Ge.get(A);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=k.vertexTangents,j.toneMapping=k.toneMapping}function Ma(A,k,j,Y,Z){k.isScene!==!0&&(k=Mn),Ye.resetTextureUnits();let Ae=k.fog,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?k.environment:null,Te=re===null?U.outputColorSpace:re.isXRRenderTarget===!0?re.texture.colorSpace:vt.workingColorSpace,De=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,He=R.get(Y.envMap||Ie,De),nt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,mt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),Ve=!!j.morphAttributes.position,gt=!!j.morphAttributes.normal,tn=!!j.morphAttributes.color,Dt=ys;Y.toneMapped&&(re===null||re.isXRRenderTarget===!0)&&(Dt=U.toneMapping);let Nt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,wn=Nt!==void 0?Nt.length:0,Be=Ge.get(Y),pn=T.state.lights;if($t===!0&&(dn===!0||A!==ee)){let Ut=A===ee&&Y.id===J;se.setState(Y,A,Ut)}let xt=!1,Ts=!1;Y.version===Be.__version?Be.needsLights&&Be.lightsStateVersion!==pn.state.version||Z.isBatchedMesh&&Be.batching===!1||!Z.isBatchedMesh&&Be.batching===!0||Z.isBatchedMesh&&Be.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Be.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Be.instancing===!1||!Z.isInstancedMesh&&Be.instancing===!0||Z.isSkinnedMesh&&Be.skinning===!1||!Z.isSkinnedMesh&&Be.skinning===!0||Z.isInstancedMesh&&Be.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Be.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Be.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Be.instancingMorph===!1&&Z.morphTexture!==null||Be.envMap!==He||Y.fog===!0&&Be.fog!==Ae||Be.numClippingPlanes!==void 0&&(Be.numClippingPlanes!==se.numPlanes||Be.numIntersection!==se.numIntersection)||Be.vertexAlphas!==nt||Be.vertexTangents!==mt||Be.morphTargets!==Ve||Be.morphNormals!==gt||Be.morphColors!==tn||Be.morphTargetsCount!==wn||Be.numLightProbeGrids!==cn(T.state.lightProbeGridArray)?xt=!0:(Be.outputColorSpace!==Te||Be.toneMapping!==Dt)&&(Ts=!0):(xt=!0,Be.__version=Y.version);let mn=Be.currentProgram;(xt===!0||Ts===!0)&&(mn=Ts===!0?bi(Y,k,Z,Te,Dt):ls(Y,k,Z),G&&Y.isNodeMaterial&&G.onUpdateProgram(Y,mn,Be));let lo=!1,cs=!1,Es=!1,ft=mn.getUniforms(),rn=Be.uniforms;if(Me.useProgram(mn.program)&&(lo=!0,cs=!0,Es=!0),Y.id!==J&&(J=Y.id,cs=!0),lo||ee!==A){Me.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",A.projectionMatrix),ft.setValue(B,"viewMatrix",A.matrixWorldInverse);let gn=ft.map.cameraPosition;gn!==void 0&&gn.setValue(B,In.setFromMatrixPosition(A.matrixWorld)),lt.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ft.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),ee!==A&&(ee=A,cs=!0,Es=!0)}if(Be.needsLights&&(pn.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",pn.state.sunShadowMap,Ye),pn.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",pn.state.directionalShadowMap,Ye),pn.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",pn.state.spotShadowMap,Ye),pn.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",pn.state.pointShadowMap,Ye)),Z.isSkinnedMesh){ft.setOptional(B,Z,"bindMatrix"),ft.setOptional(B,Z,"bindMatrixInverse");let Ut=Z.skeleton;Ut&&(Ut.boneTexture===null&&Ut.computeBoneTexture(),ft.setValue(B,"boneTexture",Ut.boneTexture,Ye))}Z.isBatchedMesh&&(ft.setOptional(B,Z,"batchingTexture"),ft.setValue(B,"batchingTexture",Z._matricesTexture,Ye),ft.setOptional(B,Z,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",Z._indirectTexture,Ye),ft.setOptional(B,Z,"batchingColorTexture"),Z._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",Z._colorsTexture,Ye));let ii=j.morphAttributes;if((ii.position!==void 0||ii.normal!==void 0||ii.color!==void 0)&&oe.update(Z,j,mn),(cs||Be.receiveShadow!==Z.receiveShadow)&&(Be.receiveShadow=Z.receiveShadow,ft.setValue(B,"receiveShadow",Z.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&k.environment!==null&&(rn.envMapIntensity.value=k.environmentIntensity),rn.dfgLUT!==void 0&&(rn.dfgLUT.value=XC()),cs){if(ft.setValue(B,"toneMappingExposure",U.toneMappingExposure),Be.needsLights&&oo(rn,Es),Ae&&Y.fog===!0&&xe.refreshFogUniforms(rn,Ae),xe.refreshMaterialUniforms(rn,Y,ye,Ee,T.state.transmissionRenderTarget[A.id]),Be.needsLights&&Be.numLightProbeGrids>0){let Ut=S,gn=0;for(let Jn of T.state.lightProbeGridArray)Jn.texture!==null&&(Ut.textures[gn]=Jn.texture,Ut.min[gn]=Jn.boundingBox.min,Ut.max[gn]=Jn.boundingBox.max,Ut.resolution[gn]=Jn.resolution,gn++);for(let Jn in Ut)Ut[Jn].length=gn;rn.probesSH.value=Ut.textures,rn.probesMin.value=Ut.min,rn.probesMax.value=Ut.max,rn.probesResolution.value=Ut.resolution}ga.upload(B,Ks(Be),rn,Ye)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(ga.upload(B,Ks(Be),rn,Ye),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ft.setValue(B,"center",Z.center),ft.setValue(B,"modelViewMatrix",Z.modelViewMatrix),ft.setValue(B,"normalMatrix",Z.normalMatrix),ft.setValue(B,"modelMatrix",Z.matrixWorld),Y.uniformsGroups!==void 0){let Ut=Y.uniformsGroups;for(let gn=0,Jn=Ut.length;gn<Jn;gn++){let Hl=Ut[gn];Xe.update(Hl,mn),Xe.bind(Hl,mn)}}return mn}function oo(A,k){A.ambientLightColor.needsUpdate=k,A.lightProbe.needsUpdate=k,A.sunLights.needsUpdate=k,A.sunLightShadows.needsUpdate=k,A.directionalLights.needsUpdate=k,A.directionalLightShadows.needsUpdate=k,A.pointLights.needsUpdate=k,A.pointLightShadows.needsUpdate=k,A.spotLights.needsUpdate=k,A.spotLightShadows.needsUpdate=k,A.rectAreaLights.needsUpdate=k,A.hemisphereLights.needsUpdate=k}function js(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return O},this.getRenderTarget=function(){return re},this.setRenderTargetTextures=function(A,k,j){let Y=Ge.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ge.get(A.texture).__webglTexture=k,Ge.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,k){let j=Ge.get(A);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(A,k=0,j=0){re=A,q=k,O=j;let Y=null,Z=!1,Ae=!1;if(A){let Te=Ge.get(A);if(Te.__useDefaultFramebuffer!==void 0){Me.bindFramebuffer(B.FRAMEBUFFER,Te.__webglFramebuffer),ie.copy(A.viewport),de.copy(A.scissor),he=A.scissorTest,Me.viewport(ie),Me.scissor(de),Me.setScissorTest(he),J=-1;return}else if(Te.__webglFramebuffer===void 0)Ye.setupRenderTarget(A);else if(Te.__hasExternalTextures)Ye.rebindTextures(A,Ge.get(A.texture).__webglTexture,Ge.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let nt=A.depthTexture;if(Te.__boundDepthTexture!==nt){if(nt!==null&&Ge.has(nt)&&(A.width!==nt.image.width||A.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ye.setupDepthRenderbuffer(A)}}let De=A.texture;(De.isData3DTexture||De.isDataArrayTexture||De.isCompressedArrayTexture)&&(Ae=!0);let He=Ge.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(He[k])?Y=He[k][j]:Y=He[k],Z=!0):A.samples>0&&Ye.useMultisampledRTT(A)===!1?Y=Ge.get(A).__webglMultisampledFramebuffer:Array.isArray(He)?Y=He[j]:Y=He,ie.copy(A.viewport),de.copy(A.scissor),he=A.scissorTest}else ie.copy(Le).multiplyScalar(ye).floor(),de.copy(at).multiplyScalar(ye).floor(),he=ut;if(j!==0&&(Y=V),Me.bindFramebuffer(B.FRAMEBUFFER,Y)&&Me.drawBuffers(A,Y),Me.viewport(ie),Me.scissor(de),Me.setScissorTest(he),Z){let Te=Ge.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+k,Te.__webglTexture,j)}else if(Ae){let Te=k;for(let De=0;De<A.textures.length;De++){let He=Ge.get(A.textures[De]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+De,He.__webglTexture,j,Te)}}else if(A!==null&&j!==0){let Te=Ge.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Te.__webglTexture,j)}J=-1};function ao(A){let k=Ge.get(A);return(k.__readFormat!==A.format||k.__readType!==A.type)&&(k.__readFormat=A.format,k.__readType=A.type,k.__formatReadable=lt.textureFormatReadable(A.format),k.__typeReadable=lt.textureTypeReadable(A.type)),k}this.readRenderTargetPixels=function(A,k,j,Y,Z,Ae,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let De=Ge.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De){Me.bindFramebuffer(B.FRAMEBUFFER,De);try{let He=A.textures[Te],nt=He.format,mt=He.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let Ve=ao(He);if(Ve.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ve.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=A.width-Y&&j>=0&&j<=A.height-Z&&B.readPixels(k,j,Y,Z,_e.convert(nt),_e.convert(mt),Ae)}finally{let He=re!==null?Ge.get(re).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,He)}}},this.readRenderTargetPixelsAsync=async function(A,k,j,Y,Z,Ae,Ie,Te=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let De=Ge.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(De=De[Ie],Array.isArray(De)&&(De=De[0])),De)if(k>=0&&k<=A.width-Y&&j>=0&&j<=A.height-Z){Me.bindFramebuffer(B.FRAMEBUFFER,De);let He=A.textures[Te],nt=He.format,mt=He.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Te);let Ve=ao(He);if(Ve.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ve.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.bufferData(B.PIXEL_PACK_BUFFER,Ae.byteLength,B.STREAM_READ),B.readPixels(k,j,Y,Z,_e.convert(nt),_e.convert(mt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let tn=re!==null?Ge.get(re).__webglFramebuffer:null;Me.bindFramebuffer(B.FRAMEBUFFER,tn);let Dt=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await Qx(B,Dt,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ae),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(gt),B.deleteSync(Dt),Ae}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,k=null,j=0){let Y=Math.pow(2,-j),Z=Math.floor(A.image.width*Y),Ae=Math.floor(A.image.height*Y),Ie=k!==null?k.x:0,Te=k!==null?k.y:0;Ye.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Ie,Te,Z,Ae),Me.unbindTexture()},this.copyTextureToTexture=function(A,k,j=null,Y=null,Z=0,Ae=0){let Ie,Te,De,He,nt,mt,Ve,gt,tn,Dt=A.isCompressedTexture?A.mipmaps[Ae]:A.image;if(j!==null)Ie=j.max.x-j.min.x,Te=j.max.y-j.min.y,De=j.isBox3?j.max.z-j.min.z:1,He=j.min.x,nt=j.min.y,mt=j.isBox3?j.min.z:0;else{let ft=Math.pow(2,-Z);Ie=Math.floor(Dt.width*ft),Te=Math.floor(Dt.height*ft),A.isDataArrayTexture?De=Dt.depth:A.isData3DTexture?De=Math.floor(Dt.depth*ft):De=1,He=0,nt=0,mt=0}Y!==null?(Ve=Y.x,gt=Y.y,tn=Y.z):(Ve=0,gt=0,tn=0);let Nt=_e.convert(k.format),wn=_e.convert(k.type),Be;k.isData3DTexture?(Ye.setTexture3D(k,0),Be=B.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(Ye.setTexture2DArray(k,0),Be=B.TEXTURE_2D_ARRAY):(Ye.setTexture2D(k,0),Be=B.TEXTURE_2D),Me.activeTexture(B.TEXTURE0),Me.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,k.flipY),Me.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),Me.pixelStorei(B.UNPACK_ALIGNMENT,k.unpackAlignment);let pn=Me.getParameter(B.UNPACK_ROW_LENGTH),xt=Me.getParameter(B.UNPACK_IMAGE_HEIGHT),Ts=Me.getParameter(B.UNPACK_SKIP_PIXELS),mn=Me.getParameter(B.UNPACK_SKIP_ROWS),lo=Me.getParameter(B.UNPACK_SKIP_IMAGES);Me.pixelStorei(B.UNPACK_ROW_LENGTH,Dt.width),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,Dt.height),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,He),Me.pixelStorei(B.UNPACK_SKIP_ROWS,nt),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,mt);let cs=A.isDataArrayTexture||A.isData3DTexture,Es=k.isDataArrayTexture||k.isData3DTexture;if(A.isDepthTexture){let ft=Ge.get(A),rn=Ge.get(k),ii=Ge.get(ft.__renderTarget),Ut=Ge.get(rn.__renderTarget);Me.bindFramebuffer(B.READ_FRAMEBUFFER,ii.__webglFramebuffer),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,Ut.__webglFramebuffer);for(let gn=0;gn<De;gn++)cs&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ge.get(A).__webglTexture,Z,mt+gn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ge.get(k).__webglTexture,Ae,tn+gn)),B.blitFramebuffer(He,nt,He+Ie,nt+Te,Ve,gt,Ve+Ie,gt+Te,B.DEPTH_BUFFER_BIT,B.NEAREST);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||Ge.has(A)){let ft=Ge.get(A),rn=Ge.get(k);Me.bindFramebuffer(B.READ_FRAMEBUFFER,N),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let ii=0;ii<De;ii++)cs?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,Z,mt+ii):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,Z),Es?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,rn.__webglTexture,Ae,tn+ii):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,rn.__webglTexture,Ae),Z!==0?B.blitFramebuffer(He,nt,He+Ie,nt+Te,Ve,gt,Ve+Ie,gt+Te,B.COLOR_BUFFER_BIT,B.NEAREST):Es?B.copyTexSubImage3D(Be,Ae,Ve,gt,tn+ii,He,nt,Ie,Te):B.copyTexSubImage2D(Be,Ae,Ve,gt,He,nt,Ie,Te);Me.bindFramebuffer(B.READ_FRAMEBUFFER,null),Me.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else Es?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Be,Ae,Ve,gt,tn,Ie,Te,De,Nt,wn,Dt.data):k.isCompressedArrayTexture?B.compressedTexSubImage3D(Be,Ae,Ve,gt,tn,Ie,Te,De,Nt,Dt.data):B.texSubImage3D(Be,Ae,Ve,gt,tn,Ie,Te,De,Nt,wn,Dt):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ae,Ve,gt,Ie,Te,Nt,wn,Dt.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ae,Ve,gt,Dt.width,Dt.height,Nt,Dt.data):B.texSubImage2D(B.TEXTURE_2D,Ae,Ve,gt,Ie,Te,Nt,wn,Dt);Me.pixelStorei(B.UNPACK_ROW_LENGTH,pn),Me.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),Me.pixelStorei(B.UNPACK_SKIP_PIXELS,Ts),Me.pixelStorei(B.UNPACK_SKIP_ROWS,mn),Me.pixelStorei(B.UNPACK_SKIP_IMAGES,lo),Ae===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&B.generateMipmap(Be),Me.unbindTexture()},this.initRenderTarget=function(A){Ge.get(A).__webglFramebuffer===void 0&&Ye.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?Ye.setTextureCube(A,0):A.isData3DTexture?Ye.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?Ye.setTexture2DArray(A,0):Ye.setTexture2D(A,0),Me.unbindTexture()},this.resetState=function(){q=0,O=0,re=null,Me.reset(),Se.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Hi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var $C=.28;function to(n){let e=new ml({flatShading:!0,side:xi});return e.color.setRGB(n[0]/255,n[1]/255,n[2]/255,Bn),e}function qC(n,e,t){n.onBeforeCompile=i=>{i.uniforms.heatTable={value:e},i.uniforms.showsHeat=t,i.vertexShader=i.vertexShader.replace("#include <common>",`#include <common>
attribute float heat;
varying float vHeat;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vHeat = heat;`),i.fragmentShader=i.fragmentShader.replace("#include <common>",`#include <common>
uniform sampler2D heatTable;
uniform bool showsHeat;
varying float vHeat;`).replace("#include <color_fragment>",`#include <color_fragment>
                if (showsHeat) {
                    float at = (floor(vHeat * 255.0 + 0.5) + 0.5) / 256.0;
                    diffuseColor.rgb = texture2D(heatTable, vec2(at, 0.5)).rgb;
                }`)}}var kl=class{constructor(e,t){this.mesh=e;this.corners=F_(e),this.radius=Math.hypot(...e.max.map((o,a)=>o-e.min[a]))/2,this.geometry.setAttribute("position",new bn(this.corners,3)),this.setHeat(new Uint8Array(this.corners.length/3)),this.geometry.boundingSphere=new Vn(new z,this.radius),this.table=new aa(I_(t),256,1,Ui),this.table.colorSpace=Bn,this.table.minFilter=hn,this.table.magFilter=hn,this.table.needsUpdate=!0;let i=to(t),s=to(t),r=to(t);for(let o of[i,s,r])o.polygonOffset=!0,o.polygonOffsetFactor=1,o.polygonOffsetUnits=1,qC(o,this.table,this.showsHeat);s.colorWrite=!1,r.polygonOffset=!1,r.transparent=!0,r.opacity=$C,r.depthWrite=!1,r.depthFunc=yr,this.materials=[i,s,r],this.solid=this.make(i,0),this.ghost.add(this.make(s,1),this.make(r,2))}mesh;corners;solid;ghost=new gi;radius;geometry=new Sn;materials;showsHeat={value:!1};table;make(e,t){let i=new Hn(this.geometry,e);return i.matrixAutoUpdate=!1,i.renderOrder=t,i}get triangles(){return this.corners.length/9}setHeat(e){this.geometry.setAttribute("heat",new bn(e,1,!0))}showHeat(e){this.showsHeat.value=e}showAs(e){this.solid.visible=e==="solid",this.ghost.visible=e==="ghost"}clip(e){for(let t of this.materials)t.clippingPlanes=e}place(e,t){let i=Io(e,this.mesh.centre),s=new St().set(e[0],e[1],e[2],i[0]-t[0],e[4],e[5],e[6],i[1]-t[1],e[8],e[9],e[10],i[2]-t[2],0,0,0,1);for(let r of[this.solid,...this.ghost.children])r.matrix.copy(s),r.matrixWorldNeedsUpdate=!0;return s}boxCorners(e){let t=this.mesh.max.map((s,r)=>s-this.mesh.centre[r]),i=[-1,1];return i.flatMap(s=>i.flatMap(r=>i.map(o=>new z(s*t[0],r*t[1],o*t[2]).applyMatrix4(e).toArray())))}dispose(){this.geometry.dispose(),this.table.dispose(),this.materials.forEach(e=>e.dispose())}};Pe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ke},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};fi.line={uniforms:Nl.merge([Pe.common,Pe.fog,Pe.line]),vertexShader:`
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
		`};var no=class extends Gi{constructor(e){super({type:"LineMaterial",uniforms:Nl.clone(fi.line.uniforms),vertexShader:fi.line.vertexShader,fragmentShader:fi.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Oy=new ei,zh=new z,xa=class extends Sl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new kn(e,3)),this.setAttribute("uv",new kn(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new Tr(t,6,1);return this.setAttribute("instanceStart",new is(i,3,0)),this.setAttribute("instanceEnd",new is(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new Tr(t,6,1);return this.setAttribute("instanceColorStart",new is(i,3,0)),this.setAttribute("instanceColorEnd",new is(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new pl(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ei);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Oy.setFromBufferAttribute(t),this.boundingBox.union(Oy))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vn),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)zh.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(zh)),zh.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(zh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var jp=new Lt,Fy=new z,By=new z,$n=new Lt,qn=new Lt,bs=new Lt,Qp=new z,em=new St,Yn=new Ml,ky=new z,Vh=new ei,Hh=new Vn,Ss=new Lt,Ms,io;function zy(n,e,t){return Ss.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),Ss.multiplyScalar(1/Ss.w),Ss.x=io/t.width,Ss.y=io/t.height,Ss.applyMatrix4(n.projectionMatrixInverse),Ss.multiplyScalar(1/Ss.w),Math.abs(Math.max(Ss.x,Ss.y))}function YC(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Yn.start.fromBufferAttribute(s,a),Yn.end.fromBufferAttribute(r,a),Yn.applyMatrix4(t);let c=new z,u=new z;Ms.distanceSqToSegment(Yn.start,Yn.end,u,c),u.distanceTo(c)<io*.5&&e.push({point:u,pointOnLine:c,distance:Ms.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function JC(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),f=-e.near;Ms.at(1,bs),bs.w=1,bs.applyMatrix4(e.matrixWorldInverse),bs.applyMatrix4(i),bs.multiplyScalar(1/bs.w),bs.x*=r.x/2,bs.y*=r.y/2,bs.z=0,Qp.copy(bs),em.multiplyMatrices(e.matrixWorldInverse,o);for(let h=0,d=u;h<d;h++){if($n.fromBufferAttribute(l,h),qn.fromBufferAttribute(c,h),$n.w=1,qn.w=1,$n.applyMatrix4(em),qn.applyMatrix4(em),$n.z>f&&qn.z>f)continue;if($n.z>f){let C=$n.z-qn.z,S=($n.z-f)/C;$n.lerp(qn,S)}else if(qn.z>f){let C=qn.z-$n.z,S=(qn.z-f)/C;qn.lerp($n,S)}$n.applyMatrix4(i),qn.applyMatrix4(i),$n.multiplyScalar(1/$n.w),qn.multiplyScalar(1/qn.w),$n.x*=r.x/2,$n.y*=r.y/2,qn.x*=r.x/2,qn.y*=r.y/2,Yn.start.copy($n),Yn.start.z=0,Yn.end.copy(qn),Yn.end.z=0;let b=Yn.closestPointToPointParameter(Qp,!0);Yn.at(b,ky);let m=Dl.lerp($n.z,qn.z,b),g=m>=-1&&m<=1,v=Qp.distanceTo(ky)<io*.5;if(g&&v){Yn.start.fromBufferAttribute(l,h),Yn.end.fromBufferAttribute(c,h),Yn.start.applyMatrix4(o),Yn.end.applyMatrix4(o);let C=new z,S=new z;Ms.distanceSqToSegment(Yn.start,Yn.end,S,C),t.push({point:S,pointOnLine:C,distance:Ms.origin.distanceTo(S),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var Gh=class extends Hn{constructor(e=new xa,t=new no({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Fy.fromBufferAttribute(t,o),By.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Fy.distanceTo(By);let r=new Tr(s,2,1);return e.setAttribute("instanceDistanceStart",new is(r,1,0)),e.setAttribute("instanceDistanceEnd",new is(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Ms=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;io=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Hh.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=io*.5;else{let f=Math.max(s.near,Hh.distanceToPoint(Ms.origin));c=zy(s,f,l.resolution)}if(Hh.radius+=c,Ms.intersectsSphere(Hh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Vh.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=io*.5;else{let f=Math.max(s.near,Vh.distanceToPoint(Ms.origin));u=zy(s,f,l.resolution)}Vh.expandByScalar(u),Ms.intersectsBox(Vh)!==!1&&(i?YC(this,t):JC(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(jp),this.material.uniforms.resolution.value.set(jp.z,jp.w))}};var ZC=3,so=4;function Vy(n){return n===so?0:n}function Hy(n,e){let t=[new Map,new Map];for(let i=0;i+2<n.length;i+=3)e(n[i],n[i+1])&&t.forEach((s,r)=>{let o=n[i+r],a=s.get(o);(a===void 0||Vy(n[i+2])>Vy(a))&&s.set(o,n[i+2])});return t}var KC=["near","touch","proper"];function jC(n){return n===ZC?"proper":n===so?"near":"touch"}function QC(n,e){return[...n].flatMap(([t,i])=>jC(i)===e?[t]:[])}function eR(n,e){let t=new Float32Array(9*e.length);return e.forEach((i,s)=>t.set(n.subarray(9*i,9*i+9),9*s)),t}function tm(n){let e=new Float32Array(2*n.length);for(let t=0;t<n.length;t+=9){let[i,s,r]=[0,3,6].map(o=>n.subarray(t+o,t+o+3));[i,s,s,r,r,i].forEach((o,a)=>e.set(o,2*t+3*a))}return e}function tR(n,e,t){let i={segments:[],points:[],gaps:[]};for(let s=0;s<n.length;){let r=n[s],o=s,a=[];for(;o<n.length&&n[o]===r;o+=4)a.push(e([n[o+1],n[o+2],n[o+3]]));s=o;let l=t(r);if(l===null)continue;if(l===so){i.gaps.push(...a.flat());continue}a.length===1&&i.points.push(...a[0]);let c=a.length>2?a.length:a.length-1;for(let u=0;u<c;++u)i.segments.push(...a[u],...a[(u+1)%a.length])}return i}var Wh=class{group=new gi;lines=new gi;red;yellow;orange;outline=new Sr({color:5915904});segment=new no({color:0,linewidth:2.5});gap=new no({color:11030016,linewidth:3.5});dot=new la({color:0,size:7,sizeAttenuation:!1});constructor(){this.red=to(Ki(2)),this.yellow=to(Ki(1)),this.orange=to(Ki(7)),this.red.emissive.copy(this.red.color).multiplyScalar(.45),this.yellow.emissive.copy(this.yellow.color).multiplyScalar(.35),this.orange.emissive.copy(this.orange.color).multiplyScalar(.35),this.group.add(this.lines)}get materials(){return[this.red,this.yellow,this.orange,this.outline,this.segment,this.gap,this.dot]}clear(){for(let e of[...this.group.children,...this.lines.children])e!==this.lines&&(e.geometry.dispose(),e.removeFromParent())}addBody(e,t,i){let s={near:this.orange,touch:this.yellow,proper:this.red};for(let r of KC){let o=eR(e,QC(t,r));if(o.length===0)continue;let a=new Sn().setAttribute("position",new bn(o,3));if(this.addPlaced(new Hn(a,s[r]),i),r!=="proper"){let l=new Sn().setAttribute("position",new bn(tm(o),3));this.addPlaced(new Jr(l,this.outline),i)}}}addPlaced(e,t){e.matrixAutoUpdate=!1,e.matrix.copy(t),e.frustumCulled=!1,this.group.add(e)}show(e,t,i){this.clear(),e.forEach((s,r)=>this.addBody(s,t[r],i[r]))}addLines(e,t){if(e.length===0)return;let i=new xa().setPositions(new Float32Array(e)),s=new Gh(i,t);s.frustumCulled=!1,s.renderOrder=4,this.lines.add(s)}addPoints(e,t,i,s){let o=tR(e,a=>Io(t,a).map((l,c)=>l-i[c]),s);if(this.addLines(o.segments,this.segment),this.addLines(o.gaps,this.gap),o.points.length>0){let a=new bn(new Float32Array(o.points),3),l=new cl(new Sn().setAttribute("position",a),this.dot);l.frustumCulled=!1,l.renderOrder=5,this.lines.add(l)}return o.gaps.length/6}clip(e){for(let t of this.materials)t.clippingPlanes=e}dispose(){this.clear(),this.materials.forEach(e=>e.dispose())}};function Gy(n,{origin:[e,t,i],direction:[s,r,o]},a){let l=null,c=1/0;for(let u=0;u<n.length;u+=9){let f=n[u],h=n[u+1],d=n[u+2],p=n[u+3]-f,b=n[u+4]-h,m=n[u+5]-d,g=n[u+6]-f,v=n[u+7]-h,C=n[u+8]-d,S=r*C-o*v,I=o*g-s*C,T=s*v-r*g,x=p*S+b*I+m*T;if(x===0)continue;let E=e-f,H=t-h,U=i-d,L=(E*S+H*I+U*T)/x;if(!(L>=0&&L<=1))continue;let G=H*m-U*b,V=U*p-E*m,N=E*b-H*p,W=(s*G+r*V+o*N)/x;if(!(W>=0&&L+W<=1))continue;let q=(g*G+v*V+C*N)/x;q>0&&q<c&&!a(q)&&(c=q,l={triangle:u/9,distance:q})}return l}var Xh=class{group=new gi;face=new oa({color:2068479,side:xi,transparent:!0,opacity:.55});edge=new Sr({color:675742});clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){if(this.clear(),!e||!t||9*t.triangle>=e.length)return;let s=e.slice(9*t.triangle,9*t.triangle+9),r=a=>new Sn().setAttribute("position",new bn(a,3)),o=[new Hn(r(s),this.face),new Jr(r(tm(s)),this.edge)];for(let a of o)a.matrixAutoUpdate=!1,a.matrix.copy(i[t.body]),a.frustumCulled=!1,this.group.add(a)}dispose(){this.clear(),this.face.dispose(),this.edge.dispose()}};var Wy={type:"change"},im={type:"start"},$y={type:"end"},$h=new vr,Xy=new ci,nR=Math.cos(70*Dl.DEG2RAD),Pn=new z,vi=2*Math.PI,Ct={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},nm=1e-6,qh=class extends wl{constructor(e,t=null){super(e,t),this.state=Ct.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Er.ROTATE,MIDDLE:Er.DOLLY,RIGHT:Er.PAN},this.touches={ONE:Cr.ROTATE,TWO:Cr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Li,this._lastTargetPosition=new z,this._quat=new Li().setFromUnitVectors(e.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ha,this._sphericalDelta=new ha,this._scale=1,this._panOffset=new z,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new z,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=sR.bind(this),this._onPointerDown=iR.bind(this),this._onPointerUp=rR.bind(this),this._onContextMenu=dR.bind(this),this._onMouseWheel=lR.bind(this),this._onKeyDown=cR.bind(this),this._onTouchStart=uR.bind(this),this._onTouchMove=hR.bind(this),this._onMouseDown=oR.bind(this),this._onMouseMove=aR.bind(this),this._interceptControlDown=fR.bind(this),this._interceptControlUp=pR.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ct.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(Wy),this.update(),this.state=Ct.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Pn.copy(t).sub(this.target),Pn.applyQuaternion(this._quat),this._spherical.setFromVector3(Pn),this.autoRotate&&this.state===Ct.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=vi:i>Math.PI&&(i-=vi),s<-Math.PI?s+=vi:s>Math.PI&&(s-=vi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Pn.setFromSpherical(this._spherical),Pn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Pn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Pn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Pn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):($h.origin.copy(this.object.position),$h.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot($h.direction))<nR?this.object.lookAt(this.target):(Xy.setFromNormalAndCoplanarPoint(this.object.up,this.target),$h.intersectPlane(Xy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>nm||8*(1-this._lastQuaternion.dot(this.object.quaternion))>nm||this._lastTargetPosition.distanceToSquared(this.target)>nm?(this.dispatchEvent(Wy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?vi/60*this.autoRotateSpeed*e:vi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Pn.setFromMatrixColumn(t,0),Pn.multiplyScalar(-e),this._panOffset.add(Pn)}_panUp(e,t){this.screenSpacePanning===!0?Pn.setFromMatrixColumn(t,1):(Pn.setFromMatrixColumn(t,0),Pn.crossVectors(this.object.up,Pn)),Pn.multiplyScalar(e),this._panOffset.add(Pn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Pn.copy(s).sub(this.target);let r=Pn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(vi*this._rotateDelta.x/t.clientHeight),this._rotateUp(vi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-vi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(vi*this._rotateDelta.x/t.clientHeight),this._rotateUp(vi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function iR(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function sR(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function rR(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent($y),this.state=Ct.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function oR(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Er.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ct.DOLLY;break;case Er.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}break;case Er.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ct.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ct.PAN}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(im)}function aR(n){switch(this.state){case Ct.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ct.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ct.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function lR(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ct.NONE||(n.preventDefault(),this.dispatchEvent(im),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent($y))}function cR(n){this.enabled!==!1&&this._handleKeyDown(n)}function uR(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Cr.ROTATE:if(this.enableRotate===!1){this.state=Ct.NONE;break}this._handleTouchStartRotate(n),this.state=Ct.TOUCH_ROTATE;break;case Cr.PAN:if(this.enablePan===!1){this.state=Ct.NONE;break}this._handleTouchStartPan(n),this.state=Ct.TOUCH_PAN;break;default:this.state=Ct.NONE}break;case 2:switch(this.touches.TWO){case Cr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ct.TOUCH_DOLLY_PAN;break;case Cr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ct.TOUCH_DOLLY_ROTATE;break;default:this.state=Ct.NONE}break;default:this.state=Ct.NONE}this.state!==Ct.NONE&&this.dispatchEvent(im)}function hR(n){switch(this._trackPointer(n),this.state){case Ct.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ct.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ct.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ct.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ct.NONE}}function dR(n){this.enabled!==!1&&n.preventDefault()}function fR(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function pR(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var mR=1.08,qy=new z(.75,-1,.6).normalize();function gR(){let n=new ol;return n.add(new xl(16777215,10133670,1.9)),n}var Yh=class{constructor(e,t,i){this.canvas=e;this.moved=t;this.drawn=i;this.renderer=new Fh({canvas:e,antialias:!0}),this.renderer.outputColorSpace=Bn,this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.camera.up.set(0,0,1),this.controls=new qh(this.camera,e),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.addEventListener("change",this.change),e.addEventListener("webglcontextrestored",this.draw),this.watcher=new ResizeObserver(()=>this.resize()),this.watcher.observe(e),this.resize()}canvas;moved;drawn;frames=0;renderer;camera=new ui(35,1,.01,1e3);controls;lamp=new bl(16777215,2.3);layers=[];watcher;isWaiting=!1;isPlacing=!1;radius=1;change=()=>{this.draw(),this.isPlacing||this.moved()};draw=()=>{this.isWaiting||(this.isWaiting=!0,requestAnimationFrame(()=>{this.isWaiting=!1,this.render(),this.drawn()}))};resize(){let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];e>0&&t>0&&(this.renderer.setPixelRatio(Math.min(2,devicePixelRatio)),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.draw())}setBackground(e){this.renderer.setClearColor(new dt(e)),this.draw()}setLayers(e){this.layers=e.map(({objects:t,forgetsDepth:i})=>{let s=gR();return s.add(...t),{scene:s,forgetsDepth:i}}),this.draw()}render(){let e=this.camera.position.distanceTo(this.controls.target),t=this.camera.position.length()+this.radius;this.camera.near=Math.max(e/500,(t-2*this.radius)/2,t/1e5),this.camera.near=Math.min(this.camera.near,e/2),this.camera.far=2*t,this.camera.updateProjectionMatrix(),this.lamp.position.copy(this.camera.position),this.lamp.target.position.copy(this.controls.target),this.renderer.clear();for(let{scene:i,forgetsDepth:s}of this.layers)s&&this.renderer.clearDepth(),i.add(this.lamp,this.lamp.target),this.renderer.render(i,this.camera);this.frames+=1}fit(e,t,i){let s=new z(...e),r=i?qy.clone():this.camera.position.clone().sub(this.controls.target).normalize(),o=new z().crossVectors(this.camera.up,r).normalize(),a=new z().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360),c=l*this.camera.aspect,u=1e-9;for(let f of t){let h=new z(...f).sub(s),d=Math.max(Math.abs(h.dot(o))/c,Math.abs(h.dot(a))/l);u=Math.max(u,d+h.dot(r))}this.look(s.clone().addScaledVector(r,mR*u),s)}get isAtStart(){return this.camera.position.clone().sub(this.controls.target).normalize().distanceTo(qy)<1e-6}look(e,t){this.isPlacing=!0,this.controls.target.copy(t),this.camera.position.copy(e),this.controls.update(),this.isPlacing=!1,this.draw()}turn(e,t){let i=this.controls.target,s=this.camera.position.clone().sub(i),r=s.length(),o=Math.atan2(s.y,s.x)+e,a=Math.min(Math.PI-.01,Math.max(.01,Math.acos(s.z/r)-t)),l=r*Math.sin(a);s.set(l*Math.cos(o),l*Math.sin(o),r*Math.cos(a)),this.look(s.add(i),i.clone()),this.moved()}approach(e){let t=this.controls.target,i=this.camera.position.clone().sub(t).multiplyScalar(e);this.look(i.add(t),t.clone()),this.moved()}move(e,t){let i=this.controls.target,s=this.camera.position.distanceTo(i);this.camera.updateMatrix();let r=new z().addScaledVector(new z().setFromMatrixColumn(this.camera.matrix,0),e*s).addScaledVector(new z().setFromMatrixColumn(this.camera.matrix,1),t*s);this.look(this.camera.position.clone().add(r),i.clone().add(r)),this.moved()}setRadius(e){this.radius=e}get view(){return[...this.camera.position.toArray(),...this.controls.target.toArray()]}set view(e){this.look(new z().fromArray(e,0),new z().fromArray(e,3))}rayAt(e,t){let i=new Ke(2*e/this.canvas.clientWidth-1,1-2*t/this.canvas.clientHeight),s=this.camera;s.updateMatrixWorld();let o=new z(i.x,i.y,.5).unproject(s).sub(this.camera.position).normalize();return{origin:this.camera.position.toArray(),direction:o.toArray()}}pixelOf(e){this.camera.updateMatrixWorld();let t=new z(...e).project(this.camera);return[(t.x+1)/2*this.canvas.clientWidth,(1-t.y)/2*this.canvas.clientHeight]}picture(){return this.render(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}async save(e){let t=await this.picture();if(t){let i=document.createElement("a");i.href=URL.createObjectURL(t),i.download=`${e}.png`.replaceAll(/[^\w.-]+/g,"_"),i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e3)}}dispose(){this.watcher.disconnect(),this.controls.dispose(),this.canvas.removeEventListener("webglcontextrestored",this.draw),this.renderer.dispose(),this.renderer.forceContextLoss()}};function Yy(n,e){let t=new z(n==="x"?-1:0,n==="y"?-1:0,n==="z"?-1:0);return new ci(t,e)}var sm={mode:"contacts",ghost:"b",throughWalls:!0,lines:!0,clip:null,camera:null,partA:"",partB:"",pick:null,seek:"contact"};function _R(n,e){let t=(n??"").split(",").map(Number);return t.length===e&&t.every(Number.isFinite)&&n?t:null}function xR(n){let e=/^([xyz]):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(n??"");return e&&Number.isFinite(Number(e[2]))?{axis:e[1],at:Number(e[2])}:null}function yR(n){let e=/^([ab]):(\d+)$/.exec(n??"");return e?{body:e[1]==="a"?0:1,triangle:Number(e[2])}:null}function rm(n,e){let t=["",""];for(let i of[n.get("part"),n.get("with")])if(i){let{body:s,part:r}=K0(i,{...e,hasA:o=>t[0]===""&&e.hasA(o)});t[s]=r}return t}function Zy(n,e){return Object.entries(n).every(([t,i])=>t==="camera"||i===e[t])}function om(n,e){let t=n.get("ghost"),i=n.get("seek"),[s,r]=rm(n,e);return{mode:n.get("mode")==="heat"?"heat":"contacts",ghost:t==="a"||t==="none"?t:"b",throughWalls:n.get("walls")!=="0",lines:n.get("lines")!=="0",clip:xR(n.get("clip")),camera:_R(n.get("cam"),6),partA:s,partB:r,pick:yR(n.get("pick")),seek:i==="near"||i==="either"?i:"contact"}}function Jy(n){return String(Number(n.toPrecision(6)))}function Ky(n,e){let t={};return n.mode!==sm.mode&&(t.mode=n.mode),n.camera&&(t.cam=n.camera.map(Jy).join(",")),n.ghost!==sm.ghost&&(t.ghost=n.ghost),n.throughWalls||(t.walls="0"),n.lines||(t.lines="0"),n.partA&&(t.part=Po(0,n.partA,e)),n.partB&&(t[n.partA?"with":"part"]=Po(1,n.partB,e)),n.clip&&(t.clip=`${n.clip.axis}:${Jy(n.clip.at)}`),n.pick&&(t.pick=`${n.pick.body===0?"a":"b"}:${n.pick.triangle}`),n.seek!==sm.seek&&(t.seek=n.seek),t}var vR=[186,190,196],bR=[100,138,186],SR=[1,0,0,0,0,1,0,0,0,0,1,0],Jh=class{constructor(e,{meshes:t,parts:i},s,r){this.canvas=e;this.stage=new Yh(e,s,r),this.parts=i,this.bodies=[new kl(t[0],vR),new kl(t[1],bR)],this.origin=t[0].centre,this.refreshTheme()}canvas;stage;bodies;gaps=0;contactsView=new Wh;mark=new Xh;origin;parts;matrices=[new St,new St];highlights=[new Map,new Map];contacts=null;state=null;fitted=null;freshAt=-1;refreshTheme(){this.stage.setBackground(qi("--stage",this.canvas))}show(e,t){this.contacts=e,this.matrices=[this.bodies[0].place(SR,this.origin),this.bodies[1].place(Pc(e.scenario),this.origin)],this.stage.setRadius(this.centreOfB().length()+this.bodies[1].radius+this.bodies[0].radius),this.refreshContacts(t),this.state=t,this.applyState(t),!t.camera&&!this.isInView()&&this.fit(this.fitted===null)}centreOfB(){return new z().setFromMatrixPosition(this.matrices[1])}isShown(e,t,i){return this.parts[0].isOf(t,e.partA)&&this.parts[1].isOf(i,e.partB)}refreshContacts(e){if(!this.contacts)return;let{pairs:t,points:i,scenario:s}=this.contacts,r=(a,l)=>this.isShown(e,a,l);this.highlights=Hy(t,r);let o=[this.bodies[0].corners,this.bodies[1].corners];this.contactsView.show(o,this.highlights,this.matrices),this.gaps=this.contactsView.addPoints(i,Lo(s.pose_a),this.origin,a=>r(t[3*a],t[3*a+1])?t[3*a+2]:null)}setState(e){let t=this.state;this.state=e,!(t&&Zy(t,e))&&(t&&(t.partA!==e.partA||t.partB!==e.partB)&&this.refreshContacts(e),this.applyState(e))}applyState(e){let[t,i]=this.bodies;t.showAs(e.ghost==="a"?"ghost":"solid"),i.showAs(e.ghost==="b"?"ghost":"solid"),this.bodies.forEach(o=>o.showHeat(e.mode==="heat"));let s=e.clip?"xyz".indexOf(e.clip.axis):0,r=e.clip?[Yy(e.clip.axis,e.clip.at-this.origin[s])]:[];this.bodies.forEach(o=>o.clip(r)),this.contactsView.clip(r),this.contactsView.group.visible=e.mode==="contacts",this.contactsView.lines.visible=e.lines,this.mark.show(e.pick&&this.bodies[e.pick.body].corners,e.pick,this.matrices),this.arrange(e)}isShowing(e){return this.state===e}arrange(e){let[t,i]=this.bodies,s={objects:[t.solid,i.solid],forgetsDepth:!1},r={objects:[this.contactsView.group],forgetsDepth:e.throughWalls},o={objects:[t.ghost,i.ghost],forgetsDepth:!1},a={objects:[this.mark.group],forgetsDepth:!0};this.stage.setLayers(e.throughWalls?[s,o,r,a]:[s,r,o,a])}setHeat(e,t){e.forEach((i,s)=>this.bodies[s].setHeat(D_(i,t))),this.stage.draw()}ballAround(){return new Vn(new z,this.bodies[0].radius).union(new Vn(this.centreOfB(),this.bodies[1].radius))}isInView(){let e=this.ballAround(),t=this.fitted;return t!==null&&t.center.distanceTo(e.center)+e.radius<=t.radius*1.001}fit(e){this.fitted=this.ballAround();let t=this.bodies.flatMap((s,r)=>s.boxCorners(this.matrices[r])),i=new ei().setFromPoints(t.map(s=>new z(...s)));this.stage.fit(i.getCenter(new z).toArray(),t,e),this.freshAt=this.stage.isAtStart?this.contacts?.scenario.index??-1:-1}goToContact(){let e=this.bodies[0].corners,t=new z;for(let l of this.highlights[0].keys())t.add(this.middleOf(e,l));let i=this.highlights[0].size;if(i===0){this.fit(!1);return}t.divideScalar(i);let s=0;for(let l of this.highlights[0].keys())s=Math.max(s,this.middleOf(e,l).distanceTo(t));let r=Math.min(this.bodies[0].radius,this.bodies[1].radius)/12,o=new Vn(t,Math.max(s,r)).getBoundingBox(new ei),a=[o.min,o.max].flatMap(({x:l,z:c})=>[o.min,o.max].map(({y:u})=>[l,u,c]));this.stage.fit(t.toArray(),a,!1)}middleOf(e,t){let[i,s,r]=[0,3,6].map(o=>new z().fromArray(e,9*t+o));return i.add(s).add(r).divideScalar(3)}get view(){return this.stage.view.map((e,t)=>e+this.origin[t%3])}get ownView(){return this.contacts?.scenario.index===this.freshAt?null:this.view}set view(e){this.stage.view=e.map((t,i)=>t-this.origin[i%3])}pickMiddle(e){return this.pickAt(this.canvas.clientWidth/2,this.canvas.clientHeight/2,e)}pickAt(e,t,i){let s=this.stage.rayAt(e,t),r=[0,1].filter(l=>this.bodies[l].ghost.visible),o=[0,1].filter(l=>this.bodies[l].solid.visible);return i?this.pickAmong(s,r)??this.pickAmong(s,o):(this.state?.throughWalls&&this.state.mode==="contacts"?this.pickAmong(s,[0,1],!0):null)??this.pickAmong(s,o)??this.pickAmong(s,r)}pickAmong(e,t,i=!1){let s=1/0,r=null;for(let o of t){let a=i?[...this.highlights[o].keys()]:null,l=this.hit(e,o,a);l&&l.distance<s&&(s=l.distance,r={body:o,triangle:a?a[l.triangle]:l.triangle})}return r}hit(e,t,i){let s=this.matrices[t].clone().invert(),r=new z(...e.origin).applyMatrix4(s),o=new z(...e.direction).transformDirection(s),a=this.bodies[t].corners;if(i){let f=new Float32Array(9*i.length);i.forEach((h,d)=>f.set(a.subarray(9*h,9*h+9),9*d)),a=f}let l=this.state?.clip,c=l?"xyz".indexOf(l.axis):0,u=l?l.at-this.origin[c]:1/0;return Gy(a,{origin:r.toArray(),direction:o.toArray()},f=>e.origin[c]+f*e.direction[c]>u)}get highlighted(){return this.highlights.map(e=>[...e.keys()].sort((t,i)=>t-i))}pixelOf(e){return this.stage.pixelOf(e.map((t,i)=>t-this.origin[i]))}pixelOfWorld(e){let t=this.contacts?.scenario;return this.pixelOf(t?Io(Lo(t.pose_a),e):e)}dispose(){this.bodies.forEach(e=>e.dispose()),this.contactsView.dispose(),this.mark.dispose(),this.stage.dispose()}};function ya(n){return n.bodies.reduce((e,t)=>e+t.triangles,0)}function jy(n){let[e,t]=Qe({value:null,error:""});return $e(()=>{let i=!0;return n&&ya(n)<=Wa&&B_(n).then(s=>i&&t({value:s,error:""}),s=>i&&t({value:null,error:Kn(s)})),()=>{i=!1}},[n?.job]),e}function Qy(n,e,t){let[i,s]=Qe({value:null,error:""}),r=Tt(!1);return $e(()=>{n&&e&&t&&!r.current&&(r.current=!0,k_(n,e).then(o=>s({value:o,error:o?"":"this job has no heat map"}),o=>s({value:null,error:Kn(o)})))},[n,e,t]),i}function ev(n,e){let[t,i]=Qe(null),[s,r]=Qe({scenario:-1,error:""}),o=Tt(null);return $e(()=>{if(n)return o.current=new kc(n.job,i,(a,l)=>r({scenario:a,error:Kn(l)})),()=>o.current?.close()},[n?.job]),$e(()=>o.current?.want(e),[n?.job,e]),{contacts:t,error:s.scenario===e?s.error:""}}function tv(n,e,t,i,s,r){let[o,a]=Qe(null),[l,c]=Qe(""),u=Tt(0),f=Tt(-1),h=Tt(-1),d=Tt(r);return d.current=r,$e(()=>{if(!n.current||!e)return;let p=performance.now(),b;try{b=new Jh(n.current,e,()=>d.current(b.view),()=>{f.current=h.current,u.current===0&&h.current>=0&&(u.current=performance.now()-p)})}catch(g){c(`this browser draws no 3D (WebGL 2): ${Kn(g)}. All else on this page works.`);return}a(b);let m=lc(()=>b.refreshTheme());return()=>{m(),b.dispose()}},[e]),$e(()=>{o&&t&&(o.show(t,i),h.current=t.scenario.index)},[o,t]),$e(()=>o?.setState(i),[o,i]),$e(()=>{o&&s&&o.setHeat(s.counts,s.most)},[o,s]),{viewer:o,error:l,firstFrame:u,drawn:f}}var MR=4;function nv({job:n,scenario:e,contacts:t,canvas:i,viewer:s,waits:r,root:o,pick:a}){let l=Tt([0,0]),c=f=>{let h=Math.hypot(f.clientX-l.current[0],f.clientY-l.current[1]);s&&h<MR&&a(s.pickAt(f.offsetX,f.offsetY,f.shiftKey))};return y("div",{class:"stage",onWheelCapture:f=>{o&&o.getRootNode().activeElement!==i.current&&f.stopPropagation()},children:[y("canvas",{ref:i,tabIndex:0,role:"img","aria-label":`scenario ${e}: ${t?.scenario.class??""}, ${t?.scenario.count??0} pairs${t?.scenario.near_count?`, ${t.scenario.near_count} near`:""}`,onKeyDown:f=>{f.key==="Enter"&&a(s?.pickMiddle(f.shiftKey)??null)},onPointerDown:f=>{l.current=[f.clientX,f.clientY]},onClick:c}),y("span",{class:"cross-hair","aria-hidden":"true"}),r&&y("p",{class:"wait over",children:["reading ",Fe(ya(n))," triangles…"]}),y("div",{class:"corner",children:[y("span",{class:"swatch a"})," A ",y(Ft,{text:ar(n.bodies[0].file)})," ",y("span",{class:"swatch b"})," B"," ",y(Ft,{text:ar(n.bodies[1].file)}),y("span",{class:"note",children:"drawn in single precision"})]})]})}var am=100;function wR(n,e){let t=new Map;for(let i=0;i+2<n.length;i+=3){let[s,r]=[0,1].map(c=>e[c].nameOf(n[i+c])),o=`${s.length}:${s}${r}`,a=t.get(o),l=n[i+2]===so?1:0;a?(a.count+=1,a.near+=l):t.set(o,{a:s,b:r,count:1,near:l})}return[...t.values()].sort((i,s)=>s.count-i.count)}function sv(n){let{state:e}=n,t=Ht(()=>wR(n.contacts.pairs,n.model.parts),[n.contacts,n.model]);if(t.length===0&&!e.partA&&!e.partB)return null;let i=t.some(r=>r.near>0)?"parts in contact or near here":"parts in contact here",s=r=>e.partA===r.a&&e.partB===r.b;return y("section",{"aria-label":i,children:[y("h2",{children:i}),y("ul",{class:"pairs",children:t.slice(0,am).map(r=>y("li",{children:y("button",{type:"button","aria-pressed":s(r),onClick:()=>s(r)?n.choose("",""):n.choose(r.a,r.b),children:[y("span",{children:[y(Ft,{text:r.a})," ",y("i",{children:"×"})," ",y(Ft,{text:r.b})]}),y("b",{children:[Fe(r.count),r.near>0&&y("i",{children:[" (",Fe(r.near)," near)"]})]})]})},`${r.a}
${r.b}`))}),t.length>am&&y("p",{class:"note",children:["and ",Gt(t.length-am,"pair")," of parts more"]}),(e.partA||e.partB)&&y("p",{class:"note",children:["only ",y(Ft,{text:e.partA||"all of A"})," × ",y(Ft,{text:e.partB||"all of B"}),";"," ",y("button",{type:"button",class:"link",onClick:()=>n.choose("",""),children:"show all"})]})]})}function rv(n){let{pick:e,job:t}=n,i=n.model.meshes[e.body],s=n.model.parts[e.body],r=e.triangle<i.triangles.length/3,o=Ht(()=>{let l=0,c=n.contacts?.pairs??new Uint32Array;for(let u=e.body;u<c.length;u+=3)l+=c[u]===e.triangle?1:0;return l},[n.contacts,e]),a=n.heat?.counts[e.body][e.triangle];return y("section",{"aria-label":"picked triangle","aria-live":"polite",children:[y("h2",{children:["picked"," ",y("button",{type:"button",class:"link",onClick:n.drop,children:"drop"})]}),r?y("p",{children:[e.body===0?"A":"B"," triangle ",y("b",{children:Fe(e.triangle)}),", ",y(Ft,{text:s.nameOf(e.triangle)})," ",Fe(s.placeOf(e.triangle)),"; in ",Gt(o,"pair")," here",a!==void 0&&`; in ${Fe(a)} of ${Gt(t.done,"pose")} (${un(a/Math.max(1,t.done))})`]}):y("p",{children:["the mesh has no triangle ",Fe(e.triangle)]})]})}function iv({pose:n,title:e}){let t=[n.slice(0,4),n.slice(4,8),n.slice(8,12),[0,0,0,1]];return y("table",{class:"matrix",children:[y("caption",{children:e}),y("tbody",{children:t.map((i,s)=>y("tr",{children:i.map((r,o)=>y("td",{children:String(r)},o))},s))})]})}function ov({job:n,contacts:e}){let t=Pc(e.scenario),i=e_(t),s=Ri.filter(a=>a!=="distance"&&(!Fs(a)||Math.abs(i[a])>1e-9)).map(a=>`${a} ${On(i[a],5)}${Fs(a)?"°":""}`),{pose_a:r,pose_b:o}=e.scenario;return y("section",{"aria-label":"pose",children:[y("h2",{children:"B in A's frame"}),y("p",{children:[s.join("  ")," ",y("span",{class:"note",children:["lengths in ",n.unit]})]}),y("details",{children:[y("summary",{children:"matrix"}),n.poses.of_both_bodies&&y(iv,{pose:r,title:"A in the world"}),y(iv,{pose:n.poses.of_both_bodies?o:t,title:n.poses.of_both_bodies?"B in the world":"B in A's frame"})]})]})}function av({model:n,contacts:e}){let t=n?.meshes.filter(r=>r.checked===!1)??[],i=n?.meshes.some(r=>r.checked===null)??!1,s=e?.scenario;return y(Vt,{children:[t.length>0&&y(Pt,{kind:"bad",children:["not the tested geometry: the bytes of ",Gt(t.length,"mesh").replace("meshs","meshes")," do not have the SHA-256 of the run (",t.map(r=>r.sha256.slice(0,16)).join(", "),")"]}),t.length===0&&i&&y(Pt,{kind:"warn",children:"the geometry is not checked: this browser computes SHA-256 on 127.0.0.1 or over TLS only"}),s?.verified===!1&&y(Pt,{kind:"bad",children:["this scenario, run again, gives another record than the stored one: ",s.verify_note]}),s&&s.draw_note!==""&&y(Pt,{kind:"warn",children:["nothing is drawn: ",s.draw_note]}),s&&s.failure!==""&&y(Pt,{kind:"bad",children:["failed: ",y(Ft,{text:s.failure})]})]})}function lv({job:n,contacts:e}){let{scenario:t}=e,i=Ro(t.class),s=t.class!==null&&t.count>0?Gt(t.count,"pair"):"",r=t.near_count>0?Gt(t.near_count,"near pair"):"",o=[t.least_distance!==null?`nearest triangles ${On(t.least_distance,6)} ${n.unit} apart`:"",i===3?"one body is inside the other: g changes the ghost":"",t.id!==null?`id ${t.id}`:"",t.time!==null?`t ${On(t.time,6)}`:"",e.isCut?`drawn: the first ${Fe(e.pairs.length/3)} pairs`:"",t.cut?`list of pairs cut at ${Fe(t.listed)}`:"",t.surfaces_only?"surfaces only: a body is open":"",t.insides_skipped?"containment not tested: triangles are ignored":"",t.distance_bound!==null&&t.distance_bound>0?`at most ${On(t.distance_bound)} ${n.unit} apart`:""].filter(a=>a!=="");return y("span",{class:"scenario-status",children:[y("span",{children:[y(Wr,{kind:i}),y("b",{children:t.class??"no result yet"}),s&&`, ${s}`,r&&`, ${r}`]}),t.verified===!0&&y("span",{class:"verified",title:"run again, the record has the same bytes",children:"✓ verified"}),t.verified===null&&y("span",{class:"note",title:t.verify_note,children:["not verified",t.verify_note&&`: ${t.verify_note}`]}),o.length>0&&y("span",{class:"note",children:o.join(" · ")})]})}function cv(n){let{job:e,scenarios:t}=n,i=y(Ft,{text:e.name||e.job}),s=r=>n.move(t.placeOf(Math.round(Number(r))||0));return y("div",{class:"viewer-head",children:[y("h1",{children:[n.isInReport?i:y("a",{href:Ps(e.job),children:i})," ",y("span",{class:"note",children:"›"})," ",y("label",{class:"number",children:["#",y("input",{type:"number","aria-label":"scenario",min:t.at(0),max:t.at(t.count-1),value:n.scenario,onChange:r=>s(r.currentTarget.value)})]})]}),n.contacts&&y(lv,{job:e,contacts:n.contacts})]})}function Zh(n){return{contact:"contact",near:"near scenario",either:"contact or near scenario"}[n]}function AR({seek:n,choose:e}){return y("select",{"aria-label":"what previous and next find",value:n,onChange:t=>e(t.currentTarget.value),children:[y("option",{value:"contact",children:"contacts"}),y("option",{value:"near",children:"near"}),y("option",{value:"either",children:"both"})]})}function uv(n){let{scenarios:e,search:t,isPlaying:i,play:s}=n,r=e.count-1;return y("div",{class:"scrub",children:[y("button",{type:"button",onClick:()=>t.start(-1),title:"p",children:["‹ previous ",Zh(n.seek)]}),y("button",{type:"button",onClick:()=>t.start(1),title:"n",children:["next ",Zh(n.seek)," ›"]}),n.chooseSeek&&y(AR,{seek:n.seek,choose:n.chooseSeek}),y("input",{type:"range","aria-label":n.isInReport?"scenarios of this report":`scenario, 0 to ${r}`,min:0,max:r,value:n.place,onInput:o=>n.move(Number(o.currentTarget.value))}),s&&y("button",{type:"button",onClick:()=>s(!i),title:"space","aria-pressed":i,children:i?"stop":"play"}),n.children,y("span",{class:"note","aria-live":"polite",children:t.said})]})}var Kh=class{constructor(e,t){this.total=e;this.chosen=t?[...t].sort((i,s)=>i-s):null}total;chosen;get count(){return this.chosen?.length??this.total}at(e){let t=Math.min(this.count-1,Math.max(0,e));return this.chosen?this.chosen[t]:t}placeOf(e){if(!this.chosen)return Math.min(this.total-1,Math.max(0,e));let t=this.chosen.map(i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}};var fv=({partA:n,partB:e})=>!n&&!e;function zl(n,e){return`jobs/${encodeURIComponent(n)}/scenarios/${e}`}async function hv({job:n,from:e,step:t,signal:i,tell:s},r){let o=new URLSearchParams({from:String(e),step:String(t)});for(r.seek!=="contact"&&o.set("class",r.seek),r.partA&&o.set("part_a",r.partA),r.partB&&o.set("part_b",r.partB);;){let a=await Ai(zl(n.job,`next?${o}`),i);if(a.index!==null||a.searched_to===null)return a.index;s(a.searched_to),o.set("from",String(a.searched_to))}}function pv(n,{partA:e,partB:t,seek:i},s){for(let r=0;r+2<n.length;r+=3)if((i==="either"||n[r+2]===so==(i==="near"))&&s[0].isOf(n[r],e)&&s[1].isOf(n[r+1],t))return!0;return!1}async function dv(n){for(;;)try{return await n()}catch(e){if(!(e instanceof Bi&&e.isBusy))throw e;await ec()}}async function TR({job:n,signal:e},t,i,s){let r=await dv(()=>Ai(zl(n.job,String(t)),e));if(r.exact_pairs===0)return r.draw_note!=="";let o=await dv(()=>Zn(zl(n.job,`${t}/pairs`),e));return o.cut||pv(o.values,i,s)}async function mv(n,e,t){let{level:i}=n.job;if(fv(e)||i==="pairs"||i==="contacts")return hv(n,e);let s=await t();[e.partA,e.partB].forEach((r,o)=>{if(r&&!s[o].names.includes(r))throw new Error(`the body has no part '${r}'`)});for(let r=n.from;;n.tell(r)){let o=await hv({...n,from:r},{...e,partA:"",partB:""});if(o===null||await TR(n,o,e,s))return o;r=o}}async function ER(n,e,{seek:t}){if(n.clearance===null||t==="either")return!0;let i=await Ai(zl(n.job,String(e)));return Ro(i.class)===7==(t==="near")}async function gv({job:n,from:e,step:t},i,s,r){let o=i.filter(a=>(a-e)*t>0).sort((a,l)=>(a-l)*t);for(let a of o)if(await ER(n,a,s)&&(fv(s)||pv((await Zn(zl(n.job,`${a}/pairs`))).values,s,r)))return a;return null}function _v(n,e,t,i,s){let[r,o]=Qe(""),a=Tt(null),l=()=>{a.current&&(a.current.stop.abort(),a.current=null,o(u=>u.replace("searching","stopped")))},c=async u=>{if(a.current?.by===u)return;l(),o("");let f={by:u,stop:new AbortController};a.current=f;try{let h=await n(u,f.stop.signal,d=>{a.current===f&&o(`searching, at #${Fe(d)}`)});if(a.current!==f)return;a.current=null,h!==null?(o(""),e(h)):o(`no ${i} ${u>0?"after":"before"} this scenario${t?"":" so far"}`)}catch(h){a.current===f&&(a.current=null,o(Rs(h)?"":Kn(h)))}};return $e(()=>()=>{l(),o("")},s),{said:r,start:u=>{c(u)},stop:l}}function xv(n){let e=Tt(n);e.current=n,$e(()=>pi("viewer",()=>{let{model:t,contacts:i,state:s,drawing:r,scenario:o,canvas:a}=e.current,l=r.viewer,c=a.current?.getBoundingClientRect(),u=([d,p])=>[d+(c?.left??0),p+(c?.top??0)],f=i?.points??new Float64Array,h=Array.from({length:Math.min(8,f.length/4)},(d,p)=>Array.from(f.subarray(4*p+1,4*p+4)));return{ready:l?.isShowing(s)===!0&&r.drawn.current===o,scenario:i?.scenario.index,class:i?.scenario.class,verified:i?.scenario.verified,mode:s.mode,ghost:s.ghost,throughWalls:s.throughWalls,clip:s.clip,camera:l?.view,parts:[s.partA,s.partB],pick:s.pick,trianglesDrawn:l?.bodies.map(d=>d.triangles)??[0,0],highlighted:l?.highlighted??[[],[]],gaps:l?.gaps??0,shaChecked:t?.meshes.map(d=>d.checked),meshMilliseconds:t?.milliseconds,firstFrameMilliseconds:r.firstFrame.current,frames:l?.stage.frames,pointPixels:l?h.map(d=>u(l.pixelOfWorld(d))):[]}}),[])}var CR=60,jh=Math.PI/24,Qh=.05;function RR(n,e){let t=e.bodies[1]?.size??[0,0,0],i=Math.hypot(t[0],t[1],t[2])/2,s=n?.meshes[0],r=o=>s?[s.min[o]-i,s.max[o]+i]:[-1,1];return{x:r(0),y:r(1),z:r(2)}}function lm(n){let e=n.route.job,{value:t,error:i}=Us(`jobs/${encodeURIComponent(e)}`,1,()=>!1);return t?y(PR,{...n,job:t}):i?y(Pt,{kind:"bad",children:i}):y("p",{class:"wait",children:["asking for ",e,"…"]})}function PR({source:n,route:e,report:t,job:i}){let{value:s,error:r}=jy(i),o=Ht(()=>({bodies:Rc(i),hasA:Ne=>s?.parts[0].names.includes(Ne)??!0}),[s]),[a,l]=Qe(e.scenario),[c,u]=Qe(()=>om(e.query,o)),{contacts:f,error:h}=ev(i,a),{value:d,error:p}=Qy(i,s,c.mode==="heat"||c.pick!==null&&i.maps),b=Tt(null),[m,g]=Qe(!1),[v,C]=Qe(!1),S=Zm(Ne=>u(Le=>({...Le,...Ne})),[]),I=tv(b,s,f,c,d,Ne=>S({camera:Ne})),{viewer:T}=I,x=Ht(()=>RR(s,i),[s,i]);ur(t?null:`#${a} ${i.name}`),xv({model:s,contacts:f,state:c,drawing:I,scenario:a,canvas:b});let E=()=>{T&&c.camera&&(T.view=c.camera)},[H,U]=Qe(0);$e(()=>{l(e.scenario),u(om(e.query,o)),U(Ne=>Ne+1)},[e]),$e(E,[T,H]),$e(()=>{if(s){let[Ne,Le]=rm(e.query,o);S({partA:Ne,partB:Le})}},[s]);let L=(Ne,Le)=>Wn(e.job,Ne,Ky({...c,camera:Le},o.bodies)),G=()=>L(a,c.camera??T?.ownView??null),V=ya(i)>Wa,N=!V&&I.error==="";$e(()=>((s||V)&&oc(G),rr),[a,c,f,s]);let W=Ht(()=>new Kh(i.scenarios,t?.scenarios),[i,t]),q=W.placeOf(a),O=Ne=>l(W.at(Ne));$e(()=>{if(!m||f?.scenario.index!==a)return;if(q+1>=W.count){g(!1);return}let Ne=setTimeout(()=>O(q+1),CR);return()=>clearTimeout(Ne)},[m,f,a]);let re=async()=>s?.parts??Promise.all([Bo(i.job,0),Bo(i.job,1)]),ie=_v((Ne,Le,at)=>t&&s?gv({job:i,from:a,step:Ne},t.scenarios,c,s.parts):mv({job:i,from:a,step:Ne,signal:Le,tell:at},c,re),Ne=>{Da(G()),Is(L(Ne,c.camera))},i.done===i.scenarios,Zh(c.seek),[e,a,c,m]),de=()=>{S({camera:null}),T?.fit(!1)},he=()=>{T?.goToContact(),S({camera:T?.view??null})},Q=Ne=>{if(c.clip){let[Le,at]=x[c.clip.axis],ut=Math.min(at,Math.max(Le,c.clip.at+Ne*(at-Le)/100));S({clip:{...c.clip,at:ut}})}},ge={n:()=>ie.start(1),p:()=>ie.start(-1),ArrowRight:()=>O(q+1),ArrowLeft:()=>O(q-1),...N?{" ":()=>g(!m),h:()=>S({mode:c.mode==="heat"||!i.maps?"contacts":"heat"}),g:()=>S({ghost:c.ghost==="a"?"b":c.ghost==="b"?"none":"a"}),x:()=>S({throughWalls:!c.throughWalls}),l:()=>S({lines:!c.lines}),s:()=>S({clip:c.clip?null:{axis:"x",at:(x.x[0]+x.x[1])/2}}),"[":()=>Q(-1),"]":()=>Q(1),f:de,c:he,"Shift+ArrowRight":()=>T?.stage.turn(jh,0),"Shift+ArrowLeft":()=>T?.stage.turn(-jh,0),"Shift+ArrowUp":()=>T?.stage.turn(0,jh),"Shift+ArrowDown":()=>T?.stage.turn(0,-jh),W:()=>T?.stage.move(0,Qh),S:()=>T?.stage.move(0,-Qh),A:()=>T?.stage.move(-Qh,0),D:()=>T?.stage.move(Qh,0),"+":()=>T?.stage.approach(.85),"-":()=>T?.stage.approach(1/.85)}:{},Escape:ie.stop,"?":()=>C(!0)},Ee=Ne=>u(Le=>Ne===null&&Le.pick===null?Le:{...Le,pick:Ne});Oc(ge,t?.root);let ye=i.folder?Na(i.folder):n.kind==="folder"?Na(n.name):i.job,We=r||I.error||h||(c.mode==="heat"?p:"");return y("div",{class:"viewer",children:[y(cv,{job:i,isInReport:t!==void 0,scenario:a,scenarios:W,contacts:f,move:O}),y(av,{model:s,contacts:f}),We&&y(Pt,{kind:"bad",children:We}),y(uv,{scenarios:W,isInReport:t!==void 0,place:q,move:O,search:ie,seek:c.seek,chooseSeek:i.clearance===null?null:Ne=>S({seek:Ne}),isPlaying:m,play:N?g:null,children:[y(P_,{address:()=>location.href.split("#")[0]+L(a,T?.view??c.camera)}),N&&y("button",{type:"button",onClick:()=>{T?.stage.save(`${i.name||e.job}-${a}`)},disabled:!T,children:"PNG"}),y("button",{type:"button",class:"quiet",onClick:()=>C(!0),title:"keys",children:"?"})]}),y("div",{class:"stage-row",children:[V?y("div",{class:"stage",children:y("p",{class:"wait",children:[Fe(ya(i))," triangles: above ",Fe(Wa)," this page does not draw. The exports have it all: ",y("code",{children:["cdctl extract ",ye," ",String(a)," --out case"]})]})}):y(nv,{job:i,scenario:a,contacts:f,canvas:b,viewer:T,waits:!T&&!We,root:t?.root,pick:Ee}),y("aside",{class:"side",children:[N&&y(Vt,{children:[y(R_,{state:c,bounds:x,hasMap:i.maps,change:S,fit:de,goToContact:he}),c.mode==="heat"&&d?y(U_,{heat:d,job:i}):y(O_,{hasNear:i.clearance!==null})]}),c.pick&&s&&y(rv,{pick:c.pick,model:s,contacts:f,heat:d,job:i,drop:()=>S({pick:null})}),f&&s&&y(sv,{contacts:f,model:s,state:c,choose:(Ne,Le)=>S({partA:Ne,partB:Le})}),f&&y(ov,{job:i,contacts:f}),y("section",{"aria-label":"as a case of its own",children:[y("h2",{children:"as a case of its own"}),y(Ec,{text:`cdctl extract ${ye} ${a} --out case`})]})]})]}),v&&y(Uc,{title:"Keys of the viewer",keys:w_(N),close:()=>C(!1)})]})}var yv={system:"light",light:"dark",dark:"system"};function IR(){let[n,e]=Qe(lg());return y("button",{type:"button",class:"quiet",onClick:()=>{cg(yv[n]),e(yv[n])},title:"light, dark, or as the system says",children:[{system:"◐",light:"○",dark:"●"}[n]," ",n]})}function vv(n){let{source:e,screen:t}=n,i=e.job===null,s=(r,o,a)=>y("a",{href:`#/${r}`,...a?{"aria-current":"page"}:{},children:o});return y(Vt,{children:[y("header",{class:"bar",children:[y("a",{class:"brand",href:"#/",children:[y("img",{src:"icon.svg",alt:"",width:20,height:20}),"cdcluster"]}),y("nav",{"aria-label":"screens",children:[i&&s("cluster","cluster",t==="cluster"),i&&s("jobs","jobs",t==="jobs"),e.job!==null&&s(`jobs/${e.job}`,"job",t==="job")]}),y("span",{class:"where",title:`${e.program} ${e.name}`,children:[e.kind==="folder"?"folder ":"master ",y(Ft,{text:e.kind==="folder"?ar(e.name):e.name}),e.tls&&" · TLS"]}),y(IR,{})]}),y("main",{children:n.children})]})}function bv(n){return n.job===null?"#/cluster":Ps(n.job)}function Mv(){let[n,e]=Qe(Ed),t=()=>e(Ed()),i=Tt(location.hash);return $e(()=>{location.hash!==i.current&&t();let s=()=>{rr(),wd(),t()};return addEventListener("hashchange",s),()=>removeEventListener("hashchange",s)},[]),[n,t]}function LR({source:n}){let[e,t]=Mv();$e(()=>pi("route",()=>({screen:e.screen,link:location.hash})),[e]);let i=location.hash.replace(/^#\/?/,"")==="";return $e(()=>{i&&(Da(bv(n)),t())},[i]),y(vv,{source:n,screen:e.screen,children:e.screen==="none"&&!i?y(Pt,{kind:"warn",children:["this address names nothing here; ",y("a",{href:bv(n),children:"go to the start"})]}):y(DR,{source:n,route:e})})}function DR({source:n,route:e}){switch(e.screen){case"cluster":return y(Y0,{});case"jobs":return y($0,{});case"job":return y(E_,{source:n,route:e},e.job);case"viewer":return y(lm,{source:n,route:e},e.job);default:return null}}function NR(){let[n,e]=Qe(null),[t,i]=Qe("");return $e(()=>{Ai("source").then(e,s=>i(Kn(s)))},[]),n?y(LR,{source:n}):t?y(Pt,{kind:"bad",children:t}):null}function UR({source:n,report:e}){let[t]=Mv(),i=Ht(()=>Td(Wn(n.job??"",e.scenarios[0])),[]);return y(lm,{source:n,route:t.screen==="viewer"?t:i,report:e})}async function OR(n,e){tg(o=>e.answer(o));let t=await Ai("source"),i=new CSSStyleSheet;i.replaceSync(await Ad("app.css"));let s=n.attachShadow({mode:"open"});s.adoptedStyleSheets=[i];let r=s.appendChild(document.createElement("div"));xd(y(UR,{source:t,report:{scenarios:e.scenarios,root:r}}),r)}ig();var ed=document.getElementById("page"),Sv=sc.of(document);ed&&Sv?OR(ed,Sv):ed&&(ug(),wd(),xd(y(NR,{}),ed));
