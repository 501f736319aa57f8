//! When do two machines get the same bits? `cargo run --release -p lessons --bin 10-same-bits [-- WIND]`, m/s.

use std::hint::black_box;

use kerchief::{Drag, Lines, Node, Q13, Q24, Scalar, Sheet, Vec3, Vectors, Xpbd, measure};
use lessons::{Plot, argument, farthest, shortest_time};

/// The digest of the scene `dragged`, which boards compute, too.
fn digest<S: Scalar>() -> u32 {
    let sheet = Sheet::<S, 10, 10>::new([0.75, 0.6], 5e-4, 1.5 / 60.0, 3);
    let forces = (sheet.gravity([0.0, 0.0, -9.81]), Drag::new(sheet.units.verlet_damping(0.02)));
    let scene = sheet.scene(forces, (sheet.stretch(40.0), sheet.shear(8.0), sheet.bend(2.0)), (), Xpbd::new());
    let (mut cloth, mut memory) = (sheet.lay([-0.4, -0.3, 0.0]), scene.memory());
    [0, 9].iter().for_each(|&column| cloth.pin(Node::new(column, 0)));
    (0..8).for_each(|_| scene.step(&mut cloth, &mut memory));
    measure::digest(&cloth)
}

/// Positions of a flag in `f32` in each of 300 frames. One number of its initial state is changed by `places` last places.
fn flag(wind: f64, places: f32) -> Vec<Vec<[f64; 3]>> {
    let sheet = Sheet::<f32, 16, 12>::new([0.6, 0.44], 2e-4, 1.0 / 60.0, 4);
    let air = sheet.aerodynamic_wind([wind, 0.1 * wind, 0.0], 1.2, 1.2);
    let links = (sheet.stretch(200.0), sheet.shear(5.0), sheet.bend(1.0));
    let scene = sheet.scene((sheet.gravity([0.0, 0.0, -9.81]), air), links, (), Lines::new());
    let (mut cloth, mut memory) = (sheet.hang([0.1, 0.1, 0.1]), scene.memory());
    (0..12).for_each(|row| cloth.pin(Node::new(0, row)));
    cloth.position.add(Node::new(8, 6), Vec3::new(0.0, places * 2.4e-7, 0.0));
    let frame = |_| {
        scene.step(&mut cloth, &mut memory);
        cloth.position.values().map(|at| sheet.metres(at)).collect()
    };
    (0..300).map(frame).collect()
}

fn main() {
    let [a, b, c] = [0.1_f32, 0.7, -0.8].map(black_box);
    println!("(a + b) + c = {:e}, a + (b + c) = {:e}", (a + b) + c, a + (b + c));
    println!("a b - fl(a b), rounded twice {:e}, rounded once {:e}", a * b - black_box(a * b), a.mul_add(b, -(a * b)));
    let [f32, f64, q24, q13] = [digest::<f32>(), digest::<f64>(), digest::<Q24>(), digest::<Q13>()];
    println!("digests: f32 {f32:08x}, f64 {f64:08x}, q24 {q24:08x}, q13 {q13:08x}");

    let both = flag(argument(6.0), 0.0).into_iter().zip(flag(argument(6.0), 1.0));
    let apart: Vec<_> = (1..).zip(both).map(|(frame, (a, b))| (f64::from(frame) / 60.0, farthest(&a, &b))).collect();
    println!("two flags a last place apart: {:.0e} m after 1 s, {:.0e} m after 5 s", apart[59].1, apart[299].1);
    let axes = ["time, s", "largest distance, m"];
    let mut plot = Plot::new("Two flags a last place apart", axes).in_powers_of_ten([false, true]);
    plot.curve(format!("wind of {} m/s", argument(6.0)), apart);
    plot.write("10-same-bits");

    let start = [Vec3::new(1.0, 2.0, 3.0), Vec3::new(0.1, -0.2, 0.3)];
    let mut objects = vec![start; 64 * 64];
    let [mut position, velocity] = start.map(Vectors::<f32, 64, 64>::filled);
    let by_object = shortest_time(|| black_box(&mut objects).iter_mut().for_each(|[x, v]| *x += *v * 0.125));
    let by_row = shortest_time(|| {
        let rows = black_box(&mut position).0.iter_mut().zip(&velocity.0);
        rows.for_each(|(x, v)| (0..64).for_each(|column| x.add(column, v.at(column) * 0.125)));
    });
    println!("the same bits in both layouts: {}", objects.iter().zip(position.values()).all(|([x, _], y)| *x == y));
    println!("wall time, objects / rows: {:.1}", by_object / by_row);
}
