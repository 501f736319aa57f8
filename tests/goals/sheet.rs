//! The thesis' sheet, ten times as stiff: 10 m × 10 m, laid flat and let go.

use kerchief::host::Counted;
use kerchief::{
    Bend, Cloth, Drag, FacetWind, Force, Gravity, Leapfrog, Lines, Node, Scalar, Scene, Shear, Solver, Stretch, Units,
    measure,
};

const SIZE: f64 = 10.0;
const FRAME: f64 = 0.1;
/// Substeps of the finer of two reference solutions.
const FINE: u32 = 512;
/// The largest distance of the finer reference solution from the extrapolated limit, sheet sizes. It is an error of second order, which the extrapolation removes.
const CONVERGED: f64 = 1e-5;

/// Where a sheet is pinned.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hold {
    TwoCorners,
    TopEdge,
    LeftEdge,
}

/// A sheet of 16 × 16 or 32 × 32 particles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Sheet {
    pub(crate) side: usize,
    /// The mass of a particle, kg.
    pub(crate) mass: f64,
    pub(crate) hold: Hold,
    /// The wind of the facet model, m/s.
    pub(crate) wind: Option<[f64; 3]>,
    /// The length of the run, frames of 0.1 s.
    pub(crate) frames: usize,
}

/// Positions at the ends of frames, m.
pub(crate) type Frames = Vec<Vec<[f64; 3]>>;

/// The measured counterparts of a goal's bounds.
#[derive(Clone, Copy, Debug)]
#[allow(dead_code, reason = "shown where a goal is missed")]
pub(crate) struct Found {
    pub(crate) error: f64,
    pub(crate) strain: f64,
    pub(crate) operations: f64,
}

/// The result of a run: positions of all frames, the largest strain, and the operations in total.
struct Motion {
    frames: Frames,
    strain: f64,
    operations: u64,
}

impl Sheet {
    /// The reference solution: leapfrog in `f64`, extrapolated from two steps.
    pub(crate) fn reference(&self) -> Frames {
        let [fine, coarse] = [FINE, FINE / 2].map(|substeps| self.moved::<f64, _>(Leapfrog, substeps).frames);
        let limit: Frames = fine.iter().zip(&coarse).map(|(fine, coarse)| extrapolate(fine, coarse)).collect();
        let left = distance(&limit, &fine);
        assert!(left < CONVERGED, "{self:?}: the reference is {left:e} from its limit");
        limit
    }

    /// The line solver in `f32` against the reference solution.
    pub(crate) fn run(&self, substeps: u32, tolerance: f64, reference: &Frames) -> Found {
        let motion = self.moved::<Counted, _>(Lines::with_sweeps(2).within(tolerance), substeps);
        let particle_frames = (self.side * self.side * self.frames) as f64;
        Found {
            error: distance(&motion.frames, reference),
            strain: motion.strain,
            operations: motion.operations as f64 / particle_frames,
        }
    }

    fn moved<S: Scalar, V: Solver<S>>(&self, solver: V, substeps: u32) -> Motion {
        let units = Units::sheet([self.side; 2], [SIZE; 2], self.mass, FRAME, substeps);
        let gravity = Gravity::new(units.acceleration([0.0, 0.0, -9.81]));
        // drag takes a tenth of every velocity in a frame
        let drag = Drag::new(units.drag(-0.9_f64.ln() / FRAME));
        match (self.side, self.wind) {
            (16, None) => self.frames::<S, V, _, 16, 16>(solver, &units, (gravity, drag)),
            (32, None) => self.frames::<S, V, _, 32, 32>(solver, &units, (gravity, drag)),
            (16, Some(wind)) => {
                let wind = FacetWind::new(units.facet_wind(wind));
                self.frames::<S, V, _, 16, 16>(solver, &units, (gravity, drag, wind))
            }
            (32, Some(wind)) => {
                let wind = FacetWind::new(units.facet_wind(wind));
                self.frames::<S, V, _, 32, 32>(solver, &units, (gravity, drag, wind))
            }
            _ => unreachable!("no such sheet in the table"),
        }
    }

    fn frames<S: Scalar, V: Solver<S>, F: Force<S>, const W: usize, const H: usize>(
        &self,
        solver: V,
        units: &Units,
        forces: F,
    ) -> Motion {
        let stretch = Stretch::new(units, units.stiffness(942_700.0));
        let links = (stretch, Shear::new(units, units.stiffness(9_427.0)), Bend::new(units, units.stiffness(942.7)));
        let scene = Scene::new(units, forces, links, (), solver);
        let mut cloth = Cloth::<S, W, H>::lay(units, units.point([0.0; 3]));
        for k in 0..self.side {
            match self.hold {
                Hold::TwoCorners if k != 0 && k != self.side - 1 => {}
                Hold::TwoCorners | Hold::TopEdge => cloth.pin(Node::new(k, 0)),
                Hold::LeftEdge => cloth.pin(Node::new(0, k)),
            }
        }
        let mut memory = scene.memory();
        let mut motion = Motion { frames: Vec::new(), strain: 0.0, operations: 0 };
        for _ in 0..self.frames {
            Counted::reset();
            scene.step(&mut cloth, &mut memory);
            motion.operations += Counted::operations().total();
            motion.strain = motion.strain.max(measure::strain(&cloth, &scene.links.0).largest.to_f64());
            motion.frames.push(cloth.position.values().map(|x| x.to_f64().map(|cells| cells * units.cell)).collect());
        }
        motion
    }
}

fn extrapolate(fine: &[[f64; 3]], coarse: &[[f64; 3]]) -> Vec<[f64; 3]> {
    let particle = |(f, c): (&[f64; 3], &[f64; 3])| core::array::from_fn(|k| (4.0 * f[k] - c[k]) / 3.0);
    fine.iter().zip(coarse).map(particle).collect()
}

/// The RMS distance over particles and frames, over the sheet's size.
fn distance(a: &Frames, b: &Frames) -> f64 {
    let squares =
        a.iter().flatten().zip(b.iter().flatten()).map(|(a, b)| (0..3).map(|k| (a[k] - b[k]).powi(2)).sum::<f64>());
    let count = a.iter().map(Vec::len).sum::<usize>();
    (squares.sum::<f64>() / count as f64).sqrt() / SIZE
}
