//! A live window.

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::time::{Duration, Instant};

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mono_font::{MonoTextStyle, ascii::FONT_7X13};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::text::Text;
use embedded_graphics::{Drawable, draw_target::DrawTarget};
use embedded_graphics_simulator::sdl2::Keycode;
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay, SimulatorEvent, Window};
use instances::simulation;
use kerchief::host::{Description, Painter, ScalarKind, Simulation, SolverKind, Still, Wind, WindModel};

const SIDE: u32 = 640;
/// A key turns gravity by so much, degrees.
const TILT: f64 = 5.0;
/// Frames that may be computed for one picture, so that the motion keeps up with the clock.
const MOST_FRAMES: u32 = 4;
const KEYS: &str = "p pin  w wind  arrows tilt  s solver  n number  space pause  r reset  q quit";

/// Runs `scene` in a window until it is closed.
pub(crate) fn run(scene: Description, scalar: ScalarKind) -> Result<(), String> {
    let mut stage = Stage::new(scene, scalar)?;
    let scene = stage.scene.clone();
    let still = stage.simulation.still();
    let size = Size::new(SIDE, SIDE);
    let painter = Painter::new(&scene, &[fallen(&scene, &still), still], size).map_err(|error| error.to_string())?;
    let mut display = SimulatorDisplay::with_default_color(size, Rgb888::BLACK);
    let mut window = Window::new(&format!("kerchief: {}", scene.name), &OutputSettings::default());
    open(&mut window, &display)?;

    let step = Duration::from_secs_f64(scene.solver.step.min(3600.0));
    let mut due = Instant::now();
    loop {
        for event in window.events() {
            match event {
                SimulatorEvent::Quit | SimulatorEvent::KeyDown { keycode: Keycode::Q | Keycode::Escape, .. } => {
                    return Ok(());
                }
                SimulatorEvent::KeyDown { keycode, repeat, .. } => stage.key(keycode, repeat),
                _ => {}
            }
        }
        let mut frames = 0;
        while due <= Instant::now() && frames < MOST_FRAMES {
            stage.advance();
            due += step;
            frames += 1;
        }
        if frames == MOST_FRAMES {
            // Too slow for the clock: go on from here instead of running after it.
            due = Instant::now();
        }
        let Ok(()) = painter.draw(&stage.simulation.still(), &mut display);
        let Ok(()) = stage.caption(&mut display);
        window.update(&display);
    }
}

