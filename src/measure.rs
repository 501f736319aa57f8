//! Measurements of a sheet: strain, energy, momentum, bounds, digest. None of them changes it.

mod intersections;

pub use intersections::intersections;

use crate::grid::Grid;
use crate::link::{Family, Links, OneByOne, Order, Visitor, one_by_one};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::Units;
use crate::vec3::Vec3;

/// The relative difference between links and their rest lengths, `||d|/L − 1|`.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Strain<S> {
    /// The largest strain of all links.
    pub largest: S,
    /// The root mean square of all strains.
    pub rms: S,
}

/// The strain of all springs of `links`. In fixed point, a stretch beyond the largest number counts as that number.
pub fn strain<S: Scalar, L: Links<S>, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    links: &L,
) -> Strain<S> {
    let mut meter = Meter { particles, largest: S::ZERO, sum: S::EMPTY, count: 0 };
    links.springs(&mut meter);
    let rms = if meter.count == 0 { S::ZERO } else { S::root_mean(meter.sum, meter.count) };
    Strain { largest: meter.largest, rms }
}

struct Meter<'a, S: Scalar, const W: usize, const H: usize> {
    particles: &'a Particles<S, W, H>,
    largest: S,
    sum: S::Sum,
    count: u32,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Meter<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Meter<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        order.each::<W, H>(|a, b| {
            let length = (self.particles.position.at(b) - self.particles.position.at(a)).length();
            let strain = strain_of(length, family.rest.length);
            self.largest = self.largest.max(strain);
            self.sum = S::accumulate(self.sum, strain.product(strain));
            self.count += 1;
        });
    }
}

/// The [`largest`](Strain::largest) strain alone, for boards: it takes two roots per family instead of one per link.
pub fn largest_strain<S: Scalar, L: Links<S>, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    links: &L,
) -> S {
    let mut extremes = Extremes { particles, largest: S::ZERO };
    links.springs(&mut extremes);
    extremes.largest
}

struct Extremes<'a, S: Scalar, const W: usize, const H: usize> {
    particles: &'a Particles<S, W, H>,
    largest: S,
}

impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Extremes<'_, S, W, H> {
    #[inline]
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
        one_by_one::<S, ACROSS, DOWN>(self, family);
    }
}

impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Extremes<'_, S, W, H> {
    #[inline(always)]
    fn links(&mut self, family: &Family<S>, order: impl Order) {
        let rest = family.rest.length;
        // a chain has no links across, and their rest length is zero
        let mut squares: Option<[S::Product; 2]> = None;
        order.each::<W, H>(|a, b| {
            let square = (self.particles.position.at(b) - self.particles.position.at(a)).squared();
            let [shortest, longest] = squares.unwrap_or([square; 2]);
            squares = Some([
                if square < shortest { square } else { shortest },
                if square > longest { square } else { longest },
            ]);
        });
        for square in squares.into_iter().flatten() {
            self.largest = self.largest.max(strain_of(S::root(square), rest));
        }
    }
}

/// The relative difference between a length and a rest length.
#[inline(always)]
fn strain_of<S: Scalar>(length: S, rest: S) -> S {
    (length - rest).divide(rest).abs()
}

/// The kinetic energy of the free particles, J.
pub fn kinetic_energy<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>, units: &Units) -> f64 {
    let speed = units.cell / units.tick();
    free(particles).map(|(mass, _, v)| 0.5 * mass * units.mass * dot(v, v) * speed * speed).sum()
}

/// The potential energy of the free particles in a field of `gravity` (m/s²), relative to the origin, J.
pub fn gravitational_energy<S: Scalar, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    units: &Units,
    gravity: [f64; 3],
) -> f64 {
    free(particles).map(|(mass, x, _)| -mass * units.mass * dot(gravity, x) * units.cell).sum()
}

