//! A sheet in the form that graphics engines use: positions and normals in `f32`, triangles, texture coordinates.
//!
//! [`Mesh`] stores the numbers of a frame in flat slices, ready to be copied into a vertex buffer; its [triangles](Mesh::triangles) and [texture
//! coordinates](Mesh::texture) never change. Vertices are the particles, row by row. To fill an existing buffer, use the iterators [`positions`] and
//! [`normals`] without a mesh.
//!
//! ```
//! use kerchief::{Cloth, Mesh, Q24, Units};
//!
//! const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
//! const INDICES: [[u16; 3]; Mesh::<16, 16>::TRIANGLES] = Mesh::<16, 16>::indices();
//!
//! let cloth = Cloth::<Q24, 16, 16>::lay(&UNITS, UNITS.point([0.0, 0.0, 0.5]));
//! let mut mesh = Mesh::BLANK;
//! mesh.update(&cloth, &UNITS); // after each frame
//! let (vertices, normals): (&[f32], &[f32]) = (mesh.positions.as_flat(), mesh.normals.as_flat());
//! assert_eq!((vertices.len(), normals.len()), (3 * 16 * 16, 3 * 16 * 16));
//! assert_eq!(normals[..3], [0.0, 0.0, 1.0]);
//! assert_eq!((INDICES.len(), INDICES[0]), (2 * 15 * 15, [0, 1, 16]));
//! ```
//!
//! Axes are the scene's: x to the right, y away from the viewer, z up, which is right-handed. For an engine whose y axis points up, such as three.js or glTF,
//! pass (x, z, −y).
//!
//! Seen from the front of the sheet, the corners of triangles are in counter-clockwise order. The front of a [laid](crate::Cloth::lay) sheet faces up, that of
//! a [hung](crate::Cloth::hang) sheet faces along y. It is the side whose pattern `render::Look` calls `front`.

use crate::grid::{Grid, Node};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::Units;
use crate::vec3::Vec3;

/// The vertices of a sheet of `W × H` particles in one frame.
///
/// Memory: 24 bytes per particle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mesh<const W: usize, const H: usize> {
    /// The positions of the particles, m.
    pub positions: Grid<[f32; 3], W, H>,
    /// Unit normals of the front; zero if all triangles around a particle have no area.
    pub normals: Grid<[f32; 3], W, H>,
}

impl<const W: usize, const H: usize> Mesh<W, H> {
    /// All zeros.
    pub const BLANK: Self = Self { positions: Grid::filled([0.0; 3]), normals: Grid::filled([0.0; 3]) };

    /// The number of triangles: two for each cell, none for a chain.
    pub const TRIANGLES: usize = 2 * (W - 1) * (H - 1);

    /// Copies the vertices from a sheet.
    pub fn update<S: Scalar>(&mut self, particles: &Particles<S, W, H>, units: &Units) {
        self.positions.values_mut().zip(positions(particles, units)).for_each(|(kept, new)| *kept = new);
        self.normals.values_mut().zip(normals(particles)).for_each(|(kept, new)| *kept = new);
    }

    /// The corners of the triangles as indices of vertices, cell by cell.
    ///
    /// A sheet of more than 65 536 particles does not compile.
    pub fn triangles() -> impl Iterator<Item = [u16; 3]> {
        (0..Self::TRIANGLES).map(Self::triangle)
    }

    /// [`triangles`](Self::triangles) as an array, also in a constant. It compiles only if `N` is the number of triangles.
    pub const fn indices<const N: usize>() -> [[u16; 3]; N] {
        const { assert!(N == Self::TRIANGLES, "a mesh has 2·(W − 1)·(H − 1) triangles") };
        let mut indices = [[0; 3]; N];
        let mut index = 0;
        while index < N {
            indices[index] = Self::triangle(index);
            index += 1;
        }
        indices
    }

    /// The texture coordinates of the vertices: (0, 0) is particle (0, 0), (1, 1) the last particle of the last row.
    ///
    /// A picture whose first row is its top row, as in wgpu and glTF, stands upright on a hung sheet.
    pub fn texture() -> impl Iterator<Item = [f32; 2]> {
        texture(W, H)
    }

    const fn triangle(index: usize) -> [u16; 3] {
        const { assert!(W * H <= 1 << 16, "16 bits number at most 65536 vertices") };
        let [a, b, c] = triangle(W, index);
        [a as u16, b as u16, c as u16]
    }
}

/// The positions of all particles, m, row by row.
pub fn positions<S: Scalar, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    units: &Units,
) -> impl Iterator<Item = [f32; 3]> {
    particles.position.values().map(|place| single(units.metres(place)))
}

/// The unit normals of all particles on the front, row by row: see [`normal`].
pub fn normals<S: Scalar, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
) -> impl Iterator<Item = [f32; 3]> {
    Grid::<S, W, H>::nodes().map(|node| {
        let here = particles.position.at(node);
        let edge = |other| particles.position.at(other).difference(here).to_f64();
        single(normal([W, H], node, edge))
    })
}

