// Builds a scene, as sandbox_describe tells it, in Rapier of the package @dimforge/rapier2d-simd-compat. Enough for the bench: no chains, and hinges alone.
const turn = (angle) => 2 * Math.PI * angle;

export class RapierWorld {
    constructor(Rapier, scene) {
        this.Rapier = Rapier;
        const {gravity: [x, y] = [0, -10], enable_sleep = true} = scene.world ?? {};
        this.world = new Rapier.World({x, y});
        this.world.timestep = scene.dt ?? 1 / 60;
        this.sleeps = enable_sleep;
        this.bodies = scene.bodies.map((body) => this.createBody(body));
        for (const joint of scene.joints) this.createJoint(joint);
    }
    step() {
        this.world.step();
    }
    createBody({type = 'static', position: [x, y] = [0, 0], angle = 0, shapes, ...more}) {
        const {Rapier, world} = this;
        const make = {static: 'fixed', kinematic: 'kinematicVelocityBased', dynamic: 'dynamic'}[type];
        const [vx, vy] = more.linear_velocity ?? [0, 0];
        const def = Rapier.RigidBodyDesc[make]().setTranslation(x, y).setRotation(angle).setLinvel(vx, vy).setAngvel(more.angular_velocity ?? 0)
            .setLinearDamping(more.linear_damping ?? 0).setAngularDamping(more.angular_damping ?? 0).setCanSleep(this.sleeps && (more.enable_sleep ?? true));
        const body = world.createRigidBody(def);
        for (const shape of shapes) world.createCollider(this.collider(shape), body);
        return body;
    }
    collider(shape) {
        const {ColliderDesc} = this.Rapier;
        let def;
        if (shape.circle) {
            const [x, y] = shape.circle.center ?? [0, 0];
            def = ColliderDesc.ball(shape.circle.radius ?? 0.5).setTranslation(x, y);
        } else if (shape.capsule) {
            const {point1: [x1, y1] = [0, 0], point2: [x2, y2] = [0, 0], radius} = shape.capsule;
            def = ColliderDesc.capsule(Math.hypot(x2 - x1, y2 - y1) / 2, radius).setTranslation((x1 + x2) / 2, (y1 + y2) / 2)
                .setRotation(Math.atan2(y2 - y1, x2 - x1) - Math.PI / 2);
        } else if (shape.polygon) {
            def = this.polygon(shape.polygon);
        } else {
            throw new Error(`the bench has no ${Object.keys(shape)} for Rapier`);
        }
        return def.setDensity(shape.density ?? 1).setFriction(shape.friction ?? 0.6).setRestitution(shape.restitution ?? 0).setCollisionGroups(this.groups(shape.filter));
    }
    polygon({points, radius = 0}) {
        const {ColliderDesc} = this.Rapier;
        const [[x1, y1], [x2], [x3, y3], [x4]] = [...points, [], [], []];
        // A box is a shape of its own here, and faster.
        if (points.length === 4 && radius === 0 && new Set(points.map(([x]) => x)).size === 2 && new Set(points.map(([, y]) => y)).size === 2) {
            const [left, right] = [Math.min(x1, x2, x3, x4), Math.max(x1, x2, x3, x4)];
            return ColliderDesc.cuboid((right - left) / 2, Math.abs(y3 - y1) / 2).setTranslation((left + right) / 2, (y1 + y3) / 2);
        }
        const all = new Float32Array(points.flat());
        return radius > 0 ? ColliderDesc.roundConvexHull(all, radius) : ColliderDesc.convexHull(all);
    }
    /** Rapier has no negative groups: each gets a bit of its own, which its members do not meet. */
    groups({category = 1, mask = 0xffff, group = 0} = {}) {
        const bits = 0xff00, own = group < 0 ? 0x80 << -group : 0;
        const meets = (mask & 1) | (mask & 2 ? bits & ~own | 2 : 0);
        return group < 0 ? own << 16 | meets : (category & 0xff) << 16 >>> 0 | mask & 0xffff;
    }
    createJoint(joint) {
        if (joint.type !== 'revolute') throw new Error(`the bench has no ${joint.type} for Rapier`);
        const {Rapier, world, bodies} = this;
        const {frame_a = {}, frame_b = {}, limit, spring} = joint;
        const [[ax, ay], [bx, by]] = [frame_a.position ?? [0, 0], frame_b.position ?? [0, 0]];
        const made = world.createImpulseJoint(Rapier.JointData.revolute({x: ax, y: ay}, {x: bx, y: by}), bodies[joint.body_a], bodies[joint.body_b], true);
        made.setContactsEnabled(joint.collide_connected ?? false);
        const bend = (frame_a.angle ?? 0) - (frame_b.angle ?? 0);
        if (limit?.enable) made.setLimits((limit.lower ?? 0) + bend, (limit.upper ?? 0) + bend);
        if (spring?.enable) {
            made.configureMotorModel(Rapier.MotorModel.AccelerationBased);
            made.configureMotorPosition((spring.target ?? 0) + bend, turn(spring.hertz) ** 2, 2 * (spring.damping_ratio ?? 0) * turn(spring.hertz));
        }
    }
    destroyBody(body) {
        this.world.removeRigidBody(body);
    }
    destroy() {
        this.world.free();
    }
    get counts() {
        return `${this.world.bodies.len()} bodies, ${this.world.impulseJoints.len()} joints`;
    }
    height() {
        return this.bodies.reduce((sum, body) => sum + (body.isValid() ? body.translation().y : 0), 0);
    }
}
