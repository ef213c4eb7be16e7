// The engine in files of its own, which browsers compile while they load.
import * as islet from './islet.js';

islet.setSource((simd) => (simd ? new URL('./islet-simd.wasm', import.meta.url) : new URL('./islet.wasm', import.meta.url)));
const {setSource, ...Islet} = islet;
export * from './islet.js';
export {Islet, Islet as default};
