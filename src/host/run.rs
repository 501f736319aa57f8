//! Simulations whose number type, grid and solver are chosen at run time.

use core::fmt;
use std::boxed::Box;
use std::vec::Vec;

use super::build::{Forces, SceneLinks, gravity};
use super::description::{Description, Wind};
use super::error::SceneError;
use super::grip::Grip;
use super::obstacles::Obstacles;
use super::parts::Parts;
use super::range::Range;
use super::solver::SceneSolver;
use crate::cloth::Cloth;
use crate::force::Hand;
use crate::grid::{Grid, Node};
use crate::link::Links;
use crate::measure::{self, digest, elastic_energy, gravitational_energy, is_finite, kinetic_energy};
use crate::particles::Particles;
use crate::scalar::{Q13, Q24, Scalar};
use crate::scene::Scene;
use crate::solver::Solver;
use crate::units::{Length, Units};
use crate::vec3::Vec3;

/// A number type, by its name on the command line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScalarKind {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    F64,
    /// Fixed point with 24 fraction bits.
    Q24,
    /// Fixed point with 24 fraction bits, in which links are measured to 13.
    Q13,
}

impl ScalarKind {
    /// Every number type.
    pub const ALL: [Self; 4] = [Self::F32, Self::F64, Self::Q24, Self::Q13];

    /// Its name.
    pub const fn name(self) -> &'static str {
        match self {
            Self::F32 => f32::NAME,
            Self::F64 => f64::NAME,
            Self::Q24 => Q24::NAME,
            Self::Q13 => Q13::NAME,
        }
    }

    /// The number type of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// Strain of one or all link families: `| |d|/L - 1 |` of a link. Both numbers are NaN if the strain of a link is undefined.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strain {
    /// The largest of all links.
    pub largest: f64,
    /// The root of the mean square.
    pub rms: f64,
}

/// Strain by family; `None` for a family that the scene does not have.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strains {
    /// Links to the next particle.
    pub stretch: Option<Strain>,
    /// Links along diagonals.
    pub shear: Option<Strain>,
    /// Links to the particle after the next.
    pub bend: Option<Strain>,
    /// All links together.
    pub all: Strain,
}

/// The visible state at one time.
#[derive(Clone, Debug, PartialEq)]
pub struct Still {
    /// Position of every particle, m, row by row.
    pub positions: Vec<[f64; 3]>,
    /// Centres of the balls, m.
    pub spheres: Vec<[f64; 3]>,
}

/// The state that a sheet carries from one [`Simulation`] to another.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// The positions.
    pub still: Still,
    /// Velocity of every particle, m/s, row by row.
    pub velocities: Vec<[f64; 3]>,
    /// Whether each particle is pinned, row by row.
    pub pinned: Vec<bool>,
}

/// The limit that an exploded sheet has exceeded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Explosion {
    /// A number is infinite or undefined.
    NotFinite,
    /// A particle is further than a million times the sheet's longer side, along an axis, from where the sheet's first particle started. Numbers may grow far beyond that
    /// before they are infinite.
    Far,
    /// A particle has left the range of this fixed-point type and has come back at its other end.
    OutOfRange(&'static str),
}

impl fmt::Display for Explosion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite => f.write_str("a number is not finite"),
            Self::Far => f.write_str("a particle is further than a million sheet sizes from the start"),
            Self::OutOfRange(scalar) => write!(f, "a particle left the range of {scalar}"),
        }
    }
}

/// The distance of [`Explosion::Far`], in longer sides of the sheet.
const FAR: f64 = 1e6;

