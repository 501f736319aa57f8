//! When does cloth slide? `cargo run --release -p lessons --bin 06-ball [-- FRICTION]`.

use kerchief::{Lines, Node, Sheet};
use lessons::{Plot, argument};

const SIDE: usize = 16;
const SHEET: Sheet<f64, SIDE, SIDE> = Sheet::new([0.6, 0.6], 3e-4, 1.0 / 60.0, 8); // cells of 4 cm
const RADIUS: f64 = 0.15; // m

/// The distance that a sheet has slid on a slope in half a second, m. The plane is level, and gravity is tilted.
fn slid(slope: f64, friction: f64) -> f64 {
    let gravity = SHEET.gravity([9.81 * slope.sin(), 0.0, -9.81 * slope.cos()]);
    let ground = SHEET.plane([0.0; 3], [0.0, 0.0, 1.0], 0.0).with_friction(friction);
    let scene = SHEET.scene(gravity, (SHEET.stretch(100.0), SHEET.shear(1.0)), ground, Lines::new());
    let (mut cloth, mut memory) = (SHEET.lay([0.0; 3]), scene.memory());
    (0..30).for_each(|_| scene.step(&mut cloth, &mut memory));
    SHEET.metres(cloth.position.at(Node::new(0, 0)))[0]
}

/// Positions (m) of the particles of a sheet 0.6 s after its release on top of a ball, 2 cm beside its middle.
fn draped(margin: f64, friction: f64) -> Vec<[f64; 3]> {
    let forces = (SHEET.gravity([0.0, 0.0, -9.81]), SHEET.drag(1.0));
    let ball = SHEET.ball([0.0, 0.0, -RADIUS - margin], RADIUS, margin).with_friction(friction);
    let scene = SHEET.scene(forces, (SHEET.stretch(1000.0), SHEET.shear(5.0), SHEET.bend(0.5)), ball, Lines::new());
    let (mut cloth, mut memory) = (SHEET.lay([-0.28, -0.3, 0.0]), scene.memory());
    (0..36).for_each(|_| scene.step(&mut cloth, &mut memory));
    cloth.position.values().map(|at| SHEET.metres(at)).collect()
}

fn main() {
    let friction = argument(0.5);
    let [_, slides] = (0..20).fold([0.0, 1.5], |[rests, slides], _| {
        let middle = 0.5 * (rests + slides);
        if slid(middle, friction) < 1e-4 { [middle, slides] } else { [rests, middle] }
    });
    let [found, law] = [slides, friction.atan()].map(f64::to_degrees);
    println!("friction {friction}: slides from {found:.2} degrees on, by Coulomb's law from {law:.2}");
    let needed = RADIUS.hypot(0.02) - RADIUS; // distance of the ends of a link of 4 cm whose middle touches the ball
    println!("\nmargin, mm   nearest particle, mm   nearest middle of a link, mm");
    for margin in [0.0, needed] {
        let places = draped(margin, friction);
        let gap = |[x, y, z]: [f64; 3]| 1e3 * (x.hypot(y).hypot(z + RADIUS + margin) - RADIUS);
        let middle = |ends: &[[f64; 3]]| [0, 1, 2].map(|axis| 0.5 * (ends[0][axis] + ends[1][axis]));
        let nearest = places.iter().map(|place| gap(*place)).fold(f64::MAX, f64::min);
        let links = places.chunks(SIDE).flat_map(|row| row.windows(2));
        let link = links.map(|ends| gap(middle(ends))).fold(f64::MAX, f64::min);
        println!("{:10.3} {nearest:22.3} {link:30.3}", 1e3 * margin);
    }
    println!("\nfriction   the middle of the sheet after 0.6 s: x, z, m");
    let mut plot = Plot::new("A sheet on a ball, cut through the middle", ["x, m", "z, m"]).at_one_scale();
    let circle = (0..=63).map(|k| (0.1 * f64::from(k)).sin_cos());
    plot.curve("ball", circle.map(|(x, z)| (RADIUS * x, RADIUS * (z - 1.0))));
    for friction in [0.0, 0.1, friction] {
        let row = &draped(needed, friction)[SIDE * (SIDE / 2)..][..SIDE];
        println!("{friction:8} {:9.3} {:7.3}", row[SIDE / 2][0], row[SIDE / 2][2]);
        plot.curve(format!("friction {friction}"), row.iter().map(|[x, _, z]| (*x, *z)));
    }
    plot.write("06-ball");
}
