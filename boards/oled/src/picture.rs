//! The picture in the display's format: two pixels a byte, the left one in the upper half.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::pixelcolor::{Gray4, GrayColor};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

use crate::show::SCREEN;

/// Bytes of a row.
pub const ROW: usize = SCREEN.width as usize / 2;

/// A picture of 128 × 64 pixels. Parts of rows are filled byte by byte, not pixel by pixel.
#[derive(Debug)]
pub struct Picture {
    bytes: [[u8; ROW]; SCREEN.height as usize],
}

impl Picture {
    /// All black.
    pub const fn new() -> Self {
        Self { bytes: [[0; ROW]; SCREEN.height as usize] }
    }

    /// The bytes of all rows.
    pub fn bytes(&self) -> &[u8] {
        self.bytes.as_flattened()
    }
}

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        SCREEN
    }
}

impl GetPixel for Picture {
    type Color = Gray4;

    fn pixel(&self, at: Point) -> Option<Gray4> {
        let row = self.bytes.get(usize::try_from(at.y).ok()?)?;
        let byte = row.get(usize::try_from(at.x).ok()? / 2)?;
        Some(Gray4::new(if at.x % 2 == 0 { byte >> 4 } else { byte & 15 }))
    }
}

impl DrawTarget for Picture {
    type Color = Gray4;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().try_for_each(|Pixel(at, color)| self.fill_solid(&Rectangle::new(at, Size::new(1, 1)), color))
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Gray4) -> Result<(), Infallible> {
        let area = area.intersection(&self.bounding_box());
        let both = color.luma() * 0x11;
        let [start, top] = [area.top_left.x, area.top_left.y].map(|place| place as usize);
        let end = start + area.size.width as usize;
        for row in self.bytes.iter_mut().skip(top).take(area.size.height as usize) {
            if start % 2 == 1 && start < end {
                row[start / 2] = row[start / 2] & 0xf0 | both & 0x0f;
            }
            if end % 2 == 1 && start < end {
                row[end / 2] = row[end / 2] & 0x0f | both & 0xf0;
            }
            if let Some(whole) = row.get_mut(start.div_ceil(2)..end / 2) {
                whole.fill(both);
            }
        }
        Ok(())
    }
}
