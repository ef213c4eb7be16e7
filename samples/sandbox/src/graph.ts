// A small graph of the last seconds: energy, residual and the time of a step, each to its own scale.
import {native} from './native';
import {find, make, type Stage} from './stage';

const length = 300; // steps
const lines = [
    {name: 'energy', unit: 'J', color: '--awake-2', log: false},
    {name: 'residual', unit: 'm/s', color: '--contact', log: true},
    {name: 'step', unit: 'ms', color: '--accent', log: false},
] as const;

export interface Graph {
    begin(): void;
    /// After each step, which took so many milliseconds.
    note(ms: number): void;
    draw(): void;
    readonly measures: boolean;
}

export function makeGraph(stage: Stage): Graph {
    const box = make('section', {id: 'graph', hidden: true});
    box.setAttribute('aria-label', 'Graph');
    const canvas = make('canvas', {ariaHidden: 'true'});
    const texts = lines.map(({color}) => {
        const text = make('span');
        text.style.setProperty('--line-color', `var(${color})`);
        return text;
    });
    box.append(canvas, make('div', {}, ...texts));
    find('panel').before(box);
    const context = canvas.getContext('2d')!;
    const toggle = make('input', {type: 'checkbox', id: 'see-graph'});
    find('see').append(make('label', {title: 'Energy, residual and time of a step, over the last 300 steps'}, toggle, ' Graph'));
    toggle.addEventListener('change', () => (box.hidden = !toggle.checked));
    const values = lines.map(() => new Float64Array(length));
    let count = 0;

    return {
        get measures() {
            return toggle.checked;
        },
        begin() {
            count = 0;
        },
        note(ms) {
            if (!toggle.checked) return;
            const now = [native.sandbox_energy(0), stage.running.world.report().residual, ms];
            now.forEach((value, i) => (values[i]![count % length] = value));
            ++count;
        },
        draw() {
            if (!toggle.checked) return;
            const ratio = window.devicePixelRatio || 1;
            const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
            if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
            else context.clearRect(0, 0, width, height);
            const shown = Math.min(count, length), style = getComputedStyle(document.documentElement);
            lines.forEach(({name, unit, color, log}, i) => {
                const at = (k: number) => values[i]![(count - shown + k) % length]!;
                const scaled = (value: number) => (log ? Math.log10(Math.max(value, 1e-7)) : value);
                let low = Infinity, high = -Infinity;
                for (let k = 0; k < shown; ++k) {
                    low = Math.min(low, scaled(at(k)));
                    high = Math.max(high, scaled(at(k)));
                }
                if (name === 'step') low = 0;
                const span = Math.max(high - low, 1e-9);
                context.beginPath();
                for (let k = 0; k < shown; ++k) context.lineTo((k / (length - 1)) * width, height - 2 - ((scaled(at(k)) - low) / span) * (height - 4));
                context.strokeStyle = style.getPropertyValue(color);
                context.lineWidth = 1.5 * ratio;
                context.stroke();
                // A clock that counts in tenths of milliseconds, or in whole ones, tells a step's time only in the mean of many.
                const told = Math.min(shown, name === 'step' ? length : 1);
                let last = 0;
                for (let k = shown - told; k < shown; ++k) last += at(k) / told;
                texts[i]!.textContent = `${name} ${last === 0 ? '0' : Math.abs(last) >= 0.01 && Math.abs(last) < 1e5 ? last.toPrecision(3) : last.toExponential(1)} ${unit}`;
            });
        },
    };
}
