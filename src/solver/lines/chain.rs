//! A row or a column of links, solved exactly.
//!
//! With unit normals n, inverse masses w and a strength κ = a/b, the linearised constraints `|d| − L = λ/κ` of a chain form a tridiagonal system. In
//! multipliers μ = λ/a, which fit any number type,
//!
//! `(a·(w_i + w_{i+1}) + b)·μ_i − a·w_i·(n_{i−1}·n_i)·μ_{i−1} − a·w_{i+1}·(n_i·n_{i+1})·μ_{i+1} = |d_i| − L`.
//!
//! One pass down and one up solve it (L. Thomas, 1949), where Gauss–Seidel carries news one link a sweep. With equal masses and one end free the pivots stay
//! between a·w and 2·a·w + b.
//!
//! Columns are solved side by side, [`LANES`] at a time. A row is eliminated from both its ends to its middle (a twisted factorisation), so that a mirrored
//! sheet of even width is solved as the mirror image, to the last bit in floats; all of a row but the elimination is done for many links at once.

use heapless::Vec;

use crate::grid::Grid;
use crate::link::Quotient;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Rest, Rounding, Scalar};
use crate::solver::unit_mass::UnitMass;
use crate::vec3::Vec3;
use crate::vectors::{SIDE_BY_SIDE, ahead, behind, columns};

use super::diagonal::each_diagonal;
use super::geometric_stiffness::{TAUT, geometric_stiffness};
use super::heavy::Heavy;
use super::regularise::{harmless, regularisation};
use super::{displace, displace_row};

/// Columns that are solved side by side, where a machine computes several numbers at once: two of its vectors of `f32`.
const LANES: usize = 8;

/// Links of one kind.
pub(super) struct Chain<'a, S: Scalar, const W: usize, const H: usize> {
    pub(super) rest: &'a Rest<S>,
    pub(super) strength: Quotient<S>,
    pub(super) moment: Moment,
    pub(super) rounding: Rounding,
    pub(super) unit_mass: &'a UnitMass<W, H>,
    pub(super) heavy: Heavy,
    /// The least inverse mass over the largest that is more than 1.
    pub(super) span: S,
}

/// What elimination leaves of one link's equation: the change of its multiplier is `right + factor · (change of the next)`.
#[derive(Clone, Copy)]
pub(super) struct Eliminated<S> {
    pub(super) pivot: S,
    pub(super) right: S,
}

impl<S: Scalar> Eliminated<S> {
    pub(super) const NONE: Self = Self { pivot: S::ZERO, right: S::ZERO };

    /// The next link, and the factor of its change in this one's.
    #[inline(always)]
    pub(super) fn next<const UNIT_MASS: bool>(self, diagonal: S, coupling: S, residual: S) -> (Self, S) {
        let factor = times::<UNIT_MASS, S>(coupling, self.pivot);
        let pivot = (diagonal - times::<UNIT_MASS, S>(factor, coupling)).recip();
        let right = times::<UNIT_MASS, S>(residual + times::<UNIT_MASS, S>(self.right, coupling), pivot);
        (Self { pivot, right }, factor)
    }
}

/// The dividend in a link's own coefficient. A taut chain between two pins has no pivot but for the divisor, and what floats round of light particles' inverse masses is
/// more: of that a little is left. Fixed point has no masses that light.
#[inline(always)]
pub(super) fn yielding<S: Scalar>(dividend: S) -> S {
    if S::FLOATS { dividend + S::from_f64(4.0 * S::RESOLUTION) } else { dividend }
}

/// Whether products with masses are skipped where all are 1: not where they cost no more than looking.
pub(super) const fn skips_masses<S: Scalar>() -> bool {
    !(S::FLOATS && SIDE_BY_SIDE)
}

/// A product with a pivot, a coupling or a factor. Where all masses are 1 none of them is larger than 1: pivots are at least `a + b`, of which the larger is 1.
#[inline(always)]
fn times<const UNIT_MASS: bool, S: Scalar>(x: S, ratio: S) -> S {
    if UNIT_MASS { x.scaled(ratio) } else { x * ratio }
}

