//! Small scenes, one for each thing that can act on a sheet, in every number type and by every solver. They need nothing but the crate: a
//! board can run them too.

use kerchief::force::Force;
use kerchief::{
    AerodynamicWind, BackwardEuler, Bend, Capsule, Cloth, Collider, Damped, Drag, FacetWind, ForwardEuler, Gravity,
    Leapfrog, Lines, Links, Node, Plane, Scalar, Scene, Shear, Solver, Sphere, StrainLimited, Stretch, Tether, Units,
    Vec3, Verlet, Xpbd, measure,
};

/// What acts on the sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Case {
    Gravity,
    FacetWind,
    AerodynamicWind,
    BallWithFriction,
    DampedLinks,
    StrainLimit,
    Tether,
    MovingPinAndBall,
}

pub(crate) const CASES: [Case; 8] = [
    Case::Gravity,
    Case::FacetWind,
    Case::AerodynamicWind,
    Case::BallWithFriction,
    Case::DampedLinks,
    Case::StrainLimit,
    Case::Tether,
    Case::MovingPinAndBall,
];

/// What moves it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    ForwardEuler,
    BackwardEuler,
    Verlet,
    Leapfrog,
    Xpbd,
    Lines,
}

pub(crate) const METHODS: [Method; 6] =
    [Method::ForwardEuler, Method::BackwardEuler, Method::Verlet, Method::Leapfrog, Method::Xpbd, Method::Lines];

/// What came of it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Outcome {
    pub(crate) digest: u32,
    pub(crate) finite: bool,
    /// The corners of the box around the sheet, cells.
    pub(crate) bounds: [[f64; 3]; 2],
}

/// Frames of a sixtieth of a second.
const FRAMES: u32 = 12;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Plays a case in numbers of type `S`.
pub(crate) fn play<S: Scalar>(case: Case, method: Method) -> Outcome {
    // substeps as the method needs them; three and five are no powers of two
    match method {
        Method::ForwardEuler => play_with::<S, _>(case, ForwardEuler, 256),
        Method::BackwardEuler => play_with::<S, _>(case, BackwardEuler { newton_steps: 2 }, 2),
        Method::Verlet => play_with::<S, _>(case, Verlet { sweeps: 4 }, 3),
        Method::Leapfrog => play_with::<S, _>(case, Leapfrog, 8),
        Method::Xpbd => play_with::<S, _>(case, Xpbd, 5),
        Method::Lines => play_with::<S, _>(case, Lines::new(), 2),
    }
}

fn play_with<S: Scalar, V: Solver<S>>(case: Case, solver: V, substeps: u32) -> Outcome {
    match case {
        Case::Gravity => gravity(solver, substeps),
        Case::FacetWind => facet_wind(solver, substeps),
        Case::AerodynamicWind => aerodynamic_wind(solver, substeps),
        Case::BallWithFriction => ball_with_friction(solver, substeps),
        Case::DampedLinks => damped_links(solver, substeps),
        Case::StrainLimit => strain_limit(solver, substeps),
        Case::Tether => tether(solver, substeps),
        Case::MovingPinAndBall => moving_pin_and_ball(solver, substeps),
    }
}

/// Square cells of 5 cm.
fn square(substeps: u32) -> Units {
    Units::sheet([8, 8], [0.35, 0.35], 5e-4, 1.0 / 60.0, substeps)
}

/// Cells of 5 cm × 4 cm.
fn oblong(substeps: u32) -> Units {
    Units::sheet([16, 16], [0.75, 0.6], 5e-4, 1.0 / 60.0, substeps)
}

fn springs<S: Scalar>(units: &Units) -> (Stretch<S>, Shear<S>, Bend<S>) {
    (
        Stretch::new(units, units.stiffness(40.0)),
        Shear::new(units, units.stiffness(8.0)),
        Bend::new(units, units.stiffness(2.0)),
    )
}

fn weight<S: Scalar>(units: &Units) -> Gravity<S> {
    Gravity::new(units.acceleration(GRAVITY))
}

fn gravity<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = square(substeps);
    let mut cloth = Cloth::<S, 8, 8>::lay(&units, units.point([-0.1, 0.0, 0.2]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(7, 0));
    let forces = (weight(&units), Drag::new(units.verlet_damping(0.02)));
    finish(&Scene::new(&units, forces, springs(&units), (), solver), cloth)
}

fn facet_wind<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = oblong(substeps);
    let mut cloth = Cloth::<S, 16, 16>::hang(&units, units.point([0.0; 3]));
    for row in 0..16 {
        cloth.pin(Node::new(0, row));
    }
    let forces = (weight(&units), FacetWind::new(units.facet_wind([3.0, 2.0, 0.5])));
    finish(&Scene::new(&units, forces, springs(&units), (), solver), cloth)
}

