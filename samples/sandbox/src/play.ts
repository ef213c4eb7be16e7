// Keys and touch play what a scene offers (a character, a pinball table, a car), and drive the car that was put in last.
import {controls, goal, native, type Control} from './native';
import {find, make, type Stage} from './stage';

const car_controls: readonly Control[] = [{name: 'back', way: '<'}, {name: 'forward', way: '>'}];
const car_speed = 8; // m/s
const key_ways: Record<string, string> = {ArrowLeft: '<', ArrowRight: '>', ArrowUp: '^', ArrowDown: 'v', a: '<', d: '>', w: '^', s: 'v'};
const signs: Record<string, string> = {'<': '←', '>': '→', '^': '↑', v: '↓'};

export interface Player {
    /// After a scene was loaded.
    begin(): void;
    /// Before each step.
    beforeStep(): void;
    /// After each step.
    afterStep(): void;
    /// Whether a key plays here. While the scene is paused, the arrows step it.
    takes(key: string): boolean;
    readonly goal: {x: number; y: number} | undefined;
}

export function makePlayer(stage: Stage, isPlaying: () => boolean): Player {
    const bar = find('controls');
    let list: readonly Control[] = [];
    let ofScene = 0; // how many of them are the scene's
    let driven = 0; // m/s, what the car was told
    let target: {x: number; y: number} | undefined;
    let won = false;
    const keys = new Set<string>(); // held
    const buttons = new Set<string>();

    const holds = (way: string) => keys.has(way) || buttons.has(way);

    function show() {
        bar.replaceChildren(...list.map(({name, way}) => {
            const button = make('button', {textContent: signs[way]!, title: `${name} (${signs[way]})`});
            button.setAttribute('aria-label', name);
            button.dataset.way = way;
            const press = (on: boolean) => () => {
                if (on) {
                    buttons.add(way);
                    if (!isPlaying()) stage.setPlaying(true);
                } else {
                    buttons.delete(way);
                }
                button.classList.toggle('held', on);
            };
            button.addEventListener('pointerdown', (event) => {
                button.setPointerCapture(event.pointerId);
                press(true)();
            });
            for (const type of ['pointerup', 'pointercancel', 'blur'] as const) button.addEventListener(type, press(false));
            button.addEventListener('keydown', (event) => {
                if (event.key === ' ' || event.key === 'Enter') press(true)();
            });
            button.addEventListener('keyup', press(false));
            button.addEventListener('contextmenu', (event) => event.preventDefault());
            return button;
        }));
        bar.hidden = list.length === 0;
    }

    function offer() {
        const own = controls();
        const next = own.length === 0 && native.sandbox_has_car(0) !== 0 ? car_controls : own;
        ofScene = own.length;
        if (next.length === list.length && next.every(({name}, i) => list[i]!.name === name)) return;
        list = next;
        show();
    }

    addEventListener('keydown', (event) => {
        const way = key_ways[event.key];
        const at = event.target as HTMLElement;
        if (way === undefined || event.ctrlKey || event.altKey || event.metaKey || at.matches('select, input, textarea')) return;
        if (!isPlaying() || !list.some((control) => control.way === way)) return;
        keys.add(way);
    });
    addEventListener('keyup', (event) => {
        const way = key_ways[event.key];
        if (way !== undefined) keys.delete(way);
    });
    const release = () => {
        keys.clear();
        buttons.clear();
    };
    addEventListener('blur', release);
    document.addEventListener('visibilitychange', release);

    return {
        begin() {
            list = [];
            keys.clear();
            buttons.clear();
            driven = 0;
            won = false;
            target = goal();
            offer();
            show();
        },
        beforeStep() {
            offer();
            if (list.length === 0) return;
            if (ofScene > 0) {
                let held = 0;
                list.forEach(({way}, i) => (held |= holds(way) ? 1 << i : 0));
                native.sandbox_hold(0, held);
            }
            const speed = car_speed * (Number(holds('>')) - Number(holds('<')));
            if (speed !== driven && native.sandbox_has_car(0) !== 0) {
                native.sandbox_drive(0, speed);
                driven = speed;
            }
        },
        afterStep() {
            if (won || target === undefined || native.sandbox_has_won(0) === 0) return;
            won = true;
            const {step, timeStep} = stage.running;
            stage.say(`You got to the flag in ${(step * timeStep).toFixed(1)} s.`);
        },
        takes: (key) => isPlaying() && list.some(({way}) => way === key_ways[key]),
        get goal() {
            return target;
        },
    };
}
