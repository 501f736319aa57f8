//! a particle needs a positive mass

use kerchief::Units;

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 0.0, 0.02, 4);

fn main() {
    let _ = UNITS;
}
