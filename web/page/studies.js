// The map of stability and the plot of errors against cost. A worker computes both, case by case.
import { CostPlot, SOLVER_COLOURS, cases } from 'playground/cost.js';
import { STEPS, STIFFNESS, StabilityMap } from 'playground/map.js';
import { label } from 'playground/settings.js';

export function studies({ worker, stage, load, find }) {
    let studying = null;
    let heard = () => {};
    const target = (name) => Number(document.querySelector(`input[name=${name}]:checked`).value);

    const map = new StabilityMap(find('map'), ({ substeps, stiffness }) => {
        load(target('map-sheet'), { substeps }, { stiffness });
    });
    const plot = new CostPlot(find('cost'), ({ solver, number, substeps, sweeps }) => {
        load(target('cost-sheet'), { solver, number, substeps, sweeps }, {});
    });
    find('cost-key').replaceChildren(...Object.entries(SOLVER_COLOURS).map(([solver, colour]) => {
        const entry = document.createElement('span');
        const dot = document.createElement('i');
        dot.style.background = colour;
        entry.append(dot, label('solver', solver));
        return entry;
    }), 'squares: fixed point; dotted: estimated error of the reference');

    const buttons = { map: [find('map-run'), find('map-note'), 'Draw the map'], cost: [find('cost-run'), find('cost-note'), 'Draw the plot'] };
    let current = null;
    // The number of the last study.
    let asked = 0;
    // The settings of the drawn map.
    let drawn = null;

    // The settings on which the map depends: all but substeps and stiffness, which are its axes.
    const mapped = () => ({ ...stage().settings(target('map-sheet')), substeps: 0, stiffness: 0 });

    function end(note) {
        if (!current) return;
        const [button, shown, text] = buttons[current];
        button.textContent = text;
        shown.textContent = note;
        current = null;
    }

    // Stops the running study. Starts this one, unless it was the running one.
    function start(kind, message, total, show) {
        const again = current === kind;
        if (current) {
            asked += 1;
            studying.postMessage({ study: asked });
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
            // A result of a stopped study.
            if (data.study !== asked) return;
            if (data.done) {
                end(data.failed ? 'the reference has exploded' : '');
                return;
            }
            if (data.floor === undefined) count += 1;
            shown.textContent = `${count} of ${total}`;
            show(data);
        };
        asked += 1;
        studying.postMessage({ ...message, study: asked });
    }

    find('map-run').addEventListener('click', () => {
        const settings = stage().settings(target('map-sheet'));
        const frequency = stage().frequency / Math.sqrt(settings.stiffness);
        if (current !== 'map') {
            map.clear();
            drawn = JSON.stringify(mapped());
        }
        start('map', { map: { settings, steps: STEPS, stiffness: STIFFNESS } }, STEPS.length * STIFFNESS.length, (data) => map.show(data, frequency));
    });

    find('cost-run').addEventListener('click', () => {
        const list = cases([...new Set([0, 1].map((sheet) => stage().settings(sheet).number))]);
        if (current !== 'cost') plot.clear(list);
        start('cost', { cost: { settings: stage().settings(0), cases: list } }, list.length, (data) => plot.add(data));
    });

    for (const radio of document.querySelectorAll('input[name=map-sheet]')) radio.addEventListener('change', () => settled());

    function settled() {
        map.mark(stage().settings(target('map-sheet')));
        if (drawn && current !== 'map') buttons.map[1].textContent = drawn === JSON.stringify(mapped()) ? '' : 'drawn with other settings';
    }

    return { settled };
}
