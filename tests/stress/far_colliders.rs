//! Particles and colliders at opposite ends of the range of fixed point. Differences of their positions once wrapped: a sheet that rose to more than 128 cells above the
//! ground was thrown to the ground's other side.

use kerchief::{Capsule, Collider, Moment, Plane, Q13, Q24, Scalar, Sphere, Units, Vec3};
use proptest::prelude::*;

/// One cell is 1 m.
const UNITS: Units = Units::sheet([2; 2], [1.0; 2], 1.0, 1.0, 1);
const FRAME: Moment = Moment { substep: 1, substeps: 1, shift: 0, halves: 2 };

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    core::array::from_fn(|axis| a[axis] - b[axis])
}

/// Compares a collider's contact with the exact penetration `depth`.
fn meets<S: Scalar>(collider: &impl Collider<S>, place: [f64; 3], depth: f64) -> Result<(), TestCaseError> {
    let place = Vec3::from_f64(place);
    match collider.contact(FRAME, place, Vec3::ZERO) {
        Some(contact) => {
            let found = contact.depth.to_f64();
            prop_assert!((found - depth.min(S::LARGEST)).abs() < 1e-4, "depth {found}, not {depth} in {}", S::NAME);
            prop_assert!(collider.reaches(FRAME, place, place), "{depth} deep in {}, but `reaches` says no", S::NAME);
        }
        None => prop_assert!(depth < 1e-4, "{depth} deep in {}, but no contact", S::NAME),
    }
    Ok(())
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    let end = prop_oneof![-127.0..-100.0, -127.0..127.0, 100.0..127.0];
    [end.clone(), end.clone(), end]
}

fn in_fixed_point<S: Scalar>(
    place: [f64; 3],
    [a, b]: [[f64; 3]; 2],
    direction: [f64; 3],
    reach: f64,
) -> Result<(), TestCaseError> {
    let [radius, margin] = [0.75 * reach, 0.25 * reach].map(|length| UNITS.length(length));
    let length = dot(direction, direction).sqrt();
    let height = dot(minus(place, a), direction) / length;
    meets(&Plane::<S>::new(UNITS.point(a), Vec3::from_f64(direction), margin), place, 0.25 * reach - height)?;
    let way = minus(place, a);
    meets(&Sphere::<S>::new(UNITS.point(a), radius, margin), place, reach - dot(way, way).sqrt())?;
    let segment = minus(b, a);
    let squared = dot(segment, segment);
    if squared < 127.0 * 127.0 {
        let part = (dot(way, segment) / squared).clamp(0.0, 1.0);
        let way = minus(way, segment.map(|component| part * component));
        let depth = reach - dot(way, way).sqrt();
        meets(&Capsule::<S>::new(UNITS.point(a), UNITS.point(b), radius, margin), place, depth)?;
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 20_000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn colliders_are_met_across_the_whole_range(
        place in place(),
        ends in [place(), place()],
        direction in [-2.0..2.0, -2.0..2.0, 0.1..2.0],
        reach in 0.0..63.0,
    ) {
        in_fixed_point::<Q24>(place, ends, direction, reach)?;
        in_fixed_point::<Q13>(place, ends, direction, reach)?;
    }
}
