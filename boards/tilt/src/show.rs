//! The show on the round LCD: a kerchief between four pegs, which feels the force of the hand.

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Circle, PrimitiveStyle, Rectangle};
use kerchief::render::pattern::{Border, Gingham, Width};
use kerchief::render::{Camera, Gouraud, Light, Look, Shade, Shaded, View};
use kerchief::scene::Only;
use kerchief::{
    Cloth, Drag, Gravity, Lines, Node, Q13, Resting, Scalar, Scene, Shear, Sheet, Solver, Stillness, Stretch, Vec3,
    measure,
};

/// Particles a side: an odd number, so that one is in the middle.
const SIDE: usize = 9;
/// Steps in a second.
pub const RATE: u32 = 60;
/// The display's memory. Only the disk that touches its sides is visible.
pub const SCREEN: Size = Size::new(240, 240);
/// The acceleration of gravity, in the sensor's unit.
pub const WEIGHT: i32 = 4096;

/// Substeps of a step. With two, rows are strained too much when the hand shakes the board, and substeps are split into more parts than these.
const SUBSTEPS: u32 = 3;
/// Eight sweeps at most, found by simulated shaking on a host: with fewer, rows are strained by more than 3 %.
const LINES: Lines = Lines { most_sweeps: 8, ..Lines::with_sweeps(1) };
/// kg/m²
const DENSITY: f64 = 0.1;
/// The kerchief's side, m.
const LENGTH: f64 = 0.3;
const MASS: f64 = DENSITY * LENGTH * LENGTH / (SIDE * SIDE) as f64;
const SHEET: Sheet<Q13, SIDE, SIDE> = Sheet::new([LENGTH, LENGTH], MASS, 1.0 / RATE as f64, SUBSTEPS);
/// Pegs are nearer to each other than the kerchief is long. At first a thread of length 1 extends along the display by the first number, and away from it by the second.
const SLOPE: [f64; 2] = [0.8, 0.6];
/// The camera is 0.66 m from the middle of the pegs: with threads of 0.3 m the pegs are then inside the disk.
const VIEW: View = View::new(0.0, 0.0).at(SHEET.units.point([0.0; 3]), SHEET.units.length(0.66));
/// N/m
const STRETCH: f64 = 4e3;
const SHEAR: f64 = 6.0;
/// Drag, 1/s: the kerchief comes to rest some seconds after the hand.
const DRAG: f64 = 6.0;
/// The kerchief rests when it moves by less than ten pixels a second, and by no more than a pixel in that time.
const STILL: Stillness = Stillness { speed: 0.015, acceleration: 0.015, time: 1.0 };
/// The largest difference between the felt force and the sensor's, along each axis: a hundredth of gravity. The noise of a sensor at rest is smaller.
const PLAY: i32 = WEIGHT / 100;
/// At rest the sensor is read once in so many steps.
const DROWSE: u32 = RATE / 10;

type Forces = (Gravity<Q13>, Drag<Q13>);
type Springs = (Stretch<Q13>, Shear<Q13>);
type Mover = Resting<Lines>;
/// The kerchief.
type Fabric = Cloth<Q13, SIDE, SIDE>;
type Weave = Border<Gingham>;

const RED: Rgb888 = Rgb888::new(196, 40, 44);
const LOOK: Look<Weave, Weave> = {
    let lamp = Light::new(-40.0, 40.0);
    let light = Light {
        lamp: Rgb888::new(190, 180, 158),
        sky: Rgb888::new(104, 112, 124),
        ground: Rgb888::new(62, 60, 62),
        ..lamp
    };
    let gingham = Gingham { width: Width::cells(1), tones: [Rgb888::new(250, 244, 232), RED] };
    Look::new(light, Border { width: Width::cells(1), tone: RED, inner: gingham })
};

/// The colours of the background, at the top and at the bottom.
const BACK: [Rgb888; 2] = [Rgb888::new(38, 52, 72), Rgb888::new(92, 112, 128)];
const BRASS: Rgb888 = Rgb888::new(222, 190, 110);
/// A peg's diameter, pixels.
const PEG: u32 = 9;
const CORNERS: [Node; 4] =
    [Node::new(0, 0), Node::new(SIDE - 1, 0), Node::new(0, SIDE - 1), Node::new(SIDE - 1, SIDE - 1)];

/// A kerchief, its scene and its picture.
#[derive(Debug)]
pub struct Show {
    /// The kerchief.
    pub cloth: Fabric,
    scene: Scene<Forces, Springs, (), Mover, Only<Q13, SIDE, SIDE>>,
    memory: <Mover as Solver<Q13>>::Memory<Springs, SIDE, SIDE>,
    /// The velocity change by gravity in a substep.
    weight: Q13,
    /// The felt force, in parts of [`WEIGHT`]: to the right, away from the viewer, up. At rest it points up.
    felt: [i32; 3],
    /// Steps since the start.
    step: u32,
    shaded: Shaded<Look<Weave, Weave>, SIDE, SIDE, 1, Gouraud<Rgb565, 3, SIDE, SIDE>>,
    camera: Camera<Q13>,
}

