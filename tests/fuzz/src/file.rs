//! Scene files of arbitrary bytes. Each is refused with a message of one line, or plays twice with the same digest.

use kerchief::host::{Description, ScalarKind, SceneError, Simulation};

/// The function that sets up a scene in a number type.
pub type Simulate = fn(&Description, ScalarKind) -> Result<Box<dyn Simulation>, SceneError>;

/// Upper bounds of the scenes that are played: solver steps of a frame, and particles.
const STEPS: u32 = 64;
const PARTICLES: usize = 64;

/// Reads a file and plays its scene in every number type that can represent it.
pub fn play(bytes: &[u8], simulation: Simulate) {
    let Ok(text) = core::str::from_utf8(bytes) else { return };
    let scene = match Description::parse(text) {
        Ok(scene) => scene,
        Err(error) => {
            assert!(!error.to_string().contains(char::is_control), "{error:?}");
            return;
        }
    };
    let solver = scene.solver;
    let sweeps = solver.iterations.saturating_mul(2).max(solver.sweeps.unwrap_or(1));
    if scene.sheet.columns * scene.sheet.rows > PARTICLES || solver.substeps.saturating_mul(sweeps) > STEPS {
        return;
    }
    for scalar in ScalarKind::ALL {
        let digest = || {
            let mut simulation = simulation(&scene, scalar).ok()?;
            (0..3).for_each(|_| simulation.frame());
            Some(simulation.digest())
        };
        assert_eq!(digest(), digest(), "in {}", scalar.name());
    }
}
