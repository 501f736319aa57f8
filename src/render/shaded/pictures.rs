//! Tests that compare pictures as text.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::*;
use crate::cloth::Cloth;
use crate::render::{Ball, Finish, Light, View};
use crate::scalar::Q24;
use crate::units::{Length, Point as Spot, Units};

const UNITS: Units = Units::sheet([5, 5], [4.0, 4.0], 1.0, 0.1, 1);
const SCREEN: Size = Size::new(24, 24);
/// Light that leaves colours as they are.
const EVEN: Light = Light { lamp: Rgb888::BLACK, sky: Rgb888::WHITE, ground: Rgb888::WHITE, ..Light::new(0.0, 45.0) };

type Sheet<S> = Cloth<S, 5, 5>;

fn laid<S: Scalar>() -> Sheet<S> {
    Cloth::lay(&UNITS, UNITS.point([-2.0, -2.0, 0.0]))
}

fn hung<S: Scalar>() -> Sheet<S> {
    Cloth::hang(&UNITS, UNITS.point([-2.0, 0.0, 2.0]))
}

fn two_sided() -> Look<Rgb888, Rgb888> {
    Look::new(EVEN, Rgb888::RED).back(Rgb888::BLUE)
}

fn picture<S: Scalar, O: Solids<S>>(
    cloth: &Sheet<S>,
    look: Look<Rgb888, Rgb888, O>,
    view: &View,
) -> MockDisplay<Rgb888> {
    let mut display = MockDisplay::new();
    display.set_allow_overdraw(true);
    Shaded::new(look).draw(cloth, &Camera::new(view, SCREEN), &mut display).unwrap();
    display
}

#[test]
fn a_laid_sheet_shows_its_front_upwards() {
    let view = View::new(0.0, 90.0).at(Spot([0.0; 3]), Length(15.0));
    picture(&laid::<Q24>(), two_sided(), &view).assert_pattern(&[
        "                  ",
        "                  ",
        "                  ",
        "                  ",
        "                  ",
        "                  ",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
        "      RRRRRRRRRRRR",
    ]);
    let below = View::new(0.0, -90.0).at(Spot([0.0; 3]), Length(15.0));
    let display = picture(&laid::<Q24>(), two_sided(), &below);
    assert_eq!(display.get_pixel(Point::new(12, 12)), Some(Rgb888::BLUE));
}

#[test]
fn a_sheet_alone_covers_each_pixel_once() {
    let mut display = MockDisplay::<Rgb888>::new();
    let camera = Camera::new(&View::new(25.0, 40.0).at(Spot([0.0; 3]), Length(12.0)), SCREEN);
    Shaded::new(two_sided()).draw(&laid::<f32>(), &camera, &mut display).unwrap();
    display.assert_pattern(&[
        "                     ",
        "                     ",
        "                     ",
        "                     ",
        "                     ",
        "                     ",
        "                     ",
        "        RRRRR        ",
        "       RRRRRRRRR     ",
        "      RRRRRRRRRRRRRR ",
        "     RRRRRRRRRRRRRRRR",
        "    RRRRRRRRRRRRRRRR ",
        "   RRRRRRRRRRRRRRRRR ",
        "  RRRRRRRRRRRRRRRRR  ",
        "  RRRRRRRRRRRRRRRRR  ",
        "    RRRRRRRRRRRRRR   ",
        "       RRRRRRRRRRR   ",
        "          RRRRRRR    ",
        "             RRRR    ",
    ]);
}

