//! Vectors of three numbers.

use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use crate::scalar::{Rest, Rounding, Scalar};

/// A vector (x, y, z); z points up.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Vec3<S> {
    /// To the right.
    pub x: S,
    /// Away from the viewer.
    pub y: S,
    /// Up.
    pub z: S,
}

impl<S: Scalar> Vec3<S> {
    /// The null vector.
    pub const ZERO: Self = Self { x: S::ZERO, y: S::ZERO, z: S::ZERO };

    /// The vector (x, y, z).
    #[inline]
    pub const fn new(x: S, y: S, z: S) -> Self {
        Self { x, y, z }
    }

    /// The nearest vector to `values`.
    #[inline]
    pub fn from_f64([x, y, z]: [f64; 3]) -> Self {
        Self::new(S::from_f64(x), S::from_f64(y), S::from_f64(z))
    }

    /// The components as `f64`.
    #[inline]
    pub fn to_f64(self) -> [f64; 3] {
        [self.x.to_f64(), self.y.to_f64(), self.z.to_f64()]
    }

    /// The vector with `f` applied to each component.
    #[inline]
    #[must_use]
    pub fn map(self, f: impl Fn(S) -> S) -> Self {
        Self::new(f(self.x), f(self.y), f(self.z))
    }

    /// The scalar product at full width.
    #[inline]
    pub(crate) fn dot_wide(self, other: Self) -> S::Product {
        self.x.product(other.x) + self.y.product(other.y) + self.z.product(other.z)
    }

    /// The scalar product, rounded once.
    #[inline]
    pub fn dot(self, other: Self) -> S {
        S::narrow(self.dot_wide(other))
    }

    /// The vector from `other` to `self`, by [`Scalar::difference`].
    #[inline]
    #[must_use]
    pub fn difference(self, other: Self) -> Self {
        Self::new(self.x.difference(other.x), self.y.difference(other.y), self.z.difference(other.z))
    }

    /// The vector product.
    #[inline]
    #[must_use]
    pub fn cross(self, other: Self) -> Self {
        Self::new(
            self.y * other.z - self.z * other.y,
            self.z * other.x - self.x * other.z,
            self.x * other.y - self.y * other.x,
        )
    }

    /// The squared length at full width: comparing it needs no root.
    #[inline]
    pub fn squared(self) -> S::Product {
        self.dot_wide(self)
    }

    /// The length.
    #[inline]
    pub fn length(self) -> S {
        S::root(self.squared())
    }

    /// `self · ratio` for `|ratio| ≤ 1`.
    #[inline(always)]
    #[must_use]
    pub(crate) fn scaled(self, ratio: S) -> Self {
        self.map(|component| component.scaled(ratio))
    }

    /// The vector of length `length` in this direction, with the given rounding.
    #[inline(always)]
    #[must_use]
    pub(crate) fn of_length(self, length: S, rounding: Rounding) -> Self {
        self.map(|component| length.scaled_as(component, rounding))
    }

    /// [`Scalar::correction`] of this link vector.
    #[inline(always)]
    #[must_use]
    pub(crate) fn correction(self, rest: &Rest<S>, part: S, rounding: Rounding) -> Self {
        Self::of(S::correction(self.array(), rest, part, rounding))
    }

    /// `|self| − L` and `self/|self|`.
    #[inline(always)]
    pub(crate) fn direction(self, rest: &Rest<S>) -> (S, Self) {
        let (excess, normal) = S::direction(self.array(), rest);
        (excess, Self::of(normal))
    }

    /// The cosine of the angle between two directions.
    #[inline(always)]
    pub(crate) fn cosine(self, other: Self) -> S {
        S::cosine(self.array(), other.array())
    }

    /// The gain by [`Scalar::press`] of a panel's corners, for these diagonals and this relative velocity of the air.
    #[inline(always)]
    pub(crate) fn press([a, b]: [Self; 2], air: Self, panel: &S::Panel, most: impl FnOnce() -> S) -> Option<Self> {
        S::press([a.array(), b.array()], air.array(), panel, most).map(Self::of)
    }

    /// The gain by [`Scalar::press_any`].
    #[inline]
    #[must_use]
    pub(crate) fn press_any([a, b]: [Self; 2], air: Self, panel: &S::Panel, most: S) -> Self {
        Self::of(S::press_any([a.array(), b.array()], air.array(), panel, most))
    }

    /// A quarter of `self + other`.
    #[inline(always)]
    #[must_use]
    pub(crate) fn quarter_of_sum(self, other: Self) -> Self {
        Self::new(self.x.quarter_of_sum(other.x), self.y.quarter_of_sum(other.y), self.z.quarter_of_sum(other.z))
    }

    #[inline(always)]
    fn of([x, y, z]: [S; 3]) -> Self {
        Self { x, y, z }
    }

    #[inline(always)]
    pub(crate) fn array(self) -> [S; 3] {
        [self.x, self.y, self.z]
    }

    /// This vector if `this`, otherwise the other one, without a branch.
    #[inline(always)]
    #[must_use]
    pub fn or(self, other: Self, this: bool) -> Self {
        let choose = |a, b| if this { a } else { b };
        Self::new(choose(self.x, other.x), choose(self.y, other.y), choose(self.z, other.z))
    }

    /// `self · factor`, for small whole factors.
    #[inline]
    #[must_use]
    pub fn times(self, factor: i32) -> Self {
        self.map(|component| component.times(factor))
    }

    /// `self · 2^shift`.
    #[inline]
    #[must_use]
    pub(crate) fn double(self, shift: u32) -> Self {
        self.map(|component| component.double(shift))
    }

    /// `self / 2^shift`, rounded to nearest.
    #[inline]
    #[must_use]
    pub fn halve(self, shift: u32) -> Self {
        self.map(|component| component.halve(shift))
    }
}

impl<S: Scalar> Add for Vec3<S> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::new(self.x + other.x, self.y + other.y, self.z + other.z)
    }
}

impl<S: Scalar> Sub for Vec3<S> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::new(self.x - other.x, self.y - other.y, self.z - other.z)
    }
}

impl<S: Scalar> Neg for Vec3<S> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        self.map(|component| -component)
    }
}

impl<S: Scalar> Mul<S> for Vec3<S> {
    type Output = Self;
    #[inline]
    fn mul(self, factor: S) -> Self {
        self.map(|component| component * factor)
    }
}

impl<S: Scalar> AddAssign for Vec3<S> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<S: Scalar> SubAssign for Vec3<S> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}
