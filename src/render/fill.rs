//! Filled triangles.
//!
//! Corners lie anywhere between pixels, and a pixel belongs to the triangle that covers its middle. Faces with a common edge therefore
//! neither overlap nor leave a gap. (The triangle of `embedded-graphics` joins middles of pixels, draws common edges twice and follows
//! all its edges again for each row.)

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;

use super::camera::Spot;
use super::quotient::quotient;

/// Twice the signed area of the triangle a, b, c: positive if clockwise on the screen.
pub(super) fn turn(a: Spot, b: Spot, c: Spot) -> i64 {
    let (ab, ac) = ((b.x - a.x, b.y - a.y), (c.x - a.x, c.y - a.y));
    // a Cortex-M0 has no products of 64 bits; sides below 128 pixels do not need them
    let short = [ab.0, ab.1, ac.0, ac.1].into_iter().all(|side| side.unsigned_abs() < 1 << 15);
    if short {
        return i64::from(ab.0 * ac.1 - ab.1 * ac.0);
    }
    i64::from(ab.0) * i64::from(ac.1) - i64::from(ab.1) * i64::from(ac.0)
}

/// Fills the pixels whose middle lies in the triangle and in `area`, the target's bounding box.
pub(super) fn triangle<D: DrawTarget>(
    corners: [Spot; 3],
    color: D::Color,
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    outline(corners.map(Corner::plain), area, |span| target.fill_solid(&span.area(), color))
}

/// Twice the signed areas of a face's triangles (q, p, s) and (t, q, s): see [`turn`].
pub(super) fn turns([p, q, s, t]: [Spot; 4]) -> [i64; 2] {
    [turn(q, p, s), turn(t, q, s)]
}

/// Fills both triangles of a face with these [`turns`].
pub(super) fn face<D: DrawTarget>(
    [p, q, s, t]: [Spot; 4],
    [one, other]: [i64; 2],
    color: D::Color,
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    let ring = [p, q, t, s];
    if is_one_span([one, other], ring) {
        return outline(ring.map(Corner::plain), area, |span| target.fill_solid(&span.area(), color));
    }
    triangle([q, p, s], color, area, target)?;
    triangle([t, q, s], color, area, target)
}

/// Whether both triangles of a face with these [`turns`] form one span in each row. They do if they lie on opposite sides of their common edge and their outline
/// does not turn back up.
pub(super) fn is_one_span([one, other]: [i64; 2], ring: [Spot; 4]) -> bool {
    let apart = (one > 0 && other > 0) || (one < 0 && other < 0);
    apart && falls_twice(ring)
}

/// Whether the outline descends on both sides from its highest corner to its lowest one.
fn falls_twice(ring: [Spot; 4]) -> bool {
    let [a, b, c, d] = ring.map(|spot| spot.y);
    let rises = [a <= b, b <= c, c <= d, d <= a];
    // one change of direction at the highest corner, and one at the lowest
    (0..4).filter(|&k| rises[k] != rises[(k + 1) % 4]).count() == 2
}

/// A corner of a polygon, and the values (· 2⁸) that are interpolated between corners.
#[derive(Clone, Copy)]
pub(super) struct Corner<const K: usize> {
    pub(super) spot: Spot,
    pub(super) values: [i32; K],
}

impl Corner<0> {
    const fn plain(spot: Spot) -> Self {
        Self { spot, values: [] }
    }
}

/// The part of a row of pixels inside a polygon.
pub(super) struct Span<const K: usize> {
    pub(super) row: i32,
    /// The first column on the target, and the column after the last one.
    pub(super) left: i32,
    pub(super) right: i32,
    /// The first column and the number of columns, on the target and beside it.
    pub(super) first: i32,
    pub(super) count: i32,
    /// The values at both ends, · 2¹⁶.
    pub(super) from: [i32; K],
    pub(super) to: [i32; K],
}

impl<const K: usize> Span<K> {
    /// The pixels on the target.
    #[inline(always)]
    pub(super) fn area(&self) -> Rectangle {
        Rectangle::new(Point::new(self.left, self.row), Size::new((self.right - self.left) as u32, 1))
    }
}

