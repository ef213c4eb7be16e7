// What calls.js stands on: the engine's memory, and how numbers, ids and lists lie in it. Nothing here makes objects on the way of a step.
import {errorNames} from './calls.js';

/** The functions of the engine; undefined until it is loaded. */
export let wasm;
// The memory, seen anew whenever it has grown.
export let F32, U32, U8;
/** Where the arguments of a call lie. A function that the engine calls has the next frame for its own calls. */
export let A = 0;
/** What hooks get with a call: the place of their world in `worlds`. */
export let context = 0;
export const frame_bytes = 2048;
const frames = 32;
/** A part of a definition that is left out. */
export const none = Object.freeze({});
/** The functions that the queries under way call, the innermost last. */
export const visitors = [];
/** Room for lists that the engine writes. */
export const room = {at: 0, bytes: 0};
/** Room for lists that the engine reads, one for each that a call may have. */
const given = [{at: 0, bytes: 0}, {at: 0, bytes: 0}, {at: 0, bytes: 0}];

/** What went wrong in a call. Its message says what was wrong and how to mend it; `code` is the name of the error. */
export class IsletError extends Error {
    constructor(code, message) {
        super(message);
        this.code = code;
    }
}
IsletError.prototype.name = 'IsletError';

let pending = 0; // an error that the engine told of during a call
let thrown; // what a function that the engine called has thrown

/** The engine tells of an error. */
export function remember(error) {
    if (pending === 0) pending = error;
}
export function caught(error) {
    thrown ??= {error};
}

export function errorName(error) {
    return errorNames[error] ?? 'none';
}

/** The sentence at an address; undefined if there is none. */
export function sentence(at) {
    if (at === 0) return undefined;
    let end = at;
    while (U8[end] !== 0) ++end;
    return new TextDecoder().decode(U8.slice(at, end));
}

export function makeError(error) {
    return new IsletError(errorName(error), sentence(wasm.islet_describe(error)));
}

/** After each call: throws what went wrong in it. */
export function check() {
    if (pending !== 0 || thrown !== undefined) fail();
    if (U8.length === 0) seeMemory();
}
function fail() {
    const error = pending, what = thrown;
    pending = 0;
    thrown = undefined;
    if (U8.length === 0) seeMemory();
    if (what !== undefined) throw what.error;
    throw makeError(error);
}

/** A call without an argument that it needs would go on with 0, false or NaN. */
export function takes(name, count, given) {
    if (given < count) throw new TypeError(`${name} takes ${count} argument${count === 1 ? '' : 's'}, not ${given}`);
}

export function mustBeLoaded() {
    if (wasm === undefined) throw new IsletError('notLoaded', 'The engine is not loaded yet: await load() or createWorld() first.');
}

export function seeMemory() {
    const {buffer} = wasm.memory;
    F32 = new Float32Array(buffer);
    U32 = new Uint32Array(buffer);
    U8 = new Uint8Array(buffer);
}

export function setWasm(exports) {
    wasm = exports;
    seeMemory();
    A = allocate(frames * frame_bytes);
}

/** Memory of the engine's, aligned to 16 bytes. */
export function allocate(bytes) {
    const at = wasm.malloc(bytes) >>> 0;
    if (U8.length === 0) seeMemory();
    if (at === 0) {
        throw new IsletError('blockTooSmall', `There is no memory for ${bytes} bytes: make smaller worlds, or destroy() those that are no longer needed.`);
    }
    return at;
}

/** Runs a function that the engine calls, with a frame of its own for its calls. What it throws is thrown when the engine has returned. */
export function inFrame(run, otherwise) {
    if (thrown !== undefined) return otherwise;
    A += frame_bytes;
    const before = pending;
    pending = 0;
    try {
        return run();
    } catch (error) {
        caught(error);
        return otherwise;
    } finally {
        A -= frame_bytes;
        pending = before;
    }
}

export function setContext(to) {
    context = to;
}

/** The address of a function of src/callbacks.cpp. */
export function callback(which) {
    return wasm.islet_js_callback(which);
}

// -- numbers and ids ------------------------------------------------------------------------------------------------------------------

// An id is a number: the slot (below 2^20, from 1 on) and 2^20 times the generation.
const slots = 2 ** 20;

export function putId(at, id) {
    U32[at >> 2] = id % slots;
    U32[(at >> 2) + 1] = Math.floor(id / slots);
}
export function getId(at) {
    return U32[at >> 2] + slots * U32[(at >> 2) + 1];
}
/** The slot of a body, shape or joint, from 0 on: its place in World.poses. */
export function slotOf(id) {
    takes('slotOf', 1, arguments.length);
    return id % slots - 1;
}

