//! Compares the parser's defaults with those on the page.

use kerchief::host::{Description, Everything};

use crate::file::Scene;
use crate::page::{Row, quoted};

/// The deviations from the row's default. `scene` has the required keys of its table.
pub(crate) fn complaints(scene: &Scene<'_>, row: &Row) -> Vec<String> {
    let path = scene.path(&row.key);
    let default = row.default.as_str();
    let others = quoted(default, '`');
    if let Some(rest) = default.strip_prefix("required") {
        let other = others.first().filter(|_| rest.starts_with(", or "));
        return required(scene, &row.key, other.map(String::as_str));
    }
    if let Some(rest) = default.strip_prefix("off") {
        return match (rest.split_once(" `").map_or(rest, |(word, _)| word), others.first()) {
            ("", None) => off(scene, &given(scene, row), &path),
            ("; not with", Some(other)) => {
                let mut complaints = off(scene, &given(scene, row), &path);
                if given(scene, row).key(other, None).parse().is_ok() {
                    complaints.push(format!("{path} is taken with {other}"));
                }
                complaints
            }
            ("; with", Some(other)) => {
                let mut complaints = off(scene, &given(scene, row).key(other, None), &path);
                if given(scene, row).parse().is_ok() {
                    complaints.push(format!("{path} is taken without {other}"));
                }
                complaints
            }
            _ => vec![format!("{path}: no default {default:?}")],
        };
    }
    match default {
        "2 × `iterations`" => sweeps(),
        "a cell's longer side" => thickness(),
        _ => match &others[..] {
            [value] if default == format!("`{value}`") => said(scene, row, value),
            _ => vec![format!("{path}: no default {default:?}")],
        },
    }
}

/// The scene with the key, or, if the key is a table, with that table's required keys.
pub(crate) fn given<'a>(scene: &Scene<'a>, row: &Row) -> Scene<'a> {
    match row.range.as_str() {
        "a table" => scene.table_within(&row.key),
        _ => scene.clone().key(&row.key, None),
    }
}

fn required(scene: &Scene<'_>, key: &str, other: Option<&str>) -> Vec<String> {
    let path = scene.path(key);
    let mut complaints = Vec::new();
    let neither = other.map_or(scene.clone(), |other| scene.clone().without(other)).without(key);
    let instead = other.map(|other| scene.path(other));
    match neither.parse() {
        Ok(_) => complaints.push(format!("{path} is not required")),
        Err(error)
            if error.reason.starts_with("missing") && (error.key == path || Some(error.key.clone()) == instead) => {}
        Err(error) => complaints.push(format!("{path} is required for another reason: {error}")),
    }
    if let Err(error) = neither.clone().key(key, None).parse() {
        complaints.push(format!("{path} is refused: {error}"));
    }
    if let Some(other) = other
        && neither.key(key, None).key(other, None).parse().is_ok()
    {
        complaints.push(format!("{path} is taken with {other}"));
    }
    complaints
}

fn meaning(scene: &Scene<'_>) -> Result<String, String> {
    scene.parse().map(|scene| format!("{scene:?}")).map_err(|error| error.to_string())
}

/// Checks that the scenes first differ by an absent and a present value.
pub(crate) fn off(without: &Scene<'_>, with: &Scene<'_>, path: &str) -> Vec<String> {
    let (without, with) = match (meaning(without), meaning(with)) {
        (Ok(without), Ok(with)) => (without, with),
        (Err(error), _) | (_, Err(error)) => return vec![format!("{path}: {error}")],
    };
    let same = without.bytes().zip(with.bytes()).take_while(|(a, b)| a == b).count();
    let [without, with] = [&without, &with].map(|text| text.get(same..).unwrap_or_default());
    let is_off = without.starts_with("None") && with.starts_with("Some(") || without.starts_with(']');
    if is_off { Vec::new() } else { vec![format!("{path} is not off where it is left out")] }
}

/// Checks that the default as an explicit value changes nothing, and that another value does.
fn said(scene: &Scene<'_>, row: &Row, value: &str) -> Vec<String> {
    let path = scene.path(&row.key);
    let number = |text: &str| text.parse::<f64>().ok();
    let fraction = value.split_once('/').and_then(|(a, b)| Some(number(a)? / number(b)?));
    let value = fraction.map_or_else(|| value.to_owned(), |fraction| fraction.to_string());
    let silent = meaning(&scene.clone().without(&row.key));
    let mut complaints = Vec::new();
    if meaning(&scene.clone().key(&row.key, Some(&value))) != silent {
        complaints.push(format!("{path} = {value} is not the default"));
    }
    if meaning(&scene.clone().key(&row.key, None)) == silent {
        complaints.push(format!("{path} changes nothing"));
    }
    complaints
}

/// The digest of a sheet that has crumpled on the ground, with this further table.
fn end(table: &str) -> u32 {
    let text = format!(
        "[cloth]\ncolumns = 8\nrows = 8\nwidth = 0.7\nheight = 0.7\nmass = 0.01\npose = \"hang\"\norigin = [0, 0, 0.75]\n\
         [stretch]\nstiffness = 100\n[environment]\ngravity = [0, 1, -9.81]\n\
         [[plane]]\npoint = [0, 0, 0]\nnormal = [0, 0.1, 1]\nfriction = 0.5\n{table}\n"
    );
    let mut moving = Description::parse(&text).unwrap().simulation_on::<Everything, f64, 8, 8>().unwrap();
    (0..60).for_each(|_| moving.frame());
    moving.digest()
}

fn sweeps() -> Vec<String> {
    let ends = ["", "sweeps = 6", "sweeps = 5"].map(|sweeps| end(&format!("[solver]\niterations = 3\n{sweeps}")));
    if ends[0] == ends[1] && ends[1] != ends[2] { Vec::new() } else { vec![format!("solver.sweeps: {ends:?}")] }
}

fn thickness() -> Vec<String> {
    let ends = ["", "thickness = 0.1", "thickness = 0.09"].map(|thickness| end(&format!("[self]\n{thickness}")));
    if ends[0] == ends[1] && ends[1] != ends[2] { Vec::new() } else { vec![format!("self.thickness: {ends:?}")] }
}
