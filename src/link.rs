//! Links between particles: stretch, shear and bend springs, their dampers, tethers, the strain limit.
//!
//! A family of links is a pattern of grid offsets. Its links are enumerated, never stored. `()` is no link; a tuple combines its members. A family of your own
//! implements [`Links`].

mod count;
mod limit;
mod order;
mod spring;
mod tether;

use crate::fingerprint::Fingerprint;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Rest, Scalar};
use crate::units::Strength;

pub use count::{Blank, Count, Damping, Directions, Undamped, WithDampers};
pub use limit::StrainLimited;
pub use order::each;
pub(crate) use order::{OneByOne, Order, each_row, fits, in_row, one_by_one};
pub use spring::{Bend, Damped, Shear, Stretch};
pub use tether::Tether;

/// A family of links, or none, or several.
pub trait Links<S: Scalar> {
    /// The number of directions of springs that [`springs`](Self::springs) shows at most: `Directions<2>` for rows and columns. Solvers reserve memory for as
    /// many, and skip sweeps if there are none.
    type Directions: Count;

    /// Whether [`dampers`](Self::dampers) may show any: [`WithDampers`] or [`Undamped`].
    type Damping: Damping;

    /// Shows `visitor` every family of springs, in the order in which solvers relax them.
    #[inline]
    fn springs<V: Visitor<S>>(&self, _visitor: &mut V) {}

    /// Shows `visitor` every damped family, with the strength of its dampers.
    #[inline]
    fn dampers<V: Visitor<S>>(&self, _visitor: &mut V) {}

    /// Moves particles, after the springs, until the inequality constraints of the links are satisfied.
    #[inline]
    fn confine<const W: usize, const H: usize>(&self, _particles: &mut Particles<S, W, H>, _moment: Moment) {}

    /// Adds all data that the links depend on, so that a sheet at rest wakes when they change: see [`rest`](crate::rest). Links with the default method keep
    /// sheets awake.
    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.unknown();
    }
}

/// Sees families of links one by one.
pub trait Visitor<S: Scalar> {
    /// The links between particles that are `ACROSS` columns and `DOWN` rows apart; if neither is zero, along both diagonals.
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>);
}

/// The common properties of a family's links.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Family<S: Scalar> {
    /// Stiffness or damping.
    pub strength: Quotient<S>,
    /// The length of a link at rest.
    pub rest: Rest<S>,
}

/// A [`Strength`] κ in the cloth's numbers, `κ = dividend/divisor`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quotient<S> {
    /// min(κ, 1)
    pub dividend: S,
    /// min(1/κ, 1)
    pub divisor: S,
}

impl<S: Scalar> Quotient<S> {
    /// The nearest quotient.
    ///
    /// # Panics
    /// If the strength doesn't [fit](Strength::fits) the number type.
    #[track_caller]
    #[inline]
    pub fn new(strength: Strength) -> Self {
        let strength = strength.fits::<S>();
        Self { dividend: S::from_f64(strength.dividend), divisor: S::from_f64(strength.divisor) }
    }

    /// κ
    #[inline]
    pub fn value(self) -> S {
        self.dividend.divide(self.divisor)
    }

    /// κ/(1 + κ·w): the implicit effect of a spring between particles with inverse masses of sum w.
    #[inline]
    pub fn against(self, inverse_mass: S) -> S {
        self.dividend.divide(self.divisor + self.dividend * inverse_mass)
    }

    /// `x · dividend`, exact to the last place, because the dividend of a soft link is small. A stiff link has the dividend 1.
    #[inline(always)]
    pub(crate) fn times_dividend(self, x: S) -> S {
        if S::LOOKING_PAYS && self.dividend == S::ONE { x } else { x * self.dividend }
    }

    /// `x · divisor`, exact to the last place, because the divisor of a stiff link is small. A soft link has the divisor 1, and multipliers start from zero.
    #[inline(always)]
    pub(crate) fn times_divisor(self, x: S) -> S {
        if S::LOOKING_PAYS && (x == S::ZERO || self.divisor == S::ONE) { x } else { x * self.divisor }
    }

    /// `x · dividend` for `|x| ≤ 1`, with the accuracy of [`Scalar::scaled`]. A stiff link has the dividend 1.
    #[inline(always)]
    pub(crate) fn of_dividend(self, x: S) -> S {
        if S::LOOKING_PAYS && self.dividend == S::ONE { x } else { x.scaled(self.dividend) }
    }

    /// Adds the quotient to a fingerprint.
    pub(crate) fn fingerprint(self, print: &mut Fingerprint) {
        print.numbers([self.dividend, self.divisor]);
    }

    /// The sum of both quotients.
    pub(crate) fn plus(self, other: Self) -> Self {
        let both = |a: Self, b: Self| {
            // the weaker strength divided by the stronger one, to the last place
            let ratio = if a.dividend == S::ONE && b.dividend == S::ONE {
                a.divisor.divide(b.divisor)
            } else if a.dividend == S::ONE {
                b.dividend * a.divisor
            } else if a.dividend == S::ZERO {
                return b;
            } else {
                b.dividend.divide(a.dividend)
            };
            let times = S::ONE + ratio;
            let [dividend, divisor] = [a.dividend, a.divisor];
            if dividend * times > divisor {
                Self { dividend: S::ONE, divisor: divisor.divide(dividend).divide(times) }
            } else {
                Self { dividend: dividend.divide(divisor) * times, divisor: S::ONE }
            }
        };
        if self.divisor < other.divisor || self.dividend > other.dividend {
            both(self, other)
        } else {
            both(other, self)
        }
    }

