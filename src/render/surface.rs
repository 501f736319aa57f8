//! The smooth surface through the particles.

use crate::grid::Node;
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// A point of the surface through all particles by cubic splines along rows and columns: the tangent at a particle is that of the chord
/// between its neighbours (Catmull and Rom, "A class of local interpolating splines", 1974). The border is extrapolated linearly.
///
/// `corner` is the first corner of a cell; `across` and `down` (0 to 1) are the position in the cell.
pub(super) fn point<S: Scalar, const W: usize, const H: usize>(
    position: &Vectors<S, W, H>,
    corner: Node,
    across: S,
    down: S,
) -> Vec3<S> {
    let (horizontal, vertical) = (weights(across), weights(down));
    let row = |k: usize| {
        let row = corner.row as i32 + k as i32 - 1;
        let at = |k: usize| beyond_rows(position, corner.column as i32 + k as i32 - 1, row);
        blend(horizontal, at)
    };
    blend(vertical, row)
}

/// The weighted sum of four points. Where one weight is 1, the other points are not computed.
fn blend<S: Scalar>(weights: [S; 4], point: impl Fn(usize) -> Vec3<S>) -> Vec3<S> {
    match weights {
        [_, one, _, _] if one == S::ONE => point(1),
        [_, _, one, _] if one == S::ONE => point(2),
        _ => point(0) * weights[0] + point(1) * weights[1] + point(2) * weights[2] + point(3) * weights[3],
    }
}

/// The weights of four points. At 0 the second weight is exactly 1, at 1 the third: neighbouring cells meet without a gap.
fn weights<S: Scalar>(u: S) -> [S; 4] {
    let square = u * u;
    let cube = square * u;
    let first = square - (u + cube).halve(1);
    let third = u.halve(1) + square.double(1) - (cube.times(3)).halve(1);
    let fourth = (cube - square).halve(1);
    [first, S::ONE - first - third - fourth, third, fourth]
}

fn beyond_rows<S: Scalar, const W: usize, const H: usize>(
    position: &Vectors<S, W, H>,
    column: i32,
    row: i32,
) -> Vec3<S> {
    let last = H as i32 - 1;
    if row < 0 {
        beyond_columns(position, column, 0).double(1) - beyond_columns(position, column, 1)
    } else if row > last {
        beyond_columns(position, column, last).double(1) - beyond_columns(position, column, last - 1)
    } else {
        beyond_columns(position, column, row)
    }
}

fn beyond_columns<S: Scalar, const W: usize, const H: usize>(
    position: &Vectors<S, W, H>,
    column: i32,
    row: i32,
) -> Vec3<S> {
    let at = |column: i32| position.at(Node::new(column as usize, row as usize));
    let last = W as i32 - 1;
    if column < 0 {
        at(0).double(1) - at(1)
    } else if column > last {
        at(last).double(1) - at(last - 1)
    } else {
        at(column)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;
    use crate::scalar::Q24;

    /// A sheet on z = x² − y, in quarters so that all types represent it exactly.
    fn sheet<S: Scalar>() -> Vectors<S, 5, 4> {
        let mut grid = Vectors::filled(Vec3::ZERO);
        for node in Grid::<S, 5, 4>::nodes() {
            let (x, y) = (node.column as f64 / 2.0, node.row as f64 / 2.0);
            grid.set(node, Vec3::from_f64([x, y, x * x - y]));
        }
        grid
    }

    #[test]
    fn a_parabola_is_met_between_its_points() {
        fn check<S: Scalar>(bound: f64) {
            let [x, y, z] = point(&sheet::<S>(), Node::new(1, 1), S::from_f64(0.3), S::from_f64(0.7)).to_f64();
            assert!((x - 0.65).abs() < bound && (y - 0.85).abs() < bound, "{x} {y}");
            assert!((z - (x * x - y)).abs() < bound, "{z}");
        }
        check::<f64>(1e-14);
        check::<f32>(1e-6);
        check::<Q24>(1e-6);
    }

    #[test]
    fn cells_meet_in_the_same_bits() {
        fn check<S: Scalar>() {
            let grid = sheet::<S>();
            for k in 0..=8 {
                let u = S::from_int(k).divide(S::from_int(8));
                assert_eq!(point(&grid, Node::new(0, 1), S::ONE, u), point(&grid, Node::new(1, 1), S::ZERO, u));
                assert_eq!(point(&grid, Node::new(2, 0), u, S::ONE), point(&grid, Node::new(2, 1), u, S::ZERO));
            }
            assert_eq!(point(&grid, Node::new(3, 2), S::ONE, S::ONE), grid.at(Node::new(4, 3)));
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }
}
