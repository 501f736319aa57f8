//! A map: the outcomes over two variables, for every solver and number type.

use std::path::Path;

use indicatif::ProgressBar;
use kerchief::host::{ScalarKind, SolverKind};
use rayon::prelude::*;
use serde::Serialize;

use crate::experiment::{Experiment, LARGEST, Outcome, Pose, USUAL};
use crate::heat::{Panel, Scale, Sheet};
use laboratory::page::Page;

/// Solvers, number types and sizes of the study.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Setting<'a> {
    pub(crate) solvers: &'a [SolverKind],
    pub(crate) scalars: &'a [ScalarKind],
    /// Values along each axis.
    pub(crate) points: u32,
    /// Frames of a run in maps over the step, with one substep each; maps over substeps run a quarter of them.
    pub(crate) frames: u32,
    /// The most particles a side.
    pub(crate) most: u32,
}

/// A variable of an axis.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variable {
    pub(crate) words: &'static str,
    /// Its values: spread evenly on a logarithmic scale, or listed.
    values: Values,
    set: fn(&mut Experiment, f64),
}

#[derive(Clone, Copy, Debug)]
enum Values {
    Between(f64, f64),
    These(&'static [f64]),
    Sides(&'static [usize]),
}

impl Variable {
    fn values(&self, setting: &Setting) -> Vec<f64> {
        match self.values {
            Values::Sides(values) => {
                values.iter().map(|&side| side as f64).filter(|&side| side <= f64::from(setting.most)).collect()
            }
            Values::These(values) => values.to_vec(),
            Values::Between(low, high) => {
                let part = |k: u32| f64::from(k) / f64::from(setting.points - 1);
                (0..setting.points).map(|k| low * (high / low).powf(part(k))).collect()
            }
        }
    }
}

/// The plan of a map.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Plan {
    pub(crate) name: &'static str,
    pub(crate) title: &'static str,
    /// Differences of its sheets from the usual sheet, in words.
    words: &'static str,
    /// The sheet whose two variables change.
    usual: Experiment,
    across: Variable,
    up: Variable,
    /// The value of `up` at which a solver becomes unstable by theory, in an experiment with a given value of `across`.
    limit: fn(SolverKind, Experiment) -> Option<f64>,
    /// Whether the energy is drawn, too.
    energy: bool,
}

const STEP: Variable =
    Variable { words: "step, s", values: Values::Between(1e-4, 0.2), set: |experiment, step| experiment.frame = step };

const STIFFNESS: Variable = Variable {
    words: "stiffness, N/m",
    values: Values::Between(1.0, 1e11),
    set: |experiment, stiffness| experiment.stiffness = stiffness,
};

/// The longest stable step for the springs.
fn too_fast(solver: SolverKind, experiment: Experiment) -> Option<f64> {
    let frequency = experiment.frequency();
    match solver {
        SolverKind::Leapfrog => Some(2.0 / frequency),
        SolverKind::ForwardEuler => Some(experiment.drag / (frequency * frequency)),
        _ => None,
    }
}

const SIDE: Variable = Variable {
    words: "particles a side",
    values: Values::Sides(&[4, 8, 16, 32, 48, 64, LARGEST]),
    set: |experiment, side| experiment.side = side as usize,
};

/// Substeps of a sixtieth of a second.
const SUBSTEPS: Variable = Variable {
    words: "substeps of 1/60 s",
    values: Values::These(&[1.0, 2.0, 4.0, 8.0, 16.0]),
    set: |experiment, substeps| experiment.substeps = substeps as u32,
};

const WIND: Variable = Variable {
    words: "wind, m/s",
    values: Values::Between(0.1, 100.0),
    set: |experiment, wind| experiment.wind = wind,
};

/// The smallest stable number of substeps for the springs.
fn too_few(solver: SolverKind, experiment: Experiment) -> Option<f64> {
    too_fast(solver, experiment).map(|step| experiment.frame / step)
}

/// The sheet for maps over grids: stiff, so that it doesn't stretch by its own weight.
const STIFF: Experiment = Experiment { stiffness: 1e4, drag: 2.0, ..USUAL };
const SHEETS: &str = "Springs of 10⁴ N/m, drag 2 /s. Largest grids: 16 × 16 for backward Euler, 64 × 64 for the line solver, 32 × 32 for the others. Laid flat and pinned at two \
    corners, the line solver in `f32` goes to 128 × 128.";

/// All maps.
pub(crate) const MAPS: [Plan; 8] = [
    Plan {
        name: "stiffness",
        title: "Step and stiffness",
        words: "",
        usual: USUAL,
        across: STIFFNESS,
        up: STEP,
        limit: too_fast,
        energy: true,
    },
    Plan {
        name: "mass",
        title: "Step and mass ratio",
        words: "",
        usual: USUAL,
        across: Variable {
            words: "mass of the border / mass inside",
            values: Values::Between(1e-3, 1e3),
            set: |experiment, ratio| experiment.hem = ratio,
        },
        up: STEP,
        limit: too_fast,
        energy: false,
    },
    Plan {
        name: "wind",
        title: "Step and wind",
        words: "",
        usual: USUAL,
        across: WIND,
        up: STEP,
        limit: |solver, experiment| {
            let wind = 2.0 / experiment.wind_rate();
            Some(too_fast(solver, experiment).map_or(wind, |springs| springs.min(wind)))
        },
        energy: false,
    },
    Plan {
        name: "grid",
        title: "Hung: substeps and grid",
        words: SHEETS,
        usual: STIFF,
        across: SIDE,
        up: SUBSTEPS,
        limit: too_few,
        energy: true,
    },
    Plan {
        name: "laid",
        title: "Laid flat and pinned at two corners: substeps and grid",
        words: SHEETS,
        usual: Experiment { pose: Pose::Laid, ..STIFF },
        across: SIDE,
        up: SUBSTEPS,
        limit: too_few,
        energy: true,
    },
    Plan {
        name: "centre",
        title: "Laid flat and pinned in the centre: substeps and grid",
        words: SHEETS,
        usual: Experiment { pose: Pose::Centre, ..STIFF },
        across: SIDE,
        up: SUBSTEPS,
        limit: too_few,
        energy: true,
    },
    Plan {
        name: "storm",
        title: "Storms: substeps and wind",
        words: "16 × 16 particles, springs of 10⁴ N/m. The wind blows across the sheet.",
        usual: Experiment { side: 16, stiffness: 1e4, ..USUAL },
        across: WIND,
        up: SUBSTEPS,
        limit: too_few,
        energy: false,
    },
    Plan {
        name: "compliance",
        title: "Compliance and substeps",
        words: "",
        usual: USUAL,
        across: Variable {
            words: "compliance, m/N",
            values: Values::Between(1e-12, 1.0),
            set: |experiment, compliance| experiment.stiffness = 1.0 / compliance,
        },
        up: SUBSTEPS,
        limit: too_few,
        energy: false,
    },
];

/// The outcomes of all runs of a map.
#[derive(Clone, Debug)]
pub(crate) struct Map {
    pub(crate) plan: Plan,
    pub(crate) across: Vec<f64>,
    pub(crate) up: Vec<f64>,
    pub(crate) fields: Vec<Field>,
}

/// The part of a map for one solver and number type.
#[derive(Clone, Debug)]
pub(crate) struct Field {
    pub(crate) solver: SolverKind,
    pub(crate) scalar: ScalarKind,
    /// Row by row, from the lowest.
    pub(crate) outcomes: Vec<Outcome>,
}

/// A row of the table.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct Row {
    map: &'static str,
    solver: &'static str,
    scalar: &'static str,
    across: f64,
    up: f64,
    outcome: &'static str,
    strain: Option<f64>,
    energy: Option<f64>,
}

