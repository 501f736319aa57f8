//! Coloured patterns on a sheet.

use embedded_graphics::pixelcolor::Rgb888;

use super::tone::mix;
use crate::grid::Node;

/// The length of a cell in a [`Place`].
pub const CELL: i32 = 256;

/// The width of a band or a square of a pattern.
///
/// ```
/// use kerchief::render::pattern::{CELL, Width};
///
/// assert_eq!(Width::cells(2), Width::parts(2 * CELL));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Width(i32);

impl Width {
    /// A width in cells.
    pub const fn cells(cells: i32) -> Self {
        Self(cells * CELL)
    }

    /// A width in parts of a cell ([`CELL`] of them to a cell), for fractions of a cell.
    pub const fn parts(parts: i32) -> Self {
        Self(parts)
    }
}

/// A position on a sheet at rest, in parts of a cell ([`CELL`] of them to a cell).
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// The distance from the first column.
    pub across: i32,
    /// The distance from the first row.
    pub down: i32,
    /// The sheet's width.
    pub width: i32,
    /// The sheet's height.
    pub height: i32,
}

impl Place {
    /// The middle of one of the `parts × parts` parts of a cell, at this column and row, on a sheet of `W × H` particles.
    pub(super) const fn middle<const W: usize, const H: usize>(
        cell: Node,
        [column, row]: [usize; 2],
        parts: i32,
    ) -> Self {
        Self {
            across: cell.column as i32 * CELL + CELL * (2 * column as i32 + 1) / (2 * parts),
            down: cell.row as i32 * CELL + CELL * (2 * row as i32 + 1) / (2 * parts),
            width: (W as i32 - 1) * CELL,
            height: (H as i32 - 1) * CELL,
        }
    }

    /// The distance to the nearest edge.
    pub fn to_edge(&self) -> i32 {
        self.across.min(self.width - self.across).min(self.down).min(self.height - self.down)
    }
}

/// The colour at each position of a sheet. A plain colour is a pattern, and so is a function.
///
/// ```
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use kerchief::render::pattern::{CELL, Pattern, Place};
///
/// let dots = |at: &Place| {
///     let (x, y) = (at.across.rem_euclid(2 * CELL) - CELL, at.down.rem_euclid(2 * CELL) - CELL);
///     if x * x + y * y < CELL * CELL / 4 { Rgb888::WHITE } else { Rgb888::CSS_DARK_RED }
/// };
/// assert_eq!(dots.tone(&Place { across: CELL, down: CELL, width: 8 * CELL, height: 8 * CELL }), Rgb888::WHITE);
/// ```
pub trait Pattern {
    /// The colour at a place.
    fn tone(&self, at: &Place) -> Rgb888;
}

impl Pattern for Rgb888 {
    fn tone(&self, _at: &Place) -> Rgb888 {
        *self
    }
}

impl<F: Fn(&Place) -> Rgb888> Pattern for F {
    fn tone(&self, at: &Place) -> Rgb888 {
        self(at)
    }
}

/// Bands from the first row to the last. The band in the middle of the sheet has the second colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stripes {
    /// The width of a band.
    pub width: Width,
    /// The two colours.
    pub tones: [Rgb888; 2],
}

impl Pattern for Stripes {
    fn tone(&self, at: &Place) -> Rgb888 {
        self.tones[usize::from(is_band(at.across, at.width, self.width))]
    }
}

/// A chessboard. The square in the middle of the sheet has the second colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Checks {
    /// The side of a square.
    pub width: Width,
    /// The two colours.
    pub tones: [Rgb888; 2],
}

impl Pattern for Checks {
    fn tone(&self, at: &Place) -> Rgb888 {
        let same = is_band(at.across, at.width, self.width) == is_band(at.down, at.height, self.width);
        self.tones[usize::from(same)]
    }
}

/// Bands of coloured threads in both directions, as woven: full colour where two bands cross, half where a band crosses plain threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Gingham {
    /// The width of a band.
    pub width: Width,
    /// The colours of the plain and of the coloured threads.
    pub tones: [Rgb888; 2],
}

impl Pattern for Gingham {
    fn tone(&self, at: &Place) -> Rgb888 {
        let coloured =
            i32::from(is_band(at.across, at.width, self.width)) + i32::from(is_band(at.down, at.height, self.width));
        mix(self.tones[0], self.tones[1], 128 * coloured)
    }
}

/// A band along all edges around another pattern.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Border<P> {
    /// The band's width.
    pub width: Width,
    /// The band's colour.
    pub tone: Rgb888,
    /// The pattern inside the border.
    pub inner: P,
}

impl<P: Pattern> Pattern for Border<P> {
    fn tone(&self, at: &Place) -> Rgb888 {
        if at.to_edge() < self.width.0 { self.tone } else { self.inner.tone(at) }
    }
}

/// Whether a place lies in a band of the second colour. One of these bands is centred on the extent.
fn is_band(place: i32, extent: i32, Width(width): Width) -> bool {
    let width = width.max(1);
    (place - extent / 2 + width / 2).div_euclid(width) % 2 == 0
}

#[cfg(test)]
mod tests {
    extern crate std;
    use embedded_graphics::pixelcolor::RgbColor;
    use std::string::String;

    use super::*;

    const TONES: [Rgb888; 2] = [Rgb888::WHITE, Rgb888::RED];

    /// The pattern at the middle of each cell of a sheet of 7 × 5 cells.
    fn rows(pattern: &impl Pattern) -> [String; 5] {
        [0, 1, 2, 3, 4].map(|row| {
            let place = |column| Place {
                across: column * CELL + CELL / 2,
                down: row * CELL + CELL / 2,
                width: 7 * CELL,
                height: 5 * CELL,
            };
            (0..7)
                .map(|column| match pattern.tone(&place(column)) {
                    Rgb888::WHITE => '.',
                    Rgb888::RED => '#',
                    Rgb888::BLUE => 'b',
                    _ => '+',
                })
                .collect()
        })
    }

    #[test]
    fn patterns_are_centred() {
        assert_eq!(rows(&Rgb888::RED), ["#######"; 5]);
        assert_eq!(rows(&Stripes { width: Width::cells(1), tones: TONES }), [".#.#.#."; 5]);
        let checks = Checks { width: Width::cells(1), tones: TONES };
        assert_eq!(rows(&checks), [".#.#.#.", "#.#.#.#", ".#.#.#.", "#.#.#.#", ".#.#.#."]);
        let gingham = Gingham { width: Width::cells(1), tones: TONES };
        assert_eq!(rows(&gingham), ["+#+#+#+", ".+.+.+.", "+#+#+#+", ".+.+.+.", "+#+#+#+"]);
        let border = Border {
            width: Width::cells(1),
            tone: Rgb888::BLUE,
            inner: Stripes { width: Width::cells(1), tones: TONES },
        };
        assert_eq!(rows(&border), ["bbbbbbb", "b#.#.#b", "b#.#.#b", "b#.#.#b", "bbbbbbb"]);
    }
}
