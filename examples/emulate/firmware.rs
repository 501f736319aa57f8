//! Builds firmware as its users do, with the oldest supported Rust: the newest release may lack a target, and figures are those of one compiler.

use std::collections::HashMap;
use std::path::PathBuf;
use std::process::Command;

/// An example of this crate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Firmware<'a> {
    pub(crate) example: &'a str,
    /// The board's file in `boards`; without one it is the board of `memory.x`.
    pub(crate) board: Option<&'a str>,
    pub(crate) features: &'a str,
    pub(crate) profile: &'a str,
    pub(crate) targets: &'a [&'a str],
    /// Number type and scene that are left of all.
    pub(crate) only: [Option<&'a str>; 2],
}

impl<'a> Firmware<'a> {
    /// A program that measures, on the board that takes every processor.
    #[allow(dead_code, reason = "for the tests")]
    pub(crate) const fn measuring(example: &'a str, targets: &'a [&'a str], only: [Option<&'a str>; 2]) -> Self {
        Self { example, board: Some("lm3s6965"), features: "semihosting", profile: "board", targets, only }
    }

    /// The programs, by target.
    pub(crate) fn build(&self) -> HashMap<String, PathBuf> {
        let mut cargo = Command::new("rustup");
        cargo.args(["run", concat!(env!("CARGO_PKG_RUST_VERSION"), ".0"), "cargo"]);
        if let Some(board) = self.board {
            cargo.args(["--config", &format!("boards/{board}.toml")]);
        }
        cargo.args(["build", "--locked", "--message-format=json-render-diagnostics"]);
        cargo.args(["--no-default-features", "--features", self.features]);
        cargo.args(["--example", self.example, "--profile", self.profile]);
        for target in self.targets {
            cargo.args(["--target", target]);
        }
        for (variable, value) in ["KERCHIEF_NUMBER", "KERCHIEF_SCENE"].into_iter().zip(self.only) {
            match value {
                Some(value) => cargo.env(variable, value),
                None => cargo.env_remove(variable),
            };
        }
        // what the test's own cargo says of itself is not for this one
        for variable in ["CARGO", "RUSTC", "RUSTDOC", "RUSTFLAGS", "CARGO_ENCODED_RUSTFLAGS"] {
            cargo.env_remove(variable);
        }
        let output = cargo.current_dir(env!("CARGO_MANIFEST_DIR")).output().expect("rustup starts");
        let name = self.example;
        assert!(output.status.success(), "{name} doesn't build:\n{}", String::from_utf8_lossy(&output.stderr));
        let messages = String::from_utf8(output.stdout).expect("cargo writes UTF-8");
        let artifacts = messages.lines().filter_map(|line| {
            let message: serde_json::Value = serde_json::from_str(line).expect("cargo writes JSON");
            let path = PathBuf::from(message["executable"].as_str()?);
            let target = self.targets.iter().find(|target| path.iter().any(|part| part == **target))?;
            Some(((*target).to_owned(), path))
        });
        let programs: HashMap<_, _> = artifacts.collect();
        assert_eq!(programs.len(), self.targets.len(), "{name}: a program for each target");
        programs
    }
}
