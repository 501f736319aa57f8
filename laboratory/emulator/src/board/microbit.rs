//! The BBC micro:bit.

use std::path::Path;

use image::{Rgb, RgbImage};

use crate::qemu::Qemu;
use crate::{Firmware, Result};
use microbit::leds::{BRIGHTEST, LEDS, ROWS, lit};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("boards/microbit", "microbit", &["thumbv6m-none-eabi"]);
const MACHINE: &str = "microbit";
/// An instruction takes 2 to the power of this, 64 ns: about a cycle at 16 MHz.
const SHIFT: u32 = 6;
/// QEMU's trace event for a write to the pins.
const WRITE: &str = "nrf51_gpio_write";
/// A traced write to the register of all pins, up to its value.
const OUT: &str = "offset 0x504 value ";

/// The brightness of each LED, 0 to [`BRIGHTEST`].
pub type Levels = [[u32; LEDS]; LEDS];

/// Starts a program.
///
/// # Errors
///
/// If the program or the emulator fails.
pub fn start(program: &Path) -> Result<Qemu> {
    Qemu::start(MACHINE, Some(WRITE), program, SHIFT)
}

/// The number of passes of the last picture in which each LED shone.
///
/// # Errors
///
/// If the picture has too few or too many passes.
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

/// A picture of the LEDs.
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
