//! Constructors refuse senseless values of a scene in one sentence. A scene that they accept can be stepped.

use std::any::Any;
use std::panic::{AssertUnwindSafe, Location, catch_unwind, set_hook, take_hook};
use std::sync::Mutex;

use embedded_graphics::geometry::Size;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use kerchief::material::{DENIM, Material};
use kerchief::render::{Ball, Ground, Light, Rod, View};
use kerchief::rest::{Resting, Stillness};
use kerchief::units::{Acceleration, Airflow, DragRate, Length, PanelFlow, Point, Strength};
use kerchief::{
    AerodynamicWind, BackwardEuler, Bend, Capsule, Cloth, Collider, Damped, Drag, FacetWind, Force, ForwardEuler,
    Gravity, Leapfrog, Lines, Links, Node, PanelWind, Plane, Q13, Q24, Scalar, Scene, Shear, Solver, Sphere,
    StrainLimited, Stretch, Tether, Units, Vec3, Verlet, Xpbd, measure,
};
use proptest::prelude::*;
use proptest::sample::select;
use proptest::test_runner::RngSeed;

const UNITS: Units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 1.0 / 60.0, 4);

/// The beginnings of the sentences in which constructors refuse values.
const SENTENCES: [&str; 42] = [
    "a direction's angles are finite",
    "a place that is looked at is finite",
    "the eye is at least one cell away from its target",
    "a field of view lies between 0 and 180 degrees",
    "a screen has a pixel at least",
    "a ground reaches somewhere",
    "a sheet needs two particles and a positive size",
    "a sheet needs a finite size",
    "a particle needs a positive mass",
    "a frame needs a positive length and one substep at least",
    "a frame has at most 16777216 substeps",
    "numbers of a scene are finite",
    "a stiffness is zero or above",
    "a compliance is zero or above",
    "a damping is zero or above",
    "a drag is finite, zero or above",
    "a damping factor is at least 0 and below 1",
    "a density is zero or above",
    "a drag coefficient is zero or above",
    "a constant of the scene is not finite, or too large for its number type",
    "a constant of the scene is too small for its number type",
    "a wind's pressure is zero or above",
    "a panel's area is positive",
    "a radius or margin is zero or above",
    "a length is beyond the range of the number type",
    "a strength is zero or above",
    "a place is not finite, or beyond the range of the number type",
    "a slack is finite, zero or above",
    "a strain limit is positive and finite",
    "fixed point represents strain limits below 63",
    "a coefficient of friction is finite, zero or above",
    "a plane's normal is finite and not zero",
    "a capsule is longer than the range of the number type",
    "a hem's factor is positive and finite",
    "a hem is too light for the number type",
    "the sheet has no particle in this column and row",
    "an inverse mass is finite, zero or above",
    "a stillness is positive and finite",
    "Verlet needs one sweep at least",
    "backward Euler needs one Newton step at least",
    "lines need one sweep at least",
    "a tolerance is positive and finite",
];