impl Plan {
    /// The number of runs.
    pub(crate) fn runs(&self, setting: &Setting) -> u64 {
        let points = self.across.values(setting).len() * self.up.values(setting).len();
        (points * setting.solvers.len() * setting.scalars.len()) as u64
    }

    /// The frames of a run: the same number in the whole map.
    fn frames(&self, setting: &Setting) -> u32 {
        if self.up.words == SUBSTEPS.words { setting.frames.div_ceil(4) } else { setting.frames }
    }

    /// Makes all runs.
    pub(crate) fn explore(&self, setting: &Setting, bar: &ProgressBar) -> Result<Map, String> {
        let (across, up) = (self.across.values(setting), self.up.values(setting));
        let kinds =
            setting.solvers.iter().flat_map(|&solver| setting.scalars.iter().map(move |&scalar| (solver, scalar)));
        let fields = kinds.map(|(solver, scalar)| {
            let places: Vec<_> = up.iter().flat_map(|&up| across.iter().map(move |&across| (across, up))).collect();
            let run = |&(across, up): &(f64, f64)| {
                let outcome = self.experiment(across, up).run(solver, scalar, self.frames(setting));
                bar.inc(1);
                outcome
            };
            let outcomes = places.par_iter().map(run).collect::<Result<_, _>>()?;
            Ok(Field { solver, scalar, outcomes })
        });
        let fields = fields.collect::<Result<_, String>>()?;
        Ok(Map { plan: *self, across, up, fields })
    }

