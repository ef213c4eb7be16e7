// Reads the frames of a movie, whose bytes tools/islet/movie.hpp describes. Frames are told as changes, so going back means starting
// over from an earlier frame: a copy of the state is kept every so many frames, as they are first passed.

const framesPerCopy = 50;

/// What the numbers in a movie stand for.
export const looks = ["static", "kinematic", "awake", "asleep", "bullet", "disabled"];
export const jointLooks = ["joint", "idle-joint", "limit"];
const kinds = ["dot", "line", "loop", "ring"];
const frames = ["world", "a", "b", "endA-b", "endB-a", "endA-way", "endB-way", "between"];

const unfolded = (n) => (n >>> 1) ^ -(n & 1);

/// Rows of whole numbers by id. A row's change counts only if it was made in the frame before.
class Table {
    constructor(turn) {
        this.turn = turn;
        this.size = 0;
        this.x = this.y = this.angle = this.dx = this.dy = this.turned = this.changedIn = new Int32Array(0);
        this.live = new Uint8Array(0);
    }

    grow(size) {
        this.size = Math.max(this.size, size);
        if (size <= this.live.length) return;
        const room = Math.max(64, 2 * size);
        for (const name of ["x", "y", "angle", "dx", "dy", "turned", "changedIn", "live"]) {
            const old = this[name];
            this[name] = new old.constructor(room);
            this[name].set(old);
        }
    }

    copy() {
        const copy = Object.assign(new Table(this.turn), this);
        for (const name of ["x", "y", "angle", "dx", "dy", "turned", "changedIn", "live"]) copy[name] = this[name].slice(0, this.size);
        return copy;
    }
}

class State {
    constructor(bodyTurn, contactTurn) {
        this.position = 0; // in the bytes
        this.bodies = new Table(bodyTurn);
        this.looks = []; // by body, an index of `looks`
        this.models = []; // by body
        this.contacts = new Table(contactTurn);
        this.figures = 0; // how many the bytes have told so far
        this.joints = new Map(); // by id: what is drawn of each, and its bodies, -1 for none; without a body a, where its first end is
    }

    copy() {
        const copy = Object.assign(new State(), this);
        copy.bodies = this.bodies.copy();
        copy.looks = this.looks.slice();
        copy.models = this.models.slice();
        copy.contacts = this.contacts.copy();
        copy.joints = new Map(this.joints);
        return copy;
    }
}

export class Movie {
    /// `run` is the page's description of the run.
    constructor(bytes, run) {
        this.bytes = bytes;
        this.frames = run.frames;
        this.state = new State(run.bodyTurn, run.contactTurn);
        this.figures = []; // by number; read again where frames are
        this.frame = -1; // that `state` is of; -1 before the first
        this.copies = [this.state.copy()]; // entry i is of frame i * framesPerCopy - 1
    }

    /// The state at a frame; good until the next call.
    at(frame) {
        if (frame < this.frame || frame >= this.frame + framesPerCopy) {
            const copy = Math.min(Math.floor((frame + 1) / framesPerCopy), this.copies.length - 1);
            const start = copy * framesPerCopy - 1;
            if (frame < this.frame || start > this.frame) {
                this.state = this.copies[copy].copy();
                this.frame = start;
            }
        }
        while (this.frame < frame) {
            this.frame += 1;
            this.#advance();
            if ((this.frame + 1) % framesPerCopy === 0 && this.copies.length === (this.frame + 1) / framesPerCopy) {
                this.copies.push(this.state.copy());
            }
        }
        return this.state;
    }

    #advance() {
        const { state } = this;
        this.#table(state.bodies, (id) => {
            state.looks[id] = this.#number();
            state.models[id] = this.#number();
        });
        for (const id of this.#ids()) state.looks[id] = this.#number();
        this.#table(state.contacts, () => {});
        this.#set((id) => state.joints.delete(id));
        for (const id of this.#ids()) {
            const number = this.#number();
            if (number === state.figures) {
                state.figures += 1;
                this.figures[number] = this.#figure();
            }
            const joint = { figure: this.figures[number], b: this.#number() - 1, a: this.#number() - 1 };
            if (joint.a < 0) Object.assign(joint, { x: this.#signed(), y: this.#signed() });
            state.joints.set(id, joint);
        }
    }

    /// The marks of a joint, by the names above.
    #figure() {
        const marks = [];
        let last = {};
        for (let count = this.#number(); count > 0; --count) {
            const head = this.#number();
            const mark = { kind: kinds[head & 3], look: jointLooks[(head >> 2) & 3], points: [] };
            if (mark.kind === "ring") mark.radius = this.#signed();
            for (let points = head >> 4; points > 0; --points) {
                const x = this.#number();
                const frame = frames[x & 7], from = frame === last.frame ? last : { x: 0, y: 0 };
                last = { frame, x: from.x + unfolded(x >>> 3), y: from.y + this.#signed() };
                mark.points.push(last);
            }
            marks.push(mark);
        }
        return marks;
    }

    #table(table, readMore) {
        this.#set((id) => (table.live[id] = 0));
        let x = 0, y = 0, angle = 0;
        for (const id of this.#ids()) {
            table.grow(id + 1);
            this.#row();
            table.x[id] = x += this.x;
            table.y[id] = y += this.y;
            table.angle[id] = angle = (angle + this.angle) & (table.turn - 1);
            table.live[id] = 1;
            table.changedIn[id] = -1;
            readMore(id);
        }
        const { frame } = this;
        for (const id of this.#ids()) {
            const goesOn = table.changedIn[id] === frame - 1;
            this.#row();
            const dx = this.x + (goesOn ? table.dx[id] : 0);
            const dy = this.y + (goesOn ? table.dy[id] : 0);
            const turned = this.angle + (goesOn ? table.turned[id] : 0);
            table.x[id] += table.dx[id] = dx;
            table.y[id] += table.dy[id] = dy;
            table.turned[id] = turned;
            table.angle[id] = (table.angle[id] + turned) & (table.turn - 1);
            table.changedIn[id] = frame;
        }
    }

    /// Reads a row into x, y and angle.
    #row() {
        const first = this.bytes[this.state.position++];
        if (first === 255) {
            this.x = this.#signed();
            this.y = this.#signed();
            this.angle = this.#signed();
        } else {
            this.x = Math.trunc(first / 27) - 4;
            this.y = (Math.trunc(first / 3) % 9) - 4;
            this.angle = (first % 3) - 1;
        }
    }

    #ids() {
        const ids = [];
        this.#set((id) => ids.push(id));
        return ids;
    }

    #set(visit) {
        let id = 0;
        for (let runs = this.#number(); runs > 0; --runs) {
            id += this.#number();
            for (let length = this.#number(); length > 0; --length) visit(id++);
        }
    }

    #signed() {
        return unfolded(this.#number());
    }

    #number() {
        let n = 0;
        for (let shift = 0; ; shift += 7) {
            const byte = this.bytes[this.state.position++];
            n |= (byte & 0x7f) << shift;
            if (!(byte & 0x80)) return n >>> 0;
        }
    }
}

/// Bytes from the text of an element of the page.
export function bytesOf(id) {
    const text = atob(document.getElementById(id).textContent.trim());
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return bytes;
}
