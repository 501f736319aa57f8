//! The Raspberry Pi Pico in rp2040js.

use std::path::Path;

use serde::Serialize;

use crate::board::lcd::{self, Run};
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("examples/pico", "pico", &["thumbv6m-none-eabi"]);

/// What is done while the program runs: pictures are counted from one.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Plan {
    /// The step whose picture is the last; without one, the sheet comes to rest.
    pub until: Option<u32>,
    /// After which pictures, beside the last, the display is looked at.
    pub shots: Vec<usize>,
    /// After which pictures the button goes down or up.
    pub presses: Vec<(usize, bool)>,
    /// Whether what is read from the flash comes through a model of its cache, or at once.
    pub cached: bool,
}

/// Runs a program, and tells `shown` after every picture which step it shows.
///
/// # Errors
///
/// What is wrong with the program or the emulator. What the display and the chip found wrong is in the [`Run`].
pub fn run(path: &Path, plan: &Plan, shown: impl FnMut(u32)) -> Result<Run> {
    lcd::run("pico.mjs", path, plan, shown)
}
