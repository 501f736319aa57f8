//! The measured scenes, on 16 × 16 particles in any number type. Firmware counts their instructions and links them one by one. Hosts play them,
//! too.

use kerchief::force::Force;
use kerchief::self_contact::Thickness;
use kerchief::{
    AerodynamicWind, BackwardEuler, Bend, Capsule, Cloth, Collider, Damped, Drag, FacetWind, ForwardEuler, Gravity,
    Leapfrog, Lines, Links, Node, PanelWind, Plane, Q13, Q24, Resting, Scalar, Scene, SelfContact, Shear, Solver,
    Sphere, Stillness, StrainLimited, Stretch, Tether, Units, Vec3, Verlet, Xpbd, measure,
};

/// Particles a side.
pub const SIDE: usize = 16;

/// Substeps of XPBD, or sweeps of position Verlet, in a frame.
pub const SWEEPS: u32 = 8;

/// Settings of the line solver, and its substeps in a frame, with which the strain of the moving sheet stays under 1 %.
pub const LINES: (Lines, u32) = (Lines::with_sweeps(1).within(0.03), 1);

/// Frames before the counted ones, after which the strains of the links are typical.
pub const WARM_UP: u32 = 2;
/// The number of counted frames: two. Scenes of the line solver, whose number of sweeps varies, and of a sheet at rest, whose frame is short, are counted to the end of the
/// first second.
pub const fn counted(scene: &str) -> u32 {
    let is_long = is(Some("lines"), scene)
        || is(Some("damped lines"), scene)
        || is(Some("lines, meeting itself"), scene)
        || is(Some("xpbd, at rest"), scene);
    if is_long { 60 - WARM_UP } else { 2 }
}

/// A visitor of the measured scenes.
pub trait Bench {
    /// The only number type to compile. `None`: all.
    const NUMBER: Option<&'static str>;
    /// The only scene to compile. `None`: all.
    const SCENE: Option<&'static str>;

