// Live plots of the last seconds, with a line for each sheet.
import { COLOURS, begin, power, step } from 'playground/draw.js';
import { FRAME } from 'playground/engine.js';

// Frames along the axis.
const SHOWN = 600;
const [LEFT, RIGHT, TOP, BOTTOM] = [44, 8, 8, 18];

export class Strip {
    // `log`: [lowest, highest] exponent of ten of a logarithmic axis.
    constructor(canvas, { log } = {}) {
        this.canvas = canvas;
        this.log = log;
        this.clear();
    }

    clear() {
        this.points = [[], []];
        this.last = 0;
    }

    // Adds the value of a sheet at a frame.
    add(sheet, frame, value) {
        const points = this.points[sheet];
        points.push([frame, value]);
        while (points[0][0] < frame - SHOWN) points.shift();
        this.last = Math.max(this.last, frame);
    }

    #axis(values) {
        if (!this.log) {
            const [low, high] = [Math.min(0, ...values), Math.max(0, ...values)];
            const span = high - low || 1;
            const by = step(span, 3);
            const [from, to] = [Math.floor(low / by), Math.ceil(high / by) || 1];
            const ticks = Array.from({ length: to - from + 1 }, (_, k) => (from + k) * by);
            return { ticks: ticks.map((tick) => [tick, Number(tick.toPrecision(6)).toString()]), from: from * by, to: to * by, place: (value) => value };
        }
        const place = (value) => Math.min(Math.max(Math.log10(value), this.log[0]), this.log[1]);
        const exponents = values.filter((value) => value > 0).map(place);
        let [from, to] = exponents.length ? [Math.floor(Math.min(...exponents)), Math.ceil(Math.max(...exponents))] : [-3, 0];
        if (from === to) to += 1;
        const by = Math.ceil((to - from) / 4);
        const ticks = [];
        for (let tick = to; tick >= from; tick -= by) ticks.push([tick, power(tick)]);
        return { ticks, from, to, place };
    }

    draw() {
        const [context, width, height] = begin(this.canvas);
        const values = this.points.flatMap((points) => points.map(([, value]) => value)).filter(Number.isFinite);
        const { ticks, from, to, place } = this.#axis(values);
        const first = Math.max(0, this.last - SHOWN);
        const x = (frame) => LEFT + ((frame - first) / SHOWN) * (width - LEFT - RIGHT);
        const y = (value) => height - BOTTOM - ((place(value) - from) / (to - from)) * (height - TOP - BOTTOM);
        const row = (tick) => Math.round(height - BOTTOM - ((tick - from) / (to - from)) * (height - TOP - BOTTOM)) + 0.5;
        context.textAlign = 'right';
        context.textBaseline = 'middle';
        context.beginPath();
        for (const [tick, name] of ticks) {
            context.moveTo(LEFT, row(tick));
            context.lineTo(width - RIGHT, row(tick));
            context.fillText(name, LEFT - 6, row(tick));
        }
        context.stroke();
        context.textAlign = 'center';
        context.textBaseline = 'alphabetic';
        for (let second = Math.ceil(first * FRAME / 2) * 2; second <= (first + SHOWN) * FRAME; second += 2) {
            context.fillText(`${second} s`, Math.min(Math.max(x(second / FRAME), LEFT + 6), width - RIGHT - 10), height - 4);
        }
        context.lineWidth = 1.75;
        context.lineJoin = 'round';
        this.points.forEach((points, sheet) => {
            context.strokeStyle = COLOURS[sheet];
            context.setLineDash(sheet ? [5, 3] : []);
            context.beginPath();
            for (const [frame, value] of points) {
                if (Number.isFinite(value) && (!this.log || value > 0)) context.lineTo(x(frame), y(value));
            }
            context.stroke();
        });
        context.setLineDash([]);
    }
}
