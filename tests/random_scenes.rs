//! Scenes and states that nobody would write: none panics, none hangs, and what a stable solver moves stays finite.
//!
//! `PROPTEST_CASES=100000 cargo test --release --test random_scenes` looks longer. What it finds is kept in `random_scenes.regressions` and tried first. The fuzzers of
//! `tests/fuzz` look where the code has been least; what they keep is played here too.

#[path = "fuzz/file.rs"]
mod file;
#[path = "fuzz/state.rs"]
mod state;

use std::fmt::Write;
use std::fs;
use std::path::Path;

use kerchief::host::{BUILT_IN, Description, ScalarKind, SolverKind, Wind, WindModel};
use proptest::prelude::*;
use proptest::sample::{Index, select};
use proptest::test_runner::{FailurePersistence, FileFailurePersistence, RngSeed};

/// A number between two powers of ten.
fn power(low: f64, high: f64) -> impl Strategy<Value = f64> {
    (low..high).prop_map(|exponent| 10_f64.powf(exponent))
}

fn vector(largest: f64) -> impl Strategy<Value = [f64; 3]> {
    [-largest..largest, -largest..largest, -largest..largest]
}

/// Tables that a scene may have or not.
fn extras() -> impl Strategy<Value = String> {
    let wind = (vector(30.0), select(&["facet", "aerodynamic"][..]))
        .prop_map(|(velocity, model)| format!("wind = {{ velocity = {velocity:?}, model = \"{model}\" }}\n"));
    let environment = (vector(20.0), power(-2.0, 2.0), proptest::option::of(wind)).prop_map(|(gravity, drag, wind)| {
        format!("[environment]\ngravity = {gravity:?}\ndrag = {drag}\n{}", wind.unwrap_or_default())
    });
    let surface =
        (0.0..0.1, 0.0..2.0).prop_map(|(margin, friction)| format!("margin = {margin}\nfriction = {friction}\n"));
    let sphere =
        (vector(1.0), power(-2.0, 0.0), vector(5.0), surface).prop_map(|(centre, radius, velocity, surface)| {
            format!("[[sphere]]\ncentre = {centre:?}\nradius = {radius}\nvelocity = {velocity:?}\n{surface}")
        });
    let plane = vector(1.0).prop_map(|normal| format!("[[plane]]\npoint = [0.0, 0.0, -1.0]\nnormal = {normal:?}\n"));
    let tether = (0.0..0.5).prop_map(|slack| format!("[tether]\nslack = {slack}\n"));
    let rest = power(-4.0, 0.0).prop_map(|speed| format!("[rest]\nspeed = {speed}\n"));
    let option = |text: BoxedStrategy<String>| proptest::option::of(text).prop_map(Option::unwrap_or_default);
    (environment, option(sphere.boxed()), option(plane.boxed()), option(tether.boxed()), option(rest.boxed()))
        .prop_map(|(a, b, c, d, e)| a + &b + &c + &d + &e)
}

fn scene() -> impl Strategy<Value = String> {
    let cloth = (
        select(&[[4, 4], [8, 8], [1, 32]][..]),
        power(-1.0, 1.0),
        power(-5.0, 1.0),
        select(&["[[0, 0]]", "\"top\"", "\"left\"", "\"corners\"", "[]"][..]),
        select(&["lay", "hang"][..]),
    );
    let links = [power(-2.0, 8.0), power(-2.0, 8.0), power(-2.0, 8.0), power(-6.0, 1.0)];
    let step = (power(-3.0, -0.7), 1_u32..10, 1_u32..4, proptest::option::of(power(-3.0, 0.0)));
    (cloth, links, extras(), step).prop_map(|((shape, size, mass, pins, pose), links, extras, step)| {
        let [columns, rows] = shape;
        let [stretch, shear, bend, damping] = links;
        let (frame, substeps, iterations, limit) = step;
        let mut text = format!(
            "[cloth]\ncolumns = {columns}\nrows = {rows}\nwidth = {size}\nheight = {size}\nmass = {mass}\npins = {pins}\n\
             pose = \"{pose}\"\n[stretch]\nstiffness = {stretch}\ndamping = {damping}\n[shear]\nstiffness = {shear}\n\
             [bend]\nstiffness = {bend}\n{extras}[solver]\nstep = {frame}\nsubsteps = {substeps}\niterations = {iterations}\n"
        );
        if let Some(limit) = limit {
            let _ = writeln!(text, "strain_limit = {limit}");
        }
        text
    })
}

