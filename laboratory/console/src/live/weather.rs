//! Wind and gravity as the keys have changed them.

use kerchief::host::{Description, Wind, WindModel};

/// The rotation of gravity by a key, degrees.
const TILT: f64 = 5.0;
/// The wind of a scene that has none of its own: components to the right, into the picture and up, m/s.
const BREEZE: [f64; 3] = [3.0, 2.0, 0.0];

#[derive(Clone, Copy, Debug)]
pub(super) struct Weather {
    pub(super) windy: bool,
    /// Inclination of gravity to the right and into the picture, degrees.
    pub(super) tilt: [f64; 2],
}

impl Weather {
    /// Wind and gravity of the scene.
    pub(super) fn of(scene: &Description) -> Self {
        Self { windy: scene.wind.is_some(), tilt: [0.0; 2] }
    }

    /// Turns gravity by `keys` key presses, to the right (axis 0) or into the picture (axis 1).
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
        // Without a tilt, gravity is the scene's own vector.
        if self.tilt == [0.0; 2] { [x, y, z] } else { [tilt[0], tilt[1], -pull * cx * cy] }
    }
}

/// A vector from components to the right, into the scene's picture and up.
fn picture(scene: &Description, [right, into, up]: [f64; 3]) -> [f64; 3] {
    let (sin, cos) = scene.picture.azimuth.to_radians().sin_cos();
    [right * cos - into * sin, right * sin + into * cos, up]
}