fn sentence(panic: &(dyn Any + Send)) -> &str {
    panic.downcast_ref::<&str>().copied().or(panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("nothing")
}

/// Asserts that `make` panics with this sentence, at a line of this file.
#[track_caller]
fn refused<T>(what: &str, expected: &str, make: impl FnOnce() -> T) {
    static ONE_HOOK: Mutex<()> = Mutex::new(());
    static FILE: Mutex<String> = Mutex::new(String::new());

    assert!(
        SENTENCES.iter().any(|sentence| sentence.starts_with(expected) || expected.starts_with(sentence)),
        "{expected}"
    );
    let result = {
        let _one = ONE_HOOK.lock().unwrap();
        let hook = take_hook();
        set_hook(Box::new(|info| *FILE.lock().unwrap() = info.location().map_or("", Location::file).to_string()));
        let result = catch_unwind(AssertUnwindSafe(make));
        set_hook(hook);
        result
    };
    let Err(panic) = result else { panic!("{what} is accepted") };
    let found = sentence(&*panic);
    assert!(found.starts_with(expected), "{what}: {found:?}");
    assert_eq!(*FILE.lock().unwrap(), file!(), "{what}: the caller's line");
}

const WRONG: [f64; 3] = [f64::NAN, f64::INFINITY, -1.0];

#[test]
fn sizes_masses_and_times_are_positive_and_finite() {
    for bad in [f64::NAN, f64::NEG_INFINITY, -1.0, 0.0] {
        for size in [[bad, 0.3], [0.3, bad]] {
            refused("size", "a sheet needs two particles and a positive size", || {
                Units::sheet([4, 4], size, 1e-3, 0.02, 4)
            });
        }
    }
    for bad in [f64::NAN, f64::INFINITY, -1.0, 0.0] {
        refused("mass", "a particle needs a positive mass", || Units::sheet([4, 4], [0.3, 0.3], bad, 0.02, 4));
        refused("frame", "a frame needs a positive length", || Units::sheet([4, 4], [0.3, 0.3], 1e-3, bad, 4));
        refused("density", "a particle needs a positive mass", || {
            Material { density: bad, ..DENIM }.units([4, 4], [0.3, 0.3], 0.02, 4)
        });
    }
    refused("size", "a sheet needs a finite size", || Units::sheet([4, 4], [f64::INFINITY, 0.3], 1e-3, 0.02, 4));
    // a side without a second particle has no length
    let chain = Units::sheet([1, 4], [f64::NAN, 0.3], 1e-3, 0.02, 4);
    assert_eq!((chain.cell, chain.sides), (0.3 / 3.0, [0.0, 1.0]));
}

#[test]
fn substeps_are_counted() {
    let of = |substeps| Units::sheet([4, 4], [0.3, 0.3], 1e-3, 0.02, substeps);
    for substeps in [(1 << 24) + 1, 1 << 31, (1 << 31) + 1, u32::MAX] {
        refused("substeps", "a frame has at most 16777216 substeps", || of(substeps));
        let by_hand = Units { substeps, ..UNITS };
        refused("substeps", "a frame has at most 16777216 substeps", || Scene::new(&by_hand, (), (), (), Xpbd));
    }
    refused("substeps", "a frame needs a positive length and one substep", || of(0));
    refused("substeps", "a frame needs a positive length and one substep", || {
        Scene::new(&Units { substeps: 0, ..UNITS }, (), (), (), Xpbd)
    });
    assert_eq!(of(1 << 24).shift(), 24);
}

/// An acceleration that does not come from [`Units`].
fn weight(cells_per_tick: [f64; 3]) -> Acceleration {
    let mut weight = UNITS.acceleration([0.0; 3]);
    weight.0 = cells_per_tick;
    weight
}

#[test]
fn what_is_undefined_does_not_become_fixed_point() {
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let vector = [0.0, bad, 0.0];
        refused("gravity", "numbers of a scene are finite", || UNITS.acceleration(vector));
        refused("velocity", "numbers of a scene are finite", || UNITS.velocity(vector));
        refused("point", "numbers of a scene are finite", || UNITS.point(vector));
        refused("length", "numbers of a scene are finite", || UNITS.length(bad));
        refused("wind", "numbers of a scene are finite", || UNITS.facet_wind(vector));
        refused("wind", "numbers of a scene are finite", || UNITS.aerodynamic_wind(vector, 1.2, 1.2));
        refused("wind", "numbers of a scene are finite", || UNITS.panel_wind(vector, 1.2, 1.2));
        refused("density", "numbers of a scene are finite", || UNITS.aerodynamic_wind([0.0; 3], bad, 1.2));
        let too_large = "a constant of the scene is not finite, or too large";
        refused("gravity", too_large, || Gravity::<Q24>::new(weight(vector)));
        refused("gravity", too_large, || Gravity::<f32>::new(weight(vector)));
        refused("wind", too_large, || FacetWind::<Q24>::new(Airflow { wind: vector, pressure: 0.0, widest: 1.0 }));
        refused("place", "a place is not finite", || Cloth::<Q24, 4, 4>::lay(&UNITS, Point(vector)));
        refused("place", "a place is not finite", || Sphere::<f32>::new(Point(vector), Length(1.0), Length(0.0)));
        refused("normal", "a plane's normal is finite", || {
            Plane::<f32>::new(Point([0.0; 3]), Vec3::from_f64(vector), Length(0.0))
        });
    }
    refused("gravity", "a constant of the scene is not finite, or too large", || {
        Gravity::<Q24>::new(weight([128.0; 3]))
    });
    refused("place", "a place is not finite, or beyond", || Cloth::<Q24, 4, 4>::hang(&UNITS, Point([126.0, 0.0, 0.0])));
    refused("place", "a place is not finite, or beyond", || {
        Cloth::<Q24, 4, 4>::hang(&UNITS, Point([0.0, 0.0, -126.0]))
    });
    assert_eq!(
        Cloth::<Q24, 4, 4>::hang(&UNITS, Point([124.0, 0.0, -124.0])).position.at(Node::new(3, 3)).z.to_f64(),
        -127.0
    );
}

