//! The accelerometer of a QMI8658 on I2C (QST, *QMI8658C datasheet*). It has a gyroscope, too, which stays off.
//!
//! The maintained driver (`ph-qmi8658` 0.1.1) is for `embedded-hal-async` and Rust 1.92. This one takes any bus of `embedded-hal` 1.0.

use embedded_hal::i2c::I2c;

/// The chip's I2C address, with its pin SA0 high or low.
const ADDRESSES: [u8; 2] = [0x6b, 0x6a];

const WHO_AM_I: u8 = 0x00;
/// The value of that register.
const IDENTITY: u8 = 0x05;
/// The first of six registers: the axes x, y, z, the lower byte first.
const ACCELERATION: u8 = 0x35;

/// Registers and their values.
const SETTINGS: [[u8; 2]; 4] = [
    // CTRL1: the register's address increments by itself, the lower byte comes first
    [0x02, 0x40],
    // CTRL2: ±8 g, 125 readings a second
    [0x03, 0x26],
    // CTRL5: the chip's low-pass filter, at 13 % of that rate
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
    /// Starts the sensor. Returns an error if there is none.
    ///
    /// The settings are written before the identity is read: after a read, `rp2040-hal` 0.12 takes the end of that read for the end of the next write, and drops the write.
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

    /// The specific force along its axes, in 4096ths of the acceleration of gravity. At rest it points up.
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

/// No chip answers, or another chip does.
pub(crate) struct NoSensor;
