//! Wrappers of a force forward all of its methods, in any nesting.

use crate::fingerprint::Fingerprint;
use crate::force::{Force, Row, Slowdown};
use crate::scalar::{Q24, Scalar};
use crate::vec3::Vec3;

/// A force whose answers differ from all defaults.
#[derive(Clone, Copy)]
struct Probe;

fn along<S: Scalar>(x: f64) -> Vec3<S> {
    Vec3::from_f64([x, 0.0, 0.0])
}

fn slow<S: Scalar>() -> Slowdown<S> {
    let [rate, decay, gain] = [0.25, 0.75, 0.875].map(S::from_f64);
    Slowdown { rate, decay, gain }
}

impl<S: Scalar> Force<S> for Probe {
    fn uniform(&self) -> Vec3<S> {
        along(0.5)
    }

    fn drag(&self) -> Slowdown<S> {
        slow()
    }

    fn follows_velocity(&self) -> bool {
        false
    }

    fn particles<const W: usize>(&self, row: Row<'_, S, W>, gain: &mut Vec3<[S; W]>) {
        gain.add(0, along(row.index as f64));
    }

    fn cells<const W: usize>(&self, _rows: [Row<'_, S, W>; 2], [upper, lower]: [&mut Vec3<[S; W]>; 2]) {
        upper.add(1, along(2.0));
        lower.add(1, along(3.0));
    }

    fn fingerprint(&self, print: &mut Fingerprint) {
        print.word(7);
    }
}

/// The answers and effects of a force.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Said<S> {
    speaks: [bool; 2],
    is_field: bool,
    uniform: f64,
    drag: Slowdown<S>,
    follows_velocity: bool,
    gains: [[f64; 2]; 2],
    is_known: bool,
}

fn said<S: Scalar, F: Force<S>>(force: &F) -> Said<S> {
    let still = Vec3::<[S; 2]>::row(Vec3::ZERO);
    let inverse_mass = [S::ONE; 2];
    let row = |index| Row { index, position: &still, velocity: &still, inverse_mass: &inverse_mass };
    let [mut upper, mut lower] = [still; 2];
    force.particles(row(5), &mut upper);
    force.cells([row(5), row(6)], [&mut upper, &mut lower]);
    let print = || {
        let mut print = Fingerprint::new();
        force.fingerprint(&mut print);
        print
    };
    Said {
        speaks: [F::DRAG, F::UNIFORM],
        is_field: force.is_field(),
        uniform: force.uniform().x.to_f64(),
        drag: force.drag(),
        follows_velocity: force.follows_velocity(),
        gains: [upper, lower].map(|row| [0, 1].map(|column| row.at(column).x.to_f64())),
        is_known: print().matches(print()),
    }
}

fn check<S: Scalar>() {
    let expected = Said {
        speaks: [true; 2],
        is_field: true,
        uniform: 0.5,
        drag: slow::<S>(),
        follows_velocity: false,
        gains: [[5.0, 2.0], [0.0, 3.0]],
        is_known: true,
    };
    assert_eq!(said::<S, _>(&Probe), expected);
    assert_eq!(said::<S, _>(&Some(Probe)), expected, "an option");
    assert_eq!(said::<S, _>(&(Probe,)), expected, "a tuple");
    assert_eq!(said::<S, _>(&(None::<Probe>, (), Some((Probe,)))), expected);
    assert_eq!(said::<S, _>(&Some(((), Some(Probe)))), expected);
    let nothing = Said { is_field: false, uniform: 0.0, drag: Slowdown::NONE, gains: [[0.0; 2]; 2], ..expected };
    assert_eq!(said::<S, _>(&None::<Probe>), nothing, "none");
    assert_eq!(said::<S, _>(&(None::<(Probe,)>, ())), nothing);
    assert_eq!(said::<S, _>(&((), ())), Said { speaks: [false; 2], ..nothing }, "nothing twice");
}

#[test]
fn what_stands_around_a_force_forwards_all_that_it_says() {
    check::<f32>();
    check::<Q24>();
}
