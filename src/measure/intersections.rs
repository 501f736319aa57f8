//! Intersections of a sheet with itself.

use core::array;

use crate::grid::Node;
use crate::particles::Particles;
use crate::scalar::Scalar;

/// The steps per cell in which positions are counted: fixed-point positions are represented exactly, and so the signs below are exact.
const PARTS: f64 = 16_777_216.0;

/// Positions further from the origin, cells, are clamped to this distance.
const FAR: f64 = 8192.0;

type Place = [i64; 3];

/// The number of pairs of an edge and a triangle of the sheet that intersect. A cell consists of two triangles. Edges run along rows and columns and along the
/// diagonal between the two triangles. An edge and a triangle with a common corner are not counted. Every pair is tested by the signs of volumes in whole
/// numbers, unless the triangle's bounding box is apart from that of the edge's row.
///
/// Takes 24 bytes of stack per particle: this function is for hosts.
pub fn intersections<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>) -> u32 {
    // the conversion turns undefined components into 0
    let place = |node: Node| particles.position.at(node).to_f64().map(|x| (x.clamp(-FAR, FAR) * PARTS) as i64);
    let places: [[Place; W]; H] = array::from_fn(|row| array::from_fn(|column| place(Node { column, row })));
    // the bounding boxes of the edges that begin in a row
    let around: [_; H] = array::from_fn(|row| bounds(places[row..H.min(row + 2)].as_flattened()));
    count(places.as_flattened(), W, &around)
}

/// [`intersections`] for a grid of any size: compiled once.
fn count(places: &[Place], columns: usize, around: &[[Place; 2]]) -> u32 {
    let rows = around.len();
    let mut count = 0;
    for corner in (1..rows).flat_map(|row| (1..columns).map(move |column| row * columns + column)) {
        let [left, up] = [1, columns];
        for triangle in [[corner - left - up, corner - up, corner - left], [corner - up, corner, corner - left]] {
            let corners = triangle.map(|corner| places[corner]);
            let near = bounds(&corners);
            for row in (0..rows).filter(|row| meet(near, around[*row])) {
                each_edge(row, [columns, rows], |edge| {
                    let ends = edge.map(|end| places[end]);
                    if meet(near, bounds(&ends))
                        && !edge.iter().any(|end| triangle.contains(end))
                        && passes_through(ends, corners)
                    {
                        count += 1;
                    }
                });
            }
        }
    }
    count
}

/// The edges that begin in a row, by the indices of their ends.
fn each_edge(row: usize, [columns, rows]: [usize; 2], mut visit: impl FnMut([usize; 2])) {
    for column in 0..columns {
        let node = row * columns + column;
        let (right, down) = (column + 1 < columns, row + 1 < rows);
        if right {
            visit([node, node + 1]);
        }
        if down {
            visit([node, node + columns]);
        }
        if right && down {
            visit([node + 1, node + columns]);
        }
    }
}

fn bounds(places: &[Place]) -> [Place; 2] {
    let fold = |choose: fn(i64, i64) -> i64| {
        array::from_fn(|axis| places.iter().map(|place| place[axis]).reduce(choose).unwrap_or(0))
    };
    [fold(i64::min), fold(i64::max)]
}

fn meet([low, high]: [Place; 2], [other_low, other_high]: [Place; 2]) -> bool {
    (0..3).all(|axis| low[axis] <= other_high[axis] && other_low[axis] <= high[axis])
}

/// Whether an edge passes through the interior of a triangle.
fn passes_through([p, q]: [Place; 2], [a, b, c]: [Place; 3]) -> bool {
    side(a, b, c, p) * side(a, b, c, q) < 0 && {
        let sides = [side(p, q, a, b), side(p, q, b, c), side(p, q, c, a)];
        sides == [1; 3] || sides == [-1; 3]
    }
}

/// The side of the triangle a, b, c on which a point lies: 1, −1, or 0 in its plane.
fn side(a: Place, b: Place, c: Place, p: Place) -> i32 {
    let from = |x: Place| -> [i128; 3] { array::from_fn(|axis| i128::from(x[axis] - a[axis])) };
    let ([bx, by, bz], [cx, cy, cz], [px, py, pz]) = (from(b), from(c), from(p));
    let volume = px * (by * cz - bz * cy) + py * (bz * cx - bx * cz) + pz * (bx * cy - by * cx);
    volume.signum() as i32
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloth::Cloth;
    use crate::units::Units;
    use crate::vec3::Vec3;

    const UNITS: Units = Units::sheet([6, 3], [5.0, 2.0], 1.0, 0.1, 1);

    #[test]
    fn a_strip_that_is_bent_through_itself_is_counted() {
        let mut strip = Cloth::<f64, 6, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        assert_eq!(intersections(&strip), 0);
        // the end turns back, and down through the middle of the second row of cells
        for row in 0..3 {
            let y = row as f64;
            let at = |x: f64, z: f64| Vec3::from_f64([x, y + 0.25, z]);
            strip.position.set(Node::new(4, row), at(1.4, 1.0));
            strip.position.set(Node::new(5, row), at(1.4, -0.5));
        }
        // three edges and two diagonals of the end pass through the strip; no edge of the strip passes through the end, as they lie beside it
        let down = intersections(&strip);
        assert!(down >= 4, "{down}");
        for row in 0..3 {
            strip.position.add(Node::new(5, row), Vec3::from_f64([0.0, 0.0, 0.75]));
        }
        assert_eq!(intersections(&strip), 0);
    }

    #[test]
    fn looking_at_rows_that_are_near_finds_all() {
        const EVERYWHERE: [Place; 2] = [[i64::MIN; 3], [i64::MAX; 3]];
        let mut sheet = Cloth::<f64, 6, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        let mut seed = 1_u32;
        let mut random = || {
            seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(seed >> 8) / PARTS
        };
        let mut found = 0;
        for _ in 0..50 {
            sheet.position.change(|x| x + Vec3::from_f64([random(), 3.0 * random(), random()]));
            let place = |node| sheet.position.at(node).to_f64().map(|x| (x * PARTS) as i64);
            let places: [Place; 18] = array::from_fn(|k| place(Node { column: k % 6, row: k / 6 }));
            let count = intersections(&sheet);
            assert_eq!(count, super::count(&places, 6, &[EVERYWHERE; 3]));
            found += count;
        }
        assert!(found > 100, "{found}");
    }

    #[test]
    fn an_edge_passes_through_a_triangle_or_beside_it() {
        let triangle = [[0, 0, 0], [4, 0, 0], [0, 4, 0]];
        assert!(passes_through([[1, 1, -1], [1, 1, 1]], triangle));
        assert!(passes_through([[1, 1, 1], [1, 1, -1]], triangle));
        for edge in [[[3, 3, -1], [3, 3, 1]], [[1, 1, 1], [1, 1, 2]], [[1, 1, 0], [2, 1, 0]], [[0, 0, -1], [0, 0, 1]]] {
            assert!(!passes_through(edge, triangle), "{edge:?}");
        }
    }
}
