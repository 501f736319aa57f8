//! The LM3S6965 evaluation board.

use std::path::PathBuf;

use image::{GrayImage, Luma};

use crate::firmware::Firmware;
use crate::gdb::Result;
use crate::qemu::Qemu;

const TARGET: &str = "thumbv7m-none-eabi";
pub(crate) const MACHINE: &str = "lm3s6965evb";

/// Builds the example.
pub(crate) fn build() -> PathBuf {
    let firmware = Firmware {
        example: "oled",
        board: Some("lm3s6965"),
        features: "oled",
        profile: "board",
        targets: &[TARGET],
        only: [None; 2],
    };
    firmware.build()[TARGET].clone()
}

/// The greys (0 to 15) of the display's pixels.
pub(crate) fn greys(board: &mut Qemu) -> Result<GrayImage> {
    /// QEMU enlarges pixels.
    const PIXEL: u32 = 4;
    let screen = board.screen()?;
    let (width, height) = (screen.width() / PIXEL, screen.height() / PIXEL);
    for (x, y, color) in screen.enumerate_pixels() {
        let image::Rgb([r, g, b]) = *color;
        let first = screen.get_pixel(x / PIXEL * PIXEL, y / PIXEL * PIXEL);
        if color != first || r != g || g != b || r % 17 != 0 {
            return Err(format!("the screen is {color:?} at {x}, {y}").into());
        }
    }
    Ok(GrayImage::from_fn(width, height, |x, y| Luma([screen.get_pixel(x * PIXEL, y * PIXEL)[0] / 17])))
}
