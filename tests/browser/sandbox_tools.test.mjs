// The sandbox's tools, controls, settings and files, used in a real browser as a person would. Time in the page is the test's: it goes as fast as it can.
// Environment: CHROMIUM, the browser; SANDBOX, the built folder; ISLET, the program, for recordings (without it, that test is left out).
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {describe, test} from 'node:test';
import {setTimeout as sleep} from 'node:timers/promises';
import {fileURLToPath} from 'node:url';
import {axeFindings, phone, server, temporaryFolder, useBrowser, visit} from './browser.mjs';

const root = fileURLToPath(new URL('../..', import.meta.url));
const desktop = {viewport: {width: 1000, height: 640}};
const swing = readFileSync(join(root, 'samples/scenes/swing.json'), 'utf8');
const folder = temporaryFolder('sandbox');
const patience = 120_000; // ms, with a busy machine

useBrowser(process.env.SANDBOX);

/// Opens the page at a scene.
const withPage = (scene, use, {init, ...options} = desktop) => visit(`${server.address}#${scene}`, {
    options,
    mayAsk: (url) => /^(blob:)?http:\/\/127/.test(url),
    prepare: async (page) => {
        // Time stands still from the start: how long the page takes to load changes nothing in it.
        await page.clock.install({time: 0});
        await page.clock.pauseAt(60_000);
        // Five or six steps a picture: drawing takes most of the time.
        await page.addInitScript(() => (window.requestAnimationFrame = (draw) => setTimeout(() => draw(performance.now()), 96)));
        if (init) await page.addInitScript(init);
    },
}, async (page) => {
    await begin(page);
    await use(page);
});

/// Waits for the first picture. Time in the page passes in run() alone.
const begin = (page) => until(page, () => page.evaluate(() => Number(document.documentElement.dataset.step) >= 0), () => run(page, 0.1));
/// Waits for what the browser does by itself: reading files, packing. `meanwhile` runs before each look; time in the page stands still without it.
async function until(page, isSo, meanwhile = () => {}) {
    for (const end = Date.now() + patience; ;) {
        await meanwhile();
        if (await isSo()) return;
        assert.ok(Date.now() < end, 'it never came to be');
        await sleep(10);
    }
}
const run = (page, seconds) => page.clock.runFor(Math.round(1000 * seconds));
const message = (page) => page.locator('#message').textContent();
/// After this, a message is a new one.
async function messageGoes(page) {
    await run(page, 5.1);
    assert.equal(await message(page), '');
}
const openPanel = async (page) => (await page.locator('#panel').isHidden()) && page.click('#settings');
async function downloaded(page, id) {
    await openPanel(page);
    const [download] = await Promise.all([page.waitForEvent('download'), page.click(id).then(() => run(page, 0.1))]);
    const path = join(folder, `${Math.random()}-${download.suggestedFilename()}`);
    await download.saveAs(path);
    return {path, name: download.suggestedFilename(), bytes: readFileSync(path)};
}
/// The world as it is, by the page's own file of it.
const worldOf = async (page) => JSON.parse((await downloaded(page, '#save')).bytes);
async function openText(page, text) {
    await openPanel(page);
    const before = await page.evaluate(() => document.documentElement.dataset.opened);
    await page.locator('#open-file').setInputFiles({name: 'scene.json', mimeType: 'application/json', buffer: Buffer.from(text)});
    await until(page, () => page.evaluate((before) => document.documentElement.dataset.opened !== before, before));
}
/// Where a body is, as the page says.
async function placeOf(page, slot) {
    await page.locator('#body-number').fill(String(slot));
    await page.locator('#body-number').blur();
    await run(page, 0.1);
    return placeSeen(page);
}
/// The same for the body that was asked for before.
async function placeSeen(page) {
    const [, x, y] = /at (-?[\d.]+), (-?[\d.]+) m/.exec(await page.locator('#body-numbers').textContent());
    return {x: Number(x), y: Number(y)};
}

