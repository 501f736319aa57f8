//! Filled triangles.
//!
//! The corners lie anywhere between pixels and each pixel belongs to the triangle that covers its middle, so that faces with a common
//! edge neither overlap nor leave a gap. (The triangle of `embedded-graphics` joins middles of pixels, draws common edges twice and
//! walks all its edges again for each row.)

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::primitives::Rectangle;

use super::camera::Spot;

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
    mut corners: [Spot; 3],
    color: D::Color,
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    corners.sort_unstable_by_key(|corner| corner.y);
    let [top, middle, bottom] = corners;
    let (first, last) = (area.top_left, area.top_left + area.size);
    let rows = next_middle(top.y).max(first.y)..next_middle(bottom.y).min(last.y);
    let columns = |x: i32| next_middle(x).clamp(first.x, last.x);
    if rows.is_empty() {
        return Ok(());
    }
    let mut long = Edge::new(top, bottom, rows.start);
    let mut short = Edge::new(top, middle, rows.start);
    let lower = next_middle(middle.y);
    if rows.start >= lower {
        short = Edge::new(middle, bottom, rows.start);
    }
    for row in rows {
        if row == lower {
            short = Edge::new(middle, bottom, row);
        }
        let (a, b) = (long.next(), short.next());
        let (left, right) = (columns(a.min(b)), columns(a.max(b)));
        if left < right {
            target.fill_solid(&Rectangle::new(Point::new(left, row), Size::new((right - left) as u32, 1)), color)?;
        }
    }
    Ok(())
}

/// The first pixel whose middle is not before a place.
pub(super) const fn next_middle(place: i32) -> i32 {
    (place + 127) >> 8
}

/// A line downwards, row by row. A common edge is the same line to both its triangles.
struct Edge {
    /// Pixels · 2¹⁷.
    x: i64,
    /// Of a row.
    slope: i64,
}

impl Edge {
    /// From the middle of a row of pixels on.
    fn new(start: Spot, end: Spot, row: i32) -> Self {
        let height = end.y - start.y;
        // times 2⁹: an edge of 100 pixels ends a fifth of a pixel off at most, and 32 bits hold 4096 pixels
        let slope = i64::from(if height == 0 { 0 } else { ((end.x - start.x) << 9) / height });
        let below = i64::from(256 * row + 128 - start.y);
        Self { x: (i64::from(start.x) << 9) + slope * below, slope: slope * 256 }
    }

    /// Where it crosses this row, pixels · 256; the next time, the next.
    #[inline]
    fn next(&mut self) -> i32 {
        let x = (self.x >> 9) as i32;
        self.x += self.slope;
        x
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::Dimensions;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::{Gray4, GrayColor};

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
    fn what_is_beside_the_target_is_left_out() {
        let mut display = MockDisplay::new();
        fill([spot(-4000.0, -3000.0), spot(4000.0, -3000.0), spot(30.0, 4000.0)], Gray4::WHITE, &mut display);
        assert_eq!(display.affected_area(), display.bounding_box());
    }
}
