//! Contacts of a sheet with itself.
//!
//! [`SelfContact`] is a solver around another one. It keeps particles that are not neighbours a thickness apart, as a collider keeps them from its surface. On a mesh of squares
//! with a thickness of d cells, no particle passes through a cell and no edge through another edge while the mesh is strained by less than d·√2 − 1: 41 % for 1, 6 % for 0.75.
//!
//! ```
//! use kerchief::*;
//!
//! const SHEET: Sheet<Q24, 16, 16> = Sheet::new([0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
//! let mut cloth = SHEET.hang([0.0, 0.0, 0.31]);
//! let forces = (SHEET.gravity([0.0, 0.0, -9.81]), SHEET.drag(1.0));
//! let links = (SHEET.stretch(100.0), SHEET.shear(1.0), SHEET.bend(0.01));
//! let ground = SHEET.plane([0.0; 3], [0.0, 0.0, 1.0], 0.01);
//! // 2 cm thick, which is a cell
//! let solver = SHEET.self_contact(0.02, 0.3, Lines::new());
//! let scene = SHEET.scene(forces, links, ground, solver);
//! let mut memory = scene.memory();
//! (0..60).for_each(|_| scene.step(&mut cloth, &mut memory));
//! assert!(measure::closest(&cloth, &SHEET.units) > 0.018);
//! ```
//!
//! A list of the quads of particles that may meet is made once in a frame, from boxes of whole numbers around them. It is made more often if parts of the sheet differ in
//! velocity by more than two cells a frame, less often if they hardly differ. Flat parts of a sheet are left out. In every substep, and between the sweeps of the line solver,
//! the particles of the listed quads are checked. The list takes 6 bytes a particle; scenes without `SelfContact` have none.
//!
//! For sheets that come to rest, wrap `Resting` around `SelfContact`, not the other way round.

mod extent;
mod meet;
mod near;
mod sweep;
mod tiling;

use core::cell::Cell;

use crate::collider::{Collider, Contact, Meeting, coefficient};
use crate::fingerprint::Fingerprint;
use crate::force::Force;
use crate::grid::Node;
use crate::link::Links;
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::{Rest, Scalar};
use crate::solver::{Physics, Solver};
use crate::units::Units;
use crate::vec3::Vec3;

use extent::Flatness;
use near::List;

pub(crate) use near::Near;

/// The least thickness of a sheet, in longer sides of its cells; the largest is 1.
pub(crate) const THINNEST: f64 = 0.75;

/// The allowance for two particles that together deviate from their predicted ways while a list lasts, cells. It is the first number plus the largest difference of velocities,
/// and at most the second number.
const STRAY: [f64; 2] = [0.2, 0.5];

/// A sheet's thickness, checked by [`Thickness::new`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Thickness {
    cells: f64,
    sides: [f64; 2],
}

impl Thickness {
    /// A thickness in m, from three quarters of a cell's longer side to the whole side.
    ///
    /// # Panics
    /// At compile time in a constant: for any other thickness.
    #[track_caller]
    pub const fn new(units: &Units, metres: f64) -> Self {
        let cells = metres / units.cell;
        // allows for rounding of the metres
        assert!(
            cells >= THINNEST - 1e-9 && cells <= 1.0 + 1e-9,
            "a sheet that meets itself is between 0.75 and 1 times as thick as a cell's longer side"
        );
        Self { cells, sides: units.sides }
    }
}

/// A solver around another one that adds contacts of the sheet with itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SelfContact<S: Scalar, V> {
    /// The solver that moves the sheet.
    pub solver: V,
    law: Law<S>,
}

impl<S: Scalar, V> SelfContact<S, V> {
    /// A sheet of this thickness that slides on itself with a coefficient of `friction`, moved by `solver`.
    ///
    /// # Panics
    /// For a friction that is negative, not finite or beyond the number type.
    #[track_caller]
    pub fn new(thickness: Thickness, friction: f64, solver: V) -> Self {
        Self { solver, law: Law::new(thickness, friction) }
    }
}

/// The law of contact between particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Law<S: Scalar> {
    /// The thickness, as the rest length of a contact.
    rest: Rest<S>,
    friction: S,
    /// Particles closer than so many columns and so many rows are neighbours, whose distance is left to links.
    neighbours: [usize; 2],
    /// The thickness in coarse numbers, rounded up.
    coarse: i32,
    flatness: Flatness,
    /// The most pairs of tiles that the list takes. A smaller capacity changes the computing time only.
    capacity: usize,
}

