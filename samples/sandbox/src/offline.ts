// After the first visit the page opens without a network (sw.js).
export async function keepOffline() {
    if (!import.meta.env.PROD || !('serviceWorker' in navigator)) return;
    try {
        const {serviceWorker} = navigator;
        const first = serviceWorker.controller === null;
        const controlled = new Promise((done) => serviceWorker.addEventListener('controllerchange', done, {once: true}));
        await serviceWorker.register('./sw.js', {scope: './'});
        if (first) {
            // What was loaded before there was a worker goes through it once more, now from the browser's own cache.
            await controlled;
            const {name} = performance.getEntriesByType('resource').find((entry) => entry.name.endsWith('.wasm'))!;
            await (await fetch(name, {cache: 'force-cache'})).arrayBuffer();
            if (await caches.match(name) === undefined) return; // the storage is full
        }
        document.documentElement.dataset.offline = 'ready';
    } catch {
        // Where pages may not keep anything, this one needs its network.
    }
}
