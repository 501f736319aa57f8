// Runs a program on an emulated RP2040 with an LCD of 240 × 240 pixels, from one picture to the next.
//
// `node SCRIPT PACKAGE FLASH ORDERS`: a script that calls `play`, the folder of rp2040js, the flash's contents, and a JSON file
// { stop, failed, log, stack: [end, start], until, shots: [picture, …], cached, … }: addresses in the program, the last step (null: until a second passes without a
// picture), numbers of pictures to record (null: all), whether the flash's cache is modelled, and the script's own orders.
// Writes "step n" to the standard error output after every picture, and prints JSON at the end:
// { steps, shots: [[pixel, …], …], log: [byte, …], stack: [byte, …], on, idle, errors, frequency, … }. For that second without a picture, idle has the number of bytes sent to the
// display and the number of cycles in which the processor was awake.
import { readFile } from 'node:fs/promises';
import { argv, stderr, stdout } from 'node:process';
import { load } from './rp2040.mjs';

const SIDE = 240;
const PATIENCE = 1e9;
// A program without a last step must be at rest by then, ns.
const LIMIT = 30e9;

// An LCD of the ST7789's family: its commands, its window and its memory. `more` has additional commands of one controller, each with its number of parameters.
class Lcd {
    constructor(wrong, more) {
        this.wrong = wrong;
        this.lengths = { ...Lcd.LENGTHS, ...more };
    }

    memory = new Uint16Array(SIDE * SIDE);
    window = { left: 0, right: SIDE - 1, top: 0, bottom: SIDE - 1 };
    command = null;
    parameters = [];
    awake = false;
    on = false;
    format = null;
    access = 0;
    half = null;
    x = 0;
    y = 0;
    left = 0;

    byte(value, isData) {
        if (isData) this.data(value); else if (value !== 0) this.start(value);
    }

    // The largest number of parameters of each command.
    static LENGTHS = { 0x01: 0, 0x11: 0, 0x13: 0, 0x20: 0, 0x21: 0, 0x29: 0, 0x2a: 4, 0x2b: 4, 0x2c: Infinity, 0x33: 6, 0x36: 1, 0x3a: 1 };

    start(command) {
        this.finish();
        if (!(command in this.lengths)) this.wrong(`unknown command ${command.toString(16)}`);
        this.command = command;
        this.parameters = [];
        if (command === 0x11) this.awake = true;
        if (command === 0x29) this.on = true;
        if (command === 0x2c) {
            if (!this.awake || this.format !== 0x55) this.wrong('pixels for a display that sleeps or has another format');
            const { left, right, top, bottom } = this.window;
            [this.x, this.y, this.left] = [left, top, (right - left + 1) * (bottom - top + 1)];
        }
    }

    // A command ends where the next one begins.
    finish() {
        if (this.command === 0x2c && (this.left !== 0 || this.half !== null)) this.wrong(`${this.left} pixels of a window are missing`);
        if ((this.command === 0x2a || this.command === 0x2b) && this.parameters.length !== 4) this.wrong('a window of less than four bytes');
        this.half = null;
    }

    data(value) {
        if (this.command === null) return this.wrong('data before a command');
        if (this.command === 0x2c) return this.pixel(value);
        this.parameters.push(value);
        const { length } = this.parameters;
        if (length > this.lengths[this.command]) this.wrong(`too much for command ${this.command.toString(16)}`);
        if (this.command === 0x36) this.access = value;
        if (this.command === 0x3a) this.format = value;
        if (length === 4 && (this.command === 0x2a || this.command === 0x2b)) {
            const [a, b, c, d] = this.parameters;
            const [from, to] = [a << 8 | b, c << 8 | d];
            if (from > to || to >= SIDE) this.wrong(`a window from ${from} to ${to}`);
            if (this.command === 0x2a) [this.window.left, this.window.right] = [from, to];
            else [this.window.top, this.window.bottom] = [from, to];
        }
    }

