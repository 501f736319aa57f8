//! The program `simulate`: refusals and output.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;
use std::time::{Duration, Instant};

use instances::simulation;
use kerchief::host::{Description, SHAPES, ScalarKind, Simulation, SolverKind, Wind, WindModel};
use tempfile::TempDir;

/// A scene that runs in an instant.
const SMALL: &str = r#"
name = "small"
[cloth]
columns = 4
rows = 4
width = 1.0
height = 1.0
density = 0.2
origin = [-0.5, -0.5, 1.0]
pins = [[0, 0], [3, 0]]
[stretch]
stiffness = 100.0
[shear]
stiffness = 10.0
[environment]
gravity = [0.0, 0.0, -9.81]
[[sphere]]
centre = [0.0, 0.0, 0.4]
radius = 0.3
[solver]
kind = "xpbd"
step = 0.02
substeps = 4
[run]
frames = 10
"#;

/// The built program.
fn program() -> Command {
    static PATH: OnceLock<PathBuf> = OnceLock::new();
    let build = || {
        // The same set of packages as in `tests/run`, so that its build is reused.
        let tested = std::env::var("KERCHIEF_TESTED");
        escargot::CargoBuild::new()
            .manifest_path(concat!(env!("CARGO_MANIFEST_DIR"), "/../../Cargo.toml"))
            .args(tested.as_deref().unwrap_or("-p kerchief-console").split(' '))
            .example("simulate")
            .env_remove("RUSTC_BOOTSTRAP")
            .current_release()
    };
    Command::new(PATH.get_or_init(|| build().run().expect("the example builds").path().to_path_buf()))
}

/// A working directory with the scene `small.toml`.
fn room() -> TempDir {
    let room = tempfile::tempdir().unwrap();
    fs::write(room.path().join("small.toml"), SMALL).unwrap();
    room
}

/// The report of the last run.
fn report(room: &Path) -> BTreeMap<String, serde_json::Value> {
    serde_json::from_str(&fs::read_to_string(room.join("out/report.json")).unwrap()).unwrap()
}

fn run(room: &Path, args: &[&str]) -> Output {
    program().current_dir(room).args(args).output().unwrap()
}

