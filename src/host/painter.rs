//! Pictures of a scene.

use embedded_graphics::geometry::{self, Size};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::primitives::PrimitiveStyle;
use embedded_graphics::{Drawable, draw_target::DrawTarget};
use std::vec::Vec;

use super::choice::Weave;
use super::description::{Description, Picture};
use super::error::SceneError;
use super::run::Still;
use super::shape::for_each_shape;
use crate::cloth::Cloth;
use crate::grid::Node;
use crate::render::Backdrop;
use crate::render::pattern::{Border, CELL, Checks, Gingham, Pattern, Place, Stripes, Width};
use crate::render::{Ball, Camera, Ground, Light, Look, Orbit, Rod, Shaded, Shadow, View, Wireframe};
use crate::units::{Length, Point, Units};
use crate::vec3::Vec3;

/// Draws [`Still`]s of a scene: the sheet, balls and rods, and a ground with their shadow.
///
/// Pictures are computed in `f32`, independently of the sheet's number type.
#[derive(Clone, Debug)]
pub struct Painter<'a> {
    scene: &'a Description,
    units: Units,
    view: View,
    ground: Ground,
    light: Light,
    screen: Size,
}

const BALL: Rgb888 = Rgb888::new(96, 112, 128);
const ROD: Rgb888 = Rgb888::new(120, 96, 72);
const SHADOW: Rgb888 = Rgb888::new(150, 142, 136);
/// The distance beside the sheet within which a particle is picked, in longer sides of the sheet.
const BESIDE: f64 = 0.05;
/// The largest coordinate that is drawn, cells from the origin: a sheet may have left every bound.
const FURTHEST: f64 = 512.0;

