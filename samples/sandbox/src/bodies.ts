// Draws all bodies by WebGL: bodies of the same shapes are instances of one mesh. Poses go from the engine's memory to a texture as they are.
//
// A triangle knows how far each of its points is inside the body, which gives smooth rims and strokes of the same width at every scale:
//
//     depth = radius - |q|       flat side: q = (depth of the middle - depth, 0)       round corner: q = from the middle of its circle
import {type BodyId, type World} from './engine';
import {Links} from './links';
import {colorBits, colorParts, find_pose, makeProgram, row, type Program} from './program';

type Point = {x: number; y: number};

const place = 0, reach = 1, bend = 2, slot = 3; // attributes
const floats = 10; // of a vertex: position, push, q, growth of q, radius, kind
const kinds = {plain: 0, spoke: 1, line: 2} as const;

const vertex_source = `${find_pose}
layout(location = 0) in vec4 place; // m, in the body; pixels outwards
layout(location = 1) in vec4 reach; // q (m), and what it grows by for each pixel outwards
layout(location = 2) in vec2 bend;  // radius (m), kind
layout(location = 3) in uint slot;
uniform highp sampler2D colors;
out vec3 depth; // q and radius, in pixels
out vec4 color;
flat out int kind;
void main() {
    vec4 pose = texelFetch(poses, place_of(slot), 0);
    kind = int(bend.y);
    float wide = kind == ${kinds.line} ? camera.w : 0.5;
    depth = kind == ${kinds.line} ? vec3(reach.xy * wide, bend.x * wide) : vec3(camera.x * reach.xy + reach.zw * wide, camera.x * bend.x);
    color = texelFetch(colors, place_of(slot), 0);
    gl_Position = on_screen(pixel_of(pose, place.xy) + mat2(pose.z, pose.w, -pose.w, pose.z) * place.zw * wide);
}`;

const fragment_source = `
in vec3 depth;
in vec4 color;
flat in int kind;
uniform vec4 edge;
uniform float stroke; // pixels
out vec4 shown;
void main() {
    float inside = depth.z - length(depth.xy);
    float dark = kind == ${kinds.line} ? 0.0 : clamp(stroke + 0.5 - inside, 0.0, 1.0);
    if (kind == ${kinds.spoke} && depth.x > 0.0) dark = max(dark, clamp(0.5 * stroke + 0.5 - abs(depth.y), 0.0, 1.0));
    shown = vec4(mix(color.rgb, edge.rgb, dark * edge.a * min(stroke, 1.0)), clamp(inside + 0.5, 0.0, 1.0));
}`;

interface Mesh {
    first: number; // vertex
    count: number;
    slots: number[];
}

export interface Look {
    scale: number; // pixels per metre
    left: number; // pixels, where the world's origin is
    bottom: number;
    ratio: number; // pixels of a unit of length of the page
    paper: string;
    edge: string;
    joint: string; // empty: no joints
    colorOf(state: number, slot: number): string;
}

/// Where the processor does what a graphics processor should, a canvas's own outlines are faster.
function isSlow(gl: WebGL2RenderingContext): boolean {
    const names = gl.getExtension('WEBGL_debug_renderer_info');
    return names !== null && /SwiftShader|llvmpipe|Software|Basic Render/i.test(String(gl.getParameter(names.UNMASKED_RENDERER_WEBGL)));
}

export class Bodies {
    private readonly gl: WebGL2RenderingContext | null;
    private program: Program | undefined; // undefined while there is no context
    private links: Links | undefined;
    private meshes = new Map<string, Mesh>();
    private vertices: number[] = [];
    private bodies: BodyId[] = []; // by slot; 0: none
    private meshOf: (Mesh | undefined)[] = [];
    private colors = new Uint32Array(0); // by slot
    private textureRows = 0;
    private readonly buffers: Record<string, WebGLBuffer> = {};

    /// The canvas is left as it is if there is no WebGL.
    constructor(readonly canvas: HTMLCanvasElement) {
        // What is drawn stays: a picture can be taken of it at any time.
        const options: WebGLContextAttributes = {alpha: false, antialias: false, depth: false, preserveDrawingBuffer: true, failIfMajorPerformanceCaveat: true};
        const gl = canvas.getContext('webgl2', options) as WebGL2RenderingContext | null;
        this.gl = gl === null || isSlow(gl) ? null : gl;
        this.begin();
        canvas.addEventListener('webglcontextlost', (event) => {
            event.preventDefault(); // it may come back
            this.program = undefined;
        });
        canvas.addEventListener('webglcontextrestored', () => this.begin());
    }

