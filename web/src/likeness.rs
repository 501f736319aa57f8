//! A sheet's copy in `f64`. Measures, explosions and pictures are computed from the copy, so that their code is compiled once for each grid and not for each number
//! type and solver too.

use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::Rgb888;
use kerchief::material::Springs;
use kerchief::measure::{self, Strain};
use kerchief::render::pattern::{Border, CELL, Gingham, Width};
use kerchief::render::{Ball, Ground, Light, Look, Orbit, Shaded, Shadow};
use kerchief::{Grid, Node, Particles, Scalar, Sheet, Vec3};

use crate::eye::camera;
use crate::frame::Frame;
use crate::frequency;
use crate::parts::{self, BALL, Links};
use crate::settings::{SIZE, Settings};

/// Whether a sheet moves, or how it has exploded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Fate {
    /// It moves.
    Moving = 0,
    /// A number is infinite or undefined.
    NotFinite,
    /// A particle has left the range of fixed point and reappears at the other end.
    OutOfRange,
    /// A link is several times its rest length, and a particle is far away.
    Burst,
}

/// A sheet has burst if the largest strain of its links exceeds `STRAINED` and a coordinate of a particle exceeds `FAR` sheet sizes.
const STRAINED: f64 = 5.0;
const FAR: f64 = 20.0;
/// Coordinates are limited to this before drawing, cells.
const FURTHEST: f64 = 512.0;

/// Colours of the left sheet and of the right one: plain threads; coloured threads and border.
const TONES: [[Rgb888; 2]; 2] =
    [[Rgb888::new(250, 240, 226), Rgb888::new(178, 34, 38)], [Rgb888::new(244, 242, 234), Rgb888::new(38, 84, 140)]];
const BALL_TONE: Rgb888 = Rgb888::new(128, 132, 130);
const SHADOW: Rgb888 = Rgb888::new(172, 164, 154);
/// Light from the floor: cloth is mostly seen from the side or from below.
const REFLECTED: Rgb888 = Rgb888::new(140, 130, 122);
/// Bands of the pattern along a side.
const BANDS: i32 = 15;

/// The copy of a sheet of `N × N` particles, drawn with `FACES × FACES` faces a cell.
#[derive(Debug)]
pub struct Likeness<const N: usize, const FACES: usize> {
    sheet: Sheet<f64, N, N>,
    links: Links<f64>,
    springs: Springs,
    particles: Box<Particles<f64, N, N>>,
    gravity: [f64; 3],
    ball: Option<[f64; 3]>,
    places: Vec<[f64; 3]>,
    fate: Fate,
}

impl<const N: usize, const FACES: usize> Likeness<N, FACES> {
    /// The copy of a sheet.
    pub fn new<S: Scalar>(settings: &Settings, substeps: u32, particles: &Particles<S, N, N>) -> Self {
        let sheet = Sheet::<f64, N, N>::of(&settings.material(), [SIZE; 2], crate::settings::FRAME, substeps);
        let springs = parts::stiffness(&sheet, settings);
        let links = (
            sheet.damped(sheet.stretch(springs.stretch), 0.0),
            settings.shear.then(|| sheet.damped(sheet.shear(springs.shear), 0.0)),
            settings.bend.then(|| sheet.damped(sheet.bend(springs.bend), 0.0)),
        );
        let mut likeness = Self {
            sheet,
            links,
            springs,
            particles: Box::new(Particles::BLANK),
            gravity: [0.0; 3],
            ball: None,
            places: Vec::new(),
            fate: Fate::Moving,
        };
        likeness.change(settings);
        copy(particles, &mut likeness.particles);
        likeness.list();
        likeness
    }

    /// Takes over the settings that the copy needs and that change while a sheet moves: gravity and the ball.
    pub fn change(&mut self, settings: &Settings) {
        self.gravity = settings.gravity();
        self.ball = settings.ball.then(|| settings.start.ball());
    }

    /// Takes over the particles after a frame. If the sheet has exploded, the copy keeps the previous frame.
    pub fn follow<S: Scalar>(&mut self, particles: &Particles<S, N, N>) -> Fate {
        self.fate = self.take(particles);
        self.fate
    }

    /// Takes over the particles after a substep of the frame in which the sheet explodes. Returns false, and takes over nothing, once it has exploded.
    pub fn approach<S: Scalar>(&mut self, particles: &Particles<S, N, N>) -> bool {
        self.take(particles) == Fate::Moving
    }

    fn take<S: Scalar>(&mut self, particles: &Particles<S, N, N>) -> Fate {
        let mut next = Box::new(Particles::BLANK);
        copy(particles, &mut next);
        let fate = self.fate_of(&next, if S::EXACT_SUMS { S::LARGEST } else { f64::INFINITY });
        if fate == Fate::Moving {
            self.particles = next;
            self.list();
        }
        fate
    }

    /// Takes over whether a particle is pinned: its inverse mass is then 0.
    pub fn hold(&mut self, node: Node, inverse_mass: f64) {
        self.particles.inverse_mass[node] = inverse_mass;
        if inverse_mass == 0.0 {
            self.particles.velocity.set(node, Vec3::ZERO);
        }
    }

    fn list(&mut self) {
        self.places.clear();
        self.places.extend(self.particles.position.values().map(|place| self.sheet.metres(place)));
    }