/// Opens the window: SDL panics where there is no screen.
fn open(window: &mut Window, display: &SimulatorDisplay<Rgb888>) -> Result<(), String> {
    let hook = take_hook();
    set_hook(Box::new(|_| {}));
    let opened = catch_unwind(AssertUnwindSafe(|| window.update(display)));
    set_hook(hook);
    opened.map_err(|_| "--window: cannot open a window on this screen".to_string())
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

/// The scene with all that keys change.
struct Stage {
    scene: Description,
    scalar: ScalarKind,
    simulation: Box<dyn Simulation>,
    /// The corner that is pinned or released next.
    corner: usize,
    windy: bool,
    /// Gravity turned about the picture's axes into and across it, degrees.
    tilt: [f64; 2],
    paused: bool,
    /// What could not be done.
    complaint: String,
}

impl Stage {
    fn new(scene: Description, scalar: ScalarKind) -> Result<Self, String> {
        let simulation = simulation(&scene, scalar).map_err(|error| error.to_string())?;
        let windy = scene.wind.is_some();
        let complaint = String::new();
        Ok(Self { scene, scalar, simulation, corner: 0, windy, tilt: [0.0; 2], paused: false, complaint })
    }

    fn advance(&mut self) {
        if !self.paused {
            self.simulation.frame();
        }
    }

    fn key(&mut self, key: Keycode, repeat: bool) {
        match key {
            Keycode::Left => self.turn(0, -TILT),
            Keycode::Right => self.turn(0, TILT),
            Keycode::Up => self.turn(1, TILT),
            Keycode::Down => self.turn(1, -TILT),
            _ if repeat => {}
            Keycode::Space => self.paused = !self.paused,
            Keycode::P => self.pin(),
            Keycode::W => {
                self.windy = !self.windy;
                self.apply();
            }
            Keycode::S => {
                let kind = next(&SolverKind::ALL, self.scene.solver.kind);
                self.change(kind, self.scalar);
            }
            Keycode::N => self.change(self.scene.solver.kind, next(&ScalarKind::ALL, self.scalar)),
            Keycode::R => match Self::new(self.scene.clone(), self.scalar) {
                Ok(stage) => *self = stage,
                Err(complaint) => self.complaint = complaint,
            },
            _ => {}
        }
    }

    fn turn(&mut self, axis: usize, by: f64) {
        self.tilt[axis] = (self.tilt[axis] + by).clamp(-90.0, 90.0);
        self.apply();
    }

    fn pin(&mut self) {
        let (right, bottom) = (self.scene.sheet.columns - 1, self.scene.sheet.rows - 1);
        let [column, row] = [[0, 0], [right, 0], [right, bottom], [0, bottom]][self.corner];
        let pinned = self.simulation.state().pinned[row * self.scene.sheet.columns + column];
        self.simulation.set_pinned(column, row, !pinned);
        self.corner = (self.corner + 1) % 4;
    }

    /// Goes on with another solver or number type.
    fn change(&mut self, kind: SolverKind, scalar: ScalarKind) {
        let before = std::mem::replace(&mut self.scene.solver.kind, kind);
        match simulation(&self.scene, scalar) {
            Ok(mut simulation) => {
                if self.simulation.is_finite() {
                    simulation.restore(&self.simulation.state());
                }
                (self.simulation, self.scalar) = (simulation, scalar);
                self.complaint.clear();
                self.apply();
            }
            Err(error) => {
                self.scene.solver.kind = before;
                self.complaint = error.to_string();
            }
        }
    }

    /// Sets gravity and wind as the keys have them.
    fn apply(&mut self) {
        let wind = self.scene.wind.unwrap_or(Wind {
            velocity: self.picture([3.0, 2.0, 0.0]),
            model: WindModel::Aerodynamic { density: 1.2, drag_coefficient: 1.2 },
        });
        let gravity = self.gravity();
        let result = self.simulation.set_wind(self.windy.then_some(&wind));
        match result.and_then(|()| self.simulation.set_gravity(gravity)) {
            Ok(()) => self.complaint.clear(),
            Err(error) => self.complaint = error.to_string(),
        }
    }

    fn gravity(&self) -> [f64; 3] {
        let [[sx, cx], [sy, cy]] = self.tilt.map(|degrees| [degrees.to_radians().sin(), degrees.to_radians().cos()]);
        let [x, y, z] = self.scene.gravity;
        let pull = (x * x + y * y + z * z).sqrt();
        let tilt = self.picture([pull * sx * cy, pull * sy, 0.0]);
        // Upright, gravity is the scene's own.
        if self.tilt == [0.0; 2] { [x, y, z] } else { [tilt[0], tilt[1], -pull * cx * cy] }
    }

    /// A level vector to the right of, into, and up in the picture.
    fn picture(&self, [right, into, up]: [f64; 3]) -> [f64; 3] {
        let (sin, cos) = self.scene.picture.azimuth.to_radians().sin_cos();
        [right * cos - into * sin, right * sin + into * cos, up]
    }

    fn caption<D: DrawTarget<Color = Rgb888>>(&self, target: &mut D) -> Result<(), D::Error> {
        let style = MonoTextStyle::new(&FONT_7X13, Rgb888::new(60, 64, 72));
        let solver = &self.scene.solver;
        let state = format!(
            "{} in {}, {} substeps   wind {}   tilt {:+.0} {:+.0}{}",
            solver.kind.name(),
            self.scalar.name(),
            solver.substeps,
            if self.windy { "on" } else { "off" },
            self.tilt[0],
            self.tilt[1],
            if self.paused { "   paused" } else { "" },
        );
        let finite = if self.simulation.is_finite() { "" } else { "not finite any more: r starts again" };
        let complaint = if self.complaint.is_empty() { finite } else { &self.complaint };
        Text::new(&state, Point::new(8, 18), style).draw(target)?;
        Text::new(complaint, Point::new(8, 36), MonoTextStyle::new(&FONT_7X13, Rgb888::new(170, 30, 30)))
            .draw(target)?;
        Text::new(KEYS, Point::new(8, SIDE as i32 - 8), style).draw(target).map(drop)
    }
}

/// The member after `current`, around.
fn next<T: Copy + PartialEq, const N: usize>(all: &[T; N], current: T) -> T {
    let index = all.iter().position(|member| *member == current).unwrap_or_default();
    all[(index + 1) % N]
}
