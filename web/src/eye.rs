//! Where one looks from.

use embedded_graphics::geometry::Size;
use kerchief::Units;
use kerchief::render::{Camera, View};

/// The point in the middle of the picture, m.
const TARGET: [f64; 3] = [0.0, 0.0, 0.34];

/// Width over height of a screen that shows the scene from [`Eye::distance`].
const WIDEST: f64 = 4.0 / 3.0;

/// A look at the scene.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Eye {
    /// Degrees, as of [`View::new`].
    pub azimuth: f64,
    /// Degrees.
    pub elevation: f64,
    /// From the middle of the scene, m.
    pub distance: f64,
}

impl Eye {
    /// Where the page looks from at first.
    pub const DEFAULT: Self = Self { azimuth: 28.0, elevation: 16.0, distance: 1.9 };

    /// The camera that looks at sheets of these units.
    pub fn camera(&self, units: &Units, screen: Size) -> Camera<f32> {
        // a view has its angle across the shorter side: what is seen across is as much on any screen that is not wider than 4 : 3
        let across = f64::from(screen.width) / f64::from(screen.width.min(screen.height));
        let distance = self.distance * (WIDEST / across).max(1.0);
        // the eye is a cell away from what it looks at, at least
        let distance = units.length(distance.max(units.cell));
        Camera::new(&View::new(self.azimuth, self.elevation).at(units.point(TARGET), distance), screen)
    }
}
