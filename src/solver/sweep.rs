//! One Gauss–Seidel sweep over springs, each projected implicitly: `Δx = ∓w·κ/(1 + κ·Σw)·(|d| − L)·d/|d|`.
//!
//! With κ = k·h²/m this is the step of XPBD from a multiplier of zero (M. Macklin, M. Müller, N. Chentanez, *XPBD: position-based
//! simulation of compliant constrained dynamics*, 2016, equation 18 with α̃ = 1/κ).

use crate::grid::Node;
use crate::link::{Count, Family, Links, Quotient, Visitor, each_row, in_row};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Rest, Rounding, Scalar};
use crate::solver::{aside, unit_mass};
use crate::vec3::Vec3;

/// Moves a particle with its velocity for a substep, to the start of [`sweeps`].
///
/// If there are links to sweep over, its velocity is set [aside].
#[inline(always)]
pub(super) fn go<S: Scalar, L: Links<S>>(moment: Moment) -> impl Fn(Vec3<S>, Vec3<S>) -> [Vec3<S>; 2] {
    move |position, velocity| {
        let position = position + moment.displacement(velocity);
        let is_swept = L::Directions::NUMBER > 0;
        [position, if is_swept { aside::set_aside(velocity, position, moment) } else { velocity }]
    }
}

/// Projects every spring `parts` times, each time with one part in `parts` of its stiffness. Particles have been moved by [`go`].
#[inline]
pub(super) fn sweeps<S: Scalar, L: Links<S>, const W: usize, const H: usize>(
    links: &L,
    particles: &mut Particles<S, W, H>,
    moment: Moment,
    parts: u32,
) {
    if L::Directions::NUMBER == 0 {
        return;
    }
    let unit_mass = unit_mass::rows(particles);
    let part = part_of(parts);
    for _ in 0..parts {
        links.springs(&mut Project { particles, moment, rounding: moment.rounding(), part, unit_mass });
    }
    aside::give_all_back(particles, moment);
}

/// `1/parts`. Numbers of parts beyond the range of fixed point are divided by 2ⁿ first.
fn part_of<S: Scalar>(parts: u32) -> S {
    if parts == 1 {
        return S::ONE;
    }
    if parts < 128 {
        return S::from_int(parts as i32).recip();
    }
    let shift = 25 - parts.leading_zeros();
    S::ONE.halve(shift).times(parts as i32).recip().halve(shift)
}

struct Project<'a, S, const W: usize, const H: usize> {
    particles: &'a mut Particles<S, W, H>,
    moment: Moment,
    rounding: Rounding,
    /// The part of its stiffness with which a spring is projected.
    part: S,
    /// The rows whose particles all have mass 1, so that no mass is checked.
    unit_mass: [bool; H],
}

impl<S: Scalar, const W: usize, const H: usize> Project<'_, S, W, H> {
    /// Projects a link between particles of mass 1.
    #[inline(always)]
    fn join(&mut self, a: Node, b: Node, rest: &Rest<S>, part: S) {
        let by = (self.particles.position.at(b) - self.particles.position.at(a)).correction(rest, part, self.rounding);
        self.displace(a, by);
        self.displace(b, -by);
    }

    /// Projects a link between particles of any mass.
    #[inline(always)]
    fn join_any(&mut self, a: Node, b: Node, rest: &Rest<S>, strength: Quotient<S>, part: S) {
        let [wa, wb] = [a, b].map(|node| self.particles.inverse_mass[node]);
        if wa == S::ONE && wb == S::ONE {
            self.join(a, b, rest, part);
        } else if wa + wb != S::ZERO {
            let d = self.particles.position.at(b) - self.particles.position.at(a);
            let part = strength.against(wa + wb);
            if part.is_within(S::ONE) {
                let by = d.correction(rest, part, self.rounding);
                self.displace(a, by * wa);
                self.displace(b, -(by * wb));
            } else {
                // heavy particles: times an inverse mass, `part` is at most 1, as fixed point needs
                self.displace(a, d.correction(rest, part * wa, self.rounding));
                self.displace(b, -d.correction(rest, part * wb, self.rounding));
            }
        }
    }

    #[inline(always)]
    fn displace(&mut self, node: Node, by: Vec3<S>) {
        aside::displace_node(self.particles, node, by, self.moment);
    }
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Project<'_, S, W, H> {
    #[inline(never)] // one copy for all scenes of a grid
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let strength = if self.part == S::ONE { family.strength } else { family.strength.scaled(self.part) };
        // nearly all links join two unit-mass particles: their quotient is formed once, and their masses need no product
        let part = strength.against(S::ONE + S::ONE);
        each_row::<DOWN, H>(|row| {
            let node = |column, down| Node { column, row: row + down };
            if self.unit_mass[row] && self.unit_mass[row + DOWN] {
                in_row::<ACROSS, DOWN, W>(|a, b| self.join(node(a, 0), node(b, DOWN), &family.rest, part));
            } else {
                in_row::<ACROSS, DOWN, W>(|a, b| {
                    self.join_any(node(a, 0), node(b, DOWN), &family.rest, strength, part);
                });
            }
        });
    }
}
