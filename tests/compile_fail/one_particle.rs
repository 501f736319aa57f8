//! a sheet needs two particles and a positive size

use kerchief::Units;

const UNITS: Units = Units::sheet([1, 1], [0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let _ = UNITS;
}
