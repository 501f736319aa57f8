//! Rest freezes a sheet where it has settled, and changes nothing before.

use kerchief::{Scalar, Solver, measure};

use crate::{SIDE, Springs, Trial, UNITS, curtain, every_solver, resting, settle};

/// Frames of a minute.
const MINUTE: u32 = 3600;

struct KeepsItsBits;

impl Trial for KeepsItsBits {
    fn with<S: Scalar, V: Solver<S> + Copy>(&self, name: &str, solver: V)
    where
        V::Memory<Springs<S>, SIDE, SIDE>: Clone,
    {
        let (scene, mut cloth) = curtain::<S, _>(resting(solver));
        let mut memory = scene.memory();
        let (alone, mut twin) = curtain::<S, _>(solver);
        let mut twin_memory = alone.memory();
        let start = measure::kinetic_energy(&cloth, &UNITS);
        let frames = settle(&scene, &mut cloth, &mut memory, MINUTE);
        let frames = frames.unwrap_or_else(|| panic!("{name} in {} never rests", S::NAME));
        for _ in 0..frames {
            alone.step_one(&mut twin, &mut twin_memory);
        }
        let digest = measure::digest(&cloth);
        assert_eq!(digest, measure::digest(&twin), "{name} in {}: rest changed the motion before", S::NAME);
        assert!(measure::kinetic_energy(&cloth, &UNITS) < 1e-4 * start, "{name} in {}: rests too early", S::NAME);
        for _ in 0..100 {
            scene.step_one(&mut cloth, &mut memory);
            assert!(memory.is_at_rest() && measure::digest(&cloth) == digest, "{name} in {} moves", S::NAME);
        }
        // the sheet had settled: without rest it moves by less than 1 mm in a further quarter of a minute
        for _ in 0..MINUTE / 4 {
            alone.step_one(&mut twin, &mut twin_memory);
        }
        let apart = cloth.position.values().zip(twin.position.values()).map(|(a, b)| (a - b).length().to_f64());
        let apart = apart.fold(0.0, f64::max) * UNITS.cell;
        assert!(apart < 1e-3, "{name} in {}: frozen {apart} m from where it hangs", S::NAME);
    }
}

#[test]
fn a_settled_sheet_keeps_its_bits() {
    every_solver(&KeepsItsBits);
}
