//! The usual entry point: a sheet's size, number type and units in one constant.
//!
//! ```
//! use kerchief::*;
//!
//! // m, kg of a particle, s, substeps
//! const SHEET: Sheet<Q24, 16, 16> = Sheet::new([0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
//!
//! let mut cloth = SHEET.hang([0.0, 0.0, 0.3]);
//! cloth.pin(Node::new(0, 0));
//! let forces = (SHEET.gravity([0.0, 0.0, -9.81]), SHEET.drag(0.5));
//! let links = (SHEET.stretch(100.0), SHEET.shear(1.0));
//! let ball = SHEET.ball([0.15, 0.1, 0.1], 0.05, 0.005);
//! let scene = SHEET.scene(forces, links, ball, Lines::new());
//! let mut memory = scene.memory();
//! scene.step(&mut cloth, &mut memory);
//! ```
//!
//! Everything made by a [`Sheet`] is for sheets of its size and number type: its scenes step no other sheet.

use core::marker::PhantomData;

use crate::cloth::Cloth;
use crate::collider::{Capsule, Moving, Plane, Sphere};
use crate::force::{AerodynamicWind, Drag, FacetWind, Gravity, Hand, PanelWind};
use crate::grid::Node;
use crate::link::{Bend, Damped, Shear, Stretch, Tether};
use crate::material::Material;
use crate::rest::{Resting, Stillness};
use crate::scalar::Scalar;
use crate::scene::{Only, Scene};
use crate::self_contact::{SelfContact, Thickness};
use crate::units::Units;
use crate::vec3::Vec3;

/// The size, number type and units of a sheet of `W` × `H` particles, with constructors for its parts.
#[derive(Debug)]
pub struct Sheet<S, const W: usize, const H: usize> {
    /// Cells, ticks and masses.
    pub units: Units,
    number: PhantomData<fn() -> S>,
}

// not derived: a derive would require `S: Copy`, and no number is stored
impl<S, const W: usize, const H: usize> Copy for Sheet<S, W, H> {}

impl<S, const W: usize, const H: usize> Clone for Sheet<S, W, H> {
    fn clone(&self) -> Self {
        *self
    }
}

impl<S: Scalar, const W: usize, const H: usize> Sheet<S, W, H> {
    /// A sheet of `[width, height]` (m) whose particles have `mass` (kg) each. It moves in frames of `frame` (s), divided into `substeps`.
    ///
    /// # Panics
    /// At compile time in a constant, like [`Units::sheet`].
    #[track_caller]
    pub const fn new(size: [f64; 2], mass: f64, frame: f64, substeps: u32) -> Self {
        Self { units: Units::sheet([W, H], size, mass, frame, substeps), number: PhantomData }
    }

    /// A sheet of a material. A particle has the mass of one cell.
    ///
    /// # Panics
    /// At compile time in a constant, like [`Units::sheet`].
    #[track_caller]
    pub const fn of(material: &Material, size: [f64; 2], frame: f64, substeps: u32) -> Self {
        Self { units: material.units([W, H], size, frame, substeps), number: PhantomData }
    }

    /// An upright sheet in the x-z plane: row 0 on top, particle (0, 0) at `origin` (m).
    ///
    /// # Panics
    /// If a particle would be beyond the range of the number type.
    #[track_caller]
    #[inline]
    pub fn hang(&self, origin: [f64; 3]) -> Cloth<S, W, H> {
        Cloth::hang(&self.units, self.units.point(origin))
    }

    /// A flat sheet in the x-y plane: particle (0, 0) at `origin` (m), columns along x, rows along y.
    ///
    /// # Panics
    /// If a particle would be beyond the range of the number type.
    #[track_caller]
    #[inline]
    pub fn lay(&self, origin: [f64; 3]) -> Cloth<S, W, H> {
        Cloth::lay(&self.units, self.units.point(origin))
    }

    /// Gravity, m/s².
    ///
    /// # Panics
    /// Like every method below, if the number type does not represent the value: see [`units`](crate::units).
    #[track_caller]
    #[inline]
    pub fn gravity(&self, acceleration: [f64; 3]) -> Gravity<S> {
        Gravity::new(self.units.acceleration(acceleration))
    }

    /// Drag −m·γ·v with the rate γ (1/s).
    #[track_caller]
    #[inline]
    pub fn drag(&self, per_second: f64) -> Drag<S> {
        Drag::new(self.units.drag(per_second))
    }

    /// Wind of the facet model, by its velocity (m/s).
    #[track_caller]
    #[inline]
    pub fn facet_wind(&self, velocity: [f64; 3]) -> FacetWind<S> {
        FacetWind::new(self.units.facet_wind(velocity))
    }

    /// Wind of the aerodynamic model, by its velocity (m/s), the air's density (kg/m³) and the drag coefficient of a plate across the flow.
    #[track_caller]
    #[inline]
    pub fn aerodynamic_wind(&self, velocity: [f64; 3], density: f64, drag_coefficient: f64) -> AerodynamicWind<S> {
        AerodynamicWind::new(self.units.aerodynamic_wind(velocity, density, drag_coefficient))
    }

    /// Wind on cells, the cheapest on a board, by its velocity (m/s), the air's density (kg/m³) and the drag coefficient of a plate across the flow.
    #[track_caller]
    #[inline]
    pub fn panel_wind(&self, velocity: [f64; 3], density: f64, drag_coefficient: f64) -> PanelWind<S> {
        PanelWind::new(self.units.panel_wind(velocity, density, drag_coefficient))
    }

