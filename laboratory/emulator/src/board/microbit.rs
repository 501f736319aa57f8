//! The BBC micro:bit.

use std::path::Path;

use image::{Rgb, RgbImage};

use crate::qemu::Qemu;
use crate::{Firmware, Result};
use microbit::leds::{BRIGHTEST, LEDS, ROWS, lit};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("boards/microbit", "microbit", &["thumbv6m-none-eabi"]);
const MACHINE: &str = "microbit";
/// 64 ns an instruction, as at 16 MHz.
const SHIFT: u32 = 6;
/// What is written to the pins.
const WRITE: &str = "nrf51_gpio_write";
/// The register of all pins.
const OUT: &str = "offset 0x504 value ";

/// How bright each LED is.
pub type Levels = [[u32; LEDS]; LEDS];

/// Starts a program.
///
/// # Errors
///
/// What is wrong with the program or the emulator.
pub fn start(program: &Path) -> Result<Qemu> {
    Qemu::start(MACHINE, Some(WRITE), program, SHIFT)
}

/// For how many passes of the last picture each LED shone.
///
/// # Errors
///
/// Where a picture has another number of passes.
pub fn levels(board: &mut Qemu) -> Result<Levels> {
    let mut levels = [[0; LEDS]; LEDS];
    let mut slots = 0;
    for line in board.trace()? {
        let Some(value) = line.strip_prefix(OUT) else { continue };
        let pins = u32::from_str_radix(value.trim_start_matches("0x"), 16)?;
        slots += u32::from(pins != 0);
        for (level, shines) in levels.iter_mut().flatten().zip(lit(pins).into_iter().flatten()) {
            *level += shines;
        }
    }
    if slots == ROWS * BRIGHTEST { Ok(levels) } else { Err(format!("{slots} slots of a picture").into()) }
}

/// The LEDs as a camera sees them.
pub fn photograph(levels: &Levels) -> RgbImage {
    /// From one LED to the next, in dots.
    const PITCH: u32 = 64;
    const SIDE: u32 = PITCH * LEDS as u32;
    const BOARD: [f64; 3] = [20.0, 22.0, 28.0];
    const RED: [f64; 3] = [255.0, 44.0, 26.0];
    RgbImage::from_fn(SIDE, SIDE, |x, y| {
        let level = f64::from(levels[(y / PITCH) as usize][(x / PITCH) as usize]) / f64::from(BRIGHTEST);
        let from_middle = |place: u32| f64::from(place % PITCH) - f64::from(PITCH / 2) + 0.5;
        // an upright case of 10 × 20 dots with a glow around it
        let [across, down] = [(from_middle(x).abs() - 5.0).max(0.0), (from_middle(y).abs() - 10.0).max(0.0)];
        let away = across.hypot(down);
        let shine = if away == 0.0 { 0.12 + 0.88 * level } else { 0.75 * level * (-away / 6.0).exp() };
        let heat = if away == 0.0 { level * 0.35 } else { 0.0 };
        Rgb([0, 1, 2].map(|k| (BOARD[k] + (RED[k] - BOARD[k]) * shine + (255.0 - RED[k]) * heat) as u8))
    })
}
