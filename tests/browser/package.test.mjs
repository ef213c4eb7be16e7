// The package @islet/engine in a real browser, without a bundler: as files, in one file, and in a worker. Environment: CHROMIUM, the browser.
import assert from 'node:assert/strict';
import {fileURLToPath} from 'node:url';
import {test} from 'node:test';
import {browser, server, useBrowser} from './browser.mjs';

useBrowser(fileURLToPath(new URL('../../bindings/js', import.meta.url)));

/// As samples/scenes/flight.cpp makes it: the hash after a second, or what went wrong.
const hello = `async (file, options) => {
    const {load, createWorld, makeBox} = await import(file);
    await load(options);
    const world = await createWorld();
    world.createPolygon(world.createBody(), makeBox(20, 1));
    world.createPolygon(world.createBody({type: 'dynamic', position: {x: 0, y: 8}}), makeBox(0.5, 0.5));
    for (let i = 0; i < 60; ++i) world.step(1 / 60);
    return world.hash().toString(16).padStart(16, '0');
}`;

test('runs in pages and workers, with the golden hash', async () => {
    const page = await browser.newPage();
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(error.stack));
    for (const file of ['index.js', 'inline.js']) {
        for (const simd of [true, false]) {
            await page.goto(`${server.address}package.json`);
            const address = `${server.address}dist/${file}`;
            const hash = await page.evaluate(`(${hello})('${address}', {simd: ${simd}})`);
            assert.equal(hash, '0d75a134d5c0755c', `${file}, SIMD ${simd}`);
        }
    }
    const inWorker = await page.evaluate(`new Promise((done, failed) => {
        const text = ${JSON.stringify(`(${hello})('${server.address}dist/index.js').then(postMessage)`)};
        const worker = new Worker(URL.createObjectURL(new Blob([text], {type: 'text/javascript'})), {type: 'module'});
        worker.onmessage = ({data}) => done(data);
        worker.onerror = failed;
    })`);
    assert.equal(inWorker, '0d75a134d5c0755c');
    assert.deepEqual(complaints, []);
});