#[test]
fn a_sheet_folded_over_shows_both_sides_and_hides_what_is_behind() {
    fn check<S: Scalar>(view: &View) -> MockDisplay<Rgb888> {
        // the last two rows turn back towards the viewer and hang lower
        let mut cloth = hung::<S>();
        for node in Grid::<S, 5, 5>::nodes() {
            let folded = [[0.0, 0.0], [0.0, 1.0], [0.0, 2.0], [-1.0, 1.5], [-1.4, 0.5]][node.row];
            cloth.position.set(node, Vec3::from_f64([node.column as f64 - 2.0, folded[0], folded[1]]));
        }
        picture(&cloth, two_sided(), view)
    }
    let view = View::new(20.0, 10.0).at(Spot([0.0, -0.5, 1.0]), Length(12.0));
    check::<f64>(&view).assert_pattern(&[
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "      BBBBBBBBBBBBBB",
        "     BBBBBBBBBBBBBBB",
        "    BBBBBBBBBBBBBBBR",
        "    BBBBBBBBBBBBBBBR",
        "    BBBBBBBBBBBBBBBR",
        "    BBBBBBBBBBBBBBBR",
        "      RRRRBBBBBBBBBR",
        "                RRRR",
    ]);
    check::<f32>(&view).assert_eq(&check::<f64>(&view));
    check::<Q24>(&view).assert_eq(&check::<f64>(&view));
}

#[test]
fn a_ball_in_front_covers_the_sheet() {
    let view = View::new(0.0, 0.0).at(Spot([0.0; 3]), Length(12.0));
    let ball = Ball::<Q24>::new(Spot([1.0, -1.5, 0.0]), Length(1.2), Rgb888::GREEN);
    picture(&hung::<Q24>(), two_sided().solids(ball), &view).assert_pattern(&[
        "                     ",
        "                     ",
        "                     ",
        "                     ",
        "                     ",
        "     BBBBBBBBBBBBBB  ",
        "     BBBBBBBBBBBBBB  ",
        "     BBBBBBBBBGGGGG  ",
        "     BBBBBBBBGGGGGGG ",
        "     BBBBBBBGGGGGGGGG",
        "     BBBBBBGGGGGGGGGG",
        "     BBBBBBGGGGGGGGGG",
        "     BBBBBBGGGGGGGGGG",
        "     BBBBBBGGGGGGGGGG",
        "     BBBBBBBGGGGGGGGG",
        "     BBBBBBBBGGGGGGG ",
        "     BBBBBBBBBGGGGG  ",
        "     BBBBBBBBBBBBBB  ",
        "     BBBBBBBBBBBBBB  ",
    ]);
}

#[test]
fn a_ball_behind_is_covered_by_the_sheet() {
    let view = View::new(0.0, 0.0).at(Spot([0.0; 3]), Length(12.0));
    let ball = Ball::<Q24>::new(Spot([2.2, 1.5, 0.0]), Length(1.2), Rgb888::GREEN);
    picture(&hung::<Q24>(), two_sided().solids(ball), &view).assert_pattern(&[
        "                       ",
        "                       ",
        "                       ",
        "                       ",
        "                       ",
        "     BBBBBBBBBBBBBB    ",
        "     BBBBBBBBBBBBBB    ",
        "     BBBBBBBBBBBBBB    ",
        "     BBBBBBBBBBBBBBGG  ",
        "     BBBBBBBBBBBBBBGGGG",
        "     BBBBBBBBBBBBBBGGGG",
        "     BBBBBBBBBBBBBBGGGG",
        "     BBBBBBBBBBBBBBGGGG",
        "     BBBBBBBBBBBBBBGGGG",
        "     BBBBBBBBBBBBBBGGGG",
        "     BBBBBBBBBBBBBBGG  ",
        "     BBBBBBBBBBBBBB    ",
        "     BBBBBBBBBBBBBB    ",
        "     BBBBBBBBBBBBBB    ",
    ]);
}

