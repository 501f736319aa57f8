//! The LM3S6965 evaluation board, as far as the OLED and the joystick need it. No maintained crate supports this chip, so registers are written by address.

use core::convert::Infallible;

use embedded_hal::digital::{ErrorType as PinErrorType, OutputPin};
use embedded_hal::spi::{ErrorType, SpiBus};

use oled::show::Stick;

/// Cycles in a second.
pub(crate) const FREQUENCY: u32 = 50_000_000;

const SYSTEM: u32 = 0x400f_e000;
const SSI: u32 = 0x4000_8000;
const PORT_A: u32 = 0x4000_4000;
const PORT_C: u32 = 0x4000_6000;
const PORT_D: u32 = 0x4000_7000;
const PORT_E: u32 = 0x4002_4000;

/// The registers. They are the same on every chip of this kind. Reading or writing one of them does not affect Rust's memory.
#[allow(unsafe_code, reason = "a register is a number that is made an address")]
mod register {
    pub(super) fn read(address: u32) -> u32 {
        // SAFETY: every caller names a register of the chip.
        unsafe { (address as *const u32).read_volatile() }
    }

    pub(super) fn write(address: u32, value: u32) {
        // SAFETY: as above.
        unsafe { (address as *mut u32).write_volatile(value) }
    }
}

use register::{read, write};

/// The parts of the board.
pub(crate) struct Board {
    pub(crate) spi: Ssi,
    pub(crate) select: Pin,
    pub(crate) data: Pin,
    pub(crate) joystick: Joystick,
}

impl Board {
    /// Starts the clock and the pins.
    pub(crate) fn start() -> Self {
        // the crystal of 8 MHz and the phase-locked loop of 400 MHz, divided by 2 and 4; it becomes the clock once it has settled
        const LOOP: u32 = 0x0380 | 3 << 23 | 1 << 22;
        write(SYSTEM + 0x060, LOOP | 1 << 11);
        while read(SYSTEM + 0x050) & 1 << 6 == 0 {}
        write(SYSTEM + 0x060, LOOP);
        // enable SSI0 and ports A, C, D, E
        write(SYSTEM + 0x104, 1 << 4);
        write(SYSTEM + 0x108, 0b1_1101);
        cortex_m::asm::delay(3);
        // clock and data belong to the interface; its frame signal is unused, because it would end with every byte
        write(PORT_A + 0x420, 1 << 2 | 1 << 5);
        write(PORT_A + 0x51c, 1 << 2 | 1 << 5);
        let select = Pin::output(PORT_A, 3);
        let data = Pin::output(PORT_C, 7);
        // high: low, this pin would select the memory card
        Pin::output(PORT_D, 0).write(true);
        Self { spi: Ssi::start(), select, data, joystick: Joystick::start() }
    }
}

/// An output pin.
pub(crate) struct Pin {
    port: u32,
    mask: u32,
}

impl Pin {
    fn output(port: u32, pin: u32) -> Self {
        let mask = 1 << pin;
        for register in [0x400, 0x51c] {
            write(port + register, read(port + register) | mask);
        }
        Self { port, mask }
    }

    /// The address contains a mask of the pins that are written.
    fn write(&mut self, high: bool) {
        write(self.port + (self.mask << 2), if high { self.mask } else { 0 });
    }
}

impl PinErrorType for Pin {
    type Error = Infallible;
}

impl OutputPin for Pin {
    fn set_low(&mut self) -> Result<(), Infallible> {
        self.write(false);
        Ok(())
    }

    fn set_high(&mut self) -> Result<(), Infallible> {
        self.write(true);
        Ok(())
    }
}

/// The synchronous interface SSI0, a PL022.
pub(crate) struct Ssi(());

const DATA: u32 = SSI + 0x08;
const STATUS: u32 = SSI + 0x0c;
const NOT_FULL: u32 = 1 << 1;
const RECEIVED: u32 = 1 << 2;
const BUSY: u32 = 1 << 4;

impl Ssi {
    /// Starts it with 8 bits, a clock that is high when idle, and 50 MHz/14: the display takes up to 4 MHz.
    fn start() -> Self {
        write(SSI + 0x10, 14);
        write(SSI, 1 << 6 | 7);
        write(SSI + 0x04, 1 << 1);
        Self(())
    }
}

impl ErrorType for Ssi {
    type Error = Infallible;
}

impl SpiBus for Ssi {
    fn read(&mut self, words: &mut [u8]) -> Result<(), Infallible> {
        self.transfer_in_place(words)
    }

    fn write(&mut self, words: &[u8]) -> Result<(), Infallible> {
        for word in words {
            while read(STATUS) & NOT_FULL == 0 {}
            write(DATA, u32::from(*word));
            // received bytes would fill the receiver, and stop the sender
            if read(STATUS) & RECEIVED != 0 {
                read(DATA);
            }
        }
        Ok(())
    }

    fn transfer(&mut self, answer: &mut [u8], words: &[u8]) -> Result<(), Infallible> {
        let length = answer.len().min(words.len());
        answer[..length].copy_from_slice(&words[..length]);
        self.transfer_in_place(&mut answer[..length])?;
        self.write(&words[length..])
    }

    fn transfer_in_place(&mut self, words: &mut [u8]) -> Result<(), Infallible> {
        self.flush()?;
        for word in words {
            write(DATA, u32::from(*word));
            while read(STATUS) & RECEIVED == 0 {}
            *word = read(DATA) as u8;
        }
        Ok(())
    }

    fn flush(&mut self) -> Result<(), Infallible> {
        while read(STATUS) & BUSY != 0 {}
        while read(STATUS) & RECEIVED != 0 {
            read(DATA);
        }
        Ok(())
    }
}

/// The joystick's four directions, low while pressed.
pub(crate) struct Joystick {
    /// Directions that were seen released once. One that is low from the start is pressed by accident or not connected.
    seen: u32,
}

const UP: u32 = 1 << 0;
const DOWN: u32 = 1 << 1;
const LEFT: u32 = 1 << 2;
const RIGHT: u32 = 1 << 3;

impl Joystick {
    fn start() -> Self {
        const ALL: u32 = UP | DOWN | LEFT | RIGHT;
        for register in [0x510, 0x51c] {
            write(PORT_E + register, ALL);
        }
        Self { seen: 0 }
    }

    /// The direction in which it is pressed.
    pub(crate) fn read(&mut self) -> Stick {
        let released = read(PORT_E + ((UP | DOWN | LEFT | RIGHT) << 2));
        self.seen |= released;
        let held = |direction: u32| i32::from(self.seen & !released & direction != 0);
        Stick { right: held(RIGHT) - held(LEFT), away: held(UP) - held(DOWN) }
    }
}
