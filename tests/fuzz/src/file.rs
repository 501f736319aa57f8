//! Scene files of any bytes: each is refused in a line or moves, twice the same.

use kerchief::host::{Description, ScalarKind, SceneError, Simulation};

/// How a scene is set up.
pub type Simulate = fn(&Description, ScalarKind) -> Result<Box<dyn Simulation>, SceneError>;

/// What a scene may cost: solver steps of a frame, particles.
const STEPS: u32 = 64;
const PARTICLES: usize = 64;

/// Reads a file and plays the scene that it describes in every number type that holds it.
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