#[test]
fn nothing_is_softer_than_nothing() {
    for bad in [f64::NAN, f64::NEG_INFINITY, -1.0, -5e-324] {
        refused("stiffness", "a stiffness is zero or above", || UNITS.stiffness(bad));
        refused("compliance", "a compliance is zero or above", || UNITS.compliance(bad));
        refused("damping", "a damping is zero or above", || UNITS.damping(bad));
        refused("drag", "a drag is finite, zero or above", || UNITS.drag(bad));
        refused("drag", "a damping factor is at least 0", || UNITS.verlet_damping(bad));
        let strength = Strength { dividend: bad, divisor: 1.0 };
        refused("strength", "a strength is zero or above", || Stretch::<f32>::new(&UNITS, strength));
        refused("strength", "a strength is zero or above", || Damped::<_, Q24>::new((), strength));
    }
    refused("drag", "a drag is finite", || UNITS.drag(f64::INFINITY));
    refused("drag", "a damping factor", || UNITS.verlet_damping(1.0));
    assert_eq!(UNITS.stiffness(f64::INFINITY), UNITS.compliance(0.0), "rigid");
    assert_eq!(UNITS.stiffness(-0.0).value(), 0.0);
}

#[test]
fn pictures_have_a_view() {
    let view = View::new(30.0, 20.0);
    let [origin, metre] = [[0.0; 3], [1.0; 3]].map(|place| UNITS.point(place));
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        refused("azimuth", "a direction's angles are finite", || View::new(bad, 0.0));
        refused("elevation", "a direction's angles are finite", || View::new(0.0, bad));
        refused("lamp", "a direction's angles are finite", || Light::new(bad, bad));
        refused("target", "a place that is looked at is finite", || view.at(Point([0.0, bad, 0.0]), Length(3.0)));
        refused("distance", "the eye is at least one cell", || view.at(origin, Length(bad)));
        refused("field", "a field of view lies", || view.field_of_view(bad));
    }
    refused("screen", "a screen has a pixel", || view.fit(origin, metre, Size::new(0, 100)));
    for bad in [f64::NAN, -1.0] {
        refused("reach", "a ground reaches somewhere", || Ground::new(origin, Length(bad)));
        refused("radius", "a radius or margin is zero", || Ball::<f32>::new(origin, Length(bad), Rgb888::BLACK));
        refused("radius", "a radius or margin is zero", || Rod::<Q24>::new(origin, metre, Length(bad), Rgb888::BLACK));
    }
}

