//! The distance of fixed point from f64, and the trembling of a sheet at rest.

use kerchief::{
    BackwardEuler, Bend, Cloth, Drag, Gravity, Lines, Node, Q13, Q24, Scalar, Scene, Shear, Solver, Stretch, Units,
    Vec3, Verlet, Xpbd,
};

const SIDE: usize = 16;

/// The sheet on which number types are tested: light, 30 cm, hanging upright.
#[derive(Clone, Copy, Debug)]
struct Sheet {
    /// Its position, m. Floats are the more precise the nearer a coordinate is to zero; fixed point is equally precise everywhere.
    origin: [f64; 3],
    pins: &'static [usize],
    /// The initial velocity, from the front, cells per tick.
    speed: f64,
    /// 1/s
    drag: f64,
    substeps: u32,
}

impl Sheet {
    /// Runs for `frames` of 1/60 s, then shows `seen` the positions (cells) after each further frame until it returns true.
    fn run<S: Scalar, V: Solver<S>>(&self, solver: V, frames: u32, mut seen: impl FnMut(&[[f64; 3]]) -> bool) {
        let units = Units::sheet([SIDE, SIDE], [0.3, 0.3], 1e-3, 1.0 / 60.0, self.substeps);
        let mut cloth = Cloth::<S, SIDE, SIDE>::hang(&units, units.point(self.origin));
        cloth.velocity.change(|_| Vec3::from_f64([0.0, self.speed, 0.0]));
        for &column in self.pins {
            cloth.pin(Node::new(column, 0));
        }
        let forces = (Gravity::new(units.acceleration([0.0, 0.0, -9.81])), Drag::new(units.drag(self.drag)));
        let links = (
            Stretch::new(&units, units.compliance(1e-4)),
            Shear::new(&units, units.compliance(1e-2)),
            Bend::new(&units, units.compliance(1e-1)),
        );
        let scene = Scene::new(&units, forces, links, (), solver);
        let mut memory = scene.memory::<S, SIDE, SIDE>();
        (0..frames).for_each(|_| scene.step(&mut cloth, &mut memory));
        loop {
            let places: Vec<_> = cloth.position.values().map(Vec3::to_f64).collect();
            if seen(&places) {
                break;
            }
            scene.step(&mut cloth, &mut memory);
        }
    }

    fn after_ten_seconds<S: Scalar, V: Solver<S>>(&self, solver: V) -> Vec<[f64; 3]> {
        let mut end = Vec::new();
        self.run::<S, V>(solver, 600, |places| {
            end = places.to_vec();
            true
        });
        end
    }
}

/// The largest distance between corresponding particles, sheet sizes.
fn distance(a: &[[f64; 3]], b: &[[f64; 3]]) -> f64 {
    let apart = |(p, q): (&[f64; 3], &[f64; 3])| (0..3).map(|k| (p[k] - q[k]).powi(2)).sum::<f64>().sqrt();
    a.iter().zip(b).map(apart).fold(0.0, f64::max) / (SIDE - 1) as f64
}

/// A sheet on two corners with an initial velocity, damped by drag.
const DAMPED: Sheet = Sheet { origin: [0.0; 3], pins: &[0, SIDE - 1], speed: 0.05, drag: 2.0, substeps: 1 };

/// A position away from the origin: 5, 10 and 15 cells from the coordinate planes.
const ELSEWHERE: [f64; 3] = [0.1, 0.2, 0.3];

/// Asserts distances from `f64`: at the origin of `Q24` (`accurate`), `Q13` (`fast`) and `f32` (4e-6). Elsewhere that of `Q24` must be within the same bound, and at most
/// `against_f32` times that of `f32`.
fn ten_seconds<V: Solver<f64> + Solver<f32> + Solver<Q24> + Solver<Q13> + Copy>(
    solver: V,
    substeps: u32,
    [accurate, fast]: [f64; 2],
    against_f32: f64,
) {
    let sheet = Sheet { substeps, ..DAMPED };
    let exact = sheet.after_ten_seconds::<f64, _>(solver);
    let floating = (sheet.after_ten_seconds::<f32, _>(solver), "f32", 4e-6);
    let fixed = [
        (sheet.after_ten_seconds::<Q24, _>(solver), "q24", accurate),
        (sheet.after_ten_seconds::<Q13, _>(solver), "q13", fast),
    ];
    for (found, name, most) in [floating].into_iter().chain(fixed) {
        let found = distance(&found, &exact);
        println!("{substeps} substeps in {name}: {found:.1e} sheet sizes");
        assert!(found <= most, "{substeps} substeps: {found:e} sheet sizes from f64 in {name}");
    }
    let sheet = Sheet { origin: ELSEWHERE, ..sheet };
    let exact = sheet.after_ten_seconds::<f64, _>(solver);
    let floating = distance(&sheet.after_ten_seconds::<f32, _>(solver), &exact);
    let fixed = distance(&sheet.after_ten_seconds::<Q24, _>(solver), &exact);
    println!("{substeps} substeps elsewhere: {floating:.1e} in f32, {fixed:.1e} in q24");
    assert!(
        fixed <= accurate && fixed <= against_f32 * floating,
        "{substeps} substeps: {fixed:e}, {floating:e} in f32"
    );
}

#[test]
fn after_ten_seconds_fixed_point_is_where_f64_is() {
    ten_seconds(Xpbd, 8, [2e-6, 2e-5], 1.2);
    ten_seconds(Xpbd, 32, [1e-5, 8e-5], 1.2);
    ten_seconds(Xpbd, 128, [8e-5, 5e-4], 4.0);
    ten_seconds(Verlet { sweeps: 8 }, 1, [1e-6, 2e-5], 1.2);
    ten_seconds(Lines::with_sweeps(1), 1, [6e-6, 8e-5], 1.2);
    ten_seconds(Lines::with_sweeps(2), 4, [6e-6, 8e-5], 1.2);
}

