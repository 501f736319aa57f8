// Tests of mouse, touch and keys.
import assert from 'node:assert/strict';
import { eye, frame, held, moved, place, play, query, spot } from './look.mjs';

export default function tests({ test, open, context }) {
    test('a mouse drags a particle, in both sheets', async () => {
        const page = await open('?run=0&reference=0');
        await play(page, 100);
        const index = 8 * 16 + 8;
        const before = [await place(page, index, 0), await place(page, index, 1)];
        const [x, y] = await spot(page, index);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 60, y - 40, { steps: 4 });
        await play(page, 30);
        const dragged = await page.evaluate(() => globalThis.playground.engine.place(0, 8 * 16 + 8));
        for (const sheet of [0, 1]) {
            const way = await moved(page, index, before[sheet], sheet);
            assert.ok(way > 0.04, `sheet ${sheet}: ${way} m`);
        }
        await page.mouse.up();
        await play(page, 90);
        const back = await moved(page, index, dragged);
        assert.ok(back > 0.02, `it swings back: ${back} m`);
        await page.close();
    });

    test('a mouse carries a pin', async () => {
        const page = await open('?run=0&reference=0');
        const before = [await place(page, 0, 0), await place(page, 0, 1)];
        const [x, y] = await spot(page, 0, 1);
        await page.mouse.move(x, y);
        await page.mouse.down();
        await page.mouse.move(x + 40, y + 20, { steps: 2 });
        await play(page, 20);
        await page.mouse.up();
        for (const sheet of [0, 1]) assert.ok(await moved(page, 0, before[sheet], sheet) > 0.04);
        assert.equal(await held(page), 2);
        await page.close();
    });

    test('a finger drags a particle, two zoom', async () => {
        const page = await open('?run=0&reference=0');
        await play(page, 100);
        const index = 10 * 16 + 8;
        const before = await place(page, index);
        const turned = await eye(page);
        const [x, y] = await spot(page, index);
        const session = await context.newCDPSession(page);
        const touch = (type, ...points) => session.send('Input.dispatchTouchEvent', { type, touchPoints: points.map(([at, down], id) => ({ x: at, y: down, id })) });
        await touch('touchStart', [x, y]);
        await touch('touchMove', [x - 20, y - 10]);
        await touch('touchMove', [x - 60, y - 30]);
        await play(page, 30);
        assert.ok(await moved(page, index, before) > 0.04);
        assert.deepEqual(await eye(page), turned, 'the view stays');
        await touch('touchEnd');
        const [left, top] = await page.evaluate(() => {
            const box = document.querySelector('.picture canvas').getBoundingClientRect();
            return [box.left, box.top];
        });
        await touch('touchStart', [left + 40, top + 30]);
        await touch('touchStart', [left + 40, top + 30], [left + 90, top + 30]);
        await touch('touchMove', [left + 40, top + 30], [left + 190, top + 30]);
        await touch('touchEnd');
        const near = await eye(page);
        assert.ok(near.distance < 0.8 * turned.distance, `${near.distance}`);
        await page.close();
    });

    test('a press pins, turns, and beside the cloth it turns too', async () => {
        const page = await open('?run=0&reference=0');
        await play(page, 60);
        const at = await spot(page, 7 * 16 + 8);
        assert.equal(await held(page), 2);
        await page.click('text=Pin');
        await page.mouse.click(...at);
        assert.equal(await held(page), 3);
        await page.mouse.click(...at);
        assert.equal(await held(page), 2);
        await page.click('text=Pull');
        await page.keyboard.down('Shift');
        await page.mouse.click(...at);
        await page.keyboard.up('Shift');
        assert.equal(await held(page), 3, 'shift-click');
        const first = await eye(page);
        await page.click('text=Turn');
        await page.mouse.move(...at);
        await page.mouse.down();
        await page.mouse.move(at[0] + 50, at[1] + 20);
        await page.mouse.up();
        const second = await eye(page);
        assert.ok(second.azimuth !== first.azimuth && second.elevation !== first.elevation);
        await page.click('text=Pull');
        const box = await page.locator('.picture canvas').first().boundingBox();
        await page.mouse.move(box.x + 8, box.y + 8);
        await page.mouse.down();
        await page.mouse.move(box.x + 48, box.y + 8);
        await page.mouse.up();
        const third = await eye(page);
        assert.ok(third.azimuth !== second.azimuth);
        await page.mouse.wheel(0, -300);
        await page.waitForFunction((distance) => globalThis.playground.engine.eye().distance < distance, third.distance);
        await page.close();
    });

    test('keys have the effects of pointers', async () => {
        const page = await open('?run=0&reference=0');
        await page.keyboard.press('f');
        assert.equal(await frame(page), 1);
        await page.keyboard.press(' ');
        assert.equal(await page.textContent('#run'), 'Pause');
        await page.keyboard.press(' ');
        await page.keyboard.press('m');
        assert.equal((await query(page)).get('slow'), '1');
        await page.keyboard.press('r');
        assert.equal(await frame(page), 0);
        await play(page, 60);
        await page.focus('.picture canvas');
        const first = await eye(page);
        for (const key of ['ArrowRight', 'ArrowUp', '+']) await page.keyboard.press(key);
        const second = await eye(page);
        assert.ok(['azimuth', 'elevation', 'distance'].every((name) => second[name] !== first[name]));
        for (let count = 0; count < 5; count += 1) await page.keyboard.press('.');
        const index = 8 * 16 + 8;
        assert.equal(await page.textContent('#said'), 'Particle in column 9, row 9');
        const before = await place(page, index);
        for (let count = 0; count < 4; count += 1) await page.keyboard.press('w');
        await play(page, 30);
        const lifted = await place(page, index);
        assert.ok(lifted[2] > before[2] + 0.02, `${before[2]} ${lifted[2]}`);
        await page.keyboard.press('x');
        await page.keyboard.press('p');
        assert.equal(await held(page), 3);
        const pinned = await place(page, index);
        await play(page, 30);
        assert.equal(await moved(page, index, pinned), 0);
        await page.close();
    });
}
