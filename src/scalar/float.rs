//! `f32` and `f64`.

use super::panel::Panel;
use super::{Rest, Scalar, root};

/// A number's bits, with the same bits for every NaN: Rust leaves the NaN that an operation returns to the compiler.
trait CanonicalBits {
    type Bits;
    fn canonical_bits(self) -> Self::Bits;
}

macro_rules! float {
    ($float:ty, $bits:ty, $name:literal, $sqrt:path, $floor:path, $tiny:literal) => {
        impl CanonicalBits for $float {
            type Bits = $bits;
            #[inline]
            fn canonical_bits(self) -> $bits {
                let bits = self.to_bits();
                // in integers, because a comparison of floats may be a function call
                if bits << 1 > <$float>::INFINITY.to_bits() << 1 { <$float>::NAN.to_bits() } else { bits }
            }
        }

        impl Scalar for $float {
            const NAME: &'static str = $name;
            const ZERO: Self = 0.0;
            const ONE: Self = 1.0;
            const HALF: Self = 0.5;
            const LARGEST: f64 = <$float>::MAX as f64;
            const RESOLUTION: f64 = <$float>::EPSILON as f64;
            // the resolution of positions 8 cells from the origin
            const EDGE: f64 = 8.0 * Self::RESOLUTION;
            const STRAY: f64 = 8.0 * Self::EDGE;
            const EMPTY: Self = 0.0;
            const INFINITE_DIVISOR: Self = <$float>::INFINITY;

            type Product = Self;
            type Prepared = ();
            type Panel = Panel<Self>;
            type Sum = Self;

            #[inline(always)]
            fn prepared(_: Self, _: Self) {}

            #[inline]
            fn from_f64(value: f64) -> Self {
                value as Self
            }
            #[inline]
            fn from_int(value: i32) -> Self {
                value as Self
            }
            #[inline]
            fn to_f64(self) -> f64 {
                self as f64
            }
            #[inline]
            fn times(self, factor: i32) -> Self {
                self * factor as Self
            }
            #[inline]
            fn double(self, shift: u32) -> Self {
                self * (1_u32 << shift) as Self
            }
            #[inline]
            fn halve(self, shift: u32) -> Self {
                self * (1.0 / (1_u32 << shift) as Self)
            }
            #[inline]
            fn rate(self, halves: u32, shift: u32) -> Self {
                self * ((halves << shift) as Self * 0.5)
            }
            #[inline]
            fn product(self, other: Self) -> Self {
                self * other
            }
            #[inline]
            fn narrow(product: Self) -> Self {
                product
            }
            #[inline]
            fn root(squares: Self) -> Self {
                $sqrt(squares)
            }
            #[inline]
            fn recip(self) -> Self {
                1.0 / self
            }
            #[inline]
            fn divide(self, divisor: Self) -> Self {
                self / divisor
            }
            #[inline]
            fn elongation(squares: Self, rest: &Rest<Self>) -> Self {
                // The lower bound keeps coincident particles finite; it is far below any length that rounding leaves.
                1.0 - rest.length / $sqrt(Scalar::max(squares, $tiny))
            }
            #[inline]
            fn round_times(self, factor: i32) -> i32 {
                $floor(self * factor as Self + 0.5) as i32
            }
            #[inline]
            fn coarse(self) -> i32 {
                (self * 256.0) as i32
            }
            #[inline]
            fn direction([x, y, z]: [Self; 3], rest: &Rest<Self>) -> (Self, [Self; 3]) {
                let length = $sqrt(Scalar::max(x * x + y * y + z * z, $tiny));
                let inverse = 1.0 / length;
                (length - rest.length, [x * inverse, y * inverse, z * inverse])
            }
            #[inline]
            fn panel(pressure: Self, area: Self) -> Panel<Self> {
                Panel::new(pressure, area)
            }
            #[inline(always)]
            fn press(
                diagonals: [[Self; 3]; 2],
                air: [Self; 3],
                panel: &Panel<Self>,
                most: impl FnOnce() -> Self,
            ) -> Option<[Self; 3]> {
                Some(panel.press(diagonals, air, most(), $tiny))
            }
            #[inline]
            fn press_any(diagonals: [[Self; 3]; 2], air: [Self; 3], panel: &Panel<Self>, most: Self) -> [Self; 3] {
                panel.press(diagonals, air, most, $tiny)
            }
            #[inline]
            fn accumulate(sum: Self, product: Self) -> Self {
                sum + product
            }
            #[inline]
            fn quotient(dividend: Self, divisor: Self) -> Self {
                dividend / divisor
            }
            #[inline]
            fn root_mean(sum: Self, count: u32) -> Self {
                $sqrt(sum / count as Self)
            }
            #[inline]
            fn bits(self, hash: impl FnMut(u8)) {
                self.canonical_bits().to_le_bytes().into_iter().for_each(hash);
            }
            #[inline]
            fn word(self) -> u32 {
                let bits = u64::from(self.canonical_bits());
                (bits ^ bits >> 32) as u32
            }
            #[inline]
            fn is_finite(self) -> bool {
                <$float>::is_finite(self)
            }
            #[inline]
            fn abs(self) -> Self {
                <$float>::abs(self)
            }
        }
    };
}

float!(f32, u32, "f32", root::f32, libm::floorf, 1e-20);
float!(f64, u64, "f64", root::f64, libm::floor, 1e-60);