impl<S: Scalar> Law<S> {
    #[track_caller]
    pub(crate) fn new(Thickness { cells, sides }: Thickness, friction: f64) -> Self {
        let neighbours = sides.map(|side| apart(side, cells));
        Self {
            rest: Rest::spanning(S::from_f64(cells), S::ZERO),
            friction: coefficient(friction),
            neighbours,
            coarse: (256.0 * cells) as i32 + 1,
            flatness: Flatness::new(sides, neighbours),
            capacity: usize::MAX,
        }
    }

    /// Whether two particles are neighbours.
    #[inline(always)]
    fn joins(&self, i: Node, j: Node) -> bool {
        i.column.abs_diff(j.column) < self.neighbours[0] && i.row.abs_diff(j.row) < self.neighbours[1]
    }

    /// The distance up to which particles are listed, in coarse numbers; `spread` is their largest difference of velocities.
    fn watch(&self, spread: S) -> i32 {
        let [least, most] = STRAY.map(|cells| (256.0 * cells) as i32);
        self.coarse + spread.coarse().saturating_add(least).min(most)
    }

    /// The most by which a substep moves particles apart beyond their approach in it.
    fn slow(&self, shift: u32) -> S {
        let d = self.rest.length;
        if shift > 0 { d.halve(shift - 1) } else { d }
    }
}

/// The number of cells of a side from which on particles at rest are apart by the thickness and a quarter, so that a slightly compressed sheet has no contacts. Sides without
/// length get a number beyond all grids.
const fn apart(side: f64, thickness: f64) -> usize {
    let mut cells = 2;
    while cells < 1 << 15 && cells as f64 * side < 1.25 * thickness {
        cells += 1;
    }
    cells
}

/// The memory of the wrapped solver, and the list of parts of the sheet that may meet.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SelfContactMemory<M, const W: usize, const H: usize> {
    solver: M,
    // made again in the next frame
    #[cfg_attr(feature = "serde", serde(skip, default = "nothing"))]
    near: Near<W, H>,
}

#[cfg(feature = "serde")]
const fn nothing<const W: usize, const H: usize>() -> Near<W, H> {
    Near::NONE
}

impl<M, const W: usize, const H: usize> SelfContactMemory<M, W, H> {
    /// The memory of the wrapped solver.
    pub const fn solver(&mut self) -> &mut M {
        &mut self.solver
    }

    /// The largest number of pairs of particles in contact at once in the last frame.
    pub const fn contacts(&self) -> u32 {
        self.near.contacts
    }
}

impl<S: Scalar, V: Solver<S>> Solver<S> for SelfContact<S, V> {
    type Memory<L: Links<S>, const W: usize, const H: usize> = SelfContactMemory<V::Memory<L, W, H>, W, H>;

    fn memory<L: Links<S>, const W: usize, const H: usize>(&self) -> Self::Memory<L, W, H> {
        const { assert!(!V::WHOLE_FRAMES, "`Resting` stands around `SelfContact`, or the sheet never rests") };
        SelfContactMemory { solver: self.solver.memory(), near: Near::NONE }
    }

    fn substep<F: Force<S>, L: Links<S>, C: Collider<S>, const W: usize, const H: usize>(
        &self,
        physics: Physics<'_, F, L, C>,
        particles: &mut Particles<S, W, H>,
        memory: &mut Self::Memory<L, W, H>,
        moment: Moment,
    ) {
        let SelfContactMemory { solver, near } = memory;
        substep(Some((&self.law, near)), &self.solver, physics, particles, solver, moment);
    }
}

/// Moves particles by a substep of `solver`, with contacts of the sheet with itself if `own` has a law.
#[inline(always)]
pub(crate) fn substep<
    S: Scalar,
    V: Solver<S>,
    F: Force<S>,
    L: Links<S>,
    C: Collider<S>,
    const W: usize,
    const H: usize,
>(
    mut own: Option<(&Law<S>, &mut Near<W, H>)>,
    solver: &V,
    physics: Physics<'_, F, L, C>,
    particles: &mut Particles<S, W, H>,
    memory: &mut V::Memory<L, W, H>,
    moment: Moment,
) {
    let Physics { forces, links, colliders } = physics;
    let contacts = Cell::new(0);
    let layers = own.as_mut().map(|(law, near)| {
        near.follow(particles, law, moment);
        Layers { law, list: near.list(), contacts: &contacts }
    });
    let colliders = &Beside { layers, colliders };
    solver.substep(Physics { forces, links, colliders }, particles, memory, moment);
    if let Some((_, near)) = own {
        near.contacts = near.contacts.max(contacts.get());
    }
}

