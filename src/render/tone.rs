//! Tones, the colours in which pictures are computed, and their conversion to the colours of displays.

use embedded_graphics::Pixel;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Dimensions, Point};
use embedded_graphics::pixelcolor::{
    Bgr555, Bgr565, Bgr888, BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb555, Rgb565, Rgb888, RgbColor,
};
use embedded_graphics::primitives::{PointsIter, Rectangle};

/// A display's colour that can represent a tone, a colour of 8 bits per channel.
///
/// Implemented for the colours of `embedded-graphics`. For a colour of your own, [`nearest`](Self::nearest) is enough:
///
/// ```
/// use embedded_graphics::pixelcolor::{PixelColor, Rgb888, RgbColor, raw::RawU2};
/// use kerchief::render::Shade;
///
/// /// Electronic paper with a third ink.
/// #[derive(Clone, Copy, PartialEq)]
/// enum Ink { Black, White, Red }
///
/// impl PixelColor for Ink {
///     type Raw = RawU2;
/// }
///
/// impl Shade for Ink {
///     fn nearest(tone: Rgb888) -> Self {
///         match (tone.r() < 128, tone.g() < 128) {
///             (true, _) => Self::Black,
///             (false, true) => Self::Red,
///             (false, false) => Self::White,
///         }
///     }
/// }
/// ```
pub trait Shade: PixelColor {
    /// Whether even an area of one tone is drawn as a pattern of several colours.
    const PATTERNED: bool = false;

    /// The colour nearest to a tone.
    fn nearest(tone: Rgb888) -> Self;

    /// The colour of the pixel at a point, chosen so that the pixels around it have the tone on average. By default, the nearest colour.
    fn dithered(tone: Rgb888, _at: Point) -> Self {
        Self::nearest(tone)
    }
}

/// Thresholds 0 to 15 of ordered dithering (Bayer, "An optimum method for two-level rendition of continuous-tone pictures", 1973).
const BAYER: [[u8; 4]; 4] = [[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]];

/// One of the two levels of 0 to `MAX` next to a channel's value, chosen by the threshold of the pixel.
fn dither<const MAX: u16>(channel: u8, at: Point) -> u8 {
    let threshold = BAYER[(at.y & 3) as usize][(at.x & 3) as usize];
    // extended to 0 to 256, so that full brightness gives the highest level at every pixel
    let part = u16::from(channel) + u16::from(channel >> 7);
    ((part * MAX + u16::from(threshold * 16 + 8)) >> 8) as u8
}

fn luma(tone: Rgb888) -> u8 {
    Gray8::from(tone).luma()
}

macro_rules! rgb {
    ($($color:ty: $r:literal $g:literal $b:literal),*) => {
        $(impl Shade for $color {
            fn nearest(tone: Rgb888) -> Self {
                tone.into()
            }
            fn dithered(tone: Rgb888, at: Point) -> Self {
                Self::new(dither::<$r>(tone.r(), at), dither::<$g>(tone.g(), at), dither::<$b>(tone.b(), at))
            }
        })*
    };
}

rgb!(Rgb555: 31 31 31, Bgr555: 31 31 31, Rgb565: 31 63 31, Bgr565: 31 63 31);

macro_rules! gray {
    ($($color:ty: $max:literal),*) => {
        $(impl Shade for $color {
            fn nearest(tone: Rgb888) -> Self {
                tone.into()
            }
            fn dithered(tone: Rgb888, at: Point) -> Self {
                Self::new(dither::<$max>(luma(tone), at))
            }
        })*
    };
}

gray!(Gray2: 3, Gray4: 15);

macro_rules! exact {
    ($($color:ty),*) => {
        $(impl Shade for $color {
            fn nearest(tone: Rgb888) -> Self {
                tone.into()
            }
        })*
    };
}

exact!(Rgb888, Bgr888, Gray8);

impl Shade for BinaryColor {
    const PATTERNED: bool = true;

    fn nearest(tone: Rgb888) -> Self {
        (luma(tone) >= 128).into()
    }

    fn dithered(tone: Rgb888, at: Point) -> Self {
        (dither::<1>(luma(tone), at) == 1).into()
    }
}

