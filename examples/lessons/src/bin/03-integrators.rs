//! Which step is too long? `cargo run --release -p lessons --bin 03-integrators [-- OMEGA_H]`.

use kerchief::host::Counted;
use kerchief::{BackwardEuler, ForwardEuler, Leapfrog, Node, Sheet, Solver, Verlet};
use lessons::{Plot, argument};

/// Displacement and energy (1 at the start) of a particle with omega = 1 per s after each of `count` steps of `step` (s).
fn swing(solver: impl Solver<f64>, step: f64, count: u32) -> Vec<(f64, f64)> {
    let pair = Sheet::<f64, 1, 2>::new([0.0, 1e5], 1.0, step, 1); // 1 kg, and a spring of 1 N/m
    let scene = pair.scene((), pair.stretch(1.0), (), solver);
    let (mut cloth, mut memory) = (pair.hang([0.0; 3]), scene.memory());
    cloth.pin(Node::new(0, 0));
    cloth.position.set(Node::new(0, 1), pair.place([0.0, 0.0, -1e5 - 1.0]));
    let state = |_| {
        let x = -pair.metres(cloth.position.at(Node::new(0, 1)))[2] - 1e5;
        let v = pair.units.metres_per_second(cloth.velocity.at(Node::new(0, 1)))[2];
        scene.step(&mut cloth, &mut memory);
        (x, x * x + v * v)
    };
    (0..=count).map(state).collect()
}

/// Operations per particle of a sheet of 16 x 16 in a step of 1/60 s.
fn operations(solver: impl Solver<Counted>) -> u64 {
    let sheet = Sheet::<Counted, 16, 16>::new([0.3, 0.3], 1e-4, 1.0 / 60.0, 1);
    let scene = sheet.scene(sheet.gravity([0.0, 0.0, -9.81]), sheet.stretch(1.0), (), solver);
    let (mut cloth, mut memory) = (sheet.hang([0.0; 3]), scene.memory());
    cloth.pin(Node::new(0, 0));
    Counted::reset();
    scene.step(&mut cloth, &mut memory);
    Counted::operations().total() / 256
}

fn show<V: Solver<f64> + Solver<Counted> + Copy>(plot: &mut Plot, name: &str, solver: V, theory: f64) {
    let (step, course) = (argument(0.1), swing(solver, argument(0.1), 400));
    println!("{name:15} {:17.4e} {theory:11.4e} {:12}", course[100].1, operations(solver));
    plot.curve(name, (0..).zip(course).map(|(k, (_, energy))| (f64::from(k) * step, energy.log10())));
}

fn main() {
    let step = argument(0.1);
    let growth = (1.0 + step * step).powi(100);
    println!("omega h = {step}; energy after 100 steps   by theory   operations");
    let mut plot = Plot::new("Energy of a spring by four methods", ["time, 1/omega", "log10 of energy / first energy"]);
    show(&mut plot, "forward Euler", ForwardEuler::new(), growth);
    show(&mut plot, "backward Euler", BackwardEuler::new(), 1.0 / growth);
    show(&mut plot, "Verlet, relaxed", Verlet { sweeps: 1 }, 1.0 / growth);
    show(&mut plot, "leapfrog", Leapfrog::new(), 1.0);
    plot.write("03-integrators");
    let course = swing(Leapfrog, step, 100);
    let [_, by_hand] = (1..100).fold([course[0].0, course[1].0], |[old, x], _| [x, 2.0 * x - old - step * step * x]);
    println!("step 100 by leapfrog {:.6}, by x'' = 2 x' - x - h^2 omega^2 x' {by_hand:.6}", course[100].0);
    let stable = |step: f64| swing(Leapfrog, step, 2000).iter().all(|(_, energy)| *energy < 1e4);
    let longest = (1..3000).take_while(|step| stable(f64::from(*step) / 1000.0)).count();
    println!("leapfrog is stable up to omega h = {}", longest as f64 / 1000.0);
}
