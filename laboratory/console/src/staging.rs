//! Files that appear complete or not at all.

use std::collections::BTreeSet;
use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, Once, PoisonError};

use tempfile::{Builder, NamedTempFile, TempPath};

/// The exit status of a program that a signal ends is this plus the number of the signal, by the convention of shells.
#[cfg(unix)]
const SIGNALLED: i32 = 128;

/// Temporary files that have not been moved to their places yet.
static STAGED: Mutex<BTreeSet<PathBuf>> = Mutex::new(BTreeSet::new());

/// A temporary file in the directory of its place. It is moved to its place when it is complete, and deleted if it is dropped before that.
#[derive(Debug)]
pub struct Staged {
    file: BufWriter<NamedTempFile>,
    place: PathBuf,
}

impl Staged {
    /// Opens the file that will be `name` in `directory`. Fails if a directory has that name.
    pub fn create(directory: &Path, name: &str) -> Result<Self, String> {
        let place = directory.join(name);
        if place.symlink_metadata().is_ok_and(|found| found.is_dir()) {
            return Err(failed(&place, &io::ErrorKind::IsADirectory.into()));
        }
        let mut builder = Builder::new();
        builder.prefix(".").suffix(name);
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let mut staged = staged();
        let file = builder.tempfile_in(directory).map_err(|error| failed(directory, &error))?;
        staged.insert(file.path().to_path_buf());
        Ok(Self { file: BufWriter::new(file), place })
    }

    /// Writes the buffered rest and closes the file.
    pub fn complete(self) -> Result<Complete, String> {
        let file = self.file.into_inner().map_err(|error| failed(&self.place, error.error()))?;
        Ok(Complete { file: file.into_temp_path(), place: self.place })
    }

    /// Moves the file to its place.
    pub fn finish(self) -> Result<(), String> {
        finish([self.complete()?])
    }

    /// Adds the file's name to the error of `result`.
    pub fn named<T, E: std::fmt::Display>(&self, result: Result<T, E>) -> Result<T, String> {
        result.map_err(|error| format!("{}: {error}", self.place.display()))
    }
}

/// A completely written temporary file, which has not been moved to its place yet.
#[derive(Debug)]
pub struct Complete {
    file: TempPath,
    place: PathBuf,
}

/// Moves files that belong together to their places. All of them must be complete first: a full disk would otherwise leave some without the others.
pub fn finish(files: impl IntoIterator<Item = Complete>) -> Result<(), String> {
    // The lock lets a signal wait until the last file is moved.
    let mut staged = staged();
    files.into_iter().try_for_each(|Complete { file, place }| {
        staged.remove(&*file);
        file.persist(&place).map_err(|error| failed(&place, &error.error))
    })
}

impl Write for Staged {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// A temporary file without a name in `directory`, for a program's intermediate data. The system removes it however the program ends.
pub fn scratch(directory: &Path) -> Result<fs::File, String> {
    tempfile::tempfile_in(directory).map_err(|error| failed(directory, &error))
}

/// Creates the directory `--out` and checks that files can be written there. From now on, a signal that ends the program removes the staged files.
pub fn prepare(directory: &Path) -> Result<(), String> {
    static SIGNALS: Once = Once::new();
    SIGNALS.call_once(clear_on_signals);
    fs::create_dir_all(directory).map_err(|error| format!("--out: {}", failed(directory, &error)))?;
    Staged::create(directory, "probe").map(drop).map_err(|error| format!("--out: {error}"))
}

fn staged() -> MutexGuard<'static, BTreeSet<PathBuf>> {
    // A panic elsewhere does not leave an inconsistent set.
    STAGED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Signals that end a program run no destructors. A thread waits for them and removes the staged files.
#[cfg(unix)]
fn clear_on_signals() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGQUIT, SIGTERM};
    use signal_hook::iterator::Signals;

    // If this fails, only the tidying up is missing.
    let signals = [SIGHUP, SIGINT, SIGQUIT, SIGTERM].into_iter().filter(|signal| !is_ignored(*signal));
    let Ok(mut signals) = Signals::new(signals) else { return };
    std::thread::spawn(move || {
        if let Some(signal) = signals.forever().next() {
            // The lock is kept until the program ends, so that no further file is staged.
            let staged = staged();
            for file in &*staged {
                // The file may be deleted already.
                let _ = fs::remove_file(file);
            }
            std::process::exit(SIGNALLED + signal);
        }
    });
}

#[cfg(not(unix))]
fn clear_on_signals() {}

/// Whether the program was started with a signal ignored, as by `nohup`; such a signal must stay ignored. Only Linux tells.
#[cfg(unix)]
fn is_ignored(signal: i32) -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok());
    mask.is_some_and(|mask| mask >> (signal - 1) & 1 == 1)
}

fn failed(path: &Path, error: &io::Error) -> String {
    format!("{}: {error}", path.display())
}
