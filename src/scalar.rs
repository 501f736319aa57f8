//! Numbers: `f32`, `f64` and fixed point behind one trait.
//!
//! This is the only module that depends on the bits of a number. All modules above it compute with [`Scalar`], in the sheet's own units (see
//! [`Units`](crate::Units)), so that lengths are near one and fixed point keeps its precision.
//!
//! Floats use only `+ − × ÷` and the square root, each rounded once; fixed point uses only integer arithmetic; and the order of operations is fixed. So every
//! number type gives the same bits on every target.

pub(crate) mod fit;
mod fixed24;
mod float;
pub(crate) mod panel;
mod root;
mod rounding;
mod wide;

use core::fmt::Debug;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

pub use fixed24::{Fixed24, Q13, Q24};
pub use rounding::Rounding;

/// A number type for the computation of a sheet.
///
/// Implemented for `f32`, `f64`, [`Q24`] and [`Q13`].
pub trait Scalar:
    Copy
    + Debug
    + Default
    + PartialEq
    + PartialOrd
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Neg<Output = Self>
    + AddAssign
    + SubAssign
    + Send
    + 'static
{
    /// The name by which programs choose the type.
    const NAME: &'static str;
    /// Zero.
    const ZERO: Self;
    /// One.
    const ONE: Self;
    /// One half.
    const HALF: Self;
    /// The largest magnitude that the type represents.
    const LARGEST: f64;
    /// The spacing of numbers just above one.
    const RESOLUTION: f64;
    /// The steps of a link's measured length some cells from the origin, cells. A sheet at rest vibrates by a few of them.
    const EDGE: f64;
    /// The distance by which rounding moves a sheet practically at rest, cells. In fixed point drag does not slow the last 1/(2·γ·h) places of a velocity.
    const STRAY: f64;

    /// Whether sums and differences are exact and wrap beyond the range, as in fixed point. Then no order of additions loses digits, and a value of a few last
    /// places is only round-off.
    const EXACT_SUMS: bool = false;
    /// Whether testing a factor for 0 or 1 costs less than a product.
    const LOOKING_PAYS: bool = false;
    /// The smallest softness 1/κ beside which the inertia of a particle is resolved.
    const LEAST_SOFTNESS: f64 = 1e-6;
    /// The [divisor](Self::divisor) with which every quotient is zero.
    const INFINITE_DIVISOR: Self;

    /// A product of two numbers, wide enough for three of them to be added without overflow; exact in fixed point.
    type Product: Copy + Debug + PartialOrd + Add<Output = Self::Product>;
    /// A sum of many products, as the dot product of two whole sheets.
    type Sum: Copy + Debug + PartialOrd;
    /// Data for a rest length, [prepared](Self::prepared) besides its inverse.
    type Prepared: Copy + Debug + PartialEq + Send + Sync + 'static;
    /// The constants of a sheet's panels.
    type Panel: Copy + Debug + PartialEq + Send + Sync + 'static;

    /// The nearest number to `value`; beyond [`LARGEST`](Self::LARGEST) fixed point saturates.
    ///
    /// In fixed point by integer arithmetic alone: firmware links no float routine.
    fn from_f64(value: f64) -> Self;

    /// The data for measuring links of a rest length L, from 1/L and 1/L².
    fn prepared(inverse: Self, inverse_square: Self) -> Self::Prepared;

    /// A whole number; `|value| ≤ LARGEST`.
    fn from_int(value: i32) -> Self;

    /// The value as `f64`, exact for all types.
    fn to_f64(self) -> f64;

    /// `self · factor`, for small whole factors.
    #[must_use]
    fn times(self, factor: i32) -> Self;

    /// `self · 2^shift`.
    #[must_use]
    fn double(self, shift: u32) -> Self;

    /// `self / 2^shift`, rounded to nearest.
    #[must_use]
    fn halve(self, shift: u32) -> Self;

    /// `self / 2^shift`, rounded to nearest with ties away from zero. Many ties rounded up would push a sheet to one side.
    #[inline]
    #[must_use]
    fn halve_evenly(self, shift: u32) -> Self {
        if self < Self::ZERO { -(-self).halve(shift) } else { self.halve(shift) }
    }

    /// `self · halves/2 · 2^shift`.
    #[must_use]
    fn rate(self, halves: u32, shift: u32) -> Self;

    /// `self − other`, also for positions further apart than the range of fixed point: then the largest number of that sign.
    #[inline]
    #[must_use]
    fn difference(self, other: Self) -> Self {
        self - other
    }

    /// Whether `self + other` lies beyond the range and wraps. Floats are infinite there.
    #[inline]
    fn wraps(self, _other: Self) -> bool {
        false
    }

    /// Whether the number is at most `bound`, which keeps subsequent results in the range of fixed point. Always true for floats, which need no bound.
    #[inline(always)]
    fn is_within(self, _bound: Self) -> bool {
        true
    }

    /// The smaller of the number and `bound`, which keeps subsequent results in the range of fixed point. Floats are returned unchanged.
    #[inline(always)]
    #[must_use]
    fn bounded(self, _bound: Self) -> Self {
        self
    }

    /// The number of times that a positive number can be doubled without exceeding `large` in fixed point; for a larger number it is minus the number of halvings.
    /// Zero for floats, which keep their digits at any size.
    #[inline(always)]
    fn headroom(self, _large: Self) -> i32 {
        0
    }

    /// `self · 2^shift`: the number in a smaller unit, for a larger range of digits in fixed point. Floats are returned unchanged, as they keep their digits in
    /// any unit.
    #[inline(always)]
    #[must_use]
    fn in_smaller_unit(self, _shift: u32) -> Self {
        self
    }

    /// `self / 2^shift`: the number in a larger unit. Floats are returned unchanged.
    #[inline(always)]
    #[must_use]
    fn in_larger_unit(self, _shift: u32) -> Self {
        self
    }

    /// The number prepared as a divisor for [`over`](Self::over): the reciprocal, if the type divides by multiplying.
    #[inline(always)]
    #[must_use]
    fn divisor(self) -> Self {
        self
    }

    /// `self` divided by a [divisor](Self::divisor).
    #[inline(always)]
    #[must_use]
    fn over(self, divisor: Self) -> Self {
        self.divide(divisor)
    }

    /// The exact (fixed point) or rounded (float) product.
    fn product(self, other: Self) -> Self::Product;

    /// A product rounded to nearest; saturates in fixed point.
    fn narrow(product: Self::Product) -> Self;

    /// `self · ratio` for `|ratio| ≤ 1`, with an error relative to `self`: [`Q13`] keeps few digits of a small ratio.
    #[inline]
    #[must_use]
    fn scaled(self, ratio: Self) -> Self {
        self * ratio
    }

    /// [`scaled`](Self::scaled) with the given rounding.
    #[inline]
    #[must_use]
    fn scaled_as(self, ratio: Self, _: Rounding) -> Self {
        self.scaled(ratio)
    }

    /// The square root of a sum of squares.
    fn root(squares: Self::Product) -> Self;

    /// `1/self`; zero has the largest number as its reciprocal in fixed point, infinity in float.
    #[must_use]
    fn recip(self) -> Self;

    /// `self / divisor`.
    #[must_use]
    fn divide(self, divisor: Self) -> Self;

    /// `1 − L/√squares`: the fraction of a link's vector by which it exceeds its rest length `L`.
    ///
    /// Multiplied by the link's vector this is its elongation as a vector. For coincident particles, which have no direction, the
    /// result is finite.
    fn elongation(squares: Self::Product, rest: &Rest<Self>) -> Self;

    /// The whole number nearest to `self · factor`, ties upward: pixels, tones, depths. The result lies within 32 bits.
    fn round_times(self, factor: i32) -> i32;

    /// `256 · self` as a whole number with an error below one, for bounding boxes. Saturates at 32 bits.
    fn coarse(self) -> i32;

    /// The correction applied to both ends of a link d, with opposite signs, to remove `part` of its elongation: `part·(1 − L/|d|)·d`; `|part| ≤ 1`.
    #[inline]
    fn correction(d: [Self; 3], rest: &Rest<Self>, part: Self, _: Rounding) -> [Self; 3] {
        let part = Self::elongation(squared(d), rest) * part;
        [d[0] * part, d[1] * part, d[2] * part]
    }

    /// `|d| − L` and `d/|d|`: a link's excess over its rest length, and its direction.
    fn direction(d: [Self; 3], rest: &Rest<Self>) -> (Self, [Self; 3]);

    /// The cosine of the angle between two directions.
    #[inline]
    fn cosine(a: [Self; 3], b: [Self; 3]) -> Self {
        Self::narrow(a[0].product(b[0]) + a[1].product(b[1]) + a[2].product(b[2]))
    }

    /// `(place − origin)·normal`, also for points further apart than the range of fixed point.
    #[inline]
    fn height(place: [Self; 3], origin: [Self; 3], normal: [Self; 3]) -> Self {
        Self::cosine([place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]], normal)
    }

    /// Whether one of four vectors is shorter than `length`; in fixed point, whether all components of one are.
    #[inline(always)]
    fn any_shorter(vector: impl Fn(usize) -> [Self; 3], length: Self) -> bool {
        // four numbers at once, if the processor supports it
        let square = |lane| Self::narrow(squared(vector(lane)));
        let [a, b, c, d] = [square(0), square(1), square(2), square(3)];
        a.min(b).min(c.min(d)) < length * length
    }

    /// The constants of panels of area A₀ at rest (cells², up to 1). Air that moves at one cell per tick against a panel of 1 cell² gives each of its corners
    /// the velocity `pressure` in a substep.
    fn panel(pressure: Self, area: Self) -> Self::Panel;

    /// The velocity gain of each corner of a panel with these diagonals a and b, in air of this velocity u relative to it: `c·n·(n·u)`, n = a×b/2,
    ///
    /// `c = min(pressure·|n·u|/|n|², most·min(1/A₀, 2·A₀/|n|²))`
    ///
    /// So a panel of its rest area gains at most `most·A₀` of the air's velocity normal to it, and any panel at most twice as much. No root is needed. `most`
    /// is 3/32 or less.
    ///
    /// `None` outside the range of the fast path; then call [`press_any`](Self::press_any).
    fn press(
        diagonals: [[Self; 3]; 2],
        air: [Self; 3],
        panel: &Self::Panel,
        most: impl FnOnce() -> Self,
    ) -> Option<[Self; 3]>;

    /// [`press`](Self::press) for panels of any size in any air.
    fn press_any(diagonals: [[Self; 3]; 2], air: [Self; 3], panel: &Self::Panel, most: Self) -> [Self; 3];

    /// A quarter of `self + other`; the sum may exceed the range of fixed point.
    #[inline(always)]
    #[must_use]
    fn quarter_of_sum(self, other: Self) -> Self {
        (self + other).halve(2)
    }

    /// Adds a product to a sum.
    fn accumulate(sum: Self::Sum, product: Self::Product) -> Self::Sum;

    /// The empty sum.
    const EMPTY: Self::Sum;

    /// The quotient of two sums; `divisor > 0`.
    fn quotient(dividend: Self::Sum, divisor: Self::Sum) -> Self;

    /// The root of the mean of `count` squares.
    fn root_mean(sum: Self::Sum, count: u32) -> Self;

    /// Passes the number's bits, least significant byte first, to `hash`. All undefined floats pass the same bits.
    fn bits(self, hash: impl FnMut(u8));

    /// The bits passed by [`bits`](Self::bits), folded into 32.
    fn word(self) -> u32;

    /// Whether the number is neither infinite nor undefined; always true in fixed point.
    fn is_finite(self) -> bool;

    /// The magnitude.
    #[inline]
    #[must_use]
    fn abs(self) -> Self {
        if self < Self::ZERO { -self } else { self }
    }

    /// The larger of two numbers.
    #[inline]
    #[must_use]
    fn max(self, other: Self) -> Self {
        if other > self { other } else { self }
    }

    /// The smaller of two numbers.
    #[inline]
    #[must_use]
    fn min(self, other: Self) -> Self {
        if other < self { other } else { self }
    }
}

#[inline]
fn squared<S: Scalar>([x, y, z]: [S; 3]) -> S::Product {
    x.product(x) + y.product(y) + z.product(z)
}

/// A link's rest length, prepared for [`Scalar::elongation`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rest<S: Scalar> {
    /// The length, cells.
    pub length: S,
    /// `length²`.
    pub square: S,
    /// `1/length`.
    pub inverse: S,
    /// `1/length²`.
    pub inverse_square: S,
    /// Data that the number type computes once for a rest length instead of for each link.
    pub prepared: S::Prepared,
}

impl<S: Scalar> Rest<S> {
    /// The rest length of a link that spans `across` and `down` (cells).
    pub fn spanning(across: S, down: S) -> Self {
        let square = across.product(across) + down.product(down);
        let length = S::root(square);
        let square = S::narrow(square);
        let (inverse, inverse_square) = (S::ONE.divide(length), S::ONE.divide(square));
        Self { length, square, inverse, inverse_square, prepared: S::prepared(inverse, inverse_square) }
    }
}
