// Runs a program on an emulated Raspberry Pi Pico with an OLED on I2C, until it has sent a number of pictures.
//
// node ssd1306.mjs PACKAGE FLASH PICTURES: the folder of rp2040js, the flash's contents, and the number of pictures.
// Writes "step n" to the standard error output after every picture, and prints JSON at the end: { memory: [byte, …], on, milliseconds, errors }. A byte
// is eight pixels of a column, the uppermost in bit 0; a page of 128 bytes is eight rows.
import { argv, stderr, stdout } from 'node:process';
import { load } from './rp2040.mjs';

const [, , emulator, flashFile, pictures] = argv;
const ADDRESS = 0x3c;
const [COLUMNS, PAGES] = [128, 8];
// nanoseconds without a picture after which the run fails: a second
const PATIENCE = 1e9;

const errors = [];
// the emulator does not implement the hold time of data after the clock
const wrong = (what) => { if (errors.length < 20 && !what.includes('IC_SDA_HOLD')) errors.push(what); };

// An SSD1306: its commands, its window and its memory.
class Oled {
    memory = new Uint8Array(COLUMNS * PAGES);
    columns = [0, COLUMNS - 1];
    pages = [0, PAGES - 1];
    x = 0;
    y = 0;
    on = false;
    isHorizontal = false;
    // Whether a transfer consists of data or of commands: null until its first byte decides.
    isData = null;
    command = [];
    // Bytes that are still missing in the window.
    left = 0;
    pictures = 0;

    // The number of parameters of each command.
    static LENGTHS = {
        0x20: 1, 0x21: 2, 0x22: 2, 0x2e: 0, 0x40: 0, 0x81: 1, 0x8d: 1, 0xa1: 0, 0xa4: 0, 0xa6: 0, 0xa8: 1, 0xae: 0, 0xaf: 0, 0xc8: 0, 0xd3: 1, 0xd5: 1, 0xd9: 1,
        0xda: 1, 0xdb: 1,
    };

    byte(value) {
        if (this.isData === null) {
            if (value !== 0x00 && value !== 0x40) wrong(`a transfer that starts with ${value.toString(16)}`);
            this.isData = value === 0x40;
        } else if (this.isData) this.data(value);
        else this.order(value);
    }

    order(value) {
        this.command.push(value);
        const [name, first, second] = this.command;
        if (!(name in Oled.LENGTHS)) wrong(`unknown command ${name.toString(16)}`);
        else if (this.command.length <= Oled.LENGTHS[name]) return;
        this.command = [];
        if (name === 0xae || name === 0xaf) this.on = name === 0xaf;
        if (name === 0x20) this.isHorizontal = first === 0;
        if (name === 0x21) [this.columns, this.x] = [[first, second], first];
        if (name === 0x22) [this.pages, this.y] = [[first, second], first];
        if (name === 0x21 || name === 0x22) {
            const [width, height] = [this.columns, this.pages].map(([from, to]) => to - from + 1);
            if (width < 1 || height < 1 || this.columns[1] >= COLUMNS || this.pages[1] >= PAGES) wrong('a window beyond the display');
            if (this.left !== 0 && name === 0x21) wrong(`${this.left} bytes of a window are missing`);
            this.left = width * height;
        }
    }

    data(value) {
        if (!this.on || !this.isHorizontal) wrong('pixels for a display that is off or counts otherwise');
        if (this.left === 0) return wrong('more pixels than the window has');
        this.memory[this.y * COLUMNS + this.x] = value;
        this.x += 1;
        if (this.x > this.columns[1]) [this.x, this.y] = [this.columns[0], this.y + 1];
        this.left -= 1;
        if (this.left === 0) this.pictures += 1;
    }
}

const { chip, advance } = await load(emulator, flashFile, wrong);
const { clock } = chip;
const oled = new Oled();
const bus = chip.i2c[0];
bus.onConnect = (address) => {
    if (address !== ADDRESS) wrong(`a transfer to ${address.toString(16)}`);
    oled.isData = null;
    bus.completeConnect(address === ADDRESS);
};
// a byte takes nine bits at 400 kHz on the wires
const written = clock.createAlarm(() => bus.completeWrite(true));
bus.onWriteByte = (value) => {
    oled.byte(value);
    written.schedule(9 * 1e9 / 400e3);
};

let [shown, at] = [0, 0];
while (oled.pictures < Number(pictures) && errors.length === 0) {
    if (clock.nanos - at > PATIENCE) wrong('no picture for a second');
    advance();
    if (oled.pictures > shown) {
        [shown, at] = [oled.pictures, clock.nanos];
        stderr.write(`step ${shown}\n`);
    }
}
stdout.write(JSON.stringify({ memory: Array.from(oled.memory), on: oled.on, milliseconds: clock.nanos / 1e6, errors }));