describe('the tools', () => {
    test('a swipe cuts the joints that it crosses, and enter the one in the middle', async () => {
        await withPage('hello', async (page) => {
            await openText(page, swing);
            assert.equal((await worldOf(page)).joints.length, 3);
            await page.click('#settings');
            await page.keyboard.press('7');
            await page.focus('input[value=cut]');
            await page.keyboard.press('Enter');
            await run(page, 0.1);
            assert.equal((await worldOf(page)).joints.length, 2);
            await page.click('#settings');
            for (const [from, to] of [[[500, 80], [500, 500]], ...[200, 260, 320, 380].map((y) => [[100, y], [900, y]])]) {
                await page.mouse.move(...from);
                await page.mouse.down();
                await page.mouse.move(...to, {steps: 4});
                await page.mouse.up();
            }
            assert.equal((await worldOf(page)).joints, undefined);
        });
    });

    test('what is drawn becomes one body of convex pieces, which falls; a crossing line is closed where it crosses', async () => {
        await withPage('hello', async (page) => {
            const start = await worldOf(page);
            await page.click('#settings');
            await page.keyboard.press('6');
            const draw = async (points) => {
                await page.mouse.move(...points[0]);
                await page.mouse.down();
                for (const point of points.slice(1)) await page.mouse.move(...point, {steps: 5});
                await page.mouse.up();
            };
            await draw([[500, 120], [700, 120], [700, 170], [560, 170], [560, 260], [500, 260], [500, 122]]); // an L
            await draw([[760, 200], [860, 120], [960, 200], [750, 190], [740, 120]]); // a triangle with tails
            const drawn = await worldOf(page);
            assert.equal(drawn.bodies.length, start.bodies.length + 2);
            const [l, triangle] = drawn.bodies.slice(-2);
            assert.ok(l.shapes.length >= 2, 'an L is not convex');
            assert.equal(triangle.shapes.length, 1);
            for (const {polygon} of [...l.shapes, ...triangle.shapes]) assert.ok(polygon.points.length <= 8);
            await run(page, 1);
            assert.ok((await worldOf(page)).bodies.at(-2).position[1] < l.position[1] - 0.5);
            await page.click('#settings');
            await draw([[600, 150], [604, 150]]);
            assert.match(await message(page), /Draw an outline/);
        });
    });

    test('ragdolls and cars are put in; the arrows drive the car', async () => {
        await withPage('hello', async (page) => {
            const start = await worldOf(page);
            await page.click('#settings');
            await page.keyboard.press('4');
            await page.mouse.click(300, 300);
            await page.keyboard.press('5');
            await page.mouse.click(620, 300);
            await run(page, 1);
            const put = await worldOf(page);
            assert.equal(put.bodies.length, start.bodies.length + 11 + 3);
            assert.equal(put.joints.length, 10 + 2);
            const car = put.bodies.length - 3;
            const before = await placeOf(page, car);
            await page.keyboard.down('ArrowRight');
            await run(page, 1);
            await page.keyboard.up('ArrowRight');
            const there = await placeOf(page, car);
            assert.ok(there.x > before.x + 1, JSON.stringify({before, there}));
        });
    });
});

