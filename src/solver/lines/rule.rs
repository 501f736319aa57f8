//! The rule in time, as the links of a substep see it.
//!
//! From where a substep is predicted to end, links move particles on by `x' = x̂ + part·h·(v' − v̂)` and `v' = v̂ + part·h/(1 + part·γ·h)·a'`, since drag γ is implicit: backward Euler with
//! part = 1, the second-order rule with part = ⅔ (see the [module](super)). In the first substep, whose history is missing, links follow backward Euler.

use crate::moment::Moment;
use crate::scalar::Scalar;

use super::History;

/// The coefficients of a rule in a part of a substep.
pub(super) struct TimeRule<S> {
    /// The part of a substep, which knows by how much velocities follow places.
    pub(super) moment: Moment,
    /// x' depends on v' by part·h.
    pub(super) part: S,
    /// v' depends on a' by response·h, with the h of the whole substep.
    pub(super) response: S,
    /// By which κ = k·h²/m of the whole substep is multiplied.
    pub(super) stiffness: S,
}

impl<S: Scalar> TimeRule<S> {
    /// The rule for a part of a substep that is halved `split` times, under a drag of `rate` = γ·h in the whole substep.
    #[inline(always)]
    pub(super) fn new(history: History, rate: S, moment: Moment, split: u32) -> Self {
        let (moment, part) = match history {
            History::None | History::Rough => (moment, S::ONE),
            History::Velocity => (Moment { halves: 3, ..moment }, S::from_int(2).divide(S::from_int(3))),
        };
        let response = part.divide(S::ONE + part * rate.halve(split));
        let stiffness = (part * response).halve(2 * split);
        Self { moment, part, response: response.halve(split), stiffness }
    }

    /// The part of what springs did in this substep that they will do in the next one: those of backward Euler pull for a whole substep, the others for two thirds.
    #[inline(always)]
    pub(super) fn share(&self) -> S {
        if self.part == S::ONE { S::from_f64(2.0 / 3.0) } else { S::ONE }
    }
}
