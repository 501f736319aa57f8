//! a constant of the scene is too small for its number type

use kerchief::units::Acceleration;
use kerchief::{Q24, Units};

const UNITS: Units = Units::sheet([4, 4], [30.0, 30.0], 1.0, 1.0 / 60.0, 2048);
const WEIGHT: Acceleration = UNITS.acceleration([0.0, 0.0, -9.81]).fits::<Q24>();

fn main() {
    let _ = WEIGHT;
}
