//! Plays one scene, a stiff sheet that falls from two corners, by several solvers in many settings, and prints for each a line `solver number substeps sweeps
//! [tolerance]; instructions of a frame; digest`. The study `board_precision` compares these costs with errors.
//!
//! Counts are those of QEMU with `-icount shift=0`. `KERCHIEF_NUMBER` in the environment of the build selects one number type.
//!
//! ```sh
//! cd laboratory/firmware
//! KERCHIEF_NUMBER=q24 cargo run --release --bin precision
//! ```
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in laboratory/firmware, whose .cargo/config.toml names the target");

use cortex_m_semihosting::{debug, hprintln};
use firmware::FREQUENCY;
use firmware::clock::Clock;
use kerchief::{
    Bend, Cloth, Drag, Gravity, Leapfrog, Lines, Node, Q13, Q24, Scalar, Scene, Shear, Solver, Stretch, Units, Verlet,
    Xpbd, measure,
};
use panic_semihosting as _;

const SIDE: usize = 16;
const FRAMES: u64 = 20;

/// Plays the scene `two-corners-16` of the laboratory, and prints the mean of all frames.
fn play<S: Scalar, V: Solver<S>>(clock: &mut Clock, units: &Units, name: &str, settings: &str, solver: V) {
    let mut cloth = Cloth::<S, SIDE, SIDE>::lay(units, units.point([-5.0, -5.0, 0.0]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(SIDE - 1, 0));
    let gravity = Gravity::new(units.acceleration([0.0, 0.0, -9.81]));
    let drag = Drag::new(units.verlet_damping(0.1));
    let links = (
        Stretch::new(units, units.stiffness(942_700.0)),
        Shear::new(units, units.stiffness(9_427.0)),
        Bend::new(units, units.stiffness(942.7)),
    );
    let scene = Scene::new(units, (gravity, drag), links, (), solver);
    let mut memory = scene.memory();
    let counted = (0..FRAMES).map(|_| clock.instructions(|| scene.step(&mut cloth, &mut memory))).sum::<u64>();
    hprintln!("{} {} {}; {}; {:08x}", name, S::NAME, settings, counted / FRAMES, measure::digest(&cloth));
}

/// Plays each setting. The compiler evaluates its units, so that the program contains none of their floats.
macro_rules! settings {
    ($clock:ident, $S:ty, $($name:literal $substeps:literal $rest:literal $solver:expr;)*) => {
        $({
            const UNITS: Units = Units::sheet([SIDE, SIDE], [10.0, 10.0], 1.0, 0.1, $substeps);
            play::<$S, _>($clock, &UNITS, $name, concat!(stringify!($substeps), " ", $rest), $solver);
        })*
    };
}

fn lines(sweeps: u32, tolerance: f64) -> Lines {
    Lines::with_sweeps(sweeps).within(tolerance)
}

fn play_all<S: Scalar>(clock: &mut Clock) {
    settings! { clock, S,
        "verlet" 1 "4" Verlet { sweeps: 4 };
        "verlet" 2 "4" Verlet { sweeps: 4 };
        "verlet" 4 "4" Verlet { sweeps: 4 };
        "verlet" 8 "4" Verlet { sweeps: 4 };
        "verlet" 16 "4" Verlet { sweeps: 4 };
        "xpbd" 2 "1" Xpbd;
        "xpbd" 4 "1" Xpbd;
        "xpbd" 8 "1" Xpbd;
        "xpbd" 16 "1" Xpbd;
        "xpbd" 32 "1" Xpbd;
        "xpbd" 64 "1" Xpbd;
        "leapfrog" 128 "1" Leapfrog;
        "lines" 2 "1 0.1" lines(1, 0.1);
        "lines" 4 "1 0.1" lines(1, 0.1);
        "lines" 6 "1 0.1" lines(1, 0.1);
        "lines" 8 "1 0.1" lines(1, 0.1);
        "lines" 12 "1 0.1" lines(1, 0.1);
        "lines" 16 "1 0.1" lines(1, 0.1);
        "lines" 24 "1 0.1" lines(1, 0.1);
        "lines" 4 "2 0.02" lines(2, 0.02);
        "lines" 8 "2 0.02" lines(2, 0.02);
        "lines" 12 "2 0.02" lines(2, 0.02);
        "lines" 16 "2 0.02" lines(2, 0.02);
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    const NUMBER: Option<&str> = option_env!("KERCHIEF_NUMBER");
    let wanted = |name: &str| NUMBER.is_none_or(|number| number == name);
    if let Some(peripherals) = cortex_m::Peripherals::take() {
        let clock = &mut Clock::new(peripherals.SYST, FREQUENCY);
        if wanted(f32::NAME) {
            play_all::<f32>(clock);
        }
        if wanted(Q24::NAME) {
            play_all::<Q24>(clock);
        }
        if wanted(Q13::NAME) {
            play_all::<Q13>(clock);
        }
        hprintln!("end");
    }
    debug::exit(debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}
