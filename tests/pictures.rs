//! Pictures of one scene in three number types, on displays of several colours, seen from outside the crate.

use std::convert::Infallible;

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::framebuffer::{Framebuffer, buffer_size};
use embedded_graphics::geometry::{Dimensions, OriginDimensions, Point, Size};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::raw::{BigEndian, LittleEndian, RawU2, RawU16, RawU24};
use embedded_graphics::pixelcolor::{Gray4, GrayColor, PixelColor, Rgb565, Rgb888, RgbColor};
use embedded_graphics::primitives::PrimitiveStyle;
use embedded_graphics::{Drawable, Pixel};
use kerchief::render::pattern::{Border, Gingham, Place, Width};
use kerchief::render::{Ball, Camera, Canvas, Ground, Light, Look, Shade, Shaded, Shadow, Solids, View, Wireframe};
use kerchief::{Cloth, Grid, Q24, Scalar, Units, Vec3};

const UNITS: Units = Units::sheet([16, 16], [15.0, 15.0], 1.0, 0.1, 1);
const RADIUS: f64 = 4.0;
const RED: Rgb888 = Rgb888::new(178, 34, 38);
const CREAM: Rgb888 = Rgb888::new(250, 240, 226);
const VIEW: View = View::new(-25.0, 22.0);

type Screen<const W: usize, const H: usize, const N: usize> = Framebuffer<Rgb888, RawU24, BigEndian, W, H, N>;

/// A sheet over a ball: a cap with a folded skirt that hangs from it.
fn draped<S: Scalar>() -> Cloth<S, 16, 16> {
    let mut cloth = Cloth::lay(&UNITS, UNITS.point([-7.5, -7.5, 0.0]));
    for node in Grid::<S, 16, 16>::nodes() {
        let (x, y) = (node.column as f64 - 7.5, node.row as f64 - 7.5);
        let (along, angle, radius) = (x.hypot(y), y.atan2(x), RADIUS + 0.3);
        let hanging = (along - radius * 1.2).max(0.0);
        let turned = (along / radius).min(1.2);
        let away = radius * turned.sin() + hanging * (0.3 + 0.1 * (6.0 * angle).cos());
        let height = (radius * turned.cos() - 0.9 * hanging).max(0.1 - RADIUS);
        cloth.position.set(node, Vec3::from_f64([away * angle.cos(), away * angle.sin(), height]));
    }
    cloth
}

fn camera<S: Scalar>(screen: Size) -> Camera<S> {
    Camera::new(&VIEW.fit(UNITS.point([-7.0, -7.0, -RADIUS]), UNITS.point([7.0, 7.0, RADIUS]), screen), screen)
}

/// Draws a picture with all kinds of contents.
fn draw<S: Scalar, D: DrawTarget<Color: Shade, Error = Infallible> + Dimensions>(target: &mut D) {
    let gingham = Gingham { width: Width::cells(1), tones: [CREAM, RED] };
    let ball = Ball::<S>::new(UNITS.point([0.0; 3]), UNITS.length(RADIUS), Rgb888::new(70, 110, 140));
    let ground = Ground::new(UNITS.point([0.0, 0.0, -RADIUS]), UNITS.length(30.0));
    let look = Look::new(Light::new(-62.0, 52.0), Border { width: Width::cells(1), tone: RED, inner: gingham })
        .solids(ball)
        .backdrop(ground.shadow(Shadow::<64>::new(Rgb888::new(128, 118, 112))));
    let Ok(()) = Shaded::new(look).draw(&draped::<S>(), &camera(target.bounding_box().size), target);
}

#[test]
fn all_number_types_draw_the_same_wireframe() {
    fn picture<S: Scalar>() -> Vec<u8> {
        let mut screen = Screen::<240, 240, { buffer_size::<Rgb888>(240, 240) }>::new();
        let style = PrimitiveStyle::with_stroke(Rgb888::WHITE, 1);
        let (cloth, camera) = (draped::<S>(), camera(screen.size()));
        let Ok(()) = Wireframe::new(&cloth, &camera).into_styled(style).draw(&mut screen);
        screen.data().to_vec()
    }
    let expected = picture::<f64>();
    assert!(expected.chunks(3).filter(|pixel| *pixel == [255; 3]).count() > 2_000);
    assert!(expected == picture::<f32>(), "f32");
    assert!(expected == picture::<Q24>(), "q24");
}

#[test]
fn all_number_types_draw_the_same_shaded_picture() {
    fn picture<S: Scalar>() -> Box<Screen<240, 240, { buffer_size::<Rgb888>(240, 240) }>> {
        let mut screen = Box::new(Screen::new());
        draw::<S, _>(&mut *screen);
        screen
    }
    let expected = picture::<f64>();
    for (name, found) in [("f32", picture::<f32>()), ("q24", picture::<Q24>())] {
        let differences = || expected.data().iter().zip(found.data()).map(|(a, b)| a.abs_diff(*b));
        println!("{name}: {} of {} channels differ", differences().filter(|&d| d > 0).count(), expected.data().len());
        // Tones may be rounded to the other side. An edge that crosses the middle of a pixel would differ by more; here none does.
        assert!(differences().all(|difference| difference <= 2), "{name}: {:?}", differences().max());
    }
}

