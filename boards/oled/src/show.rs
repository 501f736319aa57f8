//! The show on the OLED: a curtain in folds, and gravity that a joystick tilts.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{Line, PrimitiveStyle};
use kerchief::render::pattern::{CELL, Pattern, Place};
use kerchief::render::{Camera, Finish, Light, Look, Shade, Shaded, View};
use kerchief::scene::Only;
use kerchief::{
    Cloth, Drag, Gravity, Lines, LinesMemory, Node, Q13, Resting, Scalar, Scene, Shear, Sheet, Solver, Stillness,
    Stretch, Vec3, measure,
};

/// Particles a side.
const SIDE: usize = 16;
/// Steps in a second.
pub const RATE: u32 = 30;
/// The display.
pub const SCREEN: Size = Size::new(128, 64);

/// A theatre's curtain of 12 m × 6.4 m.
const SHEET: Sheet<Q13, SIDE, SIDE> = Sheet::new([12.0, 6.4], 0.1, 1.0 / RATE as f64, 1);
const VIEW: View = {
    let corners = [SHEET.units.point([-5.41, -0.5, -6.3]), SHEET.units.point([5.41, 0.5, 0.1])];
    View::new(0.0, 6.0).fit(corners[0], corners[1], SCREEN)
};
/// The curtain rests when it has been slower than 2 cm/s for a second.
const STILL: Stillness = Stillness { speed: 0.02, acceleration: 0.02, time: 1.0 };
/// The rings of a fold, of five columns: the distance of each from the one before along the rod, and its distance out of line, in units of the columns' distance.
/// Neighbouring columns stay a unit apart.
const FOLD: [[f64; 2]; 5] =
    [[0.76286, 0.32328], [0.97984, 0.52308], [0.85228, 0.00000], [0.85228, -0.52308], [0.97984, -0.32328]];
/// The distance from the middle of the curtain to its first ring.
const HALF: f64 = 6.64065;

type Forces = (Gravity<Q13>, Drag<Q13>);
type Mover = Resting<Lines>;
type Springs = (Stretch<Q13>, Shear<Q13>);
type Memory = <Mover as Solver<Q13>>::Memory<Springs, SIDE, SIDE>;

/// The state of the curtain and of its solver. It is too large for the stack of a board, which keeps it in a `static`.
#[derive(Debug)]
pub struct Room {
    cloth: Cloth<Q13, SIDE, SIDE>,
    memory: Memory,
}

impl Room {
    /// The state before the curtain is hung.
    pub const BLANK: Self = Self { cloth: Cloth::BLANK, memory: Memory::new(LinesMemory::BLANK) };
}

/// White, with trimmings near the lower end.
#[derive(Clone, Copy, Debug)]
struct Fabric;

impl Pattern for Fabric {
    fn tone(&self, at: &Place) -> Rgb888 {
        let grey = match at.down / CELL {
            11 | 13 => 120,
            14 => 190,
            _ => 245,
        };
        Rgb888::new(grey, grey, grey)
    }
}

/// Cloth under a lamp on the left, so that the right side of each fold is dark.
const LOOK: Look<Fabric, Fabric> = {
    let lamp = Light::new(-58.0, 18.0);
    let light = Light {
        lamp: Rgb888::new(205, 205, 205),
        sky: Rgb888::new(60, 60, 60),
        ground: Rgb888::new(34, 34, 34),
        ..lamp
    };
    let look = Look::new(light, Fabric);
    Look { finish: Finish { gloss: Rgb888::new(0, 0, 0), polish: 0, translucency: 20 }, ..look }
};

const ROD: Rgb888 = Rgb888::new(150, 150, 150);

/// The direction in which the joystick is pressed: to the right, and away from the viewer.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Stick {
    /// 1 to the right, −1 to the left.
    pub right: i32,
    /// 1 away from the viewer, −1 towards the viewer.
    pub away: i32,
}

