//! A sweep over all links of a scene.

use crate::cloth::Cloth;
use crate::grid::{Grid, Node};
use crate::link::{Family, Links, Quotient, Visitor, each};
use crate::moment::Moment;
use crate::scalar::Scalar;

use super::ROUGH;
use super::chain::Chain;

/// Which families a visit is for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Pass {
    /// All, which act with a part of their last multipliers.
    Start,
    /// All but those along rows and columns between neighbours.
    Others,
    /// Rows and columns.
    Lines,
}

/// Relaxes links.
pub(super) struct Relax<'a, S, const W: usize, const H: usize, const N: usize> {
    cloth: &'a mut Cloth<S, W, H>,
    tension: &'a mut [Grid<S, W, H>; N],
    moment: Moment,
    /// What the rule in time makes of κ.
    softness: S,
    pass: Pass,
    sweep: u32,
    warm: S,
    /// The grid of multipliers of the family at hand.
    slot: usize,
    rough: bool,
}

impl<'a, S: Scalar, const W: usize, const H: usize, const N: usize> Relax<'a, S, W, H, N> {
    pub(super) fn new(
        cloth: &'a mut Cloth<S, W, H>,
        tension: &'a mut [Grid<S, W, H>; N],
        moment: Moment,
        softness: S,
    ) -> Self {
        Self { cloth, tension, moment, softness, pass: Pass::Others, sweep: 0, warm: S::ZERO, slot: 0, rough: false }
    }

    /// Lets every link act with the part `warm` of its last multiplier.
    pub(super) fn start<L: Links<S>>(&mut self, links: &L, warm: S) {
        if warm == S::ZERO {
            *self.tension = [Grid::filled(S::ZERO); N];
        } else {
            (self.pass, self.warm, self.slot) = (Pass::Start, warm, 0);
            links.springs(self);
        }
    }

    /// Relaxes every link once.
    pub(super) fn sweep<L: Links<S>>(&mut self, links: &L, sweep: u32) {
        (self.sweep, self.rough) = (sweep, false);
        for pass in [Pass::Others, Pass::Lines] {
            (self.pass, self.slot) = (pass, 0);
            links.springs(self);
        }
    }

    /// Whether the last sweep met a row far from its rest length.
    pub(super) fn is_rough(&self) -> bool {
        self.rough
    }

    fn pull<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let diagonal = ACROSS > 0 && DOWN > 0;
        if slot + usize::from(diagonal) >= N {
            return;
        }
        let dividend = family.strength.scaled(self.softness).dividend;
        each::<ACROSS, DOWN, W, H>(|a, b| {
            let Some(tension) = self.tension.get_mut(slot + usize::from(diagonal && a.column > b.column)) else { return };
            tension[a] = tension[a] * self.warm;
            let d = self.cloth.position[b] - self.cloth.position[a];
            let (_, inverse) = S::gauge(d.squared(), &family.rest);
            self.cloth.pull(a, b, d * (inverse * tension[a] * dividend), self.moment);
        });
    }

    fn line<const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let Some(tension) = self.tension.get_mut(slot) else { return };
        let strength = family.strength.scaled(self.softness);
        let chain = Chain { rest: &family.rest, strength, moment: self.moment };
        if DOWN == 0 {
            let mut worst = S::ZERO;
            for row in 0..H {
                worst = worst.max(chain.solve(self.cloth, |column| Node { column, row }, &mut tension.0[row]));
            }
            self.rough |= worst > family.rest.length * S::from_f64(ROUGH);
        } else {
            for column in 0..W {
                let mut multipliers: [S; H] = core::array::from_fn(|row| tension.0[row][column]);
                chain.solve(self.cloth, |row| Node { column, row }, &mut multipliers);
                for row in 0..H {
                    tension.0[row][column] = multipliers[row];
                }
            }
        }
    }

    fn links<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let Quotient { dividend, divisor } = family.strength.scaled(self.softness);
        let diagonal = ACROSS > 0 && DOWN > 0;
        let remembered = slot + usize::from(diagonal) < N;
        if !remembered && self.sweep > 0 {
            return;
        }
        each::<ACROSS, DOWN, W, H>(|a, b| {
            let inverse_mass = self.cloth.inverse_mass[a] + self.cloth.inverse_mass[b];
            if inverse_mass == S::ZERO {
                return;
            }
            let d = self.cloth.position[b] - self.cloth.position[a];
            let (excess, inverse) = S::gauge(d.squared(), &family.rest);
            let pivot = (inverse_mass * dividend + divisor).recip();
            let falling = diagonal && a.column > b.column;
            let change = match self.tension.get_mut(slot + usize::from(falling)) {
                Some(tension) if remembered => {
                    let change = (excess - divisor * tension[a]) * pivot;
                    tension[a] += change;
                    change
                }
                _ => excess * pivot,
            };
            self.cloth.pull(a, b, d * (inverse * change * dividend), self.moment);
        });
    }
}

impl<S: Scalar, const W: usize, const H: usize, const N: usize> Visitor<S> for Relax<'_, S, W, H, N> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let slot = self.slot;
        self.slot += if ACROSS > 0 && DOWN > 0 { 2 } else { 1 };
        match (ACROSS + DOWN == 1, self.pass) {
            (true, Pass::Lines) => self.line::<DOWN>(family, slot),
            (false, Pass::Others) => self.links::<ACROSS, DOWN>(family, slot),
            (_, Pass::Start) => self.pull::<ACROSS, DOWN>(family, slot),
            _ => {}
        }
    }
}
