//! Where all particles have mass 1, products with their masses are skipped.

use crate::cloth::Cloth;
use crate::scalar::Scalar;

/// The rows and columns of nothing but particles of mass 1.
#[derive(Clone, Copy)]
pub(super) struct Ordinary<const W: usize, const H: usize> {
    pub(super) rows: [bool; H],
    pub(super) columns: [bool; W],
}

impl<const W: usize, const H: usize> Ordinary<W, H> {
    pub(super) fn new<S: Scalar>(cloth: &Cloth<S, W, H>) -> Self {
        let mut found = Self { rows: [true; H], columns: [true; W] };
        for (row, masses) in found.rows.iter_mut().zip(&cloth.inverse_mass.0) {
            for (column, w) in found.columns.iter_mut().zip(masses) {
                if *w != S::ONE {
                    (*row, *column) = (false, false);
                }
            }
        }
        found
    }
}