/// The curtain, its scene and its picture.
#[derive(Debug)]
pub struct Show<'a> {
    /// The curtain.
    pub cloth: &'a mut Cloth<Q13, SIDE, SIDE>,
    scene: Scene<Forces, Springs, (), Mover, Only<Q13, SIDE, SIDE>>,
    memory: &'a mut Memory,
    /// The tilt of gravity, in parts of `STEEPEST`.
    tilt: Stick,
    shaded: Shaded<Look<Fabric, Fabric>, SIDE, SIDE>,
    camera: Camera<Q13>,
}

/// The largest horizontal component of gravity, in 32nds of its vertical component.
const STEEPEST: i32 = 16;

impl<'a> Show<'a> {
    /// A curtain that has just been drawn to the side and still swings.
    pub fn new(Room { cloth, memory }: &'a mut Room) -> Self {
        cloth.hang_here(&SHEET.units, SHEET.units.point([-6.0, 0.0, 0.0]));
        gather(cloth);
        let forces = (SHEET.gravity([0.0, 0.0, -9.81]), SHEET.drag(1.2));
        let links = (SHEET.stretch(20_000.0), SHEET.shear(400.0));
        let scene = SHEET.scene(forces, links, (), SHEET.resting(STILL, Lines::new()));
        Self {
            cloth,
            memory,
            scene,
            tilt: Stick { right: STEEPEST, away: 0 },
            shaded: Shaded::new(LOOK),
            camera: Camera::new(&VIEW, SCREEN),
        }
    }

    /// Advances by a step. While both the curtain and the joystick rest, it does nothing. Returns whether the picture may have changed.
    #[inline]
    pub fn step(&mut self, stick: Stick) -> bool {
        let before = self.tilt;
        self.tilt = Stick { right: towards(before.right, stick.right), away: towards(before.away, stick.away) };
        if self.tilt != before {
            let gravity = &mut self.scene.forces.0.gain;
            let part = |tilt: i32| -gravity.z.times(tilt).halve(5);
            (gravity.x, gravity.y) = (part(self.tilt.right), part(self.tilt.away));
        }
        let rested = self.memory.is_at_rest();
        self.scene.step(self.cloth, self.memory);
        !(rested && self.memory.is_at_rest())
    }

    /// The largest strain of a thread.
    pub fn strain(&self) -> Q13 {
        measure::largest_strain(self.cloth, &self.scene.links.0)
    }

    /// Draws the rod behind the curtain.
    pub fn draw_rod<D: DrawTarget<Color: Shade>>(&self, target: &mut D) -> Result<(), D::Error> {
        let ends = [-5.5, 5.5].map(|x| self.camera.project(SHEET.units.point([x, 0.0, 0.09]).to_vec()));
        let [Some(left), Some(right)] = ends else { return Ok(()) };
        Line::new(left, right).into_styled(PrimitiveStyle::with_stroke(D::Color::nearest(ROD), 2)).draw(target)
    }

    /// Draws the curtain.
    pub fn draw<D: DrawTarget<Color: Shade>>(&mut self, target: &mut D) -> Result<(), D::Error> {
        self.shaded.draw(self.cloth, &self.camera, target)
    }
}

/// Tilts by one part: towards the joystick's direction, or back.
fn towards(tilt: i32, stick: i32) -> i32 {
    tilt + (stick.signum() * STEEPEST - tilt).signum()
}

/// Moves the columns together, so that they stand in folds, and pins the upper ends.
fn gather(cloth: &mut Cloth<Q13, SIDE, SIDE>) {
    let mut x = Q13::from_f64(-HALF);
    for column in 0..SIDE {
        let [along, out] = FOLD[column % FOLD.len()].map(Q13::from_f64);
        if column > 0 {
            x += along;
        }
        for row in 0..SIDE {
            let node = Node::new(column, row);
            let at = cloth.position.at(node);
            cloth.position.set(node, Vec3::new(x, out, at.z));
        }
        cloth.pin(Node::new(column, 0));
    }
}
