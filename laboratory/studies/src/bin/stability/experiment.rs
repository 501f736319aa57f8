//! One run: a sheet that is held at two corners or in its centre, let go from a state that no solver likes.

use instances::simulation;
use kerchief::host::{Description, Everything, ScalarKind, SolverKind, Wind, WindModel};

const GRAVITY: f64 = 9.81;
const DENSITY: f64 = 0.2;
const SIZE: f64 = 1.0;
/// How far a sheet may go, sizes.
const FURTHEST: f64 = 10.0;

/// The largest grid that all programs have in every number type, and the largest of all, which is here in floats alone.
const LARGE: usize = 64;
pub(crate) const LARGEST: usize = 128;

/// How a sheet begins.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pose {
    /// Upright, held at its upper corners.
    Hung,
    /// Flat, held at two corners.
    Laid,
    /// Flat, held in its centre.
    Centre,
}

/// A square sheet of 1 m and 0.2 kg/m².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Experiment {
    pub(crate) pose: Pose,
    /// Particles a side.
    pub(crate) side: usize,
    /// Of stretch springs, N/m; shear springs have a tenth, bend springs a hundredth.
    pub(crate) stiffness: f64,
    /// Mass of a border particle over that of another.
    pub(crate) hem: f64,
    /// Of aerodynamic wind across the sheet, m/s.
    pub(crate) wind: f64,
    /// Of the whole sheet, 1/s.
    pub(crate) drag: f64,
    /// A frame, s.
    pub(crate) frame: f64,
    pub(crate) substeps: u32,
}

pub(crate) const USUAL: Experiment = Experiment {
    pose: Pose::Hung,
    side: 8,
    stiffness: 1e3,
    hem: 1.0,
    wind: 0.0,
    drag: 0.1,
    frame: 1.0 / 60.0,
    substeps: 1,
};

/// What came of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// The number type does not hold a value.
    NotHeld,
    /// It takes too long.
    NotComputed,
    /// A number of the state was not finite, or the sheet left.
    Gone,
    Held {
        /// The largest strain of a stretch link at the end of a frame.
        strain: f64,
        /// By how much the energy exceeded that of the start, weights of the sheet times its size; undefined where the number type holds springs for rigid.
        energy: f64,
    },
}

impl Experiment {
    /// The mass of an inner particle, kg.
    pub(crate) fn mass(&self) -> f64 {
        DENSITY * SIZE * SIZE / (self.side * self.side) as f64
    }

    /// The highest angular frequency of its springs, 1/s: neighbours that move against each other along a row stretch two links each by twice
    /// their way, ω² = 4·k/m, and so do the diagonals, `ω² = 4·k_shear/m`.
    pub(crate) fn frequency(&self) -> f64 {
        (4.0 * 1.1 * self.stiffness / (self.mass() * self.hem.min(1.0))).sqrt()
    }

    /// At which rate wind takes a particle along, 1/s: the derivative of its force by the velocity, 2·½·ρ·c·A·v.
    pub(crate) fn wind_rate(&self) -> f64 {
        let area = SIZE * SIZE / ((self.side - 1) * (self.side - 1)) as f64;
        AIR * PLATE * area * self.wind / self.mass()
    }

    /// Runs it for so many frames.
    pub(crate) fn run(&self, solver: SolverKind, scalar: ScalarKind, frames: u32) -> Result<Outcome, String> {
        let scene = self.scene(solver)?;
        let moving = match (self.side, scalar) {
            _ if !self.is_affordable(solver) => return Ok(Outcome::NotComputed),
            (LARGEST, ScalarKind::F32) => scene.simulation_on::<Everything, f32, LARGEST, LARGEST>(),
            (LARGEST, _) => return Ok(Outcome::NotComputed),
            _ => simulation(&scene, scalar),
        };
        let Ok(mut moving) = moving else { return Ok(Outcome::NotHeld) };
        let mut state = moving.state();
        // displaced by up to a twentieth of a cell, without any symmetry
        let amount = 0.05 * SIZE / (self.side - 1) as f64;
        for (k, (position, pinned)) in state.still.positions.iter_mut().zip(&state.pinned).enumerate() {
            if !pinned {
                let wave = |a: f64, b: f64| (a * k as f64 + b).sin();
                let by = [wave(1.1, 0.2), wave(2.3, 1.0), wave(3.7, 0.5)];
                *position = core::array::from_fn(|axis| position[axis] + amount * by[axis]);
            }
        }
        moving.restore(&state);
        let weight = DENSITY * SIZE * SIZE * GRAVITY * SIZE;
        // in fixed point it comes back from the other end of the range
        let range = if matches!(scalar, ScalarKind::F32 | ScalarKind::F64) { f64::INFINITY } else { 100.0 };
        let gone = SIZE * f64::min(FURTHEST, range / (self.side - 1) as f64);
        let start = moving.energy();
        let (mut strain, mut energy) = (0.0_f64, 0.0_f64);
        for _ in 0..frames {
            moving.frame();
            let reach = moving.still().positions.into_iter().flatten().fold(0.0, |a: f64, x| a.max(x.abs()));
            let now = moving.strains().stretch.map_or(f64::NAN, |strain| strain.largest);
            if !(moving.is_finite() && reach < gone && now.is_finite()) {
                return Ok(Outcome::Gone);
            }
            strain = strain.max(now);
            let gain = (moving.energy() - start) / weight;
            // of rigid springs in fixed point it is undefined
            energy = if energy.is_nan() || !gain.is_finite() { f64::NAN } else { energy.max(gain) };
        }
        Ok(Outcome::Held { strain, energy })
    }

