// Explanations of explosions and refusals: each is a name and a sentence.
import { FRAME } from 'playground/engine.js';
import { label } from 'playground/settings.js';

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

// Two significant digits; a power of ten for very large and very small numbers.
export function short(number) {
    if (number !== 0 && (Math.abs(number) >= 1e4 || Math.abs(number) < 1e-2)) {
        const [digits, power] = number.toExponential(1).split('e');
        const raised = String(Number(power)).replace(/\d/g, (digit) => SUPERSCRIPTS[digit]).replace('-', '⁻');
        return `${Number(digits)}·10${raised}`;
    }
    return String(Number(number.toPrecision(2)));
}

const OUTCOMES = {
    'not-finite': 'a number became infinite',
    'out-of-range': 'a particle left the range of the numbers',
    burst: 'a link has six times its rest length and a particle is 12 m away',
};

function leapfrog(settings, frequency) {
    const step = FRAME / settings.substeps;
    const product = frequency * step;
    if (product <= 2) {
        return [
            `ω·h = ${short(product)}, below 2`,
            'Springs alone would be stable here. Dampers, wind or strong stretching lower the limit of leapfrog. Take more substeps.',
        ];
    }
    const half = product ** 2 / 2 - 1;
    const growth = half + Math.sqrt(half ** 2 - 1);
    const enough = Math.floor((frequency * FRAME) / 2) + 1;
    return [
        `ω·h = ${short(product)} > 2`,
        `Leapfrog is stable while ω·h < 2. The sheet's stiffest motion has ω = ${short(frequency)} /s, and a substep takes h = ${short(1e3 * step)} ms. Every substep `
        + `multiplies this motion by ${short(growth)}. From ${enough} substeps on, or with softer springs, it would be stable.`,
    ];
}

function forwardEuler(settings, frequency) {
    const step = FRAME / settings.substeps;
    const [driven, braked] = [frequency ** 2 * step, settings.drag + settings.damping * 1e-3 * frequency ** 2];
    const growth = Math.sqrt(1 + (frequency * step) ** 2);
    const name = driven > braked ? `ω²·h = ${short(driven)} > ${short(braked)} = γ + τ·ω²` : `ω·h = ${short(frequency * step)}`;
    return [
        name,
        `Forward Euler needs ω²·h < γ + τ·ω², with drag γ and damping τ. Without both, no step is stable. The sheet's stiffest motion, ω = ${short(frequency)} /s, grows `
        + `${short(growth)}-fold every substep of ${short(1e3 * step)} ms.`,
    ];
}

// [name, sentence] for an explosion.
export function explain(settings, fate, frequency) {
    if (settings.solver === 'leapfrog') return leapfrog(settings, frequency);
    if (settings.solver === 'forward-euler') return forwardEuler(settings, frequency);
    if (fate === 'out-of-range') {
        const reach = (128 * 0.6) / (settings.grid - 1);
        return [
            `Out of range of ${settings.number.toUpperCase()}`,
            `Fixed point represents coordinates up to 128 cells from the origin, here ${short(reach)} m. A particle went further and would reappear at the other end.`,
        ];
    }
    return [
        OUTCOMES[fate][0].toUpperCase() + OUTCOMES[fate].slice(1),
        `${label('solver', settings.solver)} is stable for any step as long as only springs act. Other forces are evaluated at the step's start and can make it unstable. `
        + `ω·h = ${short((frequency * FRAME) / settings.substeps)}.`,
    ];
}

// [name, sentence] for a sheet that does not start.
export function refuse(settings, refusal) {
    const step = short((1e3 * FRAME) / settings.substeps);
    return [
        `${settings.number.toUpperCase()} is too coarse`,
        `In substeps of ${step} ms the number type would round the constant of ${refusal} by more than a sixteenth. Take fewer substeps, or f32 or f64.`,
    ];
}
