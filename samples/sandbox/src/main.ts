// The sandbox: the scenes of the catalogue, to drag, throw, pause and rewind.
import {IsletError, Running, prove, scenes, start, type BodyId, type JointId, type SceneInfo, type World} from './engine';
import {History} from './history';
import {Camera} from './camera';
import {Painter} from './draw';
import {Beside} from './beside';
import {Gallery} from './gallery';
import {keepOffline} from './offline';
import {makeFiles} from './files';
import {makeGraph} from './graph';
import {makeHand} from './hand';
import {hero, native, textAt} from './native';
import {makePlayer} from './play';
import {wrongWith} from './scene_text';
import {makeNumbers, makeOverlay} from './see';
import {makeSolverKnobs, type Knob} from './settings';
import {setAddress, type Stage} from './stage';

const first_scene = 'mixer';
const more_bodies = 300; // to throw in
const drag_mark = 0xd7a6; // userData of the joint that drags
const drag_acceleration = 200; // m/s^2, of a dragged body at most

const find = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;
const canvas = find<HTMLCanvasElement>('world');
const timeline = find<HTMLInputElement>('timeline');
const painter = new Painter(canvas);
const camera = new Camera();

let running: Running;
let beside: Beside | undefined;
let gallery: Gallery | undefined;
let history: History;
let playing = !matchMedia('(prefers-reduced-motion: reduce)').matches;
let speed = 1;
let owed = 0; // s of the world that are still to be stepped
let looking = -1; // the moment of the history that is shown; -1: the present
let stepTime = 0; // ms, a running mean
let paintTime = 0; // ms, a running mean

// -- scenes -----------------------------------------------------------------------------------------------------------------------------

function load(scene: SceneInfo) {
    ++asked;
    files.end();
    letGo();
    running?.end();
    running = new Running(scene, more_bodies, (error) => say(error.message));
    beside?.load();
    const bodies = running.world.bodyCount();
    history = new History(running.timeStep, bodies > 2500 ? 30 : 6);
    painter.forget();
    [owed, looking, stepTime] = [0, -1, 0];
    camera.fitted = true;
    for (const knob of knobs) knob.begin(running.world);
    for (const part of [player, overlay, graph]) part.begin();
    find('description').textContent = scene.description;
    find<HTMLSelectElement>('scene').value = scene.text === undefined ? scene.name : '';
    find('proof').textContent = '';
    timeline.disabled = running.hasScript;
    say('');
    document.documentElement.dataset.scene = scene.name;
    if (scene.text !== undefined) return;
    if (location.hash.slice(1) !== scene.name) setAddress(`#${scene.name}`);
}

function listScenes() {
    const groups = new Map<string, HTMLOptGroupElement>();
    for (const {name, group, description} of scenes) {
        const option = new Option(name.replaceAll('_', ' '), name);
        option.title = description;
        let place = groups.get(group);
        if (place === undefined) {
            groups.set(group, (place = document.createElement('optgroup')));
            place.label = group;
            find('scene').append(place);
        }
        place.append(option);
    }
}

function loadByName(name: string) {
    load(scenes.find((scene) => scene.name === name)!);
}

/// Plays with a scene file, unless something is wrong with it.
function open(text: string): boolean {
    const wrong = wrongWith(text, more_bodies);
    if (wrong !== undefined) {
        say(wrong);
        return false;
    }
    load({index: -1, name: nameIn(text), group: '', description: '', text});
    return true;
}
const nameIn = (text: string) => String((JSON.parse(text) as {name?: unknown}).name ?? '') || 'scene';

let hasFailed = false; // the engine did not start
let asked = 0; // how often an address or a scene was asked for

/// What the address names. If that cannot be, the scene that is there already goes on, and the page says why.
async function openAddress() {
    const mine = ++asked;
    try {
        const text = await files.fromAddress();
        if (mine !== asked) return; // something newer was asked for while this was unpacked
        if (text === undefined) loadOfAddress();
        else if (!open(text) && !hasOpened()) load(firstScene());
    } catch (error) {
        if (mine !== asked) return;
        if (!hasOpened()) load(firstScene());
        say((error as Error).message);
    }
}

const hasOpened = () => running !== undefined;
const firstScene = () => scenes.find(({name}) => name === first_scene)!;
function loadOfAddress() {
    let name = location.hash.slice(1);
    try {
        name = decodeURIComponent(name);
    } catch {
        // No escapes, but a sign like %: there is no such scene.
    }
    const named = scenes.find((scene) => scene.name === (name || first_scene));
    if (named !== undefined || !hasOpened()) load(named ?? firstScene());
    if (named === undefined) say(`There is no scene “${name.length > 40 ? `${name.slice(0, 40)}…` : name}”.`);
}

