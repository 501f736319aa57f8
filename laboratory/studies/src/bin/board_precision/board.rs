//! Cost of frames on a board, and their errors.

use std::path::Path;
use std::process::{Command, Stdio};

use emulator::machine::{M0, M3, M4F, Machine};
use emulator::{Firmware, Programs};
use instances::simulation;
use kerchief::host::{Description, ScalarKind};
use rayon::prelude::*;
use serde::Serialize;

use laboratory::configuration::Configuration;
use laboratory::measurement::Measurement;
use laboratory::page::scientific;
use laboratory::reference::Reference;
use laboratory::scenes::named;

/// The scene of the firmware.
pub(crate) const SCENE: &str = "two-corners-16";
/// Tolerance of the reference, sheet sizes.
const CONVERGED: f64 = 2e-6;

/// An emulated processor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Board {
    machine: Machine,
    /// Its name in file names.
    pub(crate) short: &'static str,
}

pub(crate) const BOARDS: [Board; 3] =
    [Board { machine: M0, short: "m0" }, Board { machine: M3, short: "m3" }, Board { machine: M4F, short: "m4f" }];

/// The cost of a setting.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cost {
    board: Board,
    configuration: Configuration,
    /// Instructions of a frame for the whole sheet.
    instructions: f64,
    /// Digest of the sheet after the last frame.
    digest: u32,
}

/// Cost and error of a setting.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) board: Board,
    pub(crate) configuration: Configuration,
    pub(crate) instructions: f64,
    pub(crate) error: f64,
    strain: f64,
}

/// Fails with the name of a missing tool.
pub(crate) fn tools() -> Result<(), String> {
    for (tool, package) in
        [("rustup", "see https://rustup.rs"), ("qemu-system-arm", "Debian's package qemu-system-arm")]
    {
        let found = Command::new(tool).arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
        if !found.is_ok_and(|status| status.success()) {
            return Err(format!("{tool} is not there ({package})"));
        }
    }
    Ok(())
}

/// The programs of a number type, by target. A small flash has no space for all number types.
pub(crate) fn programs(number: ScalarKind) -> Result<Programs, String> {
    let targets = BOARDS.map(|board| board.machine.target);
    Firmware::measuring("precision", &targets, [Some(number.name()), None]).build().map_err(|error| error.to_string())
}

impl Board {
    pub(crate) fn name(&self) -> &'static str {
        self.machine.name
    }

    /// The costs of all settings of a number type.
    pub(crate) fn costs(self, programs: &Programs) -> Result<Vec<Cost>, String> {
        let printed = self.machine.run_counted(&programs[self.machine.target]).map_err(|error| error.to_string())?;
        let cost = |line: &str| {
            let mut fields = line.split("; ");
            let words: Vec<_> = fields.next()?.split(' ').map(str::to_owned).collect();
            Some(Cost {
                board: self,
                configuration: Configuration::from_words(&words)?,
                instructions: fields.next()?.parse().ok()?,
                digest: u32::from_str_radix(fields.next()?, 16).ok()?,
            })
        };
        printed.lines().map(|line| cost(line).ok_or_else(|| format!("{} prints {line:?}", self.name()))).collect()
    }
}

/// The errors of the settings. They are measured on the host, whose sheets equal those of the board to the last bit.
pub(crate) fn errors(costs: &[Cost], cache: &Path) -> Result<Vec<Point>, String> {
    let text = named().into_iter().find(|scene| scene.name == SCENE).expect("a scene of the laboratory").text;
    let scene = Description::parse(text).map_err(|error| error.to_string())?;
    let reference = Reference::of(simulation, text, &scene, scene.frames, CONVERGED, cache)?;
    let point = |cost: &Cost| {
        let Cost { board, configuration, instructions, digest } = *cost;
        let seen = Measurement::of(simulation, &scene, configuration, scene.frames, Some(&reference.positions))
            .map_err(|error| error.to_string())?;
        if seen.strain.is_finite() && seen.digest != digest {
            return Err(format!("{configuration}: {} moves the sheet otherwise than this machine", board.name()));
        }
        let error = seen.error.unwrap_or(f64::NAN);
        Ok(Point { board, configuration, instructions, error, strain: seen.strain })
    };
    costs.par_iter().map(point).collect()
}

/// A row of the table of all points.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    processor: &'static str,
    solver: &'static str,
    scalar: &'static str,
    substeps: u32,
    sweeps: u32,
    tolerance: Option<f64>,
    instructions: f64,
    error: String,
    strain: String,
}

impl Point {
    pub(crate) fn row(&self) -> Row {
        let Configuration { solver, scalar, substeps, sweeps, tolerance } = self.configuration;
        let [error, strain] = [self.error, self.strain].map(scientific);
        let (solver, scalar) = (solver.name(), scalar.name());
        let processor = self.board.name();
        Row { processor, solver, scalar, substeps, sweeps, tolerance, instructions: self.instructions, error, strain }
    }
}
