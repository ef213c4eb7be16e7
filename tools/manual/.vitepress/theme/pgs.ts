// <islet-pgs>: projected Gauss-Seidel on two contacts, with sliders. The plane of the two impulses shows each update as a line, the tower what the impulses mean,
// and the graph how the residual falls.
import {type Pair, problemOf, residual, solution, speed, sweeps} from './lcp';

const sliders = [
    {name: 'upper', title: 'mass of the upper box', unit: 'kg', min: -1, max: 2, step: 0.05, value: 0, of: (n: number) => 10 ** n},
    {name: 'rise', title: 'upper box rises at', unit: 'm/s', min: 0, max: 2, step: 0.05, value: 0, of: (n: number) => n},
    {name: 'omega', title: 'relaxation ω', unit: '', min: 0.3, max: 1.95, step: 0.05, value: 1, of: (n: number) => n},
    {name: 'count', title: 'sweeps', unit: '', min: 0, max: 40, step: 1, value: 4, of: (n: number) => n},
] as const;
type Name = (typeof sliders)[number]['name'];

const short = (n: number) => (Math.abs(n) >= 99.5 ? n.toFixed(0) : Math.abs(n) >= 9.95 ? n.toFixed(1) : n.toFixed(2)).replace(/^-(0\.?0*)$/, '$1');

class IsletPgs extends HTMLElement {
    private readonly inputs = {} as Record<Name, HTMLInputElement>;
    private start: Pair = [0, 0];
    private plane!: SVGSVGElement;
    private size: Pair = [3, 3]; // kg m/s, what the plane shows

    connectedCallback() {
        if (this.plane) return;
        const rows = sliders.map(({name, title, min, max, step, value}) =>
            `<label><span>${title}</span><output data-of="${name}"></output><input type="range" name="${name}" min="${min}" max="${max}" step="${step}" value="${value}"></label>`);
        this.innerHTML = `<div class="pgs"><svg class="plane" viewBox="0 0 360 330" role="img"><title>The plane of the two impulses</title><g></g></svg>
            <svg class="tower" viewBox="0 96 240 234" role="img"><title>The tower of two boxes and the impulses</title><g></g></svg>
            <svg class="graph" viewBox="0 0 600 150" role="img"><title>Residual and change of x, sweep by sweep</title><g></g></svg></div>
            <div class="sliders">${rows.join('')}</div>
            <div class="starts"><button data-start="cold">start from 0</button><button data-start="warm">warm start</button>
            <span>or drag in the plane of the impulses to start anywhere</span></div>`;
        this.plane = this.querySelector('.plane')!;
        for (const {name} of sliders) {
            this.inputs[name] = this.querySelector(`[name=${name}]`)!;
            this.inputs[name].addEventListener('input', () => this.draw());
        }
        this.querySelector('[data-start=cold]')!.addEventListener('click', () => this.from([0, 0]));
        // A game's next step is nearly the same problem: here, one that falls a tenth slower.
        this.querySelector('[data-start=warm]')!.addEventListener('click', () => this.from(solution(this.problem).map((x) => 0.9 * x) as Pair));
        const drag = (event: PointerEvent) => {
            const box = this.plane.getBoundingClientRect();
            const x = ((event.clientX - box.left) / box.width) * 360, y = ((event.clientY - box.top) / box.height) * 330;
            this.from([Math.max(0, ((x - 40) / 300) * this.size[0]), Math.max(0, ((290 - y) / 270) * this.size[1])]);
        };
        this.plane.addEventListener('pointerdown', (event) => {
            this.plane.setPointerCapture(event.pointerId);
            drag(event);
        });
        this.plane.addEventListener('pointermove', (event) => this.plane.hasPointerCapture(event.pointerId) && drag(event));
        this.draw();
    }

    private from(start: Pair) {
        this.start = start;
        this.draw();
    }

    private value(name: Name) {
        return sliders.find((slider) => slider.name === name)!.of(Number(this.inputs[name].value));
    }
    private get problem() {
        return problemOf({lower: 1, upper: this.value('upper'), rise: this.value('rise')});
    }

    private draw() {
        for (const {name, unit} of sliders) {
            const value = this.value(name);
            this.querySelector(`[data-of=${name}]`)!.textContent = `${name === 'count' ? value : short(value)} ${unit}`;
        }
        const {problem} = this, exact = solution(problem), path = sweeps(problem, this.start, 40, this.value('omega'));
        this.size = [0, 1].map((row) => Math.max(1.6, 1.5 * exact[row]!)) as Pair;
        const seen = path.slice(0, 1 + 2 * this.value('count'));
        this.querySelector('.plane g')!.innerHTML = this.planeOf(seen, exact);
        this.querySelector('.tower g')!.innerHTML = this.towerOf(seen.at(-1)!);
        this.querySelector('.graph g')!.innerHTML = this.graphOf(path);
    }

