"use strict";

// Keeps the site: lessons, pictures and tables with the first visit, other pages as they are read. A new version replaces it.
importScripts("kept.js");
const CACHE = `lightwalk-${VERSION}`;

addEventListener("install", event => event.waitUntil(caches.open(CACHE).then(async cache => {
  for (let i = 0; i < KEPT.length; i += 20) await cache.addAll(KEPT.slice(i, i + 20));
  await skipWaiting();
})));

addEventListener("activate", event => event.waitUntil(caches.keys().then(names =>
  Promise.all(names.filter(name => name.startsWith("lightwalk-") && name !== CACHE).map(name => caches.delete(name)))).then(() => clients.claim())));

addEventListener("fetch", event => {
  if (event.request.method !== "GET" || new URL(event.request.url).origin !== location.origin) return;
  event.respondWith(caches.open(CACHE).then(async cache => {
    const asked = event.request.url.endsWith("/") ? `${event.request.url}index.html` : event.request;
    const known = await cache.match(asked, {ignoreSearch: true});
    if (known) return known;
    const answer = await fetch(event.request);
    if (answer.ok && answer.status === 200) cache.put(asked, answer.clone());
    return answer;
  }));
});
