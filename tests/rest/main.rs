//! A settled sheet is not computed: it costs next to nothing, keeps its bits, and wakes on any change. A sheet that moves slowly is not settled.

mod cost;
mod restored;
mod settled;
mod slow;
mod still;
mod trembling;
mod wake;

use kerchief::rest::RestingMemory;
use kerchief::{
    BackwardEuler, Bend, Cloth, Damped, Drag, Gravity, Leapfrog, Lines, Moving, Node, Q13, Q24, Resting, Scalar, Scene,
    Shear, Solver, Sphere, Stillness, Stretch, Units, Vec3, Verlet, Xpbd,
};

/// Particles a side.
const SIDE: usize = 8;
const UNITS: Units = Units::sheet([SIDE, SIDE], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
const DOWN: [f64; 3] = [0.0, 0.0, -9.81];

type Forces<S> = (Gravity<S>, Drag<S>, Option<kerchief::FacetWind<S>>);
type Springs<S> = (Damped<Stretch<S>, S>, Shear<S>, Bend<S>);
type Described<S, V> = Scene<Forces<S>, Springs<S>, Moving<Sphere<S>>, V>;
type Sheet<S> = Cloth<S, SIDE, SIDE>;

/// A curtain under gravity and drag, with a ball beside it, and its start.
fn curtain<S: Scalar, V: Solver<S>>(solver: V) -> (Described<S, V>, Sheet<S>) {
    let mut cloth = Sheet::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
    (0..SIDE).for_each(|column| cloth.pin(Node::new(column, 0)));
    // pushed, so that it swings
    cloth.velocity.change(|_| Vec3::from_f64(UNITS.velocity([0.1, 0.2, 0.0]).0));
    (0..SIDE).for_each(|column| cloth.pin(Node::new(column, 0)));
    let forces = (Gravity::new(UNITS.acceleration(DOWN)), Drag::new(UNITS.drag(4.0)), None);
    let stretch = Damped::new(Stretch::new(&UNITS, UNITS.stiffness(50.0)), UNITS.damping(0.01));
    let links = (stretch, Shear::new(&UNITS, UNITS.stiffness(5.0)), Bend::new(&UNITS, UNITS.stiffness(1.0)));
    let ball = Sphere::new(UNITS.point([0.15, 0.4, 0.1]), UNITS.length(0.1), UNITS.length(0.01));
    let ball = ball.with_velocity(UNITS.velocity([0.0; 3]));
    (Scene::new(&UNITS, forces, links, ball, solver), cloth)
}

fn resting<V>(solver: V) -> Resting<V> {
    Resting::new(&UNITS, Stillness::DEFAULT, solver)
}

/// A test that runs with any solver that keeps the curtain stable.
trait Trial {
    fn with<S: Scalar, V: Solver<S> + Copy>(&self, name: &str, solver: V)
    where
        V::Memory<Springs<S>, SIDE, SIDE>: Clone;
}

/// A trial of every solver in every number type, without forward Euler, which is unstable where drag alone damps springs.
fn every_solver(trial: &impl Trial) {
    fn every<S: Scalar>(trial: &impl Trial) {
        trial.with::<S, _>("lines", Lines::default());
        trial.with::<S, _>("xpbd", Xpbd);
        trial.with::<S, _>("verlet", Verlet { sweeps: 4 });
        trial.with::<S, _>("leapfrog", Leapfrog);
        trial.with::<S, _>("backward Euler", BackwardEuler { newton_steps: 2 });
    }
    every::<f32>(trial);
    every::<f64>(trial);
    every::<Q24>(trial);
    every::<Q13>(trial);
}

/// The number of frames until the sheet is at rest; `None` if that takes more than `most`.
fn settle<S: Scalar, V: Solver<S>>(
    scene: &Described<S, Resting<V>>,
    cloth: &mut Sheet<S>,
    memory: &mut RestingMemory<V::Memory<Springs<S>, SIDE, SIDE>, S, SIDE, SIDE>,
    most: u32,
) -> Option<u32> {
    (1..=most).find(|_| {
        scene.step_one(cloth, memory);
        memory.is_at_rest()
    })
}
