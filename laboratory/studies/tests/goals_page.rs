//! The tables of goals in `docs/line-solver.md`: their results are those of `docs/laboratory/work_precision.csv`.
//!
//! `UPDATE_GOALS=1 cargo test -p laboratory --test goals_page` writes them.

use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

/// A row of the study, as far as the tables need it. Cells without a number are empty, or say why.
#[derive(Deserialize)]
struct Row {
    scene: String,
    solver: String,
    scalar: String,
    error: String,
    strain: String,
    instructions: String,
}

/// A row of a table: its label, the scene, the quantity, its bounds and the goals in thousands of instructions.
struct Goal {
    label: &'static str,
    scene: &'static str,
    quantity: fn(&Row) -> Option<f64>,
    bounds: [f64; 3],
    goals: [Option<f64>; 3],
    percent: bool,
}

const ERROR: fn(&Row) -> Option<f64> = |row| row.error.parse().ok();
const STRAIN: fn(&Row) -> Option<f64> = |row| row.strain.parse().ok();

const GOALS: [Goal; 7] = [
    error("two corners, 16 × 16", "two-corners-16", [1.8, 6.0, 20.0]),
    error("top edge, 32 × 32", "top-edge-32", [1.0, 2.0, 8.0]),
    error("flag, 32 × 32", "flag-32", [1.0, 4.0, 20.0]),
    strain("two corners, 16 × 16", "two-corners-16-stiff", [Some(1.5), Some(3.0), Some(7.0)]),
    strain("two corners, 32 × 32", "two-corners-32-stiff", [Some(3.0), Some(6.0), Some(25.0)]),
    strain("two corners and a ball, 32 × 32", "ball-32-stiff", [Some(4.0), Some(15.0), None]),
    strain("upright, 32 × 32, every compliance 1e-8 m/N, 1/60 s", "upright-32", [None, Some(1.9), None]),
];

const fn error(label: &'static str, scene: &'static str, [a, b, c]: [f64; 3]) -> Goal {
    let goals = [Some(a), Some(b), Some(c)];
    Goal { label, scene, quantity: ERROR, bounds: [1e-2, 1e-3, 1e-4], goals, percent: false }
}

const fn strain(label: &'static str, scene: &'static str, goals: [Option<f64>; 3]) -> Goal {
    Goal { label, scene, quantity: STRAIN, bounds: [0.1, 0.01, 0.001], goals, percent: true }
}

impl Goal {
    /// The row of results: the cheapest run within each bound, or the most accurate one and what it reaches.
    fn reached(&self, rows: &[Row]) -> String {
        let runs: Vec<[f64; 2]> = rows
            .iter()
            .filter(|row| row.scene == self.scene && row.solver == "lines" && row.scalar == "f32")
            .filter_map(|row| Some([(self.quantity)(row)?, row.instructions.parse::<f64>().ok()? / 1e3]))
            .collect();
        assert!(runs.len() > 10, "{}: {} runs", self.scene, runs.len());
        let cell = |bound: f64, goal: Option<f64>| {
            let within = runs.iter().filter(|[value, _]| *value <= bound).map(|[_, cost]| *cost);
            let Some(cost) = within.min_by(f64::total_cmp) else {
                let [value, cost] = *runs.iter().min_by(|a, b| a[0].total_cmp(&b[0])).expect("a run");
                let value = if self.percent { format!("{:.2} %", 100.0 * value) } else { format!("{value:.1e}") };
                return format!("{} for {value}", two_digits(cost));
            };
            let text = two_digits(cost);
            if goal.is_some_and(|goal| cost <= goal) { format!("**{text}**") } else { text }
        };
        let cells = [0, 1, 2].map(|k| cell(self.bounds[k], self.goals[k]));
        format!("| | reached | {} |", cells.join(" | "))
    }
}

fn two_digits(number: f64) -> String {
    let digits = (1.0 - number.log10().floor()).max(0.0) as usize;
    format!("{number:.digits$}")
}

fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

#[test]
fn results_of_goals_are_those_of_the_laboratory() {
    let mut table = csv::Reader::from_path(root().join("docs/laboratory/work_precision.csv")).unwrap();
    let rows: Vec<Row> = table.deserialize().collect::<Result<_, _>>().unwrap();
    let page = root().join("docs/line-solver.md");
    let old = fs::read_to_string(&page).unwrap();
    let mut lines: Vec<String> = old.lines().map(str::to_owned).collect();
    let mut from = 0;
    for goal in &GOALS {
        let start = format!("| {} | goal |", goal.label);
        let at = from + lines[from..].iter().position(|line| line.starts_with(&start)).expect(goal.label);
        let shown = lines[at].split('|').skip(3).map(|cell| cell.split_whitespace().next()?.parse().ok());
        assert_eq!(shown.take(3).collect::<Vec<Option<f64>>>(), goal.goals, "{}: goals", goal.label);
        assert!(lines[at + 1].starts_with("| | reached |"), "{}: results", goal.label);
        lines[at + 1] = goal.reached(&rows);
        from = at + 1;
    }
    let new = lines.join("\n") + "\n";
    if std::env::var_os("UPDATE_GOALS").is_some() {
        fs::write(page, new).unwrap();
    } else {
        assert!(new == old, "docs/line-solver.md doesn't show docs/laboratory/work_precision.csv:\n{new}");
    }
}