/// The corners of the triangles of a sheet whose size is known at run time, as indices of particles, row by row. Each cell has the triangles (p, q, s) and (q,
/// t, s), where q is to the right of p, s below it and t below q. The [wind](crate::FacetWind) acts on the same triangles.
pub fn triangles(columns: usize, rows: usize) -> impl Iterator<Item = [usize; 3]> {
    let count = 2 * columns.saturating_sub(1) * rows.saturating_sub(1);
    (0..count).map(move |index| triangle(columns, index))
}

/// The texture coordinates of a sheet whose size is known at run time: see [`Mesh::texture`].
pub fn texture(columns: usize, rows: usize) -> impl Iterator<Item = [f32; 2]> {
    let part = |index: usize, count: usize| if count > 1 { index as f32 / (count - 1) as f32 } else { 0.0 };
    (0..rows).flat_map(move |row| (0..columns).map(move |column| [part(column, columns), part(row, rows)]))
}

/// The unit normal of a particle on the front of a sheet of `[columns, rows]` particles; `edge` gives the vector from it to any neighbour.
///
/// It is the mean of the normals of the triangles around the particle, weighted by their areas. Zero if there is no triangle, if none has an area, or if a
/// number is not finite.
pub fn normal([columns, rows]: [usize; 2], node: Node, edge: impl Fn(Node) -> [f64; 3]) -> [f64; 3] {
    let Node { column, row } = node;
    let (left, right) = (column > 0, column + 1 < columns);
    let (above, below) = (row > 0, row + 1 < rows);
    // the neighbours around the particle, counter-clockwise: two consecutive ones form a triangle with it
    let ring = [
        right.then(|| Node::new(column + 1, row)),
        below.then(|| Node::new(column, row + 1)),
        (below && left).then(|| Node::new(column - 1, row + 1)),
        left.then(|| Node::new(column - 1, row)),
        above.then(|| Node::new(column, row - 1)),
        (above && right).then(|| Node::new(column + 1, row - 1)),
    ]
    .map(|neighbour| neighbour.map(&edge));
    let mut sum = Vec3::<f64>::ZERO;
    for (k, first) in ring.iter().enumerate() {
        if let (Some([a, b, c]), Some([x, y, z])) = (*first, ring[(k + 1) % ring.len()]) {
            sum += Vec3::new(a, b, c).cross(Vec3::new(x, y, z));
        }
    }
    let length = sum.length();
    if length > 0.0 && length.is_finite() { [sum.x / length, sum.y / length, sum.z / length] } else { [0.0; 3] }
}

const fn triangle(columns: usize, index: usize) -> [usize; 3] {
    let (cell, cells) = (index / 2, columns - 1);
    let p = cell / cells * columns + cell % cells;
    let (q, s) = (p + 1, p + columns);
    if index % 2 == 0 { [p, q, s] } else { [q, s + 1, s] }
}

fn single(vector: [f64; 3]) -> [f32; 3] {
    vector.map(|component| component as f32)
}

#[cfg(test)]
mod tests {
    extern crate std;
    use std::vec::Vec;

    use super::*;
    use crate::cloth::Cloth;
    use crate::scalar::{Q13, Q24};

    const UNITS: Units = Units::sheet([5, 4], [0.8, 0.9], 1e-3, 0.01, 4);

    /// A sheet bent along a cylinder of radius 2 m around an axis along y.
    fn bent<S: Scalar>() -> Cloth<S, 5, 4> {
        let mut cloth = Cloth::lay(&UNITS, UNITS.point([0.0; 3]));
        for node in Grid::<S, 5, 4>::nodes() {
            let angle = 0.1 * (node.column as f64 - 2.0);
            let place = [2.0 * libm::sin(angle), 0.3 * node.row as f64, 2.0 * libm::cos(angle)];
            cloth.position.set(node, UNITS.point(place).to_vec());
        }
        cloth
    }

    fn positions_are_in_metres<S: Scalar>(bound: f32) {
        let cloth = bent::<S>();
        let mut mesh = Mesh::BLANK;
        mesh.update(&cloth, &UNITS);
        let found: Vec<_> = positions(&cloth, &UNITS).collect();
        assert_eq!(found.as_flattened(), mesh.positions.as_flat());
        for (k, node) in Grid::<S, 5, 4>::nodes().enumerate() {
            let angle = 0.1 * (node.column as f64 - 2.0);
            let expected = [2.0 * libm::sin(angle), 0.3 * node.row as f64, 2.0 * libm::cos(angle)];
            for (found, expected) in found[k].into_iter().zip(expected) {
                assert!((found - expected as f32).abs() < bound, "{node:?} in {}: {found}, {expected}", S::NAME);
            }
        }
    }

    #[test]
    fn positions_are_in_metres_in_every_number_type() {
        positions_are_in_metres::<f32>(1e-6);
        positions_are_in_metres::<f64>(3e-7);
        positions_are_in_metres::<Q24>(3e-7);
        positions_are_in_metres::<Q13>(3e-7);
    }

