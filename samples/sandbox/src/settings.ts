// Every setting of the solver, with its unit, its comment and its reset: made from the description of the engine's interface.
import settings, {type Setting} from 'virtual:solver-settings';
import type {World} from './engine';
import {find, make, type Stage} from './stage';

type Value = number | boolean | string;
type Solver = Record<string, Value>;

// The sliders above have these.
const elsewhere = ['substeps', 'iterations'];

/// `begin` takes over what a scene has; `apply` sets anew what was changed, after the world went back to what it was before.
export interface Knob {
    begin(world: World): void;
    apply(world: World): void;
}

function makeInput(setting: Setting): HTMLInputElement | HTMLSelectElement {
    const id = `solver-${setting.key}`;
    if (setting.kind === 'switch') return make('input', {type: 'checkbox', id});
    if (setting.kind === 'choice') return make('select', {id}, ...setting.values!.map(({key, label, doc}) => make('option', {value: key, textContent: label, title: doc})));
    const input = make('input', {type: 'number', id, min: String(setting.least ?? 0), step: setting.kind === 'count' ? '1' : 'any'});
    if (setting.most !== undefined) input.max = String(setting.most);
    return input;
}

const read = (input: HTMLInputElement | HTMLSelectElement): Value =>
    input instanceof HTMLSelectElement ? input.value : input.type === 'checkbox' ? input.checked : input.value === '' ? NaN : Number(input.value);
function show(input: HTMLInputElement | HTMLSelectElement, value: Value) {
    if (input instanceof HTMLInputElement && input.type === 'checkbox') input.checked = value as boolean;
    else input.value = typeof value === 'number' ? String(Number(value.toPrecision(6))) : String(value);
}

export function makeSolverKnobs(stage: Stage): Knob[] {
    const box = find('solver');
    return settings.filter(({key}) => !elsewhere.includes(key)).map((setting) => {
        const {key, label, unit, doc} = setting;
        const input = makeInput(setting);
        const reset = make('button', {textContent: '↺', title: `${label} as the scene has it`, disabled: true});
        reset.setAttribute('aria-label', `Reset ${label}`);
        const about = make('span', {className: 'hidden', id: `about-${key}`, textContent: doc});
        input.setAttribute('aria-describedby', about.id);
        const row = make('div', {className: 'setting', title: `${doc} Usually ${String(setting.usual)}${unit === '' ? '' : ` ${unit}`}.`.trim()});
        row.append(make('label', {htmlFor: input.id, textContent: unit === '' ? label : `${label} (${unit})`}), input, reset, about);
        box.append(row);
        let start: Value = setting.usual, wanted: Value = start;
        const of = (world: World) => (world.solver() as unknown as Solver)[key]!;
        const write = (world: World, value: Value) => stage.attempt(() => world.setSolver({...world.solver(), [key]: value}));
        const set = (value: Value) => {
            stage.resume();
            write(stage.running.world, value);
            wanted = of(stage.running.world); // what the engine refuses, it did not take
            show(input, wanted);
            reset.disabled = wanted === start;
        };
        input.addEventListener('change', () => set(read(input)));
        reset.addEventListener('click', () => {
            set(start);
            input.focus();
        });
        return {
            begin(world) {
                start = wanted = of(world);
                show(input, start);
                reset.disabled = true;
            },
            apply(world) {
                if (of(world) !== wanted) write(world, wanted);
            },
        };
    });
}
