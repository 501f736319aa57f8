//! A flag on the small OLED that many boards have: SSD1306, 128 × 64 pixels, by its usual driver, on a Raspberry Pi Pico.
//!
//! | OLED | Pico |
//! |---|---|
//! | SDA | GP4 (I2C0 SDA) |
//! | SCL | GP5 (I2C0 SCL) |
//! | VCC, GND | 3V3, GND |
//!
//! ![the OLED in the emulator](../../docs/ssd1306.png)
//!
//! ```sh
//! cargo emulate ssd1306 --png ssd1306.png            # in rp2040js
//! cd examples/ssd1306 && cargo run --release         # on a Pico with a probe
//! ```
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in examples/ssd1306, whose .cargo/config.toml names the target");

use embedded_graphics::pixelcolor::BinaryColor;
use embedded_graphics::prelude::*;
use kerchief::render::{Camera, View, Wireframe};
use kerchief::{Node, Q13, Sheet, Xpbd};
use panic_halt as _;
use rp2040_hal::clocks::{Clock, init_clocks_and_plls};
use rp2040_hal::fugit::RateExtU32;
use rp2040_hal::gpio::Pins;
use rp2040_hal::{I2C, Sio, Timer, Watchdog, pac};
use ssd1306::{I2CDisplayInterface, Ssd1306, prelude::*};

/// The second-stage boot loader, which the boot ROM runs first: it makes the flash readable.
#[unsafe(link_section = ".boot2")]
#[unsafe(no_mangle)]
#[used]
#[allow(unsafe_code, reason = "a section of its own")]
static BOOT2_FIRMWARE: [u8; 256] = rp2040_boot2::BOOT_LOADER_W25Q080;

/// Pictures a second. Of the 50 ms of each, I2C takes 24 to send the picture.
const RATE: u32 = 20;
/// 13 × 9 particles of 2 g each, 1.2 m × 0.8 m, four substeps a picture.
const SHEET: Sheet<Q13, 13, 9> = Sheet::new([1.2, 0.8], 0.002, 1.0 / RATE as f64, 4);
const SCREEN: Size = Size::new(128, 64);
const VIEW: View =
    View::new(15.0, 0.0).fit(SHEET.units.point([0.0, -0.2, -0.86]), SHEET.units.point([1.2, 0.2, 0.02]), SCREEN);

#[rp2040_hal::entry]
fn main() -> ! {
    let mut chip = pac::Peripherals::take().unwrap();
    let mut watchdog = Watchdog::new(chip.WATCHDOG);
    let (pll_sys, pll_usb) = (chip.PLL_SYS, chip.PLL_USB);
    let clocks =
        init_clocks_and_plls(12_000_000, chip.XOSC, chip.CLOCKS, pll_sys, pll_usb, &mut chip.RESETS, &mut watchdog)
            .ok()
            .unwrap();
    let timer = Timer::new(chip.TIMER, &mut chip.RESETS, &clocks);
    let pins = Pins::new(chip.IO_BANK0, chip.PADS_BANK0, Sio::new(chip.SIO).gpio_bank0, &mut chip.RESETS);
    let (sda, scl) = (pins.gpio4.reconfigure(), pins.gpio5.reconfigure());
    let i2c = I2C::i2c0(chip.I2C0, sda, scl, 400.kHz(), &mut chip.RESETS, clocks.system_clock.freq());
    let mut display = Ssd1306::new(I2CDisplayInterface::new(i2c), DisplaySize128x64, DisplayRotation::Rotate0)
        .into_buffered_graphics_mode();
    display.init().unwrap();

    let mut cloth = SHEET.hang([0.0; 3]);
    (0..9).for_each(|row| cloth.pin(Node::new(0, row)));
    let forces = (SHEET.gravity([0.0, 0.0, -9.81]), SHEET.aerodynamic_wind([8.0, 1.0, 0.0], 1.2, 1.2));
    let scene = SHEET.scene(forces, (SHEET.stretch(200.0), SHEET.shear(10.0)), (), Xpbd::new());
    let mut memory = scene.memory();
    let camera = Camera::new(&VIEW, SCREEN);
    let mut next = timer.get_counter_low();
    loop {
        scene.step(&mut cloth, &mut memory);
        display.clear(BinaryColor::Off).unwrap();
        Wireframe::new(&cloth, &camera).draw(&mut display).unwrap();
        display.flush().unwrap();
        next = next.wrapping_add(1_000_000 / RATE);
        while timer.get_counter_low().wrapping_sub(next) >= 1 << 31 {}
    }
}
