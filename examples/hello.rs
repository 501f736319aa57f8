//! A kerchief falls between two pins. Draws it in the terminal with letters: `cargo run --example hello`.

use kerchief::{Cloth, Lines, Node, Q24, Sheet};

const SIDE: usize = 16;
const SHEET: Sheet<Q24, SIDE, SIDE> = Sheet::new([0.3, 0.3], 1e-4, 1.0 / 60.0, 8); // m, kg of a particle, s, substeps

fn main() {
    let mut cloth = SHEET.lay([0.0; 3]);
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(SIDE - 1, 0));
    let (gravity, links) = (SHEET.gravity([0.0, 0.0, -9.81]), (SHEET.stretch(100.0), SHEET.shear(1.0)));
    let scene = SHEET.scene(gravity, links, (), Lines::new());
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