// -- time -------------------------------------------------------------------------------------------------------------------------------

/// Runs what changes the world; what the engine says against it is shown.
function attempt(run: () => void) {
    try {
        run();
    } catch (error) {
        if (!(error instanceof IsletError)) throw error;
        say(error.message);
    }
}

function advance() {
    resume();
    if (!running.hasScript) history.keep(running.world, running.step);
    player.beforeStep();
    const began = performance.now();
    attempt(() => running.advance());
    graph.note(performance.now() - began);
    player.afterStep();
    files.afterStep();
    stepTime += (performance.now() - began - stepTime) * (stepTime === 0 ? 1 : 0.1);
    beside?.step();
}

/// What is shown becomes the present, and what came after it never was.
function resume() {
    if (looking < 0) return;
    history.cutAfter(looking);
    looking = -1;
    for (const knob of knobs) knob.apply(running.world);
    dropDrags(running.world);
}

/// The joint of a drag that ended since has come back too.
function dropDrags(world: World) {
    const {joints} = world.capacity();
    for (let slot = 0; slot < joints; ++slot) {
        const joint = world.jointAt(slot);
        if (joint !== 0 && world.jointUserData(joint) === drag_mark) world.destroyJoint(joint);
    }
    dragged = 0;
}

function look(place: number) {
    if (running.hasScript || history.length === 0) return;
    if (files.isRecording) return say('A recording goes only forward: stop it to go back.');
    setPlaying(false);
    // The present is a moment too.
    if (looking < 0) history.keep(running.world, running.step);
    looking = Math.max(0, Math.min(place, history.length - 1));
    running.goTo(history.stepAt(looking), history.imageAt(looking));
    painter.forget(); // what comes next may get the ids of what is gone
}

function setPlaying(to: boolean) {
    playing = to;
    owed = 0;
    find('play').textContent = to ? 'Pause' : 'Play';
}

let before = 0;
function frame(now: number) {
    const passed = Math.min(0.1, Math.max(0, (now - before) / 1000));
    before = now;
    if (gallery?.open) {
        gallery.draw();
        requestAnimationFrame(frame);
        return;
    }
    if (playing) {
        owed += passed * speed;
        const until = performance.now() + 14; // a scene that takes longer runs slower than it should
        while (owed >= running.timeStep) {
            owed -= running.timeStep;
            advance();
            if (performance.now() > until) owed = 0;
        }
    }
    camera.resize(canvas);
    if (camera.fitted) showAll(); // whatever the size of the window
    const began = performance.now();
    painter.draw(running.world, camera);
    paintTime += 0.1 * (performance.now() - began - paintTime);
    beside?.draw(camera, stepTime);
    measure();
    overlay.draw();
    numbers.draw();
    graph.draw();
    files.shown();
    tell();
    requestAnimationFrame(frame);
}

/// Heat and graph need the residual.
function measure() {
    const solver = running.world.solver();
    if ((overlay.measures || graph.measures) && !solver.measureResidual && looking < 0) running.world.setSolver({...solver, measureResidual: true});
}

// -- what the page says -----------------------------------------------------------------------------------------------------------------

let silence: ReturnType<typeof setTimeout> | undefined;
function say(sentence: string) {
    const message = find('message');
    message.textContent = sentence;
    message.hidden = sentence === '';
    clearTimeout(silence);
    if (sentence !== '') silence = setTimeout(() => say(''), 5000);
}

function tell() {
    const {world, timeStep} = running, {step} = running;
    const data = document.documentElement.dataset;
    data.step = String(step);
    data.stepTime = stepTime.toFixed(3);
    data.paintTime = paintTime.toFixed(3);
    find('status').textContent = `${world.bodyCount()} bodies · ${stepTime.toFixed(stepTime < 1 ? 2 : 1)} ms a step`;
    const last = Math.max(0, history.length - 1);
    timeline.max = String(last);
    const place = looking < 0 ? last : looking;
    if (Number(timeline.value) !== place) timeline.value = String(place);
    const back = looking < 0 ? 0 : (history.stepAt(last) - history.stepAt(looking)) * timeStep;
    timeline.setAttribute('aria-valuetext', `${back.toFixed(1)} seconds ago`);
    find('moment').textContent = running.hasScript
        ? 'has a script'
        : `${back === 0 ? (step * timeStep).toFixed(1) : `−${back.toFixed(1)}`} s · ${(history.bytes / 1000).toFixed(0)} kB`;
    timeline.title = running.hasScript ? 'A script moves this scene, and what it remembers does not go back' : '';
}

