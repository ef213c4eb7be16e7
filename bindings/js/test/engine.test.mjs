// The package in node. ./build.sh comes first.
import assert from 'node:assert/strict';
import {readFileSync, readdirSync} from 'node:fs';
import {test} from 'node:test';
import {Worker} from 'node:worker_threads';
import {brotliCompressSync} from 'node:zlib';
import Islet, {IsletError, constants, slotOf, version} from '@islet/engine';
import {functions, methods} from './signatures.mjs';
import {goldenHash, hex, makeHello, makePyramid} from './worlds.mjs';

const dist = new URL('../dist/', import.meta.url);

function throwsError(call, code) {
    assert.throws(call, (error) => error instanceof IsletError && error.code === code && /[.]$/.test(error.message), code);
}

test('scenes made in JavaScript have the golden hashes', async () => {
    for (const [name, make, checkpoints] of [['hello', makeHello, [60, 180]], ['pyramid', makePyramid, [60, 1200]]]) {
        const {world} = await make(Islet);
        for (let step = 1; step <= checkpoints[1]; ++step) {
            world.step(1 / 60);
            if (checkpoints.includes(step)) assert.equal(hex(world.hash()), goldenHash(name, step), `${name} after ${step} steps`);
        }
        assert.equal(world.validate(), undefined);
        world.destroy();
    }
});

test('so do the build without SIMD and those that are part of the script, in workers', async () => {
    for (const file of ['index.js', 'inline.js']) {
        for (const simd of [false, true]) {
            const worker = new Worker(new URL('other_builds.mjs', import.meta.url), {workerData: {file: new URL(file, dist).href, simd}});
            const hash = await new Promise((done, failed) => worker.once('message', done).once('error', failed));
            assert.equal(hash, goldenHash('pyramid', 60), `${file}, SIMD ${simd}`);
            await worker.terminate();
        }
    }
});

test('definitions have the defaults of the engine', async () => {
    const {world, crate} = await makeHello(Islet);
    assert.deepEqual(world.gravity(), {x: 0, y: -10});
    assert.equal(world.bodyType(crate), 'dynamic');
    assert.equal(world.bodyGravityScale(crate), 1);
    const [shape] = world.bodyShapes(crate);
    assert.equal(world.shapeFriction(shape), Math.fround(0.6));
    assert.deepEqual(world.shapeFilter(shape), {category: 1, mask: 0xffffffff, group: 0});
    assert.equal(world.shapePolygon(shape).vertices.length, 4);
    assert.equal(world.shapeCircle(shape), undefined);
    assert.equal(world.solver().substeps, 4);
    world.setSolver({...world.solver(), substeps: 8});
    assert.equal(world.solver().substeps, 8);
    assert.equal(world.solver().schedule, 'soft');
    assert.equal(constants.maxPolygonVertices, 8);
    world.destroy();
});

test('every field of a definition arrives', async () => {
    const world = await Islet.createWorld({gravity: {x: 1, y: 2}, solver: {substeps: 3}, enableSleep: false, capacity: {bodies: 3}});
    assert.deepEqual(world.gravity(), {x: 1, y: 2});
    assert.equal(world.solver().substeps, 3);
    assert.equal(world.capacity().bodies, 3);
    const body = world.createBody({
        type: 'dynamic', position: {x: 3, y: 4}, angle: 0.5, linearVelocity: {x: 5, y: 6}, angularVelocity: 7, linearDamping: 0.125, angularDamping: 0.25,
        gravityScale: 0.5, sleepThreshold: 0.75, fixedRotation: false, lockX: true, bullet: true, userData: Number.MAX_SAFE_INTEGER,
    });
    assert.deepEqual(world.bodyPosition(body), {x: 3, y: 4});
    assert.ok(Math.abs(world.bodyAngle(body) - 0.5) < 1e-6);
    assert.equal(world.bodyAngularVelocity(body), 7);
    assert.equal(world.bodyLinearDamping(body), 0.125);
    assert.equal(world.bodyAngularDamping(body), 0.25);
    assert.equal(world.bodySleepThreshold(body), 0.75);
    assert.ok(world.bodyIsXLocked(body) && !world.bodyIsYLocked(body) && world.bodyIsBullet(body));
    assert.equal(world.bodyUserData(body), Number.MAX_SAFE_INTEGER);
    const shape = world.createCapsule(body, {point1: {x: -1, y: 0}, point2: {x: 1, y: 0}, radius: 0.5}, {
        friction: 0.25, restitution: 0.5, rollingResistance: 0.125, tangentSpeed: 2, density: 3, filter: {category: 4}, material: 9, userData: 10,
    });
    assert.deepEqual(world.shapeMaterial(shape), {friction: 0.25, restitution: 0.5, rollingResistance: 0.125, tangentSpeed: 2, id: 9});
    assert.deepEqual(world.shapeFilter(shape), {category: 4, mask: 0xffffffff, group: 0});
    const anchor = world.createBody();
    const joint = world.createRevoluteJoint({
        bodyA: anchor, bodyB: body, frameB: {position: {x: 1, y: 0}}, motor: {enable: true, speed: 2, maxForce: 100}, limit: {enable: true, lower: -1, upper: 1},
    });
    assert.equal(world.jointType(joint), 'revolute');
    assert.equal(world.jointBodyB(joint), body);
    assert.deepEqual(world.jointFrameB(joint), {position: {x: 1, y: 0}, angle: 0});
    assert.equal(world.jointMotor(joint).speed, 2);
    assert.deepEqual(world.jointLimit(joint), {enable: true, lower: -1, upper: 1});
    world.destroy();
});

