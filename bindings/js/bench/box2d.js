// Builds a scene, as sandbox_describe tells it, in Box2D 3 of the package box2d3-wasm.

/** Why Box2D cannot run a scene, or an empty string. */
export function box2dLacks(scene) {
    const missing = {pulley: 'pulleys', gear: 'gears', angle: 'angle joints', mouse: 'mouse joints'};
    for (const joint of scene.joints) {
        if (missing[joint.type] !== undefined) return `Box2D 3 has no ${missing[joint.type]}.`;
        if (joint.ratchet !== undefined) return 'Box2D 3 has no ratchets.';
    }
    for (const {shapes} of scene.bodies) {
        for (const shape of shapes) if (shape.one_way !== undefined) return 'Box2D 3 has no one-way shapes.';
    }
    return '';
}

export class Box2dWorld {
    /** `Box2D`: what the package's function gives. */
    constructor(Box2D, scene) {
        this.Box2D = Box2D;
        this.made = []; // definitions of Box2D's memory, freed at the end of a call
        const def = Box2D.b2DefaultWorldDef();
        const {gravity = [0, -10], enable_sleep = true, continuous = true, solver = {}} = scene.world ?? {};
        def.gravity = this.vector(gravity);
        def.enableSleep = enable_sleep;
        def.enableContinuous = continuous;
        this.world = Box2D.b2CreateWorld(def);
        def.delete();
        this.dt = scene.dt ?? 1 / 60;
        this.substeps = solver.substeps ?? 4;
        this.bodies = scene.bodies.map((body) => this.createBody(body));
        this.joints = scene.joints.map((joint) => this.createJoint(joint));
        this.free();
    }

    step() {
        this.Box2D.b2World_Step(this.world, this.dt, this.substeps);
    }

    /** Where bodies are: x, y, cosine and sine of each, in the scene's order. */
    readPoses(out) {
        const {Box2D} = this;
        this.bodies.forEach((body, i) => {
            const at = Box2D.b2Body_GetPosition(body), turn = Box2D.b2Body_GetRotation(body);
            out[4 * i] = at.x;
            out[4 * i + 1] = at.y;
            out[4 * i + 2] = turn.c;
            out[4 * i + 3] = turn.s;
            at.delete();
            turn.delete();
        });
        return out;
    }

    isAwake(index) {
        return this.Box2D.b2Body_IsAwake(this.bodies[index]);
    }

    destroy() {
        this.Box2D.b2DestroyWorld(this.world);
    }

    get counts() {
        const counters = this.Box2D.b2World_GetCounters(this.world);
        const text = `${counters.bodyCount} bodies, ${counters.jointCount} joints`;
        counters.delete();
        return text;
    }

    height() {
        const {Box2D} = this;
        return this.bodies.reduce((sum, body) => sum + (Box2D.b2Body_IsValid(body) ? Box2D.b2Body_GetPosition(body).y : 0), 0);
    }

    destroyBody(body) {
        this.Box2D.b2DestroyBody(body);
    }

    // -- definitions ------------------------------------------------------------------------------------------------------------------

    keep(object) {
        this.made.push(object);
        return object;
    }
    free() {
        for (const object of this.made) object.delete();
        this.made = [];
    }
    vector([x, y]) {
        const vector = this.keep(new this.Box2D.b2Vec2());
        vector.x = x;
        vector.y = y;
        return vector;
    }
    rotation(angle) {
        return this.keep(this.Box2D.b2MakeRot(angle));
    }

    createBody({type = 'static', position = [0, 0], angle = 0, shapes = [], ...more}) {
        const {Box2D} = this;
        const def = Box2D.b2DefaultBodyDef();
        def.type = Box2D.b2BodyType[`b2_${type}Body`];
        def.position = this.vector(position);
        def.rotation = this.rotation(angle);
        def.linearVelocity = this.vector(more.linear_velocity ?? [0, 0]);
        def.angularVelocity = more.angular_velocity ?? 0;
        def.linearDamping = more.linear_damping ?? 0;
        def.angularDamping = more.angular_damping ?? 0;
        def.gravityScale = more.gravity_scale ?? 1;
        def.enableSleep = more.enable_sleep ?? true;
        if (more.sleep_threshold !== undefined) def.sleepThreshold = more.sleep_threshold;
        def.isAwake = more.awake ?? true;
        def.isBullet = more.bullet ?? false;
        def.isEnabled = more.enabled ?? true;
        const locks = this.keep(new Box2D.b2MotionLocks());
        Object.assign(locks, {linearX: more.lock_x ?? false, linearY: more.lock_y ?? false, angularZ: more.fixed_rotation ?? false});
        def.motionLocks = locks;
        const body = Box2D.b2CreateBody(this.world, def);
        def.delete();
        for (const shape of shapes) this.createShape(body, shape);
        return body;
    }

