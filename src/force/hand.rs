//! A hand that drags a particle.

use crate::fingerprint::Fingerprint;
use crate::force::{Force, Row};
use crate::grid::Node;
use crate::link::Quotient;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::{Length, Strength, Units};
use crate::vec3::Vec3;

/// A hand: a damped spring from one particle to a target, `F = (target − x)/compliance − damping·v`.
///
/// The force stops growing at a distance of `reach`, so it never exceeds `reach/compliance`: a sheet pinned elsewhere is not overstretched, however far away the target
/// is. The particle keeps its mass, and after release its velocity. A pinned particle stays in place: [`Scene::move_pin`](crate::Scene::move_pin) moves it.
///
/// The hand is a force like any other: all solvers approximate the same equation with it, in their order. Where a substep h is too long for its strength,
/// spring and damper are weakened, so that no particle overshoots. h²/(compliance·m) is at most ½, damping·h/m at most ¾, and the spring moves a particle of
/// mass m by at most half a cell in a substep. Here m is the unit of mass, or the mass of the gripped particle if that is smaller.
///
/// An empty hand costs one test in each substep.
///
/// ```
/// use kerchief::*;
///
/// const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
///
/// let mut cloth = Cloth::<Q24, 16, 16>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
/// cloth.pin(Node::new(0, 0));
/// cloth.pin(Node::new(15, 0));
/// // 0.2 m/N and 0.3 N·s/m, up to 0.1 m or half a newton: twice the sheet's weight
/// let hand = Hand::new(&UNITS, UNITS.compliance(0.2), UNITS.damping(0.3), UNITS.length(0.1));
/// let forces = (Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])), hand);
/// let links = (Stretch::new(&UNITS, UNITS.stiffness(100.0)), Shear::new(&UNITS, UNITS.stiffness(1.0)));
/// let mut scene = Scene::new(&UNITS, forces, links, (), Lines::new());
/// let mut memory = scene.memory();
///
/// scene.forces.1.grab(&cloth, Node::new(8, 15)); // the button goes down
/// for frame in 0..30 {
///     let target = UNITS.point([0.15, -0.01 * f64::from(frame), 0.1]);
///     scene.forces.1.drag_to(target.to_vec()); // the pointer moves
///     scene.step(&mut cloth, &mut memory);
/// }
/// assert!(UNITS.metres(cloth.position.at(Node::new(8, 15)))[1] < -0.15);
/// assert_eq!(scene.forces.1.drop(), Some(Node::new(8, 15))); // the button goes up
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hand<S> {
    /// The gripped particle and its target, cells.
    held: Option<(Node, Vec3<S>)>,
    spring: Quotient<S>,
    damper: Quotient<S>,
    /// Cells.
    reach: S,
    /// The logarithm to base 2 of the substeps in a tick.
    shift: u32,
}

/// The largest displacement by the spring in a substep, cells: with a larger one the particle's links are overstretched before they act.
const FURTHEST: f64 = 0.5;

/// The largest part of the distance to its target that a particle moves in a substep, and the largest part of its velocity that it loses. An explicit rule is
/// stable up to 4 and 2 respectively; the line solver, which extrapolates velocities, up to 4/3 of the velocity.
const MOST_OF_WAY: f64 = 0.5;
const MOST_OF_SPEED: f64 = 0.75;

/// The largest velocity change, cells per tick, so that many substeps do not leave the range of fixed point.
const FASTEST: f64 = 32.0;

impl<S: Scalar> Hand<S> {
    /// An empty hand.
    ///
    /// # Panics
    /// If compliance or damping doesn't [fit](Strength::fits) the number type, or the reach is negative or beyond its range.
    #[track_caller]
    pub fn new(units: &Units, compliance: Strength, damping: Strength, reach: Length) -> Self {
        reach.check_size::<S>();
        let (spring, damper) = (Quotient::new(compliance), Quotient::new(damping));
        Self { held: None, spring, damper, reach: S::from_f64(reach.0), shift: units.shift() }
    }

    /// Grips a particle, with its present position as the target: nothing moves yet.
    ///
    /// # Panics
    /// If the sheet has no such particle.
    #[track_caller]
    pub fn grab<const W: usize, const H: usize>(&mut self, particles: &Particles<S, W, H>, node: Node) {
        assert!(node.column < W && node.row < H, "the sheet has no particle in this column and row");
        self.held = Some((node, particles.position.at(node)));
    }

    /// Sets the target of the gripped particle (cells). The target stays until the next call.
    pub fn drag_to(&mut self, target: Vec3<S>) {
        if let Some((_, held)) = &mut self.held {
            *held = target;
        }
    }

    /// Releases the particle and returns it.
    pub fn drop(&mut self) -> Option<Node> {
        self.held.take().map(|(node, _)| node)
    }

