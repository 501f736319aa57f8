//! Which solver needs the least work for a given error? `cargo run --release -p lessons --bin 08-cost [-- STIFFNESS]`, N/m.

use kerchief::host::Counted;
use kerchief::{BackwardEuler, Leapfrog, Lines, Node, Scalar, Sheet, Solver, Verlet, Xpbd};
use lessons::{Plot, argument, shortest_time};

const SIDE: usize = 8;
const FRAMES: u64 = 20; // a third of a second

/// Positions of the particles after a sheet has swung from one edge, m.
fn swing<S: Scalar>(solver: impl Solver<S>, substeps: u32) -> Vec<[f64; 3]> {
    let stiffness = argument(50.0);
    let sheet = Sheet::<S, SIDE, SIDE>::new([0.3, 0.3], 1e-3, 1.0 / 60.0, substeps);
    let links = (sheet.stretch(stiffness), sheet.shear(0.1 * stiffness));
    let scene = sheet.scene(sheet.gravity([0.0, 0.0, -9.81]), links, (), solver);
    let (mut cloth, mut memory) = (sheet.lay([0.0; 3]), scene.memory());
    (0..SIDE).for_each(|column| cloth.pin(Node::new(column, 0)));
    (0..FRAMES).for_each(|_| scene.step(&mut cloth, &mut memory));
    cloth.position.values().map(|at| sheet.metres(at)).collect()
}

/// The root mean square of the distances between the particles of two sheets, mm.
fn apart(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let squares = a.as_flattened().iter().zip(b.as_flattened()).map(|(a, b)| (a - b).powi(2));
    1e3 * (squares.sum::<f64>() / a.len() as f64).sqrt()
}

/// Prints the solver's order and its cheapest run within 10 mm of `truth`, and plots error against operations per particle and frame.
fn study<V: Solver<f64> + Solver<Counted> + Copy>(plot: &mut Plot, truth: &[[f64; 3]], name: &str, solver: V) {
    let point = |power: u32| {
        Counted::reset();
        swing::<Counted>(solver, 1 << power);
        let operations = Counted::operations().total() / FRAMES / (SIDE * SIDE) as u64;
        (operations as f64, apart(&swing::<f64>(solver, 1 << power), truth))
    };
    let points: Vec<_> = (0..7).map(point).collect();
    let order = (points[5].1 / points[6].1).log2();
    let enough = (0..7).find(|k| points[*k..].iter().all(|(_, error)| *error < 10.0));
    let enough = enough.map_or("more than 64".into(), |k| format!("{:13} {:12}", 1 << k, points[k].0));
    println!("{name:17} {order:5.2} {enough}");
    plot.curve(name, points.into_iter().filter(|(_, error)| *error < 1e3));
}

fn main() {
    let truth = swing::<f64>(Leapfrog, 1024);
    println!("the truth is known to {:.0e} mm", apart(&swing::<f64>(Leapfrog, 512), &truth));
    println!("solver            order   substeps and operations for 10 mm");
    let axes = ["operations for a particle in a frame", "error, mm"];
    let mut plot = Plot::new("A swinging sheet: error against cost", axes).in_powers_of_ten([true; 2]);
    study(&mut plot, &truth, "leapfrog", Leapfrog);
    study(&mut plot, &truth, "XPBD", Xpbd);
    study(&mut plot, &truth, "Verlet, 4 sweeps", Verlet { sweeps: 4 });
    study(&mut plot, &truth, "backward Euler", BackwardEuler::new());
    study(&mut plot, &truth, "lines", Lines::new());
    plot.write("08-cost");
    let times = [shortest_time(|| drop(swing::<f32>(Lines::new(), 8))), shortest_time(|| drop(swing::<f32>(Xpbd, 8)))];
    println!("wall time of lines / XPBD, 8 substeps: {:.1}", times[0] / times[1]);
}
