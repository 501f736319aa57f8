//! An RP2040 with an LCD of 240 × 240 pixels in rp2040js.

use std::fs;
use std::path::Path;

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use image::{Rgb, RgbImage};
use serde::{Deserialize, Serialize};

use crate::Result;
use crate::board::rp2040;
use crate::program::{PAINT, Program};

/// Side of the display, pixels.
pub const SIDE: u32 = 240;

/// Observations of a run.
#[derive(Debug)]
pub struct Run {
    /// The step that each picture shows.
    pub steps: Vec<u32>,
    /// The pixels of the display, row by row, for each requested picture and the last state.
    pub shots: Vec<Vec<u16>>,
    /// The lines of the log.
    pub log: Vec<String>,
    /// Bytes of stack that were used, and the size of the stack.
    pub stack: [usize; 2],
    /// If the run ended at rest: bytes that the display received in the last second, and cycles of the processor awake in it.
    pub idle: Option<[u32; 2]>,
    /// Clock frequency of the processor, Hz.
    pub frequency: u32,
    /// The readings of a sensor: seconds since the start, and three axes.
    pub readings: Vec<(f64, [i16; 3])>,
    /// Errors in the program's use of the display, the sensor or the chip.
    pub errors: Vec<String>,
}

#[derive(Deserialize)]
struct Output {
    steps: Vec<u32>,
    shots: Vec<Vec<u16>>,
    log: Vec<u8>,
    stack: Vec<u8>,
    on: bool,
    idle: Option<[u32; 2]>,
    frequency: u32,
    #[serde(default)]
    readings: Vec<(f64, i16, i16, i16)>,
    errors: Vec<String>,
}

/// Runs a program by one of the scripts beside this file, and passes the step of every picture to `shown`. `plan` has the orders of `lcd.mjs` and of the script, except addresses.
///
/// # Errors
///
/// If the program or the emulator fails. Complaints of the display and the chip are in [`Run::errors`] instead.
pub(crate) fn run(script: &str, path: &Path, plan: &impl Serialize, shown: impl FnMut(u32)) -> Result<Run> {
    let program = Program::read(path)?;
    let work = tempfile::tempdir()?;
    let orders = work.path().join("orders");
    let mut order = serde_json::to_value(plan)?;
    order["stop"] = program.address("shown")?.into();
    order["failed"] = program.address("HardFault")?.into();
    order["log"] = program.address("_SEGGER_RTT")?.into();
    order["stack"] = vec![program.address("_stack_end")?, program.address("_stack_start")?].into();
    fs::write(&orders, order.to_string())?;
    let seen = rp2040::run(script, path, &orders, shown)?;
    let mut output: Output = serde_json::from_slice(&seen)?;
    if !output.on {
        output.errors.push("the display is off".into());
    }
    let unused = output.stack.chunks_exact(4).take_while(|word| **word == PAINT.to_le_bytes()).count() * 4;
    Ok(Run {
        steps: output.steps,
        shots: output.shots,
        log: program.decode(&output.log)?,
        stack: [output.stack.len() - unused, output.stack.len()],
        idle: output.idle,
        frequency: output.frequency,
        readings: output.readings.into_iter().map(|(then, x, y, z)| (then, [x, y, z])).collect(),
        errors: output.errors,
    })
}

/// Converts the pixels of a display to a picture.
pub fn picture(shot: &[u16]) -> RgbImage {
    RgbImage::from_fn(SIDE, SIDE, |x, y| {
        let color = Rgb888::from(Rgb565::from(RawU16::new(shot[(y * SIDE + x) as usize])));
        Rgb([color.r(), color.g(), color.b()])
    })
}
