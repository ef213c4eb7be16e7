// Draws a world on a canvas, all of its view. Each body has one of six colours.
import type {World} from '@islet/engine/bare';
import {Outlines} from '../../../../samples/sandbox/src/outlines';

const names = ['paper', 'static', 'static-line', 'kinematic', 'asleep', 'bullet', 'joint', 'body-1', 'body-2', 'body-3', 'body-4', 'body-5', 'body-6', 'body-edge'] as const;

export class WorldPainter {
    private readonly context: CanvasRenderingContext2D;
    private readonly outlines = new Outlines();
    scale = 1; // pixels of CSS per metre
    private left = 0; // pixels of CSS, of the world's origin
    private bottom = 0;

    constructor(private readonly canvas: HTMLCanvasElement, private readonly view: {left: number; bottom: number; right: number; top: number}) {
        this.context = canvas.getContext('2d', {alpha: false})!;
    }

    toWorld(x: number, y: number) {
        return {x: (x - this.left) / this.scale, y: (this.bottom - y) / this.scale};
    }

    draw(world: World) {
        const {canvas, context, view} = this;
        const ratio = window.devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
        if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
            canvas.width = Math.round(width * ratio);
            canvas.height = Math.round(height * ratio);
        }
        this.scale = Math.min(width / (view.right - view.left), height / (view.top - view.bottom));
        this.left = width / 2 - (this.scale * (view.left + view.right)) / 2;
        this.bottom = height / 2 + (this.scale * (view.bottom + view.top)) / 2;

        const style = getComputedStyle(canvas);
        const colors = Object.fromEntries(names.map((name) => [name, style.getPropertyValue(`--${name}`)])) as Record<(typeof names)[number], string>;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.fillStyle = colors.paper;
        context.fillRect(0, 0, canvas.width, canvas.height);
        const poses = world.readPoses(), {states, slotCount} = world;
        const scale = this.scale * ratio;
        for (let slot = 0; slot < slotCount; ++slot) {
            const state = states[slot]!, type = state & 7;
            if (state === 0) continue;
            const outline = this.outlines.of(world, slot), at = 4 * slot;
            const c = poses[at + 2]! * scale, s = poses[at + 3]! * scale;
            context.setTransform(c, -s, s, c, this.left * ratio + poses[at]! * scale, this.bottom * ratio - poses[at + 1]! * scale);
            context.fillStyle = type === 1 ? colors.static : type === 2 ? colors.kinematic : state & 16 ? colors.bullet : !(state & 8) ? colors.asleep
                : colors[`body-${1 + (slot % 6)}` as 'body-1'];
            context.fill(outline.solid);
            context.lineWidth = Math.min(1 / this.scale, 0.04);
            context.strokeStyle = type === 1 ? colors['static-line'] : colors['body-edge'];
            context.stroke(outline.solid);
            if (!outline.hasLines) continue;
            context.lineWidth = 2 / this.scale;
            context.stroke(outline.lines);
        }
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.strokeStyle = colors.joint;
        context.lineWidth = 1.2;
        this.joints(world);
    }

    private joints(world: World) {
        const {context} = this, capacity = world.capacity().joints;
        context.beginPath();
        for (let slot = 0, left = world.jointCount(); slot < capacity && left > 0; ++slot) {
            const joint = world.jointAt(slot);
            if (joint === 0) continue;
            --left;
            if (['gear', 'angle', 'motor'].includes(world.jointType(joint))) continue;
            const a = world.jointAnchorA(joint), b = world.jointAnchorB(joint);
            const x = this.left + this.scale * b.x, y = this.bottom - this.scale * b.y;
            context.moveTo(this.left + this.scale * a.x, this.bottom - this.scale * a.y);
            context.lineTo(x, y);
            if (this.scale > 12) {
                context.moveTo(x + 2, y);
                context.arc(x, y, 2, 0, 2 * Math.PI);
            }
        }
        context.stroke();
    }
}
