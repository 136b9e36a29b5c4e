"use strict";
const key = new URLSearchParams(location.hash.slice(1)).get("key");
fetch("/api/v1/source", key ? { headers: { Authorization: `Bearer ${key}` } } : {})
  .then((answer) => answer.text())
  .then((text) => { document.getElementById("app").textContent = text; });
