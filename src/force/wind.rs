//! Wind on the sheet's triangles.
//!
//! Each cell with the particles p = (c, r), q = (c+1, r), s = (c, r+1), t = (c+1, r+1) has the triangles (q, p, s) and (t, q, s).

use crate::fingerprint::Fingerprint;
use crate::force::{Force, Row};
use crate::scalar::Scalar;
use crate::units::Airflow;
use crate::vec3::Vec3;
use crate::vectors::{SIDE_BY_SIDE, left, right};

/// Wind as a pressure along each triangle's normal: force `n·(n̂·wind)` with `n = (b−a)×(c−a)` on each of its corners (thesis, 3.3 and listing 5.3).
///
/// The force grows with the area to which it stretches the sheet, and does not weaken with the sheet's velocity. If a substep is too long for this force, it is
/// limited: a corner of mass 1 gains at most a third of the wind's velocity normal to a triangle. So solvers that are stable for any step stay finite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FacetWind<S> {
    /// The velocity that a corner gains in a substep from a triangle with |n| = 1 cell² normal to the wind (cells per tick).
    pub wind: Vec3<S>,
    /// The |n| (cells²) at which the force stops growing: a corner of mass 1 then gains a third of the wind's velocity normal to the triangle in a substep.
    pub widest: S,
}

impl<S: Scalar> FacetWind<S> {
    /// Wind from [`Units::facet_wind`](crate::Units::facet_wind).
    ///
    /// # Panics
    /// If it doesn't [fit](Airflow::fits) the number type.
    #[track_caller]
    #[inline]
    pub fn new(airflow: Airflow) -> Self {
        let airflow = airflow.fits::<S>();
        Self { wind: Vec3::from_f64(airflow.wind), widest: S::from_f64(airflow.widest) }
    }
}

impl<S: Scalar> Force<S> for FacetWind<S> {
    const DRAG: bool = false;
    const UNIFORM: bool = false;

    #[inline]
    fn follows_velocity(&self) -> bool {
        false
    }

    #[inline]
    fn is_field(&self) -> bool {
        true
    }

    #[inline]
    fn cells<const W: usize>(&self, rows: [Row<'_, S, W>; 2], gains: [&mut Vec3<[S; W]>; 2]) {
        triangles(rows, gains, |_, corners, _| {
            let n = normal(corners);
            let length = n.length();
            let across = over(n.dot(self.wind), length);
            n * if length > self.widest { across * self.widest.divide(length) } else { across }
        });
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.vector(self.wind);
        print.number(self.widest);
    }
}

/// The largest part of its velocity relative to the air that a corner of mass 1 loses in a substep to a triangle with |n| = 1, as a power of ½.
///
/// Six triangles meet in a particle. With up to [`LARGE`] times their area in a stretched sheet, all six together slow it at most to rest relative to the air,
/// without overshoot. The pressure grows with the square of the velocity and is taken at the start of a substep. Without this limit, a long substep would throw
/// a light sheet back faster than it came, and faster still in the next one.
///
/// A cell whose lightest corner has an inverse mass w above 5/4 has 5/(64·w) instead. For a particle inside the sheet this adds up to 15/16 of its velocity
/// relative to the air. The line solver, which extrapolates velocities, stays stable up to 4/3 of it.
const MOST: u32 = 4;

/// The |n|, cells², above which a triangle's limit decreases with its size.
const LARGE: i32 = 2;

/// Wind as the drag of a plate, relative to the cloth's own velocity: `F = ½·ρ·c·A·(n̂·u)·|n̂·u|·n̂` for the triangle of area A with
/// `u = wind − mean corner velocity`, a third of it on each corner. If the substep is too long for this force, it is limited, so that it brings the sheet at
/// most to the wind's velocity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct AerodynamicWind<S> {
    /// The wind's velocity, cells per tick.
    pub wind: Vec3<S>,
    /// The velocity that a corner gains in a substep from a triangle with |n| = 1 cell² moving against the air at one cell per tick.
    pub pressure: S,
}

impl<S: Scalar> AerodynamicWind<S> {
    /// Wind from [`Units::aerodynamic_wind`](crate::Units::aerodynamic_wind).
    ///
    /// # Panics
    /// If it doesn't [fit](Airflow::fits) the number type.
    #[track_caller]
    #[inline]
    pub fn new(airflow: Airflow) -> Self {
        let airflow = airflow.fits::<S>();
        Self { wind: Vec3::from_f64(airflow.wind), pressure: S::from_f64(airflow.pressure) }
    }
}

impl<S: Scalar> Force<S> for AerodynamicWind<S> {
    const DRAG: bool = false;
    const UNIFORM: bool = false;