test('errors say what to do, and change nothing', async () => {
    const {world, crate} = await makeHello(Islet);
    const before = world.hash();
    throwsError(() => world.step(0), 'badTimeStep');
    throwsError(() => world.createBody({position: {x: NaN, y: 0}}), 'notFinite');
    throwsError(() => world.createCircle(crate, {center: {x: 0, y: 0}, radius: -1}), 'badGeometry');
    throwsError(() => world.bodyPosition(0), 'nullId');
    throwsError(() => world.bodyPosition(undefined), 'nullId');
    throwsError(() => world.bodyPosition(crate + 2 ** 20), 'staleId');
    throwsError(() => world.jointMotor(7), 'staleId');
    throwsError(() => world.restore(new Uint8Array(100)), 'notAnImage');
    throwsError(() => world.load(world.save().subarray(0, -8)), 'truncatedImage');
    throwsError(() => Islet.delta(new Uint8Array(9), world.save()), 'notAnImage');
    assert.throws(() => world.createBody({tipe: 'dynamic'}), /BodyDef has no tipe: there are type, /);
    assert.throws(() => world.createBody({type: 'static'}), /"static" is no BodyType: there are staticBody, kinematic, dynamic/);
    assert.throws(() => world.createBody(7), TypeError);
    assert.throws(() => world.bodySetUserData(crate, -1), RangeError);
    assert.equal(world.hash(), before);
    await assert.rejects(Islet.createWorld({capacity: {bodies: 0}}), (error) => error instanceof IsletError && error.code === 'badCapacity');
    await assert.rejects(Islet.createWorld({gravity: {x: NaN, y: 0}}), (error) => error instanceof IsletError && error.code === 'notFinite');
    const small = await Islet.createWorld({capacity: {bodies: 1}});
    small.createBody();
    throwsError(() => small.createBody(), 'bodiesFull');
    small.destroy();
    throwsError(() => small.step(), 'nullPointer');
    throwsError(() => small.hash(), 'nullPointer');
    world.destroy();
});

test('arguments that are left out have the defaults of the engine', async () => {
    const {world, crate} = await makeHello(Islet);
    const points = [{x: 0, y: 0}, {x: 1, y: 0}, {x: 0, y: 1}], pose = {p: {x: 1, y: 0}, q: {c: 1, s: 0}};
    const hull = Islet.computeHull(points);
    for (const [short, whole] of [
        [Islet.makePolygon(hull), Islet.makePolygon(hull, 0)],
        [Islet.makeOffsetBox(1, 2, pose), Islet.makeOffsetBox(1, 2, pose, 0)],
        [Islet.makeProxy(points), Islet.makeProxy(points, 0)],
    ]) {
        assert.ok(short.count >= 3, `${short.count} corners`);
        assert.deepEqual(short, whole);
    }
    assert.ok(world.createPolygon(crate, Islet.makePolygon(hull)) !== 0);
    assert.equal(world.createChain(world.createBody(), points, true).length, 3);
    world.startRecording();
    world.step();
    const recording = world.stopRecording();
    const all = world.replay(recording), some = {};
    assert.equal(all.steps, 1);
    assert.equal(world.replay(recording, 0, some), some);
    assert.equal(some.steps, 0);
    world.destroy();
});

