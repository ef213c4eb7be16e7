// How many arguments the functions of the package take, by its types.
import {readFileSync} from 'node:fs';

/// The parts between the commas that stand in no bracket.
function parts(text) {
    const found = [''];
    let depth = 0;
    for (const letter of text.replaceAll('=>', 'to')) {
        depth += '([{<'.includes(letter) - ')]}>'.includes(letter);
        if (letter === ',' && depth === 0) found.push('');
        else found[found.length - 1] += letter;
    }
    return found.filter((part) => part.trim() !== '');
}

/// Of each method of a world and each function: {needed, most}. A method that islet.d.ts has anew counts as there.
export const methods = new Map(), functions = new Map();
for (const file of ['types.d.ts', 'islet.d.ts']) {
    const types = readFileSync(new URL(`../dist/${file}`, import.meta.url), 'utf8');
    for (const [, start, name, listed] of types.matchAll(/^( {4}|export declare function )(\w+)\((.*)\): .*;$/gm)) {
        const parameters = parts(listed);
        const needed = parameters.findLastIndex((parameter) => !/^\s*\w+\?:|\| undefined$/.test(parameter)) + 1;
        (start.startsWith('export') ? functions : methods).set(name, {needed, most: parameters.length});
    }
}
