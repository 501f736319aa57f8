//! The state of a sheet.

use core::num::NonZeroU32;
use core::ops::{Deref, DerefMut};

use crate::fingerprint::Fingerprint;
use crate::grid::{Grid, Node};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::{Point, Units};
use crate::vec3::Vec3;

/// A sheet of `W` columns and `H` rows of particles. A sheet of one column is a chain.
///
/// It dereferences to its [`Particles`]: `cloth.position`, `cloth.velocity`, `cloth.inverse_mass`. It also tracks whether they may have changed, so that a
/// sheet [at rest](crate::rest) needs not read each of them.
///
/// ```
/// use kerchief::{Cloth, Node, Q24, Units, Vec3};
///
/// const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
/// let mut cloth = Cloth::<Q24, 16, 16>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
/// cloth.pin(Node::new(0, 0));
/// cloth.pin(Node::new(15, 0));
/// cloth.velocity.set(Node::new(8, 15), Vec3::from_f64(UNITS.velocity([0.0, 0.5, 0.0]).0));
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Cloth<S, const W: usize, const H: usize> {
    particles: Particles<S, W, H>,
    /// A hash of the particles; `None` if they may have changed since it was computed. `None` has only zero bits, so that [`BLANK`](Self::BLANK) consists of
    /// zeros and takes no flash.
    hash: Option<NonZeroU32>,
}

impl<S: Scalar, const W: usize, const H: usize> Cloth<S, W, H> {
    /// All zeros: the initial value of a `static` in which a sheet is [laid](Self::lay_here) or [hung](Self::hang_here) in place, so that it is never on the
    /// stack.
    ///
    /// ```
    /// use std::sync::Mutex; // on a board a cell of the crate `static_cell`
    /// use kerchief::{Cloth, Q24, Units};
    ///
    /// const UNITS: Units = Units::sheet([32, 32], [0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
    /// static SHEET: Mutex<Cloth<Q24, 32, 32>> = Mutex::new(Cloth::BLANK);
    ///
    /// let mut sheet = SHEET.lock().unwrap();
    /// sheet.hang_here(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
    /// assert_eq!(*sheet, Cloth::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3])));
    /// ```
    pub const BLANK: Self = Self { particles: Particles::BLANK, hash: None };

    /// A flat sheet in the x-y plane: particle (0, 0) at `origin`, columns along x, rows along y.
    ///
    /// # Panics
    /// If a particle would be beyond the range of the number type.
    #[track_caller]
    pub fn lay(units: &Units, origin: Point) -> Self {
        let mut cloth = Self::BLANK;
        cloth.lay_here(units, origin);
        cloth
    }

    /// An upright sheet in the x-z plane: row 0 on top, particle (0, 0) at `origin`.
    ///
    /// # Panics
    /// If a particle would be beyond the range of the number type.
    #[track_caller]
    pub fn hang(units: &Units, origin: Point) -> Self {
        let mut cloth = Self::BLANK;
        cloth.hang_here(units, origin);
        cloth
    }

    /// Makes it a [flat sheet](Self::lay) at rest, without pins, whatever it was before.
    ///
    /// # Panics
    /// If a particle would be beyond the range of the number type.
    #[track_caller]
    pub fn lay_here(&mut self, units: &Units, origin: Point) {
        self.spread(units, origin, |down| Vec3::new(S::ZERO, down, S::ZERO));
    }

    /// Makes it an [upright sheet](Self::hang) at rest, without pins, whatever it was before.
    ///
    /// # Panics
    /// If a particle would be beyond the range of the number type.
    #[track_caller]
    pub fn hang_here(&mut self, units: &Units, origin: Point) {
        self.spread(units, origin, |down| Vec3::new(S::ZERO, S::ZERO, -down));
    }

    #[track_caller]
    fn spread(&mut self, units: &Units, origin: Point, down: impl Fn(S) -> Vec3<S>) {
        origin.check::<S>();
        let [across, along] = units.sides.map(S::from_f64);
        let origin = origin.to_vec();
        let down_a_cell = down(along);
        let steps = [(origin.x, across, W), (origin.y, down_a_cell.y, H), (origin.z, down_a_cell.z, H)];
        assert!(
            steps.into_iter().all(|(from, step, count)| does_not_wrap(from, step, count)),
            "a place is not finite, or beyond the range of the number type"
        );
        for node in Grid::<S, W, H>::nodes() {
            let place = down(along.times(node.row as i32));
            let place = origin + (place + Vec3::new(across.times(node.column as i32), S::ZERO, S::ZERO));
            self.position.set(node, place);
            self.velocity.set(node, Vec3::ZERO);
            self.inverse_mass[node] = S::ONE;
        }
    }

    /// Multiplies the masses of the particles on the border by `factor` (`factor > 0`).
    ///
    /// # Panics
    /// For any other factor, and in fixed point for a factor that leaves less than 1/127 of a particle's mass.
    #[track_caller]
    pub fn hem(&mut self, factor: S) {
        assert!(factor > S::ZERO && factor.is_finite(), "a hem's factor is positive and finite");
        for node in Grid::<S, W, H>::nodes() {
            if is_border(node, W, H) {
                let inverse_mass = self.inverse_mass[node].divide(factor);
                assert!(inverse_mass.is_within(S::from_int(127)), "a hem is too light for the number type");
                self.inverse_mass[node] = inverse_mass;
            }
        }
    }

