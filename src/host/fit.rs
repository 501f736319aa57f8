//! Whether a number type holds what a scene asks for, and which key asks too much.

use core::marker::PhantomData;
use std::format;
use std::string::String;

use super::error::SceneError;
use crate::scalar::Scalar;

/// The most a position may lose to rounding, cells.
const BLUR: f64 = 1.0 / 256.0;

/// Turns numbers in the sheet's own units into `S`.
#[derive(Debug)]
pub(super) struct Fit<S>(PhantomData<S>);

impl<S: Scalar> Fit<S> {
    /// Checks that `S` holds `value`, and that it does not hold it as zero.
    pub(super) fn number(key: impl Into<String>, value: f64) -> Result<S, SceneError> {
        Self::vector(key, [value]).map(|[number]| number)
    }

    /// Checks that `S` holds every component, and not all of them as zero.
    pub(super) fn vector<const N: usize>(key: impl Into<String>, values: [f64; N]) -> Result<[S; N], SceneError> {
        // Undefined where an infinite factor met a zero: too large as well.
        if !values.iter().all(|value| value.abs() <= S::LARGEST) {
            return Err(Self::error(key, "too large"));
        }
        let numbers = values.map(S::from_f64);
        let vanishes = values.iter().any(|value| *value != 0.0) && numbers.iter().all(|number| *number == S::ZERO);
        if vanishes { Err(Self::error(key, "too small")) } else { Ok(numbers) }
    }

    /// Checks that `S` holds a place (cells) finely enough to tell particles around it apart.
    pub(super) fn place(key: impl Into<String>, cells: [f64; 3]) -> Result<(), SceneError> {
        let furthest = S::LARGEST.min(BLUR / S::RESOLUTION);
        if cells.iter().all(|cell| cell.abs() <= furthest) {
            Ok(())
        } else {
            Err(SceneError::new(key, format!("more than {furthest:.0} cells from the origin, too far for {}", S::NAME)))
        }
    }

    fn error(key: impl Into<String>, reason: &str) -> SceneError {
        SceneError::new(key, format!("{reason} for {} in this cell size, mass and step", S::NAME))
    }
}
