// Writes sw.js, which keeps the page's files in the browser: after the first visit it opens without a network.
import {createHash} from 'node:crypto';
import {readFileSync, readdirSync, writeFileSync} from 'node:fs';
import {join} from 'node:path';
import type {Plugin} from 'vite';

/// What only some ask for is kept when it was asked for.
const later = /Box2D|box2d|\.map$|^sw\.js$/;

export function offline(): Plugin {
    let folder = '';
    return {
        name: 'offline',
        apply: 'build',
        configResolved(config) {
            folder = join(config.root, config.build.outDir);
        },
        closeBundle() {
            const files = readdirSync(folder, {recursive: true, withFileTypes: true})
                .filter((entry) => entry.isFile())
                .map((entry) => join(entry.parentPath, entry.name).slice(folder.length + 1).replaceAll('\\', '/'))
                .sort();
            const hash = createHash('sha256');
            for (const file of files) if (file !== 'sw.js') hash.update(file).update(readFileSync(join(folder, file)));
            const source = readFileSync(join(import.meta.dirname, 'src', 'sw.js'), 'utf8')
                .replace("'VERSION'", () => JSON.stringify(hash.digest('hex').slice(0, 16)))
                .replace("['FILES']", () => JSON.stringify(['./', ...files.filter((file) => !later.test(file) && file !== 'index.html')]));
            writeFileSync(join(folder, 'sw.js'), source);
        },
    };
}
