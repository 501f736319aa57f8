//! One run: a sheet that is pinned at two corners or in its centre starts with displacements without any symmetry, which challenge every solver.

use instances::simulation;
use kerchief::host::{Description, Everything, ScalarKind, SolverKind, Wind, WindModel};

const GRAVITY: f64 = 9.81;
const DENSITY: f64 = 0.2;
const SIZE: f64 = 1.0;
/// The largest allowed coordinate of a sheet, sizes.
const FURTHEST: f64 = 10.0;

/// The largest grid that is compiled in every number type, and the largest grid of this program, in `f32` only.
const LARGE: usize = 64;
pub(crate) const LARGEST: usize = 128;

/// The start of a sheet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Pose {
    /// Upright, pinned at its upper corners.
    Hung,
    /// Flat, pinned at two corners.
    Laid,
    /// Flat, pinned in its centre.
    Centre,
}

/// A square sheet of 1 m and 0.2 kg/m².
#[derive(Clone, Copy, Debug)]
pub(crate) struct Experiment {
    pub(crate) pose: Pose,
    /// Particles a side.
    pub(crate) side: usize,
    /// Stiffness of stretch springs, N/m; shear springs have a tenth of it, bend springs a hundredth.
    pub(crate) stiffness: f64,
    /// Mass of a border particle divided by the mass of an inner one.
    pub(crate) hem: f64,
    /// Speed of aerodynamic wind across the sheet, m/s.
    pub(crate) wind: f64,
    /// Drag of the whole sheet, 1/s.
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

/// The outcome of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Outcome {
    /// The number type does not represent a value of the scene.
    NotHeld,
    /// The run would take too long.
    NotComputed,
    /// A number of the state was not finite, or the sheet has left the allowed range.
    Gone,
    Held {
        /// The largest strain of a stretch link at the end of a frame.
        strain: f64,
        /// The largest gain of energy since the start, in weights of the sheet times its size; undefined if the number type treats springs as rigid.
        energy: f64,
    },
}

impl Experiment {
    /// The mass of an inner particle, kg.
    pub(crate) fn mass(&self) -> f64 {
        DENSITY * SIZE * SIZE / (self.side * self.side) as f64
    }

    /// The highest angular frequency of the springs, 1/s. Neighbours that move against each other along a row each stretch two links by twice
    /// their displacement: ω² = 4·k/m. So do the diagonals: `ω² = 4·k_shear/m`.
    pub(crate) fn frequency(&self) -> f64 {
        (4.0 * 1.1 * self.stiffness / (self.mass() * self.hem.min(1.0))).sqrt()
    }

    /// The rate at which a particle approaches the wind's velocity, 1/s: the derivative of the wind's force by the velocity, 2·½·ρ·c·A·v, divided by the mass.
    pub(crate) fn wind_rate(&self) -> f64 {
        let area = SIZE * SIZE / ((self.side - 1) * (self.side - 1)) as f64;
        AIR * PLATE * area * self.wind / self.mass()
    }

    /// Runs the experiment for a number of frames.
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
        // Displacements by up to a twentieth of a cell along each axis, without any symmetry.
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
        // In fixed point a sheet that leaves the range reappears at its other end: the limit is inside the range.
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
            // The energy of rigid springs in fixed point is undefined.
            energy = if energy.is_nan() || !gain.is_finite() { f64::NAN } else { energy.max(gain) };
        }
        Ok(Outcome::Held { strain, energy })
    }

    /// Whether the run is computed: only the line solver runs large grids, and the largest one in one pose only.
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
        // A scene file cannot name a larger grid.
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

/// Density of air, kg/m³, and the drag coefficient of a plate.
const AIR: f64 = 1.2;
const PLATE: f64 = 1.2;

/// A description of the experiment and of the maps.
pub(crate) fn words(frames: u32) -> String {
    format!(
        "A square sheet of {SIZE} m and {DENSITY} kg/m² starts with every free particle displaced by up to 5 % of a cell. Maps over the step run {frames} solver steps, maps over \
         substeps {} sixtieths of a second. Unless a map says otherwise, the sheet hangs from two corners. It has {} × {} particles, stretch springs of {} N/m (shear springs a \
         tenth, bend springs a hundredth of that), a drag of {} /s and steps of {:.1} ms. Position Verlet has 4 sweeps, the other solvers their defaults. *Strain* is the largest \
         strain of a stretch link at the end of any frame. *Gain of energy* is the largest increase since the start, in weights of the sheet times its size. It includes the \
         energy of strain that a solver leaves in nearly rigid springs.\n\n\
         *Black*: a number is not finite, or the sheet is {FURTHEST} times its size away. *Hatched*: the number type does not represent a value, and the scene is refused; or \
         the number type treats springs as rigid, so that their energy is undefined; or the run was not computed. Lines are limits of theory: h = 2/ω for leapfrog and h = γ/ω² \
         for forward Euler with drag γ, where ω² = 4·(k + k_shear)/m. In wind there is also the limit h = 2/rate. Here rate = ρ·c·A·v/m is the rate at which a particle approaches \
         the wind's velocity. Beyond this limit, wind that is evaluated at a step's start would overshoot if it were not bounded.",
        frames.div_ceil(4),
        USUAL.side,
        USUAL.side,
        USUAL.stiffness,
        USUAL.drag,
        1e3 * USUAL.frame / f64::from(USUAL.substeps),
    )
}
