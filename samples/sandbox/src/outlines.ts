// The outlines of a world's bodies as paths of a canvas, in metres and in the body's own frame with y turned down. The sandbox and the manual's pages draw with
// them.
import type {BodyId, ShapeId, World} from '@islet/engine/bare';
import {Outline} from './outline';

export interface BodyPaths {
    body: BodyId;
    solid: Path2D; // what is filled
    lines: Path2D; // segments
    hasLines: boolean;
}

/// The paths of a world's bodies, each made when it is first asked for.
export class Outlines {
    private paths: BodyPaths[] = []; // by slot

    forget() {
        this.paths = [];
    }

    of(world: World, slot: number): BodyPaths {
        const body = world.bodyAt(slot), old = this.paths[slot];
        return old?.body === body ? old : (this.paths[slot] = pathsOf(world, body));
    }
}

function pathsOf(world: World, body: BodyId): BodyPaths {
    const paths: BodyPaths = {body, solid: new Path2D(), lines: new Path2D(), hasLines: false};
    for (const shape of world.bodyShapes(body)) {
        const outline = outlineOf(world, shape);
        outline.traceOwn(outline.isLine ? paths.lines : paths.solid);
        paths.hasLines ||= outline.isLine;
        if (!outline.isDisc) continue;
        const [{x, y}] = outline.points as [{x: number; y: number}];
        paths.solid.moveTo(x, -y); // a spoke, which shows how it turns
        paths.solid.lineTo(x + outline.radius, -y);
    }
    return paths;
}

function outlineOf(world: World, shape: ShapeId): Outline {
    switch (world.shapeType(shape)) {
        case 'circle': {
            const {center, radius} = world.shapeCircle(shape)!;
            return new Outline([center], radius);
        }
        case 'capsule': {
            const {point1, point2, radius} = world.shapeCapsule(shape)!;
            return new Outline([point1, point2], radius);
        }
        case 'polygon': {
            const {vertices, radius} = world.shapePolygon(shape)!;
            return new Outline(vertices, radius);
        }
        case 'segment': {
            const {point1, point2} = world.shapeSegment(shape)!;
            return new Outline([point1, point2], 0, true);
        }
        case 'chainSegment': {
            const {point1, point2} = world.shapeChainSegment(shape)!.segment;
            return new Outline([point1, point2], 0, true);
        }
        case 'halfSpace': {
            const {normal, offset} = world.shapeHalfSpace(shape)!;
            const far = 1000, x = normal.x * offset, y = normal.y * offset;
            const corner = (along: number, below: number) => ({x: x - far * (along * normal.y + below * normal.x), y: y + far * (along * normal.x - below * normal.y)});
            return new Outline([corner(1, 0), corner(1, 1), corner(-1, 1), corner(-1, 0)], 0);
        }
    }
}
