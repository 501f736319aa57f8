//! Builds firmware with the commands of its users and the oldest supported Rust. The newest release may lack a target, and published figures belong to one compiler.

use std::collections::BTreeMap;
use std::fs;
use std::io::{BufRead, BufReader, Read};
use std::path::PathBuf;
use std::process::{Command, Stdio};
use std::sync::{Arc, Mutex, PoisonError};
use std::thread;

use crate::{Result, TOOLCHAIN, root, target};

/// Programs by target.
pub type Programs = BTreeMap<String, PathBuf>;

/// A program of a package for boards.
#[derive(Clone, Copy, Debug)]
pub struct Firmware<'a> {
    /// The package's folder, from the root of the repository. Its `.cargo/config.toml` and `memory.x` configure the linker.
    pub package: &'a str,
    /// The program.
    pub program: &'a str,
    /// The cargo profile.
    pub profile: &'a str,
    /// Features of the package, separated by commas.
    pub features: &'a str,
    /// The compilation targets.
    pub targets: &'a [&'a str],
    /// The only number type and the only scene that are compiled, `None` for all: `KERCHIEF_NUMBER` and `KERCHIEF_SCENE` in the environment of the build.
    pub only: [Option<&'a str>; 2],
}

/// Programs that this process has built or that one of its threads is building, by their [`Firmware`].
static BUILT: Mutex<BTreeMap<String, Arc<Mutex<Option<Programs>>>>> = Mutex::new(BTreeMap::new());

impl<'a> Firmware<'a> {
    /// The program of a board's package.
    pub const fn board(package: &'a str, program: &'a str, targets: &'a [&'a str]) -> Self {
        Self { package, program, profile: "release", features: "", targets, only: [None; 2] }
    }

    /// A program of `laboratory/firmware`, whose board accepts every Cortex-M. `only` selects a number type and a scene.
    pub const fn measuring(program: &'a str, targets: &'a [&'a str], only: [Option<&'a str>; 2]) -> Self {
        Self { only, ..Self::board("laboratory/firmware", program, targets) }
    }

    /// Builds the program, once in the life of this process: later calls return the same files.
    ///
    /// # Errors
    ///
    /// If cargo fails, with its messages.
    pub fn build(&self) -> Result<Programs> {
        self.build_aloud(|_| {})
    }

    /// Like [`Self::build`], and passes every line of cargo's error output to `said`.
    ///
    /// # Errors
    ///
    /// If cargo fails, with its messages.
    pub fn build_aloud(&self, said: impl FnMut(&str)) -> Result<Programs> {
        // a poisoned lock is harmless: a build that panicked has stored nothing
        let own = {
            let mut built = BUILT.lock().unwrap_or_else(PoisonError::into_inner);
            Arc::clone(built.entry(format!("{self:?}")).or_default())
        };
        let mut own = own.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(programs) = &*own {
            return Ok(programs.clone());
        }
        let programs = self.cargo(said)?;
        *own = Some(programs.clone());
        Ok(programs)
    }

    fn cargo(&self, mut said: impl FnMut(&str)) -> Result<Programs> {
        let mut cargo = Command::new("rustup");
        cargo.args(["run", TOOLCHAIN, "cargo", "build", "--locked"]);
        cargo.args(["--message-format=json-render-diagnostics", "--bin", self.program, "--profile", self.profile]);
        cargo.args(["--features", self.features]).arg("--target-dir").arg(target());
        for target in self.targets {
            cargo.args(["--target", target]);
        }
        for (variable, value) in ["KERCHIEF_NUMBER", "KERCHIEF_SCENE"].into_iter().zip(self.only) {
            match value {
                Some(value) => cargo.env(variable, value),
                None => cargo.env_remove(variable),
            };
        }
        // variables that cargo has set for this process must not reach the other cargo
        for variable in ["CARGO", "RUSTC", "RUSTDOC", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "RUSTC_BOOTSTRAP"] {
            cargo.env_remove(variable);
        }
        cargo.current_dir(root().join(self.package)).stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        let mut process = cargo.spawn().map_err(|error| format!("rustup: {error}"))?;
        let (mut output, errors) =
            (process.stdout.take().ok_or("no output")?, process.stderr.take().ok_or("no errors")?);
        let messages = thread::spawn(move || {
            let mut messages = String::new();
            output.read_to_string(&mut messages).map(|_| messages)
        });
        let mut complaint = String::new();
        for line in BufReader::new(errors).lines() {
            let line = line?;
            said(line.trim());
            complaint += &line;
            complaint.push('\n');
        }
        let status = process.wait()?;
        let messages = messages.join().map_err(|_| "cargo's messages are lost")??;
        if !status.success() {
            return Err(format!("{} of {} doesn't build:\n{complaint}", self.program, self.package).into());
        }
        let mut programs = Programs::new();
        for line in messages.lines() {
            let message: serde_json::Value = serde_json::from_str(line)?;
            let Some(path) = message["executable"].as_str().map(PathBuf::from) else { continue };
            let target = self.targets.iter().find(|target| path.iter().any(|part| part == **target));
            let target = target.ok_or_else(|| format!("{} is for no known target", path.display()))?;
            programs.insert((*target).to_owned(), self.keep(target, path)?);
        }
        if programs.len() == self.targets.len() {
            Ok(programs)
        } else {
            Err(format!("{} of {}: not a program for each target", self.program, self.package).into())
        }
    }

    /// Copies a program whose file the build of the next scene would replace.
    fn keep(&self, target: &str, program: PathBuf) -> Result<PathBuf> {
        if self.only == [None; 2] {
            return Ok(program);
        }
        let [number, scene] = self.only.map(|name| name.unwrap_or("all").replace(|c: char| !c.is_alphanumeric(), "-"));
        let room = program.with_file_name("kept");
        fs::create_dir_all(&room)?;
        let copy = room.join(format!("{}-{number}-{scene}-{target}", self.program));
        fs::copy(&program, &copy)?;
        Ok(copy)
    }
}
