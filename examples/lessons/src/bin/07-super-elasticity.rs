//! Why does stiff cloth stretch like rubber? `cargo run --release -p lessons --bin 07-super-elasticity [-- SWEEPS]`.

use kerchief::host::Counted;
use kerchief::{Lines, Links, Node, Scalar, Sheet, Solver, StrainLimited, Verlet, Xpbd, measure};
use lessons::{Plot, argument};

/// A chain of `N` particles of 10 g, a metre long, in frames of 1/60 s.
const fn chain<const N: usize>(substeps: u32) -> Sheet<Counted, 1, N> {
    Sheet::new([0.0, 1.0], 0.01, 1.0 / 60.0, substeps)
}
const STIFFNESS: f64 = 1e5; // N/m
const TRUE: f64 = 100.0 * 31.0 * 0.01 * 9.81 / (STIFFNESS / 31.0); // %, of a link of 1/31 m that carries 31 particles

/// The strain of a hanging chain after 4 s (percent), and the operations per particle in a frame.
fn hang<const N: usize>(substeps: u32, solver: impl Solver<Counted>, links: impl Links<Counted>) -> (f64, u64) {
    let chain = chain::<N>(substeps);
    let scene = chain.scene((chain.gravity([0.0, 0.0, -9.81]), chain.drag(4.0)), links, (), solver);
    let (mut cloth, mut memory) = (chain.hang([0.0; 3]), scene.memory());
    cloth.pin(Node::new(0, 0));
    (0..239).for_each(|_| scene.step(&mut cloth, &mut memory));
    Counted::reset();
    scene.step(&mut cloth, &mut memory);
    let operations = Counted::operations().total();
    (100.0 * measure::strain(&cloth, &chain.stretch(STIFFNESS)).largest.to_f64(), operations / N as u64)
}

fn relaxed<const N: usize>(sweeps: u32) -> (f64, u64) {
    hang::<N>(1, Verlet { sweeps }, chain::<N>(1).stretch(STIFFNESS))
}

/// Displaces the lowest particle of a chain of 64 and counts the particles that have moved after the sweeps of one substep.
fn heard(sweeps: u32) -> usize {
    let chain = Sheet::<f64, 1, 64>::new([0.0, 1.0], 0.01, 1.0 / 60.0, 1);
    let scene = chain.scene((), chain.stretch(STIFFNESS), (), Verlet { sweeps });
    let (mut cloth, before) = (chain.hang([0.0; 3]), chain.hang([0.0; 3]));
    cloth.position.add(Node::new(0, 63), chain.place([0.0, 0.0, -0.001]));
    scene.step(&mut cloth, &mut scene.memory());
    cloth.position.values().zip(before.position.values()).filter(|(now, then)| now != then).count()
}

fn main() {
    let sweeps = argument(15.0) as u32;
    println!("particles that have moved after 1, 2, 4 and 8 sweeps: {:?}", [1, 2, 4, 8].map(heard));
    let mut plot = Plot::new("Strain of a hanging chain", ["sweeps", "strain, %"]).in_powers_of_ten([true; 2]);
    let curve = |of: fn(u32) -> f64| (0..8).map(move |power| (f64::from(1 << power), of(1 << power)));
    plot.curve("32 particles", curve(|sweeps| relaxed::<32>(sweeps).0));
    plot.curve("16 particles", curve(|sweeps| relaxed::<16>(sweeps).0));
    plot.curve("8 particles", curve(|sweeps| relaxed::<8>(sweeps).0));
    plot.curve("springs alone, 32", curve(|_| TRUE));
    plot.write("07-super-elasticity");
    println!("\n32 particles, by their springs {TRUE:.4} %   strain, %   operations for a particle in a frame");
    let show = |name: String, (strain, operations): (f64, u64)| println!("{name:39} {strain:9.4} {operations:6}");
    let (springs, short) = (chain::<32>(1).stretch(STIFFNESS), chain::<32>(sweeps));
    let tether = chain::<32>(1).tether::<1>(&[Node::new(0, 0)], 0.0).expect("one anchor");
    show(format!("Verlet, {sweeps} sweeps"), relaxed::<32>(sweeps));
    show("... limited to 10 %".into(), hang::<32>(1, Verlet { sweeps }, StrainLimited::new(springs, 0.1)));
    show("... tethered".into(), hang::<32>(1, Verlet { sweeps }, (springs, tether)));
    show(format!("XPBD, {sweeps} substeps"), hang::<32>(sweeps, Xpbd::new(), short.stretch(STIFFNESS)));
    show("lines, 1 substep".into(), hang::<32>(1, Lines::new(), springs));
}
