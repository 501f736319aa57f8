//! Wind on the sheet's cells.

use crate::fingerprint::Fingerprint;
use crate::force::{Force, Row};
use crate::scalar::Scalar;
use crate::scalar::panel::MOST_OF_PANEL;
use crate::units::PanelFlow;
use crate::vec3::Vec3;
use crate::vectors::{SIDE_BY_SIDE, left, right};

/// Wind as the drag of plates, one for each cell: `F = ½·ρ·c·A·(n̂·u)·|n̂·u|·n̂`, a quarter of it on each corner. `A·n̂` is half the vector product of the
/// cell's diagonals, and `u = wind − mean corner velocity`. If the substep is too long for this force, it is limited, so that it brings the sheet at most to
/// the wind's velocity.
///
/// In aerodynamics, too, a quadrilateral panel has its normal from its diagonals (J. Hess, A. Smith, *Calculation of potential flow about arbitrary bodies*,
/// 1967). [`AerodynamicWind`](crate::AerodynamicWind) acts on both triangles of a cell instead, each along its own normal. On a flat cell that does not turn
/// both forces are equal. Panel wind takes neither a root nor, in fixed point, a division: on a board without a floating-point unit it costs about a tenth of that. It
/// treats both sides alike: a mirrored sheet moves as the mirror image.
///
/// In fixed point, relative velocities of up to 8 cells per tick at panels of 0.8 to 1.25 times their rest area are computed by a fast path, in numbers of 13
/// fraction bits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelWind<S: Scalar> {
    /// The wind's velocity, cells per tick.
    pub wind: Vec3<S>,
    pressure: S,
    area: S,
    panel: S::Panel,
}

impl<S: Scalar> PanelWind<S> {
    /// Wind from [`Units::panel_wind`](crate::Units::panel_wind).
    ///
    /// # Panics
    /// If it doesn't [fit](PanelFlow::fits) the number type.
    #[track_caller]
    #[inline]
    pub fn new(flow: PanelFlow) -> Self {
        let flow = flow.fits::<S>();
        let (pressure, area) = (S::from_f64(flow.pressure), S::from_f64(flow.area));
        Self { wind: Vec3::from_f64(flow.wind), pressure, area, panel: S::panel(pressure, area) }
    }

    /// The same gain outside the range of the fast path.
    #[inline(never)]
    #[cold]
    fn gain_any<const W: usize>(&self, rows: [Row<'_, S, W>; 2], cell: usize) -> Vec3<S> {
        let cell = cell.min(W.saturating_sub(2));
        let (diagonals, air) = self.meets(&column(&rows, cell), &column(&rows, cell + 1));
        Vec3::press_any(diagonals, air, &self.panel, most(&rows, cell))
    }

    /// The diagonals of the panel between two columns, and the air's velocity relative to it.
    #[inline(always)]
    fn meets(&self, left: &Column<S>, right: &Column<S>) -> ([Vec3<S>; 2], Vec3<S>) {
        ([right.lower - left.upper, right.upper - left.lower], self.wind - (left.velocity + right.velocity))
    }
}

impl<S: Scalar> Force<S> for PanelWind<S> {
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
    fn cells<const W: usize>(&self, [top, bottom]: [Row<'_, S, W>; 2], [upper, lower]: [&mut Vec3<[S; W]>; 2]) {
        if W < 2 {
            return;
        }
        let rows = [top, bottom];
        if const { SIDE_BY_SIDE } {
            // all at once and without a branch, so that a processor may compute four at a time; the first column follows the last
            let heavy = rows.iter().all(|row| row.inverse_mass.iter().all(|w| *w <= light()));
            let all: [S; W] = core::array::from_fn(|cell| most(&rows, if heavy { W } else { cell }));
            let next = [top.position, bottom.position, top.velocity, bottom.velocity];
            let [q, t, vq, vt] = next.map(|row| row.components(left::<1, S, W>));
            let mut gains = Vec3::row(Vec3::ZERO);
            for cell in 0..W {
                let velocity = vq.at(cell).quarter_of_sum(vt.at(cell));
                let next = Column { upper: q.at(cell), lower: t.at(cell), velocity };
                let (diagonals, air) = self.meets(&column(&rows, cell), &next);
                let gain = Vec3::press(diagonals, air, &self.panel, || all[cell]);
                gains.set(cell, gain.unwrap_or_else(|| self.gain_any(rows, cell)));
            }
            gains.set(W - 1, Vec3::ZERO);
            let before = gains.components(right::<1, S, W>);
            for column in 0..W {
                let both = before.at(column) + gains.at(column);
                upper.add(column, both);
                lower.add(column, both);
            }
        } else {
            let (mut here, mut before) = (column(&rows, 0), Vec3::ZERO);
            for cell in 0..W - 1 {
                let next = column(&rows, cell + 1);
                let (diagonals, air) = self.meets(&here, &next);
                let gain = Vec3::press(diagonals, air, &self.panel, || most(&rows, cell));
                let gain = gain.unwrap_or_else(|| self.gain_any(rows, cell));
                upper.add(cell, before + gain);
                lower.add(cell, before + gain);
                (here, before) = (next, gain);
            }
            upper.add(W - 1, before + Vec3::ZERO);
            lower.add(W - 1, before + Vec3::ZERO);
        }
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.vector(self.wind);
        print.numbers([self.pressure, self.area]);
    }
}

/// A column of particles in two neighbouring rows.
#[derive(Clone, Copy)]
struct Column<S> {
    upper: Vec3<S>,
    lower: Vec3<S>,
    /// A quarter of the sum of both velocities.
    velocity: Vec3<S>,
}

#[inline(always)]
fn column<S: Scalar, const W: usize>([top, bottom]: &[Row<'_, S, W>; 2], column: usize) -> Column<S> {
    Column {
        upper: top.position.at(column),
        lower: bottom.position.at(column),
        velocity: top.velocity.at(column).quarter_of_sum(bottom.velocity.at(column)),
    }
}

/// The largest inverse mass that counts as 1.
#[inline(always)]
fn light<S: Scalar>() -> S {
    S::ONE + S::ONE.halve(2)
}

/// [`MOST_OF_PANEL`], divided by w/(5/4) if the lightest corner of a cell has an inverse mass w above 5/4.
#[inline(always)]
fn most<S: Scalar, const W: usize>([top, bottom]: &[Row<'_, S, W>; 2], cell: usize) -> S {
    let most = S::from_f64(MOST_OF_PANEL);
    if cell + 1 >= W {
        return most;
    }
    let [top, bottom] = [top.inverse_mass, bottom.inverse_mass];
    let w = top[cell].max(top[cell + 1]).max(bottom[cell].max(bottom[cell + 1]));
    if w > light() { (light::<S>() * most).divide(w) } else { most }
}
