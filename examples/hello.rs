//! A kerchief falls between two pins, drawn in the terminal with letters: `cargo run --example hello`.

use kerchief::{Cloth, Gravity, Lines, Node, Q24, Scene, Shear, Stretch, Units};

const SIDE: usize = 16;
const UNITS: Units = Units::sheet([SIDE, SIDE], [0.3, 0.3], 1e-4, 1.0 / 60.0, 8); // particles, m, kg, s, substeps

fn main() {
    let mut cloth = Cloth::<Q24, SIDE, SIDE>::lay(&UNITS, UNITS.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(SIDE - 1, 0));
    let gravity = Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81]));
    let links = (Stretch::new(&UNITS, UNITS.stiffness(100.0)), Shear::new(&UNITS, UNITS.stiffness(1.0)));
    let scene = Scene::new(&UNITS, gravity, links, (), Lines::new());
    let mut memory = scene.memory();
    for frame in 0..=60 {
        if frame % 12 == 0 {
            println!("{:.1} s\n{}\n", f64::from(frame) / 60.0, picture(&cloth));
        }
        scene.step(&mut cloth, &mut memory);
    }
}

/// The sheet from the side: y to the right, z up, two letters to a cell. The pins are in the middle of the first line.
fn picture(cloth: &Cloth<Q24, SIDE, SIDE>) -> String {
    let mut rows = [[' '; 4 * SIDE]; SIDE + 1];
    for position in cloth.position.values() {
        let [_, y, z] = position.to_f64().map(f64::round); // cells
        let (column, row) = (2 * (y as isize + SIDE as isize), -z as isize);
        rows[row.clamp(0, SIDE as isize) as usize][column.clamp(0, 4 * SIDE as isize - 1) as usize] = '#';
    }
    let rows = rows.map(|row| row.iter().collect::<String>().trim_end().to_owned());
    rows.join("\n").trim_end().to_owned()
}
