//! The laboratory's programs: output and refusals.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use tempfile::TempDir;

/// A sheet whose operations are counted, and so soft that its reference is computed in an instant.
const SMALL: &str = r#"
name = "small"
[cloth]
columns = 16
rows = 16
width = 1.0
height = 1.0
mass = 0.01
pins = [[0, 0], [15, 0]]
[stretch]
stiffness = 20.0
[shear]
stiffness = 2.0
[environment]
gravity = [0.0, 0.0, -9.81]
[solver]
step = 0.05
[run]
frames = 4
"#;

/// The built program.
fn program(name: &str) -> Command {
    Command::new(match name {
        "board_precision" => env!("CARGO_BIN_EXE_board_precision"),
        "convergence" => env!("CARGO_BIN_EXE_convergence"),
        "discretisation" => env!("CARGO_BIN_EXE_discretisation"),
        "figures" => env!("CARGO_BIN_EXE_figures"),
        "stability" => env!("CARGO_BIN_EXE_stability"),
        "work_precision" => env!("CARGO_BIN_EXE_work_precision"),
        _ => panic!("no program {name}"),
    })
}

/// A working directory with the scenes `small.toml` and `tiny.toml`.
fn room() -> TempDir {
    let room = tempfile::tempdir().unwrap();
    fs::write(room.path().join("small.toml"), SMALL).unwrap();
    let tiny = SMALL.replace("= 16", "= 4").replace("[15, 0]", "[3, 0]").replace("\"small\"", "\"tiny\"");
    fs::write(room.path().join("tiny.toml"), tiny).unwrap();
    room
}

fn run(room: &Path, name: &'static str, args: &[&str]) -> Output {
    program(name).current_dir(room).args(args).output().unwrap()
}

/// Asserts that a program succeeds and prints nothing on stderr.
fn succeeds(room: &Path, name: &'static str, args: &[&str]) -> String {
    let output = run(room, name, args);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && stderr.is_empty(), "{name} {args:?}: {stderr}");
    String::from_utf8(output.stdout).unwrap()
}

/// Asserts one line on stderr that contains `reason`, exit status 2, and no new files.
fn refuses(room: &Path, name: &'static str, args: &[&str], reason: &str) {
    let before = names(room);
    let output = run(room, name, args);
    let stderr = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{name} {args:?}: {stderr}");
    assert_eq!(stderr.lines().count(), 1, "{name} {args:?}: {stderr:?}");
    assert!(stderr.starts_with("error: ") && stderr.contains(reason), "{name} {args:?}: {stderr:?}, not {reason:?}");
    assert!(output.stdout.is_empty(), "{name} {args:?}");
    assert_eq!(names(room), before, "{name} {args:?} left something");
}

fn names(directory: &Path) -> Vec<String> {
    let entries = fs::read_dir(directory).unwrap();
    let mut names: Vec<_> = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap()).collect();
    names.sort();
    names
}

/// The head of a table, and its rows by column names.
fn table(path: &Path) -> (Vec<String>, Vec<BTreeMap<String, String>>) {
    let mut reader = csv::Reader::from_path(path).unwrap();
    let head = reader.headers().unwrap().iter().map(String::from).collect();
    (head, reader.deserialize().map(Result::unwrap).collect())
}

/// Asserts that a file is a plot: its elements are nested correctly, it contains `words`, and it has at least this number of curves.
fn assert_plot(path: &Path, words: &[&str], curves: usize) {
    let svg = fs::read_to_string(path).unwrap();
    assert!(svg.starts_with("<svg ") && svg.ends_with("</svg>\n"), "{}", path.display());
    let mut open = Vec::new();
    for tag in svg.split('<').skip(1) {
        let (tag, _) = tag.split_once('>').expect("a tag ends");
        let name = tag.trim_start_matches('/').split([' ', '/', '\n']).next().unwrap();
        if tag.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "{}", path.display());
        } else if !tag.ends_with('/') {
            open.push(name);
        }
    }
    assert!(open.is_empty(), "{}: {open:?}", path.display());
    for word in words {
        assert!(svg.contains(word), "{}: no {word:?}", path.display());
    }
    assert!(svg.matches("<polyline").count() >= curves, "{}", path.display());
    for number in ["NaN", "inf"] {
        assert!(!svg.contains(number), "{}: {number}", path.display());
    }
}

