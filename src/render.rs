//! Drawing a sheet on any `embedded-graphics` display.

pub mod camera;
pub mod canvas;
mod fill;
pub mod ground;
pub mod light;
pub mod pattern;
pub mod shaded;
pub mod shadow;
pub mod solid;
mod surface;
pub mod tone;
pub mod view;
pub mod wireframe;

pub use camera::Camera;
pub use canvas::{Canvas, Dirty};
pub use ground::{Backdrop, Ground};
pub use light::Light;
pub use pattern::Pattern;
pub use shaded::{Look, Shaded};
pub use shadow::Shadow;
pub use solid::{Ball, Rod, Solids};
pub use tone::{Shade, Toned};
pub use view::View;
pub use wireframe::Wireframe;
