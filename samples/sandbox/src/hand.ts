// Tools of the hand: cut joints, draw a shape, put in boxes, balls, ragdolls and cars.
import * as decomposition from 'poly-decomp-es';
import simplify from 'simplify-js';
import {computeHull, makeBox, makePolygon, type JointId, type World} from './engine';
import {native} from './native';
import type {Point, Stage} from './stage';

const most_corners = 8; // of a convex piece
const most_pieces = 60;

export interface Hand {
    /// Whether the tool takes what the pointer does from here on.
    begin(point: Point): boolean;
    move(point: Point): void;
    end(): void;
    cancel(): void;
    /// Does with the tool what a pointer would do in the middle of the picture.
    use(): void;
    /// The line that is being drawn, and whether it will be closed.
    readonly stroke: readonly Point[];
}

// -- cutting ----------------------------------------------------------------------------------------------------------------------------

/// Twice the area on the left of a, b, c.
const turn = (a: Point, b: Point, c: Point) => (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
const cross = (a: Point, b: Point, c: Point, d: Point) => turn(a, b, c) * turn(a, b, d) < 0 && turn(c, d, a) * turn(c, d, b) < 0;

function distanceTo(p: Point, a: Point, b: Point): number {
    const x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
    const t = square === 0 ? 0 : Math.min(1, Math.max(0, ((p.x - a.x) * x + (p.y - a.y) * y) / square));
    return Math.hypot(a.x + t * x - p.x, a.y + t * y - p.y);
}

function* jointsOf(world: World): Iterable<{joint: JointId; a: Point; b: Point}> {
    const {joints} = world.capacity();
    for (let slot = 0; slot < joints; ++slot) {
        const joint = world.jointAt(slot);
        if (joint === 0) continue;
        const type = world.jointType(joint);
        if (type === 'gear' || type === 'mouse') continue;
        yield {joint, a: world.jointAnchorA(joint), b: world.jointAnchorB(joint)};
    }
}

/// The joints whose line a swipe crosses, or whose hinge it comes as near as this.
function jointsAcross(world: World, from: Point, to: Point, near: number): JointId[] {
    const across: JointId[] = [];
    for (const {joint, a, b} of jointsOf(world)) if (cross(from, to, a, b) || distanceTo(b, from, to) < near) across.push(joint);
    return across;
}

// -- drawing ----------------------------------------------------------------------------------------------------------------------------

/// The outline that a stroke encloses: the first loop if it crosses itself, else all of it, closed by a straight line.
function outlineOf(stroke: readonly Point[]): Point[] {
    for (let j = 2; j + 1 < stroke.length; ++j) {
        for (let i = j - 2; i >= 0; --i) {
            const a = stroke[i]!, b = stroke[i + 1]!, c = stroke[j]!, d = stroke[j + 1]!;
            if (!cross(a, b, c, d)) continue;
            const before = turn(a, b, c), after = turn(a, b, d), t = before / (before - after);
            return [{x: c.x + t * (d.x - c.x), y: c.y + t * (d.y - c.y)}, ...stroke.slice(i + 1, j + 1)];
        }
    }
    return [...stroke];
}

const areaOf = (outline: readonly Point[]) => outline.reduce((sum, p, i) => {
    const q = outline[(i + 1) % outline.length]!;
    return sum + 0.5 * (p.x * q.y - q.x * p.y);
}, 0);

/// The convex pieces of an outline, each of at most eight corners.
export function convexPieces(stroke: readonly Point[], tolerance: number): Point[][] {
    const outline = simplify(outlineOf(stroke), tolerance, true);
    const polygon = outline.map(({x, y}): [number, number] => [x, y]);
    decomposition.removeDuplicatePoints(polygon, tolerance / 2);
    decomposition.makeCCW(polygon);
    decomposition.removeCollinearPoints(polygon, 0.02);
    if (polygon.length < 3 || !decomposition.isSimple(polygon)) return [];
    const pieces: Point[][] = [];
    for (const convex of decomposition.quickDecomp(polygon)) {
        // Fans of what has more corners.
        const corners = convex.map(([x, y]) => ({x, y}));
        for (let i = 1; i + 1 < corners.length; i += most_corners - 2) pieces.push([corners[0]!, ...corners.slice(i, i + most_corners - 1)]);
    }
    const least = 1e-4 + 1e-3 * Math.abs(areaOf(outline)); // m^2: slivers weigh nothing and catch
    return pieces.filter((piece) => areaOf(piece) > least);
}

// -- the tools --------------------------------------------------------------------------------------------------------------------------

export function makeHand(stage: Stage): Hand {
    let stroke: Point[] = [];
    const size = () => Math.min(1, 26 / stage.camera.scale); // m, half of a box

    function putOne(point: Point) {
        const {world} = stage.running;
        const body = world.createBody({type: 'dynamic', position: point});
        try {
            if (stage.tool === 'box') world.createPolygon(body, makeBox(size(), size()));
            else world.createCircle(body, {center: {x: 0, y: 0}, radius: size()}, {restitution: 0.4});
        } catch (error) {
            world.destroyBody(body);
            throw error;
        }
    }

    function putShape(drawn: readonly Point[]) {
        const pieces = convexPieces(drawn, 4 / stage.camera.scale);
        if (pieces.length === 0) return stage.say('Draw an outline: what it encloses becomes a body.');
        if (pieces.length > most_pieces) return stage.say(`This outline has ${pieces.length} convex pieces, and a body may have ${most_pieces}: draw a plainer one.`);
        const {world} = stage.running;
        const all = pieces.flat();
        const middle = {x: all.reduce((sum, {x}) => sum + x, 0) / all.length, y: all.reduce((sum, {y}) => sum + y, 0) / all.length};
        const body = world.createBody({type: 'dynamic', position: middle});
        try {
            for (const piece of pieces) {
                world.createPolygon(body, makePolygon(computeHull(piece.map(({x, y}) => ({x: x - middle.x, y: y - middle.y}))), 0));
            }
        } catch (error) {
            world.destroyBody(body);
            throw error;
        }
    }

    function cut(from: Point, to: Point) {
        const {world} = stage.running;
        const joints = jointsAcross(world, from, to, 6 / stage.camera.scale);
        if (joints.length === 0) return;
        stage.resume();
        for (const joint of joints) {
            if (!world.jointIsValid(joint)) continue; // a gear goes with what it couples
            const ends = [world.jointBodyA(joint), world.jointBodyB(joint)];
            world.destroyJoint(joint);
            for (const body of ends) if (world.bodyType(body) === 'dynamic') world.bodyWake(body);
        }
    }

    function put(point: Point) {
        stage.resume();
        stage.attempt(() => {
            if (stage.tool === 'doll') native.sandbox_spawn_doll(0, point.x, point.y);
            else if (stage.tool === 'car') native.sandbox_spawn_car(0, point.x, point.y);
            else putOne(point);
            stage.running.world.stepCount(); // throws what the engine said
        });
    }

    return {
        get stroke() {
            return stroke;
        },
        begin(point) {
            if (stage.tool === 'drag') return false;
            stroke = [];
            if (stage.tool === 'cut' || stage.tool === 'shape') stroke = [point];
            else put(point);
            return true;
        },
        move(point) {
            const last = stroke.at(-1);
            if (last === undefined || Math.hypot(point.x - last.x, point.y - last.y) < 3 / stage.camera.scale) return;
            if (stage.tool === 'cut') stage.attempt(() => cut(last, point));
            if (stroke.length < 2000) stroke.push(point);
            if (stage.tool === 'cut' && stroke.length > 12) stroke.shift();
        },
        end() {
            const drawn = stroke;
            stroke = [];
            if (stage.tool !== 'shape' || drawn.length === 0) return;
            stage.resume();
            stage.attempt(() => putShape(drawn));
        },
        cancel() {
            stroke = [];
        },
        use() {
            const {camera} = stage, {world} = stage.running;
            if (stage.tool === 'cut') {
                const from = ({a, b}: {a: Point; b: Point}) => Math.min(...[a, b].map(({x, y}) => Math.hypot(x - camera.x, y - camera.y)));
                const nearest = [...jointsOf(world)].sort((one, other) => from(one) - from(other))[0];
                if (nearest === undefined) stage.say('There is no joint to cut.');
                else cut(nearest.a, nearest.b);
            } else if (stage.tool === 'shape') {
                stage.resume();
                stage.attempt(() => putShape(Array.from({length: 10}, (_, i) => {
                    const angle = Math.PI * (0.5 + i / 5), radius = (i % 2 === 0 ? 2 : 0.9) * size();
                    return {x: camera.x + radius * Math.cos(angle), y: camera.y + radius * Math.sin(angle)};
                })));
            } else if (stage.tool !== 'drag') {
                put(camera);
            }
        },
    };
}
