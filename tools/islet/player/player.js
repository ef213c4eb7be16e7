// Puts the player together: reads what the page holds, and lets buttons, keys and time change what is shown.
import { Movie, bytesOf, looks } from "./movie.js";
import { Camera } from "../../../samples/sandbox/src/camera";
import { roundLength } from "./lengths.js";
import { outlineOf } from "./models.js";
import { Painter } from "./painter.js";
import { Numbers } from "./numbers.js";
import { Timeline } from "./timeline.js";
import { Clock } from "./clock.js";
import { listenToPointer } from "./pointer.js";
import "./player.css";

const element = (id) => document.getElementById(id);
const floatsOf = (id) => new Float32Array(bytesOf(id).buffer);
const fractions = { 0.125: "⅛", 0.25: "¼", 0.5: "½" };

const run = JSON.parse(element("run").textContent);
const models = JSON.parse(element("models").textContent).map((model) => model.map(outlineOf));
const numbersRead = floatsOf("numbers"), trailsRead = floatsOf("trails");
const slice = (all, i, length) => all.subarray(i * length, (i + 1) * length);
const columns = Object.fromEntries(run.columns.map((name, i) => [name, slice(numbersRead, i, run.frames)]));
const trails = Array.from({ length: run.trails }, (_, i) => slice(trailsRead, i, 2 * run.frames));
const stepOf = (frame) => Math.min(frame * run.stride, run.steps);

const movie = new Movie(bytesOf("movie"), run);
const canvas = element("world");
const camera = new Camera();
const [left, bottom, right, top] = run.view;
const view = { left, bottom, right, top };
let area; // where no panel lies over the view
const painter = new Painter(canvas, run, models, trails);
const clock = new Clock(Array.from({ length: run.frames }, (_, i) => stepOf(i) * run.dt));
const shown = { contacts: true, joints: true };
const followTime = 0.4; // s, in which the camera makes most of its way
let following = true;
let drawnAt = 0; // ms
let stale = true; // something changed since the last drawing

const redraw = () => (stale = true);
const numbers = new Numbers(element("rows"), columns, redraw);
const timeline = new Timeline(element("scrubber"), element("curve"), run.frames, (frame) => act(() => clock.seek(frame)));

function act(change) {
    change();
    redraw();
}

/// The view goes where no panel lies over it.
function fit() {
    const margin = 12;
    const dock = element("dock").getBoundingClientRect(), head = element("head").getBoundingClientRect();
    const panel = element("numbers-panel").getBoundingClientRect();
    const beside = panel.left > window.innerWidth / 2 && window.innerWidth >= 1000;
    const above = head.bottom + margin;
    const width = Math.max(50, (beside ? panel.left : window.innerWidth) - 2 * margin), height = Math.max(50, dock.top - margin - above);
    area = { x: margin, y: above, width, height };
    camera.resize(canvas);
    camera.fit(view, area);
    redraw();
}

function toggle(name) {
    shown[name] = !shown[name];
    element(name).setAttribute("aria-pressed", String(shown[name]));
    redraw();
}

function zoom(factor) {
    act(() => camera.zoom(factor, canvas.clientWidth / 2, canvas.clientHeight / 2));
}

const commands = {
    play: () => (clock.playing ? clock.pause() : clock.play()),
    back: () => clock.step(-1),
    forward: () => clock.step(1),
    first: () => clock.seek(0),
    last: () => clock.seek(clock.end),
    slower: () => clock.shift(-1),
    faster: () => clock.shift(1),
    contacts: () => toggle("contacts"),
    joints: () => toggle("joints"),
    closer: () => zoom(1.25),
    farther: () => zoom(1 / 1.25),
    follow: () => {
        following = !following;
        element("follow").setAttribute("aria-pressed", String(following));
        fit();
    },
    fit,
    help: () => element("help-panel").toggleAttribute("hidden"),
};
const keys = {
    " ": "play", ArrowLeft: "back", ArrowRight: "forward", Home: "first", End: "last", ArrowUp: "faster", ArrowDown: "slower",
    "+": "closer", "=": "closer", "-": "farther", 0: "fit", c: "contacts", j: "joints", f: "follow", "?": "help",
};

