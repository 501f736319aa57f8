//! Pointer events: they drag the sheet, turn the picture and zoom.

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

/// A pointer event. Positions are pixels of the window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pointer {
    Pressed(Button, Point),
    Moved(Point),
    Released(Button),
    /// Notches of the wheel, away from the user.
    Wheel(f64),
}

/// A grabbed particle, and the point to which it is dragged, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Held {
    pub(super) node: Node,
    pub(super) place: [f64; 3],
}

/// The pressed button; the first one if two are pressed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Pressed {
    pub(super) button: Button,
    /// The last position of the pointer, pixels of the picture.
    pub(super) at: Point,
    /// The dragged particle; none if the picture turns.
    pub(super) held: Option<Held>,
}

/// The logarithm of the zoom factor of a notch, as on the playground's page.
const NOTCH: f64 = 0.1;

/// The zoom factor for a number of notches.
pub(super) fn factor(notches: f64) -> f64 {
    (NOTCH * notches).exp()
}
