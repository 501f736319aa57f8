//! Equal numbers everywhere: each scene, solver and number type has one digest, the same in debug and release builds and on every target.
//! This includes floats: only `+ − × ÷` and the correctly rounded square root are used, in one order.
//!
//! After an intended change of the motion, `UPDATE_DIGESTS=1 cargo test -p cases --test digests` rewrites `src/table.rs`. That run still
//! fails, because it was compiled with the old table. The tests `boards` of the emulator compare boards with the same table.

use std::fmt::Write;

use cases::{
    Ball, CASES, Drag, Ground, METHODS, Mass, Method, NUMBERS, Number, Outcome, Rod, Setup, Spring, Surface, TABLE,
    Wind,
};
use kerchief::Scalar;
use kerchief::host::{Description, WindModel, built_in};

fn pairs() -> impl Iterator<Item = (Setup, Method)> {
    CASES.into_iter().flat_map(|case| METHODS.into_iter().map(move |method| (case, method)))
}

/// The digest after the last frame, and the state of the sheet.
fn outcome(number: &Number, case: &Setup, method: Method) -> (u32, Outcome) {
    let mut last = 0;
    let outcome = (number.play)(case, method, &mut |digest| last = digest);
    (last, outcome)
}

#[test]
fn digests_are_those_of_the_table() {
    let mut found = Vec::new();
    for (case, method) in pairs() {
        let digests: Vec<_> = NUMBERS.iter().map(|number| outcome(number, &case, method).0).collect();
        found.push((case.name, format!("{method:?}"), digests));
    }
    if std::env::var_os("UPDATE_DIGESTS").is_some() {
        write(&found);
    }
    let mut differences = Vec::new();
    for (scene, solver, digests) in &found {
        let Some((_, _, expected)) = TABLE.iter().find(|row| (row.0, row.1) == (*scene, solver.as_str())) else {
            differences.push(format!("{scene} by {solver}: not in the table"));
            continue;
        };
        for ((number, expected), found) in NUMBERS.iter().zip(expected).zip(digests) {
            if expected != found {
                let name = number.name;
                differences.push(format!("{scene} by {solver} in {name}: {found:#010x} instead of {expected:#010x}"));
            }
        }
    }
    assert!(differences.is_empty(), "sheets moved otherwise:\n{}", differences.join("\n"));
    assert_eq!(TABLE.len(), found.len(), "the table has a row for each scene and solver, and no other");
}

/// Writes the table.
fn write(rows: &[(&str, String, Vec<u32>)]) {
    let names = NUMBERS.iter().map(|number| number.name).collect::<Vec<_>>().join(", ");
    let mut text = format!(
        "//! Digests of the scenes, written by `UPDATE_DIGESTS=1 cargo test -p cases --test digests` and not meant to be read.\n\
         #![allow(clippy::unreadable_literal)]\n\n\
         /// Scene, solver, and the digests in {names}.\n\
         pub const TABLE: &[(&str, &str, [u32; {}])] = &[\n",
        NUMBERS.len()
    );
    for (scene, solver, digests) in rows {
        let digests = digests.iter().map(|digest| format!("{digest:#010x}")).collect::<Vec<_>>().join(", ");
        let _ = writeln!(text, "    ({scene:?}, {solver:?}, [{digests}]),");
    }
    text += "];\n";
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/src/table.rs");
    std::fs::write(path, text).expect("the table can be written");
}

/// The table doesn't preserve wrong motion: in every number type the box around the sheet is close to that in f64.
#[test]
fn number_types_agree() {
    for (case, method) in pairs() {
        // cells; particles between the curtain's pegs start on the axis of its rod, and rounding decides in which direction they leave it
        let bound = if case.name == "curtain" { 0.2 } else { 0.01 };
        let outcomes: Vec<_> = NUMBERS.iter().map(|number| (number.name, outcome(number, &case, method).1)).collect();
        let reference = outcomes.iter().find(|(name, _)| *name == f64::NAME).expect("f64 is a number type").1;
        for (name, outcome) in outcomes {
            let apart = farthest(outcome.bounds, reference.bounds);
            assert!(outcome.finite && apart < bound, "{} by {method:?} in {name}: {apart} cells from f64", case.name);
        }
    }
}

