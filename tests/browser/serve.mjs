// A server of a folder's files, on a port of the system's choice.
import {createReadStream, statSync} from 'node:fs';
import {createServer} from 'node:http';
import {extname, join, normalize, sep} from 'node:path';

const types = {'.html': 'text/html', '.js': 'text/javascript', '.json': 'application/json', '.css': 'text/css', '.svg': 'image/svg+xml', '.wasm': 'application/wasm'};

/** Gives the address and what ends the server. */
export async function serve(folder) {
    const server = createServer((request, response) => {
        const path = normalize(decodeURIComponent(new URL(request.url, 'http://localhost').pathname));
        const file = join(folder, path.endsWith(sep) ? `${path}index.html` : path);
        try {
            if (!file.startsWith(join(folder, sep)) || !statSync(file).isFile()) throw new Error('no file');
        } catch {
            response.writeHead(404).end();
            return;
        }
        response.writeHead(200, {'Content-Type': types[extname(file)] ?? 'application/octet-stream'});
        createReadStream(file).pipe(response);
    });
    await new Promise((done) => server.listen(0, '127.0.0.1', done));
    return {address: `http://127.0.0.1:${server.address().port}/`, close: () => server.close()};
}
