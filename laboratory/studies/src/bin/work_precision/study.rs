//! A scene solved by many configurations: their costs and errors.

use std::collections::BTreeMap;
use std::path::Path;

use indicatif::ProgressBar;
use kerchief::host::Description;
use rayon::prelude::*;
use serde::Serialize;

use crate::cost::{self, PerParticle};
use crate::lean;
use laboratory::configuration::{Choice, Configuration};
use laboratory::measurement::Measurement;
use laboratory::reference::Reference;

/// A configuration and its measurements.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    pub(crate) configuration: Configuration,
    pub(crate) seen: Measurement,
    pub(crate) operations: Option<PerParticle>,
    /// Instructions per particle and frame.
    pub(crate) instructions: Option<f64>,
    /// Computing time divided by that of the study's first point.
    pub(crate) time_ratio: f64,
}

/// A scene, the number of its frames and the tolerance of its reference.
#[derive(Clone, Debug)]
pub(crate) struct Subject {
    pub(crate) text: String,
    pub(crate) scene: Description,
    pub(crate) frames: u32,
    /// Tolerance of the reference, sheet sizes; without it, only strain is measured.
    pub(crate) tolerance: Option<f64>,
}

/// The results of a subject.
#[derive(Clone, Debug)]
pub(crate) struct Study {
    pub(crate) subject: Subject,
    pub(crate) reference: Option<Reference>,
    pub(crate) points: Vec<Point>,
    /// Relative variation of instructions per operation with the number of substeps, the largest one for each solver and number
    /// type; `None` without callgrind.
    pub(crate) spread: Option<BTreeMap<String, f64>>,
}

impl Subject {
    /// Checks the configurations before any of them is run.
    pub(crate) fn check(&self, choice: &Choice, callgrind: bool) -> Result<(), String> {
        let in_scene = |reason: &dyn std::fmt::Display| format!("{}: {reason}", self.scene.name);
        let configurations = choice.configurations();
        if configurations.is_empty() {
            return Err("--work: leaves no configuration".to_string());
        }
        for configuration in configurations {
            lean::moving(&configuration.of(&self.scene), configuration.scalar).map_err(|error| in_scene(&error))?;
        }
        if !callgrind && lean::counted(&self.scene).is_none() {
            let grids = "operations are counted for undamped sheets of 16 × 16 and 32 × 32 only, instructions for all";
            return Err(in_scene(&grids));
        }
        Ok(())
    }

    /// Runs all configurations.
    pub(crate) fn study(
        &self,
        choice: &Choice,
        callgrind: bool,
        cache: &Path,
        bar: &ProgressBar,
    ) -> Result<Study, String> {
        let in_scene = |reason: &dyn std::fmt::Display| format!("{}: {reason}", self.scene.name);
        let configurations = choice.configurations();
        bar.inc_length(configurations.len() as u64 + 1);
        let reference = || {
            let solve = |tolerance| Reference::of(lean::moving, &self.text, &self.scene, self.frames, tolerance, cache);
            let reference = self.tolerance.map(solve).transpose().map_err(|error| in_scene(&error));
            bar.inc(1);
            reference
        };
        let exchanges =
            || callgrind.then(|| cost::exchanges(&self.text, &self.scene, &configurations, bar)).transpose();
        let (reference, exchanges) = rayon::join(reference, exchanges);
        let (reference, exchanges) = (reference?, exchanges?);
        let point = |&configuration: &Configuration| {
            let positions = reference.as_ref().map(|reference| &reference.positions);
            let seen = Measurement::of(lean::moving, &self.scene, configuration, self.frames, positions)
                .map_err(|e| in_scene(&e))?;
            let is_whole = seen.strain.is_finite();
            let operations = is_whole.then(|| cost::operations(&self.scene, configuration, self.frames)).flatten();
            let units = operations.map_or(f64::from(configuration.substeps), PerParticle::total);
            let exchange = exchanges.as_ref().and_then(|exchanges| exchanges.get(&configuration.group()));
            let instructions =
                exchange.filter(|_| is_whole).map(|rate| rate.instructions(configuration.substeps, units));
            bar.inc(1);
            Ok::<_, String>(Point { configuration, seen, operations, instructions, time_ratio: 1.0 })
        };
        let mut points: Vec<Point> = configurations.par_iter().map(point).collect::<Result<_, _>>()?;
        if let Some(first) = points.first().map(|point| point.seen.time.as_secs_f64()) {
            for point in &mut points {
                point.time_ratio = point.seen.time.as_secs_f64() / first;
            }
        }
        let spread = exchanges.map(|exchanges| {
            let mut spread = BTreeMap::new();
            for configuration in &configurations {
                let largest: &mut f64 = spread.entry(configuration.kind()).or_default();
                *largest =
                    exchanges.get(&configuration.group()).map_or(*largest, |exchange| largest.max(exchange.spread()));
            }
            spread
        });
        Ok(Study { subject: self.clone(), reference, points, spread })
    }
}

impl Point {
    /// The cost of a frame per particle: instructions if they were counted, or else operations.
    pub(crate) fn cost(&self) -> f64 {
        self.instructions.or(self.operations.map(PerParticle::total)).unwrap_or(f64::NAN)
    }
}

/// A row of the table of all points.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row<'a> {
    scene: &'a str,
    solver: &'static str,
    scalar: &'static str,
    substeps: u32,
    sweeps: u32,
    tolerance: Option<f64>,
    error: Option<String>,
    strain: String,
    instructions: Option<f64>,
    operations: Option<f64>,
    additions: Option<f64>,
    products: Option<f64>,
    quotients: Option<f64>,
    roots: Option<f64>,
    comparisons: Option<f64>,
    time_ratio: f64,
}

impl Study {
    /// All points as rows of a table.
    pub(crate) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        let number = |value: f64| if value.is_finite() { format!("{value:e}") } else { "diverged".to_string() };
        self.points.iter().map(move |point| {
            let Configuration { solver, scalar, substeps, sweeps, tolerance } = point.configuration;
            let count =
                |of: fn(PerParticle) -> f64| point.operations.map(of).map(|count| (count * 10.0).round() / 10.0);
            Row {
                scene: &self.subject.scene.name,
                solver: solver.name(),
                scalar: scalar.name(),
                substeps,
                sweeps,
                tolerance,
                error: point.seen.error.map(number),
                strain: number(point.seen.strain),
                instructions: point.instructions.map(f64::round),
                operations: count(PerParticle::total),
                additions: count(|of| of.additions),
                products: count(|of| of.products),
                quotients: count(|of| of.quotients),
                roots: count(|of| of.roots),
                comparisons: count(|of| of.comparisons),
                time_ratio: (point.time_ratio * 100.0).round() / 100.0,
            }
        })
    }
}