/// The channels red, green and blue of a tone.
pub(super) fn channels(tone: Rgb888) -> [i32; 3] {
    [tone.r(), tone.g(), tone.b()].map(i32::from)
}

/// Interpolates linearly: `from` at a `part` of 0, `to` at 256.
pub(super) fn mix(from: Rgb888, to: Rgb888, part: i32) -> Rgb888 {
    let channel = |from: u8, to: u8| (i32::from(from) + (((i32::from(to) - i32::from(from)) * part + 128) >> 8)) as u8;
    Rgb888::new(channel(from.r(), to.r()), channel(from.g(), to.g()), channel(from.b(), to.b()))
}

/// A draw target for tones, which draws on a display of any colour type.
#[derive(Debug)]
pub struct Toned<'a, D>(pub &'a mut D);

impl<D: DrawTarget> Dimensions for Toned<'_, D> {
    fn bounding_box(&self) -> Rectangle {
        self.0.bounding_box()
    }
}

impl<D: DrawTarget<Color: Shade>> DrawTarget for Toned<'_, D> {
    type Color = Rgb888;
    type Error = D::Error;

    fn draw_iter<I: IntoIterator<Item = Pixel<Rgb888>>>(&mut self, pixels: I) -> Result<(), D::Error> {
        self.0.draw_iter(pixels.into_iter().map(|Pixel(at, tone)| Pixel(at, D::Color::dithered(tone, at))))
    }

    fn fill_contiguous<I: IntoIterator<Item = Rgb888>>(&mut self, area: &Rectangle, tones: I) -> Result<(), D::Error> {
        self.0.fill_contiguous(area, area.points().zip(tones).map(|(at, tone)| D::Color::dithered(tone, at)))
    }

    fn fill_solid(&mut self, area: &Rectangle, tone: Rgb888) -> Result<(), D::Error> {
        if D::Color::PATTERNED {
            self.0.fill_contiguous(area, area.points().map(|at| D::Color::dithered(tone, at)))
        } else {
            self.0.fill_solid(area, D::Color::nearest(tone))
        }
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::Size;
    use embedded_graphics::mock_display::MockDisplay;

    use super::*;

    #[test]
    fn dithered_areas_have_their_tone_on_average() {
        let area = Rectangle::new(Point::zero(), Size::new(8, 8));
        for tone in 0..=255_u8 {
            let gray = Rgb888::new(tone, tone, tone);
            let bright = area.points().filter(|&at| BinaryColor::dithered(gray, at).is_on()).count();
            assert!((bright as f64 / 64.0 - f64::from(tone) / 255.0).abs() < 0.04, "{tone}: {bright}");
            let sum: u32 = area.points().map(|at| u32::from(Gray4::dithered(gray, at).luma())).sum();
            assert!((f64::from(sum) / 64.0 - f64::from(tone) / 17.0).abs() < 0.07, "{tone}: {sum}");
        }
    }

    #[test]
    fn black_and_white_stay_black_and_white() {
        for at in Rectangle::new(Point::zero(), Size::new(4, 4)).points() {
            assert_eq!(Rgb565::dithered(Rgb888::BLACK, at), Rgb565::BLACK);
            assert_eq!(Rgb565::dithered(Rgb888::WHITE, at), Rgb565::WHITE);
            assert_eq!(BinaryColor::dithered(Rgb888::WHITE, at), BinaryColor::On);
            assert_eq!(BinaryColor::dithered(Rgb888::BLACK, at), BinaryColor::Off);
        }
    }

    #[test]
    fn a_display_of_two_colours_shows_a_half_tone_as_a_pattern() {
        let mut display = MockDisplay::<BinaryColor>::new();
        Toned(&mut display)
            .fill_solid(&Rectangle::new(Point::zero(), Size::new(6, 3)), Rgb888::new(128, 128, 128))
            .unwrap();
        display.assert_pattern(&[".#.#.#", "#.#.#.", ".#.#.#"]);
    }

    #[test]
    fn mixtures_reach_both_ends() {
        let (a, b) = (Rgb888::new(10, 200, 30), Rgb888::new(250, 0, 30));
        assert_eq!(mix(a, b, 0), a);
        assert_eq!(mix(a, b, 256), b);
        assert_eq!(mix(a, b, 128), Rgb888::new(130, 100, 30));
    }
}