#[test]
fn colliders_have_a_shape() {
    let (origin, metre) = (UNITS.point([0.0; 3]), UNITS.length(0.1));
    refused("normal", "a plane's normal is finite and not zero", || Plane::<Q24>::new(origin, Vec3::ZERO, metre));
    refused("normal", "a plane's normal is finite and not zero", || Plane::<f64>::new(origin, Vec3::ZERO, metre));
    refused("radius", "a radius or margin is zero or above", || Sphere::<Q24>::new(origin, Length(-1.0), metre));
    refused("margin", "a radius or margin is zero or above", || {
        Plane::<Q24>::new(origin, Vec3::from_f64([0.0, 0.0, 1.0]), Length(-1.0))
    });
    refused("margin", "a length is beyond the range", || Sphere::<Q24>::new(origin, Length(100.0), Length(100.0)));
    refused("radius", "a length is beyond the range", || Sphere::<Q24>::new(origin, Length(200.0), metre));
    let [a, b] = [-70.0, 70.0].map(|x| Point([x, 0.0, 0.0]));
    refused("length", "a capsule is longer than", || Capsule::<Q24>::new(a, b, metre, metre));
    for bad in [f64::NAN, f64::INFINITY, -0.1] {
        refused("friction", "a coefficient of friction", || {
            Sphere::<f32>::new(origin, metre, metre).with_friction(bad)
        });
        refused("friction", "a coefficient of friction", || {
            Capsule::<f32>::new(origin, origin, metre, metre).with_friction(bad)
        });
        refused("friction", "a coefficient of friction", || {
            Plane::<f32>::new(origin, Vec3::from_f64([0.0, 0.0, 1.0]), metre).with_friction(bad)
        });
    }
    refused("velocity", "a constant of the scene is not finite", || {
        let mut velocity = UNITS.velocity([0.0; 3]);
        velocity.0 = [f64::NAN; 3];
        Sphere::<Q24>::new(origin, metre, metre).with_velocity(velocity)
    });
}

#[test]
fn a_pin_outside_the_grid_reports_the_callers_line() {
    let mut cloth = Cloth::<f32, 8, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    for node in [Node::new(8, 0), Node::new(0, 4), Node::new(usize::MAX, 0)] {
        refused("pin", "the sheet has no particle in this column and row", || cloth.pin(node));
        refused("pin", "the sheet has no particle in this column and row", || cloth.release(node, 1.0));
    }
    for bad in [f32::NAN, f32::INFINITY, -1.0] {
        refused("inverse mass", "an inverse mass is finite", || cloth.release(Node::new(0, 0), bad));
        refused("hem", "a hem's factor", || cloth.hem(bad));
    }
    cloth.pin(Node::new(7, 3));
    let mut light = Cloth::<Q24, 4, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    refused("hem", "a hem is too light", || light.hem(Q24::from_f64(0.001)));
}

#[test]
fn solvers_do_something() {
    fn memory<S: Scalar>(solver: impl Solver<S>) {
        Scene::new(&UNITS, (), (), (), solver).memory::<S, 4, 4>();
    }
    refused("sweeps", "Verlet needs one sweep", || memory::<f32>(Verlet { sweeps: 0 }));
    refused("steps", "backward Euler needs one Newton step", || memory::<Q24>(BackwardEuler { newton_steps: 0 }));
    refused("sweeps", "lines need one sweep", || Lines::with_sweeps(0));
    refused("sweeps", "lines need one sweep", || memory::<f32>(Lines { sweeps: 0, ..Lines::new() }));
    for bad in WRONG.into_iter().chain([0.0]) {
        refused("tolerance", "a tolerance is positive", || Lines::new().within(bad));
        let still = |speed, acceleration, time| Resting::new(&UNITS, Stillness { speed, acceleration, time }, Xpbd);
        refused("speed", "a stillness is positive", || still(bad, 1.0, 1.0));
        refused("acceleration", "a stillness is positive", || still(1.0, bad, 1.0));
        refused("time", "a stillness is positive", || still(1.0, 1.0, bad));
        refused("limit", "a strain limit is positive", || StrainLimited::<_, f32>::new((), bad));
    }
    refused("limit", "fixed point represents", || StrainLimited::<_, Q24>::new((), 63.0));
    refused("slack", "a slack is finite", || Tether::<f32, 1>::new(&UNITS, &[], -0.1));
}

