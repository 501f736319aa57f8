//! Checks that a number type represents the values of a scene. An error names the key of a value that does not fit.

use core::marker::PhantomData;
use std::format;
use std::string::String;

use super::error::SceneError;
use crate::scalar::{Scalar, fit};

/// The largest rounding error of a position, cells.
const BLUR: f64 = 1.0 / 256.0;

/// Converts numbers in the sheet's own units to `S`.
#[derive(Debug)]
pub(super) struct Fit<S>(PhantomData<S>);

impl<S: Scalar> Fit<S> {
    /// Checks that `S` represents `value`, and does not round it to zero.
    pub(super) fn number(key: impl Into<String>, value: f64) -> Result<S, SceneError> {
        Self::vector(key, [value]).map(|[number]| number)
    }

    /// Checks that `S` represents every component, and does not round all of them to zero.
    pub(super) fn vector<const N: usize>(key: impl Into<String>, values: [f64; N]) -> Result<[S; N], SceneError> {
        match fit::fit::<S, N>(values) {
            // An undefined value, infinity times zero, counts as too large as well.
            fit::Fit::TooLarge => Err(Self::error(key, "too large", "")),
            fit::Fit::AsZero => Err(Self::error(key, "too small", "")),
            fit::Fit::Coarsely | fit::Fit::Well => Ok(values.map(S::from_f64)),
        }
    }

    /// Checks that `S` represents a constant of the sheet's motion: rounding changes it by at most a sixteenth of its largest component.
    pub(super) fn constant<const N: usize>(key: impl Into<String>, values: [f64; N]) -> Result<[S; N], SceneError> {
        match fit::fit::<S, N>(values) {
            fit::Fit::Coarsely => {
                Err(Self::error(key, "too small", ": rounding would change it by more than a sixteenth"))
            }
            _ => Self::vector(key, values),
        }
    }

    /// Checks that `S` represents a place (cells) finely enough to distinguish particles around it.
    pub(super) fn place(key: impl Into<String>, cells: [f64; 3]) -> Result<(), SceneError> {
        let furthest = S::LARGEST.min(BLUR / S::RESOLUTION);
        if cells.iter().all(|cell| cell.abs() <= furthest) {
            Ok(())
        } else {
            Err(SceneError::new(key, format!("more than {furthest:.0} cells from the origin, too far for {}", S::NAME)))
        }
    }

    fn error(key: impl Into<String>, reason: &str, why: &str) -> SceneError {
        SceneError::new(key, format!("{reason} for {} in this cell size, mass and step{why}", S::NAME))
    }
}

/// Checks that numbers are finite. For numbers that come from no scene file.
pub(super) fn finite(key: &str, values: &[f64]) -> Result<(), SceneError> {
    if values.iter().all(|value| value.is_finite()) { Ok(()) } else { Err(SceneError::new(key, "must be finite")) }
}
