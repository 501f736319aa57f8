//! The pixels of a picture in the format of a canvas: red, green, blue and opacity, a byte each.

use core::convert::Infallible;

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;

/// The most pixels a side.
pub const LARGEST: u32 = 1024;

/// A picture.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Frame {
    size: Size,
    bytes: Vec<[u8; 4]>,
}

impl Frame {
    /// A picture without pixels.
    pub const EMPTY: Self = Self { size: Size::zero(), bytes: Vec::new() };

    /// Sets the size of the picture, at most [`LARGEST`] pixels a side.
    pub fn resize(&mut self, width: u32, height: u32) {
        self.size = Size::new(width.clamp(1, LARGEST), height.clamp(1, LARGEST));
        self.bytes.resize((self.size.width * self.size.height) as usize, [255; 4]);
    }

    /// The pixels, row by row.
    pub fn bytes(&self) -> &[[u8; 4]] {
        &self.bytes
    }

    /// The 32-bit FNV-1a hash of all bytes.
    pub fn hash(&self) -> u32 {
        let hash = |hash: u32, byte: &u8| (hash ^ u32::from(*byte)).wrapping_mul(0x0100_0193);
        self.bytes.iter().flatten().fold(0x811c_9dc5, hash)
    }

    fn row(&mut self, y: i32, left: i32, width: u32) -> &mut [[u8; 4]] {
        let start = y as usize * self.size.width as usize + left as usize;
        &mut self.bytes[start..start + width as usize]
    }
}

fn bytes(color: Rgb888) -> [u8; 4] {
    [color.r(), color.g(), color.b(), 255]
}

impl OriginDimensions for Frame {
    fn size(&self) -> Size {
        self.size
    }
}

impl DrawTarget for Frame {
    type Color = Rgb888;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        let seen = self.bounding_box();
        for Pixel(at, color) in pixels {
            if seen.contains(at) {
                self.row(at.y, at.x, 1)[0] = bytes(color);
            }
        }
        Ok(())
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb888>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        if area.intersection(&self.bounding_box()) != *area {
            return self.draw_iter(area.points().zip(colors).map(|(at, color)| Pixel(at, color)));
        }
        let mut colors = colors.into_iter();
        for y in area.rows() {
            for (pixel, color) in self.row(y, area.top_left.x, area.size.width).iter_mut().zip(&mut colors) {
                *pixel = bytes(color);
            }
        }
        Ok(())
    }

    fn fill_solid(&mut self, area: &Rectangle, color: Rgb888) -> Result<(), Infallible> {
        let area = area.intersection(&self.bounding_box());
        for y in area.rows() {
            self.row(y, area.top_left.x, area.size.width).fill(bytes(color));
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn frame() -> Frame {
        let mut frame = Frame::default();
        frame.resize(4, 3);
        frame
    }

    /// Indices of the red pixels.
    fn red(frame: &Frame) -> Vec<usize> {
        let is_red = |pixel: &[u8; 4]| *pixel == [255, 0, 0, 255];
        frame.bytes().iter().enumerate().filter(|(_, pixel)| is_red(pixel)).map(|(index, _)| index).collect()
    }

    #[test]
    fn every_way_to_fill_clips_alike() {
        for (area, expected) in [
            (Rectangle::new(Point::new(1, 1), Size::new(2, 1)), vec![5, 6]),
            (Rectangle::new(Point::new(2, -1), Size::new(9, 3)), vec![2, 3, 6, 7]),
            (Rectangle::new(Point::new(-5, 2), Size::new(6, 7)), vec![8]),
            (Rectangle::new(Point::new(4, 0), Size::new(1, 1)), vec![]),
        ] {
            let mut frames = [frame(), frame(), frame()];
            let Ok(()) = frames[0].fill_solid(&area, Rgb888::RED);
            let Ok(()) = frames[1].fill_contiguous(&area, core::iter::repeat(Rgb888::RED));
            let Ok(()) = frames[2].draw_iter(area.points().map(|at| Pixel(at, Rgb888::RED)));
            for frame in &frames {
                assert_eq!(red(frame), expected, "{area:?}");
            }
        }
    }

    #[test]
    fn a_short_row_of_colours_leaves_the_rest() {
        let mut frame = frame();
        let Ok(()) = frame.fill_contiguous(&Rectangle::new(Point::zero(), Size::new(2, 2)), [Rgb888::RED; 3]);
        assert_eq!(red(&frame), [0, 1, 4]);
    }

    #[test]
    fn the_hash_sees_every_pixel() {
        let (blank, mut changed) = (frame(), frame());
        let Ok(()) = changed.draw_iter([Pixel(Point::new(3, 2), Rgb888::RED)]);
        assert_ne!(blank.hash(), changed.hash());
    }
}
