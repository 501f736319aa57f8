//! Abuse by pins, balls, wind and gravity.

use std::f64::consts::TAU;

use kerchief::{
    AerodynamicWind, BackwardEuler, FacetWind, Lines, Node, Q13, Q24, Scalar, Solver, Sphere, Verlet, Xpbd,
};

use crate::ordeal::{Ordeal, all};
use crate::stage::{CLOTH, DOWN, Sheet, Stage, corners};

/// Both pins are shaken to and fro by 20 % of the sheet's size, with this frequency, 1/s.
struct Shaken(f64);

impl Ordeal for Shaken {
    fn sheet(&self) -> Sheet {
        CLOTH
    }
    fn frames(&self) -> u32 {
        120
    }
    fn disturb<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(
        &self,
        stage: &mut Stage<S, V, W, H>,
        frame: u32,
    ) {
        let place = |frame: u32| 0.2 * CLOTH.size * (TAU * self.0 * f64::from(frame) * CLOTH.frame).sin();
        let way = place(frame + 1) - place(frame);
        corners::<W>().into_iter().for_each(|pin| stage.carry(pin, [0.3 * way, way, 0.0]));
    }
    fn end<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>) {
        corners::<W>().into_iter().for_each(|pin| stage.carry(pin, [0.0; 3]));
    }
}

#[test]
fn pins_are_shaken() {
    for frequency in [0.5, 5.0] {
        all(&format!("pins shaken at {frequency} Hz"), &Shaken(frequency));
    }
}

/// A ball with a radius of a fifth of the size is fired through the middle of the sheet at this speed, m/s.
struct Fired(f64);

impl Ordeal for Fired {
    fn sheet(&self) -> Sheet {
        CLOTH
    }
    fn frames(&self) -> u32 {
        (3.0 / self.0 / CLOTH.frame).ceil() as u32 + 30
    }
    fn begin<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>) {
        let units = stage.units;
        let ball = Sphere::new(units.point([0.0, -1.0, 0.05]), units.length(0.2), units.length(0.02));
        stage.scene.colliders = ball.with_velocity(units.velocity([0.0, self.0, 0.0])).with_friction(0.5);
    }
    fn disturb<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>, _: u32) {
        // once it has passed through, it stops out of reach of the sheet
        let units = stage.units;
        if stage.scene.colliders.centre.y.to_f64() * units.cell > 2.0 {
            stage.scene.colliders.turn(units.velocity([0.0; 3]));
        }
    }
    fn end<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>) {
        let units = stage.units;
        let nowhere = Sphere::new(units.point([0.0, 2.5, 0.0]), units.length(0.01), units.length(0.0));
        stage.scene.colliders = nowhere.with_velocity(units.velocity([0.0; 3]));
    }
    // a corner that the ball pushed through its neighbours stays there
    fn left(&self) -> f64 {
        0.6
    }
}

#[test]
fn a_ball_is_fired_through() {
    for speed in [2.0, 100.0] {
        all(&format!("a ball fired at {speed} m/s"), &Fired(speed));
    }
}

/// A storm of 100 m/s whose direction turns, for two seconds.
struct Storm {
    aerodynamic: bool,
}

impl Ordeal for Storm {
    fn sheet(&self) -> Sheet {
        CLOTH
    }
    fn frames(&self) -> u32 {
        120
    }
    fn disturb<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(
        &self,
        stage: &mut Stage<S, V, W, H>,
        frame: u32,
    ) {
        let units = stage.units;
        let angle = 0.02 * f64::from(frame);
        let wind = [100.0 * angle.sin(), 100.0 * angle.cos(), 10.0];
        if self.aerodynamic {
            stage.scene.forces.3 = Some(AerodynamicWind::new(units.aerodynamic_wind(wind, 1.2, 1.2)));
        } else {
            stage.scene.forces.2 = Some(FacetWind::new(units.facet_wind(wind)));
        }
    }
    fn end<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>) {
        (stage.scene.forces.2, stage.scene.forces.3) = (None, None);
    }
}

