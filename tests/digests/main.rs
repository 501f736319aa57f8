//! Equal numbers everywhere: one digest for each small scene, solver and number type, the same in debug and release builds and on every
//! target. Only `+ − × ÷` and the correctly rounded root are used, in one order, so this holds for floats too.
//!
//! After a change that means to move sheets otherwise, `UPDATE_DIGESTS=1 cargo test --test digests -- --nocapture` prints the new table for
//! `tests/digests/table.rs`, and still fails.

mod scenes;
mod table;

use kerchief::{Q24, Scalar};
use scenes::{CASES, Case, METHODS, Method, Outcome, play};
use table::TABLE;

const TYPES: [&str; 3] = [f32::NAME, f64::NAME, Q24::NAME];

fn outcomes(case: Case, method: Method) -> [Outcome; 3] {
    [play::<f32>(case, method), play::<f64>(case, method), play::<Q24>(case, method)]
}

fn pairs() -> impl Iterator<Item = (Case, Method)> {
    CASES.into_iter().flat_map(|case| METHODS.into_iter().map(move |method| (case, method)))
}

#[test]
fn digests_are_those_of_the_table() {
    let update = std::env::var_os("UPDATE_DIGESTS").is_some();
    let mut differences = Vec::new();
    for (case, method) in pairs() {
        let names = (format!("{case:?}"), format!("{method:?}"));
        let found = outcomes(case, method).map(|outcome| outcome.digest);
        if update {
            let [f32, f64, q24] = found;
            println!("    ({:?}, {:?}, [{f32:#010x}, {f64:#010x}, {q24:#010x}]),", names.0, names.1);
        }
        let Some((_, _, expected)) = TABLE.iter().find(|row| (row.0, row.1) == (names.0.as_str(), names.1.as_str()))
        else {
            differences.push(format!("{case:?} by {method:?}: not in the table"));
            continue;
        };
        for ((name, expected), found) in TYPES.iter().zip(expected).zip(found) {
            if *expected != found {
                differences
                    .push(format!("{case:?} by {method:?} in {name}: {found:#010x} instead of {expected:#010x}"));
            }
        }
    }
    assert!(differences.is_empty(), "sheets moved otherwise:\n{}", differences.join("\n"));
    assert_eq!(TABLE.len(), pairs().count(), "the table has a row for each scene and solver, and no other");
}

/// What the table keeps is worth keeping: all number types tell the same story.
#[test]
fn number_types_agree() {
    for (case, method) in pairs() {
        let outcomes = outcomes(case, method);
        // in cells; forward Euler amplifies every rounding
        let bound = if method == Method::ForwardEuler { 0.1 } else { 1e-3 };
        for (outcome, name) in outcomes.into_iter().zip(TYPES) {
            let apart = farthest(outcome.bounds, outcomes[1].bounds);
            assert!(outcome.finite && apart < bound, "{case:?} by {method:?} in {name}: {apart} cells from f64");
        }
    }
}

/// The largest difference of two boxes, cells.
fn farthest(a: [[f64; 3]; 2], b: [[f64; 3]; 2]) -> f64 {
    a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}
