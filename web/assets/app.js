var Nt,om,ky,js,td,Vl,am,Fl,lm,id,nd,zy,xa=Symbol.for("pv"),Hl={},Gl=[],Vy=/^m(i|n|o|s|text|space)$/,sd=Array.isArray,cm=Gl.slice,Ir=Object.assign;function Pr(n){n&&n.parentNode&&n.remove()}function Bl(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:xa,__v:s||++om,__i:-1,__u:0};return!s&&Nt.vnode&&Nt.vnode(r),r}function Ut(n){return n.children}function kl(n,e){this.props=n,this.context=e,this.__g=0}function Qs(n,e){if(e==null)return n.__&&Qs(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Qs(n)}function Hy(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Ir({constructor:xa},t)).__v=t.__v+1,Nt.vnode&&Nt.vnode(e),rd(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Qs(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,mm(s,e,r),t.__=t.__e=null,e.__e!=i&&um(e))}function um(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),um(n)}function sm(n){(8&n.__g||(n.__g|=8,js.push(n),Vl++))&&td==Nt.debounceRendering||((td=Nt.debounceRendering)||queueMicrotask)(hm)}function hm(){try{for(var n,e=1;js.length;)js.length>e&&js.sort(am),n=js.shift(),e=js.length,8&n.__g&&Hy(n)}finally{(Vl=js.length)&&(td||queueMicrotask)(hm)}}function dm(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,b,g,m=i.__k||Gl,v=e.length;for(l=Gy(t,e,m,l,v),f=0;f<v;f++)(d=t.__k[f])!=null&&(h=~d.__i&&m[d.__i]||Hl,d.__i=f,g=rd(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&od(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),b=b||p,4&d.__u?(l=fm(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&g!==void 0?l=g:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=b,l}function Gy(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,b=p,g=0,m=0,v=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=Bl(null,o):sd(o)?o=v[r]=Bl(Ut,{children:o}):o.constructor===xa&&o.__b?o=v[r]=Bl(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,l=r+g,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Wy(o,t,l,b))&&(b--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?g--:c==l+1?g++:c!=l&&(c>l?g--:g++,m=1)):(~c||(s>p?g--:s<p&&g++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(m){for(u=[],f=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(g=0,h=u.length;g<h;)u[d=g+h>>1]<o.__i?g=d+1:h=d;u[g]=o.__i,f[r]=g+1}for(g=u.length;r--;)f[r]&&(f[r]==g?g--:v[r].__u|=4)}if(b)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Qs(a)),ad(a,a));return i}function fm(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=fm(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Qs(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Wy(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function rm(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Ol(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||rm(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||rm(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=nd[e]||(nd[e]=Xy(e)),(n.__a||(n.__a={}))[e]=id,r=e!=(e=e.replace(lm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Xy(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Fl]==null)e[Fl]=id++;else if(e[Fl]<this.__a[n])return;return t(Nt.event?Nt.event(e):e)}}}function rd(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,g,m,v,E,M,L,C,_,T,k,U,D,H=e.type;if(e.constructor!==xa)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=zl(u,r):r.push(u),a=r[0]||a),(u=Nt.__b)&&u(e);e:if(typeof H=="function"){h=o.length;try{if(m=e.props,v=(u=H.prototype)&&u.render,E=(u=H.contextType)&&i[u.__c],M=u?E?E.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(v?e.__c=d=new H(m,M):(e.__c=d=new kl(m,M),d.constructor=H,d.render=$y),E&&E.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),v&&(d.__s||(d.__s=d.state),H.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Ir({},d.__s)),Ir(d.__s,H.getDerivedStateFromProps(m,d.__s)))),p=d.props,b=d.state,d.__v=e,t.__c){if(m!==p&&v&&!H.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(m,M),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(m,d.__s,M)===!1){e.__v!=t.__v&&(d.props=m,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(O){O&&(O.__=e)}),Gl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=Qs(t);break e}d.componentWillUpdate&&d.componentWillUpdate(m,d.__s,M),v&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,b,g)})}else v&&!H.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),v&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=M,d.props=m,d.__P=n,d.__g&=-5,L=Nt.__r,C=v?25:0;do d.__g&=-9,L&&L(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++C<25);v&&(Gl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Ir({},i,d.getChildContext())),v&&t.__c&&d.getSnapshotBeforeUpdate&&(g=d.getSnapshotBeforeUpdate(p,b)),_=u&&u.type===Ut&&u.key==null?u.props.children:u,m.__P&&(u=a,s=(n=m.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(O){O&&ad(O,O)}),t.__k=null),a=t.__k?Qs(t,0):null),a=dm(n,sd(_)?_:[_],e,t,i,s,r,o,a,l,c),m.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(Pr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(O){if(o.length=h,e.__v=null,l||r)if(O&&O.then){if(e.__u|=128|l,r){for(~(U=r.indexOf(a||void 0))||(U=r.length);(D=r[U-1])&&D.nodeType==8;)U--;for(;U<r.length;U++)if(D=r[U])if(r[U]=null,T){if(D==k)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(k=zl(T=D))}}if(!T){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;T=a}(u=zl(T=e.__c.__z||(e.__c.__z=T)))?(e.__e=T,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Pr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),O&&O.then||pm(e),Nt.__e(O,e,t)}}else a=e.__e=qy(t.__e,e,t,i,s,r,o,l,c,n);return(u=Nt.diffed)&&u(e),a}function zl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function pm(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(pm))}function mm(n,e,t){for(var i=0;i<t.length;)od(t[i++],t[i++],t[i++]);Nt.__c&&Nt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Nt.__e(r,s.__v)}})}function qy(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,g,m,v=t.props||Hl,E=e.props,M=e.type;if(M=="svg"?s="http://www.w3.org/2000/svg":M=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(M?p.localName==M:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(m=c.ownerDocument||document,!M)return m.createTextNode(E);n=m.createElementNS(s,M,E.is?E:c),a&&(Nt.__m&&Nt.__m(e,r),a=!1),r=null}if(M){if(c=M=="template"&&n.content||n,r=M=="textarea"&&E.defaultValue!=null?null:r&&cm.call(c.childNodes),!a&&r)for(v={},u=0;u<n.attributes.length;u++)v[(p=n.attributes[u]).name]=p.value;for(u in v)p=v[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in E||u=="value"&&"defaultValue"in E||u=="checked"&&"defaultChecked"in E||Ol(n,u,null,p,s);for(u in E)p=E[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?b=p:u=="checked"?g=p:a&&typeof p!="function"||v[u]===p||Ol(n,u,p,v[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(M=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Vy.test(M))&&(s="http://www.w3.org/1999/xhtml"),dm(c,sd(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&Qs(t,0),a,l),r&&r.some(Pr)),a&&M!="textarea"||(u="value",M=="progress"&&b==null?n.removeAttribute(u):b==null||b===n[u]&&(M!="progress"||b)||Ol(n,u,b,v[u],s),u="checked",g!=null&&g!=n[u]&&Ol(n,u,g,v[u],s))}else v===E||a&&n.data==E||(n.data=E);return n}function od(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Nt.__e(s,t)}}function ad(n,e,t){var i,s,r,o;if(Nt.unmount&&Nt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||od(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Nt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&ad(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=zl(i,r=[]))&&(i==n.__e&&r.some(Pr),Pr(s),Pr(i)),t||Pr(n.__e),n.__e=n.__c=n.__=null}function $y(n,e,t){return this.constructor(n,t)}function ld(n,e){var t,i,s,r;Nt.__&&Nt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Bl(Ut,{children:[n]}),s=[],r=[],rd(e,e.__k,i||Hl,Hl,e.namespaceURI,i?null:e.firstChild?cm.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),mm(s,e.__k,r),e.__k.props.children=null}Nt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Vl=0,n}},om=0,ky=function(n){return n!=null&&n.constructor===xa},kl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Ir({},this.state)),typeof n=="function"&&(n=n(Ir({},t),this.props)),n&&(Ir(t,n),this.__v&&(e&&this.__k.push(e),sm(this)))},kl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),sm(this))},kl.prototype.render=Ut,js=[],Vl=0,am=function(n,e){return n.__v.__b-e.__v.__b},Fl=Symbol(),lm=/(PointerCapture)$|Capture$/i,id=0,nd={},zy=0;var va,wn,cd,gm,ud=Object.is,ba=0,Am=[],hd=[],gn=Nt,_m=gn.__b,xm=gn.__r,ym=gn.diffed,vm=gn.__c,bm=gn.unmount,Sm=gn.__;function fd(n,e){gn.__h&&gn.__h(wn,n,ba||e),ba=0;var t=wn.__H||(wn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function et(n){return ba=1,Yy(Em,n)}function Yy(n,e,t){var i=fd(va++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):Em(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);ud(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=wn,!wn.__f)){wn.__f=!0;var s=wn.shouldComponentUpdate;wn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,ud(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function Ye(n,e){var t=fd(va++,3);!gn.__s&&Tm(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,wn.__H.__h.push(t))}function on(n){return ba=5,An(function(){return{current:n}},[])}function An(n,e){var t=fd(va++,7);return Tm(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function pd(n,e){return ba=8,An(function(){return n},e)}function Jy(){var n;do{for(;n=hd.shift();)try{ya(n)}catch(t){gn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=Am.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(ya),e.__h.some(dd),e.__h=[]}catch(t){e.__h=[],gn.__e(t,n.__v)}}}while(hd.length)}gn.__b=function(n){wn=null,_m&&_m(n)},gn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),Sm&&Sm(n,e)},gn.__r=function(n){xm&&xm(n),va=0;var e=(wn=n.__c).__H;e&&(cd==wn?wn.__h=[]:(e.__h.some(ya),e.__h.some(dd),va=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),cd=wn},gn.diffed=function(n){ym&&ym(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&wm(Am.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),cd=wn=null},gn.__c=function(n,e){e.some(function(t){try{t.__h.some(ya),t.__h=t.__h.filter(function(i){return!i.__||dd(i)})}catch(i){t.__h=[function(){throw i}]}}),vm&&vm(n,e)},gn.unmount=function(n){bm&&bm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,wm(hd.push(s))}else ya(s)}catch(r){e=r}}),i.__H=void 0,e&&gn.__e(e,i.__v))};var Mm=typeof requestAnimationFrame=="function";function Zy(n){var e,t=function(){clearTimeout(i),Mm&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);Mm&&(e=requestAnimationFrame(t))}function wm(n){n!=1&&gm==gn.requestAnimationFrame||((gm=gn.requestAnimationFrame)||Zy)(Jy)}function ya(n){var e=wn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),wn=e}function dd(n){var e=wn;n.__c=n.__(),wn=e}function Tm(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!ud(t,n[i])})}function Em(n,e){return typeof e=="function"?e(n):e}function Ky(n,e){switch(n){case"|u1":return new Uint8Array(e);case"<u4":return new Uint32Array(e);case"<f4":return new Float32Array(e);case"<f8":return new Float64Array(e);case"<u8":return Float64Array.from(new BigUint64Array(e),Number);default:throw new Error(`an NPY array of type ${n}, which this page does not know`)}}function Cm(n){let e=new Uint8Array(n);if(e.length<10||e[0]!==147||e[1]!==78||e[6]!==1)throw new Error("not an NPY array of format 1.0");let t=10+e[8]+256*e[9],i=new TextDecoder("latin1").decode(e.subarray(10,t)),s=/'descr':\s*'([^']+)'/.exec(i)?.[1]??"",r=(/'shape':\s*\(([^)]*)\)/.exec(i)?.[1]??"").split(",").filter(a=>a.trim()!=="").map(Number);if(/'fortran_order':\s*True/.test(i))throw new Error("an NPY array in Fortran order, which this page does not read");let o=Ky(s,n.slice(t));if(o.length!==r.reduce((a,l)=>a*l,1))throw new Error("an NPY array that is cut short");return{shape:r,values:o}}var us=class extends Error{constructor(t,i){super(i);this.status=t}status},Rm="cdcluster.key",Wl="";function jy(){try{return localStorage.getItem(Rm)??Wl}catch{return Wl}}function md(){let n=/^#key=([^&]*)&?(.*)$/.exec(location.hash);if(n){Wl=n[1];try{localStorage.setItem(Rm,Wl)}catch{}history.replaceState(null,"",`${location.pathname}#${n[2]}`)}}async function Qy(n){try{let e=await n.json();if(typeof e=="object"&&e!==null&&"error"in e)return String(e.error)}catch{}return`the server answered ${n.status}`}async function ev(n,e){let t=jy(),i=t===""?{}:{Authorization:`Bearer ${t}`},s;try{s=await fetch(`api/v1/${n}`,{headers:i,credentials:"same-origin",...e?{signal:e}:{}})}catch(r){throw e?.aborted?r:new us(0,"the server does not answer: has it ended?")}if(!s.ok)throw new us(s.status,await Qy(s));return{bytes:await s.arrayBuffer(),cut:s.headers.get("X-Cut")==="true"}}var Xl=ev;function Pm(n){Xl=n}async function gd(n,e){return new TextDecoder().decode((await Xl(n,e)).bytes)}async function Es(n,e){return JSON.parse(await gd(n,e))}async function Ni(n,e){let{bytes:t,cut:i}=await Xl(n,e);return{...Cm(t),cut:i}}async function Im(n,e){return(await Xl(n,e)).bytes}function hs(n){return n instanceof DOMException&&n.name==="AbortError"}function Tn(n){return n instanceof Error?n.message:String(n)}var $l=new Map,ql=[];function Ui(n,e){return $l.set(n,e),()=>{$l.get(n)===e&&$l.delete(n)}}function Lm(){addEventListener("error",n=>ql.push(n.message)),addEventListener("unhandledrejection",n=>ql.push(String(n.reason))),document.addEventListener("securitypolicyviolation",n=>ql.push(`policy: ${n.violatedDirective} ${n.blockedURI}`)),window.cdcluster={facts:()=>Object.assign({ready:!1,errors:[...ql]},...[...$l.values()].map(n=>n()))}}async function tv(n){let e=atob(n),t=new Uint8Array(e.length);for(let s=0;s<e.length;++s)t[s]=e.charCodeAt(s);let i=new Blob([t]).stream().pipeThrough(new DecompressionStream("gzip"));return new Response(i).arrayBuffer()}var Yl=class n{constructor(e){this.blocks=e}blocks;static of(e){let i=Array.from(e.querySelectorAll("template[data-path]")).map(s=>[s.dataset.path??"",{base64:()=>s.content.textContent??"",cut:s.dataset.cut==="true"}]);return i.length===0?null:new n(new Map(i))}get scenarios(){return[...this.blocks.keys()].flatMap(e=>{let t=/^jobs\/[^/]+\/scenarios\/(\d+)$/.exec(e);return t?[Number(t[1])]:[]})}async answer(e){let t=this.blocks.get(e);if(!t)throw new us(404,"this report holds its worst scenarios only");return{bytes:await tv(t.base64()),cut:t.cut}}};function Jl(n){let[e,t]=n.replace(/^#/,"").split("?",2),i={screen:"none",job:"",scenario:0,query:new URLSearchParams(t??"")},s=e.split("/").filter(o=>o!=="");if(s.length===1&&(s[0]==="cluster"||s[0]==="jobs"))return{...i,screen:s[0]};if(s[0]!=="jobs"||s.length<2||s.length>3)return i;let r=nv(s[1]);return s.length===2?{...i,screen:"job",job:r}:/^\d+$/.test(s[2])?{...i,screen:"viewer",job:r,scenario:Number(s[2])}:i}function nv(n){try{return decodeURIComponent(n)}catch{return n}}function er(n){return`#/jobs/${encodeURIComponent(n)}`}function _n(n,e,t={}){let i=new URLSearchParams(t).toString().replaceAll("%2C",",").replaceAll("%3A",":").replaceAll("%2F","/");return`${er(n)}/${e}${i===""?"":`?${i}`}`}var Dm=0;function Cs(n){Lr(),location.hash=n}function Zl(n){Lr(),history.replaceState(null,"",n)}function Nm(n){Lr(),Dm=window.setTimeout(()=>history.replaceState(null,"",n),200)}function Lr(){clearTimeout(Dm)}var Um="cdcluster.theme",Kl=new Set;function Om(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:"system"}function Fm(n){n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n;try{localStorage.setItem(Um,n)}catch{}Kl.forEach(e=>e())}function Bm(){try{let n=localStorage.getItem(Um);(n==="light"||n==="dark")&&(document.documentElement.dataset.theme=n)}catch{}matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>Kl.forEach(n=>n()))}function jl(n){return Kl.add(n),()=>Kl.delete(n)}function Wi(n,e=document.documentElement){return getComputedStyle(e).getPropertyValue(n).trim()}function Ge(n){return(n<0?"-":"")+String(Math.round(Math.abs(n))).replace(/\B(?=(\d{3})+$)/g," ")}function Zn(n,e=4){return Number.isFinite(n)?String(Number(n.toPrecision(e))):n>0?"infinite":"-"}function En(n){return Number.isFinite(n)?`${n>0&&n<.001?"< 0.1":Zn(100*n,3)} %`:"-"}function Ql(n,e,t){let i=0;for(;Math.abs(n)>=e&&i+1<t.length;)n/=e,i+=1;let s=i===0?String(Math.round(n)):n.toPrecision(3);return t[i]===""?s:s+" "+t[i]}function Rs(n){return Ql(n,1024,["B","KiB","MiB","GiB","TiB"])}function km(n){return`${Ql(n,1e3,["B","kB","MB","GB"])}/s`}function zm(n,e){if(n<.01*e)return`${Rs(n)} of ${Rs(e)}`;let[t,i]=Rs(e).split(" ");return`${(n/(e/Number(t))).toPrecision(2)} of ${t} ${i}`}function tr(n){return`${Ql(n,1e3,["","k","M","G"])}/s`}function _d(n){return Ql(n,1e3,["","k","M","G"])}function Dr(n){if(!Number.isFinite(n))return"-";if(n<10)return`${Zn(n,2)} s`;let e=Math.round(n),t=i=>String(i).padStart(2,"0");return e<3600?`${Math.floor(e/60)}:${t(e%60)}`:e<86400?`${Math.floor(e/3600)} h ${t(Math.floor(e%3600/60))}`:`${Math.floor(e/86400)} d ${Math.floor(e%86400/3600)} h`}function jt(n,e){return`${Ge(n)} ${e}${n===1?"":"s"}`}function Sa(n){return/^[\w./:@%+=,-]+$/.test(n)?n:`'${n.replaceAll("'","'\\''")}'`}function nr(n){return n.split("/").pop()||n}var iv="uplot",sv="u-hz",rv="u-vt",ov="u-title",av="u-wrap",lv="u-under",cv="u-over",uv="u-axis",Or="u-off",hv="u-select",dv="u-cursor-x",fv="u-cursor-y",pv="u-cursor-pt",mv="u-legend",gv="u-live",_v="u-inline",xv="u-series",yv="u-marker",Vm="u-label",vv="u-value",wa="width",Aa="height";var Hm="bottom",uo="left",xd="right",Ud="#000",Gm=Ud+"0",yd="mousemove",Wm="mousedown",vd="mouseup",Xm="mouseenter",qm="mouseleave",$m="dblclick",bv="resize",Sv="scroll",Ym="change",sc="dppxchange",Od="--",xo=typeof window<"u",Ad=xo?document:null,fo=xo?window:null,Mv=xo?navigator:null,Tt,ec;function Td(){let n=devicePixelRatio;Tt!=n&&(Tt=n,ec&&Cd(Ym,ec,Td),ec=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),Fr(Ym,ec,Td),fo.dispatchEvent(new CustomEvent(sc)))}function Mi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function Ed(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function Yt(n,e,t){n.style[e]=t+"px"}function Xi(n,e,t,i){let s=Ad.createElement(n);return e!=null&&Mi(s,e),t?.insertBefore(s,i),s}function Oi(n,e){return Xi("div",n,e)}var Jm=new WeakMap;function ds(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Jm.get(n);r!=o&&(n.style.transform=r,Jm.set(n,r),e<0||t<0||e>i||t>s?Mi(n,Or):Ed(n,Or))}var Zm=new WeakMap;function Km(n,e,t){let i=e+t,s=Zm.get(n);i!=s&&(Zm.set(n,i),n.style.background=e,n.style.borderColor=t)}var jm=new WeakMap;function Qm(n,e,t,i){let s=e+""+t,r=jm.get(n);s!=r&&(jm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Fd={passive:!0},wv={...Fd,capture:!0};function Fr(n,e,t,i){e.addEventListener(n,t,i?wv:Fd)}function Cd(n,e,t,i){e.removeEventListener(n,t,Fd)}xo&&Td();function qi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:wi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function Eg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var Cg=n=>n!=null,Rg=n=>n!=null&&n>0,ac=Eg(Cg),Av=Eg(Rg);function Tv(n,e,t,i=0,s=!1){let r=s?Av:ac,o=s?Rg:Cg;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function lc(n,e,t,i){let s=ng(n),r=ng(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Ps:Pg,a=s==1?wi:Fi,l=r==1?Fi:wi,c=a(o(Rn(n))),u=l(o(Rn(e))),f=po(t,c),h=po(t,u);return t==10&&(c<0&&(f=Ht(f,-c)),u<0&&(h=Ht(h,-u))),i||t==2?(n=f*s,e=h*r):(n=Ng(n,f),e=cc(e,h)),[n,e]}function Bd(n,e,t,i){let s=lc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var kd=.1,eg={mode:3,pad:kd},Ea={pad:0,soft:null,mode:0},Ev={min:Ea,max:Ea};function rc(n,e,t,i){return uc(t)?tg(n,e,t):(Ea.pad=t,Ea.soft=i?0:null,Ea.mode=i?3:0,tg(n,e,Ev))}function wt(n,e){return n??e}function Cv(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function tg(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Vt),l=wt(s.hard,Vt),c=wt(i.soft,Vt),u=wt(s.soft,-Vt),f=wt(i.mode,0),h=wt(s.mode,0),d=e-n,p=Ps(d),b=oi(Rn(n),Rn(e)),g=Ps(b),m=Rn(g-p);(d<1e-24||m>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Vt&&(r=0),h==2&&u!=-Vt&&(o=0)));let v=d||b||1e3,E=Ps(v),M=po(10,wi(E)),L=v*(d==0?n==0?.1:1:r),C=Ht(Ng(n-L,M/10),24),_=n>=c&&(f==1||f==3&&C<=c||f==2&&C>=c)?c:Vt,T=oi(a,C<_&&n>=_?_:$i(_,C)),k=v*(d==0?e==0?.1:1:o),U=Ht(cc(e+k,M/10),24),D=e<=u&&(h==1||h==3&&U>=u||h==2&&U<=u)?u:-Vt,H=$i(l,U>D&&e<=D?D:oi(D,U));return T==H&&T==0&&(H=100),[T,H]}var Rv=new Intl.NumberFormat(xo?Mv.language:"en-US"),zd=n=>Rv.format(n),Ai=Math,ic=Ai.PI,Rn=Ai.abs,wi=Ai.floor,Cn=Ai.round,Fi=Ai.ceil,$i=Ai.min,oi=Ai.max,po=Ai.pow,ng=Ai.sign,Ps=Ai.log10,Pg=Ai.log2,Pv=(n,e=1)=>Ai.sinh(n)*e,bd=(n,e=1)=>Ai.asinh(n/e),Vt=1/0;function ig(n){return(Ps((n^n>>31)-(n>>31))|0)+1}function Rd(n,e,t){return $i(oi(n,e),t)}function Ig(n){return typeof n=="function"}function yt(n){return Ig(n)?n:()=>n}var Iv=()=>{},Lg=n=>n,Dg=(n,e)=>e,Lv=n=>null,sg=n=>!0,rg=(n,e)=>n==e,Dv=/\.\d*?(?=9{6,}|0{6,})/gm,Br=n=>{if(Og(n)||sr.has(n))return n;let e=`${n}`,t=e.match(Dv);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Br(s)}e${r}`}return Ht(n,i)};function Nr(n,e){return Br(Ht(Br(n/e))*e)}function cc(n,e){return Br(Fi(Br(n/e))*e)}function Ng(n,e){return Br(wi(Br(n/e))*e)}function Ht(n,e=0){if(Og(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Cn(i)/t}var sr=new Map;function Ug(n){return((""+n).split(".")[1]||"").length}function Ra(n,e,t,i){let s=[],r=i.map(Ug);for(let o=e;o<t;o++){let a=Rn(o),l=Ht(po(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Ht(u,f);s.push(h),sr.set(h,f)}}return s}var Ca={},Vd=[],mo=[null,null],ir=Array.isArray,Og=Number.isInteger,Nv=n=>n===void 0;function og(n){return typeof n=="string"}function uc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Uv(n){return n!=null&&typeof n=="object"}var Ov=Object.getPrototypeOf(Uint8Array),Fg="__proto__";function go(n,e=uc){let t;if(ir(n)){let i=n.find(s=>s!=null);if(ir(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=go(n[s],e)}else t=n.slice()}else if(n instanceof Ov)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Fg&&(t[i]=go(n[i],e))}else t=n;return t}function xn(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Fg&&(uc(n[s])?xn(n[s],go(i[s])):n[s]=go(i[s]))}return n}var Fv=0,Bv=1,kv=2;function zv(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Vv(n,e){if(Wv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Xv(o[0])||(o=Gv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:Bv,d=[];for(let p=0;p<u.length;p++){let b=u[p],g=r.get(l[p]);b===null?h!=Fv&&(f[g]=b,h==kv&&d.push(g)):f[g]=b}zv(f,d,s),i.push(f)}}return i}var Hv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Gv(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Wv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Xv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=oi(1,wi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Bg=["January","February","March","April","May","June","July","August","September","October","November","December"],kg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function zg(n){return n.slice(0,3)}var qv=kg.map(zg),$v=Bg.map(zg),Yv={MMMM:Bg,MMM:$v,WWWW:kg,WWW:qv};function Ma(n){return(n<10?"0":"")+n}function Jv(n){return(n<10?"00":n<100?"0":"")+n}var Zv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Ma(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Ma(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Ma(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Ma(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Ma(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>Jv(n.getMilliseconds())};function Hd(n,e){e=e||Yv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?Zv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Kv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function jv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Kv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Vg=n=>n%1==0,oc=[1,2,2.5,5],Qv=Ra(10,-32,0,oc),Hg=Ra(10,0,32,oc),eb=Hg.filter(Vg),Ur=Qv.concat(Hg),Gd=`
`,Gg="{YYYY}",ag=Gd+Gg,Wg="{M}/{D}",Ta=Gd+Wg,tc=Ta+"/{YY}",Xg="{aa}",tb="{h}:{mm}",ho=tb+Xg,lg=Gd+ho,cg=":{ss}",Ct=null;function qg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ra(10,0,3,oc).filter(Vg):Ra(10,-3,0,oc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Gg,Ct,Ct,Ct,Ct,Ct,Ct,1],[s*28,"{MMM}",ag,Ct,Ct,Ct,Ct,Ct,1],[s,Wg,ag,Ct,Ct,Ct,Ct,Ct,1],[i,"{h}"+Xg,tc,Ct,Ta,Ct,Ct,Ct,1],[t,ho,tc,Ct,Ta,Ct,Ct,Ct,1],[e,cg,tc+" "+ho,Ct,Ta+" "+ho,Ct,lg,Ct,1],[n,cg+".{fff}",tc+" "+ho,Ct,Ta+" "+ho,Ct,lg,Ct,1]];function u(f){return(h,d,p,b,g,m)=>{let v=[],E=g>=o,M=g>=r&&g<o,L=f(p),C=Ht(L*n,3),_=Sd(L.getFullYear(),E?0:L.getMonth(),M||E?1:L.getDate()),T=Ht(_*n,3);if(M||E){let k=M?g/r:0,U=E?g/o:0,D=C==T?C:Ht(Sd(_.getFullYear()+U,_.getMonth()+k,1)*n,3),H=new Date(Cn(D/n)),O=H.getFullYear(),I=H.getMonth();for(let W=0;D<=b;W++){let $=Sd(O+U*W,I+k*W,1),G=$-f(Ht($*n,3));D=Ht((+$+G)*n,3),D<=b&&v.push(D)}}else{let k=g>=s?s:g,U=wi(p)-wi(C),D=T+U+cc(C-T,k);v.push(D);let H=f(D),O=H.getHours()+H.getMinutes()/t+H.getSeconds()/i,I=g/i,W=h.axes[d]._space,$=m/W;for(;D=Ht(D+g,n==1?0:3),!(D>b);)if(I>1){let G=wi(Ht(O+I,6))%24,Q=f(D).getHours()-G;Q>1&&(Q=-1),D-=Q*i,O=(O+I)%24;let ie=v[v.length-1];Ht((D-ie)/g,3)*$>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,u]}var[nb,ib,sb]=qg(1),[rb,ob,ab]=qg(.001);Ra(2,-53,53,[1]);function ug(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function hg(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let b=n(p),g=b.getFullYear(),m=b.getMonth(),v=b.getDate(),E=b.getHours(),M=b.getMinutes(),L=b.getSeconds(),C=g!=l&&a[2]||m!=c&&a[3]||v!=u&&a[4]||E!=f&&a[5]||M!=h&&a[6]||L!=d&&a[7]||a[1];return l=g,c=m,u=v,f=E,h=M,d=L,C(b)})}}function lb(n,e){let t=Hd(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function Sd(n,e,t){return new Date(n,e,t)}function dg(n,e){return e(n)}var cb="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function fg(n,e){return(t,i,s,r)=>r==null?Od:e(n(i))}function ub(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function hb(n,e){return n.series[e].fill(n,e)}var db={show:!0,live:!0,isolate:!1,mount:Iv,markers:{show:!0,width:2,stroke:ub,fill:hb,dash:"solid"},idx:null,idxs:null,values:[]};function fb(n,e){let t=n.cursor.points,i=Oi(),s=t.size(n,e);Yt(i,wa,s),Yt(i,Aa,s);let r=s/-2;Yt(i,"marginLeft",r),Yt(i,"marginTop",r);let o=t.width(n,e,s);return o&&Yt(i,"borderWidth",o),i}function pb(n,e){let t=n.series[e].points;return t._fill||t._stroke}function mb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function gb(n,e){return n.series[e].points.size}var Md=[0,0];function _b(n,e,t){return Md[0]=e,Md[1]=t,Md}function nc(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function wd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var xb={show:!0,x:!0,y:!0,lock:!1,move:_b,points:{one:!1,show:fb,size:gb,width:0,stroke:mb,fill:pb},bind:{mousedown:nc,mouseup:nc,click:nc,dblclick:nc,mousemove:wd,mouseleave:wd,mouseenter:wd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},$g={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Wd=xn({},$g,{filter:Dg}),Yg=xn({},Wd,{size:10}),Jg=xn({},$g,{show:!1}),Xd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Zg="bold "+Xd,Kg=1.5,pg={show:!0,scale:"x",stroke:Ud,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zg,side:2,grid:Wd,ticks:Yg,border:Jg,font:Xd,lineGap:Kg,rotate:0},yb="Value",vb="Time",mg={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function bb(n,e,t,i,s){return e.map(r=>r==null?"":zd(r))}function Sb(n,e,t,i,s,r,o){let a=[],l=sr.get(s)||0;t=o?t:Ht(cc(t,s),l);for(let c=t;c<=i;c=Ht(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function Pd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Ps:Pg,u=wi(c(t));s=po(l,u),l==10&&(s=Ur[qi(s,Ur)]);let f=t,h=s*l;l==10&&(h=Ur[qi(h,Ur)]);do a.push(f),f=f+s,l==10&&!sr.has(f)&&(f=Ht(f,sr.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Ur[qi(h,Ur)]));while(f<=i);return a}function Mb(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?Pd(n,e,oi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?Pd(n,e,oi(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var jg=/./,wb=/[12357]/,Ab=/[125]/,gg=/1/,Id=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function Tb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?jg:l(7,o)-u>=c?wb:l(5,o)-u>=c?Ab:gg;if(f==gg){let h=Rn(l(1,o)-u);if(h<c)return Id(e.slice().reverse(),a.distr,f,Fi(c/h)).reverse()}return Id(e,a.distr,f,1)}function Eb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=Rn(l(1,o)-l(2,o));return c<a?Id(e.slice().reverse(),3,jg,Fi(a/c)).reverse():e}function Cb(n,e,t,i){return i==null?Od:e==null?"":zd(e)}var _g={show:!0,scale:"y",stroke:Ud,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Zg,side:3,grid:Wd,ticks:Yg,border:Jg,font:Xd,lineGap:Kg,rotate:0};function Rb(n,e){let t=3+(n||1)*2;return Ht(t*e,3)}function Pb(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=Rn(o-r),l=n.series[e],c=a/(l.points.space*Tt);return i[1]-i[0]<=c}var xg={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},Qg=(n,e,t,i,s)=>s,yg={show:!0,auto:!0,sorted:0,gaps:Qg,alpha:1,facets:[xn({},xg,{scale:"x"}),xn({},xg,{scale:"y"})]},vg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:Qg,alpha:1,points:{show:Pb,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function Ib(n,e,t,i,s){return t/10}var e0={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Lb=xn({},e0,{time:!1,ori:1}),bg={};function t0(n,e){let t=bg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(bg[n]=t)),t}var _o=1,Ld=2;function kr(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,b=a.height,g=n.valToPosH,m=n.valToPosV;return u.ori==0?t(s,l,c,u,f,g,m,h,d,p,b,dc,yo,pc,i0,r0):t(s,l,c,u,f,m,g,d,h,b,p,fc,vo,Yd,s0,o0)}function qd(n,e){let t=0,i=0,s=wt(n.bands,Vd);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Db(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Is(n,e,t,i,s,r){return kr(n,e,(o,a,l,c,u,f,h,d,p,b,g)=>{let m=o.pxRound,v=c.dir*(c.ori==0?1:-1),E=c.ori==0?yo:vo,M,L;v==1?(M=t,L=i):(M=i,L=t);let C=m(f(a[M],c,b,d)),_=m(h(l[M],u,g,p)),T=m(f(a[L],c,b,d)),k=m(h(r==1?u.max:u.min,u,g,p)),U=new Path2D(s);return E(U,T,k),E(U,C,k),E(U,C,_),U})}function hc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?pc:Yd,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function Nb(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function $d(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),b=f-s;d=o<=0&&b>=0&&b<l?r(n[b]):d;let m=h+s;p=o>=0&&m>=0&&m<l?r(n[m]):p,p>=d&&a.push([d,p])}return a}function Sg(n){return n==0?Lg:n==1?Cn:e=>Nr(e,n)}function n0(n){let e=n==0?dc:fc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=$i(c,a/2,l/2),u=$i(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var dc=(n,e,t)=>{n.moveTo(e,t)},fc=(n,e,t)=>{n.moveTo(t,e)},yo=(n,e,t)=>{n.lineTo(e,t)},vo=(n,e,t)=>{n.lineTo(t,e)},pc=n0(0),Yd=n0(1),i0=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},s0=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},r0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},o0=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function a0(n){return(e,t,i,s,r)=>kr(e,t,(o,a,l,c,u,f,h,d,p,b,g)=>{let{pxRound:m,points:v}=o,E,M;c.ori==0?(E=dc,M=i0):(E=fc,M=s0);let L=Ht(v.width*Tt,3),C=(v.size-v.width)/2*Tt,_=Ht(C*2,3),T=new Path2D,k=new Path2D,{left:U,top:D,width:H,height:O}=e.bbox;pc(k,U-_,D-_,H+_*2,O+_*2);let I=W=>{if(l[W]!=null){let $=m(f(a[W],c,b,d)),G=m(h(l[W],u,g,p));E(T,$+C,G),M(T,$,G,C,0,ic*2)}};if(r)r.forEach(I);else for(let W=i;W<=s;W++)I(W);return{stroke:L>0?T:null,fill:T,clip:k,flags:_o|Ld}})}function l0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Ub=l0(yo),Ob=l0(vo);function c0(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>kr(t,i,(o,a,l,c,u,f,h,d,p,b,g)=>{[s,r]=ac(l,s,r);let m=o.pxRound,v=O=>m(f(O,c,b,d)),E=O=>m(h(O,u,g,p)),M,L;c.ori==0?(M=yo,L=Ub):(M=vo,L=Ob);let C=c.dir*(c.ori==0?1:-1),_={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:_o},T=_.stroke,k=!1;if(r-s>=b*4){let O=he=>t.posToVal(he,c.key,!0),I=null,W=null,$,G,le,Z=v(a[C==1?s:r]),Q=v(a[s]),ie=v(a[r]),de=O(C==1?Q+1:ie-1);for(let he=C==1?s:r;he>=s&&he<=r;he+=C){let ee=a[he],_e=(C==1?ee<de:ee>de)?Z:v(ee),Re=l[he];_e==Z?Re!=null?(G=Re,I==null?(M(T,_e,E(G)),$=I=W=G):G<I?I=G:G>W&&(W=G)):Re===null&&(k=!0):(I!=null&&L(T,Z,E(I),E(W),E($),E(G)),Re!=null?(G=Re,M(T,_e,E(G)),I=W=$=G):(I=W=null,Re===null&&(k=!0)),Z=_e,de=O(Z+C))}I!=null&&I!=W&&le!=Z&&L(T,Z,E(I),E(W),E($),E(G))}else for(let O=C==1?s:r;O>=s&&O<=r;O+=C){let I=l[O];I===null?k=!0:I!=null&&M(T,v(a[O]),E(I))}let[D,H]=qd(t,i);if(o.fill!=null||D!=0){let O=_.fill=new Path2D(T),I=o.fillTo(t,i,o.min,o.max,D),W=E(I),$=v(a[s]),G=v(a[r]);C==-1&&([G,$]=[$,G]),M(O,G,W),M(O,$,W)}if(!o.spanGaps){let O=[];k&&O.push(...$d(a,l,s,r,C,v,e)),_.gaps=O=o.gaps(t,i,s,r,O),_.clip=hc(O,c.ori,d,p,b,g)}return H!=0&&(_.band=H==2?[Is(t,i,s,r,T,-1),Is(t,i,s,r,T,1)]:Is(t,i,s,r,T,H)),_})}function Fb(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>kr(r,o,(c,u,f,h,d,p,b,g,m,v,E)=>{[a,l]=ac(f,a,l);let M=c.pxRound,{left:L,width:C}=r.bbox,_=Q=>M(p(Q,h,v,g)),T=Q=>M(b(Q,d,E,m)),k=h.ori==0?yo:vo,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:_o},D=U.stroke,H=h.dir*(h.ori==0?1:-1),O=T(f[H==1?a:l]),I=_(u[H==1?a:l]),W=I,$=I;s&&e==-1&&($=L,k(D,$,O)),k(D,I,O);for(let Q=H==1?a:l;Q>=a&&Q<=l;Q+=H){let ie=f[Q];if(ie==null)continue;let de=_(u[Q]),he=T(ie);e==1?k(D,de,O):k(D,W,he),k(D,de,he),O=he,W=de}let G=W;s&&e==1&&(G=L+C,k(D,G,O));let[le,Z]=qd(r,o);if(c.fill!=null||le!=0){let Q=U.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,le),de=T(ie);k(Q,G,de),k(Q,$,de)}if(!c.spanGaps){let Q=[];Q.push(...$d(u,f,a,l,H,_,i));let ie=c.width*Tt/2,de=t||e==1?ie:-ie,he=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=de,ee[1]+=he}),U.gaps=Q=c.gaps(r,o,a,l,Q),U.clip=hc(Q,h.ori,g,m,v,E)}return Z!=0&&(U.band=Z==2?[Is(r,o,a,l,D,-1),Is(r,o,a,l,D,1)]:Is(r,o,a,l,D,Z)),U})}function Mg(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=Rn(n[l]-n[a]);u<c&&(c=u,o=Rn(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Bb(n){n=n||Ca;let e=wt(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=wt(e[1],Vt),l=wt(e[2],1),c=wt(n.disp,Ca),u=wt(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,b,g)=>kr(d,p,(m,v,E,M,L,C,_,T,k,U,D)=>{let H=m.pxRound,O=t,I=i*Tt,W=a*Tt,$=l*Tt,G,le;M.ori==0?[G,le]=r(d,p):[le,G]=r(d,p);let Z=M.dir*(M.ori==0?1:-1),Q=M.ori==0?pc:Yd,ie=M.ori==0?u:(Ie,Ze,ct,Ae,zt,He,$e)=>{u(Ie,Ze,ct,zt,Ae,$e,He)},de=wt(d.bands,Vd).find(Ie=>Ie.series[0]==p),he=de!=null?de.dir:0,ee=m.fillTo(d,p,m.min,m.max,he),ge=H(_(ee,L,D,k)),_e,Re,ve,We=U,me=H(m.width*Tt),be=!1,je=null,rt=null,at=null,Zt=null;f!=null&&(me==0||h!=null)&&(be=!0,je=f.values(d,p,b,g),rt=new Map,new Set(je).forEach(Ie=>{Ie!=null&&rt.set(Ie,new Path2D)}),me>0&&(at=h.values(d,p,b,g),Zt=new Map,new Set(at).forEach(Ie=>{Ie!=null&&Zt.set(Ie,new Path2D)})));let{x0:Gt,size:un}=c;if(Gt!=null&&un!=null){O=1,v=Gt.values(d,p,b,g),Gt.unit==2&&(v=v.map(ct=>d.posToVal(T+ct*U,M.key,!0)));let Ie=un.values(d,p,b,g);un.unit==2?Re=Ie[0]*U:Re=C(Ie[0],M,U,T)-C(0,M,U,T),We=Mg(v,E,C,M,U,T,We),ve=We-Re+I}else We=Mg(v,E,C,M,U,T,We),ve=We*o+I,Re=We-ve;ve<1&&(ve=0),me>=Re/2&&(me=0),ve<5&&(H=Lg);let Ft=ve>0,Dn=We-ve-(Ft?me:0);Re=H(Rd(Dn,$,W)),_e=(O==0?Re/2:O==Z?0:Re)-O*Z*((O==0?I/2:0)+(Ft?me/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},Sn=be?null:new Path2D,en=null;if(de!=null)en=d.data[de.series[1]];else{let{y0:Ie,y1:Ze}=c;Ie!=null&&Ze!=null&&(E=Ze.values(d,p,b,g),en=Ie.values(d,p,b,g))}let hn=G*Re,B=le*Re;for(let Ie=Z==1?b:g;Ie>=b&&Ie<=g;Ie+=Z){let Ze=E[Ie];if(Ze==null)continue;if(en!=null){let q=en[Ie]??0;if(Ze-q==0)continue;ge=_(q,L,D,k)}let ct=M.distr!=2||c!=null?v[Ie]:Ie,Ae=C(ct,M,U,T),zt=_(wt(Ze,ee),L,D,k),He=H(Ae-_e),$e=H(oi(zt,ge)),R=H($i(zt,ge)),S=$e-R;if(Ze!=null){let q=Ze<0?B:hn,ue=Ze<0?hn:B;be?(me>0&&at[Ie]!=null&&Q(Zt.get(at[Ie]),He,R+wi(me/2),Re,oi(0,S-me),q,ue),je[Ie]!=null&&Q(rt.get(je[Ie]),He,R+wi(me/2),Re,oi(0,S-me),q,ue)):Q(Sn,He,R+wi(me/2),Re,oi(0,S-me),q,ue),ie(d,p,Ie,He-me/2,R,Re+me,S)}}return me>0?bt.stroke=be?Zt:Sn:be||(bt._fill=m.width==0?m._fill:m._stroke??m._fill,bt.width=0),bt.fill=be?rt:Sn,bt})}function kb(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>kr(i,s,(a,l,c,u,f,h,d,p,b,g,m)=>{[r,o]=ac(c,r,o);let v=a.pxRound,E=G=>v(h(G,u,g,p)),M=G=>v(d(G,f,m,b)),L,C,_;u.ori==0?(L=dc,_=yo,C=r0):(L=fc,_=vo,C=o0);let T=u.dir*(u.ori==0?1:-1),k=E(l[T==1?r:o]),U=k,D=[],H=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let Z=l[G],Q=E(Z);D.push(U=Q),H.push(M(c[G]))}let O={stroke:n(D,H,L,_,C,v),fill:null,clip:null,band:null,gaps:null,flags:_o},I=O.stroke,[W,$]=qd(i,s);if(a.fill!=null||W!=0){let G=O.fill=new Path2D(I),le=a.fillTo(i,s,a.min,a.max,W),Z=M(le);_(G,U,Z),_(G,k,Z)}if(!a.spanGaps){let G=[];G.push(...$d(l,c,r,o,T,E,t)),O.gaps=G=a.gaps(i,s,r,o,G),O.clip=hc(G,u.ori,p,b,g,m)}return $!=0&&(O.band=$==2?[Is(i,s,r,o,I,-1),Is(i,s,r,o,I,1)]:Is(i,s,r,o,I,$)),O})}function zb(n){return kb(Vb,n)}function Vb(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var Dd=new Set;function wg(){for(let n of Dd)n.syncRect(!0)}xo&&(Fr(bv,fo,wg),Fr(Sv,fo,wg,!0),Fr(sc,fo,()=>{Xn.pxRatio=Tt}));var Hb=c0(),Gb=a0();function Ag(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Nd(r,o,e,t))}function Wb(n,e){return n.map((t,i)=>i==0?{}:xn({},e,t))}function Nd(n,e,t,i){return xn({},e==0?t:i,n)}function u0(n,e,t){return e==null?mo:[e,t]}var Xb=u0;function qb(n,e,t){return e==null?mo:rc(e,t,kd,!0)}function h0(n,e,t,i){return e==null?mo:lc(e,t,n.scales[i].log,!1)}var $b=h0;function d0(n,e,t,i){return e==null?mo:Bd(e,t,n.scales[i].log,!1)}var Yb=d0;function Jb(n,e,t,i,s){let r=oi(ig(n),ig(e)),o=e-n,a=qi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?sr.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function Tg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Cn((t=+s)*Tt))+"px"),[n,e,t]}function Zb(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ht(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Xn(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(x,w,P,N){let X=w.valToPct(x);return N+P*(w.dir==-1?1-X:X)}function o(x,w,P,N){let X=w.valToPct(x);return N+P*(w.dir==-1?X:1-X)}function a(x,w,P,N){return w.ori==0?r(x,w,P,N):o(x,w,P,N)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Oi(iv);if(n.id!=null&&(c.id=n.id),Mi(c,n.class),n.title){let x=Oi(ov,c);x.textContent=n.title}let u=Xi("canvas"),f=i.ctx=u.getContext("2d"),h=Oi(av,c);Fr("click",h,x=>{x.target===p&&(Xt!=ro||Kt!=oo)&&Wn.click(i,x)},!0);let d=i.under=Oi(lv,h);h.appendChild(u);let p=i.over=Oi(cv,h);n=go(n);let b=+wt(n.pxAlign,1),g=Sg(b);(n.plugins||[]).forEach(x=>{x.opts&&(n=x.opts(i,n)||n)});let m=n.ms||.001,v=i.series=s==1?Ag(n.series||[],mg,vg,!1):Wb(n.series||[null],yg),E=i.axes=Ag(n.axes||[],pg,_g,!0),M=i.scales={},L=i.bands=n.bands||[];L.forEach(x=>{x.fill=yt(x.fill||null),x.dir=wt(x.dir,-1)});let C=s==2?v[1].facets[0].scale:v[0].scale,_={axes:As,series:gt},T=(n.drawOrder||["axes","series"]).map(x=>_[x]);function k(x){let w=x.distr==3?P=>Ps(P>0?P:x.clamp(i,P,x.min,x.max,x.key)):x.distr==4?P=>bd(P,x.asinh):x.distr==100?P=>x.fwd(P):P=>P;return P=>{let N=w(P),{_min:X,_max:K}=x,ae=K-X;return(N-X)/ae}}function U(x){let w=M[x];if(w==null){let P=(n.scales||Ca)[x]||Ca;if(P.from!=null){U(P.from);let N=xn({},M[P.from],P,{key:x});N.valToPct=k(N),M[x]=N}else{w=M[x]=xn({},x==C?e0:Lb,P),w.key=x;let N=w.time,X=w.range,K=ir(X);if((x!=C||s==2&&!N)&&(K&&(X[0]==null||X[1]==null)&&(X={min:X[0]==null?eg:{mode:1,hard:X[0],soft:X[0]},max:X[1]==null?eg:{mode:1,hard:X[1],soft:X[1]}},K=!1),!K&&uc(X))){let ae=X;X=(fe,Me,Ue)=>Me==null?mo:rc(Me,Ue,ae)}w.range=yt(X||(N?Xb:x==C?w.distr==3?$b:w.distr==4?Yb:u0:w.distr==3?h0:w.distr==4?d0:qb)),w.auto=yt(K?!1:w.auto),w.clamp=yt(w.clamp||Ib),w._min=w._max=null,w.valToPct=k(w)}}}U("x"),U("y"),s==1&&v.forEach(x=>{U(x.scale)}),E.forEach(x=>{U(x.scale)});for(let x in n.scales)U(x);let D=M[C],H=D.distr,O,I;D.ori==0?(Mi(c,sv),O=r,I=o):(Mi(c,rv),O=o,I=r);let W={};for(let x in M){let w=M[x];(w.min!=null||w.max!=null)&&(W[x]={min:w.min,max:w.max},w.min=w.max=null)}let $=n.tzDate||(x=>new Date(Cn(x/m))),G=n.fmtDate||Hd,le=m==1?sb($):ab($),Z=hg($,ug(m==1?ib:ob,G)),Q=fg($,dg(cb,G)),ie=[],de=i.legend=xn({},db,n.legend),he=i.cursor=xn({},xb,{drag:{y:s==2}},n.cursor),ee=de.show,ge=he.show,_e=de.markers;de.idxs=ie,_e.width=yt(_e.width),_e.dash=yt(_e.dash),_e.stroke=yt(_e.stroke),_e.fill=yt(_e.fill);let Re,ve,We,me=[],be=[],je,rt=!1,at={};if(de.live){let x=v[1]?v[1].values:null;rt=x!=null,je=rt?x(i,1,0):{_:0};for(let w in je)at[w]=Od}if(ee)if(Re=Xi("table",mv,c),We=Xi("tbody",null,Re),de.mount(i,Re),rt){ve=Xi("thead",null,Re,We);let x=Xi("tr",null,ve);Xi("th",null,x);for(var Zt in je)Xi("th",Vm,x).textContent=Zt}else Mi(Re,_v),de.live&&Mi(Re,gv);let Gt={show:!0},un={show:!1};function Ft(x,w){if(w==0&&(rt||!de.live||s==2))return mo;let P=[],N=Xi("tr",xv,We,We.childNodes[w]);Mi(N,x.class),x.show||Mi(N,Or);let X=Xi("th",null,N);if(_e.show){let fe=Oi(yv,X);if(w>0){let Me=_e.width(i,w);Me&&(fe.style.border=Me+"px "+_e.dash(i,w)+" "+_e.stroke(i,w)),fe.style.background=_e.fill(i,w)}}let K=Oi(Vm,X);x.label instanceof HTMLElement?K.appendChild(x.label):K.textContent=x.label,w>0&&(_e.show||(K.style.color=x.width>0?_e.stroke(i,w):_e.fill(i,w)),bt("click",X,fe=>{if(he._lock)return;tt(fe);let Me=v.indexOf(x);if((fe.ctrlKey||fe.metaKey)!=de.isolate){let Ue=v.some((Oe,Be)=>Be>0&&Be!=Me&&Oe.show);v.forEach((Oe,Be)=>{Be>0&&os(Be,Ue?Be==Me?Gt:un:Gt,!0,mn.setSeries)})}else os(Me,{show:!x.show},!0,mn.setSeries)},!1),nt&&bt(Xm,X,fe=>{he._lock||(tt(fe),os(v.indexOf(x),lo,!0,mn.setSeries))},!1));for(var ae in je){let fe=Xi("td",vv,N);fe.textContent="--",P.push(fe)}return[N,P]}let Dn=new Map;function bt(x,w,P,N=!0){let X=Dn.get(w)||{},K=he.bind[x](i,w,P,N);K&&(Fr(x,w,X[x]=K),Dn.set(w,X))}function Sn(x,w,P){let N=Dn.get(w)||{};for(let X in N)(x==null||X==x)&&(Cd(X,w,N[X]),delete N[X]);x==null&&Dn.delete(w)}let en=0,hn=0,B=0,Ie=0,Ze=0,ct=0,Ae=Ze,zt=ct,He=B,$e=Ie,R=0,S=0,q=0,ue=0;i.bbox={};let oe=!1,ye=!1,Se=!1,te=!1,se=!1,pe=!1;function F(x,w,P){(P||x!=i.width||w!=i.height)&&re(x,w),ft(!1),Se=!0,ye=!0,Jn()}function re(x,w){i.width=en=B=x,i.height=hn=Ie=w,Ze=ct=0,we(),Xe();let P=i.bbox;R=P.left=Nr(Ze*Tt,.5),S=P.top=Nr(ct*Tt,.5),q=P.width=Nr(B*Tt,.5),ue=P.height=Nr(Ie*Tt,.5)}let ne=3;function Te(){let x=!1,w=0;for(;!x;){w++;let P=no(w),N=rs(w);x=w==ne||P&&N,x||(re(i.width,i.height),ye=!0)}}function xe({width:x,height:w}){F(x,w)}i.setSize=xe;function we(){let x=!1,w=!1,P=!1,N=!1;E.forEach((X,K)=>{if(X.show&&X._show){let{side:ae,_size:fe}=X,Me=ae%2,Ue=X.label!=null?X.labelSize:0,Oe=fe+Ue;Oe>0&&(Me?(B-=Oe,ae==3?(Ze+=Oe,N=!0):P=!0):(Ie-=Oe,ae==0?(ct+=Oe,x=!0):w=!0))}}),is[0]=x,is[1]=P,is[2]=w,is[3]=N,B-=Vi[1]+Vi[3],Ze+=Vi[3],Ie-=Vi[2]+Vi[0],ct+=Vi[0]}function Xe(){let x=Ze+B,w=ct+Ie,P=Ze,N=ct;function X(K,ae){switch(K){case 1:return x+=ae,x-ae;case 2:return w+=ae,w-ae;case 3:return P-=ae,P+ae;case 0:return N-=ae,N+ae}}E.forEach((K,ae)=>{if(K.show&&K._show){let fe=K.side;K._pos=X(fe,K._size),K.label!=null&&(K._lpos=X(fe,K.labelSize))}})}if(he.dataIdx==null){let x=he.hover,w=x.skip=new Set(x.skip??[]);w.add(void 0);let P=x.prox=yt(x.prox),N=x.bias??=0;he.dataIdx=(X,K,ae,fe)=>{if(K==0)return ae;let Me=ae,Ue=P(X,K,ae,fe)??Vt,Oe=Ue>=0&&Ue<Vt,Be=D.ori==0?B:Ie,lt=he.left,At=e[0],Mt=e[K];if(w.has(Mt[ae])){Me=null;let _t=null,Qe=null,qe;if(N==0||N==-1)for(qe=ae;_t==null&&qe-- >0;)w.has(Mt[qe])||(_t=qe);if(N==0||N==1)for(qe=ae;Qe==null&&qe++<Mt.length;)w.has(Mt[qe])||(Qe=qe);if(_t!=null||Qe!=null)if(Oe){let $t=_t==null?-1/0:O(At[_t],D,Be,0),sn=Qe==null?1/0:O(At[Qe],D,Be,0),Fn=lt-$t,Bt=sn-lt;Fn<=Bt?Fn<=Ue&&(Me=_t):Bt<=Ue&&(Me=Qe)}else Me=Qe==null?_t:_t==null?Qe:ae-_t<=Qe-ae?_t:Qe}else Oe&&Rn(lt-O(At[ae],D,Be,0))>Ue&&(Me=null);return Me}}let tt=x=>{he.event=x};he.idxs=ie,he._lock=!1;let ce=he.points;ce.show=yt(ce.show),ce.size=yt(ce.size),ce.stroke=yt(ce.stroke),ce.width=yt(ce.width),ce.fill=yt(ce.fill);let ke=i.focus=xn({},n.focus||{alpha:.3},he.focus),nt=ke.prox>=0,Pe=nt&&ce.one,ht=[],Wt=[],ti=[];function ua(x,w){let P=ce.show(i,w);if(P instanceof HTMLElement)return Mi(P,pv),Mi(P,x.class),ds(P,-10,-10,B,Ie),p.insertBefore(P,ht[w]),P}function Qr(x,w){if(s==1||w>0){let P=s==1&&M[x.scale].time,N=x.value;x.value=P?og(N)?fg($,dg(N,G)):N||Q:N||Cb,x.label=x.label||(P?vb:yb)}if(Pe||w>0){x.width=x.width==null?1:x.width,x.paths=x.paths||Hb||Lv,x.fillTo=yt(x.fillTo||Db),x.pxAlign=+wt(x.pxAlign,b),x.pxRound=Sg(x.pxAlign),x.stroke=yt(x.stroke||null),x.fill=yt(x.fill||null),x._stroke=x._fill=x._paths=x._focus=null;let P=Rb(oi(1,x.width),1),N=x.points=xn({},{size:P,width:oi(1,P*.2),stroke:x.stroke,space:P*2,paths:Gb,_stroke:null,_fill:null},x.points);N.show=yt(N.show),N.filter=yt(N.filter),N.fill=yt(N.fill),N.stroke=yt(N.stroke),N.paths=yt(N.paths),N.pxAlign=x.pxAlign}if(ee){let P=Ft(x,w);me.splice(w,0,P[0]),be.splice(w,0,P[1]),de.values.push(null)}if(ge){ie.splice(w,0,null);let P=null;Pe?w==0&&(P=ua(x,w)):w>0&&(P=ua(x,w)),ht.splice(w,0,P),Wt.splice(w,0,0),ti.splice(w,0,0)}On("addSeries",w)}function Xh(x,w){w=w??v.length,x=s==1?Nd(x,w,mg,vg):Nd(x,w,{},yg),v.splice(w,0,x),Qr(v[w],w)}i.addSeries=Xh;function Ll(x){if(v.splice(x,1),ee){de.values.splice(x,1),be.splice(x,1);let w=me.splice(x,1)[0];Sn(null,w.firstChild),w.remove()}ge&&(ie.splice(x,1),ht.splice(x,1)[0].remove(),Wt.splice(x,1),ti.splice(x,1)),On("delSeries",x)}i.delSeries=Ll;let is=[!1,!1,!1,!1];function Ss(x,w){if(x._show=x.show,x.show){let P=x.side%2,N=M[x.scale];N==null&&(x.scale=P?v[1].scale:C,N=M[x.scale]);let X=N.time;x.size=yt(x.size),x.space=yt(x.space),x.rotate=yt(x.rotate),ir(x.incrs)&&x.incrs.forEach(ae=>{!sr.has(ae)&&sr.set(ae,Ug(ae))}),x.incrs=yt(x.incrs||(N.distr==2?eb:X?m==1?nb:rb:Ur)),x.splits=yt(x.splits||(X&&N.distr==1?le:N.distr==3?Pd:N.distr==4?Mb:Sb)),x.stroke=yt(x.stroke),x.grid.stroke=yt(x.grid.stroke),x.ticks.stroke=yt(x.ticks.stroke),x.border.stroke=yt(x.border.stroke);let K=x.values;x.values=ir(K)&&!ir(K[0])?yt(K):X?ir(K)?hg($,ug(K,G)):og(K)?lb($,K):K||Z:K||bb,x.filter=yt(x.filter||(N.distr>=3&&N.log==10?Tb:N.distr==3&&N.log==2?Eb:Dg)),x.font=Tg(x.font),x.labelFont=Tg(x.labelFont),x._size=x.size(i,null,w,0),x._space=x._rotate=x._incrs=x._found=x._splits=x._values=null,x._size>0&&(is[w]=!0,x._el=Oi(uv,h))}}function Ms(x,w,P,N){let[X,K,ae,fe]=P,Me=w%2,Ue=0;return Me==0&&(fe||K)&&(Ue=w==0&&!X||w==2&&!ae?Cn(pg.size/3):0),Me==1&&(X||ae)&&(Ue=w==1&&!K||w==3&&!fe?Cn(_g.size/2):0),Ue}let ha=i.padding=(n.padding||[Ms,Ms,Ms,Ms]).map(x=>yt(wt(x,Ms))),Vi=i._padding=ha.map((x,w)=>x(i,w,is,0)),tn,an=null,ln=null,ss=s==1?v[0].idxs:null,yi=null,qs=!1;function da(x,w){if(e=x??[],i.data=i._data=e,s==2){tn=0;for(let P=1;P<v.length;P++)tn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),yi=e[0],tn=yi.length;let P=e;if(H==2){P=e.slice();let N=P[0]=Array(tn);for(let X=0;X<tn;X++)N[X]=X}i._data=e=P}if(ft(!0),On("setData"),H==2&&(Se=!0),w!==!1){let P=D;P.auto(i,qs)?fa():Js(C,P.min,P.max),te=te||he.left>=0,pe=!0,Jn()}}i.setData=da;function fa(){qs=!0;let x,w;s==1&&(tn>0?(an=ss[0]=0,ln=ss[1]=tn-1,x=e[0][an],w=e[0][ln],H==2?(x=an,w=ln):x==w&&(H==3?[x,w]=lc(x,x,D.log,!1):H==4?[x,w]=Bd(x,x,D.log,!1):D.time?w=x+Cn(86400/m):[x,w]=rc(x,w,kd,!0))):(an=ss[0]=x=null,ln=ss[1]=w=null)),Js(C,x,w)}let eo,$s,to,A,z,j,Y,J,Ee,De;function Ce(x,w,P,N,X,K){x??=Gm,P??=Vd,N??="butt",X??=Gm,K??="round",x!=eo&&(f.strokeStyle=eo=x),X!=$s&&(f.fillStyle=$s=X),w!=to&&(f.lineWidth=to=w),K!=z&&(f.lineJoin=z=K),N!=j&&(f.lineCap=j=N),P!=A&&f.setLineDash(A=P)}function Ne(x,w,P,N){w!=$s&&(f.fillStyle=$s=w),x!=Y&&(f.font=Y=x),P!=J&&(f.textAlign=J=P),N!=Ee&&(f.textBaseline=Ee=N)}function Ve(x,w,P,N,X=0){if(N.length>0&&x.auto(i,qs)&&(w==null||w.min==null)){let K=wt(an,0),ae=wt(ln,N.length-1),fe=P.min==null?Tv(N,K,ae,X,x.distr==3):[P.min,P.max];x.min=$i(x.min,P.min=fe[0]),x.max=oi(x.max,P.max=fe[1])}}let it={min:null,max:null};function mt(){for(let N in M){let X=M[N];W[N]==null&&(X.min==null||W[C]!=null&&X.auto(i,qs))&&(W[N]=it)}for(let N in M){let X=M[N];W[N]==null&&X.from!=null&&W[X.from]!=null&&(W[N]=it)}W[C]!=null&&ft(!0);let x={};for(let N in W){let X=W[N];if(X!=null){let K=x[N]=go(M[N],Uv);if(X.min!=null)xn(K,X);else if(N!=C||s==2)if(tn==0&&K.from==null){let ae=K.range(i,null,null,N);K.min=ae[0],K.max=ae[1]}else K.min=Vt,K.max=-Vt}}if(tn>0){v.forEach((N,X)=>{if(s==1){let K=N.scale,ae=W[K];if(ae==null)return;let fe=x[K];if(X==0){let Me=fe.range(i,fe.min,fe.max,K);fe.min=Me[0],fe.max=Me[1],an=qi(fe.min,e[0]),ln=qi(fe.max,e[0]),ln-an>1&&(e[0][an]<fe.min&&an++,e[0][ln]>fe.max&&ln--),N.min=yi[an],N.max=yi[ln]}else N.show&&N.auto&&Ve(fe,ae,N,e[X],N.sorted);N.idxs[0]=an,N.idxs[1]=ln}else if(X>0&&N.show&&N.auto){let[K,ae]=N.facets,fe=K.scale,Me=ae.scale,[Ue,Oe]=e[X],Be=x[fe],lt=x[Me];Be!=null&&Ve(Be,W[fe],K,Ue,K.sorted),lt!=null&&Ve(lt,W[Me],ae,Oe,ae.sorted),N.min=ae.min,N.max=ae.max}});for(let N in x){let X=x[N],K=W[N];if(X.from==null&&(K==null||K.min==null)){let ae=X.range(i,X.min==Vt?null:X.min,X.max==-Vt?null:X.max,N);X.min=ae[0],X.max=ae[1]}}}for(let N in x){let X=x[N];if(X.from!=null){let K=x[X.from];if(K.min==null)X.min=X.max=null;else{let ae=X.range(i,K.min,K.max,N);X.min=ae[0],X.max=ae[1]}}}let w={},P=!1;for(let N in x){let X=x[N],K=M[N];if(K.min!=X.min||K.max!=X.max){K.min=X.min,K.max=X.max;let ae=K.distr;K._min=ae==3?Ps(K.min):ae==4?bd(K.min,K.asinh):ae==100?K.fwd(K.min):K.min,K._max=ae==3?Ps(K.max):ae==4?bd(K.max,K.asinh):ae==100?K.fwd(K.max):K.max,w[N]=P=!0}}if(P){v.forEach((N,X)=>{s==2?X>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)Se=!0,On("setScale",N);ge&&he.left>=0&&(te=pe=!0)}for(let N in W)W[N]=null}function ze(x){let w=Rd(an-1,0,tn-1),P=Rd(ln+1,0,tn-1);for(;x[w]==null&&w>0;)w--;for(;x[P]==null&&P<tn-1;)P++;return[w,P]}function gt(){if(tn>0){let x=v.some(w=>w._focus)&&De!=ke.alpha;x&&(f.globalAlpha=De=ke.alpha),v.forEach((w,P)=>{if(P>0&&w.show&&(Qt(P,!1),Qt(P,!0),w._paths==null)){let N=De;De!=w.alpha&&(f.globalAlpha=De=w.alpha);let X=s==2?[0,e[P][0].length-1]:ze(e[P]);w._paths=w.paths(i,P,X[0],X[1]),De!=N&&(f.globalAlpha=De=N)}}),v.forEach((w,P)=>{if(P>0&&w.show){let N=De;De!=w.alpha&&(f.globalAlpha=De=w.alpha),w._paths!=null&&It(P,!1);{let X=w._paths!=null?w._paths.gaps:null,K=w.points.show(i,P,an,ln,X),ae=w.points.filter(i,P,K,X);(K||ae)&&(w.points._paths=w.points.paths(i,P,an,ln,ae),It(P,!0))}De!=N&&(f.globalAlpha=De=N),On("drawSeries",P)}}),x&&(f.globalAlpha=De=1)}}function Qt(x,w){let P=w?v[x].points:v[x];P._stroke=P.stroke(i,x),P._fill=P.fill(i,x)}function It(x,w){let P=w?v[x].points:v[x],{stroke:N,fill:X,clip:K,flags:ae,_stroke:fe=P._stroke,_fill:Me=P._fill,_width:Ue=P.width}=P._paths;Ue=Ht(Ue*Tt,3);let Oe=null,Be=Ue%2/2;w&&Me==null&&(Me=Ue>0?"#fff":fe);let lt=P.pxAlign==1&&Be>0;if(lt&&f.translate(Be,Be),!w){let At=R-Ue/2,Mt=S-Ue/2,_t=q+Ue,Qe=ue+Ue;Oe=new Path2D,Oe.rect(At,Mt,_t,Qe)}w?Fe(fe,Ue,P.dash,P.cap,Me,N,X,ae,K):Lt(x,fe,Ue,P.dash,P.cap,Me,N,X,ae,Oe,K),lt&&f.translate(-Be,-Be)}function Lt(x,w,P,N,X,K,ae,fe,Me,Ue,Oe){let Be=!1;Me!=0&&L.forEach((lt,At)=>{if(lt.series[0]==x){let Mt=v[lt.series[1]],_t=e[lt.series[1]],Qe=(Mt._paths||Ca).band;ir(Qe)&&(Qe=lt.dir==1?Qe[0]:Qe[1]);let qe,$t=null;Mt.show&&Qe&&Cv(_t,an,ln)?($t=lt.fill(i,At)||K,qe=Mt._paths.clip):Qe=null,Fe(w,P,N,X,$t,ae,fe,Me,Ue,Oe,qe,Qe),Be=!0}}),Be||Fe(w,P,N,X,K,ae,fe,Me,Ue,Oe)}let Mn=_o|Ld;function Fe(x,w,P,N,X,K,ae,fe,Me,Ue,Oe,Be){Ce(x,w,P,N,X),(Me||Ue||Be)&&(f.save(),Me&&f.clip(Me),Ue&&f.clip(Ue)),Be?(fe&Mn)==Mn?(f.clip(Be),Oe&&f.clip(Oe),xt(X,ae),dn(x,K,w)):fe&Ld?(xt(X,ae),f.clip(Be),dn(x,K,w)):fe&_o&&(f.save(),f.clip(Be),Oe&&f.clip(Oe),xt(X,ae),f.restore(),dn(x,K,w)):(xt(X,ae),dn(x,K,w)),(Me||Ue||Be)&&f.restore()}function dn(x,w,P){P>0&&(w instanceof Map?w.forEach((N,X)=>{f.strokeStyle=eo=X,f.stroke(N)}):w!=null&&x&&f.stroke(w))}function xt(x,w){w instanceof Map?w.forEach((P,N)=>{f.fillStyle=$s=N,f.fill(P)}):w!=null&&x&&f.fill(w)}function ws(x,w,P,N){let X=E[x],K;if(N<=0)K=[0,0];else{let ae=X._space=X.space(i,x,w,P,N),fe=X._incrs=X.incrs(i,x,w,P,N,ae);K=Jb(w,P,fe,N,ae)}return X._found=K}function fn(x,w,P,N,X,K,ae,fe,Me,Ue){let Oe=ae%2/2;b==1&&f.translate(Oe,Oe),Ce(fe,ae,Me,Ue,fe),f.beginPath();let Be,lt,At,Mt,_t=X+(N==0||N==3?-K:K);P==0?(lt=X,Mt=_t):(Be=X,At=_t);for(let Qe=0;Qe<x.length;Qe++)w[Qe]!=null&&(P==0?Be=At=x[Qe]:lt=Mt=x[Qe],f.moveTo(Be,lt),f.lineTo(At,Mt));f.stroke(),b==1&&f.translate(-Oe,-Oe)}function no(x){let w=!0;return E.forEach((P,N)=>{if(!P.show)return;let X=M[P.scale];if(X.min==null){P._show&&(w=!1,P._show=!1,ft(!1));return}else P._show||(w=!1,P._show=!0,ft(!1));let K=P.side,ae=K%2,{min:fe,max:Me}=X,[Ue,Oe]=ws(N,fe,Me,ae==0?B:Ie);if(Oe==0)return;let Be=X.distr==2,lt=P._splits=P.splits(i,N,fe,Me,Ue,Oe,Be),At=X.distr==2?lt.map(qe=>yi[qe]):lt,Mt=X.distr==2?yi[lt[1]]-yi[lt[0]]:Ue,_t=P._values=P.values(i,P.filter(i,At,N,Oe,Mt),N,Oe,Mt);P._rotate=K==2?P.rotate(i,_t,N,Oe):0;let Qe=P._size;P._size=Fi(P.size(i,_t,N,x)),Qe!=null&&P._size!=Qe&&(w=!1)}),w}function rs(x){let w=!0;return ha.forEach((P,N)=>{let X=P(i,N,is,x);X!=Vi[N]&&(w=!1),Vi[N]=X}),w}function As(){for(let x=0;x<E.length;x++){let w=E[x];if(!w.show||!w._show)continue;let P=w.side,N=P%2,X,K,ae=w.stroke(i,x),fe=P==0||P==3?-1:1,[Me,Ue]=w._found;if(w.label!=null){let si=w.labelGap*fe,Si=Cn((w._lpos+si)*Tt);Ne(w.labelFont[0],ae,"center",P==2?"top":Hm),f.save(),N==1?(X=K=0,f.translate(Si,Cn(S+ue/2)),f.rotate((P==3?-ic:ic)/2)):(X=Cn(R+q/2),K=Si);let Rr=Ig(w.label)?w.label(i,x,Me,Ue):w.label;f.fillText(Rr,X,K),f.restore()}if(Ue==0)continue;let Oe=M[w.scale],Be=N==0?q:ue,lt=N==0?R:S,At=w._splits,Mt=Oe.distr==2?At.map(si=>yi[si]):At,_t=Oe.distr==2?yi[At[1]]-yi[At[0]]:Me,Qe=w.ticks,qe=w.border,$t=Qe.show?Qe.size:0,sn=Cn($t*Tt),Fn=Cn((w.alignTo==2?w._size-$t-w.gap:w.gap)*Tt),Bt=w._rotate*-ic/180,rn=g(w._pos*Tt),vi=(sn+Fn)*fe,ii=rn+vi;K=N==0?ii:0,X=N==1?ii:0;let Li=w.font[0],Hi=w.align==1?uo:w.align==2?xd:Bt>0?uo:Bt<0?xd:N==0?"center":P==3?xd:uo,ls=Bt||N==1?"middle":P==2?"top":Hm;Ne(Li,ae,Hi,ls);let bi=w.font[1]*w.lineGap,Di=At.map(si=>g(a(si,Oe,Be,lt))),Gi=w._values;for(let si=0;si<Gi.length;si++){let Si=Gi[si];if(Si!=null){N==0?X=Di[si]:K=Di[si],Si=""+Si;let Rr=Si.indexOf(`
`)==-1?[Si]:Si.split(/\n/gm);for(let ri=0;ri<Rr.length;ri++){let im=Rr[ri];Bt?(f.save(),f.translate(X,K+ri*bi),f.rotate(Bt),f.fillText(im,0,0),f.restore()):f.fillText(im,X,K+ri*bi)}}}Qe.show&&fn(Di,Qe.filter(i,Mt,x,Ue,_t),N,P,rn,sn,Ht(Qe.width*Tt,3),Qe.stroke(i,x),Qe.dash,Qe.cap);let cs=w.grid;cs.show&&fn(Di,cs.filter(i,Mt,x,Ue,_t),N,N==0?2:1,N==0?S:R,N==0?ue:q,Ht(cs.width*Tt,3),cs.stroke(i,x),cs.dash,cs.cap),qe.show&&fn([rn],[1],N==0?1:0,N==0?1:2,N==1?S:R,N==1?ue:q,Ht(qe.width*Tt,3),qe.stroke(i,x),qe.dash,qe.cap)}On("drawAxes")}function ft(x){v.forEach((w,P)=>{P>0&&(w._paths=null,x&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let nn=!1,ni=!1,Dt=[];function pn(){ni=!1;for(let x=0;x<Dt.length;x++)On(...Dt[x]);Dt.length=0}function Jn(){nn||(Hv(kp),nn=!0)}function Dl(x,w=!1){nn=!0,ni=w,x(i),kp(),w&&Dt.length>0&&queueMicrotask(pn)}i.batch=Dl;function kp(){if(oe&&(mt(),oe=!1),Se&&(Te(),Se=!1),ye){if(Yt(d,uo,Ze),Yt(d,"top",ct),Yt(d,wa,B),Yt(d,Aa,Ie),Yt(p,uo,Ze),Yt(p,"top",ct),Yt(p,wa,B),Yt(p,Aa,Ie),Yt(h,wa,en),Yt(h,Aa,hn),u.width=Cn(en*Tt),u.height=Cn(hn*Tt),E.forEach(({_el:x,_show:w,_size:P,_pos:N,side:X})=>{if(x!=null)if(w){let K=X===3||X===0?P:0,ae=X%2==1;Yt(x,ae?"left":"top",N-K),Yt(x,ae?"width":"height",P),Yt(x,ae?"top":"left",ae?ct:Ze),Yt(x,ae?"height":"width",ae?Ie:B),Ed(x,Or)}else Mi(x,Or)}),eo=$s=to=z=j=Y=J=Ee=A=null,De=1,ga(!0),Ze!=Ae||ct!=zt||B!=He||Ie!=$e){ft(!1);let x=B/He,w=Ie/$e;if(ge&&!te&&he.left>=0){he.left*=x,he.top*=w,io&&ds(io,Cn(he.left),0,B,Ie),so&&ds(so,0,Cn(he.top),B,Ie);for(let P=0;P<ht.length;P++){let N=ht[P];N!=null&&(Wt[P]*=x,ti[P]*=w,ds(N,Fi(Wt[P]),Fi(ti[P]),B,Ie))}}if(qt.show&&!se&&qt.left>=0&&qt.width>0){qt.left*=x,qt.width*=x,qt.top*=w,qt.height*=w;for(let P in Kh)Yt(ao,P,qt[P])}Ae=Ze,zt=ct,He=B,$e=Ie}On("setSize"),ye=!1}en>0&&hn>0&&(f.clearRect(0,0,u.width,u.height),On("drawClear"),T.forEach(x=>x()),On("draw")),qt.show&&se&&(Nl(qt),se=!1),ge&&te&&(Cr(null,!0,!1),te=!1),de.show&&de.live&&pe&&(Jh(),pe=!1),l||(l=!0,i.status=1,On("ready")),qs=!1,nn=!1}i.redraw=(x,w)=>{Se=w||!1,x!==!1?Js(C,D.min,D.max):Jn()};function qh(x,w){let P=M[x];if(P.from==null){if(tn==0){let N=P.range(i,w.min,w.max,x);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(tn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;x==C&&P.distr==2&&tn>0&&(w.min=qi(w.min,e[0]),w.max=qi(w.max,e[0]),w.min==w.max&&w.max++),W[x]=w,oe=!0,Jn()}}i.setScale=qh;let $h,Yh,io,so,zp,Vp,ro,oo,Hp,Gp,Xt,Kt,Ys=!1,Wn=he.drag,Nn=Wn.x,Un=Wn.y;ge&&(he.x&&($h=Oi(dv,p)),he.y&&(Yh=Oi(fv,p)),D.ori==0?(io=$h,so=Yh):(io=Yh,so=$h),Xt=he.left,Kt=he.top);let qt=i.select=xn({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),ao=qt.show?Oi(hv,qt.over?p:d):null;function Nl(x,w){if(qt.show){for(let P in x)qt[P]=x[P],P in Kh&&Yt(ao,P,x[P]);w!==!1&&On("setSelect")}}i.setSelect=Nl;function Ey(x){if(v[x].show)ee&&Ed(me[x],Or);else if(ee&&Mi(me[x],Or),ge){let P=Pe?ht[0]:ht[x];P!=null&&ds(P,-10,-10,B,Ie)}}function Js(x,w,P){qh(x,{min:w,max:P})}function os(x,w,P,N){w.focus!=null&&Ly(x),w.show!=null&&v.forEach((X,K)=>{K>0&&(x==K||x==null)&&(X.show=w.show,Ey(K),s==2?(Js(X.facets[0].scale,null,null),Js(X.facets[1].scale,null,null)):Js(X.scale,null,null),Jn())}),P!==!1&&On("setSeries",x,w),N&&_a("setSeries",i,x,w)}i.setSeries=os;function Cy(x,w){xn(L[x],w)}function Ry(x,w){x.fill=yt(x.fill||null),x.dir=wt(x.dir,-1),w=w??L.length,L.splice(w,0,x)}function Py(x){x==null?L.length=0:L.splice(x,1)}i.addBand=Ry,i.setBand=Cy,i.delBand=Py;function Iy(x,w){v[x].alpha=w,ge&&ht[x]!=null&&(ht[x].style.opacity=w),ee&&me[x]&&(me[x].style.opacity=w)}let Ts,Zs,Er,lo={focus:!0};function Ly(x){if(x!=Er){let w=x==null,P=ke.alpha!=1;v.forEach((N,X)=>{if(s==1||X>0){let K=w||X==0||X==x;N._focus=w?null:K,P&&Iy(X,K?1:ke.alpha)}}),Er=x,P&&Jn()}}ee&&nt&&bt(qm,Re,x=>{he._lock||(tt(x),Er!=null&&os(null,lo,!0,mn.setSeries))});function as(x,w,P){let N=M[w];P&&(x=x/Tt-(N.ori==1?ct:Ze));let X=B;N.ori==1&&(X=Ie,x=X-x),N.dir==-1&&(x=X-x);let K=N._min,ae=N._max,fe=x/X,Me=K+(ae-K)*fe,Ue=N.distr;return Ue==3?po(10,Me):Ue==4?Pv(Me,N.asinh):Ue==100?N.bwd(Me):Me}function Dy(x,w){let P=as(x,C,w);return qi(P,e[0],an,ln)}i.valToIdx=x=>qi(x,e[0]),i.posToIdx=Dy,i.posToVal=as,i.valToPos=(x,w,P)=>M[w].ori==0?r(x,M[w],P?q:B,P?R:0):o(x,M[w],P?ue:Ie,P?S:0),i.setCursor=(x,w,P)=>{Xt=x.left,Kt=x.top,Cr(null,w,P)};function Wp(x,w){Yt(ao,uo,qt.left=x),Yt(ao,wa,qt.width=w)}function Xp(x,w){Yt(ao,"top",qt.top=x),Yt(ao,Aa,qt.height=w)}let pa=D.ori==0?Wp:Xp,ma=D.ori==1?Wp:Xp;function Ny(){if(ee&&de.live)for(let x=s==2?1:0;x<v.length;x++){if(x==0&&rt)continue;let w=de.values[x],P=0;for(let N in w)be[x][P++].firstChild.nodeValue=w[N]}}function Jh(x,w){if(x!=null&&(x.idxs?x.idxs.forEach((P,N)=>{ie[N]=P}):Nv(x.idx)||ie.fill(x.idx),de.idx=ie[0]),ee&&de.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!rt)&&Uy(P,ie[P]);Ny()}pe=!1,w!==!1&&On("setLegend")}i.setLegend=Jh;function Uy(x,w){let P=v[x],N=x==0&&H==2?yi:e[x],X;rt?X=P.values(i,x,w)??at:(X=P.value(i,w==null?null:N[w],x,w),X=X==null?at:{_:X}),de.values[x]=X}function Cr(x,w,P){Hp=Xt,Gp=Kt,[Xt,Kt]=he.move(i,Xt,Kt),he.left=Xt,he.top=Kt,ge&&(io&&ds(io,Cn(Xt),0,B,Ie),so&&ds(so,0,Cn(Kt),B,Ie));let N,X=an>ln;Ts=Vt,Zs=null;let K=D.ori==0?B:Ie,ae=D.ori==1?B:Ie;if(Xt<0||tn==0||X){N=he.idx=null;for(let fe=0;fe<v.length;fe++){let Me=ht[fe];Me!=null&&ds(Me,-10,-10,B,Ie)}nt&&os(null,lo,!0,x==null&&mn.setSeries),de.live&&(ie.fill(N),pe=!0)}else{let fe,Me,Ue;s==1&&(fe=D.ori==0?Xt:Kt,Me=as(fe,C),N=he.idx=qi(Me,e[0],an,ln),Ue=O(e[0][N],D,K,0));let Oe=-10,Be=-10,lt=0,At=0,Mt=!0,_t="",Qe="";for(let qe=s==2?1:0;qe<v.length;qe++){let $t=v[qe],sn=ie[qe],Fn=sn==null?null:s==1?e[qe][sn]:e[qe][1][sn],Bt=he.dataIdx(i,qe,N,Me),rn=Bt==null?null:s==1?e[qe][Bt]:e[qe][1][Bt];if(pe=pe||rn!=Fn||Bt!=sn,ie[qe]=Bt,qe>0&&$t.show){let vi=Bt==null?-10:Bt==N?Ue:O(s==1?e[0][Bt]:e[qe][0][Bt],D,K,0),ii=rn==null?-10:I(rn,s==1?M[$t.scale]:M[$t.facets[1].scale],ae,0);if(nt&&rn!=null){let Li=D.ori==1?Xt:Kt,Hi=Rn(ke.dist(i,qe,Bt,ii,Li));if(Hi<Ts){let ls=ke.bias;if(ls!=0){let bi=as(Li,$t.scale),Di=rn>=0?1:-1,Gi=bi>=0?1:-1;Gi==Di&&(Gi==1?ls==1?rn>=bi:rn<=bi:ls==1?rn<=bi:rn>=bi)&&(Ts=Hi,Zs=qe)}else Ts=Hi,Zs=qe}}if(pe||Pe){let Li,Hi;D.ori==0?(Li=vi,Hi=ii):(Li=ii,Hi=vi);let ls,bi,Di,Gi,cs,si,Si=!0,Rr=ce.bbox;if(Rr!=null){Si=!1;let ri=Rr(i,qe);Di=ri.left,Gi=ri.top,ls=ri.width,bi=ri.height}else Di=Li,Gi=Hi,ls=bi=ce.size(i,qe);if(si=ce.fill(i,qe),cs=ce.stroke(i,qe),Pe)qe==Zs&&Ts<=ke.prox&&(Oe=Di,Be=Gi,lt=ls,At=bi,Mt=Si,_t=si,Qe=cs);else{let ri=ht[qe];ri!=null&&(Wt[qe]=Di,ti[qe]=Gi,Qm(ri,ls,bi,Si),Km(ri,si,cs),ds(ri,Fi(Di),Fi(Gi),B,Ie))}}}}if(Pe){let qe=ke.prox,$t=Er==null?Ts<=qe:Ts>qe||Zs!=Er;if(pe||$t){let sn=ht[0];sn!=null&&(Wt[0]=Oe,ti[0]=Be,Qm(sn,lt,At,Mt),Km(sn,_t,Qe),ds(sn,Fi(Oe),Fi(Be),B,Ie))}}}if(qt.show&&Ys)if(x!=null){let[fe,Me]=mn.scales,[Ue,Oe]=mn.match,[Be,lt]=x.cursor.sync.scales,At=x.cursor.drag;if(Nn=At._x,Un=At._y,Nn||Un){let{left:Mt,top:_t,width:Qe,height:qe}=x.select,$t=x.scales[Be].ori,sn=x.posToVal,Fn,Bt,rn,vi,ii,Li=fe!=null&&Ue(fe,Be),Hi=Me!=null&&Oe(Me,lt);Li&&Nn?($t==0?(Fn=Mt,Bt=Qe):(Fn=_t,Bt=qe),rn=M[fe],vi=O(sn(Fn,Be),rn,K,0),ii=O(sn(Fn+Bt,Be),rn,K,0),pa($i(vi,ii),Rn(ii-vi))):pa(0,K),Hi&&Un?($t==1?(Fn=Mt,Bt=Qe):(Fn=_t,Bt=qe),rn=M[Me],vi=I(sn(Fn,lt),rn,ae,0),ii=I(sn(Fn+Bt,lt),rn,ae,0),ma($i(vi,ii),Rn(ii-vi))):ma(0,ae)}else jh()}else{let fe=Rn(Hp-zp),Me=Rn(Gp-Vp);if(D.ori==1){let lt=fe;fe=Me,Me=lt}Nn=Wn.x&&fe>=Wn.dist,Un=Wn.y&&Me>=Wn.dist;let Ue=Wn.uni;Ue!=null?Nn&&Un&&(Nn=fe>=Ue,Un=Me>=Ue,!Nn&&!Un&&(Me>fe?Un=!0:Nn=!0)):Wn.x&&Wn.y&&(Nn||Un)&&(Nn=Un=!0);let Oe,Be;Nn&&(D.ori==0?(Oe=ro,Be=Xt):(Oe=oo,Be=Kt),pa($i(Oe,Be),Rn(Be-Oe)),Un||ma(0,ae)),Un&&(D.ori==1?(Oe=ro,Be=Xt):(Oe=oo,Be=Kt),ma($i(Oe,Be),Rn(Be-Oe)),Nn||pa(0,K)),!Nn&&!Un&&(pa(0,0),ma(0,0))}if(Wn._x=Nn,Wn._y=Un,x==null){if(P){if(nm!=null){let[fe,Me]=mn.scales;mn.values[0]=fe!=null?as(D.ori==0?Xt:Kt,fe):null,mn.values[1]=Me!=null?as(D.ori==1?Xt:Kt,Me):null}_a(yd,i,Xt,Kt,B,Ie,N)}if(nt){let fe=P&&mn.setSeries,Me=ke.prox;Er==null?Ts<=Me&&os(Zs,lo,!0,fe):Ts>Me?os(null,lo,!0,fe):Zs!=Er&&os(Zs,lo,!0,fe)}}pe&&(de.idx=N,Jh()),w!==!1&&On("setCursor")}let Ks=null;Object.defineProperty(i,"rect",{get(){return Ks==null&&ga(!1),Ks}});function ga(x=!1){x?Ks=null:(Ks=p.getBoundingClientRect(),On("syncRect",Ks))}function qp(x,w,P,N,X,K,ae){he._lock||Ys&&x!=null&&x.movementX==0&&x.movementY==0||(Zh(x,w,P,N,X,K,ae,!1,x!=null),x!=null?Cr(null,!0,!0):Cr(w,!0,!1))}function Zh(x,w,P,N,X,K,ae,fe,Me){if(Ks==null&&ga(!1),tt(x),x!=null)P=x.clientX-Ks.left,N=x.clientY-Ks.top;else{if(P<0||N<0){Xt=-10,Kt=-10;return}let[Ue,Oe]=mn.scales,Be=w.cursor.sync,[lt,At]=Be.values,[Mt,_t]=Be.scales,[Qe,qe]=mn.match,$t=w.axes[0].side%2==1,sn=D.ori==0?B:Ie,Fn=D.ori==1?B:Ie,Bt=$t?K:X,rn=$t?X:K,vi=$t?N:P,ii=$t?P:N;if(Mt!=null?P=Qe(Ue,Mt)?a(lt,M[Ue],sn,0):-10:P=sn*(vi/Bt),_t!=null?N=qe(Oe,_t)?a(At,M[Oe],Fn,0):-10:N=Fn*(ii/rn),D.ori==1){let Li=P;P=N,N=Li}}Me&&(w==null||w.cursor.event.type==yd)&&((P<=1||P>=B-1)&&(P=Nr(P,B)),(N<=1||N>=Ie-1)&&(N=Nr(N,Ie))),fe?(zp=P,Vp=N,[ro,oo]=he.move(i,P,N)):(Xt=P,Kt=N)}let Kh={width:0,height:0,left:0,top:0};function jh(){Nl(Kh,!1)}let $p,Yp,Jp,Zp;function Kp(x,w,P,N,X,K,ae){Ys=!0,Nn=Un=Wn._x=Wn._y=!1,Zh(x,w,P,N,X,K,ae,!0,!1),x!=null&&(bt(vd,Ad,jp,!1),_a(Wm,i,ro,oo,B,Ie,null));let{left:fe,top:Me,width:Ue,height:Oe}=qt;$p=fe,Yp=Me,Jp=Ue,Zp=Oe}function jp(x,w,P,N,X,K,ae){Ys=Wn._x=Wn._y=!1,Zh(x,w,P,N,X,K,ae,!1,!0);let{left:fe,top:Me,width:Ue,height:Oe}=qt,Be=Ue>0||Oe>0,lt=$p!=fe||Yp!=Me||Jp!=Ue||Zp!=Oe;if(Be&&lt&&Nl(qt),Wn.setScale&&Be&&lt){let At=fe,Mt=Ue,_t=Me,Qe=Oe;if(D.ori==1&&(At=Me,Mt=Oe,_t=fe,Qe=Ue),Nn&&Js(C,as(At,C),as(At+Mt,C)),Un)for(let qe in M){let $t=M[qe];qe!=C&&$t.from==null&&$t.min!=Vt&&Js(qe,as(_t+Qe,qe),as(_t,qe))}jh()}else he.lock&&(he._lock=!he._lock,Cr(w,!0,x!=null));x!=null&&(Sn(vd,Ad),_a(vd,i,Xt,Kt,B,Ie,null))}function Oy(x,w,P,N,X,K,ae){if(he._lock)return;tt(x);let fe=Ys;if(Ys){let Me=!0,Ue=!0,Oe=10,Be,lt;D.ori==0?(Be=Nn,lt=Un):(Be=Un,lt=Nn),Be&&lt&&(Me=Xt<=Oe||Xt>=B-Oe,Ue=Kt<=Oe||Kt>=Ie-Oe),Be&&Me&&(Xt=Xt<ro?0:B),lt&&Ue&&(Kt=Kt<oo?0:Ie),Cr(null,!0,!0),Ys=!1}Xt=-10,Kt=-10,ie.fill(null),Cr(null,!0,!0),fe&&(Ys=fe)}function Qp(x,w,P,N,X,K,ae){he._lock||(tt(x),fa(),jh(),x!=null&&_a($m,i,Xt,Kt,B,Ie,null))}function em(){E.forEach(Zb),F(i.width,i.height,!0)}Fr(sc,fo,em);let co={};co.mousedown=Kp,co.mousemove=qp,co.mouseup=jp,co.dblclick=Qp,co.setSeries=(x,w,P,N)=>{let X=mn.match[2];P=X(i,w,P),P!=-1&&os(P,N,!0,!1)},ge&&(bt(Wm,p,Kp),bt(yd,p,qp),bt(Xm,p,x=>{tt(x),ga(!1)}),bt(qm,p,Oy),bt($m,p,Qp),Dd.add(i),i.syncRect=ga);let Ul=i.hooks=n.hooks||{};function On(x,w,P){ni?Dt.push([x,w,P]):x in Ul&&Ul[x].forEach(N=>{N.call(null,i,w,P)})}(n.plugins||[]).forEach(x=>{for(let w in x.hooks)Ul[w]=(Ul[w]||[]).concat(x.hooks[w])});let tm=(x,w,P)=>P,mn=xn({key:null,setSeries:!1,filters:{pub:sg,sub:sg},scales:[C,v[1]?v[1].scale:null],match:[rg,rg,tm],values:[null,null]},he.sync);mn.match.length==2&&mn.match.push(tm),he.sync=mn;let nm=mn.key,Qh=t0(nm);function _a(x,w,P,N,X,K,ae){mn.filters.pub(x,w,P,N,X,K,ae)&&Qh.pub(x,w,P,N,X,K,ae)}Qh.sub(i);function Fy(x,w,P,N,X,K,ae){mn.filters.sub(x,w,P,N,X,K,ae)&&co[x](null,w,P,N,X,K,ae)}i.pub=Fy;function By(){Qh.unsub(i),Dd.delete(i),Dn.clear(),Cd(sc,fo,em),c.remove(),Re?.remove(),On("destroy")}i.destroy=By;function ed(){On("init",n,e),da(e||n.data,!1),W[C]?qh(C,W[C]):fa(),se=qt.show&&(qt.width>0||qt.height>0),te=pe=!0,F(n.width,n.height)}return v.forEach(Qr),E.forEach(Ss),t?t instanceof HTMLElement?(t.appendChild(c),ed()):t(i,ed):ed(),i}Xn.assign=xn;Xn.fmtNum=zd;Xn.rangeNum=rc;Xn.rangeLog=lc;Xn.rangeAsinh=Bd;Xn.orient=kr;Xn.pxRatio=Tt;Xn.join=Vv;Xn.fmtDate=Hd,Xn.tzDate=jv;Xn.sync=t0;{Xn.addGap=Nb,Xn.clipGaps=hc;let n=Xn.paths={points:a0};n.linear=c0,n.stepped=Fb,n.bars=Bb,n.spline=zb}function Ls(n,e,t=()=>!0){let[i,s]=et({value:void 0,error:"",path:n});return Ye(()=>{if(n===null)return;let r=new AbortController,o=0,a=async()=>{let l=!0;try{let c=await Es(n,r.signal);l=t(c),s({value:c,error:"",path:n})}catch(c){if(hs(c))return;s(u=>({...u,error:Tn(c),path:n}))}l&&!r.signal.aborted&&(o=window.setTimeout(a,1e3*e))};return a(),()=>{r.abort(),clearTimeout(o)}},[n]),i.path===n?i:{value:void 0,error:""}}function bo(){let[n,e]=et(0);return Ye(()=>jl(()=>e(t=>t+1)),[]),n}function rr(n){Ye(()=>{n!==null&&(document.title=n===""?"cdcluster":`${n} - cdcluster`)},[n])}var Kb=Symbol.for("pv"),jb=0;function y(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Kb,__v:--jb,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Nt.vnode&&Nt.vnode(c),c}var f0=160;function Qb(n,e,t){let i={stroke:Wi("--muted"),grid:{stroke:Wi("--line"),width:1},ticks:{stroke:Wi("--line"),width:1,size:4},font:"11px system-ui, sans-serif"};return{width:e,height:f0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},hooks:{setCursor:[s=>t(s.cursor.idx??null)]},scales:{y:{range:(s,r,o)=>[0,Math.max(1.1*o,4)]}},axes:[{...i,size:28,space:70,values:"{HH}:{mm}:{ss}"},{...i,size:64,values:(s,r)=>r.map(o=>n.format(o))}],series:[{},...n.lines.map(s=>({stroke:Wi(s.colour),width:1.5,...s.dash?{dash:s.dash}:{},points:{show:!1}}))]}}function Jd(n){let e=on(null),t=on(null),[i,s]=et(null),r=bo(),o=[n.times,...n.lines.map(u=>u.values)];Ye(()=>{let u=e.current;if(!u)return;let f=new Xn(Qb(n,u.clientWidth||300,s),o,u);t.current=f;let h=new ResizeObserver(()=>f.setSize({width:u.clientWidth||300,height:f0}));return h.observe(u),()=>{h.disconnect(),f.destroy(),t.current=null}},[r]),Ye(()=>t.current?.setData(o),[n.times,r]);let a=i!==null&&i<n.times.length?i:n.times.length-1,l=u=>n.format(u.values[a]??0),c=n.lines.map(u=>`${u.title} ${l(u)}`).join(", ");return y("figure",{class:"chart",children:[y("div",{ref:e,role:"img","aria-label":`${n.title}: ${c}`}),y("figcaption",{children:[n.lines.map(u=>y("span",{children:[y("svg",{viewBox:"0 0 18 4","aria-hidden":"true",children:y("line",{x1:0,x2:18,y1:2,y2:2,stroke:`var(${u.colour})`,"stroke-width":2,"stroke-dasharray":u.dash?.join(" ")??"none"})}),u.title," ",y("b",{children:l(u)})]},u.title)),y("span",{class:"note",children:i===null?"now":new Date(1e3*n.times[a]).toLocaleTimeString("en-GB")})]})]})}var mc=["separate","touch","cross","inside","contact","undecided","failed"];var eS=[1,2,7,6,5,3,4];function Pa(n){return n===255?0:eS[n]}function gc(n){return n>=1&&n<=4}function Ds(n){return n===255?"not tested yet":mc[n]}function _c(n){let e=mc.indexOf(n);return e<0?255:e}function p0(n){return n===255?"-":"STXICUF"[n]}var tS=[[92,168,128],[232,188,38],[206,58,50],[146,36,92],[216,104,48],[132,112,186],[60,64,70]],nS=[150,155,160];function fs(n){return n===255?nS:tS[n]}function zr(n){let[e,t,i]=fs(n);return`rgb(${e} ${t} ${i})`}function m0(n){return n===255?.12:[.3,.6,1,.9,.8,.5,.7][n]}function Ot({text:n}){return y("bdi",{class:"name",title:n.slice(0,2e3),children:n===""?"(no name)":n.length>400?`${n.slice(0,400)}…`:n})}function Vr({kind:n}){return y("span",{class:`mark mark-${Ds(n).split(" ")[0]}`,style:{background:zr(n)},"aria-hidden":"true",children:p0(n)})}function g0(n){return n.count===0&&!n.always?null:y("span",{class:`count ${n.count===0?"zero":""}`,children:[y(Vr,{kind:n.kind}),Ds(n.kind)," ",y("b",{children:Ge(n.count)})]})}function kt(n){return y("div",{class:`notice ${n.kind}`,role:n.kind==="bad"?"alert":"status",children:n.children})}function fi(n){return y("section",{class:`panel ${n.wide?"wide":""}`,"aria-label":n.title,children:[y("header",{children:[y("h2",{children:n.title}),n.note&&y("span",{class:"note",children:n.note})]}),n.children]})}function xc({done:n,total:e}){let t=e===0?0:n/e;return y("span",{class:"progress",children:[y("progress",{max:1,value:t,"aria-label":`${Ge(n)} of ${Ge(e)}`}),y("span",{children:En(t)})]})}function yc({text:n}){let[e,t]=et("");return y("button",{type:"button",class:"command",title:"copy",onClick:()=>Zd(n,t),children:[y("code",{children:n}),y("span",{"aria-live":"polite",children:e||"copy"})]})}function Zd(n,e){let t=s=>{e(s),setTimeout(()=>e(""),2e3)};(navigator.clipboard?.writeText(n)??Promise.reject(new Error)).then(()=>t("copied"),()=>t("the browser did not allow it"))}function iS(n,e){return typeof n=="number"&&typeof e=="number"?n-e:String(n).localeCompare(String(e),"en",{numeric:!0})}function or(n){let[e,t]=et(null),i=n.columns.find(a=>a.key===e?.key),s=[...n.rows];i&&e?s.sort((a,l)=>(e.down?-1:1)*iS(i.value(a),i.value(l))):n.order&&s.sort(n.order);let r=a=>{let l=a.isNumber===!0;e?.key!==a.key?t({key:a.key,down:l}):t(e.down===l?{key:a.key,down:!l}:null)},o=a=>e?.key!==a.key?"none":e.down?"descending":"ascending";return y("div",{class:"table",tabIndex:0,role:"region","aria-label":n.caption,children:y("table",{children:[y("caption",{children:n.caption}),y("thead",{children:y("tr",{children:n.columns.map(a=>y("th",{scope:"col",class:a.isNumber?"number":"","aria-sort":o(a),children:y("button",{type:"button",onClick:()=>r(a),children:a.title})},a.key))})}),y("tbody",{children:[s.length===0&&y("tr",{children:y("td",{class:"empty",colSpan:n.columns.length,children:n.empty})}),s.map(a=>y("tr",{class:n.rowClass?.(a)??"",children:n.columns.map(l=>y("td",{class:l.isNumber?"number":"",children:l.cell(a)},l.key))},n.rowKey(a)))]})]})})}function _0(n){let e=n.scenarios_per_second??0;return n.state==="running"&&e>0?(n.scenarios-n.done)/e:NaN}var sS=[{key:"job",title:"job",cell:n=>y("a",{href:er(n.job),children:n.job}),value:n=>n.job},{key:"name",title:"name",cell:n=>y(Ot,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>y("span",{class:`state ${n.state==="failed"?"bad":n.state==="paused"?"warn":""}`,children:n.state}),value:n=>n.state},{key:"owner",title:"owner",cell:n=>y(Ot,{text:n.owner||"-"}),value:n=>n.owner??""},{key:"began",title:"began",cell:n=>(n.began??"").replace("T"," ").replace(/Z$/," UTC"),value:n=>n.began??""},{key:"scenarios",title:"scenarios",cell:n=>Ge(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"done",title:"done",cell:n=>y(xc,{done:n.done,total:n.scenarios}),value:n=>n.done/Math.max(1,n.scenarios),isNumber:!0},{key:"contact",title:"in contact",cell:n=>n.done===0?"-":En(n.contact/n.done),value:n=>n.contact/Math.max(1,n.done),isNumber:!0},{key:"failed",title:"failed",cell:n=>y("span",{class:n.failed>0?"state bad":"",children:Ge(n.failed)}),value:n=>n.failed,isNumber:!0},{key:"rate",title:"rate",cell:n=>tr(n.scenarios_per_second??0),value:n=>n.scenarios_per_second??0,isNumber:!0},{key:"eta",title:"ends in",cell:n=>Dr(_0(n)),value:n=>_0(n)||0,isNumber:!0}];function Kd(n){return y(or,{caption:"jobs",columns:sS,rows:n.jobs,rowKey:e=>e.job,...n.order?{order:n.order}:{},empty:"no job yet: cdctl run job.toml --master HOST:7600"})}function x0(){let{value:n,error:e}=Ls("jobs",2);return rr("jobs"),Ye(()=>Ui("jobs",()=>({ready:n!==void 0,jobs:n?.jobs.map(t=>t.job)})),[n]),Ye(()=>{n?.jobs.length===1&&n.jobs[0].job==="folder"&&Cs(er("folder"))},[n]),n?y(Ut,{children:[e&&y(kt,{kind:"bad",children:[e,"; below is what it said last"]}),y(Kd,{jobs:n.jobs})]}):e?y(kt,{kind:"bad",children:e}):y("p",{class:"wait",children:"asking for the jobs…"})}function vc(n){let e=["lost","silent","quarantined","draining"],t=e.indexOf(n.split(" ")[0]);return t<0?e.length:t}var y0=["bad","bad","warn","warn",""],rS=[{key:"worker",title:"worker",cell:n=>n.worker,value:n=>n.worker},{key:"name",title:"name",cell:n=>y(Ot,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>y("span",{class:`state ${y0[vc(n.state)]}`,children:n.state}),value:n=>n.state},{key:"threads",title:"threads",cell:n=>Ge(n.threads),value:n=>n.threads,isNumber:!0},{key:"working",title:"working",cell:n=>Ge(n.working),value:n=>n.working,isNumber:!0},{key:"done",title:"done",cell:n=>Ge(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"rate",title:"rate",cell:n=>tr(n.scenarios_per_second),value:n=>n.scenarios_per_second,isNumber:!0},{key:"cache",title:"cache",cell:n=>n.cache_bytes?zm(n.cached_bytes,n.cache_bytes):Rs(n.cached_bytes),value:n=>n.cached_bytes,isNumber:!0},{key:"hits",title:"hits",cell:n=>En(n.cache_hit_share),value:n=>n.cache_hit_share,isNumber:!0},{key:"peers",title:"to peers",cell:n=>Rs(n.uploaded_bytes??0),value:n=>n.uploaded_bytes??0,isNumber:!0},{key:"longest",title:"longest",cell:n=>n.longest?y("a",{href:_n(n.longest.job,n.longest.scenario),children:["#",n.longest.scenario," ",Dr(n.longest.seconds)]}):"-",value:n=>n.longest?.seconds??0,isNumber:!0}];function oS({history:n}){let e=i=>{let s=n.columns.indexOf(i);return n.rows.map(r=>r[s]??0)},t=e("time");return y("div",{class:"two",children:[y(fi,{title:"throughput",note:"scenarios a second, ten minutes",children:y(Jd,{title:"throughput",times:t,format:tr,lines:[{title:"scenarios",colour:"--accent",values:e("scenarios_per_second")}]})}),y(fi,{title:"wire",note:"bytes a second, seen from the master",children:y(Jd,{title:"wire",times:t,format:km,lines:[{title:"out",colour:"--accent",values:e("sent_per_second")},{title:"in",colour:"--second",values:e("received_per_second"),dash:[6,3]},{title:"peer to peer",colour:"--third",values:e("peer_per_second"),dash:[2,3]}]})})]})}function aS({cluster:n}){let e=n.workers.filter(r=>!r.state.startsWith("lost")),t=e.reduce((r,o)=>r+o.threads,0),i=e.reduce((r,o)=>r+o.scenarios_per_second,0),s=n.jobs.filter(r=>r.state==="running").length;return y("dl",{class:"numbers",children:[y("div",{children:[y("dt",{children:"scenarios"}),y("dd",{children:tr(i)})]}),y("div",{children:[y("dt",{children:e.length===1?"worker":"workers"}),y("dd",{children:Ge(e.length)})]}),y("div",{children:[y("dt",{children:"threads"}),y("dd",{children:Ge(t)})]}),y("div",{children:[y("dt",{children:s===1?"job runs":"jobs run"}),y("dd",{children:Ge(s)})]}),y("div",{children:[y("dt",{children:"up"}),y("dd",{children:Dr(n.uptime_seconds)})]}),y("div",{children:[y("dt",{children:"free on the disk"}),y("dd",{children:Rs(n.state_bytes?.free??0)})]})]})}function v0(){let{value:n,error:e}=Ls("cluster",1),{value:t}=Ls("history",2);if(rr("cluster"),Ye(()=>Ui("cluster",()=>({ready:n!==void 0,workers:n?.workers.map(r=>({name:r.name,state:r.state})),jobs:n?.jobs.map(r=>({job:r.job,done:r.done,state:r.state}))})),[n]),!n)return e?y(kt,{kind:"bad",children:e}):y("p",{class:"wait",children:"asking the master…"});let i=(r,o)=>vc(r.state)-vc(o.state),s=(r,o)=>+(o.state==="running")-+(r.state==="running");return y(Ut,{children:[e&&y(kt,{kind:"bad",children:[e,"; below is what it said last"]}),n.paused&&y(kt,{kind:"bad",children:["jobs are paused: ",n.paused]}),n.alarms.map((r,o)=>y(kt,{kind:"warn",children:[y("b",{children:"alarm"})," ",y(Ot,{text:r})]},o)),y(aS,{cluster:n}),y("p",{class:"line",children:[y("b",{children:"bottleneck"})," ",n.bottleneck,n.workers_lost>0&&y(Ut,{children:[" · ",jt(n.workers_lost,"worker")," lost so far"]}),n.alarms.length===0&&y(Ut,{children:" · no alarms"})]}),t&&y(oS,{history:t}),y(or,{caption:"workers",columns:rS,rows:n.workers,rowKey:r=>r.worker,order:i,rowClass:r=>y0[vc(r.state)],empty:"no worker is connected: start cdworker --master HOST:7600"}),y(Kd,{jobs:n.jobs,order:s})]})}var jd=1e3;function lS(n){let e=[],t=null;return n.classes.forEach((i,s)=>{gc(i)?t?(t.last=n.first+s,t.worst=n.isWorse(s,t.worst)?s:t.worst):(t={first:n.first+s,last:n.first+s,worst:s},e.push(t)):t=null}),e}function b0({job:n,results:e}){if(n.poses.kind!=="file"||!e.isExact)return null;let t=lS(e),i=s=>y("a",{href:_n(n.job,s),children:["#",Ge(s)]});return y(fi,{title:"episodes",note:`${jt(t.length,"run")} of consecutive scenarios in contact${t.length>jd?`; the first ${Ge(jd)} are listed`:""}`,children:y(or,{caption:"episodes",rows:t.slice(0,jd),rowKey:s=>String(s.first),empty:"no scenario is in contact",columns:[{key:"first",title:"first",cell:s=>i(s.first),value:s=>s.first,isNumber:!0},{key:"last",title:"last",cell:s=>i(s.last),value:s=>s.last,isNumber:!0},{key:"length",title:"scenarios",cell:s=>Ge(s.last-s.first+1),value:s=>s.last-s.first,isNumber:!0},{key:"worst",title:"worst",cell:s=>y(Ut,{children:[y(Vr,{kind:e.classes[s.worst]})," ",i(e.scenarioAt(s.worst))]}),value:s=>e.countAt(s.worst),isNumber:!0},{key:"pairs",title:"pairs there",cell:s=>e.counts?Ge(e.countAt(s.worst)):"-",value:s=>e.countAt(s.worst),isNumber:!0}]})})}function cS(n,e){let i=n/e,s=i+1.959964*1.959964/(2*e),r=1.959964*Math.sqrt(i*(1-i)/e+1.959964*1.959964/(4*e*e)),o=1+1.959964*1.959964/e;return[Math.max(0,(s-r)/o),Math.min(1,(s+r)/o)]}function uS({group:n,job:e}){let t=e.poses.kind==="random"&&!e.poses.penetration&&e.done>0,[i,s]=t?cS(n.scenarios,e.done):[0,0];return y("span",{class:"share",children:[y("meter",{min:0,max:1,value:n.share}),y("span",{children:[En(n.share),t&&y("small",{children:[" ",`${En(i)} to ${En(s)}`]})]})]})}function hS(n){return[{key:"a",title:"part of A",cell:e=>y(Ot,{text:e.a}),value:e=>e.a},{key:"b",title:"part of B",cell:e=>y(Ot,{text:e.b}),value:e=>e.b},{key:"scenarios",title:"in poses",cell:e=>Ge(e.scenarios),value:e=>e.scenarios,isNumber:!0},{key:"share",title:"share",cell:e=>y(uS,{group:e,job:n}),value:e=>e.share,isNumber:!0},{key:"worst",title:"worst",cell:e=>y("a",{href:_n(n.job,e.worst,{part:`a/${e.a}`,with:`b/${e.b}`}),children:[y(Vr,{kind:_c(e.class)})," #",Ge(e.worst)]}),value:e=>e.worst_pairs,isNumber:!0}]}function S0({job:n,groups:e}){let t=n.groups_total??e.length,i=t>e.length;return y(fi,{title:"parts in contact",note:i?`the ${Ge(e.length)} in most poses, of ${Ge(t)}`:"",children:y(or,{caption:"parts in contact",columns:hS(n),rows:e,rowKey:s=>`${s.a}
${s.b}`,empty:"no part is in contact"})})}function dS(n){let e=[];for(let t of n){if(t===0)continue;let i=31-Math.clz32(t);for(;e.length<=i;){let s=2**e.length;e.push({first:s,last:2*s-1,count:0})}e[i].count+=1}return e}function Qd({results:n}){let e=n.counts?dS(n.counts):[];if(e.length===0)return null;let[t,i,s]=[480,150,18],r=Math.log1p(Math.max(...e.map(a=>a.count))),o=t/e.length;return y(fi,{title:"pairs a scenario",note:`scenarios in contact, both axes logarithmic${n.isExact?"":", of the sample"}`,children:y("svg",{class:"histogram",viewBox:`0 0 ${t} ${i+s}`,role:"img","aria-label":"histogram of pairs a scenario",children:[e.map((a,l)=>{let c=Math.log1p(a.count)/r*(i-14);return y("g",{children:[y("title",{children:`${Ge(a.first)} to ${Ge(a.last)} pairs: ${jt(a.count,"scenario")}`}),y("rect",{class:"hit",x:l*o,y:0,width:o,height:i}),y("rect",{class:"bar",x:l*o+1,y:i-c,width:o-2,height:c}),a.count>0&&y("text",{x:(l+.5)*o,y:i-c-3,children:_d(a.count)}),(l%2===0||e.length<12)&&y("text",{x:(l+.5)*o,y:i+13,children:_d(a.first)})]},a.first)}),y("line",{x1:0,x2:t,y1:i,y2:i})]})})}function So(n,[e,t,i]){return[n[0]*e+n[1]*t+n[2]*i+n[3],n[4]*e+n[5]*t+n[6]*i+n[7],n[8]*e+n[9]*t+n[10]*i+n[11]]}function Mo(n){let e=[n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]],t=i=>-(e[i]*n[3]+e[i+1]*n[7]+e[i+2]*n[11]);return[e[0],e[1],e[2],t(0),e[3],e[4],e[5],t(3),e[6],e[7],e[8],t(6)]}function bc(n,e){let t=[];for(let i=0;i<12;i+=4)for(let s=0;s<4;++s)t.push(n[i]*e[s]+n[i+1]*e[s+4]+n[i+2]*e[s+8]+(s===3?n[i+3]:0));return t}var Yi=["x","y","z","roll","pitch","yaw","distance"];function Ia(n,e=0){let t=180/Math.PI,[i,s,r]=[n[e+3],n[e+7],n[e+11]];return{x:i,y:s,z:r,roll:Math.atan2(n[e+9],n[e+10])*t,pitch:Math.asin(Math.max(-1,Math.min(1,-n[e+8])))*t,yaw:Math.atan2(n[e+4],n[e])*t,distance:Math.hypot(i,s,r)}}function ar(n){return n==="roll"||n==="pitch"||n==="yaw"}var fS=10;function pS(n,e,t,i,s){n.beginPath(),e===1?n.arc(t,i,s*.55,0,2*Math.PI):e===2||e===4?(n.moveTo(t-s,i-s),n.lineTo(t+s,i+s),e===2&&(n.moveTo(t+s,i-s),n.lineTo(t-s,i+s))):e===3?n.rect(t-s,i-s,2*s,2*s):e>=5&&e!==255&&(n.moveTo(t-s,i),n.lineTo(t+s,i)),n.stroke()}var wo=class{constructor(e,t,i,s,r,o,a){this.results=e;this.x=t;this.y=i;this.columns=s;this.rows=r;this.showsShares=o;this.describe=a;let l=s*r;this.worst=new Int32Array(l).fill(-1),this.number=new Uint32Array(l),this.tested=new Uint32Array(l),this.contacts=new Uint32Array(l)}results;x;y;columns;rows;showsShares;describe;worst;number;tested;contacts;add(e,t,i){let s=t*this.columns+e,r=this.results.classes[i];this.number[s]+=1,this.tested[s]+=r===255?0:1,this.contacts[s]+=gc(r)?1:0,(this.worst[s]<0||this.results.isWorse(i,this.worst[s]))&&(this.worst[s]=i)}colour(e){let t=this.results.classes[this.worst[e]];if(!this.showsShares||this.tested[e]===0)return fs(t);let i=this.contacts[e]/this.tested[e],[s,r]=[fs(0),fs(2)];return[0,1,2].map(o=>s[o]+(r[o]-s[o])*i)}draw(e,t,i){let s=new ImageData(this.columns,this.rows);for(let o=0;o<this.worst.length;++o){if(this.worst[o]<0)continue;let l=4*((this.rows-1-Math.floor(o/this.columns))*this.columns+o%this.columns);s.data.set([...this.colour(o),255],l)}let r=new OffscreenCanvas(this.columns,this.rows);r.getContext("2d")?.putImageData(s,0,0),e.imageSmoothingEnabled=!1,e.drawImage(r,0,0,t,i),this.drawGlyphs(e,t/this.columns,i/this.rows)}drawGlyphs(e,t,i){let s=Math.min(t,i);if(!(s<fS||this.showsShares)){e.strokeStyle="rgb(0 0 0 / 0.3)",e.lineWidth=Math.max(1,s/14);for(let r=0;r<this.worst.length;++r)if(this.worst[r]>=0){let o=(r%this.columns+.5)*t,a=(this.rows-.5-Math.floor(r/this.columns))*i;pS(e,this.results.classes[this.worst[r]],o,a,s*.2)}}}spot(e,t){let i=t*this.columns+e;return e<0||t<0||e>=this.columns||t>=this.rows||this.worst[i]<0?null:{scenario:this.results.scenarioAt(this.worst[i]),text:this.text(i),x:e/this.columns,y:t/this.rows,width:1/this.columns,height:1/this.rows}}text(e){let t=this.worst[e],i=this.results.scenarioAt(t),s=this.results.countAt(t),r=s>0?`, ${Ge(s)} pairs`:"",o=`#${i} ${Ds(this.results.classes[t])}${r}${this.describe(i)}`;if(this.number[e]===1)return o;let a=En(this.contacts[e]/Math.max(1,this.tested[e]));return`${Ge(this.number[e])} scenarios, ${a} in contact; the worst is ${o}`}at(e,t){return this.spot(Math.floor(e*this.columns),Math.floor(t*this.rows))}step(e,t,i){let s=e?Math.round(e.x*this.columns):Math.floor(this.columns/2)-t,r=e?Math.round(e.y*this.rows):Math.floor(this.rows/2)-i;for(;;){if(s+=t,r+=i,s<0||r<0||s>=this.columns||r>=this.rows)return e;let o=this.spot(s,r);if(o)return o}}};function To(n,e){return`${Zn(e)}${n.unit}`}var mS=512,gS=40,ef=class{constructor(e,t){this.axes=e;this.unit=t;this.strides=e.map((i,s)=>e.slice(s+1).reduce((r,o)=>r*o.count,1))}axes;unit;strides;varying(){return this.axes.flatMap((e,t)=>e.count>1?[t]:[])}value(e,t){let{first:i,last:s,count:r}=this.axes[e];return t===0?i:t===r-1?s:i+(s-i)*t/(r-1)}numberOf(e,t){return Math.floor(t/this.strides[e])%this.axes[e].count}unitOf(e){return ar(this.axes[e].name)?"°":` ${this.unit}`}plotAxis(e){let{name:t,first:i,last:s}=this.axes[e];return{title:t,first:i,last:s,unit:this.unitOf(e)}}valueText(e,t){return`${this.axes[e].name} ${Zn(this.value(e,t))}${this.unitOf(e)}`}describe(e){let t=this.varying().map(i=>this.valueText(i,this.numberOf(i,e)));return t.length===0?"":` at ${t.join(", ")}`}};function M0(n,e,t,i,s){let r=e.isExact?mS:gS,o=Math.min(r,n.axes[t].count),a=Math.min(r,n.axes[i].count),l=new wo(e,n.plotAxis(t),n.plotAxis(i),o,a,!1,h=>n.describe(h)),c=h=>Math.floor(h*o/n.axes[t].count),u=h=>Math.floor(h*a/n.axes[i].count);if(!e.isExact){for(let h=0;h<e.classes.length;++h){let d=e.scenarioAt(h);l.add(c(n.numberOf(t,d)),u(n.numberOf(i,d)),h)}return l}let f=s.reduce((h,d,p)=>h+(p===t||p===i?0:d*n.strides[p]),0);for(let h=0;h<n.axes[t].count;++h)for(let d=0;d<(t===i?1:n.axes[i].count);++d){let p=f+h*n.strides[t]+(t===i?0:d*n.strides[i]);l.add(c(h),t===i?0:u(d),p-e.first)}return l}function w0(n){return n.poses.kind==="grid"&&n.poses.axes?new ef(n.poses.axes,n.unit):null}var _S={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function xS(n,e,t,i){let[s,r]=[e.x*t,(1-e.y-e.height)*i];n.lineWidth=2*devicePixelRatio,n.strokeStyle=Wi("--ink"),n.beginPath(),e.width>0?n.rect(s-1,r-1,Math.max(4,e.width*t)+2,Math.max(4,e.height*i)+2):n.arc(s,r,6*devicePixelRatio,0,2*Math.PI),n.stroke()}function tf(n){let{model:e}=n,t=on(null),i=on(null),[s,r]=et(null),[o,a]=et([0,0]),l=bo();Ye(()=>{let h=t.current;if(!h)return;let d=new ResizeObserver(()=>a([Math.round(h.clientWidth*devicePixelRatio),Math.round(h.clientHeight*devicePixelRatio)]));return d.observe(h),()=>d.disconnect()},[]),Ye(()=>r(null),[e.x.title,e.y.title]),Ye(()=>{let[h,d]=o;if(h>0&&d>0){i.current=new OffscreenCanvas(h,d);let p=i.current.getContext("2d");p&&e.draw(p,h,d)}},[e,o,l]),Ye(()=>{let h=t.current?.getContext("2d"),[d,p]=o;!t.current||!h||!i.current||(t.current.width=d,t.current.height=p,h.drawImage(i.current,0,0),s&&xS(h,s,d,p))},[e,s,o,l]);let c=h=>{let d=h.currentTarget.getBoundingClientRect(),p=(h.clientX-d.left)/d.width,b=1-(h.clientY-d.top)/d.height;return e.at(p,b,d.width,d.height)},u=h=>{let d=_S[h.key];d?(r(e.step(s,...d)),h.preventDefault()):h.key==="Enter"&&s&&n.open(s.scenario)},f=h=>To(h,(h.first+h.last)/2);return y("div",{class:"plot",children:[y("div",{class:"y-axis","aria-hidden":"true",children:[y("span",{children:To(e.y,e.y.last)}),y("b",{children:e.y.title}),y("span",{children:To(e.y,e.y.first)})]}),y("canvas",{ref:t,tabIndex:0,role:"application","aria-label":`${e.x.title} against ${e.y.title}: arrows move, Enter opens. ${s?.text??""}`,onPointerMove:h=>r(c(h)),onPointerLeave:()=>r(null),onClick:h=>{let d=c(h);d&&n.open(d.scenario)},onKeyDown:u}),y("div",{class:"x-axis","aria-hidden":"true",children:[y("span",{children:To(e.x,e.x.first)}),y("span",{children:[y("b",{children:e.x.title})," ",f(e.x)]}),y("span",{children:To(e.x,e.x.last)})]}),y("p",{class:"readout","aria-live":"polite",children:s?s.text:"point at a place to read it; a click opens its worst scenario"})]})}var T0=4096,E0=1<<24,yS=1<<22,vS=1<<18,Sc=65536,Mc=class{constructor(e,t,i,s){this.first=e;this.end=t;this.classes=i;this.counts=s}first;end;classes;counts;get isExact(){return this.classes.length===this.end-this.first}scenarioAt(e){return this.isExact?this.first+e:this.first+Math.floor(e*(this.end-this.first)/this.classes.length)}classOf(e){return this.isExact?this.classes[e-this.first]:void 0}isWorse(e,t){let i=Pa(this.classes[e])-Pa(this.classes[t]);return i>0||i===0&&this.countAt(e)>this.countAt(t)}worst(){let e=0;for(let t=1;t<this.classes.length;++t)e=this.isWorse(t,e)?t:e;return this.classes.length===0?0:this.scenarioAt(e)}countAt(e){return this.counts?.[e]??0}};function bS(n){return n.kind==="folder"?1<<20:Sc}function nf(n,e){return n.kind==="folder"?e:Sc}async function A0(n,e,t,i,s){for(let r=0;r<t.length;r+=i){let o=Math.min(i,t.length-r),a=await Ni(`${n}?first=${e+r}&count=${o}`,s);t.set(a.values,r)}return t}function La(n,e){return`jobs/${encodeURIComponent(n.job)}/${e}`}async function wc(n,e,t,i,s){let r=i-t,o=bS(n);if(r>nf(n,E0)){let[u,f]=await Promise.all(["classes","counts"].map(h=>Ni(`${La(e,h)}?sample=${T0}`,s)));return new Mc(0,e.scenarios,u.values,f.values)}let a=await A0(La(e,"classes"),t,new Uint8Array(r).fill(255),o,s),c=e.level!=="any"&&r<=nf(n,yS)?await A0(La(e,"counts"),t,new Uint32Array(r),o,s):null;return new Mc(t,i,a,c)}function C0(n,e,t){return t-e<=nf(n,E0)}async function R0(n,e){let t=n.poses.of_both_bodies?24:12,i=n.scenarios;if(i>vS){let o=await Ni(`${La(n,"poses")}?sample=${T0}`,e),a=o.shape[0];return{scenarios:Float64Array.from({length:a},(c,u)=>Math.floor(u*i/a)),values:o.values,width:t,isSample:!0}}let s=new Float64Array(t*i);for(let o=0;o<i;o+=Sc){let a=Math.min(Sc,i-o),l=await Ni(`${La(n,"poses")}?first=${o}&count=${a}`,e);s.set(l.values,t*o)}return{scenarios:Float64Array.from({length:i},(o,a)=>a),values:s,width:t,isSample:!1}}var sf=5e4,Ac=128,P0=14;function L0(n){let e=n.scenarios.length,t=Object.fromEntries(Yi.map(i=>[i,new Float64Array(e)]));for(let i=0;i<e;++i){let s;if(n.width===24){let r=Array.from(n.values.subarray(24*i,24*i+12)),o=Array.from(n.values.subarray(24*i+12,24*i+24));s=Ia(bc(Mo(r),o))}else s=Ia(n.values,12*i);for(let r of Yi)t[r][i]=s[r]}return t}function D0(n){let e=s=>{let[r,o]=N0(n[s]);return(o-r)*(ar(s)?1e-6:1)},[t,i]=Yi.filter(s=>s!=="distance").sort((s,r)=>e(r)-e(s));return Yi.indexOf(t)<Yi.indexOf(i)?[t,i]:[i,t]}function N0(n){let[e,t]=[1/0,-1/0];for(let i of n)e=Math.min(e,i),t=Math.max(t,i);return e<t?[e,t]:[e-.5,e+.5]}function I0(n,e,t){let[i,s]=N0(e),r=.03*(s-i);return{title:n,first:i-r,last:s+r,unit:ar(n)?"°":` ${t}`}}var Tc=class{constructor(e,t,i,s,r,o){this.results=e;this.elements=t;this.px=i;this.py=s;this.x=r;this.y=o;this.order=Uint32Array.from(i,(a,l)=>l).sort((a,l)=>this.rank(a)-this.rank(l)||a-l)}results;elements;px;py;x;y;order;rank(e){return Pa(this.kind(e))}kind(e){return this.elements[e]<0?255:this.results.classes[this.elements[e]]}draw(e,t,i){let s=this.px.length,r=(s>2e4?1:s>2e3?1.6:2.6)*devicePixelRatio;for(let o of this.order){let a=this.kind(o),[l,c]=[this.px[o]*t,(1-this.py[o])*i],[u,f,h]=fs(a);e.fillStyle=`rgb(${u} ${f} ${h} / ${a===0?.6:.9})`,e.beginPath(),a===0||a===1?e.arc(l,c,r,0,2*Math.PI):a===2?e.rect(l-r,c-r,2*r,2*r):(e.moveTo(l,c-1.4*r),e.lineTo(l+1.4*r,c+r),e.lineTo(l-1.4*r,c+r)),e.fill()}}spot(e){let t=this.results.scenarioAt(Math.max(0,this.elements[e])),i=this.results.countAt(this.elements[e]),s=[this.x,this.y].map((o,a)=>{let l=a===0?this.px[e]:this.py[e];return`${o.title} ${Zn(o.first+l*(o.last-o.first))}${o.unit}`}),r=i>0?`, ${Ge(i)} pairs`:"";return{scenario:t,text:`#${t} ${Ds(this.kind(e))}${r} at ${s.join(", ")}`,x:this.px[e],y:this.py[e],width:0,height:0}}at(e,t,i,s){let r=-1,o=P0*P0;for(let a=0;a<this.px.length;++a){let l=(this.px[a]-e)*i,c=(this.py[a]-t)*s,u=l*l+c*c;(u<o||u===o&&r>=0&&this.rank(a)>this.rank(r))&&(o=u,r=a)}return r<0?null:this.spot(r)}step(e,t,i){let s=e??{x:.5,y:.5},r=-1,o=1/0;for(let a=0;a<this.px.length;++a){let[l,c]=[this.px[a]-s.x,this.py[a]-s.y],u=l*t+c*i,f=l*l+c*c;u>0&&2*u*u>=f&&f<o&&(o=f,r=a)}return r<0?e:this.spot(r)}};function U0(n,e,t,i,s,r){let[o,a]=[I0(i,t[i],r),I0(s,t[s],r)],l=(d,p)=>(p-d.first)/(d.last-d.first),c=t[i].map(d=>l(o,d)),u=t[s].map(d=>l(a,d)),f=Int32Array.from(e.scenarios,(d,p)=>n.isExact?d-n.first:p<n.classes.length&&e.isSample?p:-1);if(!n.isExact&&!e.isSample)for(let d=0;d<n.classes.length;++d)f[n.scenarioAt(d)]=d;if(c.length<=sf){let d=f.every(p=>p>=0)?null:[...f.keys()].filter(p=>f[p]>=0);return d?new Tc(n,Int32Array.from(d,p=>f[p]),Float64Array.from(d,p=>c[p]),Float64Array.from(d,p=>u[p]),o,a):new Tc(n,f,c,u,o,a)}let h=new wo(n,o,a,Ac,Ac,!0,()=>"");for(let d=0;d<c.length;++d)f[d]>=0&&h.add(Math.floor(c[d]*Ac),Math.floor(u[d]*Ac),f[d]);return h}function O0(n){Ye(()=>Ui("pose space",()=>{let e=n?.step(null,1,0)??null;return{poseSpace:e&&{...e,axes:[n?.x.title,n?.y.title]}}}),[n])}function Ec(n){return y("label",{children:[n.label," ",y("select",{value:n.value,onChange:e=>n.choose(e.currentTarget.value),children:n.all.map(e=>y("option",{value:e,children:e},e))})]})}function SS(n){let e=n.varying();return{x:e[0]??0,y:e[1]??e[0]??0,fixed:n.axes.map(()=>0)}}function MS({job:n,grid:e,results:t}){let[{x:i,y:s,fixed:r},o]=et(()=>SS(e)),a=An(()=>M0(e,t,i,s,r),[e,t,i,s,r]);O0(a);let l=e.varying(),c=l.map(h=>e.axes[h].name),u=(h,d)=>{let p=e.axes.findIndex(v=>v.name===d),[b,g]=h==="x"?[i,s]:[s,i],m=p===g?b:g;o({x:h==="x"?p:m,y:h==="x"?m:p,fixed:r})},f=l.filter(h=>h!==i&&h!==s);return y(fi,{title:"pose space",note:t.isExact?"":`a sample of ${Ge(t.classes.length)}, other axes folded`,children:[y("div",{class:"controls",children:[l.length>1&&y(Ut,{children:[y(Ec,{label:"across",value:e.axes[i].name,all:c,choose:h=>u("x",h)}),y(Ec,{label:"up",value:e.axes[s].name,all:c,choose:h=>u("y",h)})]}),t.isExact&&f.map(h=>y("label",{class:"slider",children:[y("input",{type:"range",min:0,max:e.axes[h].count-1,value:r[h],onInput:d=>{let p=Number(d.currentTarget.value);o({x:i,y:s,fixed:r.map((b,g)=>g===h?p:b)})}})," ",e.valueText(h,r[h])]},h))]}),y(tf,{model:a,open:h=>Cs(_n(n.job,h))})]})}function wS({job:n,results:e}){let[t,i]=et(null),[s,r]=et(""),[o,a]=et(null);Ye(()=>{let p=new AbortController;return R0(n,p.signal).then(i,b=>hs(b)||r(Tn(b))),()=>p.abort()},[n.job,n.scenarios]);let l=An(()=>t?L0(t):null,[t]),[c,u]=o??(l?D0(l):["x","y"]),f=An(()=>t&&l?U0(e,t,l,c,u,n.unit):null,[e,t,l,c,u]);O0(f);let h=t!==null&&t.scenarios.length>sf,d=[t?.isSample||!e.isExact?`a sample of ${Ge(Math.min(t?.scenarios.length??0,e.classes.length))}`:"",h?"share of contacts in each cell":"",n.poses.penetration?"poses pushed to contact":""];return y(fi,{title:"pose space",note:d.filter(p=>p!=="").join(", "),children:[s&&y(kt,{kind:"bad",children:s}),y("div",{class:"controls",children:[y(Ec,{label:"across",value:c,all:Yi,choose:p=>a([p,u])}),y(Ec,{label:"up",value:u,all:Yi,choose:p=>a([c,p])}),y("span",{class:"note",children:"of B in A's frame"})]}),f?y(tf,{model:f,open:p=>Cs(_n(n.job,p))}):y("p",{class:"wait",children:"reading the poses…"})]})}function F0({job:n,results:e}){let t=An(()=>w0(n),[n.job]);return t?y(MS,{job:n,grid:t,results:e}):y(wS,{job:n,results:e})}var AS=1024;function TS(n,e,t){let i=Math.min(AS,t-e),s=new Int32Array(i).fill(-1);for(let r=0;r<n.classes.length;++r){let o=n.scenarioAt(r);if(o<e||o>=t)continue;let a=Math.floor((o-e)*i/(t-e));(s[a]<0||n.isWorse(r,s[a]))&&(s[a]=r)}return s}function ES(n,e,t,i){let s=Math.round(n.clientWidth*devicePixelRatio),r=Math.round(n.clientHeight*devicePixelRatio),o=n.getContext("2d");if(!(!o||s===0)&&(n.width=s,n.height=r,t.forEach((a,l)=>{if(a<0)return;let c=e.classes[a],[u,f]=[l,l+1].map(p=>Math.round(p*s/t.length)),h=r*m0(c),d=f-u>4*devicePixelRatio?devicePixelRatio:0;o.fillStyle=zr(c),o.fillRect(u,r-h,Math.max(1,f-u-d),h)}),i)){let[a,l]=[Math.min(...i)*s,Math.max(...i)*s];o.fillStyle=Wi("--accent"),o.globalAlpha=.25,o.fillRect(a,0,l-a,r)}}function B0(n){let{source:e,job:t}=n,i=on(null),[s,r]=et([0,t.scenarios]),[o,a]=et(null),[l,c]=et(""),[u,f]=et(null),[h,d]=et(-1),[p,b]=et(0),g=bo(),[m,v]=s,E=o&&o.first===m&&o.end===v?o:n.results,M=An(()=>TS(E,m,v),[E,m,v]);Ye(()=>{if(a(null),n.results.isExact||!C0(e,m,v))return;let O=new AbortController;return wc(e,t,m,v,O.signal).then(a,I=>hs(I)||c(Tn(I))),()=>O.abort()},[m,v,n.results.isExact]),Ye(()=>{let O=i.current;if(!O)return;let I=new ResizeObserver(()=>b(O.clientWidth));return I.observe(O),()=>I.disconnect()},[]),Ye(()=>{i.current&&ES(i.current,E,M,u)},[E,m,v,u,p,g]);let L=O=>{let I=O.currentTarget.getBoundingClientRect();return Math.min(1,Math.max(0,(O.clientX-I.left)/I.width))},C=O=>Math.min(M.length-1,Math.floor(O*M.length)),_=O=>{M[O]>=0&&Cs(_n(t.job,E.scenarioAt(M[O])))},T=()=>{if(!u)return;let[O,I]=[Math.min(...u),Math.max(...u)];if(f(null),I-O<.005){_(C(O));return}let W=Math.floor(m+O*(v-m));r([W,Math.max(W+1,Math.ceil(m+I*(v-m)))]),d(-1)},k=O=>{let I=O.key==="ArrowRight"?1:O.key==="ArrowLeft"?-1:0;I!==0?(d(Math.min(M.length-1,Math.max(0,h+I))),O.preventDefault()):O.key==="Enter"&&h>=0?_(h):O.key==="Escape"&&r([0,t.scenarios])},U=h>=0&&h<M.length?M[h]:-1,D=m===0&&v===t.scenarios,H=U>=0?`#${E.scenarioAt(U)} ${Ds(E.classes[U])}, the worst of this bin`:"drag to zoom, click to open";return y(fi,{title:"scenarios in order",wide:!0,note:E.isExact?"":`a sample of ${Ge(E.classes.length)}; zoomed windows are exact`,children:[l&&y(kt,{kind:"bad",children:l}),y("canvas",{ref:i,class:"strip",tabIndex:0,role:"application","aria-label":`scenarios ${m} to ${v-1}: arrows move, Enter opens, Escape shows all. ${H}`,onPointerDown:O=>{O.currentTarget.setPointerCapture(O.pointerId),f([L(O),L(O)])},onPointerMove:O=>{d(C(L(O))),f(u&&[u[0],L(O)])},onPointerUp:T,onPointerCancel:()=>f(null),onPointerLeave:()=>u||d(-1),onKeyDown:k}),y("div",{class:"x-axis",children:[y("span",{children:["#",Ge(m)]}),y("span",{class:"readout",children:H}),y("span",{children:[!D&&y("button",{type:"button",class:"quiet",onClick:()=>r([0,t.scenarios]),children:"show all"})," ","#",Ge(v-1)]})]})]})}function k0(n){return n.state!=="running"&&n.state!=="paused"}function CS(n){return n.touch+n.cross+n.inside+n.contact}function RS({job:n}){let e=CS(n),t=n.done===n.scenarios?"":` tested so far, of ${Ge(n.scenarios)}`;return y("div",{class:"verdict",children:[y("h1",{children:[y(Ot,{text:n.name||n.job}),y("span",{class:`state ${n.state==="failed"?"bad":""}`,children:n.state}),!k0(n)&&y(xc,{done:n.done,total:n.scenarios})]}),y("p",{class:"sentence",children:e===0?`No contact in ${jt(n.done,"scenario")}${t}.`:`${Ge(e)} of ${jt(n.done,"scenario")}${t} ${e===1?"is":"are"} in contact (${En(e/Math.max(1,n.done))}), with ${jt(n.pairs,"pair")} of triangles.`}),y("p",{class:"counts",children:[mc.map((i,s)=>y(g0,{kind:s,count:n[i],always:i==="separate"||i==="cross"||i==="failed"},i)),n.digest&&y("span",{class:"count",children:["digest ",y("code",{title:n.digest,children:n.digest.slice(0,16)})]})]})]})}function PS({job:n}){let e=[];return n.surfaces_only>0&&e.push(`Containment was not tested in ${jt(n.surfaces_only,"scenario")}: a body is open.`),n.insides_skipped>0&&e.push(`Containment was not tested in ${jt(n.insides_skipped,"scenario")}: triangles are ignored, and the rest of a body is open.`),n.cut>0&&e.push(`The list of pairs ends at ${Ge(n.limit_pairs)} in ${jt(n.cut,"scenario")}; counts are true.`),n.map_pairs>0&&e.push(`The heat map counts the first ${Ge(n.map_pairs)} pairs of a scenario.`),e.length===0?null:y("p",{class:"caveats",children:e.join(" ")})}function IS({body:n,letter:e,unit:t}){let i=n.closed===null?"":n.closed?", closed":", open";return y("div",{class:"card",children:[y("b",{class:"letter",children:e}),y("div",{children:[y(Ot,{text:nr(n.file)}),n.name.toLowerCase()!==e.toLowerCase()&&y("span",{class:"note",children:[" ","called ",y(Ot,{text:n.name})]}),y("div",{class:"note",children:[jt(n.triangles,"triangle"),", ",jt(n.parts,"part"),i]}),y("div",{class:"note",children:[n.size.map(s=>Zn(s)).join(" × ")," ",t," · ",n.precision]})]})]})}function LS(n){let{poses:e}=n;return e.kind==="grid"?`grid ${(e.axes??[]).filter(i=>i.count>1).map(i=>`${i.name} ${Ge(i.count)}`).join(" × ")}`:e.kind==="random"?`random, seed ${e.seed??"-"}${e.penetration?`, pushed ${e.penetration.map(t=>En(t)).join(" to ")} into contact`:""}`:`file ${nr(e.file??"")}`}function DS({job:n}){let e=n.tolerance>0?`tolerance ${Zn(n.tolerance)} ${n.unit}`:"exact";return y("div",{class:"card",children:[y("b",{class:"letter",children:"×"}),y("div",{children:[y("span",{children:jt(n.poses.count,"pose")}),y("div",{class:"note",children:[LS(n),n.poses.of_both_bodies?", of both bodies":""]}),y("div",{class:"note",children:["level ",n.level,", ",e,n.ignored>0&&`, ${jt(n.ignored,"range")} ignored`]})]})]})}function NS({job:n}){let e=[["where",n.where],["instructions",n.simd],["time",n.seconds>0?`${Dr(n.seconds)}, ${tr(n.scenarios_per_second)}`:""],["owner",n.owner],["started",n.started||n.began],["ended",n.ended],["command",n.command],["program",[n.program,n.commit].filter(s=>s!=="").join(", commit ")],["digest",n.digest??""],...n.bodies.map(s=>[`mesh ${s.name}`,`${s.sha256} (${Rs(s.bytes)}), ${s.file}`])],t=n.folder?Sa(n.folder):n.job,i=(n.formats??[]).length>0?`the folder has ${n.formats?.join(", ")}; more:`:"";return y("details",{class:"how",children:[y("summary",{children:"how it ran, and exports"}),y("dl",{children:e.filter(([,s])=>s).map(([s,r])=>y("div",{children:[y("dt",{children:s}),y("dd",{children:y("bdi",{children:r})})]},s))}),y("p",{class:"note",children:[i," ",y(yc,{text:`cdctl results ${t}${n.folder?"":" --out out"} --formats csv,npz`})]})]})}var US=3e3;function OS(n,e){let[t,i]=et({results:null,error:"",done:-1,at:0}),[s,r]=et(0);return Ye(()=>{if(!e)return;let o=new AbortController,a=(l,c)=>i(u=>({results:l??u.results,error:c,done:e.done,at:performance.now()}));return wc(n,e,0,e.scenarios,o.signal).then(l=>a(l,""),l=>hs(l)||a(null,Tn(l))),()=>o.abort()},[e?.job,s]),Ye(()=>{if(!e||t.done<0||e.done===t.done)return;let o=Math.max(0,t.at+US-performance.now()),a=setTimeout(()=>r(l=>l+1),o);return()=>clearTimeout(a)},[e?.done,t]),t}function FS(n,e){Ye(()=>Ui("job",()=>({ready:n!==void 0&&e!==null,job:n?.job,done:n?.done,isExact:e?.isExact,tested:e?.classes.reduce((t,i)=>t+(i===255?0:1),0)})),[n,e])}function z0({source:n,id:e}){let{value:t,error:i}=Ls(`jobs/${encodeURIComponent(e)}`,1,a=>!k0(a)),{results:s,error:r}=OS(n,t),o=An(()=>s?.worst()??0,[s]);return rr(t&&t.name||e),FS(t,s),t?y(Ut,{children:[(i||r)&&y(kt,{kind:"bad",children:i||r}),t.failure&&y(kt,{kind:"bad",children:["failed: ",y(Ot,{text:t.failure})]}),t.paused&&y(kt,{kind:"warn",children:["paused: ",t.paused]}),y(RS,{job:t}),y("div",{class:"cards",children:[t.bodies.map((a,l)=>y(IS,{body:a,letter:l===0?"A":l===1?"B":String(l),unit:t.unit},l)),y(DS,{job:t}),y("a",{class:"card go",href:_n(t.job,o),children:"see it in 3D"})]}),y(PS,{job:t}),s?y(Ut,{children:[y("div",{class:"two",children:[y(F0,{job:t,results:s}),t.groups?y(S0,{job:t,groups:t.groups}):y(Qd,{results:s})]}),y(B0,{source:n,job:t,results:s}),y("div",{class:"two",children:[t.groups&&y(Qd,{results:s}),y(b0,{job:t,results:s})]})]}):y("p",{class:"wait",children:"reading the results…"}),y(NS,{job:t})]}):i?y(kt,{kind:"bad",children:i}):y("p",{class:"wait",children:["asking for ",e,"…"]})}var BS=[["n, p","next and previous scenario in contact"],["← →","previous and next scenario"],["space","play, stop"],["h","heat map, contacts"],["g","ghost: A, B, none"],["x","contacts through walls"],["l","segments and points"],["s","section plane"],["[ ]","move the section plane"],["f","fit all into view"],["c","go to the contact"],["shift ← → ↑ ↓","turn"],["+ −","nearer, farther"],["drag, wheel","turn, zoom; with the right button or two fingers: move"],["click","pick a triangle; with shift: of the ghost"],["?","these keys"]];function V0({close:n}){let e=on(null);return Ye(()=>e.current?.showModal(),[]),y("dialog",{ref:e,class:"keys",onClose:n,onClick:()=>e.current?.close(),children:[y("h2",{children:"Keys of the viewer"}),y("table",{children:y("tbody",{children:BS.map(([t,i])=>y("tr",{children:[y("th",{scope:"row",children:y("kbd",{children:t})}),y("td",{children:i})]},t))})}),y("button",{type:"button",children:"close"})]})}function H0(n){let e=n.target;if(n.ctrlKey||n.altKey||n.metaKey)return!0;if(e instanceof HTMLInputElement){let s=e.type==="range"||e.type==="radio";return e.type==="number"||s&&n.key.startsWith("Arrow")}let t=e instanceof HTMLButtonElement&&n.key===" ",i=e instanceof Element?e.getRootNode():document;return t||e instanceof HTMLSelectElement||i.querySelector("dialog[open]")!==null}function G0(n){return y("fieldset",{class:"radio",children:[y("legend",{children:n.title}),n.all.map(([e,t])=>y("label",{children:[y("input",{type:"radio",name:n.name,checked:n.value===e,onChange:()=>n.choose(e)}),y("span",{children:t})]},e))]})}function rf(n){return y("label",{class:"check",children:[y("input",{type:"checkbox",checked:n.isOn,onChange:e=>n.turn(e.currentTarget.checked)}),n.text]})}function kS(n){let{clip:e}=n.state,[t,i]=n.bounds[e?.axis??"x"],s=r=>(n.bounds[r][0]+n.bounds[r][1])/2;return y("div",{class:"section-plane",children:[y(rf,{text:"section",isOn:e!==null,turn:r=>n.change({clip:r?{axis:"x",at:s("x")}:null})}),e&&y(Ut,{children:[y("select",{"aria-label":"axis of the section plane",value:e.axis,onChange:r=>{let o=r.currentTarget.value;n.change({clip:{axis:o,at:s(o)}})},children:["x","y","z"].map(r=>y("option",{children:r},r))}),y("input",{type:"range","aria-label":"place of the section plane",min:t,max:i,step:(i-t)/500||1,value:e.at,onInput:r=>n.change({clip:{axis:e.axis,at:Number(r.currentTarget.value)}})}),y("output",{children:Number(e.at.toPrecision(4))})]})]})}function W0(n){let{state:e,change:t}=n,i=[["contacts","contacts"]];n.hasMap&&i.push(["heat","heat map"]);let s=[["a","A"],["b","B"],["none","none"]];return y("section",{class:"view-controls","aria-label":"view",children:[y(G0,{title:"show",name:"mode",value:e.mode,all:i,choose:r=>t({mode:r})}),y(G0,{title:"ghost",name:"ghost",value:e.ghost,all:s,choose:r=>t({ghost:r})}),y(rf,{text:"through walls",isOn:e.throughWalls,turn:r=>t({throughWalls:r})}),y(rf,{text:"segments and points",isOn:e.lines,turn:r=>t({lines:r})}),y(kS,{state:e,bounds:n.bounds,change:t}),y("div",{class:"buttons",children:[y("button",{type:"button",onClick:n.fit,title:"f",children:"fit"}),y("button",{type:"button",onClick:n.goToContact,title:"c",children:"go to the contact"})]})]})}function X0({address:n}){let[e,t]=et("");return y("button",{type:"button",onClick:()=>Zd(n(),t),children:e||"copy link"})}var Da=[[68,1,84],[71,45,123],[59,82,139],[44,114,142],[33,145,140],[40,174,128],[94,201,98],[173,220,48],[253,231,37]];function of(n){let e=Math.min(1,Math.max(0,n))*(Da.length-1),t=Math.min(Da.length-2,Math.floor(e)),i=e-t;return[0,1,2].map(s=>Math.round(Da[t][s]+(Da[t+1][s]-Da[t][s])*i))}function q0(n){let e=new Uint8Array(1024);for(let t=0;t<256;++t)e.set([...t===0?n:of((t-1)/254),255],4*t);return e}function zS(n,e){return n===0?0:e<=1?255:1+Math.round(254*Math.log(n)/Math.log(e))}function $0(n,e){let t=new Float64Array(e);for(let i=0;i+1<n.length;i+=2)t[n[i]]=n[i+1];return t}function Y0(n,e){let t=new Uint8Array(3*n.length);for(let i=0;i<n.length;++i)t.fill(zS(n[i],e),3*i,3*i+3);return t}var Cc=48;function VS(n){let e=[1];for(let t=10;t<n/2;t*=10)e.push(t);return n>1?[...e,n]:e}function J0({heat:n,job:e}){if(n.most===0)return y("p",{class:"note",children:"no triangle was in contact"});let[t,i]=[264,10],s=o=>n.most<=1?0:Math.log(o)/Math.log(n.most)*t,r=VS(n.most);return y("figure",{class:"legend",children:[y("svg",{viewBox:`0 0 ${t} 42`,role:"img","aria-label":"colours of the heat map",children:[Array.from({length:Cc},(o,a)=>{let[l,c,u]=of(a/(Cc-1));return y("rect",{x:a*t/Cc,y:0,width:t/Cc+.5,height:i,fill:`rgb(${l},${c},${u})`},a)}),r.map((o,a)=>y("g",{children:[y("line",{x1:s(o),x2:s(o),y1:i,y2:i+3}),y("text",{x:s(o),y:i+14,class:a===0?"begin":a===r.length-1?"end":"",children:Ge(o)}),y("text",{x:s(o),y:i+27,class:a===0?"begin":a===r.length-1?"end":"",children:En(o/Math.max(1,e.done))})]},o))]}),y("figcaption",{class:"note",children:["scenarios in which a triangle is in contact, logarithmic",e.map_pairs>0&&`, of the first ${Ge(e.map_pairs)} pairs`,"; plain: never"]})]})}function Z0(){return y("ul",{class:"legend plain",children:[y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:y("path",{d:"M1 11 7 1l6 10z",fill:zr(2)})}),"proper: goes through the other"]}),y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:y("path",{d:"M1 11 7 1l6 10z",fill:zr(1),class:"outlined"})}),"touch or coplanar: outlined"]}),y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:[y("path",{d:"M1 9 11 4",class:"thick"}),y("circle",{cx:12,cy:4,r:2})]}),"what they share"]})]})}var HS=[0,67,68,77,69,83,72,49],af=29;async function GS(n,e){if(!globalThis.crypto?.subtle)return null;let t=new Uint8Array(await crypto.subtle.digest("SHA-256",n));return Array.from(t,i=>i.toString(16).padStart(2,"0")).join("")===e}function WS(n,e,t){let i=[],s=new TextDecoder;for(let r=0;r<t;++r){let o=n.getUint32(e,!0),a=s.decode(new Uint8Array(n.buffer,e+4,o));e+=4+o,i.push({name:a,begin:n.getUint32(e,!0),end:n.getUint32(e+4,!0)}),e+=8}return i}function XS(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i+=3)for(let s=0;s<3;++s){let r=n[i+s];e[s]=r<e[s]?r:e[s],t[s]=r>t[s]?r:t[s]}return n.length===0?[[0,0,0],[0,0,0]]:[e,t]}function qS(n,e,t){let i=new DataView(n);if(n.byteLength<af||HS.some((b,g)=>i.getUint8(g)!==b))throw new Error("the server's mesh is not in canonical form");let s=i.getUint8(8)===1,r=Number(i.getBigUint64(9,!0)),o=Number(i.getBigUint64(17,!0)),a=i.getUint32(25,!0),l=af+r*3*(s?8:4),c=l+o*12;if(c>n.byteLength)throw new Error("the server's mesh is cut short");let u=n.slice(af,l),f=s?new Float64Array(u):new Float32Array(u),h=new Uint32Array(n.slice(l,c)),[d,p]=XS(f);return{sha256:e,checked:t,bytes:n.byteLength,vertices:f,triangles:h,parts:WS(i,c,a),min:d,max:p,centre:[0,1,2].map(b=>(d[b]+p[b])/2)}}async function lf(n,e){let t=await Im(`meshes/${n}`,e),i=await GS(t,n);try{return qS(t,n,i)}catch(s){throw i===!1?new Error(`not the tested geometry: ${Tn(s)}`):s}}function K0(n){let{vertices:e,triangles:t,centre:i}=n,[s,r,o]=i,a=new Float32Array(3*t.length);for(let l=0;l<t.length;++l){let c=3*t[l];a[3*l]=e[c]-s,a[3*l+1]=e[c+1]-r,a[3*l+2]=e[c+2]-o}return a}function Rc(n,e){let t=0,i=n.parts.length;for(;t<i;){let r=t+i>>1;n.parts[r].end<=e?t=r+1:i=r}let s=n.parts[t];return s&&s.begin<=e?s:void 0}function Eo(n,e,t){return t===""||Rc(n,e)?.name===t}var Na=8e6,Pc=null;async function $S(n){let e=performance.now(),[t,i]=n.bodies.map(o=>o.sha256),s=lf(t);return{meshes:await Promise.all([s,t===i?s:lf(i)]),milliseconds:performance.now()-e}}function j0(n){let e=n.bodies.map(t=>t.sha256).join(" ");if(Pc?.key!==e){let t=$S(n);Pc={key:e,model:t},t.catch(()=>{Pc=null})}return Pc.model}async function Q0(n,e){try{let i=(await Promise.all([0,1].map(r=>Ni(`jobs/${encodeURIComponent(n.job)}/map/${r}`)))).map((r,o)=>$0(r.values,e.meshes[o].triangles.length/3)),s=i.reduce((r,o)=>o.reduce((a,l)=>Math.max(a,l),r),0);return{counts:i,most:s}}catch(t){if(t instanceof us&&t.status===404)return null;throw t}}var cf=100;function YS(n,e){let t=new Map;for(let i=0;i+2<n.length;i+=3){let[s,r]=[0,1].map(l=>Rc(e[l],n[i+l])?.name??""),o=`${s.length}:${s}${r}`,a=t.get(o);a?a.count+=1:t.set(o,{a:s,b:r,count:1})}return[...t.values()].sort((i,s)=>s.count-i.count)}function t_(n){let{state:e}=n,t=An(()=>YS(n.contacts.pairs,n.model.meshes),[n.contacts,n.model]);if(t.length===0&&!e.partA&&!e.partB)return null;let i=s=>e.partA===s.a&&e.partB===s.b;return y("section",{"aria-label":"parts in contact here",children:[y("h2",{children:"parts in contact here"}),y("ul",{class:"pairs",children:t.slice(0,cf).map(s=>y("li",{children:y("button",{type:"button","aria-pressed":i(s),onClick:()=>i(s)?n.choose("",""):n.choose(s.a,s.b),children:[y("span",{children:[y(Ot,{text:s.a})," ",y("i",{children:"×"})," ",y(Ot,{text:s.b})]}),y("b",{children:Ge(s.count)})]})},`${s.a}
${s.b}`))}),t.length>cf&&y("p",{class:"note",children:["and ",jt(t.length-cf,"pair")," of parts more"]}),(e.partA||e.partB)&&y("p",{class:"note",children:["only ",y(Ot,{text:e.partA||"all of A"})," × ",y(Ot,{text:e.partB||"all of B"}),";"," ",y("button",{type:"button",class:"link",onClick:()=>n.choose("",""),children:"show all"})]})]})}function n_(n){let{pick:e,job:t}=n,i=n.model.meshes[e.body],s=Rc(i,e.triangle),r=e.triangle<i.triangles.length/3,o=An(()=>{let l=0,c=n.contacts?.pairs??new Uint32Array;for(let u=e.body;u<c.length;u+=3)l+=c[u]===e.triangle?1:0;return l},[n.contacts,e]),a=n.heat?.counts[e.body][e.triangle];return y("section",{"aria-label":"picked triangle","aria-live":"polite",children:[y("h2",{children:["picked"," ",y("button",{type:"button",class:"link",onClick:n.drop,children:"drop"})]}),r?y("p",{children:[e.body===0?"A":"B"," triangle ",y("b",{children:Ge(e.triangle)}),s&&y(Ut,{children:[", ",y(Ot,{text:s.name})," ",Ge(e.triangle-s.begin)]}),"; in ",jt(o,"pair")," here",a!==void 0&&`; in ${Ge(a)} of ${jt(t.done,"pose")} (${En(a/Math.max(1,t.done))})`]}):y("p",{children:["the mesh has no triangle ",Ge(e.triangle)]})]})}function e_({pose:n,title:e}){let t=[n.slice(0,4),n.slice(4,8),n.slice(8,12),[0,0,0,1]];return y("table",{class:"matrix",children:[y("caption",{children:e}),y("tbody",{children:t.map((i,s)=>y("tr",{children:i.map((r,o)=>y("td",{children:String(r)},o))},s))})]})}function i_({job:n,contacts:e,relative:t}){let i=Ia(t),s=Yi.filter(a=>a!=="distance"&&(!ar(a)||Math.abs(i[a])>1e-9)).map(a=>`${a} ${Zn(i[a],5)}${ar(a)?"°":""}`),{pose_a:r,pose_b:o}=e.scenario;return y("section",{"aria-label":"pose",children:[y("h2",{children:"B in A's frame"}),y("p",{children:[s.join("  ")," ",y("span",{class:"note",children:["lengths in ",n.unit]})]}),y("details",{children:[y("summary",{children:"matrix"}),n.poses.of_both_bodies&&y(e_,{pose:r,title:"A in the world"}),y(e_,{pose:n.poses.of_both_bodies?o:t,title:n.poses.of_both_bodies?"B in the world":"B in A's frame"})]})]})}function s_({model:n,contacts:e}){let t=n?.meshes.filter(r=>r.checked===!1)??[],i=n?.meshes.some(r=>r.checked===null)??!1,s=e?.scenario;return y(Ut,{children:[t.length>0&&y(kt,{kind:"bad",children:["not the tested geometry: the bytes of ",jt(t.length,"mesh").replace("meshs","meshes")," do not have the SHA-256 of the run (",t.map(r=>r.sha256.slice(0,16)).join(", "),")"]}),t.length===0&&i&&y(kt,{kind:"warn",children:"the geometry is not checked: this browser computes SHA-256 on 127.0.0.1 or over TLS only"}),s?.verified===!1&&y(kt,{kind:"bad",children:["this scenario, run again, gives another record than the stored one: ",s.verify_note]}),s&&s.failure!==""&&y(kt,{kind:"bad",children:["failed: ",y(Ot,{text:s.failure})]})]})}function r_({job:n,contacts:e}){let{scenario:t}=e,i=_c(t.class),s=t.class!==null&&t.count>0?jt(t.count,"pair"):"",r=[i===3?"one body is inside the other: g changes the ghost":"",t.id!==null?`id ${t.id}`:"",t.time!==null?`t ${Zn(t.time,6)}`:"",e.isCut?`drawn: the first ${Ge(e.pairs.length/3)} pairs`:"",t.cut?`list of pairs cut at ${Ge(t.listed)}`:"",t.surfaces_only?"surfaces only: a body is open":"",t.insides_skipped?"containment not tested: triangles are ignored":"",t.distance_bound!==null&&t.distance_bound>0?`at most ${Zn(t.distance_bound)} ${n.unit} apart`:""].filter(o=>o!=="");return y("span",{class:"scenario-status",children:[y("span",{children:[y(Vr,{kind:i}),y("b",{children:t.class??"no result yet"}),s&&`, ${s}`]}),t.verified===!0&&y("span",{class:"verified",title:"run again, the record has the same bytes",children:"✓ verified"}),t.verified===null&&y("span",{class:"note",title:t.verify_note,children:["not verified",t.verify_note&&`: ${t.verify_note}`]}),r.length>0&&y("span",{class:"note",children:r.join(" · ")})]})}var Ic=class{constructor(e,t){this.total=e;this.chosen=t?[...t].sort((i,s)=>i-s):null}total;chosen;get count(){return this.chosen?.length??this.total}at(e){let t=Math.min(this.count-1,Math.max(0,e));return this.chosen?this.chosen[t]:t}placeOf(e){if(!this.chosen)return Math.min(this.total-1,Math.max(0,e));let t=this.chosen.map(i=>Math.abs(i-e));return t.indexOf(Math.min(...t))}};async function o_(n,e,t,i){let s=new URLSearchParams({from:String(e),step:String(t)});i.partA&&s.set("part_a",i.partA),i.partB&&s.set("part_b",i.partB);let r=`jobs/${encodeURIComponent(n)}/scenarios/next?${s}`;return(await Es(r)).index}async function a_(n,e,t,i,s,r){let o=e.filter(a=>(a-t)*i>0).sort((a,l)=>(a-l)*i);for(let a of o){if(!s.partA&&!s.partB)return a;let{values:l}=await Ni(`jobs/${encodeURIComponent(n)}/scenarios/${a}/pairs`);for(let c=0;c+2<l.length;c+=3)if(Eo(r[0],l[c],s.partA)&&Eo(r[1],l[c+1],s.partB))return a}return null}var JS=300,Lc=class{constructor(e,t,i){this.job=e;this.show=t;this.fail=i}job;show;fail;wanted=null;isLoading=!1;stop=new AbortController;want(e){this.wanted=e,this.isLoading||this.run()}close(){this.wanted=null,this.stop.abort()}async run(){for(this.isLoading=!0;this.wanted!==null;){let e=this.wanted;try{let t=await this.load(e);this.wanted=this.wanted===e?null:this.wanted,this.show(t)}catch(t){if(hs(t)||this.stop.signal.aborted)break;t instanceof us&&t.status===503?await new Promise(i=>setTimeout(i,JS)):(this.wanted=this.wanted===e?null:this.wanted,this.fail(e,t))}}this.isLoading=!1}async load(e){let t=`jobs/${encodeURIComponent(this.job)}/scenarios/${e}`,i=this.stop.signal,s=await Es(t,i);if(s.class===null||s.exact_pairs===0)return{scenario:s,pairs:new Uint32Array,points:new Float64Array,isCut:!1};let r=await Ni(`${t}/pairs`,i),o=await Ni(`${t}/points`,i);return{scenario:s,pairs:r.values,points:o.values,isCut:r.cut||o.cut}}};var Sr={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Mr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},V_=0,zf=1,H_=2;var ml=1,G_=2,ta=3,wr=0,hi=1,gi=2,$r=0,na=1,Vf=2,Hf=3,Gf=4,W_=5;var Yr=100,X_=101,q_=102,$_=103,Y_=104,J_=200,Z_=201,K_=202,j_=203,Wf=204,Xf=205,Q_=206,ex=207,tx=208,nx=209,ix=210,sx=211,rx=212,ox=213,ax=214,ou=0,au=1,lu=2,pr=3,cu=4,uu=5,hu=6,du=7,ku=0,lx=1,cx=2,_s=0,qf=1,$f=2,Yf=3,Jf=4,Zf=5,Kf=6,jf=7;var Qf=300,Jr=301,ia=302,zu=303,Vu=304,fu=1e3,ms=1001,pu=1002,cn=1003,ux=1004;var gl=1005;var ui=1006,Hu=1007;var Gs=1008;var _i=1009,ep=1010,tp=1011,sa=1012,Gu=1013,es=1014,ts=1015,ns=1016,Wu=1017,Xu=1018,Zr=1020,np=35902,ip=35899,sp=1021,rp=1022,Ii=1023,zs=1026,Ws=1027,op=1028,qu=1029,Ar=1030,$u=1031;var Yu=1033,_l=33776,xl=33777,yl=33778,vl=33779,Ju=35840,Zu=35841,Ku=35842,ju=35843,Qu=36196,eh=37492,th=37496,nh=37488,ih=37489,bl=37490,sh=37491,rh=37808,oh=37809,ah=37810,lh=37811,ch=37812,uh=37813,hh=37814,dh=37815,fh=37816,ph=37817,mh=37818,gh=37819,_h=37820,xh=37821,yh=36492,vh=36494,bh=36495,Sh=36283,Mh=36284,Sl=36285,wh=36286;var Ga=2300,mu=2301,su=2302,Lf=2303,Df=2400,Nf=2401,Uf=2402;var hx=3200;var Ah=0,dx=1,Xs="",kn="srgb",Wa="srgb-linear",Xa="linear",Rt="srgb";var ru=7680;var fx=519,px=512,mx=513,gx=514,ap=515,_x=516,xx=517,lp=518,cp=519,up=35044;var hp="300 es",ki=2e3,Wo=2001;function ZS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function KS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function qa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function yx(){let n=qa("canvas");return n.style.display="block",n}var l_={},Xo=null;function $a(...n){let e="THREE."+n.shift();Xo?Xo("log",e,...n):console.log(e,...n)}function vx(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function Je(...n){n=vx(n);let e="THREE."+n.shift();if(Xo)Xo("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function st(...n){n=vx(n);let e="THREE."+n.shift();if(Xo)Xo("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function za(...n){let e=n.join(" ");e in l_||(l_[e]=!0,Je(...n))}function bx(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var Sx={[ou]:ou,[lu]:hu,[cu]:cu,[pr]:uu,[au]:au,[hu]:lu,[du]:du,[uu]:pr},ji=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],c_=1234567,Va=Math.PI/180,qo=180/Math.PI;function Tr(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Kn[n&255]+Kn[n>>8&255]+Kn[n>>16&255]+Kn[n>>24&255]+"-"+Kn[e&255]+Kn[e>>8&255]+"-"+Kn[e>>16&15|64]+Kn[e>>24&255]+"-"+Kn[t&63|128]+Kn[t>>8&255]+"-"+Kn[t>>16&255]+Kn[t>>24&255]+Kn[i&255]+Kn[i>>8&255]+Kn[i>>16&255]+Kn[i>>24&255]).toLowerCase()}function ut(n,e,t){return Math.max(e,Math.min(t,n))}function dp(n,e){return(n%e+e)%e}function jS(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function QS(n,e,t){return n!==e?(t-n)/(e-n):0}function Ha(n,e,t){return(1-t)*n+t*e}function eM(n,e,t,i){return Ha(n,e,1-Math.exp(-t*i))}function tM(n,e=1){return e-Math.abs(dp(n,e*2)-e)}function nM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function iM(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function sM(n,e){return n+Math.floor(Math.random()*(e-n+1))}function rM(n,e){return n+Math.random()*(e-n)}function oM(n){return n*(.5-Math.random())}function aM(n){n!==void 0&&(c_=n);let e=c_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function lM(n){return n*Va}function cM(n){return n*qo}function uM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function hM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function fp(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function dM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:Je("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Th(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function pp(n,e){if(e.constructor===Float32Array)return n;let t=Th(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function mp(n,e){if(e.constructor===Float32Array)return n;let t=Th(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ml={DEG2RAD:Va,RAD2DEG:qo,generateUUID:Tr,clamp:ut,euclideanModulo:dp,mapLinear:jS,inverseLerp:QS,lerp:Ha,damp:eM,pingpong:tM,smoothstep:nM,smootherstep:iM,randInt:sM,randFloat:rM,randFloatSpread:oM,seededRandom:aM,degToRad:lM,radToDeg:cM,isPowerOfTwo:uM,ceilPowerOfTwo:hM,floorPowerOfTwo:fp,setQuaternionFromProperEuler:dM,normalize:mp,denormalize:pp},Ke=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ci=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],b=r[o+3];if(f!==b||l!==h||c!==d||u!==p){let g=l*h+c*d+u*p+f*b;g<0&&(h=-h,d=-d,p=-p,b=-b,g=-g);let m=1-a;if(g<.9995){let v=Math.acos(g),E=Math.sin(v);m=Math.sin(m*v)/E,a=Math.sin(a*v)/E,l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+b*a}else{l=l*m+h*a,c=c*m+d*a,u=u*m+p*a,f=f*m+b*a;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:Je("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(ut(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},V=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(u_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(u_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return uf.copy(this).projectOnVector(e),this.sub(uf)}reflect(e){return this.sub(uf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(ut(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},uf=new V,u_=new Ci,ot=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],b=s[0],g=s[3],m=s[6],v=s[1],E=s[4],M=s[7],L=s[2],C=s[5],_=s[8];return r[0]=o*b+a*v+l*L,r[3]=o*g+a*E+l*C,r[6]=o*m+a*M+l*_,r[1]=c*b+u*v+f*L,r[4]=c*g+u*E+f*C,r[7]=c*m+u*M+f*_,r[2]=h*b+d*v+p*L,r[5]=h*g+d*E+p*C,r[8]=h*m+d*M+p*_,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/p;return e[0]=f*b,e[1]=(s*c-u*i)*b,e[2]=(a*i-s*o)*b,e[3]=h*b,e[4]=(u*t-s*l)*b,e[5]=(s*r-a*t)*b,e[6]=d*b,e[7]=(i*l-c*t)*b,e[8]=(o*t-i*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return za("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(hf.makeScale(e,t)),this}rotate(e){return za("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(hf.makeRotation(-e)),this}translate(e,t){return za("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(hf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},hf=new ot,h_=new ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),d_=new ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function fM(){let n={enabled:!0,workingColorSpace:Wa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Rt&&(s.r=ks(s.r),s.g=ks(s.g),s.b=ks(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Rt&&(s.r=Go(s.r),s.g=Go(s.g),s.b=Go(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Xs?Xa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Wa]:{primaries:e,whitePoint:i,transfer:Xa,toXYZ:h_,fromXYZ:d_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:kn},outputColorSpaceConfig:{drawingBufferColorSpace:kn}},[kn]:{primaries:e,whitePoint:i,transfer:Rt,toXYZ:h_,fromXYZ:d_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:kn}}}),n}var vt=fM();function ks(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Go(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var Co,gu=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{Co===void 0&&(Co=qa("canvas")),Co.width=e.width,Co.height=e.height;let s=Co.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=Co}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=qa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=ks(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(ks(t[i]/255)*255):t[i]=ks(t[i]);return{data:t,width:e.width,height:e.height}}else return Je("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},pM=0,$o=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:pM++}),this.uuid=Tr(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(df(s[o].image)):r.push(df(s[o]))}else r=df(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function df(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?gu.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:(Je("Texture: Unable to serialize Texture."),{})}var mM=0,ff=new V,mi=class n extends ji{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ms,s=ms,r=ui,o=Gs,a=Ii,l=_i,c=n.DEFAULT_ANISOTROPY,u=Xs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:mM++}),this.uuid=Tr(),this.name="",this.source=new $o(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ke(0,0),this.repeat=new Ke(1,1),this.center=new Ke(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new ot,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(ff).x}get height(){return this.source.getSize(ff).y}get depth(){return this.source.getSize(ff).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){Je(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Qf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case fu:e.x=e.x-Math.floor(e.x);break;case ms:e.x=e.x<0?0:1;break;case pu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case fu:e.y=e.y-Math.floor(e.y);break;case ms:e.y=e.y<0?0:1;break;case pu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};mi.DEFAULT_IMAGE=null;mi.DEFAULT_MAPPING=Qf;mi.DEFAULT_ANISOTROPY=1;var Pt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],b=l[2],g=l[6],m=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-b)<.01&&Math.abs(p-g)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+b)<.1&&Math.abs(p+g)<.1&&Math.abs(c+d+m-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let E=(c+1)/2,M=(d+1)/2,L=(m+1)/2,C=(u+h)/4,_=(f+b)/4,T=(p+g)/4;return E>M&&E>L?E<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(E),s=C/i,r=_/i):M>L?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=C/s,r=T/s):L<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(L),i=_/r,s=T/r),this.set(i,s,r,t),this}let v=Math.sqrt((g-p)*(g-p)+(f-b)*(f-b)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(g-p)/v,this.y=(f-b)/v,this.z=(h-u)/v,this.w=Math.acos((c+d+m-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=ut(this.x,e.x,t.x),this.y=ut(this.y,e.y,t.y),this.z=ut(this.z,e.z,t.z),this.w=ut(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=ut(this.x,e,t),this.y=ut(this.y,e,t),this.z=ut(this.z,e,t),this.w=ut(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(ut(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},_u=class extends ji{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ui,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Pt(0,0,e,t),this.scissorTest=!1,this.viewport=new Pt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new mi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ui,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new $o(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ri=class extends _u{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},Ya=class extends mi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var xu=class extends mi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=ms,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var St=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,g){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,g)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,g){let m=this.elements;return m[0]=e,m[4]=t,m[8]=i,m[12]=s,m[1]=r,m[5]=o,m[9]=a,m[13]=l,m[2]=c,m[6]=u,m[10]=f,m[14]=h,m[3]=d,m[7]=p,m[11]=b,m[15]=g,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Ro.setFromMatrixColumn(e,0).length(),r=1/Ro.setFromMatrixColumn(e,1).length(),o=1/Ro.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-b*c,t[9]=-a*l,t[2]=b-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h+b*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=b+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h-b*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=b-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+b,t[1]=l*f,t[5]=b*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=b-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-b*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+b,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=b*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(gM,e,_M)}lookAt(e,t,i){let s=this.elements;return Ti.subVectors(e,t),Ti.lengthSq()===0&&(Ti.z=1),Ti.normalize(),lr.crossVectors(i,Ti),lr.lengthSq()===0&&(Math.abs(i.z)===1?Ti.x+=1e-4:Ti.z+=1e-4,Ti.normalize(),lr.crossVectors(i,Ti)),lr.normalize(),Dc.crossVectors(Ti,lr),s[0]=lr.x,s[4]=Dc.x,s[8]=Ti.x,s[1]=lr.y,s[5]=Dc.y,s[9]=Ti.y,s[2]=lr.z,s[6]=Dc.z,s[10]=Ti.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],b=i[6],g=i[10],m=i[14],v=i[3],E=i[7],M=i[11],L=i[15],C=s[0],_=s[4],T=s[8],k=s[12],U=s[1],D=s[5],H=s[9],O=s[13],I=s[2],W=s[6],$=s[10],G=s[14],le=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*C+a*U+l*I+c*le,r[4]=o*_+a*D+l*W+c*Z,r[8]=o*T+a*H+l*$+c*Q,r[12]=o*k+a*O+l*G+c*ie,r[1]=u*C+f*U+h*I+d*le,r[5]=u*_+f*D+h*W+d*Z,r[9]=u*T+f*H+h*$+d*Q,r[13]=u*k+f*O+h*G+d*ie,r[2]=p*C+b*U+g*I+m*le,r[6]=p*_+b*D+g*W+m*Z,r[10]=p*T+b*H+g*$+m*Q,r[14]=p*k+b*O+g*G+m*ie,r[3]=v*C+E*U+M*I+L*le,r[7]=v*_+E*D+M*W+L*Z,r[11]=v*T+E*H+M*$+L*Q,r[15]=v*k+E*O+M*G+L*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],b=e[7],g=e[11],m=e[15],v=l*d-c*h,E=a*d-c*f,M=a*h-l*f,L=o*d-c*u,C=o*h-l*u,_=o*f-a*u;return t*(b*v-g*E+m*M)-i*(p*v-g*L+m*C)+s*(p*E-b*L+m*_)-r*(p*M-b*C+g*_)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],b=e[13],g=e[14],m=e[15],v=t*a-i*o,E=t*l-s*o,M=t*c-r*o,L=i*l-s*a,C=i*c-r*a,_=s*c-r*l,T=u*b-f*p,k=u*g-h*p,U=u*m-d*p,D=f*g-h*b,H=f*m-d*b,O=h*m-d*g,I=v*O-E*H+M*D+L*U-C*k+_*T;if(I===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let W=1/I;return e[0]=(a*O-l*H+c*D)*W,e[1]=(s*H-i*O-r*D)*W,e[2]=(b*_-g*C+m*L)*W,e[3]=(h*C-f*_-d*L)*W,e[4]=(l*U-o*O-c*k)*W,e[5]=(t*O-s*U+r*k)*W,e[6]=(g*M-p*_-m*E)*W,e[7]=(u*_-h*M+d*E)*W,e[8]=(o*H-a*U+c*T)*W,e[9]=(i*U-t*H-r*T)*W,e[10]=(p*C-b*M+m*v)*W,e[11]=(f*M-u*C-d*v)*W,e[12]=(a*k-o*D-l*T)*W,e[13]=(t*D-i*k+s*T)*W,e[14]=(b*E-p*L-g*v)*W,e[15]=(u*L-f*E+h*v)*W,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,b=o*u,g=o*f,m=a*f,v=l*c,E=l*u,M=l*f,L=i.x,C=i.y,_=i.z;return s[0]=(1-(b+m))*L,s[1]=(d+M)*L,s[2]=(p-E)*L,s[3]=0,s[4]=(d-M)*C,s[5]=(1-(h+m))*C,s[6]=(g+v)*C,s[7]=0,s[8]=(p+E)*_,s[9]=(g-v)*_,s[10]=(1-(h+b))*_,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Ro.set(s[0],s[1],s[2]).length(),a=Ro.set(s[4],s[5],s[6]).length(),l=Ro.set(s[8],s[9],s[10]).length();r<0&&(o=-o),Ji.copy(this);let c=1/o,u=1/a,f=1/l;return Ji.elements[0]*=c,Ji.elements[1]*=c,Ji.elements[2]*=c,Ji.elements[4]*=u,Ji.elements[5]*=u,Ji.elements[6]*=u,Ji.elements[8]*=f,Ji.elements[9]*=f,Ji.elements[10]*=f,t.setFromRotationMatrix(Ji),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=ki,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,b;if(l)p=r/(o-r),b=o*r/(o-r);else if(a===ki)p=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===Wo)p=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=ki,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,b;if(l)p=1/(o-r),b=o/(o-r);else if(a===ki)p=-2/(o-r),b=-(o+r)/(o-r);else if(a===Wo)p=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Ro=new V,Ji=new St,gM=new V(0,0,0),_M=new V(1,1,1),lr=new V,Dc=new V,Ti=new V,f_=new St,p_=new Ci,Vs=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(ut(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-ut(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(ut(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-ut(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(ut(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-ut(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:Je("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return f_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(f_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return p_.setFromEuler(this),this.setFromQuaternion(p_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Vs.DEFAULT_ORDER="XYZ";var Ja=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},xM=0,m_=new V,Po=new Ci,Ns=new St,Nc=new V,Ua=new V,yM=new V,vM=new Ci,g_=new V(1,0,0),__=new V(0,1,0),x_=new V(0,0,1),y_={type:"added"},bM={type:"removed"},Io={type:"childadded",child:null},pf={type:"childremoved",child:null},Vn=class n extends ji{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:xM++}),this.uuid=Tr(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new V,t=new Vs,i=new Ci,s=new V(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new St},normalMatrix:{value:new ot}}),this.matrix=new St,this.matrixWorld=new St,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ja,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Po.setFromAxisAngle(e,t),this.quaternion.multiply(Po),this}rotateOnWorldAxis(e,t){return Po.setFromAxisAngle(e,t),this.quaternion.premultiply(Po),this}rotateX(e){return this.rotateOnAxis(g_,e)}rotateY(e){return this.rotateOnAxis(__,e)}rotateZ(e){return this.rotateOnAxis(x_,e)}translateOnAxis(e,t){return m_.copy(e).applyQuaternion(this.quaternion),this.position.add(m_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(g_,e)}translateY(e){return this.translateOnAxis(__,e)}translateZ(e){return this.translateOnAxis(x_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ns.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Nc.copy(e):Nc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ua.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ns.lookAt(Ua,Nc,this.up):Ns.lookAt(Nc,Ua,this.up),this.quaternion.setFromRotationMatrix(Ns),s&&(Ns.extractRotation(s.matrixWorld),Po.setFromRotationMatrix(Ns),this.quaternion.premultiply(Po.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(st("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(y_),Io.child=e,this.dispatchEvent(Io),Io.child=null):st("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(bM),pf.child=e,this.dispatchEvent(pf),pf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ns.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ns.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ns),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(y_),Io.child=e,this.dispatchEvent(Io),Io.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,e,yM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,vM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};Vn.DEFAULT_UP=new V(0,1,0);Vn.DEFAULT_MATRIX_AUTO_UPDATE=!0;Vn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var pi=class extends Vn{constructor(){super(),this.isGroup=!0,this.type="Group"}},SM={type:"move"},Yo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new pi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new pi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new V,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new V),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new pi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new V,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new V,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let g=t.getJointPose(b,i),m=this._getHandJoint(c,b);g!==null&&(m.matrix.fromArray(g.transform.matrix),m.matrix.decompose(m.position,m.quaternion,m.scale),m.matrixWorldNeedsUpdate=!0,m.jointRadius=g.radius),m.visible=g!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(SM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new pi;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},Mx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},cr={h:0,s:0,l:0},Uc={h:0,s:0,l:0};function mf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var dt=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=kn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=vt.workingColorSpace){if(e=dp(e,1),t=ut(t,0,1),i=ut(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=mf(o,r,e+1/3),this.g=mf(o,r,e),this.b=mf(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=kn){function i(r){r!==void 0&&parseFloat(r)<1&&Je("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:Je("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);Je("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=kn){let i=Mx[e.toLowerCase()];return i!==void 0?this.setHex(i,t):Je("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=ks(e.r),this.g=ks(e.g),this.b=ks(e.b),this}copyLinearToSRGB(e){return this.r=Go(e.r),this.g=Go(e.g),this.b=Go(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=kn){return vt.workingToColorSpace(jn.copy(this),e),Math.round(ut(jn.r*255,0,255))*65536+Math.round(ut(jn.g*255,0,255))*256+Math.round(ut(jn.b*255,0,255))}getHexString(e=kn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(jn.copy(this),t);let i=jn.r,s=jn.g,r=jn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(jn.copy(this),t),e.r=jn.r,e.g=jn.g,e.b=jn.b,e}getStyle(e=kn){vt.workingToColorSpace(jn.copy(this),e);let t=jn.r,i=jn.g,s=jn.b;return e!==kn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(cr),this.setHSL(cr.h+e,cr.s+t,cr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(cr),e.getHSL(Uc);let i=Ha(cr.h,Uc.h,t),s=Ha(cr.s,Uc.s,t),r=Ha(cr.l,Uc.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},jn=new dt;dt.NAMES=Mx;var Za=class extends Vn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Vs,this.environmentIntensity=1,this.environmentRotation=new Vs,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Zi=new V,Us=new V,gf=new V,Os=new V,Lo=new V,Do=new V,v_=new V,_f=new V,xf=new V,yf=new V,vf=new Pt,bf=new Pt,Sf=new Pt,fr=class n{constructor(e=new V,t=new V,i=new V){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Zi.subVectors(e,t),s.cross(Zi);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Zi.subVectors(s,t),Us.subVectors(i,t),gf.subVectors(e,t);let o=Zi.dot(Zi),a=Zi.dot(Us),l=Zi.dot(gf),c=Us.dot(Us),u=Us.dot(gf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Os)===null?!1:Os.x>=0&&Os.y>=0&&Os.x+Os.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Os)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Os.x),l.addScaledVector(o,Os.y),l.addScaledVector(a,Os.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return vf.setScalar(0),bf.setScalar(0),Sf.setScalar(0),vf.fromBufferAttribute(e,t),bf.fromBufferAttribute(e,i),Sf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(vf,r.x),o.addScaledVector(bf,r.y),o.addScaledVector(Sf,r.z),o}static isFrontFacing(e,t,i,s){return Zi.subVectors(i,t),Us.subVectors(e,t),Zi.cross(Us).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Zi.subVectors(this.c,this.b),Us.subVectors(this.a,this.b),Zi.cross(Us).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Lo.subVectors(s,i),Do.subVectors(r,i),_f.subVectors(e,i);let l=Lo.dot(_f),c=Do.dot(_f);if(l<=0&&c<=0)return t.copy(i);xf.subVectors(e,s);let u=Lo.dot(xf),f=Do.dot(xf);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Lo,o);yf.subVectors(e,r);let d=Lo.dot(yf),p=Do.dot(yf);if(p>=0&&d<=p)return t.copy(r);let b=d*c-l*p;if(b<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Do,a);let g=u*p-d*f;if(g<=0&&f-u>=0&&d-p>=0)return v_.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(v_,a);let m=1/(g+b+h);return o=b*m,a=h*m,t.copy(i).addScaledVector(Lo,o).addScaledVector(Do,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Qn=class{constructor(e=new V(1/0,1/0,1/0),t=new V(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Ki.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Ki.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Ki.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Ki):Ki.fromBufferAttribute(r,o),Ki.applyMatrix4(e.matrixWorld),this.expandByPoint(Ki);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Oc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Oc.copy(i.boundingBox)),Oc.applyMatrix4(e.matrixWorld),this.union(Oc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Ki),Ki.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Oa),Fc.subVectors(this.max,Oa),No.subVectors(e.a,Oa),Uo.subVectors(e.b,Oa),Oo.subVectors(e.c,Oa),ur.subVectors(Uo,No),hr.subVectors(Oo,Uo),Hr.subVectors(No,Oo);let t=[0,-ur.z,ur.y,0,-hr.z,hr.y,0,-Hr.z,Hr.y,ur.z,0,-ur.x,hr.z,0,-hr.x,Hr.z,0,-Hr.x,-ur.y,ur.x,0,-hr.y,hr.x,0,-Hr.y,Hr.x,0];return!Mf(t,No,Uo,Oo,Fc)||(t=[1,0,0,0,1,0,0,0,1],!Mf(t,No,Uo,Oo,Fc))?!1:(Bc.crossVectors(ur,hr),t=[Bc.x,Bc.y,Bc.z],Mf(t,No,Uo,Oo,Fc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Ki).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Ki).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Fs[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Fs[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Fs[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Fs[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Fs[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Fs[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Fs[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Fs[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Fs),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Fs=[new V,new V,new V,new V,new V,new V,new V,new V],Ki=new V,Oc=new Qn,No=new V,Uo=new V,Oo=new V,ur=new V,hr=new V,Hr=new V,Oa=new V,Fc=new V,Bc=new V,Gr=new V;function Mf(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Gr.fromArray(n,r);let a=s.x*Math.abs(Gr.x)+s.y*Math.abs(Gr.y)+s.z*Math.abs(Gr.z),l=e.dot(Gr),c=t.dot(Gr),u=i.dot(Gr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var yn=new V,kc=new Ke,MM=0,vn=class extends ji{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:MM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=up,this.updateRanges=[],this.gpuType=ts,this.version=0,this._normalizationScale=e!==void 0?Th(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)kc.fromBufferAttribute(this,t),kc.applyMatrix3(e),this.setXY(t,kc.x,kc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix3(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyMatrix4(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.applyNormalMatrix(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)yn.fromBufferAttribute(this,t),yn.transformDirection(e),this.setXYZ(t,yn.x,yn.y,yn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):pp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):mp(e,this.array)}};var Ka=class extends vn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var ja=class extends vn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var zn=class extends vn{constructor(e,t,i){super(new Float32Array(e),t,i)}},wM=new Qn,Fa=new V,wf=new V,Hn=class{constructor(e=new V,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):wM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Fa.subVectors(e,this.center);let t=Fa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Fa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(wf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Fa.copy(e.center).add(wf)),this.expandByPoint(Fa.copy(e.center).sub(wf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},AM=0,Bi=new St,Af=new Vn,Fo=new V,Ei=new Qn,Ba=new Qn,Bn=new V,bn=class n extends ji{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:AM++}),this.uuid=Tr(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(ZS(e)?ja:Ka)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new ot().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Bi.makeRotationFromQuaternion(e),this.applyMatrix4(Bi),this}rotateX(e){return Bi.makeRotationX(e),this.applyMatrix4(Bi),this}rotateY(e){return Bi.makeRotationY(e),this.applyMatrix4(Bi),this}rotateZ(e){return Bi.makeRotationZ(e),this.applyMatrix4(Bi),this}translate(e,t,i){return Bi.makeTranslation(e,t,i),this.applyMatrix4(Bi),this}scale(e,t,i){return Bi.makeScale(e,t,i),this.applyMatrix4(Bi),this}lookAt(e){return Af.lookAt(e),Af.updateMatrix(),this.applyMatrix4(Af.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Fo).negate(),this.translate(Fo.x,Fo.y,Fo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new zn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&Je("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new V(-1/0,-1/0,-1/0),new V(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ei.setFromBufferAttribute(r),this.morphTargetsRelative?(Bn.addVectors(this.boundingBox.min,Ei.min),this.boundingBox.expandByPoint(Bn),Bn.addVectors(this.boundingBox.max,Ei.max),this.boundingBox.expandByPoint(Bn)):(this.boundingBox.expandByPoint(Ei.min),this.boundingBox.expandByPoint(Ei.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&st('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Hn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){st("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new V,1/0);return}if(e){let i=this.boundingSphere.center;if(Ei.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ba.setFromBufferAttribute(a),this.morphTargetsRelative?(Bn.addVectors(Ei.min,Ba.min),Ei.expandByPoint(Bn),Bn.addVectors(Ei.max,Ba.max),Ei.expandByPoint(Bn)):(Ei.expandByPoint(Ba.min),Ei.expandByPoint(Ba.max))}Ei.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Bn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Bn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Bn.fromBufferAttribute(a,c),l&&(Fo.fromBufferAttribute(e,c),Bn.add(Fo)),s=Math.max(s,i.distanceToSquared(Bn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&st('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){st("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new vn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let k=0;k<i.count;k++)a[k]=new V,l[k]=new V;let u=new V,f=new V,h=new V,d=new Ke,p=new Ke,b=new Ke,g=new V,m=new V;function v(k,U,D){c[k]=c[U]=c[D]=1,u.fromBufferAttribute(i,k),f.fromBufferAttribute(i,U),h.fromBufferAttribute(i,D),d.fromBufferAttribute(r,k),p.fromBufferAttribute(r,U),b.fromBufferAttribute(r,D),f.sub(u),h.sub(u),p.sub(d),b.sub(d);let H=1/(p.x*b.y-b.x*p.y);isFinite(H)&&(g.copy(f).multiplyScalar(b.y).addScaledVector(h,-p.y).multiplyScalar(H),m.copy(h).multiplyScalar(p.x).addScaledVector(f,-b.x).multiplyScalar(H),a[k].add(g),a[U].add(g),a[D].add(g),l[k].add(m),l[U].add(m),l[D].add(m))}let E=this.groups;E.length===0&&(E=[{start:0,count:e.count}]);for(let k=0,U=E.length;k<U;++k){let D=E[k],H=D.start,O=D.count;for(let I=H,W=H+O;I<W;I+=3)v(e.getX(I+0),e.getX(I+1),e.getX(I+2))}let M=new V,L=new V,C=new V,_=new V;function T(k){C.fromBufferAttribute(s,k),_.copy(C);let U=a[k];M.copy(U),M.sub(C.multiplyScalar(C.dot(U))).normalize(),L.crossVectors(_,U);let H=L.dot(l[k])<0?-1:1;o.setXYZW(k,M.x,M.y,M.z,H)}for(let k=0,U=i.count;k<U;++k)c[k]&&T(k);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new vn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new V,r=new V,o=new V,a=new V,l=new V,c=new V,u=new V,f=new V;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),b=e.getX(h+1),g=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,g),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,g),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(g,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Bn.fromBufferAttribute(e,t),Bn.normalize(),e.setXYZ(t,Bn.x,Bn.y,Bn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let b=0,g=l.length;b<g;b++){a.isInterleavedBufferAttribute?d=l[b]*a.data.stride+a.offset:d=l[b]*u;for(let m=0;m<u;m++)h[p++]=c[d++]}return new vn(h,u,f)}if(this.index===null)return Je("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},yu=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=up,this.updateRanges=[],this.version=0,this.uuid=Tr()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=b_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=b_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function b_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Tr()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ai=new V,Qi=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?Th(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)ai.fromBufferAttribute(this,t),ai.applyMatrix4(e),this.setXYZ(t,ai.x,ai.y,ai.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)ai.fromBufferAttribute(this,t),ai.applyNormalMatrix(e),this.setXYZ(t,ai.x,ai.y,ai.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)ai.fromBufferAttribute(this,t),ai.transformDirection(e),this.setXYZ(t,ai.x,ai.y,ai.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){$a("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new vn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){$a("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):pp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):mp(e,this.data.array)}},Tf=new V,TM=new V,EM=new ot,li=class{constructor(e=new V(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=Tf.subVectors(i,t).cross(TM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(Tf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||EM.getNormalMatrix(e),s=this.coplanarPoint(Tf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},CM=0,gs=class extends ji{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:CM++}),this.uuid=Tr(),this.name="",this.type="Material",this.blending=na,this.side=wr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Wf,this.blendDst=Xf,this.blendEquation=Yr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new dt(0,0,0),this.blendAlpha=0,this.depthFunc=pr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=fx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=ru,this.stencilZFail=ru,this.stencilZPass=ru,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){Je(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){Je(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new dt().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new li().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ke().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ke().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Bs=new V,Ef=new V,zc=new V,Vc=new V,mr=class{constructor(e=new V,t=new V(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Bs)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Bs.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Bs.copy(this.origin).addScaledVector(this.direction,t),Bs.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){Ef.copy(e).add(t).multiplyScalar(.5),zc.copy(t).sub(e).normalize(),Vc.copy(this.origin).sub(Ef);let r=e.distanceTo(t)*.5,o=-this.direction.dot(zc),a=Vc.dot(this.direction),l=-Vc.dot(zc),c=Vc.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let b=1/u;f*=b,h*=b,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(Ef).addScaledVector(zc,h),d}intersectSphere(e,t){if(e.radius<0)return null;Bs.subVectors(e.center,this.origin);let i=Bs.dot(this.direction),s=Bs.dot(Bs)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Bs)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,b=t.y-o.y,g=t.z-o.z,m=i.x-o.x,v=i.y-o.y,E=i.z-o.z,M=Math.abs(l),L=Math.abs(c),C=Math.abs(u),_,T,k,U,D,H,O,I,W,$,G,le;if(M>=L&&M>=C?(k=l,H=f,W=p,le=m,l>=0?(_=c,T=u,U=h,D=d,O=b,I=g,$=v,G=E):(_=u,T=c,U=d,D=h,O=g,I=b,$=E,G=v)):L>=C?(k=c,H=h,W=b,le=v,c>=0?(_=u,T=l,U=d,D=f,O=g,I=p,$=E,G=m):(_=l,T=u,U=f,D=d,O=p,I=g,$=m,G=E)):(k=u,H=d,W=g,le=E,u>=0?(_=l,T=c,U=f,D=h,O=p,I=b,$=m,G=v):(_=c,T=l,U=h,D=f,O=b,I=p,$=v,G=m)),k===0)return null;let Z=_/k,Q=T/k,ie=1/k,de=U-Z*H,he=D-Q*H,ee=O-Z*W,ge=I-Q*W,_e=$-Z*le,Re=G-Q*le,ve=_e*ge-Re*ee,We=de*Re-he*_e,me=ee*he-ge*de;if(s){if(ve<0||We<0||me<0)return null}else if((ve<0||We<0||me<0)&&(ve>0||We>0||me>0))return null;let be=ve+We+me;if(be===0)return null;let je=ie*(ve*H+We*W+me*le);return(be>0?je<0:je>0)?null:this.at(je/be,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Jo=class extends gs{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new dt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Vs,this.combine=ku,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},S_=new St,Wr=new mr,Hc=new Hn,M_=new V,Gc=new V,Wc=new V,Xc=new V,Cf=new V,qc=new V,w_=new V,$c=new V,Gn=class extends Vn{constructor(e=new bn,t=new Jo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){qc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(Cf.fromBufferAttribute(f,e),o?qc.addScaledVector(Cf,u):qc.addScaledVector(Cf.sub(t),u))}t.add(qc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Hc.copy(i.boundingSphere),Hc.applyMatrix4(r),Wr.copy(e.ray).recast(e.near),!(Hc.containsPoint(Wr.origin)===!1&&(Wr.intersectSphere(Hc,M_)===null||Wr.origin.distanceToSquared(M_)>(e.far-e.near)**2))&&(S_.copy(r).invert(),Wr.copy(e.ray).applyMatrix4(S_),!(i.boundingBox!==null&&Wr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Wr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let g=h[p],m=o[g.materialIndex],v=Math.max(g.start,d.start),E=Math.min(a.count,Math.min(g.start+g.count,d.start+d.count));for(let M=v,L=E;M<L;M+=3){let C=a.getX(M),_=a.getX(M+1),T=a.getX(M+2);s=Yc(this,m,e,i,c,u,f,C,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(a.count,d.start+d.count);for(let g=p,m=b;g<m;g+=3){let v=a.getX(g),E=a.getX(g+1),M=a.getX(g+2);s=Yc(this,o,e,i,c,u,f,v,E,M),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let g=h[p],m=o[g.materialIndex],v=Math.max(g.start,d.start),E=Math.min(l.count,Math.min(g.start+g.count,d.start+d.count));for(let M=v,L=E;M<L;M+=3){let C=M,_=M+1,T=M+2;s=Yc(this,m,e,i,c,u,f,C,_,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=g.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let g=p,m=b;g<m;g+=3){let v=g,E=g+1,M=g+2;s=Yc(this,o,e,i,c,u,f,v,E,M),s&&(s.faceIndex=Math.floor(g/3),t.push(s))}}}};function RM(n,e,t,i,s,r,o,a){let l;if(e.side===hi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===wr,a),l===null)return null;$c.copy(a),$c.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo($c);return c<t.near||c>t.far?null:{distance:c,point:$c.clone(),object:n}}function Yc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,Gc),n.getVertexPosition(l,Wc),n.getVertexPosition(c,Xc);let u=RM(n,e,t,i,Gc,Wc,Xc,w_);if(u){let f=new V;fr.getBarycoord(w_,Gc,Wc,Xc,f),s&&(u.uv=fr.getInterpolatedAttribute(s,a,l,c,f,new Ke)),r&&(u.uv1=fr.getInterpolatedAttribute(r,a,l,c,f,new Ke)),o&&(u.normal=fr.getInterpolatedAttribute(o,a,l,c,f,new V),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new V,materialIndex:0};fr.getNormal(Gc,Wc,Xc,h.normal),u.face=h,u.barycoord=f}return u}var Zo=class extends mi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=cn,u=cn,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Xr=new Hn,PM=new Ke(.5,.5),Jc=new V,gr=class{constructor(e=new li,t=new li,i=new li,s=new li,r=new li,o=new li){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=ki,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],b=r[9],g=r[10],m=r[11],v=r[12],E=r[13],M=r[14],L=r[15];if(s[0].setComponents(c-o,d-u,m-p,L-v).normalize(),s[1].setComponents(c+o,d+u,m+p,L+v).normalize(),s[2].setComponents(c+a,d+f,m+b,L+E).normalize(),s[3].setComponents(c-a,d-f,m-b,L-E).normalize(),i)s[4].setComponents(l,h,g,M).normalize(),s[5].setComponents(c-l,d-h,m-g,L-M).normalize();else if(s[4].setComponents(c-l,d-h,m-g,L-M).normalize(),t===ki)s[5].setComponents(c+l,d+h,m+g,L+M).normalize();else if(t===Wo)s[5].setComponents(l,h,g,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Xr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Xr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Xr)}intersectsSprite(e){Xr.center.set(0,0,0);let t=PM.distanceTo(e.center);return Xr.radius=.7071067811865476+t,Xr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Xr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Jc.x=s.normal.x>0?e.max.x:e.min.x,Jc.y=s.normal.y>0?e.max.y:e.min.y,Jc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Jc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},A_=new St,vu=class n{constructor(){this.coordinateSystem=ki,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];A_.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new gr),i[s].setFromProjectionMatrix(A_,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new gr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var _r=class extends gs{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new dt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},bu=new V,Su=new V,T_=new St,ka=new mr,Zc=new Hn,Rf=new V,E_=new V,Mu=class extends Vn{constructor(e=new bn,t=new _r){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)bu.fromBufferAttribute(t,s-1),Su.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=bu.distanceTo(Su);e.setAttribute("lineDistance",new zn(i,1))}else Je("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),Zc.copy(i.boundingSphere),Zc.applyMatrix4(s),Zc.radius+=r,e.ray.intersectsSphere(Zc)===!1)return;T_.copy(s).invert(),ka.copy(e.ray).applyMatrix4(T_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let b=d,g=p-1;b<g;b+=c){let m=u.getX(b),v=u.getX(b+1),E=Kc(this,e,ka,l,m,v,b);E&&t.push(E)}if(this.isLineLoop){let b=u.getX(p-1),g=u.getX(d),m=Kc(this,e,ka,l,b,g,p-1);m&&t.push(m)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let b=d,g=p-1;b<g;b+=c){let m=Kc(this,e,ka,l,b,b+1,b);m&&t.push(m)}if(this.isLineLoop){let b=Kc(this,e,ka,l,p-1,d,p-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Kc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(bu.fromBufferAttribute(a,s),Su.fromBufferAttribute(a,r),t.distanceSqToSegment(bu,Su,Rf,E_)>i)return;Rf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Rf);if(!(c<e.near||c>e.far))return{distance:c,point:E_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var C_=new V,R_=new V,qr=class extends Mu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)C_.fromBufferAttribute(t,s),R_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+C_.distanceTo(R_);e.setAttribute("lineDistance",new zn(i,1))}else Je("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Ko=class extends gs{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new dt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},P_=new St,Of=new mr,jc=new Hn,Qc=new V,Qa=class extends Vn{constructor(e=new bn,t=new Ko){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),jc.copy(i.boundingSphere),jc.applyMatrix4(s),jc.radius+=r,e.ray.intersectsSphere(jc)===!1)return;P_.copy(s).invert(),Of.copy(e.ray).applyMatrix4(P_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,f=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let p=h,b=d;p<b;p++){let g=c.getX(p);Qc.fromBufferAttribute(f,g),I_(Qc,g,l,s,e,t,this)}}else{let h=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let p=h,b=d;p<b;p++)Qc.fromBufferAttribute(f,p),I_(Qc,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function I_(n,e,t,i,s,r,o){let a=Of.distanceSqToPoint(n);if(a<t){let l=new V;Of.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var el=class extends mi{constructor(e=[],t=Jr,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var Hs=class extends mi{constructor(e,t,i=es,s,r,o,a=cn,l=cn,c,u=zs,f=1){if(u!==zs&&u!==Ws)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new $o(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},tl=class extends Hs{constructor(e,t=es,i=Jr,s,r,o=cn,a=cn,l,c=zs){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},nl=class extends mi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},jo=class n extends bn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new zn(c,3)),this.setAttribute("normal",new zn(u,3)),this.setAttribute("uv",new zn(f,2));function p(b,g,m,v,E,M,L,C,_,T,k){let U=M/_,D=L/T,H=M/2,O=L/2,I=C/2,W=_+1,$=T+1,G=0,le=0,Z=new V;for(let Q=0;Q<$;Q++){let ie=Q*D-O;for(let de=0;de<W;de++){let he=de*U-H;Z[b]=he*v,Z[g]=ie*E,Z[m]=I,c.push(Z.x,Z.y,Z.z),Z[b]=0,Z[g]=0,Z[m]=C>0?1:-1,u.push(Z.x,Z.y,Z.z),f.push(de/_),f.push(1-Q/T),G+=1}}for(let Q=0;Q<T;Q++)for(let ie=0;ie<_;ie++){let de=h+ie+W*Q,he=h+ie+W*(Q+1),ee=h+(ie+1)+W*(Q+1),ge=h+(ie+1)+W*Q;l.push(de,he,ge),l.push(he,ee,ge),le+=6}a.addGroup(d,le,k),d+=le,h+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var il=class n extends bn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],b=[],g=[];for(let m=0;m<u;m++){let v=m*h-o;for(let E=0;E<c;E++){let M=E*f-r;p.push(M,-v,0),b.push(0,0,1),g.push(E/a),g.push(1-m/l)}}for(let m=0;m<l;m++)for(let v=0;v<a;v++){let E=v+c*m,M=v+c*(m+1),L=v+1+c*(m+1),C=v+1+c*m;d.push(E,M,C),d.push(M,L,C)}this.setIndex(d),this.setAttribute("position",new zn(p,3)),this.setAttribute("normal",new zn(b,3)),this.setAttribute("uv",new zn(g,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var sl=class extends bn{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new V,r=new V;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let f=l[c],h=f.start,d=f.count;for(let p=h,b=h+d;p<b;p+=3)for(let g=0;g<3;g++){let m=a.getX(p+g),v=a.getX(p+(g+1)%3);s.fromBufferAttribute(o,m),r.fromBufferAttribute(o,v),L_(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,f=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,f),L_(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new zn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function L_(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function Kr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(D_(s))s.isRenderTargetTexture?(Je("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(D_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function ei(n){let e={};for(let t=0;t<n.length;t++){let i=Kr(n[t]);for(let s in i)e[s]=i[s]}return e}function D_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function IM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function gp(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var wl={clone:Kr,merge:ei},LM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,DM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,zi=class extends gs{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=LM,this.fragmentShader=DM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Kr(e.uniforms),this.uniformsGroups=IM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new dt().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ke().fromArray(s.value);break;case"v3":this.uniforms[i].value=new V().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Pt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new ot().fromArray(s.value);break;case"m4":this.uniforms[i].value=new St().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},wu=class extends zi{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var rl=class extends gs{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new dt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new dt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=Ah,this.normalScale=new Ke(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Vs,this.combine=ku,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},Au=class extends gs{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=hx,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Tu=class extends gs{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Bo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function eu(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var xr=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Eu=class extends xr{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Df,endingEnd:Df}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Nf:r=e,a=2*t-i;break;case Uf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Nf:o=e,l=2*i-t;break;case Uf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),b=p*p,g=b*p,m=-h*g+2*h*b-h*p,v=(1+h)*g+(-1.5-2*h)*b+(-.5+h)*p+1,E=(-1-d)*g+(1.5+d)*b+.5*p,M=d*g-d*b;for(let L=0;L!==a;++L)r[L]=m*o[u+L]+v*o[c+L]+E*o[l+L]+M*o[f+L];return r}},Cu=class extends xr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Ru=class extends xr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Pu=class extends xr{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),b=1-p;for(let g=0;g!==a;++g)r[g]=o[c+g]*b+o[l+g]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let b=o[c+p],g=o[l+p],m=d*h+p*2,v=f[m],E=f[m+1],M=e*h+p*2,L=u[M],C=u[M+1],_=UM(i,t,v,L,s);r[p]=wx(_,b,E,C,g)}return r}};function wx(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function NM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function UM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=wx(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=NM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Pi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Bo(t,this.TimeBufferType),this.values=Bo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Bo(e.times,Array),values:Bo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),eu(e.settings)&&(i.settings={inTangents:Bo(e.settings.inTangents,Array),outTangents:Bo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Ru(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new Cu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Eu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Pu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ga:t=this.InterpolantFactoryMethodDiscrete;break;case mu:t=this.InterpolantFactoryMethodLinear;break;case su:t=this.InterpolantFactoryMethodSmooth;break;case Lf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return Je("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ga;case this.InterpolantFactoryMethodLinear:return mu;case this.InterpolantFactoryMethodSmooth:return su;case this.InterpolantFactoryMethodBezier:return Lf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;eu(this.settings)&&(N_(this.settings.inTangents,e),N_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;eu(this.settings)&&(U_(this.settings.inTangents,e),U_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(st("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(st("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){st("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){st("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&KS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){st("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===su,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let b=t[f+p];if(b!==t[h+p]||b!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,eu(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function N_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function U_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Pi.prototype.ValueTypeName="";Pi.prototype.TimeBufferType=Float32Array;Pi.prototype.ValueBufferType=Float32Array;Pi.prototype.DefaultInterpolation=mu;var yr=class extends Pi{constructor(e,t,i){super(e,t,i)}};yr.prototype.ValueTypeName="bool";yr.prototype.ValueBufferType=Array;yr.prototype.DefaultInterpolation=Ga;yr.prototype.InterpolantFactoryMethodLinear=void 0;yr.prototype.InterpolantFactoryMethodSmooth=void 0;var Iu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Iu.prototype.ValueTypeName="color";var Lu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Lu.prototype.ValueTypeName="number";var Du=class extends xr{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ci.slerpFlat(r,0,o,c-a,o,c,l);return r}},ol=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Du(this.times,this.values,this.getValueSize(),e)}};ol.prototype.ValueTypeName="quaternion";ol.prototype.InterpolantFactoryMethodSmooth=void 0;var vr=class extends Pi{constructor(e,t,i){super(e,t,i)}};vr.prototype.ValueTypeName="string";vr.prototype.ValueBufferType=Array;vr.prototype.DefaultInterpolation=Ga;vr.prototype.InterpolantFactoryMethodLinear=void 0;vr.prototype.InterpolantFactoryMethodSmooth=void 0;var Nu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Nu.prototype.ValueTypeName="vector";var Uu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Ax=new Uu,Ou=class{constructor(e){this.manager=e!==void 0?e:Ax,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Ou.DEFAULT_MATERIAL_NAME="__DEFAULT";var al=class extends Vn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new dt(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ll=class extends al{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new dt(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},Pf=new St,O_=new V,F_=new V,Fu=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ke(512,512),this.mapType=_i,this.map=null,this.mapPass=null,this.matrix=new St,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new gr,this._frameExtents=new Ke(1,1),this._viewportCount=1,this._viewports=[new Pt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;O_.setFromMatrixPosition(e.matrixWorld),t.position.copy(O_),F_.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(F_),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){Pf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(Pf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Wo||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(Pf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},tu=new V,nu=new Ci,ps=new V,cl=class extends Vn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new St,this.projectionMatrix=new St,this.projectionMatrixInverse=new St,this.coordinateSystem=ki,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(tu,nu,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tu,nu,ps.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(tu,nu,ps),ps.x===1&&ps.y===1&&ps.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(tu,nu,ps.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},dr=new V,B_=new Ke,k_=new Ke,ci=class extends cl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=qo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Va*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return qo*2*Math.atan(Math.tan(Va*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){dr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(dr.x,dr.y).multiplyScalar(-e/dr.z),dr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(dr.x,dr.y).multiplyScalar(-e/dr.z)}getViewSize(e,t){return this.getViewBounds(e,B_,k_),t.subVectors(k_,B_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Va*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ul=class extends cl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},Ff=class extends Fu{constructor(){super(new ul(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},hl=class extends al{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(Vn.DEFAULT_UP),this.updateMatrix(),this.target=new Vn,this.shadow=new Ff}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var dl=class extends bn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var ko=-90,zo=1,Qo=class extends Vn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ci(ko,zo,e,t);s.layers=this.layers,this.add(s);let r=new ci(ko,zo,e,t);r.layers=this.layers,this.add(r);let o=new ci(ko,zo,e,t);o.layers=this.layers,this.add(o);let a=new ci(ko,zo,e,t);a.layers=this.layers,this.add(a);let l=new ci(ko,zo,e,t);l.layers=this.layers,this.add(l);let c=new ci(ko,zo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===ki)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Wo)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let g=!1;e.isWebGLRenderer===!0?g=e.state.buffers.depth.getReversed():g=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,s),g&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Bu=class extends ci{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var _p="\\[\\]\\.:\\/",OM=new RegExp("["+_p+"]","g"),xp="[^"+_p+"]",FM="[^"+_p.replace("\\.","")+"]",BM=/((?:WC+[\/:])*)/.source.replace("WC",xp),kM=/(WCOD+)?/.source.replace("WCOD",FM),zM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",xp),VM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",xp),HM=new RegExp("^"+BM+kM+zM+VM+"$"),GM=["material","materials","bones","map"],Bf=class{constructor(e,t,i){let s=i||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(OM,"")}static parseTrackName(e){let t=HM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);GM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){Je("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){st("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){st("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){st("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){st("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){st("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){st("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;st("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){st("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=Bf;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var N2=new Float32Array(1);var br=class extends yu{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var ea=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=ut(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(ut(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var kf=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var z_=new V,iu=new V,Vo=new V,Ho=new V,If=new V,WM=new V,XM=new V,fl=class{constructor(e=new V,t=new V){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){z_.subVectors(e,this.start),iu.subVectors(this.end,this.start);let i=iu.dot(iu);if(i===0)return 0;let r=iu.dot(z_)/i;return t&&(r=ut(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=WM,i=XM){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;Vo.subVectors(c,a),Ho.subVectors(u,l),If.subVectors(a,l);let f=Vo.dot(Vo),h=Ho.dot(Ho),d=Ho.dot(If);if(f<=s&&h<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(f<=s)r=0,o=d/h,o=ut(o,0,1);else{let p=Vo.dot(If);if(h<=s)o=0,r=ut(-p/f,0,1);else{let b=Vo.dot(Ho),g=f*h-b*b;g!==0?r=ut((b*d-p*h)/g,0,1):r=0,o=(b*r+d)/h,o<0?(o=0,r=ut(-p/f,0,1)):o>1&&(o=1,r=ut((b-p)/f,0,1))}}return t.copy(a).addScaledVector(Vo,r),i.copy(l).addScaledVector(Ho,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var pl=class extends ji{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function yp(n,e,t,i){let s=qM(i);switch(t){case sp:return n*e;case op:return n*e/s.components*s.byteLength;case qu:return n*e/s.components*s.byteLength;case Ar:return n*e*2/s.components*s.byteLength;case $u:return n*e*2/s.components*s.byteLength;case rp:return n*e*3/s.components*s.byteLength;case Ii:return n*e*4/s.components*s.byteLength;case Yu:return n*e*4/s.components*s.byteLength;case _l:case xl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case yl:case vl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case Zu:case ju:return Math.max(n,16)*Math.max(e,8)/4;case Ju:case Ku:return Math.max(n,8)*Math.max(e,8)/2;case Qu:case eh:case nh:case ih:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case th:case bl:case sh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case rh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case oh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ah:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case lh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case ch:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case uh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case hh:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case dh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case fh:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case ph:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case mh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case gh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case _h:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case xh:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case yh:case vh:case bh:return Math.ceil(n/4)*Math.ceil(e/4)*16;case Sh:case Mh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Sl:case wh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function qM(n){switch(n){case _i:case ep:return{byteLength:1,components:1};case sa:case tp:case ns:return{byteLength:2,components:1};case Wu:case Xu:return{byteLength:2,components:4};case es:case Gu:case ts:return{byteLength:4,components:1};case np:case ip:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?Je("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function $x(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function YM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],b=f[d];b.start<=p.start+p.count+1?p.count=Math.max(p.count,b.start+b.count-p.start):(++h,f[h]=b)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let b=f[d];n.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var JM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,ZM=`#ifdef USE_ALPHAHASH
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
#endif`,KM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,jM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,QM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,ew=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,tw=`#ifdef USE_AOMAP
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
#endif`,nw=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,iw=`#ifdef USE_BATCHING
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
#endif`,sw=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,rw=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ow=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,aw=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,lw=`#ifdef USE_IRIDESCENCE
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
#endif`,cw=`#ifdef USE_BUMPMAP
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
#endif`,uw=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,hw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,dw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,fw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,pw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,mw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,gw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,_w=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,xw=`#define PI 3.141592653589793
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
} // validated`,yw=`vec3 transformedNormal = objectNormal;
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
#endif`,vw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,bw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Sw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Mw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,ww="gl_FragColor = linearToOutputTexel( gl_FragColor );",Aw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Tw=`#ifdef USE_ENVMAP
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
#endif`,Ew=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Cw=`#ifdef USE_ENVMAP
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
#endif`,Rw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Pw=`#ifdef USE_ENVMAP
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
#endif`,Iw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Lw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Dw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Nw=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Uw=`#ifdef USE_GRADIENTMAP
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
}`,Ow=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Fw=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Bw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,kw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,zw=`#ifdef USE_ENVMAP
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
#endif`,Vw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Hw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Gw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Ww=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Xw=`PhysicalMaterial material;
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
#endif`,qw=`uniform sampler2D dfgLUT;
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
}`,$w=`
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
#endif`,Yw=`#if defined( RE_IndirectDiffuse )
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
#endif`,Jw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,Zw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Kw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,jw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Qw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,e1=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,t1=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,n1=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,i1=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,s1=`#if defined( USE_POINTS_UV )
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
#endif`,r1=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,o1=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,a1=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,l1=`#if defined( USE_MORPHCOLORS )
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
#endif`,c1=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,u1=`#ifdef USE_MORPHTARGETS
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
#endif`,h1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,d1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,f1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,p1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,m1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,g1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,_1=`#ifdef USE_NORMALMAP
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
#endif`,x1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,y1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,v1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,b1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,S1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,M1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,w1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,A1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,T1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,E1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,C1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,R1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,P1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,I1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,L1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,D1=`float getShadowMask() {
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
}`,N1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,U1=`#ifdef USE_SKINNING
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
#endif`,O1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,F1=`#ifdef USE_SKINNING
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
#endif`,B1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,k1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,z1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,V1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,H1=`#ifdef USE_TRANSMISSION
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
#endif`,G1=`#ifdef USE_TRANSMISSION
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
#endif`,W1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,X1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,q1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,$1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,Y1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,J1=`uniform sampler2D t2D;
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
}`,Z1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,K1=`uniform float backgroundBlurriness;
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
}`,j1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,Q1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,eA=`#include <common>
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
}`,tA=`#if DEPTH_PACKING == 3200
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
}`,nA=`#define DISTANCE
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
}`,iA=`#define DISTANCE
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
}`,sA=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,rA=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,oA=`uniform float scale;
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
}`,aA=`uniform vec3 diffuse;
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
}`,lA=`#include <common>
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
}`,cA=`uniform vec3 diffuse;
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
}`,uA=`#define LAMBERT
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
}`,hA=`#define LAMBERT
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
}`,dA=`#define MATCAP
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
}`,fA=`#define MATCAP
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
}`,pA=`#define NORMAL
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
}`,mA=`#define NORMAL
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
}`,gA=`#define PHONG
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
}`,_A=`#define PHONG
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
}`,xA=`#define STANDARD
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
}`,yA=`#define STANDARD
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
}`,vA=`#define TOON
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
}`,bA=`#define TOON
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
}`,SA=`uniform float size;
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
}`,MA=`uniform vec3 diffuse;
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
}`,wA=`#include <common>
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
}`,AA=`uniform vec3 color;
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
}`,TA=`uniform float rotation;
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
}`,EA=`uniform vec3 diffuse;
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
}`,pt={alphahash_fragment:JM,alphahash_pars_fragment:ZM,alphamap_fragment:KM,alphamap_pars_fragment:jM,alphatest_fragment:QM,alphatest_pars_fragment:ew,aomap_fragment:tw,aomap_pars_fragment:nw,batching_pars_vertex:iw,batching_vertex:sw,begin_vertex:rw,beginnormal_vertex:ow,bsdfs:aw,iridescence_fragment:lw,bumpmap_pars_fragment:cw,clipping_planes_fragment:uw,clipping_planes_pars_fragment:hw,clipping_planes_pars_vertex:dw,clipping_planes_vertex:fw,color_fragment:pw,color_pars_fragment:mw,color_pars_vertex:gw,color_vertex:_w,common:xw,defaultnormal_vertex:yw,displacementmap_pars_vertex:vw,displacementmap_vertex:bw,emissivemap_fragment:Sw,emissivemap_pars_fragment:Mw,colorspace_fragment:ww,colorspace_pars_fragment:Aw,envmap_fragment:Tw,envmap_common_pars_fragment:Ew,envmap_pars_fragment:Cw,envmap_pars_vertex:Rw,envmap_physical_pars_fragment:zw,envmap_vertex:Pw,fog_vertex:Iw,fog_pars_vertex:Lw,fog_fragment:Dw,fog_pars_fragment:Nw,gradientmap_pars_fragment:Uw,lightmap_pars_fragment:Ow,lights_lambert_fragment:Fw,lights_lambert_pars_fragment:Bw,lights_pars_begin:kw,lights_toon_fragment:Vw,lights_toon_pars_fragment:Hw,lights_phong_fragment:Gw,lights_phong_pars_fragment:Ww,lights_physical_fragment:Xw,lights_physical_pars_fragment:qw,lights_fragment_begin:$w,lights_fragment_maps:Yw,lights_fragment_end:Jw,lightprobes_pars_fragment:Zw,logdepthbuf_fragment:Kw,logdepthbuf_pars_fragment:jw,logdepthbuf_pars_vertex:Qw,logdepthbuf_vertex:e1,map_fragment:t1,map_pars_fragment:n1,map_particle_fragment:i1,map_particle_pars_fragment:s1,metalnessmap_fragment:r1,metalnessmap_pars_fragment:o1,morphinstance_vertex:a1,morphcolor_vertex:l1,morphnormal_vertex:c1,morphtarget_pars_vertex:u1,morphtarget_vertex:h1,normal_fragment_begin:d1,normal_fragment_maps:f1,normal_pars_fragment:p1,normal_pars_vertex:m1,normal_vertex:g1,normalmap_pars_fragment:_1,clearcoat_normal_fragment_begin:x1,clearcoat_normal_fragment_maps:y1,clearcoat_pars_fragment:v1,iridescence_pars_fragment:b1,opaque_fragment:S1,packing:M1,premultiplied_alpha_fragment:w1,project_vertex:A1,dithering_fragment:T1,dithering_pars_fragment:E1,roughnessmap_fragment:C1,roughnessmap_pars_fragment:R1,shadowmap_pars_fragment:P1,shadowmap_pars_vertex:I1,shadowmap_vertex:L1,shadowmask_pars_fragment:D1,skinbase_vertex:N1,skinning_pars_vertex:U1,skinning_vertex:O1,skinnormal_vertex:F1,specularmap_fragment:B1,specularmap_pars_fragment:k1,tonemapping_fragment:z1,tonemapping_pars_fragment:V1,transmission_fragment:H1,transmission_pars_fragment:G1,uv_pars_fragment:W1,uv_pars_vertex:X1,uv_vertex:q1,worldpos_vertex:$1,background_vert:Y1,background_frag:J1,backgroundCube_vert:Z1,backgroundCube_frag:K1,cube_vert:j1,cube_frag:Q1,depth_vert:eA,depth_frag:tA,distance_vert:nA,distance_frag:iA,equirect_vert:sA,equirect_frag:rA,linedashed_vert:oA,linedashed_frag:aA,meshbasic_vert:lA,meshbasic_frag:cA,meshlambert_vert:uA,meshlambert_frag:hA,meshmatcap_vert:dA,meshmatcap_frag:fA,meshnormal_vert:pA,meshnormal_frag:mA,meshphong_vert:gA,meshphong_frag:_A,meshphysical_vert:xA,meshphysical_frag:yA,meshtoon_vert:vA,meshtoon_frag:bA,points_vert:SA,points_frag:MA,shadow_vert:wA,shadow_frag:AA,sprite_vert:TA,sprite_frag:EA},Le={common:{diffuse:{value:new dt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new ot}},envmap:{envMap:{value:null},envMapRotation:{value:new ot},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new ot},normalScale:{value:new Ke(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new dt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new dt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0},uvTransform:{value:new ot}},sprite:{diffuse:{value:new dt(16777215)},opacity:{value:1},center:{value:new Ke(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new ot},alphaMap:{value:null},alphaMapTransform:{value:new ot},alphaTest:{value:0}}},di={basic:{uniforms:ei([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.fog]),vertexShader:pt.meshbasic_vert,fragmentShader:pt.meshbasic_frag},lambert:{uniforms:ei([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new dt(0)},envMapIntensity:{value:1}}]),vertexShader:pt.meshlambert_vert,fragmentShader:pt.meshlambert_frag},phong:{uniforms:ei([Le.common,Le.specularmap,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,Le.lights,{emissive:{value:new dt(0)},specular:{value:new dt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:pt.meshphong_vert,fragmentShader:pt.meshphong_frag},standard:{uniforms:ei([Le.common,Le.envmap,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.roughnessmap,Le.metalnessmap,Le.fog,Le.lights,{emissive:{value:new dt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag},toon:{uniforms:ei([Le.common,Le.aomap,Le.lightmap,Le.emissivemap,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.gradientmap,Le.fog,Le.lights,{emissive:{value:new dt(0)}}]),vertexShader:pt.meshtoon_vert,fragmentShader:pt.meshtoon_frag},matcap:{uniforms:ei([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,Le.fog,{matcap:{value:null}}]),vertexShader:pt.meshmatcap_vert,fragmentShader:pt.meshmatcap_frag},points:{uniforms:ei([Le.points,Le.fog]),vertexShader:pt.points_vert,fragmentShader:pt.points_frag},dashed:{uniforms:ei([Le.common,Le.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:pt.linedashed_vert,fragmentShader:pt.linedashed_frag},depth:{uniforms:ei([Le.common,Le.displacementmap]),vertexShader:pt.depth_vert,fragmentShader:pt.depth_frag},normal:{uniforms:ei([Le.common,Le.bumpmap,Le.normalmap,Le.displacementmap,{opacity:{value:1}}]),vertexShader:pt.meshnormal_vert,fragmentShader:pt.meshnormal_frag},sprite:{uniforms:ei([Le.sprite,Le.fog]),vertexShader:pt.sprite_vert,fragmentShader:pt.sprite_frag},background:{uniforms:{uvTransform:{value:new ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:pt.background_vert,fragmentShader:pt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new ot}},vertexShader:pt.backgroundCube_vert,fragmentShader:pt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:pt.cube_vert,fragmentShader:pt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:pt.equirect_vert,fragmentShader:pt.equirect_frag},distance:{uniforms:ei([Le.common,Le.displacementmap,{referencePosition:{value:new V},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:pt.distance_vert,fragmentShader:pt.distance_frag},shadow:{uniforms:ei([Le.lights,Le.fog,{color:{value:new dt(0)},opacity:{value:1}}]),vertexShader:pt.shadow_vert,fragmentShader:pt.shadow_frag}};di.physical={uniforms:ei([di.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new ot},clearcoatNormalScale:{value:new Ke(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new ot},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new ot},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new ot},sheen:{value:0},sheenColor:{value:new dt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new ot},transmissionSamplerSize:{value:new Ke},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new ot},attenuationDistance:{value:0},attenuationColor:{value:new dt(0)},specularColor:{value:new dt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new ot},anisotropyVector:{value:new Ke},anisotropyMap:{value:null},anisotropyMapTransform:{value:new ot}}]),vertexShader:pt.meshphysical_vert,fragmentShader:pt.meshphysical_frag};var Eh={r:0,b:0,g:0},CA=new St,Yx=new ot;Yx.set(-1,0,0,0,1,0,0,0,1);function RA(n,e,t,i,s,r){let o=new dt(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(v){let E=v.isScene===!0?v.background:null;if(E&&E.isTexture){let M=v.backgroundBlurriness>0;E=e.get(E,M)}return E}function p(v){let E=!1,M=d(v);M===null?g(o,a):M&&M.isColor&&(g(M,1),E=!0);let L=n.xr.getEnvironmentBlendMode();L==="additive"?t.buffers.color.setClear(0,0,0,1,r):L==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||E)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(v,E){let M=d(E);M&&M.isCubeTexture?(c===void 0&&(c=new Gn(new jo(1,1,1),new zi({name:"BackgroundCubeMaterial",uniforms:Kr(di.backgroundCube.uniforms),vertexShader:di.backgroundCube.vertexShader,fragmentShader:di.backgroundCube.fragmentShader,side:hi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(L,C,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=E.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(CA.makeRotationFromEuler(E.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(Yx),c.material.toneMapped=vt.getTransfer(M.colorSpace)!==Rt,(u!==M||f!==M.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=M,f=M.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Gn(new il(2,2),new zi({name:"BackgroundMaterial",uniforms:Kr(di.background.uniforms),vertexShader:di.background.vertexShader,fragmentShader:di.background.fragmentShader,side:wr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=E.backgroundIntensity,l.material.toneMapped=vt.getTransfer(M.colorSpace)!==Rt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||f!==M.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=M,f=M.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function g(v,E){v.getRGB(Eh,gp(n)),t.buffers.color.setClear(Eh.r,Eh.g,Eh.b,E,r)}function m(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,E=1){o.set(v),a=E,g(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,g(o,a)},render:p,addToRenderList:b,dispose:m}}function PA(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(D,H,O,I,W){let $=!1,G=f(D,I,O,H);r!==G&&(r=G,c(r.object)),$=d(D,I,O,W),$&&p(D,I,O,W),W!==null&&e.update(W,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,M(D,H,O,I),W!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(W).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function f(D,H,O,I){let W=I.wireframe===!0,$=i[H.id];$===void 0&&($={},i[H.id]=$);let G=D.isInstancedMesh===!0?D.id:0,le=$[G];le===void 0&&(le={},$[G]=le);let Z=le[O.id];Z===void 0&&(Z={},le[O.id]=Z);let Q=Z[W];return Q===void 0&&(Q=h(l()),Z[W]=Q),Q}function h(D){let H=[],O=[],I=[];for(let W=0;W<t;W++)H[W]=0,O[W]=0,I[W]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:O,attributeDivisors:I,object:D,attributes:{},index:null}}function d(D,H,O,I){let W=r.attributes,$=H.attributes,G=0,le=O.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=W[Z],de=$[Z];if(de===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(de=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(de=D.instanceColor)),ie===void 0||ie.attribute!==de||de&&ie.data!==de.data)return!0;G++}return r.attributesNum!==G||r.index!==I}function p(D,H,O,I){let W={},$=H.attributes,G=0,le=O.getAttributes();for(let Z in le)if(le[Z].location>=0){let ie=$[Z];ie===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let de={};de.attribute=ie,ie&&ie.data&&(de.data=ie.data),W[Z]=de,G++}r.attributes=W,r.attributesNum=G,r.index=I}function b(){let D=r.newAttributes;for(let H=0,O=D.length;H<O;H++)D[H]=0}function g(D){m(D,0)}function m(D,H){let O=r.newAttributes,I=r.enabledAttributes,W=r.attributeDivisors;O[D]=1,I[D]===0&&(n.enableVertexAttribArray(D),I[D]=1),W[D]!==H&&(n.vertexAttribDivisor(D,H),W[D]=H)}function v(){let D=r.newAttributes,H=r.enabledAttributes;for(let O=0,I=H.length;O<I;O++)H[O]!==D[O]&&(n.disableVertexAttribArray(O),H[O]=0)}function E(D,H,O,I,W,$,G){G===!0?n.vertexAttribIPointer(D,H,O,W,$):n.vertexAttribPointer(D,H,O,I,W,$)}function M(D,H,O,I){b();let W=I.attributes,$=O.getAttributes(),G=H.defaultAttributeValues;for(let le in $){let Z=$[le];if(Z.location>=0){let Q=W[le];if(Q===void 0&&(le==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),le==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ie=Q.normalized,de=Q.itemSize,he=e.get(Q);if(he===void 0)continue;let ee=he.buffer,ge=he.type,_e=he.bytesPerElement,Re=ge===n.INT||ge===n.UNSIGNED_INT||Q.gpuType===Gu;if(Q.isInterleavedBufferAttribute){let ve=Q.data,We=ve.isInterleavedBuffer===!0?ve.stride:ve.itemSize,me=Q.offset;if(ve.isInstancedInterleavedBuffer||ve.isInstancedBufferAttribute){for(let be=0;be<Z.locationSize;be++)m(Z.location+be,ve.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=ve.meshPerAttribute*ve.count)}else for(let be=0;be<Z.locationSize;be++)g(Z.location+be);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let be=0;be<Z.locationSize;be++)E(Z.location+be,de/Z.locationSize,ge,ie,We*_e,(me+de/Z.locationSize*be)*_e,Re)}else{if(Q.isInstancedBufferAttribute){for(let ve=0;ve<Z.locationSize;ve++)m(Z.location+ve,Q.meshPerAttribute);D.isInstancedMesh!==!0&&I._maxInstanceCount===void 0&&(I._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ve=0;ve<Z.locationSize;ve++)g(Z.location+ve);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let ve=0;ve<Z.locationSize;ve++)E(Z.location+ve,de/Z.locationSize,ge,ie,de*_e,de/Z.locationSize*ve*_e,Re)}}else if(G!==void 0){let ie=G[le];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Z.location,ie);break;case 3:n.vertexAttrib3fv(Z.location,ie);break;case 4:n.vertexAttrib4fv(Z.location,ie);break;default:n.vertexAttrib1fv(Z.location,ie)}}}}v()}function L(){k();for(let D in i){let H=i[D];for(let O in H){let I=H[O];for(let W in I){let $=I[W];for(let G in $)u($[G].object),delete $[G];delete I[W]}}delete i[D]}}function C(D){if(i[D.id]===void 0)return;let H=i[D.id];for(let O in H){let I=H[O];for(let W in I){let $=I[W];for(let G in $)u($[G].object),delete $[G];delete I[W]}}delete i[D.id]}function _(D){for(let H in i){let O=i[H];for(let I in O){let W=O[I];if(W[D.id]===void 0)continue;let $=W[D.id];for(let G in $)u($[G].object),delete $[G];delete W[D.id]}}}function T(D){for(let H in i){let O=i[H],I=D.isInstancedMesh===!0?D.id:0,W=O[I];if(W!==void 0){for(let $ in W){let G=W[$];for(let le in G)u(G[le].object),delete G[le];delete W[$]}delete O[I],Object.keys(O).length===0&&delete i[H]}}}function k(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:k,resetDefaultState:U,dispose:L,releaseStatesOfGeometry:C,releaseStatesOfObject:T,releaseStatesOfProgram:_,initAttributes:b,enableAttribute:g,disableUnusedAttributes:v}}function IA(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function LA(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let _=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==Ii&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let T=_===ns&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(_!==_i&&_!==ts&&!T&&i.convert(_)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(_){if(_==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&(Je("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&Je("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&Je("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),g=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),m=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),E=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),L=n.getParameter(n.MAX_SAMPLES),C=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:b,maxCubemapSize:g,maxAttributes:m,maxVertexUniforms:v,maxVaryings:E,maxFragmentUniforms:M,maxSamples:L,samples:C}}function DA(n){let e=this,t=null,i=0,s=!1,r=!1,o=new li,a=new ot,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,b=f.clipIntersection,g=f.clipShadows,m=n.get(f);if(!s||p===null||p.length===0||r&&!g)r?u(null):c();else{let v=r?0:i,E=v*4,M=m.clippingState||null;l.value=M,M=u(p,h,E,d);for(let L=0;L!==E;++L)M[L]=t[L];m.clippingState=M,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let b=f!==null?f.length:0,g=null;if(b!==0){if(g=l.value,p!==!0||g===null){let m=d+b*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(g===null||g.length<m)&&(g=new Float32Array(m));for(let E=0,M=d;E!==b;++E,M+=4)o.copy(f[E]).applyMatrix4(v,a),o.normal.toArray(g,M),g[M+3]=o.constant}l.value=g,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,g}}var El=class extends Ri{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new el(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new jo(5,5,5),r=new zi({name:"CubemapFromEquirect",uniforms:Kr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:hi,blending:$r});r.uniforms.tEquirect.value=t;let o=new Gn(s,r),a=t.minFilter;return t.minFilter===Gs&&(t.minFilter=ui),new Qo(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},Tx=256,NA=3,UA=20,Jx=256,Zx=16,OA=3,FA=new V,BA=new dt,Rh=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Qo(1,10,null),this._boxMesh=new Gn(new jo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=FA}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(BA));let g=new Qo(i,s,u);return g.position.copy(a),g.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=Rx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=Cx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(Tx,fp(e))}_fromTexture(e,t){e.mapping===Jr||e.mapping===ia?this._setSize(e.image.length===0?Tx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=Ex(e,!1,!1),i=Math.log2(e)-NA;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=Ex(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===Jr||e.mapping===ia?(this._cubemapMaterial===null&&(this._cubemapMaterial=Rx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=Cx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=kA(),this._integrationMaterial=zA());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Zx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-OA)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Jx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=VA());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function Ex(n,e,t){return new El(n,{minFilter:Gs,generateMipmaps:e,type:ns,colorSpace:Wa,depthBuffer:t})}function Cl(n,e,t){return new zi({name:n,uniforms:e,vertexShader:pt.cube_vert,fragmentShader:t,side:hi,blending:$r,depthTest:!1,depthWrite:!1})}function kA(){return Cl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Jx}u

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
	`)}function zA(){return Cl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Zx}},`

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
	`)}function VA(){return Cl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${UA}
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
	`)}function Cx(){return Cl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function Rx(){return Cl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function HA(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===zu||d===Vu)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let b=new El(p.height);return b.fromEquirectangularTexture(n,h),e.set(h,b),h.addEventListener("dispose",c),a(b.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===zu||d===Vu,b=d===Jr||d===ia;if(p||b){let g=t.get(h),m=g!==void 0?g.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==m)return i===null&&(i=new Rh(n)),g=p?i.fromEquirectangular(h,g):i.fromCubemap(h,g),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),g.texture;if(g!==void 0)return g.texture;{let v=h.image;return p&&v&&v.height>0||b&&v&&l(v)?(i===null&&(i=new Rh(n)),g=p?i.fromEquirectangular(h):i.fromCubemap(h),g.texture.pmremVersion=h.pmremVersion,t.set(h,g),h.addEventListener("dispose",u),g.texture):null}}}return h}function a(h,d){return d===zu?h.mapping=Jr:d===Vu&&(h.mapping=ia),h}function l(h){let d=0,p=6;for(let b=0;b<p;b++)h[b]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function GA(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&za("WebGLRenderer: "+i+" extension not supported."),s}}}function WA(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let g in p.attributes)e.remove(p.attributes[g]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let b=r.get(p);b&&(e.remove(b),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function u(p){let b=p.attributes;for(let g in b)e.update(b[g],n.ARRAY_BUFFER)}function f(p){let b=p.index,g=p.attributes.position,m=0;if(g===void 0)return;let v=b!==null?b.array.length:g.array.length/3-1,E=g.count>=65535?ja:Ka,M=new E(Math.ceil(v/3)*6,1),L=M.array;if(b!==null){let _=b.array;m=b.version;for(let T=0,k=0;T<v;T+=3){let U=_[T+0],D=_[T+1],H=_[T+2];L[k++]=U,L[k++]=D,L[k++]=D,L[k++]=H,L[k++]=H,L[k++]=U}}else{m=g.version;for(let _=0,T=0;_<v;_+=3){let k=_+0,U=_+1,D=_+2;L[T++]=k,L[T++]=U,L[T++]=U,L[T++]=D,L[T++]=D,L[T++]=k}}M.version=m;let C=r.get(p);C&&e.remove(C),r.set(p,M)}function h(p){let b=r.get(p);if(b){let g=p.index;g!==null&&b.version<g.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let b=s[p].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function XA(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let b=0;for(let g=0;g<d;g++)b+=h[g];t.update(b,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function qA(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:st("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function $A(n,e,t){let i=new WeakMap,s=new Pt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let k=function(){_.dispose(),i.delete(a),a.removeEventListener("dispose",k)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,g=a.morphAttributes.position||[],m=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],E=0;d===!0&&(E=1),p===!0&&(E=2),b===!0&&(E=3);let M=a.attributes.position.count*E,L=1;M>e.maxTextureSize&&(L=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let C=new Float32Array(M*L*4*f),_=new Ya(C,M,L,f);_.type=ts,_.needsUpdate=!0;let T=E*4;for(let U=0;U<f;U++){let D=g[U],H=m[U],O=v[U],I=M*L*4*U;for(let W=0;W<D.count;W++){let $=W*T;d===!0&&(s.fromBufferAttribute(D,W),C[I+$+0]=s.x,C[I+$+1]=s.y,C[I+$+2]=s.z,C[I+$+3]=0),p===!0&&(s.fromBufferAttribute(H,W),C[I+$+4]=s.x,C[I+$+5]=s.y,C[I+$+6]=s.z,C[I+$+7]=0),b===!0&&(s.fromBufferAttribute(O,W),C[I+$+8]=s.x,C[I+$+9]=s.y,C[I+$+10]=s.z,C[I+$+11]=O.itemSize===4?s.w:1)}}h={count:f,texture:_,size:new Ke(M,L)},i.set(a,h),a.addEventListener("dispose",k)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function YA(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var JA={[qf]:"LINEAR_TONE_MAPPING",[$f]:"REINHARD_TONE_MAPPING",[Yf]:"CINEON_TONE_MAPPING",[Jf]:"ACES_FILMIC_TONE_MAPPING",[Kf]:"AGX_TONE_MAPPING",[jf]:"NEUTRAL_TONE_MAPPING",[Zf]:"CUSTOM_TONE_MAPPING"};function ZA(n,e,t,i,s,r){let o=new Ri(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new bn;u.setAttribute("position",new zn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new zn([0,2,0,0,2,0],2));let f=new wu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Gn(u,f),d=new ul(-1,1,1,-1,0,1),p=null,b=null,g=!1,m,v=null,E=[],M=!1;this.setSize=function(L,C){o.setSize(L,C),a!==null&&a.setSize(L,C),l!==null&&l.setSize(L,C);for(let _=0;_<E.length;_++){let T=E[_];T.setSize&&T.setSize(L,C)}},this.setEffects=function(L){E=L,M=E.length>0&&E[0].isRenderPass===!0;let C=o.width,_=o.height;E.length>0&&a===null&&(a=new Ri(C,_,{type:ns,depthBuffer:!1,stencilBuffer:!1}),l=new Ri(C,_,{type:ns,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&E.some(k=>k.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new Hs(C,_),r===!0&&(c.format=Ws,c.type=Zr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let k=0;k<E.length;k++){let U=E[k];U.setSize&&U.setSize(C,_),T&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(L,C){if(g||L.toneMapping===_s&&E.length===0)return!1;if(v=C,C!==null){let _=C.width,T=C.height;(o.width!==_||o.height!==T)&&this.setSize(_,T)}return M===!1&&L.setRenderTarget(o),m=L.toneMapping,L.toneMapping=_s,!0},this.hasRenderPass=function(){return M},this.end=function(L,C){L.toneMapping=m,g=!0;let _=o,T=a;for(let k=0;k<E.length;k++){let U=E[k];U.enabled!==!1&&(U.render(L,T,_,C),U.needsSwap!==!1&&(_=T,T=T===a?l:a))}if(p!==L.outputColorSpace||b!==L.toneMapping){p=L.outputColorSpace,b=L.toneMapping,f.defines={},vt.getTransfer(p)===Rt&&(f.defines.SRGB_TRANSFER="");let k=JA[b];k&&(f.defines[k]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=_.texture,L.setRenderTarget(v),L.render(h,d),v=null,g=!1},this.isCompositing=function(){return g},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Kx=new mi,jx=new Hs(1,1),Qx=new tl(1),ey=new Ya,ty=new xu,ny=new el,Px=[],Ix=[],Lx=new Float32Array(16),Dx=new Float32Array(9),Nx=new Float32Array(4);function oa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Px[s];if(r===void 0&&(r=new Float32Array(s),Px[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Pn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function In(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Ih(n,e){let t=Ix[e];t===void 0&&(t=new Int32Array(e),Ix[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function KA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function jA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pn(t,e))return;n.uniform2fv(this.addr,e),In(t,e)}}function QA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Pn(t,e))return;n.uniform3fv(this.addr,e),In(t,e)}}function eT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pn(t,e))return;n.uniform4fv(this.addr,e),In(t,e)}}function tT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Pn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),In(t,e)}else{if(Pn(t,i))return;Nx.set(i),n.uniformMatrix2fv(this.addr,!1,Nx),In(t,i)}}function nT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Pn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),In(t,e)}else{if(Pn(t,i))return;Dx.set(i),n.uniformMatrix3fv(this.addr,!1,Dx),In(t,i)}}function iT(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Pn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),In(t,e)}else{if(Pn(t,i))return;Lx.set(i),n.uniformMatrix4fv(this.addr,!1,Lx),In(t,i)}}function sT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function rT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pn(t,e))return;n.uniform2iv(this.addr,e),In(t,e)}}function oT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Pn(t,e))return;n.uniform3iv(this.addr,e),In(t,e)}}function aT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pn(t,e))return;n.uniform4iv(this.addr,e),In(t,e)}}function lT(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function cT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Pn(t,e))return;n.uniform2uiv(this.addr,e),In(t,e)}}function uT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Pn(t,e))return;n.uniform3uiv(this.addr,e),In(t,e)}}function hT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Pn(t,e))return;n.uniform4uiv(this.addr,e),In(t,e)}}function Lh(n){return n.version===0&&(n.compareFunction=cp,n.needsUpdate=!0),n}function dT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Lh(jx):r=Kx,t.setTexture2D(e||r,s)}function fT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||ty,s)}function pT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Lh(Qx):r=ny,t.setTextureCube(e||r,s)}function mT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||ey,s)}function gT(n){switch(n){case 5126:return KA;case 35664:return jA;case 35665:return QA;case 35666:return eT;case 35674:return tT;case 35675:return nT;case 35676:return iT;case 5124:case 35670:return sT;case 35667:case 35671:return rT;case 35668:case 35672:return oT;case 35669:case 35673:return aT;case 5125:return lT;case 36294:return cT;case 36295:return uT;case 36296:return hT;case 35678:case 36198:case 36298:case 36306:case 35682:return dT;case 35679:case 36299:case 36307:return fT;case 35680:case 36300:case 36308:case 36293:return pT;case 36289:case 36303:case 36311:case 36292:return mT}}function _T(n,e){n.uniform1fv(this.addr,e)}function xT(n,e){let t=oa(e,this.size,2);n.uniform2fv(this.addr,t)}function yT(n,e){let t=oa(e,this.size,3);n.uniform3fv(this.addr,t)}function vT(n,e){let t=oa(e,this.size,4);n.uniform4fv(this.addr,t)}function bT(n,e){let t=oa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function ST(n,e){let t=oa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function MT(n,e){let t=oa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function wT(n,e){n.uniform1iv(this.addr,e)}function AT(n,e){n.uniform2iv(this.addr,e)}function TT(n,e){n.uniform3iv(this.addr,e)}function ET(n,e){n.uniform4iv(this.addr,e)}function CT(n,e){n.uniform1uiv(this.addr,e)}function RT(n,e){n.uniform2uiv(this.addr,e)}function PT(n,e){n.uniform3uiv(this.addr,e)}function IT(n,e){n.uniform4uiv(this.addr,e)}function LT(n,e,t){let i=this.cache,s=e.length,r=Ih(t,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Lh(jx):o=Kx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function DT(n,e,t){let i=this.cache,s=e.length,r=Ih(t,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||ty,r[o])}function NT(n,e,t){let i=this.cache,s=e.length,r=Ih(t,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Lh(Qx):o=ny;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function UT(n,e,t){let i=this.cache,s=e.length,r=Ih(t,s);Pn(i,r)||(n.uniform1iv(this.addr,r),In(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||ey,r[o])}function OT(n){switch(n){case 5126:return _T;case 35664:return xT;case 35665:return yT;case 35666:return vT;case 35674:return bT;case 35675:return ST;case 35676:return MT;case 5124:case 35670:return wT;case 35667:case 35671:return AT;case 35668:case 35672:return TT;case 35669:case 35673:return ET;case 5125:return CT;case 36294:return RT;case 36295:return PT;case 36296:return IT;case 35678:case 36198:case 36298:case 36306:case 35682:return LT;case 35679:case 36299:case 36307:return DT;case 35680:case 36300:case 36308:case 36293:return NT;case 36289:case 36303:case 36311:case 36292:return UT}}var Sp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=gT(t.type)}},Mp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=OT(t.type)}},wp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},vp=/(\w+)(\])?(\[|\.)?/g;function Ux(n,e){n.seq.push(e),n.map[e.id]=e}function FT(n,e,t){let i=n.name,s=i.length;for(vp.lastIndex=0;;){let r=vp.exec(i),o=vp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ux(t,c===void 0?new Sp(a,n,e):new Mp(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new wp(a),Ux(t,f)),t=f}}}var ra=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);FT(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Ox(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var BT=37297,kT=0;function zT(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Fx=new ot;function VT(n){vt._getMatrix(Fx,vt.workingColorSpace,n);let e=`mat3( ${Fx.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case Xa:return[e,"LinearTransferOETF"];case Rt:return[e,"sRGBTransferOETF"];default:return Je("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Bx(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+zT(n.getShaderSource(e),a)}else return r}function HT(n,e){let t=VT(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var GT={[qf]:"Linear",[$f]:"Reinhard",[Yf]:"Cineon",[Jf]:"ACESFilmic",[Kf]:"AgX",[jf]:"Neutral",[Zf]:"Custom"};function WT(n,e){let t=GT[e];return t===void 0?(Je("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var Ch=new V;function XT(){vt.getLuminanceCoefficients(Ch);let n=Ch.x.toFixed(4),e=Ch.y.toFixed(4),t=Ch.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function qT(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Tl).join(`
`)}function $T(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function YT(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Tl(n){return n!==""}function kx(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function zx(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var JT=/^[ \t]*#include +<([\w\d./]+)>/gm;function Ap(n){return n.replace(JT,ZT)}function ZT(n,e){let t=pt[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return Ap(t)}var KT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Vx(n){return n.replace(KT,jT)}function jT(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Hx(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var QT={[ml]:"SHADOWMAP_TYPE_PCF",[ta]:"SHADOWMAP_TYPE_VSM"};function eE(n){return QT[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var tE={[ia]:"ENVMAP_MODE_REFRACTION"};function nE(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":tE[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var iE={[ku]:"ENVMAP_BLENDING_MULTIPLY",[lx]:"ENVMAP_BLENDING_MIX",[cx]:"ENVMAP_BLENDING_ADD"};function sE(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":iE[n.combine]||"ENVMAP_BLENDING_NONE"}function rE(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=eE(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=nE(t),f=sE(t),h=qT(t),d=$T(r),p=s.createProgram(),b,g,m=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Tl).join(`
`),b.length>0&&(b+=`
`),g=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Tl).join(`
`),g.length>0&&(g+=`
`)):(b=[Hx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Tl).join(`
`),g=[Hx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==_s?"#define TONE_MAPPING":"",t.toneMapping!==_s?pt.tonemapping_pars_fragment:"",t.toneMapping!==_s?WT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",pt.colorspace_pars_fragment,HT("linearToOutputTexel",t.outputColorSpace),XT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Tl).join(`
`)),o=Ap(o),o=kx(o,t),o=zx(o,t),a=Ap(a),a=kx(a,t),a=zx(a,t),o=Vx(o),a=Vx(a),t.isRawShaderMaterial!==!0&&(m=`#version 300 es
`,b=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,g=["#define varying in",t.glslVersion===hp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===hp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+g);let v=m+b+o,E=m+g+a,M=Ox(s,s.VERTEX_SHADER,v),L=Ox(s,s.FRAGMENT_SHADER,E);s.attachShader(p,M),s.attachShader(p,L),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function C(U){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(M)||"",O=s.getShaderInfoLog(L)||"",I=D.trim(),W=H.trim(),$=O.trim(),G=!0,le=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,M,L);else{let Z=Bx(s,M,"vertex"),Q=Bx(s,L,"fragment");st("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+I+`
`+Z+`
`+Q)}else I!==""?Je("WebGLProgram: Program Info Log:",I):(W===""||$==="")&&(le=!1);le&&(U.diagnostics={runnable:G,programLog:I,vertexShader:{log:W,prefix:b},fragmentShader:{log:$,prefix:g}})}s.deleteShader(M),s.deleteShader(L),_=new ra(s,p),T=YT(s,p)}let _;this.getUniforms=function(){return _===void 0&&C(this),_};let T;this.getAttributes=function(){return T===void 0&&C(this),T};let k=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return k===!1&&(k=s.getProgramParameter(p,BT)),k},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=kT++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=M,this.fragmentShader=L,this}var oE=0,Tp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new Ep(e),t.set(e,i)),i}},Ep=class{constructor(e){this.id=oE++,this.code=e,this.usedTimes=0}};function aE(n){return n===Ar||n===bl||n===Sl}function lE(n,e,t,i,s,r){let o=new Ja,a=new Tp,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(_){return l.add(_),_===0?"uv":`uv${_}`}function p(_,T,k,U,D,H){let O=U.fog,I=D.geometry,W=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?U.environment:null,$=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,G=e.get(_.envMap||W,$),le=h[_.type],Z=i.precision;_.precision!==null&&(Z=i.getMaxPrecision(_.precision),Z!==_.precision&&Je("WebGLProgram.getParameters:",_.precision,"not supported, using",Z,"instead."));let Q=I.morphAttributes.position||I.morphAttributes.normal||I.morphAttributes.color,ie=Q!==void 0?Q.length:0,de=0;I.morphAttributes.position!==void 0&&(de=1),I.morphAttributes.normal!==void 0&&(de=2),I.morphAttributes.color!==void 0&&(de=3);let he,ee,ge,_e;if(le){let Pe=di[le];he=Pe.vertexShader,ee=Pe.fragmentShader}else{he=_.vertexShader,ee=_.fragmentShader;let Pe=a.getVertexShaderStage(_),ht=a.getFragmentShaderStage(_);a.update(_,Pe,ht),ge=Pe.id,_e=ht.id}let Re=n.getRenderTarget(),ve=n.state.buffers.depth.getReversed(),We=D.isInstancedMesh===!0,me=D.isBatchedMesh===!0,be=!!_.map,je=!!_.matcap,rt=!!G,at=rt&&G.isPMREMTexture===!0,Zt=!!_.aoMap,Gt=!!_.lightMap,un=!!_.bumpMap&&_.wireframe===!1,Ft=!!_.normalMap,Dn=!!_.displacementMap,bt=!!_.emissiveMap,Sn=!!_.metalnessMap,en=!!_.roughnessMap,hn=_.anisotropy>0,B=_.clearcoat>0,Ie=_.diffuseRoughness>0,Ze=_.dispersion>0,ct=_.retroreflectivity>0,Ae=_.iridescence>0,zt=_.sheen>0,He=_.transmission>0,$e=hn&&!!_.anisotropyMap,R=B&&!!_.clearcoatMap,S=B&&!!_.clearcoatNormalMap,q=B&&!!_.clearcoatRoughnessMap,ue=Ie&&!!_.diffuseRoughnessMap,oe=Ae&&!!_.iridescenceMap,ye=Ae&&!!_.iridescenceThicknessMap,Se=zt&&!!_.sheenColorMap,te=zt&&!!_.sheenRoughnessMap,se=!!_.specularMap,pe=!!_.specularColorMap,F=!!_.specularIntensityMap,re=He&&!!_.transmissionMap,ne=He&&!!_.thicknessMap,Te=!!_.gradientMap,xe=!!_.alphaMap,we=_.alphaTest>0,Xe=!!_.alphaHash,tt=!!_.extensions,ce=_s;_.toneMapped&&(Re===null||Re.isXRRenderTarget===!0)&&(ce=n.toneMapping);let ke=at?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,nt={shaderID:le,shaderType:_.type,shaderName:_.name,vertexShader:he,fragmentShader:ee,defines:_.defines,customVertexShaderID:ge,customFragmentShaderID:_e,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:Z,batching:me,batchingColor:me&&D._colorsTexture!==null,instancing:We,instancingColor:We&&D.instanceColor!==null,instancingMorph:We&&D.morphTexture!==null,outputColorSpace:Re===null?n.outputColorSpace:Re.isXRRenderTarget===!0?Re.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:be,matcap:je,envMap:rt,envMapMode:rt&&G.mapping,envMapPMREM:at,envMapMaxLod:at?ke.length-1:null,envMapSize:at?ke[0].width:null,aoMap:Zt,lightMap:Gt,bumpMap:un,normalMap:Ft,displacementMap:Dn,emissiveMap:bt,normalMapObjectSpace:Ft&&_.normalMapType===dx,normalMapTangentSpace:Ft&&_.normalMapType===Ah,packedNormalMap:Ft&&_.normalMapType===Ah&&aE(_.normalMap.format),metalnessMap:Sn,roughnessMap:en,anisotropy:hn,anisotropyMap:$e,clearcoat:B,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Ie,diffuseRoughnessMap:ue,dispersion:Ze,retroreflection:ct,iridescence:Ae,iridescenceMap:oe,iridescenceThicknessMap:ye,sheen:zt,sheenColorMap:Se,sheenRoughnessMap:te,specularMap:se,specularColorMap:pe,specularIntensityMap:F,transmission:He,transmissionMap:re,thicknessMap:ne,gradientMap:Te,opaque:_.transparent===!1&&_.blending===na&&_.alphaToCoverage===!1,alphaMap:xe,alphaTest:we,alphaHash:Xe,combine:_.combine,mapUv:be&&d(_.map.channel),aoMapUv:Zt&&d(_.aoMap.channel),lightMapUv:Gt&&d(_.lightMap.channel),bumpMapUv:un&&d(_.bumpMap.channel),normalMapUv:Ft&&d(_.normalMap.channel),displacementMapUv:Dn&&d(_.displacementMap.channel),emissiveMapUv:bt&&d(_.emissiveMap.channel),metalnessMapUv:Sn&&d(_.metalnessMap.channel),roughnessMapUv:en&&d(_.roughnessMap.channel),anisotropyMapUv:$e&&d(_.anisotropyMap.channel),clearcoatMapUv:R&&d(_.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:ue&&d(_.diffuseRoughnessMap.channel),iridescenceMapUv:oe&&d(_.iridescenceMap.channel),iridescenceThicknessMapUv:ye&&d(_.iridescenceThicknessMap.channel),sheenColorMapUv:Se&&d(_.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(_.sheenRoughnessMap.channel),specularMapUv:se&&d(_.specularMap.channel),specularColorMapUv:pe&&d(_.specularColorMap.channel),specularIntensityMapUv:F&&d(_.specularIntensityMap.channel),transmissionMapUv:re&&d(_.transmissionMap.channel),thicknessMapUv:ne&&d(_.thicknessMap.channel),alphaMapUv:xe&&d(_.alphaMap.channel),vertexTangents:!!I.attributes.tangent&&(Ft||hn),vertexNormals:!!I.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!I.attributes.color&&I.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!I.attributes.uv&&(be||xe),fog:!!O,useFog:_.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||I.attributes.normal===void 0&&Ft===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ve,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:I.attributes.position!==void 0,morphTargets:I.morphAttributes.position!==void 0,morphNormals:I.morphAttributes.normal!==void 0,morphColors:I.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:de,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:H.filter(Pe=>Pe.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:n.shadowMap.enabled&&k.length>0,shadowMapType:n.shadowMap.type,toneMapping:ce,decodeVideoTexture:be&&_.map.isVideoTexture===!0&&vt.getTransfer(_.map.colorSpace)===Rt,decodeVideoTextureEmissive:bt&&_.emissiveMap.isVideoTexture===!0&&vt.getTransfer(_.emissiveMap.colorSpace)===Rt,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===gi,flipSided:_.side===hi,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:tt&&_.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(tt&&_.extensions.multiDraw===!0||me)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return nt.vertexUv1s=l.has(1),nt.vertexUv2s=l.has(2),nt.vertexUv3s=l.has(3),l.clear(),nt}function b(_){let T=[];if(_.shaderID?T.push(_.shaderID):(T.push(_.customVertexShaderID),T.push(_.customFragmentShaderID)),_.defines!==void 0)for(let k in _.defines)T.push(k),T.push(_.defines[k]);return _.isRawShaderMaterial===!1&&(g(T,_),m(T,_),T.push(n.outputColorSpace)),T.push(_.customProgramCacheKey),T.join()}function g(_,T){_.push(T.precision),_.push(T.outputColorSpace),_.push(T.envMapMode),_.push(T.envMapPMREM),_.push(T.envMapMaxLod),_.push(T.envMapSize),_.push(T.mapUv),_.push(T.alphaMapUv),_.push(T.lightMapUv),_.push(T.aoMapUv),_.push(T.bumpMapUv),_.push(T.normalMapUv),_.push(T.displacementMapUv),_.push(T.emissiveMapUv),_.push(T.metalnessMapUv),_.push(T.roughnessMapUv),_.push(T.anisotropyMapUv),_.push(T.clearcoatMapUv),_.push(T.clearcoatNormalMapUv),_.push(T.clearcoatRoughnessMapUv),_.push(T.diffuseRoughnessMapUv),_.push(T.iridescenceMapUv),_.push(T.iridescenceThicknessMapUv),_.push(T.sheenColorMapUv),_.push(T.sheenRoughnessMapUv),_.push(T.specularMapUv),_.push(T.specularColorMapUv),_.push(T.specularIntensityMapUv),_.push(T.transmissionMapUv),_.push(T.thicknessMapUv),_.push(T.combine),_.push(T.fogExp2),_.push(T.sizeAttenuation),_.push(T.morphTargetsCount),_.push(T.numSunLights),_.push(T.numDirLights),_.push(T.numPointLights),_.push(T.numSpotLights),_.push(T.numSpotLightMaps),_.push(T.numHemiLights),_.push(T.numRectAreaLights),_.push(T.numSunLightShadows),_.push(T.numDirLightShadows),_.push(T.numPointLightShadows),_.push(T.numSpotLightShadows),_.push(T.numSpotLightShadowsWithMaps),_.push(T.numLightProbes),_.push(T.numLightProbeGrids),_.push(T.shadowMapType),_.push(T.toneMapping),_.push(T.numClippingPlanes),_.push(T.numClipIntersection),_.push(T.depthPacking)}function m(_,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function v(_){let T=h[_.type],k;if(T){let U=di[T];k=wl.clone(U.uniforms)}else k=_.uniforms;return k}function E(_,T){let k=u.get(T);return k!==void 0?++k.usedTimes:(k=new rE(n,T,_,s),c.push(k),u.set(T,k)),k}function M(_){if(--_.usedTimes===0){let T=c.indexOf(_);c[T]=c[c.length-1],c.pop(),u.delete(_.cacheKey),_.destroy()}}function L(_){a.remove(_)}function C(){a.dispose()}return{getParameters:p,getProgramCacheKey:b,getUniforms:v,acquireProgram:E,releaseProgram:M,releaseShaderCache:L,programs:c,dispose:C}}function cE(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function uE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Gx(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Wx(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,b,g,m){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:b,renderOrder:h.renderOrder,z:g,group:m},n[e]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=p,v.materialVariant=o(h),v.groupOrder=b,v.renderOrder=h.renderOrder,v.z=g,v.group=m),e++,v}function l(h,d,p,b,g,m,v){v.reversedDepth===!0&&(g=-g);let E=a(h,d,p,b,g,m);p.transmission>0?i.push(E):p.transparent===!0?s.push(E):t.push(E)}function c(h,d,p,b,g,m){let v=a(h,d,p,b,g,m);p.transmission>0?i.unshift(v):p.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||uE),i.length>1&&i.sort(d||Gx),s.length>1&&s.sort(d||Gx)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function hE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Wx,n.set(i,[o])):s>=r.length?(o=new Wx,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function dE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new V,color:new dt};break;case"SpotLight":t={position:new V,direction:new V,color:new dt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new V,color:new dt,distance:0,decay:0};break;case"HemisphereLight":t={direction:new V,skyColor:new dt,groundColor:new dt};break;case"RectAreaLight":t={color:new dt,position:new V,halfWidth:new V,halfHeight:new V};break}return n[e.id]=t,t}}}function fE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ke,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var pE=0;function mE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function gE(n){let e=new dE,t=fE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new V);let s=new V,r=new St,o=new St;function a(c){let u=0,f=0,h=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let d=0,p=0,b=0,g=0,m=0,v=0,E=0,M=0,L=0,C=0,_=0,T=0,k=0,U=0;c.sort(mE);for(let H=0,O=c.length;H<O;H++){let I=c[H],W=I.color,$=I.intensity,G=I.distance,le=null;if(I.shadow&&I.shadow.map&&(I.shadow.map.texture.format===Ar?le=I.shadow.map.texture:le=I.shadow.map.depthTexture||I.shadow.map.texture),I.isAmbientLight)u+=W.r*$,f+=W.g*$,h+=W.b*$;else if(I.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(I.sh.coefficients[Z],$);U++}else if(I.isSunLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=le;let de=Q.getViewportCount();for(let he=0;he<de;he++)i.sunShadowMatrix[b+he]=Q.getMatrix(he),i.sunShadowCascade[b+he]=Q._cascadeData[he];b+=de,p++}i.sun[d]=Z,d++}else if(I.isDirectionalLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[g]=ie,i.directionalShadowMap[g]=le,i.directionalShadowMatrix[g]=I.shadow.matrix,L++}i.directional[g]=Z,g++}else if(I.isSpotLight){let Z=e.get(I);Z.position.setFromMatrixPosition(I.matrixWorld),Z.color.copy(W).multiplyScalar($),Z.distance=G,Z.coneCos=Math.cos(I.angle),Z.penumbraCos=Math.cos(I.angle*(1-I.penumbra)),Z.decay=I.decay,i.spot[v]=Z;let Q=I.shadow;if(I.map&&(i.spotLightMap[T]=I.map,T++,Q.updateMatrices(I),I.castShadow&&k++),i.spotLightMatrix[v]=Q.matrix,I.castShadow){let ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[v]=ie,i.spotShadowMap[v]=le,_++}v++}else if(I.isRectAreaLight){let Z=e.get(I);Z.color.copy(W).multiplyScalar($),Z.halfWidth.set(I.width*.5,0,0),Z.halfHeight.set(0,I.height*.5,0),i.rectArea[E]=Z,E++}else if(I.isPointLight){let Z=e.get(I);if(Z.color.copy(I.color).multiplyScalar(I.intensity),Z.distance=I.distance,Z.decay=I.decay,I.castShadow){let Q=I.shadow,ie=t.get(I);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[m]=ie,i.pointShadowMap[m]=le,i.pointShadowMatrix[m]=I.shadow.matrix,C++}i.point[m]=Z,m++}else if(I.isHemisphereLight){let Z=e.get(I);Z.skyColor.copy(I.color).multiplyScalar($),Z.groundColor.copy(I.groundColor).multiplyScalar($),i.hemi[M]=Z,M++}}E>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Le.LTC_FLOAT_1,i.rectAreaLTC2=Le.LTC_FLOAT_2):(i.rectAreaLTC1=Le.LTC_HALF_1,i.rectAreaLTC2=Le.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let D=i.hash;(D.sunLength!==d||D.directionalLength!==g||D.pointLength!==m||D.spotLength!==v||D.rectAreaLength!==E||D.hemiLength!==M||D.numSunShadows!==p||D.numDirectionalShadows!==L||D.numPointShadows!==C||D.numSpotShadows!==_||D.numSpotMaps!==T||D.numLightProbes!==U)&&(i.sun.length=d,i.directional.length=g,i.spot.length=v,i.rectArea.length=E,i.point.length=m,i.hemi.length=M,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=L,i.directionalShadowMap.length=L,i.directionalShadowMatrix.length=L,i.pointShadow.length=C,i.pointShadowMap.length=C,i.pointShadowMatrix.length=C,i.spotShadow.length=_,i.spotShadowMap.length=_,i.spotLightMatrix.length=_+T-k,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=k,i.numLightProbes=U,D.sunLength=d,D.directionalLength=g,D.pointLength=m,D.spotLength=v,D.rectAreaLength=E,D.hemiLength=M,D.numSunShadows=p,D.numDirectionalShadows=L,D.numPointShadows=C,D.numSpotShadows=_,D.numSpotMaps=T,D.numLightProbes=U,i.version=pE++)}function l(c,u){let f=0,h=0,d=0,p=0,b=0,g=0,m=u.matrixWorldInverse;for(let v=0,E=c.length;v<E;v++){let M=c[v];if(M.isSunLight){let L=i.sun[f];L.direction.setFromMatrixPosition(M.matrixWorld),L.direction.transformDirection(m),f++}else if(M.isDirectionalLight){let L=i.directional[h];L.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),L.direction.sub(s),L.direction.transformDirection(m),h++}else if(M.isSpotLight){let L=i.spot[p];L.position.setFromMatrixPosition(M.matrixWorld),L.position.applyMatrix4(m),L.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),L.direction.sub(s),L.direction.transformDirection(m),p++}else if(M.isRectAreaLight){let L=i.rectArea[b];L.position.setFromMatrixPosition(M.matrixWorld),L.position.applyMatrix4(m),o.identity(),r.copy(M.matrixWorld),r.premultiply(m),o.extractRotation(r),L.halfWidth.set(M.width*.5,0,0),L.halfHeight.set(0,M.height*.5,0),L.halfWidth.applyMatrix4(o),L.halfHeight.applyMatrix4(o),b++}else if(M.isPointLight){let L=i.point[d];L.position.setFromMatrixPosition(M.matrixWorld),L.position.applyMatrix4(m),d++}else if(M.isHemisphereLight){let L=i.hemi[g];L.direction.setFromMatrixPosition(M.matrixWorld),L.direction.transformDirection(m),g++}}}return{setup:a,setupView:l,state:i}}function Xx(n){let e=new gE(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function _E(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Xx(n),e.set(s,[a])):r>=o.length?(a=new Xx(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var xE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,yE=`uniform sampler2D shadow_pass;
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
}`,vE=[new V(1,0,0),new V(-1,0,0),new V(0,1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1)],bE=[new V(0,-1,0),new V(0,-1,0),new V(0,0,1),new V(0,0,-1),new V(0,-1,0),new V(0,-1,0)],qx=new St,Al=new V,bp=new V;function SE(n,e,t){let i=new gr,s=new Ke,r=new Ke,o=new Pt,a=new Au,l=new Tu,c={},u=t.maxTextureSize,f={[wr]:hi,[hi]:wr,[gi]:gi},h=new zi({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ke},radius:{value:4}},vertexShader:xE,fragmentShader:yE}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new bn;p.setAttribute("position",new vn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Gn(p,h),g=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ml;let m=this.type;this.render=function(C,_,T){if(g.enabled===!1||g.autoUpdate===!1&&g.needsUpdate===!1||C.length===0)return;this.type===G_&&(Je("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ml);let k=n.getRenderTarget(),U=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),H=n.state;H.setBlending($r),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let O=m!==this.type;O&&_.traverse(function(I){I.material&&(Array.isArray(I.material)?I.material.forEach(W=>W.needsUpdate=!0):I.material.needsUpdate=!0)});for(let I=0,W=C.length;I<W;I++){let $=C[I],G=$.shadow;if(G===void 0){Je("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let le=G.getFrameExtents();s.multiply(le),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/le.x),s.x=r.x*le.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/le.y),s.y=r.y*le.y,G.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Z,G.map===null||O===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===ta){if($.isPointLight){Je("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Ri(s.x,s.y,{format:Ar,type:ns,minFilter:ui,magFilter:ui,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new Hs(s.x,s.y,ts),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=zs,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=cn,G.map.depthTexture.magFilter=cn}else $.isPointLight?(G.map=new El(s.x),G.map.depthTexture=new tl(s.x,es)):(G.map=new Ri(s.x,s.y),G.map.depthTexture=new Hs(s.x,s.y,es)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=zs,this.type===ml?(G.map.depthTexture.compareFunction=Z?lp:ap,G.map.depthTexture.minFilter=ui,G.map.depthTexture.magFilter=ui):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=cn,G.map.depthTexture.magFilter=cn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,T);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let de=0;de<Q;de++){let he=G.getCamera(de);if($.isPointLight){let ee=G.camera,ge=G.matrix,_e=$.distance||ee.far;_e!==ee.far&&(ee.far=_e,ee.updateProjectionMatrix()),Al.setFromMatrixPosition($.matrixWorld),ee.position.copy(Al),bp.copy(ee.position),bp.add(vE[de]),ee.up.copy(bE[de]),ee.lookAt(bp),ee.updateMatrixWorld(),ge.makeTranslation(-Al.x,-Al.y,-Al.z),qx.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(qx,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,de),n.clear();else{de===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(de);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),H.viewport(o)}i=G.getFrustum(de),M(_,T,he,$,ie,this.type)}G.isPointLightShadow!==!0&&this.type===ta&&v(G,T),G.needsUpdate=!1}m=this.type,g.needsUpdate=!1,n.setRenderTarget(k,U,D)};function v(C,_){let T=e.update(b);h.defines.VSM_SAMPLES!==C.blurSamples&&(h.defines.VSM_SAMPLES=C.blurSamples,d.defines.VSM_SAMPLES=C.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),C.mapPass===null?C.mapPass=new Ri(s.x,s.y,{format:Ar,type:ns}):(C.mapPass.width!==C.map.width||C.mapPass.height!==C.map.height)&&C.mapPass.setSize(C.map.width,C.map.height),h.uniforms.shadow_pass.value=C.map.depthTexture,h.uniforms.resolution.value.set(C.map.width,C.map.height),h.uniforms.radius.value=C.radius,n.setRenderTarget(C.mapPass),n.clear(),n.renderBufferDirect(_,null,T,h,b,null),d.uniforms.shadow_pass.value=C.mapPass.texture,d.uniforms.resolution.value.set(C.map.width,C.map.height),d.uniforms.radius.value=C.radius,n.setRenderTarget(C.map),n.clear(),n.renderBufferDirect(_,null,T,d,b,null)}function E(C,_,T,k){let U=null,D=T.isPointLight===!0?C.customDistanceMaterial:C.customDepthMaterial;if(D!==void 0)U=D;else if(U=T.isPointLight===!0?l:a,n.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let H=U.uuid,O=_.uuid,I=c[H];I===void 0&&(I={},c[H]=I);let W=I[O];W===void 0&&(W=U.clone(),I[O]=W,_.addEventListener("dispose",L)),U=W}if(U.visible=_.visible,U.wireframe=_.wireframe,k===ta?U.side=_.shadowSide!==null?_.shadowSide:_.side:U.side=_.shadowSide!==null?_.shadowSide:f[_.side],U.alphaMap=_.alphaMap,U.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,U.map=_.map,U.clipShadows=_.clipShadows,U.clippingPlanes=_.clippingPlanes,U.clipIntersection=_.clipIntersection,U.displacementMap=_.displacementMap,U.displacementScale=_.displacementScale,U.displacementBias=_.displacementBias,U.wireframeLinewidth=_.wireframeLinewidth,U.linewidth=_.linewidth,T.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let H=n.properties.get(U);H.light=T}return U}function M(C,_,T,k,U,D){if(C.visible===!1)return;if(C.layers.test(U)&&(C.isMesh||C.isLine||C.isPoints)&&(C.castShadow||C.receiveShadow&&D===ta)&&(!C.frustumCulled||C.intersectsFrustum(i))){C.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,C.matrixWorld);let I=e.update(C),W=C.material;if(Array.isArray(W)){let $=I.groups;for(let G=0,le=$.length;G<le;G++){let Z=$[G],Q=W[Z.materialIndex];if(Q&&Q.visible){let ie=E(C,Q,k,D);C.onBeforeShadow(n,C,_,T,I,ie,Z),n.renderBufferDirect(T,null,I,ie,C,Z),C.onAfterShadow(n,C,_,T,I,ie,Z)}}}else if(W.visible){let $=E(C,W,k,D);C.onBeforeShadow(n,C,_,T,I,$,null),n.renderBufferDirect(T,null,I,$,C,null),C.onAfterShadow(n,C,_,T,I,$,null)}}let O=C.children;for(let I=0,W=O.length;I<W;I++)M(O[I],_,T,k,U,D)}function L(C){C.target.removeEventListener("dispose",L);for(let T in c){let k=c[T],U=C.target.uuid;U in k&&(k[U].dispose(),delete k[U])}}}function ME(n,e){function t(){let F=!1,re=new Pt,ne=null,Te=new Pt(0,0,0,0);return{setMask:function(xe){ne!==xe&&!F&&(n.colorMask(xe,xe,xe,xe),ne=xe)},setLocked:function(xe){F=xe},setClear:function(xe,we,Xe,tt,ce){ce===!0&&(xe*=tt,we*=tt,Xe*=tt),re.set(xe,we,Xe,tt),Te.equals(re)===!1&&(n.clearColor(xe,we,Xe,tt),Te.copy(re))},reset:function(){F=!1,ne=null,Te.set(-1,0,0,0)}}}function i(){let F=!1,re=!1,ne=null,Te=null,xe=null;return{setReversed:function(we){if(re!==we){let Xe=e.get("EXT_clip_control");we?Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.ZERO_TO_ONE_EXT):Xe.clipControlEXT(Xe.LOWER_LEFT_EXT,Xe.NEGATIVE_ONE_TO_ONE_EXT),re=we;let tt=xe;xe=null,this.setClear(tt)}},getReversed:function(){return re},setTest:function(we){we?ve(n.DEPTH_TEST):We(n.DEPTH_TEST)},setMask:function(we){ne!==we&&!F&&(n.depthMask(we),ne=we)},setFunc:function(we){if(re&&(we=Sx[we]),Te!==we){switch(we){case ou:n.depthFunc(n.NEVER);break;case au:n.depthFunc(n.ALWAYS);break;case lu:n.depthFunc(n.LESS);break;case pr:n.depthFunc(n.LEQUAL);break;case cu:n.depthFunc(n.EQUAL);break;case uu:n.depthFunc(n.GEQUAL);break;case hu:n.depthFunc(n.GREATER);break;case du:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Te=we}},setLocked:function(we){F=we},setClear:function(we){xe!==we&&(xe=we,re&&(we=1-we),n.clearDepth(we))},reset:function(){F=!1,ne=null,Te=null,xe=null,re=!1}}}function s(){let F=!1,re=null,ne=null,Te=null,xe=null,we=null,Xe=null,tt=null,ce=null;return{setTest:function(ke){F||(ke?ve(n.STENCIL_TEST):We(n.STENCIL_TEST))},setMask:function(ke){re!==ke&&!F&&(n.stencilMask(ke),re=ke)},setFunc:function(ke,nt,Pe){(ne!==ke||Te!==nt||xe!==Pe)&&(n.stencilFunc(ke,nt,Pe),ne=ke,Te=nt,xe=Pe)},setOp:function(ke,nt,Pe){(we!==ke||Xe!==nt||tt!==Pe)&&(n.stencilOp(ke,nt,Pe),we=ke,Xe=nt,tt=Pe)},setLocked:function(ke){F=ke},setClear:function(ke){ce!==ke&&(n.clearStencil(ke),ce=ke)},reset:function(){F=!1,re=null,ne=null,Te=null,xe=null,we=null,Xe=null,tt=null,ce=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],b=null,g=!1,m=null,v=null,E=null,M=null,L=null,C=null,_=null,T=new dt(0,0,0),k=0,U=!1,D=null,H=null,O=null,I=null,W=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,le=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(le=parseFloat(/^WebGL (\d)/.exec(Z)[1]),G=le>=1):Z.indexOf("OpenGL ES")!==-1&&(le=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),G=le>=2);let Q=null,ie={},de=n.getParameter(n.SCISSOR_BOX),he=n.getParameter(n.VIEWPORT),ee=new Pt().fromArray(de),ge=new Pt().fromArray(he);function _e(F,re,ne,Te){let xe=new Uint8Array(4),we=n.createTexture();n.bindTexture(F,we),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let Xe=0;Xe<ne;Xe++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(re,0,n.RGBA,1,1,Te,0,n.RGBA,n.UNSIGNED_BYTE,xe):n.texImage2D(re+Xe,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,xe);return we}let Re={};Re[n.TEXTURE_2D]=_e(n.TEXTURE_2D,n.TEXTURE_2D,1),Re[n.TEXTURE_CUBE_MAP]=_e(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),Re[n.TEXTURE_2D_ARRAY]=_e(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),Re[n.TEXTURE_3D]=_e(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ve(n.DEPTH_TEST),o.setFunc(pr),un(!1),Ft(zf),ve(n.CULL_FACE),Zt($r);function ve(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function We(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function me(F,re){return h[F]!==re?(n.bindFramebuffer(F,re),h[F]=re,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=re),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=re),!0):!1}function be(F,re){let ne=p,Te=!1;if(F){ne=d.get(re),ne===void 0&&(ne=[],d.set(re,ne));let xe=F.textures;if(ne.length!==xe.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let we=0,Xe=xe.length;we<Xe;we++)ne[we]=n.COLOR_ATTACHMENT0+we;ne.length=xe.length,Te=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Te=!0);Te&&n.drawBuffers(ne)}function je(F){return b!==F?(n.useProgram(F),b=F,!0):!1}let rt={[Yr]:n.FUNC_ADD,[X_]:n.FUNC_SUBTRACT,[q_]:n.FUNC_REVERSE_SUBTRACT};rt[$_]=n.MIN,rt[Y_]=n.MAX;let at={[J_]:n.ZERO,[Z_]:n.ONE,[K_]:n.SRC_COLOR,[Wf]:n.SRC_ALPHA,[ix]:n.SRC_ALPHA_SATURATE,[tx]:n.DST_COLOR,[Q_]:n.DST_ALPHA,[j_]:n.ONE_MINUS_SRC_COLOR,[Xf]:n.ONE_MINUS_SRC_ALPHA,[nx]:n.ONE_MINUS_DST_COLOR,[ex]:n.ONE_MINUS_DST_ALPHA,[sx]:n.CONSTANT_COLOR,[rx]:n.ONE_MINUS_CONSTANT_COLOR,[ox]:n.CONSTANT_ALPHA,[ax]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(F,re,ne,Te,xe,we,Xe,tt,ce,ke){if(F===$r){g===!0&&(We(n.BLEND),g=!1);return}if(g===!1&&(ve(n.BLEND),g=!0),F!==W_){if(F!==m||ke!==U){if((v!==Yr||L!==Yr)&&(n.blendEquation(n.FUNC_ADD),v=Yr,L=Yr),ke)switch(F){case na:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Vf:n.blendFunc(n.ONE,n.ONE);break;case Hf:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Gf:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:st("WebGLState: Invalid blending: ",F);break}else switch(F){case na:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Vf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Hf:st("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Gf:st("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:st("WebGLState: Invalid blending: ",F);break}E=null,M=null,C=null,_=null,T.set(0,0,0),k=0,m=F,U=ke}return}xe=xe||re,we=we||ne,Xe=Xe||Te,(re!==v||xe!==L)&&(n.blendEquationSeparate(rt[re],rt[xe]),v=re,L=xe),(ne!==E||Te!==M||we!==C||Xe!==_)&&(n.blendFuncSeparate(at[ne],at[Te],at[we],at[Xe]),E=ne,M=Te,C=we,_=Xe),(tt.equals(T)===!1||ce!==k)&&(n.blendColor(tt.r,tt.g,tt.b,ce),T.copy(tt),k=ce),m=F,U=!1}function Gt(F,re){F.side===gi?We(n.CULL_FACE):ve(n.CULL_FACE);let ne=F.side===hi;re&&(ne=!ne),un(ne),F.blending===na&&F.transparent===!1?Zt($r):Zt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Te=F.stencilWrite;a.setTest(Te),Te&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),bt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?ve(n.SAMPLE_ALPHA_TO_COVERAGE):We(n.SAMPLE_ALPHA_TO_COVERAGE)}function un(F){D!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),D=F)}function Ft(F){F!==V_?(ve(n.CULL_FACE),F!==H&&(F===zf?n.cullFace(n.BACK):F===H_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):We(n.CULL_FACE),H=F}function Dn(F){F!==O&&(G&&n.lineWidth(F),O=F)}function bt(F,re,ne){F?(ve(n.POLYGON_OFFSET_FILL),(I!==re||W!==ne)&&(I=re,W=ne,o.getReversed()&&(re=-re,ne=-ne),n.polygonOffset(re,ne))):We(n.POLYGON_OFFSET_FILL)}function Sn(F){F?ve(n.SCISSOR_TEST):We(n.SCISSOR_TEST)}function en(F){F===void 0&&(F=n.TEXTURE0+$-1),Q!==F&&(n.activeTexture(F),Q=F)}function hn(F,re,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let Te=ie[ne];Te===void 0&&(Te={type:void 0,texture:void 0},ie[ne]=Te),(Te.type!==F||Te.texture!==re)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(F,re||Re[F]),Te.type=F,Te.texture=re)}function B(){let F=ie[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Ie(){try{n.compressedTexImage2D(...arguments)}catch(F){st("WebGLState:",F)}}function Ze(){try{n.compressedTexImage3D(...arguments)}catch(F){st("WebGLState:",F)}}function ct(){try{n.texSubImage2D(...arguments)}catch(F){st("WebGLState:",F)}}function Ae(){try{n.texSubImage3D(...arguments)}catch(F){st("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){st("WebGLState:",F)}}function He(){try{n.compressedTexSubImage3D(...arguments)}catch(F){st("WebGLState:",F)}}function $e(){try{n.texStorage2D(...arguments)}catch(F){st("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){st("WebGLState:",F)}}function S(){try{n.texImage2D(...arguments)}catch(F){st("WebGLState:",F)}}function q(){try{n.texImage3D(...arguments)}catch(F){st("WebGLState:",F)}}function ue(F){return f[F]!==void 0?f[F]:n.getParameter(F)}function oe(F,re){f[F]!==re&&(n.pixelStorei(F,re),f[F]=re)}function ye(F){ee.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function Se(F){ge.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),ge.copy(F))}function te(F,re){let ne=c.get(re);ne===void 0&&(ne=new WeakMap,c.set(re,ne));let Te=ne.get(F);Te===void 0&&(Te=n.getUniformBlockIndex(re,F.name),n.uniformBlockBinding(re,Te,Te),ne.set(F,Te))}function se(F,re,ne){let xe=c.get(re).get(F);l[xe]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,xe,ne),l[xe]=ne)}function pe(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,ie={},h={},l={},d=new WeakMap,p=[],b=null,g=!1,m=null,v=null,E=null,M=null,L=null,C=null,_=null,T=new dt(0,0,0),k=0,U=!1,D=null,H=null,O=null,I=null,W=null,ee.set(0,0,n.canvas.width,n.canvas.height),ge.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ve,disable:We,bindFramebuffer:me,drawBuffers:be,useProgram:je,setBlending:Zt,setMaterial:Gt,setFlipSided:un,setCullFace:Ft,setLineWidth:Dn,setPolygonOffset:bt,setScissorTest:Sn,activeTexture:en,bindTexture:hn,unbindTexture:B,compressedTexImage2D:Ie,compressedTexImage3D:Ze,texImage2D:S,texImage3D:q,pixelStorei:oe,getParameter:ue,updateUBOMapping:te,uniformBlockBinding:se,texStorage2D:$e,texStorage3D:R,texSubImage2D:ct,texSubImage3D:Ae,compressedTexSubImage2D:zt,compressedTexSubImage3D:He,scissor:ye,viewport:Se,reset:pe}}function wE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ke,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,b=new FinalizationRegistry(R=>p.delete(R)),g=!1;try{g=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function m(R,S){return g?new OffscreenCanvas(R,S):qa("canvas")}function v(R,S,q){let ue=1,oe=$e(R);if((oe.width>q||oe.height>q)&&(ue=q/Math.max(oe.width,oe.height)),ue<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ye=Math.floor(ue*oe.width),Se=Math.floor(ue*oe.height);h===void 0&&(h=m(ye,Se));let te=S?m(ye,Se):h;return te.width=ye,te.height=Se,te.getContext("2d").drawImage(R,0,0,ye,Se),Je("WebGLRenderer: Texture has been resized from ("+oe.width+"x"+oe.height+") to ("+ye+"x"+Se+")."),te}else return"data"in R&&Je("WebGLRenderer: Image in DataTexture is too big ("+oe.width+"x"+oe.height+")."),R;return R}function E(R){return R.generateMipmaps}function M(R){n.generateMipmap(R)}function L(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function C(R,S,q,ue,oe,ye=!1){if(R!==null){if(n[R]!==void 0)return n[R];Je("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let Se;ue&&(Se=e.get("EXT_texture_norm16"),Se||Je("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&Se&&(te=Se.R16_EXT),q===n.SHORT&&Se&&(te=Se.R16_SNORM_EXT)),S===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),S===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&Se&&(te=Se.RG16_EXT),q===n.SHORT&&Se&&(te=Se.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),S===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),S===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),S===n.RGB&&(q===n.UNSIGNED_SHORT&&Se&&(te=Se.RGB16_EXT),q===n.SHORT&&Se&&(te=Se.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),S===n.RGBA){let se=ye?Xa:vt.getTransfer(oe);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=se===Rt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&Se&&(te=Se.RGBA16_EXT),q===n.SHORT&&Se&&(te=Se.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function _(R,S){let q;return R?S===null||S===es||S===Zr?q=n.DEPTH24_STENCIL8:S===ts?q=n.DEPTH32F_STENCIL8:S===sa&&(q=n.DEPTH24_STENCIL8,Je("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===es||S===Zr?q=n.DEPTH_COMPONENT24:S===ts?q=n.DEPTH_COMPONENT32F:S===sa&&(q=n.DEPTH_COMPONENT16),q}function T(R,S){return E(R)===!0||R.isFramebufferTexture&&R.minFilter!==cn&&R.minFilter!==ui?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function k(R){let S=new WeakRef(R);i.get(R).__ref=S,p.add(S),b.register(R,S,S)}function U(R){let S=i.get(R).__ref;S!==void 0&&(p.delete(S),b.unregister(S))}function D(R){O(R.target)}function H(R){I(R.target)}function O(R){R.removeEventListener("dispose",D),U(R),$(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function I(R){R.removeEventListener("dispose",H),U(R),le(R)}function W(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?I(S):O(S))}p.clear(),f.clear()}function $(R){let S=i.get(R);if(S.__webglInit===void 0)return;let q=R.source,ue=d.get(q);if(ue){let oe=ue[S.__cacheKey];oe.usedTimes--,oe.usedTimes===0&&G(R),Object.keys(ue).length===0&&d.delete(q)}i.remove(R)}function G(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let q=R.source,ue=d.get(q);delete ue[S.__cacheKey],o.memory.textures--}function le(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&O(q),R.isWebGLCubeRenderTarget)for(let oe=0;oe<6;oe++){if(Array.isArray(S.__webglFramebuffer[oe]))for(let ye=0;ye<S.__webglFramebuffer[oe].length;ye++)n.deleteFramebuffer(S.__webglFramebuffer[oe][ye]);else n.deleteFramebuffer(S.__webglFramebuffer[oe]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[oe])}else{if(Array.isArray(S.__webglFramebuffer))for(let oe=0;oe<S.__webglFramebuffer.length;oe++)n.deleteFramebuffer(S.__webglFramebuffer[oe]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let oe=0;oe<S.__webglColorRenderbuffer.length;oe++)S.__webglColorRenderbuffer[oe]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[oe]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let ue=R.textures;for(let oe=0,ye=ue.length;oe<ye;oe++){let Se=i.get(ue[oe]);Se.__webglTexture&&(n.deleteTexture(Se.__webglTexture),o.memory.textures--),i.remove(ue[oe])}i.remove(R)}let Z=0;function Q(){Z=0}function ie(){return Z}function de(R){Z=R}function he(){let R=Z;return R>=s.maxTextures&&Je("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,R}function ee(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function ge(R,S){let q=i.get(R);if(R.isVideoTexture&&zt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let ue=R.image;if(ue===null)Je("WebGLRenderer: Texture marked for update but no image data found.");else if(ue.complete===!1)Je("WebGLRenderer: Texture marked for update but image is incomplete");else{Gt(q,R,S);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+S)}function _e(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Gt(q,R,S);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+S)}function Re(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Gt(q,R,S);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+S)}function ve(R,S){let q=i.get(R);if(R.version>0&&q.__version!==R.version){un(q,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+S)}let We={[fu]:n.REPEAT,[ms]:n.CLAMP_TO_EDGE,[pu]:n.MIRRORED_REPEAT},me={[cn]:n.NEAREST,[ux]:n.NEAREST_MIPMAP_NEAREST,[gl]:n.NEAREST_MIPMAP_LINEAR,[ui]:n.LINEAR,[Hu]:n.LINEAR_MIPMAP_NEAREST,[Gs]:n.LINEAR_MIPMAP_LINEAR},be={[px]:n.NEVER,[cp]:n.ALWAYS,[mx]:n.LESS,[ap]:n.LEQUAL,[gx]:n.EQUAL,[lp]:n.GEQUAL,[_x]:n.GREATER,[xx]:n.NOTEQUAL};function je(R,S){if(S.type===ts&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===ui||S.magFilter===Hu||S.magFilter===gl||S.magFilter===Gs||S.minFilter===ui||S.minFilter===Hu||S.minFilter===gl||S.minFilter===Gs)&&Je("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,We[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,We[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,We[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,me[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,me[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,be[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===cn||S.minFilter!==gl&&S.minFilter!==Gs||S.type===ts&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function rt(R,S){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",D),k(S));let ue=S.source,oe=d.get(ue);oe===void 0&&(oe={},d.set(ue,oe));let ye=ee(S);if(ye!==R.__cacheKey){oe[ye]===void 0&&(oe[ye]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),oe[ye].usedTimes++;let Se=oe[R.__cacheKey];Se!==void 0&&(oe[R.__cacheKey].usedTimes--,Se.usedTimes===0&&G(S)),R.__cacheKey=ye,R.__webglTexture=oe[ye].texture}return q}function at(R,S,q){return Math.floor(Math.floor(R/q)/S)}function Zt(R,S,q,ue){let ye=R.updateRanges;if(ye.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,q,ue,S.data);else{ye.sort((F,re)=>F.start-re.start);let Se=0;for(let F=1;F<ye.length;F++){let re=ye[Se],ne=ye[F],Te=re.start+re.count,xe=at(ne.start,S.width,4),we=at(re.start,S.width,4);ne.start<=Te+1&&xe===we&&at(ne.start+ne.count-1,S.width,4)===xe?re.count=Math.max(re.count,ne.start+ne.count-re.start):(++Se,ye[Se]=ne)}ye.length=Se+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),se=t.getParameter(n.UNPACK_SKIP_PIXELS),pe=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let F=0,re=ye.length;F<re;F++){let ne=ye[F],Te=Math.floor(ne.start/4),xe=Math.ceil(ne.count/4),we=Te%S.width,Xe=Math.floor(Te/S.width),tt=xe,ce=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,we),t.pixelStorei(n.UNPACK_SKIP_ROWS,Xe),t.texSubImage2D(n.TEXTURE_2D,0,we,Xe,tt,ce,q,ue,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,se),t.pixelStorei(n.UNPACK_SKIP_ROWS,pe)}}function Gt(R,S,q){let ue=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(ue=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(ue=n.TEXTURE_3D);let oe=rt(R,S),ye=S.source;t.bindTexture(ue,R.__webglTexture,n.TEXTURE0+q);let Se=i.get(ye);if(ye.version!==Se.__version||oe===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let ce=vt.getPrimaries(vt.workingColorSpace),ke=S.colorSpace===Xs?null:vt.getPrimaries(S.colorSpace),nt=S.colorSpace===Xs||ce===ke?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,nt)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let se=v(S.image,!1,s.maxTextureSize);se=He(S,se);let pe=r.convert(S.format,S.colorSpace),F=r.convert(S.type),re=C(S.internalFormat,pe,F,S.normalized,S.colorSpace,S.isVideoTexture);je(ue,S);let ne,Te=S.mipmaps,xe=S.isVideoTexture!==!0,we=Se.__version===void 0||oe===!0,Xe=ye.dataReady,tt=T(S,se);if(S.isDepthTexture)re=_(S.format===Ws,S.type),we&&(xe?t.texStorage2D(n.TEXTURE_2D,1,re,se.width,se.height):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,F,null));else if(S.isDataTexture)if(Te.length>0){xe&&we&&t.texStorage2D(n.TEXTURE_2D,tt,re,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)ne=Te[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data);S.generateMipmaps=!1}else xe?(we&&t.texStorage2D(n.TEXTURE_2D,tt,re,se.width,se.height),Xe&&Zt(S,se,pe,F)):t.texImage2D(n.TEXTURE_2D,0,re,se.width,se.height,0,pe,F,se.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){xe&&we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,re,Te[0].width,Te[0].height,se.depth);for(let ce=0,ke=Te.length;ce<ke;ce++)if(ne=Te[ce],S.format!==Ii)if(pe!==null)if(xe){if(Xe)if(S.layerUpdates.size>0){let nt=yp(ne.width,ne.height,S.format,S.type);for(let Pe of S.layerUpdates){let ht=ne.data.subarray(Pe*nt/ne.data.BYTES_PER_ELEMENT,(Pe+1)*nt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,Pe,ne.width,ne.height,1,pe,ht)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,ne.data,0,0);else Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else xe?Xe&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,ce,0,0,0,ne.width,ne.height,se.depth,pe,F,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,ce,re,ne.width,ne.height,se.depth,0,pe,F,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{xe&&we&&t.texStorage2D(n.TEXTURE_2D,tt,re,Te[0].width,Te[0].height);for(let ce=0,ke=Te.length;ce<ke;ce++)ne=Te[ce],S.format!==Ii?pe!==null?xe?Xe&&t.compressedTexSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,ne.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,ne.width,ne.height,pe,F,ne.data):t.texImage2D(n.TEXTURE_2D,ce,re,ne.width,ne.height,0,pe,F,ne.data)}else if(S.isDataArrayTexture)if(xe){if(we&&t.texStorage3D(n.TEXTURE_2D_ARRAY,tt,re,se.width,se.height,se.depth),Xe)if(S.layerUpdates.size>0){let ce=yp(se.width,se.height,S.format,S.type);for(let ke of S.layerUpdates){let nt=se.data.subarray(ke*ce/se.data.BYTES_PER_ELEMENT,(ke+1)*ce/se.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,ke,se.width,se.height,1,pe,F,nt)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,se.width,se.height,se.depth,pe,F,se.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,re,se.width,se.height,se.depth,0,pe,F,se.data);else if(S.isData3DTexture)xe?(we&&t.texStorage3D(n.TEXTURE_3D,tt,re,se.width,se.height,se.depth),Xe&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,se.width,se.height,se.depth,pe,F,se.data)):t.texImage3D(n.TEXTURE_3D,0,re,se.width,se.height,se.depth,0,pe,F,se.data);else if(S.isFramebufferTexture){if(we)if(xe)t.texStorage2D(n.TEXTURE_2D,tt,re,se.width,se.height);else{let ce=se.width,ke=se.height;for(let nt=0;nt<tt;nt++)t.texImage2D(n.TEXTURE_2D,nt,re,ce,ke,0,pe,F,null),ce>>=1,ke>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let ce=n.canvas;if(ce.hasAttribute("layoutsubtree")||ce.setAttribute("layoutsubtree","true"),se.parentNode!==ce){ce.appendChild(se),f.add(S),ce.onpaint=ke=>{let nt=ke.changedElements;for(let Pe of f)nt.includes(Pe.image)&&(Pe.needsUpdate=!0)},ce.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,se);else{let nt=n.RGBA,Pe=n.RGBA,ht=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,nt,Pe,ht,se)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Te.length>0){if(xe&&we){let ce=$e(Te[0]);t.texStorage2D(n.TEXTURE_2D,tt,re,ce.width,ce.height)}for(let ce=0,ke=Te.length;ce<ke;ce++)ne=Te[ce],xe?Xe&&t.texSubImage2D(n.TEXTURE_2D,ce,0,0,pe,F,ne):t.texImage2D(n.TEXTURE_2D,ce,re,pe,F,ne);S.generateMipmaps=!1}else if(xe){if(we){let ce=$e(se);t.texStorage2D(n.TEXTURE_2D,tt,re,ce.width,ce.height)}Xe&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,pe,F,se)}else t.texImage2D(n.TEXTURE_2D,0,re,pe,F,se);E(S)&&S.mipmapsAutoUpdate===!0&&M(ue),Se.__version=ye.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function un(R,S,q){if(S.image.length!==6)return;let ue=rt(R,S),oe=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let ye=i.get(oe);if(oe.version!==ye.__version||ue===!0){t.activeTexture(n.TEXTURE0+q);let Se=vt.getPrimaries(vt.workingColorSpace),te=S.colorSpace===Xs?null:vt.getPrimaries(S.colorSpace),se=S.colorSpace===Xs||Se===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,se);let pe=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,re=[];for(let Pe=0;Pe<6;Pe++)!pe&&!F?re[Pe]=v(S.image[Pe],!0,s.maxCubemapSize):re[Pe]=F?S.image[Pe].image:S.image[Pe],re[Pe]=He(S,re[Pe]);let ne=re[0],Te=r.convert(S.format,S.colorSpace),xe=r.convert(S.type),we=C(S.internalFormat,Te,xe,S.normalized,S.colorSpace),Xe=S.isVideoTexture!==!0,tt=ye.__version===void 0||ue===!0,ce=oe.dataReady,ke=T(S,ne);je(n.TEXTURE_CUBE_MAP,S);let nt;if(S.isDepthTexture){if(we=_(S.format===Ws,S.type),tt)if(Xe)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,we,ne.width,ne.height);else for(let Pe=0;Pe<6;Pe++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,ne.width,ne.height,0,Te,xe,null)}else if(pe){Xe&&tt&&t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,we,ne.width,ne.height);for(let Pe=0;Pe<6;Pe++){nt=re[Pe].mipmaps;for(let ht=0;ht<nt.length;ht++){let Wt=nt[ht];S.format!==Ii?Te!==null?Xe?ce&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Wt.width,Wt.height,Te,Wt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,we,Wt.width,Wt.height,0,Wt.data):Je("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,0,0,Wt.width,Wt.height,Te,xe,Wt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht,we,Wt.width,Wt.height,0,Te,xe,Wt.data)}}}else{if(nt=S.mipmaps,Xe&&tt){nt.length>0&&ke++;let Pe=$e(re[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,ke,we,Pe.width,Pe.height)}for(let Pe=0;Pe<6;Pe++)if(F){Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,re[Pe].width,re[Pe].height,Te,xe,re[Pe].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,re[Pe].width,re[Pe].height,0,Te,xe,re[Pe].data);for(let ht=0;ht<nt.length;ht++){let ti=nt[ht].image[Pe].image;Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,ti.width,ti.height,Te,xe,ti.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,we,ti.width,ti.height,0,Te,xe,ti.data)}}else{Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,0,0,Te,xe,re[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,0,we,Te,xe,re[Pe]);for(let ht=0;ht<nt.length;ht++){let Wt=nt[ht];Xe?ce&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,0,0,Te,xe,Wt.image[Pe]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Pe,ht+1,we,Te,xe,Wt.image[Pe])}}}E(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),ye.__version=oe.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Ft(R,S,q,ue,oe,ye){let Se=r.convert(q.format,q.colorSpace),te=r.convert(q.type),se=C(q.internalFormat,Se,te,q.normalized,q.colorSpace),pe=i.get(S),F=i.get(q);if(F.__renderTarget=S,!pe.__hasExternalTextures){let re=Math.max(1,S.width>>ye),ne=Math.max(1,S.height>>ye);oe===n.TEXTURE_3D||oe===n.TEXTURE_2D_ARRAY?t.texImage3D(oe,ye,se,re,ne,S.depth,0,Se,te,null):t.texImage2D(oe,ye,se,re,ne,0,Se,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),Ae(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ue,oe,F.__webglTexture,0,ct(S)):(oe===n.TEXTURE_2D||oe>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&oe<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,ue,oe,F.__webglTexture,ye),t.bindFramebuffer(n.FRAMEBUFFER,null)}function Dn(R,S,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let ue=S.depthTexture,oe=ue&&ue.isDepthTexture?ue.type:null,ye=_(S.stencilBuffer,oe),Se=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;Ae(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(S),ye,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(S),ye,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ye,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,Se,n.RENDERBUFFER,R)}else{let ue=S.textures;for(let oe=0;oe<ue.length;oe++){let ye=ue[oe],Se=r.convert(ye.format,ye.colorSpace),te=r.convert(ye.type),se=C(ye.internalFormat,Se,te,ye.normalized,ye.colorSpace);Ae(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,ct(S),se,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,ct(S),se,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,se,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(R,S,q){let ue=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let oe=i.get(S.depthTexture);oe.__renderTarget=S;let ye=ue?S.depthTexture.image[0]:S.depthTexture.image;(!oe.__webglTexture||ye.width!==S.width||ye.height!==S.height)&&(ye.width=S.width,ye.height=S.height,S.depthTexture.needsUpdate=!0),ue?ve(S.depthTexture,0):ge(S.depthTexture,0);let Se=oe.__webglTexture,te=ct(S),se=ue?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,pe=S.depthTexture.format===Ws?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===zs)Ae(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,Se,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,Se,0);else if(S.depthTexture.format===Ws)Ae(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,pe,se,Se,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,pe,se,Se,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function Sn(R){let S=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let ue=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),ue){let oe=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,ue.removeEventListener("dispose",oe)};ue.addEventListener("dispose",oe),S.__depthDisposeCallback=oe}S.__boundDepthTexture=ue}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let ue=0;ue<6;ue++)bt(S.__webglFramebuffer[ue],R,ue);else R.texture.mipmaps.length>0?bt(S.__webglFramebuffer[0],R,0):bt(S.__webglFramebuffer,R,0);else if(q){S.__webglDepthbuffer=[];for(let ue=0;ue<6;ue++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[ue]),S.__webglDepthbuffer[ue]===void 0)S.__webglDepthbuffer[ue]=n.createRenderbuffer(),Dn(S.__webglDepthbuffer[ue],R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=S.__webglDepthbuffer[ue];n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),Dn(S.__webglDepthbuffer,R,!1);else{let oe=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ye=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ye),n.framebufferRenderbuffer(n.FRAMEBUFFER,oe,n.RENDERBUFFER,ye)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function en(R,S,q){let ue=i.get(R);S!==void 0&&Ft(ue.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&Sn(R)}function hn(R){let S=R.texture,q=i.get(R),ue=i.get(S);R.addEventListener("dispose",H),k(R);let oe=R.textures,ye=R.isWebGLCubeRenderTarget===!0,Se=oe.length>1;if(Se||(ue.__webglTexture===void 0&&(ue.__webglTexture=n.createTexture()),ue.__version=S.version,o.memory.textures++),ye){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let se=0;se<S.mipmaps.length;se++)q.__webglFramebuffer[te][se]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(Se)for(let te=0,se=oe.length;te<se;te++){let pe=i.get(oe[te]);pe.__webglTexture===void 0&&(pe.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&Ae(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<oe.length;te++){let se=oe[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let pe=r.convert(se.format,se.colorSpace),F=r.convert(se.type),re=C(se.internalFormat,pe,F,se.normalized,se.colorSpace,R.isXRRenderTarget===!0),ne=ct(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,re,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),Dn(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ye){t.bindTexture(n.TEXTURE_CUBE_MAP,ue.__webglTexture),je(n.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Ft(q.__webglFramebuffer[te][se],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,se);else Ft(q.__webglFramebuffer[te],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);E(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(Se){for(let te=0,se=oe.length;te<se;te++){let pe=oe[te],F=i.get(pe),re=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(re=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(re,F.__webglTexture),je(re,pe),Ft(q.__webglFramebuffer,R,pe,n.COLOR_ATTACHMENT0+te,re,0),E(pe)&&M(re)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,ue.__webglTexture),je(te,S),S.mipmaps.length>0)for(let se=0;se<S.mipmaps.length;se++)Ft(q.__webglFramebuffer[se],R,S,n.COLOR_ATTACHMENT0,te,se);else Ft(q.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,te,0);E(S)?M(te):S.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&Sn(R)}function B(R){let S=R.textures;for(let q=0,ue=S.length;q<ue;q++){let oe=S[q];if(E(oe)&&oe.mipmapsAutoUpdate===!0){let ye=L(R),Se=i.get(oe).__webglTexture;t.bindTexture(ye,Se),M(ye),t.unbindTexture()}}}let Ie=[];function Ze(R){if(R.samples>0){if(Ae(R)===!1){let S=R.textures,q=R.width,ue=R.height,oe=n.COLOR_BUFFER_BIT,ye=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,Se=i.get(R),te=S.length>1;if(te)for(let pe=0;pe<S.length;pe++)t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,Se.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglFramebuffer);for(let pe=0;pe<S.length;pe++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(oe|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(oe|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,Se.__webglColorRenderbuffer[pe]);let F=i.get(S[pe]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,q,ue,0,0,q,ue,oe,n.NEAREST),l===!0&&(Ie.length=0,Ie.push(n.COLOR_ATTACHMENT0+pe),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Ie.push(ye),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Ie))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let pe=0;pe<S.length;pe++){t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.RENDERBUFFER,Se.__webglColorRenderbuffer[pe]);let F=i.get(S[pe]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,Se.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+pe,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,Se.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function ct(R){return Math.min(s.maxSamples,R.samples)}function Ae(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function zt(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function He(R,S){let q=R.colorSpace,ue=R.format,oe=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==Wa&&q!==Xs&&(vt.getTransfer(q)===Rt?(ue!==Ii||oe!==_i)&&Je("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):st("WebGLTextures: Unsupported texture color space:",q)),S}function $e(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=he,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=de,this.setTexture2D=ge,this.setTexture2DArray=_e,this.setTexture3D=Re,this.setTextureCube=ve,this.rebindTextures=en,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Ze,this.setupDepthRenderbuffer=Sn,this.setupFrameBufferTexture=Ft,this.useMultisampledRTT=Ae,this.dispose=W}function AE(n,e){function t(i,s=Xs){let r,o=vt.getTransfer(s);if(i===_i)return n.UNSIGNED_BYTE;if(i===Wu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Xu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===np)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===ip)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===ep)return n.BYTE;if(i===tp)return n.SHORT;if(i===sa)return n.UNSIGNED_SHORT;if(i===Gu)return n.INT;if(i===es)return n.UNSIGNED_INT;if(i===ts)return n.FLOAT;if(i===ns)return n.HALF_FLOAT;if(i===sp)return n.ALPHA;if(i===rp)return n.RGB;if(i===Ii)return n.RGBA;if(i===zs)return n.DEPTH_COMPONENT;if(i===Ws)return n.DEPTH_STENCIL;if(i===op)return n.RED;if(i===qu)return n.RED_INTEGER;if(i===Ar)return n.RG;if(i===$u)return n.RG_INTEGER;if(i===Yu)return n.RGBA_INTEGER;if(i===_l||i===xl||i===yl||i===vl)if(o===Rt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===_l)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===_l)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===yl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===vl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Ju||i===Zu||i===Ku||i===ju)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Ju)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===Zu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Ku)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===ju)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Qu||i===eh||i===th||i===nh||i===ih||i===bl||i===sh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Qu||i===eh)return o===Rt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===th)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===nh)return r.COMPRESSED_R11_EAC;if(i===ih)return r.COMPRESSED_SIGNED_R11_EAC;if(i===bl)return r.COMPRESSED_RG11_EAC;if(i===sh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===rh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh||i===dh||i===fh||i===ph||i===mh||i===gh||i===_h||i===xh)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===rh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===oh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ah)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===lh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===ch)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===uh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===hh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===dh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===fh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===ph)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===mh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===gh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===_h)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===xh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===yh||i===vh||i===bh)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===yh)return o===Rt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===vh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===bh)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===Sh||i===Mh||i===Sl||i===wh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===Sh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===Mh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Sl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===wh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Zr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var TE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,EE=`
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

}`,Cp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new nl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new zi({vertexShader:TE,fragmentShader:EE,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Gn(new il(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Rp=class extends ji{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,b=typeof XRWebGLBinding<"u",g=new Cp,m={},v=t.getContextAttributes(),E=null,M=null,L=[],C=[],_=new Ke,T=null,k=null,U=new ci;U.viewport=new Pt;let D=new ci;D.viewport=new Pt;let H=[U,D],O=new Bu,I=null,W=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let ge=L[ee];return ge===void 0&&(ge=new Yo,L[ee]=ge),ge.getTargetRaySpace()},this.getControllerGrip=function(ee){let ge=L[ee];return ge===void 0&&(ge=new Yo,L[ee]=ge),ge.getGripSpace()},this.getHand=function(ee){let ge=L[ee];return ge===void 0&&(ge=new Yo,L[ee]=ge),ge.getHandSpace()};function $(ee){let ge=C.indexOf(ee.inputSource);if(ge===-1)return;let _e=L[ge];_e!==void 0&&(_e.update(ee.inputSource,ee.frame,c||o),_e.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",le);for(let ee=0;ee<L.length;ee++){let ge=C[ee];ge!==null&&(C[ee]=null,L[ee].disconnect(ge))}I=null,W=null,g.reset();for(let ee in m)delete m[ee];if(e.setRenderTarget(E),d=null,h=null,f=null,s=null,M=null,he.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(_.width,_.height,!1),k!==null){let ee=k.camera;ee.fov=k.fov,ee.zoom=k.zoom,ee.updateProjectionMatrix(),k=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&Je("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&b&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(E=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",le),v.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(_),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let _e=null,Re=null,ve=null;v.depth&&(ve=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,_e=v.stencil?Ws:zs,Re=v.stencil?Zr:es);let We={colorFormat:t.RGBA8,depthFormat:ve,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(We),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),M=new Ri(h.textureWidth,h.textureHeight,{format:Ii,type:_i,depthTexture:new Hs(h.textureWidth,h.textureHeight,Re,void 0,void 0,void 0,void 0,void 0,void 0,_e),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let _e={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,_e),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new Ri(d.framebufferWidth,d.framebufferHeight,{format:Ii,type:_i,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),he.setContext(s),he.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return g.getDepthTexture()};function le(ee){for(let ge=0;ge<ee.removed.length;ge++){let _e=ee.removed[ge],Re=C.indexOf(_e);Re>=0&&(C[Re]=null,L[Re].disconnect(_e))}for(let ge=0;ge<ee.added.length;ge++){let _e=ee.added[ge],Re=C.indexOf(_e);if(Re===-1){for(let We=0;We<L.length;We++)if(We>=C.length){C.push(_e),Re=We;break}else if(C[We]===null){C[We]=_e,Re=We;break}if(Re===-1)break}let ve=L[Re];ve&&ve.connect(_e)}}function Z(ee,ge){ge===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(ge.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let ge=ee.near,_e=ee.far;g.texture!==null&&(g.depthNear>0&&(ge=g.depthNear),g.depthFar>0&&(_e=g.depthFar)),O.near=D.near=U.near=ge,O.far=D.far=U.far=_e,(I!==O.near||W!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),I=O.near,W=O.far),O.layers.mask=ee.layers.mask|6,U.layers.mask=O.layers.mask&-5,D.layers.mask=O.layers.mask&-3;let Re=ee.parent,ve=O.cameras;Z(O,Re);for(let We=0;We<ve.length;We++)Z(ve[We],Re);O.projectionMatrix.copy(U.projectionMatrix),O.projectionMatrixInverse.copy(U.projectionMatrixInverse),k===null&&ee.isPerspectiveCamera&&(k={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,O,Re)};function Q(ee,ge,_e){_e===null?ee.matrix.copy(ge.matrixWorld):(ee.matrix.copy(_e.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(ge.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(ge.projectionMatrix),ee.projectionMatrixInverse.copy(ge.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=qo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return g.texture!==null},this.getDepthSensingMesh=function(){return g.getMesh(O)},this.getCameraTexture=function(ee){return m[ee]};let ie=null;function de(ee,ge){if(u=ge.getViewerPose(c||o),p=ge,u!==null){let _e=u.views;d!==null&&(e.setRenderTargetFramebuffer(M,d.framebuffer),e.setRenderTarget(M));let Re=!1;_e.length!==O.cameras.length&&(O.cameras.length=0,Re=!0);for(let be=0;be<_e.length;be++){let je=_e[be],rt=null;if(d!==null)rt=d.getViewport(je);else{let Zt=f.getViewSubImage(h,je);rt=Zt.viewport,be===0&&(e.setRenderTargetTextures(M,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(M))}let at=H[be];at===void 0&&(at=new ci,at.layers.enable(be),at.viewport=new Pt,H[be]=at),at.matrix.fromArray(je.transform.matrix),at.matrix.decompose(at.position,at.quaternion,at.scale),at.projectionMatrix.fromArray(je.projectionMatrix),at.projectionMatrixInverse.copy(at.projectionMatrix).invert(),at.viewport.set(rt.x,rt.y,rt.width,rt.height),be===0&&(O.matrix.copy(at.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),Re===!0&&O.cameras.push(at)}let ve=s.enabledFeatures;if(ve&&ve.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){f=i.getBinding();let be=f.getDepthInformation(_e[0]);be&&be.isValid&&be.texture&&g.init(be,s.renderState)}if(ve&&ve.includes("camera-access")&&b){e.state.unbindTexture(),f=i.getBinding();for(let be=0;be<_e.length;be++){let je=_e[be].camera;if(je){let rt=m[je];rt||(rt=new nl,m[je]=rt);let at=f.getCameraImage(je);rt.sourceTexture=at}}}}for(let _e=0;_e<L.length;_e++){let Re=C[_e],ve=L[_e];Re!==null&&ve!==void 0&&ve.update(Re,ge,c||o)}ie&&ie(ee,ge),ge.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:ge}),p=null}let he=new $x;he.setAnimationLoop(de),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},CE=new St,iy=new ot;iy.set(-1,0,0,0,1,0,0,0,1);function RE(n,e){function t(g,m){g.matrixAutoUpdate===!0&&g.updateMatrix(),m.value.copy(g.matrix)}function i(g,m){m.color.getRGB(g.fogColor.value,gp(n)),m.isFog?(g.fogNear.value=m.near,g.fogFar.value=m.far):m.isFogExp2&&(g.fogDensity.value=m.density)}function s(g,m,v,E,M){m.isNodeMaterial?m.uniformsNeedUpdate=!1:m.isMeshBasicMaterial?r(g,m):m.isMeshLambertMaterial?(r(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshToonMaterial?(r(g,m),f(g,m)):m.isMeshPhongMaterial?(r(g,m),u(g,m),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)):m.isMeshStandardMaterial?(r(g,m),h(g,m),m.isMeshPhysicalMaterial&&d(g,m,M)):m.isMeshMatcapMaterial?(r(g,m),p(g,m)):m.isMeshDepthMaterial?r(g,m):m.isMeshDistanceMaterial?(r(g,m),b(g,m)):m.isMeshNormalMaterial?r(g,m):m.isLineBasicMaterial?(o(g,m),m.isLineDashedMaterial&&a(g,m)):m.isPointsMaterial?l(g,m,v,E):m.isSpriteMaterial?c(g,m):m.isShadowMaterial?(g.color.value.copy(m.color),g.opacity.value=m.opacity):m.isShaderMaterial&&(m.uniformsNeedUpdate=!1)}function r(g,m){g.opacity.value=m.opacity,m.color&&g.diffuse.value.copy(m.color),m.emissive&&g.emissive.value.copy(m.emissive).multiplyScalar(m.emissiveIntensity),m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.bumpMap&&(g.bumpMap.value=m.bumpMap,t(m.bumpMap,g.bumpMapTransform),g.bumpScale.value=m.bumpScale,m.side===hi&&(g.bumpScale.value*=-1)),m.normalMap&&(g.normalMap.value=m.normalMap,t(m.normalMap,g.normalMapTransform),g.normalScale.value.copy(m.normalScale),m.side===hi&&g.normalScale.value.negate()),m.displacementMap&&(g.displacementMap.value=m.displacementMap,t(m.displacementMap,g.displacementMapTransform),g.displacementScale.value=m.displacementScale,g.displacementBias.value=m.displacementBias),m.emissiveMap&&(g.emissiveMap.value=m.emissiveMap,t(m.emissiveMap,g.emissiveMapTransform)),m.specularMap&&(g.specularMap.value=m.specularMap,t(m.specularMap,g.specularMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest);let v=e.get(m),E=v.envMap,M=v.envMapRotation;E&&(g.envMap.value=E,g.envMapRotation.value.setFromMatrix4(CE.makeRotationFromEuler(M)).transpose(),E.isCubeTexture&&E.isRenderTargetTexture===!1&&g.envMapRotation.value.premultiply(iy),g.reflectivity.value=m.reflectivity,g.ior.value=m.ior,g.refractionRatio.value=m.refractionRatio),m.lightMap&&(g.lightMap.value=m.lightMap,g.lightMapIntensity.value=m.lightMapIntensity,t(m.lightMap,g.lightMapTransform)),m.aoMap&&(g.aoMap.value=m.aoMap,g.aoMapIntensity.value=m.aoMapIntensity,t(m.aoMap,g.aoMapTransform))}function o(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform))}function a(g,m){g.dashSize.value=m.dashSize,g.totalSize.value=m.dashSize+m.gapSize,g.scale.value=m.scale}function l(g,m,v,E){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.size.value=m.size*v,g.scale.value=E*.5,m.map&&(g.map.value=m.map,t(m.map,g.uvTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function c(g,m){g.diffuse.value.copy(m.color),g.opacity.value=m.opacity,g.rotation.value=m.rotation,m.map&&(g.map.value=m.map,t(m.map,g.mapTransform)),m.alphaMap&&(g.alphaMap.value=m.alphaMap,t(m.alphaMap,g.alphaMapTransform)),m.alphaTest>0&&(g.alphaTest.value=m.alphaTest)}function u(g,m){g.specular.value.copy(m.specular),g.shininess.value=Math.max(m.shininess,1e-4)}function f(g,m){m.gradientMap&&(g.gradientMap.value=m.gradientMap)}function h(g,m){g.metalness.value=m.metalness,m.metalnessMap&&(g.metalnessMap.value=m.metalnessMap,t(m.metalnessMap,g.metalnessMapTransform)),g.roughness.value=m.roughness,m.roughnessMap&&(g.roughnessMap.value=m.roughnessMap,t(m.roughnessMap,g.roughnessMapTransform)),m.envMap&&(g.envMapIntensity.value=m.envMapIntensity)}function d(g,m,v){g.ior.value=m.ior,m.diffuseRoughness>0&&(g.diffuseRoughness.value=m.diffuseRoughness,m.diffuseRoughnessMap&&(g.diffuseRoughnessMap.value=m.diffuseRoughnessMap,t(m.diffuseRoughnessMap,g.diffuseRoughnessMapTransform))),m.sheen>0&&(g.sheenColor.value.copy(m.sheenColor).multiplyScalar(m.sheen),g.sheenRoughness.value=m.sheenRoughness,m.sheenColorMap&&(g.sheenColorMap.value=m.sheenColorMap,t(m.sheenColorMap,g.sheenColorMapTransform)),m.sheenRoughnessMap&&(g.sheenRoughnessMap.value=m.sheenRoughnessMap,t(m.sheenRoughnessMap,g.sheenRoughnessMapTransform))),m.clearcoat>0&&(g.clearcoat.value=m.clearcoat,g.clearcoatRoughness.value=m.clearcoatRoughness,m.clearcoatMap&&(g.clearcoatMap.value=m.clearcoatMap,t(m.clearcoatMap,g.clearcoatMapTransform)),m.clearcoatRoughnessMap&&(g.clearcoatRoughnessMap.value=m.clearcoatRoughnessMap,t(m.clearcoatRoughnessMap,g.clearcoatRoughnessMapTransform)),m.clearcoatNormalMap&&(g.clearcoatNormalMap.value=m.clearcoatNormalMap,t(m.clearcoatNormalMap,g.clearcoatNormalMapTransform),g.clearcoatNormalScale.value.copy(m.clearcoatNormalScale),m.side===hi&&g.clearcoatNormalScale.value.negate())),m.dispersion>0&&(g.dispersion.value=m.dispersion),m.retroreflectivity>0&&(g.retroreflectivity.value=m.retroreflectivity),m.iridescence>0&&(g.iridescence.value=m.iridescence,g.iridescenceIOR.value=m.iridescenceIOR,g.iridescenceThicknessMinimum.value=m.iridescenceThicknessMinimum,g.iridescenceThicknessMaximum.value=m.iridescenceThicknessMaximum,m.iridescenceMap&&(g.iridescenceMap.value=m.iridescenceMap,t(m.iridescenceMap,g.iridescenceMapTransform)),m.iridescenceThicknessMap&&(g.iridescenceThicknessMap.value=m.iridescenceThicknessMap,t(m.iridescenceThicknessMap,g.iridescenceThicknessMapTransform))),m.transmission>0&&(g.transmission.value=m.transmission,g.transmissionSamplerMap.value=v.texture,g.transmissionSamplerSize.value.set(v.width,v.height),m.transmissionMap&&(g.transmissionMap.value=m.transmissionMap,t(m.transmissionMap,g.transmissionMapTransform)),g.thickness.value=m.thickness,m.thicknessMap&&(g.thicknessMap.value=m.thicknessMap,t(m.thicknessMap,g.thicknessMapTransform)),g.attenuationDistance.value=m.attenuationDistance,g.attenuationColor.value.copy(m.attenuationColor)),m.anisotropy>0&&(g.anisotropyVector.value.set(m.anisotropy*Math.cos(m.anisotropyRotation),m.anisotropy*Math.sin(m.anisotropyRotation)),m.anisotropyMap&&(g.anisotropyMap.value=m.anisotropyMap,t(m.anisotropyMap,g.anisotropyMapTransform))),g.specularIntensity.value=m.specularIntensity,g.specularColor.value.copy(m.specularColor),m.specularColorMap&&(g.specularColorMap.value=m.specularColorMap,t(m.specularColorMap,g.specularColorMapTransform)),m.specularIntensityMap&&(g.specularIntensityMap.value=m.specularIntensityMap,t(m.specularIntensityMap,g.specularIntensityMapTransform))}function p(g,m){m.matcap&&(g.matcap.value=m.matcap)}function b(g,m){let v=e.get(m).light;g.referencePosition.value.setFromMatrixPosition(v.matrixWorld),g.nearDistance.value=v.shadow.camera.near,g.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function PE(n,e,t,i){let s={},r={};function o(v,E){let M=E.program;i.uniformBlockBinding(v,M,s[v.id])}function a(v,E){let M=s[v.id];M===void 0&&(p(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",g));let L=E.program;i.updateUBOMapping(v,L);let C=e.render.frame;r[v.id]!==C&&(c(v),r[v.id]=C)}function l(v){let E=n.createBuffer(),M=v.__size,L=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,E),n.bufferData(n.UNIFORM_BUFFER,M,L),n.bindBuffer(n.UNIFORM_BUFFER,null),E}function c(v){let E=s[v.id],M=v.uniforms,L=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,E);for(let C=0,_=M.length;C<_;C++){let T=M[C];if(Array.isArray(T))for(let k=0,U=T.length;k<U;k++)u(T[k],C,k,L);else u(T,C,0,L)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,E,M,L){if(h(v,E,M,L)===!0){let C=v.__offset,_=v.value;if(Array.isArray(_)){let T=0;for(let k=0;k<_.length;k++){let U=_[k],D=b(U,!0);f(U,v.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(_,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,C,v.__data)}}function f(v,E,M){typeof v=="number"||typeof v=="boolean"?E[M]=v:v.isMatrix3?(E[M]=v.elements[0],E[M+1]=v.elements[1],E[M+2]=v.elements[2],E[M+3]=0,E[M+4]=v.elements[3],E[M+5]=v.elements[4],E[M+6]=v.elements[5],E[M+7]=0,E[M+8]=v.elements[6],E[M+9]=v.elements[7],E[M+10]=v.elements[8],E[M+11]=0):ArrayBuffer.isView(v)?E.set(v.subarray(0,E.length-M),M):v.toArray(E,M)}function h(v,E,M,L){let C=v.value,_=E+"_"+M;if(Array.isArray(C)){L[_]===void 0&&(L[_]=[]);let T=L[_],k=!1;for(let U=0;U<C.length;U++)d(C[U],T,U)===!0&&(k=!0);return k}return d(C,L,_)}function d(v,E,M){if(E[M]===void 0)return typeof v=="number"||typeof v=="boolean"?E[M]=v:ArrayBuffer.isView(v)?E[M]=v.slice():E[M]=v.clone(),!0;{let L=E[M];if(typeof v=="number"||typeof v=="boolean"){if(L!==v)return E[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(L.equals(v)===!1)return L.copy(v),!0}}return!1}function p(v){let E=v.uniforms,M=0,L=16;for(let _=0,T=E.length;_<T;_++){let k=Array.isArray(E[_])?E[_]:[E[_]];for(let U=0,D=k.length;U<D;U++){let H=k[U],O=Array.isArray(H.value)?H.value:[H.value],I=Array.isArray(E[_])||Array.isArray(H.value),W=M;for(let G=0,le=O.length;G<le;G++){let Z=O[G],Q=b(Z,I),ie=M%L,de=ie%Q.boundary,he=ie+de;M+=de,he!==0&&L-he<Q.storage&&(M+=L-he),G===0&&(W=M),M+=Q.storage}let $=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new $((M-W)/Float32Array.BYTES_PER_ELEMENT),H.__offset=W}}let C=M%L;return C>0&&(M+=L-C),v.__size=M,v.__cache={},this}function b(v,E){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?Je("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):Je("WebGLRenderer: Unsupported uniform value type.",v),E===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function g(v){let E=v.target;E.removeEventListener("dispose",g),n.deleteBuffer(s[E.id]),delete s[E.id],delete r[E.id]}function m(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:m}}var IE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),xs=null;function LE(){return xs===null&&(xs=new Zo(IE,16,16,Ar,ns),xs.name="DFG_LUT",xs.minFilter=ui,xs.magFilter=ui,xs.wrapS=ms,xs.wrapT=ms,xs.generateMipmaps=!1,xs.needsUpdate=!0),xs}var Ph=class{constructor(e={}){let{canvas:t=yx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=_i}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let b=d,g=new Set([Yu,$u,qu]),m=new Set([_i,es,sa,Zr,Wu,Xu]),v=new Uint32Array(4),E=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},L=null,C=null,_=[],T=[],k=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=_s,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,H=null,O=null,I=null,W=null;this._outputColorSpace=kn;let $=0,G=0,le=null,Z=-1,Q=null,ie=new Pt,de=new Pt,he=null,ee=new dt(0),ge=0,_e=t.width,Re=t.height,ve=1,We=null,me=null,be=new Pt(0,0,_e,Re),je=new Pt(0,0,_e,Re),rt=!1,at=new gr,Zt=new vu,Gt=!1,un=!1,Ft=new St,Dn=new V,bt=new Pt,Sn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function hn(){return le===null?ve:1}let B=i;function Ie(A,z){return t.getContext(A,z)}let Ze,ct,Ae,zt,He,$e,R,S,q,ue,oe,ye,Se,te,se,pe,F,re,ne,Te,xe,we,Xe;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",ke,!1),t.addEventListener("webglcontextrestored",nt,!1),t.addEventListener("webglcontextcreationerror",Pe,!1),B===null){let z="webgl2";if(B=Ie(z,A),B===null)throw Ie(z)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}tt()}catch(A){throw t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),st("WebGLRenderer: "+A.message),A}function tt(){Ze=new GA(B),Ze.init(),xe=new AE(B,Ze),ct=new LA(B,Ze,e,xe),Ae=new ME(B,Ze),ct.reversedDepthBuffer&&h&&Ae.buffers.depth.setReversed(!0),O=B.createFramebuffer(),I=B.createFramebuffer(),W=B.createFramebuffer(),zt=new qA(B),He=new cE,$e=new wE(B,Ze,Ae,He,ct,xe,zt),R=new HA(U),S=new YM(B),we=new PA(B,S),q=new WA(B,S,zt,we),ue=new YA(B,q,S,we,zt),re=new $A(B,ct,$e),se=new DA(He),oe=new lE(U,R,Ze,ct,we,se),ye=new RE(U,He),Se=new hE,te=new _E(Ze),F=new RA(U,R,Ae,ue,p,l),pe=new SE(U,ue,ct),Xe=new PE(B,zt,ct,Ae),ne=new IA(B,Ze,zt),Te=new XA(B,Ze,zt),zt.programs=oe.programs,U.capabilities=ct,U.extensions=Ze,U.properties=He,U.renderLists=Se,U.shadowMap=pe,U.state=Ae,U.info=zt}b!==_i&&(k=new ZA(b,t.width,t.height,a,s,r));let ce=new Rp(U,B);this.xr=ce,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Ze.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Ze.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return ve},this.setPixelRatio=function(A){A!==void 0&&(ve=A,this.setSize(_e,Re,!1))},this.getSize=function(A){return A.set(_e,Re)},this.setSize=function(A,z,j=!0){if(ce.isPresenting){Je("WebGLRenderer: Can't change size while VR device is presenting.");return}_e=A,Re=z,t.width=Math.floor(A*ve),t.height=Math.floor(z*ve),j===!0&&(t.style.width=A+"px",t.style.height=z+"px"),k!==null&&k.setSize(t.width,t.height),this.setViewport(0,0,A,z)},this.getDrawingBufferSize=function(A){return A.set(_e*ve,Re*ve).floor()},this.setDrawingBufferSize=function(A,z,j){_e=A,Re=z,ve=j,t.width=Math.floor(A*j),t.height=Math.floor(z*j),this.setViewport(0,0,A,z)},this.setEffects=function(A){if(b===_i){st("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let z=0;z<A.length;z++)if(A[z].isOutputPass===!0){Je("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}k.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ie)},this.getViewport=function(A){return A.copy(be)},this.setViewport=function(A,z,j,Y){A.isVector4?be.set(A.x,A.y,A.z,A.w):be.set(A,z,j,Y),Ae.viewport(ie.copy(be).multiplyScalar(hn()).round())},this.getScissor=function(A){return A.copy(je)},this.setScissor=function(A,z,j,Y){A.isVector4?je.set(A.x,A.y,A.z,A.w):je.set(A,z,j,Y),Ae.scissor(de.copy(je).multiplyScalar(hn()).round())},this.getScissorTest=function(){return rt},this.setScissorTest=function(A){Ae.setScissorTest(rt=A)},this.setOpaqueSort=function(A){We=A},this.setTransparentSort=function(A){me=A},this.getClearColor=function(A){return A.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(A=!0,z=!0,j=!0){let Y=0;if(A){let J=!1;if(le!==null){let Ee=le.texture.format;J=g.has(Ee)}if(J){let Ee=le.texture.type,De=m.has(Ee),Ce=F.getClearColor(),Ne=F.getClearAlpha(),Ve=Ce.r,it=Ce.g,mt=Ce.b;De?(v[0]=Ve,v[1]=it,v[2]=mt,v[3]=Ne,B.clearBufferuiv(B.COLOR,0,v)):(E[0]=Ve,E[1]=it,E[2]=mt,E[3]=Ne,B.clearBufferiv(B.COLOR,0,E))}else Y|=B.COLOR_BUFFER_BIT}z&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),H=A},this.dispose=function(){t.removeEventListener("webglcontextlost",ke,!1),t.removeEventListener("webglcontextrestored",nt,!1),t.removeEventListener("webglcontextcreationerror",Pe,!1),F.dispose(),Se.dispose(),te.dispose(),$e.dispose(),He.dispose(),R.dispose(),ue.dispose(),q.dispose(),we.dispose(),Xe.dispose(),oe.dispose(),ce.dispose(),ce.removeEventListener("sessionstart",Ll),ce.removeEventListener("sessionend",is),Ss.stop()};function ke(A){A.preventDefault(),$a("WebGLRenderer: Context Lost."),D=!0}function nt(){$a("WebGLRenderer: Context Restored."),D=!1;let A=zt.autoReset,z=pe.enabled,j=pe.autoUpdate,Y=pe.needsUpdate,J=pe.type;tt(),zt.autoReset=A,pe.enabled=z,pe.autoUpdate=j,pe.needsUpdate=Y,pe.type=J}function Pe(A){st("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ht(A){let z=A.target;z.removeEventListener("dispose",ht),Wt(z)}function Wt(A){ti(A),He.remove(A)}function ti(A){let z=He.get(A).programs;z!==void 0&&(z.forEach(function(j){oe.releaseProgram(j)}),A.isShaderMaterial&&oe.releaseShaderCache(A))}this.renderBufferDirect=function(A,z,j,Y,J,Ee){z===null&&(z=Sn);let De=J.isMesh&&J.matrixWorld.determinantAffine()<0,Ce=fa(A,z,j,Y,J);Ae.setMaterial(Y,De);let Ne=j.index,Ve=1;if(Y.wireframe===!0){if(Ne=q.getWireframeAttribute(j),Ne===void 0)return;Ve=2}let it=j.drawRange,mt=j.attributes.position,ze=it.start*Ve,gt=(it.start+it.count)*Ve;Ee!==null&&(ze=Math.max(ze,Ee.start*Ve),gt=Math.min(gt,(Ee.start+Ee.count)*Ve)),Ne!==null?(ze=Math.max(ze,0),gt=Math.min(gt,Ne.count)):mt!=null&&(ze=Math.max(ze,0),gt=Math.min(gt,mt.count));let Qt=gt-ze;if(Qt<0||Qt===1/0)return;we.setup(J,Y,Ce,j,Ne);let It,Lt=ne;if(Ne!==null&&(It=S.get(Ne),Lt=Te,Lt.setIndex(It)),J.isMesh)Y.wireframe===!0?(Ae.setLineWidth(Y.wireframeLinewidth*hn()),Lt.setMode(B.LINES)):Lt.setMode(B.TRIANGLES);else if(J.isLine){let Mn=Y.linewidth;Mn===void 0&&(Mn=1),Ae.setLineWidth(Mn*hn()),J.isLineSegments?Lt.setMode(B.LINES):J.isLineLoop?Lt.setMode(B.LINE_LOOP):Lt.setMode(B.LINE_STRIP)}else J.isPoints?Lt.setMode(B.POINTS):J.isSprite&&Lt.setMode(B.TRIANGLES);if(J.isBatchedMesh)if(Ze.get("WEBGL_multi_draw"))Lt.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Mn=J._multiDrawStarts,Fe=J._multiDrawCounts,dn=J._multiDrawCount,xt=Ne?S.get(Ne).bytesPerElement:1,ws=He.get(Y).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)ws.setValue(B,"_gl_DrawID",fn),Lt.render(Mn[fn]/xt,Fe[fn])}else if(J.isInstancedMesh)Lt.renderInstances(ze,Qt,J.count);else if(j.isInstancedBufferGeometry){let Mn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Fe=Math.min(j.instanceCount,Mn);Lt.renderInstances(ze,Qt,Fe)}else Lt.render(ze,Qt)};function ua(A,z,j,Y){H!==null&&A.isNodeMaterial&&H.setObject(Y,A),Gt===!0&&se.setState(A,j,!1),A.transparent===!0&&A.side===gi&&A.forceSinglePass===!1?(A.side=hi,A.needsUpdate=!0,ss(A,z,Y),A.side=wr,A.needsUpdate=!0,ss(A,z,Y),A.side=gi):ss(A,z,Y)}this.compile=function(A,z,j=null){j===null&&(j=A),H!==null&&H.renderStart(A,z,j),C=te.get(j),C.init(z),T.push(C),j.traverseVisible(function(J){J.isLight&&J.layers.test(z.layers)&&(C.pushLight(J),J.castShadow&&C.pushShadow(J))}),A!==j&&A.traverseVisible(function(J){J.isLight&&J.layers.test(z.layers)&&(C.pushLight(J),J.castShadow&&C.pushShadow(J))}),C.setupLights(),H!==null&&H.updateLights(C.state.lightsArray),un=this.localClippingEnabled,Gt=se.init(this.clippingPlanes,un),Gt===!0&&se.setGlobalState(this.clippingPlanes,z),H!==null&&pe.render(C.state.shadowsArray,j,z);let Y=new Set;return A.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Ee=J.material;if(Ee)if(Array.isArray(Ee))for(let De=0;De<Ee.length;De++){let Ce=Ee[De];ua(Ce,j,z,J),Y.add(Ce)}else ua(Ee,j,z,J),Y.add(Ee)}),C=T.pop(),H!==null&&H.renderEnd(),Y},this.compileAsync=function(A,z,j=null){let Y=this.compile(A,z,j);return new Promise(J=>{function Ee(){if(Y.forEach(function(De){let Ne=He.get(De).currentProgram;(Ne===void 0||Ne.isReady())&&Y.delete(De)}),Y.size===0){J(A);return}setTimeout(Ee,10)}Ze.get("KHR_parallel_shader_compile")!==null?Ee():setTimeout(Ee,10)})};let Qr=null;function Xh(A){Qr&&Qr(A)}function Ll(){Ss.stop()}function is(){Ss.start()}let Ss=new $x;Ss.setAnimationLoop(Xh),typeof self<"u"&&Ss.setContext(self),this.setAnimationLoop=function(A){Qr=A,ce.setAnimationLoop(A),A===null?Ss.stop():Ss.start()},ce.addEventListener("sessionstart",Ll),ce.addEventListener("sessionend",is),this.render=function(A,z){if(z!==void 0&&z.isCamera!==!0){st("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;H!==null&&H.renderStart(A,z);let j=ce.enabled===!0&&ce.isPresenting===!0,Y=k!==null&&(le===null||j)&&k.begin(U,le);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),z.parent===null&&z.matrixWorldAutoUpdate===!0&&z.updateMatrixWorld(),ce.enabled===!0&&ce.isPresenting===!0&&(k===null||k.isCompositing()===!1)&&(ce.cameraAutoUpdate===!0&&ce.updateCamera(z),z=ce.getCamera()),A.isScene===!0&&A.onBeforeRender(U,A,z,le),C=te.get(A,T.length),C.init(z),C.state.textureUnits=$e.getTextureUnits(),T.push(C),Ft.multiplyMatrices(z.projectionMatrix,z.matrixWorldInverse),z.isArrayCamera?Zt.setFromArrayCamera(z):at.setFromProjectionMatrix(Ft,ki,z.reversedDepth),un=this.localClippingEnabled,Gt=se.init(this.clippingPlanes,un),L=Se.get(A,_.length),L.init(),_.push(L),this.info.render.frame++,ce.enabled===!0&&ce.isPresenting===!0){let De=U.xr.getDepthSensingMesh();De!==null&&Ms(De,z,-1/0,U.sortObjects)}Ms(A,z,0,U.sortObjects),L.finish(),H!==null&&H.updateLights(C.state.lightsArray),U.sortObjects===!0&&L.sort(We,me),en=ce.enabled===!1||ce.isPresenting===!1||ce.hasDepthSensing()===!1,en&&F.addToRenderList(L,A),this.info.autoReset===!0&&this.info.reset(),Gt===!0&&se.beginShadows();let J=C.state.shadowsArray;if(pe.render(J,A,z),Gt===!0&&se.endShadows(),(Y&&k.hasRenderPass())===!1){let De=L.opaque,Ce=L.transmissive;if(C.setupLights(),z.isArrayCamera){let Ne=z.cameras;if(Ce.length>0)for(let Ve=0,it=Ne.length;Ve<it;Ve++){let mt=Ne[Ve];Vi(De,Ce,A,mt)}en&&F.render(A);for(let Ve=0,it=Ne.length;Ve<it;Ve++){let mt=Ne[Ve];ha(L,A,mt,mt.viewport)}}else Ce.length>0&&Vi(De,Ce,A,z),en&&F.render(A),ha(L,A,z)}le!==null&&G===0&&($e.updateMultisampleRenderTarget(le),$e.updateRenderTargetMipmap(le)),Y&&k.end(U),A.isScene===!0&&A.onAfterRender(U,A,z),we.resetDefaultState(),Z=-1,Q=null,T.pop(),T.length>0?(C=T[T.length-1],$e.setTextureUnits(C.state.textureUnits),Gt===!0&&se.setGlobalState(U.clippingPlanes,C.state.camera)):C=null,_.pop(),_.length>0?L=_[_.length-1]:L=null,H!==null&&H.renderEnd()};function Ms(A,z,j,Y){if(A.visible===!1)return;if(A.layers.test(z.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(z);else if(A.isLight)C.pushLight(A),A.castShadow&&C.pushShadow(A);else if(A.isSprite){let De=z.isArrayCamera?Zt:at;if(!A.frustumCulled||A.intersectsFrustum(De)){Y&&bt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ft);let Ce=ue.update(A),Ne=A.material;Ne.visible&&L.push(A,Ce,Ne,j,bt.z,null,z)}}else if(A.isMesh||A.isLine||A.isPoints){let De=z.isArrayCamera?Zt:at;if(!A.frustumCulled||A.intersectsFrustum(De)){let Ce=ue.update(A),Ne=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),bt.copy(A.boundingSphere.center)):(Ce.boundingSphere===null&&Ce.computeBoundingSphere(),bt.copy(Ce.boundingSphere.center)),bt.applyMatrix4(A.matrixWorld).applyMatrix4(Ft)),Array.isArray(Ne)){let Ve=Ce.groups;for(let it=0,mt=Ve.length;it<mt;it++){let ze=Ve[it],gt=Ne[ze.materialIndex];gt&&gt.visible&&L.push(A,Ce,gt,j,bt.z,ze,z)}}else Ne.visible&&L.push(A,Ce,Ne,j,bt.z,null,z)}}}let Ee=A.children;for(let De=0,Ce=Ee.length;De<Ce;De++)Ms(Ee[De],z,j,Y)}function ha(A,z,j,Y){let{opaque:J,transmissive:Ee,transparent:De}=A;C.setupLightsView(j),Gt===!0&&se.setGlobalState(U.clippingPlanes,j),Y&&Ae.viewport(ie.copy(Y)),J.length>0&&tn(J,z,j),Ee.length>0&&tn(Ee,z,j),De.length>0&&tn(De,z,j),Ae.buffers.depth.setTest(!0),Ae.buffers.depth.setMask(!0),Ae.buffers.color.setMask(!0),Ae.setPolygonOffset(!1)}function Vi(A,z,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(C.state.transmissionRenderTarget[Y.id]===void 0){let ze=Ze.has("EXT_color_buffer_half_float")||Ze.has("EXT_color_buffer_float");C.state.transmissionRenderTarget[Y.id]=new Ri(1,1,{generateMipmaps:!0,type:ze?ns:_i,minFilter:Gs,samples:Math.max(4,ct.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Ee=C.state.transmissionRenderTarget[Y.id],De=Y.viewport||ie;Ee.setSize(De.z*U.transmissionResolutionScale,De.w*U.transmissionResolutionScale);let Ce=U.getRenderTarget(),Ne=U.getActiveCubeFace(),Ve=U.getActiveMipmapLevel();U.setRenderTarget(Ee),U.getClearColor(ee),ge=U.getClearAlpha(),ge<1&&U.setClearColor(16777215,.5),U.clear(),en&&F.render(j);let it=U.toneMapping;U.toneMapping=_s;let mt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),C.setupLightsView(Y),Gt===!0&&se.setGlobalState(U.clippingPlanes,Y),tn(A,j,Y),$e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee),Ze.has("WEBGL_multisampled_render_to_texture")===!1){let ze=!1;for(let gt=0,Qt=z.length;gt<Qt;gt++){let It=z[gt],{object:Lt,geometry:Mn,material:Fe,group:dn}=It;if(Fe.side===gi&&Lt.layers.test(Y.layers)){let xt=Fe.side;Fe.side=hi,Fe.needsUpdate=!0,an(Lt,j,Y,Mn,Fe,dn),Fe.side=xt,Fe.needsUpdate=!0,ze=!0}}ze===!0&&($e.updateMultisampleRenderTarget(Ee),$e.updateRenderTargetMipmap(Ee))}U.setRenderTarget(Ce,Ne,Ve),U.setClearColor(ee,ge),mt!==void 0&&(Y.viewport=mt),U.toneMapping=it}function tn(A,z,j){let Y=z.isScene===!0?z.overrideMaterial:null;for(let J=0,Ee=A.length;J<Ee;J++){let De=A[J],{object:Ce,geometry:Ne,group:Ve}=De,it=De.material;it.allowOverride===!0&&Y!==null&&(it=Y),Ce.layers.test(j.layers)&&an(Ce,z,j,Ne,it,Ve)}}function an(A,z,j,Y,J,Ee){H!==null&&J.isNodeMaterial&&H.setObject(A,J),A.onBeforeRender(U,z,j,Y,J,Ee),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),J.onBeforeRender(U,z,j,Y,A,Ee),J.transparent===!0&&J.side===gi&&J.forceSinglePass===!1?(J.side=hi,J.needsUpdate=!0,U.renderBufferDirect(j,z,Y,J,A,Ee),J.side=wr,J.needsUpdate=!0,U.renderBufferDirect(j,z,Y,J,A,Ee),J.side=gi):U.renderBufferDirect(j,z,Y,J,A,Ee),A.onAfterRender(U,z,j,Y,J,Ee)}function ln(A){let z=0;for(let j of A)j.texture!==null&&z++;return z}function ss(A,z,j){z.isScene!==!0&&(z=Sn);let Y=He.get(A),J=C.state.lights,Ee=C.state.shadowsArray,De=J.state.version,Ce=oe.getParameters(A,J.state,Ee,z,j,C.state.lightProbeGridArray),Ne=oe.getProgramCacheKey(Ce),Ve=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?z.environment:null,Y.fog=z.fog;let it=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=R.get(A.envMap||Y.environment,it),Y.envMapRotation=Y.environment!==null&&A.envMap===null?z.environmentRotation:A.envMapRotation,Ve===void 0&&(A.addEventListener("dispose",ht),Ve=new Map,Y.programs=Ve,Y.programVariants=new Map);let mt=Ve.get(Ne);if(mt!==void 0){if(Y.currentProgram===mt&&Y.lightsStateVersion===De)return da(A,Ce),mt}else Ce.uniforms=oe.getUniforms(A),H!==null&&A.isNodeMaterial&&H.build(A,j,Ce),A.onBeforeCompile(Ce,U),mt=oe.acquireProgram(Ce,Ne),Ve.set(Ne,mt),Y.uniforms=Ce.uniforms;let ze=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(ze.clippingPlanes=se.uniform),da(A,Ce),Y.needsLights=$s(A),Y.lightsStateVersion=De,Y.needsLights&&(ze.ambientLightColor.value=J.state.ambient,ze.lightProbe.value=J.state.probe,ze.sunLights.value=J.state.sun,ze.sunLightShadows.value=J.state.sunShadow,ze.directionalLights.value=J.state.directional,ze.directionalLightShadows.value=J.state.directionalShadow,ze.spotLights.value=J.state.spot,ze.spotLightShadows.value=J.state.spotShadow,ze.rectAreaLights.value=J.state.rectArea,ze.ltc_1.value=J.state.rectAreaLTC1,ze.ltc_2.value=J.state.rectAreaLTC2,ze.pointLights.value=J.state.point,ze.pointLightShadows.value=J.state.pointShadow,ze.hemisphereLights.value=J.state.hemi,ze.sunShadowMatrix.value=J.state.sunShadowMatrix,ze.sunShadowCascade.value=J.state.sunShadowCascade,ze.directionalShadowMatrix.value=J.state.directionalShadowMatrix,ze.spotLightMatrix.value=J.state.spotLightMatrix,ze.spotLightMap.value=J.state.spotLightMap,ze.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=ln(C.state.lightProbeGridArray),Y.currentProgram=mt,Y.uniformsList=null,mt}function yi(A,z,j,Y,J){let Ee=He.get(A),De=Ee.currentProgram.id+","+Y+","+J,Ce=Ee.programVariants.get(De);return Ce===void 0?(Ce=ss(A,z,j),Ee.programVariants.set(De,Ce)):(Ee.currentProgram=Ce,Ee.uniformsList=null,Ee.outputColorSpace=Y,Ee.toneMapping=J),Ce}function qs(A){if(A.uniformsList===null){let z=A.currentProgram.getUniforms();A.uniformsList=ra.seqWithValue(z.seq,A.uniforms)}return A.uniformsList}function da(A,z){let j=He.get(A);j.outputColorSpace=z.outputColorSpace,j.batching=z.batching,j.batchingColor=z.batchingColor,j.instancing=z.instancing,j.instancingColor=z.instancingColor,j.instancingMorph=z.instancingMorph,j.skinning=z.skinning,j.morphTargets=z.morphTargets,j.morphNormals=z.morphNormals,j.morphColors=z.morphColors,j.morphTargetsCount=z.morphTargetsCount,j.numClippingPlanes=z.numClippingPlanes,j.numIntersection=z.numClipIntersection,j.vertexAlphas=z.vertexAlphas,j.vertexTangents=z.vertexTangents,j.toneMapping=z.toneMapping}function fa(A,z,j,Y,J){z.isScene!==!0&&(z=Sn),$e.resetTextureUnits();let Ee=z.fog,De=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?z.environment:null,Ce=le===null?U.outputColorSpace:le.isXRRenderTarget===!0?le.texture.colorSpace:vt.workingColorSpace,Ne=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,Ve=R.get(Y.envMap||De,Ne),it=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,mt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ze=!!j.morphAttributes.position,gt=!!j.morphAttributes.normal,Qt=!!j.morphAttributes.color,It=_s;Y.toneMapped&&(le===null||le.isXRRenderTarget===!0)&&(It=U.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Mn=Lt!==void 0?Lt.length:0,Fe=He.get(Y),dn=C.state.lights;if(Gt===!0&&(un===!0||A!==Q)){let Dt=A===Q&&Y.id===Z;se.setState(Y,A,Dt)}let xt=!1,ws=!1;Y.version===Fe.__version?Fe.needsLights&&Fe.lightsStateVersion!==dn.state.version||J.isBatchedMesh&&Fe.batching===!1||!J.isBatchedMesh&&Fe.batching===!0||J.isBatchedMesh&&Fe.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Fe.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Fe.instancing===!1||!J.isInstancedMesh&&Fe.instancing===!0||J.isSkinnedMesh&&Fe.skinning===!1||!J.isSkinnedMesh&&Fe.skinning===!0||J.isInstancedMesh&&Fe.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Fe.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Fe.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Fe.instancingMorph===!1&&J.morphTexture!==null||Fe.envMap!==Ve||Y.fog===!0&&Fe.fog!==Ee||Fe.numClippingPlanes!==void 0&&(Fe.numClippingPlanes!==se.numPlanes||Fe.numIntersection!==se.numIntersection)||Fe.vertexAlphas!==it||Fe.vertexTangents!==mt||Fe.morphTargets!==ze||Fe.morphNormals!==gt||Fe.morphColors!==Qt||Fe.morphTargetsCount!==Mn||Fe.numLightProbeGrids!==ln(C.state.lightProbeGridArray)?xt=!0:(Fe.outputColorSpace!==Ce||Fe.toneMapping!==It)&&(ws=!0):(xt=!0,Fe.__version=Y.version);let fn=Fe.currentProgram;(xt===!0||ws===!0)&&(fn=ws===!0?yi(Y,z,J,Ce,It):ss(Y,z,J),H&&Y.isNodeMaterial&&H.onUpdateProgram(Y,fn,Fe));let no=!1,rs=!1,As=!1,ft=fn.getUniforms(),nn=Fe.uniforms;if(Ae.useProgram(fn.program)&&(no=!0,rs=!0,As=!0),Y.id!==Z&&(Z=Y.id,rs=!0),no||Q!==A){Ae.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),ft.setValue(B,"projectionMatrix",A.projectionMatrix),ft.setValue(B,"viewMatrix",A.matrixWorldInverse);let pn=ft.map.cameraPosition;pn!==void 0&&pn.setValue(B,Dn.setFromMatrixPosition(A.matrixWorld)),ct.logarithmicDepthBuffer&&ft.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&ft.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),Q!==A&&(Q=A,rs=!0,As=!0)}if(Fe.needsLights&&(dn.state.sunShadowMap.length>0&&ft.setValue(B,"sunShadowMap",dn.state.sunShadowMap,$e),dn.state.directionalShadowMap.length>0&&ft.setValue(B,"directionalShadowMap",dn.state.directionalShadowMap,$e),dn.state.spotShadowMap.length>0&&ft.setValue(B,"spotShadowMap",dn.state.spotShadowMap,$e),dn.state.pointShadowMap.length>0&&ft.setValue(B,"pointShadowMap",dn.state.pointShadowMap,$e)),J.isSkinnedMesh){ft.setOptional(B,J,"bindMatrix"),ft.setOptional(B,J,"bindMatrixInverse");let Dt=J.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),ft.setValue(B,"boneTexture",Dt.boneTexture,$e))}J.isBatchedMesh&&(ft.setOptional(B,J,"batchingTexture"),ft.setValue(B,"batchingTexture",J._matricesTexture,$e),ft.setOptional(B,J,"batchingIdTexture"),ft.setValue(B,"batchingIdTexture",J._indirectTexture,$e),ft.setOptional(B,J,"batchingColorTexture"),J._colorsTexture!==null&&ft.setValue(B,"batchingColorTexture",J._colorsTexture,$e));let ni=j.morphAttributes;if((ni.position!==void 0||ni.normal!==void 0||ni.color!==void 0)&&re.update(J,j,fn),(rs||Fe.receiveShadow!==J.receiveShadow)&&(Fe.receiveShadow=J.receiveShadow,ft.setValue(B,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&z.environment!==null&&(nn.envMapIntensity.value=z.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=LE()),rs){if(ft.setValue(B,"toneMappingExposure",U.toneMappingExposure),Fe.needsLights&&eo(nn,As),Ee&&Y.fog===!0&&ye.refreshFogUniforms(nn,Ee),ye.refreshMaterialUniforms(nn,Y,ve,Re,C.state.transmissionRenderTarget[A.id]),Fe.needsLights&&Fe.numLightProbeGrids>0){let Dt=M,pn=0;for(let Jn of C.state.lightProbeGridArray)Jn.texture!==null&&(Dt.textures[pn]=Jn.texture,Dt.min[pn]=Jn.boundingBox.min,Dt.max[pn]=Jn.boundingBox.max,Dt.resolution[pn]=Jn.resolution,pn++);for(let Jn in Dt)Dt[Jn].length=pn;nn.probesSH.value=Dt.textures,nn.probesMin.value=Dt.min,nn.probesMax.value=Dt.max,nn.probesResolution.value=Dt.resolution}ra.upload(B,qs(Fe),nn,$e)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(ra.upload(B,qs(Fe),nn,$e),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&ft.setValue(B,"center",J.center),ft.setValue(B,"modelViewMatrix",J.modelViewMatrix),ft.setValue(B,"normalMatrix",J.normalMatrix),ft.setValue(B,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Dt=Y.uniformsGroups;for(let pn=0,Jn=Dt.length;pn<Jn;pn++){let Dl=Dt[pn];Xe.update(Dl,fn),Xe.bind(Dl,fn)}}return fn}function eo(A,z){A.ambientLightColor.needsUpdate=z,A.lightProbe.needsUpdate=z,A.sunLights.needsUpdate=z,A.sunLightShadows.needsUpdate=z,A.directionalLights.needsUpdate=z,A.directionalLightShadows.needsUpdate=z,A.pointLights.needsUpdate=z,A.pointLightShadows.needsUpdate=z,A.spotLights.needsUpdate=z,A.spotLightShadows.needsUpdate=z,A.rectAreaLights.needsUpdate=z,A.hemisphereLights.needsUpdate=z}function $s(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return le},this.setRenderTargetTextures=function(A,z,j){let Y=He.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),He.get(A.texture).__webglTexture=z,He.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,z){let j=He.get(A);j.__webglFramebuffer=z,j.__useDefaultFramebuffer=z===void 0},this.setRenderTarget=function(A,z=0,j=0){le=A,$=z,G=j;let Y=null,J=!1,Ee=!1;if(A){let Ce=He.get(A);if(Ce.__useDefaultFramebuffer!==void 0){Ae.bindFramebuffer(B.FRAMEBUFFER,Ce.__webglFramebuffer),ie.copy(A.viewport),de.copy(A.scissor),he=A.scissorTest,Ae.viewport(ie),Ae.scissor(de),Ae.setScissorTest(he),Z=-1;return}else if(Ce.__webglFramebuffer===void 0)$e.setupRenderTarget(A);else if(Ce.__hasExternalTextures)$e.rebindTextures(A,He.get(A.texture).__webglTexture,He.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let it=A.depthTexture;if(Ce.__boundDepthTexture!==it){if(it!==null&&He.has(it)&&(A.width!==it.image.width||A.height!==it.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");$e.setupDepthRenderbuffer(A)}}let Ne=A.texture;(Ne.isData3DTexture||Ne.isDataArrayTexture||Ne.isCompressedArrayTexture)&&(Ee=!0);let Ve=He.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(Ve[z])?Y=Ve[z][j]:Y=Ve[z],J=!0):A.samples>0&&$e.useMultisampledRTT(A)===!1?Y=He.get(A).__webglMultisampledFramebuffer:Array.isArray(Ve)?Y=Ve[j]:Y=Ve,ie.copy(A.viewport),de.copy(A.scissor),he=A.scissorTest}else ie.copy(be).multiplyScalar(ve).floor(),de.copy(je).multiplyScalar(ve).floor(),he=rt;if(j!==0&&(Y=O),Ae.bindFramebuffer(B.FRAMEBUFFER,Y)&&Ae.drawBuffers(A,Y),Ae.viewport(ie),Ae.scissor(de),Ae.setScissorTest(he),J){let Ce=He.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+z,Ce.__webglTexture,j)}else if(Ee){let Ce=z;for(let Ne=0;Ne<A.textures.length;Ne++){let Ve=He.get(A.textures[Ne]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Ne,Ve.__webglTexture,j,Ce)}}else if(A!==null&&j!==0){let Ce=He.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ce.__webglTexture,j)}Z=-1};function to(A){let z=He.get(A);return(z.__readFormat!==A.format||z.__readType!==A.type)&&(z.__readFormat=A.format,z.__readType=A.type,z.__formatReadable=ct.textureFormatReadable(A.format),z.__typeReadable=ct.textureTypeReadable(A.type)),z}this.readRenderTargetPixels=function(A,z,j,Y,J,Ee,De,Ce=0){if(!(A&&A.isWebGLRenderTarget)){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Ne=He.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne){Ae.bindFramebuffer(B.FRAMEBUFFER,Ne);try{let Ve=A.textures[Ce],it=Ve.format,mt=Ve.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ce);let ze=to(Ve);if(ze.__formatReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ze.__typeReadable===!1){st("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}z>=0&&z<=A.width-Y&&j>=0&&j<=A.height-J&&B.readPixels(z,j,Y,J,xe.convert(it),xe.convert(mt),Ee)}finally{let Ve=le!==null?He.get(le).__webglFramebuffer:null;Ae.bindFramebuffer(B.FRAMEBUFFER,Ve)}}},this.readRenderTargetPixelsAsync=async function(A,z,j,Y,J,Ee,De,Ce=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Ne=He.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&De!==void 0&&(Ne=Ne[De],Array.isArray(Ne)&&(Ne=Ne[0])),Ne)if(z>=0&&z<=A.width-Y&&j>=0&&j<=A.height-J){Ae.bindFramebuffer(B.FRAMEBUFFER,Ne);let Ve=A.textures[Ce],it=Ve.format,mt=Ve.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ce);let ze=to(Ve);if(ze.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ze.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.bufferData(B.PIXEL_PACK_BUFFER,Ee.byteLength,B.STREAM_READ),B.readPixels(z,j,Y,J,xe.convert(it),xe.convert(mt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Qt=le!==null?He.get(le).__webglFramebuffer:null;Ae.bindFramebuffer(B.FRAMEBUFFER,Qt);let It=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await bx(B,It,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Ee),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(gt),B.deleteSync(It),Ee}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,z=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(A.image.width*Y),Ee=Math.floor(A.image.height*Y),De=z!==null?z.x:0,Ce=z!==null?z.y:0;$e.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,De,Ce,J,Ee),Ae.unbindTexture()},this.copyTextureToTexture=function(A,z,j=null,Y=null,J=0,Ee=0){let De,Ce,Ne,Ve,it,mt,ze,gt,Qt,It=A.isCompressedTexture?A.mipmaps[Ee]:A.image;if(j!==null)De=j.max.x-j.min.x,Ce=j.max.y-j.min.y,Ne=j.isBox3?j.max.z-j.min.z:1,Ve=j.min.x,it=j.min.y,mt=j.isBox3?j.min.z:0;else{let ft=Math.pow(2,-J);De=Math.floor(It.width*ft),Ce=Math.floor(It.height*ft),A.isDataArrayTexture?Ne=It.depth:A.isData3DTexture?Ne=Math.floor(It.depth*ft):Ne=1,Ve=0,it=0,mt=0}Y!==null?(ze=Y.x,gt=Y.y,Qt=Y.z):(ze=0,gt=0,Qt=0);let Lt=xe.convert(z.format),Mn=xe.convert(z.type),Fe;z.isData3DTexture?($e.setTexture3D(z,0),Fe=B.TEXTURE_3D):z.isDataArrayTexture||z.isCompressedArrayTexture?($e.setTexture2DArray(z,0),Fe=B.TEXTURE_2D_ARRAY):($e.setTexture2D(z,0),Fe=B.TEXTURE_2D),Ae.activeTexture(B.TEXTURE0),Ae.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,z.flipY),Ae.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,z.premultiplyAlpha),Ae.pixelStorei(B.UNPACK_ALIGNMENT,z.unpackAlignment);let dn=Ae.getParameter(B.UNPACK_ROW_LENGTH),xt=Ae.getParameter(B.UNPACK_IMAGE_HEIGHT),ws=Ae.getParameter(B.UNPACK_SKIP_PIXELS),fn=Ae.getParameter(B.UNPACK_SKIP_ROWS),no=Ae.getParameter(B.UNPACK_SKIP_IMAGES);Ae.pixelStorei(B.UNPACK_ROW_LENGTH,It.width),Ae.pixelStorei(B.UNPACK_IMAGE_HEIGHT,It.height),Ae.pixelStorei(B.UNPACK_SKIP_PIXELS,Ve),Ae.pixelStorei(B.UNPACK_SKIP_ROWS,it),Ae.pixelStorei(B.UNPACK_SKIP_IMAGES,mt);let rs=A.isDataArrayTexture||A.isData3DTexture,As=z.isDataArrayTexture||z.isData3DTexture;if(A.isDepthTexture){let ft=He.get(A),nn=He.get(z),ni=He.get(ft.__renderTarget),Dt=He.get(nn.__renderTarget);Ae.bindFramebuffer(B.READ_FRAMEBUFFER,ni.__webglFramebuffer),Ae.bindFramebuffer(B.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let pn=0;pn<Ne;pn++)rs&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(A).__webglTexture,J,mt+pn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,He.get(z).__webglTexture,Ee,Qt+pn)),B.blitFramebuffer(Ve,it,Ve+De,it+Ce,ze,gt,ze+De,gt+Ce,B.DEPTH_BUFFER_BIT,B.NEAREST);Ae.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(J!==0||A.isRenderTargetTexture||He.has(A)){let ft=He.get(A),nn=He.get(z);Ae.bindFramebuffer(B.READ_FRAMEBUFFER,I),Ae.bindFramebuffer(B.DRAW_FRAMEBUFFER,W);for(let ni=0;ni<Ne;ni++)rs?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,ft.__webglTexture,J,mt+ni):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,ft.__webglTexture,J),As?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,nn.__webglTexture,Ee,Qt+ni):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,nn.__webglTexture,Ee),J!==0?B.blitFramebuffer(Ve,it,Ve+De,it+Ce,ze,gt,ze+De,gt+Ce,B.COLOR_BUFFER_BIT,B.NEAREST):As?B.copyTexSubImage3D(Fe,Ee,ze,gt,Qt+ni,Ve,it,De,Ce):B.copyTexSubImage2D(Fe,Ee,ze,gt,Ve,it,De,Ce);Ae.bindFramebuffer(B.READ_FRAMEBUFFER,null),Ae.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else As?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Fe,Ee,ze,gt,Qt,De,Ce,Ne,Lt,Mn,It.data):z.isCompressedArrayTexture?B.compressedTexSubImage3D(Fe,Ee,ze,gt,Qt,De,Ce,Ne,Lt,It.data):B.texSubImage3D(Fe,Ee,ze,gt,Qt,De,Ce,Ne,Lt,Mn,It):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Ee,ze,gt,De,Ce,Lt,Mn,It.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Ee,ze,gt,It.width,It.height,Lt,It.data):B.texSubImage2D(B.TEXTURE_2D,Ee,ze,gt,De,Ce,Lt,Mn,It);Ae.pixelStorei(B.UNPACK_ROW_LENGTH,dn),Ae.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),Ae.pixelStorei(B.UNPACK_SKIP_PIXELS,ws),Ae.pixelStorei(B.UNPACK_SKIP_ROWS,fn),Ae.pixelStorei(B.UNPACK_SKIP_IMAGES,no),Ee===0&&z.generateMipmaps===!0&&z.mipmapsAutoUpdate===!0&&B.generateMipmap(Fe),Ae.unbindTexture()},this.initRenderTarget=function(A){He.get(A).__webglFramebuffer===void 0&&$e.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?$e.setTextureCube(A,0):A.isData3DTexture?$e.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?$e.setTexture2DArray(A,0):$e.setTexture2D(A,0),Ae.unbindTexture()},this.resetState=function(){$=0,G=0,le=null,Ae.reset(),we.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return ki}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var DE=.28;function aa(n){let e=new rl({flatShading:!0,side:gi});return e.color.setRGB(n[0]/255,n[1]/255,n[2]/255,kn),e}function NE(n,e,t){n.onBeforeCompile=i=>{i.uniforms.heatTable={value:e},i.uniforms.showsHeat=t,i.vertexShader=i.vertexShader.replace("#include <common>",`#include <common>
attribute float heat;
varying float vHeat;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vHeat = heat;`),i.fragmentShader=i.fragmentShader.replace("#include <common>",`#include <common>
uniform sampler2D heatTable;
uniform bool showsHeat;
varying float vHeat;`).replace("#include <color_fragment>",`#include <color_fragment>
                if (showsHeat) {
                    float at = (floor(vHeat * 255.0 + 0.5) + 0.5) / 256.0;
                    diffuseColor.rgb = texture2D(heatTable, vec2(at, 0.5)).rgb;
                }`)}}var Rl=class{constructor(e,t){this.mesh=e;this.corners=K0(e),this.radius=Math.hypot(...e.max.map((o,a)=>o-e.min[a]))/2,this.geometry.setAttribute("position",new vn(this.corners,3)),this.setHeat(new Uint8Array(this.corners.length/3)),this.geometry.boundingSphere=new Hn(new V,this.radius),this.table=new Zo(q0(t),256,1,Ii),this.table.colorSpace=kn,this.table.minFilter=cn,this.table.magFilter=cn,this.table.needsUpdate=!0;let i=aa(t),s=aa(t),r=aa(t);for(let o of[i,s,r])o.polygonOffset=!0,o.polygonOffsetFactor=1,o.polygonOffsetUnits=1,NE(o,this.table,this.showsHeat);s.colorWrite=!1,r.polygonOffset=!1,r.transparent=!0,r.opacity=DE,r.depthWrite=!1,r.depthFunc=pr,this.materials=[i,s,r],this.solid=this.make(i,0),this.ghost.add(this.make(s,1),this.make(r,2))}mesh;corners;solid;ghost=new pi;radius;geometry=new bn;materials;showsHeat={value:!1};table;make(e,t){let i=new Gn(this.geometry,e);return i.matrixAutoUpdate=!1,i.renderOrder=t,i}get triangles(){return this.corners.length/9}setHeat(e){this.geometry.setAttribute("heat",new vn(e,1,!0))}showHeat(e){this.showsHeat.value=e}showAs(e){this.solid.visible=e==="solid",this.ghost.visible=e==="ghost"}clip(e){for(let t of this.materials)t.clippingPlanes=e}place(e,t){let i=So(e,this.mesh.centre),s=new St().set(e[0],e[1],e[2],i[0]-t[0],e[4],e[5],e[6],i[1]-t[1],e[8],e[9],e[10],i[2]-t[2],0,0,0,1);for(let r of[this.solid,...this.ghost.children])r.matrix.copy(s),r.matrixWorldNeedsUpdate=!0;return s}boxCorners(e){let t=this.mesh.max.map((s,r)=>s-this.mesh.centre[r]),i=[-1,1];return i.flatMap(s=>i.flatMap(r=>i.map(o=>new V(s*t[0],r*t[1],o*t[2]).applyMatrix4(e).toArray())))}dispose(){this.geometry.dispose(),this.table.dispose(),this.materials.forEach(e=>e.dispose())}};Le.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ke},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};di.line={uniforms:wl.merge([Le.common,Le.fog,Le.line]),vertexShader:`
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
		`};var la=class extends zi{constructor(e){super({type:"LineMaterial",uniforms:wl.clone(di.line.uniforms),vertexShader:di.line.vertexShader,fragmentShader:di.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var sy=new Qn,Dh=new V,ca=class extends dl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new zn(e,3)),this.setAttribute("uv",new zn(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new br(t,6,1);return this.setAttribute("instanceStart",new Qi(i,3,0)),this.setAttribute("instanceEnd",new Qi(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new br(t,6,1);return this.setAttribute("instanceColorStart",new Qi(i,3,0)),this.setAttribute("instanceColorEnd",new Qi(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new sl(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),sy.setFromBufferAttribute(t),this.boundingBox.union(sy))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Hn),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Dh.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Dh)),Dh.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Dh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var Pp=new Pt,ry=new V,oy=new V,qn=new Pt,$n=new Pt,ys=new Pt,Ip=new V,Lp=new St,Yn=new fl,ay=new V,Nh=new Qn,Uh=new Hn,vs=new Pt,bs,jr;function ly(n,e,t){return vs.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),vs.multiplyScalar(1/vs.w),vs.x=jr/t.width,vs.y=jr/t.height,vs.applyMatrix4(n.projectionMatrixInverse),vs.multiplyScalar(1/vs.w),Math.abs(Math.max(vs.x,vs.y))}function UE(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Yn.start.fromBufferAttribute(s,a),Yn.end.fromBufferAttribute(r,a),Yn.applyMatrix4(t);let c=new V,u=new V;bs.distanceSqToSegment(Yn.start,Yn.end,u,c),u.distanceTo(c)<jr*.5&&e.push({point:u,pointOnLine:c,distance:bs.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function OE(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),f=-e.near;bs.at(1,ys),ys.w=1,ys.applyMatrix4(e.matrixWorldInverse),ys.applyMatrix4(i),ys.multiplyScalar(1/ys.w),ys.x*=r.x/2,ys.y*=r.y/2,ys.z=0,Ip.copy(ys),Lp.multiplyMatrices(e.matrixWorldInverse,o);for(let h=0,d=u;h<d;h++){if(qn.fromBufferAttribute(l,h),$n.fromBufferAttribute(c,h),qn.w=1,$n.w=1,qn.applyMatrix4(Lp),$n.applyMatrix4(Lp),qn.z>f&&$n.z>f)continue;if(qn.z>f){let E=qn.z-$n.z,M=(qn.z-f)/E;qn.lerp($n,M)}else if($n.z>f){let E=$n.z-qn.z,M=($n.z-f)/E;$n.lerp(qn,M)}qn.applyMatrix4(i),$n.applyMatrix4(i),qn.multiplyScalar(1/qn.w),$n.multiplyScalar(1/$n.w),qn.x*=r.x/2,qn.y*=r.y/2,$n.x*=r.x/2,$n.y*=r.y/2,Yn.start.copy(qn),Yn.start.z=0,Yn.end.copy($n),Yn.end.z=0;let b=Yn.closestPointToPointParameter(Ip,!0);Yn.at(b,ay);let g=Ml.lerp(qn.z,$n.z,b),m=g>=-1&&g<=1,v=Ip.distanceTo(ay)<jr*.5;if(m&&v){Yn.start.fromBufferAttribute(l,h),Yn.end.fromBufferAttribute(c,h),Yn.start.applyMatrix4(o),Yn.end.applyMatrix4(o);let E=new V,M=new V;bs.distanceSqToSegment(Yn.start,Yn.end,M,E),t.push({point:M,pointOnLine:E,distance:bs.origin.distanceTo(M),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var Oh=class extends Gn{constructor(e=new ca,t=new la({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)ry.fromBufferAttribute(t,o),oy.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+ry.distanceTo(oy);let r=new br(s,2,1);return e.setAttribute("instanceDistanceStart",new Qi(r,1,0)),e.setAttribute("instanceDistanceEnd",new Qi(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;bs=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;jr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Uh.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=jr*.5;else{let f=Math.max(s.near,Uh.distanceToPoint(bs.origin));c=ly(s,f,l.resolution)}if(Uh.radius+=c,bs.intersectsSphere(Uh)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Nh.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=jr*.5;else{let f=Math.max(s.near,Nh.distanceToPoint(bs.origin));u=ly(s,f,l.resolution)}Nh.expandByScalar(u),bs.intersectsBox(Nh)!==!1&&(i?UE(this,t):OE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(Pp),this.material.uniforms.resolution.value.set(Pp.z,Pp.w))}};var FE=3;function cy(n,e){let t=[new Map,new Map];for(let i=0;i+2<n.length;i+=3)e(n[i],n[i+1])&&t.forEach((s,r)=>{let o=n[i+r];s.set(o,Math.max(n[i+2],s.get(o)??0))});return t}function BE(n,e){return[...n].flatMap(([t,i])=>i===FE===e?[t]:[])}function kE(n,e){let t=new Float32Array(9*e.length);return e.forEach((i,s)=>t.set(n.subarray(9*i,9*i+9),9*s)),t}function Dp(n){let e=new Float32Array(2*n.length);for(let t=0;t<n.length;t+=9){let[i,s,r]=[0,3,6].map(o=>n.subarray(t+o,t+o+3));[i,s,s,r,r,i].forEach((o,a)=>e.set(o,2*t+3*a))}return e}function zE(n,e,t){let i={segments:[],points:[]};for(let s=0;s<n.length;){let r=n[s],o=s,a=[];for(;o<n.length&&n[o]===r;o+=4)a.push(e([n[o+1],n[o+2],n[o+3]]));if(s=o,!t(r))continue;a.length===1&&i.points.push(...a[0]);let l=a.length>2?a.length:a.length-1;for(let c=0;c<l;++c)i.segments.push(...a[c],...a[(c+1)%a.length])}return i}var Fh=class{group=new pi;lines=new pi;red;yellow;outline=new _r({color:5915904});segment=new la({color:0,linewidth:2.5});dot=new Ko({color:0,size:7,sizeAttenuation:!1});constructor(){this.red=aa(fs(2)),this.yellow=aa(fs(1)),this.red.emissive.copy(this.red.color).multiplyScalar(.45),this.yellow.emissive.copy(this.yellow.color).multiplyScalar(.35),this.group.add(this.lines)}clear(){for(let e of[...this.group.children,...this.lines.children])e!==this.lines&&(e.geometry.dispose(),e.removeFromParent())}addBody(e,t,i){for(let s of[!1,!0]){let r=kE(e,BE(t,s));if(r.length===0)continue;let o=new bn().setAttribute("position",new vn(r,3));if(this.addPlaced(new Gn(o,s?this.red:this.yellow),i),!s){let a=new bn().setAttribute("position",new vn(Dp(r),3));this.addPlaced(new qr(a,this.outline),i)}}}addPlaced(e,t){e.matrixAutoUpdate=!1,e.matrix.copy(t),e.frustumCulled=!1,this.group.add(e)}show(e,t,i){this.clear(),e.forEach((s,r)=>this.addBody(s,t[r],i[r]))}addPoints(e,t,i,s){let o=zE(e,a=>So(t,a).map((l,c)=>l-i[c]),s);if(o.segments.length>0){let a=new ca().setPositions(new Float32Array(o.segments)),l=new Oh(a,this.segment);l.frustumCulled=!1,l.renderOrder=4,this.lines.add(l)}if(o.points.length>0){let a=new vn(new Float32Array(o.points),3),l=new Qa(new bn().setAttribute("position",a),this.dot);l.frustumCulled=!1,l.renderOrder=5,this.lines.add(l)}}clip(e){for(let t of[this.red,this.yellow,this.outline,this.segment,this.dot])t.clippingPlanes=e}dispose(){this.clear(),[this.red,this.yellow,this.outline,this.segment,this.dot].forEach(e=>e.dispose())}};function uy(n,{origin:[e,t,i],direction:[s,r,o]},a){let l=null,c=1/0;for(let u=0;u<n.length;u+=9){let f=n[u],h=n[u+1],d=n[u+2],p=n[u+3]-f,b=n[u+4]-h,g=n[u+5]-d,m=n[u+6]-f,v=n[u+7]-h,E=n[u+8]-d,M=r*E-o*v,L=o*m-s*E,C=s*v-r*m,_=p*M+b*L+g*C;if(_===0)continue;let T=e-f,k=t-h,U=i-d,D=(T*M+k*L+U*C)/_;if(!(D>=0&&D<=1))continue;let H=k*g-U*b,O=U*p-T*g,I=T*b-k*p,W=(s*H+r*O+o*I)/_;if(!(W>=0&&D+W<=1))continue;let $=(m*H+v*O+E*I)/_;$>0&&$<c&&!a($)&&(c=$,l={triangle:u/9,distance:$})}return l}var Bh=class{group=new pi;face=new Jo({color:2068479,side:gi,transparent:!0,opacity:.55});edge=new _r({color:675742});clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){if(this.clear(),!e||!t||9*t.triangle>=e.length)return;let s=e.slice(9*t.triangle,9*t.triangle+9),r=a=>new bn().setAttribute("position",new vn(a,3)),o=[new Gn(r(s),this.face),new qr(r(Dp(s)),this.edge)];for(let a of o)a.matrixAutoUpdate=!1,a.matrix.copy(i[t.body]),a.frustumCulled=!1,this.group.add(a)}dispose(){this.clear(),this.face.dispose(),this.edge.dispose()}};var hy={type:"change"},Up={type:"start"},fy={type:"end"},kh=new mr,dy=new li,VE=Math.cos(70*Ml.DEG2RAD),Ln=new V,xi=2*Math.PI,Et={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Np=1e-6,zh=class extends pl{constructor(e,t=null){super(e,t),this.state=Et.NONE,this.target=new V,this.cursor=new V,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:Sr.ROTATE,MIDDLE:Sr.DOLLY,RIGHT:Sr.PAN},this.touches={ONE:Mr.ROTATE,TWO:Mr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new V,this._lastQuaternion=new Ci,this._lastTargetPosition=new V,this._quat=new Ci().setFromUnitVectors(e.up,new V(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new ea,this._sphericalDelta=new ea,this._scale=1,this._panOffset=new V,this._rotateStart=new Ke,this._rotateEnd=new Ke,this._rotateDelta=new Ke,this._panStart=new Ke,this._panEnd=new Ke,this._panDelta=new Ke,this._dollyStart=new Ke,this._dollyEnd=new Ke,this._dollyDelta=new Ke,this._dollyDirection=new V,this._mouse=new Ke,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=GE.bind(this),this._onPointerDown=HE.bind(this),this._onPointerUp=WE.bind(this),this._onContextMenu=KE.bind(this),this._onMouseWheel=$E.bind(this),this._onKeyDown=YE.bind(this),this._onTouchStart=JE.bind(this),this._onTouchMove=ZE.bind(this),this._onMouseDown=XE.bind(this),this._onMouseMove=qE.bind(this),this._interceptControlDown=jE.bind(this),this._interceptControlUp=QE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Et.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(hy),this.update(),this.state=Et.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Ln.copy(t).sub(this.target),Ln.applyQuaternion(this._quat),this._spherical.setFromVector3(Ln),this.autoRotate&&this.state===Et.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=xi:i>Math.PI&&(i-=xi),s<-Math.PI?s+=xi:s>Math.PI&&(s-=xi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Ln.setFromSpherical(this._spherical),Ln.applyQuaternion(this._quatInverse),t.copy(this.target).add(Ln),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Ln.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new V(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new V(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Ln.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(kh.origin.copy(this.object.position),kh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(kh.direction))<VE?this.object.lookAt(this.target):(dy.setFromNormalAndCoplanarPoint(this.object.up,this.target),kh.intersectPlane(dy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Np||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Np||this._lastTargetPosition.distanceToSquared(this.target)>Np?(this.dispatchEvent(hy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?xi/60*this.autoRotateSpeed*e:xi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Ln.setFromMatrixColumn(t,0),Ln.multiplyScalar(-e),this._panOffset.add(Ln)}_panUp(e,t){this.screenSpacePanning===!0?Ln.setFromMatrixColumn(t,1):(Ln.setFromMatrixColumn(t,0),Ln.crossVectors(this.object.up,Ln)),Ln.multiplyScalar(e),this._panOffset.add(Ln)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Ln.copy(s).sub(this.target);let r=Ln.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(xi*this._rotateDelta.x/t.clientHeight),this._rotateUp(xi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(xi*this._rotateDelta.x/t.clientHeight),this._rotateUp(xi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ke,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function HE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function GE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function WE(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(fy),this.state=Et.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function XE(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case Sr.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Et.DOLLY;break;case Sr.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Et.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Et.ROTATE}break;case Sr.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Et.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Et.PAN}break;default:this.state=Et.NONE}this.state!==Et.NONE&&this.dispatchEvent(Up)}function qE(n){switch(this.state){case Et.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Et.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Et.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function $E(n){this.enabled===!1||this.enableZoom===!1||this.state!==Et.NONE||(n.preventDefault(),this.dispatchEvent(Up),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(fy))}function YE(n){this.enabled!==!1&&this._handleKeyDown(n)}function JE(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Mr.ROTATE:if(this.enableRotate===!1){this.state=Et.NONE;break}this._handleTouchStartRotate(n),this.state=Et.TOUCH_ROTATE;break;case Mr.PAN:if(this.enablePan===!1){this.state=Et.NONE;break}this._handleTouchStartPan(n),this.state=Et.TOUCH_PAN;break;default:this.state=Et.NONE}break;case 2:switch(this.touches.TWO){case Mr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Et.TOUCH_DOLLY_PAN;break;case Mr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Et.TOUCH_DOLLY_ROTATE;break;default:this.state=Et.NONE}break;default:this.state=Et.NONE}this.state!==Et.NONE&&this.dispatchEvent(Up)}function ZE(n){switch(this._trackPointer(n),this.state){case Et.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Et.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Et.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Et.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Et.NONE}}function KE(n){this.enabled!==!1&&n.preventDefault()}function jE(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function QE(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var eC=1.08,tC=new V(.75,-1,.6).normalize();function nC(){let n=new Za;return n.add(new ll(16777215,10133670,1.9)),n}var Vh=class{constructor(e,t,i){this.canvas=e;this.moved=t;this.drawn=i;this.renderer=new Ph({canvas:e,antialias:!0}),this.renderer.outputColorSpace=kn,this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.camera.up.set(0,0,1),this.controls=new zh(this.camera,e),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.addEventListener("change",this.change),e.addEventListener("webglcontextrestored",this.draw),this.watcher=new ResizeObserver(()=>this.resize()),this.watcher.observe(e),this.resize()}canvas;moved;drawn;frames=0;renderer;camera=new ci(35,1,.01,1e3);controls;lamp=new hl(16777215,2.3);layers=[];watcher;isWaiting=!1;isPlacing=!1;radius=1;change=()=>{this.draw(),this.isPlacing||this.moved()};draw=()=>{this.isWaiting||(this.isWaiting=!0,requestAnimationFrame(()=>{this.isWaiting=!1,this.render(),this.drawn()}))};resize(){let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];e>0&&t>0&&(this.renderer.setPixelRatio(Math.min(2,devicePixelRatio)),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.draw())}setBackground(e){this.renderer.setClearColor(new dt(e)),this.draw()}setLayers(e){this.layers=e.map(({objects:t,forgetsDepth:i})=>{let s=nC();return s.add(...t),{scene:s,forgetsDepth:i}}),this.draw()}render(){let e=this.camera.position.distanceTo(this.controls.target),t=this.camera.position.length()+this.radius;this.camera.near=Math.max(e/500,(t-2*this.radius)/2,t/1e5),this.camera.near=Math.min(this.camera.near,e/2),this.camera.far=2*t,this.camera.updateProjectionMatrix(),this.lamp.position.copy(this.camera.position),this.lamp.target.position.copy(this.controls.target),this.renderer.clear();for(let{scene:i,forgetsDepth:s}of this.layers)s&&this.renderer.clearDepth(),i.add(this.lamp,this.lamp.target),this.renderer.render(i,this.camera);this.frames+=1}fit(e,t,i){let s=new V(...e),r=i?tC.clone():this.camera.position.clone().sub(this.controls.target).normalize(),o=new V().crossVectors(this.camera.up,r).normalize(),a=new V().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360),c=l*this.camera.aspect,u=1e-9;for(let f of t){let h=new V(...f).sub(s),d=Math.max(Math.abs(h.dot(o))/c,Math.abs(h.dot(a))/l);u=Math.max(u,d+h.dot(r))}this.look(s.clone().addScaledVector(r,eC*u),s)}look(e,t){this.isPlacing=!0,this.controls.target.copy(t),this.camera.position.copy(e),this.controls.update(),this.isPlacing=!1,this.draw()}turn(e,t){let i=this.controls.target,s=this.camera.position.clone().sub(i),r=s.length(),o=Math.atan2(s.y,s.x)+e,a=Math.min(Math.PI-.01,Math.max(.01,Math.acos(s.z/r)-t)),l=r*Math.sin(a);s.set(l*Math.cos(o),l*Math.sin(o),r*Math.cos(a)),this.look(s.add(i),i.clone()),this.moved()}approach(e){let t=this.controls.target,i=this.camera.position.clone().sub(t).multiplyScalar(e);this.look(i.add(t),t.clone()),this.moved()}setRadius(e){this.radius=e}get view(){return[...this.camera.position.toArray(),...this.controls.target.toArray()]}set view(e){this.look(new V().fromArray(e,0),new V().fromArray(e,3))}rayAt(e,t){let i=new Ke(2*e/this.canvas.clientWidth-1,1-2*t/this.canvas.clientHeight),s=this.camera;s.updateMatrixWorld();let o=new V(i.x,i.y,.5).unproject(s).sub(this.camera.position).normalize();return{origin:this.camera.position.toArray(),direction:o.toArray()}}pixelOf(e){this.camera.updateMatrixWorld();let t=new V(...e).project(this.camera);return[(t.x+1)/2*this.canvas.clientWidth,(1-t.y)/2*this.canvas.clientHeight]}picture(){return this.render(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}dispose(){this.watcher.disconnect(),this.controls.dispose(),this.canvas.removeEventListener("webglcontextrestored",this.draw),this.renderer.dispose(),this.renderer.forceContextLoss()}};function py(n,e){let t=new V(n==="x"?-1:0,n==="y"?-1:0,n==="z"?-1:0);return new li(t,e)}var my={mode:"contacts",ghost:"b",throughWalls:!0,lines:!0,clip:null,camera:null,partA:"",partB:"",pick:null};function iC(n,e){let t=(n??"").split(",").map(Number);return t.length===e&&t.every(Number.isFinite)&&n?t:null}function sC(n){let e=/^([xyz]):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(n??"");return e&&Number.isFinite(Number(e[2]))?{axis:e[1],at:Number(e[2])}:null}function rC(n){let e=/^([ab]):(\d+)$/.exec(n??"");return e?{body:e[1]==="a"?0:1,triangle:Number(e[2])}:null}function Op(n,e){let[t,i]=["",""];for(let s of[n.get("part"),n.get("with")])s&&(s.startsWith("b/")?i=s.slice(2):s.startsWith("a/")?t=s.slice(2):t===""&&e(s)?t=s:i=s);return[t,i]}function _y(n,e){return Object.entries(n).every(([t,i])=>t==="camera"||i===e[t])}function Fp(n,e){let t=n.get("ghost"),[i,s]=Op(n,e);return{mode:n.get("mode")==="heat"?"heat":"contacts",ghost:t==="a"||t==="none"?t:"b",throughWalls:n.get("walls")!=="0",lines:n.get("lines")!=="0",clip:sC(n.get("clip")),camera:iC(n.get("cam"),6),partA:i,partB:s,pick:rC(n.get("pick"))}}function gy(n){return String(Number(n.toPrecision(6)))}function Pl(n){let e={};return n.mode!==my.mode&&(e.mode=n.mode),n.camera&&(e.cam=n.camera.map(gy).join(",")),n.ghost!==my.ghost&&(e.ghost=n.ghost),n.throughWalls||(e.walls="0"),n.lines||(e.lines="0"),n.partA&&(e.part=`a/${n.partA}`),n.partB&&(e[n.partA?"with":"part"]=`b/${n.partB}`),n.clip&&(e.clip=`${n.clip.axis}:${gy(n.clip.at)}`),n.pick&&(e.pick=`${n.pick.body===0?"a":"b"}:${n.pick.triangle}`),e}var oC=[186,190,196],aC=[100,138,186],lC=[1,0,0,0,0,1,0,0,0,0,1,0],Hh=class{constructor(e,t,i,s){this.canvas=e;this.stage=new Vh(e,i,s),this.bodies=[new Rl(t[0],oC),new Rl(t[1],aC)],this.origin=t[0].centre,this.refreshTheme()}canvas;stage;bodies;contactsView=new Fh;mark=new Bh;origin;matrices=[new St,new St];highlights=[new Map,new Map];contacts=null;state=null;fitted=null;refreshTheme(){this.stage.setBackground(Wi("--stage",this.canvas))}relativePose(e){return bc(Mo(e.pose_a),e.pose_b)}show(e,t){this.contacts=e,this.matrices=[this.bodies[0].place(lC,this.origin),this.bodies[1].place(this.relativePose(e.scenario),this.origin)],this.stage.setRadius(this.centreOfB().length()+this.bodies[1].radius+this.bodies[0].radius),this.refreshContacts(t),this.state=t,this.applyState(t),!t.camera&&!this.isInView()&&this.fit(this.fitted===null)}centreOfB(){return new V().setFromMatrixPosition(this.matrices[1])}isShown(e,t,i){let[s,r]=this.bodies;return Eo(s.mesh,t,e.partA)&&Eo(r.mesh,i,e.partB)}refreshContacts(e){if(!this.contacts)return;let{pairs:t,points:i,scenario:s}=this.contacts,r=(a,l)=>this.isShown(e,a,l);this.highlights=cy(t,r);let o=[this.bodies[0].corners,this.bodies[1].corners];this.contactsView.show(o,this.highlights,this.matrices),this.contactsView.addPoints(i,Mo(s.pose_a),this.origin,a=>r(t[3*a],t[3*a+1]))}setState(e){let t=this.state;this.state=e,!(t&&_y(t,e))&&(t&&(t.partA!==e.partA||t.partB!==e.partB)&&this.refreshContacts(e),this.applyState(e))}applyState(e){let[t,i]=this.bodies;t.showAs(e.ghost==="a"?"ghost":"solid"),i.showAs(e.ghost==="b"?"ghost":"solid"),this.bodies.forEach(o=>o.showHeat(e.mode==="heat"));let s=e.clip?"xyz".indexOf(e.clip.axis):0,r=e.clip?[py(e.clip.axis,e.clip.at-this.origin[s])]:[];this.bodies.forEach(o=>o.clip(r)),this.contactsView.clip(r),this.contactsView.group.visible=e.mode==="contacts",this.contactsView.lines.visible=e.lines,this.mark.show(e.pick&&this.bodies[e.pick.body].corners,e.pick,this.matrices),this.arrange(e)}isShowing(e){return this.state===e}arrange(e){let[t,i]=this.bodies,s={objects:[t.solid,i.solid],forgetsDepth:!1},r={objects:[this.contactsView.group],forgetsDepth:e.throughWalls},o={objects:[t.ghost,i.ghost],forgetsDepth:!1},a={objects:[this.mark.group],forgetsDepth:!0};this.stage.setLayers(e.throughWalls?[s,o,r,a]:[s,r,o,a])}setHeat(e,t){e.forEach((i,s)=>this.bodies[s].setHeat(Y0(i,t))),this.stage.draw()}ballAround(){return new Hn(new V,this.bodies[0].radius).union(new Hn(this.centreOfB(),this.bodies[1].radius))}isInView(){let e=this.ballAround(),t=this.fitted;return t!==null&&t.center.distanceTo(e.center)+e.radius<=t.radius*1.001}fit(e){this.fitted=this.ballAround();let t=this.bodies.flatMap((s,r)=>s.boxCorners(this.matrices[r])),i=new Qn().setFromPoints(t.map(s=>new V(...s)));this.stage.fit(i.getCenter(new V).toArray(),t,e)}goToContact(){let e=this.bodies[0].corners,t=new V;for(let l of this.highlights[0].keys())t.add(this.middleOf(e,l));let i=this.highlights[0].size;if(i===0){this.fit(!1);return}t.divideScalar(i);let s=0;for(let l of this.highlights[0].keys())s=Math.max(s,this.middleOf(e,l).distanceTo(t));let r=Math.min(this.bodies[0].radius,this.bodies[1].radius)/12,o=new Hn(t,Math.max(s,r)).getBoundingBox(new Qn),a=[o.min,o.max].flatMap(({x:l,z:c})=>[o.min,o.max].map(({y:u})=>[l,u,c]));this.stage.fit(t.toArray(),a,!1)}middleOf(e,t){let[i,s,r]=[0,3,6].map(o=>new V().fromArray(e,9*t+o));return i.add(s).add(r).divideScalar(3)}get view(){return this.stage.view.map((e,t)=>e+this.origin[t%3])}set view(e){this.stage.view=e.map((t,i)=>t-this.origin[i%3])}pickAt(e,t,i){let s=this.stage.rayAt(e,t),r=[0,1].filter(l=>this.bodies[l].ghost.visible),o=[0,1].filter(l=>this.bodies[l].solid.visible);return i?this.pickAmong(s,r)??this.pickAmong(s,o):(this.state?.throughWalls&&this.state.mode==="contacts"?this.pickAmong(s,[0,1],!0):null)??this.pickAmong(s,o)??this.pickAmong(s,r)}pickAmong(e,t,i=!1){let s=1/0,r=null;for(let o of t){let a=i?[...this.highlights[o].keys()]:null,l=this.hit(e,o,a);l&&l.distance<s&&(s=l.distance,r={body:o,triangle:a?a[l.triangle]:l.triangle})}return r}hit(e,t,i){let s=this.matrices[t].clone().invert(),r=new V(...e.origin).applyMatrix4(s),o=new V(...e.direction).transformDirection(s),a=this.bodies[t].corners;if(i){let f=new Float32Array(9*i.length);i.forEach((h,d)=>f.set(a.subarray(9*h,9*h+9),9*d)),a=f}let l=this.state?.clip,c=l?"xyz".indexOf(l.axis):0,u=l?l.at-this.origin[c]:1/0;return uy(a,{origin:r.toArray(),direction:o.toArray()},f=>e.origin[c]+f*e.direction[c]>u)}get highlighted(){return this.highlights.map(e=>[...e.keys()].sort((t,i)=>t-i))}pixelOf(e){return this.stage.pixelOf(e.map((t,i)=>t-this.origin[i]))}pixelOfWorld(e){let t=this.contacts?.scenario;return this.pixelOf(t?So(Mo(t.pose_a),e):e)}dispose(){this.bodies.forEach(e=>e.dispose()),this.contactsView.dispose(),this.mark.dispose(),this.stage.dispose()}};function Il(n){return n.bodies.reduce((e,t)=>e+t.triangles,0)}function xy(n){let[e,t]=et({value:null,error:""});return Ye(()=>{let i=!0;return n&&Il(n)<=Na&&j0(n).then(s=>i&&t({value:s,error:""}),s=>i&&t({value:null,error:Tn(s)})),()=>{i=!1}},[n?.job]),e}function yy(n,e,t){let[i,s]=et({value:null,error:""}),r=on(!1);return Ye(()=>{n&&e&&t&&!r.current&&(r.current=!0,Q0(n,e).then(o=>s({value:o,error:o?"":"this job has no heat map"}),o=>s({value:null,error:Tn(o)})))},[n,e,t]),i}function vy(n,e){let[t,i]=et(null),[s,r]=et({scenario:-1,error:""}),o=on(null);return Ye(()=>{if(n)return o.current=new Lc(n.job,i,(a,l)=>r({scenario:a,error:Tn(l)})),()=>o.current?.close()},[n?.job]),Ye(()=>o.current?.want(e),[n?.job,e]),{contacts:t,error:s.scenario===e?s.error:""}}function by(n,e,t,i,s,r){let[o,a]=et(null),[l,c]=et(""),u=on(0),f=on(-1),h=on(-1),d=on(r);return d.current=r,Ye(()=>{if(!n.current||!e)return;let p=performance.now(),b;try{b=new Hh(n.current,e.meshes,()=>d.current(b.view),()=>{f.current=h.current,u.current===0&&h.current>=0&&(u.current=performance.now()-p)})}catch(m){c(`this browser draws no 3D (WebGL 2): ${Tn(m)}. All else on this page works.`);return}a(b);let g=jl(()=>b.refreshTheme());return()=>{g(),b.dispose()}},[e]),Ye(()=>{o&&t&&(o.show(t,i),h.current=t.scenario.index)},[o,t]),Ye(()=>o?.setState(i),[o,i]),Ye(()=>{o&&s&&o.setHeat(s.counts,s.most)},[o,s]),{viewer:o,error:l,firstFrame:u,drawn:f}}var cC=60,uC=4,Gh=Math.PI/24;function hC(n,e){let t=e?.bodies[1]?.size??[0,0,0],i=Math.hypot(t[0],t[1],t[2])/2,s=n?.meshes[0],r=o=>s?[s.min[o]-i,s.max[o]+i]:[-1,1];return{x:r(0),y:r(1),z:r(2)}}function dC(n){let e=on(n);e.current=n,Ye(()=>Ui("viewer",()=>{let{model:t,contacts:i,state:s,drawing:r,scenario:o,canvas:a}=e.current,l=r.viewer,c=a.current?.getBoundingClientRect(),u=([d,p])=>[d+(c?.left??0),p+(c?.top??0)],f=i?.points??new Float64Array,h=Array.from({length:Math.min(8,f.length/4)},(d,p)=>Array.from(f.subarray(4*p+1,4*p+4)));return{ready:l?.isShowing(s)===!0&&r.drawn.current===o,scenario:i?.scenario.index,class:i?.scenario.class,verified:i?.scenario.verified,mode:s.mode,ghost:s.ghost,throughWalls:s.throughWalls,clip:s.clip,camera:l?.view,parts:[s.partA,s.partB],pick:s.pick,trianglesDrawn:l?.bodies.map(d=>d.triangles)??[0,0],highlighted:l?.highlighted??[[],[]],shaChecked:t?.meshes.map(d=>d.checked),meshMilliseconds:t?.milliseconds,firstFrameMilliseconds:r.firstFrame.current,frames:l?.stage.frames,pointPixels:l?h.map(d=>u(l.pixelOfWorld(d))):[]}}),[])}function Bp({source:n,route:e,report:t}){let{value:i,error:s}=Ls(`jobs/${encodeURIComponent(e.job)}`,1,()=>!1),{value:r,error:o}=xy(i),a=pd(me=>r?.meshes[0].parts.some(be=>be.name===me)??!0,[r]),[l,c]=et(e.scenario),[u,f]=et(()=>Fp(e.query,a)),{contacts:h,error:d}=vy(i,l),{value:p,error:b}=yy(i,r,u.mode==="heat"||u.pick!==null&&i?.maps===!0),g=on(null),[m,v]=et(!1),[E,M]=et(""),[L,C]=et(!1),_=pd(me=>f(be=>({...be,...me})),[]),T=by(g,r,h,u,p,me=>_({camera:me})),{viewer:k}=T,U=An(()=>hC(r,i),[r,i]);rr(t?null:`#${l} ${i?.name??""}`),dC({job:i,model:r,contacts:h,state:u,drawing:T,scenario:l,canvas:g});let D=()=>{k&&u.camera&&(k.view=u.camera)},[H,O]=et(0);Ye(()=>{c(e.scenario),f(Fp(e.query,a)),O(me=>me+1)},[e]),Ye(D,[k,H]),Ye(()=>{if(r){let[me,be]=Op(e.query,a);_({partA:me,partB:be})}},[r]),Ye(()=>(Nm(_n(e.job,l,Pl(u))),Lr),[l,u]);let I=An(()=>new Ic(i?.scenarios??1,t?.scenarios),[i,t]),W=I.placeOf(l),$=me=>c(I.at(me));Ye(()=>{if(!m||h?.scenario.index!==l)return;if(W+1>=I.count){v(!1);return}let me=setTimeout(()=>$(W+1),cC);return()=>clearTimeout(me)},[m,h,l]);let G=async me=>{M("");try{let be=t&&r?await a_(e.job,t.scenarios,l,me,u,r.meshes):await o_(e.job,l,me,u);be===null?M(me>0?"no contact after this scenario":"no contact before this scenario"):(Zl(_n(e.job,l,Pl(u))),Cs(_n(e.job,be,Pl(u))))}catch(be){M(Tn(be))}},le=()=>{_({camera:null}),k?.fit(!1)},Z=()=>{k?.goToContact(),_({camera:k?.view??null})},Q=me=>{if(u.clip){let[be,je]=U[u.clip.axis],rt=Math.min(je,Math.max(be,u.clip.at+me*(je-be)/100));_({clip:{...u.clip,at:rt}})}},ie={n:()=>{G(1)},p:()=>{G(-1)},ArrowRight:()=>$(W+1),ArrowLeft:()=>$(W-1)," ":()=>v(!m),h:()=>_({mode:u.mode==="heat"||!i?.maps?"contacts":"heat"}),g:()=>_({ghost:u.ghost==="a"?"b":u.ghost==="b"?"none":"a"}),x:()=>_({throughWalls:!u.throughWalls}),l:()=>_({lines:!u.lines}),s:()=>_({clip:u.clip?null:{axis:"x",at:(U.x[0]+U.x[1])/2}}),"[":()=>Q(-1),"]":()=>Q(1),f:le,c:Z,"Shift+ArrowRight":()=>k?.stage.turn(Gh,0),"Shift+ArrowLeft":()=>k?.stage.turn(-Gh,0),"Shift+ArrowUp":()=>k?.stage.turn(0,Gh),"Shift+ArrowDown":()=>k?.stage.turn(0,-Gh),"+":()=>k?.stage.approach(.85),"-":()=>k?.stage.approach(1/.85),"?":()=>C(!0)},de=on(me=>{});de.current=me=>{let be=me.shiftKey&&me.key.startsWith("Arrow"),je=ie[be?`Shift+${me.key}`:me.key];je&&!H0(me)&&(je(),me.preventDefault())},Ye(()=>{let me=t?.root??document,be=je=>de.current(je);return me.addEventListener("keydown",be),()=>me.removeEventListener("keydown",be)},[]);let he=on([0,0]),ee=me=>{let be=Math.hypot(me.clientX-he.current[0],me.clientY-he.current[1]);if(k&&be<uC){let je=k.pickAt(me.offsetX,me.offsetY,me.shiftKey);f(rt=>je===null&&rt.pick===null?rt:{...rt,pick:je})}},ge=me=>{t&&t.root.getRootNode().activeElement!==g.current&&me.stopPropagation()},_e=async()=>{let me=await k?.stage.picture();if(me){let be=document.createElement("a");be.href=URL.createObjectURL(me),be.download=`${i?.name||e.job}-${l}.png`.replaceAll(/[^\w.-]+/g,"_"),be.click(),setTimeout(()=>URL.revokeObjectURL(be.href),1e3)}};if(!i)return s?y(kt,{kind:"bad",children:s}):y("p",{class:"wait",children:["asking for ",e.job,"…"]});let Re=Il(i)>Na,ve=i.folder?Sa(i.folder):n.kind==="folder"?Sa(n.name):i.job,We=o||T.error||d||(u.mode==="heat"?b:"");return y("div",{class:"viewer",children:[y("div",{class:"viewer-head",children:[y("h1",{children:[t?y(Ot,{text:i.name||i.job}):y("a",{href:er(i.job),children:y(Ot,{text:i.name||i.job})})," ",y("span",{class:"note",children:"›"})," ",y("label",{class:"number",children:["#",y("input",{type:"number","aria-label":"scenario",min:I.at(0),max:I.at(I.count-1),value:l,onChange:me=>$(I.placeOf(Math.round(Number(me.currentTarget.value))||0))})]})]}),h&&y(r_,{job:i,contacts:h})]}),y(s_,{model:r,contacts:h}),We&&y(kt,{kind:"bad",children:We}),y("div",{class:"scrub",children:[y("button",{type:"button",onClick:()=>{G(-1)},title:"p",children:"‹ previous contact"}),y("button",{type:"button",onClick:()=>{G(1)},title:"n",children:"next contact ›"}),y("input",{type:"range","aria-label":t?"scenarios of this report":`scenario, 0 to ${I.count-1}`,min:0,max:I.count-1,value:W,onInput:me=>$(Number(me.currentTarget.value))}),y("button",{type:"button",onClick:()=>v(!m),title:"space","aria-pressed":m,children:m?"stop":"play"}),y(X0,{address:()=>location.href.split("#")[0]+_n(e.job,l,Pl(u))}),y("button",{type:"button",onClick:()=>{_e()},disabled:!k,children:"PNG"}),y("button",{type:"button",class:"quiet",onClick:()=>C(!0),title:"keys",children:"?"}),y("span",{class:"note","aria-live":"polite",children:E})]}),y("div",{class:"stage-row",children:[y("div",{class:"stage",onWheelCapture:ge,children:Re?y("p",{class:"wait",children:[Ge(Il(i))," triangles: above ",Ge(Na)," this page does not draw. The exports have it all: ",y("code",{children:["cdctl extract ",ve," ",String(l)," --out case"]})]}):y(Ut,{children:[y("canvas",{ref:g,tabIndex:0,role:"img","aria-label":`scenario ${l}: ${h?.scenario.class??""}, ${h?.scenario.count??0} pairs`,onPointerDown:me=>{he.current=[me.clientX,me.clientY]},onClick:ee}),!k&&!We&&y("p",{class:"wait over",children:["reading ",Ge(Il(i))," triangles…"]}),y("div",{class:"corner",children:[y("span",{class:"swatch a"})," A ",y(Ot,{text:nr(i.bodies[0].file)})," ",y("span",{class:"swatch b"})," B ",y(Ot,{text:nr(i.bodies[1].file)}),y("span",{class:"note",children:"drawn in single precision"})]})]})}),y("aside",{class:"side",children:[y(W0,{state:u,bounds:U,hasMap:i.maps,change:_,fit:le,goToContact:Z}),u.mode==="heat"&&p?y(J0,{heat:p,job:i}):y(Z0,{}),u.pick&&r&&y(n_,{pick:u.pick,model:r,contacts:h,heat:p,job:i,drop:()=>_({pick:null})}),h&&r&&y(t_,{contacts:h,model:r,state:u,choose:(me,be)=>_({partA:me,partB:be})}),h&&k&&y(i_,{job:i,contacts:h,relative:k.relativePose(h.scenario)}),y("section",{"aria-label":"as a case of its own",children:[y("h2",{children:"as a case of its own"}),y(yc,{text:`cdctl extract ${ve} ${l} --out case`})]})]})]}),L&&y(V0,{close:()=>C(!1)})]})}var Sy={system:"light",light:"dark",dark:"system"};function fC(){let[n,e]=et(Om());return y("button",{type:"button",class:"quiet",onClick:()=>{Fm(Sy[n]),e(Sy[n])},title:"light, dark, or as the system says",children:[{system:"◐",light:"○",dark:"●"}[n]," ",n]})}function My(n){let{source:e,screen:t}=n,i=e.job===null,s=(r,o,a)=>y("a",{href:`#/${r}`,...a?{"aria-current":"page"}:{},children:o});return y(Ut,{children:[y("header",{class:"bar",children:[y("a",{class:"brand",href:"#/",children:[y("img",{src:"icon.svg",alt:"",width:20,height:20}),"cdcluster"]}),y("nav",{"aria-label":"screens",children:[i&&s("cluster","cluster",t==="cluster"),i&&s("jobs","jobs",t==="jobs"),e.job!==null&&s(`jobs/${e.job}`,"job",t==="job")]}),y("span",{class:"where",title:`${e.program} ${e.name}`,children:[e.kind==="folder"?"folder ":"master ",y(Ot,{text:e.kind==="folder"?nr(e.name):e.name}),e.tls&&" · TLS"]}),y(fC,{})]}),y("main",{children:n.children})]})}function wy(n){return n.job===null?"#/cluster":er(n.job)}function Ty(){let[n,e]=et(()=>Jl(location.hash)),t=()=>e(Jl(location.hash));return Ye(()=>{let i=()=>{Lr(),md(),t()};return addEventListener("hashchange",i),()=>removeEventListener("hashchange",i)},[]),[n,t]}function pC({source:n}){let[e,t]=Ty();Ye(()=>Ui("route",()=>({screen:e.screen,link:location.hash})),[e]);let i=location.hash.replace(/^#\/?/,"")==="";return Ye(()=>{i&&(Zl(wy(n)),t())},[i]),y(My,{source:n,screen:e.screen,children:e.screen==="none"&&!i?y(kt,{kind:"warn",children:["this address names nothing here; ",y("a",{href:wy(n),children:"go to the start"})]}):y(mC,{source:n,route:e})})}function mC({source:n,route:e}){switch(e.screen){case"cluster":return y(v0,{});case"jobs":return y(x0,{});case"job":return y(z0,{source:n,id:e.job},e.job);case"viewer":return y(Bp,{source:n,route:e},e.job);default:return null}}function gC(){let[n,e]=et(null),[t,i]=et("");return Ye(()=>{Es("source").then(e,s=>i(Tn(s)))},[]),n?y(pC,{source:n}):t?y(kt,{kind:"bad",children:t}):null}function _C({source:n,report:e}){let[t]=Ty(),i=An(()=>Jl(_n(n.job??"",e.scenarios[0])),[]);return y(Bp,{source:n,route:t.screen==="viewer"?t:i,report:e})}async function xC(n,e){Pm(o=>e.answer(o));let t=await Es("source"),i=new CSSStyleSheet;i.replaceSync(await gd("app.css"));let s=n.attachShadow({mode:"open"});s.adoptedStyleSheets=[i];let r=s.appendChild(document.createElement("div"));ld(y(_C,{source:t,report:{scenarios:e.scenarios,root:r}}),r)}Lm();var Wh=document.getElementById("page"),Ay=Yl.of(document);Wh&&Ay?xC(Wh,Ay):Wh&&(Bm(),md(),ld(y(gC,{}),Wh));
