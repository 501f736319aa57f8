//! Counts the instructions that a board executes for a frame of each scene of [`cases::bench`], and prints a line `number; scene; instructions of a frame;
//! bytes of the cloth; bytes of the solver's memory; digest`.
//!
//! Counts are those of QEMU with `-icount shift=0`.
//!
//! ```sh
//! cd laboratory/firmware
//! KERCHIEF_NUMBER=q24 cargo run --release --target thumbv6m-none-eabi --bin instructions
//! ```
//!
//! `KERCHIEF_NUMBER` and `KERCHIEF_SCENE` in the environment of the build select one number type or one scene: a small flash has no space for all.
//! `UPDATE_INSTRUCTIONS=1 cargo test -p emulator --test boards -- --ignored published` writes the counts to `docs/instructions.md`.
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in laboratory/firmware, whose .cargo/config.toml names the target");

use core::hint::black_box;

use cases::bench::{self, Bench, SIDE, WARM_UP, counted};
use cortex_m_semihosting::{debug, hprintln};
use firmware::FREQUENCY;
use firmware::clock::Clock;
use kerchief::force::Force;
use kerchief::{Cloth, Collider, Links, Scalar, Scene, Solver, measure};
use panic_semihosting as _;

/// Counts and prints each scene.
struct Counter(Clock);

impl Bench for Counter {
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
        // parameters that are known at run time only, like the gravity of a tilted board
        let scene = black_box(scene);
        let mut memory = scene.memory();
        for _ in 0..WARM_UP {
            scene.step_one(&mut cloth, &mut memory);
        }
        let frames = counted(name);
        // all frames in one measurement: a frame at rest takes not much more than a tick of the clock
        let instructions = self.0.instructions(|| (0..frames).for_each(|_| scene.step_one(&mut cloth, &mut memory)));
        hprintln!(
            "{}; {}; {}; {}; {}; {:08x}",
            S::NAME,
            name,
            instructions / u64::from(frames),
            size_of_val(&cloth),
            size_of_val(&memory),
            measure::digest(&cloth)
        );
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    if let Some(peripherals) = cortex_m::Peripherals::take() {
        bench::play_all(&mut Counter(Clock::new(peripherals.SYST, FREQUENCY)));
        hprintln!("end");
    }
    debug::exit(debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}
