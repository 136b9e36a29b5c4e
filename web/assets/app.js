var $t,Jg,ZS,Ar,gf,Uc,Kg,Lc,Zg,yf,_f,jS,sl=Symbol.for("pv"),Fc={},kc=[],QS=/^m(i|n|o|s|text|space)$/,xf=Array.isArray,jg=kc.slice,co=Object.assign;function lo(n){n&&n.parentNode&&n.remove()}function Dc(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:sl,__v:s||++Jg,__i:-1,__u:0};return!s&&$t.vnode&&$t.vnode(r),r}function Pt(n){return n.children}function Nc(n,e){this.props=n,this.context=e,this.__g=0}function Tr(n,e){if(e==null)return n.__&&Tr(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Tr(n)}function eM(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=co({constructor:sl},t)).__v=t.__v+1,$t.vnode&&$t.vnode(e),vf(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Tr(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,s0(s,e,r),t.__=t.__e=null,e.__e!=i&&Qg(e))}function Qg(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),Qg(n)}function qg(n){(8&n.__g||(n.__g|=8,Ar.push(n),Uc++))&&gf==$t.debounceRendering||((gf=$t.debounceRendering)||queueMicrotask)(e0)}function e0(){try{for(var n,e=1;Ar.length;)Ar.length>e&&Ar.sort(Kg),n=Ar.shift(),e=Ar.length,8&n.__g&&eM(n)}finally{(Uc=Ar.length)&&(gf||queueMicrotask)(e0)}}function t0(n,e,t,i,s,r,o,a,l,c,u){var d,h,f,p,v,g,_=i.__k||kc,b=e.length;for(l=tM(t,e,_,l,b),d=0;d<b;d++)(f=t.__k[d])!=null&&(h=~f.__i&&_[f.__i]||Fc,f.__i=d,g=vf(n,f,h,s,r,o,a,l,c,u),p=f.__e,(h.ref!=f.ref||8&h.__u)&&(h.ref&&bf(h.ref,null,f,h),f.ref&&u.push(f.ref,f.__c||p,f)),v=v||p,4&f.__u?(l=n0(f,l,n,!h.__v),h.__e&&(h.__e=null)):typeof f.type=="function"&&g!==void 0?l=g:p&&(l=p.nextSibling),f.__u&=-21);return t.__e=v,l}function tM(n,e,t,i,s){var r,o,a,l,c,u,d,h,f,p=t.length,v=p,g=0,_=0,b=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=b[r]=Dc(null,o):xf(o)?o=b[r]=Dc(Pt,{children:o}):o.constructor===sl&&o.__b?o=b[r]=Dc(o.type,o.props,o.key,o.ref,o.__v):b[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=nM(o,t,l,v))&&(v--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,_=1)):(~c||(s>p?g--:s<p&&g++),typeof o.type!="function"&&(o.__u|=4))):b[r]=null;if(_){for(u=[],d=[],r=0;r<s;r++)if((o=b[r])&&16&o.__u){for(g=0,h=u.length;g<h;)u[f=g+h>>1]<o.__i?g=f+1:h=f;u[g]=o.__i,d[r]=g+1}for(g=u.length;r--;)d[r]&&(d[r]==g?g--:b[r].__u|=4)}if(v)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Tr(a)),Sf(a,a));return i}function n0(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=n0(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Tr(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function nM(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function Yg(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Ic(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||Yg(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||Yg(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=_f[e]||(_f[e]=iM(e)),(n.__a||(n.__a={}))[e]=yf,r=e!=(e=e.replace(Zg,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function iM(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Lc]==null)e[Lc]=yf++;else if(e[Lc]<this.__a[n])return;return t($t.event?$t.event(e):e)}}}function vf(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,p,v,g,_,b,E,M,I,C,y,T,k,D,L,H=e.type;if(e.constructor!==sl)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,d=r=[],u.nodeType==8?a=Oc(u,r):r.push(u),a=r[0]||a),(u=$t.__b)&&u(e);e:if(typeof H=="function"){h=o.length;try{if(_=e.props,b=(u=H.prototype)&&u.render,E=(u=H.contextType)&&i[u.__c],M=u?E?E.props.value:u.__:i,(f=t.__c)?(e.__c=f,2&f.__g&&(f.__g|=1)):(b?e.__c=f=new H(_,M):(e.__c=f=new Nc(_,M),f.constructor=H,f.render=rM),E&&E.sub(f),f.state||(f.state={}),f.__n=i,f.__g|=8,f.__h=[],f.__k=[]),b&&(f.__s||(f.__s=f.state),H.getDerivedStateFromProps&&(f.__s==f.state&&(f.__s=co({},f.__s)),co(f.__s,H.getDerivedStateFromProps(_,f.__s)))),p=f.props,v=f.state,f.__v=e,t.__c){if(_!==p&&b&&!H.getDerivedStateFromProps&&f.componentWillReceiveProps&&f.componentWillReceiveProps(_,M),e.__v==t.__v&&!(8&f.__g)||!(4&f.__g)&&f.shouldComponentUpdate&&f.shouldComponentUpdate(_,f.__s,M)===!1){e.__v!=t.__v&&(f.props=_,f.state=f.__s,f.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(V){V&&(V.__=e)}),kc.push.apply(f.__h,f.__k),f.__k=[],f.__h.length&&o.push(f),a=Tr(t);break e}f.componentWillUpdate&&f.componentWillUpdate(_,f.__s,M),b&&f.componentDidUpdate&&f.__h.push(function(){f.componentDidUpdate(p,v,g)})}else b&&!H.getDerivedStateFromProps&&f.componentWillMount&&f.componentWillMount(),b&&f.componentDidMount&&f.__h.push(f.componentDidMount);f.context=M,f.props=_,f.__P=n,f.__g&=-5,I=$t.__r,C=b?25:0;do f.__g&=-9,I&&I(e),u=f.render(f.props,f.state=f.__s,f.context);while(8&f.__g&&++C<25);b&&(kc.push.apply(f.__h,f.__k),f.__k=[]),f.state=f.__s,f.getChildContext&&(i=co({},i,f.getChildContext())),b&&t.__c&&f.getSnapshotBeforeUpdate&&(g=f.getSnapshotBeforeUpdate(p,v)),y=u&&u.type===Pt&&u.key==null?u.props.children:u,_.__P&&(u=a,s=(n=_.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(V){V&&Sf(V,V)}),t.__k=null),a=t.__k?Tr(t,0):null),a=t0(n,xf(y)?y:[y],e,t,i,s,r,o,a,l,c),_.__P&&(e.__e=null,a=u),e.__u&=-161,d&&d.some(lo),f.__h.length&&o.push(f),1&f.__g&&(f.__g&=-4)}catch(V){if(o.length=h,e.__v=null,l||r)if(V&&V.then){if(e.__u|=128|l,r){for(~(D=r.indexOf(a||void 0))||(D=r.length);(L=r[D-1])&&L.nodeType==8;)D--;for(;D<r.length;D++)if(L=r[D])if(r[D]=null,T){if(L==k)break}else{if(L.nodeType!=8)break;L.data.startsWith("$s")&&(k=Oc(T=L))}}if(!T){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;T=a}(u=Oc(T=e.__c.__z||(e.__c.__z=T)))?(e.__e=T,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(lo);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),V&&V.then||i0(e),$t.__e(V,e,t)}}else a=e.__e=sM(t.__e,e,t,i,s,r,o,l,c,n);return(u=$t.diffed)&&u(e),a}function Oc(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function i0(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(i0))}function s0(n,e,t){for(var i=0;i<t.length;)bf(t[i++],t[i++],t[i++]);$t.__c&&$t.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){$t.__e(r,s.__v)}})}function sM(n,e,t,i,s,r,o,a,l,c){var u,d,h,f,p,v,g,_,b=t.props||Fc,E=e.props,M=e.type;if(M=="svg"?s="http://www.w3.org/2000/svg":M=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(M?p.localName==M:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(_=c.ownerDocument||document,!M)return _.createTextNode(E);n=_.createElementNS(s,M,E.is?E:c),a&&($t.__m&&$t.__m(e,r),a=!1),r=null}if(M){if(c=M=="template"&&n.content||n,r=M=="textarea"&&E.defaultValue!=null?null:r&&jg.call(c.childNodes),!a&&r)for(b={},u=0;u<n.attributes.length;u++)b[(p=n.attributes[u]).name]=p.value;for(u in b)p=b[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in E||u=="value"&&"defaultValue"in E||u=="checked"&&"defaultChecked"in E||Ic(n,u,null,p,s);for(u in E)p=E[u],u=="children"?f=p:u=="dangerouslySetInnerHTML"?d=p:u=="value"?v=p:u=="checked"?g=p:a&&typeof p!="function"||b[u]===p||Ic(n,u,p,b[u],s);d?(a||h&&(d.__html==h.__html||d.__html==n.innerHTML)||(n.innerHTML=d.__html),e.__k=[]):(h&&(n.textContent=""),(M=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&QS.test(M))&&(s="http://www.w3.org/1999/xhtml"),t0(c,xf(f)?f:[f],e,t,i,s,r,o,r?r[0]:t.__k&&Tr(t,0),a,l),r&&r.some(lo)),a&&M!="textarea"||(u="value",M=="progress"&&v==null?n.removeAttribute(u):v==null||v===n[u]&&(M!="progress"||v)||Ic(n,u,v,b[u],s),u="checked",g!=null&&g!=n[u]&&Ic(n,u,g,b[u],s))}else b===E||a&&n.data==E||(n.data=E);return n}function bf(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){$t.__e(s,t)}}function Sf(n,e,t){var i,s,r,o;if($t.unmount&&$t.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||bf(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){$t.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&Sf(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=Oc(i,r=[]))&&(i==n.__e&&r.some(lo),lo(s),lo(i)),t||lo(n.__e),n.__e=n.__c=n.__=null}function rM(n,e,t){return this.constructor(n,t)}function Mf(n,e){var t,i,s,r;$t.__&&$t.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Dc(Pt,{children:[n]}),s=[],r=[],vf(e,e.__k,i||Fc,Fc,e.namespaceURI,i?null:e.firstChild?jg.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),s0(s,e.__k,r),e.__k.props.children=null}$t={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Uc=0,n}},Jg=0,ZS=function(n){return n!=null&&n.constructor===sl},Nc.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=co({},this.state)),typeof n=="function"&&(n=n(co({},t),this.props)),n&&(co(t,n),this.__v&&(e&&this.__k.push(e),qg(this)))},Nc.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),qg(this))},Nc.prototype.render=Pt,Ar=[],Uc=0,Kg=function(n,e){return n.__v.__b-e.__v.__b},Lc=Symbol(),Zg=/(PointerCapture)$|Capture$/i,yf=0,_f={},jS=0;var ol,Un,wf,r0,Af=Object.is,al=0,p0=[],Tf=[],Cn=$t,o0=Cn.__b,a0=Cn.__r,l0=Cn.diffed,c0=Cn.__c,u0=Cn.unmount,h0=Cn.__;function Cf(n,e){Cn.__h&&Cn.__h(Un,n,al||e),al=0;var t=Un.__H||(Un.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function $e(n){return al=1,oM(_0,n)}function oM(n,e,t){var i=Cf(ol++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):_0(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);Af(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Un,!Un.__f)){Un.__f=!0;var s=Un.shouldComponentUpdate;Un.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,Af(h.__[0],h.__N[0])||(u=!0))}),s){var d=s.call(this,r,o,a);return c?d||u:d}return!c||u}}return i.__}function ke(n,e){var t=Cf(ol++,3);!Cn.__s&&g0(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Un.__H.__h.push(t))}function Tt(n){return al=5,lt(function(){return{current:n}},[])}function lt(n,e){var t=Cf(ol++,7);return g0(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function m0(n,e){return al=8,lt(function(){return n},e)}function aM(){var n;do{for(;n=Tf.shift();)try{rl(n)}catch(t){Cn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=p0.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(rl),e.__h.some(Ef),e.__h=[]}catch(t){e.__h=[],Cn.__e(t,n.__v)}}}while(Tf.length)}Cn.__b=function(n){Un=null,o0&&o0(n)},Cn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),h0&&h0(n,e)},Cn.__r=function(n){a0&&a0(n),ol=0;var e=(Un=n.__c).__H;e&&(wf==Un?Un.__h=[]:(e.__h.some(rl),e.__h.some(Ef),ol=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),wf=Un},Cn.diffed=function(n){l0&&l0(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&f0(p0.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),wf=Un=null},Cn.__c=function(n,e){e.some(function(t){try{t.__h.some(rl),t.__h=t.__h.filter(function(i){return!i.__||Ef(i)})}catch(i){t.__h=[function(){throw i}]}}),c0&&c0(n,e)},Cn.unmount=function(n){u0&&u0(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,f0(Tf.push(s))}else rl(s)}catch(r){e=r}}),i.__H=void 0,e&&Cn.__e(e,i.__v))};var d0=typeof requestAnimationFrame=="function";function lM(n){var e,t=function(){clearTimeout(i),d0&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);d0&&(e=requestAnimationFrame(t))}function f0(n){n!=1&&r0==Cn.requestAnimationFrame||((r0=Cn.requestAnimationFrame)||lM)(aM)}function rl(n){var e=Un,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Un=e}function Ef(n){var e=Un;n.__c=n.__(),Un=e}function g0(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!Af(t,n[i])})}function _0(n,e){return typeof e=="function"?e(n):e}function cM(n,e){switch(n){case"|u1":return new Uint8Array(e);case"<u4":return new Uint32Array(e);case"<f4":return new Float32Array(e);case"<f8":return new Float64Array(e);case"<u8":return Float64Array.from(new BigUint64Array(e),Number);default:throw new Error(`an NPY array of type ${n}, which this page does not know`)}}function y0(n){let e=new Uint8Array(n);if(e.length<10||e[0]!==147||e[1]!==78||e[6]!==1)throw new Error("not an NPY array of format 1.0");let t=10+e[8]+256*e[9],i=new TextDecoder("latin1").decode(e.subarray(10,t)),s=/'descr':\s*'([^']+)'/.exec(i)?.[1]??"",r=(/'shape':\s*\(([^)]*)\)/.exec(i)?.[1]??"").split(",").filter(a=>a.trim()!=="").map(Number);if(/'fortran_order':\s*True/.test(i))throw new Error("an NPY array in Fortran order, which this page does not read");let o=cM(s,n.slice(t));if(o.length!==r.reduce((a,l)=>a*l,1))throw new Error("an NPY array that is cut short");return{shape:r,values:o}}var wi=class extends Error{constructor(t,i){super(i);this.status=t}status;get isBusy(){return this.status===503}},uM=300;function zc(){return new Promise(n=>setTimeout(n,uM))}var x0="cdcluster.key",Bc="";function hM(){try{return localStorage.getItem(x0)??Bc}catch{return Bc}}function Rf(){let n=/^#key=([^&]*)&?(.*)$/.exec(location.hash);if(n){Bc=n[1];try{localStorage.setItem(x0,Bc)}catch{}history.replaceState(null,"",`${location.pathname}#${n[2]}`)}}async function dM(n){try{let e=await n.json();if(typeof e=="object"&&e!==null&&"error"in e)return String(e.error)}catch{}return`the server answered ${n.status}`}async function fM(n,e){let t=hM(),i=t===""?{}:{Authorization:`Bearer ${t}`},s;try{s=await fetch(`api/v1/${n}`,{headers:i,credentials:"same-origin",...e?{signal:e}:{}})}catch(r){throw e?.aborted?r:new wi(0,"the server does not answer: has it ended?")}if(!s.ok)throw new wi(s.status,await dM(s));return{bytes:await s.arrayBuffer(),cut:s.headers.get("X-Cut")==="true"}}var Vc=fM;function v0(n){Vc=n}async function Pf(n,e){return new TextDecoder().decode((await Vc(n,e)).bytes)}async function Ai(n,e){return JSON.parse(await Pf(n,e))}async function Kt(n,e){let{bytes:t,cut:i}=await Vc(n,e);return{...y0(t),cut:i}}async function b0(n,e){return(await Vc(n,e)).bytes}function ls(n){return n instanceof DOMException&&n.name==="AbortError"}function Rn(n){return n instanceof Error?n.message:String(n)}var Gc=new Map,Hc=[];function Ti(n,e){return Gc.set(n,e),()=>{Gc.get(n)===e&&Gc.delete(n)}}function S0(){addEventListener("error",n=>Hc.push(n.message)),addEventListener("unhandledrejection",n=>Hc.push(String(n.reason))),document.addEventListener("securitypolicyviolation",n=>Hc.push(`policy: ${n.violatedDirective} ${n.blockedURI}`)),window.cdcluster={facts:()=>Object.assign({ready:!1,errors:[...Hc]},...[...Gc.values()].map(n=>n()))}}async function pM(n){let e=atob(n),t=new Uint8Array(e.length);for(let s=0;s<e.length;++s)t[s]=e.charCodeAt(s);let i=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(i).arrayBuffer()}var Wc=class n{constructor(e){this.blocks=e}blocks;static of(e){let i=Array.from(e.querySelectorAll("template[data-path]")).map(s=>[s.dataset.path??"",{base64:()=>s.content.textContent??"",cut:s.dataset.cut==="true"}]);return i.length===0?null:new n(new Map(i))}get scenarios(){return[...this.blocks.keys()].flatMap(e=>{let t=/^jobs\/[^/]+\/scenarios\/(\d+)$/.exec(e);return t?[Number(t[1])]:[]})}async answer(e){let t=this.blocks.get(e);if(!t)throw new wi(404,"this report holds its worst scenarios only");return{bytes:await pM(t.base64()),cut:t.cut}}};function If(n){let[e,t]=n.replace(/^#/,"").split("?",2),i={screen:"none",job:"",scenario:0,query:new URLSearchParams(t??"")},s=e.split("/").filter(o=>o!=="");if(s.length===1&&(s[0]==="cluster"||s[0]==="jobs"))return{...i,screen:s[0]};if(s[0]!=="jobs"||s.length<2||s.length>3)return i;let r=mM(s[1]);return s.length===2?{...i,screen:"job",job:r}:/^\d+$/.test(s[2])?{...i,screen:"viewer",job:r,scenario:Number(s[2])}:i}function mM(n){try{return decodeURIComponent(n)}catch{return n}}function M0(n){let e=new URLSearchParams(n).toString().replaceAll("%2C",",").replaceAll("%3A",":").replaceAll("%2F","/");return e===""?"":`?${e}`}function Ks(n,e={}){return`#/jobs/${encodeURIComponent(n)}${M0(e)}`}function en(n,e,t={}){return`#/jobs/${encodeURIComponent(n)}/${e}${M0(t)}`}var ll=null,w0=0,$c=null;function Zs(n){A0(),location.hash=n}function Lf(){return ll=location.hash,If(ll)}function cl(n){Er(),(ll===null||location.hash===ll)&&(history.replaceState(null,"",n),ll=location.hash)}function Xc(n){Er(),$c=n,w0=window.setTimeout(A0,200)}function A0(){$c&&cl($c())}function Er(){clearTimeout(w0),$c=null}var T0="cdcluster.theme",qc=new Set;function E0(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:"system"}function C0(n){n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n;try{localStorage.setItem(T0,n)}catch{}qc.forEach(e=>e())}function R0(){try{let n=localStorage.getItem(T0);(n==="light"||n==="dark")&&(document.documentElement.dataset.theme=n)}catch{}matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>qc.forEach(n=>n()))}function Yc(n){return qc.add(n),()=>qc.delete(n)}function cs(n,e=document.documentElement){return getComputedStyle(e).getPropertyValue(n).trim()}function fe(n){return(n<0?"-":"")+String(Math.round(Math.abs(n))).replace(/\B(?=(\d{3})+$)/g," ")}function Et(n,e=4){return Number.isFinite(n)?String(Number(n.toPrecision(e))):n>0?"infinite":"-"}function Sn(n){return Number.isFinite(n)?`${n>0&&n<.001?"< 0.1":Et(100*n,3)} %`:"-"}function Jc(n,e,t){let i=0;for(;Math.abs(n)>=e&&i+1<t.length;)n/=e,i+=1;let s=i===0?String(Math.round(n)):n.toPrecision(3);return t[i]===""?s:s+" "+t[i]}function js(n){return Jc(n,1024,["B","KiB","MiB","GiB","TiB"])}function P0(n){return`${Jc(n,1e3,["B","kB","MB","GB"])}/s`}function I0(n,e){if(n<.01*e)return`${js(n)} of ${js(e)}`;let[t,i]=js(e).split(" ");return`${(n/(e/Number(t))).toPrecision(2)} of ${t} ${i}`}function Cr(n){return`${Jc(n,1e3,["","k","M","G"])}/s`}function Df(n){return Jc(n,1e3,["","k","M","G"])}function uo(n){if(!Number.isFinite(n))return"-";if(n<10)return`${Et(n,2)} s`;let e=Math.round(n),t=i=>String(i).padStart(2,"0");return e<3600?`${Math.floor(e/60)}:${t(e%60)}`:e<86400?`${Math.floor(e/3600)} h ${t(Math.floor(e%3600/60))}`:`${Math.floor(e/86400)} d ${Math.floor(e%86400/3600)} h`}function ft(n,e){return`${fe(n)} ${e}${n===1?"":"s"}`}function ul(n){return/^[\w./:@%+=,-]+$/.test(n)?n:`'${n.replaceAll("'","'\\''")}'`}function us(n){return n.split("/").pop()||n}var gM="uplot",_M="u-hz",yM="u-vt",xM="u-title",vM="u-wrap",bM="u-under",SM="u-over",MM="u-axis",po="u-off",wM="u-select",AM="u-cursor-x",TM="u-cursor-y",EM="u-cursor-pt",CM="u-legend",RM="u-live",PM="u-inline",IM="u-series",LM="u-marker",L0="u-label",DM="u-value",dl="width",fl="height";var D0="bottom",Yo="left",Nf="right",Zf="#000",N0=Zf+"0",Of="mousemove",O0="mousedown",Uf="mouseup",U0="mouseenter",F0="mouseleave",k0="dblclick",NM="resize",OM="scroll",B0="change",eu="dppxchange",jf="--",ta=typeof window<"u",Vf=ta?document:null,Ko=ta?window:null,UM=ta?navigator:null,Ut,Kc;function Hf(){let n=devicePixelRatio;Ut!=n&&(Ut=n,Kc&&Wf(B0,Kc,Hf),Kc=matchMedia(`(min-resolution: ${Ut-.001}dppx) and (max-resolution: ${Ut+.001}dppx)`),mo(B0,Kc,Hf),Ko.dispatchEvent(new CustomEvent(eu)))}function Fi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Gf(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function an(n,e,t){n.style[e]=t+"px"}function hs(n,e,t,i){let s=Vf.createElement(n);return e!=null&&Fi(s,e),t?.insertBefore(s,i),s}function ji(n,e){return hs("div",n,e)}var z0=new WeakMap;function Is(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=z0.get(n);r!=o&&(n.style.transform=r,z0.set(n,r),e<0||t<0||e>i||t>s?Fi(n,po):Gf(n,po))}var V0=new WeakMap;function H0(n,e,t){let i=e+t,s=V0.get(n);i!=s&&(V0.set(n,i),n.style.background=e,n.style.borderColor=t)}var G0=new WeakMap;function W0(n,e,t,i){let s=e+""+t,r=G0.get(n);s!=r&&(G0.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Qf={passive:!0},FM={...Qf,capture:!0};function mo(n,e,t,i){e.addEventListener(n,t,i?FM:Qf)}function Wf(n,e,t,i){e.removeEventListener(n,t,Qf)}ta&&Hf();function ds(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:ki((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function y_(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var x_=n=>n!=null,v_=n=>n!=null&&n>0,iu=y_(x_),kM=y_(v_);function BM(n,e,t,i=0,s=!1){let r=s?kM:iu,o=s?v_:x_;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Zt,l??-Zt]}function su(n,e,t,i){let s=q0(n),r=q0(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Qs:b_,a=s==1?ki:Qi,l=r==1?Qi:ki,c=a(o(kn(n))),u=l(o(kn(e))),d=Zo(t,c),h=Zo(t,u);return t==10&&(c<0&&(d=jt(d,-c)),u<0&&(h=jt(h,-u))),i||t==2?(n=d*s,e=h*r):(n=A_(n,d),e=ru(e,h)),[n,e]}function ep(n,e,t,i){let s=su(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var tp=.1,$0={mode:3,pad:tp},ml={pad:0,soft:null,mode:0},zM={min:ml,max:ml};function tu(n,e,t,i){return ou(t)?X0(n,e,t):(ml.pad=t,ml.soft=i?0:null,ml.mode=i?3:0,X0(n,e,zM))}function It(n,e){return n??e}function VM(n,e,t){for(e=It(e,0),t=It(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function X0(n,e,t){let i=t.min,s=t.max,r=It(i.pad,0),o=It(s.pad,0),a=It(i.hard,-Zt),l=It(s.hard,Zt),c=It(i.soft,Zt),u=It(s.soft,-Zt),d=It(i.mode,0),h=It(s.mode,0),f=e-n,p=Qs(f),v=pi(kn(n),kn(e)),g=Qs(v),_=kn(g-p);(f<1e-24||_>10)&&(f=0,(n==0||e==0)&&(f=1e-24,d==2&&c!=Zt&&(r=0),h==2&&u!=-Zt&&(o=0)));let b=f||v||1e3,E=Qs(b),M=Zo(10,ki(E)),I=b*(f==0?n==0?.1:1:r),C=jt(A_(n-I,M/10),24),y=n>=c&&(d==1||d==3&&C<=c||d==2&&C>=c)?c:Zt,T=pi(a,C<y&&n>=y?y:fs(y,C)),k=b*(f==0?e==0?.1:1:o),D=jt(ru(e+k,M/10),24),L=e<=u&&(h==1||h==3&&D>=u||h==2&&D<=u)?u:-Zt,H=fs(l,D>L&&e<=L?L:pi(L,D));return T==H&&T==0&&(H=100),[T,H]}var HM=new Intl.NumberFormat(ta?UM.language:"en-US"),np=n=>HM.format(n),Bi=Math,Qc=Bi.PI,kn=Bi.abs,ki=Bi.floor,Fn=Bi.round,Qi=Bi.ceil,fs=Bi.min,pi=Bi.max,Zo=Bi.pow,q0=Bi.sign,Qs=Bi.log10,b_=Bi.log2,GM=(n,e=1)=>Bi.sinh(n)*e,Ff=(n,e=1)=>Bi.asinh(n/e),Zt=1/0;function Y0(n){return(Qs((n^n>>31)-(n>>31))|0)+1}function $f(n,e,t){return fs(pi(n,e),t)}function S_(n){return typeof n=="function"}function Mt(n){return S_(n)?n:()=>n}var WM=()=>{},M_=n=>n,w_=(n,e)=>e,$M=n=>null,J0=n=>!0,K0=(n,e)=>n==e,XM=/\.\d*?(?=9{6,}|0{6,})/gm,go=n=>{if(E_(n)||Pr.has(n))return n;let e=`${n}`,t=e.match(XM);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${go(s)}e${r}`}return jt(n,i)};function ho(n,e){return go(jt(go(n/e))*e)}function ru(n,e){return go(Qi(go(n/e))*e)}function A_(n,e){return go(ki(go(n/e))*e)}function jt(n,e=0){if(E_(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Fn(i)/t}var Pr=new Map;function T_(n){return((""+n).split(".")[1]||"").length}function _l(n,e,t,i){let s=[],r=i.map(T_);for(let o=e;o<t;o++){let a=kn(o),l=jt(Zo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,d=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:jt(u,d);s.push(h),Pr.set(h,d)}}return s}var gl={},ip=[],jo=[null,null],Rr=Array.isArray,E_=Number.isInteger,qM=n=>n===void 0;function Z0(n){return typeof n=="string"}function ou(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function YM(n){return n!=null&&typeof n=="object"}var JM=Object.getPrototypeOf(Uint8Array),C_="__proto__";function Qo(n,e=ou){let t;if(Rr(n)){let i=n.find(s=>s!=null);if(Rr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=Qo(n[s],e)}else t=n.slice()}else if(n instanceof JM)t=n.slice();else if(e(n)){t={};for(let i in n)i!=C_&&(t[i]=Qo(n[i],e))}else t=n;return t}function Pn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=C_&&(ou(n[s])?Pn(n[s],Qo(i[s])):n[s]=Qo(i[s]))}return n}var KM=0,ZM=1,jM=2;function QM(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function ew(n,e){if(iw(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return sw(o[0])||(o=nw(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],d=Array(s).fill(void 0),h=e?e[o][c]:ZM,f=[];for(let p=0;p<u.length;p++){let v=u[p],g=r.get(l[p]);v===null?h!=KM&&(d[g]=v,h==jM&&f.push(g)):d[g]=v}QM(d,f,s),i.push(d)}}return i}var tw=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function nw(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function iw(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function sw(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=pi(1,ki((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var R_=["January","February","March","April","May","June","July","August","September","October","November","December"],P_=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function I_(n){return n.slice(0,3)}var rw=P_.map(I_),ow=R_.map(I_),aw={MMMM:R_,MMM:ow,WWWW:P_,WWW:rw};function hl(n){return(n<10?"0":"")+n}function lw(n){return(n<10?"00":n<100?"0":"")+n}var cw={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>hl(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>hl(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>hl(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>hl(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>hl(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>lw(n.getMilliseconds())};function sp(n,e){e=e||aw;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?cw[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var uw=new Intl.DateTimeFormat().resolvedOptions().timeZone;function hw(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==uw?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var L_=n=>n%1==0,nu=[1,2,2.5,5],dw=_l(10,-32,0,nu),D_=_l(10,0,32,nu),fw=D_.filter(L_),fo=dw.concat(D_),rp=`
`,N_="{YYYY}",j0=rp+N_,O_="{M}/{D}",pl=rp+O_,Zc=pl+"/{YY}",U_="{aa}",pw="{h}:{mm}",Jo=pw+U_,Q0=rp+Jo,e_=":{ss}",kt=null;function F_(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?_l(10,0,3,nu).filter(L_):_l(10,-3,0,nu)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,N_,kt,kt,kt,kt,kt,kt,1],[s*28,"{MMM}",j0,kt,kt,kt,kt,kt,1],[s,O_,j0,kt,kt,kt,kt,kt,1],[i,"{h}"+U_,Zc,kt,pl,kt,kt,kt,1],[t,Jo,Zc,kt,pl,kt,kt,kt,1],[e,e_,Zc+" "+Jo,kt,pl+" "+Jo,kt,Q0,kt,1],[n,e_+".{fff}",Zc+" "+Jo,kt,pl+" "+Jo,kt,Q0,kt,1]];function u(d){return(h,f,p,v,g,_)=>{let b=[],E=g>=o,M=g>=r&&g<o,I=d(p),C=jt(I*n,3),y=kf(I.getFullYear(),E?0:I.getMonth(),M||E?1:I.getDate()),T=jt(y*n,3);if(M||E){let k=M?g/r:0,D=E?g/o:0,L=C==T?C:jt(kf(y.getFullYear()+D,y.getMonth()+k,1)*n,3),H=new Date(Fn(L/n)),V=H.getFullYear(),O=H.getMonth();for(let $=0;L<=v;$++){let q=kf(V+D*$,O+k*$,1),G=q-d(jt(q*n,3));L=jt((+q+G)*n,3),L<=v&&b.push(L)}}else{let k=g>=s?s:g,D=ki(p)-ki(C),L=T+D+ru(C-T,k);b.push(L);let H=d(L),V=H.getHours()+H.getMinutes()/t+H.getSeconds()/i,O=g/i,$=h.axes[f]._space,q=_/$;for(;L=jt(L+g,n==1?0:3),!(L>v);)if(O>1){let G=ki(jt(V+O,6))%24,ee=d(L).getHours()-G;ee>1&&(ee=-1),L-=ee*i,V=(V+O)%24;let Y=b[b.length-1];jt((L-Y)/g,3)*q>=.7&&b.push(L)}else b.push(L)}return b}}return[l,c,u]}var[mw,gw,_w]=F_(1),[yw,xw,vw]=F_(.001);_l(2,-53,53,[1]);function t_(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function n_(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,d,h,f;return i.map(p=>{let v=n(p),g=v.getFullYear(),_=v.getMonth(),b=v.getDate(),E=v.getHours(),M=v.getMinutes(),I=v.getSeconds(),C=g!=l&&a[2]||_!=c&&a[3]||b!=u&&a[4]||E!=d&&a[5]||M!=h&&a[6]||I!=f&&a[7]||a[1];return l=g,c=_,u=b,d=E,h=M,f=I,C(v)})}}function bw(n,e){let t=sp(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function kf(n,e,t){return new Date(n,e,t)}function i_(n,e){return e(n)}var Sw="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function s_(n,e){return(t,i,s,r)=>r==null?jf:e(n(i))}function Mw(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function ww(n,e){return n.series[e].fill(n,e)}var Aw={show:!0,live:!0,isolate:!1,mount:WM,markers:{show:!0,width:2,stroke:Mw,fill:ww,dash:"solid"},idx:null,idxs:null,values:[]};function Tw(n,e){let t=n.cursor.points,i=ji(),s=t.size(n,e);an(i,dl,s),an(i,fl,s);let r=s/-2;an(i,"marginLeft",r),an(i,"marginTop",r);let o=t.width(n,e,s);return o&&an(i,"borderWidth",o),i}function Ew(n,e){let t=n.series[e].points;return t._fill||t._stroke}function Cw(n,e){let t=n.series[e].points;return t._stroke||t._fill}function Rw(n,e){return n.series[e].points.size}var Bf=[0,0];function Pw(n,e,t){return Bf[0]=e,Bf[1]=t,Bf}function jc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function zf(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var Iw={show:!0,x:!0,y:!0,lock:!1,move:Pw,points:{one:!1,show:Tw,size:Rw,width:0,stroke:Cw,fill:Ew},bind:{mousedown:jc,mouseup:jc,click:jc,dblclick:jc,mousemove:zf,mouseleave:zf,mouseenter:zf},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},k_={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},op=Pn({},k_,{filter:w_}),B_=Pn({},op,{size:10}),z_=Pn({},k_,{show:!1}),ap='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',V_="bold "+ap,H_=1.5,r_={show:!0,scale:"x",stroke:Zf,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:V_,side:2,grid:op,ticks:B_,border:z_,font:ap,lineGap:H_,rotate:0},Lw="Value",Dw="Time",o_={show:!0,scale:"x",auto:!1,sorted:1,min:Zt,max:-Zt,idxs:[]};function Nw(n,e,t,i,s){return e.map(r=>r==null?"":np(r))}function Ow(n,e,t,i,s,r,o){let a=[],l=Pr.get(s)||0;t=o?t:jt(ru(t,s),l);for(let c=t;c<=i;c=jt(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Xf(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Qs:b_,u=ki(c(t));s=Zo(l,u),l==10&&(s=fo[ds(s,fo)]);let d=t,h=s*l;l==10&&(h=fo[ds(h,fo)]);do a.push(d),d=d+s,l==10&&!Pr.has(d)&&(d=jt(d,Pr.get(s))),d>=h&&(s=d,h=s*l,l==10&&(h=fo[ds(h,fo)]));while(d<=i);return a}function Uw(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Xf(n,e,pi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Xf(n,e,pi(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var G_=/./,Fw=/[12357]/,kw=/[125]/,a_=/1/,qf=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Bw(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),d=l(9,o)-u>=c?G_:l(7,o)-u>=c?Fw:l(5,o)-u>=c?kw:a_;if(d==a_){let h=kn(l(1,o)-u);if(h<c)return qf(e.slice().reverse(),a.distr,d,Qi(c/h)).reverse()}return qf(e,a.distr,d,1)}function zw(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=kn(l(1,o)-l(2,o));return c<a?qf(e.slice().reverse(),3,G_,Qi(a/c)).reverse():e}function Vw(n,e,t,i){return i==null?jf:e==null?"":np(e)}var l_={show:!0,scale:"y",stroke:Zf,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:V_,side:3,grid:op,ticks:B_,border:z_,font:ap,lineGap:H_,rotate:0};function Hw(n,e){let t=3+(n||1)*2;return jt(t*e,3)}function Gw(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=kn(o-r),l=n.series[e],c=a/(l.points.space*Ut);return i[1]-i[0]<=c}var c_={scale:null,auto:!0,sorted:0,min:Zt,max:-Zt},W_=(n,e,t,i,s)=>s,u_={show:!0,auto:!0,sorted:0,gaps:W_,alpha:1,facets:[Pn({},c_,{scale:"x"}),Pn({},c_,{scale:"y"})]},h_={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:W_,alpha:1,points:{show:Gw,filter:null},values:null,min:Zt,max:-Zt,idxs:[],path:null,clip:null};function Ww(n,e,t,i,s){return t/10}var $_={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},$w=Pn({},$_,{time:!1,ori:1}),d_={};function X_(n,e){let t=d_[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(d_[n]=t)),t}var ea=1,Yf=2;function _o(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],d=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,f=a.top,p=a.width,v=a.height,g=n.valToPosH,_=n.valToPosV;return u.ori==0?t(s,l,c,u,d,g,_,h,f,p,v,lu,na,uu,Y_,K_):t(s,l,c,u,d,_,g,f,h,v,p,cu,ia,up,J_,Z_)}function lp(n,e){let t=0,i=0,s=It(n.bands,ip);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Xw(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function er(n,e,t,i,s,r){return _o(n,e,(o,a,l,c,u,d,h,f,p,v,g)=>{let _=o.pxRound,b=c.dir*(c.ori==0?1:-1),E=c.ori==0?na:ia,M,I;b==1?(M=t,I=i):(M=i,I=t);let C=_(d(a[M],c,v,f)),y=_(h(l[M],u,g,p)),T=_(d(a[I],c,v,f)),k=_(h(r==1?u.max:u.min,u,g,p)),D=new Path2D(s);return E(D,T,k),E(D,C,k),E(D,C,y),D})}function au(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?uu:up,l=t;for(let d=0;d<n.length;d++){let h=n[d];if(h[1]>h[0]){let f=h[0]-l;f>0&&a(o,l,i,f,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function qw(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function cp(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let d=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let f=r(n[d]),p=h==d?f:r(n[h]),v=d-s;f=o<=0&&v>=0&&v<l?r(n[v]):f;let _=h+s;p=o>=0&&_>=0&&_<l?r(n[_]):p,p>=f&&a.push([f,p])}return a}function f_(n){return n==0?M_:n==1?Fn:e=>ho(e,n)}function q_(n){let e=n==0?lu:cu,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=fs(c,a/2,l/2),u=fs(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var lu=(n,e,t)=>{n.moveTo(e,t)},cu=(n,e,t)=>{n.moveTo(t,e)},na=(n,e,t)=>{n.lineTo(e,t)},ia=(n,e,t)=>{n.lineTo(t,e)},uu=q_(0),up=q_(1),Y_=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},J_=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},K_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Z_=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function j_(n){return(e,t,i,s,r)=>_o(e,t,(o,a,l,c,u,d,h,f,p,v,g)=>{let{pxRound:_,points:b}=o,E,M;c.ori==0?(E=lu,M=Y_):(E=cu,M=J_);let I=jt(b.width*Ut,3),C=(b.size-b.width)/2*Ut,y=jt(C*2,3),T=new Path2D,k=new Path2D,{left:D,top:L,width:H,height:V}=e.bbox;uu(k,D-y,L-y,H+y*2,V+y*2);let O=$=>{if(l[$]!=null){let q=_(d(a[$],c,v,f)),G=_(h(l[$],u,g,p));E(T,q+C,G),M(T,q,G,C,0,Qc*2)}};if(r)r.forEach(O);else for(let $=i;$<=s;$++)O($);return{stroke:I>0?T:null,fill:T,clip:k,flags:ea|Yf}})}function Q_(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Yw=Q_(na),Jw=Q_(ia);function ey(n){let e=It(n?.alignGaps,0);return(t,i,s,r)=>_o(t,i,(o,a,l,c,u,d,h,f,p,v,g)=>{[s,r]=iu(l,s,r);let _=o.pxRound,b=V=>_(d(V,c,v,f)),E=V=>_(h(V,u,g,p)),M,I;c.ori==0?(M=na,I=Yw):(M=ia,I=Jw);let C=c.dir*(c.ori==0?1:-1),y={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ea},T=y.stroke,k=!1;if(r-s>=v*4){let V=ue=>t.posToVal(ue,c.key,!0),O=null,$=null,q,G,ce,K=b(a[C==1?s:r]),ee=b(a[s]),Y=b(a[r]),oe=V(C==1?ee+1:Y-1);for(let ue=C==1?s:r;ue>=s&&ue<=r;ue+=C){let te=a[ue],me=(C==1?te<oe:te>oe)?K:b(te),Ae=l[ue];me==K?Ae!=null?(G=Ae,O==null?(M(T,me,E(G)),q=O=$=G):G<O?O=G:G>$&&($=G)):Ae===null&&(k=!0):(O!=null&&I(T,K,E(O),E($),E(q),E(G)),Ae!=null?(G=Ae,M(T,me,E(G)),O=$=q=G):(O=$=null,Ae===null&&(k=!0)),K=me,oe=V(K+C))}O!=null&&O!=$&&ce!=K&&I(T,K,E(O),E($),E(q),E(G))}else for(let V=C==1?s:r;V>=s&&V<=r;V+=C){let O=l[V];O===null?k=!0:O!=null&&M(T,b(a[V]),E(O))}let[L,H]=lp(t,i);if(o.fill!=null||L!=0){let V=y.fill=new Path2D(T),O=o.fillTo(t,i,o.min,o.max,L),$=E(O),q=b(a[s]),G=b(a[r]);C==-1&&([G,q]=[q,G]),M(V,G,$),M(V,q,$)}if(!o.spanGaps){let V=[];k&&V.push(...cp(a,l,s,r,C,b,e)),y.gaps=V=o.gaps(t,i,s,r,V),y.clip=au(V,c.ori,f,p,v,g)}return H!=0&&(y.band=H==2?[er(t,i,s,r,T,-1),er(t,i,s,r,T,1)]:er(t,i,s,r,T,H)),y})}function Kw(n){let e=It(n.align,1),t=It(n.ascDesc,!1),i=It(n.alignGaps,0),s=It(n.extend,!1);return(r,o,a,l)=>_o(r,o,(c,u,d,h,f,p,v,g,_,b,E)=>{[a,l]=iu(d,a,l);let M=c.pxRound,{left:I,width:C}=r.bbox,y=ee=>M(p(ee,h,b,g)),T=ee=>M(v(ee,f,E,_)),k=h.ori==0?na:ia,D={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:ea},L=D.stroke,H=h.dir*(h.ori==0?1:-1),V=T(d[H==1?a:l]),O=y(u[H==1?a:l]),$=O,q=O;s&&e==-1&&(q=I,k(L,q,V)),k(L,O,V);for(let ee=H==1?a:l;ee>=a&&ee<=l;ee+=H){let Y=d[ee];if(Y==null)continue;let oe=y(u[ee]),ue=T(Y);e==1?k(L,oe,V):k(L,$,ue),k(L,oe,ue),V=ue,$=oe}let G=$;s&&e==1&&(G=I+C,k(L,G,V));let[ce,K]=lp(r,o);if(c.fill!=null||ce!=0){let ee=D.fill=new Path2D(L),Y=c.fillTo(r,o,c.min,c.max,ce),oe=T(Y);k(ee,G,oe),k(ee,q,oe)}if(!c.spanGaps){let ee=[];ee.push(...cp(u,d,a,l,H,y,i));let Y=c.width*Ut/2,oe=t||e==1?Y:-Y,ue=t||e==-1?-Y:Y;ee.forEach(te=>{te[0]+=oe,te[1]+=ue}),D.gaps=ee=c.gaps(r,o,a,l,ee),D.clip=au(ee,h.ori,g,_,b,E)}return K!=0&&(D.band=K==2?[er(r,o,a,l,L,-1),er(r,o,a,l,L,1)]:er(r,o,a,l,L,K)),D})}function p_(n,e,t,i,s,r,o=Zt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=kn(n[l]-n[a]);u<c&&(c=u,o=kn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Zw(n){n=n||gl;let e=It(n.size,[.6,Zt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=Mt(s),o=1-e[0],a=It(e[1],Zt),l=It(e[2],1),c=It(n.disp,gl),u=It(n.each,f=>{}),{fill:d,stroke:h}=c;return(f,p,v,g)=>_o(f,p,(_,b,E,M,I,C,y,T,k,D,L)=>{let H=_.pxRound,V=t,O=i*Ut,$=a*Ut,q=l*Ut,G,ce;M.ori==0?[G,ce]=r(f,p):[ce,G]=r(f,p);let K=M.dir*(M.ori==0?1:-1),ee=M.ori==0?uu:up,Y=M.ori==0?u:(Ee,Ke,at,we,Nt,ze,ye)=>{u(Ee,Ke,at,Nt,we,ye,ze)},oe=It(f.bands,ip).find(Ee=>Ee.series[0]==p),ue=oe!=null?oe.dir:0,te=_.fillTo(f,p,_.min,_.max,ue),_e=H(y(te,I,L,k)),me,Ae,be,qe=D,tt=H(_.width*Ut),Be=!1,ot=null,ut=null,Je=null,Vt=null;d!=null&&(tt==0||h!=null)&&(Be=!0,ot=d.values(f,p,v,g),ut=new Map,new Set(ot).forEach(Ee=>{Ee!=null&&ut.set(Ee,new Path2D)}),tt>0&&(Je=h.values(f,p,v,g),Vt=new Map,new Set(Je).forEach(Ee=>{Ee!=null&&Vt.set(Ee,new Path2D)})));let{x0:qt,size:dn}=c;if(qt!=null&&dn!=null){V=1,b=qt.values(f,p,v,g),qt.unit==2&&(b=b.map(at=>f.posToVal(T+at*D,M.key,!0)));let Ee=dn.values(f,p,v,g);dn.unit==2?Ae=Ee[0]*D:Ae=C(Ee[0],M,D,T)-C(0,M,D,T),qe=p_(b,E,C,M,D,T,qe),be=qe-Ae+O}else qe=p_(b,E,C,M,D,T,qe),be=qe*o+O,Ae=qe-be;be<1&&(be=0),tt>=Ae/2&&(tt=0),be<5&&(H=M_);let Dt=be>0,Nn=qe-be-(Dt?tt:0);Ae=H($f(Nn,q,$)),me=(V==0?Ae/2:V==K?0:Ae)-V*K*((V==0?O/2:0)+(Dt?tt/2:0));let At={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},un=Be?null:new Path2D,tn=null;if(oe!=null)tn=f.data[oe.series[1]];else{let{y0:Ee,y1:Ke}=c;Ee!=null&&Ke!=null&&(E=Ke.values(f,p,v,g),tn=Ee.values(f,p,v,g))}let fn=G*Ae,U=ce*Ae;for(let Ee=K==1?v:g;Ee>=v&&Ee<=g;Ee+=K){let Ke=E[Ee];if(Ke==null)continue;if(tn!=null){let X=tn[Ee]??0;if(Ke-X==0)continue;_e=y(X,I,L,k)}let at=M.distr!=2||c!=null?b[Ee]:Ee,we=C(at,M,D,T),Nt=y(It(Ke,te),I,L,k),ze=H(we-me),ye=H(pi(Nt,_e)),R=H(fs(Nt,_e)),S=ye-R;if(Ke!=null){let X=Ke<0?U:fn,de=Ke<0?fn:U;Be?(tt>0&&Je[Ee]!=null&&ee(Vt.get(Je[Ee]),ze,R+ki(tt/2),Ae,pi(0,S-tt),X,de),ot[Ee]!=null&&ee(ut.get(ot[Ee]),ze,R+ki(tt/2),Ae,pi(0,S-tt),X,de)):ee(un,ze,R+ki(tt/2),Ae,pi(0,S-tt),X,de),Y(f,p,Ee,ze-tt/2,R,Ae+tt,S)}}return tt>0?At.stroke=Be?Vt:un:Be||(At._fill=_.width==0?_._fill:_._stroke??_._fill,At.width=0),At.fill=Be?ut:un,At})}function jw(n,e){let t=It(e?.alignGaps,0);return(i,s,r,o)=>_o(i,s,(a,l,c,u,d,h,f,p,v,g,_)=>{[r,o]=iu(c,r,o);let b=a.pxRound,E=G=>b(h(G,u,g,p)),M=G=>b(f(G,d,_,v)),I,C,y;u.ori==0?(I=lu,y=na,C=K_):(I=cu,y=ia,C=Z_);let T=u.dir*(u.ori==0?1:-1),k=E(l[T==1?r:o]),D=k,L=[],H=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let K=l[G],ee=E(K);L.push(D=ee),H.push(M(c[G]))}let V={stroke:n(L,H,I,y,C,b),fill:null,clip:null,band:null,gaps:null,flags:ea},O=V.stroke,[$,q]=lp(i,s);if(a.fill!=null||$!=0){let G=V.fill=new Path2D(O),ce=a.fillTo(i,s,a.min,a.max,$),K=M(ce);y(G,D,K),y(G,k,K)}if(!a.spanGaps){let G=[];G.push(...cp(l,c,r,o,T,E,t)),V.gaps=G=a.gaps(i,s,r,o,G),V.clip=au(G,u.ori,p,v,g,_)}return q!=0&&(V.band=q==2?[er(i,s,r,o,O,-1),er(i,s,r,o,O,1)]:er(i,s,r,o,O,q)),V})}function Qw(n){return jw(e1,n)}function e1(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),d=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],d[h]=n[h+1]-n[h],c[h]=u[h]/d[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(d[h-1]+d[h])/((2*d[h]+d[h-1])/c[h-1]+(d[h]+2*d[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+d[h]/3,e[h]+l[h]*d[h]/3,n[h+1]-d[h]/3,e[h+1]-l[h+1]*d[h]/3,n[h+1],e[h+1])}return a}var Jf=new Set;function m_(){for(let n of Jf)n.syncRect(!0)}ta&&(mo(NM,Ko,m_),mo(OM,Ko,m_,!0),mo(eu,Ko,()=>{Zn.pxRatio=Ut}));var t1=ey(),n1=j_();function g_(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Kf(r,o,e,t))}function i1(n,e){return n.map((t,i)=>i==0?{}:Pn({},e,t))}function Kf(n,e,t,i){return Pn({},e==0?t:i,n)}function ty(n,e,t){return e==null?jo:[e,t]}var s1=ty;function r1(n,e,t){return e==null?jo:tu(e,t,tp,!0)}function ny(n,e,t,i){return e==null?jo:su(e,t,n.scales[i].log,!1)}var o1=ny;function iy(n,e,t,i){return e==null?jo:ep(e,t,n.scales[i].log,!1)}var a1=iy;function l1(n,e,t,i,s){let r=pi(Y0(n),Y0(e)),o=e-n,a=ds(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?Pr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function __(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Fn((t=+s)*Ut))+"px"),[n,e,t]}function c1(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=jt(e[2]*Ut,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Zn(n,e,t){let i={mode:It(n.mode,1)},s=i.mode;function r(x,w,P,N){let W=w.valToPct(x);return N+P*(w.dir==-1?1-W:W)}function o(x,w,P,N){let W=w.valToPct(x);return N+P*(w.dir==-1?W:1-W)}function a(x,w,P,N){return w.ori==0?r(x,w,P,N):o(x,w,P,N)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=ji(gM);if(n.id!=null&&(c.id=n.id),Fi(c,n.class),n.title){let x=ji(xM,c);x.textContent=n.title}let u=hs("canvas"),d=i.ctx=u.getContext("2d"),h=ji(vM,c);mo("click",h,x=>{x.target===p&&(sn!=Go||hn!=Wo)&&Kn.click(i,x)},!0);let f=i.under=ji(bM,h);h.appendChild(u);let p=i.over=ji(SM,h);n=Qo(n);let v=+It(n.pxAlign,1),g=f_(v);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let _=n.ms||.001,b=i.series=s==1?g_(n.series||[],o_,h_,!1):i1(n.series||[null],u_),E=i.axes=g_(n.axes||[],r_,l_,!0),M=i.scales={},I=i.bands=n.bands||[];I.forEach(x=>{x.fill=Mt(x.fill||null),x.dir=It(x.dir,-1)});let C=s==2?b[1].facets[0].scale:b[0].scale,y={axes:Ys,series:xt},T=(n.drawOrder||["axes","series"]).map(x=>y[x]);function k(x){let w=x.distr==3?P=>Qs(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>Ff(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let N=w(P),{_min:W,_max:j}=x,le=j-W;return(N-W)/le}}function D(x){let w=M[x];if(w==null){let P=(n.scales||gl)[x]||gl;if(P.from!=null){D(P.from);let N=Pn({},M[P.from],P,{key:x});N.valToPct=k(N),M[x]=N}else{w=M[x]=Pn({},x==C?$_:$w,P),w.key=x;let N=w.time,W=w.range,j=Rr(W);if((x!=C||s==2&&!N)&&(j&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?$0:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?$0:{mode:1,hard:W[1],soft:W[1]}},j=!1),!j&&ou(W))){let le=W;W=(pe,Me,Oe)=>Me==null?jo:tu(Me,Oe,le)}w.range=Mt(W||(N?s1:x==C?w.distr==3?o1:w.distr==4?a1:ty:w.distr==3?ny:w.distr==4?iy:r1)),w.auto=Mt(j?!1:w.auto),w.clamp=Mt(w.clamp||Ww),w._min=w._max=null,w.valToPct=k(w)}}}D("x"),D("y"),s==1&&b.forEach(x=>{D(x.scale)}),E.forEach(x=>{D(x.scale)});for(let x in n.scales)D(x);let L=M[C],H=L.distr,V,O;L.ori==0?(Fi(c,_M),V=r,O=o):(Fi(c,yM),V=o,O=r);let $={};for(let x in M){let w=M[x];(w.min!=null||w.max!=null)&&($[x]={min:w.min,max:w.max},w.min=w.max=null)}let q=n.tzDate||(x=>new Date(Fn(x/_))),G=n.fmtDate||sp,ce=_==1?_w(q):vw(q),K=n_(q,t_(_==1?gw:xw,G)),ee=s_(q,i_(Sw,G)),Y=[],oe=i.legend=Pn({},Aw,n.legend),ue=i.cursor=Pn({},Iw,{drag:{y:s==2}},n.cursor),te=oe.show,_e=ue.show,me=oe.markers;oe.idxs=Y,me.width=Mt(me.width),me.dash=Mt(me.dash),me.stroke=Mt(me.stroke),me.fill=Mt(me.fill);let Ae,be,qe,tt=[],Be=[],ot,ut=!1,Je={};if(oe.live){let x=b[1]?b[1].values:null;ut=x!=null,ot=ut?x(i,1,0):{_:0};for(let w in ot)Je[w]=jf}if(te)if(Ae=hs("table",CM,c),qe=hs("tbody",null,Ae),oe.mount(i,Ae),ut){be=hs("thead",null,Ae,qe);let x=hs("tr",null,be);hs("th",null,x);for(var Vt in ot)hs("th",L0,x).textContent=Vt}else Fi(Ae,PM),oe.live&&Fi(Ae,RM);let qt={show:!0},dn={show:!1};function Dt(x,w){if(w==0&&(ut||!oe.live||s==2))return jo;let P=[],N=hs("tr",IM,qe,qe.childNodes[w]);Fi(N,x.class),x.show||Fi(N,po);let W=hs("th",null,N);if(me.show){let pe=ji(LM,W);if(w>0){let Me=me.width(i,w);Me&&(pe.style.border=Me+"px "+me.dash(i,w)+" "+me.stroke(i,w)),pe.style.background=me.fill(i,w)}}let j=ji(L0,W);x.label instanceof HTMLElement?j.appendChild(x.label):j.textContent=x.label,w>0&&(me.show||(j.style.color=x.width>0?me.stroke(i,w):me.fill(i,w)),At("click",W,pe=>{if(ue._lock)return;nt(pe);let Me=b.indexOf(x);if((pe.ctrlKey||pe.metaKey)!=oe.isolate){let Oe=b.some((Ue,Ve)=>Ve>0&&Ve!=Me&&Ue.show);b.forEach((Ue,Ve)=>{Ve>0&&Es(Ve,Oe?Ve==Me?qt:dn:qt,!0,En.setSeries)})}else Es(Me,{show:!x.show},!0,En.setSeries)},!1),it&&At(U0,W,pe=>{ue._lock||(nt(pe),Es(b.indexOf(x),Xo,!0,En.setSeries))},!1));for(var le in ot){let pe=hs("td",DM,N);pe.textContent="--",P.push(pe)}return[N,P]}let Nn=new Map;function At(x,w,P,N=!0){let W=Nn.get(w)||{},j=ue.bind[x](i,w,P,N);j&&(mo(x,w,W[x]=j),Nn.set(w,W))}function un(x,w,P){let N=Nn.get(w)||{};for(let W in N)(x==null||W==x)&&(Wf(W,w,N[W]),delete N[W]);x==null&&Nn.delete(w)}let tn=0,fn=0,U=0,Ee=0,Ke=0,at=0,we=Ke,Nt=at,ze=U,ye=Ee,R=0,S=0,X=0,de=0;i.bbox={};let ae=!1,ve=!1,Se=!1,ne=!1,se=!1,ge=!1;function F(x,w,P){(P||x!=i.width||w!=i.height)&&re(x,w),gt(!1),Se=!0,ve=!0,si()}function re(x,w){i.width=tn=U=x,i.height=fn=Ee=w,Ke=at=0,Te(),Xe();let P=i.bbox;R=P.left=ho(Ke*Ut,.5),S=P.top=ho(at*Ut,.5),X=P.width=ho(U*Ut,.5),de=P.height=ho(Ee*Ut,.5)}let ie=3;function Ce(){let x=!1,w=0;for(;!x;){w++;let P=zo(w),N=Ts(w);x=w==ie||P&&N,x||(re(i.width,i.height),ve=!0)}}function xe({width:x,height:w}){F(x,w)}i.setSize=xe;function Te(){let x=!1,w=!1,P=!1,N=!1;E.forEach((W,j)=>{if(W.show&&W._show){let{side:le,_size:pe}=W,Me=le%2,Oe=W.label!=null?W.labelSize:0,Ue=pe+Oe;Ue>0&&(Me?(U-=Ue,le==3?(Ke+=Ue,N=!0):P=!0):(Ee-=Ue,le==0?(at+=Ue,x=!0):w=!0))}}),ws[0]=x,ws[1]=P,ws[2]=w,ws[3]=N,U-=rs[1]+rs[3],Ke+=rs[3],Ee-=rs[2]+rs[0],at+=rs[0]}function Xe(){let x=Ke+U,w=at+Ee,P=Ke,N=at;function W(j,le){switch(j){case 1:return x+=le,x-le;case 2:return w+=le,w-le;case 3:return P-=le,P+le;case 0:return N-=le,N+le}}E.forEach((j,le)=>{if(j.show&&j._show){let pe=j.side;j._pos=W(pe,j._size),j.label!=null&&(j._lpos=W(pe,j.labelSize))}})}if(ue.dataIdx==null){let x=ue.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let P=x.prox=Mt(x.prox),N=x.bias??=0;ue.dataIdx=(W,j,le,pe)=>{if(j==0)return le;let Me=le,Oe=P(W,j,le,pe)??Zt,Ue=Oe>=0&&Oe<Zt,Ve=L.ori==0?U:Ee,ht=ue.left,Ot=e[0],Rt=e[j];if(w.has(Rt[le])){Me=null;let bt=null,Qe=null,Ye;if(N==0||N==-1)for(Ye=le;bt==null&&Ye-- >0;)w.has(Rt[Ye])||(bt=Ye);if(N==0||N==1)for(Ye=le;Qe==null&&Ye++<Rt.length;)w.has(Rt[Ye])||(Qe=Ye);if(bt!=null||Qe!=null)if(Ue){let on=bt==null?-1/0:V(Ot[bt],L,Ve,0),yn=Qe==null?1/0:V(Ot[Qe],L,Ve,0),Xn=ht-on,Yt=yn-ht;Xn<=Yt?Xn<=Oe&&(Me=bt):Yt<=Oe&&(Me=Qe)}else Me=Qe==null?bt:bt==null?Qe:le-bt<=Qe-le?bt:Qe}else Ue&&kn(ht-V(Ot[le],L,Ve,0))>Oe&&(Me=null);return Me}}let nt=x=>{ue.event=x};ue.idxs=Y,ue._lock=!1;let he=ue.points;he.show=Mt(he.show),he.size=Mt(he.size),he.stroke=Mt(he.stroke),he.width=Mt(he.width),he.fill=Mt(he.fill);let He=i.focus=Pn({},n.focus||{alpha:.3},ue.focus),it=He.prox>=0,Ie=it&&he.one,mt=[],nn=[],ci=[];function Ka(x,w){let P=he.show(i,w);if(P instanceof HTMLElement)return Fi(P,EM),Fi(P,x.class),Is(P,-10,-10,U,Ee),p.insertBefore(P,mt[w]),P}function Fo(x,w){if(s==1||w>0){let P=s==1&&M[x.scale].time,N=x.value;x.value=P?Z0(N)?s_(q,i_(N,G)):N||ee:N||Vw,x.label=x.label||(P?Dw:Lw)}if(Ie||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||t1||$M,x.fillTo=Mt(x.fillTo||Xw),x.pxAlign=+It(x.pxAlign,v),x.pxRound=f_(x.pxAlign),x.stroke=Mt(x.stroke||null),x.fill=Mt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=Hw(pi(1,x.width),1),N=x.points=Pn({},{size:P,width:pi(1,P*.2),stroke:x.stroke,space:P*2,paths:n1,_stroke:null,_fill:null},x.points);N.show=Mt(N.show),N.filter=Mt(N.filter),N.fill=Mt(N.fill),N.stroke=Mt(N.stroke),N.paths=Mt(N.paths),N.pxAlign=x.pxAlign}if(te){let P=Dt(x,w);tt.splice(w,0,P[0]),Be.splice(w,0,P[1]),oe.values.push(null)}if(_e){Y.splice(w,0,null);let P=null;Ie?w==0&&(P=Ka(x,w)):w>0&&(P=Ka(x,w)),mt.splice(w,0,P),nn.splice(w,0,0),ci.splice(w,0,0)}$n("addSeries",w)}function of(x,w){w=w??b.length,x=s==1?Kf(x,w,o_,h_):Kf(x,w,{},u_),b.splice(w,0,x),Fo(b[w],w)}i.addSeries=of;function Ec(x){if(b.splice(x,1),te){oe.values.splice(x,1),Be.splice(x,1);let w=tt.splice(x,1)[0];un(null,w.firstChild),w.remove()}_e&&(Y.splice(x,1),mt.splice(x,1)[0].remove(),nn.splice(x,1),ci.splice(x,1)),$n("delSeries",x)}i.delSeries=Ec;let ws=[!1,!1,!1,!1];function $s(x,w){if(x._show=x.show,x.show){let P=x.side%2,N=M[x.scale];N==null&&(x.scale=P?b[1].scale:C,N=M[x.scale]);let W=N.time;x.size=Mt(x.size),x.space=Mt(x.space),x.rotate=Mt(x.rotate),Rr(x.incrs)&&x.incrs.forEach(le=>{!Pr.has(le)&&Pr.set(le,T_(le))}),x.incrs=Mt(x.incrs||(N.distr==2?fw:W?_==1?mw:yw:fo)),x.splits=Mt(x.splits||(W&&N.distr==1?ce:N.distr==3?Xf:N.distr==4?Uw:Ow)),x.stroke=Mt(x.stroke),x.grid.stroke=Mt(x.grid.stroke),x.ticks.stroke=Mt(x.ticks.stroke),x.border.stroke=Mt(x.border.stroke);let j=x.values;x.values=Rr(j)&&!Rr(j[0])?Mt(j):W?Rr(j)?n_(q,t_(j,G)):Z0(j)?bw(q,j):j||K:j||Nw,x.filter=Mt(x.filter||(N.distr>=3&&N.log==10?Bw:N.distr==3&&N.log==2?zw:w_)),x.font=__(x.font),x.labelFont=__(x.labelFont),x._size=x.size(i,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(ws[w]=!0,x._el=ji(MM,h))}}function Xs(x,w,P,N){let[W,j,le,pe]=P,Me=w%2,Oe=0;return Me==0&&(pe||j)&&(Oe=w==0&&!W||w==2&&!le?Fn(r_.size/3):0),Me==1&&(W||le)&&(Oe=w==1&&!j||w==3&&!pe?Fn(l_.size/2):0),Oe}let Za=i.padding=(n.padding||[Xs,Xs,Xs,Xs]).map(x=>Mt(It(x,Xs))),rs=i._padding=Za.map((x,w)=>x(i,w,ws,0)),gn,vn=null,bn=null,As=s==1?b[0].idxs:null,Di=null,xr=!1;function ja(x,w){if(e=x??[],i.data=i._data=e,s==2){gn=0;for(let P=1;P<b.length;P++)gn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),Di=e[0],gn=Di.length;let P=e;if(H==2){P=e.slice();let N=P[0]=Array(gn);for(let W=0;W<gn;W++)N[W]=W}i._data=e=P}if(gt(!0),$n("setData"),H==2&&(Se=!0),w!==!1){let P=L;P.auto(i,xr)?Qa():Sr(C,P.min,P.max),ne=ne||ue.left>=0,ge=!0,si()}}i.setData=ja;function Qa(){xr=!0;let x,w;s==1&&(gn>0?(vn=As[0]=0,bn=As[1]=gn-1,x=e[0][vn],w=e[0][bn],H==2?(x=vn,w=bn):x==w&&(H==3?[x,w]=su(x,x,L.log,!1):H==4?[x,w]=ep(x,x,L.log,!1):L.time?w=x+Fn(86400/_):[x,w]=tu(x,w,tp,!0))):(vn=As[0]=x=null,bn=As[1]=w=null)),Sr(C,x,w)}let ko,vr,Bo,A,z,Q,J,Z,Re,De;function Pe(x,w,P,N,W,j){x??=N0,P??=ip,N??="butt",W??=N0,j??="round",x!=ko&&(d.strokeStyle=ko=x),W!=vr&&(d.fillStyle=vr=W),w!=Bo&&(d.lineWidth=Bo=w),j!=z&&(d.lineJoin=z=j),N!=Q&&(d.lineCap=Q=N),P!=A&&d.setLineDash(A=P)}function Ne(x,w,P,N){w!=vr&&(d.fillStyle=vr=w),x!=J&&(d.font=J=x),P!=Z&&(d.textAlign=Z=P),N!=Re&&(d.textBaseline=Re=N)}function We(x,w,P,N,W=0){if(N.length>0&&x.auto(i,xr)&&(w==null||w.min==null)){let j=It(vn,0),le=It(bn,N.length-1),pe=P.min==null?BM(N,j,le,W,x.distr==3):[P.min,P.max];x.min=fs(x.min,P.min=pe[0]),x.max=pi(x.max,P.max=pe[1])}}let st={min:null,max:null};function yt(){for(let N in M){let W=M[N];$[N]==null&&(W.min==null||$[C]!=null&&W.auto(i,xr))&&($[N]=st)}for(let N in M){let W=M[N];$[N]==null&&W.from!=null&&$[W.from]!=null&&($[N]=st)}$[C]!=null&&gt(!0);let x={};for(let N in $){let W=$[N];if(W!=null){let j=x[N]=Qo(M[N],YM);if(W.min!=null)Pn(j,W);else if(N!=C||s==2)if(gn==0&&j.from==null){let le=j.range(i,null,null,N);j.min=le[0],j.max=le[1]}else j.min=Zt,j.max=-Zt}}if(gn>0){b.forEach((N,W)=>{if(s==1){let j=N.scale,le=$[j];if(le==null)return;let pe=x[j];if(W==0){let Me=pe.range(i,pe.min,pe.max,j);pe.min=Me[0],pe.max=Me[1],vn=ds(pe.min,e[0]),bn=ds(pe.max,e[0]),bn-vn>1&&(e[0][vn]<pe.min&&vn++,e[0][bn]>pe.max&&bn--),N.min=Di[vn],N.max=Di[bn]}else N.show&&N.auto&&We(pe,le,N,e[W],N.sorted);N.idxs[0]=vn,N.idxs[1]=bn}else if(W>0&&N.show&&N.auto){let[j,le]=N.facets,pe=j.scale,Me=le.scale,[Oe,Ue]=e[W],Ve=x[pe],ht=x[Me];Ve!=null&&We(Ve,$[pe],j,Oe,j.sorted),ht!=null&&We(ht,$[Me],le,Ue,le.sorted),N.min=le.min,N.max=le.max}});for(let N in x){let W=x[N],j=$[N];if(W.from==null&&(j==null||j.min==null)){let le=W.range(i,W.min==Zt?null:W.min,W.max==-Zt?null:W.max,N);W.min=le[0],W.max=le[1]}}}for(let N in x){let W=x[N];if(W.from!=null){let j=x[W.from];if(j.min==null)W.min=W.max=null;else{let le=W.range(i,j.min,j.max,N);W.min=le[0],W.max=le[1]}}}let w={},P=!1;for(let N in x){let W=x[N],j=M[N];if(j.min!=W.min||j.max!=W.max){j.min=W.min,j.max=W.max;let le=j.distr;j._min=le==3?Qs(j.min):le==4?Ff(j.min,j.asinh):le==100?j.fwd(j.min):j.min,j._max=le==3?Qs(j.max):le==4?Ff(j.max,j.asinh):le==100?j.fwd(j.max):j.max,w[N]=P=!0}}if(P){b.forEach((N,W)=>{s==2?W>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)Se=!0,$n("setScale",N);_e&&ue.left>=0&&(ne=ge=!0)}for(let N in $)$[N]=null}function Ge(x){let w=$f(vn-1,0,gn-1),P=$f(bn+1,0,gn-1);for(;x[w]==null&&w>0;)w--;for(;x[P]==null&&P<gn-1;)P++;return[w,P]}function xt(){if(gn>0){let x=b.some(w=>w._focus)&&De!=He.alpha;x&&(d.globalAlpha=De=He.alpha),b.forEach((w,P)=>{if(P>0&&w.show&&(pn(P,!1),pn(P,!0),w._paths==null)){let N=De;De!=w.alpha&&(d.globalAlpha=De=w.alpha);let W=s==2?[0,e[P][0].length-1]:Ge(e[P]);w._paths=w.paths(i,P,W[0],W[1]),De!=N&&(d.globalAlpha=De=N)}}),b.forEach((w,P)=>{if(P>0&&w.show){let N=De;De!=w.alpha&&(d.globalAlpha=De=w.alpha),w._paths!=null&&Ht(P,!1);{let W=w._paths!=null?w._paths.gaps:null,j=w.points.show(i,P,vn,bn,W),le=w.points.filter(i,P,j,W);(j||le)&&(w.points._paths=w.points.paths(i,P,vn,bn,le),Ht(P,!0))}De!=N&&(d.globalAlpha=De=N),$n("drawSeries",P)}}),x&&(d.globalAlpha=De=1)}}function pn(x,w){let P=w?b[x].points:b[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function Ht(x,w){let P=w?b[x].points:b[x],{stroke:N,fill:W,clip:j,flags:le,_stroke:pe=P._stroke,_fill:Me=P._fill,_width:Oe=P.width}=P._paths;Oe=jt(Oe*Ut,3);let Ue=null,Ve=Oe%2/2;w&&Me==null&&(Me=Oe>0?"#fff":pe);let ht=P.pxAlign==1&&Ve>0;if(ht&&d.translate(Ve,Ve),!w){let Ot=R-Oe/2,Rt=S-Oe/2,bt=X+Oe,Qe=de+Oe;Ue=new Path2D,Ue.rect(Ot,Rt,bt,Qe)}w?Fe(pe,Oe,P.dash,P.cap,Me,N,W,le,j):Gt(x,pe,Oe,P.dash,P.cap,Me,N,W,le,Ue,j),ht&&d.translate(-Ve,-Ve)}function Gt(x,w,P,N,W,j,le,pe,Me,Oe,Ue){let Ve=!1;Me!=0&&I.forEach((ht,Ot)=>{if(ht.series[0]==x){let Rt=b[ht.series[1]],bt=e[ht.series[1]],Qe=(Rt._paths||gl).band;Rr(Qe)&&(Qe=ht.dir==1?Qe[0]:Qe[1]);let Ye,on=null;Rt.show&&Qe&&VM(bt,vn,bn)?(on=ht.fill(i,Ot)||j,Ye=Rt._paths.clip):Qe=null,Fe(w,P,N,W,on,le,pe,Me,Oe,Ue,Ye,Qe),Ve=!0}}),Ve||Fe(w,P,N,W,j,le,pe,Me,Oe,Ue)}let On=ea|Yf;function Fe(x,w,P,N,W,j,le,pe,Me,Oe,Ue,Ve){Pe(x,w,P,N,W),(Me||Oe||Ve)&&(d.save(),Me&&d.clip(Me),Oe&&d.clip(Oe)),Ve?(pe&On)==On?(d.clip(Ve),Ue&&d.clip(Ue),St(W,le),wn(x,j,w)):pe&Yf?(St(W,le),d.clip(Ve),wn(x,j,w)):pe&ea&&(d.save(),d.clip(Ve),Ue&&d.clip(Ue),St(W,le),d.restore(),wn(x,j,w)):(St(W,le),wn(x,j,w)),(Me||Oe||Ve)&&d.restore()}function wn(x,w,P){P>0&&(w instanceof Map?w.forEach((N,W)=>{d.strokeStyle=ko=W,d.stroke(N)}):w!=null&&x&&d.stroke(w))}function St(x,w){w instanceof Map?w.forEach((P,N)=>{d.fillStyle=vr=N,d.fill(P)}):w!=null&&x&&d.fill(w)}function qs(x,w,P,N){let W=E[x],j;if(N<=0)j=[0,0];else{let le=W._space=W.space(i,x,w,P,N),pe=W._incrs=W.incrs(i,x,w,P,N,le);j=l1(w,P,pe,N,le)}return W._found=j}function An(x,w,P,N,W,j,le,pe,Me,Oe){let Ue=le%2/2;v==1&&d.translate(Ue,Ue),Pe(pe,le,Me,Oe,pe),d.beginPath();let Ve,ht,Ot,Rt,bt=W+(N==0||N==3?-j:j);P==0?(ht=W,Rt=bt):(Ve=W,Ot=bt);for(let Qe=0;Qe<x.length;Qe++)w[Qe]!=null&&(P==0?Ve=Ot=x[Qe]:ht=Rt=x[Qe],d.moveTo(Ve,ht),d.lineTo(Ot,Rt));d.stroke(),v==1&&d.translate(-Ue,-Ue)}function zo(x){let w=!0;return E.forEach((P,N)=>{if(!P.show)return;let W=M[P.scale];if(W.min==null){P._show&&(w=!1,P._show=!1,gt(!1));return}else P._show||(w=!1,P._show=!0,gt(!1));let j=P.side,le=j%2,{min:pe,max:Me}=W,[Oe,Ue]=qs(N,pe,Me,le==0?U:Ee);if(Ue==0)return;let Ve=W.distr==2,ht=P._splits=P.splits(i,N,pe,Me,Oe,Ue,Ve),Ot=W.distr==2?ht.map(Ye=>Di[Ye]):ht,Rt=W.distr==2?Di[ht[1]]-Di[ht[0]]:Oe,bt=P._values=P.values(i,P.filter(i,Ot,N,Ue,Rt),N,Ue,Rt);P._rotate=j==2?P.rotate(i,bt,N,Ue):0;let Qe=P._size;P._size=Qi(P.size(i,bt,N,x)),Qe!=null&&P._size!=Qe&&(w=!1)}),w}function Ts(x){let w=!0;return Za.forEach((P,N)=>{let W=P(i,N,ws,x);W!=rs[N]&&(w=!1),rs[N]=W}),w}function Ys(){for(let x=0;x<E.length;x++){let w=E[x];if(!w.show||!w._show)continue;let P=w.side,N=P%2,W,j,le=w.stroke(i,x),pe=P==0||P==3?-1:1,[Me,Oe]=w._found;if(w.label!=null){let di=w.labelGap*pe,Ui=Fn((w._lpos+di)*Ut);Ne(w.labelFont[0],le,"center",P==2?"top":D0),d.save(),N==1?(W=j=0,d.translate(Ui,Fn(S+de/2)),d.rotate((P==3?-Qc:Qc)/2)):(W=Fn(R+X/2),j=Ui);let ao=S_(w.label)?w.label(i,x,Me,Oe):w.label;d.fillText(ao,W,j),d.restore()}if(Oe==0)continue;let Ue=M[w.scale],Ve=N==0?X:de,ht=N==0?R:S,Ot=w._splits,Rt=Ue.distr==2?Ot.map(di=>Di[di]):Ot,bt=Ue.distr==2?Di[Ot[1]]-Di[Ot[0]]:Me,Qe=w.ticks,Ye=w.border,on=Qe.show?Qe.size:0,yn=Fn(on*Ut),Xn=Fn((w.alignTo==2?w._size-on-w.gap:w.gap)*Ut),Yt=w._rotate*-Qc/180,xn=g(w._pos*Ut),Ni=(yn+Xn)*pe,hi=xn+Ni;j=N==0?hi:0,W=N==1?hi:0;let Ki=w.font[0],os=w.align==1?Yo:w.align==2?Nf:Yt>0?Yo:Yt<0?Nf:N==0?"center":P==3?Nf:Yo,Rs=Yt||N==1?"middle":P==2?"top":D0;Ne(Ki,le,os,Rs);let Oi=w.font[1]*w.lineGap,Zi=Ot.map(di=>g(a(di,Ue,Ve,ht))),as=w._values;for(let di=0;di<as.length;di++){let Ui=as[di];if(Ui!=null){N==0?W=Zi[di]:j=Zi[di],Ui=""+Ui;let ao=Ui.indexOf(`
`)==-1?[Ui]:Ui.split(/\n/gm);for(let fi=0;fi<ao.length;fi++){let Xg=ao[fi];Yt?(d.save(),d.translate(W,j+fi*Oi),d.rotate(Yt),d.fillText(Xg,0,0),d.restore()):d.fillText(Xg,W,j+fi*Oi)}}}Qe.show&&An(Zi,Qe.filter(i,Rt,x,Oe,bt),N,P,xn,yn,jt(Qe.width*Ut,3),Qe.stroke(i,x),Qe.dash,Qe.cap);let Ps=w.grid;Ps.show&&An(Zi,Ps.filter(i,Rt,x,Oe,bt),N,N==0?2:1,N==0?S:R,N==0?de:X,jt(Ps.width*Ut,3),Ps.stroke(i,x),Ps.dash,Ps.cap),Ye.show&&An([xn],[1],N==0?1:0,N==0?1:2,N==1?S:R,N==1?de:X,jt(Ye.width*Ut,3),Ye.stroke(i,x),Ye.dash,Ye.cap)}$n("drawAxes")}function gt(x){b.forEach((w,P)=>{P>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let _n=!1,ui=!1,Wt=[];function Tn(){ui=!1;for(let x=0;x<Wt.length;x++)$n(...Wt[x]);Wt.length=0}function si(){_n||(tw(Cg),_n=!0)}function Cc(x,w=!1){_n=!0,ui=w,x(i),Cg(),w&&Wt.length>0&&queueMicrotask(Tn)}i.batch=Cc;function Cg(){if(ae&&(yt(),ae=!1),Se&&(Ce(),Se=!1),ve){if(an(f,Yo,Ke),an(f,"top",at),an(f,dl,U),an(f,fl,Ee),an(p,Yo,Ke),an(p,"top",at),an(p,dl,U),an(p,fl,Ee),an(h,dl,tn),an(h,fl,fn),u.width=Fn(tn*Ut),u.height=Fn(fn*Ut),E.forEach(({_el:x,_show:w,_size:P,_pos:N,side:W})=>{if(x!=null)if(w){let j=W===3||W===0?P:0,le=W%2==1;an(x,le?"left":"top",N-j),an(x,le?"width":"height",P),an(x,le?"top":"left",le?at:Ke),an(x,le?"height":"width",le?Ee:U),Gf(x,po)}else Fi(x,po)}),ko=vr=Bo=z=Q=J=Z=Re=A=null,De=1,nl(!0),Ke!=we||at!=Nt||U!=ze||Ee!=ye){gt(!1);let x=U/ze,w=Ee/ye;if(_e&&!ne&&ue.left>=0){ue.left*=x,ue.top*=w,Vo&&Is(Vo,Fn(ue.left),0,U,Ee),Ho&&Is(Ho,0,Fn(ue.top),U,Ee);for(let P=0;P<mt.length;P++){let N=mt[P];N!=null&&(nn[P]*=x,ci[P]*=w,Is(N,Qi(nn[P]),Qi(ci[P]),U,Ee))}}if(rn.show&&!se&&rn.left>=0&&rn.width>0){rn.left*=x,rn.width*=x,rn.top*=w,rn.height*=w;for(let P in df)an($o,P,rn[P])}we=Ke,Nt=at,ze=U,ye=Ee}$n("setSize"),ve=!1}tn>0&&fn>0&&(d.clearRect(0,0,u.width,u.height),$n("drawClear"),T.forEach(x=>x()),$n("draw")),rn.show&&se&&(Rc(rn),se=!1),_e&&ne&&(oo(null,!0,!1),ne=!1),oe.show&&oe.live&&ge&&(uf(),ge=!1),l||(l=!0,i.status=1,$n("ready")),xr=!1,_n=!1}i.redraw=(x,w)=>{Se=w||!1,x!==!1?Sr(C,L.min,L.max):si()};function af(x,w){let P=M[x];if(P.from==null){if(gn==0){let N=P.range(i,w.min,w.max,x);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(gn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==C&&P.distr==2&&gn>0&&(w.min=ds(w.min,e[0]),w.max=ds(w.max,e[0]),w.min==w.max&&w.max++),$[x]=w,ae=!0,si()}}i.setScale=af;let lf,cf,Vo,Ho,Rg,Pg,Go,Wo,Ig,Lg,sn,hn,br=!1,Kn=ue.drag,Gn=Kn.x,Wn=Kn.y;_e&&(ue.x&&(lf=ji(AM,p)),ue.y&&(cf=ji(TM,p)),L.ori==0?(Vo=lf,Ho=cf):(Vo=cf,Ho=lf),sn=ue.left,hn=ue.top);let rn=i.select=Pn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),$o=rn.show?ji(wM,rn.over?p:f):null;function Rc(x,w){if(rn.show){for(let P in x)rn[P]=x[P],P in df&&an($o,P,x[P]);w!==!1&&$n("setSelect")}}i.setSelect=Rc;function BS(x){if(b[x].show)te&&Gf(tt[x],po);else if(te&&Fi(tt[x],po),_e){let P=Ie?mt[0]:mt[x];P!=null&&Is(P,-10,-10,U,Ee)}}function Sr(x,w,P){af(x,{min:w,max:P})}function Es(x,w,P,N){w.focus!=null&&WS(x),w.show!=null&&b.forEach((W,j)=>{j>0&&(x==j||x==null)&&(W.show=w.show,BS(j),s==2?(Sr(W.facets[0].scale,null,null),Sr(W.facets[1].scale,null,null)):Sr(W.scale,null,null),si())}),P!==!1&&$n("setSeries",x,w),N&&il("setSeries",i,x,w)}i.setSeries=Es;function zS(x,w){Pn(I[x],w)}function VS(x,w){x.fill=Mt(x.fill||null),x.dir=It(x.dir,-1),w=w??I.length,I.splice(w,0,x)}function HS(x){x==null?I.length=0:I.splice(x,1)}i.addBand=VS,i.setBand=zS,i.delBand=HS;function GS(x,w){b[x].alpha=w,_e&&mt[x]!=null&&(mt[x].style.opacity=w),te&&tt[x]&&(tt[x].style.opacity=w)}let Js,Mr,ro,Xo={focus:!0};function WS(x){if(x!=ro){let w=x==null,P=He.alpha!=1;b.forEach((N,W)=>{if(s==1||W>0){let j=w||W==0||W==x;N._focus=w?null:j,P&&GS(W,j?1:He.alpha)}}),ro=x,P&&si()}}te&&it&&At(F0,Ae,x=>{ue._lock||(nt(x),ro!=null&&Es(null,Xo,!0,En.setSeries))});function Cs(x,w,P){let N=M[w];P&&(x=x/Ut-(N.ori==1?at:Ke));let W=U;N.ori==1&&(W=Ee,x=W-x),N.dir==-1&&(x=W-x);let j=N._min,le=N._max,pe=x/W,Me=j+(le-j)*pe,Oe=N.distr;return Oe==3?Zo(10,Me):Oe==4?GM(Me,N.asinh):Oe==100?N.bwd(Me):Me}function $S(x,w){let P=Cs(x,C,w);return ds(P,e[0],vn,bn)}i.valToIdx=x=>ds(x,e[0]),i.posToIdx=$S,i.posToVal=Cs,i.valToPos=(x,w,P)=>M[w].ori==0?r(x,M[w],P?X:U,P?R:0):o(x,M[w],P?de:Ee,P?S:0),i.setCursor=(x,w,P)=>{sn=x.left,hn=x.top,oo(null,w,P)};function Dg(x,w){an($o,Yo,rn.left=x),an($o,dl,rn.width=w)}function Ng(x,w){an($o,"top",rn.top=x),an($o,fl,rn.height=w)}let el=L.ori==0?Dg:Ng,tl=L.ori==1?Dg:Ng;function XS(){if(te&&oe.live)for(let x=s==2?1:0;x<b.length;x++){if(x==0&&ut)continue;let w=oe.values[x],P=0;for(let N in w)Be[x][P++].firstChild.nodeValue=w[N]}}function uf(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((P,N)=>{Y[N]=P}):qM(x.idx)||Y.fill(x.idx),oe.idx=Y[0]),te&&oe.live){for(let P=0;P<b.length;P++)(P>0||s==1&&!ut)&&qS(P,Y[P]);XS()}ge=!1,w!==!1&&$n("setLegend")}i.setLegend=uf;function qS(x,w){let P=b[x],N=x==0&&H==2?Di:e[x],W;ut?W=P.values(i,x,w)??Je:(W=P.value(i,w==null?null:N[w],x,w),W=W==null?Je:{_:W}),oe.values[x]=W}function oo(x,w,P){Ig=sn,Lg=hn,[sn,hn]=ue.move(i,sn,hn),ue.left=sn,ue.top=hn,_e&&(Vo&&Is(Vo,Fn(sn),0,U,Ee),Ho&&Is(Ho,0,Fn(hn),U,Ee));let N,W=vn>bn;Js=Zt,Mr=null;let j=L.ori==0?U:Ee,le=L.ori==1?U:Ee;if(sn<0||gn==0||W){N=ue.idx=null;for(let pe=0;pe<b.length;pe++){let Me=mt[pe];Me!=null&&Is(Me,-10,-10,U,Ee)}it&&Es(null,Xo,!0,x==null&&En.setSeries),oe.live&&(Y.fill(N),ge=!0)}else{let pe,Me,Oe;s==1&&(pe=L.ori==0?sn:hn,Me=Cs(pe,C),N=ue.idx=ds(Me,e[0],vn,bn),Oe=V(e[0][N],L,j,0));let Ue=-10,Ve=-10,ht=0,Ot=0,Rt=!0,bt="",Qe="";for(let Ye=s==2?1:0;Ye<b.length;Ye++){let on=b[Ye],yn=Y[Ye],Xn=yn==null?null:s==1?e[Ye][yn]:e[Ye][1][yn],Yt=ue.dataIdx(i,Ye,N,Me),xn=Yt==null?null:s==1?e[Ye][Yt]:e[Ye][1][Yt];if(ge=ge||xn!=Xn||Yt!=yn,Y[Ye]=Yt,Ye>0&&on.show){let Ni=Yt==null?-10:Yt==N?Oe:V(s==1?e[0][Yt]:e[Ye][0][Yt],L,j,0),hi=xn==null?-10:O(xn,s==1?M[on.scale]:M[on.facets[1].scale],le,0);if(it&&xn!=null){let Ki=L.ori==1?sn:hn,os=kn(He.dist(i,Ye,Yt,hi,Ki));if(os<Js){let Rs=He.bias;if(Rs!=0){let Oi=Cs(Ki,on.scale),Zi=xn>=0?1:-1,as=Oi>=0?1:-1;as==Zi&&(as==1?Rs==1?xn>=Oi:xn<=Oi:Rs==1?xn<=Oi:xn>=Oi)&&(Js=os,Mr=Ye)}else Js=os,Mr=Ye}}if(ge||Ie){let Ki,os;L.ori==0?(Ki=Ni,os=hi):(Ki=hi,os=Ni);let Rs,Oi,Zi,as,Ps,di,Ui=!0,ao=he.bbox;if(ao!=null){Ui=!1;let fi=ao(i,Ye);Zi=fi.left,as=fi.top,Rs=fi.width,Oi=fi.height}else Zi=Ki,as=os,Rs=Oi=he.size(i,Ye);if(di=he.fill(i,Ye),Ps=he.stroke(i,Ye),Ie)Ye==Mr&&Js<=He.prox&&(Ue=Zi,Ve=as,ht=Rs,Ot=Oi,Rt=Ui,bt=di,Qe=Ps);else{let fi=mt[Ye];fi!=null&&(nn[Ye]=Zi,ci[Ye]=as,W0(fi,Rs,Oi,Ui),H0(fi,di,Ps),Is(fi,Qi(Zi),Qi(as),U,Ee))}}}}if(Ie){let Ye=He.prox,on=ro==null?Js<=Ye:Js>Ye||Mr!=ro;if(ge||on){let yn=mt[0];yn!=null&&(nn[0]=Ue,ci[0]=Ve,W0(yn,ht,Ot,Rt),H0(yn,bt,Qe),Is(yn,Qi(Ue),Qi(Ve),U,Ee))}}}if(rn.show&&br)if(x!=null){let[pe,Me]=En.scales,[Oe,Ue]=En.match,[Ve,ht]=x.cursor.sync.scales,Ot=x.cursor.drag;if(Gn=Ot._x,Wn=Ot._y,Gn||Wn){let{left:Rt,top:bt,width:Qe,height:Ye}=x.select,on=x.scales[Ve].ori,yn=x.posToVal,Xn,Yt,xn,Ni,hi,Ki=pe!=null&&Oe(pe,Ve),os=Me!=null&&Ue(Me,ht);Ki&&Gn?(on==0?(Xn=Rt,Yt=Qe):(Xn=bt,Yt=Ye),xn=M[pe],Ni=V(yn(Xn,Ve),xn,j,0),hi=V(yn(Xn+Yt,Ve),xn,j,0),el(fs(Ni,hi),kn(hi-Ni))):el(0,j),os&&Wn?(on==1?(Xn=Rt,Yt=Qe):(Xn=bt,Yt=Ye),xn=M[Me],Ni=O(yn(Xn,ht),xn,le,0),hi=O(yn(Xn+Yt,ht),xn,le,0),tl(fs(Ni,hi),kn(hi-Ni))):tl(0,le)}else ff()}else{let pe=kn(Ig-Rg),Me=kn(Lg-Pg);if(L.ori==1){let ht=pe;pe=Me,Me=ht}Gn=Kn.x&&pe>=Kn.dist,Wn=Kn.y&&Me>=Kn.dist;let Oe=Kn.uni;Oe!=null?Gn&&Wn&&(Gn=pe>=Oe,Wn=Me>=Oe,!Gn&&!Wn&&(Me>pe?Wn=!0:Gn=!0)):Kn.x&&Kn.y&&(Gn||Wn)&&(Gn=Wn=!0);let Ue,Ve;Gn&&(L.ori==0?(Ue=Go,Ve=sn):(Ue=Wo,Ve=hn),el(fs(Ue,Ve),kn(Ve-Ue)),Wn||tl(0,le)),Wn&&(L.ori==1?(Ue=Go,Ve=sn):(Ue=Wo,Ve=hn),tl(fs(Ue,Ve),kn(Ve-Ue)),Gn||el(0,j)),!Gn&&!Wn&&(el(0,0),tl(0,0))}if(Kn._x=Gn,Kn._y=Wn,x==null){if(P){if($g!=null){let[pe,Me]=En.scales;En.values[0]=pe!=null?Cs(L.ori==0?sn:hn,pe):null,En.values[1]=Me!=null?Cs(L.ori==1?sn:hn,Me):null}il(Of,i,sn,hn,U,Ee,N)}if(it){let pe=P&&En.setSeries,Me=He.prox;ro==null?Js<=Me&&Es(Mr,Xo,!0,pe):Js>Me?Es(null,Xo,!0,pe):Mr!=ro&&Es(Mr,Xo,!0,pe)}}ge&&(oe.idx=N,uf()),w!==!1&&$n("setCursor")}let wr=null;Object.defineProperty(i,"rect",{get(){return wr==null&&nl(!1),wr}});function nl(x=!1){x?wr=null:(wr=p.getBoundingClientRect(),$n("syncRect",wr))}function Og(x,w,P,N,W,j,le){ue._lock||br&&x!=null&&x.movementX==0&&x.movementY==0||(hf(x,w,P,N,W,j,le,!1,x!=null),x!=null?oo(null,!0,!0):oo(w,!0,!1))}function hf(x,w,P,N,W,j,le,pe,Me){if(wr==null&&nl(!1),nt(x),x!=null)P=x.clientX-wr.left,N=x.clientY-wr.top;else{if(P<0||N<0){sn=-10,hn=-10;return}let[Oe,Ue]=En.scales,Ve=w.cursor.sync,[ht,Ot]=Ve.values,[Rt,bt]=Ve.scales,[Qe,Ye]=En.match,on=w.axes[0].side%2==1,yn=L.ori==0?U:Ee,Xn=L.ori==1?U:Ee,Yt=on?j:W,xn=on?W:j,Ni=on?N:P,hi=on?P:N;if(Rt!=null?P=Qe(Oe,Rt)?a(ht,M[Oe],yn,0):-10:P=yn*(Ni/Yt),bt!=null?N=Ye(Ue,bt)?a(Ot,M[Ue],Xn,0):-10:N=Xn*(hi/xn),L.ori==1){let Ki=P;P=N,N=Ki}}Me&&(w==null||w.cursor.event.type==Of)&&((P<=1||P>=U-1)&&(P=ho(P,U)),(N<=1||N>=Ee-1)&&(N=ho(N,Ee))),pe?(Rg=P,Pg=N,[Go,Wo]=ue.move(i,P,N)):(sn=P,hn=N)}let df={width:0,height:0,left:0,top:0};function ff(){Rc(df,!1)}let Ug,Fg,kg,Bg;function zg(x,w,P,N,W,j,le){br=!0,Gn=Wn=Kn._x=Kn._y=!1,hf(x,w,P,N,W,j,le,!0,!1),x!=null&&(At(Uf,Vf,Vg,!1),il(O0,i,Go,Wo,U,Ee,null));let{left:pe,top:Me,width:Oe,height:Ue}=rn;Ug=pe,Fg=Me,kg=Oe,Bg=Ue}function Vg(x,w,P,N,W,j,le){br=Kn._x=Kn._y=!1,hf(x,w,P,N,W,j,le,!1,!0);let{left:pe,top:Me,width:Oe,height:Ue}=rn,Ve=Oe>0||Ue>0,ht=Ug!=pe||Fg!=Me||kg!=Oe||Bg!=Ue;if(Ve&&ht&&Rc(rn),Kn.setScale&&Ve&&ht){let Ot=pe,Rt=Oe,bt=Me,Qe=Ue;if(L.ori==1&&(Ot=Me,Rt=Ue,bt=pe,Qe=Oe),Gn&&Sr(C,Cs(Ot,C),Cs(Ot+Rt,C)),Wn)for(let Ye in M){let on=M[Ye];Ye!=C&&on.from==null&&on.min!=Zt&&Sr(Ye,Cs(bt+Qe,Ye),Cs(bt,Ye))}ff()}else ue.lock&&(ue._lock=!ue._lock,oo(w,!0,x!=null));x!=null&&(un(Uf,Vf),il(Uf,i,sn,hn,U,Ee,null))}function YS(x,w,P,N,W,j,le){if(ue._lock)return;nt(x);let pe=br;if(br){let Me=!0,Oe=!0,Ue=10,Ve,ht;L.ori==0?(Ve=Gn,ht=Wn):(Ve=Wn,ht=Gn),Ve&&ht&&(Me=sn<=Ue||sn>=U-Ue,Oe=hn<=Ue||hn>=Ee-Ue),Ve&&Me&&(sn=sn<Go?0:U),ht&&Oe&&(hn=hn<Wo?0:Ee),oo(null,!0,!0),br=!1}sn=-10,hn=-10,Y.fill(null),oo(null,!0,!0),pe&&(br=pe)}function Hg(x,w,P,N,W,j,le){ue._lock||(nt(x),Qa(),ff(),x!=null&&il(k0,i,sn,hn,U,Ee,null))}function Gg(){E.forEach(c1),F(i.width,i.height,!0)}mo(eu,Ko,Gg);let qo={};qo.mousedown=zg,qo.mousemove=Og,qo.mouseup=Vg,qo.dblclick=Hg,qo.setSeries=(x,w,P,N)=>{let W=En.match[2];P=W(i,w,P),P!=-1&&Es(P,N,!0,!1)},_e&&(At(O0,p,zg),At(Of,p,Og),At(U0,p,x=>{nt(x),nl(!1)}),At(F0,p,YS),At(k0,p,Hg),Jf.add(i),i.syncRect=nl);let Pc=i.hooks=n.hooks||{};function $n(x,w,P){ui?Wt.push([x,w,P]):x in Pc&&Pc[x].forEach(N=>{N.call(null,i,w,P)})}(n.plugins||[]).forEach(x=>{for(let w in x.hooks)Pc[w]=(Pc[w]||[]).concat(x.hooks[w])});let Wg=(x,w,P)=>P,En=Pn({key:null,setSeries:!1,filters:{pub:J0,sub:J0},scales:[C,b[1]?b[1].scale:null],match:[K0,K0,Wg],values:[null,null]},ue.sync);En.match.length==2&&En.match.push(Wg),ue.sync=En;let $g=En.key,pf=X_($g);function il(x,w,P,N,W,j,le){En.filters.pub(x,w,P,N,W,j,le)&&pf.pub(x,w,P,N,W,j,le)}pf.sub(i);function JS(x,w,P,N,W,j,le){En.filters.sub(x,w,P,N,W,j,le)&&qo[x](null,w,P,N,W,j,le)}i.pub=JS;function KS(){pf.unsub(i),Jf.delete(i),Nn.clear(),Wf(eu,Ko,Gg),c.remove(),Ae?.remove(),$n("destroy")}i.destroy=KS;function mf(){$n("init",n,e),ja(e||n.data,!1),$[C]?af(C,$[C]):Qa(),se=rn.show&&(rn.width>0||rn.height>0),ne=ge=!0,F(n.width,n.height)}return b.forEach(Fo),E.forEach($s),t?t instanceof HTMLElement?(t.appendChild(c),mf()):t(i,mf):mf(),i}Zn.assign=Pn;Zn.fmtNum=np;Zn.rangeNum=tu;Zn.rangeLog=su;Zn.rangeAsinh=ep;Zn.orient=_o;Zn.pxRatio=Ut;Zn.join=ew;Zn.fmtDate=sp,Zn.tzDate=hw;Zn.sync=X_;{Zn.addGap=qw,Zn.clipGaps=au;let n=Zn.paths={points:j_};n.linear=ey,n.stepped=Kw,n.bars=Zw,n.spline=Qw}function ps(n,e,t=()=>!0){let[i,s]=$e({value:void 0,error:"",path:n});return ke(()=>{if(n===null)return;let r=new AbortController,o=0,a=async()=>{let l=!0;try{let c=await Ai(n,r.signal);l=t(c),s({value:c,error:"",path:n})}catch(c){if(ls(c))return;s(u=>({...u,error:Rn(c),path:n}))}l&&!r.signal.aborted&&(o=window.setTimeout(a,1e3*e))};return a(),()=>{r.abort(),clearTimeout(o)}},[n]),i.path===n?i:{value:void 0,error:""}}function sa(){let[n,e]=$e(0);return ke(()=>Yc(()=>e(t=>t+1)),[]),n}function Ir(n){ke(()=>{n!==null&&(document.title=n===""?"cdcluster":`${n} - cdcluster`)},[n])}var u1=4;function Ls(n,e,t){let[i,s]=$e({value:null,error:"",key:null,version:null,rests:0}),[r,o]=$e(0),a=Tt(!1),l=Tt({version:e,load:t});return l.current={version:e,load:t},ke(()=>{if(n===null)return;let c=new AbortController,u=l.current.version,d=performance.now();a.current=!0;let h=(f,p)=>{a.current=!1;let v=performance.now();s(g=>({value:f??(g.key===n?g.value:null),error:p,key:n,version:u,rests:v+u1*(v-d)}))};return l.current.load(c.signal).then(f=>c.signal.aborted||h(f,""),f=>ls(f)||c.signal.aborted||h(null,Rn(f))),()=>c.abort()},[n,r]),ke(()=>{if(i.key!==n||n===null||i.version===e||a.current)return;let c=setTimeout(()=>o(u=>u+1),Math.max(0,i.rests-performance.now()));return()=>clearTimeout(c)},[n,e,i]),i.key===n?i:{value:null,error:""}}var h1=Symbol.for("pv"),d1=0;function m(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:h1,__v:--d1,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),$t.vnode&&$t.vnode(c),c}var sy=160;function f1(n,e,t){let i={stroke:cs("--muted"),grid:{stroke:cs("--line"),width:1},ticks:{stroke:cs("--line"),width:1,size:4},font:"11px system-ui, sans-serif"};return{width:e,height:sy,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},hooks:{setCursor:[s=>t(s.cursor.idx??null)]},scales:{y:{range:(s,r,o)=>[0,Math.max(1.1*o,4)]}},axes:[{...i,size:28,space:70,values:"{HH}:{mm}:{ss}"},{...i,size:64,values:(s,r)=>r.map(o=>n.format(o))}],series:[{},...n.lines.map(s=>({stroke:cs(s.colour),width:1.5,...s.dash?{dash:s.dash}:{},points:{show:!1}}))]}}function hp(n){let e=Tt(null),t=Tt(null),[i,s]=$e(null),r=sa(),o=[n.times,...n.lines.map(u=>u.values)];ke(()=>{let u=e.current;if(!u)return;let d=new Zn(f1(n,u.clientWidth||300,s),o,u);t.current=d;let h=new ResizeObserver(()=>d.setSize({width:u.clientWidth||300,height:sy}));return h.observe(u),()=>{h.disconnect(),d.destroy(),t.current=null}},[r]),ke(()=>t.current?.setData(o),[n.times,r]);let a=i!==null&&i<n.times.length?i:n.times.length-1,l=u=>n.format(u.values[a]??0),c=n.lines.map(u=>`${u.title} ${l(u)}`).join(", ");return m("figure",{class:"chart",children:[m("div",{ref:e,role:"img","aria-label":`${n.title}: ${c}`}),m("figcaption",{children:[n.lines.map(u=>m("span",{children:[m("svg",{viewBox:"0 0 18 4","aria-hidden":"true",children:m("line",{x1:0,x2:18,y1:2,y2:2,stroke:`var(${u.colour})`,"stroke-width":2,"stroke-dasharray":u.dash?.join(" ")??"none"})}),u.title," ",m("b",{children:l(u)})]},u.title)),m("span",{class:"note",children:i===null?"now":new Date(1e3*n.times[a]).toLocaleTimeString("en-GB")})]})]})}var hu=["separate","touch","cross","inside","contact","undecided","failed","near"];var ry=[0,7,1,2,3,4,5,6],p1=[1,4,6,7,5,2,8,3];function Lr(n){return n===255?0:p1[n]}function yl(n){return n>=1&&n<=4}function du(n){return yl(n)||n===7}function ms(n){return n===255?"not tested yet":hu[n]}function ra(n){let e=hu.indexOf(n);return e<0?255:e}function oy(n){return n===255?"-":"STXICUFN"[n]}var m1=[[92,168,128],[232,188,38],[206,58,50],[146,36,92],[214,82,54],[132,112,186],[60,64,70],[240,140,40]],g1=[150,155,160];function Ei(n){return n===255?g1:m1[n]}function Dr(n){let[e,t,i]=Ei(n);return`rgb(${e} ${t} ${i})`}function ay(n){return n===255?.12:[.3,.6,1,.9,.8,.5,.7,.45][n]}function et({text:n}){return m("bdi",{class:"name",title:n.slice(0,2e3),children:n===""?"(no name)":n.length>400?`${n.slice(0,400)}…`:n})}function mi({kind:n}){return m("span",{class:`mark mark-${ms(n).split(" ")[0]}`,style:{background:Dr(n)},"aria-hidden":"true",children:oy(n)})}function ly(n){return n.count===0&&!n.always?null:m("span",{class:`count ${n.count===0?"zero":""}`,children:[m(mi,{kind:n.kind}),ms(n.kind)," ",m("b",{children:fe(n.count)})]})}function Ct(n){return m("div",{class:`notice ${n.kind}`,role:n.kind==="bad"?"alert":"status",children:n.children})}function mn(n){return m("section",{class:`panel ${n.wide?"wide":""}`,"aria-label":n.title,children:[m("header",{children:[m("h2",{children:n.title}),n.note&&m("span",{class:"note",children:n.note})]}),n.children]})}function fu({done:n,total:e}){let t=e===0?0:n/e;return m("span",{class:"progress",children:[m("progress",{max:1,value:t,"aria-label":`${fe(n)} of ${fe(e)}`}),m("span",{children:Sn(t)})]})}function pu({text:n}){let[e,t]=$e("");return m("button",{type:"button",class:"command",title:"copy",onClick:()=>dp(n,t),children:[m("code",{children:n}),m("span",{"aria-live":"polite",children:e||"copy"})]})}function dp(n,e){let t=s=>{e(s),setTimeout(()=>e(""),2e3)};(navigator.clipboard?.writeText(n)??Promise.reject(new Error)).then(()=>t("copied"),()=>t("the browser did not allow it"))}function _1(n,e){return typeof n=="number"&&typeof e=="number"?n-e:String(n).localeCompare(String(e),"en",{numeric:!0})}function ri(n){let[e,t]=$e(null),i=n.columns.find(a=>a.key===e?.key),s=[...n.rows];i&&e?s.sort((a,l)=>(e.down?-1:1)*_1(i.value(a),i.value(l))):n.order&&s.sort(n.order);let r=a=>{let l=a.isNumber===!0;e?.key!==a.key?t({key:a.key,down:l}):t(e.down===l?{key:a.key,down:!l}:null)},o=a=>e?.key!==a.key?"none":e.down?"descending":"ascending";return m("div",{class:"table",tabIndex:0,role:"region","aria-label":n.caption,children:m("table",{children:[m("caption",{children:n.caption}),m("thead",{children:m("tr",{children:n.columns.map(a=>m("th",{scope:"col",class:a.isNumber?"number":"","aria-sort":o(a),children:m("button",{type:"button",onClick:()=>r(a),children:a.title})},a.key))})}),m("tbody",{children:[s.length===0&&m("tr",{children:m("td",{class:"empty",colSpan:n.columns.length,children:n.empty})}),s.map(a=>m("tr",{class:n.rowClass?.(a)??"",children:n.columns.map(l=>m("td",{class:l.isNumber?"number":"",children:l.cell(a)},l.key))},n.rowKey(a)))]})]})})}function cy(n){let e=n.scenarios_per_second??0;return n.state==="running"&&e>0?(n.scenarios-n.done)/e:NaN}var y1=[{key:"job",title:"job",cell:n=>m("a",{href:Ks(n.job),children:n.job}),value:n=>n.job},{key:"name",title:"name",cell:n=>m(et,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>m("span",{class:`state ${n.state==="failed"?"bad":n.state==="paused"?"warn":""}`,children:n.state}),value:n=>n.state},{key:"owner",title:"owner",cell:n=>m(et,{text:n.owner||"-"}),value:n=>n.owner??""},{key:"began",title:"began",cell:n=>(n.began??"").replace("T"," ").replace(/Z$/," UTC"),value:n=>n.began??""},{key:"scenarios",title:"scenarios",cell:n=>fe(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"done",title:"done",cell:n=>m(fu,{done:n.done,total:n.scenarios}),value:n=>n.done/Math.max(1,n.scenarios),isNumber:!0},{key:"contact",title:"in contact",cell:n=>n.done===0?"-":Sn(n.contact/n.done),value:n=>n.contact/Math.max(1,n.done),isNumber:!0},{key:"failed",title:"failed",cell:n=>m("span",{class:n.failed>0?"state bad":"",children:fe(n.failed)}),value:n=>n.failed,isNumber:!0},{key:"rate",title:"rate",cell:n=>Cr(n.scenarios_per_second??0),value:n=>n.scenarios_per_second??0,isNumber:!0},{key:"eta",title:"ends in",cell:n=>uo(cy(n)),value:n=>cy(n)||0,isNumber:!0}];function fp(n){return m(ri,{caption:"jobs",columns:y1,rows:n.jobs,rowKey:e=>e.job,...n.order?{order:n.order}:{},empty:"no job yet: cdctl run job.toml --master HOST:7600"})}function uy(){let{value:n,error:e}=ps("jobs",2);return Ir("jobs"),ke(()=>Ti("jobs",()=>({ready:n!==void 0,jobs:n?.jobs.map(t=>t.job)})),[n]),ke(()=>{n?.jobs.length===1&&n.jobs[0].job==="folder"&&Zs(Ks("folder"))},[n]),n?m(Pt,{children:[e&&m(Ct,{kind:"bad",children:[e,"; below is what it said last"]}),m(fp,{jobs:n.jobs})]}):e?m(Ct,{kind:"bad",children:e}):m("p",{class:"wait",children:"asking for the jobs…"})}function mu(n){let e=["lost","silent","quarantined","draining"],t=e.indexOf(n.split(" ")[0]);return t<0?e.length:t}var hy=["bad","bad","warn","warn",""],x1=[{key:"worker",title:"worker",cell:n=>n.worker,value:n=>n.worker},{key:"name",title:"name",cell:n=>m(et,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>m("span",{class:`state ${hy[mu(n.state)]}`,children:n.state}),value:n=>n.state},{key:"threads",title:"threads",cell:n=>fe(n.threads),value:n=>n.threads,isNumber:!0},{key:"working",title:"working",cell:n=>fe(n.working),value:n=>n.working,isNumber:!0},{key:"done",title:"done",cell:n=>fe(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"rate",title:"rate",cell:n=>Cr(n.scenarios_per_second),value:n=>n.scenarios_per_second,isNumber:!0},{key:"cache",title:"cache",cell:n=>n.cache_bytes?I0(n.cached_bytes,n.cache_bytes):js(n.cached_bytes),value:n=>n.cached_bytes,isNumber:!0},{key:"hits",title:"hits",cell:n=>Sn(n.cache_hit_share),value:n=>n.cache_hit_share,isNumber:!0},{key:"peers",title:"to peers",cell:n=>js(n.uploaded_bytes??0),value:n=>n.uploaded_bytes??0,isNumber:!0},{key:"longest",title:"longest",cell:n=>n.longest?m("a",{href:en(n.longest.job,n.longest.scenario),children:["#",n.longest.scenario," ",uo(n.longest.seconds)]}):"-",value:n=>n.longest?.seconds??0,isNumber:!0}];function v1({history:n}){let e=i=>{let s=n.columns.indexOf(i);return n.rows.map(r=>r[s]??0)},t=e("time");return m("div",{class:"two",children:[m(mn,{title:"throughput",note:"scenarios a second, ten minutes",children:m(hp,{title:"throughput",times:t,format:Cr,lines:[{title:"scenarios",colour:"--accent",values:e("scenarios_per_second")}]})}),m(mn,{title:"wire",note:"bytes a second, seen from the master",children:m(hp,{title:"wire",times:t,format:P0,lines:[{title:"out",colour:"--accent",values:e("sent_per_second")},{title:"in",colour:"--second",values:e("received_per_second"),dash:[6,3]},{title:"peer to peer",colour:"--third",values:e("peer_per_second"),dash:[2,3]}]})})]})}function b1({cluster:n}){let e=n.workers.filter(r=>!r.state.startsWith("lost")),t=e.reduce((r,o)=>r+o.threads,0),i=e.reduce((r,o)=>r+o.scenarios_per_second,0),s=n.jobs.filter(r=>r.state==="running").length;return m("dl",{class:"numbers",children:[m("div",{children:[m("dt",{children:"scenarios"}),m("dd",{children:Cr(i)})]}),m("div",{children:[m("dt",{children:e.length===1?"worker":"workers"}),m("dd",{children:fe(e.length)})]}),m("div",{children:[m("dt",{children:"threads"}),m("dd",{children:fe(t)})]}),m("div",{children:[m("dt",{children:s===1?"job runs":"jobs run"}),m("dd",{children:fe(s)})]}),m("div",{children:[m("dt",{children:"up"}),m("dd",{children:uo(n.uptime_seconds)})]}),m("div",{children:[m("dt",{children:"free on the disk"}),m("dd",{children:js(n.state_bytes?.free??0)})]})]})}function dy(){let{value:n,error:e}=ps("cluster",1),{value:t}=ps("history",2);if(Ir("cluster"),ke(()=>Ti("cluster",()=>({ready:n!==void 0,workers:n?.workers.map(r=>({name:r.name,state:r.state})),jobs:n?.jobs.map(r=>({job:r.job,done:r.done,state:r.state}))})),[n]),!n)return e?m(Ct,{kind:"bad",children:e}):m("p",{class:"wait",children:"asking the master…"});let i=(r,o)=>mu(r.state)-mu(o.state),s=(r,o)=>+(o.state==="running")-+(r.state==="running");return m(Pt,{children:[e&&m(Ct,{kind:"bad",children:[e,"; below is what it said last"]}),n.paused&&m(Ct,{kind:"bad",children:["jobs are paused: ",n.paused]}),n.alarms.map((r,o)=>m(Ct,{kind:"warn",children:[m("b",{children:"alarm"})," ",m(et,{text:r})]},o)),m(b1,{cluster:n}),m("p",{class:"line",children:[m("b",{children:"bottleneck"})," ",n.bottleneck,n.workers_lost>0&&m(Pt,{children:[" · ",ft(n.workers_lost,"worker")," lost so far"]}),n.alarms.length===0&&m(Pt,{children:" · no alarms"})]}),t&&m(v1,{history:t}),m(ri,{caption:"workers",columns:x1,rows:n.workers,rowKey:r=>r.worker,order:i,rowClass:r=>hy[mu(r.state)],empty:"no worker is connected: start cdworker --master HOST:7600"}),m(fp,{jobs:n.jobs,order:s})]})}var tr=[0,1];function gi(n,[e,t]=tr){return[n.bodies[e]?.name??"",n.bodies[t]?.name??""]}function oa(n){return n.state!=="running"&&n.state!=="paused"}function nr(n){return n.question==="distance"}function gu(n){return n.question==="motion"}function Lt(n){return n.question==="shots"}function Xt(n){return n.steps!==void 0}function Ci({bodies:n}){return n??tr}function jn(n){return Lt(n)&&(n.poses.axes??[]).length>0}function _i(n){return Lt(n)?"hit":"pair"}function S1(n){let e=[];for(let t of n){if(t===0)continue;let i=31-Math.clz32(t);for(;e.length<=i;){let s=2**e.length;e.push({first:s,last:2*s-1,count:0})}e[i].count+=1}return e}function pp({bars:n,label:e}){let[t,i,s]=[480,150,18],r=Math.log1p(Math.max(...n.map(a=>a.count))),o=t/n.length;return m("svg",{class:"histogram",viewBox:`0 0 ${t} ${i+s}`,role:"img","aria-label":e,children:[n.map((a,l)=>{let c=Math.log1p(a.count)/r*(i-14);return m("g",{children:[m("title",{children:`${a.about}: ${ft(a.count,"scenario")}`}),m("rect",{class:"hit",x:l*o,y:0,width:o,height:i}),m("rect",{class:"bar",x:l*o+1,y:i-c,width:o-2,height:c}),a.count>0&&m("text",{x:(l+.5)*o,y:i-c-3,children:Df(a.count)}),(l%2===0||n.length<12)&&m("text",{x:(l+.5)*o,y:i+13,children:a.foot})]},a.about)}),m("line",{x1:0,x2:t,y1:i,y2:i})]})}function mp({job:n,results:e}){let t=lt(()=>e.counts?S1(e.counts):[],[e]);if(t.length===0)return null;let[i,s]=[_i(n),Lt(n)?"bundle":"scenario"];return m(mn,{title:`${i}s a ${s}`,note:`${s}s in contact${n.clearance===null?"":" or near"}, both axes logarithmic${e.isExact?"":", of the sample"}`,children:m(pp,{label:`histogram of ${i}s a ${s}`,bars:t.map(r=>({about:`${fe(r.first)} to ${fe(r.last)} ${i}s`,foot:Df(r.first),count:r.count}))})})}var M1=10,xl=20;function w1(n,e=M1){let t=[];return(n.distances??new Float64Array).forEach((i,s)=>{let r=t.length===e?n.distanceAt(t[e-1]):null;if(Number.isNaN(i)||r!==null&&i>=r)return;let o=t.findIndex(a=>i<(n.distanceAt(a)??1/0));t.splice(o<0?t.length:o,0,s),t.length=Math.min(t.length,e)}),t}function A1(n){let e=n.filter(s=>!Number.isNaN(s)),t=e.reduce((s,r)=>Math.max(s,r),0);if(e.length===0||t===0)return e.length===0?[]:[{from:0,to:0,count:e.length}];let i=Array.from({length:xl},(s,r)=>({from:r/xl*t,to:(r+1)/xl*t,count:0}));return e.forEach(s=>{i[Math.min(xl-1,Math.floor(s/t*xl))].count+=1}),i}function fy({job:n,results:e}){let t=lt(()=>w1(e),[e]),i=lt(()=>A1(e.distances??new Float64Array),[e]),s=e.isExact?"":", of the sample";return m(Pt,{children:[m(mn,{title:"least distances",note:`between the bodies' surfaces, in ${n.unit}${s}`,children:m(ri,{caption:"least distances",rows:t,rowKey:r=>String(r),empty:"no scenario has a distance",columns:[{key:"scenario",title:"scenario",cell:r=>m("a",{href:en(n.job,e.scenarioAt(r)),children:["#",fe(e.scenarioAt(r))]}),value:r=>e.scenarioAt(r),isNumber:!0},{key:"class",title:"class",cell:r=>m(Pt,{children:[m(mi,{kind:e.classes[r]})," ",ms(e.classes[r])]}),value:r=>e.classes[r]},{key:"distance",title:`distance [${n.unit}]`,cell:r=>Et(e.distanceAt(r)??Number.NaN,6),value:r=>e.distanceAt(r)??1/0,isNumber:!0}]})}),i.length>0&&m(mn,{title:"distances",note:`scenarios by distance in ${n.unit}; heights are logarithmic${s}`,children:m(pp,{label:"histogram of distances",bars:i.map(r=>({about:`${Et(r.from)} to ${Et(r.to)} ${n.unit}`,foot:Et(r.from,2),count:r.count}))})})]})}var gp=1e3;function T1(n){let e=[],t=0,i=null;return n.classes.forEach((s,r)=>{du(s)?i?(i.last=n.first+r,i.worst=n.isWorse(r,i.worst)?r:i.worst):(i={first:n.first+r,last:n.first+r,worst:r},t+=1,t<=gp&&e.push(i)):i=null}),{count:t,listed:e}}function py({job:n,results:e}){let t=n.poses.kind==="file"&&e.isExact&&!Xt(n),i=lt(()=>t?T1(e):null,[e,t]);if(!i)return null;let s=n.clearance===null?"in contact":"in contact or near",r=o=>m("a",{href:en(n.job,o),children:["#",fe(o)]});return m(mn,{title:"episodes",note:`${ft(i.count,"run")} of consecutive scenarios ${s}${i.count>gp?`; the first ${fe(gp)} are listed`:""}`,children:m(ri,{caption:"episodes",rows:i.listed,rowKey:o=>String(o.first),empty:`no scenario is ${s}`,columns:[{key:"first",title:"first",cell:o=>r(o.first),value:o=>o.first,isNumber:!0},{key:"last",title:"last",cell:o=>r(o.last),value:o=>o.last,isNumber:!0},{key:"length",title:"scenarios",cell:o=>fe(o.last-o.first+1),value:o=>o.last-o.first,isNumber:!0},{key:"worst",title:"worst",cell:o=>m(Pt,{children:[m(mi,{kind:e.classes[o.worst]})," ",r(e.scenarioAt(o.worst))]}),value:o=>e.countAt(o.worst),isNumber:!0},{key:"pairs",title:"pairs there",cell:o=>e.counts?fe(e.countAt(o.worst)):"-",value:o=>e.countAt(o.worst),isNumber:!0}]})})}function my(n){return n.replaceAll(/[\\/*?[]/g,"\\$&")}function _p(n){return n.replaceAll(/\\(.)/gs,"$1")}function E1(n,e){let t=e.indexOf(n);return t>=0?t:["a","b"].indexOf(n)}function Nr(n,e,t){return`${t[n]!==""&&t[0]!==t[1]?my(t[n]):"ab"[n]}/${my(e)}`}function yp(n,e){for(let t=n.indexOf("/");t>=0;t=n.indexOf("/",t+1))if(e.has(n.slice(0,t)))return{body:n.slice(0,t),part:n.slice(t+1)};return null}function gy(n,e){let t=/^((?:\\.|[^\\/])*)\/(.*)$/s.exec(n),i=t?E1(_p(t[1]),e.bodies):-1;if(t&&i>=0)return{body:i,part:_p(t[2])};let s=_p(n);return{body:e.hasA(s)?0:1,part:s}}function C1(n,e){let i=n/e,s=i+1.959964*1.959964/(2*e),r=1.959964*Math.sqrt(i*(1-i)/e+1.959964*1.959964/(4*e*e)),o=1+1.959964*1.959964/e;return[Math.max(0,(s-r)/o),Math.min(1,(s+r)/o)]}function R1({group:n,job:e}){let t=e.poses.kind==="random"&&!e.poses.penetration&&e.done>0,[i,s]=t?C1(n.scenarios,e.done):[0,0];return m("span",{class:"share",children:[m("meter",{min:0,max:1,value:n.share}),m("span",{children:[Sn(n.share),t&&m("small",{children:[" ",`${Sn(i)} to ${Sn(s)}`]})]})]})}function P1(n,{a:e,b:t}){let[i,s]=[yp(e,n),yp(t,n)];if(!i||!s)return{};let r=[i.body,s.body];return{part:Nr(0,i.part,r),with:Nr(1,s.part,r)}}var _y=new WeakMap;function I1(n){let e=_y.get(n)??new Set(n.map(({name:t})=>t));return _y.set(n,e),e}function yy(n,e){let{a:t,b:i,worst:s}=e;if(Xt(n))return en(n.job,s,P1(I1(n.bodies),e));let r=gi(n);return en(n.job,s,{part:Nr(0,t,r),with:Nr(1,i,r)})}var L1={key:"near",title:"near pairs",cell:n=>fe(n.near),value:n=>n.near,isNumber:!0};function D1(n){return[{key:"a",title:"part",cell:e=>m(et,{text:e.a}),value:e=>e.a},{key:"scenarios",title:"in bundles",cell:e=>fe(e.scenarios),value:e=>e.scenarios,isNumber:!0},{key:"pairs",title:"hits",cell:e=>fe(e.pairs),value:e=>e.pairs,isNumber:!0},{key:"worst",title:"most hits",cell:e=>m("a",{href:yy(n,e),children:["#",fe(e.worst)]}),value:e=>e.worst_pairs,isNumber:!0}]}function N1(n){return Lt(n)?D1(n):[{key:"a",title:"part of A",cell:e=>m(et,{text:e.a}),value:e=>e.a},{key:"b",title:"part of B",cell:e=>m(et,{text:e.b}),value:e=>e.b},{key:"scenarios",title:"in poses",cell:e=>fe(e.scenarios),value:e=>e.scenarios,isNumber:!0},{key:"share",title:"share",cell:e=>m(R1,{group:e,job:n}),value:e=>e.share,isNumber:!0},{key:"worst",title:"worst",cell:e=>m("a",{href:yy(n,e),children:[m(mi,{kind:ra(e.class)})," #",fe(e.worst)]}),value:e=>e.worst_pairs+e.worst_near,isNumber:!0},...n.clearance===null?[]:[L1]]}function xy({job:n,groups:e}){let t=n.groups_total??e.length,i=t>e.length,s=Lt(n),[r,o]=$e(""),a=r.toLowerCase(),l=e.filter(({a:u,b:d})=>u.toLowerCase().includes(a)||d.toLowerCase().includes(a)),c=s?"parts hit":n.clearance===null?"parts in contact":"parts in contact or near";return m(mn,{title:c,note:i?`the ${fe(e.length)} in most ${s?"bundles":"poses"}, of ${fe(t)}`:"",children:[Xt(n)&&m("input",{type:"search","aria-label":"parts whose name holds",placeholder:"body/part",value:r,onInput:u=>o(u.currentTarget.value)}),m(ri,{caption:c,columns:N1(n),rows:l,rowKey:u=>`${u.a}
${u.b}`,empty:r?"no part has such a name":`no part is ${s?"hit":n.clearance===null?"in contact":"in contact or near"}`})]})}var yo={body:"",steps:null};function xp(n){let e=/^(\d{1,9})(?:-(\d{1,9}))?$/.exec(n??""),[t,i]=[Number(e?.[1]),Number(e?.[2]??e?.[1])];return e&&t<=i?[t,i]:null}function vl([n,e]){return n===e?String(n):`${n}-${e}`}function _u(n){return{body:n.get("body")??"",steps:xp(n.get("steps"))}}function Ds({body:n,steps:e}){return{...n?{body:n}:{},...e?{steps:vl(e)}:{}}}function es({body:n,steps:e}){return n!==""||e!==null}function yu(n,e){let t=n.findIndex(i=>i.name===e);return t>=0||!/^\d{1,9}$/.test(e)?t:Number(e)<n.length?Number(e):-1}function O1(n){let e=(n??"").split(",").map(t=>/^(\w+):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(t));return Object.fromEntries(e.flatMap(t=>t&&Number.isFinite(Number(t[2]))?[[t[1],Number(t[2])]]:[]))}function U1(n,e){let t=r=>/^\d{1,15}$/.test(r??""),[i,s]=[Number(n),Number(e)];return t(n)&&t(e)&&i<=s?[i,s+1]:null}function vp(n){return{x:n.get("x")??"",y:n.get("y")??"",at:O1(n.get("at")),window:U1(n.get("from"),n.get("to")),filter:_u(n)}}function vy(n){let e={};n.x&&n.y&&(e.x=n.x,e.y=n.y);let t=Object.entries(n.at);return t.length>0&&(e.at=t.map(([i,s])=>`${i}:${s}`).join(",")),n.window&&(e.from=String(n.window[0]),e.to=String(n.window[1]-1)),es(n.filter)&&Object.assign(e,Ds(n.filter)),e}function zi(n,[e,t,i]){return[n[0]*e+n[1]*t+n[2]*i+n[3],n[4]*e+n[5]*t+n[6]*i+n[7],n[8]*e+n[9]*t+n[10]*i+n[11]]}function ir(n){let e=[n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]],t=i=>-(e[i]*n[3]+e[i+1]*n[7]+e[i+2]*n[11]);return[e[0],e[1],e[2],t(0),e[3],e[4],e[5],t(3),e[6],e[7],e[8],t(6)]}function Sl(n,e){let t=[];for(let i=0;i<12;i+=4)for(let s=0;s<4;++s)t.push(n[i]*e[s]+n[i+1]*e[s+4]+n[i+2]*e[s+8]+(s===3?n[i+3]:0));return t}function xu({pose_a:n,pose_b:e}){return Sl(ir(n),e)}var Ml=["x","y","z","roll","pitch","yaw","distance"],xo=["azimuth","elevation"],bl=180/Math.PI;function Or(n,e,t=0){switch(n){case"x":return e[t+3];case"y":return e[t+7];case"z":return e[t+11];case"roll":return Math.atan2(e[t+9],e[t+10])*bl;case"pitch":return Math.asin(Math.max(-1,Math.min(1,-e[t+8])))*bl;case"yaw":return Math.atan2(e[t+4],e[t])*bl;case"distance":return Math.hypot(e[t+3],e[t+7],e[t+11]);case"azimuth":{let i=Math.atan2(e[t+4],e[t])*bl;return i<-1e-9?i+360:Math.max(0,i)}case"elevation":return Math.asin(Math.max(-1,Math.min(1,e[t+8])))*bl}}function by(n){return Object.fromEntries(Ml.map(e=>[e,Or(e,n)]))}function sr(n){return["roll","pitch","yaw",...xo].includes(n)}var wl=4096,F1=1<<24,Ri=65536,Ur=class{constructor(e,t,i,s,r=null,o=null){this.first=e;this.end=t;this.classes=i;this.counts=s;this.chosen=r;this.distances=o}first;end;classes;counts;chosen;distances;get isExact(){return this.classes.length===this.end-this.first}get isSample(){return!this.isExact&&this.chosen===null}scenarioAt(e){return this.chosen?this.chosen[e]:this.isExact?this.first+e:this.first+Math.floor(e*(this.end-this.first)/this.classes.length)}classOf(e){return this.isExact?this.classes[e-this.first]:void 0}isWorse(e,t){let i=Lr(this.classes[e])-Lr(this.classes[t])||this.countAt(e)-this.countAt(t);return i>0||i===0&&(this.distanceAt(e)??1/0)<(this.distanceAt(t)??1/0)}worst(){let e=0;for(let t=1;t<this.classes.length;++t)e=this.isWorse(t,e)?t:e;return this.classes.length===0?0:this.scenarioAt(e)}countAt(e){return this.counts?.[e]??0}distanceAt(e){let t=this.distances?.[e]??Number.NaN;return Number.isNaN(t)?null:t}};function k1(n){return n.kind==="folder"?1<<20:Ri}function Sp(n){return n.kind==="folder"?F1:Ri}async function bp(n,e,t,i,s){for(let r=0;r<t.length;r+=i){let o=Math.min(i,t.length-r),a=await Kt(`${n}?first=${e+r}&count=${o}`,s);t.set(a.values,r)}return t}function gs(n,e){return`jobs/${encodeURIComponent(n.job)}/${e}`}async function vu(n,e,t,i,s){if(!aa(n,t,i)){let r=["classes","counts",...nr(e)?["distances"]:[]],[o,a,l]=await Promise.all(r.map(c=>Kt(`${gs(e,c)}?sample=${wl}`,s)));return new Ur(0,e.scenarios,o.values,a.values,null,l?.values??null)}return Sy(e,t,i-t,k1(n),s)}async function Sy(n,e,t,i,s){let r=new Uint8Array(t).fill(255),o=await bp(gs(n,"classes"),e,r,i,s),a=n.level==="any"?null:await bp(gs(n,"counts"),e,new Uint32Array(t),i,s),l=nr(n)?await bp(gs(n,"distances"),e,new Float64Array(t).fill(Number.NaN),i,s):null;return new Ur(e,e+t,o,a,null,l)}function My(n,e,t,i){return Sy(n,e,t,Ri,i)}function aa(n,e,t){return t-e<=Sp(n)}var B1=10;function z1(n,e=B1){return Array.from(n.classes,(i,s)=>s).filter(i=>n.countAt(i)>0).sort((i,s)=>n.countAt(s)-n.countAt(i)||i-s).slice(0,e)}async function V1(n,e,t){let i=s=>Kt(`${gs(n,"poses")}?first=${s}&count=1`,t);return Promise.all(e.map(async s=>(await i(s)).values))}function wy({job:n,results:e}){let t=lt(()=>z1(e),[e]),i=t.map(l=>e.scenarioAt(l)),s=jn(n)&&i.length>0?i.join(" "):null,r=Ls(s,0,l=>V1(n,i,l)),o=t.map((l,c)=>({scenario:i[c],hits:e.countAt(l),pose:r.value?.[c]??null})),a=(jn(n)?xo:[]).map(l=>({key:l,title:`${l} [°]`,cell:({pose:c})=>c?Et(Or(l,c),5):"",value:({pose:c})=>c?Or(l,c):0,isNumber:!0}));return m(mn,{title:"most hits",note:e.isExact?"":"of the sample",children:[r.error&&m(Ct,{kind:"bad",children:r.error}),m(ri,{caption:"most hits",rows:o,rowKey:l=>String(l.scenario),empty:"no line hits anything",columns:[{key:"scenario",title:"bundle",cell:l=>m("a",{href:en(n.job,l.scenario),children:["#",fe(l.scenario)]}),value:l=>l.scenario,isNumber:!0},...a,{key:"hits",title:"hits",cell:l=>fe(l.hits),value:l=>l.hits,isNumber:!0}]})]})}function bu(n,e,t,i,s){if(e===0||e===255||e===1){let r=s*(e===1?.85:e===0?.35:.15);n.moveTo(t+r,i),n.arc(t,i,r,0,2*Math.PI)}else if(e===2||e===4)n.moveTo(t-s,i-s),n.lineTo(t+s,i+s),e===2&&(n.moveTo(t+s,i-s),n.lineTo(t-s,i+s));else if(e===3)n.rect(t-s,i-s,2*s,2*s);else if(e===5)n.moveTo(t-s,i),n.lineTo(t+s,i);else if(e===7)for(let r of[-.5,.5])n.moveTo(t+r*s,i-s),n.lineTo(t+r*s,i+s);else n.moveTo(t,i-s),n.lineTo(t+s,i+s),n.lineTo(t-s,i+s),n.lineTo(t,i-s)}var H1=10,la=class{constructor(e,t,i,s,r,o,a){this.results=e;this.x=t;this.y=i;this.columns=s;this.rows=r;this.showsShares=o;this.describe=a;let l=s*r;this.worst=new Int32Array(l).fill(-1),this.number=new Uint32Array(l),this.tested=new Uint32Array(l),this.contacts=new Uint32Array(l)}results;x;y;columns;rows;showsShares;describe;worst;number;tested;contacts;add(e,t,i){let s=t*this.columns+e,r=this.results.classes[i];this.number[s]+=1,this.tested[s]+=r===255?0:1,this.contacts[s]+=yl(r)?1:0,(this.worst[s]<0||this.results.isWorse(i,this.worst[s]))&&(this.worst[s]=i)}colour(e){let t=this.results.classes[this.worst[e]];if(!this.showsShares||this.tested[e]===0)return Ei(t);let i=this.contacts[e]/this.tested[e],[s,r]=[Ei(0),Ei(2)];return[0,1,2].map(o=>s[o]+(r[o]-s[o])*i)}draw(e,t,i){let s=new ImageData(this.columns,this.rows);for(let o=0;o<this.worst.length;++o){if(this.worst[o]<0)continue;let l=4*((this.rows-1-Math.floor(o/this.columns))*this.columns+o%this.columns);s.data.set([...this.colour(o),255],l)}let r=new OffscreenCanvas(this.columns,this.rows);r.getContext("2d")?.putImageData(s,0,0),e.imageSmoothingEnabled=!1,e.drawImage(r,0,0,t,i),this.drawGlyphs(e,t/this.columns,i/this.rows)}drawGlyphs(e,t,i){let s=Math.min(t,i);if(!(s<H1||this.showsShares)){e.strokeStyle="rgb(0 0 0 / 0.3)",e.lineWidth=Math.max(1,s/14),e.beginPath();for(let r=0;r<this.worst.length;++r)if(this.worst[r]>=0){let o=(r%this.columns+.5)*t,a=(this.rows-.5-Math.floor(r/this.columns))*i,l=this.results.classes[this.worst[r]];l!==0&&l!==255&&bu(e,l,o,a,s*.2)}e.stroke()}}spot(e,t){let i=t*this.columns+e;return e<0||t<0||e>=this.columns||t>=this.rows||this.worst[i]<0?null:{scenario:this.results.scenarioAt(this.worst[i]),text:this.text(i),x:e/this.columns,y:t/this.rows,width:1/this.columns,height:1/this.rows}}text(e){let t=this.worst[e],i=this.results.scenarioAt(t),s=this.results.countAt(t),r=s>0?`, ${fe(s)} pairs`:"",o=`#${i} ${ms(this.results.classes[t])}${r}${this.describe(i)}`;if(this.number[e]===1)return o;let a=Sn(this.contacts[e]/Math.max(1,this.tested[e]));return`${fe(this.number[e])} scenarios, ${a} in contact; the worst is ${o}`}at(e,t){return this.spot(Math.floor(e*this.columns),Math.floor(t*this.rows))}step(e,t,i){let s=e?Math.round(e.x*this.columns):Math.floor(this.columns/2)-t,r=e?Math.round(e.y*this.rows):Math.floor(this.rows/2)-i;for(;;){if(s+=t,r+=i,s<0||r<0||s>=this.columns||r>=this.rows)return e;let o=this.spot(s,r);if(o)return o}}};function ca(n,e){return`${Et(e)}${n.unit}`}var G1=512,W1=40,Mp=class{constructor(e,t){this.axes=e;this.unit=t;this.strides=e.map((i,s)=>e.slice(s+1).reduce((r,o)=>r*o.count,1))}axes;unit;strides;varying(){return this.axes.flatMap((e,t)=>e.count>1?[t]:[])}value(e,t){let{first:i,last:s,count:r}=this.axes[e];return t===0?i:t===r-1?s:i+(s-i)*t/(r-1)}numberOf(e,t){return Math.floor(t/this.strides[e])%this.axes[e].count}unitOf(e){return sr(this.axes[e].name)?"°":` ${this.unit}`}plotAxis(e){let{name:t,first:i,last:s}=this.axes[e];return{title:t,first:i,last:s,unit:this.unitOf(e)}}nearest(e,t){let{first:i,last:s,count:r}=this.axes[e],o=s===i?0:(t-i)/(s-i)*(r-1);return Math.min(r-1,Math.max(0,Math.round(o)))}brief(e,t){let i=this.value(e,t),s=[4,6,9,12].find(r=>this.nearest(e,Number(i.toPrecision(r)))===t);return s===void 0?i:Number(i.toPrecision(s))}varyingNamed(e){return this.varying().find(t=>this.axes[t].name===e)}valueText(e,t){return`${this.axes[e].name} ${Et(this.value(e,t))}${this.unitOf(e)}`}describe(e){let t=this.varying().map(i=>this.valueText(i,this.numberOf(i,e)));return t.length===0?"":` at ${t.join(", ")}`}};function Ay(n,e,t,i,s){let r=e.isSample?W1:G1,o=Math.min(r,n.axes[t].count),a=Math.min(r,n.axes[i].count),l=new la(e,n.plotAxis(t),n.plotAxis(i),o,a,!1,h=>n.describe(h)),c=h=>Math.floor(h*o/n.axes[t].count),u=h=>Math.floor(h*a/n.axes[i].count);if(!e.isExact){for(let h=0;h<e.classes.length;++h){let f=e.scenarioAt(h);l.add(c(n.numberOf(t,f)),u(n.numberOf(i,f)),h)}return l}let d=s.reduce((h,f,p)=>h+(p===t||p===i?0:f*n.strides[p]),0);for(let h=0;h<n.axes[t].count;++h)for(let f=0;f<(t===i?1:n.axes[i].count);++f){let p=d+h*n.strides[t]+(t===i?0:f*n.strides[i]);l.add(c(h),t===i?0:u(f),p-e.first)}return l}function Ty(n){return n.poses.kind==="grid"&&n.poses.axes?new Mp(n.poses.axes,n.unit):null}var $1={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function X1(n,e,t,i){let[s,r]=[e.x*t,(1-e.y-e.height)*i];n.lineWidth=2*devicePixelRatio,n.strokeStyle=cs("--ink"),n.beginPath(),e.width>0?n.rect(s-1,r-1,Math.max(4,e.width*t)+2,Math.max(4,e.height*i)+2):n.arc(s,r,6*devicePixelRatio,0,2*Math.PI),n.stroke()}function wp(n){let{model:e}=n,t=Tt(null),i=Tt(null),[s,r]=$e(null),[o,a]=$e([0,0]),l=sa();ke(()=>{let h=t.current;if(!h)return;let f=new ResizeObserver(()=>a([Math.round(h.clientWidth*devicePixelRatio),Math.round(h.clientHeight*devicePixelRatio)]));return f.observe(h),()=>f.disconnect()},[]),ke(()=>r(null),[e.x.title,e.y.title]),ke(()=>{let[h,f]=o;if(h>0&&f>0){i.current=new OffscreenCanvas(h,f);let p=i.current.getContext("2d");p&&e.draw(p,h,f)}},[e,o,l]),ke(()=>{let h=t.current?.getContext("2d"),[f,p]=o;!t.current||!h||!i.current||(t.current.width=f,t.current.height=p,h.drawImage(i.current,0,0),s&&X1(h,s,f,p))},[e,s,o,l]);let c=h=>{let f=h.currentTarget.getBoundingClientRect(),p=(h.clientX-f.left)/f.width,v=1-(h.clientY-f.top)/f.height;return e.at(p,v,f.width,f.height)},u=h=>{let f=$1[h.key];f?(r(e.step(s,...f)),h.preventDefault()):h.key==="Enter"&&s&&n.open(s.scenario)},d=h=>ca(h,(h.first+h.last)/2);return m("div",{class:"plot",children:[m("div",{class:"y-axis","aria-hidden":"true",children:[m("span",{children:ca(e.y,e.y.last)}),m("b",{children:e.y.title}),m("span",{children:ca(e.y,e.y.first)})]}),m("canvas",{ref:t,tabIndex:0,role:"application","aria-label":`${e.x.title} against ${e.y.title}: arrows move, Enter opens. ${s?.text??""}`,onPointerMove:h=>r(c(h)),onPointerLeave:()=>r(null),onClick:h=>{let f=c(h);f&&n.open(f.scenario)},onKeyDown:u}),m("div",{class:"x-axis","aria-hidden":"true",children:[m("span",{children:ca(e.x,e.x.first)}),m("span",{children:[m("b",{children:e.x.title})," ",d(e.x)]}),m("span",{children:ca(e.x,e.x.last)})]}),m("p",{class:"readout","aria-live":"polite",children:s?s.text:"point at a place to read it; a click opens its worst scenario"})]})}var q1=1<<20;function Fr(n){return jn(n)?xo:Ml}function Ey(n,e,t,i){for(let s=0;s*t<e.length;++s){let[r,o]=[e,s*t];if(t===24){let a=Array.from({length:24},(l,c)=>e[24*s+c]);[r,o]=[Sl(ir(a.slice(0,12)),a.slice(12)),0]}for(let[a,l]of n)l[i+s]=Or(a,r,o)}}function Cy(n,e){return new Map(n.map(t=>[t,new Float64Array(e)]))}function Ry(n){return n.poses.of_both_bodies?24:12}async function Py(n,e,t){let i=Math.min(wl,n.scenarios),s=await Kt(`${gs(n,"poses")}?sample=${i}`,t),r=Cy(e,i);return Ey(r,s.values,Ry(n),0),r}function Ap(n){let[e,t]=[1/0,-1/0];for(let i of n)e=i<e?i:e,t=i>t?i:t;return e<t?[e,t]:[e-.5,e+.5]}function Tp(n){let e=r=>{let[o,a]=Ap(n.get(r)??new Float64Array(1));return(a-o)*(sr(r)?1e-6:1)},t=[...n.keys()],[i,s]=t.filter(r=>r!=="distance").sort((r,o)=>e(o)-e(r));return t.indexOf(i)<t.indexOf(s)?[i,s]:[s,i]}async function Iy(n,e){return Tp(await Py(n,Fr(n),e))}function Ly(n,e){return e.scenarios<=q1||!aa(n,0,e.scenarios)}async function Dy(n,e,t,i,s){let r=e.scenarios;if(!aa(n,0,r))return Py(e,t,i);let o=Cy(t,r);for(let a=0;a<r;a+=Ri){let l=Math.min(Ri,r-a),c=await Kt(`${gs(e,"poses")}?first=${a}&count=${l}`,i);Ey(o,c.values,Ry(e),a),s((a+l)/r)}return o}var Rp=5e4,Ep=128,Ny=14;function Oy(n,e,t){let[i,s]=Ap(e),r=.03*(s-i);return{title:n,first:i-r,last:s+r,unit:sr(n)?"°":` ${t}`}}var Cp=class{constructor(e,t,i,s,r,o){this.results=e;this.px=t;this.py=i;this.x=s;this.y=r;this.noun=o;this.order=Uint32Array.from(t,(a,l)=>l).sort((a,l)=>this.rank(a)-this.rank(l)||a-l)}results;px;py;x;y;noun;order;rank(e){return Lr(this.kind(e))+this.results.countAt(e)/2**32}kind(e){return this.results.classes[e]??255}draw(e,t,i){let s=this.px.length,r=(s>2e4?1.5:s>2e3?2.4:3.4)*devicePixelRatio;e.lineWidth=Math.max(1,.4*r);for(let o=0;o<s;){let a=this.kind(this.order[o]);for(e.beginPath();o<s&&this.kind(this.order[o])===a;++o){let d=this.order[o];bu(e,a,this.px[d]*t,(1-this.py[d])*i,r)}let[l,c,u]=Ei(a);e.strokeStyle=`rgb(${l} ${c} ${u} / ${a===0?.6:.9})`,e.stroke()}}spot(e){let t=this.results.scenarioAt(e),i=this.results.countAt(e),s=[this.x,this.y].map((o,a)=>{let l=a===0?this.px[e]:this.py[e];return`${o.title} ${Et(o.first+l*(o.last-o.first))}${o.unit}`}),r=i>0?`, ${fe(i)} ${this.noun}s`:"";return{scenario:t,text:`#${t} ${ms(this.kind(e))}${r} at ${s.join(", ")}`,x:this.px[e],y:this.py[e],width:0,height:0}}at(e,t,i,s){let r=-1,o=Ny*Ny;for(let a=0;a<this.px.length;++a){let l=(this.px[a]-e)*i,c=(this.py[a]-t)*s,u=l*l+c*c;(u<o||u===o&&r>=0&&this.rank(a)>this.rank(r))&&(o=u,r=a)}return r<0?null:this.spot(r)}step(e,t,i){let s=e??{x:.5,y:.5},r=-1,o=1/0;for(let a=0;a<this.px.length;++a){let[l,c]=[this.px[a]-s.x,this.py[a]-s.y],u=l*t+c*i,d=l*l+c*c;u>0&&2*u*u>=d&&d<o&&(o=d,r=a)}return r<0?e:this.spot(r)}};function Uy(n,[e,t],[i,s],r,o="pair"){let[a,l]=[Oy(e,t,r),Oy(i,s,r)],c=(f,p)=>(p-f.first)/(f.last-f.first),u=Math.min(t.length,n.classes.length);if(u<=Rp){let f=(p,v)=>v.subarray(0,u).map(g=>c(p,g));return new Cp(n,f(a,t),f(l,s),a,l,o)}let d=new la(n,a,l,Ep,Ep,!0,()=>""),h=(f,p)=>Math.floor(c(f,p)*Ep);for(let f=0;f<u;++f)d.add(h(a,t[f]),h(l,s[f]),f);return d}var Su=16;function Fy(n,e,t,i){let s=[...new Set([e,t])].sort((a,l)=>n.strides[l]-n.strides[a]);if(s.reduce((a,l)=>a*n.axes[l].count,1)>Su*Ri)return null;let o=Float64Array.of(i.reduce((a,l,c)=>a+(s.includes(c)?0:l*n.strides[c]),0));for(let a of s){let[l,c,u]=[o,n.axes[a].count,n.strides[a]];o=Float64Array.from({length:l.length*c},(d,h)=>l[Math.floor(h/c)]+h%c*u)}return o}function ky(n){let e=[];for(let t of n){let i=e.at(-1);if(i&&t<i.first+Ri)i.count=t-i.first+1;else{if(e.length===Su)return null;e.push({first:t,count:1})}}return e}async function By(n,e,t,i){let s=new Uint8Array(e.length),r=new Uint32Array(e.length),o=0;for(let{first:a,count:l}of t){let c=await My(n,a,l,i);for(;o<e.length&&e[o]<a+l;++o)s[o]=c.classes[e[o]-a],r[o]=c.counts?.[e[o]-a]??0}return new Ur(0,n.scenarios,s,r,e)}var Y1=150;function Vy(n){ke(()=>Ti("pose space",()=>{let e=n?.step(null,1,0)??null;return{poseSpace:e&&{...e,axes:[n?.x.title,n?.y.title]}}}),[n])}function Mu(n){return m("label",{children:[n.label," ",m("select",{value:n.value,onChange:e=>n.choose(e.currentTarget.value),children:n.all.map(e=>m("option",{value:e,children:e},e))})]})}function J1(n,e){let[t=0,i=t]=n.varying(),[s,r]=[n.varyingNamed(e.x),n.varyingNamed(e.y)];return s!==void 0&&r!==void 0&&(s!==r||t===i)?[s,r]:[t,i]}function K1(n,e,t,i,s){let{job:r,results:o}=n,a=o.isExact?null:[t,i,...s].join(" "),l=lt(()=>a===null?null:Fy(e,t,i,s),[a]),c=lt(()=>l&&ky(l),[l]);return{...Ls(c&&a,o,async d=>(await new Promise(h=>setTimeout(h,Y1)),By(r,l??new Float64Array,c??[],d))),isTooScattered:a!==null&&c===null}}function Z1(n,e){if(n.isExact||e.value)return"";let t=e.isTooScattered?`: this slice lies in more than ${Su} windows of ${fe(Ri)}`:"; reading the slice…";return`a sample of ${fe(n.classes.length)}, other axes folded${t}`}function j1(n){let{job:e,grid:t,results:i,view:s,change:r}=n,[o,a]=J1(t,s),l=t.axes.map(({name:b},E)=>b in s.at?t.nearest(E,s.at[b]):0),c=b=>b!==o&&b!==a,u=lt(()=>l.map((b,E)=>c(E)?b:0),[o,a,...l]),d=K1(n,t,o,a,u),h=d.value??i,f=lt(()=>Ay(t,h,o,a,u),[t,h,o,a,u]);Vy(f);let p=t.varying(),v=b=>t.axes[b].name,g=p.map(v),_=(b,E)=>{let M=t.varyingNamed(E)??o,[I,C]=b==="x"?[o,a]:[a,o],y=M===C?I:C,[T,k]=b==="x"?[M,y]:[y,M];r({x:v(T),y:v(k)})};return m(mn,{title:"pose space",note:Z1(i,d),children:[d.error&&m(Ct,{kind:"bad",children:d.error}),m("div",{class:"controls",children:[p.length>1&&m(Pt,{children:[m(Mu,{label:"across",value:v(o),all:g,choose:b=>_("x",b)}),m(Mu,{label:"up",value:v(a),all:g,choose:b=>_("y",b)})]}),!d.isTooScattered&&p.filter(c).map(b=>m("label",{class:"slider",children:[m("input",{type:"range",min:0,max:t.axes[b].count-1,value:u[b],onInput:E=>{let M=t.brief(b,Number(E.currentTarget.value));r({at:{...s.at,[v(b)]:M}})}})," ",t.valueText(b,u[b])]},b))]}),m(wp,{model:f,open:b=>Zs(en(e.job,b))})]})}function zy(n,e){return e.includes(n)}function Q1({source:n,job:e,view:t},i){let s=zy(t.x,Fr(e))&&zy(t.y,Fr(e))?[t.x,t.y]:null,r=Ly(n,e),o=Ls(s||r?null:e.job,0,d=>Iy(e,d)),a=r?Fr(e):s??o.value,l=Ls(a&&a.join(" "),0,d=>Dy(n,e,a??[],d,i)),c=l.value,u=lt(()=>r?c&&Tp(c):o.value,[c,o.value]);return{drawn:s??u,all:c,error:o.error||l.error}}function eA(n){let{job:e,results:t,change:i}=n,[s,r]=$e(0),{drawn:o,all:a,error:l}=Q1(n,r),[c,u]=o??Fr(e),[d,h]=[a?.get(c),a?.get(u)],f=lt(()=>d&&h?Uy(t,[c,d],[u,h],e.unit,_i(e)):null,[t,c,u,d,h]);Vy(f);let p=[t.isExact?"":`a sample of ${fe(t.classes.length)}`,t.classes.length>Rp?"share of contacts in each cell":"",e.poses.penetration?"poses pushed to contact":""];return m(mn,{title:jn(e)?"directions":"pose space",note:p.filter(v=>v!=="").join(", "),children:[l&&m(Ct,{kind:"bad",children:l}),m("div",{class:"controls",children:[m(Mu,{label:"across",value:c,all:Fr(e),choose:v=>i({x:v,y:u})}),m(Mu,{label:"up",value:u,all:Fr(e),choose:v=>i({x:c,y:v})}),m("span",{class:"note",children:jn(e)?"where the lines come from":"of B in A's frame"})]}),f?m(wp,{model:f,open:v=>Zs(en(e.job,v))}):m("p",{class:"wait",children:["reading the poses… ",s>0&&Sn(s)]})]})}function Hy(n){let e=lt(()=>Ty(n.job),[n.job.job]);return Lt(n.job)&&!jn(n.job)?null:e?m(j1,{...n,grid:e}):m(eA,{...n})}var tA=1024;function nA(n,e,t){return n&&n[0]<e?[n[0],Math.min(e,n[1])]:t}function iA(n,e,t){if(t>0)return`${fe(e.classes.length)} of a sample of ${fe(t)}`;let i=`windows of at most ${fe(Sp(n))} are exact`;return e.isSample?`a sample of ${fe(e.classes.length)}; ${i}`:""}function sA(n,e){return e.reduce((t,i)=>t+(i>=0&&n.classes[i]!==255?1:0),0)}function rA(n,e,t){let i=Math.min(tA,t-e),s=new Int32Array(i).fill(-1);for(let r=0;r<n.classes.length;++r){let o=n.scenarioAt(r);if(o<e||o>=t)continue;let a=Math.floor((o-e)*i/(t-e));(s[a]<0||n.isWorse(r,s[a]))&&(s[a]=r)}return s}function oA(n,e,t,{bin:i,drag:s}){let r=Math.round(n.clientWidth*devicePixelRatio),o=Math.round(n.clientHeight*devicePixelRatio),a=n.getContext("2d");if(!a||r===0)return;n.width=r,n.height=o;let l=c=>[c,c+1].map(u=>Math.round(u*r/t.length));if(t.forEach((c,u)=>{if(c<0)return;let d=e.classes[c],[h,f]=l(u),p=o*ay(d),v=f-h>4*devicePixelRatio?devicePixelRatio:0;a.fillStyle=Dr(d),a.fillRect(h,o-p,Math.max(1,f-h-v),p)}),a.fillStyle=cs("--accent"),i>=0){let[c,u]=l(i);a.fillRect(c,0,Math.max(2*devicePixelRatio,u-c),3*devicePixelRatio)}if(s){let[c,u]=[Math.min(...s)*r,Math.max(...s)*r];a.globalAlpha=.25,a.fillRect(c,0,u-c,o)}}function aA([n,e],t,i,s){let r=Math.max(1,Math.min(s,i?Math.ceil((e-n)/2):2*(e-n))),o=(t-n)/(e-n),a=Math.min(s-r,Math.max(0,Math.floor(t)-Math.floor(o*r)));return[a,a+r]}function lA([n,e],t,i){let s=e-n,r=Math.min(i-s,Math.max(0,Math.round(t-s/2)));return t>=n&&t<e?[n,e]:[r,r+s]}function cA(n,e,t,[i,s]){let r=t.isSample&&aa(n,i,s),o=Ls(r?`${i} ${s}`:null,t,a=>vu(n,e,i,s,a));return{results:o.value??t,error:o.error}}function Gy(n){let{source:e,job:t}=n,i=t.scenarios,s=Tt(null),[r,o]=$e(null),[a,l]=$e(-1),[c,u]=$e(0),d=sa(),h=n.range??[0,i],f=nA(n.view.window,i,h),[p,v]=f,{results:g,error:_}=cA(e,t,n.results,f),b=lt(()=>rA(g,p,v),[g,p,v]),E=b.length,M=Y=>Math.floor((Y-p)*E/(v-p)),I=a>=p&&a<v?M(a):-1,C=Y=>p+Math.ceil(Y*(v-p)/E);ke(()=>{let Y=s.current;if(!Y)return;let oe=new ResizeObserver(()=>u(Y.clientWidth));return oe.observe(Y),()=>oe.disconnect()},[]),ke(()=>{s.current&&oA(s.current,g,b,{bin:I,drag:r})},[g,b,I,r,c,d]),ke(()=>Ti("strip",()=>({strip:{first:p,end:v,mark:a,isExact:g.isExact,shown:sA(g,b)}})),[g,b,a]);let y=([Y,oe])=>n.change({window:Y===h[0]&&oe===h[1]?null:[Y,oe]}),T=Y=>{let oe=Y.currentTarget.getBoundingClientRect();return Math.min(1,Math.max(0,(Y.clientX-oe.left)/oe.width))},k=Y=>C(Math.min(E-1,Math.floor(Y*E))),D=Y=>{b[Y]>=0&&Zs(en(t.job,g.scenarioAt(b[Y]),Ds(n.view.filter)))},L=()=>{if(!r)return;let[Y,oe]=[Math.min(...r),Math.max(...r)];if(o(null),oe-Y<.005){D(Math.min(E-1,Math.floor(Y*E)));return}let ue=Math.floor(p+Y*(v-p));y([ue,Math.max(ue+1,Math.ceil(p+oe*(v-p)))]),l(-1)},H=Y=>{let oe=I<0?Y>0?p:v-1:Y>0?C(I+1):C(I)-1,ue=Math.min(i-1,Math.max(0,oe));l(ue),y(lA(f,ue,i))},V=Y=>y(aA(f,I<0?(p+v)/2:a,Y,i)),O={ArrowRight:()=>H(1),ArrowLeft:()=>H(-1),"+":()=>V(!0),"-":()=>V(!1),Enter:()=>D(I),Escape:()=>y(h)},$=Y=>{let oe=Y.ctrlKey||Y.altKey||Y.metaKey?void 0:O[Y.key];oe&&(oe(),Y.preventDefault())},q=I>=0?b[I]:-1,G=q>=0?g.distanceAt(q):null,ce=G===null?"":`, ${Et(G,6)} ${t.unit} apart`,K=q>=0&&Lt(t)?`, ${ft(g.countAt(q),"hit")}`:"",ee=q>=0?`#${g.scenarioAt(q)} ${ms(g.classes[q])}${ce}${K}, the ${K?"most":"worst"} of this bin`:"drag to zoom, click to open";return m(mn,{title:"scenarios in order",wide:!0,note:iA(e,g,n.chosenOf??0),children:[_&&m(Ct,{kind:"bad",children:_}),m("canvas",{ref:s,class:"strip",tabIndex:0,role:"application","aria-label":`scenarios ${p} to ${v-1}: arrows move, plus and minus zoom, Enter opens, Escape shows all. ${ee}`,onPointerDown:Y=>{Y.currentTarget.setPointerCapture(Y.pointerId),o([T(Y),T(Y)])},onPointerMove:Y=>{l(k(T(Y))),o(r&&[r[0],T(Y)])},onPointerUp:L,onPointerCancel:()=>o(null),onPointerLeave:()=>r||l(-1),onKeyDown:$}),m("div",{class:"x-axis",children:[m("span",{children:["#",fe(p)]}),m("span",{class:"readout",children:ee}),m("span",{children:[n.view.window&&m("button",{type:"button",class:"quiet",onClick:()=>y(h),children:"show all"})," ","#",fe(v-1)]})]})]})}function Wy(n){let e=`jobs/${encodeURIComponent(n)}`,t=ps(e,1,()=>!1),i=t.value!==void 0&&!oa(t.value),s=ps(i?`${e}/progress`:null,1,l=>!oa(l)),r=s.value!==void 0&&oa(s.value),o=ps(r?e:null,1,()=>!1);return{value:lt(()=>o.value??(t.value&&{...t.value,...s.value}),[t.value,s.value,o.value]),error:t.error||s.error||o.error}}var uA=3e3;function $y(n,e){let[t,i]=$e({results:null,error:"",done:-1,at:0}),[s,r]=$e(0);return ke(()=>{if(!e)return;let o=new AbortController,a=(l,c)=>i(u=>({results:l??u.results,error:c,done:e.done,at:performance.now()}));return vu(n,e,0,e.scenarios,o.signal).then(l=>a(l,""),l=>ls(l)||a(null,Rn(l))),()=>o.abort()},[e?.job,s]),ke(()=>{if(!e||t.done<0||e.done===t.done)return;let o=Math.max(0,t.at+uA-performance.now()),a=setTimeout(()=>r(l=>l+1),o);return()=>clearTimeout(a)},[e?.done,t]),t}var hA=1<<20,wu=class{constructor(e,t,i){this.results=e;this.rows=t;this.total=i}results;rows;total;get count(){return this.rows.length/3}get areAll(){return this.count===this.total}stepOf(e){return this.rows[3*e]}pairOf(e){return[this.rows[3*e+1],this.rows[3*e+2]]}elementOf(e){return this.count===this.results.classes.length?e:Math.floor(e*this.total/this.count)}classOf(e){return this.results.classes[this.elementOf(e)]}chosen(e,t){return Array.from({length:this.count},(i,s)=>s).filter(i=>{let s=this.stepOf(i);return(!t||s>=t[0]&&s<=t[1])&&(e<0||this.pairOf(i).includes(e))})}resultsOf(e){let{results:t}=this,i=e.map(o=>this.elementOf(o)),s=t.counts,r=t.distances;return new Ur(t.first,t.end,Uint8Array.from(i,o=>t.classes[o]),s&&Uint32Array.from(i,o=>s[o]),Float64Array.from(i,o=>t.scenarioAt(o)),r&&Float64Array.from(i,o=>r[o]))}};function Xy(n,e){let t=Array.from({length:e},(i,s)=>({body:s,scenarios:0,contacts:0,near:0,worst:-1}));for(let i=0;i<n.count;++i){let[s,r]=[n.classOf(i),n.elementOf(i)];for(let o of n.pairOf(i)){let a=t[o];a.scenarios+=1,a.contacts+=yl(s)?1:0,a.near+=s===7?1:0,a.worst=a.worst<0||n.results.isWorse(r,a.worst)?r:a.worst}}return t}function qy(n,e,t,i){let s=t.toLowerCase(),r=(o,a)=>a.contacts-o.contacts||a.near-o.near||a.scenarios-o.scenarios||o.body-a.body;return n.filter(({body:o})=>e[o].toLowerCase().includes(s)).sort(r).slice(0,i)}async function Yy(n,e,t){let i=gs(n,"bodies"),s=n.scenarios;if(!e.isExact||s>hA){let o=await Kt(`${i}?sample=${wl}`,t);return new wu(e,o.values,s)}let r=new Uint32Array(3*s);for(let o=0;o<s;o+=Ri){let a=Math.min(Ri,s-o),l=await Kt(`${i}?first=${o}&count=${a}`,t);r.set(l.values,3*o)}return new wu(e,r,s)}var Pp=100;function dA({job:n,rows:e,filter:t},{worst:i}){if(i<0)return"-";let s=e.results.scenarioAt(i);return m("a",{href:en(n.job,s,Ds(t)),children:[m(mi,{kind:e.results.classes[i]})," #",fe(s)]})}function fA(n,e){let{job:t,filter:i,change:s}=n,r=(a,l)=>({key:a,title:l,cell:c=>fe(c[a]),value:c=>c[a],isNumber:!0}),o=({body:a})=>i.body===e[a];return[{key:"body",title:"body",cell:a=>m("button",{type:"button",class:"link","aria-pressed":o(a),onClick:()=>s({...i,body:o(a)?"":e[a.body]}),children:m(et,{text:e[a.body]})}),value:({body:a})=>e[a]},r("contacts","in contact"),...t.clearance===null?[]:[r("near","near")],r("scenarios","scenarios"),{key:"worst",title:"worst",cell:a=>dA(n,a),value:({worst:a})=>a<0?0:n.rows.results.countAt(a),isNumber:!0}]}function pA({job:n,filter:e,change:t}){let i=e.steps?vl(e.steps):"";return m("div",{class:"controls",children:[m("label",{children:["steps"," ",m("input",{type:"text",size:12,"aria-label":"range of steps",placeholder:`0-${(n.steps??1)-1}`,value:i,onChange:s=>t({...e,steps:xp(s.currentTarget.value)})})]}),es(e)&&m("span",{class:"note",children:["only ",e.body?m(et,{text:e.body}):"scenarios",i&&` in steps ${i}`," ",m("button",{type:"button",class:"link",onClick:()=>t(yo),children:"show all"})]})]})}function Jy(n){let{job:e,rows:t}=n,[i,s]=$e(""),r=lt(()=>e.bodies.map(({name:u})=>u),[e.job]),o=lt(()=>Xy(t,r.length),[t,r]),a=lt(()=>qy(o,r,i,Pp),[o,r,i]),l=t.areAll?"":`; counted in a sample of ${ft(t.count,"scenario")}`,c=r.length>Pp?`at most ${Pp} of `:"";return m(mn,{title:"bodies",note:`${c}${fe(r.length)} bodies, most contacts first${l}`,children:[m(pA,{job:e,filter:n.filter,change:n.change}),m("input",{type:"search","aria-label":"bodies whose name holds",placeholder:"a body's name",value:i,onInput:u=>s(u.currentTarget.value)}),m(ri,{caption:"bodies",rows:a,rowKey:({body:u})=>String(u),empty:"no body has such a name",columns:fA(n,r)})]})}function Ky(n,e,t){let i=new Map,s=[],r=0;for(let o=0;o<n.count;++o){if(!du(n.classOf(o)))continue;let[a,l,c]=[n.stepOf(o),n.pairOf(o),n.elementOf(o)],u=l.join(" "),d=i.get(u);if(d&&d.last+1===a){d.last=a,d.worst=n.results.isWorse(c,d.worst)?c:d.worst;continue}let h=l.every(p=>e.bodies[p].fixed)?(e.steps??1)-1:a,f={pair:l,first:a,last:h,worst:c};i.set(u,f),r+=1,r<=t&&s.push(f)}return{count:r,listed:s}}var Ip=1e3;function mA(n,{results:e}){let t=({pair:i},s)=>gi(n,i)[s];return[{key:"a",title:"body A",cell:i=>m(et,{text:t(i,0)}),value:i=>t(i,0)},{key:"b",title:"body B",cell:i=>m(et,{text:t(i,1)}),value:i=>t(i,1)},{key:"first",title:"first step",cell:i=>fe(i.first),value:i=>i.first,isNumber:!0},{key:"last",title:"last step",cell:i=>fe(i.last),value:i=>i.last,isNumber:!0},{key:"worst",title:"worst",cell:i=>m("a",{href:en(n.job,e.scenarioAt(i.worst)),children:[m(mi,{kind:e.classes[i.worst]})," #",fe(e.scenarioAt(i.worst))]}),value:i=>e.countAt(i.worst),isNumber:!0}]}function Zy({job:n,rows:e}){let t=lt(()=>e.areAll?Ky(e,n,Ip):null,[e]);if(!t)return null;let i=n.clearance===null?"in contact":"in contact or near",s=t.count>Ip?`; the first ${fe(Ip)} are listed`:"";return m(mn,{title:"episodes",note:`${ft(t.count,"run")} of steps at which two bodies are ${i}${s}`,children:m(ri,{caption:"episodes",rows:t.listed,rowKey:r=>`${r.pair.join(" ")} ${r.first}`,empty:`no two bodies are ${i}`,columns:mA(n,e)})})}var Lp=5;function jy({job:n}){let{bodies:e}=n,t=new Map(e.map(o=>[o.sha256,o])),i=e.reduce((o,a)=>o+a.triangles,0),s=e.filter(o=>o.fixed).length,r=[...new Set([...t.values()].map(o=>us(o.file)))];return m("div",{class:"card",children:[m("b",{class:"letter",children:e.length>99?"n":e.length}),m("div",{children:[m("span",{children:[fe(e.length)," bodies of ",t.size===1?"1 mesh":`${fe(t.size)} meshes`]}),m("div",{class:"note",children:[ft(i,"triangle")," in all, ",s===0?"none":fe(s)," fixed"]}),m("div",{class:"note",children:[m(et,{text:r.slice(0,Lp).join(", ")}),r.length>Lp&&` and ${fe(r.length-Lp)} more`]})]})]})}function Qy(n,e){let t=new Map;n.bodies.forEach(({sha256:o})=>t.set(o,(t.get(o)??0)+1));let i=new Map(n.bodies.map(o=>[o.sha256,o.file])),s=[...t].map(([o,a])=>[a===1?"mesh of 1 body":`mesh of ${fe(a)} bodies`,`${o}, ${i.get(o)??""}`]),r=s.length-e;return r>0?[...s.slice(0,e),["meshes",`and ${fe(r)} more`]]:s}function ex(n,e,t){let i=n!==void 0&&e!==null&&Xt(n),s=Ls(i?n.job:null,e,c=>n&&e?Yy(n,e,c):Promise.reject(new Error("there are no results"))),r=s.value,o=n&&t.body?yu(n.bodies,t.body):-1,a=t.body!==""&&o<0,l=lt(()=>!r||!es(t)?r?.results??e:r.resultsOf(a?[]:r.chosen(o,t.steps)),[r,e,t,o]);return{rows:r,results:l,error:s.error||(n&&a?`the job has no body '${t.body}'`:"")}}var gA=[0,67,68,77,69,83,72,49],Dp=29;async function _A(n,e){if(!globalThis.crypto?.subtle)return null;let t=new Uint8Array(await crypto.subtle.digest("SHA-256",n));return Array.from(t,i=>i.toString(16).padStart(2,"0")).join("")===e}function yA(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i+=3)for(let s=0;s<3;++s){let r=n[i+s];e[s]=r<e[s]?r:e[s],t[s]=r>t[s]?r:t[s]}return n.length===0?[[0,0,0],[0,0,0]]:[e,t]}function xA(n,e,t){let i=new DataView(n);if(n.byteLength<Dp||gA.some((p,v)=>i.getUint8(v)!==p))throw new Error("the server's mesh is not in canonical form");let s=i.getUint8(8)===1,r=Number(i.getBigUint64(9,!0)),o=Number(i.getBigUint64(17,!0)),a=Dp+r*3*(s?8:4),l=a+o*12;if(l>n.byteLength)throw new Error("the server's mesh is cut short");let c=n.slice(Dp,a),u=s?new Float64Array(c):new Float32Array(c),d=new Uint32Array(n.slice(a,l)),[h,f]=yA(u);return{sha256:e,checked:t,bytes:n.byteLength,vertices:u,triangles:d,min:h,max:f,centre:[0,1,2].map(p=>(h[p]+f[p])/2)}}async function Al(n,e){let t=await b0(`meshes/${n}`,e),i=await _A(t,n);try{return xA(t,n,i)}catch(s){throw i===!1?new Error(`not the tested geometry: ${Rn(s)}`):s}}function Au(n){let{vertices:e,triangles:t,centre:i}=n,[s,r,o]=i,a=new Float32Array(3*t.length);for(let l=0;l<t.length;++l){let c=3*t[l];a[3*l]=e[c]-s,a[3*l+1]=e[c+1]-r,a[3*l+2]=e[c+2]-o}return a}var Np=class{constructor(e,t){this.names=e;this.runs=t}names;runs;runOf(e){let t=0,i=this.runs.length/2;for(;i-t>1;){let s=t+i>>1;this.runs[2*s]<=e?t=s:i=s}return t}partOf(e){return this.runs[2*this.runOf(e)+1]}nameOf(e){return this.names[this.partOf(e)]??""}isOf(e,t){return t===""||this.nameOf(e)===t}placeOf(e){let t=this.runOf(e),i=e-this.runs[2*t];for(let s=0;s<t;++s)this.runs[2*s+1]===this.runs[2*t+1]&&(i+=this.runs[2*s+2]-this.runs[2*s]);return i}};async function Op(n,e){return(await Kt(`jobs/${encodeURIComponent(n)}/parts/${e}/closed`)).values}async function kr(n,e){let t=`jobs/${encodeURIComponent(n)}/parts/${e}`,[i,s]=await Promise.all([Kt(t),Ai(`${t}/names`)]);return new Np(s,i.values)}var Tu=class{constructor(e,t=Al){this.trianglesMax=e;this.read=t}trianglesMax;read;kept=new Map;get({sha256:e,triangles:t}){let i=this.kept.get(e)?.mesh??this.read(e);return this.kept.delete(e),this.kept.set(e,{mesh:i,triangles:t}),i.catch(()=>this.kept.delete(e)),this.drop(e),i}drop(e){let t=[...this.kept.values()].reduce((i,s)=>i+s.triangles,0);for(let[i,{triangles:s}]of this.kept){if(t<=this.trianglesMax||i===e)return;this.kept.delete(i),t-=s}}};var Tl=[[68,1,84],[71,45,123],[59,82,139],[44,114,142],[33,145,140],[40,174,128],[94,201,98],[173,220,48],[253,231,37]];function Up(n){let e=Math.min(1,Math.max(0,n))*(Tl.length-1),t=Math.min(Tl.length-2,Math.floor(e)),i=e-t;return[0,1,2].map(s=>Math.round(Tl[t][s]+(Tl[t+1][s]-Tl[t][s])*i))}function tx(n){let e=new Uint8Array(1024);for(let t=0;t<256;++t)e.set([...t===0?n:Up((t-1)/254),255],4*t);return e}function vA(n,e){return n===0?0:e<=1?255:1+Math.round(254*Math.log(n)/Math.log(e))}function nx(n,e){let t=new Float64Array(e);for(let i=0;i+1<n.length;i+=2)t[n[i]]=n[i+1];return t}function ix(n,e){let t=new Uint8Array(3*n.length);for(let i=0;i<n.length;++i)t.fill(vA(n[i],e),3*i,3*i+3);return t}var bo=8e6,Eu=null,bA=new Tu(bo),vo=new Map,SA=16;async function MA(n){let e=performance.now(),[t,i]=n.bodies.map(l=>l.sha256),s=Al(t),r=Promise.all([kr(n.job,0),kr(n.job,1)]),o=await Promise.all([s,t===i?s:Al(i)]),a=Lt(n)?await Op(n.job,0):null;return{bodies:tr,meshes:o,parts:await r,closed:a,milliseconds:performance.now()-e}}function Cu(n,e){return bA.get(n.bodies[e])}async function wA(n,e){let t=performance.now(),[i,s]=e,r=Promise.all([kr(n.job,i),kr(n.job,s)]),o=await Promise.all([Cu(n,i),Cu(n,s)]),a=Lt(n)?await Op(n.job,i):null;return{bodies:e,meshes:o,parts:await r,closed:a,milliseconds:performance.now()-t}}function sx(n,e){let t=[n.job,...e].join(" "),i=vo.get(t)??wA(n,e);return vo.delete(t),vo.set(t,i),i.catch(()=>vo.delete(t)),vo.size>SA&&vo.delete(vo.keys().next().value??t),i}function Br(n,e){return e.reduce((t,i)=>t+(n.bodies[i]?.triangles??0),0)}function rx(n){return!Xt(n)&&Br(n,tr)>bo}function ox(n){let e=[n.job,...n.bodies.map(t=>t.sha256)].join(" ");if(Eu?.key!==e){let t=MA(n);Eu={key:e,model:t},t.catch(()=>{Eu=null})}return Eu.model}async function ax(n,e){try{let i=(await Promise.all([0,1].map(r=>Kt(`jobs/${encodeURIComponent(n.job)}/map/${r}`)))).map((r,o)=>nx(r.values,e.meshes[o].triangles.length/3)),s=i.reduce((r,o)=>o.reduce((a,l)=>Math.max(a,l),r),0);return{counts:i,most:s}}catch(t){if(t instanceof wi&&t.status===404)return null;throw t}}var AA=65;function Fp(n,e,t){return(1-t)*n+t*e}function TA([n,e,t,i],[s,r,o]){let a=2/(n*n+e*e+t*t+i*i);return[1-a*(t*t+i*i),a*(e*t-n*i),a*(e*i+n*t),s,a*(e*t+n*i),1-a*(e*e+i*i),a*(t*i-n*e),r,a*(e*i-n*t),a*(t*i+n*e),1-a*(e*e+t*t),o]}function El(n,e,t){let s=n.slice(0,4).reduce((o,a,l)=>o+a*e[l],0)>0?1:-1,r=o=>Fp(n[o],o<4?s*e[o]:e[o],t);return TA([r(0),r(1),r(2),r(3)],[r(4),r(5),r(6)])}function EA({from:n,to:e},t){return{pose_a:El(n.a,e.a,t),pose_b:El(n.b,e.b,t)}}function CA({from:n,to:e},t){let i=s=>Fp(n.b[s],e.b[s],t);return zi(ir(El(n.a,e.a,t)),[i(4),i(5),i(6)])}function ua(n,e){return e/2**n.depth}function ha(n){return n.event===null?null:ua(n,n.event)}function da(n){return ha(n)??0}function kp({motion:n},e){return n?e??da(n):0}function Cl({pose_a:n,pose_b:e,motion:t},i){return t?EA(t,kp({motion:t},i)):{pose_a:n,pose_b:e}}function Ru(n,e){return xu(Cl(n,e))}function fa({class:n}){return n==="near"||n==="inside"}function lx({motion:n},e){return!n||e===null||e===da(n)}function So(n){let e=[],t=(s,r,o)=>{(s<r||o==="event")&&e.push({from:ua(n,s),to:ua(n,r),kind:o})};for(let{state:s,first:r,count:o,event_first:a,event_last:l}of n.runs){if(a===null||l===null){t(r,r+o,s);continue}t(r,a,"open"),t(a,l,"event"),t(l,r+o,"open")}let i=n.runs.at(-1);return t(i?i.first+i.count:0,2**n.depth,"unknown"),e}function RA(n,e){let t=n.filter(({from:i,to:s})=>i<=e&&e<=s).map(({kind:i})=>i);return["event","open","free"].find(i=>t.includes(i))??"unknown"}function cx(n){return So(n).map(({from:e,to:t,kind:i})=>{let s=e===t?0:Math.max(1,Math.ceil((t-e)*(AA-1)));return{points:Array.from({length:s+1},(o,a)=>CA(n,s===0?e:Fp(e,t,a/s))),kind:i}})}function ux(n){return String(Number(n.toPrecision(6)))}function hx(n,e){let[t,i]=[n.t0,n.t1].map(r=>ux(ua(n,r))),s=e?"near":"in contact";return n.until==="free"&&n.end==="free"?`free from ${i} of the way on`:n.end==="limit"&&n.event===null?`known up to ${i} of the way`:n.event===null?n.runs.some(({state:r})=>r==="open")?"not decided where open":"free throughout":n.until==="free"?`${s} at ${t} of the way, not free up to ${i}`:t===i?`${s} at ${i} of the way`:`first ${s} between ${t} and ${i} of the way`}function dx(n,e,t){let i=RA(So(n),t),s={free:"free",open:"open: not decided",event:e?"near":"in contact",unknown:"not searched"}[i],r=ha(n),o=r===null?"no contacts to draw":t===r?"the event, contacts are drawn":"contacts are drawn at the event only";return`at ${ux(t)} of the way: ${s}; ${o}`}var fx=65536,Bp=200,zp=8e6;function px(n,e){let t=new Set;for(let i=0;3*i<n.length;++i)for(let s of[0,1]){let r=n[3*i+1+s];t.has(r)||(t.add(r),e(r,i,s))}}function PA(n,e){let t=new Map;return px(n,(i,s,r)=>{let o=Array.from({length:12},(a,l)=>e[24*s+12*r+l]);t.set(i,()=>o)}),t}function IA(n,e){let t=new Map;return px(n,(i,s,r)=>{let o=c=>Array.from({length:7},(u,d)=>e[28*s+14*c+7*r+d]),[a,l]=[o(0),o(1)];t.set(i,c=>El(a,l,c))}),t}function Vp(n,e,t,i,s){return Kt(`jobs/${encodeURIComponent(n.job)}/${e}?first=${t}&count=${i}`,s)}async function LA(n,e,t){let i=Math.min(2,(n.steps??0)-e),{values:s}=await Vp(n,"steps",e,i,t);return[s[0],i===2?s[2]:n.scenarios]}async function mx(n,e,t,i){let[s,r]=e?.rangeOf(t)??await LA(n,t,i),o=Math.min(fx,r-s),a=gu(n),[l,c,u]=await Promise.all(["bodies","classes",a?"keys":"poses"].map(d=>Vp(n,d,s,o,i)));return{step:t,first:s,rows:l.values,classes:c.values,poses:(a?IA:PA)(l.values,u.values),isCut:o<r-s}}function DA(n,[e,t],i){let s=-1;for(let r=0;3*r<n.length;++r){let[o,a]=[n[3*r+1],n[3*r+2]];if(o===e&&a===t)return r;s<0&&(o===i||a===i)&&(s=r)}return Math.max(0,s)}async function gx(n,e,t,i,s,r){let[o,a]=e.rangeOf(t),l=await Vp(n,"bodies",o,Math.min(fx,a-o),r);return o+DA(l.values,i,s)}function _x({poses:n},e){return[...n.keys()].filter(t=>!e.includes(t)).sort((t,i)=>t-i)}function yx(n,e,t){if(t.length===0)return"none";let i=[...e,...t].reduce((s,r)=>s+n[r].triangles,0);return t.length>Bp||i>zp?"boxes":"meshes"}var xx=65536,NA=1<<20,Hp=class{constructor(e,t,i){this.firsts=e;this.times=t;this.scenarios=i}firsts;times;scenarios;get count(){return this.firsts.length}timeOf(e){return this.times[e]}rangeOf(e,t=e){return[this.firsts[e],t+1<this.count?this.firsts[t+1]:this.scenarios]}hasScenarios(e){let[t,i]=this.rangeOf(e);return t<i}nearest(e,t){let i=Math.min(this.count-1,Math.max(0,e)),s=(o,a)=>{for(let l=o;l>=0&&l<this.count;l+=a)if(this.hasScenarios(l))return l;return-1},r=s(i,t);return r>=0?r:s(i,-t)}within([e,t]){let i=this.count-1;return[Math.min(e,i),Math.min(t,i)]}},Pu=null;async function OA(n,e){let t=new Float64Array(e),i=new Float64Array(e);for(let s=0;s<e;s+=xx){let r=Math.min(xx,e-s),o=await Kt(`jobs/${encodeURIComponent(n.job)}/steps?first=${s}&count=${r}`);for(let a=0;a<r;++a)t[s+a]=o.values[2*a],i[s+a]=o.values[2*a+1]}return new Hp(t,i,n.scenarios)}function vx(n){if(Pu?.job!==n.job){let e=n.steps??0,t=e===0||e>NA?Promise.resolve(null):OA(n,e);Pu={job:n.job,steps:t},t.catch(()=>{Pu=null})}return Pu.steps}function Lu(n){let[e,t]=$e({steps:null,error:""});return ke(()=>{let i=!0;return n&&vx(n).then(s=>i&&t({steps:s,error:""}),s=>i&&t({steps:null,error:Rn(s)})),()=>{i=!1}},[n?.job]),e}function bx(n){return n instanceof wi&&n.status===404}var Iu={bodies:null,error:"",isLeftOut:!1};function Sx(n,e,t,i){let[s,r]=$e(Iu),o=t?.scenario.step;return ke(()=>{if(e===null&&!i||o===void 0)return;let a=new AbortController,l=c=>{let u=i&&bx(c);r({...Iu,step:o,error:u?"":Rn(c),isLeftOut:u})};return mx(n,e,o,a.signal).then(c=>a.signal.aborted||r({...Iu,step:o,bodies:c}),c=>ls(c)||a.signal.aborted||l(c)),()=>a.abort()},[n.job,e,o]),s.step===o?s:Iu}async function UA(n,e,t){let i=s=>Cu(n,s).catch(r=>bx(r)?null:Promise.reject(r));return Promise.all(e.map(s=>t==="meshes"?i(s):null))}var Gp={form:"none",count:0,boxes:0,error:""};function Mx(n,e,t,i){let[s,r]=$e(Gp);return ke(()=>{if(!e||!t||!i){e?.showOthers([]),r(Gp);return}let o=!0,a=Ci(t.scenario),l=_x(i,a),c=yx(n.bodies,a,l),u=d=>{if(o){e.showOthers(l.map((f,p)=>{let{low:v,size:g}=n.bodies[f],_=i.poses.get(f)??(()=>[]);return{body:f,poseAt:_,low:v,size:g,mesh:d[p]}}));let h=c==="meshes"?d.filter(f=>f===null).length:0;r({form:c,count:l.length,boxes:h,error:""})}};return UA(n,l,c).then(u,d=>o&&r({...Gp,count:l.length,error:Rn(d)})),()=>{o=!1}},[e,t,i]),s}function wx(n,e,t,i,s){let r=Tt(null);return ke(()=>()=>r.current?.abort(),[]),(o,a)=>{let l=e?.nearest(o,a)??-1;if(!e||!t||l<0||l===t.scenario.step)return;r.current?.abort();let c=new AbortController;r.current=c;let u=i.body?yu(n.bodies,i.body):-1;gx(n,e,l,Ci(t.scenario),u,c.signal).then(d=>c.signal.aborted||s(d),()=>{})}}var FA=[["n, p","next and previous scenario in contact, or what else is chosen"],["← →","previous and next scenario"],["esc","end a search for the next contact"]],kA=[[", .","previous and next step, at best of the same two bodies"]],BA=[["space","play, stop"],["h","heat map, contacts"],["g","ghost: A, B, none"],["x","contacts through walls"],["l","segments and points, or the path of a motion"],["s","section plane"],["[ ]","move the section plane"],["f","fit all into view"],["c","go to the contact"],["e","in a motion: the time of the event"],["shift ← → ↑ ↓","turn"],["shift W A S D","move up, left, down, right"],["+ −","nearer, farther"],["enter","in the picture: pick the triangle in its middle; with shift: of the ghost"],["drag, wheel","turn, zoom; with the right button or two fingers: move"],["click","pick a triangle; with shift: of the ghost"]];function Ax(n,e){return[...FA,...e?kA:[],...n?BA:[],["?","these keys"]]}var Tx=[["tab","from one part of the page to the next"],["← → ↑ ↓","in the pose space: the next place"],["← →","in the scenarios in order: the next bar; beyond the edge, further scenarios"],["+ −","there: half as many scenarios about the mark, or twice as many"],["enter","open the scenario at the mark"],["esc","all scenarios in order"],["?","these keys"]];function Du({title:n,keys:e,close:t}){let i=Tt(null);return ke(()=>i.current?.showModal(),[]),m("dialog",{ref:i,class:"keys",onClose:t,onClick:()=>i.current?.close(),children:[m("h2",{children:n}),m("table",{children:m("tbody",{children:e.map(([s,r])=>m("tr",{children:[m("th",{scope:"row",children:m("kbd",{children:s})}),m("td",{children:r})]},r))})}),m("button",{type:"button",children:"close"})]})}function Nu(n,e=document){let t=Tt(n);t.current=n,ke(()=>{let i=s=>{if(!(s instanceof KeyboardEvent))return;let r=s.shiftKey&&s.key.startsWith("Arrow"),o=t.current[r?`Shift+${s.key}`:s.key];o&&!zA(s)&&(o(),s.preventDefault())};return e.addEventListener("keydown",i),()=>e.removeEventListener("keydown",i)},[e])}function zA(n){let e=n.target;if(n.ctrlKey||n.altKey||n.metaKey)return!0;if(e instanceof HTMLInputElement){let s=e.type==="range"||e.type==="radio";return e.type==="number"||s&&n.key.startsWith("Arrow")}let t=e instanceof HTMLButtonElement&&n.key===" ",i=e instanceof Element?e.getRootNode():document;return t||e instanceof HTMLSelectElement||i.querySelector("dialog[open]")!==null}function VA(n){return n.touch+n.cross+n.inside+n.contact}function HA(n){if(n.clearance===null)return"";let e=`at most ${Et(n.clearance,6)} ${n.unit} apart`;return` In ${ft(n.near,"scenario")} without contact the bodies are ${e}, with ${ft(n.near_pairs,"near pair")}.`}function GA(n){let e=VA(n),t=Lt(n)?"bundle":"scenario",i=n.done===n.scenarios?"":` tested so far, of ${fe(n.scenarios)}`,s=Sn(e/Math.max(1,n.done)),r=e===1?"is":"are",o=`${ft(n.done,t)}${i}`;if(Lt(n)){let l=n.first_hits?`${ft(n.pairs,"line")} that cross A`:ft(n.pairs,"hit");return e===0?`No line hits anything in ${o}.`:`${fe(e)} of ${o} ${r} hit (${s}), with ${l}.`}let a=nr(n)?"":`, with ${ft(n.pairs,"pair")} of triangles`;return e===0?`No contact in ${o}.`:`${fe(e)} of ${o} ${r} in contact (${s})${a}.`}function WA({job:n}){return m("div",{class:"verdict",children:[m("h1",{children:[m(et,{text:n.name||n.job}),m("span",{class:`state ${n.state==="failed"?"bad":""}`,children:n.state}),!oa(n)&&m(fu,{done:n.done,total:n.scenarios})]}),m("p",{class:"sentence",children:[GA(n),HA(n)]}),m("p",{class:"counts",children:[ry.map(e=>{let t=hu[e],i=Lt(n)?"contact":"cross",s=t==="separate"||t===i||t==="failed";return m(ly,{kind:e,count:n[t],always:s||e===7&&n.clearance!==null},t)}),n.digest&&m("span",{class:"count",children:["digest ",m("code",{title:n.digest,children:n.digest.slice(0,16)})]})]})]})}function $A({job:n}){let e=[];return n.surfaces_only>0&&e.push(`Containment was not tested in ${ft(n.surfaces_only,"scenario")}: a body is open.`),n.insides_skipped>0&&e.push(`Containment was not tested in ${ft(n.insides_skipped,"scenario")}: triangles are ignored, and the rest of a body is open.`),n.cut>0&&e.push(`The list of ${_i(n)}s ends at ${fe(n.limit_pairs)} in ${ft(n.cut,"scenario")}; counts are true.`),n.map_pairs>0&&e.push(`The heat map counts the first ${fe(n.map_pairs)} ${_i(n)}s of a scenario.`),e.length===0?null:m("p",{class:"caveats",children:e.join(" ")})}function XA({body:n,letter:e,unit:t}){let i=n.closed===null?"":n.closed?", closed":", open";return m("div",{class:"card",children:[m("b",{class:"letter",children:e}),m("div",{children:[m(et,{text:us(n.file)}),n.name.toLowerCase()!==e.toLowerCase()&&m("span",{class:"note",children:[" ","called ",m(et,{text:n.name})]}),m("div",{class:"note",children:[ft(n.triangles,"triangle"),", ",ft(n.parts,"part"),i]}),m("div",{class:"note",children:[n.size.map(s=>Et(s)).join(" × ")," ",t," · ",n.precision]})]})]})}function qA({job:n,body:e}){let t=(n.poses.axes??[]).map(i=>`${i.name} ${fe(i.count)}`);return m("div",{class:"card",children:[m("b",{class:"letter",children:"B"}),m("div",{children:[m(et,{text:e.name}),m("div",{class:"note",children:[ft(e.triangles,"line"),jn(n)?" a bundle":""]}),m("div",{class:"note",children:jn(n)?`directions ${t.join(" × ")}`:`file ${us(n.poses.file??"")}`})]})]})}function YA(n){let{poses:e}=n;return e.kind==="shots"?jn(n)?"bundles of lines":"lines of a file":e.kind==="grid"?`grid ${(e.axes??[]).filter(i=>i.count>1).map(i=>`${i.name} ${fe(i.count)}`).join(" × ")}`:e.kind==="random"?`random, seed ${e.seed??"-"}${e.penetration?`, pushed ${e.penetration.map(t=>Sn(t)).join(" to ")} into contact`:""}`:`file ${us(e.file??"")}`}function JA({job:n}){return m("div",{class:"card",children:[m("b",{class:"letter",children:"×"}),m("div",{children:[m("span",{children:n.steps===void 0?ft(n.poses.count,"pose"):ft(n.steps,"step")}),m("div",{class:"note",children:[Xt(n)?ft(n.scenarios,"scenario"):YA(n),n.poses.of_both_bodies&&!Xt(n)?", of both bodies":""]}),m("div",{class:"note",children:["level ",nr(n)?"distance":n.level,n.first_hits&&", the first hit of each line",typeof n.up_to=="number"&&`, up to ${Et(n.up_to,6)} ${n.unit}`,n.clearance!==null&&`, clearance ${Et(n.clearance,6)} ${n.unit}`,n.ignored>0&&`, ${ft(n.ignored,"range")} ignored`]})]})]})}function KA({job:n}){let e=[["where",n.where],["instructions",n.simd],["time",n.seconds>0?`${uo(n.seconds)}, ${Cr(n.scenarios_per_second)}`:""],["owner",n.owner],["started",n.started||n.began],["ended",n.ended],["command",n.command],["program",[n.program,n.commit].filter(s=>s!=="").join(", commit ")],["digest",n.digest??""],...Xt(n)?Qy(n,20):n.bodies.map(s=>[`mesh ${s.name}`,`${s.sha256} (${js(s.bytes)}), ${s.file}`])],t=n.folder?ul(n.folder):n.job,i=(n.formats??[]).length>0?`the folder has ${n.formats?.join(", ")}; more:`:"";return m("details",{class:"how",children:[m("summary",{children:"how it ran, and exports"}),m("dl",{children:e.filter(([,s])=>s).map(([s,r])=>m("div",{children:[m("dt",{children:s}),m("dd",{children:m("bdi",{children:r})})]},s))}),m("p",{class:"note",children:[i," ",m(pu,{text:`cdctl results ${t}${n.folder?"":" --out out"} --formats csv,npz`})]})]})}function ZA(n,e,{rows:t,results:i}){ke(()=>Ti("job",()=>({ready:n!==void 0&&e!==null,job:n?.job,done:n?.done,isExact:e?.isExact,rows:t?.count,shown:i&&Array.from(i.classes.subarray(0,64),(s,r)=>i.scenarioAt(r)),tested:e?.classes.reduce((s,r)=>s+(r===255?0:1),0)})),[n,e,t,i])}function jA(n){let[e,t]=$e(()=>vp(n.query));return ke(()=>t(vp(n.query)),[n]),ke(()=>(Xc(()=>Ks(n.job,vy(e))),Er),[e]),[e,i=>t(s=>({...s,...i}))]}function Ex({source:n,route:e}){let t=e.job,[i,s]=jA(e),[r,o]=$e(!1),{value:a,error:l}=Wy(t),{results:c,error:u}=$y(n,a),d=ex(a,c,i.filter),{steps:h}=Lu(a),f=lt(()=>d.results?.worst()??0,[d.results]);if(Ir(a&&a.name||t),ZA(a,c,d),Nu({"?":()=>o(!0)}),!a)return l?m(Ct,{kind:"bad",children:l}):m("p",{class:"wait",children:["asking for ",t,"…"]});let p=l||u||d.error,v=h&&i.filter.steps?h.rangeOf(...h.within(i.filter.steps)):void 0,g=_=>s({filter:_,window:null});return m(Pt,{children:[p&&m(Ct,{kind:"bad",children:p}),a.failure&&m(Ct,{kind:"bad",children:["failed: ",m(et,{text:a.failure})]}),a.paused&&m(Ct,{kind:"warn",children:["paused: ",a.paused]}),m(WA,{job:a}),m("div",{class:"cards",children:[Xt(a)&&m(jy,{job:a}),(Xt(a)?[]:a.bodies).map((_,b)=>Lt(a)&&b===1?m(qA,{job:a,body:_},b):m(XA,{body:_,letter:b===0?"A":"B",unit:a.unit},b)),m(JA,{job:a}),m("a",{class:"card go",href:en(a.job,f,Ds(i.filter)),children:"see it in 3D"})]}),m($A,{job:a}),c?m(Pt,{children:[m("div",{class:"two",children:[Xt(a)?d.rows?m(Jy,{job:a,rows:d.rows,filter:i.filter,change:g}):m("p",{class:"wait",children:"reading the bodies of the scenarios…"}):m(Hy,{source:n,job:a,results:c,view:i,change:s}),a.groups?m(xy,{job:a,groups:a.groups}):m(mp,{job:a,results:c})]}),m(Gy,{source:n,job:a,results:d.results??c,chosenOf:es(i.filter)&&d.rows?.areAll===!1?d.rows.count:0,...v&&v[0]<v[1]?{range:v}:{},view:i,change:s}),nr(a)&&m("div",{class:"two",children:m(fy,{job:a,results:c})}),Lt(a)&&m("div",{class:"two",children:m(wy,{job:a,results:c})}),m("div",{class:"two",children:[a.groups&&m(mp,{job:a,results:c}),d.rows?m(Zy,{job:a,rows:d.rows}):m(py,{job:a,results:c})]})]}):m("p",{class:"wait",children:"reading the results…"}),m(KA,{job:a}),m("button",{type:"button",class:"quiet",onClick:()=>o(!0),children:"keys of this page"}),r&&m(Du,{title:"Keys of a job's page",keys:Tx,close:()=>o(!1)})]})}function Cx(n){let{steps:e,step:t,stepTo:i}=n,[s,r]=$e(t);ke(()=>r(t),[t]);let o=a=>{let l=Math.round(Number(a))||0;r(l),i(l,l<t?-1:1)};return m("div",{class:"scrub steps",role:"group","aria-label":"steps",children:[m("button",{type:"button",disabled:t<=0,onClick:()=>i(t-1,-1),title:",",children:"‹ previous step"}),m("button",{type:"button",disabled:t>=e.count-1,onClick:()=>i(t+1,1),title:".",children:"next step ›"}),m("label",{class:"number",children:["step"," ",m("input",{type:"number","aria-label":"step",min:0,max:e.count-1,value:s,onChange:a=>o(a.currentTarget.value)})]}),m("input",{type:"range","aria-label":`step, 0 to ${e.count-1}`,min:0,max:e.count-1,value:s,onInput:a=>o(a.currentTarget.value)}),m("span",{class:"note",children:["t ",Et(e.timeOf(t),6),", ",ft(e.count,"step")]})]})}function Rx({filter:n,drop:e}){return m("p",{class:"note scene-filter",children:["next and previous: only ",n.body?m(et,{text:n.body}):"scenarios",n.steps&&` in steps ${vl(n.steps)}`,";"," ",m("button",{type:"button",class:"link",onClick:e,children:"all"})]})}var Wp=100;function QA({rows:n,classes:e},t,i){let s=i.toLowerCase(),r=o=>t[o].name.toLowerCase().includes(s);return Array.from({length:n.length/3},(o,a)=>a).filter(o=>r(n[3*o+1])||r(n[3*o+2])).sort((o,a)=>Lr(e[a])-Lr(e[o])||o-a)}function eT({form:n,count:e,boxes:t,error:i},s){let r=s?" Bodies of the step's last scenarios are left out.":"",o=e===1?"1 other body":`${fe(e)} other bodies`;if(i)return`The other bodies are not drawn: ${i}`;if(n==="boxes")return`${o}: boxes only, above ${Bp} bodies or ${fe(zp)} triangles.${r}`;let a=t>0?` Of ${fe(t)} this report has no mesh, so boxes are drawn.`:"";return`${o} near another at this step, faint.${a}${r}`}function Px(n){let{job:e,step:t}=n,i=lt(()=>QA(t,e.bodies,n.text),[t,n.text]),s="pairs of bodies at this step";return m("section",{"aria-label":s,children:[m("h2",{children:s}),m("input",{type:"search","aria-label":"pairs of this body",placeholder:"a body's name",value:n.text,onInput:r=>n.setText(r.currentTarget.value)}),m("ul",{class:"pairs",children:i.slice(0,Wp).map(r=>{let[o,a]=gi(e,[t.rows[3*r+1],t.rows[3*r+2]]),l=t.first+r;return m("li",{children:m("button",{type:"button","aria-pressed":l===n.scenario,disabled:n.held?.includes(l)===!1,onClick:()=>n.open(l),children:[m("span",{children:[m(mi,{kind:t.classes[r]})," ",m(et,{text:o})," ",m("i",{children:"×"})," ",m(et,{text:a})]}),m("b",{children:["#",fe(l)]})]})},r)})}),i.length>Wp&&m("p",{class:"note",children:["and ",ft(i.length-Wp,"pair")," more"]}),m("p",{class:"note",children:eT(n.others,t.isCut)})]})}var tT=[150,155,160],nT=[214,216,219],[iT,sT]=[2,5];function $p(n,e){return{free:tT,open:Ei(sT),event:Ei(e?7:iT),unknown:nT}[n]}function Xp(n,e){let[t,i,s]=$p(n,e);return`rgb(${t} ${i} ${s})`}var[Mo,Ou]=[1e3,14],rT=4,oT=2**-10;function aT({motion:n,isNear:e,tau:t}){let i=[...new Set([n.t0,n.t1])].map(o=>Mo*ua(n,o)),s=So(n),r=[...s.filter(o=>o.kind!=="event"),...s.filter(o=>o.kind==="event")];return m("svg",{viewBox:`0 -6 ${Mo} ${Ou+12}`,preserveAspectRatio:"none","aria-hidden":"true",children:[r.map(({from:o,to:a,kind:l})=>{let c=Math.max(Mo*(a-o),l==="event"?rT:0),u=Math.min(Mo*o,Mo-c);return m("rect",{class:l,x:u,y:0,width:c,height:Ou,fill:Xp(l,e)},`${o} ${l}`)}),i.map(o=>m("line",{class:"bracket",x1:o,x2:o,y1:-6,y2:Ou+6},o)),m("line",{class:"now",x1:Mo*t,x2:Mo*t,y1:-2,y2:Ou+2})]})}function lT({motion:n,isNear:e}){let t={free:"free",open:"open",event:e?"near":"in contact",unknown:"not searched"},i=new Set(So(n).map(({kind:s})=>s));return m("span",{class:"time-legend note",children:Object.keys(t).filter(s=>i.has(s)).map(s=>m("span",{children:[m("i",{style:{background:Xp(s,e)}})," ",t[s]]},s))})}function Ix(n){let{motion:e,choose:t}=n,i=fa(n.scenario),s=n.tau??da(e),r=dx(e,i,s);return m("section",{class:"time-line","aria-label":"time of the motion",children:[m(aT,{motion:e,isNear:i,tau:s}),m("div",{children:[m("input",{type:"range","aria-label":"time","aria-valuetext":r,min:0,max:1,step:Math.max(oT,2**-e.depth),value:s,onInput:o=>t(Number(o.currentTarget.value))}),m("button",{type:"button",disabled:ha(e)===null,onClick:()=>t(null),title:"e",children:"event"})]}),m("output",{children:r}),m(lT,{motion:e,isNear:i})]})}function Lx(n){return m("fieldset",{class:"radio",children:[m("legend",{children:n.title}),n.all.map(([e,t])=>m("label",{children:[m("input",{type:"radio",name:n.name,checked:n.value===e,onChange:()=>n.choose(e)}),m("span",{children:t})]},e))]})}function Rl(n){return m("label",{class:"check",children:[m("input",{type:"checkbox",checked:n.isOn,onChange:e=>n.turn(e.currentTarget.checked)}),n.text]})}function cT(n){let{clip:e}=n.state,[t,i]=n.bounds[e?.axis??"x"],s=r=>(n.bounds[r][0]+n.bounds[r][1])/2;return m("div",{class:"section-plane",children:[m(Rl,{text:"section",isOn:e!==null,turn:r=>n.change({clip:r?{axis:"x",at:s("x")}:null})}),e&&m(Pt,{children:[m("select",{"aria-label":"axis of the section plane",value:e.axis,onChange:r=>{let o=r.currentTarget.value;n.change({clip:{axis:o,at:s(o)}})},children:["x","y","z"].map(r=>m("option",{children:r},r))}),m("input",{type:"range","aria-label":"place of the section plane",min:t,max:i,step:(i-t)/500||1,value:e.at,onInput:r=>n.change({clip:{axis:e.axis,at:Number(r.currentTarget.value)}})}),m("output",{children:Number(e.at.toPrecision(4))})]})]})}function Dx(n){let{state:e,change:t}=n,i=[["contacts","contacts"]];n.hasMap&&i.push(["heat","heat map"]);let s=[["a","A"],["b","B"],["none","none"]];return m("section",{class:"view-controls","aria-label":"view",children:[m(Lx,{title:"show",name:"mode",value:e.mode,all:i,choose:r=>t({mode:r})}),m(Lx,{title:"ghost",name:"ghost",value:e.ghost,all:s,choose:r=>t({ghost:r})}),m(Rl,{text:"through walls",isOn:e.throughWalls,turn:r=>t({throughWalls:r})}),n.lines.hasAllHits&&m(Rl,{text:"first hits only",isOn:e.onlyFirst,turn:r=>t({onlyFirst:r})}),m(Rl,{text:n.lines.name,isOn:e.lines,turn:r=>t({lines:r})}),n.hasOthers&&m(Rl,{text:"other bodies",isOn:e.others,turn:r=>t({others:r})}),m(cT,{state:e,bounds:n.bounds,change:t}),m("div",{class:"buttons",children:[m("button",{type:"button",onClick:n.fit,title:"f",children:"fit"}),m("button",{type:"button",onClick:n.goToContact,title:"c",children:["go to the ",n.lines.areDrawn?"hits":"contact"]})]})]})}function Nx({address:n}){let[e,t]=$e("");return m("button",{type:"button",onClick:()=>dp(n(),t),children:e||"copy link"})}var Uu=48;function uT(n){let e=[1];for(let t=10;t<n/2;t*=10)e.push(t);return n>1?[...e,n]:e}function Ox(n){return n.clearance===null?"in contact":"in contact or near"}function Ux({heat:n,job:e}){if(n.most===0)return m("p",{class:"note",children:["no triangle was ",Lt(e)?"crossed":Ox(e)]});let[t,i]=[264,10],s=o=>n.most<=1?0:Math.log(o)/Math.log(n.most)*t,r=uT(n.most);return m("figure",{class:"legend",children:[m("svg",{viewBox:`0 0 ${t} 42`,role:"img","aria-label":"colours of the heat map",children:[Array.from({length:Uu},(o,a)=>{let[l,c,u]=Up(a/(Uu-1));return m("rect",{x:a*t/Uu,y:0,width:t/Uu+.5,height:i,fill:`rgb(${l},${c},${u})`},a)}),r.map((o,a)=>m("g",{children:[m("line",{x1:s(o),x2:s(o),y1:i,y2:i+3}),m("text",{x:s(o),y:i+14,class:a===0?"begin":a===r.length-1?"end":"",children:fe(o)}),m("text",{x:s(o),y:i+27,class:a===0?"begin":a===r.length-1?"end":"",children:Lt(e)?"":Sn(o/Math.max(1,e.done))})]},o))]}),m("figcaption",{class:"note",children:[Lt(e)?"how often lines cross a triangle":`scenarios in which a triangle is ${Ox(e)}`,", logarithmic",e.map_pairs>0&&`, of the first ${fe(e.map_pairs)} pairs`,"; plain: never"]})]})}function Fx(n){return nr(n)?"the nearest triangles: the line joins their nearest points":n.clearance===null?"":"near: the line joins the nearest points"}function kx({near:n}){return m("ul",{class:"legend plain",children:[m("li",{children:[m("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:m("path",{d:"M1 11 7 1l6 10z",fill:Dr(2)})}),"proper: goes through the other"]}),m("li",{children:[m("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:m("path",{d:"M1 11 7 1l6 10z",fill:Dr(1),class:"outlined"})}),"touch or coplanar: outlined"]}),m("li",{children:[m("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:[m("path",{d:"M1 9 11 4",class:"thick"}),m("circle",{cx:12,cy:4,r:2})]}),"what they share"]}),n&&m("li",{children:[m("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:m("path",{d:"M1 11 7 1l6 10z",fill:Dr(7),class:"outlined"})}),n]})]})}var Bx=["enters","leaves","grazes"],Pl=class{constructor(e,t){this.pairs=e;this.rows=t;for(let i=0;i<this.count;++i){let s=this.lineOf(i),r=this.byLine.get(s);r?r.push(i):this.byLine.set(s,[i])}this.byLine.forEach(i=>i.sort((s,r)=>this.compare(s,r)))}pairs;rows;byLine=new Map;get count(){return Math.min(this.rows.length,this.pairs.length)/3}triangleOf(e){return this.pairs[3*e]}lineOf(e){return this.pairs[3*e+1]}depthOf(e){return this.rows[3*e]}doesCross(e){return(this.rows[3*e+1]&1)!==0}kindOf(e){return this.doesCross(e)?(this.rows[3*e+1]&4)!==0?"leaves":"enters":"grazes"}compare(e,t){let i=s=>(this.rows[3*s+1]&4)===0?1:0;return this.depthOf(e)-this.depthOf(t)||this.rows[3*e+2]-this.rows[3*t+2]||i(e)-i(t)||this.triangleOf(e)-this.triangleOf(t)}get lines(){return[...this.byLine.keys()]}ofLine(e){return this.byLine.get(e)??[]}shown(e){return[...this.byLine.values()].flatMap(t=>e?t.filter(i=>this.doesCross(i)).slice(0,1):t)}};function zx(n,e,t,i){let s=[],r=new Map;for(let o of n.ofLine(e).filter(a=>n.doesCross(a))){let a=t(n.triangleOf(o)),l=r.get(a);if(l){l.out=o,r.delete(a);continue}let c={part:a,in:o,out:null};s.push(c),i(a)&&r.set(a,c)}return s}function Fu(n,e){let t=i=>{let s=3*n.triangles[3*e+i];return Array.from(n.vertices.subarray(s,s+3))};return[t(0),t(1)]}function Vx([n,e],t){let i=Math.hypot(...e.map((s,r)=>s-n[r]));return n.map((s,r)=>s+(e[r]-s)/i*t)}function Hx(n,e,t,i){let s=[1/0,1/0,1/0],r=[-1/0,-1/0,-1/0];for(let o=0;o<e.triangles.length;++o)if(t.partOf(Math.floor(o/3))===i)for(let a=0;a<3;++a){let l=e.vertices[3*e.triangles[o]+a];s[a]=Math.min(s[a],l),r[a]=Math.max(r[a],l)}return!n.some(o=>o.every((a,l)=>a>=s[l]&&a<=r[l]))}var Qr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},eo={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},wv=0,Mm=1,Av=2;var dc=1,Tv=2,Va=3,to=0,Si=1,ei=2,Ro=0,Ha=1,wm=2,Am=3,Tm=4,Ev=5;var Po=100,Cv=101,Rv=102,Pv=103,Iv=104,Lv=200,Dv=201,Nv=202,Ov=203,Em=204,Cm=205,Uv=206,Fv=207,kv=208,Bv=209,zv=210,Vv=211,Hv=212,Gv=213,Wv=214,dh=0,fh=1,ph=2,Fs=3,mh=4,gh=5,_h=6,yh=7,$h=0,$v=1,Xv=2,zs=0,Rm=1,Pm=2,Im=3,Lm=4,Dm=5,Nm=6,Om=7;var Um=300,Io=301,Ga=302,Xh=303,qh=304,xh=1e3,Us=1001,vh=1002,Mn=1003,qv=1004;var fc=1005;var bi=1006,Yh=1007;var mr=1008;var Ii=1009,Fm=1010,km=1011,Wa=1012,Jh=1013,Ss=1014,ss=1015,Ms=1016,Kh=1017,Zh=1018,Lo=1020,Bm=35902,zm=35899,Vm=1021,Hm=1022,Ji=1023,hr=1026,gr=1027,jh=1028,Qh=1029,no=1030,ed=1031;var td=1033,pc=33776,mc=33777,gc=33778,_c=33779,nd=35840,id=35841,sd=35842,rd=35843,od=36196,ad=37492,ld=37496,cd=37488,ud=37489,yc=37490,hd=37491,dd=37808,fd=37809,pd=37810,md=37811,gd=37812,_d=37813,yd=37814,xd=37815,vd=37816,bd=37817,Sd=37818,Md=37819,wd=37820,Ad=37821,Td=36492,Ed=36494,Cd=36495,Rd=36283,Pd=36284,xc=36285,Id=36286;var Vl=2300,bh=2301,uh=2302,mm=2303,gm=2400,_m=2401,ym=2402;var Yv=3200;var Ld=0,Jv=1,_r="",cn="srgb",Hl="srgb-linear",Gl="linear",Bt="srgb";var hh=7680;var Kv=519,Zv=512,jv=513,Qv=514,Gm=515,eb=516,tb=517,Wm=518,$m=519,Xm=35044;var qm="300 es",ns=2e3,Ia=2001;function hT(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function dT(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function Wl(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function nb(){let n=Wl("canvas");return n.style.display="block",n}var Gx={},La=null;function $l(...n){let e="THREE."+n.shift();La?La("log",e,...n):console.log(e,...n)}function ib(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Ze(...n){n=ib(n);let e="THREE."+n.shift();if(La)La("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function rt(...n){n=ib(n);let e="THREE."+n.shift();if(La)La("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function kl(...n){let e=n.join(" ");e in Gx||(Gx[e]=!0,Ze(...n))}function sb(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var rb={[dh]:dh,[ph]:_h,[mh]:mh,[Fs]:gh,[fh]:fh,[_h]:ph,[yh]:yh,[gh]:Fs},vs=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},oi=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Wx=1234567,Bl=Math.PI/180,Da=180/Math.PI;function io(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(oi[n&255]+oi[n>>8&255]+oi[n>>16&255]+oi[n>>24&255]+"-"+oi[e&255]+oi[e>>8&255]+"-"+oi[e>>16&15|64]+oi[e>>24&255]+"-"+oi[t&63|128]+oi[t>>8&255]+"-"+oi[t>>16&255]+oi[t>>24&255]+oi[i&255]+oi[i>>8&255]+oi[i>>16&255]+oi[i>>24&255]).toLowerCase()}function pt(n,e,t){return Math.max(e,Math.min(t,n))}function Ym(n,e){return(n%e+e)%e}function fT(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function pT(n,e,t){return n!==e?(t-n)/(e-n):0}function zl(n,e,t){return(1-t)*n+t*e}function mT(n,e,t,i){return zl(n,e,1-Math.exp(-t*i))}function gT(n,e=1){return e-Math.abs(Ym(n,e*2)-e)}function _T(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function yT(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function xT(n,e){return n+Math.floor(Math.random()*(e-n+1))}function vT(n,e){return n+Math.random()*(e-n)}function bT(n){return n*(.5-Math.random())}function ST(n){n!==void 0&&(Wx=n);let e=Wx+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function MT(n){return n*Bl}function wT(n){return n*Da}function AT(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function TT(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function Jm(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function ET(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),d=r((e-i)/2),h=o((e-i)/2),f=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*d,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*d,a*c);break;case"ZXZ":n.set(l*d,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*f,a*c);break;case"YXY":n.set(l*f,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*f,a*u,a*c);break;default:Ze("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Dd(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function Km(n,e){if(e.constructor===Float32Array)return n;let t=Dd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function Zm(n,e){if(e.constructor===Float32Array)return n;let t=Dd(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var vc={DEG2RAD:Bl,RAD2DEG:Da,generateUUID:io,clamp:pt,euclideanModulo:Ym,mapLinear:fT,inverseLerp:pT,lerp:zl,damp:mT,pingpong:gT,smoothstep:_T,smootherstep:yT,randInt:xT,randFloat:vT,randFloatSpread:bT,seededRandom:ST,degToRad:MT,radToDeg:wT,isPowerOfTwo:AT,ceilPowerOfTwo:TT,floorPowerOfTwo:Jm,setQuaternionFromProperEuler:ET,normalize:Zm,denormalize:Km},je=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=pt(this.x,e.x,t.x),this.y=pt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=pt(this.x,e,t),this.y=pt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(pt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Wi=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],d=i[s+3],h=r[o+0],f=r[o+1],p=r[o+2],v=r[o+3];if(d!==v||l!==h||c!==f||u!==p){let g=l*h+c*f+u*p+d*v;g<0&&(h=-h,f=-f,p=-p,v=-v,g=-g);let _=1-a;if(g<.9995){let b=Math.acos(g),E=Math.sin(b);_=Math.sin(_*b)/E,a=Math.sin(a*b)/E,l=l*_+h*a,c=c*_+f*a,u=u*_+p*a,d=d*_+v*a}else{l=l*_+h*a,c=c*_+f*a,u=u*_+p*a,d=d*_+v*a;let b=1/Math.sqrt(l*l+c*c+u*u+d*d);l*=b,c*=b,u*=b,d*=b}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=d}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],d=r[o],h=r[o+1],f=r[o+2],p=r[o+3];return e[t]=a*p+u*d+l*f-c*h,e[t+1]=l*p+u*h+c*d-a*f,e[t+2]=c*p+u*f+a*h-l*d,e[t+3]=u*p-a*d-l*h-c*f,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),d=a(r/2),h=l(i/2),f=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"YXZ":this._x=h*u*d+c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"ZXY":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d-h*f*p;break;case"ZYX":this._x=h*u*d-c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d+h*f*p;break;case"YZX":this._x=h*u*d+c*f*p,this._y=c*f*d+h*u*p,this._z=c*u*p-h*f*d,this._w=c*u*d-h*f*p;break;case"XZY":this._x=h*u*d-c*f*p,this._y=c*f*d-h*u*p,this._z=c*u*p+h*f*d,this._w=c*u*d+h*f*p;break;default:Ze("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],d=t[10],h=i+a+d;if(h>0){let f=.5/Math.sqrt(h+1);this._w=.25/f,this._x=(u-l)*f,this._y=(r-c)*f,this._z=(o-s)*f}else if(i>a&&i>d){let f=2*Math.sqrt(1+i-a-d);this._w=(u-l)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+c)/f}else if(a>d){let f=2*Math.sqrt(1+a-i-d);this._w=(r-c)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(l+u)/f}else{let f=2*Math.sqrt(1+d-i-a);this._w=(o-s)/f,this._x=(r+c)/f,this._y=(l+u)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(pt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},B=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion($x.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion($x.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),d=2*(r*i-o*t);return this.x=t+l*c+o*d-a*u,this.y=i+l*u+a*c-r*d,this.z=s+l*d+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=pt(this.x,e.x,t.x),this.y=pt(this.y,e.y,t.y),this.z=pt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=pt(this.x,e,t),this.y=pt(this.y,e,t),this.z=pt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return qp.copy(this).projectOnVector(e),this.sub(qp)}reflect(e){return this.sub(qp.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(pt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},qp=new B,$x=new Wi,ct=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],d=i[7],h=i[2],f=i[5],p=i[8],v=s[0],g=s[3],_=s[6],b=s[1],E=s[4],M=s[7],I=s[2],C=s[5],y=s[8];return r[0]=o*v+a*b+l*I,r[3]=o*g+a*E+l*C,r[6]=o*_+a*M+l*y,r[1]=c*v+u*b+d*I,r[4]=c*g+u*E+d*C,r[7]=c*_+u*M+d*y,r[2]=h*v+f*b+p*I,r[5]=h*g+f*E+p*C,r[8]=h*_+f*M+p*y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=u*o-a*c,h=a*l-u*r,f=c*r-o*l,p=t*d+i*h+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let v=1/p;return e[0]=d*v,e[1]=(s*c-u*i)*v,e[2]=(a*i-s*o)*v,e[3]=h*v,e[4]=(u*t-s*l)*v,e[5]=(s*r-a*t)*v,e[6]=f*v,e[7]=(i*l-c*t)*v,e[8]=(o*t-i*r)*v,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return kl("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(Yp.makeScale(e,t)),this}rotate(e){return kl("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(Yp.makeRotation(-e)),this}translate(e,t){return kl("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(Yp.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},Yp=new ct,Xx=new ct().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),qx=new ct().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function CT(){let n={enabled:!0,workingColorSpace:Hl,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Bt&&(s.r=ur(s.r),s.g=ur(s.g),s.b=ur(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Bt&&(s.r=Pa(s.r),s.g=Pa(s.g),s.b=Pa(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===_r?Gl:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Hl]:{primaries:e,whitePoint:i,transfer:Gl,toXYZ:Xx,fromXYZ:qx,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:cn},outputColorSpaceConfig:{drawingBufferColorSpace:cn}},[cn]:{primaries:e,whitePoint:i,transfer:Bt,toXYZ:Xx,fromXYZ:qx,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:cn}}}),n}var wt=CT();function ur(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Pa(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var pa,Sh=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{pa===void 0&&(pa=Wl("canvas")),pa.width=e.width,pa.height=e.height;let s=pa.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=pa}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=Wl("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ur(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(ur(t[i]/255)*255):t[i]=ur(t[i]);return{data:t,width:e.width,height:e.height}}else return Ze("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},RT=0,Na=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:RT++}),this.uuid=io(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(Jp(s[o].image)):r.push(Jp(s[o]))}else r=Jp(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function Jp(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?Sh.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Ze("Texture: Unable to serialize Texture."),{})}var PT=0,Kp=new B,Pi=class n extends vs{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=Us,s=Us,r=bi,o=mr,a=Ji,l=Ii,c=n.DEFAULT_ANISOTROPY,u=_r){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:PT++}),this.uuid=io(),this.name="",this.source=new Na(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new je(0,0),this.repeat=new je(1,1),this.center=new je(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ct,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(Kp).x}get height(){return this.source.getSize(Kp).y}get depth(){return this.source.getSize(Kp).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Ze(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Um)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case xh:e.x=e.x-Math.floor(e.x);break;case Us:e.x=e.x<0?0:1;break;case vh:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case xh:e.y=e.y-Math.floor(e.y);break;case Us:e.y=e.y<0?0:1;break;case vh:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};Pi.DEFAULT_IMAGE=null;Pi.DEFAULT_MAPPING=Um;Pi.DEFAULT_ANISOTROPY=1;var zt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],d=l[8],h=l[1],f=l[5],p=l[9],v=l[2],g=l[6],_=l[10];if(Math.abs(u-h)<.01&&Math.abs(d-v)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(d+v)<.1&&Math.abs(p+g)<.1&&Math.abs(c+f+_-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,M=(f+1)/2,I=(_+1)/2,C=(u+h)/4,y=(d+v)/4,T=(p+g)/4;return E>M&&E>I?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=C/i,r=y/i):M>I?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=C/s,r=T/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=y/r,s=T/r),this.set(i,s,r,t),this}let b=Math.sqrt((g-p)*(g-p)+(d-v)*(d-v)+(h-u)*(h-u));return Math.abs(b)<.001&&(b=1),this.x=(g-p)/b,this.y=(d-v)/b,this.z=(h-u)/b,this.w=Math.acos((c+f+_-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=pt(this.x,e.x,t.x),this.y=pt(this.y,e.y,t.y),this.z=pt(this.z,e.z,t.z),this.w=pt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=pt(this.x,e,t),this.y=pt(this.y,e,t),this.z=pt(this.z,e,t),this.w=pt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(pt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Mh=class extends vs{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:bi,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new zt(0,0,e,t),this.scissorTest=!1,this.viewport=new zt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new Pi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:bi,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Na(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},$i=class extends Mh{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Xl=class extends Pi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Mn,this.minFilter=Mn,this.wrapR=Us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var wh=class extends Pi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=Mn,this.minFilter=Mn,this.wrapR=Us,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var vt=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,g)}set(e,t,i,s,r,o,a,l,c,u,d,h,f,p,v,g){let _=this.elements;return _[0]=e,_[4]=t,_[8]=i,_[12]=s,_[1]=r,_[5]=o,_[9]=a,_[13]=l,_[2]=c,_[6]=u,_[10]=d,_[14]=h,_[3]=f,_[7]=p,_[11]=v,_[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/ma.setFromMatrixColumn(e,0).length(),r=1/ma.setFromMatrixColumn(e,1).length(),o=1/ma.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),d=Math.sin(r);if(e.order==="XYZ"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=l*u,t[4]=-l*d,t[8]=c,t[1]=f+p*c,t[5]=h-v*c,t[9]=-a*l,t[2]=v-h*c,t[6]=p+f*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,f=l*d,p=c*u,v=c*d;t[0]=h+v*a,t[4]=p*a-f,t[8]=o*c,t[1]=o*d,t[5]=o*u,t[9]=-a,t[2]=f*a-p,t[6]=v+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,f=l*d,p=c*u,v=c*d;t[0]=h-v*a,t[4]=-o*d,t[8]=p+f*a,t[1]=f+p*a,t[5]=o*u,t[9]=v-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,f=o*d,p=a*u,v=a*d;t[0]=l*u,t[4]=p*c-f,t[8]=h*c+v,t[1]=l*d,t[5]=v*c+h,t[9]=f*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=v-h*d,t[8]=p*d+f,t[1]=d,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=f*d+p,t[10]=h-v*d}else if(e.order==="XZY"){let h=o*l,f=o*c,p=a*l,v=a*c;t[0]=l*u,t[4]=-d,t[8]=c*u,t[1]=h*d+v,t[5]=o*u,t[9]=f*d-p,t[2]=p*d-f,t[6]=a*u,t[10]=v*d+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(IT,e,LT)}lookAt(e,t,i){let s=this.elements;return Hi.subVectors(e,t),Hi.lengthSq()===0&&(Hi.z=1),Hi.normalize(),zr.crossVectors(i,Hi),zr.lengthSq()===0&&(Math.abs(i.z)===1?Hi.x+=1e-4:Hi.z+=1e-4,Hi.normalize(),zr.crossVectors(i,Hi)),zr.normalize(),ku.crossVectors(Hi,zr),s[0]=zr.x,s[4]=ku.x,s[8]=Hi.x,s[1]=zr.y,s[5]=ku.y,s[9]=Hi.y,s[2]=zr.z,s[6]=ku.z,s[10]=Hi.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],d=i[5],h=i[9],f=i[13],p=i[2],v=i[6],g=i[10],_=i[14],b=i[3],E=i[7],M=i[11],I=i[15],C=s[0],y=s[4],T=s[8],k=s[12],D=s[1],L=s[5],H=s[9],V=s[13],O=s[2],$=s[6],q=s[10],G=s[14],ce=s[3],K=s[7],ee=s[11],Y=s[15];return r[0]=o*C+a*D+l*O+c*ce,r[4]=o*y+a*L+l*$+c*K,r[8]=o*T+a*H+l*q+c*ee,r[12]=o*k+a*V+l*G+c*Y,r[1]=u*C+d*D+h*O+f*ce,r[5]=u*y+d*L+h*$+f*K,r[9]=u*T+d*H+h*q+f*ee,r[13]=u*k+d*V+h*G+f*Y,r[2]=p*C+v*D+g*O+_*ce,r[6]=p*y+v*L+g*$+_*K,r[10]=p*T+v*H+g*q+_*ee,r[14]=p*k+v*V+g*G+_*Y,r[3]=b*C+E*D+M*O+I*ce,r[7]=b*y+E*L+M*$+I*K,r[11]=b*T+E*H+M*q+I*ee,r[15]=b*k+E*V+M*G+I*Y,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],d=e[6],h=e[10],f=e[14],p=e[3],v=e[7],g=e[11],_=e[15],b=l*f-c*h,E=a*f-c*d,M=a*h-l*d,I=o*f-c*u,C=o*h-l*u,y=o*d-a*u;return t*(v*b-g*E+_*M)-i*(p*b-g*I+_*C)+s*(p*E-v*I+_*y)-r*(p*M-v*C+g*y)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],d=e[9],h=e[10],f=e[11],p=e[12],v=e[13],g=e[14],_=e[15],b=t*a-i*o,E=t*l-s*o,M=t*c-r*o,I=i*l-s*a,C=i*c-r*a,y=s*c-r*l,T=u*v-d*p,k=u*g-h*p,D=u*_-f*p,L=d*g-h*v,H=d*_-f*v,V=h*_-f*g,O=b*V-E*H+M*L+I*D-C*k+y*T;if(O===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let $=1/O;return e[0]=(a*V-l*H+c*L)*$,e[1]=(s*H-i*V-r*L)*$,e[2]=(v*y-g*C+_*I)*$,e[3]=(h*C-d*y-f*I)*$,e[4]=(l*D-o*V-c*k)*$,e[5]=(t*V-s*D+r*k)*$,e[6]=(g*M-p*y-_*E)*$,e[7]=(u*y-h*M+f*E)*$,e[8]=(o*H-a*D+c*T)*$,e[9]=(i*D-t*H-r*T)*$,e[10]=(p*C-v*M+_*b)*$,e[11]=(d*M-u*C-f*b)*$,e[12]=(a*k-o*L-l*T)*$,e[13]=(t*L-i*k+s*T)*$,e[14]=(v*E-p*I-g*b)*$,e[15]=(u*I-d*E+h*b)*$,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,d=a+a,h=r*c,f=r*u,p=r*d,v=o*u,g=o*d,_=a*d,b=l*c,E=l*u,M=l*d,I=i.x,C=i.y,y=i.z;return s[0]=(1-(v+_))*I,s[1]=(f+M)*I,s[2]=(p-E)*I,s[3]=0,s[4]=(f-M)*C,s[5]=(1-(h+_))*C,s[6]=(g+b)*C,s[7]=0,s[8]=(p+E)*y,s[9]=(g-b)*y,s[10]=(1-(h+v))*y,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=ma.set(s[0],s[1],s[2]).length(),a=ma.set(s[4],s[5],s[6]).length(),l=ma.set(s[8],s[9],s[10]).length();r<0&&(o=-o),_s.copy(this);let c=1/o,u=1/a,d=1/l;return _s.elements[0]*=c,_s.elements[1]*=c,_s.elements[2]*=c,_s.elements[4]*=u,_s.elements[5]*=u,_s.elements[6]*=u,_s.elements[8]*=d,_s.elements[9]*=d,_s.elements[10]*=d,t.setFromRotationMatrix(_s),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=ns,l=!1){let c=this.elements,u=2*r/(t-e),d=2*r/(i-s),h=(t+e)/(t-e),f=(i+s)/(i-s),p,v;if(l)p=r/(o-r),v=o*r/(o-r);else if(a===ns)p=-(o+r)/(o-r),v=-2*o*r/(o-r);else if(a===Ia)p=-o/(o-r),v=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=d,c[9]=f,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=ns,l=!1){let c=this.elements,u=2/(t-e),d=2/(i-s),h=-(t+e)/(t-e),f=-(i+s)/(i-s),p,v;if(l)p=1/(o-r),v=o/(o-r);else if(a===ns)p=-2/(o-r),v=-(o+r)/(o-r);else if(a===Ia)p=-1/(o-r),v=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=d,c[9]=0,c[13]=f,c[2]=0,c[6]=0,c[10]=p,c[14]=v,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},ma=new B,_s=new vt,IT=new B(0,0,0),LT=new B(1,1,1),zr=new B,ku=new B,Hi=new B,Yx=new vt,Jx=new Wi,dr=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],d=s[2],h=s[6],f=s[10];switch(t){case"XYZ":this._y=Math.asin(pt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-pt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-d,r),this._z=0);break;case"ZXY":this._x=Math.asin(pt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-d,f),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-pt(d,-1,1)),Math.abs(d)<.9999999?(this._x=Math.atan2(h,f),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(pt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-d,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-pt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,f),this._y=0);break;default:Ze("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return Yx.makeRotationFromQuaternion(e),this.setFromRotationMatrix(Yx,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return Jx.setFromEuler(this),this.setFromQuaternion(Jx,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};dr.DEFAULT_ORDER="XYZ";var ql=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},DT=0,Kx=new B,ga=new Wi,rr=new vt,Bu=new B,Il=new B,NT=new B,OT=new Wi,Zx=new B(1,0,0),jx=new B(0,1,0),Qx=new B(0,0,1),ev={type:"added"},UT={type:"removed"},_a={type:"childadded",child:null},Zp={type:"childremoved",child:null},Jn=class n extends vs{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:DT++}),this.uuid=io(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new B,t=new dr,i=new Wi,s=new B(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new vt},normalMatrix:{value:new ct}}),this.matrix=new vt,this.matrixWorld=new vt,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ql,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return ga.setFromAxisAngle(e,t),this.quaternion.multiply(ga),this}rotateOnWorldAxis(e,t){return ga.setFromAxisAngle(e,t),this.quaternion.premultiply(ga),this}rotateX(e){return this.rotateOnAxis(Zx,e)}rotateY(e){return this.rotateOnAxis(jx,e)}rotateZ(e){return this.rotateOnAxis(Qx,e)}translateOnAxis(e,t){return Kx.copy(e).applyQuaternion(this.quaternion),this.position.add(Kx.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(Zx,e)}translateY(e){return this.translateOnAxis(jx,e)}translateZ(e){return this.translateOnAxis(Qx,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(rr.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Bu.copy(e):Bu.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Il.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?rr.lookAt(Il,Bu,this.up):rr.lookAt(Bu,Il,this.up),this.quaternion.setFromRotationMatrix(rr),s&&(rr.extractRotation(s.matrixWorld),ga.setFromRotationMatrix(rr),this.quaternion.premultiply(ga.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(rt("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(ev),_a.child=e,this.dispatchEvent(_a),_a.child=null):rt("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(UT),Zp.child=e,this.dispatchEvent(Zp),Zp.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),rr.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),rr.multiply(e.parent.matrixWorld)),e.applyMatrix4(rr),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(ev),_a.child=e,this.dispatchEvent(_a),_a.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Il,e,NT),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Il,OT,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let d=l[c];r(e.shapes,d)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),d=o(e.shapes),h=o(e.skeletons),f=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),d.length>0&&(i.shapes=d),h.length>0&&(i.skeletons=h),f.length>0&&(i.animations=f),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Jn.DEFAULT_UP=new B(0,1,0);Jn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Jn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var Ln=class extends Jn{constructor(){super(),this.isGroup=!0,this.type="Group"}},FT={type:"move"},Oa=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new Ln,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new Ln,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new B,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new B),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new Ln,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new B,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new B,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let v of e.hand.values()){let g=t.getJointPose(v,i),_=this._getHandJoint(c,v);g!==null&&(_.matrix.fromArray(g.transform.matrix),_.matrix.decompose(_.position,_.quaternion,_.scale),_.matrixWorldNeedsUpdate=!0,_.jointRadius=g.radius),_.visible=g!==null}let u=c.joints["index-finger-tip"],d=c.joints["thumb-tip"],h=u.position.distanceTo(d.position),f=.02,p=.005;c.inputState.pinching&&h>f+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=f-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(FT)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new Ln;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},ob={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},Vr={h:0,s:0,l:0},zu={h:0,s:0,l:0};function jp(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var dt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=cn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,wt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=wt.workingColorSpace){return this.r=e,this.g=t,this.b=i,wt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=wt.workingColorSpace){if(e=Ym(e,1),t=pt(t,0,1),i=pt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=jp(o,r,e+1/3),this.g=jp(o,r,e),this.b=jp(o,r,e-1/3)}return wt.colorSpaceToWorking(this,s),this}setStyle(e,t=cn){function i(r){r!==void 0&&parseFloat(r)<1&&Ze("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Ze("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Ze("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=cn){let i=ob[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Ze("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ur(e.r),this.g=ur(e.g),this.b=ur(e.b),this}copyLinearToSRGB(e){return this.r=Pa(e.r),this.g=Pa(e.g),this.b=Pa(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=cn){return wt.workingToColorSpace(ai.copy(this),e),Math.round(pt(ai.r*255,0,255))*65536+Math.round(pt(ai.g*255,0,255))*256+Math.round(pt(ai.b*255,0,255))}getHexString(e=cn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=wt.workingColorSpace){wt.workingToColorSpace(ai.copy(this),t);let i=ai.r,s=ai.g,r=ai.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let d=o-a;switch(c=u<=.5?d/(o+a):d/(2-o-a),o){case i:l=(s-r)/d+(s<r?6:0);break;case s:l=(r-i)/d+2;break;case r:l=(i-s)/d+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=wt.workingColorSpace){return wt.workingToColorSpace(ai.copy(this),t),e.r=ai.r,e.g=ai.g,e.b=ai.b,e}getStyle(e=cn){wt.workingToColorSpace(ai.copy(this),e);let t=ai.r,i=ai.g,s=ai.b;return e!==cn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(Vr),this.setHSL(Vr.h+e,Vr.s+t,Vr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(Vr),e.getHSL(zu);let i=zl(Vr.h,zu.h,t),s=zl(Vr.s,zu.s,t),r=zl(Vr.l,zu.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},ai=new dt;dt.NAMES=ob;var Yl=class extends Jn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new dr,this.environmentIntensity=1,this.environmentRotation=new dr,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},ys=new B,or=new B,Qp=new B,ar=new B,ya=new B,xa=new B,tv=new B,em=new B,tm=new B,nm=new B,im=new zt,sm=new zt,rm=new zt,$r=class n{constructor(e=new B,t=new B,i=new B){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),ys.subVectors(e,t),s.cross(ys);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){ys.subVectors(s,t),or.subVectors(i,t),Qp.subVectors(e,t);let o=ys.dot(ys),a=ys.dot(or),l=ys.dot(Qp),c=or.dot(or),u=or.dot(Qp),d=o*c-a*a;if(d===0)return r.set(0,0,0),null;let h=1/d,f=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-f-p,p,f)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,ar)===null?!1:ar.x>=0&&ar.y>=0&&ar.x+ar.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,ar)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,ar.x),l.addScaledVector(o,ar.y),l.addScaledVector(a,ar.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return im.setScalar(0),sm.setScalar(0),rm.setScalar(0),im.fromBufferAttribute(e,t),sm.fromBufferAttribute(e,i),rm.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(im,r.x),o.addScaledVector(sm,r.y),o.addScaledVector(rm,r.z),o}static isFrontFacing(e,t,i,s){return ys.subVectors(i,t),or.subVectors(e,t),ys.cross(or).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return ys.subVectors(this.c,this.b),or.subVectors(this.a,this.b),ys.cross(or).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;ya.subVectors(s,i),xa.subVectors(r,i),em.subVectors(e,i);let l=ya.dot(em),c=xa.dot(em);if(l<=0&&c<=0)return t.copy(i);tm.subVectors(e,s);let u=ya.dot(tm),d=xa.dot(tm);if(u>=0&&d<=u)return t.copy(s);let h=l*d-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(ya,o);nm.subVectors(e,r);let f=ya.dot(nm),p=xa.dot(nm);if(p>=0&&f<=p)return t.copy(r);let v=f*c-l*p;if(v<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(xa,a);let g=u*p-f*d;if(g<=0&&d-u>=0&&f-p>=0)return tv.subVectors(r,s),a=(d-u)/(d-u+(f-p)),t.copy(s).addScaledVector(tv,a);let _=1/(g+v+h);return o=v*_,a=h*_,t.copy(i).addScaledVector(ya,o).addScaledVector(xa,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Qn=class{constructor(e=new B(1/0,1/0,1/0),t=new B(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(xs.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(xs.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=xs.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,xs):xs.fromBufferAttribute(r,o),xs.applyMatrix4(e.matrixWorld),this.expandByPoint(xs);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Vu.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Vu.copy(i.boundingBox)),Vu.applyMatrix4(e.matrixWorld),this.union(Vu)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,xs),xs.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Ll),Hu.subVectors(this.max,Ll),va.subVectors(e.a,Ll),ba.subVectors(e.b,Ll),Sa.subVectors(e.c,Ll),Hr.subVectors(ba,va),Gr.subVectors(Sa,ba),wo.subVectors(va,Sa);let t=[0,-Hr.z,Hr.y,0,-Gr.z,Gr.y,0,-wo.z,wo.y,Hr.z,0,-Hr.x,Gr.z,0,-Gr.x,wo.z,0,-wo.x,-Hr.y,Hr.x,0,-Gr.y,Gr.x,0,-wo.y,wo.x,0];return!om(t,va,ba,Sa,Hu)||(t=[1,0,0,0,1,0,0,0,1],!om(t,va,ba,Sa,Hu))?!1:(Gu.crossVectors(Hr,Gr),t=[Gu.x,Gu.y,Gu.z],om(t,va,ba,Sa,Hu))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,xs).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(xs).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(lr[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),lr[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),lr[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),lr[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),lr[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),lr[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),lr[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),lr[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(lr),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},lr=[new B,new B,new B,new B,new B,new B,new B,new B],xs=new B,Vu=new Qn,va=new B,ba=new B,Sa=new B,Hr=new B,Gr=new B,wo=new B,Ll=new B,Hu=new B,Gu=new B,Ao=new B;function om(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Ao.fromArray(n,r);let a=s.x*Math.abs(Ao.x)+s.y*Math.abs(Ao.y)+s.z*Math.abs(Ao.z),l=e.dot(Ao),c=t.dot(Ao),u=i.dot(Ao);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var In=new B,Wu=new je,kT=0,Jt=class extends vs{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:kT++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=Xm,this.updateRanges=[],this.gpuType=ss,this.version=0,this._normalizationScale=e!==void 0?Dd(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Wu.fromBufferAttribute(this,t),Wu.applyMatrix3(e),this.setXY(t,Wu.x,Wu.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyMatrix3(e),this.setXYZ(t,In.x,In.y,In.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyMatrix4(e),this.setXYZ(t,In.x,In.y,In.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.applyNormalMatrix(e),this.setXYZ(t,In.x,In.y,In.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)In.fromBufferAttribute(this,t),In.transformDirection(e),this.setXYZ(t,In.x,In.y,In.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Km(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Zm(e,this.array)}};var Jl=class extends Jt{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var Kl=class extends Jt{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var Yn=class extends Jt{constructor(e,t,i){super(new Float32Array(e),t,i)}},BT=new Qn,Dl=new B,am=new B,Bn=class{constructor(e=new B,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):BT.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Dl.subVectors(e,this.center);let t=Dl.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Dl,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(am.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Dl.copy(e.center).add(am)),this.expandByPoint(Dl.copy(e.center).sub(am))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},zT=0,ts=new vt,lm=new Jn,Ma=new B,Gi=new Qn,Nl=new Qn,qn=new B,Qt=class n extends vs{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:zT++}),this.uuid=io(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(hT(e)?Kl:Jl)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ct().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return ts.makeRotationFromQuaternion(e),this.applyMatrix4(ts),this}rotateX(e){return ts.makeRotationX(e),this.applyMatrix4(ts),this}rotateY(e){return ts.makeRotationY(e),this.applyMatrix4(ts),this}rotateZ(e){return ts.makeRotationZ(e),this.applyMatrix4(ts),this}translate(e,t,i){return ts.makeTranslation(e,t,i),this.applyMatrix4(ts),this}scale(e,t,i){return ts.makeScale(e,t,i),this.applyMatrix4(ts),this}lookAt(e){return lm.lookAt(e),lm.updateMatrix(),this.applyMatrix4(lm.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ma).negate(),this.translate(Ma.x,Ma.y,Ma.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new Yn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Ze("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new B(-1/0,-1/0,-1/0),new B(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Gi.setFromBufferAttribute(r),this.morphTargetsRelative?(qn.addVectors(this.boundingBox.min,Gi.min),this.boundingBox.expandByPoint(qn),qn.addVectors(this.boundingBox.max,Gi.max),this.boundingBox.expandByPoint(qn)):(this.boundingBox.expandByPoint(Gi.min),this.boundingBox.expandByPoint(Gi.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&rt('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){rt("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new B,1/0);return}if(e){let i=this.boundingSphere.center;if(Gi.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Nl.setFromBufferAttribute(a),this.morphTargetsRelative?(qn.addVectors(Gi.min,Nl.min),Gi.expandByPoint(qn),qn.addVectors(Gi.max,Nl.max),Gi.expandByPoint(qn)):(Gi.expandByPoint(Nl.min),Gi.expandByPoint(Nl.max))}Gi.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)qn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(qn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)qn.fromBufferAttribute(a,c),l&&(Ma.fromBufferAttribute(e,c),qn.add(Ma)),s=Math.max(s,i.distanceToSquared(qn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&rt('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){rt("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new Jt(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new B,l[k]=new B;let u=new B,d=new B,h=new B,f=new je,p=new je,v=new je,g=new B,_=new B;function b(k,D,L){c[k]=c[D]=c[L]=1,u.fromBufferAttribute(i,k),d.fromBufferAttribute(i,D),h.fromBufferAttribute(i,L),f.fromBufferAttribute(r,k),p.fromBufferAttribute(r,D),v.fromBufferAttribute(r,L),d.sub(u),h.sub(u),p.sub(f),v.sub(f);let H=1/(p.x*v.y-v.x*p.y);isFinite(H)&&(g.copy(d).multiplyScalar(v.y).addScaledVector(h,-p.y).multiplyScalar(H),_.copy(h).multiplyScalar(p.x).addScaledVector(d,-v.x).multiplyScalar(H),a[k].add(g),a[D].add(g),a[L].add(g),l[k].add(_),l[D].add(_),l[L].add(_))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let k=0,D=E.length;k<D;++k){let L=E[k],H=L.start,V=L.count;for(let O=H,$=H+V;O<$;O+=3)b(e.getX(O+0),e.getX(O+1),e.getX(O+2))}let M=new B,I=new B,C=new B,y=new B;function T(k){C.fromBufferAttribute(s,k),y.copy(C);let D=a[k];M.copy(D),M.sub(C.multiplyScalar(C.dot(D))).normalize(),I.crossVectors(y,D);let H=I.dot(l[k])<0?-1:1;o.setXYZW(k,M.x,M.y,M.z,H)}for(let k=0,D=i.count;k<D;++k)c[k]&&T(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new Jt(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,f=i.count;h<f;h++)i.setXYZ(h,0,0,0);let s=new B,r=new B,o=new B,a=new B,l=new B,c=new B,u=new B,d=new B;if(e)for(let h=0,f=e.count;h<f;h+=3){let p=e.getX(h+0),v=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,v),o.fromBufferAttribute(t,g),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,v),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(v,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,f=t.count;h<f;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),d.subVectors(s,r),u.cross(d),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)qn.fromBufferAttribute(e,t),qn.normalize(),e.setXYZ(t,qn.x,qn.y,qn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,d=a.normalized,h=new c.constructor(l.length*u),f=0,p=0;for(let v=0,g=l.length;v<g;v++){a.isInterleavedBufferAttribute?f=l[v]*a.data.stride+a.offset:f=l[v]*u;for(let _=0;_<u;_++)h[p++]=c[f++]}return new Jt(h,u,d)}if(this.index===null)return Ze("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,d=c.length;u<d;u++){let h=c[u],f=e(h,i);l.push(f)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let d=0,h=c.length;d<h;d++){let f=c[d];u.push(f.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],d=r[c];for(let h=0,f=d.length;h<f;h++)u.push(d[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let d=o[c];this.addGroup(d.start,d.count,d.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ah=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=Xm,this.updateRanges=[],this.version=0,this.uuid=io()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=nv(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=nv(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function nv(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=io()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var yi=new B,bs=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?Dd(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)yi.fromBufferAttribute(this,t),yi.applyMatrix4(e),this.setXYZ(t,yi.x,yi.y,yi.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)yi.fromBufferAttribute(this,t),yi.applyNormalMatrix(e),this.setXYZ(t,yi.x,yi.y,yi.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)yi.fromBufferAttribute(this,t),yi.transformDirection(e),this.setXYZ(t,yi.x,yi.y,yi.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){$l("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new Jt(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){$l("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):Km(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):Zm(e,this.data.array)}},cm=new B,VT=new B,HT=new ct,xi=class{constructor(e=new B(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=cm.subVectors(i,t).cross(VT.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(cm),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||HT.getNormalMatrix(e),s=this.coplanarPoint(cm).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},GT=0,ks=class extends vs{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:GT++}),this.uuid=io(),this.name="",this.type="Material",this.blending=Ha,this.side=to,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Em,this.blendDst=Cm,this.blendEquation=Po,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new dt(0,0,0),this.blendAlpha=0,this.depthFunc=Fs,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=Kv,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=hh,this.stencilZFail=hh,this.stencilZPass=hh,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Ze(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Ze(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new dt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new xi().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new je().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new je().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var cr=new B,um=new B,$u=new B,Xu=new B,Xr=class{constructor(e=new B,t=new B(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,cr)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=cr.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(cr.copy(this.origin).addScaledVector(this.direction,t),cr.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){um.copy(e).add(t).multiplyScalar(.5),$u.copy(t).sub(e).normalize(),Xu.copy(this.origin).sub(um);let r=e.distanceTo(t)*.5,o=-this.direction.dot($u),a=Xu.dot(this.direction),l=-Xu.dot($u),c=Xu.lengthSq(),u=Math.abs(1-o*o),d,h,f,p;if(u>0)if(d=o*l-a,h=o*a-l,p=r*u,d>=0)if(h>=-p)if(h<=p){let v=1/u;d*=v,h*=v,f=d*(d+o*h+2*a)+h*(o*d+h+2*l)+c}else h=r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h=-r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;else h<=-p?(d=Math.max(0,-(-o*r+a)),h=d>0?-r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c):h<=p?(d=0,h=Math.min(Math.max(-r,-l),r),f=h*(h+2*l)+c):(d=Math.max(0,-(o*r+a)),h=d>0?r:Math.min(Math.max(-r,-l),r),f=-d*d+h*(h+2*l)+c);else h=o>0?-r:r,d=Math.max(0,-(o*h+a)),f=-d*d+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,d),s&&s.copy(um).addScaledVector($u,h),f}intersectSphere(e,t){if(e.radius<0)return null;cr.subVectors(e.center,this.origin);let i=cr.dot(this.direction),s=cr.dot(cr)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,d=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),d>=0?(a=(e.min.z-h.z)*d,l=(e.max.z-h.z)*d):(a=(e.max.z-h.z)*d,l=(e.min.z-h.z)*d),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,cr)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,d=e.x-o.x,h=e.y-o.y,f=e.z-o.z,p=t.x-o.x,v=t.y-o.y,g=t.z-o.z,_=i.x-o.x,b=i.y-o.y,E=i.z-o.z,M=Math.abs(l),I=Math.abs(c),C=Math.abs(u),y,T,k,D,L,H,V,O,$,q,G,ce;if(M>=I&&M>=C?(k=l,H=d,$=p,ce=_,l>=0?(y=c,T=u,D=h,L=f,V=v,O=g,q=b,G=E):(y=u,T=c,D=f,L=h,V=g,O=v,q=E,G=b)):I>=C?(k=c,H=h,$=v,ce=b,c>=0?(y=u,T=l,D=f,L=d,V=g,O=p,q=E,G=_):(y=l,T=u,D=d,L=f,V=p,O=g,q=_,G=E)):(k=u,H=f,$=g,ce=E,u>=0?(y=l,T=c,D=d,L=h,V=p,O=v,q=_,G=b):(y=c,T=l,D=h,L=d,V=v,O=p,q=b,G=_)),k===0)return null;let K=y/k,ee=T/k,Y=1/k,oe=D-K*H,ue=L-ee*H,te=V-K*$,_e=O-ee*$,me=q-K*ce,Ae=G-ee*ce,be=me*_e-Ae*te,qe=oe*Ae-ue*me,tt=te*ue-_e*oe;if(s){if(be<0||qe<0||tt<0)return null}else if((be<0||qe<0||tt<0)&&(be>0||qe>0||tt>0))return null;let Be=be+qe+tt;if(Be===0)return null;let ot=Y*(be*H+qe*$+tt*ce);return(Be>0?ot<0:ot>0)?null:this.at(ot/Be,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Ua=class extends ks{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new dt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new dr,this.combine=$h,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},iv=new vt,To=new Xr,qu=new Bn,sv=new B,Yu=new B,Ju=new B,Ku=new B,hm=new B,Zu=new B,rv=new B,ju=new B,Dn=class extends Jn{constructor(e=new Qt,t=new Ua){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Zu.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],d=r[l];u!==0&&(hm.fromBufferAttribute(d,e),o?Zu.addScaledVector(hm,u):Zu.addScaledVector(hm.sub(t),u))}t.add(Zu)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),qu.copy(i.boundingSphere),qu.applyMatrix4(r),To.copy(e.ray).recast(e.near),!(qu.containsPoint(To.origin)===!1&&(To.intersectSphere(qu,sv)===null||To.origin.distanceToSquared(sv)>(e.far-e.near)**2))&&(iv.copy(r).invert(),To.copy(e.ray).applyMatrix4(iv),!(i.boundingBox!==null&&To.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,To)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,d=r.attributes.normal,h=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],_=o[g.materialIndex],b=Math.max(g.start,f.start),E=Math.min(a.count,Math.min(g.start+g.count,f.start+f.count));for(let M=b,I=E;M<I;M+=3){let C=a.getX(M),y=a.getX(M+1),T=a.getX(M+2);s=Qu(this,_,e,i,c,u,d,C,y,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(a.count,f.start+f.count);for(let g=p,_=v;g<_;g+=3){let b=a.getX(g),E=a.getX(g+1),M=a.getX(g+2);s=Qu(this,o,e,i,c,u,d,b,E,M),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,v=h.length;p<v;p++){let g=h[p],_=o[g.materialIndex],b=Math.max(g.start,f.start),E=Math.min(l.count,Math.min(g.start+g.count,f.start+f.count));for(let M=b,I=E;M<I;M+=3){let C=M,y=M+1,T=M+2;s=Qu(this,_,e,i,c,u,d,C,y,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,f.start),v=Math.min(l.count,f.start+f.count);for(let g=p,_=v;g<_;g+=3){let b=g,E=g+1,M=g+2;s=Qu(this,o,e,i,c,u,d,b,E,M),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function WT(n,e,t,i,s,r,o,a){let l;if(e.side===Si?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===to,a),l===null)return null;ju.copy(a),ju.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(ju);return c<t.near||c>t.far?null:{distance:c,point:ju.clone(),object:n}}function Qu(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Yu),n.getVertexPosition(l,Ju),n.getVertexPosition(c,Ku);let u=WT(n,e,t,i,Yu,Ju,Ku,rv);if(u){let d=new B;$r.getBarycoord(rv,Yu,Ju,Ku,d),s&&(u.uv=$r.getInterpolatedAttribute(s,a,l,c,d,new je)),r&&(u.uv1=$r.getInterpolatedAttribute(r,a,l,c,d,new je)),o&&(u.normal=$r.getInterpolatedAttribute(o,a,l,c,d,new B),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new B,materialIndex:0};$r.getNormal(Yu,Ju,Ku,h.normal),u.face=h,u.barycoord=d}return u}var Co=class extends Pi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=Mn,u=Mn,d,h){super(null,o,a,l,c,u,s,r,d,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Zl=class extends Jt{constructor(e,t,i,s=1){super(e,t,i),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}toJSON(){let e=super.toJSON();return e.meshPerAttribute=this.meshPerAttribute,e.isInstancedBufferAttribute=!0,e}},wa=new vt,ov=new vt,eh=[],av=new Qn,$T=new vt,Ol=new Dn,Ul=new Bn,Fa=class extends Dn{constructor(e,t,i){super(e,t),this.isInstancedMesh=!0,this.instanceMatrix=new Zl(new Float32Array(i*16),16),this.instanceColor=null,this.morphTexture=null,this.count=i,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<i;s++)this.setMatrixAt(s,$T)}computeBoundingBox(){let e=this.geometry,t=this.count;this.boundingBox===null&&(this.boundingBox=new Qn),e.boundingBox===null&&e.computeBoundingBox(),this.boundingBox.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,wa),av.copy(e.boundingBox).applyMatrix4(wa),this.boundingBox.union(av)}computeBoundingSphere(){let e=this.geometry,t=this.count;this.boundingSphere===null&&(this.boundingSphere=new Bn),e.boundingSphere===null&&e.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let i=0;i<t;i++)this.getMatrixAt(i,wa),Ul.copy(e.boundingSphere).applyMatrix4(wa),this.boundingSphere.union(Ul)}copy(e,t){return super.copy(e,t),this.instanceMatrix.copy(e.instanceMatrix),this.morphTexture=e.morphTexture!==null?e.morphTexture.clone():null,this.instanceColor=e.instanceColor!==null?e.instanceColor.clone():null,this.count=e.count,this.boundingBox=e.boundingBox!==null?e.boundingBox.clone():null,this.boundingSphere=e.boundingSphere!==null?e.boundingSphere.clone():null,this}getColorAt(e,t){return this.instanceColor===null?t.setRGB(1,1,1):t.fromArray(this.instanceColor.array,e*3)}getMatrixAt(e,t){return t.fromArray(this.instanceMatrix.array,e*16)}getMorphAt(e,t){let i=t.morphTargetInfluences,s=this.morphTexture.source.data.data,r=i.length+1,o=e*r+1;for(let a=0;a<i.length;a++)i[a]=s[o+a]}raycast(e,t){let i=this.matrixWorld,s=this.count;if(Ol.geometry=this.geometry,Ol.material=this.material,Ol.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Ul.copy(this.boundingSphere),Ul.applyMatrix4(i),e.ray.intersectsSphere(Ul)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,wa),ov.multiplyMatrices(i,wa),Ol.matrixWorld=ov,Ol.raycast(e,eh);for(let o=0,a=eh.length;o<a;o++){let l=eh[o];l.instanceId=r,l.object=this,t.push(l)}eh.length=0}}setColorAt(e,t){return this.instanceColor===null&&(this.instanceColor=new Zl(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),t.toArray(this.instanceColor.array,e*3),this}setMatrixAt(e,t){return t.toArray(this.instanceMatrix.array,e*16),this}setMorphAt(e,t){let i=t.morphTargetInfluences,s=i.length+1;this.morphTexture===null&&(this.morphTexture=new Co(new Float32Array(s*this.count),s,this.count,jh,ss));let r=this.morphTexture.source.data.data,o=0;for(let c=0;c<i.length;c++)o+=i[c];let a=this.geometry.morphTargetsRelative?1:1-o,l=s*e;return r[l]=a,r.set(i,l+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Eo=new Bn,XT=new je(.5,.5),th=new B,qr=class{constructor(e=new xi,t=new xi,i=new xi,s=new xi,r=new xi,o=new xi){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=ns,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],d=r[5],h=r[6],f=r[7],p=r[8],v=r[9],g=r[10],_=r[11],b=r[12],E=r[13],M=r[14],I=r[15];if(s[0].setComponents(c-o,f-u,_-p,I-b).normalize(),s[1].setComponents(c+o,f+u,_+p,I+b).normalize(),s[2].setComponents(c+a,f+d,_+v,I+E).normalize(),s[3].setComponents(c-a,f-d,_-v,I-E).normalize(),i)s[4].setComponents(l,h,g,M).normalize(),s[5].setComponents(c-l,f-h,_-g,I-M).normalize();else if(s[4].setComponents(c-l,f-h,_-g,I-M).normalize(),t===ns)s[5].setComponents(c+l,f+h,_+g,I+M).normalize();else if(t===Ia)s[5].setComponents(l,h,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Eo.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Eo.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Eo)}intersectsSprite(e){Eo.center.set(0,0,0);let t=XT.distanceTo(e.center);return Eo.radius=.7071067811865476+t,Eo.applyMatrix4(e.matrixWorld),this.intersectsSphere(Eo)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(th.x=s.normal.x>0?e.max.x:e.min.x,th.y=s.normal.y>0?e.max.y:e.min.y,th.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(th)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},lv=new vt,Th=class n{constructor(){this.coordinateSystem=ns,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];lv.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new qr),i[s].setFromProjectionMatrix(lv,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new qr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var Xi=class extends ks{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new dt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},Eh=new B,Ch=new B,cv=new vt,Fl=new Xr,nh=new Bn,dm=new B,uv=new B,Rh=class extends Jn{constructor(e=new Qt,t=new Xi){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)Eh.fromBufferAttribute(t,s-1),Ch.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=Eh.distanceTo(Ch);e.setAttribute("lineDistance",new Yn(i,1))}else Ze("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),nh.copy(i.boundingSphere),nh.applyMatrix4(s),nh.radius+=r,e.ray.intersectsSphere(nh)===!1)return;cv.copy(s).invert(),Fl.copy(e.ray).applyMatrix4(cv);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let f=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let _=u.getX(v),b=u.getX(v+1),E=ih(this,e,Fl,l,_,b,v);E&&t.push(E)}if(this.isLineLoop){let v=u.getX(p-1),g=u.getX(f),_=ih(this,e,Fl,l,v,g,p-1);_&&t.push(_)}}else{let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let v=f,g=p-1;v<g;v+=c){let _=ih(this,e,Fl,l,v,v+1,v);_&&t.push(_)}if(this.isLineLoop){let v=ih(this,e,Fl,l,p-1,f,p-1);v&&t.push(v)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function ih(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(Eh.fromBufferAttribute(a,s),Ch.fromBufferAttribute(a,r),t.distanceSqToSegment(Eh,Ch,dm,uv)>i)return;dm.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(dm);if(!(c<e.near||c>e.far))return{distance:c,point:uv.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var hv=new B,dv=new B,qi=class extends Rh{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)hv.fromBufferAttribute(t,s),dv.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+hv.distanceTo(dv);e.setAttribute("lineDistance",new Yn(i,1))}else Ze("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Bs=class extends ks{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new dt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},fv=new vt,xm=new Xr,sh=new Bn,rh=new B,fr=class extends Jn{constructor(e=new Qt,t=new Bs){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),sh.copy(i.boundingSphere),sh.applyMatrix4(s),sh.radius+=r,e.ray.intersectsSphere(sh)===!1)return;fv.copy(s).invert(),xm.copy(e.ray).applyMatrix4(fv);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,d=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),f=Math.min(c.count,o.start+o.count);for(let p=h,v=f;p<v;p++){let g=c.getX(p);rh.fromBufferAttribute(d,g),pv(rh,g,l,s,e,t,this)}}else{let h=Math.max(0,o.start),f=Math.min(d.count,o.start+o.count);for(let p=h,v=f;p<v;p++)rh.fromBufferAttribute(d,p),pv(rh,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function pv(n,e,t,i,s,r,o){let a=xm.distanceSqToPoint(n);if(a<t){let l=new B;xm.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var jl=class extends Pi{constructor(e=[],t=Io,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var pr=class extends Pi{constructor(e,t,i=Ss,s,r,o,a=Mn,l=Mn,c,u=hr,d=1){if(u!==hr&&u!==gr)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:d};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Na(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},Ql=class extends pr{constructor(e,t=Ss,i=Io,s,r,o=Mn,a=Mn,l,c=hr){let u={width:e,height:e,depth:1},d=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=d,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},ec=class extends Pi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},ka=class n extends Qt{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],d=[],h=0,f=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new Yn(c,3)),this.setAttribute("normal",new Yn(u,3)),this.setAttribute("uv",new Yn(d,2));function p(v,g,_,b,E,M,I,C,y,T,k){let D=M/y,L=I/T,H=M/2,V=I/2,O=C/2,$=y+1,q=T+1,G=0,ce=0,K=new B;for(let ee=0;ee<q;ee++){let Y=ee*L-V;for(let oe=0;oe<$;oe++){let ue=oe*D-H;K[v]=ue*b,K[g]=Y*E,K[_]=O,c.push(K.x,K.y,K.z),K[v]=0,K[g]=0,K[_]=C>0?1:-1,u.push(K.x,K.y,K.z),d.push(oe/y),d.push(1-ee/T),G+=1}}for(let ee=0;ee<T;ee++)for(let Y=0;Y<y;Y++){let oe=h+Y+$*ee,ue=h+Y+$*(ee+1),te=h+(Y+1)+$*(ee+1),_e=h+(Y+1)+$*ee;l.push(oe,ue,_e),l.push(ue,te,_e),ce+=6}a.addGroup(f,ce,k),f+=ce,h+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var tc=class n extends Qt{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,d=e/a,h=t/l,f=[],p=[],v=[],g=[];for(let _=0;_<u;_++){let b=_*h-o;for(let E=0;E<c;E++){let M=E*d-r;p.push(M,-b,0),v.push(0,0,1),g.push(E/a),g.push(1-_/l)}}for(let _=0;_<l;_++)for(let b=0;b<a;b++){let E=b+c*_,M=b+c*(_+1),I=b+1+c*(_+1),C=b+1+c*_;f.push(E,M,C),f.push(M,I,C)}this.setIndex(f),this.setAttribute("position",new Yn(p,3)),this.setAttribute("normal",new Yn(v,3)),this.setAttribute("uv",new Yn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var nc=class extends Qt{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new B,r=new B;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let d=l[c],h=d.start,f=d.count;for(let p=h,v=h+f;p<v;p+=3)for(let g=0;g<3;g++){let _=a.getX(p+g),b=a.getX(p+(g+1)%3);s.fromBufferAttribute(o,_),r.fromBufferAttribute(o,b),mv(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,d=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,d),mv(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new Yn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function mv(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function Do(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(gv(s))s.isRenderTargetTexture?(Ze("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(gv(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function li(n){let e={};for(let t=0;t<n.length;t++){let i=Do(n[t]);for(let s in i)e[s]=i[s]}return e}function gv(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function qT(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function jm(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:wt.workingColorSpace}var bc={clone:Do,merge:li},YT=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,JT=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,is=class extends ks{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=YT,this.fragmentShader=JT,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Do(e.uniforms),this.uniformsGroups=qT(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new dt().setHex(s.value);break;case"v2":this.uniforms[i].value=new je().fromArray(s.value);break;case"v3":this.uniforms[i].value=new B().fromArray(s.value);break;case"v4":this.uniforms[i].value=new zt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ct().fromArray(s.value);break;case"m4":this.uniforms[i].value=new vt().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},Ph=class extends is{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Yr=class extends ks{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new dt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new dt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ld,this.normalScale=new je(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new dr,this.combine=$h,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Ih=class extends ks{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Yv,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Lh=class extends ks{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Aa(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function oh(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var Jr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Dh=class extends Jr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:gm,endingEnd:gm}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case _m:r=e,a=2*t-i;break;case ym:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case _m:o=e,l=2*i-t;break;case ym:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,d=this._offsetNext,h=this._weightPrev,f=this._weightNext,p=(i-t)/(s-t),v=p*p,g=v*p,_=-h*g+2*h*v-h*p,b=(1+h)*g+(-1.5-2*h)*v+(-.5+h)*p+1,E=(-1-f)*g+(1.5+f)*v+.5*p,M=f*g-f*v;for(let I=0;I!==a;++I)r[I]=_*o[u+I]+b*o[c+I]+E*o[l+I]+M*o[d+I];return r}},Nh=class extends Jr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),d=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*d+o[l+h]*u;return r}},Oh=class extends Jr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Uh=class extends Jr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,d=this.outTangents;if(!u||!d){let p=(i-t)/(s-t),v=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*v+o[l+g]*p;return r}let h=a*2,f=e-1;for(let p=0;p!==a;++p){let v=o[c+p],g=o[l+p],_=f*h+p*2,b=d[_],E=d[_+1],M=e*h+p*2,I=u[M],C=u[M+1],y=ZT(i,t,b,I,s);r[p]=ab(y,v,E,C,g)}return r}};function ab(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function KT(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function ZT(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=ab(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=KT(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Yi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Aa(t,this.TimeBufferType),this.values=Aa(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Aa(e.times,Array),values:Aa(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),oh(e.settings)&&(i.settings={inTangents:Aa(e.settings.inTangents,Array),outTangents:Aa(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Oh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Nh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Dh(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Uh(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Vl:t=this.InterpolantFactoryMethodDiscrete;break;case bh:t=this.InterpolantFactoryMethodLinear;break;case uh:t=this.InterpolantFactoryMethodSmooth;break;case mm:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Ze("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Vl;case this.InterpolantFactoryMethodLinear:return bh;case this.InterpolantFactoryMethodSmooth:return uh;case this.InterpolantFactoryMethodBezier:return mm}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;oh(this.settings)&&(_v(this.settings.inTangents,e),_v(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;oh(this.settings)&&(yv(this.settings.inTangents,e),yv(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(rt("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(rt("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){rt("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){rt("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&dT(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){rt("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===uh,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let d=a*i,h=d-i,f=d+i;for(let p=0;p!==i;++p){let v=t[d+p];if(v!==t[h+p]||v!==t[f+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let d=a*i,h=o*i;for(let f=0;f!==i;++f)t[h+f]=t[d+f]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,oh(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function _v(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function yv(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Yi.prototype.ValueTypeName="";Yi.prototype.TimeBufferType=Float32Array;Yi.prototype.ValueBufferType=Float32Array;Yi.prototype.DefaultInterpolation=bh;var Kr=class extends Yi{constructor(e,t,i){super(e,t,i)}};Kr.prototype.ValueTypeName="bool";Kr.prototype.ValueBufferType=Array;Kr.prototype.DefaultInterpolation=Vl;Kr.prototype.InterpolantFactoryMethodLinear=void 0;Kr.prototype.InterpolantFactoryMethodSmooth=void 0;var Fh=class extends Yi{constructor(e,t,i,s){super(e,t,i,s)}};Fh.prototype.ValueTypeName="color";var kh=class extends Yi{constructor(e,t,i,s){super(e,t,i,s)}};kh.prototype.ValueTypeName="number";var Bh=class extends Jr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Wi.slerpFlat(r,0,o,c-a,o,c,l);return r}},ic=class extends Yi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Bh(this.times,this.values,this.getValueSize(),e)}};ic.prototype.ValueTypeName="quaternion";ic.prototype.InterpolantFactoryMethodSmooth=void 0;var Zr=class extends Yi{constructor(e,t,i){super(e,t,i)}};Zr.prototype.ValueTypeName="string";Zr.prototype.ValueBufferType=Array;Zr.prototype.DefaultInterpolation=Vl;Zr.prototype.InterpolantFactoryMethodLinear=void 0;Zr.prototype.InterpolantFactoryMethodSmooth=void 0;var zh=class extends Yi{constructor(e,t,i,s){super(e,t,i,s)}};zh.prototype.ValueTypeName="vector";var Vh=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,d){return c.push(u,d),this},this.removeHandler=function(u){let d=c.indexOf(u);return d!==-1&&c.splice(d,2),this},this.getHandler=function(u){for(let d=0,h=c.length;d<h;d+=2){let f=c[d],p=c[d+1];if(f.global&&(f.lastIndex=0),f.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},lb=new Vh,Hh=class{constructor(e){this.manager=e!==void 0?e:lb,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Hh.DEFAULT_MATERIAL_NAME="__DEFAULT";var sc=class extends Jn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new dt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},rc=class extends sc{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Jn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new dt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},fm=new vt,xv=new B,vv=new B,Gh=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new je(512,512),this.mapType=Ii,this.map=null,this.mapPass=null,this.matrix=new vt,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new qr,this._frameExtents=new je(1,1),this._viewportCount=1,this._viewports=[new zt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;xv.setFromMatrixPosition(e.matrixWorld),t.position.copy(xv),vv.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(vv),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){fm.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(fm,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Ia||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(fm)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},ah=new B,lh=new Wi,Os=new B,oc=class extends Jn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new vt,this.projectionMatrix=new vt,this.projectionMatrixInverse=new vt,this.coordinateSystem=ns,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(ah,lh,Os),Os.x===1&&Os.y===1&&Os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ah,lh,Os.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(ah,lh,Os),Os.x===1&&Os.y===1&&Os.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(ah,lh,Os.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Wr=new B,bv=new je,Sv=new je,vi=class extends oc{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Da*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Bl*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Da*2*Math.atan(Math.tan(Bl*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){Wr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(Wr.x,Wr.y).multiplyScalar(-e/Wr.z),Wr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(Wr.x,Wr.y).multiplyScalar(-e/Wr.z)}getViewSize(e,t){return this.getViewBounds(e,bv,Sv),t.subVectors(Sv,bv)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Bl*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ac=class extends oc{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},vm=class extends Gh{constructor(){super(new ac(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},lc=class extends sc{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Jn.DEFAULT_UP),this.updateMatrix(),this.target=new Jn,this.shadow=new vm}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var cc=class extends Qt{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Ta=-90,Ea=1,Ba=class extends Jn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new vi(Ta,Ea,e,t);s.layers=this.layers,this.add(s);let r=new vi(Ta,Ea,e,t);r.layers=this.layers,this.add(r);let o=new vi(Ta,Ea,e,t);o.layers=this.layers,this.add(o);let a=new vi(Ta,Ea,e,t);a.layers=this.layers,this.add(a);let l=new vi(Ta,Ea,e,t);l.layers=this.layers,this.add(l);let c=new vi(Ta,Ea,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===ns)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ia)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,d=e.getRenderTarget(),h=e.getActiveCubeFace(),f=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let v=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=v,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(d,h,f),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Wh=class extends vi{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var Qm="\\[\\]\\.:\\/",jT=new RegExp("["+Qm+"]","g"),eg="[^"+Qm+"]",QT="[^"+Qm.replace("\\.","")+"]",eE=/((?:WC+[\/:])*)/.source.replace("WC",eg),tE=/(WCOD+)?/.source.replace("WCOD",QT),nE=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",eg),iE=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",eg),sE=new RegExp("^"+eE+tE+nE+iE+"$"),rE=["material","materials","bones","map"],bm=class{constructor(e,t,i){let s=i||ln.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},ln=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(jT,"")}static parseTrackName(e){let t=sE.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);rE.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Ze("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){rt("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){rt("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){rt("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){rt("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){rt("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){rt("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;rt("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){rt("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};ln.Composite=bm;ln.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};ln.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};ln.prototype.GetterByBindingType=[ln.prototype._getValue_direct,ln.prototype._getValue_array,ln.prototype._getValue_arrayElement,ln.prototype._getValue_toArray];ln.prototype.SetterByBindingTypeAndVersioning=[[ln.prototype._setValue_direct,ln.prototype._setValue_direct_setNeedsUpdate,ln.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_array,ln.prototype._setValue_array_setNeedsUpdate,ln.prototype._setValue_array_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_arrayElement,ln.prototype._setValue_arrayElement_setNeedsUpdate,ln.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[ln.prototype._setValue_fromArray,ln.prototype._setValue_fromArray_setNeedsUpdate,ln.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var OU=new Float32Array(1);var jr=class extends Ah{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var za=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=pt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(pt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Sm=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var Mv=new B,ch=new B,Ca=new B,Ra=new B,pm=new B,oE=new B,aE=new B,uc=class{constructor(e=new B,t=new B){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){Mv.subVectors(e,this.start),ch.subVectors(this.end,this.start);let i=ch.dot(ch);if(i===0)return 0;let r=ch.dot(Mv)/i;return t&&(r=pt(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=oE,i=aE){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;Ca.subVectors(c,a),Ra.subVectors(u,l),pm.subVectors(a,l);let d=Ca.dot(Ca),h=Ra.dot(Ra),f=Ra.dot(pm);if(d<=s&&h<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(d<=s)r=0,o=f/h,o=pt(o,0,1);else{let p=Ca.dot(pm);if(h<=s)o=0,r=pt(-p/d,0,1);else{let v=Ca.dot(Ra),g=d*h-v*v;g!==0?r=pt((v*f-p*h)/g,0,1):r=0,o=(v*r+f)/h,o<0?(o=0,r=pt(-p/d,0,1)):o>1&&(o=1,r=pt((v-p)/d,0,1))}}return t.copy(a).addScaledVector(Ca,r),i.copy(l).addScaledVector(Ra,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var hc=class extends vs{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function tg(n,e,t,i){let s=lE(i);switch(t){case Vm:return n*e;case jh:return n*e/s.components*s.byteLength;case Qh:return n*e/s.components*s.byteLength;case no:return n*e*2/s.components*s.byteLength;case ed:return n*e*2/s.components*s.byteLength;case Hm:return n*e*3/s.components*s.byteLength;case Ji:return n*e*4/s.components*s.byteLength;case td:return n*e*4/s.components*s.byteLength;case pc:case mc:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case gc:case _c:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case id:case rd:return Math.max(n,16)*Math.max(e,8)/4;case nd:case sd:return Math.max(n,8)*Math.max(e,8)/2;case od:case ad:case cd:case ud:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case ld:case yc:case hd:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case dd:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case fd:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case pd:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case md:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case gd:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case _d:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case yd:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case xd:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case vd:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case bd:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case Sd:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case Md:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case wd:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case Ad:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case Td:case Ed:case Cd:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Rd:case Pd:return Math.ceil(n/4)*Math.ceil(e/4)*8;case xc:case Id:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function lE(n){switch(n){case Ii:case Fm:return{byteLength:1,components:1};case Wa:case km:case Ms:return{byteLength:2,components:1};case Kh:case Zh:return{byteLength:2,components:4};case Ss:case Jh:case ss:return{byteLength:4,components:1};case Bm:case zm:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Ze("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function Pb(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function uE(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,d=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let f;if(c instanceof Float32Array)f=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)f=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?f=n.HALF_FLOAT:f=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)f=n.SHORT;else if(c instanceof Uint32Array)f=n.UNSIGNED_INT;else if(c instanceof Int32Array)f=n.INT;else if(c instanceof Int8Array)f=n.BYTE;else if(c instanceof Uint8Array)f=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)f=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:f,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:d}}function i(a,l,c){let u=l.array,d=l.updateRanges;if(n.bindBuffer(c,a),d.length===0)n.bufferSubData(c,0,u);else{d.sort((f,p)=>f.start-p.start);let h=0;for(let f=1;f<d.length;f++){let p=d[h],v=d[f];v.start<=p.start+p.count+1?p.count=Math.max(p.count,v.start+v.count-p.start):(++h,d[h]=v)}d.length=h+1;for(let f=0,p=d.length;f<p;f++){let v=d[f];n.bufferSubData(c,v.start*u.BYTES_PER_ELEMENT,u,v.start,v.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var hE=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,dE=`#ifdef USE_ALPHAHASH
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
#endif`,fE=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,pE=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,mE=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,gE=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,_E=`#ifdef USE_AOMAP
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
#endif`,yE=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,xE=`#ifdef USE_BATCHING
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
#endif`,vE=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,bE=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,SE=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ME=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,wE=`#ifdef USE_IRIDESCENCE
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
#endif`,AE=`#ifdef USE_BUMPMAP
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
#endif`,TE=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,EE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,CE=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,RE=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,PE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,IE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,LE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,DE=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,NE=`#define PI 3.141592653589793
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
} // validated`,OE=`vec3 transformedNormal = objectNormal;
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
#endif`,UE=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,FE=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,kE=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,BE=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,zE="gl_FragColor = linearToOutputTexel( gl_FragColor );",VE=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,HE=`#ifdef USE_ENVMAP
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
#endif`,GE=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,WE=`#ifdef USE_ENVMAP
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
#endif`,$E=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,XE=`#ifdef USE_ENVMAP
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
#endif`,qE=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,YE=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,JE=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,KE=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,ZE=`#ifdef USE_GRADIENTMAP
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
}`,jE=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,QE=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,eC=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,tC=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,nC=`#ifdef USE_ENVMAP
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
#endif`,iC=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,sC=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,rC=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,oC=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,aC=`PhysicalMaterial material;
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
#endif`,lC=`uniform sampler2D dfgLUT;
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
}`,cC=`
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
#endif`,uC=`#if defined( RE_IndirectDiffuse )
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
#endif`,hC=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,dC=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,fC=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,pC=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,mC=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,gC=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,_C=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,yC=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,xC=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,vC=`#if defined( USE_POINTS_UV )
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
#endif`,bC=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,SC=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,MC=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,wC=`#if defined( USE_MORPHCOLORS )
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
#endif`,AC=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,TC=`#ifdef USE_MORPHTARGETS
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
#endif`,EC=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,CC=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,RC=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,PC=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,IC=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,LC=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,DC=`#ifdef USE_NORMALMAP
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
#endif`,NC=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,OC=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,UC=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,FC=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,kC=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,BC=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,zC=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,VC=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,HC=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,GC=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,WC=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,$C=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,XC=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,qC=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,YC=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,JC=`float getShadowMask() {
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
}`,KC=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,ZC=`#ifdef USE_SKINNING
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
#endif`,jC=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,QC=`#ifdef USE_SKINNING
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
#endif`,eR=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,tR=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,nR=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,iR=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,sR=`#ifdef USE_TRANSMISSION
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
#endif`,rR=`#ifdef USE_TRANSMISSION
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
#endif`,oR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,aR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,lR=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,cR=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,uR=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,hR=`uniform sampler2D t2D;
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
}`,dR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,fR=`uniform float backgroundBlurriness;
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
}`,pR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,mR=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,gR=`#include <common>
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
}`,_R=`#if DEPTH_PACKING == 3200
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
}`,yR=`#define DISTANCE
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
}`,xR=`#define DISTANCE
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
}`,vR=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,bR=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,SR=`uniform float scale;
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
}`,MR=`uniform vec3 diffuse;
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
}`,wR=`#include <common>
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
}`,AR=`uniform vec3 diffuse;
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
}`,TR=`#define LAMBERT
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
}`,ER=`#define LAMBERT
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
}`,CR=`#define MATCAP
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
}`,RR=`#define MATCAP
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
}`,PR=`#define NORMAL
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
}`,IR=`#define NORMAL
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
}`,LR=`#define PHONG
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
}`,DR=`#define PHONG
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
}`,NR=`#define STANDARD
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
}`,OR=`#define STANDARD
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
}`,UR=`#define TOON
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
}`,FR=`#define TOON
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
}`,kR=`uniform float size;
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
}`,BR=`uniform vec3 diffuse;
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
}`,zR=`#include <common>
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
}`,VR=`uniform vec3 color;
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
}`,HR=`uniform float rotation;
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
}`,GR=`uniform vec3 diffuse;
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
}`,_t={alphahash_fragment:hE,alphahash_pars_fragment:dE,alphamap_fragment:fE,alphamap_pars_fragment:pE,alphatest_fragment:mE,alphatest_pars_fragment:gE,aomap_fragment:_E,aomap_pars_fragment:yE,batching_pars_vertex:xE,batching_vertex:vE,begin_vertex:bE,beginnormal_vertex:SE,bsdfs:ME,iridescence_fragment:wE,bumpmap_pars_fragment:AE,clipping_planes_fragment:TE,clipping_planes_pars_fragment:EE,clipping_planes_pars_vertex:CE,clipping_planes_vertex:RE,color_fragment:PE,color_pars_fragment:IE,color_pars_vertex:LE,color_vertex:DE,common:NE,defaultnormal_vertex:OE,displacementmap_pars_vertex:UE,displacementmap_vertex:FE,emissivemap_fragment:kE,emissivemap_pars_fragment:BE,colorspace_fragment:zE,colorspace_pars_fragment:VE,envmap_fragment:HE,envmap_common_pars_fragment:GE,envmap_pars_fragment:WE,envmap_pars_vertex:$E,envmap_physical_pars_fragment:nC,envmap_vertex:XE,fog_vertex:qE,fog_pars_vertex:YE,fog_fragment:JE,fog_pars_fragment:KE,gradientmap_pars_fragment:ZE,lightmap_pars_fragment:jE,lights_lambert_fragment:QE,lights_lambert_pars_fragment:eC,lights_pars_begin:tC,lights_toon_fragment:iC,lights_toon_pars_fragment:sC,lights_phong_fragment:rC,lights_phong_pars_fragment:oC,lights_physical_fragment:aC,lights_physical_pars_fragment:lC,lights_fragment_begin:cC,lights_fragment_maps:uC,lights_fragment_end:hC,lightprobes_pars_fragment:dC,logdepthbuf_fragment:fC,logdepthbuf_pars_fragment:pC,logdepthbuf_pars_vertex:mC,logdepthbuf_vertex:gC,map_fragment:_C,map_pars_fragment:yC,map_particle_fragment:xC,map_particle_pars_fragment:vC,metalnessmap_fragment:bC,metalnessmap_pars_fragment:SC,morphinstance_vertex:MC,morphcolor_vertex:wC,morphnormal_vertex:AC,morphtarget_pars_vertex:TC,morphtarget_vertex:EC,normal_fragment_begin:CC,normal_fragment_maps:RC,normal_pars_fragment:PC,normal_pars_vertex:IC,normal_vertex:LC,normalmap_pars_fragment:DC,clearcoat_normal_fragment_begin:NC,clearcoat_normal_fragment_maps:OC,clearcoat_pars_fragment:UC,iridescence_pars_fragment:FC,opaque_fragment:kC,packing:BC,premultiplied_alpha_fragment:zC,project_vertex:VC,dithering_fragment:HC,dithering_pars_fragment:GC,roughnessmap_fragment:WC,roughnessmap_pars_fragment:$C,shadowmap_pars_fragment:XC,shadowmap_pars_vertex:qC,shadowmap_vertex:YC,shadowmask_pars_fragment:JC,skinbase_vertex:KC,skinning_pars_vertex:ZC,skinning_vertex:jC,skinnormal_vertex:QC,specularmap_fragment:eR,specularmap_pars_fragment:tR,tonemapping_fragment:nR,tonemapping_pars_fragment:iR,transmission_fragment:sR,transmission_pars_fragment:rR,uv_pars_fragment:oR,uv_pars_vertex:aR,uv_vertex:lR,worldpos_vertex:cR,background_vert:uR,background_frag:hR,backgroundCube_vert:dR,backgroundCube_frag:fR,cube_vert:pR,cube_frag:mR,depth_vert:gR,depth_frag:_R,distance_vert:yR,distance_frag:xR,equirect_vert:vR,equirect_frag:bR,linedashed_vert:SR,linedashed_frag:MR,meshbasic_vert:wR,meshbasic_frag:AR,meshlambert_vert:TR,meshlambert_frag:ER,meshmatcap_vert:CR,meshmatcap_frag:RR,meshnormal_vert:PR,meshnormal_frag:IR,meshphong_vert:LR,meshphong_frag:DR,meshphysical_vert:NR,meshphysical_frag:OR,meshtoon_vert:UR,meshtoon_frag:FR,points_vert:kR,points_frag:BR,shadow_vert:zR,shadow_frag:VR,sprite_vert:HR,sprite_frag:GR},Le={common:{diffuse:{value:new dt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ct}},envmap:{envMap:{value:null},envMapRotation:{value:new ct},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ct}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ct}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ct},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ct},normalScale:{value:new je(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ct},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ct}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ct}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ct}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new dt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new dt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0},uvTransform:{value:new ct}},sprite:{diffuse:{value:new dt(16777215)},opacity:{value:1},center:{value:new je(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ct},alphaMap:{value:null},alphaMapTransform:{value:new ct},alphaTest:{value:0}}},Mi={basic:{uniforms:li([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:_t.meshbasic_vert,fragmentShader:_t.meshbasic_frag},lambert:{uniforms:li([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new dt(0)},envMapIntensity:{value:1}}]),vertexShader:_t.meshlambert_vert,fragmentShader:_t.meshlambert_frag},phong:{uniforms:li([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new dt(0)},specular:{value:new dt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:_t.meshphong_vert,fragmentShader:_t.meshphong_frag},standard:{uniforms:li([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new dt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag},toon:{uniforms:li([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new dt(0)}}]),vertexShader:_t.meshtoon_vert,fragmentShader:_t.meshtoon_frag},matcap:{uniforms:li([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:_t.meshmatcap_vert,fragmentShader:_t.meshmatcap_frag},points:{uniforms:li([Le.points,Le.fog]),vertexShader:_t.points_vert,fragmentShader:_t.points_frag},dashed:{uniforms:li([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:_t.linedashed_vert,fragmentShader:_t.linedashed_frag},depth:{uniforms:li([Le.common,Le.displacementmap]),vertexShader:_t.depth_vert,fragmentShader:_t.depth_frag},normal:{uniforms:li([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:_t.meshnormal_vert,fragmentShader:_t.meshnormal_frag},sprite:{uniforms:li([Le.sprite,Le.fog]),vertexShader:_t.sprite_vert,fragmentShader:_t.sprite_frag},background:{uniforms:{uvTransform:{value:new ct},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:_t.background_vert,fragmentShader:_t.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ct}},vertexShader:_t.backgroundCube_vert,fragmentShader:_t.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:_t.cube_vert,fragmentShader:_t.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:_t.equirect_vert,fragmentShader:_t.equirect_frag},distance:{uniforms:li([Le.common,Le.displacementmap,{referencePosition:{value:new B},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:_t.distance_vert,fragmentShader:_t.distance_frag},shadow:{uniforms:li([Le.lights,Le.fog,{color:{value:new dt(0)},opacity:{value:1}}]),vertexShader:_t.shadow_vert,fragmentShader:_t.shadow_frag}};Mi.physical={uniforms:li([Mi.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ct},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ct},clearcoatNormalScale:{value:new je(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ct},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ct},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ct},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ct},sheen:{value:0},sheenColor:{value:new dt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ct},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ct},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ct},transmissionSamplerSize:{value:new je},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ct},attenuationDistance:{value:0},attenuationColor:{value:new dt(0)},specularColor:{value:new dt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ct},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ct},anisotropyVector:{value:new je},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ct}}]),vertexShader:_t.meshphysical_vert,fragmentShader:_t.meshphysical_frag};var Nd={r:0,b:0,g:0},WR=new vt,Ib=new ct;Ib.set(-1,0,0,0,1,0,0,0,1);function $R(n,e,t,i,s,r){let o=new dt(0),a=s===!0?0:1,l,c,u=null,d=0,h=null;function f(b){let E=b.isScene===!0?b.background:null;if(E&&E.isTexture){let M=b.backgroundBlurriness>0;E=e.get(E,M)}return E}function p(b){let E=!1,M=f(b);M===null?g(o,a):M&&M.isColor&&(g(M,1),E=!0);let I=n.xr.getEnvironmentBlendMode();I==="additive"?t.buffers.color.setClear(0,0,0,1,r):I==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function v(b,E){let M=f(E);M&&M.isCubeTexture?(c===void 0&&(c=new Dn(new ka(1,1,1),new is({name:"BackgroundCubeMaterial",uniforms:Do(Mi.backgroundCube.uniforms),vertexShader:Mi.backgroundCube.vertexShader,fragmentShader:Mi.backgroundCube.fragmentShader,side:Si,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(I,C,y){this.matrixWorld.copyPosition(y.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(WR.makeRotationFromEuler(E.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Ib),c.material.toneMapped=wt.getTransfer(M.colorSpace)!==Bt,(u!==M||d!==M.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=M,d=M.version,h=n.toneMapping),c.layers.enableAll(),b.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Dn(new tc(2,2),new is({name:"BackgroundMaterial",uniforms:Do(Mi.background.uniforms),vertexShader:Mi.background.vertexShader,fragmentShader:Mi.background.fragmentShader,side:to,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=wt.getTransfer(M.colorSpace)!==Bt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||d!==M.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=M,d=M.version,h=n.toneMapping),l.layers.enableAll(),b.unshift(l,l.geometry,l.material,0,0,null))}function g(b,E){b.getRGB(Nd,jm(n)),t.buffers.color.setClear(Nd.r,Nd.g,Nd.b,E,r)}function _(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(b,E=1){o.set(b),a=E,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(b){a=b,g(o,a)},render:p,addToRenderList:v,dispose:_}}function XR(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(L,H,V,O,$){let q=!1,G=d(L,O,V,H);r!==G&&(r=G,c(r.object)),q=f(L,O,V,$),q&&p(L,O,V,$),$!==null&&e.update($,n.ELEMENT_ARRAY_BUFFER),(q||o)&&(o=!1,M(L,H,V,O),$!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get($).buffer))}function l(){return n.createVertexArray()}function c(L){return n.bindVertexArray(L)}function u(L){return n.deleteVertexArray(L)}function d(L,H,V,O){let $=O.wireframe===!0,q=i[H.id];q===void 0&&(q={},i[H.id]=q);let G=L.isInstancedMesh===!0?L.id:0,ce=q[G];ce===void 0&&(ce={},q[G]=ce);let K=ce[V.id];K===void 0&&(K={},ce[V.id]=K);let ee=K[$];return ee===void 0&&(ee=h(l()),K[$]=ee),ee}function h(L){let H=[],V=[],O=[];for(let $=0;$<t;$++)H[$]=0,V[$]=0,O[$]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:V,attributeDivisors:O,object:L,attributes:{},index:null}}function f(L,H,V,O){let $=r.attributes,q=H.attributes,G=0,ce=V.getAttributes();for(let K in ce)if(ce[K].location>=0){let Y=$[K],oe=q[K];if(oe===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(oe=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(oe=L.instanceColor)),Y===void 0||Y.attribute!==oe||oe&&Y.data!==oe.data)return!0;G++}return r.attributesNum!==G||r.index!==O}function p(L,H,V,O){let $={},q=H.attributes,G=0,ce=V.getAttributes();for(let K in ce)if(ce[K].location>=0){let Y=q[K];Y===void 0&&(K==="instanceMatrix"&&L.instanceMatrix&&(Y=L.instanceMatrix),K==="instanceColor"&&L.instanceColor&&(Y=L.instanceColor));let oe={};oe.attribute=Y,Y&&Y.data&&(oe.data=Y.data),$[K]=oe,G++}r.attributes=$,r.attributesNum=G,r.index=O}function v(){let L=r.newAttributes;for(let H=0,V=L.length;H<V;H++)L[H]=0}function g(L){_(L,0)}function _(L,H){let V=r.newAttributes,O=r.enabledAttributes,$=r.attributeDivisors;V[L]=1,O[L]===0&&(n.enableVertexAttribArray(L),O[L]=1),$[L]!==H&&(n.vertexAttribDivisor(L,H),$[L]=H)}function b(){let L=r.newAttributes,H=r.enabledAttributes;for(let V=0,O=H.length;V<O;V++)H[V]!==L[V]&&(n.disableVertexAttribArray(V),H[V]=0)}function E(L,H,V,O,$,q,G){G===!0?n.vertexAttribIPointer(L,H,V,$,q):n.vertexAttribPointer(L,H,V,O,$,q)}function M(L,H,V,O){v();let $=O.attributes,q=V.getAttributes(),G=H.defaultAttributeValues;for(let ce in q){let K=q[ce];if(K.location>=0){let ee=$[ce];if(ee===void 0&&(ce==="instanceMatrix"&&L.instanceMatrix&&(ee=L.instanceMatrix),ce==="instanceColor"&&L.instanceColor&&(ee=L.instanceColor)),ee!==void 0){let Y=ee.normalized,oe=ee.itemSize,ue=e.get(ee);if(ue===void 0)continue;let te=ue.buffer,_e=ue.type,me=ue.bytesPerElement,Ae=_e===n.INT||_e===n.UNSIGNED_INT||ee.gpuType===Jh;if(ee.isInterleavedBufferAttribute){let be=ee.data,qe=be.isInterleavedBuffer===!0?be.stride:be.itemSize,tt=ee.offset;if(be.isInstancedInterleavedBuffer||be.isInstancedBufferAttribute){for(let Be=0;Be<K.locationSize;Be++)_(K.location+Be,be.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=be.meshPerAttribute*be.count)}else for(let Be=0;Be<K.locationSize;Be++)g(K.location+Be);n.bindBuffer(n.ARRAY_BUFFER,te);for(let Be=0;Be<K.locationSize;Be++)E(K.location+Be,oe/K.locationSize,_e,Y,qe*me,(tt+oe/K.locationSize*Be)*me,Ae)}else{if(ee.isInstancedBufferAttribute){for(let be=0;be<K.locationSize;be++)_(K.location+be,ee.meshPerAttribute);L.isInstancedMesh!==!0&&O._maxInstanceCount===void 0&&(O._maxInstanceCount=ee.meshPerAttribute*ee.count)}else for(let be=0;be<K.locationSize;be++)g(K.location+be);n.bindBuffer(n.ARRAY_BUFFER,te);for(let be=0;be<K.locationSize;be++)E(K.location+be,oe/K.locationSize,_e,Y,oe*me,oe/K.locationSize*be*me,Ae)}}else if(G!==void 0){let Y=G[ce];if(Y!==void 0)switch(Y.length){case 2:n.vertexAttrib2fv(K.location,Y);break;case 3:n.vertexAttrib3fv(K.location,Y);break;case 4:n.vertexAttrib4fv(K.location,Y);break;default:n.vertexAttrib1fv(K.location,Y)}}}}b()}function I(){k();for(let L in i){let H=i[L];for(let V in H){let O=H[V];for(let $ in O){let q=O[$];for(let G in q)u(q[G].object),delete q[G];delete O[$]}}delete i[L]}}function C(L){if(i[L.id]===void 0)return;let H=i[L.id];for(let V in H){let O=H[V];for(let $ in O){let q=O[$];for(let G in q)u(q[G].object),delete q[G];delete O[$]}}delete i[L.id]}function y(L){for(let H in i){let V=i[H];for(let O in V){let $=V[O];if($[L.id]===void 0)continue;let q=$[L.id];for(let G in q)u(q[G].object),delete q[G];delete $[L.id]}}}function T(L){for(let H in i){let V=i[H],O=L.isInstancedMesh===!0?L.id:0,$=V[O];if($!==void 0){for(let q in $){let G=$[q];for(let ce in G)u(G[ce].object),delete G[ce];delete $[q]}delete V[O],Object.keys(V).length===0&&delete i[H]}}}function k(){D(),o=!0,r!==s&&(r=s,c(r.object))}function D(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:D,dispose:I,releaseStatesOfGeometry:C,releaseStatesOfObject:T,releaseStatesOfProgram:y,initAttributes:v,enableAttribute:g,disableUnusedAttributes:b}}function qR(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let f=0;f<u;f++)h+=c[f];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function YR(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let y=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(y.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(y){return!(y!==Ji&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(y){let T=y===Ms&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(y!==Ii&&y!==ss&&!T&&i.convert(y)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(y){if(y==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";y="mediump"}return y==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Ze("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let d=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&d===!1;t.reversedDepthBuffer===!0&&d===!1&&Ze("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&d===!0&&Ze("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),v=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),_=n.getParameter(n.MAX_VERTEX_ATTRIBS),b=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:d,maxTextures:f,maxVertexTextures:p,maxTextureSize:v,maxCubemapSize:g,maxAttributes:_,maxVertexUniforms:b,maxVaryings:E,maxFragmentUniforms:M,maxSamples:I,samples:C}}function JR(n){let e=this,t=null,i=0,s=!1,r=!1,o=new xi,a=new ct,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(d,h){let f=d.length!==0||h||i!==0||s;return s=h,i=d.length,f},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(d,h){t=u(d,h,0)},this.setState=function(d,h,f){let p=d.clippingPlanes,v=d.clipIntersection,g=d.clipShadows,_=n.get(d);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let b=r?0:i,E=b*4,M=_.clippingState||null;l.value=M,M=u(p,h,E,f);for(let I=0;I!==E;++I)M[I]=t[I];_.clippingState=M,this.numIntersection=v?this.numPlanes:0,this.numPlanes+=b}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(d,h,f,p){let v=d!==null?d.length:0,g=null;if(v!==0){if(g=l.value,p!==!0||g===null){let _=f+v*4,b=h.matrixWorldInverse;a.getNormalMatrix(b),(g===null||g.length<_)&&(g=new Float32Array(_));for(let E=0,M=f;E!==v;++E,M+=4)o.copy(d[E]).applyMatrix4(b,a),o.normal.toArray(g,M),g[M+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=v,e.numIntersection=0,g}}var wc=class extends $i{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new jl(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new ka(5,5,5),r=new is({name:"CubemapFromEquirect",uniforms:Do(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:Si,blending:Ro});r.uniforms.tEquirect.value=t;let o=new Dn(s,r),a=t.minFilter;return t.minFilter===mr&&(t.minFilter=bi),new Ba(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},cb=256,KR=3,ZR=20,Lb=256,Db=16,jR=3,QR=new B,eP=new dt,Ud=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ba(1,10,null),this._boxMesh=new Dn(new ka(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=QR}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let d=l.autoClear,h=l.autoClearColor,f=l.autoClearDepth,p=l.autoClearStencil,v=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,v===null&&(e.background=l.getClearColor(eP));let g=new Ba(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=d,l.autoClearColor=h,l.autoClearDepth=f,l.autoClearStencil=p,e.background=v,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=db(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=hb(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(cb,Jm(e))}_fromTexture(e,t){e.mapping===Io||e.mapping===Ga?this._setSize(e.image.length===0?cb:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=ub(e,!1,!1),i=Math.log2(e)-KR;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=ub(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Io||e.mapping===Ga?(this._cubemapMaterial===null&&(this._cubemapMaterial=db()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=hb()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=tP(),this._integrationMaterial=nP());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Db);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-jR)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Lb*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=iP());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function ub(n,e,t){return new wc(n,{minFilter:mr,generateMipmaps:e,type:Ms,colorSpace:Hl,depthBuffer:t})}function Ac(n,e,t){return new is({name:n,uniforms:e,vertexShader:_t.cube_vert,fragmentShader:t,side:Si,blending:Ro,depthTest:!1,depthWrite:!1})}function tP(){return Ac("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Lb}u

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
	`)}function nP(){return Ac("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Db}},`

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
	`)}function iP(){return Ac("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${ZR}
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
	`)}function hb(){return Ac("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function db(){return Ac("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function sP(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,f=!1){return h==null?null:f?o(h):r(h)}function r(h){if(h&&h.isTexture){let f=h.mapping;if(f===Xh||f===qh)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let v=new wc(p.height);return v.fromEquirectangularTexture(n,h),e.set(h,v),h.addEventListener("dispose",c),a(v.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let f=h.mapping,p=f===Xh||f===qh,v=f===Io||f===Ga;if(p||v){let g=t.get(h),_=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==_)return i===null&&(i=new Ud(n)),g=p?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let b=h.image;return p&&b&&b.height>0||v&&b&&l(b)?(i===null&&(i=new Ud(n)),g=p?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,f){return f===Xh?h.mapping=Io:f===qh&&(h.mapping=Ga),h}function l(h){let f=0,p=6;for(let v=0;v<p;v++)h[v]!==void 0&&f++;return f===p}function c(h){let f=h.target;f.removeEventListener("dispose",c);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(h){let f=h.target;f.removeEventListener("dispose",u);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function d(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:d}}function rP(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&kl("WebGLRenderer: "+i+" extension not supported."),s}}}function oP(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let v=r.get(p);v&&(e.remove(v),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,v){return s[v.id]!==void 0||(v.addEventListener("dispose",a),s[v.id]=new WeakRef(v),o.register(v,v.id,v),t.memory.geometries++),v}function u(p){let v=p.attributes;for(let g in v)e.update(v[g],n.ARRAY_BUFFER)}function d(p){let v=p.index,g=p.attributes.position,_=0;if(g===void 0)return;let b=v!==null?v.array.length:g.array.length/3-1,E=g.count>=65535?Kl:Jl,M=new E(Math.ceil(b/3)*6,1),I=M.array;if(v!==null){let y=v.array;_=v.version;for(let T=0,k=0;T<b;T+=3){let D=y[T+0],L=y[T+1],H=y[T+2];I[k++]=D,I[k++]=L,I[k++]=L,I[k++]=H,I[k++]=H,I[k++]=D}}else{_=g.version;for(let y=0,T=0;y<b;y+=3){let k=y+0,D=y+1,L=y+2;I[T++]=k,I[T++]=D,I[T++]=D,I[T++]=L,I[T++]=L,I[T++]=k}}M.version=_;let C=r.get(p);C&&e.remove(C),r.set(p,M)}function h(p){let v=r.get(p);if(v){let g=p.index;g!==null&&v.version<g.version&&d(p)}else d(p);return r.get(p)}function f(){for(let p in s){let v=s[p].deref();v!==void 0&&l(v)}}return{get:c,update:u,getWireframeAttribute:h,dispose:f}}function aP(n,e,t){let i;function s(d){i=d}let r,o;function a(d){r=d.type,o=d.bytesPerElement}function l(d,h){n.drawElements(i,h,r,d*o),t.update(h,i,1)}function c(d,h,f){f!==0&&(n.drawElementsInstanced(i,h,r,d*o,f),t.update(h,i,f))}function u(d,h,f){if(f===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,d,0,f);let v=0;for(let g=0;g<f;g++)v+=h[g];t.update(v,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function lP(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:rt("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function cP(n,e,t){let i=new WeakMap,s=new zt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,d=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==d){let k=function(){y.dispose(),i.delete(a),a.removeEventListener("dispose",k)};h!==void 0&&h.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,v=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],_=a.morphAttributes.normal||[],b=a.morphAttributes.color||[],E=0;f===!0&&(E=1),p===!0&&(E=2),v===!0&&(E=3);let M=a.attributes.position.count*E,I=1;M>e.maxTextureSize&&(I=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let C=new Float32Array(M*I*4*d),y=new Xl(C,M,I,d);y.type=ss,y.needsUpdate=!0;let T=E*4;for(let D=0;D<d;D++){let L=g[D],H=_[D],V=b[D],O=M*I*4*D;for(let $=0;$<L.count;$++){let q=$*T;f===!0&&(s.fromBufferAttribute(L,$),C[O+q+0]=s.x,C[O+q+1]=s.y,C[O+q+2]=s.z,C[O+q+3]=0),p===!0&&(s.fromBufferAttribute(H,$),C[O+q+4]=s.x,C[O+q+5]=s.y,C[O+q+6]=s.z,C[O+q+7]=0),v===!0&&(s.fromBufferAttribute(V,$),C[O+q+8]=s.x,C[O+q+9]=s.y,C[O+q+10]=s.z,C[O+q+11]=V.itemSize===4?s.w:1)}}h={count:d,texture:y,size:new je(M,I)},i.set(a,h),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let f=0;for(let v=0;v<c.length;v++)f+=c[v];let p=a.morphTargetsRelative?1:1-f;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function uP(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,d=c.geometry,h=e.get(c,d);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let f=c.skeleton;r.get(f)!==u&&(f.update(),r.set(f,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var hP={[Rm]:"LINEAR_TONE_MAPPING",[Pm]:"REINHARD_TONE_MAPPING",[Im]:"CINEON_TONE_MAPPING",[Lm]:"ACES_FILMIC_TONE_MAPPING",[Nm]:"AGX_TONE_MAPPING",[Om]:"NEUTRAL_TONE_MAPPING",[Dm]:"CUSTOM_TONE_MAPPING"};function dP(n,e,t,i,s,r){let o=new $i(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new Qt;u.setAttribute("position",new Yn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new Yn([0,2,0,0,2,0],2));let d=new Ph({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Dn(u,d),f=new ac(-1,1,1,-1,0,1),p=null,v=null,g=!1,_,b=null,E=[],M=!1;this.setSize=function(I,C){o.setSize(I,C),a!==null&&a.setSize(I,C),l!==null&&l.setSize(I,C);for(let y=0;y<E.length;y++){let T=E[y];T.setSize&&T.setSize(I,C)}},this.setEffects=function(I){E=I,M=E.length>0&&E[0].isRenderPass===!0;let C=o.width,y=o.height;E.length>0&&a===null&&(a=new $i(C,y,{type:Ms,depthBuffer:!1,stencilBuffer:!1}),l=new $i(C,y,{type:Ms,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&E.some(k=>k.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new pr(C,y),r===!0&&(c.format=gr,c.type=Lo)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let k=0;k<E.length;k++){let D=E[k];D.setSize&&D.setSize(C,y),T&&D.needsDepthTexture===!0&&D.setDepthTexture&&D.setDepthTexture(c)}},this.begin=function(I,C){if(g||I.toneMapping===zs&&E.length===0)return!1;if(b=C,C!==null){let y=C.width,T=C.height;(o.width!==y||o.height!==T)&&this.setSize(y,T)}return M===!1&&I.setRenderTarget(o),_=I.toneMapping,I.toneMapping=zs,!0},this.hasRenderPass=function(){return M},this.end=function(I,C){I.toneMapping=_,g=!0;let y=o,T=a;for(let k=0;k<E.length;k++){let D=E[k];D.enabled!==!1&&(D.render(I,T,y,C),D.needsSwap!==!1&&(y=T,T=T===a?l:a))}if(p!==I.outputColorSpace||v!==I.toneMapping){p=I.outputColorSpace,v=I.toneMapping,d.defines={},wt.getTransfer(p)===Bt&&(d.defines.SRGB_TRANSFER="");let k=hP[v];k&&(d.defines[k]=""),d.needsUpdate=!0}d.uniforms.tDiffuse.value=y.texture,I.setRenderTarget(b),I.render(h,f),b=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),d.dispose()}}var Nb=new Pi,Ob=new pr(1,1),Ub=new Ql(1),Fb=new Xl,kb=new wh,Bb=new jl,fb=[],pb=[],mb=new Float32Array(16),gb=new Float32Array(9),_b=new Float32Array(4);function Xa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=fb[s];if(r===void 0&&(r=new Float32Array(s),fb[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function zn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Vn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function kd(n,e){let t=pb[e];t===void 0&&(t=new Int32Array(e),pb[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function fP(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function pP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(zn(t,e))return;n.uniform2fv(this.addr,e),Vn(t,e)}}function mP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(zn(t,e))return;n.uniform3fv(this.addr,e),Vn(t,e)}}function gP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(zn(t,e))return;n.uniform4fv(this.addr,e),Vn(t,e)}}function _P(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(zn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Vn(t,e)}else{if(zn(t,i))return;_b.set(i),n.uniformMatrix2fv(this.addr,!1,_b),Vn(t,i)}}function yP(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(zn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Vn(t,e)}else{if(zn(t,i))return;gb.set(i),n.uniformMatrix3fv(this.addr,!1,gb),Vn(t,i)}}function xP(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(zn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Vn(t,e)}else{if(zn(t,i))return;mb.set(i),n.uniformMatrix4fv(this.addr,!1,mb),Vn(t,i)}}function vP(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function bP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(zn(t,e))return;n.uniform2iv(this.addr,e),Vn(t,e)}}function SP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(zn(t,e))return;n.uniform3iv(this.addr,e),Vn(t,e)}}function MP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(zn(t,e))return;n.uniform4iv(this.addr,e),Vn(t,e)}}function wP(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function AP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(zn(t,e))return;n.uniform2uiv(this.addr,e),Vn(t,e)}}function TP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(zn(t,e))return;n.uniform3uiv(this.addr,e),Vn(t,e)}}function EP(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(zn(t,e))return;n.uniform4uiv(this.addr,e),Vn(t,e)}}function Bd(n){return n.version===0&&(n.compareFunction=$m,n.needsUpdate=!0),n}function CP(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Bd(Ob):r=Nb,t.setTexture2D(e||r,s)}function RP(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||kb,s)}function PP(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Bd(Ub):r=Bb,t.setTextureCube(e||r,s)}function IP(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||Fb,s)}function LP(n){switch(n){case 5126:return fP;case 35664:return pP;case 35665:return mP;case 35666:return gP;case 35674:return _P;case 35675:return yP;case 35676:return xP;case 5124:case 35670:return vP;case 35667:case 35671:return bP;case 35668:case 35672:return SP;case 35669:case 35673:return MP;case 5125:return wP;case 36294:return AP;case 36295:return TP;case 36296:return EP;case 35678:case 36198:case 36298:case 36306:case 35682:return CP;case 35679:case 36299:case 36307:return RP;case 35680:case 36300:case 36308:case 36293:return PP;case 36289:case 36303:case 36311:case 36292:return IP}}function DP(n,e){n.uniform1fv(this.addr,e)}function NP(n,e){let t=Xa(e,this.size,2);n.uniform2fv(this.addr,t)}function OP(n,e){let t=Xa(e,this.size,3);n.uniform3fv(this.addr,t)}function UP(n,e){let t=Xa(e,this.size,4);n.uniform4fv(this.addr,t)}function FP(n,e){let t=Xa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function kP(n,e){let t=Xa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function BP(n,e){let t=Xa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function zP(n,e){n.uniform1iv(this.addr,e)}function VP(n,e){n.uniform2iv(this.addr,e)}function HP(n,e){n.uniform3iv(this.addr,e)}function GP(n,e){n.uniform4iv(this.addr,e)}function WP(n,e){n.uniform1uiv(this.addr,e)}function $P(n,e){n.uniform2uiv(this.addr,e)}function XP(n,e){n.uniform3uiv(this.addr,e)}function qP(n,e){n.uniform4uiv(this.addr,e)}function YP(n,e,t){let i=this.cache,s=e.length,r=kd(t,s);zn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Bd(Ob):o=Nb;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function JP(n,e,t){let i=this.cache,s=e.length,r=kd(t,s);zn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||kb,r[o])}function KP(n,e,t){let i=this.cache,s=e.length,r=kd(t,s);zn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Bd(Ub):o=Bb;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function ZP(n,e,t){let i=this.cache,s=e.length,r=kd(t,s);zn(i,r)||(n.uniform1iv(this.addr,r),Vn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||Fb,r[o])}function jP(n){switch(n){case 5126:return DP;case 35664:return NP;case 35665:return OP;case 35666:return UP;case 35674:return FP;case 35675:return kP;case 35676:return BP;case 5124:case 35670:return zP;case 35667:case 35671:return VP;case 35668:case 35672:return HP;case 35669:case 35673:return GP;case 5125:return WP;case 36294:return $P;case 36295:return XP;case 36296:return qP;case 35678:case 36198:case 36298:case 36306:case 35682:return YP;case 35679:case 36299:case 36307:return JP;case 35680:case 36300:case 36308:case 36293:return KP;case 36289:case 36303:case 36311:case 36292:return ZP}}var sg=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=LP(t.type)}},rg=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=jP(t.type)}},og=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},ng=/(\w+)(\])?(\[|\.)?/g;function yb(n,e){n.seq.push(e),n.map[e.id]=e}function QP(n,e,t){let i=n.name,s=i.length;for(ng.lastIndex=0;;){let r=ng.exec(i),o=ng.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){yb(t,c===void 0?new sg(a,n,e):new rg(a,n,e));break}else{let d=t.map[a];d===void 0&&(d=new og(a),yb(t,d)),t=d}}}var $a=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);QP(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function xb(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var e3=37297,t3=0;function n3(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var vb=new ct;function i3(n){wt._getMatrix(vb,wt.workingColorSpace,n);let e=`mat3( ${vb.elements.map(t=>t.toFixed(4))} )`;switch(wt.getTransfer(n)){case Gl:return[e,"LinearTransferOETF"];case Bt:return[e,"sRGBTransferOETF"];default:return Ze("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function bb(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+n3(n.getShaderSource(e),a)}else return r}function s3(n,e){let t=i3(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var r3={[Rm]:"Linear",[Pm]:"Reinhard",[Im]:"Cineon",[Lm]:"ACESFilmic",[Nm]:"AgX",[Om]:"Neutral",[Dm]:"Custom"};function o3(n,e){let t=r3[e];return t===void 0?(Ze("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Od=new B;function a3(){wt.getLuminanceCoefficients(Od);let n=Od.x.toFixed(4),e=Od.y.toFixed(4),t=Od.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function l3(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Mc).join(`
`)}function c3(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function u3(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Mc(n){return n!==""}function Sb(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Mb(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var h3=/^[ \t]*#include +<([\w\d./]+)>/gm;function ag(n){return n.replace(h3,d3)}function d3(n,e){let t=_t[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return ag(t)}var f3=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function wb(n){return n.replace(f3,p3)}function p3(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Ab(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var m3={[dc]:"SHADOWMAP_TYPE_PCF",[Va]:"SHADOWMAP_TYPE_VSM"};function g3(n){return m3[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var _3={[Ga]:"ENVMAP_MODE_REFRACTION"};function y3(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":_3[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var x3={[$h]:"ENVMAP_BLENDING_MULTIPLY",[$v]:"ENVMAP_BLENDING_MIX",[Xv]:"ENVMAP_BLENDING_ADD"};function v3(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":x3[n.combine]||"ENVMAP_BLENDING_NONE"}function b3(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=g3(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=y3(t),d=v3(t),h=l3(t),f=c3(r),p=s.createProgram(),v,g,_=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(v=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Mc).join(`
`),v.length>0&&(v+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f].filter(Mc).join(`
`),g.length>0&&(g+=`
`)):(v=[Ab(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Mc).join(`
`),g=[Ab(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,f,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+d:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==zs?"#define TONE_MAPPING":"",t.toneMapping!==zs?_t.tonemapping_pars_fragment:"",t.toneMapping!==zs?o3("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",_t.colorspace_pars_fragment,s3("linearToOutputTexel",t.outputColorSpace),a3(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Mc).join(`
`)),o=ag(o),o=Sb(o,t),o=Mb(o,t),a=ag(a),a=Sb(a,t),a=Mb(a,t),o=wb(o),a=wb(a),t.isRawShaderMaterial!==!0&&(_=`#version 300 es
`,v=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+v,g=["#define varying in",t.glslVersion===qm?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===qm?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let b=_+v+o,E=_+g+a,M=xb(s,s.VERTEX_SHADER,b),I=xb(s,s.FRAGMENT_SHADER,E);s.attachShader(p,M),s.attachShader(p,I),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function C(D){if(n.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(M)||"",V=s.getShaderInfoLog(I)||"",O=L.trim(),$=H.trim(),q=V.trim(),G=!0,ce=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,M,I);else{let K=bb(s,M,"vertex"),ee=bb(s,I,"fragment");rt("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+D.name+`
Material Type: `+D.type+`

Program Info Log: `+O+`
`+K+`
`+ee)}else O!==""?Ze("WebGLProgram: Program Info Log:",O):($===""||q==="")&&(ce=!1);ce&&(D.diagnostics={runnable:G,programLog:O,vertexShader:{log:$,prefix:v},fragmentShader:{log:q,prefix:g}})}s.deleteShader(M),s.deleteShader(I),y=new $a(s,p),T=u3(s,p)}let y;this.getUniforms=function(){return y===void 0&&C(this),y};let T;this.getAttributes=function(){return T===void 0&&C(this),T};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(p,e3)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=t3++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=M,this.fragmentShader=I,this}var S3=0,lg=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new cg(e),t.set(e,i)),i}},cg=class{constructor(e){this.id=S3++,this.code=e,this.usedTimes=0}};function M3(n){return n===no||n===yc||n===xc}function w3(n,e,t,i,s,r){let o=new ql,a=new lg,l=new Set,c=[],u=new Map,d=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(y){return l.add(y),y===0?"uv":`uv${y}`}function p(y,T,k,D,L,H){let V=D.fog,O=L.geometry,$=y.isMeshStandardMaterial||y.isMeshLambertMaterial||y.isMeshPhongMaterial?D.environment:null,q=y.isMeshStandardMaterial||y.isMeshLambertMaterial&&!y.envMap||y.isMeshPhongMaterial&&!y.envMap,G=e.get(y.envMap||$,q),ce=h[y.type],K=i.precision;y.precision!==null&&(K=i.getMaxPrecision(y.precision),K!==y.precision&&Ze("WebGLProgram.getParameters:",y.precision,"not supported, using",K,"instead."));let ee=O.morphAttributes.position||O.morphAttributes.normal||O.morphAttributes.color,Y=ee!==void 0?ee.length:0,oe=0;O.morphAttributes.position!==void 0&&(oe=1),O.morphAttributes.normal!==void 0&&(oe=2),O.morphAttributes.color!==void 0&&(oe=3);let ue,te,_e,me;if(ce){let Ie=Mi[ce];ue=Ie.vertexShader,te=Ie.fragmentShader}else{ue=y.vertexShader,te=y.fragmentShader;let Ie=a.getVertexShaderStage(y),mt=a.getFragmentShaderStage(y);a.update(y,Ie,mt),_e=Ie.id,me=mt.id}let Ae=n.getRenderTarget(),be=n.state.buffers.depth.getReversed(),qe=L.isInstancedMesh===!0,tt=L.isBatchedMesh===!0,Be=!!y.map,ot=!!y.matcap,ut=!!G,Je=ut&&G.isPMREMTexture===!0,Vt=!!y.aoMap,qt=!!y.lightMap,dn=!!y.bumpMap&&y.wireframe===!1,Dt=!!y.normalMap,Nn=!!y.displacementMap,At=!!y.emissiveMap,un=!!y.metalnessMap,tn=!!y.roughnessMap,fn=y.anisotropy>0,U=y.clearcoat>0,Ee=y.diffuseRoughness>0,Ke=y.dispersion>0,at=y.retroreflectivity>0,we=y.iridescence>0,Nt=y.sheen>0,ze=y.transmission>0,ye=fn&&!!y.anisotropyMap,R=U&&!!y.clearcoatMap,S=U&&!!y.clearcoatNormalMap,X=U&&!!y.clearcoatRoughnessMap,de=Ee&&!!y.diffuseRoughnessMap,ae=we&&!!y.iridescenceMap,ve=we&&!!y.iridescenceThicknessMap,Se=Nt&&!!y.sheenColorMap,ne=Nt&&!!y.sheenRoughnessMap,se=!!y.specularMap,ge=!!y.specularColorMap,F=!!y.specularIntensityMap,re=ze&&!!y.transmissionMap,ie=ze&&!!y.thicknessMap,Ce=!!y.gradientMap,xe=!!y.alphaMap,Te=y.alphaTest>0,Xe=!!y.alphaHash,nt=!!y.extensions,he=zs;y.toneMapped&&(Ae===null||Ae.isXRRenderTarget===!0)&&(he=n.toneMapping);let He=Je?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,it={shaderID:ce,shaderType:y.type,shaderName:y.name,vertexShader:ue,fragmentShader:te,defines:y.defines,customVertexShaderID:_e,customFragmentShaderID:me,isRawShaderMaterial:y.isRawShaderMaterial===!0,glslVersion:y.glslVersion,precision:K,batching:tt,batchingColor:tt&&L._colorsTexture!==null,instancing:qe,instancingColor:qe&&L.instanceColor!==null,instancingMorph:qe&&L.morphTexture!==null,outputColorSpace:Ae===null?n.outputColorSpace:Ae.isXRRenderTarget===!0?Ae.texture.colorSpace:wt.workingColorSpace,alphaToCoverage:!!y.alphaToCoverage,map:Be,matcap:ot,envMap:ut,envMapMode:ut&&G.mapping,envMapPMREM:Je,envMapMaxLod:Je?He.length-1:null,envMapSize:Je?He[0].width:null,aoMap:Vt,lightMap:qt,bumpMap:dn,normalMap:Dt,displacementMap:Nn,emissiveMap:At,normalMapObjectSpace:Dt&&y.normalMapType===Jv,normalMapTangentSpace:Dt&&y.normalMapType===Ld,packedNormalMap:Dt&&y.normalMapType===Ld&&M3(y.normalMap.format),metalnessMap:un,roughnessMap:tn,anisotropy:fn,anisotropyMap:ye,clearcoat:U,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:X,diffuseRoughness:Ee,diffuseRoughnessMap:de,dispersion:Ke,retroreflection:at,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:ve,sheen:Nt,sheenColorMap:Se,sheenRoughnessMap:ne,specularMap:se,specularColorMap:ge,specularIntensityMap:F,transmission:ze,transmissionMap:re,thicknessMap:ie,gradientMap:Ce,opaque:y.transparent===!1&&y.blending===Ha&&y.alphaToCoverage===!1,alphaMap:xe,alphaTest:Te,alphaHash:Xe,combine:y.combine,mapUv:Be&&f(y.map.channel),aoMapUv:Vt&&f(y.aoMap.channel),lightMapUv:qt&&f(y.lightMap.channel),bumpMapUv:dn&&f(y.bumpMap.channel),normalMapUv:Dt&&f(y.normalMap.channel),displacementMapUv:Nn&&f(y.displacementMap.channel),emissiveMapUv:At&&f(y.emissiveMap.channel),metalnessMapUv:un&&f(y.metalnessMap.channel),roughnessMapUv:tn&&f(y.roughnessMap.channel),anisotropyMapUv:ye&&f(y.anisotropyMap.channel),clearcoatMapUv:R&&f(y.clearcoatMap.channel),clearcoatNormalMapUv:S&&f(y.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:X&&f(y.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&f(y.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&f(y.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&f(y.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&f(y.sheenColorMap.channel),sheenRoughnessMapUv:ne&&f(y.sheenRoughnessMap.channel),specularMapUv:se&&f(y.specularMap.channel),specularColorMapUv:ge&&f(y.specularColorMap.channel),specularIntensityMapUv:F&&f(y.specularIntensityMap.channel),transmissionMapUv:re&&f(y.transmissionMap.channel),thicknessMapUv:ie&&f(y.thicknessMap.channel),alphaMapUv:xe&&f(y.alphaMap.channel),vertexTangents:!!O.attributes.tangent&&(Dt||fn),vertexNormals:!!O.attributes.normal,vertexColors:y.vertexColors,vertexAlphas:y.vertexColors===!0&&!!O.attributes.color&&O.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!O.attributes.uv&&(Be||xe),fog:!!V,useFog:y.fog===!0,fogExp2:!!V&&V.isFogExp2,flatShading:y.wireframe===!1&&(y.flatShading===!0||O.attributes.normal===void 0&&Dt===!1&&(y.isMeshLambertMaterial||y.isMeshPhongMaterial||y.isMeshStandardMaterial||y.isMeshPhysicalMaterial)),sizeAttenuation:y.sizeAttenuation===!0,logarithmicDepthBuffer:d,reversedDepthBuffer:be,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:O.attributes.position!==void 0,morphTargets:O.morphAttributes.position!==void 0,morphNormals:O.morphAttributes.normal!==void 0,morphColors:O.morphAttributes.color!==void 0,morphTargetsCount:Y,morphTextureStride:oe,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:H.filter(Ie=>Ie.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:y.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:he,decodeVideoTexture:Be&&y.map.isVideoTexture===!0&&wt.getTransfer(y.map.colorSpace)===Bt,decodeVideoTextureEmissive:At&&y.emissiveMap.isVideoTexture===!0&&wt.getTransfer(y.emissiveMap.colorSpace)===Bt,premultipliedAlpha:y.premultipliedAlpha,doubleSided:y.side===ei,flipSided:y.side===Si,useDepthPacking:y.depthPacking>=0,depthPacking:y.depthPacking||0,index0AttributeName:y.index0AttributeName,extensionClipCullDistance:nt&&y.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(nt&&y.extensions.multiDraw===!0||tt)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:y.customProgramCacheKey()};return it.vertexUv1s=l.has(1),it.vertexUv2s=l.has(2),it.vertexUv3s=l.has(3),l.clear(),it}function v(y){let T=[];if(y.shaderID?T.push(y.shaderID):(T.push(y.customVertexShaderID),T.push(y.customFragmentShaderID)),y.defines!==void 0)for(let k in y.defines)T.push(k),T.push(y.defines[k]);return y.isRawShaderMaterial===!1&&(g(T,y),_(T,y),T.push(n.outputColorSpace)),T.push(y.customProgramCacheKey),T.join()}function g(y,T){y.push(T.precision),y.push(T.outputColorSpace),y.push(T.envMapMode),y.push(T.envMapPMREM),y.push(T.envMapMaxLod),y.push(T.envMapSize),y.push(T.mapUv),y.push(T.alphaMapUv),y.push(T.lightMapUv),y.push(T.aoMapUv),y.push(T.bumpMapUv),y.push(T.normalMapUv),y.push(T.displacementMapUv),y.push(T.emissiveMapUv),y.push(T.metalnessMapUv),y.push(T.roughnessMapUv),y.push(T.anisotropyMapUv),y.push(T.clearcoatMapUv),y.push(T.clearcoatNormalMapUv),y.push(T.clearcoatRoughnessMapUv),y.push(T.diffuseRoughnessMapUv),y.push(T.iridescenceMapUv),y.push(T.iridescenceThicknessMapUv),y.push(T.sheenColorMapUv),y.push(T.sheenRoughnessMapUv),y.push(T.specularMapUv),y.push(T.specularColorMapUv),y.push(T.specularIntensityMapUv),y.push(T.transmissionMapUv),y.push(T.thicknessMapUv),y.push(T.combine),y.push(T.fogExp2),y.push(T.sizeAttenuation),y.push(T.morphTargetsCount),y.push(T.numSunLights),y.push(T.numDirLights),y.push(T.numPointLights),y.push(T.numSpotLights),y.push(T.numSpotLightMaps),y.push(T.numHemiLights),y.push(T.numRectAreaLights),y.push(T.numSunLightShadows),y.push(T.numDirLightShadows),y.push(T.numPointLightShadows),y.push(T.numSpotLightShadows),y.push(T.numSpotLightShadowsWithMaps),y.push(T.numLightProbes),y.push(T.numLightProbeGrids),y.push(T.shadowMapType),y.push(T.toneMapping),y.push(T.numClippingPlanes),y.push(T.numClipIntersection),y.push(T.depthPacking)}function _(y,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),y.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),y.push(o.mask)}function b(y){let T=h[y.type],k;if(T){let D=Mi[T];k=bc.clone(D.uniforms)}else k=y.uniforms;return k}function E(y,T){let k=u.get(T);return k!==void 0?++k.usedTimes:(k=new b3(n,T,y,s),c.push(k),u.set(T,k)),k}function M(y){if(--y.usedTimes===0){let T=c.indexOf(y);c[T]=c[c.length-1],c.pop(),u.delete(y.cacheKey),y.destroy()}}function I(y){a.remove(y)}function C(){a.dispose()}return{getParameters:p,getProgramCacheKey:v,getUniforms:b,acquireProgram:E,releaseProgram:M,releaseShaderCache:I,programs:c,dispose:C}}function A3(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function T3(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Tb(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Eb(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let f=0;return h.isInstancedMesh&&(f+=2),h.isSkinnedMesh&&(f+=1),f}function a(h,f,p,v,g,_){let b=n[e];return b===void 0?(b={id:h.id,object:h,geometry:f,material:p,materialVariant:o(h),groupOrder:v,renderOrder:h.renderOrder,z:g,group:_},n[e]=b):(b.id=h.id,b.object=h,b.geometry=f,b.material=p,b.materialVariant=o(h),b.groupOrder=v,b.renderOrder=h.renderOrder,b.z=g,b.group=_),e++,b}function l(h,f,p,v,g,_,b){b.reversedDepth===!0&&(g=-g);let E=a(h,f,p,v,g,_);p.transmission>0?i.push(E):p.transparent===!0?s.push(E):t.push(E)}function c(h,f,p,v,g,_){let b=a(h,f,p,v,g,_);p.transmission>0?i.unshift(b):p.transparent===!0?s.unshift(b):t.unshift(b)}function u(h,f){t.length>1&&t.sort(h||T3),i.length>1&&i.sort(f||Tb),s.length>1&&s.sort(f||Tb)}function d(){for(let h=e,f=n.length;h<f;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:d,sort:u}}function E3(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Eb,n.set(i,[o])):s>=r.length?(o=new Eb,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function C3(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new B,color:new dt};break;case"SpotLight":t={position:new B,direction:new B,color:new dt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new B,color:new dt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new B,skyColor:new dt,groundColor:new dt};break;case"RectAreaLight":t={color:new dt,position:new B,halfWidth:new B,halfHeight:new B};break}return n[e.id]=t,t}}}function R3(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new je,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var P3=0;function I3(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function L3(n){let e=new C3,t=R3(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new B);let s=new B,r=new vt,o=new vt;function a(c){let u=0,d=0,h=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let f=0,p=0,v=0,g=0,_=0,b=0,E=0,M=0,I=0,C=0,y=0,T=0,k=0,D=0;c.sort(I3);for(let H=0,V=c.length;H<V;H++){let O=c[H],$=O.color,q=O.intensity,G=O.distance,ce=null;if(O.shadow&&O.shadow.map&&(O.shadow.map.texture.format===no?ce=O.shadow.map.texture:ce=O.shadow.map.depthTexture||O.shadow.map.texture),O.isAmbientLight)u+=$.r*q,d+=$.g*q,h+=$.b*q;else if(O.isLightProbe){for(let K=0;K<9;K++)i.probe[K].addScaledVector(O.sh.coefficients[K],q);D++}else if(O.isSunLight){let K=e.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let ee=O.shadow,Y=t.get(O);Y.shadowIntensity=ee.intensity,Y.shadowBias=ee.bias,Y.shadowNormalBias=ee.normalBias,Y.shadowRadius=ee.radius,Y.shadowMapSize.copy(ee.mapSize).multiply(ee.getFrameExtents()),i.sunShadow[p]=Y,i.sunShadowMap[p]=ce;let oe=ee.getViewportCount();for(let ue=0;ue<oe;ue++)i.sunShadowMatrix[v+ue]=ee.getMatrix(ue),i.sunShadowCascade[v+ue]=ee._cascadeData[ue];v+=oe,p++}i.sun[f]=K,f++}else if(O.isDirectionalLight){let K=e.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),O.castShadow){let ee=O.shadow,Y=t.get(O);Y.shadowIntensity=ee.intensity,Y.shadowBias=ee.bias,Y.shadowNormalBias=ee.normalBias,Y.shadowRadius=ee.radius,Y.shadowMapSize=ee.mapSize,i.directionalShadow[g]=Y,i.directionalShadowMap[g]=ce,i.directionalShadowMatrix[g]=O.shadow.matrix,I++}i.directional[g]=K,g++}else if(O.isSpotLight){let K=e.get(O);K.position.setFromMatrixPosition(O.matrixWorld),K.color.copy($).multiplyScalar(q),K.distance=G,K.coneCos=Math.cos(O.angle),K.penumbraCos=Math.cos(O.angle*(1-O.penumbra)),K.decay=O.decay,i.spot[b]=K;let ee=O.shadow;if(O.map&&(i.spotLightMap[T]=O.map,T++,ee.updateMatrices(O),O.castShadow&&k++),i.spotLightMatrix[b]=ee.matrix,O.castShadow){let Y=t.get(O);Y.shadowIntensity=ee.intensity,Y.shadowBias=ee.bias,Y.shadowNormalBias=ee.normalBias,Y.shadowRadius=ee.radius,Y.shadowMapSize=ee.mapSize,i.spotShadow[b]=Y,i.spotShadowMap[b]=ce,y++}b++}else if(O.isRectAreaLight){let K=e.get(O);K.color.copy($).multiplyScalar(q),K.halfWidth.set(O.width*.5,0,0),K.halfHeight.set(0,O.height*.5,0),i.rectArea[E]=K,E++}else if(O.isPointLight){let K=e.get(O);if(K.color.copy(O.color).multiplyScalar(O.intensity),K.distance=O.distance,K.decay=O.decay,O.castShadow){let ee=O.shadow,Y=t.get(O);Y.shadowIntensity=ee.intensity,Y.shadowBias=ee.bias,Y.shadowNormalBias=ee.normalBias,Y.shadowRadius=ee.radius,Y.shadowMapSize=ee.mapSize,Y.shadowCameraNear=ee.camera.near,Y.shadowCameraFar=ee.camera.far,i.pointShadow[_]=Y,i.pointShadowMap[_]=ce,i.pointShadowMatrix[_]=O.shadow.matrix,C++}i.point[_]=K,_++}else if(O.isHemisphereLight){let K=e.get(O);K.skyColor.copy(O.color).multiplyScalar(q),K.groundColor.copy(O.groundColor).multiplyScalar(q),i.hemi[M]=K,M++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=d,i.ambient[2]=h;let L=i.hash;(L.sunLength!==f||L.directionalLength!==g||L.pointLength!==_||L.spotLength!==b||L.rectAreaLength!==E||L.hemiLength!==M||L.numSunShadows!==p||L.numDirectionalShadows!==I||L.numPointShadows!==C||L.numSpotShadows!==y||L.numSpotMaps!==T||L.numLightProbes!==D)&&(i.sun.length=f,i.directional.length=g,i.spot.length=b,i.rectArea.length=E,i.point.length=_,i.hemi.length=M,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=v,i.sunShadowCascade.length=v,i.directionalShadow.length=I,i.directionalShadowMap.length=I,i.directionalShadowMatrix.length=I,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=y,i.spotShadowMap.length=y,i.spotLightMatrix.length=y+T-k,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=D,L.sunLength=f,L.directionalLength=g,L.pointLength=_,L.spotLength=b,L.rectAreaLength=E,L.hemiLength=M,L.numSunShadows=p,L.numDirectionalShadows=I,L.numPointShadows=C,L.numSpotShadows=y,L.numSpotMaps=T,L.numLightProbes=D,i.version=P3++)}function l(c,u){let d=0,h=0,f=0,p=0,v=0,g=0,_=u.matrixWorldInverse;for(let b=0,E=c.length;b<E;b++){let M=c[b];if(M.isSunLight){let I=i.sun[d];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(_),d++}else if(M.isDirectionalLight){let I=i.directional[h];I.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(_),h++}else if(M.isSpotLight){let I=i.spot[p];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(_),I.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(_),p++}else if(M.isRectAreaLight){let I=i.rectArea[v];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(_),o.identity(),r.copy(M.matrixWorld),r.premultiply(_),o.extractRotation(r),I.halfWidth.set(M.width*.5,0,0),I.halfHeight.set(0,M.height*.5,0),I.halfWidth.applyMatrix4(o),I.halfHeight.applyMatrix4(o),v++}else if(M.isPointLight){let I=i.point[f];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(_),f++}else if(M.isHemisphereLight){let I=i.hemi[g];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(_),g++}}}return{setup:a,setupView:l,state:i}}function Cb(n){let e=new L3(n),t=[],i=[],s=[];function r(d){u.camera=d,t.length=0,i.length=0,s.length=0}function o(d){d.isLightProbeGrid?s.push(d):t.push(d)}function a(d){i.push(d)}function l(){e.setup(t),s.sort((d,h)=>d.priority-h.priority||d.id-h.id)}function c(d){e.setupView(t,d)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function D3(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Cb(n),e.set(s,[a])):r>=o.length?(a=new Cb(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var N3=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,O3=`uniform sampler2D shadow_pass;
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
}`,U3=[new B(1,0,0),new B(-1,0,0),new B(0,1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1)],F3=[new B(0,-1,0),new B(0,-1,0),new B(0,0,1),new B(0,0,-1),new B(0,-1,0),new B(0,-1,0)],Rb=new vt,Sc=new B,ig=new B;function k3(n,e,t){let i=new qr,s=new je,r=new je,o=new zt,a=new Ih,l=new Lh,c={},u=t.maxTextureSize,d={[to]:Si,[Si]:to,[ei]:ei},h=new is({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new je},radius:{value:4}},vertexShader:N3,fragmentShader:O3}),f=h.clone();f.defines.HORIZONTAL_PASS=1;let p=new Qt;p.setAttribute("position",new Jt(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let v=new Dn(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=dc;let _=this.type;this.render=function(C,y,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||C.length===0)return;this.type===Tv&&(Ze("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=dc);let k=n.getRenderTarget(),D=n.getActiveCubeFace(),L=n.getActiveMipmapLevel(),H=n.state;H.setBlending(Ro),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let V=_!==this.type;V&&y.traverse(function(O){O.material&&(Array.isArray(O.material)?O.material.forEach($=>$.needsUpdate=!0):O.material.needsUpdate=!0)});for(let O=0,$=C.length;O<$;O++){let q=C[O],G=q.shadow;if(G===void 0){Ze("WebGLShadowMap:",q,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ce=G.getFrameExtents();s.multiply(ce),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ce.x),s.x=r.x*ce.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ce.y),s.y=r.y*ce.y,G.mapSize.y=r.y));let K=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=K,G.map===null||V===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Va){if(q.isPointLight){Ze("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new $i(s.x,s.y,{format:no,type:Ms,minFilter:bi,magFilter:bi,generateMipmaps:!1}),G.map.texture.name=q.name+".shadowMap",G.map.depthTexture=new pr(s.x,s.y,ss),G.map.depthTexture.name=q.name+".shadowMapDepth",G.map.depthTexture.format=hr,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Mn,G.map.depthTexture.magFilter=Mn}else q.isPointLight?(G.map=new wc(s.x),G.map.depthTexture=new Ql(s.x,Ss)):(G.map=new $i(s.x,s.y),G.map.depthTexture=new pr(s.x,s.y,Ss)),G.map.depthTexture.name=q.name+".shadowMap",G.map.depthTexture.format=hr,this.type===dc?(G.map.depthTexture.compareFunction=K?Wm:Gm,G.map.depthTexture.minFilter=bi,G.map.depthTexture.magFilter=bi):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=Mn,G.map.depthTexture.magFilter=Mn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let ee=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();q.isPointLight!==!0&&G.updateMatrices(q,T);let Y=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let oe=0;oe<ee;oe++){let ue=G.getCamera(oe);if(q.isPointLight){let te=G.camera,_e=G.matrix,me=q.distance||te.far;me!==te.far&&(te.far=me,te.updateProjectionMatrix()),Sc.setFromMatrixPosition(q.matrixWorld),te.position.copy(Sc),ig.copy(te.position),ig.add(U3[oe]),te.up.copy(F3[oe]),te.lookAt(ig),te.updateMatrixWorld(),_e.makeTranslation(-Sc.x,-Sc.y,-Sc.z),Rb.multiplyMatrices(te.projectionMatrix,te.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Rb,te.coordinateSystem,te.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,oe),n.clear();else{oe===0&&(n.setRenderTarget(G.map),n.clear());let te=G.getViewport(oe);o.set(r.x*te.x,r.y*te.y,r.x*te.z,r.y*te.w),H.viewport(o)}i=G.getFrustum(oe),M(y,T,ue,q,Y,this.type)}G.isPointLightShadow!==!0&&this.type===Va&&b(G,T),G.needsUpdate=!1}_=this.type,g.needsUpdate=!1,n.setRenderTarget(k,D,L)};function b(C,y){let T=e.update(v);h.defines.VSM_SAMPLES!==C.blurSamples&&(h.defines.VSM_SAMPLES=C.blurSamples,f.defines.VSM_SAMPLES=C.blurSamples,h.needsUpdate=!0,f.needsUpdate=!0),C.mapPass===null?C.mapPass=new $i(s.x,s.y,{format:no,type:Ms}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),h.uniforms.shadow_pass.value=C.map.depthTexture,h.uniforms.resolution.value.set(C.map.width,C.map.height),h.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(y,null,T,h,v,null),f.uniforms.shadow_pass.value=C.mapPass.texture,f.uniforms.resolution.value.set(C.map.width,C.map.height),f.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(y,null,T,f,v,null)}function E(C,y,T,k){let D=null,L=T.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(L!==void 0)D=L;else if(D=T.isPointLight===!0?l:a,n.localClippingEnabled&&y.clipShadows===!0&&Array.isArray(y.clippingPlanes)&&y.clippingPlanes.length!==0||y.displacementMap&&y.displacementScale!==0||y.alphaMap&&y.alphaTest>0||y.map&&y.alphaTest>0||y.alphaToCoverage===!0){let H=D.uuid,V=y.uuid,O=c[H];O===void 0&&(O={},c[H]=O);let $=O[V];$===void 0&&($=D.clone(),O[V]=$,y.addEventListener("dispose",I)),D=$}if(D.visible=y.visible,D.wireframe=y.wireframe,k===Va?D.side=y.shadowSide!==null?y.shadowSide:y.side:D.side=y.shadowSide!==null?y.shadowSide:d[y.side],D.alphaMap=y.alphaMap,D.alphaTest=y.alphaToCoverage===!0?.5:y.alphaTest,D.map=y.map,D.clipShadows=y.clipShadows,D.clippingPlanes=y.clippingPlanes,D.clipIntersection=y.clipIntersection,D.displacementMap=y.displacementMap,D.displacementScale=y.displacementScale,D.displacementBias=y.displacementBias,D.wireframeLinewidth=y.wireframeLinewidth,D.linewidth=y.linewidth,T.isPointLight===!0&&D.isMeshDistanceMaterial===!0){let H=n.properties.get(D);H.light=T}return D}function M(C,y,T,k,D,L){if(C.visible===!1)return;if(C.layers.test(D)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&L===Va)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,C.matrixWorld);let O=e.update(C),$=C.material;if(Array.isArray($)){let q=O.groups;for(let G=0,ce=q.length;G<ce;G++){let K=q[G],ee=$[K.materialIndex];if(ee&&ee.visible){let Y=E(C,ee,k,L);C.onBeforeShadow(n,C,y,T,O,Y,K),n.renderBufferDirect(T,null,O,Y,C,K),C.onAfterShadow(n,C,y,T,O,Y,K)}}}else if($.visible){let q=E(C,$,k,L);C.onBeforeShadow(n,C,y,T,O,q,null),n.renderBufferDirect(T,null,O,q,C,null),C.onAfterShadow(n,C,y,T,O,q,null)}}let V=C.children;for(let O=0,$=V.length;O<$;O++)M(V[O],y,T,k,D,L)}function I(C){C.target.removeEventListener("dispose",I);for(let T in c){let k=c[T],D=C.target.uuid;D in k&&(k[D].dispose(),delete k[D])}}}function B3(n,e){function t(){let F=!1,re=new zt,ie=null,Ce=new zt(0,0,0,0);return{setMask:function(xe){ie!==xe&&!F&&(n.colorMask(xe,xe,xe,xe),ie=xe)},setLocked:function(xe){F=xe},setClear:function(xe,Te,Xe,nt,he){he===!0&&(xe*=nt,Te*=nt,Xe*=nt),re.set(xe,Te,Xe,nt),Ce.equals(re)===!1&&(n.clearColor(xe,Te,Xe,nt),Ce.copy(re))},reset:function(){F=!1,ie=null,Ce.set(-1,0,0,0)}}}function i(){let F=!1,re=!1,ie=null,Ce=null,xe=null;return{setReversed:function(Te){if(re!==Te){let Xe=e.get("EXT_clip_control");Te?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),re=Te;let nt=xe;xe=null,this.setClear(nt)}},getReversed:function(){return re},setTest:function(Te){Te?be(n.DEPTH_TEST):qe(n.DEPTH_TEST)},setMask:function(Te){ie!==Te&&!F&&(n.depthMask(Te),ie=Te)},setFunc:function(Te){if(re&&(Te=rb[Te]),Ce!==Te){switch(Te){case dh:n.depthFunc(n.NEVER);break;case fh:n.depthFunc(n.ALWAYS);break;case ph:n.depthFunc(n.LESS);break;case Fs:n.depthFunc(n.LEQUAL);break;case mh:n.depthFunc(n.EQUAL);break;case gh:n.depthFunc(n.GEQUAL);break;case _h:n.depthFunc(n.GREATER);break;case yh:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ce=Te}},setLocked:function(Te){F=Te},setClear:function(Te){xe!==Te&&(xe=Te,re&&(Te=1-Te),n.clearDepth(Te))},reset:function(){F=!1,ie=null,Ce=null,xe=null,re=!1}}}function s(){let F=!1,re=null,ie=null,Ce=null,xe=null,Te=null,Xe=null,nt=null,he=null;return{setTest:function(He){F||(He?be(n.STENCIL_TEST):qe(n.STENCIL_TEST))},setMask:function(He){re!==He&&!F&&(n.stencilMask(He),re=He)},setFunc:function(He,it,Ie){(ie!==He||Ce!==it||xe!==Ie)&&(n.stencilFunc(He,it,Ie),ie=He,Ce=it,xe=Ie)},setOp:function(He,it,Ie){(Te!==He||Xe!==it||nt!==Ie)&&(n.stencilOp(He,it,Ie),Te=He,Xe=it,nt=Ie)},setLocked:function(He){F=He},setClear:function(He){he!==He&&(n.clearStencil(He),he=He)},reset:function(){F=!1,re=null,ie=null,Ce=null,xe=null,Te=null,Xe=null,nt=null,he=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},d={},h={},f=new WeakMap,p=[],v=null,g=!1,_=null,b=null,E=null,M=null,I=null,C=null,y=null,T=new dt(0,0,0),k=0,D=!1,L=null,H=null,V=null,O=null,$=null,q=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ce=0,K=n.getParameter(n.VERSION);K.indexOf("WebGL")!==-1?(ce=parseFloat(/^WebGL (\d)/.exec(K)[1]),G=ce>=1):K.indexOf("OpenGL ES")!==-1&&(ce=parseFloat(/^OpenGL ES (\d)/.exec(K)[1]),G=ce>=2);let ee=null,Y={},oe=n.getParameter(n.SCISSOR_BOX),ue=n.getParameter(n.VIEWPORT),te=new zt().fromArray(oe),_e=new zt().fromArray(ue);function me(F,re,ie,Ce){let xe=new Uint8Array(4),Te=n.createTexture();n.bindTexture(F,Te),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ie;Xe++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Ce,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(re+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return Te}let Ae={};Ae[n.TEXTURE_2D]=me(n.TEXTURE_2D,n.TEXTURE_2D,1),Ae[n.TEXTURE_CUBE_MAP]=me(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Ae[n.TEXTURE_2D_ARRAY]=me(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Ae[n.TEXTURE_3D]=me(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),be(n.DEPTH_TEST),o.setFunc(Fs),dn(!1),Dt(Mm),be(n.CULL_FACE),Vt(Ro);function be(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function qe(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function tt(F,re){return h[F]!==re?(n.bindFramebuffer(F,re),h[F]=re,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function Be(F,re){let ie=p,Ce=!1;if(F){ie=f.get(re),ie===void 0&&(ie=[],f.set(re,ie));let xe=F.textures;if(ie.length!==xe.length||ie[0]!==n.COLOR_ATTACHMENT0){for(let Te=0,Xe=xe.length;Te<Xe;Te++)ie[Te]=n.COLOR_ATTACHMENT0+Te;ie.length=xe.length,Ce=!0}}else ie[0]!==n.BACK&&(ie[0]=n.BACK,Ce=!0);Ce&&n.drawBuffers(ie)}function ot(F){return v!==F?(n.useProgram(F),v=F,!0):!1}let ut={[Po]:n.FUNC_ADD,[Cv]:n.FUNC_SUBTRACT,[Rv]:n.FUNC_REVERSE_SUBTRACT};ut[Pv]=n.MIN,ut[Iv]=n.MAX;let Je={[Lv]:n.ZERO,[Dv]:n.ONE,[Nv]:n.SRC_COLOR,[Em]:n.SRC_ALPHA,[zv]:n.SRC_ALPHA_SATURATE,[kv]:n.DST_COLOR,[Uv]:n.DST_ALPHA,[Ov]:n.ONE_MINUS_SRC_COLOR,[Cm]:n.ONE_MINUS_SRC_ALPHA,[Bv]:n.ONE_MINUS_DST_COLOR,[Fv]:n.ONE_MINUS_DST_ALPHA,[Vv]:n.CONSTANT_COLOR,[Hv]:n.ONE_MINUS_CONSTANT_COLOR,[Gv]:n.CONSTANT_ALPHA,[Wv]:n.ONE_MINUS_CONSTANT_ALPHA};function Vt(F,re,ie,Ce,xe,Te,Xe,nt,he,He){if(F===Ro){g===!0&&(qe(n.BLEND),g=!1);return}if(g===!1&&(be(n.BLEND),g=!0),F!==Ev){if(F!==_||He!==D){if((b!==Po||I!==Po)&&(n.blendEquation(n.FUNC_ADD),b=Po,I=Po),He)switch(F){case Ha:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case wm:n.blendFunc(n.ONE,n.ONE);break;case Am:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Tm:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:rt("WebGLState: Invalid blending: ",F);break}else switch(F){case Ha:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case wm:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Am:rt("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Tm:rt("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:rt("WebGLState: Invalid blending: ",F);break}E=null,M=null,C=null,y=null,T.set(0,0,0),k=0,_=F,D=He}return}xe=xe||re,Te=Te||ie,Xe=Xe||Ce,(re!==b||xe!==I)&&(n.blendEquationSeparate(ut[re],ut[xe]),b=re,I=xe),(ie!==E||Ce!==M||Te!==C||Xe!==y)&&(n.blendFuncSeparate(Je[ie],Je[Ce],Je[Te],Je[Xe]),E=ie,M=Ce,C=Te,y=Xe),(nt.equals(T)===!1||he!==k)&&(n.blendColor(nt.r,nt.g,nt.b,he),T.copy(nt),k=he),_=F,D=!1}function qt(F,re){F.side===ei?qe(n.CULL_FACE):be(n.CULL_FACE);let ie=F.side===Si;re&&(ie=!ie),dn(ie),F.blending===Ha&&F.transparent===!1?Vt(Ro):Vt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Ce=F.stencilWrite;a.setTest(Ce),Ce&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),At(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?be(n.SAMPLE_ALPHA_TO_COVERAGE):qe(n.SAMPLE_ALPHA_TO_COVERAGE)}function dn(F){L!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),L=F)}function Dt(F){F!==wv?(be(n.CULL_FACE),F!==H&&(F===Mm?n.cullFace(n.BACK):F===Av?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):qe(n.CULL_FACE),H=F}function Nn(F){F!==V&&(G&&n.lineWidth(F),V=F)}function At(F,re,ie){F?(be(n.POLYGON_OFFSET_FILL),(O!==re||$!==ie)&&(O=re,$=ie,o.getReversed()&&(re=-re,ie=-ie),n.polygonOffset(re,ie))):qe(n.POLYGON_OFFSET_FILL)}function un(F){F?be(n.SCISSOR_TEST):qe(n.SCISSOR_TEST)}function tn(F){F===void 0&&(F=n.TEXTURE0+q-1),ee!==F&&(n.activeTexture(F),ee=F)}function fn(F,re,ie){ie===void 0&&(ee===null?ie=n.TEXTURE0+q-1:ie=ee);let Ce=Y[ie];Ce===void 0&&(Ce={type:void 0,texture:void 0},Y[ie]=Ce),(Ce.type!==F||Ce.texture!==re)&&(ee!==ie&&(n.activeTexture(ie),ee=ie),n.bindTexture(F,re||Ae[F]),Ce.type=F,Ce.texture=re)}function U(){let F=Y[ee];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ee(){try{n.compressedTexImage2D(...arguments)}catch(F){rt("WebGLState:",F)}}function Ke(){try{n.compressedTexImage3D(...arguments)}catch(F){rt("WebGLState:",F)}}function at(){try{n.texSubImage2D(...arguments)}catch(F){rt("WebGLState:",F)}}function we(){try{n.texSubImage3D(...arguments)}catch(F){rt("WebGLState:",F)}}function Nt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){rt("WebGLState:",F)}}function ze(){try{n.compressedTexSubImage3D(...arguments)}catch(F){rt("WebGLState:",F)}}function ye(){try{n.texStorage2D(...arguments)}catch(F){rt("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){rt("WebGLState:",F)}}function S(){try{n.texImage2D(...arguments)}catch(F){rt("WebGLState:",F)}}function X(){try{n.texImage3D(...arguments)}catch(F){rt("WebGLState:",F)}}function de(F){return d[F]!==void 0?d[F]:n.getParameter(F)}function ae(F,re){d[F]!==re&&(n.pixelStorei(F,re),d[F]=re)}function ve(F){te.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),te.copy(F))}function Se(F){_e.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),_e.copy(F))}function ne(F,re){let ie=c.get(re);ie===void 0&&(ie=new WeakMap,c.set(re,ie));let Ce=ie.get(F);Ce===void 0&&(Ce=n.getUniformBlockIndex(re,F.name),n.uniformBlockBinding(re,Ce,Ce),ie.set(F,Ce))}function se(F,re,ie){let xe=c.get(re).get(F);l[xe]!==ie&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ie),l[xe]=ie)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},d={},ee=null,Y={},h={},l={},f=new WeakMap,p=[],v=null,g=!1,_=null,b=null,E=null,M=null,I=null,C=null,y=null,T=new dt(0,0,0),k=0,D=!1,L=null,H=null,V=null,O=null,$=null,te.set(0,0,n.canvas.width,n.canvas.height),_e.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:be,disable:qe,bindFramebuffer:tt,drawBuffers:Be,useProgram:ot,setBlending:Vt,setMaterial:qt,setFlipSided:dn,setCullFace:Dt,setLineWidth:Nn,setPolygonOffset:At,setScissorTest:un,activeTexture:tn,bindTexture:fn,unbindTexture:U,compressedTexImage2D:Ee,compressedTexImage3D:Ke,texImage2D:S,texImage3D:X,pixelStorei:ae,getParameter:de,updateUBOMapping:ne,uniformBlockBinding:se,texStorage2D:ye,texStorage3D:R,texSubImage2D:at,texSubImage3D:we,compressedTexSubImage2D:Nt,compressedTexSubImage3D:ze,scissor:ve,viewport:Se,reset:ge}}function z3(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new je,u=new WeakMap,d=new Set,h,f=new WeakMap,p=new Set,v=new FinalizationRegistry(R=>p.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function _(R,S){return g?new OffscreenCanvas(R,S):Wl("canvas")}function b(R,S,X){let de=1,ae=ye(R);if((ae.width>X||ae.height>X)&&(de=X/Math.max(ae.width,ae.height)),de<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ve=Math.floor(de*ae.width),Se=Math.floor(de*ae.height);h===void 0&&(h=_(ve,Se));let ne=S?_(ve,Se):h;return ne.width=ve,ne.height=Se,ne.getContext("2d").drawImage(R,0,0,ve,Se),Ze("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ve+"x"+Se+")."),ne}else return"data"in R&&Ze("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function E(R){return R.generateMipmaps}function M(R){n.generateMipmap(R)}function I(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,S,X,de,ae,ve=!1){if(R!==null){if(n[R]!==void 0)return n[R];Ze("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let Se;de&&(Se=e.get("EXT_texture_norm16"),Se||Ze("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let ne=S;if(S===n.RED&&(X===n.FLOAT&&(ne=n.R32F),X===n.HALF_FLOAT&&(ne=n.R16F),X===n.UNSIGNED_BYTE&&(ne=n.R8),X===n.UNSIGNED_SHORT&&Se&&(ne=Se.R16_EXT),X===n.SHORT&&Se&&(ne=Se.R16_SNORM_EXT)),S===n.RED_INTEGER&&(X===n.UNSIGNED_BYTE&&(ne=n.R8UI),X===n.UNSIGNED_SHORT&&(ne=n.R16UI),X===n.UNSIGNED_INT&&(ne=n.R32UI),X===n.BYTE&&(ne=n.R8I),X===n.SHORT&&(ne=n.R16I),X===n.INT&&(ne=n.R32I)),S===n.RG&&(X===n.FLOAT&&(ne=n.RG32F),X===n.HALF_FLOAT&&(ne=n.RG16F),X===n.UNSIGNED_BYTE&&(ne=n.RG8),X===n.UNSIGNED_SHORT&&Se&&(ne=Se.RG16_EXT),X===n.SHORT&&Se&&(ne=Se.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(X===n.UNSIGNED_BYTE&&(ne=n.RG8UI),X===n.UNSIGNED_SHORT&&(ne=n.RG16UI),X===n.UNSIGNED_INT&&(ne=n.RG32UI),X===n.BYTE&&(ne=n.RG8I),X===n.SHORT&&(ne=n.RG16I),X===n.INT&&(ne=n.RG32I)),S===n.RGB_INTEGER&&(X===n.UNSIGNED_BYTE&&(ne=n.RGB8UI),X===n.UNSIGNED_SHORT&&(ne=n.RGB16UI),X===n.UNSIGNED_INT&&(ne=n.RGB32UI),X===n.BYTE&&(ne=n.RGB8I),X===n.SHORT&&(ne=n.RGB16I),X===n.INT&&(ne=n.RGB32I)),S===n.RGBA_INTEGER&&(X===n.UNSIGNED_BYTE&&(ne=n.RGBA8UI),X===n.UNSIGNED_SHORT&&(ne=n.RGBA16UI),X===n.UNSIGNED_INT&&(ne=n.RGBA32UI),X===n.BYTE&&(ne=n.RGBA8I),X===n.SHORT&&(ne=n.RGBA16I),X===n.INT&&(ne=n.RGBA32I)),S===n.RGB&&(X===n.UNSIGNED_SHORT&&Se&&(ne=Se.RGB16_EXT),X===n.SHORT&&Se&&(ne=Se.RGB16_SNORM_EXT),X===n.UNSIGNED_INT_5_9_9_9_REV&&(ne=n.RGB9_E5),X===n.UNSIGNED_INT_10F_11F_11F_REV&&(ne=n.R11F_G11F_B10F)),S===n.RGBA){let se=ve?Gl:wt.getTransfer(ae);X===n.FLOAT&&(ne=n.RGBA32F),X===n.HALF_FLOAT&&(ne=n.RGBA16F),X===n.UNSIGNED_BYTE&&(ne=se===Bt?n.SRGB8_ALPHA8:n.RGBA8),X===n.UNSIGNED_SHORT&&Se&&(ne=Se.RGBA16_EXT),X===n.SHORT&&Se&&(ne=Se.RGBA16_SNORM_EXT),X===n.UNSIGNED_SHORT_4_4_4_4&&(ne=n.RGBA4),X===n.UNSIGNED_SHORT_5_5_5_1&&(ne=n.RGB5_A1)}return(ne===n.R16F||ne===n.R32F||ne===n.RG16F||ne===n.RG32F||ne===n.RGBA16F||ne===n.RGBA32F)&&e.get("EXT_color_buffer_float"),ne}function y(R,S){let X;return R?S===null||S===Ss||S===Lo?X=n.DEPTH24_STENCIL8:S===ss?X=n.DEPTH32F_STENCIL8:S===Wa&&(X=n.DEPTH24_STENCIL8,Ze("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Ss||S===Lo?X=n.DEPTH_COMPONENT24:S===ss?X=n.DEPTH_COMPONENT32F:S===Wa&&(X=n.DEPTH_COMPONENT16),X}function T(R,S){return E(R)===!0||R.isFramebufferTexture&&R.minFilter!==Mn&&R.minFilter!==bi?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function k(R){let S=new WeakRef(R);i.get(R).__ref=S,p.add(S),v.register(R,S,S)}function D(R){let S=i.get(R).__ref;S!==void 0&&(p.delete(S),v.unregister(S))}function L(R){V(R.target)}function H(R){O(R.target)}function V(R){R.removeEventListener("dispose",L),D(R),q(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&d.delete(R)}function O(R){R.removeEventListener("dispose",H),D(R),ce(R)}function $(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?O(S):V(S))}p.clear(),d.clear()}function q(R){let S=i.get(R);if(S.__webglInit===void 0)return;let X=R.source,de=f.get(X);if(de){let ae=de[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(R),Object.keys(de).length===0&&f.delete(X)}i.remove(R)}function G(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let X=R.source,de=f.get(X);delete de[S.__cacheKey],o.memory.textures--}function ce(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let X=R.depthTexture;if(X&&X.renderTarget===R&&V(X),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let ve=0;ve<S.__webglFramebuffer[ae].length;ve++)n.deleteFramebuffer(S.__webglFramebuffer[ae][ve]);else n.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)n.deleteFramebuffer(S.__webglFramebuffer[ae]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let de=R.textures;for(let ae=0,ve=de.length;ae<ve;ae++){let Se=i.get(de[ae]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(de[ae])}i.remove(R)}let K=0;function ee(){K=0}function Y(){return K}function oe(R){K=R}function ue(){let R=K;return R>=s.maxTextures&&Ze("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),K+=1,R}function te(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function _e(R,S){let X=i.get(R);if(R.isVideoTexture&&Nt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&X.__version!==R.version){let de=R.image;if(de===null)Ze("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)Ze("WebGLRenderer: Texture marked for update but image is incomplete");else{qt(X,R,S);return}}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,X.__webglTexture,n.TEXTURE0+S)}function me(R,S){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){qt(X,R,S);return}else R.isExternalTexture&&(X.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,X.__webglTexture,n.TEXTURE0+S)}function Ae(R,S){let X=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&X.__version!==R.version){qt(X,R,S);return}t.bindTexture(n.TEXTURE_3D,X.__webglTexture,n.TEXTURE0+S)}function be(R,S){let X=i.get(R);if(R.version>0&&X.__version!==R.version){dn(X,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,X.__webglTexture,n.TEXTURE0+S)}let qe={[xh]:n.REPEAT,[Us]:n.CLAMP_TO_EDGE,[vh]:n.MIRRORED_REPEAT},tt={[Mn]:n.NEAREST,[qv]:n.NEAREST_MIPMAP_NEAREST,[fc]:n.NEAREST_MIPMAP_LINEAR,[bi]:n.LINEAR,[Yh]:n.LINEAR_MIPMAP_NEAREST,[mr]:n.LINEAR_MIPMAP_LINEAR},Be={[Zv]:n.NEVER,[$m]:n.ALWAYS,[jv]:n.LESS,[Gm]:n.LEQUAL,[Qv]:n.EQUAL,[Wm]:n.GEQUAL,[eb]:n.GREATER,[tb]:n.NOTEQUAL};function ot(R,S){if(S.type===ss&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===bi||S.magFilter===Yh||S.magFilter===fc||S.magFilter===mr||S.minFilter===bi||S.minFilter===Yh||S.minFilter===fc||S.minFilter===mr)&&Ze("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,qe[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,qe[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,qe[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,tt[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,tt[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Be[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===Mn||S.minFilter!==fc&&S.minFilter!==mr||S.type===ss&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let X=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,X.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ut(R,S){let X=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",L),k(S));let de=S.source,ae=f.get(de);ae===void 0&&(ae={},f.set(de,ae));let ve=te(S);if(ve!==R.__cacheKey){ae[ve]===void 0&&(ae[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,X=!0),ae[ve].usedTimes++;let Se=ae[R.__cacheKey];Se!==void 0&&(ae[R.__cacheKey].usedTimes--,Se.usedTimes===0&&G(S)),R.__cacheKey=ve,R.__webglTexture=ae[ve].texture}return X}function Je(R,S,X){return Math.floor(Math.floor(R/X)/S)}function Vt(R,S,X,de){let ve=R.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,X,de,S.data);else{ve.sort((F,re)=>F.start-re.start);let Se=0;for(let F=1;F<ve.length;F++){let re=ve[Se],ie=ve[F],Ce=re.start+re.count,xe=Je(ie.start,S.width,4),Te=Je(re.start,S.width,4);ie.start<=Ce+1&&xe===Te&&Je(ie.start+ie.count-1,S.width,4)===xe?re.count=Math.max(re.count,ie.start+ie.count-re.start):(++Se,ve[Se]=ie)}ve.length=Se+1;let ne=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let F=0,re=ve.length;F<re;F++){let ie=ve[F],Ce=Math.floor(ie.start/4),xe=Math.ceil(ie.count/4),Te=Ce%S.width,Xe=Math.floor(Ce/S.width),nt=xe,he=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Te),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,Te,Xe,nt,he,X,de,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,ne),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function qt(R,S,X){let de=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(de=n.TEXTURE_3D);let ae=ut(R,S),ve=S.source;t.bindTexture(de,R.__webglTexture,n.TEXTURE0+X);let Se=i.get(ve);if(ve.version!==Se.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+X),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=wt.getPrimaries(wt.workingColorSpace),He=S.colorSpace===_r?null:wt.getPrimaries(S.colorSpace),it=S.colorSpace===_r||he===He?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,it)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let se=b(S.image,!1,s.maxTextureSize);se=ze(S,se);let ge=r.convert(S.format,S.colorSpace),F=r.convert(S.type),re=C(S.internalFormat,ge,F,S.normalized,S.colorSpace,S.isVideoTexture);ot(de,S);let ie,Ce=S.mipmaps,xe=S.isVideoTexture!==!0,Te=Se.__version===void 0||ae===!0,Xe=ve.dataReady,nt=T(S,se);if(S.isDepthTexture)re=y(S.format===gr,S.type),Te&&(xe?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,ge,F,null));else if(S.isDataTexture)if(Ce.length>0){xe&&Te&&t.texStorage2D(n.TEXTURE_2D,nt,re,Ce[0].width,Ce[0].height);for(let he=0,He=Ce.length;he<He;he++)ie=Ce[he],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ie.width,ie.height,ge,F,ie.data):t.texImage2D(n.TEXTURE_2D,he,re,ie.width,ie.height,0,ge,F,ie.data);S.generateMipmaps=!1}else xe?(Te&&t.texStorage2D(n.TEXTURE_2D,nt,re,se.width,se.height),Xe&&Vt(S,se,ge,F)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,ge,F,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xe&&Te&&t.texStorage3D(n.TEXTURE_2D_ARRAY,nt,re,Ce[0].width,Ce[0].height,se.depth);for(let he=0,He=Ce.length;he<He;he++)if(ie=Ce[he],S.format!==Ji)if(ge!==null)if(xe){if(Xe)if(S.layerUpdates.size>0){let it=tg(ie.width,ie.height,S.format,S.type);for(let Ie of S.layerUpdates){let mt=ie.data.subarray(Ie*it/ie.data.BYTES_PER_ELEMENT,(Ie+1)*it/ie.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,Ie,ie.width,ie.height,1,ge,mt)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,ge,ie.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,se.depth,0,ie.data,0,0);else Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ie.width,ie.height,se.depth,ge,F,ie.data):t.texImage3D(n.TEXTURE_2D_ARRAY,he,re,ie.width,ie.height,se.depth,0,ge,F,ie.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xe&&Te&&t.texStorage2D(n.TEXTURE_2D,nt,re,Ce[0].width,Ce[0].height);for(let he=0,He=Ce.length;he<He;he++)ie=Ce[he],S.format!==Ji?ge!==null?xe?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,he,0,0,ie.width,ie.height,ge,ie.data):t.compressedTexImage2D(n.TEXTURE_2D,he,re,ie.width,ie.height,0,ie.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ie.width,ie.height,ge,F,ie.data):t.texImage2D(n.TEXTURE_2D,he,re,ie.width,ie.height,0,ge,F,ie.data)}else if(S.isDataArrayTexture)if(xe){if(Te&&t.texStorage3D(n.TEXTURE_2D_ARRAY,nt,re,se.width,se.height,se.depth),Xe)if(S.layerUpdates.size>0){let he=tg(se.width,se.height,S.format,S.type);for(let He of S.layerUpdates){let it=se.data.subarray(He*he/se.data.BYTES_PER_ELEMENT,(He+1)*he/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,He,se.width,se.height,1,ge,F,it)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,ge,F,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,ge,F,se.data);else if(S.isData3DTexture)xe?(Te&&t.texStorage3D(n.TEXTURE_3D,nt,re,se.width,se.height,se.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,ge,F,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,ge,F,se.data);else if(S.isFramebufferTexture){if(Te)if(xe)t.texStorage2D(n.TEXTURE_2D,nt,re,se.width,se.height);else{let he=se.width,He=se.height;for(let it=0;it<nt;it++)t.texImage2D(n.TEXTURE_2D,it,re,he,He,0,ge,F,null),he>>=1,He>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let he=n.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),se.parentNode!==he){he.appendChild(se),d.add(S),he.onpaint=He=>{let it=He.changedElements;for(let Ie of d)it.includes(Ie.image)&&(Ie.needsUpdate=!0)},he.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let it=n.RGBA,Ie=n.RGBA,mt=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,it,Ie,mt,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ce.length>0){if(xe&&Te){let he=ye(Ce[0]);t.texStorage2D(n.TEXTURE_2D,nt,re,he.width,he.height)}for(let he=0,He=Ce.length;he<He;he++)ie=Ce[he],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ge,F,ie):t.texImage2D(n.TEXTURE_2D,he,re,ge,F,ie);S.generateMipmaps=!1}else if(xe){if(Te){let he=ye(se);t.texStorage2D(n.TEXTURE_2D,nt,re,he.width,he.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,F,se)}else t.texImage2D(n.TEXTURE_2D,0,re,ge,F,se);E(S)&&S.mipmapsAutoUpdate===!0&&M(de),Se.__version=ve.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function dn(R,S,X){if(S.image.length!==6)return;let de=ut(R,S),ae=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+X);let ve=i.get(ae);if(ae.version!==ve.__version||de===!0){t.activeTexture(n.TEXTURE0+X);let Se=wt.getPrimaries(wt.workingColorSpace),ne=S.colorSpace===_r?null:wt.getPrimaries(S.colorSpace),se=S.colorSpace===_r||Se===ne?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let ge=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Ie=0;Ie<6;Ie++)!ge&&!F?re[Ie]=b(S.image[Ie],!0,s.maxCubemapSize):re[Ie]=F?S.image[Ie].image:S.image[Ie],re[Ie]=ze(S,re[Ie]);let ie=re[0],Ce=r.convert(S.format,S.colorSpace),xe=r.convert(S.type),Te=C(S.internalFormat,Ce,xe,S.normalized,S.colorSpace),Xe=S.isVideoTexture!==!0,nt=ve.__version===void 0||de===!0,he=ae.dataReady,He=T(S,ie);ot(n.TEXTURE_CUBE_MAP,S);let it;if(S.isDepthTexture){if(Te=y(S.format===gr,S.type),nt)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Te,ie.width,ie.height);else for(let Ie=0;Ie<6;Ie++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Te,ie.width,ie.height,0,Ce,xe,null)}else if(ge){Xe&&nt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,He,Te,ie.width,ie.height);for(let Ie=0;Ie<6;Ie++){it=re[Ie].mipmaps;for(let mt=0;mt<it.length;mt++){let nn=it[mt];S.format!==Ji?Ce!==null?Xe?he&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt,0,0,nn.width,nn.height,Ce,nn.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt,Te,nn.width,nn.height,0,nn.data):Ze("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt,0,0,nn.width,nn.height,Ce,xe,nn.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt,Te,nn.width,nn.height,0,Ce,xe,nn.data)}}}else{if(it=S.mipmaps,Xe&&nt){it.length>0&&He++;let Ie=ye(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,He,Te,Ie.width,Ie.height)}for(let Ie=0;Ie<6;Ie++)if(F){Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,re[Ie].width,re[Ie].height,Ce,xe,re[Ie].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Te,re[Ie].width,re[Ie].height,0,Ce,xe,re[Ie].data);for(let mt=0;mt<it.length;mt++){let ci=it[mt].image[Ie].image;Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt+1,0,0,ci.width,ci.height,Ce,xe,ci.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt+1,Te,ci.width,ci.height,0,Ce,xe,ci.data)}}else{Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,0,0,Ce,xe,re[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,0,Te,Ce,xe,re[Ie]);for(let mt=0;mt<it.length;mt++){let nn=it[mt];Xe?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt+1,0,0,Ce,xe,nn.image[Ie]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ie,mt+1,Te,Ce,xe,nn.image[Ie])}}}E(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),ve.__version=ae.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Dt(R,S,X,de,ae,ve){let Se=r.convert(X.format,X.colorSpace),ne=r.convert(X.type),se=C(X.internalFormat,Se,ne,X.normalized,X.colorSpace),ge=i.get(S),F=i.get(X);if(F.__renderTarget=S,!ge.__hasExternalTextures){let re=Math.max(1,S.width>>ve),ie=Math.max(1,S.height>>ve);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,ve,se,re,ie,S.depth,0,Se,ne,null):t.texImage2D(ae,ve,se,re,ie,0,Se,ne,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,ae,F.__webglTexture,0,at(S)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,ae,F.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Nn(R,S,X){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let de=S.depthTexture,ae=de&&de.isDepthTexture?de.type:null,ve=y(S.stencilBuffer,ae),Se=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(S),ve,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(S),ve,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ve,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,R)}else{let de=S.textures;for(let ae=0;ae<de.length;ae++){let ve=de[ae],Se=r.convert(ve.format,ve.colorSpace),ne=r.convert(ve.type),se=C(ve.internalFormat,Se,ne,ve.normalized,ve.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(S),se,S.width,S.height):X?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(S),se,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,se,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function At(R,S,X){let de=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(S.depthTexture);ae.__renderTarget=S;let ve=de?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||ve.width!==S.width||ve.height!==S.height)&&(ve.width=S.width,ve.height=S.height,S.depthTexture.needsUpdate=!0),de?be(S.depthTexture,0):_e(S.depthTexture,0);let Se=ae.__webglTexture,ne=at(S),se=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+X:n.TEXTURE_2D,ge=S.depthTexture.format===gr?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===hr)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,se,Se,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,ge,se,Se,0);else if(S.depthTexture.format===gr)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,se,Se,0,ne):n.framebufferTexture2D(n.FRAMEBUFFER,ge,se,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function un(R){let S=i.get(R),X=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let de=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),de){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,de.removeEventListener("dispose",ae)};de.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=de}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(X)for(let de=0;de<6;de++)At(S.__webglFramebuffer[de],R,de);else R.texture.mipmaps.length>0?At(S.__webglFramebuffer[0],R,0):At(S.__webglFramebuffer,R,0);else if(X){S.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[de]),S.__webglDepthbuffer[de]===void 0)S.__webglDepthbuffer[de]=n.createRenderbuffer(),Nn(S.__webglDepthbuffer[de],R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Nn(S.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function tn(R,S,X){let de=i.get(R);S!==void 0&&Dt(de.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),X!==void 0&&un(R)}function fn(R){let S=R.texture,X=i.get(R),de=i.get(S);R.addEventListener("dispose",H),k(R);let ae=R.textures,ve=R.isWebGLCubeRenderTarget===!0,Se=ae.length>1;if(Se||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=S.version,o.memory.textures++),ve){X.__webglFramebuffer=[];for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0){X.__webglFramebuffer[ne]=[];for(let se=0;se<S.mipmaps.length;se++)X.__webglFramebuffer[ne][se]=n.createFramebuffer()}else X.__webglFramebuffer[ne]=n.createFramebuffer()}else{if(S.mipmaps.length>0){X.__webglFramebuffer=[];for(let ne=0;ne<S.mipmaps.length;ne++)X.__webglFramebuffer[ne]=n.createFramebuffer()}else X.__webglFramebuffer=n.createFramebuffer();if(Se)for(let ne=0,se=ae.length;ne<se;ne++){let ge=i.get(ae[ne]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){X.__webglMultisampledFramebuffer=n.createFramebuffer(),X.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,X.__webglMultisampledFramebuffer);for(let ne=0;ne<ae.length;ne++){let se=ae[ne];X.__webglColorRenderbuffer[ne]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,X.__webglColorRenderbuffer[ne]);let ge=r.convert(se.format,se.colorSpace),F=r.convert(se.type),re=C(se.internalFormat,ge,F,se.normalized,se.colorSpace,R.isXRRenderTarget===!0),ie=at(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ie,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ne,n.RENDERBUFFER,X.__webglColorRenderbuffer[ne])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(X.__webglDepthRenderbuffer=n.createRenderbuffer(),Nn(X.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),ot(n.TEXTURE_CUBE_MAP,S);for(let ne=0;ne<6;ne++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Dt(X.__webglFramebuffer[ne][se],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,se);else Dt(X.__webglFramebuffer[ne],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+ne,0);E(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let ne=0,se=ae.length;ne<se;ne++){let ge=ae[ne],F=i.get(ge),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,F.__webglTexture),ot(re,ge),Dt(X.__webglFramebuffer,R,ge,n.COLOR_ATTACHMENT0+ne,re,0),E(ge)&&M(re)}t.unbindTexture()}else{let ne=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(ne=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(ne,de.__webglTexture),ot(ne,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Dt(X.__webglFramebuffer[se],R,S,n.COLOR_ATTACHMENT0,ne,se);else Dt(X.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,ne,0);E(S)?M(ne):S.mipmaps.length>0&&n.texParameteri(ne,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&un(R)}function U(R){let S=R.textures;for(let X=0,de=S.length;X<de;X++){let ae=S[X];if(E(ae)&&ae.mipmapsAutoUpdate===!0){let ve=I(R),Se=i.get(ae).__webglTexture;t.bindTexture(ve,Se),M(ve),t.unbindTexture()}}}let Ee=[];function Ke(R){if(R.samples>0){if(we(R)===!1){let S=R.textures,X=R.width,de=R.height,ae=n.COLOR_BUFFER_BIT,ve=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(R),ne=S.length>1;if(ne)for(let ge=0;ge<S.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let ge=0;ge<S.length;ge++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),ne){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[ge]);let F=i.get(S[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,X,de,0,0,X,de,ae,n.NEAREST),l===!0&&(Ee.length=0,Ee.push(n.COLOR_ATTACHMENT0+ge),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ee.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ee))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),ne)for(let ge=0;ge<S.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,Se.__webglColorRenderbuffer[ge]);let F=i.get(S[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function at(R){return Math.min(s.maxSamples,R.samples)}function we(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function Nt(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function ze(R,S){let X=R.colorSpace,de=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||X!==Hl&&X!==_r&&(wt.getTransfer(X)===Bt?(de!==Ji||ae!==Ii)&&Ze("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):rt("WebGLTextures: Unsupported texture color space:",X)),S}function ye(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=ue,this.resetTextureUnits=ee,this.getTextureUnits=Y,this.setTextureUnits=oe,this.setTexture2D=_e,this.setTexture2DArray=me,this.setTexture3D=Ae,this.setTextureCube=be,this.rebindTextures=tn,this.setupRenderTarget=fn,this.updateRenderTargetMipmap=U,this.updateMultisampleRenderTarget=Ke,this.setupDepthRenderbuffer=un,this.setupFrameBufferTexture=Dt,this.useMultisampledRTT=we,this.dispose=$}function V3(n,e){function t(i,s=_r){let r,o=wt.getTransfer(s);if(i===Ii)return n.UNSIGNED_BYTE;if(i===Kh)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Zh)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Bm)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===zm)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===Fm)return n.BYTE;if(i===km)return n.SHORT;if(i===Wa)return n.UNSIGNED_SHORT;if(i===Jh)return n.INT;if(i===Ss)return n.UNSIGNED_INT;if(i===ss)return n.FLOAT;if(i===Ms)return n.HALF_FLOAT;if(i===Vm)return n.ALPHA;if(i===Hm)return n.RGB;if(i===Ji)return n.RGBA;if(i===hr)return n.DEPTH_COMPONENT;if(i===gr)return n.DEPTH_STENCIL;if(i===jh)return n.RED;if(i===Qh)return n.RED_INTEGER;if(i===no)return n.RG;if(i===ed)return n.RG_INTEGER;if(i===td)return n.RGBA_INTEGER;if(i===pc||i===mc||i===gc||i===_c)if(o===Bt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===pc)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===mc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===gc)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===_c)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===pc)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===mc)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===gc)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===_c)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===nd||i===id||i===sd||i===rd)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===nd)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===id)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===sd)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===rd)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===od||i===ad||i===ld||i===cd||i===ud||i===yc||i===hd)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===od||i===ad)return o===Bt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===ld)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===cd)return r.COMPRESSED_R11_EAC;if(i===ud)return r.COMPRESSED_SIGNED_R11_EAC;if(i===yc)return r.COMPRESSED_RG11_EAC;if(i===hd)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===dd||i===fd||i===pd||i===md||i===gd||i===_d||i===yd||i===xd||i===vd||i===bd||i===Sd||i===Md||i===wd||i===Ad)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===dd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===fd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===pd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===md)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===gd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===_d)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===yd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===xd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===vd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===bd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===Sd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===Md)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===wd)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===Ad)return o===Bt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===Td||i===Ed||i===Cd)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===Td)return o===Bt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===Ed)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===Cd)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Rd||i===Pd||i===xc||i===Id)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Rd)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Pd)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===xc)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===Id)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Lo?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var H3=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,G3=`
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

}`,ug=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new ec(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new is({vertexShader:H3,fragmentShader:G3,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Dn(new tc(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},hg=class extends vs{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,d=null,h=null,f=null,p=null,v=typeof XRWebGLBinding<"u",g=new ug,_={},b=t.getContextAttributes(),E=null,M=null,I=[],C=[],y=new je,T=null,k=null,D=new vi;D.viewport=new zt;let L=new vi;L.viewport=new zt;let H=[D,L],V=new Wh,O=null,$=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(te){let _e=I[te];return _e===void 0&&(_e=new Oa,I[te]=_e),_e.getTargetRaySpace()},this.getControllerGrip=function(te){let _e=I[te];return _e===void 0&&(_e=new Oa,I[te]=_e),_e.getGripSpace()},this.getHand=function(te){let _e=I[te];return _e===void 0&&(_e=new Oa,I[te]=_e),_e.getHandSpace()};function q(te){let _e=C.indexOf(te.inputSource);if(_e===-1)return;let me=I[_e];me!==void 0&&(me.update(te.inputSource,te.frame,c||o),me.dispatchEvent({type:te.type,data:te.inputSource}))}function G(){s.removeEventListener("select",q),s.removeEventListener("selectstart",q),s.removeEventListener("selectend",q),s.removeEventListener("squeeze",q),s.removeEventListener("squeezestart",q),s.removeEventListener("squeezeend",q),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ce);for(let te=0;te<I.length;te++){let _e=C[te];_e!==null&&(C[te]=null,I[te].disconnect(_e))}O=null,$=null,g.reset();for(let te in _)delete _[te];if(e.setRenderTarget(E),f=null,h=null,d=null,s=null,M=null,ue.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(y.width,y.height,!1),k!==null){let te=k.camera;te.fov=k.fov,te.zoom=k.zoom,te.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(te){r=te,i.isPresenting===!0&&Ze("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(te){a=te,i.isPresenting===!0&&Ze("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(te){c=te},this.getBaseLayer=function(){return h!==null?h:f},this.getBinding=function(){return d===null&&v&&(d=new XRWebGLBinding(s,t)),d},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(te){if(s=te,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",q),s.addEventListener("selectstart",q),s.addEventListener("selectend",q),s.addEventListener("squeeze",q),s.addEventListener("squeezestart",q),s.addEventListener("squeezeend",q),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ce),b.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(y),v&&"createProjectionLayer"in XRWebGLBinding.prototype){let me=null,Ae=null,be=null;b.depth&&(be=b.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,me=b.stencil?gr:hr,Ae=b.stencil?Lo:Ss);let qe={colorFormat:t.RGBA8,depthFormat:be,scaleFactor:r};d=this.getBinding(),h=d.createProjectionLayer(qe),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),M=new $i(h.textureWidth,h.textureHeight,{format:Ji,type:Ii,depthTexture:new pr(h.textureWidth,h.textureHeight,Ae,void 0,void 0,void 0,void 0,void 0,void 0,me),stencilBuffer:b.stencil,colorSpace:e.outputColorSpace,samples:b.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let me={antialias:b.antialias,alpha:!0,depth:b.depth,stencil:b.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,t,me),s.updateRenderState({baseLayer:f}),e.setPixelRatio(1),e.setSize(f.framebufferWidth,f.framebufferHeight,!1),M=new $i(f.framebufferWidth,f.framebufferHeight,{format:Ji,type:Ii,colorSpace:e.outputColorSpace,stencilBuffer:b.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),ue.setContext(s),ue.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function ce(te){for(let _e=0;_e<te.removed.length;_e++){let me=te.removed[_e],Ae=C.indexOf(me);Ae>=0&&(C[Ae]=null,I[Ae].disconnect(me))}for(let _e=0;_e<te.added.length;_e++){let me=te.added[_e],Ae=C.indexOf(me);if(Ae===-1){for(let qe=0;qe<I.length;qe++)if(qe>=C.length){C.push(me),Ae=qe;break}else if(C[qe]===null){C[qe]=me,Ae=qe;break}if(Ae===-1)break}let be=I[Ae];be&&be.connect(me)}}function K(te,_e){_e===null?te.matrixWorld.copy(te.matrix):te.matrixWorld.multiplyMatrices(_e.matrixWorld,te.matrix),te.matrixWorldInverse.copy(te.matrixWorld).invert()}this.updateCamera=function(te){if(s===null)return;let _e=te.near,me=te.far;g.texture!==null&&(g.depthNear>0&&(_e=g.depthNear),g.depthFar>0&&(me=g.depthFar)),V.near=L.near=D.near=_e,V.far=L.far=D.far=me,(O!==V.near||$!==V.far)&&(s.updateRenderState({depthNear:V.near,depthFar:V.far}),O=V.near,$=V.far),V.layers.mask=te.layers.mask|6,D.layers.mask=V.layers.mask&-5,L.layers.mask=V.layers.mask&-3;let Ae=te.parent,be=V.cameras;K(V,Ae);for(let qe=0;qe<be.length;qe++)K(be[qe],Ae);V.projectionMatrix.copy(D.projectionMatrix),V.projectionMatrixInverse.copy(D.projectionMatrixInverse),k===null&&te.isPerspectiveCamera&&(k={camera:te,fov:te.fov,zoom:te.zoom}),ee(te,V,Ae)};function ee(te,_e,me){me===null?te.matrix.copy(_e.matrixWorld):(te.matrix.copy(me.matrixWorld),te.matrix.invert(),te.matrix.multiply(_e.matrixWorld)),te.matrix.decompose(te.position,te.quaternion,te.scale),te.updateMatrixWorld(!0),te.projectionMatrix.copy(_e.projectionMatrix),te.projectionMatrixInverse.copy(_e.projectionMatrixInverse),te.isPerspectiveCamera&&(te.fov=Da*2*Math.atan(1/te.projectionMatrix.elements[5]),te.zoom=1)}this.getCamera=function(){return V},this.getFoveation=function(){if(!(h===null&&f===null))return l},this.setFoveation=function(te){l=te,h!==null&&(h.fixedFoveation=te),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=te)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(V)},this.getCameraTexture=function(te){return _[te]};let Y=null;function oe(te,_e){if(u=_e.getViewerPose(c||o),p=_e,u!==null){let me=u.views;f!==null&&(e.setRenderTargetFramebuffer(M,f.framebuffer),e.setRenderTarget(M));let Ae=!1;me.length!==V.cameras.length&&(V.cameras.length=0,Ae=!0);for(let Be=0;Be<me.length;Be++){let ot=me[Be],ut=null;if(f!==null)ut=f.getViewport(ot);else{let Vt=d.getViewSubImage(h,ot);ut=Vt.viewport,Be===0&&(e.setRenderTargetTextures(M,Vt.colorTexture,Vt.depthStencilTexture),e.setRenderTarget(M))}let Je=H[Be];Je===void 0&&(Je=new vi,Je.layers.enable(Be),Je.viewport=new zt,H[Be]=Je),Je.matrix.fromArray(ot.transform.matrix),Je.matrix.decompose(Je.position,Je.quaternion,Je.scale),Je.projectionMatrix.fromArray(ot.projectionMatrix),Je.projectionMatrixInverse.copy(Je.projectionMatrix).invert(),Je.viewport.set(ut.x,ut.y,ut.width,ut.height),Be===0&&(V.matrix.copy(Je.matrix),V.matrix.decompose(V.position,V.quaternion,V.scale)),Ae===!0&&V.cameras.push(Je)}let be=s.enabledFeatures;if(be&&be.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&v){d=i.getBinding();let Be=d.getDepthInformation(me[0]);Be&&Be.isValid&&Be.texture&&g.init(Be,s.renderState)}if(be&&be.includes("camera-access")&&v){e.state.unbindTexture(),d=i.getBinding();for(let Be=0;Be<me.length;Be++){let ot=me[Be].camera;if(ot){let ut=_[ot];ut||(ut=new ec,_[ot]=ut);let Je=d.getCameraImage(ot);ut.sourceTexture=Je}}}}for(let me=0;me<I.length;me++){let Ae=C[me],be=I[me];Ae!==null&&be!==void 0&&be.update(Ae,_e,c||o)}Y&&Y(te,_e),_e.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_e}),p=null}let ue=new Pb;ue.setAnimationLoop(oe),this.setAnimationLoop=function(te){Y=te},this.dispose=function(){}}},W3=new vt,zb=new ct;zb.set(-1,0,0,0,1,0,0,0,1);function $3(n,e){function t(g,_){g.matrixAutoUpdate===!0&&g.updateMatrix(),_.value.copy(g.matrix)}function i(g,_){_.color.getRGB(g.fogColor.value,jm(n)),_.isFog?(g.fogNear.value=_.near,g.fogFar.value=_.far):_.isFogExp2&&(g.fogDensity.value=_.density)}function s(g,_,b,E,M){_.isNodeMaterial?_.uniformsNeedUpdate=!1:_.isMeshBasicMaterial?r(g,_):_.isMeshLambertMaterial?(r(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshToonMaterial?(r(g,_),d(g,_)):_.isMeshPhongMaterial?(r(g,_),u(g,_),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)):_.isMeshStandardMaterial?(r(g,_),h(g,_),_.isMeshPhysicalMaterial&&f(g,_,M)):_.isMeshMatcapMaterial?(r(g,_),p(g,_)):_.isMeshDepthMaterial?r(g,_):_.isMeshDistanceMaterial?(r(g,_),v(g,_)):_.isMeshNormalMaterial?r(g,_):_.isLineBasicMaterial?(o(g,_),_.isLineDashedMaterial&&a(g,_)):_.isPointsMaterial?l(g,_,b,E):_.isSpriteMaterial?c(g,_):_.isShadowMaterial?(g.color.value.copy(_.color),g.opacity.value=_.opacity):_.isShaderMaterial&&(_.uniformsNeedUpdate=!1)}function r(g,_){g.opacity.value=_.opacity,_.color&&g.diffuse.value.copy(_.color),_.emissive&&g.emissive.value.copy(_.emissive).multiplyScalar(_.emissiveIntensity),_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.bumpMap&&(g.bumpMap.value=_.bumpMap,t(_.bumpMap,g.bumpMapTransform),g.bumpScale.value=_.bumpScale,_.side===Si&&(g.bumpScale.value*=-1)),_.normalMap&&(g.normalMap.value=_.normalMap,t(_.normalMap,g.normalMapTransform),g.normalScale.value.copy(_.normalScale),_.side===Si&&g.normalScale.value.negate()),_.displacementMap&&(g.displacementMap.value=_.displacementMap,t(_.displacementMap,g.displacementMapTransform),g.displacementScale.value=_.displacementScale,g.displacementBias.value=_.displacementBias),_.emissiveMap&&(g.emissiveMap.value=_.emissiveMap,t(_.emissiveMap,g.emissiveMapTransform)),_.specularMap&&(g.specularMap.value=_.specularMap,t(_.specularMap,g.specularMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest);let b=e.get(_),E=b.envMap,M=b.envMapRotation;E&&(g.envMap.value=E,g.envMapRotation.value.setFromMatrix4(W3.makeRotationFromEuler(M)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(zb),g.reflectivity.value=_.reflectivity,g.ior.value=_.ior,g.refractionRatio.value=_.refractionRatio),_.lightMap&&(g.lightMap.value=_.lightMap,g.lightMapIntensity.value=_.lightMapIntensity,t(_.lightMap,g.lightMapTransform)),_.aoMap&&(g.aoMap.value=_.aoMap,g.aoMapIntensity.value=_.aoMapIntensity,t(_.aoMap,g.aoMapTransform))}function o(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform))}function a(g,_){g.dashSize.value=_.dashSize,g.totalSize.value=_.dashSize+_.gapSize,g.scale.value=_.scale}function l(g,_,b,E){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.size.value=_.size*b,g.scale.value=E*.5,_.map&&(g.map.value=_.map,t(_.map,g.uvTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function c(g,_){g.diffuse.value.copy(_.color),g.opacity.value=_.opacity,g.rotation.value=_.rotation,_.map&&(g.map.value=_.map,t(_.map,g.mapTransform)),_.alphaMap&&(g.alphaMap.value=_.alphaMap,t(_.alphaMap,g.alphaMapTransform)),_.alphaTest>0&&(g.alphaTest.value=_.alphaTest)}function u(g,_){g.specular.value.copy(_.specular),g.shininess.value=Math.max(_.shininess,1e-4)}function d(g,_){_.gradientMap&&(g.gradientMap.value=_.gradientMap)}function h(g,_){g.metalness.value=_.metalness,_.metalnessMap&&(g.metalnessMap.value=_.metalnessMap,t(_.metalnessMap,g.metalnessMapTransform)),g.roughness.value=_.roughness,_.roughnessMap&&(g.roughnessMap.value=_.roughnessMap,t(_.roughnessMap,g.roughnessMapTransform)),_.envMap&&(g.envMapIntensity.value=_.envMapIntensity)}function f(g,_,b){g.ior.value=_.ior,_.diffuseRoughness>0&&(g.diffuseRoughness.value=_.diffuseRoughness,_.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=_.diffuseRoughnessMap,t(_.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),_.sheen>0&&(g.sheenColor.value.copy(_.sheenColor).multiplyScalar(_.sheen),g.sheenRoughness.value=_.sheenRoughness,_.sheenColorMap&&(g.sheenColorMap.value=_.sheenColorMap,t(_.sheenColorMap,g.sheenColorMapTransform)),_.sheenRoughnessMap&&(g.sheenRoughnessMap.value=_.sheenRoughnessMap,t(_.sheenRoughnessMap,g.sheenRoughnessMapTransform))),_.clearcoat>0&&(g.clearcoat.value=_.clearcoat,g.clearcoatRoughness.value=_.clearcoatRoughness,_.clearcoatMap&&(g.clearcoatMap.value=_.clearcoatMap,t(_.clearcoatMap,g.clearcoatMapTransform)),_.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=_.clearcoatRoughnessMap,t(_.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),_.clearcoatNormalMap&&(g.clearcoatNormalMap.value=_.clearcoatNormalMap,t(_.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(_.clearcoatNormalScale),_.side===Si&&g.clearcoatNormalScale.value.negate())),_.dispersion>0&&(g.dispersion.value=_.dispersion),_.retroreflectivity>0&&(g.retroreflectivity.value=_.retroreflectivity),_.iridescence>0&&(g.iridescence.value=_.iridescence,g.iridescenceIOR.value=_.iridescenceIOR,g.iridescenceThicknessMinimum.value=_.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=_.iridescenceThicknessMaximum,_.iridescenceMap&&(g.iridescenceMap.value=_.iridescenceMap,t(_.iridescenceMap,g.iridescenceMapTransform)),_.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=_.iridescenceThicknessMap,t(_.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),_.transmission>0&&(g.transmission.value=_.transmission,g.transmissionSamplerMap.value=b.texture,g.transmissionSamplerSize.value.set(b.width,b.height),_.transmissionMap&&(g.transmissionMap.value=_.transmissionMap,t(_.transmissionMap,g.transmissionMapTransform)),g.thickness.value=_.thickness,_.thicknessMap&&(g.thicknessMap.value=_.thicknessMap,t(_.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=_.attenuationDistance,g.attenuationColor.value.copy(_.attenuationColor)),_.anisotropy>0&&(g.anisotropyVector.value.set(_.anisotropy*Math.cos(_.anisotropyRotation),_.anisotropy*Math.sin(_.anisotropyRotation)),_.anisotropyMap&&(g.anisotropyMap.value=_.anisotropyMap,t(_.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=_.specularIntensity,g.specularColor.value.copy(_.specularColor),_.specularColorMap&&(g.specularColorMap.value=_.specularColorMap,t(_.specularColorMap,g.specularColorMapTransform)),_.specularIntensityMap&&(g.specularIntensityMap.value=_.specularIntensityMap,t(_.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,_){_.matcap&&(g.matcap.value=_.matcap)}function v(g,_){let b=e.get(_).light;g.referencePosition.value.setFromMatrixPosition(b.matrixWorld),g.nearDistance.value=b.shadow.camera.near,g.farDistance.value=b.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function X3(n,e,t,i){let s={},r={};function o(b,E){let M=E.program;i.uniformBlockBinding(b,M,s[b.id])}function a(b,E){let M=s[b.id];M===void 0&&(p(b),M=l(b),s[b.id]=M,b.addEventListener("dispose",g));let I=E.program;i.updateUBOMapping(b,I);let C=e.render.frame;r[b.id]!==C&&(c(b),r[b.id]=C)}function l(b){let E=n.createBuffer(),M=b.__size,I=b.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,M,I),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(b){let E=s[b.id],M=b.uniforms,I=b.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let C=0,y=M.length;C<y;C++){let T=M[C];if(Array.isArray(T))for(let k=0,D=T.length;k<D;k++)u(T[k],C,k,I);else u(T,C,0,I)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(b,E,M,I){if(h(b,E,M,I)===!0){let C=b.__offset,y=b.value;if(Array.isArray(y)){let T=0;for(let k=0;k<y.length;k++){let D=y[k],L=v(D,!0);d(D,b.__data,T),T+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else d(y,b.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,b.__data)}}function d(b,E,M){typeof b=="number"||typeof b=="boolean"?E[M]=b:b.isMatrix3?(E[M]=b.elements[0],E[M+1]=b.elements[1],E[M+2]=b.elements[2],E[M+3]=0,E[M+4]=b.elements[3],E[M+5]=b.elements[4],E[M+6]=b.elements[5],E[M+7]=0,E[M+8]=b.elements[6],E[M+9]=b.elements[7],E[M+10]=b.elements[8],E[M+11]=0):ArrayBuffer.isView(b)?E.set(b.subarray(0,E.length-M),M):b.toArray(E,M)}function h(b,E,M,I){let C=b.value,y=E+"_"+M;if(Array.isArray(C)){I[y]===void 0&&(I[y]=[]);let T=I[y],k=!1;for(let D=0;D<C.length;D++)f(C[D],T,D)===!0&&(k=!0);return k}return f(C,I,y)}function f(b,E,M){if(E[M]===void 0)return typeof b=="number"||typeof b=="boolean"?E[M]=b:ArrayBuffer.isView(b)?E[M]=b.slice():E[M]=b.clone(),!0;{let I=E[M];if(typeof b=="number"||typeof b=="boolean"){if(I!==b)return E[M]=b,!0}else{if(ArrayBuffer.isView(b))return!0;if(I.equals(b)===!1)return I.copy(b),!0}}return!1}function p(b){let E=b.uniforms,M=0,I=16;for(let y=0,T=E.length;y<T;y++){let k=Array.isArray(E[y])?E[y]:[E[y]];for(let D=0,L=k.length;D<L;D++){let H=k[D],V=Array.isArray(H.value)?H.value:[H.value],O=Array.isArray(E[y])||Array.isArray(H.value),$=M;for(let G=0,ce=V.length;G<ce;G++){let K=V[G],ee=v(K,O),Y=M%I,oe=Y%ee.boundary,ue=Y+oe;M+=oe,ue!==0&&I-ue<ee.storage&&(M+=I-ue),G===0&&($=M),M+=ee.storage}let q=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new q((M-$)/Float32Array.BYTES_PER_ELEMENT),H.__offset=$}}let C=M%I;return C>0&&(M+=I-C),b.__size=M,b.__cache={},this}function v(b,E){let M={boundary:0,storage:0};return typeof b=="number"||typeof b=="boolean"?(M.boundary=4,M.storage=4):b.isVector2?(M.boundary=8,M.storage=8):b.isVector3||b.isColor?(M.boundary=16,M.storage=12):b.isVector4?(M.boundary=16,M.storage=16):b.isMatrix3?(M.boundary=16,M.storage=48):b.isMatrix4?(M.boundary=16,M.storage=64):b.isTexture?Ze("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(b)?(M.boundary=16,M.storage=b.byteLength):Ze("WebGLRenderer: Unsupported uniform value type.",b),E===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(b){let E=b.target;E.removeEventListener("dispose",g),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function _(){for(let b in s)n.deleteBuffer(s[b]);s={},r={}}return{bind:o,update:a,dispose:_}}var q3=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),Vs=null;function Y3(){return Vs===null&&(Vs=new Co(q3,16,16,no,Ms),Vs.name="DFG_LUT",Vs.minFilter=bi,Vs.magFilter=bi,Vs.wrapS=Us,Vs.wrapT=Us,Vs.generateMipmaps=!1,Vs.needsUpdate=!0),Vs}var Fd=class{constructor(e={}){let{canvas:t=nb(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:d=!1,reversedDepthBuffer:h=!1,outputBufferType:f=Ii}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let v=f,g=new Set([td,ed,Qh]),_=new Set([Ii,Ss,Wa,Lo,Kh,Zh]),b=new Uint32Array(4),E=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},I=null,C=null,y=[],T=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=zs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let D=this,L=!1,H=null,V=null,O=null,$=null;this._outputColorSpace=cn;let q=0,G=0,ce=null,K=-1,ee=null,Y=new zt,oe=new zt,ue=null,te=new dt(0),_e=0,me=t.width,Ae=t.height,be=1,qe=null,tt=null,Be=new zt(0,0,me,Ae),ot=new zt(0,0,me,Ae),ut=!1,Je=new qr,Vt=new Th,qt=!1,dn=!1,Dt=new vt,Nn=new B,At=new zt,un={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},tn=!1;function fn(){return ce===null?be:1}let U=i;function Ee(A,z){return t.getContext(A,z)}let Ke,at,we,Nt,ze,ye,R,S,X,de,ae,ve,Se,ne,se,ge,F,re,ie,Ce,xe,Te,Xe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:d};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",He,!1),t.addEventListener("webglcontextrestored",it,!1),t.addEventListener("webglcontextcreationerror",Ie,!1),U===null){let z="webgl2";if(U=Ee(z,A),U===null)throw Ee(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}nt()}catch(A){throw t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),rt("WebGLRenderer: "+A.message),A}function nt(){Ke=new rP(U),Ke.init(),xe=new V3(U,Ke),at=new YR(U,Ke,e,xe),we=new B3(U,Ke),at.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),V=U.createFramebuffer(),O=U.createFramebuffer(),$=U.createFramebuffer(),Nt=new lP(U),ze=new A3,ye=new z3(U,Ke,we,ze,at,xe,Nt),R=new sP(D),S=new uE(U),Te=new XR(U,S),X=new oP(U,S,Nt,Te),de=new uP(U,X,S,Te,Nt),re=new cP(U,at,ye),se=new JR(ze),ae=new w3(D,R,Ke,at,Te,se),ve=new $3(D,ze),Se=new E3,ne=new D3(Ke),F=new $R(D,R,we,de,p,l),ge=new k3(D,de,at),Xe=new X3(U,Nt,at,we),ie=new qR(U,Ke,Nt),Ce=new aP(U,Ke,Nt),Nt.programs=ae.programs,D.capabilities=at,D.extensions=Ke,D.properties=ze,D.renderLists=Se,D.shadowMap=ge,D.state=we,D.info=Nt}v!==Ii&&(k=new dP(v,t.width,t.height,a,s,r));let he=new hg(D,U);this.xr=he,this.getContext=function(){return U},this.getContextAttributes=function(){return U.getContextAttributes()},this.forceContextLoss=function(){let A=Ke.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ke.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return be},this.setPixelRatio=function(A){A!==void 0&&(be=A,this.setSize(me,Ae,!1))},this.getSize=function(A){return A.set(me,Ae)},this.setSize=function(A,z,Q=!0){if(he.isPresenting){Ze("WebGLRenderer: Can't change size while VR device is presenting.");return}me=A,Ae=z,t.width=Math.floor(A*be),t.height=Math.floor(z*be),Q===!0&&(t.style.width=A+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,A,z)},this.getDrawingBufferSize=function(A){return A.set(me*be,Ae*be).floor()},this.setDrawingBufferSize=function(A,z,Q){me=A,Ae=z,be=Q,t.width=Math.floor(A*Q),t.height=Math.floor(z*Q),this.setViewport(0,0,A,z)},this.setEffects=function(A){if(v===Ii){rt("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let z=0;z<A.length;z++)if(A[z].isOutputPass===!0){Ze("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(Y)},this.getViewport=function(A){return A.copy(Be)},this.setViewport=function(A,z,Q,J){A.isVector4?Be.set(A.x,A.y,A.z,A.w):Be.set(A,z,Q,J),we.viewport(Y.copy(Be).multiplyScalar(fn()).round())},this.getScissor=function(A){return A.copy(ot)},this.setScissor=function(A,z,Q,J){A.isVector4?ot.set(A.x,A.y,A.z,A.w):ot.set(A,z,Q,J),we.scissor(oe.copy(ot).multiplyScalar(fn()).round())},this.getScissorTest=function(){return ut},this.setScissorTest=function(A){we.setScissorTest(ut=A)},this.setOpaqueSort=function(A){qe=A},this.setTransparentSort=function(A){tt=A},this.getClearColor=function(A){return A.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(A=!0,z=!0,Q=!0){let J=0;if(A){let Z=!1;if(ce!==null){let Re=ce.texture.format;Z=g.has(Re)}if(Z){let Re=ce.texture.type,De=_.has(Re),Pe=F.getClearColor(),Ne=F.getClearAlpha(),We=Pe.r,st=Pe.g,yt=Pe.b;De?(b[0]=We,b[1]=st,b[2]=yt,b[3]=Ne,U.clearBufferuiv(U.COLOR,0,b)):(E[0]=We,E[1]=st,E[2]=yt,E[3]=Ne,U.clearBufferiv(U.COLOR,0,E))}else J|=U.COLOR_BUFFER_BIT}z&&(J|=U.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),Q&&(J|=U.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),J!==0&&U.clear(J)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),H=A},this.dispose=function(){t.removeEventListener("webglcontextlost",He,!1),t.removeEventListener("webglcontextrestored",it,!1),t.removeEventListener("webglcontextcreationerror",Ie,!1),F.dispose(),Se.dispose(),ne.dispose(),ye.dispose(),ze.dispose(),R.dispose(),de.dispose(),X.dispose(),Te.dispose(),Xe.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",Ec),he.removeEventListener("sessionend",ws),$s.stop()};function He(A){A.preventDefault(),$l("WebGLRenderer: Context Lost."),L=!0}function it(){$l("WebGLRenderer: Context Restored."),L=!1;let A=Nt.autoReset,z=ge.enabled,Q=ge.autoUpdate,J=ge.needsUpdate,Z=ge.type;nt(),Nt.autoReset=A,ge.enabled=z,ge.autoUpdate=Q,ge.needsUpdate=J,ge.type=Z}function Ie(A){rt("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function mt(A){let z=A.target;z.removeEventListener("dispose",mt),nn(z)}function nn(A){ci(A),ze.remove(A)}function ci(A){let z=ze.get(A).programs;z!==void 0&&(z.forEach(function(Q){ae.releaseProgram(Q)}),A.isShaderMaterial&&ae.releaseShaderCache(A))}this.renderBufferDirect=function(A,z,Q,J,Z,Re){z===null&&(z=un);let De=Z.isMesh&&Z.matrixWorld.determinantAffine()<0,Pe=Qa(A,z,Q,J,Z);we.setMaterial(J,De);let Ne=Q.index,We=1;if(J.wireframe===!0){if(Ne=X.getWireframeAttribute(Q),Ne===void 0)return;We=2}let st=Q.drawRange,yt=Q.attributes.position,Ge=st.start*We,xt=(st.start+st.count)*We;Re!==null&&(Ge=Math.max(Ge,Re.start*We),xt=Math.min(xt,(Re.start+Re.count)*We)),Ne!==null?(Ge=Math.max(Ge,0),xt=Math.min(xt,Ne.count)):yt!=null&&(Ge=Math.max(Ge,0),xt=Math.min(xt,yt.count));let pn=xt-Ge;if(pn<0||pn===1/0)return;Te.setup(Z,J,Pe,Q,Ne);let Ht,Gt=ie;if(Ne!==null&&(Ht=S.get(Ne),Gt=Ce,Gt.setIndex(Ht)),Z.isMesh)J.wireframe===!0?(we.setLineWidth(J.wireframeLinewidth*fn()),Gt.setMode(U.LINES)):Gt.setMode(U.TRIANGLES);else if(Z.isLine){let On=J.linewidth;On===void 0&&(On=1),we.setLineWidth(On*fn()),Z.isLineSegments?Gt.setMode(U.LINES):Z.isLineLoop?Gt.setMode(U.LINE_LOOP):Gt.setMode(U.LINE_STRIP)}else Z.isPoints?Gt.setMode(U.POINTS):Z.isSprite&&Gt.setMode(U.TRIANGLES);if(Z.isBatchedMesh)if(Ke.get("WEBGL_multi_draw"))Gt.renderMultiDraw(Z._multiDrawStarts,Z._multiDrawCounts,Z._multiDrawCount);else{let On=Z._multiDrawStarts,Fe=Z._multiDrawCounts,wn=Z._multiDrawCount,St=Ne?S.get(Ne).bytesPerElement:1,qs=ze.get(J).currentProgram.getUniforms();for(let An=0;An<wn;An++)qs.setValue(U,"_gl_DrawID",An),Gt.render(On[An]/St,Fe[An])}else if(Z.isInstancedMesh)Gt.renderInstances(Ge,pn,Z.count);else if(Q.isInstancedBufferGeometry){let On=Q._maxInstanceCount!==void 0?Q._maxInstanceCount:1/0,Fe=Math.min(Q.instanceCount,On);Gt.renderInstances(Ge,pn,Fe)}else Gt.render(Ge,pn)};function Ka(A,z,Q,J){H!==null&&A.isNodeMaterial&&H.setObject(J,A),qt===!0&&se.setState(A,Q,!1),A.transparent===!0&&A.side===ei&&A.forceSinglePass===!1?(A.side=Si,A.needsUpdate=!0,As(A,z,J),A.side=to,A.needsUpdate=!0,As(A,z,J),A.side=ei):As(A,z,J)}this.compile=function(A,z,Q=null){Q===null&&(Q=A),H!==null&&H.renderStart(A,z,Q),C=ne.get(Q),C.init(z),T.push(C),Q.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(C.pushLight(Z),Z.castShadow&&C.pushShadow(Z))}),A!==Q&&A.traverseVisible(function(Z){Z.isLight&&Z.layers.test(z.layers)&&(C.pushLight(Z),Z.castShadow&&C.pushShadow(Z))}),C.setupLights(),H!==null&&H.updateLights(C.state.lightsArray),dn=this.localClippingEnabled,qt=se.init(this.clippingPlanes,dn),qt===!0&&se.setGlobalState(this.clippingPlanes,z),H!==null&&ge.render(C.state.shadowsArray,Q,z);let J=new Set;return A.traverse(function(Z){if(!(Z.isMesh||Z.isPoints||Z.isLine||Z.isSprite))return;let Re=Z.material;if(Re)if(Array.isArray(Re))for(let De=0;De<Re.length;De++){let Pe=Re[De];Ka(Pe,Q,z,Z),J.add(Pe)}else Ka(Re,Q,z,Z),J.add(Re)}),C=T.pop(),H!==null&&H.renderEnd(),J},this.compileAsync=function(A,z,Q=null){let J=this.compile(A,z,Q);return new Promise(Z=>{function Re(){if(J.forEach(function(De){let Ne=ze.get(De).currentProgram;(Ne===void 0||Ne.isReady())&&J.delete(De)}),J.size===0){Z(A);return}setTimeout(Re,10)}Ke.get("KHR_parallel_shader_compile")!==null?Re():setTimeout(Re,10)})};let Fo=null;function of(A){Fo&&Fo(A)}function Ec(){$s.stop()}function ws(){$s.start()}let $s=new Pb;$s.setAnimationLoop(of),typeof self<"u"&&$s.setContext(self),this.setAnimationLoop=function(A){Fo=A,he.setAnimationLoop(A),A===null?$s.stop():$s.start()},he.addEventListener("sessionstart",Ec),he.addEventListener("sessionend",ws),this.render=function(A,z){if(z!==void 0&&z.isCamera!==!0){rt("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;H!==null&&H.renderStart(A,z);let Q=he.enabled===!0&&he.isPresenting===!0,J=k!==null&&(ce===null||Q)&&k.begin(D,ce);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(z),z=he.getCamera()),A.isScene===!0&&A.onBeforeRender(D,A,z,ce),C=ne.get(A,T.length),C.init(z),C.state.textureUnits=ye.getTextureUnits(),T.push(C),Dt.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Vt.setFromArrayCamera(z):Je.setFromProjectionMatrix(Dt,ns,z.reversedDepth),dn=this.localClippingEnabled,qt=se.init(this.clippingPlanes,dn),I=Se.get(A,y.length),I.init(),y.push(I),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let De=D.xr.getDepthSensingMesh();De!==null&&Xs(De,z,-1/0,D.sortObjects)}Xs(A,z,0,D.sortObjects),I.finish(),H!==null&&H.updateLights(C.state.lightsArray),D.sortObjects===!0&&I.sort(qe,tt),tn=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,tn&&F.addToRenderList(I,A),this.info.autoReset===!0&&this.info.reset(),qt===!0&&se.beginShadows();let Z=C.state.shadowsArray;if(ge.render(Z,A,z),qt===!0&&se.endShadows(),(J&&k.hasRenderPass())===!1){let De=I.opaque,Pe=I.transmissive;if(C.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Pe.length>0)for(let We=0,st=Ne.length;We<st;We++){let yt=Ne[We];rs(De,Pe,A,yt)}tn&&F.render(A);for(let We=0,st=Ne.length;We<st;We++){let yt=Ne[We];Za(I,A,yt,yt.viewport)}}else Pe.length>0&&rs(De,Pe,A,z),tn&&F.render(A),Za(I,A,z)}ce!==null&&G===0&&(ye.updateMultisampleRenderTarget(ce),ye.updateRenderTargetMipmap(ce)),J&&k.end(D),A.isScene===!0&&A.onAfterRender(D,A,z),Te.resetDefaultState(),K=-1,ee=null,T.pop(),T.length>0?(C=T[T.length-1],ye.setTextureUnits(C.state.textureUnits),qt===!0&&se.setGlobalState(D.clippingPlanes,C.state.camera)):C=null,y.pop(),y.length>0?I=y[y.length-1]:I=null,H!==null&&H.renderEnd()};function Xs(A,z,Q,J){if(A.visible===!1)return;if(A.layers.test(z.layers)){if(A.isGroup)Q=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(z);else if(A.isLight)C.pushLight(A),A.castShadow&&C.pushShadow(A);else if(A.isSprite){let De=z.isArrayCamera?Vt:Je;if(!A.frustumCulled||A.intersectsFrustum(De)){J&&At.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Dt);let Pe=de.update(A),Ne=A.material;Ne.visible&&I.push(A,Pe,Ne,Q,At.z,null,z)}}else if(A.isMesh||A.isLine||A.isPoints){let De=z.isArrayCamera?Vt:Je;if(!A.frustumCulled||A.intersectsFrustum(De)){let Pe=de.update(A),Ne=A.material;if(J&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),At.copy(A.boundingSphere.center)):(Pe.boundingSphere===null&&Pe.computeBoundingSphere(),At.copy(Pe.boundingSphere.center)),At.applyMatrix4(A.matrixWorld).applyMatrix4(Dt)),Array.isArray(Ne)){let We=Pe.groups;for(let st=0,yt=We.length;st<yt;st++){let Ge=We[st],xt=Ne[Ge.materialIndex];xt&&xt.visible&&I.push(A,Pe,xt,Q,At.z,Ge,z)}}else Ne.visible&&I.push(A,Pe,Ne,Q,At.z,null,z)}}}let Re=A.children;for(let De=0,Pe=Re.length;De<Pe;De++)Xs(Re[De],z,Q,J)}function Za(A,z,Q,J){let{opaque:Z,transmissive:Re,transparent:De}=A;C.setupLightsView(Q),qt===!0&&se.setGlobalState(D.clippingPlanes,Q),J&&we.viewport(Y.copy(J)),Z.length>0&&gn(Z,z,Q),Re.length>0&&gn(Re,z,Q),De.length>0&&gn(De,z,Q),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function rs(A,z,Q,J){if((Q.isScene===!0?Q.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[J.id]===void 0){let Ge=Ke.has("EXT_color_buffer_half_float")||Ke.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[J.id]=new $i(1,1,{generateMipmaps:!0,type:Ge?Ms:Ii,minFilter:mr,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:wt.workingColorSpace})}let Re=C.state.transmissionRenderTarget[J.id],De=J.viewport||Y;Re.setSize(De.z*D.transmissionResolutionScale,De.w*D.transmissionResolutionScale);let Pe=D.getRenderTarget(),Ne=D.getActiveCubeFace(),We=D.getActiveMipmapLevel();D.setRenderTarget(Re),D.getClearColor(te),_e=D.getClearAlpha(),_e<1&&D.setClearColor(16777215,.5),D.clear(),tn&&F.render(Q);let st=D.toneMapping;D.toneMapping=zs;let yt=J.viewport;if(J.viewport!==void 0&&(J.viewport=void 0),C.setupLightsView(J),qt===!0&&se.setGlobalState(D.clippingPlanes,J),gn(A,Q,J),ye.updateMultisampleRenderTarget(Re),ye.updateRenderTargetMipmap(Re),Ke.has("WEBGL_multisampled_render_to_texture")===!1){let Ge=!1;for(let xt=0,pn=z.length;xt<pn;xt++){let Ht=z[xt],{object:Gt,geometry:On,material:Fe,group:wn}=Ht;if(Fe.side===ei&&Gt.layers.test(J.layers)){let St=Fe.side;Fe.side=Si,Fe.needsUpdate=!0,vn(Gt,Q,J,On,Fe,wn),Fe.side=St,Fe.needsUpdate=!0,Ge=!0}}Ge===!0&&(ye.updateMultisampleRenderTarget(Re),ye.updateRenderTargetMipmap(Re))}D.setRenderTarget(Pe,Ne,We),D.setClearColor(te,_e),yt!==void 0&&(J.viewport=yt),D.toneMapping=st}function gn(A,z,Q){let J=z.isScene===!0?z.overrideMaterial:null;for(let Z=0,Re=A.length;Z<Re;Z++){let De=A[Z],{object:Pe,geometry:Ne,group:We}=De,st=De.material;st.allowOverride===!0&&J!==null&&(st=J),Pe.layers.test(Q.layers)&&vn(Pe,z,Q,Ne,st,We)}}function vn(A,z,Q,J,Z,Re){H!==null&&Z.isNodeMaterial&&H.setObject(A,Z),A.onBeforeRender(D,z,Q,J,Z,Re),A.modelViewMatrix.multiplyMatrices(Q.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),Z.onBeforeRender(D,z,Q,J,A,Re),Z.transparent===!0&&Z.side===ei&&Z.forceSinglePass===!1?(Z.side=Si,Z.needsUpdate=!0,D.renderBufferDirect(Q,z,J,Z,A,Re),Z.side=to,Z.needsUpdate=!0,D.renderBufferDirect(Q,z,J,Z,A,Re),Z.side=ei):D.renderBufferDirect(Q,z,J,Z,A,Re),A.onAfterRender(D,z,Q,J,Z,Re)}function bn(A){let z=0;for(let Q of A)Q.texture!==null&&z++;return z}function As(A,z,Q){z.isScene!==!0&&(z=un);let J=ze.get(A),Z=C.state.lights,Re=C.state.shadowsArray,De=Z.state.version,Pe=ae.getParameters(A,Z.state,Re,z,Q,C.state.lightProbeGridArray),Ne=ae.getProgramCacheKey(Pe),We=J.programs;J.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?z.environment:null,J.fog=z.fog;let st=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;J.envMap=R.get(A.envMap||J.environment,st),J.envMapRotation=J.environment!==null&&A.envMap===null?z.environmentRotation:A.envMapRotation,We===void 0&&(A.addEventListener("dispose",mt),We=new Map,J.programs=We,J.programVariants=new Map);let yt=We.get(Ne);if(yt!==void 0){if(J.currentProgram===yt&&J.lightsStateVersion===De)return ja(A,Pe),yt}else Pe.uniforms=ae.getUniforms(A),H!==null&&A.isNodeMaterial&&H.build(A,Q,Pe),A.onBeforeCompile(Pe,D),yt=ae.acquireProgram(Pe,Ne),We.set(Ne,yt),J.uniforms=Pe.uniforms;let Ge=J.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(Ge.clippingPlanes=se.uniform),ja(A,Pe),J.needsLights=vr(A),J.lightsStateVersion=De,J.needsLights&&(Ge.ambientLightColor.value=Z.state.ambient,Ge.lightProbe.value=Z.state.probe,Ge.sunLights.value=Z.state.sun,Ge.sunLightShadows.value=Z.state.sunShadow,Ge.directionalLights.value=Z.state.directional,Ge.directionalLightShadows.value=Z.state.directionalShadow,Ge.spotLights.value=Z.state.spot,Ge.spotLightShadows.value=Z.state.spotShadow,Ge.rectAreaLights.value=Z.state.rectArea,Ge.ltc_1.value=Z.state.rectAreaLTC1,Ge.ltc_2.value=Z.state.rectAreaLTC2,Ge.pointLights.value=Z.state.point,Ge.pointLightShadows.value=Z.state.pointShadow,Ge.hemisphereLights.value=Z.state.hemi,Ge.sunShadowMatrix.value=Z.state.sunShadowMatrix,Ge.sunShadowCascade.value=Z.state.sunShadowCascade,Ge.directionalShadowMatrix.value=Z.state.directionalShadowMatrix,Ge.spotLightMatrix.value=Z.state.spotLightMatrix,Ge.spotLightMap.value=Z.state.spotLightMap,Ge.pointShadowMatrix.value=Z.state.pointShadowMatrix),J.numLightProbeGrids=bn(C.state.lightProbeGridArray),J.currentProgram=yt,J.uniformsList=null,yt}function Di(A,z,Q,J,Z){let Re=ze.get(A),De=Re.currentProgram.id+","+J+","+Z,Pe=Re.programVariants.get(De);return Pe===void 0?(Pe=As(A,z,Q),Re.programVariants.set(De,Pe)):(Re.currentProgram=Pe,Re.uniformsList=null,Re.outputColorSpace=J,Re.toneMapping=Z),Pe}function xr(A){if(A.uniformsList===null){let z=A.currentProgram.getUniforms();A.uniformsList=$a.seqWithValue(z.seq,A.uniforms)}return A.uniformsList}function ja(A,z){let Q=ze.get(A);Q.outputColorSpace=z.outputColorSpace,Q.batching=z.batching,Q.batchingColor=z.batchingColor,Q.instancing=z.instancing,Q.instancingColor=z.instancingColor,Q.instancingMorph=z.instancingMorph,Q.skinning=z.skinning,Q.morphTargets=z.morphTargets,Q.morphNormals=z.morphNormals,Q.morphColors=z.morphColors,Q.morphTargetsCount=z.morphTargetsCount,Q.numClippingPlanes=z.numClippingPlanes,Q.numIntersection=z.numClipIntersection,Q.vertexAlphas=z.vertexAlphas,Q.vertexTangents=z.vertexTangents,Q.toneMapping=z.toneMapping}function Qa(A,z,Q,J,Z){z.isScene!==!0&&(z=un),ye.resetTextureUnits();let Re=z.fog,De=J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial?z.environment:null,Pe=ce===null?D.outputColorSpace:ce.isXRRenderTarget===!0?ce.texture.colorSpace:wt.workingColorSpace,Ne=J.isMeshStandardMaterial||J.isMeshLambertMaterial&&!J.envMap||J.isMeshPhongMaterial&&!J.envMap,We=R.get(J.envMap||De,Ne),st=J.vertexColors===!0&&!!Q.attributes.color&&Q.attributes.color.itemSize===4,yt=!!Q.attributes.tangent&&(!!J.normalMap||J.anisotropy>0),Ge=!!Q.morphAttributes.position,xt=!!Q.morphAttributes.normal,pn=!!Q.morphAttributes.color,Ht=zs;J.toneMapped&&(ce===null||ce.isXRRenderTarget===!0)&&(Ht=D.toneMapping);let Gt=Q.morphAttributes.position||Q.morphAttributes.normal||Q.morphAttributes.color,On=Gt!==void 0?Gt.length:0,Fe=ze.get(J),wn=C.state.lights;if(qt===!0&&(dn===!0||A!==ee)){let Wt=A===ee&&J.id===K;se.setState(J,A,Wt)}let St=!1,qs=!1;J.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==wn.state.version||Z.isBatchedMesh&&Fe.batching===!1||!Z.isBatchedMesh&&Fe.batching===!0||Z.isBatchedMesh&&Fe.batchingColor===!0&&Z._colorsTexture===null||Z.isBatchedMesh&&Fe.batchingColor===!1&&Z._colorsTexture!==null||Z.isInstancedMesh&&Fe.instancing===!1||!Z.isInstancedMesh&&Fe.instancing===!0||Z.isSkinnedMesh&&Fe.skinning===!1||!Z.isSkinnedMesh&&Fe.skinning===!0||Z.isInstancedMesh&&Fe.instancingColor===!0&&Z.instanceColor===null||Z.isInstancedMesh&&Fe.instancingColor===!1&&Z.instanceColor!==null||Z.isInstancedMesh&&Fe.instancingMorph===!0&&Z.morphTexture===null||Z.isInstancedMesh&&Fe.instancingMorph===!1&&Z.morphTexture!==null||Fe.envMap!==We||J.fog===!0&&Fe.fog!==Re||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==st||Fe.vertexTangents!==yt||Fe.morphTargets!==Ge||Fe.morphNormals!==xt||Fe.morphColors!==pn||Fe.morphTargetsCount!==On||Fe.numLightProbeGrids!==bn(C.state.lightProbeGridArray)?St=!0:(Fe.outputColorSpace!==Pe||Fe.toneMapping!==Ht)&&(qs=!0):(St=!0,Fe.__version=J.version);let An=Fe.currentProgram;(St===!0||qs===!0)&&(An=qs===!0?Di(J,z,Z,Pe,Ht):As(J,z,Z),H&&J.isNodeMaterial&&H.onUpdateProgram(J,An,Fe));let zo=!1,Ts=!1,Ys=!1,gt=An.getUniforms(),_n=Fe.uniforms;if(we.useProgram(An.program)&&(zo=!0,Ts=!0,Ys=!0),J.id!==K&&(K=J.id,Ts=!0),zo||ee!==A){we.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),gt.setValue(U,"projectionMatrix",A.projectionMatrix),gt.setValue(U,"viewMatrix",A.matrixWorldInverse);let Tn=gt.map.cameraPosition;Tn!==void 0&&Tn.setValue(U,Nn.setFromMatrixPosition(A.matrixWorld)),at.logarithmicDepthBuffer&&gt.setValue(U,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(J.isMeshPhongMaterial||J.isMeshToonMaterial||J.isMeshLambertMaterial||J.isMeshBasicMaterial||J.isMeshStandardMaterial||J.isShaderMaterial)&&gt.setValue(U,"isOrthographic",A.isOrthographicCamera===!0),ee!==A&&(ee=A,Ts=!0,Ys=!0)}if(Fe.needsLights&&(wn.state.sunShadowMap.length>0&&gt.setValue(U,"sunShadowMap",wn.state.sunShadowMap,ye),wn.state.directionalShadowMap.length>0&&gt.setValue(U,"directionalShadowMap",wn.state.directionalShadowMap,ye),wn.state.spotShadowMap.length>0&&gt.setValue(U,"spotShadowMap",wn.state.spotShadowMap,ye),wn.state.pointShadowMap.length>0&&gt.setValue(U,"pointShadowMap",wn.state.pointShadowMap,ye)),Z.isSkinnedMesh){gt.setOptional(U,Z,"bindMatrix"),gt.setOptional(U,Z,"bindMatrixInverse");let Wt=Z.skeleton;Wt&&(Wt.boneTexture===null&&Wt.computeBoneTexture(),gt.setValue(U,"boneTexture",Wt.boneTexture,ye))}Z.isBatchedMesh&&(gt.setOptional(U,Z,"batchingTexture"),gt.setValue(U,"batchingTexture",Z._matricesTexture,ye),gt.setOptional(U,Z,"batchingIdTexture"),gt.setValue(U,"batchingIdTexture",Z._indirectTexture,ye),gt.setOptional(U,Z,"batchingColorTexture"),Z._colorsTexture!==null&&gt.setValue(U,"batchingColorTexture",Z._colorsTexture,ye));let ui=Q.morphAttributes;if((ui.position!==void 0||ui.normal!==void 0||ui.color!==void 0)&&re.update(Z,Q,An),(Ts||Fe.receiveShadow!==Z.receiveShadow)&&(Fe.receiveShadow=Z.receiveShadow,gt.setValue(U,"receiveShadow",Z.receiveShadow)),(J.isMeshStandardMaterial||J.isMeshLambertMaterial||J.isMeshPhongMaterial)&&J.envMap===null&&z.environment!==null&&(_n.envMapIntensity.value=z.environmentIntensity),_n.dfgLUT!==void 0&&(_n.dfgLUT.value=Y3()),Ts){if(gt.setValue(U,"toneMappingExposure",D.toneMappingExposure),Fe.needsLights&&ko(_n,Ys),Re&&J.fog===!0&&ve.refreshFogUniforms(_n,Re),ve.refreshMaterialUniforms(_n,J,be,Ae,C.state.transmissionRenderTarget[A.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Wt=M,Tn=0;for(let si of C.state.lightProbeGridArray)si.texture!==null&&(Wt.textures[Tn]=si.texture,Wt.min[Tn]=si.boundingBox.min,Wt.max[Tn]=si.boundingBox.max,Wt.resolution[Tn]=si.resolution,Tn++);for(let si in Wt)Wt[si].length=Tn;_n.probesSH.value=Wt.textures,_n.probesMin.value=Wt.min,_n.probesMax.value=Wt.max,_n.probesResolution.value=Wt.resolution}$a.upload(U,xr(Fe),_n,ye)}if(J.isShaderMaterial&&J.uniformsNeedUpdate===!0&&($a.upload(U,xr(Fe),_n,ye),J.uniformsNeedUpdate=!1),J.isSpriteMaterial&&gt.setValue(U,"center",Z.center),gt.setValue(U,"modelViewMatrix",Z.modelViewMatrix),gt.setValue(U,"normalMatrix",Z.normalMatrix),gt.setValue(U,"modelMatrix",Z.matrixWorld),J.uniformsGroups!==void 0){let Wt=J.uniformsGroups;for(let Tn=0,si=Wt.length;Tn<si;Tn++){let Cc=Wt[Tn];Xe.update(Cc,An),Xe.bind(Cc,An)}}return An}function ko(A,z){A.ambientLightColor.needsUpdate=z,A.lightProbe.needsUpdate=z,A.sunLights.needsUpdate=z,A.sunLightShadows.needsUpdate=z,A.directionalLights.needsUpdate=z,A.directionalLightShadows.needsUpdate=z,A.pointLights.needsUpdate=z,A.pointLightShadows.needsUpdate=z,A.spotLights.needsUpdate=z,A.spotLightShadows.needsUpdate=z,A.rectAreaLights.needsUpdate=z,A.hemisphereLights.needsUpdate=z}function vr(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return q},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ce},this.setRenderTargetTextures=function(A,z,Q){let J=ze.get(A);J.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,J.__autoAllocateDepthBuffer===!1&&(J.__useRenderToTexture=!1),ze.get(A.texture).__webglTexture=z,ze.get(A.depthTexture).__webglTexture=J.__autoAllocateDepthBuffer?void 0:Q,J.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,z){let Q=ze.get(A);Q.__webglFramebuffer=z,Q.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(A,z=0,Q=0){ce=A,q=z,G=Q;let J=null,Z=!1,Re=!1;if(A){let Pe=ze.get(A);if(Pe.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(U.FRAMEBUFFER,Pe.__webglFramebuffer),Y.copy(A.viewport),oe.copy(A.scissor),ue=A.scissorTest,we.viewport(Y),we.scissor(oe),we.setScissorTest(ue),K=-1;return}else if(Pe.__webglFramebuffer===void 0)ye.setupRenderTarget(A);else if(Pe.__hasExternalTextures)ye.rebindTextures(A,ze.get(A.texture).__webglTexture,ze.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let st=A.depthTexture;if(Pe.__boundDepthTexture!==st){if(st!==null&&ze.has(st)&&(A.width!==st.image.width||A.height!==st.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");ye.setupDepthRenderbuffer(A)}}let Ne=A.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Re=!0);let We=ze.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(We[z])?J=We[z][Q]:J=We[z],Z=!0):A.samples>0&&ye.useMultisampledRTT(A)===!1?J=ze.get(A).__webglMultisampledFramebuffer:Array.isArray(We)?J=We[Q]:J=We,Y.copy(A.viewport),oe.copy(A.scissor),ue=A.scissorTest}else Y.copy(Be).multiplyScalar(be).floor(),oe.copy(ot).multiplyScalar(be).floor(),ue=ut;if(Q!==0&&(J=V),we.bindFramebuffer(U.FRAMEBUFFER,J)&&we.drawBuffers(A,J),we.viewport(Y),we.scissor(oe),we.setScissorTest(ue),Z){let Pe=ze.get(A.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_CUBE_MAP_POSITIVE_X+z,Pe.__webglTexture,Q)}else if(Re){let Pe=z;for(let Ne=0;Ne<A.textures.length;Ne++){let We=ze.get(A.textures[Ne]);U.framebufferTextureLayer(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0+Ne,We.__webglTexture,Q,Pe)}}else if(A!==null&&Q!==0){let Pe=ze.get(A.texture);U.framebufferTexture2D(U.FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,Pe.__webglTexture,Q)}K=-1};function Bo(A){let z=ze.get(A);return(z.__readFormat!==A.format||z.__readType!==A.type)&&(z.__readFormat=A.format,z.__readType=A.type,z.__formatReadable=at.textureFormatReadable(A.format),z.__typeReadable=at.textureTypeReadable(A.type)),z}this.readRenderTargetPixels=function(A,z,Q,J,Z,Re,De,Pe=0){if(!(A&&A.isWebGLRenderTarget)){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=ze.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){we.bindFramebuffer(U.FRAMEBUFFER,Ne);try{let We=A.textures[Pe],st=We.format,yt=We.type;A.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Pe);let Ge=Bo(We);if(Ge.__formatReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(Ge.__typeReadable===!1){rt("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=A.width-J&&Q>=0&&Q<=A.height-Z&&U.readPixels(z,Q,J,Z,xe.convert(st),xe.convert(yt),Re)}finally{let We=ce!==null?ze.get(ce).__webglFramebuffer:null;we.bindFramebuffer(U.FRAMEBUFFER,We)}}},this.readRenderTargetPixelsAsync=async function(A,z,Q,J,Z,Re,De,Pe=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=ze.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=A.width-J&&Q>=0&&Q<=A.height-Z){we.bindFramebuffer(U.FRAMEBUFFER,Ne);let We=A.textures[Pe],st=We.format,yt=We.type;A.textures.length>1&&U.readBuffer(U.COLOR_ATTACHMENT0+Pe);let Ge=Bo(We);if(Ge.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(Ge.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let xt=U.createBuffer();U.bindBuffer(U.PIXEL_PACK_BUFFER,xt),U.bufferData(U.PIXEL_PACK_BUFFER,Re.byteLength,U.STREAM_READ),U.readPixels(z,Q,J,Z,xe.convert(st),xe.convert(yt),0),U.bindBuffer(U.PIXEL_PACK_BUFFER,null);let pn=ce!==null?ze.get(ce).__webglFramebuffer:null;we.bindFramebuffer(U.FRAMEBUFFER,pn);let Ht=U.fenceSync(U.SYNC_GPU_COMMANDS_COMPLETE,0);return U.flush(),await sb(U,Ht,4),U.bindBuffer(U.PIXEL_PACK_BUFFER,xt),U.getBufferSubData(U.PIXEL_PACK_BUFFER,0,Re),U.bindBuffer(U.PIXEL_PACK_BUFFER,null),U.deleteBuffer(xt),U.deleteSync(Ht),Re}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,z=null,Q=0){let J=Math.pow(2,-Q),Z=Math.floor(A.image.width*J),Re=Math.floor(A.image.height*J),De=z!==null?z.x:0,Pe=z!==null?z.y:0;ye.setTexture2D(A,0),U.copyTexSubImage2D(U.TEXTURE_2D,Q,0,0,De,Pe,Z,Re),we.unbindTexture()},this.copyTextureToTexture=function(A,z,Q=null,J=null,Z=0,Re=0){let De,Pe,Ne,We,st,yt,Ge,xt,pn,Ht=A.isCompressedTexture?A.mipmaps[Re]:A.image;if(Q!==null)De=Q.max.x-Q.min.x,Pe=Q.max.y-Q.min.y,Ne=Q.isBox3?Q.max.z-Q.min.z:1,We=Q.min.x,st=Q.min.y,yt=Q.isBox3?Q.min.z:0;else{let gt=Math.pow(2,-Z);De=Math.floor(Ht.width*gt),Pe=Math.floor(Ht.height*gt),A.isDataArrayTexture?Ne=Ht.depth:A.isData3DTexture?Ne=Math.floor(Ht.depth*gt):Ne=1,We=0,st=0,yt=0}J!==null?(Ge=J.x,xt=J.y,pn=J.z):(Ge=0,xt=0,pn=0);let Gt=xe.convert(z.format),On=xe.convert(z.type),Fe;z.isData3DTexture?(ye.setTexture3D(z,0),Fe=U.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?(ye.setTexture2DArray(z,0),Fe=U.TEXTURE_2D_ARRAY):(ye.setTexture2D(z,0),Fe=U.TEXTURE_2D),we.activeTexture(U.TEXTURE0),we.pixelStorei(U.UNPACK_FLIP_Y_WEBGL,z.flipY),we.pixelStorei(U.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),we.pixelStorei(U.UNPACK_ALIGNMENT,z.unpackAlignment);let wn=we.getParameter(U.UNPACK_ROW_LENGTH),St=we.getParameter(U.UNPACK_IMAGE_HEIGHT),qs=we.getParameter(U.UNPACK_SKIP_PIXELS),An=we.getParameter(U.UNPACK_SKIP_ROWS),zo=we.getParameter(U.UNPACK_SKIP_IMAGES);we.pixelStorei(U.UNPACK_ROW_LENGTH,Ht.width),we.pixelStorei(U.UNPACK_IMAGE_HEIGHT,Ht.height),we.pixelStorei(U.UNPACK_SKIP_PIXELS,We),we.pixelStorei(U.UNPACK_SKIP_ROWS,st),we.pixelStorei(U.UNPACK_SKIP_IMAGES,yt);let Ts=A.isDataArrayTexture||A.isData3DTexture,Ys=z.isDataArrayTexture||z.isData3DTexture;if(A.isDepthTexture){let gt=ze.get(A),_n=ze.get(z),ui=ze.get(gt.__renderTarget),Wt=ze.get(_n.__renderTarget);we.bindFramebuffer(U.READ_FRAMEBUFFER,ui.__webglFramebuffer),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,Wt.__webglFramebuffer);for(let Tn=0;Tn<Ne;Tn++)Ts&&(U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ze.get(A).__webglTexture,Z,yt+Tn),U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,ze.get(z).__webglTexture,Re,pn+Tn)),U.blitFramebuffer(We,st,We+De,st+Pe,Ge,xt,Ge+De,xt+Pe,U.DEPTH_BUFFER_BIT,U.NEAREST);we.bindFramebuffer(U.READ_FRAMEBUFFER,null),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else if(Z!==0||A.isRenderTargetTexture||ze.has(A)){let gt=ze.get(A),_n=ze.get(z);we.bindFramebuffer(U.READ_FRAMEBUFFER,O),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,$);for(let ui=0;ui<Ne;ui++)Ts?U.framebufferTextureLayer(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,gt.__webglTexture,Z,yt+ui):U.framebufferTexture2D(U.READ_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,gt.__webglTexture,Z),Ys?U.framebufferTextureLayer(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,_n.__webglTexture,Re,pn+ui):U.framebufferTexture2D(U.DRAW_FRAMEBUFFER,U.COLOR_ATTACHMENT0,U.TEXTURE_2D,_n.__webglTexture,Re),Z!==0?U.blitFramebuffer(We,st,We+De,st+Pe,Ge,xt,Ge+De,xt+Pe,U.COLOR_BUFFER_BIT,U.NEAREST):Ys?U.copyTexSubImage3D(Fe,Re,Ge,xt,pn+ui,We,st,De,Pe):U.copyTexSubImage2D(Fe,Re,Ge,xt,We,st,De,Pe);we.bindFramebuffer(U.READ_FRAMEBUFFER,null),we.bindFramebuffer(U.DRAW_FRAMEBUFFER,null)}else Ys?A.isDataTexture||A.isData3DTexture?U.texSubImage3D(Fe,Re,Ge,xt,pn,De,Pe,Ne,Gt,On,Ht.data):z.isCompressedArrayTexture?U.compressedTexSubImage3D(Fe,Re,Ge,xt,pn,De,Pe,Ne,Gt,Ht.data):U.texSubImage3D(Fe,Re,Ge,xt,pn,De,Pe,Ne,Gt,On,Ht):A.isDataTexture?U.texSubImage2D(U.TEXTURE_2D,Re,Ge,xt,De,Pe,Gt,On,Ht.data):A.isCompressedTexture?U.compressedTexSubImage2D(U.TEXTURE_2D,Re,Ge,xt,Ht.width,Ht.height,Gt,Ht.data):U.texSubImage2D(U.TEXTURE_2D,Re,Ge,xt,De,Pe,Gt,On,Ht);we.pixelStorei(U.UNPACK_ROW_LENGTH,wn),we.pixelStorei(U.UNPACK_IMAGE_HEIGHT,St),we.pixelStorei(U.UNPACK_SKIP_PIXELS,qs),we.pixelStorei(U.UNPACK_SKIP_ROWS,An),we.pixelStorei(U.UNPACK_SKIP_IMAGES,zo),Re===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&U.generateMipmap(Fe),we.unbindTexture()},this.initRenderTarget=function(A){ze.get(A).__webglFramebuffer===void 0&&ye.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?ye.setTextureCube(A,0):A.isData3DTexture?ye.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?ye.setTexture2DArray(A,0):ye.setTexture2D(A,0),we.unbindTexture()},this.resetState=function(){q=0,G=0,ce=null,we.reset(),Te.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ns}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=wt._getDrawingBufferColorSpace(e),t.unpackColorSpace=wt._getUnpackColorSpace()}};var Vb={enters:[16,132,74],leaves:[190,44,132],grazes:[232,188,38]};function Hb(n){let[e,t,i]=Vb[n];return`rgb(${e} ${t} ${i})`}function dg(n){return new Qt().setAttribute("position",new Jt(new Float32Array(n),3))}var zd=class{constructor(e){this.bundle=e;for(let t of Bx){let[i,s,r]=Vb[t].map(a=>a/255),o=new dt().setRGB(i,s,r,cn);this.dots.set(t,new Bs({color:o,size:6,sizeAttenuation:!1}))}}bundle;group=new Ln;points=[];lines=[0,0];hitting=new Xi({color:2844356,transparent:!0,opacity:.75});missing=new Xi({color:9081242,transparent:!0,opacity:.2});dots=new Map;get materials(){return[this.hitting,this.missing,...this.dots.values()]}add(e,t){e.frustumCulled=!1,e.renderOrder=t,this.group.add(e)}clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){this.clear();let s=Array.from({length:this.bundle.triangles.length/3},(l,c)=>Fu(this.bundle,c)),r=l=>s[l].flatMap(c=>i(c)),o=new Set(t.map(l=>e.lineOf(l))),a=s.flatMap((l,c)=>o.has(c)?[]:[c]);this.lines=[s.length,o.size],this.add(new qi(dg(a.flatMap(r)),this.missing),3),this.add(new qi(dg([...o].flatMap(r)),this.hitting),4),this.points=t.map(l=>({hit:l,at:i(Vx(s[e.lineOf(l)],e.depthOf(l)))}));for(let[l,c]of this.dots){let u=this.points.filter(({hit:d})=>e.kindOf(d)===l);this.add(new fr(dg(u.flatMap(({at:d})=>d)),c),5)}}clip(e){for(let t of this.materials)t.clippingPlanes=e}dispose(){this.clear(),this.materials.forEach(e=>e.dispose())}};function J3(n,e,t,i){let{hits:s}=t,r=e.parts[0],o=!t.isCut&&n.first_hits!==!0,a=Fu(e.meshes[1],i);return s?zx(s,i,c=>r.partOf(c),c=>o&&e.closed?.[c]===1&&(jn(n)||Hx(a,e.meshes[0],r,c))):[]}function Gb(n){let{line:e,job:t,model:i,contacts:s}=n,r=e<i.meshes[1].triangles.length/3,o=lt(()=>r?J3(t,i,s,e):[],[e,i,s]),{hits:a}=s,l=(a?.ofLine(e)??[]).filter(h=>a?.kindOf(h)==="grazes"),c=h=>i.parts[0].nameOf(a?.triangleOf(h)??0),u=h=>a&&h!==null?Et(a.depthOf(h),6):"",d=({in:h,out:f})=>a&&f!==null?Et(a.depthOf(f)-a.depthOf(h),6):"";return m("section",{"aria-label":"picked line","aria-live":"polite",children:[m("h2",{children:["line ",fe(e)," ",m("button",{type:"button",class:"link",onClick:n.drop,children:"drop"})]}),!r&&m("p",{children:["the bundle has no line ",fe(e)]}),r&&o.length+l.length===0&&m("p",{children:"it hits nothing"}),o.length>0&&m("table",{class:"line-hits",children:[m("caption",{class:"note",children:["from the line's start, in ",t.unit]}),m("thead",{children:m("tr",{children:[m("th",{scope:"col",children:"part"}),m("th",{scope:"col",children:"in"}),m("th",{scope:"col",children:"out"}),m("th",{scope:"col",children:"thickness"})]})}),m("tbody",{children:o.map(h=>m("tr",{children:[m("td",{children:m(et,{text:c(h.in)})}),m("td",{children:u(h.in)}),m("td",{children:u(h.out)}),m("td",{children:d(h)})]},h.in))})]}),l.map(h=>m("p",{class:"note",children:["grazes ",m(et,{text:c(h)})," at ",u(h)]},h))]})}function Wb(){return m("ul",{class:"legend plain",children:[[["enters","the line enters"],["leaves","the line leaves"],["grazes","the line only grazes the surface"]].map(([e,t])=>m("li",{children:[m("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:m("rect",{x:3,y:2,width:8,height:8,fill:Hb(e)})}),t]},e)),m("li",{class:"note",children:"faint lines hit nothing; a click on a hit picks its line"})]})}var K3=4;function $b({job:n,scenario:e,contacts:t,canvas:i,viewer:s,waits:r,root:o,pick:a,pickOther:l}){let c=t?Ci(t.scenario):tr,u=Xt(n)?gi(n,c):[us(n.bodies[0].file),Lt(n)?n.bodies[1].name:us(n.bodies[1].file)],d=Tt([0,0]),h=p=>{let v=Math.hypot(p.clientX-d.current[0],p.clientY-d.current[1]);if(s&&v<K3){let g=s.otherAt(p.offsetX,p.offsetY);a(s.pickAt(p.offsetX,p.offsetY,p.shiftKey)),g!==null&&l(g)}};return m("div",{class:"stage",onWheelCapture:p=>{o&&o.getRootNode().activeElement!==i.current&&p.stopPropagation()},children:[m("canvas",{ref:i,tabIndex:0,role:"img","aria-label":`scenario ${e}: ${t?.scenario.class??""}, ${t?.scenario.count??0} ${_i(n)}s${t?.scenario.near_count?`, ${t.scenario.near_count} near`:""}`,onKeyDown:p=>{p.key==="Enter"&&a(s?.pickMiddle(p.shiftKey)??null)},onPointerDown:p=>{d.current=[p.clientX,p.clientY]},onClick:h}),m("span",{class:"cross-hair","aria-hidden":"true"}),r&&m("p",{class:"wait over",children:["reading ",t||!Xt(n)?`${fe(Br(n,c))} triangles`:"the scenario","…"]}),m("div",{class:"corner",children:[m("span",{class:"swatch a"})," A ",m(et,{text:u[0]})," ",m("span",{class:"swatch b"})," B ",m(et,{text:u[1]}),m("span",{class:"note",children:"drawn in single precision"})]})]})}Le.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new je},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};Mi.line={uniforms:bc.merge([Le.common,Le.fog,Le.line]),vertexShader:`
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
		`};var yr=class extends is{constructor(e){super({type:"LineMaterial",uniforms:bc.clone(Mi.line.uniforms),vertexShader:Mi.line.vertexShader,fragmentShader:Mi.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Xb=new Qn,Vd=new B,so=class extends cc{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new Yn(e,3)),this.setAttribute("uv",new Yn(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new jr(t,6,1);return this.setAttribute("instanceStart",new bs(i,3,0)),this.setAttribute("instanceEnd",new bs(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new jr(t,6,1);return this.setAttribute("instanceColorStart",new bs(i,3,0)),this.setAttribute("instanceColorEnd",new bs(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new nc(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Xb.setFromBufferAttribute(t),this.boundingBox.union(Xb))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Bn),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Vd.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Vd)),Vd.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Vd));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var fg=new zt,qb=new B,Yb=new B,ti=new zt,ni=new zt,Hs=new zt,pg=new B,mg=new vt,ii=new uc,Jb=new B,Hd=new Qn,Gd=new Bn,Gs=new zt,Ws,No;function Kb(n,e,t){return Gs.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),Gs.multiplyScalar(1/Gs.w),Gs.x=No/t.width,Gs.y=No/t.height,Gs.applyMatrix4(n.projectionMatrixInverse),Gs.multiplyScalar(1/Gs.w),Math.abs(Math.max(Gs.x,Gs.y))}function Z3(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){ii.start.fromBufferAttribute(s,a),ii.end.fromBufferAttribute(r,a),ii.applyMatrix4(t);let c=new B,u=new B;Ws.distanceSqToSegment(ii.start,ii.end,u,c),u.distanceTo(c)<No*.5&&e.push({point:u,pointOnLine:c,distance:Ws.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function j3(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),d=-e.near;Ws.at(1,Hs),Hs.w=1,Hs.applyMatrix4(e.matrixWorldInverse),Hs.applyMatrix4(i),Hs.multiplyScalar(1/Hs.w),Hs.x*=r.x/2,Hs.y*=r.y/2,Hs.z=0,pg.copy(Hs),mg.multiplyMatrices(e.matrixWorldInverse,o);for(let h=0,f=u;h<f;h++){if(ti.fromBufferAttribute(l,h),ni.fromBufferAttribute(c,h),ti.w=1,ni.w=1,ti.applyMatrix4(mg),ni.applyMatrix4(mg),ti.z>d&&ni.z>d)continue;if(ti.z>d){let E=ti.z-ni.z,M=(ti.z-d)/E;ti.lerp(ni,M)}else if(ni.z>d){let E=ni.z-ti.z,M=(ni.z-d)/E;ni.lerp(ti,M)}ti.applyMatrix4(i),ni.applyMatrix4(i),ti.multiplyScalar(1/ti.w),ni.multiplyScalar(1/ni.w),ti.x*=r.x/2,ti.y*=r.y/2,ni.x*=r.x/2,ni.y*=r.y/2,ii.start.copy(ti),ii.start.z=0,ii.end.copy(ni),ii.end.z=0;let v=ii.closestPointToPointParameter(pg,!0);ii.at(v,Jb);let g=vc.lerp(ti.z,ni.z,v),_=g>=-1&&g<=1,b=pg.distanceTo(Jb)<No*.5;if(_&&b){ii.start.fromBufferAttribute(l,h),ii.end.fromBufferAttribute(c,h),ii.start.applyMatrix4(o),ii.end.applyMatrix4(o);let E=new B,M=new B;Ws.distanceSqToSegment(ii.start,ii.end,M,E),t.push({point:M,pointOnLine:E,distance:Ws.origin.distanceTo(M),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var qa=class extends Dn{constructor(e=new so,t=new yr({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)qb.fromBufferAttribute(t,o),Yb.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+qb.distanceTo(Yb);let r=new jr(s,2,1);return e.setAttribute("instanceDistanceStart",new bs(r,1,0)),e.setAttribute("instanceDistanceEnd",new bs(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;Ws=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;No=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Gd.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=No*.5;else{let d=Math.max(s.near,Gd.distanceToPoint(Ws.origin));c=Kb(s,d,l.resolution)}if(Gd.radius+=c,Ws.intersectsSphere(Gd)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Hd.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=No*.5;else{let d=Math.max(s.near,Hd.distanceToPoint(Ws.origin));u=Kb(s,d,l.resolution)}Hd.expandByScalar(u),Ws.intersectsBox(Hd)!==!1&&(i?Z3(this,t):j3(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(fg),this.material.uniforms.resolution.value.set(fg.z,fg.w))}};var Q3=.28;function Oo(n){let e=new Yr({flatShading:!0,side:ei});return e.color.setRGB(n[0]/255,n[1]/255,n[2]/255,cn),e}function e2(n,e,t){n.onBeforeCompile=i=>{i.uniforms.heatTable={value:e},i.uniforms.showsHeat=t,i.vertexShader=i.vertexShader.replace("#include <common>",`#include <common>
attribute float heat;
varying float vHeat;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vHeat = heat;`),i.fragmentShader=i.fragmentShader.replace("#include <common>",`#include <common>
uniform sampler2D heatTable;
uniform bool showsHeat;
varying float vHeat;`).replace("#include <color_fragment>",`#include <color_fragment>
                if (showsHeat) {
                    float at = (floor(vHeat * 255.0 + 0.5) + 0.5) / 256.0;
                    diffuseColor.rgb = texture2D(heatTable, vec2(at, 0.5)).rgb;
                }`)}}var Tc=class{constructor(e,t){this.mesh=e;this.corners=Au(e),this.radius=Math.hypot(...e.max.map((o,a)=>o-e.min[a]))/2,this.geometry.setAttribute("position",new Jt(this.corners,3)),this.setHeat(new Uint8Array(this.corners.length/3)),this.geometry.boundingSphere=new Bn(new B,this.radius),this.table=new Co(tx(t),256,1,Ji),this.table.colorSpace=cn,this.table.minFilter=Mn,this.table.magFilter=Mn,this.table.needsUpdate=!0;let i=Oo(t),s=Oo(t),r=Oo(t);for(let o of[i,s,r])o.polygonOffset=!0,o.polygonOffsetFactor=1,o.polygonOffsetUnits=1,e2(o,this.table,this.showsHeat);s.colorWrite=!1,r.polygonOffset=!1,r.transparent=!0,r.opacity=Q3,r.depthWrite=!1,r.depthFunc=Fs,this.materials=[i,s,r],this.solid=this.make(i,0),this.ghost.add(this.make(s,1),this.make(r,2))}mesh;corners;solid;ghost=new Ln;radius;geometry=new Qt;materials;showsHeat={value:!1};table;make(e,t){let i=new Dn(this.geometry,e);return i.matrixAutoUpdate=!1,i.renderOrder=t,i}get triangles(){return this.corners.length/9}setHeat(e){this.geometry.setAttribute("heat",new Jt(e,1,!0))}showHeat(e){this.showsHeat.value=e}showAs(e){this.solid.visible=e==="solid",this.ghost.visible=e==="ghost"}clip(e){for(let t of this.materials)t.clippingPlanes=e}place(e,t){let i=zi(e,this.mesh.centre),s=new vt().set(e[0],e[1],e[2],i[0]-t[0],e[4],e[5],e[6],i[1]-t[1],e[8],e[9],e[10],i[2]-t[2],0,0,0,1);for(let r of[this.solid,...this.ghost.children])r.matrix.copy(s),r.matrixWorldNeedsUpdate=!0;return s}boxCorners(e){let t=this.mesh.max.map((s,r)=>s-this.mesh.centre[r]),i=[-1,1];return i.flatMap(s=>i.flatMap(r=>i.map(o=>new B(s*t[0],r*t[1],o*t[2]).applyMatrix4(e).toArray())))}dispose(){this.geometry.dispose(),this.table.dispose(),this.materials.forEach(e=>e.dispose())}};var gg=3,Uo=4;function Zb(n){return n===Uo?0:n}function jb(n,e){let t=[new Map,new Map];for(let i=0;i+2<n.length;i+=3)e(n[i],n[i+1])&&t.forEach((s,r)=>{let o=n[i+r],a=s.get(o);(a===void 0||Zb(n[i+2])>Zb(a))&&s.set(o,n[i+2])});return t}var t2=["near","touch","proper"];function n2(n){return n===gg?"proper":n===Uo?"near":"touch"}function i2(n,e){return[...n].flatMap(([t,i])=>n2(i)===e?[t]:[])}function s2(n,e){let t=new Float32Array(9*e.length);return e.forEach((i,s)=>t.set(n.subarray(9*i,9*i+9),9*s)),t}function _g(n){let e=new Float32Array(2*n.length);for(let t=0;t<n.length;t+=9){let[i,s,r]=[0,3,6].map(o=>n.subarray(t+o,t+o+3));[i,s,s,r,r,i].forEach((o,a)=>e.set(o,2*t+3*a))}return e}function r2(n,e,t){let i={segments:[],points:[],gaps:[]};for(let s=0;s<n.length;){let r=n[s],o=s,a=[];for(;o<n.length&&n[o]===r;o+=4)a.push(e([n[o+1],n[o+2],n[o+3]]));s=o;let l=t(r);if(l===null)continue;if(l===Uo){i.gaps.push(...a.flat());continue}a.length===1&&i.points.push(...a[0]);let c=a.length>2?a.length:a.length-1;for(let u=0;u<c;++u)i.segments.push(...a[u],...a[(u+1)%a.length])}return i}var Wd=class{group=new Ln;lines=new Ln;red;yellow;orange;outline=new Xi({color:5915904});segment=new yr({color:0,linewidth:2.5});gap=new yr({color:11030016,linewidth:3.5});dot=new Bs({color:0,size:7,sizeAttenuation:!1});constructor(){this.red=Oo(Ei(2)),this.yellow=Oo(Ei(1)),this.orange=Oo(Ei(7)),this.red.emissive.copy(this.red.color).multiplyScalar(.45),this.yellow.emissive.copy(this.yellow.color).multiplyScalar(.35),this.orange.emissive.copy(this.orange.color).multiplyScalar(.35),this.group.add(this.lines)}get materials(){return[this.red,this.yellow,this.orange,this.outline,this.segment,this.gap,this.dot]}clear(){for(let e of[...this.group.children,...this.lines.children])e!==this.lines&&(e.geometry.dispose(),e.removeFromParent())}addBody(e,t,i){let s={near:this.orange,touch:this.yellow,proper:this.red};for(let r of t2){let o=s2(e,i2(t,r));if(o.length===0)continue;let a=new Qt().setAttribute("position",new Jt(o,3));if(this.addPlaced(new Dn(a,s[r]),i),r!=="proper"){let l=new Qt().setAttribute("position",new Jt(_g(o),3));this.addPlaced(new qi(l,this.outline),i)}}}addPlaced(e,t){e.matrixAutoUpdate=!1,e.matrix.copy(t),e.frustumCulled=!1,this.group.add(e)}show(e,t,i){this.clear(),e.forEach((s,r)=>this.addBody(s,t[r],i[r]))}addLines(e,t){if(e.length===0)return;let i=new so().setPositions(new Float32Array(e)),s=new qa(i,t);s.frustumCulled=!1,s.renderOrder=4,this.lines.add(s)}addPoints(e,t,i,s){let o=r2(e,a=>zi(t,a).map((l,c)=>l-i[c]),s);if(this.addLines(o.segments,this.segment),this.addLines(o.gaps,this.gap),o.points.length>0){let a=new Jt(new Float32Array(o.points),3),l=new fr(new Qt().setAttribute("position",a),this.dot);l.frustumCulled=!1,l.renderOrder=5,this.lines.add(l)}return o.gaps.length/6}clip(e){for(let t of this.materials)t.clippingPlanes=e}dispose(){this.clear(),this.materials.forEach(e=>e.dispose())}};var yg=100;function o2(n,e){let t=new Map;for(let i=0;i+2<n.length;i+=3){let[s,r]=[0,1].map(c=>e[c].nameOf(n[i+c])),o=`${s.length}:${s}${r}`,a=t.get(o),l=n[i+2]===Uo?1:0;a?(a.count+=1,a.near+=l):t.set(o,{a:s,b:r,count:1,near:l})}return[...t.values()].sort((i,s)=>s.count-i.count)}function Qb(n){let{state:e,bodies:t}=n,i=(c,u)=>t?`${t[c]}/${u}`:u,s=c=>t?t[c]:`all of ${"AB"[c]}`,r=lt(()=>o2(n.contacts.pairs,n.model.parts),[n.contacts,n.model]);if(r.length===0&&!e.partA&&!e.partB)return null;let o=n.contacts.hits!==null,a=o?"parts hit here":r.some(c=>c.near>0)?"parts in contact or near here":"parts in contact here",l=c=>e.partA===c.a&&e.partB===c.b;return m("section",{"aria-label":a,children:[m("h2",{children:a}),m("ul",{class:"pairs",children:r.slice(0,yg).map(c=>m("li",{children:m("button",{type:"button","aria-pressed":l(c),onClick:()=>l(c)?n.choose("",""):n.choose(c.a,c.b),children:[m("span",{children:[m(et,{text:i(0,c.a)}),!o&&m(Pt,{children:[" ",m("i",{children:"×"})," ",m(et,{text:i(1,c.b)})]})]}),m("b",{children:[fe(c.count),c.near>0&&m("i",{children:[" (",fe(c.near)," near)"]})]})]})},`${c.a}
${c.b}`))}),r.length>yg&&m("p",{class:"note",children:["and ",ft(r.length-yg,"pair")," of parts more"]}),(e.partA||e.partB)&&m("p",{class:"note",children:["only ",m(et,{text:e.partA?i(0,e.partA):s(0)})," ×"," ",m(et,{text:e.partB?i(1,e.partB):s(1)}),";"," ",m("button",{type:"button",class:"link",onClick:()=>n.choose("",""),children:"show all"})]})]})}function eS(n){let{pick:e,job:t}=n,i=n.model.meshes[e.body],s=n.model.parts[e.body],r=e.triangle<i.triangles.length/3,o=lt(()=>{let l=0,c=n.contacts?.pairs??new Uint32Array;for(let u=e.body;u<c.length;u+=3)l+=c[u]===e.triangle?1:0;return l},[n.contacts,e]),a=n.heat?.counts[e.body][e.triangle];return m("section",{"aria-label":"picked triangle","aria-live":"polite",children:[m("h2",{children:["picked"," ",m("button",{type:"button",class:"link",onClick:n.drop,children:"drop"})]}),r?m("p",{children:[e.body===0?"A":"B"," triangle ",m("b",{children:fe(e.triangle)}),", ",m(et,{text:s.nameOf(e.triangle)})," ",fe(s.placeOf(e.triangle)),"; in ",ft(o,_i(t))," here",a!==void 0&&(Lt(t)?`; crossed ${ft(a,"time")} in all`:`; in ${fe(a)} of ${ft(t.done,"pose")} (${Sn(a/Math.max(1,t.done))})`)]}):m("p",{children:["the mesh has no triangle ",fe(e.triangle)]})]})}function xg({pose:n,title:e}){let t=[n.slice(0,4),n.slice(4,8),n.slice(8,12),[0,0,0,1]];return m("table",{class:"matrix",children:[m("caption",{children:e}),m("tbody",{children:t.map((i,s)=>m("tr",{children:i.map((r,o)=>m("td",{children:String(r)},o))},s))})]})}function a2(n){return xo.map(e=>`${e} ${Et(Or(e,n),5)}°`).join("  ")}function tS({job:n,contacts:e,tau:t}){let i=Ru(e.scenario,t);if(jn(n))return m("section",{"aria-label":"direction",children:[m("h2",{children:"where the lines come from"}),m("p",{children:a2(i)}),m("details",{children:[m("summary",{children:"matrix"}),m(xg,{pose:i,title:"the bundle in A's frame"})]})]});let s=by(i),r=Ml.filter(l=>l!=="distance"&&(!sr(l)||Math.abs(s[l])>1e-9)).map(l=>`${l} ${Et(s[l],5)}${sr(l)?"°":""}`),{pose_a:o,pose_b:a}=Cl(e.scenario,t);return m("section",{"aria-label":"pose",children:[m("h2",{children:"B in A's frame"}),m("p",{children:[r.join("  ")," ",m("span",{class:"note",children:["lengths in ",n.unit]})]}),m("details",{children:[m("summary",{children:"matrix"}),n.poses.of_both_bodies&&m(xg,{pose:o,title:"A in the world"}),m(xg,{pose:n.poses.of_both_bodies?a:i,title:n.poses.of_both_bodies?"B in the world":"B in A's frame"})]})]})}function nS({model:n,contacts:e}){let t=n?.meshes.filter(r=>r.checked===!1)??[],i=n?.meshes.some(r=>r.checked===null)??!1,s=e?.scenario;return m(Pt,{children:[t.length>0&&m(Ct,{kind:"bad",children:["not the tested geometry: the bytes of ",ft(t.length,"mesh").replace("meshs","meshes")," do not have the SHA-256 of the run (",t.map(r=>r.sha256.slice(0,16)).join(", "),")"]}),t.length===0&&i&&m(Ct,{kind:"warn",children:"the geometry is not checked: this browser computes SHA-256 on 127.0.0.1 or over TLS only"}),s?.verified===!1&&m(Ct,{kind:"bad",children:["this scenario, run again, gives another record than the stored one: ",s.verify_note]}),s&&s.draw_note!==""&&m(Ct,{kind:"warn",children:["nothing is drawn: ",s.draw_note]}),s&&s.failure!==""&&m(Ct,{kind:"bad",children:["failed: ",m(et,{text:s.failure})]})]})}function l2(n,e){let t=i=>`${Et(i,6)} ${n.unit} apart`;return typeof e.distance=="number"?`the bodies are ${t(e.distance)}`:e.distance===null?e.class==="separate"&&typeof n.up_to=="number"?`more than ${t(n.up_to)}`:"":e.least_distance===null?"":`nearest triangles ${t(e.least_distance)}`}function iS({job:n,contacts:e}){let{scenario:t}=e,i=ra(t.class),s=t.class!==null&&t.count>0?ft(t.count,_i(n)):"",r=t.near_count>0?ft(t.near_count,"near pair"):"",o=[l2(n,t),t.motion?hx(t.motion,fa(t)):"",n.first_hits?"the first hit of each line":"",i===3?"one body is inside the other: g changes the ghost":"",t.id!==null?`id ${t.id}`:"",t.time!==null?`t ${Et(t.time,6)}`:"",e.isCut?`drawn: the first ${fe(e.pairs.length/3)} ${_i(n)}s`:"",t.cut?`list of ${_i(n)}s cut at ${fe(t.listed)}`:"",t.surfaces_only?"surfaces only: a body is open":"",t.insides_skipped?"containment not tested: triangles are ignored":"",t.distance_bound!==null&&t.distance_bound>0?`at most ${Et(t.distance_bound)} ${n.unit} apart`:""].filter(a=>a!=="");return m("span",{class:"scenario-status",children:[m("span",{children:[m(mi,{kind:i}),m("b",{children:t.class??"no result yet"}),s&&`, ${s}`,r&&`, ${r}`]}),t.verified===!0&&m("span",{class:"verified",title:"run again, the record has the same bytes",children:"✓ verified"}),t.verified===null&&m("span",{class:"note",title:t.verify_note,children:["not verified",t.verify_note&&`: ${t.verify_note}`]}),o.length>0&&m("span",{class:"note",children:o.join(" · ")})]})}function c2({job:n,contacts:e}){let[t,i]=gi(n,Ci(e.scenario));return m("b",{class:"pair-names",children:[m(et,{text:t})," ",m("i",{children:"×"})," ",m(et,{text:i})]})}function sS(n){let{job:e,scenarios:t}=n,i=m(et,{text:e.name||e.job}),s=r=>n.move(t.placeOf(Math.round(Number(r))||0));return m("div",{class:"viewer-head",children:[m("h1",{children:[n.isInReport?i:m("a",{href:Ks(e.job),children:i})," ",m("span",{class:"note",children:"›"})," ",m("label",{class:"number",children:["#",m("input",{type:"number","aria-label":"scenario",min:t.at(0),max:t.at(t.count-1),value:n.scenario,onChange:r=>s(r.currentTarget.value)})]})]}),n.contacts&&Xt(e)&&m(c2,{job:e,contacts:n.contacts}),n.contacts&&m(iS,{job:e,contacts:n.contacts})]})}function $d(n){return{contact:"contact",near:"near scenario",either:"contact or near scenario"}[n]}function u2({seek:n,choose:e}){return m("select",{"aria-label":"what previous and next find",value:n,onChange:t=>e(t.currentTarget.value),children:[m("option",{value:"contact",children:"contacts"}),m("option",{value:"near",children:"near"}),m("option",{value:"either",children:"both"})]})}function rS(n){let{scenarios:e,search:t,isPlaying:i,play:s}=n,r=e.count-1;return m("div",{class:"scrub",children:[m("button",{type:"button",onClick:()=>t.start(-1),title:"p",children:["‹ previous ",$d(n.seek)]}),m("button",{type:"button",onClick:()=>t.start(1),title:"n",children:["next ",$d(n.seek)," ›"]}),n.chooseSeek&&m(u2,{seek:n.seek,choose:n.chooseSeek}),m("input",{type:"range","aria-label":n.isInReport?"scenarios of this report":`scenario, 0 to ${r}`,min:0,max:r,value:n.place,onInput:o=>n.move(Number(o.currentTarget.value))}),s&&m("button",{type:"button",onClick:()=>s(!i),title:"space","aria-pressed":i,children:i?"stop":"play"}),n.children,m("span",{class:"note","aria-live":"polite",children:t.said})]})}var Xd=class{constructor(e,t){this.total=e;this.chosen=t?[...t].sort((i,s)=>i-s):null}total;chosen;get count(){return this.chosen?.length??this.total}at(e){let t=Math.min(this.count-1,Math.max(0,e));return this.chosen?this.chosen[t]:t}placeOf(e){if(!this.chosen)return Math.min(this.total-1,Math.max(0,e));let t=this.chosen.map(i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}};var lS=({partA:n,partB:e})=>!n&&!e;function Ya(n,e){return`jobs/${encodeURIComponent(n)}/scenarios/${e}`}async function oS(n,e){let{job:t,step:i,signal:s,tell:r}=n,[o,a]=n.within??[0,1/0],l=i>0?Math.max(n.from,o-1):Math.min(n.from,a),c=h=>i>0?h>=a:h<o,u=new URLSearchParams({from:String(l),step:String(i)});e.seek!=="contact"&&u.set("class",e.seek);let d=gi(t,e.bodies);for(["a","b"].forEach((h,f)=>{let p=[e.partA,e.partB][f];p&&u.set(`part_${h}`,p),p&&Xt(t)&&u.set(`body_${h}`,d[f])}),e.filter?.body&&u.set("body",e.filter.body);;){let h=await Ai(Ya(t.job,`next?${u}`),s);if(h.index!==null||h.searched_to===null)return h.index===null||c(h.index)?null:h.index;if(c(h.searched_to))return null;r(h.searched_to),u.set("from",String(h.searched_to))}}function cS(n,{partA:e,partB:t,seek:i,bodies:s},r,o){let a=[e,t].flatMap((l,c)=>l?[{part:l,side:o.indexOf(s[c]),of:r[c]}]:[]);if(a.some(({side:l})=>l<0))return!1;for(let l=0;l+2<n.length;l+=3)if((i==="either"||n[l+2]===Uo==(i==="near"))&&a.every(u=>u.of.isOf(n[l+u.side],u.part)))return!0;return!1}async function aS(n){for(;;)try{return await n()}catch(e){if(!(e instanceof wi&&e.isBusy))throw e;await zc()}}async function h2({job:n,signal:e},t,i,s){let r=await aS(()=>Ai(Ya(n.job,String(t)),e));if(r.exact_pairs===0)return r.draw_note!=="";let o=await aS(()=>Kt(Ya(n.job,`${t}/pairs`),e));return o.cut||cS(o.values,i,s,Ci(r))}function d2(n,{partA:e,bodies:t,filter:i}){return Xt(n)&&!i?.body?gi(n,t)[e?0:1]:i?.body??""}async function uS(n,e,t){let{level:i}=n.job;if(lS(e)||i==="pairs"||i==="contacts")return oS(n,e);let s=await t();[e.partA,e.partB].forEach((o,a)=>{if(o&&!s[a].names.includes(o))throw new Error(`the body has no part '${o}'`)});let r={...e,partA:"",partB:"",filter:{body:d2(n.job,e)}};for(let o=n.from;;n.tell(o)){let a=await oS({...n,from:o},r);if(a===null||await h2(n,a,e,s))return a;o=a}}async function f2(n,e,{seek:t}){if(n.clearance===null||t==="either")return!0;let i=await Ai(Ya(n.job,String(e)));return ra(i.class)===7==(t==="near")}async function p2(n,e,t,i){let s=await Ai(Ya(n.job,String(e))),r=await Kt(Ya(n.job,`${e}/pairs`));return cS(r.values,t,i,Ci(s))}async function hS({job:n,from:e,step:t},i,s,r){let o=i.filter(a=>(a-e)*t>0).sort((a,l)=>(a-l)*t);for(let a of o)if(await f2(n,a,s)&&(lS(s)||await p2(n,a,s,r)))return a;return null}function dS(n,e,t,i,s){let[r,o]=$e(""),a=Tt(null),l=()=>{a.current&&(a.current.stop.abort(),a.current=null,o(u=>u.replace("searching","stopped")))},c=async u=>{if(a.current?.by===u)return;l(),o("");let d={by:u,stop:new AbortController};a.current=d;try{let h=await n(u,d.stop.signal,f=>{a.current===d&&o(`searching, at #${fe(f)}`)});if(a.current!==d)return;a.current=null,h!==null?(o(""),e(h)):o(`no ${i} ${u>0?"after":"before"} this scenario${t?"":" so far"}`)}catch(h){a.current===d&&(a.current=null,o(ls(h)?"":Rn(h)))}};return ke(()=>()=>{l(),o("")},s),{said:r,start:u=>{c(u)},stop:l}}var qd=class{constructor(e,t,i,s,r){this.job=e;this.hasLines=t;this.modelOf=i;this.show=s;this.fail=r}job;hasLines;modelOf;show;fail;wanted=null;isLoading=!1;stop=new AbortController;want(e){this.wanted=e,this.isLoading||this.run()}close(){this.wanted=null,this.stop.abort()}async run(){for(this.isLoading=!0;this.wanted!==null;){let e=this.wanted;try{let t=await this.load(e);this.wanted=this.wanted===e?null:this.wanted,this.show(t)}catch(t){if(ls(t)||this.stop.signal.aborted)break;t instanceof wi&&t.isBusy?await zc():(this.wanted=this.wanted===e?null:this.wanted,this.fail(e,t))}}this.isLoading=!1}async load(e){let t=`jobs/${encodeURIComponent(this.job)}/scenarios/${e}`,i=await Ai(t,this.stop.signal),[s,r]=await Promise.all([this.loadContacts(t,i),this.modelOf(i)]);return{...s,model:r}}async loadContacts(e,t){let i=this.stop.signal;if(t.class===null||t.exact_pairs===0){let a=new Uint32Array,l=this.hasLines?new Pl(a,new Float64Array):null;return{scenario:t,pairs:a,points:new Float64Array,hits:l,isCut:!1}}let s=await Kt(`${e}/pairs`,i),r=s.values;if(this.hasLines){let a=await Kt(`${e}/hits`,i),l=new Pl(r,a.values);return{scenario:t,pairs:r,points:new Float64Array,hits:l,isCut:s.cut}}let o=await Kt(`${e}/points`,i);return{scenario:t,pairs:r,points:o.values,hits:null,isCut:s.cut||o.cut}}};var m2=["free","open","event","unknown"],Yd=class{group=new Ln;points=[];lines=new Map;dot=new Bs({size:10,sizeAttenuation:!1});constructor(){for(let e of m2)this.lines.set(e,new yr({linewidth:3}))}clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){this.clear();let s=o=>o.map((a,l)=>a-t[l]),r=e.map(({points:o,kind:a})=>({points:o.map(s),kind:a}));this.points=r.flatMap(({points:o})=>o);for(let[o,a]of this.lines)a.color=fS(o,i);this.dot.color=fS("event",i),r.forEach(o=>this.add(o))}add({points:e,kind:t}){let i=this.lines.get(t);if(e.length===1||!i){let r=new Jt(new Float32Array(e.flat()),3);this.place(new fr(new Qt().setAttribute("position",r),this.dot),5);return}let s=e.slice(1).flatMap((r,o)=>[...e[o],...r]);this.place(new qa(new so().setPositions(new Float32Array(s)),i),4)}place(e,t){e.frustumCulled=!1,e.renderOrder=t,this.group.add(e)}clip(e){for(let t of[...this.lines.values(),this.dot])t.clippingPlanes=e}dispose(){this.clear(),[...this.lines.values(),this.dot].forEach(e=>e.dispose())}};function fS(n,e){let[t,i,s]=$p(n,e).map(r=>r/255);return new dt().setRGB(t,i,s,cn)}var Jd=class{group=new Ln;face=new Ua({color:2068479,side:ei,transparent:!0,opacity:.55});edge=new Xi({color:675742});clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){if(this.clear(),!e||!t||9*t.triangle>=e.length)return;let s=e.slice(9*t.triangle,9*t.triangle+9),r=a=>new Qt().setAttribute("position",new Jt(a,3)),o=[new Dn(r(s),this.face),new qi(r(_g(s)),this.edge)];for(let a of o)a.matrixAutoUpdate=!1,a.matrix.copy(i[t.body]),a.frustumCulled=!1,this.group.add(a)}dispose(){this.clear(),this.face.dispose(),this.edge.dispose()}};function Kd(n,{origin:[e,t,i],direction:[s,r,o]},a){let l=null,c=1/0;for(let u=0;u<n.length;u+=9){let d=n[u],h=n[u+1],f=n[u+2],p=n[u+3]-d,v=n[u+4]-h,g=n[u+5]-f,_=n[u+6]-d,b=n[u+7]-h,E=n[u+8]-f,M=r*E-o*b,I=o*_-s*E,C=s*b-r*_,y=p*M+v*I+g*C;if(y===0)continue;let T=e-d,k=t-h,D=i-f,L=(T*M+k*I+D*C)/y;if(!(L>=0&&L<=1))continue;let H=k*g-D*v,V=D*p-T*g,O=T*v-k*p,$=(s*H+r*V+o*O)/y;if(!($>=0&&L+$<=1))continue;let q=(_*H+b*V+E*O)/y;q>0&&q<c&&!a(q)&&(c=q,l={triangle:u/9,distance:q})}return l}function vg({origin:n,direction:e},t){let i=t.clone().invert();return{origin:new B(...n).applyMatrix4(i).toArray(),direction:new B(...e).transformDirection(i).toArray()}}function bg(n,e,t){let i=n?"xyz".indexOf(n.axis):0,s=n?n.at-e[i]:1/0;return r=>t.origin[i]+r*t.direction[i]>s}function g2({corners:n,triangles:e}){if(!e)return n;let t=new Float32Array(9*e.length);return e.forEach((i,s)=>t.set(n.subarray(9*i,9*i+9),9*s)),t}function pS(n,e,t){let i=1/0,s=null;for(let r of e){let o=Kd(g2(r),vg(n,r.matrix),t);o&&o.distance<i&&(i=o.distance,s={body:r.body,triangle:r.triangles?r.triangles[o.triangle]:o.triangle})}return s}function mS(n,e){let t=e.map(s=>{let[r,o,a]=[0,3,6].map(l=>new B().fromArray(n,9*s+l));return r.add(o).add(a).divideScalar(3)}),i=t.reduce((s,r)=>s.add(r),new B).divideScalar(Math.max(1,t.length));return{centre:i,radius:t.reduce((s,r)=>Math.max(s,r.distanceTo(i)),0)}}function gS(n,e){let[t,i]=[n.clone().subScalar(e),n.clone().addScalar(e)];return[t,i].flatMap(({x:s,z:r})=>[t,i].map(({y:o})=>[s,o,r]))}var Ja=.38,_2=.26;function _S({pose:n,low:e,size:t}){return Array.from({length:8},(i,s)=>zi(n,e.map((r,o)=>r+(s>>o&1)*t[o])))}var yS=[0,1,2].flatMap(n=>Array.from({length:8},(e,t)=>t).filter(e=>(e>>n&1)===0).map(e=>[e,e+(1<<n)]));function y2(n,e,t){let i=zi(n,e);return new vt().set(n[0],n[1],n[2],i[0]-t[0],n[4],n[5],n[6],i[1]-t[1],n[8],n[9],n[10],i[2]-t[2],0,0,0,1)}var Zd=class{group=new Ln;bodies=[];reach=0;centres=[];shapes=[];depth=new Yr({flatShading:!0,side:ei,colorWrite:!1});veil=new Yr({flatShading:!0,side:ei,transparent:!0,opacity:_2,depthWrite:!1,depthFunc:Fs});line=new Xi({transparent:!0,opacity:.5});constructor(){this.veil.color.setRGB(Ja,Ja,Ja,cn),this.line.color.setRGB(Ja,Ja,Ja,cn)}place(e,t,i){let s=this.bodies.map(a=>({...a,pose:Sl(e,a.poseAt(i))})),r=this.shapes;this.clear(),this.shapes=[];for(let a of s)if(a.mesh){let l=this.shapeOf(a.mesh,r);l.bodies.push(a.body),l.matrices.push(y2(a.pose,a.mesh.centre,t))}r.filter(a=>!this.shapes.some(({mesh:l})=>l===a.mesh)).forEach(a=>a.geometry.dispose()),this.shapes.forEach(a=>this.addInstances(a)),this.addBoxes(s.filter(({mesh:a})=>a===null),t);let o=s.flatMap(_S);this.centres=s.map(({body:a,pose:l,low:c,size:u})=>({body:a,centre:zi(l,c.map((d,h)=>d+u[h]/2))})),this.reach=o.reduce((a,l)=>Math.max(a,Math.hypot(...l.map((c,u)=>c-t[u]))),0)}clear(){for(let e of this.group.children)e instanceof Fa?e.dispose():e instanceof qi&&e.geometry.dispose();this.group.clear()}shapeOf(e,t){let i=this.shapes.find(l=>l.mesh===e);if(i)return i;let s=t.find(l=>l.mesh===e),r=s?.corners??Au(e),o=s?.geometry??new Qt().setAttribute("position",new Jt(r,3)),a={mesh:e,corners:r,geometry:o,bodies:[],matrices:[]};return this.shapes.push(a),a}addInstances({geometry:e,matrices:t}){[this.depth,this.veil].forEach((i,s)=>{let r=new Fa(e,i,t.length);t.forEach((o,a)=>r.setMatrixAt(a,o)),r.frustumCulled=!1,r.renderOrder=s,this.group.add(r)})}addBoxes(e,t){if(e.length===0)return;let i=new Float32Array(e.length*yS.length*6),s=0;for(let a of e){let l=_S(a);for(let c of yS.flat())i.set(l[c].map((u,d)=>u-t[d]),s),s+=3}let r=new Qt().setAttribute("position",new Jt(i,3)),o=new qi(r,this.line);o.frustumCulled=!1,this.group.add(o)}clip(e){for(let t of[this.depth,this.veil,this.line])t.clippingPlanes=e}bodyAt(e,t){let i=1/0,s=null;for(let{corners:r,bodies:o,matrices:a}of this.shapes)a.forEach((l,c)=>{let u=Kd(r,vg(e,l),t);u&&u.distance<i&&([i,s]=[u.distance,o[c]])});return s}dispose(){this.clear(),this.shapes.forEach(e=>e.geometry.dispose()),[this.depth,this.veil,this.line].forEach(e=>e.dispose())}};var xS={type:"change"},Mg={type:"start"},bS={type:"end"},jd=new Xr,vS=new xi,x2=Math.cos(70*vc.DEG2RAD),Hn=new B,Li=2*Math.PI,Ft={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Sg=1e-6,Qd=class extends hc{constructor(e,t=null){super(e,t),this.state=Ft.NONE,this.target=new B,this.cursor=new B,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Qr.ROTATE,MIDDLE:Qr.DOLLY,RIGHT:Qr.PAN},this.touches={ONE:eo.ROTATE,TWO:eo.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new B,this._lastQuaternion=new Wi,this._lastTargetPosition=new B,this._quat=new Wi().setFromUnitVectors(e.up,new B(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new za,this._sphericalDelta=new za,this._scale=1,this._panOffset=new B,this._rotateStart=new je,this._rotateEnd=new je,this._rotateDelta=new je,this._panStart=new je,this._panEnd=new je,this._panDelta=new je,this._dollyStart=new je,this._dollyEnd=new je,this._dollyDelta=new je,this._dollyDirection=new B,this._mouse=new je,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=b2.bind(this),this._onPointerDown=v2.bind(this),this._onPointerUp=S2.bind(this),this._onContextMenu=R2.bind(this),this._onMouseWheel=A2.bind(this),this._onKeyDown=T2.bind(this),this._onTouchStart=E2.bind(this),this._onTouchMove=C2.bind(this),this._onMouseDown=M2.bind(this),this._onMouseMove=w2.bind(this),this._interceptControlDown=P2.bind(this),this._interceptControlUp=I2.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Ft.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(xS),this.update(),this.state=Ft.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Hn.copy(t).sub(this.target),Hn.applyQuaternion(this._quat),this._spherical.setFromVector3(Hn),this.autoRotate&&this.state===Ft.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=Li:i>Math.PI&&(i-=Li),s<-Math.PI?s+=Li:s>Math.PI&&(s-=Li),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Hn.setFromSpherical(this._spherical),Hn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Hn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Hn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new B(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new B(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Hn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(jd.origin.copy(this.object.position),jd.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(jd.direction))<x2?this.object.lookAt(this.target):(vS.setFromNormalAndCoplanarPoint(this.object.up,this.target),jd.intersectPlane(vS,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Sg||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Sg||this._lastTargetPosition.distanceToSquared(this.target)>Sg?(this.dispatchEvent(xS),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?Li/60*this.autoRotateSpeed*e:Li/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Hn.setFromMatrixColumn(t,0),Hn.multiplyScalar(-e),this._panOffset.add(Hn)}_panUp(e,t){this.screenSpacePanning===!0?Hn.setFromMatrixColumn(t,1):(Hn.setFromMatrixColumn(t,0),Hn.crossVectors(this.object.up,Hn)),Hn.multiplyScalar(e),this._panOffset.add(Hn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Hn.copy(s).sub(this.target);let r=Hn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Li*this._rotateDelta.x/t.clientHeight),this._rotateUp(Li*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(Li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-Li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(Li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-Li*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(Li*this._rotateDelta.x/t.clientHeight),this._rotateUp(Li*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new je,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function v2(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function b2(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function S2(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(bS),this.state=Ft.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function M2(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Qr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Ft.DOLLY;break;case Qr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ft.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ft.ROTATE}break;case Qr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Ft.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Ft.PAN}break;default:this.state=Ft.NONE}this.state!==Ft.NONE&&this.dispatchEvent(Mg)}function w2(n){switch(this.state){case Ft.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Ft.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Ft.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function A2(n){this.enabled===!1||this.enableZoom===!1||this.state!==Ft.NONE||(n.preventDefault(),this.dispatchEvent(Mg),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(bS))}function T2(n){this.enabled!==!1&&this._handleKeyDown(n)}function E2(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case eo.ROTATE:if(this.enableRotate===!1){this.state=Ft.NONE;break}this._handleTouchStartRotate(n),this.state=Ft.TOUCH_ROTATE;break;case eo.PAN:if(this.enablePan===!1){this.state=Ft.NONE;break}this._handleTouchStartPan(n),this.state=Ft.TOUCH_PAN;break;default:this.state=Ft.NONE}break;case 2:switch(this.touches.TWO){case eo.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Ft.TOUCH_DOLLY_PAN;break;case eo.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Ft.TOUCH_DOLLY_ROTATE;break;default:this.state=Ft.NONE}break;default:this.state=Ft.NONE}this.state!==Ft.NONE&&this.dispatchEvent(Mg)}function C2(n){switch(this._trackPointer(n),this.state){case Ft.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Ft.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Ft.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Ft.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Ft.NONE}}function R2(n){this.enabled!==!1&&n.preventDefault()}function P2(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function I2(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var L2=1.08,SS=new B(.75,-1,.6).normalize();function D2(){let n=new Yl;return n.add(new rc(16777215,10133670,1.9)),n}var ef=class{constructor(e,t,i){this.canvas=e;this.moved=t;this.drawn=i;this.renderer=new Fd({canvas:e,antialias:!0}),this.renderer.outputColorSpace=cn,this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.camera.up.set(0,0,1),this.controls=new Qd(this.camera,e),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.addEventListener("change",this.change),e.addEventListener("webglcontextrestored",this.draw),this.watcher=new ResizeObserver(()=>this.resize()),this.watcher.observe(e),this.resize()}canvas;moved;drawn;frames=0;renderer;camera=new vi(35,1,.01,1e3);controls;lamp=new lc(16777215,2.3);layers=[];watcher;isWaiting=!1;isPlacing=!1;radius=1;change=()=>{this.draw(),this.isPlacing||this.moved()};draw=()=>{this.isWaiting||(this.isWaiting=!0,requestAnimationFrame(()=>{this.isWaiting=!1,this.render(),this.drawn()}))};resize(){let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];e>0&&t>0&&(this.renderer.setPixelRatio(Math.min(2,devicePixelRatio)),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.draw())}setBackground(e){this.renderer.setClearColor(new dt(e)),this.draw()}setLayers(e){this.layers=e.map(({objects:t,forgetsDepth:i})=>{let s=D2();return s.add(...t),{scene:s,forgetsDepth:i}}),this.draw()}render(){let e=this.camera.position.distanceTo(this.controls.target),t=this.camera.position.length()+this.radius;this.camera.near=Math.max(e/500,(t-2*this.radius)/2,t/1e5),this.camera.near=Math.min(this.camera.near,e/2),this.camera.far=2*t,this.camera.updateProjectionMatrix(),this.lamp.position.copy(this.camera.position),this.lamp.target.position.copy(this.controls.target),this.renderer.clear();for(let{scene:i,forgetsDepth:s}of this.layers)s&&this.renderer.clearDepth(),i.add(this.lamp,this.lamp.target),this.renderer.render(i,this.camera);this.frames+=1}fit(e,t,i){let s=new B(...e),r=i?SS.clone():this.camera.position.clone().sub(this.controls.target).normalize(),o=new B().crossVectors(this.camera.up,r).normalize(),a=new B().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360),c=l*this.camera.aspect,u=1e-9;for(let d of t){let h=new B(...d).sub(s),f=Math.max(Math.abs(h.dot(o))/c,Math.abs(h.dot(a))/l);u=Math.max(u,f+h.dot(r))}this.look(s.clone().addScaledVector(r,L2*u),s)}get isAtStart(){return this.camera.position.clone().sub(this.controls.target).normalize().distanceTo(SS)<1e-6}look(e,t){this.isPlacing=!0,this.controls.target.copy(t),this.camera.position.copy(e),this.controls.update(),this.isPlacing=!1,this.draw()}turn(e,t){let i=this.controls.target,s=this.camera.position.clone().sub(i),r=s.length(),o=Math.atan2(s.y,s.x)+e,a=Math.min(Math.PI-.01,Math.max(.01,Math.acos(s.z/r)-t)),l=r*Math.sin(a);s.set(l*Math.cos(o),l*Math.sin(o),r*Math.cos(a)),this.look(s.add(i),i.clone()),this.moved()}approach(e){let t=this.controls.target,i=this.camera.position.clone().sub(t).multiplyScalar(e);this.look(i.add(t),t.clone()),this.moved()}move(e,t){let i=this.controls.target,s=this.camera.position.distanceTo(i);this.camera.updateMatrix();let r=new B().addScaledVector(new B().setFromMatrixColumn(this.camera.matrix,0),e*s).addScaledVector(new B().setFromMatrixColumn(this.camera.matrix,1),t*s);this.look(this.camera.position.clone().add(r),i.clone().add(r)),this.moved()}setRadius(e){this.radius=e}get view(){return[...this.camera.position.toArray(),...this.controls.target.toArray()]}set view(e){this.look(new B().fromArray(e,0),new B().fromArray(e,3))}rayAt(e,t){let i=new je(2*e/this.canvas.clientWidth-1,1-2*t/this.canvas.clientHeight),s=this.camera;s.updateMatrixWorld();let o=new B(i.x,i.y,.5).unproject(s).sub(this.camera.position).normalize();return{origin:this.camera.position.toArray(),direction:o.toArray()}}pixelOf(e){this.camera.updateMatrixWorld();let t=new B(...e).project(this.camera);return[(t.x+1)/2*this.canvas.clientWidth,(1-t.y)/2*this.canvas.clientHeight]}picture(){return this.render(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}async save(e){let t=await this.picture();if(t){let i=document.createElement("a");i.href=URL.createObjectURL(t),i.download=`${e}.png`.replaceAll(/[^\w.-]+/g,"_"),i.click(),setTimeout(()=>URL.revokeObjectURL(i.href),1e3)}}dispose(){this.watcher.disconnect(),this.controls.dispose(),this.canvas.removeEventListener("webglcontextrestored",this.draw),this.renderer.dispose(),this.renderer.forceContextLoss()}};function MS(n,e){let t=new B(n==="x"?-1:0,n==="y"?-1:0,n==="z"?-1:0);return new xi(t,e)}var wg={mode:"contacts",ghost:"b",throughWalls:!0,lines:!0,clip:null,camera:null,partA:"",partB:"",pick:null,seek:"contact",onlyFirst:!1,tau:null,others:!0,filter:yo};function N2(n,e){let t=(n??"").split(",").map(Number);return t.length===e&&t.every(Number.isFinite)&&n?t:null}function O2(n){let e=/^([xyz]):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(n??"");return e&&Number.isFinite(Number(e[2]))?{axis:e[1],at:Number(e[2])}:null}function U2(n){let e=/^([ab]):(\d+)$/.exec(n??"");return e?{body:e[1]==="a"?0:1,triangle:Number(e[2])}:null}function F2(n){let e=Number(n);return n&&e>=0&&e<=1?e:null}function Ag(n,e){let t=["",""];for(let i of[n.get("part"),n.get("with")])if(i){let{body:s,part:r}=gy(i,{...e,hasA:o=>t[0]===""&&e.hasA(o)});t[s]=r}return t}function AS(n,e){return Object.entries(n).every(([t,i])=>t==="camera"||i===e[t])}function Tg(n,e){let t=n.get("ghost"),i=n.get("seek"),[s,r]=Ag(n,e);return{mode:n.get("mode")==="heat"?"heat":"contacts",ghost:t==="a"||t==="none"?t:"b",throughWalls:n.get("walls")!=="0",lines:n.get("lines")!=="0",clip:O2(n.get("clip")),camera:N2(n.get("cam"),6),partA:s,partB:r,pick:U2(n.get("pick")),seek:i==="near"||i==="either"?i:"contact",onlyFirst:n.get("first")==="1",tau:F2(n.get("tau")),others:n.get("others")!=="0",filter:_u(n)}}function wS(n){return String(Number(n.toPrecision(6)))}function TS(n,e){let t={};return n.mode!==wg.mode&&(t.mode=n.mode),n.camera&&(t.cam=n.camera.map(wS).join(",")),n.ghost!==wg.ghost&&(t.ghost=n.ghost),n.throughWalls||(t.walls="0"),n.lines||(t.lines="0"),n.partA&&(t.part=Nr(0,n.partA,e)),n.partB&&(t[n.partA?"with":"part"]=Nr(1,n.partB,e)),n.clip&&(t.clip=`${n.clip.axis}:${wS(n.clip.at)}`),n.pick&&(t.pick=`${n.pick.body===0?"a":"b"}:${n.pick.triangle}`),n.seek!==wg.seek&&(t.seek=n.seek),n.onlyFirst&&(t.first="1"),n.tau!==null&&(t.tau=String(n.tau)),n.others||(t.others="0"),es(n.filter)&&Object.assign(t,Ds(n.filter)),t}var k2=[186,190,196],B2=[100,138,186],z2=8,V2=[1,0,0,0,0,1,0,0,0,0,1,0];function ES({meshes:n}){return[new Tc(n[0],k2),new Tc(n[1],B2)]}function CS({meshes:n,closed:e}){return e?new zd(n[1]):null}var tf=class{constructor(e,t,i,s){this.canvas=e;this.model=t;this.stage=new ef(e,i,s),this.bodies=ES(t),this.shotsView=CS(t),this.refreshTheme()}canvas;model;stage;bodies;gaps=0;others=new Zd;contactsView=new Wd;shotsView;pathView=new Yd;mark=new Jd;matrices=[new vt,new vt];highlights=[new Map,new Map];contacts=null;state=null;fitted=null;isOtherPair=!1;radius=1;freshAt=-1;use(e){e!==this.model&&([...this.bodies,this.shotsView].forEach(t=>t?.dispose()),this.model=e,this.bodies=ES(e),this.shotsView=CS(e),this.others.bodies=[],[this.fitted,this.isOtherPair]=[null,!0])}showOthers(e){this.others.bodies=e,this.placeOthers(),this.stage.draw()}placeOthers(){if(this.contacts&&this.state){let{scenario:e}=this.contacts,t=ir(Cl(e,this.state.tau).pose_a);this.others.place(t,this.origin,kp(e,this.state.tau))}this.stage.setRadius(Math.max(this.radius,this.others.reach))}otherAt(e,t){let i=this.others.group.visible&&this.pickAt(e,t,!1)===null,s=this.stage.rayAt(e,t);return i?this.others.bodyAt(s,bg(this.state?.clip,this.origin,s)):null}refreshTheme(){this.stage.setBackground(cs("--stage",this.canvas))}show(e,t){this.contacts=e,this.placeBodies(e,t),this.showPath(e),this.radius=this.reachOfB()+this.bodies[1].radius+this.bodies[0].radius,this.refreshContacts(t),this.state=t,this.placeOthers(),this.applyState(t),(this.isOtherPair||!t.camera&&!this.isInView())&&this.fit(this.fitted===null),this.isOtherPair=!1}placeBodies({scenario:e},t){this.matrices=[this.bodies[0].place(V2,this.origin),this.bodies[1].place(Ru(e,t.tau),this.origin)]}showPath({scenario:e}){this.pathView.show(e.motion?cx(e.motion):[],this.origin,fa(e))}reachOfB(){let e=Math.hypot(...this.bodies[1].mesh.centre),t=this.pathView.points.map(i=>Math.hypot(...i)+e);return Math.max(this.centreOfB().length(),...t)}get origin(){return this.model.meshes[0].centre}centreOfB(){return new B().setFromMatrixPosition(this.matrices[1])}isShown(e,t,i){let[s,r]=this.model.parts;return s.isOf(t,e.partA)&&r.isOf(i,e.partB)}refreshContacts(e){if(!this.contacts)return;let{pairs:t,points:i,scenario:s}=this.contacts;if(this.contacts.hits&&this.shotsView){this.refreshHits(this.contacts,this.contacts.hits,this.shotsView,e);return}let r=lx(s,e.tau),o=(l,c)=>r&&this.isShown(e,l,c);this.highlights=jb(t,o);let a=[this.bodies[0].corners,this.bodies[1].corners];this.contactsView.show(a,this.highlights,this.matrices),this.gaps=this.contactsView.addPoints(i,ir(s.pose_a),this.origin,l=>o(t[3*l],t[3*l+1])?t[3*l+2]:null)}refreshHits({scenario:e},t,i,s){let r=t.shown(s.onlyFirst).filter(a=>this.isShown(s,t.triangleOf(a),t.lineOf(a)));this.highlights=[new Map(r.map(a=>[t.triangleOf(a),gg])),new Map];let o=xu(e);i.show(t,r,a=>zi(o,a).map((l,c)=>l-this.origin[c]))}setState(e){let t=this.state;this.state=e,!(t&&AS(t,e))&&(t&&t.tau!==e.tau&&this.contacts&&(this.placeBodies(this.contacts,e),this.placeOthers(),this.refreshContacts(e)),t&&(t.partA!==e.partA||t.partB!==e.partB||t.onlyFirst!==e.onlyFirst)&&this.refreshContacts(e),this.applyState(e))}applyState(e){let[t,i]=this.bodies;t.showAs(e.ghost==="a"?"ghost":"solid"),i.showAs(e.ghost==="b"?"ghost":"solid"),this.bodies.forEach(o=>o.showHeat(e.mode==="heat"));let s=e.clip?"xyz".indexOf(e.clip.axis):0,r=e.clip?[MS(e.clip.axis,e.clip.at-this.origin[s])]:[];this.bodies.forEach(o=>o.clip(r)),this.contactsView.clip(r),this.contactsView.group.visible=e.mode==="contacts",this.contactsView.lines.visible=e.lines,this.others.clip(r),this.others.group.visible=e.others,this.pathView.clip(r),this.pathView.group.visible=e.lines,this.shotsView&&(this.shotsView.clip(r),this.shotsView.group.visible=e.mode==="contacts"&&e.lines),this.mark.show(e.pick&&this.bodies[e.pick.body].corners,e.pick,this.matrices),this.arrange(e)}isShowing(e){return this.state===e}arrange(e){let[t,i]=this.bodies,s={objects:[t.solid,i.solid],forgetsDepth:!1},r={objects:[this.contactsView.group,this.pathView.group,...this.shotsView?[this.shotsView.group]:[]],forgetsDepth:e.throughWalls},o={objects:[t.ghost,i.ghost],forgetsDepth:!1},a={objects:[this.others.group],forgetsDepth:!1},l={objects:[this.mark.group],forgetsDepth:!0};this.stage.setLayers(e.throughWalls?[s,o,a,r,l]:[s,r,o,a,l])}setHeat(e,t){e.forEach((i,s)=>this.bodies[s].setHeat(ix(i,t))),this.stage.draw()}ballAround(){let e=new Bn(new B,this.bodies[0].radius);return this.pathView.points.forEach(t=>e.expandByPoint(new B(...t))),this.shotsView?e:e.union(new Bn(this.centreOfB(),this.bodies[1].radius))}isInView(){let[e,t]=[this.ballAround(),this.fitted];return t!==null&&t.center.distanceTo(e.center)+e.radius<=t.radius*1.001}fit(e){this.fitted=this.ballAround();let i=[...(this.shotsView?this.bodies.slice(0,1):this.bodies).flatMap((r,o)=>r.boxCorners(this.matrices[o])),...this.pathView.points],s=new Qn().setFromPoints(i.map(r=>new B(...r)));this.stage.fit(s.getCenter(new B).toArray(),i,e),this.freshAt=this.stage.isAtStart?this.contacts?.scenario.index??-1:-1}goToContact(){if(this.highlights[0].size===0){this.fit(!1);return}let{centre:e,radius:t}=mS(this.bodies[0].corners,[...this.highlights[0].keys()]),i=Math.min(this.bodies[0].radius,this.bodies[1].radius)/12;this.stage.fit(e.toArray(),gS(e,Math.max(t,i)),!1)}get view(){return this.stage.view.map((e,t)=>e+this.origin[t%3])}get ownView(){return this.contacts?.scenario.index===this.freshAt?null:this.view}set view(e){this.stage.view=e.map((t,i)=>t-this.origin[i%3])}pickMiddle(e){return this.pickAt(this.canvas.clientWidth/2,this.canvas.clientHeight/2,e)}pickAt(e,t,i){let s=this.lineAt(e,t);if(s!==null)return{body:1,triangle:s};let r=this.stage.rayAt(e,t),o=[0,1].filter(c=>this.bodies[c].ghost.visible),a=[0,1].filter(c=>this.bodies[c].solid.visible);return i?this.pickAmong(r,o)??this.pickAmong(r,a):(this.state?.throughWalls&&this.state.mode==="contacts"?this.pickAmong(r,[0,1],!0):null)??this.pickAmong(r,a)??this.pickAmong(r,o)}lineAt(e,t){let i=this.contacts?.hits;if(!i||!this.shotsView?.group.visible)return null;let s=z2,r=null;for(let{hit:o,at:a}of this.shotsView.points){let[l,c]=this.stage.pixelOf(a),u=Math.hypot(l-e,c-t);u<s&&([s,r]=[u,i.lineOf(o)])}return r}pickAmong(e,t,i=!1){let s=t.map(r=>({body:r,corners:this.bodies[r].corners,matrix:this.matrices[r],triangles:i?[...this.highlights[r].keys()]:null}));return pS(e,s,bg(this.state?.clip,this.origin,e))}get lines(){return this.shotsView?.lines??[0,0]}hitPixels(e){let t=this.contacts?.hits;return(t?this.shotsView?.points.slice(0,e)??[]:[]).map(({hit:i,at:s})=>({line:t?.lineOf(i)??-1,kind:t?.kindOf(i)??"grazes",pixel:this.stage.pixelOf(s)}))}get motion(){let e=this.centreOfB().toArray();return{pieces:this.pathView.group.children.length,centre:e.map((t,i)=>t+this.origin[i])}}get highlighted(){return this.highlights.map(e=>[...e.keys()].sort((t,i)=>t-i))}pixelOf(e){return this.stage.pixelOf(e.map((t,i)=>t-this.origin[i]))}pixelOfWorld(e){let t=this.contacts?.scenario;return this.pixelOf(t?zi(ir(t.pose_a),e):e)}dispose(){this.bodies.forEach(e=>e.dispose()),this.contactsView.dispose(),this.shotsView?.dispose(),this.pathView.dispose(),this.others.dispose(),this.mark.dispose(),this.stage.dispose()}};function RS(n){let[e,t]=$e({value:null,error:""});return ke(()=>{let i=!0;return n&&!Xt(n)&&!rx(n)&&ox(n).then(s=>i&&t({value:s,error:""}),s=>i&&t({value:null,error:Rn(s)})),()=>{i=!1}},[n?.job]),e}function PS(n,e,t){let[i,s]=$e({value:null,error:""}),r=Tt(!1);return ke(()=>{n&&e&&t&&!r.current&&(r.current=!0,ax(n,e).then(o=>s({value:o,error:o?"":"this job has no heat map"}),o=>s({value:null,error:Rn(o)})))},[n,e,t]),i}async function H2(n,e){let t=Ci(e);return Xt(n)&&Br(n,t)<=bo?sx(n,t):null}function IS(n,e){let[t,i]=$e(null),[s,r]=$e({scenario:-1,error:""}),o=Tt(null);return ke(()=>{if(n)return o.current=new qd(n.job,Lt(n),a=>H2(n,a),i,(a,l)=>r({scenario:a,error:Rn(l)})),()=>o.current?.close()},[n?.job]),ke(()=>o.current?.want(e),[n?.job,e]),{contacts:t,error:s.scenario===e?s.error:""}}function LS(n,e,t,i,s,r){let[o,a]=$e(null),[l,c]=$e(""),u=Tt(0),d=Tt(-1),h=Tt(-1),f=Tt(r);return f.current=r,ke(()=>{if(!n.current||!e)return;let p=performance.now(),v;try{v=new tf(n.current,e,()=>f.current(v.view),()=>{d.current=h.current,u.current===0&&h.current>=0&&(u.current=performance.now()-p)})}catch(_){c(`this browser draws no 3D (WebGL 2): ${Rn(_)}. All else on this page works.`);return}a(v);let g=Yc(()=>v.refreshTheme());return()=>{g(),v.dispose(),a(null)}},[e!==null]),ke(()=>{o&&e&&o.use(e)},[o,e]),ke(()=>{o&&t&&(o.show(t,i),h.current=t.scenario.index)},[o,t]),ke(()=>o?.setState(i),[o,i]),ke(()=>{o&&s&&o.setHeat(s.counts,s.most)},[o,s]),{viewer:o,error:l,firstFrame:u,drawn:d}}function DS(n){let e=Tt(n);e.current=n,ke(()=>Ti("viewer",()=>{let{model:t,contacts:i,state:s,drawing:r,scenario:o,canvas:a,step:l,others:c}=e.current,u=r.viewer,d=a.current?.getBoundingClientRect(),h=([v,g])=>[v+(d?.left??0),g+(d?.top??0)],f=i?.points??new Float64Array,p=Array.from({length:Math.min(8,f.length/4)},(v,g)=>Array.from(f.subarray(4*g+1,4*g+4)));return{ready:u?.isShowing(s)===!0&&r.drawn.current===o,scenario:i?.scenario.index,class:i?.scenario.class,verified:i?.scenario.verified,mode:s.mode,ghost:s.ghost,throughWalls:s.throughWalls,clip:s.clip,camera:u?.view,parts:[s.partA,s.partB],pick:s.pick,trianglesDrawn:u?.bodies.map(v=>v.triangles)??[0,0],highlighted:u?.highlighted??[[],[]],gaps:u?.gaps??0,lines:u?.lines??[0,0],motion:i?.scenario.motion&&{tau:s.tau??da(i.scenario.motion),event:ha(i.scenario.motion),intervals:So(i.scenario.motion),...u?.motion},scene:i?.scenario.bodies&&{step:i.scenario.step,time:i.scenario.time,bodies:i.scenario.bodies,stepRead:l?.step??null,others:u?.others.group.visible?u.others.bodies.length:0,form:c.form,filter:s.filter,centres:(u?.others.centres??[]).map(v=>({...v,pixel:h(u?.pixelOf(v.centre)??[0,0])}))},hits:(u?.hitPixels(64)??[]).map(v=>({...v,pixel:h(v.pixel)})),shaChecked:t?.meshes.map(v=>v.checked),meshMilliseconds:t?.milliseconds,firstFrameMilliseconds:r.firstFrame.current,frames:u?.stage.frames,pointPixels:u?p.map(v=>h(u.pixelOfWorld(v))):[]}}),[])}var G2=60,nf=Math.PI/24,sf=.05;function W2(n,e){let t=e.bodies[n?.bodies[1]??1]?.size??[0,0,0],i=Math.hypot(t[0],t[1],t[2])/2,s=n?.meshes[0],r=o=>s?[s.min[o]-i,s.max[o]+i]:[-1,1];return{x:r(0),y:r(1),z:r(2)}}function Eg(n){let e=n.route.job,{value:t,error:i}=ps(`jobs/${encodeURIComponent(e)}`,1,()=>!1);return t?m($2,{...n,job:t}):i?m(Ct,{kind:"bad",children:i}):m("p",{class:"wait",children:["asking for ",e,"…"]})}function $2({source:n,route:e,report:t,job:i}){let[s,r]=$e(e.scenario),{value:o,error:a}=RS(i),{contacts:l,error:c}=IS(i,s),u=Xt(i),d=u?l?.model??null:o,h=l?Ci(l.scenario):tr,f=lt(()=>({bodies:gi(i,h),hasA:ye=>d?.parts[0].names.includes(ye)??!0}),[d]),[p,v]=$e(()=>Tg(e.query,f)),{value:g,error:_}=PS(i,d,p.mode==="heat"||p.pick!==null&&i.maps),b=Tt(null),[E,M]=$e(!1),[I,C]=$e(!1),y=m0(ye=>v(R=>({...R,...ye})),[]),T=LS(b,d,l,p,g,ye=>y({camera:ye})),{viewer:k}=T,{steps:D,error:L}=Lu(t?void 0:i),H=Sx(i,D,l,t!==void 0),{bodies:V,error:O}=H,$=Mx(i,k,l,V),[q,G]=$e(""),ce=lt(()=>W2(d,i),[d,i]);Ir(t?null:`#${s} ${i.name}`),DS({model:d,contacts:l,state:p,drawing:T,scenario:s,canvas:b,step:V,others:$});let K=()=>{k&&p.camera&&(k.view=p.camera)},[ee,Y]=$e(0),oe=Tt("link"),ue=Tt(-1);ke(()=>{oe.current=e.scenario===ue.current?"search":"link",ue.current=-1,r(e.scenario),v(Tg(e.query,f)),Y(ye=>ye+1)},[e]),ke(K,[k,ee]),ke(()=>{if(!d)return;let[ye,R]=oe.current==="step"?["",""]:Ag(e.query,f);oe.current==="link"?(y({partA:ye,partB:R}),K()):y({partA:ye,partB:R,pick:null,camera:null})},[d]);let te=(ye,R)=>en(e.job,ye,TS({...p,camera:R,tau:ye===s?p.tau:null},f.bodies)),_e=()=>te(s,p.camera??k?.ownView??null),me=Lt(i),Ae=me&&p.pick?.body===1?p.pick.triangle:null,be=me?"as files":"as a case of its own",tt=(!u||l!==null)&&Br(i,h)>bo,Be=!tt&&T.error==="";ke(()=>((d||tt)&&Xc(_e),Er),[s,p,l,d]);let ot=lt(()=>new Xd(i.scenarios,t?.scenarios),[i,t]),ut=ot.placeOf(s),Je=ye=>{oe.current="step",r(ot.at(ye)),y({tau:null})},Vt=wx(i,D,l,p.filter,Je);ke(()=>{if(!E||l?.scenario.index!==s)return;let ye=l.scenario.step??0,R=D?D.nearest(ye+1,1):ut+1;if(D?R<=ye:R>=ot.count){M(!1);return}let S=setTimeout(()=>D?Vt(R,1):Je(R),G2);return()=>clearTimeout(S)},[E,l,s]);let qt=async()=>d?.parts??Promise.all([kr(i.job,h[0]),kr(i.job,h[1])]),dn=D&&p.filter.steps?D.rangeOf(...D.within(p.filter.steps)):void 0,Dt={...p,bodies:h},un=dS((ye,R,S)=>t&&d?hS({job:i,from:s,step:ye},t.scenarios,Dt,d.parts):uS({job:i,from:s,step:ye,signal:R,tell:S,...dn?{within:dn}:{}},Dt,qt),ye=>{ue.current=ye,cl(_e()),Zs(te(ye,p.camera))},i.done===i.scenarios,$d(p.seek),[e,s,p,E]),tn=()=>{y({camera:null}),k?.fit(!1)},fn=()=>{k?.goToContact(),y({camera:k?.view??null})},U=ye=>{if(p.clip){let[R,S]=ce[p.clip.axis],X=Math.min(S,Math.max(R,p.clip.at+ye*(S-R)/100));y({clip:{...p.clip,at:X}})}},Ee=l?.scenario.step??0,at={n:()=>un.start(1),p:()=>un.start(-1),ArrowRight:()=>Je(ut+1),ArrowLeft:()=>Je(ut-1),...D?{".":()=>Vt(Ee+1,1),",":()=>Vt(Ee-1,-1)}:{},...Be?{" ":()=>M(!E),h:()=>y({mode:p.mode==="heat"||!i.maps?"contacts":"heat"}),g:()=>y({ghost:p.ghost==="a"?"b":p.ghost==="b"?"none":"a"}),x:()=>y({throughWalls:!p.throughWalls}),l:()=>y({lines:!p.lines}),s:()=>y({clip:p.clip?null:{axis:"x",at:(ce.x[0]+ce.x[1])/2}}),"[":()=>U(-1),"]":()=>U(1),f:tn,c:fn,e:()=>y({tau:null}),"Shift+ArrowRight":()=>k?.stage.turn(nf,0),"Shift+ArrowLeft":()=>k?.stage.turn(-nf,0),"Shift+ArrowUp":()=>k?.stage.turn(0,nf),"Shift+ArrowDown":()=>k?.stage.turn(0,-nf),W:()=>k?.stage.move(0,sf),S:()=>k?.stage.move(0,-sf),A:()=>k?.stage.move(-sf,0),D:()=>k?.stage.move(sf,0),"+":()=>k?.stage.approach(.85),"-":()=>k?.stage.approach(1/.85)}:{},Escape:un.stop,"?":()=>C(!0)},we=ye=>v(R=>ye===null&&R.pick===null?R:{...R,pick:ye});Nu(at,t?.root);let Nt=i.folder?ul(i.folder):n.kind==="folder"?ul(n.name):i.job,ze=a||T.error||c||L||O||(p.mode==="heat"?_:"");return m("div",{class:"viewer",children:[m(sS,{job:i,isInReport:t!==void 0,scenario:s,scenarios:ot,contacts:l,move:Je}),m(nS,{model:d,contacts:l}),ze&&m(Ct,{kind:"bad",children:ze}),H.isLeftOut&&m(Ct,{kind:"warn",children:["This report has no room for the other bodies of this step; ",m("code",{children:["cdctl view ",Nt]})," shows them."]}),m(rS,{scenarios:ot,isInReport:t!==void 0,place:ut,move:Je,search:un,seek:p.seek,chooseSeek:i.clearance===null?null:ye=>y({seek:ye}),isPlaying:E,play:Be?M:null,children:[m(Nx,{address:()=>location.href.split("#")[0]+te(s,k?.view??p.camera)}),Be&&m("button",{type:"button",onClick:()=>{k?.stage.save(`${i.name||e.job}-${s}`)},disabled:!k,children:"PNG"}),m("button",{type:"button",class:"quiet",onClick:()=>C(!0),title:"keys",children:"?"})]}),D&&l&&m(Cx,{steps:D,step:Ee,stepTo:Vt}),es(p.filter)&&m(Rx,{filter:p.filter,drop:()=>y({filter:yo})}),m("div",{class:"stage-row",children:[tt?m("div",{class:"stage",children:m("p",{class:"wait",children:[fe(Br(i,h))," triangles: above ",fe(bo)," this page does not draw. The exports have it all:"," ",m("code",{children:["cdctl extract ",Nt," ",String(s)," --out ",me?"scene --as vtp":"case"]})]})}):m("div",{class:"stage-column",children:[m($b,{job:i,scenario:s,contacts:l,canvas:b,viewer:k,waits:!k&&!ze,root:t?.root,pick:we,pickOther:ye=>G(i.bodies[ye].name)}),l?.scenario.motion&&m(Ix,{scenario:l.scenario,motion:l.scenario.motion,tau:p.tau,choose:ye=>y({tau:ye})})]}),m("aside",{class:"side",children:[Be&&m(Pt,{children:[m(Dx,{state:p,bounds:ce,hasMap:i.maps,hasOthers:D!==null||t!==void 0&&V!==null,lines:{areDrawn:me,hasAllHits:me&&i.first_hits!==!0,name:gu(i)?"path, segments and points":me?"lines and hits":"segments and points"},change:y,fit:tn,goToContact:fn}),p.mode==="heat"&&g?m(Ux,{heat:g,job:i}):me?m(Wb,{}):m(kx,{near:Fx(i)})]}),Ae!==null&&d&&l&&m(Gb,{line:Ae,job:i,model:d,contacts:l,drop:()=>y({pick:null})}),p.pick&&Ae===null&&d&&m(eS,{pick:p.pick,model:d,contacts:l,heat:g,job:i,drop:()=>y({pick:null})}),V&&m(Px,{job:i,step:V,scenario:s,others:$,text:q,setText:G,held:t?.scenarios,open:ye=>Je(ot.placeOf(ye))}),l&&d&&m(Qb,{contacts:l,model:d,bodies:u?f.bodies:null,state:p,choose:(ye,R)=>y({partA:ye,partB:R})}),l&&m(tS,{job:i,contacts:l,tau:p.tau}),m("section",{"aria-label":be,children:[m("h2",{children:be}),m(pu,{text:`cdctl extract ${Nt} ${s} --out ${me?"scene --as vtp":"case"}`})]})]})]}),I&&m(Du,{title:"Keys of the viewer",keys:Ax(Be,D!==null),close:()=>C(!1)})]})}var NS={system:"light",light:"dark",dark:"system"};function X2(){let[n,e]=$e(E0());return m("button",{type:"button",class:"quiet",onClick:()=>{C0(NS[n]),e(NS[n])},title:"light, dark, or as the system says",children:[{system:"◐",light:"○",dark:"●"}[n]," ",n]})}function OS(n){let{source:e,screen:t}=n,i=e.job===null,s=(r,o,a)=>m("a",{href:`#/${r}`,...a?{"aria-current":"page"}:{},children:o});return m(Pt,{children:[m("header",{class:"bar",children:[m("a",{class:"brand",href:"#/",children:[m("img",{src:"icon.svg",alt:"",width:20,height:20}),"cdcluster"]}),m("nav",{"aria-label":"screens",children:[i&&s("cluster","cluster",t==="cluster"),i&&s("jobs","jobs",t==="jobs"),e.job!==null&&s(`jobs/${e.job}`,"job",t==="job")]}),m("span",{class:"where",title:`${e.program} ${e.name}`,children:[e.kind==="folder"?"folder ":"master ",m(et,{text:e.kind==="folder"?us(e.name):e.name}),e.tls&&" · TLS"]}),m(X2,{})]}),m("main",{children:n.children})]})}function US(n){return n.job===null?"#/cluster":Ks(n.job)}function kS(){let[n,e]=$e(Lf),t=()=>e(Lf()),i=Tt(location.hash);return ke(()=>{location.hash!==i.current&&t();let s=()=>{Er(),Rf(),t()};return addEventListener("hashchange",s),()=>removeEventListener("hashchange",s)},[]),[n,t]}function q2({source:n}){let[e,t]=kS();ke(()=>Ti("route",()=>({screen:e.screen,link:location.hash})),[e]);let i=location.hash.replace(/^#\/?/,"")==="";return ke(()=>{i&&(cl(US(n)),t())},[i]),m(OS,{source:n,screen:e.screen,children:e.screen==="none"&&!i?m(Ct,{kind:"warn",children:["this address names nothing here; ",m("a",{href:US(n),children:"go to the start"})]}):m(Y2,{source:n,route:e})})}function Y2({source:n,route:e}){switch(e.screen){case"cluster":return m(dy,{});case"jobs":return m(uy,{});case"job":return m(Ex,{source:n,route:e},e.job);case"viewer":return m(Eg,{source:n,route:e},e.job);default:return null}}function J2(){let[n,e]=$e(null),[t,i]=$e("");return ke(()=>{Ai("source").then(e,s=>i(Rn(s)))},[]),n?m(q2,{source:n}):t?m(Ct,{kind:"bad",children:t}):null}function K2({source:n,report:e}){let[t]=kS(),i=lt(()=>If(en(n.job??"",e.scenarios[0])),[]);return m(Eg,{source:n,route:t.screen==="viewer"?t:i,report:e})}async function Z2(n,e){v0(o=>e.answer(o));let t=await Ai("source"),i=new CSSStyleSheet;i.replaceSync(await Pf("app.css"));let s=n.attachShadow({mode:"open"});s.adoptedStyleSheets=[i];let r=s.appendChild(document.createElement("div"));Mf(m(K2,{source:t,report:{scenarios:e.scenarios,root:r}}),r)}S0();var rf=document.getElementById("page"),FS=Wc.of(document);rf&&FS?Z2(rf,FS):rf&&(R0(),Rf(),Mf(m(J2,{}),rf));