describe('keys and touch play', () => {
    test('the character, from the start to the flag', async () => {
        await withPage('platformer', async (page) => {
            await openPanel(page);
            const bodies = (await worldOf(page)).bodies;
            const hero = bodies.length - 1, [ferry] = bodies.flatMap(({type}, i) => (type === 'kinematic' ? [i] : []));
            const held = new Set();
            const hold = async (...keys) => {
                for (const key of held) if (!keys.includes(key)) await page.keyboard.up(key);
                for (const key of keys) if (!held.has(key)) await page.keyboard.down(key);
                held.clear();
                for (const key of keys) held.add(key);
            };
            const see = async (place, isSo, what) => {
                for (let i = 0; i < 200; ++i) {
                    const {x, y} = await placeOf(page, place);
                    if (isSo(x, y)) return;
                    await page.locator('#body-number').blur();
                    }
                assert.fail(what);
            };
            const walk = async (key, isSo, what) => {
                await hold(key);
                await see(hero, isSo, what);
            };
            await walk('ArrowRight', (x) => x > -2.9, 'over the hill');
            await hold();
            await see(ferry, (x) => x < -0.7, 'the ferry comes');
            await walk('ArrowRight', (x) => x > -1.2, 'on to the ferry');
            await hold();
            await see(ferry, (x) => x > 4.8, 'the ferry is over');
            await walk('ArrowRight', (x) => x > 6, 'off it');
            await hold('ArrowRight', 'ArrowUp');
            await see(hero, (x) => x > 19.5, 'over the crate and its hole, and by the platforms');
            await hold();
            await walk('d', (x) => x > 27, 'over the beam');
            await hold();
            await run(page, 0.2);
            assert.match(await message(page), /You got to the flag in \d+\.\d s/);
        }, {viewport: {width: 480, height: 500}}); // small pictures are drawn sooner
    });

    test('the pinball table: the plunger shoots, and the flippers go up', async () => {
        await withPage('pinball', async (page) => {
            await openPanel(page);
            const bodies = (await worldOf(page)).bodies;
            const ball = bodies.findIndex(({bullet}) => bullet);
            const flipper = 1;
            await page.keyboard.down('ArrowDown');
            await run(page, 1);
            await page.keyboard.up('ArrowDown');
            await run(page, 0.7);
            assert.ok((await placeOf(page, ball)).y > 4, 'the ball was shot');
            const angle = async () => (await worldOf(page)).bodies[flipper].angle ?? 0;
            const down = await angle();
            await page.keyboard.down('ArrowLeft');
            await run(page, 0.3);
            assert.ok((await angle()) > down + 0.5);
            await page.keyboard.up('ArrowLeft');
        });
    });

    test('the car, by a finger on a phone, and only there with buttons', async () => {
        await withPage('car', async (page) => {
            const forward = page.locator('#controls button[aria-label=forward]');
            const box = await forward.boundingBox();
            assert.ok(box.width >= 44 && box.x >= 0 && box.x + box.width <= 390, JSON.stringify(box));
            const carX = async () => (await worldOf(page)).bodies[1].position[0];
            const before = await carX();
            const [panel, footer] = await Promise.all(['#panel', 'footer'].map((part) => page.locator(part).boundingBox()));
            assert.ok(panel.y + panel.height <= footer.y, JSON.stringify({panel, footer}));
            assert.ok(await page.locator('#controls').isHidden(), 'no button lies on the settings');
            await page.click('#settings');
            const session = await page.context().newCDPSession(page);
            await session.send('Input.dispatchTouchEvent', {type: 'touchStart', touchPoints: [{x: box.x + 30, y: box.y + 30}]});
            await run(page, 2);
            await session.send('Input.dispatchTouchEvent', {type: 'touchEnd', touchPoints: []});
            assert.ok((await carX()) > before + 2);
        }, phone);
        await withPage('car', async (page) => assert.ok(await page.locator('#controls').isHidden()));
    });
});

/// Pixels of the overlay that are not clear.
const overlaid = (page) => page.evaluate(() => {
    const canvas = document.getElementById('overlay');
    const copy = new OffscreenCanvas(canvas.width, canvas.height).getContext('2d', {willReadFrequently: true});
    copy.drawImage(canvas, 0, 0);
    const {data} = copy.getImageData(0, 0, canvas.width, canvas.height);
    let count = 0;
    for (let i = 3; i < data.length; i += 4) if (data[i] > 0) ++count;
    return count;
});

describe('settings and sights', () => {
    test('every setting of the solver has a control, its comment, and a reset', async () => {
        const api = JSON.parse(readFileSync(join(root, 'bindings/api.json'), 'utf8'));
        const camel = (name) => name.replace(/_([a-z])/g, (_, letter) => letter.toUpperCase());
        await withPage('pyramid', async (page) => {
            await openPanel(page);
            await page.click('summary');
            for (const {name, doc} of api.structs.find((one) => one.name === 'SolverDef').fields) {
                const input = page.locator(`#solver-${camel(name)}, #knob-${name}`);
                assert.equal(await input.count(), 1, name);
                if (doc && !['substeps', 'iterations'].includes(name)) {
                    assert.equal(await page.locator(`#about-${camel(name)}`).textContent(), doc);
                }
            }
            const omega = page.locator('#solver-omega'), reset = page.locator('button[aria-label="Reset omega"]');
            assert.ok(await reset.isDisabled());
            await omega.fill('1.3');
            await omega.blur();
            await page.selectOption('#solver-sweepOrder', 'upward');
            assert.deepEqual((await worldOf(page)).world.solver, {omega: 1.3, sweep_order: 'upward'});
            await omega.fill('5');
            await omega.blur();
            assert.equal(await omega.inputValue(), '1.3', 'what the engine refuses does not stand there');
            assert.match(await message(page), /\w+/);
            await reset.click();
            await page.click('button[aria-label="Reset sweep order"]');
            assert.equal((await worldOf(page)).world?.solver, undefined);
            await page.locator('#knob-iterations').fill('8');
            await page.locator('#knob-restitution').fill('0.5');
            const {world, bodies} = await worldOf(page);
            assert.equal(world.solver.iterations, 8);
            assert.ok(bodies.every(({shapes}) => shapes.every(({restitution}) => restitution === 0.5)));
        });
    });

    test('each sight draws something, and a body tells its numbers', async () => {
        await withPage('chain_ball', async (page) => {
            await openPanel(page);
            await run(page, 1);
            assert.ok(await page.locator('#overlay').isHidden());
            for (const id of ['islands', 'colours', 'forces', 'boxes', 'heat']) {
                await page.check(`#see-${id}`);
                await run(page, 0.1);
                assert.ok((await overlaid(page)) > 50, id);
                await page.uncheck(`#see-${id}`);
            }
            await page.check('#see-graph');
            await run(page, 0.5);
            assert.match(await page.locator('#graph').innerText(), /energy -?[\d.e+]+ J\s+residual [\d.e-]+ m\/s\s+step [\d.e-]+ ms/);
            await page.locator('#body-number').fill('1');
            await run(page, 0.1);
            assert.match(await page.locator('#body-numbers').innerText(), /body 1, dynamic\n[\d.e+]+ kg\nat .* m, .*°\n.* m\/s, .* rad\/s\nresidual .* m\/s/);
        });
        await withPage('hello', async (page) => {
            await openPanel(page);
            await run(page, 1);
            await page.check('#see-impulses');
            await run(page, 0.5);
            assert.ok((await overlaid(page)) > 50, 'impulses');
            await page.uncheck('#see-impulses');
            await page.check('#see-sleeping');
            await run(page, 0.1);
            assert.equal(await overlaid(page), 0);
            await run(page, 3);
            assert.ok((await overlaid(page)) > 20, 'sleeping');
        });
        await withPage('bullets', async (page) => {
            await openPanel(page);
            await page.check('#see-stops');
            await until(page, async () => (await overlaid(page)) > 50, () => run(page, 0.1));
        });
    });
});

