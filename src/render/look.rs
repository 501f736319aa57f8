//! The look of a picture: light, patterns, solids and backdrop.

use embedded_graphics::pixelcolor::Rgb888;

use super::light::{Finish, Light};
use super::pattern::Pattern;

/// The look of a sheet and its surroundings. Parts that are left out cost nothing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Look<F, B, O = (), G = ()> {
    /// The light on the whole scene.
    pub light: Light,
    /// The pattern of the front, which faces up if the sheet is laid, and away from a viewer at azimuth 0 if it is hung.
    pub front: F,
    /// The pattern of the back.
    pub back: B,
    /// The sheet's gloss and translucency.
    pub finish: Finish,
    /// The solids that the sheet lies on or hangs in front of.
    pub solids: O,
    /// The backdrop, behind everything else.
    pub backdrop: G,
}

/// Cotton: a faint sheen, and a quarter of the lamp's light shines through.
const COTTON: Finish = Finish { gloss: Rgb888::new(26, 24, 22), polish: 3, translucency: 64 };

impl<P: Copy> Look<P, P> {
    /// A sheet alone, with the same pattern on both sides.
    pub const fn new(light: Light, pattern: P) -> Self {
        Self { light, front: pattern, back: pattern, finish: COTTON, solids: (), backdrop: () }
    }
}

impl<F, B, O, G> Look<F, B, O, G> {
    /// This look with another pattern on the back.
    #[must_use]
    pub fn back<P: Pattern>(self, back: P) -> Look<F, P, O, G> {
        let Self { light, front, finish, solids, backdrop, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }

    /// This look with these solids.
    #[must_use]
    pub fn solids<T>(self, solids: T) -> Look<F, B, T, G> {
        let Self { light, front, back, finish, backdrop, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }

    /// This look with this backdrop.
    #[must_use]
    pub fn backdrop<T>(self, backdrop: T) -> Look<F, B, O, T> {
        let Self { light, front, back, finish, solids, .. } = self;
        Look { light, front, back, finish, solids, backdrop }
    }
}