    fn fate_of(&self, next: &Particles<f64, N, N>, range: f64) -> Fate {
        if !measure::is_finite(next) {
            return Fate::NotFinite;
        }
        let mut ways = self.particles.position.values().zip(next.position.values());
        // Fixed point wraps around. A displacement of more than half the circle in a frame means that the particle went the other way, across the end of the range.
        if ways.any(|(from, to)| largest(to - from) > range) {
            return Fate::OutOfRange;
        }
        let furthest = next.position.values().map(largest).fold(0.0, f64::max);
        let is_far = furthest * self.sheet.units.cell > FAR * SIZE;
        if is_far && measure::strain(next, &self.links).largest > STRAINED { Fate::Burst } else { Fate::Moving }
    }

    /// The particles for drawing and picking.
    fn drawn(&self) -> Particles<f32, N, N> {
        let near = |cells: f64| cells.clamp(-FURTHEST, FURTHEST);
        let mut drawn = Particles::BLANK;
        for node in Grid::<f32, N, N>::nodes() {
            drawn.position.set(node, Vec3::from_f64(self.particles.position.at(node).to_f64().map(near)));
        }
        drawn
    }
}

/// Measures and pictures of a sheet of any grid.
pub trait Shown {
    /// Whether the sheet moves, or how it has exploded.
    fn fate(&self) -> Fate;
    /// Positions of the particles, m, row by row.
    fn places(&self) -> &[[f64; 3]];
    /// Strain of the links.
    fn strain(&self) -> Strain<f64>;
    /// Kinetic, gravitational and elastic energy together, J.
    fn energy(&self) -> f64;
    /// The highest angular frequency of the sheet, 1/s.
    fn frequency(&self) -> f64;
    /// Draws the sheet, the ball and the floor, in the colours of the left sheet or of the right one.
    fn draw(&self, eye: &Orbit, right: bool, frame: &mut Frame);
    /// The particle at a pixel or near it.
    fn pick(&self, eye: &Orbit, screen: Size, pixel: Point) -> Option<Node>;
    /// The point (m) under a pixel, at the depth of the point `place` (m).
    fn under(&self, eye: &Orbit, screen: Size, pixel: Point, place: [f64; 3]) -> [f64; 3];
    /// The pixel at which a particle is seen.
    fn pixel(&self, eye: &Orbit, screen: Size, node: Node) -> Option<Point>;
}

impl<const N: usize, const FACES: usize> Shown for Likeness<N, FACES> {
    fn fate(&self) -> Fate {
        self.fate
    }

    fn places(&self) -> &[[f64; 3]] {
        &self.places
    }

    fn strain(&self) -> Strain<f64> {
        measure::strain(&*self.particles, &self.links)
    }

    fn energy(&self) -> f64 {
        let Self { sheet, links, particles, gravity, .. } = self;
        measure::kinetic_energy(particles, &sheet.units)
            + measure::gravitational_energy(particles, &sheet.units, *gravity)
            + measure::elastic_energy(particles, &sheet.units, links)
    }

    fn frequency(&self) -> f64 {
        let inverse: Vec<f64> =
            self.particles.inverse_mass.values().map(|inverse| inverse / self.sheet.units.mass).collect();
        frequency::highest(N, &inverse, &self.springs)
    }

    fn draw(&self, eye: &Orbit, right: bool, frame: &mut Frame) {
        let units = &self.sheet.units;
        let camera = camera(eye, units, embedded_graphics::geometry::OriginDimensions::size(frame));
        let ball = self.ball.map(|centre| Ball::new(units.point(centre), units.length(BALL), BALL_TONE));
        let ground = Ground::new(units.point([0.0; 3]), units.length(1.5)).tiles(units.length(0.15));
        let ground = ground.shadow(Shadow::<96>::new(SHADOW).soften(3));
        let width = Width::parts(CELL * (N as i32 - 1) / BANDS);
        let tones = TONES[usize::from(right)];
        let pattern = Border { width, tone: tones[1], inner: Gingham { width, tones } };
        let light = Light { ground: REFLECTED, ..Light::new(eye.azimuth - 40.0, 36.0) };
        let look = Look::new(light, pattern).solids(ball.as_slice()).backdrop(ground);
        let Ok(()) = Shaded::<_, N, N>::new(look).smooth::<FACES>().draw(&self.drawn(), &camera, frame);
    }

    fn pick(&self, eye: &Orbit, screen: Size, pixel: Point) -> Option<Node> {
        let units = &self.sheet.units;
        camera(eye, units, screen).ray(pixel).pick(&self.drawn(), units.length(0.03))
    }

    fn under(&self, eye: &Orbit, screen: Size, pixel: Point, place: [f64; 3]) -> [f64; 3] {
        let units = &self.sheet.units;
        units.metres(camera(eye, units, screen).under(pixel, units.point(place).to_vec()))
    }

    fn pixel(&self, eye: &Orbit, screen: Size, node: Node) -> Option<Point> {
        camera(eye, &self.sheet.units, screen).project(Vec3::from_f64(self.particles.position.at(node).to_f64()))
    }
}

fn largest(vector: Vec3<f64>) -> f64 {
    vector.to_f64().into_iter().fold(0.0, |largest, component| largest.max(component.abs()))
}

fn copy<S: Scalar, const N: usize>(from: &Particles<S, N, N>, to: &mut Particles<f64, N, N>) {
    for node in Grid::<S, N, N>::nodes() {
        to.position.set(node, Vec3::from_f64(from.position.at(node).to_f64()));
        to.velocity.set(node, Vec3::from_f64(from.velocity.at(node).to_f64()));
        to.inverse_mass[node] = from.inverse_mass[node].to_f64();
    }
}