for (const button of document.querySelectorAll("[data-command]")) {
    button.addEventListener("click", () => act(commands[button.dataset.command]));
}
window.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === "Escape") element("help-panel").hidden = true;
    const command = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!command) return;
    event.preventDefault(); // or the slider and focused buttons would take it too
    if (event.shiftKey && (command === "back" || command === "forward")) act(() => clock.step(command === "back" ? -10 : 10));
    else act(commands[command]);
});
listenToPointer(canvas, camera, redraw, fit);
window.addEventListener("resize", () => (camera.fitted ? fit() : redraw()));
window.matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => act(() => painter.readColours()));

function showScaleBar() {
    const metres = roundLength(60 / camera.scale);
    element("scale").style.width = `${metres * camera.scale}px`;
    element("scale").textContent = metres >= 1 ? `${metres} m` : metres >= 0.01 ? `${Math.round(metres * 100)} cm` : `${metres * 1000} mm`;
}

function draw(now) {
    const { frame } = clock, state = movie.at(frame);
    if (following && camera.fitted) {
        // Where nothing plays, it is there at once, so that a frame always looks the same.
        const share = clock.playing ? 1 - Math.exp(-Math.min(now - drawnAt, 100) / 1000 / followTime) : 1;
        camera.follow(painter.action(state), view, area, share);
    }
    drawnAt = now;
    painter.draw(state, frame, camera, shown);
    numbers.show(frame);
    timeline.draw(numbers.curve, frame);
    element("step").textContent = stepOf(frame);
    element("time").textContent = clock.times[frame].toFixed(2);
    element("speed").textContent = `${fractions[clock.speed] ?? clock.speed}×`;
    element("play").classList.toggle("playing", clock.playing);
    element("play").setAttribute("aria-label", clock.playing ? "pause" : "play");
    document.documentElement.dataset.frame = frame;
    document.documentElement.classList.toggle("moved", !camera.fitted);
    showScaleBar();
}

function nextPicture(now) {
    if (clock.tick(now)) redraw();
    if (painter.resize()) {
        camera.resize(canvas);
        redraw();
    }
    if (stale) {
        stale = false;
        draw(now);
    }
    requestAnimationFrame(nextPicture);
}

function introduce() {
    element("scene").textContent = run.scene;
    element("description").textContent = run.description;
    element("steps").textContent = `/ ${run.steps}`;
    const facts = [`${run.steps} steps of ${Number((1000 * run.dt).toPrecision(4))} ms`, `${run.substeps} substeps`, `hash ${run.hash}`];
    element("facts").textContent = facts.join(" · ");
    if (run.stride > 1) {
        const left = run.contacts ? "" : ", without contacts";
        element("thinned").textContent = `to keep this page small, it shows one step of every ${run.stride}${left}`;
    }
    if (run.dropped > 0) element("dropped").textContent = `contacts without room in a step: up to ${run.dropped}; things pass through each other`;
    element("verdict").textContent = run.checked ? (run.passed ? "check passed" : "check failed") : "";
    element("verdict").classList.toggle("failed", run.checked && !run.passed);
    const seen = run.looks.map((look) => looks[look]);
    if (models.flat().some((outline) => outline.isSensor)) seen.push("sensor");
    for (const entry of element("legend").children) entry.hidden = !seen.includes(entry.className);
    if (!run.contacts) document.documentElement.classList.add("no-contacts");
    if (columns.joints.every((n) => n === 0)) document.documentElement.classList.add("no-joints");
    if (window.innerWidth < 700 || window.innerHeight < 500) element("numbers-panel").open = false;
}

introduce();
fit();
if (!window.matchMedia("(prefers-reduced-motion: reduce)").matches) clock.play();
requestAnimationFrame(nextPicture);
