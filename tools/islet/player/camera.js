// What part of the world the canvas shows. World: metres, y up. Screen: CSS pixels, y down.

const closest = 4000; // pixels per metre
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
        this.x = (this.left + this.right) / 2 - (area.x + area.width / 2) / this.scale;
        this.y = (this.bottom + this.top) / 2 + (area.y + area.height / 2) / this.scale;
        this.fitted = true;
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

/// 1, 2 or 5 times a power of ten that is at least so long.
export function roundLength(least) {
    const power = 10 ** Math.floor(Math.log10(least));
    return [1, 2, 5].map((digit) => digit * power).find((length) => length >= least) ?? 10 * power;
}
