//! An outsider's force: a harmonic trap, `a = −ω²·x`.

use std::f64::consts::TAU;

use kerchief::force::{Force, Row};
use kerchief::{Cloth, Leapfrog, Q24, Scalar, Scene, Units, Vec3};

struct Trap<S> {
    /// The velocity gained in a substep (cells per tick) at a distance of one cell.
    gain: S,
}

impl<S: Scalar> Trap<S> {
    /// `angular_frequency` in 1/s.
    fn new(units: &Units, angular_frequency: f64) -> Self {
        Self { gain: S::from_f64(angular_frequency * angular_frequency * units.substep() * units.tick()) }
    }
}

impl<S: Scalar> Force<S> for Trap<S> {
    #[inline]
    fn is_field(&self) -> bool {
        true
    }

    fn particles<const W: usize>(&self, row: Row<'_, S, W>, gain: &mut Vec3<[S; W]>) {
        for column in 0..W {
            gain.add(column, -(row.position.at(column) * self.gain));
        }
    }
}

/// Particles without links are independent oscillators: mirrored at the origin after half a period, back after a whole one.
fn particles_return_after_a_period<S: Scalar>(bound: f64) {
    const FRAMES: u32 = 40;
    let units = Units::sheet([4, 3], [0.3, 0.2], 1e-3, 0.01, 8);
    let start = Cloth::<S, 4, 3>::lay(&units, units.point([0.1, -0.4, 0.2]));
    let mut cloth = start;
    let trap = Trap::new(&units, TAU / (f64::from(FRAMES) * units.frame));
    let scene = Scene::new(&units, trap, (), (), Leapfrog);
    let mut memory = scene.memory();
    let mut worst: f64 = 0.0;
    for sign in [-1.0, 1.0] {
        for _ in 0..FRAMES / 2 {
            scene.step(&mut cloth, &mut memory);
        }
        for (now, then) in cloth.position.values().zip(start.position.values()) {
            let [now, then] = [now, then].map(Vec3::to_f64);
            (0..3).for_each(|k| worst = worst.max((now[k] - sign * then[k]).abs()));
        }
    }
    assert!(worst < bound, "{} cells off in {}", worst, S::NAME);
}

#[test]
fn a_force_of_ones_own_has_its_period() {
    particles_return_after_a_period::<f64>(1e-6);
    particles_return_after_a_period::<f32>(1e-5);
    particles_return_after_a_period::<Q24>(1e-5);
}