// -- knobs ------------------------------------------------------------------------------------------------------------------------------

type Read = (world: World) => number;
type Write = (world: World, value: number) => void;

function makeKnob(name: string, low: number, high: number, by: number, unit: string, read: Read, write: Write): Knob {
    const row = document.createElement('div');
    row.className = 'knob';
    const label = document.createElement('label');
    label.textContent = name;
    label.htmlFor = `knob-${name.toLowerCase()}`;
    const value = document.createElement('output');
    const input = Object.assign(document.createElement('input'), {type: 'range', id: label.htmlFor, min: String(low), max: String(high), step: String(by)});
    const reset = Object.assign(document.createElement('button'), {textContent: '↺', title: `${name} as the scene has it`});
    reset.setAttribute('aria-label', `Reset ${name.toLowerCase()}`);
    row.append(label, value, reset, input);
    find('knobs').append(row);
    let start = 0;
    let changed = false;
    const show = () => {
        value.textContent = `${Number(input.value)}${unit}`;
        reset.disabled = !changed;
    };
    const set = (to: number) => {
        changed = to !== start;
        input.value = String(to);
        resume();
        attempt(() => write(running.world, to));
        show();
    };
    input.addEventListener('input', () => set(Number(input.value)));
    reset.addEventListener('click', () => set(start));
    return {
        begin(world) {
            start = read(world);
            changed = false;
            input.value = String(start);
            show();
        },
        // After going back, the world has the setting of that time: the knob's holds.
        apply(world) {
            if (changed || read(world) !== start) attempt(() => write(world, Number(input.value)));
        },
    };
}

/// Sets a number of all shapes, from what the scene has and the knob's value. The newest ids that the number was read of are kept.
function shapesKnob(name: string, low: number, high: number, unit: string, usual: number, read: (world: World, shape: number) => number,
    write: (world: World, shape: number, was: number, value: number) => void): Knob {
    let started = new Map<number, number>();
    return makeKnob(name, low, high, 0.05, unit, () => {
        started = new Map();
        return usual;
    }, (world, value) => {
        for (const shape of shapesOf(world)) {
            const was = started.get(shape) ?? read(world, shape);
            started.set(shape, was);
            write(world, shape, was, value);
        }
        wakeAll(world);
    });
}

const knobs: Knob[] = [
    makeKnob('Gravity', -30, 30, 0.5, ' m/s²', (world) => -world.gravity().y, (world, value) => {
        world.setGravity({x: world.gravity().x, y: -value});
        wakeAll(world);
    }),
    shapesKnob('Friction', 0, 3, ' ×', 1, (world, shape) => world.shapeFriction(shape),
        (world, shape, was, value) => world.shapeSetFriction(shape, was * value)),
    shapesKnob('Restitution', -1, 1, ' more', 0, (world, shape) => world.shapeRestitution(shape),
        (world, shape, was, value) => world.shapeSetRestitution(shape, Math.min(1, Math.max(0, was + value)))),
    makeKnob('Substeps', 1, 16, 1, '', (world) => world.solver().substeps, (world, substeps) => world.setSolver({...world.solver(), substeps})),
    makeKnob('Iterations', 1, 32, 1, '', (world) => world.solver().iterations, (world, iterations) => world.setSolver({...world.solver(), iterations})),
];

function* bodiesOf(world: World): Iterable<BodyId> {
    const {bodies} = world.capacity();
    for (let slot = 0; slot < bodies; ++slot) {
        const body = world.bodyAt(slot);
        if (body !== 0) yield body;
    }
}
function* shapesOf(world: World) {
    for (const body of bodiesOf(world)) yield* world.bodyShapes(body);
}
function wakeAll(world: World) {
    for (const body of bodiesOf(world)) if (world.bodyType(body) === 'dynamic') world.bodyWake(body);
}

// -- the camera and the pointer ---------------------------------------------------------------------------------------------------------

/// What the bars take of the window, in pixels.
let bars = {above: 0, below: 0};
function measureBars() {
    const gap = 8;
    bars = {
        above: document.querySelector('header')!.getBoundingClientRect().bottom + gap,
        below: innerHeight - document.querySelector('footer')!.getBoundingClientRect().top + gap,
    };
    document.documentElement.style.setProperty('--below', `${bars.below}px`);
}
new ResizeObserver(measureBars).observe(document.querySelector('footer')!);
addEventListener('resize', measureBars);