/// A simulation, independent of its number type, grid and solver.
pub trait Simulation: Send {
    /// Advances by one frame.
    fn frame(&mut self);
    /// The positions of particles and balls.
    fn still(&self) -> Still;
    /// The strains of the link families.
    fn strains(&self) -> Strains;
    /// Kinetic, gravitational and elastic energy together, J.
    fn energy(&self) -> f64;
    /// 32-bit FNV-1a over the bits of the state: see [`digest`].
    fn digest(&self) -> u32;
    /// Whether the sheet has exploded, and how.
    fn explosion(&self) -> Option<Explosion>;
    /// Whether every number of the state is finite and no particle has left its bounds: see [`Explosion`].
    fn is_finite(&self) -> bool {
        self.explosion().is_none()
    }
    /// Whether the sheet is at rest, so that the next frame is not computed if nothing changes: a scene's `[rest]`.
    fn is_at_rest(&self) -> bool;
    /// The largest number of pairs of particles in contact at once in the last frame; `None` without `[self]`.
    fn self_contacts(&self) -> Option<u32>;
    /// The number of pairs of an edge and a triangle of the sheet that pass through each other: see [`intersections`](crate::measure::intersections).
    fn intersections(&self) -> u32;
    /// Positions, velocities and pins.
    fn state(&self) -> State;
    /// Continues from `state`, which must belong to a sheet of the same grid.
    fn restore(&mut self, state: &State);
    /// Pins a particle at its position, or releases it.
    fn set_pinned(&mut self, column: usize, row: usize, pinned: bool);
    /// Grabs a particle at its position, and releases any other.
    ///
    /// # Errors
    ///
    /// If the parts have no hand, the grip is invalid, or the number type does not represent it.
    fn grab(&mut self, column: usize, row: usize, grip: &Grip) -> Result<(), SceneError>;
    /// Drags the grabbed particle to a place, m, and no further than the range of the number type. A pin is carried there.
    fn drag(&mut self, place: [f64; 3]);
    /// Releases the grabbed particle. A pin stays at its position.
    fn release(&mut self);
    /// Changes gravity, m/s².
    ///
    /// # Errors
    ///
    /// If the number type does not represent it.
    fn set_gravity(&mut self, gravity: [f64; 3]) -> Result<(), SceneError>;
    /// Changes the wind.
    ///
    /// # Errors
    ///
    /// If the parts have no wind, or the number type does not represent it.
    fn set_wind(&mut self, wind: Option<&Wind>) -> Result<(), SceneError>;
}

impl Description {
    /// Makes a simulation of the scene from chosen parts, in a number type and on a grid known at compile time.
    ///
    /// # Errors
    ///
    /// If the scene has another grid, names something that the parts do not have, or has a value that the number type does not represent.
    ///
    /// ```
    /// use kerchief::host::{Bare, Counted, Description, built_in};
    ///
    /// let scene = Description::parse(built_in("gravity").unwrap().text)?;
    /// let mut simulation = scene.simulation_on::<Bare, Counted, 32, 32>()?;
    /// Counted::reset();
    /// simulation.frame();
    /// assert!(Counted::operations().total() > 0);
    /// # Ok::<(), kerchief::host::SceneError>(())
    /// ```
    pub fn simulation_on<P: Parts<S>, S: Scalar + Send, const W: usize, const H: usize>(
        &self,
    ) -> Result<Box<dyn Simulation>, SceneError> {
        if (self.sheet.columns, self.sheet.rows) != (W, H) {
            return Err(SceneError::new("cloth.columns", std::format!("not a grid of {W} × {H} particles")));
        }
        Running::<P, S, W, H>::boxed(self)
    }
}

/// The core's scene of a simulation.
type Played<S, P> = Scene<Forces<S, P>, SceneLinks<S, P>, <P as Parts<S>>::Obstacles, SceneSolver<S>>;

struct Running<P: Parts<S>, S: Scalar + Send, const W: usize, const H: usize> {
    units: Units,
    gravity: [f64; 3],
    scene: Played<S, P>,
    cloth: Box<Cloth<S, W, H>>,
    /// Inverse masses of the sheet without pins.
    unpinned: Box<Grid<S, W, H>>,
    range: Range<S>,
    /// The initial position of the first particle, and the sheet's largest distance from there, cells.
    start: [f64; 3],
    furthest: f64,
    /// The duration of a frame, s, and the distance that a pin is carried in it.
    frame: f64,
    stride: Length,
    memory: <SceneSolver<S> as Solver<S>>::Memory<SceneLinks<S, P>, W, H>,
}

