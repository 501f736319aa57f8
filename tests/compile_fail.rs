//! Impossible scenes don't compile, and the compiler's message gives the reason.
//!
//! Each file in `compile_fail` begins with a reason that the message must contain. The rest of the message is the compiler's
//! own and changes from release to release.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// The path of the library that this test is linked with, so that nothing is built anew.
fn library() -> PathBuf {
    let cargo = Command::new(env!("CARGO"))
        .args(["test", "--no-run", "--quiet", "--locked", "--test", "compile_fail", "--message-format", "json"])
        // the packages that `tests/run` builds together, or this one
        .args(std::env::var("KERCHIEF_TESTED").as_deref().unwrap_or("-p kerchief").split(' '))
        .args((!cfg!(debug_assertions)).then_some("--release"))
        .current_dir(env!("CARGO_MANIFEST_DIR"))
        // `tests/run` sets it to time tests; with it, crates would be built anew
        .env_remove("RUSTC_BOOTSTRAP")
        .output()
        .expect("cargo runs");
    let messages = String::from_utf8(cargo.stdout).expect("cargo writes UTF-8");
    messages
        .lines()
        .map(|line| serde_json::from_str::<serde_json::Value>(line).expect("a line is a message"))
        .filter(|message| message["reason"] == "compiler-artifact" && message["target"]["name"] == "kerchief")
        .flat_map(|message| message["filenames"].as_array().cloned().unwrap_or_default())
        .filter_map(|name| name.as_str().map(PathBuf::from))
        .find(|path| path.extension().is_some_and(|extension| extension == "rlib"))
        .expect("cargo names the library")
}

/// Compiles a program to an object file: sizes are checked only when generic functions are instantiated.
fn compile(program: &Path, library: &Path, directory: &Path) -> Output {
    let test = std::env::current_exe().expect("this test is a file");
    let dependencies = test.parent().expect("it lies among the libraries");
    Command::new("rustc")
        .args(["--edition", "2024", "--emit", "obj", "--color", "never", "--out-dir"])
        .arg(directory)
        .arg("-L")
        .arg(format!("dependency={}", dependencies.display()))
        .arg("--extern")
        .arg(format!("kerchief={}", library.display()))
        .arg(program)
        .output()
        .expect("rustc runs")
}

#[test]
fn impossible_scenes_do_not_compile() {
    let (library, directory) = (library(), tempfile::tempdir().expect("a directory for object files"));
    let programs = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/compile_fail");
    let mut failures = Vec::new();
    for entry in programs.read_dir().expect("the programs are there") {
        let program = entry.expect("a file").path();
        let source = std::fs::read_to_string(&program).expect("a program");
        let reason = source.lines().next().and_then(|line| line.strip_prefix("//! "));
        let output = compile(&program, &library, directory.path());
        let message = String::from_utf8_lossy(&output.stderr);
        // the program without a reason is the valid one, which the others spoil
        let expected = match reason {
            None => output.status.success(),
            Some(reason) => !output.status.success() && message.contains(reason),
        };
        if !expected {
            failures.push(format!("{}: {}\n{message}", program.display(), reason.unwrap_or("compiles")));
        }
    }
    assert!(failures.is_empty(), "unexpected from the compiler:\n{}", failures.join("\n"));
}