/// The height after a fall of a second from rest, m.
fn fall<S: Scalar>(units: &Units) -> f64 {
    let mut cloth = Cloth::<S, 4, 4>::lay(units, units.point([0.0; 3]));
    let scene = Scene::new(units, Gravity::new(units.acceleration([0.0, 0.0, -9.81])), (), (), Xpbd);
    scene.memory::<S, 4, 4>();
    (0..60).for_each(|_| scene.step(&mut cloth, &mut scene.memory()));
    cloth.position.at(Node::new(1, 1)).z.to_f64() * units.cell
}

/// Gravity that fixed point represents with one to three bits: 10 % too weak at 2048 substeps, 79 % too strong at 8192.
#[test]
fn what_rounding_changes_by_more_than_a_sixteenth_is_refused() {
    let units = |substeps| Units::sheet([4, 4], [30.0, 30.0], 1.0, 1.0 / 60.0, substeps);
    let too_small = "a constant of the scene is too small for its number type";
    for substeps in [2048, 8192, 1 << 20] {
        refused("gravity", too_small, || fall::<Q24>(&units(substeps)));
        refused("gravity", too_small, || fall::<Q13>(&units(substeps)));
    }
    for substeps in [1, 8, 64, 256, 300, 512] {
        let fallen = catch_unwind(|| fall::<Q24>(&units(substeps)));
        // it depends on chance whether a number is near a multiple of the last place
        let Ok(fallen) = fallen else { continue };
        assert!(substeps <= 64 || fallen < 0.0);
        assert!((fallen / fall::<f64>(&units(substeps)) - 1.0).abs() < 0.063, "{substeps}: {fallen}");
    }
    fall::<f32>(&units(8192));
    refused("stiffness", too_small, || Stretch::<Q24>::new(&UNITS, UNITS.stiffness(5e-6)));
    refused("damping", too_small, || Damped::<_, Q24>::new((), UNITS.damping(3.5e-8)));
    refused("drag", too_small, || Drag::<Q24>::new(UNITS.drag(2e-5)));
    refused("wind", too_small, || FacetWind::<Q24>::new(UNITS.facet_wind([1e-7, 0.0, 0.0])));
    refused("pressure", too_small, || PanelWind::<Q24>::new(UNITS.panel_wind([1.0, 0.0, 0.0], 1e-6, 1.0)));
    refused("area", "a panel's area is positive", || {
        PanelWind::<Q24>::new(PanelFlow { area: 0.0, ..UNITS.panel_wind([1.0, 0.0, 0.0], 1.0, 1.0) })
    });
    refused("pressure", too_small, || AerodynamicWind::<Q24>::new(UNITS.aerodynamic_wind([1.0, 0.0, 0.0], 1e-6, 1.0)));
    // zero stays zero, and the rounding of a small component beside a large one does not count
    let _ = Stretch::<Q24>::new(&UNITS, UNITS.stiffness(0.0));
    let _ = Drag::<Q24>::new(UNITS.drag(0.0));
    let _ = Gravity::<Q24>::new(UNITS.acceleration([1e-6, 0.0, -9.81]));
}

/// Fixed point's largest number is below 128: with more sweeps, a spring's share in one of them was once negative.
#[test]
fn verlet_counts_more_sweeps_than_fixed_point_has_numbers() {
    fn lowest<S: Scalar>(sweeps: u32) -> f64 {
        let mut cloth = Cloth::<S, 4, 4>::hang(&UNITS, UNITS.point([0.0; 3]));
        [0, 3].into_iter().for_each(|column| cloth.pin(Node::new(column, 0)));
        let links = (Stretch::new(&UNITS, UNITS.stiffness(20.0)), Shear::new(&UNITS, UNITS.stiffness(2.0)));
        let scene =
            Scene::new(&UNITS, Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])), links, (), Verlet { sweeps });
        scene.memory::<S, 4, 4>();
        (0..30).for_each(|_| scene.step(&mut cloth, &mut scene.memory()));
        cloth.position.values().fold(0.0, |lowest, x| f64::min(lowest, x.z.to_f64() * UNITS.cell))
    }
    for sweeps in [1, 127, 128, 129, 200, 1000] {
        let (exact, found) = (lowest::<f64>(sweeps), [lowest::<Q24>(sweeps), lowest::<Q13>(sweeps)]);
        assert!(found.iter().all(|lowest| (lowest - exact).abs() < 3e-3), "{sweeps} sweeps: {found:?}, not {exact}");
    }
}

