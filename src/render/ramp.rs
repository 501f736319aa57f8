//! Tables of a colour's tones, from darkness to full light.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::light::{Light, Lit};
use super::tone::{Shade, channels};

/// The number of levels, from no light to full light.
pub(super) const LEVELS: usize = 128;

/// The colours of `K` bases at each level of light.
///
/// Light is one number here, its luma. Its split between the surface's own colour and gloss, and between lamp, sky and ground, is assumed to be the most common split at
/// that level: little light comes from the ground, more from the sky and the lamp.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Ramps<C, const K: usize> {
    /// The colours of the lamp, the sky and the ground, for which the tables are valid.
    lights: Option<[Rgb888; 3]>,
    /// The largest luma of the light, where 255 counts as one, and the levels per unit of luma, · 2¹⁶.
    most: i32,
    unit: i32,
    of: [Option<(Rgb888, [C; LEVELS])>; K],
    /// The index of the table that is replaced next.
    next: usize,
}

impl<C: Shade, const K: usize> Ramps<C, K> {
    pub(super) const NONE: Self = Self { lights: None, most: 1, unit: 0, of: [None; K], next: 0 };

    /// Discards all tables if the colours of the light have changed.
    pub(super) fn prepare(&mut self, &Light { lamp, sky, ground, .. }: &Light) {
        let lights = [lamp, sky, ground];
        if self.lights != Some(lights) {
            let most = luma(bright(lights)).max(1);
            let unit = ((LEVELS as i32 - 1) << 16) / most;
            *self = Self { lights: Some(lights), most, unit, ..Self::NONE };
        }
    }

    /// The level of this light, · 2⁸.
    pub(super) fn level(&self, lit: Lit) -> u16 {
        ((luma(lit.grey()).clamp(0, self.most) * self.unit) >> 8) as u16
    }

    /// The colours of a base at each level. Computes them if no table has them.
    #[inline]
    pub(super) fn of(&mut self, base: Rgb888) -> &[C; LEVELS] {
        const { assert!(K > 0, "there is a colour at least") };
        let found = self.of.iter().position(|ramp| matches!(ramp, Some((other, _)) if *other == base));
        let index = found.unwrap_or_else(|| self.make(base));
        match &self.of[index.min(K - 1)] {
            Some((_, colors)) => colors,
            None => unreachable!("it was found or made"),
        }
    }

    #[cold]
    #[inline(never)]
    fn make(&mut self, base: Rgb888) -> usize {
        let index = self.next;
        self.next = if index + 1 < K { index + 1 } else { 0 };
        let lights = self.lights.unwrap_or([Rgb888::BLACK; 3]);
        let colors = core::array::from_fn(|level| C::nearest(Lit::of(self.color(lights, level as i32)).tone(base)));
        self.of[index] = Some((base, colors));
        index
    }

    /// The light at a level: from black to the ground's light, and on to the sum of lamp and sky.
    fn color(&self, lights: [Rgb888; 3], level: i32) -> [i32; 3] {
        let [dark, bright] = [channels(lights[2]), bright(lights)];
        let (from, to) = (luma(dark), self.most);
        let here = level * self.most / (LEVELS as i32 - 1);
        core::array::from_fn(|k| {
            if here <= from {
                dark[k] * here / from.max(1)
            } else {
                dark[k] + (bright[k] - dark[k]) * (here - from) / (to - from).max(1)
            }
        })
    }
}

/// The light on a surface that faces the lamp and the sky.
fn bright([lamp, sky, _]: [Rgb888; 3]) -> [i32; 3] {
    let [lamp, sky] = [lamp, sky].map(channels);
    core::array::from_fn(|k| lamp[k] + sky[k])
}

/// The luma of a colour (ITU-R BT.601).
fn luma([r, g, b]: [i32; 3]) -> i32 {
    (77 * r + 150 * g + 29 * b) >> 8
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::Size;

    use super::*;
    use crate::render::light::{Finish, Normal};
    use crate::render::{Camera, View};
    use crate::vec3::Vec3;

    /// Light of one hue is represented by one number: the table agrees with the lighting equation to half a level of 2.4 and a rounding.
    #[test]
    fn tables_have_the_tones_of_light_of_one_hue() {
        let [lamp, sky, ground] = [170, 130, 60].map(|grey| Rgb888::new(grey, grey, grey));
        let light = Light { lamp, sky, ground, ..Light::new(-50.0, 40.0) };
        let finish = Finish { gloss: Rgb888::BLACK, polish: 0, translucency: 64 };
        let lamp = light.lamp(&Camera::<f64>::new(&View::new(0.0, 0.0), Size::new(64, 64)));
        let base = Rgb888::new(200, 100, 50);
        let mut ramps = Ramps::<Rgb888, 1>::NONE;
        ramps.prepare(&light);
        for k in 0..500 {
            let (turn, rise) = (f64::from(k) * 0.7, f64::from(k) / 250.0 - 1.0);
            let flat = libm::sqrt(1.0 - rise * rise);
            let normal = Normal::of(Vec3::<f64>::from_f64([flat * libm::cos(turn), flat * libm::sin(turn), rise]));
            let level = ramps.level(lamp.lit(&finish, normal));
            let found = channels(ramps.of(base)[usize::from((level + 128) >> 8)]);
            let expected = channels(lamp.tone(base, &finish, normal));
            for (found, expected) in found.into_iter().zip(expected) {
                assert!((found - expected).abs() <= 2, "{found}, not {expected}: {normal:?}");
            }
        }
    }
}
