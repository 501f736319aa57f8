//! The picture in the display's format: 16 bits a pixel.

use core::cell::Cell;
use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{OriginDimensions, Point, Size};
use embedded_graphics::image::GetPixel;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::{RawData, RawU16};
use embedded_graphics::primitives::{PointsIter, Rectangle};

use crate::show::SCREEN;

const WIDTH: usize = SCREEN.width as usize;
const HEIGHT: usize = SCREEN.height as usize;

/// All pixels, black.
#[allow(clippy::large_const_arrays, reason = "what a static starts as")]
pub const BLACK: Rows = [[0; WIDTH]; HEIGHT];

/// The pixels, 115 200 bytes.
pub type Rows = [[u16; WIDTH]; HEIGHT];

/// A picture of 240 × 240 pixels, too large for the stack.
///
/// Its pixels may be lent. Meanwhile no pixel can be read, and drawing has no effect.
#[allow(missing_debug_implementations, reason = "it would print 57 600 numbers")]
pub struct Picture {
    rows: Cell<Option<&'static mut Rows>>,
}

impl Picture {
    /// A picture in these rows.
    pub fn new(rows: &'static mut Rows) -> Self {
        Self { rows: Cell::new(Some(rows)) }
    }

    /// Lends the pixels, unless they are lent already.
    pub fn lend(&self) -> Option<&'static mut Rows> {
        self.rows.take()
    }

    /// Takes back pixels that were lent.
    pub fn give_back(&self, rows: &'static mut Rows) {
        self.rows.set(Some(rows));
    }
}

/// Writes colours to pixels, until there are no more of either.
#[inline(never)] // alone, the loop's variables fit the registers of a Cortex-M0
fn write(pixels: &mut [u16], colors: impl Iterator<Item = Rgb565>) {
    for (pixel, color) in pixels.iter_mut().zip(colors) {
        *pixel = RawU16::from(color).into_inner();
    }
}

/// Writes one colour to all pixels, four at a time.
#[inline]
fn fill(pixels: &mut [u16], color: u16) {
    let mut fours = pixels.chunks_exact_mut(4);
    for four in &mut fours {
        four.fill(color);
    }
    fours.into_remainder().fill(color);
}

impl OriginDimensions for Picture {
    fn size(&self) -> Size {
        SCREEN
    }
}

impl GetPixel for Picture {
    type Color = Rgb565;

    fn pixel(&self, at: Point) -> Option<Rgb565> {
        let rows = self.lend()?;
        let [x, y] = [at.x, at.y].map(|place| usize::try_from(place).ok());
        let pixel = y.and_then(|y| rows.get(y)).zip(x).and_then(|(row, x)| row.get(x)).copied();
        self.give_back(rows);
        Some(RawU16::new(pixel?).into())
    }
}

impl DrawTarget for Picture {
    type Color = Rgb565;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb565>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        pixels.into_iter().try_for_each(|Pixel(at, color)| self.fill_solid(&Rectangle::new(at, Size::new(1, 1)), color))
    }

    #[inline]
    fn fill_contiguous<I: IntoIterator<Item = Rgb565>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        let mut colors = colors.into_iter();
        let columns = area.top_left.x as usize..(area.top_left.x as usize).wrapping_add(area.size.width as usize);
        if area.size.height == 1 {
            // a part of a row within the picture: faces are drawn as such parts
            let row = self.rows.get_mut().as_mut().and_then(|all| all.get_mut(area.top_left.y as usize));
            if let Some(part) = row.and_then(|row| row.get_mut(columns)) {
                write(part, colors);
                return Ok(());
            }
        }
        area.points()
            .zip(&mut colors)
            .try_for_each(|(at, color)| self.fill_solid(&Rectangle::new(at, Size::new(1, 1)), color))
    }

    #[inline]
    fn fill_solid(&mut self, area: &Rectangle, color: Rgb565) -> Result<(), Infallible> {
        let Some(all) = self.rows.get_mut() else { return Ok(()) };
        let color = RawU16::from(color).into_inner();
        let end = area.top_left + area.size;
        if area.size.height == 1 {
            // a part of a row within the picture: faces are drawn as such parts
            let row = all.get_mut(area.top_left.y as usize);
            if let Some(part) = row.and_then(|row| row.get_mut(area.top_left.x as usize..end.x as usize)) {
                fill(part, color);
                return Ok(());
            }
        }
        let within = |place: i32, side: usize| place.clamp(0, side as i32) as usize;
        let columns = within(area.top_left.x, WIDTH)..within(end.x, WIDTH);
        if let Some(rows) = all.get_mut(within(area.top_left.y, HEIGHT)..within(end.y, HEIGHT)) {
            for row in rows {
                if let Some(part) = row.get_mut(columns.clone()) {
                    fill(part, color);
                }
            }
        }
        Ok(())
    }
}
