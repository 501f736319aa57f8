//! The lighting of surfaces.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};

use super::camera::Camera;
use super::quotient::quotient;
use super::tone::channels;
use super::view::sin_cos;
use crate::scalar::Scalar;
use crate::scalar::fit::is_finite;
use crate::vec3::Vec3;

/// A lamp far away, the sky above, and the light reflected by the ground.
///
/// A surface of colour c and normal n (z upwards) has, channel by channel, the tone c·(ground + (sky − ground)·(1 + z)/2 + lamp·max(n·l + w, 0)/(1 + w))
/// + gloss·lamp (Lambert's law for a wide lamp, a hemisphere light, Blinn's highlight), where 255 counts as one and w is 0.3.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// The unit vector towards the lamp.
    pub towards: [f64; 3],
    /// The lamp's colour on a surface that faces it.
    pub lamp: Rgb888,
    /// The ambient light on surfaces that face upwards.
    pub sky: Rgb888,
    /// The ambient light on surfaces that face downwards.
    pub ground: Rgb888,
}

impl Light {
    /// A warm lamp in this direction (degrees, as in [`View::new`](super::View::new)) under a pale sky.
    ///
    /// # Panics
    /// At compile time in a constant: for an angle that is not finite.
    #[track_caller]
    pub const fn new(azimuth: f64, elevation: f64) -> Self {
        assert!(is_finite(azimuth) && is_finite(elevation), "a direction's angles are finite");
        let ((sa, ca), (se, ce)) = (sin_cos(azimuth), sin_cos(elevation));
        Self {
            towards: [ce * sa, -ce * ca, se],
            lamp: Rgb888::new(140, 131, 116),
            sky: Rgb888::new(146, 148, 154),
            ground: Rgb888::new(104, 94, 88),
        }
    }

    /// The light for normals in scene coordinates.
    pub(super) fn lamp<S: Scalar>(&self, camera: &Camera<S>) -> Lamp {
        self.lamp_of(camera, |direction| direction)
    }

    /// The light for normals in eye coordinates.
    pub(super) fn lamp_seen<S: Scalar>(&self, camera: &Camera<S>) -> Lamp {
        self.lamp_of(camera, |direction| camera.seen(direction))
    }

    fn lamp_of<S: Scalar>(&self, camera: &Camera<S>, seen: impl Fn(Vec3<S>) -> Vec3<S>) -> Lamp {
        let towards = Vec3::from_f64(self.towards);
        let [towards, halfway, zenith] =
            [towards, unit(towards - camera.axes.forward), Vec3::new(S::ZERO, S::ZERO, S::ONE)]
                .map(|direction| Normal::of(seen(direction)));
        Lamp { towards, halfway, zenith, light: *self }
    }
}

/// The response of a surface to light, apart from its colour.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Finish {
    /// The part of the lamp's light that the highlight adds at its brightest point.
    pub gloss: Rgb888,
    /// The logarithm to base 2 of the highlight's exponent: 3 is cloth, 5 is paint.
    pub polish: u32,
    /// The part (of 256) of the lamp's light that shines through to the other side.
    pub translucency: i32,
}

/// The w of [`Light`], of 256: how far the light of a wide lamp reaches around an edge.
const WRAP: i32 = 80;

/// `number/(256 + WRAP)`, rounded towards zero, by the divisor's reciprocal, rounded up. Exact for `(facing + WRAP)·256` with |facing| ≤ 256.
const fn over_wrapped(number: i32) -> i32 {
    const DIVISOR: u32 = 256 + WRAP as u32;
    // a multiple of 256: four of its zero bits are dropped so that the product fits 32 bits
    let size = number.unsigned_abs();
    let quotient = ((size >> 4) * ((1 << 20) / DIVISOR + 1)) >> 16;
    if number < 0 { -(quotient as i32) } else { quotient as i32 }
}

/// A light, with its directions in the coordinates of the normals.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    towards: Normal,
    /// Halfway between the directions to the lamp and to the eye.
    halfway: Normal,
    zenith: Normal,
    light: Light,
}

impl Lamp {
    /// The light from which this was made.
    pub(super) const fn light(&self) -> &Light {
        &self.light
    }

    /// The tone of a surface of this colour and normal.
    #[inline]
    pub(super) fn tone(&self, base: Rgb888, finish: &Finish, normal: Normal) -> Rgb888 {
        self.lit(finish, normal).tone(base)
    }

