// The examples of docs/javascript.md, one after another in one program.
import assert from 'node:assert/strict';
import {readFileSync, statSync} from 'node:fs';
import {test} from 'node:test';
import {brotliCompressSync} from 'node:zlib';
import Islet, {IsletError} from '@islet/engine';

const page = readFileSync(new URL('../../../docs/javascript.md', import.meta.url), 'utf8');

test('the examples run', async () => {
    const blocks = [...page.matchAll(/^```js\n([^]*?)^```$/gm)].map((match) => match[1]);
    assert.ok(blocks.length >= 6);
    assert.match(blocks[0], /^import Islet, \{IsletError\} from '@islet\/engine';\n/);
    const printed = [], drawn = [];
    const AsyncFunction = (async () => {}).constructor;
    const program = blocks.join('\n').replace(/^import .*\n/, '');
    const run = new AsyncFunction('Islet', 'IsletError', 'console', 'draw', program);
    await run(Islet, IsletError, {log: (...words) => printed.push(words.join(' '))}, (...pose) => drawn.push(pose));
    assert.equal(printed[0], 'the crate rests at (0.000, 1.500)');
    assert.match(printed[1], /^The time step/);
    assert.deepEqual(drawn.map(([slot, , y]) => [slot, Math.round(10 * y)]), [[0, 0], [1, 15]]);
    assert.equal(printed.at(-1), 'complete');
});

test('the sizes are those of the files', () => {
    const kilobytes = (bytes) => Math.round(bytes / 1000);
    const sizes = ['islet-simd.wasm', 'islet.wasm'].map((name) => {
        const file = new URL(`../dist/${name}`, import.meta.url);
        return [kilobytes(statSync(file).size), kilobytes(brotliCompressSync(readFileSync(file)).length)];
    });
    const told = page.replaceAll('\n', ' ').match(/has (\d+) kB, and (\d+) kB compressed by Brotli\. The file without has (\d+) kB and (\d+) kB/).slice(1).map(Number);
    const [, , plain, plainByBrotli] = sizes.flat();
    assert.ok(plain <= 264 && plainByBrotli <= 100, `without SIMD: ${plain} kB, ${plainByBrotli} kB by Brotli`);
    // A few bytes more or less are no news.
    sizes.flat().forEach((size, i) => assert.ok(Math.abs(size - told[i]) <= 0.03 * size, `${size} kB, not ${told[i]}`));
});
