import * as Islet from './islet.js';

export * from './islet.js';
export {Islet};
export default Islet;
