//! The sheet of the stress tests and its scene.

use kerchief::{
    AerodynamicWind, Bend, Cloth, Drag, FacetWind, Gravity, Grid, Moving, Node, Scalar, Scene, Shear, Solver, Sphere,
    Stretch, Units, Vec3, measure,
};

/// A sheet's properties, in SI units.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sheet {
    /// m
    pub(crate) size: f64,
    /// kg a particle
    pub(crate) mass: f64,
    /// N/m
    pub(crate) stretch: f64,
    pub(crate) shear: f64,
    pub(crate) bend: f64,
    /// The length of a frame, s.
    pub(crate) frame: f64,
    pub(crate) substeps: u32,
    /// 1/s
    pub(crate) drag: f64,
}

/// A metre of light cloth in frames of 1/60 s. With 8 × 8 particles, hanging from two corners, it is strained by 0.5 %.
pub(crate) const CLOTH: Sheet = Sheet {
    size: 1.0,
    mass: 2e-3,
    stretch: 1000.0,
    shear: 100.0,
    bend: 10.0,
    frame: 1.0 / 60.0,
    substeps: 8,
    drag: 1.0,
};

pub(crate) const DOWN: [f64; 3] = [0.0, 0.0, -9.81];

type Forces<S> = (Gravity<S>, Drag<S>, Option<FacetWind<S>>, Option<AerodynamicWind<S>>);
type Links<S> = (Stretch<S>, Shear<S>, Bend<S>);

/// The sheet, pinned at its two upper corners, its scene and its solver's memory.
pub(crate) struct Stage<S: Scalar, V: Solver<S>, const W: usize, const H: usize> {
    pub(crate) units: Units,
    pub(crate) scene: Scene<Forces<S>, Links<S>, Moving<Sphere<S>>, V>,
    pub(crate) cloth: Cloth<S, W, H>,
    memory: V::Memory<Links<S>, W, H>,
    random: u64,
}

/// The upper corners.
pub(crate) const fn corners<const W: usize>() -> [Node; 2] {
    [Node::new(0, 0), Node::new(W - 1, 0)]
}

impl<S: Scalar, V: Solver<S>, const W: usize, const H: usize> Stage<S, V, W, H> {
    pub(crate) fn new(sheet: &Sheet, solver: V) -> Self {
        let Sheet { size, mass, stretch, shear, bend, frame, substeps, drag } = *sheet;
        let units = Units::sheet([W, H], [size, size], mass, frame, substeps);
        // around the origin, so that there is the most space in all directions
        let mut cloth = Cloth::hang(&units, units.point([-0.5 * size, 0.0, 0.5 * size]));
        corners::<W>().into_iter().for_each(|node| cloth.pin(node));
        let links = (
            Stretch::new(&units, units.stiffness(stretch)),
            Shear::new(&units, units.stiffness(shear)),
            Bend::new(&units, units.stiffness(bend)),
        );
        let forces = (Gravity::new(units.acceleration(DOWN)), Drag::new(units.drag(drag)), None, None);
        let nowhere = Sphere::new(units.point([3.0 * size, 0.0, 0.0]), units.length(0.01 * size), units.length(0.0));
        let nowhere = nowhere.with_velocity(units.velocity([0.0; 3]));
        let scene = Scene::new(&units, forces, links, nowhere, solver);
        let memory = scene.memory();
        Self { units, scene, cloth, memory, random: 0x9e37_79b9_7f4a_7c15 }
    }

    pub(crate) fn step(&mut self) {
        self.scene.play(&mut self.cloth, &mut self.memory);
    }

    /// A pseudorandom number from −1 to 1 (G. Marsaglia, *Xorshift RNGs*, 2003).
    pub(crate) fn random(&mut self) -> f64 {
        self.random ^= self.random << 13;
        self.random ^= self.random >> 7;
        self.random ^= self.random << 17;
        (self.random >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn random_vector(&mut self, largest: f64) -> [f64; 3] {
        core::array::from_fn(|_| largest * self.random())
    }

    /// Puts every free particle where `place` says, m.
    pub(crate) fn place(&mut self, mut place: impl FnMut(&mut Self, Node) -> [f64; 3]) {
        for node in Grid::<S, W, H>::nodes() {
            if !self.cloth.is_pinned(node) {
                let point = place(self, node);
                self.cloth.position.set(node, self.units.point(point).to_vec());
            }
        }
    }

    /// Gives every free particle a random velocity, m/s.
    pub(crate) fn kick(&mut self, largest: f64) {
        for node in Grid::<S, W, H>::nodes() {
            if !self.cloth.is_pinned(node) {
                let velocity = self.random_vector(largest);
                self.cloth.velocity.set(node, Vec3::from_f64(self.units.velocity(velocity).0));
            }
        }
    }

    /// A particle's position, m.
    pub(crate) fn at(&self, node: Node) -> [f64; 3] {
        self.cloth.position.at(node).to_f64().map(|cells| cells * self.units.cell)
    }

    pub(crate) fn gravity(&mut self, acceleration: [f64; 3]) {
        self.scene.forces.0 = Gravity::new(self.units.acceleration(acceleration));
    }

    pub(crate) fn drag(&mut self, rate: f64) {
        self.scene.forces.1 = Drag::new(self.units.drag(rate));
    }

    /// Lets a pin move by `way` in the next frame, m.
    pub(crate) fn carry(&mut self, node: Node, way: [f64; 3]) {
        let target = self.cloth.position.at(node) + self.units.point(way).to_vec();
        self.scene.move_pin(&mut self.cloth, node, target);
    }

    /// The largest strain of a stretch link.
    pub(crate) fn strain(&self) -> f64 {
        measure::strain(&self.cloth, &self.scene.links.0).largest.to_f64()
    }

    /// The largest speed of a particle along an axis, m/s.
    pub(crate) fn speed(&self) -> f64 {
        largest(self.cloth.velocity.values()) * self.units.cell / self.units.tick()
    }

    /// The largest coordinate of a particle, m.
    pub(crate) fn reach(&self) -> f64 {
        largest(self.cloth.position.values()) * self.units.cell
    }
}

/// The largest absolute component; infinite if one is undefined.
fn largest<S: Scalar>(vectors: impl Iterator<Item = Vec3<S>>) -> f64 {
    let components = vectors.flat_map(Vec3::to_f64).map(f64::abs);
    components.fold(0.0, |largest, x| if x.is_nan() { f64::INFINITY } else { x.max(largest) })
}
