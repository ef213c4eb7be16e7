// How the sandbox shows the world, and other engines beside it: WebGL, the gallery, Box2D in a second pane or over Islet, and the page without a network.
// Environment: CHROMIUM, the browser; SANDBOX, the built folder.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {describe, test} from 'node:test';
import {axeFindings, browser, hideProcessor, server, settle, useBrowser, visit} from './browser.mjs';

const desktop = {viewport: {width: 900, height: 640}};

useBrowser(process.env.SANDBOX);

/// Opens the page at a scene; `use` also gets what it asks for.
async function withPage(scene, {webgl = false, complaintsExpected = /GPU stall due to ReadPixels/, ...options}, use) {
    const asked = [];
    await visit(`${server.address}#${scene}`, {
        options: {...desktop, ...options},
        isKnown: (message) => complaintsExpected.test(message),
        prepare: async (page) => {
            page.on('request', (request) => asked.push(request.url()));
            if (webgl) await page.addInitScript(hideProcessor);
        },
    }, async (page) => {
        await page.waitForFunction(() => Number(document.documentElement.dataset.step) >= 0);
        await use(page, asked);
    });
}

/// What the canvases show one upon the other, eight pixels to one in each direction.
const smallPictureOf = (page) => page.evaluate(() => {
    const all = [...document.querySelectorAll('main canvas:not([hidden])')];
    const width = Math.round(all[0].width / 8), height = Math.round(all[0].height / 8);
    const context = Object.assign(document.createElement('canvas'), {width, height}).getContext('2d', {willReadFrequently: true});
    context.imageSmoothingQuality = 'high';
    for (const canvas of all) context.drawImage(canvas, 0, 0, width, height);
    return [...context.getImageData(0, 0, width, height).data];
});
const difference = (a, b) => a.reduce((sum, value, i) => sum + Math.abs(value - b[i]), 0) / a.length;

