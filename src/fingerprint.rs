//! A number that is another one when anything has changed: how a sheet at rest notices that it has to wake.

use crate::scalar::Scalar;
use crate::vec3::Vec3;

/// A 32-bit hash of numbers, in the order in which they were added.
///
/// A single number that changes always changes it; several that change at once leave it the same once in 2³² times.
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
pub struct Fingerprint {
    hash: u32,
    known: bool,
}

impl Fingerprint {
    /// The fingerprint of nothing.
    pub const fn new() -> Self {
        Self { hash: 0, known: true }
    }

    /// Takes something in that cannot be seen: this fingerprint then matches no other.
    pub const fn unknown(&mut self) {
        self.known = false;
    }

    /// Takes a number in.
    #[inline]
    pub fn number<S: Scalar>(&mut self, number: S) {
        self.numbers([number]);
    }

    /// Takes up to seven numbers in, at the cost of one product.
    #[inline]
    pub fn numbers<S: Scalar, const N: usize>(&mut self, numbers: [S; N]) {
        const { assert!(N <= 7, "an eighth would be rotated nearly as the first") };
        let mut mix = 0_u32;
        for (k, number) in numbers.into_iter().enumerate() {
            // each to another place, so that equal changes of two don't cancel
            mix ^= number.word().rotate_left(9 * k as u32);
        }
        self.word(mix);
    }

    /// Takes a row of places and velocities in.
    ///
    /// A velocity goes in with its place, without a rotation between them: five instructions for two words on a Cortex-M0, loads included. So a change of a
    /// coordinate and one of the velocity along it, in the same particle at once, may cancel each other; no others do but by chance.
    #[inline]
    pub(crate) fn row<S: Scalar, const W: usize>(&mut self, places: &[S; W], velocities: &[S; W]) {
        self.pass(places, velocities, |mix, place, velocity| (mix ^ place).wrapping_add(velocity));
    }

    /// Takes a row of masses in.
    #[inline]
    pub(crate) fn masses<S: Scalar, const W: usize>(&mut self, masses: &[S; W]) {
        self.pass(masses, masses, |mix, mass, _| mix ^ mass);
    }

    /// Passes a row through `join`, which can be undone for either word.
    #[inline(always)]
    fn pass<S: Scalar, const W: usize>(&mut self, a: &[S; W], b: &[S; W], join: impl Fn(u32, u32, u32) -> u32) {
        let mut mix = self.hash;
        let mut next = |a: S, b: S| mix = join(mix, a.word(), b.word()).rotate_right(9);
        let ((a, last_a), (b, last_b)) = (a.as_chunks::<8>(), b.as_chunks::<8>());
        for (a, b) in a.iter().zip(b) {
            // eight in one go, without a loop
            (0..8).for_each(|k| next(a[k], b[k]));
        }
        last_a.iter().zip(last_b).for_each(|(a, b)| next(*a, *b));
        self.hash = mix.wrapping_mul(0x9e37_79b9);
    }

    /// Takes a vector in.
    #[inline]
    pub fn vector<S: Scalar>(&mut self, vector: Vec3<S>) {
        self.numbers([vector.x, vector.y, vector.z]);
    }

    /// Takes 32 bits in.
    #[inline]
    pub fn word(&mut self, word: u32) {
        // the rotation brings what a product leaves in the upper bits, as of changed signs, back to the lower ones
        self.hash = (self.hash.rotate_left(5) ^ word).wrapping_mul(0x9e37_79b9);
    }

    /// Whether both are of the same numbers.
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
        // changes of all numbers at once, which a weaker hash would take for none
        let all = |change: fn(f64) -> f64| of::<S>(&numbers.map(change));
        for (what, changed) in
            [("sign", all(|x| -x)), ("place", all(|x| x + 1.0)), ("size", all(|x| 2.0 * x)), ("all", all(|_| 0.0))]
        {
            assert!(!print.matches(changed), "{what}");
        }
        let seven = |change: f64| {
            let mut print = Fingerprint::new();
            print.numbers::<S, 7>(core::array::from_fn(|k| S::from_f64(numbers[k] * change)));
            print
        };
        assert!(seven(1.0).matches(seven(1.0)) && !seven(1.0).matches(seven(-1.0)) && !seven(1.0).matches(seven(2.0)));
        let mut swapped = numbers;
        swapped.swap(3, 200);
        assert!(!print.matches(of::<S>(&swapped)));
    }

    /// Rows as long as a chunk and some, and their fingerprint once they are changed.
    fn every_change_of_rows_shows<S: Scalar>() {
        const W: usize = 11;
        let numbers: [[f64; W]; 3] = core::array::from_fn(|row| core::array::from_fn(|k| ((7 * row + k) as f64).sin()));
        let of = |[places, velocities, masses]: &[[f64; W]; 3]| {
            let mut print = Fingerprint::new();
            print.row(&places.map(S::from_f64), &velocities.map(S::from_f64));
            print.masses(&masses.map(S::from_f64));
            print
        };
        let print = of(&numbers);
        assert!(print.matches(of(&numbers)));
        for row in 0..3 {
            for k in 0..W {
                let mut changed = numbers;
                changed[row][k] += 2.0 * S::RESOLUTION;
                assert!(!print.matches(of(&changed)), "row {row}, column {k}");
                // two neighbours drawn together, a pin that changes places
                let (mut pinched, mut swapped) = (changed, numbers);
                pinched[row][(k + 1) % W] -= 2.0 * S::RESOLUTION;
                swapped[row].swap(k, (k + 1) % W);
                assert!(!print.matches(of(&pinched)) && !print.matches(of(&swapped)), "row {row}, column {k}");
            }
        }
        for change in [|x: f64| -x, |x| x + 1.0, |x| 2.0 * x, |_| 0.0] {
            assert!(!print.matches(of(&numbers.map(|row| row.map(change)))));
        }
    }

    #[test]
    fn every_change_shows_in_every_number_type() {
        every_change_of_rows_shows::<f32>();
        every_change_of_rows_shows::<f64>();
        every_change_of_rows_shows::<Q24>();
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
