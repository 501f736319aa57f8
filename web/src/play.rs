//! A sheet in motion, of any number type, solver and grid.

use kerchief::scene::Only;
use kerchief::solver::Physics;
use kerchief::{
    BackwardEuler, Cloth, ForwardEuler, Grid, Leapfrog, Lines, Moment, Node, Particles, Scalar, Scene, Sheet, Solver,
    Units, Vec3, Verlet, Xpbd, measure,
};

use crate::likeness::{Fate, Likeness, Shown};
use crate::parts::{self, Forces, Links, Obstacles, Refusal};
use crate::settings::{self, FRAME, SIZE, Settings, Start};

/// The largest displacement of a carried pin in a frame, m.
const STRIDE: f64 = 0.03;

/// A sheet in motion.
pub trait Moving {
    /// Moves on by one frame, unless the sheet has exploded.
    fn frame(&mut self) -> Fate;
    /// Takes over the settings that may change while the sheet moves: stiffness, damping, drag, wind, gravity, ball.
    ///
    /// # Errors
    /// If the number type does not represent one of them. Then nothing has changed.
    fn change(&mut self, settings: &Settings) -> Result<(), Refusal>;
    /// Pins a particle at its position, or releases it.
    fn hold(&mut self, node: Node, held: bool);
    /// Whether a particle is pinned.
    fn is_held(&self, node: Node) -> bool;
    /// The hand grabs a particle.
    fn grab(&mut self, node: Node);
    /// Drags the grabbed particle to a point, m. A pin is carried there.
    fn drag(&mut self, place: [f64; 3]);
    /// Releases the grabbed particle.
    fn release(&mut self);
    /// The digest of the last frame before an explosion: see [`measure::digest`].
    fn digest(&self) -> u32;
    /// Its measures and pictures.
    fn shown(&self) -> &dyn Shown;
}

/// A sheet of `N × N` particles, drawn with `FACES × FACES` faces a cell, at its start.
///
/// # Errors
/// If the number type does not represent a constant.
pub fn start<S: Scalar, const N: usize, const FACES: usize>(settings: &Settings) -> Result<Box<dyn Moving>, Refusal> {
    let sheet = Sheet::<S, N, N>::of(&settings.material(), [SIZE; 2], FRAME, settings.substeps);
    let mut cloth = Box::new(lie(&sheet, settings.start));
    cloth.share_area();
    let unpinned = Box::new(cloth.inverse_mass);
    for node in pins::<N>(settings.start) {
        cloth.pin(node);
    }
    let (gravity, drag, wind) = parts::weather(&sheet, settings)?;
    let world = World {
        forces: (gravity, drag, wind, parts::hand(&sheet, settings)),
        links: parts::links(&sheet, settings)?,
        obstacles: (parts::ball(&sheet, settings), parts::floor(&sheet)),
    };
    let sweeps = settings.sweeps;
    let player = match settings.solver {
        settings::Solver::Lines => world.played(&sheet, Lines::with_sweeps(sweeps)),
        settings::Solver::Xpbd => world.played(&sheet, Xpbd::new()),
        settings::Solver::Leapfrog => world.played(&sheet, Leapfrog::new()),
        settings::Solver::BackwardEuler => world.played(&sheet, BackwardEuler { newton_steps: sweeps }),
        settings::Solver::Verlet => world.played(&sheet, Verlet { sweeps }),
        settings::Solver::ForwardEuler => world.played(&sheet, ForwardEuler::new()),
    };
    let likeness = Likeness::new(settings, settings.substeps, &cloth);
    let digest = measure::digest(&cloth);
    let before = cloth.clone();
    Ok(Box::new(Running::<S, N, FACES> { sheet, cloth, before, unpinned, player, likeness, digest }))
}

/// The sheet at its start, without pins.
fn lie<S: Scalar, const N: usize>(sheet: &Sheet<S, N, N>, start: Start) -> Cloth<S, N, N> {
    let half = 0.5 * SIZE;
    match start {
        Start::Corners => sheet.lay([-half, -half, SIZE + 0.05]),
        Start::Curtain | Start::Flag => sheet.hang([-half, 0.0, SIZE + 0.05]),
        Start::Ball => sheet.lay([-half, -half, 0.45]),
    }
}

/// Particles that are pinned at the start.
fn pins<const N: usize>(start: Start) -> impl Iterator<Item = Node> {
    Grid::<(), N, N>::nodes().filter(move |node| match start {
        Start::Corners => node.row == 0 && (node.column == 0 || node.column + 1 == N),
        Start::Curtain => node.row == 0,
        Start::Flag => node.column == 0,
        Start::Ball => false,
    })
}

/// Forces, links and colliders of a sheet.
struct World<S: Scalar> {
    forces: Forces<S>,
    links: Links<S>,
    obstacles: Obstacles<S>,
}

impl<S: Scalar> World<S> {
    fn played<V, const N: usize>(self, sheet: &Sheet<S, N, N>, solver: V) -> Box<dyn Player<S, N>>
    where
        V: Solver<S> + 'static,
        V::Memory<Links<S>, N, N>: 'static,
    {
        let scene = sheet.scene(self.forces, self.links, self.obstacles, solver);
        let memory = scene.memory();
        Box::new(Played { scene, memory })
    }
}

