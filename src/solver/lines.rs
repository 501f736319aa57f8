//! The line solver: every row and every column of stretch links solved exactly, in second order.
//!
//! A row (or column) of links is a chain. With unit normals n, inverse masses w and the compliance α̃ = 1/κ its linearised constraints
//! form a tridiagonal system in the multipliers λ,
//!
//! `−w_i·(n_{i−1}·n_i)·λ_{i−1} + (w_i + w_{i+1} + α̃)·λ_i − w_{i+1}·(n_i·n_{i+1})·λ_{i+1} = |d_i| − L`,
//!
//! which one pass down and one up solve (L. Thomas, 1949): exact along the whole chain, where Gauss–Seidel carries news one link a sweep.
//!
//! A substep predicts with BDF2 (C. Curtiss, J. Hirschfelder, 1952), projects the other families once, then all rows, then all columns. What
//! couples rows and columns is carried over from substep to substep: the columns' multipliers act, at a part of their last strength, before the rows are solved.

use crate::cloth::Cloth;
use crate::collider::Collider;
use crate::force::{Force, Row};
use crate::grid::{Grid, Node};
use crate::link::{Family, Links, Quotient, Visitor, each};
use crate::moment::Moment;
use crate::scalar::Scalar;
use crate::solver::{Physics, Solver, confine, predict, sweep};
use crate::vec3::Vec3;

/// Second order in time, exact along rows and columns, stable for any stiffness and step: the solver for nearly inextensible sheets.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lines;

/// What BDF2 and the warm start remember.
#[derive(Clone, Copy, Debug)]
pub struct Memory<S, const W: usize, const H: usize> {
    /// The displacement of the last substep, cells.
    moved: Grid<Vec3<S>, W, H>,
    /// The velocity before the last substep, cells per tick.
    earlier: Grid<Vec3<S>, W, H>,
    /// The multiplier of the link to the particle below, cells.
    tension: Grid<S, W, H>,
    /// Whether the last substep ended near a solution, so that the next may build on it.
    smooth: bool,
    /// 3 after a step of BDF2, 2 after one of backward Euler.
    halves: u32,
}

/// The part of the last multipliers from which columns start. At 0.9 a sheet on two corners swings up.
const WARM: f64 = 0.5;

/// The strain error of a row, after the columns have been solved, from which on the next substep is backward Euler: BDF2 doesn't recover
/// from a scrambled sheet.
const ROUGH: f64 = 0.05;

impl<S: Scalar> Solver<S> for Lines {
    type Memory<const W: usize, const H: usize> = Memory<S, W, H>;

    fn memory<const W: usize, const H: usize>(&self) -> Self::Memory<W, H> {
        let zero = Grid::filled(Vec3::ZERO);
        Memory { moved: zero, earlier: zero, tension: Grid::filled(S::ZERO), smooth: false, halves: 2 }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        cloth: &mut Cloth<S, W, H>,
        memory: &mut Self::Memory<W, H>,
        moment: Moment,
    ) {
        let second = memory.smooth;
        let moment = Moment { halves: if second { 3 } else { 2 }, ..moment };
        predict::damp(physics.links, cloth);
        if second {
            predict_second(physics.forces, cloth, memory, moment);
        } else {
            predict_first(physics.forces, cloth, memory, moment);
        }
        memory.halves = moment.halves;
        let drag = physics.forces.drag().rate;
        // κ of a BDF2 step: h_eff² = (4/9)·h²/(1 + (2/3)·γ·h); of backward Euler: h²/(1 + γ·h)
        let four_ninths = S::from_int(4).divide(S::from_int(9));
        let two_thirds = S::from_int(2).divide(S::from_int(3));
        let softness = if second { four_ninths.divide(S::ONE + two_thirds * drag) } else { (S::ONE + drag).recip() };
        sweep::sweep_soft(physics.links, cloth, moment, softness);
        let mut solve = Solve { cloth, memory, moment, softness, pass: 0, rough: false };
        physics.links.springs(&mut solve);
        solve.pass = 1;
        physics.links.springs(&mut solve);
        memory.smooth = !solve.rough;
        confine(physics, cloth, moment);
    }
}

/// The last substep's displacement, from how it was made.
#[inline]
fn last_moved<S: Scalar>(halves: u32, third: S, before: Vec3<S>, velocity: Vec3<S>, shift: u32) -> Vec3<S> {
    let drift = velocity.halve(shift);
    if halves == 3 { (before + drift + drift) * third } else { drift }
}

