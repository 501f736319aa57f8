//! Damped sheets come to rest in every number type, although rounding makes them tremble.

use kerchief::{
    Cloth, Drag, Gravity, Lines, Node, Q13, Q24, Resting, Scalar, Scene, Shear, Solver, Stillness, Stretch, Units,
    Vec3, Verlet, Xpbd,
};

const SIDE: usize = 8;
/// Frames of a minute.
const MINUTE: u32 = 3600;

/// A damped scene, in SI units.
#[derive(Clone, Copy, Debug)]
struct Damped {
    size: f64,
    /// The strain of a link that carries the weight of a whole column.
    strain: f64,
    substeps: u32,
    drag: f64,
    pins: Pins,
}

#[derive(Clone, Copy, Debug)]
enum Pins {
    Corners,
    Edge,
}

/// Scenes with mixed sizes, stiffness, substeps, drags and pins.
fn scenes() -> impl Iterator<Item = Damped> {
    (0..20_usize).map(|k| Damped {
        size: [0.3, 0.6, 1.0, 1.7, 3.0][k % 5],
        strain: [0.001, 0.003, 0.01, 0.03][k % 4],
        substeps: [1, 2, 4, 8, 16, 3][k % 6],
        drag: [2.0, 3.0, 5.0][k % 3],
        pins: if k % 7 < 4 { Pins::Corners } else { Pins::Edge },
    })
}

/// The frame in which a pushed sheet comes to rest, if it does within a minute.
fn frames<S: Scalar, V: Solver<S>>(scene: Damped, solver: V) -> Option<u32> {
    let Damped { size, strain, substeps, drag, pins } = scene;
    let mass = 0.2 * size * size / (SIDE * SIDE) as f64;
    let units = Units::sheet([SIDE; 2], [size; 2], mass, 1.0 / 60.0, substeps);
    let stiffness = mass * 9.81 * SIDE as f64 / (strain * units.cell);
    let mut cloth = Cloth::<S, SIDE, SIDE>::hang(&units, units.point([0.0, 0.0, size]));
    cloth.velocity.change(|_| Vec3::from_f64(units.velocity([0.1, 0.2, 0.0]).0));
    for column in 0..SIDE {
        if matches!(pins, Pins::Edge) || column == 0 || column == SIDE - 1 {
            cloth.pin(Node::new(column, 0));
        }
    }
    let forces = (Gravity::new(units.acceleration([0.0, 0.0, -9.81])), Drag::new(units.drag(drag)));
    let links =
        (Stretch::new(&units, units.stiffness(stiffness)), Shear::new(&units, units.stiffness(0.1 * stiffness)));
    let scene = Scene::new(&units, forces, links, (), Resting::new(&units, Stillness::DEFAULT, solver));
    let mut memory = scene.memory();
    (1..=MINUTE).find(|_| {
        scene.step(&mut cloth, &mut memory);
        memory.is_at_rest()
    })
}

fn every_scene<S: Scalar>(failures: &mut Vec<String>) {
    for scene in scenes() {
        let found = [
            ("xpbd", frames::<S, _>(scene, Xpbd)),
            ("verlet", frames::<S, _>(scene, Verlet { sweeps: 4 })),
            ("lines", frames::<S, _>(scene, Lines::default())),
        ];
        for (name, frames) in found {
            if frames.is_none() {
                failures.push(format!("{name} in {}: {scene:?}", S::NAME));
            }
        }
    }
}

#[test]
fn damped_sheets_come_to_rest_within_a_minute() {
    let mut failures = Vec::new();
    every_scene::<f32>(&mut failures);
    every_scene::<f64>(&mut failures);
    every_scene::<Q24>(&mut failures);
    every_scene::<Q13>(&mut failures);
    assert!(failures.is_empty(), "never at rest:\n{}", failures.join("\n"));
}
