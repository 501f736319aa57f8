//! A sheet drawn as its links.

use embedded_graphics::Drawable;
use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::Point;
use embedded_graphics::pixelcolor::{PixelColor, Rgb888};
use embedded_graphics::primitives::{Line, Primitive, PrimitiveStyle, Styled, StyledDrawable};

use super::camera::Camera;
use super::tone::Shade;
use crate::grid::Node;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// The lines between a sheet's particles, each one pixel wide.
///
/// [`draw`](Self::draw) draws light lines that get dimmer with depth. With a style, a wireframe is drawn like any other primitive:
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb565, prelude::*, primitives::PrimitiveStyle};
/// use kerchief::{Cloth, Q24, Units, render::{Camera, View, Wireframe}};
///
/// const UNITS: Units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
/// const SCREEN: Size = Size::new(64, 64);
/// const VIEW: View = View::new(0.0, 0.0).fit(UNITS.point([0.0; 3]), UNITS.point([0.3, 0.0, 0.3]), SCREEN);
///
/// let cloth = Cloth::<Q24, 4, 4>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
/// let camera = Camera::new(&VIEW, SCREEN);
/// let mut display = MockDisplay::new();
/// display.set_allow_overdraw(true);
/// Wireframe::new(&cloth, &camera).into_styled(PrimitiveStyle::with_stroke(Rgb565::RED, 1)).draw(&mut display)?;
/// # Ok::<(), core::convert::Infallible>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct Wireframe<'a, S, const W: usize, const H: usize> {
    particles: &'a Particles<S, W, H>,
    camera: &'a Camera<S>,
    links: &'a [(i32, i32)],
}

/// The links along rows and columns.
const STRETCH: &[(i32, i32)] = &[(1, 0), (0, 1)];

/// The luma of a line at the depth of the target, and its decrease per distance to the target. A sheet spans about a third of that distance.
const LUMA: i32 = 200;
const FALL: i32 = 320;
/// The least luma of a line: half, so that a display of two colours shows all lines.
const DIMMEST: i32 = 128;

impl<'a, S: Scalar, const W: usize, const H: usize> Wireframe<'a, S, W, H> {
    /// The columns and rows of a sheet.
    pub const fn new(particles: &'a Particles<S, W, H>, camera: &'a Camera<S>) -> Self {
        Self { particles, camera, links: STRETCH }
    }

    /// Draws these links instead: offsets (columns, rows) from each particle to another, none of them (0, 0).
    #[must_use]
    pub const fn links(self, links: &'a [(i32, i32)]) -> Self {
        Self { links, ..self }
    }

    /// Draws light lines that get dimmer with depth.
    ///
    /// # Errors
    /// Errors of the target.
    pub fn draw<D: DrawTarget<Color: Shade>>(&self, target: &mut D) -> Result<(), D::Error> {
        self.each(|line, depth| {
            let luma = (LUMA - (depth - S::ONE).round_times(FALL)).clamp(DIMMEST, 255) as u8;
            let color = D::Color::nearest(Rgb888::new(luma, luma, luma));
            line.into_styled(PrimitiveStyle::with_stroke(color, 1)).draw(target)
        })
    }

    /// The wireframe in one colour and line width.
    pub const fn into_styled<C: PixelColor>(self, style: PrimitiveStyle<C>) -> Styled<Self, PrimitiveStyle<C>> {
        Styled::new(self, style)
    }

    /// Passes each line that may be on the screen, and the depth of its middle, to `draw`.
    fn each<E>(&self, mut draw: impl FnMut(Line, S) -> Result<(), E>) -> Result<(), E> {
        for &(across, down) in self.links {
            let step = |node: Node, sign: i32| {
                let column = node.column as i32 + sign * across;
                let row = node.row as i32 + sign * down;
                let inside = (0..W as i32).contains(&column) && (0..H as i32).contains(&row);
                inside.then(|| Node::new(column as usize, row as usize))
            };
            if (across, down) == (0, 0) {
                continue;
            }
            for start in crate::grid::Grid::<S, W, H>::nodes().filter(|&node| step(node, -1).is_none()) {
                // following the links computes each particle's place once
                let mut last = self.camera.place(self.particles.position.at(start));
                let mut node = start;
                while let Some(next) = step(node, 1) {
                    let place = self.camera.place(self.particles.position.at(next));
                    if let Some(line) = self.line(last, place) {
                        draw(line, (last.z + place.z).halve(1))?;
                    }
                    (last, node) = (place, next);
                }
            }
        }
        Ok(())
    }

    fn line(&self, a: Vec3<S>, b: Vec3<S>) -> Option<Line> {
        let near = Camera::<S>::near();
        let (a, b) = match (a.z < near, b.z < near) {
            (false, false) => (a, b),
            (true, false) => (Camera::clip(a, b), b),
            (false, true) => (a, Camera::clip(b, a)),
            (true, true) => return None,
        };
        let [a, b] = [self.camera.spot(a)?, self.camera.spot(b)?].map(|spot| Point::new(spot.x >> 8, spot.y >> 8));
        self.camera.may_show(a, b).then(|| Line::new(a, b))
    }
}

