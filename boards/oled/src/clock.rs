//! The processor's timer `SysTick`: it counts steps, and cycles within a step.

use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_rt::exception;

/// Steps since the start.
static STEPS: AtomicU32 = AtomicU32::new(0);

#[exception]
fn SysTick() {
    // load and store, as a Cortex-M0 has no atomic addition: nothing else writes
    STEPS.store(STEPS.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
}

/// A clock whose tick is a step.
pub(crate) struct Clock {
    /// Cycles of a step.
    period: u32,
}

impl Clock {
    /// Starts counting steps of `period` cycles, at most 2²⁴.
    pub(crate) fn start(mut timer: SYST, period: u32) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(period - 1);
        timer.clear_current();
        timer.enable_interrupt();
        timer.enable_counter();
        Self { period }
    }

    /// Sleeps until the number of steps since the start differs from `last`. Returns that number.
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

    /// Cycles since the start, modulo 2³².
    pub(crate) fn cycles(&self) -> u32 {
        loop {
            let steps = STEPS.load(Ordering::Relaxed);
            let left = SYST::get_current();
            if steps == STEPS.load(Ordering::Relaxed) {
                // a step begins when the counter reaches zero, a cycle before it is reloaded
                let gone = if left == 0 { 0 } else { self.period - left };
                return steps.wrapping_mul(self.period).wrapping_add(gone);
            }
        }
    }
}
