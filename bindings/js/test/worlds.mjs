// Scenes of the catalogue once more, by this package, and their golden hashes.
import {readFileSync} from 'node:fs';

const golden = new Map();
for (const line of readFileSync(new URL('../../../tests/determinism/golden.txt', import.meta.url), 'utf8').split('\n')) {
    const [scene, steps, hash] = line.split(' ');
    if (hash !== undefined && scene !== '#') golden.set(`${scene} ${steps}`, hash);
}
export const goldenHash = (scene, steps) => golden.get(`${scene} ${steps}`);

/// The hash as the table writes it.
export const hex = (hash) => hash.toString(16).padStart(16, '0');

/// As samples/scenes/flight.cpp makes it.
export async function makeHello(Islet) {
    const world = await Islet.createWorld();
    const floor = world.createBody();
    world.createPolygon(floor, Islet.makeBox(20, 1));
    const crate = world.createBody({type: 'dynamic', position: {x: 0, y: 8}});
    world.createPolygon(crate, Islet.makeBox(0.5, 0.5));
    return {world, floor, crate};
}

/// As samples/scenes/pyramids.cpp makes it.
export async function makePyramid(Islet) {
    const world = await Islet.createWorld({enableSleep: false});
    world.createPolygon(world.createBody({position: {x: 0, y: -1}}), Islet.makeBox(12, 1));
    const box = Islet.makeBox(0.5, 0.5);
    for (let row = 0; row < 10; ++row) {
        for (let i = 0; i < 10 - row; ++i) {
            world.createPolygon(world.createBody({type: 'dynamic', position: {x: -5 + 0.5 * (row + 1 + 2 * i), y: 0.5 * (2 * row + 1)}}), box);
        }
    }
    return {world};
}
