//! The clock: the number of frames that are due, and the rate of pictures.

use std::time::{Duration, Instant};

/// The most frames that are computed for one picture, so that the motion keeps up with the clock.
const MOST: u32 = 4;
/// The shortest interval in which pictures are counted.
const COUNTED: Duration = Duration::from_secs(1);

/// When the next frame is due.
#[derive(Debug)]
pub struct Clock {
    step: Duration,
    due: Instant,
}

impl Clock {
    /// A clock for frames of `step` seconds, the first of which is due now.
    pub fn new(step: f64, now: Instant) -> Self {
        Self { step: Duration::from_secs_f64(step.min(3600.0)), due: now }
    }

    /// The number of frames that are due, at most `MOST`.
    pub fn frames(&mut self, now: Instant) -> u32 {
        let mut frames = 0;
        while self.due <= now {
            if frames == MOST {
                // The computer is too slow for the clock: skip the missed frames.
                self.due = now;
                break;
            }
            self.due += self.step;
            frames += 1;
        }
        frames
    }
}

/// Pictures a second.
#[derive(Debug)]
pub struct Rate {
    since: Instant,
    pictures: u32,
    measured: Option<f64>,
}

impl Rate {
    pub fn new(now: Instant) -> Self {
        Self { since: now, pictures: 0, measured: None }
    }

    /// Counts a picture that was shown.
    pub fn count(&mut self, now: Instant) {
        self.pictures += 1;
        let passed = now - self.since;
        if passed >= COUNTED {
            self.measured = Some(f64::from(self.pictures) / passed.as_secs_f64());
            (self.since, self.pictures) = (now, 0);
        }
    }

    /// Pictures a second in the last interval; none in the first one.
    pub fn a_second(&self) -> Option<f64> {
        self.measured
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_keep_up_with_the_clock_as_long_as_they_can() {
        let start = Instant::now();
        let at = |millis: u64| start + Duration::from_millis(millis);
        let mut clock = Clock::new(0.01, start);
        assert_eq!([0, 0, 9, 10, 35].map(|millis| clock.frames(at(millis))), [1, 0, 0, 1, 2]);
        assert_eq!(clock.frames(at(5000)), MOST, "late by far");
        assert_eq!(clock.frames(at(5000)), 1, "missed frames are skipped");
        assert_eq!(clock.frames(at(5009)), 0);
    }

    #[test]
    fn pictures_are_counted_for_a_second() {
        let start = Instant::now();
        let at = |millis: u64| start + Duration::from_millis(millis);
        let mut rate = Rate::new(start);
        (1..50).for_each(|picture| rate.count(at(20 * picture)));
        assert_eq!(rate.a_second(), None, "not yet");
        rate.count(at(1000));
        assert_eq!(rate.a_second(), Some(50.0));
        rate.count(at(1500));
        assert_eq!(rate.a_second(), Some(50.0), "of the last whole second");
        rate.count(at(3000));
        assert_eq!(rate.a_second(), Some(1.0), "a stall counts");
    }
}
