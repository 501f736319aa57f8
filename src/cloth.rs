//! The state of a sheet.

use crate::grid::{Grid, Node};
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::units::{Point, Units};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// A sheet of `W` columns and `H` rows of particles: all that changes while it moves.
///
/// The units are those of [`Units`]: positions in cells, velocities in cells per tick, masses in ordinary particles. A sheet of one
/// column is a chain.
///
/// ```
/// use kerchief::{Cloth, Node, Point, Q24, Units};
///
/// const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
/// let mut cloth = Cloth::<Q24, 16, 16>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
/// cloth.pin(Node::new(0, 0));
/// cloth.pin(Node::new(15, 0));
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cloth<S, const W: usize, const H: usize> {
    /// Where the particles are, cells.
    pub position: Vectors<S, W, H>,
    /// How fast they move, cells per tick.
    pub velocity: Vectors<S, W, H>,
    /// One over a particle's mass in ordinary particles: 1 for most, ½ for one twice as heavy, 0 for a pin.
    pub inverse_mass: Grid<S, W, H>,
}

impl<S: Scalar, const W: usize, const H: usize> Cloth<S, W, H> {
    /// Nothing but zeros: room in a `static` for a sheet that is [laid](Self::lay_here) or [hung](Self::hang_here) there, so that it is never on the stack.
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
    pub const BLANK: Self = Self {
        position: Vectors::filled(Vec3::ZERO),
        velocity: Vectors::filled(Vec3::ZERO),
        inverse_mass: Grid::filled(S::ZERO),
    };

    /// A flat sheet in the x-y plane: particle (0, 0) at `origin`, columns along x, rows along y.
    pub fn lay(units: &Units, origin: Point) -> Self {
        let mut cloth = Self::BLANK;
        cloth.lay_here(units, origin);
        cloth
    }

    /// An upright sheet in the x-z plane: row 0 on top, particle (0, 0) at `origin`.
    pub fn hang(units: &Units, origin: Point) -> Self {
        let mut cloth = Self::BLANK;
        cloth.hang_here(units, origin);
        cloth
    }

    /// Makes a [flat sheet](Self::lay) of it, whatever it was: at rest, no pins.
    pub fn lay_here(&mut self, units: &Units, origin: Point) {
        self.spread(units, origin, |down| Vec3::new(S::ZERO, down, S::ZERO));
    }

    /// Makes an [upright sheet](Self::hang) of it, whatever it was: at rest, no pins.
    pub fn hang_here(&mut self, units: &Units, origin: Point) {
        self.spread(units, origin, |down| Vec3::new(S::ZERO, S::ZERO, -down));
    }

    fn spread(&mut self, units: &Units, origin: Point, down: impl Fn(S) -> Vec3<S>) {
        let [across, along] = units.sides.map(S::from_f64);
        let origin = origin.to_vec();
        for node in Grid::<S, W, H>::nodes() {
            let place = down(along.times(node.row as i32));
            let place = origin + (place + Vec3::new(across.times(node.column as i32), S::ZERO, S::ZERO));
            self.position.set(node, place);
            self.velocity.set(node, Vec3::ZERO);
            self.inverse_mass[node] = S::ONE;
        }
    }

    /// Makes border particles `factor` times as heavy as they are (`factor > 0`).
    pub fn hem(&mut self, factor: S) {
        for node in Grid::<S, W, H>::nodes() {
            if is_border(node, W, H) {
                self.inverse_mass[node] = self.inverse_mass[node].divide(factor);
            }
        }
    }

    /// Gives each particle the mass of its share of the cells: where an inner particle has mass 1, one on an edge has ½ and one in a
    /// corner ¼.
    pub fn share_area(&mut self) {
        for node in Grid::<S, W, H>::nodes() {
            let halvings =
                u32::from(node.column == 0 || node.column + 1 == W) + u32::from(node.row == 0 || node.row + 1 == H);
            self.inverse_mass[node] = S::ONE.double(halvings);
        }
    }

    /// Holds a particle where it is.
    pub fn pin(&mut self, node: Node) {
        self.inverse_mass[node] = S::ZERO;
        self.velocity.set(node, Vec3::ZERO);
    }

    /// Lets a pinned particle go, with this inverse mass.
    pub fn release(&mut self, node: Node, inverse_mass: S) {
        self.inverse_mass[node] = inverse_mass;
    }

    /// Moves a particle within a substep: its velocity takes part, so that it stays the sum of what moved the particle. (The difference
    /// of two positions would lose its digits.)
    #[inline]
    pub fn displace(&mut self, node: Node, by: Vec3<S>, moment: Moment) {
        self.position.add(node, by);
        self.velocity.add(node, moment.velocity(by));
    }

    /// Moves `a` by `by` and `b` against it, each times its inverse mass.
    #[inline]
    pub fn pull(&mut self, a: Node, b: Node, by: Vec3<S>, moment: Moment) {
        self.displace(a, by * self.inverse_mass[a], moment);
        self.displace(b, -(by * self.inverse_mass[b]), moment);
    }

    /// Whether a particle is pinned.
    pub fn is_pinned(&self, node: Node) -> bool {
        self.inverse_mass[node] == S::ZERO
    }
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
}
