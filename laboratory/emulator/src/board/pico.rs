//! The Raspberry Pi Pico in rp2040js.

use std::path::Path;

use serde::Serialize;

use crate::board::lcd::{self, Run};
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("examples/pico", "pico", &["thumbv6m-none-eabi"]);

/// The plan of a run. Pictures are counted from one.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Plan {
    /// The step whose picture is the last. `None`: until the sheet is at rest.
    pub until: Option<u32>,
    /// Pictures after which the display is recorded, in addition to the last.
    pub shots: Vec<usize>,
    /// Pictures after which the button goes down (`true`) or up.
    pub presses: Vec<(usize, bool)>,
    /// Whether reads from the flash go through a model of its cache. Otherwise they take no additional time.
    pub cached: bool,
}

/// Runs a program, and passes the step of every picture to `shown`.
///
/// # Errors
///
/// If the program or the emulator fails. Complaints of the display and the chip are in [`Run::errors`] instead.
pub fn run(path: &Path, plan: &Plan, shown: impl FnMut(u32)) -> Result<Run> {
    lcd::run("pico.mjs", path, plan, shown)
}
