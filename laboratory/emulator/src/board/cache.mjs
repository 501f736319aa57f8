// The cache between the RP2040's processor and its flash, which rp2040js lacks: 16 KB, two-way set-associative, lines of 8 bytes (RP2040 datasheet, 2.6.3.1). A miss replaces the
// least recently used line. The cost of a miss is an estimate: at 200 MHz the flash is read at 100 MHz, four bits at a time, in about 30 cycles of the flash's clock.
const CYCLES_OF_A_MISS = 60;
const LINE_BITS = 3;
const SETS = 1024;

// Attaches the model to a chip. Returns a function that returns the cycles spent on misses since its last call.
export function model(chip, start, end) {
    // the lines of each set, most recently used first
    const ways = new Int32Array(2 * SETS).fill(-1);
    let cycles = 0;
    const look = (address) => {
        if (address < start || address >= end) return;
        const line = address >>> LINE_BITS;
        const first = 2 * (line % SETS);
        if (ways[first] === line) return;
        if (ways[first + 1] !== line) cycles += CYCLES_OF_A_MISS;
        [ways[first], ways[first + 1]] = [line, ways[first]];
    };
    for (const read of ['readUint32', 'readUint16', 'readUint8']) {
        const direct = chip[read].bind(chip);
        let deep = false;
        chip[read] = (address) => {
            // the emulator implements a read of one size by reads of another: only the outermost counts
            if (deep) return direct(address);
            deep = true;
            look(address >>> 0);
            const value = direct(address);
            deep = false;
            return value;
        };
    }
    return () => { const cost = cycles; cycles = 0; return cost; };
}
