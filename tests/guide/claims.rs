//! Claims of the guide's pages that no snippet and no other test asserts.

use kerchief::host::{Description, Everything, built_in};
use kerchief::{
    BackwardEuler, ForwardEuler, Leapfrog, Lines, Node, Shear, Sheet, Solver, Stretch, Vec3, Verlet, Xpbd, measure,
};

/// The size of a solver's memory for a sheet of 16 × 16 particles in `f32` with two families of springs, bytes.
fn remembered<V: Solver<f32>>(_: V) -> usize {
    size_of::<V::Memory<(Stretch<f32>, Shear<f32>), 16, 16>>()
}

/// The column *remembers* in the table of solvers.
#[test]
fn solvers_remember_what_the_page_says() {
    let number = size_of::<f32>() * 16 * 16;
    let vector = 3 * number;
    assert_eq!([remembered(Xpbd::new()), remembered(Verlet::new())], [0, 0]);
    assert_eq!(remembered(ForwardEuler::new()), vector);
    assert_eq!(remembered(Leapfrog::new()), 2 * vector);
    assert_eq!(remembered(BackwardEuler::new()), 5 * vector);
    // a multiplier for each of a particle's two stretch links and two diagonals, and a few bytes for the whole sheet
    let lines = vector + 4 * number;
    assert!((lines..lines + 200).contains(&remembered(Lines::new())), "{}", remembered(Lines::new()));
}

/// Compares the kinetic energy of a sheet that moves through still air, after a frame, with that before.
#[test]
fn still_air_brakes_in_two_models_of_three() {
    const SHEET: Sheet<f32, 8, 8> = Sheet::new([0.3, 0.3], 1e-3, 1.0 / 60.0, 4);
    macro_rules! left {
        ($wind:expr) => {{
            let mut cloth = SHEET.lay([0.0; 3]);
            (0..64).for_each(|i| cloth.velocity.set(Node::new(i % 8, i / 8), Vec3::new(0.0, 0.0, 1.0)));
            let before = measure::kinetic_energy(&cloth, &SHEET.units);
            let scene = SHEET.scene($wind, (), (), Xpbd::new());
            let mut memory = scene.memory();
            scene.step(&mut cloth, &mut memory);
            measure::kinetic_energy(&cloth, &SHEET.units) / before
        }};
    }
    let still = [0.0; 3];
    let [aerodynamic, panel] =
        [left!(SHEET.aerodynamic_wind(still, 1.2, 1.2)), left!(SHEET.panel_wind(still, 1.2, 1.2))];
    assert!(aerodynamic < 0.99 && panel < 0.99, "{aerodynamic} {panel}");
    assert_eq!(left!(SHEET.facet_wind(still)), 1.0);
}

/// The number of particles that touch the ball of the scene `no-shear` after 2.4 s.
fn carried(shear: &str) -> usize {
    let text = format!("{}\n{shear}", built_in("no-shear").unwrap().text);
    let scene = Description::parse(&text).unwrap();
    let mut simulation = scene.simulation_on::<Everything, f32, 32, 32>().unwrap();
    (0..24).for_each(|_| simulation.frame());
    let ball = scene.spheres[0];
    let reach = ball.radius + ball.surface.margin;
    let far = |place: &[f64; 3]| (0..3).map(|axis| (place[axis] - ball.centre[axis]).powi(2)).sum::<f64>().sqrt();
    simulation.still().positions.iter().filter(|place| far(place) < 1.01 * reach).count()
}

/// The caption of `shear.png`.
#[test]
fn without_shear_the_sheet_lies_on_the_ball() {
    let [without, with] = ["", "[shear]\nstiffness = 9427.0"].map(carried);
    assert!(with > 0 && without > 3 * with, "{without} particles without shear links, {with} with them");
}
