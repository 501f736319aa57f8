//! The show on the LCD: a flag before the sky, in gusts or in a steady breeze, and a cloth on two corners that comes to rest.

use core::fmt::Write;

use embedded_graphics::mono_font::MonoTextStyle;
use embedded_graphics::mono_font::ascii::FONT_7X13;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Line, PrimitiveStyle, Rectangle};
use embedded_graphics::text::{Baseline, Text};
use heapless::String;
use kerchief::render::pattern::{CELL, Pattern, Place};
use kerchief::render::{Camera, Gouraud, Light, Look, Shade, Shaded, View};
use kerchief::scene::Only;
use kerchief::units::PanelFlow;
use kerchief::{
    Cloth, Gravity, Lines, Node, PanelWind, Q13, Resting, Scalar, Scene, Shear, Sheet, Solver, Stillness, Stretch,
    Vec3, measure,
};

/// Particles down the pole and along the flag.
const ROW: usize = 8;
const ROWS: usize = 11;
/// Steps in a second, each with a picture of its own.
pub const RATE: u32 = 60;
/// The display.
pub const SCREEN: Size = Size::new(240, 240);

/// Substeps of a step, found by simulating gusts on a host: with fewer, gusts strain the flag by more than 2 %.
const SUBSTEPS: u32 = 4;
/// Two sweeps at most, so that no gust delays a picture.
const LINES: Lines = Lines { most_sweeps: 2, ..Lines::with_sweeps(1).within(0.04) };
/// kg/m²
const DENSITY: f64 = 0.1;
/// m, down the pole and along the flag. Row 0 is at the pole: links between particles of mass 1 cost less, and only this row has other masses.
const SIZE: [f64; 2] = [0.6, 0.9];
const MASS: f64 = DENSITY * SIZE[0] * SIZE[1] / (ROW * ROWS) as f64;
const SHEET: Sheet<Q13, ROW, ROWS> = Sheet::new(SIZE, MASS, 1.0 / RATE as f64, SUBSTEPS);
const VIEW: View = {
    let corners = [SHEET.units.point([-0.08, -0.2, -0.91]), SHEET.units.point([0.9, 0.2, 0.04])];
    View::new(12.0, -3.0).fit(corners[0], corners[1], SCREEN)
};
/// A sheet rests when it moves by less than four pixels a second, and by no more than a pixel in two seconds.
const STILL: Stillness = Stillness { speed: 0.02, acceleration: 0.02, time: 2.0 };
/// A 96th of 1 m/s, in 2⁻²⁴ cells per tick.
const BREATH: i32 = (SHEET.units.velocity([1.0, 0.0, 0.0]).0[0] * (1 << 24) as f64 / 96.0) as i32;

/// Steps in which the wind rises at the start.
const RISE: u32 = RATE / 2;

/// Air at rest.
const CALM: PanelFlow = SHEET.units.panel_wind([0.0; 3], 1.2, 1.2);
/// Air at rest with a large drag, in which a cloth soon comes to rest.
const THICK: PanelFlow = SHEET.units.panel_wind([0.0; 3], 1.2, 40.0);

type Forces = (Gravity<Q13>, PanelWind<Q13>);
type Springs = (Stretch<Q13>, Shear<Q13>);
type Mover = Resting<Lines>;
/// The flag or the cloth.
type Fabric = Cloth<Q13, ROW, ROWS>;

/// Three bands, the middle one wider.
#[derive(Clone, Copy, Debug)]
pub struct Bands;

