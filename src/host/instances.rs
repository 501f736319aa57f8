//! Simulations whose number type and grid are chosen at run time.

/// Defines a function that makes a simulation of a scene in a number type and on a grid chosen at run time.
///
/// Every pair of number type and grid is compiled with every solver, in the crate that calls this macro. Each pair takes about a second to compile, so a program
/// lists only those it needs. A scene with another number type or grid is refused with an error that names the key.
///
/// ```
/// use kerchief::host::{Description, ScalarKind};
///
/// kerchief::simulations! {
///     /// Small sheets in two number types.
///     fn simulation;
///     scalars: F32 = f32, Q24 = kerchief::Q24;
///     grids: (4, 4) (8, 8)
/// }
///
/// let scene = "[cloth]\ncolumns = 8\nrows = 8\nwidth = 0.3\nheight = 0.3\ndensity = 0.2\n[stretch]\nstiffness = 100\n";
/// let scene = Description::parse(scene)?;
/// let mut moving = simulation(&scene, ScalarKind::Q24)?;
/// moving.frame();
/// assert!(simulation(&scene, ScalarKind::F64).is_err());
/// # Ok::<(), kerchief::host::SceneError>(())
/// ```
#[macro_export]
macro_rules! simulations {
    (
        $(#[$doc:meta])*
        $visibility:vis fn $name:ident;
        scalars: $($kind:ident = $scalar:ty),+;
        grids: $(($columns:literal, $rows:literal))+
    ) => {
        $(#[$doc])*
        ///
        /// # Errors
        ///
        /// If the number type or the grid is not compiled here, or the number type does not represent a value. The error names the key.
        $visibility fn $name(
            scene: &$crate::host::Description,
            scalar: $crate::host::ScalarKind,
        ) -> ::std::result::Result<::std::boxed::Box<dyn $crate::host::Simulation>, $crate::host::SceneError> {
            fn on_its_grid<S: $crate::Scalar + Send>(
                scene: &$crate::host::Description,
            ) -> ::std::result::Result<::std::boxed::Box<dyn $crate::host::Simulation>, $crate::host::SceneError> {
                match (scene.sheet.columns, scene.sheet.rows) {
                    $(($columns, $rows) => scene.simulation_on::<$crate::host::Everything, S, $columns, $rows>(),)+
                    _ => Err($crate::host::SceneError::new("cloth.columns", "a grid that this program was built without")),
                }
            }
            match scalar {
                $($crate::host::ScalarKind::$kind => on_its_grid::<$scalar>(scene),)+
                #[allow(unreachable_patterns)]
                _ => Err($crate::host::SceneError::new("scalar", "a number type that this program was built without")),
            }
        }
    };
}
