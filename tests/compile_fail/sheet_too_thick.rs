//! a sheet that meets itself is between 0.75 and 1 times as thick as a cell's longer side

use kerchief::self_contact::Thickness;
use kerchief::{Lines, SelfContact, Units};

const UNITS: Units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 0.02, 4);
const THICKNESS: Thickness = Thickness::new(&UNITS, 0.11);

fn main() {
    let _ = SelfContact::<f32, Lines>::new(THICKNESS, 0.3, Lines::new());
}
