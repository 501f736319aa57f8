//! The scene file's reference, `docs/guide/scene-file.md`, against the parser: every key, every bound, every default.

use kerchief::host::SHAPES;

use crate::file::Scene;
use crate::page::{quoted, rows, sections, tables};

mod default;
mod file;
mod page;
mod range;

const PAGE: &str = include_str!("../../docs/guide/scene-file.md");

/// The keys that the parser knows in a table. It lists them when it finds an unknown key.
fn known(scene: &Scene<'_>) -> Vec<String> {
    let error = scene.clone().key("no-such-key", Some("0")).parse().map(|_| ()).unwrap_err();
    if !error.key.ends_with("no-such-key") || !error.reason.starts_with("unknown key") {
        return vec![error.to_string()];
    }
    let mut keys = quoted(&error.reason, '`');
    keys.sort();
    keys
}

/// The differences between the page and the parser.
fn complaints(text: &str) -> Vec<String> {
    let page = sections(text);
    let mut complaints = Vec::new();
    let tables = tables(&page);
    for table in &tables {
        let scene = Scene::with(&page, table);
        let of_table = rows(&page, table);
        let mut said: Vec<_> = of_table.iter().map(|row| row.key.clone()).collect();
        if table.is_empty() {
            let top = tables.iter().filter(|table| !table.is_empty() && !table.contains('.'));
            said.extend(top.map(|table| table.trim_matches(['[', ']']).to_owned()));
        }
        said.sort();
        let known = known(&scene);
        if said != known {
            complaints.push(format!("{table:?}: the page has {said:?}, the parser {known:?}"));
            continue;
        }
        complaints.extend(exclusions(&scene, &of_table));
        for row in &of_table {
            complaints.extend(default::complaints(&scene, row));
            complaints.extend(range::complaints(&with_needs(&scene, row), row));
            let below = format!("[{}]", scene.path(&row.key));
            if (row.range == "a table") != tables.contains(&below) {
                complaints.push(format!("{below} is a table in one place only"));
            }
        }
    }
    complaints
}

/// The pairs of keys that the parser refuses together although the page does not exclude them.
fn exclusions(scene: &Scene<'_>, rows: &[page::Row]) -> Vec<String> {
    let mut complaints = Vec::new();
    for (index, row) in rows.iter().enumerate() {
        for other in &rows[..index] {
            let names = format!("`{}`", other.key);
            let is_said = row.default.contains(&names) && !row.default.contains("; with ");
            if is_said || [row, other].iter().any(|row| row.range == "a table") {
                continue;
            }
            let both = with_needs(&with_needs(scene, row), other).key(&row.key, None).key(&other.key, None);
            if let Err(error) = both.parse() {
                complaints.push(format!("{} is not taken with {}: {error}", scene.path(&row.key), other.key));
            }
        }
    }
    complaints
}

/// The scene with the keys that a key needs, and without those that it excludes.
fn with_needs<'a>(scene: &Scene<'a>, row: &page::Row) -> Scene<'a> {
    let Some(other) = quoted(&row.default, '`').pop() else { return scene.clone() };
    if row.default.starts_with("off; with ") {
        scene.clone().key(&other, None)
    } else if row.default.starts_with("required, or ") {
        scene.clone().without(&other)
    } else {
        scene.clone()
    }
}

