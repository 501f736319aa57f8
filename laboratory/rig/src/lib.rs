//! One description of a scene, two ways to move it: the reference's [`Model`], moved by the core.
//!
//! [`Rig`] is the core's side, for any solver, number type, further links and colliders. [`moved`] hides the solver's type, so that a test
//! can loop over [`Method`]s. States are in SI units, as in the reference.
#![allow(
    missing_docs,
    missing_debug_implementations,
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    reason = "not published: names and signatures say it"
)]

mod compare;
mod method;
pub mod reference;
pub mod scenes;

use kerchief::{
    AerodynamicWind, Bend, Cloth, Collider, Damped, Drag, FacetWind, Gravity, Links, Node, PanelWind, Scalar, Scene,
    Shear, Solver, Stretch, Units, Vec3,
};

use crate::reference::vector::scale;
use crate::reference::{BEND, Model, Pose, SHEAR, STRETCH, Sheet, State, Wind};

pub use compare::{carried, error, free, largest_error, stirred, strain, tenths};
pub use method::{ALL, Method, Motion, moved};

/// The forces of a [`Model`].
pub type Forces<S> =
    (Gravity<S>, Option<Drag<S>>, Option<FacetWind<S>>, (Option<AerodynamicWind<S>>, Option<PanelWind<S>>));

/// The links of a [`Model`].
pub type Springs<S> = (Option<Damped<Stretch<S>, S>>, Option<Damped<Shear<S>, S>>, Option<Damped<Bend<S>, S>>);

/// The length of a frame (s), and the number of its substeps.
#[derive(Clone, Copy, Debug)]
pub struct Pace {
    pub frame: f64,
    pub substeps: u32,
}

impl Pace {
    pub const fn new(frame: f64, substeps: u32) -> Self {
        Self { frame, substeps }
    }

    /// The core's units for a sheet. Its middle particle has the unit mass.
    pub fn units(self, sheet: &Sheet) -> Units {
        let ordinary = sheet.masses[sheet.index((sheet.columns / 2, sheet.rows / 2))];
        Units::sheet([sheet.columns, sheet.rows], [sheet.width, sheet.height], ordinary, self.frame, self.substeps)
    }
}

/// A scene of the core, its sheet and its solver's memory.
pub struct Rig<S: Scalar, V: Solver<S>, const W: usize, const H: usize, L: Links<S> = Springs<S>, C = ()> {
    pub units: Units,
    pub scene: Scene<Forces<S>, L, C, V>,
    pub cloth: Cloth<S, W, H>,
    pub memory: V::Memory<L, W, H>,
}

impl<S: Scalar, V: Solver<S>, const W: usize, const H: usize> Rig<S, V, W, H> {
    pub fn new(model: &Model, pace: Pace, solver: V) -> Self {
        let units = pace.units(&model.sheet);
        let scene = Scene::new(&units, forces(model, &units), springs(model, &units), (), solver);
        Self { units, cloth: cloth(&model.sheet, &units), memory: scene.memory(), scene }
    }
}

impl<S: Scalar, V: Solver<S>, const W: usize, const H: usize, L: Links<S>, C: Collider<S>> Rig<S, V, W, H, L, C> {
    /// The same rig with links made from its own ones.
    pub fn with_links<M: Links<S>>(self, links: impl FnOnce(&Units, L) -> M) -> Rig<S, V, W, H, M, C> {
        let Self { units, scene, cloth, .. } = self;
        let Scene { forces, links: own, colliders, solver, .. } = scene;
        let scene = Scene::new(&units, forces, links(&units, own), colliders, solver);
        Rig { units, memory: scene.memory(), scene, cloth }
    }

    /// The same rig with colliders.
    pub fn with_colliders<D: Collider<S>>(self, colliders: impl FnOnce(&Units) -> D) -> Rig<S, V, W, H, L, D> {
        let Self { units, scene, cloth, memory } = self;
        let Scene { forces, links, solver, .. } = scene;
        let scene = Scene::new(&units, forces, links, colliders(&units), solver);
        Rig { units, scene, cloth, memory }
    }

    /// Moves the sheet and its colliders by one frame.
    pub fn step(&mut self) {
        self.scene.play(&mut self.cloth, &mut self.memory);
    }

    pub fn run(&mut self, frames: u32) {
        (0..frames).for_each(|_| self.step());
    }

    /// A point in the core's units and numbers.
    pub fn place(&self, metres: [f64; 3]) -> Vec3<S> {
        self.units.point(metres).to_vec()
    }

    /// Positions in m and velocities in m/s.
    pub fn state(&self) -> State {
        let speed = self.units.cell / self.units.tick();
        State {
            position: self.cloth.position.values().map(|x| scale(self.units.cell, x.to_f64())).collect(),
            velocity: self.cloth.velocity.values().map(|v| scale(speed, v.to_f64())).collect(),
        }
    }

    /// Sets positions (m) and velocities (m/s) of the particles.
    pub fn set(&mut self, state: &State) {
        let (mut positions, mut velocities) = (state.position.iter(), state.velocity.iter());
        let units = &self.units;
        self.cloth.position.change(|x| positions.next().map_or(x, |&metres| units.point(metres).to_vec()));
        self.cloth.velocity.change(|v| velocities.next().map_or(v, |&speed| Vec3::from_f64(units.velocity(speed).0)));
    }
}

fn forces<S: Scalar>(model: &Model, units: &Units) -> Forces<S> {
    let gravity = Gravity::new(units.acceleration(model.gravity));
    let drag = (model.drag != 0.0).then(|| Drag::new(units.drag(model.drag)));
    match model.wind {
        None => (gravity, drag, None, (None, None)),
        Some(Wind::Facet(wind)) => (gravity, drag, Some(FacetWind::new(units.facet_wind(wind))), (None, None)),
        Some(Wind::Aerodynamic { velocity, density, drag_coefficient }) => {
            let airflow = units.aerodynamic_wind(velocity, density, drag_coefficient);
            (gravity, drag, None, (Some(AerodynamicWind::new(airflow)), None))
        }
        Some(Wind::Panel { velocity, density, drag_coefficient }) => {
            let flow = units.panel_wind(velocity, density, drag_coefficient);
            (gravity, drag, None, (None, Some(PanelWind::new(flow))))
        }
    }
}

fn springs<S: Scalar>(model: &Model, units: &Units) -> Springs<S> {
    let strengths = |offsets| {
        let family = model.families.iter().find(|family| family.offsets == offsets)?;
        Some((units.stiffness(family.stiffness), units.damping(family.damping)))
    };
    (
        strengths(STRETCH).map(|(k, damping)| Damped::new(Stretch::new(units, k), damping)),
        strengths(SHEAR).map(|(k, damping)| Damped::new(Shear::new(units, k), damping)),
        strengths(BEND).map(|(k, damping)| Damped::new(Bend::new(units, k), damping)),
    )
}

fn cloth<S: Scalar, const W: usize, const H: usize>(sheet: &Sheet, units: &Units) -> Cloth<S, W, H> {
    assert_eq!([W, H], [sheet.columns, sheet.rows], "columns and rows of the model");
    let origin = units.point(sheet.origin);
    let mut cloth = match sheet.pose {
        Pose::Lay => Cloth::lay(units, origin),
        Pose::Hang => Cloth::hang(units, origin),
    };
    for (inverse, mass) in cloth.inverse_mass.values_mut().zip(&sheet.masses) {
        *inverse = S::from_f64(units.mass / mass);
    }
    for &(column, row) in &sheet.pins {
        cloth.pin(Node::new(column, row));
    }
    cloth
}
