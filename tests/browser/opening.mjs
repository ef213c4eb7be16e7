// How soon the sandbox moves on a processor that is four times slower: from the request to the third step, in a browser that has seen nothing of it before.
//   measure.sh opening [RUNS]
import {launch} from './browser.mjs';
import {serve} from './serve.mjs';

const runs = Number(process.argv[2] ?? 10);
const server = await serve(process.env.SANDBOX);
const seconds = [];
for (let i = 0; i < runs; ++i) {
    const browser = await launch();
    const page = await browser.newPage({viewport: {width: 1280, height: 760}});
    const session = await page.context().newCDPSession(page);
    await session.send('Emulation.setCPUThrottlingRate', {rate: 4});
    const began = performance.now();
    await page.goto(server.address, {waitUntil: 'commit'});
    await page.waitForFunction(() => Number(document.documentElement.dataset.step) >= 3);
    seconds.push((performance.now() - began) / 1000);
    await browser.close();
}
seconds.sort((a, b) => a - b);
const shown = (value) => `${value.toFixed(2)} s`;
console.log(`moves after (median of ${runs}) ${shown(seconds[Math.floor(runs / 2)])}, at the soonest ${shown(seconds[0])}, at the latest ${shown(seconds.at(-1))}`);
server.close();
