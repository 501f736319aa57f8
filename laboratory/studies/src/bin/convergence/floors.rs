//! Rounding errors of the number types.

use std::path::Path;

use indicatif::ProgressBar;
use instances::simulation;
use kerchief::host::{Description, ScalarKind};
use rayon::prelude::*;

use crate::orders::Orders;
use crate::usual::{USUAL, colour_of, name};
use laboratory::configuration::Configuration;
use laboratory::page::{Page, scientific};
use laboratory::plot::{Axis, Curve, Plot, marker};
use laboratory::reference::{record, rms, size};

/// Number types that are compared with `f64`.
const TYPES: [ScalarKind; 3] = [ScalarKind::F32, ScalarKind::Q24, ScalarKind::Q13];

/// Distances from the same solver in `f64`, and from the reference.
#[derive(Clone, Debug)]
pub(crate) struct Floors {
    name: String,
    substeps: Vec<u32>,
    points: Vec<Point>,
}

#[derive(Clone, Copy, Debug)]
struct Point {
    configuration: Configuration,
    /// RMS distance from the same configuration in `f64`, divided by the sheet's size. It is infinite if one of them blew up, and undefined if the number type refuses a
    /// step this short.
    rounding: f64,
    /// RMS distance from the reference, divided by the sheet's size.
    error: f64,
}

impl Floors {
    /// Runs all solvers in all number types.
    pub(crate) fn of(scene: &Description, orders: &Orders, bar: &ProgressBar) -> Result<Self, String> {
        let configurations: Vec<_> = USUAL
            .iter()
            .flat_map(|&(solver, sweeps)| {
                let configuration = move |substeps| Configuration {
                    solver,
                    scalar: ScalarKind::F64,
                    substeps,
                    sweeps,
                    tolerance: None,
                };
                orders.substeps.iter().map(move |&substeps| configuration(substeps))
            })
            .collect();
        bar.inc_length(configurations.len() as u64);
        let run = |&exact: &Configuration| {
            let frames =
                |of| record(simulation, scene, of, orders.frames).map_err(|error| format!("{}: {error}", scene.name));
            let precise = frames(exact)?;
            let point = |scalar| {
                let configuration = Configuration { scalar, ..exact };
                let Ok(found) = frames(configuration) else {
                    return Point { configuration, rounding: f64::NAN, error: f64::NAN };
                };
                let to = |other| found.as_ref().map_or(f64::INFINITY, |found| rms(found, other) / size(scene));
                let rounding = precise.as_ref().map_or(f64::INFINITY, to);
                Point { configuration, rounding, error: to(&orders.reference.positions) }
            };
            let points = TYPES.map(point);
            bar.inc(1);
            Ok::<_, String>(points)
        };
        let points: Vec<[Point; 3]> = configurations.par_iter().map(run).collect::<Result<_, _>>()?;
        Ok(Self {
            name: scene.name.clone(),
            substeps: orders.substeps.clone(),
            points: points.into_iter().flatten().collect(),
        })
    }

    fn own(&self, index: usize, scalar: ScalarKind) -> impl Iterator<Item = &Point> {
        let (solver, sweeps) = USUAL[index];
        self.points.iter().filter(move |point| {
            let of = point.configuration;
            (of.solver, of.sweeps, of.scalar) == (solver, sweeps, scalar)
        })
    }

    /// Writes the plot and adds it and the table to the page.
    pub(crate) fn report(&self, page: &mut Page, directory: &Path) -> Result<(), String> {
        page.paragraph(&format!("## Round-off: {}", self.name));
        page.paragraph(
            "RMS distance, over all particles and frames, from the same solver with the same substeps in f64, / sheet size. The *floor* is the smallest \
             error against the reference at any of these numbers of substeps.",
        );
        let file = format!("rounding-{}.svg", self.name);
        self.plot().write(directory, &file)?;
        page.picture(&format!("{}: round-off of all solvers and number types", self.name), &file);
        let heads: Vec<_> = self.substeps.iter().map(u32::to_string).collect();
        let mut head = vec!["solver, number type; substeps per frame:"];
        head.extend(heads.iter().map(String::as_str));
        head.push("floor");
        let kinds = (0..USUAL.len()).flat_map(|index| TYPES.map(|scalar| (index, scalar)));
        page.table(
            &head,
            kinds.map(|(index, scalar)| {
                let (solver, sweeps) = USUAL[index];
                let mut row = vec![format!("{} {}", name(solver, sweeps), scalar.name())];
                row.extend(
                    self.own(index, scalar).map(|point| {
                        if point.rounding.is_nan() { "–".to_string() } else { scientific(point.rounding) }
                    }),
                );
                let floor = self.own(index, scalar).min_by(|a, b| a.error.total_cmp(&b.error));
                let floor = floor.filter(|point| point.error.is_finite());
                row.push(floor.map_or("–".to_string(), |point| {
                    format!("{} at {}", scientific(point.error), point.configuration.substeps)
                }));
                row
            }),
        );
        Ok(())
    }

    fn plot(&self) -> Plot<'_> {
        let kinds = (0..USUAL.len()).flat_map(|index| TYPES.map(|scalar| (index, scalar)));
        let curve = |(index, scalar): (usize, ScalarKind)| {
            let (solver, sweeps) = USUAL[index];
            let place = |point: &Point| (f64::from(point.configuration.substeps), point.rounding);
            Curve {
                name: format!("{} {}", name(solver, sweeps), scalar.name()),
                colour: colour_of((solver, sweeps)),
                marker: marker(scalar),
                width: 1,
                points: self.own(index, scalar).map(place).collect(),
            }
        };
        Plot {
            title: &self.name,
            axes: [
                Axis { words: "substeps per frame", log: true, bounds: (1.0, 1e6) },
                Axis { words: "distance to f64, RMS / sheet size", log: true, bounds: (1e-12, 1.0) },
            ],
            curves: kinds.map(curve).collect(),
            notes: Vec::new(),
        }
    }
}
