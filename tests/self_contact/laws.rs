//! Laws of self-contact.

use std::mem::size_of;

use kerchief::{
    BackwardEuler, Cloth, Leapfrog, Lines, Node, Q13, Q24, Scalar, SelfContact, Sheet, Solver, Stillness, Stretch,
    Vec3, Verlet, Xpbd, measure,
};

use crate::stage::{Case, Random, Stage, layered};

/// A sheet of `W` × `H` particles in cells of a centimetre.
fn sheet<S: Scalar, const W: usize, const H: usize>(substeps: u32) -> Sheet<S, W, H> {
    Sheet::new([0.01 * (W - 1) as f64, 0.01 * (H - 1) as f64], 1e-3, 0.01, substeps)
}

#[test]
fn six_bytes_a_particle() {
    fn more<S: Scalar, const W: usize, const H: usize>() {
        type Of<V, S, const W: usize, const H: usize> = <V as Solver<S>>::Memory<Stretch<S>, W, H>;
        let layered = size_of::<Of<SelfContact<S, Lines>, S, W, H>>();
        let plain = size_of::<Of<Lines, S, W, H>>();
        assert!(layered - plain <= 6 * W * H + 24, "{} of {W} x {H} in {}", layered - plain, S::NAME);
    }
    more::<f32, 8, 8>();
    more::<f64, 16, 16>();
    more::<Q13, 33, 17>();
}

/// A sheet that never comes near itself moves to the same bits as without self-contact.
#[test]
fn where_nothing_meets_no_bit_changes() {
    fn law<S: Scalar, V: Solver<S> + Copy>(solver: V, substeps: u32) {
        let mut plain = Stage::<S, _, 12, 9>::new(Case::Twist, substeps, |_| solver);
        let mut layered = Stage::<S, _, 12, 9>::new(Case::Twist, substeps, layered(solver));
        for _ in 0..20 {
            plain.step();
            layered.step();
            let who = (S::NAME, std::any::type_name::<V>());
            assert_eq!(
                measure::digest(&plain.cloth),
                measure::digest(&layered.cloth),
                "{who:?}, {}",
                layered.memory.contacts()
            );
        }
    }
    law::<f32, _>(Lines::new(), 8);
    law::<Q24, _>(Lines::new(), 8);
    law::<Q13, _>(Xpbd, 8);
    law::<f32, _>(Verlet { sweeps: 3 }, 8);
    law::<f32, _>(BackwardEuler { newton_steps: 1 }, 8);
    law::<f64, _>(Leapfrog, 64);
    law::<Q24, _>(Leapfrog, 64);
}

/// Throws two layers of particles without links at each other; `look` sees the start and every frame.
fn thrown<S: Scalar, V: Solver<S>>(solver: V, friction: f64, mut look: impl FnMut(&Sheet<S, 8, 11>, &Cloth<S, 8, 11>)) {
    let sheet = sheet::<S, 8, 11>(8);
    let mut cloth = sheet.lay([0.0; 3]);
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    for row in 0..11 {
        for column in 0..8 {
            let node = Node::new(column, row);
            // the rows from 6 on lie above the first rows, shifted a little sideways
            let (x, y, z, up) = if row < 6 {
                (0.01 * column as f64, 0.01 * row as f64, 0.0, 1.0)
            } else {
                (0.01 * column as f64 + 0.003, 0.01 * (10 - row) as f64 + 0.004, 0.025, -1.0)
            };
            cloth.position.set(node, sheet.place([x, y, z + 0.001 * random.next()]));
            let velocity = [0.2 * random.next() - 0.1 * up, 0.1 * random.next(), 0.5 * up];
            cloth.velocity.set(node, Vec3::from_f64(sheet.units.velocity(velocity).0));
        }
    }
    let scene = sheet.scene((), (), (), sheet.self_contact(0.01, friction, solver));
    let mut memory = scene.memory();
    let mut met = 0;
    look(&sheet, &cloth);
    for _ in 0..20 {
        scene.step(&mut cloth, &mut memory);
        met = met.max(memory.contacts());
        look(&sheet, &cloth);
    }
    assert!(met > 10, "{met} pairs in contact");
}