impl Show {
    /// A kerchief on an upright board, before it falls.
    #[inline(never)]
    pub fn new() -> Self {
        let gravity = SHEET.gravity([0.0, 0.0, -9.81]);
        let links = (SHEET.stretch(STRETCH), SHEET.shear(SHEAR));
        let scene = SHEET.scene((gravity, SHEET.drag(DRAG)), links, (), SHEET.resting(STILL, LINES));
        Self {
            cloth: pyramid(),
            memory: scene.memory(),
            scene,
            weight: -gravity.gain.z,
            felt: [0, 0, WEIGHT],
            step: 0,
            shaded: Shaded::new(LOOK).gouraud(),
            camera: Camera::new(&VIEW, SCREEN),
        }
    }

    /// Whether [`feel`](Self::feel) should be called before the next step: before each one while the kerchief moves, ten times a second while it rests.
    pub fn is_attentive(&self) -> bool {
        !self.memory.is_at_rest() || self.step % DROWSE == 0
    }

    /// Takes the force that the sensor measures, in parts of [`WEIGHT`]: to the right, away from the viewer, up. Gravity is its opposite, on a shaken board, too. The felt
    /// force follows with some [play](PLAY): it is as smooth as the measured force, and the noise of a sensor does not wake the kerchief.
    pub fn feel(&mut self, force: [i32; 3]) {
        for (felt, force) in self.felt.iter_mut().zip(force) {
            *felt = (*felt).clamp(force - PLAY, force + PLAY);
        }
        // with these shifts, eight times gravity, the sensor's range, fits 32 bits
        let [x, y, z] = self.felt.map(|felt| Q13::from_bits(-felt * (self.weight.to_bits() >> 8) / (WEIGHT >> 8)));
        self.scene.forces.0.gain = Vec3::new(x, y, z);
    }

    /// Advances by a step. While the kerchief rests, it does nothing. Returns whether the picture may have changed.
    #[inline(never)]
    pub fn step(&mut self) -> bool {
        let rested = self.memory.is_at_rest();
        self.scene.step(&mut self.cloth, &mut self.memory);
        self.step += 1;
        !(rested && self.memory.is_at_rest())
    }

    /// The largest strain of a stretch link.
    pub fn strain(&self) -> Q13 {
        measure::largest_strain(&self.cloth, &self.scene.links.0)
    }

    /// Draws the background on the area of a target.
    #[inline(never)]
    pub fn draw_back<D: DrawTarget<Color: Shade>>(&self, target: &mut D) -> Result<(), D::Error> {
        let area = target.bounding_box();
        for y in area.rows() {
            // 256/240 without a division
            let part = (y * 273) >> 8;
            let channel = |of: fn(&Rgb888) -> u8| {
                let [from, to] = BACK.map(|tone| i32::from(of(&tone)));
                (from + (((to - from) * part) >> 8)) as u8
            };
            let tone = Rgb888::new(channel(RgbColor::r), channel(RgbColor::g), channel(RgbColor::b));
            let row = Rectangle::new(Point::new(area.top_left.x, y), Size::new(area.size.width, 1));
            target.fill_solid(&row, D::Color::nearest(tone))?;
        }
        Ok(())
    }

    /// Draws the kerchief and its pegs.
    #[inline(never)]
    pub fn draw<D: DrawTarget<Color = Rgb565>>(&mut self, target: &mut D) -> Result<(), D::Error> {
        self.shaded.draw(&self.cloth, &self.camera, target)?;
        for corner in CORNERS {
            let Some(at) = self.camera.project(self.cloth.position.at(corner)) else { continue };
            Circle::with_center(at, PEG).into_styled(PrimitiveStyle::with_fill(Rgb565::nearest(BRASS))).draw(target)?;
        }
        Ok(())
    }
}

/// A pyramid with its tip away from the viewer, whose threads have their rest lengths.
fn pyramid() -> Fabric {
    let mut cloth = SHEET.hang([0.0; 3]);
    let side = Q13::from_f64(SHEET.units.sides[0]);
    let [along, away] = SLOPE.map(|part| Q13::from_f64(part) * side);
    let half = SIDE as i32 / 2;
    for node in (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| Node::new(column, row))) {
        let [x, z] = [node.column, node.row].map(|place| place as i32 - half);
        let depth = 2 * half - x.abs() - z.abs();
        cloth.position.set(node, Vec3::new(along.times(x), away.times(depth), along.times(-z)));
    }
    CORNERS.into_iter().for_each(|corner| cloth.pin(corner));
    cloth
}
