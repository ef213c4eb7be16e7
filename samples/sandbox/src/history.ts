// The way back: the newest moment as a whole image, and from each kept moment the way to the one before.
//
//     moments:   0 <- 10 <- 20 <- [30]
import {apply, delta, type World} from './engine';

interface Moment {
    step: number;
    back: Uint8Array; // delta from this moment to the one before; empty for the first
}

const seconds = 60;
const most_bytes = 200e6;

export class History {
    private moments: Moment[] = [];
    private image: Uint8Array = new Uint8Array(0); // of the newest
    private cursor: {place: number; image: Uint8Array} = {place: -1, image: new Uint8Array(0)}; // the moment last looked at
    bytes = 0;

    /// `stride`: steps between moments.
    constructor(private readonly timeStep: number, readonly stride: number) {}

    get length() {
        return this.moments.length;
    }

    /// Before each step.
    keep(world: World, step: number) {
        const last = this.moments.at(-1);
        if (last !== undefined && step < last.step + this.stride) return;
        const image = world.save();
        const back = last === undefined ? new Uint8Array(0) : delta(image, this.image);
        this.moments.push({step, back});
        this.bytes += back.length + image.length - this.image.length;
        this.image = image;
        this.cursor.place = -1;
        const most = seconds / this.timeStep / this.stride;
        while (this.moments.length > most + 1 || (this.bytes > most_bytes && this.moments.length > 2)) {
            this.moments.shift();
            const first = this.moments[0]!;
            this.bytes -= first.back.length;
            first.back = new Uint8Array(0);
        }
    }

    stepAt(place: number) {
        return this.moments[place]!.step;
    }

    imageAt(place: number): Uint8Array {
        let {place: at, image} = this.cursor;
        if (at < place) [at, image] = [this.moments.length - 1, this.image];
        for (; at > place; --at) image = apply(image, this.moments[at]!.back);
        this.cursor = {place, image};
        return image;
    }

    /// Forgets what came after a moment.
    cutAfter(place: number) {
        const image = this.imageAt(place);
        for (const {back} of this.moments.splice(place + 1)) this.bytes -= back.length;
        this.bytes += image.length - this.image.length;
        this.image = image;
        this.cursor.place = -1;
    }
}
