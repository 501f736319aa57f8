//! The processor's own timer: it counts steps, and cycles within them.

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;

/// Steps since the start.
static STEPS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    // the only writer: a Cortex-M0 has no addition in one go
    STEPS.store(STEPS.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
}

/// A clock whose tick is a step.
pub(crate) struct Clock {
    /// Cycles of a step.
    period: u32,
}

impl Clock {
    /// Starts to count steps of so many cycles, at most 2²⁴.
    pub(crate) fn start(mut timer: SYST, period: u32) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(period - 1);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
        Self { period }
    }

    /// Steps since the start. Sleeps until there is another one than `last`.
    #[allow(clippy::unused_self, reason = "only a clock that was started counts")]
    pub(crate) fn wait(&self, last: u32) -> u32 {
        loop {
            let steps = STEPS.load(Ordering::Relaxed);
            if steps != last {
                return steps;
            }
            cortex_m::asm::wfi();
        }
    }

    /// Cycles since the start, of which 32 bits are kept.
    pub(crate) fn cycles(&self) -> u32 {
        loop {
            let steps = STEPS.load(Ordering::Relaxed);
            let left = SYST::get_current();
            if steps == STEPS.load(Ordering::Relaxed) {
                // a step begins where the counter is zero, a cycle before it starts anew
                let gone = if left == 0 { 0 } else { self.period - left };
                return steps.wrapping_mul(self.period).wrapping_add(gone);
            }
        }
    }
}
