//! A view direction that a pointer turns and zooms.

/// The direction and the distance of a [`View`](super::View), turned and zoomed by a pointer.
///
/// Elevations stay between 2° and 88°: the picture never flips, and a floor is seen from above. Distances stay between 0.4 and 3.2 times the initial one. An initial elevation
/// outside of these bounds widens them to include it.
///
/// ```
/// use kerchief::render::Orbit;
///
/// let mut orbit = Orbit::new(30.0, 20.0, 60.0);
/// orbit.drag(-50.0, 10.0); // the scene follows the pointer
/// assert_eq!((orbit.azimuth, orbit.elevation), (50.0, 24.0));
/// orbit.zoom(2.0);
/// assert_eq!(orbit.distance, 30.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    /// Degrees, as in [`View::new`](super::View::new).
    pub azimuth: f64,
    /// Degrees.
    pub elevation: f64,
    /// The distance from the eye to its target, in any unit.
    pub distance: f64,
    /// The bounds of the elevation, and below of the distance.
    elevations: [f64; 2],
    distances: [f64; 2],
}

const ELEVATIONS: [f64; 2] = [2.0, 88.0];
/// In initial distances.
const DISTANCES: [f64; 2] = [0.4, 3.2];
const DEGREES_A_PIXEL: f64 = 0.4;

impl Orbit {
    /// An orbit with this initial direction (degrees) and distance.
    pub const fn new(azimuth: f64, elevation: f64, distance: f64) -> Self {
        let elevations = [ELEVATIONS[0].min(elevation), ELEVATIONS[1].max(elevation)];
        let distances = [DISTANCES[0] * distance, DISTANCES[1] * distance];
        Self { azimuth, elevation, distance, elevations, distances }
    }

    /// Turns the scene by a pointer's displacement, pixels.
    pub fn drag(&mut self, right: f64, down: f64) {
        self.turn(right * DEGREES_A_PIXEL, down * DEGREES_A_PIXEL);
    }

    /// Turns the scene to the right, and raises the eye, by degrees.
    pub fn turn(&mut self, right: f64, up: f64) {
        // kept from -180 to 180, so that the angle keeps its precision
        self.azimuth = ((self.azimuth - right) % 360.0 + 540.0) % 360.0 - 180.0;
        self.elevation = (self.elevation + up).clamp(self.elevations[0], self.elevations[1]);
    }

    /// Divides the distance by `factor` (`factor > 0`).
    pub fn zoom(&mut self, factor: f64) {
        self.distance = (self.distance / factor).clamp(self.distances[0], self.distances[1]);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn turns_stay_within_a_circle_and_never_flip() {
        let mut orbit = Orbit::new(170.0, 20.0, 1.0);
        orbit.turn(-30.0, 0.0);
        assert_eq!(orbit.azimuth, -160.0);
        orbit.turn(2000.0, 0.0);
        assert!((-180.0..180.0).contains(&orbit.azimuth), "{}", orbit.azimuth);
        for (pixels, elevation) in [(1000.0, 88.0), (-1000.0, 2.0)] {
            orbit.drag(0.0, pixels);
            assert_eq!(orbit.elevation, elevation);
        }
    }

    #[test]
    fn a_first_elevation_out_of_bounds_may_stay() {
        for elevation in [-40.0, 0.0, 90.0] {
            let mut orbit = Orbit::new(0.0, elevation, 1.0);
            orbit.turn(10.0, 0.0);
            assert_eq!(orbit.elevation, elevation);
        }
    }

    #[test]
    fn zooms_end() {
        let mut orbit = Orbit::new(0.0, 0.0, 10.0);
        orbit.zoom(1e9);
        assert_eq!(orbit.distance, 4.0);
        orbit.zoom(1e-9);
        assert_eq!(orbit.distance, 32.0);
    }
}
