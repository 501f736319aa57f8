//! The largest stable step.

use kerchief::host::{ScalarKind, SolverKind};

use crate::experiment::Outcome;
use crate::map::{Field, Map};
use laboratory::page::Page;

/// A run counts as stable if its strain is below this.
const MOST: f64 = 0.25;

/// Adds the table of largest stable steps for four stiffnesses of the map.
pub(crate) fn report(maps: &[Map], page: &mut Page) {
    let Some(map) = maps.iter().find(|map| map.plan.name == "stiffness") else { return };
    page.paragraph("## Largest stable step");
    page.paragraph(&format!(
        "In ms. At this step of the map and at all shorter ones, the sheet does not become black and no stretch link is strained by {} % or more. *All*: every step of the map.",
        100.0 * MOST
    ));
    let nearest = |wanted: f64| {
        let distance = |value: &f64| (value / wanted).ln().abs();
        (0..map.across.len())
            .min_by(|&a, &b| distance(&map.across[a]).total_cmp(&distance(&map.across[b])))
            .unwrap_or(0)
    };
    let mut columns = [1e2, 1e4, 1e7, 1e10].map(nearest).to_vec();
    columns.dedup();
    let heads: Vec<_> = columns.iter().map(|&column| format!("{:.0e} N/m", map.across[column])).collect();
    let mut head = vec!["solver"];
    head.extend(heads.iter().map(String::as_str));
    let theory = [SolverKind::Leapfrog, SolverKind::ForwardEuler]
        .into_iter()
        .filter(|kind| map.fields.iter().any(|field| field.solver == *kind));
    let theory = theory.map(|kind| {
        let limit = |&column: &usize| map.plan.limit(kind, map.across[column]).map_or("–".into(), milliseconds);
        [format!("{}, theory", kind.name())].into_iter().chain(columns.iter().map(limit)).collect::<Vec<_>>()
    });
    let found = map.fields.iter().map(|field| {
        let cells = columns.iter().map(|&column| largest(map, field, column));
        [name(field.solver, field.scalar)].into_iter().chain(cells).collect::<Vec<_>>()
    });
    let rows: Vec<_> = found.chain(theory).collect();
    page.table(&head, rows);
}

fn name(solver: SolverKind, scalar: ScalarKind) -> String {
    format!("{} {}", solver.name(), scalar.name())
}

fn largest(map: &Map, field: &Field, column: usize) -> String {
    let outcome = |row: usize| field.outcomes[row * map.across.len() + column];
    let represented: Vec<_> = (0..map.up.len()).filter(|&row| outcome(row) != Outcome::NotHeld).collect();
    let holds = |row: &&usize| matches!(outcome(**row), Outcome::Held { strain, .. } if strain < MOST);
    let held: Vec<_> = represented.iter().take_while(holds).collect();
    match held.last() {
        _ if represented.is_empty() => "refused".into(),
        None => "none".into(),
        Some(_) if held.len() == represented.len() => "all".into(),
        Some(&&row) => milliseconds(map.up[row]),
    }
}

fn milliseconds(step: f64) -> String {
    let value = 1e3 * step;
    if value < 0.01 { format!("{value:.0e}") } else { format!("{value:.2}") }
}
