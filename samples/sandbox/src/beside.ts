// The same scene in Box2D, in a pane beside Islet's or drawn over it. Box2D is a package of its own, which is loaded when somebody asks for it.
import type {Box2dWorld, SceneText} from '../../../bindings/js/bench/box2d';
import {describe, scenes, type Running} from './engine';
import type {Camera} from './camera';
import {Painter} from './draw';

const offered = ['chain_ball', 'mass_ratio', 'tiled_floor', 'card_house', 'tall_card_house', 'arch'];

interface Box2d {
    make(scene: SceneText): Box2dWorld;
    lacks(scene: SceneText): string;
}
async function loadBox2d(): Promise<Box2d> {
    const [{default: make}, {default: wasm}, {Box2dWorld, box2dLacks}] = await Promise.all([
        import('../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.mjs'),
        import('../node_modules/box2d3-wasm/build/dist/es/compat/Box2D.compat.wasm?url'),
        import('../../../bindings/js/bench/box2d.js'),
    ]);
    const module: unknown = await make({locateFile: () => new URL(wasm, location.href).href});
    return {make: (scene) => new Box2dWorld(module, scene), lacks: box2dLacks};
}

/// How the two engines are shown.
type Way = 'panes' | 'over';

interface Host {
    running(): Running;
    again(): void;
    choose(name: string): void;
    say(sentence: string): void;
}

export class Beside {
    private readonly buttons: Record<Way, HTMLButtonElement>;
    private readonly canvas = document.createElement('canvas');
    private readonly figures = document.createElement('p');
    private painter: Painter | undefined;
    private box2d: Promise<Box2d> | undefined;
    private world: Box2dWorld | undefined;
    private poses = new Float32Array(0);
    private states = new Uint8Array(0);
    private bodies = 0; // of the scene: what was thrown in since is Islet's alone
    private steps = 0;
    private time = 0; // ms a step, a running mean
    private told = 0; // ms, when the figures were
    private way: Way | undefined; // undefined: Islet alone

    constructor(section: HTMLElement, private readonly main: HTMLCanvasElement, private readonly host: Host) {
        const heading = Object.assign(document.createElement('h2'), {textContent: 'Beside Box2D'});
        const text = 'The same scene in Box2D 3, in a second pane or drawn over Islet. Its package is loaded when you ask for it, and runs without SIMD, '
            + 'which it offers only together with threads.';
        const about = Object.assign(document.createElement('p'), {textContent: text});
        const button = (way: Way, id: string, textContent: string) => {
            const made = Object.assign(document.createElement('button'), {id, textContent});
            made.addEventListener('click', () => void this.toggle(way));
            return made;
        };
        this.buttons = {panes: button('panes', 'beside-box2d', 'Two panes'), over: button('over', 'over-box2d', 'One over the other')};
        const ways = Object.assign(document.createElement('div'), {className: 'row'});
        ways.append(this.buttons.panes, this.buttons.over);
        const row = Object.assign(document.createElement('div'), {className: 'row offered'});
        for (const name of offered.filter((wanted) => scenes.some(({name}) => name === wanted))) {
            const choice = Object.assign(document.createElement('button'), {textContent: name.replaceAll('_', ' ')});
            choice.addEventListener('click', () => {
                this.host.choose(name);
                if (!this.open) void this.toggle('panes');
            });
            row.append(choice);
        }
        section.append(heading, about, ways, row);
        Object.assign(this.canvas, {id: 'other', hidden: true});
        this.canvas.setAttribute('role', 'img');
        this.canvas.setAttribute('aria-label', 'The same scene in Box2D');
        Object.assign(this.figures, {id: 'versus', hidden: true});
        this.main.after(this.canvas, this.figures);
        this.show();
    }

    get open() {
        return this.way !== undefined;
    }

    private show() {
        const {way} = this;
        for (const [name, button] of Object.entries(this.buttons)) button.setAttribute('aria-pressed', String(name === way));
        document.body.classList.toggle('beside', way === 'panes');
        document.body.classList.toggle('over', way === 'over');
        this.canvas.hidden = this.figures.hidden = way === undefined;
        for (const below of this.main.parentElement!.querySelectorAll<HTMLElement>('.below')) {
            if (below.nextElementSibling === this.canvas) below.hidden = way !== 'panes';
        }
    }

