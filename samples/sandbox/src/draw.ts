// Draws a world: bodies and joints by WebGL (bodies.ts) on a canvas below, and what is left on the canvas itself. Where there is no WebGL, the canvas gets all:
// outlines are made once, and poses come straight from the engine's memory.
import {Bodies} from './bodies';
import type {Camera} from './camera';
import {Links} from './links';
import type {ContactInfo, World} from './engine';
import {Outlines} from './outlines';

/// Bodies that touch are told apart by colours: as many while they are awake as asleep.
const kinds = 6;
const awake = ['awake-1', 'awake-2', 'awake-3', 'awake-4', 'awake-5', 'awake-6'] as const;
const asleep = ['asleep-1', 'asleep-2', 'asleep-3', 'asleep-4', 'asleep-5', 'asleep-6'] as const;
const names = ['paper', 'static', 'kinematic', ...awake, ...asleep, 'bullet', 'edge', 'joint', 'contact', 'over'] as const;
type Color = (typeof names)[number];

/// Where bodies are, if not where a world has them.
export interface Poses {
    poses: Float32Array;
    states: Uint8Array;
}

export class Painter {
    private readonly context: CanvasRenderingContext2D;
    private readonly outlines = new Outlines();
    private colors = {} as Record<Color, string>;
    private contact: ContactInfo | undefined;
    private readonly bodies: Bodies | undefined;
    private empty = true; // there is nothing on the canvas above
    showContacts = false;
    showJoints = true;

