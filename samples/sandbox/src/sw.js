// The page's files, kept in the browser. offline.plugin.ts writes the build's hash and its files into it.
const cache_name = `islet-${'VERSION'}`;
const files = ['FILES'];
const wasm = /\/(plain|simd)-[^/]*\.wasm$/;

self.addEventListener('install', (event) => {
    event.waitUntil((async () => {
        const cache = await caches.open(cache_name);
        // Of the two builds of the engine the one that this browser runs comes by itself, when it is asked for.
        await cache.addAll(files.filter((file) => !wasm.test(`/${file}`)));
        await self.skipWaiting();
    })());
});

self.addEventListener('activate', (event) => {
    event.waitUntil((async () => {
        for (const name of await caches.keys()) if (name.startsWith('islet-') && name !== cache_name) await caches.delete(name);
        await self.clients.claim();
    })());
});

self.addEventListener('fetch', (event) => {
    const {request} = event;
    if (request.method !== 'GET' || new URL(request.url).origin !== location.origin) return;
    event.respondWith(answer(request));
});

async function answer(request) {
    const cache = await caches.open(cache_name).catch(() => undefined);
    if (cache === undefined) return fetch(request); // the storage is broken or gone
    // The page itself comes from the network where there is one: so a new build is seen at once.
    const page = request.mode === 'navigate';
    const kept = await cache.match(page ? './' : request, {ignoreSearch: page});
    if (kept !== undefined && !page) return kept;
    try {
        const response = await fetch(request);
        if (response.ok && !page) await cache.put(request, response.clone()).catch(() => {}); // if the storage is full, the page needs its network
        return response;
    } catch (error) {
        if (kept !== undefined) return kept;
        throw error;
    }
}
