//! todo
use crate::figures::Figure;
pub(crate) fn write(figures: &[Figure]) {}
pub(crate) fn check(figures: &[Figure]) {}
