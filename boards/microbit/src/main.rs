//! A flag of 8 × 8 particles on the 25 LEDs of a BBC micro:bit v1, in 16 KB of RAM. Button A calms the wind, button B makes it stronger.
//!
//! No wiring is needed: rows of LEDs at P0.13 to P0.15, columns at P0.04 to P0.12, buttons at P0.17 (A) and P0.26 (B).
//!
//! ![the LEDs in the emulator](../../../docs/microbit.png)
//!
//! ```sh
//! cargo emulate microbit --png microbit.png          # in QEMU: the LEDs after 120 steps, and the log
//! cd boards/microbit && cargo run --release          # on a micro:bit, whose USB port is a probe
//! ```
//!
//! A step is a 60th of a second. It is computed; then its picture is shown for the rest of that time, in passes of 0.8 ms for each row of wires. The log is sent
//! through RTT.
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in boards/microbit, whose .cargo/config.toml names the target");

mod board;

use board::Board;
use defmt_rtt as _;
use kerchief::measure;
use microbit::leds::{BRIGHTEST, ROWS, pins};
use microbit::show::{RATE, Show};
use panic_probe as _;
use static_cell::StaticCell;

/// Steps between two lines of the log.
const LOGGED: u32 = 60;
/// The time for which a pass lights a row of wires, µs.
const SLOT: u32 = 800;

static SHOW: StaticCell<Show> = StaticCell::new();

#[cortex_m_rt::entry]
fn main() -> ! {
    let Some(board) = Board::start() else { defmt::unreachable!() };
    let show = SHOW.init_with(Show::new);
    let (mut step, mut held, mut late) = (0, [false; 2], 0);
    let mut next = board.micros();
    loop {
        next = next.wrapping_add(1_000_000 / RATE);
        let buttons = board.buttons();
        for (button, more) in [false, true].into_iter().enumerate() {
            if buttons[button] && !held[button] {
                show.press(more);
            }
        }
        held = buttons;
        show.step();
        step += 1;
        let picture = show.picture();
        for pass in 0..BRIGHTEST {
            for row in 0..ROWS {
                board.write(pins(&picture, row, pass));
                let start = board.micros();
                while board.micros().wrapping_sub(start) < SLOT {}
            }
        }
        board.write(0);
        // lost time is not made up for: the flag then moves more slowly
        if board.micros().wrapping_sub(next) < 1 << 31 {
            late += 1;
            next = board.micros();
        }
        while board.micros().wrapping_sub(next) >= 1 << 31 {}
        if step % LOGGED == 0 {
            defmt::info!("step {=u32}, digest {=u32:08x}, late {=u32}", step, measure::digest(&show.cloth), late);
        }
        shown(step);
    }
}

/// An emulator stops here to read the LEDs.
#[inline(never)]
extern "C" fn shown(step: u32) {
    core::hint::black_box(step);
}
