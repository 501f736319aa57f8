//! The race: a sheet of 16 × 16 swings down from two corners, in every number type and by two solvers.

use kerchief::{Lines, Node, Q13, Q24, Scalar, Sheet, Solver, Xpbd, measure};

/// Particles a side.
pub const SIDE: usize = 16;
/// Frames of a sixtieth of a second.
pub const FRAMES: u32 = 60;

/// A sheet of 10 m × 10 m with particles of 1 kg.
const fn sheet<S: Scalar>(substeps: u32) -> Sheet<S, SIDE, SIDE> {
    Sheet::new([10.0, 10.0], 1.0, 1.0 / 60.0, substeps)
}

/// Measures frames and takes the results.
pub trait Judge {
    /// Runs a frame. Returns its cost: instructions or cycles.
    fn frame(&mut self, frame: impl FnOnce()) -> u64;

    /// Takes a result.
    fn result(&mut self, result: Result);
}

/// The result of a solver in a number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Result {
    /// The number type.
    pub number: &'static str,
    /// The solver and its substeps.
    pub solver: &'static str,
    /// The mean cost of a frame, in the judge's unit.
    pub cost: u64,
    /// The largest strain of a stretch link at the end of any frame, in hundredths of a percent.
    pub strain: i32,
    /// The digest of the sheet after the last frame.
    pub digest: u32,
}

/// Runs the race in every number type.
pub fn race(judge: &mut impl Judge) {
    by_both::<f32>(judge);
    by_both::<Q24>(judge);
    by_both::<Q13>(judge);
}

fn by_both<S: Scalar>(judge: &mut impl Judge) {
    let (many, few) = const { (sheet::<S>(8), sheet::<S>(2)) };
    run("XPBD, 8 substeps", &many, Xpbd::new(), judge);
    run("lines, 2 substeps", &few, Lines::with_sweeps(1), judge);
}

#[inline(never)]
fn run<S: Scalar, V: Solver<S>>(name: &'static str, sheet: &Sheet<S, SIDE, SIDE>, solver: V, judge: &mut impl Judge) {
    let links = (sheet.stretch(942_700.0), sheet.shear(9_427.0));
    let scene = sheet.scene(sheet.gravity([0.0, 0.0, -9.81]), links, (), solver);
    let mut cloth = sheet.hang([0.0; 3]);
    [0, SIDE - 1].into_iter().for_each(|column| cloth.pin(Node::new(column, 0)));
    let mut memory = scene.memory();
    let (mut cost, mut strain) = (0, 0);
    for _ in 0..FRAMES {
        cost += judge.frame(|| scene.step(&mut cloth, &mut memory));
        strain = strain.max(measure::strain(&cloth, &scene.links.0).largest.round_times(10_000));
    }
    let digest = measure::digest(&cloth);
    judge.result(Result { number: S::NAME, solver: name, cost: cost / u64::from(FRAMES), strain, digest });
}
