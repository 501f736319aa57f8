//! The scene with all that keys and pointers change.

use std::fmt;

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::{DrawTarget, DrawTargetExt};
use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::{Circle, Primitive, PrimitiveStyle};
use kerchief::host::{Description, Grip, Painter, ScalarKind, Simulation, SolverKind, Still};
use kerchief::render::Orbit;

use super::caption::{Caption, PICTURE};
use super::pointer::{Button, Held, Pointer, Pressed, factor};
use super::strain::{Watched, percent};
use super::weather::Weather;
use crate::Start;

/// A mark on the particle in the hand.
const HAND: Rgb888 = Rgb888::new(232, 163, 61);
const HAND_SIZE: u32 = 9;

/// What a key asks for.
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

/// A scene in motion, and where it is looked at from.
pub struct Stage<'a> {
    scene: Description,
    scalar: ScalarKind,
    start: Start,
    painter: Painter<'a>,
    orbit: Orbit,
    simulation: Box<dyn Simulation>,
    strain: Watched,
    /// The corner that is pinned or released next.
    corner: usize,
    weather: Weather,
    paused: bool,
    pressed: Option<Pressed>,
    /// What could not be done.
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

    /// Moves on by a frame, unless it is paused.
    pub fn advance(&mut self) {
        if !self.paused {
            self.simulation.frame();
            self.strain.follow(&*self.simulation);
        }
    }

    /// A key was pressed, or repeats itself.
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

    /// A pointer did something.
    pub fn point(&mut self, pointer: Pointer) {
        match pointer {
            Pointer::Pressed(button, at) if self.pressed.is_none() && PICTURE.contains(at) => {
                let at = at - PICTURE.top_left;
                let held = if button == Button::Left { self.grab(at) } else { None };
                self.pressed = Some(Pressed { button, at, held });
            }
            Pointer::Moved(at) => self.moved(at - PICTURE.top_left),
            Pointer::Released(button) if self.pressed.is_some_and(|pressed| pressed.button == button) => {
                self.simulation.release();
                self.pressed = None;
            }
            Pointer::Wheel(notches) => {
                self.orbit.zoom(factor(notches));
                self.painter.look(&self.orbit);
            }
            Pointer::Pressed(..) | Pointer::Released(_) => {}
        }
    }

    /// Takes hold of the particle under a pixel of the picture.
    fn grab(&mut self, at: Point) -> Option<Held> {
        if !self.simulation.is_finite() {
            return None;
        }
        let still = self.simulation.still();
        let node = self.painter.pick(&still, at)?;
        let held = Held { node, place: still.positions[node.row * self.scene.sheet.columns + node.column] };
        self.hold(held).then_some(held)
    }

    /// Whether the hand holds it.
    fn hold(&mut self, Held { node, place }: Held) -> bool {
        match self.simulation.grab(node.column, node.row, &Grip::of(&self.scene)) {
            Ok(()) => {
                self.simulation.drag(place);
                self.complaint.clear();
                true
            }
            Err(error) => {
                self.complaint = error.to_string();
                false
            }
        }
    }

    fn moved(&mut self, at: Point) {
        let Some(pressed) = &mut self.pressed else { return };
        let way = at - pressed.at;
        pressed.at = at;
        if let Some(held) = &mut pressed.held {
            held.place = self.painter.under(at, held.place);
            self.simulation.drag(held.place);
        } else {
            self.orbit.drag(f64::from(way.x), f64::from(way.y));
            self.painter.look(&self.orbit);
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

    /// Starts the scene again; it is looked at from where it was.
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

    /// Goes on with another solver or number type.
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

    /// Takes in the hand again what another simulation has had.
    fn hold_on(&mut self) {
        let Some(held) = self.pressed.and_then(|pressed| pressed.held) else { return };
        if !self.hold(held) {
            self.pressed = None;
        }
    }

    /// Sets gravity and wind as the keys have them.
    fn apply(&mut self) {
        let result = self.simulation.set_wind(self.weather.wind(&self.scene).as_ref());
        match result.and_then(|()| self.simulation.set_gravity(self.weather.gravity(&self.scene))) {
            Ok(()) => self.complaint.clear(),
            Err(error) => self.complaint = error.to_string(),
        }
    }

    /// Draws the whole window, with the rate at which its pictures are shown.
    pub fn draw<D: DrawTarget<Color = Rgb888>>(&self, rate: Option<f64>, target: &mut D) -> Result<(), D::Error> {
        let still = self.simulation.still();
        let mut picture = target.cropped(&PICTURE);
        self.painter.draw(&still, &mut picture)?;
        if let Some(held) = self.pressed.and_then(|pressed| pressed.held) {
            let place = still.positions[held.node.row * self.scene.sheet.columns + held.node.column];
            if let Some(at) = self.painter.pixel(place) {
                Circle::with_center(at, HAND_SIZE).into_styled(PrimitiveStyle::with_fill(HAND)).draw(&mut picture)?;
            }
        }
        self.caption(rate).draw(target)
    }

    fn caption(&self, rate: Option<f64>) -> Caption {
        let solver = &self.scene.solver;
        let [right, into] = self.weather.tilt;
        let state = format!(
            "{} in {}, {} substeps   wind {}   tilt {right:+.0} {into:+.0}{}",
            solver.kind.name(),
            self.scalar.name(),
            solver.substeps,
            if self.weather.windy { "on" } else { "off" },
            if self.paused { "   paused" } else { "" },
        );
        let measured = format!(
            "{} pictures a second   stretch strain {}, {} at most since the start",
            rate.map_or("-".to_string(), |rate| format!("{rate:.0}")),
            percent(self.strain.now),
            percent(self.strain.most),
        );
        let finite = if self.simulation.is_finite() { "" } else { "not finite any more: r starts again" };
        let complaint = if self.complaint.is_empty() { finite } else { &self.complaint };
        Caption { state: [state, measured], complaint: complaint.to_string() }
    }
}

/// The start, as far below as a sheet may fall: what is to be seen besides it.
fn fallen(scene: &Description, start: &Still) -> Still {
    let mut still = start.clone();
    let depth = scene.sheet.height.max(scene.sheet.width);
    let floor = scene.planes.iter().map(|plane| plane.point[2]).fold(f64::MIN, f64::max);
    for [_, _, z] in &mut still.positions {
        *z = (*z - depth).max(floor.min(*z));
    }
    still
}

/// The member after `current`, around.
fn next<T: Copy + PartialEq, const N: usize>(all: &[T; N], current: T) -> T {
    let index = all.iter().position(|member| *member == current).unwrap_or_default();
    all[(index + 1) % N]
}

#[cfg(test)]
mod tests;
