//! A scene that is played live: the actions of keys and pointers, and the picture with its captions. The window itself is elsewhere.

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
