//! Simulations that contain only the parts of their scene, as a user's own program would.

use instances::simulation;
use kerchief::host::{Bare, Counted, Description, Everything, ScalarKind, SceneError, Simulation};
use kerchief::{Q13, Q24, Scalar};

type Moving = Result<Box<dyn Simulation>, SceneError>;

/// Starts a scene. A scene that needs further parts or another grid gets a simulation with all parts.
pub(crate) fn moving(scene: &Description, scalar: ScalarKind) -> Moving {
    let lean = match scalar {
        ScalarKind::F32 => on_grid::<f32>(scene),
        ScalarKind::F64 => on_grid::<f64>(scene),
        ScalarKind::Q24 => on_grid::<Q24>(scene),
        ScalarKind::Q13 => on_grid::<Q13>(scene),
    };
    lean.unwrap_or_else(|| simulation(scene, scalar))
}

/// The same in `f32` with counted operations; `None` for other grids.
pub(crate) fn counted(scene: &Description) -> Option<Moving> {
    let large = || (sides(scene) == (32, 32)).then(|| scene.simulation_on::<Everything, Counted, 32, 32>());
    on_grid::<Counted>(scene).or_else(large)
}

/// The grids for which lean simulations are compiled; each adds to the build time.
fn on_grid<S: Scalar + Send>(scene: &Description) -> Option<Moving> {
    let damped = [scene.stretch, scene.shear, scene.bend].into_iter().flatten().any(|spring| spring.damping != 0.0);
    let met = !scene.spheres.is_empty() || !scene.planes.is_empty() || !scene.capsules.is_empty();
    match sides(scene) {
        _ if damped || met || scene.wind.is_some() => None,
        (16, 16) => Some(scene.simulation_on::<Bare, S, 16, 16>()),
        (32, 32) => Some(scene.simulation_on::<Bare, S, 32, 32>()),
        _ => None,
    }
}

const fn sides(scene: &Description) -> (usize, usize) {
    (scene.sheet.columns, scene.sheet.rows)
}