#[test]
fn a_sheet_around_a_ball_is_drawn_before_and_after_it() {
    // a band around the ball, open to the right
    let mut cloth = hung::<Q24>();
    for node in Grid::<Q24, 5, 5>::nodes() {
        let angle = 0.6 + 5.0 * node.column as f64 / 4.0;
        let z = 0.6 - 0.3 * node.row as f64;
        cloth.position.set(node, Vec3::from_f64([2.4 * libm::cos(angle), 2.4 * libm::sin(angle), z]));
    }
    let view = View::new(0.0, 30.0).at(Spot([0.0; 3]), Length(12.0));
    let ball = Ball::<Q24>::new(Spot([0.0; 3]), Length(1.5), Rgb888::GREEN);
    picture(&cloth, two_sided().solids(ball), &view).assert_pattern(&[
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "                    ",
        "           GG       ",
        "        RGGGGGGRR   ",
        "      RRGGGGGGGGRRR ",
        "    RRRGGGGGGGGGGRR ",
        "   BRRRGGGGGGGGGGRR ",
        "   BBRGGGGGGGGGGGG  ",
        "   BBBGGGGGGGGGGGG  ",
        "   BBBBGGGGGGGGGGBBB",
        "    BBBBGGBBBBBBBBBB",
        "     BBBBBBBBBBBBBBB",
        "      BBBBBBBBBBBBBB",
        "       BBBBBBBBBBB  ",
        "        BBBB        ",
    ]);
}

#[test]
fn of_several_solids_the_nearest_is_drawn_last() {
    let view = View::new(0.0, 0.0).at(Spot([0.0; 3]), Length(12.0));
    let ball = |y, tone| Ball::<Q24>::new(Spot([0.0, y, 0.0]), Length(1.0), tone);
    let solids = (ball(-2.0, Rgb888::GREEN), [ball(2.0, Rgb888::CYAN), ball(-4.0, Rgb888::YELLOW)]);
    let display = picture(&hung::<Q24>(), two_sided().solids(solids), &view);
    assert_eq!(display.get_pixel(Point::new(12, 12)), Some(Rgb888::YELLOW));
    let solids = (ball(3.0, Rgb888::GREEN), [ball(2.0, Rgb888::CYAN), ball(4.0, Rgb888::YELLOW)]);
    let display = picture(&hung::<Q24>(), two_sided().solids(solids), &view);
    assert_eq!(display.get_pixel(Point::new(12, 12)), Some(Rgb888::BLUE), "all of them are behind the sheet");
}

#[test]
fn nothing_behind_the_camera_is_drawn() {
    let behind = View::new(0.0, 0.0).at(Spot([0.0, 20.0, 0.0]), Length(10.0));
    let ball = Ball::<Q24>::new(Spot([0.0; 3]), Length(1.0), Rgb888::GREEN);
    let display = picture(&hung::<Q24>(), two_sided().solids(ball), &behind);
    assert_eq!(display.affected_area(), Rectangle::zero());
}

#[test]
fn smooth_cells_have_the_outline_of_a_flat_sheet() {
    let view = View::new(25.0, 40.0).at(Spot([0.0; 3]), Length(12.0));
    let camera = Camera::new(&view, SCREEN);
    let mut display = MockDisplay::<Rgb888>::new();
    Shaded::new(two_sided()).smooth::<3>().draw(&laid::<f64>(), &camera, &mut display).unwrap();
    display.assert_eq(&picture(&laid::<f64>(), two_sided(), &view));
}

#[test]
fn an_error_of_the_display_is_reported() {
    struct Broken;
    impl embedded_graphics::geometry::OriginDimensions for Broken {
        fn size(&self) -> Size {
            SCREEN
        }
    }
    impl DrawTarget for Broken {
        type Color = Rgb888;
        type Error = &'static str;
        fn draw_iter<I>(&mut self, _: I) -> Result<(), Self::Error> {
            Err("broken")
        }
    }
    let camera = Camera::new(&View::new(0.0, 0.0), SCREEN);
    assert_eq!(Shaded::new(two_sided()).draw(&hung::<f32>(), &camera, &mut Broken), Err("broken"));
}

