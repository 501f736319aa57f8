//! The Waveshare RP2040-LCD-1.28 in rp2040js: a round LCD, and an accelerometer that measures the movements of a hand.

use std::path::Path;

use image::{Rgb, RgbImage};
use serde::Serialize;

use crate::board::lcd::{self, Run, SIDE};
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("boards/tilt", "tilt", &["thumbv6m-none-eabi"]);

/// A gesture. A row is the time since the start, s, and the reading of the accelerometer along its three axes, in g. Between two rows readings are interpolated linearly.
pub type Gesture = Vec<[f64; 4]>;

/// The plan of a run. Pictures are counted from one.
#[derive(Clone, Debug, Serialize)]
pub struct Plan {
    /// The step whose picture is the last. `None`: until the kerchief is at rest after the gesture.
    pub until: Option<u32>,
    /// Pictures after which the display is recorded, in addition to the last. `None`: all.
    pub shots: Option<Vec<usize>>,
    /// Whether reads from the flash go through a model of its cache. Otherwise they take no additional time.
    pub cached: bool,
    /// The movements of the hand.
    pub gesture: Gesture,
    /// Whether the board has a sensor.
    pub sensor: bool,
}

impl Default for Plan {
    fn default() -> Self {
        Self { until: None, shots: Some(Vec::new()), cached: false, gesture: gesture(), sensor: true }
    }
}

/// The gesture of `tilt.csv`: from a table into a hand, tilted to the left and to the right, upright, flat and shaken, and back onto the table. It was computed from angles and a
/// hand's tremble, not recorded on a board.
///
/// # Panics
///
/// If `tilt.csv` is malformed.
pub fn gesture() -> Gesture {
    let rows = include_str!("tilt.csv").lines().skip(1);
    let row = |line: &str| -> Option<[f64; 4]> {
        line.split(',').map(|cell| cell.parse().ok()).collect::<Option<Vec<_>>>()?.try_into().ok()
    };
    rows.map(|line| row(line).expect("four numbers")).collect()
}

/// Runs a program, and passes the step of every picture to `shown`.
///
/// # Errors
///
/// If the program or the emulator fails. Complaints of the display, the sensor and the chip are in [`Run::errors`] instead.
pub fn run(path: &Path, plan: &Plan, shown: impl FnMut(u32)) -> Result<Run> {
    lcd::run("tilt.mjs", path, plan, shown)
}

/// The visible part of the display's memory: a disk.
pub fn picture(shot: &[u16]) -> RgbImage {
    let mut picture = lcd::picture(shot);
    // coordinates in half pixels
    let from_middle = |place: u32| i64::from(2 * place + 1) - i64::from(SIDE);
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        let [x, y] = [x, y].map(from_middle);
        if x * x + y * y > i64::from(SIDE * SIDE) {
            *pixel = Rgb([0; 3]);
        }
    }
    picture
}
