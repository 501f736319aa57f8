//! A sheet that is stretched tenfold in still air. The air once took up to |n|/16 of a corner's velocity in a substep, for any size |n| of a triangle: it threw the sheet
//! back faster than it came, and faster still in the next substep.

use kerchief::{
    AerodynamicWind, Cloth, Force, Lines, Node, PanelWind, Q13, Q24, Scalar, Scene, Solver, Units, Vec3, Xpbd,
};

const SIDE: usize = 4;
/// The distance of neighbours, cells.
const APART: i32 = 10;
const UNITS: Units = Units::sheet([SIDE; 2], [3.0; 2], 1.0, 0.1, 1);

/// The largest speed in 40 frames and the mean velocity after them, over the initial speed.
fn left<S: Scalar, F: Force<S>, V: Solver<S>>(air: F, solver: V) -> [f64; 2] {
    let units = UNITS;
    let mut cloth = Cloth::<S, SIDE, SIDE>::lay(&units, units.point([0.0; 3]));
    let place = |k: usize| S::from_int(APART * (k as i32 - 2));
    for (column, row) in (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (column, row))) {
        cloth.position.set(Node::new(column, row), Vec3::new(place(column), place(row), S::ZERO));
    }
    // air of this density would stop the sheet in a hundredth of a substep
    let speed = 0.5;
    cloth.velocity.change(|_| Vec3::from_f64([0.0, 0.0, speed]));
    let scene = Scene::new(&units, air, (), (), solver);
    let mut memory = scene.memory();
    let mut fastest = 0.0_f64;
    for _ in 0..40 {
        scene.step(&mut cloth, &mut memory);
        fastest = cloth.velocity.values().map(|v| v.to_f64()[2].abs()).fold(fastest, f64::max);
    }
    let mean = cloth.velocity.values().map(|v| v.to_f64()[2]).sum::<f64>() / (SIDE * SIDE) as f64;
    [fastest, mean].map(|velocity| velocity / speed)
}

#[test]
fn air_stills_large_triangles() {
    fn every<S: Scalar>() {
        let air = AerodynamicWind::<S>::new(UNITS.aerodynamic_wind([0.0; 3], 1000.0, 1.0));
        let panels = PanelWind::<S>::new(UNITS.panel_wind([0.0; 3], 1000.0, 1.0));
        let all = [
            ("lines", left::<S, _, Lines>(air, Lines::new())),
            ("xpbd", left::<S, _, _>(air, Xpbd)),
            ("lines, panels", left::<S, _, Lines>(panels, Lines::new())),
            ("xpbd, panels", left::<S, _, _>(panels, Xpbd)),
        ];
        for (solver, [fastest, mean]) in all {
            // the air acts on the mean velocity of a triangle's corners, so their relative velocities remain
            assert!(fastest <= 1.0 && mean.abs() < 0.1, "{fastest} and {mean} by {solver} in {}", S::NAME);
        }
    }
    every::<f32>();
    every::<f64>();
    every::<Q24>();
    every::<Q13>();
}
