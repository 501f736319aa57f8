//! A scene that is played live, without the window around it: what keys and pointers do, and what is shown.

mod caption;
mod clock;
mod pointer;
mod stage;
mod strain;
mod weather;

pub use caption::{PICTURE, SIZE};
pub use clock::{Clock, Rate};
pub use pointer::{Button, Pointer};
pub use stage::{Key, Stage};
