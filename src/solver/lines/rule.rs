//! The rule in time for the links of a substep.
//!
//! From the predicted x̂ and v̂, links lead to `x' = x̂ + part·h·(v' − v̂)` and `v' = v̂ + part·h/(1 + part·γ·h)·a'`, since drag γ is implicit. Part = 1 is backward Euler,
//! part = ⅔ the second-order rule (see the [module](super)). In the first substep, which has no history, links follow backward Euler.

use crate::moment::Moment;
use crate::scalar::Scalar;

use super::History;

/// The coefficients of a rule in a part of a substep.
pub(super) struct TimeRule<S> {
    /// The moment of the part of a substep; it relates displacements to velocity changes.
    pub(super) moment: Moment,
    /// x' depends on v' by part·h.
    pub(super) part: S,
    /// v' depends on a' by response·h, with the h of the whole substep.
    pub(super) response: S,
    /// The factor of κ = k·h²/m, with the h of the whole substep.
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

    /// The share of the velocity change by springs in this substep that is assumed for the next one. In backward Euler, springs act for a whole substep, in the other rule for two
    /// thirds.
    #[inline(always)]
    pub(super) fn share(&self) -> S {
        if self.part == S::ONE { S::from_f64(2.0 / 3.0) } else { S::ONE }
    }
}
