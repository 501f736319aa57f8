//! A clock that counts instructions: in QEMU with `-icount shift=0` an instruction takes a nanosecond of the emulated time that `SysTick` reads.
//!
//! It is configured by the timer's frequency only, and contains no calibrated loop. The tests compare it with an independent counter.

use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;

/// Nanoseconds in a second.
const SECOND: u32 = 1_000_000_000;

/// A clock that counts instructions.
#[allow(missing_debug_implementations, reason = "the timer has none")]
pub struct Clock {
    timer: SYST,
    /// Ticks in a second.
    frequency: u32,
}

impl Clock {
    /// Counted ticks in a second. On a chip, ticks are cycles of the processor.
    pub const CYCLES: u32 = SECOND;

    /// A clock whose timer ticks with this frequency, Hz.
    pub fn new(mut timer: SYST, frequency: u32) -> Self {
        timer.set_clock_source(SystClkSource::Core);
        timer.set_reload(0x00ff_ffff);
        timer.clear_current();
        timer.enable_counter();
        Self { timer, frequency }
    }

    /// The number of instructions that `work` executes.
    pub fn instructions(&mut self, work: impl FnOnce()) -> u64 {
        mark();
        let ticks = self.ticks(work);
        mark();
        u64::from(ticks) * u64::from(SECOND) / u64::from(self.frequency)
    }

    /// The ticks that `work` takes: up to 2²⁴.
    fn ticks(&mut self, work: impl FnOnce()) -> u32 {
        self.timer.clear_current();
        let start = SYST::get_current();
        work();
        assert!(!self.timer.has_wrapped(), "too long for the timer");
        start.wrapping_sub(SYST::get_current()) & 0x00ff_ffff
    }
}

/// The second counter reads its count here, before and after each counted part.
#[inline(never)]
extern "C" fn mark() {
    cortex_m::asm::nop();
}
