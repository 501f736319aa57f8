//! A number type that counts its operations.

use core::cell::Cell;
use core::cmp::Ordering;
use core::ops::{Add, AddAssign, Mul, Neg, Sub, SubAssign};

use crate::scalar::panel::Panel;
use crate::scalar::{Rest, Scalar};

/// `f32` to the last bit, but every operation is counted: the cost of a solver on any machine.
///
/// The counts belong to the thread. Changes of sign and conversions are not counted. A number that a [fingerprint](crate::fingerprint) reads counts as one
/// comparison, with its former value.
///
/// ```
/// use kerchief::host::Counted;
/// use kerchief::{Scalar, Vec3};
///
/// let edge = Vec3::<Counted>::from_f64([2.0, 3.0, 6.0]);
/// Counted::reset();
/// assert_eq!(edge.length().to_f64(), 7.0);
/// let operations = Counted::operations();
/// assert_eq!((operations.products, operations.additions, operations.roots), (3, 2, 1));
/// assert_eq!(operations.total(), 6);
/// ```
#[derive(Clone, Copy, Debug, Default)]
pub struct Counted(f32);

/// Numbers of operations.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Operations {
    /// Sums and differences.
    pub additions: u64,
    /// Products, including those with powers of two.
    pub products: u64,
    /// Quotients and reciprocals.
    pub quotients: u64,
    /// Square roots.
    pub roots: u64,
    /// Comparisons of two numbers, or of a number with its former value.
    pub comparisons: u64,
}

impl Operations {
    const NONE: Self = Self { additions: 0, products: 0, quotients: 0, roots: 0, comparisons: 0 };
    const ADDITION: Self = Self { additions: 1, ..Self::NONE };
    const PRODUCT: Self = Self { products: 1, ..Self::NONE };
    const QUOTIENT: Self = Self { quotients: 1, ..Self::NONE };
    const ROOT: Self = Self { roots: 1, ..Self::NONE };
    const COMPARISON: Self = Self { comparisons: 1, ..Self::NONE };

    /// The sum of all kinds.
    pub const fn total(self) -> u64 {
        self.additions + self.products + self.quotients + self.roots + self.comparisons
    }

    /// The sum of both, kind by kind.
    #[must_use]
    pub const fn and(self, other: Self) -> Self {
        Self {
            additions: self.additions + other.additions,
            products: self.products + other.products,
            quotients: self.quotients + other.quotients,
            roots: self.roots + other.roots,
            comparisons: self.comparisons + other.comparisons,
        }
    }
}

std::thread_local! {
    static DONE: Cell<Operations> = const { Cell::new(Operations::NONE) };
}

impl Counted {
    /// Sets this thread's counts to zero.
    pub fn reset() {
        DONE.set(Operations::NONE);
    }

    /// The operations of this thread since the last [`reset`](Self::reset).
    pub fn operations() -> Operations {
        DONE.get()
    }

    #[inline]
    fn did(operations: Operations) {
        DONE.set(DONE.get().and(operations));
    }
}

impl PartialEq for Counted {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        Self::did(Operations::COMPARISON);
        self.0 == other.0
    }
}

impl PartialOrd for Counted {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Self::did(Operations::COMPARISON);
        self.0.partial_cmp(&other.0)
    }
}

macro_rules! operator {
    ($($name:ident $call:ident $operation:ident),*) => {$(
        impl $name for Counted {
            type Output = Self;
            #[inline]
            fn $call(self, other: Self) -> Self {
                Self::did(Operations::$operation);
                Self(self.0.$call(other.0))
            }
        }
    )*};
}
operator!(Add add ADDITION, Sub sub ADDITION, Mul mul PRODUCT);

impl Neg for Counted {
    type Output = Self;
    #[inline]
    fn neg(self) -> Self {
        Self(-self.0)
    }
}

impl AddAssign for Counted {
    #[inline]
    fn add_assign(&mut self, other: Self) {
        *self = *self + other;
    }
}

impl SubAssign for Counted {
    #[inline]
    fn sub_assign(&mut self, other: Self) {
        *self = *self - other;
    }
}

/// The further operations of [`Scalar::direction`]: a squared length, and a vector times a number.
const DIRECTION: Operations = Operations { additions: 2, products: 6, ..Operations::NONE };

/// The operations of `f32` in both [`Scalar::elongation`] and [`Scalar::direction`]: a floor, a root, a quotient and a difference.
const GAUGE: Operations = Operations { additions: 1, quotients: 1, roots: 1, comparisons: 1, ..Operations::NONE };

