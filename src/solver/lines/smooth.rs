//! Split sheets that hardly move are smoothed.
//!
//! A part of a substep has few sweeps, and what they leave of a strain moves particles within a very short time: a residual of half a percent in parts of half a millisecond is a velocity
//! of a metre a second. It excites what the next part has to solve, and a nearly rigid sheet that should come to rest goes on shaking. Neighbours shake against each
//! other; so while nothing moves far in a substep, each velocity is drawn towards its neighbours' in every part: `v' = v + min(w, 1)/8·Σ(v_j − v)`. It takes energy, moves nothing
//! that is at rest, and leaves whole sheets their motion.

use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// How far particles of a sheet that is smoothed move at most in a substep, cells.
pub(super) const SLOW: f64 = 0.3;

/// The part of a neighbour's difference, as a power of two: less than a half for all four.
const PART: u32 = 3;

/// Draws velocities towards those of their neighbours.
#[inline(never)] // one for all scenes
pub(super) fn smooth<S: Scalar, const W: usize, const H: usize>(particles: &mut Particles<S, W, H>) {
    let mut above = particles.velocity.0[0];
    for row in 0..H {
        let here = particles.velocity.0[row];
        let below = if row + 1 < H { particles.velocity.0[row + 1] } else { here };
        let w = &particles.inverse_mass.0[row];
        let velocity = &mut particles.velocity.0[row];
        for column in 0..W {
            let v = here.at(column);
            let missing = |neighbour: Vec3<S>| (neighbour - v).map(|x| x.halve_evenly(PART));
            let beside = |column: usize| if column < W { missing(here.at(column)) } else { Vec3::ZERO };
            // in this order a mirrored row is smoothed as the mirror image
            let across = beside(column.wrapping_sub(1)) + beside(column + 1);
            let down = missing(above.at(column)) + missing(below.at(column));
            velocity.add(column, (across + down) * w[column].min(S::ONE));
        }
        above = here;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloth::Cloth;
    use crate::grid::{Grid, Node};
    use crate::scalar::{Q13, Q24};

    type Sheet<S> = Cloth<S, 4, 3>;

    /// A sheet of free particles.
    fn free<S: Scalar>() -> Sheet<S> {
        let mut cloth = Sheet::BLANK;
        cloth.inverse_mass = Grid::filled(S::ONE);
        cloth
    }

    /// A sheet of which one particle is pinned and each has another velocity, or its mirror image.
    fn shaken<S: Scalar>(mirrored: bool) -> Sheet<S> {
        let mut cloth = free();
        let place = |node: Node| if mirrored { Node::new(3 - node.column, node.row) } else { node };
        for (k, node) in Grid::<S, 4, 3>::nodes().enumerate() {
            let number = |a: f64| (a * k as f64).sin();
            cloth.velocity.set(place(node), Vec3::from_f64([number(7.3), number(2.1), number(4.7)]));
        }
        cloth.pin(place(Node::new(1, 0)));
        cloth
    }

    fn shaking_fades<S: Scalar>() {
        let mut cloth = shaken::<S>(false);
        let energy = |cloth: &Sheet<S>| cloth.velocity.values().map(|v| v.dot(v).to_f64()).sum::<f64>();
        let pin = Node::new(1, 0);
        let [start, held] = [energy(&cloth), cloth.velocity.at(pin).to_f64()[0]];
        smooth(&mut cloth);
        assert!(energy(&cloth) < 0.7 * start, "{} of {start} in {}", energy(&cloth), S::NAME);
        assert_eq!(cloth.velocity.at(pin).to_f64()[0], held, "a pin in {}", S::NAME);
    }

    #[test]
    fn neighbours_stop_shaking_against_each_other() {
        shaking_fades::<f32>();
        shaking_fades::<Q24>();
        shaking_fades::<Q13>();
    }

    #[test]
    fn what_moves_as_a_whole_goes_on() {
        let mut cloth = free::<Q24>();
        let v = Vec3::from_f64([0.1, -2.3, 4.5]);
        Grid::<Q24, 4, 3>::nodes().for_each(|node| cloth.velocity.set(node, v));
        smooth(&mut cloth);
        assert!(cloth.velocity.values().all(|found| found == v));
    }

    #[test]
    fn a_mirrored_sheet_is_smoothed_as_the_mirror_image() {
        let [mut cloth, mut image] = [false, true].map(shaken::<f32>);
        smooth(&mut cloth);
        smooth(&mut image);
        for node in Grid::<f32, 4, 3>::nodes() {
            assert_eq!(cloth.velocity.at(node), image.velocity.at(Node::new(3 - node.column, node.row)));
        }
    }
}
