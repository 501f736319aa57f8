//! A kerchief between four pegs, on the Waveshare RP2040-LCD-1.28: gravity follows the hand. Tilt the board and the kerchief falls that way; shake it and it flies.
//!
//! Everything is on the board, and no wiring is needed: an RP2040 with 2 MB of flash, a round LCD of 240 × 240 pixels (GC9A01), an accelerometer and gyroscope (QMI8658), a charger
//! for a lithium cell, USB-C.
//!
//! | LCD (GC9A01) | RP2040 |
//! |---|---|
//! | DC | GP8 |
//! | CS | GP9 |
//! | CLK | GP10 (SPI1 SCK) |
//! | DIN | GP11 (SPI1 TX) |
//! | RST | GP12 |
//! | BL | GP25 |
//!
//! | sensor (QMI8658) | RP2040 |
//! |---|---|
//! | SDA | GP6 (I2C1 SDA) |
//! | SCL | GP7 (I2C1 SCL) |
//!
//! ![the LCD in the emulator](../../../docs/tilt.gif)
//!
//! ```sh
//! cargo emulate tilt --png tilt.png                  # in rp2040js: the picture after 120 steps, and the log
//! cd boards/tilt && cargo run --release              # on the board with a probe
//! ```
//!
//! `rp2040-hal` sets up the chip's clocks, DMA and I2C in a few lines. The drivers use it through `embedded-hal`: `mipidsi` starts the LCD, `qmi8658.rs` reads the sensor.
//!
//! The chip runs at 200 MHz, its bus to the display at 50. A step is a 60th of a second, and each has a picture. Before each step the sensor is read: gravity is opposite to
//! the force that it measures. While DMA sends a picture to the display, the next step is computed, by code that was copied to RAM (`fast.x`). At rest no step is computed and
//! no byte is sent to the display: the processor sleeps, and reads the sensor ten times a second. Without a sensor the log says so, and gravity points down the display. The
//! log is sent through RTT.
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in boards/tilt, whose .cargo/config.toml names the target");

mod chip;
mod clock;
mod divider;
mod fast;
mod lcd;
mod meter;
mod pace;
mod qmi8658;

use clock::Clock;
use defmt_rtt as _;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::RgbColor;
use embedded_hal::digital::OutputPin;
use embedded_hal::i2c::I2c;
use embedded_hal::spi::MODE_3;
use embedded_hal_bus::spi::ExclusiveDevice;
use kerchief::measure;
use kerchief::render::Canvas;
use lcd::Lcd;
use meter::{Lap, Meter, shown};
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::GC9A01;
use mipidsi::options::{ColorInversion, ColorOrder, Orientation};
use pace::Pace;
use panic_probe as _;
use qmi8658::Qmi8658;
use rp2040_hal::clocks::Clock as _;
use rp2040_hal::dma::DMAExt;
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::gpio::{FunctionSpi, Pins};
use rp2040_hal::pac::{CorePeripherals, Peripherals};
use rp2040_hal::{I2C, Sio, Spi, Timer, Watchdog};
use static_cell::{ConstStaticCell, StaticCell};
use tilt::picture::{BLACK, Picture, Rows};
use tilt::show::{RATE, SCREEN, Show};

/// The second-stage boot loader, which the boot ROM runs first: it makes the flash readable.
#[unsafe(link_section = ".boot2")]
#[unsafe(no_mangle)]
#[used]
#[allow(unsafe_code, reason = "a section of its own")]
static BOOT2_FIRMWARE: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// The frequency of the bus to the display, Hz.
const BUS: u32 = 50_000_000;
/// The frequency of the bus to the sensor, Hz.
const SENSOR_BUS: u32 = 400_000;
/// The most steps between two pictures; further steps are dropped.
const MOST: u32 = 2;
/// Steps between two lines of the log.
const LOGGED: u32 = 60;

static SHOW: StaticCell<Show> = StaticCell::new();
static ROWS: ConstStaticCell<Rows> = ConstStaticCell::new(BLACK);

