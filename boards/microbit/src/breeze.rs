//! A wind that a Cortex-M0 can afford on every cell in every substep: products of 32 bits, no root and no division.

use kerchief::fingerprint::Fingerprint;
use kerchief::force::{Force, Row};
use kerchief::{Q13, Vec3};

/// Wind that presses on cells along their normals in proportion to its speed past them: the gain of each corner is `part·n·(n·u)`, where n is half the product of
/// the cell's diagonals and u the velocity of the air relative to the cell. It sets the flag in motion, and calm air stills it.
#[derive(Clone, Copy, Debug)]
pub struct Breeze {
    /// The velocity of the air, cells per tick, in 2⁻¹³.
    pub wind: [i32; 3],
}

/// The fraction bits of diagonals, normals and velocities.
const BITS: u32 = 13;
/// The part of its velocity relative to the air that a corner of a cell of 1 cell² across it loses in a substep, as a power of ½.
const PART: u32 = 3;

impl Force<Q13> for Breeze {
    const UNIFORM: bool = false;

    #[inline]
    fn is_field(&self) -> bool {
        true
    }

    #[inline]
    fn follows_velocity(&self) -> bool {
        true
    }

    #[inline]
    fn cells<const W: usize>(&self, [top, bottom]: [Row<'_, Q13, W>; 2], [upper, lower]: [&mut Vec3<[Q13; W]>; 2]) {
        // strips of every other column of cells, so that each particle is at the edge of one: half the cost
        for column in (1..W).step_by(2) {
            let [p, q] = [column - 1, column].map(|column| top.position.at(column));
            let [s, t] = [column - 1, column].map(|column| bottom.position.at(column));
            // along the other diagonal the mean is about the same
            let gain = self.gain(t - p, s - q, top.velocity.at(column - 1) + bottom.velocity.at(column));
            for column in [column - 1, column] {
                upper.add(column, gain);
                lower.add(column, gain);
            }
        }
    }

    fn fingerprint(&self, print: &mut Fingerprint) {
        self.wind.iter().for_each(|component| print.word(*component as u32));
    }
}

impl Breeze {
    /// For diagonals of up to three cells, and twice the cell's velocity.
    #[inline]
    fn gain(&self, a: Vec3<Q13>, b: Vec3<Q13>, twice: Vec3<Q13>) -> Vec3<Q13> {
        let bits = |Vec3 { x, y, z }: Vec3<Q13>, drop: u32| [x, y, z].map(|component| component.to_bits() >> drop);
        let [[ax, ay, az], [bx, by, bz]] = [a, b].map(|diagonal| bits(diagonal, 24 - BITS));
        let [vx, vy, vz] = bits(twice, 25 - BITS);
        let product = |a: i32, b: i32| a.wrapping_mul(b);
        let half = |twice: i32| twice >> (BITS + 1);
        let n = [
            half(product(ay, bz).wrapping_sub(product(az, by))),
            half(product(az, bx).wrapping_sub(product(ax, bz))),
            half(product(ax, by).wrapping_sub(product(ay, bx))),
        ];
        let [x, y, z] = self.wind;
        let across = product(n[0], x - vx).wrapping_add(product(n[1], y - vy)).wrapping_add(product(n[2], z - vz));
        let across = across >> (BITS + PART);
        let [x, y, z] = n.map(|n| Q13::from_bits(product(n, across) >> (2 * BITS - 24)));
        Vec3::new(x, y, z)
    }
}
