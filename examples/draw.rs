//! A denim sheet hung from two corners, drawn with `embedded-graphics`: `cargo run --release --example draw` writes `out/draw.png`.

use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay};
use kerchief::material::DENIM;
use kerchief::render::{Camera, Ground, Light, Look, Shaded, Shadow, View, pattern::Stripes, pattern::Width};
use kerchief::{Lines, Node, Sheet, Units};

const SIDE: usize = 24;
const SHEET: Sheet<f32, SIDE, SIDE> = Sheet::of(&DENIM, [0.6, 0.6], 1.0 / 60.0, 8); // m, s, substeps
const UNITS: Units = SHEET.units;
const SCREEN: Size = Size::new(480, 480);
const VIEW: View = View::new(30.0, 15.0).fit(UNITS.point([-0.1, -0.3, -0.1]), UNITS.point([0.7, 0.6, 0.7]), SCREEN);
const BLUE: [Rgb888; 2] = [Rgb888::new(60, 84, 130), Rgb888::new(42, 60, 98)];

fn main() {
    let mut cloth = SHEET.lay([0.0, 0.0, 0.65]);
    cloth.share_area();
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(SIDE - 1, 0));
    let forces = (SHEET.gravity([0.0, 0.0, -9.81]), SHEET.drag(0.5));
    let scene = SHEET.scene(forces, SHEET.springs(&DENIM, 0.5), (), Lines::new());
    let mut memory = scene.memory();
    for _frame in 0..150 {
        scene.step(&mut cloth, &mut memory);
    }
    let ground = Ground::new(UNITS.point([0.3, 0.0, 0.0]), UNITS.length(1.0));
    let look = Look::new(Light::new(-40.0, 50.0), Stripes { width: Width::cells(1), tones: BLUE });
    let look = look.backdrop(ground.shadow(Shadow::<96>::new(Rgb888::new(128, 120, 116))));
    let mut display = SimulatorDisplay::<Rgb888>::new(SCREEN);
    let Ok(()) = Shaded::new(look).smooth::<8>().draw(&cloth, &Camera::new(&VIEW, SCREEN), &mut display);
    std::fs::create_dir_all("out").expect("a place for the picture");
    display.to_rgb_output_image(&OutputSettings::default()).save_png("out/draw.png").expect("the picture is written");
}
