//! Wrappers of a collider forward all of its methods, in any nesting.

use crate::collider::{Collider, Contact, Meeting, Moving, OneStep, Stationary};
use crate::fingerprint::Fingerprint;
use crate::grid::{Grid, Node};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Q24, Scalar};
use crate::vec3::Vec3;

const MOMENT: Moment = Moment { substep: 1, substeps: 2, shift: 1, halves: 2 };

/// A collider whose answers differ from all defaults.
#[derive(Clone, Copy, Default)]
struct Probe {
    /// The number of calls of `advance`.
    frames: i32,
}

impl Stationary for Probe {}

impl<S: Scalar> Collider<S> for Probe {
    fn contact(&self, _moment: Moment, position: Vec3<S>, _moved: Vec3<S>) -> Option<Contact<S>> {
        (position.z < S::ZERO).then(|| Contact::smooth(Vec3::new(S::ZERO, S::ZERO, S::ONE), -position.z))
    }

    fn reaches(&self, _moment: Moment, low: Vec3<S>, _high: Vec3<S>) -> bool {
        low.z < S::ZERO
    }

    fn meets(&self) -> bool {
        true
    }

    fn meet<const W: usize, const H: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        meeting: &mut impl Meeting<S, W, H>,
    ) {
        let apart = Contact::smooth(Vec3::new(S::ONE, S::ZERO, S::ZERO), S::from_int(2));
        meeting.separate(particles, [Node::new(0, 0), Node::new(1, 0)], &apart);
    }

    fn advance(&mut self, _end: Moment) {
        self.frames += 1;
    }

    fn fingerprint(&self, print: &mut Fingerprint) {
        print.word(self.frames as u32);
    }
}

/// The answers and effects of a collider.
#[allow(clippy::struct_excessive_bools, reason = "answers to questions of yes and no")]
#[derive(Clone, Copy, Debug, PartialEq)]
struct Said {
    is_present: bool,
    depths: [Option<f64>; 2],
    reaches: [bool; 2],
    meets: bool,
    met: [f64; 2],
    /// Whether its fingerprint is the same after a frame, and whether it matches itself.
    is_as_before: bool,
    is_known: bool,
}

fn said<S: Scalar, C: Collider<S> + ?Sized>(collider: &mut C) -> Said {
    let at = |z| Vec3::from_f64([0.0, 0.0, z]);
    let contact = |z| collider.contact(MOMENT, at(z), Vec3::ZERO).map(|contact| contact.depth.to_f64());
    let depths = [0.25, -0.25].map(contact);
    let reaches = [0.5, -0.5].map(|z| collider.reaches(MOMENT, at(z), at(1.0)));
    let mut particles = Particles::<S, 2, 1>::BLANK;
    particles.inverse_mass = Grid::filled(S::ONE);
    collider.meet(&mut particles, &mut OneStep(MOMENT));
    let met = [0, 1].map(|column| particles.position.at(Node::new(column, 0)).x.to_f64());
    let print = |collider: &C| {
        let mut print = Fingerprint::new();
        collider.fingerprint(&mut print);
        print
    };
    let [before, again] = [print(collider), print(collider)];
    let (is_present, meets) = (collider.is_present(), collider.meets());
    collider.advance(MOMENT);
    let is_as_before = before.matches(print(collider));
    Said { is_present, depths, reaches, meets, met, is_as_before, is_known: before.matches(again) }
}

fn check<S: Scalar>() {
    let probe = Probe::default();
    let expected = Said {
        is_present: true,
        depths: [None, Some(0.25)],
        reaches: [false, true],
        meets: true,
        met: [1.0, -1.0],
        is_as_before: false,
        is_known: true,
    };
    let vec = |collider| heapless::Vec::<_, 2>::from_iter([collider]);
    assert_eq!(said::<S, _>(&mut { probe }), expected);
    assert_eq!(said::<S, _>(&mut Some(probe)), expected, "an option");
    assert_eq!(said::<S, _>(&mut (probe,)), expected, "a tuple");
    assert_eq!(said::<S, [_]>(&mut [probe]), expected, "a slice");
    assert_eq!(said::<S, _>(&mut vec(probe)), expected, "a vector");
    assert_eq!(said::<S, _>(&mut Moving(probe)), expected, "on its way");
    assert_eq!(said::<S, _>(&mut Some((Moving(probe), None::<Probe>))), expected);
    assert_eq!(said::<S, _>(&mut (None::<Probe>, (), Some(Moving(probe)))), expected);
    assert_eq!(said::<S, _>(&mut Moving(Some((probe, ())))), expected);
    assert_eq!(said::<S, _>(&mut heapless::Vec::<_, 2>::from_iter([Some((probe,)), None])), expected);
    assert_eq!(said::<S, [_]>(&mut [Moving(Some(probe)), Moving(None)]), expected);
    let nothing =
        Said { is_present: false, depths: [None; 2], reaches: [false; 2], meets: false, met: [0.0; 2], ..expected };
    let nothing = Said { is_as_before: true, ..nothing };
    assert_eq!(said::<S, _>(&mut None::<Probe>), nothing, "none");
    assert_eq!(said::<S, [Probe]>(&mut []), nothing, "an empty slice");
    assert_eq!(said::<S, _>(&mut (None::<Probe>, heapless::Vec::<Probe, 2>::new())), nothing);
}

#[test]
fn what_stands_around_a_collider_forwards_all_that_it_says() {
    check::<f32>();
    check::<Q24>();
}
