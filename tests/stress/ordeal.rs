//! Ordeals of a sheet: a disturbance, with bounds on the sheet during and after it.

use std::fmt::Write;

use kerchief::{BackwardEuler, Lines, Q13, Q24, Scalar, Solver, Verlet, Xpbd, measure};

use crate::is_long;
use crate::stage::{DOWN, Sheet, Stage};

/// A disturbance of a sheet for some frames, and the calm after it.
pub(crate) trait Ordeal {
    fn sheet(&self) -> Sheet;
    /// How many frames the disturbance lasts.
    fn frames(&self) -> u32;
    /// Called before the first frame.
    fn begin<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, _stage: &mut Stage<S, V, W, H>) {}
    /// Called before each frame.
    fn disturb<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(
        &self,
        _stage: &mut Stage<S, V, W, H>,
        _frame: u32,
    ) {
    }
    /// Called after the last frame.
    fn end<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, _stage: &mut Stage<S, V, W, H>) {}
    /// The largest coordinate that is allowed in any frame, sheet sizes from the origin.
    fn bounds(&self) -> f64 {
        3.0
    }
    /// The length of the calm, s.
    fn calm(&self) -> f64 {
        6.0
    }
    /// The bound on the speed at the end, sizes a second. The speed is a root mean square over the last frames, since at one moment a trembling sheet is slow or fast by chance.
    fn still(&self) -> f64 {
        0.02
    }
    /// The bound on the strain of stretch links at the end.
    fn left(&self) -> f64 {
        0.2
    }
}

/// The last frames of the calm, over which speeds are averaged.
const LAST: u32 = 10;

fn run<S: Scalar, V: Solver<S> + Copy, const W: usize, const H: usize>(
    ordeal: &impl Ordeal,
    solver: V,
) -> Result<u32, String> {
    let sheet = ordeal.sheet();
    let mut stage = Stage::<S, V, W, H>::new(&sheet, solver);
    ordeal.begin(&mut stage);
    let bounded = |stage: &Stage<S, V, W, H>, when: &str, frame| {
        let reach = stage.reach() / sheet.size;
        let fine = measure::is_finite(&stage.cloth) && reach < ordeal.bounds();
        if fine { Ok(()) } else { Err(format!("reaches {reach:.1} sizes in {when} {frame}")) }
    };
    for frame in 0..ordeal.frames() {
        ordeal.disturb(&mut stage, frame);
        stage.step();
        bounded(&stage, "frame", frame)?;
    }
    ordeal.end(&mut stage);
    stage.gravity(DOWN);
    stage.drag(5.0);
    let calm = (ordeal.calm() / sheet.frame).ceil() as u32;
    let mut squares = 0.0;
    for frame in 0..calm {
        stage.step();
        bounded(&stage, "calm frame", frame)?;
        if frame + LAST >= calm {
            squares += (stage.speed() / sheet.size).powi(2);
        }
    }
    let (speed, strain) = ((squares / f64::from(LAST)).sqrt(), stage.strain());
    // q13 resolves the lengths of links to 2⁻¹³ cells, which in a short step of a stiff sheet appears as a speed
    let measured = if S::NAME == Q13::NAME {
        64.0 / 8192.0 / (W - 1) as f64 / (sheet.frame / f64::from(sheet.substeps))
    } else {
        0.0
    };
    if !(speed < ordeal.still().max(measured) && strain < ordeal.left()) {
        return Err(format!("left with {speed:.1e} sizes a second, strain {strain:.1e}"));
    }
    Ok(measure::digest(&stage.cloth))
}

/// The failures so far, one a line.
#[derive(Debug, Default)]
pub(crate) struct Complaints(String);

impl Complaints {
    pub(crate) fn note(&mut self, who: &str, result: Result<u32, String>) {
        if let Err(what) = result {
            let _ = write!(self.0, "\n{who}: {what}");
        }
    }

    pub(crate) fn assert_none(&self) {
        assert!(self.0.is_empty(), "{}", self.0);
    }
}

/// The line solver in a number type; in the long version twice, to the same bits.
pub(crate) fn default_in<S: Scalar, const W: usize, const H: usize>(
    complaints: &mut Complaints,
    what: &str,
    ordeal: &impl Ordeal,
) {
    let run = || run::<S, Lines, W, H>(ordeal, Lines::new());
    let same = |first| !is_long() || run() == Ok(first);
    let result = run().and_then(|first| if same(first) { Ok(first) } else { Err("not the same twice".into()) });
    complaints.note(&format!("{what}, {W} x {H}, lines in {}", S::NAME), result);
}

/// The line solver in every number type.
pub(crate) fn default_solver<const W: usize, const H: usize>(
    complaints: &mut Complaints,
    what: &str,
    ordeal: &impl Ordeal,
) {
    default_in::<f32, W, H>(complaints, what, ordeal);
    default_in::<f64, W, H>(complaints, what, ordeal);
    default_in::<Q24, W, H>(complaints, what, ordeal);
    default_in::<Q13, W, H>(complaints, what, ordeal);
}

/// The other solvers that are stable for any step, in every number type.
pub(crate) fn other_solvers<const W: usize, const H: usize>(
    complaints: &mut Complaints,
    what: &str,
    ordeal: &impl Ordeal,
) {
    fn each<S: Scalar, const W: usize, const H: usize>(complaints: &mut Complaints, what: &str, ordeal: &impl Ordeal) {
        let who = |solver: &str| format!("{what}, {W} x {H}, {solver} in {}", S::NAME);
        complaints.note(&who("xpbd"), run::<S, _, W, H>(ordeal, Xpbd));
        complaints.note(&who("verlet"), run::<S, _, W, H>(ordeal, Verlet { sweeps: 4 }));
        complaints.note(&who("backward Euler"), run::<S, _, W, H>(ordeal, BackwardEuler { newton_steps: 2 }));
    }
    each::<f32, W, H>(complaints, what, ordeal);
    each::<f64, W, H>(complaints, what, ordeal);
    each::<Q24, W, H>(complaints, what, ordeal);
    each::<Q13, W, H>(complaints, what, ordeal);
}

/// All solvers, and the line solver on a larger grid.
pub(crate) fn all(what: &str, ordeal: &impl Ordeal) {
    let mut complaints = Complaints::default();
    default_solver::<8, 8>(&mut complaints, what, ordeal);
    let larger = run::<f32, Lines, 16, 16>(ordeal, Lines::new());
    complaints.note(&format!("{what}, 16 x 16, lines in f32"), larger);
    let larger = run::<Q24, Lines, 16, 16>(ordeal, Lines::new());
    complaints.note(&format!("{what}, 16 x 16, lines in q24"), larger);
    other_solvers::<8, 8>(&mut complaints, what, ordeal);
    complaints.assert_none();
}
