//! One physical sheet on many grids.

use image::{RgbImage, imageops};
use instances::simulation;
use kerchief::Units;
use kerchief::host::{Description, ScalarKind, SolverKind, Still};
use kerchief::material::{JACKET, Material};

use laboratory::reference::{Frames, mean_square, rms};

/// The side of the sheet, m, and the time of a frame, s.
const SIZE: f64 = 1.0;
pub(crate) const STEP: f64 = 0.02;
/// The angle between neighbouring cells at which bend springs are as stiff as the fabric, rad.
const FOLD: f64 = 0.5;
/// Leapfrog's steps as a part of the time that a wave takes across a cell, a·√(density/C); leapfrog is stable up to 0.87.
const STABLE: f64 = 0.5;
/// The time over which motions are compared, s.
const MOTION: f64 = 0.5;

/// A square sheet pinned along its border, which sags by its weight. It is taut everywhere, so that no wrinkles form: they would differ
/// between grids.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Awning {
    pub(crate) material: Material,
    /// Drag, 1/s.
    pub(crate) drag: f64,
    pub(crate) solver: SolverKind,
    pub(crate) substeps: u32,
    pub(crate) sweeps: u32,
    /// The time until it is at rest, s.
    pub(crate) seconds: f64,
}

impl Default for Awning {
    fn default() -> Self {
        Self { material: JACKET, drag: 10.0, solver: SolverKind::Lines, substeps: 8, sweeps: 2, seconds: 3.0 }
    }
}

/// The result of a run.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) side: usize,
    /// Height of the border above the middle, m.
    pub(crate) sag: f64,
    /// The largest strain of a stretch link at rest.
    pub(crate) strain: f64,
    pub(crate) still: Still,
    /// Positions during the motion.
    motion: Frames,
}

impl Awning {
    /// The scene on a grid.
    pub(crate) fn scene(&self, side: usize) -> Result<Description, String> {
        let last = side - 1;
        let border =
            (0..side * side).map(|i| [i % side, i / side]).filter(|node| node.iter().any(|k| [0, last].contains(k)));
        let pins: Vec<_> = border.map(|[column, row]| format!("[{column}, {row}]")).collect();
        let units: Units = self.material.units([side, side], [SIZE, SIZE], STEP, self.substeps);
        let springs = self.material.springs(&units, FOLD);
        let text = format!(
            "name = \"awning\"\n\
             [cloth]\ncolumns = {side}\nrows = {side}\nwidth = {SIZE}\nheight = {SIZE}\ndensity = {}\npins = [{}]\n\
             [stretch]\nstiffness = {}\n[shear]\nstiffness = {}\n[bend]\nstiffness = {}\n\
             [environment]\ngravity = [0.0, 0.0, -9.81]\ndrag = {}\n\
             [solver]\nkind = \"{}\"\nstep = {STEP}\nsubsteps = {}\niterations = {}\n\
             [picture]\npattern = \"gingham\"\nbands = 7\nelevation = 15.0\nazimuth = 25.0\n",
            self.material.density,
            pins.join(", "),
            springs.stretch,
            springs.shear,
            springs.bend,
            self.drag,
            self.solver.name(),
            self.substeps,
            self.sweeps,
        );
        Description::parse(&text).map_err(|error| error.to_string())
    }

    /// The same awning moved by leapfrog. Its steps are so short that it is stable on the finest grid, and that its error in time is far below the error of any grid.
    pub(crate) fn exactly(self, finest: usize) -> Self {
        let Material { density, stretch, .. } = self.material;
        let longest = STABLE * SIZE / (finest - 1) as f64 * (density / stretch).sqrt();
        Self { solver: SolverKind::Leapfrog, substeps: (STEP / longest).ceil() as u32, sweeps: 1, ..self }
    }

    /// Solver and settings in words.
    pub(crate) fn method(&self) -> String {
        let Self { solver, substeps, sweeps, .. } = self;
        format!("Solver: {}, f64, frames of {STEP} s, {substeps} substeps, iterations = {sweeps}.", solver.name())
    }

