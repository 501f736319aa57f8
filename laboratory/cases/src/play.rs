//! Plays a scene in any number type by any solver, without the standard library: boards can run it, too.

use kerchief::collider::{Contact, Moving};
use kerchief::link::{Visitor, WithDampers};
use kerchief::{
    AerodynamicWind, BackwardEuler, Bend, Capsule, Cloth, Collider, Damped, Drag, FacetWind, ForwardEuler, Gravity,
    Leapfrog, Lines, Links, Moment, Node, PanelWind, Particles, Plane, Q13, Q24, Scalar, Scene, Shear, Solver, Sphere,
    StrainLimited, Stretch, Tether, Units, Vec3, Verlet, Xpbd, measure,
};

use crate::setup::{self, Mass, SIDE, Setup, Surface, Wind};

/// A number type, with a function that plays scenes in it.
#[derive(Clone, Copy, Debug)]
pub struct Number {
    /// Its name.
    pub name: &'static str,
    /// Plays a scene, and passes the digest after every frame to the closure.
    pub play: fn(&Setup, Method, &mut dyn FnMut(u32)) -> Outcome,
}

const fn number<S: Scalar>() -> Number {
    Number { name: S::NAME, play: play::<S> }
}

/// Every number type, in the order of the table. Boards leave out f64: without a unit for it they would take minutes. This is a static, so that the generic code is compiled
/// in this crate only, not again in each program.
pub static NUMBERS: &[Number] = &[
    number::<f32>(),
    #[cfg(not(target_os = "none"))]
    number::<f64>(),
    number::<Q24>(),
    number::<Q13>(),
];

/// The solver that plays a scene.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// [`ForwardEuler`](kerchief::ForwardEuler)
    ForwardEuler,
    /// [`BackwardEuler`](kerchief::BackwardEuler)
    BackwardEuler,
    /// [`Verlet`](kerchief::Verlet)
    Verlet,
    /// [`Leapfrog`](kerchief::Leapfrog)
    Leapfrog,
    /// [`Xpbd`](kerchief::Xpbd)
    Xpbd,
    /// [`Lines`](kerchief::Lines)
    Lines,
}

/// Every solver.
pub const METHODS: [Method; 6] =
    [Method::ForwardEuler, Method::BackwardEuler, Method::Verlet, Method::Leapfrog, Method::Xpbd, Method::Lines];

/// The result of a run.
#[derive(Clone, Copy, Debug)]
pub struct Outcome {
    /// Whether all numbers of the sheet are finite.
    pub finite: bool,
    /// The corners of the box around the sheet, cells.
    pub bounds: [[f64; 3]; 2],
}

/// The frames and substeps of a run.
struct Pace {
    /// The length of a frame, as a multiple of the scene's own frame.
    part: f64,
    substeps: u32,
    frames: u32,
}

/// Plays `setup` in numbers of type `S` and passes the digest after every frame to `frame`.
fn play<S: Scalar>(setup: &Setup, method: Method, frame: &mut dyn FnMut(u32)) -> Outcome {
    // Verlet, XPBD and lines play long enough for the thesis' sheets to touch the ball. Explicit solvers are stable for tiny steps only. Three and six are no powers of two.
    match method {
        Method::ForwardEuler => {
            run::<S, _>(setup, ForwardEuler, &Pace { part: 1.0 / 64.0, substeps: 16, frames: 3 }, frame)
        }
        Method::BackwardEuler => {
            let solver = BackwardEuler { newton_steps: 1 };
            run::<S, _>(setup, solver, &Pace { part: 1.0, substeps: 2, frames: 1 }, frame)
        }
        Method::Verlet => run::<S, _>(setup, Verlet { sweeps: 3 }, &Pace { part: 1.5, substeps: 2, frames: 8 }, frame),
        Method::Leapfrog => run::<S, _>(setup, Leapfrog, &Pace { part: 1.0 / 16.0, substeps: 6, frames: 3 }, frame),
        Method::Xpbd => run::<S, _>(setup, Xpbd, &Pace { part: 1.5, substeps: 3, frames: 8 }, frame),
        Method::Lines => run::<S, _>(setup, Lines::default(), &Pace { part: 1.5, substeps: 2, frames: 8 }, frame),
    }
}

fn run<S: Scalar, V: Solver<S>>(setup: &Setup, solver: V, pace: &Pace, frame: &mut dyn FnMut(u32)) -> Outcome {
    let units = units(setup, pace);
    let mut cloth = sheet::<S>(setup, &units);
    let forces = (
        Gravity::new(units.acceleration(setup.gravity)),
        setup.drag.map(|drag| match drag {
            setup::Drag::Rate(rate) => Drag::new(units.drag(rate)),
            setup::Drag::Verlet(part) => Drag::new(units.verlet_damping(part)),
        }),
        match setup.wind {
            Some(Wind::Facet(wind)) => (Some(FacetWind::new(units.facet_wind(wind))), None, None),
            Some(Wind::Aerodynamic(wind)) => {
                (None, Some(AerodynamicWind::new(units.aerodynamic_wind(wind, 1.2, 1.2))), None)
            }
            Some(Wind::Panel(wind)) => (None, None, Some(PanelWind::new(units.panel_wind(wind, 1.2, 1.2)))),
            None => (None, None, None),
        },
    );
    let mut scene = Scene::new(&units, forces, Held::new(setup, &units), colliders(setup, &units), solver);
    let mut memory = scene.memory();
    for _ in 0..pace.frames {
        if let (Some(way), [[column, row], ..]) = (setup.hand, setup.pins) {
            let hand = Node::new(*column, *row);
            let target = cloth.position.at(hand) + Vec3::from_f64(way);
            scene.move_pin(&mut cloth, hand, target);
        }
        scene.play(&mut cloth, &mut memory);
        frame(measure::digest(&cloth));
    }
    Outcome { finite: measure::is_finite(&cloth), bounds: measure::bounds(&cloth).map(Vec3::to_f64) }
}

