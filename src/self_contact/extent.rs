//! Boxes of whole numbers, the same for all number types.

/// Edges are kept in coarse numbers divided by 4, which are 64ths of a cell.
const EDGE_SHIFT: u32 = 2;

/// An axis-aligned box, in [coarse](crate::Scalar::coarse) numbers or, once packed, in coarser ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Extent {
    pub(super) low: [i32; 3],
    pub(super) high: [i32; 3],
}

impl Extent {
    /// The empty box.
    pub(super) const EMPTY: Self = Self { low: [i32::MAX; 3], high: [i32::MIN; 3] };

    /// The smallest box around both.
    pub(super) fn and(self, other: Self) -> Self {
        Self {
            low: core::array::from_fn(|axis| self.low[axis].min(other.low[axis])),
            high: core::array::from_fn(|axis| self.high[axis].max(other.high[axis])),
        }
    }

    /// Whether the distance between the boxes is less than `reach`.
    #[inline]
    pub(super) fn is_near(&self, other: &Self, reach: i32) -> bool {
        let mut squares = 0;
        for axis in 0..3 {
            let gap =
                self.low[axis].saturating_sub(other.high[axis]).max(other.low[axis].saturating_sub(self.high[axis]));
            if gap >= reach {
                return false;
            }
            if gap > 0 {
                squares += gap * gap;
            }
        }
        squares < reach * reach
    }
}

/// Bounds of a tile's particles and edges while they move on at their velocities.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Bounds {
    /// The box of its particles.
    pub(super) places: Extent,
    /// The boxes of its edges, as vectors: along rows, and down columns.
    pub(super) edges: [Extent; 2],
}

impl Bounds {
    pub(super) const EMPTY: Self = Self { places: Extent::EMPTY, edges: [Extent::EMPTY; 2] };

    pub(super) fn and(self, other: &Self) -> Self {
        Self {
            places: self.places.and(other.places),
            edges: [self.edges[0].and(other.edges[0]), self.edges[1].and(other.edges[1])],
        }
    }

    /// Packs the spans of a tile along an axis into 12 numbers of 16 bits: places relative to an origin, in coarse numbers divided by 2^`shift`, edges in 1/64 cell. Numbers
    /// beyond the range become the largest, which brings boxes closer together and makes edges unknown.
    pub(super) fn pack(packed: &mut [i16; 12], axis: usize, spans: [[i32; 2]; 3], origin: [i32; 3], shift: u32) {
        // so that the compiler leaves out bounds checks
        let axis = axis.min(2);
        let origin = origin[axis];
        let [places, edges @ ..] = spans;
        let place = |x: i32, up: i32| {
            let x = (x.saturating_sub(origin) >> shift).saturating_add(up);
            x.clamp(i16::MIN.into(), i16::MAX.into()) as i16
        };
        packed[axis] = place(places[0], 0);
        packed[3 + axis] = place(places[1], 1);
        let edge = |x: i32, up: i32| ((x >> EDGE_SHIFT) + up).clamp(i8::MIN.into(), i8::MAX.into()) as i8 as u8;
        for (family, [low, high]) in edges.into_iter().enumerate() {
            packed[6 + 3 * family + axis] = i16::from_le_bytes([edge(low, 0), edge(high, 1)]);
        }
    }

    pub(super) fn unpacked(packed: &[i16; 12]) -> Self {
        let edges = |family: usize, byte: usize| {
            core::array::from_fn(|axis| i32::from(packed[6 + 3 * family + axis].to_le_bytes()[byte] as i8))
        };
        Self {
            places: Extent {
                low: core::array::from_fn(|axis| packed[axis].into()),
                high: core::array::from_fn(|axis| packed[3 + axis].into()),
            },
            edges: [0, 1].map(|family| Extent { low: edges(family, 0), high: edges(family, 1) }),
        }
    }
}

/// A test whether a patch is so flat that none of its particles meet except neighbours.
///
/// Let u be a direction along which every edge of a row has a component of at least A > 0, and every edge of a column one of at most B in magnitude. Particles p columns and q
/// rows apart, with p·a ≥ q·b for cells of a × b, are then at least p·A − q·B ≥ p·a·(A/a − B/b) apart along u. Unless they are neighbours, p·a ≥ m, the smaller extent of the
/// neighbourhood along rows and columns. If p·a < q·b, exchange the roles of rows and columns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Flatness {
    /// m/a and m/b in 16ths, rounded down and up.
    least: [i32; 2],
    most: [i32; 2],
}

impl Flatness {
    /// The test for cells with these `sides`; particles that are so many columns or rows apart are not `neighbours`.
    pub(super) const fn new(sides: [f64; 2], neighbours: [usize; 2]) -> Self {
        let [across, down] = [neighbours[0] as f64 * sides[0], neighbours[1] as f64 * sides[1]];
        let shortest = if across < down { across } else { down };
        // a chain has no cells, and is never flat
        let [a, b] = [sides[0], sides[1]];
        if !(a > 0.0 && b > 0.0) {
            return Self { least: [0; 2], most: [0; 2] };
        }
        let parts = [16.0 * shortest / a, 16.0 * shortest / b];
        Self { least: [parts[0] as i32, parts[1] as i32], most: [parts[0] as i32 + 1, parts[1] as i32 + 1] }
    }

