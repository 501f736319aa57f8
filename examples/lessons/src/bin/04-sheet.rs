//! What does each family of springs do? `cargo run --release -p lessons --bin 04-sheet [-- SHEAR]`, N/m.

use kerchief::measure::{bounds, elastic_energy as energy, strain};
use kerchief::{Cloth, Lines, Links, Node, Sheet};
use lessons::{GAP, Plot, argument};

const SIDE: usize = 11;
const SHEET: Sheet<f64, SIDE, SIDE> = Sheet::new([1.0, 1.0], 0.002, 1.0 / 60.0, 8); // cells of 0.1 m

/// A sheet whose particles are moved from `p` to `place(p)`, m.
fn deformed(place: impl Fn([f64; 3]) -> [f64; 3]) -> Cloth<f64, SIDE, SIDE> {
    let mut cloth = SHEET.lay([0.0; 3]);
    cloth.position.change(|at| SHEET.place(place(SHEET.metres(at))));
    cloth
}

/// The sheet after 4 s.
fn settled(mut cloth: Cloth<f64, SIDE, SIDE>, links: impl Links<f64>) -> Cloth<f64, SIDE, SIDE> {
    let scene = SHEET.scene((SHEET.gravity([0.0, 0.0, -9.81]), SHEET.drag(2.0)), links, (), Lines::new());
    let mut memory = scene.memory();
    (0..240).for_each(|_| scene.step(&mut cloth, &mut memory));
    cloth
}

/// Rows and columns of the sheet seen along y, shifted by `beside` (m).
fn threads(cloth: &Cloth<f64, SIDE, SIDE>, beside: f64) -> Vec<(f64, f64)> {
    let at = |column, row| SHEET.metres(cloth.position.at(Node::new(column, row)));
    let pair = |i| (0..SIDE).map(move |j| at(i, j)).chain([GAP]).chain((0..SIDE).map(move |j| at(j, i))).chain([GAP]);
    (0..SIDE).flat_map(pair).map(|[x, _, z]| (x + beside, z)).collect()
}

fn main() {
    let (stretch, shear, bend) = (SHEET.stretch(1000.0), SHEET.shear(argument(20.0)), SHEET.bend(200.0));
    println!("energy, J           stretch     shear      bend");
    for (name, cloth) in vec![
        ("longer by 10 %", deformed(|[x, y, _]| [1.1 * x, y, 0.0])),
        ("skewed by 0.2 rad", deformed(|[x, y, _]| [x + y * 0.2_f64.sin(), y * 0.2_f64.cos(), 0.0])),
        ("folded upright", deformed(|[x, y, _]| [x.min(0.5), y, (x - 0.5).max(0.0)])),
    ] {
        let units = &SHEET.units;
        let [a, b, c] = [energy(&cloth, units, &stretch), energy(&cloth, units, &shear), energy(&cloth, units, &bend)];
        println!("{name:17} {a:9.4} {b:9.4} {c:9.4}");
    }
    let (mut hung, mut shelf, both) = (SHEET.hang([0.0; 3]), SHEET.lay([0.0; 3]), (stretch, shear));
    hung.pin(Node::new(0, 0));
    (0..6 * SIDE).for_each(|k| shelf.pin(Node::new(k % 6, k / 6)));
    println!("\nsettled                strain of threads   of diagonals   lowest, m");
    let mut plot = Plot::new("Hung by a corner; clamped as a shelf", ["x, m", "z, m"]).at_one_scale();
    for (beside, name, cloth) in vec![
        (0.0, "hung: stretch", settled(hung, stretch)),
        (0.8, "hung: and shear", settled(hung, both)),
        (1.8, "shelf: both", settled(shelf, both)),
        (1.8, "shelf: and bend", settled(shelf, (both, bend))),
    ] {
        let (low, along, across) = (bounds(&cloth)[0], strain(&cloth, &stretch), strain(&cloth, &shear));
        println!("{name:16} {:23.4} {:14.4} {:11.3}", along.largest, across.largest, SHEET.metres(low)[2]);
        plot.curve(name, threads(&cloth, beside));
    }
    plot.write("04-sheet");
}
