// A program of WebGL, and where its uniforms are.
export interface Program {
    readonly program: WebGLProgram;
    readonly at: Record<string, WebGLUniformLocation | null>;
}

/// Undefined if the shaders do not compile, for which a driver may have its reasons.
export function makeProgram(gl: WebGL2RenderingContext, vertex: string, fragment: string, uniforms: readonly string[]): Program | undefined {
    const program = gl.createProgram();
    for (const [type, source] of [[gl.VERTEX_SHADER, vertex], [gl.FRAGMENT_SHADER, fragment]] as const) {
        const shader = gl.createShader(type);
        if (shader === null) return undefined;
        gl.shaderSource(shader, `#version 300 es\nprecision highp float;\n${source}`);
        gl.compileShader(shader);
        gl.attachShader(program, shader);
    }
    gl.linkProgram(program);
    if (!gl.getProgramParameter(program, gl.LINK_STATUS)) return undefined;
    return {program, at: Object.fromEntries(uniforms.map((name) => [name, gl.getUniformLocation(program, name)]))};
}

/// Where a body's pose and colour stand in their textures, for shaders, and how much wider than high these are.
export const row = 1024;
export const find_pose = `
uniform highp sampler2D poses;
uniform vec4 camera; // pixels per metre, where the origin is (pixels), pixels of a unit of length of the page
uniform vec2 size;   // pixels
ivec2 place_of(uint slot) { return ivec2(int(slot) & ${row - 1}, int(slot) / ${row}); }
vec2 pixel_of(vec4 pose, vec2 point) { return camera.x * (pose.xy + mat2(pose.z, pose.w, -pose.w, pose.z) * point) + camera.yz; }
vec4 on_screen(vec2 pixel) { return vec4(2.0 * pixel / size - 1.0, 0, 1); }
`;

/// A colour of the style sheet, #rgb, #rgba, #rrggbb or #rrggbbaa, with red in the lowest byte.
export function colorBits(color: string): number {
    let value = known.get(color);
    if (value === undefined) {
        let digits = color.slice(1);
        if (digits.length < 6) digits = [...digits].map((digit) => digit + digit).join('');
        const [r, g, b, a = 255] = digits.match(/../g)!.map((two) => parseInt(two, 16)) as [number, number, number, number?];
        value = (r | g << 8 | b << 16 | a << 24) >>> 0;
        known.set(color, value);
    }
    return value;
}
const known = new Map<string, number>();

export function colorParts(color: string): [number, number, number, number] {
    const bits = colorBits(color);
    return [(bits & 255) / 255, (bits >> 8 & 255) / 255, (bits >> 16 & 255) / 255, (bits >>> 24) / 255];
}
