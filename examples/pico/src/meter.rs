//! Cycles of the stages of a picture.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::primitives::Rectangle;

use crate::clock::Clock;

/// Cycles of each stage, summed over pictures.
#[derive(Debug, Default)]
pub(crate) struct Meter {
    /// Moving the sheet.
    pub(crate) simulate: u32,
    /// Sorting faces.
    pub(crate) sort: u32,
    /// Erasing the last picture, lighting and filling faces.
    pub(crate) fill: u32,
    /// Sending the picture to the display.
    pub(crate) transfer: u32,
    /// Pictures since the last line of the log.
    pub(crate) pictures: u32,
}

impl Meter {
    /// Adds a picture: the clock's cycles at its start, after moving the sheet, after drawing and after sending, and the cycles of sorting faces.
    pub(crate) fn add(&mut self, [start, simulated, drawn, sent]: [u32; 4], sort: u32) {
        self.simulate += simulated.wrapping_sub(start);
        self.sort += sort;
        self.fill += drawn.wrapping_sub(simulated) - sort;
        self.transfer += sent.wrapping_sub(drawn);
        self.pictures += 1;
    }

    /// Pictures a second over the last `gone` cycles, at `frequency` Hz.
    pub(crate) fn rate(&self, frequency: u32, gone: u32) -> u32 {
        ((u64::from(self.pictures) * u64::from(frequency) + u64::from(gone / 2)) / u64::from(gone.max(1))) as u32
    }

    /// Logs the means and resets all sums. `rate` is in pictures a second.
    pub(crate) fn log(&mut self, step: u32, rate: u32, dropped: u32, digest: u32) {
        let Self { simulate, sort, fill, transfer, pictures } = core::mem::take(self);
        let mean = |cycles: u32| cycles / pictures.max(1);
        defmt::info!(
            "step {=u32}, digest {=u32:08x}, pictures {=u32}, rate {=u32}, dropped {=u32}, cycles {=u32} {=u32} {=u32} {=u32}",
            step,
            digest,
            pictures,
            rate,
            dropped,
            mean(simulate),
            mean(sort),
            mean(fill),
            mean(transfer)
        );
    }
}

/// A target that records when it is first drawn on. Until then, faces are sorted.
pub(crate) struct Lap<'a, D> {
    target: &'a mut D,
    clock: &'a Clock,
    /// The clock's cycles at the first drawing.
    first: Option<u32>,
}

impl<'a, D> Lap<'a, D> {
    /// Draws on a target. Returns the cycles of sorting faces.
    pub(crate) fn time(
        target: &'a mut D,
        clock: &'a Clock,
        draw: impl FnOnce(&mut Self) -> Result<(), Infallible>,
    ) -> u32 {
        let start = clock.cycles();
        let mut lap = Self { target, clock, first: None };
        let Ok(()) = draw(&mut lap);
        lap.first.map_or(0, |first| first.wrapping_sub(start))
    }

    fn note(&mut self) {
        if self.first.is_none() {
            self.first = Some(self.clock.cycles());
        }
    }
}

impl<D: Dimensions> Dimensions for Lap<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.target.bounding_box()
    }
}

impl<D: DrawTarget<Error = Infallible>> DrawTarget for Lap<'_, D> {
    type Color = D::Color;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<D::Color>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        self.note();
        self.target.draw_iter(pixels)
    }

    fn fill_contiguous<I: IntoIterator<Item = D::Color>>(
        &mut self,
        area: &Rectangle,
        colors: I,
    ) -> Result<(), Infallible> {
        self.note();
        self.target.fill_contiguous(area, colors)
    }

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), Infallible> {
        self.note();
        self.target.fill_solid(area, color)
    }
}

/// An emulator stops here to read the display.
#[inline(never)]
pub(crate) extern "C" fn shown(step: u32) {
    core::hint::black_box(step);
}