    createShape(body, shape) {
        const {Box2D} = this;
        const def = this.keep(Box2D.b2DefaultShapeDef());
        def.density = shape.density ?? 1;
        const material = this.keep(Box2D.b2DefaultSurfaceMaterial());
        material.friction = shape.friction ?? 0.6;
        material.restitution = shape.restitution ?? 0;
        material.rollingResistance = shape.rolling_resistance ?? 0;
        material.tangentSpeed = shape.tangent_speed ?? 0;
        def.material = material;
        const {category = 1, mask = 2 ** 53 - 1, group = 0} = shape.filter ?? {};
        const filter = this.keep(new Box2D.b2Filter());
        filter.categoryBits = category % 2 ** 32;
        filter.maskBits = mask % 2 ** 32;
        filter.groupIndex = group;
        def.filter = filter;
        def.isSensor = shape.sensor ?? false;
        def.enableSensorEvents = false;
        def.enableContactEvents = false;
        if (shape.circle) {
            const circle = this.keep(new Box2D.b2Circle());
            circle.center = this.vector(shape.circle.center ?? [0, 0]);
            circle.radius = shape.circle.radius ?? 0.5;
            Box2D.b2CreateCircleShape(body, def, circle);
        } else if (shape.capsule) {
            const capsule = this.keep(new Box2D.b2Capsule());
            capsule.center1 = this.vector(shape.capsule.point1 ?? [0, 0]);
            capsule.center2 = this.vector(shape.capsule.point2 ?? [0, 0]);
            capsule.radius = shape.capsule.radius;
            Box2D.b2CreateCapsuleShape(body, def, capsule);
        } else if (shape.segment) {
            this.createSegment(body, def, shape.segment.point1 ?? [0, 0], shape.segment.point2 ?? [0, 0]);
        } else if (shape.half_space) {
            // A segment of 2 km, as in samples/harness/scene.hpp.
            const {normal: [x, y] = [0, 1], offset = 0} = shape.half_space;
            this.createSegment(body, def, [x * offset + 1000 * y, y * offset - 1000 * x], [x * offset - 1000 * y, y * offset + 1000 * x]);
        } else if (shape.chain) {
            this.createChain(body, material, filter, shape.chain);
        } else {
            const hull = this.keep(Box2D.b2ComputeHull(shape.polygon.points.map((point) => this.vector(point))));
            Box2D.b2CreatePolygonShape(body, def, this.keep(Box2D.b2MakePolygon(hull, shape.polygon.radius ?? 0)));
        }
        this.free();
    }

    createSegment(body, def, from, to) {
        const segment = this.keep(new this.Box2D.b2Segment());
        segment.point1 = this.vector(from);
        segment.point2 = this.vector(to);
        this.Box2D.b2CreateSegmentShape(body, def, segment);
    }

    createChain(body, material, filter, {points, loop = false}) {
        const {Box2D} = this;
        // The ends of an open chain are for smoothness alone: straight on beyond them.
        const beyond = ([x1, y1], [x2, y2]) => [2 * x1 - x2, 2 * y1 - y2];
        const all = loop ? points : [beyond(points[0], points[1]), ...points, beyond(points.at(-1), points.at(-2))];
        const def = this.keep(Box2D.b2DefaultChainDef());
        def.isLoop = loop;
        def.filter = filter;
        def.SetPoints(all.map((point) => this.vector(point)));
        def.SetMaterials([material]);
        Box2D.b2CreateChain(body, def);
    }

