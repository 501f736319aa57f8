//! Plots, and a table of the cheapest settings.

use std::path::Path;

use kerchief::host::{ScalarKind, SolverKind};

use crate::NUMBERS;
use crate::board::{BOARDS, Board, Point};
use laboratory::front::cheapest;
use laboratory::page::{Page, scientific};
use laboratory::plot::{Axis, Curve, Plot};

/// Position errors (sheet sizes) for which the table gives the cheapest setting.
const ERRORS: [f64; 3] = [1e-2, 1e-3, 1e-4];

/// Bounds of the plots: costs, and errors.
const COSTS: (f64, f64) = (1e4, 1e10);
const SEEN: (f64, f64) = (1e-6, 1.0);

const WORDS: &str = "The sheet of 16 × 16 particles on two corners from the first section, computed on a Cortex-M0, M3 and M4F in QEMU. *Instructions* are those executed in a \
    frame of 0.1 s for the whole sheet, as the mean over 2 s. *Errors* are measured in the same runs on the host; board and host end with the same digest. `f32` is \
    computed in software on M0 and M3.";

pub(crate) fn report(points: &[Point], page: &mut Page, directory: &Path) -> Result<(), String> {
    page.paragraph("# Error against cost on a board");
    page.paragraph(WORDS);
    for board in BOARDS {
        let own: Vec<&Point> = points.iter().filter(|point| point.board.name() == board.name()).collect();
        let file = format!("board-{}-error.svg", board.short);
        plot(board, &own).write(directory, &file)?;
        page.picture(&format!("{}: position error against instructions", board.name()), &file);
    }
    page.paragraph("Thousands of instructions of a frame for the cheapest setting that reaches an error (in brackets: the setting and its error):");
    let head: Vec<String> = ERRORS.iter().map(|error| format!("≤ {error:e}")).collect();
    let head: Vec<&str> = ["processor", "number"].into_iter().chain(head.iter().map(String::as_str)).collect();
    let rows = BOARDS.iter().flat_map(|board| NUMBERS.map(|number| row(board, number, points)));
    page.table(&head, rows);
    Ok(())
}

fn places(points: &[&Point]) -> Vec<(f64, f64)> {
    points.iter().map(|point| (point.instructions, point.error)).collect()
}

fn row(board: &Board, number: ScalarKind, points: &[Point]) -> Vec<String> {
    let own = |point: &&Point| point.board.name() == board.name() && point.configuration.scalar == number;
    let own: Vec<&Point> = points.iter().filter(own).collect();
    let places = places(&own);
    let choice = |error: f64| {
        cheapest(&places, error).map_or("–".to_string(), |index| {
            let Point { configuration, instructions, error, .. } = own[index];
            let solver = configuration.solver.name();
            let thousands = (instructions / 1e3).round();
            format!("{thousands} ({solver}, {}: {})", configuration.settings(), scientific(*error))
        })
    };
    [board.name().to_string(), number.name().to_string()].into_iter().chain(ERRORS.map(choice)).collect()
}

/// A curve for every solver in every number type, and the Pareto front of all points in grey.
fn plot(board: Board, points: &[&Point]) -> Plot<'static> {
    let places = places(points);
    let mut curves = vec![Curve::front(&places)];
    for (solver, scalar) in SolverKind::ALL.into_iter().flat_map(|solver| NUMBERS.map(|scalar| (solver, scalar))) {
        let is_own = |point: &&&Point| (point.configuration.solver, point.configuration.scalar) == (solver, scalar);
        let own: Vec<&Point> = points.iter().filter(is_own).copied().collect();
        curves.push(Curve::of(solver, scalar, &self::places(&own)));
    }
    curves.retain(|curve| !curve.points.is_empty());
    let axis = |words, bounds| Axis { words, log: true, bounds };
    Plot {
        title: board.name(),
        axes: [axis("instructions of a frame of 0.1 s", COSTS), axis("position error, RMS / sheet size", SEEN)],
        curves,
        notes: vec!["16 × 16 particles on two".to_string(), "corners, 2 s".to_string()],
    }
}
