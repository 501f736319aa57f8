//! Fixed point with 8 bits before the point and 24 after it.

mod conversion;
mod exact;
mod kernel;
mod newton;
mod panel;
mod product;
mod quotient;
mod short;

use core::marker::PhantomData;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use fixed::types::I8F24;

use super::wide::Wide;
use super::{Rest, Rounding, Scalar};
use product::{round, signed};
use quotient::{divide, quotient, root, saturate};

use exact::Exact;
use kernel::Kernel;
use panel::Panel;
use short::Short;

/// A fixed-point number from −128 to 128 in steps of 2⁻²⁴ (6·10⁻⁸). The kernel `K` computes its products, quotients and links.
///
/// Sums wrap, products are rounded to nearest. (The operators of the crate `fixed` round towards −∞, which pushes a sheet at rest sideways.) Lengths are
/// measured in cells: a sheet may move through 128 cells to either side of the origin.
#[derive(Clone, Copy, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Fixed24<K>(I8F24, PhantomData<K>);

/// The accurate type: results are accurate to 6·10⁻⁸ cells, which takes 64-bit products for a link.
pub type Q24 = Fixed24<Exact>;

/// The fast type: links are measured to 13 fraction bits, 6·10⁻⁵ cells, which takes 32-bit products only. All other values have the 24 bits of [`Q24`].
///
/// Links strained by more than 6 %, or shorter than 0.61 cells, are computed by the code of [`Q24`].
pub type Q13 = Fixed24<Short>;

const FRACTION: u32 = 24;

/// The bits of one.
const ONE: i32 = 1 << FRACTION;

impl<K> Fixed24<K> {
    /// The number with these bits, `bits / 2²⁴`.
    #[inline]
    pub const fn from_bits(bits: i32) -> Self {
        Self(I8F24::from_bits(bits), PhantomData)
    }

    /// The number's bits, `value · 2²⁴`.
    #[inline]
    pub const fn to_bits(self) -> i32
    where
        K: Copy,
    {
        self.0.to_bits()
    }

    /// The same number as a type of the crate `fixed`.
    pub const fn to_fixed(self) -> I8F24
    where
        K: Copy,
    {
        self.0
    }
}

impl<K> core::fmt::Debug for Fixed24<K> {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        core::fmt::Debug::fmt(&self.0, f)
    }
}

#[cfg(feature = "defmt")]
impl<K: Kernel> defmt::Format for Fixed24<K> {
    fn format(&self, f: defmt::Formatter<'_>) {
        defmt::write!(f, "{}p-24", self.to_bits());
    }
}

impl<K: Kernel> Add for Fixed24<K> {
    type Output = Self;
    #[inline]
    fn add(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().wrapping_add(other.to_bits()))
    }
}

impl<K: Kernel> Sub for Fixed24<K> {
    type Output = Self;
    #[inline]
    fn sub(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().wrapping_sub(other.to_bits()))
    }
}

impl<K: Kernel> Mul for Fixed24<K> {
    type Output = Self;
    #[inline]
    fn mul(self, other: Self) -> Self {
        Self::from_bits(K::multiply(self.to_bits(), other.to_bits()))
    }
}

impl<K: Kernel> Neg for Fixed24<K> {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self::from_bits(self.to_bits().wrapping_neg())
    }
}

impl<K: Kernel> AddAssign for Fixed24<K> {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl<K: Kernel> SubAssign for Fixed24<K> {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// Applies `change` to each component. (The standard library's `map` on arrays is not always inlined.)
#[inline(always)]
fn each<T, U>([x, y, z]: [T; 3], change: impl Fn(T) -> U) -> [U; 3] {
    [change(x), change(y), change(z)]
}

impl<K: Kernel> Scalar for Fixed24<K> {
    const NAME: &'static str = K::NAME;
    const ZERO: Self = Self::from_bits(0);
    const ONE: Self = Self::from_bits(1 << FRACTION);
    const HALF: Self = Self::from_bits(1 << (FRACTION - 1));
    const LARGEST: f64 = 127.999_999_94;
    const RESOLUTION: f64 = 1.0 / (1 << FRACTION) as f64;
    const EDGE: f64 = K::EDGE;
    const STRAY: f64 = K::STRAY;
    const EMPTY: i128 = 0;
    const EXACT_SUMS: bool = true;
    const LOOKING_PAYS: bool = true;
    const LEAST_SOFTNESS: f64 = 1.0 / 65_536.0;
    const INFINITE_DIVISOR: Self = Self::ZERO;

