//! Plays the scenes of the digests on a board, in every number type by every solver, and prints the digest after every frame. Sheets move
//! identically, to the last bit, on every machine: the tests `boards` of the emulator compare the digests.
//!
//! ```sh
//! cd laboratory/firmware
//! cargo run --profile small --bin digests
//! ```
#![cfg_attr(target_os = "none", no_std, no_main)]

use core::fmt::Write;

use cases::{CASES, METHODS, NUMBERS};
use heapless::String;

/// Prints a line `scene solver number digest …` for each run.
fn print(mut line: impl FnMut(&str)) {
    for case in &CASES {
        for method in METHODS {
            for number in NUMBERS {
                let mut text = String::<256>::new();
                let mut complete = write!(text, "{} {method:?} {}", case.name, number.name).is_ok();
                let outcome =
                    (number.play)(case, method, &mut |digest| complete &= write!(text, " {digest:08x}").is_ok());
                assert!(complete && outcome.finite, "{text}");
                line(&text);
            }
        }
    }
    line("end");
}

#[cfg(target_os = "none")]
mod board {
    use cortex_m_semihosting::{debug, hprintln};
    use panic_semihosting as _;

    #[cortex_m_rt::entry]
    fn main() -> ! {
        super::print(|line| hprintln!("{}", line));
        debug::exit(debug::EXIT_SUCCESS);
        loop {
            cortex_m::asm::wfi();
        }
    }
}

#[cfg(not(target_os = "none"))]
fn main() {
    print(|line| println!("{line}"));
}