fn aerodynamic_wind<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = oblong(substeps);
    let mut cloth = Cloth::<S, 16, 16>::hang(&units, units.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(15, 0));
    let forces = (weight(&units), AerodynamicWind::new(units.aerodynamic_wind([1.0, 5.0, 0.0], 1.2, 1.5)));
    finish(&Scene::new(&units, forces, springs(&units), (), solver), cloth)
}

fn ball_with_friction<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = oblong(substeps);
    let mut cloth = Cloth::<S, 16, 16>::lay(&units, units.point([-0.4, -0.3, 0.0]));
    cloth.share_area();
    cloth.hem(S::from_f64(1.5));
    let ball = Sphere::new(units.point([0.0, 0.0, -0.25]), units.length(0.2), units.length(0.01))
        .with_friction(S::from_f64(0.4));
    finish(&Scene::new(&units, weight(&units), springs(&units), ball, solver), cloth)
}

fn damped_links<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = square(substeps);
    let mut cloth = Cloth::<S, 8, 8>::lay(&units, units.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    let damping = units.damping(0.01);
    let (stretch, shear, bend) = springs(&units);
    let links = (Damped::new(stretch, damping), shear, Damped::new(bend, damping));
    finish(&Scene::new(&units, weight(&units), links, (), solver), cloth)
}

fn strain_limit<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = square(substeps);
    let mut cloth = Cloth::<S, 8, 8>::hang(&units, units.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(7, 0));
    let stretch = Stretch::new(&units, units.stiffness(4.0));
    let links = (StrainLimited::new(stretch, S::from_f64(0.1)), Shear::new(&units, units.stiffness(1.0)));
    finish(&Scene::new(&units, weight(&units), links, (), solver), cloth)
}

fn tether<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = square(substeps);
    let mut cloth = Cloth::<S, 8, 8>::lay(&units, units.point([0.0; 3]));
    let corners = [Node::new(0, 0), Node::new(7, 0)];
    for corner in corners {
        cloth.pin(corner);
    }
    let Ok(tethers) = Tether::<S, 2>::new(&units, &corners, S::from_f64(0.02)) else {
        unreachable!("two corners fit");
    };
    let links = (Stretch::new(&units, units.stiffness(4.0)), Shear::new(&units, units.stiffness(1.0)), tethers);
    finish(&Scene::new(&units, weight(&units), links, (), solver), cloth)
}

fn moving_pin_and_ball<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Outcome {
    let units = square(substeps);
    let mut cloth = Cloth::<S, 8, 8>::lay(&units, units.point([-0.17, -0.18, 0.0]));
    let hand = Node::new(7, 7);
    cloth.pin(hand);
    let margin = units.length(0.005);
    let ball = Sphere::new(units.point([0.0, 0.0, -0.12]), units.length(0.1), margin)
        .with_velocity(units.velocity([0.3, 0.0, 0.1]));
    let rod = Capsule::new(units.point([-0.2, -0.2, -0.1]), units.point([-0.2, 0.2, -0.1]), units.length(0.04), margin)
        .with_friction(S::HALF);
    let ground = Plane::new(units.point([0.0, 0.0, -0.15]), Vec3::from_f64([0.1, 0.0, 1.0]), margin);
    let mut scene = Scene::new(&units, weight(&units), springs(&units), (ball, rod, ground), solver);
    let mut memory = scene.memory();
    let step = Vec3::from_f64([-0.05, 0.02, 0.1]);
    for _ in 0..FRAMES {
        let target = cloth.position.at(hand) + step;
        scene.move_pin(&mut cloth, hand, target);
        scene.step(&mut cloth, &mut memory);
        scene.advance();
    }
    outcome(&cloth)
}

fn finish<S, F, L, C, V, const W: usize, const H: usize>(
    scene: &Scene<F, L, C, V>,
    mut cloth: Cloth<S, W, H>,
) -> Outcome
where
    S: Scalar,
    F: Force<S>,
    L: Links<S>,
    C: Collider<S>,
    V: Solver<S>,
{
    let mut memory = scene.memory();
    for _ in 0..FRAMES {
        scene.step(&mut cloth, &mut memory);
    }
    outcome(&cloth)
}

fn outcome<S: Scalar, const W: usize, const H: usize>(cloth: &Cloth<S, W, H>) -> Outcome {
    Outcome {
        digest: measure::digest(cloth),
        finite: measure::is_finite(cloth),
        bounds: measure::bounds(cloth).map(Vec3::to_f64),
    }
}
