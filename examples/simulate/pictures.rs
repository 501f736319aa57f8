//! Pictures of a run: an animation, or one file each.

use std::path::Path;

use indicatif::ProgressBar;
use kerchief::host::{Bounds, Description, Still};
use rayon::prelude::*;

use crate::animation::{Animation, Palette};
use crate::spool::Spool;
use console::staging::{Complete, Staged};
use console::studio::Studio;

/// The side of a picture, pixels.
const SIDE: u32 = 540;
/// The shortest time between two pictures of an animation, s: browsers slow down animations of more than 50 a second, and 30 look smooth.
const SPACING: f64 = 1.0 / 30.0;
/// The time for which an animation shows its last picture, s.
const LAST: f64 = 1.0;
/// Pictures from which an animation's palette is computed.
const SAMPLES: usize = 8;
/// Pictures drawn at once.
const BATCH: usize = 16;

/// The recorded moments of a run. They are stored on the disk, because the camera's place and the animation's palette are known only at the end.
#[derive(Debug)]
pub(crate) struct Album<'a> {
    scene: &'a Description,
    directory: &'a Path,
    /// Whether to write an animation, and whether to write a picture of each moment.
    animation: bool,
    pictures: bool,
    seen: Bounds,
    spool: Spool,
    /// The moments that the animation shows, as numbers of the spool.
    shown: Vec<usize>,
    /// The last moment, where it is not on the spool.
    last: Option<(u32, Still)>,
}

impl<'a> Album<'a> {
    /// An empty album for an animation, for pictures or for both, in `directory`.
    pub(crate) fn new(
        scene: &'a Description,
        directory: &'a Path,
        animation: bool,
        pictures: bool,
    ) -> Result<Self, String> {
        let (seen, spool) = (Bounds::new(scene), Spool::new(directory)?);
        Ok(Self { scene, directory, animation, pictures, seen, spool, shown: Vec::new(), last: None })
    }

    /// Adds the moment at the end of a frame.
    pub(crate) fn add(&mut self, frame: u32, still: &Still) -> Result<(), String> {
        self.seen.include(self.scene, still);
        let before = self.shown.last().map(|&index| self.spool.frames[index]);
        let is_due = |before| f64::from(frame - before) * self.scene.solver.step > 0.999 * SPACING;
        let is_shown = self.animation && before.is_none_or(is_due);
        if is_shown {
            self.shown.push(self.spool.frames.len());
        }
        if is_shown || self.pictures {
            self.last = None;
            return self.spool.push(frame, still);
        }
        self.last = Some((frame, still.clone()));
        Ok(())
    }

    /// Draws everything: `animation.gif`, which runs as fast as the scene, and `frame-NNNNN.png` for each moment.
    pub(crate) fn develop(mut self, bar: &ProgressBar) -> Result<Vec<Complete>, String> {
        if let Some((frame, still)) = self.last.take() {
            self.spool.push(frame, &still)?;
        }
        let studio = Studio::within(self.scene, self.seen, SIDE)?;
        let mut files = Vec::new();
        if self.animation {
            // the animation ends with the last moment, even if the time before it is a little longer than the others
            let end = self.spool.frames.len() - 1;
            if self.shown.last() != Some(&end) {
                self.shown.truncate((self.shown.len() - 1).max(1));
                self.shown.push(end);
            }
            files.push(self.animate(&studio, bar)?);
        }
        if self.pictures {
            files.extend(self.print(&studio, bar)?);
        }
        bar.finish_and_clear();
        Ok(files)
    }

    fn animate(&mut self, studio: &Studio<'_>, bar: &ProgressBar) -> Result<Complete, String> {
        let shown = &self.shown;
        let samples: Vec<_> = shown.iter().copied().step_by(shown.len().div_ceil(SAMPLES)).collect();
        let draw = |stills: Vec<(u32, Still)>| stills.par_iter().map(|(_, still)| studio.picture(still)).collect();
        let samples: Vec<_> = draw(self.spool.read(&samples)?);
        let palette = Palette::of(&samples);

        let mut file = Staged::create(self.directory, "animation.gif")?;
        let result = (|| {
            let failed = |error: gif::EncodingError| error.to_string();
            let mut animation = Animation::new(&mut file, SIDE as u16, SIDE as u16, &palette).map_err(failed)?;
            let frames: Vec<_> = shown.iter().map(|&index| self.spool.frames[index]).collect();
            let mut following = frames.windows(2).map(|pair| f64::from(pair[1] - pair[0]) * self.scene.solver.step);
            bar.set_length(frames.len() as u64);
            for batch in shown.chunks(BATCH) {
                let pictures: Vec<_> = draw(self.spool.read(batch)?);
                for picture in &pictures {
                    animation.show(picture, following.next().unwrap_or(LAST)).map_err(failed)?;
                    bar.inc(1);
                }
            }
            Ok::<_, String>(())
        })();
        file.named(result)?;
        file.complete()
    }

    fn print(&mut self, studio: &Studio<'_>, bar: &ProgressBar) -> Result<Vec<Complete>, String> {
        let count = self.spool.frames.len();
        bar.set_length(count as u64);
        bar.set_position(0);
        let mut files = Vec::new();
        for first in (0..count).step_by(BATCH) {
            let batch: Vec<_> = (first..count.min(first + BATCH)).collect();
            let pictures = self.spool.read(&batch)?.into_par_iter().map(|(frame, still)| {
                let mut file = Staged::create(self.directory, &format!("frame-{frame:05}.png"))?;
                let encoder = image::codecs::png::PngEncoder::new(&mut file);
                let result = studio.picture(&still).write_with_encoder(encoder);
                file.named(result)?;
                bar.inc(1);
                file.complete()
            });
            files.extend(pictures.collect::<Result<Vec<_>, String>>()?);
        }
        Ok(files)
    }
}
