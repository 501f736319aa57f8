//! The report of a study: plots, tables and the best configurations.

use std::collections::BTreeMap;
use std::path::Path;

use kerchief::host::{ScalarKind, SolverKind};

use crate::study::{Point, Study};
use laboratory::configuration::Configuration;
use laboratory::front::{best_within, cheapest, front};
use laboratory::page::{Page, scientific, thousands};
use laboratory::plot::{Axis, Curve, Plot};

/// Errors, strains and costs for which the best configuration is named.
#[derive(Clone, Debug)]
pub(crate) struct Wishes {
    pub(crate) errors: Vec<f64>,
    pub(crate) strains: Vec<f64>,
    pub(crate) budgets: Vec<f64>,
}

/// The quantity that is plotted against cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Quality {
    Error,
    Strain,
}

/// Bounds of the plots: costs, and errors or strains.
const COSTS: (f64, f64) = (1.0, 1e9);
const QUALITIES: (f64, f64) = (1e-9, 1.0);

/// Relative variations up to this are summarised by their maximum; larger ones are listed.
const STEADY: f64 = 0.05;

impl Quality {
    const fn name(self) -> &'static str {
        match self {
            Self::Error => "error",
            Self::Strain => "strain",
        }
    }

    const fn words(self) -> &'static str {
        match self {
            Self::Error => "position error, RMS / sheet size",
            Self::Strain => "largest stretch strain in motion",
        }
    }

    fn of(self, point: &Point) -> f64 {
        match self {
            Self::Error => point.seen.error.unwrap_or(f64::NAN),
            Self::Strain => point.seen.strain,
        }
    }

    fn points(self, study: &Study) -> Vec<(f64, f64)> {
        study.points.iter().map(|point| (point.cost(), self.of(point))).collect()
    }
}

impl Study {
    fn qualities(&self) -> impl Iterator<Item = (Quality, Vec<(f64, f64)>)> {
        let qualities =
            if self.reference.is_some() { vec![Quality::Error, Quality::Strain] } else { vec![Quality::Strain] };
        qualities.into_iter().map(|quality| (quality, quality.points(self)))
    }

