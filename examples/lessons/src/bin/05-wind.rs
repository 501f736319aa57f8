//! How does air push on cloth? `cargo run --release -p lessons --bin 05-wind [-- DENSITY]` of the air, kg/m³.

use kerchief::{Force, ForwardEuler, Leapfrog, Sheet, measure};
use lessons::{Plot, argument};

const SIDE: usize = 9;
const MASS: f64 = 0.2; // kg, of 1 m²
const SHEET: Sheet<f64, SIDE, SIDE> = Sheet::new([1.0, 1.0], MASS / 64.0, 0.001, 1);
const SPEED: f64 = 2.0; // of the wind, m/s

/// The force of a wind on the whole sheet at rest (N): its change of momentum in a frame without links, per time.
fn force(wind: impl Force<f64>) -> f64 {
    let scene = SHEET.scene(wind, (), (), ForwardEuler::new());
    let mut cloth = SHEET.lay([0.0; 3]);
    scene.step(&mut cloth, &mut scene.memory());
    measure::momentum(&cloth, &SHEET.units)[2] / SHEET.units.frame
}

/// The mean velocity upward (m/s) of a released sheet, in each millisecond of 0.3 s.
fn flight(forces: impl Force<f64>) -> Vec<(f64, f64)> {
    let scene = SHEET.scene(forces, (SHEET.stretch(50.0), SHEET.shear(5.0), SHEET.bend(5.0)), (), Leapfrog::new());
    let (mut cloth, mut memory) = (SHEET.lay([0.0; 3]), scene.memory());
    cloth.share_area();
    let frame = |frame: u32| {
        let velocity = measure::momentum(&cloth, &SHEET.units)[2] / MASS;
        scene.step(&mut cloth, &mut memory);
        (f64::from(frame) * SHEET.units.frame, velocity)
    };
    (0..=300).map(frame).collect()
}

fn main() {
    let density = argument(1.2);
    let half = 0.5 * density * 1.2; // rho c / 2
    let (facet, plate) = (|wind| SHEET.facet_wind(wind), |wind| SHEET.aerodynamic_wind(wind, density, 1.2));
    println!("angle to the normal   facet, N   6 A w cos   aerodynamic, N   rho c A (w cos)^2 / 2");
    for degrees in [0.0_f64, 30.0, 60.0, 90.0] {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let wind = [SPEED * sin, 0.0, SPEED * cos];
        let [by_facet, by_plate] = [force(facet(wind)), force(plate(wind))];
        let [across, square] = [6.0 * SPEED * cos, half * (SPEED * cos).powi(2)];
        println!("{degrees:19} {by_facet:10.3} {across:11.3} {by_plate:16.3} {square:23.3}");
    }
    let (wind, weight) = ([0.0, 0.0, SPEED], SHEET.gravity([0.0, 0.0, -9.81]));
    let last = (MASS * 9.81 / half).sqrt(); // the velocity at which drag balances the weight, m/s
    let mut plot = Plot::new("A sheet let go in air", ["time, s", "velocity upward, m/s"]);
    println!("\nvelocity upward, m/s, after  0.1 s    exactly    0.3 s    exactly");
    let mut show = |name: &str, course: Vec<(f64, f64)>, [early, late]: [f64; 2]| {
        println!("{name:23} {:10.3} {early:10.3} {:8.3} {late:10.3}", course[100].1, course[300].1);
        plot.curve(name, course.into_iter().step_by(4));
    };
    let carried = |time: f64| SPEED - SPEED / (1.0 + SPEED * time * half / MASS);
    show("in aerodynamic wind", flight(plate(wind)), [0.1, 0.3].map(carried));
    show("in facet wind", flight(facet(wind)), [0.1, 0.3].map(|time| 6.0 * SPEED * time / MASS));
    let falling = |time: f64| -last * (9.81 * time / last).tanh();
    show("falling in still air", flight((weight, plate([0.0; 3]))), [0.1, 0.3].map(falling));
    show("falling without air", flight(weight), [0.1, 0.3].map(|time| -9.81 * time));
    plot.write("05-wind");
}
