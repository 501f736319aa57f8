//! The picture as the display wants it: 16 bits a pixel.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::primitives::Rectangle;

use crate::show::SCREEN;

const WIDTH: usize = SCREEN.width as usize;
const HEIGHT: usize = SCREEN.height as usize;

/// A picture of 240 × 240 pixels, 115 200 bytes.
pub(crate) struct Picture {
    rows: [[u16; WIDTH]; HEIGHT],
}

impl Picture {
    /// All black.
    pub(crate) const fn new() -> Self {
        Self { rows: [[0; WIDTH]; HEIGHT] }
    }

    /// The part of each row that lies in an area of the picture.
    pub(crate) fn parts(&self, area: &Rectangle) -> impl Iterator<Item = &[u16]> {
        let [left, top] = [area.top_left.x, area.top_left.y].map(|place| place as usize);
        let [width, height] = [area.size.width, area.size.height].map(|side| side as usize);
        self.rows.iter().skip(top).take(height).filter_map(move |row| row.get(left..left + width))
    }
}

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        SCREEN
    }
}

impl GetPixel for Picture {
    type Color = Rgb565;

    fn pixel(&self, at: Point) -> Option<Rgb565> {
        let row = self.rows.get(usize::try_from(at.y).ok()?)?;
        Some(RawU16::new(*row.get(usize::try_from(at.x).ok()?)?).into())
    }
}

impl DrawTarget for Picture {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().try_for_each(|Pixel(at, color)| self.fill_solid(&Rectangle::new(at, Size::new(1, 1)), color))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Infallible> {
        let area = area.intersection(&self.bounding_box());
        let [left, top] = [area.top_left.x, area.top_left.y].map(|place| place as usize);
        let [width, height] = [area.size.width, area.size.height].map(|side| side as usize);
        let color = RawU16::from(color).into_inner();
        for row in self.rows.iter_mut().skip(top).take(height) {
            if let Some(part) = row.get_mut(left..left + width) {
                part.fill(color);
            }
        }
        Ok(())
    }
}
