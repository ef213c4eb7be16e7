// The engine and the scenes of the catalogue, which are in one WebAssembly (sandbox.cpp).
import type {SceneText} from '../../../bindings/js/bench/box2d';
import * as Islet from '@islet/engine/bare';
import plain from '../../../build/js/sandbox/plain.wasm?url';
import simd from '../../../build/js/sandbox/simd.wasm?url';
import {setNative} from './native';
import {putText, setModule, thrower} from './scene_text';
import golden from '../../../tests/determinism/golden.txt?raw';

export {IsletError} from '@islet/engine/bare';
export type {BodyId, ContactInfo, JointId, Polygon, World} from '@islet/engine/bare';
export const {delta, apply, makeBox, makePolygon, computeHull, slotOf} = Islet;

interface Exports {
    memory: WebAssembly.Memory;
    sandbox_scene_count(): number;
    sandbox_scene_text(scene: number, which: number): number;
    sandbox_load(place: number, scene: number, more: number, errorHook: number, errorContext: number): number;
    sandbox_load_text(place: number, more: number, errorHook: number, errorContext: number): number;
    sandbox_unload(place: number): void;
    sandbox_step(place: number): void;
    sandbox_set_step(place: number, step: number): void;
    sandbox_step_index(place: number): number;
    sandbox_has_script(place: number): number;
    sandbox_time_step(place: number): number;
    sandbox_view(place: number): number;
    sandbox_describe(scene: number): number;
}
let exports: Exports;

export interface SceneInfo {
    readonly index: number;
    readonly name: string;
    readonly group: string;
    readonly description: string;
    readonly text?: string; // of a scene file, which is not in the catalogue
}
export const scenes: SceneInfo[] = [];

export async function start() {
    // What the C++ library asks of a system: the time. Its files are not there.
    const wasi = {
        clock_time_get(_clock: number, _precision: bigint, to: number) {
            new DataView(exports.memory.buffer).setBigUint64(to, BigInt(Math.round(performance.now() * 1e6)), true);
            return 0;
        },
        fd_close: () => 8,
        fd_seek: () => 8,
        fd_write: () => 8,
    };
    const module = typeof WebAssembly === 'undefined' ? undefined : await compile(new URL(Islet.hasSimd ? simd : plain, location.href));
    exports = (await Islet.load({
        wasm: module,
        imports: {wasi_snapshot_preview1: wasi, sandbox: thrower(() => exports.memory)},
    })) as unknown as Exports;
    setModule(module!);
    setNative(exports);
    for (let index = 0; index < exports.sandbox_scene_count(); ++index) {
        const [name, group, description] = [0, 1, 2].map((which) => text(exports.sandbox_scene_text(index, which))) as [string, string, string];
        scenes.push({index, name, group, description});
    }
}

async function compile(url: URL): Promise<WebAssembly.Module> {
    const response = await fetch(url).catch(() => {
        throw new Error(`${url} cannot be loaded: is there a network?`);
    });
    if (!response.ok) throw new Error(`${url} cannot be loaded: ${response.status} ${response.statusText}`);
    // A server that does not know the type of .wasm files is no hindrance.
    const streams = response.headers.get('Content-Type')?.startsWith('application/wasm');
    return streams ? WebAssembly.compileStreaming(response) : WebAssembly.compile(await response.arrayBuffer());
}

function text(at: number): string {
    const bytes = new Uint8Array(exports.memory.buffer);
    return new TextDecoder().decode(bytes.subarray(at, bytes.indexOf(0, at)));
}

/// The scene that runs, for another engine.
export function describe(running: Running): SceneText {
    const scene = JSON.parse(text(exports.sandbox_describe(running.scene.index))) as SceneText;
    running.world.stepCount(); // any call: after it, the package sees the memory anew, which may have grown
    return scene;
}

/// A scene that runs. There is one at a time in each place.
export class Running {
    readonly world: Islet.World;
    readonly timeStep: number;
    readonly hasScript: boolean;
    readonly view: {left: number; bottom: number; right: number; top: number};

    /// `more`: room for so many bodies that the scene does not have.
    constructor(readonly scene: SceneInfo, more: number, report: (error: Islet.IsletError) => void, readonly place = 0) {
        this.world = Islet.World.at((hook, context) => {
            if (scene.text === undefined) return exports.sandbox_load(place, scene.index, more, hook, context);
            putText(scene.text);
            return exports.sandbox_load_text(place, more, hook, context);
        }, report);
        this.timeStep = exports.sandbox_time_step(place);
        this.hasScript = exports.sandbox_has_script(place) !== 0;
        const view = new Float32Array(exports.memory.buffer, exports.sandbox_view(place), 4);
        this.view = {left: view[0]!, bottom: view[1]!, right: view[2]!, top: view[3]!};
    }
    get step() {
        return exports.sandbox_step_index(this.place);
    }
    advance() {
        this.world.growRecording();
        exports.sandbox_step(this.place);
        try {
            this.world.stepCount();
        } catch {
            // What the scene's script asked for in vain: a body that it knew may be gone.
        }
    }
    goTo(step: number, image: Uint8Array) {
        this.world.restore(image);
        exports.sandbox_set_step(this.place, step);
    }
    end() {
        this.world.destroy();
        if (this.place > 0) exports.sandbox_unload(this.place);
    }
}

/// Steps and hash of a scene's first checkpoint.
const checkpoints = new Map<string, {steps: number; hash: string}>();
for (const line of golden.split('\n')) {
    const [name, steps, hash] = line.split(' ');
    if (name && steps && hash && name !== '#' && !checkpoints.has(name)) checkpoints.set(name, {steps: Number(steps), hash});
}

export interface Proof {
    steps: number;
    hash: string;
    golden: string;
}

/// Runs a scene to its checkpoint, beside the one that is played with.
export function prove(scene: SceneInfo): Proof {
    const {steps, hash} = checkpoints.get(scene.name) ?? {steps: 60, hash: 'none'};
    const running = new Running(scene, 0, () => {}, 1);
    for (let i = 0; i < steps; ++i) running.advance();
    const seen = running.world.hash().toString(16).padStart(16, '0');
    running.end();
    return {steps, hash: seen, golden: hash};
}