test('a call with too few arguments says how many there are, and changes nothing', async () => {
    const {world, crate} = await makeHello(Islet);
    const before = world.hash();
    let tried = 0;
    for (const [of, known] of [[world, methods], [Islet, functions]]) {
        for (const [name, {needed}] of known) {
            if (typeof of[name] !== 'function') continue;
            for (let given = 0; given < needed; ++given) {
                const message = `${name} takes ${needed} argument${needed === 1 ? '' : 's'}, not ${given}`;
                assert.throws(() => of[name](...Array(given).fill(crate)), (error) => error instanceof TypeError && error.message === message, message);
                ++tried;
            }
        }
    }
    assert.ok(tried > 300, `${tried} calls`);
    assert.equal(world.hash(), before);
    assert.throws(() => world.bodySetEnabled(crate), /^TypeError: bodySetEnabled takes 2 arguments, not 1$/);
    assert.throws(() => world.bodySetTransform(crate, {x: 1, y: 1}), /^TypeError: bodySetTransform takes 3 arguments, not 2$/);
    assert.ok(world.bodyIsEnabled(crate));
    world.destroy();
});

test('a vector without all of its numbers is refused by name', async () => {
    const {world, crate} = await makeHello(Islet);
    const before = world.hash();
    const unturned = {c: 1, s: 0}, origin = {x: 0, y: 0};
    for (const [call, message] of [
        [() => world.createBody({position: {x: 1}}), 'position.y is missing: give an object with x, y'],
        [() => world.createBody({position: [1, 2]}), 'position.x is missing: give an object with x, y'],
        [() => world.createBody({position: {x: 1, y: '2'}}), 'position.y is "2", no number: give an object with x, y'],
        [() => world.bodySetLinearVelocity(crate, undefined), 'velocity is missing: give an object with x, y'],
        [() => world.bodySetLinearVelocity(crate, 3), 'velocity.x is missing: give an object with x, y'],
        [() => world.bodySetPose(crate, {p: origin}), 'Transform.q is missing: give an object with c, s'],
        [() => world.bodySetPose(crate, {p: {x: 1}, q: unturned}), 'Transform.p.y is missing: give an object with x, y'],
        [() => world.bodySetPose(crate, {p: origin, q: {c: 1}}), 'Transform.q.s is missing: give an object with c, s'],
        [() => world.overlapBox({lower: origin}), 'Aabb.upper is missing: give an object with x, y'],
        [() => world.createChain(crate, [origin, {x: 1, y: 0}, {y: 1}], true), 'points[2].x is missing: give an object with x, y'],
        [() => world.createRevoluteJoint({bodyA: crate, frameB: {position: {y: 1}}}), 'position.x is missing: give an object with x, y'],
    ]) assert.throws(call, (error) => error instanceof TypeError && error.message === message, message);
    assert.equal(world.hash(), before);
    await assert.rejects(Islet.createWorld({gravity: {y: -10}}), /gravity\.x is missing/);
    // Vectors may be of classes, and have more than their numbers.
    class Point {
        get x() { return 3; }
        get y() { return 4; }
    }
    assert.deepEqual(world.bodyPosition(world.createBody({position: new Point()})), {x: 3, y: 4});
    assert.deepEqual(world.bodyPosition(world.createBody({position: {x: 1, y: 2, z: 3}})), {x: 1, y: 2});
    world.destroy();
});

test('what a step goes on in spite of, onError hears', async () => {
    const told = [];
    const world = await Islet.createWorld({capacity: {contacts: 1}, onError: (error) => told.push(error.code)});
    world.createPolygon(world.createBody(), Islet.makeBox(20, 1));
    for (let i = 0; i < 3; ++i) world.createPolygon(world.createBody({type: 'dynamic', position: {x: 2 * i, y: 1.4}}), Islet.makeBox(0.5, 0.5));
    world.step();
    assert.ok(told.includes('contactsFull'));
    assert.ok(world.report().droppedContacts > 0);
    world.destroy();
});

