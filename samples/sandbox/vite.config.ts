import {defineConfig} from 'vite';
import {withoutEval} from './box2d.plugin';
import {offline} from './offline.plugin';
import solverSettings from './solver_settings';

export default defineConfig({
    plugins: [solverSettings(), withoutEval(), offline()],
    base: './', // wherever the folder is served
    build: {
        outDir: '../../build/sandbox',
        emptyOutDir: true,
        assetsInlineLimit: 0, // the page's policy allows no data: scripts or styles
        target: 'es2022',
        modulePreload: false,
    },
    preview: {port: 8080},
});