    /// Runs the awning until it is at rest.
    pub(crate) fn outcome(&self, side: usize) -> Result<Outcome, String> {
        let mut moving = simulation(&self.scene(side)?, ScalarKind::F64).map_err(|error| error.to_string())?;
        let frames = |seconds: f64| (seconds / STEP).round().max(1.0) as u32;
        let mut motion = Frames::new();
        for frame in 0..frames(self.seconds.max(MOTION)) {
            moving.frame();
            if frame < frames(MOTION) {
                motion.push(moving.still().positions);
            }
        }
        if !moving.is_finite() {
            return Err("the sheet blew up".to_string());
        }
        let still = moving.still();
        Ok(Outcome {
            side,
            sag: -at(&still.positions, side, [0.5, 0.5])[2],
            strain: moving.strains().stretch.map_or(0.0, |strain| strain.largest),
            motion,
            still,
        })
    }

    /// A description of the awning and of the distances.
    pub(crate) fn words(&self) -> String {
        let Material { density, stretch, shear, bend, .. } = self.material;
        format!(
            "An awning: a square of {SIZE} m of light jacket cloth (`material::JACKET`: {density} kg/m², C = {stretch} N/m, G = {shear} N/m, \
             B = {bend:.1e} N·m), laid flat and pinned along its border, with a drag of {} /s. Springs and masses follow from the fabric by the laws of \
             `material`; the stiffness of bend springs is exact at folds of {FOLD} rad. Distances are RMS over the particles of the coarser grid, / sheet size; \
             the finer sheet is interpolated (cubically) between its particles. They are given at rest, after {} s, and in motion, over the first {MOTION} s.",
            self.drag, self.seconds
        )
    }
}

impl Outcome {
    /// Distances from a finer sheet at rest and in motion: RMS over this sheet's particles, divided by the sheet's size.
    pub(crate) fn distances(&self, finer: &Self) -> [f64; 2] {
        let place = |index: usize| index as f64 / (self.side - 1) as f64;
        let places: Vec<_> = (0..self.side * self.side).map(|i| [place(i % self.side), place(i / self.side)]).collect();
        let there =
            |still: &Vec<[f64; 3]>| places.iter().map(|&place| at(still, finer.side, place)).collect::<Vec<_>>();
        let rest = mean_square(&self.still.positions, &there(&finer.still.positions)).sqrt();
        let motion: Frames = finer.motion.iter().map(there).collect();
        [rest / SIZE, rms(&self.motion, &motion) / SIZE]
    }

    /// The side of a cell, m.
    pub(crate) fn cell(&self) -> f64 {
        SIZE / (self.side - 1) as f64
    }
}

/// The part of a square picture that shows the sheet.
pub(crate) fn cropped(picture: &RgbImage) -> RgbImage {
    let side = picture.width();
    imageops::crop_imm(picture, 0, side / 5, side, side / 2 - side / 20).to_image()
}

/// A point of the sheet between particles, by cubic interpolation along both sides: linear interpolation would have a larger error than the
/// grid. `place` is in sides of the sheet.
fn at(positions: &[[f64; 3]], side: usize, place: [f64; 2]) -> [f64; 3] {
    let [(column, across), (row, down)] = place.map(|x| {
        let x = x * (side - 1) as f64;
        let first = (x.floor() as usize).saturating_sub(1).min(side - 4);
        (first, cubic(x - first as f64))
    });
    let mut sum = [0.0; 3];
    for (j, down) in down.into_iter().enumerate() {
        for (i, across) in across.into_iter().enumerate() {
            let position = positions[(row + j) * side + column + i];
            sum = core::array::from_fn(|k| sum[k] + across * down * position[k]);
        }
    }
    sum
}

/// Weights of Lagrange interpolation at `x` from values at 0, 1, 2 and 3.
fn cubic(x: f64) -> [f64; 4] {
    core::array::from_fn(|i| {
        let others = (0..4).filter(|j| *j != i).map(|j| (x - f64::from(j as u8)) / (i as f64 - f64::from(j as u8)));
        others.product()
    })
}