#[test]
fn errors_are_put_against_operations() {
    let room = room();
    let room = room.path();
    let args = ["small.toml", "--solvers", "lines,xpbd,forward-euler", "--scalars", "f32,q24", "--substeps", "2,4,8"];
    let more = [
        "--sweeps",
        "1",
        "--cost",
        "operations",
        "--error",
        "1e-2",
        "--budget",
        "3000",
        "--reference-error",
        "1e-4",
        "--tolerance",
        "0.02",
    ];
    let said = succeeds(room, "work_precision", &[&args[..], &more].concat());
    assert!(said.starts_with("small: error 1e-2: ") && said.contains("operations"), "{said}");
    let out = room.join("out/work_precision");
    assert_eq!(names(&out), ["small-error.svg", "small-strain.svg", "work_precision.csv", "work_precision.md"]);
    assert_eq!(names(&room.join("out/references")).len(), 1);

    let (head, rows) = table(&out.join("work_precision.csv"));
    let expected = "scene solver scalar substeps sweeps tolerance error strain instructions operations additions products quotients roots \
                    comparisons time_ratio";
    assert_eq!(head.join(" "), expected);
    assert_eq!(rows.len(), 18);
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    for row in &rows {
        if row["solver"] == "forward-euler" {
            assert!(row["error"] == "diverged" || number(row, "error") > 0.0, "{row:?}");
            continue;
        }
        let kinds = ["additions", "products", "quotients", "roots", "comparisons"].map(|kind| number(row, kind));
        assert!((kinds.iter().sum::<f64>() - number(row, "operations")).abs() < 0.5, "{row:?}");
        assert!(kinds.iter().all(|count| *count > 0.0), "{row:?}");
        assert!(number(row, "error") < 0.2 && number(row, "strain") > 0.0, "{row:?}");
        assert_eq!(row["instructions"], "");
    }
    // More substeps cost more and have smaller errors.
    let lines: Vec<_> = rows.iter().filter(|row| row["solver"] == "lines" && row["scalar"] == "f32").collect();
    for pair in lines.windows(2) {
        assert!(number(pair[0], "operations") < number(pair[1], "operations"), "{pair:?}");
        assert!(number(pair[0], "error") > number(pair[1], "error"), "{pair:?}");
    }
    assert_plot(&out.join("small-error.svg"), &["operations per particle and frame", "position error", "lines q24"], 5);
    assert_plot(&out.join("small-strain.svg"), &["largest stretch strain", "Pareto front"], 5);
    let page = fs::read_to_string(out.join("work_precision.md")).unwrap();
    assert!(page.contains("The reference is leapfrog in f64") && page.contains("(small-error.svg)"), "{page}");
}

#[test]
fn instructions_are_counted_where_valgrind_is() {
    let room = room();
    let room = room.path();
    let args = ["tiny.toml", "--solvers", "xpbd", "--scalars", "f32", "--substeps", "1,2,4", "--strain-only"];
    let args = [&args[..], &["--cost", "instructions"]].concat();
    if Command::new("valgrind").arg("--version").output().is_err() {
        refuses(room, "work_precision", &args, "--cost instructions: valgrind is not there");
        return;
    }
    succeeds(room, "work_precision", &args);
    let out = room.join("out/work_precision");
    assert_eq!(names(&out), ["tiny-strain.svg", "work_precision.csv", "work_precision.md"]);
    let (_, rows) = table(&out.join("work_precision.csv"));
    let counts: Vec<f64> = rows.iter().map(|row| row["instructions"].parse().unwrap()).collect();
    assert_eq!(counts.len(), 3);
    // Each configuration has twice as many substeps as the one before.
    for pair in counts.windows(2) {
        let ratio = pair[1] / pair[0];
        assert!((1.8..2.2).contains(&ratio), "{counts:?}");
    }
    assert!(rows.iter().all(|row| row["error"].is_empty() && row["operations"].is_empty()), "{rows:?}");
}