#[test]
fn memory_is_as_documented() {
    assert_eq!(size_of::<Shaded<(), 16, 16>>(), 16 * 256);
}

/// A sheet bent to a quarter of an upright pipe.
fn bent<S: Scalar>() -> Sheet<S> {
    let mut cloth = hung();
    for node in Grid::<S, 5, 5>::nodes() {
        let angle = node.column as f64 * core::f64::consts::FRAC_PI_8;
        let [_, _, height] = cloth.position.at(node).to_f64();
        cloth.position.set(node, Vec3::from_f64([2.5 * libm::sin(angle), -2.5 * libm::cos(angle), height]));
    }
    cloth
}

/// The largest difference between neighbouring pixels of the middle row.
fn steepest(display: &MockDisplay<Rgb888>) -> u8 {
    let tones = (0..SCREEN.width as i32).filter_map(|x| display.get_pixel(Point::new(x, SCREEN.height as i32 / 2)));
    let (mut before, mut most) = (None, 0);
    for tone in tones {
        most = before.map_or(0, |before: u8| before.abs_diff(tone.r())).max(most);
        before = Some(tone.r());
    }
    most
}

#[test]
fn light_goes_from_particle_to_particle() {
    fn check<S: Scalar>() {
        let view = View::new(40.0, 0.0).at(Spot([1.2, -1.2, 0.0]), Length(12.0));
        let look = Look::new(Light::new(-60.0, 20.0), Rgb888::new(200, 200, 200));
        let camera = Camera::new(&view, SCREEN);
        let [mut flat, mut smooth, mut fine] = [(); 3].map(|()| MockDisplay::new());
        for display in [&mut flat, &mut smooth, &mut fine] {
            display.set_allow_overdraw(true);
        }
        Shaded::new(look).draw(&bent::<S>(), &camera, &mut flat).unwrap();
        Shaded::new(look).gouraud::<_, 1>().draw(&bent::<S>(), &camera, &mut smooth).unwrap();
        Shaded::new(look).smooth::<4>().gouraud::<_, 1>().draw(&bent::<S>(), &camera, &mut fine).unwrap();
        let [flat, smooth, fine] = [&flat, &smooth, &fine].map(steepest);
        assert!(flat > 20 && smooth < flat / 2 && fine < flat / 2, "{flat}, {smooth}, {fine} in {}", S::NAME);
    }
    check::<f32>();
    check::<Q24>();
}

#[test]
fn even_light_leaves_colours_as_they_are() {
    let view = View::new(20.0, 30.0).at(Spot([0.0; 3]), Length(15.0));
    let stripes = |at: &Place| [Rgb888::RED, Rgb888::GREEN, Rgb888::BLUE][(at.across / 256) as usize % 3];
    let look =
        Look { finish: Finish { gloss: Rgb888::BLACK, ..Look::new(EVEN, stripes).finish }, ..Look::new(EVEN, stripes) };
    let camera = Camera::new(&view, SCREEN);
    let pictures = [0, 1, 2, 3].map(|k| {
        let mut display = MockDisplay::<Rgb888>::new();
        display.set_allow_overdraw(true);
        let shaded = Shaded::<_, 5, 5>::new(look);
        // without tables, and with tables for all three colours, for two and for one
        match k {
            0 => Shaded::<_, 5, 5>::new(look).draw(&laid::<Q24>(), &camera, &mut display).unwrap(),
            1 => shaded.gouraud::<_, 3>().draw(&laid::<Q24>(), &camera, &mut display).unwrap(),
            2 => shaded.gouraud::<_, 2>().draw(&laid::<Q24>(), &camera, &mut display).unwrap(),
            _ => shaded.gouraud::<_, 1>().draw(&laid::<Q24>(), &camera, &mut display).unwrap(),
        }
        display
    });
    for gouraud in &pictures[1..] {
        assert!(*gouraud == pictures[0], "{gouraud:?} {:?}", pictures[0]);
    }
}
