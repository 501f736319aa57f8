//! A sweep over all links of a scene.

use crate::cloth::Cloth;
use crate::grid::{Grid, Node};
use crate::link::{Family, Links, Quotient, Visitor, each};
use crate::moment::Moment;
use crate::scalar::Scalar;

use super::chain::Chain;
use super::{ROUGH, WARM_LINES, WARM_OTHERS, pull};

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
        Self { cloth, tension, moment, softness, pass: Pass::Others, sweep: 0, slot: 0, rough: false }
    }

    /// Lets every link act with a part of its last multiplier.
    pub(super) fn start<L: Links<S>>(&mut self, links: &L) {
        (self.pass, self.slot) = (Pass::Start, 0);
        links.springs(self);
    }

    /// Starts every link from nothing.
    pub(super) fn forget(&mut self) {
        *self.tension = [Grid::filled(S::ZERO); N];
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
        let cloth = &mut *self.cloth;
        let moment = self.moment;
        let warm = S::from_f64(WARM_OTHERS);
        let dividend = family.strength.scaled(self.softness).dividend;
        let mut act = |a: Node, b: Node, multiplier: &mut S| {
            *multiplier = *multiplier * warm;
            let d = cloth.position.at(b) - cloth.position.at(a);
            let (_, inverse) = S::gauge(d.squared(), &family.rest);
            pull(cloth, [a, b], d * (inverse * *multiplier * dividend), moment);
        };
        match self.tension.get_mut(slot..) {
            Some([rising, falling, ..]) if ACROSS > 0 && DOWN > 0 => each::<ACROSS, DOWN, W, H>(|a, b| {
                let tension = if a.column > b.column { &mut *falling } else { &mut *rising };
                act(a, b, &mut tension[a]);
            }),
            Some([tension, ..]) if ACROSS == 0 || DOWN == 0 => {
                each::<ACROSS, DOWN, W, H>(|a, b| act(a, b, &mut tension[a]));
            }
            _ => {}
        }
    }

    fn line<const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let Some(tension) = self.tension.get_mut(slot) else { return };
        let strength = family.strength.scaled(self.softness);
        let chain = Chain { rest: &family.rest, strength, moment: self.moment };
        let start = self.pass == Pass::Start;
        let warm = S::from_f64(WARM_LINES);
        if DOWN == 0 {
            let mut worst = S::ZERO;
            for row in 0..H {
                let node = |column| Node { column, row };
                if start {
                    chain.pull(self.cloth, node, &mut tension.0[row], warm);
                } else {
                    worst = worst.max(chain.solve(self.cloth, node, &mut tension.0[row]));
                }
            }
            self.rough |= worst > family.rest.length * S::from_f64(ROUGH);
        } else {
            for column in 0..W {
                let node = |row| Node { column, row };
                let mut multipliers: [S; H] = core::array::from_fn(|row| tension.0[row][column]);
                if start {
                    chain.pull(self.cloth, node, &mut multipliers, warm);
                } else {
                    chain.solve(self.cloth, node, &mut multipliers);
                }
                for row in 0..H {
                    tension.0[row][column] = multipliers[row];
                }
            }
        }
    }

    fn links<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>, slot: usize) {
        let cloth = &mut *self.cloth;
        let moment = self.moment;
        let Quotient { dividend, divisor } = family.strength.scaled(self.softness);
        let mut relax = |a: Node, b: Node, multiplier: &mut S| {
            let inverse_mass = cloth.inverse_mass[a] + cloth.inverse_mass[b];
            if inverse_mass == S::ZERO {
                return;
            }
            let d = cloth.position.at(b) - cloth.position.at(a);
            let (excess, inverse) = S::gauge(d.squared(), &family.rest);
            let change = (excess - divisor * *multiplier).divide(inverse_mass * dividend + divisor);
            *multiplier += change;
            pull(cloth, [a, b], d * (inverse * change * dividend), moment);
        };
        match self.tension.get_mut(slot..) {
            Some([rising, falling, ..]) if ACROSS > 0 && DOWN > 0 => each::<ACROSS, DOWN, W, H>(|a, b| {
                let tension = if a.column > b.column { &mut *falling } else { &mut *rising };
                relax(a, b, &mut tension[a]);
            }),
            Some([tension, ..]) if ACROSS == 0 || DOWN == 0 => {
                each::<ACROSS, DOWN, W, H>(|a, b| relax(a, b, &mut tension[a]));
            }
            // without a memory a second time would count twice
            _ if self.sweep == 0 => each::<ACROSS, DOWN, W, H>(|a, b| relax(a, b, &mut { S::ZERO })),
            _ => {}
        }
    }
}

impl<S: Scalar, const W: usize, const H: usize, const N: usize> Visitor<S> for Relax<'_, S, W, H, N> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        let slot = self.slot;
        self.slot += if ACROSS > 0 && DOWN > 0 { 2 } else { 1 };
        match (ACROSS + DOWN == 1, self.pass) {
            (true, Pass::Start | Pass::Lines) => self.line::<DOWN>(family, slot),
            (false, Pass::Start) => self.pull::<ACROSS, DOWN>(family, slot),
            (false, Pass::Others) => self.links::<ACROSS, DOWN>(family, slot),
            _ => {}
        }
    }
}
