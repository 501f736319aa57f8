//! The 25 LEDs of the micro:bit v1: three wires for rows, nine for columns. Nothing here depends on the chip: a number stands for the state of all
//! pins, and [`lit`] computes from it which LEDs shine.

/// LEDs a side.
pub const LEDS: usize = 5;
/// The highest brightness of a LED.
pub const BRIGHTEST: u32 = 4;

/// The pin of the first row; a row shines while its pin is high.
const ROW: u32 = 13;
/// The pin of the first column; a LED shines while its column's pin is low.
const COLUMN: u32 = 4;
/// The number of row wires.
pub const ROWS: u32 = 3;
const COLUMNS: u32 = 9;

/// Row and column of the wires of each LED, from the upper left (the schematic of the micro:bit v1.3B).
const WIRES: [[(u32, u32); LEDS]; LEDS] = [
    [(0, 0), (1, 3), (0, 1), (1, 4), (0, 2)],
    [(2, 3), (2, 4), (2, 5), (2, 6), (2, 7)],
    [(1, 1), (0, 8), (1, 2), (2, 8), (1, 0)],
    [(0, 7), (0, 6), (0, 5), (0, 4), (0, 3)],
    [(2, 2), (1, 6), (2, 0), (1, 5), (2, 1)],
];

/// A mask of all pins.
pub const PINS: u32 = ((1 << ROWS) - 1) << ROW | ((1 << COLUMNS) - 1) << COLUMN;

/// The state of the pins while one row of wires is on, in a pass that lights the LEDs brighter than `pass`.
pub fn pins(picture: &[[u32; LEDS]; LEDS], row: u32, pass: u32) -> u32 {
    let mut pins = 1 << (ROW + row) | ((1 << COLUMNS) - 1) << COLUMN;
    for (wires, level) in WIRES.iter().flatten().zip(picture.iter().flatten()) {
        if wires.0 == row && *level > pass {
            pins &= !(1 << (COLUMN + wires.1));
        }
    }
    pins
}

/// The LEDs that shine with this state of the pins: 1 for each, 0 for the others.
pub fn lit(pins: u32) -> [[u32; LEDS]; LEDS] {
    WIRES.map(|row| row.map(|(row, column)| (pins >> (ROW + row)) & !(pins >> (COLUMN + column)) & 1))
}