fn predict_first<S: Scalar, F: Force<S>, const W: usize, const H: usize>(
    forces: &F,
    cloth: &mut Cloth<S, W, H>,
    memory: &mut Memory<S, W, H>,
    moment: Moment,
) {
    let third = S::ONE.divide(S::from_int(3));
    for node in Grid::<S, W, H>::nodes() {
        let v = cloth.velocity[node];
        memory.moved[node] = last_moved(memory.halves, third, memory.moved[node], v, moment.shift);
        memory.earlier[node] = v;
    }
    let slowed = (S::ONE + forces.drag().rate).recip();
    predict::predict(
        forces,
        cloth,
        moment.shift,
        |velocity, gain| {
            if F::DRAG { (velocity + gain) * slowed } else { velocity + gain }
        },
    );
}

/// `v̂ = (v + (v − v₋)/3 + (2/3)·gain)/(1 + (2/3)·γ·h)`, `x̂ = x + ((x − x₋) + 2·h·v̂)/3`.
fn predict_second<S: Scalar, F: Force<S>, const W: usize, const H: usize>(
    forces: &F,
    cloth: &mut Cloth<S, W, H>,
    memory: &mut Memory<S, W, H>,
    moment: Moment,
) {
    let third = S::ONE.divide(S::from_int(3));
    let two_thirds = third + third;
    let slowed = (S::ONE + two_thirds * forces.drag().rate).recip();
    let uniform = forces.uniform();
    let mut gain = [Vec3::ZERO; W];
    let mut above = if F::FIELD { Some(extrapolated(cloth, memory, 0, third, moment.shift)) } else { None };
    for row in 0..H {
        let mut below_gain = [Vec3::ZERO; W];
        if let Some((x, v)) = &above {
            let here = Row { position: x, velocity: v };
            forces.particles(here, &mut gain);
            let next = if row + 1 < H { Some(extrapolated(cloth, memory, row + 1, third, moment.shift)) } else { None };
            if let Some((x, v)) = &next {
                forces.cells([here, Row { position: x, velocity: v }], [&mut gain, &mut below_gain]);
            }
            above = next;
        }
        for column in 0..W {
            let node = Node { column, row };
            let inverse_mass = cloth.inverse_mass[node];
            let v = cloth.velocity[node];
            let moved = last_moved(memory.halves, third, memory.moved[node], v, moment.shift);
            memory.moved[node] = moved;
            if inverse_mass == S::ZERO {
                memory.earlier[node] = v;
                cloth.position[node] += v.halve(moment.shift);
                continue;
            }
            let gain = if F::FIELD { gain[column] * inverse_mass + uniform } else { uniform };
            let mut next = v + (v - memory.earlier[node]) * third + gain * two_thirds;
            if F::DRAG {
                next = next * slowed;
            }
            memory.earlier[node] = v;
            cloth.velocity[node] = next;
            let drift = next.halve(moment.shift);
            cloth.position[node] += (moved + drift + drift) * third;
        }
        gain = below_gain;
    }
}

/// A row's positions and velocities at the end of the substep, extrapolated from the last two: wind at the start alone would be of first order.
#[inline]
fn extrapolated<S: Scalar, const W: usize, const H: usize>(
    cloth: &Cloth<S, W, H>,
    memory: &Memory<S, W, H>,
    row: usize,
    third: S,
    shift: u32,
) -> ([Vec3<S>; W], [Vec3<S>; W]) {
    let (mut x, mut v) = (cloth.position.0[row], cloth.velocity.0[row]);
    for column in 0..W {
        x[column] += last_moved(memory.halves, third, memory.moved.0[row][column], v[column], shift);
        let change = v[column] - memory.earlier.0[row][column];
        v[column] += change;
    }
    (x, v)
}

/// Sees the stretch family: first its rows, then its columns.
struct Solve<'a, S, const W: usize, const H: usize> {
    cloth: &'a mut Cloth<S, W, H>,
    memory: &'a mut Memory<S, W, H>,
    moment: Moment,
    softness: S,
    pass: u32,
    rough: bool,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Solve<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        if ACROSS == 1 && DOWN == 0 {
            if self.pass == 0 { self.rows(family) } else { self.check(family) }
        }
        if ACROSS == 0 && DOWN == 1 && self.pass == 0 {
            self.columns(family);
        }
    }
}

