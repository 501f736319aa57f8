//! Instructions of a frame, counted by valgrind's callgrind. The program runs itself under callgrind.

use std::fs;
use std::io::{self, Read, Write};
use std::process::{Command, Stdio};

use kerchief::host::{Description, Simulation};

use crate::lean;
use laboratory::configuration::Configuration;

/// The first word of the command line that makes the program only move a sheet.
const WORD: &str = "frames-for-callgrind";

/// Frames before the counted one: a solver's first frame differs from the others.
pub(crate) const BEFORE: u32 = 1;

/// Makes glibc clear and copy memory in loops. Callgrind would count an instruction for every byte of `rep stosb` or `rep movsb`, which are one instruction each.
const TUNABLES: &str = "glibc.cpu.x86_rep_stosb_threshold=0x7fffffff:glibc.cpu.x86_rep_movsb_threshold=0x7fffffff";

/// Whether valgrind is on the path.
pub(crate) fn is_there() -> bool {
    let quiet = Command::new("valgrind").arg("--version").stdout(Stdio::null()).stderr(Stdio::null()).status();
    quiet.is_ok_and(|status| status.success())
}

/// If the command line begins with `WORD`: moves the scene from stdin by `BEFORE` frames and the counted one.
pub(crate) fn answer() -> Option<Result<(), String>> {
    let mut words = std::env::args().skip(1);
    (words.next()? == WORD).then(|| {
        let words: Vec<_> = words.collect();
        let configuration = Configuration::from_words(&words).ok_or("not a configuration")?;
        let mut text = String::new();
        io::stdin().read_to_string(&mut text).map_err(|error| error.to_string())?;
        let scene = Description::parse(&text).map_err(|error| error.to_string())?;
        let scene = configuration.of(&scene);
        let mut moving = lean::moving(&scene, configuration.scalar).map_err(|error| error.to_string())?;
        for _ in 0..BEFORE {
            moving.frame();
        }
        frame_for_callgrind(&mut *moving);
        Ok(())
    })
}

/// The frame that callgrind counts.
#[inline(never)]
fn frame_for_callgrind(moving: &mut dyn Simulation) {
    moving.frame();
    // Prevents a tail call: callgrind would not see its return.
    std::hint::black_box(moving);
}

/// Instructions of the frame after [`BEFORE`] frames, for all particles together.
pub(crate) fn instructions(text: &str, configuration: Configuration) -> Result<u64, String> {
    let failed = |error: io::Error| format!("valgrind: {error}");
    let room = tempfile::tempdir().map_err(failed)?;
    let counts = room.path().join("counts");
    let mut child = Command::new("valgrind")
        .env("GLIBC_TUNABLES", TUNABLES)
        .args(["--tool=callgrind", "--toggle-collect=*frame_for_callgrind*"])
        .arg(format!("--callgrind-out-file={}", counts.display()))
        .arg(std::env::current_exe().map_err(failed)?)
        .arg(WORD)
        .args(configuration.words())
        .stdin(Stdio::piped())
        .stdout(Stdio::null())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(failed)?;
    let written = child.stdin.take().map(|mut input| input.write_all(text.as_bytes()));
    let output = child.wait_with_output().map_err(failed)?;
    let report = || String::from_utf8_lossy(&output.stderr).lines().last().unwrap_or_default().to_string();
    if !output.status.success() || written.is_none_or(|result| result.is_err()) {
        return Err(format!("valgrind: {}", report()));
    }
    let counts = fs::read_to_string(counts).map_err(failed)?;
    let summary =
        counts.lines().find_map(|line| line.strip_prefix("summary: ").or_else(|| line.strip_prefix("totals: ")));
    let summary = summary.and_then(|count| count.trim().parse().ok()).filter(|&count| count > 0);
    summary.ok_or_else(|| "valgrind: counted nothing".to_string())
}
