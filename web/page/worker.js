// The workers' script: the reference solution, the map of stability, errors against cost.
//
// The first message, { engine, bytes }, opens the module. The others are
//   { follow: settings }                     starts a reference; { frame, events, start } moves it and answers { frame, places, start }
//   { map: { settings, steps, stiffness } }  answers { cell: [row, column], strain, fate, refused } for each case
//   { cost: { settings, cases } }            answers { point, error, time } for each case, and { floor }, the estimated error of the reference
// Messages for a map or a cost plot have a number, { study }, and all answers repeat it. A study ends with { done }, or when a message has another number.

let Playground = null;
let engine = null;
let study = 0;
let started = Promise.resolve();
// Messages for frames of the reference that are not computed yet.
let queue = [];
let following = false;

const REFERENCE = 0;
const CASE = 1;
// The largest ω·h of references in the cost plot, and the frames of each case.
const FINE = 0.5;
const MAP_FRAMES = 45;
const COST_FRAMES = 30;

// Handles waiting messages before the next frames. A timer would wait for milliseconds.
const breath = new MessageChannel();
const breathing = [];
breath.port1.onmessage = () => breathing.shift()();
const breathe = () => new Promise((resolve) => { breathing.push(resolve); breath.port2.postMessage(null); });

async function map(own, { settings, steps, stiffness }) {
    for (let row = 0; row < steps.length; row += 1) {
        for (let column = 0; column < stiffness.length; column += 1) {
            const refused = engine.start(CASE, { ...settings, substeps: steps[row], stiffness: stiffness[column] });
            let [strain, fate] = [0, null];
            for (let frame = 0; frame < MAP_FRAMES && !refused && !fate; frame += 1) {
                fate = engine.frame(CASE);
                strain = Math.max(strain, engine.strain(CASE));
                if (frame % 8 === 0) await breathe();
                if (own !== study) return;
            }
            postMessage({ study: own, cell: [row, column], strain, fate, refused });
        }
    }
    postMessage({ study: own, done: true });
}

// Plays a case to its end. Returns the particles' coordinates and the milliseconds of a frame, or null if it is refused, explodes or is stopped.
async function play(own, settings) {
    if (engine.start(CASE, settings)) return null;
    let time = 0;
    for (let frame = 0; frame < COST_FRAMES; frame += 1) {
        const begun = performance.now();
        if (engine.frame(CASE)) return null;
        time += performance.now() - begun;
        if (frame % 8 === 0) await breathe();
        if (own !== study) return null;
    }
    return { places: engine.places(CASE), time: time / COST_FRAMES };
}

async function cost(own, { settings, cases }) {
    engine.start(CASE, { ...settings, solver: 'leapfrog', number: 'f64', substeps: 64, sweeps: 1 });
    const frequency = engine.frequency(CASE);
    const exact = await play(own, Playground.reference(settings, frequency, FINE));
    const coarser = await play(own, Playground.reference(settings, frequency, 2 * FINE));
    if (own !== study) return;
    if (!exact || !coarser) { postMessage({ study: own, done: true, failed: true }); return; }
    // Richardson: leapfrog has order 2, so the error of the finer solution is a third of the difference.
    postMessage({ study: own, floor: Playground.distance(exact.places, coarser.places) / 3 });
    for (const [point, one] of cases.entries()) {
        const whole = { ...settings, ...one };
        // The browser compiles code while the first frames run; these two are not measured.
        if (!engine.start(CASE, whole)) [0, 1].forEach(() => engine.frame(CASE));
        const played = await play(own, whole);
        if (own !== study) return;
        postMessage({ study: own, point, error: played && Playground.distance(played.places, exact.places), time: played?.time });
    }
    postMessage({ study: own, done: true });
}

function follow({ frame, events, start }) {
    for (const event of events) {
        if (event.change) engine.change(REFERENCE, { ...event.change, solver: 'leapfrog', number: 'f64' });
        else engine.act(REFERENCE, event);
    }
    const fate = engine.frame(REFERENCE);
    postMessage({ frame, start, places: fate ? null : engine.places(REFERENCE) });
}

async function drain() {
    if (following) return;
    following = true;
    while (queue.length) {
        follow(queue.shift());
        await breathe();
    }
    following = false;
}

addEventListener('message', ({ data }) => {
    if (data.engine) {
        started = (async () => {
            Playground = await import(data.engine);
            engine = await Playground.Engine.open(data.bytes);
        })();
        return;
    }
    study = data.study ?? study;
    const own = study;
    started.then(() => {
        if (data.follow) {
            // Messages for the previous start are obsolete.
            queue = [];
            engine.start(REFERENCE, data.follow);
        } else if (data.events) {
            queue.push(data);
            drain();
        }
        if (data.map) map(own, data.map);
        else if (data.cost) cost(own, data.cost);
    });
});
