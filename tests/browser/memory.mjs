// What the sandbox holds while somebody plays at random: scenes, tools, time, settings, files. A row a minute, after a collection of garbage.
//   measure.sh memory [MINUTES [SEED]]
import {readFileSync} from 'node:fs';
import {launch} from './browser.mjs';
import {serve} from './serve.mjs';

const minutes = Number(process.argv[2] ?? 30);
let state = Number(process.argv[3] ?? 1);
const random = () => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) / 2 ** 32; // Knuth's, of "The Art of Computer Programming" 3.3.4
const below = (count) => Math.floor(random() * count);
const oneOf = (choices) => choices[below(choices.length)];

const server = await serve(process.env.SANDBOX);
const browser = await launch();
const page = await browser.newPage({viewport: {width: 1280, height: 760}});
page.setDefaultTimeout(120_000); // large scenes are slow
const complaints = [];
page.on('pageerror', (error) => complaints.push(error.stack));
page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
// The engine's memory is the page's own secret: it is seen as it is made.
await page.addInitScript(() => {
    window.memories = [];
    const {instantiate, instantiateStreaming} = WebAssembly;
    const keep = (found) => {
        const memory = (found.instance ?? found).exports.memory;
        if (memory) window.memories.push(new WeakRef(memory));
        return found;
    };
    WebAssembly.instantiate = (...args) => instantiate(...args).then(keep);
    WebAssembly.instantiateStreaming = (...args) => instantiateStreaming(...args).then(keep);
});
const session = await page.context().newCDPSession(page);
await page.goto(server.address);
await page.waitForFunction(() => Number(document.documentElement.dataset.step) >= 3);
// (Software takes seconds for a picture of the benchmarks' thousands of bodies: somebody would only wait.)
const scenes = await page.locator('#scene optgroup:not([label=benchmark]) option').evaluateAll((options) => options.map(({value}) => value));

const place = () => [below(1280), 80 + below(560)];
async function stroke(points) {
    await page.mouse.move(...place());
    await page.mouse.down();
    for (let i = 0; i < points; ++i) await page.mouse.move(...place(), {steps: 4});
    await page.mouse.up();
}
const tool = (name) => page.locator(`input[value=${name}]`).evaluate((choice) => choice.click());
const plays = {
    scene: () => page.locator('#scene').selectOption(oneOf(scenes)),
    drag: async () => (await tool('drag'), await stroke(2)),
    spawn: async () => {
        await tool(oneOf(['box', 'ball', 'doll', 'car']));
        for (let i = 0; i < 5; ++i) await page.mouse.click(...place());
    },
    shape: async () => (await tool('shape'), await stroke(5)),
    cut: async () => (await tool('cut'), await stroke(3)),
    keys: async () => {
        const key = oneOf(['ArrowUp', 'KeyA', 'KeyD', 'KeyW']);
        await page.keyboard.down(key);
        await page.waitForTimeout(400);
        await page.keyboard.up(key);
    },
    rewind: () => page.locator('#timeline').evaluate((line, share) => {
        line.value = String(Number(line.min) + share * (Number(line.max) - Number(line.min)));
        line.dispatchEvent(new Event('input', {bubbles: true}));
    }, random()),
    play: () => page.keyboard.press('Space'),
    again: () => page.keyboard.press('KeyR'),
    see: async () => {
        const boxes = page.locator('.switches input[type=checkbox]');
        await boxes.nth(below(await boxes.count())).evaluate((box) => box.click());
    },
    knob: async () => {
        const knobs = page.locator('#knobs input[type=range]');
        await knobs.nth(below(await knobs.count())).evaluate((knob, share) => {
            knob.value = String(Number(knob.min) + share * (Number(knob.max) - Number(knob.min)));
            knob.dispatchEvent(new Event('input', {bubbles: true}));
            knob.dispatchEvent(new Event('change', {bubbles: true}));
        }, random());
    },
    save: async () => {
        const waiting = page.waitForEvent('download', {timeout: 5000}).catch(() => undefined);
        await page.locator('#save').evaluate((button) => button.click());
        await (await waiting)?.delete();
    },
};
const weights = {scene: 2, drag: 6, spawn: 4, shape: 2, cut: 2, keys: 2, rewind: 3, play: 1, again: 1, see: 1, knob: 1, save: 1};
const bag = Object.entries(weights).flatMap(([name, weight]) => Array(weight).fill(name));

/// MB: JavaScript's heap; the buffers of its arrays and of the engines; the engines' alone; and what the page's processes have of the machine: memory of their
/// own, memory that they share with the one that draws, and pages of Chromium's program.
async function held() {
    await session.send('HeapProfiler.collectGarbage');
    const {usedSize, backingStorageSize} = await session.send('Runtime.getHeapUsage');
    const engines = await page.evaluate(() => window.memories.reduce((sum, memory) => sum + (memory.deref()?.buffer.byteLength ?? 0), 0));
    const {processInfo} = await (await browser.newBrowserCDPSession()).send('SystemInfo.getProcessInfo');
    const pages = processInfo.filter(({type}) => type === 'renderer').map(({id}) => readFileSync(`/proc/${id}/status`, 'utf8'));
    const resident = (kind) => pages.reduce((sum, status) => sum + 1024 * Number(new RegExp(`Rss${kind}:\\s*(\\d+)`).exec(status)[1]), 0);
    return [usedSize, backingStorageSize, engines, resident('Anon'), resident('Shmem'), resident('File')].map((bytes) => (bytes / 1e6).toFixed(1));
}

console.log('| minute | actions | scripts, MB | buffers | engines | process: own | shared | program |\n|---|---|---|---|---|---|---|---|');
const began = Date.now();
for (let minute = 0, actions = 0; minute <= minutes; ++minute) {
    for (; Date.now() - began < 60000 * minute; ++actions) {
        await plays[oneOf(bag)]();
        await page.waitForTimeout(50 + below(300));
    }
    console.log(`| ${minute} | ${actions} | ${(await held()).join(' | ')} |`);
}
for (const complaint of complaints) console.log(complaint);
await browser.close();
server.close();
process.exitCode = complaints.length === 0 ? 0 : 1;
