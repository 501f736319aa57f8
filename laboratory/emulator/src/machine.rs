//! The machines that firmware runs on: QEMU's LM3S6965 board with a choice of Cortex-M processors, and WebAssembly in node.

use std::path::Path;
use std::process::Command;

use crate::Result;
use crate::counter::Counter;

/// A machine and its compilation target.
#[derive(Clone, Copy, Debug)]
pub struct Machine {
    /// Its name in documents.
    pub name: &'static str,
    /// The target that programs are built for.
    pub target: &'static str,
    kind: Kind,
}

#[derive(Clone, Copy, Debug)]
enum Kind {
    /// QEMU's LM3S6965 evaluation board with this processor.
    Board(&'static str),
    /// node with its system interface for WebAssembly.
    Node,
}

const fn board(name: &'static str, target: &'static str, processor: &'static str) -> Machine {
    Machine { name, target, kind: Kind::Board(processor) }
}

/// A Cortex-M0.
pub const M0: Machine = board("Cortex-M0", "thumbv6m-none-eabi", "cortex-m0");
/// A Cortex-M3.
pub const M3: Machine = board("Cortex-M3", "thumbv7m-none-eabi", "cortex-m3");
const M4: Machine = board("Cortex-M4 without FPU", "thumbv7em-none-eabi", "cortex-m4");
/// A Cortex-M4 with a unit for `f32`.
pub const M4F: Machine = board("Cortex-M4F", "thumbv7em-none-eabihf", "cortex-m4");
const M7: Machine = board("Cortex-M7", "thumbv7em-none-eabihf", "cortex-m7");
const M33: Machine = board("Cortex-M33", "thumbv7em-none-eabihf", "cortex-m33");
/// A virtual machine for WebAssembly.
pub const WASM: Machine = Machine { name: "WebAssembly", target: "wasm32-wasip1", kind: Kind::Node };

/// Every machine.
pub const ALL: [Machine; 7] = [M0, M3, M4, M4F, M7, M33, WASM];

/// QEMU's options with which an instruction takes a nanosecond.
const COUNTED: [&str; 2] = ["-icount", "shift=0"];
/// Seconds after which a program counts as hanging.
const PATIENCE: &str = "600";

impl Machine {
    /// Runs a program and returns its output, without the last line `end`.
    ///
    /// # Errors
    ///
    /// If the program fails, hangs or doesn't print `end` last.
    pub fn run(&self, program: &Path) -> Result<String> {
        self.run_with(program, &[])
    }

    /// Like [`Self::run`], with instructions of one nanosecond.
    ///
    /// # Errors
    ///
    /// See [`Self::run`].
    pub fn run_counted(&self, program: &Path) -> Result<String> {
        self.run_with(program, &COUNTED)
    }

    /// Like [`Self::run_counted`]. Also returns the instructions between the two marks of every pair, as counted by `counter`.
    ///
    /// # Errors
    ///
    /// See [`Self::run`], or if the marks are not pairs.
    pub fn run_marked(&self, program: &Path, counter: &Counter) -> Result<(String, Vec<u64>)> {
        let mut printed = String::new();
        let counts = counter.between_marks(program, |options| {
            printed = self.run_with(program, &[&COUNTED, options].concat())?;
            Ok(())
        })?;
        Ok((printed, counts))
    }

    fn run_with(&self, program: &Path, options: &[&str]) -> Result<String> {
        let mut command = Command::new("timeout");
        command.arg(PATIENCE);
        match self.kind {
            Kind::Board(processor) => command
                .args(["qemu-system-arm", "-M", "lm3s6965evb", "-cpu", processor, "-display", "none"])
                .args(["-semihosting-config", "enable=on,target=native"])
                .args(options)
                .arg("-kernel"),
            Kind::Node => command.args(["node", "--no-warnings", concat!(env!("CARGO_MANIFEST_DIR"), "/src/node.mjs")]),
        };
        let output = command.arg(program).output().map_err(|error| format!("timeout: {error}"))?;
        let printed = String::from_utf8_lossy(&output.stdout).into_owned();
        let tail = printed.lines().last().unwrap_or_default().to_owned();
        let Some(lines) = printed.strip_suffix("end\n").filter(|_| output.status.success()) else {
            let errors = String::from_utf8_lossy(&output.stderr);
            let (name, program, status) = (self.name, program.display(), output.status);
            return Err(format!("{name}: {program} ends with {status}, after {tail:?}: {errors}").into());
        };
        Ok(lines.to_owned())
    }
}
