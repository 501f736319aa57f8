//! A sheet as its faces.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::camera::Camera;
use super::fill;
use super::ground::Backdrop;
use super::light::{Finish, Lamp, Light, unit};
use super::pattern::{Pattern, Place};
use super::solid::Solids;
use super::surface;
use super::tone::{Shade, Toned};
use crate::cloth::Cloth;
use crate::grid::{Grid, Node};
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// How a sheet and what is around it look. What isn't named costs nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look<F, B, O = (), G = ()> {
    /// The light on everything.
    pub light: Light,
    /// The side that faces up where a sheet is laid, and away from a viewer at azimuth 0 where it is hung.
    pub front: F,
    /// The other side.
    pub back: B,
    /// The sheet's gloss and translucency.
    pub finish: Finish,
    /// What the sheet lies on or hangs before.
    pub solids: O,
    /// What is behind everything.
    pub backdrop: G,
}

/// Cloth: a faint sheen, a quarter of the light shines through.
pub const COTTON: Finish = Finish { gloss: Rgb888::new(26, 24, 22), polish: 3, translucency: 64 };

impl<P: Copy> Look<P, P> {
    /// A sheet alone, of the same pattern on both sides.
    pub const fn new(light: Light, pattern: P) -> Self {
        Self { light, front: pattern, back: pattern, finish: COTTON, solids: (), backdrop: () }
    }
}

impl<F, B, O, G> Look<F, B, O, G> {
    /// The same with another back.
    #[must_use]
    pub fn back<P: Pattern>(self, back: P) -> Look<F, P, O, G> {
        let Self { light, front, finish, solids, backdrop, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }

    /// The same with these solids.
    #[must_use]
    pub fn solids<T>(self, solids: T) -> Look<F, B, T, G> {
        let Self { light, front, back, finish, backdrop, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }

    /// The same before this backdrop.
    #[must_use]
    pub fn backdrop<T>(self, backdrop: T) -> Look<F, B, O, T> {
        let Self { light, front, back, finish, solids, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }
}

/// Draws sheets of `W × H` particles with light and shade, what is further away first.
///
/// Each cell is drawn as `N × N` faces, one unless it is [`smooth`](Self::smooth).
///
/// Memory: 4 bytes per particle for the order in which cells are drawn, and the look.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shaded<L, const W: usize, const H: usize, const N: usize = 1> {
    /// How everything looks.
    pub look: L,
    /// Depth and cell, ready to be sorted.
    order: Grid<u32, W, H>,
}

impl<L, const W: usize, const H: usize> Shaded<L, W, H> {
    /// A renderer that draws one face for each cell.
    pub const fn new(look: L) -> Self {
        const { assert!(W * H <= 1 << 16, "a shaded sheet has at most 65536 particles") };
        Self { look, order: Grid::filled(0) }
    }

    /// Draws `N × N` faces for each cell, on a smooth surface through the particles: for large pictures. `N` up to 64.
    pub fn smooth<const N: usize>(self) -> Shaded<L, W, H, N> {
        const { assert!(N > 0 && N <= 64, "a cell is divided into 1 to 64 faces a side") };
        Shaded { look: self.look, order: self.order }
    }
}

impl<F: Pattern, B: Pattern, O, G, const W: usize, const H: usize, const N: usize> Shaded<Look<F, B, O, G>, W, H, N> {
    /// Draws the backdrop, the solids and the sheet.
    ///
    /// # Errors
    /// Whatever the target reports.
    pub fn draw<S: Scalar, D: DrawTarget<Color: Shade>>(
        &mut self,
        cloth: &Cloth<S, W, H>,
        camera: &Camera<S>,
        target: &mut D,
    ) -> Result<(), D::Error>
    where
        O: Solids<S>,
        G: Backdrop<S>,
    {
        let Look { light, solids, backdrop, .. } = &mut self.look;
        backdrop.prepare(cloth, solids, light);
        backdrop.draw(camera, target)?;
        let mut target = Toned(target);
        let mut solid = farthest(&self.look.solids, camera, None);
        loop {
            let count = self.collect(cloth, camera, solid);
            self.faces(cloth, camera, count, &mut target)?;
            let Some(index) = solid else { return Ok(()) };
            self.look.solids.draw(index, camera, &self.look.light, &mut target)?;
            solid = farthest(&self.look.solids, camera, Some(index));
        }
    }

    /// Orders the cells that are drawn next, just before a solid or after all of them, and counts them.
    fn collect<S: Scalar>(&mut self, cloth: &Cloth<S, W, H>, camera: &Camera<S>, solid: Option<usize>) -> usize
    where
        O: Solids<S>,
    {
        let solids = &self.look.solids;
        let order = self.order.0.as_flattened_mut();
        let mut count = 0;
        for row in 1..H {
            for column in 1..W {
                let [p, q, s, t] = corners(column - 1, row - 1).map(|node| cloth.position[node].halve(2));
                let place = camera.place(p + q + s + t);
                if place.z < Camera::<S>::near() {
                    continue;
                }
                let before = |index| solids.hides(index, place, camera);
                let due = solid.is_none_or(before)
                    && !(0..solids.count()).any(|other| is_deeper(solids, camera, other, solid) && before(other));
                if due {
                    let depth = place.z.min(S::from_int(7)).round_times(1 << 13) as u32;
                    order[count] = (0xffff - depth) << 16 | ((row - 1) * W + column - 1) as u32;
                    count += 1;
                }
            }
        }
        order[..count].sort_unstable();
        count
    }

    /// Draws the first cells of the order.
    fn faces<S: Scalar, D: DrawTarget<Color = Rgb888>>(
        &self,
        cloth: &Cloth<S, W, H>,
        camera: &Camera<S>,
        count: usize,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let easel = Easel::<_, _, _, _, _, N> {
            look: &self.look,
            lamp: self.look.light.lamp(camera),
            camera,
            area: target.bounding_box(),
        };
        for key in &self.order.0.as_flattened()[..count] {
            let cell = (key & 0xffff) as usize;
            let cell = Node::new(cell % W, cell / W);
            let corners = corners(cell.column, cell.row).map(|node| cloth.position[node]);
            if N == 1 {
                let place = Place::middle::<W, H>(cell, [0, 0], 1);
                easel.face(corners, &place, target)?;
                continue;
            }
            let [p, q, s, t] = corners.map(|corner| camera.place(corner).z);
            let (backward, upward) = (p + s < q + t, p + q < s + t);
            let part = |k: usize| S::from_int(k as i32).divide(S::from_int(N as i32));
            for row in (0..N).map(|k| if upward { N - 1 - k } else { k }) {
                for column in (0..N).map(|k| if backward { N - 1 - k } else { k }) {
                    let corner = |c, r| surface::point(&cloth.position, cell, part(column + c), part(row + r));
                    let place = Place::middle::<W, H>(cell, [column, row], N as i32);
                    easel.face([corner(0, 0), corner(1, 0), corner(0, 1), corner(1, 1)], &place, target)?;
                }
            }
        }
        Ok(())
    }
}

/// All that a face's picture depends on beside its corners.
struct Easel<'a, S, F, B, O, G, const N: usize> {
    look: &'a Look<F, B, O, G>,
    lamp: Lamp<S>,
    camera: &'a Camera<S>,
    area: Rectangle,
}

impl<S: Scalar, F: Pattern, B: Pattern, O, G, const N: usize> Easel<'_, S, F, B, O, G, N> {
    /// Draws the face of corners p, q (to the right), s (below) and t as the triangles (q, p, s) and (t, q, s).
    fn face<D: DrawTarget<Color = Rgb888>>(
        &self,
        [p, q, s, t]: [Vec3<S>; 4],
        at: &Place,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let [Some(a), Some(b), Some(c), Some(d)] =
            [p, q, s, t].map(|corner| self.camera.spot(self.camera.place(corner)))
        else {
            return Ok(());
        };
        // Seen from the front, columns and rows turn against the clock. The diagonals span twice the face.
        let is_front = fill::turn(b, a, c) + fill::turn(d, b, c) > 0;
        let diagonals = ((t - p).times(N as i32), (s - q).times(N as i32));
        let normal = unit(diagonals.0.cross(diagonals.1));
        let look = self.look;
        let tone = if is_front {
            self.lamp.tone(look.front.tone(at), &look.finish, normal)
        } else {
            self.lamp.tone(look.back.tone(at), &look.finish, -normal)
        };
        fill::triangle([b, a, c], tone, &self.area, target)?;
        fill::triangle([d, b, c], tone, &self.area, target)
    }
}