function showAll() {
    const {above} = bars, below = Math.max(8, bars.below - (innerHeight - canvas.clientHeight));
    const area = {x: 8, y: above, width: canvas.clientWidth - 16, height: Math.max(80, canvas.clientHeight - above - below)};
    camera.fit(running.view, area);
    // Where the whole is small, what is played is shown near.
    const near = 24, played = camera.scale < near ? hero() : undefined; // pixels for each metre
    if (played === undefined) return;
    camera.scale = near;
    const {left, right} = running.view, half = area.width / 2 / near;
    camera.center({x: right - left > 2 * half ? Math.min(right - half, Math.max(left + half, played.x)) : (left + right) / 2, y: played.y}, area);
}

let dragged: JointId = 0;
const pointers = new Map<number, {x: number; y: number}>();
let tool = 'drag';

/// The dynamic body under a point, or within a finger's breadth of it.
function bodyAt(point: {x: number; y: number}, reach: number): BodyId {
    const {world} = running;
    const dynamic = (shape: number) => world.bodyType(world.shapeBody(shape)) === 'dynamic';
    const hit = world.overlapPoint(point).find(dynamic)
        ?? world.overlapBox({lower: {x: point.x - reach, y: point.y - reach}, upper: {x: point.x + reach, y: point.y + reach}}).find(dynamic);
    return hit === undefined ? 0 : world.shapeBody(hit);
}

function grab(point: {x: number; y: number}, reach: number): boolean {
    const body = bodyAt(point, reach);
    if (body === 0) return false;
    resume();
    const {world} = running;
    attempt(() => {
        dragged = world.createMouseJoint({body, target: point, maxForce: drag_acceleration * world.bodyMass(body), userData: drag_mark});
        world.bodyWake(body);
    });
    return dragged !== 0;
}
function letGo() {
    if (dragged !== 0 && running.world.jointIsValid(dragged)) running.world.destroyJoint(dragged);
    dragged = 0;
}

canvas.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    pointers.set(event.pointerId, {x: event.offsetX, y: event.offsetY});
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add('busy');
    if (pointers.size > 1) {
        hand.cancel();
        return letGo();
    }
    const point = camera.toWorld(event.offsetX, event.offsetY);
    if (!hand.begin(point)) grab(point, (event.pointerType === 'touch' ? 14 : 3) / camera.scale);
});
canvas.addEventListener('pointermove', (event) => {
    const old = pointers.get(event.pointerId);
    if (old === undefined) return;
    const now = {x: event.offsetX, y: event.offsetY};
    if (pointers.size === 2) {
        const other = [...pointers].find(([id]) => id !== event.pointerId)![1];
        const factor = Math.hypot(now.x - other.x, now.y - other.y) / Math.max(1, Math.hypot(old.x - other.x, old.y - other.y));
        camera.zoom(factor, (now.x + other.x) / 2, (now.y + other.y) / 2);
        camera.pan((now.x - old.x) / 2, (now.y - old.y) / 2);
    } else if (dragged !== 0) {
        if (running.world.jointIsValid(dragged)) running.world.jointSetTarget(dragged, camera.toWorld(now.x, now.y));
    } else if (tool !== 'drag') {
        hand.move(camera.toWorld(now.x, now.y));
    } else {
        camera.pan(now.x - old.x, now.y - old.y);
    }
    pointers.set(event.pointerId, now);
});
for (const type of ['pointerup', 'pointercancel'] as const) {
    canvas.addEventListener(type, (event) => {
        pointers.delete(event.pointerId);
        if (pointers.size === 0) canvas.classList.remove('busy');
        if (type === 'pointerup') hand.end();
        else hand.cancel();
        letGo();
    });
}
canvas.addEventListener('wheel', (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(-event.deltaY / 500), event.offsetX, event.offsetY);
}, {passive: false});
canvas.addEventListener('dblclick', () => (camera.fitted = true));

// -- buttons and keys -------------------------------------------------------------------------------------------------------------------

function setSpeed(to: number) {
    speed = to;
    find('slow').setAttribute('aria-pressed', String(to !== 1));
}
function stepOnce() {
    setPlaying(false);
    advance();
}
function choose(to: string) {
    tool = to;
    document.querySelector<HTMLInputElement>(`input[name=tool][value=${to}]`)!.checked = true;
}

