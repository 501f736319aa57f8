//! The accelerometer of a QMI8658 on I2C (QST, *QMI8658C datasheet*). It has a gyroscope, too, which stays off.
//!
//! The maintained driver (`ph-qmi8658` 0.1.1) is for `embedded-hal-async` and Rust 1.92. This one takes any bus of `embedded-hal` 1.0.

use embedded_hal::i2c::I2c;

/// What the chip is called by, with its pin SA0 high or low.
const ADDRESSES: [u8; 2] = [0x6b, 0x6a];

const WHO_AM_I: u8 = 0x00;
/// What it answers.
const IDENTITY: u8 = 0x05;
/// Its six bytes are the axes x, y, z, the lower byte first.
const ACCELERATION: u8 = 0x35;

/// Registers and what is written there.
const SETTINGS: [[u8; 2]; 4] = [
    // CTRL1: the address goes on by itself, the lower byte comes first
    [0x02, 0x40],
    // CTRL2: ±8 g, 125 readings a second
    [0x03, 0x26],
    // CTRL5: its own filter, a low pass at 13 % of that
    [0x06, 0x07],
    // CTRL7: the accelerometer, and nothing else
    [0x08, 0x01],
];

/// A sensor that measures.
pub(crate) struct Qmi8658<I> {
    bus: I,
    address: u8,
}

impl<I: I2c> Qmi8658<I> {
    /// Starts the sensor: an error if there is none.
    ///
    /// Its settings come before the question what it is: after a read, `rp2040-hal` 0.12 takes the read's end for that of the next write, and drops the latter.
    pub(crate) fn start(bus: I) -> Result<Self, NoSensor> {
        let mut sensor = Self { bus, address: 0 };
        for address in ADDRESSES {
            sensor.address = address;
            let is_set = SETTINGS.iter().all(|setting| sensor.bus.write(address, setting).is_ok());
            if is_set && matches!(sensor.read(WHO_AM_I), Ok([IDENTITY])) {
                return Ok(sensor);
            }
        }
        Err(NoSensor)
    }

    /// What it feels along its axes, in 4096ths of a weight. At rest that points up.
    pub(crate) fn force(&mut self) -> Result<[i32; 3], NoSensor> {
        let [x, x_high, y, y_high, z, z_high] = self.read(ACCELERATION)?;
        Ok([[x, x_high], [y, y_high], [z, z_high]].map(|bytes| i32::from(i16::from_le_bytes(bytes))))
    }

    fn read<const N: usize>(&mut self, register: u8) -> Result<[u8; N], NoSensor> {
        let mut bytes = [0; N];
        self.bus.write_read(self.address, &[register], &mut bytes).map_err(|_| NoSensor)?;
        Ok(bytes)
    }
}

/// Nothing answers, or something else.
pub(crate) struct NoSensor;