/// Senseless numbers, and some sensible ones.
fn number() -> impl Strategy<Value = f64> {
    let odd = [
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        0.0,
        -0.0,
        5e-324,
        -1.0,
        1.0,
        127.0,
        128.0,
        -128.0,
        1e9,
        -1e9,
        1e38,
        1e39,
        1e300,
        f64::MAX,
        f64::MIN,
        1e-9,
    ];
    prop_oneof![1 => select(odd.to_vec()), 2 => (-12.0..12.0_f64).prop_map(|power| 10_f64.powf(power)), 6 => 0.01..2.0]
}

fn count() -> impl Strategy<Value = u32> {
    prop_oneof![1 => select(&[0, 127, 128, 1 << 24, (1 << 24) + 1, 1 << 31, u32::MAX][..]), 8 => 1_u32..6]
}

/// The constants of a scene, each taken once.
struct Constants<'a>(std::slice::Iter<'a, f64>, std::slice::Iter<'a, u32>);

impl Constants<'_> {
    fn next(&mut self) -> f64 {
        *self.0.next().expect("enough numbers")
    }

    fn vector(&mut self) -> [f64; 3] {
        [self.next(), self.next(), self.next()]
    }

    fn count(&mut self) -> u32 {
        *self.1.next().expect("enough counts")
    }
}

/// Calls every public constructor of a scene's parts and plays a few frames. Returns whether the sheet stayed finite.
fn played<S: Scalar>(from: &mut Constants<'_>, kind: usize) -> bool {
    let units = Units::sheet([4, 4], [from.next(), from.next()], from.next(), from.next(), from.count());
    let gravity = Gravity::<S>::new(units.acceleration(from.vector()));
    let drag = Drag::<S>::new(if kind % 2 == 0 { units.drag(from.next()) } else { units.verlet_damping(from.next()) });
    let facet = FacetWind::<S>::new(units.facet_wind(from.vector()));
    let wind = AerodynamicWind::<S>::new(units.aerodynamic_wind(from.vector(), from.next(), from.next()));
    let panels = PanelWind::<S>::new(units.panel_wind(from.vector(), from.next(), from.next()));
    let raw = Drag::<S>::new(DragRate { rate: from.next(), decay: from.next(), gain: from.next() });
    let stretch = Stretch::<S>::new(&units, units.stiffness(from.next()));
    let shear = Shear::<S>::new(&units, units.compliance(from.next()));
    let bend = Bend::<S>::new(&units, Strength { dividend: from.next(), divisor: from.next() });
    let damped = Damped::new(stretch, units.damping(from.next()));
    let limited = StrainLimited::<_, S>::new(shear, from.next());
    let slack = Tether::<S, 2>::new(&units, &[Node::new(0, 0)], from.next()).expect("one is fewer than two");
    let friction = from.next();
    let centre = units.point(from.vector());
    let ball = Sphere::<S>::new(centre, units.length(from.next()), units.length(from.next())).with_friction(friction);
    let ball = ball.with_velocity(units.velocity(from.vector()));
    let normal = Vec3::from_f64(from.vector());
    let ground = Plane::<S>::new(Point(from.vector()), normal, Length(from.next())).with_friction(friction);
    let rod = Capsule::<S>::new(centre, Point(from.vector()), Length(from.next()), units.length(from.next()));
    let mut cloth = if kind % 3 == 0 {
        Cloth::<S, 4, 4>::lay(&units, units.point(from.vector()))
    } else {
        Cloth::hang(&units, Point(from.vector()))
    };
    cloth.hem(S::from_f64(from.next()));
    cloth.pin(Node::new(from.count() as usize % 5, 0));
    cloth.release(Node::new(3, 3), S::from_f64(from.next()));
    let forces = (gravity, drag, (facet, wind, panels, raw));
    let (links, colliders) = ((damped, limited, (bend, slack)), (ball, ground, rod));
    let (sweeps, tolerance) = (from.count(), from.next());
    match kind {
        0 => moved(&units, forces, links, colliders, Xpbd, cloth),
        1 => moved(&units, forces, links, colliders, Verlet { sweeps: sweeps.min(1000) }, cloth),
        2 => moved(&units, forces, links, colliders, Leapfrog, cloth),
        3 => moved(&units, forces, links, colliders, ForwardEuler, cloth),
        4 => moved(&units, forces, links, colliders, BackwardEuler { newton_steps: sweeps.min(20) }, cloth),
        5 => moved(&units, forces, links, colliders, Lines::with_sweeps(sweeps.min(20)).within(tolerance), cloth),
        _ => {
            let stillness = Stillness { speed: from.next(), acceleration: from.next(), time: from.next() };
            moved(&units, forces, links, colliders, Resting::new(&units, stillness, Xpbd), cloth)
        }
    }
}

