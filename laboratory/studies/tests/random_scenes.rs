//! Random scenes and states that nobody would write: none of them panics or hangs, and stable solvers keep all numbers finite. In fixed point a particle leaves the range only in
//! scenes that come near its limit, or are overstretched, in `f64` as well.
//!
//! `PROPTEST_CASES=3000 cargo test --release -p laboratory --test random_scenes` tests more cases. Failures are stored in `random_scenes.regressions` and are tried first. The
//! fuzzers of `tests/fuzz` look for inputs that reach new code; their corpus is played here, too.

use std::fmt::Write;
use std::fs;
use std::path::Path;

use instances::simulation;
use kerchief::host::{BUILT_IN, Description, ScalarKind, SolverKind, Wind, WindModel};
use kerchief_fuzz::{file, state};
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

/// Optional tables of a scene.
fn extras() -> impl Strategy<Value = String> {
    let wind = (vector(30.0), select(&["facet", "aerodynamic", "panel"][..]))
        .prop_map(|(velocity, model)| format!("wind = {{ velocity = {velocity:?}, model = \"{model}\" }}\n"));
    let environment = (vector(20.0), power(-2.0, 2.0), proptest::option::of(wind)).prop_map(|(gravity, drag, wind)| {
        format!("[environment]\ngravity = {gravity:?}\ndrag = {drag}\n{}", wind.unwrap_or_default())
    });
    let surface =
        (0.0..0.1, 0.0..2.0).prop_map(|(margin, friction)| format!("margin = {margin}\nfriction = {friction}\n"));
    let sphere = (vector(1.0), power(-2.0, 0.0), vector(5.0), surface.clone()).prop_map(
        |(centre, radius, velocity, surface)| {
            format!("[[sphere]]\ncentre = {centre:?}\nradius = {radius}\nvelocity = {velocity:?}\n{surface}")
        },
    );
    let capsule = (vector(2.0), vector(2.0), power(-2.0, 0.0), surface)
        .prop_map(|(a, b, radius, surface)| format!("[[capsule]]\na = {a:?}\nb = {b:?}\nradius = {radius}\n{surface}"));
    let plane = vector(1.0).prop_map(|normal| format!("[[plane]]\npoint = [0.0, 0.0, -1.0]\nnormal = {normal:?}\n"));
    let tether = (0.0..0.5).prop_map(|slack| format!("[tether]\nslack = {slack}\n"));
    let rest = power(-4.0, 0.0).prop_map(|speed| format!("[rest]\nspeed = {speed}\n"));
    let option = |text: BoxedStrategy<String>| proptest::option::of(text).prop_map(Option::unwrap_or_default);
    let obstacles = (option(sphere.boxed()), option(plane.boxed()), option(capsule.boxed()));
    (environment, obstacles, option(tether.boxed()), option(rest.boxed())).prop_map(
        |(environment, (sphere, plane, capsule), tether, rest)| {
            [environment, sphere, plane, capsule, tether, rest].concat()
        },
    )
}

fn scene() -> impl Strategy<Value = String> {
    let hem = proptest::option::of(power(-1.5, 1.5).prop_map(|factor| format!("hem = {factor}\n")));
    let mass = prop_oneof![
        power(-5.0, 1.0).prop_map(|mass| format!("mass = {mass}\n")),
        power(-3.0, 1.0).prop_map(|density| format!("density = {density}\n")),
    ];
    let cloth = (
        select(&[[4, 4], [8, 8], [1, 32]][..]),
        power(-1.0, 1.0),
        (mass, hem).prop_map(|(mass, hem)| mass + &hem.unwrap_or_default()),
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
            "[cloth]\ncolumns = {columns}\nrows = {rows}\nwidth = {size}\nheight = {size}\n{mass}pins = {pins}\n\
             pose = \"{pose}\"\n[stretch]\nstiffness = {stretch}\ndamping = {damping}\n[shear]\nstiffness = {shear}\n\
             [bend]\nstiffness = {bend}\n{extras}[solver]\nstep = {frame}\nsubsteps = {substeps}\niterations = {iterations}\n"
        );
        if let Some(limit) = limit {
            let _ = writeln!(text, "strain_limit = {limit}");
        }
        text
    })
}

