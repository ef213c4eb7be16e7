// What part of the world a canvas shows. The sandbox and the page of `islet run --html` look through it. World: metres, y up. Screen: CSS pixels, y down.

const closest = 4000; // pixels per metre
const most_growth = 3; // of the view, when the camera follows

export interface Rectangle {
    left: number;
    bottom: number;
    right: number;
    top: number;
}

/// A part of the canvas, in pixels, that no panel covers.
export interface Area {
    x: number;
    y: number;
    width: number;
    height: number;
}

export class Camera {
    x = 0; // m, the middle of the canvas
    y = 0;
    scale = 50; // pixels per metre
    fitted = true; // nobody has moved it since it was fitted
    private width = 1; // pixels, of the canvas
    private height = 1;
    private farthest = 1;

    /// To be told of the canvas's size before anything else, and whenever that changes.
    resize(canvas: {readonly clientWidth: number; readonly clientHeight: number}) {
        this.width = canvas.clientWidth;
        this.height = canvas.clientHeight;
    }

    /// Shows a whole view in an area.
    fit(view: Rectangle, area: Area) {
        this.scale = scaleFor(view, area);
        this.farthest = Math.min(this.scale / 20, closest);
        this.center({x: (view.left + view.right) / 2, y: (view.bottom + view.top) / 2}, area);
        this.fitted = true;
    }

    /// Shows a place of the world in the middle of an area.
    center(place: {x: number; y: number}, area: Area) {
        [this.x, this.y] = this.centered(place, area, this.scale);
    }

    /// Goes after the action, a box or undefined, as far as it leaves the view: the view shifts, and grows up to three times. `share` of the way, from 0 to 1.
    follow(action: Rectangle | undefined, view: Rectangle, area: Area, share: number) {
        const width = view.right - view.left, height = view.top - view.bottom;
        const middle = {x: (view.left + view.right) / 2, y: (view.bottom + view.top) / 2};
        let scale = scaleFor(view, area);
        if (action !== undefined) {
            const margin = 0.1 * Math.min(width, height);
            const left = action.left - margin, bottom = action.bottom - margin, right = action.right + margin, top = action.top + margin;
            if (left < view.left || bottom < view.bottom || right > view.right || top > view.top) {
                const growth = Math.min(Math.max(1, (right - left) / width, (top - bottom) / height), most_growth);
                scale /= growth;
                middle.x = shifted(middle.x, (growth * width) / 2, left, right);
                middle.y = shifted(middle.y, (growth * height) / 2, bottom, top);
            }
        }
        const [x, y] = this.centered(middle, area, scale);
        this.scale += share * (scale - this.scale);
        this.x += share * (x - this.x);
        this.y += share * (y - this.y);
    }

    /// Zooms by a factor so that the world's point under a point of the screen stays there.
    zoom(factor: number, px: number, py: number) {
        const about = this.toWorld(px, py);
        this.scale = Math.min(Math.max(this.scale * factor, this.farthest), closest);
        const now = this.toWorld(px, py);
        this.x += about.x - now.x;
        this.y += about.y - now.y;
        this.fitted = false;
    }

    /// Moves what is shown by pixels.
    pan(dx: number, dy: number) {
        this.x -= dx / this.scale;
        this.y += dy / this.scale;
        this.fitted = false;
    }

    screenX(x: number) {
        return this.width / 2 + (x - this.x) * this.scale;
    }

    screenY(y: number) {
        return this.height / 2 - (y - this.y) * this.scale;
    }

    /// What of the world is on the canvas.
    seen(): Rectangle {
        const half = {x: this.width / 2 / this.scale, y: this.height / 2 / this.scale};
        return {left: this.x - half.x, bottom: this.y - half.y, right: this.x + half.x, top: this.y + half.y};
    }

    toWorld(px: number, py: number) {
        return {x: this.x + (px - this.width / 2) / this.scale, y: this.y - (py - this.height / 2) / this.scale};
    }

    private centered(place: {x: number; y: number}, area: Area, scale: number): [number, number] {
        const right = area.x + area.width / 2 - this.width / 2, down = area.y + area.height / 2 - this.height / 2;
        return [place.x - right / scale, place.y + down / scale];
    }
}

const scaleFor = (view: Rectangle, area: Area) => Math.min(area.width / (view.right - view.left), area.height / (view.top - view.bottom));

/// The middle of an interval of so much to each side that moves only as far as it must to hold [low, high], or has that in its own middle.
function shifted(middle: number, half: number, low: number, high: number): number {
    if (high - low > 2 * half) return (low + high) / 2;
    return Math.min(Math.max(middle, high - half), low + half);
}
