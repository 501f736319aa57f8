//! Where one looks from.

use embedded_graphics::geometry::Size;
use kerchief::Units;
use kerchief::render::{Camera, Orbit, View};

/// The point in the middle of the picture, m.
const TARGET: [f64; 3] = [0.0, 0.0, 0.34];

/// Width over height of a screen that shows the scene from the distance of an eye.
const WIDEST: f64 = 4.0 / 3.0;

/// Where the page looks from at first: degrees, m.
pub const START: Orbit = Orbit::new(28.0, 16.0, 1.9);

/// The camera that looks at sheets of these units.
pub fn camera(eye: &Orbit, units: &Units, screen: Size) -> Camera<f32> {
    // a view has its angle across the shorter side: what is seen across is as much on any screen that is not wider than 4 : 3
    let across = f64::from(screen.width) / f64::from(screen.width.min(screen.height));
    let distance = eye.distance * (WIDEST / across).max(1.0);
    // the eye is a cell away from what it looks at, at least
    let distance = units.length(distance.max(units.cell));
    Camera::new(&View::new(eye.azimuth, eye.elevation).at(units.point(TARGET), distance), screen)
}
