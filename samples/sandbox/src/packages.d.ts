declare module '*/Box2D.compat.mjs' {
    const make: (options: {locateFile: (name: string) => string}) => Promise<unknown>;
    export default make;
}
