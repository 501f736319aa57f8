//! The sheets of a page.

use embedded_graphics::geometry::{Point, Size};
use kerchief::render::Orbit;
use kerchief::{Node, Q13, Q24, Scalar};

use crate::eye;
use crate::frame::Frame;
use crate::likeness::Fate;
use crate::parts::Refusal;
use crate::play::{Moving, start};
use crate::settings::{Number, Settings};

/// The left sheet and the right one.
const SHEETS: usize = 2;

/// The sheets, and the settings for the next start or change.
pub(crate) struct World {
    pub(crate) settings: Settings,
    pub(crate) eye: Orbit,
    pub(crate) frame: Frame,
    /// A result of three numbers, which the page reads from memory.
    pub(crate) place: [f64; 3],
    sheets: [Option<Box<dyn Moving>>; SHEETS],
    sides: [usize; SHEETS],
}

impl World {
    pub(crate) const fn new() -> Self {
        Self {
            settings: Settings::DEFAULT,
            eye: eye::START,
            frame: Frame::EMPTY,
            place: [0.0; 3],
            sheets: [const { None }; SHEETS],
            sides: [0; SHEETS],
        }
    }

    /// Starts a sheet, instead of the one before. After a refusal there is none.
    pub(crate) fn start(&mut self, sheet: usize) -> u32 {
        self.sheets[sheet] = None;
        self.sides[sheet] = self.settings.side;
        let started = match self.settings.number {
            Number::F32 => on_grid::<f32>(&self.settings),
            Number::F64 => on_grid::<f64>(&self.settings),
            Number::Q24 => on_grid::<Q24>(&self.settings),
            Number::Q13 => on_grid::<Q13>(&self.settings),
        };
        match started {
            Ok(moving) => {
                self.sheets[sheet] = Some(moving);
                0
            }
            Err(refusal) => refusal as u32,
        }
    }

    pub(crate) fn change(&mut self, sheet: usize) -> u32 {
        let settings = self.settings;
        let change = |moving: &mut Box<dyn Moving>| moving.change(&settings).err().map_or(0, |refusal| refusal as u32);
        self.sheets[sheet].as_mut().map_or(0, change)
    }

    pub(crate) fn sheet(&mut self, sheet: usize) -> &mut dyn Moving {
        self.sheets[sheet].as_deref_mut().expect("a sheet that was started")
    }

    pub(crate) fn node(&self, sheet: usize, index: usize) -> Node {
        Node::new(index % self.sides[sheet], index / self.sides[sheet])
    }

    pub(crate) fn fate(&mut self, sheet: usize) -> Fate {
        self.sheet(sheet).shown().fate()
    }

    pub(crate) fn draw(&mut self, sheet: usize, width: u32, height: u32) {
        let Self { eye, frame, sheets, .. } = self;
        frame.resize(width, height);
        if let Some(moving) = &sheets[sheet] {
            moving.shown().draw(eye, sheet > 0, frame);
        }
    }

    pub(crate) fn pick(&mut self, sheet: usize, screen: Size, pixel: Point) -> i32 {
        let (eye, side) = (self.eye, self.sides[sheet]);
        let picked = self.sheet(sheet).shown().pick(&eye, screen, pixel);
        picked.map_or(-1, |node| (node.row * side + node.column) as i32)
    }

    pub(crate) fn drag_under(&mut self, sheet: usize, screen: Size, pixel: Point) {
        let (eye, place) = (self.eye, self.place);
        self.place = self.sheet(sheet).shown().under(&eye, screen, pixel, place);
    }

    /// A particle's pixel: its column in the upper half, its row in the lower; −1 if there is none.
    pub(crate) fn pixel(&mut self, sheet: usize, screen: Size, index: usize) -> i32 {
        let (eye, node) = (self.eye, self.node(sheet, index));
        let seen = self.sheet(sheet).shown().pixel(&eye, screen, node);
        let within = |pixel: &Point| pixel.x >= 0 && pixel.y >= 0 && pixel.x < 0x7fff && pixel.y < 0x7fff;
        seen.filter(within).map_or(-1, |pixel| pixel.x << 16 | pixel.y)
    }
}

/// Starts a sheet on one of the page's grids. Finer grids are drawn with fewer faces a cell.
fn on_grid<S: Scalar>(settings: &Settings) -> Result<Box<dyn Moving>, Refusal> {
    match settings.side {
        8 => start::<S, 8, 8>(settings),
        16 => start::<S, 16, 4>(settings),
        _ => start::<S, 32, 2>(settings),
    }
}
