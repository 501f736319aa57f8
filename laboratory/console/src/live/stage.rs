//! The scene with the state that keys and pointers change.

mod drawing;
mod pointing;
#[cfg(test)]
mod tests;

use std::fmt;

use kerchief::host::{Description, Painter, ScalarKind, Simulation, SolverKind, Still};
use kerchief::render::Orbit;

use super::caption::PICTURE;
use super::pointer::Pressed;
use super::strain::Watched;
use super::weather::Weather;
use crate::Start;

/// The command of a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Key {
    Left,
    Right,
    Up,
    Down,
    Pause,
    Pin,
    Wind,
    Solver,
    Number,
    Reset,
}

/// A scene in motion, and the position of the eye.
pub struct Stage<'a> {
    scene: Description,
    scalar: ScalarKind,
    start: Start,
    painter: Painter<'a>,
    orbit: Orbit,
    simulation: Box<dyn Simulation>,
    strain: Watched,
    /// The next corner that is pinned or released.
    corner: usize,
    weather: Weather,
    paused: bool,
    pressed: Option<Pressed>,
    /// The reason why the last command failed.
    complaint: String,
}

impl fmt::Debug for Stage<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Stage").field("scene", &self.scene.name).field("scalar", &self.scalar).finish_non_exhaustive()
    }
}

impl<'a> Stage<'a> {
    pub fn new(scene: &'a Description, scalar: ScalarKind, start: Start) -> Result<Self, String> {
        let simulation = start(scene, scalar).map_err(|error| error.to_string())?;
        let still = simulation.still();
        let seen = [fallen(scene, &still), still];
        let painter = Painter::new(scene, &seen, PICTURE.size).map_err(|error| error.to_string())?;
        Ok(Self {
            scene: scene.clone(),
            scalar,
            start,
            orbit: painter.orbit(),
            painter,
            strain: Watched::start(&*simulation),
            simulation,
            corner: 0,
            weather: Weather::of(scene),
            paused: false,
            pressed: None,
            complaint: String::new(),
        })
    }

    /// Moves the sheet by a frame, unless it is paused.
    pub fn advance(&mut self) {
        if !self.paused {
            self.simulation.frame();
            self.strain.follow(&*self.simulation);
        }
    }

    /// Handles a key press or, with `repeat`, a repetition of it.
    pub fn key(&mut self, key: Key, repeat: bool) {
        match key {
            Key::Left => self.tilt(0, -1.0),
            Key::Right => self.tilt(0, 1.0),
            Key::Up => self.tilt(1, 1.0),
            Key::Down => self.tilt(1, -1.0),
            _ if repeat => {}
            Key::Pause => self.paused = !self.paused,
            Key::Pin => self.pin(),
            Key::Wind => {
                self.weather.windy = !self.weather.windy;
                self.apply();
            }
            Key::Solver => {
                let kind = next(&SolverKind::ALL, self.scene.solver.kind);
                self.change(kind, self.scalar);
            }
            Key::Number => self.change(self.scene.solver.kind, next(&ScalarKind::ALL, self.scalar)),
            Key::Reset => self.reset(),
        }
    }

    fn tilt(&mut self, axis: usize, keys: f64) {
        self.weather.turn(axis, keys);
        self.apply();
    }

    fn pin(&mut self) {
        let (right, bottom) = (self.scene.sheet.columns - 1, self.scene.sheet.rows - 1);
        let [column, row] = [[0, 0], [right, 0], [right, bottom], [0, bottom]][self.corner];
        let pinned = self.simulation.state().pinned[row * self.scene.sheet.columns + column];
        self.simulation.set_pinned(column, row, !pinned);
        self.corner = (self.corner + 1) % 4;
    }

    /// Restarts the scene. The position of the eye stays.
    fn reset(&mut self) {
        match (self.start)(&self.scene, self.scalar) {
            Ok(simulation) => {
                self.simulation = simulation;
                self.strain = Watched::start(&*self.simulation);
                (self.corner, self.weather, self.paused) = (0, Weather::of(&self.scene), false);
                self.pressed = None;
                self.complaint.clear();
            }
            Err(error) => self.complaint = error.to_string(),
        }
    }

    /// Continues with another solver or number type.
    fn change(&mut self, kind: SolverKind, scalar: ScalarKind) {
        let before = std::mem::replace(&mut self.scene.solver.kind, kind);
        match (self.start)(&self.scene, scalar) {
            Ok(mut simulation) => {
                if self.simulation.is_finite() {
                    simulation.restore(&self.simulation.state());
                }
                (self.simulation, self.scalar) = (simulation, scalar);
                self.complaint.clear();
                self.apply();
                self.hold_on();
            }
            Err(error) => {
                self.scene.solver.kind = before;
                self.complaint = error.to_string();
            }
        }
    }

    /// Sets gravity and wind as the keys have changed them.
    fn apply(&mut self) {
        let result = self.simulation.set_wind(self.weather.wind(&self.scene).as_ref());
        match result.and_then(|()| self.simulation.set_gravity(self.weather.gravity(&self.scene))) {
            Ok(()) => self.complaint.clear(),
            Err(error) => self.complaint = error.to_string(),
        }
    }
}

/// The start moved down by the longer side of the sheet, but not below a plane: the view contains both.
fn fallen(scene: &Description, start: &Still) -> Still {
    let mut still = start.clone();
    let depth = scene.sheet.height.max(scene.sheet.width);
    let floor = scene.planes.iter().map(|plane| plane.point[2]).fold(f64::MIN, f64::max);
    for [_, _, z] in &mut still.positions {
        *z = (*z - depth).max(floor.min(*z));
    }
    still
}

/// The member after `current`, cyclically.
fn next<T: Copy + PartialEq, const N: usize>(all: &[T; N], current: T) -> T {
    let index = all.iter().position(|member| *member == current).unwrap_or_default();
    all[(index + 1) % N]
}
