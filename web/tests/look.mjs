// Queries to a page and its sheets.

// Moves the sheets by some frames, and returns the digest of one.
export const play = (page, frames, sheet = 0) => page.evaluate(([count, of]) => {
    for (let frame = 0; frame < count; frame += 1) globalThis.playground.stage.step();
    return globalThis.playground.engine.digest(of);
}, [frames, sheet]);

export const frame = (page) => page.evaluate(() => globalThis.playground.stage.frame);
export const eye = (page) => page.evaluate(() => globalThis.playground.engine.eye());
export const held = (page) => page.evaluate(() => globalThis.playground.stage.held.size);
export const query = async (page) => new URLSearchParams(new URL(page.url()).search);

// The position of a particle on the page, CSS pixels.
export const spot = (page, index, sheet = 0) => page.evaluate(([particle, of]) => {
    const canvas = document.querySelectorAll('.picture canvas')[of];
    const { left, top, width, height } = canvas.getBoundingClientRect();
    const [x, y] = globalThis.playground.engine.pixel(of, [canvas.width, canvas.height], particle);
    return [left + ((x + 0.5) * width) / canvas.width, top + ((y + 0.5) * height) / canvas.height];
}, [index, sheet]);

// The distance of a particle from the position `before`, m.
export const moved = (page, index, before, sheet = 0) => page.evaluate(([particle, from, of]) => {
    const to = globalThis.playground.engine.place(of, particle);
    return Math.hypot(...to.map((x, axis) => x - from[axis]));
}, [index, before, sheet]);
export const place = (page, index, sheet = 0) => page.evaluate(([particle, of]) => globalThis.playground.engine.place(of, particle), [index, sheet]);