impl<P: Parts<S>, S: Scalar + Send, const W: usize, const H: usize> Running<P, S, W, H> {
    fn boxed(description: &Description) -> Result<Box<dyn Simulation>, SceneError> {
        let units = description.units()?;
        let mut cloth = Box::new(description.cloth::<S, W, H>(&units)?);
        let unpinned = Box::new(cloth.inverse_mass);
        for &[column, row] in &description.sheet.pins {
            cloth.pin(Node { column, row });
        }
        let forces = description.forces::<S, P>(&units)?;
        let (links, obstacles) = (description.links::<S, P>(&units)?, P::obstacles(description, &units)?);
        let scene = Scene::new(&units, forces, links, obstacles, SceneSolver::new(description, &units)?);
        let (memory, range) = (scene.memory(), Range::new(&mut cloth.position.values()));
        let (start, gravity) = (units.point(description.sheet.origin).0, description.gravity);
        let furthest = FAR * (units.sides[0] * (W - 1) as f64).max(units.sides[1] * (H - 1) as f64);
        let (frame, stride) = (description.solver.step, Length(0.0));
        Ok(Box::new(Self { units, gravity, scene, cloth, unpinned, range, start, furthest, frame, stride, memory }))
    }
}

impl<P: Parts<S>, S: Scalar + Send, const W: usize, const H: usize> Simulation for Running<P, S, W, H> {
    fn frame(&mut self) {
        let hand = P::present(&mut self.scene.forces.3);
        if let Some((pin, place)) = hand.and_then(|hand| hand.carried(&self.cloth, self.stride)) {
            self.scene.move_pin(&mut self.cloth, pin, place);
        }
        self.scene.play(&mut self.cloth, &mut self.memory);
        // a sheet at rest does not move
        if !self.memory.is_at_rest() {
            self.range.look(&mut self.cloth.position.values());
        }
    }

    fn still(&self) -> Still {
        Still {
            positions: scaled(&mut self.cloth.position.values(), self.units.cell),
            spheres: self.scene.colliders.centres(&self.units),
        }
    }

    fn strains(&self) -> Strains {
        let (stretch, shear, bend) = &self.scene.links.springs;
        Strains {
            stretch: stretch.map(|links| strain(&self.cloth, &links)),
            shear: shear.map(|links| strain(&self.cloth, &links)),
            bend: bend.map(|links| strain(&self.cloth, &links)),
            all: strain(&self.cloth, &self.scene.links.springs),
        }
    }

    fn energy(&self) -> f64 {
        kinetic_energy(&self.cloth, &self.units)
            + gravitational_energy(&self.cloth, &self.units, self.gravity)
            + elastic_energy(&self.cloth, &self.units, &self.scene.links.springs)
    }

    fn digest(&self) -> u32 {
        digest(&self.cloth)
    }

    fn explosion(&self) -> Option<Explosion> {
        if !is_finite(&self.cloth) {
            Some(Explosion::NotFinite)
        } else if self.range.is_left() {
            Some(Explosion::OutOfRange(S::NAME))
        } else {
            far(&mut self.cloth.position.values(), self.start, self.furthest).then_some(Explosion::Far)
        }
    }

    fn is_at_rest(&self) -> bool {
        self.memory.is_at_rest()
    }

    fn self_contacts(&self) -> Option<u32> {
        self.memory.inner().contacts()
    }

    fn intersections(&self) -> u32 {
        measure::intersections(&self.cloth)
    }

    fn state(&self) -> State {
        let speed = self.units.cell / self.units.tick();
        State {
            still: self.still(),
            velocities: scaled(&mut self.cloth.velocity.values(), speed),
            pinned: self.cloth.inverse_mass.0.as_flattened().iter().map(|inverse| *inverse == S::ZERO).collect(),
        }
    }

