//! The cost of a frame: operations and instructions.

use std::collections::BTreeMap;

use indicatif::ProgressBar;
use kerchief::host::{Counted, Description, Operations, ScalarKind};
use rayon::prelude::*;

use crate::callgrind;
use crate::lean;
use laboratory::configuration::Configuration;

/// Positions of the counted frames in a run, as parts of its length.
const LOOKS: [f64; 3] = [0.25, 0.5, 0.75];

/// Substeps at which callgrind counts; the nearest numbers in the study are taken.
const ANCHORS: [u32; 2] = [3, 12];

/// Operations per particle and frame.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct PerParticle {
    pub(crate) additions: f64,
    pub(crate) products: f64,
    pub(crate) quotients: f64,
    pub(crate) roots: f64,
    pub(crate) comparisons: f64,
}

impl PerParticle {
    fn of(operations: Operations, particle_frames: f64) -> Self {
        let Operations { additions, products, quotients, roots, comparisons } = operations;
        let each = |count: u64| count as f64 / particle_frames;
        Self {
            additions: each(additions),
            products: each(products),
            quotients: each(quotients),
            roots: each(roots),
            comparisons: each(comparisons),
        }
    }

    pub(crate) fn total(self) -> f64 {
        self.additions + self.products + self.quotients + self.roots + self.comparisons
    }
}

/// Operations of a solver in a scene, as the mean of three frames during the run. A frame before each one lets the solver settle. `None` if no
/// counting sheet is compiled for the scene.
pub(crate) fn operations(scene: &Description, configuration: Configuration, frames: u32) -> Option<PerParticle> {
    let scene = configuration.of(scene);
    let mut counted = lean::counted(&scene)?.ok()?;
    let mut moving = lean::moving(&scene, ScalarKind::F32).ok()?;
    let (mut now, mut sum) = (0, Operations::default());
    for look in LOOKS {
        let then = (look * f64::from(frames)) as u32;
        (now..then).for_each(|_| moving.frame());
        now = then;
        counted.restore(&moving.state());
        counted.frame();
        Counted::reset();
        counted.frame();
        sum = sum.and(Counted::operations());
    }
    let particles = (scene.sheet.columns * scene.sheet.rows) as f64;
    Some(PerParticle::of(sum, particles * LOOKS.len() as f64))
}

/// The operations of the frame that callgrind counts, for all particles together.
fn operations_looked_at(scene: &Description, configuration: Configuration) -> Option<u64> {
    let mut counted = lean::counted(&configuration.of(scene))?.ok()?;
    (0..callgrind::BEFORE).for_each(|_| counted.frame());
    Counted::reset();
    counted.frame();
    Some(Counted::operations().total())
}

/// Instructions per operation at the anchors: (substeps, rate).
#[derive(Clone, Debug)]
pub(crate) struct Exchange(Vec<(u32, f64)>);

impl Exchange {
    /// Instructions of a frame of `operations`. The logarithm of the rate is interpolated linearly in the logarithm of the substeps.
    pub(crate) fn instructions(&self, substeps: u32, operations: f64) -> f64 {
        let place = |&(anchor, rate): &(u32, f64)| (f64::from(anchor).ln(), rate.ln());
        let at = f64::from(substeps).ln();
        let below = self.0.iter().map(place).rfind(|(anchor, _)| *anchor <= at);
        let above = self.0.iter().map(place).find(|(anchor, _)| *anchor > at);
        let rate = match (below, above) {
            (Some((left, low)), Some((right, high))) => low + (high - low) * (at - left) / (right - left),
            (Some((_, rate)), None) | (None, Some((_, rate))) => rate,
            (None, None) => f64::NAN,
        };
        rate.exp() * operations
    }

    /// Relative difference between the largest and the smallest rate.
    pub(crate) fn spread(&self) -> f64 {
        let rates = || self.0.iter().map(|(_, rate)| *rate);
        let (low, high) = (rates().fold(f64::INFINITY, f64::min), rates().fold(0.0, f64::max));
        high / low - 1.0
    }
}

/// Instructions per operation for every group of configurations that differ only in substeps, by callgrind. If the scene has no counting sheet, substeps × particles
/// replace the operations.
pub(crate) fn exchanges(
    text: &str,
    scene: &Description,
    configurations: &[Configuration],
    bar: &ProgressBar,
) -> Result<BTreeMap<String, Exchange>, String> {
    let mut anchors: Vec<Configuration> = Vec::new();
    for anchor in ANCHORS {
        let mut nearest: BTreeMap<String, Configuration> = BTreeMap::new();
        for &configuration in configurations {
            let best = nearest.entry(configuration.group()).or_insert(configuration);
            if configuration.substeps.abs_diff(anchor) < best.substeps.abs_diff(anchor) {
                *best = configuration;
            }
        }
        for configuration in nearest.into_values() {
            if !anchors.contains(&configuration) {
                anchors.push(configuration);
            }
        }
    }
    bar.inc_length(anchors.len() as u64);
    let particles = (scene.sheet.columns * scene.sheet.rows) as f64;
    let rate = |&configuration: &Configuration| {
        let instructions = callgrind::instructions(text, configuration)? as f64;
        let operations = operations_looked_at(scene, configuration)
            .map_or(f64::from(configuration.substeps) * particles, |operations| operations as f64);
        bar.inc(1);
        Ok::<_, String>((configuration, instructions / operations))
    };
    let rates: Vec<_> = anchors.par_iter().map(rate).collect::<Result<_, _>>()?;
    let mut exchanges: BTreeMap<String, Exchange> = BTreeMap::new();
    // The anchors ascend, as `Exchange::instructions` requires.
    for (configuration, rate) in rates {
        exchanges
            .entry(configuration.group())
            .or_insert_with(|| Exchange(Vec::new()))
            .0
            .push((configuration.substeps, rate));
    }
    Ok(exchanges)
}
