//! The lessons' programs.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::{Arc, Mutex, OnceLock};

/// The lessons in order, with the paths of their programs.
pub(crate) const LESSONS: [(&str, &str); 10] = [
    ("01-spring", env!("CARGO_BIN_EXE_01-spring")),
    ("02-damping", env!("CARGO_BIN_EXE_02-damping")),
    ("03-integrators", env!("CARGO_BIN_EXE_03-integrators")),
    ("04-sheet", env!("CARGO_BIN_EXE_04-sheet")),
    ("05-wind", env!("CARGO_BIN_EXE_05-wind")),
    ("06-ball", env!("CARGO_BIN_EXE_06-ball")),
    ("07-super-elasticity", env!("CARGO_BIN_EXE_07-super-elasticity")),
    ("08-cost", env!("CARGO_BIN_EXE_08-cost")),
    ("09-fixed-point", env!("CARGO_BIN_EXE_09-fixed-point")),
    ("10-same-bits", env!("CARGO_BIN_EXE_10-same-bits")),
];

/// The folder of the repository.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The text of a file of the repository.
pub(crate) fn read(file: impl AsRef<Path>) -> String {
    let path = root().join(file);
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The output of a lesson and the plot that it writes. With the same arguments the program is run once, in a folder of its own.
pub(crate) fn run(lesson: &str, arguments: &[&str]) -> (String, String) {
    type Outcome = Arc<OnceLock<(String, String)>>;
    static RUNS: Mutex<BTreeMap<String, Outcome>> = Mutex::new(BTreeMap::new());
    let name = [&[lesson], arguments].concat().join("_");
    let outcome = RUNS.lock().expect("no run fails in here").entry(name.clone()).or_default().clone();
    outcome.get_or_init(|| run_in(&name, lesson, arguments)).clone()
}

fn run_in(folder: &str, lesson: &str, arguments: &[&str]) -> (String, String) {
    let program = LESSONS.iter().find(|(name, _)| *name == lesson).expect("a lesson").1;
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(folder);
    fs::create_dir_all(&folder).expect("a folder");
    let output = Command::new(program).args(arguments).current_dir(&folder).output().expect("the program runs");
    assert!(output.status.success(), "{lesson} {arguments:?}: {}", String::from_utf8_lossy(&output.stderr));
    let plot = folder.join(format!("out/lessons/{lesson}.svg"));
    let plot = fs::read_to_string(plot).expect("the program writes its plot");
    (String::from_utf8(output.stdout).expect("text"), plot)
}

/// The numbers in the first line that starts with `label`.
pub(crate) fn numbers(text: &str, label: &str) -> Vec<f64> {
    let line = text
        .lines()
        .find_map(|line| line.trim_start().strip_prefix(label))
        .unwrap_or_else(|| panic!("no line {label:?} in\n{text}"));
    let words = line.split(|c: char| !(c.is_ascii_alphanumeric() || ".-".contains(c)));
    words.filter_map(|word| word.parse().ok()).collect()
}