    pixel(value) {
        if (this.half === null) { this.half = value; return; }
        if (this.left === 0) this.wrong('more pixels than the window has');
        else {
            this.memory[this.y * SIDE + this.x] = this.half << 8 | value;
            this.left -= 1;
            this.x += 1;
            if (this.x > this.window.right) [this.x, this.y] = [this.window.left, this.y + 1];
        }
        this.half = null;
    }
}

// Runs a program. The first argument is the wiring of the display. `attach(chip, orders, wrong)` connects other devices and returns { shown(picture), isBusy(), seen() }:
// a callback after each picture, whether the run must go on even after a second without a picture, and additional output.
export async function play({ spi: bus, data, select, reset, commands = {}, access = 0 }, attach) {
    const [, , emulator, flashFile, ordersFile] = argv;
    const orders = JSON.parse(await readFile(ordersFile, 'utf8'));
    const errors = [];
    const wrong = (what) => { if (errors.length < 20) errors.push(what); };
    const { chip, advance, RAM, GPIOPinState } = await load(emulator, flashFile, wrong, orders.cached);
    const { core, clock } = chip;
    const beside = attach(chip, orders, wrong);

    const lcd = new Lcd(wrong, commands);
    const spi = chip.spi[bus];
    // an SPI frame takes its time on the wires
    const arrived = clock.createAlarm(() => spi.completeTransmit(0));
    let bytes = 0;
    spi.onTransmit = (value) => {
        bytes += spi.dataBits / 8;
        if (chip.gpio[select].value === GPIOPinState.Low && chip.gpio[reset].value === GPIOPinState.High) {
            const isData = chip.gpio[data].value === GPIOPinState.High;
            if (spi.dataBits === 16) lcd.byte(value >> 8, isData);
            lcd.byte(value & 0xff, isData);
        } else wrong('a byte for a display that does not listen');
        arrived.schedule(spi.dataBits * 1e9 / spi.clockFrequency);
    };

    // Empties the log's buffer, as a debug probe does.
    const log = [];
    const drain = () => {
        const channel = orders.log - RAM + 24;
        const word = (at) => chip.sramView.getUint32(at, true);
        const [buffer, size, written] = [4, 8, 12].map((offset) => word(channel + offset));
        for (let read = word(channel + 16); size !== 0 && read !== written; read = (read + 1) % size) log.push(chip.sram[buffer - RAM + read]);
        chip.sramView.setUint32(channel + 16, written, true);
    };

    let [shown, awake, idle] = [0, 0, null];
    const steps = [];
    const shots = [];
    while (errors.length < 20) {
        const at = core.PC;
        if (at === orders.stop) {
            // after an interrupt the processor returns to the same address
            if (steps.at(-1) === core.registers[0]) { advance(); continue; }
            steps.push(core.registers[0]);
            stderr.write(`step ${steps.at(-1)}\n`);
            [shown, awake, bytes] = [clock.nanos, core.cycles, 0];
            if (lcd.access !== access) wrong(`the display's memory is read in the order ${lcd.access}`);
            drain();
            const last = orders.until !== null && steps.at(-1) >= orders.until;
            if (last || orders.shots === null || orders.shots.includes(steps.length)) shots.push(Array.from(lcd.memory));
            if (last) break;
            beside.shown(steps.length);
        } else if (steps.length > 0 && clock.nanos - shown > PATIENCE && !beside.isBusy()) {
            if (orders.until !== null) wrong('no picture for a second');
            drain();
            idle = [bytes, core.cycles - awake];
            shots.push(Array.from(lcd.memory));
            break;
        } else if (orders.until === null && clock.nanos > LIMIT) {
            drain();
            wrong('no rest');
            break;
        } else if (at === orders.failed) {
            drain();
            wrong('the program failed');
            break;
        }
        advance();
    }
    const [end, start] = orders.stack.map((address) => address - RAM);
    const stack = Array.from(chip.sram.subarray(end, start));
    stdout.write(JSON.stringify({ steps, shots, log, stack, on: lcd.on, idle, errors, frequency: chip.clkSys, ...beside.seen() }));
}