/// The substeps over which a sheet at rest is observed.
const STEPS: u32 = 10_000;

/// The motion in [`STEPS`] substeps of a sheet that has hung for 30 s.
struct Rest {
    /// The largest displacement of a particle along each axis, cells.
    furthest: [f64; 3],
    /// The largest displacement of a particle's mean position, along any axis, from the first tenth of the substeps to the last, cells.
    drift: f64,
}

fn at_rest<S: Scalar, V: Solver<S>>(solver: V, substeps: u32) -> Rest {
    let pins = &[0, SIDE - 1];
    let mut start = Vec::new();
    let mut furthest = [0.0_f64; 3];
    let mut sums = [[[0.0_f64; 3]; SIDE * SIDE]; 2];
    let (all, mut frames) = (STEPS / substeps, 0);
    Sheet { origin: [0.0; 3], pins, speed: 0.0, drag: 5.0, substeps }.run::<S, V>(solver, 1800, |places| {
        if start.is_empty() {
            start = places.to_vec();
        }
        for (place, start) in places.iter().zip(&start) {
            for axis in 0..3 {
                furthest[axis] = furthest[axis].max((place[axis] - start[axis]).abs());
            }
        }
        for (sum, counts) in sums.iter_mut().zip([frames < all / 10, frames >= all - all / 10]) {
            for (sum, place) in sum.iter_mut().zip(places).filter(|_| counts) {
                (0..3).for_each(|axis| sum[axis] += place[axis]);
            }
        }
        frames += 1;
        frames == all
    });
    let [first, last] = sums;
    let apart = first.iter().flatten().zip(last.iter().flatten()).map(|(a, b)| (a - b).abs());
    Rest { furthest, drift: apart.fold(0.0, f64::max) / f64::from(all / 10) }
}

#[test]
fn a_sheet_at_rest_trembles_by_a_few_last_places_and_neither_creeps_nor_drifts() {
    // a last place of an edge in q13 is 2⁻¹³ cells
    let [q24, q13] = [Q24::RESOLUTION, 1.0 / 8192.0];
    for (solver, Rest { furthest, drift }, place, most) in [
        ("xpbd, q24", at_rest::<Q24, _>(Xpbd, 8), q24, 10.0),
        ("verlet, q24", at_rest::<Q24, _>(Verlet { sweeps: 8 }, 1), q24, 10.0),
        ("lines, q24", at_rest::<Q24, _>(Lines::with_sweeps(1), 1), q24, 20.0),
        ("xpbd, q13", at_rest::<Q13, _>(Xpbd, 8), q13, 2.0),
        ("verlet, q13", at_rest::<Q13, _>(Verlet { sweeps: 8 }, 1), q13, 2.0),
        ("lines, q13", at_rest::<Q13, _>(Lines::with_sweeps(1), 1), q13, 8.0),
    ] {
        let [x, y, z] = furthest.map(|way| way / place);
        let drift = drift / place;
        println!("{solver}: {x:.1}, {y:.1}, {z:.1} last places, the mean {drift:.2}");
        assert!(y == 0.0, "{solver} leaves its plane by {y} last places");
        assert!(x <= most && z <= most, "{solver} moves by {x} and {z} last places");
        assert!(drift <= 0.5, "{solver} drifts by {drift} last places");
    }
}

/// The positions after ten frames by backward Euler of a sheet of a metre with this stiffness (N/m) and hem, m.
fn stiff<S: Scalar>(stiffness: f64, hem: f64) -> Vec<[f64; 3]> {
    let units = Units::sheet([8, 8], [1.0; 2], 2e-3, 1.0 / 60.0, 1);
    let mut cloth = Cloth::<S, 8, 8>::hang(&units, units.point([-0.5, 0.0, 0.5]));
    cloth.hem(S::from_f64(hem));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(7, 0));
    let links = (
        Stretch::new(&units, units.stiffness(stiffness)),
        Shear::new(&units, units.stiffness(0.1 * stiffness)),
        Bend::new(&units, units.stiffness(10.0)),
    );
    let forces = (Gravity::new(units.acceleration([0.0, 2.0, -9.81])), Drag::new(units.drag(1.0)));
    let scene = Scene::new(&units, forces, links, (), BackwardEuler { newton_steps: 1 });
    let mut memory = scene.memory();
    (0..10).for_each(|_| scene.step(&mut cloth, &mut memory));
    cloth.position.values().map(|x| x.to_f64().map(|cells| cells * units.cell)).collect()
}

/// Beside a stiff spring inertia is a small number, which was once rounded to nothing: sheets drifted, and some flew away. The inertia of a heavy hem may exceed the range.
#[test]
fn backward_euler_has_digits_of_inertia_and_room_for_it() {
    for (stiffness, hem, most) in [(1e3, 1.0, 3e-5), (1e4, 1.0, 2e-4), (1e5, 1.0, 2e-4), (1.0, 100.0, 1e-4)] {
        let exact = stiff::<f64>(stiffness, hem);
        for (found, name) in [(stiff::<Q24>(stiffness, hem), "q24"), (stiff::<Q13>(stiffness, hem), "q13")] {
            let error = distance(&found, &exact) * (SIDE - 1) as f64;
            assert!(error < most, "{stiffness:e} N/m, hem {hem}: {error:e} m from f64 in {name}");
        }
    }
}
