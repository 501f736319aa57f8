//! A hand drags a sheet as far as the sheet reaches, with every solver in `f32`, `Q24` and `Q13`, and does not overstretch it.

use kerchief::{
    BackwardEuler, Bend, Cloth, Damped, Drag, ForwardEuler, Gravity, Hand, Leapfrog, Lines, Node, Q13, Q24, Resting,
    Scalar, Scene, Shear, Solver, Stillness, Stretch, Units, Verlet, Xpbd, measure,
};

const SIDE: usize = 12;
const HELD: Node = Node::new(6, 11);

type Links<S> = (Damped<Stretch<S>, S>, Shear<S>, Bend<S>);
type Forces<S> = (Gravity<S>, Drag<S>, Hand<S>);

struct Play<S: Scalar, V: Solver<S>> {
    units: Units,
    cloth: Cloth<S, SIDE, SIDE>,
    scene: Scene<Forces<S>, Links<S>, (), V>,
    memory: V::Memory<Links<S>, SIDE, SIDE>,
}

impl<S: Scalar, V: Solver<S>> Play<S, V> {
    /// A sheet of 29 g that hangs from two corners, and an empty hand with a force of up to a newton, three and a half times the sheet's weight.
    fn new(solver: V, substeps: u32, stiffness: f64) -> Self {
        let units = Units::sheet([SIDE, SIDE], [0.3, 0.3], 2e-4, 1.0 / 60.0, substeps);
        let mut cloth = Cloth::hang(&units, units.point([-0.15, 0.0, 0.3]));
        cloth.pin(Node::new(0, 0));
        cloth.pin(Node::new(SIDE - 1, 0));
        let hand = Hand::new(&units, units.compliance(0.1), units.damping(0.3), units.length(0.1));
        let forces = (Gravity::new(units.acceleration([0.0, 0.0, -9.81])), Drag::new(units.drag(1.0)), hand);
        let links = (
            Damped::new(Stretch::new(&units, units.stiffness(stiffness)), units.damping(0.01)),
            Shear::new(&units, units.stiffness(0.1 * stiffness)),
            Bend::new(&units, units.stiffness(0.01 * stiffness)),
        );
        let scene = Scene::new(&units, forces, links, (), solver);
        let memory = scene.memory();
        Self { units, cloth, scene, memory }
    }

    fn frames(&mut self, count: u32) -> f64 {
        let mut strain: f64 = 0.0;
        for _ in 0..count {
            self.scene.step(&mut self.cloth, &mut self.memory);
            assert!(measure::is_finite(&self.cloth), "in {}", S::NAME);
            strain = strain.max(measure::strain(&self.cloth, &self.scene.links.0).largest.to_f64());
        }
        strain
    }

    /// The position of the grabbed particle, m.
    fn held(&self) -> [f64; 3] {
        self.units.metres(self.cloth.position.at(HELD))
    }

    fn drag(&mut self, metres: [f64; 3]) {
        self.scene.forces.2.drag_to(self.units.point(metres).to_vec());
    }
}

/// Dragged within reach, the particle arrives at its target, up to the offset that weight and compliance cause. Dropped, it swings back.
fn follows<S: Scalar, V: Solver<S>>(name: &str, solver: V, substeps: u32, stiffness: f64, strain: f64) {
    let mut play = Play::<S, V>::new(solver, substeps, stiffness);
    play.frames(40);
    let start = play.held();
    play.scene.forces.2.grab(&play.cloth, HELD);
    for frame in 1..=60 {
        play.drag([start[0], -0.1 * f64::from(frame) / 60.0, start[2] + 0.05 * f64::from(frame) / 60.0]);
        play.frames(1);
    }
    let worst = play.frames(120);
    let [_, y, z] = play.held();
    let off = (y + 0.1).hypot(z - start[2] - 0.05);
    // the weight of 29 g (0.29 N) at 0.1 m/N
    assert!(off < 0.029, "{name} in {}: {off} m from the target", S::NAME);
    assert!(worst < strain, "{name} in {}: strained by {worst}", S::NAME);
    assert_eq!(play.scene.forces.2.drop(), Some(HELD));
    let dropped = play.units.metres_per_second(play.cloth.velocity.at(HELD));
    assert!(dropped.iter().all(|speed| speed.abs() < 0.2), "{name} in {}: dropped at {dropped:?} m/s", S::NAME);
    assert_eq!(play.cloth.inverse_mass[HELD], S::ONE);
    play.frames(300);
    let end = play.held();
    let back = (0..3).map(|k| (end[k] - start[k]).powi(2)).sum::<f64>().sqrt();
    assert!(back < 0.02, "{name} in {}: {back} m from where it hung", S::NAME);
}

/// Dragged out of reach at 30 m/s, the sheet is pulled taut and not overstretched.
fn does_not_tear<S: Scalar, V: Solver<S>>(name: &str, solver: V, substeps: u32, stiffness: f64, strain: f64) {
    let mut play = Play::<S, V>::new(solver, substeps, stiffness);
    play.frames(30);
    play.scene.forces.2.grab(&play.cloth, HELD);
    let mut worst: f64 = 0.0;
    for frame in 0..90 {
        let away = 0.5 * f64::from(frame.min(4));
        play.drag([0.3 * away, -away, 0.3 - 0.2 * away]);
        worst = worst.max(play.frames(1));
    }
    assert!(worst < strain, "{name} in {}: strained by {worst}", S::NAME);
    let [x, y, z] = play.held();
    // a sheet of 0.3 m that hangs from its upper corners
    let reached = x.hypot(y).hypot(z - 0.3);
    assert!(reached > 0.25 && reached < 0.3 * (1.0 + strain), "{name} in {}: {reached} m", S::NAME);
}

