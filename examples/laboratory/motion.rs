//! Scenes in motion, put together from no more parts than they name: what a program of one's own would run.

use kerchief::Q24;
use kerchief::host::{Basics, Counted, Description, ScalarKind, SceneError, Simulation, WindModel};

type Moving = Result<Box<dyn Simulation>, SceneError>;

/// The grids for which this is compiled; it takes a while for each.
macro_rules! on_grid {
    ($scene:ident, $scalar:ty) => {
        match ($scene.sheet.columns, $scene.sheet.rows) {
            (8, 8) => Some($scene.simulation_on::<Basics, $scalar, 8, 8>()),
            (16, 16) => Some($scene.simulation_on::<Basics, $scalar, 16, 16>()),
            (32, 32) => Some($scene.simulation_on::<Basics, $scalar, 32, 32>()),
            _ => None,
        }
    };
}

/// Sets a scene in motion; one that needs more parts, or another grid, with all parts there are.
pub(crate) fn moving(scene: &Description, scalar: ScalarKind) -> Moving {
    let lean = match scalar {
        _ if !is_basic(scene) => None,
        ScalarKind::F32 => on_grid!(scene, f32),
        ScalarKind::F64 => on_grid!(scene, f64),
        ScalarKind::Q24 => on_grid!(scene, Q24),
    };
    lean.unwrap_or_else(|| scene.simulation(scalar))
}

/// The same in `f32`, with its operations counted; nothing for other grids and parts.
pub(crate) fn counted(scene: &Description) -> Option<Moving> {
    if is_basic(scene) { on_grid!(scene, Counted) } else { None }
}

fn is_basic(scene: &Description) -> bool {
    let damped = [scene.stretch, scene.shear, scene.bend].into_iter().flatten().any(|spring| spring.damping != 0.0);
    let follows = scene.wind.is_some_and(|wind| wind.model != WindModel::Facet);
    !damped && !follows
}
