//! An animation of a display.

use std::fs::File;
use std::path::Path;

use color_quant::NeuQuant;
use gif::{Encoder, Frame, Repeat};

use crate::Result;
use crate::board::pico::{SIDE, picture};

/// Writes pictures one after another, forever: one for every `stride` steps, of which there are `rate` in a second.
pub fn save(shots: &[Vec<u16>], stride: u32, rate: u32, path: &Path) -> Result<()> {
    let pictures: Vec<_> = shots.iter().map(|shot| picture(shot)).collect();
    let sample: Vec<u8> = pictures
        .iter()
        .step_by(8)
        .flat_map(|picture| picture.pixels().flat_map(|pixel| [pixel[0], pixel[1], pixel[2], 255]))
        .collect();
    // the colours of all pictures, so that none of them flickers
    let quantizer = NeuQuant::new(10, 256, &sample);
    let side = SIDE as u16;
    let mut encoder = Encoder::new(File::create(path)?, side, side, &quantizer.color_map_rgb())?;
    encoder.set_repeat(Repeat::Infinite)?;
    let hundredths = |picture: u32| picture * stride * 100 / rate;
    for (k, picture) in (0..).zip(&pictures) {
        let indices: Vec<u8> =
            picture.pixels().map(|pixel| quantizer.index_of(&[pixel[0], pixel[1], pixel[2], 255]) as u8).collect();
        let mut frame = Frame::from_indexed_pixels(side, side, indices, None);
        frame.delay = (hundredths(k + 1) - hundredths(k)) as u16;
        encoder.write_frame(&frame)?;
    }
    Ok(())
}
