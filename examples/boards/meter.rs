//! Where the time of a picture goes.

use core::convert::Infallible;

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Dimensions;
use embedded_graphics::primitives::Rectangle;

use crate::clock::Clock;

/// Cycles of the parts of a picture, summed over pictures.
#[derive(Debug, Default)]
pub(crate) struct Meter {
    /// The sheet is moved.
    pub(crate) simulate: u32,
    /// Faces are put in order.
    pub(crate) sort: u32,
    /// The last picture is erased, faces are lit and filled.
    pub(crate) fill: u32,
    /// The picture goes to the display.
    pub(crate) transfer: u32,
    /// Pictures since the last line of the log.
    pub(crate) pictures: u32,
}

impl Meter {
    /// Logs the means, and starts anew.
    pub(crate) fn log(&mut self, step: u32, dropped: u32, digest: u32) {
        let Self { simulate, sort, fill, transfer, pictures } = core::mem::take(self);
        let mean = |cycles: u32| cycles / pictures.max(1);
        defmt::info!(
            "step {=u32}, digest {=u32:08x}, pictures {=u32}, dropped {=u32}, cycles {=u32} {=u32} {=u32} {=u32}",
            step,
            digest,
            pictures,
            dropped,
            mean(simulate),
            mean(sort),
            mean(fill),
            mean(transfer)
        );
    }
}

/// A target that notes when something is drawn on it for the first time: before that, faces are put in order.
pub(crate) struct Lap<'a, D> {
    target: &'a mut D,
    clock: &'a Clock,
    /// Cycles at the first drawing.
    pub(crate) first: Option<u32>,
}

impl<'a, D> Lap<'a, D> {
    pub(crate) fn new(target: &'a mut D, clock: &'a Clock) -> Self {
        Self { target, clock, first: None }
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

    fn fill_solid(&mut self, area: &Rectangle, color: D::Color) -> Result<(), Infallible> {
        self.note();
        self.target.fill_solid(area, color)
    }
}
