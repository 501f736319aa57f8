//! The ground and the background.

use embedded_graphics::draw_target::DrawTarget;
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::Rectangle;

use super::camera::Camera;
use super::light::Light;
use super::shadow::{Cast, Field};
use super::solid::Solids;
use super::tone::{Shade, Toned, mix};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::{Length, Point as Place};
use crate::vec3::Vec3;

/// The backdrop, drawn before everything else: none, `()`, a plain colour, or a [`Ground`].
pub trait Backdrop<S: Scalar> {
    /// Prepares for a picture of these particles and solids in this light.
    fn prepare<O: Solids<S>, const W: usize, const H: usize>(
        &mut self,
        particles: &Particles<S, W, H>,
        solids: &O,
        light: &Light,
    );

    /// Draws the backdrop over the whole target.
    ///
    /// # Errors
    /// Errors of the target.
    fn draw<D: DrawTarget<Color: Shade>>(&self, camera: &Camera<S>, target: &mut D) -> Result<(), D::Error>;
}

impl<S: Scalar> Backdrop<S> for () {
    fn prepare<O: Solids<S>, const W: usize, const H: usize>(&mut self, _: &Particles<S, W, H>, _: &O, _: &Light) {}

    fn draw<D: DrawTarget<Color: Shade>>(&self, _: &Camera<S>, _: &mut D) -> Result<(), D::Error> {
        Ok(())
    }
}

impl<S: Scalar> Backdrop<S> for Rgb888 {
    fn prepare<O: Solids<S>, const W: usize, const H: usize>(&mut self, _: &Particles<S, W, H>, _: &O, _: &Light) {}

    fn draw<D: DrawTarget<Color: Shade>>(&self, _: &Camera<S>, target: &mut D) -> Result<(), D::Error> {
        Toned(target).clear(*self)
    }
}

/// A level ground of tiles that fades into the background.
///
/// Each row of pixels costs a division, each pixel on the ground about eight products. A camera below the ground sees only the
/// background.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ground<M = ()> {
    /// The middle of its visible part, cells.
    centre: [f64; 3],
    /// The distance from the middle at which it has faded away, cells.
    reach: f64,
    /// The side of a tile, cells.
    tile: f64,
    /// The colours of the tiles in full light.
    pub tones: [Rgb888; 2],
    /// The background at the top and at the bottom of the screen.
    pub background: [Rgb888; 2],
    /// The shadow on it.
    pub shadow: M,
}

impl Ground {
    /// A light-coloured ground at the height of `centre`, without a shadow, that has faded away at a distance of `reach` from `centre`.
    ///
    /// # Panics
    /// At compile time in a constant: for a `reach` that is not positive.
    #[track_caller]
    pub const fn new(centre: Place, reach: Length) -> Self {
        assert!(reach.0 > 0.0, "a ground reaches somewhere");
        Self {
            centre: centre.0,
            reach: reach.0,
            tile: reach.0 / 8.0,
            tones: [Rgb888::new(226, 218, 206), Rgb888::new(214, 205, 192)],
            background: [Rgb888::new(206, 212, 216), Rgb888::new(236, 232, 224)],
            shadow: (),
        }
    }

    /// This ground with a shadow on it.
    pub fn shadow<M: Cast>(self, shadow: M) -> Ground<M> {
        let Self { centre, reach, tile, tones, background, shadow: () } = self;
        Ground { centre, reach, tile, tones, background, shadow }
    }
}

impl<M> Ground<M> {
    /// This ground with tiles of this side, at least a 120th of the ground's reach.
    ///
    /// # Panics
    /// At compile time in a constant: for smaller tiles.
    #[must_use]
    pub fn tiles(self, side: Length) -> Self {
        assert!(side.0 * 120.0 >= self.reach, "a ground reaches over 120 tiles at most");
        Self { tile: side.0, ..self }
    }

    /// This ground in other colours.
    #[must_use]
    pub fn tones(self, tones: [Rgb888; 2], background: [Rgb888; 2]) -> Self {
        Self { tones, background, ..self }
    }
}

