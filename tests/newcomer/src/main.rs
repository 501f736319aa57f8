//! A flag in the wind. A ball flies into it, and a hand drags its corner. The program plays it in `f32` and in fixed point, and draws it into `f32.ppm` and `q24.ppm`.

use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::pixelcolor::raw::{BigEndian, RawU24};
use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
use kerchief::material::DENIM;
use kerchief::render::{Camera, Light, Look, Shaded, View};
use kerchief::{Lines, Node, Scalar, Sheet, Stillness, measure};

const SCREEN: Size = Size::new(320, 240);
type Picture = Framebuffer<Rgb888, RawU24, BigEndian, 320, 240, { buffer_size::<Rgb888>(320, 240) }>;

fn play<S: Scalar>() -> Picture {
    let sheet = Sheet::<S, 24, 16>::of(&DENIM, [0.9, 0.6], 1.0 / 60.0, 4); // m, s, substeps
    let mut cloth = sheet.hang([0.0, 0.0, 0.6]);
    (0..16).for_each(|row| cloth.pin(Node::new(0, row)));
    let wind = sheet.aerodynamic_wind([2.0, 0.5, 0.0], 1.2, 1.2); // m/s, kg/m³, drag coefficient
    let hand = sheet.hand(0.05, 0.5, 0.1); // m/N, N·s/m, m
    let forces = (sheet.gravity([0.0, 0.0, -9.81]), wind, hand);
    let ball = sheet.moving_ball([0.5, -1.0, 0.2], 0.1, 0.01, [0.0, 0.8, 0.0]).with_friction(0.3);
    let mut scene =
        sheet.scene(forces, sheet.springs(&DENIM, 0.5), ball, sheet.resting(Stillness::DEFAULT, Lines::new()));
    let mut memory = scene.memory();

    scene.forces.2.grab(&cloth, Node::new(23, 15));
    for frame in 0..120 {
        scene.forces.2.drag_to(sheet.place([0.8, -0.005 * f64::from(frame), 0.1]));
        scene.play(&mut cloth, &mut memory);
    }
    let [_, y, _] = sheet.metres(cloth.position.at(Node::new(23, 15)));
    assert!(y < -0.4, "the hand holds it at {y} m");
    assert!(measure::strain(&cloth, &scene.links.0).largest.to_f64() < 0.05);

    let [low, high] = [[0.0, -0.6, 0.0], [0.9, 0.2, 0.6]].map(|corner| sheet.units.point(corner));
    let camera = Camera::new(&View::new(-30.0, 15.0).fit(low, high, SCREEN), SCREEN);
    let look = Look::new(Light::new(-40.0, 50.0), Rgb888::new(60, 84, 130));
    let mut picture = Picture::new();
    let Ok(()) = Shaded::new(look).draw(&cloth, &camera, &mut picture);
    picture
}

fn main() {
    for (name, picture) in [("f32.ppm", play::<f32>()), ("q24.ppm", play::<kerchief::Q24>())] {
        let file = [b"P6 320 240 255\n".as_slice(), picture.data()].concat();
        std::fs::write(name, file).expect("a place for the picture");
    }
}