fn plain(rest: Rest<Counted>) -> Rest<f32> {
    Rest {
        length: rest.length.0,
        square: rest.square.0,
        inverse: rest.inverse.0,
        inverse_square: rest.inverse_square.0,
        prepared: (),
    }
}

impl Scalar for Counted {
    const NAME: &'static str = "counted f32";
    const ZERO: Self = Self(f32::ZERO);
    const ONE: Self = Self(f32::ONE);
    const HALF: Self = Self(f32::HALF);
    const LARGEST: f64 = f32::LARGEST;
    const RESOLUTION: f64 = f32::RESOLUTION;
    const EDGE: f64 = f32::EDGE;
    const STRAY: f64 = f32::STRAY;
    const EMPTY: Self = Self(f32::EMPTY);
    const INFINITE_DIVISOR: Self = Self(f32::INFINITE_DIVISOR);

    type Product = Self;
    type Prepared = ();
    type Panel = Panel<Self>;
    type Sum = Self;

    #[inline]
    fn prepared(_: Self, _: Self) {}

    fn from_f64(value: f64) -> Self {
        Self(f32::from_f64(value))
    }
    #[inline]
    fn from_int(value: i32) -> Self {
        Self(f32::from_int(value))
    }
    #[inline]
    fn to_f64(self) -> f64 {
        self.0.to_f64()
    }
    #[inline]
    fn times(self, factor: i32) -> Self {
        Self::did(Operations::PRODUCT);
        Self(self.0.times(factor))
    }
    #[inline]
    fn double(self, shift: u32) -> Self {
        Self::did(Operations::PRODUCT);
        Self(self.0.double(shift))
    }
    #[inline]
    fn halve(self, shift: u32) -> Self {
        Self::did(Operations::PRODUCT);
        Self(self.0.halve(shift))
    }
    #[inline]
    fn rate(self, halves: u32, shift: u32) -> Self {
        Self::did(Operations::PRODUCT);
        Self(self.0.rate(halves, shift))
    }
    #[inline]
    fn product(self, other: Self) -> Self {
        Self::did(Operations::PRODUCT);
        Self(self.0.product(other.0))
    }
    #[inline]
    fn narrow(product: Self) -> Self {
        Self(f32::narrow(product.0))
    }
    #[inline]
    fn root(squares: Self) -> Self {
        Self::did(Operations::ROOT);
        Self(f32::root(squares.0))
    }
    #[inline]
    fn recip(self) -> Self {
        Self::did(Operations::QUOTIENT);
        Self(Scalar::recip(self.0))
    }
    #[inline]
    fn divide(self, divisor: Self) -> Self {
        Self::did(Operations::QUOTIENT);
        Self(self.0.divide(divisor.0))
    }
    #[inline]
    fn elongation(squares: Self, rest: &Rest<Self>) -> Self {
        Self::did(GAUGE);
        Self(f32::elongation(squares.0, &plain(*rest)))
    }
    #[inline]
    fn round_times(self, factor: i32) -> i32 {
        Self::did(Operations::PRODUCT.and(Operations::ADDITION));
        self.0.round_times(factor)
    }
    #[inline]
    fn coarse(self) -> i32 {
        Self::did(Operations::PRODUCT);
        self.0.coarse()
    }
    #[inline]
    fn direction(d: [Self; 3], rest: &Rest<Self>) -> (Self, [Self; 3]) {
        Self::did(GAUGE.and(DIRECTION));
        let (longer, along) = f32::direction(d.map(|component| component.0), &plain(*rest));
        (Self(longer), along.map(Self))
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
        Some(panel.press(diagonals, air, most(), Self(1e-20)))
    }
    #[inline]
    fn press_any(diagonals: [[Self; 3]; 2], air: [Self; 3], panel: &Panel<Self>, most: Self) -> [Self; 3] {
        panel.press(diagonals, air, most, Self(1e-20))
    }
    #[inline]
    fn accumulate(sum: Self, product: Self) -> Self {
        Self::did(Operations::ADDITION);
        Self(f32::accumulate(sum.0, product.0))
    }
    #[inline]
    fn quotient(dividend: Self, divisor: Self) -> Self {
        Self::did(Operations::QUOTIENT);
        Self(f32::quotient(dividend.0, divisor.0))
    }
    #[inline]
    fn root_mean(sum: Self, count: u32) -> Self {
        Self::did(Operations::QUOTIENT.and(Operations::ROOT));
        Self(f32::root_mean(sum.0, count))
    }
    #[inline]
    fn bits(self, hash: impl FnMut(u8)) {
        self.0.bits(hash);
    }
    #[inline]
    fn word(self) -> u32 {
        Self::did(Operations::COMPARISON);
        self.0.word()
    }
    #[inline]
    fn is_finite(self) -> bool {
        Scalar::is_finite(self.0)
    }
    #[inline]
    fn abs(self) -> Self {
        Self(Scalar::abs(self.0))
    }
    #[inline]
    fn max(self, other: Self) -> Self {
        Self::did(Operations::COMPARISON);
        Self(Scalar::max(self.0, other.0))
    }
    #[inline]
    fn min(self, other: Self) -> Self {
        Self::did(Operations::COMPARISON);
        Self(Scalar::min(self.0, other.0))
    }
}

