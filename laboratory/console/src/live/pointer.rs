//! A pointer: drags the sheet, turns the picture, zooms.

use embedded_graphics::geometry::Point;
use kerchief::Node;

/// A button.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Button {
    /// Drags the sheet; beside it, turns the picture.
    Left,
    /// Turns the picture.
    Right,
}

/// What a pointer does. Places are pixels of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pointer {
    Pressed(Button, Point),
    Moved(Point),
    Released(Button),
    /// Notches away from the user.
    Wheel(f64),
}

/// A particle in the hand, and where it is dragged, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Held {
    pub(super) node: Node,
    pub(super) place: [f64; 3],
}

/// A button that is pressed: the first of two.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pressed {
    pub(super) button: Button,
    /// Where the pointer was last, pixels of the picture.
    pub(super) at: Point,
    /// What is dragged; nothing where the picture turns.
    pub(super) held: Option<Held>,
}

/// By how much a notch of the wheel brings the eye nearer, as on the playground's page.
const NOTCH: f64 = 0.1;

/// The zoom's factor of so many notches.
pub(super) fn factor(notches: f64) -> f64 {
    (NOTCH * notches).exp()
}
