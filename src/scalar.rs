//! Numbers: `f32`, `f64` and fixed point behind one trait.
//!
//! This is the only module that knows a number's bits. Everything above it computes with [`Scalar`], in the sheet's own units
//! (see [`Units`](crate::Units)), so that lengths are near one and fixed point loses nothing.
//!
//! Only `+ − × ÷` and the square root are used, each rounded once and always in the same order, so every number type gives the same
//! bits on every target.

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

/// A number that a sheet can be computed in.
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
    /// The largest magnitude that the type holds.
    const LARGEST: f64;
    /// The spacing of numbers just above one.
    const RESOLUTION: f64;
    /// The steps in which the type measures a link some cells from the origin, cells: by a few of them a sheet at rest trembles.
    const EDGE: f64;
    /// How far rounding carries a sheet that is as good as at rest, cells. In fixed point drag does not slow the last 1/(2·γ·h) places of a velocity.
    const STRAY: f64;

    /// Whether sums and differences are exact, and wrap beyond the range: those of fixed point. Then no order of adding loses a digit, and a few last places are nothing but
    /// round-off.
    const EXACT_SUMS: bool = false;
    /// Whether looking if a factor is 0 or 1 costs less than a product.
    const LOOKING_PAYS: bool = false;
    /// The least softness 1/κ beside which the inertia of a particle is resolved.
    const LEAST_SOFTNESS: f64 = 1e-6;
    /// A [divisor](Self::divisor) that leaves nothing of a number.
    const INFINITE_DIVISOR: Self;

    /// A product of two numbers, wide enough for three of them to be added without overflow; exact in fixed point.
    type Product: Copy + Debug + PartialOrd + Add<Output = Self::Product>;
    /// A sum of many products, as the dot product of two whole sheets.
    type Sum: Copy + Debug + PartialOrd;
    /// What a rest length is [prepared](Self::prepared) for besides its inverse.
    type Prepared: Copy + Debug + PartialEq + Send + Sync + 'static;
    /// What the panels of a sheet have in common.
    type Panel: Copy + Debug + PartialEq + Send + Sync + 'static;

    /// The nearest number to `value`; beyond [`LARGEST`](Self::LARGEST) fixed point saturates.
    ///
    /// Integer arithmetic alone for fixed point: firmware links no float routine.
    fn from_f64(value: f64) -> Self;

    /// What links of a rest length L are measured with, from 1/L and 1/L².
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

    /// The same with ties away from zero: rounded up, many of them push a sheet aside.
    #[inline]
    #[must_use]
    fn halve_evenly(self, shift: u32) -> Self {
        if self < Self::ZERO { -(-self).halve(shift) } else { self.halve(shift) }
    }

    /// `self · halves/2 · 2^shift`.
    #[must_use]
    fn rate(self, halves: u32, shift: u32) -> Self;

    /// `self − other`, as of places that may be further apart than fixed point holds: then the largest number of that sign.
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

    /// Whether the number is no more than a bound that keeps what follows in the range of fixed point. Floats need none.
    #[inline(always)]
    fn is_within(self, _bound: Self) -> bool {
        true
    }

    /// The number, or a bound that keeps what follows in the range of fixed point.
    #[inline(always)]
    #[must_use]
    fn bounded(self, _bound: Self) -> Self {
        self
    }

    /// How often fixed point doubles a positive number until another time would make it more than `large`; how often it halves a larger one, below zero. Floats keep their
    /// digits at any size.
    #[inline(always)]
    fn headroom(self, _large: Self) -> i32 {
        0
    }

    /// `self · 2^shift`: in a unit so much smaller, where fixed point has room for it. Floats keep their digits in any unit, and their unit.
    #[inline(always)]
    #[must_use]
    fn in_smaller_unit(self, _shift: u32) -> Self {
        self
    }

    /// `self / 2^shift`, likewise in a unit so much larger.
    #[inline(always)]
    #[must_use]
    fn in_larger_unit(self, _shift: u32) -> Self {
        self
    }

    /// What [`over`](Self::over) divides by: for numbers that divide by multiplying, the reciprocal.
    #[inline(always)]
    #[must_use]
    fn divisor(self) -> Self {
        self
    }

    /// `self` by a [divisor](Self::divisor).
    #[inline(always)]
    #[must_use]
    fn over(self, divisor: Self) -> Self {
        self.divide(divisor)
    }

    /// The exact (fixed point) or rounded (float) product.
    fn product(self, other: Self) -> Self::Product;

    /// A product rounded to nearest; saturates in fixed point.
    fn narrow(product: Self::Product) -> Self;

    /// `self · ratio` for `|ratio| ≤ 1`, right to a part of `self`: of a small ratio [`Q13`] keeps few digits.
    #[inline]
    #[must_use]
    fn scaled(self, ratio: Self) -> Self {
        self * ratio
    }

    /// The same, rounded as told.
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

    /// `1 − L/√squares`: the part of a link's vector by which it is longer than its rest length `L`.
    ///
    /// Multiplied by the link's vector this is its elongation as a vector. For coincident particles, which have no direction, the
    /// result is finite.
    fn elongation(squares: Self::Product, rest: &Rest<Self>) -> Self;

    /// The whole number nearest to `self · factor`, ties upward: pixels, tones, depths. The result lies within 32 bits.
    fn round_times(self, factor: i32) -> i32;

    /// `256 · self` as a whole number, less than one off: what boxes are made of. The largest or least of 32 bits where they don't hold it.
    fn coarse(self) -> i32;

    /// What is done to both ends of a link d to undo `part` of its elongation, `part·(1 − L/|d|)·d`; `|part| ≤ 1`.
    #[inline]
    fn correction(d: [Self; 3], rest: &Rest<Self>, part: Self, _: Rounding) -> [Self; 3] {
        let part = Self::elongation(squared(d), rest) * part;
        [d[0] * part, d[1] * part, d[2] * part]
    }

    /// `|d| − L` and `d/|d|`: by how much a link is longer than its rest length, and its direction.
    fn direction(d: [Self; 3], rest: &Rest<Self>) -> (Self, [Self; 3]);

    /// The cosine of the angle between two directions.
    #[inline]
    fn cosine(a: [Self; 3], b: [Self; 3]) -> Self {
        Self::narrow(a[0].product(b[0]) + a[1].product(b[1]) + a[2].product(b[2]))
    }

    /// `(place − origin)·normal`, as of places that may be further apart than fixed point holds.
    #[inline]
    fn height(place: [Self; 3], origin: [Self; 3], normal: [Self; 3]) -> Self {
        Self::cosine([place[0] - origin[0], place[1] - origin[1], place[2] - origin[2]], normal)
    }

    /// Whether one of four vectors is shorter than `length`, or in fixed point all its components are.
    #[inline(always)]
    fn any_shorter(vector: impl Fn(usize) -> [Self; 3], length: Self) -> bool {
        // four numbers at once, where a machine does that
        let square = |lane| Self::narrow(squared(vector(lane)));
        let [a, b, c, d] = [square(0), square(1), square(2), square(3)];
        a.min(b).min(c.min(d)) < length * length
    }

    /// What panels of the area A₀ at rest (cells², up to 1) have in common. Air that moves at one cell per tick against a panel of 1 cell² gives each of its
    /// corners the velocity `pressure` in a substep.
    fn panel(pressure: Self, area: Self) -> Self::Panel;

    /// The velocity that each corner of a panel with these diagonals a and b gains from air with this velocity relative to it: `c·n·(n·u)`, n = a×b/2,
    ///
    /// `c = min(pressure·|n·u|/|n|², most·min(1/A₀, 2·A₀/|n|²))`
    ///
    /// So air takes a panel of its rest area no further than by `most·A₀` of its velocity across it, and no panel further than by twice as much. Without a root. `most` is
    /// 3/32 or less.
    ///
    /// Nothing where there is no short way; then [`press_any`](Self::press_any) is asked.
    fn press(
        diagonals: [[Self; 3]; 2],
        air: [Self; 3],
        panel: &Self::Panel,
        most: impl FnOnce() -> Self,
    ) -> Option<[Self; 3]>;

    /// The same for panels of any size in any air.
    fn press_any(diagonals: [[Self; 3]; 2], air: [Self; 3], panel: &Self::Panel, most: Self) -> [Self; 3];

    /// A quarter of `self + other`, which may be more than fixed point holds.
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

    /// Passes the number's bits, least significant byte first, to `hash`. Floats that are undefined pass the same ones.
    fn bits(self, hash: impl FnMut(u8));

    /// The number's bits, folded into 32, as [`bits`](Self::bits) passes them.
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
    /// What the number type forms once, not for each link.
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
