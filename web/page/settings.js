// The settings: names, ranges, defaults, and their form in the page's address.

const SUBSTEPS = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];

const choice = (key, label, options, help) => ({ kind: 'choice', key, label, options, help });
const range = (key, label, least, most, step, unit, help) => ({ kind: 'range', key, label, least, most, step, unit, help });
const toggle = (key, label, help) => ({ kind: 'toggle', key, label, help });
const numbers = (values) => values.map((value) => [value, String(value)]);

// Settings of each sheet. A change restarts both sheets.
export const OWN = [
    choice('solver', 'Solver', [
        ['lines', 'Line solver'], ['xpbd', 'XPBD'], ['leapfrog', 'Leapfrog'],
        ['backward-euler', 'Backward Euler'], ['verlet', 'Verlet'], ['forward-euler', 'Forward Euler'],
    ]),
    choice('number', 'Numbers', [['f32', 'f32'], ['f64', 'f64'], ['q24', 'Q24, fixed'], ['q13', 'Q13, fixed']]),
    choice('substeps', 'Substeps', numbers(SUBSTEPS)),
    choice('sweeps', 'Sweeps', numbers([1, 2, 3, 4, 6, 8, 12, 15, 20, 30])),
];

// Settings of both sheets. A change restarts both sheets.
export const BOTH = [
    choice('start', 'Start', [
        ['corners', 'Held at two corners'], ['curtain', 'Curtain'], ['flag', 'Flag'], ['ball', 'Falls on a ball'],
    ]),
    choice('fabric', 'Fabric', [
        ['denim', 'Denim'], ['interlock', 'Interlock, a T-shirt'], ['rib-knit', 'Rib knit'], ['ponte-roma', 'Ponte Roma'],
        ['trousers', 'Trousers'], ['jacket', 'Jacket'], ['tablecloth', 'Tablecloth'], ['blanket', 'Blanket'],
    ]),
    choice('grid', 'Particles', [[8, '8 × 8'], [16, '16 × 16'], [32, '32 × 32']]),
    { ...range('stiffness', 'Stiffness', -2, 1, 0.25, '×'), log: true },
    toggle('shear', 'Shear springs'),
    toggle('bend', 'Bend springs'),
];

// Settings of both sheets that change while they move.
export const LIVE = [
    range('damping', 'Damping', 0, 5, 0.25, 'ms'),
    range('drag', 'Drag', 0, 5, 0.1, '/s'),
    range('wind', 'Wind', 0, 10, 0.25, 'm/s'),
    range('heading', 'Wind blows to', -180, 180, 15, '°'),
    range('tilt', 'Gravity, right', -60, 60, 5, '°'),
    range('roll', 'Gravity, away', -60, 60, 5, '°'),
    toggle('ball', 'Ball'),
];

export const SWEEPING = new Set(['lines', 'backward-euler', 'verlet']);

const LEFT = { solver: 'lines', number: 'f32', substeps: 8, sweeps: 2 };
const RIGHT = { solver: 'verlet', number: 'f32', substeps: 8, sweeps: 15 };
const SHARED = {
    start: 'corners', fabric: 'denim', grid: 16, stiffness: 1, shear: 1, bend: 1,
    damping: 0, drag: 0.5, wind: 0, heading: 90, tilt: 0, roll: 0, ball: 0,
};
// Further settings that a start brings along.
export const ALONG = { flag: { wind: 4, heading: 15, ball: 0 }, ball: { wind: 0, ball: 1 }, curtain: { wind: 2, heading: 90, ball: 0 }, corners: { wind: 0, ball: 0 } };
const PAGE = { lesson: '', run: 1, slow: 0, reference: 1, frames: 0, map: 0, cost: 0 };

const KNOWN = new Map([...OWN, ...BOTH, ...LIVE].map((setting) => [setting.key, setting]));

// The value of a parameter in an address, limited to its range; `otherwise` if it is invalid.
function valid(key, text, otherwise) {
    const setting = KNOWN.get(key);
    if (setting.kind === 'choice') {
        const found = setting.options.find(([value]) => String(value) === String(text));
        return found ? found[0] : otherwise;
    }
    const value = Number(text);
    if (text === '' || !Number.isFinite(value)) return otherwise;
    if (setting.kind === 'toggle') return value ? 1 : 0;
    const { least, most, log } = setting;
    if (log) return Math.min(Math.max(value, 10 ** least), 10 ** most);
    return Math.min(Math.max(value, least), most);
}

// Reads an address: { shared, sheets: [left, right], page }.
export function parse(query) {
    const asked = new URLSearchParams(query);
    const read = (defaults, suffix = '') => Object.fromEntries(Object.entries(defaults).map(([key, otherwise]) => {
        const name = key + suffix;
        return [key, asked.has(name) ? valid(key, asked.get(name), otherwise) : otherwise];
    }));
    const start = valid('start', asked.get('start') ?? '', SHARED.start);
    const page = Object.fromEntries(Object.entries(PAGE).map(([key, otherwise]) => {
        const text = asked.get(key);
        if (text === null) return [key, otherwise];
        if (key === 'lesson') return [key, /^\w{1,20}$/.test(text) ? text : ''];
        return [key, Math.max(0, Math.trunc(Number(text))) || 0];
    }));
    return { shared: read({ ...SHARED, ...ALONG[start], start }), sheets: [read(LEFT), read(RIGHT, '2')], page };
}

// The address of a state: the settings that differ from the defaults.
export function format({ shared, sheets, page }) {
    const said = new URLSearchParams();
    if (page.lesson) said.set('lesson', page.lesson);
    const write = (values, defaults, suffix = '') => Object.entries(values).forEach(([key, value]) => {
        if (value !== defaults[key]) said.set(key + suffix, value);
    });
    write(sheets[0], LEFT);
    write(sheets[1], RIGHT, '2');
    if (shared.start !== SHARED.start) said.set('start', shared.start);
    write(shared, { ...SHARED, ...ALONG[shared.start], start: shared.start });
    if (!page.reference) said.set('reference', 0);
    if (page.slow) said.set('slow', 1);
    return said.size ? `?${said}` : '';
}

export const label = (key, value) => {
    const setting = KNOWN.get(key);
    return setting.options?.find(([option]) => option === value)?.[1] ?? String(value);
};

// A value with its unit.
export function text(setting, value) {
    if (setting.log) return `${setting.unit} ${Number(value.toPrecision(2))}`;
    return `${Number(value.toFixed(2))} ${setting.unit}`.replace(' °', '°');
}
