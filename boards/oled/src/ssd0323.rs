//! The SSD0323, a controller of OLEDs in 16 greys, by `embedded-hal`: two pixels a byte, the left one in the upper half.

use core::convert::Infallible;

use embedded_graphics::geometry::Point;
use embedded_graphics::primitives::Rectangle;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiDevice;

use oled::picture::ROW;
use oled::show::SCREEN;

/// The commands after a reset, with their parameters.
const START: [&[u8]; 17] = [
    &[0xae],                                              // off
    &[0x81, 50],                                          // contrast
    &[0x85],                                              // half of the full current
    &[0xa0, 0x41], // columns from the left, upper half of a byte first, rows of two chips interleaved
    &[0xa1, 0],    // first row
    &[0xa2, 0],    // no offset
    &[0xa4],       // neither all on nor inverted
    &[0xa8, 63],   // 64 rows
    &[0xb1, 0x22], // phases of a row
    &[0xb2, 70],   // cycles of a row
    &[0xb3, 0xf1], // clock: its fastest, divided by 2
    &[0xbf, 0x0d], // low voltage of columns
    &[0xbe, 0x02], // high voltage of rows
    &[0xbc, 0x3f], // voltage before a row
    &[0xb8, 1, 0x11, 0x22, 0x32, 0x43, 0x54, 0x65, 0x76], // greys
    &[0xad, 0x03], // converter
    &[0xaf],       // on
];

/// A display of 128 × 64 pixels.
pub(crate) struct Ssd0323<S, P> {
    spi: S,
    /// Low for commands, high for pixels.
    data: P,
}

impl<S: SpiDevice, P: OutputPin<Error = Infallible>> Ssd0323<S, P> {
    /// Starts the display.
    pub(crate) fn new(spi: S, data: P) -> Result<Self, S::Error> {
        let mut display = Self { spi, data };
        for command in START {
            display.command(command)?;
        }
        Ok(display)
    }

    /// Sends an area of a picture in the display's format, in whole bytes.
    pub(crate) fn send(&mut self, picture: &[u8], area: &Rectangle) -> Result<(), S::Error> {
        let area = area.intersection(&Rectangle::new(Point::zero(), SCREEN));
        let Some(end) = area.bottom_right() else { return Ok(()) };
        let [left, right] = [area.top_left.x, end.x].map(|x| (x / 2) as u8);
        let [top, bottom] = [area.top_left.y, end.y].map(|y| y as u8);
        self.command(&[0x15, left, right])?;
        self.command(&[0x75, top, bottom])?;
        let Ok(()) = self.data.set_high();
        for row in picture.chunks_exact(ROW).take(usize::from(bottom) + 1).skip(usize::from(top)) {
            let part = row.get(usize::from(left)..=usize::from(right)).unwrap_or_default();
            self.spi.write(part)?;
        }
        Ok(())
    }

    fn command(&mut self, bytes: &[u8]) -> Result<(), S::Error> {
        let Ok(()) = self.data.set_low();
        self.spi.write(bytes)
    }
}