/// Scene files with pieces replaced by random text.
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

/// The part of fixed point's range that a sheet may use at the ends of frames. Within a frame it may be further out, and links between particles are up to twice as long.
const ROOM: f64 = 0.4;

/// Whether wind of the facet model moves the sheet without bound. This wind does not weaken with the sheet's velocity, and grows with the stretched area. It is too strong if
/// it carries a free sheet away, exceeds the springs' forces, or displaces light particles by more than the sheet's size within a substep, and whirls them faster and faster.
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

/// Results of a run.
#[derive(Debug, PartialEq)]
struct Seen {
    digest: u32,
    finite: bool,
    /// The furthest coordinate at the end of a frame, m.
    reach: f64,
    /// The largest strain at the end of a frame.
    strain: f64,
}

/// Runs some frames; `None` if the number type refuses the scene.
fn played(scene: &Description, scalar: ScalarKind) -> Option<Seen> {
    let mut simulation = match simulation(scene, scalar) {
        Ok(simulation) => simulation,
        Err(error) => {
            assert!(!error.to_string().contains('\n') && !error.key.is_empty(), "{error}");
            return None;
        }
    };
    let (mut reach, mut strain) = (0.0_f64, 0.0_f64);
    for _ in 0..12 {
        simulation.frame();
        reach = simulation.still().positions.as_flattened().iter().fold(reach, |most, x| most.max(x.abs()));
        strain = strain.max(simulation.strains().all.largest);
    }
    Some(Seen { digest: simulation.digest(), finite: simulation.is_finite(), reach, strain })
}

/// The range of fixed point, m: 128 cells.
fn range(scene: &Description) -> f64 {
    let sheet = &scene.sheet;
    let side = |size: f64, particles: usize| if particles > 1 { size / (particles - 1) as f64 } else { 0.0 };
    128.0 * side(sheet.width, sheet.columns).max(side(sheet.height, sheet.rows))
}

/// The number of cases of `PROPTEST_CASES`, with a new seed in every run; or `cases` cases that are always the same.
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
    fn stable_solvers_hold_every_scene(text in scene()) {
        let Ok(mut scene) = Description::parse(&text) else { return Ok(()) };
        for kind in [SolverKind::Lines, SolverKind::Xpbd, SolverKind::Verlet, SolverKind::BackwardEuler] {
            scene.solver.kind = kind;
            let exact = played(&scene, ScalarKind::F64);
            // A sheet that other solvers overstretch in f64 may fly off in fixed point.
            let torn = |seen: &Seen| seen.strain > 1.0 && kind != SolverKind::Lines;
            let stays = exact.as_ref().is_some_and(|seen| seen.reach < ROOM * range(&scene) && !torn(seen));
            for scalar in ScalarKind::ALL {
                let once = played(&scene, scalar);
                let floats = matches!(scalar, ScalarKind::F32 | ScalarKind::F64);
                let holds = once.as_ref().is_none_or(|seen| seen.finite) || !(floats || stays);
                prop_assert!(holds || is_unbounded(&scene), "{} in {}: {exact:?}, {once:?}", kind.name(), scalar.name());
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
    #![proptest_config(config(40))]

    #[test]
    fn no_bits_of_a_state_panic(bits in proptest::collection::vec(any::<u32>(), state::NUMBERS)) {
        state::play_all(&bits.try_into().expect("as many as asked for"));
    }
}

/// The corpus of a fuzzer: a [`fuzz`](https://rust-fuzz.github.io/book/) target in `tests/fuzz`.
fn corpus(target: &str) -> Vec<Vec<u8>> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/fuzz/corpus").join(target);
    let files = fs::read_dir(&folder).expect("a corpus");
    let corpus: Vec<_> = files.map(|file| fs::read(file.expect("an entry").path()).expect("a file")).collect();
    assert!(corpus.len() > 10, "{} is empty", folder.display());
    corpus
}

#[test]
fn what_fuzzers_found_moves() {
    corpus("step").iter().for_each(|bytes| state::play(bytes));
    corpus("scene_file").iter().for_each(|bytes| file::play(bytes, simulation));
}