test('poses are an array in the memory of the engine', async () => {
    const {world, floor, crate} = await makeHello(Islet);
    const poses = world.readPoses();
    for (let i = 0; i < 70; ++i) world.step();
    assert.equal(world.readPoses(), poses);
    const at = 4 * slotOf(crate);
    assert.deepEqual({x: poses[at], y: poses[at + 1]}, world.bodyPosition(crate));
    assert.ok(Math.abs(Math.atan2(poses[at + 3], poses[at + 2]) - world.bodyAngle(crate)) < 1e-6);
    assert.equal(world.slotCount, 2);
    assert.equal(world.states[slotOf(floor)], 1);
    assert.equal(world.states[slotOf(crate)], 3 + 8);
    world.destroyBody(floor);
    world.readPoses();
    assert.equal(world.states[slotOf(floor)], 0);
    // More memory moves the array, and readPoses knows.
    const others = [];
    while (poses.length > 0 && others.length < 100) others.push(await Islet.createWorld({capacity: {bodies: 20000, shapes: 20000, contacts: 60000}}));
    assert.ok(poses.length === 0, 'the memory has grown');
    assert.equal(world.readPoses()[at], world.bodyPosition(crate).x);
    for (const other of others) other.destroy();
    world.destroy();
});

test('events are iterable, again and within each other', async () => {
    const world = await Islet.createWorld();
    world.createPolygon(world.createBody(), Islet.makeBox(20, 1));
    const balls = [-3, 0, 3].map((x) => world.createBody({type: 'dynamic', position: {x, y: 2}, linearVelocity: {x: 0, y: -5}}));
    const shapes = balls.map((ball) => world.createCircle(ball, {center: {x: 0, y: 0}, radius: 0.5}, {hitEvents: true}));
    const touched = [], hits = [];
    for (let i = 0; i < 60; ++i) {
        world.step();
        for (const {shapeA, shapeB} of world.beginTouchEvents()) touched.push(shapes.includes(shapeA) ? shapeA : shapeB);
        for (const hit of world.hitEvents()) hits.push(hit.speed);
        const events = world.beginTouchEvents();
        if (events.length === 3) {
            let pairs = 0;
            for (const a of events) for (const b of events) pairs += a.shapeA > 0 && b.shapeA > 0 ? 1 : 0;
            assert.equal(pairs, 9);
            for (const event of events) if (event) break;
            assert.equal([...events].length, 3);
            assert.throws(() => events.at(3), RangeError);
        }
    }
    assert.deepEqual(touched.sort(), shapes.sort());
    assert.ok(hits.length === 3 && hits.every((speed) => speed > 5));
    world.destroy();
});

test('a step makes no objects', async () => {
    const {world} = await makePyramid(Islet);
    let sum = 0;
    const turn = () => {
        world.step();
        const poses = world.readPoses();
        sum += poses[5];
        for (const event of world.beginTouchEvents()) sum += event.shapeA;
    };
    for (let i = 0; i < 600; ++i) turn();
    const before = process.memoryUsage().heapUsed;
    for (let i = 0; i < 1000; ++i) turn();
    const each = (process.memoryUsage().heapUsed - before) / 1000;
    assert.ok(each < 100, `${each} bytes a step`);
    assert.ok(sum > 0);
    world.destroy();
});

test('hooks are called, may read, and what they throw comes out of the step', async () => {
    const {world, floor, crate} = await makeHello(Islet);
    const shape = world.bodyShapes(crate)[0];
    let asked = 0, solved = 0;
    world.shapeEnablePreSolve(shape, true);
    world.setHooks({
        filter(a, b) {
            ++asked;
            assert.deepEqual([world.shapeBody(a), world.shapeBody(b)].sort(), [floor, crate].sort());
            return true;
        },
        preSolve(contact) {
            ++solved;
            assert.equal(contact.contact.points.length, contact.contact.pointCount);
            contact.enabled = false;
        },
        mixFriction: (a, materialA, b) => a * b,
    });
    for (let i = 0; i < 120; ++i) world.step();
    assert.ok(asked > 0 && solved > 0);
    assert.ok(world.bodyPosition(crate).y < 0, 'the floor does not hold it');
    world.bodySetTransform(crate, {x: 0, y: 1.5}, 0);
    world.setHooks({
        filter() {
            throw new Error('a mistake in a hook');
        },
    });
    assert.throws(() => {
        for (let i = 0; i < 10; ++i) world.step();
    }, /a mistake in a hook/);
    world.setHooks();
    const before = world.stepCount();
    world.step();
    assert.equal(world.stepCount(), before + 1);
    world.destroy();
});