/// Asserts that the program succeeds and prints nothing on stderr.
fn succeeds(room: &Path, args: &[&str]) -> String {
    let output = run(room, args);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && stderr.is_empty(), "{args:?}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

/// Asserts one line on stderr that contains `reason`, exit status 2, and no new files.
fn refuses(room: &Path, args: &[&str], reason: &str) {
    let before = names(room);
    let output = run(room, args);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{args:?}: {stderr}");
    assert!(stderr.starts_with("error: ") && stderr.ends_with('\n'), "{args:?}: {stderr:?}");
    assert_eq!(stderr.lines().count(), 1, "{args:?}: {stderr:?}");
    assert!(stderr.contains(reason), "{args:?}: {stderr:?} does not say {reason:?}");
    assert!(output.stdout.is_empty(), "{args:?}");
    assert_eq!(names(room), before, "{args:?} left something");
}

fn names(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

#[test]
fn scenes_that_are_not_there() {
    let room = room();
    let room = room.path();
    refuses(room, &["flagg"], "no scene or file \"flagg\"; built-in scenes: gravity, sphere, wind, no-shear, flag");
    refuses(room, &["missing.toml"], "missing.toml: ");
    refuses(room, &["."], ".: ");
    refuses(room, &["two\nlines.toml"], "two\\nlines.toml: ");
    fs::write(room.join("latin.toml"), b"name = \"caf\xe9\"\n").unwrap();
    refuses(room, &["latin.toml"], "latin.toml: ");
}

#[test]
fn scenes_that_are_wrong() {
    let room = room();
    let room = room.path();
    for (from, to, reason) in [
        ("density = 0.2", "density = -0.2", "bad.toml: cloth.density: must be above zero"),
        ("rows = 4", "rows = 5", "bad.toml: cloth.rows: no grid of 4x5"),
        ("[shear]", "[sheer]", "bad.toml: sheer: unknown key"),
        ("[run]", "[run", "bad.toml: line 24: unclosed table"),
        ("name = \"small\"", "\"two\\nlines\" = 1", "bad.toml: two\\nlines: unknown key"),
        ("kind = \"xpbd\"", "kind = {lines = {}}", "bad.toml: solver.kind: invalid type: table, expected a string"),
    ] {
        assert_eq!(SMALL.matches(from).count(), 1, "{from:?}");
        fs::write(room.join("bad.toml"), SMALL.replace(from, to)).unwrap();
        refuses(room, &["bad.toml"], reason);
    }
}

#[test]
fn options_that_are_wrong() {
    let room = room();
    let room = room.path();
    for (args, reason) in [
        (&["small.toml", "--frame", "3"][..], "unexpected argument '--frame'"),
        (&["small.toml", "other.toml"], "unexpected argument 'other.toml'"),
        (
            &["small.toml", "--scalar", "f16"],
            "invalid value 'f16' for '--scalar <TYPE>' [possible values: f32, f64, q24, q13]",
        ),
        (
            &["small.toml", "--solver", "magic"],
            "[possible values: verlet, forward-euler, backward-euler, leapfrog, xpbd",
        ),
        (&["small.toml", "--substeps", "0"], "'--substeps <N>'"),
        (&["small.toml", "--substeps", "4000000000"], "'--substeps <N>'"),
        (&["small.toml", "--iterations", "0"], "'--iterations <N>'"),
        (&["small.toml", "--frames", "ten"], "'--frames <N>'"),
        (&["small.toml", "--every", "0"], "'--every <N>'"),
        (&["small.toml", "--every", "-1"], "invalid value '-1' for '--every <N>': -1 is not in 1..=1048576"),
        (&["small.toml", "--frames", "-3"], "invalid value '-3' for '--frames <N>': -3 is not in 1..=1048576"),
        (&["small.toml", "--substeps", "-3"], "'--substeps <N>': -3 is not in"),
        (&["small.toml", "--iterations", "-3"], "'--iterations <N>': -3 is not in"),
        (&["small.toml", "--out"], "'--out <DIR>'"),
        (&["small.toml", "--out", "small.toml"], "--out: small.toml: "),
        (&["small.toml", "--out", "small.toml/out"], "--out: small.toml/out: "),
        (&["small.toml", "--out", "small.toml/two\nlines"], "--out: small.toml/two\\nlines: "),
    ] {
        refuses(room, args, reason);
    }
}

#[test]
#[cfg(target_os = "linux")]
fn directories_that_cannot_be_written() {
    let room = room();
    refuses(room.path(), &["small.toml", "--out", "/proc"], "--out: /proc: ");
    refuses(room.path(), &["small.toml", "--out", "/proc/none/of/this"], "--out: /proc/none/of/this: ");
}

/// A full disk, here simulated by a limit on the size of files: the files of the run before stay unchanged, and no temporary file is left.
#[test]
#[cfg(unix)]
fn a_full_disk_leaves_what_was_there() {
    let room = room();
    let room = room.path();
    succeeds(room, &["small.toml", "--csv", "--gif", "--png", "--every", "5"]);
    let before = contents(&room.join("out"));
    for kind in ["--csv", "--gif", "--png"] {
        // The limit is in blocks of 512 bytes. With the signal ignored, a write fails as on a full disk.
        let output = Command::new("sh")
            .args(["-c", "trap '' XFSZ; ulimit -f 1; exec \"$@\"", "sh"])
            .arg(program().get_program())
            .args(["small.toml", "--solver", "lines", kind])
            .current_dir(room)
            .output()
            .unwrap();
        let stderr = String::from_utf8(output.stderr).unwrap();
        assert_eq!(output.status.code(), Some(2), "{kind}: {stderr}");
        assert!(stderr.starts_with("error: out") && stderr.lines().count() == 1, "{kind}: {stderr:?}");
        assert!(contents(&room.join("out")) == before, "{kind}: something else is there");
    }
}

/// If a directory has the name of one output file, none of the other files is written.
#[test]
fn a_place_that_is_taken() {
    let room = room();
    let room = room.path();
    for name in ["report.json", "positions.csv", "animation.gif", "frame-00005.png", "frame-00005.obj"] {
        let out = format!("out-{name}");
        fs::create_dir_all(room.join(&out).join(name)).unwrap();
        let args = ["small.toml", "--csv", "--gif", "--png", "--obj", "--every", "5", "--out", &out];
        refuses(room, &args, &format!("{out}/{name}: is a directory"));
        assert_eq!(names(&room.join(&out)), [name], "nothing beside it");
    }
}

/// Starts a run of many hours, and returns when it has written a part of its temporary file.
#[cfg(unix)]
fn interrupted(command: &mut Command, room: &Path) -> std::process::Child {
    let long = ["small.toml", "--csv", "--frames", "1000000", "--solver", "lines"];
    let mut running = command.current_dir(room).args(long).spawn().unwrap();
    let staged = || {
        fs::read_dir(room.join("out")).unwrap().any(|entry| {
            let entry = entry.unwrap();
            // The probe file may be deleted between the two calls.
            entry.file_name().to_string_lossy().starts_with('.')
                && entry.metadata().is_ok_and(|file| file.len() > 100_000)
        })
    };
    let start = Instant::now();
    while !staged() {
        assert!(start.elapsed().as_secs() < 60 && running.try_wait().unwrap().is_none(), "it writes nothing");
        std::thread::sleep(Duration::from_millis(5));
    }
    running
}

/// Sends a signal. Returns the exit status if the program ends within `patience`.
#[cfg(unix)]
fn signal(running: &mut std::process::Child, signal: &str, patience: Duration) -> Option<std::process::ExitStatus> {
    let sent = Command::new("sh").arg("-c").arg(format!("kill -{signal} {}", running.id())).status().unwrap();
    assert!(sent.success(), "{signal}");
    let start = Instant::now();
    while start.elapsed() < patience {
        if let Some(status) = running.try_wait().unwrap() {
            return Some(status);
        }
        std::thread::sleep(Duration::from_millis(5));
    }
    None
}

/// A signal in the middle of a run: the files of the run before stay unchanged, and no temporary file is left.
#[test]
#[cfg(target_os = "linux")]
fn a_signal_leaves_what_was_there() {
    let room = room();
    let room = room.path();
    succeeds(room, &["small.toml", "--csv"]);
    let before = contents(&room.join("out"));
    for (name, number) in [("INT", 2), ("TERM", 15), ("HUP", 1), ("QUIT", 3)] {
        // A test process that ignores the signal would pass this on to the program.
        let mut running = interrupted(Command::new("env").arg("--default-signal").arg(program().get_program()), room);
        let status = signal(&mut running, name, Duration::from_secs(60));
        let _ = running.kill();
        assert_eq!(status.expect(name).code(), Some(128 + number), "{name}");
        assert!(contents(&room.join("out")) == before, "{name}: something else is there");
    }

    let nohup = ["-c", "trap '' HUP; exec \"$@\"", "sh"];
    let mut running = interrupted(Command::new("sh").args(nohup).arg(program().get_program()), room);
    let ignored = signal(&mut running, "HUP", Duration::from_millis(200));
    running.kill().unwrap();
    running.wait().unwrap();
    assert_eq!(ignored, None, "as with nohup");
}

/// The program's peak memory, kB, as the system reported it last before the program ended.
#[cfg(target_os = "linux")]
fn peak_memory(room: &Path, args: &[&str]) -> u64 {
    use std::process::Stdio;

    let mut running = program().current_dir(room).args(args).stdout(Stdio::null()).spawn().unwrap();
    let mut peak = 0;
    while running.try_wait().unwrap().is_none() {
        let status = fs::read_to_string(format!("/proc/{}/status", running.id())).unwrap_or_default();
        let line = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        peak = peak.max(line.map_or(0, |line| line.trim().trim_end_matches(" kB").parse().unwrap()));
        std::thread::sleep(Duration::from_millis(2));
    }
    assert!(running.wait().unwrap().success(), "{args:?}");
    peak
}

/// Stills for pictures are recorded on the disk. In memory 1500 stills of this sheet would take 147 MB.
#[test]
#[cfg(target_os = "linux")]
fn memory_does_not_grow_with_frames() {
    let room = room();
    let room = room.path();
    let large = SMALL.replace("columns = 4\nrows = 4", "columns = 64\nrows = 64").replace("[3, 0]", "[63, 0]");
    // A run so short that the animation has two pictures.
    let large = large.replace("step = 0.02\nsubsteps = 4", "step = 2e-5\nsubsteps = 1");
    fs::write(room.join("large.toml"), large).unwrap();
    for kinds in [&["--gif"][..], &["--gif", "--png", "--every", "1000"]] {
        let peak = |frames| peak_memory(room, &[&["large.toml", "--frames", frames], kinds].concat());
        let (short, long) = (peak("100"), peak("1500"));
        assert!(long < short + short / 2, "{kinds:?}: {short} kB in 100 frames, {long} kB in 1500");
    }
}

/// An endless file, a file that is too large, and a file that would take a hundred times its size in memory.
#[test]
#[cfg(target_os = "linux")]
fn scene_files_without_bound_are_refused() {
    let room = room();
    let room = room.path();
    refuses(room, &["/dev/zero"], "/dev/zero: larger than 16 MB");
    fs::write(room.join("large.toml"), format!("{SMALL}#{}", "x".repeat(16 << 20))).unwrap();
    refuses(room, &["large.toml"], "large.toml: larger than 16 MB");
    fs::write(room.join("large.toml"), format!("{SMALL}#{}", "x".repeat(15 << 20))).unwrap();
    succeeds(room, &["large.toml", "--csv"]);
    let pins = format!("pins = [{}[3, 0]]", "[0, 0], ".repeat(1_200_000));
    fs::write(room.join("pins.toml"), SMALL.replace("pins = [[0, 0], [3, 0]]", &pins)).unwrap();
    let limited = Command::new("sh")
        .args(["-c", "ulimit -v 400000; exec \"$@\"", "sh"])
        .arg(program().get_program())
        .arg("pins.toml")
        .current_dir(room)
        .output()
        .unwrap();
    let stderr = String::from_utf8_lossy(&limited.stderr);
    assert_eq!(limited.status.code(), Some(2), "{stderr}");
    assert!(stderr.contains("pins.toml: line 10: more than 262144 values"), "{stderr}");
}

/// No name of a scene or a file sends control characters to a terminal.
#[test]
#[cfg(unix)]
fn control_characters_are_not_printed() {
    let room = room();
    let room = room.path();
    fs::write(room.join("named.toml"), SMALL.replace("name = \"small\"", r#"name = "\u001b[31mred\u009b\u202e""#))
        .unwrap();
    fs::write(room.join("key.toml"), SMALL.replace("name = \"small\"", r#""\u001b[31m\u202e" = 1"#)).unwrap();
    fs::write(room.join("\u{1b}[31m.toml"), "[cloth\n").unwrap();
    let runs = [
        &["named.toml", "--csv", "--out", "\u{1b}[31mout"][..],
        &["key.toml"],
        &["\u{1b}[31m.toml"],
        &["\u{1b}[31m\u{202e}"],
        &["small.toml", "--scalar", "\u{1b}[31m"],
    ];
    for args in runs {
        let output = run(room, args);
        for text in [output.stdout, output.stderr].map(|text| String::from_utf8(text).unwrap()) {
            let hidden = text.chars().find(|c| c.is_control() && *c != '\n' || *c == '\u{202e}');
            assert_eq!(hidden, None, "{args:?}: {text:?}");
        }
        let expected = if args == runs[0] { 0 } else { 2 };
        assert_eq!(output.status.code(), Some(expected), "{args:?}");
    }
    let stdout = succeeds(room, runs[0]);
    assert!(stdout.contains(r"\u{1b}[31mred\u{9b}\u{202e}"), "{stdout}");
}

/// Paths need not be valid UTF-8.
#[test]
#[cfg(target_os = "linux")]
fn paths_that_are_not_text() {
    use std::ffi::OsStr;
    use std::os::unix::ffi::OsStrExt;

    let room = room();
    let room = room.path();
    let [scene, out] = [&b"caf\xe9.toml"[..], b"sortie\xe9"].map(OsStr::from_bytes);
    fs::write(room.join(scene), SMALL.replace("name = \"small\"", "")).unwrap();
    let output = program().current_dir(room).arg(scene).args(["--csv", "--gif", "--out"]).arg(out).output().unwrap();
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && stderr.is_empty(), "{stderr}");
    assert_eq!(names(&room.join(out)), ["animation.gif", "positions.csv", "report.json"]);
    let missing = program().current_dir(room).arg(OsStr::from_bytes(b"\xe9.toml")).output().unwrap();
    assert_eq!(missing.status.code(), Some(2));
    assert!(String::from_utf8(missing.stderr).unwrap().starts_with("error: \u{fffd}.toml: "));
}

/// A kill in the middle of a run: the files of the run before stay unchanged.
#[test]
#[cfg(unix)]
fn an_interrupted_run_leaves_what_was_there() {
    let room = room();
    let room = room.path();
    succeeds(room, &["small.toml", "--csv"]);
    let before = contents(&room.join("out"));
    let mut running = interrupted(&mut program(), room);
    running.kill().unwrap();
    running.wait().unwrap();
    let mut after = contents(&room.join("out"));
    after.retain(|name, _| !name.starts_with('.'));
    assert!(after == before, "the old files changed");
}

/// The names and contents of the files of a directory.
fn contents(directory: &Path) -> BTreeMap<String, Vec<u8>> {
    names(directory).into_iter().map(|name| (name.clone(), fs::read(directory.join(name)).unwrap())).collect()
}

#[test]
fn a_window_needs_its_feature() {
    refuses(room().path(), &["small.toml", "--window"], "--window: ");
}

#[test]
fn numbers_that_the_type_cannot_hold() {
    let room = room();
    let room = room.path();
    for (scalar, from, to, reason) in [
        ("q24", "origin = [-0.5, -0.5, 1.0]", "origin = [-0.5, 50.0, 1.0]", "cloth.origin: more than 128 cells"),
        ("f32", "origin = [-0.5, -0.5, 1.0]", "origin = [1e5, 0.0, 1.0]", "cloth.origin: more than"),
        ("q24", "width = 1.0", "width = 0.01", "cloth.width: too small beside cloth.height for q24"),
        ("q24", "width = 1.0", "width = 1e3", "cloth.height: too small beside cloth.width for q24"),
        ("f32", "width = 1.0", "width = 1e308", "cloth.width: too large"),
        ("f64", "density = 0.2", "mass = 1e308", "cloth.mass: too large"),
        ("f32", "density = 0.2", "density = 1e-308", "cloth.density: too small"),
        ("f32", "step = 0.02", "step = 1e19", "solver.step: too large"),
        ("q24", "gravity = [0.0, 0.0, -9.81]", "gravity = [0.0, 0.0, 1e9]", "environment.gravity: too large for q24"),
        ("q24", "gravity = [0.0, 0.0, -9.81]", "gravity = [0.0, 0.0, 1e-5]", "environment.gravity: too small for q24"),
        ("f32", "gravity = [0.0, 0.0, -9.81]", "gravity = [0.0, 0.0, 1e45]", "environment.gravity: too large for f32"),
        ("q24", "radius = 0.3", "radius = 30.0", "sphere[0].radius: too large for q24"),
        ("q24", "radius = 0.3", "radius = 0.3\nmargin = 60.0", "sphere[0].margin: too large for q24"),
        ("f64", "radius = 0.3", "radius = 5e307\nmargin = 5e307", "sphere[0].radius: too large for f64"),
        ("f64", "radius = 0.3", "radius = 2e307\nmargin = 1.7e308", "sphere[0].margin: too large for f64"),
        ("f64", "radius = 0.3", "radius = 0.3\nvelocity = [0, 0, 1.7e308]", "sphere[0].velocity: more than"),
        ("q24", "radius = 0.3", "radius = 0.3\nfriction = 200", "sphere[0].friction: too large for q24"),
        ("q24", "radius = 0.3", "radius = 0.3\nvelocity = [0, 0, 300.0]", "sphere[0].velocity: more than 128 cells"),
        ("f32", "centre = [0.0, 0.0, 0.4]", "centre = [0.0, 1e39, 0.4]", "sphere[0].centre: more than"),
        ("q24", "stiffness = 100.0", "stiffness = 1e-6", "stretch.stiffness: too small for q24"),
        ("f32", "stiffness = 100.0", "stiffness = 1e-60", "stretch.stiffness: too small for f32"),
        ("q24", "stiffness = 100.0", "compliance = 1e7", "stretch.compliance: too small for q24"),
        ("q24", "density = 0.2", "density = 0.2\nhem = 500", "cloth.hem: too large for q24"),
        ("q24", "density = 0.2", "density = 0.2\nhem = 0.04", "cloth.hem: too large for q24"),
        (
            "q24",
            "[run]",
            "[[capsule]]\na = [-30.0, 0.0, 0.0]\nb = [30.0, 0.0, 0.0]\nradius = 0.1\n[run]",
            "capsule[0].b: too large for q24",
        ),
        ("q24", "kind = \"xpbd\"", "kind = \"lines\"\ntolerance = 1e-9", "solver.tolerance: too small for q24"),
        ("f64", "width = 1.0\nheight = 1.0\ndensity", "width = 5e-324\nheight = 1.0\nmass", "cloth.width: too small"),
        ("q24", "[run]", "[rest]\nspeed = 1e-9\n[run]", "rest.speed: too small for q24"),
        ("q24", "[run]", "[rest]\nacceleration = 1e6\n[run]", "rest.acceleration: too large for q24"),
        ("q24", "substeps = 4", "strain_limit = 100", "solver.strain_limit: too large for q24"),
        (
            "q24",
            "-9.81]",
            "-0.0003]",
            "environment.gravity: too small for q24 in this cell size, mass and step: rounding",
        ),
        ("q13", "-9.81]", "-9.81]\ndrag = 1.5e-5", "environment.drag: too small for q13"),
        ("q24", "stiffness = 100.0", "stiffness = 8e-5", "stretch.stiffness: too small for q24"),
        ("q24", "stiffness = 100.0", "stiffness = 100.0\ndamping = 4e-7", "stretch.damping: too small for q24"),
        ("q24", "radius = 0.3", "radius = 0.3\nfriction = 9e-8", "sphere[0].friction: too small for q24"),
    ] {
        assert_eq!(SMALL.matches(from).count(), 1, "{from:?}");
        fs::write(room.join("bad.toml"), SMALL.replace(from, to)).unwrap();
        refuses(room, &["bad.toml", "--scalar", scalar], reason);
    }
}

#[test]
fn positions_are_those_of_the_recorded_frames() {
    let room = room();
    let room = room.path();
    succeeds(room, &["small.toml", "--csv", "--every", "3", "--scalar", "f64"]);
    assert_eq!(names(&room.join("out")), ["positions.csv", "report.json"]);
    let table = fs::read_to_string(room.join("out/positions.csv")).unwrap();
    let mut lines = table.lines();
    assert_eq!(lines.next(), Some("frame,column,row,x,y,z"));

    let scene = Description::parse(SMALL).unwrap();
    let mut simulation = simulation(&scene, ScalarKind::F64).unwrap();
    for frame in 0..=10 {
        if frame > 0 {
            simulation.frame();
        }
        if frame % 3 != 0 && frame != 10 {
            continue;
        }
        for (index, position) in simulation.still().positions.into_iter().enumerate() {
            let line = lines.next().unwrap();
            let fields: Vec<_> = line.split(',').collect();
            let place = [frame, index % 4, index / 4].map(|number| number.to_string());
            assert_eq!(fields[..3], place, "{line}");
            let written = [3, 4, 5].map(|field| fields[field].parse::<f64>().unwrap().to_bits());
            assert_eq!(written, position.map(f64::to_bits), "{line}: every digit comes back");
        }
    }
    assert_eq!(lines.next(), None);
}

/// The numbers in the lines of an OBJ file that begin with `word`.
fn obj_lines(text: &str, word: &str) -> Vec<Vec<f64>> {
    let lines = text.lines().filter_map(|line| line.strip_prefix(word)?.strip_prefix(' '));
    let numbers = |line: &str| line.split([' ', '/']).map(|number| number.parse().unwrap()).collect();
    lines.map(numbers).collect()
}

#[test]
fn meshes_are_those_of_the_recorded_frames() {
    let room = room();
    let room = room.path();
    succeeds(room, &["small.toml", "--obj", "--csv", "--every", "6"]);
    let files = ["frame-00000.obj", "frame-00006.obj", "frame-00010.obj"];
    assert_eq!(names(&room.join("out")), [&files[..], &["positions.csv", "report.json"]].concat());
    let table = fs::read_to_string(room.join("out/positions.csv")).unwrap();
    let number = |field: &str| field.parse::<f64>().unwrap();
    let mut rows = table.lines().skip(1).map(|line| line.split(',').skip(3).map(number).collect::<Vec<_>>());
    for name in files {
        let text = fs::read_to_string(room.join("out").join(name)).unwrap();
        assert!(text.starts_with("# small, frame "), "{text}");
        let (places, normals) = (obj_lines(&text, "v"), obj_lines(&text, "vn"));
        assert_eq!(places, rows.by_ref().take(16).collect::<Vec<_>>(), "{name}: every digit comes back");
        for normal in &normals {
            assert!((normal.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-5, "{name}: {normal:?}");
        }
        let texture = obj_lines(&text, "vt");
        assert_eq!((texture.len(), &texture[0], &texture[15]), (16, &vec![0.0, 1.0], &vec![1.0, 0.0]));
        let faces = obj_lines(&text, "f");
        assert_eq!((faces.len(), normals.len()), (18, 16));
        for face in faces {
            let corners = [0, 3, 6].map(|corner| {
                assert_eq!(face[corner..corner + 3], [face[corner]; 3], "{name}");
                face[corner] as usize - 1
            });
            let [a, b, c] = corners.map(|corner| &places[corner]);
            let [d, e] = [b, c].map(|end| [0, 1, 2].map(|axis| end[axis] - a[axis]));
            let across = [0, 1, 2].map(|k| d[(k + 1) % 3] * e[(k + 2) % 3] - d[(k + 2) % 3] * e[(k + 1) % 3]);
            for corner in corners {
                let facing: f64 = across.iter().zip(&normals[corner]).map(|(a, b)| a * b).sum();
                assert!(facing > 0.0, "{name}: {face:?}");
            }
        }
    }
    assert_eq!(rows.next(), None);
}

#[test]
fn the_mesh_of_a_chain_is_a_line() {
    let room = room();
    let chain = SMALL.replace("columns = 4\nrows = 4\nwidth = 1.0", "columns = 1\nrows = 32\nwidth = 0.0");
    let chain = chain.replace("density = 0.2", "mass = 1e-3").replace("[3, 0]", "[0, 31]");
    fs::write(room.path().join("chain.toml"), chain).unwrap();
    succeeds(room.path(), &["chain.toml", "--obj", "--every", "10"]);
    let text = fs::read_to_string(room.path().join("out/frame-00010.obj")).unwrap();
    assert_eq!([obj_lines(&text, "v").len(), obj_lines(&text, "vt").len(), obj_lines(&text, "f").len()], [32, 32, 0]);
    let line = &obj_lines(&text, "l")[0];
    assert!(line.chunks(2).enumerate().all(|(index, vertex)| vertex == [index as f64 + 1.0; 2]), "{line:?}");
}

#[test]
fn the_report_has_its_keys_in_order() {
    let room = room();
    let room = room.path();
    let stdout = succeeds(room, &["small.toml", "--csv", "--scalar", "q24", "--substeps", "3", "--frames", "7"]);
    let text = fs::read_to_string(room.join("out/report.json")).unwrap();
    let at = |key: &&str| text.find(&format!("\"{key}\":")).unwrap_or_else(|| panic!("no {key} in {text}"));
    let keys = [
        "scene",
        "scalar",
        "solver",
        "columns",
        "rows",
        "frames",
        "frames_at_rest",
        "substeps",
        "iterations",
        "seconds",
        "steps_per_second",
        "particle_steps_per_second",
        "max_strain_motion",
        "max_strain_end",
        "rms_strain_end",
        "energy_start",
        "energy_end",
        "digest",
        "finite",
    ];
    assert!(keys.iter().map(at).is_sorted(), "{text}");
    let report = report(room);
    assert_eq!(report.len(), keys.len(), "{text}");

    let mut scene = Description::parse(SMALL).unwrap();
    scene.solver.substeps = 3;
    let mut simulation = simulation(&scene, ScalarKind::Q24).unwrap();
    let start = simulation.energy();
    let mut motion = 0.0_f64;
    for _ in 0..7 {
        simulation.frame();
        motion = motion.max(simulation.strains().stretch.unwrap().largest);
    }
    let strains = simulation.strains();
    assert_eq!(report["scene"], "small");
    assert_eq!(report["scalar"], "q24");
    assert_eq!(report["solver"], "xpbd");
    assert_eq!((&report["columns"], &report["rows"]), (&4.into(), &4.into()));
    assert_eq!((&report["frames"], &report["substeps"], &report["iterations"]), (&7.into(), &3.into(), &1.into()));
    assert_eq!(report["max_strain_motion"]["stretch"], motion);
    assert_eq!(report["max_strain_end"]["stretch"], strains.stretch.unwrap().largest);
    assert_eq!(report["max_strain_end"]["shear"], strains.shear.unwrap().largest);
    assert!(report["max_strain_end"]["bend"].is_null(), "the scene has no bend links");
    assert_eq!(report["rms_strain_end"], strains.all.rms);
    for (key, energy) in [("energy_start", start), ("energy_end", simulation.energy())] {
        let reported = report[key].as_f64().unwrap();
        assert!((reported / energy - 1.0).abs() < 1e-15, "{key}: {reported}, not {energy}");
    }
    assert_eq!(report["digest"], simulation.digest());
    assert_eq!(report["finite"], true);
    let [seconds, steps, particle_steps] =
        ["seconds", "steps_per_second", "particle_steps_per_second"].map(|key| report[key].as_f64().unwrap());
    assert!(seconds > 0.0 && (steps * seconds / 21.0 - 1.0).abs() < 1e-9);
    assert!((particle_steps / steps / 16.0 - 1.0).abs() < 1e-9);
    assert!(stdout.contains(&format!("{:#010x}", simulation.digest())), "{stdout}");
}

/// A built-in scene of a sheet with self-contact: the report has the number of contacts and the number of self-intersections.
#[test]
fn a_sheet_that_meets_itself_is_reported() {
    let room = room();
    let stdout = succeeds(room.path(), &["heap", "--csv", "--every", "60", "--frames", "60", "--intersections"]);
    let with = report(room.path());
    let contacts = with["self_contacts"].as_u64().unwrap();
    assert!(contacts > 50 && with["self_intersections"] == 0, "{stdout}");
    assert!(stdout.contains(&format!("meets itself in   {contacts} places at most")), "{stdout}");
    assert!(stdout.contains("passes through    0 times"), "{stdout}");

    let heap = kerchief::host::built_in("heap").unwrap().text.replace("[self]\nfriction = 0.3\n", "");
    fs::write(room.path().join("heap.toml"), heap).unwrap();
    succeeds(room.path(), &["heap.toml", "--csv", "--every", "60", "--frames", "60", "--intersections"]);
    let without = report(room.path());
    assert!(without["self_intersections"].as_u64().unwrap() > 1000 && !without.contains_key("self_contacts"));
}

/// A change to a sheet at rest.
type Disturb = fn(&mut dyn Simulation);

/// `[rest]` saves computation without changing the result: the sheet has the same final state, and moves again when it is disturbed.
#[test]
fn a_sheet_at_rest_is_not_computed() {
    let room = room();
    let room = room.path();
    let damped = SMALL.replace("[environment]", "[environment]\ndrag = 5.0");
    fs::write(room.join("resting.toml"), format!("{damped}[rest]\n")).unwrap();
    let stdout = succeeds(room, &["resting.toml", "--csv", "--every", "1000", "--frames", "1000"]);
    let report = report(room);
    let at_rest = report["frames_at_rest"].as_u64().unwrap();
    assert!(
        (500..1000).contains(&at_rest) && stdout.contains(&format!("at rest           {at_rest} frames")),
        "{stdout}"
    );

    let scene = Description::parse(&damped).unwrap();
    let mut moving = simulation(&scene, ScalarKind::F32).unwrap();
    (0..1000 - at_rest).for_each(|_| moving.frame());
    assert_eq!(report["digest"], moving.digest(), "as it was when it came to rest");
    assert!(!moving.is_at_rest(), "a scene without [rest] never is");

    let scene = Description::parse(&format!("{damped}[rest]\n")).unwrap();
    let disturbances: [(&str, Disturb); 4] = [
        ("gravity", |simulation| simulation.set_gravity([0.0, 1.0, -9.81]).unwrap()),
        ("a pin let go", |simulation| simulation.set_pinned(3, 0, false)),
        ("another state", |simulation| {
            let mut state = simulation.state();
            state.velocities[9][1] = 0.1;
            simulation.restore(&state);
        }),
        ("wind", |simulation| {
            let wind = Wind { velocity: [0.0, 1.0, 0.0], model: WindModel::Facet };
            simulation.set_wind(Some(&wind)).unwrap();
        }),
    ];
    for (what, disturb) in disturbances {
        // A new simulation each time: by XPBD, a sheet on one pin and a ball turns at 0.6 mm/s forever and never rests again.
        let mut resting = simulation(&scene, ScalarKind::F32).unwrap();
        (0..1000).for_each(|_| resting.frame());
        assert!(resting.is_at_rest(), "before {what}");
        let digest = resting.digest();
        disturb(&mut *resting);
        resting.frame();
        assert!(!resting.is_at_rest() && resting.digest() != digest, "{what}");
    }
}

/// `sweeps` in a file overrides its `iterations`, but the option overrides both.
#[test]
fn the_command_line_overrides_the_file() {
    let room = room();
    let room = room.path();
    fs::write(room.join("swept.toml"), SMALL.replace("substeps = 4", "substeps = 4\nsweeps = 1")).unwrap();
    let report = |scene: &str, iterations: &[&str]| {
        succeeds(room, &[&[scene, "--solver", "lines", "--csv"], iterations].concat());
        report(room)
    };
    let three = report("small.toml", &["--iterations", "3"]);
    assert_eq!((three.get("sweeps"), &three["iterations"]), (None, &3.into()));
    let swept = report("swept.toml", &[]);
    assert_eq!(swept["sweeps"], 1);
    assert_ne!(swept["digest"], three["digest"]);
    let overridden = report("swept.toml", &["--iterations", "3"]);
    assert_eq!(overridden["digest"], three["digest"]);
    assert_eq!(overridden.get("sweeps"), None);
}

/// In fixed point a sheet that leaves the range would reappear at its other end.
#[test]
fn a_sheet_that_falls_out_of_range_is_reported() {
    let room = room();
    let room = room.path();
    let beside_the_ball = SMALL.replace("origin = [-0.5,", "origin = [5.0,");
    fs::write(room.join("free.toml"), beside_the_ball.replace("pins = [[0, 0], [3, 0]]", "")).unwrap();
    for (scalar, frames, finite) in [("q24", "140", true), ("q24", "160", false), ("f32", "160", true)] {
        let args = ["free.toml", "--csv", "--scalar", scalar, "--frames", frames];
        if finite {
            succeeds(room, &args);
        } else {
            explodes(room, &args, "a particle left the range of q24");
        }
        assert_eq!(report(room)["finite"], finite, "{scalar} after {frames} frames");
    }
}

/// Asserts that a run writes its report, and ends with one line that names the frame of the explosion and its reason. Returns the frame.
fn explodes(room: &Path, args: &[&str], reason: &str) -> u32 {
    let output = run(room, args);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(3), "{args:?}: {stderr}");
    assert_eq!(stderr.lines().count(), 1, "{args:?}: {stderr:?}");
    assert!(
        stderr.contains(reason) && stderr.trim_end().ends_with("see docs/guide/symptoms.md"),
        "{args:?}: {stderr:?}"
    );
    let stdout = String::from_utf8(output.stdout).unwrap();
    assert!(stdout.contains("finite            no") && stdout.contains("written to"), "{args:?}: {stdout}");
    assert_eq!(report(room)["finite"], false, "{args:?}");
    let frame = stderr.strip_prefix("error: exploded in frame ").unwrap_or_else(|| panic!("{stderr:?}"));
    frame.split_once(':').unwrap().0.parse().unwrap()
}

#[test]
fn exploded_runs_say_so() {
    let room = room();
    let room = room.path();
    let wild = SMALL.replace("stiffness = 100.0", "stiffness = 1e9");
    fs::write(room.join("wild.toml"), &wild).unwrap();
    let args = ["wild.toml", "--solver", "forward-euler", "--csv", "--frames", "50", "--scalar"];
    let number = explodes(room, &[&args[..], &["f64"]].concat(), "further than a million sheet sizes");
    assert!(number < 10, "{number}");
    // A run that ends with this frame: the sheet is far away but finite.
    let frames = number.to_string();
    let short = ["wild.toml", "--solver", "forward-euler", "--csv", "--scalar", "f64", "--frames", &frames];
    assert_eq!(explodes(room, &short, "further than a million sheet sizes"), number);
    assert_eq!(names(&room.join("out")), ["positions.csv", "report.json"]);
    let table = fs::read_to_string(room.join("out/positions.csv")).unwrap();
    assert_eq!(table.lines().count(), 1 + 16 * (number as usize + 1), "every frame is there");
    let furthest =
        table.lines().skip(1).flat_map(|line| line.split(',').skip(3)).map(|x| x.parse::<f64>().unwrap().abs());
    let furthest = furthest.fold(0.0, f64::max);
    assert!(furthest.is_finite() && furthest > 1e6, "{furthest}");
    fs::write(room.join("blown.toml"), wild.replace("step = 0.02", "step = 2e9")).unwrap();
    explodes(room, &["blown.toml", "--solver", "forward-euler", "--csv"], "a number is not finite");
    let help = succeeds(room, &["--help"]);
    assert!(help.contains("3 if the sheet exploded"), "{help}");
}

#[test]
fn a_file_without_a_name_is_called_as_it_is() {
    let room = room();
    let room = room.path();
    fs::write(room.join("nameless.toml"), SMALL.replace("name = \"small\"", "")).unwrap();
    succeeds(room, &["nameless.toml", "--csv"]);
    assert!(fs::read_to_string(room.join("out/report.json")).unwrap().contains("\"scene\": \"nameless\""));
}

#[test]
fn a_plain_run_writes_an_animation_as_fast_as_the_scene() {
    let room = room();
    let room = room.path();
    let stdout = succeeds(room, &["small.toml"]);
    assert_eq!(names(&room.join("out")), ["animation.gif", "report.json"]);
    assert!(stdout.contains("small: 4 x 4 particles, 10 frames"), "{stdout}");

    let mut options = gif::DecodeOptions::new();
    options.set_color_output(gif::ColorOutput::RGBA);
    let mut decoder = options.read_info(fs::File::open(room.join("out/animation.gif")).unwrap()).unwrap();
    assert_eq!((decoder.width(), decoder.height()), (540, 540));
    assert_eq!(decoder.repeat(), gif::Repeat::Infinite);
    let mut delays = Vec::new();
    let mut changed = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        delays.push(frame.delay);
        changed.push(frame.buffer.chunks(4).filter(|pixel| pixel[3] != 0).count());
    }
    // 10 frames of 0.02 s: every second one is shown, the last one for a second.
    assert_eq!(delays, [4, 4, 4, 4, 4, 100]);
    assert_eq!(changed[0], 540 * 540);
    assert!(changed[1..].iter().all(|count| (100..540 * 270).contains(count)), "{changed:?}");
}

#[test]
fn an_animation_ends_with_the_end() {
    let room = room();
    let room = room.path();
    succeeds(room, &["small.toml", "--frames", "9"]);
    let mut decoder = gif::Decoder::new(fs::File::open(room.join("out/animation.gif")).unwrap()).unwrap();
    let mut delays = Vec::new();
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        delays.push(frame.delay);
    }
    assert_eq!(delays, [4, 4, 4, 6, 100]);
}

#[test]
fn frames_are_pictures_of_the_recorded_moments() {
    let room = room();
    let room = room.path();
    succeeds(room, &["small.toml", "--png", "--every", "4", "--out", "deep/er"]);
    let directory = room.join("deep/er");
    let pictures = ["frame-00000.png", "frame-00004.png", "frame-00008.png", "frame-00010.png"];
    assert_eq!(names(&directory)[..4], pictures);
    assert_eq!(names(&directory)[4..], ["report.json"]);
    let pictures = pictures.map(|name| image::open(directory.join(name)).unwrap().to_rgb8());
    for picture in &pictures {
        assert_eq!(picture.dimensions(), (540, 540));
        let red = picture.pixels().filter(|pixel| pixel[0] / 2 > pixel[1].max(pixel[2])).count();
        assert!((5_000..200_000).contains(&red), "{red} pixels of the sheet's red");
    }
    assert_ne!(pictures[0], pictures[1]);
    assert_ne!(pictures[2], pictures[3]);
}

#[test]
fn sheets_that_blow_up_are_reported_and_drawn() {
    let room = room();
    let room = room.path();
    fs::write(room.join("wild.toml"), SMALL.replace("stiffness = 100.0", "stiffness = 1e9")).unwrap();
    explodes(room, &["wild.toml", "--solver", "forward-euler", "--frames", "50", "--png", "--every", "10"], "");
    assert_eq!(names(&room.join("out")).len(), 7);
    let report = report(room);
    assert_eq!(report["finite"], false);
    for key in ["max_strain_motion", "max_strain_end"] {
        for family in ["stretch", "shear"] {
            assert!(report[key][family].is_null(), "{key}: {family} is undefined, not {}", report[key][family]);
        }
    }
}

#[test]
fn every_number_type_grid_and_solver_runs() {
    for &(columns, rows) in SHAPES {
        let cells = if columns > 1 { columns - 1 } else { 1 };
        let text = format!(
            "[cloth]\ncolumns = {columns}\nrows = {rows}\nwidth = {}\nheight = {}\nmass = 0.01\npins = \"top\"\n\
             [stretch]\nstiffness = 10\ndamping = 0.001\n[shear]\nstiffness = 1\n[bend]\nstiffness = 1\n\
             [environment]\ngravity = [0, 0, -9.81]\nwind = {{ velocity = [1, 1, 1], model = \"facet\" }}\n\
             [solver]\nstep = 0.01\nsubsteps = 2\n",
            0.1 * cells as f64,
            0.1 * (rows - 1) as f64,
        );
        let mut scene = Description::parse(&text).unwrap();
        for kind in SolverKind::ALL {
            scene.solver.kind = kind;
            let lowest = ScalarKind::ALL.map(|scalar| {
                let mut simulation = simulation(&scene, scalar).unwrap();
                let start = simulation.still().positions;
                (0..5).for_each(|_| simulation.frame());
                assert!(simulation.is_finite());
                let end = simulation.still().positions;
                assert_eq!(start[..columns], end[..columns], "pins hold");
                end.iter().fold(f64::MAX, |lowest, [_, _, z]| lowest.min(*z))
            });
            // A free fall is 1.2 cm.
            assert!(lowest.iter().all(|z| (-0.03..-0.005).contains(z)), "{} {columns}x{rows}: {lowest:?}", kind.name());
            let spread = lowest.iter().fold(0.0_f64, |spread, z| spread.max((z - lowest[1]).abs()));
            assert!(spread < 1e-4, "{} {columns}x{rows}: {lowest:?}", kind.name());
        }
    }
}

#[test]
fn a_state_moves_from_one_solver_and_number_type_to_another() {
    let mut scene = Description::parse(SMALL).unwrap();
    let mut before = simulation(&scene, ScalarKind::F64).unwrap();
    (0..5).for_each(|_| before.frame());
    before.set_pinned(3, 0, false);
    scene.solver.kind = SolverKind::Verlet;
    scene.solver.substeps = 7;
    let mut after = simulation(&scene, ScalarKind::F64).unwrap();
    after.restore(&before.state());
    let (before, after) = (before.state(), after.state());
    let difference = |a: &[[f64; 3]], b: &[[f64; 3]]| {
        a.iter().flatten().zip(b.iter().flatten()).fold(0.0_f64, |largest, (a, b)| largest.max((a - b).abs()))
    };
    assert!(difference(&before.still.positions, &after.still.positions) < 1e-14);
    assert!(difference(&before.velocities, &after.velocities) < 1e-13);
    assert_eq!(before.pinned, after.pinned);
    assert!(before.pinned[0] && !before.pinned[3]);
}
