//! Scenes in which a sheet of a metre touches itself.

use kerchief::scene::Only;
use kerchief::{
    AerodynamicWind, Bend, Cloth, Drag, Gravity, Grid, Node, Plane, Scalar, Scene, SelfContact, Shear, Sheet, Solver,
    Sphere, Stretch, measure,
};

/// m
const SIZE: f64 = 1.0;
/// kg
const MASS: f64 = 0.2;
/// s
const FRAME: f64 = 1.0 / 60.0;
/// m
const GROUND: f64 = -0.6;

/// A way to bring the sheet into contact with itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Case {
    /// Hung up, disturbed a little, and dropped on the ground.
    Heap,
    /// Dropped on a ball.
    Drape,
    /// Pinned at a pole, in gusty wind that turns.
    Flag,
    /// Pinned at pegs that move together in a zigzag until the curtain is 40 % as wide.
    Curtain,
    /// Laid on the ground. One edge is carried over to the other in an arc and let go.
    Fold,
    /// Pinned between two rods. The lower one makes half a turn and comes nearer.
    Twist,
}

impl Case {
    pub(crate) const ALL: [Self; 6] = [Self::Heap, Self::Drape, Self::Flag, Self::Curtain, Self::Fold, Self::Twist];
}

type Forces<S> = (Gravity<S>, Drag<S>, Option<AerodynamicWind<S>>);
type Links<S> = (Stretch<S>, Shear<S>, Bend<S>);
type Obstacles<S> = (Plane<S>, Option<Sphere<S>>);

pub(crate) struct Stage<S: Scalar, V: Solver<S>, const W: usize, const H: usize> {
    case: Case,
    pub(crate) sheet: Sheet<S, W, H>,
    pub(crate) scene: Scene<Forces<S>, Links<S>, Obstacles<S>, V, Only<S, W, H>>,
    pub(crate) cloth: Cloth<S, W, H>,
    pub(crate) memory: V::Memory<Links<S>, W, H>,
    frame: u32,
}

impl<S: Scalar, V: Solver<S>, const W: usize, const H: usize> Stage<S, V, W, H> {
    pub(crate) fn new(case: Case, substeps: u32, solver: impl FnOnce(&Sheet<S, W, H>) -> V) -> Self {
        let cell = SIZE / (W.max(H) - 1) as f64;
        let [width, height] = [W, H].map(|count| cell * (count - 1) as f64);
        let sheet = Sheet::<S, W, H>::new([width, height], MASS / (W * H) as f64, FRAME, substeps);
        let low = GROUND + 0.6 * cell;
        let (mut cloth, pins) = match case {
            Case::Heap => (sheet.hang([-0.5, 0.0, GROUND + 1.2]), vec![]),
            Case::Drape => (sheet.lay([-0.45, -0.53, 0.4]), vec![]),
            Case::Flag => (sheet.hang([-0.5, 0.0, 0.5]), (0..H).map(|row| Node::new(0, row)).collect()),
            Case::Curtain => (sheet.hang([-0.5, 0.0, 0.5]), pegs::<W>().map(|column| Node::new(column, 0)).collect()),
            Case::Fold => (sheet.lay([-0.5, -0.5, low]), (0..W).map(|column| Node::new(column, H - 1)).collect()),
            Case::Twist => {
                let rods = [0, H - 1].into_iter().flat_map(|row| (0..W).map(move |column| Node::new(column, row)));
                (sheet.hang([-0.5, 0.0, 0.5]), rods.collect())
            }
        };
        pins.into_iter().for_each(|node| cloth.pin(node));
        if case == Case::Heap {
            let mut random = Random(0x9e37_79b9_7f4a_7c15);
            for node in Grid::<S, W, H>::nodes() {
                let velocity = [0.02 * random.next(), 0.1 * random.next(), 0.0];
                cloth.velocity.set(node, kerchief::Vec3::from_f64(sheet.units.velocity(velocity).0));
            }
        }
        let forces = (sheet.gravity([0.0, 0.0, -9.81]), sheet.drag(1.0), None);
        let links = (sheet.stretch(1000.0), sheet.shear(100.0), sheet.bend(1.0));
        let ground = sheet.plane([0.0, 0.0, GROUND], [0.0, 0.0, 1.0], 0.5 * cell).with_friction(0.3);
        let ball = (case == Case::Drape).then(|| sheet.ball([0.0; 3], 0.25, 0.5 * cell).with_friction(0.3));
        let scene = sheet.scene(forces, links, (ground, ball), solver(&sheet));
        let memory = scene.memory();
        Self { case, sheet, scene, cloth, memory, frame: 0 }
    }