#[test]
fn momentum_is_kept_to_the_bit_in_fixed_point() {
    fn law<S: Scalar, V: Solver<S>>(solver: V) {
        let mut start = None;
        thrown(solver, 0.4, |_, cloth: &Cloth<S, 8, 11>| {
            let sum = cloth.velocity.values().fold(Vec3::ZERO, |sum, v| sum + v);
            assert_eq!(sum, *start.get_or_insert(sum), "in {}", S::NAME);
        });
    }
    law::<Q24, _>(Xpbd);
    law::<Q13, _>(Xpbd);
    law::<Q13, _>(Verlet { sweeps: 2 });
    law::<Q24, _>(Leapfrog);
}

#[test]
fn layers_thrown_at_each_other_gain_no_energy() {
    fn law<S: Scalar, V: Solver<S>>(solver: V, friction: f64) {
        let mut before = f64::INFINITY;
        let (mut first, mut last) = (None, 0.0);
        thrown(solver, friction, |sheet, cloth: &Cloth<S, 8, 11>| {
            let energy = measure::kinetic_energy(cloth, &sheet.units);
            // the line solver's velocity history may return a little energy
            assert!(energy <= before * 1.03, "{energy} J after {before} J in {}", S::NAME);
            assert!(energy <= *first.get_or_insert(energy), "{energy} J in {}", S::NAME);
            (before, last) = (energy, energy);
        });
        assert!(last < 0.9 * first.unwrap(), "nothing was stopped");
    }
    for friction in [0.0, 0.4] {
        law::<f32, _>(Xpbd, friction);
        law::<Q24, _>(Xpbd, friction);
        law::<Q13, _>(Lines::new(), friction);
        law::<f64, _>(Lines::new(), friction);
        law::<f32, _>(Leapfrog, friction);
    }
}

/// No sheet intersects itself: with pins, hems, oblong cells, as a chain, by all solvers stable for any step.
#[test]
fn every_kind_of_sheet_keeps_apart() {
    fn drop<S: Scalar, V: Solver<S>, const W: usize, const H: usize>(
        size: [f64; 2],
        thickness: f64,
        hem: f64,
        solver: V,
    ) {
        let sheet = Sheet::<S, W, H>::new(size, 1e-4, 1.0 / 60.0, 16);
        let mut cloth = sheet.hang([-0.5 * size[0], 0.0, size[1] + 0.02]);
        if hem != 1.0 {
            cloth.hem(S::from_f64(hem));
        }
        cloth.pin(Node::new(0, H - 1));
        let mut random = Random(0x9e37_79b9_7f4a_7c15);
        for row in 0..H - 1 {
            for column in 0..W {
                let velocity = sheet.units.velocity([0.05 * random.next(), 0.2 * random.next(), 0.0]).0;
                cloth.velocity.set(Node::new(column, row), Vec3::from_f64(velocity));
            }
        }
        let forces = (sheet.gravity([0.0, 0.0, -9.81]), sheet.drag(3.0));
        let links = (sheet.stretch(100.0), sheet.shear(10.0), sheet.bend(0.1));
        let ground = sheet.plane([0.0; 3], [0.0, 0.0, 1.0], 0.01);
        let scene = sheet.scene(forces, links, ground, sheet.self_contact(thickness, 0.3, solver));
        let mut memory = scene.memory();
        let mut met = 0;
        for _ in 0..180 {
            scene.step(&mut cloth, &mut memory);
            met = met.max(memory.contacts());
        }
        assert!(met > 0, "no contact: {W} x {H} in {}", S::NAME);
        let intersections = measure::intersections(&cloth);
        assert_eq!(intersections, 0, "{W} x {H} in {}", S::NAME);
    }
    drop::<f32, _, 12, 12>([0.3, 0.3], 0.3 / 11.0, 1.5, Lines::new());
    drop::<Q24, _, 12, 12>([0.3, 0.3], 0.3 / 11.0, 0.5, Xpbd);
    drop::<Q13, _, 9, 14>([0.2, 0.26], 0.025, 1.0, Lines::new());
    drop::<f32, _, 5, 12>([0.07, 0.25], 0.25 / 11.0, 1.0, Xpbd);
    drop::<f64, _, 1, 24>([0.0, 0.4], 0.4 / 23.0, 1.0, Lines::new());
    drop::<f32, _, 3, 16>([0.05, 0.375], 0.02, 1.0, Lines::new());
    drop::<f32, _, 10, 10>([0.3, 0.3], 0.3 / 9.0, 1.0, BackwardEuler { newton_steps: 2 });
    drop::<f32, _, 10, 10>([0.3, 0.3], 0.3 / 9.0, 1.0, Verlet { sweeps: 2 });
}