fn units(setup: &Setup, pace: &Pace) -> Units {
    let cells = (SIDE - 1) as f64;
    let mass = match setup.mass {
        Mass::PerParticle(mass) => mass,
        Mass::PerArea(density) => density * (setup.size[0] / cells) * (setup.size[1] / cells),
    };
    Units::sheet([SIDE; 2], setup.size, mass, setup.frame * pace.part, pace.substeps)
}

fn sheet<S: Scalar>(setup: &Setup, units: &Units) -> Cloth<S, SIDE, SIDE> {
    let origin = units.point(setup.origin);
    let mut cloth = if setup.upright { Cloth::hang(units, origin) } else { Cloth::lay(units, origin) };
    if let Mass::PerArea(_) = setup.mass {
        cloth.share_area();
    }
    if let Some(factor) = setup.hem {
        cloth.hem(S::from_f64(factor));
    }
    for &[column, row] in setup.pins {
        cloth.pin(Node::new(column, row));
    }
    cloth
}

type Springs<S> = (Damped<Stretch<S>, S>, Option<Damped<Shear<S>, S>>, Option<Damped<Bend<S>, S>>);

/// The links of a scene. Shear, bend, the limit and the tethers are optional.
struct Held<S: Scalar> {
    springs: Springs<S>,
    limit: Option<StrainLimited<Springs<S>, S>>,
    tether: Option<Tether<S, SIDE>>,
}

impl<S: Scalar> Held<S> {
    fn new(setup: &Setup, units: &Units) -> Self {
        let strengths = |spring: setup::Spring| (units.stiffness(spring.stiffness), units.damping(spring.damping));
        let (stiffness, damping) = strengths(setup.stretch);
        let springs = (
            Damped::new(Stretch::new(units, stiffness), damping),
            setup.shear.map(strengths).map(|(k, d)| Damped::new(Shear::new(units, k), d)),
            setup.bend.map(strengths).map(|(k, d)| Damped::new(Bend::new(units, k), d)),
        );
        let limit = setup.limit.map(|limit| StrainLimited::new(springs, limit));
        let tether = setup.tether.map(|slack| {
            let anchors: heapless::Vec<Node, SIDE> =
                setup.pins.iter().map(|&[column, row]| Node::new(column, row)).collect();
            let Ok(tether) = Tether::new(units, &anchors, slack) else {
                unreachable!("as many anchors as pins");
            };
            tether
        });
        Self { springs, limit, tether }
    }
}

impl<S: Scalar> Links<S> for Held<S> {
    type Directions = <Springs<S> as Links<S>>::Directions;
    type Damping = WithDampers;

    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        self.springs.springs(visitor);
    }

    fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
        self.springs.dampers(visitor);
    }

    fn confine<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, moment: Moment) {
        self.tether.confine(particles, moment);
        self.limit.confine(particles, moment);
    }
}

enum Obstacle<S> {
    Ball(Moving<Sphere<S>>),
    Rod(Capsule<S>),
    Ground(Plane<S>),
}

impl<S: Scalar> Collider<S> for Obstacle<S> {
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        match self {
            Self::Ball(ball) => ball.contact(moment, position, moved),
            Self::Rod(rod) => rod.contact(moment, position, moved),
            Self::Ground(ground) => ground.contact(moment, position, moved),
        }
    }

    fn advance(&mut self, end: Moment) {
        if let Self::Ball(ball) = self {
            ball.advance(end);
        }
    }
}

fn colliders<S: Scalar>(setup: &Setup, units: &Units) -> heapless::Vec<Obstacle<S>, 3> {
    let surface = |surface: Surface| (units.length(surface.margin), surface.friction);
    let ball = setup.ball.map(|ball| {
        let (margin, friction) = surface(ball.surface);
        let sphere = Sphere::new(units.point(ball.centre), units.length(ball.radius), margin);
        Obstacle::Ball(sphere.with_friction(friction).with_velocity(units.velocity(ball.velocity)))
    });
    let rod = setup.rod.map(|rod| {
        let (margin, friction) = surface(rod.surface);
        let [a, b] = rod.ends.map(|end| units.point(end));
        Obstacle::Rod(Capsule::new(a, b, units.length(rod.radius), margin).with_friction(friction))
    });
    let ground = setup.ground.map(|ground| {
        let (margin, friction) = surface(ground.surface);
        let plane = Plane::new(units.point(ground.point), Vec3::from_f64(ground.normal), margin);
        Obstacle::Ground(plane.with_friction(friction))
    });
    [ball, rod, ground].into_iter().flatten().collect()
}