#[test]
fn orders_energies_and_floors() {
    let room = room();
    let room = room.path();
    let args = ["tiny.toml", "--substeps", "32,64", "--energy-scene", "tiny.toml", "--seconds", "0.2"];
    succeeds(room, "convergence", &args);
    let out = room.join("out/convergence");
    let plots = ["energy-tiny.svg", "order-tiny.svg", "rounding-tiny.svg"];
    assert_eq!(
        names(&out),
        [&["convergence.md", "energy-tiny.svg", "energy.csv"][..], &["order-tiny.svg", "orders.csv"], &plots[2..]]
            .concat()
    );
    let (_, rows) = table(&out.join("orders.csv"));
    let error = |solver: &str, substeps: &str| {
        let row = rows.iter().find(|row| row["solver"] == solver && row["substeps"] == substeps).unwrap();
        row["error"].parse::<f64>().unwrap()
    };
    // In substeps this short, fixed point does not represent the springs.
    let args =
        ["tiny.toml", "--substeps", "32,1500", "--frames", "1", "--energy-scene", "tiny.toml", "--seconds", "0.1"];
    succeeds(room, "convergence", &[&args[..], &["--out", "fine"]].concat());
    let page = fs::read_to_string(room.join("fine/convergence.md")).unwrap();
    assert!(page.lines().any(|line| line.starts_with("| lines × 1 q24 |") && line.contains("| – |")), "{page}");
    for (solver, order) in [("leapfrog", 2.0), ("lines", 2.0), ("xpbd", 1.0), ("backward-euler", 1.0)] {
        let found = (error(solver, "32") / error(solver, "64")).log2();
        assert!((found - order).abs() < 0.2, "{solver}: {found}");
    }
    assert_plot(&out.join(plots[0]), &["time, s", "change of energy"], 5);
    assert_plot(&out.join(plots[1]), &["substep, s", "orders 1 and 2"], 7);
    assert_plot(&out.join(plots[2]), &["substeps per frame", "lines × 1 q24"], 7);
}

#[test]
fn grids_and_parameters() {
    let room = room();
    let room = room.path();
    succeeds(room, "discretisation", &["--sides", "8,12,16", "--side", "8", "--seconds", "0.6", "--substeps", "4"]);
    let out = room.join("out/discretisation");
    let expected = "discretisation.md grids.csv grids.png grids.svg parameters.csv parameters.png parameters.svg";
    assert_eq!(names(&out).join(" "), expected);
    let (head, rows) = table(&out.join("grids.csv"));
    assert_eq!(head.join(" "), "side cell sag strain distance_at_rest distance_in_motion");
    let motion: Vec<Option<f64>> = rows.iter().map(|row| row["distance_in_motion"].parse().ok()).collect();
    let [Some(coarse), Some(fine), None] = motion[..] else { panic!("{motion:?}") };
    assert!(fine < coarse && coarse < 0.01, "{motion:?}");
    let (_, rows) = table(&out.join("parameters.csv"));
    let sag = |property: &str, factor: &str| {
        let row = rows.iter().find(|row| row["property"] == property && row["factor"] == factor).unwrap();
        row["sag"].parse::<f64>().unwrap()
    };
    assert!(sag("stretch stiffness C", "4.0") < sag("stretch stiffness C", "0.25"));
    assert!(sag("density", "4.0") > sag("density", "0.25"));
    assert_plot(&out.join("grids.svg"), &["side of a cell", "at rest"], 4);
    assert_plot(&out.join("parameters.svg"), &["factor on the property", "sag, mm", "iterations"], 7);
    let picture = image::open(out.join("grids.png")).unwrap().to_rgb8();
    assert!(picture.width() > 3 * 300 && picture.pixels().any(|pixel| pixel.0 != [255; 3]));
}

/// Leapfrog becomes unstable at its theoretical limit. The line solver is stable everywhere.
#[test]
fn maps_of_stability() {
    let room = room();
    let room = room.path();
    let args =
        ["--solvers", "leapfrog,lines", "--scalars", "f64,q24", "--points", "4", "--frames", "120", "--most", "16"];
    succeeds(room, "stability", &args);
    let out = room.join("out/stability");
    let expected = "stability-centre-energy.svg stability-centre-strain.svg stability-compliance-strain.svg stability-grid-energy.svg \
                    stability-grid-strain.svg stability-laid-energy.svg stability-laid-strain.svg stability-mass-strain.svg \
                    stability-stiffness-energy.svg stability-stiffness-strain.svg stability-storm-strain.svg stability-wind-strain.svg stability.csv stability.md";
    assert_eq!(names(&out).join(" "), expected);
    let (head, rows) = table(&out.join("stability.csv"));
    assert_eq!(head.join(" "), "map solver scalar across up outcome strain energy");
    let number = |row: &BTreeMap<String, String>, key: &str| row[key].parse::<f64>().unwrap();
    let (mut below, mut above) = (0, 0);
    for row in rows.iter().filter(|row| row["map"] == "stiffness" && row["scalar"] == "f64") {
        // ω² = 4·(k + k_shear)/m, 0.2 kg in 64 particles
        let limit = (0.2 / 64.0 / (1.1 * number(row, "across"))).sqrt();
        let step = number(row, "up") / limit;
        if row["solver"] == "lines" {
            assert_eq!(row["outcome"], "held", "{row:?}");
        } else if step < 0.9 {
            assert_eq!(row["outcome"], "held", "{row:?}");
            below += 1;
        } else if step > 1.5 {
            assert_eq!(row["outcome"], "gone", "{row:?}");
            above += 1;
        }
    }
    assert!(below > 1 && above > 1, "{below} steps below the limit, {above} above");
    for row in rows.iter().filter(|row| row["solver"] == "lines" && row["map"] != "compliance") {
        assert_ne!(row["outcome"], "gone", "{row:?}");
    }
    for map in ["centre", "compliance", "grid", "laid", "mass", "stiffness", "storm", "wind"] {
        let path = out.join(format!("stability-{map}-strain.svg"));
        assert_plot(&path, &["limit of theory", "lines q24", "leapfrog f64", "gone"], 2);
    }
    let page = fs::read_to_string(out.join("stability.md")).unwrap();
    assert!(page.contains("| leapfrog, theory |") && page.contains("| lines q24 |"), "{page}");
}

