//! The awning with one property changed at a time.

use std::path::Path;

use indicatif::ProgressBar;
use kerchief::material::Material;
use rayon::prelude::*;
use serde::Serialize;

use crate::awning::{Awning, Outcome, STEP, cropped};
use console::studio::Studio;
use laboratory::page::{Page, scientific, write_csv, write_png};
use laboratory::plot::{Axis, COLOURS, Curve, Marker, Plot};
use laboratory::strip::strip;

/// Factors on a property.
const FACTORS: [f64; 5] = [0.25, 0.5, 1.0, 2.0, 4.0];
/// The side of a picture, pixels.
const SIDE: u32 = 400;

/// A property that is changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Property {
    Stiffness,
    Shear,
    Bend,
    Density,
    Damping,
    Step,
    Sweeps,
}

impl Property {
    const ALL: [Self; 7] =
        [Self::Stiffness, Self::Shear, Self::Bend, Self::Density, Self::Damping, Self::Step, Self::Sweeps];

    const fn name(self) -> &'static str {
        match self {
            Self::Stiffness => "stretch stiffness C",
            Self::Shear => "shear stiffness G",
            Self::Bend => "bending rigidity B",
            Self::Density => "density",
            Self::Damping => "drag",
            Self::Step => "time step",
            Self::Sweeps => "iterations",
        }
    }

    /// The awning with the property multiplied by a factor, and the new value in words.
    fn changed(self, awning: &Awning, factor: f64) -> (Awning, String) {
        let mut changed = *awning;
        let Material { density, stretch, shear, bend, .. } = &mut changed.material;
        let (property, unit) = match self {
            Self::Stiffness => (stretch, "N/m"),
            Self::Shear => (shear, "N/m"),
            Self::Bend => (bend, "N·m"),
            Self::Density => (density, "kg/m²"),
            Self::Damping => (&mut changed.drag, "1/s"),
            Self::Step => {
                changed.substeps = (f64::from(awning.substeps) / factor).round().max(1.0) as u32;
                return (changed, format!("{:.3} ms", 1e3 * STEP / f64::from(changed.substeps)));
            }
            Self::Sweeps => {
                changed.sweeps = (f64::from(awning.sweeps) * factor).round().max(1.0) as u32;
                return (changed, changed.sweeps.to_string());
            }
        };
        *property *= factor;
        let value = *property;
        let words = if value < 1e-2 { format!("{value:.1e} {unit}") } else { format!("{value:.3} {unit}") };
        (changed, words)
    }
}

/// The results with each property at each value.
#[derive(Clone, Debug)]
pub(crate) struct Parameters {
    awning: Awning,
    side: usize,
    changes: Vec<Change>,
}

#[derive(Clone, Debug)]
struct Change {
    property: Property,
    factor: f64,
    words: String,
    outcome: Outcome,
}

/// A row of the table.
#[derive(Clone, Debug, Serialize)]
struct Row {
    property: &'static str,
    factor: f64,
    value: String,
    sag: f64,
    strain: f64,
    distance_at_rest: f64,
    distance_in_motion: f64,
}

impl Parameters {
    /// Runs all sheets.
    pub(crate) fn of(awning: Awning, side: usize, bar: &ProgressBar) -> Result<Self, String> {
        let all: Vec<_> = Property::ALL.iter().flat_map(|&property| FACTORS.map(|factor| (property, factor))).collect();
        bar.inc_length(all.len() as u64);
        let run = |&(property, factor): &(Property, f64)| {
            let (changed, words) = property.changed(&awning, factor);
            let outcome = changed.outcome(side)?;
            bar.inc(1);
            Ok::<_, String>(Change { property, factor, words, outcome })
        };
        let mut changes: Vec<Change> = all.par_iter().map(run).collect::<Result<_, _>>()?;
        // Sweeps are rounded to whole numbers, so that two factors may give the same number.
        changes.dedup_by(|a, b| a.property == b.property && a.words == b.words);
        Ok(Self { awning, side, changes })
    }

    fn rows(&self) -> Vec<Row> {
        let base = self.changes.iter().find(|change| change.factor == 1.0).expect("the sheet as it is");
        let row = |change: &Change| {
            let [distance_at_rest, distance_in_motion] = change.outcome.distances(&base.outcome);
            Row {
                property: change.property.name(),
                factor: change.factor,
                value: change.words.clone(),
                sag: change.outcome.sag,
                strain: change.outcome.strain,
                distance_at_rest,
                distance_in_motion,
            }
        };
        self.changes.iter().map(row).collect()
    }

    /// Writes plot, pictures and table, and adds them to the page.
    pub(crate) fn report(&self, page: &mut Page, directory: &Path) -> Result<(), String> {
        let rows = self.rows();
        page.paragraph("## One property at a time");
        page.paragraph(&format!(
            "{1} Grid: {0} × {0} particles. Distances are from the sheet without changes.",
            self.side,
            self.awning.method()
        ));
        self.plot().write(directory, "parameters.svg")?;
        page.picture("sag against the factor by which a property is changed", "parameters.svg");
        self.pictures(directory)?;
        page.picture("the sheet at rest with four stretch stiffnesses", "parameters.png");
        page.table(
            &["property", "value", "sag, mm", "largest strain, %", "distance at rest", "distance in motion"],
            rows.iter().map(|row| {
                let distance = |distance: f64| if distance == 0.0 { "0".to_string() } else { scientific(distance) };
                vec![
                    row.property.to_string(),
                    row.value.clone(),
                    format!("{:.3}", 1e3 * row.sag),
                    format!("{:.3}", 100.0 * row.strain),
                    distance(row.distance_at_rest),
                    distance(row.distance_in_motion),
                ]
            }),
        );
        write_csv(directory, "parameters.csv", &rows)
    }

    fn plot(&self) -> Plot<'static> {
        let curve = |(index, &property): (usize, &Property)| {
            let own = self.changes.iter().filter(|change| change.property == property);
            Curve {
                name: property.name().to_string(),
                colour: COLOURS[index],
                marker: Marker::Disc,
                width: 2,
                points: own.map(|change| (change.factor, 1e3 * change.outcome.sag)).collect(),
            }
        };
        Plot {
            title: "sag of the awning",
            axes: [
                Axis { words: "factor on the property", log: true, bounds: (1e-3, 1e3) },
                Axis { words: "sag, mm", log: false, bounds: (0.0, 1e6) },
            ],
            curves: Property::ALL.iter().enumerate().map(curve).collect(),
            notes: Vec::new(),
        }
    }

    fn pictures(&self, directory: &Path) -> Result<(), String> {
        let scene = self.awning.scene(self.side)?;
        let shown = |change: &&Change| change.property == Property::Stiffness && change.factor != 0.5;
        let changes: Vec<_> = self.changes.iter().filter(shown).collect();
        let studio = Studio::new(&scene, changes.iter().map(|change| &change.outcome.still), SIDE)?;
        let panel =
            |change: &&Change| (cropped(&studio.picture(&change.outcome.still)), format!("C = {}", change.words));
        write_png(directory, "parameters.png", &strip(&changes.iter().map(panel).collect::<Vec<_>>()))
    }
}
