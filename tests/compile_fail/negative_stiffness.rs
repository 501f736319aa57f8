//! a stiffness is zero or above

use kerchief::Units;
use kerchief::units::Strength;

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);
const STRENGTH: Strength = UNITS.stiffness(-1.0);

fn main() {
    let _ = STRENGTH;
}
