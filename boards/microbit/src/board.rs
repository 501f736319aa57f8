//! The micro:bit's pins and clock.

use microbit::leds::PINS;
use nrf51_pac::{GPIO, Peripherals, TIMER0};

/// Buttons A and B, low while pressed.
const BUTTONS: [u32; 2] = [17, 26];

/// The parts of the board.
pub(crate) struct Board {
    port: GPIO,
    timer: TIMER0,
}

#[allow(unsafe_code, reason = "numbers for registers of 32 bits, all of which are allowed")]
impl Board {
    /// Starts the clock and the pins.
    pub(crate) fn start() -> Option<Self> {
        let chip = Peripherals::take()?;
        let (port, timer) = (chip.GPIO, chip.TIMER0);
        port.dirset.write(|w| unsafe { w.bits(PINS) });
        // 16 MHz divided by 2⁴, 32 bits
        timer.prescaler.write(|w| unsafe { w.bits(4) });
        timer.bitmode.write(|w| unsafe { w.bits(3) });
        timer.tasks_start.write(|w| unsafe { w.bits(1) });
        Some(Self { port, timer })
    }

    /// Microseconds since the start, modulo 2³².
    pub(crate) fn micros(&self) -> u32 {
        self.timer.tasks_capture[0].write(|w| unsafe { w.bits(1) });
        self.timer.cc[0].read().bits()
    }

    /// Sets all pins.
    pub(crate) fn write(&self, pins: u32) {
        self.port.out.write(|w| unsafe { w.bits(pins) });
    }

    /// Whether each button is pressed.
    pub(crate) fn buttons(&self) -> [bool; 2] {
        let pins = self.port.in_.read().bits();
        BUTTONS.map(|pin| pins >> pin & 1 == 0)
    }
}