fn corners(column: usize, row: usize) -> [Node; 4] {
    [Node::new(column, row), Node::new(column + 1, row), Node::new(column, row + 1), Node::new(column + 1, row + 1)]
}

/// Whether a solid is drawn before another; all are drawn before none.
fn is_deeper<S: Scalar>(solids: &impl Solids<S>, camera: &Camera<S>, index: usize, than: Option<usize>) -> bool {
    than.is_none_or(|than| {
        let (depth, other) = (solids.depth(index, camera), solids.depth(than, camera));
        depth > other || (depth == other && index < than)
    })
}

/// The solid that is drawn next after another.
fn farthest<S: Scalar>(solids: &impl Solids<S>, camera: &Camera<S>, after: Option<usize>) -> Option<usize> {
    let left =
        (0..solids.count()).filter(|&index| after.is_none_or(|after| is_deeper(solids, camera, after, Some(index))));
    left.reduce(|next, index| if is_deeper(solids, camera, index, Some(next)) { index } else { next })
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::{Point, Size};
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::RgbColor;

    use super::*;
    use crate::render::{Ball, View};
    use crate::scalar::Q24;
    use crate::units::{Length, Point as Spot, Units};

    const UNITS: Units = Units::sheet([5, 5], [4.0, 4.0], 1.0, 0.1, 1);
    const SCREEN: Size = Size::new(24, 24);
    /// Colours stay as they are.
    const EVEN: Light =
        Light { lamp: Rgb888::BLACK, sky: Rgb888::WHITE, ground: Rgb888::WHITE, ..Light::new(0.0, 45.0) };

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
                cloth.position[node] = Vec3::from_f64([node.column as f64 - 2.0, folded[0], folded[1]]);
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
            cloth.position[node] = Vec3::from_f64([2.4 * libm::cos(angle), 2.4 * libm::sin(angle), z]);
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
        assert_eq!(size_of::<Shaded<(), 16, 16>>(), 4 * 256);
    }
}
