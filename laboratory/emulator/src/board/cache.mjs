// The cache between the RP2040's processor and its flash, which rp2040js does without: 16 KB in two ways of lines of 8 bytes (RP2040 datasheet, 2.6.3.1). The least recently used line makes
// room. What a miss costs is an estimate: at 200 MHz the flash is read at 100, in four bits at a time, by some 30 cycles of its own.
const CYCLES_OF_A_MISS = 60;
const LINE_BITS = 3;
const SETS = 1024;

// Counts what misses of a chip have cost since the last question.
export function model(chip, start, end) {
    // the line in each way of each set, the one used last first
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
            // a read of one size is made of those of another
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
