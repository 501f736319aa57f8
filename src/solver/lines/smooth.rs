//! Split sheets that hardly move are smoothed.
//!
//! A part of a substep has few sweeps, and what they leave of a strain moves particles within a very short time: a residual of half a percent in parts of half a millisecond is a velocity
//! of a metre a second. It excites what the next part has to solve, and a nearly rigid sheet that should come to rest goes on shaking. Neighbours shake against each
//! other; so while nothing moves far in a substep, every part takes the sharpest bends out of the velocities of rows, then of columns: `v' = v − min(w, 1)/16·DᵀD·v` with second differences D.
//! What shakes from particle to particle is gone. It takes energy and moves nothing that is at rest; a sheet that moves or turns as a whole, or swings in long waves, is left its motion.

use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// How far particles of a sheet that is smoothed move at most in a substep, cells.
pub(super) const SLOW: f64 = 0.3;

/// How far particles of a sheet move at most in a substep that is as good as at rest, cells: it needs no smoothing, which would be one more rounding.
pub(super) const STILL: f64 = 1e-3;

/// Takes the sharpest bends out of velocities.
#[inline(never)] // one for all scenes
pub(super) fn smooth<S: Scalar, const W: usize, const H: usize>(particles: &mut Particles<S, W, H>) {
    let (velocity, inverse_mass) = (&mut particles.velocity.0, &particles.inverse_mass.0);
    for (row, w) in velocity.iter_mut().zip(inverse_mass) {
        straighten(&mut row.x, w);
        straighten(&mut row.y, w);
        straighten(&mut row.z, w);
    }
    for axis in 0..3 {
        for column in 0..W {
            let (mut line, mut w) = ([S::ZERO; H], [S::ZERO; H]);
            for (row, velocity) in velocity.iter_mut().enumerate() {
                (line[row], w[row]) = (component(velocity, axis)[column], inverse_mass[row][column]);
            }
            straighten(&mut line, &w);
            for (velocity, line) in velocity.iter_mut().zip(line) {
                component(velocity, axis)[column] = line;
            }
        }
    }
}

fn component<S, const W: usize>(row: &mut Vec3<[S; W]>, axis: usize) -> &mut [S; W] {
    match axis {
        0 => &mut row.x,
        1 => &mut row.y,
        _ => &mut row.z,
    }
}

/// The same for the velocities of a row or a column along an axis. Outer ones are added first, so that a mirrored line becomes the mirror image.
#[inline(never)] // of any length: one for all
fn straighten<S: Scalar>(v: &mut [S], inverse_mass: &[S]) {
    let [mut before, mut here] = [S::ZERO; 2];
    for (k, w) in inverse_mass.iter().enumerate().take(v.len()) {
        // a sixteenth of the second difference around the next particle, whose neighbours are not changed yet
        let after = if k + 2 < v.len() { (v[k] + v[k + 2] - (v[k + 1] + v[k + 1])).halve_evenly(4) } else { S::ZERO };
        v[k] += (here + here - (before + after)) * w.min(S::ONE);
        [before, here] = [here, after];
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
    fn what_moves_and_turns_as_a_whole_goes_on() {
        let mut cloth = free::<Q24>();
        let at = |node: Node| Vec3::from_f64([0.125 + node.row as f64, -2.25 * node.column as f64, 4.5]);
        Grid::<Q24, 4, 3>::nodes().for_each(|node| cloth.velocity.set(node, at(node)));
        smooth(&mut cloth);
        Grid::<Q24, 4, 3>::nodes().for_each(|node| assert_eq!(cloth.velocity.at(node), at(node)));
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
