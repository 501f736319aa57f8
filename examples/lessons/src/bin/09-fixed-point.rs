//! How good are 24 bits? `cargo run --release -p lessons --bin 09-fixed-point [-- CELLS]` from the origin.

use kerchief::{Node, Q13, Q24, Scalar, Sheet, Xpbd};
use lessons::{Plot, argument, farthest};

const SIDE: usize = 12;
const CELL: f64 = 0.02; // m

/// Positions after each quarter second of ten seconds, in cells from the place (`away`, `away`, `away`) where the sheet starts.
fn course<S: Scalar>(away: f64) -> Vec<Vec<[f64; 3]>> {
    let sheet = Sheet::<S, SIDE, SIDE>::new([CELL * (SIDE - 1) as f64; 2], 1e-3, 1.0 / 60.0, 8);
    let links = (sheet.stretch(1e4), sheet.shear(100.0), sheet.bend(10.0));
    let scene = sheet.scene((sheet.gravity([0.0, 0.0, -9.81]), sheet.drag(2.0)), links, (), Xpbd::new());
    let origin = [CELL * away; 3];
    let (mut cloth, mut memory) = (sheet.lay(origin), scene.memory());
    [0, SIDE - 1].iter().for_each(|&column| cloth.pin(Node::new(column, 0)));
    let quarter = |_| {
        (0..15).for_each(|_| scene.step(&mut cloth, &mut memory));
        let local = |[x, y, z]: [f64; 3]| [x - away, y - away, z - away];
        cloth.position.values().map(|at| local(at.to_f64())).collect()
    };
    (0..40).map(quarter).collect()
}

/// The largest distance of a particle from its place in `f64`, cells, with the time (s).
fn drift<S: Scalar>(away: f64) -> Vec<(f64, f64)> {
    let both = course::<S>(away).into_iter().zip(course::<f64>(away));
    (1..).zip(both).map(|(quarter, (a, b))| (0.25 * f64::from(quarter), farthest(&a, &b))).collect()
}

fn places<S: Scalar>(far: f64) {
    let next = if S::EXACT_SUMS { S::RESOLUTION } else { S::RESOLUTION * 2_f64.powf(far.log2().floor()) };
    println!("{:8} {:15.1e} {next:8.1e} {:10.1e}", S::NAME, S::RESOLUTION, S::LARGEST);
}

fn main() {
    let far = argument(100.0);
    println!("         last place of 1   of {far}   largest, cells");
    places::<f32>(far);
    places::<Q24>(far);
    let mut plot = Plot::new("Rounding: distance from f64", ["time, s", "largest distance, cells"])
        .in_powers_of_ten([false, true]);
    println!("\ndistance from f64 after ten seconds, cells");
    let mut show = |name: String, course: Vec<(f64, f64)>| {
        println!("{name:24} {:.1e}", course[39].1);
        plot.curve(name, course);
    };
    show("f32 at the origin".into(), drift::<f32>(0.0));
    show(format!("f32 {far} cells away"), drift::<f32>(far));
    show("Q24 at the origin".into(), drift::<Q24>(0.0));
    show(format!("Q24 {far} cells away"), drift::<Q24>(far));
    show("Q13 at the origin".into(), drift::<Q13>(0.0));
    plot.write("09-fixed-point");
    println!("Q24 is in the same places here and there: {}", course::<Q24>(0.0) == course::<Q24>(far));
    println!("\nsubsteps   what gravity adds in one, in last places of Q24");
    for substeps in [8, 512, 32_768, 262_144] {
        let sheet = Sheet::<Q24, SIDE, SIDE>::new([CELL * (SIDE - 1) as f64; 2], 1e-3, 1.0 / 60.0, substeps);
        println!("{substeps:8} {:10.1}", sheet.units.acceleration([0.0, 0.0, 9.81]).0[2] / Q24::RESOLUTION);
    }
}