    /// Gives each particle the mass of its share of the cells: 1 for an inner particle, ½ on an edge, ¼ in a corner. This overwrites hems and pins: call it
    /// before them.
    pub fn share_area(&mut self) {
        for node in Grid::<S, W, H>::nodes() {
            let halvings =
                u32::from(node.column == 0 || node.column + 1 == W) + u32::from(node.row == 0 || node.row + 1 == H);
            self.inverse_mass[node] = S::ONE.double(halvings);
        }
    }

    /// Pins a particle at its present position.
    ///
    /// # Panics
    /// If the sheet has no such particle.
    #[track_caller]
    pub fn pin(&mut self, node: Node) {
        check_node::<W, H>(node);
        self.inverse_mass[node] = S::ZERO;
        self.velocity.set(node, Vec3::ZERO);
    }

    /// Releases a pinned particle and gives it this inverse mass.
    ///
    /// # Panics
    /// If the sheet has no such particle, or the inverse mass is negative or not finite.
    #[track_caller]
    pub fn release(&mut self, node: Node, inverse_mass: S) {
        check_node::<W, H>(node);
        assert!(inverse_mass >= S::ZERO && inverse_mass.is_finite(), "an inverse mass is finite, zero or above");
        self.inverse_mass[node] = inverse_mass;
    }

    /// Adds the particles to a fingerprint. It reads them only if they may have changed since the last call.
    pub(crate) fn fingerprint(&mut self, print: &mut Fingerprint) {
        let hash = self.hash.map_or_else(
            || {
                let mut print = Fingerprint::new();
                self.particles.fingerprint(&mut print);
                print.hash()
            },
            NonZeroU32::get,
        );
        // one hash in 2³² is zero: it is computed anew each time
        self.hash = NonZeroU32::new(hash);
        print.word(hash);
    }
}

impl<S, const W: usize, const H: usize> Deref for Cloth<S, W, H> {
    type Target = Particles<S, W, H>;

    #[inline]
    fn deref(&self) -> &Self::Target {
        &self.particles
    }
}

/// Every mutable access counts as a change.
impl<S, const W: usize, const H: usize> DerefMut for Cloth<S, W, H> {
    #[inline]
    fn deref_mut(&mut self) -> &mut Self::Target {
        self.hash = None;
        &mut self.particles
    }
}

/// Sheets are equal if their particles are.
impl<S: PartialEq, const W: usize, const H: usize> PartialEq for Cloth<S, W, H> {
    fn eq(&self, other: &Self) -> bool {
        self.particles == other.particles
    }
}

#[track_caller]
const fn check_node<const W: usize, const H: usize>(node: Node) {
    assert!(node.column < W && node.row < H, "the sheet has no particle in this column and row");
}

/// Whether successive positions along an axis stay in the range. In fixed point a position beyond it would wrap to the other end.
fn does_not_wrap<S: Scalar>(from: S, step: S, count: usize) -> bool {
    let mut place = from;
    (1..count).all(|_| {
        let before = place;
        place += step;
        place == before || ((place > before) == (step > S::ZERO) && place.is_finite())
    })
}

/// Whether a node lies on the border of a grid of `columns` × `rows`.
pub(crate) const fn is_border(node: Node, columns: usize, rows: usize) -> bool {
    node.column == 0 || node.row == 0 || node.column + 1 == columns || node.row + 1 == rows
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNITS: Units = Units::sheet([4, 3], [3.0, 4.0], 1.0, 0.1, 1);

    #[test]
    fn a_laid_sheet_is_flat_and_a_hung_one_upright() {
        let laid = Cloth::<f64, 4, 3>::lay(&UNITS, UNITS.point([2.0, 0.0, 1.0]));
        assert_eq!(laid.position.at(Node::new(3, 2)), Vec3::new(2.5, 2.0, 0.5));
        let hung = Cloth::<f64, 4, 3>::hang(&UNITS, UNITS.point([2.0, 0.0, 1.0]));
        assert_eq!(hung.position.at(Node::new(3, 2)), Vec3::new(2.5, 0.0, -1.5));
    }

    #[test]
    fn shares_and_hems_act_on_the_border() {
        let mut cloth = Cloth::<f64, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        cloth.share_area();
        cloth.hem(2.0);
        let rows = cloth.inverse_mass.0;
        assert_eq!(rows, [[2.0, 1.0, 1.0, 2.0], [1.0, 1.0, 1.0, 1.0], [2.0, 1.0, 1.0, 2.0]]);
    }

    #[test]
    fn a_pin_is_held_until_it_is_released() {
        let mut cloth = Cloth::<f32, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        let node = Node::new(1, 1);
        cloth.pin(node);
        assert!(cloth.is_pinned(node));
        cloth.release(node, 1.0);
        assert!(!cloth.is_pinned(node));
    }
    #[test]
    fn particles_are_looked_at_once_after_they_may_have_changed() {
        fn print(cloth: &mut Cloth<f32, 4, 3>) -> Fingerprint {
            let mut print = Fingerprint::new();
            cloth.fingerprint(&mut print);
            print
        }
        let node = Node::new(2, 1);
        let mut cloth = Cloth::<f32, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        assert_eq!(cloth.hash, None);
        let laid = print(&mut cloth);
        let known = cloth.hash;
        assert!(known.is_some() && print(&mut cloth).matches(laid));
        assert!(!cloth.is_pinned(node) && cloth.position.values().count() == 12 && cloth.hash == known);
        let mut copy = cloth;
        copy.pin(node);
        assert_eq!((copy.hash, cloth.hash), (None, known));
        assert!(!print(&mut copy).matches(laid) && copy != cloth);
        copy.release(node, 1.0);
        assert!(copy == cloth && copy.hash.is_none());
        assert!(print(&mut copy).matches(laid) && copy.hash == known);
    }
}
