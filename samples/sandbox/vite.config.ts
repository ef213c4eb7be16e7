import {defineConfig} from 'vite';

export default defineConfig({
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
