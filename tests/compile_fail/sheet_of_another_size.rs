//! expected `4`, found `8`

use kerchief::{Leapfrog, Sheet};

const SHEET: Sheet<f32, 4, 4> = Sheet::new([0.1, 0.1], 1e-3, 0.02, 4);
const OTHER: Sheet<f32, 8, 8> = Sheet::new([0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let mut cloth = OTHER.lay([0.0; 3]);
    let scene = SHEET.scene((), (), (), Leapfrog);
    scene.step(&mut cloth, &mut scene.memory());
}
