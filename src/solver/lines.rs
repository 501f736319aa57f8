//! The line solver: every row and every column of stretch links is solved exactly. It is of second order in time.
//!
//! # Stages of a substep
//!
//! A substep is made in one or more equal parts, each with these stages:
//!
//! 1. *Predict* ([`two_step`]). Particles move to where they would be at the end of the part without links.
//! 2. *Damp* ([`pull`], [`viscosity`]). Dampers act on all velocities at once, by rows and columns. They assume that springs will change velocities as in the last part.
//! 3. *Sweep* ([`relax`]). A sweep solves the other families of links, then all rows and all columns, and corrects positions and velocities. Between two sweeps, particles are
//!    moved out of colliders. Sweeps go on until one finds every row within the tolerance.
//! 4. *Confine* ([`contact`]). Limits and tethers are applied, then particles are moved out of colliders a last time.
//! 5. *Damp again* ([`pull`]). Dampers act on the difference between the velocity changes of stages 3 and 4 and those assumed in stage 2.
//! 6. *Remember*. The number of sweeps and the residual decide how the next part is solved; after the last part they decide into how many parts the next substep is [split].
//!
//! # Rule in time
//!
//! Velocities follow BDF2 (C. Curtiss, J. Hirschfelder, 1952), positions the three-level rule of the same order
//!
//! `v' = (4·v − v₋)/3 + (2/3)·h·a'`,  `x' = x + h·(4·v' + v + v₋)/6`.
//!
//! Compared with BDF2 for both, the pair needs one vector of history instead of two, and loses half as much energy. It is stable for any step, and halves unresolved vibrations
//! in every substep. The first substep has no history. There, links follow backward Euler, which costs no order if done once. The other forces act with their acceleration at
//! the start of the substep, and the missing v₋ is v − h·a, so that free fall is exact.
//!
//! # Sweeps
//!
//! Rows, columns and the diagonals of the cells are chains, each solved exactly ([`chain`], [`diagonal`]). Diagonals up to κ = k·h²/m = 32 (scaled by the [rule](rule) in time)
//! and all other links are relaxed one by one ([`pairs`]).
//!
//! Each family disturbs the solution of the others, so one sweep is not enough. While the sheet swings, two are; where it snaps taut, more are made, and their number is
//! [kept](sweeps) until the bounce is over.
//!
//! In every substep all multipliers start at zero. If they started from their last values, a part of these would not decay on a stiff sheet, and would shake it. The first sweep
//! reads the last values all the same, to separate the strain that balances spring forces from the unsolved residual.
//!
//! # Steps too long for sweeps
//!
//! Such substeps are [split] into parts. On a grid of N particles a side, a sweep reduces the residual to 1 − c/N² of itself; shorter steps reduce it with the square of the step.

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

/// The line solver, for sheets that hardly stretch: second order in time, exact along rows, columns and stiff diagonals. It is an answer to super-elasticity (thesis,
/// section 6.2).
///
/// The rule in time is stable for any stiffness and step, and substeps whose sweeps don't converge are split. Nearly rigid sheets in few substeps may tremble all the same;
/// docs/line-solver.md lists the cases.
///
/// Its memory has a vector for each particle, a multiplier for each link, and another vector for each particle where links may be [damped](crate::link::Damped).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// The least number of sweeps in a substep, at least one. More sweeps make a substep more accurate; the order is 2 with any number.
    pub sweeps: u32,
    /// Sweeps end once no row has a larger residual strain than this. Sheets in motion are strained by about as much.
    pub tolerance: f64,
    /// The most sweeps in a substep, however large the residual, and the most parts into which a substep is split whose residual stays above twice the tolerance. Both bound the
    /// time of a step. Sheets with a side of more than 32 particles may be split into 4 times as many parts, those with a side of more than 64 into 16
    /// times as many, and so on with each doubling.
    pub most_sweeps: u32,
}

impl Lines {
    /// At least two sweeps in a substep, for most scenes.
    pub const fn new() -> Self {
        Self::with_sweeps(2)
    }

    /// At least `sweeps` sweeps in a substep, and at most 16 (or `sweeps` if that is more), until the residual strain of rows is at most 2 %.
    ///
    /// # Panics
    /// At compile time in a constant: for no sweeps.
    #[track_caller]
    pub const fn with_sweeps(sweeps: u32) -> Self {
        assert!(sweeps > 0, "lines need one sweep at least");
        Self { sweeps, tolerance: 0.02, most_sweeps: if sweeps > 16 { sweeps } else { 16 } }
    }

