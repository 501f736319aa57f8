//! The grid shapes of the host program.

/// Calls the macro `$then` with every supported shape, so that there is one list: columns, rows, and the number of faces along a side of a
/// cell in pictures.
#[doc(hidden)]
#[macro_export]
macro_rules! for_each_shape {
    ($then:ident) => {
        $then! {
            (1, 32, 1) (4, 4, 24) (8, 8, 16) (12, 12, 12) (16, 16, 10) (24, 24, 8) (32, 32, 6) (48, 48, 4) (64, 64, 3)
            (24, 16, 8) (48, 32, 4)
        }
    };
}

#[cfg(feature = "graphics")]
pub(super) use for_each_shape;

macro_rules! list {
    ($(($columns:literal, $rows:literal, $faces:literal))*) => {
        /// Every grid a scene file may ask for, as `(columns, rows)`.
        pub const SHAPES: &[(usize, usize)] = &[$(($columns, $rows)),*];
    };
}
for_each_shape!(list);
