import {readFileSync} from 'node:fs';
import {fileURLToPath} from 'node:url';
import {defineConfig} from 'vitepress';

const root = fileURLToPath(new URL('../../../', import.meta.url));
const pages = `${root}build/manual/pages`; // pages.py makes them
const {guides, reference} = JSON.parse(readFileSync(`${pages}/contents.json`, 'utf8'));

export default defineConfig({
    title: 'Islet',
    description: 'The manual of Islet, a 2D physics engine with the same bits everywhere',
    lang: 'en',
    base: process.env.ISLET_MANUAL_BASE || '/',
    srcDir: pages,
    outDir: `${root}build/manual/site`,
    cacheDir: `${root}build/manual/cache`,
    head: [['link', {rel: 'icon', href: 'data:,'}]],
    vue: {template: {compilerOptions: {isCustomElement: (tag) => tag.startsWith('islet-')}}},
    markdown: {theme: {light: 'github-light-high-contrast', dark: 'github-dark-high-contrast'}},
    vite: {
        resolve: {alias: {'@islet/engine/bare': `${root}bindings/js/dist/islet.js`}},
        build: {assetsInlineLimit: 0, chunkSizeWarningLimit: 3000},
        publicDir: `${pages}/static`, // files of the tree
        logLevel: 'warn',
    },
    themeConfig: {
        outline: [2, 3],
        search: {provider: 'local'},
        nav: [
            {text: 'Guide', link: '/guide'},
            {text: 'Reference', link: '/reference/'},
            {text: 'PGS explained', link: '/pgs'},
            {text: 'Benchmarks', link: '/benchmarks'},
        ],
        sidebar: {
            '/reference/': [{text: 'Reference', link: '/reference/', items: reference}],
            '/source/': [],
            '/': [{text: 'All pages', link: '/guide'}, ...guides],
        },
        docFooter: {prev: false, next: false},
    },
});