#[rp2040_hal::entry]
fn main() -> ! {
    let (Some(core), Some(mut chip)) = (CorePeripherals::take(), Peripherals::take()) else { defmt::unreachable!() };
    let mut watchdog = Watchdog::new(chip.WATCHDOG);
    let plls = (chip.PLL_SYS, chip.PLL_USB);
    let clocks = chip::start(chip.VREG_AND_CHIP_RESET, chip.XOSC, chip.CLOCKS, plls, &mut chip.RESETS, &mut watchdog);
    let Ok(clocks) = clocks else { defmt::panic!("the clocks do not start") };
    let sio = Sio::new(chip.SIO);
    let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, sio.gpio_bank0, &mut chip.RESETS);
    let mut timer = Timer::new(chip.TIMER, &mut chip.RESETS, &clocks);
    let mut light = pins.gpio25.into_push_pull_output();

    let wires = (pins.gpio11.into_function::<FunctionSpi>(), pins.gpio10.into_function::<FunctionSpi>());
    let spi = Spi::<_, _, _, 8>::new(chip.SPI1, wires);
    let mut spi = spi.init(&mut chip.RESETS, clocks.peripheral_clock.freq(), BUS.Hz(), MODE_3);
    let mut select = pins.gpio9.into_push_pull_output();
    let mut data = pins.gpio8.into_push_pull_output();
    let Ok(device) = ExclusiveDevice::new_no_delay(&mut spi, &mut select);
    let mut buffer = [0; 64];
    let display = Builder::new(GC9A01, SpiInterface::new(device, &mut data, &mut buffer))
        .display_size(SCREEN.width as u16, SCREEN.height as u16)
        .invert_colors(ColorInversion::Inverted)
        .color_order(ColorOrder::Bgr)
        // as the manufacturer's programs for this board set it
        .orientation(Orientation::new().flip_vertical())
        .reset_pin(pins.gpio12.into_push_pull_output())
        .init(&mut timer);
    if display.is_err() {
        defmt::panic!("the display does not start");
    }
    drop(display);

    // from here on, frames of the bus have 16 bits
    let (interface, wires) = spi.disable().free();
    let spi = Spi::<_, _, _, 16>::new(interface, wires);
    let spi = spi.init(&mut chip.RESETS, clocks.peripheral_clock.freq(), BUS.Hz(), MODE_3);
    let channel = chip.DMA.split(&mut chip.RESETS).ch0;
    let mut lcd = Lcd::new(channel, spi, select, data);

    let (sda, scl) = (pins.gpio6.reconfigure(), pins.gpio7.reconfigure());
    let bus = I2C::i2c1(chip.I2C1, sda, scl, SENSOR_BUS.Hz(), &mut chip.RESETS, clocks.system_clock.freq());
    let mut hand = Hand::new(bus);

    let show = SHOW.init_with(Show::new);
    let canvas = &mut Canvas::new(Picture::new(ROWS.take()));
    // at first a display shows random pixels
    let Ok(()) = canvas.clear(Rgb565::BLACK);
    let frequency = clocks.system_clock.freq().to_Hz();
    let clock = Clock::start(core.SYST, frequency / RATE);
    let mut pace = Pace::new(MOST);
    let mut meter = Meter::default();
    let (mut now, mut step, mut first) = (0, 0, true);
    let mut logged = clock.cycles();
    loop {
        now = clock.wait(now);
        let start = clock.cycles();
        let due = pace.due(now);
        let mut changed = core::mem::take(&mut first);
        for _ in 0..due {
            if show.is_attentive() {
                hand.move_show(show);
            }
            changed |= show.step();
        }
        let simulated = clock.cycles();
        // the last picture was sent while the step was computed
        if lcd.finish(canvas.buffer()) {
            // the backlight is switched on with the first picture
            let Ok(()) = light.set_high();
            shown(step);
        }
        step += due;
        if !changed {
            continue;
        }
        let free = clock.cycles();
        let Ok(()) = canvas.restore(|behind| show.draw_back(behind));
        let sort = Lap::time(canvas, &clock, |lap| show.draw(lap));
        let drawn = clock.cycles();
        let Ok(()) = canvas.send(|picture, area| lcd.send(picture, area));
        let waited = free.wrapping_sub(simulated);
        meter.add([start, simulated, drawn.wrapping_sub(waited), clock.cycles()], sort);
        if step % LOGGED < due {
            let gone = clock.cycles().wrapping_sub(logged);
            logged = logged.wrapping_add(gone);
            meter.log(step, meter.rate(frequency, gone), pace.dropped, measure::digest(&show.cloth));
        }
    }
}

/// The motion of the hand, measured by the sensor.
struct Hand<I> {
    /// None if no sensor answered at the start.
    sensor: Option<Qmi8658<I>>,
    /// Whether it answered when it was last read.
    answers: bool,
}

impl<I: I2c> Hand<I> {
    fn new(bus: I) -> Self {
        let sensor = Qmi8658::start(bus).ok();
        if sensor.is_none() {
            defmt::warn!("no QMI8658 answers: gravity stays the display's");
        }
        Self { answers: sensor.is_some(), sensor }
    }

    /// Passes the sensor's force to the show. If the sensor does not answer, gravity stays as it is.
    fn move_show(&mut self, show: &mut Show) {
        let Some(sensor) = &mut self.sensor else { return };
        let force = sensor.force();
        if let Ok(force) = force {
            show.feel(turned(force));
        }
        if force.is_err() && self.answers {
            defmt::warn!("the QMI8658 does not answer: gravity stays as it is");
        }
        self.answers = force.is_ok();
    }
}

/// From the sensor's axes to the display's: right, away from the viewer, up. The sensor is on the back: its z points away from the viewer, its x down and its y to the left,
/// as other programs for this board assume. This program has not been tried on a real board: if the kerchief falls in another direction, change the axes here.
const fn turned([x, y, z]: [i32; 3]) -> [i32; 3] {
    [-y, z, -x]
}
