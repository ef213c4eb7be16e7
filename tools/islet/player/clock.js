// Plays frames in time: which one is shown, at which speed, and whether it runs.

const longestTick = 0.1; // s; after a longer pause of the browser the run goes on where it was, not where it would be

export const speeds = [1 / 8, 1 / 4, 1 / 2, 1, 2, 4];

export class Clock {
    /// `times` of the frames, s, ascending.
    constructor(times) {
        this.times = times;
        this.frame = 0;
        this.time = times[0];
        this.speed = 1;
        this.playing = false;
        this.last = null; // when the last tick was, ms
    }

    get end() {
        return this.times.length - 1;
    }

    play() {
        if (this.frame === this.end) this.seek(0);
        this.playing = this.end > 0;
        this.last = null;
    }

    pause() {
        this.playing = false;
    }

    seek(frame) {
        this.frame = Math.min(Math.max(Math.round(frame), 0), this.end);
        this.time = this.times[this.frame];
    }

    /// Pauses, and goes so many frames on (or back).
    step(frames) {
        this.pause();
        this.seek(this.frame + frames);
    }

    /// Takes the next speed up (1) or down (-1).
    shift(by) {
        const index = speeds.indexOf(this.speed) + by;
        this.speed = speeds[Math.min(Math.max(index, 0), speeds.length - 1)];
    }

    /// Moves on to `now`, ms. Returns whether another frame is to be shown.
    tick(now) {
        if (!this.playing) return false;
        const passed = this.last === null ? 0 : Math.min((now - this.last) / 1000, longestTick);
        this.last = now;
        this.time += passed * this.speed;
        const before = this.frame;
        // A little early is better than twice the same frame when the screen's rate is the run's.
        while (this.frame < this.end && this.times[this.frame + 1] <= this.time + 1e-4) this.frame += 1;
        if (this.frame === this.end) this.pause();
        return this.frame !== before || !this.playing;
    }
}
