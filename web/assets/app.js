var Nt,Qp,Iy,Zs,Zh,Vl,em,Fl,tm,jh,Kh,Ly,ga=Symbol.for("pv"),Hl={},Gl=[],Dy=/^m(i|n|o|s|text|space)$/,Qh=Array.isArray,nm=Gl.slice,Pr=Object.assign;function Rr(n){n&&n.parentNode&&n.remove()}function Bl(n,e,t,i,s){var r={type:n,props:e,key:t,ref:i,__k:null,__:null,__b:0,__e:null,__c:null,constructor:ga,__v:s||++Qp,__i:-1,__u:0};return!s&&Nt.vnode&&Nt.vnode(r),r}function Ut(n){return n.children}function kl(n,e){this.props=n,this.context=e,this.__g=0}function Ks(n,e){if(e==null)return n.__&&Ks(n.__,n.__i+1);for(var t;e<n.__k.length;e++)if((t=n.__k[e])&&t.__e)return t.__e;return typeof n.type!="function"||n.props.__P?null:Ks(n)}function Ny(n){var e,t=n.__v,i=t.__e,s=[],r=[],o=n.__P;o&&((e=Pr({constructor:ga},t)).__v=t.__v+1,Nt.vnode&&Nt.vnode(e),ed(o,e,t,n.__n,o.namespaceURI,32&t.__u?[i]:null,s,i||Ks(t),32&t.__u,r),e.__v=t.__v,e.__.__k[e.__i]=e,lm(s,e,r),t.__=t.__e=null,e.__e!=i&&im(e))}function im(n){if((n=n.__)&&n.__c&&!n.props.__P)return n.__e=null,n.__k.some(function(e){return e&&(n.__e=e.__e)}),im(n)}function Kp(n){(8&n.__g||(n.__g|=8,Zs.push(n),Vl++))&&Zh==Nt.debounceRendering||((Zh=Nt.debounceRendering)||queueMicrotask)(sm)}function sm(){try{for(var n,e=1;Zs.length;)Zs.length>e&&Zs.sort(em),n=Zs.shift(),e=Zs.length,8&n.__g&&Ny(n)}finally{(Vl=Zs.length)&&(Zh||queueMicrotask)(sm)}}function rm(n,e,t,i,s,r,o,a,l,c,u){var f,h,d,p,b,m,g=i.__k||Gl,v=e.length;for(l=Uy(t,e,g,l,v),f=0;f<v;f++)(d=t.__k[f])!=null&&(h=~d.__i&&g[d.__i]||Hl,d.__i=f,m=ed(n,d,h,s,r,o,a,l,c,u),p=d.__e,(h.ref!=d.ref||8&h.__u)&&(h.ref&&td(h.ref,null,d,h),d.ref&&u.push(d.ref,d.__c||p,d)),b=b||p,4&d.__u?(l=om(d,l,n,!h.__v),h.__e&&(h.__e=null)):typeof d.type=="function"&&m!==void 0?l=m:p&&(l=p.nextSibling),d.__u&=-21);return t.__e=b,l}function Uy(n,e,t,i,s){var r,o,a,l,c,u,f,h,d,p=t.length,b=p,m=0,g=0,v=n.__k=Array(s);for(r=0;r<s;r++)(o=e[r])!=null&&typeof o!="boolean"&&typeof o!="function"?(typeof o!="object"||o.constructor===String?o=v[r]=Bl(null,o):Qh(o)?o=v[r]=Bl(Ut,{children:o}):o.constructor===ga&&o.__b?o=v[r]=Bl(o.type,o.props,o.key,o.ref,o.__v):v[r]=o,l=r+m,o.__=n,o.__b=n.__b+1,a=null,~(c=o.__i=Oy(o,t,l,b))&&(b--,(a=t[c])&&(a.__u|=2)),a&&a.__v?(o.__u|=16,c==l-1?m--:c==l+1?m++:c!=l&&(c>l?m--:m++,g=1)):(~c||(s>p?m--:s<p&&m++),typeof o.type!="function"&&(o.__u|=4))):v[r]=null;if(g){for(u=[],f=[],r=0;r<s;r++)if((o=v[r])&&16&o.__u){for(m=0,h=u.length;m<h;)u[d=m+h>>1]<o.__i?m=d+1:h=d;u[m]=o.__i,f[r]=m+1}for(m=u.length;r--;)f[r]&&(f[r]==m?m--:v[r].__u|=4)}if(b)for(r=0;r<p;r++)!(a=t[r])||2&a.__u||(a.__e==i&&(i=Ks(a)),nd(a,a));return i}function om(n,e,t,i){var s,r,o,a;if(typeof n.type=="function"){if(n.props.__P)return e;if(s=n.__k)for(r=0;r<s.length;r++)s[r]&&(s[r].__=n,e=om(s[r],e,t,!1));return e}for(e&&!e.parentNode&&(e=Ks(n))&&!e.parentNode&&(e=null),o=n.__e,a=e;a&&a.nodeType==8;)a=a.nextSibling;for(o!=a&&(!i&&t.moveBefore&&o.parentNode?t.moveBefore(o,e):t.insertBefore(o,e||null)),e=o;(e=e&&e.nextSibling)&&e.nodeType==8&&!e.data.startsWith("$s"););return e}function Oy(n,e,t,i){var s,r=n.key,o=n.type,a=e[t],l=a&&!(2&a.__u);if(a===null&&r==null||l&&r==a.key&&o==a.type)return t;if(i>(l?1:0)){for(s=t-1;s>=0;s--)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s;for(s=t+1;s<e.length;s++)if((a=e[s])&&!(2&a.__u)&&r==a.key&&o==a.type)return s}return-1}function jp(n,e,t){t==null&&(t=""),e[0]=="-"?n.setProperty(e,t):n[e]=t}function Ol(n,e,t,i,s){var r,o;if(e=="style")if(typeof t=="string")n.style.cssText=t;else{if(typeof i=="string"&&(n.style.cssText=i=""),i)for(e in i)t&&e in t||jp(n.style,e);if(t)for(e in t)i&&t[e]==i[e]||jp(n.style,e,t[e])}else if(e[0]=="o"&&e[1]=="n")typeof t!="function"&&(t=null),typeof i!="function"&&(i=null),(n.__e||(n.__e={}))[e]=t,t&&i||(o=Kh[e]||(Kh[e]=Fy(e)),(n.__a||(n.__a={}))[e]=jh,r=e!=(e=e.replace(tm,"$1")),(e=e.slice(2))[0]<"a"&&(e=e.toLowerCase()),t?n.addEventListener(e,o,r):n.removeEventListener(e,o,r));else{if(s=="http://www.w3.org/2000/svg")e=e.replace(/xlink(H|:h)/,"h").replace(/sName$/,"s");else if(e!="width"&&e!="height"&&e!="href"&&e!="list"&&e!="form"&&e!="tabIndex"&&e!="download"&&e!="rowSpan"&&e!="colSpan"&&e!="role"&&e!="popover"&&e in n)try{return void(n[e]=t??"")}catch{}if(typeof t=="function")return;t==null||t===!1&&e[4]!="-"?n.removeAttribute(e):n.setAttribute(e,e=="popover"&&t==1?"":t)}}function Fy(n){return function(e){var t=this.__e;if(t){if(t=t[n],e[Fl]==null)e[Fl]=jh++;else if(e[Fl]<this.__a[n])return;return t(Nt.event?Nt.event(e):e)}}}function ed(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,m,g,v,C,M,I,E,x,T,V,U,D,H=e.type;if(e.constructor!==ga)return null;128&t.__u&&(l=32&t.__u,u=t.__c.__z)&&(e.__u|=l,f=r=[],u.nodeType==8?a=zl(u,r):r.push(u),a=r[0]||a),(u=Nt.__b)&&u(e);e:if(typeof H=="function"){h=o.length;try{if(g=e.props,v=(u=H.prototype)&&u.render,C=(u=H.contextType)&&i[u.__c],M=u?C?C.props.value:u.__:i,(d=t.__c)?(e.__c=d,2&d.__g&&(d.__g|=1)):(v?e.__c=d=new H(g,M):(e.__c=d=new kl(g,M),d.constructor=H,d.render=ky),C&&C.sub(d),d.state||(d.state={}),d.__n=i,d.__g|=8,d.__h=[],d.__k=[]),v&&(d.__s||(d.__s=d.state),H.getDerivedStateFromProps&&(d.__s==d.state&&(d.__s=Pr({},d.__s)),Pr(d.__s,H.getDerivedStateFromProps(g,d.__s)))),p=d.props,b=d.state,d.__v=e,t.__c){if(g!==p&&v&&!H.getDerivedStateFromProps&&d.componentWillReceiveProps&&d.componentWillReceiveProps(g,M),e.__v==t.__v&&!(8&d.__g)||!(4&d.__g)&&d.shouldComponentUpdate&&d.shouldComponentUpdate(g,d.__s,M)===!1){e.__v!=t.__v&&(d.props=g,d.state=d.__s,d.__g&=-9),e.__e=t.__e,e.__k=t.__k,e.__k.some(function(O){O&&(O.__=e)}),Gl.push.apply(d.__h,d.__k),d.__k=[],d.__h.length&&o.push(d),a=Ks(t);break e}d.componentWillUpdate&&d.componentWillUpdate(g,d.__s,M),v&&d.componentDidUpdate&&d.__h.push(function(){d.componentDidUpdate(p,b,m)})}else v&&!H.getDerivedStateFromProps&&d.componentWillMount&&d.componentWillMount(),v&&d.componentDidMount&&d.__h.push(d.componentDidMount);d.context=M,d.props=g,d.__P=n,d.__g&=-5,I=Nt.__r,E=v?25:0;do d.__g&=-9,I&&I(e),u=d.render(d.props,d.state=d.__s,d.context);while(8&d.__g&&++E<25);v&&(Gl.push.apply(d.__h,d.__k),d.__k=[]),d.state=d.__s,d.getChildContext&&(i=Pr({},i,d.getChildContext())),v&&t.__c&&d.getSnapshotBeforeUpdate&&(m=d.getSnapshotBeforeUpdate(p,b)),x=u&&u.type===Ut&&u.key==null?u.props.children:u,g.__P&&(u=a,s=(n=g.__P).namespaceURI,l=r=null,t.props&&t.props.__P!=n&&(t.__k.some(function(O){O&&nd(O,O)}),t.__k=null),a=t.__k?Ks(t,0):null),a=rm(n,Qh(x)?x:[x],e,t,i,s,r,o,a,l,c),g.__P&&(e.__e=null,a=u),e.__u&=-161,f&&f.some(Rr),d.__h.length&&o.push(d),1&d.__g&&(d.__g&=-4)}catch(O){if(o.length=h,e.__v=null,l||r)if(O&&O.then){if(e.__u|=128|l,r){for(~(U=r.indexOf(a||void 0))||(U=r.length);(D=r[U-1])&&D.nodeType==8;)U--;for(;U<r.length;U++)if(D=r[U])if(r[U]=null,T){if(D==V)break}else{if(D.nodeType!=8)break;D.data.startsWith("$s")&&(V=zl(T=D))}}if(!T){for(;a&&a.nodeType==8&&a.nextSibling;)a=a.nextSibling;T=a}(u=zl(T=e.__c.__z||(e.__c.__z=T)))?(e.__e=T,a=u):e.__e=a,a=a&&a.nextSibling}else r&&r.some(Rr);else e.__e=t.__e;e.__k||(e.__k=t.__k||[]),O&&O.then||am(e),Nt.__e(O,e,t)}}else a=e.__e=By(t.__e,e,t,i,s,r,o,l,c,n);return(u=Nt.diffed)&&u(e),a}function zl(n,e){if(n&&n.nodeType==8&&n.data.startsWith("$s"))for(var t=1;n=n.nextSibling;){if(n.nodeType==8){if(n.data.startsWith("$s"))t++;else if(n.data.startsWith("/$s")&&!--t)return n}e&&e.push(n)}}function am(n){n&&(n.__c&&(n.__c.__g|=4),n.__k&&n.__k.some(am))}function lm(n,e,t){for(var i=0;i<t.length;)td(t[i++],t[i++],t[i++]);Nt.__c&&Nt.__c(e,n),n.some(function(s){try{n=s.__h,s.__h=[],n.some(function(r){r.call(s)})}catch(r){Nt.__e(r,s.__v)}})}function By(n,e,t,i,s,r,o,a,l,c){var u,f,h,d,p,b,m,g,v=t.props||Hl,C=e.props,M=e.type;if(M=="svg"?s="http://www.w3.org/2000/svg":M=="math"?s="http://www.w3.org/1998/Math/MathML":s||(s="http://www.w3.org/1999/xhtml"),r){for(u=0;u<r.length;u++)if((p=r[u])&&(M?p.localName==M:p.nodeType==3)){n=p,r[u]=null;break}}if(!n){if(g=c.ownerDocument||document,!M)return g.createTextNode(C);n=g.createElementNS(s,M,C.is?C:c),a&&(Nt.__m&&Nt.__m(e,r),a=!1),r=null}if(M){if(c=M=="template"&&n.content||n,r=M=="textarea"&&C.defaultValue!=null?null:r&&nm.call(c.childNodes),!a&&r)for(v={},u=0;u<n.attributes.length;u++)v[(p=n.attributes[u]).name]=p.value;for(u in v)p=v[u],u=="dangerouslySetInnerHTML"?h=p:u=="children"||u in C||u=="value"&&"defaultValue"in C||u=="checked"&&"defaultChecked"in C||Ol(n,u,null,p,s);for(u in C)p=C[u],u=="children"?d=p:u=="dangerouslySetInnerHTML"?f=p:u=="value"?b=p:u=="checked"?m=p:a&&typeof p!="function"||v[u]===p||Ol(n,u,p,v[u],s);f?(a||h&&(f.__html==h.__html||f.__html==n.innerHTML)||(n.innerHTML=f.__html),e.__k=[]):(h&&(n.textContent=""),(M=="foreignObject"||s=="http://www.w3.org/1998/Math/MathML"&&Dy.test(M))&&(s="http://www.w3.org/1999/xhtml"),rm(c,Qh(d)?d:[d],e,t,i,s,r,o,r?r[0]:t.__k&&Ks(t,0),a,l),r&&r.some(Rr)),a&&M!="textarea"||(u="value",M=="progress"&&b==null?n.removeAttribute(u):b==null||b===n[u]&&(M!="progress"||b)||Ol(n,u,b,v[u],s),u="checked",m!=null&&m!=n[u]&&Ol(n,u,m,v[u],s))}else v===C||a&&n.data==C||(n.data=C);return n}function td(n,e,t,i){try{typeof n=="function"?e?e.__x=n(e)||1:i&&(i=i.__c||i.__e)&&(e=i.__x)&&(i.__x=null,typeof e=="function"?e():n(null)):n.current=e}catch(s){Nt.__e(s,t)}}function nd(n,e,t){var i,s,r,o;if(Nt.unmount&&Nt.unmount(n),!(i=n.ref)||i.current&&i.current!=n.__e||td(i,null,e,n),i=n.__c){if(i.componentWillUnmount)try{i.componentWillUnmount()}catch(a){Nt.__e(a,e)}i.__P=i.__n=null}if(i=n.__k)for(o=0;o<i.length;o++)i[o]&&nd(i[o],e,typeof n.type!="function"||t&&!n.props.__P);!t&&(i=n.__c)&&(i=i.__z)&&(s=zl(i,r=[]))&&(i==n.__e&&r.some(Rr),Rr(s),Rr(i)),t||Rr(n.__e),n.__e=n.__c=n.__=null}function ky(n,e,t){return this.constructor(n,t)}function cm(n,e){var t,i,s,r;Nt.__&&Nt.__(n,e),e.nodeType==9&&(e=e.documentElement),i=(t=n&&32&n.__u)?null:e.__k,e.__k=Bl(Ut,{children:[n]}),s=[],r=[],ed(e,e.__k,i||Hl,Hl,e.namespaceURI,i?null:e.firstChild?nm.call(e.childNodes):null,s,i?i.__e:e.firstChild,t,r),lm(s,e.__k,r),e.__k.props.children=null}Nt={__e:function(n,e,t,i){for(var s,r,o;e=e.__;)if((s=e.__c)&&!(1&s.__g)){s.__g|=4;try{if((o=(r=s.constructor)&&r.getDerivedStateFromError)&&s.setState(r.getDerivedStateFromError(n)),s.componentDidCatch&&(s.componentDidCatch(n,i||{}),o=1),o&&8&s.__g)return void(s.__g|=2)}catch(a){n=a}}throw Vl=0,n}},Qp=0,Iy=function(n){return n!=null&&n.constructor===ga},kl.prototype.setState=function(n,e){var t=this.__s;t&&t!=this.state||(t=this.__s=Pr({},this.state)),typeof n=="function"&&(n=n(Pr({},t),this.props)),n&&(Pr(t,n),this.__v&&(e&&this.__k.push(e),Kp(this)))},kl.prototype.forceUpdate=function(n){this.__v&&(this.__g|=4,n&&this.__h.push(n),Kp(this))},kl.prototype.render=Ut,Zs=[],Vl=0,em=function(n,e){return n.__v.__b-e.__v.__b},Fl=Symbol(),tm=/(PointerCapture)$|Capture$/i,jh=0,Kh={},Ly=0;var xa,Mn,id,um,sd=Object.is,ya=0,ym=[],rd=[],gn=Nt,hm=gn.__b,dm=gn.__r,fm=gn.diffed,pm=gn.__c,mm=gn.unmount,gm=gn.__;function ad(n,e){gn.__h&&gn.__h(Mn,n,ya||e),ya=0;var t=Mn.__H||(Mn.__H={__:[],__h:[]});return n>=t.__.length&&t.__.push({}),t.__[n]}function Qe(n){return ya=1,zy(bm,n)}function zy(n,e,t){var i=ad(xa++,2);if(i.t=n,!i.__c&&(i.__=[t?t(e):bm(void 0,e),function(r){var o=(i.__N||i.__)[0],a=i.t(o,r);sd(o,a)||(i.__N=[a,i.__[1]],i.__c.setState({}))}],i.__c=Mn,!Mn.__f)){Mn.__f=!0;var s=Mn.shouldComponentUpdate;Mn.shouldComponentUpdate=function(r,o,a){var l=this.__H;if(!l)return!0;var c=!1,u=this.props!=r;if(l.__.some(function(h){h.__N&&(c=!0,sd(h.__[0],h.__N[0])||(u=!0))}),s){var f=s.call(this,r,o,a);return c?f||u:f}return!c||u}}return i.__}function Ye(n,e){var t=ad(xa++,3);!gn.__s&&vm(t.__H,e)&&(t.__P=!0,t.__=n,t.u=e,Mn.__H.__h.push(t))}function on(n){return ya=5,Jn(function(){return{current:n}},[])}function Jn(n,e){var t=ad(xa++,7);return vm(t.__H,e)&&(t.__=n(),t.__H=e),t.__}function ld(n,e){return ya=8,Jn(function(){return n},e)}function Vy(){var n;do{for(;n=rd.shift();)try{_a(n)}catch(t){gn.__e(t,{__:(n=n.__P)&&n.__v})}for(;n=ym.shift();){var e=n.__H;if(n.__P&&e)try{e.__h.some(_a),e.__h.some(od),e.__h=[]}catch(t){e.__h=[],gn.__e(t,n.__v)}}}while(rd.length)}gn.__b=function(n){Mn=null,hm&&hm(n)},gn.__=function(n,e){n&&e.__k&&e.__k.__m&&(n.__m=e.__k.__m),gm&&gm(n,e)},gn.__r=function(n){dm&&dm(n),xa=0;var e=(Mn=n.__c).__H;e&&(id==Mn?Mn.__h=[]:(e.__h.some(_a),e.__h.some(od),xa=0),e.__h=[],e.__.some(function(t){t.__N&&(t.__=t.__N),t.u=t.__N=void 0})),id=Mn},gn.diffed=function(n){fm&&fm(n);var e=n.__c;e&&e.__H&&(e.__H.__h.length&&xm(ym.push(e)),e.__H.__.some(function(t){t.u&&(t.__H=t.u)})),id=Mn=null},gn.__c=function(n,e){e.some(function(t){try{t.__h.some(_a),t.__h=t.__h.filter(function(i){return!i.__||od(i)})}catch(i){t.__h=[function(){throw i}]}}),pm&&pm(n,e)},gn.unmount=function(n){mm&&mm(n);var e,t,i=n.__c;i&&i.__H&&(i.__H.__.some(function(s){try{if(s.__P&&s.__c){if(t===void 0){for(t=n.__;t&&(!t.__c||!t.__c.__P);)t=t.__;t=t&&t.__c}s.__P=t,xm(rd.push(s))}else _a(s)}catch(r){e=r}}),i.__H=void 0,e&&gn.__e(e,i.__v))};var _m=typeof requestAnimationFrame=="function";function Hy(n){var e,t=function(){clearTimeout(i),_m&&cancelAnimationFrame(e),setTimeout(n)},i=setTimeout(t,35);_m&&(e=requestAnimationFrame(t))}function xm(n){n!=1&&um==gn.requestAnimationFrame||((um=gn.requestAnimationFrame)||Hy)(Vy)}function _a(n){var e=Mn,t=n.__c;typeof t=="function"&&(n.__c=void 0,t()),Mn=e}function od(n){var e=Mn;n.__c=n.__(),Mn=e}function vm(n,e){return!n||n.length!=e.length||e.some(function(t,i){return!sd(t,n[i])})}function bm(n,e){return typeof e=="function"?e(n):e}function Gy(n,e){switch(n){case"|u1":return new Uint8Array(e);case"<u4":return new Uint32Array(e);case"<f4":return new Float32Array(e);case"<f8":return new Float64Array(e);case"<u8":return Float64Array.from(new BigUint64Array(e),Number);default:throw new Error(`an NPY array of type ${n}, which this page does not know`)}}function Sm(n){let e=new Uint8Array(n);if(e.length<10||e[0]!==147||e[1]!==78||e[6]!==1)throw new Error("not an NPY array of format 1.0");let t=10+e[8]+256*e[9],i=new TextDecoder("latin1").decode(e.subarray(10,t)),s=/'descr':\s*'([^']+)'/.exec(i)?.[1]??"",r=(/'shape':\s*\(([^)]*)\)/.exec(i)?.[1]??"").split(",").filter(a=>a.trim()!=="").map(Number);if(/'fortran_order':\s*True/.test(i))throw new Error("an NPY array in Fortran order, which this page does not read");let o=Gy(s,n.slice(t));if(o.length!==r.reduce((a,l)=>a*l,1))throw new Error("an NPY array that is cut short");return{shape:r,values:o}}var js=class extends Error{constructor(t,i){super(i);this.status=t}status},Mm="cdcluster.key",Wl="";function Wy(){try{return localStorage.getItem(Mm)??Wl}catch{return Wl}}function cd(){let n=/^#key=([^&]*)&?(.*)$/.exec(location.hash);if(n){Wl=n[1];try{localStorage.setItem(Mm,Wl)}catch{}history.replaceState(null,"",`${location.pathname}#${n[2]}`)}}async function Xy(n){try{let e=await n.json();if(typeof e=="object"&&e!==null&&"error"in e)return String(e.error)}catch{}return`the server answered ${n.status}`}async function ud(n,e){let t=Wy(),i=t===""?{}:{Authorization:`Bearer ${t}`},s;try{s=await fetch(`api/v1/${n}`,{headers:i,credentials:"same-origin",...e?{signal:e}:{}})}catch(r){throw e?.aborted?r:new js(0,"the server does not answer: has it ended?")}if(!s.ok)throw new js(s.status,await Xy(s));return s}async function Qs(n,e){return await(await ud(n,e)).json()}async function cs(n,e){let t=await ud(n,e);return{...Sm(await t.arrayBuffer()),cut:t.headers.get("X-Cut")==="true"}}async function wm(n,e){return(await ud(n,e)).arrayBuffer()}function us(n){return n instanceof DOMException&&n.name==="AbortError"}function wn(n){return n instanceof Error?n.message:String(n)}var ql=new Map,Xl=[];function Ni(n,e){return ql.set(n,e),()=>{ql.get(n)===e&&ql.delete(n)}}function Am(){addEventListener("error",n=>Xl.push(n.message)),addEventListener("unhandledrejection",n=>Xl.push(String(n.reason))),document.addEventListener("securitypolicyviolation",n=>Xl.push(`policy: ${n.violatedDirective} ${n.blockedURI}`)),window.cdcluster={facts:()=>Object.assign({ready:!1,errors:[...Xl]},...[...ql.values()].map(n=>n()))}}function Yl(n){let[e,t]=n.replace(/^#/,"").split("?",2),i={screen:"none",job:"",scenario:0,query:new URLSearchParams(t??"")},s=e.split("/").filter(o=>o!=="");if(s.length===1&&(s[0]==="cluster"||s[0]==="jobs"))return{...i,screen:s[0]};if(s[0]!=="jobs"||s.length<2||s.length>3)return i;let r=qy(s[1]);return s.length===2?{...i,screen:"job",job:r}:/^\d+$/.test(s[2])?{...i,screen:"viewer",job:r,scenario:Number(s[2])}:i}function qy(n){try{return decodeURIComponent(n)}catch{return n}}function er(n){return`#/jobs/${encodeURIComponent(n)}`}function On(n,e,t={}){let i=new URLSearchParams(t).toString().replaceAll("%2C",",").replaceAll("%3A",":").replaceAll("%2F","/");return`${er(n)}/${e}${i===""?"":`?${i}`}`}var Tm=0;function Ts(n){Ir(),location.hash=n}function $l(n){Ir(),history.replaceState(null,"",n)}function Em(n){Ir(),Tm=window.setTimeout(()=>history.replaceState(null,"",n),200)}function Ir(){clearTimeout(Tm)}var Cm="cdcluster.theme",Jl=new Set;function Rm(){let n=document.documentElement.dataset.theme;return n==="light"||n==="dark"?n:"system"}function Pm(n){n==="system"?delete document.documentElement.dataset.theme:document.documentElement.dataset.theme=n;try{localStorage.setItem(Cm,n)}catch{}Jl.forEach(e=>e())}function Im(){try{let n=localStorage.getItem(Cm);(n==="light"||n==="dark")&&(document.documentElement.dataset.theme=n)}catch{}matchMedia("(prefers-color-scheme: dark)").addEventListener("change",()=>Jl.forEach(n=>n()))}function Zl(n){return Jl.add(n),()=>Jl.delete(n)}function Gi(n){return getComputedStyle(document.documentElement).getPropertyValue(n).trim()}function He(n){return(n<0?"-":"")+String(Math.round(Math.abs(n))).replace(/\B(?=(\d{3})+$)/g," ")}function Zn(n,e=4){return Number.isFinite(n)?String(Number(n.toPrecision(e))):n>0?"infinite":"-"}function An(n){return Number.isFinite(n)?`${n>0&&n<.001?"< 0.1":Zn(100*n,3)} %`:"-"}function Kl(n,e,t){let i=0;for(;Math.abs(n)>=e&&i+1<t.length;)n/=e,i+=1;let s=i===0?String(Math.round(n)):n.toPrecision(3);return t[i]===""?s:s+" "+t[i]}function Es(n){return Kl(n,1024,["B","KiB","MiB","GiB","TiB"])}function Lm(n){return`${Kl(n,1e3,["B","kB","MB","GB"])}/s`}function Dm(n,e){if(n<.01*e)return`${Es(n)} of ${Es(e)}`;let[t,i]=Es(e).split(" ");return`${(n/(e/Number(t))).toPrecision(2)} of ${t} ${i}`}function tr(n){return`${Kl(n,1e3,["","k","M","G"])}/s`}function hd(n){return Kl(n,1e3,["","k","M","G"])}function Lr(n){if(!Number.isFinite(n))return"-";if(n<10)return`${Zn(n,2)} s`;let e=Math.round(n),t=i=>String(i).padStart(2,"0");return e<3600?`${Math.floor(e/60)}:${t(e%60)}`:e<86400?`${Math.floor(e/3600)} h ${t(Math.floor(e%3600/60))}`:`${Math.floor(e/86400)} d ${Math.floor(e%86400/3600)} h`}function jt(n,e){return`${He(n)} ${e}${n===1?"":"s"}`}function va(n){return/^[\w./:@%+=,-]+$/.test(n)?n:`'${n.replaceAll("'","'\\''")}'`}function ba(n){return n.split("/").pop()||n}var Yy="uplot",$y="u-hz",Jy="u-vt",Zy="u-title",Ky="u-wrap",jy="u-under",Qy="u-over",ev="u-axis",Ur="u-off",tv="u-select",nv="u-cursor-x",iv="u-cursor-y",sv="u-cursor-pt",rv="u-legend",ov="u-live",av="u-inline",lv="u-series",cv="u-marker",Nm="u-label",uv="u-value",Ma="width",wa="height";var Um="bottom",co="left",dd="right",Rd="#000",Om=Rd+"0",fd="mousemove",Fm="mousedown",pd="mouseup",Bm="mouseenter",km="mouseleave",zm="dblclick",hv="resize",dv="scroll",Vm="change",nc="dppxchange",Pd="--",_o=typeof window<"u",yd=_o?document:null,ho=_o?window:null,fv=_o?navigator:null,Tt,jl;function vd(){let n=devicePixelRatio;Tt!=n&&(Tt=n,jl&&Sd(Vm,jl,vd),jl=matchMedia(`(min-resolution: ${Tt-.001}dppx) and (max-resolution: ${Tt+.001}dppx)`),Or(Vm,jl,vd),ho.dispatchEvent(new CustomEvent(nc)))}function Mi(n,e){if(e!=null){let t=n.classList;!t.contains(e)&&t.add(e)}}function bd(n,e){let t=n.classList;t.contains(e)&&t.remove(e)}function $t(n,e,t){n.style[e]=t+"px"}function Wi(n,e,t,i){let s=yd.createElement(n);return e!=null&&Mi(s,e),t?.insertBefore(s,i),s}function Ui(n,e){return Wi("div",n,e)}var Hm=new WeakMap;function hs(n,e,t,i,s){let r="translate("+e+"px,"+t+"px)",o=Hm.get(n);r!=o&&(n.style.transform=r,Hm.set(n,r),e<0||t<0||e>i||t>s?Mi(n,Ur):bd(n,Ur))}var Gm=new WeakMap;function Wm(n,e,t){let i=e+t,s=Gm.get(n);i!=s&&(Gm.set(n,i),n.style.background=e,n.style.borderColor=t)}var Xm=new WeakMap;function qm(n,e,t,i){let s=e+""+t,r=Xm.get(n);s!=r&&(Xm.set(n,s),n.style.height=t+"px",n.style.width=e+"px",n.style.marginLeft=i?-e/2+"px":0,n.style.marginTop=i?-t/2+"px":0)}var Id={passive:!0},pv={...Id,capture:!0};function Or(n,e,t,i){e.addEventListener(n,t,i?pv:Id)}function Sd(n,e,t,i){e.removeEventListener(n,t,Id)}_o&&vd();function Xi(n,e,t,i){let s;t=t||0,i=i||e.length-1;let r=i<=2147483647;for(;i-t>1;)s=r?t+i>>1:wi((t+i)/2),e[s]<n?t=s:i=s;return n-e[t]<=e[i]-n?t:i}function vg(n){return(t,i,s)=>{let r=-1,o=-1;for(let a=i;a<=s;a++)if(n(t[a])){r=a;break}for(let a=s;a>=i;a--)if(n(t[a])){o=a;break}return[r,o]}}var bg=n=>n!=null,Sg=n=>n!=null&&n>0,rc=vg(bg),mv=vg(Sg);function gv(n,e,t,i=0,s=!1){let r=s?mv:rc,o=s?Sg:bg;[e,t]=r(n,e,t);let a=n[e],l=n[e];if(e>-1)if(i==1)a=n[e],l=n[t];else if(i==-1)a=n[t],l=n[e];else for(let c=e;c<=t;c++){let u=n[c];o(u)&&(u<a?a=u:u>l&&(l=u))}return[a??Vt,l??-Vt]}function oc(n,e,t,i){let s=Jm(n),r=Jm(e);n==e&&(s==-1?(n*=t,e/=t):(n/=t,e*=t));let o=t==10?Cs:Mg,a=s==1?wi:Oi,l=r==1?Oi:wi,c=a(o(En(n))),u=l(o(En(e))),f=fo(t,c),h=fo(t,u);return t==10&&(c<0&&(f=Ht(f,-c)),u<0&&(h=Ht(h,-u))),i||t==2?(n=f*s,e=h*r):(n=Eg(n,f),e=ac(e,h)),[n,e]}function Ld(n,e,t,i){let s=oc(n,e,t,i);return n==0&&(s[0]=0),e==0&&(s[1]=0),s}var Dd=.1,Ym={mode:3,pad:Dd},Ta={pad:0,soft:null,mode:0},_v={min:Ta,max:Ta};function ic(n,e,t,i){return lc(t)?$m(n,e,t):(Ta.pad=t,Ta.soft=i?0:null,Ta.mode=i?3:0,$m(n,e,_v))}function wt(n,e){return n??e}function xv(n,e,t){for(e=wt(e,0),t=wt(t,n.length-1);e<=t;){if(n[e]!=null)return!0;e++}return!1}function $m(n,e,t){let i=t.min,s=t.max,r=wt(i.pad,0),o=wt(s.pad,0),a=wt(i.hard,-Vt),l=wt(s.hard,Vt),c=wt(i.soft,Vt),u=wt(s.soft,-Vt),f=wt(i.mode,0),h=wt(s.mode,0),d=e-n,p=Cs(d),b=oi(En(n),En(e)),m=Cs(b),g=En(m-p);(d<1e-24||g>10)&&(d=0,(n==0||e==0)&&(d=1e-24,f==2&&c!=Vt&&(r=0),h==2&&u!=-Vt&&(o=0)));let v=d||b||1e3,C=Cs(v),M=fo(10,wi(C)),I=v*(d==0?n==0?.1:1:r),E=Ht(Eg(n-I,M/10),24),x=n>=c&&(f==1||f==3&&E<=c||f==2&&E>=c)?c:Vt,T=oi(a,E<x&&n>=x?x:qi(x,E)),V=v*(d==0?e==0?.1:1:o),U=Ht(ac(e+V,M/10),24),D=e<=u&&(h==1||h==3&&U>=u||h==2&&U<=u)?u:-Vt,H=qi(l,U>D&&e<=D?D:oi(D,U));return T==H&&T==0&&(H=100),[T,H]}var yv=new Intl.NumberFormat(_o?fv.language:"en-US"),Nd=n=>yv.format(n),Ai=Math,tc=Ai.PI,En=Ai.abs,wi=Ai.floor,Tn=Ai.round,Oi=Ai.ceil,qi=Ai.min,oi=Ai.max,fo=Ai.pow,Jm=Ai.sign,Cs=Ai.log10,Mg=Ai.log2,vv=(n,e=1)=>Ai.sinh(n)*e,md=(n,e=1)=>Ai.asinh(n/e),Vt=1/0;function Zm(n){return(Cs((n^n>>31)-(n>>31))|0)+1}function Md(n,e,t){return qi(oi(n,e),t)}function wg(n){return typeof n=="function"}function yt(n){return wg(n)?n:()=>n}var bv=()=>{},Ag=n=>n,Tg=(n,e)=>e,Sv=n=>null,Km=n=>!0,jm=(n,e)=>n==e,Mv=/\.\d*?(?=9{6,}|0{6,})/gm,Fr=n=>{if(Rg(n)||ir.has(n))return n;let e=`${n}`,t=e.match(Mv);if(t==null)return n;let i=t[0].length-1;if(e.indexOf("e-")!=-1){let[s,r]=e.split("e");return+`${Fr(s)}e${r}`}return Ht(n,i)};function Dr(n,e){return Fr(Ht(Fr(n/e))*e)}function ac(n,e){return Fr(Oi(Fr(n/e))*e)}function Eg(n,e){return Fr(wi(Fr(n/e))*e)}function Ht(n,e=0){if(Rg(n))return n;let t=10**e,i=n*t*(1+Number.EPSILON);return Tn(i)/t}var ir=new Map;function Cg(n){return((""+n).split(".")[1]||"").length}function Ca(n,e,t,i){let s=[],r=i.map(Cg);for(let o=e;o<t;o++){let a=En(o),l=Ht(fo(n,o),a);for(let c=0;c<i.length;c++){let u=n==10?+`${i[c]}e${o}`:i[c]*l,f=(o>=0?0:a)+(o>=r[c]?0:r[c]),h=n==10?u:Ht(u,f);s.push(h),ir.set(h,f)}}return s}var Ea={},Ud=[],po=[null,null],nr=Array.isArray,Rg=Number.isInteger,wv=n=>n===void 0;function Qm(n){return typeof n=="string"}function lc(n){let e=!1;if(n!=null){let t=n.constructor;e=t==null||t==Object}return e}function Av(n){return n!=null&&typeof n=="object"}var Tv=Object.getPrototypeOf(Uint8Array),Pg="__proto__";function mo(n,e=lc){let t;if(nr(n)){let i=n.find(s=>s!=null);if(nr(i)||e(i)){t=Array(n.length);for(let s=0;s<n.length;s++)t[s]=mo(n[s],e)}else t=n.slice()}else if(n instanceof Tv)t=n.slice();else if(e(n)){t={};for(let i in n)i!=Pg&&(t[i]=mo(n[i],e))}else t=n;return t}function _n(n){let e=arguments;for(let t=1;t<e.length;t++){let i=e[t];for(let s in i)s!=Pg&&(lc(n[s])?_n(n[s],mo(i[s])):n[s]=mo(i[s]))}return n}var Ev=0,Cv=1,Rv=2;function Pv(n,e,t){for(let i=0,s,r=-1;i<e.length;i++){let o=e[i];if(o>r){for(s=o-1;s>=0&&n[s]==null;)n[s--]=null;for(s=o+1;s<t&&n[s]==null;)n[r=s++]=null}}}function Iv(n,e){if(Nv(n)){let o=n[0].slice();for(let a=1;a<n.length;a++)o.push(...n[a].slice(1));return Uv(o[0])||(o=Dv(o)),o}let t=new Set;for(let o=0;o<n.length;o++){let l=n[o][0],c=l.length;for(let u=0;u<c;u++)t.add(l[u])}let i=[Array.from(t).sort((o,a)=>o-a)],s=i[0].length,r=new Map;for(let o=0;o<s;o++)r.set(i[0][o],o);for(let o=0;o<n.length;o++){let a=n[o],l=a[0];for(let c=1;c<a.length;c++){let u=a[c],f=Array(s).fill(void 0),h=e?e[o][c]:Cv,d=[];for(let p=0;p<u.length;p++){let b=u[p],m=r.get(l[p]);b===null?h!=Ev&&(f[m]=b,h==Rv&&d.push(m)):f[m]=b}Pv(f,d,s),i.push(f)}}return i}var Lv=typeof queueMicrotask>"u"?n=>Promise.resolve().then(n):queueMicrotask;function Dv(n){let e=n[0],t=e.length,i=Array(t);for(let r=0;r<i.length;r++)i[r]=r;i.sort((r,o)=>e[r]-e[o]);let s=[];for(let r=0;r<n.length;r++){let o=n[r],a=Array(t);for(let l=0;l<t;l++)a[l]=o[i[l]];s.push(a)}return s}function Nv(n){let e=n[0][0],t=e.length;for(let i=1;i<n.length;i++){let s=n[i][0];if(s.length!=t)return!1;if(s!=e){for(let r=0;r<t;r++)if(s[r]!=e[r])return!1}}return!0}function Uv(n,e=100){let t=n.length;if(t<=1)return!0;let i=0,s=t-1;for(;i<=s&&n[i]==null;)i++;for(;s>=i&&n[s]==null;)s--;if(s<=i)return!0;let r=oi(1,wi((s-i+1)/e));for(let o=n[i],a=i+r;a<=s;a+=r){let l=n[a];if(l!=null){if(l<=o)return!1;o=l}}return!0}var Ig=["January","February","March","April","May","June","July","August","September","October","November","December"],Lg=["Sunday","Monday","Tuesday","Wednesday","Thursday","Friday","Saturday"];function Dg(n){return n.slice(0,3)}var Ov=Lg.map(Dg),Fv=Ig.map(Dg),Bv={MMMM:Ig,MMM:Fv,WWWW:Lg,WWW:Ov};function Sa(n){return(n<10?"0":"")+n}function kv(n){return(n<10?"00":n<100?"0":"")+n}var zv={YYYY:n=>n.getFullYear(),YY:n=>(n.getFullYear()+"").slice(2),MMMM:(n,e)=>e.MMMM[n.getMonth()],MMM:(n,e)=>e.MMM[n.getMonth()],MM:n=>Sa(n.getMonth()+1),M:n=>n.getMonth()+1,DD:n=>Sa(n.getDate()),D:n=>n.getDate(),WWWW:(n,e)=>e.WWWW[n.getDay()],WWW:(n,e)=>e.WWW[n.getDay()],HH:n=>Sa(n.getHours()),H:n=>n.getHours(),h:n=>{let e=n.getHours();return e==0?12:e>12?e-12:e},AA:n=>n.getHours()>=12?"PM":"AM",aa:n=>n.getHours()>=12?"pm":"am",a:n=>n.getHours()>=12?"p":"a",mm:n=>Sa(n.getMinutes()),m:n=>n.getMinutes(),ss:n=>Sa(n.getSeconds()),s:n=>n.getSeconds(),fff:n=>kv(n.getMilliseconds())};function Od(n,e){e=e||Bv;let t=[],i=/\{([a-z]+)\}|[^{]+/gi,s;for(;s=i.exec(n);)t.push(s[0][0]=="{"?zv[s[1]]:s[0]);return r=>{let o="";for(let a=0;a<t.length;a++)o+=typeof t[a]=="string"?t[a]:t[a](r,e);return o}}var Vv=new Intl.DateTimeFormat().resolvedOptions().timeZone;function Hv(n,e){let t;return e=="UTC"||e=="Etc/UTC"?t=new Date(+n+n.getTimezoneOffset()*6e4):e==Vv?t=n:(t=new Date(n.toLocaleString("en-US",{timeZone:e})),t.setMilliseconds(n.getMilliseconds())),t}var Ng=n=>n%1==0,sc=[1,2,2.5,5],Gv=Ca(10,-32,0,sc),Ug=Ca(10,0,32,sc),Wv=Ug.filter(Ng),Nr=Gv.concat(Ug),Fd=`
`,Og="{YYYY}",eg=Fd+Og,Fg="{M}/{D}",Aa=Fd+Fg,Ql=Aa+"/{YY}",Bg="{aa}",Xv="{h}:{mm}",uo=Xv+Bg,tg=Fd+uo,ng=":{ss}",Ct=null;function kg(n){let e=n*1e3,t=e*60,i=t*60,s=i*24,r=s*30,o=s*365,l=(n==1?Ca(10,0,3,sc).filter(Ng):Ca(10,-3,0,sc)).concat([e,e*5,e*10,e*15,e*30,t,t*5,t*10,t*15,t*30,i,i*2,i*3,i*4,i*6,i*8,i*12,s,s*2,s*3,s*4,s*5,s*6,s*7,s*8,s*9,s*10,s*15,r,r*2,r*3,r*4,r*6,o,o*2,o*5,o*10,o*25,o*50,o*100]),c=[[o,Og,Ct,Ct,Ct,Ct,Ct,Ct,1],[s*28,"{MMM}",eg,Ct,Ct,Ct,Ct,Ct,1],[s,Fg,eg,Ct,Ct,Ct,Ct,Ct,1],[i,"{h}"+Bg,Ql,Ct,Aa,Ct,Ct,Ct,1],[t,uo,Ql,Ct,Aa,Ct,Ct,Ct,1],[e,ng,Ql+" "+uo,Ct,Aa+" "+uo,Ct,tg,Ct,1],[n,ng+".{fff}",Ql+" "+uo,Ct,Aa+" "+uo,Ct,tg,Ct,1]];function u(f){return(h,d,p,b,m,g)=>{let v=[],C=m>=o,M=m>=r&&m<o,I=f(p),E=Ht(I*n,3),x=gd(I.getFullYear(),C?0:I.getMonth(),M||C?1:I.getDate()),T=Ht(x*n,3);if(M||C){let V=M?m/r:0,U=C?m/o:0,D=E==T?E:Ht(gd(x.getFullYear()+U,x.getMonth()+V,1)*n,3),H=new Date(Tn(D/n)),O=H.getFullYear(),L=H.getMonth();for(let X=0;D<=b;X++){let $=gd(O+U*X,L+V*X,1),G=$-f(Ht($*n,3));D=Ht((+$+G)*n,3),D<=b&&v.push(D)}}else{let V=m>=s?s:m,U=wi(p)-wi(E),D=T+U+ac(E-T,V);v.push(D);let H=f(D),O=H.getHours()+H.getMinutes()/t+H.getSeconds()/i,L=m/i,X=h.axes[d]._space,$=g/X;for(;D=Ht(D+m,n==1?0:3),!(D>b);)if(L>1){let G=wi(Ht(O+L,6))%24,Q=f(D).getHours()-G;Q>1&&(Q=-1),D-=Q*i,O=(O+L)%24;let ie=v[v.length-1];Ht((D-ie)/m,3)*$>=.7&&v.push(D)}else v.push(D)}return v}}return[l,c,u]}var[qv,Yv,$v]=kg(1),[Jv,Zv,Kv]=kg(.001);Ca(2,-53,53,[1]);function ig(n,e){return n.map(t=>t.map((i,s)=>s==0||s==8||i==null?i:e(s==1||t[8]==0?i:t[1]+i)))}function sg(n,e){return(t,i,s,r,o)=>{let a=e.find(p=>o>=p[0])||e[e.length-1],l,c,u,f,h,d;return i.map(p=>{let b=n(p),m=b.getFullYear(),g=b.getMonth(),v=b.getDate(),C=b.getHours(),M=b.getMinutes(),I=b.getSeconds(),E=m!=l&&a[2]||g!=c&&a[3]||v!=u&&a[4]||C!=f&&a[5]||M!=h&&a[6]||I!=d&&a[7]||a[1];return l=m,c=g,u=v,f=C,h=M,d=I,E(b)})}}function jv(n,e){let t=Od(e);return(i,s,r,o,a)=>s.map(l=>t(n(l)))}function gd(n,e,t){return new Date(n,e,t)}function rg(n,e){return e(n)}var Qv="{YYYY}-{MM}-{DD} {h}:{mm}{aa}";function og(n,e){return(t,i,s,r)=>r==null?Pd:e(n(i))}function eb(n,e){let t=n.series[e];return t.width?t.stroke(n,e):t.points.width?t.points.stroke(n,e):null}function tb(n,e){return n.series[e].fill(n,e)}var nb={show:!0,live:!0,isolate:!1,mount:bv,markers:{show:!0,width:2,stroke:eb,fill:tb,dash:"solid"},idx:null,idxs:null,values:[]};function ib(n,e){let t=n.cursor.points,i=Ui(),s=t.size(n,e);$t(i,Ma,s),$t(i,wa,s);let r=s/-2;$t(i,"marginLeft",r),$t(i,"marginTop",r);let o=t.width(n,e,s);return o&&$t(i,"borderWidth",o),i}function sb(n,e){let t=n.series[e].points;return t._fill||t._stroke}function rb(n,e){let t=n.series[e].points;return t._stroke||t._fill}function ob(n,e){return n.series[e].points.size}var _d=[0,0];function ab(n,e,t){return _d[0]=e,_d[1]=t,_d}function ec(n,e,t,i=!0){return s=>{s.button==0&&(!i||s.target==e)&&t(s)}}function xd(n,e,t,i=!0){return s=>{(!i||s.target==e)&&t(s)}}var lb={show:!0,x:!0,y:!0,lock:!1,move:ab,points:{one:!1,show:ib,size:ob,width:0,stroke:rb,fill:sb},bind:{mousedown:ec,mouseup:ec,click:ec,dblclick:ec,mousemove:xd,mouseleave:xd,mouseenter:xd},drag:{setScale:!0,x:!0,y:!1,dist:0,uni:null,click:(n,e)=>{e.stopPropagation(),e.stopImmediatePropagation()},_x:!1,_y:!1},focus:{dist:(n,e,t,i,s)=>i-s,prox:-1,bias:0},hover:{skip:[void 0],prox:null,bias:0},left:-10,top:-10,idx:null,dataIdx:null,idxs:null,event:null},zg={show:!0,stroke:"rgba(0,0,0,0.07)",width:2},Bd=_n({},zg,{filter:Tg}),Vg=_n({},Bd,{size:10}),Hg=_n({},zg,{show:!1}),kd='12px system-ui, -apple-system, "Segoe UI", Roboto, "Helvetica Neue", Arial, "Noto Sans", sans-serif, "Apple Color Emoji", "Segoe UI Emoji", "Segoe UI Symbol", "Noto Color Emoji"',Gg="bold "+kd,Wg=1.5,ag={show:!0,scale:"x",stroke:Rd,space:50,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Gg,side:2,grid:Bd,ticks:Vg,border:Hg,font:kd,lineGap:Wg,rotate:0},cb="Value",ub="Time",lg={show:!0,scale:"x",auto:!1,sorted:1,min:Vt,max:-Vt,idxs:[]};function hb(n,e,t,i,s){return e.map(r=>r==null?"":Nd(r))}function db(n,e,t,i,s,r,o){let a=[],l=ir.get(s)||0;t=o?t:Ht(ac(t,s),l);for(let c=t;c<=i;c=Ht(c+s,l))a.push(Object.is(c,-0)?0:c);return a}function wd(n,e,t,i,s,r,o){let a=[],l=n.scales[n.axes[e].scale].log,c=l==10?Cs:Mg,u=wi(c(t));s=fo(l,u),l==10&&(s=Nr[Xi(s,Nr)]);let f=t,h=s*l;l==10&&(h=Nr[Xi(h,Nr)]);do a.push(f),f=f+s,l==10&&!ir.has(f)&&(f=Ht(f,ir.get(s))),f>=h&&(s=f,h=s*l,l==10&&(h=Nr[Xi(h,Nr)]));while(f<=i);return a}function fb(n,e,t,i,s,r,o){let l=n.scales[n.axes[e].scale].asinh,c=i>l?wd(n,e,oi(l,t),i,s):[l],u=i>=0&&t<=0?[0]:[];return(t<-l?wd(n,e,oi(l,-i),-t,s):[l]).reverse().map(h=>-h).concat(u,c)}var Xg=/./,pb=/[12357]/,mb=/[125]/,cg=/1/,Ad=(n,e,t,i)=>n.map((s,r)=>e==4&&s==0||r%i==0&&t.test(s.toExponential()[s<0?1:0])?s:null);function gb(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=n.scales[o],l=n.valToPos,c=r._space,u=l(10,o),f=l(9,o)-u>=c?Xg:l(7,o)-u>=c?pb:l(5,o)-u>=c?mb:cg;if(f==cg){let h=En(l(1,o)-u);if(h<c)return Ad(e.slice().reverse(),a.distr,f,Oi(c/h)).reverse()}return Ad(e,a.distr,f,1)}function _b(n,e,t,i,s){let r=n.axes[t],o=r.scale,a=r._space,l=n.valToPos,c=En(l(1,o)-l(2,o));return c<a?Ad(e.slice().reverse(),3,Xg,Oi(a/c)).reverse():e}function xb(n,e,t,i){return i==null?Pd:e==null?"":Nd(e)}var ug={show:!0,scale:"y",stroke:Rd,space:30,gap:5,alignTo:1,size:50,labelGap:0,labelSize:30,labelFont:Gg,side:3,grid:Bd,ticks:Vg,border:Hg,font:kd,lineGap:Wg,rotate:0};function yb(n,e){let t=3+(n||1)*2;return Ht(t*e,3)}function vb(n,e){let{scale:t,idxs:i}=n.series[0],s=n._data[0],r=n.valToPos(s[i[0]],t,!0),o=n.valToPos(s[i[1]],t,!0),a=En(o-r),l=n.series[e],c=a/(l.points.space*Tt);return i[1]-i[0]<=c}var hg={scale:null,auto:!0,sorted:0,min:Vt,max:-Vt},qg=(n,e,t,i,s)=>s,dg={show:!0,auto:!0,sorted:0,gaps:qg,alpha:1,facets:[_n({},hg,{scale:"x"}),_n({},hg,{scale:"y"})]},fg={scale:"y",auto:!0,sorted:0,show:!0,spanGaps:!1,gaps:qg,alpha:1,points:{show:vb,filter:null},values:null,min:Vt,max:-Vt,idxs:[],path:null,clip:null};function bb(n,e,t,i,s){return t/10}var Yg={time:!0,auto:!0,distr:1,log:10,asinh:1,min:null,max:null,dir:1,ori:0},Sb=_n({},Yg,{time:!1,ori:1}),pg={};function $g(n,e){let t=pg[n];return t||(t={key:n,plots:[],sub(i){t.plots.push(i)},unsub(i){t.plots=t.plots.filter(s=>s!=i)},pub(i,s,r,o,a,l,c){for(let u=0;u<t.plots.length;u++)t.plots[u]!=s&&t.plots[u].pub(i,s,r,o,a,l,c)}},n!=null&&(pg[n]=t)),t}var go=1,Td=2;function Br(n,e,t){let i=n.mode,s=n.series[e],r=i==2?n._data[e]:n._data,o=n.scales,a=n.bbox,l=r[0],c=i==2?r[1]:r[e],u=i==2?o[s.facets[0].scale]:o[n.series[0].scale],f=i==2?o[s.facets[1].scale]:o[s.scale],h=a.left,d=a.top,p=a.width,b=a.height,m=n.valToPosH,g=n.valToPosV;return u.ori==0?t(s,l,c,u,f,m,g,h,d,p,b,uc,xo,dc,Zg,jg):t(s,l,c,u,f,g,m,d,h,b,p,hc,yo,Hd,Kg,Qg)}function zd(n,e){let t=0,i=0,s=wt(n.bands,Ud);for(let r=0;r<s.length;r++){let o=s[r];o.series[0]==e?t=o.dir:o.series[1]==e&&(o.dir==1?i|=1:i|=2)}return[t,i==1?-1:i==2?1:i==3?2:0]}function Mb(n,e,t,i,s){let r=n.mode,o=n.series[e],a=r==2?o.facets[1].scale:o.scale,l=n.scales[a];return s==-1?l.min:s==1?l.max:l.distr==3?l.dir==1?l.min:l.max:0}function Rs(n,e,t,i,s,r){return Br(n,e,(o,a,l,c,u,f,h,d,p,b,m)=>{let g=o.pxRound,v=c.dir*(c.ori==0?1:-1),C=c.ori==0?xo:yo,M,I;v==1?(M=t,I=i):(M=i,I=t);let E=g(f(a[M],c,b,d)),x=g(h(l[M],u,m,p)),T=g(f(a[I],c,b,d)),V=g(h(r==1?u.max:u.min,u,m,p)),U=new Path2D(s);return C(U,T,V),C(U,E,V),C(U,E,x),U})}function cc(n,e,t,i,s,r){let o=null;if(n.length>0){o=new Path2D;let a=e==0?dc:Hd,l=t;for(let f=0;f<n.length;f++){let h=n[f];if(h[1]>h[0]){let d=h[0]-l;d>0&&a(o,l,i,d,i+r),l=h[1]}}let c=t+s-l,u=10;c>0&&a(o,l,i-u/2,c,i+r+u)}return o}function wb(n,e,t){let i=n[n.length-1];i&&i[0]==e?i[1]=t:n.push([e,t])}function Vd(n,e,t,i,s,r,o){let a=[],l=n.length;for(let c=s==1?t:i;c>=t&&c<=i;c+=s)if(e[c]===null){let f=c,h=c;if(s==1)for(;++c<=i&&e[c]===null;)h=c;else for(;--c>=t&&e[c]===null;)h=c;let d=r(n[f]),p=h==f?d:r(n[h]),b=f-s;d=o<=0&&b>=0&&b<l?r(n[b]):d;let g=h+s;p=o>=0&&g>=0&&g<l?r(n[g]):p,p>=d&&a.push([d,p])}return a}function mg(n){return n==0?Ag:n==1?Tn:e=>Dr(e,n)}function Jg(n){let e=n==0?uc:hc,t=n==0?(s,r,o,a,l,c)=>{s.arcTo(r,o,a,l,c)}:(s,r,o,a,l,c)=>{s.arcTo(o,r,l,a,c)},i=n==0?(s,r,o,a,l)=>{s.rect(r,o,a,l)}:(s,r,o,a,l)=>{s.rect(o,r,l,a)};return(s,r,o,a,l,c=0,u=0)=>{c==0&&u==0?i(s,r,o,a,l):(c=qi(c,a/2,l/2),u=qi(u,a/2,l/2),e(s,r+c,o),t(s,r+a,o,r+a,o+l,c),t(s,r+a,o+l,r,o+l,u),t(s,r,o+l,r,o,u),t(s,r,o,r+a,o,c),s.closePath())}}var uc=(n,e,t)=>{n.moveTo(e,t)},hc=(n,e,t)=>{n.moveTo(t,e)},xo=(n,e,t)=>{n.lineTo(e,t)},yo=(n,e,t)=>{n.lineTo(t,e)},dc=Jg(0),Hd=Jg(1),Zg=(n,e,t,i,s,r)=>{n.arc(e,t,i,s,r)},Kg=(n,e,t,i,s,r)=>{n.arc(t,e,i,s,r)},jg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(e,t,i,s,r,o)},Qg=(n,e,t,i,s,r,o)=>{n.bezierCurveTo(t,e,s,i,o,r)};function e0(n){return(e,t,i,s,r)=>Br(e,t,(o,a,l,c,u,f,h,d,p,b,m)=>{let{pxRound:g,points:v}=o,C,M;c.ori==0?(C=uc,M=Zg):(C=hc,M=Kg);let I=Ht(v.width*Tt,3),E=(v.size-v.width)/2*Tt,x=Ht(E*2,3),T=new Path2D,V=new Path2D,{left:U,top:D,width:H,height:O}=e.bbox;dc(V,U-x,D-x,H+x*2,O+x*2);let L=X=>{if(l[X]!=null){let $=g(f(a[X],c,b,d)),G=g(h(l[X],u,m,p));C(T,$+E,G),M(T,$,G,E,0,tc*2)}};if(r)r.forEach(L);else for(let X=i;X<=s;X++)L(X);return{stroke:I>0?T:null,fill:T,clip:V,flags:go|Td}})}function t0(n){return(e,t,i,s,r,o)=>{i!=s&&(r!=i&&o!=i&&n(e,t,i),r!=s&&o!=s&&n(e,t,s),n(e,t,o))}}var Ab=t0(xo),Tb=t0(yo);function n0(n){let e=wt(n?.alignGaps,0);return(t,i,s,r)=>Br(t,i,(o,a,l,c,u,f,h,d,p,b,m)=>{[s,r]=rc(l,s,r);let g=o.pxRound,v=O=>g(f(O,c,b,d)),C=O=>g(h(O,u,m,p)),M,I;c.ori==0?(M=xo,I=Ab):(M=yo,I=Tb);let E=c.dir*(c.ori==0?1:-1),x={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},T=x.stroke,V=!1;if(r-s>=b*4){let O=fe=>t.posToVal(fe,c.key,!0),L=null,X=null,$,G,ue,Z=v(a[E==1?s:r]),Q=v(a[s]),ie=v(a[r]),pe=O(E==1?Q+1:ie-1);for(let fe=E==1?s:r;fe>=s&&fe<=r;fe+=E){let ee=a[fe],xe=(E==1?ee<pe:ee>pe)?Z:v(ee),se=l[fe];xe==Z?se!=null?(G=se,L==null?(M(T,xe,C(G)),$=L=X=G):G<L?L=G:G>X&&(X=G)):se===null&&(V=!0):(L!=null&&I(T,Z,C(L),C(X),C($),C(G)),se!=null?(G=se,M(T,xe,C(G)),L=X=$=G):(L=X=null,se===null&&(V=!0)),Z=xe,pe=O(Z+E))}L!=null&&L!=X&&ue!=Z&&I(T,Z,C(L),C(X),C($),C(G))}else for(let O=E==1?s:r;O>=s&&O<=r;O+=E){let L=l[O];L===null?V=!0:L!=null&&M(T,v(a[O]),C(L))}let[D,H]=zd(t,i);if(o.fill!=null||D!=0){let O=x.fill=new Path2D(T),L=o.fillTo(t,i,o.min,o.max,D),X=C(L),$=v(a[s]),G=v(a[r]);E==-1&&([G,$]=[$,G]),M(O,G,X),M(O,$,X)}if(!o.spanGaps){let O=[];V&&O.push(...Vd(a,l,s,r,E,v,e)),x.gaps=O=o.gaps(t,i,s,r,O),x.clip=cc(O,c.ori,d,p,b,m)}return H!=0&&(x.band=H==2?[Rs(t,i,s,r,T,-1),Rs(t,i,s,r,T,1)]:Rs(t,i,s,r,T,H)),x})}function Eb(n){let e=wt(n.align,1),t=wt(n.ascDesc,!1),i=wt(n.alignGaps,0),s=wt(n.extend,!1);return(r,o,a,l)=>Br(r,o,(c,u,f,h,d,p,b,m,g,v,C)=>{[a,l]=rc(f,a,l);let M=c.pxRound,{left:I,width:E}=r.bbox,x=Q=>M(p(Q,h,v,m)),T=Q=>M(b(Q,d,C,g)),V=h.ori==0?xo:yo,U={stroke:new Path2D,fill:null,clip:null,band:null,gaps:null,flags:go},D=U.stroke,H=h.dir*(h.ori==0?1:-1),O=T(f[H==1?a:l]),L=x(u[H==1?a:l]),X=L,$=L;s&&e==-1&&($=I,V(D,$,O)),V(D,L,O);for(let Q=H==1?a:l;Q>=a&&Q<=l;Q+=H){let ie=f[Q];if(ie==null)continue;let pe=x(u[Q]),fe=T(ie);e==1?V(D,pe,O):V(D,X,fe),V(D,pe,fe),O=fe,X=pe}let G=X;s&&e==1&&(G=I+E,V(D,G,O));let[ue,Z]=zd(r,o);if(c.fill!=null||ue!=0){let Q=U.fill=new Path2D(D),ie=c.fillTo(r,o,c.min,c.max,ue),pe=T(ie);V(Q,G,pe),V(Q,$,pe)}if(!c.spanGaps){let Q=[];Q.push(...Vd(u,f,a,l,H,x,i));let ie=c.width*Tt/2,pe=t||e==1?ie:-ie,fe=t||e==-1?-ie:ie;Q.forEach(ee=>{ee[0]+=pe,ee[1]+=fe}),U.gaps=Q=c.gaps(r,o,a,l,Q),U.clip=cc(Q,h.ori,m,g,v,C)}return Z!=0&&(U.band=Z==2?[Rs(r,o,a,l,D,-1),Rs(r,o,a,l,D,1)]:Rs(r,o,a,l,D,Z)),U})}function gg(n,e,t,i,s,r,o=Vt){if(n.length>1){let a=null;for(let l=0,c=1/0;l<n.length;l++)if(e[l]!==void 0){if(a!=null){let u=En(n[l]-n[a]);u<c&&(c=u,o=En(t(n[l],i,s,r)-t(n[a],i,s,r)))}a=l}}return o}function Cb(n){n=n||Ea;let e=wt(n.size,[.6,Vt,1]),t=n.align||0,i=n.gap||0,s=n.radius;s=s==null?[0,0]:typeof s=="number"?[s,0]:s;let r=yt(s),o=1-e[0],a=wt(e[1],Vt),l=wt(e[2],1),c=wt(n.disp,Ea),u=wt(n.each,d=>{}),{fill:f,stroke:h}=c;return(d,p,b,m)=>Br(d,p,(g,v,C,M,I,E,x,T,V,U,D)=>{let H=g.pxRound,O=t,L=i*Tt,X=a*Tt,$=l*Tt,G,ue;M.ori==0?[G,ue]=r(d,p):[ue,G]=r(d,p);let Z=M.dir*(M.ori==0?1:-1),Q=M.ori==0?dc:Hd,ie=M.ori==0?u:(Re,Je,at,we,zt,Ve,qe)=>{u(Re,Je,at,zt,we,qe,Ve)},pe=wt(d.bands,Ud).find(Re=>Re.series[0]==p),fe=pe!=null?pe.dir:0,ee=g.fillTo(d,p,g.min,g.max,fe),_e=H(x(ee,I,D,V)),xe,se,ce,Oe=U,Ke=H(g.width*Tt),Ge=!1,pt=null,ht=null,rt=null,Zt=null;f!=null&&(Ke==0||h!=null)&&(Ge=!0,pt=f.values(d,p,b,m),ht=new Map,new Set(pt).forEach(Re=>{Re!=null&&ht.set(Re,new Path2D)}),Ke>0&&(rt=h.values(d,p,b,m),Zt=new Map,new Set(rt).forEach(Re=>{Re!=null&&Zt.set(Re,new Path2D)})));let{x0:Gt,size:un}=c;if(Gt!=null&&un!=null){O=1,v=Gt.values(d,p,b,m),Gt.unit==2&&(v=v.map(at=>d.posToVal(T+at*U,M.key,!0)));let Re=un.values(d,p,b,m);un.unit==2?se=Re[0]*U:se=E(Re[0],M,U,T)-E(0,M,U,T),Oe=gg(v,C,E,M,U,T,Oe),ce=Oe-se+L}else Oe=gg(v,C,E,M,U,T,Oe),ce=Oe*o+L,se=Oe-ce;ce<1&&(ce=0),Ke>=se/2&&(Ke=0),ce<5&&(H=Ag);let Ot=ce>0,In=Oe-ce-(Ot?Ke:0);se=H(Md(In,$,X)),xe=(O==0?se/2:O==Z?0:se)-O*Z*((O==0?L/2:0)+(Ot?Ke/2:0));let bt={stroke:null,fill:null,clip:null,band:null,gaps:null,flags:0},bn=Ge?null:new Path2D,en=null;if(pe!=null)en=d.data[pe.series[1]];else{let{y0:Re,y1:Je}=c;Re!=null&&Je!=null&&(C=Je.values(d,p,b,m),en=Re.values(d,p,b,m))}let hn=G*se,B=ue*se;for(let Re=Z==1?b:m;Re>=b&&Re<=m;Re+=Z){let Je=C[Re];if(Je==null)continue;if(en!=null){let q=en[Re]??0;if(Je-q==0)continue;_e=x(q,I,D,V)}let at=M.distr!=2||c!=null?v[Re]:Re,we=E(at,M,U,T),zt=x(wt(Je,ee),I,D,V),Ve=H(we-xe),qe=H(oi(zt,_e)),R=H(qi(zt,_e)),S=qe-R;if(Je!=null){let q=Je<0?B:hn,de=Je<0?hn:B;Ge?(Ke>0&&rt[Re]!=null&&Q(Zt.get(rt[Re]),Ve,R+wi(Ke/2),se,oi(0,S-Ke),q,de),pt[Re]!=null&&Q(ht.get(pt[Re]),Ve,R+wi(Ke/2),se,oi(0,S-Ke),q,de)):Q(bn,Ve,R+wi(Ke/2),se,oi(0,S-Ke),q,de),ie(d,p,Re,Ve-Ke/2,R,se+Ke,S)}}return Ke>0?bt.stroke=Ge?Zt:bn:Ge||(bt._fill=g.width==0?g._fill:g._stroke??g._fill,bt.width=0),bt.fill=Ge?ht:bn,bt})}function Rb(n,e){let t=wt(e?.alignGaps,0);return(i,s,r,o)=>Br(i,s,(a,l,c,u,f,h,d,p,b,m,g)=>{[r,o]=rc(c,r,o);let v=a.pxRound,C=G=>v(h(G,u,m,p)),M=G=>v(d(G,f,g,b)),I,E,x;u.ori==0?(I=uc,x=xo,E=jg):(I=hc,x=yo,E=Qg);let T=u.dir*(u.ori==0?1:-1),V=C(l[T==1?r:o]),U=V,D=[],H=[];for(let G=T==1?r:o;G>=r&&G<=o;G+=T)if(c[G]!=null){let Z=l[G],Q=C(Z);D.push(U=Q),H.push(M(c[G]))}let O={stroke:n(D,H,I,x,E,v),fill:null,clip:null,band:null,gaps:null,flags:go},L=O.stroke,[X,$]=zd(i,s);if(a.fill!=null||X!=0){let G=O.fill=new Path2D(L),ue=a.fillTo(i,s,a.min,a.max,X),Z=M(ue);x(G,U,Z),x(G,V,Z)}if(!a.spanGaps){let G=[];G.push(...Vd(l,c,r,o,T,C,t)),O.gaps=G=a.gaps(i,s,r,o,G),O.clip=cc(G,u.ori,p,b,m,g)}return $!=0&&(O.band=$==2?[Rs(i,s,r,o,L,-1),Rs(i,s,r,o,L,1)]:Rs(i,s,r,o,L,$)),O})}function Pb(n){return Rb(Ib,n)}function Ib(n,e,t,i,s,r){let o=n.length;if(o<2)return null;let a=new Path2D;if(t(a,n[0],e[0]),o==2)i(a,n[1],e[1]);else{let l=Array(o),c=Array(o-1),u=Array(o-1),f=Array(o-1);for(let h=0;h<o-1;h++)u[h]=e[h+1]-e[h],f[h]=n[h+1]-n[h],c[h]=u[h]/f[h];l[0]=c[0];for(let h=1;h<o-1;h++)c[h]===0||c[h-1]===0||c[h-1]>0!=c[h]>0?l[h]=0:(l[h]=3*(f[h-1]+f[h])/((2*f[h]+f[h-1])/c[h-1]+(f[h]+2*f[h-1])/c[h]),isFinite(l[h])||(l[h]=0));l[o-1]=c[o-2];for(let h=0;h<o-1;h++)s(a,n[h]+f[h]/3,e[h]+l[h]*f[h]/3,n[h+1]-f[h]/3,e[h+1]-l[h+1]*f[h]/3,n[h+1],e[h+1])}return a}var Ed=new Set;function _g(){for(let n of Ed)n.syncRect(!0)}_o&&(Or(hv,ho,_g),Or(dv,ho,_g,!0),Or(nc,ho,()=>{Wn.pxRatio=Tt}));var Lb=n0(),Db=e0();function xg(n,e,t,i){return(i?[n[0],n[1]].concat(n.slice(2)):[n[0]].concat(n.slice(1))).map((r,o)=>Cd(r,o,e,t))}function Nb(n,e){return n.map((t,i)=>i==0?{}:_n({},e,t))}function Cd(n,e,t,i){return _n({},e==0?t:i,n)}function i0(n,e,t){return e==null?po:[e,t]}var Ub=i0;function Ob(n,e,t){return e==null?po:ic(e,t,Dd,!0)}function s0(n,e,t,i){return e==null?po:oc(e,t,n.scales[i].log,!1)}var Fb=s0;function r0(n,e,t,i){return e==null?po:Ld(e,t,n.scales[i].log,!1)}var Bb=r0;function kb(n,e,t,i,s){let r=oi(Zm(n),Zm(e)),o=e-n,a=Xi(s/i*o,t);do{let l=t[a],c=i*l/o;if(c>=s&&r+(l<5?ir.get(l):0)<=17)return[l,c]}while(++a<t.length);return[0,0]}function yg(n){let e,t;return n=n.replace(/(\d+)px/,(i,s)=>(e=Tn((t=+s)*Tt))+"px"),[n,e,t]}function zb(n){n.show&&[n.font,n.labelFont].forEach(e=>{let t=Ht(e[2]*Tt,1);e[0]=e[0].replace(/[0-9.]+px/,t+"px"),e[1]=t})}function Wn(n,e,t){let i={mode:wt(n.mode,1)},s=i.mode;function r(_,w,P,N){let W=w.valToPct(_);return N+P*(w.dir==-1?1-W:W)}function o(_,w,P,N){let W=w.valToPct(_);return N+P*(w.dir==-1?W:1-W)}function a(_,w,P,N){return w.ori==0?r(_,w,P,N):o(_,w,P,N)}i.valToPosH=r,i.valToPosV=o;let l=!1;i.status=0;let c=i.root=Ui(Yy);if(n.id!=null&&(c.id=n.id),Mi(c,n.class),n.title){let _=Ui(Zy,c);_.textContent=n.title}let u=Wi("canvas"),f=i.ctx=u.getContext("2d"),h=Ui(Ky,c);Or("click",h,_=>{_.target===p&&(Xt!=so||Kt!=ro)&&Gn.click(i,_)},!0);let d=i.under=Ui(jy,h);h.appendChild(u);let p=i.over=Ui(Qy,h);n=mo(n);let b=+wt(n.pxAlign,1),m=mg(b);(n.plugins||[]).forEach(_=>{_.opts&&(n=_.opts(i,n)||n)});let g=n.ms||.001,v=i.series=s==1?xg(n.series||[],lg,fg,!1):Nb(n.series||[null],dg),C=i.axes=xg(n.axes||[],ag,ug,!0),M=i.scales={},I=i.bands=n.bands||[];I.forEach(_=>{_.fill=yt(_.fill||null),_.dir=wt(_.dir,-1)});let E=s==2?v[1].facets[0].scale:v[0].scale,x={axes:ws,series:gt},T=(n.drawOrder||["axes","series"]).map(_=>x[_]);function V(_){let w=_.distr==3?P=>Cs(P>0?P:_.clamp(i,P,_.min,_.max,_.key)):_.distr==4?P=>md(P,_.asinh):_.distr==100?P=>_.fwd(P):P=>P;return P=>{let N=w(P),{_min:W,_max:K}=_,le=K-W;return(N-W)/le}}function U(_){let w=M[_];if(w==null){let P=(n.scales||Ea)[_]||Ea;if(P.from!=null){U(P.from);let N=_n({},M[P.from],P,{key:_});N.valToPct=V(N),M[_]=N}else{w=M[_]=_n({},_==E?Yg:Sb,P),w.key=_;let N=w.time,W=w.range,K=nr(W);if((_!=E||s==2&&!N)&&(K&&(W[0]==null||W[1]==null)&&(W={min:W[0]==null?Ym:{mode:1,hard:W[0],soft:W[0]},max:W[1]==null?Ym:{mode:1,hard:W[1],soft:W[1]}},K=!1),!K&&lc(W))){let le=W;W=(me,Se,De)=>Se==null?po:ic(Se,De,le)}w.range=yt(W||(N?Ub:_==E?w.distr==3?Fb:w.distr==4?Bb:i0:w.distr==3?s0:w.distr==4?r0:Ob)),w.auto=yt(K?!1:w.auto),w.clamp=yt(w.clamp||bb),w._min=w._max=null,w.valToPct=V(w)}}}U("x"),U("y"),s==1&&v.forEach(_=>{U(_.scale)}),C.forEach(_=>{U(_.scale)});for(let _ in n.scales)U(_);let D=M[E],H=D.distr,O,L;D.ori==0?(Mi(c,$y),O=r,L=o):(Mi(c,Jy),O=o,L=r);let X={};for(let _ in M){let w=M[_];(w.min!=null||w.max!=null)&&(X[_]={min:w.min,max:w.max},w.min=w.max=null)}let $=n.tzDate||(_=>new Date(Tn(_/g))),G=n.fmtDate||Od,ue=g==1?$v($):Kv($),Z=sg($,ig(g==1?Yv:Zv,G)),Q=og($,rg(Qv,G)),ie=[],pe=i.legend=_n({},nb,n.legend),fe=i.cursor=_n({},lb,{drag:{y:s==2}},n.cursor),ee=pe.show,_e=fe.show,xe=pe.markers;pe.idxs=ie,xe.width=yt(xe.width),xe.dash=yt(xe.dash),xe.stroke=yt(xe.stroke),xe.fill=yt(xe.fill);let se,ce,Oe,Ke=[],Ge=[],pt,ht=!1,rt={};if(pe.live){let _=v[1]?v[1].values:null;ht=_!=null,pt=ht?_(i,1,0):{_:0};for(let w in pt)rt[w]=Pd}if(ee)if(se=Wi("table",rv,c),Oe=Wi("tbody",null,se),pe.mount(i,se),ht){ce=Wi("thead",null,se,Oe);let _=Wi("tr",null,ce);Wi("th",null,_);for(var Zt in pt)Wi("th",Nm,_).textContent=Zt}else Mi(se,av),pe.live&&Mi(se,ov);let Gt={show:!0},un={show:!1};function Ot(_,w){if(w==0&&(ht||!pe.live||s==2))return po;let P=[],N=Wi("tr",lv,Oe,Oe.childNodes[w]);Mi(N,_.class),_.show||Mi(N,Ur);let W=Wi("th",null,N);if(xe.show){let me=Ui(cv,W);if(w>0){let Se=xe.width(i,w);Se&&(me.style.border=Se+"px "+xe.dash(i,w)+" "+xe.stroke(i,w)),me.style.background=xe.fill(i,w)}}let K=Ui(Nm,W);_.label instanceof HTMLElement?K.appendChild(_.label):K.textContent=_.label,w>0&&(xe.show||(K.style.color=_.width>0?xe.stroke(i,w):xe.fill(i,w)),bt("click",W,me=>{if(fe._lock)return;et(me);let Se=v.indexOf(_);if((me.ctrlKey||me.metaKey)!=pe.isolate){let De=v.some((Ne,Fe)=>Fe>0&&Fe!=Se&&Ne.show);v.forEach((Ne,Fe)=>{Fe>0&&rs(Fe,De?Fe==Se?Gt:un:Gt,!0,mn.setSeries)})}else rs(Se,{show:!_.show},!0,mn.setSeries)},!1),tt&&bt(Bm,W,me=>{fe._lock||(et(me),rs(v.indexOf(_),ao,!0,mn.setSeries))},!1));for(var le in pt){let me=Wi("td",uv,N);me.textContent="--",P.push(me)}return[N,P]}let In=new Map;function bt(_,w,P,N=!0){let W=In.get(w)||{},K=fe.bind[_](i,w,P,N);K&&(Or(_,w,W[_]=K),In.set(w,W))}function bn(_,w,P){let N=In.get(w)||{};for(let W in N)(_==null||W==_)&&(Sd(W,w,N[W]),delete N[W]);_==null&&In.delete(w)}let en=0,hn=0,B=0,Re=0,Je=0,at=0,we=Je,zt=at,Ve=B,qe=Re,R=0,S=0,q=0,de=0;i.bbox={};let ae=!1,ve=!1,be=!1,te=!1,re=!1,ge=!1;function F(_,w,P){(P||_!=i.width||w!=i.height)&&oe(_,w),dt(!1),be=!0,ve=!0,$n()}function oe(_,w){i.width=en=B=_,i.height=hn=Re=w,Je=at=0,Me(),We();let P=i.bbox;R=P.left=Dr(Je*Tt,.5),S=P.top=Dr(at*Tt,.5),q=P.width=Dr(B*Tt,.5),de=P.height=Dr(Re*Tt,.5)}let ne=3;function Ae(){let _=!1,w=0;for(;!_;){w++;let P=to(w),N=ss(w);_=w==ne||P&&N,_||(oe(i.width,i.height),ve=!0)}}function ye({width:_,height:w}){F(_,w)}i.setSize=ye;function Me(){let _=!1,w=!1,P=!1,N=!1;C.forEach((W,K)=>{if(W.show&&W._show){let{side:le,_size:me}=W,Se=le%2,De=W.label!=null?W.labelSize:0,Ne=me+De;Ne>0&&(Se?(B-=Ne,le==3?(Je+=Ne,N=!0):P=!0):(Re-=Ne,le==0?(at+=Ne,_=!0):w=!0))}}),ns[0]=_,ns[1]=P,ns[2]=w,ns[3]=N,B-=zi[1]+zi[3],Je+=zi[3],Re-=zi[2]+zi[0],at+=zi[0]}function We(){let _=Je+B,w=at+Re,P=Je,N=at;function W(K,le){switch(K){case 1:return _+=le,_-le;case 2:return w+=le,w-le;case 3:return P-=le,P+le;case 0:return N-=le,N+le}}C.forEach((K,le)=>{if(K.show&&K._show){let me=K.side;K._pos=W(me,K._size),K.label!=null&&(K._lpos=W(me,K.labelSize))}})}if(fe.dataIdx==null){let _=fe.hover,w=_.skip=new Set(_.skip??[]);w.add(void 0);let P=_.prox=yt(_.prox),N=_.bias??=0;fe.dataIdx=(W,K,le,me)=>{if(K==0)return le;let Se=le,De=P(W,K,le,me)??Vt,Ne=De>=0&&De<Vt,Fe=D.ori==0?B:Re,ot=fe.left,At=e[0],Mt=e[K];if(w.has(Mt[le])){Se=null;let _t=null,je=null,Xe;if(N==0||N==-1)for(Xe=le;_t==null&&Xe-- >0;)w.has(Mt[Xe])||(_t=Xe);if(N==0||N==1)for(Xe=le;je==null&&Xe++<Mt.length;)w.has(Mt[Xe])||(je=Xe);if(_t!=null||je!=null)if(Ne){let Yt=_t==null?-1/0:O(At[_t],D,Fe,0),sn=je==null?1/0:O(At[je],D,Fe,0),Un=ot-Yt,Ft=sn-ot;Un<=Ft?Un<=De&&(Se=_t):Ft<=De&&(Se=je)}else Se=je==null?_t:_t==null?je:le-_t<=je-le?_t:je}else Ne&&En(ot-O(At[le],D,Fe,0))>De&&(Se=null);return Se}}let et=_=>{fe.event=_};fe.idxs=ie,fe._lock=!1;let he=fe.points;he.show=yt(he.show),he.size=yt(he.size),he.stroke=yt(he.stroke),he.width=yt(he.width),he.fill=yt(he.fill);let Be=i.focus=_n({},n.focus||{alpha:.3},fe.focus),tt=Be.prox>=0,Ce=tt&&he.one,ct=[],Wt=[],ti=[];function la(_,w){let P=he.show(i,w);if(P instanceof HTMLElement)return Mi(P,sv),Mi(P,_.class),hs(P,-10,-10,B,Re),p.insertBefore(P,ct[w]),P}function jr(_,w){if(s==1||w>0){let P=s==1&&M[_.scale].time,N=_.value;_.value=P?Qm(N)?og($,rg(N,G)):N||Q:N||xb,_.label=_.label||(P?ub:cb)}if(Ce||w>0){_.width=_.width==null?1:_.width,_.paths=_.paths||Lb||Sv,_.fillTo=yt(_.fillTo||Mb),_.pxAlign=+wt(_.pxAlign,b),_.pxRound=mg(_.pxAlign),_.stroke=yt(_.stroke||null),_.fill=yt(_.fill||null),_._stroke=_._fill=_._paths=_._focus=null;let P=yb(oi(1,_.width),1),N=_.points=_n({},{size:P,width:oi(1,P*.2),stroke:_.stroke,space:P*2,paths:Db,_stroke:null,_fill:null},_.points);N.show=yt(N.show),N.filter=yt(N.filter),N.fill=yt(N.fill),N.stroke=yt(N.stroke),N.paths=yt(N.paths),N.pxAlign=_.pxAlign}if(ee){let P=Ot(_,w);Ke.splice(w,0,P[0]),Ge.splice(w,0,P[1]),pe.values.push(null)}if(_e){ie.splice(w,0,null);let P=null;Ce?w==0&&(P=la(_,w)):w>0&&(P=la(_,w)),ct.splice(w,0,P),Wt.splice(w,0,0),ti.splice(w,0,0)}Nn("addSeries",w)}function zh(_,w){w=w??v.length,_=s==1?Cd(_,w,lg,fg):Cd(_,w,{},dg),v.splice(w,0,_),jr(v[w],w)}i.addSeries=zh;function Ll(_){if(v.splice(_,1),ee){pe.values.splice(_,1),Ge.splice(_,1);let w=Ke.splice(_,1)[0];bn(null,w.firstChild),w.remove()}_e&&(ie.splice(_,1),ct.splice(_,1)[0].remove(),Wt.splice(_,1),ti.splice(_,1)),Nn("delSeries",_)}i.delSeries=Ll;let ns=[!1,!1,!1,!1];function bs(_,w){if(_._show=_.show,_.show){let P=_.side%2,N=M[_.scale];N==null&&(_.scale=P?v[1].scale:E,N=M[_.scale]);let W=N.time;_.size=yt(_.size),_.space=yt(_.space),_.rotate=yt(_.rotate),nr(_.incrs)&&_.incrs.forEach(le=>{!ir.has(le)&&ir.set(le,Cg(le))}),_.incrs=yt(_.incrs||(N.distr==2?Wv:W?g==1?qv:Jv:Nr)),_.splits=yt(_.splits||(W&&N.distr==1?ue:N.distr==3?wd:N.distr==4?fb:db)),_.stroke=yt(_.stroke),_.grid.stroke=yt(_.grid.stroke),_.ticks.stroke=yt(_.ticks.stroke),_.border.stroke=yt(_.border.stroke);let K=_.values;_.values=nr(K)&&!nr(K[0])?yt(K):W?nr(K)?sg($,ig(K,G)):Qm(K)?jv($,K):K||Z:K||hb,_.filter=yt(_.filter||(N.distr>=3&&N.log==10?gb:N.distr==3&&N.log==2?_b:Tg)),_.font=yg(_.font),_.labelFont=yg(_.labelFont),_._size=_.size(i,null,w,0),_._space=_._rotate=_._incrs=_._found=_._splits=_._values=null,_._size>0&&(ns[w]=!0,_._el=Ui(ev,h))}}function Ss(_,w,P,N){let[W,K,le,me]=P,Se=w%2,De=0;return Se==0&&(me||K)&&(De=w==0&&!W||w==2&&!le?Tn(ag.size/3):0),Se==1&&(W||le)&&(De=w==1&&!K||w==3&&!me?Tn(ug.size/2):0),De}let ca=i.padding=(n.padding||[Ss,Ss,Ss,Ss]).map(_=>yt(wt(_,Ss))),zi=i._padding=ca.map((_,w)=>_(i,w,ns,0)),tn,an=null,ln=null,is=s==1?v[0].idxs:null,yi=null,Ws=!1;function ua(_,w){if(e=_??[],i.data=i._data=e,s==2){tn=0;for(let P=1;P<v.length;P++)tn+=e[P][0].length}else{e.length==0&&(i.data=i._data=e=[[]]),yi=e[0],tn=yi.length;let P=e;if(H==2){P=e.slice();let N=P[0]=Array(tn);for(let W=0;W<tn;W++)N[W]=W}i._data=e=P}if(dt(!0),Nn("setData"),H==2&&(be=!0),w!==!1){let P=D;P.auto(i,Ws)?ha():Ys(E,P.min,P.max),te=te||fe.left>=0,ge=!0,$n()}}i.setData=ua;function ha(){Ws=!0;let _,w;s==1&&(tn>0?(an=is[0]=0,ln=is[1]=tn-1,_=e[0][an],w=e[0][ln],H==2?(_=an,w=ln):_==w&&(H==3?[_,w]=oc(_,_,D.log,!1):H==4?[_,w]=Ld(_,_,D.log,!1):D.time?w=_+Tn(86400/g):[_,w]=ic(_,w,Dd,!0))):(an=is[0]=_=null,ln=is[1]=w=null)),Ys(E,_,w)}let Qr,Xs,eo,A,k,j,Y,J,Te,Ie;function Ee(_,w,P,N,W,K){_??=Om,P??=Ud,N??="butt",W??=Om,K??="round",_!=Qr&&(f.strokeStyle=Qr=_),W!=Xs&&(f.fillStyle=Xs=W),w!=eo&&(f.lineWidth=eo=w),K!=k&&(f.lineJoin=k=K),N!=j&&(f.lineCap=j=N),P!=A&&f.setLineDash(A=P)}function Le(_,w,P,N){w!=Xs&&(f.fillStyle=Xs=w),_!=Y&&(f.font=Y=_),P!=J&&(f.textAlign=J=P),N!=Te&&(f.textBaseline=Te=N)}function ze(_,w,P,N,W=0){if(N.length>0&&_.auto(i,Ws)&&(w==null||w.min==null)){let K=wt(an,0),le=wt(ln,N.length-1),me=P.min==null?gv(N,K,le,W,_.distr==3):[P.min,P.max];_.min=qi(_.min,P.min=me[0]),_.max=oi(_.max,P.max=me[1])}}let nt={min:null,max:null};function mt(){for(let N in M){let W=M[N];X[N]==null&&(W.min==null||X[E]!=null&&W.auto(i,Ws))&&(X[N]=nt)}for(let N in M){let W=M[N];X[N]==null&&W.from!=null&&X[W.from]!=null&&(X[N]=nt)}X[E]!=null&&dt(!0);let _={};for(let N in X){let W=X[N];if(W!=null){let K=_[N]=mo(M[N],Av);if(W.min!=null)_n(K,W);else if(N!=E||s==2)if(tn==0&&K.from==null){let le=K.range(i,null,null,N);K.min=le[0],K.max=le[1]}else K.min=Vt,K.max=-Vt}}if(tn>0){v.forEach((N,W)=>{if(s==1){let K=N.scale,le=X[K];if(le==null)return;let me=_[K];if(W==0){let Se=me.range(i,me.min,me.max,K);me.min=Se[0],me.max=Se[1],an=Xi(me.min,e[0]),ln=Xi(me.max,e[0]),ln-an>1&&(e[0][an]<me.min&&an++,e[0][ln]>me.max&&ln--),N.min=yi[an],N.max=yi[ln]}else N.show&&N.auto&&ze(me,le,N,e[W],N.sorted);N.idxs[0]=an,N.idxs[1]=ln}else if(W>0&&N.show&&N.auto){let[K,le]=N.facets,me=K.scale,Se=le.scale,[De,Ne]=e[W],Fe=_[me],ot=_[Se];Fe!=null&&ze(Fe,X[me],K,De,K.sorted),ot!=null&&ze(ot,X[Se],le,Ne,le.sorted),N.min=le.min,N.max=le.max}});for(let N in _){let W=_[N],K=X[N];if(W.from==null&&(K==null||K.min==null)){let le=W.range(i,W.min==Vt?null:W.min,W.max==-Vt?null:W.max,N);W.min=le[0],W.max=le[1]}}}for(let N in _){let W=_[N];if(W.from!=null){let K=_[W.from];if(K.min==null)W.min=W.max=null;else{let le=W.range(i,K.min,K.max,N);W.min=le[0],W.max=le[1]}}}let w={},P=!1;for(let N in _){let W=_[N],K=M[N];if(K.min!=W.min||K.max!=W.max){K.min=W.min,K.max=W.max;let le=K.distr;K._min=le==3?Cs(K.min):le==4?md(K.min,K.asinh):le==100?K.fwd(K.min):K.min,K._max=le==3?Cs(K.max):le==4?md(K.max,K.asinh):le==100?K.fwd(K.max):K.max,w[N]=P=!0}}if(P){v.forEach((N,W)=>{s==2?W>0&&w.y&&(N._paths=null):w[N.scale]&&(N._paths=null)});for(let N in w)be=!0,Nn("setScale",N);_e&&fe.left>=0&&(te=ge=!0)}for(let N in X)X[N]=null}function ke(_){let w=Md(an-1,0,tn-1),P=Md(ln+1,0,tn-1);for(;_[w]==null&&w>0;)w--;for(;_[P]==null&&P<tn-1;)P++;return[w,P]}function gt(){if(tn>0){let _=v.some(w=>w._focus)&&Ie!=Be.alpha;_&&(f.globalAlpha=Ie=Be.alpha),v.forEach((w,P)=>{if(P>0&&w.show&&(Qt(P,!1),Qt(P,!0),w._paths==null)){let N=Ie;Ie!=w.alpha&&(f.globalAlpha=Ie=w.alpha);let W=s==2?[0,e[P][0].length-1]:ke(e[P]);w._paths=w.paths(i,P,W[0],W[1]),Ie!=N&&(f.globalAlpha=Ie=N)}}),v.forEach((w,P)=>{if(P>0&&w.show){let N=Ie;Ie!=w.alpha&&(f.globalAlpha=Ie=w.alpha),w._paths!=null&&It(P,!1);{let W=w._paths!=null?w._paths.gaps:null,K=w.points.show(i,P,an,ln,W),le=w.points.filter(i,P,K,W);(K||le)&&(w.points._paths=w.points.paths(i,P,an,ln,le),It(P,!0))}Ie!=N&&(f.globalAlpha=Ie=N),Nn("drawSeries",P)}}),_&&(f.globalAlpha=Ie=1)}}function Qt(_,w){let P=w?v[_].points:v[_];P._stroke=P.stroke(i,_),P._fill=P.fill(i,_)}function It(_,w){let P=w?v[_].points:v[_],{stroke:N,fill:W,clip:K,flags:le,_stroke:me=P._stroke,_fill:Se=P._fill,_width:De=P.width}=P._paths;De=Ht(De*Tt,3);let Ne=null,Fe=De%2/2;w&&Se==null&&(Se=De>0?"#fff":me);let ot=P.pxAlign==1&&Fe>0;if(ot&&f.translate(Fe,Fe),!w){let At=R-De/2,Mt=S-De/2,_t=q+De,je=de+De;Ne=new Path2D,Ne.rect(At,Mt,_t,je)}w?Ue(me,De,P.dash,P.cap,Se,N,W,le,K):Lt(_,me,De,P.dash,P.cap,Se,N,W,le,Ne,K),ot&&f.translate(-Fe,-Fe)}function Lt(_,w,P,N,W,K,le,me,Se,De,Ne){let Fe=!1;Se!=0&&I.forEach((ot,At)=>{if(ot.series[0]==_){let Mt=v[ot.series[1]],_t=e[ot.series[1]],je=(Mt._paths||Ea).band;nr(je)&&(je=ot.dir==1?je[0]:je[1]);let Xe,Yt=null;Mt.show&&je&&xv(_t,an,ln)?(Yt=ot.fill(i,At)||K,Xe=Mt._paths.clip):je=null,Ue(w,P,N,W,Yt,le,me,Se,De,Ne,Xe,je),Fe=!0}}),Fe||Ue(w,P,N,W,K,le,me,Se,De,Ne)}let Sn=go|Td;function Ue(_,w,P,N,W,K,le,me,Se,De,Ne,Fe){Ee(_,w,P,N,W),(Se||De||Fe)&&(f.save(),Se&&f.clip(Se),De&&f.clip(De)),Fe?(me&Sn)==Sn?(f.clip(Fe),Ne&&f.clip(Ne),xt(W,le),dn(_,K,w)):me&Td?(xt(W,le),f.clip(Fe),dn(_,K,w)):me&go&&(f.save(),f.clip(Fe),Ne&&f.clip(Ne),xt(W,le),f.restore(),dn(_,K,w)):(xt(W,le),dn(_,K,w)),(Se||De||Fe)&&f.restore()}function dn(_,w,P){P>0&&(w instanceof Map?w.forEach((N,W)=>{f.strokeStyle=Qr=W,f.stroke(N)}):w!=null&&_&&f.stroke(w))}function xt(_,w){w instanceof Map?w.forEach((P,N)=>{f.fillStyle=Xs=N,f.fill(P)}):w!=null&&_&&f.fill(w)}function Ms(_,w,P,N){let W=C[_],K;if(N<=0)K=[0,0];else{let le=W._space=W.space(i,_,w,P,N),me=W._incrs=W.incrs(i,_,w,P,N,le);K=kb(w,P,me,N,le)}return W._found=K}function fn(_,w,P,N,W,K,le,me,Se,De){let Ne=le%2/2;b==1&&f.translate(Ne,Ne),Ee(me,le,Se,De,me),f.beginPath();let Fe,ot,At,Mt,_t=W+(N==0||N==3?-K:K);P==0?(ot=W,Mt=_t):(Fe=W,At=_t);for(let je=0;je<_.length;je++)w[je]!=null&&(P==0?Fe=At=_[je]:ot=Mt=_[je],f.moveTo(Fe,ot),f.lineTo(At,Mt));f.stroke(),b==1&&f.translate(-Ne,-Ne)}function to(_){let w=!0;return C.forEach((P,N)=>{if(!P.show)return;let W=M[P.scale];if(W.min==null){P._show&&(w=!1,P._show=!1,dt(!1));return}else P._show||(w=!1,P._show=!0,dt(!1));let K=P.side,le=K%2,{min:me,max:Se}=W,[De,Ne]=Ms(N,me,Se,le==0?B:Re);if(Ne==0)return;let Fe=W.distr==2,ot=P._splits=P.splits(i,N,me,Se,De,Ne,Fe),At=W.distr==2?ot.map(Xe=>yi[Xe]):ot,Mt=W.distr==2?yi[ot[1]]-yi[ot[0]]:De,_t=P._values=P.values(i,P.filter(i,At,N,Ne,Mt),N,Ne,Mt);P._rotate=K==2?P.rotate(i,_t,N,Ne):0;let je=P._size;P._size=Oi(P.size(i,_t,N,_)),je!=null&&P._size!=je&&(w=!1)}),w}function ss(_){let w=!0;return ca.forEach((P,N)=>{let W=P(i,N,ns,_);W!=zi[N]&&(w=!1),zi[N]=W}),w}function ws(){for(let _=0;_<C.length;_++){let w=C[_];if(!w.show||!w._show)continue;let P=w.side,N=P%2,W,K,le=w.stroke(i,_),me=P==0||P==3?-1:1,[Se,De]=w._found;if(w.label!=null){let si=w.labelGap*me,Si=Tn((w._lpos+si)*Tt);Le(w.labelFont[0],le,"center",P==2?"top":Um),f.save(),N==1?(W=K=0,f.translate(Si,Tn(S+de/2)),f.rotate((P==3?-tc:tc)/2)):(W=Tn(R+q/2),K=Si);let Cr=wg(w.label)?w.label(i,_,Se,De):w.label;f.fillText(Cr,W,K),f.restore()}if(De==0)continue;let Ne=M[w.scale],Fe=N==0?q:de,ot=N==0?R:S,At=w._splits,Mt=Ne.distr==2?At.map(si=>yi[si]):At,_t=Ne.distr==2?yi[At[1]]-yi[At[0]]:Se,je=w.ticks,Xe=w.border,Yt=je.show?je.size:0,sn=Tn(Yt*Tt),Un=Tn((w.alignTo==2?w._size-Yt-w.gap:w.gap)*Tt),Ft=w._rotate*-tc/180,rn=m(w._pos*Tt),vi=(sn+Un)*me,ii=rn+vi;K=N==0?ii:0,W=N==1?ii:0;let Li=w.font[0],Vi=w.align==1?co:w.align==2?dd:Ft>0?co:Ft<0?dd:N==0?"center":P==3?dd:co,as=Ft||N==1?"middle":P==2?"top":Um;Le(Li,le,Vi,as);let bi=w.font[1]*w.lineGap,Di=At.map(si=>m(a(si,Ne,Fe,ot))),Hi=w._values;for(let si=0;si<Hi.length;si++){let Si=Hi[si];if(Si!=null){N==0?W=Di[si]:K=Di[si],Si=""+Si;let Cr=Si.indexOf(`
`)==-1?[Si]:Si.split(/\n/gm);for(let ri=0;ri<Cr.length;ri++){let Zp=Cr[ri];Ft?(f.save(),f.translate(W,K+ri*bi),f.rotate(Ft),f.fillText(Zp,0,0),f.restore()):f.fillText(Zp,W,K+ri*bi)}}}je.show&&fn(Di,je.filter(i,Mt,_,De,_t),N,P,rn,sn,Ht(je.width*Tt,3),je.stroke(i,_),je.dash,je.cap);let ls=w.grid;ls.show&&fn(Di,ls.filter(i,Mt,_,De,_t),N,N==0?2:1,N==0?S:R,N==0?de:q,Ht(ls.width*Tt,3),ls.stroke(i,_),ls.dash,ls.cap),Xe.show&&fn([rn],[1],N==0?1:0,N==0?1:2,N==1?S:R,N==1?de:q,Ht(Xe.width*Tt,3),Xe.stroke(i,_),Xe.dash,Xe.cap)}Nn("drawAxes")}function dt(_){v.forEach((w,P)=>{P>0&&(w._paths=null,_&&(s==1?(w.min=null,w.max=null):w.facets.forEach(N=>{N.min=null,N.max=null})))})}let nn=!1,ni=!1,Dt=[];function pn(){ni=!1;for(let _=0;_<Dt.length;_++)Nn(...Dt[_]);Dt.length=0}function $n(){nn||(Lv(Lp),nn=!0)}function Dl(_,w=!1){nn=!0,ni=w,_(i),Lp(),w&&Dt.length>0&&queueMicrotask(pn)}i.batch=Dl;function Lp(){if(ae&&(mt(),ae=!1),be&&(Ae(),be=!1),ve){if($t(d,co,Je),$t(d,"top",at),$t(d,Ma,B),$t(d,wa,Re),$t(p,co,Je),$t(p,"top",at),$t(p,Ma,B),$t(p,wa,Re),$t(h,Ma,en),$t(h,wa,hn),u.width=Tn(en*Tt),u.height=Tn(hn*Tt),C.forEach(({_el:_,_show:w,_size:P,_pos:N,side:W})=>{if(_!=null)if(w){let K=W===3||W===0?P:0,le=W%2==1;$t(_,le?"left":"top",N-K),$t(_,le?"width":"height",P),$t(_,le?"top":"left",le?at:Je),$t(_,le?"height":"width",le?Re:B),bd(_,Ur)}else Mi(_,Ur)}),Qr=Xs=eo=k=j=Y=J=Te=A=null,Ie=1,pa(!0),Je!=we||at!=zt||B!=Ve||Re!=qe){dt(!1);let _=B/Ve,w=Re/qe;if(_e&&!te&&fe.left>=0){fe.left*=_,fe.top*=w,no&&hs(no,Tn(fe.left),0,B,Re),io&&hs(io,0,Tn(fe.top),B,Re);for(let P=0;P<ct.length;P++){let N=ct[P];N!=null&&(Wt[P]*=_,ti[P]*=w,hs(N,Oi(Wt[P]),Oi(ti[P]),B,Re))}}if(qt.show&&!re&&qt.left>=0&&qt.width>0){qt.left*=_,qt.width*=_,qt.top*=w,qt.height*=w;for(let P in qh)$t(oo,P,qt[P])}we=Je,zt=at,Ve=B,qe=Re}Nn("setSize"),ve=!1}en>0&&hn>0&&(f.clearRect(0,0,u.width,u.height),Nn("drawClear"),T.forEach(_=>_()),Nn("draw")),qt.show&&re&&(Nl(qt),re=!1),_e&&te&&(Er(null,!0,!1),te=!1),pe.show&&pe.live&&ge&&(Wh(),ge=!1),l||(l=!0,i.status=1,Nn("ready")),Ws=!1,nn=!1}i.redraw=(_,w)=>{be=w||!1,_!==!1?Ys(E,D.min,D.max):$n()};function Vh(_,w){let P=M[_];if(P.from==null){if(tn==0){let N=P.range(i,w.min,w.max,_);w.min=N[0],w.max=N[1]}if(w.min>w.max){let N=w.min;w.min=w.max,w.max=N}if(tn>1&&w.min!=null&&w.max!=null&&w.max-w.min<1e-16)return;_==E&&P.distr==2&&tn>0&&(w.min=Xi(w.min,e[0]),w.max=Xi(w.max,e[0]),w.min==w.max&&w.max++),X[_]=w,ae=!0,$n()}}i.setScale=Vh;let Hh,Gh,no,io,Dp,Np,so,ro,Up,Op,Xt,Kt,qs=!1,Gn=fe.drag,Ln=Gn.x,Dn=Gn.y;_e&&(fe.x&&(Hh=Ui(nv,p)),fe.y&&(Gh=Ui(iv,p)),D.ori==0?(no=Hh,io=Gh):(no=Gh,io=Hh),Xt=fe.left,Kt=fe.top);let qt=i.select=_n({show:!0,over:!0,left:0,width:0,top:0,height:0},n.select),oo=qt.show?Ui(tv,qt.over?p:d):null;function Nl(_,w){if(qt.show){for(let P in _)qt[P]=_[P],P in qh&&$t(oo,P,_[P]);w!==!1&&Nn("setSelect")}}i.setSelect=Nl;function yy(_){if(v[_].show)ee&&bd(Ke[_],Ur);else if(ee&&Mi(Ke[_],Ur),_e){let P=Ce?ct[0]:ct[_];P!=null&&hs(P,-10,-10,B,Re)}}function Ys(_,w,P){Vh(_,{min:w,max:P})}function rs(_,w,P,N){w.focus!=null&&wy(_),w.show!=null&&v.forEach((W,K)=>{K>0&&(_==K||_==null)&&(W.show=w.show,yy(K),s==2?(Ys(W.facets[0].scale,null,null),Ys(W.facets[1].scale,null,null)):Ys(W.scale,null,null),$n())}),P!==!1&&Nn("setSeries",_,w),N&&ma("setSeries",i,_,w)}i.setSeries=rs;function vy(_,w){_n(I[_],w)}function by(_,w){_.fill=yt(_.fill||null),_.dir=wt(_.dir,-1),w=w??I.length,I.splice(w,0,_)}function Sy(_){_==null?I.length=0:I.splice(_,1)}i.addBand=by,i.setBand=vy,i.delBand=Sy;function My(_,w){v[_].alpha=w,_e&&ct[_]!=null&&(ct[_].style.opacity=w),ee&&Ke[_]&&(Ke[_].style.opacity=w)}let As,$s,Tr,ao={focus:!0};function wy(_){if(_!=Tr){let w=_==null,P=Be.alpha!=1;v.forEach((N,W)=>{if(s==1||W>0){let K=w||W==0||W==_;N._focus=w?null:K,P&&My(W,K?1:Be.alpha)}}),Tr=_,P&&$n()}}ee&&tt&&bt(km,se,_=>{fe._lock||(et(_),Tr!=null&&rs(null,ao,!0,mn.setSeries))});function os(_,w,P){let N=M[w];P&&(_=_/Tt-(N.ori==1?at:Je));let W=B;N.ori==1&&(W=Re,_=W-_),N.dir==-1&&(_=W-_);let K=N._min,le=N._max,me=_/W,Se=K+(le-K)*me,De=N.distr;return De==3?fo(10,Se):De==4?vv(Se,N.asinh):De==100?N.bwd(Se):Se}function Ay(_,w){let P=os(_,E,w);return Xi(P,e[0],an,ln)}i.valToIdx=_=>Xi(_,e[0]),i.posToIdx=Ay,i.posToVal=os,i.valToPos=(_,w,P)=>M[w].ori==0?r(_,M[w],P?q:B,P?R:0):o(_,M[w],P?de:Re,P?S:0),i.setCursor=(_,w,P)=>{Xt=_.left,Kt=_.top,Er(null,w,P)};function Fp(_,w){$t(oo,co,qt.left=_),$t(oo,Ma,qt.width=w)}function Bp(_,w){$t(oo,"top",qt.top=_),$t(oo,wa,qt.height=w)}let da=D.ori==0?Fp:Bp,fa=D.ori==1?Fp:Bp;function Ty(){if(ee&&pe.live)for(let _=s==2?1:0;_<v.length;_++){if(_==0&&ht)continue;let w=pe.values[_],P=0;for(let N in w)Ge[_][P++].firstChild.nodeValue=w[N]}}function Wh(_,w){if(_!=null&&(_.idxs?_.idxs.forEach((P,N)=>{ie[N]=P}):wv(_.idx)||ie.fill(_.idx),pe.idx=ie[0]),ee&&pe.live){for(let P=0;P<v.length;P++)(P>0||s==1&&!ht)&&Ey(P,ie[P]);Ty()}ge=!1,w!==!1&&Nn("setLegend")}i.setLegend=Wh;function Ey(_,w){let P=v[_],N=_==0&&H==2?yi:e[_],W;ht?W=P.values(i,_,w)??rt:(W=P.value(i,w==null?null:N[w],_,w),W=W==null?rt:{_:W}),pe.values[_]=W}function Er(_,w,P){Up=Xt,Op=Kt,[Xt,Kt]=fe.move(i,Xt,Kt),fe.left=Xt,fe.top=Kt,_e&&(no&&hs(no,Tn(Xt),0,B,Re),io&&hs(io,0,Tn(Kt),B,Re));let N,W=an>ln;As=Vt,$s=null;let K=D.ori==0?B:Re,le=D.ori==1?B:Re;if(Xt<0||tn==0||W){N=fe.idx=null;for(let me=0;me<v.length;me++){let Se=ct[me];Se!=null&&hs(Se,-10,-10,B,Re)}tt&&rs(null,ao,!0,_==null&&mn.setSeries),pe.live&&(ie.fill(N),ge=!0)}else{let me,Se,De;s==1&&(me=D.ori==0?Xt:Kt,Se=os(me,E),N=fe.idx=Xi(Se,e[0],an,ln),De=O(e[0][N],D,K,0));let Ne=-10,Fe=-10,ot=0,At=0,Mt=!0,_t="",je="";for(let Xe=s==2?1:0;Xe<v.length;Xe++){let Yt=v[Xe],sn=ie[Xe],Un=sn==null?null:s==1?e[Xe][sn]:e[Xe][1][sn],Ft=fe.dataIdx(i,Xe,N,Se),rn=Ft==null?null:s==1?e[Xe][Ft]:e[Xe][1][Ft];if(ge=ge||rn!=Un||Ft!=sn,ie[Xe]=Ft,Xe>0&&Yt.show){let vi=Ft==null?-10:Ft==N?De:O(s==1?e[0][Ft]:e[Xe][0][Ft],D,K,0),ii=rn==null?-10:L(rn,s==1?M[Yt.scale]:M[Yt.facets[1].scale],le,0);if(tt&&rn!=null){let Li=D.ori==1?Xt:Kt,Vi=En(Be.dist(i,Xe,Ft,ii,Li));if(Vi<As){let as=Be.bias;if(as!=0){let bi=os(Li,Yt.scale),Di=rn>=0?1:-1,Hi=bi>=0?1:-1;Hi==Di&&(Hi==1?as==1?rn>=bi:rn<=bi:as==1?rn<=bi:rn>=bi)&&(As=Vi,$s=Xe)}else As=Vi,$s=Xe}}if(ge||Ce){let Li,Vi;D.ori==0?(Li=vi,Vi=ii):(Li=ii,Vi=vi);let as,bi,Di,Hi,ls,si,Si=!0,Cr=he.bbox;if(Cr!=null){Si=!1;let ri=Cr(i,Xe);Di=ri.left,Hi=ri.top,as=ri.width,bi=ri.height}else Di=Li,Hi=Vi,as=bi=he.size(i,Xe);if(si=he.fill(i,Xe),ls=he.stroke(i,Xe),Ce)Xe==$s&&As<=Be.prox&&(Ne=Di,Fe=Hi,ot=as,At=bi,Mt=Si,_t=si,je=ls);else{let ri=ct[Xe];ri!=null&&(Wt[Xe]=Di,ti[Xe]=Hi,qm(ri,as,bi,Si),Wm(ri,si,ls),hs(ri,Oi(Di),Oi(Hi),B,Re))}}}}if(Ce){let Xe=Be.prox,Yt=Tr==null?As<=Xe:As>Xe||$s!=Tr;if(ge||Yt){let sn=ct[0];sn!=null&&(Wt[0]=Ne,ti[0]=Fe,qm(sn,ot,At,Mt),Wm(sn,_t,je),hs(sn,Oi(Ne),Oi(Fe),B,Re))}}}if(qt.show&&qs)if(_!=null){let[me,Se]=mn.scales,[De,Ne]=mn.match,[Fe,ot]=_.cursor.sync.scales,At=_.cursor.drag;if(Ln=At._x,Dn=At._y,Ln||Dn){let{left:Mt,top:_t,width:je,height:Xe}=_.select,Yt=_.scales[Fe].ori,sn=_.posToVal,Un,Ft,rn,vi,ii,Li=me!=null&&De(me,Fe),Vi=Se!=null&&Ne(Se,ot);Li&&Ln?(Yt==0?(Un=Mt,Ft=je):(Un=_t,Ft=Xe),rn=M[me],vi=O(sn(Un,Fe),rn,K,0),ii=O(sn(Un+Ft,Fe),rn,K,0),da(qi(vi,ii),En(ii-vi))):da(0,K),Vi&&Dn?(Yt==1?(Un=Mt,Ft=je):(Un=_t,Ft=Xe),rn=M[Se],vi=L(sn(Un,ot),rn,le,0),ii=L(sn(Un+Ft,ot),rn,le,0),fa(qi(vi,ii),En(ii-vi))):fa(0,le)}else Yh()}else{let me=En(Up-Dp),Se=En(Op-Np);if(D.ori==1){let ot=me;me=Se,Se=ot}Ln=Gn.x&&me>=Gn.dist,Dn=Gn.y&&Se>=Gn.dist;let De=Gn.uni;De!=null?Ln&&Dn&&(Ln=me>=De,Dn=Se>=De,!Ln&&!Dn&&(Se>me?Dn=!0:Ln=!0)):Gn.x&&Gn.y&&(Ln||Dn)&&(Ln=Dn=!0);let Ne,Fe;Ln&&(D.ori==0?(Ne=so,Fe=Xt):(Ne=ro,Fe=Kt),da(qi(Ne,Fe),En(Fe-Ne)),Dn||fa(0,le)),Dn&&(D.ori==1?(Ne=so,Fe=Xt):(Ne=ro,Fe=Kt),fa(qi(Ne,Fe),En(Fe-Ne)),Ln||da(0,K)),!Ln&&!Dn&&(da(0,0),fa(0,0))}if(Gn._x=Ln,Gn._y=Dn,_==null){if(P){if(Jp!=null){let[me,Se]=mn.scales;mn.values[0]=me!=null?os(D.ori==0?Xt:Kt,me):null,mn.values[1]=Se!=null?os(D.ori==1?Xt:Kt,Se):null}ma(fd,i,Xt,Kt,B,Re,N)}if(tt){let me=P&&mn.setSeries,Se=Be.prox;Tr==null?As<=Se&&rs($s,ao,!0,me):As>Se?rs(null,ao,!0,me):$s!=Tr&&rs($s,ao,!0,me)}}ge&&(pe.idx=N,Wh()),w!==!1&&Nn("setCursor")}let Js=null;Object.defineProperty(i,"rect",{get(){return Js==null&&pa(!1),Js}});function pa(_=!1){_?Js=null:(Js=p.getBoundingClientRect(),Nn("syncRect",Js))}function kp(_,w,P,N,W,K,le){fe._lock||qs&&_!=null&&_.movementX==0&&_.movementY==0||(Xh(_,w,P,N,W,K,le,!1,_!=null),_!=null?Er(null,!0,!0):Er(w,!0,!1))}function Xh(_,w,P,N,W,K,le,me,Se){if(Js==null&&pa(!1),et(_),_!=null)P=_.clientX-Js.left,N=_.clientY-Js.top;else{if(P<0||N<0){Xt=-10,Kt=-10;return}let[De,Ne]=mn.scales,Fe=w.cursor.sync,[ot,At]=Fe.values,[Mt,_t]=Fe.scales,[je,Xe]=mn.match,Yt=w.axes[0].side%2==1,sn=D.ori==0?B:Re,Un=D.ori==1?B:Re,Ft=Yt?K:W,rn=Yt?W:K,vi=Yt?N:P,ii=Yt?P:N;if(Mt!=null?P=je(De,Mt)?a(ot,M[De],sn,0):-10:P=sn*(vi/Ft),_t!=null?N=Xe(Ne,_t)?a(At,M[Ne],Un,0):-10:N=Un*(ii/rn),D.ori==1){let Li=P;P=N,N=Li}}Se&&(w==null||w.cursor.event.type==fd)&&((P<=1||P>=B-1)&&(P=Dr(P,B)),(N<=1||N>=Re-1)&&(N=Dr(N,Re))),me?(Dp=P,Np=N,[so,ro]=fe.move(i,P,N)):(Xt=P,Kt=N)}let qh={width:0,height:0,left:0,top:0};function Yh(){Nl(qh,!1)}let zp,Vp,Hp,Gp;function Wp(_,w,P,N,W,K,le){qs=!0,Ln=Dn=Gn._x=Gn._y=!1,Xh(_,w,P,N,W,K,le,!0,!1),_!=null&&(bt(pd,yd,Xp,!1),ma(Fm,i,so,ro,B,Re,null));let{left:me,top:Se,width:De,height:Ne}=qt;zp=me,Vp=Se,Hp=De,Gp=Ne}function Xp(_,w,P,N,W,K,le){qs=Gn._x=Gn._y=!1,Xh(_,w,P,N,W,K,le,!1,!0);let{left:me,top:Se,width:De,height:Ne}=qt,Fe=De>0||Ne>0,ot=zp!=me||Vp!=Se||Hp!=De||Gp!=Ne;if(Fe&&ot&&Nl(qt),Gn.setScale&&Fe&&ot){let At=me,Mt=De,_t=Se,je=Ne;if(D.ori==1&&(At=Se,Mt=Ne,_t=me,je=De),Ln&&Ys(E,os(At,E),os(At+Mt,E)),Dn)for(let Xe in M){let Yt=M[Xe];Xe!=E&&Yt.from==null&&Yt.min!=Vt&&Ys(Xe,os(_t+je,Xe),os(_t,Xe))}Yh()}else fe.lock&&(fe._lock=!fe._lock,Er(w,!0,_!=null));_!=null&&(bn(pd,yd),ma(pd,i,Xt,Kt,B,Re,null))}function Cy(_,w,P,N,W,K,le){if(fe._lock)return;et(_);let me=qs;if(qs){let Se=!0,De=!0,Ne=10,Fe,ot;D.ori==0?(Fe=Ln,ot=Dn):(Fe=Dn,ot=Ln),Fe&&ot&&(Se=Xt<=Ne||Xt>=B-Ne,De=Kt<=Ne||Kt>=Re-Ne),Fe&&Se&&(Xt=Xt<so?0:B),ot&&De&&(Kt=Kt<ro?0:Re),Er(null,!0,!0),qs=!1}Xt=-10,Kt=-10,ie.fill(null),Er(null,!0,!0),me&&(qs=me)}function qp(_,w,P,N,W,K,le){fe._lock||(et(_),ha(),Yh(),_!=null&&ma(zm,i,Xt,Kt,B,Re,null))}function Yp(){C.forEach(zb),F(i.width,i.height,!0)}Or(nc,ho,Yp);let lo={};lo.mousedown=Wp,lo.mousemove=kp,lo.mouseup=Xp,lo.dblclick=qp,lo.setSeries=(_,w,P,N)=>{let W=mn.match[2];P=W(i,w,P),P!=-1&&rs(P,N,!0,!1)},_e&&(bt(Fm,p,Wp),bt(fd,p,kp),bt(Bm,p,_=>{et(_),pa(!1)}),bt(km,p,Cy),bt(zm,p,qp),Ed.add(i),i.syncRect=pa);let Ul=i.hooks=n.hooks||{};function Nn(_,w,P){ni?Dt.push([_,w,P]):_ in Ul&&Ul[_].forEach(N=>{N.call(null,i,w,P)})}(n.plugins||[]).forEach(_=>{for(let w in _.hooks)Ul[w]=(Ul[w]||[]).concat(_.hooks[w])});let $p=(_,w,P)=>P,mn=_n({key:null,setSeries:!1,filters:{pub:Km,sub:Km},scales:[E,v[1]?v[1].scale:null],match:[jm,jm,$p],values:[null,null]},fe.sync);mn.match.length==2&&mn.match.push($p),fe.sync=mn;let Jp=mn.key,$h=$g(Jp);function ma(_,w,P,N,W,K,le){mn.filters.pub(_,w,P,N,W,K,le)&&$h.pub(_,w,P,N,W,K,le)}$h.sub(i);function Ry(_,w,P,N,W,K,le){mn.filters.sub(_,w,P,N,W,K,le)&&lo[_](null,w,P,N,W,K,le)}i.pub=Ry;function Py(){$h.unsub(i),Ed.delete(i),In.clear(),Sd(nc,ho,Yp),c.remove(),se?.remove(),Nn("destroy")}i.destroy=Py;function Jh(){Nn("init",n,e),ua(e||n.data,!1),X[E]?Vh(E,X[E]):ha(),re=qt.show&&(qt.width>0||qt.height>0),te=ge=!0,F(n.width,n.height)}return v.forEach(jr),C.forEach(bs),t?t instanceof HTMLElement?(t.appendChild(c),Jh()):t(i,Jh):Jh(),i}Wn.assign=_n;Wn.fmtNum=Nd;Wn.rangeNum=ic;Wn.rangeLog=oc;Wn.rangeAsinh=Ld;Wn.orient=Br;Wn.pxRatio=Tt;Wn.join=Iv;Wn.fmtDate=Od,Wn.tzDate=Hv;Wn.sync=$g;{Wn.addGap=wb,Wn.clipGaps=cc;let n=Wn.paths={points:e0};n.linear=n0,n.stepped=Eb,n.bars=Cb,n.spline=Pb}function Ps(n,e,t=()=>!0){let[i,s]=Qe({value:void 0,error:"",path:n});return Ye(()=>{if(n===null)return;let r=new AbortController,o=0,a=async()=>{let l=!0;try{let c=await Qs(n,r.signal);l=t(c),s({value:c,error:"",path:n})}catch(c){if(us(c))return;s(u=>({...u,error:wn(c),path:n}))}l&&!r.signal.aborted&&(o=window.setTimeout(a,1e3*e))};return a(),()=>{r.abort(),clearTimeout(o)}},[n]),i.path===n?i:{value:void 0,error:""}}function vo(){let[n,e]=Qe(0);return Ye(()=>Zl(()=>e(t=>t+1)),[]),n}function sr(n){Ye(()=>{document.title=n===""?"cdcluster":`${n} - cdcluster`},[n])}var Vb=Symbol.for("pv"),Hb=0;function y(n,e,t,i,s,r){e||(e={});var o,a,l=e;if("ref"in l&&typeof n!="function")for(a in l={},e)a=="ref"?o=e[a]:l[a]=e[a];var c={type:n,props:l,key:t,ref:o,__k:null,__:null,__b:0,__e:null,__c:null,constructor:Vb,__v:--Hb,__i:-1,__u:0};return(s||r)&&(c.__source=s,c.__self=r),Nt.vnode&&Nt.vnode(c),c}var o0=160;function Gb(n,e,t){let i={stroke:Gi("--muted"),grid:{stroke:Gi("--line"),width:1},ticks:{stroke:Gi("--line"),width:1,size:4},font:"11px system-ui, sans-serif"};return{width:e,height:o0,legend:{show:!1},cursor:{drag:{x:!1,y:!1},y:!1},hooks:{setCursor:[s=>t(s.cursor.idx??null)]},scales:{y:{range:(s,r,o)=>[0,o>0?1.1*o:1]}},axes:[{...i,size:28,space:70,values:"{HH}:{mm}:{ss}"},{...i,size:64,values:(s,r)=>r.map(o=>n.format(o))}],series:[{},...n.lines.map(s=>({stroke:Gi(s.colour),width:1.5,...s.dash?{dash:s.dash}:{},points:{show:!1}}))]}}function Gd(n){let e=on(null),t=on(null),[i,s]=Qe(null),r=vo(),o=[n.times,...n.lines.map(u=>u.values)];Ye(()=>{let u=e.current;if(!u)return;let f=new Wn(Gb(n,u.clientWidth||300,s),o,u);t.current=f;let h=new ResizeObserver(()=>f.setSize({width:u.clientWidth||300,height:o0}));return h.observe(u),()=>{h.disconnect(),f.destroy(),t.current=null}},[r]),Ye(()=>t.current?.setData(o),[n.times,r]);let a=i!==null&&i<n.times.length?i:n.times.length-1,l=u=>n.format(u.values[a]??0),c=n.lines.map(u=>`${u.title} ${l(u)}`).join(", ");return y("figure",{class:"chart",children:[y("div",{ref:e,role:"img","aria-label":`${n.title}: ${c}`}),y("figcaption",{children:[n.lines.map(u=>y("span",{children:[y("svg",{viewBox:"0 0 18 4","aria-hidden":"true",children:y("line",{x1:0,x2:18,y1:2,y2:2,stroke:`var(${u.colour})`,"stroke-width":2,"stroke-dasharray":u.dash?.join(" ")??"none"})}),u.title," ",y("b",{children:l(u)})]},u.title)),y("span",{class:"note",children:i===null?"now":new Date(1e3*n.times[a]).toLocaleTimeString("en-GB")})]})]})}var fc=["separate","touch","cross","inside","contact","undecided","failed"];var Wb=[1,2,7,6,5,3,4];function Ra(n){return n===255?0:Wb[n]}function pc(n){return n>=1&&n<=4}function Is(n){return n===255?"not tested yet":fc[n]}function mc(n){let e=fc.indexOf(n);return e<0?255:e}function a0(n){return n===255?"-":"STXICUF"[n]}var Xb=[[92,168,128],[232,188,38],[206,58,50],[146,36,92],[216,104,48],[132,112,186],[60,64,70]],qb=[150,155,160];function ds(n){return n===255?qb:Xb[n]}function kr(n){let[e,t,i]=ds(n);return`rgb(${e} ${t} ${i})`}function l0(n){return n===255?.12:[.3,.6,1,.9,.8,.5,.7][n]}function Bt({text:n}){return y("bdi",{class:"name",title:n.slice(0,2e3),children:n===""?"(no name)":n.length>400?`${n.slice(0,400)}…`:n})}function zr({kind:n}){return y("span",{class:`mark mark-${Is(n).split(" ")[0]}`,style:{background:kr(n)},"aria-hidden":"true",children:a0(n)})}function c0(n){return n.count===0&&!n.always?null:y("span",{class:`count ${n.count===0?"zero":""}`,children:[y(zr,{kind:n.kind}),Is(n.kind)," ",y("b",{children:He(n.count)})]})}function kt(n){return y("div",{class:`notice ${n.kind}`,role:n.kind==="bad"?"alert":"status",children:n.children})}function fi(n){return y("section",{class:`panel ${n.wide?"wide":""}`,"aria-label":n.title,children:[y("header",{children:[y("h2",{children:n.title}),n.note&&y("span",{class:"note",children:n.note})]}),n.children]})}function gc({done:n,total:e}){let t=e===0?0:n/e;return y("span",{class:"progress",children:[y("progress",{max:1,value:t,"aria-label":`${He(n)} of ${He(e)}`}),y("span",{children:An(t)})]})}function _c({text:n}){let[e,t]=Qe("");return y("button",{type:"button",class:"command",title:"copy",onClick:()=>Wd(n,t),children:[y("code",{children:n}),y("span",{"aria-live":"polite",children:e||"copy"})]})}function Wd(n,e){let t=s=>{e(s),setTimeout(()=>e(""),2e3)};(navigator.clipboard?.writeText(n)??Promise.reject(new Error)).then(()=>t("copied"),()=>t("the browser did not allow it"))}function Yb(n,e){return typeof n=="number"&&typeof e=="number"?n-e:String(n).localeCompare(String(e),"en",{numeric:!0})}function rr(n){let[e,t]=Qe(null),i=n.columns.find(a=>a.key===e?.key),s=[...n.rows];i&&e?s.sort((a,l)=>(e.down?-1:1)*Yb(i.value(a),i.value(l))):n.order&&s.sort(n.order);let r=a=>{let l=a.isNumber===!0;e?.key!==a.key?t({key:a.key,down:l}):t(e.down===l?{key:a.key,down:!l}:null)},o=a=>e?.key!==a.key?"none":e.down?"descending":"ascending";return y("div",{class:"table",tabIndex:0,role:"region","aria-label":n.caption,children:y("table",{children:[y("caption",{children:n.caption}),y("thead",{children:y("tr",{children:n.columns.map(a=>y("th",{scope:"col",class:a.isNumber?"number":"","aria-sort":o(a),children:y("button",{type:"button",onClick:()=>r(a),children:a.title})},a.key))})}),y("tbody",{children:[s.length===0&&y("tr",{children:y("td",{class:"empty",colSpan:n.columns.length,children:n.empty})}),s.map(a=>y("tr",{class:n.rowClass?.(a)??"",children:n.columns.map(l=>y("td",{class:l.isNumber?"number":"",children:l.cell(a)},l.key))},n.rowKey(a)))]})]})})}function u0(n){let e=n.scenarios_per_second??0;return n.state==="running"&&e>0?(n.scenarios-n.done)/e:NaN}var $b=[{key:"job",title:"job",cell:n=>y("a",{href:er(n.job),children:n.job}),value:n=>n.job},{key:"name",title:"name",cell:n=>y(Bt,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>y("span",{class:`state ${n.state==="failed"?"bad":n.state==="paused"?"warn":""}`,children:n.state}),value:n=>n.state},{key:"owner",title:"owner",cell:n=>y(Bt,{text:n.owner||"-"}),value:n=>n.owner??""},{key:"began",title:"began",cell:n=>(n.began??"").replace("T"," ").replace(/Z$/," UTC"),value:n=>n.began??""},{key:"scenarios",title:"scenarios",cell:n=>He(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"done",title:"done",cell:n=>y(gc,{done:n.done,total:n.scenarios}),value:n=>n.done/Math.max(1,n.scenarios),isNumber:!0},{key:"contact",title:"in contact",cell:n=>n.done===0?"-":An(n.contact/n.done),value:n=>n.contact/Math.max(1,n.done),isNumber:!0},{key:"failed",title:"failed",cell:n=>y("span",{class:n.failed>0?"state bad":"",children:He(n.failed)}),value:n=>n.failed,isNumber:!0},{key:"rate",title:"rate",cell:n=>tr(n.scenarios_per_second??0),value:n=>n.scenarios_per_second??0,isNumber:!0},{key:"eta",title:"ends in",cell:n=>Lr(u0(n)),value:n=>u0(n)||0,isNumber:!0}];function Xd(n){return y(rr,{caption:"jobs",columns:$b,rows:n.jobs,rowKey:e=>e.job,...n.order?{order:n.order}:{},empty:"no job yet: cdctl run job.toml --master HOST:7600"})}function h0(){let{value:n,error:e}=Ps("jobs",2);return sr("jobs"),Ye(()=>Ni("jobs",()=>({ready:n!==void 0,jobs:n?.jobs.map(t=>t.job)})),[n]),Ye(()=>{n?.jobs.length===1&&n.jobs[0].job==="folder"&&Ts(er("folder"))},[n]),n?y(Ut,{children:[e&&y(kt,{kind:"bad",children:[e,"; below is what it said last"]}),y(Xd,{jobs:n.jobs})]}):e?y(kt,{kind:"bad",children:e}):y("p",{class:"wait",children:"asking for the jobs…"})}function xc(n){let e=["lost","silent","quarantined","draining"],t=e.indexOf(n.split(" ")[0]);return t<0?e.length:t}var d0=["bad","bad","warn","warn",""],Jb=[{key:"worker",title:"worker",cell:n=>n.worker,value:n=>n.worker},{key:"name",title:"name",cell:n=>y(Bt,{text:n.name}),value:n=>n.name},{key:"state",title:"state",cell:n=>y("span",{class:`state ${d0[xc(n.state)]}`,children:n.state}),value:n=>n.state},{key:"threads",title:"threads",cell:n=>He(n.threads),value:n=>n.threads,isNumber:!0},{key:"working",title:"working",cell:n=>He(n.working),value:n=>n.working,isNumber:!0},{key:"done",title:"done",cell:n=>He(n.scenarios),value:n=>n.scenarios,isNumber:!0},{key:"rate",title:"rate",cell:n=>tr(n.scenarios_per_second),value:n=>n.scenarios_per_second,isNumber:!0},{key:"cache",title:"cache",cell:n=>n.cache_bytes?Dm(n.cached_bytes,n.cache_bytes):Es(n.cached_bytes),value:n=>n.cached_bytes,isNumber:!0},{key:"hits",title:"hits",cell:n=>An(n.cache_hit_share),value:n=>n.cache_hit_share,isNumber:!0},{key:"peers",title:"to peers",cell:n=>Es(n.uploaded_bytes??0),value:n=>n.uploaded_bytes??0,isNumber:!0},{key:"longest",title:"longest",cell:n=>n.longest?y("a",{href:On(n.longest.job,n.longest.scenario),children:["#",n.longest.scenario," ",Lr(n.longest.seconds)]}):"-",value:n=>n.longest?.seconds??0,isNumber:!0}];function Zb({history:n}){let e=i=>{let s=n.columns.indexOf(i);return n.rows.map(r=>r[s]??0)},t=e("time");return y("div",{class:"two",children:[y(fi,{title:"throughput",note:"scenarios a second, ten minutes",children:y(Gd,{title:"throughput",times:t,format:tr,lines:[{title:"scenarios",colour:"--accent",values:e("scenarios_per_second")}]})}),y(fi,{title:"wire",note:"bytes a second, seen from the master",children:y(Gd,{title:"wire",times:t,format:Lm,lines:[{title:"out",colour:"--accent",values:e("sent_per_second")},{title:"in",colour:"--second",values:e("received_per_second"),dash:[6,3]},{title:"peer to peer",colour:"--third",values:e("peer_per_second"),dash:[2,3]}]})})]})}function Kb({cluster:n}){let e=n.workers.filter(r=>!r.state.startsWith("lost")),t=e.reduce((r,o)=>r+o.threads,0),i=e.reduce((r,o)=>r+o.scenarios_per_second,0),s=n.jobs.filter(r=>r.state==="running").length;return y("dl",{class:"numbers",children:[y("div",{children:[y("dt",{children:"scenarios"}),y("dd",{children:tr(i)})]}),y("div",{children:[y("dt",{children:e.length===1?"worker":"workers"}),y("dd",{children:He(e.length)})]}),y("div",{children:[y("dt",{children:"threads"}),y("dd",{children:He(t)})]}),y("div",{children:[y("dt",{children:s===1?"job runs":"jobs run"}),y("dd",{children:He(s)})]}),y("div",{children:[y("dt",{children:"up"}),y("dd",{children:Lr(n.uptime_seconds)})]}),y("div",{children:[y("dt",{children:"free on the disk"}),y("dd",{children:Es(n.state_bytes?.free??0)})]})]})}function f0(){let{value:n,error:e}=Ps("cluster",1),{value:t}=Ps("history",2);if(sr("cluster"),Ye(()=>Ni("cluster",()=>({ready:n!==void 0,workers:n?.workers.map(r=>({name:r.name,state:r.state})),jobs:n?.jobs.map(r=>({job:r.job,done:r.done,state:r.state}))})),[n]),!n)return e?y(kt,{kind:"bad",children:e}):y("p",{class:"wait",children:"asking the master…"});let i=(r,o)=>xc(r.state)-xc(o.state),s=(r,o)=>+(o.state==="running")-+(r.state==="running");return y(Ut,{children:[e&&y(kt,{kind:"bad",children:[e,"; below is what it said last"]}),n.paused&&y(kt,{kind:"bad",children:["jobs are paused: ",n.paused]}),n.alarms.map((r,o)=>y(kt,{kind:"warn",children:[y("b",{children:"alarm"})," ",y(Bt,{text:r})]},o)),y(Kb,{cluster:n}),y("p",{class:"line",children:[y("b",{children:"bottleneck"})," ",n.bottleneck,n.workers_lost>0&&y(Ut,{children:[" · ",jt(n.workers_lost,"worker")," lost so far"]}),n.alarms.length===0&&y(Ut,{children:" · no alarms"})]}),t&&y(Zb,{history:t}),y(rr,{caption:"workers",columns:Jb,rows:n.workers,rowKey:r=>r.worker,order:i,rowClass:r=>d0[xc(r.state)],empty:"no worker is connected: start cdworker --master HOST:7600"}),y(Xd,{jobs:n.jobs,order:s})]})}var qd=1e3;function jb(n){let e=[],t=null;return n.classes.forEach((i,s)=>{pc(i)?t?(t.last=n.first+s,t.worst=n.isWorse(s,t.worst)?s:t.worst):(t={first:n.first+s,last:n.first+s,worst:s},e.push(t)):t=null}),e}function p0({job:n,results:e}){if(n.poses.kind!=="file"||!e.isExact)return null;let t=jb(e),i=s=>y("a",{href:On(n.job,s),children:["#",He(s)]});return y(fi,{title:"episodes",note:`${jt(t.length,"run")} of consecutive scenarios in contact${t.length>qd?`; the first ${He(qd)} are listed`:""}`,children:y(rr,{caption:"episodes",rows:t.slice(0,qd),rowKey:s=>String(s.first),empty:"no scenario is in contact",columns:[{key:"first",title:"first",cell:s=>i(s.first),value:s=>s.first,isNumber:!0},{key:"last",title:"last",cell:s=>i(s.last),value:s=>s.last,isNumber:!0},{key:"length",title:"scenarios",cell:s=>He(s.last-s.first+1),value:s=>s.last-s.first,isNumber:!0},{key:"worst",title:"worst",cell:s=>y(Ut,{children:[y(zr,{kind:e.classes[s.worst]})," ",i(e.scenarioAt(s.worst))]}),value:s=>e.countAt(s.worst),isNumber:!0},{key:"pairs",title:"pairs there",cell:s=>e.counts?He(e.countAt(s.worst)):"-",value:s=>e.countAt(s.worst),isNumber:!0}]})})}function Qb(n,e){let i=n/e,s=i+1.959964*1.959964/(2*e),r=1.959964*Math.sqrt(i*(1-i)/e+1.959964*1.959964/(4*e*e)),o=1+1.959964*1.959964/e;return[Math.max(0,(s-r)/o),Math.min(1,(s+r)/o)]}function eS({group:n,job:e}){let t=e.poses.kind==="random"&&!e.poses.penetration&&e.done>0,[i,s]=t?Qb(n.scenarios,e.done):[0,0];return y("span",{class:"share",children:[y("meter",{min:0,max:1,value:n.share}),y("span",{children:[An(n.share),t&&y("small",{children:[" ",`${An(i)} to ${An(s)}`]})]})]})}function tS(n){return[{key:"a",title:"part of A",cell:e=>y(Bt,{text:e.a}),value:e=>e.a},{key:"b",title:"part of B",cell:e=>y(Bt,{text:e.b}),value:e=>e.b},{key:"scenarios",title:"in poses",cell:e=>He(e.scenarios),value:e=>e.scenarios,isNumber:!0},{key:"share",title:"share",cell:e=>y(eS,{group:e,job:n}),value:e=>e.share,isNumber:!0},{key:"worst",title:"worst",cell:e=>y("a",{href:On(n.job,e.worst,{part:`a/${e.a}`,with:`b/${e.b}`}),children:[y(zr,{kind:mc(e.class)})," #",He(e.worst)]}),value:e=>e.worst_pairs,isNumber:!0}]}function m0({job:n,groups:e}){let t=n.groups_total??e.length,i=t>e.length;return y(fi,{title:"parts in contact",note:i?`the ${He(e.length)} in most poses, of ${He(t)}`:"",children:y(rr,{caption:"parts in contact",columns:tS(n),rows:e,rowKey:s=>`${s.a}
${s.b}`,empty:"no part is in contact"})})}function nS(n){let e=[];for(let t of n){if(t===0)continue;let i=31-Math.clz32(t);for(;e.length<=i;){let s=2**e.length;e.push({first:s,last:2*s-1,count:0})}e[i].count+=1}return e}function Yd({results:n}){let e=n.counts?nS(n.counts):[];if(e.length===0)return null;let[t,i,s]=[480,150,18],r=Math.log1p(Math.max(...e.map(a=>a.count))),o=t/e.length;return y(fi,{title:"pairs a scenario",note:`scenarios in contact, both axes logarithmic${n.isExact?"":", of the sample"}`,children:y("svg",{class:"histogram",viewBox:`0 0 ${t} ${i+s}`,role:"img","aria-label":"histogram of pairs a scenario",children:[e.map((a,l)=>{let c=Math.log1p(a.count)/r*(i-14);return y("g",{children:[y("title",{children:`${He(a.first)} to ${He(a.last)} pairs: ${jt(a.count,"scenario")}`}),y("rect",{class:"hit",x:l*o,y:0,width:o,height:i}),y("rect",{class:"bar",x:l*o+1,y:i-c,width:o-2,height:c}),a.count>0&&y("text",{x:(l+.5)*o,y:i-c-3,children:hd(a.count)}),(l%2===0||e.length<12)&&y("text",{x:(l+.5)*o,y:i+13,children:hd(a.first)})]},a.first)}),y("line",{x1:0,x2:t,y1:i,y2:i})]})})}function bo(n,[e,t,i]){return[n[0]*e+n[1]*t+n[2]*i+n[3],n[4]*e+n[5]*t+n[6]*i+n[7],n[8]*e+n[9]*t+n[10]*i+n[11]]}function So(n){let e=[n[0],n[4],n[8],n[1],n[5],n[9],n[2],n[6],n[10]],t=i=>-(e[i]*n[3]+e[i+1]*n[7]+e[i+2]*n[11]);return[e[0],e[1],e[2],t(0),e[3],e[4],e[5],t(3),e[6],e[7],e[8],t(6)]}function yc(n,e){let t=[];for(let i=0;i<12;i+=4)for(let s=0;s<4;++s)t.push(n[i]*e[s]+n[i+1]*e[s+4]+n[i+2]*e[s+8]+(s===3?n[i+3]:0));return t}var Yi=["x","y","z","roll","pitch","yaw","distance"];function Pa(n,e=0){let t=180/Math.PI,[i,s,r]=[n[e+3],n[e+7],n[e+11]];return{x:i,y:s,z:r,roll:Math.atan2(n[e+9],n[e+10])*t,pitch:Math.asin(Math.max(-1,Math.min(1,-n[e+8])))*t,yaw:Math.atan2(n[e+4],n[e])*t,distance:Math.hypot(i,s,r)}}function or(n){return n==="roll"||n==="pitch"||n==="yaw"}var iS=10;function sS(n,e,t,i,s){n.beginPath(),e===1?n.arc(t,i,s*.55,0,2*Math.PI):e===2||e===4?(n.moveTo(t-s,i-s),n.lineTo(t+s,i+s),e===2&&(n.moveTo(t+s,i-s),n.lineTo(t-s,i+s))):e===3?n.rect(t-s,i-s,2*s,2*s):e>=5&&e!==255&&(n.moveTo(t-s,i),n.lineTo(t+s,i)),n.stroke()}var Mo=class{constructor(e,t,i,s,r,o,a){this.results=e;this.x=t;this.y=i;this.columns=s;this.rows=r;this.showsShares=o;this.describe=a;let l=s*r;this.worst=new Int32Array(l).fill(-1),this.number=new Uint32Array(l),this.tested=new Uint32Array(l),this.contacts=new Uint32Array(l)}results;x;y;columns;rows;showsShares;describe;worst;number;tested;contacts;add(e,t,i){let s=t*this.columns+e,r=this.results.classes[i];this.number[s]+=1,this.tested[s]+=r===255?0:1,this.contacts[s]+=pc(r)?1:0,(this.worst[s]<0||this.results.isWorse(i,this.worst[s]))&&(this.worst[s]=i)}colour(e){let t=this.results.classes[this.worst[e]];if(!this.showsShares||this.tested[e]===0)return ds(t);let i=this.contacts[e]/this.tested[e],[s,r]=[ds(0),ds(2)];return[0,1,2].map(o=>s[o]+(r[o]-s[o])*i)}draw(e,t,i){let s=new ImageData(this.columns,this.rows);for(let o=0;o<this.worst.length;++o){if(this.worst[o]<0)continue;let l=4*((this.rows-1-Math.floor(o/this.columns))*this.columns+o%this.columns);s.data.set([...this.colour(o),255],l)}let r=new OffscreenCanvas(this.columns,this.rows);r.getContext("2d")?.putImageData(s,0,0),e.imageSmoothingEnabled=!1,e.drawImage(r,0,0,t,i),this.drawGlyphs(e,t/this.columns,i/this.rows)}drawGlyphs(e,t,i){let s=Math.min(t,i);if(!(s<iS||this.showsShares)){e.strokeStyle="rgb(0 0 0 / 0.3)",e.lineWidth=Math.max(1,s/14);for(let r=0;r<this.worst.length;++r)if(this.worst[r]>=0){let o=(r%this.columns+.5)*t,a=(this.rows-.5-Math.floor(r/this.columns))*i;sS(e,this.results.classes[this.worst[r]],o,a,s*.2)}}}spot(e,t){let i=t*this.columns+e;return e<0||t<0||e>=this.columns||t>=this.rows||this.worst[i]<0?null:{scenario:this.results.scenarioAt(this.worst[i]),text:this.text(i),x:e/this.columns,y:t/this.rows,width:1/this.columns,height:1/this.rows}}text(e){let t=this.worst[e],i=this.results.scenarioAt(t),s=this.results.countAt(t),r=s>0?`, ${He(s)} pairs`:"",o=`#${i} ${Is(this.results.classes[t])}${r}${this.describe(i)}`;if(this.number[e]===1)return o;let a=An(this.contacts[e]/Math.max(1,this.tested[e]));return`${He(this.number[e])} scenarios, ${a} in contact; the worst is ${o}`}at(e,t){return this.spot(Math.floor(e*this.columns),Math.floor(t*this.rows))}step(e,t,i){let s=e?Math.round(e.x*this.columns):Math.floor(this.columns/2)-t,r=e?Math.round(e.y*this.rows):Math.floor(this.rows/2)-i;for(;;){if(s+=t,r+=i,s<0||r<0||s>=this.columns||r>=this.rows)return e;let o=this.spot(s,r);if(o)return o}}};function Ao(n,e){return`${Zn(e)}${n.unit}`}var rS=512,oS=40,$d=class{constructor(e,t){this.axes=e;this.unit=t;this.strides=e.map((i,s)=>e.slice(s+1).reduce((r,o)=>r*o.count,1))}axes;unit;strides;varying(){return this.axes.flatMap((e,t)=>e.count>1?[t]:[])}value(e,t){let{first:i,last:s,count:r}=this.axes[e];return t===0?i:t===r-1?s:i+(s-i)*t/(r-1)}numberOf(e,t){return Math.floor(t/this.strides[e])%this.axes[e].count}unitOf(e){return or(this.axes[e].name)?"°":` ${this.unit}`}plotAxis(e){let{name:t,first:i,last:s}=this.axes[e];return{title:t,first:i,last:s,unit:this.unitOf(e)}}valueText(e,t){return`${this.axes[e].name} ${Zn(this.value(e,t))}${this.unitOf(e)}`}describe(e){let t=this.varying().map(i=>this.valueText(i,this.numberOf(i,e)));return t.length===0?"":` at ${t.join(", ")}`}};function g0(n,e,t,i,s){let r=e.isExact?rS:oS,o=Math.min(r,n.axes[t].count),a=Math.min(r,n.axes[i].count),l=new Mo(e,n.plotAxis(t),n.plotAxis(i),o,a,!1,h=>n.describe(h)),c=h=>Math.floor(h*o/n.axes[t].count),u=h=>Math.floor(h*a/n.axes[i].count);if(!e.isExact){for(let h=0;h<e.classes.length;++h){let d=e.scenarioAt(h);l.add(c(n.numberOf(t,d)),u(n.numberOf(i,d)),h)}return l}let f=s.reduce((h,d,p)=>h+(p===t||p===i?0:d*n.strides[p]),0);for(let h=0;h<n.axes[t].count;++h)for(let d=0;d<(t===i?1:n.axes[i].count);++d){let p=f+h*n.strides[t]+(t===i?0:d*n.strides[i]);l.add(c(h),t===i?0:u(d),p-e.first)}return l}function _0(n){return n.poses.kind==="grid"&&n.poses.axes?new $d(n.poses.axes,n.unit):null}var aS={ArrowLeft:[-1,0],ArrowRight:[1,0],ArrowUp:[0,1],ArrowDown:[0,-1]};function lS(n,e,t,i){let[s,r]=[e.x*t,(1-e.y-e.height)*i];n.lineWidth=2*devicePixelRatio,n.strokeStyle=Gi("--ink"),n.beginPath(),e.width>0?n.rect(s-1,r-1,Math.max(4,e.width*t)+2,Math.max(4,e.height*i)+2):n.arc(s,r,6*devicePixelRatio,0,2*Math.PI),n.stroke()}function Jd(n){let{model:e}=n,t=on(null),i=on(null),[s,r]=Qe(null),[o,a]=Qe([0,0]),l=vo();Ye(()=>{let h=t.current;if(!h)return;let d=new ResizeObserver(()=>a([Math.round(h.clientWidth*devicePixelRatio),Math.round(h.clientHeight*devicePixelRatio)]));return d.observe(h),()=>d.disconnect()},[]),Ye(()=>r(null),[e.x.title,e.y.title]),Ye(()=>{let[h,d]=o;if(h>0&&d>0){i.current=new OffscreenCanvas(h,d);let p=i.current.getContext("2d");p&&e.draw(p,h,d)}},[e,o,l]),Ye(()=>{let h=t.current?.getContext("2d"),[d,p]=o;!t.current||!h||!i.current||(t.current.width=d,t.current.height=p,h.drawImage(i.current,0,0),s&&lS(h,s,d,p))},[e,s,o,l]);let c=h=>{let d=h.currentTarget.getBoundingClientRect(),p=(h.clientX-d.left)/d.width,b=1-(h.clientY-d.top)/d.height;return e.at(p,b,d.width,d.height)},u=h=>{let d=aS[h.key];d?(r(e.step(s,...d)),h.preventDefault()):h.key==="Enter"&&s&&n.open(s.scenario)},f=h=>Ao(h,(h.first+h.last)/2);return y("div",{class:"plot",children:[y("div",{class:"y-axis","aria-hidden":"true",children:[y("span",{children:Ao(e.y,e.y.last)}),y("b",{children:e.y.title}),y("span",{children:Ao(e.y,e.y.first)})]}),y("canvas",{ref:t,tabIndex:0,role:"application","aria-label":`${e.x.title} against ${e.y.title}: arrows move, Enter opens. ${s?.text??""}`,onPointerMove:h=>r(c(h)),onPointerLeave:()=>r(null),onClick:h=>{let d=c(h);d&&n.open(d.scenario)},onKeyDown:u}),y("div",{class:"x-axis","aria-hidden":"true",children:[y("span",{children:Ao(e.x,e.x.first)}),y("span",{children:[y("b",{children:e.x.title})," ",f(e.x)]}),y("span",{children:Ao(e.x,e.x.last)})]}),y("p",{class:"readout","aria-live":"polite",children:s?s.text:"point at a place to read it; a click opens its worst scenario"})]})}var y0=4096,v0=1<<24,cS=1<<22,uS=1<<18,vc=65536,bc=class{constructor(e,t,i,s){this.first=e;this.end=t;this.classes=i;this.counts=s}first;end;classes;counts;get isExact(){return this.classes.length===this.end-this.first}scenarioAt(e){return this.isExact?this.first+e:this.first+Math.floor(e*(this.end-this.first)/this.classes.length)}classOf(e){return this.isExact?this.classes[e-this.first]:void 0}isWorse(e,t){let i=Ra(this.classes[e])-Ra(this.classes[t]);return i>0||i===0&&this.countAt(e)>this.countAt(t)}worst(){let e=0;for(let t=1;t<this.classes.length;++t)e=this.isWorse(t,e)?t:e;return this.classes.length===0?0:this.scenarioAt(e)}countAt(e){return this.counts?.[e]??0}};function hS(n){return n.kind==="folder"?1<<20:vc}function Zd(n,e){return n.kind==="folder"?e:vc}async function x0(n,e,t,i,s){for(let r=0;r<t.length;r+=i){let o=Math.min(i,t.length-r),a=await cs(`${n}?first=${e+r}&count=${o}`,s);t.set(a.values,r)}return t}function Ia(n,e){return`jobs/${encodeURIComponent(n.job)}/${e}`}async function Sc(n,e,t,i,s){let r=i-t,o=hS(n);if(r>Zd(n,v0)){let[u,f]=await Promise.all(["classes","counts"].map(h=>cs(`${Ia(e,h)}?sample=${y0}`,s)));return new bc(0,e.scenarios,u.values,f.values)}let a=await x0(Ia(e,"classes"),t,new Uint8Array(r).fill(255),o,s),c=e.level!=="any"&&r<=Zd(n,cS)?await x0(Ia(e,"counts"),t,new Uint32Array(r),o,s):null;return new bc(t,i,a,c)}function b0(n,e,t){return t-e<=Zd(n,v0)}async function S0(n,e){let t=n.poses.of_both_bodies?24:12,i=n.scenarios;if(i>uS){let o=await cs(`${Ia(n,"poses")}?sample=${y0}`,e),a=o.shape[0];return{scenarios:Float64Array.from({length:a},(c,u)=>Math.floor(u*i/a)),values:o.values,width:t,isSample:!0}}let s=new Float64Array(t*i);for(let o=0;o<i;o+=vc){let a=Math.min(vc,i-o),l=await cs(`${Ia(n,"poses")}?first=${o}&count=${a}`,e);s.set(l.values,t*o)}return{scenarios:Float64Array.from({length:i},(o,a)=>a),values:s,width:t,isSample:!1}}var Kd=5e4,Mc=128,M0=14;function A0(n){let e=n.scenarios.length,t=Object.fromEntries(Yi.map(i=>[i,new Float64Array(e)]));for(let i=0;i<e;++i){let s;if(n.width===24){let r=Array.from(n.values.subarray(24*i,24*i+12)),o=Array.from(n.values.subarray(24*i+12,24*i+24));s=Pa(yc(So(r),o))}else s=Pa(n.values,12*i);for(let r of Yi)t[r][i]=s[r]}return t}function T0(n){let e=s=>{let[r,o]=E0(n[s]);return(o-r)*(or(s)?1e-6:1)},[t,i]=Yi.filter(s=>s!=="distance").sort((s,r)=>e(r)-e(s));return Yi.indexOf(t)<Yi.indexOf(i)?[t,i]:[i,t]}function E0(n){let[e,t]=[1/0,-1/0];for(let i of n)e=Math.min(e,i),t=Math.max(t,i);return e<t?[e,t]:[e-.5,e+.5]}function w0(n,e,t){let[i,s]=E0(e),r=.03*(s-i);return{title:n,first:i-r,last:s+r,unit:or(n)?"°":` ${t}`}}var wc=class{constructor(e,t,i,s,r,o){this.results=e;this.elements=t;this.px=i;this.py=s;this.x=r;this.y=o;this.order=Uint32Array.from(i,(a,l)=>l).sort((a,l)=>this.rank(a)-this.rank(l)||a-l)}results;elements;px;py;x;y;order;rank(e){return Ra(this.kind(e))}kind(e){return this.elements[e]<0?255:this.results.classes[this.elements[e]]}draw(e,t,i){let s=this.px.length,r=(s>2e4?1:s>2e3?1.6:2.6)*devicePixelRatio;for(let o of this.order){let a=this.kind(o),[l,c]=[this.px[o]*t,(1-this.py[o])*i],[u,f,h]=ds(a);e.fillStyle=`rgb(${u} ${f} ${h} / ${a===0?.6:.9})`,e.beginPath(),a===0||a===1?e.arc(l,c,r,0,2*Math.PI):a===2?e.rect(l-r,c-r,2*r,2*r):(e.moveTo(l,c-1.4*r),e.lineTo(l+1.4*r,c+r),e.lineTo(l-1.4*r,c+r)),e.fill()}}spot(e){let t=this.results.scenarioAt(Math.max(0,this.elements[e])),i=this.results.countAt(this.elements[e]),s=[this.x,this.y].map((o,a)=>{let l=a===0?this.px[e]:this.py[e];return`${o.title} ${Zn(o.first+l*(o.last-o.first))}${o.unit}`}),r=i>0?`, ${He(i)} pairs`:"";return{scenario:t,text:`#${t} ${Is(this.kind(e))}${r} at ${s.join(", ")}`,x:this.px[e],y:this.py[e],width:0,height:0}}at(e,t,i,s){let r=-1,o=M0*M0;for(let a=0;a<this.px.length;++a){let l=(this.px[a]-e)*i,c=(this.py[a]-t)*s,u=l*l+c*c;(u<o||u===o&&r>=0&&this.rank(a)>this.rank(r))&&(o=u,r=a)}return r<0?null:this.spot(r)}step(e,t,i){let s=e??{x:.5,y:.5},r=-1,o=1/0;for(let a=0;a<this.px.length;++a){let[l,c]=[this.px[a]-s.x,this.py[a]-s.y],u=l*t+c*i,f=l*l+c*c;u>0&&2*u*u>=f&&f<o&&(o=f,r=a)}return r<0?e:this.spot(r)}};function C0(n,e,t,i,s,r){let[o,a]=[w0(i,t[i],r),w0(s,t[s],r)],l=(d,p)=>(p-d.first)/(d.last-d.first),c=t[i].map(d=>l(o,d)),u=t[s].map(d=>l(a,d)),f=Int32Array.from(e.scenarios,(d,p)=>n.isExact?d-n.first:p<n.classes.length&&e.isSample?p:-1);if(!n.isExact&&!e.isSample)for(let d=0;d<n.classes.length;++d)f[n.scenarioAt(d)]=d;if(c.length<=Kd){let d=f.every(p=>p>=0)?null:[...f.keys()].filter(p=>f[p]>=0);return d?new wc(n,Int32Array.from(d,p=>f[p]),Float64Array.from(d,p=>c[p]),Float64Array.from(d,p=>u[p]),o,a):new wc(n,f,c,u,o,a)}let h=new Mo(n,o,a,Mc,Mc,!0,()=>"");for(let d=0;d<c.length;++d)f[d]>=0&&h.add(Math.floor(c[d]*Mc),Math.floor(u[d]*Mc),f[d]);return h}function R0(n){Ye(()=>Ni("pose space",()=>{let e=n?.step(null,1,0)??null;return{poseSpace:e&&{...e,axes:[n?.x.title,n?.y.title]}}}),[n])}function Ac(n){return y("label",{children:[n.label," ",y("select",{value:n.value,onChange:e=>n.choose(e.currentTarget.value),children:n.all.map(e=>y("option",{value:e,children:e},e))})]})}function dS(n){let e=n.varying();return{x:e[0]??0,y:e[1]??e[0]??0,fixed:n.axes.map(()=>0)}}function fS({job:n,grid:e,results:t}){let[{x:i,y:s,fixed:r},o]=Qe(()=>dS(e)),a=Jn(()=>g0(e,t,i,s,r),[e,t,i,s,r]);R0(a);let l=e.varying(),c=l.map(h=>e.axes[h].name),u=(h,d)=>{let p=e.axes.findIndex(v=>v.name===d),[b,m]=h==="x"?[i,s]:[s,i],g=p===m?b:m;o({x:h==="x"?p:g,y:h==="x"?g:p,fixed:r})},f=l.filter(h=>h!==i&&h!==s);return y(fi,{title:"pose space",note:t.isExact?"":`a sample of ${He(t.classes.length)}, other axes folded`,children:[y("div",{class:"controls",children:[l.length>1&&y(Ut,{children:[y(Ac,{label:"across",value:e.axes[i].name,all:c,choose:h=>u("x",h)}),y(Ac,{label:"up",value:e.axes[s].name,all:c,choose:h=>u("y",h)})]}),t.isExact&&f.map(h=>y("label",{class:"slider",children:[y("input",{type:"range",min:0,max:e.axes[h].count-1,value:r[h],onInput:d=>{let p=Number(d.currentTarget.value);o({x:i,y:s,fixed:r.map((b,m)=>m===h?p:b)})}})," ",e.valueText(h,r[h])]},h))]}),y(Jd,{model:a,open:h=>Ts(On(n.job,h))})]})}function pS({job:n,results:e}){let[t,i]=Qe(null),[s,r]=Qe(""),[o,a]=Qe(null);Ye(()=>{let p=new AbortController;return S0(n,p.signal).then(i,b=>us(b)||r(wn(b))),()=>p.abort()},[n.job,n.scenarios]);let l=Jn(()=>t?A0(t):null,[t]),[c,u]=o??(l?T0(l):["x","y"]),f=Jn(()=>t&&l?C0(e,t,l,c,u,n.unit):null,[e,t,l,c,u]);R0(f);let h=t!==null&&t.scenarios.length>Kd,d=[t?.isSample||!e.isExact?`a sample of ${He(Math.min(t?.scenarios.length??0,e.classes.length))}`:"",h?"share of contacts in each cell":"",n.poses.penetration?"poses pushed to contact":""];return y(fi,{title:"pose space",note:d.filter(p=>p!=="").join(", "),children:[s&&y(kt,{kind:"bad",children:s}),y("div",{class:"controls",children:[y(Ac,{label:"across",value:c,all:Yi,choose:p=>a([p,u])}),y(Ac,{label:"up",value:u,all:Yi,choose:p=>a([c,p])}),y("span",{class:"note",children:"of B in A's frame"})]}),f?y(Jd,{model:f,open:p=>Ts(On(n.job,p))}):y("p",{class:"wait",children:"reading the poses…"})]})}function P0({job:n,results:e}){let t=Jn(()=>_0(n),[n.job]);return t?y(fS,{job:n,grid:t,results:e}):y(pS,{job:n,results:e})}var mS=1024;function gS(n,e,t){let i=Math.min(mS,t-e),s=new Int32Array(i).fill(-1);for(let r=0;r<n.classes.length;++r){let o=n.scenarioAt(r);if(o<e||o>=t)continue;let a=Math.floor((o-e)*i/(t-e));(s[a]<0||n.isWorse(r,s[a]))&&(s[a]=r)}return s}function _S(n,e,t,i){let s=Math.round(n.clientWidth*devicePixelRatio),r=Math.round(n.clientHeight*devicePixelRatio),o=n.getContext("2d");if(!(!o||s===0)&&(n.width=s,n.height=r,t.forEach((a,l)=>{if(a<0)return;let c=e.classes[a],[u,f]=[l,l+1].map(p=>Math.round(p*s/t.length)),h=r*l0(c),d=f-u>4*devicePixelRatio?devicePixelRatio:0;o.fillStyle=kr(c),o.fillRect(u,r-h,Math.max(1,f-u-d),h)}),i)){let[a,l]=[Math.min(...i)*s,Math.max(...i)*s];o.fillStyle=Gi("--accent"),o.globalAlpha=.25,o.fillRect(a,0,l-a,r)}}function I0(n){let{source:e,job:t}=n,i=on(null),[s,r]=Qe([0,t.scenarios]),[o,a]=Qe(null),[l,c]=Qe(""),[u,f]=Qe(null),[h,d]=Qe(-1),[p,b]=Qe(0),m=vo(),[g,v]=s,C=o&&o.first===g&&o.end===v?o:n.results,M=Jn(()=>gS(C,g,v),[C,g,v]);Ye(()=>{if(a(null),n.results.isExact||!b0(e,g,v))return;let O=new AbortController;return Sc(e,t,g,v,O.signal).then(a,L=>us(L)||c(wn(L))),()=>O.abort()},[g,v,n.results.isExact]),Ye(()=>{let O=i.current;if(!O)return;let L=new ResizeObserver(()=>b(O.clientWidth));return L.observe(O),()=>L.disconnect()},[]),Ye(()=>{i.current&&_S(i.current,C,M,u)},[C,g,v,u,p,m]);let I=O=>{let L=O.currentTarget.getBoundingClientRect();return Math.min(1,Math.max(0,(O.clientX-L.left)/L.width))},E=O=>Math.min(M.length-1,Math.floor(O*M.length)),x=O=>{M[O]>=0&&Ts(On(t.job,C.scenarioAt(M[O])))},T=()=>{if(!u)return;let[O,L]=[Math.min(...u),Math.max(...u)];if(f(null),L-O<.005){x(E(O));return}let X=Math.floor(g+O*(v-g));r([X,Math.max(X+1,Math.ceil(g+L*(v-g)))]),d(-1)},V=O=>{let L=O.key==="ArrowRight"?1:O.key==="ArrowLeft"?-1:0;L!==0?(d(Math.min(M.length-1,Math.max(0,h+L))),O.preventDefault()):O.key==="Enter"&&h>=0?x(h):O.key==="Escape"&&r([0,t.scenarios])},U=h>=0&&h<M.length?M[h]:-1,D=g===0&&v===t.scenarios,H=U>=0?`#${C.scenarioAt(U)} ${Is(C.classes[U])}, the worst of this bin`:"drag to zoom, click to open";return y(fi,{title:"scenarios in order",wide:!0,note:C.isExact?"":`a sample of ${He(C.classes.length)}; zoomed windows are exact`,children:[l&&y(kt,{kind:"bad",children:l}),y("canvas",{ref:i,class:"strip",tabIndex:0,role:"application","aria-label":`scenarios ${g} to ${v-1}: arrows move, Enter opens, Escape shows all. ${H}`,onPointerDown:O=>{O.currentTarget.setPointerCapture(O.pointerId),f([I(O),I(O)])},onPointerMove:O=>{d(E(I(O))),f(u&&[u[0],I(O)])},onPointerUp:T,onPointerCancel:()=>f(null),onPointerLeave:()=>u||d(-1),onKeyDown:V}),y("div",{class:"x-axis",children:[y("span",{children:["#",He(g)]}),y("span",{class:"readout",children:H}),y("span",{children:[!D&&y("button",{type:"button",class:"quiet",onClick:()=>r([0,t.scenarios]),children:"show all"})," ","#",He(v-1)]})]})]})}function L0(n){return n.state!=="running"&&n.state!=="paused"}function xS(n){return n.touch+n.cross+n.inside+n.contact}function yS({job:n}){let e=xS(n),t=n.done===n.scenarios?"":` tested so far, of ${He(n.scenarios)}`;return y("div",{class:"verdict",children:[y("h1",{children:[y(Bt,{text:n.name||n.job}),y("span",{class:`state ${n.state==="failed"?"bad":""}`,children:n.state}),!L0(n)&&y(gc,{done:n.done,total:n.scenarios})]}),y("p",{class:"sentence",children:e===0?`No contact in ${jt(n.done,"scenario")}${t}.`:`${He(e)} of ${jt(n.done,"scenario")}${t} ${e===1?"is":"are"} in contact (${An(e/Math.max(1,n.done))}), with ${jt(n.pairs,"pair")} of triangles.`}),y("p",{class:"counts",children:[fc.map((i,s)=>y(c0,{kind:s,count:n[i],always:i==="separate"||i==="cross"||i==="failed"},i)),n.digest&&y("span",{class:"count",children:["digest ",y("code",{title:n.digest,children:n.digest.slice(0,16)})]})]})]})}function vS({job:n}){let e=[];return n.surfaces_only>0&&e.push(`Containment was not tested in ${jt(n.surfaces_only,"scenario")}: a body is open.`),n.insides_skipped>0&&e.push(`Containment was not tested in ${jt(n.insides_skipped,"scenario")}: triangles are ignored, and the rest of a body is open.`),n.cut>0&&e.push(`The list of pairs ends at ${He(n.limit_pairs)} in ${jt(n.cut,"scenario")}; counts are true.`),n.map_pairs>0&&e.push(`The heat map counts the first ${He(n.map_pairs)} pairs of a scenario.`),e.length===0?null:y("p",{class:"caveats",children:e.join(" ")})}function bS({body:n,letter:e,unit:t}){let i=n.closed===null?"":n.closed?", closed":", open";return y("div",{class:"card",children:[y("b",{class:"letter",children:e}),y("div",{children:[y(Bt,{text:ba(n.file)}),n.name.toLowerCase()!==e.toLowerCase()&&y("span",{class:"note",children:[" ","called ",y(Bt,{text:n.name})]}),y("div",{class:"note",children:[jt(n.triangles,"triangle"),", ",jt(n.parts,"part"),i]}),y("div",{class:"note",children:[n.size.map(s=>Zn(s)).join(" × ")," ",t," · ",n.precision]})]})]})}function SS(n){let{poses:e}=n;return e.kind==="grid"?`grid ${(e.axes??[]).filter(i=>i.count>1).map(i=>`${i.name} ${He(i.count)}`).join(" × ")}`:e.kind==="random"?`random, seed ${e.seed??"-"}${e.penetration?`, pushed ${e.penetration.map(t=>An(t)).join(" to ")} into contact`:""}`:`file ${ba(e.file??"")}`}function MS({job:n}){let e=n.tolerance>0?`tolerance ${Zn(n.tolerance)} ${n.unit}`:"exact";return y("div",{class:"card",children:[y("b",{class:"letter",children:"×"}),y("div",{children:[y("span",{children:jt(n.poses.count,"pose")}),y("div",{class:"note",children:[SS(n),n.poses.of_both_bodies?", of both bodies":""]}),y("div",{class:"note",children:["level ",n.level,", ",e,n.ignored>0&&`, ${jt(n.ignored,"range")} ignored`]})]})]})}function wS({job:n}){let e=[["where",n.where],["instructions",n.simd],["time",n.seconds>0?`${Lr(n.seconds)}, ${tr(n.scenarios_per_second)}`:""],["owner",n.owner],["started",n.started||n.began],["ended",n.ended],["command",n.command],["program",[n.program,n.commit].filter(s=>s!=="").join(", commit ")],["digest",n.digest??""],...n.bodies.map(s=>[`mesh ${s.name}`,`${s.sha256} (${Es(s.bytes)}), ${s.file}`])],t=n.folder?va(n.folder):n.job,i=(n.formats??[]).length>0?`the folder has ${n.formats?.join(", ")}; more:`:"";return y("details",{class:"how",children:[y("summary",{children:"how it ran, and exports"}),y("dl",{children:e.filter(([,s])=>s).map(([s,r])=>y("div",{children:[y("dt",{children:s}),y("dd",{children:y("bdi",{children:r})})]},s))}),y("p",{class:"note",children:[i," ",y(_c,{text:`cdctl results ${t}${n.folder?"":" --out out"} --formats csv,npz`})]})]})}var AS=3e3;function TS(n,e){let[t,i]=Qe({results:null,error:"",done:-1,at:0}),[s,r]=Qe(0);return Ye(()=>{if(!e)return;let o=new AbortController,a=(l,c)=>i(u=>({results:l??u.results,error:c,done:e.done,at:performance.now()}));return Sc(n,e,0,e.scenarios,o.signal).then(l=>a(l,""),l=>us(l)||a(null,wn(l))),()=>o.abort()},[e?.job,s]),Ye(()=>{if(!e||t.done<0||e.done===t.done)return;let o=Math.max(0,t.at+AS-performance.now()),a=setTimeout(()=>r(l=>l+1),o);return()=>clearTimeout(a)},[e?.done,t]),t}function ES(n,e){Ye(()=>Ni("job",()=>({ready:n!==void 0&&e!==null,job:n?.job,done:n?.done,isExact:e?.isExact,tested:e?.classes.reduce((t,i)=>t+(i===255?0:1),0)})),[n,e])}function D0({source:n,id:e}){let{value:t,error:i}=Ps(`jobs/${encodeURIComponent(e)}`,1,a=>!L0(a)),{results:s,error:r}=TS(n,t),o=Jn(()=>s?.worst()??0,[s]);return sr(t&&t.name||e),ES(t,s),t?y(Ut,{children:[(i||r)&&y(kt,{kind:"bad",children:i||r}),t.failure&&y(kt,{kind:"bad",children:["failed: ",y(Bt,{text:t.failure})]}),t.paused&&y(kt,{kind:"warn",children:["paused: ",t.paused]}),y(yS,{job:t}),y("div",{class:"cards",children:[t.bodies.map((a,l)=>y(bS,{body:a,letter:l===0?"A":l===1?"B":String(l),unit:t.unit},l)),y(MS,{job:t}),y("a",{class:"card go",href:On(t.job,o),children:"see it in 3D"})]}),y(vS,{job:t}),s?y(Ut,{children:[y("div",{class:"two",children:[y(P0,{job:t,results:s}),t.groups?y(m0,{job:t,groups:t.groups}):y(Yd,{results:s})]}),y(I0,{source:n,job:t,results:s}),y("div",{class:"two",children:[t.groups&&y(Yd,{results:s}),y(p0,{job:t,results:s})]})]}):y("p",{class:"wait",children:"reading the results…"}),y(wS,{job:t})]}):i?y(kt,{kind:"bad",children:i}):y("p",{class:"wait",children:["asking for ",e,"…"]})}var CS=[["n, p","next and previous scenario in contact"],["← →","previous and next scenario"],["space","play, stop"],["h","heat map, contacts"],["g","ghost: A, B, none"],["x","contacts through walls"],["l","segments and points"],["s","section plane"],["[ ]","move the section plane"],["f","fit all into view"],["c","go to the contact"],["shift ← → ↑ ↓","turn"],["+ −","nearer, farther"],["drag, wheel","turn, zoom; with the right button or two fingers: move"],["click","pick a triangle; with shift: of the ghost"],["?","these keys"]];function N0({close:n}){let e=on(null);return Ye(()=>e.current?.showModal(),[]),y("dialog",{ref:e,class:"keys",onClose:n,onClick:()=>e.current?.close(),children:[y("h2",{children:"Keys of the viewer"}),y("table",{children:y("tbody",{children:CS.map(([t,i])=>y("tr",{children:[y("th",{scope:"row",children:y("kbd",{children:t})}),y("td",{children:i})]},t))})}),y("button",{type:"button",children:"close"})]})}function U0(n){let e=n.target;if(n.ctrlKey||n.altKey||n.metaKey)return!0;if(e instanceof HTMLInputElement){let i=e.type==="range"||e.type==="radio";return e.type==="number"||i&&n.key.startsWith("Arrow")}return e instanceof HTMLButtonElement&&n.key===" "||e instanceof HTMLSelectElement||document.querySelector("dialog[open]")!==null}function O0(n){return y("fieldset",{class:"radio",children:[y("legend",{children:n.title}),n.all.map(([e,t])=>y("label",{children:[y("input",{type:"radio",name:n.name,checked:n.value===e,onChange:()=>n.choose(e)}),y("span",{children:t})]},e))]})}function jd(n){return y("label",{class:"check",children:[y("input",{type:"checkbox",checked:n.isOn,onChange:e=>n.turn(e.currentTarget.checked)}),n.text]})}function RS(n){let{clip:e}=n.state,[t,i]=n.bounds[e?.axis??"x"],s=r=>(n.bounds[r][0]+n.bounds[r][1])/2;return y("div",{class:"section-plane",children:[y(jd,{text:"section",isOn:e!==null,turn:r=>n.change({clip:r?{axis:"x",at:s("x")}:null})}),e&&y(Ut,{children:[y("select",{"aria-label":"axis of the section plane",value:e.axis,onChange:r=>{let o=r.currentTarget.value;n.change({clip:{axis:o,at:s(o)}})},children:["x","y","z"].map(r=>y("option",{children:r},r))}),y("input",{type:"range","aria-label":"place of the section plane",min:t,max:i,step:(i-t)/500||1,value:e.at,onInput:r=>n.change({clip:{axis:e.axis,at:Number(r.currentTarget.value)}})}),y("output",{children:Number(e.at.toPrecision(4))})]})]})}function F0(n){let{state:e,change:t}=n,i=[["contacts","contacts"]];n.hasMap&&i.push(["heat","heat map"]);let s=[["a","A"],["b","B"],["none","none"]];return y("section",{class:"view-controls","aria-label":"view",children:[y(O0,{title:"show",name:"mode",value:e.mode,all:i,choose:r=>t({mode:r})}),y(O0,{title:"ghost",name:"ghost",value:e.ghost,all:s,choose:r=>t({ghost:r})}),y(jd,{text:"through walls",isOn:e.throughWalls,turn:r=>t({throughWalls:r})}),y(jd,{text:"segments and points",isOn:e.lines,turn:r=>t({lines:r})}),y(RS,{state:e,bounds:n.bounds,change:t}),y("div",{class:"buttons",children:[y("button",{type:"button",onClick:n.fit,title:"f",children:"fit"}),y("button",{type:"button",onClick:n.goToContact,title:"c",children:"go to the contact"})]})]})}function B0({address:n}){let[e,t]=Qe("");return y("button",{type:"button",onClick:()=>Wd(n(),t),children:e||"copy link"})}var La=[[68,1,84],[71,45,123],[59,82,139],[44,114,142],[33,145,140],[40,174,128],[94,201,98],[173,220,48],[253,231,37]];function Qd(n){let e=Math.min(1,Math.max(0,n))*(La.length-1),t=Math.min(La.length-2,Math.floor(e)),i=e-t;return[0,1,2].map(s=>Math.round(La[t][s]+(La[t+1][s]-La[t][s])*i))}function k0(n){let e=new Uint8Array(1024);for(let t=0;t<256;++t)e.set([...t===0?n:Qd((t-1)/254),255],4*t);return e}function PS(n,e){return n===0?0:e<=1?255:1+Math.round(254*Math.log(n)/Math.log(e))}function z0(n,e){let t=new Float64Array(e);for(let i=0;i+1<n.length;i+=2)t[n[i]]=n[i+1];return t}function V0(n,e){let t=new Uint8Array(3*n.length);for(let i=0;i<n.length;++i)t.fill(PS(n[i],e),3*i,3*i+3);return t}var Tc=48;function IS(n){let e=[1];for(let t=10;t<n/2;t*=10)e.push(t);return n>1?[...e,n]:e}function H0({heat:n,job:e}){if(n.most===0)return y("p",{class:"note",children:"no triangle was in contact"});let[t,i]=[264,10],s=o=>n.most<=1?0:Math.log(o)/Math.log(n.most)*t,r=IS(n.most);return y("figure",{class:"legend",children:[y("svg",{viewBox:`0 0 ${t} 42`,role:"img","aria-label":"colours of the heat map",children:[Array.from({length:Tc},(o,a)=>{let[l,c,u]=Qd(a/(Tc-1));return y("rect",{x:a*t/Tc,y:0,width:t/Tc+.5,height:i,fill:`rgb(${l},${c},${u})`},a)}),r.map((o,a)=>y("g",{children:[y("line",{x1:s(o),x2:s(o),y1:i,y2:i+3}),y("text",{x:s(o),y:i+14,class:a===0?"begin":a===r.length-1?"end":"",children:He(o)}),y("text",{x:s(o),y:i+27,class:a===0?"begin":a===r.length-1?"end":"",children:An(o/Math.max(1,e.done))})]},o))]}),y("figcaption",{class:"note",children:["scenarios in which a triangle is in contact, logarithmic",e.map_pairs>0&&`, of the first ${He(e.map_pairs)} pairs`,"; plain: never"]})]})}function G0(){return y("ul",{class:"legend plain",children:[y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:y("path",{d:"M1 11 7 1l6 10z",fill:kr(2)})}),"proper: goes through the other"]}),y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:y("path",{d:"M1 11 7 1l6 10z",fill:kr(1),class:"outlined"})}),"touch or coplanar: outlined"]}),y("li",{children:[y("svg",{viewBox:"0 0 14 12","aria-hidden":"true",children:[y("path",{d:"M1 9 11 4",class:"thick"}),y("circle",{cx:12,cy:4,r:2})]}),"what they share"]})]})}var LS=[0,67,68,77,69,83,72,49],ef=29;async function DS(n,e){if(!globalThis.crypto?.subtle)return null;let t=new Uint8Array(await crypto.subtle.digest("SHA-256",n));return Array.from(t,i=>i.toString(16).padStart(2,"0")).join("")===e}function NS(n,e,t){let i=[],s=new TextDecoder;for(let r=0;r<t;++r){let o=n.getUint32(e,!0),a=s.decode(new Uint8Array(n.buffer,e+4,o));e+=4+o,i.push({name:a,begin:n.getUint32(e,!0),end:n.getUint32(e+4,!0)}),e+=8}return i}function US(n){let e=[1/0,1/0,1/0],t=[-1/0,-1/0,-1/0];for(let i=0;i<n.length;i+=3)for(let s=0;s<3;++s){let r=n[i+s];e[s]=r<e[s]?r:e[s],t[s]=r>t[s]?r:t[s]}return n.length===0?[[0,0,0],[0,0,0]]:[e,t]}function OS(n,e,t){let i=new DataView(n);if(n.byteLength<ef||LS.some((b,m)=>i.getUint8(m)!==b))throw new Error("the server's mesh is not in canonical form");let s=i.getUint8(8)===1,r=Number(i.getBigUint64(9,!0)),o=Number(i.getBigUint64(17,!0)),a=i.getUint32(25,!0),l=ef+r*3*(s?8:4),c=l+o*12;if(c>n.byteLength)throw new Error("the server's mesh is cut short");let u=n.slice(ef,l),f=s?new Float64Array(u):new Float32Array(u),h=new Uint32Array(n.slice(l,c)),[d,p]=US(f);return{sha256:e,checked:t,bytes:n.byteLength,vertices:f,triangles:h,parts:NS(i,c,a),min:d,max:p,centre:[0,1,2].map(b=>(d[b]+p[b])/2)}}async function tf(n,e){let t=await wm(`meshes/${n}`,e),i=await DS(t,n);try{return OS(t,n,i)}catch(s){throw i===!1?new Error(`not the tested geometry: ${wn(s)}`):s}}function W0(n){let{vertices:e,triangles:t,centre:i}=n,[s,r,o]=i,a=new Float32Array(3*t.length);for(let l=0;l<t.length;++l){let c=3*t[l];a[3*l]=e[c]-s,a[3*l+1]=e[c+1]-r,a[3*l+2]=e[c+2]-o}return a}function Da(n,e){let t=0,i=n.parts.length;for(;t<i;){let r=t+i>>1;n.parts[r].end<=e?t=r+1:i=r}let s=n.parts[t];return s&&s.begin<=e?s:void 0}var Na=8e6,Ec=null;async function FS(n){let e=performance.now(),[t,i]=n.bodies.map(o=>o.sha256),s=tf(t);return{meshes:await Promise.all([s,t===i?s:tf(i)]),milliseconds:performance.now()-e}}function X0(n){let e=n.bodies.map(t=>t.sha256).join(" ");if(Ec?.key!==e){let t=FS(n);Ec={key:e,model:t},t.catch(()=>{Ec=null})}return Ec.model}async function q0(n,e){try{let i=(await Promise.all([0,1].map(r=>cs(`jobs/${encodeURIComponent(n.job)}/map/${r}`)))).map((r,o)=>z0(r.values,e.meshes[o].triangles.length/3)),s=i.reduce((r,o)=>o.reduce((a,l)=>Math.max(a,l),r),0);return{counts:i,most:s}}catch(t){if(t instanceof js&&t.status===404)return null;throw t}}var nf=100;function BS(n,e){let t=new Map;for(let i=0;i+2<n.length;i+=3){let[s,r]=[0,1].map(l=>Da(e[l],n[i+l])?.name??""),o=`${s.length}:${s}${r}`,a=t.get(o);a?a.count+=1:t.set(o,{a:s,b:r,count:1})}return[...t.values()].sort((i,s)=>s.count-i.count)}function $0(n){let{state:e}=n,t=Jn(()=>BS(n.contacts.pairs,n.model.meshes),[n.contacts,n.model]);if(t.length===0&&!e.partA&&!e.partB)return null;let i=s=>e.partA===s.a&&e.partB===s.b;return y("section",{"aria-label":"parts in contact here",children:[y("h2",{children:"parts in contact here"}),y("ul",{class:"pairs",children:t.slice(0,nf).map(s=>y("li",{children:y("button",{type:"button","aria-pressed":i(s),onClick:()=>i(s)?n.choose("",""):n.choose(s.a,s.b),children:[y("span",{children:[y(Bt,{text:s.a})," ",y("i",{children:"×"})," ",y(Bt,{text:s.b})]}),y("b",{children:He(s.count)})]})},`${s.a}
${s.b}`))}),t.length>nf&&y("p",{class:"note",children:["and ",jt(t.length-nf,"pair")," of parts more"]}),(e.partA||e.partB)&&y("p",{class:"note",children:["only ",y(Bt,{text:e.partA||"all of A"})," × ",y(Bt,{text:e.partB||"all of B"}),";"," ",y("button",{type:"button",class:"link",onClick:()=>n.choose("",""),children:"show all"})]})]})}function J0(n){let{pick:e,job:t}=n,i=n.model.meshes[e.body],s=Da(i,e.triangle),r=e.triangle<i.triangles.length/3,o=Jn(()=>{let l=0,c=n.contacts?.pairs??new Uint32Array;for(let u=e.body;u<c.length;u+=3)l+=c[u]===e.triangle?1:0;return l},[n.contacts,e]),a=n.heat?.counts[e.body][e.triangle];return y("section",{"aria-label":"picked triangle","aria-live":"polite",children:[y("h2",{children:["picked"," ",y("button",{type:"button",class:"link",onClick:n.drop,children:"drop"})]}),r?y("p",{children:[e.body===0?"A":"B"," triangle ",y("b",{children:He(e.triangle)}),s&&y(Ut,{children:[", ",y(Bt,{text:s.name})," ",He(e.triangle-s.begin)]}),"; in ",jt(o,"pair")," here",a!==void 0&&`; in ${He(a)} of ${jt(t.done,"pose")} (${An(a/Math.max(1,t.done))})`]}):y("p",{children:["the mesh has no triangle ",He(e.triangle)]})]})}function Y0({pose:n,title:e}){let t=[n.slice(0,4),n.slice(4,8),n.slice(8,12),[0,0,0,1]];return y("table",{class:"matrix",children:[y("caption",{children:e}),y("tbody",{children:t.map((i,s)=>y("tr",{children:i.map((r,o)=>y("td",{children:String(r)},o))},s))})]})}function Z0({job:n,contacts:e,relative:t}){let i=Pa(t),s=Yi.filter(a=>a!=="distance"&&(!or(a)||Math.abs(i[a])>1e-9)).map(a=>`${a} ${Zn(i[a],5)}${or(a)?"°":""}`),{pose_a:r,pose_b:o}=e.scenario;return y("section",{"aria-label":"pose",children:[y("h2",{children:"B in A's frame"}),y("p",{children:[s.join("  ")," ",y("span",{class:"note",children:["lengths in ",n.unit]})]}),y("details",{children:[y("summary",{children:"matrix"}),n.poses.of_both_bodies&&y(Y0,{pose:r,title:"A in the world"}),y(Y0,{pose:n.poses.of_both_bodies?o:t,title:n.poses.of_both_bodies?"B in the world":"B in A's frame"})]})]})}function K0({model:n,contacts:e}){let t=n?.meshes.filter(r=>r.checked===!1)??[],i=n?.meshes.some(r=>r.checked===null)??!1,s=e?.scenario;return y(Ut,{children:[t.length>0&&y(kt,{kind:"bad",children:["not the tested geometry: the bytes of ",jt(t.length,"mesh").replace("meshs","meshes")," do not have the SHA-256 of the run (",t.map(r=>r.sha256.slice(0,16)).join(", "),")"]}),t.length===0&&i&&y(kt,{kind:"warn",children:"the geometry is not checked: this browser computes SHA-256 on 127.0.0.1 or over TLS only"}),s?.verified===!1&&y(kt,{kind:"bad",children:["this scenario, run again here, gives another record than the stored one: ",s.verify_note]}),s&&s.failure!==""&&y(kt,{kind:"bad",children:["failed: ",y(Bt,{text:s.failure})]})]})}function j0({job:n,contacts:e}){let{scenario:t}=e,i=mc(t.class),s=t.class!==null&&t.count>0?jt(t.count,"pair"):"",r=[i===3?"one body is inside the other: g changes the ghost":"",t.id!==null?`id ${t.id}`:"",t.time!==null?`t ${Zn(t.time,6)}`:"",e.isCut?`drawn: the first ${He(e.pairs.length/3)} pairs`:"",t.cut?`list of pairs cut at ${He(t.listed)}`:"",t.surfaces_only?"surfaces only: a body is open":"",t.insides_skipped?"containment not tested: triangles are ignored":"",t.distance_bound!==null&&t.distance_bound>0?`at most ${Zn(t.distance_bound)} ${n.unit} apart`:""].filter(o=>o!=="");return y("span",{class:"scenario-status",children:[y("span",{children:[y(zr,{kind:i}),y("b",{children:t.class??"no result yet"}),s&&`, ${s}`]}),t.verified===!0&&y("span",{class:"verified",title:"run again by this server, the record has the same bytes",children:"✓ verified"}),t.verified===null&&y("span",{class:"note",title:t.verify_note,children:["not verified",t.verify_note&&`: ${t.verify_note}`]}),r.length>0&&y("span",{class:"note",children:r.join(" · ")})]})}async function Q0(n,e,t,i){let s=new URLSearchParams({from:String(e),step:String(t)});i.partA&&s.set("part_a",i.partA),i.partB&&s.set("part_b",i.partB);let r=`jobs/${encodeURIComponent(n)}/scenarios/next?${s}`;return(await Qs(r)).index}var kS=300,Cc=class{constructor(e,t,i){this.job=e;this.show=t;this.fail=i}job;show;fail;wanted=null;isLoading=!1;stop=new AbortController;want(e){this.wanted=e,this.isLoading||this.run()}close(){this.wanted=null,this.stop.abort()}async run(){for(this.isLoading=!0;this.wanted!==null;){let e=this.wanted;try{let t=await this.load(e);this.wanted=this.wanted===e?null:this.wanted,this.show(t)}catch(t){if(us(t)||this.stop.signal.aborted)break;t instanceof js&&t.status===503?await new Promise(i=>setTimeout(i,kS)):(this.wanted=this.wanted===e?null:this.wanted,this.fail(e,t))}}this.isLoading=!1}async load(e){let t=`jobs/${encodeURIComponent(this.job)}/scenarios/${e}`,i=this.stop.signal,s=await Qs(t,i);if(s.class===null||s.exact_pairs===0)return{scenario:s,pairs:new Uint32Array,points:new Float64Array,isCut:!1};let r=await cs(`${t}/pairs`,i),o=await cs(`${t}/points`,i);return{scenario:s,pairs:r.values,points:o.values,isCut:r.cut||o.cut}}};var br={LEFT:0,MIDDLE:1,RIGHT:2,ROTATE:0,DOLLY:1,PAN:2},Sr={ROTATE:0,PAN:1,DOLLY_PAN:2,DOLLY_ROTATE:3},D_=0,Nf=1,N_=2;var ml=1,U_=2,Qo=3,Mr=0,hi=1,gi=2,qr=0,ea=1,Uf=2,Of=3,Ff=4,O_=5;var Yr=100,F_=101,B_=102,k_=103,z_=104,V_=200,H_=201,G_=202,W_=203,Bf=204,kf=205,X_=206,q_=207,Y_=208,$_=209,J_=210,Z_=211,K_=212,j_=213,Q_=214,nu=0,iu=1,su=2,fr=3,ru=4,ou=5,au=6,lu=7,Uu=0,ex=1,tx=2,gs=0,zf=1,Vf=2,Hf=3,Gf=4,Wf=5,Xf=6,qf=7;var Yf=300,$r=301,ta=302,Ou=303,Fu=304,cu=1e3,ps=1001,uu=1002,cn=1003,nx=1004;var gl=1005;var ui=1006,Bu=1007;var Vs=1008;var _i=1009,$f=1010,Jf=1011,na=1012,ku=1013,Qi=1014,es=1015,ts=1016,zu=1017,Vu=1018,Jr=1020,Zf=35902,Kf=35899,jf=1021,Qf=1022,Ii=1023,Bs=1026,Hs=1027,ep=1028,Hu=1029,wr=1030,Gu=1031;var Wu=1033,_l=33776,xl=33777,yl=33778,vl=33779,Xu=35840,qu=35841,Yu=35842,$u=35843,Ju=36196,Zu=37492,Ku=37496,ju=37488,Qu=37489,bl=37490,eh=37491,th=37808,nh=37809,ih=37810,sh=37811,rh=37812,oh=37813,ah=37814,lh=37815,ch=37816,uh=37817,hh=37818,dh=37819,fh=37820,ph=37821,mh=36492,gh=36494,_h=36495,xh=36283,yh=36284,Sl=36285,vh=36286;var Ga=2300,hu=2301,eu=2302,Tf=2303,Ef=2400,Cf=2401,Rf=2402;var ix=3200;var bh=0,sx=1,Gs="",Bn="srgb",Wa="srgb-linear",Xa="linear",Rt="srgb";var tu=7680;var rx=519,ox=512,ax=513,lx=514,tp=515,cx=516,ux=517,np=518,ip=519,sp=35044;var rp="300 es",Bi=2e3,Ho=2001;function zS(n){for(let e=n.length-1;e>=0;--e)if(n[e]>=65535)return!0;return!1}function VS(n){return ArrayBuffer.isView(n)&&!(n instanceof DataView)}function qa(n){return document.createElementNS("http://www.w3.org/1999/xhtml",n)}function hx(){let n=qa("canvas");return n.style.display="block",n}var e_={},Go=null;function Ya(...n){let e="THREE."+n.shift();Go?Go("log",e,...n):console.log(e,...n)}function dx(n){let e=n[0];if(typeof e=="string"&&e.startsWith("TSL:")){let t=n[1];t&&t.isStackTrace?n[0]+=" "+t.getLocation():n[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return n}function $e(...n){n=dx(n);let e="THREE."+n.shift();if(Go)Go("warn",e,...n);else{let t=n[0];t&&t.isStackTrace?console.warn(t.getError(e)):console.warn(e,...n)}}function it(...n){n=dx(n);let e="THREE."+n.shift();if(Go)Go("error",e,...n);else{let t=n[0];t&&t.isStackTrace?console.error(t.getError(e)):console.error(e,...n)}}function za(...n){let e=n.join(" ");e in e_||(e_[e]=!0,$e(...n))}function fx(n,e,t){return new Promise(function(i,s){function r(){switch(n.clientWaitSync(e,n.SYNC_FLUSH_COMMANDS_BIT,0)){case n.WAIT_FAILED:s();break;case n.TIMEOUT_EXPIRED:setTimeout(r,t);break;default:i()}}setTimeout(r,t)})}var px={[nu]:nu,[su]:au,[ru]:ru,[fr]:ou,[iu]:iu,[au]:su,[lu]:lu,[ou]:fr},Ki=class{addEventListener(e,t){this._listeners===void 0&&(this._listeners={});let i=this._listeners;i[e]===void 0&&(i[e]=[]),i[e].indexOf(t)===-1&&i[e].push(t)}hasEventListener(e,t){let i=this._listeners;return i===void 0?!1:i[e]!==void 0&&i[e].indexOf(t)!==-1}removeEventListener(e,t){let i=this._listeners;if(i===void 0)return;let s=i[e];if(s!==void 0){let r=s.indexOf(t);r!==-1&&s.splice(r,1)}}dispatchEvent(e){let t=this._listeners;if(t===void 0)return;let i=t[e.type];if(i!==void 0){e.target=this;let s=i.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,e);e.target=null}}},Kn=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],t_=1234567,Va=Math.PI/180,Wo=180/Math.PI;function Ar(){let n=Math.random()*4294967295|0,e=Math.random()*4294967295|0,t=Math.random()*4294967295|0,i=Math.random()*4294967295|0;return(Kn[n&255]+Kn[n>>8&255]+Kn[n>>16&255]+Kn[n>>24&255]+"-"+Kn[e&255]+Kn[e>>8&255]+"-"+Kn[e>>16&15|64]+Kn[e>>24&255]+"-"+Kn[t&63|128]+Kn[t>>8&255]+"-"+Kn[t>>16&255]+Kn[t>>24&255]+Kn[i&255]+Kn[i>>8&255]+Kn[i>>16&255]+Kn[i>>24&255]).toLowerCase()}function lt(n,e,t){return Math.max(e,Math.min(t,n))}function op(n,e){return(n%e+e)%e}function HS(n,e,t,i,s){return i+(n-e)*(s-i)/(t-e)}function GS(n,e,t){return n!==e?(t-n)/(e-n):0}function Ha(n,e,t){return(1-t)*n+t*e}function WS(n,e,t,i){return Ha(n,e,1-Math.exp(-t*i))}function XS(n,e=1){return e-Math.abs(op(n,e*2)-e)}function qS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*(3-2*n))}function YS(n,e,t){return n<=e?0:n>=t?1:(n=(n-e)/(t-e),n*n*n*(n*(n*6-15)+10))}function $S(n,e){return n+Math.floor(Math.random()*(e-n+1))}function JS(n,e){return n+Math.random()*(e-n)}function ZS(n){return n*(.5-Math.random())}function KS(n){n!==void 0&&(t_=n);let e=t_+=1831565813;return e=Math.imul(e^e>>>15,e|1),e^=e+Math.imul(e^e>>>7,e|61),((e^e>>>14)>>>0)/4294967296}function jS(n){return n*Va}function QS(n){return n*Wo}function eM(n){return n>0&&Number.isInteger(n)&&2**Math.round(Math.log2(n))===n}function tM(n){return Math.pow(2,Math.ceil(Math.log(n)/Math.LN2))}function ap(n){return Math.pow(2,Math.floor(Math.log(n)/Math.LN2))}function nM(n,e,t,i,s){let r=Math.cos,o=Math.sin,a=r(t/2),l=o(t/2),c=r((e+i)/2),u=o((e+i)/2),f=r((e-i)/2),h=o((e-i)/2),d=r((i-e)/2),p=o((i-e)/2);switch(s){case"XYX":n.set(a*u,l*f,l*h,a*c);break;case"YZY":n.set(l*h,a*u,l*f,a*c);break;case"ZXZ":n.set(l*f,l*h,a*u,a*c);break;case"XZX":n.set(a*u,l*p,l*d,a*c);break;case"YXY":n.set(l*d,a*u,l*p,a*c);break;case"ZYZ":n.set(l*p,l*d,a*u,a*c);break;default:$e("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function Sh(n){switch(n.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function lp(n,e){if(e.constructor===Float32Array)return n;let t=Sh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(n/t,-1)}function cp(n,e){if(e.constructor===Float32Array)return n;let t=Sh(e);if(t===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(n*t)}var Ml={DEG2RAD:Va,RAD2DEG:Wo,generateUUID:Ar,clamp:lt,euclideanModulo:op,mapLinear:HS,inverseLerp:GS,lerp:Ha,damp:WS,pingpong:XS,smoothstep:qS,smootherstep:YS,randInt:$S,randFloat:JS,randFloatSpread:ZS,seededRandom:KS,degToRad:jS,radToDeg:QS,isPowerOfTwo:eM,ceilPowerOfTwo:tM,floorPowerOfTwo:ap,setQuaternionFromProperEuler:nM,normalize:cp,denormalize:lp},Ze=class{static{this.prototype.isVector2=!0}constructor(e=0,t=0){this.x=e,this.y=t}get width(){return this.x}set width(e){this.x=e}get height(){return this.y}set height(e){this.y=e}set(e,t){return this.x=e,this.y=t,this}setScalar(e){return this.x=e,this.y=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;default:throw new Error("THREE.Vector2: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y)}copy(e){return this.x=e.x,this.y=e.y,this}add(e){return this.x+=e.x,this.y+=e.y,this}addScalar(e){return this.x+=e,this.y+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this}subScalar(e){return this.x-=e,this.y-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this}multiply(e){return this.x*=e.x,this.y*=e.y,this}multiplyScalar(e){return this.x*=e,this.y*=e,this}divide(e){return this.x/=e.x,this.y/=e.y,this}divideScalar(e){return this.multiplyScalar(1/e)}applyMatrix3(e){let t=this.x,i=this.y,s=e.elements;return this.x=s[0]*t+s[3]*i+s[6],this.y=s[1]*t+s[4]*i+s[7],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this}clamp(e,t){return this.x=lt(this.x,e.x,t.x),this.y=lt(this.y,e.y,t.y),this}clampScalar(e,t){return this.x=lt(this.x,e,t),this.y=lt(this.y,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(lt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(e){return this.x*e.x+this.y*e.y}cross(e){return this.x*e.y-this.y*e.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(lt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y;return t*t+i*i}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this}equals(e){return e.x===this.x&&e.y===this.y}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this}rotateAround(e,t){let i=Math.cos(t),s=Math.sin(t),r=this.x-e.x,o=this.y-e.y;return this.x=r*i-o*s+e.x,this.y=r*s+o*i+e.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},Ci=class{constructor(e=0,t=0,i=0,s=1){this.isQuaternion=!0,this._x=e,this._y=t,this._z=i,this._w=s}static slerpFlat(e,t,i,s,r,o,a){let l=i[s+0],c=i[s+1],u=i[s+2],f=i[s+3],h=r[o+0],d=r[o+1],p=r[o+2],b=r[o+3];if(f!==b||l!==h||c!==d||u!==p){let m=l*h+c*d+u*p+f*b;m<0&&(h=-h,d=-d,p=-p,b=-b,m=-m);let g=1-a;if(m<.9995){let v=Math.acos(m),C=Math.sin(v);g=Math.sin(g*v)/C,a=Math.sin(a*v)/C,l=l*g+h*a,c=c*g+d*a,u=u*g+p*a,f=f*g+b*a}else{l=l*g+h*a,c=c*g+d*a,u=u*g+p*a,f=f*g+b*a;let v=1/Math.sqrt(l*l+c*c+u*u+f*f);l*=v,c*=v,u*=v,f*=v}}e[t]=l,e[t+1]=c,e[t+2]=u,e[t+3]=f}static multiplyQuaternionsFlat(e,t,i,s,r,o){let a=i[s],l=i[s+1],c=i[s+2],u=i[s+3],f=r[o],h=r[o+1],d=r[o+2],p=r[o+3];return e[t]=a*p+u*f+l*d-c*h,e[t+1]=l*p+u*h+c*f-a*d,e[t+2]=c*p+u*d+a*h-l*f,e[t+3]=u*p-a*f-l*h-c*d,e}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get w(){return this._w}set w(e){this._w=e,this._onChangeCallback()}set(e,t,i,s){return this._x=e,this._y=t,this._z=i,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(e){return this._x=e.x,this._y=e.y,this._z=e.z,this._w=e.w,this._onChangeCallback(),this}setFromEuler(e,t=!0){let i=e._x,s=e._y,r=e._z,o=e._order,a=Math.cos,l=Math.sin,c=a(i/2),u=a(s/2),f=a(r/2),h=l(i/2),d=l(s/2),p=l(r/2);switch(o){case"XYZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"YXZ":this._x=h*u*f+c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"ZXY":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f-h*d*p;break;case"ZYX":this._x=h*u*f-c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f+h*d*p;break;case"YZX":this._x=h*u*f+c*d*p,this._y=c*d*f+h*u*p,this._z=c*u*p-h*d*f,this._w=c*u*f-h*d*p;break;case"XZY":this._x=h*u*f-c*d*p,this._y=c*d*f-h*u*p,this._z=c*u*p+h*d*f,this._w=c*u*f+h*d*p;break;default:$e("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return t===!0&&this._onChangeCallback(),this}setFromAxisAngle(e,t){let i=t/2,s=Math.sin(i);return this._x=e.x*s,this._y=e.y*s,this._z=e.z*s,this._w=Math.cos(i),this._onChangeCallback(),this}setFromRotationMatrix(e){let t=e.elements,i=t[0],s=t[4],r=t[8],o=t[1],a=t[5],l=t[9],c=t[2],u=t[6],f=t[10],h=i+a+f;if(h>0){let d=.5/Math.sqrt(h+1);this._w=.25/d,this._x=(u-l)*d,this._y=(r-c)*d,this._z=(o-s)*d}else if(i>a&&i>f){let d=2*Math.sqrt(1+i-a-f);this._w=(u-l)/d,this._x=.25*d,this._y=(s+o)/d,this._z=(r+c)/d}else if(a>f){let d=2*Math.sqrt(1+a-i-f);this._w=(r-c)/d,this._x=(s+o)/d,this._y=.25*d,this._z=(l+u)/d}else{let d=2*Math.sqrt(1+f-i-a);this._w=(o-s)/d,this._x=(r+c)/d,this._y=(l+u)/d,this._z=.25*d}return this._onChangeCallback(),this}setFromUnitVectors(e,t){let i=e.dot(t)+1;return i<1e-8?(i=0,Math.abs(e.x)>Math.abs(e.z)?(this._x=-e.y,this._y=e.x,this._z=0,this._w=i):(this._x=0,this._y=-e.z,this._z=e.y,this._w=i)):(this._x=e.y*t.z-e.z*t.y,this._y=e.z*t.x-e.x*t.z,this._z=e.x*t.y-e.y*t.x,this._w=i),this.normalize()}angleTo(e){return 2*Math.acos(Math.abs(lt(this.dot(e),-1,1)))}rotateTowards(e,t){let i=this.angleTo(e);if(i===0)return this;let s=Math.min(1,t/i);return this.slerp(e,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(e){return this._x*e._x+this._y*e._y+this._z*e._z+this._w*e._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let e=this.length();return e===0?(this._x=0,this._y=0,this._z=0,this._w=1):(e=1/e,this._x=this._x*e,this._y=this._y*e,this._z=this._z*e,this._w=this._w*e),this._onChangeCallback(),this}multiply(e){return this.multiplyQuaternions(this,e)}premultiply(e){return this.multiplyQuaternions(e,this)}multiplyQuaternions(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=t._x,l=t._y,c=t._z,u=t._w;return this._x=i*u+o*a+s*c-r*l,this._y=s*u+o*l+r*a-i*c,this._z=r*u+o*c+i*l-s*a,this._w=o*u-i*a-s*l-r*c,this._onChangeCallback(),this}slerp(e,t){let i=e._x,s=e._y,r=e._z,o=e._w,a=this.dot(e);a<0&&(i=-i,s=-s,r=-r,o=-o,a=-a);let l=1-t;if(a<.9995){let c=Math.acos(a),u=Math.sin(c);l=Math.sin(l*c)/u,t=Math.sin(t*c)/u,this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this._onChangeCallback()}else this._x=this._x*l+i*t,this._y=this._y*l+s*t,this._z=this._z*l+r*t,this._w=this._w*l+o*t,this.normalize();return this}slerpQuaternions(e,t,i){return this.copy(e).slerp(t,i)}random(){let e=2*Math.PI*Math.random(),t=2*Math.PI*Math.random(),i=Math.random(),s=Math.sqrt(1-i),r=Math.sqrt(i);return this.set(s*Math.sin(e),s*Math.cos(e),r*Math.sin(t),r*Math.cos(t))}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._w===this._w}fromArray(e,t=0){return this._x=e[t],this._y=e[t+1],this._z=e[t+2],this._w=e[t+3],this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._w,e}fromBufferAttribute(e,t){return this._x=e.getX(t),this._y=e.getY(t),this._z=e.getZ(t),this._w=e.getW(t),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},z=class{static{this.prototype.isVector3=!0}constructor(e=0,t=0,i=0){this.x=e,this.y=t,this.z=i}set(e,t,i){return i===void 0&&(i=this.z),this.x=e,this.y=t,this.z=i,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;default:throw new Error("THREE.Vector3: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this}multiplyVectors(e,t){return this.x=e.x*t.x,this.y=e.y*t.y,this.z=e.z*t.z,this}applyEuler(e){return this.applyQuaternion(n_.setFromEuler(e))}applyAxisAngle(e,t){return this.applyQuaternion(n_.setFromAxisAngle(e,t))}applyMatrix3(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[3]*i+r[6]*s,this.y=r[1]*t+r[4]*i+r[7]*s,this.z=r[2]*t+r[5]*i+r[8]*s,this}applyNormalMatrix(e){return this.applyMatrix3(e).normalize()}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=e.elements,o=1/(r[3]*t+r[7]*i+r[11]*s+r[15]);return this.x=(r[0]*t+r[4]*i+r[8]*s+r[12])*o,this.y=(r[1]*t+r[5]*i+r[9]*s+r[13])*o,this.z=(r[2]*t+r[6]*i+r[10]*s+r[14])*o,this}applyQuaternion(e){let t=this.x,i=this.y,s=this.z,r=e.x,o=e.y,a=e.z,l=e.w,c=2*(o*s-a*i),u=2*(a*t-r*s),f=2*(r*i-o*t);return this.x=t+l*c+o*f-a*u,this.y=i+l*u+a*c-r*f,this.z=s+l*f+r*u-o*c,this}project(e){return this.applyMatrix4(e.matrixWorldInverse).applyMatrix4(e.projectionMatrix)}unproject(e){return this.applyMatrix4(e.projectionMatrixInverse).applyMatrix4(e.matrixWorld)}transformDirection(e){let t=this.x,i=this.y,s=this.z,r=e.elements;return this.x=r[0]*t+r[4]*i+r[8]*s,this.y=r[1]*t+r[5]*i+r[9]*s,this.z=r[2]*t+r[6]*i+r[10]*s,this.normalize()}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this}divideScalar(e){return this.multiplyScalar(1/e)}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this}clamp(e,t){return this.x=lt(this.x,e.x,t.x),this.y=lt(this.y,e.y,t.y),this.z=lt(this.z,e.z,t.z),this}clampScalar(e,t){return this.x=lt(this.x,e,t),this.y=lt(this.y,e,t),this.z=lt(this.z,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(lt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this}cross(e){return this.crossVectors(this,e)}crossVectors(e,t){let i=e.x,s=e.y,r=e.z,o=t.x,a=t.y,l=t.z;return this.x=s*l-r*a,this.y=r*o-i*l,this.z=i*a-s*o,this}projectOnVector(e){let t=e.lengthSq();if(t===0)return this.set(0,0,0);let i=e.dot(this)/t;return this.copy(e).multiplyScalar(i)}projectOnPlane(e){return sf.copy(this).projectOnVector(e),this.sub(sf)}reflect(e){return this.sub(sf.copy(e).multiplyScalar(2*this.dot(e)))}angleTo(e){let t=Math.sqrt(this.lengthSq()*e.lengthSq());if(t===0)return Math.PI/2;let i=this.dot(e)/t;return Math.acos(lt(i,-1,1))}distanceTo(e){return Math.sqrt(this.distanceToSquared(e))}distanceToSquared(e){let t=this.x-e.x,i=this.y-e.y,s=this.z-e.z;return t*t+i*i+s*s}manhattanDistanceTo(e){return Math.abs(this.x-e.x)+Math.abs(this.y-e.y)+Math.abs(this.z-e.z)}setFromSpherical(e){return this.setFromSphericalCoords(e.radius,e.phi,e.theta)}setFromSphericalCoords(e,t,i){let s=Math.sin(t)*e;return this.x=s*Math.sin(i),this.y=Math.cos(t)*e,this.z=s*Math.cos(i),this}setFromCylindrical(e){return this.setFromCylindricalCoords(e.radius,e.theta,e.y)}setFromCylindricalCoords(e,t,i){return this.x=e*Math.sin(t),this.y=i,this.z=e*Math.cos(t),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this}setFromMatrixScale(e){let t=this.setFromMatrixColumn(e,0).length(),i=this.setFromMatrixColumn(e,1).length(),s=this.setFromMatrixColumn(e,2).length();return this.x=t,this.y=i,this.z=s,this}setFromMatrixColumn(e,t){return this.fromArray(e.elements,t*4)}setFromMatrix3Column(e,t){return this.fromArray(e.elements,t*3)}setFromEuler(e){return this.x=e._x,this.y=e._y,this.z=e._z,this}setFromColor(e){return this.x=e.r,this.y=e.g,this.z=e.b,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let e=Math.random()*Math.PI*2,t=Math.random()*2-1,i=Math.sqrt(1-t*t);return this.x=i*Math.cos(e),this.y=t,this.z=i*Math.sin(e),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},sf=new z,n_=new Ci,st=class{static{this.prototype.isMatrix3=!0}constructor(e,t,i,s,r,o,a,l,c){this.elements=[1,0,0,0,1,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c)}set(e,t,i,s,r,o,a,l,c){let u=this.elements;return u[0]=e,u[1]=s,u[2]=a,u[3]=t,u[4]=r,u[5]=l,u[6]=i,u[7]=o,u[8]=c,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],this}extractBasis(e,t,i){return e.setFromMatrix3Column(this,0),t.setFromMatrix3Column(this,1),i.setFromMatrix3Column(this,2),this}setFromMatrix4(e){let t=e.elements;return this.set(t[0],t[4],t[8],t[1],t[5],t[9],t[2],t[6],t[10]),this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[3],l=i[6],c=i[1],u=i[4],f=i[7],h=i[2],d=i[5],p=i[8],b=s[0],m=s[3],g=s[6],v=s[1],C=s[4],M=s[7],I=s[2],E=s[5],x=s[8];return r[0]=o*b+a*v+l*I,r[3]=o*m+a*C+l*E,r[6]=o*g+a*M+l*x,r[1]=c*b+u*v+f*I,r[4]=c*m+u*C+f*E,r[7]=c*g+u*M+f*x,r[2]=h*b+d*v+p*I,r[5]=h*m+d*C+p*E,r[8]=h*g+d*M+p*x,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[3]*=e,t[6]*=e,t[1]*=e,t[4]*=e,t[7]*=e,t[2]*=e,t[5]*=e,t[8]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8];return t*o*u-t*a*c-i*r*u+i*a*l+s*r*c-s*o*l}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=u*o-a*c,h=a*l-u*r,d=c*r-o*l,p=t*f+i*h+s*d;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let b=1/p;return e[0]=f*b,e[1]=(s*c-u*i)*b,e[2]=(a*i-s*o)*b,e[3]=h*b,e[4]=(u*t-s*l)*b,e[5]=(s*r-a*t)*b,e[6]=d*b,e[7]=(i*l-c*t)*b,e[8]=(o*t-i*r)*b,this}transpose(){let e,t=this.elements;return e=t[1],t[1]=t[3],t[3]=e,e=t[2],t[2]=t[6],t[6]=e,e=t[5],t[5]=t[7],t[7]=e,this}getNormalMatrix(e){return this.setFromMatrix4(e).invert().transpose()}transposeIntoArray(e){let t=this.elements;return e[0]=t[0],e[1]=t[3],e[2]=t[6],e[3]=t[1],e[4]=t[4],e[5]=t[7],e[6]=t[2],e[7]=t[5],e[8]=t[8],this}setUvTransform(e,t,i,s,r,o,a){let l=Math.cos(r),c=Math.sin(r);return this.set(i*l,i*c,-i*(l*o+c*a)+o+e,-s*c,s*l,-s*(-c*o+l*a)+a+t,0,0,1),this}scale(e,t){return za("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(rf.makeScale(e,t)),this}rotate(e){return za("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(rf.makeRotation(-e)),this}translate(e,t){return za("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(rf.makeTranslation(e,t)),this}makeTranslation(e,t){return e.isVector2?this.set(1,0,e.x,0,1,e.y,0,0,1):this.set(1,0,e,0,1,t,0,0,1),this}makeRotation(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,i,t,0,0,0,1),this}makeScale(e,t){return this.set(e,0,0,0,t,0,0,0,1),this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<9;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<9;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e}clone(){return new this.constructor().fromArray(this.elements)}},rf=new st,i_=new st().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),s_=new st().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function iM(){let n={enabled:!0,workingColorSpace:Wa,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===Rt&&(s.r=Fs(s.r),s.g=Fs(s.g),s.b=Fs(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===Rt&&(s.r=Vo(s.r),s.g=Vo(s.g),s.b=Vo(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Gs?Xa:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},e=[.64,.33,.3,.6,.15,.06],t=[.2126,.7152,.0722],i=[.3127,.329];return n.define({[Wa]:{primaries:e,whitePoint:i,transfer:Xa,toXYZ:i_,fromXYZ:s_,luminanceCoefficients:t,workingColorSpaceConfig:{unpackColorSpace:Bn},outputColorSpaceConfig:{drawingBufferColorSpace:Bn}},[Bn]:{primaries:e,whitePoint:i,transfer:Rt,toXYZ:i_,fromXYZ:s_,luminanceCoefficients:t,outputColorSpaceConfig:{drawingBufferColorSpace:Bn}}}),n}var vt=iM();function Fs(n){return n<.04045?n*.0773993808:Math.pow(n*.9478672986+.0521327014,2.4)}function Vo(n){return n<.0031308?n*12.92:1.055*Math.pow(n,.41666)-.055}var To,du=class{static getDataURL(e,t="image/png"){if(/^data:/i.test(e.src)||typeof HTMLCanvasElement>"u")return e.src;let i;if(e instanceof HTMLCanvasElement)i=e;else{To===void 0&&(To=qa("canvas")),To.width=e.width,To.height=e.height;let s=To.getContext("2d");e instanceof ImageData?s.putImageData(e,0,0):s.drawImage(e,0,0,e.width,e.height),i=To}return i.toDataURL(t)}static sRGBToLinear(e){if(typeof HTMLImageElement<"u"&&e instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&e instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&e instanceof ImageBitmap){let t=qa("canvas");t.width=e.width,t.height=e.height;let i=t.getContext("2d");i.drawImage(e,0,0,e.width,e.height);let s=i.getImageData(0,0,e.width,e.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Fs(r[o]/255)*255;return i.putImageData(s,0,0),t}else if(e.data){let t=e.data.slice(0);for(let i=0;i<t.length;i++)t instanceof Uint8Array||t instanceof Uint8ClampedArray?t[i]=Math.floor(Fs(t[i]/255)*255):t[i]=Fs(t[i]);return{data:t,width:e.width,height:e.height}}else return $e("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),e}},sM=0,Xo=class{constructor(e=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:sM++}),this.uuid=Ar(),this.data=e,this.dataReady=!0,this.version=0}getSize(e){let t=this.data;return typeof HTMLVideoElement<"u"&&t instanceof HTMLVideoElement?e.set(t.videoWidth,t.videoHeight,0):typeof VideoFrame<"u"&&t instanceof VideoFrame?e.set(t.displayWidth,t.displayHeight,0):t!==null?e.set(t.width||0,t.height||0,t.depth||0):e.set(0,0,0),e}set needsUpdate(e){e===!0&&this.version++}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.images[this.uuid]!==void 0)return e.images[this.uuid];let i={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(of(s[o].image)):r.push(of(s[o]))}else r=of(s);i.url=r}return t||(e.images[this.uuid]=i),i}};function of(n){return typeof HTMLImageElement<"u"&&n instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&n instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&n instanceof ImageBitmap?du.getDataURL(n):n.data?{data:Array.from(n.data),width:n.width,height:n.height,type:n.data.constructor.name}:($e("Texture: Unable to serialize Texture."),{})}var rM=0,af=new z,mi=class n extends Ki{constructor(e=n.DEFAULT_IMAGE,t=n.DEFAULT_MAPPING,i=ps,s=ps,r=ui,o=Vs,a=Ii,l=_i,c=n.DEFAULT_ANISOTROPY,u=Gs){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:rM++}),this.uuid=Ar(),this.name="",this.source=new Xo(e),this.mipmaps=[],this.mapping=t,this.channel=0,this.wrapS=i,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=c,this.format=a,this.internalFormat=null,this.type=l,this.offset=new Ze(0,0),this.repeat=new Ze(1,1),this.center=new Ze(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new st,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=u,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(e&&e.depth&&e.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(af).x}get height(){return this.source.getSize(af).y}get depth(){return this.source.getSize(af).z}get image(){return this.source.data}set image(e){this.source.data=e}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(e){return this.name=e.name,this.source=e.source,this.mipmaps=e.mipmaps.slice(0),this.mapping=e.mapping,this.channel=e.channel,this.wrapS=e.wrapS,this.wrapT=e.wrapT,this.magFilter=e.magFilter,this.minFilter=e.minFilter,this.anisotropy=e.anisotropy,this.format=e.format,this.internalFormat=e.internalFormat,this.type=e.type,this.normalized=e.normalized,this.offset.copy(e.offset),this.repeat.copy(e.repeat),this.center.copy(e.center),this.rotation=e.rotation,this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrix.copy(e.matrix),this.generateMipmaps=e.generateMipmaps,this.mipmapsAutoUpdate=e.mipmapsAutoUpdate,this.premultiplyAlpha=e.premultiplyAlpha,this.flipY=e.flipY,this.unpackAlignment=e.unpackAlignment,this.colorSpace=e.colorSpace,this.renderTarget=e.renderTarget,this.isRenderTargetTexture=e.isRenderTargetTexture,this.isPMREMTexture=e.isPMREMTexture,this.isArrayTexture=e.isArrayTexture,this.userData=JSON.parse(JSON.stringify(e.userData)),this.needsUpdate=!0,this}setValues(e){for(let t in e){let i=e[t];if(i===void 0){$e(`Texture.setValues(): parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Texture.setValues(): property '${t}' does not exist.`);continue}s&&i&&s.isVector2&&i.isVector2||s&&i&&s.isVector3&&i.isVector3||s&&i&&s.isMatrix3&&i.isMatrix3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";if(!t&&e.textures[this.uuid]!==void 0)return e.textures[this.uuid];let i={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(e).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(i.userData=this.userData),t||(e.textures[this.uuid]=i),i}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(e){if(this.mapping!==Yf)return e;if(e.applyMatrix3(this.matrix),e.x<0||e.x>1)switch(this.wrapS){case cu:e.x=e.x-Math.floor(e.x);break;case ps:e.x=e.x<0?0:1;break;case uu:Math.abs(Math.floor(e.x)%2)===1?e.x=Math.ceil(e.x)-e.x:e.x=e.x-Math.floor(e.x);break}if(e.y<0||e.y>1)switch(this.wrapT){case cu:e.y=e.y-Math.floor(e.y);break;case ps:e.y=e.y<0?0:1;break;case uu:Math.abs(Math.floor(e.y)%2)===1?e.y=Math.ceil(e.y)-e.y:e.y=e.y-Math.floor(e.y);break}return this.flipY&&(e.y=1-e.y),e}set needsUpdate(e){e===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(e){e===!0&&this.pmremVersion++}};mi.DEFAULT_IMAGE=null;mi.DEFAULT_MAPPING=Yf;mi.DEFAULT_ANISOTROPY=1;var Pt=class{static{this.prototype.isVector4=!0}constructor(e=0,t=0,i=0,s=1){this.x=e,this.y=t,this.z=i,this.w=s}get width(){return this.z}set width(e){this.z=e}get height(){return this.w}set height(e){this.w=e}set(e,t,i,s){return this.x=e,this.y=t,this.z=i,this.w=s,this}setScalar(e){return this.x=e,this.y=e,this.z=e,this.w=e,this}setX(e){return this.x=e,this}setY(e){return this.y=e,this}setZ(e){return this.z=e,this}setW(e){return this.w=e,this}setComponent(e,t){switch(e){case 0:this.x=t;break;case 1:this.y=t;break;case 2:this.z=t;break;case 3:this.w=t;break;default:throw new Error("THREE.Vector4: index is out of range: "+e)}return this}getComponent(e){switch(e){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+e)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(e){return this.x=e.x,this.y=e.y,this.z=e.z,this.w=e.w!==void 0?e.w:1,this}add(e){return this.x+=e.x,this.y+=e.y,this.z+=e.z,this.w+=e.w,this}addScalar(e){return this.x+=e,this.y+=e,this.z+=e,this.w+=e,this}addVectors(e,t){return this.x=e.x+t.x,this.y=e.y+t.y,this.z=e.z+t.z,this.w=e.w+t.w,this}addScaledVector(e,t){return this.x+=e.x*t,this.y+=e.y*t,this.z+=e.z*t,this.w+=e.w*t,this}sub(e){return this.x-=e.x,this.y-=e.y,this.z-=e.z,this.w-=e.w,this}subScalar(e){return this.x-=e,this.y-=e,this.z-=e,this.w-=e,this}subVectors(e,t){return this.x=e.x-t.x,this.y=e.y-t.y,this.z=e.z-t.z,this.w=e.w-t.w,this}multiply(e){return this.x*=e.x,this.y*=e.y,this.z*=e.z,this.w*=e.w,this}multiplyScalar(e){return this.x*=e,this.y*=e,this.z*=e,this.w*=e,this}applyMatrix4(e){let t=this.x,i=this.y,s=this.z,r=this.w,o=e.elements;return this.x=o[0]*t+o[4]*i+o[8]*s+o[12]*r,this.y=o[1]*t+o[5]*i+o[9]*s+o[13]*r,this.z=o[2]*t+o[6]*i+o[10]*s+o[14]*r,this.w=o[3]*t+o[7]*i+o[11]*s+o[15]*r,this}divide(e){return this.x/=e.x,this.y/=e.y,this.z/=e.z,this.w/=e.w,this}divideScalar(e){return this.multiplyScalar(1/e)}setAxisAngleFromQuaternion(e){this.w=2*Math.acos(e.w);let t=Math.sqrt(1-e.w*e.w);return t<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=e.x/t,this.y=e.y/t,this.z=e.z/t),this}setAxisAngleFromRotationMatrix(e){let t,i,s,r,l=e.elements,c=l[0],u=l[4],f=l[8],h=l[1],d=l[5],p=l[9],b=l[2],m=l[6],g=l[10];if(Math.abs(u-h)<.01&&Math.abs(f-b)<.01&&Math.abs(p-m)<.01){if(Math.abs(u+h)<.1&&Math.abs(f+b)<.1&&Math.abs(p+m)<.1&&Math.abs(c+d+g-3)<.1)return this.set(1,0,0,0),this;t=Math.PI;let C=(c+1)/2,M=(d+1)/2,I=(g+1)/2,E=(u+h)/4,x=(f+b)/4,T=(p+m)/4;return C>M&&C>I?C<.01?(i=0,s=.707106781,r=.707106781):(i=Math.sqrt(C),s=E/i,r=x/i):M>I?M<.01?(i=.707106781,s=0,r=.707106781):(s=Math.sqrt(M),i=E/s,r=T/s):I<.01?(i=.707106781,s=.707106781,r=0):(r=Math.sqrt(I),i=x/r,s=T/r),this.set(i,s,r,t),this}let v=Math.sqrt((m-p)*(m-p)+(f-b)*(f-b)+(h-u)*(h-u));return Math.abs(v)<.001&&(v=1),this.x=(m-p)/v,this.y=(f-b)/v,this.z=(h-u)/v,this.w=Math.acos((c+d+g-1)/2),this}setFromMatrixPosition(e){let t=e.elements;return this.x=t[12],this.y=t[13],this.z=t[14],this.w=t[15],this}min(e){return this.x=Math.min(this.x,e.x),this.y=Math.min(this.y,e.y),this.z=Math.min(this.z,e.z),this.w=Math.min(this.w,e.w),this}max(e){return this.x=Math.max(this.x,e.x),this.y=Math.max(this.y,e.y),this.z=Math.max(this.z,e.z),this.w=Math.max(this.w,e.w),this}clamp(e,t){return this.x=lt(this.x,e.x,t.x),this.y=lt(this.y,e.y,t.y),this.z=lt(this.z,e.z,t.z),this.w=lt(this.w,e.w,t.w),this}clampScalar(e,t){return this.x=lt(this.x,e,t),this.y=lt(this.y,e,t),this.z=lt(this.z,e,t),this.w=lt(this.w,e,t),this}clampLength(e,t){let i=this.length();return this.divideScalar(i||1).multiplyScalar(lt(i,e,t))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(e){return this.x*e.x+this.y*e.y+this.z*e.z+this.w*e.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(e){return this.normalize().multiplyScalar(e)}lerp(e,t){return this.x+=(e.x-this.x)*t,this.y+=(e.y-this.y)*t,this.z+=(e.z-this.z)*t,this.w+=(e.w-this.w)*t,this}lerpVectors(e,t,i){return this.x=e.x+(t.x-e.x)*i,this.y=e.y+(t.y-e.y)*i,this.z=e.z+(t.z-e.z)*i,this.w=e.w+(t.w-e.w)*i,this}equals(e){return e.x===this.x&&e.y===this.y&&e.z===this.z&&e.w===this.w}fromArray(e,t=0){return this.x=e[t],this.y=e[t+1],this.z=e[t+2],this.w=e[t+3],this}toArray(e=[],t=0){return e[t]=this.x,e[t+1]=this.y,e[t+2]=this.z,e[t+3]=this.w,e}fromBufferAttribute(e,t){return this.x=e.getX(t),this.y=e.getY(t),this.z=e.getZ(t),this.w=e.getW(t),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},fu=class extends Ki{constructor(e=1,t=1,i={}){super(),i=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:ui,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},i),this.isRenderTarget=!0,this.width=e,this.height=t,this.depth=i.depth,this.scissor=new Pt(0,0,e,t),this.scissorTest=!1,this.viewport=new Pt(0,0,e,t),this.textures=[];let s=i.count;for(let r=0;r<s;r++)this.textures[r]=new mi({width:e,height:t,depth:i.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(i),this.depthBuffer=i.depthBuffer,this.stencilBuffer=i.stencilBuffer,this.resolveColorBuffer=i.resolveColorBuffer,this.resolveDepthBuffer=i.resolveDepthBuffer,this.resolveStencilBuffer=i.resolveStencilBuffer,this.storeMultisampledColorBuffer=i.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=i.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=i.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=i.depthTexture,this.samples=i.samples,this.multiview=i.multiview,this.useArrayDepthTexture=i.useArrayDepthTexture}_setTextureOptions(e={}){let t={minFilter:ui,generateMipmaps:!1,flipY:!1,internalFormat:null};e.mapping!==void 0&&(t.mapping=e.mapping),e.wrapS!==void 0&&(t.wrapS=e.wrapS),e.wrapT!==void 0&&(t.wrapT=e.wrapT),e.wrapR!==void 0&&(t.wrapR=e.wrapR),e.magFilter!==void 0&&(t.magFilter=e.magFilter),e.minFilter!==void 0&&(t.minFilter=e.minFilter),e.format!==void 0&&(t.format=e.format),e.type!==void 0&&(t.type=e.type),e.anisotropy!==void 0&&(t.anisotropy=e.anisotropy),e.colorSpace!==void 0&&(t.colorSpace=e.colorSpace),e.flipY!==void 0&&(t.flipY=e.flipY),e.generateMipmaps!==void 0&&(t.generateMipmaps=e.generateMipmaps),e.mipmapsAutoUpdate!==void 0&&(t.mipmapsAutoUpdate=e.mipmapsAutoUpdate),e.internalFormat!==void 0&&(t.internalFormat=e.internalFormat);for(let i=0;i<this.textures.length;i++)this.textures[i].setValues(t)}get texture(){return this.textures[0]}set texture(e){this.textures[0]=e}set depthTexture(e){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),e!==null&&e.renderTarget===null&&(e.renderTarget=this),this._depthTexture=e}get depthTexture(){return this._depthTexture}setSize(e,t,i=1){if(this.width!==e||this.height!==t||this.depth!==i){this.width=e,this.height=t,this.depth=i;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=e,this.textures[s].image.height=t,this.textures[s].image.depth=i,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,e,t),this.scissor.set(0,0,e,t)}clone(){return new this.constructor().copy(this)}copy(e){this.width=e.width,this.height=e.height,this.depth=e.depth,this.scissor.copy(e.scissor),this.scissorTest=e.scissorTest,this.viewport.copy(e.viewport),this.textures.length=0;for(let t=0,i=e.textures.length;t<i;t++){this.textures[t]=e.textures[t].clone(),this.textures[t].isRenderTargetTexture=!0,this.textures[t].renderTarget=this;let s=Object.assign({},e.textures[t].image);this.textures[t].source=new Xo(s)}if(this.depthBuffer=e.depthBuffer,this.stencilBuffer=e.stencilBuffer,this.resolveColorBuffer=e.resolveColorBuffer,this.resolveDepthBuffer=e.resolveDepthBuffer,this.resolveStencilBuffer=e.resolveStencilBuffer,this.storeMultisampledColorBuffer=e.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=e.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=e.storeMultisampledStencilBuffer,e.depthTexture!==null)if(e.depthTexture.renderTarget===e){let t=e.depthTexture.clone();t.renderTarget=null,this.depthTexture=t}else this.depthTexture=e.depthTexture;else this.depthTexture=null;return this.samples=e.samples,this.multiview=e.multiview,this.useArrayDepthTexture=e.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},Ri=class extends fu{constructor(e=1,t=1,i={}){super(e,t,i),this.isWebGLRenderTarget=!0}},$a=class extends mi{constructor(e=null,t=1,i=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}addLayerUpdate(e){this.layerUpdates.add(e)}clearLayerUpdates(){this.layerUpdates.clear()}};var pu=class extends mi{constructor(e=null,t=1,i=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:e,width:t,height:i,depth:s},this.magFilter=cn,this.minFilter=cn,this.wrapR=ps,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(e){return super.copy(e),this.wrapR=e.wrapR,this}};var St=class n{static{this.prototype.isMatrix4=!0}constructor(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],e!==void 0&&this.set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m)}set(e,t,i,s,r,o,a,l,c,u,f,h,d,p,b,m){let g=this.elements;return g[0]=e,g[4]=t,g[8]=i,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=l,g[2]=c,g[6]=u,g[10]=f,g[14]=h,g[3]=d,g[7]=p,g[11]=b,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new n().fromArray(this.elements)}copy(e){let t=this.elements,i=e.elements;return t[0]=i[0],t[1]=i[1],t[2]=i[2],t[3]=i[3],t[4]=i[4],t[5]=i[5],t[6]=i[6],t[7]=i[7],t[8]=i[8],t[9]=i[9],t[10]=i[10],t[11]=i[11],t[12]=i[12],t[13]=i[13],t[14]=i[14],t[15]=i[15],this}copyPosition(e){let t=this.elements,i=e.elements;return t[12]=i[12],t[13]=i[13],t[14]=i[14],this}setFromMatrix3(e){let t=e.elements;return this.set(t[0],t[3],t[6],0,t[1],t[4],t[7],0,t[2],t[5],t[8],0,0,0,0,1),this}extractBasis(e,t,i){return this.determinantAffine()===0?(e.set(1,0,0),t.set(0,1,0),i.set(0,0,1),this):(e.setFromMatrixColumn(this,0),t.setFromMatrixColumn(this,1),i.setFromMatrixColumn(this,2),this)}makeBasis(e,t,i){return this.set(e.x,t.x,i.x,0,e.y,t.y,i.y,0,e.z,t.z,i.z,0,0,0,0,1),this}extractRotation(e){if(e.determinantAffine()===0)return this.identity();let t=this.elements,i=e.elements,s=1/Eo.setFromMatrixColumn(e,0).length(),r=1/Eo.setFromMatrixColumn(e,1).length(),o=1/Eo.setFromMatrixColumn(e,2).length();return t[0]=i[0]*s,t[1]=i[1]*s,t[2]=i[2]*s,t[3]=0,t[4]=i[4]*r,t[5]=i[5]*r,t[6]=i[6]*r,t[7]=0,t[8]=i[8]*o,t[9]=i[9]*o,t[10]=i[10]*o,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromEuler(e){let t=this.elements,i=e.x,s=e.y,r=e.z,o=Math.cos(i),a=Math.sin(i),l=Math.cos(s),c=Math.sin(s),u=Math.cos(r),f=Math.sin(r);if(e.order==="XYZ"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=-l*f,t[8]=c,t[1]=d+p*c,t[5]=h-b*c,t[9]=-a*l,t[2]=b-h*c,t[6]=p+d*c,t[10]=o*l}else if(e.order==="YXZ"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h+b*a,t[4]=p*a-d,t[8]=o*c,t[1]=o*f,t[5]=o*u,t[9]=-a,t[2]=d*a-p,t[6]=b+h*a,t[10]=o*l}else if(e.order==="ZXY"){let h=l*u,d=l*f,p=c*u,b=c*f;t[0]=h-b*a,t[4]=-o*f,t[8]=p+d*a,t[1]=d+p*a,t[5]=o*u,t[9]=b-h*a,t[2]=-o*c,t[6]=a,t[10]=o*l}else if(e.order==="ZYX"){let h=o*u,d=o*f,p=a*u,b=a*f;t[0]=l*u,t[4]=p*c-d,t[8]=h*c+b,t[1]=l*f,t[5]=b*c+h,t[9]=d*c-p,t[2]=-c,t[6]=a*l,t[10]=o*l}else if(e.order==="YZX"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=b-h*f,t[8]=p*f+d,t[1]=f,t[5]=o*u,t[9]=-a*u,t[2]=-c*u,t[6]=d*f+p,t[10]=h-b*f}else if(e.order==="XZY"){let h=o*l,d=o*c,p=a*l,b=a*c;t[0]=l*u,t[4]=-f,t[8]=c*u,t[1]=h*f+b,t[5]=o*u,t[9]=d*f-p,t[2]=p*f-d,t[6]=a*u,t[10]=b*f+h}return t[3]=0,t[7]=0,t[11]=0,t[12]=0,t[13]=0,t[14]=0,t[15]=1,this}makeRotationFromQuaternion(e){return this.compose(oM,e,aM)}lookAt(e,t,i){let s=this.elements;return Ti.subVectors(e,t),Ti.lengthSq()===0&&(Ti.z=1),Ti.normalize(),ar.crossVectors(i,Ti),ar.lengthSq()===0&&(Math.abs(i.z)===1?Ti.x+=1e-4:Ti.z+=1e-4,Ti.normalize(),ar.crossVectors(i,Ti)),ar.normalize(),Rc.crossVectors(Ti,ar),s[0]=ar.x,s[4]=Rc.x,s[8]=Ti.x,s[1]=ar.y,s[5]=Rc.y,s[9]=Ti.y,s[2]=ar.z,s[6]=Rc.z,s[10]=Ti.z,this}multiply(e){return this.multiplyMatrices(this,e)}premultiply(e){return this.multiplyMatrices(e,this)}multiplyMatrices(e,t){let i=e.elements,s=t.elements,r=this.elements,o=i[0],a=i[4],l=i[8],c=i[12],u=i[1],f=i[5],h=i[9],d=i[13],p=i[2],b=i[6],m=i[10],g=i[14],v=i[3],C=i[7],M=i[11],I=i[15],E=s[0],x=s[4],T=s[8],V=s[12],U=s[1],D=s[5],H=s[9],O=s[13],L=s[2],X=s[6],$=s[10],G=s[14],ue=s[3],Z=s[7],Q=s[11],ie=s[15];return r[0]=o*E+a*U+l*L+c*ue,r[4]=o*x+a*D+l*X+c*Z,r[8]=o*T+a*H+l*$+c*Q,r[12]=o*V+a*O+l*G+c*ie,r[1]=u*E+f*U+h*L+d*ue,r[5]=u*x+f*D+h*X+d*Z,r[9]=u*T+f*H+h*$+d*Q,r[13]=u*V+f*O+h*G+d*ie,r[2]=p*E+b*U+m*L+g*ue,r[6]=p*x+b*D+m*X+g*Z,r[10]=p*T+b*H+m*$+g*Q,r[14]=p*V+b*O+m*G+g*ie,r[3]=v*E+C*U+M*L+I*ue,r[7]=v*x+C*D+M*X+I*Z,r[11]=v*T+C*H+M*$+I*Q,r[15]=v*V+C*O+M*G+I*ie,this}multiplyScalar(e){let t=this.elements;return t[0]*=e,t[4]*=e,t[8]*=e,t[12]*=e,t[1]*=e,t[5]*=e,t[9]*=e,t[13]*=e,t[2]*=e,t[6]*=e,t[10]*=e,t[14]*=e,t[3]*=e,t[7]*=e,t[11]*=e,t[15]*=e,this}determinant(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[12],o=e[1],a=e[5],l=e[9],c=e[13],u=e[2],f=e[6],h=e[10],d=e[14],p=e[3],b=e[7],m=e[11],g=e[15],v=l*d-c*h,C=a*d-c*f,M=a*h-l*f,I=o*d-c*u,E=o*h-l*u,x=o*f-a*u;return t*(b*v-m*C+g*M)-i*(p*v-m*I+g*E)+s*(p*C-b*I+g*x)-r*(p*M-b*E+m*x)}determinantAffine(){let e=this.elements,t=e[0],i=e[4],s=e[8],r=e[1],o=e[5],a=e[9],l=e[2],c=e[6],u=e[10];return t*(o*u-a*c)-i*(r*u-a*l)+s*(r*c-o*l)}transpose(){let e=this.elements,t;return t=e[1],e[1]=e[4],e[4]=t,t=e[2],e[2]=e[8],e[8]=t,t=e[6],e[6]=e[9],e[9]=t,t=e[3],e[3]=e[12],e[12]=t,t=e[7],e[7]=e[13],e[13]=t,t=e[11],e[11]=e[14],e[14]=t,this}setPosition(e,t,i){let s=this.elements;return e.isVector3?(s[12]=e.x,s[13]=e.y,s[14]=e.z):(s[12]=e,s[13]=t,s[14]=i),this}invert(){let e=this.elements,t=e[0],i=e[1],s=e[2],r=e[3],o=e[4],a=e[5],l=e[6],c=e[7],u=e[8],f=e[9],h=e[10],d=e[11],p=e[12],b=e[13],m=e[14],g=e[15],v=t*a-i*o,C=t*l-s*o,M=t*c-r*o,I=i*l-s*a,E=i*c-r*a,x=s*c-r*l,T=u*b-f*p,V=u*m-h*p,U=u*g-d*p,D=f*m-h*b,H=f*g-d*b,O=h*g-d*m,L=v*O-C*H+M*D+I*U-E*V+x*T;if(L===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let X=1/L;return e[0]=(a*O-l*H+c*D)*X,e[1]=(s*H-i*O-r*D)*X,e[2]=(b*x-m*E+g*I)*X,e[3]=(h*E-f*x-d*I)*X,e[4]=(l*U-o*O-c*V)*X,e[5]=(t*O-s*U+r*V)*X,e[6]=(m*M-p*x-g*C)*X,e[7]=(u*x-h*M+d*C)*X,e[8]=(o*H-a*U+c*T)*X,e[9]=(i*U-t*H-r*T)*X,e[10]=(p*E-b*M+g*v)*X,e[11]=(f*M-u*E-d*v)*X,e[12]=(a*V-o*D-l*T)*X,e[13]=(t*D-i*V+s*T)*X,e[14]=(b*C-p*I-m*v)*X,e[15]=(u*I-f*C+h*v)*X,this}scale(e){let t=this.elements,i=e.x,s=e.y,r=e.z;return t[0]*=i,t[4]*=s,t[8]*=r,t[1]*=i,t[5]*=s,t[9]*=r,t[2]*=i,t[6]*=s,t[10]*=r,t[3]*=i,t[7]*=s,t[11]*=r,this}getMaxScaleOnAxis(){let e=this.elements,t=e[0]*e[0]+e[1]*e[1]+e[2]*e[2],i=e[4]*e[4]+e[5]*e[5]+e[6]*e[6],s=e[8]*e[8]+e[9]*e[9]+e[10]*e[10];return Math.sqrt(Math.max(t,i,s))}makeTranslation(e,t,i){return e.isVector3?this.set(1,0,0,e.x,0,1,0,e.y,0,0,1,e.z,0,0,0,1):this.set(1,0,0,e,0,1,0,t,0,0,1,i,0,0,0,1),this}makeRotationX(e){let t=Math.cos(e),i=Math.sin(e);return this.set(1,0,0,0,0,t,-i,0,0,i,t,0,0,0,0,1),this}makeRotationY(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,0,i,0,0,1,0,0,-i,0,t,0,0,0,0,1),this}makeRotationZ(e){let t=Math.cos(e),i=Math.sin(e);return this.set(t,-i,0,0,i,t,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(e,t){let i=Math.cos(t),s=Math.sin(t),r=1-i,o=e.x,a=e.y,l=e.z,c=r*o,u=r*a;return this.set(c*o+i,c*a-s*l,c*l+s*a,0,c*a+s*l,u*a+i,u*l-s*o,0,c*l-s*a,u*l+s*o,r*l*l+i,0,0,0,0,1),this}makeScale(e,t,i){return this.set(e,0,0,0,0,t,0,0,0,0,i,0,0,0,0,1),this}makeShear(e,t,i,s,r,o){return this.set(1,i,r,0,e,1,o,0,t,s,1,0,0,0,0,1),this}compose(e,t,i){let s=this.elements,r=t._x,o=t._y,a=t._z,l=t._w,c=r+r,u=o+o,f=a+a,h=r*c,d=r*u,p=r*f,b=o*u,m=o*f,g=a*f,v=l*c,C=l*u,M=l*f,I=i.x,E=i.y,x=i.z;return s[0]=(1-(b+g))*I,s[1]=(d+M)*I,s[2]=(p-C)*I,s[3]=0,s[4]=(d-M)*E,s[5]=(1-(h+g))*E,s[6]=(m+v)*E,s[7]=0,s[8]=(p+C)*x,s[9]=(m-v)*x,s[10]=(1-(h+b))*x,s[11]=0,s[12]=e.x,s[13]=e.y,s[14]=e.z,s[15]=1,this}decompose(e,t,i){let s=this.elements;e.x=s[12],e.y=s[13],e.z=s[14];let r=this.determinantAffine();if(r===0)return i.set(1,1,1),t.identity(),this;let o=Eo.set(s[0],s[1],s[2]).length(),a=Eo.set(s[4],s[5],s[6]).length(),l=Eo.set(s[8],s[9],s[10]).length();r<0&&(o=-o),$i.copy(this);let c=1/o,u=1/a,f=1/l;return $i.elements[0]*=c,$i.elements[1]*=c,$i.elements[2]*=c,$i.elements[4]*=u,$i.elements[5]*=u,$i.elements[6]*=u,$i.elements[8]*=f,$i.elements[9]*=f,$i.elements[10]*=f,t.setFromRotationMatrix($i),i.x=o,i.y=a,i.z=l,this}makePerspective(e,t,i,s,r,o,a=Bi,l=!1){let c=this.elements,u=2*r/(t-e),f=2*r/(i-s),h=(t+e)/(t-e),d=(i+s)/(i-s),p,b;if(l)p=r/(o-r),b=o*r/(o-r);else if(a===Bi)p=-(o+r)/(o-r),b=-2*o*r/(o-r);else if(a===Ho)p=-o/(o-r),b=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=h,c[12]=0,c[1]=0,c[5]=f,c[9]=d,c[13]=0,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=-1,c[15]=0,this}makeOrthographic(e,t,i,s,r,o,a=Bi,l=!1){let c=this.elements,u=2/(t-e),f=2/(i-s),h=-(t+e)/(t-e),d=-(i+s)/(i-s),p,b;if(l)p=1/(o-r),b=o/(o-r);else if(a===Bi)p=-2/(o-r),b=-(o+r)/(o-r);else if(a===Ho)p=-1/(o-r),b=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return c[0]=u,c[4]=0,c[8]=0,c[12]=h,c[1]=0,c[5]=f,c[9]=0,c[13]=d,c[2]=0,c[6]=0,c[10]=p,c[14]=b,c[3]=0,c[7]=0,c[11]=0,c[15]=1,this}equals(e){let t=this.elements,i=e.elements;for(let s=0;s<16;s++)if(t[s]!==i[s])return!1;return!0}fromArray(e,t=0){for(let i=0;i<16;i++)this.elements[i]=e[i+t];return this}toArray(e=[],t=0){let i=this.elements;return e[t]=i[0],e[t+1]=i[1],e[t+2]=i[2],e[t+3]=i[3],e[t+4]=i[4],e[t+5]=i[5],e[t+6]=i[6],e[t+7]=i[7],e[t+8]=i[8],e[t+9]=i[9],e[t+10]=i[10],e[t+11]=i[11],e[t+12]=i[12],e[t+13]=i[13],e[t+14]=i[14],e[t+15]=i[15],e}},Eo=new z,$i=new St,oM=new z(0,0,0),aM=new z(1,1,1),ar=new z,Rc=new z,Ti=new z,r_=new St,o_=new Ci,ks=class n{constructor(e=0,t=0,i=0,s=n.DEFAULT_ORDER){this.isEuler=!0,this._x=e,this._y=t,this._z=i,this._order=s}get x(){return this._x}set x(e){this._x=e,this._onChangeCallback()}get y(){return this._y}set y(e){this._y=e,this._onChangeCallback()}get z(){return this._z}set z(e){this._z=e,this._onChangeCallback()}get order(){return this._order}set order(e){this._order=e,this._onChangeCallback()}set(e,t,i,s=this._order){return this._x=e,this._y=t,this._z=i,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(e){return this._x=e._x,this._y=e._y,this._z=e._z,this._order=e._order,this._onChangeCallback(),this}setFromRotationMatrix(e,t=this._order,i=!0){let s=e.elements,r=s[0],o=s[4],a=s[8],l=s[1],c=s[5],u=s[9],f=s[2],h=s[6],d=s[10];switch(t){case"XYZ":this._y=Math.asin(lt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-u,d),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(h,c),this._z=0);break;case"YXZ":this._x=Math.asin(-lt(u,-1,1)),Math.abs(u)<.9999999?(this._y=Math.atan2(a,d),this._z=Math.atan2(l,c)):(this._y=Math.atan2(-f,r),this._z=0);break;case"ZXY":this._x=Math.asin(lt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(-f,d),this._z=Math.atan2(-o,c)):(this._y=0,this._z=Math.atan2(l,r));break;case"ZYX":this._y=Math.asin(-lt(f,-1,1)),Math.abs(f)<.9999999?(this._x=Math.atan2(h,d),this._z=Math.atan2(l,r)):(this._x=0,this._z=Math.atan2(-o,c));break;case"YZX":this._z=Math.asin(lt(l,-1,1)),Math.abs(l)<.9999999?(this._x=Math.atan2(-u,c),this._y=Math.atan2(-f,r)):(this._x=0,this._y=Math.atan2(a,d));break;case"XZY":this._z=Math.asin(-lt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(h,c),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-u,d),this._y=0);break;default:$e("Euler: .setFromRotationMatrix() encountered an unknown order: "+t)}return this._order=t,i===!0&&this._onChangeCallback(),this}setFromQuaternion(e,t,i){return r_.makeRotationFromQuaternion(e),this.setFromRotationMatrix(r_,t,i)}setFromVector3(e,t=this._order){return this.set(e.x,e.y,e.z,t)}reorder(e){return o_.setFromEuler(this),this.setFromQuaternion(o_,e)}equals(e){return e._x===this._x&&e._y===this._y&&e._z===this._z&&e._order===this._order}fromArray(e){return this._x=e[0],this._y=e[1],this._z=e[2],e[3]!==void 0&&(this._order=e[3]),this._onChangeCallback(),this}toArray(e=[],t=0){return e[t]=this._x,e[t+1]=this._y,e[t+2]=this._z,e[t+3]=this._order,e}_onChange(e){return this._onChangeCallback=e,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};ks.DEFAULT_ORDER="XYZ";var Ja=class{constructor(){this.mask=1}set(e){this.mask=(1<<e|0)>>>0}enable(e){this.mask|=1<<e|0}enableAll(){this.mask=-1}toggle(e){this.mask^=1<<e|0}disable(e){this.mask&=~(1<<e|0)}disableAll(){this.mask=0}test(e){return(this.mask&e.mask)!==0}isEnabled(e){return(this.mask&(1<<e|0))!==0}},lM=0,a_=new z,Co=new Ci,Ls=new St,Pc=new z,Ua=new z,cM=new z,uM=new Ci,l_=new z(1,0,0),c_=new z(0,1,0),u_=new z(0,0,1),h_={type:"added"},hM={type:"removed"},Ro={type:"childadded",child:null},lf={type:"childremoved",child:null},zn=class n extends Ki{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:lM++}),this.uuid=Ar(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=n.DEFAULT_UP.clone();let e=new z,t=new ks,i=new Ci,s=new z(1,1,1);function r(){i.setFromEuler(t,!1)}function o(){t.setFromQuaternion(i,void 0,!1)}t._onChange(r),i._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:e},rotation:{configurable:!0,enumerable:!0,value:t},quaternion:{configurable:!0,enumerable:!0,value:i},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new St},normalMatrix:{value:new st}}),this.matrix=new St,this.matrixWorld=new St,this.matrixAutoUpdate=n.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=n.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new Ja,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(e){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(e),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(e){return this.quaternion.premultiply(e),this}setRotationFromAxisAngle(e,t){this.quaternion.setFromAxisAngle(e,t)}setRotationFromEuler(e){this.quaternion.setFromEuler(e,!0)}setRotationFromMatrix(e){this.quaternion.setFromRotationMatrix(e)}setRotationFromQuaternion(e){this.quaternion.copy(e)}rotateOnAxis(e,t){return Co.setFromAxisAngle(e,t),this.quaternion.multiply(Co),this}rotateOnWorldAxis(e,t){return Co.setFromAxisAngle(e,t),this.quaternion.premultiply(Co),this}rotateX(e){return this.rotateOnAxis(l_,e)}rotateY(e){return this.rotateOnAxis(c_,e)}rotateZ(e){return this.rotateOnAxis(u_,e)}translateOnAxis(e,t){return a_.copy(e).applyQuaternion(this.quaternion),this.position.add(a_.multiplyScalar(t)),this}translateX(e){return this.translateOnAxis(l_,e)}translateY(e){return this.translateOnAxis(c_,e)}translateZ(e){return this.translateOnAxis(u_,e)}localToWorld(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(this.matrixWorld)}worldToLocal(e){return this.updateWorldMatrix(!0,!1),e.applyMatrix4(Ls.copy(this.matrixWorld).invert())}lookAt(e,t,i){e.isVector3?Pc.copy(e):Pc.set(e,t,i);let s=this.parent;this.updateWorldMatrix(!0,!1),Ua.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Ls.lookAt(Ua,Pc,this.up):Ls.lookAt(Pc,Ua,this.up),this.quaternion.setFromRotationMatrix(Ls),s&&(Ls.extractRotation(s.matrixWorld),Co.setFromRotationMatrix(Ls),this.quaternion.premultiply(Co.invert()))}add(e){if(arguments.length>1){for(let t=0;t<arguments.length;t++)this.add(arguments[t]);return this}return e===this?(it("Object3D.add: object can't be added as a child of itself.",e),this):(e&&e.isObject3D?(e.removeFromParent(),e.parent=this,this.children.push(e),e.dispatchEvent(h_),Ro.child=e,this.dispatchEvent(Ro),Ro.child=null):it("Object3D.add: object not an instance of THREE.Object3D.",e),this)}remove(e){if(arguments.length>1){for(let i=0;i<arguments.length;i++)this.remove(arguments[i]);return this}let t=this.children.indexOf(e);return t!==-1&&(e.parent=null,this.children.splice(t,1),e.dispatchEvent(hM),lf.child=e,this.dispatchEvent(lf),lf.child=null),this}removeFromParent(){let e=this.parent;return e!==null&&e.remove(this),this}clear(){return this.remove(...this.children)}attach(e){return this.updateWorldMatrix(!0,!1),Ls.copy(this.matrixWorld).invert(),e.parent!==null&&(e.parent.updateWorldMatrix(!0,!1),Ls.multiply(e.parent.matrixWorld)),e.applyMatrix4(Ls),e.removeFromParent(),e.parent=this,this.children.push(e),e.updateWorldMatrix(!1,!0),e.dispatchEvent(h_),Ro.child=e,this.dispatchEvent(Ro),Ro.child=null,this}getObjectById(e){return this.getObjectByProperty("id",e)}getObjectByName(e){return this.getObjectByProperty("name",e)}getObjectByProperty(e,t){if(this[e]===t)return this;for(let i=0,s=this.children.length;i<s;i++){let o=this.children[i].getObjectByProperty(e,t);if(o!==void 0)return o}}getObjectsByProperty(e,t,i=[]){this[e]===t&&i.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(e,t,i);return i}getWorldPosition(e){return this.updateWorldMatrix(!0,!1),e.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,e,cM),e}getWorldScale(e){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Ua,uM,e),e}getWorldDirection(e){this.updateWorldMatrix(!0,!1);let t=this.matrixWorld.elements;return e.set(t[8],t[9],t[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(e){e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverse(e)}traverseVisible(e){if(this.visible===!1)return;e(this);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].traverseVisible(e)}traverseAncestors(e){let t=this.parent;t!==null&&(e(t),t.traverseAncestors(e))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let e=this.pivot;if(e!==null){let t=e.x,i=e.y,s=e.z,r=this.matrix.elements;r[12]+=t-r[0]*t-r[4]*i-r[8]*s,r[13]+=i-r[1]*t-r[5]*i-r[9]*s,r[14]+=s-r[2]*t-r[6]*i-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(e){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||e)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,e=!0);let t=this.children;for(let i=0,s=t.length;i<s;i++)t[i].updateMatrixWorld(e)}updateWorldMatrix(e,t,i=!1){let s=this.parent;if(e===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||i)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,i=!0),t===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,i)}}toJSON(e){let t=e===void 0||typeof e=="string",i={};t&&(e={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},i.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(e),s.indirectTexture=this._indirectTexture.toJSON(e),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(e)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,l){return a[l.uuid]===void 0&&(a[l.uuid]=l.toJSON(e)),l.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(e).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(e).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(e.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let l=a.shapes;if(Array.isArray(l))for(let c=0,u=l.length;c<u;c++){let f=l[c];r(e.shapes,f)}else r(e.shapes,l)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(e.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let l=0,c=this.material.length;l<c;l++)a.push(r(e.materials,this.material[l]));s.material=a}else s.material=r(e.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(e).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let l=this.animations[a];s.animations.push(r(e.animations,l))}}if(t){let a=o(e.geometries),l=o(e.materials),c=o(e.textures),u=o(e.images),f=o(e.shapes),h=o(e.skeletons),d=o(e.animations),p=o(e.nodes);a.length>0&&(i.geometries=a),l.length>0&&(i.materials=l),c.length>0&&(i.textures=c),u.length>0&&(i.images=u),f.length>0&&(i.shapes=f),h.length>0&&(i.skeletons=h),d.length>0&&(i.animations=d),p.length>0&&(i.nodes=p)}return i.object=s,i;function o(a){let l=[];for(let c in a){let u=a[c];delete u.metadata,l.push(u)}return l}}clone(e){return new this.constructor().copy(this,e)}copy(e,t=!0){if(this.name=e.name,this.up.copy(e.up),this.position.copy(e.position),this.rotation.order=e.rotation.order,this.quaternion.copy(e.quaternion),this.scale.copy(e.scale),this.pivot=e.pivot!==null?e.pivot.clone():null,this.matrix.copy(e.matrix),this.matrixWorld.copy(e.matrixWorld),this.matrixAutoUpdate=e.matrixAutoUpdate,this.matrixWorldAutoUpdate=e.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=e.matrixWorldNeedsUpdate,this.layers.mask=e.layers.mask,this.visible=e.visible,this.castShadow=e.castShadow,this.receiveShadow=e.receiveShadow,this.frustumCulled=e.frustumCulled,this.renderOrder=e.renderOrder,this.static=e.static,this.animations=e.animations.slice(),this.userData=JSON.parse(JSON.stringify(e.userData)),t===!0)for(let i=0;i<e.children.length;i++){let s=e.children[i];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};zn.DEFAULT_UP=new z(0,1,0);zn.DEFAULT_MATRIX_AUTO_UPDATE=!0;zn.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var pi=class extends zn{constructor(){super(),this.isGroup=!0,this.type="Group"}},dM={type:"move"},qo=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new pi,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new pi,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new z,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new z),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new pi,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new z,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new z,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(e){return this._targetRay!==null&&this._targetRay.dispatchEvent(e),this._grip!==null&&this._grip.dispatchEvent(e),this._hand!==null&&this._hand.dispatchEvent(e),this}connect(e){if(e&&e.hand){let t=this._hand;if(t)for(let i of e.hand.values())this._getHandJoint(t,i)}return this.dispatchEvent({type:"connected",data:e}),this}disconnect(e){return this.dispatchEvent({type:"disconnected",data:e}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(e,t,i){let s=null,r=null,o=null,a=this._targetRay,l=this._grip,c=this._hand;if(e&&t.session.visibilityState!=="visible-blurred"){if(c&&e.hand){o=!0;for(let b of e.hand.values()){let m=t.getJointPose(b,i),g=this._getHandJoint(c,b);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let u=c.joints["index-finger-tip"],f=c.joints["thumb-tip"],h=u.position.distanceTo(f.position),d=.02,p=.005;c.inputState.pinching&&h>d+p?(c.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:e.handedness,target:this})):!c.inputState.pinching&&h<=d-p&&(c.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:e.handedness,target:this}))}else l!==null&&e.gripSpace&&(r=t.getPose(e.gripSpace,i),r!==null&&(l.matrix.fromArray(r.transform.matrix),l.matrix.decompose(l.position,l.quaternion,l.scale),l.matrixWorldNeedsUpdate=!0,r.linearVelocity?(l.hasLinearVelocity=!0,l.linearVelocity.copy(r.linearVelocity)):l.hasLinearVelocity=!1,r.angularVelocity?(l.hasAngularVelocity=!0,l.angularVelocity.copy(r.angularVelocity)):l.hasAngularVelocity=!1,l.eventsEnabled&&l.dispatchEvent({type:"gripUpdated",data:e,target:this})));a!==null&&(s=t.getPose(e.targetRaySpace,i),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(dM)))}return a!==null&&(a.visible=s!==null),l!==null&&(l.visible=r!==null),c!==null&&(c.visible=o!==null),this}_getHandJoint(e,t){if(e.joints[t.jointName]===void 0){let i=new pi;i.matrixAutoUpdate=!1,i.visible=!1,e.joints[t.jointName]=i,e.add(i)}return e.joints[t.jointName]}},mx={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},lr={h:0,s:0,l:0},Ic={h:0,s:0,l:0};function cf(n,e,t){return t<0&&(t+=1),t>1&&(t-=1),t<1/6?n+(e-n)*6*t:t<1/2?e:t<2/3?n+(e-n)*6*(2/3-t):n}var ut=class{constructor(e,t,i){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(e,t,i)}set(e,t,i){if(t===void 0&&i===void 0){let s=e;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(e,t,i);return this}setScalar(e){return this.r=e,this.g=e,this.b=e,this}setHex(e,t=Bn){return e=Math.floor(e),this.r=(e>>16&255)/255,this.g=(e>>8&255)/255,this.b=(e&255)/255,vt.colorSpaceToWorking(this,t),this}setRGB(e,t,i,s=vt.workingColorSpace){return this.r=e,this.g=t,this.b=i,vt.colorSpaceToWorking(this,s),this}setHSL(e,t,i,s=vt.workingColorSpace){if(e=op(e,1),t=lt(t,0,1),i=lt(i,0,1),t===0)this.r=this.g=this.b=i;else{let r=i<=.5?i*(1+t):i+t-i*t,o=2*i-r;this.r=cf(o,r,e+1/3),this.g=cf(o,r,e),this.b=cf(o,r,e-1/3)}return vt.colorSpaceToWorking(this,s),this}setStyle(e,t=Bn){function i(r){r!==void 0&&parseFloat(r)<1&&$e("Color: Alpha component of "+e+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(e)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,t);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,t);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return i(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,t);break;default:$e("Color: Unknown color model "+e)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(e)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,t);if(o===6)return this.setHex(parseInt(r,16),t);$e("Color: Invalid hex color "+e)}else if(e&&e.length>0)return this.setColorName(e,t);return this}setColorName(e,t=Bn){let i=mx[e.toLowerCase()];return i!==void 0?this.setHex(i,t):$e("Color: Unknown color "+e),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(e){return this.r=e.r,this.g=e.g,this.b=e.b,this}copySRGBToLinear(e){return this.r=Fs(e.r),this.g=Fs(e.g),this.b=Fs(e.b),this}copyLinearToSRGB(e){return this.r=Vo(e.r),this.g=Vo(e.g),this.b=Vo(e.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(e=Bn){return vt.workingToColorSpace(jn.copy(this),e),Math.round(lt(jn.r*255,0,255))*65536+Math.round(lt(jn.g*255,0,255))*256+Math.round(lt(jn.b*255,0,255))}getHexString(e=Bn){return("000000"+this.getHex(e).toString(16)).slice(-6)}getHSL(e,t=vt.workingColorSpace){vt.workingToColorSpace(jn.copy(this),t);let i=jn.r,s=jn.g,r=jn.b,o=Math.max(i,s,r),a=Math.min(i,s,r),l,c,u=(a+o)/2;if(a===o)l=0,c=0;else{let f=o-a;switch(c=u<=.5?f/(o+a):f/(2-o-a),o){case i:l=(s-r)/f+(s<r?6:0);break;case s:l=(r-i)/f+2;break;case r:l=(i-s)/f+4;break}l/=6}return e.h=l,e.s=c,e.l=u,e}getRGB(e,t=vt.workingColorSpace){return vt.workingToColorSpace(jn.copy(this),t),e.r=jn.r,e.g=jn.g,e.b=jn.b,e}getStyle(e=Bn){vt.workingToColorSpace(jn.copy(this),e);let t=jn.r,i=jn.g,s=jn.b;return e!==Bn?`color(${e} ${t.toFixed(3)} ${i.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(t*255)},${Math.round(i*255)},${Math.round(s*255)})`}offsetHSL(e,t,i){return this.getHSL(lr),this.setHSL(lr.h+e,lr.s+t,lr.l+i)}add(e){return this.r+=e.r,this.g+=e.g,this.b+=e.b,this}addColors(e,t){return this.r=e.r+t.r,this.g=e.g+t.g,this.b=e.b+t.b,this}addScalar(e){return this.r+=e,this.g+=e,this.b+=e,this}sub(e){return this.r=Math.max(0,this.r-e.r),this.g=Math.max(0,this.g-e.g),this.b=Math.max(0,this.b-e.b),this}multiply(e){return this.r*=e.r,this.g*=e.g,this.b*=e.b,this}multiplyScalar(e){return this.r*=e,this.g*=e,this.b*=e,this}lerp(e,t){return this.r+=(e.r-this.r)*t,this.g+=(e.g-this.g)*t,this.b+=(e.b-this.b)*t,this}lerpColors(e,t,i){return this.r=e.r+(t.r-e.r)*i,this.g=e.g+(t.g-e.g)*i,this.b=e.b+(t.b-e.b)*i,this}lerpHSL(e,t){this.getHSL(lr),e.getHSL(Ic);let i=Ha(lr.h,Ic.h,t),s=Ha(lr.s,Ic.s,t),r=Ha(lr.l,Ic.l,t);return this.setHSL(i,s,r),this}setFromVector3(e){return this.r=e.x,this.g=e.y,this.b=e.z,this}applyMatrix3(e){let t=this.r,i=this.g,s=this.b,r=e.elements;return this.r=r[0]*t+r[3]*i+r[6]*s,this.g=r[1]*t+r[4]*i+r[7]*s,this.b=r[2]*t+r[5]*i+r[8]*s,this}equals(e){return e.r===this.r&&e.g===this.g&&e.b===this.b}fromArray(e,t=0){return this.r=e[t],this.g=e[t+1],this.b=e[t+2],this}toArray(e=[],t=0){return e[t]=this.r,e[t+1]=this.g,e[t+2]=this.b,e}fromBufferAttribute(e,t){return this.r=e.getX(t),this.g=e.getY(t),this.b=e.getZ(t),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},jn=new ut;ut.NAMES=mx;var Za=class extends zn{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new ks,this.environmentIntensity=1,this.environmentRotation=new ks,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(e,t){return super.copy(e,t),this.background=e.background!==null?e.background.clone():null,this.environment=e.environment!==null?e.environment.clone():null,this.fog=e.fog!==null?e.fog.clone():null,this.backgroundBlurriness=e.backgroundBlurriness,this.backgroundIntensity=e.backgroundIntensity,this.backgroundRotation.copy(e.backgroundRotation),this.environmentIntensity=e.environmentIntensity,this.environmentRotation.copy(e.environmentRotation),this.overrideMaterial=e.overrideMaterial!==null?e.overrideMaterial.clone():null,this.matrixAutoUpdate=e.matrixAutoUpdate,this}toJSON(e){let t=super.toJSON(e);return this.fog!==null&&(t.object.fog=this.fog.toJSON()),t.object.backgroundBlurriness=this.backgroundBlurriness,t.object.backgroundIntensity=this.backgroundIntensity,t.object.backgroundRotation=this.backgroundRotation.toArray(),t.object.environmentIntensity=this.environmentIntensity,t.object.environmentRotation=this.environmentRotation.toArray(),t}},Ji=new z,Ds=new z,uf=new z,Ns=new z,Po=new z,Io=new z,d_=new z,hf=new z,df=new z,ff=new z,pf=new Pt,mf=new Pt,gf=new Pt,dr=class n{constructor(e=new z,t=new z,i=new z){this.a=e,this.b=t,this.c=i}static getNormal(e,t,i,s){s.subVectors(i,t),Ji.subVectors(e,t),s.cross(Ji);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(e,t,i,s,r){Ji.subVectors(s,t),Ds.subVectors(i,t),uf.subVectors(e,t);let o=Ji.dot(Ji),a=Ji.dot(Ds),l=Ji.dot(uf),c=Ds.dot(Ds),u=Ds.dot(uf),f=o*c-a*a;if(f===0)return r.set(0,0,0),null;let h=1/f,d=(c*l-a*u)*h,p=(o*u-a*l)*h;return r.set(1-d-p,p,d)}static containsPoint(e,t,i,s){return this.getBarycoord(e,t,i,s,Ns)===null?!1:Ns.x>=0&&Ns.y>=0&&Ns.x+Ns.y<=1}static getInterpolation(e,t,i,s,r,o,a,l){return this.getBarycoord(e,t,i,s,Ns)===null?(l.x=0,l.y=0,"z"in l&&(l.z=0),"w"in l&&(l.w=0),null):(l.setScalar(0),l.addScaledVector(r,Ns.x),l.addScaledVector(o,Ns.y),l.addScaledVector(a,Ns.z),l)}static getInterpolatedAttribute(e,t,i,s,r,o){return pf.setScalar(0),mf.setScalar(0),gf.setScalar(0),pf.fromBufferAttribute(e,t),mf.fromBufferAttribute(e,i),gf.fromBufferAttribute(e,s),o.setScalar(0),o.addScaledVector(pf,r.x),o.addScaledVector(mf,r.y),o.addScaledVector(gf,r.z),o}static isFrontFacing(e,t,i,s){return Ji.subVectors(i,t),Ds.subVectors(e,t),Ji.cross(Ds).dot(s)<0}set(e,t,i){return this.a.copy(e),this.b.copy(t),this.c.copy(i),this}setFromPointsAndIndices(e,t,i,s){return this.a.copy(e[t]),this.b.copy(e[i]),this.c.copy(e[s]),this}setFromAttributeAndIndices(e,t,i,s){return this.a.fromBufferAttribute(e,t),this.b.fromBufferAttribute(e,i),this.c.fromBufferAttribute(e,s),this}clone(){return new this.constructor().copy(this)}copy(e){return this.a.copy(e.a),this.b.copy(e.b),this.c.copy(e.c),this}getArea(){return Ji.subVectors(this.c,this.b),Ds.subVectors(this.a,this.b),Ji.cross(Ds).length()*.5}getMidpoint(e){return e.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(e){return n.getNormal(this.a,this.b,this.c,e)}getPlane(e){return e.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(e,t){return n.getBarycoord(e,this.a,this.b,this.c,t)}getInterpolation(e,t,i,s,r){return n.getInterpolation(e,this.a,this.b,this.c,t,i,s,r)}containsPoint(e){return n.containsPoint(e,this.a,this.b,this.c)}isFrontFacing(e){return n.isFrontFacing(this.a,this.b,this.c,e)}intersectsBox(e){return e.intersectsTriangle(this)}closestPointToPoint(e,t){let i=this.a,s=this.b,r=this.c,o,a;Po.subVectors(s,i),Io.subVectors(r,i),hf.subVectors(e,i);let l=Po.dot(hf),c=Io.dot(hf);if(l<=0&&c<=0)return t.copy(i);df.subVectors(e,s);let u=Po.dot(df),f=Io.dot(df);if(u>=0&&f<=u)return t.copy(s);let h=l*f-u*c;if(h<=0&&l>=0&&u<=0&&l-u>0)return o=l/(l-u),t.copy(i).addScaledVector(Po,o);ff.subVectors(e,r);let d=Po.dot(ff),p=Io.dot(ff);if(p>=0&&d<=p)return t.copy(r);let b=d*c-l*p;if(b<=0&&c>=0&&p<=0)return a=c/(c-p),t.copy(i).addScaledVector(Io,a);let m=u*p-d*f;if(m<=0&&f-u>=0&&d-p>=0)return d_.subVectors(r,s),a=(f-u)/(f-u+(d-p)),t.copy(s).addScaledVector(d_,a);let g=1/(m+b+h);return o=b*g,a=h*g,t.copy(i).addScaledVector(Po,o).addScaledVector(Io,a)}equals(e){return e.a.equals(this.a)&&e.b.equals(this.b)&&e.c.equals(this.c)}},Qn=class{constructor(e=new z(1/0,1/0,1/0),t=new z(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=e,this.max=t}set(e,t){return this.min.copy(e),this.max.copy(t),this}setFromArray(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t+=3)this.expandByPoint(Zi.fromArray(e,t));return this}setFromBufferAttribute(e){this.makeEmpty();for(let t=0,i=e.count;t<i;t++)this.expandByPoint(Zi.fromBufferAttribute(e,t));return this}setFromPoints(e){this.makeEmpty();for(let t=0,i=e.length;t<i;t++)this.expandByPoint(e[t]);return this}setFromCenterAndSize(e,t){let i=Zi.copy(t).multiplyScalar(.5);return this.min.copy(e).sub(i),this.max.copy(e).add(i),this}setFromObject(e,t=!1){return this.makeEmpty(),this.expandByObject(e,t)}clone(){return new this.constructor().copy(this)}copy(e){return this.min.copy(e.min),this.max.copy(e.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(e){return this.isEmpty()?e.set(0,0,0):e.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(e){return this.isEmpty()?e.set(0,0,0):e.subVectors(this.max,this.min)}expandByPoint(e){return this.min.min(e),this.max.max(e),this}expandByVector(e){return this.min.sub(e),this.max.add(e),this}expandByScalar(e){return this.min.addScalar(-e),this.max.addScalar(e),this}expandByObject(e,t=!1){e.updateWorldMatrix(!1,!1);let i=e.geometry;if(i!==void 0){let r=i.getAttribute("position");if(t===!0&&r!==void 0&&e.isInstancedMesh!==!0&&e.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)e.isMesh===!0?e.getVertexPosition(o,Zi):Zi.fromBufferAttribute(r,o),Zi.applyMatrix4(e.matrixWorld),this.expandByPoint(Zi);else e.boundingBox!==void 0?(e.boundingBox===null&&e.computeBoundingBox(),Lc.copy(e.boundingBox)):(i.boundingBox===null&&i.computeBoundingBox(),Lc.copy(i.boundingBox)),Lc.applyMatrix4(e.matrixWorld),this.union(Lc)}let s=e.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],t);return this}containsPoint(e){return e.x>=this.min.x&&e.x<=this.max.x&&e.y>=this.min.y&&e.y<=this.max.y&&e.z>=this.min.z&&e.z<=this.max.z}containsBox(e){return this.min.x<=e.min.x&&e.max.x<=this.max.x&&this.min.y<=e.min.y&&e.max.y<=this.max.y&&this.min.z<=e.min.z&&e.max.z<=this.max.z}getParameter(e,t){return t.set((e.x-this.min.x)/(this.max.x-this.min.x),(e.y-this.min.y)/(this.max.y-this.min.y),(e.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(e){return e.max.x>=this.min.x&&e.min.x<=this.max.x&&e.max.y>=this.min.y&&e.min.y<=this.max.y&&e.max.z>=this.min.z&&e.min.z<=this.max.z}intersectsSphere(e){return this.clampPoint(e.center,Zi),Zi.distanceToSquared(e.center)<=e.radius*e.radius}intersectsPlane(e){let t,i;return e.normal.x>0?(t=e.normal.x*this.min.x,i=e.normal.x*this.max.x):(t=e.normal.x*this.max.x,i=e.normal.x*this.min.x),e.normal.y>0?(t+=e.normal.y*this.min.y,i+=e.normal.y*this.max.y):(t+=e.normal.y*this.max.y,i+=e.normal.y*this.min.y),e.normal.z>0?(t+=e.normal.z*this.min.z,i+=e.normal.z*this.max.z):(t+=e.normal.z*this.max.z,i+=e.normal.z*this.min.z),t<=-e.constant&&i>=-e.constant}intersectsTriangle(e){if(this.isEmpty())return!1;this.getCenter(Oa),Dc.subVectors(this.max,Oa),Lo.subVectors(e.a,Oa),Do.subVectors(e.b,Oa),No.subVectors(e.c,Oa),cr.subVectors(Do,Lo),ur.subVectors(No,Do),Vr.subVectors(Lo,No);let t=[0,-cr.z,cr.y,0,-ur.z,ur.y,0,-Vr.z,Vr.y,cr.z,0,-cr.x,ur.z,0,-ur.x,Vr.z,0,-Vr.x,-cr.y,cr.x,0,-ur.y,ur.x,0,-Vr.y,Vr.x,0];return!_f(t,Lo,Do,No,Dc)||(t=[1,0,0,0,1,0,0,0,1],!_f(t,Lo,Do,No,Dc))?!1:(Nc.crossVectors(cr,ur),t=[Nc.x,Nc.y,Nc.z],_f(t,Lo,Do,No,Dc))}clampPoint(e,t){return t.copy(e).clamp(this.min,this.max)}distanceToPoint(e){return this.clampPoint(e,Zi).distanceTo(e)}getBoundingSphere(e){return this.isEmpty()?e.makeEmpty():(this.getCenter(e.center),e.radius=this.getSize(Zi).length()*.5),e}intersect(e){return this.min.max(e.min),this.max.min(e.max),this.isEmpty()&&this.makeEmpty(),this}union(e){return this.min.min(e.min),this.max.max(e.max),this}applyMatrix4(e){return this.isEmpty()?this:(Us[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(e),Us[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(e),Us[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(e),Us[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(e),Us[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(e),Us[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(e),Us[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(e),Us[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(e),this.setFromPoints(Us),this)}translate(e){return this.min.add(e),this.max.add(e),this}equals(e){return e.min.equals(this.min)&&e.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(e){return this.min.fromArray(e.min),this.max.fromArray(e.max),this}},Us=[new z,new z,new z,new z,new z,new z,new z,new z],Zi=new z,Lc=new Qn,Lo=new z,Do=new z,No=new z,cr=new z,ur=new z,Vr=new z,Oa=new z,Dc=new z,Nc=new z,Hr=new z;function _f(n,e,t,i,s){for(let r=0,o=n.length-3;r<=o;r+=3){Hr.fromArray(n,r);let a=s.x*Math.abs(Hr.x)+s.y*Math.abs(Hr.y)+s.z*Math.abs(Hr.z),l=e.dot(Hr),c=t.dot(Hr),u=i.dot(Hr);if(Math.max(-Math.max(l,c,u),Math.min(l,c,u))>a)return!1}return!0}var xn=new z,Uc=new Ze,fM=0,yn=class extends Ki{constructor(e,t,i=!1){if(super(),Array.isArray(e))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:fM++}),this.name="",this.array=e,this.itemSize=t,this.count=e!==void 0?e.length/t:0,this.normalized=i,this.usage=sp,this.updateRanges=[],this.gpuType=es,this.version=0,this._normalizationScale=e!==void 0?Sh(e):void 0}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.name=e.name,this.array=new e.array.constructor(e.array),this.itemSize=e.itemSize,this.count=e.count,this.normalized=e.normalized,this.usage=e.usage,this.gpuType=e.gpuType,this._normalizationScale=e._normalizationScale,this}copyAt(e,t,i){e*=this.itemSize,i*=t.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[e+s]=t.array[i+s];return this}copyArray(e){return this.array.set(e),this}applyMatrix3(e){if(this.itemSize===2)for(let t=0,i=this.count;t<i;t++)Uc.fromBufferAttribute(this,t),Uc.applyMatrix3(e),this.setXY(t,Uc.x,Uc.y);else if(this.itemSize===3)for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix3(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyMatrix4(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyMatrix4(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.applyNormalMatrix(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)xn.fromBufferAttribute(this,t),xn.transformDirection(e),this.setXYZ(t,xn.x,xn.y,xn.z);return this}set(e,t=0){return this.array.set(e,t),this}getComponent(e,t){let i=this.array[e*this.itemSize+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.array[e*this.itemSize+t]=i,this}getX(e){let t=this.array[e*this.itemSize];return this.normalized&&(t=this._denormalize(t)),t}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize]=t,this}getY(e){let t=this.array[e*this.itemSize+1];return this.normalized&&(t=this._denormalize(t)),t}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+1]=t,this}getZ(e){let t=this.array[e*this.itemSize+2];return this.normalized&&(t=this._denormalize(t)),t}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+2]=t,this}getW(e){let t=this.array[e*this.itemSize+3];return this.normalized&&(t=this._denormalize(t)),t}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.array[e*this.itemSize+3]=t,this}setXY(e,t,i){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.array[e+0]=t,this.array[e+1]=i,this}setXYZ(e,t,i,s){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e*=this.itemSize,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.array[e+0]=t,this.array[e+1]=i,this.array[e+2]=s,this.array[e+3]=r,this}onUpload(e){return this.onUploadCallback=e,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let e={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return e.name=this.name,e.usage=this.usage,e.gpuType=this.gpuType,e}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):lp(e,this.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):cp(e,this.array)}};var Ka=class extends yn{constructor(e,t,i){super(new Uint16Array(e),t,i)}};var ja=class extends yn{constructor(e,t,i){super(new Uint32Array(e),t,i)}};var kn=class extends yn{constructor(e,t,i){super(new Float32Array(e),t,i)}},pM=new Qn,Fa=new z,xf=new z,Vn=class{constructor(e=new z,t=-1){this.isSphere=!0,this.center=e,this.radius=t}set(e,t){return this.center.copy(e),this.radius=t,this}setFromPoints(e,t){let i=this.center;t!==void 0?i.copy(t):pM.setFromPoints(e).getCenter(i);let s=0;for(let r=0,o=e.length;r<o;r++)s=Math.max(s,i.distanceToSquared(e[r]));return this.radius=Math.sqrt(s),this}copy(e){return this.center.copy(e.center),this.radius=e.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(e){return e.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(e){return e.distanceTo(this.center)-this.radius}intersectsSphere(e){let t=this.radius+e.radius;return e.center.distanceToSquared(this.center)<=t*t}intersectsBox(e){return e.intersectsSphere(this)}intersectsPlane(e){return Math.abs(e.distanceToPoint(this.center))<=this.radius}clampPoint(e,t){let i=this.center.distanceToSquared(e);return t.copy(e),i>this.radius*this.radius&&(t.sub(this.center).normalize(),t.multiplyScalar(this.radius).add(this.center)),t}getBoundingBox(e){return this.isEmpty()?(e.makeEmpty(),e):(e.set(this.center,this.center),e.expandByScalar(this.radius),e)}applyMatrix4(e){return this.center.applyMatrix4(e),this.radius=this.radius*e.getMaxScaleOnAxis(),this}translate(e){return this.center.add(e),this}expandByPoint(e){if(this.isEmpty())return this.center.copy(e),this.radius=0,this;Fa.subVectors(e,this.center);let t=Fa.lengthSq();if(t>this.radius*this.radius){let i=Math.sqrt(t),s=(i-this.radius)*.5;this.center.addScaledVector(Fa,s/i),this.radius+=s}return this}union(e){return e.isEmpty()?this:this.isEmpty()?(this.copy(e),this):(this.center.equals(e.center)===!0?this.radius=Math.max(this.radius,e.radius):(xf.subVectors(e.center,this.center).setLength(e.radius),this.expandByPoint(Fa.copy(e.center).add(xf)),this.expandByPoint(Fa.copy(e.center).sub(xf))),this)}equals(e){return e.center.equals(this.center)&&e.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(e){return this.radius=e.radius,this.center.fromArray(e.center),this}},mM=0,Fi=new St,yf=new zn,Uo=new z,Ei=new Qn,Ba=new Qn,Fn=new z,vn=class n extends Ki{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:mM++}),this.uuid=Ar(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(e){return Array.isArray(e)?this.index=new(zS(e)?ja:Ka)(e,1):this.index=e,this}setIndirect(e,t=0){return this.indirect=e,this.indirectOffset=t,this}getIndirect(){return this.indirect}getAttribute(e){return this.attributes[e]}setAttribute(e,t){return this.attributes[e]=t,this}deleteAttribute(e){return delete this.attributes[e],this}hasAttribute(e){return this.attributes[e]!==void 0}addGroup(e,t,i=0){this.groups.push({start:e,count:t,materialIndex:i})}clearGroups(){this.groups=[]}setDrawRange(e,t){this.drawRange.start=e,this.drawRange.count=t}applyMatrix4(e){let t=this.attributes.position;t!==void 0&&(t.applyMatrix4(e),t.needsUpdate=!0);let i=this.attributes.normal;if(i!==void 0){let r=new st().getNormalMatrix(e);i.applyNormalMatrix(r),i.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(e),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(e){return Fi.makeRotationFromQuaternion(e),this.applyMatrix4(Fi),this}rotateX(e){return Fi.makeRotationX(e),this.applyMatrix4(Fi),this}rotateY(e){return Fi.makeRotationY(e),this.applyMatrix4(Fi),this}rotateZ(e){return Fi.makeRotationZ(e),this.applyMatrix4(Fi),this}translate(e,t,i){return Fi.makeTranslation(e,t,i),this.applyMatrix4(Fi),this}scale(e,t,i){return Fi.makeScale(e,t,i),this.applyMatrix4(Fi),this}lookAt(e){return yf.lookAt(e),yf.updateMatrix(),this.applyMatrix4(yf.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Uo).negate(),this.translate(Uo.x,Uo.y,Uo.z),this}setFromPoints(e){let t=this.getAttribute("position");if(t===void 0){let i=[];for(let s=0,r=e.length;s<r;s++){let o=e[s];i.push(o.x,o.y,o.z||0)}this.setAttribute("position",new kn(i,3))}else{let i=Math.min(e.length,t.count);for(let s=0;s<i;s++){let r=e[s];t.setXYZ(s,r.x,r.y,r.z||0)}e.length>t.count&&$e("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),t.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new z(-1/0,-1/0,-1/0),new z(1/0,1/0,1/0));return}if(e!==void 0){if(this.boundingBox.setFromBufferAttribute(e),t)for(let i=0,s=t.length;i<s;i++){let r=t[i];Ei.setFromBufferAttribute(r),this.morphTargetsRelative?(Fn.addVectors(this.boundingBox.min,Ei.min),this.boundingBox.expandByPoint(Fn),Fn.addVectors(this.boundingBox.max,Ei.max),this.boundingBox.expandByPoint(Fn)):(this.boundingBox.expandByPoint(Ei.min),this.boundingBox.expandByPoint(Ei.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&it('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vn);let e=this.attributes.position,t=this.morphAttributes.position;if(e&&e.isGLBufferAttribute){it("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new z,1/0);return}if(e){let i=this.boundingSphere.center;if(Ei.setFromBufferAttribute(e),t)for(let r=0,o=t.length;r<o;r++){let a=t[r];Ba.setFromBufferAttribute(a),this.morphTargetsRelative?(Fn.addVectors(Ei.min,Ba.min),Ei.expandByPoint(Fn),Fn.addVectors(Ei.max,Ba.max),Ei.expandByPoint(Fn)):(Ei.expandByPoint(Ba.min),Ei.expandByPoint(Ba.max))}Ei.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Fn.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Fn));if(t)for(let r=0,o=t.length;r<o;r++){let a=t[r],l=this.morphTargetsRelative;for(let c=0,u=a.count;c<u;c++)Fn.fromBufferAttribute(a,c),l&&(Uo.fromBufferAttribute(e,c),Fn.add(Uo)),s=Math.max(s,i.distanceToSquared(Fn))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&it('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let e=this.index,t=this.attributes;if(e===null||t.position===void 0||t.normal===void 0||t.uv===void 0){it("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let i=t.position,s=t.normal,r=t.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==i.count)&&(o=new yn(new Float32Array(4*i.count),4),this.setAttribute("tangent",o));let a=[],l=[],c=new Uint8Array(i.count);for(let V=0;V<i.count;V++)a[V]=new z,l[V]=new z;let u=new z,f=new z,h=new z,d=new Ze,p=new Ze,b=new Ze,m=new z,g=new z;function v(V,U,D){c[V]=c[U]=c[D]=1,u.fromBufferAttribute(i,V),f.fromBufferAttribute(i,U),h.fromBufferAttribute(i,D),d.fromBufferAttribute(r,V),p.fromBufferAttribute(r,U),b.fromBufferAttribute(r,D),f.sub(u),h.sub(u),p.sub(d),b.sub(d);let H=1/(p.x*b.y-b.x*p.y);isFinite(H)&&(m.copy(f).multiplyScalar(b.y).addScaledVector(h,-p.y).multiplyScalar(H),g.copy(h).multiplyScalar(p.x).addScaledVector(f,-b.x).multiplyScalar(H),a[V].add(m),a[U].add(m),a[D].add(m),l[V].add(g),l[U].add(g),l[D].add(g))}let C=this.groups;C.length===0&&(C=[{start:0,count:e.count}]);for(let V=0,U=C.length;V<U;++V){let D=C[V],H=D.start,O=D.count;for(let L=H,X=H+O;L<X;L+=3)v(e.getX(L+0),e.getX(L+1),e.getX(L+2))}let M=new z,I=new z,E=new z,x=new z;function T(V){E.fromBufferAttribute(s,V),x.copy(E);let U=a[V];M.copy(U),M.sub(E.multiplyScalar(E.dot(U))).normalize(),I.crossVectors(x,U);let H=I.dot(l[V])<0?-1:1;o.setXYZW(V,M.x,M.y,M.z,H)}for(let V=0,U=i.count;V<U;++V)c[V]&&T(V);this._transformed=!0}computeVertexNormals(){let e=this.index,t=this.getAttribute("position");if(t!==void 0){let i=this.getAttribute("normal");if(i===void 0||i.count!==t.count)i=new yn(new Float32Array(t.count*3),3),this.setAttribute("normal",i);else for(let h=0,d=i.count;h<d;h++)i.setXYZ(h,0,0,0);let s=new z,r=new z,o=new z,a=new z,l=new z,c=new z,u=new z,f=new z;if(e)for(let h=0,d=e.count;h<d;h+=3){let p=e.getX(h+0),b=e.getX(h+1),m=e.getX(h+2);s.fromBufferAttribute(t,p),r.fromBufferAttribute(t,b),o.fromBufferAttribute(t,m),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),a.fromBufferAttribute(i,p),l.fromBufferAttribute(i,b),c.fromBufferAttribute(i,m),a.add(u),l.add(u),c.add(u),i.setXYZ(p,a.x,a.y,a.z),i.setXYZ(b,l.x,l.y,l.z),i.setXYZ(m,c.x,c.y,c.z)}else for(let h=0,d=t.count;h<d;h+=3)s.fromBufferAttribute(t,h+0),r.fromBufferAttribute(t,h+1),o.fromBufferAttribute(t,h+2),u.subVectors(o,r),f.subVectors(s,r),u.cross(f),i.setXYZ(h+0,u.x,u.y,u.z),i.setXYZ(h+1,u.x,u.y,u.z),i.setXYZ(h+2,u.x,u.y,u.z);this.normalizeNormals(),i.needsUpdate=!0}}normalizeNormals(){let e=this.attributes.normal;for(let t=0,i=e.count;t<i;t++)Fn.fromBufferAttribute(e,t),Fn.normalize(),e.setXYZ(t,Fn.x,Fn.y,Fn.z)}toNonIndexed(){function e(a,l){let c=a.array,u=a.itemSize,f=a.normalized,h=new c.constructor(l.length*u),d=0,p=0;for(let b=0,m=l.length;b<m;b++){a.isInterleavedBufferAttribute?d=l[b]*a.data.stride+a.offset:d=l[b]*u;for(let g=0;g<u;g++)h[p++]=c[d++]}return new yn(h,u,f)}if(this.index===null)return $e("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let t=new n,i=this.index.array,s=this.attributes;for(let a in s){let l=s[a],c=e(l,i);t.setAttribute(a,c)}let r=this.morphAttributes;for(let a in r){let l=[],c=r[a];for(let u=0,f=c.length;u<f;u++){let h=c[u],d=e(h,i);l.push(d)}t.morphAttributes[a]=l}t.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,l=o.length;a<l;a++){let c=o[a];t.addGroup(c.start,c.count,c.materialIndex)}return t}toJSON(){let e={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(e.uuid=this.uuid,e.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,e.name=this.name,Object.keys(this.userData).length>0&&(e.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let l=this.parameters;for(let c in l)l[c]!==void 0&&(e[c]=l[c]);return e}e.data={attributes:{}};let t=this.index;t!==null&&(e.data.index={type:t.array.constructor.name,array:Array.prototype.slice.call(t.array)});let i=this.attributes;for(let l in i){let c=i[l];e.data.attributes[l]=c.toJSON(e.data)}let s={},r=!1;for(let l in this.morphAttributes){let c=this.morphAttributes[l],u=[];for(let f=0,h=c.length;f<h;f++){let d=c[f];u.push(d.toJSON(e.data))}u.length>0&&(s[l]=u,r=!0)}r&&(e.data.morphAttributes=s,e.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(e.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(e.data.boundingSphere=a.toJSON()),e}clone(){return new this.constructor().copy(this)}copy(e){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let t={};this.name=e.name;let i=e.index;i!==null&&this.setIndex(i.clone());let s=e.attributes;for(let c in s){let u=s[c];this.setAttribute(c,u.clone(t))}let r=e.morphAttributes;for(let c in r){let u=[],f=r[c];for(let h=0,d=f.length;h<d;h++)u.push(f[h].clone(t));this.morphAttributes[c]=u}this.morphTargetsRelative=e.morphTargetsRelative;let o=e.groups;for(let c=0,u=o.length;c<u;c++){let f=o[c];this.addGroup(f.start,f.count,f.materialIndex)}let a=e.boundingBox;a!==null&&(this.boundingBox=a.clone());let l=e.boundingSphere;return l!==null&&(this.boundingSphere=l.clone()),this.drawRange.start=e.drawRange.start,this.drawRange.count=e.drawRange.count,this.userData=e.userData,this._transformed=e._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},mu=class{constructor(e,t){this.isInterleavedBuffer=!0,this.array=e,this.stride=t,this.count=e!==void 0?e.length/t:0,this.usage=sp,this.updateRanges=[],this.version=0,this.uuid=Ar()}onUploadCallback(){}set needsUpdate(e){e===!0&&this.version++}setUsage(e){return this.usage=e,this}addUpdateRange(e,t){this.updateRanges.push({start:e,count:t})}clearUpdateRanges(){this.updateRanges.length=0}copy(e){return this.array=new e.array.constructor(e.array),this.count=e.count,this.stride=e.stride,this.usage=e.usage,this}copyAt(e,t,i){e*=this.stride,i*=t.stride;for(let s=0,r=this.stride;s<r;s++)this.array[e+s]=t.array[i+s];return this}set(e,t=0){return this.array.set(e,t),this}clone(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=f_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=this.array.slice(0).buffer);let i=new this.array.constructor(e.arrayBuffers[t]),s=new this.constructor(i,this.stride);return s.setUsage(this.usage),s}onUpload(e){return this.onUploadCallback=e,this}toJSON(e){e.arrayBuffers===void 0&&(e.arrayBuffers={});let t=f_(this.array);e.arrayBuffers[t]===void 0&&(e.arrayBuffers[t]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let i={uuid:this.uuid,buffer:t,type:this.array.constructor.name,stride:this.stride};return i.usage=this.usage,i}};function f_(n){return n.buffer._uuid===void 0&&(n.buffer._uuid=Ar()),n.byteOffset===0&&n.byteLength===n.buffer.byteLength?n.buffer._uuid:n.buffer._uuid+":"+n.byteOffset+":"+n.byteLength}var ai=new z,ji=class n{constructor(e,t,i,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=e,this.itemSize=t,this.offset=i,this.normalized=s,this._normalizationScale=e!==void 0?Sh(e.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(e){this.data.needsUpdate=e}applyMatrix4(e){for(let t=0,i=this.data.count;t<i;t++)ai.fromBufferAttribute(this,t),ai.applyMatrix4(e),this.setXYZ(t,ai.x,ai.y,ai.z);return this}applyNormalMatrix(e){for(let t=0,i=this.count;t<i;t++)ai.fromBufferAttribute(this,t),ai.applyNormalMatrix(e),this.setXYZ(t,ai.x,ai.y,ai.z);return this}transformDirection(e){for(let t=0,i=this.count;t<i;t++)ai.fromBufferAttribute(this,t),ai.transformDirection(e),this.setXYZ(t,ai.x,ai.y,ai.z);return this}getComponent(e,t){let i=this.array[e*this.data.stride+this.offset+t];return this.normalized&&(i=this._denormalize(i)),i}setComponent(e,t,i){return this.normalized&&(i=this._normalize(i)),this.data.array[e*this.data.stride+this.offset+t]=i,this}setX(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset]=t,this}setY(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+1]=t,this}setZ(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+2]=t,this}setW(e,t){return this.normalized&&(t=this._normalize(t)),this.data.array[e*this.data.stride+this.offset+3]=t,this}getX(e){let t=this.data.array[e*this.data.stride+this.offset];return this.normalized&&(t=this._denormalize(t)),t}getY(e){let t=this.data.array[e*this.data.stride+this.offset+1];return this.normalized&&(t=this._denormalize(t)),t}getZ(e){let t=this.data.array[e*this.data.stride+this.offset+2];return this.normalized&&(t=this._denormalize(t)),t}getW(e){let t=this.data.array[e*this.data.stride+this.offset+3];return this.normalized&&(t=this._denormalize(t)),t}setXY(e,t,i){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i)),this.data.array[e+0]=t,this.data.array[e+1]=i,this}setXYZ(e,t,i,s){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this}setXYZW(e,t,i,s,r){return e=e*this.data.stride+this.offset,this.normalized&&(t=this._normalize(t),i=this._normalize(i),s=this._normalize(s),r=this._normalize(r)),this.data.array[e+0]=t,this.data.array[e+1]=i,this.data.array[e+2]=s,this.data.array[e+3]=r,this}clone(e){if(e===void 0){Ya("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return new yn(new this.array.constructor(t),this.itemSize,this.normalized)}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.clone(e)),new n(e.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(e){if(e===void 0){Ya("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let t=[];for(let i=0;i<this.count;i++){let s=i*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)t.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:t,normalized:this.normalized}}else return e.interleavedBuffers===void 0&&(e.interleavedBuffers={}),e.interleavedBuffers[this.data.uuid]===void 0&&(e.interleavedBuffers[this.data.uuid]=this.data.toJSON(e)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(e){let t=this._normalizationScale;return t!==void 0?Math.max(e/t,-1):lp(e,this.data.array)}_normalize(e){let t=this._normalizationScale;return t!==void 0?Math.round(e*t):cp(e,this.data.array)}},vf=new z,gM=new z,_M=new st,li=class{constructor(e=new z(1,0,0),t=0){this.isPlane=!0,this.normal=e,this.constant=t}set(e,t){return this.normal.copy(e),this.constant=t,this}setComponents(e,t,i,s){return this.normal.set(e,t,i),this.constant=s,this}setFromNormalAndCoplanarPoint(e,t){return this.normal.copy(e),this.constant=-t.dot(this.normal),this}setFromCoplanarPoints(e,t,i){let s=vf.subVectors(i,t).cross(gM.subVectors(e,t)).normalize();return this.setFromNormalAndCoplanarPoint(s,e),this}copy(e){return this.normal.copy(e.normal),this.constant=e.constant,this}normalize(){let e=1/this.normal.length();return this.normal.multiplyScalar(e),this.constant*=e,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(e){return this.normal.dot(e)+this.constant}distanceToSphere(e){return this.distanceToPoint(e.center)-e.radius}projectPoint(e,t){return t.copy(e).addScaledVector(this.normal,-this.distanceToPoint(e))}intersectLine(e,t,i=!0){let s=e.delta(vf),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(e.start)===0?t.copy(e.start):null;let o=-(e.start.dot(this.normal)+this.constant)/r;return i===!0&&(o<0||o>1)?null:t.copy(e.start).addScaledVector(s,o)}intersectsLine(e){let t=this.distanceToPoint(e.start),i=this.distanceToPoint(e.end);return t<0&&i>0||i<0&&t>0}intersectsBox(e){return e.intersectsPlane(this)}intersectsSphere(e){return e.intersectsPlane(this)}coplanarPoint(e){return e.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(e,t){let i=t||_M.getNormalMatrix(e),s=this.coplanarPoint(vf).applyMatrix4(e),r=this.normal.applyMatrix3(i).normalize();return this.constant=-s.dot(r),this}translate(e){return this.constant-=e.dot(this.normal),this}equals(e){return e.normal.equals(this.normal)&&e.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(e){return this.normal.fromArray(e.normal),this.constant=e.constant,this}},xM=0,ms=class extends Ki{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:xM++}),this.uuid=Ar(),this.name="",this.type="Material",this.blending=ea,this.side=Mr,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=Bf,this.blendDst=kf,this.blendEquation=Yr,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new ut(0,0,0),this.blendAlpha=0,this.depthFunc=fr,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=rx,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=tu,this.stencilZFail=tu,this.stencilZPass=tu,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(e){this._alphaTest>0!=e>0&&this.version++,this._alphaTest=e}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(e){if(e!==void 0)for(let t in e){let i=e[t];if(i===void 0){$e(`Material: parameter '${t}' has value of undefined.`);continue}let s=this[t];if(s===void 0){$e(`Material: '${t}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(i):s&&s.isVector2&&i&&i.isVector2||s&&s.isEuler&&i&&i.isEuler||s&&s.isVector3&&i&&i.isVector3?s.copy(i):this[t]=i}}toJSON(e){let t=e===void 0||typeof e=="string";t&&(e={textures:{},images:{}});let i={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};i.uuid=this.uuid,i.type=this.type,i.blending=this.blending,i.side=this.side,i.shadowSide=this.shadowSide,i.vertexColors=this.vertexColors,i.opacity=this.opacity,i.transparent=this.transparent,i.blendSrc=this.blendSrc,i.blendDst=this.blendDst,i.blendEquation=this.blendEquation,i.blendSrcAlpha=this.blendSrcAlpha,i.blendDstAlpha=this.blendDstAlpha,i.blendEquationAlpha=this.blendEquationAlpha,i.blendColor=this.blendColor.getHex(),i.blendAlpha=this.blendAlpha,i.depthFunc=this.depthFunc,i.depthTest=this.depthTest,i.depthWrite=this.depthWrite,i.colorWrite=this.colorWrite,i.clipIntersection=this.clipIntersection,i.clipShadows=this.clipShadows,i.stencilWriteMask=this.stencilWriteMask,i.stencilFunc=this.stencilFunc,i.stencilRef=this.stencilRef,i.stencilFuncMask=this.stencilFuncMask,i.stencilFail=this.stencilFail,i.stencilZFail=this.stencilZFail,i.stencilZPass=this.stencilZPass,i.stencilWrite=this.stencilWrite,i.polygonOffset=this.polygonOffset,i.polygonOffsetFactor=this.polygonOffsetFactor,i.polygonOffsetUnits=this.polygonOffsetUnits,i.dithering=this.dithering,i.alphaTest=this.alphaTest,i.alphaHash=this.alphaHash,i.alphaToCoverage=this.alphaToCoverage,i.premultipliedAlpha=this.premultipliedAlpha,i.forceSinglePass=this.forceSinglePass,i.allowOverride=this.allowOverride,i.visible=this.visible,i.toneMapped=this.toneMapped,i.name=this.name,this.color&&this.color.isColor&&(i.color=this.color.getHex()),this.roughness!==void 0&&(i.roughness=this.roughness),this.metalness!==void 0&&(i.metalness=this.metalness),this.sheen!==void 0&&(i.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(i.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(i.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(i.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(i.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(i.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(i.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(i.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(i.shininess=this.shininess),this.clearcoat!==void 0&&(i.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(i.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(i.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(i.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(e).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(i.clearcoatMap=this.clearcoatMap.toJSON(e).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(i.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(e).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(i.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(e).uuid,i.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(i.sheenColorMap=this.sheenColorMap.toJSON(e).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(i.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(e).uuid),this.dispersion!==void 0&&(i.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(i.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(i.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(i.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(i.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(i.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(i.iridescenceMap=this.iridescenceMap.toJSON(e).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(i.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(e).uuid),this.anisotropy!==void 0&&(i.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(i.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(i.anisotropyMap=this.anisotropyMap.toJSON(e).uuid),this.map&&this.map.isTexture&&(i.map=this.map.toJSON(e).uuid),this.matcap&&this.matcap.isTexture&&(i.matcap=this.matcap.toJSON(e).uuid),this.alphaMap&&this.alphaMap.isTexture&&(i.alphaMap=this.alphaMap.toJSON(e).uuid),this.lightMap&&this.lightMap.isTexture&&(i.lightMap=this.lightMap.toJSON(e).uuid,i.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(i.aoMap=this.aoMap.toJSON(e).uuid,i.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(i.bumpMap=this.bumpMap.toJSON(e).uuid,i.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(i.normalMap=this.normalMap.toJSON(e).uuid,i.normalMapType=this.normalMapType,i.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(i.displacementMap=this.displacementMap.toJSON(e).uuid,i.displacementScale=this.displacementScale,i.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(i.roughnessMap=this.roughnessMap.toJSON(e).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(i.metalnessMap=this.metalnessMap.toJSON(e).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(i.emissiveMap=this.emissiveMap.toJSON(e).uuid),this.specularMap&&this.specularMap.isTexture&&(i.specularMap=this.specularMap.toJSON(e).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(i.specularIntensityMap=this.specularIntensityMap.toJSON(e).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(i.specularColorMap=this.specularColorMap.toJSON(e).uuid),this.envMap&&this.envMap.isTexture&&(i.envMap=this.envMap.toJSON(e).uuid,this.combine!==void 0&&(i.combine=this.combine)),this.envMapRotation!==void 0&&(i.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(i.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(i.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(i.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(i.gradientMap=this.gradientMap.toJSON(e).uuid),this.transmission!==void 0&&(i.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(i.transmissionMap=this.transmissionMap.toJSON(e).uuid),this.thickness!==void 0&&(i.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(i.thicknessMap=this.thicknessMap.toJSON(e).uuid),this.attenuationDistance!==void 0&&(i.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(i.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(i.size=this.size),this.sizeAttenuation!==void 0&&(i.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(i.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(i.rotation=this.rotation),this.depthPacking!==void 0&&(i.depthPacking=this.depthPacking),this.linewidth!==void 0&&(i.linewidth=this.linewidth),this.linecap!==void 0&&(i.linecap=this.linecap),this.linejoin!==void 0&&(i.linejoin=this.linejoin),this.dashSize!==void 0&&(i.dashSize=this.dashSize),this.gapSize!==void 0&&(i.gapSize=this.gapSize),this.scale!==void 0&&(i.scale=this.scale),this.wireframe!==void 0&&(i.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(i.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(i.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(i.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(i.flatShading=this.flatShading),this.fog!==void 0&&(i.fog=this.fog),Object.keys(this.userData).length>0&&(i.userData=this.userData);function s(r){let o=[];for(let a in r){let l=r[a];delete l.metadata,o.push(l)}return o}if(t){let r=s(e.textures),o=s(e.images);r.length>0&&(i.textures=r),o.length>0&&(i.images=o)}return i}fromJSON(e,t){if(e.uuid!==void 0&&(this.uuid=e.uuid),e.name!==void 0&&(this.name=e.name),e.color!==void 0&&this.color!==void 0&&this.color.setHex(e.color),e.roughness!==void 0&&(this.roughness=e.roughness),e.metalness!==void 0&&(this.metalness=e.metalness),e.sheen!==void 0&&(this.sheen=e.sheen),e.sheenColor!==void 0&&(this.sheenColor=new ut().setHex(e.sheenColor)),e.sheenRoughness!==void 0&&(this.sheenRoughness=e.sheenRoughness),e.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(e.emissive),e.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(e.specular),e.specularIntensity!==void 0&&(this.specularIntensity=e.specularIntensity),e.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(e.specularColor),e.shininess!==void 0&&(this.shininess=e.shininess),e.clearcoat!==void 0&&(this.clearcoat=e.clearcoat),e.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=e.clearcoatRoughness),e.diffuseRoughness!==void 0&&(this.diffuseRoughness=e.diffuseRoughness),e.dispersion!==void 0&&(this.dispersion=e.dispersion),e.retroreflectivity!==void 0&&(this.retroreflectivity=e.retroreflectivity),e.iridescence!==void 0&&(this.iridescence=e.iridescence),e.iridescenceIOR!==void 0&&(this.iridescenceIOR=e.iridescenceIOR),e.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessMinimum),e.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=e.iridescenceThicknessMaximum),e.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=e.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=e.iridescenceThicknessRange[1]),e.transmission!==void 0&&(this.transmission=e.transmission),e.thickness!==void 0&&(this.thickness=e.thickness),e.attenuationDistance!==void 0&&(this.attenuationDistance=e.attenuationDistance),e.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(e.attenuationColor),e.anisotropy!==void 0&&(this.anisotropy=e.anisotropy),e.anisotropyRotation!==void 0&&(this.anisotropyRotation=e.anisotropyRotation),e.fog!==void 0&&(this.fog=e.fog),e.flatShading!==void 0&&(this.flatShading=e.flatShading),e.blending!==void 0&&(this.blending=e.blending),e.combine!==void 0&&(this.combine=e.combine),e.side!==void 0&&(this.side=e.side),e.shadowSide!==void 0&&(this.shadowSide=e.shadowSide),e.opacity!==void 0&&(this.opacity=e.opacity),e.transparent!==void 0&&(this.transparent=e.transparent),e.alphaTest!==void 0&&(this.alphaTest=e.alphaTest),e.alphaHash!==void 0&&(this.alphaHash=e.alphaHash),e.depthFunc!==void 0&&(this.depthFunc=e.depthFunc),e.depthTest!==void 0&&(this.depthTest=e.depthTest),e.depthWrite!==void 0&&(this.depthWrite=e.depthWrite),e.colorWrite!==void 0&&(this.colorWrite=e.colorWrite),e.clippingPlanes!==void 0&&(this.clippingPlanes=e.clippingPlanes.map(i=>new li().fromJSON(i))),e.clipIntersection!==void 0&&(this.clipIntersection=e.clipIntersection),e.clipShadows!==void 0&&(this.clipShadows=e.clipShadows),e.depthPacking!==void 0&&(this.depthPacking=e.depthPacking),e.blendSrc!==void 0&&(this.blendSrc=e.blendSrc),e.blendDst!==void 0&&(this.blendDst=e.blendDst),e.blendEquation!==void 0&&(this.blendEquation=e.blendEquation),e.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=e.blendSrcAlpha),e.blendDstAlpha!==void 0&&(this.blendDstAlpha=e.blendDstAlpha),e.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=e.blendEquationAlpha),e.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(e.blendColor),e.blendAlpha!==void 0&&(this.blendAlpha=e.blendAlpha),e.stencilWriteMask!==void 0&&(this.stencilWriteMask=e.stencilWriteMask),e.stencilFunc!==void 0&&(this.stencilFunc=e.stencilFunc),e.stencilRef!==void 0&&(this.stencilRef=e.stencilRef),e.stencilFuncMask!==void 0&&(this.stencilFuncMask=e.stencilFuncMask),e.stencilFail!==void 0&&(this.stencilFail=e.stencilFail),e.stencilZFail!==void 0&&(this.stencilZFail=e.stencilZFail),e.stencilZPass!==void 0&&(this.stencilZPass=e.stencilZPass),e.stencilWrite!==void 0&&(this.stencilWrite=e.stencilWrite),e.wireframe!==void 0&&(this.wireframe=e.wireframe),e.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=e.wireframeLinewidth),e.wireframeLinecap!==void 0&&(this.wireframeLinecap=e.wireframeLinecap),e.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=e.wireframeLinejoin),e.rotation!==void 0&&(this.rotation=e.rotation),e.linewidth!==void 0&&(this.linewidth=e.linewidth),e.linecap!==void 0&&(this.linecap=e.linecap),e.linejoin!==void 0&&(this.linejoin=e.linejoin),e.dashSize!==void 0&&(this.dashSize=e.dashSize),e.gapSize!==void 0&&(this.gapSize=e.gapSize),e.scale!==void 0&&(this.scale=e.scale),e.polygonOffset!==void 0&&(this.polygonOffset=e.polygonOffset),e.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=e.polygonOffsetFactor),e.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=e.polygonOffsetUnits),e.dithering!==void 0&&(this.dithering=e.dithering),e.alphaToCoverage!==void 0&&(this.alphaToCoverage=e.alphaToCoverage),e.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=e.premultipliedAlpha),e.forceSinglePass!==void 0&&(this.forceSinglePass=e.forceSinglePass),e.allowOverride!==void 0&&(this.allowOverride=e.allowOverride),e.visible!==void 0&&(this.visible=e.visible),e.toneMapped!==void 0&&(this.toneMapped=e.toneMapped),e.userData!==void 0&&(this.userData=e.userData),e.vertexColors!==void 0&&(typeof e.vertexColors=="number"?this.vertexColors=e.vertexColors>0:this.vertexColors=e.vertexColors),e.size!==void 0&&(this.size=e.size),e.sizeAttenuation!==void 0&&(this.sizeAttenuation=e.sizeAttenuation),e.map!==void 0&&(this.map=t[e.map]||null),e.matcap!==void 0&&(this.matcap=t[e.matcap]||null),e.alphaMap!==void 0&&(this.alphaMap=t[e.alphaMap]||null),e.bumpMap!==void 0&&(this.bumpMap=t[e.bumpMap]||null),e.bumpScale!==void 0&&(this.bumpScale=e.bumpScale),e.normalMap!==void 0&&(this.normalMap=t[e.normalMap]||null),e.normalMapType!==void 0&&(this.normalMapType=e.normalMapType),e.normalScale!==void 0){let i=e.normalScale;Array.isArray(i)===!1&&(i=[i,i]),this.normalScale=new Ze().fromArray(i)}return e.displacementMap!==void 0&&(this.displacementMap=t[e.displacementMap]||null),e.displacementScale!==void 0&&(this.displacementScale=e.displacementScale),e.displacementBias!==void 0&&(this.displacementBias=e.displacementBias),e.roughnessMap!==void 0&&(this.roughnessMap=t[e.roughnessMap]||null),e.metalnessMap!==void 0&&(this.metalnessMap=t[e.metalnessMap]||null),e.emissiveMap!==void 0&&(this.emissiveMap=t[e.emissiveMap]||null),e.emissiveIntensity!==void 0&&(this.emissiveIntensity=e.emissiveIntensity),e.specularMap!==void 0&&(this.specularMap=t[e.specularMap]||null),e.specularIntensityMap!==void 0&&(this.specularIntensityMap=t[e.specularIntensityMap]||null),e.specularColorMap!==void 0&&(this.specularColorMap=t[e.specularColorMap]||null),e.envMap!==void 0&&(this.envMap=t[e.envMap]||null),e.envMapRotation!==void 0&&this.envMapRotation.fromArray(e.envMapRotation),e.envMapIntensity!==void 0&&(this.envMapIntensity=e.envMapIntensity),e.reflectivity!==void 0&&(this.reflectivity=e.reflectivity),e.refractionRatio!==void 0&&(this.refractionRatio=e.refractionRatio),e.lightMap!==void 0&&(this.lightMap=t[e.lightMap]||null),e.lightMapIntensity!==void 0&&(this.lightMapIntensity=e.lightMapIntensity),e.aoMap!==void 0&&(this.aoMap=t[e.aoMap]||null),e.aoMapIntensity!==void 0&&(this.aoMapIntensity=e.aoMapIntensity),e.gradientMap!==void 0&&(this.gradientMap=t[e.gradientMap]||null),e.clearcoatMap!==void 0&&(this.clearcoatMap=t[e.clearcoatMap]||null),e.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=t[e.clearcoatRoughnessMap]||null),e.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=t[e.clearcoatNormalMap]||null),e.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Ze().fromArray(e.clearcoatNormalScale)),e.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=t[e.diffuseRoughnessMap]||null),e.iridescenceMap!==void 0&&(this.iridescenceMap=t[e.iridescenceMap]||null),e.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=t[e.iridescenceThicknessMap]||null),e.transmissionMap!==void 0&&(this.transmissionMap=t[e.transmissionMap]||null),e.thicknessMap!==void 0&&(this.thicknessMap=t[e.thicknessMap]||null),e.anisotropyMap!==void 0&&(this.anisotropyMap=t[e.anisotropyMap]||null),e.sheenColorMap!==void 0&&(this.sheenColorMap=t[e.sheenColorMap]||null),e.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=t[e.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(e){this.name=e.name,this.blending=e.blending,this.side=e.side,this.vertexColors=e.vertexColors,this.opacity=e.opacity,this.transparent=e.transparent,this.blendSrc=e.blendSrc,this.blendDst=e.blendDst,this.blendEquation=e.blendEquation,this.blendSrcAlpha=e.blendSrcAlpha,this.blendDstAlpha=e.blendDstAlpha,this.blendEquationAlpha=e.blendEquationAlpha,this.blendColor.copy(e.blendColor),this.blendAlpha=e.blendAlpha,this.depthFunc=e.depthFunc,this.depthTest=e.depthTest,this.depthWrite=e.depthWrite,this.stencilWriteMask=e.stencilWriteMask,this.stencilFunc=e.stencilFunc,this.stencilRef=e.stencilRef,this.stencilFuncMask=e.stencilFuncMask,this.stencilFail=e.stencilFail,this.stencilZFail=e.stencilZFail,this.stencilZPass=e.stencilZPass,this.stencilWrite=e.stencilWrite;let t=e.clippingPlanes,i=null;if(t!==null){let s=t.length;i=new Array(s);for(let r=0;r!==s;++r)i[r]=t[r].clone()}return this.clippingPlanes=i,this.clipIntersection=e.clipIntersection,this.clipShadows=e.clipShadows,this.shadowSide=e.shadowSide,this.colorWrite=e.colorWrite,this.precision=e.precision,this.polygonOffset=e.polygonOffset,this.polygonOffsetFactor=e.polygonOffsetFactor,this.polygonOffsetUnits=e.polygonOffsetUnits,this.dithering=e.dithering,this.alphaTest=e.alphaTest,this.alphaHash=e.alphaHash,this.alphaToCoverage=e.alphaToCoverage,this.premultipliedAlpha=e.premultipliedAlpha,this.forceSinglePass=e.forceSinglePass,this.allowOverride=e.allowOverride,this.visible=e.visible,this.toneMapped=e.toneMapped,this.userData=JSON.parse(JSON.stringify(e.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(e){e===!0&&this.version++}};var Os=new z,bf=new z,Oc=new z,Fc=new z,pr=class{constructor(e=new z,t=new z(0,0,-1)){this.origin=e,this.direction=t}set(e,t){return this.origin.copy(e),this.direction.copy(t),this}copy(e){return this.origin.copy(e.origin),this.direction.copy(e.direction),this}at(e,t){return t.copy(this.origin).addScaledVector(this.direction,e)}lookAt(e){return this.direction.copy(e).sub(this.origin).normalize(),this}recast(e){return this.origin.copy(this.at(e,Os)),this}closestPointToPoint(e,t){t.subVectors(e,this.origin);let i=t.dot(this.direction);return i<0?t.copy(this.origin):t.copy(this.origin).addScaledVector(this.direction,i)}distanceToPoint(e){return Math.sqrt(this.distanceSqToPoint(e))}distanceSqToPoint(e){let t=Os.subVectors(e,this.origin).dot(this.direction);return t<0?this.origin.distanceToSquared(e):(Os.copy(this.origin).addScaledVector(this.direction,t),Os.distanceToSquared(e))}distanceSqToSegment(e,t,i,s){bf.copy(e).add(t).multiplyScalar(.5),Oc.copy(t).sub(e).normalize(),Fc.copy(this.origin).sub(bf);let r=e.distanceTo(t)*.5,o=-this.direction.dot(Oc),a=Fc.dot(this.direction),l=-Fc.dot(Oc),c=Fc.lengthSq(),u=Math.abs(1-o*o),f,h,d,p;if(u>0)if(f=o*l-a,h=o*a-l,p=r*u,f>=0)if(h>=-p)if(h<=p){let b=1/u;f*=b,h*=b,d=f*(f+o*h+2*a)+h*(o*f+h+2*l)+c}else h=r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h=-r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;else h<=-p?(f=Math.max(0,-(-o*r+a)),h=f>0?-r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c):h<=p?(f=0,h=Math.min(Math.max(-r,-l),r),d=h*(h+2*l)+c):(f=Math.max(0,-(o*r+a)),h=f>0?r:Math.min(Math.max(-r,-l),r),d=-f*f+h*(h+2*l)+c);else h=o>0?-r:r,f=Math.max(0,-(o*h+a)),d=-f*f+h*(h+2*l)+c;return i&&i.copy(this.origin).addScaledVector(this.direction,f),s&&s.copy(bf).addScaledVector(Oc,h),d}intersectSphere(e,t){if(e.radius<0)return null;Os.subVectors(e.center,this.origin);let i=Os.dot(this.direction),s=Os.dot(Os)-i*i,r=e.radius*e.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=i-o,l=i+o;return l<0?null:a<0?this.at(l,t):this.at(a,t)}intersectsSphere(e){return e.radius<0?!1:this.distanceSqToPoint(e.center)<=e.radius*e.radius}distanceToPlane(e){let t=e.normal.dot(this.direction);if(t===0)return e.distanceToPoint(this.origin)===0?0:null;let i=-(this.origin.dot(e.normal)+e.constant)/t;return i>=0?i:null}intersectPlane(e,t){let i=this.distanceToPlane(e);return i===null?null:this.at(i,t)}intersectsPlane(e){let t=e.distanceToPoint(this.origin);return t===0||e.normal.dot(this.direction)*t<0}intersectBox(e,t){let i,s,r,o,a,l,c=1/this.direction.x,u=1/this.direction.y,f=1/this.direction.z,h=this.origin;return c>=0?(i=(e.min.x-h.x)*c,s=(e.max.x-h.x)*c):(i=(e.max.x-h.x)*c,s=(e.min.x-h.x)*c),u>=0?(r=(e.min.y-h.y)*u,o=(e.max.y-h.y)*u):(r=(e.max.y-h.y)*u,o=(e.min.y-h.y)*u),i>o||r>s||((r>i||isNaN(i))&&(i=r),(o<s||isNaN(s))&&(s=o),f>=0?(a=(e.min.z-h.z)*f,l=(e.max.z-h.z)*f):(a=(e.max.z-h.z)*f,l=(e.min.z-h.z)*f),i>l||a>s)||((a>i||i!==i)&&(i=a),(l<s||s!==s)&&(s=l),s<0)?null:this.at(i>=0?i:s,t)}intersectsBox(e){return this.intersectBox(e,Os)!==null}intersectTriangle(e,t,i,s,r){let o=this.origin,a=this.direction,l=a.x,c=a.y,u=a.z,f=e.x-o.x,h=e.y-o.y,d=e.z-o.z,p=t.x-o.x,b=t.y-o.y,m=t.z-o.z,g=i.x-o.x,v=i.y-o.y,C=i.z-o.z,M=Math.abs(l),I=Math.abs(c),E=Math.abs(u),x,T,V,U,D,H,O,L,X,$,G,ue;if(M>=I&&M>=E?(V=l,H=f,X=p,ue=g,l>=0?(x=c,T=u,U=h,D=d,O=b,L=m,$=v,G=C):(x=u,T=c,U=d,D=h,O=m,L=b,$=C,G=v)):I>=E?(V=c,H=h,X=b,ue=v,c>=0?(x=u,T=l,U=d,D=f,O=m,L=p,$=C,G=g):(x=l,T=u,U=f,D=d,O=p,L=m,$=g,G=C)):(V=u,H=d,X=m,ue=C,u>=0?(x=l,T=c,U=f,D=h,O=p,L=b,$=g,G=v):(x=c,T=l,U=h,D=f,O=b,L=p,$=v,G=g)),V===0)return null;let Z=x/V,Q=T/V,ie=1/V,pe=U-Z*H,fe=D-Q*H,ee=O-Z*X,_e=L-Q*X,xe=$-Z*ue,se=G-Q*ue,ce=xe*_e-se*ee,Oe=pe*se-fe*xe,Ke=ee*fe-_e*pe;if(s){if(ce<0||Oe<0||Ke<0)return null}else if((ce<0||Oe<0||Ke<0)&&(ce>0||Oe>0||Ke>0))return null;let Ge=ce+Oe+Ke;if(Ge===0)return null;let pt=ie*(ce*H+Oe*X+Ke*ue);return(Ge>0?pt<0:pt>0)?null:this.at(pt/Ge,r)}applyMatrix4(e){return this.origin.applyMatrix4(e),this.direction.transformDirection(e),this}equals(e){return e.origin.equals(this.origin)&&e.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},Yo=class extends ms{constructor(e){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.combine=Uu,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.fog=e.fog,this}},p_=new St,Gr=new pr,Bc=new Vn,m_=new z,kc=new z,zc=new z,Vc=new z,Sf=new z,Hc=new z,g_=new z,Gc=new z,Hn=class extends zn{constructor(e=new vn,t=new Yo){super(),this.isMesh=!0,this.type="Mesh",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(e,t){let i=this.geometry,s=i.attributes.position,r=i.morphAttributes.position,o=i.morphTargetsRelative;t.fromBufferAttribute(s,e);let a=this.morphTargetInfluences;if(r&&a){Hc.set(0,0,0);for(let l=0,c=r.length;l<c;l++){let u=a[l],f=r[l];u!==0&&(Sf.fromBufferAttribute(f,e),o?Hc.addScaledVector(Sf,u):Hc.addScaledVector(Sf.sub(t),u))}t.add(Hc)}return t}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(i.boundingSphere===null&&i.computeBoundingSphere(),Bc.copy(i.boundingSphere),Bc.applyMatrix4(r),Gr.copy(e.ray).recast(e.near),!(Bc.containsPoint(Gr.origin)===!1&&(Gr.intersectSphere(Bc,m_)===null||Gr.origin.distanceToSquared(m_)>(e.far-e.near)**2))&&(p_.copy(r).invert(),Gr.copy(e.ray).applyMatrix4(p_),!(i.boundingBox!==null&&Gr.intersectsBox(i.boundingBox)===!1)&&this._computeIntersections(e,t,Gr)))}_computeIntersections(e,t,i){let s,r=this.geometry,o=this.material,a=r.index,l=r.attributes.position,c=r.attributes.uv,u=r.attributes.uv1,f=r.attributes.normal,h=r.groups,d=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let m=h[p],g=o[m.materialIndex],v=Math.max(m.start,d.start),C=Math.min(a.count,Math.min(m.start+m.count,d.start+d.count));for(let M=v,I=C;M<I;M+=3){let E=a.getX(M),x=a.getX(M+1),T=a.getX(M+2);s=Wc(this,g,e,i,c,u,f,E,x,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(a.count,d.start+d.count);for(let m=p,g=b;m<g;m+=3){let v=a.getX(m),C=a.getX(m+1),M=a.getX(m+2);s=Wc(this,o,e,i,c,u,f,v,C,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}else if(l!==void 0)if(Array.isArray(o))for(let p=0,b=h.length;p<b;p++){let m=h[p],g=o[m.materialIndex],v=Math.max(m.start,d.start),C=Math.min(l.count,Math.min(m.start+m.count,d.start+d.count));for(let M=v,I=C;M<I;M+=3){let E=M,x=M+1,T=M+2;s=Wc(this,g,e,i,c,u,f,E,x,T),s&&(s.faceIndex=Math.floor(M/3),s.face.materialIndex=m.materialIndex,t.push(s))}}else{let p=Math.max(0,d.start),b=Math.min(l.count,d.start+d.count);for(let m=p,g=b;m<g;m+=3){let v=m,C=m+1,M=m+2;s=Wc(this,o,e,i,c,u,f,v,C,M),s&&(s.faceIndex=Math.floor(m/3),t.push(s))}}}};function yM(n,e,t,i,s,r,o,a){let l;if(e.side===hi?l=i.intersectTriangle(o,r,s,!0,a):l=i.intersectTriangle(s,r,o,e.side===Mr,a),l===null)return null;Gc.copy(a),Gc.applyMatrix4(n.matrixWorld);let c=t.ray.origin.distanceTo(Gc);return c<t.near||c>t.far?null:{distance:c,point:Gc.clone(),object:n}}function Wc(n,e,t,i,s,r,o,a,l,c){n.getVertexPosition(a,kc),n.getVertexPosition(l,zc),n.getVertexPosition(c,Vc);let u=yM(n,e,t,i,kc,zc,Vc,g_);if(u){let f=new z;dr.getBarycoord(g_,kc,zc,Vc,f),s&&(u.uv=dr.getInterpolatedAttribute(s,a,l,c,f,new Ze)),r&&(u.uv1=dr.getInterpolatedAttribute(r,a,l,c,f,new Ze)),o&&(u.normal=dr.getInterpolatedAttribute(o,a,l,c,f,new z),u.normal.dot(i.direction)>0&&u.normal.multiplyScalar(-1));let h={a,b:l,c,normal:new z,materialIndex:0};dr.getNormal(kc,zc,Vc,h.normal),u.face=h,u.barycoord=f}return u}var $o=class extends mi{constructor(e=null,t=1,i=1,s,r,o,a,l,c=cn,u=cn,f,h){super(null,o,a,l,c,u,s,r,f,h),this.isDataTexture=!0,this.image={data:e,width:t,height:i},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var Wr=new Vn,vM=new Ze(.5,.5),Xc=new z,mr=class{constructor(e=new li,t=new li,i=new li,s=new li,r=new li,o=new li){this.planes=[e,t,i,s,r,o]}set(e,t,i,s,r,o){let a=this.planes;return a[0].copy(e),a[1].copy(t),a[2].copy(i),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(e){let t=this.planes;for(let i=0;i<6;i++)t[i].copy(e.planes[i]);return this}setFromProjectionMatrix(e,t=Bi,i=!1){let s=this.planes,r=e.elements,o=r[0],a=r[1],l=r[2],c=r[3],u=r[4],f=r[5],h=r[6],d=r[7],p=r[8],b=r[9],m=r[10],g=r[11],v=r[12],C=r[13],M=r[14],I=r[15];if(s[0].setComponents(c-o,d-u,g-p,I-v).normalize(),s[1].setComponents(c+o,d+u,g+p,I+v).normalize(),s[2].setComponents(c+a,d+f,g+b,I+C).normalize(),s[3].setComponents(c-a,d-f,g-b,I-C).normalize(),i)s[4].setComponents(l,h,m,M).normalize(),s[5].setComponents(c-l,d-h,g-m,I-M).normalize();else if(s[4].setComponents(c-l,d-h,g-m,I-M).normalize(),t===Bi)s[5].setComponents(c+l,d+h,g+m,I+M).normalize();else if(t===Ho)s[5].setComponents(l,h,m,M).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+t);return this}intersectsObject(e){if(e.boundingSphere!==void 0)e.boundingSphere===null&&e.computeBoundingSphere(),Wr.copy(e.boundingSphere).applyMatrix4(e.matrixWorld);else{let t=e.geometry;t.boundingSphere===null&&t.computeBoundingSphere(),Wr.copy(t.boundingSphere).applyMatrix4(e.matrixWorld)}return this.intersectsSphere(Wr)}intersectsSprite(e){Wr.center.set(0,0,0);let t=vM.distanceTo(e.center);return Wr.radius=.7071067811865476+t,Wr.applyMatrix4(e.matrixWorld),this.intersectsSphere(Wr)}intersectsSphere(e){let t=this.planes,i=e.center,s=-e.radius;for(let r=0;r<6;r++)if(t[r].distanceToPoint(i)<s)return!1;return!0}intersectsBox(e){let t=this.planes;for(let i=0;i<6;i++){let s=t[i];if(Xc.x=s.normal.x>0?e.max.x:e.min.x,Xc.y=s.normal.y>0?e.max.y:e.min.y,Xc.z=s.normal.z>0?e.max.z:e.min.z,s.distanceToPoint(Xc)<0)return!1}return!0}containsPoint(e){let t=this.planes;for(let i=0;i<6;i++)if(t[i].distanceToPoint(e)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},__=new St,gu=class n{constructor(){this.coordinateSystem=Bi,this._frustums=[],this._count=0}setFromArrayCamera(e){let t=e.cameras,i=this._frustums;for(let s=0;s<t.length;s++){let r=t[s];__.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),i[s]===void 0&&(i[s]=new mr),i[s].setFromProjectionMatrix(__,r.coordinateSystem,r.reversedDepth)}return this._count=t.length,this}getFrustum(e){return this._frustums[e]}intersectsObject(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsObject(e))return!0;return!1}intersectsSprite(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSprite(e))return!0;return!1}intersectsSphere(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsSphere(e))return!0;return!1}intersectsBox(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].intersectsBox(e))return!0;return!1}containsPoint(e){let t=this._frustums;for(let i=0;i<this._count;i++)if(t[i].containsPoint(e))return!0;return!1}copy(e){this.coordinateSystem=e.coordinateSystem;let t=this._frustums,i=e._frustums;for(let s=0;s<e._count;s++)t[s]===void 0&&(t[s]=new mr),t[s].copy(i[s]);return this._count=e._count,this}clone(){return new n().copy(this)}};var gr=class extends ms{constructor(e){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new ut(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.linewidth=e.linewidth,this.linecap=e.linecap,this.linejoin=e.linejoin,this.fog=e.fog,this}},_u=new z,xu=new z,x_=new St,ka=new pr,qc=new Vn,Mf=new z,y_=new z,yu=class extends zn{constructor(e=new vn,t=new gr){super(),this.isLine=!0,this.type="Line",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[0];for(let s=1,r=t.count;s<r;s++)_u.fromBufferAttribute(t,s-1),xu.fromBufferAttribute(t,s),i[s]=i[s-1],i[s]+=_u.distanceTo(xu);e.setAttribute("lineDistance",new kn(i,1))}else $e("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Line.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),qc.copy(i.boundingSphere),qc.applyMatrix4(s),qc.radius+=r,e.ray.intersectsSphere(qc)===!1)return;x_.copy(s).invert(),ka.copy(e.ray).applyMatrix4(x_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=this.isLineSegments?2:1,u=i.index,h=i.attributes.position;if(u!==null){let d=Math.max(0,o.start),p=Math.min(u.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let g=u.getX(b),v=u.getX(b+1),C=Yc(this,e,ka,l,g,v,b);C&&t.push(C)}if(this.isLineLoop){let b=u.getX(p-1),m=u.getX(d),g=Yc(this,e,ka,l,b,m,p-1);g&&t.push(g)}}else{let d=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let b=d,m=p-1;b<m;b+=c){let g=Yc(this,e,ka,l,b,b+1,b);g&&t.push(g)}if(this.isLineLoop){let b=Yc(this,e,ka,l,p-1,d,p-1);b&&t.push(b)}}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Yc(n,e,t,i,s,r,o){let a=n.geometry.attributes.position;if(_u.fromBufferAttribute(a,s),xu.fromBufferAttribute(a,r),t.distanceSqToSegment(_u,xu,Mf,y_)>i)return;Mf.applyMatrix4(n.matrixWorld);let c=e.ray.origin.distanceTo(Mf);if(!(c<e.near||c>e.far))return{distance:c,point:y_.clone().applyMatrix4(n.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:n}}var v_=new z,b_=new z,Xr=class extends yu{constructor(e,t){super(e,t),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let e=this.geometry;if(e.index===null){let t=e.attributes.position,i=[];for(let s=0,r=t.count;s<r;s+=2)v_.fromBufferAttribute(t,s),b_.fromBufferAttribute(t,s+1),i[s]=s===0?0:i[s-1],i[s+1]=i[s]+v_.distanceTo(b_);e.setAttribute("lineDistance",new kn(i,1))}else $e("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var Jo=class extends ms{constructor(e){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new ut(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.alphaMap=e.alphaMap,this.size=e.size,this.sizeAttenuation=e.sizeAttenuation,this.fog=e.fog,this}},S_=new St,Pf=new pr,$c=new Vn,Jc=new z,Qa=class extends zn{constructor(e=new vn,t=new Jo){super(),this.isPoints=!0,this.type="Points",this.geometry=e,this.material=t,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(e,t){return super.copy(e,t),e.morphTargetInfluences!==void 0?this.morphTargetInfluences=e.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,e.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},e.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(e.material)?e.material.slice():e.material,this.geometry=e.geometry,this}intersectsFrustum(e){return e.intersectsObject(this)}raycast(e,t){let i=this.geometry,s=this.matrixWorld,r=e.params.Points.threshold,o=i.drawRange;if(i.boundingSphere===null&&i.computeBoundingSphere(),$c.copy(i.boundingSphere),$c.applyMatrix4(s),$c.radius+=r,e.ray.intersectsSphere($c)===!1)return;S_.copy(s).invert(),Pf.copy(e.ray).applyMatrix4(S_);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),l=a*a,c=i.index,f=i.attributes.position;if(c!==null){let h=Math.max(0,o.start),d=Math.min(c.count,o.start+o.count);for(let p=h,b=d;p<b;p++){let m=c.getX(p);Jc.fromBufferAttribute(f,m),M_(Jc,m,l,s,e,t,this)}}else{let h=Math.max(0,o.start),d=Math.min(f.count,o.start+o.count);for(let p=h,b=d;p<b;p++)Jc.fromBufferAttribute(f,p),M_(Jc,p,l,s,e,t,this)}}updateMorphTargets(){let t=this.geometry.morphAttributes,i=Object.keys(t);if(i.length>0){let s=t[i[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function M_(n,e,t,i,s,r,o){let a=Pf.distanceSqToPoint(n);if(a<t){let l=new z;Pf.closestPointToPoint(n,l),l.applyMatrix4(i);let c=s.ray.origin.distanceTo(l);if(c<s.near||c>s.far)return;r.push({distance:c,distanceToRay:Math.sqrt(a),point:l,index:e,face:null,faceIndex:null,barycoord:null,object:o})}}var el=class extends mi{constructor(e=[],t=$r,i,s,r,o,a,l,c,u){super(e,t,i,s,r,o,a,l,c,u),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(e){this.image=e}};var zs=class extends mi{constructor(e,t,i=Qi,s,r,o,a=cn,l=cn,c,u=Bs,f=1){if(u!==Bs&&u!==Hs)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let h={width:e,height:t,depth:f};super(h,s,r,o,a,l,u,i,c),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(e){return super.copy(e),this.source=new Xo(Object.assign({},e.image)),this.compareFunction=e.compareFunction,this}toJSON(e){let t=super.toJSON(e);return t.compareFunction=this.compareFunction,t}},tl=class extends zs{constructor(e,t=Qi,i=$r,s,r,o=cn,a=cn,l,c=Bs){let u={width:e,height:e,depth:1},f=[u,u,u,u,u,u];super(e,e,t,i,s,r,o,a,l,c),this.image=f,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(e){this.image=e}},nl=class extends mi{constructor(e=null){super(),this.sourceTexture=e,this.isExternalTexture=!0}copy(e){return super.copy(e),this.sourceTexture=e.sourceTexture,this}},Zo=class n extends vn{constructor(e=1,t=1,i=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:e,height:t,depth:i,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let l=[],c=[],u=[],f=[],h=0,d=0;p("z","y","x",-1,-1,i,t,e,o,r,0),p("z","y","x",1,-1,i,t,-e,o,r,1),p("x","z","y",1,1,e,i,t,s,o,2),p("x","z","y",1,-1,e,i,-t,s,o,3),p("x","y","z",1,-1,e,t,i,s,r,4),p("x","y","z",-1,-1,e,t,-i,s,r,5),this.setIndex(l),this.setAttribute("position",new kn(c,3)),this.setAttribute("normal",new kn(u,3)),this.setAttribute("uv",new kn(f,2));function p(b,m,g,v,C,M,I,E,x,T,V){let U=M/x,D=I/T,H=M/2,O=I/2,L=E/2,X=x+1,$=T+1,G=0,ue=0,Z=new z;for(let Q=0;Q<$;Q++){let ie=Q*D-O;for(let pe=0;pe<X;pe++){let fe=pe*U-H;Z[b]=fe*v,Z[m]=ie*C,Z[g]=L,c.push(Z.x,Z.y,Z.z),Z[b]=0,Z[m]=0,Z[g]=E>0?1:-1,u.push(Z.x,Z.y,Z.z),f.push(pe/x),f.push(1-Q/T),G+=1}}for(let Q=0;Q<T;Q++)for(let ie=0;ie<x;ie++){let pe=h+ie+X*Q,fe=h+ie+X*(Q+1),ee=h+(ie+1)+X*(Q+1),_e=h+(ie+1)+X*Q;l.push(pe,fe,_e),l.push(fe,ee,_e),ue+=6}a.addGroup(d,ue,V),d+=ue,h+=G}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.depth,e.widthSegments,e.heightSegments,e.depthSegments)}};var il=class n extends vn{constructor(e=1,t=1,i=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:e,height:t,widthSegments:i,heightSegments:s};let r=e/2,o=t/2,a=Math.floor(i),l=Math.floor(s),c=a+1,u=l+1,f=e/a,h=t/l,d=[],p=[],b=[],m=[];for(let g=0;g<u;g++){let v=g*h-o;for(let C=0;C<c;C++){let M=C*f-r;p.push(M,-v,0),b.push(0,0,1),m.push(C/a),m.push(1-g/l)}}for(let g=0;g<l;g++)for(let v=0;v<a;v++){let C=v+c*g,M=v+c*(g+1),I=v+1+c*(g+1),E=v+1+c*g;d.push(C,M,E),d.push(M,I,E)}this.setIndex(d),this.setAttribute("position",new kn(p,3)),this.setAttribute("normal",new kn(b,3)),this.setAttribute("uv",new kn(m,2))}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}static fromJSON(e){return new n(e.width,e.height,e.widthSegments,e.heightSegments)}};var sl=class extends vn{constructor(e=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:e},e!==null){let t=[],i=new Set,s=new z,r=new z;if(e.index!==null){let o=e.attributes.position,a=e.index,l=e.groups;l.length===0&&(l=[{start:0,count:a.count,materialIndex:0}]);for(let c=0,u=l.length;c<u;++c){let f=l[c],h=f.start,d=f.count;for(let p=h,b=h+d;p<b;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),v=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,v),w_(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}}else{let o=e.attributes.position;for(let a=0,l=o.count/3;a<l;a++)for(let c=0;c<3;c++){let u=3*a+c,f=3*a+(c+1)%3;s.fromBufferAttribute(o,u),r.fromBufferAttribute(o,f),w_(s,r,i)===!0&&(t.push(s.x,s.y,s.z),t.push(r.x,r.y,r.z))}}this.setAttribute("position",new kn(t,3))}}copy(e){return super.copy(e),this.parameters=Object.assign({},e.parameters),this}};function w_(n,e,t){let i=`${n.x},${n.y},${n.z}-${e.x},${e.y},${e.z}`,s=`${e.x},${e.y},${e.z}-${n.x},${n.y},${n.z}`;return t.has(i)===!0||t.has(s)===!0?!1:(t.add(i),t.add(s),!0)}function Zr(n){let e={};for(let t in n){e[t]={};for(let i in n[t]){let s=n[t][i];if(A_(s))s.isRenderTargetTexture?($e("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),e[t][i]=null):e[t][i]=s.clone();else if(Array.isArray(s))if(A_(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();e[t][i]=r}else e[t][i]=s.slice();else e[t][i]=s}}return e}function ei(n){let e={};for(let t=0;t<n.length;t++){let i=Zr(n[t]);for(let s in i)e[s]=i[s]}return e}function A_(n){return n&&(n.isColor||n.isMatrix3||n.isMatrix4||n.isVector2||n.isVector3||n.isVector4||n.isTexture||n.isQuaternion)}function bM(n){let e=[];for(let t=0;t<n.length;t++)e.push(n[t].clone());return e}function up(n){let e=n.getRenderTarget();return e===null?n.outputColorSpace:e.isXRRenderTarget===!0?e.texture.colorSpace:vt.workingColorSpace}var wl={clone:Zr,merge:ei},SM=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,MM=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,ki=class extends ms{constructor(e){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=SM,this.fragmentShader=MM,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,e!==void 0&&this.setValues(e)}copy(e){return super.copy(e),this.fragmentShader=e.fragmentShader,this.vertexShader=e.vertexShader,this.uniforms=Zr(e.uniforms),this.uniformsGroups=bM(e.uniformsGroups),this.defines=Object.assign({},e.defines),this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.fog=e.fog,this.lights=e.lights,this.clipping=e.clipping,this.extensions=Object.assign({},e.extensions),this.glslVersion=e.glslVersion,this.defaultAttributeValues=Object.assign({},e.defaultAttributeValues),this.index0AttributeName=e.index0AttributeName,this.uniformsNeedUpdate=e.uniformsNeedUpdate,this}toJSON(e){let t=super.toJSON(e);t.glslVersion=this.glslVersion,t.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?t.uniforms[s]={type:"t",value:o.toJSON(e).uuid}:o&&o.isColor?t.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?t.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?t.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?t.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?t.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?t.uniforms[s]={type:"m4",value:o.toArray()}:t.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(t.defines=this.defines),t.vertexShader=this.vertexShader,t.fragmentShader=this.fragmentShader,t.lights=this.lights,t.clipping=this.clipping;let i={};for(let s in this.extensions)this.extensions[s]===!0&&(i[s]=!0);return Object.keys(i).length>0&&(t.extensions=i),t}fromJSON(e,t){if(super.fromJSON(e,t),e.uniforms!==void 0)for(let i in e.uniforms){let s=e.uniforms[i];switch(this.uniforms[i]={},s.type){case"t":this.uniforms[i].value=t[s.value]||null;break;case"c":this.uniforms[i].value=new ut().setHex(s.value);break;case"v2":this.uniforms[i].value=new Ze().fromArray(s.value);break;case"v3":this.uniforms[i].value=new z().fromArray(s.value);break;case"v4":this.uniforms[i].value=new Pt().fromArray(s.value);break;case"m3":this.uniforms[i].value=new st().fromArray(s.value);break;case"m4":this.uniforms[i].value=new St().fromArray(s.value);break;default:this.uniforms[i].value=s.value}}if(e.defines!==void 0&&(this.defines=e.defines),e.vertexShader!==void 0&&(this.vertexShader=e.vertexShader),e.fragmentShader!==void 0&&(this.fragmentShader=e.fragmentShader),e.glslVersion!==void 0&&(this.glslVersion=e.glslVersion),e.extensions!==void 0)for(let i in e.extensions)this.extensions[i]=e.extensions[i];return e.lights!==void 0&&(this.lights=e.lights),e.clipping!==void 0&&(this.clipping=e.clipping),this}},vu=class extends ki{constructor(e){super(e),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var rl=class extends ms{constructor(e){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new ut(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new ut(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=bh,this.normalScale=new Ze(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new ks,this.combine=Uu,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(e)}copy(e){return super.copy(e),this.color.copy(e.color),this.map=e.map,this.lightMap=e.lightMap,this.lightMapIntensity=e.lightMapIntensity,this.aoMap=e.aoMap,this.aoMapIntensity=e.aoMapIntensity,this.emissive.copy(e.emissive),this.emissiveMap=e.emissiveMap,this.emissiveIntensity=e.emissiveIntensity,this.bumpMap=e.bumpMap,this.bumpScale=e.bumpScale,this.normalMap=e.normalMap,this.normalMapType=e.normalMapType,this.normalScale.copy(e.normalScale),this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.specularMap=e.specularMap,this.alphaMap=e.alphaMap,this.envMap=e.envMap,this.envMapRotation.copy(e.envMapRotation),this.combine=e.combine,this.reflectivity=e.reflectivity,this.envMapIntensity=e.envMapIntensity,this.refractionRatio=e.refractionRatio,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this.wireframeLinecap=e.wireframeLinecap,this.wireframeLinejoin=e.wireframeLinejoin,this.flatShading=e.flatShading,this.fog=e.fog,this}},bu=class extends ms{constructor(e){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=ix,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(e)}copy(e){return super.copy(e),this.depthPacking=e.depthPacking,this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this.wireframe=e.wireframe,this.wireframeLinewidth=e.wireframeLinewidth,this}},Su=class extends ms{constructor(e){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(e)}copy(e){return super.copy(e),this.map=e.map,this.alphaMap=e.alphaMap,this.displacementMap=e.displacementMap,this.displacementScale=e.displacementScale,this.displacementBias=e.displacementBias,this}};function Oo(n,e){return!n||n.constructor===e?n:typeof e.BYTES_PER_ELEMENT=="number"?new e(n):Array.prototype.slice.call(n)}function Zc(n){return n!==void 0&&n.inTangents!==void 0&&n.outTangents!==void 0}var _r=class{constructor(e,t,i,s){this.parameterPositions=e,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new t.constructor(i),this.sampleValues=t,this.valueSize=i,this.settings=null,this.DefaultSettings_={}}evaluate(e){let t=this.parameterPositions,i=this._cachedIndex,s=t[i],r=t[i-1];e:{t:{let o;n:{i:if(!(e<s)){for(let a=i+2;;){if(s===void 0){if(e<r)break i;return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}if(i===a)break;if(r=s,s=t[++i],e<s)break t}o=t.length;break n}if(!(e>=r)){let a=t[1];e<a&&(i=2,r=a);for(let l=i-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(i===l)break;if(s=r,r=t[--i-1],e>=r)break t}o=i,i=0;break n}break e}for(;i<o;){let a=i+o>>>1;e<t[a]?o=a:i=a+1}if(s=t[i],r=t[i-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return i=t.length,this._cachedIndex=i,this.copySampleValue_(i-1)}this._cachedIndex=i,this.intervalChanged_(i,r,s)}return this.interpolate_(i,r,e,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(e){let t=this.resultBuffer,i=this.sampleValues,s=this.valueSize,r=e*s;for(let o=0;o!==s;++o)t[o]=i[r+o];return t}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},Mu=class extends _r{constructor(e,t,i,s){super(e,t,i,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Ef,endingEnd:Ef}}intervalChanged_(e,t,i){let s=this.parameterPositions,r=e-2,o=e+1,a=s[r],l=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Cf:r=e,a=2*t-i;break;case Rf:r=s.length-2,a=t+s[r]-s[r+1];break;default:r=e,a=i}if(l===void 0)switch(this.getSettings_().endingEnd){case Cf:o=e,l=2*i-t;break;case Rf:o=1,l=i+s[1]-s[0];break;default:o=e-1,l=t}let c=(i-t)*.5,u=this.valueSize;this._weightPrev=c/(t-a),this._weightNext=c/(l-i),this._offsetPrev=r*u,this._offsetNext=o*u}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this._offsetPrev,f=this._offsetNext,h=this._weightPrev,d=this._weightNext,p=(i-t)/(s-t),b=p*p,m=b*p,g=-h*m+2*h*b-h*p,v=(1+h)*m+(-1.5-2*h)*b+(-.5+h)*p+1,C=(-1-d)*m+(1.5+d)*b+.5*p,M=d*m-d*b;for(let I=0;I!==a;++I)r[I]=g*o[u+I]+v*o[c+I]+C*o[l+I]+M*o[f+I];return r}},wu=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=(i-t)/(s-t),f=1-u;for(let h=0;h!==a;++h)r[h]=o[c+h]*f+o[l+h]*u;return r}},Au=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e){return this.copySampleValue_(e-1)}},Tu=class extends _r{interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=e*a,c=l-a,u=this.inTangents,f=this.outTangents;if(!u||!f){let p=(i-t)/(s-t),b=1-p;for(let m=0;m!==a;++m)r[m]=o[c+m]*b+o[l+m]*p;return r}let h=a*2,d=e-1;for(let p=0;p!==a;++p){let b=o[c+p],m=o[l+p],g=d*h+p*2,v=f[g],C=f[g+1],M=e*h+p*2,I=u[M],E=u[M+1],x=AM(i,t,v,I,s);r[p]=gx(x,b,C,E,m)}return r}};function gx(n,e,t,i,s){let r=1-n;return r*r*r*e+3*r*r*n*t+3*r*n*n*i+n*n*n*s}function wM(n,e,t,i,s){let r=1-n;return 3*r*r*(t-e)+6*r*n*(i-t)+3*n*n*(s-i)}function AM(n,e,t,i,s){let r=(n-e)/(s-e);for(let o=0;o<8;o++){let a=gx(r,e,t,i,s)-n;if(Math.abs(a)<1e-10)break;let l=wM(r,e,t,i,s);if(Math.abs(l)<1e-10)break;r=Math.max(0,Math.min(1,r-a/l))}return r}var Pi=class{constructor(e,t,i,s){if(e===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(t===void 0||t.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+e);this.name=e,this.times=Oo(t,this.TimeBufferType),this.values=Oo(i,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(e){let t=e.constructor,i;if(t.toJSON!==this.toJSON)i=t.toJSON(e);else{i={name:e.name,times:Oo(e.times,Array),values:Oo(e.values,Array)};let s=e.getInterpolation();s!==e.DefaultInterpolation&&(i.interpolation=s),Zc(e.settings)&&(i.settings={inTangents:Oo(e.settings.inTangents,Array),outTangents:Oo(e.settings.outTangents,Array)})}return i.type=e.ValueTypeName,i}InterpolantFactoryMethodDiscrete(e){return new Au(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodLinear(e){return new wu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodSmooth(e){return new Mu(this.times,this.values,this.getValueSize(),e)}InterpolantFactoryMethodBezier(e){let t=new Tu(this.times,this.values,this.getValueSize(),e);return this.settings&&(t.inTangents=this.settings.inTangents,t.outTangents=this.settings.outTangents),t}setInterpolation(e){let t;switch(e){case Ga:t=this.InterpolantFactoryMethodDiscrete;break;case hu:t=this.InterpolantFactoryMethodLinear;break;case eu:t=this.InterpolantFactoryMethodSmooth;break;case Tf:t=this.InterpolantFactoryMethodBezier;break}if(t===void 0){let i="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(e!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(i);return $e("KeyframeTrack:",i),this}return this.createInterpolant=t,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return Ga;case this.InterpolantFactoryMethodLinear:return hu;case this.InterpolantFactoryMethodSmooth:return eu;case this.InterpolantFactoryMethodBezier:return Tf}}getValueSize(){return this.values.length/this.times.length}shift(e){if(e!==0){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]+=e;Zc(this.settings)&&(T_(this.settings.inTangents,e),T_(this.settings.outTangents,e))}return this}scale(e){if(e!==1){let t=this.times;for(let i=0,s=t.length;i!==s;++i)t[i]*=e;Zc(this.settings)&&(E_(this.settings.inTangents,e),E_(this.settings.outTangents,e))}return this}trim(e,t){let i=this.times,s=i.length,r=0,o=s-1;for(;r!==s&&i[r]<e;)++r;for(;o!==-1&&i[o]>t;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=i.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let e=!0,t=this.getValueSize();t-Math.floor(t)!==0&&(it("KeyframeTrack: Invalid value size in track.",this),e=!1);let i=this.times,s=this.values,r=i.length;r===0&&(it("KeyframeTrack: Track is empty.",this),e=!1);let o=null;for(let a=0;a!==r;a++){let l=i[a];if(typeof l=="number"&&isNaN(l)){it("KeyframeTrack: Time is not a valid number.",this,a,l),e=!1;break}if(o!==null&&o>l){it("KeyframeTrack: Out of order keys.",this,a,l,o),e=!1;break}o=l}if(s!==void 0&&VS(s))for(let a=0,l=s.length;a!==l;++a){let c=s[a];if(isNaN(c)){it("KeyframeTrack: Value is not a valid number.",this,a,c),e=!1;break}}return e}optimize(){let e=this.times.slice(),t=this.values.slice(),i=this.getValueSize(),s=this.getInterpolation()===eu,r=e.length-1,o=1;for(let a=1;a<r;++a){let l=!1,c=e[a],u=e[a+1];if(c!==u&&(a!==1||c!==e[0]))if(s)l=!0;else{let f=a*i,h=f-i,d=f+i;for(let p=0;p!==i;++p){let b=t[f+p];if(b!==t[h+p]||b!==t[d+p]){l=!0;break}}}if(l){if(a!==o){e[o]=e[a];let f=a*i,h=o*i;for(let d=0;d!==i;++d)t[h+d]=t[f+d]}++o}}if(r>0){e[o]=e[r];for(let a=r*i,l=o*i,c=0;c!==i;++c)t[l+c]=t[a+c];++o}return o!==e.length?(this.times=e.slice(0,o),this.values=t.slice(0,o*i)):(this.times=e,this.values=t),this}clone(){let e=this.times.slice(),t=this.values.slice(),i=this.constructor,s=new i(this.name,e,t);return s.createInterpolant=this.createInterpolant,Zc(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function T_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]+=e}function E_(n,e){for(let t=0,i=n.length;t!==i;t+=2)n[t]*=e}Pi.prototype.ValueTypeName="";Pi.prototype.TimeBufferType=Float32Array;Pi.prototype.ValueBufferType=Float32Array;Pi.prototype.DefaultInterpolation=hu;var xr=class extends Pi{constructor(e,t,i){super(e,t,i)}};xr.prototype.ValueTypeName="bool";xr.prototype.ValueBufferType=Array;xr.prototype.DefaultInterpolation=Ga;xr.prototype.InterpolantFactoryMethodLinear=void 0;xr.prototype.InterpolantFactoryMethodSmooth=void 0;var Eu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Eu.prototype.ValueTypeName="color";var Cu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Cu.prototype.ValueTypeName="number";var Ru=class extends _r{constructor(e,t,i,s){super(e,t,i,s)}interpolate_(e,t,i,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,l=(i-t)/(s-t),c=e*a;for(let u=c+a;c!==u;c+=4)Ci.slerpFlat(r,0,o,c-a,o,c,l);return r}},ol=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}InterpolantFactoryMethodLinear(e){return new Ru(this.times,this.values,this.getValueSize(),e)}};ol.prototype.ValueTypeName="quaternion";ol.prototype.InterpolantFactoryMethodSmooth=void 0;var yr=class extends Pi{constructor(e,t,i){super(e,t,i)}};yr.prototype.ValueTypeName="string";yr.prototype.ValueBufferType=Array;yr.prototype.DefaultInterpolation=Ga;yr.prototype.InterpolantFactoryMethodLinear=void 0;yr.prototype.InterpolantFactoryMethodSmooth=void 0;var Pu=class extends Pi{constructor(e,t,i,s){super(e,t,i,s)}};Pu.prototype.ValueTypeName="vector";var Iu=class{constructor(e,t,i){let s=this,r=!1,o=0,a=0,l,c=[];this.onStart=void 0,this.onLoad=e,this.onProgress=t,this.onError=i,this._abortController=null,this.itemStart=function(u){a++,r===!1&&s.onStart!==void 0&&s.onStart(u,o,a),r=!0},this.itemEnd=function(u){o++,s.onProgress!==void 0&&s.onProgress(u,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(u){s.onError!==void 0&&s.onError(u)},this.resolveURL=function(u){return u=u.normalize("NFC"),l?l(u):u},this.setURLModifier=function(u){return l=u,this},this.addHandler=function(u,f){return c.push(u,f),this},this.removeHandler=function(u){let f=c.indexOf(u);return f!==-1&&c.splice(f,2),this},this.getHandler=function(u){for(let f=0,h=c.length;f<h;f+=2){let d=c[f],p=c[f+1];if(d.global&&(d.lastIndex=0),d.test(u))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},_x=new Iu,Lu=class{constructor(e){this.manager=e!==void 0?e:_x,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(e,t){let i=this;return new Promise(function(s,r){i.load(e,s,t,r)})}parse(){}setCrossOrigin(e){return this.crossOrigin=e,this}setWithCredentials(e){return this.withCredentials=e,this}setPath(e){return this.path=e,this}setResourcePath(e){return this.resourcePath=e,this}setRequestHeader(e){return this.requestHeader=e,this}setPriority(e){return this.priority=e,this}setCache(e){return this.cache=e,this}abort(){return this}};Lu.DEFAULT_MATERIAL_NAME="__DEFAULT";var al=class extends zn{static registerNode(e){this.prototype._lightNode=e}constructor(e,t=1){super(),this.isLight=!0,this.type="Light",this.color=new ut(e),this.intensity=t}copy(e,t){return super.copy(e,t),this.color.copy(e.color),this.intensity=e.intensity,this}toJSON(e){let t=super.toJSON(e);return t.object.color=this.color.getHex(),t.object.intensity=this.intensity,t}},ll=class extends al{constructor(e,t,i){super(e,i),this.isHemisphereLight=!0,this.type="HemisphereLight",this.position.copy(zn.DEFAULT_UP),this.updateMatrix(),this.groundColor=new ut(t)}copy(e,t){return super.copy(e,t),this.groundColor.copy(e.groundColor),this}toJSON(e){let t=super.toJSON(e);return t.object.groundColor=this.groundColor.getHex(),t}},wf=new St,C_=new z,R_=new z,Du=class{constructor(e){this.camera=e,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Ze(512,512),this.mapType=_i,this.map=null,this.mapPass=null,this.matrix=new St,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new mr,this._frameExtents=new Ze(1,1),this._viewportCount=1,this._viewports=[new Pt(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(e){let t=this.camera;C_.setFromMatrixPosition(e.matrixWorld),t.position.copy(C_),R_.setFromMatrixPosition(e.target.matrixWorld),t.lookAt(R_),t.updateMatrixWorld(),this._updateMatrix(t,this.matrix,this._frustum)}_updateMatrix(e,t,i,s){wf.multiplyMatrices(e.projectionMatrix,e.matrixWorldInverse),i.setFromProjectionMatrix(wf,e.coordinateSystem,e.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,l=s?s.x/r.x:0,c=s?s.y/r.y:0;e.coordinateSystem===Ho||e.reversedDepth?t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,1,0,0,0,0,1):t.set(.5*o,0,0,.5*o+l,0,.5*a,0,.5*a+c,0,0,.5,.5,0,0,0,1),t.multiply(wf)}getViewport(e){return this._viewports[e]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(e){return this.camera=e.camera.clone(),this.intensity=e.intensity,this.bias=e.bias,this.radius=e.radius,this.autoUpdate=e.autoUpdate,this.needsUpdate=e.needsUpdate,this.normalBias=e.normalBias,this.blurSamples=e.blurSamples,this.mapSize.copy(e.mapSize),this.mapType=e.mapType,this.biasNode=e.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let e={};return e.intensity=this.intensity,e.bias=this.bias,e.normalBias=this.normalBias,e.radius=this.radius,e.blurSamples=this.blurSamples,e.mapSize=this.mapSize.toArray(),e.mapType=this.mapType,e.camera=this.camera.toJSON(!1).object,delete e.camera.matrix,e}},Kc=new z,jc=new Ci,fs=new z,cl=class extends zn{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new St,this.projectionMatrix=new St,this.projectionMatrixInverse=new St,this.coordinateSystem=Bi,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(e,t){return super.copy(e,t),this.matrixWorldInverse.copy(e.matrixWorldInverse),this.projectionMatrix.copy(e.projectionMatrix),this.projectionMatrixInverse.copy(e.projectionMatrixInverse),this.coordinateSystem=e.coordinateSystem,this}getWorldDirection(e){return super.getWorldDirection(e).negate()}updateMatrixWorld(e){super.updateMatrixWorld(e),this.matrixWorld.decompose(Kc,jc,fs),fs.x===1&&fs.y===1&&fs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Kc,jc,fs.set(1,1,1)).invert()}updateWorldMatrix(e,t,i=!1){super.updateWorldMatrix(e,t,i),this.matrixWorld.decompose(Kc,jc,fs),fs.x===1&&fs.y===1&&fs.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Kc,jc,fs.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},hr=new z,P_=new Ze,I_=new Ze,ci=class extends cl{constructor(e=50,t=1,i=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=e,this.zoom=1,this.near=i,this.far=s,this.focus=10,this.aspect=t,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.fov=e.fov,this.zoom=e.zoom,this.near=e.near,this.far=e.far,this.focus=e.focus,this.aspect=e.aspect,this.view=e.view===null?null:Object.assign({},e.view),this.filmGauge=e.filmGauge,this.filmOffset=e.filmOffset,this}setFocalLength(e){let t=.5*this.getFilmHeight()/e;this.fov=Wo*2*Math.atan(t),this.updateProjectionMatrix()}getFocalLength(){let e=Math.tan(Va*.5*this.fov);return .5*this.getFilmHeight()/e}getEffectiveFOV(){return Wo*2*Math.atan(Math.tan(Va*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(e,t,i){hr.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),t.set(hr.x,hr.y).multiplyScalar(-e/hr.z),hr.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),i.set(hr.x,hr.y).multiplyScalar(-e/hr.z)}getViewSize(e,t){return this.getViewBounds(e,P_,I_),t.subVectors(I_,P_)}setViewOffset(e,t,i,s,r,o){this.aspect=e/t,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=this.near,t=e*Math.tan(Va*.5*this.fov)/this.zoom,i=2*t,s=this.aspect*i,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let l=o.fullWidth,c=o.fullHeight;r+=o.offsetX*s/l,t-=o.offsetY*i/c,s*=o.width/l,i*=o.height/c}let a=this.filmOffset;a!==0&&(r+=e*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,t,t-i,e,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.fov=this.fov,t.object.zoom=this.zoom,t.object.near=this.near,t.object.far=this.far,t.object.focus=this.focus,t.object.aspect=this.aspect,this.view!==null&&(t.object.view=Object.assign({},this.view)),t.object.filmGauge=this.filmGauge,t.object.filmOffset=this.filmOffset,t}};var ul=class extends cl{constructor(e=-1,t=1,i=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=e,this.right=t,this.top=i,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(e,t){return super.copy(e,t),this.left=e.left,this.right=e.right,this.top=e.top,this.bottom=e.bottom,this.near=e.near,this.far=e.far,this.zoom=e.zoom,this.view=e.view===null?null:Object.assign({},e.view),this}setViewOffset(e,t,i,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=e,this.view.fullHeight=t,this.view.offsetX=i,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let e=(this.right-this.left)/(2*this.zoom),t=(this.top-this.bottom)/(2*this.zoom),i=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=i-e,o=i+e,a=s+t,l=s-t;if(this.view!==null&&this.view.enabled){let c=(this.right-this.left)/this.view.fullWidth/this.zoom,u=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=c*this.view.offsetX,o=r+c*this.view.width,a-=u*this.view.offsetY,l=a-u*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,l,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(e){let t=super.toJSON(e);return t.object.zoom=this.zoom,t.object.left=this.left,t.object.right=this.right,t.object.top=this.top,t.object.bottom=this.bottom,t.object.near=this.near,t.object.far=this.far,this.view!==null&&(t.object.view=Object.assign({},this.view)),t}},If=class extends Du{constructor(){super(new ul(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},hl=class extends al{constructor(e,t){super(e,t),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy(zn.DEFAULT_UP),this.updateMatrix(),this.target=new zn,this.shadow=new If}dispose(){super.dispose(),this.shadow.dispose()}copy(e){return super.copy(e),this.target=e.target.clone(),this.shadow=e.shadow.clone(),this}toJSON(e){let t=super.toJSON(e);return t.object.shadow=this.shadow.toJSON(),t.object.target=this.target.uuid,t}};var dl=class extends vn{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(e){return super.copy(e),this.instanceCount=e.instanceCount,this}toJSON(){let e=super.toJSON();return e.instanceCount=this.instanceCount,e.isInstancedBufferGeometry=!0,e}};var Fo=-90,Bo=1,Ko=class extends zn{constructor(e,t,i){super(),this.type="CubeCamera",this.renderTarget=i,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new ci(Fo,Bo,e,t);s.layers=this.layers,this.add(s);let r=new ci(Fo,Bo,e,t);r.layers=this.layers,this.add(r);let o=new ci(Fo,Bo,e,t);o.layers=this.layers,this.add(o);let a=new ci(Fo,Bo,e,t);a.layers=this.layers,this.add(a);let l=new ci(Fo,Bo,e,t);l.layers=this.layers,this.add(l);let c=new ci(Fo,Bo,e,t);c.layers=this.layers,this.add(c)}updateCoordinateSystem(){let e=this.coordinateSystem,t=this.children.concat(),[i,s,r,o,a,l]=t;for(let c of t)this.remove(c);if(e===Bi)i.up.set(0,1,0),i.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),l.up.set(0,1,0),l.lookAt(0,0,-1);else if(e===Ho)i.up.set(0,-1,0),i.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),l.up.set(0,-1,0),l.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+e);for(let c of t)this.add(c),c.updateMatrixWorld()}update(e,t){this.parent===null&&this.updateMatrixWorld();let{renderTarget:i,activeMipmapLevel:s}=this;this.coordinateSystem!==e.coordinateSystem&&(this.coordinateSystem=e.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,l,c,u]=this.children,f=e.getRenderTarget(),h=e.getActiveCubeFace(),d=e.getActiveMipmapLevel(),p=e.xr.enabled;e.xr.enabled=!1;let b=i.texture.mipmapsAutoUpdate;i.texture.mipmapsAutoUpdate=!1;let m=!1;e.isWebGLRenderer===!0?m=e.state.buffers.depth.getReversed():m=e.reversedDepthBuffer,e.setRenderTarget(i,0,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,r),e.setRenderTarget(i,1,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,o),e.setRenderTarget(i,2,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,a),e.setRenderTarget(i,3,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,l),e.setRenderTarget(i,4,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,c),i.texture.mipmapsAutoUpdate=b,e.setRenderTarget(i,5,s),m&&e.autoClear===!1&&e.clearDepth(),e.render(t,u),e.setRenderTarget(f,h,d),e.xr.enabled=p,i.texture.needsPMREMUpdate=!0}},Nu=class extends ci{constructor(e=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=e,this.perCameraFrustumCulled=!1}};var hp="\\[\\]\\.:\\/",TM=new RegExp("["+hp+"]","g"),dp="[^"+hp+"]",EM="[^"+hp.replace("\\.","")+"]",CM=/((?:WC+[\/:])*)/.source.replace("WC",dp),RM=/(WCOD+)?/.source.replace("WCOD",EM),PM=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",dp),IM=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",dp),LM=new RegExp("^"+CM+RM+PM+IM+"$"),DM=["material","materials","bones","map"],Lf=class{constructor(e,t,i){let s=i||Jt.parseTrackName(t);this._targetGroup=e,this._bindings=e.subscribe_(t,s)}getValue(e,t){this.bind();let i=this._targetGroup.nCachedObjects_,s=this._bindings[i];s!==void 0&&s.getValue(e,t)}setValue(e,t){let i=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=i.length;s!==r;++s)i[s].setValue(e,t)}bind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].bind()}unbind(){let e=this._bindings;for(let t=this._targetGroup.nCachedObjects_,i=e.length;t!==i;++t)e[t].unbind()}},Jt=class n{constructor(e,t,i){this.path=t,this.parsedPath=i||n.parseTrackName(t),this.node=n.findNode(e,this.parsedPath.nodeName),this.rootNode=e,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(e,t,i){return e&&e.isAnimationObjectGroup?new n.Composite(e,t,i):new n(e,t,i)}static sanitizeNodeName(e){return e.replace(/\s/g,"_").replace(TM,"")}static parseTrackName(e){let t=LM.exec(e);if(t===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+e);let i={nodeName:t[2],objectName:t[3],objectIndex:t[4],propertyName:t[5],propertyIndex:t[6]},s=i.nodeName&&i.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=i.nodeName.substring(s+1);DM.indexOf(r)!==-1&&(i.nodeName=i.nodeName.substring(0,s),i.objectName=r)}if(i.propertyName===null||i.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+e);return i}static findNode(e,t){if(t===void 0||t===""||t==="."||t===-1||t===e.name||t===e.uuid)return e;if(e.skeleton){let i=e.skeleton.getBoneByName(t);if(i!==void 0)return i}if(e.children){let i=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===t||a.uuid===t)return a;let l=i(a.children);if(l)return l}return null},s=i(e.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(e,t){e[t]=this.targetObject[this.propertyName]}_getValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)e[t++]=i[s]}_getValue_arrayElement(e,t){e[t]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(e,t){this.resolvedProperty.toArray(e,t)}_setValue_direct(e,t){this.targetObject[this.propertyName]=e[t]}_setValue_direct_setNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(e,t){this.targetObject[this.propertyName]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++]}_setValue_array_setNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(e,t){let i=this.resolvedProperty;for(let s=0,r=i.length;s!==r;++s)i[s]=e[t++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(e,t){this.resolvedProperty[this.propertyIndex]=e[t]}_setValue_arrayElement_setNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty[this.propertyIndex]=e[t],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(e,t){this.resolvedProperty.fromArray(e,t)}_setValue_fromArray_setNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(e,t){this.resolvedProperty.fromArray(e,t),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(e,t){this.bind(),this.getValue(e,t)}_setValue_unbound(e,t){this.bind(),this.setValue(e,t)}bind(){let e=this.node,t=this.parsedPath,i=t.objectName,s=t.propertyName,r=t.propertyIndex;if(e||(e=n.findNode(this.rootNode,t.nodeName),this.node=e),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!e){$e("PropertyBinding: No target node found for track: "+this.path+".");return}if(i){let c=t.objectIndex;switch(i){case"materials":if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.materials){it("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}e=e.material.materials;break;case"bones":if(!e.skeleton){it("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}e=e.skeleton.bones;for(let u=0;u<e.length;u++)if(e[u].name===c){c=u;break}break;case"map":if("map"in e){e=e.map;break}if(!e.material){it("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!e.material.map){it("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}e=e.material.map;break;default:if(e[i]===void 0){it("PropertyBinding: Can not bind to objectName of node undefined.",this);return}e=e[i]}if(c!==void 0){if(e[c]===void 0){it("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,e);return}e=e[c]}}let o=e[s];if(o===void 0){let c=t.nodeName;it("PropertyBinding: Trying to update property for track: "+c+"."+s+" but it wasn't found.",e);return}let a=this.Versioning.None;this.targetObject=e,e.isMaterial===!0?a=this.Versioning.NeedsUpdate:e.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let l=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!e.geometry){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!e.geometry.morphAttributes){it("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}e.morphTargetDictionary[r]!==void 0&&(r=e.morphTargetDictionary[r])}l=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(l=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(l=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[l],this.setValue=this.SetterByBindingTypeAndVersioning[l][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};Jt.Composite=Lf;Jt.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};Jt.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};Jt.prototype.GetterByBindingType=[Jt.prototype._getValue_direct,Jt.prototype._getValue_array,Jt.prototype._getValue_arrayElement,Jt.prototype._getValue_toArray];Jt.prototype.SetterByBindingTypeAndVersioning=[[Jt.prototype._setValue_direct,Jt.prototype._setValue_direct_setNeedsUpdate,Jt.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_array,Jt.prototype._setValue_array_setNeedsUpdate,Jt.prototype._setValue_array_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_arrayElement,Jt.prototype._setValue_arrayElement_setNeedsUpdate,Jt.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[Jt.prototype._setValue_fromArray,Jt.prototype._setValue_fromArray_setNeedsUpdate,Jt.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var x2=new Float32Array(1);var vr=class extends mu{constructor(e,t,i=1){super(e,t),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=i}copy(e){return super.copy(e),this.meshPerAttribute=e.meshPerAttribute,this}clone(e){let t=super.clone(e);return t.meshPerAttribute=this.meshPerAttribute,t}toJSON(e){let t=super.toJSON(e);return t.isInstancedInterleavedBuffer=!0,t.meshPerAttribute=this.meshPerAttribute,t}};var jo=class{constructor(e=1,t=0,i=0){this.radius=e,this.phi=t,this.theta=i}set(e,t,i){return this.radius=e,this.phi=t,this.theta=i,this}copy(e){return this.radius=e.radius,this.phi=e.phi,this.theta=e.theta,this}makeSafe(){return this.phi=lt(this.phi,1e-6,Math.PI-1e-6),this}setFromVector3(e){return this.setFromCartesianCoords(e.x,e.y,e.z)}setFromCartesianCoords(e,t,i){return this.radius=Math.sqrt(e*e+t*t+i*i),this.radius===0?(this.theta=0,this.phi=0):(this.theta=Math.atan2(e,i),this.phi=Math.acos(lt(t/this.radius,-1,1))),this}clone(){return new this.constructor().copy(this)}};var Df=class{static{this.prototype.isMatrix2=!0}constructor(e,t,i,s){this.elements=[1,0,0,1],e!==void 0&&this.set(e,t,i,s)}identity(){return this.set(1,0,0,1),this}fromArray(e,t=0){for(let i=0;i<4;i++)this.elements[i]=e[i+t];return this}set(e,t,i,s){let r=this.elements;return r[0]=e,r[2]=t,r[1]=i,r[3]=s,this}};var L_=new z,Qc=new z,ko=new z,zo=new z,Af=new z,NM=new z,UM=new z,fl=class{constructor(e=new z,t=new z){this.start=e,this.end=t}set(e,t){return this.start.copy(e),this.end.copy(t),this}copy(e){return this.start.copy(e.start),this.end.copy(e.end),this}getCenter(e){return e.addVectors(this.start,this.end).multiplyScalar(.5)}delta(e){return e.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(e,t){return this.delta(t).multiplyScalar(e).add(this.start)}closestPointToPointParameter(e,t){L_.subVectors(e,this.start),Qc.subVectors(this.end,this.start);let i=Qc.dot(Qc);if(i===0)return 0;let r=Qc.dot(L_)/i;return t&&(r=lt(r,0,1)),r}closestPointToPoint(e,t,i){let s=this.closestPointToPointParameter(e,t);return this.delta(i).multiplyScalar(s).add(this.start)}distanceSqToLine3(e,t=NM,i=UM){let s=10000000000000001e-32,r,o,a=this.start,l=e.start,c=this.end,u=e.end;ko.subVectors(c,a),zo.subVectors(u,l),Af.subVectors(a,l);let f=ko.dot(ko),h=zo.dot(zo),d=zo.dot(Af);if(f<=s&&h<=s)return t.copy(a),i.copy(l),t.distanceToSquared(i);if(f<=s)r=0,o=d/h,o=lt(o,0,1);else{let p=ko.dot(Af);if(h<=s)o=0,r=lt(-p/f,0,1);else{let b=ko.dot(zo),m=f*h-b*b;m!==0?r=lt((b*d-p*h)/m,0,1):r=0,o=(b*r+d)/h,o<0?(o=0,r=lt(-p/f,0,1)):o>1&&(o=1,r=lt((b-p)/f,0,1))}}return t.copy(a).addScaledVector(ko,r),i.copy(l).addScaledVector(zo,o),t.distanceToSquared(i)}applyMatrix4(e){return this.start.applyMatrix4(e),this.end.applyMatrix4(e),this}equals(e){return e.start.equals(this.start)&&e.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};var pl=class extends Ki{constructor(e,t=null){super(),this.object=e,this.domElement=t,this.enabled=!0,this.state=-1,this.keys={},this.mouseButtons={LEFT:null,MIDDLE:null,RIGHT:null},this.touches={ONE:null,TWO:null}}connect(e){this.domElement!==null&&this.disconnect(),this.domElement=e}disconnect(){}dispose(){}update(){}};function fp(n,e,t,i){let s=OM(i);switch(t){case jf:return n*e;case ep:return n*e/s.components*s.byteLength;case Hu:return n*e/s.components*s.byteLength;case wr:return n*e*2/s.components*s.byteLength;case Gu:return n*e*2/s.components*s.byteLength;case Qf:return n*e*3/s.components*s.byteLength;case Ii:return n*e*4/s.components*s.byteLength;case Wu:return n*e*4/s.components*s.byteLength;case _l:case xl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case yl:case vl:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case qu:case $u:return Math.max(n,16)*Math.max(e,8)/4;case Xu:case Yu:return Math.max(n,8)*Math.max(e,8)/2;case Ju:case Zu:case ju:case Qu:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*8;case Ku:case bl:case eh:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case th:return Math.floor((n+3)/4)*Math.floor((e+3)/4)*16;case nh:return Math.floor((n+4)/5)*Math.floor((e+3)/4)*16;case ih:return Math.floor((n+4)/5)*Math.floor((e+4)/5)*16;case sh:return Math.floor((n+5)/6)*Math.floor((e+4)/5)*16;case rh:return Math.floor((n+5)/6)*Math.floor((e+5)/6)*16;case oh:return Math.floor((n+7)/8)*Math.floor((e+4)/5)*16;case ah:return Math.floor((n+7)/8)*Math.floor((e+5)/6)*16;case lh:return Math.floor((n+7)/8)*Math.floor((e+7)/8)*16;case ch:return Math.floor((n+9)/10)*Math.floor((e+4)/5)*16;case uh:return Math.floor((n+9)/10)*Math.floor((e+5)/6)*16;case hh:return Math.floor((n+9)/10)*Math.floor((e+7)/8)*16;case dh:return Math.floor((n+9)/10)*Math.floor((e+9)/10)*16;case fh:return Math.floor((n+11)/12)*Math.floor((e+9)/10)*16;case ph:return Math.floor((n+11)/12)*Math.floor((e+11)/12)*16;case mh:case gh:case _h:return Math.ceil(n/4)*Math.ceil(e/4)*16;case xh:case yh:return Math.ceil(n/4)*Math.ceil(e/4)*8;case Sl:case vh:return Math.ceil(n/4)*Math.ceil(e/4)*16}throw new Error(`Unable to determine texture byte length for ${t} format.`)}function OM(n){switch(n){case _i:case $f:return{byteLength:1,components:1};case na:case Jf:case ts:return{byteLength:2,components:1};case zu:case Vu:return{byteLength:2,components:4};case Qi:case ku:case es:return{byteLength:4,components:1};case Zf:case Kf:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${n}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?$e("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function kx(){let n=null,e=!1,t=null,i=null;function s(r,o){i=n.requestAnimationFrame(s),t(r,o)}return{start:function(){e!==!0&&t!==null&&n!==null&&(i=n.requestAnimationFrame(s),e=!0)},stop:function(){n!==null&&n.cancelAnimationFrame(i),e=!1},setAnimationLoop:function(r){t=r},setContext:function(r){n=r}}}function BM(n){let e=new WeakMap;function t(a,l){let c=a.array,u=a.usage,f=c.byteLength,h=n.createBuffer();n.bindBuffer(l,h),n.bufferData(l,c,u),a.onUploadCallback();let d;if(c instanceof Float32Array)d=n.FLOAT;else if(typeof Float16Array<"u"&&c instanceof Float16Array)d=n.HALF_FLOAT;else if(c instanceof Uint16Array)a.isFloat16BufferAttribute?d=n.HALF_FLOAT:d=n.UNSIGNED_SHORT;else if(c instanceof Int16Array)d=n.SHORT;else if(c instanceof Uint32Array)d=n.UNSIGNED_INT;else if(c instanceof Int32Array)d=n.INT;else if(c instanceof Int8Array)d=n.BYTE;else if(c instanceof Uint8Array)d=n.UNSIGNED_BYTE;else if(c instanceof Uint8ClampedArray)d=n.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+c);return{buffer:h,type:d,bytesPerElement:c.BYTES_PER_ELEMENT,version:a.version,size:f}}function i(a,l,c){let u=l.array,f=l.updateRanges;if(n.bindBuffer(c,a),f.length===0)n.bufferSubData(c,0,u);else{f.sort((d,p)=>d.start-p.start);let h=0;for(let d=1;d<f.length;d++){let p=f[h],b=f[d];b.start<=p.start+p.count+1?p.count=Math.max(p.count,b.start+b.count-p.start):(++h,f[h]=b)}f.length=h+1;for(let d=0,p=f.length;d<p;d++){let b=f[d];n.bufferSubData(c,b.start*u.BYTES_PER_ELEMENT,u,b.start,b.count)}l.clearUpdateRanges()}l.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),e.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let l=e.get(a);l&&(n.deleteBuffer(l.buffer),e.delete(a))}function o(a,l){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let u=e.get(a);(!u||u.version<a.version)&&e.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let c=e.get(a);if(c===void 0)e.set(a,t(a,l));else if(c.version<a.version){if(c.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");i(c.buffer,a,l),c.version=a.version}}return{get:s,remove:r,update:o}}var kM=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,zM=`#ifdef USE_ALPHAHASH
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
#endif`,VM=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,HM=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,GM=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,WM=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,XM=`#ifdef USE_AOMAP
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
#endif`,qM=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,YM=`#ifdef USE_BATCHING
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
#endif`,$M=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,JM=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,ZM=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,KM=`float G_BlinnPhong_Implicit( ) {
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
} // validated`,jM=`#ifdef USE_IRIDESCENCE
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
#endif`,QM=`#ifdef USE_BUMPMAP
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
#endif`,ew=`#if NUM_CLIPPING_PLANES > 0
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
#endif`,tw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,nw=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,iw=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,sw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,rw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,ow=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,aw=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
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
#endif`,lw=`#define PI 3.141592653589793
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
} // validated`,cw=`vec3 transformedNormal = objectNormal;
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
#endif`,uw=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,hw=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,dw=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,fw=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,pw="gl_FragColor = linearToOutputTexel( gl_FragColor );",mw=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,gw=`#ifdef USE_ENVMAP
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
#endif`,_w=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,xw=`#ifdef USE_ENVMAP
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
#endif`,yw=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,vw=`#ifdef USE_ENVMAP
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
#endif`,bw=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Sw=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Mw=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,ww=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,Aw=`#ifdef USE_GRADIENTMAP
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
}`,Tw=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Ew=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Cw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Rw=`uniform bool receiveShadow;
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
#include <lightprobes_pars_fragment>`,Pw=`#ifdef USE_ENVMAP
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
#endif`,Iw=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Lw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,Dw=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Nw=`varying vec3 vViewPosition;
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
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Uw=`PhysicalMaterial material;
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
#endif`,Ow=`uniform sampler2D dfgLUT;
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
}`,Fw=`
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
#endif`,Bw=`#if defined( RE_IndirectDiffuse )
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
#endif`,kw=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,zw=`#if NUM_LIGHT_PROBE_GRIDS > 0
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
#endif`,Vw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,Hw=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Gw=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,Ww=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,Xw=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,qw=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,Yw=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
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
#endif`,$w=`#if defined( USE_POINTS_UV )
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
#endif`,Jw=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,Zw=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,Kw=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,jw=`#if defined( USE_MORPHCOLORS )
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
#endif`,Qw=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,e1=`#ifdef USE_MORPHTARGETS
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
#endif`,t1=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,n1=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
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
vec3 nonPerturbedNormal = normal;`,i1=`#ifdef USE_NORMALMAP_OBJECTSPACE
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
#endif`,s1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,r1=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,o1=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,a1=`#ifdef USE_NORMALMAP
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
#endif`,l1=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,c1=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,u1=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,h1=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,d1=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,f1=`vec3 packNormalToRGB( const in vec3 normal ) {
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
}`,p1=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,m1=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,g1=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,_1=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,x1=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,y1=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,v1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,b1=`#if NUM_SPOT_LIGHT_COORDS > 0
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
#endif`,S1=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
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
#endif`,M1=`float getShadowMask() {
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
}`,w1=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,A1=`#ifdef USE_SKINNING
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
#endif`,T1=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,E1=`#ifdef USE_SKINNING
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
#endif`,C1=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,R1=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,P1=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,I1=`#ifndef saturate
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
vec3 CustomToneMapping( vec3 color ) { return color; }`,L1=`#ifdef USE_TRANSMISSION
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
#endif`,D1=`#ifdef USE_TRANSMISSION
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
#endif`,N1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,U1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,O1=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
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
#endif`,F1=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,B1=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,k1=`uniform sampler2D t2D;
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
}`,z1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,V1=`uniform float backgroundBlurriness;
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
}`,H1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,G1=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,W1=`#include <common>
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
}`,X1=`#if DEPTH_PACKING == 3200
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
}`,q1=`#define DISTANCE
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
}`,Y1=`#define DISTANCE
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
}`,$1=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,J1=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,Z1=`uniform float scale;
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
}`,K1=`uniform vec3 diffuse;
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
}`,j1=`#include <common>
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
}`,Q1=`uniform vec3 diffuse;
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
}`,eA=`#define LAMBERT
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
}`,tA=`#define LAMBERT
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
}`,nA=`#define MATCAP
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
}`,iA=`#define MATCAP
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
}`,sA=`#define NORMAL
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
}`,rA=`#define NORMAL
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
}`,oA=`#define PHONG
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
}`,aA=`#define PHONG
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
}`,lA=`#define STANDARD
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
}`,cA=`#define STANDARD
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
}`,uA=`#define TOON
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
}`,hA=`#define TOON
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
}`,dA=`uniform float size;
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
}`,fA=`uniform vec3 diffuse;
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
}`,pA=`#include <common>
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
}`,mA=`uniform vec3 color;
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
}`,gA=`uniform float rotation;
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
}`,_A=`uniform vec3 diffuse;
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
}`,ft={alphahash_fragment:kM,alphahash_pars_fragment:zM,alphamap_fragment:VM,alphamap_pars_fragment:HM,alphatest_fragment:GM,alphatest_pars_fragment:WM,aomap_fragment:XM,aomap_pars_fragment:qM,batching_pars_vertex:YM,batching_vertex:$M,begin_vertex:JM,beginnormal_vertex:ZM,bsdfs:KM,iridescence_fragment:jM,bumpmap_pars_fragment:QM,clipping_planes_fragment:ew,clipping_planes_pars_fragment:tw,clipping_planes_pars_vertex:nw,clipping_planes_vertex:iw,color_fragment:sw,color_pars_fragment:rw,color_pars_vertex:ow,color_vertex:aw,common:lw,defaultnormal_vertex:cw,displacementmap_pars_vertex:uw,displacementmap_vertex:hw,emissivemap_fragment:dw,emissivemap_pars_fragment:fw,colorspace_fragment:pw,colorspace_pars_fragment:mw,envmap_fragment:gw,envmap_common_pars_fragment:_w,envmap_pars_fragment:xw,envmap_pars_vertex:yw,envmap_physical_pars_fragment:Pw,envmap_vertex:vw,fog_vertex:bw,fog_pars_vertex:Sw,fog_fragment:Mw,fog_pars_fragment:ww,gradientmap_pars_fragment:Aw,lightmap_pars_fragment:Tw,lights_lambert_fragment:Ew,lights_lambert_pars_fragment:Cw,lights_pars_begin:Rw,lights_toon_fragment:Iw,lights_toon_pars_fragment:Lw,lights_phong_fragment:Dw,lights_phong_pars_fragment:Nw,lights_physical_fragment:Uw,lights_physical_pars_fragment:Ow,lights_fragment_begin:Fw,lights_fragment_maps:Bw,lights_fragment_end:kw,lightprobes_pars_fragment:zw,logdepthbuf_fragment:Vw,logdepthbuf_pars_fragment:Hw,logdepthbuf_pars_vertex:Gw,logdepthbuf_vertex:Ww,map_fragment:Xw,map_pars_fragment:qw,map_particle_fragment:Yw,map_particle_pars_fragment:$w,metalnessmap_fragment:Jw,metalnessmap_pars_fragment:Zw,morphinstance_vertex:Kw,morphcolor_vertex:jw,morphnormal_vertex:Qw,morphtarget_pars_vertex:e1,morphtarget_vertex:t1,normal_fragment_begin:n1,normal_fragment_maps:i1,normal_pars_fragment:s1,normal_pars_vertex:r1,normal_vertex:o1,normalmap_pars_fragment:a1,clearcoat_normal_fragment_begin:l1,clearcoat_normal_fragment_maps:c1,clearcoat_pars_fragment:u1,iridescence_pars_fragment:h1,opaque_fragment:d1,packing:f1,premultiplied_alpha_fragment:p1,project_vertex:m1,dithering_fragment:g1,dithering_pars_fragment:_1,roughnessmap_fragment:x1,roughnessmap_pars_fragment:y1,shadowmap_pars_fragment:v1,shadowmap_pars_vertex:b1,shadowmap_vertex:S1,shadowmask_pars_fragment:M1,skinbase_vertex:w1,skinning_pars_vertex:A1,skinning_vertex:T1,skinnormal_vertex:E1,specularmap_fragment:C1,specularmap_pars_fragment:R1,tonemapping_fragment:P1,tonemapping_pars_fragment:I1,transmission_fragment:L1,transmission_pars_fragment:D1,uv_pars_fragment:N1,uv_pars_vertex:U1,uv_vertex:O1,worldpos_vertex:F1,background_vert:B1,background_frag:k1,backgroundCube_vert:z1,backgroundCube_frag:V1,cube_vert:H1,cube_frag:G1,depth_vert:W1,depth_frag:X1,distance_vert:q1,distance_frag:Y1,equirect_vert:$1,equirect_frag:J1,linedashed_vert:Z1,linedashed_frag:K1,meshbasic_vert:j1,meshbasic_frag:Q1,meshlambert_vert:eA,meshlambert_frag:tA,meshmatcap_vert:nA,meshmatcap_frag:iA,meshnormal_vert:sA,meshnormal_frag:rA,meshphong_vert:oA,meshphong_frag:aA,meshphysical_vert:lA,meshphysical_frag:cA,meshtoon_vert:uA,meshtoon_frag:hA,points_vert:dA,points_frag:fA,shadow_vert:pA,shadow_frag:mA,sprite_vert:gA,sprite_frag:_A},Pe={common:{diffuse:{value:new ut(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new st}},envmap:{envMap:{value:null},envMapRotation:{value:new st},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new st}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new st}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new st},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new st},normalScale:{value:new Ze(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new st},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new st}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new st}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new st}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new ut(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new ut(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0},uvTransform:{value:new st}},sprite:{diffuse:{value:new ut(16777215)},opacity:{value:1},center:{value:new Ze(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new st},alphaMap:{value:null},alphaMapTransform:{value:new st},alphaTest:{value:0}}},di={basic:{uniforms:ei([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.fog]),vertexShader:ft.meshbasic_vert,fragmentShader:ft.meshbasic_frag},lambert:{uniforms:ei([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new ut(0)},envMapIntensity:{value:1}}]),vertexShader:ft.meshlambert_vert,fragmentShader:ft.meshlambert_frag},phong:{uniforms:ei([Pe.common,Pe.specularmap,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,Pe.lights,{emissive:{value:new ut(0)},specular:{value:new ut(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:ft.meshphong_vert,fragmentShader:ft.meshphong_frag},standard:{uniforms:ei([Pe.common,Pe.envmap,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.roughnessmap,Pe.metalnessmap,Pe.fog,Pe.lights,{emissive:{value:new ut(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag},toon:{uniforms:ei([Pe.common,Pe.aomap,Pe.lightmap,Pe.emissivemap,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.gradientmap,Pe.fog,Pe.lights,{emissive:{value:new ut(0)}}]),vertexShader:ft.meshtoon_vert,fragmentShader:ft.meshtoon_frag},matcap:{uniforms:ei([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,Pe.fog,{matcap:{value:null}}]),vertexShader:ft.meshmatcap_vert,fragmentShader:ft.meshmatcap_frag},points:{uniforms:ei([Pe.points,Pe.fog]),vertexShader:ft.points_vert,fragmentShader:ft.points_frag},dashed:{uniforms:ei([Pe.common,Pe.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:ft.linedashed_vert,fragmentShader:ft.linedashed_frag},depth:{uniforms:ei([Pe.common,Pe.displacementmap]),vertexShader:ft.depth_vert,fragmentShader:ft.depth_frag},normal:{uniforms:ei([Pe.common,Pe.bumpmap,Pe.normalmap,Pe.displacementmap,{opacity:{value:1}}]),vertexShader:ft.meshnormal_vert,fragmentShader:ft.meshnormal_frag},sprite:{uniforms:ei([Pe.sprite,Pe.fog]),vertexShader:ft.sprite_vert,fragmentShader:ft.sprite_frag},background:{uniforms:{uvTransform:{value:new st},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:ft.background_vert,fragmentShader:ft.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new st}},vertexShader:ft.backgroundCube_vert,fragmentShader:ft.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:ft.cube_vert,fragmentShader:ft.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:ft.equirect_vert,fragmentShader:ft.equirect_frag},distance:{uniforms:ei([Pe.common,Pe.displacementmap,{referencePosition:{value:new z},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:ft.distance_vert,fragmentShader:ft.distance_frag},shadow:{uniforms:ei([Pe.lights,Pe.fog,{color:{value:new ut(0)},opacity:{value:1}}]),vertexShader:ft.shadow_vert,fragmentShader:ft.shadow_frag}};di.physical={uniforms:ei([di.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new st},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new st},clearcoatNormalScale:{value:new Ze(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new st},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new st},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new st},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new st},sheen:{value:0},sheenColor:{value:new ut(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new st},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new st},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new st},transmissionSamplerSize:{value:new Ze},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new st},attenuationDistance:{value:0},attenuationColor:{value:new ut(0)},specularColor:{value:new ut(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new st},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new st},anisotropyVector:{value:new Ze},anisotropyMap:{value:null},anisotropyMapTransform:{value:new st}}]),vertexShader:ft.meshphysical_vert,fragmentShader:ft.meshphysical_frag};var Mh={r:0,b:0,g:0},xA=new St,zx=new st;zx.set(-1,0,0,0,1,0,0,0,1);function yA(n,e,t,i,s,r){let o=new ut(0),a=s===!0?0:1,l,c,u=null,f=0,h=null;function d(v){let C=v.isScene===!0?v.background:null;if(C&&C.isTexture){let M=v.backgroundBlurriness>0;C=e.get(C,M)}return C}function p(v){let C=!1,M=d(v);M===null?m(o,a):M&&M.isColor&&(m(M,1),C=!0);let I=n.xr.getEnvironmentBlendMode();I==="additive"?t.buffers.color.setClear(0,0,0,1,r):I==="alpha-blend"&&t.buffers.color.setClear(0,0,0,0,r),(n.autoClear||C)&&(t.buffers.depth.setTest(!0),t.buffers.depth.setMask(!0),t.buffers.color.setMask(!0),n.clear(n.autoClearColor,n.autoClearDepth,n.autoClearStencil))}function b(v,C){let M=d(C);M&&M.isCubeTexture?(c===void 0&&(c=new Hn(new Zo(1,1,1),new ki({name:"BackgroundCubeMaterial",uniforms:Zr(di.backgroundCube.uniforms),vertexShader:di.backgroundCube.vertexShader,fragmentShader:di.backgroundCube.fragmentShader,side:hi,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),c.geometry.deleteAttribute("uv"),c.onBeforeRender=function(I,E,x){this.matrixWorld.copyPosition(x.matrixWorld)},Object.defineProperty(c.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),i.update(c)),c.material.uniforms.envMap.value=M,c.material.uniforms.backgroundBlurriness.value=C.backgroundBlurriness,c.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,c.material.uniforms.backgroundRotation.value.setFromMatrix4(xA.makeRotationFromEuler(C.backgroundRotation)).transpose(),M.isRenderTargetTexture===!1&&c.material.uniforms.backgroundRotation.value.premultiply(zx),c.material.toneMapped=vt.getTransfer(M.colorSpace)!==Rt,(u!==M||f!==M.version||h!==n.toneMapping)&&(c.material.needsUpdate=!0,u=M,f=M.version,h=n.toneMapping),c.layers.enableAll(),v.unshift(c,c.geometry,c.material,0,0,null)):M&&M.isTexture&&(l===void 0&&(l=new Hn(new il(2,2),new ki({name:"BackgroundMaterial",uniforms:Zr(di.background.uniforms),vertexShader:di.background.vertexShader,fragmentShader:di.background.fragmentShader,side:Mr,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),Object.defineProperty(l.material,"map",{get:function(){return this.uniforms.t2D.value}}),i.update(l)),l.material.uniforms.t2D.value=M,l.material.uniforms.backgroundIntensity.value=C.backgroundIntensity,l.material.toneMapped=vt.getTransfer(M.colorSpace)!==Rt,M.matrixAutoUpdate===!0&&M.updateMatrix(),l.material.uniforms.uvTransform.value.copy(M.matrix),(u!==M||f!==M.version||h!==n.toneMapping)&&(l.material.needsUpdate=!0,u=M,f=M.version,h=n.toneMapping),l.layers.enableAll(),v.unshift(l,l.geometry,l.material,0,0,null))}function m(v,C){v.getRGB(Mh,up(n)),t.buffers.color.setClear(Mh.r,Mh.g,Mh.b,C,r)}function g(){c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0),l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0)}return{getClearColor:function(){return o},setClearColor:function(v,C=1){o.set(v),a=C,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(v){a=v,m(o,a)},render:p,addToRenderList:b,dispose:g}}function vA(n,e){let t=n.getParameter(n.MAX_VERTEX_ATTRIBS),i={},s=h(null),r=s,o=!1;function a(D,H,O,L,X){let $=!1,G=f(D,L,O,H);r!==G&&(r=G,c(r.object)),$=d(D,L,O,X),$&&p(D,L,O,X),X!==null&&e.update(X,n.ELEMENT_ARRAY_BUFFER),($||o)&&(o=!1,M(D,H,O,L),X!==null&&n.bindBuffer(n.ELEMENT_ARRAY_BUFFER,e.get(X).buffer))}function l(){return n.createVertexArray()}function c(D){return n.bindVertexArray(D)}function u(D){return n.deleteVertexArray(D)}function f(D,H,O,L){let X=L.wireframe===!0,$=i[H.id];$===void 0&&($={},i[H.id]=$);let G=D.isInstancedMesh===!0?D.id:0,ue=$[G];ue===void 0&&(ue={},$[G]=ue);let Z=ue[O.id];Z===void 0&&(Z={},ue[O.id]=Z);let Q=Z[X];return Q===void 0&&(Q=h(l()),Z[X]=Q),Q}function h(D){let H=[],O=[],L=[];for(let X=0;X<t;X++)H[X]=0,O[X]=0,L[X]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:H,enabledAttributes:O,attributeDivisors:L,object:D,attributes:{},index:null}}function d(D,H,O,L){let X=r.attributes,$=H.attributes,G=0,ue=O.getAttributes();for(let Z in ue)if(ue[Z].location>=0){let ie=X[Z],pe=$[Z];if(pe===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(pe=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(pe=D.instanceColor)),ie===void 0||ie.attribute!==pe||pe&&ie.data!==pe.data)return!0;G++}return r.attributesNum!==G||r.index!==L}function p(D,H,O,L){let X={},$=H.attributes,G=0,ue=O.getAttributes();for(let Z in ue)if(ue[Z].location>=0){let ie=$[Z];ie===void 0&&(Z==="instanceMatrix"&&D.instanceMatrix&&(ie=D.instanceMatrix),Z==="instanceColor"&&D.instanceColor&&(ie=D.instanceColor));let pe={};pe.attribute=ie,ie&&ie.data&&(pe.data=ie.data),X[Z]=pe,G++}r.attributes=X,r.attributesNum=G,r.index=L}function b(){let D=r.newAttributes;for(let H=0,O=D.length;H<O;H++)D[H]=0}function m(D){g(D,0)}function g(D,H){let O=r.newAttributes,L=r.enabledAttributes,X=r.attributeDivisors;O[D]=1,L[D]===0&&(n.enableVertexAttribArray(D),L[D]=1),X[D]!==H&&(n.vertexAttribDivisor(D,H),X[D]=H)}function v(){let D=r.newAttributes,H=r.enabledAttributes;for(let O=0,L=H.length;O<L;O++)H[O]!==D[O]&&(n.disableVertexAttribArray(O),H[O]=0)}function C(D,H,O,L,X,$,G){G===!0?n.vertexAttribIPointer(D,H,O,X,$):n.vertexAttribPointer(D,H,O,L,X,$)}function M(D,H,O,L){b();let X=L.attributes,$=O.getAttributes(),G=H.defaultAttributeValues;for(let ue in $){let Z=$[ue];if(Z.location>=0){let Q=X[ue];if(Q===void 0&&(ue==="instanceMatrix"&&D.instanceMatrix&&(Q=D.instanceMatrix),ue==="instanceColor"&&D.instanceColor&&(Q=D.instanceColor)),Q!==void 0){let ie=Q.normalized,pe=Q.itemSize,fe=e.get(Q);if(fe===void 0)continue;let ee=fe.buffer,_e=fe.type,xe=fe.bytesPerElement,se=_e===n.INT||_e===n.UNSIGNED_INT||Q.gpuType===ku;if(Q.isInterleavedBufferAttribute){let ce=Q.data,Oe=ce.isInterleavedBuffer===!0?ce.stride:ce.itemSize,Ke=Q.offset;if(ce.isInstancedInterleavedBuffer||ce.isInstancedBufferAttribute){for(let Ge=0;Ge<Z.locationSize;Ge++)g(Z.location+Ge,ce.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=ce.meshPerAttribute*ce.count)}else for(let Ge=0;Ge<Z.locationSize;Ge++)m(Z.location+Ge);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let Ge=0;Ge<Z.locationSize;Ge++)C(Z.location+Ge,pe/Z.locationSize,_e,ie,Oe*xe,(Ke+pe/Z.locationSize*Ge)*xe,se)}else{if(Q.isInstancedBufferAttribute){for(let ce=0;ce<Z.locationSize;ce++)g(Z.location+ce,Q.meshPerAttribute);D.isInstancedMesh!==!0&&L._maxInstanceCount===void 0&&(L._maxInstanceCount=Q.meshPerAttribute*Q.count)}else for(let ce=0;ce<Z.locationSize;ce++)m(Z.location+ce);n.bindBuffer(n.ARRAY_BUFFER,ee);for(let ce=0;ce<Z.locationSize;ce++)C(Z.location+ce,pe/Z.locationSize,_e,ie,pe*xe,pe/Z.locationSize*ce*xe,se)}}else if(G!==void 0){let ie=G[ue];if(ie!==void 0)switch(ie.length){case 2:n.vertexAttrib2fv(Z.location,ie);break;case 3:n.vertexAttrib3fv(Z.location,ie);break;case 4:n.vertexAttrib4fv(Z.location,ie);break;default:n.vertexAttrib1fv(Z.location,ie)}}}}v()}function I(){V();for(let D in i){let H=i[D];for(let O in H){let L=H[O];for(let X in L){let $=L[X];for(let G in $)u($[G].object),delete $[G];delete L[X]}}delete i[D]}}function E(D){if(i[D.id]===void 0)return;let H=i[D.id];for(let O in H){let L=H[O];for(let X in L){let $=L[X];for(let G in $)u($[G].object),delete $[G];delete L[X]}}delete i[D.id]}function x(D){for(let H in i){let O=i[H];for(let L in O){let X=O[L];if(X[D.id]===void 0)continue;let $=X[D.id];for(let G in $)u($[G].object),delete $[G];delete X[D.id]}}}function T(D){for(let H in i){let O=i[H],L=D.isInstancedMesh===!0?D.id:0,X=O[L];if(X!==void 0){for(let $ in X){let G=X[$];for(let ue in G)u(G[ue].object),delete G[ue];delete X[$]}delete O[L],Object.keys(O).length===0&&delete i[H]}}}function V(){U(),o=!0,r!==s&&(r=s,c(r.object))}function U(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:V,resetDefaultState:U,dispose:I,releaseStatesOfGeometry:E,releaseStatesOfObject:T,releaseStatesOfProgram:x,initAttributes:b,enableAttribute:m,disableUnusedAttributes:v}}function bA(n,e,t){let i;function s(l){i=l}function r(l,c){n.drawArrays(i,l,c),t.update(c,i,1)}function o(l,c,u){u!==0&&(n.drawArraysInstanced(i,l,c,u),t.update(c,i,u))}function a(l,c,u){if(u===0)return;e.get("WEBGL_multi_draw").multiDrawArraysWEBGL(i,l,0,c,0,u);let h=0;for(let d=0;d<u;d++)h+=c[d];t.update(h,i,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function SA(n,e,t,i){let s;function r(){if(s!==void 0)return s;if(e.has("EXT_texture_filter_anisotropic")===!0){let x=e.get("EXT_texture_filter_anisotropic");s=n.getParameter(x.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(x){return!(x!==Ii&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(x){let T=x===ts&&(e.has("EXT_color_buffer_half_float")||e.has("EXT_color_buffer_float"));return!(x!==_i&&x!==es&&!T&&i.convert(x)!==n.getParameter(n.IMPLEMENTATION_COLOR_READ_TYPE))}function l(x){if(x==="highp"){if(n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.HIGH_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.HIGH_FLOAT).precision>0)return"highp";x="mediump"}return x==="mediump"&&n.getShaderPrecisionFormat(n.VERTEX_SHADER,n.MEDIUM_FLOAT).precision>0&&n.getShaderPrecisionFormat(n.FRAGMENT_SHADER,n.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let c=t.precision!==void 0?t.precision:"highp",u=l(c);u!==c&&($e("WebGLRenderer:",c,"not supported, using",u,"instead."),c=u);let f=t.reversedDepthBuffer===!0&&e.has("EXT_clip_control"),h=t.logarithmicDepthBuffer===!0&&f===!1;t.reversedDepthBuffer===!0&&f===!1&&$e("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),t.logarithmicDepthBuffer===!0&&f===!0&&$e("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let d=n.getParameter(n.MAX_TEXTURE_IMAGE_UNITS),p=n.getParameter(n.MAX_VERTEX_TEXTURE_IMAGE_UNITS),b=n.getParameter(n.MAX_TEXTURE_SIZE),m=n.getParameter(n.MAX_CUBE_MAP_TEXTURE_SIZE),g=n.getParameter(n.MAX_VERTEX_ATTRIBS),v=n.getParameter(n.MAX_VERTEX_UNIFORM_VECTORS),C=n.getParameter(n.MAX_VARYING_VECTORS),M=n.getParameter(n.MAX_FRAGMENT_UNIFORM_VECTORS),I=n.getParameter(n.MAX_SAMPLES),E=n.getParameter(n.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:l,textureFormatReadable:o,textureTypeReadable:a,precision:c,logarithmicDepthBuffer:h,reversedDepthBuffer:f,maxTextures:d,maxVertexTextures:p,maxTextureSize:b,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:v,maxVaryings:C,maxFragmentUniforms:M,maxSamples:I,samples:E}}function MA(n){let e=this,t=null,i=0,s=!1,r=!1,o=new li,a=new st,l={value:null,needsUpdate:!1};this.uniform=l,this.numPlanes=0,this.numIntersection=0,this.init=function(f,h){let d=f.length!==0||h||i!==0||s;return s=h,i=f.length,d},this.beginShadows=function(){r=!0,u(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(f,h){t=u(f,h,0)},this.setState=function(f,h,d){let p=f.clippingPlanes,b=f.clipIntersection,m=f.clipShadows,g=n.get(f);if(!s||p===null||p.length===0||r&&!m)r?u(null):c();else{let v=r?0:i,C=v*4,M=g.clippingState||null;l.value=M,M=u(p,h,C,d);for(let I=0;I!==C;++I)M[I]=t[I];g.clippingState=M,this.numIntersection=b?this.numPlanes:0,this.numPlanes+=v}};function c(){l.value!==t&&(l.value=t,l.needsUpdate=i>0),e.numPlanes=i,e.numIntersection=0}function u(f,h,d,p){let b=f!==null?f.length:0,m=null;if(b!==0){if(m=l.value,p!==!0||m===null){let g=d+b*4,v=h.matrixWorldInverse;a.getNormalMatrix(v),(m===null||m.length<g)&&(m=new Float32Array(g));for(let C=0,M=d;C!==b;++C,M+=4)o.copy(f[C]).applyMatrix4(v,a),o.normal.toArray(m,M),m[M+3]=o.constant}l.value=m,l.needsUpdate=!0}return e.numPlanes=b,e.numIntersection=0,m}}var El=class extends Ri{constructor(e=1,t={}){super(e,e,t),this.isWebGLCubeRenderTarget=!0;let i={width:e,height:e,depth:1},s=[i,i,i,i,i,i];this.texture=new el(s),this._setTextureOptions(t),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(e,t){this.texture.type=t.type,this.texture.colorSpace=t.colorSpace,this.texture.generateMipmaps=t.generateMipmaps,this.texture.minFilter=t.minFilter,this.texture.magFilter=t.magFilter;let i={uniforms:{tEquirect:{value:null}},vertexShader:`

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
			`},s=new Zo(5,5,5),r=new ki({name:"CubemapFromEquirect",uniforms:Zr(i.uniforms),vertexShader:i.vertexShader,fragmentShader:i.fragmentShader,side:hi,blending:qr});r.uniforms.tEquirect.value=t;let o=new Hn(s,r),a=t.minFilter;return t.minFilter===Vs&&(t.minFilter=ui),new Ko(1,10,this).update(e,o),t.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(e,t=!0,i=!0,s=!0){let r=e.getRenderTarget();for(let o=0;o<6;o++)e.setRenderTarget(this,o),e.clear(t,i,s);e.setRenderTarget(r)}},xx=256,wA=3,AA=20,Vx=256,Hx=16,TA=3,EA=new z,CA=new ut,Ah=class n{constructor(e){this._renderer=e,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new Ko(1,10,null),this._boxMesh=new Hn(new Zo(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(e,t=0,i=.1,s=100,r={}){let{size:o=256,position:a=EA}=r,l=this._renderer;this._setSize(o);let c=this._allocateTarget(),u=this._getSourceTarget(!0);t>0&&(u.texture.mipmapsAutoUpdate=!1);let f=l.autoClear,h=l.autoClearColor,d=l.autoClearDepth,p=l.autoClearStencil,b=e.background;l.autoClear=!0,l.autoClearColor=!0,l.autoClearDepth=!0,l.autoClearStencil=!0,b===null&&(e.background=l.getClearColor(CA));let m=new Ko(i,s,u);return m.position.copy(a),m.update(l,e),l.autoClear=f,l.autoClearColor=h,l.autoClearDepth=d,l.autoClearStencil=p,e.background=b,t>0&&(u.texture.mipmapsAutoUpdate=!0,this._blur(c,t)),this._applyPMREM(c),c}fromEquirectangular(e,t=null){return this._fromTexture(e,t)}fromCubemap(e,t=null){return this._fromTexture(e,t)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=bx(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=vx(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(e,t){return t>0?1-Math.sqrt(1-e/t):0}_setSize(e){this._cubeSize=Math.max(xx,ap(e))}_fromTexture(e,t){e.mapping===$r||e.mapping===ta?this._setSize(e.image.length===0?xx:e.image[0].width||e.image[0].image.width):this._setSize(e.image.width/4);let i=t||this._allocateTarget();return this._textureToCubemap(e),this._applyPMREM(i),i}_allocateTarget(){let e=this._cubeSize,t=yx(e,!1,!1),i=Math.log2(e)-wA;for(let s=0;s<=i;s++)t.texture.mipmaps.push({width:e>>s,height:e>>s});return t.texture.name="PMREM",t.texture.isPMREMTexture=!0,t}_getSourceTarget(e=!1){let t=this._cubeSize,i=this._sourceTarget;return(i===null||i.width!==t||e&&i.depthBuffer===!1)&&(i!==null&&i.dispose(),this._sourceTarget=yx(t,!0,e)),this._sourceTarget}_compileMaterial(e){this._boxMesh.material=e,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(e,t,i){let s=this._boxMesh,r=this._cubeCamera;s.material=i,r.renderTarget=e,r.activeMipmapLevel=t;let o=e.width>>t;e.viewport.set(0,0,o,o),r.update(this._renderer,s),e.viewport.set(0,0,e.width,e.height)}_textureToCubemap(e){let t;e.mapping===$r||e.mapping===ta?(this._cubemapMaterial===null&&(this._cubemapMaterial=bx()),t=this._cubemapMaterial,t.uniforms.flipEnvMap.value=e.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=vx()),t=this._equirectMaterial),t.uniforms.envMap.value=e,this._renderCube(this._getSourceTarget(),0,t)}_applyPMREM(e){this._ggxMaterial===null&&(this._ggxMaterial=RA(),this._integrationMaterial=PA());let t=this._cubeSize,i=e.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(t/Hx);for(let o=0;o<=i;o++){let a=n.lodToRoughness(o,i);if(o>i-TA)r.roughness.value=a,this._renderCube(e,o,this._integrationMaterial);else{let l=a>0?Math.log2(t)+.5*Math.log2(6/(Vx*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=l,this._renderCube(e,o,this._ggxMaterial)}}}_blur(e,t){this._blurMaterial===null&&(this._blurMaterial=IA());let i=this._blurMaterial,s=i.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(t,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(e,0,i),s.envMap.value=e.texture,this._renderCube(r,0,i)}};function yx(n,e,t){return new El(n,{minFilter:Vs,generateMipmaps:e,type:ts,colorSpace:Wa,depthBuffer:t})}function Cl(n,e,t){return new ki({name:n,uniforms:e,vertexShader:ft.cube_vert,fragmentShader:t,side:hi,blending:qr,depthTest:!1,depthWrite:!1})}function RA(){return Cl("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Vx}u

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
	`)}function PA(){return Cl("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Hx}},`

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
	`)}function IA(){return Cl("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${AA}
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
	`)}function vx(){return Cl("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

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
	`)}function bx(){return Cl("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function LA(n){let e=new WeakMap,t=new WeakMap,i=null;function s(h,d=!1){return h==null?null:d?o(h):r(h)}function r(h){if(h&&h.isTexture){let d=h.mapping;if(d===Ou||d===Fu)if(e.has(h)){let p=e.get(h).texture;return a(p,h.mapping)}else{let p=h.image;if(p&&p.height>0){let b=new El(p.height);return b.fromEquirectangularTexture(n,h),e.set(h,b),h.addEventListener("dispose",c),a(b.texture,h.mapping)}else return null}}return h}function o(h){if(h&&h.isTexture&&h.isPMREMTexture!==!0){let d=h.mapping,p=d===Ou||d===Fu,b=d===$r||d===ta;if(p||b){let m=t.get(h),g=m!==void 0?m.texture.pmremVersion:0;if(h.isRenderTargetTexture&&h.pmremVersion!==g)return i===null&&(i=new Ah(n)),m=p?i.fromEquirectangular(h,m):i.fromCubemap(h,m),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),m.texture;if(m!==void 0)return m.texture;{let v=h.image;return p&&v&&v.height>0||b&&v&&l(v)?(i===null&&(i=new Ah(n)),m=p?i.fromEquirectangular(h):i.fromCubemap(h),m.texture.pmremVersion=h.pmremVersion,t.set(h,m),h.addEventListener("dispose",u),m.texture):null}}}return h}function a(h,d){return d===Ou?h.mapping=$r:d===Fu&&(h.mapping=ta),h}function l(h){let d=0,p=6;for(let b=0;b<p;b++)h[b]!==void 0&&d++;return d===p}function c(h){let d=h.target;d.removeEventListener("dispose",c);let p=e.get(d);p!==void 0&&(e.delete(d),p.dispose())}function u(h){let d=h.target;d.removeEventListener("dispose",u);let p=t.get(d);p!==void 0&&(t.delete(d),p.dispose())}function f(){e=new WeakMap,t=new WeakMap,i!==null&&(i.dispose(),i=null)}return{get:s,dispose:f}}function DA(n){let e={};function t(i){if(e[i]!==void 0)return e[i];let s=n.getExtension(i);return e[i]=s,s}return{has:function(i){return t(i)!==null},init:function(){t("EXT_color_buffer_float"),t("WEBGL_clip_cull_distance"),t("OES_texture_float_linear"),t("EXT_color_buffer_half_float"),t("WEBGL_multisampled_render_to_texture"),t("WEBGL_render_shared_exponent")},get:function(i){let s=t(i);return s===null&&za("WebGLRenderer: "+i+" extension not supported."),s}}}function NA(n,e,t,i){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){l(p.target)}function l(p){p.index!==null&&e.remove(p.index);for(let m in p.attributes)e.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let b=r.get(p);b&&(e.remove(b),r.delete(p)),i.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,t.memory.geometries--}function c(p,b){return s[b.id]!==void 0||(b.addEventListener("dispose",a),s[b.id]=new WeakRef(b),o.register(b,b.id,b),t.memory.geometries++),b}function u(p){let b=p.attributes;for(let m in b)e.update(b[m],n.ARRAY_BUFFER)}function f(p){let b=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let v=b!==null?b.array.length:m.array.length/3-1,C=m.count>=65535?ja:Ka,M=new C(Math.ceil(v/3)*6,1),I=M.array;if(b!==null){let x=b.array;g=b.version;for(let T=0,V=0;T<v;T+=3){let U=x[T+0],D=x[T+1],H=x[T+2];I[V++]=U,I[V++]=D,I[V++]=D,I[V++]=H,I[V++]=H,I[V++]=U}}else{g=m.version;for(let x=0,T=0;x<v;x+=3){let V=x+0,U=x+1,D=x+2;I[T++]=V,I[T++]=U,I[T++]=U,I[T++]=D,I[T++]=D,I[T++]=V}}M.version=g;let E=r.get(p);E&&e.remove(E),r.set(p,M)}function h(p){let b=r.get(p);if(b){let m=p.index;m!==null&&b.version<m.version&&f(p)}else f(p);return r.get(p)}function d(){for(let p in s){let b=s[p].deref();b!==void 0&&l(b)}}return{get:c,update:u,getWireframeAttribute:h,dispose:d}}function UA(n,e,t){let i;function s(f){i=f}let r,o;function a(f){r=f.type,o=f.bytesPerElement}function l(f,h){n.drawElements(i,h,r,f*o),t.update(h,i,1)}function c(f,h,d){d!==0&&(n.drawElementsInstanced(i,h,r,f*o,d),t.update(h,i,d))}function u(f,h,d){if(d===0)return;e.get("WEBGL_multi_draw").multiDrawElementsWEBGL(i,h,0,r,f,0,d);let b=0;for(let m=0;m<d;m++)b+=h[m];t.update(b,i,1)}this.setMode=s,this.setIndex=a,this.render=l,this.renderInstances=c,this.renderMultiDraw=u}function OA(n){let e={geometries:0,textures:0},t={frame:0,calls:0,triangles:0,points:0,lines:0};function i(r,o,a){switch(t.calls++,o){case n.TRIANGLES:t.triangles+=a*(r/3);break;case n.LINES:t.lines+=a*(r/2);break;case n.LINE_STRIP:t.lines+=a*(r-1);break;case n.LINE_LOOP:t.lines+=a*r;break;case n.POINTS:t.points+=a*r;break;default:it("WebGLInfo: Unknown draw mode:",o);break}}function s(){t.calls=0,t.triangles=0,t.points=0,t.lines=0}return{memory:e,render:t,programs:null,autoReset:!0,reset:s,update:i}}function FA(n,e,t){let i=new WeakMap,s=new Pt;function r(o,a,l){let c=o.morphTargetInfluences,u=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,f=u!==void 0?u.length:0,h=i.get(a);if(h===void 0||h.count!==f){let V=function(){x.dispose(),i.delete(a),a.removeEventListener("dispose",V)};h!==void 0&&h.texture.dispose();let d=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,b=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],v=a.morphAttributes.color||[],C=0;d===!0&&(C=1),p===!0&&(C=2),b===!0&&(C=3);let M=a.attributes.position.count*C,I=1;M>e.maxTextureSize&&(I=Math.ceil(M/e.maxTextureSize),M=e.maxTextureSize);let E=new Float32Array(M*I*4*f),x=new $a(E,M,I,f);x.type=es,x.needsUpdate=!0;let T=C*4;for(let U=0;U<f;U++){let D=m[U],H=g[U],O=v[U],L=M*I*4*U;for(let X=0;X<D.count;X++){let $=X*T;d===!0&&(s.fromBufferAttribute(D,X),E[L+$+0]=s.x,E[L+$+1]=s.y,E[L+$+2]=s.z,E[L+$+3]=0),p===!0&&(s.fromBufferAttribute(H,X),E[L+$+4]=s.x,E[L+$+5]=s.y,E[L+$+6]=s.z,E[L+$+7]=0),b===!0&&(s.fromBufferAttribute(O,X),E[L+$+8]=s.x,E[L+$+9]=s.y,E[L+$+10]=s.z,E[L+$+11]=O.itemSize===4?s.w:1)}}h={count:f,texture:x,size:new Ze(M,I)},i.set(a,h),a.addEventListener("dispose",V)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)l.getUniforms().setValue(n,"morphTexture",o.morphTexture,t);else{let d=0;for(let b=0;b<c.length;b++)d+=c[b];let p=a.morphTargetsRelative?1:1-d;l.getUniforms().setValue(n,"morphTargetBaseInfluence",p),l.getUniforms().setValue(n,"morphTargetInfluences",c)}l.getUniforms().setValue(n,"morphTargetsTexture",h.texture,t),l.getUniforms().setValue(n,"morphTargetsTextureSize",h.size)}return{update:r}}function BA(n,e,t,i,s){let r=new WeakMap;function o(c){let u=s.render.frame,f=c.geometry,h=e.get(c,f);if(r.get(h)!==u&&(e.update(h),r.set(h,u)),c.isInstancedMesh&&(c.hasEventListener("dispose",l)===!1&&c.addEventListener("dispose",l),r.get(c)!==u&&(t.update(c.instanceMatrix,n.ARRAY_BUFFER),c.instanceColor!==null&&t.update(c.instanceColor,n.ARRAY_BUFFER),r.set(c,u))),c.isSkinnedMesh){let d=c.skeleton;r.get(d)!==u&&(d.update(),r.set(d,u))}return h}function a(){r=new WeakMap}function l(c){let u=c.target;u.removeEventListener("dispose",l),i.releaseStatesOfObject(u),t.remove(u.instanceMatrix),u.instanceColor!==null&&t.remove(u.instanceColor)}return{update:o,dispose:a}}var kA={[zf]:"LINEAR_TONE_MAPPING",[Vf]:"REINHARD_TONE_MAPPING",[Hf]:"CINEON_TONE_MAPPING",[Gf]:"ACES_FILMIC_TONE_MAPPING",[Xf]:"AGX_TONE_MAPPING",[qf]:"NEUTRAL_TONE_MAPPING",[Wf]:"CUSTOM_TONE_MAPPING"};function zA(n,e,t,i,s,r){let o=new Ri(e,t,{type:n,depthBuffer:s,stencilBuffer:r,samples:i?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,l=null,c=null,u=new vn;u.setAttribute("position",new kn([-1,3,0,-1,-1,0,3,-1,0],3)),u.setAttribute("uv",new kn([0,2,0,0,2,0],2));let f=new vu({uniforms:{tDiffuse:{value:null}},vertexShader:`
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
			}`,depthTest:!1,depthWrite:!1}),h=new Hn(u,f),d=new ul(-1,1,1,-1,0,1),p=null,b=null,m=!1,g,v=null,C=[],M=!1;this.setSize=function(I,E){o.setSize(I,E),a!==null&&a.setSize(I,E),l!==null&&l.setSize(I,E);for(let x=0;x<C.length;x++){let T=C[x];T.setSize&&T.setSize(I,E)}},this.setEffects=function(I){C=I,M=C.length>0&&C[0].isRenderPass===!0;let E=o.width,x=o.height;C.length>0&&a===null&&(a=new Ri(E,x,{type:ts,depthBuffer:!1,stencilBuffer:!1}),l=new Ri(E,x,{type:ts,depthBuffer:!1,stencilBuffer:!1}));let T=s===!0&&C.some(V=>V.needsDepthTexture===!0);T!==(o.depthTexture!==null)&&(T===!0&&c===null&&(c=new zs(E,x),r===!0&&(c.format=Hs,c.type=Jr)),o.dispose(),o.depthTexture=T?c:null,o.resolveDepthBuffer=T,o.storeMultisampledDepthBuffer=T);for(let V=0;V<C.length;V++){let U=C[V];U.setSize&&U.setSize(E,x),T&&U.needsDepthTexture===!0&&U.setDepthTexture&&U.setDepthTexture(c)}},this.begin=function(I,E){if(m||I.toneMapping===gs&&C.length===0)return!1;if(v=E,E!==null){let x=E.width,T=E.height;(o.width!==x||o.height!==T)&&this.setSize(x,T)}return M===!1&&I.setRenderTarget(o),g=I.toneMapping,I.toneMapping=gs,!0},this.hasRenderPass=function(){return M},this.end=function(I,E){I.toneMapping=g,m=!0;let x=o,T=a;for(let V=0;V<C.length;V++){let U=C[V];U.enabled!==!1&&(U.render(I,T,x,E),U.needsSwap!==!1&&(x=T,T=T===a?l:a))}if(p!==I.outputColorSpace||b!==I.toneMapping){p=I.outputColorSpace,b=I.toneMapping,f.defines={},vt.getTransfer(p)===Rt&&(f.defines.SRGB_TRANSFER="");let V=kA[b];V&&(f.defines[V]=""),f.needsUpdate=!0}f.uniforms.tDiffuse.value=x.texture,I.setRenderTarget(v),I.render(h,d),v=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),l!==null&&l.dispose(),u.dispose(),f.dispose()}}var Gx=new mi,Wx=new zs(1,1),Xx=new tl(1),qx=new $a,Yx=new pu,$x=new el,Sx=[],Mx=[],wx=new Float32Array(16),Ax=new Float32Array(9),Tx=new Float32Array(4);function sa(n,e,t){let i=n[0];if(i<=0||i>0)return n;let s=e*t,r=Sx[s];if(r===void 0&&(r=new Float32Array(s),Sx[s]=r),e!==0){i.toArray(r,0);for(let o=1,a=0;o!==e;++o)a+=t,n[o].toArray(r,a)}return r}function Cn(n,e){if(n.length!==e.length)return!1;for(let t=0,i=n.length;t<i;t++)if(n[t]!==e[t])return!1;return!0}function Rn(n,e){for(let t=0,i=e.length;t<i;t++)n[t]=e[t]}function Eh(n,e){let t=Mx[e];t===void 0&&(t=new Int32Array(e),Mx[e]=t);for(let i=0;i!==e;++i)t[i]=n.allocateTextureUnit();return t}function VA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1f(this.addr,e),t[0]=e)}function HA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2f(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2fv(this.addr,e),Rn(t,e)}}function GA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3f(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else if(e.r!==void 0)(t[0]!==e.r||t[1]!==e.g||t[2]!==e.b)&&(n.uniform3f(this.addr,e.r,e.g,e.b),t[0]=e.r,t[1]=e.g,t[2]=e.b);else{if(Cn(t,e))return;n.uniform3fv(this.addr,e),Rn(t,e)}}function WA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4f(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4fv(this.addr,e),Rn(t,e)}}function XA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix2fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;Tx.set(i),n.uniformMatrix2fv(this.addr,!1,Tx),Rn(t,i)}}function qA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix3fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;Ax.set(i),n.uniformMatrix3fv(this.addr,!1,Ax),Rn(t,i)}}function YA(n,e){let t=this.cache,i=e.elements;if(i===void 0){if(Cn(t,e))return;n.uniformMatrix4fv(this.addr,!1,e),Rn(t,e)}else{if(Cn(t,i))return;wx.set(i),n.uniformMatrix4fv(this.addr,!1,wx),Rn(t,i)}}function $A(n,e){let t=this.cache;t[0]!==e&&(n.uniform1i(this.addr,e),t[0]=e)}function JA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2i(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2iv(this.addr,e),Rn(t,e)}}function ZA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3i(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3iv(this.addr,e),Rn(t,e)}}function KA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4i(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4iv(this.addr,e),Rn(t,e)}}function jA(n,e){let t=this.cache;t[0]!==e&&(n.uniform1ui(this.addr,e),t[0]=e)}function QA(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y)&&(n.uniform2ui(this.addr,e.x,e.y),t[0]=e.x,t[1]=e.y);else{if(Cn(t,e))return;n.uniform2uiv(this.addr,e),Rn(t,e)}}function eT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z)&&(n.uniform3ui(this.addr,e.x,e.y,e.z),t[0]=e.x,t[1]=e.y,t[2]=e.z);else{if(Cn(t,e))return;n.uniform3uiv(this.addr,e),Rn(t,e)}}function tT(n,e){let t=this.cache;if(e.x!==void 0)(t[0]!==e.x||t[1]!==e.y||t[2]!==e.z||t[3]!==e.w)&&(n.uniform4ui(this.addr,e.x,e.y,e.z,e.w),t[0]=e.x,t[1]=e.y,t[2]=e.z,t[3]=e.w);else{if(Cn(t,e))return;n.uniform4uiv(this.addr,e),Rn(t,e)}}function Ch(n){return n.version===0&&(n.compareFunction=ip,n.needsUpdate=!0),n}function nT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_2D_SHADOW?r=Ch(Wx):r=Gx,t.setTexture2D(e||r,s)}function iT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture3D(e||Yx,s)}function sT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s);let r;this.type===n.SAMPLER_CUBE_SHADOW?r=Ch(Xx):r=$x,t.setTextureCube(e||r,s)}function rT(n,e,t){let i=this.cache,s=t.allocateTextureUnit();i[0]!==s&&(n.uniform1i(this.addr,s),i[0]=s),t.setTexture2DArray(e||qx,s)}function oT(n){switch(n){case 5126:return VA;case 35664:return HA;case 35665:return GA;case 35666:return WA;case 35674:return XA;case 35675:return qA;case 35676:return YA;case 5124:case 35670:return $A;case 35667:case 35671:return JA;case 35668:case 35672:return ZA;case 35669:case 35673:return KA;case 5125:return jA;case 36294:return QA;case 36295:return eT;case 36296:return tT;case 35678:case 36198:case 36298:case 36306:case 35682:return nT;case 35679:case 36299:case 36307:return iT;case 35680:case 36300:case 36308:case 36293:return sT;case 36289:case 36303:case 36311:case 36292:return rT}}function aT(n,e){n.uniform1fv(this.addr,e)}function lT(n,e){let t=sa(e,this.size,2);n.uniform2fv(this.addr,t)}function cT(n,e){let t=sa(e,this.size,3);n.uniform3fv(this.addr,t)}function uT(n,e){let t=sa(e,this.size,4);n.uniform4fv(this.addr,t)}function hT(n,e){let t=sa(e,this.size,4);n.uniformMatrix2fv(this.addr,!1,t)}function dT(n,e){let t=sa(e,this.size,9);n.uniformMatrix3fv(this.addr,!1,t)}function fT(n,e){let t=sa(e,this.size,16);n.uniformMatrix4fv(this.addr,!1,t)}function pT(n,e){n.uniform1iv(this.addr,e)}function mT(n,e){n.uniform2iv(this.addr,e)}function gT(n,e){n.uniform3iv(this.addr,e)}function _T(n,e){n.uniform4iv(this.addr,e)}function xT(n,e){n.uniform1uiv(this.addr,e)}function yT(n,e){n.uniform2uiv(this.addr,e)}function vT(n,e){n.uniform3uiv(this.addr,e)}function bT(n,e){n.uniform4uiv(this.addr,e)}function ST(n,e,t){let i=this.cache,s=e.length,r=Eh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_2D_SHADOW?o=Ch(Wx):o=Gx;for(let a=0;a!==s;++a)t.setTexture2D(e[a]||o,r[a])}function MT(n,e,t){let i=this.cache,s=e.length,r=Eh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture3D(e[o]||Yx,r[o])}function wT(n,e,t){let i=this.cache,s=e.length,r=Eh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));let o;this.type===n.SAMPLER_CUBE_SHADOW?o=Ch(Xx):o=$x;for(let a=0;a!==s;++a)t.setTextureCube(e[a]||o,r[a])}function AT(n,e,t){let i=this.cache,s=e.length,r=Eh(t,s);Cn(i,r)||(n.uniform1iv(this.addr,r),Rn(i,r));for(let o=0;o!==s;++o)t.setTexture2DArray(e[o]||qx,r[o])}function TT(n){switch(n){case 5126:return aT;case 35664:return lT;case 35665:return cT;case 35666:return uT;case 35674:return hT;case 35675:return dT;case 35676:return fT;case 5124:case 35670:return pT;case 35667:case 35671:return mT;case 35668:case 35672:return gT;case 35669:case 35673:return _T;case 5125:return xT;case 36294:return yT;case 36295:return vT;case 36296:return bT;case 35678:case 36198:case 36298:case 36306:case 35682:return ST;case 35679:case 36299:case 36307:return MT;case 35680:case 36300:case 36308:case 36293:return wT;case 36289:case 36303:case 36311:case 36292:return AT}}var gp=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.setValue=oT(t.type)}},_p=class{constructor(e,t,i){this.id=e,this.addr=i,this.cache=[],this.type=t.type,this.size=t.size,this.setValue=TT(t.type)}},xp=class{constructor(e){this.id=e,this.seq=[],this.map={}}setValue(e,t,i){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(e,t[a.id],i)}}},pp=/(\w+)(\])?(\[|\.)?/g;function Ex(n,e){n.seq.push(e),n.map[e.id]=e}function ET(n,e,t){let i=n.name,s=i.length;for(pp.lastIndex=0;;){let r=pp.exec(i),o=pp.lastIndex,a=r[1],l=r[2]==="]",c=r[3];if(l&&(a=a|0),c===void 0||c==="["&&o+2===s){Ex(t,c===void 0?new gp(a,n,e):new _p(a,n,e));break}else{let f=t.map[a];f===void 0&&(f=new xp(a),Ex(t,f)),t=f}}}var ia=class{constructor(e,t){this.seq=[],this.map={};let i=e.getProgramParameter(t,e.ACTIVE_UNIFORMS);for(let o=0;o<i;++o){let a=e.getActiveUniform(t,o),l=e.getUniformLocation(t,a.name);ET(a,l,this)}let s=[],r=[];for(let o of this.seq)o.type===e.SAMPLER_2D_SHADOW||o.type===e.SAMPLER_CUBE_SHADOW||o.type===e.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(e,t,i,s){let r=this.map[t];r!==void 0&&r.setValue(e,i,s)}setOptional(e,t,i){let s=t[i];s!==void 0&&this.setValue(e,i,s)}static upload(e,t,i,s){for(let r=0,o=t.length;r!==o;++r){let a=t[r],l=i[a.id];l.needsUpdate!==!1&&a.setValue(e,l.value,s)}}static seqWithValue(e,t){let i=[];for(let s=0,r=e.length;s!==r;++s){let o=e[s];o.id in t&&i.push(o)}return i}};function Cx(n,e,t){let i=n.createShader(e);return n.shaderSource(i,t),n.compileShader(i),i}var CT=37297,RT=0;function PT(n,e){let t=n.split(`
`),i=[],s=Math.max(e-6,0),r=Math.min(e+6,t.length);for(let o=s;o<r;o++){let a=o+1;i.push(`${a===e?">":" "} ${a}: ${t[o]}`)}return i.join(`
`)}var Rx=new st;function IT(n){vt._getMatrix(Rx,vt.workingColorSpace,n);let e=`mat3( ${Rx.elements.map(t=>t.toFixed(4))} )`;switch(vt.getTransfer(n)){case Xa:return[e,"LinearTransferOETF"];case Rt:return[e,"sRGBTransferOETF"];default:return $e("WebGLProgram: Unsupported color space: ",n),[e,"LinearTransferOETF"]}}function Px(n,e,t){let i=n.getShaderParameter(e,n.COMPILE_STATUS),r=(n.getShaderInfoLog(e)||"").trim();if(i&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return t.toUpperCase()+`

`+r+`

`+PT(n.getShaderSource(e),a)}else return r}function LT(n,e){let t=IT(e);return[`vec4 ${n}( vec4 value ) {`,`	return ${t[1]}( vec4( ${t[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var DT={[zf]:"Linear",[Vf]:"Reinhard",[Hf]:"Cineon",[Gf]:"ACESFilmic",[Xf]:"AgX",[qf]:"Neutral",[Wf]:"Custom"};function NT(n,e){let t=DT[e];return t===void 0?($e("WebGLProgram: Unsupported toneMapping:",e),"vec3 "+n+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+n+"( vec3 color ) { return "+t+"ToneMapping( color ); }"}var wh=new z;function UT(){vt.getLuminanceCoefficients(wh);let n=wh.x.toFixed(4),e=wh.y.toFixed(4),t=wh.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${n}, ${e}, ${t} );`,"	return dot( weights, rgb );","}"].join(`
`)}function OT(n){return[n.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",n.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Tl).join(`
`)}function FT(n){let e=[];for(let t in n){let i=n[t];i!==!1&&e.push("#define "+t+" "+i)}return e.join(`
`)}function BT(n,e){let t={},i=n.getProgramParameter(e,n.ACTIVE_ATTRIBUTES);for(let s=0;s<i;s++){let r=n.getActiveAttrib(e,s),o=r.name,a=1;r.type===n.FLOAT_MAT2&&(a=2),r.type===n.FLOAT_MAT3&&(a=3),r.type===n.FLOAT_MAT4&&(a=4),t[o]={type:r.type,location:n.getAttribLocation(e,o),locationSize:a}}return t}function Tl(n){return n!==""}function Ix(n,e){let t=e.numSpotLightShadows+e.numSpotLightMaps-e.numSpotLightShadowsWithMaps;return n.replace(/NUM_SUN_LIGHTS/g,e.numSunLights).replace(/NUM_DIR_LIGHTS/g,e.numDirLights).replace(/NUM_SPOT_LIGHTS/g,e.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,e.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,t).replace(/NUM_RECT_AREA_LIGHTS/g,e.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,e.numPointLights).replace(/NUM_HEMI_LIGHTS/g,e.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,e.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,e.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,e.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,e.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,e.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,e.numLightProbeGrids)}function Lx(n,e){return n.replace(/NUM_CLIPPING_PLANES/g,e.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,e.numClippingPlanes-e.numClipIntersection)}var kT=/^[ \t]*#include +<([\w\d./]+)>/gm;function yp(n){return n.replace(kT,zT)}function zT(n,e){let t=ft[e];if(t===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+e+">");return yp(t)}var VT=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function Dx(n){return n.replace(VT,HT)}function HT(n,e,t,i){let s="";for(let r=parseInt(e);r<parseInt(t);r++)s+=i.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function Nx(n){let e=`precision ${n.precision} float;
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
#define LOW_PRECISION`),e}var GT={[ml]:"SHADOWMAP_TYPE_PCF",[Qo]:"SHADOWMAP_TYPE_VSM"};function WT(n){return GT[n.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var XT={[ta]:"ENVMAP_MODE_REFRACTION"};function qT(n){return n.envMap===!1?"ENVMAP_MODE_REFLECTION":XT[n.envMapMode]||"ENVMAP_MODE_REFLECTION"}var YT={[Uu]:"ENVMAP_BLENDING_MULTIPLY",[ex]:"ENVMAP_BLENDING_MIX",[tx]:"ENVMAP_BLENDING_ADD"};function $T(n){return n.envMap===!1?"ENVMAP_BLENDING_NONE":YT[n.combine]||"ENVMAP_BLENDING_NONE"}function JT(n,e,t,i){let s=n.getContext(),r=t.defines,o=t.vertexShader,a=t.fragmentShader,l=WT(t),c=t.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",u=qT(t),f=$T(t),h=OT(t),d=FT(r),p=s.createProgram(),b,m,g=t.glslVersion?"#version "+t.glslVersion+`
`:"";t.isRawShaderMaterial?(b=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Tl).join(`
`),b.length>0&&(b+=`
`),m=["#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d].filter(Tl).join(`
`),m.length>0&&(m+=`
`)):(b=[Nx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",t.batching?"#define USE_BATCHING":"",t.batchingColor?"#define USE_BATCHING_COLOR":"",t.instancing?"#define USE_INSTANCING":"",t.instancingColor?"#define USE_INSTANCING_COLOR":"",t.instancingMorph?"#define USE_INSTANCING_MORPH":"",t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.map?"#define USE_MAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+u:"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.displacementMap?"#define USE_DISPLACEMENTMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.mapUv?"#define MAP_UV "+t.mapUv:"",t.alphaMapUv?"#define ALPHAMAP_UV "+t.alphaMapUv:"",t.lightMapUv?"#define LIGHTMAP_UV "+t.lightMapUv:"",t.aoMapUv?"#define AOMAP_UV "+t.aoMapUv:"",t.emissiveMapUv?"#define EMISSIVEMAP_UV "+t.emissiveMapUv:"",t.bumpMapUv?"#define BUMPMAP_UV "+t.bumpMapUv:"",t.normalMapUv?"#define NORMALMAP_UV "+t.normalMapUv:"",t.displacementMapUv?"#define DISPLACEMENTMAP_UV "+t.displacementMapUv:"",t.metalnessMapUv?"#define METALNESSMAP_UV "+t.metalnessMapUv:"",t.roughnessMapUv?"#define ROUGHNESSMAP_UV "+t.roughnessMapUv:"",t.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+t.anisotropyMapUv:"",t.clearcoatMapUv?"#define CLEARCOATMAP_UV "+t.clearcoatMapUv:"",t.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+t.clearcoatNormalMapUv:"",t.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+t.clearcoatRoughnessMapUv:"",t.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+t.diffuseRoughnessMapUv:"",t.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+t.iridescenceMapUv:"",t.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+t.iridescenceThicknessMapUv:"",t.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+t.sheenColorMapUv:"",t.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+t.sheenRoughnessMapUv:"",t.specularMapUv?"#define SPECULARMAP_UV "+t.specularMapUv:"",t.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+t.specularColorMapUv:"",t.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+t.specularIntensityMapUv:"",t.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+t.transmissionMapUv:"",t.thicknessMapUv?"#define THICKNESSMAP_UV "+t.thicknessMapUv:"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexNormals?"#define HAS_NORMAL":"",t.vertexColors?"#define USE_COLOR":"",t.vertexAlphas?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.flatShading?"#define FLAT_SHADED":"",t.skinning?"#define USE_SKINNING":"",t.morphTargets?"#define USE_MORPHTARGETS":"",t.morphNormals&&t.flatShading===!1?"#define USE_MORPHNORMALS":"",t.morphColors?"#define USE_MORPHCOLORS":"",t.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+t.morphTextureStride:"",t.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+t.morphTargetsCount:"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.sizeAttenuation?"#define USE_SIZEATTENUATION":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Tl).join(`
`),m=[Nx(t),"#define SHADER_TYPE "+t.shaderType,"#define SHADER_NAME "+t.shaderName,d,t.useFog&&t.fog?"#define USE_FOG":"",t.useFog&&t.fogExp2?"#define FOG_EXP2":"",t.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",t.map?"#define USE_MAP":"",t.matcap?"#define USE_MATCAP":"",t.envMap?"#define USE_ENVMAP":"",t.envMap?"#define "+c:"",t.envMap?"#define "+u:"",t.envMap?"#define "+f:"",t.envMapPMREM?"#define ENVMAP_MAX_LOD "+t.envMapMaxLod+".0":"",t.envMapPMREM?"#define ENVMAP_SIZE "+t.envMapSize+".0":"",t.lightMap?"#define USE_LIGHTMAP":"",t.aoMap?"#define USE_AOMAP":"",t.bumpMap?"#define USE_BUMPMAP":"",t.normalMap?"#define USE_NORMALMAP":"",t.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",t.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",t.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",t.emissiveMap?"#define USE_EMISSIVEMAP":"",t.anisotropy?"#define USE_ANISOTROPY":"",t.anisotropyMap?"#define USE_ANISOTROPYMAP":"",t.clearcoat?"#define USE_CLEARCOAT":"",t.clearcoatMap?"#define USE_CLEARCOATMAP":"",t.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",t.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",t.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",t.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",t.dispersion?"#define USE_DISPERSION":"",t.retroreflection?"#define USE_RETROREFLECTION":"",t.iridescence?"#define USE_IRIDESCENCE":"",t.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",t.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",t.specularMap?"#define USE_SPECULARMAP":"",t.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",t.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",t.roughnessMap?"#define USE_ROUGHNESSMAP":"",t.metalnessMap?"#define USE_METALNESSMAP":"",t.alphaMap?"#define USE_ALPHAMAP":"",t.alphaTest?"#define USE_ALPHATEST":"",t.alphaHash?"#define USE_ALPHAHASH":"",t.sheen?"#define USE_SHEEN":"",t.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",t.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",t.transmission?"#define USE_TRANSMISSION":"",t.transmissionMap?"#define USE_TRANSMISSIONMAP":"",t.thicknessMap?"#define USE_THICKNESSMAP":"",t.vertexTangents&&t.flatShading===!1?"#define USE_TANGENT":"",t.vertexColors||t.instancingColor?"#define USE_COLOR":"",t.vertexAlphas||t.batchingColor?"#define USE_COLOR_ALPHA":"",t.vertexUv1s?"#define USE_UV1":"",t.vertexUv2s?"#define USE_UV2":"",t.vertexUv3s?"#define USE_UV3":"",t.pointsUvs?"#define USE_POINTS_UV":"",t.gradientMap?"#define USE_GRADIENTMAP":"",t.flatShading?"#define FLAT_SHADED":"",t.doubleSided?"#define DOUBLE_SIDED":"",t.flipSided?"#define FLIP_SIDED":"",t.shadowMapEnabled?"#define USE_SHADOWMAP":"",t.shadowMapEnabled?"#define "+l:"",t.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",t.numLightProbes>0?"#define USE_LIGHT_PROBES":"",t.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",t.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",t.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",t.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",t.toneMapping!==gs?"#define TONE_MAPPING":"",t.toneMapping!==gs?ft.tonemapping_pars_fragment:"",t.toneMapping!==gs?NT("toneMapping",t.toneMapping):"",t.dithering?"#define DITHERING":"",t.opaque?"#define OPAQUE":"",ft.colorspace_pars_fragment,LT("linearToOutputTexel",t.outputColorSpace),UT(),t.useDepthPacking?"#define DEPTH_PACKING "+t.depthPacking:"",`
`].filter(Tl).join(`
`)),o=yp(o),o=Ix(o,t),o=Lx(o,t),a=yp(a),a=Ix(a,t),a=Lx(a,t),o=Dx(o),a=Dx(a),t.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,b=[h,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+b,m=["#define varying in",t.glslVersion===rp?"":"layout(location = 0) out highp vec4 pc_fragColor;",t.glslVersion===rp?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let v=g+b+o,C=g+m+a,M=Cx(s,s.VERTEX_SHADER,v),I=Cx(s,s.FRAGMENT_SHADER,C);s.attachShader(p,M),s.attachShader(p,I),t.index0AttributeName!==void 0?s.bindAttribLocation(p,0,t.index0AttributeName):t.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function E(U){if(n.debug.checkShaderErrors){let D=s.getProgramInfoLog(p)||"",H=s.getShaderInfoLog(M)||"",O=s.getShaderInfoLog(I)||"",L=D.trim(),X=H.trim(),$=O.trim(),G=!0,ue=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(G=!1,typeof n.debug.onShaderError=="function")n.debug.onShaderError(s,p,M,I);else{let Z=Px(s,M,"vertex"),Q=Px(s,I,"fragment");it("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+U.name+`
Material Type: `+U.type+`

Program Info Log: `+L+`
`+Z+`
`+Q)}else L!==""?$e("WebGLProgram: Program Info Log:",L):(X===""||$==="")&&(ue=!1);ue&&(U.diagnostics={runnable:G,programLog:L,vertexShader:{log:X,prefix:b},fragmentShader:{log:$,prefix:m}})}s.deleteShader(M),s.deleteShader(I),x=new ia(s,p),T=BT(s,p)}let x;this.getUniforms=function(){return x===void 0&&E(this),x};let T;this.getAttributes=function(){return T===void 0&&E(this),T};let V=t.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return V===!1&&(V=s.getProgramParameter(p,CT)),V},this.destroy=function(){i.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=t.shaderType,this.name=t.shaderName,this.id=RT++,this.cacheKey=e,this.usedTimes=1,this.program=p,this.vertexShader=M,this.fragmentShader=I,this}var ZT=0,vp=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(e,t,i){let s=this._getShaderCacheForMaterial(e);return s.has(t)===!1&&(s.add(t),t.usedTimes++),s.has(i)===!1&&(s.add(i),i.usedTimes++),this}remove(e){let t=this.materialCache.get(e);for(let i of t)i.usedTimes--,i.usedTimes===0&&this.shaderCache.delete(i.code);return this.materialCache.delete(e),this}getVertexShaderStage(e){return this._getShaderStage(e.vertexShader)}getFragmentShaderStage(e){return this._getShaderStage(e.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(e){let t=this.materialCache,i=t.get(e);return i===void 0&&(i=new Set,t.set(e,i)),i}_getShaderStage(e){let t=this.shaderCache,i=t.get(e);return i===void 0&&(i=new bp(e),t.set(e,i)),i}},bp=class{constructor(e){this.id=ZT++,this.code=e,this.usedTimes=0}};function KT(n){return n===wr||n===bl||n===Sl}function jT(n,e,t,i,s,r){let o=new Ja,a=new vp,l=new Set,c=[],u=new Map,f=i.logarithmicDepthBuffer,h={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function d(x){return l.add(x),x===0?"uv":`uv${x}`}function p(x,T,V,U,D,H){let O=U.fog,L=D.geometry,X=x.isMeshStandardMaterial||x.isMeshLambertMaterial||x.isMeshPhongMaterial?U.environment:null,$=x.isMeshStandardMaterial||x.isMeshLambertMaterial&&!x.envMap||x.isMeshPhongMaterial&&!x.envMap,G=e.get(x.envMap||X,$),ue=h[x.type],Z=i.precision;x.precision!==null&&(Z=i.getMaxPrecision(x.precision),Z!==x.precision&&$e("WebGLProgram.getParameters:",x.precision,"not supported, using",Z,"instead."));let Q=L.morphAttributes.position||L.morphAttributes.normal||L.morphAttributes.color,ie=Q!==void 0?Q.length:0,pe=0;L.morphAttributes.position!==void 0&&(pe=1),L.morphAttributes.normal!==void 0&&(pe=2),L.morphAttributes.color!==void 0&&(pe=3);let fe,ee,_e,xe;if(ue){let Ce=di[ue];fe=Ce.vertexShader,ee=Ce.fragmentShader}else{fe=x.vertexShader,ee=x.fragmentShader;let Ce=a.getVertexShaderStage(x),ct=a.getFragmentShaderStage(x);a.update(x,Ce,ct),_e=Ce.id,xe=ct.id}let se=n.getRenderTarget(),ce=n.state.buffers.depth.getReversed(),Oe=D.isInstancedMesh===!0,Ke=D.isBatchedMesh===!0,Ge=!!x.map,pt=!!x.matcap,ht=!!G,rt=ht&&G.isPMREMTexture===!0,Zt=!!x.aoMap,Gt=!!x.lightMap,un=!!x.bumpMap&&x.wireframe===!1,Ot=!!x.normalMap,In=!!x.displacementMap,bt=!!x.emissiveMap,bn=!!x.metalnessMap,en=!!x.roughnessMap,hn=x.anisotropy>0,B=x.clearcoat>0,Re=x.diffuseRoughness>0,Je=x.dispersion>0,at=x.retroreflectivity>0,we=x.iridescence>0,zt=x.sheen>0,Ve=x.transmission>0,qe=hn&&!!x.anisotropyMap,R=B&&!!x.clearcoatMap,S=B&&!!x.clearcoatNormalMap,q=B&&!!x.clearcoatRoughnessMap,de=Re&&!!x.diffuseRoughnessMap,ae=we&&!!x.iridescenceMap,ve=we&&!!x.iridescenceThicknessMap,be=zt&&!!x.sheenColorMap,te=zt&&!!x.sheenRoughnessMap,re=!!x.specularMap,ge=!!x.specularColorMap,F=!!x.specularIntensityMap,oe=Ve&&!!x.transmissionMap,ne=Ve&&!!x.thicknessMap,Ae=!!x.gradientMap,ye=!!x.alphaMap,Me=x.alphaTest>0,We=!!x.alphaHash,et=!!x.extensions,he=gs;x.toneMapped&&(se===null||se.isXRRenderTarget===!0)&&(he=n.toneMapping);let Be=rt?G.isCompressedCubeTexture?G.image[0].mipmaps:G.mipmaps:null,tt={shaderID:ue,shaderType:x.type,shaderName:x.name,vertexShader:fe,fragmentShader:ee,defines:x.defines,customVertexShaderID:_e,customFragmentShaderID:xe,isRawShaderMaterial:x.isRawShaderMaterial===!0,glslVersion:x.glslVersion,precision:Z,batching:Ke,batchingColor:Ke&&D._colorsTexture!==null,instancing:Oe,instancingColor:Oe&&D.instanceColor!==null,instancingMorph:Oe&&D.morphTexture!==null,outputColorSpace:se===null?n.outputColorSpace:se.isXRRenderTarget===!0?se.texture.colorSpace:vt.workingColorSpace,alphaToCoverage:!!x.alphaToCoverage,map:Ge,matcap:pt,envMap:ht,envMapMode:ht&&G.mapping,envMapPMREM:rt,envMapMaxLod:rt?Be.length-1:null,envMapSize:rt?Be[0].width:null,aoMap:Zt,lightMap:Gt,bumpMap:un,normalMap:Ot,displacementMap:In,emissiveMap:bt,normalMapObjectSpace:Ot&&x.normalMapType===sx,normalMapTangentSpace:Ot&&x.normalMapType===bh,packedNormalMap:Ot&&x.normalMapType===bh&&KT(x.normalMap.format),metalnessMap:bn,roughnessMap:en,anisotropy:hn,anisotropyMap:qe,clearcoat:B,clearcoatMap:R,clearcoatNormalMap:S,clearcoatRoughnessMap:q,diffuseRoughness:Re,diffuseRoughnessMap:de,dispersion:Je,retroreflection:at,iridescence:we,iridescenceMap:ae,iridescenceThicknessMap:ve,sheen:zt,sheenColorMap:be,sheenRoughnessMap:te,specularMap:re,specularColorMap:ge,specularIntensityMap:F,transmission:Ve,transmissionMap:oe,thicknessMap:ne,gradientMap:Ae,opaque:x.transparent===!1&&x.blending===ea&&x.alphaToCoverage===!1,alphaMap:ye,alphaTest:Me,alphaHash:We,combine:x.combine,mapUv:Ge&&d(x.map.channel),aoMapUv:Zt&&d(x.aoMap.channel),lightMapUv:Gt&&d(x.lightMap.channel),bumpMapUv:un&&d(x.bumpMap.channel),normalMapUv:Ot&&d(x.normalMap.channel),displacementMapUv:In&&d(x.displacementMap.channel),emissiveMapUv:bt&&d(x.emissiveMap.channel),metalnessMapUv:bn&&d(x.metalnessMap.channel),roughnessMapUv:en&&d(x.roughnessMap.channel),anisotropyMapUv:qe&&d(x.anisotropyMap.channel),clearcoatMapUv:R&&d(x.clearcoatMap.channel),clearcoatNormalMapUv:S&&d(x.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:q&&d(x.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:de&&d(x.diffuseRoughnessMap.channel),iridescenceMapUv:ae&&d(x.iridescenceMap.channel),iridescenceThicknessMapUv:ve&&d(x.iridescenceThicknessMap.channel),sheenColorMapUv:be&&d(x.sheenColorMap.channel),sheenRoughnessMapUv:te&&d(x.sheenRoughnessMap.channel),specularMapUv:re&&d(x.specularMap.channel),specularColorMapUv:ge&&d(x.specularColorMap.channel),specularIntensityMapUv:F&&d(x.specularIntensityMap.channel),transmissionMapUv:oe&&d(x.transmissionMap.channel),thicknessMapUv:ne&&d(x.thicknessMap.channel),alphaMapUv:ye&&d(x.alphaMap.channel),vertexTangents:!!L.attributes.tangent&&(Ot||hn),vertexNormals:!!L.attributes.normal,vertexColors:x.vertexColors,vertexAlphas:x.vertexColors===!0&&!!L.attributes.color&&L.attributes.color.itemSize===4,pointsUvs:D.isPoints===!0&&!!L.attributes.uv&&(Ge||ye),fog:!!O,useFog:x.fog===!0,fogExp2:!!O&&O.isFogExp2,flatShading:x.wireframe===!1&&(x.flatShading===!0||L.attributes.normal===void 0&&Ot===!1&&(x.isMeshLambertMaterial||x.isMeshPhongMaterial||x.isMeshStandardMaterial||x.isMeshPhysicalMaterial)),sizeAttenuation:x.sizeAttenuation===!0,logarithmicDepthBuffer:f,reversedDepthBuffer:ce,skinning:D.isSkinnedMesh===!0,hasPositionAttribute:L.attributes.position!==void 0,morphTargets:L.morphAttributes.position!==void 0,morphNormals:L.morphAttributes.normal!==void 0,morphColors:L.morphAttributes.color!==void 0,morphTargetsCount:ie,morphTextureStride:pe,numSunLights:T.sun.length,numDirLights:T.directional.length,numPointLights:T.point.length,numSpotLights:T.spot.length,numSpotLightMaps:T.spotLightMap.length,numRectAreaLights:T.rectArea.length,numHemiLights:T.hemi.length,numSunLightShadows:T.sunShadowMap.length,numDirLightShadows:T.directionalShadowMap.length,numPointLightShadows:T.pointShadowMap.length,numSpotLightShadows:T.spotShadowMap.length,numSpotLightShadowsWithMaps:T.numSpotLightShadowsWithMaps,numLightProbes:T.numLightProbes,numLightProbeGrids:H.filter(Ce=>Ce.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:x.dithering,shadowMapEnabled:n.shadowMap.enabled&&V.length>0,shadowMapType:n.shadowMap.type,toneMapping:he,decodeVideoTexture:Ge&&x.map.isVideoTexture===!0&&vt.getTransfer(x.map.colorSpace)===Rt,decodeVideoTextureEmissive:bt&&x.emissiveMap.isVideoTexture===!0&&vt.getTransfer(x.emissiveMap.colorSpace)===Rt,premultipliedAlpha:x.premultipliedAlpha,doubleSided:x.side===gi,flipSided:x.side===hi,useDepthPacking:x.depthPacking>=0,depthPacking:x.depthPacking||0,index0AttributeName:x.index0AttributeName,extensionClipCullDistance:et&&x.extensions.clipCullDistance===!0&&t.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(et&&x.extensions.multiDraw===!0||Ke)&&t.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:t.has("KHR_parallel_shader_compile"),customProgramCacheKey:x.customProgramCacheKey()};return tt.vertexUv1s=l.has(1),tt.vertexUv2s=l.has(2),tt.vertexUv3s=l.has(3),l.clear(),tt}function b(x){let T=[];if(x.shaderID?T.push(x.shaderID):(T.push(x.customVertexShaderID),T.push(x.customFragmentShaderID)),x.defines!==void 0)for(let V in x.defines)T.push(V),T.push(x.defines[V]);return x.isRawShaderMaterial===!1&&(m(T,x),g(T,x),T.push(n.outputColorSpace)),T.push(x.customProgramCacheKey),T.join()}function m(x,T){x.push(T.precision),x.push(T.outputColorSpace),x.push(T.envMapMode),x.push(T.envMapPMREM),x.push(T.envMapMaxLod),x.push(T.envMapSize),x.push(T.mapUv),x.push(T.alphaMapUv),x.push(T.lightMapUv),x.push(T.aoMapUv),x.push(T.bumpMapUv),x.push(T.normalMapUv),x.push(T.displacementMapUv),x.push(T.emissiveMapUv),x.push(T.metalnessMapUv),x.push(T.roughnessMapUv),x.push(T.anisotropyMapUv),x.push(T.clearcoatMapUv),x.push(T.clearcoatNormalMapUv),x.push(T.clearcoatRoughnessMapUv),x.push(T.diffuseRoughnessMapUv),x.push(T.iridescenceMapUv),x.push(T.iridescenceThicknessMapUv),x.push(T.sheenColorMapUv),x.push(T.sheenRoughnessMapUv),x.push(T.specularMapUv),x.push(T.specularColorMapUv),x.push(T.specularIntensityMapUv),x.push(T.transmissionMapUv),x.push(T.thicknessMapUv),x.push(T.combine),x.push(T.fogExp2),x.push(T.sizeAttenuation),x.push(T.morphTargetsCount),x.push(T.numSunLights),x.push(T.numDirLights),x.push(T.numPointLights),x.push(T.numSpotLights),x.push(T.numSpotLightMaps),x.push(T.numHemiLights),x.push(T.numRectAreaLights),x.push(T.numSunLightShadows),x.push(T.numDirLightShadows),x.push(T.numPointLightShadows),x.push(T.numSpotLightShadows),x.push(T.numSpotLightShadowsWithMaps),x.push(T.numLightProbes),x.push(T.numLightProbeGrids),x.push(T.shadowMapType),x.push(T.toneMapping),x.push(T.numClippingPlanes),x.push(T.numClipIntersection),x.push(T.depthPacking)}function g(x,T){o.disableAll(),T.instancing&&o.enable(0),T.instancingColor&&o.enable(1),T.instancingMorph&&o.enable(2),T.matcap&&o.enable(3),T.envMap&&o.enable(4),T.normalMapObjectSpace&&o.enable(5),T.normalMapTangentSpace&&o.enable(6),T.clearcoat&&o.enable(7),T.iridescence&&o.enable(8),T.alphaTest&&o.enable(9),T.vertexColors&&o.enable(10),T.vertexAlphas&&o.enable(11),T.vertexUv1s&&o.enable(12),T.vertexUv2s&&o.enable(13),T.vertexUv3s&&o.enable(14),T.vertexTangents&&o.enable(15),T.anisotropy&&o.enable(16),T.alphaHash&&o.enable(17),T.batching&&o.enable(18),T.dispersion&&o.enable(19),T.retroreflection&&o.enable(24),T.diffuseRoughness&&o.enable(25),T.batchingColor&&o.enable(20),T.gradientMap&&o.enable(21),T.packedNormalMap&&o.enable(22),T.vertexNormals&&o.enable(23),x.push(o.mask),o.disableAll(),T.fog&&o.enable(0),T.useFog&&o.enable(1),T.flatShading&&o.enable(2),T.logarithmicDepthBuffer&&o.enable(3),T.reversedDepthBuffer&&o.enable(4),T.skinning&&o.enable(5),T.morphTargets&&o.enable(6),T.morphNormals&&o.enable(7),T.morphColors&&o.enable(8),T.premultipliedAlpha&&o.enable(9),T.shadowMapEnabled&&o.enable(10),T.doubleSided&&o.enable(11),T.flipSided&&o.enable(12),T.useDepthPacking&&o.enable(13),T.dithering&&o.enable(14),T.transmission&&o.enable(15),T.sheen&&o.enable(16),T.opaque&&o.enable(17),T.pointsUvs&&o.enable(18),T.decodeVideoTexture&&o.enable(19),T.decodeVideoTextureEmissive&&o.enable(20),T.alphaToCoverage&&o.enable(21),T.numLightProbeGrids>0&&o.enable(22),T.hasPositionAttribute&&o.enable(23),x.push(o.mask)}function v(x){let T=h[x.type],V;if(T){let U=di[T];V=wl.clone(U.uniforms)}else V=x.uniforms;return V}function C(x,T){let V=u.get(T);return V!==void 0?++V.usedTimes:(V=new JT(n,T,x,s),c.push(V),u.set(T,V)),V}function M(x){if(--x.usedTimes===0){let T=c.indexOf(x);c[T]=c[c.length-1],c.pop(),u.delete(x.cacheKey),x.destroy()}}function I(x){a.remove(x)}function E(){a.dispose()}return{getParameters:p,getProgramCacheKey:b,getUniforms:v,acquireProgram:C,releaseProgram:M,releaseShaderCache:I,programs:c,dispose:E}}function QT(){let n=new WeakMap;function e(o){return n.has(o)}function t(o){let a=n.get(o);return a===void 0&&(a={},n.set(o,a)),a}function i(o){n.delete(o)}function s(o,a,l){n.get(o)[a]=l}function r(){n=new WeakMap}return{has:e,get:t,remove:i,update:s,dispose:r}}function eE(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.material.id!==e.material.id?n.material.id-e.material.id:n.materialVariant!==e.materialVariant?n.materialVariant-e.materialVariant:n.z!==e.z?n.z-e.z:n.id-e.id}function Ux(n,e){return n.groupOrder!==e.groupOrder?n.groupOrder-e.groupOrder:n.renderOrder!==e.renderOrder?n.renderOrder-e.renderOrder:n.z!==e.z?e.z-n.z:n.id-e.id}function Ox(){let n=[],e=0,t=[],i=[],s=[];function r(){e=0,t.length=0,i.length=0,s.length=0}function o(h){let d=0;return h.isInstancedMesh&&(d+=2),h.isSkinnedMesh&&(d+=1),d}function a(h,d,p,b,m,g){let v=n[e];return v===void 0?(v={id:h.id,object:h,geometry:d,material:p,materialVariant:o(h),groupOrder:b,renderOrder:h.renderOrder,z:m,group:g},n[e]=v):(v.id=h.id,v.object=h,v.geometry=d,v.material=p,v.materialVariant=o(h),v.groupOrder=b,v.renderOrder=h.renderOrder,v.z=m,v.group=g),e++,v}function l(h,d,p,b,m,g,v){v.reversedDepth===!0&&(m=-m);let C=a(h,d,p,b,m,g);p.transmission>0?i.push(C):p.transparent===!0?s.push(C):t.push(C)}function c(h,d,p,b,m,g){let v=a(h,d,p,b,m,g);p.transmission>0?i.unshift(v):p.transparent===!0?s.unshift(v):t.unshift(v)}function u(h,d){t.length>1&&t.sort(h||eE),i.length>1&&i.sort(d||Ux),s.length>1&&s.sort(d||Ux)}function f(){for(let h=e,d=n.length;h<d;h++){let p=n[h];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:t,transmissive:i,transparent:s,init:r,push:l,unshift:c,finish:f,sort:u}}function tE(){let n=new WeakMap;function e(i,s){let r=n.get(i),o;return r===void 0?(o=new Ox,n.set(i,[o])):s>=r.length?(o=new Ox,r.push(o)):o=r[s],o}function t(){n=new WeakMap}return{get:e,dispose:t}}function nE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={direction:new z,color:new ut};break;case"SpotLight":t={position:new z,direction:new z,color:new ut,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":t={position:new z,color:new ut,distance:0,decay:0};break;case"HemisphereLight":t={direction:new z,skyColor:new ut,groundColor:new ut};break;case"RectAreaLight":t={color:new ut,position:new z,halfWidth:new z,halfHeight:new z};break}return n[e.id]=t,t}}}function iE(){let n={};return{get:function(e){if(n[e.id]!==void 0)return n[e.id];let t;switch(e.type){case"SunLight":case"DirectionalLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"SpotLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze};break;case"PointLight":t={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Ze,shadowCameraNear:1,shadowCameraFar:1e3};break}return n[e.id]=t,t}}}var sE=0;function rE(n,e){return(e.castShadow?2:0)-(n.castShadow?2:0)+(e.map?1:0)-(n.map?1:0)}function oE(n){let e=new nE,t=iE(),i={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let c=0;c<9;c++)i.probe.push(new z);let s=new z,r=new St,o=new St;function a(c){let u=0,f=0,h=0;for(let H=0;H<9;H++)i.probe[H].set(0,0,0);let d=0,p=0,b=0,m=0,g=0,v=0,C=0,M=0,I=0,E=0,x=0,T=0,V=0,U=0;c.sort(rE);for(let H=0,O=c.length;H<O;H++){let L=c[H],X=L.color,$=L.intensity,G=L.distance,ue=null;if(L.shadow&&L.shadow.map&&(L.shadow.map.texture.format===wr?ue=L.shadow.map.texture:ue=L.shadow.map.depthTexture||L.shadow.map.texture),L.isAmbientLight)u+=X.r*$,f+=X.g*$,h+=X.b*$;else if(L.isLightProbe){for(let Z=0;Z<9;Z++)i.probe[Z].addScaledVector(L.sh.coefficients[Z],$);U++}else if(L.isSunLight){let Z=e.get(L);if(Z.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Q=L.shadow,ie=t.get(L);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize.copy(Q.mapSize).multiply(Q.getFrameExtents()),i.sunShadow[p]=ie,i.sunShadowMap[p]=ue;let pe=Q.getViewportCount();for(let fe=0;fe<pe;fe++)i.sunShadowMatrix[b+fe]=Q.getMatrix(fe),i.sunShadowCascade[b+fe]=Q._cascadeData[fe];b+=pe,p++}i.sun[d]=Z,d++}else if(L.isDirectionalLight){let Z=e.get(L);if(Z.color.copy(L.color).multiplyScalar(L.intensity),L.castShadow){let Q=L.shadow,ie=t.get(L);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.directionalShadow[m]=ie,i.directionalShadowMap[m]=ue,i.directionalShadowMatrix[m]=L.shadow.matrix,I++}i.directional[m]=Z,m++}else if(L.isSpotLight){let Z=e.get(L);Z.position.setFromMatrixPosition(L.matrixWorld),Z.color.copy(X).multiplyScalar($),Z.distance=G,Z.coneCos=Math.cos(L.angle),Z.penumbraCos=Math.cos(L.angle*(1-L.penumbra)),Z.decay=L.decay,i.spot[v]=Z;let Q=L.shadow;if(L.map&&(i.spotLightMap[T]=L.map,T++,Q.updateMatrices(L),L.castShadow&&V++),i.spotLightMatrix[v]=Q.matrix,L.castShadow){let ie=t.get(L);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,i.spotShadow[v]=ie,i.spotShadowMap[v]=ue,x++}v++}else if(L.isRectAreaLight){let Z=e.get(L);Z.color.copy(X).multiplyScalar($),Z.halfWidth.set(L.width*.5,0,0),Z.halfHeight.set(0,L.height*.5,0),i.rectArea[C]=Z,C++}else if(L.isPointLight){let Z=e.get(L);if(Z.color.copy(L.color).multiplyScalar(L.intensity),Z.distance=L.distance,Z.decay=L.decay,L.castShadow){let Q=L.shadow,ie=t.get(L);ie.shadowIntensity=Q.intensity,ie.shadowBias=Q.bias,ie.shadowNormalBias=Q.normalBias,ie.shadowRadius=Q.radius,ie.shadowMapSize=Q.mapSize,ie.shadowCameraNear=Q.camera.near,ie.shadowCameraFar=Q.camera.far,i.pointShadow[g]=ie,i.pointShadowMap[g]=ue,i.pointShadowMatrix[g]=L.shadow.matrix,E++}i.point[g]=Z,g++}else if(L.isHemisphereLight){let Z=e.get(L);Z.skyColor.copy(L.color).multiplyScalar($),Z.groundColor.copy(L.groundColor).multiplyScalar($),i.hemi[M]=Z,M++}}C>0&&(n.has("OES_texture_float_linear")===!0?(i.rectAreaLTC1=Pe.LTC_FLOAT_1,i.rectAreaLTC2=Pe.LTC_FLOAT_2):(i.rectAreaLTC1=Pe.LTC_HALF_1,i.rectAreaLTC2=Pe.LTC_HALF_2)),i.ambient[0]=u,i.ambient[1]=f,i.ambient[2]=h;let D=i.hash;(D.sunLength!==d||D.directionalLength!==m||D.pointLength!==g||D.spotLength!==v||D.rectAreaLength!==C||D.hemiLength!==M||D.numSunShadows!==p||D.numDirectionalShadows!==I||D.numPointShadows!==E||D.numSpotShadows!==x||D.numSpotMaps!==T||D.numLightProbes!==U)&&(i.sun.length=d,i.directional.length=m,i.spot.length=v,i.rectArea.length=C,i.point.length=g,i.hemi.length=M,i.sunShadow.length=p,i.sunShadowMap.length=p,i.sunShadowMatrix.length=b,i.sunShadowCascade.length=b,i.directionalShadow.length=I,i.directionalShadowMap.length=I,i.directionalShadowMatrix.length=I,i.pointShadow.length=E,i.pointShadowMap.length=E,i.pointShadowMatrix.length=E,i.spotShadow.length=x,i.spotShadowMap.length=x,i.spotLightMatrix.length=x+T-V,i.spotLightMap.length=T,i.numSpotLightShadowsWithMaps=V,i.numLightProbes=U,D.sunLength=d,D.directionalLength=m,D.pointLength=g,D.spotLength=v,D.rectAreaLength=C,D.hemiLength=M,D.numSunShadows=p,D.numDirectionalShadows=I,D.numPointShadows=E,D.numSpotShadows=x,D.numSpotMaps=T,D.numLightProbes=U,i.version=sE++)}function l(c,u){let f=0,h=0,d=0,p=0,b=0,m=0,g=u.matrixWorldInverse;for(let v=0,C=c.length;v<C;v++){let M=c[v];if(M.isSunLight){let I=i.sun[f];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(g),f++}else if(M.isDirectionalLight){let I=i.directional[h];I.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(g),h++}else if(M.isSpotLight){let I=i.spot[p];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),I.direction.setFromMatrixPosition(M.matrixWorld),s.setFromMatrixPosition(M.target.matrixWorld),I.direction.sub(s),I.direction.transformDirection(g),p++}else if(M.isRectAreaLight){let I=i.rectArea[b];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),o.identity(),r.copy(M.matrixWorld),r.premultiply(g),o.extractRotation(r),I.halfWidth.set(M.width*.5,0,0),I.halfHeight.set(0,M.height*.5,0),I.halfWidth.applyMatrix4(o),I.halfHeight.applyMatrix4(o),b++}else if(M.isPointLight){let I=i.point[d];I.position.setFromMatrixPosition(M.matrixWorld),I.position.applyMatrix4(g),d++}else if(M.isHemisphereLight){let I=i.hemi[m];I.direction.setFromMatrixPosition(M.matrixWorld),I.direction.transformDirection(g),m++}}}return{setup:a,setupView:l,state:i}}function Fx(n){let e=new oE(n),t=[],i=[],s=[];function r(f){u.camera=f,t.length=0,i.length=0,s.length=0}function o(f){f.isLightProbeGrid?s.push(f):t.push(f)}function a(f){i.push(f)}function l(){e.setup(t),s.sort((f,h)=>f.priority-h.priority||f.id-h.id)}function c(f){e.setupView(t,f)}let u={lightsArray:t,shadowsArray:i,lightProbeGridArray:s,camera:null,lights:e,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:u,setupLights:l,setupLightsView:c,pushLight:o,pushShadow:a}}function aE(n){let e=new WeakMap;function t(s,r=0){let o=e.get(s),a;return o===void 0?(a=new Fx(n),e.set(s,[a])):r>=o.length?(a=new Fx(n),o.push(a)):a=o[r],a}function i(){e=new WeakMap}return{get:t,dispose:i}}var lE=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,cE=`uniform sampler2D shadow_pass;
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
}`,uE=[new z(1,0,0),new z(-1,0,0),new z(0,1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1)],hE=[new z(0,-1,0),new z(0,-1,0),new z(0,0,1),new z(0,0,-1),new z(0,-1,0),new z(0,-1,0)],Bx=new St,Al=new z,mp=new z;function dE(n,e,t){let i=new mr,s=new Ze,r=new Ze,o=new Pt,a=new bu,l=new Su,c={},u=t.maxTextureSize,f={[Mr]:hi,[hi]:Mr,[gi]:gi},h=new ki({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Ze},radius:{value:4}},vertexShader:lE,fragmentShader:cE}),d=h.clone();d.defines.HORIZONTAL_PASS=1;let p=new vn;p.setAttribute("position",new yn(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let b=new Hn(p,h),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=ml;let g=this.type;this.render=function(E,x,T){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||E.length===0)return;this.type===U_&&($e("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=ml);let V=n.getRenderTarget(),U=n.getActiveCubeFace(),D=n.getActiveMipmapLevel(),H=n.state;H.setBlending(qr),H.buffers.depth.getReversed()===!0?H.buffers.color.setClear(0,0,0,0):H.buffers.color.setClear(1,1,1,1),H.buffers.depth.setTest(!0),H.setScissorTest(!1);let O=g!==this.type;O&&x.traverse(function(L){L.material&&(Array.isArray(L.material)?L.material.forEach(X=>X.needsUpdate=!0):L.material.needsUpdate=!0)});for(let L=0,X=E.length;L<X;L++){let $=E[L],G=$.shadow;if(G===void 0){$e("WebGLShadowMap:",$,"has no shadow.");continue}if(G.autoUpdate===!1&&G.needsUpdate===!1)continue;s.copy(G.mapSize);let ue=G.getFrameExtents();s.multiply(ue),r.copy(G.mapSize),(s.x>u||s.y>u)&&(s.x>u&&(r.x=Math.floor(u/ue.x),s.x=r.x*ue.x,G.mapSize.x=r.x),s.y>u&&(r.y=Math.floor(u/ue.y),s.y=r.y*ue.y,G.mapSize.y=r.y));let Z=n.state.buffers.depth.getReversed();if(G.camera._reversedDepth=Z,G.map===null||O===!0){if(G.map!==null&&(G.map.depthTexture!==null&&(G.map.depthTexture.dispose(),G.map.depthTexture=null),G.map.dispose()),this.type===Qo){if($.isPointLight){$e("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}G.map=new Ri(s.x,s.y,{format:wr,type:ts,minFilter:ui,magFilter:ui,generateMipmaps:!1}),G.map.texture.name=$.name+".shadowMap",G.map.depthTexture=new zs(s.x,s.y,es),G.map.depthTexture.name=$.name+".shadowMapDepth",G.map.depthTexture.format=Bs,G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=cn,G.map.depthTexture.magFilter=cn}else $.isPointLight?(G.map=new El(s.x),G.map.depthTexture=new tl(s.x,Qi)):(G.map=new Ri(s.x,s.y),G.map.depthTexture=new zs(s.x,s.y,Qi)),G.map.depthTexture.name=$.name+".shadowMap",G.map.depthTexture.format=Bs,this.type===ml?(G.map.depthTexture.compareFunction=Z?np:tp,G.map.depthTexture.minFilter=ui,G.map.depthTexture.magFilter=ui):(G.map.depthTexture.compareFunction=null,G.map.depthTexture.minFilter=cn,G.map.depthTexture.magFilter=cn);G.camera.updateProjectionMatrix()}G.map.isWebGLCubeRenderTarget!==!0&&(G.map.width!==s.x||G.map.height!==s.y)&&G.map.setSize(s.x,s.y);let Q=G.map.isWebGLCubeRenderTarget?6:G.getViewportCount();$.isPointLight!==!0&&G.updateMatrices($,T);let ie=(G.camera.layers.mask&4294967294)!==0?G.camera.layers:T.layers;for(let pe=0;pe<Q;pe++){let fe=G.getCamera(pe);if($.isPointLight){let ee=G.camera,_e=G.matrix,xe=$.distance||ee.far;xe!==ee.far&&(ee.far=xe,ee.updateProjectionMatrix()),Al.setFromMatrixPosition($.matrixWorld),ee.position.copy(Al),mp.copy(ee.position),mp.add(uE[pe]),ee.up.copy(hE[pe]),ee.lookAt(mp),ee.updateMatrixWorld(),_e.makeTranslation(-Al.x,-Al.y,-Al.z),Bx.multiplyMatrices(ee.projectionMatrix,ee.matrixWorldInverse),G._frustum.setFromProjectionMatrix(Bx,ee.coordinateSystem,ee.reversedDepth)}if(G.map.isWebGLCubeRenderTarget)n.setRenderTarget(G.map,pe),n.clear();else{pe===0&&(n.setRenderTarget(G.map),n.clear());let ee=G.getViewport(pe);o.set(r.x*ee.x,r.y*ee.y,r.x*ee.z,r.y*ee.w),H.viewport(o)}i=G.getFrustum(pe),M(x,T,fe,$,ie,this.type)}G.isPointLightShadow!==!0&&this.type===Qo&&v(G,T),G.needsUpdate=!1}g=this.type,m.needsUpdate=!1,n.setRenderTarget(V,U,D)};function v(E,x){let T=e.update(b);h.defines.VSM_SAMPLES!==E.blurSamples&&(h.defines.VSM_SAMPLES=E.blurSamples,d.defines.VSM_SAMPLES=E.blurSamples,h.needsUpdate=!0,d.needsUpdate=!0),E.mapPass===null?E.mapPass=new Ri(s.x,s.y,{format:wr,type:ts}):(E.mapPass.width!==E.map.width||E.mapPass.height!==E.map.height)&&E.mapPass.setSize(E.map.width,E.map.height),h.uniforms.shadow_pass.value=E.map.depthTexture,h.uniforms.resolution.value.set(E.map.width,E.map.height),h.uniforms.radius.value=E.radius,n.setRenderTarget(E.mapPass),n.clear(),n.renderBufferDirect(x,null,T,h,b,null),d.uniforms.shadow_pass.value=E.mapPass.texture,d.uniforms.resolution.value.set(E.map.width,E.map.height),d.uniforms.radius.value=E.radius,n.setRenderTarget(E.map),n.clear(),n.renderBufferDirect(x,null,T,d,b,null)}function C(E,x,T,V){let U=null,D=T.isPointLight===!0?E.customDistanceMaterial:E.customDepthMaterial;if(D!==void 0)U=D;else if(U=T.isPointLight===!0?l:a,n.localClippingEnabled&&x.clipShadows===!0&&Array.isArray(x.clippingPlanes)&&x.clippingPlanes.length!==0||x.displacementMap&&x.displacementScale!==0||x.alphaMap&&x.alphaTest>0||x.map&&x.alphaTest>0||x.alphaToCoverage===!0){let H=U.uuid,O=x.uuid,L=c[H];L===void 0&&(L={},c[H]=L);let X=L[O];X===void 0&&(X=U.clone(),L[O]=X,x.addEventListener("dispose",I)),U=X}if(U.visible=x.visible,U.wireframe=x.wireframe,V===Qo?U.side=x.shadowSide!==null?x.shadowSide:x.side:U.side=x.shadowSide!==null?x.shadowSide:f[x.side],U.alphaMap=x.alphaMap,U.alphaTest=x.alphaToCoverage===!0?.5:x.alphaTest,U.map=x.map,U.clipShadows=x.clipShadows,U.clippingPlanes=x.clippingPlanes,U.clipIntersection=x.clipIntersection,U.displacementMap=x.displacementMap,U.displacementScale=x.displacementScale,U.displacementBias=x.displacementBias,U.wireframeLinewidth=x.wireframeLinewidth,U.linewidth=x.linewidth,T.isPointLight===!0&&U.isMeshDistanceMaterial===!0){let H=n.properties.get(U);H.light=T}return U}function M(E,x,T,V,U,D){if(E.visible===!1)return;if(E.layers.test(U)&&(E.isMesh||E.isLine||E.isPoints)&&(E.castShadow||E.receiveShadow&&D===Qo)&&(!E.frustumCulled||E.intersectsFrustum(i))){E.modelViewMatrix.multiplyMatrices(T.matrixWorldInverse,E.matrixWorld);let L=e.update(E),X=E.material;if(Array.isArray(X)){let $=L.groups;for(let G=0,ue=$.length;G<ue;G++){let Z=$[G],Q=X[Z.materialIndex];if(Q&&Q.visible){let ie=C(E,Q,V,D);E.onBeforeShadow(n,E,x,T,L,ie,Z),n.renderBufferDirect(T,null,L,ie,E,Z),E.onAfterShadow(n,E,x,T,L,ie,Z)}}}else if(X.visible){let $=C(E,X,V,D);E.onBeforeShadow(n,E,x,T,L,$,null),n.renderBufferDirect(T,null,L,$,E,null),E.onAfterShadow(n,E,x,T,L,$,null)}}let O=E.children;for(let L=0,X=O.length;L<X;L++)M(O[L],x,T,V,U,D)}function I(E){E.target.removeEventListener("dispose",I);for(let T in c){let V=c[T],U=E.target.uuid;U in V&&(V[U].dispose(),delete V[U])}}}function fE(n,e){function t(){let F=!1,oe=new Pt,ne=null,Ae=new Pt(0,0,0,0);return{setMask:function(ye){ne!==ye&&!F&&(n.colorMask(ye,ye,ye,ye),ne=ye)},setLocked:function(ye){F=ye},setClear:function(ye,Me,We,et,he){he===!0&&(ye*=et,Me*=et,We*=et),oe.set(ye,Me,We,et),Ae.equals(oe)===!1&&(n.clearColor(ye,Me,We,et),Ae.copy(oe))},reset:function(){F=!1,ne=null,Ae.set(-1,0,0,0)}}}function i(){let F=!1,oe=!1,ne=null,Ae=null,ye=null;return{setReversed:function(Me){if(oe!==Me){let We=e.get("EXT_clip_control");Me?We.clipControlEXT(We.LOWER_LEFT_EXT,We.ZERO_TO_ONE_EXT):We.clipControlEXT(We.LOWER_LEFT_EXT,We.NEGATIVE_ONE_TO_ONE_EXT),oe=Me;let et=ye;ye=null,this.setClear(et)}},getReversed:function(){return oe},setTest:function(Me){Me?ce(n.DEPTH_TEST):Oe(n.DEPTH_TEST)},setMask:function(Me){ne!==Me&&!F&&(n.depthMask(Me),ne=Me)},setFunc:function(Me){if(oe&&(Me=px[Me]),Ae!==Me){switch(Me){case nu:n.depthFunc(n.NEVER);break;case iu:n.depthFunc(n.ALWAYS);break;case su:n.depthFunc(n.LESS);break;case fr:n.depthFunc(n.LEQUAL);break;case ru:n.depthFunc(n.EQUAL);break;case ou:n.depthFunc(n.GEQUAL);break;case au:n.depthFunc(n.GREATER);break;case lu:n.depthFunc(n.NOTEQUAL);break;default:n.depthFunc(n.LEQUAL)}Ae=Me}},setLocked:function(Me){F=Me},setClear:function(Me){ye!==Me&&(ye=Me,oe&&(Me=1-Me),n.clearDepth(Me))},reset:function(){F=!1,ne=null,Ae=null,ye=null,oe=!1}}}function s(){let F=!1,oe=null,ne=null,Ae=null,ye=null,Me=null,We=null,et=null,he=null;return{setTest:function(Be){F||(Be?ce(n.STENCIL_TEST):Oe(n.STENCIL_TEST))},setMask:function(Be){oe!==Be&&!F&&(n.stencilMask(Be),oe=Be)},setFunc:function(Be,tt,Ce){(ne!==Be||Ae!==tt||ye!==Ce)&&(n.stencilFunc(Be,tt,Ce),ne=Be,Ae=tt,ye=Ce)},setOp:function(Be,tt,Ce){(Me!==Be||We!==tt||et!==Ce)&&(n.stencilOp(Be,tt,Ce),Me=Be,We=tt,et=Ce)},setLocked:function(Be){F=Be},setClear:function(Be){he!==Be&&(n.clearStencil(Be),he=Be)},reset:function(){F=!1,oe=null,ne=null,Ae=null,ye=null,Me=null,We=null,et=null,he=null}}}let r=new t,o=new i,a=new s,l={},c=new WeakMap,u={},f={},h={},d=new WeakMap,p=[],b=null,m=!1,g=null,v=null,C=null,M=null,I=null,E=null,x=null,T=new ut(0,0,0),V=0,U=!1,D=null,H=null,O=null,L=null,X=null,$=n.getParameter(n.MAX_COMBINED_TEXTURE_IMAGE_UNITS),G=!1,ue=0,Z=n.getParameter(n.VERSION);Z.indexOf("WebGL")!==-1?(ue=parseFloat(/^WebGL (\d)/.exec(Z)[1]),G=ue>=1):Z.indexOf("OpenGL ES")!==-1&&(ue=parseFloat(/^OpenGL ES (\d)/.exec(Z)[1]),G=ue>=2);let Q=null,ie={},pe=n.getParameter(n.SCISSOR_BOX),fe=n.getParameter(n.VIEWPORT),ee=new Pt().fromArray(pe),_e=new Pt().fromArray(fe);function xe(F,oe,ne,Ae){let ye=new Uint8Array(4),Me=n.createTexture();n.bindTexture(F,Me),n.texParameteri(F,n.TEXTURE_MIN_FILTER,n.NEAREST),n.texParameteri(F,n.TEXTURE_MAG_FILTER,n.NEAREST);for(let We=0;We<ne;We++)F===n.TEXTURE_3D||F===n.TEXTURE_2D_ARRAY?n.texImage3D(oe,0,n.RGBA,1,1,Ae,0,n.RGBA,n.UNSIGNED_BYTE,ye):n.texImage2D(oe+We,0,n.RGBA,1,1,0,n.RGBA,n.UNSIGNED_BYTE,ye);return Me}let se={};se[n.TEXTURE_2D]=xe(n.TEXTURE_2D,n.TEXTURE_2D,1),se[n.TEXTURE_CUBE_MAP]=xe(n.TEXTURE_CUBE_MAP,n.TEXTURE_CUBE_MAP_POSITIVE_X,6),se[n.TEXTURE_2D_ARRAY]=xe(n.TEXTURE_2D_ARRAY,n.TEXTURE_2D_ARRAY,1,1),se[n.TEXTURE_3D]=xe(n.TEXTURE_3D,n.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),ce(n.DEPTH_TEST),o.setFunc(fr),un(!1),Ot(Nf),ce(n.CULL_FACE),Zt(qr);function ce(F){u[F]!==!0&&(n.enable(F),u[F]=!0)}function Oe(F){u[F]!==!1&&(n.disable(F),u[F]=!1)}function Ke(F,oe){return h[F]!==oe?(n.bindFramebuffer(F,oe),h[F]=oe,F===n.DRAW_FRAMEBUFFER&&(h[n.FRAMEBUFFER]=oe),F===n.FRAMEBUFFER&&(h[n.DRAW_FRAMEBUFFER]=oe),!0):!1}function Ge(F,oe){let ne=p,Ae=!1;if(F){ne=d.get(oe),ne===void 0&&(ne=[],d.set(oe,ne));let ye=F.textures;if(ne.length!==ye.length||ne[0]!==n.COLOR_ATTACHMENT0){for(let Me=0,We=ye.length;Me<We;Me++)ne[Me]=n.COLOR_ATTACHMENT0+Me;ne.length=ye.length,Ae=!0}}else ne[0]!==n.BACK&&(ne[0]=n.BACK,Ae=!0);Ae&&n.drawBuffers(ne)}function pt(F){return b!==F?(n.useProgram(F),b=F,!0):!1}let ht={[Yr]:n.FUNC_ADD,[F_]:n.FUNC_SUBTRACT,[B_]:n.FUNC_REVERSE_SUBTRACT};ht[k_]=n.MIN,ht[z_]=n.MAX;let rt={[V_]:n.ZERO,[H_]:n.ONE,[G_]:n.SRC_COLOR,[Bf]:n.SRC_ALPHA,[J_]:n.SRC_ALPHA_SATURATE,[Y_]:n.DST_COLOR,[X_]:n.DST_ALPHA,[W_]:n.ONE_MINUS_SRC_COLOR,[kf]:n.ONE_MINUS_SRC_ALPHA,[$_]:n.ONE_MINUS_DST_COLOR,[q_]:n.ONE_MINUS_DST_ALPHA,[Z_]:n.CONSTANT_COLOR,[K_]:n.ONE_MINUS_CONSTANT_COLOR,[j_]:n.CONSTANT_ALPHA,[Q_]:n.ONE_MINUS_CONSTANT_ALPHA};function Zt(F,oe,ne,Ae,ye,Me,We,et,he,Be){if(F===qr){m===!0&&(Oe(n.BLEND),m=!1);return}if(m===!1&&(ce(n.BLEND),m=!0),F!==O_){if(F!==g||Be!==U){if((v!==Yr||I!==Yr)&&(n.blendEquation(n.FUNC_ADD),v=Yr,I=Yr),Be)switch(F){case ea:n.blendFuncSeparate(n.ONE,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Uf:n.blendFunc(n.ONE,n.ONE);break;case Of:n.blendFuncSeparate(n.ZERO,n.ONE_MINUS_SRC_COLOR,n.ZERO,n.ONE);break;case Ff:n.blendFuncSeparate(n.DST_COLOR,n.ONE_MINUS_SRC_ALPHA,n.ZERO,n.ONE);break;default:it("WebGLState: Invalid blending: ",F);break}else switch(F){case ea:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE_MINUS_SRC_ALPHA,n.ONE,n.ONE_MINUS_SRC_ALPHA);break;case Uf:n.blendFuncSeparate(n.SRC_ALPHA,n.ONE,n.ONE,n.ONE);break;case Of:it("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Ff:it("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:it("WebGLState: Invalid blending: ",F);break}C=null,M=null,E=null,x=null,T.set(0,0,0),V=0,g=F,U=Be}return}ye=ye||oe,Me=Me||ne,We=We||Ae,(oe!==v||ye!==I)&&(n.blendEquationSeparate(ht[oe],ht[ye]),v=oe,I=ye),(ne!==C||Ae!==M||Me!==E||We!==x)&&(n.blendFuncSeparate(rt[ne],rt[Ae],rt[Me],rt[We]),C=ne,M=Ae,E=Me,x=We),(et.equals(T)===!1||he!==V)&&(n.blendColor(et.r,et.g,et.b,he),T.copy(et),V=he),g=F,U=!1}function Gt(F,oe){F.side===gi?Oe(n.CULL_FACE):ce(n.CULL_FACE);let ne=F.side===hi;oe&&(ne=!ne),un(ne),F.blending===ea&&F.transparent===!1?Zt(qr):Zt(F.blending,F.blendEquation,F.blendSrc,F.blendDst,F.blendEquationAlpha,F.blendSrcAlpha,F.blendDstAlpha,F.blendColor,F.blendAlpha,F.premultipliedAlpha),o.setFunc(F.depthFunc),o.setTest(F.depthTest),o.setMask(F.depthWrite),r.setMask(F.colorWrite);let Ae=F.stencilWrite;a.setTest(Ae),Ae&&(a.setMask(F.stencilWriteMask),a.setFunc(F.stencilFunc,F.stencilRef,F.stencilFuncMask),a.setOp(F.stencilFail,F.stencilZFail,F.stencilZPass)),bt(F.polygonOffset,F.polygonOffsetFactor,F.polygonOffsetUnits),F.alphaToCoverage===!0?ce(n.SAMPLE_ALPHA_TO_COVERAGE):Oe(n.SAMPLE_ALPHA_TO_COVERAGE)}function un(F){D!==F&&(F?n.frontFace(n.CW):n.frontFace(n.CCW),D=F)}function Ot(F){F!==D_?(ce(n.CULL_FACE),F!==H&&(F===Nf?n.cullFace(n.BACK):F===N_?n.cullFace(n.FRONT):n.cullFace(n.FRONT_AND_BACK))):Oe(n.CULL_FACE),H=F}function In(F){F!==O&&(G&&n.lineWidth(F),O=F)}function bt(F,oe,ne){F?(ce(n.POLYGON_OFFSET_FILL),(L!==oe||X!==ne)&&(L=oe,X=ne,o.getReversed()&&(oe=-oe,ne=-ne),n.polygonOffset(oe,ne))):Oe(n.POLYGON_OFFSET_FILL)}function bn(F){F?ce(n.SCISSOR_TEST):Oe(n.SCISSOR_TEST)}function en(F){F===void 0&&(F=n.TEXTURE0+$-1),Q!==F&&(n.activeTexture(F),Q=F)}function hn(F,oe,ne){ne===void 0&&(Q===null?ne=n.TEXTURE0+$-1:ne=Q);let Ae=ie[ne];Ae===void 0&&(Ae={type:void 0,texture:void 0},ie[ne]=Ae),(Ae.type!==F||Ae.texture!==oe)&&(Q!==ne&&(n.activeTexture(ne),Q=ne),n.bindTexture(F,oe||se[F]),Ae.type=F,Ae.texture=oe)}function B(){let F=ie[Q];F!==void 0&&F.type!==void 0&&(n.bindTexture(F.type,null),F.type=void 0,F.texture=void 0)}function Re(){try{n.compressedTexImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function Je(){try{n.compressedTexImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function at(){try{n.texSubImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function we(){try{n.texSubImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function zt(){try{n.compressedTexSubImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function Ve(){try{n.compressedTexSubImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function qe(){try{n.texStorage2D(...arguments)}catch(F){it("WebGLState:",F)}}function R(){try{n.texStorage3D(...arguments)}catch(F){it("WebGLState:",F)}}function S(){try{n.texImage2D(...arguments)}catch(F){it("WebGLState:",F)}}function q(){try{n.texImage3D(...arguments)}catch(F){it("WebGLState:",F)}}function de(F){return f[F]!==void 0?f[F]:n.getParameter(F)}function ae(F,oe){f[F]!==oe&&(n.pixelStorei(F,oe),f[F]=oe)}function ve(F){ee.equals(F)===!1&&(n.scissor(F.x,F.y,F.z,F.w),ee.copy(F))}function be(F){_e.equals(F)===!1&&(n.viewport(F.x,F.y,F.z,F.w),_e.copy(F))}function te(F,oe){let ne=c.get(oe);ne===void 0&&(ne=new WeakMap,c.set(oe,ne));let Ae=ne.get(F);Ae===void 0&&(Ae=n.getUniformBlockIndex(oe,F.name),n.uniformBlockBinding(oe,Ae,Ae),ne.set(F,Ae))}function re(F,oe,ne){let ye=c.get(oe).get(F);l[ye]!==ne&&(n.bindBufferBase(n.UNIFORM_BUFFER,ye,ne),l[ye]=ne)}function ge(){n.disable(n.BLEND),n.disable(n.CULL_FACE),n.disable(n.DEPTH_TEST),n.disable(n.POLYGON_OFFSET_FILL),n.disable(n.SCISSOR_TEST),n.disable(n.STENCIL_TEST),n.disable(n.SAMPLE_ALPHA_TO_COVERAGE),n.blendEquation(n.FUNC_ADD),n.blendFunc(n.ONE,n.ZERO),n.blendFuncSeparate(n.ONE,n.ZERO,n.ONE,n.ZERO),n.blendColor(0,0,0,0),n.colorMask(!0,!0,!0,!0),n.clearColor(0,0,0,0),n.depthMask(!0),n.depthFunc(n.LESS),o.setReversed(!1),n.clearDepth(1),n.stencilMask(4294967295),n.stencilFunc(n.ALWAYS,0,4294967295),n.stencilOp(n.KEEP,n.KEEP,n.KEEP),n.clearStencil(0),n.cullFace(n.BACK),n.frontFace(n.CCW),n.polygonOffset(0,0),n.activeTexture(n.TEXTURE0),n.bindFramebuffer(n.FRAMEBUFFER,null),n.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),n.bindFramebuffer(n.READ_FRAMEBUFFER,null),n.useProgram(null),n.lineWidth(1),n.scissor(0,0,n.canvas.width,n.canvas.height),n.viewport(0,0,n.canvas.width,n.canvas.height),n.pixelStorei(n.PACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_ALIGNMENT,4),n.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,!1),n.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),n.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,n.BROWSER_DEFAULT_WEBGL),n.pixelStorei(n.PACK_ROW_LENGTH,0),n.pixelStorei(n.PACK_SKIP_PIXELS,0),n.pixelStorei(n.PACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_ROW_LENGTH,0),n.pixelStorei(n.UNPACK_IMAGE_HEIGHT,0),n.pixelStorei(n.UNPACK_SKIP_PIXELS,0),n.pixelStorei(n.UNPACK_SKIP_ROWS,0),n.pixelStorei(n.UNPACK_SKIP_IMAGES,0),u={},f={},Q=null,ie={},h={},l={},d=new WeakMap,p=[],b=null,m=!1,g=null,v=null,C=null,M=null,I=null,E=null,x=null,T=new ut(0,0,0),V=0,U=!1,D=null,H=null,O=null,L=null,X=null,ee.set(0,0,n.canvas.width,n.canvas.height),_e.set(0,0,n.canvas.width,n.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:ce,disable:Oe,bindFramebuffer:Ke,drawBuffers:Ge,useProgram:pt,setBlending:Zt,setMaterial:Gt,setFlipSided:un,setCullFace:Ot,setLineWidth:In,setPolygonOffset:bt,setScissorTest:bn,activeTexture:en,bindTexture:hn,unbindTexture:B,compressedTexImage2D:Re,compressedTexImage3D:Je,texImage2D:S,texImage3D:q,pixelStorei:ae,getParameter:de,updateUBOMapping:te,uniformBlockBinding:re,texStorage2D:qe,texStorage3D:R,texSubImage2D:at,texSubImage3D:we,compressedTexSubImage2D:zt,compressedTexSubImage3D:Ve,scissor:ve,viewport:be,reset:ge}}function pE(n,e,t,i,s,r,o){let a=e.has("WEBGL_multisampled_render_to_texture")?e.get("WEBGL_multisampled_render_to_texture"):null,l=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),c=new Ze,u=new WeakMap,f=new Set,h,d=new WeakMap,p=new Set,b=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,S){return m?new OffscreenCanvas(R,S):qa("canvas")}function v(R,S,q){let de=1,ae=qe(R);if((ae.width>q||ae.height>q)&&(de=q/Math.max(ae.width,ae.height)),de<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ve=Math.floor(de*ae.width),be=Math.floor(de*ae.height);h===void 0&&(h=g(ve,be));let te=S?g(ve,be):h;return te.width=ve,te.height=be,te.getContext("2d").drawImage(R,0,0,ve,be),$e("WebGLRenderer: Texture has been resized from ("+ae.width+"x"+ae.height+") to ("+ve+"x"+be+")."),te}else return"data"in R&&$e("WebGLRenderer: Image in DataTexture is too big ("+ae.width+"x"+ae.height+")."),R;return R}function C(R){return R.generateMipmaps}function M(R){n.generateMipmap(R)}function I(R){return R.isWebGLCubeRenderTarget?n.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?n.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?n.TEXTURE_2D_ARRAY:n.TEXTURE_2D}function E(R,S,q,de,ae,ve=!1){if(R!==null){if(n[R]!==void 0)return n[R];$e("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let be;de&&(be=e.get("EXT_texture_norm16"),be||$e("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let te=S;if(S===n.RED&&(q===n.FLOAT&&(te=n.R32F),q===n.HALF_FLOAT&&(te=n.R16F),q===n.UNSIGNED_BYTE&&(te=n.R8),q===n.UNSIGNED_SHORT&&be&&(te=be.R16_EXT),q===n.SHORT&&be&&(te=be.R16_SNORM_EXT)),S===n.RED_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.R8UI),q===n.UNSIGNED_SHORT&&(te=n.R16UI),q===n.UNSIGNED_INT&&(te=n.R32UI),q===n.BYTE&&(te=n.R8I),q===n.SHORT&&(te=n.R16I),q===n.INT&&(te=n.R32I)),S===n.RG&&(q===n.FLOAT&&(te=n.RG32F),q===n.HALF_FLOAT&&(te=n.RG16F),q===n.UNSIGNED_BYTE&&(te=n.RG8),q===n.UNSIGNED_SHORT&&be&&(te=be.RG16_EXT),q===n.SHORT&&be&&(te=be.RG16_SNORM_EXT)),S===n.RG_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RG8UI),q===n.UNSIGNED_SHORT&&(te=n.RG16UI),q===n.UNSIGNED_INT&&(te=n.RG32UI),q===n.BYTE&&(te=n.RG8I),q===n.SHORT&&(te=n.RG16I),q===n.INT&&(te=n.RG32I)),S===n.RGB_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGB8UI),q===n.UNSIGNED_SHORT&&(te=n.RGB16UI),q===n.UNSIGNED_INT&&(te=n.RGB32UI),q===n.BYTE&&(te=n.RGB8I),q===n.SHORT&&(te=n.RGB16I),q===n.INT&&(te=n.RGB32I)),S===n.RGBA_INTEGER&&(q===n.UNSIGNED_BYTE&&(te=n.RGBA8UI),q===n.UNSIGNED_SHORT&&(te=n.RGBA16UI),q===n.UNSIGNED_INT&&(te=n.RGBA32UI),q===n.BYTE&&(te=n.RGBA8I),q===n.SHORT&&(te=n.RGBA16I),q===n.INT&&(te=n.RGBA32I)),S===n.RGB&&(q===n.UNSIGNED_SHORT&&be&&(te=be.RGB16_EXT),q===n.SHORT&&be&&(te=be.RGB16_SNORM_EXT),q===n.UNSIGNED_INT_5_9_9_9_REV&&(te=n.RGB9_E5),q===n.UNSIGNED_INT_10F_11F_11F_REV&&(te=n.R11F_G11F_B10F)),S===n.RGBA){let re=ve?Xa:vt.getTransfer(ae);q===n.FLOAT&&(te=n.RGBA32F),q===n.HALF_FLOAT&&(te=n.RGBA16F),q===n.UNSIGNED_BYTE&&(te=re===Rt?n.SRGB8_ALPHA8:n.RGBA8),q===n.UNSIGNED_SHORT&&be&&(te=be.RGBA16_EXT),q===n.SHORT&&be&&(te=be.RGBA16_SNORM_EXT),q===n.UNSIGNED_SHORT_4_4_4_4&&(te=n.RGBA4),q===n.UNSIGNED_SHORT_5_5_5_1&&(te=n.RGB5_A1)}return(te===n.R16F||te===n.R32F||te===n.RG16F||te===n.RG32F||te===n.RGBA16F||te===n.RGBA32F)&&e.get("EXT_color_buffer_float"),te}function x(R,S){let q;return R?S===null||S===Qi||S===Jr?q=n.DEPTH24_STENCIL8:S===es?q=n.DEPTH32F_STENCIL8:S===na&&(q=n.DEPTH24_STENCIL8,$e("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):S===null||S===Qi||S===Jr?q=n.DEPTH_COMPONENT24:S===es?q=n.DEPTH_COMPONENT32F:S===na&&(q=n.DEPTH_COMPONENT16),q}function T(R,S){return C(R)===!0||R.isFramebufferTexture&&R.minFilter!==cn&&R.minFilter!==ui?Math.log2(Math.max(S.width,S.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?S.mipmaps.length:1}function V(R){let S=new WeakRef(R);i.get(R).__ref=S,p.add(S),b.register(R,S,S)}function U(R){let S=i.get(R).__ref;S!==void 0&&(p.delete(S),b.unregister(S))}function D(R){O(R.target)}function H(R){L(R.target)}function O(R){R.removeEventListener("dispose",D),U(R),$(R),R.isVideoTexture&&u.delete(R),R.isHTMLTexture&&f.delete(R)}function L(R){R.removeEventListener("dispose",H),U(R),ue(R)}function X(){for(let R of p){let S=R.deref();S!==void 0&&(S.isRenderTarget===!0?L(S):O(S))}p.clear(),f.clear()}function $(R){let S=i.get(R);if(S.__webglInit===void 0)return;let q=R.source,de=d.get(q);if(de){let ae=de[S.__cacheKey];ae.usedTimes--,ae.usedTimes===0&&G(R),Object.keys(de).length===0&&d.delete(q)}i.remove(R)}function G(R){let S=i.get(R);n.deleteTexture(S.__webglTexture);let q=R.source,de=d.get(q);delete de[S.__cacheKey],o.memory.textures--}function ue(R){let S=i.get(R);S.__depthDisposeCallback&&S.__depthDisposeCallback();let q=R.depthTexture;if(q&&q.renderTarget===R&&O(q),R.isWebGLCubeRenderTarget)for(let ae=0;ae<6;ae++){if(Array.isArray(S.__webglFramebuffer[ae]))for(let ve=0;ve<S.__webglFramebuffer[ae].length;ve++)n.deleteFramebuffer(S.__webglFramebuffer[ae][ve]);else n.deleteFramebuffer(S.__webglFramebuffer[ae]);S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer[ae])}else{if(Array.isArray(S.__webglFramebuffer))for(let ae=0;ae<S.__webglFramebuffer.length;ae++)n.deleteFramebuffer(S.__webglFramebuffer[ae]);else n.deleteFramebuffer(S.__webglFramebuffer);if(S.__webglDepthbuffer&&n.deleteRenderbuffer(S.__webglDepthbuffer),S.__webglMultisampledFramebuffer&&n.deleteFramebuffer(S.__webglMultisampledFramebuffer),S.__webglColorRenderbuffer)for(let ae=0;ae<S.__webglColorRenderbuffer.length;ae++)S.__webglColorRenderbuffer[ae]&&n.deleteRenderbuffer(S.__webglColorRenderbuffer[ae]);S.__webglDepthRenderbuffer&&n.deleteRenderbuffer(S.__webglDepthRenderbuffer)}let de=R.textures;for(let ae=0,ve=de.length;ae<ve;ae++){let be=i.get(de[ae]);be.__webglTexture&&(n.deleteTexture(be.__webglTexture),o.memory.textures--),i.remove(de[ae])}i.remove(R)}let Z=0;function Q(){Z=0}function ie(){return Z}function pe(R){Z=R}function fe(){let R=Z;return R>=s.maxTextures&&$e("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),Z+=1,R}function ee(R){let S=[];return S.push(R.wrapS),S.push(R.wrapT),S.push(R.wrapR||0),S.push(R.magFilter),S.push(R.minFilter),S.push(R.anisotropy),S.push(R.internalFormat),S.push(R.format),S.push(R.type),S.push(R.generateMipmaps),S.push(R.mipmapsAutoUpdate),S.push(R.premultiplyAlpha),S.push(R.flipY),S.push(R.unpackAlignment),S.push(R.colorSpace),S.join()}function _e(R,S){let q=i.get(R);if(R.isVideoTexture&&zt(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&q.__version!==R.version){let de=R.image;if(de===null)$e("WebGLRenderer: Texture marked for update but no image data found.");else if(de.complete===!1)$e("WebGLRenderer: Texture marked for update but image is incomplete");else{Gt(q,R,S);return}}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D,q.__webglTexture,n.TEXTURE0+S)}function xe(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Gt(q,R,S);return}else R.isExternalTexture&&(q.__webglTexture=R.sourceTexture?R.sourceTexture:null);t.bindTexture(n.TEXTURE_2D_ARRAY,q.__webglTexture,n.TEXTURE0+S)}function se(R,S){let q=i.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&q.__version!==R.version){Gt(q,R,S);return}t.bindTexture(n.TEXTURE_3D,q.__webglTexture,n.TEXTURE0+S)}function ce(R,S){let q=i.get(R);if(R.version>0&&q.__version!==R.version){un(q,R,S);return}t.bindTexture(n.TEXTURE_CUBE_MAP,q.__webglTexture,n.TEXTURE0+S)}let Oe={[cu]:n.REPEAT,[ps]:n.CLAMP_TO_EDGE,[uu]:n.MIRRORED_REPEAT},Ke={[cn]:n.NEAREST,[nx]:n.NEAREST_MIPMAP_NEAREST,[gl]:n.NEAREST_MIPMAP_LINEAR,[ui]:n.LINEAR,[Bu]:n.LINEAR_MIPMAP_NEAREST,[Vs]:n.LINEAR_MIPMAP_LINEAR},Ge={[ox]:n.NEVER,[ip]:n.ALWAYS,[ax]:n.LESS,[tp]:n.LEQUAL,[lx]:n.EQUAL,[np]:n.GEQUAL,[cx]:n.GREATER,[ux]:n.NOTEQUAL};function pt(R,S){if(S.type===es&&e.has("OES_texture_float_linear")===!1&&(S.magFilter===ui||S.magFilter===Bu||S.magFilter===gl||S.magFilter===Vs||S.minFilter===ui||S.minFilter===Bu||S.minFilter===gl||S.minFilter===Vs)&&$e("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),n.texParameteri(R,n.TEXTURE_WRAP_S,Oe[S.wrapS]),n.texParameteri(R,n.TEXTURE_WRAP_T,Oe[S.wrapT]),(R===n.TEXTURE_3D||R===n.TEXTURE_2D_ARRAY)&&n.texParameteri(R,n.TEXTURE_WRAP_R,Oe[S.wrapR]),n.texParameteri(R,n.TEXTURE_MAG_FILTER,Ke[S.magFilter]),n.texParameteri(R,n.TEXTURE_MIN_FILTER,Ke[S.minFilter]),S.compareFunction&&(n.texParameteri(R,n.TEXTURE_COMPARE_MODE,n.COMPARE_REF_TO_TEXTURE),n.texParameteri(R,n.TEXTURE_COMPARE_FUNC,Ge[S.compareFunction])),e.has("EXT_texture_filter_anisotropic")===!0){if(S.magFilter===cn||S.minFilter!==gl&&S.minFilter!==Vs||S.type===es&&e.has("OES_texture_float_linear")===!1)return;if(S.anisotropy>1||i.get(S).__currentAnisotropy){let q=e.get("EXT_texture_filter_anisotropic");n.texParameterf(R,q.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(S.anisotropy,s.getMaxAnisotropy())),i.get(S).__currentAnisotropy=S.anisotropy}}}function ht(R,S){let q=!1;R.__webglInit===void 0&&(R.__webglInit=!0,S.addEventListener("dispose",D),V(S));let de=S.source,ae=d.get(de);ae===void 0&&(ae={},d.set(de,ae));let ve=ee(S);if(ve!==R.__cacheKey){ae[ve]===void 0&&(ae[ve]={texture:n.createTexture(),usedTimes:0},o.memory.textures++,q=!0),ae[ve].usedTimes++;let be=ae[R.__cacheKey];be!==void 0&&(ae[R.__cacheKey].usedTimes--,be.usedTimes===0&&G(S)),R.__cacheKey=ve,R.__webglTexture=ae[ve].texture}return q}function rt(R,S,q){return Math.floor(Math.floor(R/q)/S)}function Zt(R,S,q,de){let ve=R.updateRanges;if(ve.length===0)t.texSubImage2D(n.TEXTURE_2D,0,0,0,S.width,S.height,q,de,S.data);else{ve.sort((F,oe)=>F.start-oe.start);let be=0;for(let F=1;F<ve.length;F++){let oe=ve[be],ne=ve[F],Ae=oe.start+oe.count,ye=rt(ne.start,S.width,4),Me=rt(oe.start,S.width,4);ne.start<=Ae+1&&ye===Me&&rt(ne.start+ne.count-1,S.width,4)===ye?oe.count=Math.max(oe.count,ne.start+ne.count-oe.start):(++be,ve[be]=ne)}ve.length=be+1;let te=t.getParameter(n.UNPACK_ROW_LENGTH),re=t.getParameter(n.UNPACK_SKIP_PIXELS),ge=t.getParameter(n.UNPACK_SKIP_ROWS);t.pixelStorei(n.UNPACK_ROW_LENGTH,S.width);for(let F=0,oe=ve.length;F<oe;F++){let ne=ve[F],Ae=Math.floor(ne.start/4),ye=Math.ceil(ne.count/4),Me=Ae%S.width,We=Math.floor(Ae/S.width),et=ye,he=1;t.pixelStorei(n.UNPACK_SKIP_PIXELS,Me),t.pixelStorei(n.UNPACK_SKIP_ROWS,We),t.texSubImage2D(n.TEXTURE_2D,0,Me,We,et,he,q,de,S.data)}R.clearUpdateRanges(),t.pixelStorei(n.UNPACK_ROW_LENGTH,te),t.pixelStorei(n.UNPACK_SKIP_PIXELS,re),t.pixelStorei(n.UNPACK_SKIP_ROWS,ge)}}function Gt(R,S,q){let de=n.TEXTURE_2D;(S.isDataArrayTexture||S.isCompressedArrayTexture)&&(de=n.TEXTURE_2D_ARRAY),S.isData3DTexture&&(de=n.TEXTURE_3D);let ae=ht(R,S),ve=S.source;t.bindTexture(de,R.__webglTexture,n.TEXTURE0+q);let be=i.get(ve);if(ve.version!==be.__version||ae===!0){if(t.activeTexture(n.TEXTURE0+q),(typeof ImageBitmap<"u"&&S.image instanceof ImageBitmap)===!1){let he=vt.getPrimaries(vt.workingColorSpace),Be=S.colorSpace===Gs?null:vt.getPrimaries(S.colorSpace),tt=S.colorSpace===Gs||he===Be?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,tt)}t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment);let re=v(S.image,!1,s.maxTextureSize);re=Ve(S,re);let ge=r.convert(S.format,S.colorSpace),F=r.convert(S.type),oe=E(S.internalFormat,ge,F,S.normalized,S.colorSpace,S.isVideoTexture);pt(de,S);let ne,Ae=S.mipmaps,ye=S.isVideoTexture!==!0,Me=be.__version===void 0||ae===!0,We=ve.dataReady,et=T(S,re);if(S.isDepthTexture)oe=x(S.format===Hs,S.type),Me&&(ye?t.texStorage2D(n.TEXTURE_2D,1,oe,re.width,re.height):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ge,F,null));else if(S.isDataTexture)if(Ae.length>0){ye&&Me&&t.texStorage2D(n.TEXTURE_2D,et,oe,Ae[0].width,Ae[0].height);for(let he=0,Be=Ae.length;he<Be;he++)ne=Ae[he],ye?We&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ne.width,ne.height,ge,F,ne.data):t.texImage2D(n.TEXTURE_2D,he,oe,ne.width,ne.height,0,ge,F,ne.data);S.generateMipmaps=!1}else ye?(Me&&t.texStorage2D(n.TEXTURE_2D,et,oe,re.width,re.height),We&&Zt(S,re,ge,F)):t.texImage2D(n.TEXTURE_2D,0,oe,re.width,re.height,0,ge,F,re.data);else if(S.isCompressedTexture)if(S.isCompressedArrayTexture){ye&&Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,oe,Ae[0].width,Ae[0].height,re.depth);for(let he=0,Be=Ae.length;he<Be;he++)if(ne=Ae[he],S.format!==Ii)if(ge!==null)if(ye){if(We)if(S.layerUpdates.size>0){let tt=fp(ne.width,ne.height,S.format,S.type);for(let Ce of S.layerUpdates){let ct=ne.data.subarray(Ce*tt/ne.data.BYTES_PER_ELEMENT,(Ce+1)*tt/ne.data.BYTES_PER_ELEMENT);t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,Ce,ne.width,ne.height,1,ge,ct)}}else t.compressedTexSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,re.depth,ge,ne.data)}else t.compressedTexImage3D(n.TEXTURE_2D_ARRAY,he,oe,ne.width,ne.height,re.depth,0,ne.data,0,0);else $e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else ye?We&&t.texSubImage3D(n.TEXTURE_2D_ARRAY,he,0,0,0,ne.width,ne.height,re.depth,ge,F,ne.data):t.texImage3D(n.TEXTURE_2D_ARRAY,he,oe,ne.width,ne.height,re.depth,0,ge,F,ne.data);S.layerUpdates.size>0&&S.clearLayerUpdates()}else{ye&&Me&&t.texStorage2D(n.TEXTURE_2D,et,oe,Ae[0].width,Ae[0].height);for(let he=0,Be=Ae.length;he<Be;he++)ne=Ae[he],S.format!==Ii?ge!==null?ye?We&&t.compressedTexSubImage2D(n.TEXTURE_2D,he,0,0,ne.width,ne.height,ge,ne.data):t.compressedTexImage2D(n.TEXTURE_2D,he,oe,ne.width,ne.height,0,ne.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):ye?We&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ne.width,ne.height,ge,F,ne.data):t.texImage2D(n.TEXTURE_2D,he,oe,ne.width,ne.height,0,ge,F,ne.data)}else if(S.isDataArrayTexture)if(ye){if(Me&&t.texStorage3D(n.TEXTURE_2D_ARRAY,et,oe,re.width,re.height,re.depth),We)if(S.layerUpdates.size>0){let he=fp(re.width,re.height,S.format,S.type);for(let Be of S.layerUpdates){let tt=re.data.subarray(Be*he/re.data.BYTES_PER_ELEMENT,(Be+1)*he/re.data.BYTES_PER_ELEMENT);t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,Be,re.width,re.height,1,ge,F,tt)}S.clearLayerUpdates()}else t.texSubImage3D(n.TEXTURE_2D_ARRAY,0,0,0,0,re.width,re.height,re.depth,ge,F,re.data)}else t.texImage3D(n.TEXTURE_2D_ARRAY,0,oe,re.width,re.height,re.depth,0,ge,F,re.data);else if(S.isData3DTexture)ye?(Me&&t.texStorage3D(n.TEXTURE_3D,et,oe,re.width,re.height,re.depth),We&&t.texSubImage3D(n.TEXTURE_3D,0,0,0,0,re.width,re.height,re.depth,ge,F,re.data)):t.texImage3D(n.TEXTURE_3D,0,oe,re.width,re.height,re.depth,0,ge,F,re.data);else if(S.isFramebufferTexture){if(Me)if(ye)t.texStorage2D(n.TEXTURE_2D,et,oe,re.width,re.height);else{let he=re.width,Be=re.height;for(let tt=0;tt<et;tt++)t.texImage2D(n.TEXTURE_2D,tt,oe,he,Be,0,ge,F,null),he>>=1,Be>>=1}}else if(S.isHTMLTexture){if("texElementImage2D"in n){let he=n.canvas;if(he.hasAttribute("layoutsubtree")||he.setAttribute("layoutsubtree","true"),re.parentNode!==he){he.appendChild(re),f.add(S),he.onpaint=Be=>{let tt=Be.changedElements;for(let Ce of f)tt.includes(Ce.image)&&(Ce.needsUpdate=!0)},he.requestPaint();return}if(n.texElementImage2D.length===3)n.texElementImage2D(n.TEXTURE_2D,n.RGBA8,re);else{let tt=n.RGBA,Ce=n.RGBA,ct=n.UNSIGNED_BYTE;n.texElementImage2D(n.TEXTURE_2D,0,tt,Ce,ct,re)}n.texParameteri(n.TEXTURE_2D,n.TEXTURE_MIN_FILTER,n.LINEAR),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_S,n.CLAMP_TO_EDGE),n.texParameteri(n.TEXTURE_2D,n.TEXTURE_WRAP_T,n.CLAMP_TO_EDGE)}}else if(Ae.length>0){if(ye&&Me){let he=qe(Ae[0]);t.texStorage2D(n.TEXTURE_2D,et,oe,he.width,he.height)}for(let he=0,Be=Ae.length;he<Be;he++)ne=Ae[he],ye?We&&t.texSubImage2D(n.TEXTURE_2D,he,0,0,ge,F,ne):t.texImage2D(n.TEXTURE_2D,he,oe,ge,F,ne);S.generateMipmaps=!1}else if(ye){if(Me){let he=qe(re);t.texStorage2D(n.TEXTURE_2D,et,oe,he.width,he.height)}We&&t.texSubImage2D(n.TEXTURE_2D,0,0,0,ge,F,re)}else t.texImage2D(n.TEXTURE_2D,0,oe,ge,F,re);C(S)&&S.mipmapsAutoUpdate===!0&&M(de),be.__version=ve.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function un(R,S,q){if(S.image.length!==6)return;let de=ht(R,S),ae=S.source;t.bindTexture(n.TEXTURE_CUBE_MAP,R.__webglTexture,n.TEXTURE0+q);let ve=i.get(ae);if(ae.version!==ve.__version||de===!0){t.activeTexture(n.TEXTURE0+q);let be=vt.getPrimaries(vt.workingColorSpace),te=S.colorSpace===Gs?null:vt.getPrimaries(S.colorSpace),re=S.colorSpace===Gs||be===te?n.NONE:n.BROWSER_DEFAULT_WEBGL;t.pixelStorei(n.UNPACK_FLIP_Y_WEBGL,S.flipY),t.pixelStorei(n.UNPACK_PREMULTIPLY_ALPHA_WEBGL,S.premultiplyAlpha),t.pixelStorei(n.UNPACK_ALIGNMENT,S.unpackAlignment),t.pixelStorei(n.UNPACK_COLORSPACE_CONVERSION_WEBGL,re);let ge=S.isCompressedTexture||S.image[0].isCompressedTexture,F=S.image[0]&&S.image[0].isDataTexture,oe=[];for(let Ce=0;Ce<6;Ce++)!ge&&!F?oe[Ce]=v(S.image[Ce],!0,s.maxCubemapSize):oe[Ce]=F?S.image[Ce].image:S.image[Ce],oe[Ce]=Ve(S,oe[Ce]);let ne=oe[0],Ae=r.convert(S.format,S.colorSpace),ye=r.convert(S.type),Me=E(S.internalFormat,Ae,ye,S.normalized,S.colorSpace),We=S.isVideoTexture!==!0,et=ve.__version===void 0||de===!0,he=ae.dataReady,Be=T(S,ne);pt(n.TEXTURE_CUBE_MAP,S);let tt;if(S.isDepthTexture){if(Me=x(S.format===Hs,S.type),et)if(We)t.texStorage2D(n.TEXTURE_CUBE_MAP,1,Me,ne.width,ne.height);else for(let Ce=0;Ce<6;Ce++)t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,ne.width,ne.height,0,Ae,ye,null)}else if(ge){We&&et&&t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,ne.width,ne.height);for(let Ce=0;Ce<6;Ce++){tt=oe[Ce].mipmaps;for(let ct=0;ct<tt.length;ct++){let Wt=tt[ct];S.format!==Ii?Ae!==null?We?he&&t.compressedTexSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,0,0,Wt.width,Wt.height,Ae,Wt.data):t.compressedTexImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,Me,Wt.width,Wt.height,0,Wt.data):$e("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):We?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,0,0,Wt.width,Wt.height,Ae,ye,Wt.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct,Me,Wt.width,Wt.height,0,Ae,ye,Wt.data)}}}else{if(tt=S.mipmaps,We&&et){tt.length>0&&Be++;let Ce=qe(oe[0]);t.texStorage2D(n.TEXTURE_CUBE_MAP,Be,Me,Ce.width,Ce.height)}for(let Ce=0;Ce<6;Ce++)if(F){We?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,oe[Ce].width,oe[Ce].height,Ae,ye,oe[Ce].data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,oe[Ce].width,oe[Ce].height,0,Ae,ye,oe[Ce].data);for(let ct=0;ct<tt.length;ct++){let ti=tt[ct].image[Ce].image;We?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,0,0,ti.width,ti.height,Ae,ye,ti.data):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,Me,ti.width,ti.height,0,Ae,ye,ti.data)}}else{We?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,0,0,Ae,ye,oe[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,0,Me,Ae,ye,oe[Ce]);for(let ct=0;ct<tt.length;ct++){let Wt=tt[ct];We?he&&t.texSubImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,0,0,Ae,ye,Wt.image[Ce]):t.texImage2D(n.TEXTURE_CUBE_MAP_POSITIVE_X+Ce,ct+1,Me,Ae,ye,Wt.image[Ce])}}}C(S)&&S.mipmapsAutoUpdate===!0&&M(n.TEXTURE_CUBE_MAP),ve.__version=ae.version,S.onUpdate&&S.onUpdate(S)}R.__version=S.version}function Ot(R,S,q,de,ae,ve){let be=r.convert(q.format,q.colorSpace),te=r.convert(q.type),re=E(q.internalFormat,be,te,q.normalized,q.colorSpace),ge=i.get(S),F=i.get(q);if(F.__renderTarget=S,!ge.__hasExternalTextures){let oe=Math.max(1,S.width>>ve),ne=Math.max(1,S.height>>ve);ae===n.TEXTURE_3D||ae===n.TEXTURE_2D_ARRAY?t.texImage3D(ae,ve,re,oe,ne,S.depth,0,be,te,null):t.texImage2D(ae,ve,re,oe,ne,0,be,te,null)}t.bindFramebuffer(n.FRAMEBUFFER,R),we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,de,ae,F.__webglTexture,0,at(S)):(ae===n.TEXTURE_2D||ae>=n.TEXTURE_CUBE_MAP_POSITIVE_X&&ae<=n.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&n.framebufferTexture2D(n.FRAMEBUFFER,de,ae,F.__webglTexture,ve),t.bindFramebuffer(n.FRAMEBUFFER,null)}function In(R,S,q){if(n.bindRenderbuffer(n.RENDERBUFFER,R),S.depthBuffer){let de=S.depthTexture,ae=de&&de.isDepthTexture?de.type:null,ve=x(S.stencilBuffer,ae),be=S.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(S),ve,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(S),ve,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,ve,S.width,S.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,be,n.RENDERBUFFER,R)}else{let de=S.textures;for(let ae=0;ae<de.length;ae++){let ve=de[ae],be=r.convert(ve.format,ve.colorSpace),te=r.convert(ve.type),re=E(ve.internalFormat,be,te,ve.normalized,ve.colorSpace);we(S)?a.renderbufferStorageMultisampleEXT(n.RENDERBUFFER,at(S),re,S.width,S.height):q?n.renderbufferStorageMultisample(n.RENDERBUFFER,at(S),re,S.width,S.height):n.renderbufferStorage(n.RENDERBUFFER,re,S.width,S.height)}}n.bindRenderbuffer(n.RENDERBUFFER,null)}function bt(R,S,q){let de=S.isWebGLCubeRenderTarget===!0;if(t.bindFramebuffer(n.FRAMEBUFFER,R),!(S.depthTexture&&S.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let ae=i.get(S.depthTexture);ae.__renderTarget=S;let ve=de?S.depthTexture.image[0]:S.depthTexture.image;(!ae.__webglTexture||ve.width!==S.width||ve.height!==S.height)&&(ve.width=S.width,ve.height=S.height,S.depthTexture.needsUpdate=!0),de?ce(S.depthTexture,0):_e(S.depthTexture,0);let be=ae.__webglTexture,te=at(S),re=de?n.TEXTURE_CUBE_MAP_POSITIVE_X+q:n.TEXTURE_2D,ge=S.depthTexture.format===Hs?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;if(S.depthTexture.format===Bs)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,be,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,be,0);else if(S.depthTexture.format===Hs)we(S)?a.framebufferTexture2DMultisampleEXT(n.FRAMEBUFFER,ge,re,be,0,te):n.framebufferTexture2D(n.FRAMEBUFFER,ge,re,be,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function bn(R){let S=i.get(R),q=R.isWebGLCubeRenderTarget===!0;if(S.__boundDepthTexture!==R.depthTexture){let de=R.depthTexture;if(S.__depthDisposeCallback&&S.__depthDisposeCallback(),de){let ae=()=>{delete S.__boundDepthTexture,delete S.__depthDisposeCallback,de.removeEventListener("dispose",ae)};de.addEventListener("dispose",ae),S.__depthDisposeCallback=ae}S.__boundDepthTexture=de}if(R.depthTexture&&!S.__autoAllocateDepthBuffer)if(q)for(let de=0;de<6;de++)bt(S.__webglFramebuffer[de],R,de);else R.texture.mipmaps.length>0?bt(S.__webglFramebuffer[0],R,0):bt(S.__webglFramebuffer,R,0);else if(q){S.__webglDepthbuffer=[];for(let de=0;de<6;de++)if(t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[de]),S.__webglDepthbuffer[de]===void 0)S.__webglDepthbuffer[de]=n.createRenderbuffer(),In(S.__webglDepthbuffer[de],R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer[de];n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}}else if(R.texture.mipmaps.length>0?t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer[0]):t.bindFramebuffer(n.FRAMEBUFFER,S.__webglFramebuffer),S.__webglDepthbuffer===void 0)S.__webglDepthbuffer=n.createRenderbuffer(),In(S.__webglDepthbuffer,R,!1);else{let ae=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,ve=S.__webglDepthbuffer;n.bindRenderbuffer(n.RENDERBUFFER,ve),n.framebufferRenderbuffer(n.FRAMEBUFFER,ae,n.RENDERBUFFER,ve)}t.bindFramebuffer(n.FRAMEBUFFER,null)}function en(R,S,q){let de=i.get(R);S!==void 0&&Ot(de.__webglFramebuffer,R,R.texture,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,0),q!==void 0&&bn(R)}function hn(R){let S=R.texture,q=i.get(R),de=i.get(S);R.addEventListener("dispose",H),V(R);let ae=R.textures,ve=R.isWebGLCubeRenderTarget===!0,be=ae.length>1;if(be||(de.__webglTexture===void 0&&(de.__webglTexture=n.createTexture()),de.__version=S.version,o.memory.textures++),ve){q.__webglFramebuffer=[];for(let te=0;te<6;te++)if(S.mipmaps.length>0){q.__webglFramebuffer[te]=[];for(let re=0;re<S.mipmaps.length;re++)q.__webglFramebuffer[te][re]=n.createFramebuffer()}else q.__webglFramebuffer[te]=n.createFramebuffer()}else{if(S.mipmaps.length>0){q.__webglFramebuffer=[];for(let te=0;te<S.mipmaps.length;te++)q.__webglFramebuffer[te]=n.createFramebuffer()}else q.__webglFramebuffer=n.createFramebuffer();if(be)for(let te=0,re=ae.length;te<re;te++){let ge=i.get(ae[te]);ge.__webglTexture===void 0&&(ge.__webglTexture=n.createTexture(),o.memory.textures++)}if(R.samples>0&&we(R)===!1){q.__webglMultisampledFramebuffer=n.createFramebuffer(),q.__webglColorRenderbuffer=[],t.bindFramebuffer(n.FRAMEBUFFER,q.__webglMultisampledFramebuffer);for(let te=0;te<ae.length;te++){let re=ae[te];q.__webglColorRenderbuffer[te]=n.createRenderbuffer(),n.bindRenderbuffer(n.RENDERBUFFER,q.__webglColorRenderbuffer[te]);let ge=r.convert(re.format,re.colorSpace),F=r.convert(re.type),oe=E(re.internalFormat,ge,F,re.normalized,re.colorSpace,R.isXRRenderTarget===!0),ne=at(R);n.renderbufferStorageMultisample(n.RENDERBUFFER,ne,oe,R.width,R.height),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+te,n.RENDERBUFFER,q.__webglColorRenderbuffer[te])}n.bindRenderbuffer(n.RENDERBUFFER,null),R.depthBuffer&&(q.__webglDepthRenderbuffer=n.createRenderbuffer(),In(q.__webglDepthRenderbuffer,R,!0)),t.bindFramebuffer(n.FRAMEBUFFER,null)}}if(ve){t.bindTexture(n.TEXTURE_CUBE_MAP,de.__webglTexture),pt(n.TEXTURE_CUBE_MAP,S);for(let te=0;te<6;te++)if(S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ot(q.__webglFramebuffer[te][re],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,re);else Ot(q.__webglFramebuffer[te],R,S,n.COLOR_ATTACHMENT0,n.TEXTURE_CUBE_MAP_POSITIVE_X+te,0);C(S)?M(n.TEXTURE_CUBE_MAP):S.mipmaps.length>0&&n.texParameteri(n.TEXTURE_CUBE_MAP,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}else if(be){for(let te=0,re=ae.length;te<re;te++){let ge=ae[te],F=i.get(ge),oe=n.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(oe=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(oe,F.__webglTexture),pt(oe,ge),Ot(q.__webglFramebuffer,R,ge,n.COLOR_ATTACHMENT0+te,oe,0),C(ge)&&M(oe)}t.unbindTexture()}else{let te=n.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(te=R.isWebGL3DRenderTarget?n.TEXTURE_3D:n.TEXTURE_2D_ARRAY),t.bindTexture(te,de.__webglTexture),pt(te,S),S.mipmaps.length>0)for(let re=0;re<S.mipmaps.length;re++)Ot(q.__webglFramebuffer[re],R,S,n.COLOR_ATTACHMENT0,te,re);else Ot(q.__webglFramebuffer,R,S,n.COLOR_ATTACHMENT0,te,0);C(S)?M(te):S.mipmaps.length>0&&n.texParameteri(te,n.TEXTURE_MAX_LEVEL,S.mipmaps.length-1),t.unbindTexture()}R.depthBuffer&&bn(R)}function B(R){let S=R.textures;for(let q=0,de=S.length;q<de;q++){let ae=S[q];if(C(ae)&&ae.mipmapsAutoUpdate===!0){let ve=I(R),be=i.get(ae).__webglTexture;t.bindTexture(ve,be),M(ve),t.unbindTexture()}}}let Re=[];function Je(R){if(R.samples>0){if(we(R)===!1){let S=R.textures,q=R.width,de=R.height,ae=n.COLOR_BUFFER_BIT,ve=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT,be=i.get(R),te=S.length>1;if(te)for(let ge=0;ge<S.length;ge++)t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,null),t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,null,0);t.bindFramebuffer(n.READ_FRAMEBUFFER,be.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer[0]):t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglFramebuffer);for(let ge=0;ge<S.length;ge++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(ae|=n.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(ae|=n.STENCIL_BUFFER_BIT)),te){n.framebufferRenderbuffer(n.READ_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let F=i.get(S[ge]).__webglTexture;n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0,n.TEXTURE_2D,F,0)}n.blitFramebuffer(0,0,q,de,0,0,q,de,ae,n.NEAREST),l===!0&&(Re.length=0,Re.push(n.COLOR_ATTACHMENT0+ge),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&Re.push(ve),n.invalidateFramebuffer(n.READ_FRAMEBUFFER,Re))}if(t.bindFramebuffer(n.READ_FRAMEBUFFER,null),t.bindFramebuffer(n.DRAW_FRAMEBUFFER,null),te)for(let ge=0;ge<S.length;ge++){t.bindFramebuffer(n.FRAMEBUFFER,be.__webglMultisampledFramebuffer),n.framebufferRenderbuffer(n.FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.RENDERBUFFER,be.__webglColorRenderbuffer[ge]);let F=i.get(S[ge]).__webglTexture;t.bindFramebuffer(n.FRAMEBUFFER,be.__webglFramebuffer),n.framebufferTexture2D(n.DRAW_FRAMEBUFFER,n.COLOR_ATTACHMENT0+ge,n.TEXTURE_2D,F,0)}t.bindFramebuffer(n.DRAW_FRAMEBUFFER,be.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&l){let S=R.stencilBuffer?n.DEPTH_STENCIL_ATTACHMENT:n.DEPTH_ATTACHMENT;n.invalidateFramebuffer(n.DRAW_FRAMEBUFFER,[S])}}}function at(R){return Math.min(s.maxSamples,R.samples)}function we(R){let S=i.get(R);return R.samples>0&&e.has("WEBGL_multisampled_render_to_texture")===!0&&S.__useRenderToTexture!==!1}function zt(R){let S=o.render.frame;u.get(R)!==S&&(u.set(R,S),R.update())}function Ve(R,S){let q=R.colorSpace,de=R.format,ae=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||q!==Wa&&q!==Gs&&(vt.getTransfer(q)===Rt?(de!==Ii||ae!==_i)&&$e("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):it("WebGLTextures: Unsupported texture color space:",q)),S}function qe(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(c.width=R.naturalWidth||R.width,c.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(c.width=R.displayWidth,c.height=R.displayHeight):(c.width=R.width,c.height=R.height),c}this.allocateTextureUnit=fe,this.resetTextureUnits=Q,this.getTextureUnits=ie,this.setTextureUnits=pe,this.setTexture2D=_e,this.setTexture2DArray=xe,this.setTexture3D=se,this.setTextureCube=ce,this.rebindTextures=en,this.setupRenderTarget=hn,this.updateRenderTargetMipmap=B,this.updateMultisampleRenderTarget=Je,this.setupDepthRenderbuffer=bn,this.setupFrameBufferTexture=Ot,this.useMultisampledRTT=we,this.dispose=X}function mE(n,e){function t(i,s=Gs){let r,o=vt.getTransfer(s);if(i===_i)return n.UNSIGNED_BYTE;if(i===zu)return n.UNSIGNED_SHORT_4_4_4_4;if(i===Vu)return n.UNSIGNED_SHORT_5_5_5_1;if(i===Zf)return n.UNSIGNED_INT_5_9_9_9_REV;if(i===Kf)return n.UNSIGNED_INT_10F_11F_11F_REV;if(i===$f)return n.BYTE;if(i===Jf)return n.SHORT;if(i===na)return n.UNSIGNED_SHORT;if(i===ku)return n.INT;if(i===Qi)return n.UNSIGNED_INT;if(i===es)return n.FLOAT;if(i===ts)return n.HALF_FLOAT;if(i===jf)return n.ALPHA;if(i===Qf)return n.RGB;if(i===Ii)return n.RGBA;if(i===Bs)return n.DEPTH_COMPONENT;if(i===Hs)return n.DEPTH_STENCIL;if(i===ep)return n.RED;if(i===Hu)return n.RED_INTEGER;if(i===wr)return n.RG;if(i===Gu)return n.RG_INTEGER;if(i===Wu)return n.RGBA_INTEGER;if(i===_l||i===xl||i===yl||i===vl)if(o===Rt)if(r=e.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(i===_l)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(i===yl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(i===vl)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=e.get("WEBGL_compressed_texture_s3tc"),r!==null){if(i===_l)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(i===xl)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(i===yl)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(i===vl)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(i===Xu||i===qu||i===Yu||i===$u)if(r=e.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(i===Xu)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(i===qu)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(i===Yu)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(i===$u)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(i===Ju||i===Zu||i===Ku||i===ju||i===Qu||i===bl||i===eh)if(r=e.get("WEBGL_compressed_texture_etc"),r!==null){if(i===Ju||i===Zu)return o===Rt?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(i===Ku)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(i===ju)return r.COMPRESSED_R11_EAC;if(i===Qu)return r.COMPRESSED_SIGNED_R11_EAC;if(i===bl)return r.COMPRESSED_RG11_EAC;if(i===eh)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(i===th||i===nh||i===ih||i===sh||i===rh||i===oh||i===ah||i===lh||i===ch||i===uh||i===hh||i===dh||i===fh||i===ph)if(r=e.get("WEBGL_compressed_texture_astc"),r!==null){if(i===th)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(i===nh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(i===ih)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(i===sh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(i===rh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(i===oh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(i===ah)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(i===lh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(i===ch)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(i===uh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(i===hh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(i===dh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(i===fh)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(i===ph)return o===Rt?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(i===mh||i===gh||i===_h)if(r=e.get("EXT_texture_compression_bptc"),r!==null){if(i===mh)return o===Rt?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(i===gh)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(i===_h)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(i===xh||i===yh||i===Sl||i===vh)if(r=e.get("EXT_texture_compression_rgtc"),r!==null){if(i===xh)return r.COMPRESSED_RED_RGTC1_EXT;if(i===yh)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(i===Sl)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(i===vh)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return i===Jr?n.UNSIGNED_INT_24_8:n[i]!==void 0?n[i]:null}return{convert:t}}var gE=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,_E=`
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

}`,Sp=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(e,t){if(this.texture===null){let i=new nl(e.texture);(e.depthNear!==t.depthNear||e.depthFar!==t.depthFar)&&(this.depthNear=e.depthNear,this.depthFar=e.depthFar),this.texture=i}}getMesh(e){if(this.texture!==null&&this.mesh===null){let t=e.cameras[0].viewport,i=new ki({vertexShader:gE,fragmentShader:_E,uniforms:{depthColor:{value:this.texture},depthWidth:{value:t.z},depthHeight:{value:t.w}}});this.mesh=new Hn(new il(20,20),i)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Mp=class extends Ki{constructor(e,t){super();let i=this,s=null,r=1,o=null,a="local-floor",l=1,c=null,u=null,f=null,h=null,d=null,p=null,b=typeof XRWebGLBinding<"u",m=new Sp,g={},v=t.getContextAttributes(),C=null,M=null,I=[],E=[],x=new Ze,T=null,V=null,U=new ci;U.viewport=new Pt;let D=new ci;D.viewport=new Pt;let H=[U,D],O=new Nu,L=null,X=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(ee){let _e=I[ee];return _e===void 0&&(_e=new qo,I[ee]=_e),_e.getTargetRaySpace()},this.getControllerGrip=function(ee){let _e=I[ee];return _e===void 0&&(_e=new qo,I[ee]=_e),_e.getGripSpace()},this.getHand=function(ee){let _e=I[ee];return _e===void 0&&(_e=new qo,I[ee]=_e),_e.getHandSpace()};function $(ee){let _e=E.indexOf(ee.inputSource);if(_e===-1)return;let xe=I[_e];xe!==void 0&&(xe.update(ee.inputSource,ee.frame,c||o),xe.dispatchEvent({type:ee.type,data:ee.inputSource}))}function G(){s.removeEventListener("select",$),s.removeEventListener("selectstart",$),s.removeEventListener("selectend",$),s.removeEventListener("squeeze",$),s.removeEventListener("squeezestart",$),s.removeEventListener("squeezeend",$),s.removeEventListener("end",G),s.removeEventListener("inputsourceschange",ue);for(let ee=0;ee<I.length;ee++){let _e=E[ee];_e!==null&&(E[ee]=null,I[ee].disconnect(_e))}L=null,X=null,m.reset();for(let ee in g)delete g[ee];if(e.setRenderTarget(C),d=null,h=null,f=null,s=null,M=null,fe.stop(),i.isPresenting=!1,e.setPixelRatio(T),e.setSize(x.width,x.height,!1),V!==null){let ee=V.camera;ee.fov=V.fov,ee.zoom=V.zoom,ee.updateProjectionMatrix(),V=null}i.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(ee){r=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(ee){a=ee,i.isPresenting===!0&&$e("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return c||o},this.setReferenceSpace=function(ee){c=ee},this.getBaseLayer=function(){return h!==null?h:d},this.getBinding=function(){return f===null&&b&&(f=new XRWebGLBinding(s,t)),f},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(ee){if(s=ee,s!==null){if(C=e.getRenderTarget(),s.addEventListener("select",$),s.addEventListener("selectstart",$),s.addEventListener("selectend",$),s.addEventListener("squeeze",$),s.addEventListener("squeezestart",$),s.addEventListener("squeezeend",$),s.addEventListener("end",G),s.addEventListener("inputsourceschange",ue),v.xrCompatible!==!0&&await t.makeXRCompatible(),T=e.getPixelRatio(),e.getSize(x),b&&"createProjectionLayer"in XRWebGLBinding.prototype){let xe=null,se=null,ce=null;v.depth&&(ce=v.stencil?t.DEPTH24_STENCIL8:t.DEPTH_COMPONENT24,xe=v.stencil?Hs:Bs,se=v.stencil?Jr:Qi);let Oe={colorFormat:t.RGBA8,depthFormat:ce,scaleFactor:r};f=this.getBinding(),h=f.createProjectionLayer(Oe),s.updateRenderState({layers:[h]}),e.setPixelRatio(1),e.setSize(h.textureWidth,h.textureHeight,!1),M=new Ri(h.textureWidth,h.textureHeight,{format:Ii,type:_i,depthTexture:new zs(h.textureWidth,h.textureHeight,se,void 0,void 0,void 0,void 0,void 0,void 0,xe),stencilBuffer:v.stencil,colorSpace:e.outputColorSpace,samples:v.antialias?4:0,resolveDepthBuffer:h.ignoreDepthValues===!1,resolveStencilBuffer:h.ignoreDepthValues===!1,storeMultisampledDepthBuffer:h.ignoreDepthValues===!1,storeMultisampledStencilBuffer:h.ignoreDepthValues===!1})}else{let xe={antialias:v.antialias,alpha:!0,depth:v.depth,stencil:v.stencil,framebufferScaleFactor:r};d=new XRWebGLLayer(s,t,xe),s.updateRenderState({baseLayer:d}),e.setPixelRatio(1),e.setSize(d.framebufferWidth,d.framebufferHeight,!1),M=new Ri(d.framebufferWidth,d.framebufferHeight,{format:Ii,type:_i,colorSpace:e.outputColorSpace,stencilBuffer:v.stencil,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}M.isXRRenderTarget=!0,this.setFoveation(l),c=null,o=await s.requestReferenceSpace(a),fe.setContext(s),fe.start(),i.isPresenting=!0,i.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function ue(ee){for(let _e=0;_e<ee.removed.length;_e++){let xe=ee.removed[_e],se=E.indexOf(xe);se>=0&&(E[se]=null,I[se].disconnect(xe))}for(let _e=0;_e<ee.added.length;_e++){let xe=ee.added[_e],se=E.indexOf(xe);if(se===-1){for(let Oe=0;Oe<I.length;Oe++)if(Oe>=E.length){E.push(xe),se=Oe;break}else if(E[Oe]===null){E[Oe]=xe,se=Oe;break}if(se===-1)break}let ce=I[se];ce&&ce.connect(xe)}}function Z(ee,_e){_e===null?ee.matrixWorld.copy(ee.matrix):ee.matrixWorld.multiplyMatrices(_e.matrixWorld,ee.matrix),ee.matrixWorldInverse.copy(ee.matrixWorld).invert()}this.updateCamera=function(ee){if(s===null)return;let _e=ee.near,xe=ee.far;m.texture!==null&&(m.depthNear>0&&(_e=m.depthNear),m.depthFar>0&&(xe=m.depthFar)),O.near=D.near=U.near=_e,O.far=D.far=U.far=xe,(L!==O.near||X!==O.far)&&(s.updateRenderState({depthNear:O.near,depthFar:O.far}),L=O.near,X=O.far),O.layers.mask=ee.layers.mask|6,U.layers.mask=O.layers.mask&-5,D.layers.mask=O.layers.mask&-3;let se=ee.parent,ce=O.cameras;Z(O,se);for(let Oe=0;Oe<ce.length;Oe++)Z(ce[Oe],se);O.projectionMatrix.copy(U.projectionMatrix),O.projectionMatrixInverse.copy(U.projectionMatrixInverse),V===null&&ee.isPerspectiveCamera&&(V={camera:ee,fov:ee.fov,zoom:ee.zoom}),Q(ee,O,se)};function Q(ee,_e,xe){xe===null?ee.matrix.copy(_e.matrixWorld):(ee.matrix.copy(xe.matrixWorld),ee.matrix.invert(),ee.matrix.multiply(_e.matrixWorld)),ee.matrix.decompose(ee.position,ee.quaternion,ee.scale),ee.updateMatrixWorld(!0),ee.projectionMatrix.copy(_e.projectionMatrix),ee.projectionMatrixInverse.copy(_e.projectionMatrixInverse),ee.isPerspectiveCamera&&(ee.fov=Wo*2*Math.atan(1/ee.projectionMatrix.elements[5]),ee.zoom=1)}this.getCamera=function(){return O},this.getFoveation=function(){if(!(h===null&&d===null))return l},this.setFoveation=function(ee){l=ee,h!==null&&(h.fixedFoveation=ee),d!==null&&d.fixedFoveation!==void 0&&(d.fixedFoveation=ee)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(O)},this.getCameraTexture=function(ee){return g[ee]};let ie=null;function pe(ee,_e){if(u=_e.getViewerPose(c||o),p=_e,u!==null){let xe=u.views;d!==null&&(e.setRenderTargetFramebuffer(M,d.framebuffer),e.setRenderTarget(M));let se=!1;xe.length!==O.cameras.length&&(O.cameras.length=0,se=!0);for(let Ge=0;Ge<xe.length;Ge++){let pt=xe[Ge],ht=null;if(d!==null)ht=d.getViewport(pt);else{let Zt=f.getViewSubImage(h,pt);ht=Zt.viewport,Ge===0&&(e.setRenderTargetTextures(M,Zt.colorTexture,Zt.depthStencilTexture),e.setRenderTarget(M))}let rt=H[Ge];rt===void 0&&(rt=new ci,rt.layers.enable(Ge),rt.viewport=new Pt,H[Ge]=rt),rt.matrix.fromArray(pt.transform.matrix),rt.matrix.decompose(rt.position,rt.quaternion,rt.scale),rt.projectionMatrix.fromArray(pt.projectionMatrix),rt.projectionMatrixInverse.copy(rt.projectionMatrix).invert(),rt.viewport.set(ht.x,ht.y,ht.width,ht.height),Ge===0&&(O.matrix.copy(rt.matrix),O.matrix.decompose(O.position,O.quaternion,O.scale)),se===!0&&O.cameras.push(rt)}let ce=s.enabledFeatures;if(ce&&ce.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&b){f=i.getBinding();let Ge=f.getDepthInformation(xe[0]);Ge&&Ge.isValid&&Ge.texture&&m.init(Ge,s.renderState)}if(ce&&ce.includes("camera-access")&&b){e.state.unbindTexture(),f=i.getBinding();for(let Ge=0;Ge<xe.length;Ge++){let pt=xe[Ge].camera;if(pt){let ht=g[pt];ht||(ht=new nl,g[pt]=ht);let rt=f.getCameraImage(pt);ht.sourceTexture=rt}}}}for(let xe=0;xe<I.length;xe++){let se=E[xe],ce=I[xe];se!==null&&ce!==void 0&&ce.update(se,_e,c||o)}ie&&ie(ee,_e),_e.detectedPlanes&&i.dispatchEvent({type:"planesdetected",data:_e}),p=null}let fe=new kx;fe.setAnimationLoop(pe),this.setAnimationLoop=function(ee){ie=ee},this.dispose=function(){}}},xE=new St,Jx=new st;Jx.set(-1,0,0,0,1,0,0,0,1);function yE(n,e){function t(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function i(m,g){g.color.getRGB(m.fogColor.value,up(n)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,v,C,M){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),f(m,g)):g.isMeshPhongMaterial?(r(m,g),u(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),h(m,g),g.isMeshPhysicalMaterial&&d(m,g,M)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),b(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?l(m,g,v,C):g.isSpriteMaterial?c(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,t(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===hi&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,t(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===hi&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,t(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,t(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,t(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let v=e.get(g),C=v.envMap,M=v.envMapRotation;C&&(m.envMap.value=C,m.envMapRotation.value.setFromMatrix4(xE.makeRotationFromEuler(M)).transpose(),C.isCubeTexture&&C.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Jx),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,t(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,t(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function l(m,g,v,C){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*v,m.scale.value=C*.5,g.map&&(m.map.value=g.map,t(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function c(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,t(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,t(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function u(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function f(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function h(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,t(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,t(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function d(m,g,v){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,t(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,t(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,t(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,t(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,t(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,t(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===hi&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,t(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,t(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=v.texture,m.transmissionSamplerSize.value.set(v.width,v.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,t(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,t(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,t(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,t(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,t(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function b(m,g){let v=e.get(g).light;m.referencePosition.value.setFromMatrixPosition(v.matrixWorld),m.nearDistance.value=v.shadow.camera.near,m.farDistance.value=v.shadow.camera.far}return{refreshFogUniforms:i,refreshMaterialUniforms:s}}function vE(n,e,t,i){let s={},r={};function o(v,C){let M=C.program;i.uniformBlockBinding(v,M,s[v.id])}function a(v,C){let M=s[v.id];M===void 0&&(p(v),M=l(v),s[v.id]=M,v.addEventListener("dispose",m));let I=C.program;i.updateUBOMapping(v,I);let E=e.render.frame;r[v.id]!==E&&(c(v),r[v.id]=E)}function l(v){let C=n.createBuffer(),M=v.__size,I=v.usage;return n.bindBuffer(n.UNIFORM_BUFFER,C),n.bufferData(n.UNIFORM_BUFFER,M,I),n.bindBuffer(n.UNIFORM_BUFFER,null),C}function c(v){let C=s[v.id],M=v.uniforms,I=v.__cache;n.bindBuffer(n.UNIFORM_BUFFER,C);for(let E=0,x=M.length;E<x;E++){let T=M[E];if(Array.isArray(T))for(let V=0,U=T.length;V<U;V++)u(T[V],E,V,I);else u(T,E,0,I)}n.bindBuffer(n.UNIFORM_BUFFER,null)}function u(v,C,M,I){if(h(v,C,M,I)===!0){let E=v.__offset,x=v.value;if(Array.isArray(x)){let T=0;for(let V=0;V<x.length;V++){let U=x[V],D=b(U,!0);f(U,v.__data,T),T+=D.storage/Float32Array.BYTES_PER_ELEMENT}}else f(x,v.__data,0);n.bufferSubData(n.UNIFORM_BUFFER,E,v.__data)}}function f(v,C,M){typeof v=="number"||typeof v=="boolean"?C[M]=v:v.isMatrix3?(C[M]=v.elements[0],C[M+1]=v.elements[1],C[M+2]=v.elements[2],C[M+3]=0,C[M+4]=v.elements[3],C[M+5]=v.elements[4],C[M+6]=v.elements[5],C[M+7]=0,C[M+8]=v.elements[6],C[M+9]=v.elements[7],C[M+10]=v.elements[8],C[M+11]=0):ArrayBuffer.isView(v)?C.set(v.subarray(0,C.length-M),M):v.toArray(C,M)}function h(v,C,M,I){let E=v.value,x=C+"_"+M;if(Array.isArray(E)){I[x]===void 0&&(I[x]=[]);let T=I[x],V=!1;for(let U=0;U<E.length;U++)d(E[U],T,U)===!0&&(V=!0);return V}return d(E,I,x)}function d(v,C,M){if(C[M]===void 0)return typeof v=="number"||typeof v=="boolean"?C[M]=v:ArrayBuffer.isView(v)?C[M]=v.slice():C[M]=v.clone(),!0;{let I=C[M];if(typeof v=="number"||typeof v=="boolean"){if(I!==v)return C[M]=v,!0}else{if(ArrayBuffer.isView(v))return!0;if(I.equals(v)===!1)return I.copy(v),!0}}return!1}function p(v){let C=v.uniforms,M=0,I=16;for(let x=0,T=C.length;x<T;x++){let V=Array.isArray(C[x])?C[x]:[C[x]];for(let U=0,D=V.length;U<D;U++){let H=V[U],O=Array.isArray(H.value)?H.value:[H.value],L=Array.isArray(C[x])||Array.isArray(H.value),X=M;for(let G=0,ue=O.length;G<ue;G++){let Z=O[G],Q=b(Z,L),ie=M%I,pe=ie%Q.boundary,fe=ie+pe;M+=pe,fe!==0&&I-fe<Q.storage&&(M+=I-fe),G===0&&(X=M),M+=Q.storage}let $=H.type==="int"?Int32Array:H.type==="uint"?Uint32Array:Float32Array;H.__data=new $((M-X)/Float32Array.BYTES_PER_ELEMENT),H.__offset=X}}let E=M%I;return E>0&&(M+=I-E),v.__size=M,v.__cache={},this}function b(v,C){let M={boundary:0,storage:0};return typeof v=="number"||typeof v=="boolean"?(M.boundary=4,M.storage=4):v.isVector2?(M.boundary=8,M.storage=8):v.isVector3||v.isColor?(M.boundary=16,M.storage=12):v.isVector4?(M.boundary=16,M.storage=16):v.isMatrix3?(M.boundary=16,M.storage=48):v.isMatrix4?(M.boundary=16,M.storage=64):v.isTexture?$e("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(v)?(M.boundary=16,M.storage=v.byteLength):$e("WebGLRenderer: Unsupported uniform value type.",v),C===!0&&(M.boundary=16,M.storage=Math.ceil(M.storage/16)*16),M}function m(v){let C=v.target;C.removeEventListener("dispose",m),n.deleteBuffer(s[C.id]),delete s[C.id],delete r[C.id]}function g(){for(let v in s)n.deleteBuffer(s[v]);s={},r={}}return{bind:o,update:a,dispose:g}}var bE=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),_s=null;function SE(){return _s===null&&(_s=new $o(bE,16,16,wr,ts),_s.name="DFG_LUT",_s.minFilter=ui,_s.magFilter=ui,_s.wrapS=ps,_s.wrapT=ps,_s.generateMipmaps=!1,_s.needsUpdate=!0),_s}var Th=class{constructor(e={}){let{canvas:t=hx(),context:i=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:l=!0,preserveDrawingBuffer:c=!1,powerPreference:u="default",failIfMajorPerformanceCaveat:f=!1,reversedDepthBuffer:h=!1,outputBufferType:d=_i}=e;this.isWebGLRenderer=!0;let p;if(i!==null){if(typeof WebGLRenderingContext<"u"&&i instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=i.getContextAttributes().alpha}else p=o;let b=d,m=new Set([Wu,Gu,Hu]),g=new Set([_i,Qi,na,Jr,zu,Vu]),v=new Uint32Array(4),C=new Int32Array(4),M={textures:[],min:[],max:[],resolution:[]},I=null,E=null,x=[],T=[],V=null;this.domElement=t,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=gs,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let U=this,D=!1,H=null,O=null,L=null,X=null;this._outputColorSpace=Bn;let $=0,G=0,ue=null,Z=-1,Q=null,ie=new Pt,pe=new Pt,fe=null,ee=new ut(0),_e=0,xe=t.width,se=t.height,ce=1,Oe=null,Ke=null,Ge=new Pt(0,0,xe,se),pt=new Pt(0,0,xe,se),ht=!1,rt=new mr,Zt=new gu,Gt=!1,un=!1,Ot=new St,In=new z,bt=new Pt,bn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},en=!1;function hn(){return ue===null?ce:1}let B=i;function Re(A,k){return t.getContext(A,k)}let Je,at,we,zt,Ve,qe,R,S,q,de,ae,ve,be,te,re,ge,F,oe,ne,Ae,ye,Me,We;try{let A={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:l,preserveDrawingBuffer:c,powerPreference:u,failIfMajorPerformanceCaveat:f};if("setAttribute"in t&&t.setAttribute("data-engine",`three.js r${"187"}`),t.addEventListener("webglcontextlost",Be,!1),t.addEventListener("webglcontextrestored",tt,!1),t.addEventListener("webglcontextcreationerror",Ce,!1),B===null){let k="webgl2";if(B=Re(k,A),B===null)throw Re(k)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}et()}catch(A){throw t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),it("WebGLRenderer: "+A.message),A}function et(){Je=new DA(B),Je.init(),ye=new mE(B,Je),at=new SA(B,Je,e,ye),we=new fE(B,Je),at.reversedDepthBuffer&&h&&we.buffers.depth.setReversed(!0),O=B.createFramebuffer(),L=B.createFramebuffer(),X=B.createFramebuffer(),zt=new OA(B),Ve=new QT,qe=new pE(B,Je,we,Ve,at,ye,zt),R=new LA(U),S=new BM(B),Me=new vA(B,S),q=new NA(B,S,zt,Me),de=new BA(B,q,S,Me,zt),oe=new FA(B,at,qe),re=new MA(Ve),ae=new jT(U,R,Je,at,Me,re),ve=new yE(U,Ve),be=new tE,te=new aE(Je),F=new yA(U,R,we,de,p,l),ge=new dE(U,de,at),We=new vE(B,zt,at,we),ne=new bA(B,Je,zt),Ae=new UA(B,Je,zt),zt.programs=ae.programs,U.capabilities=at,U.extensions=Je,U.properties=Ve,U.renderLists=be,U.shadowMap=ge,U.state=we,U.info=zt}b!==_i&&(V=new zA(b,t.width,t.height,a,s,r));let he=new Mp(U,B);this.xr=he,this.getContext=function(){return B},this.getContextAttributes=function(){return B.getContextAttributes()},this.forceContextLoss=function(){let A=Je.get("WEBGL_lose_context");A&&A.loseContext()},this.forceContextRestore=function(){let A=Je.get("WEBGL_lose_context");A&&A.restoreContext()},this.getPixelRatio=function(){return ce},this.setPixelRatio=function(A){A!==void 0&&(ce=A,this.setSize(xe,se,!1))},this.getSize=function(A){return A.set(xe,se)},this.setSize=function(A,k,j=!0){if(he.isPresenting){$e("WebGLRenderer: Can't change size while VR device is presenting.");return}xe=A,se=k,t.width=Math.floor(A*ce),t.height=Math.floor(k*ce),j===!0&&(t.style.width=A+"px",t.style.height=k+"px"),V!==null&&V.setSize(t.width,t.height),this.setViewport(0,0,A,k)},this.getDrawingBufferSize=function(A){return A.set(xe*ce,se*ce).floor()},this.setDrawingBufferSize=function(A,k,j){xe=A,se=k,ce=j,t.width=Math.floor(A*j),t.height=Math.floor(k*j),this.setViewport(0,0,A,k)},this.setEffects=function(A){if(b===_i){it("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(A){for(let k=0;k<A.length;k++)if(A[k].isOutputPass===!0){$e("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}V.setEffects(A||[])},this.getCurrentViewport=function(A){return A.copy(ie)},this.getViewport=function(A){return A.copy(Ge)},this.setViewport=function(A,k,j,Y){A.isVector4?Ge.set(A.x,A.y,A.z,A.w):Ge.set(A,k,j,Y),we.viewport(ie.copy(Ge).multiplyScalar(hn()).round())},this.getScissor=function(A){return A.copy(pt)},this.setScissor=function(A,k,j,Y){A.isVector4?pt.set(A.x,A.y,A.z,A.w):pt.set(A,k,j,Y),we.scissor(pe.copy(pt).multiplyScalar(hn()).round())},this.getScissorTest=function(){return ht},this.setScissorTest=function(A){we.setScissorTest(ht=A)},this.setOpaqueSort=function(A){Oe=A},this.setTransparentSort=function(A){Ke=A},this.getClearColor=function(A){return A.copy(F.getClearColor())},this.setClearColor=function(){F.setClearColor(...arguments)},this.getClearAlpha=function(){return F.getClearAlpha()},this.setClearAlpha=function(){F.setClearAlpha(...arguments)},this.clear=function(A=!0,k=!0,j=!0){let Y=0;if(A){let J=!1;if(ue!==null){let Te=ue.texture.format;J=m.has(Te)}if(J){let Te=ue.texture.type,Ie=g.has(Te),Ee=F.getClearColor(),Le=F.getClearAlpha(),ze=Ee.r,nt=Ee.g,mt=Ee.b;Ie?(v[0]=ze,v[1]=nt,v[2]=mt,v[3]=Le,B.clearBufferuiv(B.COLOR,0,v)):(C[0]=ze,C[1]=nt,C[2]=mt,C[3]=Le,B.clearBufferiv(B.COLOR,0,C))}else Y|=B.COLOR_BUFFER_BIT}k&&(Y|=B.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),j&&(Y|=B.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),Y!==0&&B.clear(Y)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(A){A.setRenderer(this),H=A},this.dispose=function(){t.removeEventListener("webglcontextlost",Be,!1),t.removeEventListener("webglcontextrestored",tt,!1),t.removeEventListener("webglcontextcreationerror",Ce,!1),F.dispose(),be.dispose(),te.dispose(),qe.dispose(),Ve.dispose(),R.dispose(),de.dispose(),q.dispose(),Me.dispose(),We.dispose(),ae.dispose(),he.dispose(),he.removeEventListener("sessionstart",Ll),he.removeEventListener("sessionend",ns),bs.stop()};function Be(A){A.preventDefault(),Ya("WebGLRenderer: Context Lost."),D=!0}function tt(){Ya("WebGLRenderer: Context Restored."),D=!1;let A=zt.autoReset,k=ge.enabled,j=ge.autoUpdate,Y=ge.needsUpdate,J=ge.type;et(),zt.autoReset=A,ge.enabled=k,ge.autoUpdate=j,ge.needsUpdate=Y,ge.type=J}function Ce(A){it("WebGLRenderer: A WebGL context could not be created. Reason: ",A.statusMessage)}function ct(A){let k=A.target;k.removeEventListener("dispose",ct),Wt(k)}function Wt(A){ti(A),Ve.remove(A)}function ti(A){let k=Ve.get(A).programs;k!==void 0&&(k.forEach(function(j){ae.releaseProgram(j)}),A.isShaderMaterial&&ae.releaseShaderCache(A))}this.renderBufferDirect=function(A,k,j,Y,J,Te){k===null&&(k=bn);let Ie=J.isMesh&&J.matrixWorld.determinantAffine()<0,Ee=ha(A,k,j,Y,J);we.setMaterial(Y,Ie);let Le=j.index,ze=1;if(Y.wireframe===!0){if(Le=q.getWireframeAttribute(j),Le===void 0)return;ze=2}let nt=j.drawRange,mt=j.attributes.position,ke=nt.start*ze,gt=(nt.start+nt.count)*ze;Te!==null&&(ke=Math.max(ke,Te.start*ze),gt=Math.min(gt,(Te.start+Te.count)*ze)),Le!==null?(ke=Math.max(ke,0),gt=Math.min(gt,Le.count)):mt!=null&&(ke=Math.max(ke,0),gt=Math.min(gt,mt.count));let Qt=gt-ke;if(Qt<0||Qt===1/0)return;Me.setup(J,Y,Ee,j,Le);let It,Lt=ne;if(Le!==null&&(It=S.get(Le),Lt=Ae,Lt.setIndex(It)),J.isMesh)Y.wireframe===!0?(we.setLineWidth(Y.wireframeLinewidth*hn()),Lt.setMode(B.LINES)):Lt.setMode(B.TRIANGLES);else if(J.isLine){let Sn=Y.linewidth;Sn===void 0&&(Sn=1),we.setLineWidth(Sn*hn()),J.isLineSegments?Lt.setMode(B.LINES):J.isLineLoop?Lt.setMode(B.LINE_LOOP):Lt.setMode(B.LINE_STRIP)}else J.isPoints?Lt.setMode(B.POINTS):J.isSprite&&Lt.setMode(B.TRIANGLES);if(J.isBatchedMesh)if(Je.get("WEBGL_multi_draw"))Lt.renderMultiDraw(J._multiDrawStarts,J._multiDrawCounts,J._multiDrawCount);else{let Sn=J._multiDrawStarts,Ue=J._multiDrawCounts,dn=J._multiDrawCount,xt=Le?S.get(Le).bytesPerElement:1,Ms=Ve.get(Y).currentProgram.getUniforms();for(let fn=0;fn<dn;fn++)Ms.setValue(B,"_gl_DrawID",fn),Lt.render(Sn[fn]/xt,Ue[fn])}else if(J.isInstancedMesh)Lt.renderInstances(ke,Qt,J.count);else if(j.isInstancedBufferGeometry){let Sn=j._maxInstanceCount!==void 0?j._maxInstanceCount:1/0,Ue=Math.min(j.instanceCount,Sn);Lt.renderInstances(ke,Qt,Ue)}else Lt.render(ke,Qt)};function la(A,k,j,Y){H!==null&&A.isNodeMaterial&&H.setObject(Y,A),Gt===!0&&re.setState(A,j,!1),A.transparent===!0&&A.side===gi&&A.forceSinglePass===!1?(A.side=hi,A.needsUpdate=!0,is(A,k,Y),A.side=Mr,A.needsUpdate=!0,is(A,k,Y),A.side=gi):is(A,k,Y)}this.compile=function(A,k,j=null){j===null&&(j=A),H!==null&&H.renderStart(A,k,j),E=te.get(j),E.init(k),T.push(E),j.traverseVisible(function(J){J.isLight&&J.layers.test(k.layers)&&(E.pushLight(J),J.castShadow&&E.pushShadow(J))}),A!==j&&A.traverseVisible(function(J){J.isLight&&J.layers.test(k.layers)&&(E.pushLight(J),J.castShadow&&E.pushShadow(J))}),E.setupLights(),H!==null&&H.updateLights(E.state.lightsArray),un=this.localClippingEnabled,Gt=re.init(this.clippingPlanes,un),Gt===!0&&re.setGlobalState(this.clippingPlanes,k),H!==null&&ge.render(E.state.shadowsArray,j,k);let Y=new Set;return A.traverse(function(J){if(!(J.isMesh||J.isPoints||J.isLine||J.isSprite))return;let Te=J.material;if(Te)if(Array.isArray(Te))for(let Ie=0;Ie<Te.length;Ie++){let Ee=Te[Ie];la(Ee,j,k,J),Y.add(Ee)}else la(Te,j,k,J),Y.add(Te)}),E=T.pop(),H!==null&&H.renderEnd(),Y},this.compileAsync=function(A,k,j=null){let Y=this.compile(A,k,j);return new Promise(J=>{function Te(){if(Y.forEach(function(Ie){let Le=Ve.get(Ie).currentProgram;(Le===void 0||Le.isReady())&&Y.delete(Ie)}),Y.size===0){J(A);return}setTimeout(Te,10)}Je.get("KHR_parallel_shader_compile")!==null?Te():setTimeout(Te,10)})};let jr=null;function zh(A){jr&&jr(A)}function Ll(){bs.stop()}function ns(){bs.start()}let bs=new kx;bs.setAnimationLoop(zh),typeof self<"u"&&bs.setContext(self),this.setAnimationLoop=function(A){jr=A,he.setAnimationLoop(A),A===null?bs.stop():bs.start()},he.addEventListener("sessionstart",Ll),he.addEventListener("sessionend",ns),this.render=function(A,k){if(k!==void 0&&k.isCamera!==!0){it("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(D===!0)return;H!==null&&H.renderStart(A,k);let j=he.enabled===!0&&he.isPresenting===!0,Y=V!==null&&(ue===null||j)&&V.begin(U,ue);if(A.matrixWorldAutoUpdate===!0&&A.updateMatrixWorld(),k.parent===null&&k.matrixWorldAutoUpdate===!0&&k.updateMatrixWorld(),he.enabled===!0&&he.isPresenting===!0&&(V===null||V.isCompositing()===!1)&&(he.cameraAutoUpdate===!0&&he.updateCamera(k),k=he.getCamera()),A.isScene===!0&&A.onBeforeRender(U,A,k,ue),E=te.get(A,T.length),E.init(k),E.state.textureUnits=qe.getTextureUnits(),T.push(E),Ot.multiplyMatrices(k.projectionMatrix,k.matrixWorldInverse),k.isArrayCamera?Zt.setFromArrayCamera(k):rt.setFromProjectionMatrix(Ot,Bi,k.reversedDepth),un=this.localClippingEnabled,Gt=re.init(this.clippingPlanes,un),I=be.get(A,x.length),I.init(),x.push(I),this.info.render.frame++,he.enabled===!0&&he.isPresenting===!0){let Ie=U.xr.getDepthSensingMesh();Ie!==null&&Ss(Ie,k,-1/0,U.sortObjects)}Ss(A,k,0,U.sortObjects),I.finish(),H!==null&&H.updateLights(E.state.lightsArray),U.sortObjects===!0&&I.sort(Oe,Ke),en=he.enabled===!1||he.isPresenting===!1||he.hasDepthSensing()===!1,en&&F.addToRenderList(I,A),this.info.autoReset===!0&&this.info.reset(),Gt===!0&&re.beginShadows();let J=E.state.shadowsArray;if(ge.render(J,A,k),Gt===!0&&re.endShadows(),(Y&&V.hasRenderPass())===!1){let Ie=I.opaque,Ee=I.transmissive;if(E.setupLights(),k.isArrayCamera){let Le=k.cameras;if(Ee.length>0)for(let ze=0,nt=Le.length;ze<nt;ze++){let mt=Le[ze];zi(Ie,Ee,A,mt)}en&&F.render(A);for(let ze=0,nt=Le.length;ze<nt;ze++){let mt=Le[ze];ca(I,A,mt,mt.viewport)}}else Ee.length>0&&zi(Ie,Ee,A,k),en&&F.render(A),ca(I,A,k)}ue!==null&&G===0&&(qe.updateMultisampleRenderTarget(ue),qe.updateRenderTargetMipmap(ue)),Y&&V.end(U),A.isScene===!0&&A.onAfterRender(U,A,k),Me.resetDefaultState(),Z=-1,Q=null,T.pop(),T.length>0?(E=T[T.length-1],qe.setTextureUnits(E.state.textureUnits),Gt===!0&&re.setGlobalState(U.clippingPlanes,E.state.camera)):E=null,x.pop(),x.length>0?I=x[x.length-1]:I=null,H!==null&&H.renderEnd()};function Ss(A,k,j,Y){if(A.visible===!1)return;if(A.layers.test(k.layers)){if(A.isGroup)j=A.renderOrder;else if(A.isLOD)A.autoUpdate===!0&&A.update(k);else if(A.isLight)E.pushLight(A),A.castShadow&&E.pushShadow(A);else if(A.isSprite){let Ie=k.isArrayCamera?Zt:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){Y&&bt.setFromMatrixPosition(A.matrixWorld).applyMatrix4(Ot);let Ee=de.update(A),Le=A.material;Le.visible&&I.push(A,Ee,Le,j,bt.z,null,k)}}else if(A.isMesh||A.isLine||A.isPoints){let Ie=k.isArrayCamera?Zt:rt;if(!A.frustumCulled||A.intersectsFrustum(Ie)){let Ee=de.update(A),Le=A.material;if(Y&&(A.boundingSphere!==void 0?(A.boundingSphere===null&&A.computeBoundingSphere(),bt.copy(A.boundingSphere.center)):(Ee.boundingSphere===null&&Ee.computeBoundingSphere(),bt.copy(Ee.boundingSphere.center)),bt.applyMatrix4(A.matrixWorld).applyMatrix4(Ot)),Array.isArray(Le)){let ze=Ee.groups;for(let nt=0,mt=ze.length;nt<mt;nt++){let ke=ze[nt],gt=Le[ke.materialIndex];gt&&gt.visible&&I.push(A,Ee,gt,j,bt.z,ke,k)}}else Le.visible&&I.push(A,Ee,Le,j,bt.z,null,k)}}}let Te=A.children;for(let Ie=0,Ee=Te.length;Ie<Ee;Ie++)Ss(Te[Ie],k,j,Y)}function ca(A,k,j,Y){let{opaque:J,transmissive:Te,transparent:Ie}=A;E.setupLightsView(j),Gt===!0&&re.setGlobalState(U.clippingPlanes,j),Y&&we.viewport(ie.copy(Y)),J.length>0&&tn(J,k,j),Te.length>0&&tn(Te,k,j),Ie.length>0&&tn(Ie,k,j),we.buffers.depth.setTest(!0),we.buffers.depth.setMask(!0),we.buffers.color.setMask(!0),we.setPolygonOffset(!1)}function zi(A,k,j,Y){if((j.isScene===!0?j.overrideMaterial:null)!==null)return;if(E.state.transmissionRenderTarget[Y.id]===void 0){let ke=Je.has("EXT_color_buffer_half_float")||Je.has("EXT_color_buffer_float");E.state.transmissionRenderTarget[Y.id]=new Ri(1,1,{generateMipmaps:!0,type:ke?ts:_i,minFilter:Vs,samples:Math.max(4,at.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:vt.workingColorSpace})}let Te=E.state.transmissionRenderTarget[Y.id],Ie=Y.viewport||ie;Te.setSize(Ie.z*U.transmissionResolutionScale,Ie.w*U.transmissionResolutionScale);let Ee=U.getRenderTarget(),Le=U.getActiveCubeFace(),ze=U.getActiveMipmapLevel();U.setRenderTarget(Te),U.getClearColor(ee),_e=U.getClearAlpha(),_e<1&&U.setClearColor(16777215,.5),U.clear(),en&&F.render(j);let nt=U.toneMapping;U.toneMapping=gs;let mt=Y.viewport;if(Y.viewport!==void 0&&(Y.viewport=void 0),E.setupLightsView(Y),Gt===!0&&re.setGlobalState(U.clippingPlanes,Y),tn(A,j,Y),qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te),Je.has("WEBGL_multisampled_render_to_texture")===!1){let ke=!1;for(let gt=0,Qt=k.length;gt<Qt;gt++){let It=k[gt],{object:Lt,geometry:Sn,material:Ue,group:dn}=It;if(Ue.side===gi&&Lt.layers.test(Y.layers)){let xt=Ue.side;Ue.side=hi,Ue.needsUpdate=!0,an(Lt,j,Y,Sn,Ue,dn),Ue.side=xt,Ue.needsUpdate=!0,ke=!0}}ke===!0&&(qe.updateMultisampleRenderTarget(Te),qe.updateRenderTargetMipmap(Te))}U.setRenderTarget(Ee,Le,ze),U.setClearColor(ee,_e),mt!==void 0&&(Y.viewport=mt),U.toneMapping=nt}function tn(A,k,j){let Y=k.isScene===!0?k.overrideMaterial:null;for(let J=0,Te=A.length;J<Te;J++){let Ie=A[J],{object:Ee,geometry:Le,group:ze}=Ie,nt=Ie.material;nt.allowOverride===!0&&Y!==null&&(nt=Y),Ee.layers.test(j.layers)&&an(Ee,k,j,Le,nt,ze)}}function an(A,k,j,Y,J,Te){H!==null&&J.isNodeMaterial&&H.setObject(A,J),A.onBeforeRender(U,k,j,Y,J,Te),A.modelViewMatrix.multiplyMatrices(j.matrixWorldInverse,A.matrixWorld),A.normalMatrix.getNormalMatrix(A.modelViewMatrix),J.onBeforeRender(U,k,j,Y,A,Te),J.transparent===!0&&J.side===gi&&J.forceSinglePass===!1?(J.side=hi,J.needsUpdate=!0,U.renderBufferDirect(j,k,Y,J,A,Te),J.side=Mr,J.needsUpdate=!0,U.renderBufferDirect(j,k,Y,J,A,Te),J.side=gi):U.renderBufferDirect(j,k,Y,J,A,Te),A.onAfterRender(U,k,j,Y,J,Te)}function ln(A){let k=0;for(let j of A)j.texture!==null&&k++;return k}function is(A,k,j){k.isScene!==!0&&(k=bn);let Y=Ve.get(A),J=E.state.lights,Te=E.state.shadowsArray,Ie=J.state.version,Ee=ae.getParameters(A,J.state,Te,k,j,E.state.lightProbeGridArray),Le=ae.getProgramCacheKey(Ee),ze=Y.programs;Y.environment=A.isMeshStandardMaterial||A.isMeshLambertMaterial||A.isMeshPhongMaterial?k.environment:null,Y.fog=k.fog;let nt=A.isMeshStandardMaterial||A.isMeshLambertMaterial&&!A.envMap||A.isMeshPhongMaterial&&!A.envMap;Y.envMap=R.get(A.envMap||Y.environment,nt),Y.envMapRotation=Y.environment!==null&&A.envMap===null?k.environmentRotation:A.envMapRotation,ze===void 0&&(A.addEventListener("dispose",ct),ze=new Map,Y.programs=ze,Y.programVariants=new Map);let mt=ze.get(Le);if(mt!==void 0){if(Y.currentProgram===mt&&Y.lightsStateVersion===Ie)return ua(A,Ee),mt}else Ee.uniforms=ae.getUniforms(A),H!==null&&A.isNodeMaterial&&H.build(A,j,Ee),A.onBeforeCompile(Ee,U),mt=ae.acquireProgram(Ee,Le),ze.set(Le,mt),Y.uniforms=Ee.uniforms;let ke=Y.uniforms;return(!A.isShaderMaterial&&!A.isRawShaderMaterial||A.clipping===!0)&&(ke.clippingPlanes=re.uniform),ua(A,Ee),Y.needsLights=Xs(A),Y.lightsStateVersion=Ie,Y.needsLights&&(ke.ambientLightColor.value=J.state.ambient,ke.lightProbe.value=J.state.probe,ke.sunLights.value=J.state.sun,ke.sunLightShadows.value=J.state.sunShadow,ke.directionalLights.value=J.state.directional,ke.directionalLightShadows.value=J.state.directionalShadow,ke.spotLights.value=J.state.spot,ke.spotLightShadows.value=J.state.spotShadow,ke.rectAreaLights.value=J.state.rectArea,ke.ltc_1.value=J.state.rectAreaLTC1,ke.ltc_2.value=J.state.rectAreaLTC2,ke.pointLights.value=J.state.point,ke.pointLightShadows.value=J.state.pointShadow,ke.hemisphereLights.value=J.state.hemi,ke.sunShadowMatrix.value=J.state.sunShadowMatrix,ke.sunShadowCascade.value=J.state.sunShadowCascade,ke.directionalShadowMatrix.value=J.state.directionalShadowMatrix,ke.spotLightMatrix.value=J.state.spotLightMatrix,ke.spotLightMap.value=J.state.spotLightMap,ke.pointShadowMatrix.value=J.state.pointShadowMatrix),Y.numLightProbeGrids=ln(E.state.lightProbeGridArray),Y.currentProgram=mt,Y.uniformsList=null,mt}function yi(A,k,j,Y,J){let Te=Ve.get(A),Ie=Te.currentProgram.id+","+Y+","+J,Ee=Te.programVariants.get(Ie);return Ee===void 0?(Ee=is(A,k,j),Te.programVariants.set(Ie,Ee)):(Te.currentProgram=Ee,Te.uniformsList=null,Te.outputColorSpace=Y,Te.toneMapping=J),Ee}function Ws(A){if(A.uniformsList===null){let k=A.currentProgram.getUniforms();A.uniformsList=ia.seqWithValue(k.seq,A.uniforms)}return A.uniformsList}function ua(A,k){let j=Ve.get(A);j.outputColorSpace=k.outputColorSpace,j.batching=k.batching,j.batchingColor=k.batchingColor,j.instancing=k.instancing,j.instancingColor=k.instancingColor,j.instancingMorph=k.instancingMorph,j.skinning=k.skinning,j.morphTargets=k.morphTargets,j.morphNormals=k.morphNormals,j.morphColors=k.morphColors,j.morphTargetsCount=k.morphTargetsCount,j.numClippingPlanes=k.numClippingPlanes,j.numIntersection=k.numClipIntersection,j.vertexAlphas=k.vertexAlphas,j.vertexTangents=k.vertexTangents,j.toneMapping=k.toneMapping}function ha(A,k,j,Y,J){k.isScene!==!0&&(k=bn),qe.resetTextureUnits();let Te=k.fog,Ie=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial?k.environment:null,Ee=ue===null?U.outputColorSpace:ue.isXRRenderTarget===!0?ue.texture.colorSpace:vt.workingColorSpace,Le=Y.isMeshStandardMaterial||Y.isMeshLambertMaterial&&!Y.envMap||Y.isMeshPhongMaterial&&!Y.envMap,ze=R.get(Y.envMap||Ie,Le),nt=Y.vertexColors===!0&&!!j.attributes.color&&j.attributes.color.itemSize===4,mt=!!j.attributes.tangent&&(!!Y.normalMap||Y.anisotropy>0),ke=!!j.morphAttributes.position,gt=!!j.morphAttributes.normal,Qt=!!j.morphAttributes.color,It=gs;Y.toneMapped&&(ue===null||ue.isXRRenderTarget===!0)&&(It=U.toneMapping);let Lt=j.morphAttributes.position||j.morphAttributes.normal||j.morphAttributes.color,Sn=Lt!==void 0?Lt.length:0,Ue=Ve.get(Y),dn=E.state.lights;if(Gt===!0&&(un===!0||A!==Q)){let Dt=A===Q&&Y.id===Z;re.setState(Y,A,Dt)}let xt=!1,Ms=!1;Y.version===Ue.__version?Ue.needsLights&&Ue.lightsStateVersion!==dn.state.version||J.isBatchedMesh&&Ue.batching===!1||!J.isBatchedMesh&&Ue.batching===!0||J.isBatchedMesh&&Ue.batchingColor===!0&&J._colorsTexture===null||J.isBatchedMesh&&Ue.batchingColor===!1&&J._colorsTexture!==null||J.isInstancedMesh&&Ue.instancing===!1||!J.isInstancedMesh&&Ue.instancing===!0||J.isSkinnedMesh&&Ue.skinning===!1||!J.isSkinnedMesh&&Ue.skinning===!0||J.isInstancedMesh&&Ue.instancingColor===!0&&J.instanceColor===null||J.isInstancedMesh&&Ue.instancingColor===!1&&J.instanceColor!==null||J.isInstancedMesh&&Ue.instancingMorph===!0&&J.morphTexture===null||J.isInstancedMesh&&Ue.instancingMorph===!1&&J.morphTexture!==null||Ue.envMap!==ze||Y.fog===!0&&Ue.fog!==Te||Ue.numClippingPlanes!==void 0&&(Ue.numClippingPlanes!==re.numPlanes||Ue.numIntersection!==re.numIntersection)||Ue.vertexAlphas!==nt||Ue.vertexTangents!==mt||Ue.morphTargets!==ke||Ue.morphNormals!==gt||Ue.morphColors!==Qt||Ue.morphTargetsCount!==Sn||Ue.numLightProbeGrids!==ln(E.state.lightProbeGridArray)?xt=!0:(Ue.outputColorSpace!==Ee||Ue.toneMapping!==It)&&(Ms=!0):(xt=!0,Ue.__version=Y.version);let fn=Ue.currentProgram;(xt===!0||Ms===!0)&&(fn=Ms===!0?yi(Y,k,J,Ee,It):is(Y,k,J),H&&Y.isNodeMaterial&&H.onUpdateProgram(Y,fn,Ue));let to=!1,ss=!1,ws=!1,dt=fn.getUniforms(),nn=Ue.uniforms;if(we.useProgram(fn.program)&&(to=!0,ss=!0,ws=!0),Y.id!==Z&&(Z=Y.id,ss=!0),to||Q!==A){we.buffers.depth.getReversed()&&A.reversedDepth!==!0&&(A._reversedDepth=!0,A.updateProjectionMatrix()),dt.setValue(B,"projectionMatrix",A.projectionMatrix),dt.setValue(B,"viewMatrix",A.matrixWorldInverse);let pn=dt.map.cameraPosition;pn!==void 0&&pn.setValue(B,In.setFromMatrixPosition(A.matrixWorld)),at.logarithmicDepthBuffer&&dt.setValue(B,"logDepthBufFC",2/(Math.log(A.far+1)/Math.LN2)),(Y.isMeshPhongMaterial||Y.isMeshToonMaterial||Y.isMeshLambertMaterial||Y.isMeshBasicMaterial||Y.isMeshStandardMaterial||Y.isShaderMaterial)&&dt.setValue(B,"isOrthographic",A.isOrthographicCamera===!0),Q!==A&&(Q=A,ss=!0,ws=!0)}if(Ue.needsLights&&(dn.state.sunShadowMap.length>0&&dt.setValue(B,"sunShadowMap",dn.state.sunShadowMap,qe),dn.state.directionalShadowMap.length>0&&dt.setValue(B,"directionalShadowMap",dn.state.directionalShadowMap,qe),dn.state.spotShadowMap.length>0&&dt.setValue(B,"spotShadowMap",dn.state.spotShadowMap,qe),dn.state.pointShadowMap.length>0&&dt.setValue(B,"pointShadowMap",dn.state.pointShadowMap,qe)),J.isSkinnedMesh){dt.setOptional(B,J,"bindMatrix"),dt.setOptional(B,J,"bindMatrixInverse");let Dt=J.skeleton;Dt&&(Dt.boneTexture===null&&Dt.computeBoneTexture(),dt.setValue(B,"boneTexture",Dt.boneTexture,qe))}J.isBatchedMesh&&(dt.setOptional(B,J,"batchingTexture"),dt.setValue(B,"batchingTexture",J._matricesTexture,qe),dt.setOptional(B,J,"batchingIdTexture"),dt.setValue(B,"batchingIdTexture",J._indirectTexture,qe),dt.setOptional(B,J,"batchingColorTexture"),J._colorsTexture!==null&&dt.setValue(B,"batchingColorTexture",J._colorsTexture,qe));let ni=j.morphAttributes;if((ni.position!==void 0||ni.normal!==void 0||ni.color!==void 0)&&oe.update(J,j,fn),(ss||Ue.receiveShadow!==J.receiveShadow)&&(Ue.receiveShadow=J.receiveShadow,dt.setValue(B,"receiveShadow",J.receiveShadow)),(Y.isMeshStandardMaterial||Y.isMeshLambertMaterial||Y.isMeshPhongMaterial)&&Y.envMap===null&&k.environment!==null&&(nn.envMapIntensity.value=k.environmentIntensity),nn.dfgLUT!==void 0&&(nn.dfgLUT.value=SE()),ss){if(dt.setValue(B,"toneMappingExposure",U.toneMappingExposure),Ue.needsLights&&Qr(nn,ws),Te&&Y.fog===!0&&ve.refreshFogUniforms(nn,Te),ve.refreshMaterialUniforms(nn,Y,ce,se,E.state.transmissionRenderTarget[A.id]),Ue.needsLights&&Ue.numLightProbeGrids>0){let Dt=M,pn=0;for(let $n of E.state.lightProbeGridArray)$n.texture!==null&&(Dt.textures[pn]=$n.texture,Dt.min[pn]=$n.boundingBox.min,Dt.max[pn]=$n.boundingBox.max,Dt.resolution[pn]=$n.resolution,pn++);for(let $n in Dt)Dt[$n].length=pn;nn.probesSH.value=Dt.textures,nn.probesMin.value=Dt.min,nn.probesMax.value=Dt.max,nn.probesResolution.value=Dt.resolution}ia.upload(B,Ws(Ue),nn,qe)}if(Y.isShaderMaterial&&Y.uniformsNeedUpdate===!0&&(ia.upload(B,Ws(Ue),nn,qe),Y.uniformsNeedUpdate=!1),Y.isSpriteMaterial&&dt.setValue(B,"center",J.center),dt.setValue(B,"modelViewMatrix",J.modelViewMatrix),dt.setValue(B,"normalMatrix",J.normalMatrix),dt.setValue(B,"modelMatrix",J.matrixWorld),Y.uniformsGroups!==void 0){let Dt=Y.uniformsGroups;for(let pn=0,$n=Dt.length;pn<$n;pn++){let Dl=Dt[pn];We.update(Dl,fn),We.bind(Dl,fn)}}return fn}function Qr(A,k){A.ambientLightColor.needsUpdate=k,A.lightProbe.needsUpdate=k,A.sunLights.needsUpdate=k,A.sunLightShadows.needsUpdate=k,A.directionalLights.needsUpdate=k,A.directionalLightShadows.needsUpdate=k,A.pointLights.needsUpdate=k,A.pointLightShadows.needsUpdate=k,A.spotLights.needsUpdate=k,A.spotLightShadows.needsUpdate=k,A.rectAreaLights.needsUpdate=k,A.hemisphereLights.needsUpdate=k}function Xs(A){return A.isMeshLambertMaterial||A.isMeshToonMaterial||A.isMeshPhongMaterial||A.isMeshStandardMaterial||A.isShadowMaterial||A.isShaderMaterial&&A.lights===!0}this.getActiveCubeFace=function(){return $},this.getActiveMipmapLevel=function(){return G},this.getRenderTarget=function(){return ue},this.setRenderTargetTextures=function(A,k,j){let Y=Ve.get(A);Y.__autoAllocateDepthBuffer=A.resolveDepthBuffer===!1,Y.__autoAllocateDepthBuffer===!1&&(Y.__useRenderToTexture=!1),Ve.get(A.texture).__webglTexture=k,Ve.get(A.depthTexture).__webglTexture=Y.__autoAllocateDepthBuffer?void 0:j,Y.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(A,k){let j=Ve.get(A);j.__webglFramebuffer=k,j.__useDefaultFramebuffer=k===void 0},this.setRenderTarget=function(A,k=0,j=0){ue=A,$=k,G=j;let Y=null,J=!1,Te=!1;if(A){let Ee=Ve.get(A);if(Ee.__useDefaultFramebuffer!==void 0){we.bindFramebuffer(B.FRAMEBUFFER,Ee.__webglFramebuffer),ie.copy(A.viewport),pe.copy(A.scissor),fe=A.scissorTest,we.viewport(ie),we.scissor(pe),we.setScissorTest(fe),Z=-1;return}else if(Ee.__webglFramebuffer===void 0)qe.setupRenderTarget(A);else if(Ee.__hasExternalTextures)qe.rebindTextures(A,Ve.get(A.texture).__webglTexture,Ve.get(A.depthTexture).__webglTexture);else if(A.depthBuffer){let nt=A.depthTexture;if(Ee.__boundDepthTexture!==nt){if(nt!==null&&Ve.has(nt)&&(A.width!==nt.image.width||A.height!==nt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");qe.setupDepthRenderbuffer(A)}}let Le=A.texture;(Le.isData3DTexture||Le.isDataArrayTexture||Le.isCompressedArrayTexture)&&(Te=!0);let ze=Ve.get(A).__webglFramebuffer;A.isWebGLCubeRenderTarget?(Array.isArray(ze[k])?Y=ze[k][j]:Y=ze[k],J=!0):A.samples>0&&qe.useMultisampledRTT(A)===!1?Y=Ve.get(A).__webglMultisampledFramebuffer:Array.isArray(ze)?Y=ze[j]:Y=ze,ie.copy(A.viewport),pe.copy(A.scissor),fe=A.scissorTest}else ie.copy(Ge).multiplyScalar(ce).floor(),pe.copy(pt).multiplyScalar(ce).floor(),fe=ht;if(j!==0&&(Y=O),we.bindFramebuffer(B.FRAMEBUFFER,Y)&&we.drawBuffers(A,Y),we.viewport(ie),we.scissor(pe),we.setScissorTest(fe),J){let Ee=Ve.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_CUBE_MAP_POSITIVE_X+k,Ee.__webglTexture,j)}else if(Te){let Ee=k;for(let Le=0;Le<A.textures.length;Le++){let ze=Ve.get(A.textures[Le]);B.framebufferTextureLayer(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0+Le,ze.__webglTexture,j,Ee)}}else if(A!==null&&j!==0){let Ee=Ve.get(A.texture);B.framebufferTexture2D(B.FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,Ee.__webglTexture,j)}Z=-1};function eo(A){let k=Ve.get(A);return(k.__readFormat!==A.format||k.__readType!==A.type)&&(k.__readFormat=A.format,k.__readType=A.type,k.__formatReadable=at.textureFormatReadable(A.format),k.__typeReadable=at.textureTypeReadable(A.type)),k}this.readRenderTargetPixels=function(A,k,j,Y,J,Te,Ie,Ee=0){if(!(A&&A.isWebGLRenderTarget)){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let Le=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le){we.bindFramebuffer(B.FRAMEBUFFER,Le);try{let ze=A.textures[Ee],nt=ze.format,mt=ze.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ee);let ke=eo(ze);if(ke.__formatReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(ke.__typeReadable===!1){it("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}k>=0&&k<=A.width-Y&&j>=0&&j<=A.height-J&&B.readPixels(k,j,Y,J,ye.convert(nt),ye.convert(mt),Te)}finally{let ze=ue!==null?Ve.get(ue).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,ze)}}},this.readRenderTargetPixelsAsync=async function(A,k,j,Y,J,Te,Ie,Ee=0){if(!(A&&A.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let Le=Ve.get(A).__webglFramebuffer;if(A.isWebGLCubeRenderTarget&&Ie!==void 0&&(Le=Le[Ie],Array.isArray(Le)&&(Le=Le[0])),Le)if(k>=0&&k<=A.width-Y&&j>=0&&j<=A.height-J){we.bindFramebuffer(B.FRAMEBUFFER,Le);let ze=A.textures[Ee],nt=ze.format,mt=ze.type;A.textures.length>1&&B.readBuffer(B.COLOR_ATTACHMENT0+Ee);let ke=eo(ze);if(ke.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(ke.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let gt=B.createBuffer();B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.bufferData(B.PIXEL_PACK_BUFFER,Te.byteLength,B.STREAM_READ),B.readPixels(k,j,Y,J,ye.convert(nt),ye.convert(mt),0),B.bindBuffer(B.PIXEL_PACK_BUFFER,null);let Qt=ue!==null?Ve.get(ue).__webglFramebuffer:null;we.bindFramebuffer(B.FRAMEBUFFER,Qt);let It=B.fenceSync(B.SYNC_GPU_COMMANDS_COMPLETE,0);return B.flush(),await fx(B,It,4),B.bindBuffer(B.PIXEL_PACK_BUFFER,gt),B.getBufferSubData(B.PIXEL_PACK_BUFFER,0,Te),B.bindBuffer(B.PIXEL_PACK_BUFFER,null),B.deleteBuffer(gt),B.deleteSync(It),Te}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(A,k=null,j=0){let Y=Math.pow(2,-j),J=Math.floor(A.image.width*Y),Te=Math.floor(A.image.height*Y),Ie=k!==null?k.x:0,Ee=k!==null?k.y:0;qe.setTexture2D(A,0),B.copyTexSubImage2D(B.TEXTURE_2D,j,0,0,Ie,Ee,J,Te),we.unbindTexture()},this.copyTextureToTexture=function(A,k,j=null,Y=null,J=0,Te=0){let Ie,Ee,Le,ze,nt,mt,ke,gt,Qt,It=A.isCompressedTexture?A.mipmaps[Te]:A.image;if(j!==null)Ie=j.max.x-j.min.x,Ee=j.max.y-j.min.y,Le=j.isBox3?j.max.z-j.min.z:1,ze=j.min.x,nt=j.min.y,mt=j.isBox3?j.min.z:0;else{let dt=Math.pow(2,-J);Ie=Math.floor(It.width*dt),Ee=Math.floor(It.height*dt),A.isDataArrayTexture?Le=It.depth:A.isData3DTexture?Le=Math.floor(It.depth*dt):Le=1,ze=0,nt=0,mt=0}Y!==null?(ke=Y.x,gt=Y.y,Qt=Y.z):(ke=0,gt=0,Qt=0);let Lt=ye.convert(k.format),Sn=ye.convert(k.type),Ue;k.isData3DTexture?(qe.setTexture3D(k,0),Ue=B.TEXTURE_3D):k.isDataArrayTexture||k.isCompressedArrayTexture?(qe.setTexture2DArray(k,0),Ue=B.TEXTURE_2D_ARRAY):(qe.setTexture2D(k,0),Ue=B.TEXTURE_2D),we.activeTexture(B.TEXTURE0),we.pixelStorei(B.UNPACK_FLIP_Y_WEBGL,k.flipY),we.pixelStorei(B.UNPACK_PREMULTIPLY_ALPHA_WEBGL,k.premultiplyAlpha),we.pixelStorei(B.UNPACK_ALIGNMENT,k.unpackAlignment);let dn=we.getParameter(B.UNPACK_ROW_LENGTH),xt=we.getParameter(B.UNPACK_IMAGE_HEIGHT),Ms=we.getParameter(B.UNPACK_SKIP_PIXELS),fn=we.getParameter(B.UNPACK_SKIP_ROWS),to=we.getParameter(B.UNPACK_SKIP_IMAGES);we.pixelStorei(B.UNPACK_ROW_LENGTH,It.width),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,It.height),we.pixelStorei(B.UNPACK_SKIP_PIXELS,ze),we.pixelStorei(B.UNPACK_SKIP_ROWS,nt),we.pixelStorei(B.UNPACK_SKIP_IMAGES,mt);let ss=A.isDataArrayTexture||A.isData3DTexture,ws=k.isDataArrayTexture||k.isData3DTexture;if(A.isDepthTexture){let dt=Ve.get(A),nn=Ve.get(k),ni=Ve.get(dt.__renderTarget),Dt=Ve.get(nn.__renderTarget);we.bindFramebuffer(B.READ_FRAMEBUFFER,ni.__webglFramebuffer),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,Dt.__webglFramebuffer);for(let pn=0;pn<Le;pn++)ss&&(B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(A).__webglTexture,J,mt+pn),B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,Ve.get(k).__webglTexture,Te,Qt+pn)),B.blitFramebuffer(ze,nt,ze+Ie,nt+Ee,ke,gt,ke+Ie,gt+Ee,B.DEPTH_BUFFER_BIT,B.NEAREST);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else if(J!==0||A.isRenderTargetTexture||Ve.has(A)){let dt=Ve.get(A),nn=Ve.get(k);we.bindFramebuffer(B.READ_FRAMEBUFFER,L),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,X);for(let ni=0;ni<Le;ni++)ss?B.framebufferTextureLayer(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,dt.__webglTexture,J,mt+ni):B.framebufferTexture2D(B.READ_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,dt.__webglTexture,J),ws?B.framebufferTextureLayer(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,nn.__webglTexture,Te,Qt+ni):B.framebufferTexture2D(B.DRAW_FRAMEBUFFER,B.COLOR_ATTACHMENT0,B.TEXTURE_2D,nn.__webglTexture,Te),J!==0?B.blitFramebuffer(ze,nt,ze+Ie,nt+Ee,ke,gt,ke+Ie,gt+Ee,B.COLOR_BUFFER_BIT,B.NEAREST):ws?B.copyTexSubImage3D(Ue,Te,ke,gt,Qt+ni,ze,nt,Ie,Ee):B.copyTexSubImage2D(Ue,Te,ke,gt,ze,nt,Ie,Ee);we.bindFramebuffer(B.READ_FRAMEBUFFER,null),we.bindFramebuffer(B.DRAW_FRAMEBUFFER,null)}else ws?A.isDataTexture||A.isData3DTexture?B.texSubImage3D(Ue,Te,ke,gt,Qt,Ie,Ee,Le,Lt,Sn,It.data):k.isCompressedArrayTexture?B.compressedTexSubImage3D(Ue,Te,ke,gt,Qt,Ie,Ee,Le,Lt,It.data):B.texSubImage3D(Ue,Te,ke,gt,Qt,Ie,Ee,Le,Lt,Sn,It):A.isDataTexture?B.texSubImage2D(B.TEXTURE_2D,Te,ke,gt,Ie,Ee,Lt,Sn,It.data):A.isCompressedTexture?B.compressedTexSubImage2D(B.TEXTURE_2D,Te,ke,gt,It.width,It.height,Lt,It.data):B.texSubImage2D(B.TEXTURE_2D,Te,ke,gt,Ie,Ee,Lt,Sn,It);we.pixelStorei(B.UNPACK_ROW_LENGTH,dn),we.pixelStorei(B.UNPACK_IMAGE_HEIGHT,xt),we.pixelStorei(B.UNPACK_SKIP_PIXELS,Ms),we.pixelStorei(B.UNPACK_SKIP_ROWS,fn),we.pixelStorei(B.UNPACK_SKIP_IMAGES,to),Te===0&&k.generateMipmaps===!0&&k.mipmapsAutoUpdate===!0&&B.generateMipmap(Ue),we.unbindTexture()},this.initRenderTarget=function(A){Ve.get(A).__webglFramebuffer===void 0&&qe.setupRenderTarget(A)},this.initTexture=function(A){A.isCubeTexture?qe.setTextureCube(A,0):A.isData3DTexture?qe.setTexture3D(A,0):A.isDataArrayTexture||A.isCompressedArrayTexture?qe.setTexture2DArray(A,0):qe.setTexture2D(A,0),we.unbindTexture()},this.resetState=function(){$=0,G=0,ue=null,we.reset(),Me.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bi}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(e){this._outputColorSpace=e;let t=this.getContext();t.drawingBufferColorSpace=vt._getDrawingBufferColorSpace(e),t.unpackColorSpace=vt._getUnpackColorSpace()}};var ME=.28;function ra(n){let e=new rl({flatShading:!0,side:gi});return e.color.setRGB(n[0]/255,n[1]/255,n[2]/255,Bn),e}function wE(n,e,t){n.onBeforeCompile=i=>{i.uniforms.heatTable={value:e},i.uniforms.showsHeat=t,i.vertexShader=i.vertexShader.replace("#include <common>",`#include <common>
attribute float heat;
varying float vHeat;`).replace("#include <begin_vertex>",`#include <begin_vertex>
vHeat = heat;`),i.fragmentShader=i.fragmentShader.replace("#include <common>",`#include <common>
uniform sampler2D heatTable;
uniform bool showsHeat;
varying float vHeat;`).replace("#include <color_fragment>",`#include <color_fragment>
                if (showsHeat) {
                    float at = (floor(vHeat * 255.0 + 0.5) + 0.5) / 256.0;
                    diffuseColor.rgb = texture2D(heatTable, vec2(at, 0.5)).rgb;
                }`)}}var Rl=class{constructor(e,t){this.mesh=e;this.corners=W0(e),this.radius=Math.hypot(...e.max.map((o,a)=>o-e.min[a]))/2,this.geometry.setAttribute("position",new yn(this.corners,3)),this.setHeat(new Uint8Array(this.corners.length/3)),this.geometry.boundingSphere=new Vn(new z,this.radius),this.table=new $o(k0(t),256,1,Ii),this.table.colorSpace=Bn,this.table.minFilter=cn,this.table.magFilter=cn,this.table.needsUpdate=!0;let i=ra(t),s=ra(t),r=ra(t);for(let o of[i,s,r])o.polygonOffset=!0,o.polygonOffsetFactor=1,o.polygonOffsetUnits=1,wE(o,this.table,this.showsHeat);s.colorWrite=!1,r.polygonOffset=!1,r.transparent=!0,r.opacity=ME,r.depthWrite=!1,r.depthFunc=fr,this.materials=[i,s,r],this.solid=this.make(i,0),this.ghost.add(this.make(s,1),this.make(r,2))}mesh;corners;solid;ghost=new pi;radius;geometry=new vn;materials;showsHeat={value:!1};table;make(e,t){let i=new Hn(this.geometry,e);return i.matrixAutoUpdate=!1,i.renderOrder=t,i}get triangles(){return this.corners.length/9}setHeat(e){this.geometry.setAttribute("heat",new yn(e,1,!0))}showHeat(e){this.showsHeat.value=e}showAs(e){this.solid.visible=e==="solid",this.ghost.visible=e==="ghost"}clip(e){for(let t of this.materials)t.clippingPlanes=e}place(e,t){let i=bo(e,this.mesh.centre),s=new St().set(e[0],e[1],e[2],i[0]-t[0],e[4],e[5],e[6],i[1]-t[1],e[8],e[9],e[10],i[2]-t[2],0,0,0,1);for(let r of[this.solid,...this.ghost.children])r.matrix.copy(s),r.matrixWorldNeedsUpdate=!0;return s}boxCorners(e){let t=this.mesh.max.map((s,r)=>s-this.mesh.centre[r]),i=[-1,1];return i.flatMap(s=>i.flatMap(r=>i.map(o=>new z(s*t[0],r*t[1],o*t[2]).applyMatrix4(e).toArray())))}dispose(){this.geometry.dispose(),this.table.dispose(),this.materials.forEach(e=>e.dispose())}};Pe.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Ze},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};di.line={uniforms:wl.merge([Pe.common,Pe.fog,Pe.line]),vertexShader:`
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
		`};var oa=class extends ki{constructor(e){super({type:"LineMaterial",uniforms:wl.clone(di.line.uniforms),vertexShader:di.line.vertexShader,fragmentShader:di.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(e)}get color(){return this.uniforms.diffuse.value}set color(e){this.uniforms.diffuse.value=e}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(e){e===!0!==this.worldUnits&&(this.needsUpdate=!0),e===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(e){this.uniforms.linewidth&&(this.uniforms.linewidth.value=e)}get dashed(){return"USE_DASH"in this.defines}set dashed(e){e===!0!==this.dashed&&(this.needsUpdate=!0),e===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(e){this.uniforms.dashScale.value=e}get dashSize(){return this.uniforms.dashSize.value}set dashSize(e){this.uniforms.dashSize.value=e}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(e){this.uniforms.dashOffset.value=e}get gapSize(){return this.uniforms.gapSize.value}set gapSize(e){this.uniforms.gapSize.value=e}get opacity(){return this.uniforms.opacity.value}set opacity(e){this.uniforms&&(this.uniforms.opacity.value=e)}get resolution(){return this.uniforms.resolution.value}set resolution(e){this.uniforms.resolution.value.copy(e)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(e){this.defines&&(e===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),e===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var Zx=new Qn,Rh=new z,aa=class extends dl{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let e=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],t=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],i=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(i),this.setAttribute("position",new kn(e,3)),this.setAttribute("uv",new kn(t,2))}applyMatrix4(e){let t=this.attributes.instanceStart,i=this.attributes.instanceEnd;return t!==void 0&&(t.applyMatrix4(e),i.applyMatrix4(e),t.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new vr(t,6,1);return this.setAttribute("instanceStart",new ji(i,3,0)),this.setAttribute("instanceEnd",new ji(i,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(e){let t;e instanceof Float32Array?t=e:Array.isArray(e)&&(t=new Float32Array(e));let i=new vr(t,6,1);return this.setAttribute("instanceColorStart",new ji(i,3,0)),this.setAttribute("instanceColorEnd",new ji(i,3,3)),this}fromWireframeGeometry(e){return this.setPositions(e.attributes.position.array),this}fromEdgesGeometry(e){return this.setPositions(e.attributes.position.array),this}fromMesh(e){return this.fromWireframeGeometry(new sl(e.geometry)),this}fromLineSegments(e){let t=e.geometry;return this.setPositions(t.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new Qn);let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;e!==void 0&&t!==void 0&&(this.boundingBox.setFromBufferAttribute(e),Zx.setFromBufferAttribute(t),this.boundingBox.union(Zx))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new Vn),this.boundingBox===null&&this.computeBoundingBox();let e=this.attributes.instanceStart,t=this.attributes.instanceEnd;if(e!==void 0&&t!==void 0){let i=this.boundingSphere.center;this.boundingBox.getCenter(i);let s=0;for(let r=0,o=e.count;r<o;r++)Rh.fromBufferAttribute(e,r),s=Math.max(s,i.distanceToSquared(Rh)),Rh.fromBufferAttribute(t,r),s=Math.max(s,i.distanceToSquared(Rh));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};var wp=new Pt,Kx=new z,jx=new z,Xn=new Pt,qn=new Pt,xs=new Pt,Ap=new z,Tp=new St,Yn=new fl,Qx=new z,Ph=new Qn,Ih=new Vn,ys=new Pt,vs,Kr;function ey(n,e,t){return ys.set(0,0,-e,1).applyMatrix4(n.projectionMatrix),ys.multiplyScalar(1/ys.w),ys.x=Kr/t.width,ys.y=Kr/t.height,ys.applyMatrix4(n.projectionMatrixInverse),ys.multiplyScalar(1/ys.w),Math.abs(Math.max(ys.x,ys.y))}function AE(n,e){let t=n.matrixWorld,i=n.geometry,s=i.attributes.instanceStart,r=i.attributes.instanceEnd,o=Math.min(i.instanceCount,s.count);for(let a=0,l=o;a<l;a++){Yn.start.fromBufferAttribute(s,a),Yn.end.fromBufferAttribute(r,a),Yn.applyMatrix4(t);let c=new z,u=new z;vs.distanceSqToSegment(Yn.start,Yn.end,u,c),u.distanceTo(c)<Kr*.5&&e.push({point:u,pointOnLine:c,distance:vs.origin.distanceTo(u),object:n,face:null,faceIndex:a,uv:null,uv1:null})}}function TE(n,e,t){let i=e.projectionMatrix,r=n.material.resolution,o=n.matrixWorld,a=n.geometry,l=a.attributes.instanceStart,c=a.attributes.instanceEnd,u=Math.min(a.instanceCount,l.count),f=-e.near;vs.at(1,xs),xs.w=1,xs.applyMatrix4(e.matrixWorldInverse),xs.applyMatrix4(i),xs.multiplyScalar(1/xs.w),xs.x*=r.x/2,xs.y*=r.y/2,xs.z=0,Ap.copy(xs),Tp.multiplyMatrices(e.matrixWorldInverse,o);for(let h=0,d=u;h<d;h++){if(Xn.fromBufferAttribute(l,h),qn.fromBufferAttribute(c,h),Xn.w=1,qn.w=1,Xn.applyMatrix4(Tp),qn.applyMatrix4(Tp),Xn.z>f&&qn.z>f)continue;if(Xn.z>f){let C=Xn.z-qn.z,M=(Xn.z-f)/C;Xn.lerp(qn,M)}else if(qn.z>f){let C=qn.z-Xn.z,M=(qn.z-f)/C;qn.lerp(Xn,M)}Xn.applyMatrix4(i),qn.applyMatrix4(i),Xn.multiplyScalar(1/Xn.w),qn.multiplyScalar(1/qn.w),Xn.x*=r.x/2,Xn.y*=r.y/2,qn.x*=r.x/2,qn.y*=r.y/2,Yn.start.copy(Xn),Yn.start.z=0,Yn.end.copy(qn),Yn.end.z=0;let b=Yn.closestPointToPointParameter(Ap,!0);Yn.at(b,Qx);let m=Ml.lerp(Xn.z,qn.z,b),g=m>=-1&&m<=1,v=Ap.distanceTo(Qx)<Kr*.5;if(g&&v){Yn.start.fromBufferAttribute(l,h),Yn.end.fromBufferAttribute(c,h),Yn.start.applyMatrix4(o),Yn.end.applyMatrix4(o);let C=new z,M=new z;vs.distanceSqToSegment(Yn.start,Yn.end,M,C),t.push({point:M,pointOnLine:C,distance:vs.origin.distanceTo(M),object:n,face:null,faceIndex:h,uv:null,uv1:null})}}}var Lh=class extends Hn{constructor(e=new aa,t=new oa({color:Math.random()*16777215})){super(e,t),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let e=this.geometry,t=e.attributes.instanceStart,i=e.attributes.instanceEnd,s=new Float32Array(2*t.count);for(let o=0,a=0,l=t.count;o<l;o++,a+=2)Kx.fromBufferAttribute(t,o),jx.fromBufferAttribute(i,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+Kx.distanceTo(jx);let r=new vr(s,2,1);return e.setAttribute("instanceDistanceStart",new ji(r,1,0)),e.setAttribute("instanceDistanceEnd",new ji(r,1,1)),this}raycast(e,t){let i=this.material.worldUnits,s=e.camera;if(s===null&&!i&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),i===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=e.params.Line2!==void 0&&e.params.Line2.threshold||0;vs=e.ray;let o=this.matrixWorld,a=this.geometry,l=this.material;Kr=l.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Ih.copy(a.boundingSphere).applyMatrix4(o);let c;if(i)c=Kr*.5;else{let f=Math.max(s.near,Ih.distanceToPoint(vs.origin));c=ey(s,f,l.resolution)}if(Ih.radius+=c,vs.intersectsSphere(Ih)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Ph.copy(a.boundingBox).applyMatrix4(o);let u;if(i)u=Kr*.5;else{let f=Math.max(s.near,Ph.distanceToPoint(vs.origin));u=ey(s,f,l.resolution)}Ph.expandByScalar(u),vs.intersectsBox(Ph)!==!1&&(i?AE(this,t):TE(this,s,t))}onBeforeRender(e){let t=this.material.uniforms;t&&t.resolution&&(e.getViewport(wp),this.material.uniforms.resolution.value.set(wp.z,wp.w))}};var EE=3;function ty(n,e){let t=[new Map,new Map];for(let i=0;i+2<n.length;i+=3)e(n[i],n[i+1])&&t.forEach((s,r)=>{let o=n[i+r];s.set(o,Math.max(n[i+2],s.get(o)??0))});return t}function CE(n,e){return[...n].flatMap(([t,i])=>i===EE===e?[t]:[])}function RE(n,e){let t=new Float32Array(9*e.length);return e.forEach((i,s)=>t.set(n.subarray(9*i,9*i+9),9*s)),t}function Ep(n){let e=new Float32Array(2*n.length);for(let t=0;t<n.length;t+=9){let[i,s,r]=[0,3,6].map(o=>n.subarray(t+o,t+o+3));[i,s,s,r,r,i].forEach((o,a)=>e.set(o,2*t+3*a))}return e}function PE(n,e,t){let i={segments:[],points:[]};for(let s=0;s<n.length;){let r=n[s],o=s,a=[];for(;o<n.length&&n[o]===r;o+=4)a.push(e([n[o+1],n[o+2],n[o+3]]));if(s=o,!t(r))continue;a.length===1&&i.points.push(...a[0]);let l=a.length>2?a.length:a.length-1;for(let c=0;c<l;++c)i.segments.push(...a[c],...a[(c+1)%a.length])}return i}var Dh=class{group=new pi;lines=new pi;red;yellow;outline=new gr({color:5915904});segment=new oa({color:0,linewidth:2.5});dot=new Jo({color:0,size:7,sizeAttenuation:!1});constructor(){this.red=ra(ds(2)),this.yellow=ra(ds(1)),this.red.emissive.copy(this.red.color).multiplyScalar(.45),this.yellow.emissive.copy(this.yellow.color).multiplyScalar(.35),this.group.add(this.lines)}clear(){for(let e of[...this.group.children,...this.lines.children])e!==this.lines&&(e.geometry.dispose(),e.removeFromParent())}addBody(e,t,i){for(let s of[!1,!0]){let r=RE(e,CE(t,s));if(r.length===0)continue;let o=new vn().setAttribute("position",new yn(r,3));if(this.addPlaced(new Hn(o,s?this.red:this.yellow),i),!s){let a=new vn().setAttribute("position",new yn(Ep(r),3));this.addPlaced(new Xr(a,this.outline),i)}}}addPlaced(e,t){e.matrixAutoUpdate=!1,e.matrix.copy(t),e.frustumCulled=!1,this.group.add(e)}show(e,t,i){this.clear(),e.forEach((s,r)=>this.addBody(s,t[r],i[r]))}addPoints(e,t,i,s){let o=PE(e,a=>bo(t,a).map((l,c)=>l-i[c]),s);if(o.segments.length>0){let a=new aa().setPositions(new Float32Array(o.segments)),l=new Lh(a,this.segment);l.frustumCulled=!1,l.renderOrder=4,this.lines.add(l)}if(o.points.length>0){let a=new yn(new Float32Array(o.points),3),l=new Qa(new vn().setAttribute("position",a),this.dot);l.frustumCulled=!1,l.renderOrder=5,this.lines.add(l)}}clip(e){for(let t of[this.red,this.yellow,this.outline,this.segment,this.dot])t.clippingPlanes=e}dispose(){this.clear(),[this.red,this.yellow,this.outline,this.segment,this.dot].forEach(e=>e.dispose())}};function ny(n,{origin:[e,t,i],direction:[s,r,o]},a){let l=null,c=1/0;for(let u=0;u<n.length;u+=9){let f=n[u],h=n[u+1],d=n[u+2],p=n[u+3]-f,b=n[u+4]-h,m=n[u+5]-d,g=n[u+6]-f,v=n[u+7]-h,C=n[u+8]-d,M=r*C-o*v,I=o*g-s*C,E=s*v-r*g,x=p*M+b*I+m*E;if(x===0)continue;let T=e-f,V=t-h,U=i-d,D=(T*M+V*I+U*E)/x;if(!(D>=0&&D<=1))continue;let H=V*m-U*b,O=U*p-T*m,L=T*b-V*p,X=(s*H+r*O+o*L)/x;if(!(X>=0&&D+X<=1))continue;let $=(g*H+v*O+C*L)/x;$>0&&$<c&&!a($)&&(c=$,l={triangle:u/9,distance:$})}return l}var Nh=class{group=new pi;face=new Yo({color:2068479,side:gi,transparent:!0,opacity:.55});edge=new gr({color:675742});clear(){for(let e of[...this.group.children])e.geometry.dispose(),e.removeFromParent()}show(e,t,i){if(this.clear(),!e||!t||9*t.triangle>=e.length)return;let s=e.slice(9*t.triangle,9*t.triangle+9),r=a=>new vn().setAttribute("position",new yn(a,3)),o=[new Hn(r(s),this.face),new Xr(r(Ep(s)),this.edge)];for(let a of o)a.matrixAutoUpdate=!1,a.matrix.copy(i[t.body]),a.frustumCulled=!1,this.group.add(a)}dispose(){this.clear(),this.face.dispose(),this.edge.dispose()}};var iy={type:"change"},Rp={type:"start"},ry={type:"end"},Uh=new pr,sy=new li,IE=Math.cos(70*Ml.DEG2RAD),Pn=new z,xi=2*Math.PI,Et={NONE:-1,ROTATE:0,DOLLY:1,PAN:2,TOUCH_ROTATE:3,TOUCH_PAN:4,TOUCH_DOLLY_PAN:5,TOUCH_DOLLY_ROTATE:6},Cp=1e-6,Oh=class extends pl{constructor(e,t=null){super(e,t),this.state=Et.NONE,this.target=new z,this.cursor=new z,this.minDistance=0,this.maxDistance=1/0,this.minZoom=0,this.maxZoom=1/0,this.minTargetRadius=0,this.maxTargetRadius=1/0,this.minPolarAngle=0,this.maxPolarAngle=Math.PI,this.minAzimuthAngle=-1/0,this.maxAzimuthAngle=1/0,this.enableDamping=!1,this.dampingFactor=.05,this.enableZoom=!0,this.zoomSpeed=1,this.enableRotate=!0,this.rotateSpeed=1,this.keyRotateSpeed=1,this.enablePan=!0,this.panSpeed=1,this.screenSpacePanning=!0,this.keyPanSpeed=7,this.zoomToCursor=!1,this.autoRotate=!1,this.autoRotateSpeed=2,this.keys={LEFT:"ArrowLeft",UP:"ArrowUp",RIGHT:"ArrowRight",BOTTOM:"ArrowDown"},this.mouseButtons={LEFT:br.ROTATE,MIDDLE:br.DOLLY,RIGHT:br.PAN},this.touches={ONE:Sr.ROTATE,TWO:Sr.DOLLY_PAN},this.target0=this.target.clone(),this.position0=this.object.position.clone(),this.zoom0=this.object.zoom,this._cursorStyle="auto",this._domElementKeyEvents=null,this._lastPosition=new z,this._lastQuaternion=new Ci,this._lastTargetPosition=new z,this._quat=new Ci().setFromUnitVectors(e.up,new z(0,1,0)),this._quatInverse=this._quat.clone().invert(),this._spherical=new jo,this._sphericalDelta=new jo,this._scale=1,this._panOffset=new z,this._rotateStart=new Ze,this._rotateEnd=new Ze,this._rotateDelta=new Ze,this._panStart=new Ze,this._panEnd=new Ze,this._panDelta=new Ze,this._dollyStart=new Ze,this._dollyEnd=new Ze,this._dollyDelta=new Ze,this._dollyDirection=new z,this._mouse=new Ze,this._performCursorZoom=!1,this._pointers=[],this._pointerPositions={},this._controlActive=!1,this._onPointerMove=DE.bind(this),this._onPointerDown=LE.bind(this),this._onPointerUp=NE.bind(this),this._onContextMenu=VE.bind(this),this._onMouseWheel=FE.bind(this),this._onKeyDown=BE.bind(this),this._onTouchStart=kE.bind(this),this._onTouchMove=zE.bind(this),this._onMouseDown=UE.bind(this),this._onMouseMove=OE.bind(this),this._interceptControlDown=HE.bind(this),this._interceptControlUp=GE.bind(this),this.domElement!==null&&this.connect(this.domElement),this.update()}set cursorStyle(e){this._cursorStyle=e,e==="grab"?this.domElement.style.cursor="grab":this.domElement.style.cursor="auto"}get cursorStyle(){return this._cursorStyle}connect(e){super.connect(e),this.domElement.addEventListener("pointerdown",this._onPointerDown),this.domElement.addEventListener("pointercancel",this._onPointerUp),this.domElement.addEventListener("contextmenu",this._onContextMenu),this.domElement.addEventListener("wheel",this._onMouseWheel,{passive:!1}),this.domElement.ownerDocument.addEventListener("keydown",this._interceptControlDown,{passive:!0,capture:!0}),this.domElement.style.touchAction="none"}disconnect(){this.state=Et.NONE,this.domElement.removeEventListener("pointerdown",this._onPointerDown),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.domElement.removeEventListener("pointercancel",this._onPointerUp),this.domElement.removeEventListener("wheel",this._onMouseWheel),this.domElement.removeEventListener("contextmenu",this._onContextMenu),this.stopListenToKeyEvents(),this.domElement.ownerDocument.removeEventListener("keydown",this._interceptControlDown,{capture:!0}),this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{capture:!0}),this._controlActive=!1,this._pointers.length=0,this._pointerPositions={},this.domElement.style.touchAction="",this.domElement.style.cursor="auto"}dispose(){this.disconnect()}getPolarAngle(){return this._spherical.phi}getAzimuthalAngle(){return this._spherical.theta}getDistance(){return this.object.position.distanceTo(this.target)}listenToKeyEvents(e){e.addEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=e}stopListenToKeyEvents(){this._domElementKeyEvents!==null&&(this._domElementKeyEvents.removeEventListener("keydown",this._onKeyDown),this._domElementKeyEvents=null)}saveState(){this.target0.copy(this.target),this.position0.copy(this.object.position),this.zoom0=this.object.zoom}reset(){this.target.copy(this.target0),this.object.position.copy(this.position0),this.object.zoom=this.zoom0,this.object.updateProjectionMatrix(),this.dispatchEvent(iy),this.update(),this.state=Et.NONE}pan(e,t){this._pan(e,t),this.update()}dollyIn(e){this._dollyIn(e),this.update()}dollyOut(e){this._dollyOut(e),this.update()}rotateLeft(e){this._rotateLeft(e),this.update()}rotateUp(e){this._rotateUp(e),this.update()}update(e=null){let t=this.object.position;Pn.copy(t).sub(this.target),Pn.applyQuaternion(this._quat),this._spherical.setFromVector3(Pn),this.autoRotate&&this.state===Et.NONE&&this._rotateLeft(this._getAutoRotationAngle(e)),this.enableDamping?(this._spherical.theta+=this._sphericalDelta.theta*this.dampingFactor,this._spherical.phi+=this._sphericalDelta.phi*this.dampingFactor):(this._spherical.theta+=this._sphericalDelta.theta,this._spherical.phi+=this._sphericalDelta.phi);let i=this.minAzimuthAngle,s=this.maxAzimuthAngle;isFinite(i)&&isFinite(s)&&(i<-Math.PI?i+=xi:i>Math.PI&&(i-=xi),s<-Math.PI?s+=xi:s>Math.PI&&(s-=xi),i<=s?this._spherical.theta=Math.max(i,Math.min(s,this._spherical.theta)):this._spherical.theta=this._spherical.theta>(i+s)/2?Math.max(i,this._spherical.theta):Math.min(s,this._spherical.theta)),this._spherical.phi=Math.max(this.minPolarAngle,Math.min(this.maxPolarAngle,this._spherical.phi)),this._spherical.makeSafe(),this.enableDamping===!0?this.target.addScaledVector(this._panOffset,this.dampingFactor):this.target.add(this._panOffset),this.target.sub(this.cursor),this.target.clampLength(this.minTargetRadius,this.maxTargetRadius),this.target.add(this.cursor);let r=!1;if(this.zoomToCursor&&this._performCursorZoom||this.object.isOrthographicCamera)this._spherical.radius=this._clampDistance(this._spherical.radius);else{let o=this._spherical.radius;this._spherical.radius=this._clampDistance(this._spherical.radius*this._scale),r=o!=this._spherical.radius}if(Pn.setFromSpherical(this._spherical),Pn.applyQuaternion(this._quatInverse),t.copy(this.target).add(Pn),this.object.lookAt(this.target),this.enableDamping===!0?(this._sphericalDelta.theta*=1-this.dampingFactor,this._sphericalDelta.phi*=1-this.dampingFactor,this._panOffset.multiplyScalar(1-this.dampingFactor)):(this._sphericalDelta.set(0,0,0),this._panOffset.set(0,0,0)),this.zoomToCursor&&this._performCursorZoom){let o=null;if(this.object.isPerspectiveCamera){let a=Pn.length();o=this._clampDistance(a*this._scale);let l=a-o;this.object.position.addScaledVector(this._dollyDirection,l),this.object.updateMatrixWorld(),r=!!l}else if(this.object.isOrthographicCamera){let a=new z(this._mouse.x,this._mouse.y,0);a.unproject(this.object);let l=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),this.object.updateProjectionMatrix(),r=l!==this.object.zoom;let c=new z(this._mouse.x,this._mouse.y,0);c.unproject(this.object),this.object.position.sub(c).add(a),this.object.updateMatrixWorld(),o=Pn.length()}else console.warn("WARNING: OrbitControls.js encountered an unknown camera type - zoom to cursor disabled."),this.zoomToCursor=!1;o!==null&&(this.screenSpacePanning?this.target.set(0,0,-1).transformDirection(this.object.matrix).multiplyScalar(o).add(this.object.position):(Uh.origin.copy(this.object.position),Uh.direction.set(0,0,-1).transformDirection(this.object.matrix),Math.abs(this.object.up.dot(Uh.direction))<IE?this.object.lookAt(this.target):(sy.setFromNormalAndCoplanarPoint(this.object.up,this.target),Uh.intersectPlane(sy,this.target))))}else if(this.object.isOrthographicCamera){let o=this.object.zoom;this.object.zoom=Math.max(this.minZoom,Math.min(this.maxZoom,this.object.zoom/this._scale)),o!==this.object.zoom&&(this.object.updateProjectionMatrix(),r=!0)}return this._scale=1,this._performCursorZoom=!1,r||this._lastPosition.distanceToSquared(this.object.position)>Cp||8*(1-this._lastQuaternion.dot(this.object.quaternion))>Cp||this._lastTargetPosition.distanceToSquared(this.target)>Cp?(this.dispatchEvent(iy),this._lastPosition.copy(this.object.position),this._lastQuaternion.copy(this.object.quaternion),this._lastTargetPosition.copy(this.target),!0):!1}_getAutoRotationAngle(e){return e!==null?xi/60*this.autoRotateSpeed*e:xi/60/60*this.autoRotateSpeed}_getZoomScale(e){let t=Math.abs(e*.01);return Math.pow(.95,this.zoomSpeed*t)}_rotateLeft(e){this._sphericalDelta.theta-=e}_rotateUp(e){this._sphericalDelta.phi-=e}_panLeft(e,t){Pn.setFromMatrixColumn(t,0),Pn.multiplyScalar(-e),this._panOffset.add(Pn)}_panUp(e,t){this.screenSpacePanning===!0?Pn.setFromMatrixColumn(t,1):(Pn.setFromMatrixColumn(t,0),Pn.crossVectors(this.object.up,Pn)),Pn.multiplyScalar(e),this._panOffset.add(Pn)}_pan(e,t){let i=this.domElement;if(this.object.isPerspectiveCamera){let s=this.object.position;Pn.copy(s).sub(this.target);let r=Pn.length();r*=Math.tan(this.object.fov/2*Math.PI/180),this._panLeft(2*e*r/i.clientHeight,this.object.matrix),this._panUp(2*t*r/i.clientHeight,this.object.matrix)}else this.object.isOrthographicCamera?(this._panLeft(e*(this.object.right-this.object.left)/this.object.zoom/i.clientWidth,this.object.matrix),this._panUp(t*(this.object.top-this.object.bottom)/this.object.zoom/i.clientHeight,this.object.matrix)):(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - pan disabled."),this.enablePan=!1)}_dollyOut(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale/=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_dollyIn(e){this.object.isPerspectiveCamera||this.object.isOrthographicCamera?this._scale*=e:(console.warn("WARNING: OrbitControls.js encountered an unknown camera type - dolly/zoom disabled."),this.enableZoom=!1)}_updateZoomParameters(e,t){if(!this.zoomToCursor)return;this._performCursorZoom=!0;let i=this.domElement.getBoundingClientRect(),s=e-i.left,r=t-i.top,o=i.width,a=i.height;this._mouse.x=s/o*2-1,this._mouse.y=-(r/a)*2+1,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()}_clampDistance(e){return Math.max(this.minDistance,Math.min(this.maxDistance,e))}_handleMouseDownRotate(e){this._rotateStart.set(e.clientX,e.clientY)}_handleMouseDownDolly(e){this._updateZoomParameters(e.clientX,e.clientY),this._dollyStart.set(e.clientX,e.clientY)}_handleMouseDownPan(e){this._panStart.set(e.clientX,e.clientY)}_handleMouseMoveRotate(e){this._rotateEnd.set(e.clientX,e.clientY),this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(xi*this._rotateDelta.x/t.clientHeight),this._rotateUp(xi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd),this.update()}_handleMouseMoveDolly(e){this._dollyEnd.set(e.clientX,e.clientY),this._dollyDelta.subVectors(this._dollyEnd,this._dollyStart),this._dollyDelta.y>0?this._dollyOut(this._getZoomScale(this._dollyDelta.y)):this._dollyDelta.y<0&&this._dollyIn(this._getZoomScale(this._dollyDelta.y)),this._dollyStart.copy(this._dollyEnd),this.zoomToCursor&&(this._performCursorZoom=!0,this._dollyDirection.set(this._mouse.x,this._mouse.y,1).unproject(this.object).sub(this.object.position).normalize()),this.update()}_handleMouseMovePan(e){this._panEnd.set(e.clientX,e.clientY),this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd),this.update()}_handleMouseWheel(e){this._updateZoomParameters(e.clientX,e.clientY),e.deltaY<0?this._dollyIn(this._getZoomScale(e.deltaY)):e.deltaY>0&&this._dollyOut(this._getZoomScale(e.deltaY)),this.update()}_handleKeyDown(e){let t=!1;switch(e.code){case this.keys.UP:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,this.keyPanSpeed),t=!0;break;case this.keys.BOTTOM:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateUp(-xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(0,-this.keyPanSpeed),t=!0;break;case this.keys.LEFT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(this.keyPanSpeed,0),t=!0;break;case this.keys.RIGHT:e.ctrlKey||e.metaKey||e.shiftKey?this.enableRotate&&this._rotateLeft(-xi*this.keyRotateSpeed/this.domElement.clientHeight):this.enablePan&&this._pan(-this.keyPanSpeed,0),t=!0;break}t&&(e.preventDefault(),this.update())}_handleTouchStartRotate(e){if(this._pointers.length===1)this._rotateStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._rotateStart.set(i,s)}}_handleTouchStartPan(e){if(this._pointers.length===1)this._panStart.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panStart.set(i,s)}}_handleTouchStartDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyStart.set(0,r)}_handleTouchStartDollyPan(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enablePan&&this._handleTouchStartPan(e)}_handleTouchStartDollyRotate(e){this.enableZoom&&this._handleTouchStartDolly(e),this.enableRotate&&this._handleTouchStartRotate(e)}_handleTouchMoveRotate(e){if(this._pointers.length==1)this._rotateEnd.set(e.pageX,e.pageY);else{let i=this._getSecondPointerPosition(e),s=.5*(e.pageX+i.x),r=.5*(e.pageY+i.y);this._rotateEnd.set(s,r)}this._rotateDelta.subVectors(this._rotateEnd,this._rotateStart).multiplyScalar(this.rotateSpeed);let t=this.domElement;this._rotateLeft(xi*this._rotateDelta.x/t.clientHeight),this._rotateUp(xi*this._rotateDelta.y/t.clientHeight),this._rotateStart.copy(this._rotateEnd)}_handleTouchMovePan(e){if(this._pointers.length===1)this._panEnd.set(e.pageX,e.pageY);else{let t=this._getSecondPointerPosition(e),i=.5*(e.pageX+t.x),s=.5*(e.pageY+t.y);this._panEnd.set(i,s)}this._panDelta.subVectors(this._panEnd,this._panStart).multiplyScalar(this.panSpeed),this._pan(this._panDelta.x,this._panDelta.y),this._panStart.copy(this._panEnd)}_handleTouchMoveDolly(e){let t=this._getSecondPointerPosition(e),i=e.pageX-t.x,s=e.pageY-t.y,r=Math.sqrt(i*i+s*s);this._dollyEnd.set(0,r),this._dollyDelta.set(0,Math.pow(this._dollyEnd.y/this._dollyStart.y,this.zoomSpeed)),this._dollyOut(this._dollyDelta.y),this._dollyStart.copy(this._dollyEnd);let o=(e.pageX+t.x)*.5,a=(e.pageY+t.y)*.5;this._updateZoomParameters(o,a)}_handleTouchMoveDollyPan(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enablePan&&this._handleTouchMovePan(e)}_handleTouchMoveDollyRotate(e){this.enableZoom&&this._handleTouchMoveDolly(e),this.enableRotate&&this._handleTouchMoveRotate(e)}_addPointer(e){this._pointers.push(e.pointerId)}_removePointer(e){delete this._pointerPositions[e.pointerId];for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId){this._pointers.splice(t,1);return}}_isTrackingPointer(e){for(let t=0;t<this._pointers.length;t++)if(this._pointers[t]==e.pointerId)return!0;return!1}_trackPointer(e){let t=this._pointerPositions[e.pointerId];t===void 0&&(t=new Ze,this._pointerPositions[e.pointerId]=t),t.set(e.pageX,e.pageY)}_getSecondPointerPosition(e){let t=e.pointerId===this._pointers[0]?this._pointers[1]:this._pointers[0];return this._pointerPositions[t]}_customWheelEvent(e){let t=e.deltaMode,i={clientX:e.clientX,clientY:e.clientY,deltaY:e.deltaY};switch(t){case 1:i.deltaY*=16;break;case 2:i.deltaY*=100;break}return e.ctrlKey&&!this._controlActive&&(i.deltaY*=10),i}};function LE(n){this.enabled!==!1&&(this._pointers.length===0&&(this.domElement.setPointerCapture(n.pointerId),this.domElement.ownerDocument.addEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.addEventListener("pointerup",this._onPointerUp)),!this._isTrackingPointer(n)&&(this._addPointer(n),n.pointerType==="touch"?this._onTouchStart(n):this._onMouseDown(n),this._cursorStyle==="grab"&&(this.domElement.style.cursor="grabbing")))}function DE(n){this.enabled!==!1&&(n.pointerType==="touch"?this._onTouchMove(n):this._onMouseMove(n))}function NE(n){switch(this._removePointer(n),this._pointers.length){case 0:this.domElement.releasePointerCapture(n.pointerId),this.domElement.ownerDocument.removeEventListener("pointermove",this._onPointerMove),this.domElement.ownerDocument.removeEventListener("pointerup",this._onPointerUp),this.dispatchEvent(ry),this.state=Et.NONE,this._cursorStyle==="grab"&&(this.domElement.style.cursor="grab");break;case 1:let e=this._pointers[0],t=this._pointerPositions[e];this._onTouchStart({pointerId:e,pageX:t.x,pageY:t.y});break}}function UE(n){let e;switch(n.button){case 0:e=this.mouseButtons.LEFT;break;case 1:e=this.mouseButtons.MIDDLE;break;case 2:e=this.mouseButtons.RIGHT;break;default:e=-1}switch(e){case br.DOLLY:if(this.enableZoom===!1)return;this._handleMouseDownDolly(n),this.state=Et.DOLLY;break;case br.ROTATE:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Et.PAN}else{if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Et.ROTATE}break;case br.PAN:if(n.ctrlKey||n.metaKey||n.shiftKey){if(this.enableRotate===!1)return;this._handleMouseDownRotate(n),this.state=Et.ROTATE}else{if(this.enablePan===!1)return;this._handleMouseDownPan(n),this.state=Et.PAN}break;default:this.state=Et.NONE}this.state!==Et.NONE&&this.dispatchEvent(Rp)}function OE(n){switch(this.state){case Et.ROTATE:if(this.enableRotate===!1)return;this._handleMouseMoveRotate(n);break;case Et.DOLLY:if(this.enableZoom===!1)return;this._handleMouseMoveDolly(n);break;case Et.PAN:if(this.enablePan===!1)return;this._handleMouseMovePan(n);break}}function FE(n){this.enabled===!1||this.enableZoom===!1||this.state!==Et.NONE||(n.preventDefault(),this.dispatchEvent(Rp),this._handleMouseWheel(this._customWheelEvent(n)),this.dispatchEvent(ry))}function BE(n){this.enabled!==!1&&this._handleKeyDown(n)}function kE(n){switch(this._trackPointer(n),this._pointers.length){case 1:switch(this.touches.ONE){case Sr.ROTATE:if(this.enableRotate===!1){this.state=Et.NONE;break}this._handleTouchStartRotate(n),this.state=Et.TOUCH_ROTATE;break;case Sr.PAN:if(this.enablePan===!1){this.state=Et.NONE;break}this._handleTouchStartPan(n),this.state=Et.TOUCH_PAN;break;default:this.state=Et.NONE}break;case 2:switch(this.touches.TWO){case Sr.DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchStartDollyPan(n),this.state=Et.TOUCH_DOLLY_PAN;break;case Sr.DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchStartDollyRotate(n),this.state=Et.TOUCH_DOLLY_ROTATE;break;default:this.state=Et.NONE}break;default:this.state=Et.NONE}this.state!==Et.NONE&&this.dispatchEvent(Rp)}function zE(n){switch(this._trackPointer(n),this.state){case Et.TOUCH_ROTATE:if(this.enableRotate===!1)return;this._handleTouchMoveRotate(n),this.update();break;case Et.TOUCH_PAN:if(this.enablePan===!1)return;this._handleTouchMovePan(n),this.update();break;case Et.TOUCH_DOLLY_PAN:if(this.enableZoom===!1&&this.enablePan===!1)return;this._handleTouchMoveDollyPan(n),this.update();break;case Et.TOUCH_DOLLY_ROTATE:if(this.enableZoom===!1&&this.enableRotate===!1)return;this._handleTouchMoveDollyRotate(n),this.update();break;default:this.state=Et.NONE}}function VE(n){this.enabled!==!1&&n.preventDefault()}function HE(n){n.key==="Control"&&(this._controlActive=!0,this.domElement.ownerDocument.addEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}function GE(n){n.key==="Control"&&(this._controlActive=!1,this.domElement.ownerDocument.removeEventListener("keyup",this._interceptControlUp,{passive:!0,capture:!0}))}var WE=1.08,XE=new z(.75,-1,.6).normalize();function qE(){let n=new Za;return n.add(new ll(16777215,10133670,1.9)),n}var Fh=class{constructor(e,t,i){this.canvas=e;this.moved=t;this.drawn=i;this.renderer=new Th({canvas:e,antialias:!0}),this.renderer.outputColorSpace=Bn,this.renderer.autoClear=!1,this.renderer.localClippingEnabled=!0,this.camera.up.set(0,0,1),this.controls=new Oh(this.camera,e),this.controls.enableDamping=!1,this.controls.zoomToCursor=!0,this.controls.addEventListener("change",this.change),e.addEventListener("webglcontextrestored",this.draw),this.watcher=new ResizeObserver(()=>this.resize()),this.watcher.observe(e),this.resize()}canvas;moved;drawn;frames=0;renderer;camera=new ci(35,1,.01,1e3);controls;lamp=new hl(16777215,2.3);layers=[];watcher;isWaiting=!1;isPlacing=!1;radius=1;change=()=>{this.draw(),this.isPlacing||this.moved()};draw=()=>{this.isWaiting||(this.isWaiting=!0,requestAnimationFrame(()=>{this.isWaiting=!1,this.render(),this.drawn()}))};resize(){let[e,t]=[this.canvas.clientWidth,this.canvas.clientHeight];e>0&&t>0&&(this.renderer.setPixelRatio(Math.min(2,devicePixelRatio)),this.renderer.setSize(e,t,!1),this.camera.aspect=e/t,this.camera.updateProjectionMatrix(),this.draw())}setBackground(e){this.renderer.setClearColor(new ut(e)),this.draw()}setLayers(e){this.layers=e.map(({objects:t,forgetsDepth:i})=>{let s=qE();return s.add(...t),{scene:s,forgetsDepth:i}}),this.draw()}render(){let e=this.camera.position.distanceTo(this.controls.target),t=this.camera.position.length()+this.radius;this.camera.near=Math.max(e/500,(t-2*this.radius)/2,t/1e5),this.camera.near=Math.min(this.camera.near,e/2),this.camera.far=2*t,this.camera.updateProjectionMatrix(),this.lamp.position.copy(this.camera.position),this.lamp.target.position.copy(this.controls.target),this.renderer.clear();for(let{scene:i,forgetsDepth:s}of this.layers)s&&this.renderer.clearDepth(),i.add(this.lamp,this.lamp.target),this.renderer.render(i,this.camera);this.frames+=1}fit(e,t,i){let s=new z(...e),r=i?XE.clone():this.camera.position.clone().sub(this.controls.target).normalize(),o=new z().crossVectors(this.camera.up,r).normalize(),a=new z().crossVectors(r,o),l=Math.tan(this.camera.fov*Math.PI/360),c=l*this.camera.aspect,u=1e-9;for(let f of t){let h=new z(...f).sub(s),d=Math.max(Math.abs(h.dot(o))/c,Math.abs(h.dot(a))/l);u=Math.max(u,d+h.dot(r))}this.look(s.clone().addScaledVector(r,WE*u),s)}look(e,t){this.isPlacing=!0,this.controls.target.copy(t),this.camera.position.copy(e),this.controls.update(),this.isPlacing=!1,this.draw()}turn(e,t){let i=this.controls.target,s=this.camera.position.clone().sub(i),r=s.length(),o=Math.atan2(s.y,s.x)+e,a=Math.min(Math.PI-.01,Math.max(.01,Math.acos(s.z/r)-t)),l=r*Math.sin(a);s.set(l*Math.cos(o),l*Math.sin(o),r*Math.cos(a)),this.look(s.add(i),i.clone()),this.moved()}approach(e){let t=this.controls.target,i=this.camera.position.clone().sub(t).multiplyScalar(e);this.look(i.add(t),t.clone()),this.moved()}setRadius(e){this.radius=e}get view(){return[...this.camera.position.toArray(),...this.controls.target.toArray()]}set view(e){this.look(new z().fromArray(e,0),new z().fromArray(e,3))}rayAt(e,t){let i=new Ze(2*e/this.canvas.clientWidth-1,1-2*t/this.canvas.clientHeight),s=this.camera;s.updateMatrixWorld();let o=new z(i.x,i.y,.5).unproject(s).sub(this.camera.position).normalize();return{origin:this.camera.position.toArray(),direction:o.toArray()}}pixelOf(e){this.camera.updateMatrixWorld();let t=new z(...e).project(this.camera);return[(t.x+1)/2*this.canvas.clientWidth,(1-t.y)/2*this.canvas.clientHeight]}picture(){return this.render(),new Promise(e=>this.canvas.toBlob(e,"image/png"))}dispose(){this.watcher.disconnect(),this.controls.dispose(),this.canvas.removeEventListener("webglcontextrestored",this.draw),this.renderer.dispose(),this.renderer.forceContextLoss()}};function oy(n,e){let t=new z(n==="x"?-1:0,n==="y"?-1:0,n==="z"?-1:0);return new li(t,e)}var ay={mode:"contacts",ghost:"b",throughWalls:!0,lines:!0,clip:null,camera:null,partA:"",partB:"",pick:null};function YE(n,e){let t=(n??"").split(",").map(Number);return t.length===e&&t.every(Number.isFinite)&&n?t:null}function $E(n){let e=/^([xyz]):(-?[\d.]+(?:e[-+]?\d+)?)$/i.exec(n??"");return e&&Number.isFinite(Number(e[2]))?{axis:e[1],at:Number(e[2])}:null}function JE(n){let e=/^([ab]):(\d+)$/.exec(n??"");return e?{body:e[1]==="a"?0:1,triangle:Number(e[2])}:null}function Pp(n,e){let[t,i]=["",""];for(let s of[n.get("part"),n.get("with")])s&&(s.startsWith("b/")?i=s.slice(2):s.startsWith("a/")?t=s.slice(2):t===""&&e(s)?t=s:i=s);return[t,i]}function cy(n,e){return Object.entries(n).every(([t,i])=>t==="camera"||i===e[t])}function Ip(n,e){let t=n.get("ghost"),[i,s]=Pp(n,e);return{mode:n.get("mode")==="heat"?"heat":"contacts",ghost:t==="a"||t==="none"?t:"b",throughWalls:n.get("walls")!=="0",lines:n.get("lines")!=="0",clip:$E(n.get("clip")),camera:YE(n.get("cam"),6),partA:i,partB:s,pick:JE(n.get("pick"))}}function ly(n){return String(Number(n.toPrecision(6)))}function Pl(n){let e={};return n.mode!==ay.mode&&(e.mode=n.mode),n.camera&&(e.cam=n.camera.map(ly).join(",")),n.ghost!==ay.ghost&&(e.ghost=n.ghost),n.throughWalls||(e.walls="0"),n.lines||(e.lines="0"),n.partA&&(e.part=`a/${n.partA}`),n.partB&&(e[n.partA?"with":"part"]=`b/${n.partB}`),n.clip&&(e.clip=`${n.clip.axis}:${ly(n.clip.at)}`),n.pick&&(e.pick=`${n.pick.body===0?"a":"b"}:${n.pick.triangle}`),e}var ZE=[186,190,196],KE=[100,138,186],jE=[1,0,0,0,0,1,0,0,0,0,1,0],Bh=class{stage;bodies;contactsView=new Dh;mark=new Nh;origin;matrices=[new St,new St];highlights=[new Map,new Map];contacts=null;state=null;fitted=null;constructor(e,t,i,s){this.stage=new Fh(e,i,s),this.bodies=[new Rl(t[0],ZE),new Rl(t[1],KE)],this.origin=t[0].centre,this.refreshTheme()}refreshTheme(){this.stage.setBackground(Gi("--stage"))}relativePose(e){return yc(So(e.pose_a),e.pose_b)}show(e,t){this.contacts=e,this.matrices=[this.bodies[0].place(jE,this.origin),this.bodies[1].place(this.relativePose(e.scenario),this.origin)],this.stage.setRadius(this.centreOfB().length()+this.bodies[1].radius+this.bodies[0].radius),this.refreshContacts(t),this.state=t,this.applyState(t),!t.camera&&!this.isInView()&&this.fit(this.fitted===null)}centreOfB(){return new z().setFromMatrixPosition(this.matrices[1])}isShown(e,t,i){let s=(r,o,a)=>o===""||Da(this.bodies[r].mesh,a)?.name===o;return s(0,e.partA,t)&&s(1,e.partB,i)}refreshContacts(e){if(!this.contacts)return;let{pairs:t,points:i,scenario:s}=this.contacts,r=(a,l)=>this.isShown(e,a,l);this.highlights=ty(t,r);let o=[this.bodies[0].corners,this.bodies[1].corners];this.contactsView.show(o,this.highlights,this.matrices),this.contactsView.addPoints(i,So(s.pose_a),this.origin,a=>r(t[3*a],t[3*a+1]))}setState(e){let t=this.state;this.state=e,!(t&&cy(t,e))&&(t&&(t.partA!==e.partA||t.partB!==e.partB)&&this.refreshContacts(e),this.applyState(e))}applyState(e){let[t,i]=this.bodies;t.showAs(e.ghost==="a"?"ghost":"solid"),i.showAs(e.ghost==="b"?"ghost":"solid"),this.bodies.forEach(o=>o.showHeat(e.mode==="heat"));let s=e.clip?"xyz".indexOf(e.clip.axis):0,r=e.clip?[oy(e.clip.axis,e.clip.at-this.origin[s])]:[];this.bodies.forEach(o=>o.clip(r)),this.contactsView.clip(r),this.contactsView.group.visible=e.mode==="contacts",this.contactsView.lines.visible=e.lines,this.mark.show(e.pick&&this.bodies[e.pick.body].corners,e.pick,this.matrices),this.arrange(e)}isShowing(e){return this.state===e}arrange(e){let[t,i]=this.bodies,s={objects:[t.solid,i.solid],forgetsDepth:!1},r={objects:[this.contactsView.group],forgetsDepth:e.throughWalls},o={objects:[t.ghost,i.ghost],forgetsDepth:!1},a={objects:[this.mark.group],forgetsDepth:!0};this.stage.setLayers(e.throughWalls?[s,o,r,a]:[s,r,o,a])}setHeat(e,t){e.forEach((i,s)=>this.bodies[s].setHeat(V0(i,t))),this.stage.draw()}ballAround(){return new Vn(new z,this.bodies[0].radius).union(new Vn(this.centreOfB(),this.bodies[1].radius))}isInView(){let e=this.ballAround(),t=this.fitted;return t!==null&&t.center.distanceTo(e.center)+e.radius<=t.radius*1.001}fit(e){this.fitted=this.ballAround();let t=this.bodies.flatMap((s,r)=>s.boxCorners(this.matrices[r])),i=new Qn().setFromPoints(t.map(s=>new z(...s)));this.stage.fit(i.getCenter(new z).toArray(),t,e)}goToContact(){let e=this.bodies[0].corners,t=new z;for(let l of this.highlights[0].keys())t.add(this.middleOf(e,l));let i=this.highlights[0].size;if(i===0){this.fit(!1);return}t.divideScalar(i);let s=0;for(let l of this.highlights[0].keys())s=Math.max(s,this.middleOf(e,l).distanceTo(t));let r=Math.min(this.bodies[0].radius,this.bodies[1].radius)/12,o=new Vn(t,Math.max(s,r)).getBoundingBox(new Qn),a=[o.min,o.max].flatMap(({x:l,z:c})=>[o.min,o.max].map(({y:u})=>[l,u,c]));this.stage.fit(t.toArray(),a,!1)}middleOf(e,t){let[i,s,r]=[0,3,6].map(o=>new z().fromArray(e,9*t+o));return i.add(s).add(r).divideScalar(3)}get view(){return this.stage.view.map((e,t)=>e+this.origin[t%3])}set view(e){this.stage.view=e.map((t,i)=>t-this.origin[i%3])}pickAt(e,t,i){let s=this.stage.rayAt(e,t),r=[0,1].filter(l=>this.bodies[l].ghost.visible),o=[0,1].filter(l=>this.bodies[l].solid.visible);return i?this.pickAmong(s,r)??this.pickAmong(s,o):(this.state?.throughWalls&&this.state.mode==="contacts"?this.pickAmong(s,[0,1],!0):null)??this.pickAmong(s,o)??this.pickAmong(s,r)}pickAmong(e,t,i=!1){let s=1/0,r=null;for(let o of t){let a=i?[...this.highlights[o].keys()]:null,l=this.hit(e,o,a);l&&l.distance<s&&(s=l.distance,r={body:o,triangle:a?a[l.triangle]:l.triangle})}return r}hit(e,t,i){let s=this.matrices[t].clone().invert(),r=new z(...e.origin).applyMatrix4(s),o=new z(...e.direction).transformDirection(s),a=this.bodies[t].corners;if(i){let f=new Float32Array(9*i.length);i.forEach((h,d)=>f.set(a.subarray(9*h,9*h+9),9*d)),a=f}let l=this.state?.clip,c=l?"xyz".indexOf(l.axis):0,u=l?l.at-this.origin[c]:1/0;return ny(a,{origin:r.toArray(),direction:o.toArray()},f=>e.origin[c]+f*e.direction[c]>u)}get highlighted(){return this.highlights.map(e=>[...e.keys()].sort((t,i)=>t-i))}pixelOf(e){return this.stage.pixelOf(e.map((t,i)=>t-this.origin[i]))}pixelOfWorld(e){let t=this.contacts?.scenario;return this.pixelOf(t?bo(So(t.pose_a),e):e)}dispose(){this.bodies.forEach(e=>e.dispose()),this.contactsView.dispose(),this.mark.dispose(),this.stage.dispose()}};function Il(n){return n.bodies.reduce((e,t)=>e+t.triangles,0)}function uy(n){let[e,t]=Qe({value:null,error:""});return Ye(()=>{let i=!0;return n&&Il(n)<=Na&&X0(n).then(s=>i&&t({value:s,error:""}),s=>i&&t({value:null,error:wn(s)})),()=>{i=!1}},[n?.job]),e}function hy(n,e,t){let[i,s]=Qe({value:null,error:""}),r=on(!1);return Ye(()=>{n&&e&&t&&!r.current&&(r.current=!0,q0(n,e).then(o=>s({value:o,error:o?"":"this job has no heat map"}),o=>s({value:null,error:wn(o)})))},[n,e,t]),i}function dy(n,e){let[t,i]=Qe(null),[s,r]=Qe({scenario:-1,error:""}),o=on(null);return Ye(()=>{if(n)return o.current=new Cc(n.job,i,(a,l)=>r({scenario:a,error:wn(l)})),()=>o.current?.close()},[n?.job]),Ye(()=>o.current?.want(e),[n?.job,e]),{contacts:t,error:s.scenario===e?s.error:""}}function fy(n,e,t,i,s,r){let[o,a]=Qe(null),[l,c]=Qe(""),u=on(0),f=on(-1),h=on(-1),d=on(r);return d.current=r,Ye(()=>{if(!n.current||!e)return;let p=performance.now(),b;try{b=new Bh(n.current,e.meshes,()=>d.current(b.view),()=>{f.current=h.current,u.current===0&&h.current>=0&&(u.current=performance.now()-p)})}catch(g){c(`this browser draws no 3D (WebGL 2): ${wn(g)}. All else on this page works.`);return}a(b);let m=Zl(()=>b.refreshTheme());return()=>{m(),b.dispose()}},[e]),Ye(()=>{o&&t&&(o.show(t,i),h.current=t.scenario.index)},[o,t]),Ye(()=>o?.setState(i),[o,i]),Ye(()=>{o&&s&&o.setHeat(s.counts,s.most)},[o,s]),{viewer:o,error:l,firstFrame:u,drawn:f}}var QE=60,eC=4,kh=Math.PI/24;function tC(n,e){let t=e?.bodies[1]?.size??[0,0,0],i=Math.hypot(t[0],t[1],t[2])/2,s=n?.meshes[0],r=o=>s?[s.min[o]-i,s.max[o]+i]:[-1,1];return{x:r(0),y:r(1),z:r(2)}}function nC(n){let e=on(n);e.current=n,Ye(()=>Ni("viewer",()=>{let{model:t,contacts:i,state:s,drawing:r,scenario:o,canvas:a}=e.current,l=r.viewer,c=a.current?.getBoundingClientRect(),u=([d,p])=>[d+(c?.left??0),p+(c?.top??0)],f=i?.points??new Float64Array,h=Array.from({length:Math.min(8,f.length/4)},(d,p)=>Array.from(f.subarray(4*p+1,4*p+4)));return{ready:l?.isShowing(s)===!0&&r.drawn.current===o,scenario:i?.scenario.index,class:i?.scenario.class,verified:i?.scenario.verified,mode:s.mode,ghost:s.ghost,throughWalls:s.throughWalls,clip:s.clip,camera:l?.view,parts:[s.partA,s.partB],pick:s.pick,trianglesDrawn:l?.bodies.map(d=>d.triangles)??[0,0],highlighted:l?.highlighted??[[],[]],shaChecked:t?.meshes.map(d=>d.checked),meshMilliseconds:t?.milliseconds,firstFrameMilliseconds:r.firstFrame.current,frames:l?.stage.frames,pointPixels:l?h.map(d=>u(l.pixelOfWorld(d))):[]}}),[])}function py({source:n,route:e}){let{value:t,error:i}=Ps(`jobs/${encodeURIComponent(e.job)}`,1,()=>!1),{value:s,error:r}=uy(t),o=ld(se=>s?.meshes[0].parts.some(ce=>ce.name===se)??!0,[s]),[a,l]=Qe(e.scenario),[c,u]=Qe(()=>Ip(e.query,o)),{contacts:f,error:h}=dy(t,a),{value:d,error:p}=hy(t,s,c.mode==="heat"||c.pick!==null&&t?.maps===!0),b=on(null),[m,g]=Qe(!1),[v,C]=Qe(""),[M,I]=Qe(!1),E=ld(se=>u(ce=>({...ce,...se})),[]),x=fy(b,s,f,c,d,se=>E({camera:se})),{viewer:T}=x,V=Jn(()=>tC(s,t),[s,t]);sr(`#${a} ${t?.name??""}`),nC({job:t,model:s,contacts:f,state:c,drawing:x,scenario:a,canvas:b});let U=()=>{T&&c.camera&&(T.view=c.camera)},[D,H]=Qe(0);Ye(()=>{l(e.scenario),u(Ip(e.query,o)),H(se=>se+1)},[e]),Ye(U,[T,D]),Ye(()=>{if(s){let[se,ce]=Pp(e.query,o);E({partA:se,partB:ce})}},[s]),Ye(()=>(Em(On(e.job,a,Pl(c))),Ir),[a,c]);let O=t?t.scenarios-1:0,L=se=>l(Math.min(O,Math.max(0,se)));Ye(()=>{if(!m||f?.scenario.index!==a)return;if(a>=O){g(!1);return}let se=setTimeout(()=>L(a+1),QE);return()=>clearTimeout(se)},[m,f,a]);let X=async se=>{C("");try{let ce=await Q0(e.job,a,se,c);ce===null?C(se>0?"no contact after this scenario":"no contact before this scenario"):($l(On(e.job,a,Pl(c))),Ts(On(e.job,ce,Pl(c))))}catch(ce){C(wn(ce))}},$=()=>{E({camera:null}),T?.fit(!1)},G=()=>{T?.goToContact(),E({camera:T?.view??null})},ue=se=>{if(c.clip){let[ce,Oe]=V[c.clip.axis],Ke=Math.min(Oe,Math.max(ce,c.clip.at+se*(Oe-ce)/100));E({clip:{...c.clip,at:Ke}})}},Z={n:()=>{X(1)},p:()=>{X(-1)},ArrowRight:()=>L(a+1),ArrowLeft:()=>L(a-1)," ":()=>g(!m),h:()=>E({mode:c.mode==="heat"||!t?.maps?"contacts":"heat"}),g:()=>E({ghost:c.ghost==="a"?"b":c.ghost==="b"?"none":"a"}),x:()=>E({throughWalls:!c.throughWalls}),l:()=>E({lines:!c.lines}),s:()=>E({clip:c.clip?null:{axis:"x",at:(V.x[0]+V.x[1])/2}}),"[":()=>ue(-1),"]":()=>ue(1),f:$,c:G,"Shift+ArrowRight":()=>T?.stage.turn(kh,0),"Shift+ArrowLeft":()=>T?.stage.turn(-kh,0),"Shift+ArrowUp":()=>T?.stage.turn(0,kh),"Shift+ArrowDown":()=>T?.stage.turn(0,-kh),"+":()=>T?.stage.approach(.85),"-":()=>T?.stage.approach(1/.85),"?":()=>I(!0)},Q=on(se=>{});Q.current=se=>{let ce=se.shiftKey&&se.key.startsWith("Arrow"),Oe=Z[ce?`Shift+${se.key}`:se.key];Oe&&!U0(se)&&(Oe(),se.preventDefault())},Ye(()=>{let se=ce=>Q.current(ce);return document.addEventListener("keydown",se),()=>document.removeEventListener("keydown",se)},[]);let ie=on([0,0]),pe=se=>{let ce=Math.hypot(se.clientX-ie.current[0],se.clientY-ie.current[1]);if(T&&ce<eC){let Oe=T.pickAt(se.offsetX,se.offsetY,se.shiftKey);u(Ke=>Oe===null&&Ke.pick===null?Ke:{...Ke,pick:Oe})}},fe=async()=>{let se=await T?.stage.picture();if(se){let ce=document.createElement("a");ce.href=URL.createObjectURL(se),ce.download=`${t?.name||e.job}-${a}.png`.replaceAll(/[^\w.-]+/g,"_"),ce.click(),setTimeout(()=>URL.revokeObjectURL(ce.href),1e3)}};if(!t)return i?y(kt,{kind:"bad",children:i}):y("p",{class:"wait",children:["asking for ",e.job,"…"]});let ee=Il(t)>Na,_e=t.folder?va(t.folder):n.kind==="folder"?va(n.name):t.job,xe=r||x.error||h||(c.mode==="heat"?p:"");return y("div",{class:"viewer",children:[y("div",{class:"viewer-head",children:[y("h1",{children:[y("a",{href:er(t.job),children:y(Bt,{text:t.name||t.job})})," ",y("span",{class:"note",children:"›"})," ",y("label",{class:"number",children:["#",y("input",{type:"number","aria-label":"scenario",min:0,max:O,value:a,onChange:se=>L(Math.round(Number(se.currentTarget.value))||0)})]})]}),f&&y(j0,{job:t,contacts:f})]}),y(K0,{model:s,contacts:f}),xe&&y(kt,{kind:"bad",children:xe}),y("div",{class:"scrub",children:[y("button",{type:"button",onClick:()=>{X(-1)},title:"p",children:"‹ previous contact"}),y("button",{type:"button",onClick:()=>{X(1)},title:"n",children:"next contact ›"}),y("input",{type:"range","aria-label":`scenario, 0 to ${O}`,min:0,max:O,value:a,onInput:se=>L(Number(se.currentTarget.value))}),y("button",{type:"button",onClick:()=>g(!m),title:"space","aria-pressed":m,children:m?"stop":"play"}),y(B0,{address:()=>location.href.split("#")[0]+On(e.job,a,Pl(c))}),y("button",{type:"button",onClick:()=>{fe()},disabled:!T,children:"PNG"}),y("button",{type:"button",class:"quiet",onClick:()=>I(!0),title:"keys",children:"?"}),y("span",{class:"note","aria-live":"polite",children:v})]}),y("div",{class:"stage-row",children:[y("div",{class:"stage",children:ee?y("p",{class:"wait",children:[He(Il(t))," triangles: above ",He(Na)," this page does not draw. The exports have it all: ",y("code",{children:["cdctl extract ",_e," ",String(a)," --out case"]})]}):y(Ut,{children:[y("canvas",{ref:b,tabIndex:0,role:"img","aria-label":`scenario ${a}: ${f?.scenario.class??""}, ${f?.scenario.count??0} pairs`,onPointerDown:se=>{ie.current=[se.clientX,se.clientY]},onClick:pe}),!T&&!xe&&y("p",{class:"wait over",children:["reading ",He(Il(t))," triangles…"]}),y("div",{class:"corner",children:[y("span",{class:"swatch a"})," A ",y(Bt,{text:t.bodies[0].name})," ",y("span",{class:"swatch b"})," B ",y(Bt,{text:t.bodies[1].name}),y("span",{class:"note",children:"drawn in single precision"})]})]})}),y("aside",{class:"side",children:[y(F0,{state:c,bounds:V,hasMap:t.maps,change:E,fit:$,goToContact:G}),c.mode==="heat"&&d?y(H0,{heat:d,job:t}):y(G0,{}),c.pick&&s&&y(J0,{pick:c.pick,model:s,contacts:f,heat:d,job:t,drop:()=>E({pick:null})}),f&&s&&y($0,{contacts:f,model:s,state:c,choose:(se,ce)=>E({partA:se,partB:ce})}),f&&T&&y(Z0,{job:t,contacts:f,relative:T.relativePose(f.scenario)}),y("section",{"aria-label":"as a case of its own",children:[y("h2",{children:"as a case of its own"}),y(_c,{text:`cdctl extract ${_e} ${a} --out case`})]})]})]}),M&&y(N0,{close:()=>I(!1)})]})}var my={system:"light",light:"dark",dark:"system"};function iC(){let[n,e]=Qe(Rm());return y("button",{type:"button",class:"quiet",onClick:()=>{Pm(my[n]),e(my[n])},title:"light, dark, or as the system says",children:[{system:"◐",light:"○",dark:"●"}[n]," ",n]})}function gy(n){let{source:e,screen:t}=n,i=e.job===null,s=(r,o,a)=>y("a",{href:`#/${r}`,...a?{"aria-current":"page"}:{},children:o});return y(Ut,{children:[y("header",{class:"bar",children:[y("a",{class:"brand",href:"#/",children:[y("img",{src:"icon.svg",alt:"",width:20,height:20}),"cdcluster"]}),y("nav",{"aria-label":"screens",children:[i&&s("cluster","cluster",t==="cluster"),i&&s("jobs","jobs",t==="jobs"),e.job!==null&&s(`jobs/${e.job}`,"job",t==="job")]}),y("span",{class:"where",title:`${e.program} ${e.name}`,children:[e.kind==="folder"?"folder ":"master ",y(Bt,{text:e.kind==="folder"?ba(e.name):e.name}),e.tls&&" · TLS"]}),y(iC,{})]}),y("main",{children:n.children})]})}function _y(n){return n.job===null?"#/cluster":er(n.job)}function sC({source:n}){let[e,t]=Qe(()=>Yl(location.hash));Ye(()=>{let s=()=>{Ir(),cd(),t(Yl(location.hash))};return addEventListener("hashchange",s),()=>removeEventListener("hashchange",s)},[]),Ye(()=>Ni("route",()=>({screen:e.screen,link:location.hash})),[e]);let i=location.hash.replace(/^#\/?/,"")==="";return Ye(()=>{i&&($l(_y(n)),t(Yl(location.hash)))},[i]),y(gy,{source:n,screen:e.screen,children:e.screen==="none"&&!i?y(kt,{kind:"warn",children:["this address names nothing here; ",y("a",{href:_y(n),children:"go to the start"})]}):y(rC,{source:n,route:e})})}function rC({source:n,route:e}){switch(e.screen){case"cluster":return y(f0,{});case"jobs":return y(h0,{});case"job":return y(D0,{source:n,id:e.job},e.job);case"viewer":return y(py,{source:n,route:e},e.job);default:return null}}function oC(){let[n,e]=Qe(null),[t,i]=Qe("");return Ye(()=>{Qs("source").then(e,s=>i(wn(s)))},[]),n?y(sC,{source:n}):t?y(kt,{kind:"bad",children:t}):null}Am();Im();cd();var xy=document.getElementById("page");xy&&cm(y(oC,{}),xy);
