//! The line solver: every row and every column of stretch links solved exactly, in second order.
//!
//! **In time** velocities follow BDF2 (C. Curtiss, J. Hirschfelder, 1952) and positions the three-level rule of the same order
//!
//! `v' = (4·v − v₋)/3 + (2/3)·h·a'`,  `x' = x + h·(4·v' + v + v₋)/6`,
//!
//! which needs one vector of history instead of two, is stable for any step, loses half as much energy as BDF2 for both, and halves what it can't resolve in
//! every substep. In the first substep, whose history is missing, links follow backward Euler, which once costs no order, and the other forces their
//! acceleration at its start, so that free fall is exact.
//!
//! **Dampers** act on all velocities at once, by rows and columns, too ([`viscosity`]).
//!
//! **In space** a sweep solves the other families, all rows and all columns, one after the other; after each sweep, particles are moved out of colliders. Rows, columns and
//! the diagonals of the cells are chains, each solved exactly ([`chain`], [`diagonal`]); diagonals up to κ = k·h²/m = 32 and all other links are relaxed
//! one by one ([`pairs`]). Families pull each other out of shape, so sweeps go on until one finds every row within the tolerance: where the sheet swings two are
//! enough, where it snaps taut more are spent, and [kept](sweeps) until a bounce is over. All multipliers start from nothing: on a stiff sheet a part of the last ones
//! does not die away, and shakes it. They are looked at in the first sweep all the same, to tell what springs hold from what is left unsolved.
//!
//! **Steps too long for sweeps** are [split]: what a sweep leaves shrinks by 1 − c/N² on a grid of N particles a side, but with the square of the step.

mod chain;
mod columns;
mod contact;
mod diagonal;
mod exponent;
mod geometric_stiffness;
mod pairs;
mod place;
mod pull;
mod regularise;
mod relax;
mod rows;
mod rule;
mod split;
mod streak;
mod sweeps;
mod tridiagonal;
mod two_step;
mod viscosity;

use crate::collider::Collider;
use crate::force::Force;
use crate::grid::Grid;
use crate::link::{Blank, Count, Damping, Links};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::scalar::fit::is_positive;
use crate::solver::{Physics, Solver, aside};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

use contact::Contacts;
use pull::Viscous;
use relax::Relax;
use rule::TimeRule;
use split::{Outcome, Split};
use streak::is_easy;
use sweeps::Kept;

/// Second order in time, exact along rows, columns and stiff diagonals: the solver for sheets that hardly stretch, an answer to the question of super-elasticity
/// (thesis, section 6.2).
///
/// The rule in time is stable for any stiffness and step, and substeps whose sweeps don't converge are split. Nearly rigid sheets in few substeps may go on trembling all the
/// same: docs/line-solver.md says which.
///
/// It remembers a multiplier of each link, and a vector a particle where links may be [damped](crate::link::Damped).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// Sweeps in every substep, at least one. More make a substep more accurate; the order is 2 with any number.
    pub sweeps: u32,
    /// The largest strain of a row that needs no further sweep. Sheets in motion are strained by about as much.
    pub tolerance: f64,
    /// The most sweeps in a substep, however strained rows are, and the most parts into which it is split where they don't get within twice the tolerance: what bounds the time
    /// that a step takes. Sheets with a side of more than 32 particles may be split into 4 times as many parts, with one of more than 64 into 16 times as many.
    pub most_sweeps: u32,
}

impl Lines {
    /// Two sweeps or more: what most scenes want.
    pub const fn new() -> Self {
        Self::with_sweeps(2)
    }

    /// At least `sweeps` sweeps in a substep, and at most 16, until rows are strained by no more than 2 %.
    ///
    /// # Panics
    /// At compile time in a constant: for no sweeps.
    #[track_caller]
    pub const fn with_sweeps(sweeps: u32) -> Self {
        assert!(sweeps > 0, "lines need one sweep at least");
        Self { sweeps, tolerance: 0.02, most_sweeps: if sweeps > 16 { sweeps } else { 16 } }
    }

    /// The same, until rows are strained by no more than `tolerance`.
    ///
    /// # Panics
    /// At compile time in a constant: for a tolerance that is not positive and finite.
    #[must_use]
    #[track_caller]
    pub const fn within(self, tolerance: f64) -> Self {
        assert!(is_positive(tolerance), "a tolerance is positive and finite");
        Self { tolerance, ..self }
    }
}

