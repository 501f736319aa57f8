// The map of stability and the plot of errors against cost: each computed by a worker, case by case.
import { CostPlot, SOLVER_COLOURS, cases } from 'playground/cost.js';
import { STEPS, STIFFNESS, StabilityMap } from 'playground/map.js';
import { label } from 'playground/settings.js';

export function studies({ state, worker, stage, choose, share, run, find }) {
    let studying = null;
    let heard = () => {};
    const target = (name) => Number(document.querySelector(`input[name=${name}]:checked`).value);

    const map = new StabilityMap(find('map'), ({ substeps, stiffness }) => {
        Object.assign(state.sheets[target('map-sheet')], { substeps });
        share({ stiffness });
        run();
    });
    const plot = new CostPlot(find('cost'), ({ solver, number, substeps, sweeps }) => {
        choose(target('cost-sheet'), { solver, number, substeps, sweeps });
        run();
    });
    find('cost-key').replaceChildren(...Object.entries(SOLVER_COLOURS).map(([solver, colour]) => {
        const entry = document.createElement('span');
        const dot = document.createElement('i');
        dot.style.background = colour;
        entry.append(dot, label('solver', solver));
        return entry;
    }), 'squares: fixed point; dotted: what is sure of the reference');

    const buttons = { map: [find('map-run'), find('map-note'), 'Draw the map'], cost: [find('cost-run'), find('cost-note'), 'Draw the plot'] };
    let current = null;

    function end(note) {
        if (!current) return;
        const [button, shown, text] = buttons[current];
        button.textContent = text;
        shown.textContent = note;
        current = null;
    }

    // Starts a study, or stops the one that runs.
    function start(kind, message, total, show) {
        const again = current === kind;
        if (current) {
            studying.postMessage({ stop: true });
            end('stopped');
        }
        if (again) return;
        studying ??= worker((data) => heard(data));
        current = kind;
        const [button, shown] = buttons[kind];
        button.textContent = 'Stop';
        let count = 0;
        shown.textContent = `0 of ${total}`;
        heard = (data) => {
            if (data.done) {
                if (data.done === kind) end(data.failed ? 'the reference has exploded' : '');
                return;
            }
            if (current !== kind) return;
            if (data.floor === undefined) count += 1;
            shown.textContent = `${count} of ${total}`;
            show(data);
        };
        studying.postMessage(message);
    }

    find('map-run').addEventListener('click', () => {
        const settings = stage().settings(target('map-sheet'));
        const frequency = stage().frequency / Math.sqrt(state.shared.stiffness);
        if (current !== 'map') map.clear();
        start('map', { map: { settings, steps: STEPS, stiffness: STIFFNESS } }, STEPS.length * STIFFNESS.length, (data) => map.show(data, frequency));
    });

    find('cost-run').addEventListener('click', () => {
        const list = cases([...new Set(state.sheets.map(({ number }) => number))]);
        if (current !== 'cost') plot.clear(list);
        start('cost', { cost: { settings: stage().settings(0), cases: list } }, list.length, (data) => plot.add(data));
    });

    for (const radio of document.querySelectorAll('input[name=map-sheet]')) radio.addEventListener('change', () => settled());

    function settled() {
        const { substeps } = state.sheets[target('map-sheet')];
        map.mark({ substeps, stiffness: state.shared.stiffness });
    }

    return { settled };
}