/// Sheets whose layers start pushed through each other stay bounded and slow.
#[test]
fn tangled_starts_stay_bounded() {
    fn law<S: Scalar, V: Solver<S>>(solver: V, seed: u64) -> f64 {
        let sheet = Sheet::<S, 12, 12>::new([0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
        let mut cloth = sheet.hang([-0.15, 0.0, 0.4]);
        let mut random = Random(seed);
        for row in 0..12 {
            for column in 0..12 {
                let place = [0.15 * random.next(), 0.05 * random.next(), 0.4 + 0.15 * random.next()];
                cloth.position.set(Node::new(column, row), sheet.place(place));
            }
        }
        let forces = (sheet.gravity([0.0, 0.0, -9.81]), sheet.drag(2.0));
        let links = (sheet.stretch(100.0), sheet.shear(10.0));
        let ground = sheet.plane([0.0; 3], [0.0, 0.0, 1.0], 0.01);
        let scene = sheet.scene(forces, links, ground, sheet.self_contact(0.3 / 11.0, 0.3, solver));
        let mut memory = scene.memory();
        for frame in 0..180 {
            scene.step(&mut cloth, &mut memory);
            let far = cloth.position.largest().to_f64() * sheet.units.cell;
            assert!(measure::is_finite(&cloth) && far < 1.5, "{far} m in frame {frame}, in {}", S::NAME);
        }
        let speed = cloth.velocity.largest().to_f64() * sheet.units.cell / sheet.units.tick();
        // a tangle whose rows act on each other goes on trembling
        assert!(speed < 2.0, "{speed} m/s at the end in {}", S::NAME);
        speed
    }
    let mut mean = 0.0;
    for seed in [1, 0x2545_f491_4f6c_dd1d, 0x9e37_79b9_7f4a_7c15] {
        mean += law::<f32, _>(Lines::new(), seed) / 12.0;
        mean += law::<Q24, _>(Lines::new(), seed) / 12.0;
        mean += law::<f32, _>(Xpbd, seed) / 12.0;
        mean += law::<Q13, _>(Xpbd, seed) / 12.0;
    }
    assert!(mean < 1.0, "{mean} m/s at the end on average");
}

/// `Resting` around `SelfContact`: a heap comes to rest, keeps its bits, and wakes when a particle is pushed.
#[test]
fn a_heap_comes_to_rest() {
    fn law<S: Scalar>() {
        let solver = |sheet: &Sheet<S, 12, 12>| sheet.resting(Stillness::DEFAULT, layered(Xpbd)(sheet));
        let mut stage = Stage::<S, _, 12, 12>::new(Case::Heap, 16, solver);
        stage.scene.forces.1 = stage.sheet.drag(4.0);
        (0..900).for_each(|_| stage.step());
        assert!(stage.memory.is_at_rest(), "awake in {}", S::NAME);
        let lies = measure::digest(&stage.cloth);
        (0..10).for_each(|_| stage.step());
        assert_eq!(measure::digest(&stage.cloth), lies, "in {}", S::NAME);
        stage.cloth.velocity.set(Node::new(3, 3), Vec3::from_f64([0.0, 0.0, 0.5]));
        stage.step();
        assert!(!stage.memory.is_at_rest() && measure::digest(&stage.cloth) != lies, "asleep in {}", S::NAME);
    }
    law::<f32>();
    law::<Q24>();
    law::<Q13>();
}

/// A sheet that falls in a heap gains no energy.
#[test]
fn a_heap_gains_no_energy() {
    fn law<S: Scalar, V: Solver<S> + Copy>(solver: V) {
        let mut stage = Stage::<S, _, 12, 12>::new(Case::Heap, 16, layered(solver));
        let mut least = stage.energy();
        for frame in 0..200 {
            stage.step();
            let energy = stage.energy();
            // 0.2 kg that fall by a metre set 2 J free
            assert!(energy < least + 0.01, "{energy} J after {least} J in frame {frame}, in {}", S::NAME);
            least = least.min(energy);
        }
    }
    law::<f32, _>(Lines::new());
    law::<Q24, _>(Lines::new());
    law::<f32, _>(Xpbd);
}
