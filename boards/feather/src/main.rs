//! Floating point on the FPU against fixed point, on a board with an STM32F405 (Adafruit Feather STM32F405 Express, boards of `WeAct` and similar ones). The board prints the
//! table on the serial port.
//!
//! | serial adapter, 3.3 V | STM32F405 |
//! |---|---|
//! | RX | PA9 (`USART1_TX`) |
//! | GND | GND |
//!
//! 115 200 baud, 8 bits, no parity.
//!
//! ```sh
//! cargo emulate feather                              # in QEMU
//! cd boards/feather && cargo run --release           # in QEMU too, as .cargo/config.toml says; there you name your probe
//! ```
//!
//! `SysTick` counts executed instructions in QEMU, and cycles of 16 MHz on a board. Don't compare one with the other: an instruction takes a cycle or more.
#![no_std]
#![no_main]

#[cfg(not(target_os = "none"))]
compile_error!("firmware runs on a board: run cargo in boards/feather, whose .cargo/config.toml names the target");

mod serial;

use core::fmt::Write;
use core::hint::black_box;

use feather::clock::Clock;
use feather::race::{self, FRAMES, Judge, Result, SIDE};
use panic_semihosting as _;
use serial::Serial;
use stm32f4::stm32f405::Peripherals;

/// The frequency of `SysTick` in QEMU, Hz.
const EMULATED: u32 = 168_000_000;

struct Table {
    clock: Clock,
    serial: Serial,
}

impl Judge for Table {
    fn frame(&mut self, frame: impl FnOnce()) -> u64 {
        self.clock.instructions(|| black_box(frame)())
    }

    fn result(&mut self, Result { number, solver, cost, strain, digest }: Result) {
        let [whole, part] = [strain / 100, strain % 100];
        let Ok(()) =
            writeln!(self.serial, "| {number:6} | {solver:17} | {cost:12} | {whole:3}.{part:02} % | {digest:08x} |\r")
        else {
            return;
        };
    }
}

#[cortex_m_rt::entry]
fn main() -> ! {
    if let (Some(core), Some(chip)) = (cortex_m::Peripherals::take(), Peripherals::take()) {
        let mut serial = Serial::new(&chip.RCC, &chip.GPIOA, chip.USART1);
        let _ = write!(serial, "A sheet of {SIDE} x {SIDE} swings down from two corners in {FRAMES} frames.\r\n\r\n");
        let _ = write!(serial, "| number | solver            | a frame      | strain   | digest   |\r\n");
        let _ = write!(serial, "|--------|-------------------|-------------:|---------:|----------|\r\n");
        // a chip reports that its oscillator is ready, QEMU never does
        let frequency = if chip.RCC.cr().read().hsirdy().bit() { Clock::CYCLES } else { EMULATED };
        let mut table = Table { clock: Clock::new(core.SYST, frequency), serial };
        race::race(&mut table);
        let _ = write!(table.serial, "\r\nend\r\n");
    }
    loop {
        cortex_m::asm::wfi();
    }
}
