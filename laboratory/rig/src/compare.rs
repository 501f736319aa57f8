//! Distances between two motions.

use super::Motion;
use crate::reference::vector::{add, scale};
use crate::reference::{Model, Solution, State, Vector, rms_distance};

/// RMS distance between two states of a sheet, divided by its size.
pub fn error(model: &Model, a: &State, b: &State) -> f64 {
    rms_distance(&a.position, &b.position) / model.sheet.size()
}

/// The largest [`error`] of a motion at the times of `exact`. These must be ends of frames of `frame` seconds.
pub fn largest_error(model: &Model, exact: &Solution, frame: f64, motion: &mut dyn Motion) -> f64 {
    let mut frames = 0;
    let errors = exact.times.iter().zip(&exact.states).map(|(time, state)| {
        let end = (time / frame).round() as u32;
        motion.run(end - frames);
        frames = end;
        error(model, &motion.state(), state)
    });
    // A motion that blew up has an undefined error, which `f64::max` would ignore: it counts as infinite.
    errors.fold(0.0, |largest, e| if e.is_nan() { f64::INFINITY } else { e.max(largest) })
}

/// The ends of the first frames of 0.1 s.
pub fn tenths(frames: u32) -> Vec<f64> {
    (1..=frames).map(|frame| f64::from(frame) * 0.1).collect()
}

/// The start with every free particle displaced by up to a tenth of a cell along each axis and moving, without any symmetry.
pub fn stirred(model: &Model) -> State {
    let mut state = model.start();
    let amount = 0.1 * model.sheet.cell().into_iter().fold(0.0, f64::max);
    for i in free(model) {
        let wave = |a: f64, b: f64| (a * i as f64 + b).sin();
        state.position[i] = add(state.position[i], scale(amount, [wave(1.1, 0.2), wave(2.3, 1.0), wave(3.7, 0.5)]));
        state.velocity[i] = scale(4.0 * amount, [wave(0.7, 2.0), wave(1.9, 0.1), wave(2.9, 1.3)]);
    }
    state
}

/// The start with the same velocity for all particles, including pins.
pub fn carried(model: &Model, velocity: Vector) -> State {
    let mut state = model.start();
    state.velocity.fill(velocity);
    state
}

/// Indices of the particles that are not pinned.
pub fn free(model: &Model) -> impl Iterator<Item = usize> {
    let pins: Vec<usize> = model.sheet.pins.iter().map(|&pin| model.sheet.index(pin)).collect();
    (0..model.sheet.particles()).filter(move |i| !pins.contains(i))
}

/// The largest strain `||d|/L - 1|` of the links with this offset.
pub fn strain(model: &Model, state: &State, offset: (i32, i32)) -> f64 {
    let rest = model.sheet.positions();
    let length =
        |x: &[Vector], i: usize, j: usize| crate::reference::vector::norm(crate::reference::vector::sub(x[i], x[j]));
    let links = (0..model.sheet.particles()).filter_map(|i| Some((i, model.sheet.neighbour(i, offset)?)));
    links.map(|(i, j)| (length(&state.position, i, j) / length(&rest, i, j) - 1.0).abs()).fold(0.0, f64::max)
}