#[test]
fn a_small_gray_display_shows_the_drape() {
    let mut display = MockDisplay::<Gray4>::new();
    display.set_allow_overdraw(true);
    draw::<Q24, _>(&mut display);
    // A coarse picture: the mean of each block of 4 × 4 pixels
    let rows: Vec<String> = (0..16)
        .map(|row| {
            let mean = |column| {
                let pixels = (0..16).map(|k| Point::new(4 * column + k % 4, 4 * row + k / 4));
                pixels.map(|at| u32::from(display.get_pixel(at).unwrap().luma())).sum::<u32>() / 16
            };
            (0..16).map(|column| char::from_digit(mean(column), 16).unwrap()).collect()
        })
        .collect();
    assert_eq!(
        rows,
        [
            "cccccccccccccccc",
            "cccccccccccccccc",
            "cccccccccccccccc",
            "ccccccbbcccccccc",
            "cccccb8a98cccccc",
            "cccca8c967accccc",
            "cccc8998988ccccc",
            "ccca5897555ccccc",
            "cccc96753359cccc",
            "ccccb6544789bccc",
            "ccccca989abccccd",
            "cccccccccccccccc",
            "dccccccccccccddd",
            "ccdddcccccccccdd",
            "cccdcccddddccddc",
            "dddccccddcccdddd",
        ]
    );
}

/// The colours of a paper display with three inks, in two bits.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Ink {
    Black,
    White,
    Red,
}

impl PixelColor for Ink {
    type Raw = RawU2;
}

impl Shade for Ink {
    fn nearest(tone: Rgb888) -> Self {
        match (tone.r() < 128, tone.g() < 128) {
            (true, _) => Self::Black,
            (false, true) => Self::Red,
            (false, false) => Self::White,
        }
    }
}

/// A paper display of 24 × 24 pixels.
struct Paper([[Ink; 24]; 24]);

impl OriginDimensions for Paper {
    fn size(&self) -> Size {
        Size::new(24, 24)
    }
}

impl DrawTarget for Paper {
    type Color = Ink;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Ink>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, ink) in pixels {
            self.0[at.y as usize][at.x as usize] = ink;
        }
        Ok(())
    }
}

/// A solid of one's own: a mark at the camera's target, over the sheet, without a shadow.
struct Mark;

impl<S: Scalar> Solids<S> for Mark {
    fn count(&self) -> usize {
        1
    }

    fn depth(&self, _: usize, _: &Camera<S>) -> S {
        S::ONE
    }

    fn hides(&self, _: usize, _: Vec3<S>, _: &Camera<S>) -> bool {
        true
    }

    fn shades(&self, _: Vec3<S>, _: Vec3<S>) -> bool {
        false
    }

    fn draw<D: DrawTarget<Color = Rgb888>>(
        &self,
        _: usize,
        camera: &Camera<S>,
        _: &Light,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let at = camera.project(camera.target()).into_iter().map(|at| Pixel(at, Rgb888::BLACK));
        target.draw_iter(at)
    }
}

#[test]
fn colours_patterns_and_solids_of_ones_own_are_welcome() {
    let halves = |at: &Place| if at.across < at.width / 2 { Rgb888::RED } else { Rgb888::WHITE };
    let light = Light { lamp: Rgb888::BLACK, sky: Rgb888::WHITE, ground: Rgb888::WHITE, ..Light::new(0.0, 90.0) };
    let mut shaded = Shaded::new(Look::new(light, halves).solids(Mark).backdrop(Rgb888::BLACK));
    let cloth = Cloth::<Q24, 16, 16>::lay(&UNITS, UNITS.point([-7.5, -7.5, 0.0]));
    let camera = Camera::new(&View::new(0.0, 90.0).at(UNITS.point([0.0; 3]), UNITS.length(50.0)), Size::new(24, 24));
    let mut paper = Paper([[Ink::White; 24]; 24]);
    let Ok(()) = shaded.draw(&cloth, &camera, &mut paper);
    assert_eq!(
        paper.0[12],
        std::array::from_fn(|x| match x {
            5..=11 => Ink::Red,
            13..=18 => Ink::White,
            _ => Ink::Black,
        })
    );
}

#[test]
fn a_canvas_sends_the_box_around_a_moving_sheet() {
    type Buffer = Framebuffer<Rgb565, RawU16, LittleEndian, 64, 64, { buffer_size::<Rgb565>(64, 64) }>;
    let mut cloth = Cloth::<Q24, 16, 16>::lay(&UNITS, UNITS.point([-7.5, -7.5, 0.0]));
    let camera = Camera::new(&View::new(0.0, 90.0).at(UNITS.point([0.0; 3]), UNITS.length(120.0)), Size::new(64, 64));
    let mut canvas = Canvas::new(Buffer::new());
    let mut sent = || {
        let mut display = MockDisplay::<Rgb565>::new();
        let Ok(()) = canvas.erase(Rgb565::BLACK);
        let Ok(()) = Wireframe::new(&cloth, &camera).draw(&mut canvas);
        let Ok(()) = canvas.flush(&mut display);
        cloth.position.change(|x| x + Vec3::from_f64([6.0, 0.0, 0.0]));
        display.affected_area()
    };
    let (first, second) = (sent(), sent());
    let width = |cells: f64| (cells / 120.0 * 32.0 / 15_f64.to_radians().tan()).round() as u32 + 1;
    assert_eq!(first.size, Size::new(width(15.0), width(15.0)));
    assert_eq!(second.size, Size::new(width(21.0), width(15.0)));
}
