//! Writes pictures as a GIF with one palette, where each frame contains only the changed rectangle.

use std::io::Write;

use color_quant::NeuQuant;
use gif::{DisposalMethod, Encoder, EncodingError, Frame, Repeat};
use image::{Rgb, RgbImage};

/// A GIF has 256 colours; the last one stands for "as before".
const COLOURS: usize = 255;
const AS_BEFORE: u8 = 255;
/// `NeuQuant` samples one pixel in this many.
const SAMPLED: i32 = 3;

/// Thresholds 0 to 15 of ordered dithering (B. Bayer, *An optimum method for two-level rendition of continuous-tone pictures*, 1973).
const BAYER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];
/// The largest change of a component by dithering: about half the distance between neighbouring colours of the palette.
const DITHER: u8 = 5;

/// The colours of an animation.
#[derive(Debug)]
pub(crate) struct Palette {
    colours: Vec<u8>,
    /// The index of the nearest colour, by the upper 6 bits of red, green and blue.
    nearest: Vec<u8>,
}

impl Palette {
    /// The best colours for these pictures.
    pub(crate) fn of<'a>(pictures: impl IntoIterator<Item = &'a RgbImage>) -> Self {
        let opaque = |Rgb([red, green, blue]): &Rgb<u8>| [*red, *green, *blue, 255];
        let pixels: Vec<u8> = pictures.into_iter().flat_map(|picture| picture.pixels().flat_map(opaque)).collect();
        let quantizer = NeuQuant::new(SAMPLED, COLOURS, &pixels);
        let middle = |bits: usize| ((bits & 63) << 2 | 2) as u8;
        let nearest =
            |bits: usize| quantizer.index_of(&[middle(bits >> 12), middle(bits >> 6), middle(bits), 255]) as u8;
        Self { nearest: (0..1 << 18).map(nearest).collect(), colours: quantizer.color_map_rgb() }
    }

    /// The index of a pixel's colour, dithered: without it, edges would be visible between two colours of the palette.
    fn index(&self, (x, y, Rgb(components)): (u32, u32, &Rgb<u8>)) -> u8 {
        let threshold = BAYER[(y & 3) as usize][(x & 3) as usize];
        let [red, green, blue] = components
            .map(|component| usize::from(component.saturating_add(threshold * DITHER / 8).saturating_sub(DITHER) >> 2));
        self.nearest[red << 12 | green << 6 | blue]
    }
}

/// A GIF that is being written. It repeats for ever.
pub(crate) struct Animation<'a, W: Write> {
    encoder: Encoder<W>,
    palette: &'a Palette,
    shown: Vec<u8>,
    /// The exact and the rounded sum of all delays, in the hundredths of a second that a GIF counts.
    due: f64,
    given: f64,
}

impl<'a, W: Write> Animation<'a, W> {
    /// Begins an animation of pictures of `width` × `height`.
    pub(crate) fn new(file: W, width: u16, height: u16, palette: &'a Palette) -> Result<Self, EncodingError> {
        let mut encoder = Encoder::new(file, width, height, &palette.colours)?;
        encoder.set_repeat(Repeat::Infinite)?;
        Ok(Self { encoder, palette, shown: Vec::new(), due: 0.0, given: 0.0 })
    }

    /// Shows `picture` for `seconds`.
    pub(crate) fn show(&mut self, picture: &RgbImage, seconds: f64) -> Result<(), EncodingError> {
        let width = picture.width() as usize;
        let indices: Vec<u8> = picture.enumerate_pixels().map(|pixel| self.palette.index(pixel)).collect();
        let changed = |at: &usize| self.shown.get(*at) != Some(&indices[*at]);
        let rows = (0..indices.len()).filter(changed).map(|at| at / width);
        let columns = (0..indices.len()).filter(changed).map(|at| at % width);
        let (left, right) = columns.fold((width - 1, 0), |(low, high), x| (low.min(x), high.max(x)));
        let (top, bottom) = rows.fold((picture.height() as usize - 1, 0), |(low, high), y| (low.min(y), high.max(y)));
        // A picture equal to the last one still needs a frame for its delay: that frame has one pixel.
        let (right, bottom) = (right.max(left), bottom.max(top));
        let buffer = (top..=bottom)
            .flat_map(|y| (left..=right).map(move |x| y * width + x))
            .map(|at| if changed(&at) { indices[at] } else { AS_BEFORE })
            .collect::<Vec<u8>>();
        self.due += 100.0 * seconds;
        let delay = (self.due - self.given).round();
        self.given += delay;
        self.encoder.write_frame(&Frame {
            left: left as u16,
            top: top as u16,
            width: (right - left + 1) as u16,
            height: (bottom - top + 1) as u16,
            delay: delay as u16,
            dispose: DisposalMethod::Keep,
            transparent: Some(AS_BEFORE),
            buffer: buffer.into(),
            ..Frame::default()
        })?;
        self.shown = indices;
        Ok(())
    }
}