    /// κ times a factor up to 1. The larger of dividend and divisor is 1 again.
    #[must_use]
    pub fn scaled(self, factor: S) -> Self {
        let [dividend, divisor] = [self.dividend * factor, self.divisor];
        if dividend > divisor {
            Self { dividend: S::ONE, divisor: divisor.divide(dividend) }
        } else {
            Self { dividend: dividend.divide(divisor), divisor: S::ONE }
        }
    }
}

/// The number of directions of the links between particles `ACROSS` columns and `DOWN` rows apart.
pub(crate) const fn directions<const ACROSS: usize, const DOWN: usize>() -> usize {
    if ACROSS > 0 && DOWN > 0 { 2 } else { 1 }
}

/// Rejects links that show more directions or dampers than their types declare.
#[track_caller]
pub(crate) fn check<S: Scalar, L: Links<S>>(links: &L) {
    let (mut springs, mut dampers) = (Shown(0), Shown(0));
    links.springs(&mut springs);
    links.dampers(&mut dampers);
    assert!(
        springs.0 <= L::Directions::NUMBER,
        "links show more directions than `Directions` says; a scene has 24 at most"
    );
    assert!(dampers.0 == 0 || L::Damping::ANY, "links show dampers, and `Damping` says `Undamped`");
}

/// The number of directions of all families shown.
struct Shown(usize);

impl<S: Scalar> Visitor<S> for Shown {
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, _family: &Family<S>) {
        self.0 += directions::<ACROSS, DOWN>();
    }
}

impl<S: Scalar> Links<S> for () {
    type Directions = Directions<0>;
    type Damping = Undamped;

    #[inline]
    fn fingerprint(&self, _print: &mut Fingerprint) {}
}

/// Optional links, chosen at run time.
impl<S: Scalar, T: Links<S>> Links<S> for Option<T> {
    type Directions = T::Directions;
    type Damping = T::Damping;

    #[inline]
    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        if let Some(links) = self {
            links.springs(visitor);
        }
    }

    #[inline]
    fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
        if let Some(links) = self {
            links.dampers(visitor);
        }
    }

    #[inline]
    fn confine<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, moment: Moment) {
        if let Some(links) = self {
            links.confine(particles, moment);
        }
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.word(u32::from(self.is_some()));
        if let Some(links) = self {
            links.fingerprint(print);
        }
    }
}

macro_rules! sum {
    ($name:ident) => { $name::Directions };
    ($name:ident, $($others:ident),+) => { <$name::Directions as Count>::Plus<sum!($($others),+)> };
}

macro_rules! any {
    ($name:ident) => { $name::Damping };
    ($name:ident, $($others:ident),+) => { <$name::Damping as Damping>::Or<any!($($others),+)> };
}

macro_rules! tuple {
    ($($name:ident),+) => {
        impl<S: Scalar, $($name: Links<S>),+> Links<S> for ($($name,)+) {
            type Directions = sum!($($name),+);
            type Damping = any!($($name),+);

            #[inline]
            fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.springs(visitor);)+
            }

            #[inline]
            fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.dampers(visitor);)+
            }

            #[inline]
            fn fingerprint(&self, print: &mut Fingerprint) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.fingerprint(print);)+
            }

            #[inline]
            fn confine<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, moment: Moment) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.confine(particles, moment);)+
            }
        }
    };
}

tuple!(A);
tuple!(A, B);
tuple!(A, B, C);
tuple!(A, B, C, D);
tuple!(A, B, C, D, E);

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Q24;

    #[test]
    fn quotients_of_any_two_strengths_are_added() {
        fn check<S: Scalar>(error: f64) {
            let quotient = |kappa: f64| Quotient::<S> {
                dividend: S::from_f64(kappa.min(1.0)),
                divisor: S::from_f64(if kappa > 0.0 { (1.0 / kappa).min(1.0) } else { 1.0 }),
            };
            for a in [0.0, 0.01, 0.6, 1.0, 3.0, 50.0] {
                for b in [0.0, 0.02, 0.6, 1.0, 7.0, 64.0] {
                    let Quotient { dividend, divisor } = quotient(a).plus(quotient(b));
                    let [dividend, divisor] = [dividend, divisor].map(S::to_f64);
                    assert!(dividend.max(divisor) == 1.0, "{a} + {b} in {}: {dividend}/{divisor}", S::NAME);
                    let sum = dividend / divisor;
                    assert!((sum - (a + b)).abs() <= error * (a + b), "{a} + {b} in {}: {sum}", S::NAME);
                }
            }
        }
        check::<f64>(1e-15);
        check::<f32>(5e-7);
        check::<Q24>(2e-5);
    }
}
