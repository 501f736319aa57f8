//! An enlarged picture of a display with its case.

use image::{Rgb, RgbImage};

/// Width of the dark frame around the display, in pixels of the display.
const BEZEL: u32 = 4;

/// Enlarges a picture by `scale`. The pixels of an OLED are separate lights: between two of them, `gap` of the `scale` dots stay dark.
pub fn photograph(picture: &RgbImage, scale: u32, gap: u32) -> RgbImage {
    const BLACK: Rgb<u8> = Rgb([6, 6, 8]);
    const CASE: Rgb<u8> = Rgb([28, 29, 32]);
    let [width, height] = [picture.width(), picture.height()].map(|side| (side + 2 * BEZEL) * scale);
    RgbImage::from_fn(width, height, |x, y| {
        let at = |place: u32, side: u32| (place / scale).checked_sub(BEZEL).filter(|pixel| *pixel < side);
        let (Some(column), Some(row)) = (at(x, picture.width()), at(y, picture.height())) else {
            let edge = |place: u32, length: u32| place.min(length - 1 - place);
            return if edge(x, width).min(edge(y, height)) < scale { CASE } else { BLACK };
        };
        if x % scale >= scale - gap || y % scale >= scale - gap { BLACK } else { *picture.get_pixel(column, row) }
    })
}
