//! An animation of a display.

use std::fs::File;
use std::path::Path;

use color_quant::NeuQuant;
use gif::{Encoder, Frame, Repeat};

use crate::gdb::Result;
use crate::pico::{SIDE, picture};

/// A twentieth of a second, in hundredths.
const DELAY: u16 = 5;

/// Writes pictures one after another, forever.
pub(crate) fn save(shots: &[Vec<u16>], path: &Path) -> Result<()> {
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
    for picture in &pictures {
        let indices: Vec<u8> =
            picture.pixels().map(|pixel| quantizer.index_of(&[pixel[0], pixel[1], pixel[2], 255]) as u8).collect();
        let mut frame = Frame::from_indexed_pixels(side, side, indices, None);
        frame.delay = DELAY;
        encoder.write_frame(&frame)?;
    }
    Ok(())
}
