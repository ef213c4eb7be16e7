// Plays with the sandbox (samples/sandbox) in a real browser, as a person would, from a server of files on this machine.
// Environment: CHROMIUM, the browser; SANDBOX, the built folder.
import assert from 'node:assert/strict';
import {describe, test} from 'node:test';
import {axeFindings, browser, drawPicture, phone, pictureOf, pixels, server, settle, useBrowser, visit} from './browser.mjs';

const desktop = {viewport: {width: 1280, height: 760}};
const awake = [1, 2, 3, 4, 5, 6].map((kind) => `awake-${kind}`);
const bodies = [...awake, ...[1, 2, 3, 4, 5, 6].map((kind) => `asleep-${kind}`)];

useBrowser(process.env.SANDBOX);

/// Opens the page at a scene.
const withPage = (scene, options, use) => visit(`${server.address}${scene ? `#${scene}` : ''}`, {
    options,
    // Reading what software has drawn is slow, says Chromium; only tests do.
    isKnown: (message) => message.includes('GPU stall due to ReadPixels'),
    prepare: (page) => page.addInitScript(drawPicture),
}, async (page) => {
    await page.waitForFunction(() => Number(document.documentElement.dataset.step) >= 0);
    await use(page);
});

const stepOf = (page) => page.evaluate(() => Number(document.documentElement.dataset.step));
const reach = (page, step) => page.waitForFunction((least) => Number(document.documentElement.dataset.step) >= least, step);
/// Waits while so many seconds of the world pass.
const run = async (page, seconds) => reach(page, (await stepOf(page)) + 60 * seconds);
/// Pauses, if need be, and waits for the picture.
async function pause(page) {
    if ((await page.locator('#play').textContent()) === 'Pause') await page.click('#play');
    await settle(page);
}

/// Waits until the bodies, awake or asleep, are where they should be.
async function become(page, what, isSo) {
    let seen;
    for (let i = 0; i < 60; ++i) {
        seen = await pixels(page, bodies);
        if (isSo(seen)) return seen;
        await run(page, 0.25);
    }
    return assert.fail(`${what}: ${JSON.stringify(seen)}`);
}

// How soon depends on the machine and on what else it does; how much there is to load and to compile does not.
test('opens moving, from few files and bytes, even where the processor is slow', async () => {
    const context = await browser.newContext(desktop);
    context.setDefaultTimeout(120_000); // ms: a busy machine is slow
    const page = await context.newPage();
    await page.addInitScript(drawPicture);
    const session = await context.newCDPSession(page);
    await session.send('Emulation.setCPUThrottlingRate', {rate: 4});
    await page.goto(server.address);
    await reach(page, 3);
    const loaded = await page.evaluate(() => performance.getEntriesByType('resource').map(({name, decodedBodySize: bytes}) => [name, bytes]));
    // The engine is read a second time, from the browser's own cache (offline.ts): that is no other file.
    const files = [...new Map(loaded.reverse())].filter(([name]) => !name.endsWith('icon.svg'));
    assert.deepEqual(files.map(([name]) => name.split('.').pop()).sort(), ['css', 'js', 'wasm']);
    const bytes = files.reduce((sum, [, size]) => sum + size, 0);
    assert.ok(bytes < 2e6, `${bytes} bytes`); // 4 s at 4 Mbit/s, uncompressed
    const picture = await pictureOf(page);
    await settle(page);
    assert.notEqual(await pictureOf(page), picture);
    assert.ok((await pixels(page, awake)).count > 5000);
    await context.close();
});

