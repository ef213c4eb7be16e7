// What part of the world the canvas shows. World: metres, y up. Screen: CSS pixels, y down.

const closest = 4000; // pixels per metre
const mostGrowth = 3; // of the view, when the camera follows
const zoomPerPixel = 0.0015; // of a wheel's turn

export class Camera {
    constructor(view) {
        [this.left, this.bottom, this.right, this.top] = view;
        this.x = this.y = 0; // world point that is drawn at screen (0, 0)
        this.scale = 1; // pixels per metre
        this.fitted = true; // nobody has moved it since it was fitted
    }

    /// Shows the whole view inside a rectangle of the screen.
    fit(area) {
        const width = this.right - this.left, height = this.top - this.bottom;
        this.scale = Math.min(area.width / width, area.height / height);
        this.farthest = this.scale / 20;
        this.area = area;
        this.home = { scale: this.scale, left: this.left, bottom: this.bottom, right: this.right, top: this.top };
        this.x = (this.left + this.right) / 2 - (area.x + area.width / 2) / this.scale;
        this.y = (this.bottom + this.top) / 2 + (area.y + area.height / 2) / this.scale;
        this.fitted = true;
    }

    /// Goes after the action, a box [left, bottom, right, top] or null, as far as it leaves the view that was fitted: the view shifts, and grows up to three times.
    /// `share` of the way, from 0 to 1.
    follow(action, share) {
        const { area, home } = this;
        const width = home.right - home.left, height = home.top - home.bottom;
        const middle = [(home.left + home.right) / 2, (home.bottom + home.top) / 2];
        let scale = home.scale;
        if (action) {
            const margin = 0.1 * Math.min(width, height);
            const [left, bottom, right, top] = [action[0] - margin, action[1] - margin, action[2] + margin, action[3] + margin];
            if (left < home.left || bottom < home.bottom || right > home.right || top > home.top) {
                const growth = Math.min(Math.max(1, (right - left) / width, (top - bottom) / height), mostGrowth);
                scale /= growth;
                middle[0] = shifted(middle[0], (growth * width) / 2, left, right);
                middle[1] = shifted(middle[1], (growth * height) / 2, bottom, top);
            }
        }
        const x = middle[0] - (area.x + area.width / 2) / scale, y = middle[1] + (area.y + area.height / 2) / scale;
        this.scale += share * (scale - this.scale);
        this.x += share * (x - this.x);
        this.y += share * (y - this.y);
    }

    /// Zooms by a factor so that the world point under screen point (px, py) stays there.
    zoom(factor, px, py) {
        const scale = Math.min(Math.max(this.scale * factor, Math.min(this.farthest, closest)), closest);
        this.x += px / this.scale - px / scale;
        this.y -= py / this.scale - py / scale;
        this.scale = scale;
        this.fitted = false;
    }

    wheel(pixels, px, py) {
        this.zoom(Math.exp(-zoomPerPixel * pixels), px, py);
    }

    /// Moves what is shown by pixels.
    pan(dx, dy) {
        this.x -= dx / this.scale;
        this.y += dy / this.scale;
        this.fitted = false;
    }

    screenX(x) {
        return (x - this.x) * this.scale;
    }

    screenY(y) {
        return (this.y - y) * this.scale;
    }
}

/// The middle of an interval of so much to each side that moves only as far as it must to hold [low, high], or has that in its own middle.
function shifted(middle, half, low, high) {
    if (high - low > 2 * half) return (low + high) / 2;
    return Math.min(Math.max(middle, high - half), low + half);
}

/// 1, 2 or 5 times a power of ten that is at least so long.
export function roundLength(least) {
    const power = 10 ** Math.floor(Math.log10(least));
    return [1, 2, 5].map((digit) => digit * power).find((length) => length >= least) ?? 10 * power;
}
