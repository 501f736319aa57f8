// Builds the page: node web/build.mjs MODULE OUT
//
// OUT/playground is a folder for any static file server. OUT/playground.html is the same page in one file, which opens from a disk. The page's scripts import each other
// through an import map; in the single file the map contains the scripts as data URLs.
import { cp, mkdir, readFile, readdir, rm, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { argv } from 'node:process';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

// The largest allowed download, bytes by gzip.
const MOST = 350 * 1024;

const [, , wasm, out] = argv;
const page = fileURLToPath(new URL('page', import.meta.url));
const folder = join(out, 'playground');
await rm(folder, { recursive: true, force: true });
await mkdir(folder, { recursive: true });
await cp(page, folder, { recursive: true });
await cp(wasm, join(folder, 'playground.wasm'));

const read = (name) => readFile(join(folder, name), 'utf8');
const names = (await readdir(folder)).sort();
const scripts = names.filter((name) => name.endsWith('.js'));
const imports = Object.fromEntries(await Promise.all(scripts.map(async (name) => (
    [`playground/${name}`, `data:text/javascript;base64,${Buffer.from(await read(name)).toString('base64')}`]
))));
const module = (await readFile(wasm)).toString('base64');

// Applies the replacements [from, to] to a text. Each `from` must occur exactly once.
function replace(text, parts) {
    return parts.reduce((whole, [from, to]) => {
        const halves = whole.split(from);
        if (halves.length !== 2) throw new Error(`${halves.length - 1} times in the page: ${from}`);
        return halves.join(to);
    }, text);
}

const single = replace(await read('index.html'), [
    ['<link rel="stylesheet" href="style.css">', `<style>\n${await read('style.css')}</style>`],
    ['{ "imports": { "playground/": "./" } }', JSON.stringify({ imports })],
    ['<noscript>', `<script type="text/plain" id="wasm">${module}</script>\n<noscript>`],
]);
await writeFile(join(out, 'playground.html'), single);

const packed = async (name) => gzipSync(await readFile(join(folder, name)), { level: 9 }).length;
const sizes = await Promise.all(names.map(packed));
const total = sizes.reduce((sum, size) => sum + size, 0);
const kilobytes = (bytes) => `${(bytes / 1024).toFixed(1)} KB`;
console.log(`playground: ${kilobytes(total)} by gzip, ${kilobytes(sizes[names.indexOf('playground.wasm')])} of it the module; single file ${kilobytes(single.length)}`);
if (total > MOST) throw new Error(`the page has ${total} bytes by gzip, more than ${MOST}`);