    /// The longer side of a cell, m.
    pub(crate) fn cell(&self) -> f64 {
        self.sheet.units.cell
    }

    pub(crate) fn step(&mut self) {
        self.direct(f64::from(self.frame) * FRAME);
        self.scene.step(&mut self.cloth, &mut self.memory);
        self.frame += 1;
    }

    /// Moves the pins and sets the wind for this time (s).
    fn direct(&mut self, time: f64) {
        let (cell, height) = (self.cell(), self.cell() * (H - 1) as f64);
        let at = |column: usize| -0.5 * SIZE + cell * column as f64;
        match self.case {
            Case::Heap | Case::Drape => {}
            Case::Flag => {
                let gust = 1.0 + 0.5 * (1.3 * time).sin() + 0.4 * (3.1 * time).sin();
                let velocity = [6.0 * gust, 3.0 * (0.7 * time).sin(), 0.5];
                self.scene.forces.2 = Some(self.sheet.aerodynamic_wind(velocity, 1.2, 1.0));
            }
            Case::Curtain => {
                let (narrower, apart) = (1.0 - 0.6 * (time / 3.0).min(1.0), 1.3 * cell * (time / 2.0).min(1.0));
                for (index, column) in pegs::<W>().enumerate() {
                    let y = if index % 2 == 0 { apart } else { -apart };
                    self.carry(Node::new(column, 0), [-0.5 * SIZE + narrower * cell * column as f64, y, 0.5]);
                }
            }
            Case::Fold => {
                let [middle, arm] = [-0.5 * SIZE + 0.5 * height, 0.5 * height];
                let angle = time.min(3.0);
                let place = [middle + arm * angle.cos(), GROUND + 1.7 * cell + arm * angle.sin()];
                for column in 0..W {
                    let node = Node::new(column, H - 1);
                    if time < 3.1 {
                        self.carry(node, [at(column), place[0], place[1]]);
                    } else if self.cloth.is_pinned(node) {
                        self.cloth.release(node, S::ONE);
                    }
                }
            }
            Case::Twist => {
                let part = (time / 4.0).min(1.0);
                let (angle, z) = (std::f64::consts::PI * part, 0.5 - height * (0.97 - 0.45 * part));
                for column in 0..W {
                    let x = at(column);
                    self.carry(Node::new(column, H - 1), [x * angle.cos(), x * angle.sin(), z]);
                }
            }
        }
    }

    fn carry(&mut self, node: Node, metres: [f64; 3]) {
        let target = self.sheet.place(metres);
        self.scene.move_pin(&mut self.cloth, node, target);
    }

    pub(crate) fn strain(&self) -> f64 {
        measure::strain(&self.cloth, &self.scene.links.0).largest.to_f64()
    }

    pub(crate) fn energy(&self) -> f64 {
        let units = &self.sheet.units;
        measure::kinetic_energy(&self.cloth, units)
            + measure::gravitational_energy(&self.cloth, units, [0.0, 0.0, -9.81])
            + measure::elastic_energy(&self.cloth, units, &self.scene.links)
    }
}

/// Columns of the pegs: every third and the last one, but none next to the last.
fn pegs<const W: usize>() -> impl Iterator<Item = usize> {
    (0..W).filter(|column| column % 3 == 0 && column + 2 < W || column + 1 == W)
}

/// Self-contact around `solver`, for a sheet as thick as a cell.
pub(crate) fn layered<S: Scalar, V, const W: usize, const H: usize>(
    solver: V,
) -> impl FnOnce(&Sheet<S, W, H>) -> SelfContact<S, V> {
    move |sheet| sheet.self_contact(sheet.units.cell, 0.3, solver)
}

/// Pseudorandom numbers from −1 to 1 (G. Marsaglia, *Xorshift RNGs*, 2003).
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn next(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