impl<'a> Painter<'a> {
    /// A painter for pictures of this size that show these stills.
    ///
    /// # Errors
    ///
    /// If the sheet's size, mass or step is too large or too small.
    pub fn new<'b>(
        scene: &'a Description,
        stills: impl IntoIterator<Item = &'b Still>,
        screen: Size,
    ) -> Result<Self, SceneError> {
        let mut seen = Bounds::new(scene);
        stills.into_iter().for_each(|still| seen.include(scene, still));
        Self::within(scene, seen, screen)
    }

    /// A painter for pictures of this size that show all stills within these bounds.
    ///
    /// # Errors
    ///
    /// As [`new`](Self::new).
    pub fn within(scene: &'a Description, Bounds(seen): Bounds, screen: Size) -> Result<Self, SceneError> {
        let units = scene.units()?;
        let Picture { azimuth, elevation, frame, .. } = scene.picture;
        let [low, high] = frame.unwrap_or(seen);
        let size = (0..3).fold(units.cell, |size, axis| size.max(high[axis] - low[axis]));
        let floor = scene.planes.iter().filter(|plane| plane.normal[2] > 0.999).map(|plane| plane.point[2]);
        let floor = floor.reduce(f64::max).unwrap_or(low[2].min(seen[0][2]) - 0.02 * size);
        let middle = [0, 1].map(|axis| 0.5 * (low[axis] + high[axis]));
        // without the checks of `Units::length`: a picture may have any extent
        let length = |metres: f64| Length(metres / units.cell);
        let ground = Ground::new(units.place([middle[0], middle[1], floor]), length(2.2 * size));
        Ok(Self {
            scene,
            units,
            view: View::new(azimuth, elevation).fit(units.place(low), units.place(high), screen),
            ground: ground.tiles(length(0.25 * size)),
            light: light(azimuth),
            screen,
        })
    }

    /// The direction and distance (cells) from which pictures are seen.
    pub fn orbit(&self) -> Orbit {
        let Picture { azimuth, elevation, .. } = self.scene.picture;
        Orbit::new(azimuth, elevation, self.view.distance)
    }

    /// Looks at the same point from elsewhere: from the painter's [`orbit`](Self::orbit), turned. The light turns with it.
    pub fn look(&mut self, from: &Orbit) {
        self.view = self.view.seen_from(from);
        self.light = light(from.azimuth);
    }

    /// The particle nearest to a pixel in the picture of `still`; `None` if the pixel is too far from the sheet.
    pub fn pick(&self, still: &Still, pixel: geometry::Point) -> Option<Node> {
        macro_rules! choose {
            ($(($columns:literal, $rows:literal, $faces:literal))*) => {
                match (self.scene.sheet.columns, self.scene.sheet.rows) {
                    $(($columns, $rows) => self.pick_of_grid::<$columns, $rows>(still, pixel),)*
                    _ => None,
                }
            };
        }
        for_each_shape!(choose)
    }

    /// The place (m) under a pixel at the depth of another place (m).
    pub fn under(&self, pixel: geometry::Point, place: [f64; 3]) -> [f64; 3] {
        self.units.metres(self.camera().under(pixel, self.units.place(place).to_vec()))
    }

    /// The pixel at which a place (m) appears.
    pub fn pixel(&self, place: [f64; 3]) -> Option<geometry::Point> {
        self.camera().project(self.units.place(place).to_vec())
    }

    fn camera(&self) -> Camera<f32> {
        Camera::new(&self.view, self.screen)
    }

    fn pick_of_grid<const W: usize, const H: usize>(&self, still: &Still, pixel: geometry::Point) -> Option<Node> {
        let side = self.scene.sheet.width.max(self.scene.sheet.height);
        let beside = Length(BESIDE * side / self.units.cell);
        self.camera().ray(pixel).pick(&self.laid::<W, H>(still), beside)
    }

    /// The sheet with the positions of `still`.
    fn laid<const W: usize, const H: usize>(&self, still: &Still) -> Cloth<f32, W, H> {
        let mut cloth = Cloth::lay(&self.units, Point([0.0; 3]));
        // A coordinate that is NaN is drawn far below.
        let near = |cells: f64| if cells.is_nan() { -FURTHEST } else { cells.clamp(-FURTHEST, FURTHEST) };
        let mut positions = still.positions.iter();
        cloth
            .position
            .change(|x| positions.next().map_or(x, |&metres| Vec3::from_f64(self.units.place(metres).0.map(near))));
        cloth
    }

    /// Draws `still` over all of `target`.
    ///
    /// # Errors
    ///
    /// Errors of the target.
    pub fn draw<D: DrawTarget<Color = Rgb888>>(&self, still: &Still, target: &mut D) -> Result<(), D::Error> {
        macro_rules! choose {
            ($(($columns:literal, $rows:literal, $faces:literal))*) => {
                match (self.scene.sheet.columns, self.scene.sheet.rows) {
                    $(($columns, $rows) => self.draw_grid::<D, $columns, $rows, $faces>(still, target),)*
                    _ => Ok(()),
                }
            };
        }
        for_each_shape!(choose)
    }

    fn draw_grid<D: DrawTarget<Color = Rgb888>, const W: usize, const H: usize, const N: usize>(
        &self,
        still: &Still,
        target: &mut D,
    ) -> Result<(), D::Error> {
        let (cloth, camera) = (self.laid::<W, H>(still), self.camera());
        let solids = (&*self.balls(still), &*self.rods());
        let mut ground = self.ground.shadow(Shadow::<160>::new(SHADOW).soften(6));
        if W == 1 {
            ground.prepare(&cloth, &solids, &self.light);
            ground.draw(&camera, target)?;
            let [red, green, blue] = self.scene.picture.colours[1];
            let style = PrimitiveStyle::with_stroke(Rgb888::new(red, green, blue), self.screen.width.div_ceil(160));
            return Wireframe::new(&cloth, &camera).into_styled(style).draw(target);
        }
        let pattern = Woven::new(&self.scene.picture, W.max(H) as i32 - 1);
        let look = Look::new(self.light, pattern).solids(solids).backdrop(ground);
        Shaded::<_, W, H>::new(look).smooth::<N>().draw(&cloth, &camera, target)
    }

    fn balls(&self, still: &Still) -> Vec<Ball<f32>> {
        let ball = |(centre, sphere): (&[f64; 3], &super::Sphere)| {
            Ball::new(self.units.place(*centre), self.units.length(sphere.radius), BALL)
        };
        still.spheres.iter().zip(&self.scene.spheres).map(ball).collect()
    }

    fn rods(&self) -> Vec<Rod<f32>> {
        let rod = |rod: &super::Capsule| {
            Rod::new(self.units.point(rod.a), self.units.point(rod.b), self.units.length(rod.radius), ROD)
        };
        self.scene.capsules.iter().map(rod).collect()
    }
}

/// The light: a lamp behind the viewer's left shoulder.
fn light(azimuth: f64) -> Light {
    Light::new(azimuth - 50.0, 50.0)
}

