//! leave nothing for stretch springs: choose a sharper fold or larger cells

use kerchief::Units;
use kerchief::material::{INTERLOCK, Springs};

const UNITS: Units = INTERLOCK.units([31, 31], [0.15, 0.15], 0.02, 4);
const SPRINGS: Springs = INTERLOCK.springs(&UNITS, 0.5);

fn main() {
    let _ = SPRINGS;
}