/// The energy stored in springs, J: the sum of ½·k·(|d| − L)² (thesis, equations 4.1–4.3).
pub fn elastic_energy<S: Scalar, L: Links<S>, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
    units: &Units,
    links: &L,
) -> f64 {
    struct Store<'a, S, const W: usize, const H: usize> {
        particles: &'a Particles<S, W, H>,
        energy: f64,
    }
    impl<S: Scalar, const W: usize, const H: usize> Visitor<S> for Store<'_, S, W, H> {
        #[inline]
        fn family<const ACROSS: usize, const DOWN: usize>(&mut self, family: &Family<S>) {
            one_by_one::<S, ACROSS, DOWN>(self, family);
        }
    }

    impl<S: Scalar, const W: usize, const H: usize> OneByOne<S> for Store<'_, S, W, H> {
        #[inline(always)]
        fn links(&mut self, family: &Family<S>, order: impl Order) {
            let strength = family.strength.dividend.to_f64() / family.strength.divisor.to_f64();
            order.each::<W, H>(|a, b| {
                let d = (self.particles.position.at(b) - self.particles.position.at(a)).to_f64();
                let elongation = libm::sqrt(dot(d, d)) - family.rest.length.to_f64();
                self.energy += 0.5 * strength * elongation * elongation;
            });
        }
    }
    let mut store = Store { particles, energy: 0.0 };
    links.springs(&mut store);
    let speed = units.cell / units.substep();
    store.energy * units.mass * speed * speed
}

/// The momentum of the free particles, kg·m/s.
pub fn momentum<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>, units: &Units) -> [f64; 3] {
    let scale = units.mass * units.cell / units.tick();
    free(particles).fold([0.0; 3], |sum, (mass, _, v)| core::array::from_fn(|k| sum[k] + mass * v[k] * scale))
}

/// The smallest distance between two particles that are two or more columns or rows apart in the sheet, m; infinite if there are none. It tests every pair.
pub fn closest<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>, units: &Units) -> f64 {
    let mut least = f64::INFINITY;
    for a in Grid::<S, W, H>::nodes() {
        let place = particles.position.at(a).to_f64();
        for b in Grid::<S, W, H>::nodes()
            .filter(|b| b.row >= a.row + 2 || b.row >= a.row && b.column.abs_diff(a.column) >= 2)
        {
            let other = particles.position.at(b).to_f64();
            let way: [f64; 3] = core::array::from_fn(|axis| other[axis] - place[axis]);
            least = least.min(dot(way, way));
        }
    }
    units.cell * libm::sqrt(least)
}

/// Mass, position and velocity of each free particle.
fn free<S: Scalar, const W: usize, const H: usize>(
    particles: &Particles<S, W, H>,
) -> impl Iterator<Item = (f64, [f64; 3], [f64; 3])> {
    Grid::<S, W, H>::nodes().filter(|&node| !particles.is_pinned(node)).map(|node| {
        (
            1.0 / particles.inverse_mass[node].to_f64(),
            particles.position.at(node).to_f64(),
            particles.velocity.at(node).to_f64(),
        )
    })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// The corners of the smallest axis-aligned box around a sheet, cells.
pub fn bounds<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>) -> [Vec3<S>; 2] {
    let first = particles.position.0[0].at(0);
    particles.position.values().fold([first; 2], |[low, high], x| {
        [
            Vec3::new(low.x.min(x.x), low.y.min(x.y), low.z.min(x.z)),
            Vec3::new(high.x.max(x.x), high.y.max(x.y), high.z.max(x.z)),
        ]
    })
}

/// Whether all positions and velocities are finite.
pub fn is_finite<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>) -> bool {
    let mut vectors = particles.position.values().chain(particles.velocity.values());
    vectors.all(|v| v.x.is_finite() && v.y.is_finite() && v.z.is_finite())
}

