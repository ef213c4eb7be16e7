// Draws a state of the movie on the canvas.
import { roundLength } from "./lengths.js";
import { jointLooks, looks } from "./movie.js";

const tints = 6;
const bodiesPerPath = 200; // longer paths take longer to fill than many short ones
const smallestRinged = 8; // pixels; on smaller bodies a hinge's ring is no more than its dot
const smallestWithMarks = 4; // pixels; on smaller bodies contacts and joints would hide what they lie on
const strays = 0.1; // of the bodies at each side, which the camera does not follow
const tau = 2 * Math.PI;

const clamp = (n, low, high) => Math.min(Math.max(n, low), high);

/// One of a few tints, scattered so that neighbours differ without a pattern.
function tintOf(body) {
    let bits = Math.imul(body, 2654435761);
    bits = Math.imul(bits ^ (bits >>> 15), 2246822519);
    return ((bits ^ (bits >>> 13)) >>> 0) % tints;
}

export class Painter {
    /// `models`: of outlines, by number. `trails`: of coordinates x, y, x, y, ... from the origin, an entry per frame.
    constructor(canvas, run, models, trails) {
        this.canvas = canvas;
        this.context = canvas.getContext("2d");
        this.run = run;
        this.models = models;
        this.reach = models.map((model) => Math.max(0, ...model.map((outline) => outline.reach)));
        this.trails = trails;
        this.readColours();
    }

    /// The colours are the style sheet's, which knows whether the page is light or dark.
    readColours() {
        const style = getComputedStyle(document.documentElement);
        const colour = (name) => style.getPropertyValue(`--${name}`).trim();
        this.colours = {};
        for (const name of ["paper", "grid", "axis", "trail", "contact", ...jointLooks]) this.colours[name] = colour(name);
        this.looks = {};
        for (const look of [...looks, "sensor"]) {
            const fills = Array.from({ length: tints }, (_, i) => colour(`${look}-${i + 1}`) || colour(look));
            this.looks[look] = { fills, stroke: colour(`${look}-line`) };
        }
    }

    /// Makes the canvas as sharp as the screen. True if its size changed.
    resize() {
        const ratio = window.devicePixelRatio || 1;
        const width = Math.round(this.canvas.clientWidth * ratio), height = Math.round(this.canvas.clientHeight * ratio);
        if (this.canvas.width === width && this.canvas.height === height) return false;
        this.canvas.width = width;
        this.canvas.height = height;
        return true;
    }

    draw(state, frame, camera, shown) {
        const { context } = this;
        const ratio = window.devicePixelRatio || 1;
        this.width = this.canvas.width / ratio;
        this.height = this.canvas.height / ratio;
        this.camera = camera;
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.fillStyle = this.colours.paper;
        context.fillRect(0, 0, this.width, this.height);
        context.lineJoin = context.lineCap = "round";
        this.#grid();
        const size = this.#typicalSize(state) * camera.scale;
        this.#trails(frame);
        this.#bodies(state, size);
        if (shown.joints && size >= smallestWithMarks) this.#joints(state, size);
        if (shown.contacts && size >= smallestWithMarks) this.#contacts(state, size);
    }

