//! The reference solution for errors: leapfrog in `f64`, whose substeps are doubled until the extrapolated solution converges.

use std::fs;
use std::hash::{DefaultHasher, Hash, Hasher};
use std::path::Path;

use kerchief::host::{Description, ScalarKind, SceneError, SolverKind};
use serde::{Deserialize, Serialize};

use super::Start;
use super::configuration::Configuration;
use console::staging::{self, Staged};

/// Substeps of the first solution.
const FEWEST: u32 = 64;
/// The most substeps, converged or not.
const MOST: u32 = 4096;
/// A solution has blown up if its RMS distance from the start is larger, sheet sizes.
const LOST: f64 = 10.0;

/// Positions at the ends of frames, m.
pub type Frames = Vec<Vec<[f64; 3]>>;

/// A solution and its convergence.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Reference {
    /// The scene's text. It identifies a cached solution.
    scene: String,
    /// Position of every particle at the end of every frame, m: Richardson's extrapolation from the solutions with `substeps` and with half as many.
    pub positions: Frames,
    /// The most substeps per frame.
    pub substeps: u32,
    /// RMS distance over all particles and frames from the extrapolation from half as many substeps, divided by the sheet's size.
    pub difference: f64,
    /// The observed order without extrapolation, from the last three solutions.
    pub order: Option<f64>,
    tolerance: f64,
}

impl Reference {
    /// The solution of a scene. It is read from `cache` if it is there, and stored there otherwise.
    pub fn of(
        start: Start,
        text: &str,
        scene: &Description,
        frames: u32,
        tolerance: f64,
        cache: &Path,
    ) -> Result<Self, String> {
        let mut hasher = DefaultHasher::new();
        text.hash(&mut hasher);
        let name = format!("{}-{:016x}.json", scene.name.replace(|c: char| !c.is_alphanumeric(), "-"), hasher.finish());
        let cached = fs::read(cache.join(&name)).ok().and_then(|bytes| serde_json::from_slice::<Self>(&bytes).ok());
        let is_it = |found: &Self| {
            let enough = found.difference <= tolerance || found.tolerance <= tolerance;
            found.scene == text && found.positions.len() as u32 >= frames && enough
        };
        if let Some(mut reference) = cached.filter(is_it) {
            reference.positions.truncate(frames as usize);
            return Ok(reference);
        }
        let reference = Self::solve(start, text, scene, frames, tolerance)?;
        staging::prepare(cache)?;
        let mut file = Staged::create(cache, &name)?;
        let written = serde_json::to_writer(&mut file, &reference);
        file.named(written)?;
        file.finish()?;
        Ok(reference)
    }

    fn solve(start: Start, text: &str, scene: &Description, frames: u32, tolerance: f64) -> Result<Self, String> {
        let size = size(scene);
        let (mut substeps, mut coarse) = (FEWEST, None::<Frames>);
        let (mut before, mut limit, mut order) = (None::<f64>, None::<Frames>, None);
        let mut difference = f64::INFINITY;
        while substeps <= MOST {
            let (solver, scalar) = (SolverKind::Leapfrog, ScalarKind::F64);
            let leapfrog = Configuration { solver, scalar, substeps, sweeps: 1, tolerance: None };
            let fine = record(start, scene, leapfrog, frames).map_err(|error| error.to_string())?;
            if let (Some(fine), Some(coarse)) = (&fine, &coarse) {
                let distance = rms(fine, coarse) / size;
                order = before.map(|before: f64| (before / distance).log2());
                before = Some(distance);
                let extrapolated = extrapolate(fine, coarse);
                difference = limit.map_or(f64::INFINITY, |limit| rms(&extrapolated, &limit) / size);
                limit = Some(extrapolated);
            }
            coarse = fine;
            if difference <= tolerance {
                break;
            }
            substeps *= 2;
        }
        let positions = limit.filter(|_| difference.is_finite());
        let positions = positions.ok_or("no reference: leapfrog blows up with all the substeps that are tried")?;
        Ok(Self { scene: text.to_string(), positions, substeps: substeps.min(MOST), difference, order, tolerance })
    }
}

/// The sheet's longer side, m.
pub fn size(scene: &Description) -> f64 {
    scene.sheet.width.max(scene.sheet.height)
}

/// RMS distance of all particles at all times, m.
pub fn rms(a: &Frames, b: &Frames) -> f64 {
    let mean = |(a, b): (&Vec<[f64; 3]>, &Vec<[f64; 3]>)| mean_square(a, b);
    (a.iter().zip(b).map(mean).sum::<f64>() / a.len() as f64).sqrt()
}

/// The mean squared distance of particles, m².
pub fn mean_square(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let square = |(a, b): (&[f64; 3], &[f64; 3])| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>();
    a.iter().zip(b).map(square).sum::<f64>() / a.len() as f64
}

/// Richardson's extrapolation for a method of second order.
fn extrapolate(fine: &Frames, coarse: &Frames) -> Frames {
    let particle = |(f, c): (&[f64; 3], &[f64; 3])| core::array::from_fn(|k| (4.0 * f[k] - c[k]) / 3.0);
    fine.iter().zip(coarse).map(|(fine, coarse)| fine.iter().zip(coarse).map(particle).collect()).collect()
}

/// Position of every particle at the end of every frame, m; `None` if the sheet blew up.
pub fn record(
    start: Start,
    scene: &Description,
    configuration: Configuration,
    frames: u32,
) -> Result<Option<Frames>, SceneError> {
    let mut moving = start(&configuration.of(scene), configuration.scalar)?;
    let furthest = LOST * size(scene);
    let first = moving.still().positions;
    let mut positions = Frames::new();
    for _ in 0..frames {
        moving.frame();
        let now = moving.still().positions;
        // An undefined distance counts as far.
        let is_near = mean_square(&now, &first).sqrt() < furthest;
        if !is_near {
            return Ok(None);
        }
        positions.push(now);
    }
    Ok(Some(positions))
}
