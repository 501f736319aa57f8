//! One physical sheet on many grids.

use kerchief::Units;
use kerchief::host::{Description, ScalarKind, Simulation, Still};
use kerchief::material::{BLANKET, Material};

use crate::laboratory::reference::{Frames, rms};

/// The side of the sheet, m, and the time of a frame, s.
const SIZE: f64 = 1.0;
pub(crate) const STEP: f64 = 0.02;
/// The angle between neighbouring cells at which bend springs are as stiff as the fabric, rad.
const FOLD: f64 = 0.5;
/// How long the motion is compared, s.
const MOTION: f64 = 0.5;
/// The particles a side on which shapes are compared.
const PROBES: usize = 8;

/// A square sheet held along its border, which its weight pulls down from the plane. It is taut everywhere: wrinkles, which every grid would
/// have its own of, cannot form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Awning {
    pub(crate) material: Material,
    /// 1/s
    pub(crate) drag: f64,
    pub(crate) substeps: u32,
    pub(crate) sweeps: u32,
    /// Until it is at rest.
    pub(crate) seconds: f64,
}

impl Default for Awning {
    fn default() -> Self {
        Self { material: BLANKET, drag: 10.0, substeps: 8, sweeps: 2, seconds: 3.0 }
    }
}

/// What became of it.
#[derive(Clone, Debug)]
pub(crate) struct Outcome {
    pub(crate) side: usize,
    /// How far the middle hangs below the border, m.
    pub(crate) sag: f64,
    /// The largest strain of a stretch link at rest.
    pub(crate) strain: f64,
    pub(crate) still: Still,
    /// The probes in motion, and at rest.
    motion: Frames,
    rest: Frames,
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
             [solver]\nkind = \"lines\"\nstep = {STEP}\nsubsteps = {}\niterations = {}\n\
             [picture]\npattern = \"gingham\"\nbands = 7\nelevation = 25.0\nazimuth = 25.0\n",
            self.material.density,
            pins.join(", "),
            springs.stretch,
            springs.shear,
            springs.bend,
            self.drag,
            self.substeps,
            self.sweeps,
        );
        Description::parse(&text).map_err(|error| error.to_string())
    }

    /// Lets it come to rest.
    pub(crate) fn outcome(&self, side: usize) -> Result<Outcome, String> {
        let mut moving = self.scene(side)?.simulation(ScalarKind::F64).map_err(|error| error.to_string())?;
        let probes = |moving: &dyn Simulation| {
            let still = moving.still().positions;
            let place = |probe: usize| probe as f64 / (PROBES - 1) as f64;
            (0..PROBES * PROBES).map(|i| at(&still, side, [place(i % PROBES), place(i / PROBES)])).collect()
        };
        let frames = |seconds: f64| (seconds / STEP).round().max(1.0) as u32;
        let mut motion = Frames::new();
        for frame in 0..frames(self.seconds.max(MOTION)) {
            moving.frame();
            if frame < frames(MOTION) {
                motion.push(probes(&*moving));
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
            rest: vec![probes(&*moving)],
            motion,
            still,
        })
    }

    /// What it is, in a sentence or two.
    pub(crate) fn words(&self) -> String {
        let Material { density, stretch, shear, bend, .. } = self.material;
        format!(
            "An awning: a square of {SIZE} m of blanket fabric (`material::BLANKET`: {density} kg/m², C = {stretch} N/m, G = {shear} N/m, \
             B = {bend:.1e} N·m), laid flat, held along its border, with a drag of {} /s. Springs and masses follow from the fabric by the laws of \
             `material`, with the stiffness of bend springs right at folds of {FOLD} rad. Line solver in f64, {} substeps of a frame of {STEP} s, \
             {} iterations. Distances are RMS over {PROBES} × {PROBES} places of the sheet, / sheet size: at rest after {} s, and in motion over \
             the first {MOTION} s.",
            self.drag, self.substeps, self.sweeps, self.seconds
        )
    }
}

impl Outcome {
    /// How far two sheets are apart at rest, and in motion, over the sheet's size.
    pub(crate) fn distances(&self, other: &Self) -> [f64; 2] {
        [rms(&self.rest, &other.rest) / SIZE, rms(&self.motion, &other.motion) / SIZE]
    }

    /// The side of a cell, m.
    pub(crate) fn cell(&self) -> f64 {
        SIZE / (self.side - 1) as f64
    }
}

/// A place of the sheet between particles, by bilinear interpolation; `place` counts sides of the sheet.
fn at(positions: &[[f64; 3]], side: usize, place: [f64; 2]) -> [f64; 3] {
    let cell = place.map(|x| {
        let x = x * (side - 1) as f64;
        let before = (x.floor() as usize).min(side - 2);
        (before, x - before as f64)
    });
    let [(column, across), (row, down)] = cell;
    core::array::from_fn(|k| {
        let value = |column: usize, row: usize| positions[row * side + column][k];
        let along = |row: usize| (1.0 - across) * value(column, row) + across * value(column + 1, row);
        (1.0 - down) * along(row) + down * along(row + 1)
    })
}
