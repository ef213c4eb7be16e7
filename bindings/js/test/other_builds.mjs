// A worker that runs a scene by one of the package's other builds: workerData names the file and whether it may use SIMD.
import {parentPort, workerData} from 'node:worker_threads';
import {hex, makePyramid} from './worlds.mjs';

const Islet = await import(workerData.file);
await Islet.load({simd: workerData.simd});
const {world} = await makePyramid(Islet);
for (let i = 0; i < 60; ++i) world.step();
parentPort.postMessage(hex(world.hash()));
