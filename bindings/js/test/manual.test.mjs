// The examples of docs/javascript.md, one after another in one program, and those in the tables of the pages about other engines.
import assert from 'node:assert/strict';
import {readFileSync, statSync} from 'node:fs';
import {test} from 'node:test';
import {brotliCompressSync} from 'node:zlib';
import Islet, {IsletError} from '@islet/engine';
import {functions, methods} from './signatures.mjs';

const pageOf = (name) => readFileSync(new URL(`../../../docs/${name}`, import.meta.url), 'utf8');
const page = pageOf('javascript.md');
const AsyncFunction = (async () => {}).constructor;

test('the examples run', async () => {
    const blocks = [...page.matchAll(/^```js\n([^]*?)^```$/gm)].map((match) => match[1]);
    assert.ok(blocks.length >= 6);
    assert.match(blocks[0], /^import Islet, \{IsletError\} from '@islet\/engine';\n/);
    const printed = [], drawn = [];
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
    assert.ok(plain <= 266 && plainByBrotli <= 100, `without SIMD: ${plain} kB, ${plainByBrotli} kB by Brotli`);
    // A few bytes more or less are no news.
    sizes.flat().forEach((size, i) => assert.ok(Math.abs(size - told[i]) <= 0.03 * size, `${size} kB, not ${told[i]}`));
});

/// An object whose functions must exist and be called with as many arguments as the types have.
function strict(object, known) {
    return new Proxy(object, {
        get(_, name) {
            assert.ok(name in object && known.has(name), `there is no ${name}`);
            const {needed, most} = known.get(name);
            return (...given) => {
                assert.ok(given.length >= needed && given.length <= most, `${name} takes ${needed} to ${most} arguments, not ${given.length}`);
                return object[name](...given);
            };
        },
    });
}

for (const name of ['matter-js.md', 'planck.md']) {
    test(`what the table of ${name} names exists, and its calls run`, async () => {
        const cells = [...pageOf(name).matchAll(/^\| .* \| (.*) \|$/gm)].map((match) => match[1]).slice(1);
        const snippets = cells.flatMap((cell) => [...cell.matchAll(/`([^`]+)`/g)].map((match) => match[1]));
        assert.ok(cells.length >= 15 && snippets.length >= 25, `${snippets.length} snippets in ${cells.length} rows`);
        const types = readFileSync(new URL('../dist/types.d.ts', import.meta.url), 'utf8');
        const world = await Islet.createWorld();
        const body = world.createBody({type: 'dynamic'}), ground = world.createBody();
        const given = { // what the snippets take for granted
            Islet: strict(Islet, functions), world: strict(world, methods), body, bodyA: ground, bodyB: body, frameA: {}, frameB: {},
            x: 1, y: 2, w: 3, h: 4, points: [{x: 0, y: 0}, {x: 1, y: 0}, {x: 0, y: 1}], gravity: {x: 0, y: -10},
            lower: -1, upper: 1, speed: 2, maxForce: 3, category: 1, mask: 2, group: 0,
        };
        const run = (code) => new AsyncFunction(...Object.keys(given), `return ${code};`)(...Object.values(given));
        const count = {calls: 0, parts: 0, names: 0};
        for (const snippet of snippets) {
            for (const [, owner, member] of snippet.matchAll(/\b(Islet|world)\.(\w+)/g)) assert.ok(given[owner][member], member);
            if (/^\w+$/.test(snippet)) { // a function or a field
                assert.ok(snippet === 'Map' || new RegExp(`^ {4}${snippet}\\??[:(]`, 'm').test(types), `there is no ${snippet}`);
                ++count.names;
            } else if (/^\w+: /.test(snippet)) { // a part of a definition
                const makers = [`createBody({${snippet}})`, `createCircle(body, {}, {${snippet}})`, `createRevoluteJoint({bodyA, bodyB, ${snippet}})`];
                await assert.doesNotReject(Promise.any(makers.map((maker) => run(`world.${maker}`))), snippet);
                ++count.parts;
            } else if (snippet.includes('(') && !snippet.includes('...')) {
                const result = await run(snippet);
                assert.ok(result?.count !== 0, `${snippet} is an empty shape`);
                ++count.calls;
            }
        }
        assert.ok(count.calls >= 8 && count.parts >= 2 && count.names >= 4, JSON.stringify(count));
        world.destroy();
    });
}
