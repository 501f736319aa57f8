//! The difference between the two fixed-point types.

use core::fmt::Debug;
use core::hash::Hash;

use super::Fixed24;
use crate::scalar::{Rest, Rounding};

/// The computation of products, quotients and links, on the bits of numbers with 24 fraction bits.
///
/// [`Exact`](super::Exact) and [`Short`](super::Short) implement it.
pub trait Kernel: Copy + Debug + Default + Ord + Hash + Send + 'static {
    /// The type's name.
    const NAME: &'static str;
    /// The last place of a link's components, cells.
    const EDGE: f64;
    /// The distance by which rounding moves a sheet practically at rest, cells.
    const STRAY: f64;

    /// Data for measuring links of a rest length, besides its inverse.
    type Prepared: Copy + Debug + PartialEq + Send + Sync + 'static;

    /// Computes it from 1/L and 1/L².
    fn prepared(inverse: i32, inverse_square: i32) -> Self::Prepared;

    /// A product, rounded to nearest.
    fn multiply(a: i32, b: i32) -> i32;

    /// A product with `|ratio| ≤ 1`.
    fn scaled(a: i32, ratio: i32, rounding: Rounding) -> i32;

    /// `1/x` for x > 0.
    fn reciprocal(x: i32) -> i32;

    /// `part·(1 − L/|d|)·d` for `|part| ≤ 1`.
    fn correction(d: [i32; 3], rest: &Rest<Fixed24<Self>>, part: i32, rounding: Rounding) -> [i32; 3];

    /// `|d| − L` and `d/|d|`.
    fn direction(d: [i32; 3], rest: &Rest<Fixed24<Self>>) -> (i32, [i32; 3]);

    /// The scalar product of two vectors no longer than 1.01.
    fn cosine(a: [i32; 3], b: [i32; 3]) -> i32;
}
