//! Scenes for all solvers. They are not chaotic within a second or two, so that all solvers converge to the same motion.

use crate::reference::{BEND, Family, Model, Pose, SHEAR, STRETCH, Sheet, Vector, Wind};

pub const GRAVITY: Vector = [0.0, 0.0, -9.81];

/// All three families without damping, N/m.
pub fn springs(stretch: f64, shear: f64, bend: f64) -> Vec<Family> {
    vec![Family::new(STRETCH, stretch), Family::new(SHEAR, shear), Family::new(BEND, bend)]
}

/// A square sheet of 10 m and 1 kg a particle, laid flat and pinned at two corners. It swings down and stretches by 5 %.
pub fn corners(n: usize) -> Model {
    let stretch = 62.5 * (n * n) as f64;
    let sheet = Sheet::new(Pose::Lay, [n, n], [10.0, 10.0]).with_pins(&[(0, 0), (n - 1, 0)]);
    Model {
        families: springs(stretch, stretch / 10.0, stretch / 100.0),
        gravity: GRAVITY,
        drag: 1.0,
        ..Model::new(sheet)
    }
}

/// The sheet of [`corners`] with strong dampers: a vibration loses most of its energy within its period, and the whole sheet sinks slowly.
pub fn syrup(n: usize) -> Model {
    let mut model = corners(n);
    for (family, damping) in model.families.iter_mut().zip([100.0, 30.0, 10.0]) {
        family.damping = damping;
    }
    model
}

/// A square sheet of 1 m and 10 g a particle, pinned along its left side in the wind, with damped links. It stretches by 11 %.
pub fn flag(n: usize, wind: Wind) -> Model {
    let sheet = Sheet::new(Pose::Hang, [n, n], [1.0, 1.0]).with_mass(0.01).with_left_pinned();
    let mut families = springs(300.0, 60.0, 3.0);
    for (family, damping) in families.iter_mut().zip([0.02, 0.01, 0.005]) {
        family.damping = damping;
    }
    Model { families, gravity: GRAVITY, drag: 0.5, wind: Some(wind), ..Model::new(sheet) }
}

/// Wind of the facet model that lifts a [`flag`].
pub const FACETS: Wind = Wind::Facet([4.0, 2.0, -0.5]);

/// Wind of the aerodynamic model that lifts a [`flag`].
pub const BREEZE: Wind = Wind::Aerodynamic { velocity: [4.0, 2.0, -0.5], density: 1.2, drag_coefficient: 1.3 };

/// The same wind in the panel model.
pub const PANELS: Wind = Wind::Panel { velocity: [4.0, 2.0, -0.5], density: 1.2, drag_coefficient: 1.3 };

/// A curtain of 2 m × 1 m with a hem, pinned at its upper corners. Its cells are not square and its masses differ.
pub fn curtain(wind: Option<Wind>) -> Model {
    let sheet = Sheet::new(Pose::Hang, [24, 16], [2.0, 1.0]).with_density(0.2).with_hem(2.0);
    let mut families = springs(400.0, 80.0, 10.0);
    for (family, damping) in families.iter_mut().zip([0.004, 0.002, 0.001]) {
        family.damping = damping;
    }
    let sheet = sheet.with_pins(&[(0, 0), (23, 0)]);
    Model { families, gravity: GRAVITY, drag: 0.5, wind, ..Model::new(sheet) }
}

/// A chain of 32 particles and 1 m that swings down from the horizontal.
pub fn chain() -> Model {
    let sheet = Sheet::new(Pose::Lay, [1, 32], [0.0, 1.0]).with_mass(0.01).with_pins(&[(0, 0)]);
    Model { families: springs(3000.0, 0.0, 5.0), gravity: GRAVITY, drag: 2.0, ..Model::new(sheet) }
}
