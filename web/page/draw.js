// Common parts of the plots: a canvas in device pixels, colours, ticks.

export const COLOURS = ['#b22226', '#26548c'];
const STYLE = { ink: '#6f6a61', rule: '#e4dfd4' };

// Clears a canvas and returns [context, width, height] in CSS pixels.
export function begin(canvas) {
    const ratio = Math.min(globalThis.devicePixelRatio || 1, 2);
    const { clientWidth: width, clientHeight: height } = canvas;
    const [columns, rows] = [Math.round(width * ratio), Math.round(height * ratio)];
    if (canvas.width !== columns || canvas.height !== rows) [canvas.width, canvas.height] = [columns, rows];
    const context = canvas.getContext('2d');
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.clearRect(0, 0, width, height);
    context.font = '11px system-ui, sans-serif';
    context.fillStyle = STYLE.ink;
    context.strokeStyle = STYLE.rule;
    context.lineWidth = 1;
    return [context, width, height];
}

// A round step (1, 2 or 5 times a power of ten) that divides a span into about `parts` parts.
export function step(span, parts) {
    const rough = span / parts;
    const power = 10 ** Math.floor(Math.log10(rough));
    return power * ([1, 2, 5].find((digit) => digit * power >= rough) ?? 10);
}

const SMALL = { '-': '⁻', 0: '⁰', 1: '¹', 2: '²', 3: '³', 4: '⁴', 5: '⁵', 6: '⁶', 7: '⁷', 8: '⁸', 9: '⁹' };

// 10ⁿ
export const power = (exponent) => (exponent === 0 ? '1' : `10${String(exponent).replace(/./g, (digit) => SMALL[digit])}`);