describe('the sandbox', {concurrency: 2}, () => {
    test('WebGL draws what canvas 2D draws, also when its context is lost and comes back', async () => {
        // Boxes, discs in a ring, and capsules with hinges, before anything has moved.
        const still = {viewport: {width: 640, height: 480}, reducedMotion: 'reduce', complaintsExpected: /GPU stall due to ReadPixels|CONTEXT_LOST_WEBGL/};
        for (const scene of ['mixer', 'ragdoll']) {
            let plain, bare;
            await withPage(scene, still, async (page) => {
                await settle(page, 2);
                assert.equal(await page.locator('main canvas.below').count(), 0);
                plain = await smallPictureOf(page);
                bare = plain.map((_, i) => plain[i % 4]); // paper alone, as in the corner
            });
            const isLike = (seen, what) => {
                const [off, all] = [difference(seen, plain), difference(bare, plain)];
                // A canvas strokes both sides of a rim, WebGL the inner one: of bodies of 15 pixels that is half a pixel all around.
                assert.ok(off < 0.2 * all, `${scene} ${what} differs by ${off}, from bare paper by ${all}`);
            };
            isLike(plain, 'itself');
            assert.throws(() => isLike(bare, 'nothing'));
            await withPage(scene, {...still, webgl: true}, async (page) => {
                await settle(page, 2);
                assert.equal(await page.locator('main canvas.below').count(), 1);
                isLike(await smallPictureOf(page), 'by WebGL');
                // The canvas above has nothing but the joints that WebGL leaves out: here none.
                assert.ok(await page.evaluate(() => {
                    const canvas = document.getElementById('world');
                    return canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data.every((value) => value === 0);
                }));
                if (scene !== 'ragdoll') return;
                await page.evaluate(() => {
                    const gl = document.querySelector('main canvas.below').getContext('webgl2');
                    window.loss = gl.getExtension('WEBGL_lose_context');
                    window.loss.loseContext();
                });
                await settle(page, 3);
                isLike(await smallPictureOf(page), 'without its context');
                await page.evaluate(() => window.loss.restoreContext());
                await page.waitForFunction(() => !document.querySelector('main canvas.below').getContext('webgl2').isContextLost());
                await settle(page, 3);
                isLike(await smallPictureOf(page), 'with its context again');
                await page.keyboard.press('ArrowRight');
                await page.waitForFunction(() => Number(document.documentElement.dataset.step) === 1);
            });
        }
    });

    test('the gallery has every scene, moves, and is used by keys alone', async () => {
        await withPage('hello', {bypassCSP: true}, async (page) => {
            await page.focus('#gallery');
            await page.keyboard.press('Enter');
            await page.waitForSelector('#gallery-of-scenes[open]');
            const count = await page.locator('.cards button').count();
            assert.equal(count, await page.locator('#scene option').count());
            const first = () => page.evaluate(() => document.querySelector('.cards canvas').toDataURL());
            await page.waitForFunction(() => document.querySelector('.cards canvas').width > 300 || document.querySelector('.cards canvas').width < 299);
            const picture = await first();
            await page.waitForFunction((before) => document.querySelector('.cards canvas').toDataURL() !== before, picture);
            const step = await page.evaluate(() => document.documentElement.dataset.step);

            assert.deepEqual(await axeFindings(page), []);

            // To the end and back: every card gets its world in turn, and the engine has places for all that are seen.
            await page.evaluate(() => document.querySelector('#gallery-of-scenes').scrollTo(0, 1e6));
            await settle(page, 5);
            await page.evaluate(() => document.querySelector('#gallery-of-scenes').scrollTo(0, 0));
            await page.keyboard.press('Tab');
            await page.keyboard.press('Tab');
            assert.equal(await page.evaluate(() => document.documentElement.dataset.step), step, 'the world waits');
            const chosen = (await page.locator('.cards button').nth(1).locator('strong').textContent()).replaceAll(' ', '_');
            await page.keyboard.press('Enter');
            await page.waitForSelector('#gallery-of-scenes:not([open])', {state: 'hidden'});
            assert.equal(await page.evaluate(() => location.hash), `#${chosen}`);
            await page.focus('#gallery');
            await page.keyboard.press('Enter');
            await page.keyboard.press('Escape');
            await page.waitForSelector('#gallery-of-scenes', {state: 'hidden'});
        });
    });

    test('Box2D runs the same scene in a second pane, and is loaded only then', async () => {
        await withPage('chain_ball', {}, async (page, asked) => {
            await page.click('#settings');
            assert.ok(!asked.some((url) => /box2d/i.test(url)), String(asked));
            await page.click('#beside-box2d');
            await page.waitForSelector('#other:visible');
            await page.click('#settings');
            assert.ok(asked.some((url) => /box2d.*wasm/i.test(url)));
            const told = (text) => page.waitForFunction((text) => new RegExp(text).test(document.getElementById('versus').textContent), text);
            await told('Islet \\d.* ms · \\d.* m apart · Box2D \\d.* ms');
            // The rope of a thousand link masses is long in Box2D: its ball is metres from Islet's.
            await page.waitForFunction(() => Number(document.documentElement.dataset.step) > 90);
            await told(' [1-9]\\.\\d+ m apart');
            const seen = await page.evaluate(() => {
                const other = document.getElementById('other');
                return new Set(new Uint32Array(other.getContext('2d').getImageData(0, 0, other.width, other.height).data.buffer)).size;
            });
            assert.ok(seen > 5, 'it is drawn');
            // A picture has both panes.
            await page.click('#settings');
            const [download] = await Promise.all([page.waitForEvent('download'), page.click('#png')]);
            assert.equal(readFileSync(await download.path()).readUInt32BE(16), desktop.viewport.width);
            await page.click('#settings');

            // Cards stand in both, nearly in the same places.
            await page.selectOption('#scene', 'card_house');
            await told(' 0\\.0\\d+ m apart');
            await page.selectOption('#scene', 'gears');
            await told('^Box2D 3 has no gears');
            await page.selectOption('#scene', 'platformer');
            await told('^A script');
            await page.click('#settings');
            await page.click('#beside-box2d');
            await page.waitForSelector('#other', {state: 'hidden'});
        });
    });

    test('Box2D is drawn over Islet, half transparent, by keys alone; Islet is still the one that is played with', async () => {
        await withPage('chain_ball', {reducedMotion: 'reduce'}, async (page) => {
            await page.focus('#settings');
            await page.keyboard.press('Enter');
            const pressed = () => page.evaluate(() => (
                ['beside-box2d', 'over-box2d'].map((id) => document.getElementById(id).getAttribute('aria-pressed')).join()));
            assert.equal(await page.getByRole('button', {name: 'One over the other', pressed: false}).count(), 1);
            await page.focus('#over-box2d');
            await page.keyboard.press('Enter');
            await page.waitForSelector('#other:visible');
            assert.equal(await pressed(), 'false,true');
            await page.click('#settings');
            assert.deepEqual(await page.locator('#other').boundingBox(), await page.locator('#world').boundingBox());

            // What is drawn has one colour, and Islet's bodies shine through. After a second and a half the ropes are metres apart.
            const drawn = () => page.evaluate(() => {
                const other = document.getElementById('other');
                const {data} = other.getContext('2d').getImageData(0, 0, other.width, other.height);
                const wanted = parseInt(getComputedStyle(document.documentElement).getPropertyValue('--over').trim().slice(1), 16);
                let count = 0, solid = 0, off = 0;
                for (let i = 0; i < data.length; i += 4) {
                    if (data[i + 3] < 100) continue; // a hint of a colour has few bits of it
                    count += 1;
                    if (data[i + 3] > 240) solid += 1;
                    for (let k = 0; k < 3; ++k) off = Math.max(off, Math.abs(data[i + k] - (wanted >> (16 - 8 * k) & 255)));
                }
                return {count, solid, off};
            });
            await page.click('#play');
            await page.waitForFunction(() => Number(document.documentElement.dataset.step) > 90);
            await page.click('#play');
            await settle(page);
            const {count, solid, off} = await drawn();
            assert.ok(count > 400 && solid < count / 20 && off < 8, JSON.stringify({count, solid, off}));
            assert.match(await page.locator('#versus').textContent(), /Islet \d.* [\d.]+ m apart · Box2D \d/);

            // A click goes through to Islet's world.
            const bodies = async () => parseInt(await page.locator('#status').textContent(), 10);
            const before = await bodies();
            await page.keyboard.press('2');
            await page.mouse.click(450, 400);
            await settle(page);
            assert.equal(await bodies(), before + 1);

            // From one to the other, and to Islet alone.
            await page.click('#settings');
            await page.click('#beside-box2d');
            assert.equal(await pressed(), 'true,false');
            assert.equal((await page.locator('#other').boundingBox()).width, desktop.viewport.width / 2);
            await page.click('#over-box2d');
            assert.equal((await page.locator('#other').boundingBox()).width, desktop.viewport.width);
            await page.click('#over-box2d');
            assert.equal(await pressed(), 'false,false');
            await page.waitForSelector('#other', {state: 'hidden'});
        });
    });

    test('opens without a network after the first visit', async () => {
        const context = await browser.newContext(desktop);
        const page = await context.newPage();
        const errors = [];
        page.on('pageerror', (error) => errors.push(error.stack));
        await page.goto(`${server.address}#arch`);
        await page.waitForFunction(() => document.documentElement.dataset.offline === 'ready');
        await context.setOffline(true);
        await page.goto(`${server.address}?anything#pyramid`);
        await page.waitForFunction(() => Number(document.documentElement.dataset.step) > 5);
        assert.equal(await page.locator('#scene').inputValue(), 'pyramid');
        assert.deepEqual(errors, []);
        await context.close();
    });

    test('opens with a network where the storage has no room for the engine', async () => {
        const context = await browser.newContext(desktop);
        const page = await context.newPage();
        const errors = [];
        page.on('pageerror', (error) => errors.push(error.stack));
        const session = await context.newCDPSession(page);
        await session.send('Storage.overrideQuotaForOrigin', {origin: new URL(server.address).origin, quotaSize: 1_000_000});
        await page.goto(`${server.address}#arch`);
        await page.waitForFunction(() => navigator.serviceWorker.controller !== null);
        await page.reload();
        await page.waitForFunction(() => Number(document.documentElement.dataset.step) > 5);
        assert.notEqual(await page.evaluate(() => navigator.serviceWorker.controller), null);
        const kept = await page.evaluate(async () => (await (await caches.open((await caches.keys())[0])).keys()).map(({url}) => url));
        assert.ok(kept.length > 0 && !kept.some((url) => url.endsWith('.wasm')), kept.join(' '));
        assert.deepEqual(errors, []);
        await context.close();
    });

    test('opens with a network where the storage breaks after the first visit', async () => {
        const context = await browser.newContext(desktop);
        const page = await context.newPage();
        const errors = [];
        page.on('pageerror', (error) => errors.push(error.stack));
        await page.goto(`${server.address}#arch`);
        await page.waitForFunction(() => document.documentElement.dataset.offline === 'ready');
        const [worker] = context.serviceWorkers();
        await worker.evaluate(() => (caches.open = () => Promise.reject(new DOMException('broken', 'UnknownError'))));
        await page.reload();
        await page.waitForFunction(() => Number(document.documentElement.dataset.step) > 5);
        assert.notEqual(await page.evaluate(() => navigator.serviceWorker.controller), null);
        assert.deepEqual(errors, []);
        await context.close();
    });
});
