//! What the number types run: a sheet of 16 × 16 that swings down from two corners, by two solvers.

use kerchief::{Cloth, Gravity, Lines, Node, Q13, Q24, Scalar, Scene, Shear, Solver, Stretch, Units, Xpbd, measure};

/// Particles a side.
pub const SIDE: usize = 16;
/// Frames of a sixtieth of a second.
pub const FRAMES: u32 = 60;

/// A sheet of 10 m × 10 m with particles of 1 kg.
const fn units(substeps: u32) -> Units {
    Units::sheet([SIDE, SIDE], [10.0, 10.0], 1.0, 1.0 / 60.0, substeps)
}

/// Who takes the time.
pub trait Judge {
    /// Runs a frame, and says what it cost.
    fn frame(&mut self, frame: impl FnOnce()) -> u64;

    /// Takes a result.
    fn result(&mut self, result: Result);
}

/// How a solver did in a number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Result {
    /// The number type.
    pub number: &'static str,
    /// The solver and its substeps.
    pub solver: &'static str,
    /// What a frame cost, on average.
    pub cost: u64,
    /// The largest strain of a stretch link at the end of any frame, in hundredths of a percent.
    pub strain: i32,
    /// Of the sheet after the last frame.
    pub digest: u32,
}

/// Lets every number type run.
pub fn race(judge: &mut impl Judge) {
    by_both::<f32>(judge);
    by_both::<Q24>(judge);
    by_both::<Q13>(judge);
}

fn by_both<S: Scalar>(judge: &mut impl Judge) {
    const MANY: Units = units(8);
    const FEW: Units = units(2);
    run("XPBD, 8 substeps", &scene::<S, _>(&MANY, Xpbd), &MANY, judge);
    run("lines, 2 substeps", &scene::<S, _>(&FEW, Lines::with_sweeps(1)), &FEW, judge);
}

/// A sheet under its weight.
type Hanging<S, V> = Scene<Gravity<S>, (Stretch<S>, Shear<S>), (), V>;

fn scene<S: Scalar, V>(units: &Units, solver: V) -> Hanging<S, V> {
    let gravity = Gravity::new(units.acceleration([0.0, 0.0, -9.81]));
    let links = (Stretch::new(units, units.stiffness(942_700.0)), Shear::new(units, units.stiffness(9_427.0)));
    Scene::new(units, gravity, links, (), solver)
}

#[inline(never)]
fn run<S: Scalar, V: Solver<S>>(solver: &'static str, scene: &Hanging<S, V>, units: &Units, judge: &mut impl Judge) {
    let mut cloth = Cloth::<S, SIDE, SIDE>::hang(units, units.point([0.0; 3]));
    [0, SIDE - 1].into_iter().for_each(|column| cloth.pin(Node::new(column, 0)));
    let mut memory = scene.memory();
    let (mut cost, mut strain) = (0, 0);
    for _ in 0..FRAMES {
        cost += judge.frame(|| scene.step(&mut cloth, &mut memory));
        strain = strain.max(measure::strain(&cloth, &scene.links.0).largest.round_times(10_000));
    }
    let digest = measure::digest(&cloth);
    judge.result(Result { number: S::NAME, solver, cost: cost / u64::from(FRAMES), strain, digest });
}