    /// On a cylinder the normals of inner particles are radial, by symmetry of the triangles around them.
    #[test]
    fn normals_are_those_of_the_front() {
        let cloth = bent::<f64>();
        let found: Vec<_> = normals(&cloth).collect();
        for (node, normal) in Grid::<f64, 5, 4>::nodes().zip(&found) {
            let angle = 0.1 * (node.column as f64 - 2.0);
            let length = normal.iter().map(|x| x * x).sum::<f32>().sqrt();
            assert!((length - 1.0).abs() < 1e-6, "{node:?}: {normal:?}");
            let cosine = f64::from(normal[0]) * libm::sin(angle) + f64::from(normal[2]) * libm::cos(angle);
            assert!(cosine > 0.998, "{node:?}: {normal:?}");
        }
        let middle = found[5 + 2];
        assert!(middle[0].abs() < 1e-6 && middle[1].abs() < 1e-6, "{middle:?}");
    }

    #[test]
    fn fronts_of_laid_and_hung_sheets() {
        let laid = Cloth::<Q24, 5, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
        assert!(normals(&laid).all(|normal| normal == [0.0, 0.0, 1.0]));
        let hung = Cloth::<f32, 5, 4>::hang(&UNITS, UNITS.point([0.0; 3]));
        assert!(normals(&hung).all(|normal| normal == [0.0, 1.0, 0.0]));
    }

    /// A flap of twice the area counts twice.
    #[test]
    fn normals_are_weighted_by_area() {
        let edges = [[2.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, -1.0]];
        // the edges of the middle one of 3 × 2 particles: right, below and left
        let edge = |node: Node| match (node.column, node.row) {
            (2, 0) => edges[0],
            (1, 1) => edges[1],
            (0, 1) => [0.0; 3],
            _ => edges[2],
        };
        assert_eq!(normal([3, 2], Node::new(1, 0), edge), [0.0, 0.0, 1.0]);
        let folded = |node: Node| if node == Node::new(0, 1) { [0.0, 1.0, -1.0] } else { edge(node) };
        // 2·ẑ, and (0, 1, 0) × (0, 1, −1) + (0, 1, −1) × (0, 0, −1) = (−2, 0, 0)
        let [x, y, z] = normal([3, 2], Node::new(1, 0), folded);
        assert!((x + z).abs() < 1e-15 && y == 0.0 && z > 0.7, "{x} {y} {z}");
    }

    #[test]
    fn triangles_turn_as_normals_say_and_cover_every_cell_twice() {
        let cloth = bent::<f64>();
        let places: Vec<_> = cloth.position.values().collect();
        let normals: Vec<_> = normals(&cloth).collect();
        let mut area = 0.0;
        for corners in Mesh::<5, 4>::triangles() {
            let [a, b, c] = corners.map(|corner| places[usize::from(corner)]);
            let normal = (b - a).cross(c - a);
            for corner in corners {
                let [x, y, z] = normals[usize::from(corner)].map(f64::from);
                assert!(normal.dot(Vec3::new(x, y, z)) > 0.0, "{corners:?}");
            }
            area += 0.5 * normal.length() * UNITS.cell * UNITS.cell;
        }
        let chord = 4.0 * libm::sin(0.05);
        assert!((area - 4.0 * chord * 0.9).abs() < 1e-12, "{area}");
    }

    #[test]
    fn triangles_and_textures_at_run_time_are_the_same() {
        const INDICES: [[u16; 3]; 24] = Mesh::<5, 4>::indices();
        assert!(Mesh::<5, 4>::triangles().eq(INDICES));
        let found: Vec<_> = triangles(5, 4).map(|corners| corners.map(|corner| corner as u16)).collect();
        assert_eq!(found, INDICES);
        assert_eq!(triangles(1, 32).count() + triangles(32, 1).count() + triangles(0, 0).count(), 0);
        assert_eq!(Mesh::<1, 32>::TRIANGLES, 0);
        let texture: Vec<_> = Mesh::<5, 4>::texture().collect();
        assert_eq!((texture[0], texture[4], texture[19]), ([0.0, 0.0], [1.0, 0.0], [1.0, 1.0]));
        assert_eq!(texture[5 + 1], [0.25, 1.0 / 3.0]);
        assert!(Mesh::<1, 3>::texture().eq([[0.0, 0.0], [0.0, 0.5], [0.0, 1.0]]));
    }

    #[test]
    fn what_has_no_area_has_no_normal() {
        let mut cloth = Cloth::<f32, 5, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
        cloth.position.set(Node::new(0, 0), Vec3::new(f32::NAN, 0.0, 0.0));
        let found: Vec<_> = normals(&cloth).collect();
        assert_eq!((found[0], found[19]), ([0.0; 3], [0.0, 0.0, 1.0]));
        cloth.position.change(|_| Vec3::ZERO);
        assert!(normals(&cloth).all(|normal| normal == [0.0; 3]));
        let chain = Units::sheet([1, 4], [0.0, 0.3], 1e-3, 0.01, 4);
        let chain = Cloth::<Q24, 1, 4>::hang(&chain, chain.point([0.0; 3]));
        assert!(normals(&chain).all(|normal| normal == [0.0; 3]));
    }
}
