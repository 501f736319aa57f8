//! The Waveshare RP2040-LCD-1.28 in rp2040js: a round LCD, and a sensor in somebody's hand.

use std::path::Path;

use image::{Rgb, RgbImage};
use serde::Serialize;

use crate::board::lcd::{self, Run, SIDE};
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("boards/tilt", "tilt", &["thumbv6m-none-eabi"]);

/// A gesture: seconds since the start, and what the sensor feels along its axes, in parts of a weight. Between two rows it changes evenly.
pub type Gesture = Vec<[f64; 4]>;

/// What is done while the program runs: pictures are counted from one.
#[derive(Clone, Debug, Serialize)]
pub struct Plan {
    /// The step whose picture is the last; without one, the kerchief comes to rest after the gesture.
    pub until: Option<u32>,
    /// After which pictures, beside the last, the display is looked at; all, if nothing is said.
    pub shots: Option<Vec<usize>>,
    /// Whether what is read from the flash comes through a model of its cache, or at once.
    pub cached: bool,
    /// What the hand does.
    pub gesture: Gesture,
    /// Whether there is a sensor to feel it.
    pub sensor: bool,
}

impl Default for Plan {
    fn default() -> Self {
        Self { until: None, shots: Some(Vec::new()), cached: false, gesture: gesture(), sensor: true }
    }
}

/// From a table into a hand, to the left and to the right, upright, flat and shaken, and back onto the table. It was made from angles and a hand's tremble: no board was there to
/// record one.
///
/// # Panics
///
/// If the file is broken.
pub fn gesture() -> Gesture {
    let rows = include_str!("tilt.csv").lines().skip(1);
    let row = |line: &str| -> Option<[f64; 4]> {
        line.split(',').map(|cell| cell.parse().ok()).collect::<Option<Vec<_>>>()?.try_into().ok()
    };
    rows.map(|line| row(line).expect("four numbers")).collect()
}

/// Runs a program, and tells `shown` after every picture which step it shows.
///
/// # Errors
///
/// What is wrong with the program or the emulator. What the display, the sensor and the chip found wrong is in the [`Run`].
pub fn run(path: &Path, plan: &Plan, shown: impl FnMut(u32)) -> Result<Run> {
    lcd::run("tilt.mjs", path, plan, shown)
}

/// What is seen of the display's memory: a disk.
pub fn picture(shot: &[u16]) -> RgbImage {
    let mut picture = lcd::picture(shot);
    // places in halves of a pixel
    let from_middle = |place: u32| i64::from(2 * place + 1) - i64::from(SIDE);
    for (x, y, pixel) in picture.enumerate_pixels_mut() {
        let [x, y] = [x, y].map(from_middle);
        if x * x + y * y > i64::from(SIDE * SIDE) {
            *pixel = Rgb([0; 3]);
        }
    }
    picture
}
