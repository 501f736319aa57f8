//! What the LCD shows: a flag in gusts, before the sky. Nothing here knows a board; a host plays the same, to the last bit.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use kerchief::render::pattern::{CELL, Pattern, Place};
use kerchief::render::{Camera, Light, Look, Shade, Shaded, View};
use kerchief::{Cloth, Gravity, Node, Q13, Scene, Shear, Stretch, Units, Xpbd};

use crate::breeze::Breeze;
use crate::still::Rest;

/// Particles a side.
const SIDE: usize = 16;
/// Steps in a second.
pub(crate) const RATE: u32 = 30;
/// The display.
pub(crate) const SCREEN: Size = Size::new(240, 240);
/// Substeps of a step.
const SUBSTEPS: u32 = 3;

/// A flag of 12 m × 8 m.
const UNITS: Units = Units::sheet([SIDE, SIDE], [12.0, 8.0], 0.05, 1.0 / RATE as f64, SUBSTEPS);
const VIEW: View = View::new(12.0, -3.0).fit(UNITS.point([-0.4, -1.6, -10.0]), UNITS.point([11.6, 1.6, 1.2]), SCREEN);

type Forces = (Gravity<Q13>, Breeze);
type Springs = (Stretch<Q13>, Shear<Q13>);

/// Three bands, the middle one narrower.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bands;

impl Pattern for Bands {
    fn tone(&self, at: &Place) -> Rgb888 {
        match at.down / CELL {
            0..=4 => Rgb888::new(236, 168, 52),
            5..=9 => Rgb888::new(250, 240, 220),
            _ => Rgb888::new(22, 118, 116),
        }
    }
}

const LOOK: Look<Bands, Bands> = {
    let lamp = Light::new(-52.0, 38.0);
    let light = Light {
        lamp: Rgb888::new(190, 180, 158),
        sky: Rgb888::new(104, 112, 124),
        ground: Rgb888::new(62, 60, 62),
        ..lamp
    };
    Look::new(light, Bands)
};

/// How it blows, by the button.
const WINDS: [i32; 3] = [5, 8, 0];

/// The sky at the top and at the bottom.
const SKY: [Rgb888; 2] = [Rgb888::new(84, 142, 190), Rgb888::new(236, 226, 206)];
/// The pole from its left to its right.
const POLE: [Rgb888; 4] =
    [Rgb888::new(206, 196, 178), Rgb888::new(238, 232, 220), Rgb888::new(150, 138, 122), Rgb888::new(96, 88, 80)];

/// The flag, what moves it and how it is drawn.
pub(crate) struct Show {
    pub(crate) cloth: Cloth<Q13, SIDE, SIDE>,
    scene: Scene<Forces, Springs, (), Xpbd>,
    rest: Rest<Q13>,
    /// Which of [`WINDS`] blows.
    wind: usize,
    /// Steps since the start.
    step: u32,
    shaded: Shaded<Look<Bands, Bands>, SIDE, SIDE>,
    camera: Camera<Q13>,
    /// Where the pole begins, pixels.
    pole: i32,
}

impl Show {
    pub(crate) fn new() -> Self {
        let mut cloth = Cloth::hang(&UNITS, UNITS.point([0.0; 3]));
        for row in 0..SIDE {
            cloth.pin(Node::new(0, row));
        }
        let forces = (Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])), Breeze { wind: [0; 3] });
        let links = (Stretch::new(&UNITS, UNITS.stiffness(60_000.0)), Shear::new(&UNITS, UNITS.stiffness(4_000.0)));
        let camera = Camera::new(&VIEW, SCREEN);
        let pole = camera.project(UNITS.point([0.0, 0.0, -4.0]).to_vec()).map_or(0, |at| at.x);
        Self {
            cloth,
            scene: Scene::new(&UNITS, forces, links, (), Xpbd),
            rest: Rest::new(&UNITS, 0.02, RATE),
            wind: 0,
            step: 0,
            shaded: Shaded::new(LOOK),
            camera,
            pole: pole - POLE.len() as i32,
        }
    }

    /// Another wind.
    pub(crate) fn press(&mut self) {
        self.wind = (self.wind + 1) % WINDS.len();
        self.rest.wake();
    }

    /// A step; nothing where there is no wind and the flag rests. Says whether there is something new to see.
    pub(crate) fn step(&mut self) -> bool {
        if self.rest.has_come() {
            return false;
        }
        self.step += 1;
        self.scene.forces.1.wind = self.gust();
        self.scene.step(&mut self.cloth, &mut ());
        self.rest.watch(&self.cloth);
        true
    }

    /// Wind that swells and turns.
    fn gust(&self) -> [i32; 3] {
        let strength = WINDS[self.wind];
        let swell = 128 + wave(self.step * 2) / 3 + wave(self.step * 3 + 40) / 4;
        let turn = wave(self.step * 5) + wave(self.step * 7 / 2 + 90) / 2;
        [strength * swell / 4, strength * turn / 8, strength * wave(self.step * 4 + 17) / 24]
    }

    /// Draws the sky and the pole where they are seen on a target.
    pub(crate) fn draw_sky<D: DrawTarget<Color: Shade>>(&self, target: &mut D) -> Result<(), D::Error> {
        let area = target.bounding_box();
        for y in area.rows() {
            let part = y * 256 / SCREEN.height as i32;
            let channel = |of: fn(&Rgb888) -> u8| {
                let [from, to] = SKY.map(|tone| i32::from(of(&tone)));
                (from + (((to - from) * part) >> 8)) as u8
            };
            let tone = Rgb888::new(channel(RgbColor::r), channel(RgbColor::g), channel(RgbColor::b));
            let row = Rectangle::new(Point::new(area.top_left.x, y), Size::new(area.size.width, 1));
            target.fill_solid(&row, D::Color::nearest(tone))?;
        }
        for (x, tone) in (self.pole..).zip(POLE) {
            let top = Point::new(x, 12);
            target.fill_solid(&Rectangle::new(top, Size::new(1, SCREEN.height)), D::Color::nearest(tone))?;
        }
        Ok(())
    }

    /// Draws the flag.
    pub(crate) fn draw<D: DrawTarget<Color: Shade>>(&mut self, target: &mut D) -> Result<(), D::Error> {
        self.shaded.draw(&self.cloth, &self.camera, target)
    }
}

/// A wave of period 256 between −128 and 128, of two parabolas.
fn wave(phase: u32) -> i32 {
    let x = (phase & 127) as i32;
    let arch = x * (128 - x) / 32;
    if phase & 128 == 0 { arch } else { -arch }
}
