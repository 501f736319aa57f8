//! Compares the parser with every range on the page: it must accept values within each bound and refuse those beyond.

use kerchief::host::{Everything, SHAPES};

use crate::file::Scene;
use crate::page::{Row, quoted};

/// Values that must be accepted, and values that must be refused.
struct Probes {
    taken: Vec<String>,
    refused: Vec<String>,
}

/// A finite value beyond every bound of a key.
const HUGE: &str = "1e300";
/// A positive value nearer to zero than every bound.
const TINY: &str = "1e-300";

fn probes(scene: &Scene<'_>, row: &Row) -> Option<Probes> {
    let strings = |values: &[&str]| values.iter().map(|value| String::from(*value)).collect::<Vec<_>>();
    let numbers = |taken: &[&str], refused: &[&str]| {
        let never = ["nan", "inf", "-inf", "\"1\"", "[1]", "true"];
        Some(Probes { taken: strings(taken), refused: strings(&[refused, &never[..]].concat()) })
    };
    let names = quoted(&row.range, '"');
    let vector = row.range.strip_prefix("`[x, y, z]`");
    match row.range.as_str() {
        "any" => numbers(&[&format!("-{HUGE}"), "0", HUGE], &[]),
        "> 0" => numbers(&[TINY, HUGE], &["0", &format!("-{TINY}")]),
        "≥ 0" => numbers(&["0", TINY, HUGE], &[&format!("-{TINY}"), "-1"]),
        "0 ≤ x < 1" => numbers(&["0", TINY, "0.999999999"], &[&format!("-{TINY}"), "1", "1.000000001"]),
        "text" => Some(Probes { taken: strings(&["\"\"", "\"ß\""]), refused: strings(&["1", "[1]"]) }),
        "two of `\"#rrggbb\"`" => Some(Probes {
            taken: strings(&["[\"#000000\", \"#ffffff\"]", "[\"#09afAF\", \"#000000\"]"]),
            refused: strings(&[
                "[\"#000000\"]",
                "[\"#000000\", \"#000000\", \"#000000\"]",
                "[\"#00000\", \"#000000\"]",
                "[\"#00000g\", \"#000000\"]",
                "[\"000000\", \"#000000\"]",
            ]),
        }),
        range if range.starts_with("`[[column, row], …]`") => Some(Probes {
            taken: [strings(&["[]", "[[0, 0], [3, 3]]"]), named(&names)].concat(),
            refused: strings(&["[[4, 0]]", "[[0, 4]]", "[[-1, 0]]", "[[0]]", "[[0, 0, 0]]", "\"no-such-name\""]),
        }),
        _ if vector.is_some() => {
            let mut refused = strings(&["[1, 2]", "[1, 2, 3, 4]", "[inf, 0, 0]", "[0, nan, 0]", "1", "\"x\""]);
            let mut taken = strings(&["[90, 91, 92.5]", "[90, 1e300, 92]"]);
            match vector {
                Some("") => taken = strings(&["[0, 0, 0]", "[-1, -2e300, -3]"]),
                Some(", not zero") => refused.push("[0, 0, 0]".into()),
                Some(", not below `low`") => refused.extend(other(scene, "low", |x| x - 1.0)),
                _ => {}
            }
            // nor the same vector
            if let [_, key] = &quoted(&row.range, '`')[..] {
                refused.extend(other(scene, key, |x| x));
            }
            Some(Probes { taken, refused })
        }
        _ if !names.is_empty() => {
            Some(Probes { taken: named(&names), refused: strings(&["\"no-such-name\"", "1", "[1]"]) })
        }
        range => {
            let (whole, bounds) = range.strip_prefix("whole, ").map_or((false, range), |bounds| (true, bounds));
            let (low, high) = bounds.split_once(" to ")?;
            let (least, most): (f64, f64) = (low.parse().ok()?, high.parse().ok()?);
            let step = if whole { 1.0 } else { 1e-9 * most };
            let (below, above) = ((least - step).to_string(), (most + step).to_string());
            let none = if whole { "1.5" } else { "nan" };
            numbers(&[low, high], &[&below, &above, none])
        }
    }
}

