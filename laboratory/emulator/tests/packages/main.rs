//! Packages for boards are complete: a copy outside of the repository builds with only a published version of the crate.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

use emulator::board::{feather, microbit, oled, pico, tilt};
use emulator::{Firmware, footprint, root, target};

/// Every board of `boards`, and the demo board.
const BOARDS: [Firmware<'static>; 5] =
    [microbit::FIRMWARE, oled::FIRMWARE, feather::FIRMWARE, tilt::FIRMWARE, pico::FIRMWARE];

#[test]
fn a_copy_of_a_board_builds_anywhere() {
    for board in BOARDS {
        let room = tempfile::tempdir().unwrap();
        let copy = room.path().join("copy");
        copy_folder(&root().join(board.package), &copy);
        if !copy.join("memory.x").exists() {
            // the demo board: its user copies two more files
            for file in ["memory.x", "Cargo.lock"] {
                fs::copy(root().join(file), copy.join(file)).unwrap();
            }
        }
        let found = footprint::of(&build(&copy, &board)).unwrap();
        let expected = footprint::of(&board.build().unwrap()[board.targets[0]]).unwrap();
        let [flash, ram] = [0, 1].map(|k| found[k].abs_diff(expected[k]));
        // panic messages of constructors contain the path of the caller's file
        assert!(
            flash <= 32 && ram == 0,
            "{}: {found:?} bytes of flash and RAM, {expected:?} of the original",
            board.package
        );
    }
}

/// Builds the copy with a user's command, and with this repository as the published crate.
fn build(copy: &Path, board: &Firmware<'_>) -> PathBuf {
    let patch = format!("patch.crates-io.kerchief.path={:?}", root().display().to_string());
    let mut cargo = Command::new("rustup");
    cargo.args(["run", emulator::TOOLCHAIN, "cargo", "build", "--release", "--config", &patch]);
    // reuses compiled dependencies to save time
    cargo.arg("--target-dir").arg(target());
    for variable in ["CARGO", "RUSTC", "RUSTDOC", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS", "RUSTC_BOOTSTRAP"] {
        cargo.env_remove(variable);
    }
    let output = cargo.current_dir(copy).output().unwrap();
    assert!(output.status.success(), "{}:\n{}", board.package, String::from_utf8_lossy(&output.stderr));
    let program = target().join(board.targets[0]).join("release").join(board.program);
    let kept = copy.join("program");
    fs::copy(program, &kept).unwrap();
    kept
}

fn copy_folder(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap() {
        let entry = entry.unwrap();
        let copy = to.join(entry.file_name());
        if entry.file_type().unwrap().is_dir() {
            copy_folder(&entry.path(), &copy);
        } else {
            fs::copy(entry.path(), copy).unwrap();
        }
    }
}

/// Each package contains the files that it needs. Files that several packages need are identical in all of them.
#[test]
fn what_packages_have_in_common_is_the_same() {
    let copies = [
        ["examples/pico/src/clock.rs", "boards/oled/src/clock.rs"],
        ["examples/pico/src/meter.rs", "boards/oled/src/meter.rs"],
        ["examples/pico/src/pace.rs", "boards/oled/src/pace.rs"],
        ["laboratory/firmware/src/clock.rs", "boards/feather/src/clock.rs"],
        ["examples/pico/src/chip.rs", "boards/tilt/src/chip.rs"],
        ["examples/pico/src/clock.rs", "boards/tilt/src/clock.rs"],
        ["examples/pico/src/divider.rs", "boards/tilt/src/divider.rs"],
        ["examples/pico/src/fast.rs", "boards/tilt/src/fast.rs"],
        ["examples/pico/src/meter.rs", "boards/tilt/src/meter.rs"],
        ["examples/pico/src/pace.rs", "boards/tilt/src/pace.rs"],
        ["examples/pico/src/picture.rs", "boards/tilt/src/picture.rs"],
    ];
    for files in copies {
        let [first, second] = files.map(|file| fs::read_to_string(root().join(file)).unwrap());
        assert!(first == second, "{files:?} differ");
    }
}
