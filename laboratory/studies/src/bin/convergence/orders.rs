//! The order of every solver in time.

use std::path::Path;

use indicatif::ProgressBar;
use instances::simulation;
use kerchief::host::{Description, ScalarKind};
use plotters::style::RGBColor;
use rayon::prelude::*;
use serde::Serialize;

use crate::usual::{USUAL, colour_of, name, usual};
use laboratory::configuration::Configuration;
use laboratory::measurement::Measurement;
use laboratory::page::{Page, scientific};
use laboratory::plot::{Axis, Curve, Marker, Plot};
use laboratory::reference::Reference;

/// Tolerance of the reference, sheet sizes.
const TOLERANCE: f64 = 1e-9;
/// An order is computed from errors that are larger than the reference's by this factor.
const CLEAR: f64 = 30.0;

/// Errors of all solvers in `f64`.
#[derive(Clone, Debug)]
pub(crate) struct Orders {
    pub(crate) name: String,
    pub(crate) frames: u32,
    pub(crate) substeps: Vec<u32>,
    pub(crate) reference: Reference,
    step: f64,
    points: Vec<(Configuration, f64)>,
}

/// A row of the table of all points.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row<'a> {
    scene: &'a str,
    solver: &'static str,
    sweeps: u32,
    substeps: u32,
    error: Option<f64>,
}

impl Orders {
    /// Runs all solvers.
    pub(crate) fn of(
        text: &str,
        scene: &Description,
        frames: u32,
        substeps: &[u32],
        cache: &Path,
        bar: &ProgressBar,
    ) -> Result<Self, String> {
        let in_scene = |reason: &dyn std::fmt::Display| format!("{}: {reason}", scene.name);
        let configurations: Vec<_> = substeps.iter().flat_map(|&substeps| usual(ScalarKind::F64, substeps)).collect();
        bar.inc_length(configurations.len() as u64 + 1);
        let reference =
            Reference::of(simulation, text, scene, frames, TOLERANCE, cache).map_err(|error| in_scene(&error))?;
        bar.inc(1);
        let run = |&configuration: &Configuration| {
            let seen = Measurement::of(simulation, scene, configuration, frames, Some(&reference.positions))
                .map_err(|e| in_scene(&e))?;
            bar.inc(1);
            Ok::<_, String>((configuration, seen.error.unwrap_or(f64::NAN)))
        };
        let points = configurations.par_iter().map(run).collect::<Result<_, _>>()?;
        let (name, step, substeps) = (scene.name.clone(), scene.solver.step, substeps.to_vec());
        Ok(Self { name, frames, substeps, reference, step, points })
    }

    /// All points as rows of a table.
    pub(crate) fn rows(&self) -> impl Iterator<Item = Row<'_>> {
        self.points.iter().map(|(Configuration { solver, substeps, sweeps, .. }, error)| Row {
            scene: &self.name,
            solver: solver.name(),
            sweeps: *sweeps,
            substeps: *substeps,
            error: Some(*error).filter(|error| error.is_finite()),
        })
    }

    /// Substeps and errors of one solver.
    fn own(&self, index: usize) -> Vec<(u32, f64)> {
        let (solver, sweeps) = USUAL[index];
        let own = self.points.iter().filter(|(of, _)| (of.solver, of.sweeps) == (solver, sweeps));
        own.map(|(of, error)| (of.substeps, *error)).collect()
    }

    /// The order between the two finest runs whose errors are clearly larger than the reference's.
    fn order(&self, index: usize) -> Option<f64> {
        let clear = |(_, error): &(u32, f64)| error.is_finite() && *error > CLEAR * self.reference.difference;
        let own: Vec<_> = self.own(index).into_iter().filter(clear).collect();
        let [.., (coarse, larger), (fine, smaller)] = own[..] else { return None };
        Some((larger / smaller).ln() / (f64::from(fine) / f64::from(coarse)).ln())
    }

    /// Writes the plot and adds it and the table to the page.
    pub(crate) fn report(&self, page: &mut Page, directory: &Path) -> Result<(), String> {
        page.paragraph(&format!("## Order in time: {}", self.name));
        page.paragraph(&format!(
            "Position error in f64 over {} frames of {:.3} s, RMS over all particles and frames / sheet size. The reference is leapfrog with {} \
             substeps, extrapolated. Its distance from the extrapolation from half as many substeps is {}.",
            self.frames,
            self.step,
            self.reference.substeps,
            scientific(self.reference.difference)
        ));
        let file = format!("order-{}.svg", self.name);
        self.plot().write(directory, &file)?;
        page.picture(&format!("{}: error of all solvers against their step", self.name), &file);
        let heads: Vec<_> = self.substeps.iter().map(u32::to_string).collect();
        let mut head = vec!["solver; substeps per frame:"];
        head.extend(heads.iter().map(String::as_str));
        head.push("order");
        let row = |(index, &(solver, sweeps)): (usize, &(_, u32))| {
            let mut row = vec![name(solver, sweeps)];
            row.extend(self.own(index).iter().map(|(_, error)| scientific(*error)));
            row.push(self.order(index).map_or("–".to_string(), |order| format!("{order:.2}")));
            row
        };
        page.table(&head, USUAL.iter().enumerate().map(row));
        Ok(())
    }

    fn plot(&self) -> Plot<'_> {
        let curve = |(index, &(solver, sweeps)): (usize, &(_, u32))| {
            let step = |(substeps, error): &(u32, f64)| (self.step / f64::from(*substeps), *error);
            Curve {
                name: name(solver, sweeps),
                colour: colour_of((solver, sweeps)),
                marker: Marker::Disc,
                width: 2,
                points: self.own(index).iter().map(step).collect(),
            }
        };
        let mut curves: Vec<_> = [1, 2].map(|order| self.slope(order)).into();
        curves.extend(USUAL.iter().enumerate().map(curve));
        Plot {
            title: &self.name,
            axes: [
                Axis { words: "substep, s", log: true, bounds: (1e-9, 1e3) },
                Axis { words: "position error, RMS / sheet size", log: true, bounds: (1e-12, 1.0) },
            ],
            curves,
            notes: vec!["Grey lines fall with".to_string(), "orders 1 and 2.".to_string()],
        }
    }

    /// A line with the slope of an order, above all curves of that order.
    fn slope(&self, order: i32) -> Curve {
        let own = |index: usize| self.own(index).into_iter().rfind(|(_, error)| error.is_finite());
        let near = |index: &usize| self.order(*index).is_some_and(|found| (found - f64::from(order)).abs() < 0.5);
        let highest = (0..USUAL.len()).filter(near).filter_map(own).map(|(n, error)| error * f64::from(n).powi(order));
        let height = 2.0 * highest.fold(0.0, f64::max);
        let place = |&n: &u32| (self.step / f64::from(n), height / f64::from(n).powi(order));
        Curve {
            name: String::new(),
            colour: RGBColor(190, 190, 190),
            marker: Marker::None,
            width: 3,
            points: self.substeps.iter().map(place).collect(),
        }
    }
}
