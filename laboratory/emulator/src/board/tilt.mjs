// Runs a program on an emulated Waveshare RP2040-LCD-1.28: see lcd.mjs. Its orders also have gesture: [[seconds, x, y, z], …], the force on the accelerometer in g, and
// sensor: whether the board has one. Its output also has readings: [[seconds, x, y, z], …], all values measured by the sensor.
import { play } from './lcd.mjs';

// The sensor's address and registers: a QMI8658 (QST, QMI8658C datasheet). Full scales are 2, 4, 8 and 16 g; rates are 8000 Hz divided by powers of two.
const ADDRESS = 0x6b;
const IDENTITY = 0x05;
const [CTRL1, CTRL2, CTRL5, CTRL7, ACCELERATION] = [0x02, 0x03, 0x06, 0x08, 0x35];
// Amplitude of a reading's noise, g.
const NOISE = 0.002;

class Qmi8658 {
    // After power-on the upper byte comes first, and the address does not advance.
    registers = new Map([[0x00, IDENTITY], [CTRL1, 0x20], [CTRL2, 0], [CTRL5, 0], [CTRL7, 0]]);
    address = null;
    sample = [0, 0, 0];
    readings = [];
    seed = 1;

    constructor(gesture, wrong) {
        this.gesture = gesture;
        this.wrong = wrong;
    }

    // A transfer starts by writing a register's address.
    connect(isRead) { if (!isRead) this.address = null; }

    write(value) {
        if (this.address === null) { this.address = value; return; }
        if (![CTRL1, CTRL2, CTRL5, CTRL7].includes(this.address)) this.wrong(`the sensor's register ${this.address} is written`);
        this.registers.set(this.address, value);
        this.advance();
    }

    read(seconds) {
        const at = this.address - ACCELERATION;
        if (at < 0 || at > 5) {
            if (!this.registers.has(this.address)) this.wrong(`the sensor's register ${this.address} is read`);
            return this.registers.get(this.address) ?? 0;
        }
        if (at === 0) this.measure(seconds);
        const isUpper = (at % 2 === 1) !== Boolean(this.registers.get(CTRL1) & 0x20);
        const byte = this.sample[at >> 1] >> (isUpper ? 8 : 0) & 0xff;
        this.advance();
        return byte;
    }

    advance() { if (this.registers.get(CTRL1) & 0x40) this.address += 1; }

    // Takes a sample: the force at the sensor's last measuring time.
    measure(seconds) {
        if ((this.registers.get(CTRL7) & 3) !== 1) this.wrong('a reading of an accelerometer that is off, or has a gyroscope beside it');
        if ((this.registers.get(CTRL5) & 1) !== 1) this.wrong('a reading without the filter');
        const range = 2 << (this.registers.get(CTRL2) >> 4 & 7);
        const rate = 8000 / 2 ** (this.registers.get(CTRL2) & 15);
        const then = Math.floor(seconds * rate) / rate;
        const whole = (weights) => Math.max(-32768, Math.min(32767, Math.round(weights * 32768 / range)));
        this.sample = this.felt(then).map((weights) => whole(weights + this.noise()));
        this.readings.push([then, ...this.sample]);
    }

    felt(seconds) {
        const next = this.gesture.findIndex(([time]) => time > seconds);
        const [from, to] = [this.gesture.at(next === -1 ? -1 : Math.max(next - 1, 0)), this.gesture.at(next)];
        const part = to[0] === from[0] ? 0 : (seconds - from[0]) / (to[0] - from[0]);
        return [1, 2, 3].map((axis) => from[axis] + (to[axis] - from[axis]) * part);
    }

    noise() {
        this.seed = (Math.imul(this.seed, 1664525) + 1013904223) >>> 0;
        return NOISE * (this.seed / 2 ** 31 - 1);
    }
}

// Commands that only a GC9A01 has, with their numbers of parameters (GalaxyCore, GC9A01A datasheet; some are undocumented).
const COMMANDS = {
    0x62: 12, 0x63: 12, 0x64: 7, 0x66: 10, 0x67: 10, 0x70: 9, 0x74: 7, 0x84: 1, 0x85: 1, 0x86: 1, 0x87: 1, 0x88: 1, 0x89: 1, 0x8a: 1, 0x8b: 1, 0x8c: 1, 0x8d: 1, 0x8e: 1,
    0x8f: 1, 0x90: 4, 0x98: 2, 0xae: 1, 0xb6: 2, 0xbc: 1, 0xbd: 1, 0xbe: 1, 0xc3: 1, 0xc4: 1, 0xc9: 1, 0xcd: 1, 0xdf: 3, 0xe1: 2, 0xe8: 1, 0xeb: 1, 0xed: 2, 0xef: 0, 0xf0: 6,
    0xf1: 6, 0xf2: 6, 0xf3: 6, 0xfe: 0, 0xff: 3,
};

// The panel's rows run from the display's bottom to its top, and its colours are blue, green, red. The maker's own programs send this value.
const ACCESS = 0x88;

await play({ spi: 1, data: 8, select: 9, reset: 12, commands: COMMANDS, access: ACCESS }, (chip, { gesture, sensor }, wrong) => {
    const { clock } = chip;
    const qmi8658 = new Qmi8658(gesture, wrong);
    const bus = chip.i2c[1];
    // a byte takes nine bits on the wires; the emulator leaves out the cycles that a chip adds to both halves of the clock
    const bits = () => {
        const frequency = chip.clkSys / (bus.sclHighPeriod + bus.sclLowPeriod);
        if (frequency > 401e3) wrong(`a sensor for 400 kHz at ${frequency} Hz`);
        return 9e9 / frequency;
    };
    let answer = () => {};
    const done = clock.createAlarm(() => answer());
    const after = (what) => { answer = what; done.schedule(bits()); };
    bus.onConnect = (address, mode) => {
        const isThere = sensor && address === ADDRESS;
        if (isThere) qmi8658.connect(mode === 1);
        after(() => bus.completeConnect(isThere));
    };
    bus.onWriteByte = (value) => { qmi8658.write(value); after(() => bus.completeWrite(true)); };
    bus.onReadByte = () => { const value = qmi8658.read(clock.nanos / 1e9); after(() => bus.completeRead(value)); };
    return {
        shown() {},
        // until the gesture ends
        isBusy: () => sensor && clock.nanos / 1e9 < gesture.at(-1)[0],
        seen: () => ({ readings: qmi8658.readings }),
    };
});