    #grid() {
        const { context, camera } = this;
        const step = roundLength(70 / camera.scale), seen = camera.seen();
        for (const [colour, isLine] of [[this.colours.grid, (n) => n !== 0], [this.colours.axis, (n) => n === 0]]) {
            context.beginPath();
            for (let n = Math.ceil(seen.left / step); n * step < seen.right; ++n) {
                if (!isLine(n)) continue;
                const x = Math.round(camera.screenX(n * step)) + 0.5;
                context.moveTo(x, 0);
                context.lineTo(x, this.height);
            }
            for (let n = Math.ceil(seen.bottom / step); n * step < seen.top; ++n) {
                if (!isLine(n)) continue;
                const y = Math.round(camera.screenY(n * step)) + 0.5;
                context.moveTo(0, y);
                context.lineTo(this.width, y);
            }
            context.lineWidth = 1;
            context.strokeStyle = colour;
            context.stroke();
        }
    }

    /// Paths of the traced bodies, as far as the run has come.
    #trails(frame) {
        const { context, camera, run } = this;
        context.strokeStyle = this.colours.trail;
        context.lineWidth = 1.5;
        for (const trail of this.trails) {
            context.beginPath();
            for (let i = 0; i <= frame; ++i) {
                context.lineTo(camera.screenX(trail[2 * i] + run.origin[0]), camera.screenY(trail[2 * i + 1] + run.origin[1]));
            }
            context.stroke();
        }
    }

    /// The box around nearly all bodies that move, m. Undefined if none does.
    action(state) {
        const { run } = this, x = [], y = [];
        for (let id = 0; id < state.bodies.size; ++id) {
            if (!state.bodies.live[id] || !["awake", "bullet"].includes(looks[state.looks[id]])) continue;
            x.push(run.origin[0] + state.bodies.x[id] * run.quantum);
            y.push(run.origin[1] + state.bodies.y[id] * run.quantum);
        }
        if (x.length === 0) return undefined;
        const few = Math.floor(x.length * strays);
        for (const all of [x, y]) all.sort((a, b) => a - b);
        return { left: x[few], bottom: y[few], right: x[x.length - 1 - few], top: y[y.length - 1 - few] };
    }

    /// The middling size of the moving bodies, m: lines and dots are drawn in proportion to it.
    #typicalSize(state) {
        const sizes = [];
        for (let id = 0; id < state.bodies.size; ++id) {
            if (!state.bodies.live[id] || looks[state.looks[id]] === "static") continue;
            sizes.push(Math.max(0, ...this.models[state.models[id]].map((outline) => outline.size)));
            if (sizes.length >= 200) break;
        }
        sizes.sort((a, b) => a - b);
        return sizes.length > 0 ? sizes[sizes.length >> 1] : 1;
    }

    #place(table, id, quantum) {
        this.x = this.camera.screenX(this.run.origin[0] + table.x[id] * quantum);
        this.y = this.camera.screenY(this.run.origin[1] + table.y[id] * quantum);
    }

    #sees(reach) {
        return this.x > -reach && this.y > -reach && this.x < this.width + reach && this.y < this.height + reach;
    }

    #bodies(state, size) {
        const sensors = [];
        const groups = new Map(); // ids by how they look, static ones first
        for (const look of ["disabled", "static", "kinematic", "asleep", "awake", "bullet"]) {
            for (let tint = 0; tint < tints; ++tint) groups.set(look + tint, { look: this.looks[look], tint, ids: [] });
        }
        for (let id = 0; id < state.bodies.size; ++id) {
            if (!state.bodies.live[id]) continue;
            this.#place(state.bodies, id, this.run.quantum);
            if (!this.#sees(this.reach[state.models[id]] * this.camera.scale + 2)) continue;
            groups.get(looks[state.looks[id]] + tintOf(id)).ids.push(id);
            if (this.models[state.models[id]].some((outline) => outline.isSensor)) sensors.push(id);
        }
        for (const { look, tint, ids } of groups.values()) {
            for (let i = 0; i < ids.length; i += bodiesPerPath) this.#paint(state, ids.slice(i, i + bodiesPerPath), look, tint, size);
        }
        this.context.strokeStyle = this.looks.sensor.stroke;
        this.context.lineWidth = 1;
        this.context.beginPath();
        this.#trace(state, sensors, (outline) => outline.isSensor);
        this.context.stroke();
    }

    #paint(state, ids, look, tint, size) {
        const { context } = this;
        const stroke = clamp(0.045 * size, 0.35, 1.5);
        context.strokeStyle = look.stroke;
        context.fillStyle = look.fills[tint];
        context.lineWidth = stroke;
        context.beginPath();
        this.#trace(state, ids, (outline) => !outline.isLine && !outline.isSensor);
        context.fill();
        if (size > 2.5) context.stroke();
        context.beginPath();
        this.#trace(state, ids, (outline) => outline.isLine && !outline.isSensor);
        context.lineWidth = Math.max(1.5, stroke);
        context.stroke();
        if (size > 7) this.#spokes(state, ids);
    }

    #trace(state, ids, isWanted) {
        const { bodies } = state;
        for (const id of ids) {
            const outlines = this.models[state.models[id]];
            this.#place(bodies, id, this.run.quantum);
            const angle = (bodies.angle[id] / this.run.bodyTurn) * tau;
            const c = Math.cos(angle), s = Math.sin(angle);
            for (const outline of outlines) {
                if (isWanted(outline)) outline.trace(this.context, this.x, this.y, angle, c, s, this.camera.scale);
            }
        }
    }

    /// A line in each disc that shows how it turns.
    #spokes(state, ids) {
        const { context, camera } = this;
        context.beginPath();
        for (const id of ids) {
            for (const outline of this.models[state.models[id]]) {
                if (!outline.isDisc || outline.isSensor || looks[state.looks[id]] === "static") continue;
                const [from] = outline.points;
                const to = { x: from.x + 0.8 * outline.radius, y: from.y };
                const [x, y] = this.#pointOf(state, id, from);
                const [toX, toY] = this.#pointOf(state, id, to);
                if (outline.radius * camera.scale < 4) continue;
                context.moveTo(x, y);
                context.lineTo(toX, toY);
            }
        }
        context.globalAlpha = 0.6;
        context.stroke();
        context.globalAlpha = 1;
    }

    /// Where a point of a body's own frame (m) is on the screen.
    #pointOf(state, id, p) {
        this.#place(state.bodies, id, this.run.quantum);
        const angle = (state.bodies.angle[id] / this.run.bodyTurn) * tau;
        const c = Math.cos(angle), s = Math.sin(angle), { scale } = this.camera;
        return [this.x + (c * p.x - s * p.y) * scale, this.y - (s * p.x + c * p.y) * scale];
    }

    /// What DebugDraw drew of each joint, in its colours: lines and rings, and dots where it holds its bodies.
    #joints(state, size) {
        const { context, run, camera } = this;
        const paths = Object.fromEntries(jointLooks.map((look) => [look, { lines: new Path2D(), dots: [] }]));
        for (const joint of state.joints.values()) {
            // The ends first, which other marks may lie between: dots, or rings where there are none.
            const dots = joint.figure.filter(({ kind }) => kind === "dot");
            const endMarks = dots.length > 0 ? dots : joint.figure.filter(({ kind }) => kind === "ring").slice(0, 2);
            const ends = endMarks.map(({ points }) => this.#jointPoint(state, joint, [], points[0]));
            dots.forEach(({ look }, i) => paths[look].dots.push(ends[i]));
            for (const { kind, look, points, radius } of joint.figure) {
                if (kind === "dot" || (kind === "ring" && size < smallestRinged)) continue;
                const { lines } = paths[look];
                const places = points.map((point) => this.#jointPoint(state, joint, ends, point));
                if (kind === "ring") {
                    const onScreen = radius * run.quantum * camera.scale;
                    lines.moveTo(places[0][0] + onScreen, places[0][1]);
                    lines.arc(...places[0], onScreen, 0, tau);
                } else {
                    places.forEach((place, i) => (i === 0 ? lines.moveTo(...place) : lines.lineTo(...place)));
                    if (kind === "loop") lines.closePath();
                }
            }
        }
        for (const [look, { lines, dots }] of Object.entries(paths)) {
            context.strokeStyle = this.colours[look];
            context.lineWidth = clamp(0.04 * size, 0.5, 1.6);
            context.globalAlpha = 0.75;
            context.stroke(lines);
            context.globalAlpha = 1;
            this.#dots(dots, clamp(0.075 * size, 0.6, 3.2), this.colours[look]);
        }
    }

    /// Where a point of a joint's figure is on the screen.
    #jointPoint(state, { a, b, x: freeX, y: freeY }, ends, { frame, x, y }) {
        const { run, camera } = this;
        const p = { x: x * run.quantum, y: y * run.quantum };
        if (frame === "a" && a < 0) {
            p.x += freeX * run.quantum;
            p.y += freeY * run.quantum;
        }
        if (frame === "world" || (frame === "a" && a < 0)) return [camera.screenX(run.origin[0] + p.x), camera.screenY(run.origin[1] + p.y)];
        if (frame === "a" || frame === "b") return this.#pointOf(state, frame === "a" ? a : b, p);
        const [fromX, fromY] = ends[frame.startsWith("endB") ? 1 : 0];
        let c, s; // of the way's angle in the world
        let along = p.x * camera.scale;
        const across = p.y * camera.scale;
        if (frame.endsWith("-a") || frame.endsWith("-b")) {
            const body = frame.endsWith("-a") ? a : b;
            const angle = body < 0 ? 0 : (state.bodies.angle[body] / run.bodyTurn) * tau;
            c = Math.cos(angle);
            s = Math.sin(angle);
        } else {
            const dx = ends[1][0] - ends[0][0], dy = ends[0][1] - ends[1][1];
            const far = Math.hypot(dx, dy) || 1;
            c = dx / far;
            s = dy / far;
            if (frame === "between") along = (x / run.betweenParts) * far;
        }
        return [fromX + c * along - s * across, fromY - (s * along + c * across)];
    }

    /// A dot at each touching point, and a short line along its normal.
    #contacts(state, size) {
        const { context, run } = this;
        const length = clamp(0.22 * size, 3, 14);
        const dots = [];
        context.beginPath();
        for (let id = 0; id < state.contacts.size; ++id) {
            if (!state.contacts.live[id]) continue;
            this.#place(state.contacts, id, run.contactQuantum);
            if (!this.#sees(length)) continue;
            dots.push([this.x, this.y]);
            const angle = (state.contacts.angle[id] / run.contactTurn) * tau;
            context.moveTo(this.x, this.y);
            context.lineTo(this.x + length * Math.cos(angle), this.y - length * Math.sin(angle));
        }
        if (size > 8) {
            context.strokeStyle = this.colours.contact;
            context.lineWidth = clamp(0.03 * size, 0.6, 1.3);
            context.globalAlpha = 0.7;
            context.stroke();
            context.globalAlpha = 1;
        }
        this.#dots(dots, clamp(0.055 * size, 0.5, 2.6), this.colours.contact);
    }

    #dots(points, radius, colour) {
        const { context } = this;
        context.fillStyle = colour;
        for (let i = 0; i < points.length; i += bodiesPerPath) {
            context.beginPath();
            for (const [x, y] of points.slice(i, i + bodiesPerPath)) {
                if (radius < 1) {
                    context.rect(x - radius, y - radius, 2 * radius, 2 * radius);
                } else {
                    context.moveTo(x + radius, y);
                    context.arc(x, y, radius, 0, tau);
                }
            }
            context.fill();
        }
    }
}
