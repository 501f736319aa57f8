//! A flag in gusts of wind, on a Raspberry Pi Pico with an LCD. The button changes to a flag in a steady breeze, and then to a cloth on two corners in calm air.
//!
//! | LCD (ST7789, 240 × 240) | Pico |
//! |---|---|
//! | SCL | GP18 (SPI0 SCK) |
//! | SDA | GP19 (SPI0 TX) |
//! | CS | GP17 |
//! | DC | GP16 |
//! | RES | GP20 |
//! | BLK | GP21 |
//! | VCC, GND | 3V3, GND |
//!
//! | button | Pico |
//! |---|---|
//! | one side, the other | GP15, GND |
//!
//! ![the LCD in the emulator](../../../docs/pico.png)
//!
//! ```sh
//! cargo emulate pico --png pico.png                  # in rp2040js: the picture after 120 steps, and the log
//! cd examples/pico && cargo run --release            # on a Pico with a probe
//! ```
//!
//! To start a program of your own, copy the package and the memory map, which then lies beside its `Cargo.toml`:
//!
//! ```sh
//! cp -r examples/pico my-flag && cp memory.x my-flag
//! ```
//!
//! The chip runs at 200 MHz, its bus to the display at 50. A step is a 60th of a second, and each has a picture. While DMA sends a picture to the display,
//! the next step is computed, by code that was copied to RAM (`fast.x`). At rest no step is computed and no byte is sent to the display: the processor sleeps. The log is
//! sent through RTT.
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in examples/pico, whose .cargo/config.toml names the target");

mod chip;
mod clock;
mod divider;
mod fast;
mod lcd;
mod meter;
mod pace;

use clock::Clock;
use defmt_rtt as _;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::RgbColor;
use embedded_hal::digital::{InputPin, OutputPin};
use embedded_hal::spi::MODE_3;
use embedded_hal_bus::spi::ExclusiveDevice;
use kerchief::measure;
use kerchief::render::Canvas;
use lcd::Lcd;
use meter::{Lap, Meter, shown};
use mipidsi::Builder;
use mipidsi::interface::SpiInterface;
use mipidsi::models::ST7789;
use mipidsi::options::ColorInversion;
use pace::Pace;
use panic_probe as _;
use pico::picture::{BLACK, Picture, Rows};
use pico::show::{NOTE, RATE, SCREEN, Show};
use rp2040_hal::clocks::Clock as _;
use rp2040_hal::dma::DMAExt;
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::gpio::{FunctionSpi, Pins};
use rp2040_hal::pac::{CorePeripherals, Peripherals};
use rp2040_hal::{Sio, Spi, Timer, Watchdog};
use static_cell::{ConstStaticCell, StaticCell};

/// The second-stage boot loader, which the boot ROM runs first: it makes the flash readable.
#[unsafe(link_section = ".boot2")]
#[unsafe(no_mangle)]
#[used]
#[allow(unsafe_code, reason = "a section of its own")]
static BOOT2_FIRMWARE: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// The frequency of the bus to the display, Hz.
const BUS: u32 = 50_000_000;
/// The most steps by which the show may be late; further steps are dropped.
const SLACK: u32 = 6;
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
    let mut button = pins.gpio15.into_pull_up_input();
    let mut light = pins.gpio21.into_push_pull_output();

    let wires = (pins.gpio19.into_function::<FunctionSpi>(), pins.gpio18.into_function::<FunctionSpi>());
    let spi = Spi::<_, _, _, 8>::new(chip.SPI0, wires);
    let mut spi = spi.init(&mut chip.RESETS, clocks.peripheral_clock.freq(), BUS.Hz(), MODE_3);
    let mut select = pins.gpio17.into_push_pull_output();
    let mut data = pins.gpio16.into_push_pull_output();
    let Ok(device) = ExclusiveDevice::new_no_delay(&mut spi, &mut select);
    let mut buffer = [0; 64];
    let display = Builder::new(ST7789, SpiInterface::new(device, &mut data, &mut buffer))
        .display_size(SCREEN.width as u16, SCREEN.height as u16)
        .invert_colors(ColorInversion::Inverted)
        .reset_pin(pins.gpio20.into_push_pull_output())
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

    let show = SHOW.init_with(Show::new);
    let canvas = &mut Canvas::new(Picture::new(ROWS.take()));
    // at first a display shows random pixels
    let Ok(()) = canvas.clear(Rgb565::BLACK);
    let frequency = clocks.system_clock.freq().to_Hz();
    let clock = Clock::start(core.SYST, frequency / RATE);
    let mut pace = Pace::new(1);
    let mut meter = Meter::default();
    let (mut now, mut step, mut first, mut pressed) = (0, 0, true, false);
    let mut logged = clock.cycles();
    loop {
        // the next steps make up for a step that takes longer than its time
        now = clock.wait(now).saturating_sub(SLACK).max(now + 1);
        let start = clock.cycles();
        let Ok(down) = button.is_low();
        let is_press = down && !pressed;
        pressed = down;
        if is_press {
            show.press();
        }
        let due = pace.due(now);
        let changed = (0..due).fold(first || is_press, |changed, _| show.step() || changed);
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
        first = false;
        if is_press {
            let Ok(()) = canvas.clear(Rgb565::BLACK);
        }
        let Ok(()) = canvas.restore(|behind| show.draw_sky(behind));
        let sort = Lap::time(canvas, &clock, |lap| show.draw(lap));
        let drawn = clock.cycles();
        let Ok(()) = canvas.send(|picture, area| lcd.send(picture, area));
        let waited = free.wrapping_sub(simulated);
        meter.add([start, simulated, drawn.wrapping_sub(waited), clock.cycles()], sort);
        if step % LOGGED < due {
            let gone = clock.cycles().wrapping_sub(logged);
            logged = logged.wrapping_add(gone);
            let rate = meter.rate(frequency, gone);
            meter.log(step, rate, pace.dropped, measure::digest(&show.cloth));
            show.note(rate, frequency / 1_000_000);
            // so that the next picture draws the backdrop there, too
            let Ok(()) = canvas.fill_solid(&NOTE, Rgb565::BLACK);
        }
    }
}
