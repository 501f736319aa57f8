//! A board in QEMU that runs from one picture to the next.

use std::io::{BufRead, BufReader, Write};
use std::os::unix::net::UnixStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

use tempfile::TempDir;

use crate::Result;
use crate::gdb::{Gdb, patiently};
use crate::program::{PAINT, Program};

/// A program in QEMU, stopped.
#[derive(Debug)]
pub struct Qemu {
    process: Child,
    gdb: Gdb,
    monitor: BufReader<UnixStream>,
    program: Program,
    /// Breakpoints: at the end of a picture (`shown`), and at a hard fault.
    stops: [u32; 2],
    log: Vec<u8>,
    traced: Option<&'static str>,
    /// Lines of QEMU's log file that [`Self::trace`] has returned.
    read: usize,
    work: TempDir,
}

impl Qemu {
    /// Starts a program on a machine where an instruction takes 2^`shift` nanoseconds. Events of the kind `traced` are recorded for [`Self::trace`].
    pub fn start(machine: &str, traced: Option<&'static str>, program: &Path, shift: u32) -> Result<Self> {
        let work = tempfile::tempdir()?;
        let [gdb, monitor, errors] = ["gdb", "monitor", "errors"].map(|name| work.path().join(name));
        let process = Command::new("qemu-system-arm")
            .args(["-M", machine, "-display", "none", "-serial", "none", "-S"])
            .args(["-icount", &format!("shift={shift},sleep=off"), "-d", "guest_errors,unimp", "-D"])
            .arg(&errors)
            .arg("-gdb")
            .arg(format!("unix:{},server=on,wait=off", gdb.display()))
            .arg("-monitor")
            .arg(format!("unix:{},server=on,wait=off", monitor.display()))
            .arg("-kernel")
            .arg(program)
            .args(traced.iter().flat_map(|event| ["-trace", event]))
            .stdin(Stdio::null())
            .spawn()
            .map_err(|error| format!("qemu-system-arm: {error}"))?;
        let program = Program::read(program)?;
        let stops = [program.address("shown")?, program.address("HardFault")?];
        let (gdb, monitor) = (Gdb::connect(&gdb)?, BufReader::new(patiently(&monitor)?));
        let mut qemu = Self { process, gdb, monitor, program, stops, log: Vec::new(), traced, read: 0, work };
        qemu.prompt()?;
        for stop in stops {
            qemu.gdb.set_breakpoint(stop)?;
        }
        Ok(qemu)
    }

    /// Runs until the next picture has been shown, and returns its step.
    ///
    /// # Errors
    ///
    /// If the program or the emulator fails.
    pub fn picture(&mut self) -> Result<u32> {
        self.go()?;
        self.stopped()
    }

    /// Whether the program runs for 500 ms (host time) without showing a picture. If so, it goes on running.
    pub fn rests(&mut self) -> Result<bool> {
        self.go()?;
        self.still_rests()
    }

    /// Like [`Self::rests`], for a program that is already running.
    pub fn still_rests(&mut self) -> Result<bool> {
        self.gdb.runs_for(Duration::from_millis(500))
    }

    fn go(&mut self) -> Result<()> {
        // a breakpoint stops before its instruction: it is cleared for one step, which leads past it
        let at = self.gdb.register(15)?;
        if self.stops.contains(&at) {
            self.gdb.clear_breakpoint(at)?;
            self.gdb.step()?;
            self.gdb.set_breakpoint(at)?;
        }
        self.gdb.go()
    }

    /// Waits for the next picture of a running program.
    pub fn stopped(&mut self) -> Result<u32> {
        self.gdb.wait()?;
        self.drain()?;
        if self.gdb.register(15)? == self.stops[1] {
            return Err(format!("the program failed: {}", self.log()?.join("\n")).into());
        }
        self.gdb.register(0)
    }

    /// Presses a key for some milliseconds of emulated time. The program must be running.
    pub fn press(&mut self, key: &str, milliseconds: u32) -> Result<()> {
        self.command(&format!("sendkey {key} {milliseconds}"))
    }