impl Default for Lines {
    fn default() -> Self {
        Self::new()
    }
}

/// The most sweeps before a substep is split rather than swept on, unless more are asked for: what more of them do is done better by shorter steps.
const PATIENCE: u32 = 4;

/// The strain in a row, found by the last sweep, from which on the next substep is backward Euler: BDF2 does not recover from a scrambled sheet.
const ROUGH: f64 = 0.1;

/// What a sheet's motion leaves behind.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        deserialize = "S: Scalar + serde::Deserialize<'de>, T: serde::Deserialize<'de>, P: serde::Deserialize<'de>"
    ))
)]
pub struct LinesMemory<S, T, P, const W: usize, const H: usize> {
    /// The velocity before the last substep, cells per tick.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::saved::finite"))]
    earlier: Vectors<S, W, H>,
    /// The multiplier of each link in the last sweep, at its upper or left particle, in cells over the dividend of the link's strength.
    multipliers: T,
    /// What springs did beside dampers in the last substep: x, y and z.
    pull: P,
    kept: Kept,
    split: Split,
    history: History,
    residual: S,
}

impl<S: Scalar, T: Blank, P: Blank, const W: usize, const H: usize> LinesMemory<S, T, P, W, H> {
    /// What a solver starts with: nothing but zeros.
    pub const BLANK: Self = Self {
        earlier: Vectors::filled(Vec3::ZERO),
        multipliers: T::BLANK,
        pull: P::BLANK,
        kept: Kept::NONE,
        split: Split::NONE,
        history: History::None,
        residual: S::ZERO,
    };
}

impl<S: Scalar, T, P, const W: usize, const H: usize> LinesMemory<S, T, P, W, H> {
    /// What the sweeps of the last substep left: the largest strain of a row that a last sweep found before it solved the row; of a substep that was split, the largest of all
    /// its parts. What springs hold themselves is left out; of a single sweep, what they held before it.
    ///
    /// Up to twice the [tolerance](Lines::tolerance) a substep is as accurate as its step allows. Where it stays above, the sheet has all the sweeps and parts that it may have,
    /// and more of either ([`Lines::most_sweeps`]) or shorter steps would change what it does.
    ///
    /// ```
    /// use kerchief::{Cloth, Gravity, Lines, Scene, Stretch, Units};
    ///
    /// const UNITS: Units = Units::sheet([8, 8], [0.3, 0.3], 1e-3, 1.0 / 60.0, 4);
    /// let mut cloth = Cloth::<f32, 8, 8>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
    /// cloth.pin(kerchief::Node::new(0, 0));
    /// let gravity = Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81]));
    /// let scene = Scene::new(&UNITS, gravity, Stretch::new(&UNITS, UNITS.stiffness(1e3)), (), Lines::new());
    /// let mut memory = scene.memory();
    /// scene.step(&mut cloth, &mut memory);
    /// assert!(f64::from(memory.residual()) < scene.solver.tolerance);
    /// ```
    pub fn residual(&self) -> S {
        self.residual
    }
}

/// The multipliers of links, and what is remembered beside dampers.
type MemoryOf<S, L, const W: usize, const H: usize> = LinesMemory<
    S,
    <<L as Links<S>>::Directions as Count>::Array<Grid<S, W, H>>,
    <<L as Links<S>>::Damping as Damping>::Pull<Grid<S, W, H>>,
    W,
    H,
>;

/// What is known of the past.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum History {
    /// Nothing.
    None,
    /// The last substep ended far from a solution.
    Rough,
    /// The velocity before the last substep.
    Velocity,
}

impl<S: Scalar> Solver<S> for Lines {
    type Memory<L: Links<S>, const W: usize, const H: usize> = MemoryOf<S, L, W, H>;

    #[track_caller]
    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        assert!(self.sweeps > 0 && self.most_sweeps > 0, "lines need one sweep at least");
        assert!(is_positive(self.tolerance), "a tolerance is positive and finite");
        LinesMemory::BLANK
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        if memory.history == History::None {
            memory.split = Split::start(W.max(H), self.most_sweeps);
        }
        let split = memory.split.halvings();
        let before = (moment.substep - 1) << split;
        let mut outcome = Outcome::NONE;
        memory.residual = S::ZERO;
        for part in 1..=1 << split {
            let moment = Moment {
                substep: before + part,
                substeps: moment.substeps << split,
                shift: moment.shift + split,
                ..moment
            };
            outcome = outcome.and(self.part(physics, particles, memory, moment, split));
        }
        if memory.split.learn(&outcome, S::from_f64(self.tolerance), W.max(H), self.most_sweeps) {
            memory.history = History::Rough;
            memory.kept = Kept::NONE;
            // those of a part of another length
            memory.multipliers.as_mut().fill(Grid::filled(S::ZERO));
        }
    }
}

