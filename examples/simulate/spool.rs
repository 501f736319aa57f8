//! Moments on the disk: those of a long run don't fit in memory.

use std::fs::File;
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use console::staging;
use kerchief::host::Still;

/// Bytes of a position.
const PLACE: usize = 3 * size_of::<f64>();

/// Moments in the order in which they were recorded, all of one scene.
#[derive(Debug)]
pub(crate) struct Spool {
    file: File,
    directory: PathBuf,
    /// The number of positions in a moment, and how many of these are particles; the others are spheres.
    places: usize,
    particles: usize,
    /// The frame number of each moment.
    pub(crate) frames: Vec<u32>,
}

impl Spool {
    /// An empty spool, in the directory of the files that are made from it.
    pub(crate) fn new(directory: &Path) -> Result<Self, String> {
        let file = staging::scratch(directory)?;
        Ok(Self { file, directory: directory.to_path_buf(), places: 0, particles: 0, frames: Vec::new() })
    }

    /// Adds the moment at the end of a frame.
    pub(crate) fn push(&mut self, frame: u32, still: &Still) -> Result<(), String> {
        (self.particles, self.places) = (still.positions.len(), still.positions.len() + still.spheres.len());
        let places = still.positions.iter().chain(&still.spheres);
        let bytes: Vec<u8> = places.flatten().flat_map(|component| component.to_le_bytes()).collect();
        self.file.write_all(&bytes).map_err(|error| self.failed(&error))?;
        self.frames.push(frame);
        Ok(())
    }

    /// The moments with these numbers, counted from 0, each with its frame. After this call no moment may be added.
    pub(crate) fn read(&mut self, moments: &[usize]) -> Result<Vec<(u32, Still)>, String> {
        let mut bytes = vec![0; self.places * PLACE];
        let mut stills = Vec::with_capacity(moments.len());
        for &moment in moments {
            let start = (moment * bytes.len()) as u64;
            let read = self.file.seek(SeekFrom::Start(start)).and_then(|_| self.file.read_exact(&mut bytes));
            read.map_err(|error| self.failed(&error))?;
            let component = |bytes: &[u8]| f64::from_le_bytes(bytes.try_into().expect("eight bytes"));
            let place = |bytes: &[u8]| [0, 1, 2].map(|axis| component(&bytes[8 * axis..8 * axis + 8]));
            let mut positions: Vec<_> = bytes.chunks(PLACE).map(place).collect();
            let spheres = positions.split_off(self.particles);
            stills.push((self.frames[moment], Still { positions, spheres }));
        }
        Ok(stills)
    }

    fn failed(&self, error: &io::Error) -> String {
        format!("{}: {error}", self.directory.display())
    }
}
