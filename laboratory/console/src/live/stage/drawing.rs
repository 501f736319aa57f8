//! Drawing of the stage.

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::{Circle, Primitive, PrimitiveStyle};

use super::super::caption::{Caption, PICTURE};
use super::super::strain::percent;
use super::Stage;

/// Colour of the mark on the grabbed particle.
pub(super) const HAND: Rgb888 = Rgb888::new(232, 163, 61);
const HAND_SIZE: u32 = 9;

impl Stage<'_> {
    /// Draws the whole window; the caption has the `rate` of pictures a second.
    pub fn draw<D: DrawTarget<Color = Rgb888>>(&self, rate: Option<f64>, target: &mut D) -> Result<(), D::Error> {
        let still = self.simulation.still();
        let mut picture = target.cropped(&PICTURE);
        self.painter.draw(&still, &mut picture)?;
        if let Some(held) = self.pressed.and_then(|pressed| pressed.held) {
            let place = still.positions[held.node.row * self.scene.sheet.columns + held.node.column];
            if let Some(at) = self.painter.pixel(place) {
                Circle::with_center(at, HAND_SIZE).into_styled(PrimitiveStyle::with_fill(HAND)).draw(&mut picture)?;
            }
        }
        self.caption(rate).draw(target)
    }

    pub(super) fn caption(&self, rate: Option<f64>) -> Caption {
        let solver = &self.scene.solver;
        let [right, into] = self.weather.tilt;
        let state = format!(
            "{} in {}, {} substeps   wind {}   tilt {right:+.0} {into:+.0}{}",
            solver.kind.name(),
            self.scalar.name(),
            solver.substeps,
            if self.weather.windy { "on" } else { "off" },
            if self.paused { "   paused" } else { "" },
        );
        let measured = format!(
            "{} pictures a second   stretch strain {}, {} at most since the start",
            rate.map_or("-".to_string(), |rate| format!("{rate:.0}")),
            percent(self.strain.now),
            percent(self.strain.most),
        );
        let finite = if self.simulation.is_finite() { "" } else { "not finite any more: r starts again" };
        let complaint = if self.complaint.is_empty() { finite } else { &self.complaint };
        Caption { state: [state, measured], complaint: complaint.to_string() }
    }
}
