// Tests of errors against the reference, explosions and refusals.
import assert from 'node:assert/strict';
import { play } from './look.mjs';

export default function tests({ test, open }) {
    test('the reference agrees with itself, and its distance from others is their error', async () => {
        const page = await open('?run=0&solver=leapfrog&number=f64&substeps=64&solver2=xpbd&substeps2=4&grid=8');
        const note = await page.textContent('#reference-note');
        await play(page, 30);
        await page.waitForFunction(() => globalThis.playground.stage.waiting.size === 0);
        await page.waitForFunction(() => !document.querySelector('.sheet + .sheet [data-value=error]').textContent.includes('–'));
        const [left, right] = await page.evaluate(() => [...document.querySelectorAll('[data-value=error]')].map((shown) => {
            const [digits, power] = shown.textContent.split('·10');
            const exponent = (power ?? '⁰').replace('⁻', '-').replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (digit) => '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(digit));
            return Number(digits) * 10 ** Number(exponent);
        }));
        assert.ok(left < 1e-3 && right > 5 * left, `${note} ${left} ${right}`);
        await page.close();
    });

    test('a reference that is too late is given up, in words', async () => {
        const page = await open('?run=0&solver2=xpbd&grid=8');
        // The page receives no answer of the worker during these frames.
        await play(page, 250);
        assert.match(await page.textContent('#reference-note'), /does not keep up/);
        await page.click('#reset');
        assert.match(await page.textContent('#reference-note'), /Leapfrog in f64/);
        await page.close();
    });

    test('the largest grid moves in every number type, by every solver', async () => {
        const page = await open('?run=0&reference=0&grid=32');
        const moves = await page.evaluate(() => {
            const { engine, stage } = globalThis.playground;
            return ['f32', 'f64', 'q24', 'q13'].flatMap((number) => ['lines', 'xpbd', 'leapfrog', 'backward-euler', 'verlet', 'forward-euler'].map((solver) => {
                const refused = engine.start(0, { ...stage.settings(0), number, solver, substeps: 1, sweeps: 1 });
                const before = engine.digest(0);
                const fate = engine.frame(0);
                return !refused && !fate && engine.strain(0) < 0.1 && engine.digest(0) !== before;
            }));
        });
        assert.deepEqual(moves, Array(24).fill(true));
        await page.close();
    });

    test('an explosion is frozen, named and explained', async () => {
        const page = await open('?run=0&reference=0&solver=leapfrog&substeps=16&solver2=forward-euler&substeps2=16');
        await play(page, 120);
        const [left, right] = await page.evaluate(() => [...document.querySelectorAll('.explosion')].map((box) => ({
            shown: box.getClientRects().length > 0, name: box.querySelector('strong').textContent, why: box.querySelector('p').textContent,
        })));
        assert.ok(left.shown && right.shown);
        const strain = Number.parseFloat(await page.textContent('.sheet [data-value=strain]'));
        assert.ok(strain > 50, `it is seen to explode: ${strain} %`);
        const [, product] = left.name.match(/^ω·h = ([\d.]+) > 2$/);
        const exact = await page.evaluate(() => globalThis.playground.stage.frequency / 60 / 16);
        assert.ok(Math.abs(product / exact - 1) < 0.05 && exact > 2, `${left.name} ${exact}`);
        assert.match(left.why, /stable while ω·h < 2/);
        assert.match(right.name, /^ω²·h = .* > .* = γ \+ τ·ω²$/);
        const places = await page.evaluate(() => Math.max(...globalThis.playground.engine.places(0).map(Math.abs)));
        assert.ok(places < 12, `the last frame before: ${places}`);
        const digest = await play(page, 5);
        assert.equal(await play(page, 5), digest, 'frozen');
        // The number of substeps that the sentence recommends is the smallest stable one.
        const [, enough] = left.why.match(/From (\d+) substeps/);
        assert.ok(exact * 16 / enough < 2 && exact * 16 / (enough - 1) >= 2);
        await page.click('#reset');
        assert.equal(await page.evaluate(() => document.querySelector('.explosion').hidden), true);
        await page.close();
    });

    test('a constant that a number type does not represent is refused in words', async () => {
        const page = await open('?run=0&reference=0&number=q24&substeps=64&stiffness=0.01&fabric=interlock&grid=8&number2=f32');
        const [left, right] = await page.evaluate(() => [...document.querySelectorAll('.explosion')].map((box) => (box.hidden ? null : box.textContent)));
        assert.match(left, /Q24 is too coarse.*bend springs/);
        assert.equal(right, null);
        assert.equal(await page.textContent('.sheet [data-value=digest]'), '–');
        await play(page, 5, 1);
        await page.locator('.picture canvas').first().click();
        await page.close();
    });
}
