// What the parts of the page share: the scene that is played with, and how to act on it.
import type {Running, BodyId} from './engine';
import type {Camera} from './camera';

export interface Point {
    x: number;
    y: number;
}

export interface Stage {
    readonly running: Running;
    readonly camera: Camera;
    readonly canvas: HTMLCanvasElement;
    readonly tool: string;
    /// Makes what is shown the present. Before anything changes the world.
    resume(): void;
    /// Runs what changes the world; what the engine says against it is shown.
    attempt(run: () => void): void;
    say(sentence: string): void;
    bodyAt(point: Point, reach: number): BodyId;
    setPlaying(to: boolean): void;
    /// Plays with another scene: one of the catalogue, or a scene file's text.
    open(text: string): void;
    saveScene(): string;
}

export const find = <T extends HTMLElement>(id: string) => document.getElementById(id) as T;

/// Whether the browser took the address: some take no more than a hundred in half a minute.
export function setAddress(address: string): boolean {
    try {
        window.history.replaceState(null, '', address);
        return true;
    } catch {
        return false;
    }
}

/// Makes an element.
export function make<K extends keyof HTMLElementTagNameMap>(
    tag: K, properties: Partial<Omit<HTMLElementTagNameMap[K], 'dataset' | 'style'>> = {}, ...children: (Node | string)[]): HTMLElementTagNameMap[K] {
    const element = Object.assign(document.createElement(tag), properties);
    element.append(...children);
    return element;
}
