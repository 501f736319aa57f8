//! The serial port, for output. (The HAL would wait for a clock that the emulator lacks. So the chip keeps the 16 MHz that it starts with.)

use core::fmt;

use stm32f4::stm32f405::{GPIOA, RCC, USART1};

/// Cycles of a bit: 16 MHz at 115 200 baud.
const BIT: u16 = 139;

/// `USART1` on PA9.
pub(crate) struct Serial(USART1);

impl Serial {
    pub(crate) fn new(clocks: &RCC, port: &GPIOA, usart: USART1) -> Self {
        clocks.ahb1enr().modify(|_, w| w.gpioaen().set_bit());
        clocks.apb2enr().modify(|_, w| w.usart1en().set_bit());
        port.moder().modify(|_, w| w.moder9().alternate());
        port.afrh().modify(|_, w| w.afrh9().af7());
        usart.brr().write(|w| w.div_mantissa().set(BIT >> 4).div_fraction().set((BIT & 15) as u8));
        usart.cr1().write(|w| w.ue().set_bit().te().set_bit());
        Self(usart)
    }
}

impl fmt::Write for Serial {
    fn write_str(&mut self, text: &str) -> fmt::Result {
        for byte in text.bytes() {
            while self.0.sr().read().txe().bit_is_clear() {}
            self.0.dr().write(|w| w.dr().set(byte.into()));
        }
        Ok(())
    }
}
