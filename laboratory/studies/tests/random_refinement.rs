//! Shorter steps are more accurate: random sheets by every solver in every number type, compared with the rig's reference solution.
//!
//! `PROPTEST_CASES=500 cargo test --release -p laboratory --test random_refinement` tests more cases.

use std::fmt::Write;

use kerchief::{Q13, Q24, Scalar};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngSeed;
use rig::reference::{Model, Pose, Sheet, State};
use rig::scenes::{GRAVITY, springs};
use rig::{Method, Pace, error, moved, stirred};

/// Particles a side.
const N: usize = 8;
/// A frame, s.
const FRAME: f64 = 1.0 / 60.0;
/// Frames of a run.
const FRAMES: u32 = 30;
/// Factor on the substeps of a finer run.
const FINER: u32 = 4;

/// The largest allowed ratio of the fine run's error to the coarse run's. The coarse error may be small by chance: it may change its sign between two steps.
const FACTOR: f64 = 1.5;
/// Fine errors up to this may be due to rounding, sheet sizes: in floats, and in fixed point, where in short steps the last place corresponds to a large force.
const ACCURATE: f64 = 2e-4;
const ROUNDED: f64 = 4e-3;
/// Coarse runs with a larger error are not compared, sheet sizes: they have nothing in common with the solution.
const LOST: f64 = 0.1;

/// All solvers with usual settings.
const METHODS: [Method; 6] =
    [Method::ForwardEuler, Method::BackwardEuler, Method::Leapfrog, Method::Verlet(4), Method::Xpbd, Method::Lines(2)];

#[derive(Clone, Copy, Debug)]
enum Start {
    Laid,
    Hung,
    /// Laid flat, with the far half folded over the near one.
    Folded,
}

#[derive(Clone, Copy, Debug)]
enum Pins {
    Corners,
    Edge,
    Centre,
    Single,
    None,
}

#[derive(Clone, Debug)]
struct Scene {
    start: Start,
    pins: Pins,
    size: f64,
    /// Approximate strain of the sheet by its own weight.
    strain: f64,
    shear: f64,
    bend: f64,
    drag: f64,
    substeps: u32,
}

fn scene() -> impl Strategy<Value = Scene> {
    let power = |low: f64, high: f64| (low..high).prop_map(|exponent| 10_f64.powf(exponent));
    (
        select(&[Start::Laid, Start::Hung, Start::Folded][..]),
        select(&[Pins::Corners, Pins::Edge, Pins::Centre, Pins::Single, Pins::None][..]),
        power(-0.5, 0.5),
        power(-2.5, -1.0),
        power(-1.5, 0.0),
        power(-2.0, -1.0),
        power(-0.5, 0.7),
        select(&[1_u32, 2, 3, 4, 6, 8, 12, 16][..]),
    )
        .prop_map(|(start, pins, size, strain, shear, bend, drag, substeps)| Scene {
            start,
            pins,
            size,
            strain,
            shear,
            bend,
            drag,
            substeps,
        })
}

impl Scene {
    fn model(&self) -> Model {
        const LAST: usize = N - 1;
        let pose = if matches!(self.start, Start::Hung) { Pose::Hang } else { Pose::Lay };
        let pins: &[(usize, usize)] = match self.pins {
            Pins::Corners => &[(0, 0), (LAST, 0)],
            Pins::Edge => &[(0, 0), (1, 0), (2, 0), (3, 0), (4, 0), (5, 0), (6, 0), (LAST, 0)],
            Pins::Centre => &[(N / 2, N / 2)],
            Pins::Single => &[(0, 0)],
            Pins::None => &[],
        };
        let mass = 0.2 * self.size * self.size / (N * N) as f64;
        let sheet = Sheet::new(pose, [N, N], [self.size; 2]).with_mass(mass).with_pins(pins);
        let stretch = mass * -GRAVITY[2] * (N * LAST) as f64 / (self.strain * self.size);
        let families = springs(stretch, self.shear * stretch, self.bend * stretch);
        Model { families, gravity: GRAVITY, drag: self.drag, ..Model::new(sheet) }
    }

