//! Springs between neighbours: Hooke's law `f = −k·(|d| − L)·d/|d|`, with the initial distance as the rest length L.

use crate::fingerprint::Fingerprint;
use crate::link::{Directions, Family, Links, Quotient, Undamped, Visitor, WithDampers};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Rest, Scalar};
use crate::units::{Strength, Units};

macro_rules! springs {
    ($(#[$doc:meta])* $name:ident, $($index:literal: $across:literal, $down:literal);+) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        pub struct $name<S: Scalar> {
            strength: Quotient<S>,
            rest: [Rest<S>; [$($across),+].len()],
        }

        impl<S: Scalar> $name<S> {
            /// Springs of this strength in a sheet of these units.
            ///
            /// # Panics
            /// If the strength doesn't [fit](Strength::fits) the number type.
            #[track_caller]
            #[inline]
            pub fn new(units: &Units, strength: Strength) -> Self {
                let [across, down] = units.sides.map(S::from_f64);
                let rest = [$(Rest::spanning(across.times($across), down.times($down))),+];
                Self { strength: Quotient::new(strength), rest }
            }
        }

        impl<S: Scalar> Links<S> for $name<S> {
            // one direction along rows and one along columns, or one along each diagonal
            type Directions = Directions<2>;
            type Damping = Undamped;

            #[inline]
            fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
                $(visitor.family::<$across, $down>(&Family { strength: self.strength, rest: self.rest[$index] });)+
            }

            fn fingerprint(&self, print: &mut Fingerprint) {
                self.strength.fingerprint(print);
                self.rest.iter().for_each(|rest| print.number(rest.length));
            }
        }
    };
}

springs!(
    /// Springs along rows and columns, between neighbours (thesis, figure 4.1 and listing 5.1; their force is that of equations 4.1–4.3).
    Stretch, 0: 1, 0; 1: 0, 1
);
springs!(
    /// Springs along the diagonals of the cells (thesis, figure 4.1 and listing 5.1).
    Shear, 0: 1, 1
);
springs!(
    /// Springs along rows and columns, between a particle and the next but one (thesis, figure 4.1 and listing 5.1).
    Bend, 0: 2, 0; 1: 0, 2
);

/// Links with dampers parallel to their springs: `f = −k_d·(v_i − v_j)` (thesis, equation 4.4).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Damped<L, S> {
    links: L,
    damping: Quotient<S>,
}

impl<L, S: Scalar> Damped<L, S> {
    /// `links` with a damper of this strength parallel to each spring.
    ///
    /// # Panics
    /// If the strength doesn't [fit](Strength::fits) the number type.
    #[track_caller]
    #[inline]
    pub fn new(links: L, damping: Strength) -> Self {
        Self { links, damping: Quotient::new(damping) }
    }
}

impl<S: Scalar, L: Links<S>> Links<S> for Damped<L, S> {
    type Directions = L::Directions;
    type Damping = WithDampers;

    #[inline]
    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        self.links.springs(visitor);
    }

    #[inline]
    fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
        // a scene built at run time may have a damping of zero
        if self.damping.dividend != S::ZERO {
            self.links.springs(&mut WithStrength { visitor, strength: self.damping });
        }
    }

    #[inline]
    fn confine<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, moment: Moment) {
        self.links.confine(particles, moment);
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        self.links.fingerprint(print);
        self.damping.fingerprint(print);
    }
}

/// Forwards families with another strength.
struct WithStrength<'a, V, S> {
    visitor: &'a mut V,
    strength: Quotient<S>,
}

impl<S: Scalar, V: Visitor<S>> Visitor<S> for WithStrength<'_, V, S> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        self.visitor.family::<ACROSS, DOWN>(&Family { strength: self.strength, ..*family });
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::units::Units;

    /// The number of families visited.
    struct Count(usize);

    impl<S: Scalar> Visitor<S> for Count {
        fn family<const ACROSS: usize, const DOWN: usize>(&mut self, _: &Family<S>) {
            self.0 += 1;
        }
    }

    #[test]
    fn dampers_of_no_strength_are_passed_over() {
        let units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 1.0 / 60.0, 4);
        for (damping, expected) in [(0.0, 0), (0.01, 2)] {
            let links = Damped::<_, f32>::new(Stretch::new(&units, units.stiffness(50.0)), units.damping(damping));
            let (mut springs, mut dampers) = (Count(0), Count(0));
            links.springs(&mut springs);
            links.dampers(&mut dampers);
            assert_eq!((springs.0, dampers.0), (2, expected), "{damping} N·s/m");
        }
    }
}
