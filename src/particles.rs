//! The particles that forces, links, colliders and solvers act on.

use crate::fingerprint::Fingerprint;
use crate::grid::{Grid, Node};
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// The particles of a sheet of `W` columns and `H` rows: the part of its state that changes while it moves.
///
/// A [`Cloth`](crate::Cloth) dereferences to them: pass `&cloth` or `&mut cloth` where `&Particles` or `&mut Particles` is expected.
///
/// The units are those of [`Units`](crate::Units): positions in cells, velocities in cells per tick, masses in [`Units::mass`](crate::Units::mass).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Particles<S, const W: usize, const H: usize> {
    /// Positions, cells.
    pub position: Vectors<S, W, H>,
    /// Velocities, cells per tick.
    pub velocity: Vectors<S, W, H>,
    /// Inverse masses, in 1/[`Units::mass`](crate::Units::mass): 1 for most particles, ½ for one twice as heavy, 0 for a pin.
    pub inverse_mass: Grid<S, W, H>,
}

impl<S: Scalar, const W: usize, const H: usize> Particles<S, W, H> {
    /// All zeros.
    pub const BLANK: Self = Self {
        position: Vectors::filled(Vec3::ZERO),
        velocity: Vectors::filled(Vec3::ZERO),
        inverse_mass: Grid::filled(S::ZERO),
    };

    /// Moves a particle within a substep and adds the corresponding velocity, so that the velocity remains the sum of all displacements. (The difference of two
    /// positions would lose digits.)
    #[inline]
    pub fn displace(&mut self, node: Node, by: Vec3<S>, moment: Moment) {
        self.position.add(node, by);
        self.velocity.add(node, moment.velocity(by));
    }

    /// Whether a particle is pinned.
    pub fn is_pinned(&self, node: Node) -> bool {
        self.inverse_mass[node] == S::ZERO
    }

    /// Adds every particle to a fingerprint.
    pub(crate) fn fingerprint(&self, print: &mut Fingerprint) {
        for node in Grid::<S, W, H>::nodes() {
            print.vector(self.position.at(node));
            print.vector(self.velocity.at(node));
            print.number(self.inverse_mass[node]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::{Q13, Q24};

    const W: usize = 5;
    const H: usize = 3;

    /// Particles whose components are pairwise different.
    fn scattered<S: Scalar>() -> Particles<S, W, H> {
        let mut particles = Particles::BLANK;
        for (k, node) in Grid::<S, W, H>::nodes().enumerate() {
            let number = |of: f64| (7.0 * k as f64 + of).sin();
            particles.position.set(node, Vec3::from_f64([0.0, 1.0, 2.0].map(number)));
            particles.velocity.set(node, Vec3::from_f64([3.0, 4.0, 5.0].map(number)));
            particles.inverse_mass[node] = S::from_f64(number(6.0));
        }
        particles
    }

    fn print<S: Scalar>(particles: &Particles<S, W, H>) -> Fingerprint {
        let mut print = Fingerprint::new();
        particles.fingerprint(&mut print);
        print
    }

    /// The seven numbers of a particle.
    fn numbers<S: Scalar>(particles: &mut Particles<S, W, H>, node: Node) -> [&mut S; 7] {
        let Node { column, row } = node;
        let (x, v) = (&mut particles.position.0[row], &mut particles.velocity.0[row]);
        let [x, v] = [x, v].map(|row| [&mut row.x[column], &mut row.y[column], &mut row.z[column]]);
        let ([a, b, c], [d, e, f]) = (x, v);
        [a, b, c, d, e, f, &mut particles.inverse_mass[node]]
    }

    fn every_change_shows<S: Scalar>() {
        let same = scattered::<S>();
        let shows = |changed: &Particles<S, W, H>| !print(&same).matches(print(changed));
        assert!(!shows(&scattered()));
        let least = S::from_f64(2.0 * S::RESOLUTION);
        for node in Grid::<S, W, H>::nodes() {
            let next = Node::new((node.column + 1) % W, node.row);
            for k in 0..7 {
                let mut changed = same;
                *numbers(&mut changed, node)[k] += least;
                assert!(shows(&changed), "number {k} of {node:?} in {}", S::NAME);
                // two neighbours moved towards each other; two numbers of one particle changed in opposite directions
                let (mut pinched, mut turned) = (changed, changed);
                *numbers(&mut pinched, next)[k] -= least;
                *numbers(&mut turned, node)[(k + 3) % 7] -= least;
                assert!(shows(&pinched) && shows(&turned), "number {k} of {node:?} in {}", S::NAME);
            }
            let mut swapped = same;
            swapped.inverse_mass[node] = same.inverse_mass[next];
            swapped.inverse_mass[next] = same.inverse_mass[node];
            assert!(shows(&swapped), "{node:?} in {}", S::NAME);
        }
        for change in [|x: Vec3<S>| -x, |x| x + x, |_| Vec3::ZERO] {
            let mut changed = same;
            changed.position.change(change);
            changed.velocity.change(change);
            assert!(shows(&changed), "in {}", S::NAME);
        }
    }

    #[test]
    fn every_change_shows_in_every_number_type() {
        every_change_shows::<f32>();
        every_change_shows::<f64>();
        every_change_shows::<Q24>();
        every_change_shows::<Q13>();
    }
}