    #[inline]
    fn is_field(&self) -> bool {
        true
    }

    #[inline]
    fn follows_velocity(&self) -> bool {
        true
    }

    #[inline]
    fn cells<const W: usize>(&self, rows: [Row<'_, S, W>; 2], gains: [&mut Vec3<[S; W]>; 2]) {
        let (third, large) = (S::ONE.divide(S::from_int(3)), S::from_int(LARGE));
        let most = most(rows);
        // faster air is limited anyway; times a high pressure it would leave the range of fixed point
        let fastest = if self.pressure > S::ONE { S::ONE } else { S::from_int(127) };
        triangles(rows, gains, |cell, corners, [a, b, c]| {
            let n = normal(corners);
            // a third of each velocity, so that their sum stays in range
            let u = self.wind - (a * third + b * third + c * third);
            let length = n.length();
            let across = over(n.dot(u), length);
            let speed = across.abs().bounded(fastest);
            let most = most[cell];
            let most = if length > large { (large * most).divide(length) } else { most };
            n * ((self.pressure * speed).min(most) * across)
        });
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.vector(self.wind);
        print.number(self.pressure);
    }
}

/// The limit for each cell between two rows: see [`MOST`].
#[inline]
fn most<S: Scalar, const W: usize>([top, bottom]: [Row<'_, S, W>; 2]) -> [S; W] {
    let light = S::ONE + S::ONE.halve(2);
    let (most, most_times_light) = (S::ONE.halve(MOST), light.halve(MOST));
    let (top, bottom) = (top.inverse_mass, bottom.inverse_mass);
    let mut all = [most; W];
    if top.iter().chain(bottom).any(|w| *w > light) {
        for cell in 0..W {
            let next = (cell + 1).min(W - 1);
            let w = top[cell].max(top[next]).max(bottom[cell]).max(bottom[next]);
            if w > light {
                all[cell] = most_times_light.divide(w);
            }
        }
    }
    all
}

/// A quotient, zero for a triangle without area.
#[inline(always)]
fn over<S: Scalar>(dividend: S, length: S) -> S {
    let quotient = dividend.divide(length);
    if length == S::ZERO { S::ZERO } else { quotient }
}

#[inline]
fn normal<S: Scalar>([a, b, c]: [Vec3<S>; 3]) -> Vec3<S> {
    (b - a).cross(c - a)
}

/// Adds `gain(cell, positions, velocities)` to the corners of both triangles of each cell between two rows.
///
/// All cells are computed at once and without a branch, so that a processor may compute four at a time. The row's first particles replace the corners of a cell
/// beyond the last; their gains are dropped.
#[inline]
fn triangles<S: Scalar, const W: usize>(
    [top, bottom]: [Row<'_, S, W>; 2],
    [upper, lower]: [&mut Vec3<[S; W]>; 2],
    gain: impl Fn(usize, [Vec3<S>; 3], [Vec3<S>; 3]) -> Vec3<S>,
) {
    if W < 2 {
        return;
    }
    let next = |row: &Vec3<[S; W]>| row.components(left::<1, S, W>);
    let (q, t) = (next(top.position), next(bottom.position));
    let (vq, vt) = (next(top.velocity), next(bottom.velocity));
    let mut first = Vec3::row(Vec3::ZERO);
    let mut second = first;
    for cell in 0..W {
        let at = |row: &Row<'_, S, W>| (row.position.at(cell), row.velocity.at(cell));
        let (p, s) = (at(&top), at(&bottom));
        let (q, t) = ((q.at(cell), vq.at(cell)), (t.at(cell), vt.at(cell)));
        // two calls are inlined and computed four at a time; a map over an array takes less flash on a small chip
        let [one, two] = if const { SIDE_BY_SIDE } {
            [gain(cell, [q.0, p.0, s.0], [q.1, p.1, s.1]), gain(cell, [t.0, q.0, s.0], [t.1, q.1, s.1])]
        } else {
            [[q, p, s], [t, q, s]].map(|corners| gain(cell, corners.map(|(x, _)| x), corners.map(|(_, v)| v)))
        };
        first.set(cell, one);
        second.set(cell, one + two);
    }
    for rest in [&mut first, &mut second] {
        rest.set(W - 1, Vec3::ZERO);
    }
    // a particle gains from the cell to its right and from the cell to its left
    let previous = |row: &Vec3<[S; W]>| row.components(right::<1, S, W>);
    let (before, both_before) = (previous(&first), previous(&second));
    for column in 0..W {
        upper.add(column, first.at(column) + both_before.at(column));
        lower.add(column, second.at(column) + (both_before.at(column) - before.at(column)));
    }
}
