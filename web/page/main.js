// The page: connects its parts and runs the clock.
import { controls } from 'playground/controls.js';
import { Engine } from 'playground/engine.js';
import { short } from 'playground/explain.js';
import { ALONG, BOTH, LIVE, OWN, SWEEPING, format, label, parse } from 'playground/settings.js';
import { Stage } from 'playground/stage.js';
import { Strip } from 'playground/strips.js';
import { studies } from 'playground/studies.js';
import { View } from 'playground/view.js';

const find = (id) => document.getElementById(id);

// Pixels along the longer side of a picture. Pictures that take too long get fewer pixels.
const QUALITIES = [640, 480, 360, 240];
// Pictures get smaller above LATE and larger below EARLY, ms each.
const [LATE, EARLY] = [15, 7];
// BUDGET: the most time for the frames before a picture, ms. LONGEST: the most time that frames make up for at once, s.
const BUDGET = 14;
const LONGEST = 0.1;

async function module() {
    const embedded = find('wasm');
    if (!embedded) return (await fetch('playground.wasm')).arrayBuffer();
    return Uint8Array.from(atob(embedded.textContent.trim()), (letter) => letter.charCodeAt(0)).buffer;
}

const bytes = await module();
const engine = await Engine.open(bytes);
const state = parse(location.search);

// A worker with its own module. It passes its results to `heard`.
function worker(heard) {
    const made = new Worker(import.meta.resolve('playground/worker.js'), { type: 'module' });
    made.addEventListener('message', ({ data }) => heard(data));
    made.postMessage({ engine: import.meta.resolve('playground/engine.js'), bytes });
    return made;
}

const say = (text) => { find('said').textContent = text; };

const clock = { running: state.page.run > 0, due: 0, last: 0, quality: 1, spent: 10, calm: 0, dirty: true, picture: 0 };
const changed = () => { clock.dirty = true; };

const plots = { strain: new Strip(find('strain')), energy: new Strip(find('energy')), error: new Strip(find('error'), { log: [-12, 1] }) };

const cards = [0, 1].map((sheet) => {
    const card = find('sheet').content.cloneNode(true).firstElementChild;
    find('stage').append(card);
    const part = (selector) => card.querySelector(selector);
    const side = sheet ? 'Right' : 'Left';
    return {
        card, canvas: part('canvas'), explosion: part('.explosion'),
        values: Object.fromEntries([...card.querySelectorAll('dd')].map((element) => [element.dataset.value, element])),
        own: controls(part('.own'), OWN, (key, value) => choose(sheet, { [key]: value }), (name) => `${side} sheet: ${name}`),
        side,
    };
});
const both = controls(find('both'), BOTH, (key, value) => share({ [key]: value, ...(key === 'start' ? ALONG[value] : {}) }));
const live = controls(find('live'), LIVE, (key, value) => { state.shared[key] = value; stage.change(); settled(); });

const views = cards.map(({ canvas }, sheet) => new View(canvas, engine, sheet, {
    act: (event) => stage.act(event),
    changed,
    tool: () => document.querySelector('input[name=tool]:checked').value,
    say,
}));

// Shows a message of the stage.
function told(news) {
    if (news.note !== undefined) find('reference-note').textContent = news.note;
    if (news.exploded !== undefined) {
        const { explosion, exploded } = news;
        const { explosion: box, side } = cards[exploded];
        box.hidden = false;
        [box.querySelector('strong').textContent, box.querySelector('p').textContent] = explosion;
        views[exploded].explosion = explosion;
        if (!news.refused) cards[exploded].values.strain.textContent = `${short(100 * engine.strain(exploded))} %`;
        box.setAttribute('aria-label', `${side} sheet: ${explosion[0]}`);
    }
    if (news.strain !== undefined) {
        plots.strain.add(news.sheet, news.frame, 100 * news.strain);
        plots.energy.add(news.sheet, news.frame, 1e3 * news.energy);
        cards[news.sheet].values.strain.textContent = `${short(100 * news.strain)} %`;
    }
    if (news.error !== undefined) {
        plots.error.add(news.sheet, news.frame, news.error);
        cards[news.sheet].values.error.textContent = short(news.error);
        changed();
    }
    changed();
}

function clear() {
    Object.values(plots).forEach((plot) => plot.clear());
    cards.forEach(({ explosion, values }) => {
        explosion.hidden = true;
        Object.values(values).forEach((value) => { value.textContent = '–'; });
    });
    views.forEach((view) => view.restart());
    clock.due = 0;
    changed();
}

clear();
const stage = new Stage(engine, state, worker, told);

function restart() {
    clear();
    stage.restart();
    settled();
}

// Shows all settings.
function settled() {
    cards.forEach(({ own }, sheet) => {
        Object.entries(own).forEach(([key, control]) => control.show(state.sheets[sheet][key]));
        own.sweeps.input.disabled = !SWEEPING.has(state.sheets[sheet].solver);
    });
    Object.entries({ ...both, ...live }).forEach(([key, control]) => control.show(state.shared[key]));
    find('reference').checked = Boolean(state.page.reference);
    find('slow').setAttribute('aria-pressed', Boolean(state.page.slow));
    find('lesson').hidden = !state.page.lesson;
    find('lesson').textContent = `Lesson ${state.page.lesson}`;
    study.settled();
    changed();
}