fn named(names: &[String]) -> Vec<String> {
    names.iter().map(|name| format!("\"{name}\"")).collect()
}

/// The vector of another key in `scene`, with every component changed.
fn other(scene: &Scene<'_>, key: &str, change: fn(f64) -> f64) -> Option<String> {
    let components = scene.value(key)?.trim_matches(['[', ']']).split(", ");
    let changed: Vec<_> = components.map(|x| change(x.parse().unwrap()).to_string()).collect();
    Some(format!("[{}]", changed.join(", ")))
}

/// The deviations from the row's range. `scene` has the keys that the row's key needs.
pub(crate) fn complaints(scene: &Scene<'_>, row: &Row) -> Vec<String> {
    let path = scene.path(&row.key);
    match row.range.as_str() {
        "a table" => return Vec::new(),
        "a grid" => return grids(scene, &row.key, &path),
        "0.75 to 1 cell" => return cells(scene, &row.key, &path),
        _ => {}
    }
    let Some(probes) = probes(scene, row) else { return vec![format!("{path}: no range {:?}", row.range)] };
    let mut complaints = Vec::new();
    for value in &probes.taken {
        if let Err(error) = scene.clone().key(&row.key, Some(value)).parse() {
            complaints.push(format!("{path} = {value} is refused: {error}"));
        }
    }
    for value in &probes.refused {
        match scene.clone().key(&row.key, Some(value)).parse() {
            Ok(_) => complaints.push(format!("{path} = {value} is taken")),
            Err(error) if error.key.starts_with(&path) => {}
            Err(error) => complaints.push(format!("{path} = {value} is refused for another reason: {error}")),
        }
    }
    // the parser lists the names that it knows
    if quoted(&row.range, '"').iter().any(|name| !name.starts_with('#')) {
        let error = scene.clone().key(&row.key, Some("\"no-such-name\"")).parse().map(|_| ()).unwrap_err();
        let expected = error.reason.split_once("expected").map_or("", |(_, expected)| expected);
        let mark = if expected.contains('`') { '`' } else { '"' };
        let (mut known, mut said) = (quoted(expected, mark), quoted(&row.range, '"'));
        known.sort();
        said.sort();
        if known != said {
            complaints.push(format!("{path}: the parser knows {known:?}, the page {said:?}"));
        }
    }
    complaints
}

/// Every pair of numbers up to 65 must be accepted or refused according to [`SHAPES`], which the page lists.
fn grids(scene: &Scene<'_>, key: &str, path: &str) -> Vec<String> {
    let mut complaints = Vec::new();
    for columns in 0..66 {
        for rows in 0..66 {
            let scene = scene.clone().key("columns", Some(&columns.to_string())).key("rows", Some(&rows.to_string()));
            if scene.parse().is_ok() != SHAPES.contains(&(columns, rows)) {
                complaints.push(format!("{path}: {columns} x {rows} is not as SHAPES says"));
            }
        }
    }
    for value in ["4.0", "\"4\"", "0", "-4"] {
        if scene.clone().key(key, Some(value)).parse().is_ok() {
            complaints.push(format!("{path} = {value} is taken"));
        }
    }
    complaints
}

/// A cell of the scene's sheet is half a metre long. Its length is known only when the simulation is built.
fn cells(scene: &Scene<'_>, key: &str, path: &str) -> Vec<String> {
    let expected = [("0.375", true), ("0.5", true), ("0.3749", false), ("0.5001", false), ("0", false), ("nan", false)];
    let wrong = expected.into_iter().filter(|(value, is_taken)| {
        let scene = scene.clone().key(key, Some(value)).parse();
        scene.and_then(|scene| scene.simulation_on::<Everything, f32, 4, 4>()).is_ok() != *is_taken
    });
    wrong.map(|(value, is_taken)| format!("{path} = {value}: taken should be {is_taken}")).collect()
}