    createJoint(joint) {
        const {Box2D} = this;
        const name = joint.type[0].toUpperCase() + joint.type.slice(1);
        const def = this.keep(Box2D[`b2Default${name}JointDef`]());
        const base = def.base;
        base.bodyIdA = this.bodies[joint.body_a];
        base.bodyIdB = this.bodies[joint.body_b];
        base.localFrameA = this.frame(joint.frame_a);
        base.localFrameB = this.frame(joint.frame_b);
        base.collideConnected = joint.collide_connected ?? false;
        def.base = base;
        this[`fill${name}`](def, joint);
        const made = Box2D[`b2Create${name}Joint`](this.world, def);
        this.free();
        return made;
    }

    frame({position = [0, 0], angle = 0} = {}) {
        const frame = this.keep(new this.Box2D.b2Transform());
        frame.p = this.vector(position);
        frame.q = this.rotation(angle);
        return frame;
    }

    setSpring(def, {spring = {}}) {
        def.enableSpring = spring.enable ?? false;
        def.hertz = spring.hertz ?? 0;
        def.dampingRatio = spring.damping_ratio ?? 0;
    }
    /** A motor, or friction as a motor that holds still; its strongest force or torque. */
    setMotor(def, {motor = {}, friction = 0}) {
        def.enableMotor = (motor.enable ?? false) || friction > 0;
        def.motorSpeed = motor.enable ? motor.speed ?? 0 : 0;
        return motor.enable ? motor.max_force ?? 0 : friction;
    }

    fillRevolute(def, joint) {
        this.setSpring(def, joint);
        def.targetAngle = joint.spring?.target ?? 0;
        def.enableLimit = joint.limit?.enable ?? false;
        def.lowerAngle = joint.limit?.lower ?? 0;
        def.upperAngle = joint.limit?.upper ?? 0;
        def.maxMotorTorque = this.setMotor(def, joint);
    }
    fillPrismatic(def, joint) {
        this.setSpring(def, joint);
        def.targetTranslation = joint.spring?.target ?? 0;
        def.enableLimit = joint.limit?.enable ?? false;
        def.lowerTranslation = joint.limit?.lower ?? 0;
        def.upperTranslation = joint.limit?.upper ?? 0;
        def.maxMotorForce = this.setMotor(def, joint);
    }
    fillDistance(def, joint) {
        def.length = joint.length ?? 1;
        this.setSpring(def, joint);
        def.enableLimit = joint.limit?.enable ?? false;
        if (def.enableLimit) {
            // A rope is a rod to Box2D unless its spring gives way.
            if (!def.enableSpring) Object.assign(def, {enableSpring: true, hertz: 0, dampingRatio: 0});
            def.minLength = joint.limit.lower ?? 0;
            def.maxLength = joint.limit.upper ?? 0;
        }
        def.maxMotorForce = this.setMotor(def, joint);
    }
    fillWeld(def, joint) {
        def.linearHertz = joint.linear_hertz ?? 0;
        def.linearDampingRatio = joint.linear_damping_ratio ?? 1;
        def.angularHertz = joint.angular_hertz ?? 0;
        def.angularDampingRatio = joint.angular_damping_ratio ?? 1;
    }
    fillWheel(def, joint) {
        this.setSpring(def, joint);
        def.enableLimit = joint.limit?.enable ?? false;
        def.lowerTranslation = joint.limit?.lower ?? 0;
        def.upperTranslation = joint.limit?.upper ?? 0;
        def.maxMotorTorque = this.setMotor(def, joint);
    }
    fillMotor(def, joint) {
        def.linearVelocity = this.vector(joint.linear_velocity ?? [0, 0]);
        def.angularVelocity = joint.angular_velocity ?? 0;
        def.maxVelocityForce = joint.linear_hertz ? 0 : joint.max_force ?? 0;
        def.maxVelocityTorque = joint.angular_hertz ? 0 : joint.max_torque ?? 0;
        Object.assign(def, {linearHertz: joint.linear_hertz ?? 0, linearDampingRatio: joint.linear_damping_ratio ?? 1});
        Object.assign(def, {angularHertz: joint.angular_hertz ?? 0, angularDampingRatio: joint.angular_damping_ratio ?? 1});
        def.maxSpringForce = joint.linear_hertz ? joint.max_force ?? 0 : 0;
        def.maxSpringTorque = joint.angular_hertz ? joint.max_torque ?? 0 : 0;
    }
}
