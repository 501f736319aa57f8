//! Scenes in motion, put together from no more parts than they name: what a program of one's own would run.

use kerchief::host::{Bare, Basics, Counted, Description, ScalarKind, SceneError, Simulation, WindModel};
use kerchief::{Q13, Q24, Scalar};

type Moving = Result<Box<dyn Simulation>, SceneError>;

/// Sets a scene in motion; one that needs more parts, or another grid, with all parts there are.
pub(crate) fn moving(scene: &Description, scalar: ScalarKind) -> Moving {
    let lean = match scalar {
        ScalarKind::F32 => on_grid::<f32>(scene),
        ScalarKind::F64 => on_grid::<f64>(scene),
        ScalarKind::Q24 => on_grid::<Q24>(scene),
        ScalarKind::Q13 => on_grid::<Q13>(scene),
    };
    lean.unwrap_or_else(|| scene.simulation(scalar))
}

/// The same in `f32`, with its operations counted; nothing for other grids and parts.
pub(crate) fn counted(scene: &Description) -> Option<Moving> {
    on_grid::<Counted>(scene)
}

/// The sheets that are compiled lean; it takes a while for each.
fn on_grid<S: Scalar + Send>(scene: &Description) -> Option<Moving> {
    let damped = [scene.stretch, scene.shear, scene.bend].into_iter().flatten().any(|spring| spring.damping != 0.0);
    let follows = scene.wind.is_some_and(|wind| wind.model != WindModel::Facet);
    if damped || follows {
        return None;
    }
    let calm = scene.wind.is_none();
    let free = scene.spheres.is_empty() && scene.planes.is_empty() && scene.capsules.is_empty();
    match (scene.sheet.columns, scene.sheet.rows) {
        (16, 16) if calm && free => Some(scene.simulation_on::<Bare, S, 16, 16>()),
        (32, 32) if calm && free => Some(scene.simulation_on::<Bare, S, 32, 32>()),
        (32, 32) => Some(scene.simulation_on::<Basics, S, 32, 32>()),
        _ => None,
    }
}
