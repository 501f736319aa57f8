//! a frame needs a positive length and one substep at least

use kerchief::Units;

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 0);

fn main() {
    let _ = UNITS;
}
