//! Slow motion is not rest.

use kerchief::force::Force;
use kerchief::{
    Cloth, Drag, Gravity, Lines, Node, Q13, Q24, Resting, Scalar, Scene, Shear, Sphere, Stillness, Stretch, Units,
    Vec3, Xpbd, measure,
};

const UNITS: Units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
const STILL: Stillness = Stillness::DEFAULT;

type Sheet<S> = Cloth<S, 4, 4>;

fn gravity<S: Scalar>(acceleration: f64) -> Gravity<S> {
    Gravity::new(UNITS.acceleration([0.0, 0.0, -acceleration]))
}

fn springs<S: Scalar>() -> (Stretch<S>, Shear<S>) {
    (Stretch::new(&UNITS, UNITS.stiffness(50.0)), Shear::new(&UNITS, UNITS.stiffness(5.0)))
}

/// How far a sheet that starts without velocity falls in a minute, m.
fn fallen<S: Scalar>(forces: impl Force<S>) -> f64 {
    let scene = Scene::new(&UNITS, forces, springs::<S>(), (), Resting::new(&UNITS, STILL, Xpbd));
    let mut cloth = Sheet::<S>::lay(&UNITS, UNITS.point([0.0; 3]));
    let mut memory = scene.memory::<S, 4, 4>();
    (0..3600).for_each(|_| scene.step(&mut cloth, &mut memory));
    -measure::bounds(&cloth)[1].z.to_f64() * UNITS.cell
}

/// Sheets that sink steadily, limited by drag to less than the speed threshold of [`Stillness`]. They keep moving, so they are not at rest.
fn creeping_goes_on<S: Scalar>(slowest: f64) {
    for speed in [0.98, 0.5, slowest] {
        let speed = speed * STILL.speed;
        for drag in [1e4, 30.0] {
            let sunk = fallen::<S>((gravity(drag * speed), Drag::new(UNITS.drag(drag))));
            let expected = 60.0 * speed - speed / drag;
            assert!((sunk / expected - 1.0).abs() < 0.03, "{sunk} m instead of {expected} in {}", S::NAME);
        }
    }
    // slower than a tenth of the threshold is at rest, by definition
    assert!(fallen::<S>((gravity(3e-3), Drag::new(UNITS.drag(100.0)))) < 1e-3);
}

/// A fall that drag limits to little more than the speed threshold, and one with little more than the threshold of acceleration, a ten-thousandth of gravity.
fn slow_falls_go_on<S: Scalar>() {
    let sunk = fallen::<S>((gravity(9.81), Drag::new(UNITS.drag(9.81 / (1.2 * STILL.speed)))));
    assert!((sunk / (60.0 * 1.2 * STILL.speed) - 1.0).abs() < 0.02, "{sunk} m in {}", S::NAME);
    let (accelerated, drag) = (1.2 * STILL.acceleration, 0.2);
    // x = a/γ·(t − (1 − exp(−γt))/γ)
    let expected = accelerated / drag * (60.0 - (1.0 - (-drag * 60.0_f64).exp()) / drag);
    let found = fallen::<S>((gravity(accelerated), Drag::new(UNITS.drag(drag))));
    // the velocity gained in a substep is seven units of the last place of q24
    assert!((found / expected - 1.0).abs() < 0.08, "{found} m instead of {expected} in {}", S::NAME);
    // a motion of less than speed · time / 10 is at rest, by definition; here the fall gains two units in a substep
    assert!(fallen::<S>(gravity(0.344 * STILL.acceleration)) < 1e-3);
}

