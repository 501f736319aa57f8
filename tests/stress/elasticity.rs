//! Super-elasticity: the strain of the thesis' sheets in motion, beyond the strain of their springs in the exact solution.

use kerchief::host::Counted;
use kerchief::{
    Bend, Cloth, Drag, FacetWind, Gravity, Leapfrog, Lines, Links, Node, Scalar, Scene, Shear, Solver, Sphere,
    StrainLimited, Stretch, Units, Verlet, measure,
};

use crate::is_long;

const SIDE: usize = 32;
const FRAME: f64 = 0.1;
/// Frames until the sheets hang down.
const FRAMES: u32 = 50;

/// A scene of the thesis.
#[derive(Clone, Copy, Debug)]
enum Thesis {
    Gravity,
    Sphere,
    Wind,
    NoShear,
}

/// The measurements of a run.
#[derive(Clone, Copy, Debug)]
struct Motion {
    /// The largest strain of a stretch link at the end of any frame.
    strain: f64,
    /// Operations per particle and frame.
    operations: f64,
}

impl Thesis {
    fn pins(self) -> Vec<[usize; 2]> {
        let last = SIDE - 1;
        match self {
            Self::Gravity | Self::NoShear => vec![[0, 0], [last, 0], [0, last]],
            Self::Sphere => vec![[0, 0], [last, 0]],
            Self::Wind => (0..SIDE).map(|row| [0, row]).collect(),
        }
    }

    fn play<S: Scalar, V: Solver<S>>(self, solver: V, substeps: u32, limit: Option<f64>) -> Motion {
        let units = Units::sheet([SIDE; 2], [10.0; 2], 1.0, FRAME, substeps);
        let stretch = Stretch::new(&units, units.stiffness(94_270.0));
        match limit {
            None => self.play_with(stretch, solver, &units),
            Some(limit) => self.play_with(StrainLimited::new(stretch, limit), solver, &units),
        }
    }

    fn play_with<S: Scalar, L: Links<S>, V: Solver<S>>(self, stretch: L, solver: V, units: &Units) -> Motion {
        let mut cloth = Cloth::<S, SIDE, SIDE>::lay(units, units.point([-5.0, -5.0, 0.0]));
        self.pins().into_iter().for_each(|[column, row]| cloth.pin(Node::new(column, row)));
        let wind = matches!(self, Self::Wind).then(|| FacetWind::new(units.facet_wind([5.0, 0.0, -3.0])));
        let gravity = Gravity::new(units.acceleration([0.0, 0.0, -9.81]));
        let forces = (gravity, Drag::new(units.verlet_damping(0.1)), wind);
        let shear = Shear::new(units, units.stiffness(9427.0));
        let links =
            (stretch, (!matches!(self, Self::NoShear)).then_some(shear), Bend::new(units, units.stiffness(942.7)));
        let ball: heapless::Vec<_, 1> =
            [Sphere::new(units.point([-1.0, -1.0, -7.0]), units.length(2.0), units.length(0.59))]
                .into_iter()
                .filter(|_| matches!(self, Self::Sphere | Self::NoShear))
                .collect();
        let scene = Scene::new(units, forces, links, ball, solver);
        let mut memory = scene.memory();
        let mut strain = 0.0_f64;
        let mut operations = 0;
        for _ in 0..FRAMES {
            Counted::reset();
            scene.step(&mut cloth, &mut memory);
            operations += Counted::operations().total();
            strain = strain.max(measure::strain(&cloth, &scene.links.0).largest.to_f64());
        }
        Motion { strain, operations: operations as f64 / f64::from(FRAMES) / (SIDE * SIDE) as f64 }
    }
}

/// The bounds for a scene.
struct Goal {
    scene: Thesis,
    /// The strain of the springs in the exact solution: by leapfrog with 2048 substeps, which the long version (`KERCHIEF_LONG=1`) measures.
    springs: f64,
    /// Substeps, tolerance and strain limit with which the line solver adds a strain of at most 0.1, and their cost in frames of the thesis' method
    /// with its 15 sweeps.
    substeps: u32,
    tolerance: f64,
    limit: Option<f64>,
    cost: f64,
}

/// With a tolerance of 1 every substep has one sweep.
const GOALS: [Goal; 4] = [
    Goal { scene: Thesis::Gravity, springs: 0.2537, substeps: 5, tolerance: 1.0, limit: Some(0.34), cost: 0.8 },
    Goal { scene: Thesis::Sphere, springs: 0.1459, substeps: 5, tolerance: 1.0, limit: Some(0.24), cost: 0.8 },
    Goal { scene: Thesis::Wind, springs: 0.0179, substeps: 1, tolerance: 0.15, limit: None, cost: 0.33 },
    Goal { scene: Thesis::NoShear, springs: 0.1681, substeps: 6, tolerance: 1.0, limit: Some(0.26), cost: 1.2 },
];

#[test]
fn the_thesis_scenes_are_not_super_elastic() {
    let lines = Lines::with_sweeps(2);
    for Goal { scene, springs, substeps, tolerance, limit, cost } in GOALS {
        let usual = scene.play::<f32, _>(lines, 8, None);
        assert!(usual.strain < springs + 0.01, "{scene:?} with 8 substeps: {usual:?}");
        let thesis = scene.play::<Counted, _>(Verlet { sweeps: 15 }, 1, None);
        assert!(thesis.strain > springs + 0.3, "{scene:?} by the method of the thesis: {thesis:?}");
        let cheap = scene.play::<Counted, _>(Lines::with_sweeps(1).within(tolerance), substeps, limit);
        println!("{scene:?}: springs {springs}, 15 sweeps {thesis:.3?}, line solver {cheap:.3?}");
        assert!(cheap.strain < springs + 0.1, "{scene:?} with {substeps} substeps: {cheap:?}");
        assert!(cheap.operations < cost * thesis.operations, "{scene:?}: {cheap:?} against {thesis:?}");
        if is_long() {
            let exact = scene.play::<f64, _>(Leapfrog, 2048, None);
            assert!((exact.strain - springs).abs() < 5e-4, "{scene:?} by leapfrog: {exact:?}");
            let fine = scene.play::<f32, _>(lines, 64, None);
            // the sheet that falls on the ball has its largest strain for a moment during the impact
            let near = if matches!(scene, Thesis::Sphere) { 0.01 } else { 5e-4 };
            assert!((fine.strain - springs).abs() < near, "{scene:?} with 64 substeps: {fine:?}");
        }
    }
}
