//! a grid has at most 32768 columns and rows

use kerchief::Grid;

fn main() {
    let _ = Grid::<(), 1, 32_769>::filled(());
}
