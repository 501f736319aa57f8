// The page computes the same bits as a host, from a server and from a disk.
import assert from 'node:assert/strict';
import { resolve } from 'node:path';
import { pathToFileURL } from 'node:url';
import { query } from './look.mjs';

export default function tests({ test, open, context, complaints, expected, out }) {
    test('sheets and pictures are those of a host, bit for bit', async () => {
        const page = await open('?run=0&reference=0');
        for (const { query: asked, fate, digest, width, height, pixels } of expected) {
            const found = await page.evaluate(async ([search, size]) => {
                const { engine, state, stage } = globalThis.playground;
                const { parse } = await import('playground/settings.js');
                const parsed = parse(search);
                Object.assign(state, { shared: parsed.shared, sheets: parsed.sheets });
                stage.restart();
                for (let count = 0; count < parsed.page.frames; count += 1) engine.frame(0);
                engine.draw(0, ...size);
                return { digest: engine.digest(0), pixels: engine.hash(), fate: engine.exports.fate(0) };
            }, [asked, [width, height]]);
            assert.deepEqual(found, { digest, pixels, fate }, asked);
        }
        // Q13 differs from Q24 only where links are relaxed: it measures these more coarsely. Other solvers have equal digests in both.
        const own = expected.filter(({ query: asked }) => !asked.includes('q13')).map(({ digest }) => digest);
        assert.equal(new Set(own).size, 18, 'every solver and number type has a digest of its own');
        await page.close();
    });

    test('an address sets the sheets, and the page shows it', async () => {
        for (const number of ['f32', 'q24']) {
            const { query: asked, digest } = expected.find((line) => line.query.includes(`solver=xpbd&number=${number}`));
            const page = await open(`?${asked}&lesson=4`);
            assert.equal(await page.textContent('.sheet [data-value=digest]'), digest);
            assert.equal(await page.inputValue('.sheet [data-key=solver]'), 'xpbd');
            assert.equal(await page.textContent('#lesson'), 'Lesson 4');
            assert.equal(await page.textContent('#run'), 'Play');
            await page.close();
        }
    });

    test('the first picture is there soon, and shows the framebuffer', async () => {
        const page = await open('?start=ball&run=0&reference=0');
        const ready = Number(await page.evaluate(() => document.body.dataset.ready));
        console.log(`    first picture after ${ready} ms`);
        assert.ok(ready < 3000, `${ready} ms`);
        const same = await page.evaluate(() => [0, 1].every((sheet) => {
            const canvas = document.querySelectorAll('.picture canvas')[sheet];
            const seen = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height).data;
            const drawn = globalThis.playground.engine.draw(sheet, canvas.width, canvas.height);
            return new Set(drawn).size > 50 && seen.every((byte, index) => byte === drawn[index]);
        }));
        assert.ok(same);
        await page.close();
    });

    test('the single file opens from a disk, with workers and addresses', async () => {
        const { query: asked, digest } = expected.find((line) => line.query.includes('solver=lines&number=q13'));
        const page = await open(`?${asked}`, pathToFileURL(resolve(out, 'playground.html')).href);
        assert.equal(await page.textContent('.sheet [data-value=digest]'), digest);
        await page.waitForFunction(() => document.querySelector('[data-value=error]').textContent !== '–');
        await page.click('#slow');
        assert.equal((await query(page)).get('slow'), '1');
        await page.close();
    });

    test('a folder that is opened from a disk names the file to open', async () => {
        const page = await context.newPage();
        await page.goto(pathToFileURL(resolve(out, 'playground/index.html')).href);
        await page.waitForSelector('#failed:not([hidden])');
        assert.match(await page.textContent('#failed'), /playground\.html/);
        await page.close();
        // The browser's complaints about scripts that it does not load.
        complaints.length = 0;
    });
}