#[test]
fn a_storm_blows() {
    all("facet wind of 100 m/s", &Storm { aerodynamic: false });
    all("aerodynamic wind of 100 m/s", &Storm { aerodynamic: true });
}

/// Gravity of a random direction in every frame, with components of up to four times 9.81 m/s².
struct Tumbled;

impl Ordeal for Tumbled {
    fn sheet(&self) -> Sheet {
        CLOTH
    }
    fn frames(&self) -> u32 {
        120
    }
    fn disturb<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>, _: u32) {
        let gravity = stage.random_vector(4.0 * DOWN[2].abs());
        stage.gravity(gravity);
    }
}

#[test]
fn weight_switches_in_every_frame() {
    all("gravity at random", &Tumbled);
}

/// Two corners are pulled apart to twice the sheet's width, and brought together again.
struct Torn;

impl Ordeal for Torn {
    fn sheet(&self) -> Sheet {
        CLOTH
    }
    fn frames(&self) -> u32 {
        120
    }
    fn disturb<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(
        &self,
        stage: &mut Stage<S, V, W, H>,
        frame: u32,
    ) {
        let outward = 0.5 * CLOTH.size / 40.0 * [1.0, 0.0, -1.0][(frame / 40) as usize];
        for (pin, side) in corners::<W>().into_iter().zip([-1.0, 1.0]) {
            stage.carry(pin, [side * outward, 0.0, 0.0]);
        }
    }
    fn end<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(&self, stage: &mut Stage<S, V, W, H>) {
        corners::<W>().into_iter().for_each(|pin| stage.carry(pin, [0.0; 3]));
    }
}

#[test]
fn corners_are_pulled_apart() {
    all("corners pulled apart", &Torn);
}

/// In any step, wind accelerates a free sheet to at most 1.2 times its own velocity, and to more than half of it in the end.
fn no_faster_than_the_wind<S: Scalar, V: Solver<S> + Copy>(name: &str, solver: V) {
    for (frame, substeps) in [(1e-3, 1), (1.0 / 60.0, 8), (1.0 / 60.0, 1), (0.2, 8)] {
        let sheet = Sheet { frame, substeps, drag: 0.0, stretch: 100.0, shear: 10.0, bend: 1.0, ..CLOTH };
        let mut stage = Stage::<S, V, 8, 8>::new(&sheet, solver);
        let wind = stage.units.aerodynamic_wind([0.0, 40.0, 0.0], 1.2, 1.2);
        stage.cloth.inverse_mass.values_mut().for_each(|mass| *mass = S::ONE);
        stage.gravity([0.0; 3]);
        stage.scene.forces.3 = Some(AerodynamicWind::new(wind));
        let mut fastest = 0.0_f64;
        // the range of q24 is 18 m
        for _ in 0..(0.35 / frame).ceil() as u32 {
            stage.step();
            fastest = fastest.max(stage.speed());
        }
        let middle = stage.cloth.velocity.at(Node::new(3, 3)).to_f64()[1] * stage.units.cell / stage.units.tick();
        assert!(
            fastest < 1.2 * 40.0 && middle > 0.5 * 40.0,
            "{name} in {}, frames of {frame} s: {fastest} m/s, {middle} m/s",
            S::NAME
        );
    }
}

#[test]
fn nothing_is_faster_than_the_wind() {
    fn every<S: Scalar>() {
        no_faster_than_the_wind::<S, Lines>("lines", Lines::new());
        no_faster_than_the_wind::<S, _>("xpbd", Xpbd);
        no_faster_than_the_wind::<S, _>("verlet", Verlet { sweeps: 4 });
        no_faster_than_the_wind::<S, _>("backward Euler", BackwardEuler { newton_steps: 1 });
    }
    every::<f32>();
    every::<f64>();
    every::<Q24>();
    every::<Q13>();
}
