//! Plays and draws sheets on a host, and prints their digests and pixel hashes as JSON. The page in a browser must reproduce them.

use std::io::{Result, Write, stdout};

use kerchief::{Q13, Q24, Scalar};
use playground::eye;
use playground::frame::Frame;
use playground::play;
use playground::settings::{Number, Settings, Solver, Start};

/// Frames of a run.
const FRAMES: u32 = 40;
/// Pixels of the picture.
const PICTURE: (u32, u32) = (240, 180);

fn main() -> Result<()> {
    let mut out = stdout().lock();
    let mut lines = Vec::new();
    for solver in Solver::ALL {
        // Explicit solvers need shorter steps.
        let substeps = match solver {
            Solver::ForwardEuler | Solver::Leapfrog => 64,
            _ => 6,
        };
        let settings = Settings { solver, substeps, wind: 2.0, ball: true, ..Settings::DEFAULT };
        lines.push(line::<f32>(&settings, Number::F32, "f32"));
        lines.push(line::<f64>(&settings, Number::F64, "f64"));
        lines.push(line::<Q24>(&settings, Number::Q24, "q24"));
        lines.push(line::<Q13>(&settings, Number::Q13, "q13"));
    }
    writeln!(out, "[\n{}\n]", lines.join(",\n"))
}

/// A sheet's settings as an address of the page, with the expected fate, digest and pixels.
fn line<S: Scalar>(settings: &Settings, number: Number, name: &str) -> String {
    let settings = Settings { number, ..*settings };
    let mut sheet = match play::start::<S, 16, 4>(&settings) {
        Ok(sheet) => sheet,
        Err(refusal) => panic!("{name} does not represent {refusal:?}"),
    };
    for _ in 0..FRAMES {
        sheet.frame();
    }
    let mut frame = Frame::default();
    let (width, height) = PICTURE;
    frame.resize(width, height);
    sheet.shown().draw(&eye::START, false, &mut frame);
    let Settings { solver, substeps, start, wind, .. } = settings;
    assert!(start == Start::Corners && settings.ball, "the address below has these values");
    let query =
        format!("solver={}&number={name}&substeps={substeps}&wind={wind}&ball=1&frames={FRAMES}", solver.name());
    format!(
        "{{ \"query\": \"{query}\", \"fate\": {}, \"digest\": \"{:08x}\", \"width\": {width}, \"height\": {height}, \"pixels\": \"{:08x}\" }}",
        sheet.shown().fate() as u32,
        sheet.digest(),
        frame.hash()
    )
}
