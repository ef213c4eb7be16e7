// What the tests of pages share: the browser and a server, a visit in which nothing may go wrong, and looks at what a page shows.
// Environment: CHROMIUM, the browser.
import assert from 'node:assert/strict';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {createRequire} from 'node:module';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {after, before} from 'node:test';
import {chromium} from 'playwright-core';
import {serve} from './serve.mjs';

export const phone = {viewport: {width: 390, height: 844}, deviceScaleFactor: 2, hasTouch: true, isMobile: true};
export let browser, server;

export function launch() {
    // A container's root has no sandbox, and often little shared memory.
    const args = process.getuid?.() === 0 ? ['--no-sandbox', '--disable-dev-shm-usage'] : ['--disable-dev-shm-usage'];
    return chromium.launch({executablePath: process.env.CHROMIUM, args});
}

/// While the tests of the calling file run, there is `browser`, and `server` if a folder is to be served.
export function useBrowser(folder) {
    before(async () => {
        browser = await launch();
        if (folder !== undefined) server = await serve(folder);
    });
    after(async () => {
        await browser?.close();
        server?.close();
    });
}

/// A folder that is there until the tests of the calling file are over.
export function temporaryFolder(name) {
    const folder = mkdtempSync(join(tmpdir(), `islet-${name}-`));
    after(() => rmSync(folder, {recursive: true}));
    return folder;
}

/// Opens a page, hands it to `use`, and fails on anything that it complains of, misses, or asks for though it may not.
///   options   of the browser's context
///   mayAsk    which addresses the page may ask for; if not told, those of the server
///   isKnown   messages that are no complaints
///   prepare   runs before the page is opened
export async function visit(address, {options, mayAsk = (url) => url.startsWith(server.address), isKnown = () => false, prepare}, use) {
    const context = await browser.newContext(options);
    context.setDefaultTimeout(120_000); // ms: a busy machine is slow
    const page = await context.newPage();
    const complaints = [];
    page.on('pageerror', (error) => complaints.push(error.stack));
    page.on('console', (message) => isKnown(message.text()) || complaints.push(message.text()));
    page.on('requestfailed', (request) => complaints.push(`failed: ${request.url()}`));
    page.on('request', (request) => mayAsk(request.url()) || complaints.push(`asked for ${request.url()}`));
    page.on('response', (response) => response.ok() || complaints.push(`${response.status()} for ${response.url()}`));
    await prepare?.(page, context);
    await page.goto(address);
    await use(page);
    assert.deepEqual(complaints, []);
    await context.close();
}

/// Waits until what was asked for is on the canvas.
export const settle = (page, frames = 3) => page.evaluate(async (frames) => {
    for (let i = 0; i < frames; ++i) await new Promise((done) => requestAnimationFrame(done));
}, frames);

/// For pages that call picture(): what is seen of the world, on a canvas of its own. WebGL draws on one right below #world.
/// The copy also keeps the browser from remarks on pages whose canvas is read often.
export const drawPicture = `globalThis.picture = () => {
    const all = [...document.querySelectorAll('canvas:has(+ #world):not([hidden]), #world')];
    const copy = Object.assign(document.createElement('canvas'), {width: all[0].width, height: all[0].height});
    const context = copy.getContext('2d', {willReadFrequently: true});
    for (const canvas of all) context.drawImage(canvas, 0, 0);
    return copy;
}`;
export const pictureOf = (page) => page.evaluate(() => picture().toDataURL());

/// Middle of the pixels of picture() in some of the style sheet's colours, in CSS pixels, and how many there are.
export function pixels(page, names) {
    return page.evaluate((names) => {
        const copy = picture();
        const ratio = window.devicePixelRatio;
        const {data, width} = copy.getContext('2d').getImageData(0, 0, copy.width, copy.height);
        const style = getComputedStyle(document.documentElement);
        const wanted = names.map((name) => parseInt(style.getPropertyValue(`--${name}`).trim().slice(1), 16));
        let count = 0, x = 0, y = 0;
        for (let i = 0; i < data.length; i += 4) {
            if (!wanted.includes((data[i] << 16) | (data[i + 1] << 8) | data[i + 2])) continue;
            count += 1;
            x += ((i / 4) % width) / ratio;
            y += Math.floor(i / 4 / width) / ratio;
        }
        return {count, x: x / count, y: y / count};
    }, names);
}

/// Without the name of the graphics processor, the page cannot know that there is none: it draws by WebGL.
export function hideProcessor() {
    const {getExtension} = WebGL2RenderingContext.prototype;
    WebGL2RenderingContext.prototype.getExtension = function (name) {
        return name === 'WEBGL_debug_renderer_info' ? null : getExtension.call(this, name);
    };
}

/// What axe finds against a page. A page with a policy for scripts needs `bypassCSP` in its options: axe is none of the page's own.
export async function axeFindings(page, impacts = ['minor', 'moderate', 'serious', 'critical']) {
    await page.evaluate(readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8'));
    const violations = await page.evaluate(async () => (await window.axe.run()).violations.map(({id, impact, help, nodes}) => ({id, impact, help, where: nodes.map(({target}) => target)})));
    return violations.filter(({impact}) => impacts.includes(impact));
}
