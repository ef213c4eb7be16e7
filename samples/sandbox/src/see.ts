// What can be seen beside the bodies: drawn over them by what the engine's debug drawing tells.
import type {BodyId, World} from './engine';
import type {Hand} from './hand';
import {drawn, native} from './native';
import type {Player} from './play';
import {find, make, type Point, type Stage} from './stage';

const kinds = {
    impulses: 'Impulses',
    islands: 'Islands',
    colours: 'Colours',
    forces: 'Joint force',
    boxes: 'Boxes',
    sleeping: 'Sleeping',
    stops: 'Stops',
    heat: 'Residual',
} as const;
const titles: Record<Kind, string> = {
    impulses: 'Impulses of contacts over the last substep, along the normal and along the surface',
    islands: 'Bodies that touch or are joined have one colour: the solver solves each island by itself',
    colours: 'Contacts and joints in their constraint colours: those of one colour share no body, and are solved at once',
    forces: 'Force of each joint on its second body',
    boxes: 'The bounding box of each shape',
    sleeping: 'A z on each body that sleeps',
    stops: 'Where continuous collision held fast bodies back, for a second',
    heat: 'How far the impulses of each island are from a solution, from blue (a micrometre a second) to red (a decimetre)',
};
type Kind = keyof typeof kinds;

// As in see.cpp and in DrawPart.
const [polygon, circle, capsule, segment] = [0, 1, 2, 3];
const shape_part = 0, box_part = 1, joint_part = 4, impulse_part = 7;
const longest = 70; // pixels, of the largest arrow that is seen

export const hex = (color: number) => `#${color.toString(16).padStart(6, '0')}`;

/// From blue at 1e-6 m/s over green to red at 0.1 m/s.
function heatOf(residual: number): string {
    const share = Math.min(1, Math.max(0, (Math.log10(Math.max(residual, 1e-9)) + 6) / 5));
    return `hsl(${240 - 240 * share} 85% 50%)`;
}

export interface Overlay {
    begin(): void;
    draw(): void;
    /// Whether the residual must be measured.
    readonly measures: boolean;
}