/// Passes the span of each row of a polygon to `fill`. Both sides of the polygon must descend all the way.
#[inline(always)]
pub(super) fn outline<E, const N: usize, const K: usize>(
    ring: [Corner<K>; N],
    area: &Rectangle,
    mut fill: impl FnMut(Span<K>) -> Result<(), E>,
) -> Result<(), E> {
    let (mut highest, mut lowest) = (0, ring[0].spot.y);
    for (index, corner) in ring.iter().enumerate() {
        if corner.spot.y < ring[highest].spot.y {
            highest = index;
        }
        lowest = lowest.max(corner.spot.y);
    }
    let (low, high) = (area.top_left, area.top_left + area.size);
    let mut row = next_middle(ring[highest].spot.y).max(low.y);
    let end = next_middle(lowest).min(high.y);
    let [mut one, mut other] = [1, N - 1].map(|step| Side::new(highest, step));
    while row < end {
        one.reach(&ring, row);
        other.reach(&ring, row);
        let until = one.until.min(other.until).min(end);
        while row < until {
            if one.edge.x > other.edge.x {
                // seldom: the highest corner does not tell which side is the left one
                core::mem::swap(&mut one, &mut other);
            }
            let (a, b) = (&one.edge, &other.edge);
            let [first, end] = [a, b].map(|edge| next_middle(edge.x >> 9));
            let (left, right) = (first.clamp(low.x, high.x), end.clamp(low.x, high.x));
            if left < right {
                fill(Span { row, left, right, first, count: end - first, from: a.values, to: b.values })?;
            }
            one.edge.go_on();
            other.edge.go_on();
            row += 1;
        }
    }
    Ok(())
}

/// The first pixel whose middle is at or after a place (pixels · 256).
pub(super) const fn next_middle(place: i32) -> i32 {
    (place + 127) >> 8
}

/// One side of a polygon, from its highest corner downwards.
struct Side<const K: usize> {
    /// The corner at which the edge ends.
    corner: usize,
    /// The step from one corner to the next around the ring.
    step: usize,
    edge: Edge<K>,
    /// The row after the edge's last one.
    until: i32,
}

impl<const K: usize> Side<K> {
    const fn new(highest: usize, step: usize) -> Self {
        Self { corner: highest, step, edge: Edge { x: 0, slope: 0, values: [0; K], slopes: [0; K] }, until: i32::MIN }
    }

    /// Advances to the edge that crosses a row. The row must not be below the lowest corner.
    fn reach<const N: usize>(&mut self, ring: &[Corner<K>; N], row: i32) {
        while self.until <= row {
            let start = ring[self.corner];
            self.corner =
                if self.corner + self.step < N { self.corner + self.step } else { self.corner + self.step - N };
            let end = ring[self.corner];
            self.until = next_middle(end.spot.y);
            if self.until > row {
                self.edge = Edge::new(start, end, row);
            }
        }
    }
}

/// An edge, followed downwards row by row. Both faces of a common edge compute the same line.
struct Edge<const K: usize> {
    /// The column, pixels · 2¹⁷.
    x: i32,
    /// The change of `x` per row.
    slope: i32,
    /// Values · 2¹⁶.
    values: [i32; K],
    slopes: [i32; K],
}

impl<const K: usize> Edge<K> {
    /// An edge from the middle of a row of pixels on. The row lies between the ends, so every place on the way fits 32 bits.
    fn new(start: Corner<K>, end: Corner<K>, row: i32) -> Self {
        let (from, to) = (start.spot, end.spot);
        let height = to.y - from.y;
        // times 2⁹: the end of an edge of 100 pixels is off by a fifth of a pixel at most, and 4096 pixels fit 32 bits
        let slope = quotient((to.x - from.x) << 9, height);
        let below = 256 * row + 128 - from.y;
        let slopes =
            core::array::from_fn(|k| quotient((end.values[k] - start.values[k]) << 8, (height + 15) >> 4) << 4);
        Self {
            x: (from.x << 9).wrapping_add(slope.wrapping_mul(below)),
            slope: slope.wrapping_mul(256),
            values: core::array::from_fn(|k| (start.values[k] << 8) + (slopes[k] >> 8) * below),
            slopes,
        }
    }

