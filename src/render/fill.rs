//! Filled triangles.
//!
//! The corners lie anywhere between pixels and each pixel belongs to the triangle that covers its middle, so that faces with a common
//! edge neither overlap nor leave a gap. (The triangle of `embedded-graphics` joins middles of pixels, draws common edges twice and
//! walks all its edges again for each row.)

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;

use super::camera::Spot;
use super::quotient::quotient;

/// Twice the area that a triangle turns through from `a` over `b` to `c`: positive to the right-hand side (clockwise on a screen).
pub(super) fn turn(a: Spot, b: Spot, c: Spot) -> i64 {
    let (ab, ac) = ((b.x - a.x, b.y - a.y), (c.x - a.x, c.y - a.y));
    // a Cortex-M0 has no products of 64 bits: up to 128 pixels there is no need of one
    let short = [ab.0, ab.1, ac.0, ac.1].into_iter().all(|side| side.unsigned_abs() < 1 << 15);
    if short {
        return i64::from(ab.0 * ac.1 - ab.1 * ac.0);
    }
    i64::from(ab.0) * i64::from(ac.1) - i64::from(ab.1) * i64::from(ac.0)
}

/// Fills the pixels of `area`, the target's bounding box, whose middle lies in the triangle.
pub(super) fn triangle<D: DrawTarget>(
    corners: [Spot; 3],
    color: D::Color,
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    outline(corners, color, area, target)
}

/// What a face's triangles (q, p, s) and (t, q, s) [`turn`] through.
pub(super) fn turns([p, q, s, t]: [Spot; 4]) -> [i64; 2] {
    [turn(q, p, s), turn(t, q, s)]
}

/// Fills both triangles of a face.
pub(super) fn face<D: DrawTarget>(
    [p, q, s, t]: [Spot; 4],
    [one, other]: [i64; 2],
    color: D::Color,
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    let ring = [p, q, t, s];
    // lying on either side of their common edge, they are one span in each row unless their outline turns back up
    let apart = (one > 0 && other > 0) || (one < 0 && other < 0);
    if apart && falls_twice(ring) {
        return outline(ring, color, area, target);
    }
    triangle([q, p, s], color, area, target)?;
    triangle([t, q, s], color, area, target)
}

/// Whether both ways round from the highest corner lead down to the lowest one.
fn falls_twice(ring: [Spot; 4]) -> bool {
    let [a, b, c, d] = ring.map(|spot| spot.y);
    let rises = [a <= b, b <= c, c <= d, d <= a];
    // one change of direction at the highest corner, and one at the lowest
    (0..4).filter(|&k| rises[k] != rises[(k + 1) % 4]).count() == 2
}

/// Fills a polygon both of whose sides lead downwards all the way.
fn outline<D: DrawTarget, const N: usize>(
    ring: [Spot; N],
    color: D::Color,
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    let (mut highest, mut lowest) = (0, ring[0].y);
    for (index, corner) in ring.iter().enumerate() {
        if corner.y < ring[highest].y {
            highest = index;
        }
        lowest = lowest.max(corner.y);
    }
    let (first, last) = (area.top_left, area.top_left + area.size);
    let columns = |x: i32| next_middle(x).clamp(first.x, last.x);
    let mut row = next_middle(ring[highest].y).max(first.y);
    let end = next_middle(lowest).min(last.y);
    let [mut one, mut other] = [1, N - 1].map(|step| Side::new(highest, step));
    while row < end {
        one.reach(&ring, row);
        other.reach(&ring, row);
        let until = one.until.min(other.until).min(end);
        while row < until {
            let (a, b) = (one.edge.next(), other.edge.next());
            let (left, right) = (columns(a.min(b)), columns(a.max(b)));
            if left < right {
                target
                    .fill_solid(&Rectangle::new(Point::new(left, row), Size::new((right - left) as u32, 1)), color)?;
            }
            row += 1;
        }
    }
    Ok(())
}

/// The first pixel whose middle is not before a place.
pub(super) const fn next_middle(place: i32) -> i32 {
    (place + 127) >> 8
}

/// One side of a polygon, from its highest corner downwards.
struct Side {
    /// The corner at which the edge ends.
    corner: usize,
    /// From one corner to the next, round the ring.
    step: usize,
    edge: Edge,
    /// The row after the edge's last one.
    until: i32,
}

impl Side {
    const fn new(highest: usize, step: usize) -> Self {
        Self { corner: highest, step, edge: Edge { x: 0, slope: 0 }, until: i32::MIN }
    }

    /// Goes on to the edge that crosses a row, which is not below the lowest corner.
    fn reach<const N: usize>(&mut self, ring: &[Spot; N], row: i32) {
        while self.until <= row {
            let start = ring[self.corner];
            self.corner =
                if self.corner + self.step < N { self.corner + self.step } else { self.corner + self.step - N };
            let end = ring[self.corner];
            self.until = next_middle(end.y);
            if self.until > row {
                self.edge = Edge::new(start, end, row);
            }
        }
    }
}

/// A line downwards, row by row. A common edge is the same line to both its faces.
struct Edge {
    /// Pixels · 2¹⁷.
    x: i32,
    /// Of a row.
    slope: i32,
}

impl Edge {
    /// From the middle of a row of pixels on, which lies between the ends: then 32 bits hold every place on the way.
    fn new(start: Spot, end: Spot, row: i32) -> Self {
        let height = end.y - start.y;
        // times 2⁹: an edge of 100 pixels ends a fifth of a pixel off at most, and 32 bits hold 4096 pixels
        let slope = quotient((end.x - start.x) << 9, height);
        let below = 256 * row + 128 - start.y;
        Self { x: (start.x << 9).wrapping_add(slope.wrapping_mul(below)), slope: slope.wrapping_mul(256) }
    }

    /// Where it crosses this row, pixels · 256; the next time, the next.
    #[inline]
    fn next(&mut self) -> i32 {
        let x = self.x >> 9;
        self.x = self.x.wrapping_add(self.slope);
        x
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
        // near a corner both sides of a sliver may lie on the same side of a pixel's middle, in another order for each of its triangles
        assert!(others * 100_000 < pixels, "{others} of {pixels} pixels differ");
    }

    #[test]
    fn what_is_beside_the_target_is_left_out() {
        let mut display = MockDisplay::new();
        fill([spot(-4000.0, -3000.0), spot(4000.0, -3000.0), spot(30.0, 4000.0)], Gray4::WHITE, &mut display);
        assert_eq!(display.affected_area(), display.bounding_box());
    }
}