/// The sheet as a collider for itself.
#[derive(Clone, Copy)]
struct Layers<'a, S: Scalar> {
    law: &'a Law<S>,
    list: List<'a>,
    /// The largest number of pairs of particles in contact at once.
    contacts: &'a Cell<u32>,
}

/// The sheet as a collider for itself, if it has contacts with itself, and all other colliders.
#[derive(Clone, Copy)]
struct Beside<'a, S: Scalar, C> {
    layers: Option<Layers<'a, S>>,
    colliders: &'a C,
}

impl<S: Scalar, C: Collider<S>> Collider<S> for Beside<'_, S, C> {
    #[inline]
    fn is_present(&self) -> bool {
        self.colliders.is_present()
    }

    #[inline]
    fn meets(&self) -> bool {
        self.layers.is_some_and(|layers| !layers.list.is_empty()) || self.colliders.meets()
    }

    #[inline]
    fn meet<const W: usize, const H: usize>(
        &self,
        particles: &mut Particles<S, W, H>,
        meeting: &mut impl Meeting<S, W, H>,
    ) {
        if let Some(Layers { law, list, contacts }) = self.layers {
            contacts.set(contacts.get().max(meet::meet(law, list, particles, meeting)));
        }
        self.colliders.meet(particles, meeting);
    }

    #[inline]
    fn contact(&self, moment: Moment, position: Vec3<S>, moved: Vec3<S>) -> Option<Contact<S>> {
        self.colliders.contact(moment, position, moved)
    }

    #[inline]
    fn reaches(&self, moment: Moment, low: Vec3<S>, high: Vec3<S>) -> bool {
        self.colliders.reaches(moment, low, high)
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        self.colliders.fingerprint(print);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::Grid;
    use crate::scalar::{Q13, Q24};
    use crate::sheet::Sheet;
    use crate::solver::{Lines, Xpbd};

    /// A sheet that falls in a heap has the same bits however few pairs are kept: with none, all pairs of particles are checked in every substep.
    fn any_capacity<S: Scalar, V: Solver<S> + Copy>(solver: V) {
        const W: usize = 9;
        const H: usize = 14;
        let sheet = Sheet::<S, W, H>::new([0.24, 0.39], 1e-4, 1.0 / 60.0, 8);
        let run = |capacity: usize| {
            let mut cloth = sheet.hang([-0.12, 0.0, 0.42]);
            for node in Grid::<S, W, H>::nodes() {
                let sway = 0.3 * ((7 * node.column + 3 * node.row) as f64).sin();
                cloth.velocity.set(node, Vec3::from_f64(sheet.units.velocity([0.0, sway, 0.0]).0));
            }
            let forces = (sheet.gravity([0.0, 0.0, -9.81]), sheet.drag(1.0));
            let links = (sheet.stretch(100.0), sheet.shear(5.0), sheet.bend(0.05));
            let ground = sheet.plane([0.0; 3], [0.0, 0.0, 1.0], 0.01);
            let mut own = sheet.self_contact(0.03, 0.3, solver);
            own.law.capacity = capacity;
            let scene = sheet.scene(forces, links, ground, own);
            let mut memory = scene.memory();
            let mut met = 0;
            for _ in 0..90 {
                scene.step(&mut cloth, &mut memory);
                met = met.max(memory.contacts());
            }
            assert!(met > 10, "{met} pairs met");
            cloth
        };
        let all = run(usize::MAX);
        for capacity in [0, 1, 7] {
            assert!(run(capacity) == all, "capacity for {capacity} pairs, in {}", S::NAME);
        }
    }

    #[test]
    fn any_capacity_gives_the_same_bits() {
        any_capacity::<f32, _>(Lines::new());
        any_capacity::<Q24, _>(Lines::new());
        any_capacity::<Q13, _>(Xpbd);
        any_capacity::<f64, _>(Xpbd);
    }

    #[test]
    #[should_panic(expected = "between 0.75 and 1 times as thick as a cell's longer side")]
    fn no_other_thickness_is_possible() {
        let sheet = Sheet::<f32, 4, 4>::new([0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
        let _ = sheet.self_contact(0.07, 0.0, Xpbd);
    }

    #[test]
    fn particles_are_neighbours_up_to_a_thickness_and_a_quarter() {
        assert_eq!([1.0, 0.7, 0.5, 0.2].map(|side| apart(side, 1.0)), [2, 2, 3, 7]);
        assert_eq!(apart(0.0, 1.0), 1 << 15);
    }
}
