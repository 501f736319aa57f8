//! `scene.play(..)` steps a sheet and moves on what moves

use kerchief::{Leapfrog, Sheet};

const SHEET: Sheet<f32, 4, 4> = Sheet::new([0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let mut cloth = SHEET.lay([0.0; 3]);
    let ball = SHEET.moving_ball([0.0; 3], 0.1, 0.01, [1.0, 0.0, 0.0]);
    let scene = SHEET.scene((), (), ball, Leapfrog);
    scene.step(&mut cloth, &mut scene.memory());
}
