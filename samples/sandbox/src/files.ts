// What goes out of the page and comes back: scenes, recordings, pictures and clips.
import {drawn, native} from './native';
import {hex} from './see';
import {most_text, pack, unpack} from './scene_text';
import {find, make, setAddress, type Stage} from './stage';

const most_recording = 200e6; // bytes

export interface Files {
    /// The scene in the page's address, if it holds one. Throws a sentence if that cannot be unpacked.
    fromAddress(): Promise<string | undefined>;
    /// After each step.
    afterStep(): void;
    /// The recording and the clip end with the scene.
    end(): void;
    /// After each picture.
    shown(): void;
    readonly isRecording: boolean;
}

function download(what: BlobPart, name: string, type: string) {
    const address = URL.createObjectURL(new Blob([what], {type}));
    make('a', {href: address, download: name}).click();
    setTimeout(() => URL.revokeObjectURL(address), 10_000);
}

async function copy(text: string): Promise<boolean> {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        return false; // there is no clipboard, or the page may not use it
    }
}

export function makeFiles(stage: Stage): Files {
    const name = () => stage.running.scene.name.replace(/[^\w-]/g, '_').slice(0, 60) || 'scene';
    const chooser = make('input', {type: 'file', id: 'open-file', accept: '.json,application/json', hidden: true, tabIndex: -1});
    chooser.setAttribute('aria-label', 'Scene file');
    const link = make('output', {id: 'link'});
    const row = make('div', {className: 'row'});
    find('files').append(chooser, row, link);
    const add = (id: string, text: string, title: string, run: () => void) => {
        const button = make('button', {id, textContent: text, title});
        button.addEventListener('click', run);
        row.append(button);
        return button;
    };

    async function openFile(file: File) {
        if (file.size > most_text) return stage.say(`${file.name} is too large: it has ${(file.size / 1e6).toFixed(0)} MB, and ${most_text / 1e6} MB are read.`);
        try {
            stage.open(await file.text());
        } catch {
            stage.say(`${file.name} cannot be read: it is a folder, or has changed or gone.`);
        }
        const {dataset} = document.documentElement;
        dataset.opened = String(Number(dataset.opened ?? 0) + 1);
    }
    chooser.addEventListener('change', () => {
        const file = chooser.files?.[0];
        chooser.value = '';
        if (file) void openFile(file);
    });
    addEventListener('dragover', (event) => event.preventDefault());
    addEventListener('drop', (event) => {
        event.preventDefault();
        const file = event.dataTransfer?.files[0];
        if (file) void openFile(file);
    });

    add('open', 'Open…', 'Opens a scene file, as `islet run` reads it', () => chooser.click());
    add('save', 'Save scene', 'The world as it is, as a scene file for `islet run`', () => {
        stage.attempt(() => download(stage.saveScene(), `${name()}.json`, 'application/json'));
    });
    add('share', 'Share', 'The world as it is, in the address of the page', () => void share());
    async function share() {
        link.textContent = '';
        try {
            const address = `${location.href.split('#')[0]}#scene=${await pack(stage.saveScene())}`;
            const taken = setAddress(address);
            const copied = await copy(address);
            if (!copied && !taken) return stage.say('This browser takes no new address now. Try again in a minute, or save the scene as a file.');
            link.textContent = `${copied ? 'Copied' : 'The page now has the address'}: ${(address.length / 1000).toFixed(1)} kB hold the whole scene.`;
        } catch (error) {
            stage.say((error as Error).message);
        }
    }

    // -- recordings ----------------------------------------------------------------------------------------------------------------------

    let recording = false;
    const record = add('record', 'Record', 'Records every call and step, for `islet replay`', () => {
        if (recording) return stopRecording(true);
        stage.resume();
        stage.attempt(() => {
            stage.running.world.startRecording();
            recording = true;
            tell();
        });
    });
    const tell = () => {
        record.textContent = recording ? 'Stop recording' : 'Record';
        record.setAttribute('aria-pressed', String(recording));
    };
    function stopRecording(keep: boolean) {
        if (!recording) return;
        recording = false;
        tell();
        stage.attempt(() => {
            const {world} = stage.running;
            const bytes = world.stopRecording() as Uint8Array<ArrayBuffer>;
            if (!keep) return;
            download(bytes, `${name()}.rec`, 'application/octet-stream');
            const hash = world.hash().toString(16).padStart(16, '0');
            link.textContent = `${(bytes.length / 1000).toFixed(0)} kB. islet replay ${name()}.rec ends with the hash ${hash}.`;
        });
    }

    // -- pictures ------------------------------------------------------------------------------------------------------------------------

    let wantsPicture = false;
    add('png', 'PNG', 'A picture of this moment', () => (wantsPicture = true));
    add('svg', 'SVG', 'A drawing of this moment, without limits of size', () => download(makeSvg(), `${name()}.svg`, 'image/svg+xml'));

    /// All that is drawn, where it stands on the page, on one canvas.
    const composed = make('canvas');
    function compose() {
        const {canvas} = stage, ratio = canvas.width / canvas.clientWidth;
        const layers = [...canvas.parentElement!.querySelectorAll('canvas')].filter((layer) => !layer.hidden && layer.width > 0);
        const places = layers.map((layer) => layer.getBoundingClientRect());
        const width = Math.round(ratio * Math.max(...places.map(({right}) => right))), height = Math.round(ratio * Math.max(...places.map(({bottom}) => bottom)));
        if (composed.width !== width || composed.height !== height) Object.assign(composed, {width, height});
        const context = composed.getContext('2d')!;
        context.clearRect(0, 0, width, height);
        places.forEach((at, i) => context.drawImage(layers[i]!, ratio * at.left, ratio * at.top, ratio * at.width, ratio * at.height));
    }

    function makeSvg(): string {
        const {camera, canvas} = stage, {scale} = camera;
        const width = canvas.clientWidth, height = canvas.clientHeight, halfX = width / 2 / scale, halfY = height / 2 / scale;
        const list = drawn(native.sandbox_draw(0, 1, camera.x - halfX, camera.y - halfY, camera.x + halfX, camera.y + halfY, 1));
        const number = (value: number) => String(Math.round(value * 10) / 10);
        const x = (at: number) => number(width / 2 + (at - camera.x) * scale), y = (at: number) => number(height / 2 - (at - camera.y) * scale);
        const parts: string[] = [];
        for (let at = 0; at < list.length;) {
            const kind = list[at]!, color = hex(list[at + 1]!);
            at += 4;
            if (kind === 0) {
                const radius = list[at]!, corners = list[at + 1]!;
                const points = Array.from({length: corners}, (_, i) => `${x(list[at + 2 + 2 * i]!)},${y(list[at + 3 + 2 * i]!)}`).join(' ');
                parts.push(`<polygon points="${points}" fill="${color}" stroke="${radius > 0 ? color : '#2b2014'}" stroke-width="${number(radius > 0 ? 2 * radius * scale : 1)}"/>`);
                at += 2 + 2 * corners;
            } else if (kind === 1) {
                parts.push(`<circle cx="${x(list[at]!)}" cy="${y(list[at + 1]!)}" r="${number(list[at + 2]! * scale)}" fill="${color}" stroke="#2b2014"/>`);
                at += 3;
            } else {
                const thick = kind === 2 ? number(2 * list[at + 4]! * scale) : '2';
                parts.push(`<line x1="${x(list[at]!)}" y1="${y(list[at + 1]!)}" x2="${x(list[at + 2]!)}" y2="${y(list[at + 3]!)}" stroke="${color}" stroke-width="${thick}"/>`);
                at += kind === 2 ? 5 : 4;
            }
        }
        const paper = getComputedStyle(document.documentElement).getPropertyValue('--paper').trim();
        return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 ${width} ${height}" stroke-linejoin="round" stroke-linecap="round">\n`
            + `<rect width="${width}" height="${height}" fill="${paper}"/>\n${parts.join('\n')}\n</svg>\n`;
    }

    // -- clips ---------------------------------------------------------------------------------------------------------------------------

    let clip: MediaRecorder | undefined;
    if (typeof MediaRecorder !== 'undefined' && 'captureStream' in composed) {
        const button = add('clip', 'Video', 'Films what the page shows', () => {
            if (clip !== undefined) return clip.stop();
            compose();
            const type = ['video/webm;codecs=vp9', 'video/webm', 'video/mp4'].find((one) => MediaRecorder.isTypeSupported(one));
            const parts: Blob[] = [];
            try {
                clip = new MediaRecorder(composed.captureStream(30), type === undefined ? {} : {mimeType: type});
                clip.start(1000);
            } catch {
                clip = undefined;
                return stage.say('This browser makes no video of a canvas.');
            }
            clip.addEventListener('dataavailable', ({data}) => parts.push(data));
            clip.addEventListener('stop', () => {
                const made = clip!.mimeType;
                clip = undefined;
                button.textContent = 'Video';
                button.setAttribute('aria-pressed', 'false');
                download(new Blob(parts, {type: made}), `${name()}.${made.includes('mp4') ? 'mp4' : 'webm'}`, made);
            });
            button.textContent = 'Stop video';
            button.setAttribute('aria-pressed', 'true');
        });
    }

    return {
        async fromAddress() {
            const hash = location.hash.slice(1);
            return hash.startsWith('scene=') ? unpack(hash.slice('scene='.length)) : undefined;
        },
        afterStep() {
            if (!recording) return;
            const {world} = stage.running;
            if (world.growRecording() < most_recording) return;
            stopRecording(true);
            stage.say(`The recording has reached ${most_recording / 1e6} MB and ends here.`);
        },
        end() {
            stopRecording(true);
        },
        shown() {
            if (!wantsPicture && clip === undefined) return;
            compose();
            if (!wantsPicture) return;
            wantsPicture = false;
            composed.toBlob((blob) => blob !== null && download(blob, `${name()}.png`, 'image/png'));
        },
        get isRecording() {
            return recording;
        },
    };
}
