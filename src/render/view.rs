//! The description of a camera: direction, distance and field of view, evaluated at compile time.

use core::f64::consts::PI;

use embedded_graphics::geometry::Size;

use crate::scalar::fit::is_finite;
use crate::units::{Length, Point};

/// The direction, distance and field of view of a camera, in cells and degrees.
///
/// At azimuth 0° the camera looks along y, with x to the right; at 90° it stands on the side of positive x. At elevation 90° it looks straight down.
///
/// Every method is a `const fn`: a constant view costs firmware 80 bytes of flash and no float routine.
///
/// ```
/// use embedded_graphics::geometry::Size;
/// use kerchief::{Units, render::View};
///
/// const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
/// const SCREEN: Size = Size::new(240, 240);
/// const VIEW: View = View::new(30.0, 20.0).fit(UNITS.point([0.0, -0.2, 0.0]), UNITS.point([0.3, 0.2, 0.3]), SCREEN);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The point in the middle of the picture, cells.
    pub(super) target: [f64; 3],
    /// The distance from the eye to the target, cells.
    pub(crate) distance: f64,
    /// (sin, cos)
    pub(super) azimuth: (f64, f64),
    /// (sin, cos)
    pub(super) elevation: (f64, f64),
    /// The tangent of half the field of view.
    pub(super) field: f64,
}

/// The margin that a fitted scene leaves free on each side, as a fraction of the screen.
const MARGIN: f64 = 0.04;

impl View {
    /// A view of the origin from this direction (degrees), 50 cells away, with a field of view of 30°.
    ///
    /// # Panics
    /// At compile time in a constant: for an angle that is not finite.
    #[track_caller]
    pub const fn new(azimuth: f64, elevation: f64) -> Self {
        assert!(is_finite(azimuth) && is_finite(elevation), "a direction's angles are finite");
        Self { target: [0.0; 3], distance: 50.0, azimuth: sin_cos(azimuth), elevation: sin_cos(elevation), field: 0.0 }
            .field_of_view(30.0)
    }

    /// Sets the angle (degrees, between 0 and 180) that the shorter side of the screen spans.
    ///
    /// # Panics
    /// At compile time in a constant: for an angle outside of that range.
    #[must_use]
    #[track_caller]
    pub const fn field_of_view(self, degrees: f64) -> Self {
        assert!(degrees > 0.0 && degrees < 180.0, "a field of view lies between 0 and 180 degrees");
        let (sin, cos) = sin_cos(degrees / 2.0);
        Self { field: sin / cos, ..self }
    }

    /// Looks at `target` from `distance` away.
    ///
    /// # Panics
    /// At compile time in a constant: for a distance below one cell, and for a target or distance that is not finite.
    #[must_use]
    #[track_caller]
    pub const fn at(self, target: Point, distance: Length) -> Self {
        let [x, y, z] = target.0;
        assert!(is_finite(x) && is_finite(y) && is_finite(z), "a place that is looked at is finite");
        assert!(distance.0 >= 1.0 && is_finite(distance.0), "the eye is at least one cell away from its target");
        self.from(target, distance)
    }

    /// As [`at`](Self::at), without its checks: a fitted box may have any extent, such as that of a sheet that has exploded.
    const fn from(self, target: Point, distance: Length) -> Self {
        Self { target: target.0, distance: distance.0, ..self }
    }

    /// Moves the camera as near as possible while the whole box from `low` to `high` stays on a screen of this size, with a margin of
    /// 4 % of the screen on each side.
    ///
    /// # Panics
    /// At compile time in a constant: for a screen whose width or height is zero.
    #[must_use]
    #[track_caller]
    pub const fn fit(self, low: Point, high: Point, screen: Size) -> Self {
        assert!(screen.width > 0 && screen.height > 0, "a screen has a pixel at least");
        let shorter = if screen.width < screen.height { screen.width } else { screen.height } as f64;
        let slopes = [
            self.field * (1.0 - 2.0 * MARGIN) * screen.width as f64 / shorter,
            self.field * (1.0 - 2.0 * MARGIN) * screen.height as f64 / shorter,
        ];
        let [right, up, forward] = self.axes();
        let middle = [0.5 * (low.0[0] + high.0[0]), 0.5 * (low.0[1] + high.0[1]), 0.5 * (low.0[2] + high.0[2])];
        // A corner (x, y, z) is inside if |x − x₀| ≤ slope·(z + distance). The largest x − slope·z and the largest −x − slope·z of all
        // corners give both unknowns: their sum is 2·slope·distance, their difference 2·x₀.
        let mut most = [[f64::MIN; 2]; 2];
        let mut corner = 0;
        while corner < 8 {
            let place = [
                if corner & 1 == 0 { low.0[0] } else { high.0[0] } - middle[0],
                if corner & 2 == 0 { low.0[1] } else { high.0[1] } - middle[1],
                if corner & 4 == 0 { low.0[2] } else { high.0[2] } - middle[2],
            ];
            let z = dot(forward, place);
            let across = [dot(right, place), dot(up, place)];
            let mut side = 0;
            while side < 2 {
                most[side][0] = most[side][0].max(across[side] - slopes[side] * z);
                most[side][1] = most[side][1].max(-across[side] - slopes[side] * z);
                side += 1;
            }
            corner += 1;
        }
        let distance =
            ((most[0][0] + most[0][1]) / (2.0 * slopes[0])).max((most[1][0] + most[1][1]) / (2.0 * slopes[1]));
        let shift = [0.5 * (most[0][0] - most[0][1]), 0.5 * (most[1][0] - most[1][1])];
        let target = [
            middle[0] + shift[0] * right[0] + shift[1] * up[0],
            middle[1] + shift[0] * right[1] + shift[1] * up[1],
            middle[2] + shift[0] * right[2] + shift[1] * up[2],
        ];
        self.from(Point(target), Length(distance.max(1.0)))
    }

