//! Counts the instructions that a board executes for a frame of each scene of `bench`, and prints a line `number; scene; instructions of a frame;
//! bytes of the cloth; bytes of the solver's memory; digest`.
//!
//! It counts in QEMU: with `-icount shift=0` an instruction takes a nanosecond of the emulated time that `SysTick` reads.
//!
//! ```sh
//! cargo --config boards/lm3s6965.toml run --profile board --features semihosting --target thumbv6m-none-eabi --example instructions
//! ```
//!
//! `KERCHIEF_NUMBER` and `KERCHIEF_SCENE` in the environment of the build leave one number type or one scene: a small flash doesn't hold all.
//! `UPDATE_INSTRUCTIONS=1 cargo test --test boards` makes `docs/instructions.md` of it.
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("this example is firmware: give a target");

mod bench;

use core::hint::black_box;

use bench::{Bench, SIDE, WARM_UP, counted};
use cortex_m::peripheral::SYST;
use cortex_m::peripheral::syst::SystClkSource;
use cortex_m_semihosting::{debug, hprintln};
use kerchief::force::Force;
use kerchief::{Cloth, Collider, Links, Scalar, Scene, Solver, measure};
use panic_semihosting as _;

/// The length of the loop that sets the clock: `delay` executes two instructions for every two cycles that it is asked for.
const LOOP: u32 = 10_000_000;

/// A clock that counts instructions.
struct Clock {
    timer: SYST,
    /// Instructions in a million ticks.
    scale: u64,
}

impl Clock {
    /// A clock that is set by a loop of known length.
    fn new(mut timer: SYST) -> Self {
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

    /// How long `work` takes: up to 2²⁴ ticks.
    fn ticks(&mut self, work: impl FnOnce()) -> u32 {
        self.timer.clear_current();
        let start = SYST::get_current();
        work();
        assert!(!self.timer.has_wrapped(), "too long for the timer");
        start.wrapping_sub(SYST::get_current()) & 0x00ff_ffff
    }
}

impl Bench for Clock {
    const NUMBER: Option<&'static str> = option_env!("KERCHIEF_NUMBER");
    const SCENE: Option<&'static str> = option_env!("KERCHIEF_SCENE");

    fn scene<S, F, L, C, V>(&mut self, name: &'static str, scene: &Scene<F, L, C, V>, mut cloth: Cloth<S, SIDE, SIDE>)
    where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>,
    {
        // numbers that are known at run time only, as those of a board that is tilted
        let scene = black_box(scene);
        let mut memory = scene.memory();
        for _ in 0..WARM_UP {
            scene.step(&mut cloth, &mut memory);
        }
        let frames = counted(name);
        let ticks = (0..frames).map(|_| u64::from(self.ticks(|| scene.step(&mut cloth, &mut memory)))).sum::<u64>();
        hprintln!(
            "{}; {}; {}; {}; {}; {:08x}",
            S::NAME,
            name,
            ticks * self.scale / (1_000_000 * u64::from(frames)),
            size_of_val(&cloth),
            size_of_val(&memory),
            measure::digest(&cloth)
        );
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    if let Some(peripherals) = cortex_m::Peripherals::take() {
        let mut clock = Clock::new(peripherals.SYST);
        bench::play_all(&mut clock);
        hprintln!("end");
    }
    debug::exit(debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}
