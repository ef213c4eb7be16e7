// Emscripten's glue of Box2D makes functions from text, which the page's policy forbids. Here it makes the same functions of closures.
import type {Plugin} from 'vite';

const invoker = `return function (humanName, throwBindingError, invoker, fn, runDestructors, fromRetWire, toClassParamWire, ...rest) {
    const toWire = rest.slice(0, argCount), destroy = rest.slice(argCount);
    return function (...given) {
        const destructors = needsDestructorStack ? [] : null, wired = [fn];
        if (isClassMethodFunc) wired.push(toClassParamWire(destructors, this));
        for (let i = 0; i < argCount; ++i) wired.push(toWire[i](destructors, given[i]));
        const value = invoker(...wired);
        if (needsDestructorStack) {
            runDestructors(destructors);
        } else {
            for (let i = isClassMethodFunc ? 1 : 2, next = 0; i < argTypes.length; ++i) {
                if (argTypes[i].destructorFunction !== null) destroy[next++](wired[isClassMethodFunc ? i : i - 1]);
            }
        }
        return returns ? fromRetWire(value) : undefined;
    };
}`;

const caller = `((handle, methodName, destructorsRef, args) => {
    const values = argFromPtr.map((read, i) => read(args + i * GenericWireTypeSize));
    const at = () => Emval.toValue(handle);
    const result = kind === 0 ? at()(...values) : kind === 1 ? at()[getStringOrSymbol(methodName)](...values) : kind === 2 ? new (at())(...values) : values.at(-1);
    return retType.isVoid ? undefined : emval_returnValue(toReturnWire, destructorsRef, result);
})`;

export function withoutEval(): Plugin {
    return {
        name: 'box2d-without-eval',
        enforce: 'pre',
        transform(code, id) {
            if (!id.endsWith('Box2D.compat.mjs')) return undefined;
            for (const [text, closure] of [
                ['return new Function(args1, invokerFnBody)', invoker],
                ['new Function(Object.keys(captures), functionBody)(...Object.values(captures))', caller],
            ] as const) {
                if (code.split(text).length !== 2) this.error(`Box2D's glue is not what it was: ${text}`);
                code = code.replace(text, () => closure);
            }
            code = code.replace(/await import\(['"]module['"]\)/, '{}'); // of node
            return code.includes('new Function(') ? this.error('Box2D still makes functions from text') : code;
        },
    };
}