    constructor(private readonly canvas: HTMLCanvasElement, webgl = true) {
        if (webgl) {
            const below = document.createElement('canvas');
            below.setAttribute('aria-hidden', 'true');
            below.className = 'below';
            canvas.before(below);
            this.bodies = new Bodies(below);
            if (!this.bodies.works) below.remove();
        }
        this.context = canvas.getContext('2d')!;
        this.readColors();
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.readColors());
    }

    private readColors() {
        const style = getComputedStyle(document.documentElement);
        for (const name of names) this.colors[name] = style.getPropertyValue(`--${name}`).trim();
    }

    forget() {
        this.outlines.forget();
        this.bodies?.forget();
    }

    draw(world: World, camera: Pick<Camera, 'x' | 'y' | 'scale'>, elsewhere?: Poses) {
        const {context, colors} = this;
        const {ratio, width, height, scale, left, bottom} = this.place(camera);
        context.setTransform(1, 0, 0, 1, 0, 0);
        let poses = world.readPoses(), {states} = world;
        if (elsewhere !== undefined) ({poses, states} = elsewhere);
        const joint = this.showJoints ? colors.joint : '';
        const look = {scale, left, bottom, ratio, paper: colors.paper, edge: colors.edge, joint, colorOf: this.colorOf};
        const layered = this.bodies?.draw(world, poses, states, width, height, look) === true;
        if (layered) {
            if (!this.empty) context.clearRect(0, 0, width, height);
            this.empty = true;
        } else {
            this.empty = false;
            this.drawOutlines(world, poses, states, left, bottom, scale, ratio);
        }
        if (elsewhere !== undefined) return;
        if (this.showJoints) this.drawJoints(world, left, bottom, scale, ratio, layered);
        if (this.showContacts) this.drawContacts(world, left, bottom, scale, ratio);
    }

    /// Draws bodies that move, in one colour and half transparent, on a canvas that lies over another one.
    drawOver(world: World, camera: Pick<Camera, 'x' | 'y' | 'scale'>, {poses, states}: Poses) {
        const {context, colors} = this;
        const {ratio, width, height, scale, left, bottom} = this.place(camera);
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.clearRect(0, 0, width, height);
        this.empty = false;
        context.fillStyle = context.strokeStyle = colors.over;
        context.lineWidth = 1.2 * ratio / scale;
        for (let slot = 0; slot < world.slotCount; ++slot) {
            if ((states[slot]! & 7) < 2) continue; // none there, or static
            const outline = this.outlines.of(world, slot);
            const at = 4 * slot, c = poses[at + 2]! * scale, s = poses[at + 3]! * scale;
            context.setTransform(c, -s, s, c, left + poses[at]! * scale, bottom - poses[at + 1]! * scale);
            context.globalAlpha = 0.2;
            context.fill(outline.solid);
            context.globalAlpha = 0.7;
            context.stroke(outline.solid);
            if (outline.hasLines) context.stroke(outline.lines);
        }
        context.globalAlpha = 1;
    }

    /// Where the world's origin is on the canvas and how large a metre is, in pixels of the canvas, which gets the size that it has on the page.
    private place(camera: Pick<Camera, 'x' | 'y' | 'scale'>) {
        const {canvas} = this;
        const ratio = window.devicePixelRatio || 1;
        const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
        const scale = camera.scale * ratio;
        return {ratio, width, height, scale, left: width / 2 - camera.x * scale, bottom: height / 2 + camera.y * scale};
    }

    /// What is shown, on one canvas.
    picture(): HTMLCanvasElement {
        const {canvas} = this;
        const picture = Object.assign(document.createElement('canvas'), {width: canvas.width, height: canvas.height});
        const context = picture.getContext('2d')!;
        if (this.bodies !== undefined) context.drawImage(this.bodies.canvas, 0, 0);
        context.drawImage(canvas, 0, 0);
        return picture;
    }

    private readonly colorOf = (state: number, slot: number): string => {
        const {colors} = this;
        const type = state & 7;
        if (type === 1) return colors.static;
        if (type === 2) return colors.kinematic;
        if (state & 16) return colors.bullet;
        return colors[(state & 8 ? awake : asleep)[(slot * 7 >> 1) % kinds]!];
    };

    private drawOutlines(world: World, poses: Float32Array, states: Uint8Array, left: number, bottom: number, scale: number, ratio: number) {
        const {canvas, context, colors} = this;
        context.fillStyle = colors.paper;
        context.fillRect(0, 0, canvas.width, canvas.height);
        const {slotCount} = world;
        const edges = slotCount < 3000;
        context.lineWidth = Math.min(1.2 * ratio / scale, 0.05);
        context.strokeStyle = colors.edge;
        const thick = 2.5 * ratio / scale, thin = context.lineWidth;
        let fill = '';
        for (let slot = 0; slot < slotCount; ++slot) {
            const state = states[slot]!;
            if (state === 0) continue;
            const outline = this.outlines.of(world, slot);
            const at = 4 * slot, c = poses[at + 2]! * scale, s = poses[at + 3]! * scale;
            context.setTransform(c, -s, s, c, left + poses[at]! * scale, bottom - poses[at + 1]! * scale);
            const color = this.colorOf(state, slot);
            if (color !== fill) context.fillStyle = fill = color;
            context.fill(outline.solid);
            if (edges) context.stroke(outline.solid);
            if (outline.hasLines) {
                context.lineWidth = thick;
                context.strokeStyle = (state & 7) === 1 ? colors.static : color;
                context.stroke(outline.lines);
                context.lineWidth = thin;
                context.strokeStyle = colors.edge;
            }
        }
    }

    /// `rest`: those that WebGL has drawn are left out.
    private drawJoints(world: World, left: number, bottom: number, scale: number, ratio: number, rest: boolean) {
        const count = world.jointCount();
        if (count === 0) return;
        const {context} = this;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.beginPath();
        const a = {x: 0, y: 0}, b = {x: 0, y: 0};
        const r = Math.min(2.5 * ratio, scale / 25), capacity = world.capacity().joints;
        for (let slot = 0, found = 0; slot < capacity && found < count; ++slot) {
            const joint = world.jointAt(slot);
            if (joint === 0) continue;
            ++found;
            const type = world.jointType(joint);
            if (type === 'gear' || type === 'angle' || (rest && Links.draws(type))) continue;
            this.empty = false;
            world.jointAnchorA(joint, a);
            world.jointAnchorB(joint, b);
            const x = left + b.x * scale, y = bottom - b.y * scale;
            context.moveTo(left + a.x * scale, bottom - a.y * scale);
            context.lineTo(x, y);
            if (count < 2000) {
                context.moveTo(x + r, y);
                context.arc(x, y, r, 0, 2 * Math.PI);
            }
        }
        context.lineWidth = Math.min(1.5 * ratio, Math.max(0.5, scale / 30));
        context.strokeStyle = this.colors.joint;
        context.stroke();
    }

    private drawContacts(world: World, left: number, bottom: number, scale: number, ratio: number) {
        const {context} = this;
        this.empty = false;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.fillStyle = this.colors.contact;
        context.beginPath();
        const half = 1.5 * ratio, count = world.contactCount(), capacity = world.capacity().contacts;
        for (let slot = 0, found = 0; slot < capacity && found < count; ++slot) {
            const contact = world.contactAt(slot, this.contact);
            if (contact === undefined) continue;
            this.contact = contact;
            ++found;
            for (const {point} of contact.points) context.rect(left + point.x * scale - half, bottom - point.y * scale - half, 2 * half, 2 * half);
        }
        context.fill();
    }
}
