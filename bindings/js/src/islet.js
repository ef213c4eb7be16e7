// @islet/engine: worlds, and what has no function of its own in calls.js. The comments of all functions are in islet.d.ts.
import * as calls from './calls.js';
import {A, IsletError, U32, U8, allocate, callback, check, getId, inFrame, makeError, mustBeLoaded, putBytes, remember, reserve, room, setContext, setWasm,
    takes, visitors, wasm} from './memory.js';

export {IsletError, slotOf} from './memory.js';
export * from './functions.js';
export {constants, version} from './calls.js';

const worlds = [undefined]; // by the number that their hooks get; 0 is of no world

// What a step goes on in spite of.
const reported = new Set(['contactsFull', 'eventsFull', 'hitsFull', 'recordingFull']);

const imports = {
    error(error, context) {
        const name = calls.errorNames[error & 255];
        if (!reported.has(name)) return remember(error & 255);
        const {onError} = worlds[context];
        inFrame(() => onError(makeError(error & 255)));
    },
    filter: (a, b, context) => inFrame(() => (worlds[context].hooks.filter(getId(a), getId(b)) ? 1 : 0), 1),
    preSolve(at, context) {
        inFrame(() => {
            const {hooks} = worlds[context];
            const contact = hooks.contact = calls.getPreSolve(at, hooks.contact);
            hooks.preSolve(contact);
            calls.putPreSolve(at, contact);
        });
    },
    mixFriction: (a, materialA, b, materialB, context) => inFrame(() => worlds[context].hooks.mixFriction(a, materialA >>> 0, b, materialB >>> 0), a),
    mixRestitution: (a, materialA, b, materialB, context) => inFrame(() => worlds[context].hooks.mixRestitution(a, materialA >>> 0, b, materialB >>> 0), a),
    cast: (at) => inFrame(() => visitors.at(-1)(calls.getQueryHit(at)), 0),
    overlap: (at) => inFrame(() => (visitors.at(-1)(getId(at)) === false ? 0 : 1), 0),
    collides: (at) => inFrame(() => (visitors.at(-1)(calls.getSurface(at)) ? 1 : 0), 1),
    clock: () => BigInt(Math.round(performance.now() * 1000)), // microseconds
};

// -- loading --------------------------------------------------------------------------------------------------------------------------

// (module (func (result v128) i32.const 0 i8x16.splat))
const with_simd = [0, 97, 115, 109, 1, 0, 0, 0, 1, 5, 1, 96, 0, 1, 123, 3, 2, 1, 0, 10, 8, 1, 6, 0, 65, 0, 253, 15, 11];
export const hasSimd = typeof WebAssembly !== 'undefined' && WebAssembly.validate(new Uint8Array(with_simd));

let source = () => { // gives the WebAssembly, with SIMD or without
    throw new IsletError('notLoaded', 'This build has no WebAssembly of its own: call load({wasm}) first.');
};
let loading;

export function setSource(find) {
    source = find;
}

export function load({wasm: given, simd = hasSimd, imports: more = {}} = {}) {
    loading ??= start(given, simd, {islet: imports, ...more}).catch((error) => {
        loading = undefined;
        throw error;
    });
    return loading;
}

async function start(given, simd, imported) {
    if (typeof WebAssembly === 'undefined') throw new IsletError('notLoaded', 'There is no WebAssembly here, which the engine needs.');
    let what = await (given ?? source(simd));
    if (typeof what === 'string' || what instanceof URL) what = await read(what);
    let instance;
    if (what instanceof WebAssembly.Module) {
        instance = await WebAssembly.instantiate(what, imported);
    } else if (typeof Response !== 'undefined' && what instanceof Response) {
        if (!what.ok) throw new IsletError('notLoaded', `${what.url} cannot be loaded: ${what.status} ${what.statusText}`);
        // A server that does not know the type of .wasm files is no hindrance.
        const streams = what.headers.get('Content-Type')?.startsWith('application/wasm') && WebAssembly.instantiateStreaming;
        ({instance} = streams ? await WebAssembly.instantiateStreaming(what, imported) : await WebAssembly.instantiate(await what.arrayBuffer(), imported));
    } else {
        ({instance} = await WebAssembly.instantiate(what, imported));
    }
    setWasm(instance.exports);
    instance.exports._initialize?.();
    return instance.exports;
}

async function read(url) {
    if (!String(url).startsWith('file:')) return fetch(url);
    // In node; no bundler for browsers need look for it.
    const module = 'node:fs/promises';
    const {readFile} = await import(/* @vite-ignore */ /* webpackIgnore: true */ module);
    return readFile(new URL(url));
}

// -- worlds ---------------------------------------------------------------------------------------------------------------------------

const room_for = Object.freeze({bodies: 1024, shapes: 2048, contacts: 8192, joints: 1024});

export async function createWorld(def) {
    await load();
    return new World(def);
}

export class World extends calls.Calls {
    constructor({capacity = room_for, hooks, onError, ...def} = {}) {
        super();
        mustBeLoaded();
        this.begin(onError, hooks);
        const at = A;
        calls.putCapacity(at, {...room_for, ...capacity});
        const bytes = wasm.islet_world_bytes(at);
        this.block = allocate((bytes || 64) + 64);
        try {
            calls.putWorldDef(at + 64, hooks === undefined ? def : {...def, hooks});
            U32[at + 64 + places.errorHook >> 2] = callback(4);
            U32[at + 64 + places.errorContext >> 2] = this.number;
            this.pointer = wasm.islet_create_world(this.block + 63 & ~63, bytes, at, at + 64, at + 1024);
            check();
            if (this.pointer === 0) throw makeError(U8[at + 1024]);
        } catch (error) {
            wasm.free(this.block);
            worlds[this.number] = undefined;
            throw error;
        } finally {
            setContext(0);
        }
    }

