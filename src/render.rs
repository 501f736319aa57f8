//! Drawing a sheet on any `embedded-graphics` display.

pub mod camera;
pub mod view;

pub use camera::Camera;
pub use view::View;
