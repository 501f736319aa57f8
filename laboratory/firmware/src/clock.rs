//! A clock that counts instructions: in QEMU with `-icount shift=0` an instruction takes a nanosecond of the emulated time that `SysTick` reads.

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// The length of the loop that sets the clock: `delay` executes two instructions for every two cycles that it is asked for.
const LOOP: u32 = 10_000_000;

/// A clock that counts instructions.
#[allow(missing_debug_implementations, reason = "the timer has none")]
pub struct Clock {
    timer: SYST,
    /// Instructions in a million ticks.
    scale: u64,
}

impl Clock {
    /// A clock that is set by a loop of known length.
    pub fn new(mut timer: SYST) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(0x00ff_ffff);
        timer.clear_current();
        timer.enable_counter();
        let mut clock = Self { timer, scale: 0 };
        let start = clock.ticks(|| cortex_m::asm::delay(0));
        let ticks = clock.ticks(|| cortex_m::asm::delay(LOOP)) - start;
        clock.scale = u64::from(LOOP) * 1_000_000 / u64::from(ticks);
        clock
    }

    /// What `work` executes.
    pub fn instructions(&mut self, work: impl FnOnce()) -> u64 {
        u64::from(self.ticks(work)) * self.scale / 1_000_000
    }

    /// How long `work` takes: up to 2²⁴ ticks.
    fn ticks(&mut self, work: impl FnOnce()) -> u32 {
        self.timer.clear_current();
        let start = SYST::get_current();
        work();
        assert!(!self.timer.has_wrapped(), "too long for the timer");
        start.wrapping_sub(SYST::get_current()) & 0x00ff_ffff
    }
}