impl<S: Scalar, const W: usize, const H: usize> Solve<'_, S, W, H> {
    fn rows(&mut self, family: &Family<S>) {
        // columns pull already, at a part of their last strength
        let warm = S::from_f64(WARM);
        let strength = family.strength.scaled(self.softness);
        for row in 0..H.saturating_sub(1) {
            for column in 0..W {
                let (a, b) = (Node { column, row }, Node { column, row: row + 1 });
                let tension = self.memory.tension[a] * warm;
                self.memory.tension[a] = tension;
                let d = self.cloth.position[b] - self.cloth.position[a];
                let (_, inverse) = S::gauge(d.squared(), &family.rest);
                self.cloth.pull(a, b, d * (inverse * tension * strength.dividend), self.moment);
            }
        }
        for row in 0..H {
            let mut none = [S::ZERO; W];
            chain(family, strength, self.cloth, |column| Node { column, row }, &mut none, self.moment);
        }
    }

    fn check(&mut self, family: &Family<S>) {
        let longest = family.rest.length + family.rest.length * S::from_f64(ROUGH);
        let shortest = family.rest.length - family.rest.length * S::from_f64(ROUGH);
        let (longest, shortest) = (longest.product(longest), shortest.product(shortest));
        each::<1, 0, W, H>(|a, b| {
            let squared = (self.cloth.position[b] - self.cloth.position[a]).squared();
            self.rough |= squared > longest || squared < shortest;
        });
    }

    fn columns(&mut self, family: &Family<S>) {
        let strength = family.strength.scaled(self.softness);
        for column in 0..W {
            let mut tension: [S; H] = core::array::from_fn(|row| self.memory.tension.0[row][column]);
            chain(family, strength, self.cloth, |row| Node { column, row }, &mut tension, self.moment);
            for row in 0..H {
                self.memory.tension.0[row][column] = tension[row];
            }
        }
    }
}

/// Solves one chain of `N` particles and moves them; `tension` holds the multipliers.
#[inline]
fn chain<S: Scalar, const N: usize, const W: usize, const H: usize>(
    family: &Family<S>,
    strength: Quotient<S>,
    cloth: &mut Cloth<S, W, H>,
    node: impl Fn(usize) -> Node,
    tension: &mut [S; N],
    moment: Moment,
) {
    if N < 2 {
        return;
    }
    let Quotient { dividend, divisor } = strength;
    let mut normals = [Vec3::<S>::ZERO; N];
    let mut ahead = [S::ZERO; N];
    let mut right = [S::ZERO; N];
    let mut normal_before = Vec3::ZERO;
    let (mut pivot_before, mut right_before) = (S::ZERO, S::ZERO);
    let (mut xa, mut wa) = (cloth.position[node(0)], cloth.inverse_mass[node(0)] * dividend);
    for k in 0..N - 1 {
        let b = node(k + 1);
        let (xb, wb) = (cloth.position[b], cloth.inverse_mass[b] * dividend);
        let d = xb - xa;
        let (excess, inverse) = S::gauge(d.squared(), &family.rest);
        let normal = d * inverse;
        // −(coupling to the link before); pivots stay between the least and the largest of 2·w
        let coupling = wa * normal_before.dot(normal);
        let factor = coupling * pivot_before;
        let pivot = (wa + wb + divisor - coupling * factor).recip();
        right_before = (excess - divisor * tension[k] + coupling * right_before) * pivot;
        if k > 0 {
            ahead[k - 1] = factor;
        }
        normals[k] = normal;
        right[k] = right_before;
        (normal_before, pivot_before, xa, wa) = (normal, pivot, xb, wb);
    }
    let mut change = S::ZERO;
    let mut pull_after = Vec3::ZERO;
    for k in (0..N - 1).rev() {
        change = right[k] + ahead[k] * change;
        tension[k] += change;
        let pull = normals[k] * (change * dividend);
        let b = node(k + 1);
        let w = cloth.inverse_mass[b];
        cloth.displace(b, (pull_after - pull) * w, moment);
        pull_after = pull;
    }
    let a = node(0);
    let w = cloth.inverse_mass[a];
    cloth.displace(a, pull_after * w, moment);
}
