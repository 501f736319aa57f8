// A sheet on the page: its picture, and the actions of pointers and keys on it.

// The displacement of the hand by a key, m.
const NUDGE = 0.03;

// Keys of a picture that has the focus: they turn it by pixels, or zoom by a factor.
const TURNS = { ArrowLeft: [-20, 0], ArrowRight: [20, 0], ArrowUp: [0, 20], ArrowDown: [0, -20] };
const ZOOMS = { '+': 1.15, '=': 1.15, '-': 1 / 1.15 };
// Directions: to the right, away from the viewer, up.
const PULLS = { a: [-1, 0, 0], d: [1, 0, 0], e: [0, 1, 0], q: [0, -1, 0], w: [0, 0, 1], s: [0, 0, -1] };

export class View {
    // `act` applies an action of the hand to all sheets, `changed` requests a new picture, `tool` returns the action of a press: pull, pin or turn.
    constructor(canvas, engine, sheet, { act, changed, tool, say }) {
        Object.assign(this, { canvas, engine, sheet, act, changed, tool, say });
        this.size = [1, 1];
        this.pointers = new Map();
        this.hand = null;
        this.chosen = null;
        this.explosion = null;
        this.context = canvas.getContext('2d');
        canvas.addEventListener('pointerdown', (event) => this.#down(event));
        canvas.addEventListener('pointermove', (event) => this.#move(event));
        for (const name of ['pointerup', 'pointercancel']) canvas.addEventListener(name, (event) => this.#up(event));
        canvas.addEventListener('wheel', (event) => this.#wheel(event), { passive: false });
        canvas.addEventListener('keydown', (event) => this.#key(event));
    }

    // Sets the picture's size, at most `most` pixels along its longer side.
    #fit(most) {
        const { clientWidth, clientHeight } = this.canvas;
        const ratio = Math.min(globalThis.devicePixelRatio || 1, most / Math.max(clientWidth, clientHeight, 1));
        const size = [clientWidth, clientHeight].map((side) => Math.max(16, Math.round(side * ratio)));
        if (size[0] !== this.canvas.width || size[1] !== this.canvas.height) [this.canvas.width, this.canvas.height] = size;
        this.size = size;
    }

    // Draws the picture, and marks the pinned particles `held` (null for a sheet that was refused).
    draw(most, held) {
        this.#fit(most);
        const [width, height] = this.size;
        this.context.putImageData(new ImageData(this.engine.draw(this.sheet, width, height), width, height), 0, 0);
        if (!held) return;
        const scale = width / this.canvas.clientWidth;
        held.forEach((index) => this.#dot(index, 3.5 * scale, '#2b2a28', scale));
        if (this.hand) this.#dot(this.hand.index, 6 * scale, '#e8a33d', scale);
        else if (this.chosen !== null && document.activeElement === this.canvas) this.#dot(this.chosen, 6 * scale, '#ffffff', scale);
    }

    #dot(index, radius, colour, scale) {
        const at = this.engine.pixel(this.sheet, this.size, index);
        if (!at) return;
        this.context.beginPath();
        this.context.arc(at[0] + 0.5, at[1] + 0.5, radius, 0, 2 * Math.PI);
        this.context.fillStyle = colour;
        this.context.strokeStyle = colour === '#ffffff' ? '#2b2a28' : '#ffffff';
        this.context.lineWidth = 1.5 * scale;
        this.context.fill();
        this.context.stroke();
    }

    // The pixel of the picture under a pointer.
    #pixel(event) {
        const { left, top, width, height } = this.canvas.getBoundingClientRect();
        return [((event.clientX - left) * this.size[0]) / width, ((event.clientY - top) * this.size[1]) / height].map(Math.floor);
    }

    #down(event) {
        if (event.button > 0) return;
        // Where this handler takes touches, the browser would focus the canvas too late.
        this.canvas.focus({ preventScroll: true });
        this.canvas.setPointerCapture(event.pointerId);
        this.pointers.set(event.pointerId, [event.clientX, event.clientY]);
        if (this.pointers.size > 1) { this.drop(); return; }
        const tool = event.shiftKey ? 'pin' : this.tool();
        const index = tool === 'turn' || this.explosion ? -1 : this.engine.pick(this.sheet, this.size, this.#pixel(event));
        if (index < 0) return;
        if (tool === 'pin') this.#pin(index);
        else this.#grab(index);
    }

    #move(event) {
        const before = this.pointers.get(event.pointerId);
        if (!before) return;
        const now = [event.clientX, event.clientY];
        if (this.hand && !this.hand.keys) {
            this.hand.place = this.engine.under(this.sheet, this.size, this.#pixel(event), this.hand.place);
            this.act({ drag: this.hand.place });
        } else if (this.pointers.size === 2) {
            const other = [...this.pointers].find(([id]) => id !== event.pointerId)[1];
            const span = ([x, y]) => Math.hypot(x - other[0], y - other[1]);
            this.engine.zoom(Math.max(span(now), 1) / Math.max(span(before), 1));
        } else {
            this.engine.turn(...now.map((at, axis) => at - before[axis]));
        }
        this.pointers.set(event.pointerId, now);
        this.changed();
    }

    #up(event) {
        this.pointers.delete(event.pointerId);
        if (!this.hand?.keys) this.drop();
    }

    #wheel(event) {
        // Scrolling the page does not zoom a picture that the pointer passes over.
        if (document.activeElement !== this.canvas) return;
        event.preventDefault();
        this.engine.zoom(Math.exp(-event.deltaY * 0.001));
        this.changed();
    }

    #grab(index, keys = false) {
        this.hand = { index, keys, place: this.engine.place(this.sheet, index) };
        this.act({ grab: index });
        this.changed();
    }