/// A scene and its solver's memory, for any solver.
trait Player<S: Scalar, const N: usize> {
    fn play(&mut self, cloth: &mut Cloth<S, N, N>);
    /// Moves a pin to a point during the next frame.
    fn carry(&self, cloth: &mut Cloth<S, N, N>, pin: Node, place: Vec3<S>);
    /// Plays a frame's substeps one by one, as long as `goes_on` returns true for their particles.
    fn replay(&self, cloth: &mut Cloth<S, N, N>, units: &Units, goes_on: &mut dyn FnMut(&Particles<S, N, N>) -> bool);
    fn parts(&mut self) -> (&mut Forces<S>, &mut Links<S>, &mut Obstacles<S>);
}

struct Played<S: Scalar, V: Solver<S>, const N: usize> {
    scene: Scene<Forces<S>, Links<S>, Obstacles<S>, V, Only<S, N, N>>,
    memory: V::Memory<Links<S>, N, N>,
}

impl<S: Scalar, V: Solver<S>, const N: usize> Player<S, N> for Played<S, V, N> {
    fn play(&mut self, cloth: &mut Cloth<S, N, N>) {
        self.scene.step(cloth, &mut self.memory);
    }

    fn carry(&self, cloth: &mut Cloth<S, N, N>, pin: Node, place: Vec3<S>) {
        self.scene.move_pin(cloth, pin, place);
    }

    fn replay(&self, cloth: &mut Cloth<S, N, N>, units: &Units, goes_on: &mut dyn FnMut(&Particles<S, N, N>) -> bool) {
        let Scene { forces, links, colliders, solver, .. } = &self.scene;
        let mut memory = solver.memory();
        let substeps = units.substeps;
        let end = Moment { substep: substeps, substeps, shift: units.shift(), halves: 2 };
        for substep in 1..=substeps {
            solver.substep(Physics { forces, links, colliders }, cloth, &mut memory, Moment { substep, ..end });
            if !goes_on(cloth) {
                return;
            }
        }
    }

    fn parts(&mut self) -> (&mut Forces<S>, &mut Links<S>, &mut Obstacles<S>) {
        let Scene { forces, links, colliders, .. } = &mut self.scene;
        (forces, links, colliders)
    }
}

/// A sheet of one number type and grid.
struct Running<S: Scalar, const N: usize, const FACES: usize> {
    sheet: Sheet<S, N, N>,
    cloth: Box<Cloth<S, N, N>>,
    /// The sheet before the last frame.
    before: Box<Cloth<S, N, N>>,
    /// Inverse masses of the sheet without pins.
    unpinned: Box<Grid<S, N, N>>,
    player: Box<dyn Player<S, N>>,
    likeness: Likeness<N, FACES>,
    digest: u32,
}

impl<S: Scalar, const N: usize, const FACES: usize> Running<S, N, FACES> {
    /// Carries a grabbed pin: forces do not move pins.
    fn carry(&mut self) {
        let stride = self.sheet.units.length(STRIDE);
        if let Some((pin, place)) = self.player.parts().0.3.carried(&self.cloth, stride) {
            self.player.carry(&mut self.cloth, pin, place);
        }
    }
}

impl<S: Scalar, const N: usize, const FACES: usize> Moving for Running<S, N, FACES> {
    fn frame(&mut self) -> Fate {
        if self.likeness.fate() == Fate::Moving {
            self.carry();
            *self.before = *self.cloth;
            self.player.play(&mut self.cloth);
            if self.likeness.follow(&self.cloth) == Fate::Moving {
                self.digest = measure::digest(&self.cloth);
            } else {
                // Shows the last substep before the explosion.
                let Self { sheet, before, player, likeness, .. } = self;
                player.replay(before, &sheet.units, &mut |particles| likeness.approach(particles));
            }
        }
        self.likeness.fate()
    }

    fn change(&mut self, settings: &Settings) -> Result<(), Refusal> {
        let links = parts::links(&self.sheet, settings)?;
        let (gravity, drag, wind) = parts::weather(&self.sheet, settings)?;
        let (forces, held, obstacles) = self.player.parts();
        (forces.0, forces.1, forces.2) = (gravity, drag, wind);
        *held = links;
        obstacles.0 = parts::ball(&self.sheet, settings);
        self.likeness.change(settings);
        Ok(())
    }

    fn hold(&mut self, node: Node, held: bool) {
        if held {
            self.cloth.pin(node);
        } else {
            self.cloth.release(node, self.unpinned[node]);
        }
        self.likeness.hold(node, self.cloth.inverse_mass[node].to_f64());
    }

    fn is_held(&self, node: Node) -> bool {
        self.cloth.is_pinned(node)
    }

    fn grab(&mut self, node: Node) {
        self.player.parts().0.3.grab(&self.cloth, node);
    }

    fn drag(&mut self, place: [f64; 3]) {
        // Within the range of fixed point.
        let place = place.map(|metres| metres.clamp(-2.0 * SIZE, 2.0 * SIZE));
        self.player.parts().0.3.drag_to(self.sheet.place(place));
    }

    fn release(&mut self) {
        if let Some(pin) = self.player.parts().0.3.drop().filter(|&node| self.cloth.is_pinned(node)) {
            // The pin stays where it is.
            self.cloth.pin(pin);
        }
    }

    fn digest(&self) -> u32 {
        self.digest
    }

    fn shown(&self) -> &dyn Shown {
        &self.likeness
    }
}