test('everyone can use the settings, sights and buttons, as far as axe can tell', async () => {
    for (const options of [{...desktop, colorScheme: 'light'}, {...phone, colorScheme: 'dark'}]) {
        await withPage('car', async (page) => {
            await page.clock.resume();
            assert.deepEqual(await axeFindings(page), []);
            await openPanel(page);
            await page.click('summary');
            await page.check('#see-graph');
            await page.locator('#body-number').fill('1');
            assert.deepEqual(await axeFindings(page), []);
        }, {...options, bypassCSP: true});
    }
});

describe('files', () => {
    test('a scene is saved, opened again, and shared in the address', async () => {
        await withPage('hello', async (page) => {
            await openText(page, swing);
            assert.equal(await page.evaluate(() => document.documentElement.dataset.scene), 'swing');
            await run(page, 1);
            await page.click('#play');
            const {bytes} = await downloaded(page, '#save');
            await page.click('#share');
            await until(page, () => page.evaluate(() => location.hash.startsWith('#scene=')));
            const address = await page.evaluate(() => location.href);
            const other = await page.context().newPage();
            await other.addInitScript(() => (matchMedia = () => ({matches: true, addEventListener() {}}))); // it waits
            await other.goto(address);
            await begin(other);
            const round = (key, value) => (typeof value === 'number' ? Number(value.toFixed(5)) : value);
            const same = (text) => JSON.parse(JSON.stringify(JSON.parse(text), round));
            assert.deepEqual(same((await downloaded(other, '#save')).bytes), same(bytes));
            assert.ok(address.length < 2500, String(address.length));
        });
    });

    test('a recording is downloaded, and islet replay comes to the same hash', {skip: !process.env.ISLET && 'ISLET names no program'}, async () => {
        await withPage('hello', async (page) => {
            await openPanel(page);
            await page.click('#again');
            await page.click('#record');
            await run(page, 1);
            await page.click('#settings');
            await page.keyboard.press('3');
            await page.mouse.click(600, 200);
            await run(page, 1);
            const recording = await downloaded(page, '#record');
            assert.equal(recording.name, 'hello.rec');
            const [hash] = /[0-9a-f]{16}/.exec(await page.locator('#link').textContent());
            const said = execFileSync(process.env.ISLET, ['replay', recording.path], {encoding: 'utf8'});
            assert.ok(said.includes(hash), `${said} has not ${hash}`);
        });
    });

    test('pictures and a clip', async () => {
        await withPage('hello', async (page) => {
            await run(page, 0.5);
            const png = await downloaded(page, '#png');
            assert.deepEqual([...png.bytes.subarray(0, 4)], [0x89, 0x50, 0x4e, 0x47]);
            assert.ok(png.bytes.length > 3000);
            const svg = (await downloaded(page, '#svg')).bytes.toString();
            assert.match(svg, /<polygon points="[-\d., ]+"/);
            assert.equal(await page.evaluate((text) => new DOMParser().parseFromString(text, 'image/svg+xml').querySelectorAll('parsererror').length, svg), 0);
            await page.click('#clip');
            await run(page, 0.3);
            const clip = await downloaded(page, '#clip');
            assert.match(clip.name, /^hello\.(webm|mp4)$/);
        });
    });

    test('what is no sound scene is refused with a sentence, and nothing is lost', async () => {
        const nested = '['.repeat(200000);
        const files = [
            ['', /cannot be read\. line 1, column 1: here it ceases to be JSON/],
            ['{"bodies": [', /ceases to be JSON/],
            ['<html>', /ceases to be JSON/],
            [nested, /cannot be read|too large/],
            ['{"bodies": [{"typ": "dynamic"}]}', /bodies\[0\]\.typ: there is no such field; near names: type/],
            ['{"bodies": [{"position": [NaN, 0]}]}', /ceases to be JSON/],
            ['{"bodies": [{"position": [1e999, 0]}]}', /too large/],
            ['{"bodies": [{"position": [1e30, 0]}]}', /bodies\[0\]/],
            ['{"format": 2}', /format 2/],
            ['{"name": "a", "name": "b"}', /two such fields/],
            ['{"bodies": [{"shapes": [{"box": [0, 1]}]}]}', /no sound geometry/],
            ['{"joints": [{"type": "weld", "body_a": 0, "body_b": 9}]}', /there is no body 0/],
            ['{"world": {"solver": {"substeps": 100000}}}', /substeps/],
            [`{"extra_contacts": 1900000, "bodies": [${'{"shapes": [{"box": [1, 1]}]},'.repeat(30000)}{}]}`, /too large for this page/],
        ];
        await withPage('hello', async (page) => {
            for (const [text, sentence] of files) {
                await openText(page, text);
                assert.match(await message(page), sentence, text.slice(0, 60));
                assert.equal(await page.evaluate(() => document.documentElement.dataset.scene), 'hello');
            }
            await page.evaluate(() => {
                const bytes = new Uint8Array(17e6);
                const list = new DataTransfer();
                list.items.add(new File([bytes], 'zeros.json'));
                const input = document.getElementById('open-file');
                input.files = list.files;
                input.dispatchEvent(new Event('change'));
            });
            assert.match(await message(page), /zeros\.json is too large: it has 17 MB, and 16 MB are read/);
            for (const [hash, sentence] of [
                ['scene=', /The address holds no scene|ceases to be JSON/],
                ['scene=%%%', /The address holds no scene/],
                ['scene=AAAA', /The address holds no scene/],
                [`scene=${'A'.repeat(100001)}`, /The scene in the address is too large: 100 kB/],
            ]) {
                await messageGoes(page);
                await page.evaluate((to) => (location.hash = to), hash);
                await until(page, async () => sentence.test(await message(page)));
                assert.equal(await page.evaluate(() => document.documentElement.dataset.scene), 'hello');
            }
            // 20 MB of spaces are a few kB.
            const bomb = await page.evaluate(async () => {
                const stream = new Blob([' '.repeat(20e6)]).stream().pipeThrough(new CompressionStream('deflate-raw'));
                const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
                return btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join('')).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
            });
            // Who asks for something else while an address is unpacked hears no more of that address.
            await page.evaluate(async (to) => {
                const heard = new Promise((done) => addEventListener('hashchange', done, {once: true}));
                location.hash = `scene=${to}`;
                await heard;
                location.hash = 'car';
            }, bomb);
            await until(page, () => page.evaluate(() => document.documentElement.dataset.scene === 'car'));
            await sleep(500);
            assert.equal(await message(page), '');
            await run(page, 0.1);
            await page.evaluate((to) => (location.hash = `scene=${to}`), bomb);
            await until(page, async () => /unpacks to more than 16 MB/.test(await message(page)));
            const step = await page.evaluate(() => Number(document.documentElement.dataset.step));
            await run(page, 0.2);
            assert.ok((await page.evaluate(() => Number(document.documentElement.dataset.step))) > step, 'the world goes on');
        });
        // With nothing there yet, the first scene is played.
        await withPage('scene=AAAA', async (page) => {
            await until(page, async () => /The address holds no scene/.test(await message(page)));
            assert.equal(await page.evaluate(() => document.documentElement.dataset.scene), 'mixer');
        });
    });

    test('a file that cannot be read, a scene of a long name, and addresses that the browser refuses', async () => {
        await withPage('hello', async (page) => {
            await page.evaluate(() => {
                const file = new File(['{}'], 'gone.json');
                file.text = () => Promise.reject(new DOMException('it was removed', 'NotFoundError'));
                dispatchEvent(Object.assign(new Event('drop'), {dataTransfer: {files: [file]}}));
            });
            await until(page, async () => /^gone\.json cannot be read/.test(await message(page)));
            await openText(page, JSON.stringify({name: `${'long '.repeat(1e5)}`}));
            assert.match((await downloaded(page, '#save')).name, /^(long_){12}\.json$/);
            await page.evaluate(() => {
                history.replaceState = () => {
                    throw new DOMException('too many', 'SecurityError');
                };
                navigator.clipboard.writeText = () => {
                    throw new DOMException('not here', 'NotAllowedError');
                };
            });
            await page.selectOption('#scene', 'car');
            assert.equal(await page.evaluate(() => document.documentElement.dataset.scene), 'car');
            await page.click('#share');
            await until(page, async () => /takes no new address now/.test(await message(page)));
        });
    });

    test('where the browser cannot pack and unpack, addresses with scenes are refused with a sentence', async () => {
        await withPage('scene=AAAA', async (page) => {
            await until(page, async () => /This browser cannot unpack/.test(await message(page)));
            assert.equal(await page.evaluate(() => document.documentElement.dataset.scene), 'mixer');
            await openPanel(page);
            await page.click('#share');
            await until(page, async () => /This browser cannot pack/.test(await message(page)));
        }, {...desktop, init: () => {
            delete globalThis.CompressionStream;
            delete globalThis.DecompressionStream;
        }});
    });

    test('plays without SIMD, with the same bits', async () => {
        await withPage('hello', async (page) => {
            await openPanel(page);
            await page.click('#prove');
            for (let i = 0; i < 20 && !(await page.locator('#proof').getAttribute('class')); ++i) await run(page, 0.1);
            assert.equal(await page.locator('#proof').textContent(), '✓ hello after 60 steps: 0d75a134d5c0755c, as everywhere');
        }, {...desktop, init: () => (WebAssembly.validate = () => false)});
    });
});