// They mostly wait for the world.
describe('the sandbox', {concurrency: 2}, () => {
    test('a box is dragged, hangs on the pointer, and falls when let go', async () => {
        await withPage('hello', desktop, async (page) => {
            await reach(page, 150);
            const still = await pixels(page, bodies);
            await page.mouse.move(still.x, still.y);
            await page.mouse.down();
            await page.mouse.move(still.x + 120, still.y - 200, {steps: 10});
            await become(page, 'hangs', ({x, y}) => y < still.y - 120 && x > still.x + 80);
            await run(page, 1); // at rest, or letting go throws it
            await become(page, 'hangs still', ({x, y}) => y < still.y - 120 && x > still.x + 80);
            await page.mouse.up();
            await become(page, 'has fallen', ({y}) => Math.abs(y - still.y) < 6);
        });
    });

    test('rewinds to where it was, and goes on from there', async () => {
        await withPage('hello', desktop, async (page) => {
            await pause(page);
            await page.click('#again');
            await settle(page);
            const start = await pixels(page, awake), first = await pictureOf(page);
            await page.click('#play');
            await reach(page, 60);
            await pause(page);
            const later = await pixels(page, bodies);
            assert.ok(later.y > start.y + 20, JSON.stringify({start, later}));

            await page.locator('#timeline').fill('0');
            await settle(page);
            assert.equal(await stepOf(page), 0);
            assert.equal(await pictureOf(page), first);
            assert.match(await page.locator('#moment').textContent(), /^−1\.\d s · \d+ kB$/);

            await page.click('#play');
            await reach(page, 30);
            await pause(page);
            assert.ok(!(await page.locator('#moment').textContent()).startsWith('−'), 'this is the present now');
            assert.ok((await pixels(page, bodies)).y > start.y + 5);
        });
    });

    test('what was dragged can be undone', async () => {
        await withPage('pyramid', desktop, async (page) => {
            await reach(page, 20);
            await pause(page);
            const stands = await pictureOf(page);
            const step = await stepOf(page);
            const {x, y} = await pixels(page, awake);
            await page.mouse.move(x, y);
            await page.mouse.down();
            await page.mouse.move(x + 300, y - 200, {steps: 5});
            await page.keyboard.press(' ');
            await run(page, 0.8);
            await page.mouse.up();
            await pause(page);
            assert.notEqual(await pictureOf(page), stands);
            // Back by the keyboard until before that.
            for (let i = 0; i < 40 && (await stepOf(page)) > step; ++i) await page.keyboard.press('ArrowLeft');
            await settle(page);
            assert.ok((await stepOf(page)) <= step);
            const again = await pixels(page, awake);
            assert.ok(Math.hypot(again.x - x, again.y - y) < 2, JSON.stringify({again, x, y}));
        });
    });

    test('a ball that is put where a box was taken back looks like a ball', async () => {
        await withPage('hello', desktop, async (page) => {
            await reach(page, 20);
            await pause(page);
            const pictures = [];
            for (const tool of ['2', '3']) {
                await page.keyboard.press('ArrowLeft'); // the box of the first time is gone
                await page.keyboard.press(tool);
                await page.mouse.click(900, 250);
                await settle(page);
                pictures.push(await pictureOf(page));
                await page.keyboard.press('ArrowRight');
            }
            assert.ok(pictures[0] !== pictures[1]);
        });
    });

    test('gravity turns around, and back', async () => {
        await withPage('hello', desktop, async (page) => {
            await reach(page, 150);
            const still = await pixels(page, bodies);
            await page.click('#settings');
            await page.locator('#knob-gravity').fill('-1');
            await become(page, 'rises', ({y}) => y < still.y - 30);
            await page.click('button[aria-label="Reset gravity"]');
            assert.equal(await page.locator('#knob-gravity').inputValue(), '10');
            await become(page, 'has fallen', ({y}) => Math.abs(y - still.y) < 6);
        });
    });

    test('without friction, what stood on a slope slides', async () => {
        await withPage('card_house', desktop, async (page) => {
            await reach(page, 30);
            const stands = await pixels(page, awake);
            await page.click('#settings');
            await page.locator('#knob-friction').fill('0');
            await become(page, 'lies', ({y}) => y > stands.y + 50);
        });
    });

    test('boxes and balls are thrown in, until there is no more room', async () => {
        await withPage('hello', desktop, async (page) => {
            const count = async () => parseInt(await page.locator('#status').textContent(), 10);
            const start = await count();
            await page.click('.tools >> text=Box');
            await page.mouse.click(500, 250);
            await page.keyboard.press('3');
            await page.mouse.click(700, 250);
            await settle(page);
            assert.equal(await count(), start + 2);
            await pause(page);
            await page.evaluate(() => {
                const canvas = document.getElementById('world');
                canvas.setPointerCapture = () => {};
                for (let i = 0; i < 320; ++i) {
                    const where = {pointerId: 9, bubbles: true, clientX: 200 + 8 * (i % 100), clientY: 150 + 20 * Math.floor(i / 100)};
                    canvas.dispatchEvent(new PointerEvent('pointerdown', where));
                    canvas.dispatchEvent(new PointerEvent('pointerup', where));
                }
            });
            await settle(page);
            assert.equal(await count(), start + 300);
            assert.match(await page.locator('#message').textContent(), /Capacity.*bodies/);
        });
    });

    test('keys pause, step and choose', async () => {
        await withPage('pyramid', desktop, async (page) => {
            await page.keyboard.press(' ');
            await settle(page);
            const step = await stepOf(page);
            await page.waitForTimeout(200);
            assert.equal(await stepOf(page), step);
            await page.keyboard.press('ArrowRight');
            await settle(page);
            assert.equal(await stepOf(page), step + 1);
            await page.keyboard.press('2');
            assert.ok(await page.locator('input[value=box]').isChecked());
            await page.keyboard.press('r');
            await settle(page);
            assert.equal(await stepOf(page), 0);
        });
    });

    test('the address names the scene', async () => {
        await withPage('gears', desktop, async (page) => {
            assert.equal(await page.locator('#scene').inputValue(), 'gears');
            await page.selectOption('#scene', 'arch');
            assert.equal(await page.evaluate(() => location.hash), '#arch');
            // What no scene is called is said, and the one that is there goes on.
            for (const name of ['no_such_scene', '%', '%E0%A4%A', '<img src=x>', 'x'.repeat(3000)]) {
                const step = await stepOf(page);
                await page.evaluate((to) => (location.hash = to), name);
                const sentence = `There is no scene “${name.slice(0, 4)}`;
                await page.waitForFunction((start) => document.getElementById('message').textContent.startsWith(start), sentence);
                assert.equal(await page.locator('#scene').inputValue(), 'arch');
                await reach(page, step + 1);
            }
            await page.selectOption('#scene', 'platformer');
            await settle(page);
            assert.ok(await page.locator('#timeline').isDisabled(), 'a script does not go back');
            assert.equal(await page.locator('#moment').textContent(), 'has a script');
        });
    });

    test('every scene has its golden hash in this browser', async () => {
        await withPage('hello', desktop, async (page) => {
            await pause(page);
            await page.click('#settings');
            await page.click('#prove');
            await page.waitForFunction(() => document.getElementById('proof').className !== '');
            assert.equal(await page.locator('#proof').textContent(), '✓ hello after 60 steps: 0d75a134d5c0755c, as everywhere');
            await page.click('#prove-all');
            await page.waitForFunction(() => document.getElementById('proof').className !== '', undefined, {timeout: 120000});
            assert.match(await page.locator('#proof').textContent(), /^✓ all \d\d scenes/);
        });
    });

    test('fits a phone, lying or standing, and fingers work', async () => {
        for (const viewport of [phone.viewport, {width: 844, height: 390}, {width: 320, height: 568}]) {
            await withPage('hello', {...phone, viewport}, async (page) => {
                await reach(page, 150);
                assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), viewport.width);
                for (const button of await page.locator('header button, footer button, footer .tools span').all()) {
                    const box = await button.boundingBox();
                    assert.ok(box.x >= 0 && box.x + box.width <= viewport.width && box.y + box.height <= viewport.height, JSON.stringify(box));
                    assert.ok(box.width >= 32 && box.height >= 32, `large enough for a finger: ${JSON.stringify(box)}`);
                }
                const still = await pixels(page, bodies);
                const footer = await page.locator('footer').boundingBox();
                assert.ok(still.count > 30 && still.y < footer.y, JSON.stringify(still));
                const session = await page.context().newCDPSession(page);
                const touch = (type, x, y) => session.send('Input.dispatchTouchEvent', {type, touchPoints: type === 'touchEnd' ? [] : [{x, y}]});
                await touch('touchStart', still.x, still.y);
                for (let i = 1; i <= 5; ++i) await touch('touchMove', still.x, still.y - 12 * i);
                await become(page, 'hangs', ({y}) => y < still.y - 20);
                await run(page, 0.5); // at rest, or a browser takes the next tap for the end of a fling
                await touch('touchEnd');
                await page.tap('#play');
                await page.waitForFunction(() => document.getElementById('play').textContent === 'Play', undefined, {timeout: 5000});
            });
        }
    });

    test('everyone can use its controls, as far as axe can tell', async () => {
        for (const colorScheme of ['light', 'dark']) {
            const context = await browser.newContext({...desktop, colorScheme, bypassCSP: true});
            const page = await context.newPage();
            await page.goto(server.address);
            await page.click('#settings');
            assert.deepEqual(await axeFindings(page), []);
            await context.close();
        }
    });

    test('says what is missing where the engine cannot start, and nothing else fails then', async () => {
        const noWebAssembly = () => delete globalThis.WebAssembly;
        for (const [init, blocked, sentence] of [
            [noWebAssembly, undefined, /^The engine did not start\. There is no WebAssembly here, which the engine needs\.$/],
            [() => {}, /\.wasm$/, /^The engine did not start\. .*\.wasm cannot be loaded: is there a network\?$/],
        ]) {
            const context = await browser.newContext(desktop);
            const page = await context.newPage();
            const errors = [];
            page.on('pageerror', (error) => errors.push(error.stack));
            await page.addInitScript(init);
            if (blocked) await context.route(blocked, (route) => route.abort());
            await page.goto(server.address);
            await page.waitForSelector('#message:visible');
            assert.match(await page.locator('#message').textContent(), sentence);
            for (const key of ['r', ' ', 'ArrowRight', 'ArrowLeft', '2', 'Enter', '0', 'Tab', 'Enter']) await page.keyboard.press(key);
            await page.mouse.click(500, 300);
            for (const id of ['gallery', 'again']) {
                const {x, y} = await page.locator(`#${id}`).boundingBox();
                await page.mouse.click(x + 9, y + 9);
            }
            await page.evaluate(() => (location.hash = 'car'));
            await settle(page);
            assert.match(await page.locator('#message').textContent(), sentence);
            assert.deepEqual(errors, []);
            await context.close();
        }
    });

    test('is dark where the system is, and still where motion is not wanted', async () => {
        for (const colorScheme of ['light', 'dark']) {
            await withPage('hello', {...desktop, colorScheme, reducedMotion: 'reduce'}, async (page) => {
                await settle(page);
                const paper = await page.evaluate(() => [...picture().getContext('2d').getImageData(3, 300, 1, 1).data]);
                assert.ok(colorScheme === 'dark' ? paper[0] < 60 : paper[0] > 200, String(paper));
                await page.waitForTimeout(200);
                assert.equal(await stepOf(page), 0);
            });
        }
    });
});
