//! Common parts of the host programs: command-line errors of one line, scenes by name, files that appear only when they are complete.
#![allow(
    missing_docs,
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    reason = "not published: names and signatures say it"
)]

pub mod live;
pub mod staging;
pub mod studio;

use std::ffi::OsStr;
use std::fs::File;
use std::io::{self, Read, Write};
use std::path::Path;
use std::process::ExitCode;

use clap::Parser;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use indicatif::{ProgressBar, ProgressStyle};
use kerchief::host::{BuiltIn, Description, ScalarKind, SceneError, Simulation, SolverKind};

pub use kerchief::host::printable;

/// The largest accepted scene file, MB of 2²⁰ bytes. No scene is that large, but a device file may be endless.
const LARGEST: u64 = 16;

/// Starts a scene in a number type, on one of the grids that a program is compiled for.
pub type Start = fn(&Description, ScalarKind) -> Result<Box<dyn Simulation>, SceneError>;

/// The reason why a program fails.
#[derive(Debug)]
pub enum Failure {
    /// The program could not do its task: exit status 2.
    Refused(String),
    /// The program has run, but the sheet exploded: exit status 3.
    Exploded(String),
}

impl From<String> for Failure {
    fn from(reason: String) -> Self {
        Self::Refused(reason)
    }
}

/// Turns a result into an exit status. A failure is written to stderr as one line.
pub fn exit(result: Result<(), impl Into<Failure>>) -> ExitCode {
    let Err(failure) = result else { return ExitCode::SUCCESS };
    let (reason, status) = match failure.into() {
        Failure::Refused(reason) => (reason, 2),
        Failure::Exploded(reason) => (reason, 3),
    };
    // A closed stderr is no reason to panic.
    let _ = writeln!(io::stderr(), "error: {}", printable(&reason));
    ExitCode::from(status)
}

/// Writes a line to stdout.
pub fn say(line: &str) {
    // A closed stdout is no reason to panic.
    let _ = writeln!(io::stdout(), "{line}");
}

/// Reads the command line. An error is one line with its reason. `--help` and `--version` print their text and exit.
pub fn read<A: Parser>() -> Result<A, String> {
    A::try_parse().map_err(|error| {
        if !error.use_stderr() {
            error.exit();
        }
        let text = error.render().to_string();
        // The first paragraph has the reason and the possible values; hints and usage follow.
        let reason: Vec<_> = text.lines().map(str::trim).take_while(|line| !line.is_empty()).collect();
        reason.join(" ").trim_start_matches("error: ").to_string()
    })
}

/// Parser for the name of a number type.
pub fn scalar_kind() -> impl TypedValueParser<Value = ScalarKind> {
    PossibleValuesParser::new(ScalarKind::ALL.map(ScalarKind::name))
        .map(|name| ScalarKind::from_name(&name).expect("one of the names above"))
}

/// Parser for the name of a solver.
pub fn solver_kind() -> impl TypedValueParser<Value = SolverKind> {
    PossibleValuesParser::new(SolverKind::ALL.map(SolverKind::name))
        .map(|name| SolverKind::from_name(&name).expect("one of the names above"))
}

/// The text and the description of the scene with this name among `named`, or else of the scene in this file. A file name need not be valid UTF-8.
pub fn load(scene: impl AsRef<OsStr>, named: &[BuiltIn]) -> Result<(String, Description), String> {
    let scene = scene.as_ref();
    let shown = scene.display();
    let text = match named.iter().find(|named| named.name == scene) {
        Some(scene) => scene.text.to_string(),
        None => read_scene(scene).map_err(|error| {
            let is_name = scene.to_str().is_some_and(|scene| !scene.contains(['.', '/', '\\']));
            if error.kind() == io::ErrorKind::NotFound && is_name {
                let names: Vec<_> = named.iter().map(|scene| scene.name).collect();
                format!("no scene or file \"{shown}\"; built-in scenes: {}", names.join(", "))
            } else {
                format!("{shown}: {error}")
            }
        })?,
    };
    let mut description = Description::parse(&text).map_err(|error| format!("{shown}: {error}"))?;
    if description.name.is_empty() {
        description.name = Path::new(scene).file_stem().unwrap_or_default().to_string_lossy().into_owned();
    }
    Ok((text, description))
}

fn read_scene(path: &OsStr) -> io::Result<String> {
    let mut bytes = Vec::new();
    let most = LARGEST << 20;
    if File::open(path)?.take(most + 1).read_to_end(&mut bytes)? as u64 > most {
        return Err(io::Error::other(format!("larger than {LARGEST} MB")));
    }
    String::from_utf8(bytes).map_err(|_| io::Error::other("not UTF-8"))
}

/// A progress bar on stderr; it is hidden if stderr is no terminal.
pub fn progress(what: &'static str, length: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:>8} {wide_bar} {pos}/{len} {eta}").expect("a template");
    ProgressBar::new(length).with_style(style).with_message(what)
}

/// Parses a finite number above zero.
pub fn positive(text: &str) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "not a number".to_string())?;
    if number > 0.0 && number.is_finite() { Ok(number) } else { Err("must be finite and above zero".to_string()) }
}
