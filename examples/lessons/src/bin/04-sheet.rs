//! What does each family of springs do? `cargo run --release -p lessons --bin 04-sheet [-- SHEAR]`, N/m.

use kerchief::{Cloth, Lines, Links, Node, Sheet, measure};
use lessons::{GAP, Plot, argument};

const SIDE: usize = 11;
/// Cells of 0.1 m.
const SHEET: Sheet<f64, SIDE, SIDE> = Sheet::new([1.0, 1.0], 0.002, 1.0 / 60.0, 8);

/// A sheet whose particle at (x, y) is moved to `place(x, y)`, m.
fn deformed(place: impl Fn([f64; 3]) -> [f64; 3]) -> Cloth<f64, SIDE, SIDE> {
    let mut cloth = SHEET.lay([0.0; 3]);
    cloth.position.change(|at| SHEET.place(place(SHEET.metres(at))));
    cloth
}

/// What a sheet that is held at one corner looks like after 4 s.
fn hung(links: impl Links<f64>) -> Cloth<f64, SIDE, SIDE> {
    let scene = SHEET.scene((SHEET.gravity([0.0, 0.0, -9.81]), SHEET.drag(2.0)), links, (), Lines::new());
    let (mut cloth, mut memory) = (SHEET.lay([0.0; 3]), scene.memory());
    cloth.pin(Node::new(0, 0));
    (0..240).for_each(|_| scene.step(&mut cloth, &mut memory));
    cloth
}

/// Its rows and columns seen along y, moved to the side.
fn threads(cloth: &Cloth<f64, SIDE, SIDE>, beside: f64) -> Vec<(f64, f64)> {
    let at = |column, row| {
        let [x, _, z] = SHEET.metres(cloth.position.at(Node::new(column, row)));
        (x + beside, z)
    };
    let pair = |i| (0..SIDE).map(move |j| at(i, j)).chain([GAP]).chain((0..SIDE).map(move |j| at(j, i))).chain([GAP]);
    (0..SIDE).flat_map(pair).collect()
}

fn energy(cloth: &Cloth<f64, SIDE, SIDE>, links: &impl Links<f64>) -> f64 {
    measure::elastic_energy(cloth, &SHEET.units, links)
}

fn main() {
    let (stretch, shear, bend) = (SHEET.stretch(100.0), SHEET.shear(argument(5.0)), SHEET.bend(1.0));
    println!("energy, J           stretch     shear      bend");
    for (name, cloth) in [
        ("longer by 10 %", deformed(|[x, y, _]| [1.1 * x, y, 0.0])),
        ("skewed by 0.2 rad", deformed(|[x, y, _]| [x + y * 0.2_f64.sin(), y * 0.2_f64.cos(), 0.0])),
        ("folded upright", deformed(|[x, y, _]| [x.min(0.5), y, (x - 0.5).max(0.0)])),
    ] {
        let [stretched, sheared, bent] = [energy(&cloth, &stretch), energy(&cloth, &shear), energy(&cloth, &bend)];
        println!("{name:17} {stretched:9.4} {sheared:9.4} {bent:9.4}");
    }
    println!("\nheld at one corner    strain of threads   of diagonals");
    let mut plot = Plot::new("Held at one corner", ["x, m", "z, m"]);
    let plain = (stretch, shear);
    let sheets = [("stretch", hung(stretch)), ("and shear", hung(plain)), ("and bend", hung((plain, bend)))];
    for (beside, (name, cloth)) in [0.0, 1.0, 2.0].into_iter().zip(sheets) {
        let [along, across] = [measure::strain(&cloth, &stretch), measure::strain(&cloth, &shear)];
        println!("{name:20} {:18.4} {:14.4}", along.largest, across.largest);
        plot.curve(name, threads(&cloth, beside));
    }
    plot.write("04-sheet");
}
