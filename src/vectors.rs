//! Vectors on the nodes of a grid.

use crate::grid::{Grid, Node};
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// `W × H` vectors, row by row. The thesis measures two layouts of a sheet's data (thesis, section 6.1); this is the library's.
///
/// The x components of a row are contiguous, and so are its y and its z components: processors that compute four numbers at once load them without rearranging.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vectors<S, const W: usize, const H: usize>(pub [Vec3<[S; W]>; H]);

impl<S: Scalar, const W: usize, const H: usize> Vectors<S, W, H> {
    /// The same vector everywhere.
    ///
    /// A grid without nodes, or with more than 32768 columns or rows, does not compile.
    pub const fn filled(vector: Vec3<S>) -> Self {
        const { Grid::<S, W, H>::check() };
        Self([Vec3::row(vector); H])
    }

    /// The vector at a node.
    #[inline(always)]
    pub fn at(&self, node: Node) -> Vec3<S> {
        self.0[node.row].at(node.column)
    }

    /// Replaces the vector at a node.
    #[inline(always)]
    pub fn set(&mut self, node: Node, vector: Vec3<S>) {
        self.0[node.row].set(node.column, vector);
    }

    /// Adds to the vector at a node.
    #[inline(always)]
    pub fn add(&mut self, node: Node, vector: Vec3<S>) {
        self.0[node.row].add(node.column, vector);
    }

    /// All vectors, row by row.
    pub fn values(&self) -> impl Iterator<Item = Vec3<S>> {
        self.0.iter().flat_map(|row| (0..W).map(|column| row.at(column)))
    }

    /// The largest magnitude of a component.
    pub fn largest(&self) -> S {
        self.values().fold(S::ZERO, |most, Vec3 { x, y, z }| most.max(x.abs()).max(y.abs()).max(z.abs()))
    }

    /// Replaces every vector, row by row, by the result of `change`.
    pub fn change(&mut self, mut change: impl FnMut(Vec3<S>) -> Vec3<S>) {
        for row in &mut self.0 {
            for column in 0..W {
                row.set(column, change(row.at(column)));
            }
        }
    }
}

/// A row of vectors.
impl<S: Scalar, const W: usize> Vec3<[S; W]> {
    /// The same vector everywhere.
    #[inline]
    pub const fn row(vector: Vec3<S>) -> Self {
        Self { x: [vector.x; W], y: [vector.y; W], z: [vector.z; W] }
    }

    /// The vector in a column.
    #[inline(always)]
    pub fn at(&self, column: usize) -> Vec3<S> {
        Vec3::new(self.x[column], self.y[column], self.z[column])
    }

    /// Replaces the vector in a column.
    #[inline(always)]
    pub fn set(&mut self, column: usize, vector: Vec3<S>) {
        self.x[column] = vector.x;
        self.y[column] = vector.y;
        self.z[column] = vector.z;
    }

    /// Adds to the vector in a column.
    #[inline(always)]
    pub fn add(&mut self, column: usize, vector: Vec3<S>) {
        self.set(column, self.at(column) + vector);
    }

    /// The row with `change` applied to its x, its y and its z.
    #[inline(always)]
    #[must_use]
    pub fn components(&self, change: impl Fn(&[S; W]) -> [S; W]) -> Self {
        Self { x: change(&self.x), y: change(&self.y), z: change(&self.z) }
    }
}

/// Whether the processor computes several numbers at once: then whole rows are computed, including columns at the ends that lack a neighbour.
pub(crate) const SIDE_BY_SIDE: bool = cfg!(any(target_feature = "sse2", target_feature = "neon"));

/// All columns of a row. If numbers are computed one by one, only the columns that have a neighbour `AHEAD` to the right and one `BEHIND` to the left.
pub(crate) const fn columns<const AHEAD: usize, const BEHIND: usize, const W: usize>() -> core::ops::Range<usize> {
    if SIDE_BY_SIDE { 0..W } else { BEHIND..W.saturating_sub(AHEAD) }
}

/// The vector `BY < W` columns to the right; beyond the last column zero, or the first vectors again.
#[inline(always)]
pub(crate) fn ahead<const BY: usize, S: Scalar, const W: usize>(row: &Vec3<[S; W]>) -> impl Fn(usize) -> Vec3<S> {
    let shifted = row.components(left::<BY, S, W>);
    move |column| {
        if SIDE_BY_SIDE {
            shifted.at(column)
        } else if column + BY < W {
            row.at(column + BY)
        } else {
            Vec3::ZERO
        }
    }
}

/// The vector `BY < W` columns to the left; before the first column zero, or the last vectors again.
#[inline(always)]
pub(crate) fn behind<const BY: usize, S: Scalar, const W: usize>(row: &Vec3<[S; W]>) -> impl Fn(usize) -> Vec3<S> {
    let shifted = row.components(right::<BY, S, W>);
    move |column| {
        if SIDE_BY_SIDE {
            shifted.at(column)
        } else if column >= BY {
            row.at(column - BY)
        } else {
            Vec3::ZERO
        }
    }
}

/// The row rotated to the left by `BY < W` columns: the first columns come last.
#[inline(always)]
pub(crate) fn left<const BY: usize, S: Scalar, const W: usize>(row: &[S; W]) -> [S; W] {
    let mut shifted = *row;
    shifted[..W - BY].copy_from_slice(&row[BY..]);
    shifted[W - BY..].copy_from_slice(&row[..BY]);
    shifted
}

/// The row rotated to the right by `BY < W` columns: the last columns come first.
#[inline(always)]
pub(crate) fn right<const BY: usize, S: Scalar, const W: usize>(row: &[S; W]) -> [S; W] {
    let mut shifted = *row;
    shifted[BY..].copy_from_slice(&row[..W - BY]);
    shifted[..BY].copy_from_slice(&row[W - BY..]);
    shifted
}
