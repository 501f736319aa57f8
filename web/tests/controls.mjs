// Every control, and its value in the address.
import assert from 'node:assert/strict';
import { readFile, readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { frame, play, query } from './look.mjs';

export default function tests({ test, open }) {
    test('every control changes the sheets and the address', async () => {
        const page = await open('?run=0&reference=0&wind=1&grid=8&solver=verlet');
        const shown = await page.evaluate(() => [...document.querySelectorAll('[data-key]')].map((input) => [input.dataset.key, Boolean(input.closest('.sheet + .sheet'))]));
        assert.equal(shown.length, 2 * 4 + 6 + 7);
        const LIVE = new Set(['damping', 'drag', 'wind', 'heading', 'tilt', 'roll', 'ball']);
        for (const [key, right] of shown) {
            const sheet = right ? 1 : 0;
            // A start brings its wind along, so this sets the wind again.
            await page.locator('[data-key=wind]').fill('1');
            await page.click('#reset');
            await play(page, LIVE.has(key) ? 5 : 0);
            const results = await page.evaluate(async ([name, of, live]) => {
                const { stage, engine, state } = globalThis.playground;
                const { parse } = await import('playground/settings.js');
                const input = document.querySelectorAll(`[data-key=${name}]`)[of];
                const run = (frames) => {
                    for (let count = 0; count < frames; count += 1) stage.step();
                    return engine.digest(of);
                };
                const set = (value) => {
                    if (input.type === 'checkbox') input.checked = !input.checked;
                    else input.value = value;
                    if (input.type === 'range') input.dispatchEvent(new Event('input', { bubbles: true }));
                    input.dispatchEvent(new Event('change', { bubbles: true }));
                };
                const other = (() => {
                    if (input.type === 'checkbox') return null;
                    if (input.type === 'range') return input.value < input.max ? Math.min(Number(input.value) + 4 * Number(input.step), input.max) : input.min;
                    return [...input.options].map(({ value }) => value).find((value) => value !== input.value);
                })();
                const [was, start] = [input.value, stage.frame];
                const usual = run(45);
                document.getElementById('reset').click();
                for (let count = 0; count < start; count += 1) stage.step();
                set(other);
                const kept = live ? stage.frame === start : stage.frame === 0;
                const changed = run(45);
                const { shared, sheets } = parse(location.search);
                const said = JSON.stringify({ shared, sheets }) === JSON.stringify({ shared: state.shared, sheets: state.sheets });
                const result = { usual, changed, kept, said, search: location.search };
                set(was);
                return result;
            }, [key, key in { solver: 1, number: 1, substeps: 1, sweeps: 1 } ? sheet : 0, LIVE.has(key)]);
            assert.notEqual(results.changed, results.usual, key);
            assert.ok(results.kept, `${key} starts anew, or goes on`);
            assert.ok(results.said, `${key}: ${results.search}`);
        }
        await page.close();
    });

    test('buttons: step, pause, slow, reset, reference', async () => {
        const page = await open('?run=0');
        await page.click('#step');
        assert.equal(await frame(page), 1);
        await page.click('#run');
        await page.waitForFunction(() => globalThis.playground.stage.frame > 10);
        await page.waitForFunction(() => Number.parseFloat(document.querySelector('[data-value=error]').textContent) > 0);
        await page.click('#run');
        const at = await frame(page);
        await page.waitForTimeout(150);
        assert.equal(await frame(page), at, 'it pauses');
        await page.click('#slow');
        assert.equal(await page.getAttribute('#slow', 'aria-pressed'), 'true');
        await page.click('#reset');
        assert.equal(await frame(page), 0);
        assert.match(await page.textContent('#reference-note'), /Leapfrog in f64, \d+ substeps/);
        await page.click('#reference');
        assert.equal(await page.textContent('#reference-note'), '');
        assert.equal((await query(page)).get('reference'), '0');
        await play(page, 20);
        assert.equal(await page.textContent('[data-value=error]'), '–');
        await page.close();
    });

    test('the page understands every address in the lessons', async () => {
        const lessons = fileURLToPath(new URL('../../docs/lessons', import.meta.url));
        const texts = await Promise.all((await readdir(lessons)).filter((name) => name.endsWith('.md')).map((name) => readFile(join(lessons, name), 'utf8')));
        const addresses = texts.flatMap((text) => text.match(/(?<=`)\?lesson=[^`]+/g) ?? []);
        assert.ok(addresses.length >= 10, `${addresses.length}`);
        const page = await open('?run=0&reference=0');
        for (const address of addresses) {
            const { shared, sheets: [left, right], page: own } = await page.evaluate(async (search) => {
                const { parse } = await import('playground/settings.js');
                return parse(search);
            }, address);
            const known = { ...shared, ...left, ...Object.fromEntries(Object.entries(right).map(([key, value]) => [`${key}2`, value])), ...own };
            for (const [key, value] of new URLSearchParams(address)) assert.equal(String(known[key]), value, `${key} in ${address}`);
        }
        await page.close();
    });
}
