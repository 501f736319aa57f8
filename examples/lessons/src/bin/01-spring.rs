//! Which motion follows from an energy? `cargo run --release -p lessons --bin 01-spring [-- STIFFNESS]`, N/m.

use std::f64::consts::TAU;

use kerchief::{Cloth, ForwardEuler, Leapfrog, Node, Sheet, measure};
use lessons::{Plot, argument};

const LENGTH: f64 = 0.5; // m
const MASS: f64 = 0.1; // kg
const FRAME: f64 = 0.0002; // s
/// Two particles and the spring between them.
const PAIR: Sheet<f64, 1, 2> = Sheet::new([0.0, LENGTH], MASS, FRAME, 1);
const END: Node = Node::new(0, 1);

/// A pair whose upper particle is pinned and whose lower one is displaced downwards by `pull` (m).
fn pulled(pull: f64) -> Cloth<f64, 1, 2> {
    let mut pair = PAIR.hang([0.0; 3]);
    pair.pin(Node::new(0, 0));
    pair.position.set(END, PAIR.place([0.0, 0.0, -LENGTH - pull]));
    pair
}

fn main() {
    let stiffness = argument(40.0);
    let spring = PAIR.stretch(stiffness);
    let energy = |pair: &_| measure::elastic_energy(pair, &PAIR.units, &spring);
    println!("pull, m   energy, J   minus its slope, N   force of the solver, N   -k (|d| - L), N");
    for pull in [-0.2, -0.1, 0.1, 0.2] {
        let slope = (energy(&pulled(pull + 1e-6)) - energy(&pulled(pull - 1e-6))) / 2e-6;
        let scene = PAIR.scene((), spring, (), ForwardEuler::new());
        let mut pair = pulled(pull);
        let stored = energy(&pair);
        scene.step(&mut pair, &mut scene.memory());
        let force = -measure::momentum(&pair, &PAIR.units)[2] / FRAME;
        println!("{pull:7.1} {stored:11.3} {:20.3} {force:24.3} {:17.3}", -slope, -stiffness * pull);
    }

    println!("\nperiod by 2 pi sqrt(m/k): {:.4} s", TAU * (MASS / stiffness).sqrt());
    let mut plot = Plot::new("A spring: phase portrait", ["length - rest length, m", "velocity, m/s"]);
    for pull in [0.1, 0.2, 0.4, 0.6] {
        let scene = PAIR.scene((), spring, (), Leapfrog::new());
        let (mut pair, mut memory) = (pulled(pull), scene.memory());
        let (mut path, mut passages, mut drift) = (vec![(pull, 0.0)], Vec::new(), 0.0_f64);
        for frame in 0..20_000 {
            scene.step(&mut pair, &mut memory);
            let total = energy(&pair) + measure::kinetic_energy(&pair, &PAIR.units);
            drift = drift.max((total / (0.5 * stiffness * pull * pull) - 1.0).abs());
            let (before, x) = (path[path.len() - 1].0, -PAIR.metres(pair.position.at(END))[2] - LENGTH);
            if before > 0.0 && x <= 0.0 {
                passages.push(FRAME * (f64::from(frame) + before / (before - x)));
            }
            path.push((x, -PAIR.units.metres_per_second(pair.velocity.at(END))[2]));
        }
        let period = (passages[passages.len() - 1] - passages[0]) / (passages.len() - 1) as f64;
        println!("pulled by {pull} m: period {period:.4} s, energy within {:.3} %", 100.0 * drift);
        plot.curve(format!("pulled by {pull} m"), path.into_iter().take(2600).step_by(20));
    }
    plot.write("01-spring");
}
