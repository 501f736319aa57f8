//! One Gauss–Seidel sweep over springs, each projected implicitly: `Δx = ∓w·κ/(1 + κ·Σw)·(|d| − L)·d/|d|`.
//!
//! With κ = k·h²/m this is the step of XPBD from a multiplier of zero (M. Macklin, M. Müller, N. Chentanez, *XPBD: position-based
//! simulation of compliant constrained dynamics*, 2016, equation 18 with α̃ = 1/κ).

use crate::cloth::Cloth;
use crate::link::{Family, Links, Visitor, each};
use crate::moment::Moment;
use crate::scalar::Scalar;

/// Projects every spring once, at one part in `parts` of its stiffness.
#[inline]
pub(super) fn sweep<S: Scalar, L: Links<S>, const W: usize, const H: usize>(
    links: &L,
    cloth: &mut Cloth<S, W, H>,
    moment: Moment,
    parts: u32,
) {
    links.springs(&mut Project { cloth, moment, parts });
}

struct Project<'a, S, const W: usize, const H: usize> {
    cloth: &'a mut Cloth<S, W, H>,
    moment: Moment,
    parts: u32,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Project<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let strength = if self.parts == 1 {
            family.strength
        } else {
            family.strength.scaled(S::from_int(self.parts as i32).recip())
        };
        // nearly all links join two ordinary particles: their quotient is formed once, and their masses need no product
        let ordinary = strength.against(S::ONE + S::ONE);
        each::<ACROSS, DOWN, W, H>(|a, b| {
            let [wa, wb] = [self.cloth.inverse_mass[a], self.cloth.inverse_mass[b]];
            let d = self.cloth.position.at(b) - self.cloth.position.at(a);
            let elongation = S::elongation(d.squared(), &family.rest);
            if wa == S::ONE && wb == S::ONE {
                let by = d * (elongation * ordinary);
                self.cloth.displace(a, by, self.moment);
                self.cloth.displace(b, -by, self.moment);
            } else if wa + wb != S::ZERO {
                self.cloth.pull(a, b, d * (elongation * strength.against(wa + wb)), self.moment);
            }
        });
    }
}