describe('memory', () => {
    test('stays the same while someone plays at random', async () => {
        await withPage('hello', async (page) => {
            const session = await page.context().newCDPSession(page);
            const measure = async () => {
                await session.send('HeapProfiler.collectGarbage');
                await session.send('HeapProfiler.collectGarbage');
                const {result: {objectId: prototypeObjectId}} = await session.send('Runtime.evaluate', {expression: 'WebAssembly.Memory.prototype'});
                const {objects} = await session.send('Runtime.queryObjects', {prototypeObjectId});
                const {result} = await session.send('Runtime.callFunctionOn', {
                    objectId: objects.objectId, functionDeclaration: 'function() { return this.map((memory) => memory.buffer.byteLength); }', returnByValue: true});
                const {usedSize} = await session.send('Runtime.getHeapUsage');
                return {wasm: result.value.reduce((sum, bytes) => sum + bytes, 0), heap: usedSize};
            };
            let seed = 1;
            const random = (below) => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0) / 2 ** 32 * below | 0;
            const round = async () => {
                seed = 7;
                for (const scene of ['hello', 'car', 'pyramid', 'gears']) {
                    await page.selectOption('#scene', scene);
                    for (let i = 0; i < 6; ++i) {
                        await page.keyboard.press(String(2 + random(6)));
                        await page.mouse.move(200 + random(800), 100 + random(400));
                        await page.mouse.down();
                        await page.mouse.move(200 + random(800), 100 + random(400), {steps: 5});
                        await page.mouse.up();
                        await run(page, 0.4);
                        if (random(4) === 0) await page.keyboard.press('ArrowLeft');
                        if (random(2) === 0) await page.keyboard.press('Enter');
                    }
                    await page.keyboard.press('r');
                    if (await page.locator('#play').textContent() === 'Play') await page.click('#play');
                }
                await openText(page, swing);
                await openText(page, '{"bodies": 3}');
                await page.click('#settings');
            };
            for (let i = 0; i < 2; ++i) await round(); // until the engine's memory has grown to what these scenes take
            const start = await measure();
            await round();
            const end = await measure();
            assert.equal(end.wasm, start.wasm);
            assert.ok(end.heap < start.heap + 1e6, JSON.stringify({start, end}));
        });
    });
});