impl Pattern for Bands {
    fn tone(&self, at: &Place) -> Rgb888 {
        match at.across / CELL {
            0..=1 => Rgb888::new(236, 168, 52),
            2..=4 => Rgb888::new(250, 240, 220),
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

/// A scene of the show. The button changes to the next one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Play {
    /// A flag in wind that swells and turns.
    Gusts,
    /// A flag in wind that hardly changes.
    Breeze,
    /// A cloth in folds, let go on two corners in calm air.
    Corners,
}

impl Play {
    const fn next(self) -> Self {
        match self {
            Self::Gusts => Self::Breeze,
            Self::Breeze => Self::Corners,
            Self::Corners => Self::Gusts,
        }
    }

    /// The velocity of the wind after `step` steps.
    fn wind(self, step: u32) -> Vec3<Q13> {
        let phase = step / 2;
        let [along, across, up] = match self {
            Self::Gusts => [
                480 + wave(phase * 2) / 2 + wave(phase * 3 + 40) / 3,
                wave(phase * 5) / 2 + wave(phase * 7 / 2 + 90) / 4,
                wave(phase * 4 + 17) / 6,
            ],
            Self::Breeze => [480, wave(phase * 4) / 4, wave(phase * 3) / 8],
            Self::Corners => [0; 3],
        };
        // in 96ths of a metre a second; the wind rises at first, because a flat flag would snap taut
        let risen = step.min(RISE) as i32;
        let [x, y, z] = [along, across, up].map(|speed| Q13::from_bits(speed * risen / RISE as i32 * BREATH));
        Vec3::new(x, y, z)
    }
}

/// The sky at the top and at the bottom.
const SKY: [Rgb888; 2] = [Rgb888::new(84, 142, 190), Rgb888::new(236, 226, 206)];
/// The colours of the pole from left to right, and of the rail from top to bottom.
const POLE: [Rgb888; 4] =
    [Rgb888::new(206, 196, 178), Rgb888::new(238, 232, 220), Rgb888::new(150, 138, 122), Rgb888::new(96, 88, 80)];
const INK: Rgb888 = Rgb888::new(244, 248, 252);
/// The most letters of the note, in two lines.
const LETTERS: usize = 80;
/// The area of the note.
pub const NOTE: Rectangle = Rectangle::new(Point::new(8, 4), Size::new(32 * 7, 2 * 13));

/// A sheet, its scene and its picture.
#[derive(Debug)]
pub struct Show {
    /// The flag or the cloth.
    pub cloth: Fabric,
    scene: Scene<Forces, Springs, (), Mover, Only<Q13, ROW, ROWS>>,
    memory: <Mover as Solver<Q13>>::Memory<Springs, ROW, ROWS>,
    play: Play,
    /// Steps since the play's start.
    step: u32,
    /// The largest strain since the play's start.
    largest: Q13,
    shaded: Shaded<Look<Bands, Bands>, ROW, ROWS, 1, Gouraud<Rgb565, 3, ROW, ROWS>>,
    camera: Camera<Q13>,
    /// The sheet's upper corners at the start, pixels.
    corners: [Point; 2],
    note: String<LETTERS>,
}

impl Show {
    /// A flag in gusts, at its start.
    #[inline(never)]
    pub fn new() -> Self {
        let forces = (SHEET.gravity([0.0, 0.0, -9.81]), PanelWind::new(CALM));
        let links = (SHEET.stretch(3e3), SHEET.shear(10.0));
        let scene = SHEET.scene(forces, links, (), SHEET.resting(STILL, LINES));
        let camera = Camera::new(&VIEW, SCREEN);
        Self {
            cloth: flag(),
            memory: scene.memory(),
            scene,
            play: Play::Gusts,
            step: 0,
            largest: Q13::ZERO,
            shaded: Shaded::new(LOOK).gouraud(),
            corners: corners(&flag(), &camera),
            camera,
            note: String::new(),
        }
    }

    /// Changes to the next play, from its start.
    #[inline(never)]
    pub fn press(&mut self) {
        self.play = self.play.next();
        let is_calm = self.play == Play::Corners;
        self.cloth = if is_calm { folds() } else { flag() };
        self.scene.forces.1 = PanelWind::new(if is_calm { THICK } else { CALM });
        self.corners = corners(&self.cloth, &self.camera);
        self.memory = self.scene.memory();
        self.step = 0;
        self.largest = Q13::ZERO;
    }

    /// Advances by a step. While the sheet rests, it does nothing. Returns whether the picture may have changed.
    #[inline(never)]
    pub fn step(&mut self) -> bool {
        self.scene.forces.1.wind = self.play.wind(self.step);
        let rested = self.memory.is_at_rest();
        self.scene.step(&mut self.cloth, &mut self.memory);
        self.step += 1;
        let rests = rested && self.memory.is_at_rest();
        if !rests {
            self.largest = Ord::max(self.largest, self.strain());
        }
        !rests
    }

    /// The largest strain of a [stretch](Self::stretch) link.
    #[inline(never)]
    pub fn strain(&self) -> Q13 {
        measure::largest_strain(&self.cloth, self.stretch())
    }

    /// The links whose strain is shown.
    pub fn stretch(&self) -> &Stretch<Q13> {
        &self.scene.links.0
    }

    /// Writes the note: pictures a second, the frequency in MHz, and the largest [strain](Self::strain) of any step of the play. It appears when the area [`NOTE`] is
    /// drawn again.
    #[inline(never)]
    pub fn note(&mut self, rate: u32, frequency: u32) {
        let strain = self.largest.round_times(1000);
        self.note.clear();
        // the space is enough for numbers of any size
        let _ =
            write!(self.note, "{rate} pictures/s at {frequency} MHz\nstrain up to {}.{} %", strain / 10, strain % 10);
    }

    /// Draws the background on the area of a target: the sky, the pole or the rail, and the note.
    #[inline(never)]
    pub fn draw_sky<D: DrawTarget<Color: Shade>>(&self, target: &mut D) -> Result<(), D::Error> {
        let area = target.bounding_box();
        for y in area.rows() {
            // 256/240 without a division
            let part = (y * 273) >> 8;
            let channel = |of: fn(&Rgb888) -> u8| {
                let [from, to] = SKY.map(|tone| i32::from(of(&tone)));
                (from + (((to - from) * part) >> 8)) as u8
            };
            let tone = Rgb888::new(channel(RgbColor::r), channel(RgbColor::g), channel(RgbColor::b));
            let row = Rectangle::new(Point::new(area.top_left.x, y), Size::new(area.size.width, 1));
            target.fill_solid(&row, D::Color::nearest(tone))?;
        }
        let [left, right] = self.corners;
        for (k, tone) in (0..).zip(POLE) {
            let color = D::Color::nearest(tone);
            if self.play == Play::Corners {
                let [left, right] = [left + Point::new(-8, k - 3), right + Point::new(8, k - 4)];
                Line::new(left, right).into_styled(PrimitiveStyle::with_stroke(color, 1)).draw(target)?;
            } else {
                let stripe = Rectangle::new(left + Point::new(k - 4, -8), Size::new(1, SCREEN.height));
                target.fill_solid(&stripe, color)?;
            }
        }
        if area.intersection(&NOTE).is_zero_sized() {
            return Ok(());
        }
        let style = MonoTextStyle::new(&FONT_7X13, D::Color::nearest(INK));
        Text::with_baseline(&self.note, NOTE.top_left, style, Baseline::Top).draw(target)?;
        Ok(())
    }

    /// Draws the sheet.
    #[inline(never)]
    pub fn draw<D: DrawTarget<Color = Rgb565>>(&mut self, target: &mut D) -> Result<(), D::Error> {
        self.shaded.draw(&self.cloth, &self.camera, target)
    }
}

/// A flag with a sleeve for its pole.
fn flag() -> Fabric {
    let mut cloth = spread(|row| [Q13::from_int(row as i32), Q13::ZERO]);
    (0..ROW).for_each(|column| cloth.pin(Node::new(column, 0)));
    cloth
}

/// A cloth in upright folds, pinned at its upper corners.
fn folds() -> Fabric {
    /// How far out of line the folds are, and how far apart their edges are along the rail. Neighbouring edges stay a unit apart.
    const FOLD: [f64; 2] = [0.5, 0.866_025];
    let [out, along] = FOLD.map(Q13::from_f64);
    let mut cloth = spread(|row| [Q13::ONE + along.times(row as i32), out.times([0, 1, 0, -1][row % 4])]);
    [0, ROWS - 1].into_iter().for_each(|row| cloth.pin(Node::new(0, row)));
    cloth
}

/// An upright sheet. `place` gives the position of each row, from the pole and out of line, in units of the rows' distance.
fn spread(place: impl Fn(usize) -> [Q13; 2]) -> Fabric {
    let mut cloth = SHEET.hang([0.0; 3]);
    let side = Q13::from_f64(SHEET.units.sides[1]);
    // row 0 last: its x gives how far down each column is
    for row in (0..ROWS).rev() {
        let [along, out] = place(row);
        for column in 0..ROW {
            let down = cloth.position.at(Node::new(column, 0)).x;
            let [along, out] = [along, out].map(|cells| cells * side);
            cloth.position.set(Node::new(column, row), Vec3::new(along, out, -down));
        }
    }
    cloth
}

/// The upper corners, pixels.
fn corners(cloth: &Fabric, camera: &Camera<Q13>) -> [Point; 2] {
    [0, ROWS - 1].map(|row| camera.project(cloth.position.at(Node::new(0, row))).unwrap_or_default())
}

/// A wave of period 256 between −128 and 128, of two parabolas.
fn wave(phase: u32) -> i32 {
    let x = (phase & 127) as i32;
    let arch = x * (128 - x) / 32;
    if phase & 128 == 0 { arch } else { -arch }
}