/// The largest difference between the coordinates of two boxes, cells.
fn farthest(a: [[f64; 3]; 2], b: [[f64; 3]; 2]) -> f64 {
    a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

/// Each scene with the name of a built-in scene is that scene on a smaller grid, without self-contact. Built-in scenes about self-contact have no counterpart here.
#[test]
fn scenes_of_the_files_are_the_files() {
    let mut missing: Vec<_> = kerchief::host::BUILT_IN.iter().map(|scene| scene.name).collect();
    for case in CASES {
        let Some(file) = built_in(case.name) else { continue };
        missing.retain(|name| *name != case.name);
        let file = Description::parse(file.text).expect("a built-in scene is a scene");
        assert_eq!(read(&file, &case), case);
    }
    assert_eq!(missing, ["heap", "fold"]);
}

/// Converts a scene file to a [`Setup`]. Pins depend on the grid, and are taken from `case`.
fn read(file: &Description, case: &Setup) -> Setup {
    let surface = |surface: kerchief::host::Surface| Surface { margin: surface.margin, friction: surface.friction };
    let spring = |spring: kerchief::host::Spring| Spring { stiffness: spring.stiffness, damping: spring.damping };
    let sheet = &file.sheet;
    assert!(file.spheres.len() <= 1 && file.planes.len() <= 1 && file.capsules.len() <= 1, "one of each");
    assert_eq!(sheet.pins.is_empty(), case.pins.is_empty(), "{}", case.name);
    let cells = ((sheet.columns - 1) * (sheet.rows - 1)) as f64;
    Setup {
        name: case.name,
        size: [sheet.width, sheet.height],
        upright: sheet.pose == kerchief::host::Pose::Hang,
        origin: sheet.origin,
        mass: if sheet.shares_area() {
            // rounded to the digits of the file
            Mass::PerArea((sheet.mass * cells / (sheet.width * sheet.height) * 1e9).round() / 1e9)
        } else {
            Mass::PerParticle(sheet.mass)
        },
        hem: sheet.hem,
        pins: case.pins,
        hand: None,
        stretch: file.stretch.map(spring).expect("a sheet"),
        shear: file.shear.map(spring),
        bend: file.bend.map(spring),
        limit: file.solver.strain_limit,
        tether: file.tether_slack,
        gravity: file.gravity,
        drag: file.drag.map(|drag| match drag.key {
            "drag" => Drag::Rate(drag.rate),
            _ => Drag::Verlet((-(-drag.rate * file.solver.step).exp_m1() * 1e9).round() / 1e9),
        }),
        wind: file.wind.map(|wind| match wind.model {
            WindModel::Facet => Wind::Facet(wind.velocity),
            WindModel::Aerodynamic { density, drag_coefficient } => {
                assert_eq!([density, drag_coefficient], [1.2; 2], "{}", case.name);
                Wind::Aerodynamic(wind.velocity)
            }
            WindModel::Panel { .. } => unreachable!("no built-in scene has such wind"),
        }),
        ball: file.spheres.first().map(|ball| Ball {
            centre: ball.centre,
            radius: ball.radius,
            velocity: ball.velocity,
            surface: surface(ball.surface),
        }),
        rod: file.capsules.first().map(|rod| Rod {
            ends: [rod.a, rod.b],
            radius: rod.radius,
            surface: surface(rod.surface),
        }),
        ground: file.planes.first().map(|plane| Ground {
            point: plane.point,
            normal: plane.normal,
            surface: surface(plane.surface),
        }),
        frame: file.solver.step,
    }
}
