//! A sheet at rest is not computed.
//!
//! [`Resting`] is a solver that wraps another solver. It lets the wrapped solver move the sheet until the sheet is still. From then on it only checks whether
//! any input changed since: position, velocity or mass of a particle, a force, a link, a collider. If so, the wrapped solver continues from its state with that
//! same frame. A sheet at rest keeps its bits. A scene without this wrapper pays nothing for it.
//!
//! ```
//! use kerchief::rest::{Resting, Stillness};
//! use kerchief::*;
//!
//! const UNITS: Units = Units::sheet([8, 8], [0.3, 0.3], 1e-3, 1.0 / 60.0, 4);
//! let mut cloth = Cloth::<Q24, 8, 8>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
//! (0..8).for_each(|column| cloth.pin(Node::new(column, 0)));
//! let forces = (Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81])), Drag::new(UNITS.drag(3.0)));
//! let links = (Stretch::new(&UNITS, UNITS.stiffness(50.0)), Shear::new(&UNITS, UNITS.stiffness(5.0)));
//! let mut scene = Scene::new(&UNITS, forces, links, (), Resting::new(&UNITS, Stillness::DEFAULT, Lines::new()));
//! let mut memory = scene.memory();
//! (0..600).for_each(|_| scene.step(&mut cloth, &mut memory));
//! assert!(memory.is_at_rest());
//!
//! scene.forces.0 = Gravity::new(UNITS.acceleration([1.0, 0.0, -9.81])); // the board is tilted
//! scene.step(&mut cloth, &mut memory);
//! assert!(!memory.is_at_rest());
//! ```
//!
//! A frame at rest reads the scene, not the particles. It costs less than a hundredth of the cheapest frame that moves the sheet, for any size. The [`Cloth`]
//! notices possible changes: every `&mut` access to its particles counts as one. The particles are then compared once with their earlier state. A sheet
//! overwritten with equal values stays at rest; a sheet replaced by another one does not.
//!
//! A frame that does not move the sheet need not be drawn again: [`RestingMemory::is_at_rest`] is true before and after it.
//!
//! A sheet rests as a whole. While any part of it moves, few rows are still between two other still rows (slower than 1 % of the sheet's size a second): 3 % in
//! the curtain, 2 % in the drape, 7 and 20 % in the last seconds of the thesis' sheets on a ball and on three corners. Moreover columns, diagonals and
//! multipliers couple all rows: to skip some would change the others' motion.
//!
//! Forces, links and colliders of your own keep the sheet awake unless they implement a fingerprint ([`Force::fingerprint`], [`Links::fingerprint`],
//! [`Collider::fingerprint`]). A moving ball keeps it awake, too.

use core::cmp::Ordering;

use crate::cloth::Cloth;
use crate::collider::Collider;
use crate::fingerprint::Fingerprint;
use crate::force::Force;
use crate::grid::Grid;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::scalar::fit::is_positive;
use crate::solver::{Physics, Solver};
use crate::units::Units;
use crate::vec3::Vec3;

/// The criteria of stillness. For `time`
/// * no particle is faster than `speed` along any axis,
/// * the speed of the fastest one changes by less than `acceleration · time`,
/// * no particle gets further along any axis than `speed · time / 10` from its position at the start of that time,
/// * and no pin moves, however slowly.
///
/// The speed alone would freeze a sheet at the turning point of a slow swing, or at the start of a fall: there it is accelerated. It would also freeze a sheet
/// that sinks slowly in thick air: its motion is steady and leads away, while a sheet that vibrates stays in place. So these motions are frozen: a swing that
/// is never much faster than `speed`, a fall by less than `acceleration`, and a steady motion slower than a tenth of `speed`.
///
/// If rounding moves a sheet by more, the thresholds are raised accordingly. The speeds are at least 8 of the steps in which the number type [measures
/// links](Scalar::EDGE) in each substep, counting 16 substeps at most; this matters for [`Q13`](crate::Q13). The distance is at least 1/2048 cell in `Q24` and
/// 1/1024 in `Q13`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stillness {
    /// m/s, positive
    pub speed: f64,
    /// m/s², positive
    pub acceleration: f64,
    /// s, positive
    pub time: f64,
}

impl Stillness {
    /// 1 mm/s and 1 mm/s² (a ten-thousandth of gravity) for half a second, during which no particle moves further than 0.05 mm: 0.1 mm/s for a steady motion. Larger
    /// values freeze visible motion; with much smaller ones a sheet that moves by rounding alone never rests.
    pub const DEFAULT: Self = Self { speed: 1e-3, acceleration: 1e-3, time: 0.5 };
}

