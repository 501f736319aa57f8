// An emulated RP2040 with a program in its flash.
import { readFile } from 'node:fs/promises';
import { pathToFileURL } from 'node:url';

const RAM = 0x20000000;
const NANOSECONDS_OF_A_CYCLE = 1e9 / 125e6;

// Starts the program of a file as the boot ROM does. `emulator` is the folder of rp2040js, `wrong` is told what the chip complains of.
export async function load(emulator, flashFile, wrong) {
    const { RP2040, GPIOPinState } = await import(pathToFileURL(`${emulator}/dist/esm/index.js`).href);
    const chip = new RP2040();
    const complain = (name, text) => wrong(`${name}: ${text}`);
    chip.logger = { debug() {}, info() {}, warn: complain, error: complain };
    const { core, clock } = chip;
    chip.flash.set(await readFile(flashFile));
    // the boot ROM copies the second stage to the end of the RAM and calls it with a stack below
    chip.sram.set(chip.flash.subarray(0, 256), 0x41f00);
    core.reset();
    core.SP = RAM + 0x41f00;
    core.LR = 0;
    core.PC = RAM + 0x41f00;
    const advance = () => {
        if (core.waiting) clock.tick(clock.nanosToNextAlarm);
        // an interrupt is taken where the next instruction would be
        if (!core.waiting || core.interruptsUpdated) clock.tick(core.executeInstruction() * NANOSECONDS_OF_A_CYCLE);
    };
    return { chip, advance, RAM, GPIOPinState };
}