    /// The gripped pin and its position after a frame, moved by at most `stride` towards its target. For [`Scene::move_pin`](crate::Scene::move_pin).
    pub fn carried<const W: usize, const H: usize>(
        &self,
        particles: &Particles<S, W, H>,
        stride: Length,
    ) -> Option<(Node, Vec3<S>)> {
        let (node, target) = self.held.filter(|&(node, _)| particles.is_pinned(node))?;
        let from = particles.position.at(node);
        Some((node, from + shortened(target.difference(from), S::from_f64(stride.0))))
    }

    /// The gripped particle and its target, cells.
    pub const fn held(&self) -> Option<(Node, Vec3<S>)> {
        self.held
    }
}

impl<S: Scalar> Force<S> for Hand<S> {
    const DRAG: bool = false;
    const UNIFORM: bool = false;

    #[inline]
    fn is_field(&self) -> bool {
        self.held.is_some()
    }

    #[inline]
    fn follows_velocity(&self) -> bool {
        self.held.is_some()
    }

    #[inline]
    fn particles<const W: usize>(&self, row: Row<'_, S, W>, gain: &mut Vec3<[S; W]>) {
        let Some((Node { column, row: held }, target)) = self.held else { return };
        if held != row.index || column >= W {
            return;
        }
        let w = row.inverse_mass[column];
        // gains are for mass 1: a lighter particle moves by w times as much
        let at_most = |bound: f64| if w > S::ONE { S::from_f64(bound).divide(w) } else { S::from_f64(bound) };
        let way = shortened(target.difference(row.position.at(column)), self.reach);
        let furthest = at_most(FURTHEST).min(at_most(FASTEST).halve(self.shift));
        let pull = shortened(way * bounded(self.spring, at_most(MOST_OF_WAY)), furthest).double(self.shift);
        gain.add(column, pull - row.velocity.at(column) * bounded(self.damper, at_most(MOST_OF_SPEED)));
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.word(u32::from(self.held.is_some()));
        if let Some((node, target)) = self.held {
            print.word((node.row << 16 | node.column) as u32);
            print.vector(target);
        }
        self.spring.fingerprint(print);
        self.damper.fingerprint(print);
        print.number(self.reach);
    }
}

/// The strength, at most `most ≤ 1`.
#[inline]
fn bounded<S: Scalar>(strength: Quotient<S>, most: S) -> S {
    let Quotient { dividend, divisor } = strength;
    if dividend > divisor * most { most } else { dividend.divide(divisor) }
}

