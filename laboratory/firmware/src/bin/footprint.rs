//! A program that moves a sheet and does nothing else. Its flash is the flash that a scene takes; its functions are the functions that a scene
//! needs. `KERCHIEF_NUMBER` and `KERCHIEF_SCENE` in the environment of the build select one of the scenes of [`cases::bench`].
//!
//! ```sh
//! cd laboratory/firmware
//! KERCHIEF_NUMBER=q24 KERCHIEF_SCENE=xpbd cargo build --release --target thumbv6m-none-eabi --bin footprint
//! ```
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in laboratory/firmware, whose .cargo/config.toml names the target");

use core::hint::black_box;
use core::panic::PanicInfo;

use cases::bench::{self, Bench, SIDE};
use kerchief::force::Force;
use kerchief::{Cloth, Collider, Links, Scalar, Scene, Solver};

struct Forever;

impl Bench for Forever {
    const NUMBER: Option<&'static str> = Some(env!("KERCHIEF_NUMBER"));
    const SCENE: Option<&'static str> = Some(env!("KERCHIEF_SCENE"));

    fn scene<S, F, L, C, V>(&mut self, _name: &str, scene: &Scene<F, L, C, V>, mut cloth: Cloth<S, SIDE, SIDE>)
    where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>,
    {
        let mut memory = scene.memory();
        loop {
            frame(black_box(scene), black_box(&mut cloth), &mut memory);
        }
    }
}

/// A separate function, so that a test can tell the calls of a step from the calls of the setup.
#[inline(never)]
fn frame<S, F, L, C, V>(
    scene: &Scene<F, L, C, V>,
    cloth: &mut Cloth<S, SIDE, SIDE>,
    memory: &mut V::Memory<L, SIDE, SIDE>,
) where
    S: Scalar,
    F: Force<S>,
    L: Links<S>,
    C: Collider<S>,
    V: Solver<S>,
{
    scene.step_one(cloth, memory);
}

#[cortex_m_rt::entry]
fn main() -> ! {
    bench::play_all(&mut Forever);
    loop {
        cortex_m::asm::wfi();
    }
}

/// A `no_std` program must have this function. A test asserts that no step in fixed point reaches a panic.
#[panic_handler]
fn panic(_: &PanicInfo<'_>) -> ! {
    loop {}
}