// Writes all settings into the address, after a control has changed: browsers refuse an update for every step of a slider.
function address() { history.replaceState(null, '', location.pathname + format(state)); }
document.addEventListener('change', address);

// Changes settings of one sheet and restarts both. A new solver gets its usual number of sweeps.
function choose(sheet, settings) {
    const usual = { lines: 2, verlet: 15, 'backward-euler': 1 };
    if (settings.solver && settings.sweeps === undefined) settings.sweeps = usual[settings.solver] ?? state.sheets[sheet].sweeps;
    Object.assign(state.sheets[sheet], settings);
    restart();
}

// Changes settings of both sheets and restarts them.
function share(settings) {
    Object.assign(state.shared, settings);
    restart();
}

// Loads a case of a study and runs it.
function load(sheet, own, shared) {
    Object.assign(state.shared, shared);
    choose(sheet, own);
    address();
    run(true);
}

const study = studies({ worker, stage: () => stage, load, find });

function run(running) {
    clock.running = running;
    clock.due = 0;
    find('run').textContent = running ? 'Pause' : 'Play';
}

function step() {
    run(false);
    stage.step();
    changed();
}

function slow() {
    state.page.slow = state.page.slow ? 0 : 1;
    settled();
    address();
}

find('run').addEventListener('click', () => run(!clock.running));
find('step').addEventListener('click', step);
find('slow').addEventListener('click', slow);
find('reset').addEventListener('click', restart);
find('reference').addEventListener('change', (event) => { state.page.reference = event.target.checked ? 1 : 0; restart(); });

const KEYS = { ' ': () => run(!clock.running), f: step, m: slow, r: restart };
document.addEventListener('keydown', (event) => {
    const { key, target } = event;
    // In a select, letters choose an option. Space presses the control that has the focus.
    const own = target.closest(key === ' ' ? 'button, select, input, summary, [role=button]' : 'select');
    if (!(key in KEYS) || own || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    KEYS[key]();
});

// Computes the frames that are due before the next picture. If they take longer than BUDGET, simulated time runs slower.
function frames(now) {
    const passed = Math.min((now - clock.last) / 1e3, LONGEST);
    clock.last = now;
    if (!clock.running) return;
    clock.due += passed * 60 * (state.page.slow ? 0.25 : 1);
    const begun = performance.now();
    while (clock.due >= 1) {
        clock.due -= 1;
        stage.step();
        if (performance.now() - begun > BUDGET) { clock.due = Math.min(clock.due, 1); break; }
    }
}

// Fewer pixels if pictures are late, more if there is time to spare.
function adapt(spent) {
    clock.spent = 0.9 * clock.spent + 0.1 * spent;
    clock.calm += 1;
    if (clock.spent > LATE && clock.calm > 30 && clock.quality < QUALITIES.length - 1) [clock.quality, clock.calm] = [clock.quality + 1, 0];
    if (clock.spent < EARLY && clock.calm > 240 && clock.quality > 0) [clock.quality, clock.calm] = [clock.quality - 1, 0];
}

function draw() {
    views.forEach((view, sheet) => {
        const { canvas, values, side } = cards[sheet];
        view.draw(QUALITIES[clock.quality], stage.refused[sheet] ? null : stage.held);
        values.digest.textContent = stage.refused[sheet] ? '–' : engine.digest(sheet);
        values.time.textContent = short(stage.times[sheet]);
        if (clock.picture % 30 !== 0 && clock.running) return;
        const { solver, number } = state.sheets[sheet];
        canvas.setAttribute('aria-label', `${side} sheet: ${label('solver', solver)}, ${label('number', number)}, strain ${values.strain.textContent}`);
    });
    // Every fourth picture is enough: plots change slowly.
    if (clock.picture % 4 === 0 || !clock.running) Object.values(plots).forEach((plot) => plot.draw());
    clock.picture += 1;
}

function tick(now) {
    // The next tick is requested only after this one has succeeded: a module that has failed would fail again.
    const begun = performance.now();
    frames(now);
    if (clock.dirty) {
        clock.dirty = false;
        draw();
        adapt(performance.now() - begun);
    }
    requestAnimationFrame(tick);
    if (clock.picture % 30 === 0) {
        find('speed').textContent = `A picture takes ${short(clock.spent)} ms; its longer side has ${Math.max(...views[0].size)} pixels.`;
    }
}

addEventListener('resize', changed);
run(clock.running);
settled();
address();
for (let frame = 0; frame < state.page.frames; frame += 1) stage.step();
if (state.page.frames) run(false);
if (state.page.map) find('map-run').click();
else if (state.page.cost) find('cost-run').click();
draw();
document.body.dataset.ready = String(Math.round(performance.now()));
requestAnimationFrame((now) => { clock.last = now; requestAnimationFrame(tick); });

// For the console and for tests.
globalThis.playground = { engine, stage, state, clock };