    /// A screenshot of the display.
    pub fn screen(&mut self) -> Result<image::RgbImage> {
        let file = self.work.path().join("screen.png");
        self.command(&format!("screendump {} -f png", file.display()))?;
        Ok(image::open(&file)?.to_rgb8())
    }

    /// The lines of the log so far.
    pub fn log(&self) -> Result<Vec<String>> {
        self.program.decode(&self.log)
    }

    /// The events recorded since the last call, each without the name of its kind.
    pub fn trace(&mut self) -> Result<Vec<String>> {
        let (notes, read) = (self.notes()?, self.read);
        self.read = notes.lines().count();
        let name = self.traced.unwrap_or_default();
        let traced =
            notes.lines().skip(read).filter_map(|line| line.strip_prefix(name)).map(|line| line.trim().to_owned());
        Ok(traced.collect())
    }

    /// QEMU's complaints about the program's use of the board, one a line.
    pub fn errors(&self) -> Result<String> {
        /// QEMU resets the micro:bit once before its flash is loaded, and again afterwards.
        const EARLY: &str = ", size 4, region '(null)', reason: rejected";
        let early = ["0x0", "0x4"].map(|at| format!("Invalid read at addr {at}{EARLY}"));
        let wrong = |(index, line): &(usize, &str)| {
            let traced = self.traced.is_some_and(|name| line.starts_with(name));
            !traced && early.get(*index).is_none_or(|early| early != line)
        };
        let notes = self.notes()?;
        Ok(notes.lines().enumerate().filter(wrong).map(|(_, line)| line).collect::<Vec<_>>().join("\n"))
    }

    fn notes(&self) -> Result<String> {
        Ok(std::fs::read_to_string(self.work.path().join("errors"))?)
    }

    /// The largest number of bytes of stack that were in use at any time, and the stack's size.
    pub fn stack(&mut self) -> Result<[u32; 2]> {
        let [end, start] = [self.program.address("_stack_end")?, self.program.address("_stack_start")?];
        let bytes = self.gdb.read(end, start - end)?;
        let unused = bytes.chunks_exact(4).take_while(|word| **word == PAINT.to_le_bytes()).count() as u32 * 4;
        Ok([start - end - unused, start - end])
    }

    /// Empties the log's buffer, as a debug probe does.
    fn drain(&mut self) -> Result<()> {
        // RTT control block: identification, numbers of channels; channel 0: name, buffer, size, write offset, read offset
        let channel = self.program.address("_SEGGER_RTT")? + 24;
        let [buffer, size, written, read] = [4, 8, 12, 16]
            .map(|offset| self.gdb.read_word(channel + offset))
            .into_iter()
            .collect::<Result<Vec<_>>>()?[..]
        else {
            return Err("a channel has four numbers".into());
        };
        if size == 0 {
            return Ok(());
        }
        if written < read {
            let rest = self.gdb.read(buffer + read, size - read)?;
            self.log.extend(rest);
        }
        let start = if written < read { 0 } else { read };
        let bytes = self.gdb.read(buffer + start, written - start)?;
        self.log.extend(bytes);
        self.gdb.write_word(channel + 16, written)
    }

    fn command(&mut self, line: &str) -> Result<()> {
        self.monitor.get_mut().write_all(format!("{line}\n").as_bytes())?;
        let answer = self.prompt()?;
        // the monitor echoes the command
        let complaint = answer.lines().skip(1).collect::<Vec<_>>().join("\n");
        if complaint.contains("Error") || complaint.contains("unknown") {
            return Err(format!("{line}: {complaint}").into());
        }
        Ok(())
    }

    /// Reads to the monitor's prompt.
    fn prompt(&mut self) -> Result<String> {
        let mut text = Vec::new();
        while !text.ends_with(b"(qemu) ") {
            if self.monitor.read_until(b' ', &mut text)? == 0 {
                return Err("the monitor has gone".into());
            }
        }
        Ok(String::from_utf8_lossy(&text).into_owned())
    }
}

impl Drop for Qemu {
    fn drop(&mut self) {
        // fails if the process has already ended
        let _ = self.process.kill();
        let _ = self.process.wait();
    }
}
