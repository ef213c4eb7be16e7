// Draws a world on a canvas. The outline of each body is made once; poses come straight from the engine's memory.
import {type BodyId, type ContactInfo, type Polygon, type World} from './engine';

export interface Camera {
    x: number; // m, the middle of what is shown
    y: number;
    scale: number; // pixels (of CSS) per metre
}

interface Outline {
    body: BodyId;
    solid: Path2D;
    lines: Path2D;
    hasLines: boolean;
}

const names = ['paper', 'static', 'kinematic', 'awake-1', 'awake-2', 'awake-3', 'asleep', 'bullet', 'edge', 'joint', 'contact'] as const;
type Color = (typeof names)[number];

export class Painter {
    private readonly context: CanvasRenderingContext2D;
    private outlines: (Outline | undefined)[] = [];
    private colors = {} as Record<Color, string>;
    private contact: ContactInfo | undefined;
    showContacts = false;
    showJoints = true;

    constructor(private readonly canvas: HTMLCanvasElement) {
        this.context = canvas.getContext('2d', {alpha: false})!;
        this.readColors();
        matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.readColors());
    }

    private readColors() {
        const style = getComputedStyle(document.documentElement);
        for (const name of names) this.colors[name] = style.getPropertyValue(`--${name}`).trim();
    }

    forget() {
        this.outlines = [];
    }

    draw(world: World, camera: Camera) {
        const {canvas, context, colors} = this;
        const ratio = window.devicePixelRatio || 1;
        const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
        const scale = camera.scale * ratio;
        const left = width / 2 - camera.x * scale, bottom = height / 2 + camera.y * scale;
        context.setTransform(1, 0, 0, 1, 0, 0);
        context.fillStyle = colors.paper;
        context.fillRect(0, 0, width, height);

        const poses = world.readPoses();
        const {states, slotCount} = world;
        const edges = slotCount < 3000;
        context.lineWidth = Math.min(1.2 * ratio / scale, 0.05);
        context.strokeStyle = colors.edge;
        const thick = 2.5 * ratio / scale, thin = context.lineWidth;
        let fill = '';
        for (let slot = 0; slot < slotCount; ++slot) {
            const state = states[slot]!;
            if (state === 0) continue;
            const outline = this.outlineOf(world, slot);
            const at = 4 * slot, c = poses[at + 2]! * scale, s = poses[at + 3]! * scale;
            context.setTransform(c, -s, -s, -c, left + poses[at]! * scale, bottom - poses[at + 1]! * scale);
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
        if (this.showJoints) this.drawJoints(world, left, bottom, scale, ratio);
        if (this.showContacts) this.drawContacts(world, left, bottom, scale, ratio);
    }

    private colorOf(state: number, slot: number): string {
        const {colors} = this;
        const type = state & 7;
        if (type === 1) return colors.static;
        if (type === 2) return colors.kinematic;
        if (state & 16) return colors.bullet;
        if (!(state & 8)) return colors.asleep;
        return slot % 3 === 0 ? colors['awake-1'] : slot % 3 === 1 ? colors['awake-2'] : colors['awake-3'];
    }

    private outlineOf(world: World, slot: number): Outline {
        const body = world.bodyAt(slot);
        const old = this.outlines[slot];
        if (old !== undefined && old.body === body) return old;
        const outline: Outline = {body, solid: new Path2D(), lines: new Path2D(), hasLines: false};
        for (const shape of world.bodyShapes(body)) {
            switch (world.shapeType(shape)) {
                case 'circle': {
                    const {center, radius} = world.shapeCircle(shape)!;
                    outline.solid.moveTo(center.x + radius, center.y);
                    outline.solid.arc(center.x, center.y, radius, 0, 2 * Math.PI);
                    outline.solid.lineTo(center.x, center.y);
                    break;
                }
                case 'capsule': {
                    const {point1, point2, radius} = world.shapeCapsule(shape)!;
                    const angle = Math.atan2(point2.y - point1.y, point2.x - point1.x);
                    const path = new Path2D();
                    path.arc(point1.x, point1.y, radius, angle + Math.PI / 2, angle - Math.PI / 2);
                    path.arc(point2.x, point2.y, radius, angle - Math.PI / 2, angle + Math.PI / 2);
                    path.closePath();
                    outline.solid.addPath(path);
                    break;
                }
                case 'polygon':
                    outline.solid.addPath(polygonPath(world.shapePolygon(shape)!));
                    break;
                case 'segment': {
                    const {point1, point2} = world.shapeSegment(shape)!;
                    outline.lines.moveTo(point1.x, point1.y);
                    outline.lines.lineTo(point2.x, point2.y);
                    outline.hasLines = true;
                    break;
                }
                case 'chainSegment': {
                    const {point1, point2} = world.shapeChainSegment(shape)!.segment;
                    outline.lines.moveTo(point1.x, point1.y);
                    outline.lines.lineTo(point2.x, point2.y);
                    outline.hasLines = true;
                    break;
                }
                case 'halfSpace': {
                    const {normal, offset} = world.shapeHalfSpace(shape)!;
                    const far = 1000, x = normal.x * offset, y = normal.y * offset;
                    outline.solid.moveTo(x - far * normal.y, y + far * normal.x);
                    outline.solid.lineTo(x + far * normal.y, y - far * normal.x);
                    outline.solid.lineTo(x + far * (normal.y - normal.x), y - far * (normal.x + normal.y));
                    outline.solid.lineTo(x - far * (normal.y + normal.x), y + far * (normal.x - normal.y));
                    outline.solid.closePath();
                    break;
                }
            }
        }
        return (this.outlines[slot] = outline);
    }

    private drawJoints(world: World, left: number, bottom: number, scale: number, ratio: number) {
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
            if (type === 'gear' || type === 'angle') continue;
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

function polygonPath({vertices, normals, radius}: Polygon): Path2D {
    const path = new Path2D();
    if (radius === 0) {
        for (const {x, y} of vertices) path.lineTo(x, y);
    } else {
        vertices.forEach(({x, y}, i) => {
            const before = normals[(i + vertices.length - 1) % vertices.length]!, after = normals[i]!;
            path.arc(x, y, radius, Math.atan2(before.y, before.x), Math.atan2(after.y, after.x));
        });
    }
    path.closePath();
    return path;
}
