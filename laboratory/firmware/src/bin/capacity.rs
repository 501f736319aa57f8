//! The largest sheets that a board of 64 KB moves and draws: 32 × 32 particles by XPBD and 24 × 24 by the line solver, in fixed point, lit and shaded in 16 greys
//! on 128 × 64 pixels. Prints a line `sheet; bytes of its variables; bytes of stack; bytes of RAM; grey pixels of the last picture`. `KERCHIEF_SCENE` selects `xpbd` or `lines`.
//!
//! ```sh
//! cd laboratory/firmware
//! KERCHIEF_SCENE=xpbd cargo run --release --features graphics --bin capacity
//! ```
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in laboratory/firmware, whose .cargo/config.toml names the target");

use cortex_m_semihosting::{debug, hprintln};
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::pixelcolor::raw::{BigEndian, RawU4};
use embedded_graphics::pixelcolor::{Gray4, Rgb888};
use embedded_graphics::prelude::*;
use kerchief::render::{Camera, Light, Look, Shaded, View};
use kerchief::solver::Stateless;
use kerchief::{Cloth, Gravity, Lines, Node, Q24, Scene, Shear, Solver, Stretch, Units, Xpbd};
use panic_semihosting as _;
use static_cell::ConstStaticCell;

const SCREEN: Size = Size::new(128, 64);
const FRAMES: u32 = 30;

type Picture = Framebuffer<Gray4, RawU4, BigEndian, 128, 64, { buffer_size::<Gray4>(128, 64) }>;

/// A sheet of 1 m × 1 m with N × N particles.
const fn units<const N: usize>(substeps: u32) -> Units {
    Units::sheet([N, N], [1.0, 1.0], 1e-3, 1.0 / 60.0, substeps)
}

/// Light grey cloth under a lamp.
const fn look() -> Look<Rgb888, Rgb888> {
    Look::new(Light::new(-40.0, 50.0), Rgb888::new(230, 230, 230))
}

/// The word with which `cortex-m-rt` fills the stack before the program starts.
const PAINT: u32 = 0xcccc_cccc;

/// The largest number of bytes of stack that were in use at any time, and the stack's size.
#[allow(unsafe_code, reason = "the linker knows where the stack is")]
fn stack() -> [usize; 2] {
    unsafe extern "C" {
        static _stack_start: u32;
        static _stack_end: u32;
    }
    let [start, end] = [&raw const _stack_start, &raw const _stack_end].map(|symbol| symbol as usize);
    // SAFETY: the words between both symbols are RAM
    let word = |address: usize| unsafe { (address as *const u32).read_volatile() };
    let unused = (end..start).step_by(size_of::<u32>()).take_while(|address| word(*address) == PAINT).count();
    [start - end - unused * size_of::<u32>(), start - end]
}

/// The links of every sheet.
type Springs = (Stretch<Q24>, Shear<Q24>);

/// Plays a sheet in static memory of its own.
macro_rules! play {
    ($name:literal: $side:literal, $substeps:literal, $kind:ty, $solver:expr, $memory:expr) => {{
        const UNITS: Units = units::<$side>($substeps);
        const VIEW: View =
            View::new(20.0, 10.0).fit(UNITS.point([0.0, 0.0, 0.0]), UNITS.point([1.0, 0.1, 1.0]), SCREEN);
        // constructed in place: a value that is moved into a static would be on the stack first
        static CLOTH: ConstStaticCell<Cloth<Q24, $side, $side>> = ConstStaticCell::new(Cloth::BLANK);
        static MEMORY: ConstStaticCell<<$kind as Solver<Q24>>::Memory<Springs, $side, $side>> =
            ConstStaticCell::new($memory);
        static SHADED: ConstStaticCell<Shaded<Look<Rgb888, Rgb888>, $side, $side>> =
            ConstStaticCell::new(Shaded::new(look()));
        static PICTURE: ConstStaticCell<Picture> = ConstStaticCell::new(Picture::new());
        let gravity = Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81]));
        let links = (Stretch::new(&UNITS, UNITS.stiffness(100.0)), Shear::new(&UNITS, UNITS.stiffness(1.0)));
        let scene = Scene::new(&UNITS, gravity, links, (), $solver);
        let (cloth, memory) = (CLOTH.take(), MEMORY.take());
        cloth.hang_here(&UNITS, UNITS.point([0.0, 0.0, 1.0]));
        cloth.pin(Node::new(0, 0));
        cloth.pin(Node::new($side - 1, 0));
        let (shaded, picture) = (SHADED.take(), PICTURE.take());
        let camera = Camera::new(&VIEW, SCREEN);
        for _ in 0..FRAMES {
            scene.step(cloth, memory);
            let Ok(()) = picture.clear(Gray4::BLACK);
            let Ok(()) = shaded.draw(cloth, &camera, picture);
        }
        let lit = picture.data().iter().filter(|byte| **byte != 0).count();
        let [used, there] = stack();
        let bytes = size_of_val(cloth) + size_of_val(memory) + size_of_val(shaded) + size_of_val(picture);
        hprintln!("{0} × {0} by {1}; {2}; {3}; {4}; {5}", $side, $name, bytes, used, bytes + there, 2 * lit);
    }};
}

#[cortex_m_rt::entry]
fn main() -> ! {
    if let Some("lines") = option_env!("KERCHIEF_SCENE") {
        play!("the line solver": 24, 1, Lines, Lines::with_sweeps(1), <Lines as Solver<Q24>>::Memory::<Springs, 24, 24>::BLANK);
    } else {
        play!("XPBD": 32, 8, Xpbd, Xpbd, Stateless::new());
    }
    hprintln!("end");
    debug::exit(debug::EXIT_SUCCESS);
    loop {
        cortex_m::asm::wfi();
    }
}