    /// Whether it is computed: large grids by the line solver alone, the largest in one pose.
    fn is_affordable(&self, solver: SolverKind) -> bool {
        let most = match solver {
            SolverKind::Lines if self.pose == Pose::Laid => LARGEST,
            SolverKind::Lines => LARGE,
            SolverKind::BackwardEuler => 16,
            _ => 32,
        };
        self.side <= most
    }

    fn scene(&self, solver: SolverKind) -> Result<Description, String> {
        let Self { pose, side, stiffness, hem, drag, frame, substeps, .. } = *self;
        let mass = self.mass();
        let (shear, bend) = (0.1 * stiffness, 0.01 * stiffness);
        let half = 0.5 * SIZE;
        let (lie, origin) = match pose {
            Pose::Hung => ("hang", [-half, 0.0, half]),
            Pose::Laid | Pose::Centre => ("lay", [-half, -half, 0.0]),
        };
        // a scene file has no larger one
        let named = side.min(LARGE);
        let text = format!(
            "name = \"stability\"\n\
             [cloth]\ncolumns = {named}\nrows = {named}\nwidth = {SIZE}\nheight = {SIZE}\nmass = {mass}\nhem = {hem}\n\
             pose = \"{lie}\"\norigin = {origin:?}\n\
             [stretch]\nstiffness = {stiffness}\n[shear]\nstiffness = {shear}\n[bend]\nstiffness = {bend}\n\
             [environment]\ngravity = [0.0, 0.0, -{GRAVITY}]\ndrag = {drag}\n\
             [solver]\nkind = \"{}\"\nstep = {frame}\nsubsteps = {substeps}\niterations = {}\n",
            solver.name(),
            if solver == SolverKind::Verlet { 4 } else { 1 },
        );
        let mut scene = Description::parse(&text).map_err(|error| error.to_string())?;
        (scene.sheet.columns, scene.sheet.rows) = (side, side);
        scene.sheet.pins = match pose {
            Pose::Hung | Pose::Laid => vec![[0, 0], [side - 1, 0]],
            Pose::Centre => vec![[side / 2, side / 2]],
        };
        if self.wind > 0.0 {
            let model = WindModel::Aerodynamic { density: AIR, drag_coefficient: PLATE };
            scene.wind = Some(Wind { velocity: [0.0, self.wind, 0.0], model });
        }
        Ok(scene)
    }
}

/// kg/m³, and the drag coefficient of a plate.
const AIR: f64 = 1.2;
const PLATE: f64 = 1.2;

/// What is done, in words.
pub(crate) fn words(frames: u32) -> String {
    format!(
        "A square sheet of {SIZE} m and {DENSITY} kg/m², every particle displaced by up to 5 % of a cell, is let go: for {frames} solver steps where steps differ, for {} \
         sixtieths of a second where substeps do. Unless a map says otherwise it hangs from two corners and has {} × {} particles, stretch springs of {} N/m (shear a tenth, bend a \
         hundredth of that), a drag of {} /s and steps of {:.1} ms. Position Verlet has 4 sweeps, the others their defaults. Strain is the largest of a stretch link at the end of \
         any frame; the gain of energy is the largest over that of the start, in weights of the sheet times its size; what a solver leaves of strain in nearly rigid springs \
         counts.\n\n\
         *Black*: the sheet is gone, undefined or {FURTHEST} times its size away. *Hatched*: the number type does not hold a value, and the scene is refused; or it holds springs \
         for rigid, which have no energy; or it was not computed. Lines are the limits of theory: h = 2/ω for leapfrog and h = γ/ω² for forward Euler with drag γ, ω² = 4·(k + k_shear)/m; in \
         wind also h = 2/rate with the rate ρ·c·A·v/m at which it takes a particle along: beyond that line wind taken at a step's start would overshoot, were it not bounded.",
        frames.div_ceil(4),
        USUAL.side,
        USUAL.side,
        USUAL.stiffness,
        USUAL.drag,
        1e3 * USUAL.frame / f64::from(USUAL.substeps),
    )
}