/// The 32-bit FNV-1a hash over the bits of the state: position and velocity of every particle, row by row, least significant byte first. Equal digests indicate
/// equal sheets, on any processor. All undefined numbers count as the same number.
pub fn digest<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>) -> u32 {
    let mut hash = 0x811c_9dc5_u32;
    for node in Grid::<S, W, H>::nodes() {
        for v in [particles.position.at(node), particles.velocity.at(node)] {
            for component in [v.x, v.y, v.z] {
                component.bits(|byte| hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193));
            }
        }
    }
    hash
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::grid::{Grid, Node};
    use crate::link::{Shear, Stretch};
    use crate::scalar::{Q13, Q24};

    /// The NaN that an operation returns differs between builds.
    #[test]
    fn undefined_numbers_have_one_digest() {
        fn check<S: Scalar>(undefined: [S; 4], other: S) {
            let digests = undefined.map(|number| {
                let mut particles = Particles::<S, 2, 2>::BLANK;
                particles.velocity.set(Node::new(1, 0), Vec3::new(S::ONE, number, S::ZERO));
                digest(&particles)
            });
            assert_eq!(digests, [digests[0]; 4], "{}", S::NAME);
            assert_eq!(undefined.map(S::word), [undefined[0].word(); 4], "{}", S::NAME);
            assert_ne!(undefined[0].word(), other.word(), "{}", S::NAME);
        }
        check([0x7fc0_0000, 0xffc0_0000, 0x7f80_0001, 0xffff_ffff].map(f32::from_bits), f32::INFINITY);
        let wide = [0x7ff8 << 48, 0xfff8 << 48, (0x7ff << 52) + 1, u64::MAX].map(f64::from_bits);
        check(wide, f64::INFINITY);
    }

    #[test]
    fn the_largest_strain_alone_is_that_of_all_links() {
        fn check<S: Scalar, const W: usize, const H: usize>() {
            let units = Units::sheet([W, H], [0.3, 0.2], 1e-3, 1.0 / 60.0, 4);
            let links =
                (Stretch::<S>::new(&units, units.stiffness(1.0)), Shear::<S>::new(&units, units.stiffness(1.0)));
            // shrunk to a point and inverted, at rest, and stretched far
            for scale in [0.0, -0.4, 0.97, 1.0, 1.02, 3.0] {
                let mut particles = Particles::<S, W, H>::BLANK;
                for (k, node) in Grid::<S, W, H>::nodes().enumerate() {
                    let noise = 0.02 * libm::sin(7.0 * k as f64);
                    let place = [node.column as f64 * scale + noise, node.row as f64 * scale, noise * scale];
                    particles.position.set(node, Vec3::from_f64(place));
                }
                let expected = strain(&particles, &links).largest;
                assert!(largest_strain(&particles, &links) == expected, "{W} × {H} in {}, {scale}", S::NAME);
                assert!(W == 1 || expected > S::ZERO);
            }
        }
        fn of_grids<S: Scalar>() {
            check::<S, 5, 4>();
            check::<S, 1, 4>();
            check::<S, 2, 1>();
        }
        of_grids::<f32>();
        of_grids::<f64>();
        of_grids::<Q24>();
        of_grids::<Q13>();
    }

    #[test]
    fn what_is_defined_keeps_its_digest() {
        let mut particles = Particles::<f32, 2, 2>::BLANK;
        let numbers = [1.0, -0.0, f32::INFINITY, f32::NEG_INFINITY, 1e-40, -f32::MAX];
        let mut hash = 0x811c_9dc5_u32;
        for (k, node) in Grid::<f32, 2, 2>::nodes().enumerate() {
            particles.position.set(node, Vec3::new(numbers[k], numbers[k + 1], numbers[k + 2]));
            for number in [numbers[k], numbers[k + 1], numbers[k + 2], 0.0, 0.0, 0.0] {
                for byte in number.to_bits().to_le_bytes() {
                    hash = (hash ^ u32::from(byte)).wrapping_mul(0x0100_0193);
                }
            }
        }
        assert_eq!(digest(&particles), hash);
    }
}
