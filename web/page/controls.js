// Controls made from settings: a select, a slider or a checkbox, each with its label.
import { text } from 'playground/settings.js';

let count = 0;

function make(tag, attributes = {}, ...children) {
    const element = document.createElement(tag);
    Object.entries(attributes).forEach(([name, value]) => element.setAttribute(name, value));
    element.append(...children);
    return element;
}

const MAKE = {
    choice(setting, id) {
        const options = setting.options.map(([value, name]) => make('option', { value }, name));
        const input = make('select', { id }, ...options);
        const number = typeof setting.options[0][0] === 'number';
        return {
            input, event: 'change', parts: [input],
            read: () => (number ? Number(input.value) : input.value),
            show: (value) => { input.value = value; },
        };
    },
    range(setting, id) {
        const { least: min, most: max, step, log } = setting;
        const input = make('input', { id, type: 'range', min, max, step });
        const shown = make('output', { for: id });
        return {
            input, event: 'input', parts: [input], shown,
            // Two digits, so that the address holds the whole value.
            read: () => (log ? Number((10 ** Number(input.value)).toPrecision(2)) : Number(input.value)),
            show(value) {
                input.value = log ? Math.log10(value) : value;
                shown.textContent = text(setting, value);
                input.setAttribute('aria-valuetext', shown.textContent);
            },
        };
    },
    toggle(setting, id) {
        const input = make('input', { id, type: 'checkbox' });
        return {
            input, event: 'change', parts: [input],
            read: () => (input.checked ? 1 : 0),
            show: (value) => { input.checked = Boolean(value); },
        };
    },
};

// Adds a control for each setting to `parent`, and returns the controls by key. A change calls `changed(key, value)`.
export function controls(parent, settings, changed, name = (label) => label) {
    return Object.fromEntries(settings.map((setting) => {
        count += 1;
        const control = MAKE[setting.kind](setting, `control-${count}`);
        const label = make('label', { for: control.input.id }, setting.label);
        const head = control.shown ? [make('span', { class: 'head' }, label, control.shown)] : [label];
        const parts = setting.kind === 'toggle' ? [...control.parts, ...head] : [...head, ...control.parts];
        control.input.setAttribute('aria-label', name(setting.label));
        control.input.dataset.key = setting.key;
        control.input.addEventListener(control.event, () => {
            const value = control.read();
            control.show(value);
            changed(setting.key, value);
        });
        control.field = make('div', { class: `field ${setting.kind}` }, ...parts);
        parent.append(control.field);
        return [setting.key, control];
    }));
}
