//! The LCD: `mipidsi` starts it, pixels go to it in frames of 16 bits as they lie in the picture.

use core::convert::Infallible;

use embedded_graphics::primitives::Rectangle;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::{ErrorType, SpiBus};
use embedded_hal_nb::spi::FullDuplex;

use pico::picture::Picture;

/// A started display on a bus of 16 bits.
pub(crate) struct Lcd<S, C, D> {
    pub(crate) spi: S,
    /// Low while the display listens.
    pub(crate) select: C,
    /// Low for commands.
    pub(crate) data: D,
}

const COLUMNS: u16 = 0x2a;
const ROWS: u16 = 0x2b;
const PIXELS: u16 = 0x2c;

impl<S: SpiBus<u16> + FullDuplex<u16>, C: OutputPin<Error = Infallible>, D: OutputPin<Error = Infallible>>
    Lcd<S, C, D>
{
    /// Sends a part of a picture, and waits until it has gone.
    pub(crate) fn send(&mut self, picture: &Picture, area: &Rectangle) -> Result<(), <S as ErrorType>::Error> {
        let Some(end) = area.bottom_right() else { return Ok(()) };
        let Ok(()) = self.select.set_low();
        self.command(COLUMNS, &[area.top_left.x as u16, end.x as u16])?;
        self.command(ROWS, &[area.top_left.y as u16, end.y as u16])?;
        self.command(PIXELS, &[])?;
        for part in picture.parts(area) {
            for pixel in part {
                // nobody reads what comes back, so no frame waits for the one before
                while let Err(nb::Error::WouldBlock) = FullDuplex::write(&mut self.spi, *pixel) {}
            }
        }
        SpiBus::flush(&mut self.spi)?;
        let Ok(()) = self.select.set_high();
        Ok(())
    }

    /// A command is the lower half of a frame; the upper half is no operation.
    fn command(&mut self, command: u16, parameters: &[u16]) -> Result<(), <S as ErrorType>::Error> {
        SpiBus::flush(&mut self.spi)?;
        let Ok(()) = self.data.set_low();
        SpiBus::write(&mut self.spi, &[command])?;
        SpiBus::flush(&mut self.spi)?;
        let Ok(()) = self.data.set_high();
        SpiBus::write(&mut self.spi, parameters)
    }
}
