// Scenes as JSON, by the code of the program `islet`. A text from outside is first read in an instance of WebAssembly of its own, which is thrown away: whatever
// is wrong with it, nothing of the world that is played with is lost.
import {native, textAt} from './native';

export const most_text = 16e6; // bytes
const most_link = 100_000; // letters, of a scene in an address

let module: WebAssembly.Module | undefined;
export function setModule(to: WebAssembly.Module) {
    module = to;
}

/// What the C++ throws ends here: the sentence becomes an error.
export const thrower = (memory: () => WebAssembly.Memory) => ({
    thrown(at: number) {
        throw new Error(textAt(at, memory()));
    },
});

type Reader = Pick<typeof native, 'memory' | 'sandbox_text' | 'sandbox_load_text'> & {_initialize?(): void};

export function putText(text: string, to: Pick<typeof native, 'memory' | 'sandbox_text'> = native) {
    const bytes = new TextEncoder().encode(text);
    const at = to.sandbox_text(bytes.length);
    new Uint8Array(to.memory.buffer).set(bytes, at);
}

/// What is wrong with a scene file; undefined if nothing is.
export function wrongWith(text: string, more: number): string | undefined {
    if (text.length > most_text) return `The scene is too large: it has ${(text.length / 1e6).toFixed(0)} MB, and ${most_text / 1e6} MB are read.`;
    let reader: Reader;
    const imports: Record<string, Record<string, WebAssembly.ImportValue>> = {};
    for (const {module: from, name} of WebAssembly.Module.imports(module!)) (imports[from] ??= {})[name] = () => 0;
    imports.sandbox = thrower(() => reader.memory);
    try {
        reader = new WebAssembly.Instance(module!, imports).exports as unknown as Reader;
        reader._initialize?.();
        putText(text, reader);
        return reader.sandbox_load_text(0, more, 0, 0) === 0 ? 'The scene cannot be made.' : undefined;
    } catch (error) {
        const {message} = error as Error;
        return error instanceof WebAssembly.RuntimeError || error instanceof RangeError ? 'The scene is too large for this browser.' : `The scene cannot be read. ${message}`;
    }
}

// -- addresses --------------------------------------------------------------------------------------------------------------------------

async function through(bytes: BlobPart, stream: CompressionStream | DecompressionStream, most: number): Promise<Uint8Array<ArrayBuffer> | undefined> {
    const reader = new Blob([bytes]).stream().pipeThrough(stream as ReadableWritablePair<Uint8Array, Uint8Array>).getReader();
    const parts: Uint8Array[] = [];
    let length = 0;
    for (;;) {
        const {done, value} = await reader.read();
        if (done) break;
        parts.push(value);
        length += value.length;
        if (length > most) {
            await reader.cancel();
            return undefined;
        }
    }
    const all = new Uint8Array(length);
    let at = 0;
    for (const part of parts) {
        all.set(part, at);
        at += part.length;
    }
    return all;
}

/// A scene as the end of an address: packed, in letters that need no escapes.
export async function pack(text: string): Promise<string> {
    if (typeof CompressionStream === 'undefined') throw new Error('This browser cannot pack a scene into an address. Save it as a file instead.');
    const bytes = (await through(text, new CompressionStream('deflate-raw'), Infinity))!;
    let letters = '';
    for (const byte of bytes) letters += String.fromCharCode(byte);
    const packed = btoa(letters).replaceAll('+', '-').replaceAll('/', '_').replace(/=+$/, '');
    if (packed.length > most_link) throw new Error(`The scene is too large for an address: ${(packed.length / 1000).toFixed(0)} kB. Save it as a file instead.`);
    return packed;
}

/// The scene in such an end. Throws a sentence if there is none.
export async function unpack(packed: string): Promise<string> {
    if (typeof DecompressionStream === 'undefined') throw new Error('This browser cannot unpack the scene in the address.');
    if (packed.length > most_link) throw new Error(`The scene in the address is too large: ${(packed.length / 1000).toFixed(0)} kB.`);
    try {
        const bytes = Uint8Array.from(atob(packed.replaceAll('-', '+').replaceAll('_', '/')), (letter) => letter.charCodeAt(0));
        const text = await through(bytes, new DecompressionStream('deflate-raw'), most_text);
        if (text !== undefined) return new TextDecoder('utf-8', {fatal: true}).decode(text);
    } catch {
        throw new Error('The address holds no scene: it is damaged, or cut off.');
    }
    throw new Error(`The scene in the address is too large: it unpacks to more than ${most_text / 1e6} MB.`);
}