#[test]
fn what_is_wrong_is_one_line() {
    let room = room();
    let room = room.path();
    fs::write(room.join("bad.toml"), SMALL.replace("mass = 0.01", "mass = 0.0")).unwrap();
    fs::write(
        room.join("weightless.toml"),
        SMALL.replace("-9.81", "0.0").replace("= 16", "= 4").replace("[15, ", "[3, "),
    )
    .unwrap();
    for (args, reason) in [
        (&["nowhere"][..], "no scene or file \"nowhere\"; built-in scenes: two-corners-16, "),
        (&["missing.toml"], "missing.toml: "),
        (&["bad.toml"], "bad.toml: cloth.mass: must be above zero, is 0"),
        (
            &["tiny.toml", "--cost", "operations"],
            "tiny: operations are counted for undamped sheets of 16 × 16 and 32 × 32 only",
        ),
        (&["small.toml", "--substeps", "0"], "'--substeps <N,…>'"),
        (&["small.toml", "--substeps", "8,x"], "invalid value 'x' for '--substeps <N,…>'"),
        (&["small.toml", "--solvers", "magic"], "[possible values: verlet, "),
        (&["small.toml", "--scalars", "f16"], "[possible values: f32, f64, q24, q13]"),
        (&["small.toml", "--error", "0"], "must be finite and above zero"),
        (&["small.toml", "--seconds", "inf"], "must be finite and above zero"),
        (&["small.toml", "--work", "1", "--substeps", "2", "--cost", "operations"], "--work: leaves no configuration"),
        (&["small.toml", "--cost", "time"], "[possible values: instructions, operations]"),
        (&["small.toml", "--out", "small.toml"], "--out: small.toml: "),
    ] {
        refuses(room, "work_precision", args, reason);
    }
    for (args, reason) in [
        (&["nowhere"][..], "no scene or file \"nowhere\""),
        (&["bad.toml"], "bad.toml: cloth.mass"),
        (&["tiny.toml", "--energy-scene", "nowhere"], "no scene or file \"nowhere\""),
        (&["tiny.toml", "--energy-scene", "weightless.toml"], "small: environment.gravity: without it"),
        (&["tiny.toml", "--seconds", "-1"], "'-1'"),
        (&["tiny.toml", "--out", "small.toml/out"], "--out: small.toml/out: "),
    ] {
        refuses(room, "convergence", args, reason);
    }
    for (args, reason) in [
        (&["--points", "1"][..], "'--points <N>'"),
        (&["--solvers", "magic"], "[possible values: verlet, "),
        (&["--out", "small.toml"], "--out: small.toml: "),
    ] {
        refuses(room, "stability", args, reason);
    }
    for (args, reason) in [
        (&["--sides", "8,9"][..], "one of 8, 12, 16, 24, 32, 48, 64"),
        (&["--sides", "8,8"], "--sides: at least two grids are compared"),
        (&["--side", "1"], "one of 8, 12,"),
        (&["--seconds", "0"], "must be finite and above zero"),
        (&["--substeps", "0"], "'--substeps <N>'"),
        (&["--out", "small.toml"], "--out: small.toml: "),
    ] {
        refuses(room, "discretisation", args, reason);
    }
}
