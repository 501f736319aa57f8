//! The LM3S6965 evaluation board.

use image::{GrayImage, Luma};

use crate::qemu::Qemu;
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("boards/oled", "oled", &["thumbv7m-none-eabi"]);
/// QEMU's name of the board.
pub const MACHINE: &str = "lm3s6965evb";

/// The greys (0 to 15) of the display's pixels.
///
/// # Errors
///
/// If the screen shows anything other than pixels in these greys.
pub fn greys(board: &mut Qemu) -> Result<GrayImage> {
    /// QEMU enlarges pixels by this factor.
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