impl Lines {
    /// Moves particles by a part of a substep: a half, a quarter and so on, `split` times halved.
    ///
    /// Its stages: predict, damp, sweep until satisfied, contacts, dampers' second turn, remember.
    fn part<S: Scalar, F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut MemoryOf<S, L, W, H>,
        moment: Moment,
        split: u32,
    ) -> Outcome<S> {
        let Physics { forces, links, colliders } = physics;
        let rule = TimeRule::new(memory.history, forces.drag().rate, moment, split);
        let budget = self.budget(split, memory.kept);

        // what friction looks back to
        let start = (colliders.is_present() || colliders.meets()).then_some(particles.position);
        two_step::predict(forces, particles, memory, moment, split);
        let LinesMemory { earlier, multipliers, pull, history, .. } = memory;
        let viscous = Viscous::damp(pull.as_mut(), *history, links, particles, &rule);
        let mut contacts = Contacts { colliders, start: start.as_ref(), earlier, moment: rule.moment };
        let swept = self.sweep(links, particles, multipliers.as_mut(), &rule, &mut contacts, &budget);
        links.confine(particles, rule.moment);
        contacts.resolve(particles, false);
        if let Some(viscous) = viscous {
            viscous.complete(links, particles, &rule);
        }

        memory.kept = memory.kept.after(swept.count, budget.least, swept.easy);
        memory.history = if swept.residual > S::from_f64(ROUGH) { History::Rough } else { History::Velocity };
        memory.residual = memory.residual.max(swept.residual);
        Outcome { mendable: swept.mendable, few: swept.count <= budget.least }
    }

    /// The sweeps that a part of a substep may have that is halved `split` times.
    fn budget(&self, split: u32, kept: Kept) -> Budget {
        let most = (self.most_sweeps >> split).max(1);
        let least = self.sweeps.clamp(1, most);
        Budget { least, wanted: least.max(kept.number()), most }
    }

    /// Sweeps over all links until every row is within the tolerance, or no more sweeps are left.
    #[inline(always)]
    fn sweep<S: Scalar, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        links: &L,
        particles: &mut Particles<S, W, H>,
        multipliers: &mut [Grid<S, W, H>],
        rule: &TimeRule<S>,
        contacts: &mut Contacts<'_, S, C, W, H>,
        budget: &Budget,
    ) -> Swept<S> {
        aside::set_all_aside(particles, rule.moment);
        let mut relax = Relax::new(particles, multipliers, rule.moment, rule.stiffness);
        // neither overstretched links nor light particles gain by shorter steps
        let none_is_light = relax.none_is_light;
        let gains_by_splitting = |found: S| found <= S::ONE && none_is_light;
        let most = |found: S| {
            if gains_by_splitting(found) { budget.most.min(PATIENCE).max(budget.least) } else { budget.most }
        };
        let tolerance = S::from_f64(self.tolerance);
        let (mut before, mut found, mut count) = (S::ZERO, relax.sweep(links, true), 1);
        while count < most(found) && (count < budget.wanted || found > tolerance) {
            // between the sweeps, so that links answer to what a collider does to them
            contacts.resolve(relax.particles, true);
            (before, found) = (found, relax.sweep(links, false));
            count += 1;
        }
        aside::give_all_back(relax.particles, rule.moment);
        Swept {
            count,
            residual: found,
            mendable: if gains_by_splitting(found) { found } else { S::ZERO },
            easy: is_easy(before, tolerance),
        }
    }
}

/// The sweeps that a part of a substep may have.
struct Budget {
    /// At least so many.
    least: u32,
    /// So many, whatever they find: those that are kept.
    wanted: u32,
    /// So many at most.
    most: u32,
}

/// What the sweeps of a part of a substep found.
struct Swept<S> {
    /// How many there were.
    count: u32,
    /// The largest strain of a row that the last one found.
    residual: S,
    /// The same as far as shorter steps leave less: what is overstretched comes together by sweeps, and shorter steps would throw it.
    mendable: S,
    /// Whether one sweep fewer would have done.
    easy: bool,
}
