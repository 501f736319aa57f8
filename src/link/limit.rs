//! The limit on the deformation rate (X. Provot, *Deformation constraints in a mass-spring model to describe rigid cloth behavior*, 1995). After a step no link
//! is longer than `1 + limit` times its rest length, at pins too. Only links whose particles a collider moves afterwards may be longer: contacts come last.

use core::cmp::Ordering;

use crate::fingerprint::Fingerprint;
use crate::link::{Family, Links, OneByOne, Order, Visitor, one_by_one};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::scalar::fit::is_positive;

/// Limit on the sweeps over overlong links in a step. Sweeps end as soon as no link is overlong. One sweep is usual; a few hundred occur where a solver leaves
/// a sheet of 32 × 32 stretched to several times its size.
const MOST_SWEEPS: u32 = 1000;

/// Links of which none is longer than `1 + limit` times its rest length after a step (thesis, section 5.4.2).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StrainLimited<L, S> {
    links: L,
    /// The allowed stretch, 1 + limit.
    allowed: S,
}

impl<L, S: Scalar> StrainLimited<L, S> {
    /// `links` with a maximum strain of `limit` (no unit, positive; in fixed point below 63).
    ///
    /// # Panics
    /// For any other limit.
    #[track_caller]
    pub fn new(links: L, limit: f64) -> Self {
        assert!(is_positive(limit), "a strain limit is positive and finite");
        let limit = S::from_f64(limit);
        assert!(limit > S::ZERO && limit.is_finite(), "a strain limit is positive and finite");
        assert!(limit.is_within(S::from_f64(63.0 - 1e-6)), "fixed point represents strain limits below 63");
        Self { links, allowed: S::ONE + limit }
    }
}

impl<S: Scalar, L: Links<S>> Links<S> for StrainLimited<L, S> {
    type Directions = L::Directions;
    type Damping = L::Damping;

    #[inline]
    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        self.links.springs(visitor);
    }

    #[inline]
    fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
        self.links.dampers(visitor);
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        self.links.fingerprint(print);
        print.number(self.allowed);
    }

    fn confine<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, moment: Moment) {
        self.links.confine(particles, moment);
        for _ in 0..MOST_SWEEPS {
            let mut sweep = Shorten { particles, moment, allowed: self.allowed, found: false };
            self.links.springs(&mut sweep);
            if !sweep.found {
                break;
            }
        }
    }
}

struct Shorten<'a, S, const W: usize, const H: usize> {
    particles: &'a mut Particles<S, W, H>,
    moment: Moment,
    allowed: S,
    found: bool,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Shorten<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Shorten<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let longest = family.rest.length * self.allowed;
        // slightly shorter than allowed, so that sweeps end
        let target = longest - longest.halve(10);
        let square = longest.product(longest);
        order.each::<W, H>(|a, b| {
            let d = self.particles.position.at(b) - self.particles.position.at(a);
            let squared = d.squared();
            // an undefined length is not greater than any number
            if squared.partial_cmp(&square) != Some(Ordering::Greater) {
                return;
            }
            let [wa, wb] = [a, b].map(|node| self.particles.inverse_mass[node]);
            if wa + wb == S::ZERO {
                return;
            }
            self.found = true;
            let part = S::ONE - target.divide(S::root(squared));
            // the product of two fractions: divided by the inverse masses of heavy particles, the part would leave the range of fixed point
            let share = wa.divide(wa + wb);
            self.particles.displace(a, d * (part * share), self.moment);
            self.particles.displace(b, -(d * (part * (S::ONE - share))), self.moment);
        });
    }
}