fn in_all<S: Scalar>() {
    follows::<S, _>("lines", Lines::default(), 8, 500.0, 0.03);
    follows::<S, _>("xpbd", Xpbd, 16, 500.0, 0.2);
    follows::<S, _>("verlet", Verlet { sweeps: 8 }, 4, 500.0, 0.2);
    follows::<S, _>("backward Euler", BackwardEuler { newton_steps: 2 }, 4, 500.0, 0.05);
    follows::<S, _>("leapfrog", Leapfrog, 32, 50.0, 0.1);
    does_not_tear::<S, _>("lines", Lines::default(), 8, 500.0, 0.1);
    does_not_tear::<S, _>("xpbd", Xpbd, 16, 500.0, 0.3);
    does_not_tear::<S, _>("verlet", Verlet { sweeps: 8 }, 4, 500.0, 0.3);
    does_not_tear::<S, _>("backward Euler", BackwardEuler { newton_steps: 2 }, 4, 500.0, 0.2);
    // a newton on one particle strains springs of 50 N/m by a half
    does_not_tear::<S, _>("leapfrog", Leapfrog, 32, 50.0, 0.6);
    does_not_tear::<S, _>("forward Euler", ForwardEuler, 64, 20.0, 1.5);
}

#[test]
fn hands_drag_and_do_not_tear_in_f32() {
    in_all::<f32>();
}

#[test]
fn hands_drag_and_do_not_tear_in_q24() {
    in_all::<Q24>();
}

#[test]
fn hands_drag_and_do_not_tear_in_q13() {
    in_all::<Q13>();
}

/// The hand's spring is part of the equation that all solvers approximate: they converge.
#[test]
fn solvers_agree_on_a_sheet_that_is_dragged() {
    fn end<V: Solver<f64>>(solver: V, substeps: u32) -> [f64; 3] {
        let mut play = Play::<f64, V>::new(solver, substeps, 50.0);
        play.scene.forces.2.grab(&play.cloth, HELD);
        play.drag([0.05, -0.08, 0.05]);
        play.frames(20);
        play.held()
    }
    let exact = end(Leapfrog, 512);
    let off = |found: [f64; 3]| (0..3).map(|k| (found[k] - exact[k]).powi(2)).sum::<f64>().sqrt();
    let lines = [64, 128].map(|substeps| off(end(Lines::default(), substeps)));
    assert!(lines[1] < 1e-4 && lines[1] < 0.4 * lines[0], "lines: {lines:?}");
    let leapfrog = [64, 128].map(|substeps| off(end(Leapfrog, substeps)));
    assert!(leapfrog[1] < 2e-3 && leapfrog[1] < 0.6 * leapfrog[0], "leapfrog: {leapfrog:?}");
    for (name, errors) in [
        ("xpbd", [64, 128].map(|substeps| off(end(Xpbd, substeps)))),
        ("verlet", [64, 128].map(|substeps| off(end(Verlet { sweeps: 4 }, substeps)))),
        ("forward Euler", [128, 256].map(|substeps| off(end(ForwardEuler, substeps)))),
        ("backward Euler", [64, 128].map(|substeps| off(end(BackwardEuler { newton_steps: 2 }, substeps)))),
    ] {
        assert!(errors[1] < 5e-3 && errors[1] < 0.7 * errors[0], "{name}: {errors:?}");
    }
}

/// A sheet in a motionless hand comes to rest, and wakes when it is dragged on or dropped.
#[test]
fn a_sheet_at_rest_wakes_when_the_hand_moves() {
    fn check<S: Scalar>() {
        let units = Units::sheet([SIDE, SIDE], [0.3, 0.3], 2e-4, 1.0 / 60.0, 8);
        let solver = Resting::new(&units, Stillness::DEFAULT, Lines::default());
        let mut play = Play::<S, _>::new(solver, 8, 50.0);
        play.scene.forces.1 = Drag::new(units.drag(4.0));
        let settle = |play: &mut Play<S, Resting<Lines>>| {
            (0..3600).any(|_| {
                play.frames(1);
                play.memory.is_at_rest()
            })
        };
        play.scene.forces.2.grab(&play.cloth, HELD);
        play.drag([0.0, -0.1, 0.05]);
        assert!(settle(&mut play), "it never rests in {}", S::NAME);
        play.drag([0.0, -0.1, 0.06]);
        play.frames(1);
        assert!(!play.memory.is_at_rest(), "dragged in {}", S::NAME);
        assert!(settle(&mut play), "it never rests in {}", S::NAME);
        play.scene.forces.2.drop();
        play.frames(1);
        assert!(!play.memory.is_at_rest(), "dropped in {}", S::NAME);
    }
    check::<f32>();
    check::<Q24>();
}