impl<S: Scalar, C: PixelColor, const W: usize, const H: usize> StyledDrawable<PrimitiveStyle<C>>
    for Wireframe<'_, S, W, H>
{
    type Color = C;
    type Output = ();

    fn draw_styled<D: DrawTarget<Color = C>>(&self, style: &PrimitiveStyle<C>, target: &mut D) -> Result<(), D::Error> {
        self.each(|line, _| line.draw_styled(style, target))
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::draw_target::DrawTargetExt;
    use embedded_graphics::geometry::Size;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::{BinaryColor, Gray8, GrayColor};
    use embedded_graphics::primitives::Rectangle;

    use super::*;
    use crate::cloth::Cloth;
    use crate::render::View;
    use crate::scalar::Q24;
    use crate::units::{Length, Point as Place, Units};

    const UNITS: Units = Units::sheet([4, 3], [3.0, 2.0], 1.0, 0.1, 1);
    const SCREEN: Size = Size::new(32, 16);

    fn picture<S: Scalar>(view: &View) -> MockDisplay<BinaryColor> {
        let cloth = Cloth::<S, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        let mut display = MockDisplay::new();
        display.set_allow_overdraw(true);
        let mut screen = display.clipped(&Rectangle::new(Point::zero(), SCREEN));
        Wireframe::new(&cloth, &Camera::new(view, SCREEN)).draw(&mut screen).unwrap();
        display
    }

    fn check(view: &View, pattern: &[&str]) {
        picture::<f64>(view).assert_pattern(pattern);
        picture::<f32>(view).assert_pattern(pattern);
        picture::<Q24>(view).assert_pattern(pattern);
    }

    #[test]
    fn a_flat_sheet_from_above() {
        let view = View::new(0.0, 90.0).fit(UNITS.point([0.0; 3]), UNITS.point([3.0, 2.0, 0.0]), SCREEN);
        check(
            &view,
            &[
                "    ########################",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    ########################",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    #       #      #       #",
                "    ########################",
            ],
        );
    }

    #[test]
    fn a_flat_sheet_tilted_and_turned() {
        let view = View::new(20.0, 35.0).fit(UNITS.point([0.0; 3]), UNITS.point([3.0, 2.0, 0.0]), SCREEN);
        check(
            &view,
            &[
                "                               ",
                "          ##########           ",
                "        ##     #    #######    ",
                "      ####    #       #    ####",
                "     #    ######     #        #",
                "   ##       #   #### #        #",
                "  #        #        ####      #",
                " ###       #        #   ####  #",
                "    ####  #         #       ###",
                "        ####       #          #",
                "            ####   #          #",
                "                #####         #",
                "                     ####     #",
                "                         #### #",
                "                             ##",
            ],
        );
    }

    #[test]
    fn what_is_behind_the_camera_is_cut_off() {
        // The eye stands above the sheet's second column and looks along y: half of each column is behind it.
        let view = View::new(0.0, 20.0).field_of_view(90.0).at(Place([1.0, 1.5, 0.0]), Length(1.0));
        check(
            &view,
            &[
                "                                ",
                "                                ",
                "                                ",
                "                                ",
                "                                ",
                "                                ",
                "                                ",
                "         #####################  ",
                "      ###       #      ###    ##",
                "  ####          #         ####  ",
                "################################",
                "                #               ",
                "                #               ",
                "                #               ",
                "                #               ",
                "                #               ",
            ],
        );
        let away = View::new(180.0, 0.0).at(Place([1.0, -10.0, 0.0]), Length(5.0));
        assert_eq!(picture::<Q24>(&away).affected_area().size, Size::zero());
    }

    #[test]
    fn other_links_are_drawn_on_demand() {
        let view = View::new(0.0, 90.0).fit(UNITS.point([0.0; 3]), UNITS.point([3.0, 2.0, 0.0]), SCREEN);
        let cloth = Cloth::<f32, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        let mut display = MockDisplay::new();
        display.set_allow_overdraw(true);
        let camera = Camera::new(&view, SCREEN);
        let style = PrimitiveStyle::with_stroke(BinaryColor::On, 1);
        Wireframe::new(&cloth, &camera).links(&[(1, -1)]).into_styled(style).draw(&mut display).unwrap();
        display.assert_pattern(&[
            "    #       #      #        ",
            "     #       #      #       ",
            "      #       #      #      ",
            "       #       #      #     ",
            "        #      #       #    ",
            "         #      #       #   ",
            "          #      #       #  ",
            "           #      #       # ",
            "    #       #      #       #",
            "     #       #      #       ",
            "      #       #      #      ",
            "       ##      #      ##    ",
            "         #      #       #   ",
            "          #      #       #  ",
            "           #      #       # ",
            "            #      #       #",
        ]);
    }

    #[test]
    fn what_is_further_away_is_dimmer() {
        let view = View::new(0.0, 30.0).fit(UNITS.point([0.0; 3]), UNITS.point([3.0, 2.0, 0.0]), SCREEN);
        let cloth = Cloth::<Q24, 4, 3>::lay(&UNITS, UNITS.point([0.0; 3]));
        let camera = Camera::new(&view, SCREEN);
        let mut display = MockDisplay::<Gray8>::new();
        display.set_allow_overdraw(true);
        Wireframe::new(&cloth, &camera).draw(&mut display).unwrap();
        let luma = |row: f64| {
            let pixel = camera.project(Vec3::from_f64([1.5, row, 0.0])).unwrap();
            display.get_pixel(pixel).unwrap()
        };
        assert!(luma(0.0).luma() > luma(1.0).luma() && luma(1.0).luma() > luma(2.0).luma());
    }
}
