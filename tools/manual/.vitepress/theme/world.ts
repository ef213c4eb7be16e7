// <islet-world scene="pyramid"><img ...></islet-world>: a scene of the catalogue that runs where the picture stands. Bodies can be dragged.
// The picture stays where WebAssembly does not load. One world runs at a time: the last one that came into view.
import type * as Sandbox from '../../../../samples/sandbox/src/engine';
import {WorldPainter} from './painter';

let loading: Promise<typeof Sandbox> | undefined;

/// The engine and the scenes, loaded when the first world comes into view.
function engine() {
    loading ??= import('../../../../samples/sandbox/src/engine').then(async (sandbox) => {
        await sandbox.start();
        return sandbox;
    });
    return loading;
}

const still = matchMedia('(prefers-reduced-motion: reduce)');
const dragAcceleration = 400; // m/s^2, at most
let active: IsletWorld | undefined;

class IsletWorld extends HTMLElement {
    private readonly canvas = document.createElement('canvas');
    private readonly bar = document.createElement('div');
    private readonly playButton = document.createElement('button');
    private watcher: IntersectionObserver | undefined;
    private running: Sandbox.Running | undefined;
    private painter: WorldPainter | undefined;
    private playing = !still.matches;
    private joint = 0;
    private last = 0;
    private due = 0; // s of the world's time to catch up with

    connectedCallback() {
        this.watcher = new IntersectionObserver(([entry]) => void (entry!.isIntersecting ? this.begin() : this.end()), {threshold: 0.35});
        this.watcher.observe(this);
    }
    disconnectedCallback() {
        this.watcher?.disconnect();
        this.end();
    }

    private async begin() {
        if (active === this) return;
        active?.end();
        active = this;
        try {
            const sandbox = await engine();
            if (active === this) this.show(sandbox);
        } catch (error) {
            console.warn('the picture stays:', error); // no WebAssembly, or no network any more
            active = undefined;
        }
    }

    private end() {
        if (active !== this) return;
        active = undefined;
        this.joint = 0;
        this.running?.end();
        this.running = undefined; // its last picture stays on the canvas
    }

    private show(sandbox: typeof Sandbox) {
        const scene = sandbox.scenes.find(({name}) => name === this.getAttribute('scene'));
        if (scene === undefined) return;
        if (!this.painter) this.furnish();
        this.running = new sandbox.Running(scene, 1, () => {}); // with room for the joint that drags
        this.painter = new WorldPainter(this.canvas, this.running.view);
        this.classList.add('live');
        this.joint = this.due = this.last = 0;
        requestAnimationFrame((now) => this.frame(now));
    }

    private furnish() {
        const again = document.createElement('button');
        again.textContent = '↺';
        again.ariaLabel = again.title = 'Start again';
        again.onclick = () => this.again();
        this.playButton.onclick = () => this.setPlaying(!this.playing);
        this.bar.className = 'bar';
        this.bar.append(this.playButton, again);
        this.canvas.role = 'img';
        this.canvas.ariaLabel = `${this.querySelector('img')?.alt ?? 'A scene'}. It runs, and its bodies can be dragged.`;
        this.append(this.canvas, this.bar);
        this.setPlaying(this.playing);
        this.listen();
    }

    private setPlaying(on: boolean) {
        this.playing = on;
        this.playButton.textContent = on ? '❚❚' : '▶';
        this.playButton.ariaLabel = this.playButton.title = on ? 'Pause' : 'Play';
        if (on && active !== this) void this.begin();
    }

    private again() {
        active?.end();
        void this.begin();
    }

    private frame(now: number) {
        const {running} = this;
        if (!running || active !== this) return;
        if (this.playing) {
            this.due += Math.min(0.1, this.last === 0 ? 0 : (now - this.last) / 1000);
            for (let i = 0; i < 8 && this.due >= running.timeStep; ++i, this.due -= running.timeStep) running.advance();
            if (this.due > running.timeStep) this.due = 0; // a slow machine shows it slower
        }
        this.last = now;
        this.dataset.step = String(running.step);
        this.painter!.draw(running.world);
        requestAnimationFrame((next) => this.frame(next));
    }

    // -- dragging -----------------------------------------------------------------------------------------------------------------------

    private grab(x: number, y: number): boolean {
        const world = this.running?.world, point = this.painter?.toWorld(x, y);
        if (!world || !point) return false;
        const near = 0.25 * Math.min(1, 20 / this.painter!.scale);
        const bodies = [{x: 0, y: 0}, {x: near, y: 0}, {x: -near, y: 0}, {x: 0, y: near}, {x: 0, y: -near}]
            .flatMap((by) => world.overlapPoint({x: point.x + by.x, y: point.y + by.y}))
            .map((shape) => world.shapeBody(shape))
            .filter((body) => world.bodyType(body) === 'dynamic');
        const body = bodies[0];
        if (body === undefined) return false;
        try {
            this.joint = world.createMouseJoint({body, target: point, maxForce: dragAcceleration * world.bodyMass(body)});
        } catch {
            return false; // the scene has no room for a joint
        }
        this.setPlaying(true);
        return true;
    }

    private pull(x: number, y: number) {
        if (this.joint === 0 || !this.running) return;
        try {
            this.running.world.jointSetTarget(this.joint, this.painter!.toWorld(x, y));
        } catch {
            this.joint = 0; // the body is gone, and the joint with it
        }
    }

    private release() {
        try {
            if (this.joint !== 0) this.running?.world.destroyJoint(this.joint);
        } catch {
            // The body is gone, and the joint with it.
        }
        this.joint = 0;
    }

    private listen() {
        const {canvas} = this;
        canvas.addEventListener('pointerdown', (event) => {
            if (this.grab(event.offsetX, event.offsetY)) canvas.setPointerCapture(event.pointerId);
        });
        canvas.addEventListener('pointermove', (event) => this.pull(event.offsetX, event.offsetY));
        for (const name of ['pointerup', 'pointercancel'] as const) canvas.addEventListener(name, () => this.release());
        // A finger on a body drags it; elsewhere it scrolls the page.
        canvas.addEventListener('touchmove', (event) => this.joint !== 0 && event.preventDefault(), {passive: false});
    }
}

customElements.define('islet-world', IsletWorld);