    /// Springs along rows and columns, by their stiffness (N/m).
    #[track_caller]
    #[inline]
    pub fn stretch(&self, stiffness: f64) -> Stretch<S> {
        Stretch::new(&self.units, self.units.stiffness(stiffness))
    }

    /// Springs along the diagonals of cells, by their stiffness (N/m).
    #[track_caller]
    #[inline]
    pub fn shear(&self, stiffness: f64) -> Shear<S> {
        Shear::new(&self.units, self.units.stiffness(stiffness))
    }

    /// Springs along rows and columns between a particle and the next but one, by their stiffness (N/m).
    #[track_caller]
    #[inline]
    pub fn bend(&self, stiffness: f64) -> Bend<S> {
        Bend::new(&self.units, self.units.stiffness(stiffness))
    }

    /// The springs of a material in folds by the angle `fold` (rad) between neighbouring cells: see [`Material::springs`].
    #[track_caller]
    #[inline]
    pub fn springs(&self, material: &Material, fold: f64) -> (Stretch<S>, Shear<S>, Bend<S>) {
        let springs = material.springs(&self.units, fold);
        (self.stretch(springs.stretch), self.shear(springs.shear), self.bend(springs.bend))
    }

    /// `links` with a damper (N·s/m) parallel to each spring.
    #[track_caller]
    #[inline]
    pub fn damped<L>(&self, links: L, damping: f64) -> Damped<L, S> {
        Damped::new(links, self.units.damping(damping))
    }

    /// An empty hand, by its compliance (m/N), its damping (N·s/m) and the distance to the target (m) at which its force stops growing.
    #[track_caller]
    #[inline]
    pub fn hand(&self, compliance: f64, damping: f64, reach: f64) -> Hand<S> {
        let (spring, damper) = (self.units.compliance(compliance), self.units.damping(damping));
        Hand::new(&self.units, spring, damper, self.units.length(reach))
    }

    /// A ball at rest without friction, by its centre, its radius and the `margin` between its surface and particles, m.
    #[track_caller]
    #[inline]
    pub fn ball(&self, centre: [f64; 3], radius: f64, margin: f64) -> Sphere<S> {
        Sphere::new(self.units.point(centre), self.units.length(radius), self.units.length(margin))
    }

    /// A ball that moves with `velocity` (m/s).
    #[track_caller]
    #[inline]
    pub fn moving_ball(&self, centre: [f64; 3], radius: f64, margin: f64, velocity: [f64; 3]) -> Moving<Sphere<S>> {
        self.ball(centre, radius, margin).with_velocity(self.units.velocity(velocity))
    }

    /// The half-space below a plane through `point` (m), with a normal of any length; particles keep `margin` (m) away from it.
    #[track_caller]
    #[inline]
    pub fn plane(&self, point: [f64; 3], normal: [f64; 3], margin: f64) -> Plane<S> {
        Plane::new(self.units.point(point), Vec3::from_f64(normal), self.units.length(margin))
    }

    /// A rod with round ends between `a` and `b`, by its radius and the `margin` between its surface and particles, m.
    #[track_caller]
    #[inline]
    pub fn rod(&self, a: [f64; 3], b: [f64; 3], radius: f64, margin: f64) -> Capsule<S> {
        let [a, b] = [a, b].map(|end| self.units.point(end));
        Capsule::new(a, b, self.units.length(radius), self.units.length(margin))
    }

    /// A position (m) in the sheet's units and numbers, for example a hand's target.
    ///
    /// # Panics
    /// If a component is not finite.
    #[track_caller]
    #[inline]
    pub fn place(&self, metres: [f64; 3]) -> Vec3<S> {
        self.units.point(metres).to_vec()
    }

    /// A position in the sheet's units, in m.
    #[inline]
    pub fn metres(&self, place: Vec3<S>) -> [f64; 3] {
        self.units.metres(place)
    }

    /// Tethers to up to `N` pins, each `1 + slack` times as long as the distance at rest.
    ///
    /// # Errors
    /// Returns the anchors if there are more than `N`.
    #[track_caller]
    #[inline]
    pub fn tether<'a, const N: usize>(&self, anchors: &'a [Node], slack: f64) -> Result<Tether<S, N>, &'a [Node]> {
        Tether::new(&self.units, anchors, slack)
    }

    /// `solver` with contact of the sheet with itself, by the sheet's thickness (m) and its coefficient of friction on itself.
    ///
    /// # Panics
    /// For a thickness that is not between 0.75 and 1 times the longer side of a cell.
    #[track_caller]
    #[inline]
    pub fn self_contact<V>(&self, thickness: f64, friction: f64, solver: V) -> SelfContact<S, V> {
        SelfContact::new(Thickness::new(&self.units, thickness), friction, solver)
    }

    /// `solver`, which stops computing while a sheet is as still as `stillness`.
    #[track_caller]
    #[inline]
    pub fn resting<V>(&self, stillness: Stillness, solver: V) -> Resting<V> {
        Resting::new(&self.units, stillness, solver)
    }

    /// A scene for sheets of this kind. `()` is an empty slot; a tuple combines its members.
    #[inline]
    pub const fn scene<F, L, C, V>(
        &self,
        forces: F,
        links: L,
        colliders: C,
        solver: V,
    ) -> Scene<F, L, C, V, Only<S, W, H>> {
        Scene::of(&self.units, forces, links, colliders, solver)
    }
}
