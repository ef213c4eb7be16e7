// Islet beside Box2D and Rapier in node: the same scenes, step by step in turns, so that whatever else the machine does hits all of them.
//   run.sh [SCENE...]
// Prints a table of Markdown: milliseconds a step, ratios (medians over blocks of steps), and the sizes of the packages.
import {readFileSync, statSync} from 'node:fs';
import {brotliCompressSync} from 'node:zlib';
import makeBox2d from 'box2d3-wasm';
import Rapier from '@dimforge/rapier2d-simd-compat';
import * as Islet from '../dist/index.js';
import {Box2dWorld} from './box2d.js';
import {IsletWorld} from './islet.js';
import {RapierWorld} from './rapier.js';
import {readScenes} from './scenes.js';

const steps = {large_pyramid: 100, washer: 120, joint_grid: 100, rain: 360};
const block = 20; // steps whose times are compared

/** The script of samples/scenes/benchmark_joints.cpp: every eighth step, another column of dolls comes down on each floor. */
class Rain {
    constructor(scene) {
        this.dolls = scene.bodies.slice(1);
        this.joints = scene.joints;
        this.columns = [];
        this.next = 0;
    }
    advance(world, step) {
        if (step % 8 !== 0) return;
        const {columns} = this;
        if (step === 0) {
            columns.push(world.bodies.slice(1));
            return;
        }
        const column = columns.length < 40 ? columns.length : this.next;
        if (columns.length >= 40) {
            for (const body of columns[column]) world.destroyBody(body);
            this.next = (this.next + 1) % 40;
        }
        const first = world.bodies.length;
        for (const doll of this.dolls) world.bodies.push(world.createBody({...doll, position: [doll.position[0] + 6.25 * column, doll.position[1]]}));
        for (const joint of this.joints) world.createJoint({...joint, body_a: joint.body_a + first - 1, body_b: joint.body_b + first - 1});
        columns[column] = world.bodies.slice(first);
    }
}

const median = (list) => [...list].sort((a, b) => a - b)[list.length >> 1];

function run(name, scene, engines) {
    const more = name === 'rain' ? {bodies: 11000, shapes: 14000, joints: 10000} : undefined;
    const worlds = engines.map((make) => make(scene, more));
    const scripts = worlds.map(() => (name === 'rain' ? new Rain(scene) : undefined));
    const times = worlds.map(() => []);
    for (let step = 0; step < steps[name]; ++step) {
        worlds.forEach((world, i) => {
            scripts[i]?.advance(world, step);
            const began = performance.now();
            world.step();
            const passed = performance.now() - began;
            if (step % block === 0) times[i].push(0);
            times[i][times[i].length - 1] += passed / block;
        });
    }
    const ratios = times.map((list) => median(list.map((time, i) => time / times[0][i])));
    const cells = times.map((list, i) => `${(list.reduce((a, b) => a + b) / list.length).toFixed(2)} | ${ratios[i].toFixed(2)}`);
    console.log(`| ${name} | ${worlds[0].counts} | ${cells.join(' | ')} |`);
    if (process.env.COUNTS) console.error(worlds.map((world) => `${world.counts}, heights sum to ${world.height().toFixed(0)} m`).join('\n'));
    for (const world of worlds) world.destroy();
}

await Islet.load();
await Rapier.init();
const Box2D = await makeBox2d();
const scenes = await readScenes();
console.log('| scene | at the end | Islet, ms a step | ratio | Box2D, ms | ratio | Rapier, ms | ratio |');
console.log('|---|---|---|---|---|---|---|---|');
const wanted = process.argv.slice(2);
const engines = [
    (scene, more) => new IsletWorld(Islet, scene, more),
    (scene) => new Box2dWorld(Box2D, scene),
    (scene) => new RapierWorld(Rapier, scene),
];
for (const name of wanted.length > 0 ? wanted : Object.keys(steps)) run(name, scenes.read(name), engines);

const modules = 'node_modules/';
const files = {
    '@islet/engine': ['../dist/islet-simd.wasm', '../dist/index.js', '../dist/islet.js', '../dist/calls.js', '../dist/functions.js', '../dist/memory.js'],
    'box2d3-wasm': ['deluxe.wasm', 'deluxe.mjs'].map((file) => `${modules}box2d3-wasm/build/dist/es/deluxe/Box2D.${file}`),
    '@dimforge/rapier2d-simd-compat': [`${modules}@dimforge/rapier2d-simd-compat/rapier.mjs`],
};
console.log('\n| what a page loads | kB | by Brotli |\n|---|---|---|');
for (const [name, list] of Object.entries(files)) {
    const all = list.map((file) => new URL(file, import.meta.url));
    const sum = (of) => (all.reduce((total, file) => total + of(file), 0) / 1000).toFixed(0);
    console.log(`| \`${name}\` | ${sum((file) => statSync(file).size)} | ${sum((file) => brotliCompressSync(readFileSync(file)).length)} |`);
}
process.exit(0); // Box2D's threads wait
