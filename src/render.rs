//! Drawing a sheet on any `embedded-graphics` display.
//!
//! Pictures are computed in the sheet's own number type, so every board draws the same picture. Drawing allocates no memory, and uses
//! no float routine in fixed point. A [`View`] describes direction, distance and field of view, and can be evaluated at compile time.
//! A [`Camera`] is made from a view at run time. There are two renderers:
//!
//! * [`Wireframe`] draws the links. It needs no memory.
//! * [`Shaded`] draws lit faces, with a [`Pattern`] on each side, [`Solids`] that the sheet lies on or hangs in front of, and a
//!   [`Ground`] with an optional soft [`Shadow`]. It needs 16 bytes per particle, and the shadow's map. Each face has one tone, or
//!   tones are interpolated between particles ([`Gouraud`]).
//!
//! A [`Look`] contains only the parts that it names: for a plain sheet, no code for balls, ground or shadow is linked. A [`Canvas`]
//! sends only the changed part of a picture to the display.
//!
//! Colours are [tones](Shade) of 8 bits per channel until they reach the display. The same program therefore draws in 24 and 16 bits, on
//! grey displays and, as patterns of dots, in black and white.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::{Rgb565, Rgb888}, prelude::*};
//! use kerchief::render::{Ball, Camera, Ground, Light, Look, Shaded, Shadow, View};
//! use kerchief::render::pattern::{Border, Gingham, Width};
//! use kerchief::{Cloth, Q24, Units};
//!
//! const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
//! const SCREEN: Size = Size::new(64, 64);
//! const VIEW: View = View::new(-25.0, 22.0).fit(UNITS.point([-0.2, -0.2, -0.1]), UNITS.point([0.2, 0.2, 0.1]), SCREEN);
//! const RED: Rgb888 = Rgb888::new(178, 34, 38);
//! const CREAM: Rgb888 = Rgb888::new(250, 240, 226);
//! const CELL: Width = Width::cells(1);
//! const KERCHIEF: Border<Gingham> = Border { width: CELL, tone: RED, inner: Gingham { width: CELL, tones: [CREAM, RED] } };
//!
//! let cloth = Cloth::<Q24, 16, 16>::lay(&UNITS, UNITS.point([-0.15, -0.15, 0.11]));
//! let ball = Ball::new(UNITS.point([0.0; 3]), UNITS.length(0.1), Rgb888::new(70, 110, 140));
//! let ground = Ground::new(UNITS.point([0.0, 0.0, -0.1]), UNITS.length(0.6)).shadow(Shadow::<32>::new(Rgb888::new(128, 118, 112)));
//! let look = Look::new(Light::new(-60.0, 50.0), KERCHIEF).solids(ball).backdrop(ground);
//!
//! let mut shaded = Shaded::new(look);
//! let mut camera = Camera::new(&VIEW, SCREEN);
//! let mut display = MockDisplay::<Rgb565>::new();
//! # display.set_allow_overdraw(true);
//! shaded.draw(&cloth, &camera, &mut display)?;
//! // Move the ball and turn the camera
//! shaded.look.solids.centre = UNITS.point([0.01, 0.0, 0.0]).to_vec();
//! camera.orbit(Q24::from_bits(1 << 18), Q24::from_bits(0));
//! shaded.draw(&cloth, &camera, &mut display)?;
//! # Ok::<(), core::convert::Infallible>(())
//! ```

mod camera;
mod canvas;
mod fill;
mod gouraud;
mod ground;
pub mod light;
mod look;
mod orbit;
pub mod pattern;
mod quotient;
mod ramp;
mod shaded;
mod shading;
pub mod shadow;
mod solid;
mod surface;
mod tone;
mod view;
mod wireframe;

pub use camera::Camera;
pub use canvas::{Canvas, Dirty};
pub use ground::{Backdrop, Ground};
pub use light::{Finish, Light};
pub use look::Look;
pub use orbit::Orbit;
pub use pattern::Pattern;
pub use shaded::Shaded;
pub use shading::{Flat, Gouraud, Shading};
pub use shadow::Shadow;
pub use solid::{Ball, Rod, Solids};
pub use tone::{Shade, Toned};
pub use view::View;
pub use wireframe::Wireframe;