    /// A view of the same target from the direction and distance of `orbit`, at least one cell away.
    #[cfg(feature = "std")]
    pub(crate) fn seen_from(self, orbit: &super::Orbit) -> Self {
        let Self { azimuth, elevation, .. } = Self::new(orbit.azimuth, orbit.elevation);
        Self { azimuth, elevation, distance: orbit.distance.max(1.0), ..self }
    }

    /// The unit vectors of the eye: right, up and forward.
    const fn axes(&self) -> [[f64; 3]; 3] {
        let (sa, ca) = self.azimuth;
        let (se, ce) = self.elevation;
        [[ca, sa, 0.0], [-sa * se, ca * se, ce], [-sa * ce, ca * ce, -se]]
    }
}

const fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// Sine and cosine by their series within 45° of a multiple of 90°. The functions of the standard library are not `const fn`.
pub(super) const fn sin_cos(degrees: f64) -> (f64, f64) {
    let mut rest = degrees % 360.0;
    let mut quarters = 0_i32;
    while rest > 45.0 {
        rest -= 90.0;
        quarters += 1;
    }
    while rest < -45.0 {
        rest += 90.0;
        quarters -= 1;
    }
    let x = rest * (PI / 180.0);
    let (mut sin, mut cos) = (0.0, 0.0);
    let mut term = 1.0;
    let mut k = 0;
    while k < 20 {
        if k % 2 == 0 {
            cos += term;
        } else {
            sin += term;
            term = -term;
        }
        k += 1;
        term *= x / k as f64;
    }
    match quarters.rem_euclid(4) {
        0 => (sin, cos),
        1 => (cos, -sin),
        2 => (-sin, -cos),
        _ => (-cos, sin),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_agree_with_the_standard_library() {
        let mut degrees = -1000.0;
        while degrees < 1000.0 {
            let (sin, cos) = sin_cos(degrees);
            let radians = degrees * PI / 180.0;
            assert!((sin - libm::sin(radians)).abs() < 1e-14 * 20.0, "sin {degrees}");
            assert!((cos - libm::cos(radians)).abs() < 1e-14 * 20.0, "cos {degrees}");
            degrees += 7.3;
        }
        assert_eq!(sin_cos(90.0), (1.0, 0.0));
    }

    #[test]
    fn a_fitted_box_touches_the_margin_and_stays_inside() {
        let (low, high) = (Point([-3.0, 0.0, -7.0]), Point([12.0, 9.0, 1.0]));
        for screen in [Size::new(240, 240), Size::new(128, 64), Size::new(100, 300)] {
            for (azimuth, elevation) in [(0.0, 0.0), (30.0, 20.0), (215.0, 60.0), (90.0, 90.0)] {
                let view = View::new(azimuth, elevation).fit(low, high, screen);
                let [right, up, forward] = view.axes();
                let shorter = screen.width.min(screen.height) as f64;
                let mut largest = 0.0_f64;
                for corner in 0..8 {
                    let place =
                        [0, 1, 2].map(|k| if corner >> k & 1 == 0 { low.0[k] } else { high.0[k] } - view.target[k]);
                    let depth = dot(forward, place) + view.distance;
                    let half = view.field * depth / shorter;
                    largest = largest.max((dot(right, place) / (half * screen.width as f64)).abs());
                    largest = largest.max((dot(up, place) / (half * screen.height as f64)).abs());
                }
                assert!((largest - 0.92).abs() < 1e-12, "{screen:?} {azimuth} {elevation}: {largest}");
            }
        }
    }
}
