//! The LCD. `mipidsi` starts it; then DMA sends rows of the picture while the processor computes.

use core::convert::Infallible;

use embedded_dma::ReadBuffer;
use embedded_graphics::primitives::Rectangle;
use embedded_hal::digital::OutputPin;
use embedded_hal::spi::SpiBus;
use pico::picture::{Picture, Rows};
use pico::show::SCREEN;
use rp2040_hal::dma::single_buffer::{Config, Transfer};
use rp2040_hal::dma::{CH0, Channel};
use rp2040_hal::pac::SPI0;
use rp2040_hal::spi::{Enabled, Spi, ValidSpiPinout};

/// A bus of 16 bits.
type Bus<P> = Spi<Enabled, SPI0, P, 16>;

/// A started display.
pub(crate) struct Lcd<P: ValidSpiPinout<SPI0>, C, D> {
    link: Link<P>,
    /// Low while the display listens.
    select: C,
    /// Low for commands.
    data: D,
}

enum Link<P: ValidSpiPinout<SPI0>> {
    Idle(Channel<CH0>, Bus<P>),
    Busy(Transfer<Channel<CH0>, Part, Bus<P>>),
    /// Between one and the other.
    Changing,
}

/// Whole rows of a picture.
struct Part {
    rows: &'static mut Rows,
    first: usize,
    count: usize,
}

// SAFETY: the rows are static, this is their only reference, and nothing changes them while the transfer owns it.
#[allow(unsafe_code, reason = "an address for the DMA controller")]
unsafe impl ReadBuffer for Part {
    type Word = u16;

    unsafe fn read_buffer(&self) -> (*const u16, usize) {
        let rows = self.rows.get(self.first..self.first + self.count).unwrap_or_default().as_flattened();
        (rows.as_ptr(), rows.len())
    }
}

const COLUMNS: u16 = 0x2a;
const ROWS: u16 = 0x2b;
const PIXELS: u16 = 0x2c;

impl<P: ValidSpiPinout<SPI0>, C: OutputPin<Error = Infallible>, D: OutputPin<Error = Infallible>> Lcd<P, C, D> {
    /// A display that `mipidsi` has started.
    pub(crate) fn new(channel: Channel<CH0>, bus: Bus<P>, select: C, data: D) -> Self {
        Self { link: Link::Idle(channel, bus), select, data }
    }

    /// Starts sending the rows of a picture that an area touches. The picture's pixels are lent until they are sent.
    pub(crate) fn send(&mut self, picture: &Picture, area: &Rectangle) -> Result<(), Infallible> {
        self.finish(picture);
        let (Some(end), Some(rows)) = (area.bottom_right(), picture.lend()) else { return Ok(()) };
        let Link::Idle(channel, mut bus) = core::mem::replace(&mut self.link, Link::Changing) else { return Ok(()) };
        let Ok(()) = self.select.set_low();
        self.command(&mut bus, COLUMNS, &[0, SCREEN.width as u16 - 1])?;
        self.command(&mut bus, ROWS, &[area.top_left.y as u16, end.y as u16])?;
        self.command(&mut bus, PIXELS, &[])?;
        let part = Part { rows, first: area.top_left.y as usize, count: area.size.height as usize };
        self.link = Link::Busy(Config::new(channel, part, bus).start());
        Ok(())
    }

    /// Waits for the end of the transfer and gives the picture its pixels back. Returns whether there was a transfer.
    pub(crate) fn finish(&mut self, picture: &Picture) -> bool {
        match core::mem::replace(&mut self.link, Link::Changing) {
            Link::Busy(transfer) => {
                let (channel, part, mut bus) = transfer.wait();
                picture.give_back(part.rows);
                let Ok(()) = SpiBus::flush(&mut bus);
                let Ok(()) = self.select.set_high();
                self.link = Link::Idle(channel, bus);
                true
            }
            idle => {
                self.link = idle;
                false
            }
        }
    }

    /// Sends a command and its parameters. The command is the lower half of a frame of 16 bits; the upper half, zero, is no operation.
    fn command(&mut self, bus: &mut Bus<P>, command: u16, parameters: &[u16]) -> Result<(), Infallible> {
        SpiBus::flush(bus)?;
        let Ok(()) = self.data.set_low();
        SpiBus::write(bus, &[command])?;
        SpiBus::flush(bus)?;
        let Ok(()) = self.data.set_high();
        SpiBus::write(bus, parameters)
    }
}
