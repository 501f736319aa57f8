//! A curtain on the OLED of the LM3S6965 evaluation board. The joystick tilts gravity.
//!
//! | OLED (SSD0323, 128 × 64) | LM3S6965 |
//! |---|---|
//! | CLK | PA2 (`SSI0Clk`) |
//! | CS | PA3 |
//! | DIN | PA5 (`SSI0Tx`) |
//! | D/C | PC7 |
//!
//! | joystick, low while pressed | LM3S6965 |
//! |---|---|
//! | up, down, left, right | PE0, PE1, PE2, PE3 |
//!
//! ![the OLED in the emulator](../../../docs/oled.png)
//!
//! ```sh
//! cargo emulate oled --png oled.png                  # in QEMU: the picture after 120 steps, and the log
//! cd boards/oled && cargo run --release              # in QEMU with a window
//! ```
//!
//! A step is a 30th of a second. Where pictures take longer, up to two steps are made between them and the rest is dropped. At rest no step is computed and no
//! byte is sent to the display: the processor sleeps. The log is sent through RTT.
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in boards/oled, whose .cargo/config.toml names the target");

mod board;
mod clock;
mod meter;
mod pace;
mod ssd0323;

use board::{Board, FREQUENCY};
use clock::Clock;
use defmt_rtt as _;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_hal_bus::spi::ExclusiveDevice;
use kerchief::measure;
use kerchief::render::Canvas;
use meter::{Lap, Meter, shown};
use oled::picture::Picture;
use oled::show::{RATE, Room, Show};
use pace::Pace;
use panic_probe as _;
use ssd0323::Ssd0323;
use static_cell::{ConstStaticCell, StaticCell};

/// Steps between two lines of the log.
const LOGGED: u32 = 60;

static ROOM: ConstStaticCell<Room> = ConstStaticCell::new(Room::BLANK);
static CANVAS: StaticCell<Canvas<Picture>> = StaticCell::new();

#[cortex_m_rt::entry]
fn main() -> ! {
    let Some(peripherals) = cortex_m::Peripherals::take() else { defmt::unreachable!() };
    let board = Board::start();
    let mut joystick = board.joystick;
    let Ok(spi) = ExclusiveDevice::new_no_delay(board.spi, board.select);
    let Ok(mut display) = Ssd0323::new(spi, board.data);
    let mut show = Show::new(ROOM.take());
    let canvas = CANVAS.init_with(|| Canvas::new(Picture::new()));
    // at first a display shows random pixels
    let Ok(()) = canvas.clear(Gray4::BLACK);
    let clock = Clock::start(peripherals.SYST, FREQUENCY / RATE);
    let mut pace = Pace::new(2);
    let mut meter = Meter::default();
    let (mut now, mut step, mut first) = (0, 0, true);
    let mut logged = clock.cycles();
    loop {
        now = clock.wait(now);
        let start = clock.cycles();
        let mut changed = core::mem::take(&mut first);
        let due = pace.due(now);
        for _ in 0..due {
            changed |= show.step(joystick.read());
        }
        step += due;
        if !changed {
            continue;
        }
        let simulated = clock.cycles();
        let Ok(()) = canvas.erase(Gray4::BLACK);
        let Ok(()) = show.draw_rod(canvas);
        let sort = Lap::time(canvas, &clock, |lap| show.draw(lap));
        let drawn = clock.cycles();
        let Ok(()) = canvas.send(|picture, area| display.send(picture.bytes(), area));
        let sent = clock.cycles();
        meter.add([start, simulated, drawn, sent], sort);
        if step % LOGGED < due {
            let gone = clock.cycles().wrapping_sub(logged);
            logged = logged.wrapping_add(gone);
            meter.log(step, meter.rate(FREQUENCY, gone), pace.dropped, measure::digest(show.cloth));
        }
        shown(step);
    }
}
