// The shapes of bodies, as the page holds them.
import { Outline } from "../../../samples/sandbox/src/outline";

/// From [radius, x, y, x, y, ...], for a sensor with a word before them; a negative radius means lines from point to point.
export function outlineOf(told) {
    const isSensor = typeof told[0] === "string";
    const [radius, ...numbers] = isSensor ? told.slice(1) : told;
    const points = [];
    for (let i = 0; i < numbers.length; i += 2) points.push({ x: numbers[i], y: numbers[i + 1] });
    return new Outline(points, Math.max(0, radius), radius < 0, isSensor);
}
