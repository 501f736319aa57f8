//! A board with an STM32F405.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::Duration;

use crate::counter::Counter;
use crate::{Firmware, Result};

/// The program.
pub const FIRMWARE: Firmware<'static> = Firmware::board("boards/feather", "feather", &["thumbv7em-none-eabihf"]);
const MACHINE: &str = "netduinoplus2";
/// A program that prints nothing for so long counts as hanging.
const PATIENCE: Duration = Duration::from_secs(60);

/// Runs the program, passes every line from the serial port to `line`, and returns after the line `end`.
///
/// # Errors
///
/// If the program stops before that line or hangs.
pub fn run(program: &Path, line: impl FnMut(&str)) -> Result<()> {
    run_with(program, &[], line)
}

/// Like [`run`]. Also returns the instructions of every frame, as counted by `counter`.
///
/// # Errors
///
/// If the program stops before its last line or hangs.
pub fn run_marked(program: &Path, counter: &Counter, line: impl FnMut(&str)) -> Result<Vec<u64>> {
    counter.between_marks(program, |options| run_with(program, options, line))
}

fn run_with(program: &Path, options: &[&str], mut line: impl FnMut(&str)) -> Result<()> {
    let mut board = Running(
        Command::new("qemu-system-arm")
            .args(["-M", MACHINE, "-display", "none", "-monitor", "none", "-serial", "stdio", "-icount", "shift=0"])
            .args(options)
            .args(["-semihosting-config", "enable=on,target=native", "-kernel"])
            .arg(program)
            .stdin(Stdio::null())
            .stdout(Stdio::piped())
            .spawn()
            .map_err(|error| format!("qemu-system-arm: {error}"))?,
    );
    let output = board.0.stdout.take().ok_or("no output")?;
    let (send, lines) = mpsc::channel();
    thread::spawn(move || {
        BufReader::new(output).lines().map_while(std::result::Result::ok).try_for_each(|line| send.send(line))
    });
    loop {
        match lines.recv_timeout(PATIENCE).as_deref().map(str::trim_end) {
            Ok("end") => return Ok(()),
            Ok(text) => line(text),
            Err(RecvTimeoutError::Timeout) => return Err("the program hangs".into()),
            Err(RecvTimeoutError::Disconnected) => return Err("the program failed".into()),
        }
    }
}

/// A process that ends with its owner.
struct Running(Child);

impl Drop for Running {
    fn drop(&mut self) {
        // fails if the process has already ended
        let _ = self.0.kill();
        let _ = self.0.wait();
    }
}
