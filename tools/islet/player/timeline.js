// The scrubber: a slider over a curve of one of the numbers, of which the part that has been played is drawn stronger.

export class Timeline {
    constructor(slider, canvas, frames, onSeek) {
        this.slider = slider;
        this.canvas = canvas;
        slider.max = frames - 1;
        slider.addEventListener("input", () => onSeek(slider.valueAsNumber));
    }

    draw(curve, frame) {
        this.slider.value = frame;
        const { canvas } = this;
        const ratio = window.devicePixelRatio || 1;
        const width = canvas.clientWidth, height = canvas.clientHeight;
        if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
            canvas.width = Math.round(width * ratio);
            canvas.height = Math.round(height * ratio);
        }
        const context = canvas.getContext("2d");
        const style = getComputedStyle(canvas);
        context.setTransform(ratio, 0, 0, ratio, 0, 0);
        context.clearRect(0, 0, width, height);
        const last = Math.max(1, curve.length - 1);
        const played = (frame / last) * width;
        const shape = this.#shape(curve, width, height);
        for (const [from, to, colour] of [[0, played, "--played"], [played, width, "--ahead"]]) {
            context.save();
            context.beginPath();
            context.rect(from, 0, to - from, height);
            context.clip();
            context.fillStyle = style.getPropertyValue(colour);
            context.fill(shape);
            context.restore();
        }
        context.fillStyle = style.getPropertyValue("--accent");
        context.fillRect(Math.min(Math.max(played - 1, 0), width - 2), 0, 2, height);
    }

    /// The area under the curve. Each column of pixels shows the largest of its frames, so that no peak is lost.
    #shape(curve, width, height) {
        const columns = Math.max(1, Math.min(Math.ceil(width), curve.length));
        const tops = new Float64Array(columns).fill(-Infinity);
        for (let i = 0; i < curve.length; ++i) {
            const column = Math.floor((i * columns) / curve.length);
            tops[column] = Math.max(tops[column], curve[i]);
        }
        const low = Math.min(0, ...tops), high = Math.max(low + 1e-12, ...tops);
        const path = new Path2D();
        path.moveTo(0, height);
        for (let i = 0; i < columns; ++i) {
            const y = height - 2 - ((tops[i] - low) / (high - low)) * (height - 4);
            path.lineTo((i / Math.max(1, columns - 1)) * width, y);
        }
        path.lineTo(width, height);
        path.closePath();
        return path;
    }
}
