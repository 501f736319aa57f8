//! Drawing a sheet on any `embedded-graphics` display.

pub mod camera;
pub mod tone;
pub mod view;
pub mod wireframe;

pub use camera::Camera;
pub use tone::{Shade, Toned};
pub use view::View;
pub use wireframe::Wireframe;
