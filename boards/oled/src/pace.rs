//! Steps of a fixed length in real time.

/// Counts the steps that are due.
///
/// Every step has the same length, whatever the time between two pictures, so that a simulation does not depend on that time. Where pictures take longer than a
/// step, several steps are made between two of them, up to a limit. Further steps are dropped: the sheet then moves more slowly than real time, but a slow picture
/// never gives the next one more work than that limit.
#[derive(Debug)]
pub(crate) struct Pace {
    /// The clock's steps at the last call of `due`.
    asked: u32,
    /// Steps between two pictures, at most.
    most: u32,
    /// Steps that were dropped.
    pub(crate) dropped: u32,
}

impl Pace {
    /// At most `most` steps between two pictures.
    pub(crate) const fn new(most: u32) -> Self {
        Self { asked: 0, most, dropped: 0 }
    }

    /// The steps that are due at `now`, the clock's steps since the start.
    pub(crate) fn due(&mut self, now: u32) -> u32 {
        let late = now.wrapping_sub(self.asked);
        let due = late.min(self.most);
        self.dropped += late - due;
        self.asked = now;
        due
    }
}
