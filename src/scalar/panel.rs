//! The pressure of air on a panel.

use super::Scalar;

/// The largest part of its velocity relative to the air that a corner of mass 1 loses in a substep to a panel of 1 cell². The four panels around a particle
/// together take 3/8, like the six triangles in [`AerodynamicWind`](crate::AerodynamicWind).
pub(crate) const MOST_OF_PANEL: f64 = 3.0 / 32.0;

/// The constants of a sheet's panels, in floats.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Panel<S> {
    pressure: S,
    /// 1/A₀
    inverse: S,
    /// 2·A₀
    twice: S,
}

impl<S: Scalar> Panel<S> {
    /// See [`Scalar::panel`].
    #[inline]
    pub(crate) fn new(pressure: S, area: S) -> Self {
        Self { pressure, inverse: area.recip(), twice: area.double(1) }
    }

    /// See [`Scalar::press`].
    #[inline(always)]
    pub(crate) fn press(&self, [a, b]: [[S; 3]; 2], air: [S; 3], most: S, tiny: S) -> [S; 3] {
        let cross = |k: usize, l: usize| (a[k] * b[l] - a[l] * b[k]) * S::HALF;
        let n = [cross(1, 2), cross(2, 0), cross(0, 1)];
        let dot = |u: [S; 3]| n[0] * u[0] + n[1] * u[1] + n[2] * u[2];
        // a panel without area gets no force
        let inverse = dot(n).max(tiny).recip();
        let across = dot(air);
        let part = (self.pressure * across.abs() * inverse).min(most * self.inverse.min(self.twice * inverse));
        let gain = part * across;
        [n[0] * gain, n[1] * gain, n[2] * gain]
    }
}
