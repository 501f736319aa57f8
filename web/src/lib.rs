//! The playground: sheets for a page in a browser, chosen while it runs.
//!
//! The page calls the functions in `exports`, which take and give numbers. Everything else is ordinary Rust, so that a host plays and draws the same sheets: the
//! program `expected` prints what a browser has to show.
//!
//! | module | contents |
//! |---|---|
//! | [`settings`] | what the page chooses |
//! | [`parts`] | forces, links and obstacles of a scene |
//! | [`frequency`] | the sheet's highest frequency, which limits explicit solvers |
//! | [`play`] | a sheet, whatever its number type, solver and grid |
//! | [`likeness`] | its copy in `f64`: measures, explosions, pictures |
//! | [`eye`] | where one looks from |
//! | [`frame`] | the pixels |
//! | `world`, `exports` | the way in for the page (WebAssembly alone) |

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