    /// Advances to the next row.
    #[inline(always)]
    fn go_on(&mut self) {
        self.x = self.x.wrapping_add(self.slope);
        for k in 0..K {
            self.values[k] += self.slopes[k];
        }
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::Dimensions;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::{Gray4, GrayColor};
    use embedded_graphics::primitives::PointsIter;

    use super::*;

    const fn spot(x: f64, y: f64) -> Spot {
        Spot { x: (x * 256.0) as i32, y: (y * 256.0) as i32 }
    }

    fn fill(corners: [Spot; 3], color: Gray4, display: &mut MockDisplay<Gray4>) {
        triangle(corners, color, &display.bounding_box(), display).unwrap();
    }

    #[test]
    fn pixels_whose_middle_is_inside_are_filled() {
        let mut display = MockDisplay::new();
        fill([spot(0.0, 0.0), spot(8.0, 0.0), spot(0.0, 4.0)], Gray4::WHITE, &mut display);
        display.assert_pattern(&["FFFFFFF", "FFFFF  ", "FFF    ", "F      "]);
    }

    #[test]
    fn a_fan_covers_its_polygon_once() {
        // Drawing a pixel twice or beside the display panics here.
        let hub = spot(30.3, 31.7);
        let rim = |k: usize| {
            let angle = k as f64 * 0.41;
            spot(30.3 + 29.0 * libm::cos(angle), 31.7 + 29.0 * libm::sin(angle))
        };
        let mut display = MockDisplay::new();
        for k in 0..15 {
            fill([rim(k + 1), hub, rim(k)], Gray4::new(k as u8), &mut display);
        }
        let filled = display.affected_area().rows().flat_map(|y| (0..64).map(move |x| Point::new(x, y)));
        let filled = filled.filter(|&at| display.get_pixel(at).is_some()).count();
        let area: i64 = (0..15).map(|k| turn(hub, rim(k), rim(k + 1)) / 2).sum();
        assert!((filled as f64 - area as f64 / 65536.0).abs() < 30.0, "{filled} {area}");
    }

    #[test]
    fn a_face_has_the_pixels_of_its_triangles() {
        let mut state = 1_u32;
        let mut place = || {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> 18) as i32
        };
        let (mut at_once, mut pixels, mut others) = (0, 0, 0);
        for _ in 0..2_000 {
            let corners = [0; 4].map(|_| Spot { x: place(), y: place() });
            let [p, q, s, t] = corners;
            let mut expected = MockDisplay::new();
            let mut found = MockDisplay::new();
            for display in [&mut expected, &mut found] {
                display.set_allow_overdraw(true);
            }
            fill([q, p, s], Gray4::WHITE, &mut expected);
            fill([t, q, s], Gray4::WHITE, &mut expected);
            let (area, turns) = (found.bounding_box(), turns(corners));
            at_once += u32::from(turns[0].signum() == turns[1].signum() && falls_twice([p, q, t, s]));
            face(corners, turns, Gray4::WHITE, &area, &mut found).unwrap();
            for at in area.points() {
                pixels += u32::from(expected.get_pixel(at).is_some());
                others += u32::from(expected.get_pixel(at) != found.get_pixel(at));
            }
        }
        assert!((200..1_800).contains(&at_once), "{at_once} faces at once");
        // near a corner, both sides of a sliver may lie on the same side of a pixel's middle, in a different order in each triangle
        assert!(others * 100_000 < pixels, "{others} of {pixels} pixels differ");
    }

    #[test]
    fn what_is_beside_the_target_is_left_out() {
        let mut display = MockDisplay::new();
        fill([spot(-4000.0, -3000.0), spot(4000.0, -3000.0), spot(30.0, 4000.0)], Gray4::WHITE, &mut display);
        assert_eq!(display.affected_area(), display.bounding_box());
    }
}
