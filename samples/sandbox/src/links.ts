// Draws joints by WebGL: an instance is a line between two points of two bodies, whose poses the graphics processor knows already.
import {slotOf, type JointId, type World} from './engine';
import {colorParts, find_pose, makeProgram, type Program} from './program';

const vertex_source = `${find_pose}
layout(location = 0) in vec2 corner;
layout(location = 1) in vec4 points; // m, in the first body and in the second
layout(location = 2) in uvec2 slots;
uniform vec2 wide; // pixels: half of the line, and the dot at its second end
out vec2 along;
flat out float far;
void main() {
    vec2 a = pixel_of(texelFetch(poses, place_of(slots.x), 0), points.xy), b = pixel_of(texelFetch(poses, place_of(slots.y), 0), points.zw);
    far = distance(a, b);
    vec2 way = far > 0.01 ? (b - a) / far : vec2(1, 0);
    float room = wide.y + 1.0;
    along = vec2(corner.x < 0.0 ? -room : far + room, corner.y * room);
    gl_Position = on_screen(a + way * along.x + vec2(-way.y, way.x) * along.y);
}`;

const fragment_source = `
in vec2 along;
flat in float far;
uniform vec2 wide;
uniform vec4 color;
out vec4 shown;
void main() {
    float line = wide.x - length(vec2(along.x - clamp(along.x, 0.0, far), along.y)), dot_ = wide.y - length(vec2(along.x - far, along.y));
    shown = vec4(color.rgb, clamp(max(line, dot_) + 0.5, 0.0, 1.0));
}`;

/// Joints of these types join a point of a body to a point of another; a page draws the rest by itself.
const simple = new Set(['revolute', 'prismatic', 'distance', 'weld', 'wheel']);
const most_dots = 2000; // more would hide the bodies

export class Links {
    private readonly array: WebGLVertexArrayObject;
    private readonly buffers: WebGLBuffer[];
    private joints: JointId[] = []; // by slot
    private count = 0; // of instances

    private constructor(private readonly gl: WebGL2RenderingContext, private readonly program: Program) {
        this.array = gl.createVertexArray();
        this.buffers = [0, 1, 2].map(() => gl.createBuffer());
        gl.bindVertexArray(this.array);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[0]!);
        gl.bufferData(gl.ARRAY_BUFFER, new Float32Array([-1, -1, 1, -1, -1, 1, 1, 1]), gl.STATIC_DRAW);
        gl.vertexAttribPointer(0, 2, gl.FLOAT, false, 0, 0);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[1]!);
        gl.vertexAttribPointer(1, 4, gl.FLOAT, false, 0, 0);
        gl.bindBuffer(gl.ARRAY_BUFFER, this.buffers[2]!);
        gl.vertexAttribIPointer(2, 2, gl.UNSIGNED_INT, 0, 0);
        for (const at of [0, 1, 2]) gl.enableVertexAttribArray(at);
        for (const at of [1, 2]) gl.vertexAttribDivisor(at, 1);
        gl.bindVertexArray(null);
    }

    static make(gl: WebGL2RenderingContext): Links | undefined {
        const program = makeProgram(gl, vertex_source, fragment_source, ['camera', 'size', 'poses', 'wide', 'color']);
        return program === undefined ? undefined : new Links(gl, program);
    }

    static draws(type: string) {
        return simple.has(type);
    }

    forget() {
        this.joints = [];
    }

    /// The texture of poses is that of unit 0.
    draw(world: World, camera: readonly [number, number, number, number], width: number, height: number, color: string) {
        this.find(world);
        if (this.count === 0) return;
        const {gl, program: {program, at}} = this;
        const [scale, , , ratio] = camera;
        const half = Math.min(0.75 * ratio, Math.max(0.25, scale / 60));
        gl.useProgram(program);
        gl.uniform1i(at.poses!, 0);
        gl.uniform4f(at.camera!, ...camera);
        gl.uniform2f(at.size!, width, height);
        gl.uniform2f(at.wide!, half, this.count < most_dots ? Math.min(1.8 * ratio, scale / 30) + half : half);
        gl.uniform4f(at.color!, ...colorParts(color));
        gl.bindVertexArray(this.array);
        gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, this.count);
        gl.bindVertexArray(null);
    }

    private find(world: World) {
        const {gl, joints, buffers} = this;
        const {joints: capacity} = world.capacity(), all = world.jointCount();
        let changed = joints.length !== capacity;
        joints.length = capacity;
        for (let slot = 0, found = 0; slot < capacity; ++slot) {
            const joint = found < all ? world.jointAt(slot) : 0;
            if (joint !== 0) ++found;
            if (joints[slot] === joint) continue;
            joints[slot] = joint;
            changed = true;
        }
        if (!changed) return;
        const shown = joints.filter((joint) => joint !== 0 && simple.has(world.jointType(joint)));
        this.count = shown.length;
        const points = new Float32Array(4 * shown.length), slots = new Uint32Array(2 * shown.length);
        shown.forEach((joint, i) => {
            const a = world.jointFrameA(joint).position, b = world.jointFrameB(joint).position;
            points.set([a.x, a.y, b.x, b.y], 4 * i);
            slots.set([slotOf(world.jointBodyA(joint)), slotOf(world.jointBodyB(joint))], 2 * i);
        });
        [points, slots].forEach((data, i) => {
            gl.bindBuffer(gl.ARRAY_BUFFER, buffers[1 + i]!);
            gl.bufferData(gl.ARRAY_BUFFER, data, gl.DYNAMIC_DRAW);
        });
    }
}
