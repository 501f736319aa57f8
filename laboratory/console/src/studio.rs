//! Drawings of a scene as smooth images.

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use image::{RgbImage, imageops};
use kerchief::host::{Bounds, Description, Painter, Still};

/// Pictures are drawn larger by this factor and then reduced, which smooths their edges.
const OVERSIZE: u32 = 3;

/// Makes square images.
#[derive(Debug)]
pub struct Studio<'a> {
    painter: Painter<'a>,
    side: u32,
}

impl<'a> Studio<'a> {
    /// A studio for images of `side` × `side` pixels whose view contains these stills.
    pub fn new<'b>(
        scene: &'a Description,
        stills: impl IntoIterator<Item = &'b Still>,
        side: u32,
    ) -> Result<Self, String> {
        let size = Size::new(side * OVERSIZE, side * OVERSIZE);
        let painter = Painter::new(scene, stills, size).map_err(|error| error.to_string())?;
        Ok(Self { painter, side })
    }

    /// A studio for images of `side` × `side` pixels whose view contains these bounds.
    pub fn within(scene: &'a Description, seen: Bounds, side: u32) -> Result<Self, String> {
        let size = Size::new(side * OVERSIZE, side * OVERSIZE);
        let painter = Painter::within(scene, seen, size).map_err(|error| error.to_string())?;
        Ok(Self { painter, side })
    }

    /// An image of a still.
    pub fn picture(&self, still: &Still) -> RgbImage {
        let size = Size::new(self.side * OVERSIZE, self.side * OVERSIZE);
        let mut display = SimulatorDisplay::with_default_color(size, Rgb888::BLACK);
        let Ok(()) = self.painter.draw(still, &mut display);
        let large = display.to_rgb_output_image(&OutputSettings::default());
        imageops::thumbnail(&large.as_image_buffer(), self.side, self.side)
    }
}