    fn restore(&mut self, state: &State) {
        let Particles { position, velocity, inverse_mass } = &mut **self.cloth;
        let unpinned = self.unpinned.0.as_flattened();
        for (index, inverse_mass) in inverse_mass.0.as_flattened_mut().iter_mut().enumerate() {
            *inverse_mass = if state.pinned[index] { S::ZERO } else { unpinned[index] };
        }
        let (mut positions, mut velocities) = (state.still.positions.iter(), state.velocities.iter());
        position.change(|x| positions.next().map_or(x, |&metres| self.units.place(metres).to_vec()));
        velocity.change(|v| velocities.next().map_or(v, |&speed| Vec3::from_f64(self.units.motion(speed).0)));
        self.scene.colliders.set_centres(&self.units, &state.still.spheres);
        self.range = Range::new(&mut self.cloth.position.values());
        self.memory = self.scene.memory();
    }

    fn set_pinned(&mut self, column: usize, row: usize, pinned: bool) {
        let node = Node { column, row };
        if pinned {
            self.cloth.pin(node);
        } else {
            self.cloth.release(node, self.unpinned[node]);
        }
    }

    fn grab(&mut self, column: usize, row: usize, grip: &Grip) -> Result<(), SceneError> {
        let mut taking = P::hand(&self.units, grip)?;
        self.release();
        if let Some(hand) = P::present(&mut taking) {
            hand.grab(&self.cloth, Node { column, row });
        }
        self.scene.forces.3 = taking;
        self.stride = Length((grip.speed * self.frame / self.units.cell).min(0.5 * S::LARGEST));
        Ok(())
    }

    fn drag(&mut self, place: [f64; 3]) {
        let Some(hand) = P::present(&mut self.scene.forces.3) else { return };
        let Some((node, _)) = hand.held() else { return };
        let (from, to) = (self.cloth.position.at(node).to_f64(), self.units.place(place).0);
        // also limited so that the difference stays in the range
        let within = |axis: usize| {
            let [low, high] = [-0.5, 0.5].map(|part| from[axis] + part * S::LARGEST);
            to[axis].clamp(low.max(-S::LARGEST), high.min(S::LARGEST))
        };
        if from.iter().chain(&to).all(|x| x.is_finite()) {
            hand.drag_to(Vec3::from_f64([0, 1, 2].map(within)));
        }
    }

    fn release(&mut self) {
        let mut held = core::mem::take(&mut self.scene.forces.3);
        if let Some(pin) = P::present(&mut held).and_then(Hand::drop).filter(|&node| self.cloth.is_pinned(node)) {
            // it may have been on its way to its target
            self.cloth.pin(pin);
        }
    }

    fn set_gravity(&mut self, acceleration: [f64; 3]) -> Result<(), SceneError> {
        self.scene.forces.0 = gravity(&self.units, acceleration)?;
        self.gravity = acceleration;
        Ok(())
    }

    fn set_wind(&mut self, wind: Option<&Wind>) -> Result<(), SceneError> {
        self.scene.forces.2 = P::air(&self.units, wind)?;
        Ok(())
    }
}

/// Takes an iterator: compiled for each number type, not for each grid.
fn scaled<S: Scalar>(vectors: &mut dyn Iterator<Item = Vec3<S>>, unit: f64) -> Vec<[f64; 3]> {
    vectors.map(|vector| vector.to_f64().map(|component| component * unit)).collect()
}

/// Whether any position is further than `furthest` from `start` along an axis.
fn far<S: Scalar>(positions: &mut dyn Iterator<Item = Vec3<S>>, start: [f64; 3], furthest: f64) -> bool {
    positions.map(Vec3::to_f64).any(|position| (0..3).any(|axis| (position[axis] - start[axis]).abs() > furthest))
}

fn strain<S: Scalar, const W: usize, const H: usize>(cloth: &Cloth<S, W, H>, links: &impl Links<S>) -> Strain {
    let strain = measure::strain(cloth, links);
    let (largest, rms) = (strain.largest.to_f64(), strain.rms.to_f64());
    // A comparison ignores links whose strain is undefined; the sum does not.
    Strain { largest: if rms.is_nan() { rms } else { largest }, rms }
}
