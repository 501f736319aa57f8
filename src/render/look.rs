//! How a picture looks.

use embedded_graphics::pixelcolor::Rgb888;

use super::light::{Finish, Light};
use super::pattern::Pattern;

/// How a sheet and what is around it look. What isn't named costs nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look<F, B, O = (), G = ()> {
    /// The light on everything.
    pub light: Light,
    /// The side that faces up where a sheet is laid, and away from a viewer at azimuth 0 where it is hung.
    pub front: F,
    /// The other side.
    pub back: B,
    /// The sheet's gloss and translucency.
    pub finish: Finish,
    /// What the sheet lies on or hangs before.
    pub solids: O,
    /// What is behind everything.
    pub backdrop: G,
}

/// Cloth: a faint sheen, a quarter of the light shines through.
const COTTON: Finish = Finish { gloss: Rgb888::new(26, 24, 22), polish: 3, translucency: 64 };

impl<P: Copy> Look<P, P> {
    /// A sheet alone, of the same pattern on both sides.
    pub const fn new(light: Light, pattern: P) -> Self {
        Self { light, front: pattern, back: pattern, finish: COTTON, solids: (), backdrop: () }
    }
}

impl<F, B, O, G> Look<F, B, O, G> {
    /// The same with another back.
    #[must_use]
    pub fn back<P: Pattern>(self, back: P) -> Look<F, P, O, G> {
        let Self { light, front, finish, solids, backdrop, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }

    /// The same with these solids.
    #[must_use]
    pub fn solids<T>(self, solids: T) -> Look<F, B, T, G> {
        let Self { light, front, back, finish, backdrop, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }

    /// The same before this backdrop.
    #[must_use]
    pub fn backdrop<T>(self, backdrop: T) -> Look<F, B, O, T> {
        let Self { light, front, back, finish, solids, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }
}