    fn experiment(&self, across: f64, up: f64) -> Experiment {
        let mut experiment = self.usual;
        (self.up.set)(&mut experiment, up);
        (self.across.set)(&mut experiment, across);
        experiment
    }

    /// The theoretical limit on `up` at a value of `across`.
    pub(crate) fn limit(&self, solver: SolverKind, across: f64) -> Option<f64> {
        let up = match self.up.values {
            Values::Between(low, _) => low,
            _ => 1.0,
        };
        (self.limit)(solver, self.experiment(across, up))
    }
}

impl Map {
    pub(crate) fn rows(&self) -> Vec<Row> {
        let rows = self.fields.iter().flat_map(|field| {
            field.outcomes.iter().enumerate().map(|(k, outcome)| {
                let (word, strain, energy) = match *outcome {
                    Outcome::NotHeld => ("refused", None, None),
                    Outcome::NotComputed => ("not computed", None, None),
                    Outcome::Gone => ("gone", None, None),
                    Outcome::Held { strain, energy } => ("held", Some(strain), Some(energy)),
                };
                Row {
                    map: self.plan.name,
                    solver: field.solver.name(),
                    scalar: field.scalar.name(),
                    across: self.across[k % self.across.len()],
                    up: self.up[k / self.across.len()],
                    outcome: word,
                    strain,
                    energy,
                }
            })
        });
        rows.collect()
    }

    /// Draws strain and energy, and adds them to the page.
    pub(crate) fn report(&self, page: &mut Page, directory: &Path) -> Result<(), String> {
        page.paragraph(&format!("## {}", self.plan.title));
        if !self.plan.words.is_empty() {
            page.paragraph(self.plan.words);
        }
        let strain = Scale { words: "largest strain of a stretch link", low: 1e-4, high: 10.0 };
        self.draw(strain, |strain, _| strain, directory, page)?;
        if self.plan.energy {
            let energy = Scale { words: "gain of energy / (weight · size)", low: 1e-4, high: 10.0 };
            self.draw(energy, |_, energy| energy, directory, page)?;
        }
        Ok(())
    }

    fn draw(&self, scale: Scale, of: fn(f64, f64) -> f64, directory: &Path, page: &mut Page) -> Result<(), String> {
        let panels = self.fields.iter().map(|field| Panel {
            title: format!("{} {}", field.solver.name(), field.scalar.name()),
            cells: field.outcomes.iter().map(|&outcome| (outcome, of)).collect(),
            limit: self.across.iter().map(|&across| self.plan.limit(field.solver, across)).collect(),
        });
        let rows = self.fields.iter().map(|field| field.solver).collect::<Vec<_>>();
        let columns = rows.iter().filter(|solver| **solver == rows[0]).count();
        let sheet = Sheet {
            title: format!("{}: {}", self.plan.title, scale.words),
            across: (self.plan.across.words, &self.across),
            up: (self.plan.up.words, &self.up),
            scale,
            columns,
            panels: panels.collect(),
        };
        let kind = scale.words.split(' ').find(|word| ["strain", "energy"].contains(word)).unwrap_or("map");
        let name = format!("stability-{}-{kind}.svg", self.plan.name);
        sheet.write(directory, &name)?;
        page.picture(&sheet.title, &name);
        Ok(())
    }
}