test('queries find shapes, by list and one by one', async () => {
    const {world, floor, crate} = await makeHello(Islet);
    const [ground] = world.bodyShapes(floor), [box] = world.bodyShapes(crate);
    const hit = world.castRay({x: 5, y: 10}, {x: 0, y: -20});
    assert.equal(hit.shape, ground);
    assert.deepEqual(hit.normal, {x: 0, y: 1});
    assert.deepEqual(world.castRayAll({x: 0, y: 10}, {x: 0, y: -20}).map((h) => h.shape), [box, ground]);
    assert.equal(world.castRayAny({x: 50, y: 10}, {x: 0, y: -20}), false);
    assert.deepEqual(world.overlapPoint({x: 0, y: 8}), [box]);
    assert.equal(world.closest({x: 0, y: 3}, 10).shape, ground);
    const seen = [];
    // A visitor may ask further, and change the world.
    world.overlapBoxEach({lower: {x: -9, y: -9}, upper: {x: 9, y: 9}}, undefined, (shape) => {
        seen.push(shape);
        world.overlapBoxEach({lower: {x: -9, y: -9}, upper: {x: 9, y: 9}}, undefined, () => false);
        if (shape === box) world.destroyBody(crate);
        return true;
    });
    assert.deepEqual(seen.sort(), [ground, box].sort());
    assert.equal(world.shapeIsValid(box), false);
    const fractions = [];
    world.castRayEach({x: 5, y: 10}, {x: 0, y: -20}, undefined, (one) => fractions.push(one.fraction) && 1);
    assert.equal(fractions.length, 1);
    assert.throws(() => world.castRayEach({x: 5, y: 10}, {x: 0, y: -20}, undefined, () => { throw new Error('enough'); }), /enough/);
    world.destroy();
});

test('a mover walks', async () => {
    const {world, floor} = await makeHello(Islet);
    const state = {position: {x: -5, y: 1.2}, velocity: {x: 0, y: 0}, ground: 0, groundNormal: {x: 0, y: 0}, groundPoint: {x: 0, y: 0}, squeezed: 0};
    for (let i = 0; i < 120; ++i) {
        world.stepMover({}, state, {walk: 2}, 1 / 60);
        world.step();
    }
    assert.equal(state.ground, floor);
    assert.ok(state.position.x > -2 && state.position.x < 0, `at ${state.position.x}`);
    world.destroy();
});

test('chains are made once', async () => {
    const world = await Islet.createWorld();
    const points = Array.from({length: 200}, (_, i) => ({x: -i, y: Math.sin(i)}));
    const shapes = world.createChain(world.createBody(), points, false);
    assert.equal(shapes.length, 199);
    assert.equal(world.shapeCount(), 199);
    assert.deepEqual(world.shapeChainSegment(shapes[3]).segment.point1, {x: -3, y: Math.fround(Math.sin(3))});
    world.destroy();
});

test('snapshots go back, deltas lead on, both as bytes', async () => {
    const {world} = await makePyramid(Islet);
    for (let i = 0; i < 30; ++i) world.step();
    const then = world.save(), hash = world.hash();
    for (let i = 0; i < 30; ++i) world.step();
    const now = world.save();
    assert.equal(hex(world.hash()), goldenHash('pyramid', 60));
    const change = Islet.delta(then, now);
    assert.ok(change instanceof Uint8Array && change.length < now.length);
    assert.deepEqual(Islet.apply(then, change), now);
    world.restore(then);
    assert.equal(world.hash(), hash);
    for (let i = 0; i < 30; ++i) world.step();
    assert.equal(hex(world.hash()), goldenHash('pyramid', 60));
    world.load(then);
    assert.equal(world.hash(), hash);
    assert.equal(Islet.readSnapshot(then).used.bodies, 56);
    assert.equal(Islet.readFormat(then).kind, 'snapshot');
    then[40] ^= 1;
    assert.throws(() => world.load(then), IsletError);
    world.destroy();
});

