//! a frame has at most 16777216 substeps

use kerchief::Units;

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, (1 << 31) + 1);

fn main() {
    let _ = UNITS;
}
