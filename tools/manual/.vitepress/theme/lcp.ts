// A complementarity problem of two contacts, solved by projected Gauss-Seidel row by row: what <islet-pgs> shows.

/// A tower of two boxes that falls at 1 m/s and has just reached the ground.
export interface Tower {
    lower: number; // kg
    upper: number; // kg
    rise: number; // m/s, how much faster than the lower box the upper one goes up, before the impulses
}

export type Pair = [number, number];
export interface Problem {
    m: [Pair, Pair];
    q: Pair;
}

/// Row 0: ground and lower box; row 1: lower and upper box. An impulse on a box of mass m changes its speed by 1 / m.
export function problemOf({lower, upper, rise}: Tower): Problem {
    return {m: [[1 / lower, -1 / lower], [-1 / lower, 1 / lower + 1 / upper]], q: [-1, rise]};
}

/// m/s at which gap `row` opens after the impulses x.
export function speed({m, q}: Problem, x: Pair, row: 0 | 1): number {
    return q[row] + m[row][0] * x[0] + m[row][1] * x[1];
}

/// The new impulse of a row: the residual over the diagonal, relaxed by omega, and the whole impulse kept from pulling.
export function update(problem: Problem, x: Pair, row: 0 | 1, omega = 1): number {
    return Math.max(0, x[row] - (omega * speed(problem, x, row)) / problem.m[row][row]);
}

/// How far x is from a solution: per row |x - max(0, x - w / d)| d, in m/s, where d is the diagonal; the larger of the two.
export function residual(problem: Problem, x: Pair): number {
    return Math.max(...([0, 1] as const).map((row) => Math.abs(x[row] - update(problem, x, row)) * problem.m[row][row]));
}

/// The x after each row: the start, then two entries a sweep.
export function sweeps(problem: Problem, start: Pair, count: number, omega: number): Pair[] {
    const path: Pair[] = [[...start]];
    for (let i = 0; i < count; ++i) {
        for (const row of [0, 1] as const) {
            const x: Pair = [...path.at(-1)!];
            x[row] = update(problem, x, row, omega);
            path.push(x);
        }
    }
    return path;
}

/// The solution: each of the four choices of who pushes is tried.
export function solution(problem: Problem): Pair {
    const {m: [[a, b], [c, d]], q: [p, r]} = problem, determinant = a * d - b * c;
    const tries: Pair[] = [[0, 0], [-p / a, 0], [0, -r / d], [(b * r - d * p) / determinant, (c * p - a * r) / determinant]];
    return tries.reduce((best, x) => {
        const wrong = (y: Pair) => Math.max(-y[0], -y[1], 0) * a + residual(problem, y);
        return wrong(x) < wrong(best) ? x : best;
    });
}