    type Product = Wide;
    type Prepared = K::Prepared;
    type Panel = Panel;
    type Sum = i128;

    #[inline]
    fn prepared(inverse: Self, inverse_square: Self) -> K::Prepared {
        K::prepared(inverse.to_bits(), inverse_square.to_bits())
    }

    #[inline]
    fn from_f64(value: f64) -> Self {
        // Decoded from the bits: a comparison or a product of floats would link a routine.
        let bits = value.to_bits();
        let exponent = ((bits >> 52) & 0x7ff) as i32 - 1075 + FRACTION as i32;
        let mantissa = (bits & ((1 << 52) - 1)) | (1 << 52);
        let magnitude = if exponent >= 0 {
            i64::from(i32::MAX)
        } else if exponent > -54 {
            (((mantissa >> (-exponent - 1)) + 1) >> 1).min(i32::MAX as u64) as i64
        } else {
            0
        };
        Self::from_bits(if bits >> 63 == 0 { magnitude } else { -magnitude } as i32)
    }

    #[inline]
    fn from_int(value: i32) -> Self {
        Self::from_bits(value << FRACTION)
    }

    #[inline]
    fn to_f64(self) -> f64 {
        f64::from(self.to_bits()) * Self::RESOLUTION
    }

    #[inline]
    fn times(self, factor: i32) -> Self {
        Self::from_bits(self.to_bits().wrapping_mul(factor))
    }

    #[inline]
    fn double(self, shift: u32) -> Self {
        Self::from_bits(self.to_bits().wrapping_shl(shift))
    }

    #[inline]
    fn halve(self, shift: u32) -> Self {
        if shift == 0 {
            return self;
        }
        Self::from_bits(((self.to_bits() >> (shift - 1)).wrapping_add(1)) >> 1)
    }

    #[inline]
    fn rate(self, halves: u32, shift: u32) -> Self {
        // wraps only if the result itself is too large
        match (halves % 2, shift) {
            (0, _) => self.times(halves as i32 / 2).double(shift),
            (_, 0) => self.times(halves as i32 / 2) + self.halve(1),
            _ => self.times(halves as i32).double(shift - 1),
        }
    }

    #[inline]
    fn difference(self, other: Self) -> Self {
        Self::from_bits(self.to_bits().saturating_sub(other.to_bits()))
    }

    #[inline]
    fn wraps(self, other: Self) -> bool {
        self.to_bits().checked_add(other.to_bits()).is_none()
    }

    #[inline(always)]
    fn is_within(self, bound: Self) -> bool {
        self <= bound
    }

    #[inline(always)]
    fn bounded(self, bound: Self) -> Self {
        Scalar::min(self, bound)
    }

    #[inline]
    fn headroom(self, large: Self) -> i32 {
        let (mut most, mut room) = (self, 0);
        if most <= Self::ZERO {
            return 0;
        }
        while most > large {
            most = most.halve(1);
            room -= 1;
        }
        while most.double(1) <= large {
            most = most.double(1);
            room += 1;
        }
        room
    }

    #[inline(always)]
    fn in_smaller_unit(self, shift: u32) -> Self {
        self.double(shift)
    }

    #[inline(always)]
    fn in_larger_unit(self, shift: u32) -> Self {
        self.halve(shift)
    }

    #[inline(always)]
    fn divisor(self) -> Self {
        self.recip()
    }

    #[inline(always)]
    fn over(self, divisor: Self) -> Self {
        self * divisor
    }

