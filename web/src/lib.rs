//! The playground: sheets for a page in a browser, which chooses solver, number type and grid at run time.
//!
//! The page calls the functions in `exports`, which take and return numbers. Everything else is ordinary Rust, so that a host can play and draw the same sheets. The
//! program `expected` prints the digests and pixel hashes that a browser must reproduce.
//!
//! | module | contents |
//! |---|---|
//! | [`settings`] | the settings of a sheet |
//! | [`parts`] | forces, links and colliders of a scene |
//! | [`frequency`] | the sheet's highest frequency, which limits explicit solvers |
//! | [`play`] | a sheet in motion, of any number type, solver and grid |
//! | [`likeness`] | its copy in `f64`: measures, explosions, pictures |
//! | [`eye`] | the camera |
//! | [`frame`] | the pixels |
//! | `world`, `exports` | the functions that the page calls (WebAssembly only) |

pub mod eye;
pub mod frame;
pub mod frequency;
pub mod likeness;
pub mod parts;
pub mod play;
pub mod settings;

#[cfg(target_family = "wasm")]
mod exports;
#[cfg(target_family = "wasm")]
mod world;
