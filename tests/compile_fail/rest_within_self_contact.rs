//! `Resting` stands around `SelfContact`, or the sheet never rests

use kerchief::rest::Stillness;
use kerchief::*;

const SHEET: Sheet<f32, 4, 4> = Sheet::new([0.3, 0.3], 1e-3, 1.0 / 60.0, 4);

fn main() {
    let resting = Resting::new(&SHEET.units, Stillness::DEFAULT, Lines::new());
    let scene = SHEET.scene((), SHEET.stretch(100.0), (), SHEET.self_contact(0.09, 0.3, resting));
    scene.step(&mut SHEET.hang([0.0; 3]), &mut scene.memory());
}
