//! The Raspberry Pi Pico with an SSD1306 in rp2040js.

use std::path::Path;

use image::{Rgb, RgbImage};
use serde::Deserialize;

use crate::board::rp2040;
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("examples/ssd1306", "ssd1306-rp2040", &["thumbv6m-none-eabi"]);

const WIDTH: u32 = 128;
const HEIGHT: u32 = 64;

/// Observations after the last picture.
#[derive(Debug, Deserialize)]
pub struct Run {
    /// The display's memory: a byte is eight pixels of a column, a page of 128 bytes is eight rows.
    memory: Vec<u8>,
    /// Whether the display is on.
    pub on: bool,
    /// Emulated time since the start.
    pub milliseconds: f64,
    /// Errors in the program's use of the display or the chip.
    pub errors: Vec<String>,
}

impl Run {
    /// The display's pixels, white where they shine.
    pub fn picture(&self) -> RgbImage {
        RgbImage::from_fn(WIDTH, HEIGHT, |x, y| {
            let shines = self.memory[(y / 8 * WIDTH + x) as usize] >> (y % 8) & 1 == 1;
            Rgb([if shines { 255 } else { 0 }; 3])
        })
    }
}

/// Runs a program until it has sent this number of pictures, and passes the number of each to `shown`.
///
/// # Errors
///
/// If the program or the emulator fails. Complaints of the display and the chip are in [`Run::errors`] instead.
pub fn run(program: &Path, pictures: u32, shown: impl FnMut(u32)) -> Result<Run> {
    Ok(serde_json::from_slice(&rp2040::run("ssd1306.mjs", program, pictures.to_string(), shown)?)?)
}
