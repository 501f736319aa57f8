//! Light on a surface.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::camera::Camera;
use super::view::sin_cos;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// A lamp far away, the sky above and what the ground reflects.
///
/// A surface of colour c and normal n (z upwards) gets, channel by channel, c·(ground + (sky − ground)·(1 + z)/2 + lamp·max(n·l + w, 0)/(1 + w))
/// + gloss·lamp (Lambert's law for a wide lamp, a hemisphere light, Blinn's highlight), where 255 counts as one and w is 0.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The unit vector towards the lamp.
    pub towards: [f64; 3],
    /// The lamp's colour on a surface that faces it.
    pub lamp: Rgb888,
    /// What surfaces that face upwards get from everywhere.
    pub sky: Rgb888,
    /// What surfaces that face downwards get from everywhere.
    pub ground: Rgb888,
}

impl Light {
    /// A warm lamp in this direction (degrees, as in [`View::new`](super::View::new)) under a pale sky.
    pub const fn new(azimuth: f64, elevation: f64) -> Self {
        let ((sa, ca), (se, ce)) = (sin_cos(azimuth), sin_cos(elevation));
        Self {
            towards: [ce * sa, -ce * ca, se],
            lamp: Rgb888::new(140, 131, 116),
            sky: Rgb888::new(146, 148, 154),
            ground: Rgb888::new(104, 94, 88),
        }
    }

    /// The light on surfaces whose normals are those of the scene.
    pub(super) fn lamp<S: Scalar>(&self, camera: &Camera<S>) -> Lamp<S> {
        let towards = Vec3::from_f64(self.towards);
        Lamp {
            towards,
            halfway: unit(towards - camera.axes.forward),
            zenith: Vec3::new(S::ZERO, S::ZERO, S::ONE),
            light: *self,
        }
    }

    /// The light on surfaces whose normals are those that the eye sees.
    pub(super) fn lamp_seen<S: Scalar>(&self, camera: &Camera<S>) -> Lamp<S> {
        let Lamp { towards, halfway, zenith, light } = self.lamp(camera);
        Lamp { towards: camera.seen(towards), halfway: camera.seen(halfway), zenith: camera.seen(zenith), light }
    }
}

/// How a surface answers light beyond its colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// The part of the lamp's light that the highlight adds where it is brightest.
    pub gloss: Rgb888,
    /// The highlight's exponent as a power of two: 3 is cloth, 5 is paint.
    pub polish: u32,
    /// The part (of 256) of the lamp's light that shines through to the other side.
    pub translucency: i32,
}

/// How far the lamp's light reaches around an edge: a wide lamp, not a point. Of 256.
const WRAP: i32 = 80;

/// A light in a number type.
#[derive(Clone, Copy, Debug)]
pub struct Lamp<S> {
    towards: Vec3<S>,
    /// Between the lamp and the eye.
    halfway: Vec3<S>,
    zenith: Vec3<S>,
    light: Light,
}

impl<S: Scalar> Lamp<S> {
    /// The tone of a surface of this colour and unit normal.
    pub(super) fn tone(&self, base: Rgb888, finish: &Finish, normal: Vec3<S>) -> Rgb888 {
        let facing = normal.dot(self.towards).round_times(256);
        let lamp = match (facing + WRAP) * 256 / (256 + WRAP) {
            lit if lit > 0 => lit,
            unlit => (-unlit * finish.translucency) >> 8,
        };
        let upward = (normal.dot(self.zenith).round_times(128) + 128).clamp(0, 256);
        let gloss = if facing > 0 {
            let mut part = normal.dot(self.halfway).max(S::ZERO);
            for _ in 0..finish.polish {
                part = part * part;
            }
            part.round_times(256)
        } else {
            0
        };
        let channel = |of: fn(&Rgb888) -> u8| {
            let of = |tone: &Rgb888| i32::from(of(tone));
            let Light { lamp: bright, sky, ground, .. } = &self.light;
            let light = of(ground) * (256 - upward) + of(sky) * upward + of(bright) * lamp;
            // 255 · 256 counts as one
            let lit = ((of(&base) * (light >> 8) + 128) * 257) >> 16;
            (lit + ((of(&finish.gloss) * of(bright) * gloss) >> 16)).min(255) as u8
        };
        Rgb888::new(channel(RgbColor::r), channel(RgbColor::g), channel(RgbColor::b))
    }
}

