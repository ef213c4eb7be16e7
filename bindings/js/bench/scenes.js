// The scenes of the catalogue, as the sandbox's WebAssembly tells them (samples/sandbox/describe.cpp).
import {readFile} from 'node:fs/promises';

const file = new URL('../../../build/js/sandbox/simd.wasm', import.meta.url);

export async function readScenes() {
    let exports;
    const wasi = {clock_time_get: () => 0, fd_close: () => 8, fd_seek: () => 8, fd_write: () => 8};
    const islet = new Proxy({}, {get: () => () => 0, has: () => true});
    const module = await WebAssembly.compile(await readFile(file));
    const imports = {wasi_snapshot_preview1: wasi, islet, sandbox: islet};
    exports = (await WebAssembly.instantiate(module, imports)).exports;
    exports._initialize();
    const text = (at) => {
        const bytes = new Uint8Array(exports.memory.buffer);
        return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
    };
    const names = Array.from({length: exports.sandbox_scene_count()}, (_, i) => text(exports.sandbox_scene_text(i, 0)));
    return {names, read: (name) => JSON.parse(text(exports.sandbox_describe(names.indexOf(name))))};
}