export function makeOverlay(stage: Stage, hand: Hand, player: Player): Overlay {
    const canvas = make('canvas', {id: 'overlay', ariaHidden: 'true'});
    stage.canvas.after(canvas);
    const context = canvas.getContext('2d')!;
    const on = new Set<Kind>();
    const boxes = find('see');
    for (const kind of Object.keys(kinds) as Kind[]) {
        const input = make('input', {type: 'checkbox', id: `see-${kind}`});
        boxes.append(make('label', {title: titles[kind]}, input, ` ${kinds[kind]}`));
        input.addEventListener('change', () => {
            if (input.checked) on.add(kind);
            else on.delete(kind);
            if (kind === 'stops') native.sandbox_watch_stops(0, Number(input.checked));
        });
    }

    let ratio = 1, left = 0, bottom = 0, scale = 1;
    const x = (at: number) => left + at * scale, y = (at: number) => bottom - at * scale;

    function trace(kind: number, list: Float32Array, at: number): number {
        context.beginPath();
        if (kind === polygon) {
            const corners = list[at + 1]!;
            for (let i = 0; i < corners; ++i) context.lineTo(x(list[at + 2 + 2 * i]!), y(list[at + 3 + 2 * i]!));
            context.closePath();
            return at + 2 + 2 * corners;
        }
        if (kind === circle) {
            context.arc(x(list[at]!), y(list[at + 1]!), list[at + 2]! * scale, 0, 2 * Math.PI);
            return at + 3;
        }
        if (kind === capsule) {
            const [ax, ay, bx, by, radius] = list.subarray(at, at + 5) as unknown as [number, number, number, number, number];
            const angle = Math.atan2(ay - by, bx - ax);
            context.arc(x(ax), y(ay), radius * scale, angle + Math.PI / 2, angle - Math.PI / 2);
            context.arc(x(bx), y(by), radius * scale, angle - Math.PI / 2, angle + Math.PI / 2);
            context.closePath();
            return at + 5;
        }
        if (kind === segment) {
            context.moveTo(x(list[at]!), y(list[at + 1]!));
            context.lineTo(x(list[at + 2]!), y(list[at + 3]!));
            return at + 4;
        }
        context.rect(x(list[at]!) - 2 * ratio, y(list[at + 1]!) - 2 * ratio, 4 * ratio, 4 * ratio);
        return at + 2;
    }

    function drawList(world: World, view: [number, number, number, number]) {
        const fills = on.has('islands') || on.has('heat');
        const what = (on.has('heat') ? 1 : 0) | (on.has('islands') ? 2 : 0) | (on.has('colours') ? 4 | 16 : 0) | (on.has('impulses') ? 8 : 0) | (on.has('boxes') ? 32 : 0);
        if (what === 0) return;
        const list = drawn(native.sandbox_draw(0, what, ...view, 1));
        const heats: string[] = [];
        let largest = 0;
        for (const pass of on.has('impulses') ? ['measure', 'draw'] : ['draw']) {
            for (let at = 0; at < list.length;) {
                const kind = list[at]!, color = list[at + 1]!, part = list[at + 2]!, slot = list[at + 3]!;
                at += 4;
                if (part === impulse_part && kind === segment) {
                    const [ax, ay, bx, by] = list.subarray(at, at + 4) as unknown as [number, number, number, number];
                    const length = Math.hypot(bx - ax, by - ay);
                    at += 4;
                    if (pass === 'measure') largest = Math.max(largest, length);
                    else if (length > 0.01 * largest) arrow(ax, ay, bx - ax, by - ay, longest / largest, hex(color));
                    continue;
                }
                const radius = kind === polygon ? list[at]! : 0;
                if (pass === 'measure') {
                    at += kind === polygon ? 2 + 2 * list[at + 1]! : [0, 3, 5, 4, 2][kind]!;
                    continue;
                }
                at = trace(kind, list, at);
                if (part === shape_part) {
                    if (!fills) continue;
                    const body = world.bodyAt(slot);
                    if (world.bodyType(body) === 'staticBody') continue;
                    context.fillStyle = on.has('heat') && !on.has('islands') ? (heats[slot] ??= heatOf(world.bodyResidual(body))) : hex(color);
                    context.fill();
                    if (radius > 0) {
                        context.lineWidth = 2 * radius * scale;
                        context.lineJoin = 'round';
                        context.strokeStyle = context.fillStyle;
                        context.stroke();
                    }
                } else {
                    context.lineWidth = part === joint_part ? 3 * ratio : ratio;
                    context.strokeStyle = context.fillStyle = hex(color);
                    if (kind === segment || part === box_part || part === joint_part) context.stroke();
                    else context.fill();
                }
            }
        }
    }

    /// `pixels` for each unit of its length.
    function arrow(ax: number, ay: number, dx: number, dy: number, pixels: number, color: string) {
        const fromX = x(ax), fromY = y(ay), toX = fromX + dx * pixels * ratio, toY = fromY - dy * pixels * ratio;
        const angle = Math.atan2(toY - fromY, toX - fromX), head = Math.min(7 * ratio, Math.hypot(toX - fromX, toY - fromY) / 2);
        context.beginPath();
        context.moveTo(fromX, fromY);
        context.lineTo(toX, toY);
        for (const side of [-2.6, 2.6]) {
            context.moveTo(toX, toY);
            context.lineTo(toX + head * Math.cos(angle + side), toY + head * Math.sin(angle + side));
        }
        context.lineWidth = 1.8 * ratio;
        context.strokeStyle = color;
        context.stroke();
    }

    function drawForces(world: World) {
        const found: {at: Point; force: Point; size: number}[] = [];
        const {joints} = world.capacity();
        for (let slot = 0, seen = 0; slot < joints && seen < world.jointCount(); ++slot) {
            const joint = world.jointAt(slot);
            if (joint === 0) continue;
            ++seen;
            const force = world.jointForce(joint);
            found.push({at: world.jointAnchorB(joint), force, size: Math.hypot(force.x, force.y)});
        }
        const largest = Math.max(...found.map(({size}) => size), 1e-9);
        for (const {at, force, size} of found) if (size > 0.01 * largest) arrow(at.x, at.y, force.x, force.y, longest / largest, '#c4314b');
        const top = found.find(({size}) => size === largest);
        if (top !== undefined) write(`${largest.toPrecision(3)} N`, x(top.at.x) + 6 * ratio, y(top.at.y) - 6 * ratio);
    }

    function write(text: string, atX: number, atY: number, size = 12) {
        context.font = `600 ${size * ratio}px system-ui, sans-serif`;
        context.lineWidth = 3 * ratio;
        context.lineJoin = 'round';
        context.strokeStyle = '#000a';
        context.fillStyle = '#fff';
        context.strokeText(text, atX, atY);
        context.fillText(text, atX, atY);
    }

    function drawSleeping(world: World) {
        let shown = 0;
        for (let slot = 0; slot < world.slotCount && shown < 2000; ++slot) {
            if ((world.states[slot]! & 15) !== 3) continue;
            const {x: atX, y: atY} = world.bodyCenterOfMass(world.bodyAt(slot));
            write('z', x(atX) - 3 * ratio, y(atY) + 3 * ratio, 11);
            ++shown;
        }
    }

    function drawStops() {
        const {step} = stage.running;
        const list = drawn(3 * native.sandbox_stops(0));
        context.lineWidth = 2 * ratio;
        for (let i = 0; i < list.length; i += 3) {
            context.strokeStyle = `rgb(216 60 40 / ${Math.max(0.15, 1 - (step - list[i + 2]!) / 60)})`;
            context.beginPath();
            context.arc(x(list[i]!), y(list[i + 1]!), 9 * ratio, 0, 2 * Math.PI);
            context.stroke();
        }
    }

    function drawFlag({x: atX, y: atY}: Point) {
        const height = 1.6 * scale, foot = y(atY), top = foot - height, width = 0.8 * scale;
        context.lineWidth = 2 * ratio;
        context.strokeStyle = '#7d5a3c';
        context.beginPath();
        context.moveTo(x(atX), foot);
        context.lineTo(x(atX), top);
        context.stroke();
        context.fillStyle = '#c4314b';
        context.beginPath();
        context.moveTo(x(atX), top);
        context.lineTo(x(atX) + width, top + 0.2 * height);
        context.lineTo(x(atX), top + 0.4 * height);
        context.fill();
    }

    function drawStroke() {
        const {stroke} = hand;
        if (stroke.length === 0) return;
        context.beginPath();
        for (const point of stroke) context.lineTo(x(point.x), y(point.y));
        context.lineWidth = 2.5 * ratio;
        context.strokeStyle = stage.tool === 'cut' ? '#d8452f' : '#1f7a68';
        context.stroke();
    }

    return {
        get measures() {
            return on.has('heat');
        },
        begin() {
            native.sandbox_watch_stops(0, Number(on.has('stops')));
        },
        draw() {
            const {camera} = stage, {world} = stage.running;
            const isUsed = on.size > 0 || player.goal !== undefined || hand.stroke.length > 0;
            if (canvas.hidden === isUsed) canvas.hidden = !isUsed;
            if (!isUsed) return;
            ratio = window.devicePixelRatio || 1;
            const width = Math.round(canvas.clientWidth * ratio), height = Math.round(canvas.clientHeight * ratio);
            if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, {width, height});
            else context.clearRect(0, 0, width, height);
            scale = camera.scale * ratio;
            left = width / 2 - camera.x * scale;
            bottom = height / 2 + camera.y * scale;
            const halfX = width / 2 / scale, halfY = height / 2 / scale;
            drawList(world, [camera.x - halfX, camera.y - halfY, camera.x + halfX, camera.y + halfY]);
            if (on.has('forces')) drawForces(world);
            if (on.has('sleeping')) drawSleeping(world);
            if (on.has('stops')) drawStops();
            if (player.goal !== undefined) drawFlag(player.goal);
            drawStroke();
        },
    };
}

