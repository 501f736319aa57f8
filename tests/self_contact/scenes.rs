//! No edge of a sheet passes through a triangle of it, counted by a test that knows nothing of contacts.

use std::fmt::Write;

use kerchief::{Lines, Q13, Q24, Scalar, Solver, Verlet, Xpbd, measure};

use crate::stage::{Case, Stage, layered};

/// What a run came to.
#[derive(Clone, Copy, Debug, Default)]
struct Outcome {
    /// Pairs of an edge and a triangle, of all frames that were looked at.
    intersections: u64,
    /// The largest of a stretch link in motion, and in the last second.
    strain: [f64; 2],
    /// The least distance of particles that are no neighbours in the last frame, cells.
    closest: f64,
}

fn play<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(mut stage: Stage<S, V, W, H>, frames: u32) -> Outcome {
    let mut outcome = Outcome::default();
    for frame in 1..=frames {
        stage.step();
        if frame % 5 == 0 {
            outcome.intersections += u64::from(measure::intersections(&stage.cloth));
        }
        let when = usize::from(frame + 60 > frames);
        outcome.strain[when] = outcome.strain[when].max(stage.strain());
    }
    outcome.closest = measure::closest(&stage.cloth, &stage.sheet.units) / stage.cell();
    outcome
}

/// All cases by a solver, on a grid: what went wrong.
fn all<S: Scalar, V: Solver<S> + Copy, const W: usize, const H: usize>(
    name: &str,
    substeps: u32,
    solver: V,
    frames: u32,
) -> String {
    let mut wrong = String::new();
    for case in Case::ALL {
        let outcome = play(Stage::<S, _, W, H>::new(case, substeps, layered(solver)), frames);
        println!("{case:?} {W} x {H} {name} {substeps} {}: {outcome:?}", S::NAME);
        if outcome.intersections > 0 {
            let _ = writeln!(wrong, "{case:?}, {W} x {H}, {name} {substeps} in {}: {outcome:?}", S::NAME);
        }
    }
    wrong
}

#[test]
fn small_sheets_never_pass_through_themselves() {
    let wrong = [
        all::<f32, _, 16, 16>("lines", 8, Lines::new(), 250),
        all::<Q13, _, 16, 16>("lines", 8, Lines::new(), 250),
        all::<Q24, _, 16, 16>("lines", 4, Lines::new(), 250),
        all::<f32, _, 16, 16>("xpbd", 8, Xpbd, 250),
        all::<Q13, _, 16, 16>("xpbd", 16, Xpbd, 250),
        // odd sides, of which one is no multiple of a tile
        all::<f32, _, 13, 21>("lines", 8, Lines::new(), 250),
        all::<f32, _, 16, 16>("verlet", 16, Verlet { sweeps: 2 }, 250),
    ];
    assert_eq!(wrong.concat(), "");
}

#[test]
#[ignore = "minutes"]
fn larger_sheets_never_pass_through_themselves() {
    let wrong = [
        all::<f32, _, 32, 32>("lines", 8, Lines::new(), 600),
        all::<f64, _, 32, 32>("lines", 4, Lines::new(), 600),
        all::<Q24, _, 32, 32>("lines", 8, Lines::new(), 600),
        all::<Q13, _, 32, 32>("lines", 8, Lines::new(), 600),
        all::<f32, _, 32, 32>("xpbd", 16, Xpbd, 600),
        all::<Q13, _, 32, 32>("xpbd", 16, Xpbd, 600),
    ];
    assert_eq!(wrong.concat(), "");
}

/// Without contacts they do: the counter counts.
#[test]
fn without_contacts_they_do() {
    for case in [Case::Heap, Case::Twist] {
        let outcome = play(Stage::<f32, _, 16, 16>::new(case, 8, |_| Lines::new()), 250);
        assert!(outcome.intersections > 1000, "{case:?}: {outcome:?}");
    }
}
