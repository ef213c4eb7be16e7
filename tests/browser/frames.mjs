// What a frame of the sandbox costs, the engine and the drawing apart: a pile of 2 000 awake bodies, and 10 000 bodies that are drawn.
//   measure.sh frames [SCENE...]
// Times are those that the page's thread has computed for, whatever else the machine does: paused, a frame is drawing alone.
// The browser has no graphics processor here. By WebGL it is the page's own part that is measured: all but the draw calls, which a graphics processor serves
// meanwhile. On a canvas, software computes the pixels.
import {hideProcessor, launch} from './browser.mjs';
import {serve} from './serve.mjs';

const scenes = process.argv.length > 2 ? process.argv.slice(2) : ['tumbler', 'joint_grid'];
const seconds = 4, first = 20; // steps: the first compile and make room

/// The page's own part of drawing by WebGL.
const skipDrawing = () => (WebGL2RenderingContext.prototype.drawArraysInstanced = () => {});

/// Frames, steps, and ms of the thread that pass while the page runs.
async function watch(page, session) {
    const read = async () => {
        const {metrics} = await session.send('Performance.getMetrics');
        const {frames, step} = await page.evaluate(() => ({frames: window.frameCount, step: Number(document.documentElement.dataset.step)}));
        return {frames, step, time: 1000 * metrics.find(({name}) => name === 'TaskDuration').value};
    };
    const before = await read();
    await page.waitForFunction((least) => window.frameCount >= least, before.frames + 4, {timeout: 120000});
    await page.waitForTimeout(1000 * seconds);
    const after = await read();
    return {frames: after.frames - before.frames, steps: after.step - before.step, time: after.time - before.time};
}

const browser = await launch();
const server = await serve(process.env.SANDBOX);
console.log('| scene | bodies | drawn by | drawing, ms | engine, ms a step |');
console.log('|---|---|---|---|---|');
for (const scene of scenes) {
    for (const webgl of [true, false]) {
        const page = await browser.newPage({viewport: {width: 1280, height: 760}});
        const session = await page.context().newCDPSession(page);
        await session.send('Performance.enable', {timeDomain: 'threadTicks'});
        if (webgl) {
            await page.addInitScript(hideProcessor);
            await page.addInitScript(skipDrawing);
        }
        await page.addInitScript(() => {
            window.frameCount = 0;
            const count = () => requestAnimationFrame(count, ++window.frameCount);
            count();
        });
        await page.goto(`${server.address}#${scene}`);
        await page.waitForFunction((first) => Number(document.documentElement.dataset.step) >= first, first, {timeout: 120000});
        const moving = await watch(page, session);
        await page.keyboard.press(' ');
        const still = await watch(page, session);
        // Beside what a canvas draws, the engine's time is lost in noise.
        const drawing = still.time / still.frames, engine = (moving.time - moving.frames * drawing) / moving.steps;
        const bodies = parseInt(await page.locator('#status').textContent(), 10);
        console.log(`| ${scene} | ${bodies} | ${webgl ? 'WebGL' : 'canvas 2D'} | ${drawing.toFixed(1)} | ${webgl ? engine.toFixed(1) : '–'} |`);
        await page.close();
    }
}
await browser.close();
server.close();
