//! Wind and gravity, as keys have them.

use kerchief::host::{Description, Wind, WindModel};

/// A key turns gravity by so much, degrees.
const TILT: f64 = 5.0;
/// The wind of a scene without: to the right of, into and up in the picture, m/s.
const BREEZE: [f64; 3] = [3.0, 2.0, 0.0];

#[derive(Clone, Copy, Debug)]
pub(super) struct Weather {
    pub(super) windy: bool,
    /// Gravity turned about the picture's axes into and across it, degrees.
    pub(super) tilt: [f64; 2],
}

impl Weather {
    /// A scene's own.
    pub(super) fn of(scene: &Description) -> Self {
        Self { windy: scene.wind.is_some(), tilt: [0.0; 2] }
    }

    /// Turns gravity by a key, to the right or into the picture.
    pub(super) fn turn(&mut self, axis: usize, keys: f64) {
        self.tilt[axis] = (self.tilt[axis] + keys * TILT).clamp(-90.0, 90.0);
    }

    pub(super) fn wind(&self, scene: &Description) -> Option<Wind> {
        let model = WindModel::Aerodynamic { density: 1.2, drag_coefficient: 1.2 };
        let breeze = || Wind { velocity: picture(scene, BREEZE), model };
        self.windy.then(|| scene.wind.unwrap_or_else(breeze))
    }

    pub(super) fn gravity(&self, scene: &Description) -> [f64; 3] {
        let [[sx, cx], [sy, cy]] = self.tilt.map(|degrees| [degrees.to_radians().sin(), degrees.to_radians().cos()]);
        let [x, y, z] = scene.gravity;
        let pull = (x * x + y * y + z * z).sqrt();
        let tilt = picture(scene, [pull * sx * cy, pull * sy, 0.0]);
        // Upright, gravity is the scene's own.
        if self.tilt == [0.0; 2] { [x, y, z] } else { [tilt[0], tilt[1], -pull * cx * cy] }
    }
}

/// A level vector to the right of, into, and up in the scene's picture.
fn picture(scene: &Description, [right, into, up]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = scene.picture.azimuth.to_radians().sin_cos();
    [right * cos - into * sin, right * sin + into * cos, up]
}
