//! Values on the nodes of a grid.

use core::ops::{Index, IndexMut};

/// The address of a node in a grid.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Node {
    /// Counted from the left.
    pub column: usize,
    /// Counted from the top (hung) or the front (laid).
    pub row: usize,
}

impl Node {
    /// The node in `column` and `row`.
    pub const fn new(column: usize, row: usize) -> Self {
        Self { column, row }
    }
}

/// `W × H` values, row by row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grid<T, const W: usize, const H: usize>(pub [[T; W]; H]);

impl<T: Copy, const W: usize, const H: usize> Grid<T, W, H> {
    /// The same value everywhere.
    ///
    /// A grid without nodes, or with more than 32768 columns or rows, does not compile.
    pub const fn filled(value: T) -> Self {
        const { Self::check() };
        Self([[value; W]; H])
    }

    /// Rejects impossible sizes when evaluated at compile time.
    pub(crate) const fn check() {
        assert!(W > 0 && H > 0, "a grid needs at least one column and one row");
        assert!(W <= 1 << 15 && H <= 1 << 15, "a grid has at most 32768 columns and rows");
    }

    /// All nodes, row by row.
    pub fn nodes() -> impl Iterator<Item = Node> {
        (0..H).flat_map(|row| (0..W).map(move |column| Node { column, row }))
    }

    /// All values, row by row.
    pub fn values(&self) -> impl Iterator<Item = &T> {
        self.0.iter().flatten()
    }

    /// All values, row by row.
    pub fn values_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.0.iter_mut().flatten()
    }

    /// All values as a slice, row by row.
    pub const fn as_slice(&self) -> &[T] {
        self.0.as_flattened()
    }
}

impl<T, const N: usize, const W: usize, const H: usize> Grid<[T; N], W, H> {
    /// All components of all values as a slice, row by row: the layout of a vertex buffer.
    pub const fn as_flat(&self) -> &[T] {
        self.0.as_flattened().as_flattened()
    }
}

impl<T, const W: usize, const H: usize> Index<Node> for Grid<T, W, H> {
    type Output = T;
    #[inline]
    fn index(&self, node: Node) -> &T {
        &self.0[node.row][node.column]
    }
}

impl<T, const W: usize, const H: usize> IndexMut<Node> for Grid<T, W, H> {
    #[inline]
    fn index_mut(&mut self, node: Node) -> &mut T {
        &mut self.0[node.row][node.column]
    }
}

/// Calls `visit` with every node. Unlike an iterator it is always inlined, so that the compiler removes bounds checks.
#[inline(always)]
pub(crate) fn each_node<const W: usize, const H: usize>(mut visit: impl FnMut(Node)) {
    for row in 0..H {
        for column in 0..W {
            visit(Node { column, row });
        }
    }
}