impl<S: Scalar, const W: usize, const H: usize> Chain<'_, S, W, H> {
    /// Solves every row. Returns the largest difference between a link's length and rest length that it met.
    #[inline(never)] // one for all scenes of a grid
    pub(super) fn rows(&self, particles: &mut Particles<S, W, H>, tension: &mut Grid<S, W, H>) -> S {
        let mut worst = S::ZERO;
        if W > 1 {
            for row in 0..H {
                if self.unit_mass.held[row] {
                    continue; // nor is what pins are strained by a reason to sweep on
                }
                let tension = &mut tension.0[row];
                worst = worst.max(if const { skips_masses::<S>() } && self.unit_mass.rows[row] {
                    self.row::<true>(particles, row, tension)
                } else {
                    self.row::<false>(particles, row, tension)
                });
            }
        }
        worst
    }

    #[inline(always)]
    fn row<const UNIT_MASS: bool>(&self, particles: &mut Particles<S, W, H>, row: usize, tension: &mut [S; W]) -> S {
        let dividend = self.strength.dividend;
        let own = yielding(dividend);
        let heavy = if UNIT_MASS { Heavy::NONE } else { self.heavy };
        let (links, middle) = (W - 1, (W - 1) / 2);
        let x = &particles.position.0[row];
        let w = particles.inverse_mass.0[row].map(|w| heavy.scaled(w));
        let mut normal = Vec3::row(Vec3::ZERO);
        let [mut residual, mut diagonal, mut coupling, mut change] = [[S::ZERO; W]; 4];
        let mut worst = S::ZERO;
        {
            let next = ahead::<1, S, W>(x);
            for k in columns::<1, 0, W>() {
                let (excess, along) = (next(k) - x.at(k)).direction(self.rest);
                residual[k] = excess - heavy.scaled(self.strength.times_divisor(tension[k]));
                normal.set(k, along);
            }
        }
        residual[links] = S::ZERO;
        for k in 0..W {
            worst = worst.max(residual[k].abs());
        }
        let divisor = self.divisor::<UNIT_MASS, W>(worst, || regularisation(&residual, &w, W));
        // of each link with the one after it
        let normal_next = ahead::<1, S, W>(&normal);
        for k in columns::<2, 0, W>() {
            coupling[k] = self.strength.of_dividend(normal.at(k).cosine(normal_next(k)));
        }
        for k in 0..W {
            diagonal[k] = own + own + divisor;
        }
        if !UNIT_MASS {
            for k in 0..W {
                let (here, next) = (w[k], if k + 1 < W { w[k + 1] } else { S::ZERO });
                coupling[k] = coupling[k] * next;
                diagonal[k] = (here + next) * own + divisor;
            }
        }
        let [mut left, mut right] = [Eliminated::NONE; 2];
        let mut factor = [S::ZERO; W];
        for k in 0..middle {
            let before = if k > 0 { coupling[k - 1] } else { S::ZERO };
            let ahead;
            (left, ahead) = left.next::<UNIT_MASS>(diagonal[k], before, residual[k]);
            change[k] = left.right;
            if k > 0 {
                factor[k - 1] = ahead;
            }
        }
        for k in (middle + 1..links).rev() {
            let after = if k + 1 < links { coupling[k] } else { S::ZERO };
            let ahead;
            (right, ahead) = right.next::<UNIT_MASS>(diagonal[k], after, residual[k]);
            change[k] = right.right;
            if k + 1 < links {
                factor[k + 1] = ahead;
            }
        }
        // the middle link, from both sides
        let from_left = if middle > 0 { coupling[middle - 1] } else { S::ZERO };
        let from_right = if middle + 1 < links { coupling[middle] } else { S::ZERO };
        let (to_left, to_right) = (from_left * left.pivot, from_right * right.pivot);
        let pivot = (diagonal[middle] - (from_left * to_left + from_right * to_right)).recip();
        change[middle] = (residual[middle] + (from_left * left.right + from_right * right.right)) * pivot;
        if middle > 0 {
            factor[middle - 1] = to_left;
        }
        if middle + 1 < links {
            factor[middle + 1] = to_right;
        }
        for k in (0..middle).rev() {
            change[k] += times::<UNIT_MASS, S>(change[k + 1], factor[k]);
        }
        for k in middle + 1..links {
            change[k] += times::<UNIT_MASS, S>(change[k - 1], factor[k]);
        }
        change[links] = S::ZERO;
        let mut pull = Vec3::row(Vec3::ZERO);
        for k in 0..W {
            tension[k] = tension[k].difference(-change[k]); // does not wrap
            pull.set(k, normal.at(k).of_length(self.strength.times_dividend(change[k]), self.rounding));
        }
        let before = behind::<1, S, W>(&pull);
        displace_row(
            particles,
            row,
            |k| {
                let by = pull.at(k) - before(k);
                if UNIT_MASS { by } else { by * w[k] }
            },
            self.moment,
        );
        let mut most = S::ZERO;
        for k in 0..W {
            most = most.max(change[k]);
        }
        if self.is_taut(most, heavy) {
            let tension = change.map(|change| self.strength.times_dividend(change));
            let by = geometric_stiffness(&normal, &tension, &w, W, self.rest.inverse, heavy);
            displace_row(particles, row, |k| by.at(k), self.moment);
        }
        worst
    }

    /// The divisor in the coefficients of a chain of `M` particles whose largest residual is `worst`, in the unit of multipliers: larger where they are held back.
    #[inline(always)]
    fn divisor<const UNIT_MASS: bool, const M: usize>(&self, worst: S, regularisation: impl FnOnce() -> S) -> S {
        let (heavy, span) = if UNIT_MASS { (Heavy::NONE, S::ONE) } else { (self.heavy, self.span) };
        let divisor = heavy.scaled(self.strength.divisor);
        if S::FLOATS || worst <= harmless::<S, M>(span) { divisor } else { divisor.max(regularisation()) }
    }

    /// Whether a chain whose largest multiplier this is has a tension that shakes it.
    #[inline(always)]
    pub(super) fn is_taut(&self, most: S, heavy: Heavy) -> bool {
        most.scaled(self.strength.dividend) > heavy.bound(self.rest.length * S::from_f64(TAUT))
    }

    /// Solves every column. Returns the largest residual of those that were held back, which are far from solved.
    #[inline(never)] // one for all scenes of a grid
    pub(super) fn columns(&self, particles: &mut Particles<S, W, H>, tension: &mut Grid<S, W, H>) -> S {
        let (mut column, mut unsolved) = (0, S::ZERO);
        // where products depend on the masses of a column, every machine looks at one
        if const { !skips_masses::<S>() } {
            while column + LANES <= W {
                unsolved = unsolved.max(self.some::<LANES>(particles, column, tension));
                column += LANES;
            }
            while column + 4 <= W {
                unsolved = unsolved.max(self.some::<4>(particles, column, tension));
                column += 4;
            }
        }
        while column < W {
            unsolved = unsolved.max(self.some::<1>(particles, column, tension));
            column += 1;
        }
        unsolved
    }

    fn some<const N: usize>(&self, particles: &mut Particles<S, W, H>, first: usize, tension: &mut Grid<S, W, H>) -> S {
        let place = Place { top: 0, first, count: H, slant: 0 };
        if const { skips_masses::<S>() } {
            self.one(particles, place, tension, self.unit_mass.columns[first.min(W - 1)])
        } else {
            self.side_by_side::<N, false, false>(particles, place, tension)
        }
    }

    /// Solves the diagonals of the cells of one colour, one after the other. Returns as [`columns`](Self::columns).
    pub(super) fn diagonals_one_by_one(
        &self,
        particles: &mut Particles<S, W, H>,
        colour: usize,
        tension: &mut Grid<S, W, H>,
    ) -> S {
        let mut unsolved = S::ZERO;
        each_diagonal::<W, H>(colour, |place| {
            let inverse_mass = |k: usize| particles.inverse_mass.0[place.row::<H>(k)][place.column::<1, W>(k)];
            let unit_mass = (0..place.count).all(|k| inverse_mass(k) == S::ONE);
            unsolved = unsolved.max(self.one(particles, place, tension, unit_mass));
        });
        unsolved
    }

    /// Solves one chain, whose particles may all have mass 1.
    fn one(&self, particles: &mut Particles<S, W, H>, place: Place, tension: &mut Grid<S, W, H>, unit_mass: bool) -> S {
        if unit_mass {
            self.side_by_side::<1, true, true>(particles, place, tension)
        } else {
            self.side_by_side::<1, false, true>(particles, place, tension)
        }
    }

    /// Solves `N` chains. Returns their largest residual where they were held back.
    #[inline(never)] // so that sheet and multipliers are known to be apart
    fn side_by_side<const N: usize, const UNIT_MASS: bool, const ANYWHERE: bool>(
        &self,
        particles: &mut Particles<S, W, H>,
        place: Place,
        tension: &mut Grid<S, W, H>,
    ) -> S {
        // columns' extent is known when this is compiled
        let place = if ANYWHERE { place } else { Place { top: 0, count: H, slant: 0, ..place } };
        let Place { top, first, count, .. } = place;
        if N > W || first > W - N || count > H || top > H - count {
            return S::ZERO; // said once, no column needs to be looked for
        }
        let dividend = self.strength.dividend;
        let own = yielding(dividend);
        let heavy = if UNIT_MASS { Heavy::NONE } else { self.heavy };
        // pushed one by one, so that none has to be written twice
        let mut links = Vec::<Link<S, N>, H>::new();
        let mut worst = S::ZERO;
        for k in 0..count.saturating_sub(1) {
            let (above, below) = (place.row::<H>(k), place.row::<H>(k + 1));
            let [x, y] = [&particles.position.0[above], &particles.position.0[below]];
            let mut link = Link { normal: Vec3::row(Vec3::ZERO), change: [S::ZERO; N], factor: [S::ZERO; N] };
            for lane in 0..N {
                let [here, next] = [place.column::<N, W>(k) + lane, place.column::<N, W>(k + 1) + lane];
                let (excess, normal) = (y.at(next) - x.at(here)).direction(self.rest);
                let residual = excess - heavy.scaled(self.strength.times_divisor(tension.0[above][here]));
                if !S::FLOATS {
                    worst = worst.max(residual.abs());
                }
                link.normal.set(lane, normal);
                link.change[lane] = residual;
            }
            _ = links.push(link); // there is room for all
        }
        let divisor = (0..N).fold(S::ZERO, |divisor, lane| {
            let added = || Self::regularisation(&links, particles, place, lane, heavy);
            divisor.max(self.divisor::<UNIT_MASS, H>(worst, added))
        });
        let is_regularised = divisor > heavy.scaled(self.strength.divisor);
        let mut above = [Eliminated::NONE; N];
        let mut before = Vec3::<[S; N]>::row(Vec3::ZERO);
        for (k, link) in links.iter_mut().enumerate() {
            let [u, v] =
                [&particles.inverse_mass.0[place.row::<H>(k)], &particles.inverse_mass.0[place.row::<H>(k + 1)]];
            for lane in 0..N {
                let coupling = self.strength.of_dividend(before.at(lane).cosine(link.normal.at(lane)));
                let (coupling, inverse_mass) = if UNIT_MASS {
                    (coupling, S::ONE + S::ONE)
                } else {
                    let here = heavy.scaled(u[place.column::<N, W>(k) + lane]);
                    let next = heavy.scaled(v[place.column::<N, W>(k + 1) + lane]);
                    (coupling * here, here + next)
                };
                let diagonal = inverse_mass * own + divisor;
                (above[lane], link.factor[lane]) = above[lane].next::<UNIT_MASS>(diagonal, coupling, link.change[lane]);
                link.change[lane] = above[lane].right;
            }
            before = link.normal;
        }
        let [mut change, mut factor, mut most] = [[S::ZERO; N]; 3];
        let mut below = Vec3::<[S; N]>::row(Vec3::ZERO);
        let displace = |particles: &mut Particles<S, W, H>, k: usize, by: Vec3<[S; N]>| {
            let row = place.row::<H>(k);
            let w = &particles.inverse_mass.0[row];
            let (x, v) = (&mut particles.position.0[row], &mut particles.velocity.0[row]);
            for lane in 0..N {
                let column = place.column::<N, W>(k) + lane;
                let by = by.at(lane);
                displace(x, v, column, if UNIT_MASS { by } else { by * heavy.scaled(w[column]) }, self.moment);
            }
        };
        for (k, link) in links.iter_mut().enumerate().rev() {
            let tension = &mut tension.0[place.row::<H>(k)];
            let (mut pull, mut by) = (below, below);
            for lane in 0..N {
                change[lane] = link.change[lane] + times::<UNIT_MASS, S>(change[lane], factor[lane]);
                link.change[lane] = change[lane];
                most[lane] = most[lane].max(change[lane]);
                pull.set(
                    lane,
                    link.normal.at(lane).of_length(self.strength.times_dividend(change[lane]), self.rounding),
                );
                by.set(lane, below.at(lane) - pull.at(lane));
            }
            for lane in 0..N {
                let column = place.column::<N, W>(k) + lane;
                tension[column] = tension[column].difference(-change[lane]); // does not wrap
            }
            displace(particles, k + 1, by);
            (below, factor) = (pull, link.factor);
        }
        displace(particles, 0, below);
        for lane in 0..N {
            if self.is_taut(most[lane], heavy) {
                self.ease_one(&links, particles, place, lane, heavy);
            }
        }
        if is_regularised { worst } else { S::ZERO }
    }

    /// What is added to the diagonal of one of some chains, whose residuals are known.
    #[cold]
    #[inline(never)]
    fn regularisation<const N: usize>(
        links: &[Link<S, N>],
        particles: &Particles<S, W, H>,
        place: Place,
        lane: usize,
        heavy: Heavy,
    ) -> S {
        let lane = lane.min(N - 1);
        let mut residual = [S::ZERO; H];
        residual.iter_mut().zip(links).for_each(|(residual, link)| *residual = link.change[lane]);
        regularisation(&residual, &Self::inverse_masses(particles, place, lane, heavy), place.count)
    }

    /// Eases one of some chains.
    #[inline(never)] // few chains are that taut
    fn ease_one<const N: usize>(
        &self,
        links: &[Link<S, N>],
        particles: &mut Particles<S, W, H>,
        place: Place,
        lane: usize,
        heavy: Heavy,
    ) {
        let lane = lane.min(N - 1);
        let mut normal: Vec3<[S; H]> = Vec3::row(Vec3::ZERO);
        let mut change = [S::ZERO; H];
        for (k, link) in links.iter().enumerate().take(H) {
            normal.set(k, link.normal.at(lane));
            change[k] = link.change[lane];
        }
        self.add_geometric_stiffness(particles, place, lane, (&normal, &change), heavy);
    }

    fn inverse_masses(particles: &Particles<S, W, H>, place: Place, lane: usize, heavy: Heavy) -> [S; H] {
        core::array::from_fn(|k| {
            if k < place.count {
                heavy.scaled(particles.inverse_mass.0[place.row::<H>(k)][(place.column::<1, W>(k) + lane).min(W - 1)])
            } else {
                S::ZERO
            }
        })
    }

    /// Eases one of some chains, whose links have these directions and changes of multipliers.
    #[inline(never)] // few chains are that taut
    pub(super) fn add_geometric_stiffness(
        &self,
        particles: &mut Particles<S, W, H>,
        place: Place,
        lane: usize,
        (normal, changes): (&Vec3<[S; H]>, &[S; H]),
        heavy: Heavy,
    ) {
        let tension = changes.map(|change| self.strength.times_dividend(change));
        let w = Self::inverse_masses(particles, place, lane, heavy);
        let by = geometric_stiffness(normal, &tension, &w, place.count, self.rest.inverse, heavy);
        for k in 0..place.count.min(H) {
            let (row, column) = (place.row::<H>(k), (place.column::<1, W>(k) + lane).min(W - 1));
            displace(&mut particles.position.0[row], &mut particles.velocity.0[row], column, by.at(k), self.moment);
        }
    }
}

/// Links of some chains side by side.
struct Link<S, const N: usize> {
    normal: Vec3<[S; N]>,
    /// At first the residual, in the end what the multiplier changes by.
    change: [S; N],
    /// The part of its change that the change of the link above has of it.
    factor: [S; N],
}

/// Where a chain lies: it starts in row `top` and column `first`, and has a particle in each of `count` rows, `slant` columns further in each.
#[derive(Clone, Copy)]
pub(super) struct Place {
    pub(super) top: usize,
    pub(super) first: usize,
    pub(super) count: usize,
    pub(super) slant: isize,
}

impl Place {
    /// The row of the chain's particle `k`; within the grid for a compiler to see, so that no bound is looked up.
    #[inline(always)]
    pub(super) fn row<const H: usize>(self, k: usize) -> usize {
        (self.top + k).min(H - 1)
    }

    /// The column of the chain's particle `k`, likewise; `N` chains lie side by side.
    #[inline(always)]
    pub(super) fn column<const N: usize, const W: usize>(self, k: usize) -> usize {
        self.first.wrapping_add_signed(self.slant * k as isize).min(W.saturating_sub(N))
    }
}