/// A vector of length one; a null vector stays one.
pub(super) fn unit<S: Scalar>(vector: Vec3<S>) -> Vec3<S> {
    let length = vector.length();
    if length == S::ZERO { vector } else { vector * length.recip() }
}

#[cfg(test)]
mod tests {
    use embedded_graphics::geometry::Size;

    use super::*;
    use crate::render::View;
    use crate::scalar::Q24;

    const DULL: Finish = Finish { gloss: Rgb888::BLACK, polish: 0, translucency: 0 };

    fn tones<S: Scalar>(light: &Light, finish: &Finish, normal: [f64; 3]) -> Rgb888 {
        let camera = Camera::<S>::new(&View::new(0.0, 0.0), Size::new(64, 64));
        light.lamp(&camera).tone(Rgb888::new(200, 100, 50), finish, unit(Vec3::from_f64(normal)))
    }

    #[test]
    fn a_sky_of_one_tone_leaves_colours_as_they_are() {
        let light = Light { lamp: Rgb888::BLACK, sky: Rgb888::WHITE, ground: Rgb888::WHITE, ..Light::new(0.0, 45.0) };
        assert_eq!(tones::<f64>(&light, &DULL, [0.3, 0.5, -0.7]), Rgb888::new(200, 100, 50));
    }

    #[test]
    fn the_lamp_lights_what_faces_it() {
        let light = Light { lamp: Rgb888::WHITE, sky: Rgb888::BLACK, ground: Rgb888::BLACK, ..Light::new(0.0, 90.0) };
        assert_eq!(tones::<f64>(&light, &DULL, [0.0, 0.0, 1.0]), Rgb888::new(200, 100, 50));
        let slanted = tones::<f64>(&light, &DULL, [0.8, 0.0, 0.6]);
        let expected = 200.0 * (0.6 + 80.0 / 256.0) / (1.0 + 80.0 / 256.0);
        assert!((f64::from(slanted.r()) - expected).abs() <= 1.0, "{slanted:?}");
        assert_eq!(tones::<f64>(&light, &DULL, [0.0, 0.0, -1.0]), Rgb888::BLACK);
        let thin = Finish { translucency: 128, ..DULL };
        assert!(tones::<f64>(&light, &thin, [0.0, 0.0, -1.0]).r() > 40);
    }

    #[test]
    fn a_highlight_is_halfway_between_the_lamp_and_the_eye() {
        // the eye looks along y, the lamp is above
        let light = Light::new(0.0, 90.0);
        let paint = Finish { gloss: Rgb888::WHITE, polish: 5, translucency: 0 };
        let gain = |normal| {
            i32::from(tones::<f64>(&light, &paint, normal).b()) - i32::from(tones::<f64>(&light, &DULL, normal).b())
        };
        assert!((gain([0.0, -1.0, 1.0]) - 115).abs() <= 2, "{}", gain([0.0, -1.0, 1.0]));
        assert!(gain([0.0, 0.0, 1.0]) < 2);
    }

    #[test]
    fn number_types_agree_to_a_level() {
        let light = Light::new(-40.0, 50.0);
        let finish = Finish { gloss: Rgb888::WHITE, polish: 3, translucency: 64 };
        for normal in [[0.1, -0.9, 0.3], [0.7, 0.7, 0.1], [-0.5, 0.2, -0.8], [-0.3, -0.6, 0.9]] {
            let expected = tones::<f64>(&light, &finish, normal);
            for found in [tones::<f32>(&light, &finish, normal), tones::<Q24>(&light, &finish, normal)] {
                let difference = |of: fn(&Rgb888) -> u8| of(&expected).abs_diff(of(&found));
                assert!(difference(RgbColor::r).max(difference(RgbColor::g)).max(difference(RgbColor::b)) <= 1);
            }
        }
    }
}
