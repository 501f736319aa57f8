//! A live window: passes SDL's events to the stage, and the stage's pictures to SDL.

use std::panic::{AssertUnwindSafe, catch_unwind, set_hook, take_hook};
use std::time::Instant;

use console::live::{Button, Clock, Key, Pointer, Rate, SIZE, Stage};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics_simulator::sdl2::{Keycode, MouseButton, MouseWheelDirection};
use embedded_graphics_simulator::{OutputSettings, SimulatorDisplay, SimulatorEvent, Window};
use instances::simulation;
use kerchief::host::{Description, ScalarKind};

/// Runs `scene` in a window until it is closed.
pub(crate) fn run(scene: &Description, scalar: ScalarKind) -> Result<(), String> {
    let mut stage = Stage::new(scene, scalar, simulation)?;
    let mut display = SimulatorDisplay::with_default_color(SIZE, Rgb888::BLACK);
    let mut window = Window::new(&format!("kerchief: {}", scene.name), &OutputSettings::default());
    open(&mut window, &display)?;

    let mut clock = Clock::new(scene.solver.step, Instant::now());
    let mut rate = Rate::new(Instant::now());
    loop {
        for event in window.events() {
            match event {
                SimulatorEvent::Quit | SimulatorEvent::KeyDown { keycode: Keycode::Q | Keycode::Escape, .. } => {
                    return Ok(());
                }
                SimulatorEvent::KeyDown { keycode, repeat, .. } => {
                    if let Some(key) = key(keycode) {
                        stage.key(key, repeat);
                    }
                }
                event => {
                    if let Some(pointer) = pointer(event) {
                        stage.point(pointer);
                    }
                }
            }
        }
        for _ in 0..clock.frames(Instant::now()) {
            stage.advance();
        }
        let Ok(()) = stage.draw(rate.a_second(), &mut display);
        window.update(&display);
        rate.count(Instant::now());
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

fn key(keycode: Keycode) -> Option<Key> {
    Some(match keycode {
        Keycode::Left => Key::Left,
        Keycode::Right => Key::Right,
        Keycode::Up => Key::Up,
        Keycode::Down => Key::Down,
        Keycode::Space => Key::Pause,
        Keycode::P => Key::Pin,
        Keycode::W => Key::Wind,
        Keycode::S => Key::Solver,
        Keycode::N => Key::Number,
        Keycode::R => Key::Reset,
        _ => return None,
    })
}

fn pointer(event: SimulatorEvent) -> Option<Pointer> {
    Some(match event {
        SimulatorEvent::MouseButtonDown { mouse_btn, point } => Pointer::Pressed(button(mouse_btn)?, point),
        SimulatorEvent::MouseButtonUp { mouse_btn, .. } => Pointer::Released(button(mouse_btn)?),
        SimulatorEvent::MouseMove { point } => Pointer::Moved(point),
        SimulatorEvent::MouseWheel { scroll_delta, direction } => {
            let away = f64::from(scroll_delta.y);
            Pointer::Wheel(if direction == MouseWheelDirection::Flipped { -away } else { away })
        }
        _ => return None,
    })
}

fn button(button: MouseButton) -> Option<Button> {
    match button {
        MouseButton::Left => Some(Button::Left),
        MouseButton::Right => Some(Button::Right),
        _ => None,
    }
}
