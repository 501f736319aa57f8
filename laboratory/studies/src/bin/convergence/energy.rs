//! Changes of the energy of an undamped sheet by the solvers.

use std::path::Path;

use indicatif::ProgressBar;
use instances::simulation;
use kerchief::host::{Description, ScalarKind, SolverKind};
use rayon::prelude::*;
use serde::Serialize;

use crate::usual::{USUAL, colour_of, name, usual};
use laboratory::configuration::Configuration;
use laboratory::page::{Page, write_csv};
use laboratory::plot::{Axis, Curve, Marker, Plot};
use laboratory::reference::size;

/// Factor on the substeps of leapfrog.
const LEAPFROG: u32 = 16;
/// Changes beyond these are not drawn, percent.
const DRAWN: (f64, f64) = (-20.0, 20.0);
/// A sheet has blown up if its energy has changed by this or more, percent.
const LOST: f64 = 1000.0;

/// Changes of the total energy, percent of mass × gravity × size, at the end of each frame.
#[derive(Clone, Debug)]
pub(crate) struct Energies {
    name: String,
    step: f64,
    frames: u32,
    courses: Vec<(Configuration, Vec<f64>)>,
}

/// The scene without drag and wind. Fails if it has no gravity.
pub(crate) fn undamped(scene: &Description) -> Result<Description, String> {
    if scene.gravity == [0.0; 3] {
        return Err(format!("{}: environment.gravity: without it there is no unit of energy", scene.name));
    }
    Ok(Description { drag: None, wind: None, ..scene.clone() })
}

/// A row of the table of all courses.
#[derive(Clone, Debug, Serialize)]
struct Row<'a> {
    scene: &'a str,
    solver: &'static str,
    sweeps: u32,
    substeps: u32,
    time: f64,
    change_percent: f64,
}

impl Energies {
    /// Runs all solvers in `f64` on an [`undamped`] scene.
    pub(crate) fn of(scene: &Description, frames: u32, substeps: u32, bar: &ProgressBar) -> Result<Self, String> {
        let sheet = &scene.sheet;
        let mass: f64 =
            (0..sheet.rows).flat_map(|row| (0..sheet.columns).map(move |column| sheet.mass_at(column, row))).sum();
        let gravity = scene.gravity.iter().map(|g| g * g).sum::<f64>().sqrt();
        let unit = 0.01 * mass * gravity * size(scene);
        let configurations: Vec<_> = usual(ScalarKind::F64, substeps)
            .map(|configuration| match configuration.solver {
                SolverKind::Leapfrog => Configuration { substeps: LEAPFROG * substeps, ..configuration },
                _ => configuration,
            })
            .collect();
        bar.inc_length(configurations.len() as u64);
        let course = |&configuration: &Configuration| {
            let mut moving = simulation(&configuration.of(scene), configuration.scalar)
                .map_err(|error| format!("{}: {error}", scene.name))?;
            let start = moving.energy();
            let mut changes = Vec::new();
            for _ in 0..frames {
                moving.frame();
                let change = (moving.energy() - start) / unit;
                let is_whole = change.abs() < LOST;
                if !is_whole {
                    break;
                }
                changes.push(change);
            }
            bar.inc(1);
            Ok::<_, String>((configuration, changes))
        };
        let courses = configurations.par_iter().map(course).collect::<Result<_, _>>()?;
        Ok(Self { name: scene.name.clone(), step: scene.solver.step, frames, courses })
    }

    /// Writes the plot and adds it and the table to the page.
    pub(crate) fn report(&self, page: &mut Page, directory: &Path) -> Result<(), String> {
        page.paragraph(&format!("## Energy: {} without drag", self.name));
        page.paragraph(&format!(
            "Change of the total energy in f64 over {:.2} s, in percent of mass × gravity × size. A loss of energy is the solver's own damping.",
            f64::from(self.frames) * self.step
        ));
        let file = format!("energy-{}.svg", self.name);
        self.plot().write(directory, &file)?;
        page.picture(&format!("{}: energy of all solvers over time", self.name), &file);
        page.table(
            &["solver", "substeps", "at the end, %", "lowest, %", "highest, %"],
            self.courses.iter().map(|(configuration, changes)| {
                let low = changes.iter().copied().fold(0.0, f64::min);
                let high = changes.iter().copied().fold(0.0, f64::max);
                let whole = changes.len() == self.frames as usize;
                let end =
                    changes.last().filter(|_| whole).map_or("diverged".to_string(), |change| format!("{change:.2}"));
                let substeps = configuration.substeps.to_string();
                vec![words(*configuration), substeps, end, format!("{low:.2}"), format!("{high:.2}")]
            }),
        );
        let rows: Vec<_> = self.courses.iter().flat_map(|course| self.rows(course)).collect();
        write_csv(directory, "energy.csv", &rows)
    }

    fn rows<'a>(&'a self, (configuration, changes): &'a (Configuration, Vec<f64>)) -> impl Iterator<Item = Row<'a>> {
        let Configuration { solver, substeps, sweeps, .. } = *configuration;
        changes.iter().enumerate().map(move |(frame, change)| Row {
            scene: &self.name,
            solver: solver.name(),
            sweeps,
            substeps,
            time: (frame + 1) as f64 * self.step,
            change_percent: *change,
        })
    }

    fn plot(&self) -> Plot<'_> {
        let curve = |(configuration, changes): &(Configuration, Vec<f64>)| {
            let place = |(frame, change): (usize, &f64)| ((frame + 1) as f64 * self.step, *change);
            Curve {
                name: format!("{}, {}", words(*configuration), configuration.substeps),
                colour: colour_of((configuration.solver, configuration.sweeps)),
                marker: Marker::None,
                width: 2,
                points: core::iter::once((0.0, 0.0)).chain(changes.iter().enumerate().map(place)).collect(),
            }
        };
        Plot {
            title: &self.name,
            axes: [
                Axis { words: "time, s", log: false, bounds: (0.0, 1e6) },
                Axis { words: "change of energy, % of mass × gravity × size", log: false, bounds: DRAWN },
            ],
            curves: self.courses.iter().map(curve).collect(),
            notes: vec![
                "After the comma:".to_string(),
                "substeps per frame.".to_string(),
                "Beyond ±20 %: not drawn.".to_string(),
            ],
        }
    }
}

fn words(Configuration { solver, sweeps, .. }: Configuration) -> String {
    debug_assert!(USUAL.contains(&(solver, sweeps)));
    name(solver, sweeps)
}