fn moved<S: Scalar, F: Force<S>, L: Links<S>, C: Collider<S>, V: Solver<S>>(
    units: &Units,
    forces: F,
    links: L,
    colliders: C,
    solver: V,
    mut cloth: Cloth<S, 4, 4>,
) -> bool {
    let mut scene = Scene::new(units, forces, links, colliders, solver);
    let mut memory = scene.memory::<S, 4, 4>();
    let frames = if units.substeps > 1000 { 0 } else { 3 };
    for _ in 0..frames {
        // a panic in a step is a failure, not a refusal
        catch_unwind(AssertUnwindSafe(|| scene.play(&mut cloth, &mut memory))).expect("a step cannot fail");
    }
    measure::is_finite(&cloth)
}

/// Tries a scene. Returns whether it was refused.
fn is_refused<S: Scalar>(numbers: &[f64], counts: &[u32], kind: usize) -> bool {
    let mut from = Constants(numbers.iter(), counts.iter());
    match catch_unwind(AssertUnwindSafe(|| played::<S>(&mut from, kind))) {
        Ok(finite) => {
            // all numbers in fixed point are finite, so it must not be given others
            assert!(finite || !S::EXACT_SUMS);
            false
        }
        Err(panic) => {
            let found = sentence(&*panic);
            assert!(SENTENCES.iter().any(|sentence| found.starts_with(sentence)), "in {}: {found:?}", S::NAME);
            true
        }
    }
}

/// The numbers of an acceptable scene, a few of them spoilt.
fn constants() -> impl Strategy<Value = (Vec<f64>, Vec<u32>, usize)> {
    let good = prop::collection::vec(0.05..0.9_f64, 90);
    let spoilt = prop::collection::vec((0_usize..90, number()), 0..3);
    let counts = prop_oneof![3 => prop::collection::vec(1_u32..4, 3), 1 => prop::collection::vec(count(), 3)];
    (good, spoilt, counts, 0_usize..7).prop_map(|(mut numbers, spoilt, counts, kind)| {
        spoilt.into_iter().for_each(|(index, number)| numbers[index] = number);
        (numbers, counts, kind)
    })
}

#[test]
fn constructors_refuse_in_a_sentence_or_the_scene_steps() {
    let refused = std::cell::Cell::new([0, 0]);
    let config = ProptestConfig {
        cases: 600,
        rng_seed: RngSeed::Fixed(1),
        failure_persistence: None,
        ..ProptestConfig::default()
    };
    proptest!(config, |((numbers, counts, kind) in constants())| {
        let seen = [
            is_refused::<f32>(&numbers, &counts, kind),
            is_refused::<f64>(&numbers, &counts, kind),
            is_refused::<Q24>(&numbers, &counts, kind),
            is_refused::<Q13>(&numbers, &counts, kind),
        ];
        let [played, all] = refused.get();
        refused.set([played + seen.iter().filter(|refused| !**refused).count(), all + seen.len()]);
    });
    let [played, all] = refused.get();
    assert!(played > all / 5 && played < all, "{played} of {all} were played");
}