    #[inline]
    fn product(self, other: Self) -> Wide {
        Wide::new(signed(self.to_bits(), other.to_bits()))
    }

    #[inline]
    fn narrow(product: Wide) -> Self {
        Self::from_bits(saturate(round(product.signed())))
    }

    #[inline]
    fn scaled(self, ratio: Self) -> Self {
        Self::from_bits(K::scaled(self.to_bits(), ratio.to_bits(), Rounding::NEAREST))
    }

    #[inline]
    fn scaled_as(self, ratio: Self, rounding: Rounding) -> Self {
        Self::from_bits(K::scaled(self.to_bits(), ratio.to_bits(), rounding))
    }

    #[inline]
    fn root(squares: Wide) -> Self {
        Self::from_bits(root(squares.squares()))
    }

    #[inline]
    fn recip(self) -> Self {
        if self <= Self::ZERO {
            return Self::ONE.divide(self);
        }
        Self::from_bits(K::reciprocal(self.to_bits()))
    }

    #[inline]
    fn divide(self, divisor: Self) -> Self {
        if divisor == Self::ZERO {
            return Self::from_bits(if self < Self::ZERO { -i32::MAX } else { i32::MAX });
        }
        Self::from_bits(divide(self.to_bits(), divisor.to_bits()))
    }

    #[inline]
    fn elongation(squares: Wide, rest: &Rest<Self>) -> Self {
        Self::from_bits(exact::elongation(squares.squares(), rest))
    }

    #[inline(always)]
    fn correction(d: [Self; 3], rest: &Rest<Self>, part: Self, rounding: Rounding) -> [Self; 3] {
        each(K::correction(each(d, Self::to_bits), rest, part.to_bits(), rounding), Self::from_bits)
    }

    #[inline]
    fn direction(d: [Self; 3], rest: &Rest<Self>) -> (Self, [Self; 3]) {
        let (excess, normal) = K::direction(each(d, Self::to_bits), rest);
        (Self::from_bits(excess), each(normal, Self::from_bits))
    }

    #[inline]
    fn cosine(a: [Self; 3], b: [Self; 3]) -> Self {
        Self::from_bits(K::cosine(each(a, Self::to_bits), each(b, Self::to_bits)))
    }

    #[inline]
    fn height(place: [Self; 3], origin: [Self; 3], normal: [Self; 3]) -> Self {
        // products are exact, and so is their sum
        let along = |[x, y, z]: [Self; 3]| x.product(normal[0]) + y.product(normal[1]) + z.product(normal[2]);
        Self::narrow(along(place) + along(each(origin, Neg::neg)))
    }

    #[inline(always)]
    fn any_shorter(vector: impl Fn(usize) -> [Self; 3], length: Self) -> bool {
        let short = |lane| {
            let [x, y, z] = vector(lane);
            x.abs() < length && z.abs() < length && y.abs() < length
        };
        short(0) || short(1) || short(2) || short(3)
    }

    #[inline]
    fn round_times(self, factor: i32) -> i32 {
        round(signed(self.to_bits(), factor)) as i32
    }

    #[inline]
    fn coarse(self) -> i32 {
        self.to_bits() >> 16
    }

    #[inline]
    fn panel(pressure: Self, area: Self) -> Panel {
        Panel::new(pressure.to_bits(), area.to_bits())
    }

    #[inline(always)]
    fn press([a, b]: [[Self; 3]; 2], air: [Self; 3], panel: &Panel, most: impl FnOnce() -> Self) -> Option<[Self; 3]> {
        let bits = |vector| each(vector, Self::to_bits);
        let gain = panel.press([bits(a), bits(b)], bits(air), || most().to_bits())?;
        Some(each(gain, Self::from_bits))
    }

    #[inline]
    fn press_any([a, b]: [[Self; 3]; 2], air: [Self; 3], panel: &Panel, most: Self) -> [Self; 3] {
        let bits = |vector| each(vector, Self::to_bits);
        each(panel.press_any([bits(a), bits(b)], bits(air), most.to_bits()), Self::from_bits)
    }