    /// The same with another [`tolerance`](Self::tolerance).
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

/// The most sweeps where splitting helps, unless the caller asks for more: beyond that number, shorter steps reduce the residual better than further sweeps.
const PATIENCE: u32 = 4;

/// The residual strain above which the next substep is backward Euler: BDF2 does not recover from a scrambled sheet.
const ROUGH: f64 = 0.1;

/// The line solver's state between substeps.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
#[cfg_attr(
    feature = "serde",
    serde(bound(
        deserialize = "S: Scalar + serde::Deserialize<'de>, T: serde::Deserialize<'de>, P: serde::Deserialize<'de>"
    ))
)]
pub struct LinesMemory<S, T, P, const W: usize, const H: usize> {
    /// The velocities at the start of the last substep, cells per tick.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "crate::saved::finite"))]
    earlier: Vectors<S, W, H>,
    /// The multiplier of each link after the last sweep, at its upper or left particle, in cells over the dividend of the link's strength.
    multipliers: T,
    /// The velocity changes by springs and contacts in the last substep, as the dampers of the next one assume them: x, y and z.
    pull: P,
    kept: Kept,
    split: Split,
    history: History,
    residual: S,
}

impl<S: Scalar, T: Blank, P: Blank, const W: usize, const H: usize> LinesMemory<S, T, P, W, H> {
    /// The memory at the start of a motion, all zeros.
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
    /// The residual of the last substep: the largest strain of a row that the last sweep found before it solved the row, and over all parts if the substep was split.
    /// The strain that balances the spring forces is not counted; after a single sweep, the forces are those of the substep before. In fixed point, columns and diagonals that were
    /// regularised count as well.
    ///
    /// Up to twice the [tolerance](Lines::tolerance), a substep is as accurate as its step allows. If the residual stays above, the sheet already has all the sweeps and parts that
    /// it may have, and more of either ([`Lines::most_sweeps`]) or shorter steps would change its motion.
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

/// The solver's state for links of type `L`.
type MemoryOf<S, L, const W: usize, const H: usize> = LinesMemory<
    S,
    <<L as Links<S>>::Directions as Count>::Array<Grid<S, W, H>>,
    <<L as Links<S>>::Damping as Damping>::Pull<Grid<S, W, H>>,
    W,
    H,
>;

/// The history that the rule in time can use.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
enum History {
    /// None: the first substep.
    None,
    /// None: the last substep ended far from a solution, or parts changed their length.
    Rough,
    /// The velocities at the start of the last substep.
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
            // they belong to parts of another length
            memory.multipliers.as_mut().fill(Grid::filled(S::ZERO));
        }
    }
}

impl Lines {
    /// Moves particles by one part of a substep, which is halved `split` times.
    ///
    /// Its stages are those of the [module](self): predict, damp, sweep, confine, damp again, remember.
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

        // friction acts on displacements from here
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

    /// The limits on the number of sweeps in a part of a substep that is halved `split` times.
    fn budget(&self, split: u32, kept: Kept) -> Budget {
        let most = (self.most_sweeps >> split).max(1);
        let least = self.sweeps.clamp(1, most);
        Budget { least, wanted: least.max(kept.number()), most }
    }

    /// Sweeps over all links until every row is within the tolerance or the budget is spent.
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
        // shorter steps help neither overstretched links nor light particles
        let none_is_light = relax.none_is_light;
        let gains_by_splitting = |found: S| found <= S::ONE && none_is_light;
        let most = |found: S| {
            if gains_by_splitting(found) { budget.most.min(PATIENCE).max(budget.least) } else { budget.most }
        };
        let tolerance = S::from_f64(self.tolerance);
        let (mut before, mut found, mut count) = (S::ZERO, relax.sweep(links, true), 1);
        while count < most(found) && (count < budget.wanted || found > tolerance) {
            // between the sweeps, so that links respond to the displacements by colliders
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

/// The limits on the number of sweeps in a part of a substep.
struct Budget {
    /// The least number that the caller asks for.
    least: u32,
    /// The number made whatever the residual: the kept one, if that is more.
    wanted: u32,
    /// The most.
    most: u32,
}

/// The result of the sweeps in a part of a substep.
struct Swept<S> {
    /// The number of sweeps.
    count: u32,
    /// The largest strain of a row that the last sweep found.
    residual: S,
    /// The residual, or zero where shorter steps would not reduce it: sweeps bring overstretched links together, shorter steps would throw their particles.
    mendable: S,
    /// Whether one sweep fewer would have been enough.
    easy: bool,
}
