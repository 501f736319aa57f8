//! A product in full width.

use core::cmp::Ordering;
use core::ops::Add;

/// A product of two [`Q24`](super::Q24), or a sum of up to three, with 48 fraction bits.
///
/// The squares of a vector add up to 1.5·2⁶³: this exceeds an `i64`, but not a `u64`. So sums wrap, and sums of squares are compared and read as unsigned
/// numbers. Distances across the whole range of positions are then correct at no cost.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wide(i64);

impl Wide {
    #[inline]
    pub(super) const fn new(product: i64) -> Self {
        Self(product)
    }

    /// A sum of products of either sign.
    #[inline]
    pub(super) const fn signed(self) -> i64 {
        self.0
    }

    /// A sum of squares.
    #[inline]
    pub(super) const fn squares(self) -> u64 {
        self.0 as u64
    }
}

impl Add for Wide {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self(self.0.wrapping_add(other.0))
    }
}

impl PartialOrd for Wide {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Wide {
    #[inline]
    fn cmp(&self, other: &Self) -> Ordering {
        self.squares().cmp(&other.squares())
    }
}
