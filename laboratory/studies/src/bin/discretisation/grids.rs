//! The awning on finer and finer grids.

use std::path::Path;

use indicatif::ProgressBar;
use rayon::prelude::*;
use serde::Serialize;

use crate::awning::{Awning, Outcome, cropped};
use console::studio::Studio;
use laboratory::page::{Page, scientific, write_csv, write_png};
use laboratory::plot::{Axis, COLOURS, Curve, Marker, Plot};
use laboratory::strip::strip;

/// The side of a picture, pixels.
const SIDE: u32 = 400;
/// Pictures side by side.
const PICTURES: usize = 4;

/// The results of one awning on several grids, the finest last.
#[derive(Clone, Debug)]
pub(crate) struct Grids {
    awning: Awning,
    outcomes: Vec<Outcome>,
}

/// A row of the table.
#[derive(Clone, Debug, Serialize)]
struct Row {
    side: usize,
    cell: f64,
    sag: f64,
    strain: f64,
    distance_at_rest: Option<f64>,
    distance_in_motion: Option<f64>,
}

impl Grids {
    /// Runs the sheet on all grids.
    pub(crate) fn of(awning: Awning, sides: &[usize], bar: &ProgressBar) -> Result<Self, String> {
        bar.inc_length(sides.len() as u64);
        let awning = awning.exactly(sides.iter().copied().max().unwrap_or(2));
        let run = |&side: &usize| {
            let outcome = awning.outcome(side);
            bar.inc(1);
            outcome
        };
        Ok(Self { awning, outcomes: sides.par_iter().map(run).collect::<Result<_, _>>()? })
    }

    fn rows(&self) -> Vec<Row> {
        let (finest, coarser) = self.outcomes.split_last().expect("at least two grids");
        let row = |outcome: &Outcome, distances: Option<[f64; 2]>| Row {
            side: outcome.side,
            cell: outcome.cell(),
            sag: outcome.sag,
            strain: outcome.strain,
            distance_at_rest: distances.map(|[rest, _]| rest),
            distance_in_motion: distances.map(|[_, motion]| motion),
        };
        let rows = coarser.iter().map(|outcome| row(outcome, Some(outcome.distances(finest))));
        rows.chain([row(finest, None)]).collect()
    }

    /// Writes plot, pictures and table, and adds them to the page.
    pub(crate) fn report(&self, page: &mut Page, directory: &Path) -> Result<(), String> {
        let rows = self.rows();
        let finest = self.outcomes.last().map_or(0, |outcome| outcome.side);
        page.paragraph("## The grid");
        Self::plot(&rows).write(directory, "grids.svg")?;
        page.picture("distance to the finest grid against the side of a cell", "grids.svg");
        self.pictures(directory)?;
        page.picture("the sheet at rest on four grids", "grids.png");
        let order = |index: usize, of: fn(&Row) -> Option<f64>| {
            let (before, row) = (rows.get(index.checked_sub(1)?)?, rows.get(index)?);
            // The distance from the finest grid is not the distance from the limit: the order accounts for the finest cell.
            let limit = rows.last()?.cell;
            order(before.cell, of(before)?, row.cell, of(row)?, limit)
        };
        page.paragraph(&format!(
            "{} Distances are from the grid of {finest} × {finest}; orders account for the error of that grid.",
            self.awning.method()
        ));
        page.table(
            &[
                "particles a side",
                "cell, mm",
                "sag, mm",
                "largest strain, %",
                "distance at rest",
                "order",
                "distance in motion",
                "order",
            ],
            rows.iter().enumerate().map(|(index, row)| {
                let distance = |distance: Option<f64>| distance.map_or("–".to_string(), scientific);
                let number = |order: Option<f64>| order.map_or("–".to_string(), |order| format!("{order:.1}"));
                vec![
                    row.side.to_string(),
                    format!("{:.1}", 1e3 * row.cell),
                    format!("{:.3}", 1e3 * row.sag),
                    format!("{:.3}", 100.0 * row.strain),
                    distance(row.distance_at_rest),
                    number(order(index, |row| row.distance_at_rest)),
                    distance(row.distance_in_motion),
                    number(order(index, |row| row.distance_in_motion)),
                ]
            }),
        );
        write_csv(directory, "grids.csv", &rows)
    }

    fn plot(rows: &[Row]) -> Plot<'static> {
        let curve = |name: &str, colour, of: fn(&Row) -> Option<f64>| Curve {
            name: name.to_string(),
            colour,
            marker: Marker::Disc,
            width: 2,
            points: rows.iter().filter_map(|row| Some((1e3 * row.cell, of(row)?))).collect(),
        };
        let steepness = |power: i32| Curve {
            name: String::new(),
            colour: plotters::style::RGBColor(190, 190, 190),
            marker: Marker::None,
            width: 3,
            points: match rows.first().and_then(|row| Some((row, row.distance_at_rest?))) {
                Some((first, height)) => {
                    let before_last = rows.len().saturating_sub(1);
                    let place = |row: &Row| (1e3 * row.cell, 1.5 * height * (row.cell / first.cell).powi(power));
                    rows[..before_last].iter().map(place).collect()
                }
                None => Vec::new(),
            },
        };
        Plot {
            title: "distance to the finest grid",
            axes: [
                Axis { words: "side of a cell, mm", log: true, bounds: (1e-3, 1e6) },
                Axis { words: "RMS distance / sheet size", log: true, bounds: (1e-12, 1.0) },
            ],
            curves: vec![
                steepness(1),
                steepness(2),
                curve("at rest", COLOURS[0], |row| row.distance_at_rest),
                curve("in motion", COLOURS[1], |row| row.distance_in_motion),
            ],
            notes: vec!["Grey lines fall with".to_string(), "orders 1 and 2.".to_string()],
        }
    }

    fn pictures(&self, directory: &Path) -> Result<(), String> {
        let count = self.outcomes.len();
        let shown =
            (0..PICTURES.min(count)).map(|k| &self.outcomes[k * (count - 1) / (PICTURES.min(count) - 1).max(1)]);
        let mut panels = Vec::new();
        for outcome in shown {
            let scene = self.awning.scene(outcome.side)?;
            let studio = Studio::new(&scene, [&outcome.still], SIDE)?;
            let picture = cropped(&studio.picture(&outcome.still));
            panels.push((picture, format!("{0} x {0}", outcome.side)));
        }
        write_png(directory, "grids.png", &strip(&panels))
    }
}

/// The order p of the error in the side of a cell a, from the distances of two grids from a third one with cells of `limit`. Distances are
/// c·(aᵖ − limitᵖ).
fn order(coarse: f64, far: f64, fine: f64, near: f64, limit: f64) -> Option<f64> {
    let ratio = |p: f64| (coarse.powf(p) - limit.powf(p)) / (fine.powf(p) - limit.powf(p));
    let (mut low, mut high) = (0.05, 8.0);
    let seen = far / near;
    // The ratio grows with the order.
    if !(seen > ratio(low) && seen < ratio(high)) {
        return None;
    }
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if ratio(middle) < seen { low = middle } else { high = middle }
    }
    Some(low)
}
