// What sandbox.cpp and its neighbours export beside the engine, by their names there. There is one place for a scene of the player's: 0.
interface Native {
    memory: WebAssembly.Memory;
    sandbox_control_count(place: number): number;
    sandbox_control_name(place: number, control: number): number;
    sandbox_control_way(place: number, control: number): number;
    sandbox_goal(place: number): number;
    sandbox_has_won(place: number): number;
    sandbox_hold(place: number, held: number): void;
    sandbox_hero(place: number): number;
    sandbox_spawn_doll(place: number, x: number, y: number): number;
    sandbox_spawn_car(place: number, x: number, y: number): number;
    sandbox_has_car(place: number): number;
    sandbox_drive(place: number, speed: number): void;
    sandbox_watch_stops(place: number, on: number): void;
    sandbox_draw(place: number, what: number, left: number, bottom: number, right: number, top: number, impulseScale: number): number;
    sandbox_drawn(place: number): number;
    sandbox_stops(place: number): number;
    sandbox_energy(place: number): number;
    sandbox_text(bytes: number): number;
    sandbox_load_text(place: number, more: number, errorHook: number, errorContext: number): number;
    sandbox_save(place: number, leaveOut: number): number;
}
export let native: Native;
export function setNative(to: unknown) {
    native = to as Native;
}

export function textAt(at: number, memory = native.memory): string {
    const bytes = new Uint8Array(memory.buffer);
    return new TextDecoder().decode(bytes.slice(at, bytes.indexOf(0, at)));
}

export interface Control {
    readonly name: string;
    readonly way: string; // of the key that suits it: < > ^ v
}
export function controls(): Control[] {
    return Array.from({length: native.sandbox_control_count(0)}, (_, i) => ({
        name: textAt(native.sandbox_control_name(0, i)),
        way: String.fromCharCode(native.sandbox_control_way(0, i)),
    }));
}

/// Where the player is to get to.
export function goal(): {x: number; y: number} | undefined {
    const at = native.sandbox_goal(0);
    if (at === 0) return undefined;
    const [x, y] = new Float32Array(native.memory.buffer, at, 2) as unknown as [number, number];
    return {x, y};
}

/// Where what someone plays is.
export function hero(): {x: number; y: number} | undefined {
    if (native.sandbox_hero(0) === 0) return undefined;
    const [x, y] = drawn(2) as unknown as [number, number];
    return {x, y};
}

/// Numbers of the last sandbox_draw or sandbox_stops; the next one overwrites them.
export function drawn(count: number): Float32Array {
    return new Float32Array(native.memory.buffer, native.sandbox_drawn(0), count);
}