/// The box around all visible parts of a scene that are not too far away.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Bounds([[f64; 3]; 2]);

impl Bounds {
    /// A box that contains only the initial position of particle (0, 0).
    pub fn new(scene: &Description) -> Self {
        Self([scene.sheet.origin; 2])
    }

    /// Extends the box by a still of the same scene.
    pub fn include(&mut self, scene: &Description, still: &Still) {
        let sheet = &scene.sheet;
        let furthest = 2.0 * (sheet.width + sheet.height);
        let near = |x: &&[f64; 3]| (0..3).all(|axis| (x[axis] - sheet.origin[axis]).abs() <= furthest);
        for position in still.positions.iter().filter(near) {
            self.stretch(*position, *position);
        }
        for (centre, sphere) in still.spheres.iter().zip(&scene.spheres).filter(|(centre, _)| near(centre)) {
            self.stretch(centre.map(|x| x - sphere.radius), centre.map(|x| x + sphere.radius));
        }
    }

    fn stretch(&mut self, low: [f64; 3], high: [f64; 3]) {
        let Self([lowest, highest]) = self;
        for axis in 0..3 {
            lowest[axis] = lowest[axis].min(low[axis]);
            highest[axis] = highest[axis].max(high[axis]);
        }
    }
}

/// A pattern chosen at run time.
#[derive(Clone, Copy, Debug)]
struct Woven {
    weave: Weave,
    width: Width,
    tones: [Rgb888; 2],
}

impl Woven {
    fn new(picture: &Picture, cells: i32) -> Self {
        Self {
            weave: picture.pattern,
            width: Width::parts((cells * CELL / picture.bands as i32).max(1)),
            tones: picture.colours.map(|[red, green, blue]| Rgb888::new(red, green, blue)),
        }
    }
}

impl Pattern for Woven {
    fn tone(&self, at: &Place) -> Rgb888 {
        let Self { weave, width, tones } = *self;
        match weave {
            Weave::Plain => tones[1],
            Weave::Stripes => Stripes { width, tones }.tone(at),
            Weave::Checks => Checks { width, tones }.tone(at),
            Weave::Gingham => Gingham { width, tones }.tone(at),
            Weave::Kerchief => Border { width, tone: tones[1], inner: Gingham { width, tones } }.tone(at),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::host::{Everything, built_in};

    /// From several directions, near and far.
    #[test]
    fn a_particle_is_picked_where_it_is_seen() {
        let scene = Description::parse(built_in("curtain").unwrap().text).unwrap();
        let (columns, rows) = (scene.sheet.columns, scene.sheet.rows);
        assert_eq!((columns, rows), (32, 32));
        let still = scene.simulation_on::<Everything, f32, 32, 32>().unwrap().still();
        let mut painter = Painter::new(&scene, [&still], Size::new(640, 600)).unwrap();
        let mut orbit = painter.orbit();
        painter.look(&orbit);
        for (right, up, factor) in [(0.0, 0.0, 1.0), (35.0, 20.0, 1.0), (-60.0, -100.0, 2.0), (0.0, 30.0, 0.3)] {
            orbit.turn(right, up);
            orbit.zoom(factor);
            painter.look(&orbit);
            for [column, row] in [[0, 0], [columns / 2, rows / 2], [columns - 1, rows - 1], [5, 17]] {
                let place = still.positions[row * columns + column];
                let pixel = painter.pixel(place).expect("in front of the eye");
                assert_eq!(painter.pick(&still, pixel), Some(Node { column, row }), "{orbit:?}");
                let moved = painter.under(pixel + geometry::Point::new(40, 0), place);
                assert_eq!(painter.pixel(moved), Some(pixel + geometry::Point::new(40, 0)));
            }
            assert_eq!(painter.pick(&still, geometry::Point::new(-4000, -4000)), None);
        }
    }

    #[test]
    fn looking_from_the_first_place_changes_no_pixel() {
        let scene = Description::parse(built_in("curtain").unwrap().text).unwrap();
        let still = Still { positions: std::vec![scene.sheet.origin; 2], spheres: Vec::new() };
        let painter = Painter::new(&scene, [&still], Size::new(64, 64)).unwrap();
        let mut turned = painter.clone();
        turned.look(&painter.orbit());
        assert_eq!((turned.view, turned.light), (painter.view, painter.light));
    }
}
