// Builds a scene, as sandbox_describe tells it, by the package's own functions.
const vector = ([x, y] = [0, 0]) => ({x, y});
const camel = (name) => name.replace(/_./g, (two) => two[1].toUpperCase());

/** Lists of two numbers are vectors, and names are in camel case. */
function plain(value) {
    if (Array.isArray(value)) return vector(value);
    if (value === null || typeof value !== 'object') return value;
    return Object.fromEntries(Object.entries(value).map(([name, inner]) => [camel(name), plain(inner)]));
}

export class IsletWorld {
    constructor(Islet, scene, more = {bodies: 0, shapes: 0, joints: 0}) {
        this.Islet = Islet;
        const count = (list, of) => list.reduce((sum, item) => sum + of(item), 0);
        const shapes = count(scene.bodies, (body) => count(body.shapes, (shape) => shape.chain?.points.length ?? 1)) + more.shapes;
        const bodies = scene.bodies.length + more.bodies;
        const capacity = {bodies, shapes, contacts: 8 * bodies + 1024, joints: scene.joints.length + more.joints};
        this.world = new Islet.World({...plain(scene.world ?? {}), capacity});
        this.dt = scene.dt ?? 1 / 60;
        this.bodies = scene.bodies.map((body) => this.createBody(body));
        for (const joint of scene.joints) this.createJoint(joint);
    }
    step() {
        this.world.step(this.dt);
    }
    createBody({shapes, ...def}) {
        const {Islet, world} = this;
        const body = world.createBody(plain(def));
        for (const {circle, capsule, segment, polygon, chain, half_space, ...rest} of shapes) {
            const shape = plain(rest);
            if (circle) world.createCircle(body, {center: vector(circle.center), radius: circle.radius ?? 0.5}, shape);
            else if (capsule) world.createCapsule(body, {point1: vector(capsule.point1), point2: vector(capsule.point2), radius: capsule.radius}, shape);
            else if (segment) world.createSegment(body, {point1: vector(segment.point1), point2: vector(segment.point2)}, shape);
            else if (chain) world.createChain(body, chain.points.map(vector), chain.loop ?? false, shape);
            else if (half_space) throw new Error('the bench has no half-spaces');
            else world.createPolygon(body, Islet.makePolygon(Islet.computeHull(polygon.points.map(vector)), polygon.radius ?? 0), shape);
        }
        return body;
    }
    createJoint({type, body_a, body_b, ...def}) {
        const name = type[0].toUpperCase() + type.slice(1);
        this.world[`create${name}Joint`]({bodyA: this.bodies[body_a], bodyB: this.bodies[body_b], ...plain(def)});
    }
    destroyBody(body) {
        this.world.destroyBody(body);
    }
    destroy() {
        this.world.destroy();
    }
    get counts() {
        return `${this.world.bodyCount()} bodies, ${this.world.jointCount()} joints`;
    }
    height() {
        return this.bodies.reduce((sum, body) => sum + (this.world.bodyIsValid(body) ? this.world.bodyPosition(body).y : 0), 0);
    }
}
