// Tests of the map of stability and of the plot of errors against cost.
import assert from 'node:assert/strict';
import { query } from './look.mjs';

export default function tests({ test, open }) {
    test('the map of stability has the limit where theory has it, and starts a case', async () => {
        const page = await open('?run=0&reference=0&grid=8&solver2=leapfrog&substeps2=32');
        await page.click('#map-run');
        let pictures = 0;
        while (await page.textContent('#map-run') === 'Stop') {
            pictures += await page.evaluate(() => new Promise((resolve) => { requestAnimationFrame(() => resolve(1)); }));
        }
        assert.ok(pictures > 3, 'the page goes on meanwhile');
        const cells = await page.evaluate(() => [...document.querySelectorAll('.map button')].map((cell) => ({
            gone: cell.classList.contains('gone'), product: Number(cell.getAttribute('aria-label').match(/ω·h = ([\d.]+)/)[1]),
        })));
        assert.equal(cells.length, 84);
        assert.equal(await page.textContent('#map-note'), '');
        for (const { gone, product } of cells) if (Math.abs(product - 2) > 0.15) assert.equal(gone, product > 2, `ω·h = ${product}`);
        const gone = page.locator('.map button.gone').last();
        const [, substeps] = (await gone.getAttribute('aria-label')).match(/^(\d+) substeps/);
        await gone.click();
        assert.equal((await query(page)).get('substeps2'), substeps);
        await page.waitForFunction(() => !document.querySelectorAll('.explosion')[1].hidden);
        await page.selectOption('[data-key=fabric]', 'jacket');
        assert.equal(await page.textContent('#map-note'), 'drawn with other settings');
        // Both clicks in one script: the map is complete before a second separate click.
        const stopped = await page.evaluate(() => {
            const button = document.getElementById('map-run');
            button.click();
            button.click();
            return [button.textContent, document.getElementById('map-note').textContent];
        });
        assert.deepEqual(stopped, ['Draw the map', 'stopped']);
        await page.focus('.map button[tabindex="0"]');
        await page.keyboard.press('ArrowRight');
        await page.keyboard.press('Enter');
        assert.equal(Number((await query(page)).get('stiffness')), 0.03);
        await page.close();
    });

    test('errors against cost fall with substeps, and a point is loaded', async () => {
        // Q24 refuses the shortest substeps in this fabric.
        const page = await open('?run=0&reference=0&grid=8&number2=q24&fabric=interlock');
        await page.click('#cost-run');
        await page.waitForFunction(() => document.getElementById('cost-run').textContent !== 'Stop', null, { timeout: 40_000 });
        const points = await page.evaluate(() => [...document.querySelectorAll('#cost .point')].map((point) => point.dataset.key));
        assert.ok(points.length > 20, `${points.length}`);
        const errors = await page.evaluate(() => [...document.querySelectorAll('#cost .point')].map((point) => (
            [point.dataset.key, Number(point.getAttribute('cy') ?? point.getAttribute('y'))]
        )));
        const of = (key) => errors.find(([name]) => name === key)[1];
        assert.ok(of('lines q24 1') < of('lines q24 8') && of('xpbd f32 1') < of('xpbd f32 64'), 'lower on the page is less');
        // Points may cover each other, so a mouse click might hit another one.
        await page.locator('#cost [data-key="xpbd f32 64"]').dispatchEvent('click');
        const search = await query(page);
        assert.deepEqual([search.get('solver2'), search.get('substeps2')], ['xpbd', '64']);
        await page.focus('#cost [tabindex="0"]');
        await page.keyboard.press('ArrowRight');
        const next = await page.evaluate(() => document.activeElement.dataset.key);
        await page.keyboard.press('Enter');
        const [solver, number, substeps] = next.split(' ');
        const { sheets } = await page.evaluate(() => globalThis.playground.state);
        assert.deepEqual([sheets[1].solver, sheets[1].number, String(sheets[1].substeps)], [solver, number, substeps]);
        await page.close();
    });
}
