import type {BodyId, Calls, Capacity, ErrorCode, Hooks, RecordingInfo, SnapshotInfo, WorldDef} from './types.js';

export * from './types.js';

/** What went wrong in a call. The message says what was wrong and how to mend it. The call has changed nothing. */
export declare class IsletError extends Error {
    readonly name: 'IsletError';
    readonly code: ErrorCode;
}

export interface LoadOptions {
    /** The WebAssembly: where it is, its bytes, or a compiled module. Default: the one beside this file. */
    wasm?: string | URL | BufferSource | Response | WebAssembly.Module | Promise<BufferSource | Response | WebAssembly.Module>;
    /** Whether it may use SIMD. Default: whether the machine can. The results are the same. */
    simd?: boolean;
    /** Further imports of a WebAssembly of yours that holds the engine. */
    imports?: WebAssembly.Imports;
}

/** Whether the machine has the SIMD of WebAssembly. */
export declare const hasSimd: boolean;

/** Loads the engine, once. createWorld() does it by itself. Gives the exports of the WebAssembly. */
export declare function load(options?: LoadOptions): Promise<WebAssembly.Exports>;

/** What a world is made from: all of it may be left out. */
export interface WorldOptions extends WorldDef {
    /** Room for objects; it never grows. Default: 1024 bodies, 2048 shapes, 8192 contacts, 1024 joints. */
    capacity?: Capacity;
    /** Is told of what a step goes on in spite of: `contactsFull`, `eventsFull`, `hitsFull`, `recordingFull`. Default: console.warn. */
    onError?: (error: IsletError) => void;
}

/** Loads the engine if need be, and makes a world. */
export declare function createWorld(options?: WorldOptions): Promise<World>;

/**
 * A world. Units are metres, kilograms, seconds and radians. A call that fails throws an IsletError and changes nothing.
 *
 * Functions that give an object take one to fill in as their last argument, so that a game makes none in its loop.
 */
export declare class World extends Calls {
    /** Makes a world when the engine is loaded already: see load(). */
    constructor(options?: WorldOptions);
    /**
     * A world that other code in the same WebAssembly makes. `make` gets an error hook and its context, with which that code must create the world, and
     * gives the world's address. destroy() does not free such a world.
     */
    static at(make: (errorHook: number, errorContext: number) => number, onError?: (error: IsletError) => void): World;
    /** Its address in the engine's memory. */
    readonly pointer: number;
    /** WorldOptions.onError; it can be replaced at any time. */
    onError: (error: IsletError) => void;

    /** Gives the world's memory back. The garbage collector does not. */
    destroy(): void;
    /** Advances by dt, from 1e-6 to 1 s. Default: 1/60 s. */
    step(dt?: number): void;
    /** Functions of yours that the world calls in a step; those left out are not called. What they throw, step() throws at its end. */
    setHooks(hooks?: Hooks): void;
    /** Has profile() tell what the stages of a step take, in microseconds. */
    measureTime(on?: boolean): void;

    /**
     * Writes the pose of every body to one array in the engine's memory, and gives that array, which is not copied: x, y, cosine and sine of the angle for
     * each slot (slotOf). Call it once a frame. The array is the same each time until the memory grows: do not keep it.
     */
    readPoses(): Float32Array;
    /** As of the last readPoses(), for each slot: 0 if it is free, else 1 static, 2 kinematic or 3 dynamic, 8 more if awake, 16 more if a bullet. */
    readonly states: Uint8Array;
    /** As of the last readPoses(): the slots up to the last that a body has. */
    readonly slotCount: number;

    /** All that the next steps depend on. */
    save(): Uint8Array;
    /** Begins to record every call that changes the world. `bodies`: with a hash of each body after each step. */
    startRecording(options?: {bodies?: boolean}): void;
    /** The recording, which `islet replay` and replay() repeat anywhere. */
    stopRecording(): Uint8Array;
    /**
     * Makes room for what the next step records, and gives the bytes recorded so far. step() does it by itself; call it before a step that other code in the
     * same WebAssembly makes.
     */
    growRecording(): number;
}

/** The slot of a body, shape or joint, from 0 on: its place in World.readPoses(). */
export declare function slotOf(id: BodyId): number;

/** What changed between two snapshots, packed: apply(from, delta(from, to)) is `to`. */
export declare function delta(from: Uint8Array, to: Uint8Array): Uint8Array;
/** The snapshot to which a delta leads. */
export declare function apply(from: Uint8Array, delta: Uint8Array): Uint8Array;
/** What a snapshot says about itself. */
export declare function readSnapshot(snapshot: Uint8Array): SnapshotInfo;
/** What a recording says about itself. */
export declare function readRecording(recording: Uint8Array): RecordingInfo;
