// The shapes of bodies, and how they become paths on a canvas.

/// From [radius, x, y, x, y, ...], for a sensor with a word before them: one point is a disc, two are a capsule, more a convex polygon whose corners the radius rounds; a
/// negative radius means lines from point to point.
export class Outline {
    constructor(told) {
        this.isSensor = typeof told[0] === "string";
        const [radius, ...numbers] = this.isSensor ? told.slice(1) : told;
        this.radius = radius;
        this.points = [];
        for (let i = 0; i < numbers.length; i += 2) this.points.push({ x: numbers[i], y: numbers[i + 1] });
        this.isLine = radius < 0;
        this.isDisc = radius >= 0 && this.points.length === 1;
        this.reach = Math.max(...this.points.map((p) => Math.hypot(p.x, p.y))) + Math.max(0, radius); // m, from the body's origin
        this.edges = this.points.map((p, i) => {
            const next = this.points[(i + 1) % this.points.length];
            return Math.atan2(p.x - next.x, next.y - p.y); // direction of the outward normal of the edge from here
        });
        const span = (of) => Math.max(...this.points.map(of)) - Math.min(...this.points.map(of)) + 2 * Math.max(0, radius);
        this.size = (span((p) => p.x) + span((p) => p.y)) / 2; // m, about the diameter
    }

    /// Adds the outline to the context's path; (x, y) is the body's origin on the screen, c and s the cosine and sine of its angle.
    trace(context, x, y, angle, c, s, scale) {
        const { points } = this;
        const radius = this.radius * scale;
        const rounded = this.radius > 0;
        for (let i = 0; i < points.length; ++i) {
            const px = x + (c * points[i].x - s * points[i].y) * scale;
            const py = y - (s * points[i].x + c * points[i].y) * scale;
            if (this.isDisc) {
                context.moveTo(px + radius, py);
                context.arc(px, py, radius, 0, 2 * Math.PI, true); // the way polygons go, or where both lie would be a hole
            } else if (rounded) {
                // Angles grow against the clock in the world and with it on the screen.
                const from = -(angle + this.edges[(i + points.length - 1) % points.length]);
                const to = -(angle + this.edges[i]);
                if (i === 0) context.moveTo(px + radius * Math.cos(from), py + radius * Math.sin(from));
                context.arc(px, py, radius, from, to, true);
            } else if (i === 0) {
                context.moveTo(px, py);
            } else {
                context.lineTo(px, py);
            }
        }
        if (!this.isLine) context.closePath();
    }
}