    /// Whether all particles of a patch with such edges, except neighbours, are apart by `reach` (coarse) or more.
    pub(super) fn is_flat(&self, reach: i32, edges: &[Extent; 2]) -> bool {
        let known = |edges: &Extent| {
            let inside = |x: &i32| -127 < *x && *x < 127;
            edges.low.iter().all(inside) && edges.high.iter().all(inside)
        };
        edges.iter().all(known) && self.is_wide(reach, edges, 0) && self.is_wide(reach, edges, 1)
    }

    /// The same for particles that are further apart along this family of edges than along the other.
    fn is_wide(&self, reach: i32, edges: &[Extent; 2], family: usize) -> bool {
        let (along, other) = (&edges[family], &edges[1 - family]);
        // twice the centre of the box
        let u: [i32; 3] = core::array::from_fn(|axis| along.low[axis] + along.high[axis]);
        let (mut least, mut most, mut square) = (0, [0; 2], 0);
        for axis in 0..3 {
            let ends = |edges: &Extent| [edges.low[axis] * u[axis], edges.high[axis] * u[axis]];
            let [a, b] = ends(along);
            least += a.min(b);
            let [a, b] = ends(other);
            most = [most[0] + a.min(b), most[1] + a.max(b)];
            square += u[axis] * u[axis];
        }
        let across = most[1].max(-most[0]);
        let apart = self.least[family] * least - self.most[1 - family] * across;
        // in 1/16 of the unit of edges
        let reach = (16 * (reach + 1)) >> EDGE_SHIFT;
        // all in 32 bits: small processors compose wider products of several
        4 * apart >= reach * root_above(16 * square)
    }
}

/// The least whole number whose square is above `square` (≤ 2²⁴), bit by bit.
const fn root_above(square: i32) -> i32 {
    let (mut root, mut bit) = (0, 1 << 12);
    while bit > 0 {
        let more = root + bit;
        if more * more <= square {
            root = more;
        }
        bit >>= 1;
    }
    root + 1
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bounds that are the same along every axis, packed and unpacked.
    fn kept(spans: [[i32; 2]; 3], origin: i32, shift: u32) -> Bounds {
        let mut packed = [0; 12];
        (0..3).for_each(|axis| Bounds::pack(&mut packed, axis, spans, [origin; 3], shift));
        Bounds::unpacked(&packed)
    }

    #[test]
    fn bounds_are_kept_outwards() {
        let extent = |low, high| Extent { low: [low; 3], high: [high; 3] };
        let bounds = kept([[-300, 299], [-256, 253], [12, 480]], 0, 0);
        assert_eq!(bounds, Bounds { places: extent(-300, 300), edges: [extent(-64, 64), extent(3, 121)] });
        assert_eq!(kept([[-303, 32_000], [0; 2], [0; 2]], -300, 1).places, extent(-2, 16_151));
        let bounds = kept([[-70_000, 70_000], [-2000, 2000], [-2000, 2000]], 0, 0);
        assert_eq!(bounds.places, extent(-32_768, 32_767));
        assert!(!Flatness::new([1.0; 2], [2; 2]).is_flat(384, &bounds.edges));
    }

    #[test]
    fn roots_are_rounded_up() {
        for (square, root) in [(0, 1), (1, 2), (3, 2), (4, 3), (3_096_767, 1760), (3_096_768, 1760), (1 << 24, 4097)] {
            assert_eq!(root_above(square), root, "{square}");
        }
    }

    #[test]
    fn boxes_are_near_up_to_their_reach() {
        let a = Extent { low: [0; 3], high: [10; 3] };
        let b = Extent { low: [13, 14, 10], high: [20; 3] };
        assert!(a.is_near(&b, 6) && b.is_near(&a, 6));
        assert!(!a.is_near(&b, 5) && !b.is_near(&a, 5));
    }

    /// Edges of a sheet at rest, each with a deviation of up to `by` along every axis.
    fn about(edges: [[i32; 3]; 2], by: i32) -> [Extent; 2] {
        edges.map(|edge| Extent { low: edge.map(|x| x - by), high: edge.map(|x| x + by) })
    }

    #[test]
    fn what_is_flat_is_known() {
        let square = Flatness::new([1.0; 2], [2; 2]);
        assert!(square.is_flat(384, &about([[64, 0, 0], [0, 0, -64]], 2)));
        assert!(square.is_flat(384, &about([[45, 45, 0], [-45, 45, 0]], 1)));
        assert!(!square.is_flat(384, &about([[64, 0, 0], [0, 0, -64]], 20)));
        // sheared by so much that neighbours' neighbours meet
        assert!(!square.is_flat(384, &about([[64, 0, 0], [50, 0, 30]], 1)));
        let oblong = Flatness::new([1.0, 0.6], [2, 3]);
        assert!(oblong.is_flat(384, &about([[64, 0, 0], [0, 38, 0]], 1)));
        assert!(!oblong.is_flat(384, &about([[64, 0, 0], [0, 20, 0]], 1)));
    }
}
