// The map of stability: substeps against stiffness, with a button for each case.
import { FRAME } from 'playground/engine.js';
import { short } from 'playground/explain.js';

export const STEPS = [1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64];
export const STIFFNESS = [0.01, 0.03, 0.1, 0.3, 1, 3, 10];

// [largest strain, colour], from pale to strong.
const SHADES = [[0.01, '#dfeadf'], [0.02, '#cbdfcb'], [0.05, '#b3d0b5'], [0.1, '#e9ddb0'], [0.25, '#e3c27e'], [0.5, '#d99a5b'], [Infinity, '#c9754a']];

export class StabilityMap {
    // A press on a case calls `chosen` with { substeps, stiffness }.
    constructor(grid, chosen) {
        this.grid = grid;
        this.cells = new Map();
        grid.style.setProperty('--columns', STIFFNESS.length);
        STEPS.forEach((substeps, row) => {
            const line = document.createElement('div');
            line.setAttribute('role', 'row');
            const head = document.createElement('span');
            head.setAttribute('role', 'rowheader');
            head.textContent = `${short((1e3 * FRAME) / substeps)} ms`;
            line.append(head);
            STIFFNESS.forEach((stiffness, column) => {
                const cell = document.createElement('button');
                cell.type = 'button';
                cell.setAttribute('role', 'gridcell');
                cell.tabIndex = row + column === 0 ? 0 : -1;
                cell.addEventListener('click', () => chosen({ substeps, stiffness }));
                cell.addEventListener('keydown', (event) => this.#go(event, row, column));
                line.append(cell);
                this.cells.set(`${row},${column}`, cell);
            });
            grid.append(line);
        });
        const foot = document.createElement('div');
        foot.setAttribute('role', 'row');
        foot.append(document.createElement('span'), ...STIFFNESS.map((stiffness) => {
            const head = document.createElement('span');
            head.setAttribute('role', 'columnheader');
            head.textContent = `×${stiffness}`;
            return head;
        }));
        grid.append(foot);
        this.clear();
    }

    clear() {
        this.cells.forEach((cell, key) => {
            const [row, column] = key.split(',').map(Number);
            cell.className = '';
            cell.style.background = '';
            cell.textContent = '';
            this.#name(cell, row, column, 'not computed');
        });
    }

    #name(cell, row, column, outcome) {
        const name = `${STEPS[row]} substeps of ${short((1e3 * FRAME) / STEPS[row])} ms, stiffness × ${STIFFNESS[column]}: ${outcome}`;
        cell.setAttribute('aria-label', name);
        cell.title = name;
    }

    // `frequency`: the sheet's highest angular frequency at the stiffness of the fabric, 1/s.
    show({ cell: [row, column], strain, fate, refused }, frequency) {
        const cell = this.cells.get(`${row},${column}`);
        const product = (frequency * Math.sqrt(STIFFNESS[column]) * FRAME) / STEPS[row];
        cell.classList.toggle('gone', Boolean(fate));
        cell.classList.toggle('refused', Boolean(refused));
        const gone = fate && 'explodes';
        const outcome = gone || (refused ? 'refused by the number type' : `strain ${short(100 * strain)} %`);
        cell.textContent = gone ? '✕' : '';
        if (!fate && !refused) cell.style.background = SHADES.find(([most]) => strain <= most)[1];
        this.#name(cell, row, column, `${outcome}, ω·h = ${short(product)}`);
    }

    // Marks the case with these settings.
    mark({ substeps, stiffness }) {
        this.cells.forEach((cell, key) => {
            const [row, column] = key.split(',').map(Number);
            const same = STEPS[row] === substeps && Math.abs(STIFFNESS[column] / stiffness - 1) < 0.01;
            cell.setAttribute('aria-selected', same);
        });
    }

    #go(event, row, column) {
        const by = { ArrowLeft: [0, -1], ArrowRight: [0, 1], ArrowUp: [-1, 0], ArrowDown: [1, 0] }[event.key];
        const next = by && this.cells.get(`${row + by[0]},${column + by[1]}`);
        if (!next) return;
        event.preventDefault();
        event.target.tabIndex = -1;
        next.tabIndex = 0;
        next.focus();
    }
}