    /// Receives a scene and its sheet in the initial state.
    fn scene<S, F, L, C, V>(&mut self, name: &'static str, scene: &Scene<F, L, C, V>, cloth: Cloth<S, SIDE, SIDE>)
    where
        S: Scalar,
        F: Force<S>,
        L: Links<S>,
        C: Collider<S>,
        V: Solver<S>;
}

/// The thesis' sheet, 10 m wide with particles of 1 kg, in frames of a sixtieth of a second.
const fn units(substeps: u32) -> Units {
    Units::sheet([SIDE, SIDE], [10.0, 10.0], 1.0, 1.0 / 60.0, substeps)
}

/// An upright sheet, pinned at its two upper corners.
fn cloth<S: Scalar>(units: &Units) -> Cloth<S, SIDE, SIDE> {
    let mut cloth = Cloth::hang(units, units.point([0.0; 3]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(SIDE - 1, 0));
    cloth
}

/// Thresholds below any motion: the sheet never comes to rest.
const NEVER: Stillness = Stillness { speed: 1e-9, ..Stillness::DEFAULT };
/// Thresholds so large that the sheet is at rest from the first frames on.
const SOON: Stillness = Stillness { speed: 10.0, acceleration: 1e3, time: 1.0 / 60.0 };

/// Passes the wanted scenes to a bench. The other scenes are not compiled.
macro_rules! scenes {
    ($bench:ident: $B:ident, $S:ident, $($name:literal: $units:ident, $forces:expr, $links:expr, $colliders:expr, $solver:expr;)*) => {
        $(
            if const { is($B::SCENE, $name) } {
                let scene = Scene::new(&$units, $forces, $links, $colliders, $solver);
                $bench.scene($name, &scene, cloth::<$S>(&$units));
            }
        )*
    };
}

const fn is(wanted: Option<&str>, name: &str) -> bool {
    let Some(wanted) = wanted else { return true };
    let (wanted, name) = (wanted.as_bytes(), name.as_bytes());
    let mut same = wanted.len() == name.len();
    let mut byte = 0;
    while same && byte < name.len() {
        same = wanted[byte] == name[byte];
        byte += 1;
    }
    same
}

fn gravity<S: Scalar>(units: &Units) -> Gravity<S> {
    Gravity::new(units.acceleration([0.0, 0.0, -9.81]))
}

/// Ten times the stiffness of the thesis. A sheet that hangs from two corners is strained by 0.4 %.
fn stretch<S: Scalar>(units: &Units) -> Stretch<S> {
    Stretch::new(units, units.stiffness(942_700.0))
}

fn shear<S: Scalar>(units: &Units) -> Shear<S> {
    Shear::new(units, units.stiffness(9_427.0))
}

macro_rules! numbers {
    ($bench:ident: $B:ident, $($S:ty),*) => {
        $(
            if const { is($B::NUMBER, <$S>::NAME) } {
                play::<$S, $B>($bench);
            }
        )*
    };
}

/// Plays every scene in every number type.
pub fn play_all<B: Bench>(bench: &mut B) {
    numbers!(bench: B, f32, Q24, Q13);
}

/// Plays every scene in numbers of type `S`.
fn play<S: Scalar, B: Bench>(bench: &mut B) {
    const MANY: Units = units(SWEEPS);
    const ONCE: Units = units(1);
    const FEW: Units = units(LINES.1);
    const FINE: Units = units(32);
    let margin = MANY.length(0.2);
    let away = MANY.point([0.0, 20.0, -3.0]);
    let verlet = Verlet { sweeps: SWEEPS };
    scenes! { bench: B, S,
        "bare": MANY, gravity(&MANY), (), (), Xpbd;
        "unnamed": MANY, (gravity(&MANY), (), ()), ((), (), ()), ((), (), ()), Xpbd;
        "stretch": MANY, gravity(&MANY), stretch(&MANY), (), Xpbd;
        "shear": MANY, gravity(&MANY), shear(&MANY), (), Xpbd;
        "bend": MANY, gravity(&MANY), Bend::new(&MANY, MANY.stiffness(942.7)), (), Xpbd;
        "damped stretch": MANY, gravity(&MANY), Damped::new(stretch(&MANY), MANY.damping(20.0)), (), Xpbd;
        "limited stretch": MANY, gravity(&MANY), StrainLimited::new(stretch(&MANY), 0.5), (), Xpbd;
        "tethers": MANY, gravity(&MANY), tethers::<S>(&MANY), (), Xpbd;
        "drag": MANY, (gravity(&MANY), Drag::new(MANY.drag(0.5))), (), (), Xpbd;
        "facet wind": MANY, (gravity(&MANY), FacetWind::new(MANY.facet_wind([1.0, 2.0, 0.0]))), (), (), Xpbd;
        "aerodynamic wind": MANY,
            (gravity(&MANY), AerodynamicWind::new(MANY.aerodynamic_wind([1.0, 5.0, 0.0], 1.2, 1.2))), (), (), Xpbd;
        "panel wind": MANY,
            (gravity(&MANY), PanelWind::new(MANY.panel_wind([1.0, 5.0, 0.0], 1.2, 1.2))), (), (), Xpbd;
        "sphere": MANY, gravity(&MANY), (), Sphere::new(away, MANY.length(2.0), margin), Xpbd;
        "plane": MANY, gravity(&MANY), (),
            Plane::new(MANY.point([0.0, 0.0, -20.0]), Vec3::from_f64([0.0, 0.0, 1.0]), margin), Xpbd;
        "capsule": MANY, gravity(&MANY), (),
            Capsule::new(away, MANY.point([10.0, 20.0, -3.0]), MANY.length(0.5), margin), Xpbd;
        "xpbd": MANY, gravity(&MANY), (stretch(&MANY), shear(&MANY)), (), Xpbd;
        "verlet, bare": ONCE, gravity(&ONCE), (), (), verlet;
        "verlet, stretch": ONCE, gravity(&ONCE), stretch(&ONCE), (), verlet;
        "verlet": ONCE, gravity(&ONCE), (stretch(&ONCE), shear(&ONCE)), (), verlet;
        "forward Euler": FINE, gravity(&FINE), (stretch(&FINE), shear(&FINE)), (), ForwardEuler;
        "leapfrog": FINE, gravity(&FINE), (stretch(&FINE), shear(&FINE)), (), Leapfrog;
        "backward Euler": ONCE, gravity(&ONCE), (stretch(&ONCE), shear(&ONCE)), (), BackwardEuler { newton_steps: 1 };
        "lines": FEW, gravity(&FEW), (stretch(&FEW), shear(&FEW)), (), LINES.0;
        "damped lines": FEW, gravity(&FEW), (
            Damped::new(stretch(&FEW), FEW.damping(20.0)),
            Damped::new(shear(&FEW), FEW.damping(20.0)),
        ), (), LINES.0;
        "lines, meeting itself": FEW, gravity(&FEW), (stretch(&FEW), shear(&FEW)), (),
            SelfContact::new(Thickness::new(&FEW, FEW.cell), 0.3, LINES.0);
        "xpbd, resting": MANY, gravity(&MANY), (stretch(&MANY), shear(&MANY)), (), Resting::new(&MANY, NEVER, Xpbd);
        "xpbd, at rest": MANY, gravity(&MANY), (stretch(&MANY), shear(&MANY)), (), Resting::new(&MANY, SOON, Xpbd);
    }
}

/// Tethers to both pins, so long that they stay slack.
fn tethers<S: Scalar>(units: &Units) -> Tether<S, 2> {
    let Ok(tethers) = Tether::new(units, &[Node::new(0, 0), Node::new(SIDE - 1, 0)], 1.0) else {
        unreachable!("two corners fit");
    };
    tethers
}

/// The largest strain of a stretch link.
pub fn stretch_strain<S: Scalar>(cloth: &Cloth<S, SIDE, SIDE>) -> f64 {
    measure::strain(cloth, &stretch::<S>(&units(1))).largest.to_f64()
}
