//! Progress on the standard error output: a changing line on a terminal, a line for each piece of work elsewhere.

use std::io::{IsTerminal, stderr};
use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// The display of running work. It vanishes when it is dropped.
pub(crate) struct Progress(ProgressBar);

impl Progress {
    /// Work whose current activity is shown as a line of text.
    pub(crate) fn lines(work: &str) -> Self {
        let bar = ProgressBar::new_spinner().with_prefix(work.to_owned());
        Self::start(bar, "{spinner} {prefix}: {wide_msg}", work)
    }

    /// A simulation of `steps` steps.
    pub(crate) fn steps(steps: u32) -> Self {
        let work = format!("running {steps} steps");
        Self::start(ProgressBar::new(steps.into()), "{spinner} step {pos} of {len} {wide_bar} {eta}", &work)
    }

    fn start(bar: ProgressBar, style: &str, work: &str) -> Self {
        if !stderr().is_terminal() {
            eprintln!("{work}");
        }
        bar.set_style(ProgressStyle::with_template(style).unwrap_or_else(|_| ProgressStyle::default_bar()));
        bar.enable_steady_tick(Duration::from_millis(100));
        Self(bar)
    }

    /// Shows the current activity.
    pub(crate) fn line(&self, line: &str) {
        self.0.set_message(line.to_owned());
    }

    /// Shows the current step.
    pub(crate) fn step(&self, step: u32) {
        self.0.set_position(step.into());
    }

    /// Prints a line of the board's log.
    pub(crate) fn print(&self, line: &str) {
        self.0.suspend(|| println!("{line}"));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
