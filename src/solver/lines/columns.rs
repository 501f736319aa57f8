//! Exact solves of columns, and of diagonals one by one.
//!
//! Machines with vector instructions solve [`LANES`] columns at a time, others one. For such machines, [`diagonal`](super::diagonal) solves all diagonals of a colour at once.

use heapless::Vec;

use crate::grid::Grid;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::aside::displace;
use crate::vec3::Vec3;

use super::chain::{Chain, skips_masses};
use super::exponent::Exponent;
use super::geometric_stiffness::geometric_stiffness;
use super::place::{Place, each_diagonal};
use super::regularise::regularisation;
use super::tridiagonal::{Eliminated, times};

/// The number of columns that are solved side by side on machines with vector instructions: two vectors of `f32`.
const LANES: usize = 8;

/// One link in each of `N` chains side by side.
struct Link<S, const N: usize> {
    normal: Vec3<[S; N]>,
    /// The residual, then the eliminated right side, in the end the change of the multiplier.
    change: [S; N],
    /// The factor with which this link's change enters that of the link above.
    factor: [S; N],
}

/// The links of `N` chains, from the top down.
type Links<S, const N: usize, const H: usize> = Vec<Link<S, N>, H>;

impl<S: Scalar, const W: usize, const H: usize> Chain<'_, S, W, H> {
    /// Solves every column. Returns the largest residual of the regularised columns, which are far from solved.
    #[inline(never)] // one copy for all scenes of a grid
    pub(super) fn columns(&self, particles: &mut Particles<S, W, H>, multipliers: &mut Grid<S, W, H>) -> S {
        let (mut column, mut unsolved) = (0, S::ZERO);
        // a machine that skips masses does so column by column
        if const { !skips_masses::<S>() } {
            while column + LANES <= W {
                unsolved = unsolved.max(self.some::<LANES>(particles, column, multipliers));
                column += LANES;
            }
            while column + 4 <= W {
                unsolved = unsolved.max(self.some::<4>(particles, column, multipliers));
                column += 4;
            }
        }
        while column < W {
            unsolved = unsolved.max(self.some::<1>(particles, column, multipliers));
            column += 1;
        }
        unsolved
    }

    fn some<const N: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        first: usize,
        multipliers: &mut Grid<S, W, H>,
    ) -> S {
        let place = Place { top: 0, first, count: H, slant: 0 };
        if const { skips_masses::<S>() } {
            self.one(particles, place, multipliers, self.unit_mass.columns[first.min(W - 1)])
        } else {
            self.side_by_side::<N, false, false>(particles, place, multipliers)
        }
    }

    /// Solves the diagonals of the cells of one colour, one after the other. Returns the same as [`columns`](Self::columns).
    pub(super) fn diagonals_one_by_one(
        &self,
        particles: &mut Particles<S, W, H>,
        colour: usize,
        multipliers: &mut Grid<S, W, H>,
    ) -> S {
        let mut unsolved = S::ZERO;
        each_diagonal::<W, H>(colour, |place| {
            let inverse_mass = |k: usize| particles.inverse_mass.0[place.row::<H>(k)][place.column::<1, W>(k)];
            let unit_mass = (0..place.count).all(|k| inverse_mass(k) == S::ONE);
            unsolved = unsolved.max(self.one(particles, place, multipliers, unit_mass));
        });
        unsolved
    }

    /// Solves one chain; `unit_mass` if all its particles have mass 1.
    fn one(
        &self,
        particles: &mut Particles<S, W, H>,
        place: Place,
        multipliers: &mut Grid<S, W, H>,
        unit_mass: bool,
    ) -> S {
        if unit_mass {
            self.side_by_side::<1, true, true>(particles, place, multipliers)
        } else {
            self.side_by_side::<1, false, true>(particles, place, multipliers)
        }
    }

    /// Solves `N` chains. Returns their largest residual if they were regularised, zero otherwise.
    #[inline(never)] // so that the compiler knows that sheet and multipliers don't alias
    fn side_by_side<const N: usize, const UNIT_MASS: bool, const ANYWHERE: bool>(
        &self,
        particles: &mut Particles<S, W, H>,
        place: Place,
        multipliers: &mut Grid<S, W, H>,
    ) -> S {
        // the extent of columns is known at compile time
        let place = if ANYWHERE { place } else { Place { top: 0, count: H, slant: 0, ..place } };
        let Place { top, first, count, .. } = place;
        if N > W || first > W - N || count > H || top > H - count {
            return S::ZERO; // never: saves the bounds checks below
        }
        let exponent = self.exponent::<UNIT_MASS>();
        let mut links = Links::<S, N, H>::new();
        let worst = self.gather_some(&mut links, particles, place, multipliers, exponent);
        let divisor = (0..N).fold(S::ZERO, |divisor, lane| {
            let added = || Self::regularisation_of(&links, particles, place, lane, exponent);
            divisor.max(self.divisor::<UNIT_MASS, H>(worst, added))
        });
        self.eliminate_some::<N, UNIT_MASS>(&mut links, particles, place, divisor);
        let most = self.substitute_some::<N, UNIT_MASS>(&mut links, particles, place, multipliers);
        for lane in 0..N {
            if self.is_taut(most[lane], exponent) {
                self.correct_one(&links, particles, place, lane, exponent);
            }
        }
        let is_regularised = divisor > exponent.scaled(self.strength.divisor);
        if is_regularised { worst } else { S::ZERO }
    }

    /// Gathers the links of chains. Returns the largest residual; in floats, which need no bound, zero.
    #[inline(always)]
    fn gather_some<const N: usize>(
        &self,
        links: &mut Links<S, N, H>,
        particles: &Particles<S, W, H>,
        place: Place,
        multipliers: &Grid<S, W, H>,
        exponent: Exponent,
    ) -> S {
        let mut worst = S::ZERO;
        // pushed one by one, so that no link is initialised first
        for k in 0..place.count.saturating_sub(1) {
            let (above, below) = (place.row::<H>(k), place.row::<H>(k + 1));
            let [x, y] = [&particles.position.0[above], &particles.position.0[below]];
            let mut link = Link { normal: Vec3::row(Vec3::ZERO), change: [S::ZERO; N], factor: [S::ZERO; N] };
            for lane in 0..N {
                let [here, next] = [place.column::<N, W>(k) + lane, place.column::<N, W>(k + 1) + lane];
                let (excess, normal) = (y.at(next) - x.at(here)).direction(self.rest);
                let residual = excess - exponent.scaled(self.strength.times_divisor(multipliers.0[above][here]));
                if S::EXACT_SUMS {
                    worst = worst.max(residual.abs());
                }
                link.normal.set(lane, normal);
                link.change[lane] = residual;
            }
            _ = links.push(link); // there is space for all
        }
        worst
    }

    /// Eliminates down the chains.
    #[inline(always)]
    fn eliminate_some<const N: usize, const UNIT_MASS: bool>(
        &self,
        links: &mut Links<S, N, H>,
        particles: &Particles<S, W, H>,
        place: Place,
        divisor: S,
    ) {
        let (own, exponent) = (self.own(), self.exponent::<UNIT_MASS>());
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
                    let here = exponent.scaled(u[place.column::<N, W>(k) + lane]);
                    let next = exponent.scaled(v[place.column::<N, W>(k + 1) + lane]);
                    (coupling * here, here + next)
                };
                let diagonal = inverse_mass * own + divisor;
                (above[lane], link.factor[lane]) = above[lane].next::<UNIT_MASS>(diagonal, coupling, link.change[lane]);
                link.change[lane] = above[lane].right;
            }
            before = link.normal;
        }
    }

    /// Substitutes up the chains: adds the changes to the multipliers, and moves particles. Returns the largest change in each chain.
    #[inline(always)]
    fn substitute_some<const N: usize, const UNIT_MASS: bool>(
        &self,
        links: &mut Links<S, N, H>,
        particles: &mut Particles<S, W, H>,
        place: Place,
        multipliers: &mut Grid<S, W, H>,
    ) -> [S; N] {
        let [mut change, mut factor, mut most] = [[S::ZERO; N]; 3];
        let mut below = Vec3::<[S; N]>::row(Vec3::ZERO);
        for (k, link) in links.iter_mut().enumerate().rev() {
            let multipliers = &mut multipliers.0[place.row::<H>(k)];
            let (mut pull, mut by) = (below, below);
            for lane in 0..N {
                change[lane] = link.change[lane] + times::<UNIT_MASS, S, S>(change[lane], factor[lane]);
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
                multipliers[column] = multipliers[column].difference(-change[lane]); // does not wrap
            }
            self.displace_some::<N, UNIT_MASS>(particles, place, k + 1, by);
            (below, factor) = (pull, link.factor);
        }
        self.displace_some::<N, UNIT_MASS>(particles, place, 0, below);
        most
    }

    /// Moves particle `k` of each chain; `by` is the displacement for mass 1.
    #[inline(always)]
    fn displace_some<const N: usize, const UNIT_MASS: bool>(
        &self,
        particles: &mut Particles<S, W, H>,
        place: Place,
        k: usize,
        by: Vec3<[S; N]>,
    ) {
        let (row, exponent) = (place.row::<H>(k), self.exponent::<UNIT_MASS>());
        let w = &particles.inverse_mass.0[row];
        let (x, v) = (&mut particles.position.0[row], &mut particles.velocity.0[row]);
        for lane in 0..N {
            let column = place.column::<N, W>(k) + lane;
            let by = by.at(lane);
            displace(x, v, column, if UNIT_MASS { by } else { by * exponent.scaled(w[column]) }, self.moment);
        }
    }

    /// The regularisation of the chain `lane`, whose links have their residuals.
    #[cold]
    #[inline(never)]
    fn regularisation_of<const N: usize>(
        links: &[Link<S, N>],
        particles: &Particles<S, W, H>,
        place: Place,
        lane: usize,
        exponent: Exponent,
    ) -> S {
        let lane = lane.min(N - 1);
        let mut residual = [S::ZERO; H];
        residual.iter_mut().zip(links).for_each(|(residual, link)| *residual = link.change[lane]);
        regularisation(&residual, &Self::inverse_masses(particles, place, lane, exponent), place.count)
    }

    /// Adds the geometric stiffness correction to the chain `lane`.
    #[inline(never)] // few chains are that taut
    fn correct_one<const N: usize>(
        &self,
        links: &[Link<S, N>],
        particles: &mut Particles<S, W, H>,
        place: Place,
        lane: usize,
        exponent: Exponent,
    ) {
        let lane = lane.min(N - 1);
        let mut normal: Vec3<[S; H]> = Vec3::row(Vec3::ZERO);
        let mut change = [S::ZERO; H];
        for (k, link) in links.iter().enumerate().take(H) {
            normal.set(k, link.normal.at(lane));
            change[k] = link.change[lane];
        }
        self.add_geometric_stiffness(particles, place, lane, (&normal, &change), exponent);
    }

    fn inverse_masses(particles: &Particles<S, W, H>, place: Place, lane: usize, exponent: Exponent) -> [S; H] {
        core::array::from_fn(|k| {
            if k < place.count {
                exponent
                    .scaled(particles.inverse_mass.0[place.row::<H>(k)][(place.column::<1, W>(k) + lane).min(W - 1)])
            } else {
                S::ZERO
            }
        })
    }

    /// The same for links with these directions and changes of multipliers.
    #[inline(never)] // few chains are that taut
    pub(super) fn add_geometric_stiffness(
        &self,
        particles: &mut Particles<S, W, H>,
        place: Place,
        lane: usize,
        (normal, changes): (&Vec3<[S; H]>, &[S; H]),
        exponent: Exponent,
    ) {
        let tensions = changes.map(|change| self.strength.times_dividend(change));
        let w = Self::inverse_masses(particles, place, lane, exponent);
        let by = geometric_stiffness(normal, &tensions, &w, place.count, self.rest.inverse, exponent);
        for k in 0..place.count.min(H) {
            let (row, column) = (place.row::<H>(k), (place.column::<1, W>(k) + lane).min(W - 1));
            displace(&mut particles.position.0[row], &mut particles.velocity.0[row], column, by.at(k), self.moment);
        }
    }
}
