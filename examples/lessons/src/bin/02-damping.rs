//! How long does a spring ring? `cargo run --release -p lessons --bin 02-damping [-- RATIO]`, in critical dampings.

use kerchief::{Force, Leapfrog, Links, Node, Sheet, Vec3};
use lessons::{Plot, argument};

const LENGTH: f64 = 0.5; // m
const MASS: f64 = 0.1; // kg
const STIFFNESS: f64 = 40.0; // N/m
const OMEGA: f64 = 20.0; // sqrt(k/m), 1/s
const PAIR: Sheet<f64, 1, 2> = Sheet::new([0.0, LENGTH], MASS, 0.001, 16);
const ENDS: [Node; 2] = [Node::new(0, 0), Node::new(0, 1)];

/// The displacement after `time`, 1 at the start: the solution of m x'' = -k x - d x'.
fn exact(ratio: f64, time: f64) -> f64 {
    let root = (1.0 - ratio * ratio).abs().sqrt().max(1e-9);
    let phase = OMEGA * root * time;
    let (even, odd) = if ratio < 1.0 { (phase.cos(), phase.sin()) } else { (phase.cosh(), phase.sinh()) };
    (-ratio * OMEGA * time).exp() * (even + odd * ratio / root)
}

/// Releases a pair displaced by 0.1 m: time (s) and displacement relative to 0.1 m, for each millisecond of five seconds.
fn ring(ratio: f64) -> Vec<(f64, f64)> {
    let scene = PAIR.scene((), PAIR.damped(PAIR.stretch(STIFFNESS), ratio * 2.0 * MASS * OMEGA), (), Leapfrog::new());
    let (mut pair, mut memory) = (PAIR.hang([0.0; 3]), scene.memory());
    pair.pin(ENDS[0]);
    pair.position.set(ENDS[1], PAIR.place([0.0, 0.0, -LENGTH - 0.1]));
    let frame = |frame: u32| {
        let left = (-PAIR.metres(pair.position.at(ENDS[1]))[2] - LENGTH) / 0.1;
        scene.step(&mut pair, &mut memory);
        (f64::from(frame) / 1000.0, left)
    };
    (0..=5000).map(frame).collect()
}

/// Drops a pair whose lower particle starts at 1 m/s sideways. Prints its velocities of falling and turning after a second.
fn fall(name: &str, drag: impl Force<f64>, links: impl Links<f64>) {
    let scene = PAIR.scene((PAIR.gravity([0.0, 0.0, -9.81]), drag), links, (), Leapfrog::new());
    let (mut pair, mut memory) = (PAIR.hang([0.0; 3]), scene.memory());
    pair.velocity.set(ENDS[1], Vec3::from_f64(PAIR.units.velocity([0.0, 1.0, 0.0]).0));
    (0..1000).for_each(|_| scene.step(&mut pair, &mut memory));
    let [[_, y, z], [_, other_y, other_z]] = ENDS.map(|end| PAIR.units.metres_per_second(pair.velocity.at(end)));
    println!("{name:36} {:5.2} m/s {:6.3} m/s", -(z + other_z) / 2.0, (y - other_y).hypot(z - other_z) / 2.0);
}

fn main() {
    let mut plot = Plot::new("A spring with a damper", ["time, s", "displacement / first displacement"]);
    println!("ratio   left after 0.25 s    exactly   below 1 % from");
    for ratio in [0.05, 0.25, 1.0, 2.0, argument(0.5)] {
        let course = ring(ratio);
        let settled = course.iter().rev().find(|(_, left)| left.abs() > 0.01).map_or(0.0, |(time, _)| *time);
        println!("{ratio:5.2} {:19.5} {:10.5} {settled:12.3} s", course[250].1, exact(ratio, 0.25));
        plot.curve(format!("{ratio} of critical"), course.into_iter().take(1000).step_by(4));
    }
    plot.write("02-damping");
    println!("\na turning pair in free fall, after 1 s   falls at   turns at");
    fall("no damping", (), PAIR.stretch(STIFFNESS));
    fall("a damper of 0.02 N s/m", (), PAIR.damped(PAIR.stretch(STIFFNESS), 0.02));
    fall("drag of 2 per s", PAIR.drag(2.0), PAIR.stretch(STIFFNESS));
}