function checkWide(value) {
    if (!(value >= 0 && Number.isSafeInteger(value))) throw new RangeError(`${value} is no whole number from 0 to 2^53 - 1`);
}
/** A number of 64 bits, as functions take it. */
export function wide(value) {
    checkWide(value);
    return BigInt(value);
}
export function putWide(at, value) {
    checkWide(value);
    U32[at >> 2] = value;
    U32[(at >> 2) + 1] = Math.floor(value / 2 ** 32);
}
export function getWide(at) {
    return U32[at >> 2] + 2 ** 32 * U32[(at >> 2) + 1];
}
export function getWideBits(at) {
    return BigInt(U32[at >> 2]) | BigInt(U32[(at >> 2) + 1]) << 32n;
}

/** The number of an enumeration's value. */
export function code(names, value, type) {
    const found = names.indexOf(value);
    if (found < 0) throw new TypeError(`${JSON.stringify(value)} is no ${type}: there are ${names.join(', ')}`);
    return found;
}

/** A misspelt field would be left out in silence. */
export function checkFields(value, fields, type) {
    if (value === null || typeof value !== 'object') throw new TypeError(`${value} is no ${type}: give an object with ${Object.keys(fields).join(', ')}`);
    for (const key in value) {
        if (fields[key] === undefined) throw new TypeError(`${type} has no ${key}: there are ${Object.keys(fields).join(', ')}`);
    }
}

/** What stands for a vector that has not all of its numbers: the default, if a definition leaves the vector out. `index` is its place in a list. */
export function leftOut(vector, otherwise, name, index) {
    if (vector === none) return otherwise;
    const fields = Object.keys(otherwise);
    if (index !== undefined) name += `[${index}]`;
    let value = vector ?? undefined;
    if (value !== undefined) {
        const field = fields.find((key) => typeof vector[key] !== 'number');
        name += `.${field}`;
        value = vector[field];
    }
    const fault = value === undefined ? 'missing' : `${JSON.stringify(value)}, no number`;
    throw new TypeError(`${name} is ${fault}: give an object with ${fields.join(', ')}`);
}

// -- lists ----------------------------------------------------------------------------------------------------------------------------

function grow(place, bytes) {
    if (place.bytes >= bytes) return;
    if (place.at !== 0) wasm.free(place.at);
    place.bytes = 0;
    place.at = 0;
    const wanted = Math.max(4096, bytes);
    place.at = allocate(wanted);
    place.bytes = wanted;
}

/** Sees to it that `room` has so many bytes. */
export function reserve(bytes) {
    grow(room, bytes);
}

export function getArray(at, count, step, out, get) {
    const list = Array.isArray(out) ? out : [];
    list.length = count;
    for (let i = 0; i < count; ++i) list[i] = get(at + i * step, typeof list[i] === 'object' ? list[i] : undefined);
    return list;
}

/** Writes a list where the engine can read it; returns where. */
export function putArray(list, step, put, name) {
    if (typeof list?.length !== 'number') throw new TypeError(`${list} is no array`);
    grow(given[0], list.length * step);
    for (let i = 0; i < list.length; ++i) put(given[0].at + i * step, list[i], name, i);
    return given[0].at;
}

/** Writes bytes where the engine can read them; returns where. `which` of the lists of a call they are, is 1 or 2. */
export function putBytes(bytes, which) {
    if (!(bytes instanceof Uint8Array)) throw new TypeError('the bytes of an image or a recording are a Uint8Array');
    grow(given[which], bytes.length);
    U8.set(bytes, given[which].at);
    return given[which].at;
}

class EventList {
    constructor(step, get) {
        this.step = step;
        this.get = get;
        this.start = 0;
        this.length = 0;
        this.place = -1; // while it is iterated, how far
        this.turn = {value: undefined, done: false};
    }
    at(index, out) {
        if (!(index >= 0 && index < this.length)) throw new RangeError(`there are ${this.length} events, and no ${index}`);
        return this.get(this.start + this.step * index, out);
    }
    [Symbol.iterator]() {
        if (this.place >= 0) { // within a loop over itself
            const other = new EventList(this.step, this.get);
            other.start = this.start;
            other.length = this.length;
            return other[Symbol.iterator]();
        }
        this.place = 0;
        return this;
    }
    next() {
        const {turn} = this;
        turn.done = this.place >= this.length || this.place < 0;
        if (turn.done) {
            this.place = -1;
        } else {
            turn.value = this.get(this.start + this.step * this.place, turn.value);
            ++this.place;
        }
        return turn;
    }
    return() {
        this.place = -1;
        return {value: undefined, done: true};
    }
}

/** The list of a world's events of one kind, always the same object. */
export function listOf(world, name, start, length, step, get) {
    const list = world.lists[name] ??= new EventList(step, get);
    list.start = start;
    list.length = length;
    return list;
}