    #pin(index) {
        const held = !this.engine.isHeld(this.sheet, index);
        this.act({ hold: [index, held] });
        this.say(held ? 'Pinned' : 'Let go');
        this.changed();
    }

    drop() {
        if (!this.hand) return;
        this.hand = null;
        this.act({ release: true });
        this.changed();
    }

    // The particles that keys can choose: corners, middles of edges, and the middle.
    #places() {
        const side = this.engine.sides[this.sheet];
        const [middle, last] = [Math.floor(side / 2), side - 1];
        return [0, middle, last].flatMap((row) => [0, middle, last].map((column) => row * side + column));
    }

    #choose(by) {
        this.drop();
        const places = this.#places();
        const at = places.indexOf(this.chosen);
        this.chosen = places[(at + by + places.length + (at < 0 && by < 0 ? 1 : 0)) % places.length];
        const side = this.engine.sides[this.sheet];
        this.say(`Particle in column ${this.chosen % side + 1}, row ${Math.floor(this.chosen / side) + 1}`);
    }

    #pull(way) {
        if (this.chosen === null || this.explosion) return;
        if (!this.hand) this.#grab(this.chosen, true);
        this.hand.place = this.hand.place.map((x, axis) => x + NUDGE * way[axis]);
        this.act({ drag: this.hand.place });
    }

    #key(event) {
        if (event.ctrlKey || event.metaKey || event.altKey) return;
        const { key } = event;
        if (key in TURNS) this.engine.turn(...TURNS[key]);
        else if (key in ZOOMS) this.engine.zoom(ZOOMS[key]);
        else if (key === '.') this.#choose(1);
        else if (key === ',') this.#choose(-1);
        else if (key === 'p' && this.chosen !== null && !this.explosion) this.#pin(this.chosen);
        else if (key === 'Escape' || key === 'x') this.drop();
        else if (key in PULLS) this.#pull(PULLS[key]);
        else return;
        event.preventDefault();
        this.changed();
    }

    // Forgets the state of the hand when the sheet restarts.
    restart() {
        this.hand = null;
        this.pointers.clear();
        this.explosion = null;
        if (this.chosen !== null && !this.#places().includes(this.chosen)) this.chosen = null;
    }
}