const actions: Record<string, () => void> = {
    play: () => setPlaying(!playing),
    step: stepOnce,
    slow: () => setSpeed(speed === 1 ? 0.2 : 1),
    again: () => load(running.scene),
    settings() {
        const panel = find('panel');
        panel.hidden = !panel.hidden;
        find('settings').setAttribute('aria-expanded', String(!panel.hidden));
    },
    async prove() {
        await proveAll([running.scene]);
    },
    'prove-all': async () => proveAll(scenes),
};
for (const [id, action] of Object.entries(actions)) find(id).addEventListener('click', action);

timeline.addEventListener('input', () => look(Number(timeline.value)));
find('scene').addEventListener('change', () => load(scenes.find(({name}) => name === find<HTMLSelectElement>('scene').value)!));
for (const name of ['contacts', 'joints'] as const) {
    find(name).addEventListener('change', () => {
        painter[name === 'contacts' ? 'showContacts' : 'showJoints'] = find<HTMLInputElement>(name).checked;
    });
}
document.querySelectorAll<HTMLInputElement>('input[name=tool]').forEach((input) => {
    input.addEventListener('change', () => choose(input.value));
    input.addEventListener('pointerup', () => input.blur());
});
addEventListener('hashchange', () => {
    if (!hasFailed) void openAddress();
});
addEventListener('keydown', (event) => {
    if (!hasOpened()) return;
    const at = event.target as HTMLElement;
    // Controls keep the keys that they know themselves.
    if (event.ctrlKey || event.altKey || event.metaKey || at.matches('select')) return;
    if (at.matches('button') ? /^( |Enter)$/.test(event.key) : at.matches('input') && /^( |Arrow.*)$/.test(event.key)) return;
    if (player.takes(event.key)) return event.preventDefault();
    const keys: Record<string, () => void> = {
        Enter: () => hand.use(),
        ' ': actions.play!,
        ArrowRight: stepOnce,
        ArrowLeft: () => look((looking < 0 ? history.length : looking) - 1),
        r: actions.again!,
        1: () => choose('drag'),
        2: () => choose('box'),
        3: () => choose('ball'),
        4: () => choose('doll'),
        5: () => choose('car'),
        6: () => choose('shape'),
        7: () => choose('cut'),
        0: () => (camera.fitted = true),
    };
    const action = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (action === undefined) return;
    event.preventDefault();
    action();
});

async function proveAll(list: readonly SceneInfo[]) {
    const proof = find('proof');
    proof.className = '';
    const wrong: string[] = [];
    let last = '';
    for (const [i, scene] of list.entries()) {
        proof.textContent = `${i + 1} of ${list.length}: ${scene.name}`;
        await new Promise((done) => setTimeout(done)); // the page goes on meanwhile
        const {steps, hash, golden} = prove(scene);
        if (hash !== golden) wrong.push(`${scene.name}: ${hash}, not ${golden}`);
        last = `${scene.name} after ${steps} steps: ${hash}`;
    }
    proof.className = wrong.length === 0 ? 'good' : 'bad';
    if (wrong.length > 0) proof.textContent = `✗ ${wrong.join('; ')}`;
    else proof.textContent = list.length === 1 ? `✓ ${last}, as everywhere` : `✓ all ${list.length} scenes have the hashes that they have everywhere`;
}

// -- parts that stand in files of their own ---------------------------------------------------------------------------------------------

const stage: Stage = {
    get running() {
        return running;
    },
    get tool() {
        return tool;
    },
    camera,
    canvas,
    resume,
    attempt,
    say,
    bodyAt,
    setPlaying,
    open,
    saveScene: () => textAt(native.sandbox_save(0, drag_mark)),
};
const hand = makeHand(stage);
const player = makePlayer(stage, () => playing);
const overlay = makeOverlay(stage, hand, player);
const numbers = makeNumbers(stage);
const graph = makeGraph(stage);
const files = makeFiles(stage);
knobs.push(...makeSolverKnobs(stage));

// -- ------------------------------------------------------------------------------------------------------------------------------------

try {
    await start();
    listScenes();
    beside = new Beside(find('beside'), canvas, {running: () => running, again: () => load(running.scene), choose: loadByName, say});
    gallery = new Gallery(find('gallery'), load);
    setPlaying(playing);
    while (!hasOpened()) await openAddress();
    requestAnimationFrame((now) => {
        before = now;
        frame(now);
    });
    void keepOffline();
} catch (error) {
    hasFailed = true;
    say(`The engine did not start. ${(error as Error).message}`);
    clearTimeout(silence);
    for (const part of document.querySelectorAll<HTMLElement>('header, main, aside, footer')) part.inert = true;
}