/// A solver that stops while the sheet is still.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Resting<V> {
    /// The wrapped solver.
    pub solver: V,
    threshold: Threshold,
}

impl<V> Resting<V> {
    /// `solver`, active until the sheet is as still as `stillness` in these units.
    ///
    /// # Panics
    /// At compile time in a constant, like [`Threshold::new`].
    #[track_caller]
    pub const fn new(units: &Units, stillness: Stillness, solver: V) -> Self {
        Self { solver, threshold: Threshold::new(units, stillness) }
    }
}

/// A [`Stillness`] in the sheet's units.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Threshold {
    /// Cells per tick.
    pub(crate) speed: f64,
    /// The change of speed, cells per tick.
    pub(crate) change: f64,
    /// Grains per cell, the steps in which positions are compared: a particle may move by four of them.
    pub(crate) grains: i32,
    /// The duration, frames.
    pub(crate) frames: u32,
}

/// The number of grains in the distance that counts as motion. A byte of each coordinate is stored: at the speeds of rest no frame moves a particle by the
/// byte's range.
const GRAINS: i32 = 4;

/// The allowed vibration of a sheet in a substep, in [steps of a link's length](Scalar::EDGE).
const TREMBLE: f64 = 8.0;

/// Limit on the substeps that add their vibration to the speed threshold, as a power of two. With more, a particle could move by a byte's range in a frame.
const SHAKEN: u32 = 4;

impl Threshold {
    /// The nearest threshold, of one frame at least.
    ///
    /// # Panics
    /// At compile time in a constant: for a stillness that is not positive and finite.
    #[track_caller]
    pub const fn new(units: &Units, stillness: Stillness) -> Self {
        let Stillness { speed, acceleration, time } = stillness;
        assert!(
            is_positive(speed) && is_positive(acceleration) && is_positive(time),
            "a stillness is positive and finite"
        );
        let scale = units.tick() / units.cell;
        // rounded up; the conversion saturates
        let frames = (time / units.frame) as u32;
        let frames = if frames as f64 * units.frame < time { frames.saturating_add(1) } else { frames };
        // the conversion saturates here too
        let grains = (GRAINS as f64 * units.cell / (0.1 * speed * time)) as i32;
        Self {
            speed: speed * scale,
            change: acceleration * time * scale,
            grains: if grains > 0 { grains } else { 1 },
            frames: if frames > 0 { frames } else { 1 },
        }
    }

    /// Moves the sheet by a frame with `solver`, unless it is at rest.
    #[inline]
    pub fn frame<S: Scalar, V: Solver<S>, F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        solver: &V,
        physics: Physics<'_, F, L, C>,
        cloth: &mut Cloth<S, W, H>,
        memory: &mut RestingMemory<V::Memory<L, W, H>, S, W, H>,
        end: Moment,
    ) {
        let RestingMemory { watch, places, .. } = memory;
        if watch.at_rest {
            let mut seen = surroundings(physics);
            cloth.fingerprint(&mut seen);
            if seen.matches(watch.seen) {
                return;
            }
            *watch = Watch::AWAKE;
        }
        solver.frame(physics, cloth, &mut memory.solver, end);
        let tremble = S::from_f64(TREMBLE * S::EDGE).double(end.shift.min(SHAKEN));
        let Some(speed) = fastest(cloth, S::from_f64(self.speed).max(tremble)) else {
            *watch = Watch::AWAKE;
            return;
        };
        let seen = surroundings(physics);
        let [slowest, fastest] = [watch.slowest.min(speed), watch.fastest.max(speed)];
        let grains = self.grains.min(const { (GRAINS as f64 / S::STRAY) as i32 });
        let goes_on = watch.frames > 0
            && seen.matches(watch.seen)
            && fastest - slowest < S::from_f64(self.change).max(tremble)
            && places.are_near(cloth, grains);
        *watch = if goes_on {
            Watch { frames: watch.frames + 1, seen, slowest, fastest, at_rest: false }
        } else {
            places.take(cloth, grains);
            Watch { frames: 1, seen, slowest: speed, fastest: speed, at_rest: false }
        };
        if watch.frames >= self.frames {
            watch.at_rest = true;
            cloth.fingerprint(&mut watch.seen);
        }
    }
}

/// A solver's memory, the stillness so far, and three bytes per particle for its position at the start of the stillness.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RestingMemory<M, S, const W: usize, const H: usize> {
    solver: M,
    watch: Watch<S>,
    places: Places<W, H>,
}

