//! Counts instructions by a QEMU plugin, the package `counter`. It is independent of the boards' clock.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::program::Program;
use crate::{Result, TOOLCHAIN, root, target};

/// The function that a program calls before and after each counted part.
const MARK: &str = "clock::mark";

/// The built plugin.
#[derive(Debug)]
pub struct Counter(PathBuf);

impl Counter {
    /// Builds the plugin.
    pub fn build() -> Result<Self> {
        let mut cargo = Command::new("rustup");
        cargo.args(["run", TOOLCHAIN, "cargo", "build", "--quiet", "--locked", "--release", "-p", "counter"]);
        cargo.arg("--target-dir").arg(target());
        // variables that cargo has set for this process must not reach the other cargo
        for variable in ["CARGO", "RUSTC", "RUSTDOC", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS"] {
            cargo.env_remove(variable);
        }
        let output = cargo.current_dir(root()).output().map_err(|error| format!("rustup: {error}"))?;
        if !output.status.success() {
            return Err(format!("counter doesn't build:\n{}", String::from_utf8_lossy(&output.stderr)).into());
        }
        Ok(Self(target().join("release/libcounter.so")))
    }

    /// Calls `run` with additional options for QEMU, and returns the number of instructions executed between the two marks of every pair.
    ///
    /// # Errors
    ///
    /// If `run` fails, or the number of marks is odd.
    pub fn between_marks(&self, program: &Path, run: impl FnOnce(&[&str]) -> Result<()>) -> Result<Vec<u64>> {
        let work = tempfile::tempdir()?;
        let file = work.path().join("counts");
        let mark = Program::read(program)?.address(MARK)?;
        run(&["-plugin", &format!("{},mark={mark},counts={}", self.0.display(), file.display())])?;
        let counts = fs::read_to_string(file)?;
        let counts = counts.lines().map(str::parse).collect::<Result<Vec<u64>, _>>()?;
        let (pairs, []) = counts.as_chunks::<2>() else {
            return Err(format!("{} counts, which are not pairs", counts.len()).into());
        };
        Ok(pairs.iter().map(|[start, end]| end - start).collect())
    }
}
