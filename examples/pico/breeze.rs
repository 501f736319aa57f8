//! A wind that a Cortex-M0 can afford on every cell in every substep: products of 32 bits, no root and no division.

use kerchief::force::{Force, Row};
use kerchief::{Q13, Vec3};

/// Wind that presses on cells along their normals, by as much as they stand across it: the gain of each corner is `n·(n·wind)`, where n is half the product of the
/// cell's diagonals. For cells that keep their area that is `kerchief`'s facet wind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Breeze {
    /// The velocity that a corner of a cell of 1 cell² across the wind gains in a substep, cells per tick, in 2⁻¹³.
    pub(crate) wind: [i32; 3],
}

/// The fraction bits of diagonals, normals and wind.
const BITS: u32 = 13;

impl Force<Q13> for Breeze {
    const FIELD: bool = true;
    const UNIFORM: bool = false;

    #[inline]
    fn cells<const W: usize>(&self, [top, bottom]: [Row<'_, Q13, W>; 2], [upper, lower]: [&mut Vec3<[Q13; W]>; 2]) {
        for column in 1..W {
            let [p, q] = [column - 1, column].map(|column| top.position.at(column));
            let [s, t] = [column - 1, column].map(|column| bottom.position.at(column));
            let gain = self.gain(t - p, s - q);
            for column in [column - 1, column] {
                upper.add(column, gain);
                lower.add(column, gain);
            }
        }
    }
}

impl Breeze {
    /// For diagonals of up to three cells.
    #[inline]
    fn gain(&self, a: Vec3<Q13>, b: Vec3<Q13>) -> Vec3<Q13> {
        let short = |Vec3 { x, y, z }: Vec3<Q13>| [x, y, z].map(|component| component.to_bits() >> (24 - BITS));
        let [[ax, ay, az], [bx, by, bz]] = [a, b].map(short);
        let product = |a: i32, b: i32| a.wrapping_mul(b);
        let half = |twice: i32| twice >> (BITS + 1);
        let n = [
            half(product(ay, bz).wrapping_sub(product(az, by))),
            half(product(az, bx).wrapping_sub(product(ax, bz))),
            half(product(ax, by).wrapping_sub(product(ay, bx))),
        ];
        let [x, y, z] = self.wind;
        let across = product(n[0], x).wrapping_add(product(n[1], y)).wrapping_add(product(n[2], z)) >> BITS;
        let [x, y, z] = n.map(|n| Q13::from_bits(product(n, across) >> (2 * BITS - 24)));
        Vec3::new(x, y, z)
    }
}