    #[inline(always)]
    fn quarter_of_sum(self, other: Self) -> Self {
        // cut off: an error of one place of 24 bits is negligible for air
        Self::from_bits((self.to_bits() >> 2) + (other.to_bits() >> 2))
    }

    #[inline]
    fn accumulate(sum: i128, product: Wide) -> i128 {
        sum + i128::from(product.signed())
    }

    #[inline]
    fn quotient(dividend: i128, divisor: i128) -> Self {
        let quotient = quotient(dividend.unsigned_abs(), divisor.unsigned_abs());
        Self::from_bits(if dividend < 0 { -quotient } else { quotient })
    }

    #[inline]
    fn root_mean(sum: i128, count: u32) -> Self {
        Self::root(Wide::new((sum / i128::from(count)) as i64))
    }

    #[inline]
    fn bits(self, hash: impl FnMut(u8)) {
        self.to_bits().to_le_bytes().into_iter().for_each(hash);
    }

    #[inline]
    fn word(self) -> u32 {
        self.to_bits() as u32
    }

    #[inline]
    fn is_finite(self) -> bool {
        true
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vec3::Vec3;

    fn number(value: f64) -> Q24 {
        Q24::from_f64(value)
    }

    #[test]
    fn from_f64_rounds_to_nearest_and_saturates() {
        for value in [0.0, 1.0, -1.0, 0.3, -0.3, 1e-9, 127.5, -127.5, 3e-8, -3e-8, 5e-324] {
            let expected = (value * 16_777_216.0_f64).round() as i32;
            assert_eq!(number(value).to_bits(), expected, "{value}");
        }
        assert_eq!(number(1e9).to_bits(), i32::MAX);
        assert_eq!(number(-1e300).to_bits(), -i32::MAX);
    }

    #[test]
    fn products_round_to_nearest() {
        let ulp = Q24::from_bits(1);
        assert_eq!(ulp * Q24::HALF, ulp);
        assert_eq!(-ulp * Q24::HALF, Q24::ZERO);
        assert_eq!((-Q24::from_bits(3)).halve(2), Q24::from_bits(-1));
        assert_eq!(Q24::from_bits(5).halve(2), Q24::from_bits(1));
    }

    #[test]
    fn a_link_at_rest_length_is_exactly_at_rest() {
        for (across, down) in [(1, 0), (1, 1), (2, 0)] {
            let rest = Rest::spanning(Q24::from_int(across), Q24::from_int(down));
            let squares =
                Q24::from_int(across).product(Q24::from_int(across)) + Q24::from_int(down).product(Q24::from_int(down));
            assert_eq!(Q24::elongation(squares, &rest), Q24::ZERO);
        }
        assert_eq!(Q24::elongation(Wide::new(0), &Rest::spanning(Q24::ONE, Q24::ZERO)), Q24::ZERO);
    }

    #[test]
    fn whole_numbers_are_the_nearest() {
        for (value, factor, expected) in
            [(0.5, 1, 1), (-0.5, 1, 0), (0.49, 1, 0), (-1.51, 1, -2), (127.9, 1_000_000, 127_900_000)]
        {
            assert_eq!(number(value).round_times(factor) / 10, expected / 10, "{value} · {factor}");
            assert_eq!(value.round_times(factor), expected, "{value} · {factor}");
        }
        assert_eq!(number(-0.5).round_times(3), -1);
    }

    #[test]
    fn no_distance_within_the_range_is_too_long() {
        // 208 cells: the square exceeds an i64
        let far = Vec3::new(number(120.0), number(-120.0), number(120.0));
        let reach = number(127.0);
        assert!(far.squared() > reach.product(reach));
        assert_eq!(far.length().to_bits(), i32::MAX);
        let rest = Rest::spanning(number(1.5), Q24::ZERO);
        assert!((Q24::elongation(far.squared(), &rest).to_f64() - (1.0 - 1.5 / (120.0 * 3.0_f64.sqrt()))).abs() < 1e-6);
    }
}
