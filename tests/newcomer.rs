//! A user's own package outside of the repository: it builds with nothing but a version of the crate, and draws a flag.

use std::path::Path;
use std::process::Command;
use std::{env, fs};

#[test]
fn a_newcomers_package_builds_and_draws() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let room = tempfile::tempdir().expect("a place for the package");
    fs::create_dir(room.path().join("src")).expect("a folder");
    for (from, to) in [
        ("tests/newcomer/Cargo.toml", "Cargo.toml"),
        ("tests/newcomer/src/main.rs", "src/main.rs"),
        ("Cargo.lock", "Cargo.lock"),
    ] {
        fs::copy(root.join(from), room.path().join(to)).expect("the package is there");
    }
    let source = fs::read_to_string(room.path().join("src/main.rs")).expect("its program");
    assert!(source.lines().count() <= 60, "a program of more than 60 lines");

    // stands for the version that will be published
    let patch = format!("patch.crates-io.kerchief.path={:?}", root.display().to_string());
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["run", "--release", "--quiet", "--config", &patch]).env_remove("RUSTC_BOOTSTRAP");
    // a fixed directory, only to make the test faster
    cargo.arg("--target-dir").arg(Path::new(env!("CARGO_TARGET_TMPDIR")).join("newcomer"));
    let output = cargo.current_dir(room.path()).output().expect("cargo runs");
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));

    for name in ["f32.ppm", "q24.ppm"] {
        let picture = fs::read(room.path().join(name)).expect("the picture");
        let pixels = picture.strip_prefix(b"P6 320 240 255\n").expect("a picture of 320 × 240");
        assert_eq!(pixels.len(), 3 * 320 * 240);
        let cloth = pixels.chunks(3).filter(|pixel| *pixel != [0, 0, 0]).count();
        assert!(cloth > 320 * 240 / 10, "{name}: cloth on {cloth} pixels");
    }
}