impl<M, S: Scalar, const W: usize, const H: usize> RestingMemory<M, S, W, H> {
    /// The memory of a sheet in motion. It is also valid in a constant, for a `static` on a board.
    pub const fn new(solver: M) -> Self {
        Self { solver, watch: Watch::AWAKE, places: Places(Grid::filled([0; 3])) }
    }

    /// The wrapped solver's memory, to move the sheet without this wrapper: the sheet then counts as in motion.
    pub const fn solver(&mut self) -> &mut M {
        self.watch = Watch::AWAKE;
        &mut self.solver
    }

    /// The wrapped solver's memory, read-only.
    pub const fn inner(&self) -> &M {
        &self.solver
    }

    /// Whether the last frame ended at rest: the next one is not computed unless an input changes.
    pub const fn is_at_rest(&self) -> bool {
        self.watch.at_rest
    }
}

#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Watch<S> {
    /// The number of frames for which the sheet has been still.
    #[cfg_attr(feature = "serde", serde(deserialize_with = "countable"))]
    frames: u32,
    /// The fingerprint of forces, links and colliders; at rest of the sheet, too.
    seen: Fingerprint,
    /// The least and the largest speed of the fastest particle in these frames, cells per tick.
    slowest: S,
    fastest: S,
    at_rest: bool,
}

/// A number of frames that can be incremented.
#[cfg(feature = "serde")]
fn countable<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<u32, D::Error> {
    let frames = serde::Deserialize::deserialize(deserializer)?;
    if frames < u32::MAX { Ok(frames) } else { Err(serde::de::Error::custom("too many frames")) }
}

impl<S: Scalar> Watch<S> {
    const AWAKE: Self =
        Self { frames: 0, seen: Fingerprint::new(), slowest: S::ZERO, fastest: S::ZERO, at_rest: false };
}

/// Past positions in grains; the lower byte of each suffices to tell whether a particle is near.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
struct Places<const W: usize, const H: usize>(Grid<[u8; 3], W, H>);

impl<const W: usize, const H: usize> Places<W, H> {
    fn take<S: Scalar>(&mut self, particles: &Particles<S, W, H>, grains: i32) {
        for (kept, row) in self.0.0.iter_mut().zip(&particles.position.0) {
            for (column, kept) in kept.iter_mut().enumerate() {
                *kept = lower_bytes(row.at(column), grains);
            }
        }
    }

    fn are_near<S: Scalar>(&self, particles: &Particles<S, W, H>, grains: i32) -> bool {
        self.0.0.iter().zip(&particles.position.0).all(|(kept, row)| {
            kept.iter().enumerate().all(|(column, kept)| {
                let now = lower_bytes(row.at(column), grains);
                now.iter().zip(kept).all(|(now, then)| {
                    let apart = now.wrapping_sub(*then) as i8;
                    i32::from(apart).abs() <= GRAINS
                })
            })
        })
    }
}

fn lower_bytes<S: Scalar>(place: Vec3<S>, grains: i32) -> [u8; 3] {
    [place.x, place.y, place.z].map(|x| x.round_times(grains) as u8)
}

/// The largest speed of a particle along an axis; `None` if one is faster than `limit` or a pin moves. In a moving sheet one of the first particles decides.
fn fastest<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>, limit: S) -> Option<S> {
    let mut largest = S::ZERO;
    for node in Grid::<S, W, H>::nodes() {
        let Vec3 { x, y, z } = particles.velocity.at(node);
        let limit = if particles.is_pinned(node) { S::ZERO } else { limit };
        for speed in [x.abs(), y.abs(), z.abs()] {
            // an undefined speed compares with no number
            if speed.partial_cmp(&limit).is_none_or(|order| order == Ordering::Greater) {
                return None;
            }
            largest = largest.max(speed);
        }
    }
    Some(largest)
}

fn surroundings<S: Scalar, F: Force<S>, L: Links<S>, C: Collider<S>>(physics: Physics<'_, F, L, C>) -> Fingerprint {
    let mut print = Fingerprint::new();
    physics.forces.fingerprint(&mut print);
    physics.links.fingerprint(&mut print);
    physics.colliders.fingerprint(&mut print);
    print
}

impl<S: Scalar, V: Solver<S>> Solver<S> for Resting<V> {
    type Memory<L: Links<S>, const W: usize, const H: usize> = RestingMemory<V::Memory<L, W, H>, S, W, H>;

    const WHOLE_FRAMES: bool = true;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        RestingMemory::new(self.solver.memory())
    }

    fn frame<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        cloth: &mut Cloth<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        end: Moment,
    ) {
        self.threshold.frame(&self.solver, physics, cloth, memory, end);
    }

    /// A single substep always moves the sheet.
    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        self.solver.substep(physics, particles, memory.solver(), moment);
    }
}
