// A shape's outline and how it becomes a path of a canvas. The sandbox, the manual's pages and the page of `islet run --html` draw with it.

interface Point {
    x: number;
    y: number;
}

/// The convex hull of points, its corners rounded by a radius (one point is a disc, two are a capsule, more a polygon against the clock), or lines from point
/// to point. Metres, in the body's own frame.
export class Outline {
    readonly isDisc: boolean;
    readonly reach: number; // m, from the body's origin
    readonly size: number; // m, about the diameter
    private readonly edges: number[]; // rad, of the outward normal of the edge from each point to the next

    constructor(readonly points: readonly Point[], readonly radius: number, readonly isLine = false, readonly isSensor = false) {
        this.isDisc = !isLine && points.length === 1;
        this.reach = Math.max(...points.map((p) => Math.hypot(p.x, p.y))) + radius;
        this.edges = points.map((p, i) => {
            const next = points[(i + 1) % points.length]!;
            return Math.atan2(p.x - next.x, next.y - p.y);
        });
        const span = (of: (p: Point) => number) => Math.max(...points.map(of)) - Math.min(...points.map(of)) + 2 * radius;
        this.size = (span((p) => p.x) + span((p) => p.y)) / 2;
    }

    /// Adds the outline to a path on the screen, where y points down: (x, y) is the body's origin there, c and s the cosine and sine of its angle, and `scale`
    /// the pixels of a metre.
    trace(path: CanvasPath, x: number, y: number, angle: number, c: number, s: number, scale: number) {
        const {points, edges, radius} = this, pixels = radius * scale;
        points.forEach((point, i) => {
            const px = x + (c * point.x - s * point.y) * scale, py = y - (s * point.x + c * point.y) * scale;
            if (this.isDisc) {
                path.moveTo(px + pixels, py);
                path.arc(px, py, pixels, 0, 2 * Math.PI, true); // the way polygons go, or where both lie would be a hole
            } else if (radius > 0) {
                // Angles grow against the clock in the world and with it on the screen.
                const from = -(angle + edges[(i + points.length - 1) % points.length]!), to = -(angle + edges[i]!);
                if (i === 0) path.moveTo(px + pixels * Math.cos(from), py + pixels * Math.sin(from));
                path.arc(px, py, pixels, from, to, true);
            } else if (i === 0) {
                path.moveTo(px, py);
            } else {
                path.lineTo(px, py);
            }
        });
        if (!this.isLine) path.closePath();
    }

    /// Adds the outline as it lies in the body's own frame, with y turned down.
    traceOwn(path: CanvasPath) {
        this.trace(path, 0, 0, 0, 1, 0, 1);
    }
}