    get works() {
        return this.gl !== null;
    }

    /// False where there is no WebGL, or none at the moment: nothing is drawn.
    draw(world: World, poses: Float32Array, states: Uint8Array, width: number, height: number, look: Look): boolean {
        const {gl, canvas} = this;
        if (gl === null || this.program === undefined || gl.isContextLost()) return false;
        if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
        // Poses first: to look at shapes may move the engine's memory.
        const rows = Math.ceil(world.slotCount / row);
        const grows = rows > this.textureRows;
        this.textureRows = Math.max(rows, this.textureRows);
        this.upload(0, gl.RGBA32F, gl.FLOAT, poses, world.slotCount, grows);
        this.assign(world, states.slice(0, world.slotCount), look);
        this.upload(1, gl.RGBA8, gl.UNSIGNED_BYTE, new Uint8Array(this.colors.buffer), world.slotCount, grows);
        gl.viewport(0, 0, width, height);
        gl.clearColor(...colorParts(look.paper));
        gl.clear(gl.COLOR_BUFFER_BIT);
        const camera = [look.scale, look.left, height - look.bottom, look.ratio] as const;
        const {program, at} = this.program;
        gl.useProgram(program);
        gl.uniform4f(at.camera!, ...camera);
        gl.uniform2f(at.size!, width, height);
        gl.uniform4f(at.edge!, ...colorParts(look.edge));
        gl.uniform1f(at.stroke!, Math.min(1.2 * look.ratio, 0.05 * look.scale));
        let from = 0;
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers.slots!);
        for (const {first, count, slots} of this.meshes.values()) {
            if (slots.length === 0) continue;
            gl.vertexAttribIPointer(slot, 1, gl.UNSIGNED_INT, 4, 4 * from);
            gl.drawArraysInstanced(gl.TRIANGLES, first, count, slots.length);
            from += slots.length;
        }
        if (look.joint !== '') this.links?.draw(world, camera, width, height, look.joint);
        return true;
    }

    /// The bodies' shapes may have changed while their ids have not.
    forget() {
        this.bodies = [];
        this.meshOf = [];
        this.vertices = [];
        this.meshes.clear();
        this.links?.forget();
    }

    // -- WebGL --------------------------------------------------------------------------------------------------------------------------

    private begin() {
        const {gl} = this;
        if (gl === null) return;
        const made = makeProgram(gl, vertex_source, fragment_source, ['camera', 'size', 'edge', 'stroke', 'poses', 'colors']);
        if (made === undefined) return; // the other painter serves
        gl.useProgram(made.program);
        ['poses', 'colors'].forEach((name, unit) => {
            gl.activeTexture(gl.TEXTURE0 + unit);
            gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
            for (const filter of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, filter, gl.NEAREST);
            gl.uniform1i(made.at[name]!, unit);
        });
        gl.enable(gl.BLEND);
        gl.blendFuncSeparate(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA, gl.ONE, gl.ONE);
        for (const name of ['vertices', 'slots']) this.buffers[name] = gl.createBuffer();
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers.vertices!);
        for (const [at, size, offset] of [[place, 4, 0], [reach, 4, 16], [bend, 2, 32]] as const) {
            gl.enableVertexAttribArray(at);
            gl.vertexAttribPointer(at, size, gl.FLOAT, false, 4 * floats, offset);
        }
        gl.enableVertexAttribArray(slot);
        gl.vertexAttribDivisor(slot, 1);
        this.textureRows = 0;
        this.program = made;
        this.links = Links.make(gl);
        this.forget();
    }

    /// Four numbers of each body go to the texture of a unit.
    private upload(unit: number, inside: number, type: number, data: Float32Array | Uint8Array, count: number, grows: boolean) {
        const gl = this.gl!;
        const whole = Math.floor(count / row), rest = count - whole * row;
        gl.activeTexture(gl.TEXTURE0 + unit);
        if (grows) gl.texImage2D(gl.TEXTURE_2D, 0, inside, row, this.textureRows, 0, gl.RGBA, type, null);
        if (whole > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, row, whole, gl.RGBA, type, data);
        if (rest > 0) gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, whole, rest, 1, gl.RGBA, type, data, 4 * whole * row);
    }

    /// Finds the mesh and the colour of each body.
    private assign(world: World, states: Uint8Array, look: Look) {
        const {bodies, meshOf} = this, {slotCount} = world;
        if (this.colors.length < slotCount) this.colors = new Uint32Array(Math.ceil(slotCount / row) * row);
        const vertices = this.vertices.length;
        let changed = bodies.length !== slotCount;
        bodies.length = meshOf.length = slotCount;
        for (let at = 0; at < slotCount; ++at) {
            const state = states[at]!;
            const body = state === 0 ? 0 : world.bodyAt(at);
            if (body !== bodies[at]) {
                changed = true;
                bodies[at] = body;
                meshOf[at] = body === 0 ? undefined : this.meshFor(world, body);
            }
            if (body !== 0) this.colors[at] = colorBits(look.colorOf(state, at));
        }
        const {gl, buffers} = this;
        if (vertices !== this.vertices.length) {
            gl!.bindBuffer(gl!.ARRAY_BUFFER, buffers.vertices!);
            gl!.bufferData(gl!.ARRAY_BUFFER, new Float32Array(this.vertices), gl!.STATIC_DRAW);
        }
        if (!changed) return;
        for (const mesh of this.meshes.values()) mesh.slots = [];
        meshOf.forEach((mesh, at) => mesh?.slots.push(at));
        gl!.bindBuffer(gl!.ARRAY_BUFFER, buffers.slots!);
        gl!.bufferData(gl!.ARRAY_BUFFER, new Uint32Array([...this.meshes.values()].flatMap(({slots}) => slots)), gl!.DYNAMIC_DRAW);
    }

    // -- meshes -------------------------------------------------------------------------------------------------------------------------

    private meshFor(world: World, body: BodyId): Mesh {
        const all = world.bodyShapes(body).map((shape) => {
            const type = world.shapeType(shape);
            switch (type) {
                case 'circle': return {type, ...world.shapeCircle(shape)!};
                case 'capsule': return {type, ...world.shapeCapsule(shape)!};
                case 'polygon': return {type, ...world.shapePolygon(shape)!};
                case 'segment': return {type, ...world.shapeSegment(shape)!};
                case 'chainSegment': return {type: 'segment' as const, ...world.shapeChainSegment(shape)!.segment};
                default: return {type: 'halfSpace' as const, ...world.shapeHalfSpace(shape)!};
            }
        });
        const key = JSON.stringify(all);
        let mesh = this.meshes.get(key);
        if (mesh !== undefined) return mesh;
        const pen = new Pen(this.vertices);
        const first = this.vertices.length / floats;
        for (const shape of all) {
            switch (shape.type) {
                case 'circle': pen.circle(shape.center, shape.radius); break;
                case 'capsule': pen.polygon([shape.point1, shape.point2], sides(shape.point1, shape.point2), shape.radius); break;
                case 'polygon': pen.polygon(shape.vertices, shape.normals, shape.radius); break;
                case 'segment': pen.line(shape.point1, shape.point2); break;
                case 'halfSpace': pen.halfSpace(shape.normal, shape.offset); break;
            }
        }
        mesh = {first, count: this.vertices.length / floats - first, slots: []};
        this.meshes.set(key, mesh);
        return mesh;
    }
}