#[cfg(test)]
mod tests {
    use std::format;

    use super::*;
    use crate::fingerprint::Fingerprint;
    use crate::host::{Description, Everything, SolverKind};

    /// All link families and forces of a scene, a ball, a hem and a strain limit.
    const SCENE: &str = "
        [cloth]
        columns = 4
        rows = 4
        width = 1.0
        height = 1.0
        density = 0.2
        hem = 1.5
        pins = [[0, 0], [3, 0]]
        [stretch]
        stiffness = 100.0
        damping = 0.01
        [shear]
        stiffness = 10.0
        [bend]
        stiffness = 1.0
        [environment]
        gravity = [0.0, 0.0, -9.81]
        drag = 0.3
        WIND
        [[sphere]]
        centre = [0.5, 0.5, -0.4]
        radius = 0.3
        friction = 0.2
        [solver]
        step = 0.02
        substeps = 4
        strain_limit = 0.05
    ";

    #[test]
    fn counting_changes_no_bit() {
        for model in ["facet", "aerodynamic", "panel"] {
            let wind = format!("wind = {{ velocity = [1.0, 3.0, 0.5], model = \"{model}\" }}");
            let mut scene = Description::parse(&SCENE.replace("WIND", &wind)).unwrap();
            for kind in SolverKind::ALL {
                scene.solver.kind = kind;
                let mut plain = scene.simulation_on::<Everything, f32, 4, 4>().unwrap();
                let mut counted = scene.simulation_on::<Everything, Counted, 4, 4>().unwrap();
                for _ in 0..25 {
                    plain.frame();
                    counted.frame();
                }
                assert_eq!(plain.digest(), counted.digest(), "{kind:?} {model}");
                assert_eq!(plain.strains(), counted.strains(), "{kind:?} {model}");
                assert_eq!(plain.energy(), counted.energy(), "{kind:?} {model}");
            }
        }
    }

    fn counts<T>(work: impl Fn() -> T) -> [u64; 5] {
        Counted::reset();
        work();
        let Operations { additions, products, quotients, roots, comparisons } = Counted::operations();
        [additions, products, quotients, roots, comparisons]
    }

    #[test]
    fn every_kind_is_counted() {
        let numbers = [0.25, -3.0, 7.5].map(Counted::from_f64);
        let [a, b, c] = numbers;
        let rest = Rest::spanning(a, c);
        assert_eq!(counts(|| a + b - c), [2, 0, 0, 0, 0]);
        assert_eq!(counts(|| -(a * b).product(c)), [0, 2, 0, 0, 0]);
        assert_eq!(counts(|| a.times(3).double(2).halve(1).rate(3, 1)), [0, 4, 0, 0, 0]);
        assert_eq!(counts(|| a.recip().divide(b)), [0, 0, 2, 0, 0]);
        assert_eq!(counts(|| Counted::root(a)), [0, 0, 0, 1, 0]);
        assert_eq!(counts(|| Counted::elongation(a, &rest)), [1, 0, 1, 1, 1]);
        assert_eq!(counts(|| Counted::direction([a, b, c], &rest)), [3, 6, 1, 1, 1]);
        assert_eq!(counts(|| Counted::root_mean(Counted::accumulate(a, b), 4)), [1, 0, 1, 1, 0]);
        assert_eq!(counts(|| a.max(b).min(c) == c || a < b), [0, 0, 0, 0, 4]);
        assert_eq!(counts(|| Fingerprint::new().numbers(numbers)), [0, 0, 0, 0, 3]);
        assert_eq!(counts(|| (a.abs(), -b, Counted::narrow(c), c.to_f64())), [0; 5]);
    }
}
