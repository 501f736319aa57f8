//! cannot initialize a tuple struct which contains private fields

use kerchief::units::Velocity;

fn main() {
    let _ = Velocity([1.0, 0.0, 0.0]);
}