#[test]
fn the_page_says_what_the_parser_does() {
    let complaints = complaints(PAGE);
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

#[test]
fn grids_are_listed() {
    let line = PAGE.lines().find(|line| line.starts_with("Grids (columns × rows): ")).expect("a line of grids");
    let list = line.split_once(": ").and_then(|(_, rest)| rest.split_once('.')).expect("a sentence").0;
    let grids = list.split(", ").map(|grid| grid.split_once(" × ").expect("columns × rows"));
    let grids: Vec<(usize, usize)> = grids.map(|(c, r)| (c.parse().unwrap(), r.parse().unwrap())).collect();
    assert_eq!(grids, SHAPES);
}

/// Without a table its feature is off, or its keys have their defaults.
#[test]
fn tables_that_are_left_out_are_off_or_defaults() {
    let page = sections(PAGE);
    let without = Scene::with(&page, "[cloth]");
    for table in tables(&page).iter().filter(|table| !table.is_empty() && *table != "[cloth]") {
        let with = Scene::with(&page, table);
        let [silent, said] = [&without, &with].map(|scene| format!("{:?}", scene.parse().unwrap()));
        let off = default::off(&without, &with, table);
        assert!(silent == said || off.is_empty(), "{off:?}");
    }
}

/// Every change of the page in one place causes a complaint with the given words.
#[test]
fn every_kind_of_mistake_is_noticed() {
    let mistakes = [
        // a key of the parser that is not on the page, and the other way round
        ("| `hem` | – | > 0 | off | factor of border particles' mass |\n", "", "the parser"),
        ("| `hem` |", "| `hems` |", "hems"),
        ("## `[run]`", "## `[runs]`", "runs"),
        // defaults
        ("| `tolerance` | – | > 0 | `0.02` |", "| `tolerance` | – | > 0 | `0.01` |", "solver.tolerance = 0.01"),
        ("| `1/60` |", "| `1/50` |", "solver.step"),
        ("| `hem` | – | > 0 | off |", "| `hem` | – | > 0 | `1` |", "cloth.hem"),
        ("| `strain_limit` | – | > 0 | off |", "| `strain_limit` | – | > 0 | required |", "solver.strain_limit"),
        ("| `slack` | – | ≥ 0 | `0` |", "| `slack` | – | ≥ 0 | off |", "tether.slack is not off"),
        ("| `height` | m | > 0 | required |", "| `height` | m | > 0 | `1` |", "cloth.height"),
        ("off; not with `drag`", "off", "environment.verlet_damping"),
        ("| off; with `low` |", "| off |", "picture.high"),
        ("`[\"#f3eadc\", \"#b82e34\"]`", "`[\"#f3eadc\", \"#b82e35\"]`", "picture.colours"),
        // ranges
        ("| `damping` | N·s/m | ≥ 0 |", "| `damping` | N·s/m | > 0 |", "stretch.damping = 0 is taken"),
        ("| `height` | m | > 0 |", "| `height` | m | ≥ 0 |", "cloth.height = 0 is refused"),
        ("| `azimuth` | degrees | any |", "| `azimuth` | degrees | -360 to 360 |", "is taken"),
        ("-90 to 90", "-89 to 90", "picture.elevation"),
        ("-90 to 90", "-90 to 91", "picture.elevation"),
        ("| 0 ≤ x < 1 |", "| ≥ 0 |", "environment.verlet_damping"),
        ("| `frames` | – | whole, 1 to 1048576 |", "| `frames` | – | whole, 1 to 1000000 |", "run.frames"),
        ("| `frames` | – | whole, 1 to 1048576 |", "| `frames` | – | whole, 2 to 1048576 |", "run.frames"),
        ("| `\"lay\"`, `\"hang\"` |", "| `\"lay\"` |", "cloth.pose"),
        ("`\"left\"`, ", "", "cloth.pins"),
        ("`[x, y, z]`, not zero", "`[x, y, z]`", "plane[0].normal"),
        ("`[x, y, z]`, not `a`", "`[x, y, z]`, not `b`", "capsule[0].b"),
        ("| `point` | m | `[x, y, z]` |", "| `point` | m | `[x, y, z]`, not zero |", "plane[0].point"),
    ];
    for (from, to, words) in mistakes {
        assert_eq!(PAGE.matches(from).count(), 1, "{from:?} must stand on the page once");
        let complaints = complaints(&PAGE.replacen(from, to, 1)).join("\n");
        assert!(complaints.contains(words), "{from:?} as {to:?}: {complaints:?}");
    }
}