impl<S: Scalar, M: Cast> Backdrop<S> for Ground<M> {
    fn prepare<O: Solids<S>, const W: usize, const H: usize>(
        &mut self,
        particles: &Particles<S, W, H>,
        solids: &O,
        light: &Light,
    ) {
        let field = Field {
            centre: Vec3::from_f64(self.centre),
            reach: S::from_f64(self.reach),
            towards: Vec3::from_f64(light.towards),
        };
        self.shadow.cast(particles, solids, &field);
    }

    fn draw<D: DrawTarget<Color: Shade>>(&self, camera: &Camera<S>, target: &mut D) -> Result<(), D::Error> {
        let area = target.bounding_box();
        let target = &mut Toned(target);
        // Lengths are in units of the ground's reach: the middle is (0, 0), and the ground has faded away at the unit circle.
        let reach = S::from_f64(self.reach);
        let tiles = reach.divide(S::from_f64(self.tile));
        let [right, up, forward] = [camera.axes.right, camera.axes.up, camera.axes.forward];
        let distance = camera.scale(reach).recip();
        let eye = (camera.target() - Vec3::from_f64(self.centre)) * reach.recip() - forward * distance;
        for row in area.rows() {
            let background = mix(self.background[0], self.background[1], camera.fraction_down(row));
            // A row of pixels shows a line of one depth on the ground, because the camera never rolls.
            let ray = forward + up * camera.slope_up(row);
            let stretch = Rectangle::new(Point::new(area.top_left.x, row), Size::new(area.size.width, 1));
            // no ground is drawn at a depth of 64 times its reach or more
            if eye.z <= S::ZERO || -ray.z <= eye.z.halve(6) {
                target.fill_contiguous(&stretch, core::iter::repeat_n(background, area.size.width as usize))?;
                continue;
            }
            let depth = eye.z.divide(-ray.z);
            let middle = eye + ray * depth;
            let tones = stretch.columns().map(|column| {
                let place = middle + right * (camera.slope_right(column) * depth);
                let (x, y) = (place.x, place.y);
                if x.abs() >= S::ONE || y.abs() >= S::ONE {
                    return background;
                }
                let left = (S::ONE - x * x - y * y).max(S::ZERO);
                let odd = ((x * tiles).round_times(1) + (y * tiles).round_times(1)) & 1;
                let tone = self.shadow.darken(self.tones[odd as usize], x, y);
                mix(background, tone, (left * left).round_times(256))
            });
            target.fill_contiguous(&stretch, tones)?;
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::draw_target::DrawTargetExt;
    use embedded_graphics::mock_display::MockDisplay;
    use embedded_graphics::pixelcolor::RgbColor;

    use super::*;
    use crate::cloth::Cloth;
    use crate::render::{Shadow, View};
    use crate::scalar::Q24;
    use crate::units::Units;

    const SCREEN: Size = Size::new(32, 20);

    /// A ground whose colours do not fade in the middle of the picture.
    fn ground() -> Ground {
        let blue = [Rgb888::BLUE; 2];
        Ground::new(Place([0.0; 3]), Length(100.0)).tiles(Length(4.0)).tones([Rgb888::WHITE, Rgb888::BLACK], blue)
    }

    fn picture<S: Scalar>(backdrop: &impl Backdrop<S>, view: &View) -> MockDisplay<Rgb888> {
        let mut display = MockDisplay::new();
        let mut screen = display.cropped(&Rectangle::new(Point::zero(), SCREEN));
        backdrop.draw(&Camera::new(view, SCREEN), &mut screen).unwrap();
        display
    }

    #[test]
    fn tiles_lie_where_the_camera_sees_them() {
        fn check<S: Scalar>() {
            let view = View::new(30.0, 35.0).at(Place([1.0, 2.0, 0.0]), Length(30.0));
            let display = picture::<S>(&ground(), &view);
            let camera = Camera::<S>::new(&view, SCREEN);
            let mut seen = 0;
            for column in -3..=3 {
                for row in -3..=3 {
                    let middle = Vec3::new(S::from_int(4 * column), S::from_int(4 * row), S::ZERO);
                    let pixel = camera.project(middle).unwrap();
                    if !Rectangle::new(Point::zero(), SCREEN).contains(pixel) {
                        continue;
                    }
                    let tone = display.get_pixel(pixel).unwrap();
                    let is_white = tone.r() > 128;
                    assert_eq!(is_white, (column + row) % 2 == 0, "{} {column} {row}: {tone:?}", S::NAME);
                    seen += 1;
                }
            }
            assert!(seen >= 6);
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }

    #[test]
    fn above_the_horizon_and_below_the_ground_is_background() {
        let level = View::new(30.0, 0.0).at(Place([0.0, 0.0, 10.0]), Length(30.0));
        let display = picture::<Q24>(&ground(), &level);
        for x in 0..32 {
            assert_eq!(display.get_pixel(Point::new(x, 9)), Some(Rgb888::BLUE));
        }
        assert_ne!(display.get_pixel(Point::new(16, 19)), Some(Rgb888::BLUE));
        let below = View::new(30.0, 20.0).at(Place([0.0, 0.0, -30.0]), Length(30.0));
        let display = picture::<Q24>(&ground(), &below);
        assert!(display.affected_area().size == SCREEN);
        assert_eq!(display.get_pixel(Point::new(16, 19)), Some(Rgb888::BLUE));
    }

    #[test]
    fn it_fades_away() {
        let view = View::new(0.0, 90.0).at(Place([0.0; 3]), Length(50.0));
        let plain = ground().tones([Rgb888::WHITE; 2], [Rgb888::BLUE; 2]);
        let plain = Ground { reach: 10.0, tile: 1.0, ..plain };
        let display = picture::<Q24>(&plain, &view);
        let red = |x| display.get_pixel(Point::new(x, 10)).unwrap().r();
        assert!(red(16) > 245 && red(16) > red(19) && red(19) > red(22));
        assert_eq!(red(31), 0);
    }

    #[test]
    fn a_part_of_the_target_is_drawn_as_in_the_whole() {
        let view = View::new(30.0, 35.0).at(Place([1.0, 2.0, 0.0]), Length(30.0));
        let whole = picture::<Q24>(&ground(), &view);
        let part = Rectangle::new(Point::new(5, 6), Size::new(9, 8));
        let mut display = MockDisplay::<Rgb888>::new();
        let camera = Camera::<Q24>::new(&view, SCREEN);
        ground().draw(&camera, &mut display.clipped(&part)).unwrap();
        assert_eq!(display.affected_area(), part);
        for at in embedded_graphics::primitives::PointsIter::points(&part) {
            assert_eq!(display.get_pixel(at), whole.get_pixel(at));
        }
    }

    #[test]
    fn the_shadow_is_below_a_sheet_under_a_lamp_overhead() {
        const UNITS: Units = Units::sheet([4, 4], [6.0, 6.0], 1.0, 0.1, 1);
        let cloth = Cloth::<Q24, 4, 4>::lay(&UNITS, UNITS.point([-3.0, -3.0, 8.0]));
        let view = View::new(0.0, 60.0).at(Place([0.0; 3]), Length(40.0));
        let plain = ground().tones([Rgb888::WHITE; 2], [Rgb888::WHITE; 2]);
        let plain = Ground { reach: 20.0, ..plain };
        let mut ground = plain.shadow(Shadow::<64>::new(Rgb888::BLACK).soften(0));
        let before = picture::<Q24>(&ground, &view);
        Backdrop::<Q24>::prepare(&mut ground, &cloth, &(), &Light::new(0.0, 90.0));
        let after = picture::<Q24>(&ground, &view);
        let camera = Camera::<Q24>::new(&view, SCREEN);
        let pixel = camera.project(Vec3::ZERO).unwrap();
        assert_eq!(before.get_pixel(pixel), Some(Rgb888::WHITE));
        assert!(after.get_pixel(pixel).unwrap().r() < 10);
        let beside = camera.project(Vec3::from_f64([5.0, 0.0, 0.0])).unwrap();
        assert_eq!(after.get_pixel(beside), Some(Rgb888::WHITE));
    }
}
