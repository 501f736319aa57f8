//! The measurement of a run: error, strain and time.

use std::time::{Duration, Instant};

use kerchief::host::{Description, SceneError};

use super::Start;
use super::configuration::Configuration;
use super::reference::{Frames, mean_square, size};

/// A sheet has blown up if its error (sheet sizes) reaches `LOST` or its strain reaches `TORN`.
const LOST: f64 = 1.0;
const TORN: f64 = 100.0;

/// Results of a run. Error and strain are infinite if the sheet blew up.
#[derive(Clone, Copy, Debug)]
pub struct Measurement {
    /// RMS distance from the reference over all particles and frames, divided by the sheet's size.
    pub error: Option<f64>,
    /// The largest strain of a stretch link at the end of any frame.
    pub strain: f64,
    /// Computing time of the frames.
    pub time: Duration,
    /// Digest of the final state.
    pub digest: u32,
}

impl Measurement {
    /// Runs a configuration for a number of frames.
    pub fn of(
        start: Start,
        scene: &Description,
        configuration: Configuration,
        frames: u32,
        reference: Option<&Frames>,
    ) -> Result<Self, SceneError> {
        let mut moving = start(&configuration.of(scene), configuration.scalar)?;
        let mut seen = Self { error: reference.map(|_| 0.0), strain: 0.0, time: Duration::ZERO, digest: 0 };
        let mut squares = 0.0;
        for frame in 0..frames {
            let begin = Instant::now();
            moving.frame();
            seen.time += begin.elapsed();
            let strains = moving.strains();
            let strain = strains.stretch.unwrap_or(strains.all).largest;
            seen.strain = seen.strain.max(strain);
            let mut is_whole = moving.is_finite() && strain < TORN;
            if let Some(reference) = reference {
                let square = mean_square(&moving.still().positions, &reference[frame as usize]);
                squares += square;
                is_whole &= square.sqrt() < LOST * size(scene);
            }
            if !is_whole {
                let error = seen.error.map(|_| f64::INFINITY);
                return Ok(Self { error, strain: f64::INFINITY, ..seen });
            }
        }
        seen.digest = moving.digest();
        seen.error = seen.error.map(|_| (squares / f64::from(frames)).sqrt() / size(scene));
        Ok(seen)
    }
}
