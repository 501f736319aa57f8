//! Rows and columns whose particles all have mass 1, where products with masses are skipped, and rows of pins, which are skipped as a whole.

use crate::particles::Particles;
use crate::scalar::Scalar;

/// The rows and columns whose particles all have mass 1, and the rows whose particles are all pins.
#[derive(Clone, Copy)]
pub(super) struct UnitMass<const W: usize, const H: usize> {
    pub(super) pinned: [bool; H],
    pub(super) rows: [bool; H],
    pub(super) columns: [bool; W],
}

/// The rows whose particles all have mass 1.
pub(super) fn rows<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>) -> [bool; H] {
    core::array::from_fn(|row| particles.inverse_mass.0[row].iter().all(|&w| w == S::ONE))
}

impl<const W: usize, const H: usize> UnitMass<W, H> {
    pub(super) fn new<S: Scalar>(particles: &Particles<S, W, H>) -> Self {
        let masses = &particles.inverse_mass.0;
        Self {
            pinned: core::array::from_fn(|row| masses[row].iter().all(|&w| w == S::ZERO)),
            rows: rows(particles),
            columns: core::array::from_fn(|column| (0..H).all(|row| masses[row][column] == S::ONE)),
        }
    }
}
