//! Wind on the sheet's triangles.
//!
//! Each cell with the particles p = (c, r), q = (c+1, r), s = (c, r+1), t = (c+1, r+1) has the triangles (q, p, s) and (t, q, s).

use crate::force::{Force, Row};
use crate::scalar::Scalar;
use crate::units::Airflow;
use crate::vec3::Vec3;

/// Wind as a pressure along each triangle's normal: force `n·(n̂·wind)` with `n = (b−a)×(c−a)` on each of its corners.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacetWind<S> {
    /// The velocity that a corner gains in a substep from a triangle with |n| = 1 cell² across the wind (cells per tick).
    pub wind: Vec3<S>,
}

impl<S: Scalar> FacetWind<S> {
    /// Wind from [`Units::facet_wind`](crate::Units::facet_wind).
    pub fn new(airflow: Airflow) -> Self {
        Self { wind: Vec3::from_f64(airflow.wind) }
    }
}

impl<S: Scalar> Force<S> for FacetWind<S> {
    const FIELD: bool = true;
    const UNIFORM: bool = false;

    #[inline]
    fn cells<const W: usize>(&self, rows: [Row<'_, S, W>; 2], gains: [&mut Vec3<[S; W]>; 2]) {
        triangles(rows, gains, |corners, _| {
            let n = normal(corners);
            let length = n.length();
            if length == S::ZERO { Vec3::ZERO } else { n * n.dot(self.wind).divide(length) }
        });
    }
}

/// Wind as the drag of a plate, relative to the cloth's own velocity: `F = ½·ρ·c·A·(n̂·u)·|n̂·u|·n̂` for the triangle of area A with
/// `u = wind − mean corner velocity`, a third of it on each corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AerodynamicWind<S> {
    /// The wind's velocity, cells per tick.
    pub wind: Vec3<S>,
    /// The velocity that a corner gains in a substep from a triangle with |n| = 1 cell² moving against the air at one cell per tick.
    pub pressure: S,
}

impl<S: Scalar> AerodynamicWind<S> {
    /// Wind from [`Units::aerodynamic_wind`](crate::Units::aerodynamic_wind).
    pub fn new(airflow: Airflow) -> Self {
        Self { wind: Vec3::from_f64(airflow.wind), pressure: S::from_f64(airflow.pressure) }
    }
}

impl<S: Scalar> Force<S> for AerodynamicWind<S> {
    const FIELD: bool = true;
    const FOLLOWS_VELOCITY: bool = true;
    const UNIFORM: bool = false;

    #[inline]
    fn cells<const W: usize>(&self, rows: [Row<'_, S, W>; 2], gains: [&mut Vec3<[S; W]>; 2]) {
        let third = S::ONE.divide(S::from_int(3));
        triangles(rows, gains, |corners, [a, b, c]| {
            let n = normal(corners);
            let length = n.length();
            if length == S::ZERO {
                return Vec3::ZERO;
            }
            // a third of each velocity, so that their sum stays in range
            let u = self.wind - (a * third + b * third + c * third);
            let across = n.dot(u).divide(length);
            n * (self.pressure * across * across.abs())
        });
    }
}

#[inline]
fn normal<S: Scalar>([a, b, c]: [Vec3<S>; 3]) -> Vec3<S> {
    (b - a).cross(c - a)
}

/// Adds `gain(positions, velocities)` to the corners of both triangles of each cell between two rows.
#[inline]
fn triangles<S: Scalar, const W: usize>(
    [top, bottom]: [Row<'_, S, W>; 2],
    [upper, lower]: [&mut Vec3<[S; W]>; 2],
    gain: impl Fn([Vec3<S>; 3], [Vec3<S>; 3]) -> Vec3<S>,
) {
    for left in 0..W.saturating_sub(1) {
        let right = left + 1;
        let [p, q] = [left, right].map(|column| (top.position.at(column), top.velocity.at(column)));
        let [s, t] = [left, right].map(|column| (bottom.position.at(column), bottom.velocity.at(column)));
        let [first, second] =
            [[q, p, s], [t, q, s]].map(|corners| gain(corners.map(|(x, _)| x), corners.map(|(_, v)| v)));
        upper.add(left, first);
        upper.add(right, first + second);
        lower.add(left, first + second);
        lower.add(right, second);
    }
}
