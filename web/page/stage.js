// Both sheets in motion: frames, explosions, and the reference solution, which a worker computes.
import { distance, reference } from 'playground/engine.js';
import { explain, refuse } from 'playground/explain.js';

// The largest ω·h of the reference, for the stiffest motion.
const RESOLVED = 1;
// The stage gives up a reference that is later than this many frames.
const PATIENCE = 240;

export class Stage {
    // `follower()` makes a worker for the reference. `told` receives messages: { frame }, { error }, { exploded } or { note }.
    constructor(engine, state, follower, told) {
        Object.assign(this, { engine, state, follower, told });
        this.worker = null;
        this.following = false;
        this.starts = 0;
        this.restart();
    }

    settings(sheet) { return { ...this.state.shared, ...this.state.sheets[sheet] }; }

    restart() {
        const { engine } = this;
        this.frame = 0;
        this.events = [];
        this.times = [0, 0];
        this.waiting = new Map();
        this.held = new Set();
        // A sheet that its number type refuses does not exist.
        this.refused = [0, 1].map((sheet) => engine.start(sheet, this.settings(sheet)));
        this.explosions = this.refused.map((refused, sheet) => refused && refuse(this.settings(sheet), refused));
        const there = this.refused.indexOf(null);
        this.frequency = there < 0 ? 0 : engine.frequency(there);
        for (let index = 0; there >= 0 && index < this.state.shared.grid ** 2; index += 1) {
            if (engine.isHeld(there, index)) this.held.add(index);
        }
        this.explosions.forEach((explosion, sheet) => explosion && this.told({ exploded: sheet, explosion, refused: true }));
        this.#follow();
    }

    #follow() {
        this.starts += 1;
        this.following = Boolean(this.state.page.reference) && this.frequency > 0;
        if (!this.following) {
            this.told({ note: '' });
            return;
        }
        const settings = reference(this.state.shared, this.frequency, RESOLVED);
        this.worker ??= this.follower(({ frame, places, start }) => start === this.starts && this.#compare(frame, places));
        this.worker.postMessage({ follow: settings });
        this.told({ note: `Leapfrog in f64, ${settings.substeps} substeps a frame.` });
    }

    #compare(frame, places) {
        const waiting = this.waiting.get(frame);
        this.waiting.delete(frame);
        if (!waiting) return;
        if (!places) {
            this.#giveUp('The reference has exploded.');
            return;
        }
        waiting.forEach((own, sheet) => own && this.told({ error: distance(own, places), sheet, frame }));
    }

    #giveUp(note) {
        this.following = false;
        this.waiting.clear();
        this.told({ note });
    }

    // Applies an action of the hand to all sheets.
    act(event) {
        [0, 1].forEach((sheet) => this.explosions[sheet] || this.engine.act(sheet, event));
        if (event.hold) this.held[event.hold[1] ? 'add' : 'delete'](event.hold[0]);
        this.events.push(event);
    }

    // Applies shared settings that change while the sheets move.
    change() {
        [0, 1].forEach((sheet) => {
            if (this.explosions[sheet]) return;
            const refused = this.engine.change(sheet, this.settings(sheet));
            if (refused) this.#explode(sheet, refuse(this.settings(sheet), refused));
        });
        this.events.push({ change: { ...this.state.shared, substeps: 1, sweeps: 1 } });
    }

    #explode(sheet, explosion) {
        this.explosions[sheet] = explosion;
        this.told({ exploded: sheet, explosion });
    }

    step() {
        const { engine } = this;
        this.frame += 1;
        [0, 1].forEach((sheet) => {
            if (this.explosions[sheet]) return;
            const begun = performance.now();
            const fate = engine.frame(sheet);
            const time = performance.now() - begun;
            this.times[sheet] = this.times[sheet] ? 0.95 * this.times[sheet] + 0.05 * time : time;
            if (fate) this.#explode(sheet, explain(this.settings(sheet), fate, this.frequency));
            else this.told({ frame: this.frame, sheet, strain: engine.strain(sheet), energy: engine.energy(sheet) });
        });
        if (!this.following) return;
        this.waiting.set(this.frame, [0, 1].map((sheet) => (this.explosions[sheet] ? null : engine.places(sheet))));
        this.worker.postMessage({ frame: this.frame, events: this.events, start: this.starts });
        this.events = [];
        if (this.waiting.size > PATIENCE) this.#giveUp('This device does not keep up with the reference. Take fewer particles or softer springs.');
    }
}
