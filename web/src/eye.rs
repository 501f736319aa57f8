//! The camera of the page.

use embedded_graphics::geometry::Size;
use kerchief::Units;
use kerchief::render::{Camera, Orbit, View};

/// The point in the middle of the picture, m.
const TARGET: [f64; 3] = [0.0, 0.0, 0.34];

/// The largest ratio of width to height at which the camera stays at the eye's distance; on wider screens it comes nearer.
const WIDEST: f64 = 4.0 / 3.0;

/// The first position of the eye: azimuth and elevation (degrees), distance (m).
pub const START: Orbit = Orbit::new(28.0, 16.0, 1.9);

/// The camera for sheets of these units.
pub fn camera(eye: &Orbit, units: &Units, screen: Size) -> Camera<f32> {
    // A view has its angle across the shorter side. This factor keeps the visible width of the scene equal on all screens up to 4 : 3.
    let across = f64::from(screen.width) / f64::from(screen.width.min(screen.height));
    let distance = eye.distance * (WIDEST / across).max(1.0);
    // The eye is at least one cell away from its target.
    let distance = units.length(distance.max(units.cell));
    Camera::new(&View::new(eye.azimuth, eye.elevation).at(units.point(TARGET), distance), screen)
}
