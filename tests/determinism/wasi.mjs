// Runs a WebAssembly program in node: wasi.mjs PROGRAM ARGUMENT... It may read the folders of the files it is given.
import {readFile} from 'node:fs/promises';
import path from 'node:path';
import {WASI} from 'node:wasi';

const [program, ...args] = process.argv.slice(2);
const preopens = {};
for (const argument of args.filter((a) => path.isAbsolute(a))) preopens[path.dirname(argument)] = path.dirname(argument);
const wasi = new WASI({version: 'preview1', args: [program, ...args], preopens, returnOnExit: true});
const module = await WebAssembly.compile(await readFile(program));
const instance = await WebAssembly.instantiate(module, {wasi_snapshot_preview1: wasi.wasiImport}); // by its name, for Node.js before 20
process.exitCode = wasi.start(instance);