test('a recording is replayed to the same hash, however long', async () => {
    const {world, crate} = await makeHello(Islet);
    world.startRecording();
    for (let i = 0; i < 100; ++i) {
        for (let j = 0; j < 1000; ++j) world.bodyApplyForceToCenter(crate, {x: 0.1, y: 0.2});
        world.step();
    }
    const hash = world.hash(), recording = world.stopRecording();
    assert.ok(recording.length > 2 ** 20, 'it outgrew its first buffer');
    const {needed} = Islet.readRecording(recording);
    const other = await Islet.createWorld({capacity: needed});
    const {end, steps} = other.replay(recording);
    assert.deepEqual({end, steps}, {end: 'complete', steps: 100});
    assert.equal(other.hash(), hash);
    world.destroy();
    other.destroy();
});

test('the profile is in microseconds when time is measured', async () => {
    const {world} = await makePyramid(Islet);
    world.measureTime();
    for (let i = 0; i < 10; ++i) world.step();
    const {total, solve} = world.profile();
    assert.ok(total > 0 && solve <= total, `${solve} of ${total}`);
    world.destroy();
});

test('a thousand worlds come and go in the same memory', async () => {
    const exports = await Islet.load();
    const sizes = new Set();
    for (let i = 0; i < 1000; ++i) {
        const {world} = await makeHello(Islet);
        world.step();
        world.readPoses();
        world.destroy();
        if (i > 10) sizes.add(exports.memory.buffer.byteLength);
    }
    assert.equal(sizes.size, 1);
});

test('the package holds what it needs, within its size', () => {
    const files = readdirSync(dist);
    for (const file of ['index.js', 'inline.js', 'islet.js', 'calls.js', 'memory.js', 'index.d.ts', 'types.d.ts']) assert.ok(files.includes(file), file);
    assert.equal(JSON.parse(readFileSync(new URL('../package.json', import.meta.url), 'utf8')).version, version);
    // What a browser loads: the limits are what there is, rounded up, so that growth is seen.
    const bytes = (names) => Buffer.concat(names.map((name) => readFileSync(new URL(name, dist))));
    for (const [name, whole, packed] of [['islet-simd.wasm', 451e3, 144e3], ['islet.wasm', 268e3, 102e3]]) {
        const size = bytes([name]).length, small = brotliCompressSync(bytes([name])).length;
        assert.ok(size <= whole && small <= packed, `${name}: ${size} bytes, ${small} compressed`);
    }
});

test('every function has its comment in the types', () => {
    const types = readFileSync(new URL('types.d.ts', dist), 'utf8'), code = readFileSync(new URL('calls.js', dist), 'utf8');
    const methods = [...code.matchAll(/^ {4}(\w+)\(.*\) \{$/gm)].map((match) => match[1]).filter((name) => !['if', 'for', 'switch'].includes(name));
    assert.ok(methods.length > 180, `${methods.length} methods`);
    for (const name of methods) assert.match(types, new RegExp(`^    ${name}\\(`, 'm'));
});

test('blocks of memory do not overlap, and what is freed is used again', async () => {
    const stubs = new Proxy({}, {get: () => () => 0, has: () => true});
    const {exports} = (await WebAssembly.instantiate(readFileSync(new URL('islet.wasm', dist)), {islet: stubs})).instance;
    const {malloc, free, memory} = exports;
    let state = 1;
    const below = (count) => (state = (Math.imul(state, 1664525) + 1013904223) >>> 0) % count;
    const run = () => {
        const blocks = [];
        for (let turn = 1; turn <= 2000; ++turn) {
            if (blocks.length < 40 || below(2) === 0) {
                const bytes = below(8) === 0 ? below(300000) : below(200);
                const at = malloc(bytes) >>> 0;
                assert.ok(at !== 0 && at % 16 === 0);
                new Uint8Array(memory.buffer, at, bytes).fill(turn & 255);
                blocks.push({at, bytes, mark: turn & 255});
            } else {
                const [{at, bytes, mark}] = blocks.splice(below(blocks.length), 1);
                assert.ok(new Uint8Array(memory.buffer, at, bytes).every((byte) => byte === mark));
                free(at);
            }
        }
        for (const {at} of blocks) free(at);
    };
    run();
    const most = memory.buffer.byteLength;
    free(malloc(most - 2 * 262144)); // all is one block again but for the stack and the data
    assert.equal(memory.buffer.byteLength, most);
    for (let again = 0; again < 5; ++again) run();
    assert.ok(memory.buffer.byteLength < 1.5 * most);
    assert.equal(malloc(0xffffffff), 0);
    assert.equal(malloc(0xfff00000), 0);
    free(0);
});