/// Pieces of scene files, torn out and put elsewhere.
fn torn() -> impl Strategy<Value = String> {
    let tear = (any::<Index>(), any::<Index>(), "[-\\[\\]{}=.,\"'# \\n0-9a-z\\x00é€]{0,6}");
    (any::<Index>(), proptest::collection::vec(tear, 1..6)).prop_map(|(scene, tears)| {
        let mut text: Vec<char> = scene.get(BUILT_IN).text.chars().collect();
        for (from, to, instead) in tears {
            let (from, to) = (from.index(text.len() + 1), to.index(text.len() + 1));
            text.splice(from.min(to)..from.max(to).min(from.min(to) + 40), instead.chars());
        }
        text.into_iter().collect()
    })
}

/// Whether wind of the facet model, which does not weaken with the sheet's velocity and grows with the area that it stretches, carries the sheet away, pulls
/// harder than its springs, or blows light particles beyond the sheet within a substep: it whirls them faster and faster.
fn is_unbounded(scene: &Description) -> bool {
    let speed = |wind: Wind| wind.velocity.iter().map(|v| v * v).sum::<f64>().sqrt();
    let facets = scene.wind.filter(|wind| wind.model == WindModel::Facet).map_or(0.0, speed);
    let sheet = &scene.sheet;
    let [width, height] = [sheet.width, sheet.height];
    let size = width.min(height);
    let stiffness = scene.stretch.map_or(0.0, |spring| spring.stiffness);
    let cell = width * height / ((sheet.columns - 1).max(1) * (sheet.rows - 1).max(1)) as f64;
    let substep = scene.solver.step / f64::from(scene.solver.substeps);
    let blown = facets * cell / sheet.mass_at(0, 0) * substep * substep;
    facets > 0.0 && sheet.pins.is_empty() || facets * width * height > 0.01 * stiffness * size || blown > size
}

/// Digests after some frames; none where the number type does not hold the scene.
fn played(scene: &Description, scalar: ScalarKind) -> Option<(u32, bool)> {
    let mut simulation = match scene.simulation(scalar) {
        Ok(simulation) => simulation,
        Err(error) => {
            assert!(!error.to_string().contains('\n') && !error.key.is_empty(), "{error}");
            return None;
        }
    };
    for _ in 0..12 {
        simulation.frame();
    }
    Some((simulation.digest(), simulation.is_finite()))
}

/// As many cases as the environment asks for, others in every run; or this many, always the same.
fn config(cases: u32) -> ProptestConfig {
    let asked = std::env::var_os("PROPTEST_CASES").is_some();
    let usual = ProptestConfig::default();
    let failure_persistence: Option<Box<dyn FailurePersistence>> =
        Some(Box::new(FileFailurePersistence::WithSource("regressions")));
    let (cases, rng_seed) = if asked { (usual.cases, usual.rng_seed) } else { (cases, RngSeed::Fixed(1)) };
    ProptestConfig { cases, rng_seed, failure_persistence, ..usual }
}

proptest! {
    #![proptest_config(config(40))]

    #[test]
    fn stable_solvers_keep_every_scene_finite(text in scene()) {
        let Ok(mut scene) = Description::parse(&text) else { return Ok(()) };
        for kind in [SolverKind::Lines, SolverKind::Xpbd, SolverKind::Verlet, SolverKind::BackwardEuler] {
            scene.solver.kind = kind;
            for scalar in ScalarKind::ALL {
                let once = played(&scene, scalar);
                let holds = once.is_none_or(|(_, finite)| finite);
                prop_assert!(holds || is_unbounded(&scene), "{} in {}", kind.name(), scalar.name());
                prop_assert_eq!(once, played(&scene, scalar), "{} in {}", kind.name(), scalar.name());
            }
        }
    }

}

proptest! {
    #![proptest_config(config(1000))]

    #[test]
    fn torn_files_are_refused_in_a_line(text in torn()) {
        if let Err(error) = Description::parse(&text) {
            prop_assert!(!error.to_string().contains(char::is_control), "{error:?}");
        }
    }

}

proptest! {
    #![proptest_config(config(100))]

    #[test]
    fn no_bits_of_a_state_panic(bits in proptest::collection::vec(any::<u32>(), state::NUMBERS)) {
        state::play_all(&bits.try_into().expect("as many as asked for"));
    }
}

/// What the fuzzers found worth keeping: [`fuzz`](https://rust-fuzz.github.io/book/) targets in `tests/fuzz`.
fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/fuzz/corpus").join(target);
    let files = fs::read_dir(&folder).expect("a corpus");
    let corpus: Vec<_> = files.map(|file| fs::read(file.expect("an entry").path()).expect("a file")).collect();
    assert!(corpus.len() > 10, "{} is empty", folder.display());
    corpus
}

#[test]
fn what_fuzzers_found_moves() {
    corpus("step").iter().for_each(|bytes| state::play(bytes));
    corpus("scene_file").iter().for_each(|bytes| file::play(bytes));
}
