//! a grid needs at least one column and one row

use kerchief::{Cloth, Units};

const UNITS: Units = Units::sheet([4, 4], [0.1, 0.1], 1e-3, 0.02, 4);

fn main() {
    let _ = Cloth::<f32, 0, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
}