/// The normals of a capsule's two sides.
function sides(a: Point, b: Point): Point[] {
    const length = Math.hypot(b.x - a.x, b.y - a.y) || 1;
    const right = {x: (b.y - a.y) / length, y: (a.x - b.x) / length};
    return [right, {x: -right.x, y: -right.y}];
}

const none = {x: 0, y: 0};
const add = (p: Point, q: Point, by = 1): Point => ({x: p.x + by * q.x, y: p.y + by * q.y});

class Pen {
    constructor(private readonly out: number[]) {}

    private put(at: Point, push: Point, q: Point, grow: Point, radius: number, kind: number) {
        this.out.push(at.x, at.y, push.x, push.y, q.x, q.y, grow.x, grow.y, radius, kind);
    }

    circle(center: Point, radius: number) {
        const [a, b, c, d] = [[-1, -1], [1, -1], [1, 1], [-1, 1]].map(([x, y]) => ({x: x!, y: y!})) as [Point, Point, Point, Point];
        for (const corner of [a, b, c, a, c, d]) {
            this.put(add(center, corner, radius), corner, {x: radius * corner.x, y: radius * corner.y}, corner, radius, kinds.spoke);
        }
    }

    /// Convex, counter-clockwise, with a skin of a radius; of two points it is a capsule.
    polygon(points: readonly Point[], normals: readonly Point[], radius: number) {
        const count = points.length;
        const normal = (i: number) => normals[(i + count) % count]!, point = (i: number) => points[i % count]!;
        const tips = points.map((_, i) => mitre(normal(i - 1), normal(i)));
        // As deep as all sides can move inwards before one of them vanishes.
        const deepest = Math.min(...points.map((p, i) => {
            const side = add(point(i + 1), p, -1), shrinks = add(tips[(i + 1) % count]!, tips[i]!, -1);
            return (side.x ** 2 + side.y ** 2) / Math.max(1e-9, shrinks.x * side.x + shrinks.y * side.y);
        }));
        const inset = count < 3 ? 0 : deepest, deep = radius + inset;
        const inner = points.map((p, i) => add(p, tips[i]!, -inset));
        const at = (p: Point, depth: number, push = none) => {
            this.put(p, push, {x: deep - depth, y: 0}, push === none ? none : {x: 1, y: 0}, deep, kinds.plain);
        };
        /// A strip between two lines along a side.
        const strip = (a: Point, b: Point, depth: number, c: Point, d: Point, depth2: number, pushC = none, pushD = none) => {
            at(a, depth), at(c, depth2, pushC), at(d, depth2, pushD);
            at(a, depth), at(d, depth2, pushD), at(b, depth);
        };
        points.forEach((p, i) => {
            const next = point(i + 1), n = normal(i), j = (i + 1) % count;
            if (i > 1) at(inner[0]!, deep), at(inner[i - 1]!, deep), at(inner[i]!, deep);
            if (radius === 0) return strip(inner[i]!, inner[j]!, deep, p, next, 0, tips[i], tips[j]);
            if (inset > 0) strip(inner[i]!, inner[j]!, deep, p, next, radius);
            strip(p, next, radius, add(p, n, radius), add(next, n, radius), 0, n, n);
            this.corner(p, normal(i - 1), n, radius);
        });
    }

