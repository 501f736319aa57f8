// The WebAssembly module with names instead of numbers. The page and the workers use it.

const LISTS = {
    number: ['f32', 'f64', 'q24', 'q13'],
    solver: ['lines', 'xpbd', 'leapfrog', 'backward-euler', 'verlet', 'forward-euler'],
    start: ['corners', 'curtain', 'flag', 'ball'],
    fabric: ['denim', 'interlock', 'rib-knit', 'ponte-roma', 'trousers', 'jacket', 'tablecloth', 'blanket'],
};

// In the order of `Settings::set` in src/settings.rs.
const PARAMETERS = [
    'grid', 'number', 'solver', 'substeps', 'sweeps', 'start', 'fabric', 'stiffness', 'shear', 'bend',
    'damping', 'drag', 'wind', 'heading', 'tilt', 'roll', 'ball',
];

// In the order of `Refusal` (src/parts.rs) and of `Fate` (src/likeness.rs).
const REFUSALS = [null, 'gravity', 'drag', 'wind', 'stretch springs', 'shear springs', 'bend springs', 'dampers'];
const FATES = [null, 'not-finite', 'out-of-range', 'burst'];

export const FRAME = 1 / 60;
const SIZE = 0.6;

const number = (name, value) => (name in LISTS ? LISTS[name].indexOf(value) : Number(value) * (name === 'damping' ? 1e-3 : 1));
const word = (result) => (result >>> 0).toString(16).padStart(8, '0');

export class Engine {
    static async open(bytes) {
        const { instance } = await WebAssembly.instantiate(bytes);
        return new Engine(instance.exports);
    }

    constructor(exports) {
        this.exports = exports;
        this.sides = [0, 0];
    }

    #say(settings) {
        PARAMETERS.forEach((name, index) => this.exports.set(index, number(name, settings[name])));
    }

    // Starts a sheet. Returns the name of a constant that the number type does not represent, or null.
    start(sheet, settings) {
        this.#say(settings);
        this.sides[sheet] = Number(settings.grid);
        return REFUSALS[this.exports.start(sheet)];
    }

    // Changes a moving sheet. Returns the name of a constant that the number type does not represent, or null.
    change(sheet, settings) {
        this.#say(settings);
        return REFUSALS[this.exports.change(sheet)];
    }

    // Moves a sheet by a frame. Returns the kind of its explosion, or null.
    frame(sheet) { return FATES[this.exports.frame(sheet)]; }

    // Applies an action of the hand to a sheet: { hold: [index, pinned] }, { grab: index }, { drag: place } or { release: true }.
    act(sheet, { hold, grab, drag, release }) {
        if (hold) this.exports.hold(sheet, hold[0], hold[1] ? 1 : 0);
        if (grab !== undefined) this.exports.grab(sheet, grab);
        if (drag) this.exports.drag(sheet, ...drag);
        if (release) this.exports.release(sheet);
    }

    isHeld(sheet, index) { return this.exports.is_held(sheet, index) !== 0; }

    digest(sheet) { return word(this.exports.digest(sheet)); }
    strain(sheet) { return this.exports.strain(sheet); }
    energy(sheet) { return this.exports.energy(sheet); }
    frequency(sheet) { return this.exports.frequency(sheet); }

    // A view of the module's memory, valid until the next call: memory that grows gets a new buffer.
    #floats(address, length) { return new Float64Array(this.exports.memory.buffer, address, length); }

    // Coordinates of all particles, m.
    places(sheet) { return this.#floats(this.exports.places(sheet), 3 * this.sides[sheet] ** 2).slice(); }

    place(sheet, index) { return Array.from(this.#floats(this.exports.places(sheet) + 24 * index, 3)); }

    // Turns the scene by the displacement of a pointer, pixels.
    turn(right, down) { this.exports.turn(right, down); }

    // Divides the distance of the eye by `factor`.
    zoom(factor) { this.exports.zoom(factor); }

    // The position of the eye, the same for all sheets.
    eye() {
        const [azimuth, elevation, distance] = this.#floats(this.exports.eye(), 3);
        return { azimuth, elevation, distance };
    }

    // The pixels of a picture, valid until the next call.
    draw(sheet, width, height) {
        const address = this.exports.draw(sheet, width, height);
        return new Uint8ClampedArray(this.exports.memory.buffer, address, 4 * width * height);
    }

    hash() { return word(this.exports.hash()); }

    // The particle under a pixel, or −1.
    pick(sheet, [width, height], [x, y]) { return this.exports.pick(sheet, width, height, x, y); }

    // The point (m) under a pixel, at the depth of the point `place`.
    under(sheet, [width, height], [x, y], place) {
        return Array.from(this.#floats(this.exports.under(sheet, width, height, x, y, ...place), 3));
    }

    // The pixel at which a particle is seen, or null.
    pixel(sheet, [width, height], index) {
        const packed = this.exports.pixel(sheet, width, height, index);
        return packed < 0 ? null : [packed >> 16, packed & 0xffff];
    }
}

// The RMS distance between the particles of two sheets, in sizes of the sheet.
export function distance(places, others) {
    let sum = 0;
    for (let k = 0; k < places.length; k += 1) sum += (places[k] - others[k]) ** 2;
    return Math.sqrt((3 * sum) / places.length) / SIZE;
}

// The settings of the reference solution of a sheet with highest angular frequency ω = `frequency`: leapfrog in f64, ω·h at most `most`.
export function reference(settings, frequency, most) {
    const substeps = Math.max(16, Math.ceil((frequency * FRAME) / most));
    return { ...settings, solver: 'leapfrog', number: 'f64', substeps, sweeps: 1 };
}
