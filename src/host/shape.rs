//! The grid shapes of the host program.

/// Calls the macro `$then` with every supported shape, `columns x rows`, so that the list stands in one place.
macro_rules! for_each_shape {
    ($then:ident) => {
        $then! { (1, 32) (4, 4) (8, 8) (12, 12) (16, 16) (24, 24) (32, 32) (48, 48) (64, 64) (24, 16) (48, 32) }
    };
}

pub(super) use for_each_shape;

macro_rules! list {
    ($(($columns:literal, $rows:literal))*) => {
        /// Every grid a scene file may ask for, as `(columns, rows)`.
        pub const SHAPES: &[(usize, usize)] = &[$(($columns, $rows)),*];
    };
}
for_each_shape!(list);
