// An emulated RP2040 with a program in its flash.
import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';
import { model } from './cache.mjs';

const RAM = 0x20000000;
const FLASH = [0x10000000, 0x11000000];
const REGULATOR = 0x40064;

// The core's voltage regulator, which rp2040js lacks: one register. `load` checks the voltage that the clock needs (RP2040 datasheet, 2.10; Pico SDK 2.1.1 for 200 MHz).
class Regulator {
    value = 0xb1;

    readUint32() { return this.value; }

    writeUint32Atomic(offset, value, kind) {
        const after = [value, this.value ^ value, this.value | value, this.value & ~value];
        if (offset === 0) this.value = after[kind] >>> 0;
    }

    // The field is 5 for 0.80 V; a step is 0.05 V.
    get volts() { return 0.8 + 0.05 * ((this.value >> 4 & 15) - 5); }
}

// Starts the program of a file as the boot ROM does. `emulator` is the folder of rp2040js; `wrong` receives the chip's complaints. With `cached`, reads of code and data from the
// flash go through a model of its cache. Without, they take no additional time.
export async function load(emulator, flashFile, wrong, cached = false) {
    const { RP2040, GPIOPinState } = await import(pathToFileURL(`${emulator}/dist/esm/index.js`).href);
    const chip = new RP2040();
    const complain = (name, text) => wrong(`${name}: ${text}`);
    chip.logger = { debug() {}, info() {}, warn: complain, error: complain };
    const regulator = new Regulator();
    chip.peripherals[REGULATOR] = regulator;
    const { core, clock } = chip;
    chip.flash.set(await readFile(flashFile));
    // the boot ROM copies the second stage to the end of the RAM and calls it with the stack below
    chip.sram.set(chip.flash.subarray(0, 256), 0x41f00);
    core.reset();
    core.SP = RAM + 0x41f00;
    core.LR = 0;
    core.PC = RAM + 0x41f00;
    const stalled = cached ? model(chip, ...FLASH) : () => 0;
    let frequency = 0;
    const advance = () => {
        if (core.waiting) clock.tick(clock.nanosToNextAlarm);
        // an interrupt is taken in place of the next instruction
        if (core.waiting && !core.interruptsUpdated) return;
        const cycles = core.executeInstruction();
        const stall = stalled();
        core.cycles += stall;
        clock.tick((cycles + stall) * 1e9 / chip.clkSys);
        if (chip.clkSys !== frequency) {
            frequency = chip.clkSys;
            if (frequency > 133e6 && (frequency > 200e6 || regulator.volts < 1.149)) wrong(`${frequency} Hz at ${regulator.volts} V`);
        }
    };
    return { chip, advance, RAM, GPIOPinState };
}
