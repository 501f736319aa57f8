//! A hash that differs after a change of any input: a sheet at rest uses it to wake.

use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// A 32-bit hash of numbers, in the order in which they were added.
///
/// If a single number of 32 bits changes, the hash always changes. If several numbers or one of 64 bits change at once, the hash stays the same in one of 2³²
/// cases.
///
/// ```
/// use kerchief::fingerprint::Fingerprint;
/// use kerchief::{Q24, Scalar, Vec3};
///
/// let of = |z| {
///     let mut print = Fingerprint::new();
///     print.vector(Vec3::<Q24>::from_f64([0.0, 0.0, z]));
///     print
/// };
/// assert!(of(-9.81).matches(of(-9.81)));
/// assert!(!of(-9.81).matches(of(-9.82)));
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Fingerprint {
    hash: u32,
    known: bool,
}

impl Fingerprint {
    /// The fingerprint of no data.
    pub const fn new() -> Self {
        Self { hash: 0, known: true }
    }

    /// Adds data that cannot be read: this fingerprint then matches no other.
    pub const fn unknown(&mut self) {
        self.known = false;
    }

    /// Adds a number.
    #[inline]
    pub fn number<S: Scalar>(&mut self, number: S) {
        self.word(number.word());
    }

    /// Adds numbers.
    #[inline]
    pub fn numbers<S: Scalar, const N: usize>(&mut self, numbers: [S; N]) {
        numbers.into_iter().for_each(|number| self.number(number));
    }

    /// Adds a vector.
    #[inline]
    pub fn vector<S: Scalar>(&mut self, vector: Vec3<S>) {
        self.numbers([vector.x, vector.y, vector.z]);
    }

    /// Adds 32 bits.
    #[inline]
    pub fn word(&mut self, word: u32) {
        // a product changes mainly the upper bits, for example by a changed sign; the rotation brings them back to the lower ones
        self.hash = (self.hash.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b9);
    }

    /// The hash value.
    pub(crate) const fn hash(self) -> u32 {
        self.hash
    }

    /// Whether both were computed from the same numbers.
    pub const fn matches(self, other: Self) -> bool {
        self.known && other.known && self.hash == other.hash
    }
}

impl Default for Fingerprint {
    fn default() -> Self {
        Self::new()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scalar::Q24;

    fn of<S: Scalar>(numbers: &[f64]) -> Fingerprint {
        let mut print = Fingerprint::new();
        numbers.iter().for_each(|&number| print.number(S::from_f64(number)));
        print
    }

    fn every_change_shows<S: Scalar>() {
        let numbers: [f64; 256] = core::array::from_fn(|k| (k as f64 * 0.37).sin());
        let print = of::<S>(&numbers);
        assert!(print.matches(of::<S>(&numbers)));
        for k in 0..256 {
            let mut changed = numbers;
            changed[k] += 2.0 * S::RESOLUTION;
            assert!(!print.matches(of::<S>(&changed)), "number {k}");
        }
        // simultaneous changes of all numbers, which a weaker hash would not detect
        let all = |change: fn(f64) -> f64| of::<S>(&numbers.map(change));
        for (what, changed) in
            [("sign", all(|x| -x)), ("place", all(|x| x + 1.0)), ("size", all(|x| 2.0 * x)), ("all", all(|_| 0.0))]
        {
            assert!(!print.matches(changed), "{what}");
        }
        let mut swapped = numbers;
        swapped.swap(3, 200);
        assert!(!print.matches(of::<S>(&swapped)));
    }

    #[test]
    fn every_change_shows_in_every_number_type() {
        every_change_shows::<f32>();
        every_change_shows::<f64>();
        every_change_shows::<Q24>();
    }

    #[test]
    fn what_cannot_be_seen_matches_nothing() {
        let mut print = Fingerprint::new();
        print.unknown();
        assert!(!print.matches(print));
        assert!(!print.matches(Fingerprint::new()) && !Fingerprint::new().matches(print));
    }
}
