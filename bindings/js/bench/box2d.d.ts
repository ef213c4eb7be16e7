/** A scene as sandbox_describe tells it: the fields of a scene file. */
export interface SceneText {
    dt?: number;
    bodies: {type?: string; shapes: object[]}[];
    joints: {type: string}[];
}
export declare function box2dLacks(scene: SceneText): string;
export declare class Box2dWorld {
    constructor(Box2D: unknown, scene: SceneText);
    step(): void;
    readPoses(out: Float32Array): Float32Array;
    isAwake(index: number): boolean;
    destroy(): void;
}
