// Keeps the playground, so that it opens without a network. The build puts in what and under which name.
const NAME = "kurbel-VERSION";
const FILES = "FILES";
const MINE = "kurbel-";

addEventListener("install", event => {
    event.waitUntil(caches.open(NAME).then(cache => cache.addAll(["./", ...FILES])).then(() => skipWaiting()));
});
addEventListener("activate", event => {
    const old = caches.keys().then(names => names.filter(name => name.startsWith(MINE) && name !== NAME));
    event.waitUntil(old.then(names => Promise.all(names.map(name => caches.delete(name)))).then(() => clients.claim()));
});
addEventListener("fetch", event => {
    const { method, url } = event.request;
    if (method === "GET" && url.startsWith(registration.scope)) event.respondWith(kept(event.request));
});

// What is kept; else what is fetched, which is kept from then on.
async function kept(request) {
    const cache = await caches.open(NAME);
    const found = await cache.match(request, { ignoreSearch: true });
    if (found) return found;
    const answer = await fetch(request);
    if (answer.ok) await cache.put(request, answer.clone());
    return answer;
}
