//! The page of symptoms: every scene of the page shows its symptom, and the cured scene does not.

use std::fs;

use instances::simulation;
use kerchief::host::{Description, ScalarKind, Simulation, Solver, SolverKind};

const ROOT: &str = env!("CARGO_MANIFEST_DIR");

/// Results of a run: its final state, and the largest strain of stretch links in motion.
struct Course {
    end: Box<dyn Simulation>,
    strain: f64,
    /// The largest speed in the last tenth of the run, m/s.
    speed: f64,
    /// Frames that were skipped because the sheet was at rest.
    at_rest: u32,
}

fn scene(name: &str) -> Description {
    let path = format!("{ROOT}/../../examples/scenes/symptoms/{name}.toml");
    let scene = Description::parse(&fs::read_to_string(path).unwrap()).unwrap();
    assert_eq!(scene.name, name);
    scene
}

fn course(scene: &Description) -> Course {
    let mut moving = simulation(scene, ScalarKind::F32).unwrap();
    let (mut strain, mut speed, mut at_rest) = (0.0_f64, 0.0_f64, 0);
    for frame in 0..scene.frames {
        let rests = moving.is_at_rest();
        moving.frame();
        at_rest += u32::from(rests && moving.is_at_rest());
        let stretch = moving.strains().stretch.unwrap().largest;
        strain = if stretch.is_nan() { f64::INFINITY } else { strain.max(stretch) };
        if frame >= scene.frames - scene.frames / 10 {
            let velocities = moving.state().velocities;
            speed = velocities.into_iter().flatten().fold(speed, |speed, v| speed.max(v.abs()));
        }
    }
    Course { end: moving, strain, speed, at_rest }
}

fn both(name: &str) -> [Course; 2] {
    [course(&scene(name)), course(&scene(&format!("{name}-cured")))]
}

/// The largest speed at the end of a scene with a changed solver, m/s.
fn speed(name: &str, change: impl FnOnce(&mut Solver)) -> f64 {
    let mut scene = scene(name);
    change(&mut scene.solver);
    course(&scene).speed
}

#[test]
fn explodes() {
    let [ill, cured] = both("explodes");
    assert!(!ill.end.is_finite());
    assert!(cured.end.is_finite() && cured.strain < 0.05, "{}", cured.strain);
}

#[test]
fn stretches_like_rubber() {
    let [ill, cured] = both("rubber");
    assert!(ill.strain > 1.0 && cured.strain < 0.005, "{} {}", ill.strain, cured.strain);
}

#[test]
fn slides_off() {
    let lowest = |course: &Course| course.end.still().positions.iter().fold(f64::INFINITY, |low, x| low.min(x[2]));
    let [ill, cured] = both("slides").map(|course| lowest(&course));
    assert!(ill < -2.0 && cured > -0.8, "{ill} m {cured} m");
}

#[test]
fn shakes() {
    let [ill, cured] = both("shakes");
    assert!(ill.speed > 0.02 && cured.speed < 1e-3, "{} m/s {} m/s", ill.speed, cured.speed);
    assert!(cured.end.strains().stretch.unwrap().largest < 0.01);
}

#[test]
fn turns() {
    let [ill, cured] = both("turns");
    assert!(ill.speed > 0.01 && cured.speed < 1e-3, "{} m/s {} m/s", ill.speed, cured.speed);
    let finer = ill.speed / speed("turns", |solver| solver.substeps = 32);
    assert!((2.5..4.5).contains(&finer), "{finer} times as fast as with twice the substeps");
    let swept = speed("turns", |solver| solver.sweeps = Some(16)) / ill.speed;
    assert!((0.6..0.9).contains(&swept), "{swept} times as fast with sixteen sweeps");
    for kind in [SolverKind::Xpbd, SolverKind::Verlet] {
        let speed = speed("turns", |solver| solver.kind = kind);
        assert!(speed > 0.01, "{speed} m/s by {}", kind.name());
    }
    let implicit = speed("turns", |solver| solver.kind = SolverKind::BackwardEuler);
    assert!(implicit < 1e-3, "{implicit} m/s by backward Euler");
}

#[test]
fn is_slow() {
    let [ill, cured] = both("slow");
    assert!(ill.at_rest == 0 && cured.at_rest > 200, "{} of 600", cured.at_rest);
    let [ill, cured] = [ill, cured].map(|course| course.end.still().positions);
    let apart = ill.into_iter().flatten().zip(cured.into_iter().flatten()).map(|(a, b)| (a - b).abs());
    assert!(apart.fold(0.0, f64::max) < 1e-4, "it hangs elsewhere");
}

#[test]
fn passes_through() {
    let across = |course: &Course| course.end.still().positions.iter().fold(0.0_f64, |far, x| far.max(x[1].abs()));
    let [ill, cured] = both("passes").map(|course| across(&course));
    assert!(ill < 1e-3 && cured > 0.2, "{ill} m {cured} m");
}

/// The page names exactly the scenes of the folder.
#[test]
fn the_page_names_every_scene() {
    let page = fs::read_to_string(format!("{ROOT}/../../docs/guide/symptoms.md")).unwrap();
    let column = page.lines().filter(|line| line.starts_with("| **")).filter_map(|line| line.rsplit('|').nth(1));
    let mut named: Vec<_> = column.flat_map(|cell| cell.split('`').skip(1).step_by(2).map(str::to_owned)).collect();
    let scenes = fs::read_dir(format!("{ROOT}/../../examples/scenes/symptoms")).unwrap();
    let mut there: Vec<_> =
        scenes.map(|entry| entry.unwrap().path().file_stem().unwrap().to_str().unwrap().to_owned()).collect();
    named.sort();
    there.sort();
    assert_eq!(named, there);
}
