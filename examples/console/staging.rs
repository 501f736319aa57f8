//! Files that appear whole or not at all.

use std::fs;
use std::io::{self, BufWriter, Write};
use std::path::{Path, PathBuf};

use tempfile::{Builder, NamedTempFile};

/// A file written beside its place and moved there when it is complete; dropped before that, it leaves nothing.
#[derive(Debug)]
pub(crate) struct Staged {
    file: BufWriter<NamedTempFile>,
    place: PathBuf,
}

impl Staged {
    /// Opens the file that will stand in `directory` under `name`.
    pub(crate) fn create(directory: &Path, name: &str) -> Result<Self, String> {
        let mut builder = Builder::new();
        builder.prefix(".").suffix(name);
        #[cfg(unix)]
        builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
        let file = builder.tempfile_in(directory).map_err(|error| failed(directory, &error))?;
        Ok(Self { file: BufWriter::new(file), place: directory.join(name) })
    }

    /// Moves the file to its place.
    pub(crate) fn finish(self) -> Result<(), String> {
        let failed = |error: &io::Error| failed(&self.place, error);
        let file = self.file.into_inner().map_err(|error| failed(error.error()))?;
        file.persist(&self.place).map(drop).map_err(|error| failed(&error.error))
    }

    /// `result`, with the file's name in its error.
    pub(crate) fn named<T, E: std::fmt::Display>(&self, result: Result<T, E>) -> Result<T, String> {
        result.map_err(|error| format!("{}: {error}", self.place.display()))
    }
}

impl Write for Staged {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

/// Makes the directory `--out` and makes sure that files can be written there.
pub(crate) fn prepare(directory: &Path) -> Result<(), String> {
    fs::create_dir_all(directory).map_err(|error| format!("--out: {}", failed(directory, &error)))?;
    Staged::create(directory, "probe").map(drop).map_err(|error| format!("--out: {error}"))
}

fn failed(path: &Path, error: &io::Error) -> String {
    format!("{}: {error}", path.display())
}