    /// Shows both engines this way, or Islet alone if they are shown so.
    private async toggle(way: Way) {
        if (this.open) {
            this.way = this.way === way ? undefined : way;
            if (!this.open) this.end();
            this.show();
            return;
        }
        const buttons = Object.values(this.buttons);
        for (const button of buttons) button.disabled = true;
        try {
            this.box2d ??= loadBox2d();
            await this.box2d;
            this.way = way;
            this.painter ??= new Painter(this.canvas);
            this.show();
            this.host.again();
        } catch (error) {
            this.box2d = undefined;
            this.host.say(`Box2D could not be loaded. ${(error as Error).message}`);
        } finally {
            for (const button of buttons) button.disabled = false;
        }
    }

    private end() {
        this.world?.destroy();
        this.world = undefined;
    }

    /// Whenever a scene begins.
    load() {
        this.end();
        this.painter?.forget();
        if (!this.open) return;
        void this.box2d!.then((box2d) => {
            const running = this.host.running();
            this.end();
            const refuse = (sentence: string) => void (this.figures.textContent = sentence);
            if (running.scene.text !== undefined) return refuse('Box2D runs the scenes of the gallery, not those of files.');
            if (running.hasScript) return refuse('A script moves this scene, which knows Islet alone.');
            const scene = describe(running);
            const lacks = box2d.lacks(scene);
            if (lacks !== '') return refuse(lacks);
            this.world = box2d.make(scene);
            const {bodies} = running.world.capacity();
            this.bodies = scene.bodies.length;
            this.poses = new Float32Array(4 * bodies);
            this.states = new Uint8Array(bodies);
            [this.steps, this.time, this.told] = [0, 0, 0];
            while (this.steps < running.step) this.step();
        });
    }

    step() {
        if (this.world === undefined) return;
        const began = performance.now();
        this.world.step();
        this.steps += 1;
        this.time += (performance.now() - began - this.time) * Math.max(0.02, 1 / this.steps);
    }

    draw(camera: Camera, stepTime: number) {
        const {world, painter, states, poses} = this;
        if (!this.open || painter === undefined) return;
        const running = this.host.running();
        if (world === undefined) {
            this.canvas.getContext('2d')!.clearRect(0, 0, this.canvas.width, this.canvas.height);
            return;
        }
        world.readPoses(poses);
        states.set(running.world.states.subarray(0, this.bodies));
        for (let i = 0; i < this.bodies; ++i) {
            if ((states[i]! & 7) === 3) states[i] = world.isAwake(i) ? states[i]! | 8 : states[i]! & ~8;
        }
        if (this.way === 'over') painter.drawOver(running.world, camera, {poses, states});
        else painter.draw(running.world, camera, {poses, states});
        if (performance.now() < this.told + 250) return;
        this.told = performance.now();
        const distance = this.distance(running);
        const apart = this.steps !== running.step ? 'Box2D does not go back' : distance < 1e6 ? `${distance.toFixed(3)} m apart` : 'Box2D has lost bodies';
        this.figures.textContent = `Islet ${stepTime.toFixed(2)} ms · ${apart} · Box2D ${this.time.toFixed(2)} ms`;
        this.figures.title = 'Milliseconds a step of each engine, and how far their bodies are apart (the root of the mean square)';
    }

    /// How far the bodies are from those of the other engine: the root of the mean square.
    private distance({world}: Running): number {
        const theirs = this.poses, ours = world.readPoses();
        let sum = 0, count = 0;
        for (let i = 0; i < this.bodies; ++i) {
            if ((this.states[i]! & 7) !== 3) continue;
            sum += (ours[4 * i]! - theirs[4 * i]!) ** 2 + (ours[4 * i + 1]! - theirs[4 * i + 1]!) ** 2;
            count += 1;
        }
        return Math.sqrt(sum / Math.max(1, count));
    }
}
