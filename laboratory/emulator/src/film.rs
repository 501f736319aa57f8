//! An animation of a display.

use std::fs::File;
use std::path::Path;

use color_quant::NeuQuant;
use gif::{Encoder, Frame, Repeat};

use crate::Result;
use crate::board::pico::{SIDE, picture};

/// Writes pictures one after another, forever, each as long as it stays on the display, `rate` steps a second.
pub fn save(shots: &[Vec<u16>], steps: &[u32], rate: u32, path: &Path) -> Result<()> {
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
    let hundredths = |step: u32| step * 100 / rate;
    let mut before = 0;
    for (picture, step) in pictures.iter().zip(steps) {
        let indices: Vec<u8> =
            picture.pixels().map(|pixel| quantizer.index_of(&[pixel[0], pixel[1], pixel[2], 255]) as u8).collect();
        let mut frame = Frame::from_indexed_pixels(side, side, indices, None);
        frame.delay = (hundredths(*step) - hundredths(before)) as u16;
        before = *step;
        encoder.write_frame(&frame)?;
    }
    Ok(())
}
