//! The published figures: their type, and reading, writing and comparing them.

use std::fs;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};

/// The cost of a scene.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub(crate) struct Figure {
    pub(crate) number: String,
    pub(crate) scene: String,
    /// Instructions of a frame on each of [`PROCESSORS`].
    pub(crate) m0: u64,
    pub(crate) m3: u64,
    pub(crate) m4f: u64,
    /// Bytes of flash of a program for the Cortex-M0 that moves the sheet and does nothing else.
    pub(crate) flash: u64,
    /// Bytes of the cloth.
    pub(crate) cloth: u64,
    /// Bytes of the solver's memory.
    pub(crate) memory: u64,
}

/// The processors of a [`Figure`].
pub(crate) const PROCESSORS: [&str; 3] = ["Cortex-M0", "Cortex-M3", "Cortex-M4F"];

/// Largest relative change that is tolerated.
const TOLERANCE: f64 = 0.03;

/// The resolution of the boards' clock: instructions in a tick.
pub(crate) const TICK: u64 = 80;

fn path() -> PathBuf {
    emulator::root().join("docs/instructions.csv")
}

impl Figure {
    pub(crate) fn instructions(&self) -> [u64; 3] {
        [self.m0, self.m3, self.m4f]
    }
}

/// The committed figures.
pub(crate) fn read() -> Vec<Figure> {
    let mut reader = csv::Reader::from_path(path()).expect("docs/instructions.csv can be read");
    reader.deserialize().map(|row| row.expect("docs/instructions.csv holds figures")).collect()
}

pub(crate) fn write(figures: &[Figure]) {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for figure in figures {
        writer.serialize(figure).expect("a figure is a row");
    }
    let text = writer.into_inner().expect("memory takes everything");
    fs::write(path(), text).expect("docs/instructions.csv can be written");
}

/// A message for each figure in which `found` differs from `committed`.
pub(crate) fn differences(committed: &[Figure], found: &[Figure]) -> Vec<String> {
    let mut differences = Vec::new();
    let key = |figure: &Figure| (figure.number.clone(), figure.scene.clone());
    if !committed.iter().map(key).eq(found.iter().map(key)) {
        differences.push("other scenes or number types".to_owned());
    }
    for (old, new) in committed.iter().zip(found) {
        let place = format!("{} in {}", new.scene, new.number);
        let [was, is] = [old, new].map(|figure| {
            let Figure { m0, m3, m4f, flash, cloth, memory, .. } = *figure;
            [m0, m3, m4f, flash, cloth, memory]
        });
        let columns = PROCESSORS.into_iter().chain(["flash", "cloth", "memory"]);
        for ((column, was), is) in columns.zip(was).zip(is) {
            // a frame at rest takes not much more than a tick of the clock
            let least = if PROCESSORS.contains(&column) { TICK } else { 0 };
            if is.abs_diff(was) as f64 > (TOLERANCE * was as f64).max(least as f64) {
                let way = if is > was { "grew" } else { "shrank" };
                differences.push(format!("{place}, {column}: {way} from {was} to {is}"));
            }
        }
    }
    differences
}
