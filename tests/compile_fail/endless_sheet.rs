//! a sheet needs a finite size

use kerchief::Units;

const UNITS: Units = Units::sheet([4, 4], [f64::INFINITY, 0.1], 1e-3, 0.02, 4);

fn main() {
    let _ = UNITS;
}
