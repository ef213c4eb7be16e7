// The engine as part of the script: for pages of one file, and for bundlers and servers that know no .wasm files.
import * as islet from './islet.js';
import {plain, withSimd} from './wasm.js';

async function unpacked(text) {
    const bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}

islet.setSource((simd) => unpacked(simd ? withSimd : plain));
const {setSource, ...Islet} = islet;
export * from './islet.js';
export {Islet, Islet as default};
