//! An outsider's force: a harmonic trap, `a = −ω²·x`.

use std::f64::consts::TAU;

use kerchief::force::Slowdown;
use kerchief::force::{Force, Row};
use kerchief::{
    BackwardEuler, Cloth, Drag, FacetWind, ForwardEuler, Gravity, Leapfrog, Lines, Node, Q24, Scalar, Scene, Solver,
    Stretch, Units, Vec3, Verlet, Xpbd, measure,
};

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
    fn particles<const W: usize>(&self, row: Row<'_, S, W>, gain: &mut Vec3<[S; W]>) {
        for column in 0..W {
            gain.add(column, -(row.position.at(column) * self.gain));
        }
    }
}

/// Particles without links are independent oscillators: after half a period they are mirrored at the origin, after a whole one they are back.
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

/// The crate's own forces, wrapped: each of these forwards the one method with which it acts, and leaves the others at their defaults.
struct Weight(Gravity<f64>);
struct Brake(Drag<f64>);
struct Cells(FacetWind<f64>);

impl Force<f64> for Weight {
    fn uniform(&self) -> Vec3<f64> {
        self.0.uniform()
    }
}

impl Force<f64> for Brake {
    fn drag(&self) -> Slowdown<f64> {
        self.0.drag()
    }
}

impl Force<f64> for Cells {
    fn cells<const W: usize>(&self, rows: [Row<'_, f64, W>; 2], gains: [&mut Vec3<[f64; W]>; 2]) {
        self.0.cells(rows, gains);
    }
}

/// The digest of a sheet after a second.
fn end<V: Solver<f64>>(forces: impl Force<f64>, solver: V) -> u32 {
    let units = Units::sheet([5, 4], [0.4, 0.3], 1e-3, 0.02, 16);
    let mut cloth = Cloth::<f64, 5, 4>::lay(&units, units.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(4, 0));
    let scene = Scene::new(&units, forces, Stretch::new(&units, units.stiffness(10.0)), (), solver);
    let mut memory = scene.memory();
    (0..50).for_each(|_| scene.step(&mut cloth, &mut memory));
    measure::digest(&cloth)
}

/// Every solver applies every method that a force implements, even if the force does not describe itself.
#[test]
fn a_force_that_says_nothing_of_itself_acts() {
    fn check<V: Solver<f64> + Copy>(solver: V) {
        let units = Units::sheet([5, 4], [0.4, 0.3], 1e-3, 0.02, 16);
        let gravity = Gravity::new(units.acceleration([0.0, 0.0, -9.81]));
        let drag = Drag::new(units.drag(2.0));
        let wind = FacetWind::new(units.facet_wind([0.5, 1.0, 0.2]));
        let own = end((gravity, drag, wind), solver);
        assert_eq!(own, end((Weight(gravity), Brake(drag), Cells(wind)), solver));
        assert_eq!(own, end((Some(Weight(gravity)), (Brake(drag), Cells(wind))), solver));
        assert_ne!(own, end((Weight(gravity), Brake(drag)), solver));
    }
    check(ForwardEuler);
    check(BackwardEuler::new());
    check(Leapfrog);
    check(Verlet::new());
    check(Xpbd);
    check(Lines::new());
}