/// Frames at rest in a minute of a swing with this amplitude (m). The sheet hangs from one edge, in gravity so weak that its period is `PERIOD`.
fn frames_at_rest<S: Scalar>(amplitude: f64) -> u32 {
    // a plate of length ℓ that hangs from an edge swings like a pendulum of length ⅔·ℓ
    const PERIOD: f64 = 6.0;
    let weight = (core::f64::consts::TAU / PERIOD).powi(2) * 0.2;
    let scene =
        Scene::new(&UNITS, gravity::<S>(weight), springs::<S>(), (), Resting::new(&UNITS, STILL, Lines::default()));
    let mut cloth = Sheet::<S>::hang(&UNITS, UNITS.point([0.0; 3]));
    (0..4).for_each(|column| cloth.pin(Node::new(column, 0)));
    for row in 1..4 {
        let out = amplitude * row as f64 / 3.0;
        (0..4).for_each(|column| cloth.position.add(Node::new(column, row), UNITS.point([0.0, out, 0.0]).to_vec()));
    }
    let mut memory = scene.memory();
    let mut at_rest = 0;
    for _ in 0..3600 {
        scene.step(&mut cloth, &mut memory);
        at_rest += u32::from(memory.is_at_rest());
    }
    at_rest
}

/// At its turning points a swing has zero speed, and the acceleration amplitude·ω².
fn slow_swings_go_on<S: Scalar>() {
    // 4 mm at ω = 1.05/s: 4.2 mm/s, 4.4 mm/s²
    assert_eq!(frames_at_rest::<S>(4e-3), 0, "in {}", S::NAME);
    // 0.1 mm/s, 0.1 mm/s²
    assert!(frames_at_rest::<S>(1e-4) > 1000, "in {}", S::NAME);
}

/// A pin that travels at a tenth of the speed threshold, and a ball as slow that comes to touch the sheet.
fn slow_hands_are_followed<S: Scalar>() {
    let slow = 0.1 * STILL.speed;
    let ball = Sphere::new(UNITS.point([0.1, 0.061, -0.2]), UNITS.length(0.05), UNITS.length(0.01));
    let ball = ball.with_velocity(UNITS.velocity([0.0, -slow, 0.0]));
    let forces = (gravity::<S>(9.81), Drag::new(UNITS.drag(4.0)));
    let mut scene = Scene::new(&UNITS, forces, springs::<S>(), ball, Resting::new(&UNITS, STILL, Lines::default()));
    let mut cloth = Sheet::<S>::hang(&UNITS, UNITS.point([0.0; 3]));
    (0..4).for_each(|column| cloth.pin(Node::new(column, 0)));
    let mut memory = scene.memory();
    let corner = cloth.position.at(Node::new(0, 0)).to_f64();
    let velocity = Vec3::from_f64(UNITS.velocity([slow, 0.0, 0.0]).0);
    cloth.velocity.set(Node::new(0, 0), velocity);
    for _ in 0..3600 {
        scene.play(&mut cloth, &mut memory);
    }
    let travelled = (cloth.position.at(Node::new(0, 0)).to_f64()[0] - corner[0]) * UNITS.cell;
    assert!((travelled / (60.0 * slow) - 1.0).abs() < 0.02, "the pin went {travelled} m in {}", S::NAME);
    let pushed = -measure::bounds(&cloth)[0].y.to_f64() * UNITS.cell;
    assert!((3e-3..8e-3).contains(&pushed), "the ball pushed the sheet by {pushed} m in {}", S::NAME);
}

#[test]
fn falls() {
    slow_falls_go_on::<f32>();
    slow_falls_go_on::<f64>();
    slow_falls_go_on::<Q24>();
    slow_falls_go_on::<Q13>();
}

#[test]
fn creeping() {
    creeping_goes_on::<f32>(0.15);
    creeping_goes_on::<f64>(0.15);
    creeping_goes_on::<Q24>(0.15);
    // q13's distance threshold: a thousandth of a cell in half a second
    creeping_goes_on::<Q13>(0.3);
}

#[test]
fn swings() {
    slow_swings_go_on::<f32>();
    slow_swings_go_on::<f64>();
    slow_swings_go_on::<Q24>();
}

#[test]
fn hands() {
    slow_hands_are_followed::<f32>();
    slow_hands_are_followed::<f64>();
    slow_hands_are_followed::<Q24>();
    slow_hands_are_followed::<Q13>();
}
