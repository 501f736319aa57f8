//! Where all particles have mass 1, products with their masses are skipped; rows of nothing but pins are skipped as a whole.

use crate::cloth::Cloth;
use crate::scalar::Scalar;

/// The rows and columns of nothing but particles of mass 1, and the rows of nothing but pins.
#[derive(Clone, Copy)]
pub(super) struct Ordinary<const W: usize, const H: usize> {
    pub(super) held: [bool; H],
    pub(super) rows: [bool; H],
    pub(super) columns: [bool; W],
}

impl<const W: usize, const H: usize> Ordinary<W, H> {
    pub(super) fn new<S: Scalar>(cloth: &Cloth<S, W, H>) -> Self {
        let mut found = Self { held: [true; H], rows: [true; H], columns: [true; W] };
        for ((row, held), masses) in found.rows.iter_mut().zip(&mut found.held).zip(&cloth.inverse_mass.0) {
            for (column, w) in found.columns.iter_mut().zip(masses) {
                if *w != S::ONE {
                    (*row, *column) = (false, false);
                }
                *held &= *w == S::ZERO;
            }
        }
        found
    }
}
