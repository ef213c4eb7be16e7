// All scenes by group, each with a small picture that moves while it is seen: a world of its own, which steps in what time a frame has left.
import {Running, scenes, type SceneInfo} from './engine';
import {Painter} from './draw';

const first_place = 2, last_place = 15; // of sandbox.cpp
const budget = 12; // ms of a frame
const seconds = 4; // of a scene, until it begins again
const many_bodies = 2500; // they are shown standing still
const first_steps = 40; // of a picture that stands still

interface Card {
    scene: SceneInfo;
    canvas: HTMLCanvasElement;
    painter: Painter | undefined;
    running: Running | undefined;
    done: boolean; // its picture stands still
}

export class Gallery {
    private readonly dialog = document.createElement('dialog');
    private readonly cards: Card[] = [];
    private readonly seen = new Set<Card>();
    private readonly free = Array.from({length: last_place - first_place + 1}, (_, i) => first_place + i);
    private readonly still = matchMedia('(prefers-reduced-motion: reduce)');
    private next = 0; // whose turn it is

    constructor(button: HTMLElement, choose: (scene: SceneInfo) => void) {
        // Its cards are made when somebody wants to see them.
        button.addEventListener('click', () => {
            if (this.cards.length === 0) this.fill(choose);
            this.dialog.showModal();
        });
    }

    private fill(choose: (scene: SceneInfo) => void) {
        const {dialog} = this;
        dialog.id = 'gallery-of-scenes';
        dialog.setAttribute('aria-labelledby', 'gallery-title');
        const title = Object.assign(document.createElement('h2'), {id: 'gallery-title', textContent: `${scenes.length} scenes`});
        const close = Object.assign(document.createElement('button'), {textContent: 'Close', autofocus: true});
        close.addEventListener('click', () => dialog.close());
        const bar = Object.assign(document.createElement('div'), {className: 'bar'});
        bar.append(title, close);
        dialog.append(bar);
        for (const group of new Set(scenes.map(({group}) => group))) {
            const heading = Object.assign(document.createElement('h3'), {textContent: group});
            const cards = Object.assign(document.createElement('ul'), {className: 'cards'});
            for (const scene of scenes.filter((scene) => scene.group === group)) {
                const item = document.createElement('li');
                item.append(this.makeCard(scene, choose));
                cards.append(item);
            }
            dialog.append(heading, cards);
        }
        // Keys of the world stay with the world.
        dialog.addEventListener('keydown', (event) => event.stopPropagation());
        dialog.addEventListener('click', (event) => event.target === dialog && dialog.close());
        dialog.addEventListener('close', () => {
            for (const card of this.cards) this.end(card);
        });
        document.body.append(dialog);
    }

    get open() {
        return this.dialog.open;
    }

    private makeCard(scene: SceneInfo, choose: (scene: SceneInfo) => void): HTMLButtonElement {
        const canvas = document.createElement('canvas');
        canvas.setAttribute('aria-hidden', 'true');
        const name = Object.assign(document.createElement('strong'), {textContent: scene.name.replaceAll('_', ' ')});
        const description = Object.assign(document.createElement('span'), {textContent: scene.description});
        const button = document.createElement('button');
        button.append(canvas, name, description);
        button.addEventListener('click', () => {
            this.dialog.close();
            choose(scene);
        });
        const card: Card = {scene, canvas, painter: undefined, running: undefined, done: false};
        this.cards.push(card);
        new IntersectionObserver(([entry]) => {
            if (entry!.isIntersecting) this.seen.add(card);
            else this.end(card);
        }, {root: this.dialog}).observe(button);
        return button;
    }

    /// In each frame, while it is open.
    draw() {
        const until = performance.now() + budget;
        const cards = [...this.seen];
        for (let turn = 0; turn < cards.length && performance.now() < until; ++turn) {
            this.next = (this.next + 1) % cards.length;
            this.advance(cards[this.next]!);
        }
    }

    private advance(card: Card) {
        if (card.done) return;
        if (card.running !== undefined && card.running.step * card.running.timeStep > seconds) this.restart(card);
        if (card.running === undefined) {
            const place = this.free.pop();
            if (place === undefined) return; // until another card is gone
            card.running = new Running(card.scene, 0, () => {}, place);
        }
        const {running} = card;
        const standing = this.still.matches || running.world.bodyCount() > many_bodies;
        const steps = !standing ? 2 : running.world.bodyCount() > many_bodies ? 1 : first_steps;
        for (let i = 0; i < steps; ++i) running.advance();
        card.painter ??= new Painter(card.canvas, false);
        card.painter.draw(running.world, this.cameraOf(card));
        if (!standing) return;
        this.restart(card);
        card.done = true;
    }

    private cameraOf({canvas, running}: Card) {
        const {left, bottom, right, top} = running!.view;
        const scale = Math.min(canvas.clientWidth / (right - left), canvas.clientHeight / (top - bottom)) * 0.96;
        return {x: (left + right) / 2, y: (bottom + top) / 2, scale};
    }

    /// Its world is gone; what it was drawn as stays.
    private restart(card: Card) {
        if (card.running === undefined) return;
        card.running.end();
        this.free.push(card.running.place);
        card.running = undefined;
        card.painter?.forget();
    }

    private end(card: Card) {
        this.seen.delete(card);
        this.restart(card);
    }
}
