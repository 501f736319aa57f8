//! A flag that blows for ten minutes, in the long version (`KERCHIEF_LONG=1`) for a day. Fixed point must neither overflow nor drift.

use kerchief::Cloth;
use kerchief::{
    AerodynamicWind, Damped, Drag, Gravity, Lines, Node, Q13, Q24, Scalar, Scene, Shear, Stretch, Units, measure,
};

use crate::is_long;

const MINUTE: u32 = 3600;
const TEN_MINUTES: u32 = 10 * MINUTE;
const DAY: u32 = 24 * 60 * MINUTE;

const SIDE: usize = 8;
const SIZE: f64 = 0.3;
const UNITS: Units = Units::sheet([SIDE, SIDE], [SIZE, SIZE], 3e-4, 1.0 / 60.0, 2);

/// `expected` is the flag's digest after ten minutes.
fn blow<S: Scalar>(expected: u32) {
    let mut cloth = Cloth::<S, SIDE, SIDE>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.5 * SIZE]));
    (0..SIDE).for_each(|row| cloth.pin(Node::new(0, row)));
    let pins: [_; SIDE] = core::array::from_fn(|row| cloth.position.at(Node::new(0, row)));
    let forces = (
        Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])),
        Drag::new(UNITS.drag(0.2)),
        AerodynamicWind::new(UNITS.aerodynamic_wind([6.0, 1.5, 0.3], 1.2, 1.2)),
    );
    let links = (
        Damped::new(Stretch::new(&UNITS, UNITS.stiffness(40.0)), UNITS.damping(1e-3)),
        Shear::new(&UNITS, UNITS.stiffness(2.0)),
    );
    let scene = Scene::new(&UNITS, forces, links, (), Lines::default());
    let mut memory = scene.memory();
    let long = is_long();
    // the middle of the free edge: its distance from the pole and its height, as means over each minute, m
    let (mut means, mut sum) = (Vec::new(), [0.0; 2]);
    for frame in 1..=if long { DAY } else { TEN_MINUTES } {
        scene.step(&mut cloth, &mut memory);
        let [low, high] = measure::bounds(&cloth).map(|corner| corner.to_f64().map(|cells| cells * UNITS.cell));
        let reach = low.into_iter().chain(high).fold(0.0, |reach: f64, x| reach.max(x.abs()));
        assert!(reach < 1.2 * SIZE, "{}: {reach} m from the middle of its pole after {frame} frames", S::NAME);
        let [x, _, z] = cloth.position.at(Node::new(SIDE - 1, SIDE / 2)).to_f64();
        sum = [sum[0] + x, sum[1] + z];
        if frame % MINUTE == 0 {
            means.push(sum.map(|sum| sum / f64::from(MINUTE) * UNITS.cell));
            sum = [0.0; 2];
        }
        if frame == TEN_MINUTES {
            let digest = measure::digest(&cloth);
            assert_eq!(
                digest,
                expected,
                "{} after {frame} frames: {digest:#010x} instead of {expected:#010x}",
                S::NAME
            );
        }
    }
    for (row, pin) in pins.into_iter().enumerate() {
        assert_eq!(cloth.position.at(Node::new(0, row)), pin, "the pole bends");
    }
    let first = means[1];
    for (minute, mean) in means.iter().enumerate().skip(1) {
        let creep = (0..2).map(|k| (mean[k] - first[k]).abs()).fold(0.0, f64::max);
        assert!(
            creep < 0.05 * SIZE,
            "{}: the mean position in minute {minute} is {creep} m from that in minute 1",
            S::NAME
        );
    }
}

#[test]
fn a_flag_blows_on() {
    blow::<Q13>(0xe9dd_6bd1);
    blow::<Q24>(0x0701_c8d5);
}
