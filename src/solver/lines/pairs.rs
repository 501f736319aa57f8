//! Links relaxed a row at a time.
//!
//! Links between one row and another act on the positions that all of them found (Jacobi), so that a mirrored sheet is relaxed as the mirror image, to the
//! last bit, and a machine may compute four at once. That does not overshoot: both diagonals of a cell are nearly at right angles, and the few links that
//! share a particle elsewhere lie in a row.

use crate::cloth::Cloth;
use crate::grid::Grid;
use crate::link::{Family, Quotient};
use crate::moment::Moment;
use crate::scalar::{Rest, Scalar};
use crate::vec3::Vec3;
use crate::vectors::{left, right};

use super::displace_row;

/// Links of one kind.
pub(super) struct Pairs<'a, S> {
    rest: &'a Rest<S>,
    strength: Quotient<S>,
    moment: Moment,
}

impl<'a, S: Scalar> Pairs<'a, S> {
    pub(super) fn new(family: &'a Family<S>, strength: Quotient<S>, moment: Moment) -> Self {
        Self { rest: &family.rest, strength, moment }
    }

    /// Links between particles that are `ACROSS` columns apart.
    #[inline]
    pub(super) fn row<const ACROSS: usize, const START: bool, const W: usize, const H: usize>(
        &self,
        cloth: &mut Cloth<S, W, H>,
        mut tension: Option<&mut Grid<S, W, H>>,
        warm: S,
    ) {
        if W <= ACROSS {
            return;
        }
        for row in 0..H {
            let (x, w) = (&cloth.position.0[row], cloth.inverse_mass.0[row]);
            let mut none = [S::ZERO; W];
            let tension = tension.as_deref_mut().map_or(&mut none, |grid| &mut grid.0[row]);
            let mut pull = self.pull::<START, W>(
                x,
                &x.components(left::<ACROSS, S, W>),
                &w,
                &left::<ACROSS, S, W>(&w),
                tension,
                warm,
            );
            without_last::<ACROSS, S, W>(&mut pull, tension);
            let before = pull.components(right::<ACROSS, S, W>);
            displace_row(cloth, row, |column| (pull.at(column) - before.at(column)) * w[column], self.moment);
        }
    }

    /// Links between particles that are `DOWN` rows apart.
    #[inline]
    pub(super) fn column<const DOWN: usize, const START: bool, const W: usize, const H: usize>(
        &self,
        cloth: &mut Cloth<S, W, H>,
        mut tension: Option<&mut Grid<S, W, H>>,
        warm: S,
    ) {
        // before the links of a row act, those that end in it have acted
        for row in 0..H.saturating_sub(DOWN) {
            let [x, y] = [row, row + DOWN].map(|row| &cloth.position.0[row]);
            let [u, v] = [row, row + DOWN].map(|row| cloth.inverse_mass.0[row]);
            let mut none = [S::ZERO; W];
            let tension = tension.as_deref_mut().map_or(&mut none, |grid| &mut grid.0[row]);
            let pull = self.pull::<START, W>(x, y, &u, &v, tension, warm);
            displace_row(cloth, row, |column| pull.at(column) * u[column], self.moment);
            displace_row(cloth, row + DOWN, |column| -pull.at(column) * v[column], self.moment);
        }
    }

    /// Links along both diagonals.
    #[inline]
    pub(super) fn diagonals<
        const ACROSS: usize,
        const DOWN: usize,
        const START: bool,
        const W: usize,
        const H: usize,
    >(
        &self,
        cloth: &mut Cloth<S, W, H>,
        mut tension: Option<[&mut Grid<S, W, H>; 2]>,
        warm: S,
    ) {
        if W <= ACROSS {
            return;
        }
        for colour in 0..2 {
            let mut row = colour;
            while row + DOWN < H {
                let [x, y] = [row, row + DOWN].map(|row| &cloth.position.0[row]);
                let [u, v] = [row, row + DOWN].map(|row| cloth.inverse_mass.0[row]);
                let mut none = [[S::ZERO; W]; 2];
                let [falling, rising] = match &mut tension {
                    Some([falling, rising]) => [&mut falling.0[row], &mut rising.0[row]],
                    None => none.each_mut(),
                };
                // to the right and down, to the left and down
                let mut fall = self.pull::<START, W>(
                    x,
                    &y.components(left::<ACROSS, S, W>),
                    &u,
                    &left::<ACROSS, S, W>(&v),
                    falling,
                    warm,
                );
                without_last::<ACROSS, S, W>(&mut fall, falling);
                let mut rise = self.pull::<START, W>(
                    x,
                    &y.components(right::<ACROSS, S, W>),
                    &u,
                    &right::<ACROSS, S, W>(&v),
                    rising,
                    warm,
                );
                without_first::<ACROSS, S, W>(&mut rise, rising);
                displace_row(cloth, row, |column| (fall.at(column) + rise.at(column)) * u[column], self.moment);
                let (fall, rise) = (fall.components(right::<ACROSS, S, W>), rise.components(left::<ACROSS, S, W>));
                displace_row(cloth, row + DOWN, |column| -(fall.at(column) + rise.at(column)) * v[column], self.moment);
                row += 2;
            }
        }
    }

    /// What links from a row of particles to another do: with a part of their last multipliers (`START`), or by what is missing.
    #[inline(always)]
    fn pull<const START: bool, const W: usize>(
        &self,
        x: &Vec3<[S; W]>,
        y: &Vec3<[S; W]>,
        u: &[S; W],
        v: &[S; W],
        tension: &mut [S; W],
        warm: S,
    ) -> Vec3<[S; W]> {
        let Quotient { dividend, divisor } = self.strength;
        let mut pull = Vec3::row(Vec3::ZERO);
        // no branches, all columns: so it can be done for four at once
        for column in 0..W {
            let d = y.at(column) - x.at(column);
            let (excess, normal) = d.direction(self.rest);
            let change = if START {
                let change = tension[column] * warm;
                tension[column] = change;
                change
            } else {
                let inverse_mass = u[column] + v[column];
                let change = (excess - divisor * tension[column]).divide(inverse_mass * dividend + divisor);
                let change = if inverse_mass == S::ZERO { S::ZERO } else { change };
                tension[column] += change;
                change
            };
            pull.set(column, normal * (change * dividend));
        }
        pull
    }
}

/// Nothing in the last `BY < W` columns.
#[inline(always)]
fn without_last<const BY: usize, S: Scalar, const W: usize>(pull: &mut Vec3<[S; W]>, tension: &mut [S; W]) {
    for column in W - BY..W {
        pull.set(column, Vec3::ZERO);
        tension[column] = S::ZERO;
    }
}

/// Nothing in the first `BY < W` columns.
#[inline(always)]
fn without_first<const BY: usize, S: Scalar, const W: usize>(pull: &mut Vec3<[S; W]>, tension: &mut [S; W]) {
    for column in 0..BY {
        pull.set(column, Vec3::ZERO);
        tension[column] = S::ZERO;
    }
}
