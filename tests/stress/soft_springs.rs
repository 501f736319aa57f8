//! Soft springs in short substeps, by the line solver. `Q13` once kept 14 bits of their strength κ = k·h²/m: springs grew weaker with more substeps, and beyond some number
//! had no strength at all.

use kerchief::{Cloth, Gravity, Lines, Node, Q13, Q24, Scalar, Scene, Stretch, Units};

use crate::stage::DOWN;

/// The lowest point after some frames of 20 ms, m, of a sheet with stretch links only that hangs from its upper corners.
fn lowest<S: Scalar, const W: usize, const H: usize>(
    size: [f64; 2],
    [mass, stretch]: [f64; 2],
    substeps: u32,
    frames: u32,
) -> f64 {
    let units = Units::sheet([W, H], size, mass, 0.02, substeps);
    let mut cloth = Cloth::<S, W, H>::hang(&units, units.point([0.0; 3]));
    [0, W - 1].into_iter().for_each(|column| cloth.pin(Node::new(column, 0)));
    let stretch = Stretch::new(&units, units.stiffness(stretch));
    let scene = Scene::new(&units, Gravity::new(units.acceleration(DOWN)), stretch, (), Lines::new());
    let mut memory = scene.memory();
    (0..frames).for_each(|_| scene.step(&mut cloth, &mut memory));
    cloth.position.values().map(|place| place.to_f64()[2]).fold(0.0, f64::min) * units.cell
}

#[test]
fn soft_springs_hold_however_short_a_substep_is() {
    fn chain<S: Scalar>(substeps: u32) -> f64 {
        lowest::<S, 1, 32>([0.0, 1.0], [0.01, 300.0], substeps, 20)
    }
    fn sheet<S: Scalar>(substeps: u32) -> f64 {
        lowest::<S, 4, 4>([0.3; 2], [0.05, 30.0], substeps, 40)
    }
    for substeps in [64, 128, 256, 512] {
        let exact = chain::<f64>(substeps);
        for found in [chain::<Q24>(substeps), chain::<Q13>(substeps)] {
            assert!((found / exact - 1.0).abs() < 0.002, "chain in {substeps} substeps: {found}, {exact} in f64");
        }
    }
    let exact = sheet::<f64>(64);
    for found in [sheet::<Q24>(64), sheet::<Q13>(64)] {
        assert!((found / exact - 1.0).abs() < 0.002, "sheet: {found}, {exact} in f64");
    }
}

/// The elongation under its own weight of a chain of springs with κ = 9/4/`divisor`, cells.
fn stretched<S: Scalar>(divisor: f64) -> f64 {
    let (mass, frame) = (2e-3, 0.1);
    let units = Units::sheet([1, 16], [0.0, 0.15], mass, frame, 1);
    let mut cloth = Cloth::<S, 1, 16>::hang(&units, units.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    let stiffness = 9.0 / 4.0 * mass / (frame * frame) / divisor;
    let stretch = Stretch::new(&units, units.stiffness(stiffness));
    let scene = Scene::new(&units, Gravity::new(units.acceleration(DOWN)), stretch, (), Lines::new());
    let mut memory = scene.memory();
    (0..100).for_each(|_| scene.step(&mut cloth, &mut memory));
    -cloth.position.at(Node::new(0, 15)).to_f64()[2] - 15.0
}

#[test]
fn very_stiff_springs_give_as_much_as_in_floats() {
    // with 14 bits a divisor of 2.5e-5 was zero, and the chain did not stretch; one of twice as much was a fifth too large
    for divisor in [1e-3, 2e-4, 5e-5, 2.5e-5] {
        let [exact, found] = [stretched::<f64>(divisor), stretched::<Q13>(divisor)];
        assert!((found / exact - 1.0).abs() < 0.02, "1/κ {divisor}: {found} cells, {exact} in f64");
    }
}