    /// A world that other code in the same memory has made.
    static at(make, onError) {
        const world = Object.create(World.prototype);
        world.begin(onError);
        setContext(0);
        world.pointer = make(callback(4), world.number);
        check();
        return world;
    }

    begin(onError, hooks) {
        this.lists = {};
        this.hooks = {...hooks};
        this.onError = onError ?? ((error) => console.warn(`Islet: ${error.message}`));
        const free = worlds.indexOf(undefined, 1);
        this.number = free < 0 ? worlds.length : free;
        worlds[this.number] = this;
        setContext(this.number);
        this.block = 0;
        this.recording = {at: 0, bytes: 0};
        this.all = {at: 0, slots: 0, poses: new Float32Array(0), states: new Uint8Array(0)};
        this.slotCount = 0;
    }

    destroy() {
        for (const at of [this.block, this.recording.at, this.all.at]) if (at !== 0) wasm.free(at);
        worlds[this.number] = undefined;
        Object.defineProperty(this, 'pointer', {
            get() {
                throw new IsletError('nullPointer', 'The world was destroyed: make another by createWorld().');
            },
        });
    }

    step(dt = 1 / 60) {
        this.growRecording();
        super.step(dt);
    }

    setHooks(hooks = {}) {
        this.hooks = {...hooks};
        setContext(this.number);
        try {
            calls.putHooks(A, hooks);
        } finally {
            setContext(0);
        }
        wasm.islet_world_set_hooks(this.pointer, A);
        check();
    }

    measureTime(on = true) {
        wasm.islet_world_set_clock(this.pointer, on ? callback(8) : 0, 0);
        check();
    }

    readPoses() {
        const {all} = this;
        if (all.at === 0) {
            all.slots = this.capacity().bodies;
            all.at = allocate(17 * all.slots);
        }
        this.slotCount = wasm.islet_js_poses(this.pointer, all.at, all.at + 16 * all.slots, all.slots);
        if (all.poses.buffer !== U8.buffer) {
            all.poses = new Float32Array(U8.buffer, all.at, 4 * all.slots);
            all.states = new Uint8Array(U8.buffer, all.at + 16 * all.slots, all.slots);
        }
        return all.poses;
    }

    get states() {
        return this.all.states;
    }

    // -- snapshots and recordings -----------------------------------------------------------------------------------------------------

    save() {
        const bytes = wasm.islet_world_snapshot_bytes(this.pointer);
        reserve(bytes);
        const written = wasm.islet_world_save(this.pointer, room.at, bytes);
        check();
        return U8.slice(room.at, room.at + written);
    }

    startRecording({bodies = false} = {}) {
        const bytes = wasm.islet_world_snapshot_bytes(this.pointer) + 2 ** 20;
        this.stopRecordingIfAny();
        this.recording.bytes = bytes;
        this.recording.at = allocate(bytes);
        wasm.islet_world_start_recording(this.pointer, this.recording.at, bytes, bodies ? 1 : 0);
        check();
    }

    stopRecording() {
        const {at} = this.recording;
        const written = wasm.islet_world_stop_recording(this.pointer);
        check();
        const recording = U8.slice(at, at + written);
        wasm.free(at);
        this.recording = {at: 0, bytes: 0};
        return recording;
    }

    stopRecordingIfAny() {
        if (this.recording.at !== 0) this.stopRecording();
    }

    growRecording() {
        const {at, bytes} = this.recording;
        if (at === 0) return 0;
        const used = wasm.islet_world_recorded_bytes(this.pointer);
        if (used < bytes - 2 ** 19) return used;
        const larger = allocate(2 * bytes);
        wasm.islet_world_move_recording(this.pointer, larger, 2 * bytes);
        wasm.free(at);
        this.recording = {at: larger, bytes: 2 * bytes};
        check();
        return used;
    }
}

function image(bytes, write) {
    reserve(bytes);
    U8[A] = 0;
    const written = write(room.at, bytes);
    check();
    if (written === 0) throw makeError(U8[A]);
    return U8.slice(room.at, room.at + written);
}

export function delta(from, to) {
    mustBeLoaded();
    takes('delta', 2, arguments.length);
    const a = putBytes(from, 1), b = putBytes(to, 2);
    return image(wasm.islet_max_delta_bytes(to.length), (out, bytes) => wasm.islet_delta(a, from.length, b, to.length, out, bytes, A));
}

export function apply(from, changes) {
    mustBeLoaded();
    takes('apply', 2, arguments.length);
    const a = putBytes(from, 1), b = putBytes(changes, 2);
    // As much as the image that the delta leads to says in its header, which the engine checks.
    let bytes = 2 * from.length + 4 * changes.length + 4096;
    for (;;) {
        try {
            return image(bytes, (out, size) => wasm.islet_apply(a, from.length, b, changes.length, out, size, A));
        } catch (error) {
            if (error.code !== 'imageTooSmall' || bytes > 2 ** 29) throw error;
            bytes *= 4;
        }
    }
}

export function readSnapshot(bytes) {
    mustBeLoaded();
    takes('readSnapshot', 1, arguments.length);
    const at = putBytes(bytes, 1);
    calls.expectSnapshotInfo(A);
    const error = wasm.islet_read_snapshot(at, bytes.length, A);
    if (error !== 0) throw makeError(error);
    return calls.getSnapshotInfo(A);
}

export function readRecording(bytes) {
    mustBeLoaded();
    takes('readRecording', 1, arguments.length);
    const at = putBytes(bytes, 1);
    calls.expectRecordingInfo(A);
    const error = wasm.islet_read_recording(at, bytes.length, A);
    if (error !== 0) throw makeError(error);
    return calls.getRecordingInfo(A);
}

const {places} = calls;
