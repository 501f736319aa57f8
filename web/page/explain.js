// Why a sheet has exploded: a name and a sentence.
import { FRAME } from 'playground/engine.js';
import { label } from 'playground/settings.js';

const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

// Two digits, as people write numbers.
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
    burst: 'links are six times too long and a particle is 12 m away',
};

function leapfrog(settings, frequency) {
    const step = FRAME / settings.substeps;
    const product = frequency * step;
    if (product <= 2) {
        return [
            `ω·h = ${short(product)}, below 2`,
            'Springs alone would be stable here. Dampers, wind or a sheet far longer than at rest make leapfrog\'s limit lower: take more substeps.',
        ];
    }
    const half = product ** 2 / 2 - 1;
    const growth = half + Math.sqrt(half ** 2 - 1);
    const enough = Math.floor((frequency * FRAME) / 2) + 1;
    return [
        `ω·h = ${short(product)} > 2`,
        `Leapfrog is stable while ω·h < 2. The sheet's stiffest motion has ω = ${short(frequency)} /s and a substep takes h = ${short(1e3 * step)} ms, so every substep `
        + `multiplies it by ${short(growth)}. From ${enough} substeps on it would stay, or with softer springs.`,
    ];
}

function forwardEuler(settings, frequency) {
    const step = FRAME / settings.substeps;
    const [driven, braked] = [frequency ** 2 * step, settings.drag + settings.damping * 1e-3 * frequency ** 2];
    const growth = Math.sqrt(1 + (frequency * step) ** 2);
    const name = driven > braked ? `ω²·h = ${short(driven)} > ${short(braked)} = γ + τ·ω²` : `ω·h = ${short(frequency * step)}`;
    return [
        name,
        `Forward Euler needs ω²·h below what drag γ and damping τ take; without them no step is stable. The sheet's stiffest motion, ω = ${short(frequency)} /s, grows `
        + `${short(growth)}-fold every substep of ${short(1e3 * step)} ms.`,
    ];
}

// The name and the sentence of an explosion.
export function explain(settings, fate, frequency) {
    if (settings.solver === 'leapfrog') return leapfrog(settings, frequency);
    if (settings.solver === 'forward-euler') return forwardEuler(settings, frequency);
    if (fate === 'out-of-range') {
        const reach = (128 * 0.6) / (settings.grid - 1);
        return [
            `Out of range of ${settings.number.toUpperCase()}`,
            `Fixed point counts to 128 cells from the origin, here ${short(reach)} m. A particle went further and would come back from the other end.`,
        ];
    }
    return [
        OUTCOMES[fate][0].toUpperCase() + OUTCOMES[fate].slice(1),
        `${label('solver', settings.solver)} is stable for any step where springs are all that acts; what acts besides is taken at the step's start. `
        + `ω·h = ${short((frequency * FRAME) / settings.substeps)}.`,
    ];
}

// Why a sheet does not start.
export function refuse(settings, refusal) {
    const step = short((1e3 * FRAME) / settings.substeps);
    return [
        `${settings.number.toUpperCase()} is too coarse`,
        `In substeps of ${step} ms the number type would change the constant of ${refusal} by more than a sixteenth. Take fewer substeps, or floats.`,
    ];
}
