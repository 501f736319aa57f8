//! Filled faces whose level of light is interpolated between corners (H. Gouraud, *Continuous shading of curved surfaces*, 1971).
//!
//! The level changes linearly along each side of a face, and along each row from one side to the other. A pixel takes an addition and a table look-up.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::primitives::Rectangle;

use super::camera::Spot;
use super::fill::{Corner, Span, is_one_span, outline};
use super::quotient::quotient;
use super::ramp::LEVELS;

/// Fills both triangles (q, p, s) and (t, q, s) of a face with the colours of levels (· 2⁸) that are interpolated between its corners.
pub(super) fn face<D: DrawTarget>(
    [p, q, s, t]: [Spot; 4],
    turns: [i64; 2],
    levels: [i32; 4],
    ramp: &[D::Color; LEVELS],
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    // half a level more, so that truncation rounds to nearest
    let [at_p, at_q, at_s, at_t] = levels.map(|level| [level + 128]);
    let corner = |spot, values| Corner { spot, values };
    let [p, q, s, t] = [corner(p, at_p), corner(q, at_q), corner(s, at_s), corner(t, at_t)];
    let ring = [p, q, t, s];
    if is_one_span(turns, ring.map(|corner| corner.spot)) {
        return polygon(ring, ramp, area, target);
    }
    polygon([q, p, s], ramp, area, target)?;
    polygon([t, q, s], ramp, area, target)
}

fn polygon<D: DrawTarget, const N: usize>(
    ring: [Corner<1>; N],
    ramp: &[D::Color; LEVELS],
    area: &Rectangle,
    target: &mut D,
) -> Result<(), D::Error> {
    outline(ring, area, |span| {
        let (slope, mut level) = even(&span);
        let colors = core::iter::repeat_with(move || {
            // levels are always below the end of the ramp: the mask saves a bounds check
            let color = ramp[(level >> 16) as usize & (LEVELS - 1)];
            level += slope;
            color
        });
        target.fill_contiguous(&span.area(), colors)
    })
}

/// The change of the level (· 2¹⁶) from pixel to pixel, and the level of the first pixel on the target.
#[inline(always)]
fn even(span: &Span<1>) -> (i32, i32) {
    let part = match RECIPROCALS.get(span.count as usize) {
        Some(part) => i32::from(*part),
        None => quotient(1 << 14, span.count),
    };
    let ([from], [to]) = (span.from, span.to);
    let slope = (((to - from) >> 8) * part) >> 6;
    // the middle of the first pixel is half a pixel further
    let level = from + (slope >> 1);
    let beside = span.left - span.first;
    (slope, if beside > 0 { level + slope * beside } else { level })
}

/// 2¹⁴ divided by each number of pixels.
const RECIPROCALS: [u16; 256] = {
    let mut all = [0; 256];
    let mut count = 1;
    while count < 256 {
        all[count] = (1 << 14) / count as u16;
        count += 1;
    }
    all
};

#[cfg(test)]
mod tests {
    extern crate std;
    use std::vec::Vec;

    use embedded_graphics::geometry::{Dimensions, Point};
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::{Gray8, GrayColor};

    use super::*;
    use crate::render::fill;

    /// Pseudo-random numbers of a given number of bits.
    fn numbers() -> impl FnMut(u32) -> i32 {
        let mut state = 1_u32;
        move |bits| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            (state >> (32 - bits)) as i32
        }
    }

    /// A ramp whose colours are greys equal to their levels.
    fn ramp() -> [Gray8; LEVELS] {
        core::array::from_fn(|level| Gray8::new(level as u8))
    }

    fn pixels(display: &MockDisplay<Gray8>) -> Vec<(Point, u8)> {
        let places = (0..64).flat_map(|y| (0..64).map(move |x| Point::new(x, y)));
        places.filter_map(|at| Some((at, display.get_pixel(at)?.luma()))).collect()
    }

    /// The pixels that a triangle covers on a display of 64 × 64 pixels. It may reach beyond the display.
    fn filled(corners: [Spot; 3], levels: [i32; 3]) -> Vec<(Point, u8)> {
        let mut display = MockDisplay::new();
        let ring = core::array::from_fn(|k| Corner { spot: corners[k], values: [(levels[k] << 8) + 128] });
        polygon::<_, 3>(ring, &ramp(), &display.bounding_box(), &mut display).unwrap();
        pixels(&display)
    }

    /// The level at the middle of a pixel by barycentric coordinates, and the least of these coordinates.
    fn expected([a, b, c]: [Spot; 3], levels: [i32; 3], at: Point) -> (f64, f64) {
        let spot = Spot { x: at.x * 256 + 128, y: at.y * 256 + 128 };
        let whole = fill::turn(a, b, c) as f64;
        let turns = [fill::turn(spot, b, c), fill::turn(a, spot, c), fill::turn(a, b, spot)];
        let parts = turns.map(|turn| turn as f64 / whole);
        let level = parts.iter().zip(levels).map(|(part, level)| part * f64::from(level)).sum();
        (level, parts.into_iter().fold(f64::INFINITY, f64::min))
    }

    #[test]
    fn levels_are_planes_over_triangles() {
        let mut number = numbers();
        let mut inside = 0;
        for _ in 0..3_000 {
            let corners = [0; 3].map(|_| Spot { x: number(15) - 8_000, y: number(15) - 8_000 });
            let levels = [0; 3].map(|_| number(7));
            let (low, high) = (levels.into_iter().min().unwrap(), levels.into_iter().max().unwrap());
            for (at, found) in filled(corners, levels) {
                assert!((low..=high).contains(&i32::from(found)), "{found} of {low} to {high}");
                let (level, least) = expected(corners, levels, at);
                let (before, _) = expected(corners, levels, at - Point::new(1, 0));
                // nearer to a side, its rounding matters
                if least > 0.02 {
                    inside += 1;
                    // a span of whole pixels begins and ends with the levels of its sides
                    let slack = 1.2 + (level - before).abs();
                    let error = (f64::from(found) - level).abs();
                    assert!(error <= slack, "{found}, not {level}, at {at}: {corners:?} {levels:?}");
                }
            }
        }
        assert!(inside > 100_000, "{inside} inside");
    }

    #[test]
    fn a_face_has_the_pixels_of_a_flat_one() {
        let mut number = numbers();
        for _ in 0..1_000 {
            let corners = [0; 4].map(|_| Spot { x: number(15) - 8_000, y: number(15) - 8_000 });
            let turns = fill::turns(corners);
            let (mut flat, mut smooth) = (MockDisplay::new(), MockDisplay::new());
            let area = flat.bounding_box();
            for display in [&mut flat, &mut smooth] {
                display.set_allow_overdraw(true);
            }
            fill::face(corners, turns, Gray8::new(90), &area, &mut flat).unwrap();
            face(corners, turns, [90 << 8; 4], &ramp(), &area, &mut smooth).unwrap();
            assert!(pixels(&flat) == pixels(&smooth), "{corners:?}");
        }
    }
}
