//! Pictures of a run: an animation, or one file each.

use std::path::Path;

use indicatif::ProgressBar;
use kerchief::host::{Description, Still};
use rayon::prelude::*;

use crate::animation::{Animation, Palette};
use console::staging::{Complete, Staged};
use console::studio::Studio;

/// The side of a picture, pixels.
const SIDE: u32 = 540;
/// The shortest time between two pictures of an animation, s: browsers slow down what is faster than 50 a second, and 30 look smooth.
const SPACING: f64 = 1.0 / 30.0;
/// How long an animation shows its last picture, s.
const LAST: f64 = 1.0;
/// Pictures that an animation's colours are taken from.
const SAMPLES: usize = 8;
/// Pictures drawn at once.
const BATCH: usize = 16;

/// What was recorded of a run.
#[derive(Debug)]
pub(crate) struct Album<'a> {
    scene: &'a Description,
    stills: Vec<(u32, Still)>,
}

impl<'a> Album<'a> {
    /// An empty album.
    pub(crate) fn new(scene: &'a Description) -> Self {
        Self { scene, stills: Vec::new() }
    }

    /// Adds the moment at the end of a frame.
    pub(crate) fn add(&mut self, frame: u32, still: Still) {
        self.stills.push((frame, still));
    }

    fn studio(&self) -> Result<Studio<'a>, String> {
        let stills = self.stills.iter().map(|(_, still)| still);
        Studio::new(self.scene, stills, SIDE)
    }

    /// `animation.gif`, which runs as fast as the scene.
    pub(crate) fn animation(&self, directory: &Path, bar: &ProgressBar) -> Result<Complete, String> {
        let studio = self.studio()?;
        let step = self.scene.solver.step;
        let mut shown: Vec<&(u32, Still)> = Vec::new();
        for moment in &self.stills {
            let is_due = |before: &&(u32, Still)| f64::from(moment.0 - before.0) * step > 0.999 * SPACING;
            if shown.last().is_none_or(is_due) {
                shown.push(moment);
            }
        }
        // ends with the end, be it a little longer than the others before it
        if let (Some(end), Some(last)) = (self.stills.last(), shown.last()) {
            if end.0 > last.0 {
                shown.truncate((shown.len() - 1).max(1));
                shown.push(end);
            }
        }
        let samples: Vec<_> = shown.iter().step_by(shown.len().div_ceil(SAMPLES)).collect();
        let samples: Vec<_> = samples.par_iter().map(|(_, still)| studio.picture(still)).collect();
        let palette = Palette::of(&samples);

        let mut file = Staged::create(directory, "animation.gif")?;
        let result = (|| {
            let mut animation = Animation::new(&mut file, SIDE as u16, SIDE as u16, &palette)?;
            bar.set_length(shown.len() as u64);
            for (batch, moments) in shown.chunks(BATCH).enumerate() {
                let pictures: Vec<_> = moments.par_iter().map(|(_, still)| studio.picture(still)).collect();
                for (index, picture) in pictures.iter().enumerate() {
                    let index = batch * BATCH + index;
                    let next = shown.get(index + 1);
                    animation.show(picture, next.map_or(LAST, |next| f64::from(next.0 - shown[index].0) * step))?;
                    bar.inc(1);
                }
            }
            Ok::<_, gif::EncodingError>(())
        })();
        file.named(result)?;
        file.complete()
    }

    /// `frame-NNNNN.png` for each moment.
    pub(crate) fn pictures(&self, directory: &Path, bar: &ProgressBar) -> Result<Vec<Complete>, String> {
        let studio = self.studio()?;
        bar.set_length(self.stills.len() as u64);
        let pictures = self.stills.par_iter().map(|(frame, still)| {
            let mut file = Staged::create(directory, &format!("frame-{frame:05}.png"))?;
            let encoder = image::codecs::png::PngEncoder::new(&mut file);
            let result = studio.picture(still).write_with_encoder(encoder);
            file.named(result)?;
            bar.inc(1);
            file.complete()
        });
        pictures.collect()
    }
}