    fn unit(&self) -> &'static str {
        if self.spread.is_some() { "instructions" } else { "operations" }
    }

    /// One line with the best configurations.
    pub(crate) fn advice(&self, wishes: &Wishes) -> String {
        let mut parts = Vec::new();
        for (quality, points) in self.qualities() {
            let chosen = |index: Option<usize>| match index {
                None => "nothing".to_string(),
                Some(index) => {
                    let (cost, reached) = points[index];
                    let configuration = self.points[index].configuration;
                    format!("{configuration} ({} {}, {})", thousands(cost), self.unit(), scientific(reached))
                }
            };
            let levels = if quality == Quality::Error { &wishes.errors } else { &wishes.strains };
            for &level in levels {
                parts.push(format!("{} {level:e}: {}", quality.name(), chosen(cheapest(&points, level))));
            }
            for &budget in &wishes.budgets {
                let within = chosen(best_within(&points, budget));
                parts.push(format!("least {} for {} {}: {within}", quality.name(), thousands(budget), self.unit()));
            }
        }
        format!("{}: {}", self.subject.scene.name, parts.join("; "))
    }

    /// Writes the plots and adds them, the tables and the advice to the page.
    pub(crate) fn report(&self, wishes: &Wishes, page: &mut Page, directory: &Path) -> Result<(), String> {
        let scene = &self.subject.scene;
        page.paragraph(&format!("## {}", scene.name));
        if let Some(words) = self.subject.text.lines().next().and_then(|line| line.strip_prefix("# ")) {
            page.paragraph(words);
        }
        page.paragraph(&self.basis());
        for (quality, points) in self.qualities() {
            let file = format!("{}-{}.svg", scene.name, quality.name());
            self.plot(quality, &points).write(directory, &file)?;
            page.picture(&format!("{}: {} against cost", scene.name, quality.words()), &file);
            let levels = if quality == Quality::Error { &wishes.errors } else { &wishes.strains };
            self.table(quality, &points, levels, page);
        }
        if let Some(diverged) = self.diverged() {
            page.paragraph(&diverged);
        }
        page.paragraph(&format!("*Best configurations.* {}", self.advice(wishes)));
        Ok(())
    }

    /// A paragraph about sheet, reference and counts.
    fn basis(&self) -> String {
        let scene = &self.subject.scene;
        let seconds = f64::from(self.subject.frames) * scene.solver.step;
        let sheet = format!(
            "{} × {} particles, {} frames of {:.3} s ({seconds:.2} s).",
            scene.sheet.columns, scene.sheet.rows, self.subject.frames, scene.solver.step
        );
        let reference = self.reference.as_ref().map_or("Only strain is measured.".to_string(), |reference| {
            let order = reference.order.map_or(String::new(), |order| format!(" (observed order: {order:.2})"));
            format!(
                "The reference is leapfrog in f64 with {} substeps, extrapolated. Its distance from the extrapolation from half as many substeps is {} \
                 of the sheet's size{order}.",
                reference.substeps,
                scientific(reference.difference)
            )
        });
        let spread = self.spread.as_ref().map_or(String::new(), |spread| {
            let (steady, others): (Vec<_>, Vec<_>) = spread.iter().partition(|(_, spread)| **spread <= STEADY);
            let most = steady.iter().map(|(_, spread)| **spread).fold(0.0, f64::max);
            let words = |(kind, spread): &(&String, &f64)| format!("{kind} by {:.0} %", 100.0 * **spread);
            let others: Vec<_> = others.iter().map(words).collect();
            let but = if others.is_empty() { String::new() } else { format!("; exceptions: {}", others.join(", ")) };
            format!(
                " Instructions per operation vary by at most {:.1} % with the number of substeps{but}.",
                100.0 * most
            )
        });
        format!("{sheet} {reference}{spread}")
    }

    /// The cheapest configuration of each solver and number type at each level.
    fn table(&self, quality: Quality, points: &[(f64, f64)], levels: &[f64], page: &mut Page) {
        let heads: Vec<_> = levels.iter().map(|level| format!("{} ≤ {level:e}", quality.name())).collect();
        let mut head = vec!["solver, number type"];
        head.extend(heads.iter().map(String::as_str));
        head.push("best reached");
        let mut rows = Vec::new();
        for (solver, scalar) in self.kinds() {
            let own = self.own(points, solver, scalar);
            let cell = |found: Option<usize>| {
                let words = |index: usize| {
                    format!("{} ({})", thousands(points[index].0), self.points[index].configuration.settings())
                };
                found.map_or("–".to_string(), words)
            };
            let mut row = vec![format!("{} {}", solver.name(), scalar.name())];
            row.extend(levels.iter().map(|&level| cell(cheapest(&own, level))));
            let best = front(&own).pop();
            row.push(best.map_or("–".to_string(), |index| format!("{} at {}", scientific(own[index].1), cell(best))));
            rows.push(row);
        }
        page.paragraph(&format!(
            "Thousands of {} per particle and frame (substeps × sweeps; *within* the strain above which the line solver sweeps again):",
            self.unit()
        ));
        page.table(&head, rows);
    }

    fn kinds(&self) -> Vec<(SolverKind, ScalarKind)> {
        let mut kinds = Vec::new();
        for Point { configuration: Configuration { solver, scalar, .. }, .. } in &self.points {
            if !kinds.contains(&(*solver, *scalar)) {
                kinds.push((*solver, *scalar));
            }
        }
        kinds
    }

    /// The points of one kind. All others are replaced by undefined points, so that indices stay valid.
    fn own(&self, points: &[(f64, f64)], solver: SolverKind, scalar: ScalarKind) -> Vec<(f64, f64)> {
        let is_own = |point: &Point| point.configuration.solver == solver && point.configuration.scalar == scalar;
        let place = |(point, &place): (&Point, &(f64, f64))| if is_own(point) { place } else { (f64::NAN, f64::NAN) };
        self.points.iter().zip(points).map(place).collect()
    }

    /// The configurations that blew up.
    fn diverged(&self) -> Option<String> {
        let mut groups: BTreeMap<String, Vec<(u32, bool)>> = BTreeMap::new();
        for point in &self.points {
            let Configuration { substeps, .. } = point.configuration;
            let group = groups.entry(point.configuration.group()).or_default();
            group.push((substeps, point.seen.strain.is_infinite()));
        }
        let lost = groups.iter().filter(|(_, runs)| runs.iter().any(|(_, lost)| *lost));
        let all: Vec<_> = lost.map(|(group, runs)| format!("{group} at {}", stretches(runs))).collect();
        (!all.is_empty()).then(|| format!("Diverged (with the numbers of substeps): {}.", all.join("; ")))
    }

    fn plot(&self, quality: Quality, points: &[(f64, f64)]) -> Plot<'_> {
        let kinds = self.kinds().into_iter();
        let own = kinds.map(|(solver, scalar)| Curve::of(solver, scalar, &self.own(points, solver, scalar)));
        let mut curves: Vec<_> = std::iter::once(Curve::front(points)).chain(own).collect();
        curves.retain(|curve| !curve.points.is_empty());
        let lost = self.points.iter().filter(|point| point.seen.strain.is_infinite()).count();
        let mut notes = vec![
            "Each curve: the front of".to_string(),
            "one solver over its".to_string(),
            "substeps and sweeps.".to_string(),
        ];
        if lost > 0 {
            notes.push(format!("{lost} of {} diverged.", self.points.len()));
        }
        let unit = if self.spread.is_some() {
            "instructions per particle and frame (x86-64)"
        } else {
            "operations per particle and frame"
        };
        Plot {
            title: &self.subject.scene.name,
            axes: [
                Axis { words: unit, log: true, bounds: COSTS },
                Axis { words: quality.words(), log: true, bounds: QUALITIES },
            ],
            curves,
            notes,
        }
    }
}

/// The marked numbers of an ascending list in words: `1 to 8, 32`.
fn stretches(numbers: &[(u32, bool)]) -> String {
    let runs = numbers.chunk_by(|a, b| a.1 == b.1).filter(|run| run[0].1);
    let words = |run: &[(u32, bool)]| match *run {
        [(only, _)] => only.to_string(),
        [(first, _), .., (last, _)] => format!("{first} to {last}"),
        [] => String::new(),
    };
    runs.map(words).collect::<Vec<_>>().join(", ")
}