    /// The light on a surface of this normal.
    pub(super) fn lit(&self, finish: &Finish, normal: Normal) -> Lit {
        let facing = normal.dot(self.towards, 8);
        let lamp = match over_wrapped((facing + WRAP) * 256) {
            lit if lit > 0 => lit,
            unlit => (-unlit * finish.translucency) >> 8,
        };
        let upward = (normal.dot(self.zenith, 7) + 128).clamp(0, 256);
        let gloss = if facing > 0 && finish.gloss != Rgb888::BLACK {
            let mut part = normal.dot(self.halfway, Normal::BITS).max(0);
            for _ in 0..finish.polish {
                part = (part * part + (1 << (Normal::BITS - 1))) >> Normal::BITS;
            }
            part >> (Normal::BITS - 8)
        } else {
            0
        };
        let [from_lamp, from_sky, from_ground, shine] =
            [self.light.lamp, self.light.sky, self.light.ground, finish.gloss].map(channels);
        let light = core::array::from_fn(|k| {
            ((from_ground[k] * (256 - upward) + from_sky[k] * upward + from_lamp[k] * lamp) >> 8) as u16
        });
        Lit { light, gloss: core::array::from_fn(|k| ((shine[k] * from_lamp[k] * gloss) >> 16) as u8) }
    }
}

/// The light that a surface receives, channel by channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lit {
    /// The factor of the surface's colour, where 255 counts as one; up to twice that.
    light: [u16; 3],
    /// The light that its gloss adds.
    gloss: [u8; 3],
}

impl Lit {
    /// This light, without gloss.
    pub(super) fn of(light: [i32; 3]) -> Self {
        Self { light: light.map(|light| light as u16), gloss: [0; 3] }
    }

    /// Twice the light reflected by a medium grey surface, with its gloss.
    pub(super) fn grey(&self) -> [i32; 3] {
        core::array::from_fn(|k| i32::from(self.light[k]) + 2 * i32::from(self.gloss[k]))
    }

    /// The tone of a surface of this colour.
    #[inline]
    pub(super) fn tone(&self, base: Rgb888) -> Rgb888 {
        let base = channels(base);
        let [r, g, b] = core::array::from_fn(|k| {
            let lit = ((base[k] * i32::from(self.light[k]) + 128) * 257) >> 16;
            (lit + i32::from(self.gloss[k])).min(255) as u8
        });
        Rgb888::new(r, g, b)
    }
}

/// A unit vector of 32-bit integers, in units of 2⁻¹⁴. A tone of 8 bits needs no more precision, and a Cortex-M0 has no longer products.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Normal([i32; 3]);

impl Normal {
    const BITS: u32 = 14;

    /// The zero vector: no direction.
    pub(super) const NONE: Self = Self([0; 3]);

    /// The direction of a vector whose length is near one.
    pub(super) fn of<S: Scalar>(vector: Vec3<S>) -> Self {
        Self::along(whole(vector))
    }

    /// The direction of the cross product `a × b` of two vectors about a cell long.
    pub(super) fn across<S: Scalar>(a: Vec3<S>, b: Vec3<S>) -> Self {
        let [a, b] = [a, b].map(|vector| shortened(whole(vector)));
        Self::along([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])
    }

    /// The opposite direction.
    pub(super) fn reversed(self) -> Self {
        Self(self.0.map(|component| -component))
    }

    fn along(vector: [i32; 3]) -> Self {
        let [x, y, z] = shortened(vector);
        let length = (x * x + y * y + z * z).unsigned_abs().isqrt() as i32;
        if length == 0 {
            return Self([0; 3]);
        }
        let inverse = quotient(1 << (2 * Self::BITS), length);
        Self([x, y, z].map(|component| (component * inverse + (1 << (Self::BITS - 1))) >> Self::BITS))
    }

    /// The cosine of the angle between two directions, in units of 2⁻ᵇⁱᵗˢ.
    fn dot(self, other: Self, bits: u32) -> i32 {
        let [[a, b, c], [x, y, z]] = [self.0, other.0];
        let drop = 2 * Self::BITS - bits;
        (a * x + b * y + c * z + (1 << (drop - 1))) >> drop
    }
}

/// The components in units of 2⁻¹², rounded.
fn whole<S: Scalar>(Vec3 { x, y, z }: Vec3<S>) -> [i32; 3] {
    [x, y, z].map(|component| component.round_times(1 << 12))
}

/// The same direction with components of at most 14 bits and a sign, so that the sum of three products fits 31.
fn shortened(vector: [i32; 3]) -> [i32; 3] {
    let bits = vector.into_iter().fold(0, |all, component| all | component.unsigned_abs());
    let drop = 18_u32.saturating_sub(bits.leading_zeros());
    vector.map(|component| component >> drop)
}

/// The unit vector in this direction; a zero vector stays zero.
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
        light.lamp(&camera).tone(Rgb888::new(200, 100, 50), finish, Normal::of(unit(Vec3::<S>::from_f64(normal))))
    }

    #[test]
    fn a_constant_divisor_needs_no_division() {
        for facing in -256..=256 {
            let number = (facing + WRAP) * 256;
            assert_eq!(over_wrapped(number), number / (256 + WRAP), "{number}");
        }
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
