//! Steps of a fixed length in real time.

/// Says how many steps are due.
///
/// Every step has the same length, whatever the time between two pictures: a simulation depends on nothing else. Where pictures take longer than a step, some
/// steps are made up between two of them. What is later still is dropped: the sheet then moves more slowly than time, but a slow picture is never answered by more
/// work than the next one can bear.
#[derive(Debug)]
pub(crate) struct Pace {
    /// Steps until the last question.
    asked: u32,
    /// Steps between two pictures, at most.
    most: u32,
    /// Steps that were dropped.
    pub(crate) dropped: u32,
}

impl Pace {
    /// At most so many steps between two pictures.
    pub(crate) const fn new(most: u32) -> Self {
        Self { asked: 0, most, dropped: 0 }
    }

    /// The steps that are due, when the clock has seen so many since the start.
    pub(crate) fn due(&mut self, now: u32) -> u32 {
        let late = now.wrapping_sub(self.asked);
        let due = late.min(self.most);
        self.dropped += late - due;
        self.asked = now;
        due
    }
}
