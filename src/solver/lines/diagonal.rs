//! Exact solves of the diagonals of the cells.
//!
//! Diagonals relaxed one by one between exact rows and columns would limit the convergence of the sweeps. A falling and a rising diagonal share a particle, so one of them has
//! to be solved after the other. In the order "all falling ones, then all rising ones", a mirrored sheet would not move as the mirror image. Instead, cells are coloured like a
//! chess board: the diagonals through black cells share no particle with one another, and neither do those through white cells. So both kinds of one colour are solved at once,
//! then those of the other; for even widths, a mirror maps each colour to itself.
//!
//! A multiplier is kept in the grid of its cell's colour, at the link's upper particle. In every row, the links of a colour join two neighbours and the two below them,
//! crosswise: their lower ends are the row below with the two particles of each pair [exchanged](crossed). Machines with vector instructions eliminate down the rows, all
//! diagonals of a colour side by side, which takes five numbers a particle on the stack (80 KB for 64 × 64 in `f32`). Other machines solve one diagonal after the other, in
//! five numbers a row. Both give the same bits.

use heapless::Vec;

use crate::grid::Grid;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::solver::aside::displace_row;
use crate::vec3::Vec3;

use super::chain::{Chain, skips_masses};
use super::exponent::Exponent;
use super::place::each_diagonal;
use super::tridiagonal::Eliminated;

impl<S: Scalar, const W: usize, const H: usize> Chain<'_, S, W, H> {
    /// Solves every diagonal. Returns the largest residual of the regularised diagonals, which are far from solved.
    #[inline(never)] // one copy for all scenes of a grid
    pub(super) fn diagonals(&self, particles: &mut Particles<S, W, H>, multipliers: [&mut Grid<S, W, H>; 2]) -> S {
        let mut unsolved = S::ZERO;
        if W > 1 && H > 1 {
            for (colour, multipliers) in multipliers.into_iter().enumerate() {
                if const { skips_masses::<S>() } {
                    unsolved = unsolved.max(self.diagonals_one_by_one(particles, colour, multipliers));
                } else {
                    self.diagonals_at_once(particles, colour, multipliers);
                }
            }
        }
        unsolved
    }

    /// Solves the diagonals of one colour, in floats.
    #[inline(never)] // so that the compiler knows that sheet and multipliers don't alias
    fn diagonals_at_once(&self, particles: &mut Particles<S, W, H>, colour: usize, multipliers: &mut Grid<S, W, H>) {
        let mut above = Above { normal: Vec3::row(Vec3::ZERO), per_pivot: [S::ZERO; W], right: [S::ZERO; W] };
        // pushed one by one, so that no row is initialised first
        let mut links = Vec::<Links<S, W>, H>::new();
        for row in 1..H {
            let [x, y] = [row - 1, row].map(|row| &particles.position.0[row]);
            let [u, v] = [row - 1, row].map(|row| &particles.inverse_mass.0[row]);
            let multipliers = &multipliers.0[row - 1];
            let row = if (row + colour) % 2 == 1 {
                self.eliminate::<0>(&mut above, [x, y], [u, v], multipliers)
            } else {
                self.eliminate::<1>(&mut above, [x, y], [u, v], multipliers)
            };
            _ = links.push(row); // there is space for all
        }
        let mut factor = [S::ZERO; W];
        let mut below = Below { change: [S::ZERO; W], pull: Vec3::row(Vec3::ZERO), most: [S::ZERO; W] };
        for (row, links) in (1..H).zip(&mut links).rev() {
            let multipliers = &mut multipliers.0[row - 1];
            let by = if (row + colour) % 2 == 1 {
                self.substitute::<0>(&mut below, &factor, links, multipliers)
            } else {
                self.substitute::<1>(&mut below, &factor, links, multipliers)
            };
            factor = links.factor;
            self.displace(particles, row, by);
        }
        self.displace(particles, 0, below.pull);
        let most = below.most.iter().fold(S::ZERO, |most, lane| most.max(*lane));
        if self.is_taut(most, Exponent::NONE) {
            self.correct_diagonals(particles, colour, &links);
        }
    }

    /// Eliminates the links between two rows with these positions and inverse masses.
    #[inline(never)] // so that the compiler knows that rows don't alias
    fn eliminate<const PARITY: usize>(
        &self,
        above: &mut Above<S, W>,
        [x, y]: [&Vec3<[S; W]>; 2],
        [u, v]: [&[S; W]; 2],
        multipliers: &[S; W],
    ) -> Links<S, W> {
        let (dividend, divisor) = (self.strength.dividend, self.strength.divisor);
        let own = self.own();
        let (ends, w) = (y.components(crossed::<PARITY, S, W>), crossed::<PARITY, S, W>(v));
        let [mut change, mut factor, mut per_pivot] = [[S::ZERO; W]; 3];
        let mut normal = Vec3::row(Vec3::ZERO);
        for lane in 0..W {
            let (excess, along) = (ends.at(lane) - x.at(lane)).direction(self.rest);
            change[lane] = excess - self.strength.times_divisor(multipliers[lane]);
            normal.set(lane, along);
        }
        for lane in alone::<W>(PARITY) {
            normal.set(lane, Vec3::ZERO);
            change[lane] = S::ZERO;
        }
        for lane in 0..W {
            let coupling = above.normal.at(lane).cosine(normal.at(lane)).scaled(dividend) * u[lane];
            let diagonal = (u[lane] + w[lane]) * own + divisor;
            let next;
            (next, factor[lane]) = Eliminated { per_pivot: above.per_pivot[lane], right: above.right[lane] }
                .next::<false>(diagonal, coupling, change[lane]);
            (per_pivot[lane], change[lane]) = (next.per_pivot, next.right);
        }
        *above = Above {
            per_pivot: crossed::<PARITY, S, W>(&per_pivot),
            right: crossed::<PARITY, S, W>(&change),
            normal: normal.components(crossed::<PARITY, S, W>),
        };
        Links { normal, factor, change }
    }

    /// Finds the changes of the multipliers of the links to a row from the links `below` it and their `factor`. Returns the displacements of the row for particles of mass 1.
    #[inline(never)] // so that the compiler knows that rows don't alias
    fn substitute<const PARITY: usize>(
        &self,
        below: &mut Below<S, W>,
        factor: &[S; W],
        links: &mut Links<S, W>,
        multipliers: &mut [S; W],
    ) -> Vec3<[S; W]> {
        let mut part = [S::ZERO; W];
        for lane in 0..W {
            part[lane] = below.change[lane] * factor[lane];
        }
        let part = crossed::<PARITY, S, W>(&part);
        let mut pull = Vec3::row(Vec3::ZERO);
        for lane in 0..W {
            let change = links.change[lane] + part[lane];
            links.change[lane] = change;
            below.change[lane] = change;
            below.most[lane] = below.most[lane].max(change);
            multipliers[lane] += change;
            pull.set(lane, links.normal.at(lane).of_length(self.strength.times_dividend(change), self.rounding));
        }
        let above = pull.components(crossed::<PARITY, S, W>);
        let mut by = core::mem::replace(&mut below.pull, pull);
        for lane in 0..W {
            by.set(lane, by.at(lane) - above.at(lane));
        }
        by
    }

    /// Moves a row; `by` is the displacement for particles of mass 1.
    #[inline(never)] // so that the compiler knows that rows don't alias
    fn displace(&self, particles: &mut Particles<S, W, H>, row: usize, by: Vec3<[S; W]>) {
        let w = particles.inverse_mass.0[row];
        displace_row(particles, row, |column| by.at(column) * w[column], self.moment);
    }

    /// Adds the geometric stiffness correction to the taut diagonals of one colour, for links with these directions and changes of multipliers.
    #[inline(never)] // few are that taut
    fn correct_diagonals(&self, particles: &mut Particles<S, W, H>, colour: usize, links: &[Links<S, W>]) {
        each_diagonal::<W, H>(colour, |place| {
            let mut normal: Vec3<[S; H]> = Vec3::row(Vec3::ZERO);
            let mut change = [S::ZERO; H];
            let mut most = S::ZERO;
            for k in 0..place.count - 1 {
                let (links, lane) = (&links[place.top + k], place.column::<1, W>(k));
                normal.set(k, links.normal.at(lane));
                change[k] = links.change[lane];
                most = most.max(change[k]);
            }
            if self.is_taut(most, Exponent::NONE) {
                self.add_geometric_stiffness(particles, place, 0, (&normal, &change), Exponent::NONE);
            }
        });
    }
}

