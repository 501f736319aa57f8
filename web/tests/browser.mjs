// Tests the page in a headless Chromium: node web/tests/browser.mjs PLAYWRIGHT OUT EXPECTED [PICTURES]
//
// PLAYWRIGHT is the folder of playwright-core, OUT the output folder of web/build.mjs, EXPECTED a file with the output of the program `expected`, PICTURES a folder for pictures
// of the page.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { createServer } from 'node:http';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { extname, join, resolve } from 'node:path';
import { argv } from 'node:process';
import controls from './controls.mjs';
import hands from './hands.mjs';
import host from './host.mjs';
import outcomes from './outcomes.mjs';
import screen from './screen.mjs';
import studies from './studies.mjs';

const [, , playwright, out, expectedFile, pictures] = argv;
const { chromium } = createRequire(import.meta.url)(resolve(playwright));
const expected = JSON.parse(await readFile(expectedFile, 'utf8'));

const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.wasm': 'application/wasm' };
const server = createServer(async (request, response) => {
    const { pathname } = new URL(request.url, 'http://localhost');
    const name = pathname === '/' ? '/index.html' : pathname;
    try {
        const bytes = await readFile(join(out, 'playground', name));
        response.writeHead(200, { 'content-type': TYPES[extname(name)] }).end(bytes);
    } catch {
        response.writeHead(404).end();
    }
});
await new Promise((listening) => { server.listen(0, '127.0.0.1', listening); });
const site = `http://127.0.0.1:${server.address().port}/`;

const profile = await mkdtemp(join(tmpdir(), 'playground-'));
const context = await chromium.launchPersistentContext(profile, {
    executablePath: '/usr/bin/chromium',
    headless: true,
    viewport: { width: 1280, height: 800 },
    args: ['--no-sandbox', '--disable-gpu', '--disable-quic', '--no-first-run', '--disable-background-networking', '--disable-component-update', '--disable-sync'],
});

// Errors and warnings of the page, and its requests to other sites.
const complaints = [];
context.on('console', (message) => ['error', 'warning'].includes(message.type()) && complaints.push(message.text()));
context.on('weberror', (error) => complaints.push(String(error.error())));
context.on('request', (request) => {
    if (!/^(data|blob|file):/.test(request.url()) && !request.url().startsWith(site)) complaints.push(`asks ${request.url()}`);
});
context.on('response', (response) => response.status() >= 400 && complaints.push(`${response.status()} ${response.url()}`));

async function open(query = '', base = site) {
    const page = await context.newPage();
    await page.goto(base + query);
    await page.waitForSelector('body[data-ready]');
    return page;
}

const tests = [];
const test = (name, run) => tests.push([name, run]);
for (const add of [host, hands, controls, outcomes, studies, screen]) add({ test, open, context, complaints, expected, out, pictures });

let failed = 0;
const begun = performance.now();
for (const [name, run] of tests) {
    const start = performance.now();
    try {
        complaints.length = 0;
        await run();
        assert.deepEqual(complaints, [], 'complaints of the page');
        console.log(`test ${name} ... ok <${((performance.now() - start) / 1e3).toFixed(1)}s>`);
    } catch (error) {
        failed += 1;
        console.log(`test ${name} ... FAILED\n${error.stack}`);
        for (const page of context.pages().slice(1)) await page.close();
    }
}
// In the form of cargo's summary, from which all tests are counted.
console.log(`test result: ${failed ? 'FAILED' : 'ok'}. ${tests.length - failed} passed; ${failed} failed; finished in ${((performance.now() - begun) / 1e3).toFixed(0)}s`);
await context.close();
server.close();
await rm(profile, { recursive: true, force: true });
process.exitCode = failed ? 1 : 0;
