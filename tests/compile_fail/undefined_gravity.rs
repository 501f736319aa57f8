//! numbers of a scene are finite

use kerchief::Units;
use kerchief::units::Acceleration;

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);
const WEIGHT: Acceleration = UNITS.acceleration([0.0, 0.0, f64::NAN]);

fn main() {
    let _ = WEIGHT;
}