    private planeOf(path: Pair[], exact: Pair): string {
        const {problem, size} = this, {m, q} = problem;
        const X = (x: number) => 40 + (300 * x) / size[0], Y = (y: number) => 290 - (270 * y) / size[1];
        // Where gap 0 neither opens nor closes, and the same for gap 1: w = q + m x = 0.
        const line0 = (y: number) => (-q[0] - m[0][1] * y) / m[0][0], line1 = (x: number) => (-q[1] - m[1][0] * x) / m[1][1];
        const farY = 1.05 * size[1], farX = 1.05 * size[0];
        const clipped = 'clip-path="url(#pgs-clip)"';
        const dots = path.map(([x, y], i) => `<circle cx="${X(x)}" cy="${Y(y)}" r="${i === 0 ? 5 : i % 2 === 0 ? 3.2 : 1.6}" class="${i === 0 ? 'start' : 'step'}"/>`);
        return `<clipPath id="pgs-clip"><rect x="40" y="20" width="300" height="270"/></clipPath>
            <g ${clipped}><path class="w0" d="M${X(line0(0))} ${Y(0)}L${X(line0(farY))} ${Y(farY)}"/><path class="w1" d="M${X(0)} ${Y(line1(0))}L${X(farX)} ${Y(line1(farX))}"/>
            <polyline class="path" points="${path.map(([x, y]) => `${X(x)},${Y(y)}`).join(' ')}"/>${dots.join('')}
            <circle class="exact" cx="${X(exact[0])}" cy="${Y(exact[1])}" r="8"/></g>
            <path class="axes" d="M40 20V290H345"/>
            <text x="192" y="322" text-anchor="middle">impulse from the ground, kg m/s</text>
            <text transform="translate(13 155) rotate(-90)" text-anchor="middle">impulse between the boxes</text>
            <text x="40" y="306" text-anchor="middle">0</text><text x="340" y="306" text-anchor="end">${short(size[0])}</text><text x="34" y="28" text-anchor="end">${short(size[1])}</text>
            <text class="w0 name" x="${Math.min(300, Math.max(48, X(line0(0)) + 6))}" y="282">w₀ = 0</text>
            <text class="w1 name" x="336" y="${Math.min(270, Math.max(60, Y(line1(size[0])) + 34))}" text-anchor="end">w₁ = 0</text>`;
    }

    private towerOf(x: Pair): string {
        const {problem} = this, side = 46 + 14 * Math.log10(10 * this.value('upper'));
        const w: Pair = [speed(problem, x, 0), speed(problem, x, 1)];
        const floor = 290, gap = 16, low = floor - gap - 60, high = low - gap - side;
        const arrow = (y: number, impulse: number) => {
            const length = Math.min(44, 18 * Math.sqrt(impulse));
            return length < 3 ? '' : `<path class="impulse" d="M114 ${y + gap / 2}v${-length}m-5 7l5 -7l5 7"/>`;
        };
        const words = (row: 0 | 1) => (Math.abs(w[row]) < 0.005 ? 'at rest' : w[row] > 0 ? `opens ${short(w[row])} m/s` : `closes ${short(-w[row])} m/s`);
        return `<path class="ground" d="M10 ${floor}H230"/><rect class="lower" x="66" y="${low}" width="60" height="60" rx="4"/>
            <rect class="upper" x="${96 - side / 2}" y="${high}" width="${side}" height="${side}" rx="4"/>
            <text x="72" y="${low + 54}">1 kg</text><text x="${96 - side / 2 + 5}" y="${high + 16}">${short(this.value('upper'))} kg</text>
            ${arrow(floor - gap, x[0])}${arrow(low - gap, x[1])}
            <text class="${w[0] < -0.005 ? 'bad' : ''}" x="140" y="${floor - 14}">${words(0)}</text><text class="value" x="140" y="${floor - 30}">x₀ = ${short(x[0])}</text>
            <text class="${w[1] < -0.005 ? 'bad' : ''}" x="140" y="${low - 1}">${words(1)}</text><text class="value" x="140" y="${low - 17}">x₁ = ${short(x[1])}</text>
            <text x="120" y="322" text-anchor="middle">residual ${residual(problem, x).toPrecision(2)} m/s</text>`;
    }

    private graphOf(path: Pair[]): string {
        const {problem} = this, count = 40;
        const X = (i: number) => 50 + (530 * i) / count, Y = (n: number) => 16 + (104 * Math.min(6, Math.max(0, -Math.log10(Math.max(n, 1e-9))))) / 6;
        const line = (of: (i: number) => number, from: number) =>
            Array.from({length: count + 1 - from}, (_, i) => i + from).filter((i) => of(i) > 5e-7).map((i) => `${X(i)},${Y(of(i))}`).join(' ');
        const change = (i: number) => Math.max(...[0, 1].map((row) => Math.abs(path[2 * i]![row]! - path[2 * i - 2]![row]!)));
        const shown = this.value('count');
        return `<path class="grid" d="M50 ${Y(1)}H580M50 ${Y(1e-3)}H580M50 ${Y(1e-6)}H580"/><path class="now" d="M${X(shown)} 10V124"/>
            <text x="44" y="${Y(1) + 4}" text-anchor="end">1</text><text x="44" y="${Y(1e-3) + 4}" text-anchor="end">10⁻³</text><text x="44" y="${Y(1e-6) + 4}" text-anchor="end">10⁻⁶</text>
            <polyline class="change" points="${line(change, 1)}"/><polyline class="residual" points="${line((i) => residual(problem, path[2 * i]!), 0)}"/>
            <text x="50" y="142">0</text><text x="580" y="142" text-anchor="end">40 sweeps</text>
            <text class="residual name" x="130" y="142">residual, m/s</text><text class="change name" x="260" y="142">largest change of x, kg m/s</text>`;
    }
}

customElements.define('islet-pgs', IsletPgs);