/// The vector, shortened to the length `most` if it is longer.
#[inline]
fn shortened<S: Scalar>(vector: Vec3<S>, most: S) -> Vec3<S> {
    let length = vector.length();
    if length > most { vector * most.divide(length) } else { vector }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloth::Cloth;
    use crate::force::Gravity;
    use crate::scalar::{Q13, Q24};
    use crate::scene::Scene;
    use crate::solver::{BackwardEuler, ForwardEuler, Leapfrog, Lines, Solver, Verlet, Xpbd};

    const UNITS: Units = Units::sheet([4, 3], [0.3, 0.2], 1e-3, 0.01, 4);
    const NODE: Node = Node::new(2, 1);

    fn hand<S: Scalar>(compliance: f64, reach: f64) -> Hand<S> {
        Hand::new(&UNITS, UNITS.compliance(compliance), UNITS.damping(0.2), UNITS.length(reach))
    }

    /// Without links the particle alone hangs from the hand, as far below it as compliance and weight determine.
    fn compliance_is_as_stated<S: Scalar>() {
        let mut cloth = Cloth::<S, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        let forces = (Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])), hand::<S>(2.0, 0.1));
        let mut scene = Scene::new(&UNITS, forces, (), (), Xpbd);
        scene.forces.1.grab(&cloth, NODE);
        (0..1000).for_each(|_| scene.step(&mut cloth, &mut scene.memory()));
        let [x, y, z] = UNITS.metres(cloth.position.at(NODE));
        assert!((x - 0.2).abs() < 1e-6 && (y - 0.1).abs() < 1e-6, "{x} {y} in {}", S::NAME);
        let expected = -2.0 * 1e-3 * 9.81;
        assert!((z / expected - 1.0).abs() < 1e-3, "{z} instead of {expected} in {}", S::NAME);
        assert_eq!(scene.forces.1.drop(), Some(NODE));
        assert_eq!(scene.forces.1.held(), None);
        let before = cloth.velocity.at(NODE).length().to_f64();
        assert!(before < 1e-3, "at rest: {before}");
        scene.step(&mut cloth, &mut scene.memory());
        assert!(UNITS.metres_per_second(cloth.velocity.at(NODE))[2] < -0.09, "it falls");
    }

    #[test]
    fn compliance_is_as_stated_in_every_number_type() {
        compliance_is_as_stated::<f32>();
        compliance_is_as_stated::<f64>();
        compliance_is_as_stated::<Q24>();
        compliance_is_as_stated::<Q13>();
    }

    #[test]
    fn beyond_its_reach_a_hand_pulls_no_harder() {
        let cloth = Cloth::<f64, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        let pull = |away: f64| {
            let mut hand = hand::<f64>(2.0, 0.05);
            hand.grab(&cloth, NODE);
            hand.drag_to(cloth.position.at(NODE) + UNITS.point([0.0, 0.0, away]).to_vec());
            let mut moved = cloth;
            let scene = Scene::new(&UNITS, hand, (), (), Xpbd);
            scene.step(&mut moved, &mut scene.memory());
            UNITS.metres_per_second(moved.velocity.at(NODE))[2]
        };
        assert!((pull(0.025) / pull(0.05) - 0.5).abs() < 1e-2);
        assert!((pull(5.0) / pull(500.0) - 1.0).abs() < 1e-12);
        assert!(pull(5.0) / pull(0.05) < 1.2, "{} {}", pull(5.0), pull(0.05));
    }

    /// For any stiffness and mass, every solver brings the particle to its target, and it stays there.
    #[test]
    fn no_strength_overshoots() {
        fn check<S: Scalar, V: Solver<S>>(solver: V, [compliance, damping, inverse_mass]: [f64; 3]) {
            let mut cloth = Cloth::<S, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
            cloth.inverse_mass[NODE] = S::from_f64(inverse_mass);
            let mut hand = Hand::new(&UNITS, UNITS.compliance(compliance), UNITS.damping(damping), UNITS.length(1.0));
            hand.grab(&cloth, NODE);
            let target = cloth.position.at(NODE) + UNITS.point([0.1, -0.2, 0.3]).to_vec();
            hand.drag_to(target);
            let scene = Scene::new(&UNITS, hand, (), (), solver);
            let mut memory = scene.memory();
            (0..400).for_each(|_| scene.step(&mut cloth, &mut memory));
            let off = (cloth.position.at(NODE) - target).length().to_f64();
            assert!(off < 1e-3, "{compliance} {damping} {inverse_mass} in {}: {off}", S::NAME);
        }
        fn by_all<S: Scalar>(of: [f64; 3]) {
            check::<S, _>(Xpbd, of);
            check::<S, _>(Verlet { sweeps: 1 }, of);
            check::<S, _>(Lines::new(), of);
            check::<S, _>(BackwardEuler { newton_steps: 1 }, of);
            check::<S, _>(Leapfrog, of);
            check::<S, _>(ForwardEuler, of);
        }
        for (compliance, damping) in [(0.0, 1.0), (1e-6, 100.0), (0.01, 1.0), (0.05, 0.2)] {
            for inverse_mass in [1.0, 0.25, 4.0] {
                let of = [compliance, damping, inverse_mass];
                by_all::<f32>(of);
                by_all::<f64>(of);
                by_all::<Q24>(of);
                by_all::<Q13>(of);
            }
        }
    }

    #[test]
    fn an_empty_hand_and_a_pin_leave_the_bits() {
        fn step(forces: impl Force<Q24>) -> Cloth<Q24, 4, 3> {
            let mut cloth = Cloth::lay(&UNITS, UNITS.point([0.0; 3]));
            cloth.pin(NODE);
            let scene = Scene::new(&UNITS, forces, (), (), Xpbd);
            (0..20).for_each(|_| scene.step(&mut cloth, &mut scene.memory()));
            cloth
        }
        let gravity = Gravity::new(UNITS.acceleration([0.1, 0.2, -9.81]));
        let alone = step(gravity);
        let mut hand = hand(0.1, 0.1);
        assert_eq!(step((gravity, hand)), alone);
        hand.grab(&alone, NODE);
        hand.drag_to(Vec3::ZERO);
        assert_eq!(step((gravity, hand)), alone, "a pin stays");
    }

    #[test]
    fn a_pin_is_carried_by_a_stride_at_most() {
        fn check<S: Scalar>() {
            let mut cloth = Cloth::<S, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
            let mut hand = hand::<S>(0.1, 0.1);
            let stride = UNITS.length(0.05);
            assert_eq!(hand.carried(&cloth, stride), None);
            hand.grab(&cloth, NODE);
            assert_eq!(hand.carried(&cloth, stride), None, "a free particle is pulled");
            cloth.pin(NODE);
            let from = cloth.position.at(NODE);
            for (away, expected) in [(0.03, 0.03), (0.3, 0.05)] {
                hand.drag_to(from + UNITS.point([0.0, 0.0, away]).to_vec());
                let (node, place) = hand.carried(&cloth, stride).unwrap();
                let height = UNITS.metres(place)[2];
                assert!(node == NODE && (height - expected).abs() < 1e-6, "{height} in {}", S::NAME);
            }
        }
        check::<f32>();
        check::<f64>();
        check::<Q24>();
        check::<Q13>();
    }

    #[test]
    #[should_panic(expected = "the sheet has no particle")]
    fn a_particle_that_is_not_there_is_refused() {
        hand::<f32>(0.1, 0.1).grab(&Cloth::<f32, 4, 3>::BLANK, Node::new(4, 0));
    }
}
