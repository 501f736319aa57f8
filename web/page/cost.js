// The plot of error against cost: a point for each solver, number type and number of substeps. A press on a point loads its settings.
import { power } from 'playground/draw.js';
import { short } from 'playground/explain.js';
import { label } from 'playground/settings.js';

const STEPS = [1, 2, 4, 8, 16, 32, 64];
export const SOLVER_COLOURS = {
    lines: '#b22226', xpbd: '#26548c', leapfrog: '#2d7d5a', 'backward-euler': '#8a5a9e', verlet: '#c97b1f', 'forward-euler': '#6f6a61',
};
const SWEEPS = { lines: 2, verlet: 15 };
const [WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM] = [520, 340, 66, 14, 12, 40];

const svg = (tag, attributes, text) => {
    const element = document.createElementNS('http://www.w3.org/2000/svg', tag);
    Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
    if (text !== undefined) element.textContent = text;
    return element;
};

// The cases of the plot in these number types, few substeps first.
export function cases(numbers) {
    return STEPS.flatMap((substeps) => numbers.flatMap((number) => Object.keys(SOLVER_COLOURS).map((solver) => (
        { solver, number, substeps, sweeps: SWEEPS[solver] ?? 1 }
    ))));
}

export class CostPlot {
    // A press on a point calls `chosen` with its settings.
    constructor(parent, chosen) {
        this.chosen = chosen;
        this.svg = svg('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: 'group', 'aria-label': 'Error against cost' });
        parent.append(this.svg);
        this.clear([]);
    }

    clear(list) {
        this.list = list;
        this.points = [];
        this.floor = null;
        this.draw();
    }

    add({ point, error, time, floor }) {
        if (floor !== undefined) this.floor = floor;
        // Refused and exploded cases, and errors of a sheet's size or more, are not drawn.
        else if (error > 0 && error < 1 && time > 0) this.points.push({ ...this.list[point], error, time });
        this.draw();
    }

    // A logarithmic axis of whole decades around all points: { from, to, place }.
    #axis(values, least, most, low, high) {
        const exponents = values.map((value) => Math.log10(value));
        const [from, to] = exponents.length
            ? [Math.floor(Math.min(...exponents)), Math.max(Math.ceil(Math.max(...exponents)), Math.floor(Math.min(...exponents)) + 1)] : [least, most];
        return { from, to, place: (value) => low + ((Math.log10(value) - from) / (to - from)) * (high - low) };
    }

    draw() {
        const focused = this.svg.contains(document.activeElement) ? document.activeElement.dataset.key : null;
        const x = this.#axis(this.points.map(({ time }) => time), -2, 1, LEFT, WIDTH - RIGHT);
        const y = this.#axis([...this.points.map(({ error }) => error), ...(this.floor ? [this.floor] : [])], -6, 0, HEIGHT - BOTTOM, TOP);
        const parts = [];
        for (let tick = x.from; tick <= x.to; tick += 1) {
            const at = x.place(10 ** tick);
            parts.push(svg('path', { d: `M${at} ${TOP}V${HEIGHT - BOTTOM}`, class: 'rule' }));
            parts.push(svg('text', { x: at, y: HEIGHT - BOTTOM + 15, 'text-anchor': 'middle' }, tick < -2 ? power(tick) : String(10 ** tick).slice(0, 5)));
        }
        for (let tick = y.from; tick <= y.to; tick += 1) {
            const at = y.place(10 ** tick);
            parts.push(svg('path', { d: `M${LEFT} ${at}H${WIDTH - RIGHT}`, class: 'rule' }));
            parts.push(svg('text', { x: LEFT - 7, y: at + 4, 'text-anchor': 'end' }, power(tick)));
        }
        parts.push(svg('text', { x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 6, 'text-anchor': 'middle' }, 'milliseconds a frame, here'));
        const middle = (TOP + HEIGHT - BOTTOM) / 2;
        parts.push(svg('text', { x: 16, y: middle, 'text-anchor': 'middle', transform: `rotate(-90 16 ${middle})` }, 'error, sizes of the sheet'));
        if (this.floor > 0) parts.push(svg('path', { d: `M${LEFT} ${y.place(this.floor)}H${WIDTH - RIGHT}`, class: 'floor' }));
        const curves = new Map();
        this.points.forEach((point) => {
            const key = `${point.solver} ${point.number}`;
            curves.set(key, [...(curves.get(key) ?? []), point]);
        });
        for (const points of curves.values()) {
            const places = points.map((point) => `${x.place(point.time)} ${y.place(point.error)}`);
            const dashes = points[0].number.startsWith('q') ? '4 3' : 'none';
            parts.push(svg('path', { d: `M${places.join('L')}`, class: 'curve', stroke: SOLVER_COLOURS[points[0].solver], 'stroke-dasharray': dashes }));
        }
        const markers = this.points.map((point, index) => this.#marker(point, index, x, y, focused));
        if (markers.length && !markers.some((marker) => marker.getAttribute('tabindex') === '0')) markers[0].setAttribute('tabindex', 0);
        this.svg.replaceChildren(...parts, ...markers);
        this.svg.querySelector('[data-focused]')?.focus();
    }

    #marker(point, index, x, y, focused) {
        const { solver, number, substeps, error, time } = point;
        const key = `${solver} ${number} ${substeps}`;
        const name = `${label('solver', solver)}, ${label('number', number)}, ${substeps} substeps: error ${short(error)}, ${short(time)} ms a frame`;
        const attributes = { class: 'point', fill: SOLVER_COLOURS[solver], role: 'button', 'aria-label': name, 'data-key': key };
        attributes.tabindex = key === focused ? 0 : -1;
        if (key === focused) attributes['data-focused'] = '';
        const [cx, cy] = [x.place(time), y.place(error)];
        // Squares mark fixed point.
        const marker = number.startsWith('q')
            ? svg('rect', { ...attributes, x: cx - 4.5, y: cy - 4.5, width: 9, height: 9 })
            : svg('circle', { ...attributes, cx, cy, r: 5 });
        marker.append(svg('title', {}, name));
        marker.addEventListener('click', () => this.chosen(point));
        marker.addEventListener('keydown', (event) => this.#go(event, point, index));
        return marker;
    }

    #go(event, point, index) {
        if (event.key === 'Enter' || event.key === ' ') {
            event.preventDefault();
            this.chosen(point);
            return;
        }
        const by = { ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1 }[event.key];
        const markers = this.svg.querySelectorAll('.point');
        const next = by && markers[index + by];
        if (!next) return;
        event.preventDefault();
        event.target.setAttribute('tabindex', -1);
        next.setAttribute('tabindex', 0);
        next.focus();
    }
}
