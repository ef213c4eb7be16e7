// Gives the page `virtual:solver-settings`: the fields of SolverDef as bindings/api.json describes them.
import {readFileSync} from 'node:fs';
import type {Plugin} from 'vite';

interface Field {
    name: string;
    type: string;
    default: unknown;
    doc?: string;
    unit?: string;
}
interface Api {
    structs: {name: string; fields: Field[]}[];
    enums: {name: string; doc?: string; values: {name: string; doc?: string}[]}[];
    constants: {name: string; value: unknown}[];
}

const camel = (name: string) => name.replace(/_([a-z])/g, (_, letter: string) => letter.toUpperCase());

/// What a field's comment begins with: "1 to 64.", ">= 0.", "Hz, > 0.", "0 < omega < 2.", "0 to max_shock."
function bounds(doc: string, constants: Map<string, unknown>): {least: number; above?: boolean; most?: number} {
    const value = (text: string) => Number(constants.get(text) ?? text);
    const between = /(\d[\d.]*) to (\d+|max_\w+)/.exec(doc);
    if (between) return {least: Number(between[1]), most: value(between[2]!)};
    const open = /(\d[\d.]*) < \w+ < (\d+)/.exec(doc);
    if (open) return {least: Number(open[1]), above: true, most: Number(open[2])};
    const least = /(>=|>) (\d[\d.]*)/.exec(doc);
    return {least: Number(least?.[2] ?? 0), above: least?.[1] === '>'};
}

export default function solverSettings(): Plugin {
    const id = '\0virtual:solver-settings';
    return {
        name: 'solver-settings',
        resolveId: (source) => (source === 'virtual:solver-settings' ? id : undefined),
        load(source) {
            if (source !== id) return undefined;
            const api = JSON.parse(readFileSync(new URL('../../bindings/api.json', import.meta.url), 'utf8')) as Api;
            const constants = new Map(api.constants.map(({name, value}) => [name, value]));
            const settings = api.structs.find(({name}) => name === 'SolverDef')!.fields.map(({name, type, doc = '', unit, ...field}) => {
                const choice = api.enums.find((one) => one.name === type);
                return {
                    key: camel(name),
                    label: name.replaceAll('_', ' '),
                    kind: type === 'bool' ? 'switch' : choice ? 'choice' : type === 'float' ? 'number' : 'count',
                    usual: typeof field.default === 'string' ? camel(field.default.replace(/.*::/, '')) : field.default,
                    unit: unit ?? '',
                    doc: doc || choice?.doc || '',
                    values: choice?.values.map((value) => ({key: camel(value.name), label: value.name.replaceAll('_', ' '), doc: value.doc ?? ''})),
                    ...(type === 'float' || type === 'uint32_t' ? bounds(doc, constants) : {}),
                };
            });
            return `export default ${JSON.stringify(settings)};`;
        },
    };
}
