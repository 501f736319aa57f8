//! Pictures side by side, each with a caption.

use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_10X20};
use embedded_graphics::pixelcolor::{Rgb888, WebColors};
use embedded_graphics::prelude::*;
use embedded_graphics::text::{Alignment, Text};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use image::{Rgb, RgbImage, imageops};

/// The height of a caption, and the gap between two pictures, pixels.
const LINE: u32 = 32;
const GAP: u32 = 8;

/// Pictures of equal size side by side, each above its caption.
pub fn strip(panels: &[(RgbImage, String)]) -> RgbImage {
    let (width, height) = panels.first().map_or((0, 0), |(picture, _)| picture.dimensions());
    let count = panels.len() as u32;
    let mut page = RgbImage::from_pixel(count * (width + GAP) - GAP, height + LINE, Rgb([255; 3]));
    for (index, (picture, words)) in panels.iter().enumerate() {
        let left = i64::from(index as u32 * (width + GAP));
        imageops::replace(&mut page, picture, left, 0);
        imageops::replace(&mut page, &line(words, width), left, height.into());
    }
    page
}

fn line(words: &str, width: u32) -> RgbImage {
    let mut display = SimulatorDisplay::with_default_color(Size::new(width, LINE), Rgb888::WHITE);
    let style = MonoTextStyle::new(&FONT_10X20, Rgb888::CSS_DARK_SLATE_GRAY);
    let middle = Point::new(width as i32 / 2, 22);
    let Ok(_) = Text::with_alignment(words, middle, style, Alignment::Center).draw(&mut display);
    let image = display.to_rgb_output_image(&OutputSettings::default());
    RgbImage::from_vec(width, LINE, image.as_image_buffer().to_vec()).expect("an image of that size")
}
