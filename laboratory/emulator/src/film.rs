//! An animation of a display.

use std::fs::File;
use std::path::Path;

use color_quant::NeuQuant;
use gif::{Encoder, Frame, Repeat};
use image::RgbImage;

use crate::Result;
use crate::board::lcd::SIDE;

/// Writes an endless animation. Each picture comes with the step that it shows; `rate` is the number of steps in a second. The last picture stays for `last` steps.
pub fn save(pictures: &[(u32, RgbImage)], last: u32, rate: u32, path: &Path) -> Result<()> {
    let sample: Vec<u8> = pictures
        .iter()
        .step_by(8)
        .flat_map(|(_, picture)| picture.pixels().flat_map(|pixel| [pixel[0], pixel[1], pixel[2], 255]))
        .collect();
    // one palette for all pictures, so that colours don't flicker
    let quantizer = NeuQuant::new(10, 256, &sample);
    let side = SIDE as u16;
    let mut encoder = Encoder::new(File::create(path)?, side, side, &quantizer.color_map_rgb())?;
    encoder.set_repeat(Repeat::Infinite)?;
    let hundredths = |step: u32| step * 100 / rate;
    for (k, (step, picture)) in pictures.iter().enumerate() {
        let indices: Vec<u8> =
            picture.pixels().map(|pixel| quantizer.index_of(&[pixel[0], pixel[1], pixel[2], 255]) as u8).collect();
        let mut frame = Frame::from_indexed_pixels(side, side, indices, None);
        let next = pictures.get(k + 1).map_or(step + last, |(next, _)| *next);
        frame.delay = (hundredths(next) - hundredths(*step)) as u16;
        encoder.write_frame(&frame)?;
    }
    Ok(())
}