    /// The start without any symmetry, so that rounding does not decide the direction of motion.
    fn state(&self, model: &Model) -> State {
        let mut state = stirred(model);
        if matches!(self.start, Start::Folded) {
            let flat = model.start().position;
            for row in N / 2..N {
                for column in 0..N {
                    let (here, over) = (model.sheet.index((column, row)), model.sheet.index((column, N - 1 - row)));
                    if !model.sheet.pins.contains(&(column, row)) {
                        let [_, y, z] = flat[over];
                        let [x, moved_y, moved_z] = state.position[here];
                        state.position[here] =
                            [x, moved_y - flat[here][1] + y, moved_z + z + self.size / (N - 1) as f64];
                    }
                }
            }
        }
        state
    }
}

/// The final state by the rig, if it depends little on the start and on the step.
fn solution(model: &Model, start: &State) -> Option<State> {
    let ode = model.ode();
    let time = FRAME * f64::from(FRAMES);
    let steps = (10.0 * time / ode.stable_step()).ceil() as usize;
    let solve = |mut state: State, steps: usize| {
        ode.rk4(&mut state, time / steps as f64, steps);
        state
    };
    let mut near = start.clone();
    for (k, velocity) in near.velocity.iter_mut().enumerate() {
        velocity[k % 3] += 1e-4 * model.sheet.size();
    }
    let [exact, near] = [solve(start.clone(), 2 * steps), solve(near, steps)];
    (error(model, &exact, &near) < 2e-4).then_some(exact)
}

/// The error of a run; infinite if it is undefined.
fn run<S: Scalar>(model: &Model, start: &State, exact: &State, method: Method, substeps: u32) -> f64 {
    let mut motion = moved::<S, N, N>(model, Pace::new(FRAME, substeps), method);
    motion.set(start);
    motion.run(FRAMES);
    let error = error(model, &motion.state(), exact);
    if error.is_nan() { f64::INFINITY } else { error }
}

/// Known failures: steps so short that the corrections of a soft spring are only a few last places in `Q13`.
fn is_excluded<S: Scalar>(method: Method, substeps: u32) -> bool {
    matches!(method, Method::Verlet(_) | Method::Xpbd) && S::NAME == Q13::NAME && substeps >= 24
}

/// The runs that became worse with finer steps.
fn worse<S: Scalar>(scene: &Scene, model: &Model, start: &State, exact: &State) -> String {
    let mut found = String::new();
    let accurate = if S::EXACT_SUMS { ROUNDED } else { ACCURATE };
    for method in METHODS {
        if is_excluded::<S>(method, FINER * scene.substeps) {
            continue;
        }
        let [coarse, fine] =
            [scene.substeps, FINER * scene.substeps].map(|substeps| run::<S>(model, start, exact, method, substeps));
        if fine > (FACTOR * coarse).max(accurate) && coarse < LOST {
            let _ = writeln!(found, "{method:?} in {}: {coarse:.2e} became {fine:.2e}", S::NAME);
        }
    }
    found
}

/// The number of cases of `PROPTEST_CASES`, with a new seed in every run; or a few cases that are always the same.
fn config() -> ProptestConfig {
    let asked = std::env::var_os("PROPTEST_CASES").is_some();
    let usual = ProptestConfig::default();
    let (cases, rng_seed) = if asked { (usual.cases, usual.rng_seed) } else { (20, RngSeed::Fixed(1)) };
    ProptestConfig { cases, rng_seed, failure_persistence: None, ..usual }
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn refinement_does_not_increase_the_error(scene in scene()) {
        let model = scene.model();
        let start = scene.state(&model);
        let Some(exact) = solution(&model, &start) else { return Ok(()) };
        let found = [
            worse::<f32>(&scene, &model, &start, &exact),
            worse::<f64>(&scene, &model, &start, &exact),
            worse::<Q24>(&scene, &model, &start, &exact),
            worse::<Q13>(&scene, &model, &start, &exact),
        ]
        .concat();
        prop_assert!(found.is_empty(), "\n{found}");
    }
}
