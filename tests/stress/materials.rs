//! Materials and steps from one end of their range to the other; in the long version more stiffnesses between.

use kerchief::{Lines, Node, Q13, Q24, Scalar, Solver};

use crate::is_long;
use crate::ordeal::{Complaints, Ordeal, default_in, default_solver, other_solvers};
use crate::stage::{CLOTH, Sheet, Stage};

/// A sheet whose particles are kicked in all directions, by up to 3 m/s.
struct Kicked {
    /// N/m
    stretch: f64,
    /// A part of `stretch`.
    shear: f64,
    /// s
    frame: f64,
    substeps: u32,
    /// The largest speed at the end, sheet sizes a second.
    still: f64,
    /// The mass of the particle in the middle, in masses of the others.
    heavy: f64,
}

impl Kicked {
    fn new(stretch: f64, frame: f64) -> Self {
        let substeps = if frame < 0.01 { 1 } else { 8 };
        Self { stretch, shear: 0.1, frame, substeps, still: 0.02, heavy: 1.0 }
    }
}

impl Ordeal for Kicked {
    fn sheet(&self) -> Sheet {
        // soft springs can carry light sheets only
        let mass = f64::min(2e-3, 1e-4 * self.stretch);
        let drag = if self.stretch < 1e3 { 5.0 } else { CLOTH.drag };
        let Self { stretch, frame, substeps, .. } = *self;
        let shear = self.shear * stretch;
        Sheet { mass, stretch, shear, bend: 0.1 * shear, frame, substeps, drag, ..CLOTH }
    }
    fn frames(&self) -> u32 {
        (0.5 / self.frame).ceil() as u32
    }
    fn begin<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>) {
        stage.kick(3.0);
        stage.cloth.inverse_mass[Node::new(W / 2, H / 2)] = S::from_f64(1.0 / self.heavy);
    }
    fn still(&self) -> f64 {
        self.still
    }
    fn left(&self) -> f64 {
        if self.frame > 0.02 && self.heavy > 1.0 { 1.0 } else { 0.3 }
    }
}

const STEPS: [f64; 4] = [1e-3, 1.0 / 60.0, 0.05, 0.2];

#[test]
fn every_stiffness_and_step() {
    let mut complaints = Complaints::default();
    let stiffnesses: &[f64] = if is_long() { &[1e-2, 1.0, 1e2, 1e4, 1e6, 1e8, 1e11] } else { &[1e-2, 1e2, 1e6, 1e11] };
    for &stretch in stiffnesses {
        for frame in STEPS {
            let what = format!("{stretch:e} N/m, frames of {frame:.3} s");
            default_solver::<8, 8>(&mut complaints, &what, &Kicked::new(stretch, frame));
        }
        let what = format!("{stretch:e} N/m");
        // by backward Euler, nearly rigid sheets in fixed point keep such a speed
        other_solvers::<8, 8>(&mut complaints, &what, &Kicked { still: 0.3, ..Kicked::new(stretch, 0.05) });
    }
    complaints.assert_none();
}

#[test]
fn a_particle_a_thousand_times_as_heavy() {
    let mut complaints = Complaints::default();
    for stretch in [1e4, 1e8] {
        for frame in STEPS {
            let what = format!("mass ratio 1000, {stretch:e} N/m, frames of {frame:.3} s");
            let kicked = Kicked { heavy: 1000.0, ..Kicked::new(stretch, frame) };
            // residuals within the tolerance may move that particle's neighbours by tolerance/7 sheet sizes (a cell is 1/7) in a substep
            let still = if frame < 0.01 { Lines::new().tolerance / 7.0 / frame } else { kicked.still };
            let kicked = Kicked { still: still.max(0.03), ..kicked };
            default_in::<f32, 8, 8>(&mut complaints, &what, &kicked);
            default_in::<f64, 8, 8>(&mut complaints, &what, &kicked);
            default_in::<Q24, 8, 8>(&mut complaints, &what, &kicked);
            // where substeps stay split, the errors of q13 in the lengths of links beside such a particle keep a nearly rigid sheet moving
            let still = if stretch > 1e4 { 1.0 } else { still };
            default_in::<Q13, 8, 8>(&mut complaints, &what, &Kicked { still, ..kicked });
        }
    }
    let heavy = Kicked { heavy: 1000.0, ..Kicked::new(1e4, 1.0 / 60.0) };
    other_solvers::<8, 8>(&mut complaints, "mass ratio 1000", &heavy);
    complaints.assert_none();
}

#[test]
fn long_steps_of_stiff_sheets() {
    let mut complaints = Complaints::default();
    for stretch in [1e4, 1e6, 1e8] {
        for frame in [0.05, 0.1, 0.2] {
            for (shear, substeps) in [(1e-3, 4), (1e-3, 8), (0.1, 4)] {
                let what = format!("{stretch:e} N/m, shear {shear} of it, {substeps} substeps of {frame} s");
                let kicked = Kicked { shear, substeps, ..Kicked::new(stretch, frame) };
                default_solver::<8, 8>(&mut complaints, &what, &kicked);
            }
        }
    }
    complaints.assert_none();
}