    /// The round corner between two sides, in as many pieces as keep their tips near.
    private corner(p: Point, before: Point, after: Point, radius: number) {
        const cosine = before.x * after.x + before.y * after.y;
        if (cosine < -0.1) {
            const turned = {x: before.x - before.y, y: before.y + before.x}, length = Math.hypot(turned.x, turned.y);
            const between = {x: turned.x / length, y: turned.y / length};
            this.corner(p, before, between, radius);
            this.corner(p, between, after, radius);
            return;
        }
        const tip = mitre(before, after);
        for (const [a, b] of [[before, tip], [tip, after]] as const) {
            for (const q of [none, a, b]) this.put(add(p, q, radius), q, {x: radius * q.x, y: radius * q.y}, q, radius, kinds.plain);
        }
    }

    line(a: Point, b: Point) {
        const [n] = sides(a, b) as [Point];
        const half = 1.25;
        const at = (p: Point, side: number) => this.put(p, {x: side * half * n.x, y: side * half * n.y}, {x: 0, y: side * half}, none, half - 0.5, kinds.line);
        for (const [p, side] of [[a, 1], [b, 1], [b, -1], [a, 1], [b, -1], [a, -1]] as const) at(p, side);
    }

    halfSpace(normal: Point, offset: number) {
        const far = 1000, along = {x: -normal.y, y: normal.x}, on = {x: normal.x * offset, y: normal.y * offset};
        const at = (side: number, deep: number) => {
            const push = deep === 0 ? normal : none;
            this.put(add(add(on, along, side * far), normal, -deep), push, {x: far - deep, y: 0}, push === none ? none : {x: 1, y: 0}, far, kinds.plain);
        };
        for (const [side, deep] of [[-1, 0], [1, 0], [1, far], [-1, 0], [1, far], [-1, far]] as const) at(side, deep);
    }
}

/// Where two sides that are moved outwards by 1 meet.
function mitre(a: Point, b: Point): Point {
    const scale = 1 / Math.max(0.3, 1 + a.x * b.x + a.y * b.y);
    return {x: (a.x + b.x) * scale, y: (a.y + b.y) * scale};
}