/// The eliminated links that start in a row.
#[derive(Clone, Copy)]
struct Links<S, const W: usize> {
    normal: Vec3<[S; W]>,
    /// The factor with which a link's change enters that of the link above.
    factor: [S; W],
    /// The eliminated right side, in the end the change of the multiplier.
    change: [S; W],
}

/// The eliminated links that end in a row, in the columns where they end.
struct Above<S, const W: usize> {
    normal: Vec3<[S; W]>,
    per_pivot: [S; W],
    right: [S; W],
}

/// The substituted links that start in a row.
struct Below<S, const W: usize> {
    change: [S; W],
    pull: Vec3<[S; W]>,
    /// The largest change so far.
    most: [S; W],
}

/// The row with neighbours swapped in pairs, the first of which starts in column `PARITY`; zero where there is no partner.
#[inline(always)]
fn crossed<const PARITY: usize, S: Scalar, const W: usize>(row: &[S; W]) -> [S; W] {
    core::array::from_fn(|column| {
        let partner = if column % 2 == PARITY { column + 1 } else { column.wrapping_sub(1) };
        row.get(partner).copied().unwrap_or(S::ZERO)
    })
}

/// The columns that belong to no pair.
#[inline(always)]
fn alone<const W: usize>(parity: usize) -> impl Iterator<Item = usize> {
    let first = (parity == 1).then_some(0);
    let last = ((W - parity) % 2 == 1).then_some(W - 1);
    first.into_iter().chain(last)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Node;
    use crate::link::Quotient;
    use crate::moment::Moment;
    use crate::scalar::{Q13, Q24, Rest};
    use crate::solver::unit_mass::UnitMass;

    const MOMENT: Moment = Moment { substep: 1, substeps: 1, shift: 0, halves: 3 };

    /// A crumpled sheet with two pins and particles of three masses, mirrored or not.
    fn crumpled<S: Scalar, const W: usize, const H: usize>(mirrored: bool) -> Particles<S, W, H> {
        let mut particles = Particles::BLANK;
        for (k, node) in Grid::<S, W, H>::nodes().enumerate() {
            let number = |of: usize| 0.2 * libm::sin((7 * k + of) as f64);
            let column = if mirrored { W - 1 - node.column } else { node.column };
            let x = node.column as f64 - 0.5 * (W - 1) as f64 + number(1);
            let place = Node { column, ..node };
            let place_of = |x| Vec3::from_f64([x, node.row as f64 + number(2), number(3)]);
            particles.position.set(place, place_of(if mirrored { -x } else { x }));
            particles.inverse_mass[place] = S::from_f64([1.0, 0.5, 2.0][k % 3]);
        }
        for column in [0, W - 1] {
            particles.inverse_mass[Node { column, row: 0 }] = S::ZERO;
        }
        particles
    }

    fn with_chain<S: Scalar, const W: usize, const H: usize, T>(
        particles: &mut Particles<S, W, H>,
        act: impl FnOnce(&Chain<'_, S, W, H>, &mut Particles<S, W, H>) -> T,
    ) -> T {
        let unit_mass = UnitMass::new(particles);
        let (exponent, span, _) = Exponent::new(particles, &unit_mass.rows);
        let rest = Rest::spanning(S::ONE, S::ONE);
        let strength = Quotient { dividend: S::ONE, divisor: S::from_f64(1e-3) };
        let (moment, rounding) = (MOMENT, MOMENT.rounding());
        act(&Chain { rest: &rest, strength, moment, rounding, unit_mass: &unit_mass, exponent, span }, particles)
    }

    fn both_ways<const W: usize, const H: usize>() {
        let run = |at_once: bool| {
            let mut particles = crumpled::<f32, W, H>(false);
            let mut multipliers = [Grid::filled(0.0); 2];
            with_chain(&mut particles, |chain, particles| {
                for _ in 0..3 {
                    for (colour, multipliers) in multipliers.iter_mut().enumerate() {
                        if at_once {
                            chain.diagonals_at_once(particles, colour, multipliers);
                        } else {
                            chain.diagonals_one_by_one(particles, colour, multipliers);
                        }
                    }
                }
            });
            (particles, multipliers)
        };
        assert!(run(true) == run(false), "{W} × {H}");
    }

    #[test]
    fn machines_that_compute_several_numbers_at_once_find_the_same_bits() {
        both_ways::<8, 6>();
        both_ways::<9, 7>();
        both_ways::<6, 12>();
        both_ways::<2, 5>();
        both_ways::<3, 2>();
    }

    #[test]
    fn a_mirrored_sheet_is_solved_as_the_mirror_image() {
        fn run<const W: usize, const H: usize>(mirrored: bool) -> Particles<f64, W, H> {
            let mut particles = crumpled::<f64, W, H>(mirrored);
            let [mut black, mut white] = [Grid::filled(0.0); 2];
            with_chain(&mut particles, |chain, particles| {
                chain.diagonals(particles, [&mut black, &mut white]);
            });
            particles
        }
        let [plain, mirrored] = [false, true].map(run::<8, 6>);
        for node in Grid::<f64, 8, 6>::nodes() {
            let Vec3 { x, y, z } = mirrored.position.at(Node { column: 7 - node.column, ..node });
            assert_eq!(plain.position.at(node), Vec3::new(-x, y, z), "{node:?}");
        }
    }

    /// The largest strain of the links along diagonals of one colour.
    fn strain<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>, colour: usize) -> f64 {
        let mut largest = 0.0_f64;
        each_diagonal::<W, H>(colour, |place| {
            for k in 0..place.count - 1 {
                let [a, b] = [k, k + 1].map(|k| Node { column: place.column::<1, W>(k), row: place.top + k });
                let length = (particles.position.at(b) - particles.position.at(a)).length().to_f64();
                largest = largest.max((length / core::f64::consts::SQRT_2 - 1.0).abs());
            }
        });
        largest
    }

    #[test]
    fn diagonals_of_a_colour_are_solved_at_once() {
        fn check<S: Scalar>() {
            let mut particles = crumpled::<S, 7, 9>(false);
            let mut multipliers = [Grid::filled(S::ZERO); 2];
            with_chain(&mut particles, |chain, particles| {
                let before = strain(particles, 1);
                for _ in 0..4 {
                    let [black, white] = &mut multipliers;
                    chain.diagonals(particles, [black, white]);
                }
                // the last colour solved; the first pass left a residual because links turn
                let after = strain(particles, 1);
                assert!(before > 0.1 && after < 0.01, "{}: {before} {after}", S::NAME);
            });
        }
        check::<f32>();
        check::<f64>();
        check::<Q24>();
        check::<Q13>();
    }
}
