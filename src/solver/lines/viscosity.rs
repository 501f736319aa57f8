//! Implicit dampers, all at once.
//!
//! Within a substep, dampers diffuse velocities over the grid: `(1 + W·L)·v' = v`, with inverse masses W and the Laplacian L of all dampers, each weighted with its
//! `κ = k_d·h/m`. Explicit dampers explode where κ is large. Implicit ones taken one by one carry a motion no further than a link, and a sheet hangs in the air. Here rows and
//! then columns are solved exactly, with the strength of all families along them: `(1 + X)·(1 + Y)·v' = v` (D. Peaceman, H. Rachford, 1955). A diagonal counts as two links each
//! way, and a link over two cells as four. That is their effect on smooth motions, and no less than their effect on others, so further passes over the residual converge. Three
//! passes make the error of third order in κ.

use crate::grid::{Grid, Node};
use crate::link::{Family, Links, OneByOne, Order, Quotient, Visitor, fits, one_by_one};
use crate::scalar::Scalar;
use crate::vec3::Vec3;
use crate::vectors::Vectors;

use super::tridiagonal::twisted;

/// The number of passes that makes the rule in time one of second order.
pub(super) const PASSES: u32 = 3;

/// The least 1/κ in fixed point: the velocity differences that stronger dampers leave would have no digits.
const WEAKEST: f64 = 1.0 / 64.0;

/// Solves `(1 + W·L)·v' = v` approximately; more `passes` are more accurate.
#[inline(never)] // called twice
pub(super) fn diffuse<S: Scalar, L: Links<S>, const W: usize, const H: usize>(
    links: &L,
    inverse_mass: &Grid<S, W, H>,
    velocity: &mut Vectors<S, W, H>,
    axes: &Axes<S>,
    passes: u32,
) {
    let start = *velocity;
    axes.solve(inverse_mass, velocity);
    if passes < 2 {
        return;
    }
    let shift = axes.shift(&start);
    for _ in 1..passes {
        let mut rest = start;
        for node in Grid::<S, W, H>::nodes() {
            rest.set(node, (start.at(node) - velocity.at(node)).map(|v| v.halve_evenly(shift)));
        }
        links.dampers(&mut Brake { velocity, inverse_mass, rest: &mut rest, axes, shift });
        axes.solve(inverse_mass, &mut rest);
        for node in Grid::<S, W, H>::nodes() {
            velocity.add(node, rest.at(node).double(shift));
        }
    }
}

/// The least 1/κ that is solved. In floats it is a few rounding errors of the largest inverse mass: the last pivot of a row between two pins is nearly 1/κ alone.
#[inline(never)] // for any length: unrolled for a grid, the comparisons take very long to compile
fn weakest<S: Scalar>(inverse_mass: &[S]) -> S {
    if S::EXACT_SUMS {
        S::from_f64(WEAKEST)
    } else {
        inverse_mass.iter().fold(S::ONE, |most, &w| most.max(w)) * S::from_f64(8.0 * S::RESOLUTION)
    }
}

/// The strength of all dampers along rows and columns.
pub(super) struct Axes<S> {
    /// A velocity depends on its acceleration by response·h.
    response: S,
    /// The least 1/κ of a family.
    weakest: S,
    across: Quotient<S>,
    down: Quotient<S>,
}

/// Adds up the [`Axes`] of the families that have a link in the grid.
struct Sum<'a, S, const W: usize, const H: usize> {
    axes: Option<Axes<S>>,
    inverse_mass: &'a Grid<S, W, H>,
    response: S,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Sum<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        if fits::<ACROSS, DOWN, W, H>() {
            one_by_one::<S, ACROSS, DOWN>(self, family);
        }
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Sum<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let [across, down] = order.offset();
        let axes = self.axes.get_or_insert_with(|| Axes {
            response: self.response,
            weakest: weakest(self.inverse_mass.0.as_flattened()),
            across: none(),
            down: none(),
        });
        let strength = axes.strength(family);
        let links = if across > 0 && down > 0 { 2 } else { 1 };
        for _ in 0..links * across * across {
            axes.across = axes.across.plus(strength);
        }
        for _ in 0..links * down * down {
            axes.down = axes.down.plus(strength);
        }
    }
}