// -- numbers of a body ------------------------------------------------------------------------------------------------------------------

/// In a box by the pointer, and of a body chosen by its number in the panel.
export function makeNumbers(stage: Stage): {draw(): void} {
    const hint = make('div', {id: 'numbers', hidden: true, ariaHidden: 'true'});
    document.body.append(hint);
    const input = make('input', {type: 'number', id: 'body-number', min: '0', step: '1', placeholder: 'none'});
    const output = make('output', {id: 'body-numbers'});
    output.setAttribute('for', 'body-number');
    find('see').after(make('div', {className: 'setting'}, make('label', {htmlFor: input.id, textContent: 'Numbers of body', title: 'A body\'s slot; or point at it'}), input), output);
    let pointer: {x: number; y: number} | undefined;
    stage.canvas.addEventListener('pointermove', (event) => {
        pointer = event.pointerType === 'mouse' && event.buttons === 0 ? {x: event.offsetX, y: event.offsetY} : undefined;
    });
    stage.canvas.addEventListener('pointerleave', () => (pointer = undefined));

    function describe(world: World, body: BodyId, slot: number): string {
        const {x, y} = world.bodyPosition(body), v = world.bodyLinearVelocity(body), type = world.bodyType(body);
        const degrees = (world.bodyAngle(body) * 180) / Math.PI;
        return [
            `body ${slot}, ${type === 'dynamic' && !world.bodyIsAwake(body) ? 'asleep' : type === 'staticBody' ? 'static' : type}`,
            type === 'dynamic' ? `${world.bodyMass(body).toPrecision(3)} kg` : '',
            `at ${x.toFixed(2)}, ${y.toFixed(2)} m, ${degrees.toFixed(0)}°`,
            `${Math.hypot(v.x, v.y).toFixed(2)} m/s, ${world.bodyAngularVelocity(body).toFixed(2)} rad/s`,
            world.solver().measureResidual && type === 'dynamic' ? `residual ${world.bodyResidual(body).toExponential(1)} m/s` : '',
        ].filter((line) => line !== '').join('\n');
    }

    return {
        draw() {
            const {world} = stage.running;
            const body = pointer === undefined ? 0 : stage.bodyAt(stage.camera.toWorld(pointer.x, pointer.y), 2 / stage.camera.scale);
            hint.hidden = body === 0;
            if (body !== 0 && pointer !== undefined) {
                hint.textContent = describe(world, body, body % 2 ** 20 - 1);
                const right = pointer.x + 230 > innerWidth;
                hint.style.setProperty('transform', `translate(${pointer.x + (right ? -210 : 16)}px, ${Math.min(pointer.y + 12, innerHeight - 110)}px)`);
            }
            const slot = input.value === '' ? NaN : Number(input.value);
            const chosen = slot >= 0 && slot < world.capacity().bodies ? world.bodyAt(Math.floor(slot)) : 0;
            const text = chosen !== 0 ? describe(world, chosen, slot) : input.value === '' ? '' : 'There is no such body.';
            if (output.textContent !== text) output.textContent = text;
        },
    };
}