/// Subtracts W·L·v' from the residual `rest`, which is in units of 2^shift.
struct Brake<'a, S, const W: usize, const H: usize> {
    velocity: &'a Vectors<S, W, H>,
    inverse_mass: &'a Grid<S, W, H>,
    rest: &'a mut Vectors<S, W, H>,
    axes: &'a Axes<S>,
    shift: u32,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Brake<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Brake<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let Quotient { dividend, divisor } = self.axes.strength(family);
        let strength = dividend.halve(self.shift).divide(divisor);
        order.each::<W, H>(|a, b| {
            let by = (self.velocity.at(b) - self.velocity.at(a)) * strength;
            self.rest.add(a, by * self.inverse_mass[a]);
            self.rest.add(b, -(by * self.inverse_mass[b]));
        });
    }
}

/// No damper.
const fn none<S: Scalar>() -> Quotient<S> {
    Quotient { dividend: S::ZERO, divisor: S::ONE }
}

impl<S: Scalar> Axes<S> {
    /// `None` without dampers: a scene that is assembled at run time may have none.
    pub(super) fn of<const W: usize, const H: usize>(
        links: &impl Links<S>,
        inverse_mass: &Grid<S, W, H>,
        response: S,
    ) -> Option<Self> {
        let mut sum = Sum { axes: None, inverse_mass, response };
        links.dampers(&mut sum);
        sum.axes.filter(|axes| axes.across.dividend > S::ZERO || axes.down.dividend > S::ZERO)
    }

    /// κ of a family.
    fn strength(&self, family: &Family<S>) -> Quotient<S> {
        let strength = family.strength.scaled(self.response);
        Quotient { divisor: strength.divisor.max(self.weakest), ..strength }
    }

    /// The logarithm to base 2 of a unit in which the velocity changes by dampers fit fixed point, for particles with such velocities.
    fn shift<const W: usize, const H: usize>(&self, velocity: &Vectors<S, W, H>) -> u32 {
        let mut shift = 0;
        let all = self.across.plus(self.down);
        let most = all.dividend * velocity.largest().halve(2).max(S::ONE.halve(6));
        while !most.is_within(all.divisor.double(shift)) {
            shift += 1;
        }
        shift
    }

    /// Solves `(1 + X)·(1 + Y)·v' = v`.
    fn solve<const W: usize, const H: usize>(&self, inverse_mass: &Grid<S, W, H>, v: &mut Vectors<S, W, H>) {
        if self.across.dividend != S::ZERO {
            for (masses, row) in inverse_mass.0.iter().zip(&mut v.0) {
                solve_line(self.across, masses, row);
            }
        }
        if self.down.dividend != S::ZERO {
            for column in 0..W {
                let node = |row| Node { column, row };
                let mut line = Vec3::<[S; H]>::row(Vec3::ZERO);
                (0..H).for_each(|row| line.set(row, v.at(node(row))));
                solve_line(self.down, &core::array::from_fn(|row| inverse_mass[node(row)]), &mut line);
                (0..H).for_each(|row| v.set(node(row), line.at(row)));
            }
        }
    }
}

/// Solves a row or a column for the impulse μ of each damper, in units of the strength's dividend a:
/// `(b + a·(w_i + w_{i+1}))·μ_i − a·w_i·μ_{i−1} − a·w_{i+1}·μ_{i+1} = v_{i+1} − v_i`. Impulses keep momentum to the last place, and no pivot vanishes with b.
fn solve_line<S: Scalar, const N: usize>(strength: Quotient<S>, w: &[S; N], v: &mut Vec3<[S; N]>) {
    let Quotient { dividend, divisor } = strength;
    let impulse: [Vec3<S>; N] = twisted::<false, S, Vec3<S>, N>(
        |k| divisor + (w[k] + w[k + 1]) * dividend,
        |k| w[k + 1] * dividend,
        |k| v.at(k + 1) - v.at(k),
    );
    let mut before = Vec3::ZERO;
    for k in 0..N {
        let by = impulse[k] * dividend;
        v.add(k, (by - before) * w[k]);
        before = by;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::link::{Bend, Damped, Shear, Stretch};
    use crate::scalar::Q24;
    use crate::units::Units;

    const W: usize = 8;
    const H: usize = 5;
    const UNITS: Units = Units::sheet([W, H], [0.7, 0.4], 1e-3, 1.0 / 60.0, 1);

    /// Dampers of strength κ, half and a quarter of it.
    fn dampers<S: Scalar>(kappa: f64) -> impl Links<S> {
        let strength = |part: f64| UNITS.damping(part * kappa * 1e-3 * 60.0);
        (
            Damped::new(Stretch::new(&UNITS, UNITS.stiffness(1.0)), strength(1.0)),
            Damped::new(Shear::new(&UNITS, UNITS.stiffness(1.0)), strength(0.5)),
            Damped::new(Bend::new(&UNITS, UNITS.stiffness(1.0)), strength(0.25)),
        )
    }

    fn number(k: usize) -> f64 {
        (k as f64 * 7.3).sin()
    }

    fn velocities<S: Scalar>() -> Vectors<S, W, H> {
        let mut velocity = Vectors::filled(Vec3::ZERO);
        for (k, node) in Grid::<S, W, H>::nodes().enumerate() {
            velocity.set(node, Vec3::from_f64([number(3 * k), number(3 * k + 1), number(3 * k + 2)]));
        }
        velocity
    }

    /// Free particles of three masses, and two pins.
    fn masses<S: Scalar>() -> Grid<S, W, H> {
        let mut w = Grid::filled(S::ONE);
        for (k, w) in w.values_mut().enumerate() {
            *w = S::from_f64([1.0, 0.25, 2.0][k % 3]);
        }
        w[Node::new(0, 0)] = S::ZERO;
        w[Node::new(W - 1, 0)] = S::ZERO;
        w
    }

    /// The root mean square of the residual `v − (1 + W·L)·v'`.
    fn left_over<L: Links<f64>>(
        links: &L,
        w: &Grid<f64, W, H>,
        v: &Vectors<f64, W, H>,
        end: &Vectors<f64, W, H>,
    ) -> f64 {
        let mut rest = *v;
        for node in Grid::<f64, W, H>::nodes() {
            rest.set(node, v.at(node) - end.at(node));
        }
        let axes = Axes::of(links, w, 1.0).unwrap();
        links.dampers(&mut Brake { velocity: end, inverse_mass: w, rest: &mut rest, axes: &axes, shift: 0 });
        (rest.values().map(|v| v.dot(v)).sum::<f64>() / (W * H) as f64).sqrt()
    }

    #[test]
    fn dampers_along_rows_or_along_columns_are_solved_exactly() {
        for axis in 0..2 {
            let (w, v) = (masses(), velocities());
            let kappa = Quotient { dividend: 1.0, divisor: 0.2 };
            let axes = Axes { response: 1.0, weakest: 0.0, across: [kappa, none()][axis], down: [none(), kappa][axis] };
            let mut end = v;
            axes.solve(&w, &mut end);
            for node in Grid::<f64, W, H>::nodes() {
                let [column, row] = [node.column, node.row];
                let [here, extent] = [[column, W], [row, H]][axis];
                let mut sum = end.at(node);
                for (there, neighbour) in [(here > 0, here.wrapping_sub(1)), (here + 1 < extent, here + 1)] {
                    if there {
                        let neighbour = [Node::new(neighbour, row), Node::new(column, neighbour)][axis];
                        sum += (end.at(node) - end.at(neighbour)) * (5.0 * w[node]);
                    }
                }
                let error = (sum - v.at(node)).length();
                assert!(error < 1e-13, "{node:?} along axis {axis}: {error:e}");
            }
        }
    }

    #[test]
    fn passes_converge() {
        let (w, v) = (masses(), velocities());
        for (kappa, most) in [(0.003, 3e-5), (0.03, 1e-2), (0.3, 0.3)] {
            let links = dampers(kappa);
            let mut before = f64::MAX;
            for passes in 1..30 {
                let mut end = v;
                diffuse(&links, &w, &mut end, &Axes::of(&links, &w, 1.0).unwrap(), passes);
                let found = left_over(&links, &w, &v, &end);
                assert!(found <= before.max(1e-14), "κ = {kappa}, {passes} passes: {found:e} after {before:e}");
                assert!(passes != PASSES || found < most, "κ = {kappa}: {found:e}");
                before = found;
            }
        }
    }

    #[test]
    fn dampers_of_any_strength_take_energy() {
        fn check<S: Scalar>() {
            let (w, v) = (masses::<S>(), velocities::<S>());
            let energy = |v: &Vectors<S, W, H>| -> f64 {
                let free = v.values().zip(w.values()).filter(|(_, w)| **w > S::ZERO);
                free.map(|(v, w)| v.to_f64().map(|x| x * x).iter().sum::<f64>() / w.to_f64()).sum()
            };
            for kappa in [1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e4, 1e8] {
                let links = dampers(kappa);
                for passes in [1, PASSES] {
                    let mut end = v;
                    diffuse(&links, &w, &mut end, &Axes::of(&links, &w, S::ONE).unwrap(), passes);
                    let after = energy(&end);
                    assert!(after < energy(&v), "κ = {kappa}, {passes} passes in {}: {after}", S::NAME);
                }
            }
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }

    #[test]
    fn fixed_point_keeps_momentum_to_the_last_place() {
        let momentum = |v: &Vectors<Q24, W, H>| v.values().fold(Vec3::ZERO, |sum, v| sum + v);
        for kappa in [0.01, 0.1, 0.5] {
            let (v, w) = (velocities::<Q24>(), Grid::filled(Q24::ONE));
            let mut end = v;
            let links = dampers(kappa);
            diffuse(&links, &w, &mut end, &Axes::of(&links, &w, Q24::ONE).unwrap(), PASSES);
            assert_eq!(momentum(&v), momentum(&end), "κ = {kappa}");
            assert!(end != v);
        }
    }

    #[test]
    fn what_moves_as_a_whole_is_not_damped() {
        let v = Vec3::from_f64([0.1, -2.3, 4.5]);
        let mut velocity = Vectors::<Q24, W, H>::filled(v);
        let links = dampers(3.0);
        let w = Grid::filled(Q24::ONE);
        diffuse(&links, &w, &mut velocity, &Axes::of(&links, &w, Q24::ONE).unwrap(), PASSES);
        assert!(velocity.values().all(|found| found == v));
    }

    #[test]
    fn a_mirrored_sheet_is_damped_as_the_mirror_image() {
        let mirrored = |v: &Vectors<f32, W, H>| {
            let mut image = *v;
            for node in Grid::<f32, W, H>::nodes() {
                image.set(node, v.at(Node::new(W - 1 - node.column, node.row)));
            }
            image
        };
        let run = |mut v: Vectors<f32, W, H>| {
            let links = dampers(2.0);
            let w = Grid::filled(1.0);
            diffuse(&links, &w, &mut v, &Axes::of(&links, &w, 1.0).unwrap(), PASSES);
            v
        };
        let v = velocities();
        assert!(mirrored(&run(v)) == run(mirrored(&v)));
    }
}
