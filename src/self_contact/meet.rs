//! Contacts between particles.
//!
//! Two particles that are closer than the thickness d are moved apart along the line between them until they are d apart. Friction undoes their sliding past each other in this
//! substep, up to the coefficient times the depth. Heavier particles move less; equal ones move by the same, so that momentum is kept to the bit in fixed point.
//!
//! An approach within the substep is undone at once. Particles that were too close before are moved apart by 2·d a frame at most, so that none is thrown.

use crate::collider::{Contact, Meeting};
use crate::grid::Node;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

use super::Law;
use super::near::{List, Pair, each_pair};
use super::tiling::{Patch, Tiling, inside};

/// Moves particles in contact apart, in the quads of the list. Returns the number of pairs in contact.
pub(super) fn meet<S: Scalar, const W: usize, const H: usize>(
    law: &Law<S>,
    list: List<'_>,
    particles: &mut Particles<S, W, H>,
    meeting: &mut impl Meeting<S, W, H>,
) -> u32 {
    let slow = law.slow(meeting.moment().shift);
    let mut apart = Apart { law, slow, particles, meeting, contacts: 0 };
    for &pair in list.pairs {
        apart.tiles(pair);
    }
    if let Some([a, b]) = list.beyond {
        let first = [usize::from(a), usize::from(b)];
        let mut found = false;
        each_pair::<W, H>(|a, b| {
            found |= [a, b] == first;
            if found {
                apart.tiles(Pair { tiles: [a as u8, b as u8], quads: u16::MAX });
            }
            true
        });
    }
    apart.contacts
}

/// Two by two particles, or fewer at the sheet's border.
#[derive(Clone, Copy)]
struct Block {
    nodes: [Node; 4],
    count: usize,
}

/// The x, y and z of a block's particles; in a block with fewer, the last one is repeated.
type Places<S> = [[S; 4]; 3];

impl Block {
    #[inline(always)]
    fn new<const W: usize, const H: usize>(column: usize, row: usize) -> Self {
        let node = |right, down| Node { column: column + right, row: row + down };
        let nodes = match [column + 1 < W, row + 1 < H] {
            [true, true] => return Self { nodes: [node(0, 0), node(1, 0), node(0, 1), node(1, 1)], count: 4 },
            [true, false] => [node(0, 0), node(1, 0)],
            [false, true] => [node(0, 0), node(0, 1)],
            [false, false] => return Self { nodes: [node(0, 0); 4], count: 1 },
        };
        Self { nodes: [nodes[0], nodes[1], nodes[1], nodes[1]], count: 2 }
    }

    #[inline(always)]
    fn places<S: Scalar, const W: usize, const H: usize>(&self, particles: &Particles<S, W, H>) -> Places<S> {
        let [a, b, c, d] = self.nodes.map(|node| particles.position.at(inside::<W, H>(node)));
        [[a.x, b.x, c.x, d.x], [a.y, b.y, c.y, d.y], [a.z, b.z, c.z, d.z]]
    }
}

/// The blocks of a patch.
#[inline(always)]
fn blocks<const W: usize, const H: usize>(patch: &Patch) -> impl Iterator<Item = Block> + use<W, H> {
    let columns = patch.columns.clone();
    patch
        .rows
        .clone()
        .step_by(2)
        .flat_map(move |row| columns.clone().step_by(2).map(move |column| Block::new::<W, H>(column, row)))
}

/// Whether a place is closer than d to one of four.
#[inline(always)]
fn is_close<S: Scalar>(at: Vec3<S>, places: &Places<S>, d: S) -> bool {
    let [x, y, z] = places;
    S::any_shorter(|lane| [at.x - x[lane], at.y - y[lane], at.z - z[lane]], d)
}

struct Apart<'a, S: Scalar, M, const W: usize, const H: usize> {
    law: &'a Law<S>,
    /// The most by which particles are moved apart beyond their approach in this substep.
    slow: S,
    particles: &'a mut Particles<S, W, H>,
    meeting: &'a mut M,
    contacts: u32,
}

impl<S: Scalar, M: Meeting<S, W, H>, const W: usize, const H: usize> Apart<'_, S, M, W, H> {
    fn tiles(&mut self, pair: Pair) {
        let [a, b] = pair.tiles.map(usize::from);
        let mut left = pair.quads;
        while left != 0 {
            let bit = left.trailing_zeros() as usize;
            left &= left - 1;
            let (i, j) = (bit / 4, bit % 4);
            // a quad and itself, or one with another: each pair once
            if a != b || i <= j {
                self.quads([a, i], [b, j]);
            }
        }
    }

    fn quads(&mut self, a: [usize; 2], b: [usize; 2]) {
        let [first, second] = [a, b].map(|[tile, quad]| Tiling::<W, H>::quad(tile, quad));
        for (i, block) in blocks::<W, H>(&first).enumerate() {
            for (j, other) in blocks::<W, H>(&second).enumerate() {
                if a != b || i <= j {
                    self.blocks(&block, &other, a == b && i == j);
                }
            }
        }
    }

    #[inline(always)]
    fn blocks(&mut self, first: &Block, second: &Block, same: bool) {
        let (mut at, mut places) = (first.places(self.particles), second.places(self.particles));
        for i in 0..4 {
            if i >= first.count || !is_close(Vec3::new(at[0][i], at[1][i], at[2][i]), &places, self.law.rest.length) {
                continue;
            }
            for j in 0..4 {
                if j < second.count && !(same && j <= i) {
                    self.particles(inside::<W, H>(first.nodes[i]), inside::<W, H>(second.nodes[j]));
                }
            }
            (at, places) = (first.places(self.particles), second.places(self.particles));
        }
    }

    #[inline(always)]
    fn particles(&mut self, i: Node, j: Node) {
        let d = self.law.rest.length;
        let r = self.particles.position.at(i) - self.particles.position.at(j);
        if r.squared() < d.product(d) && !self.law.joins(i, j) {
            self.contact(i, j, r);
        }
    }

    #[inline(never)] // seldom called
    fn contact(&mut self, i: Node, j: Node, r: Vec3<S>) {
        let [i, j] = [i, j].map(inside::<W, H>);
        let [wi, wj] = [i, j].map(|node| self.particles.inverse_mass[node]);
        if wi == S::ZERO && wj == S::ZERO {
            return;
        }
        self.contacts += 1;
        let (excess, normal) = r.direction(&self.law.rest);
        let moved = self.meeting.moved(self.particles, i) - self.meeting.moved(self.particles, j);
        let came = (-moved.dot(normal)).max(S::ZERO);
        let depth = (-excess).min(came + self.slow);
        let by = normal * depth - self.rubbed(moved, normal, depth);
        let velocity = self.particles.velocity.at(j);
        let contact = Contact { by, normal, depth, velocity, friction: self.law.friction };
        self.meeting.separate(self.particles, [i, j], &contact);
    }

    /// The part of a relative displacement that friction undoes.
    fn rubbed(&self, moved: Vec3<S>, normal: Vec3<S>, depth: S) -> Vec3<S> {
        let friction = self.law.friction;
        if friction == S::ZERO {
            return Vec3::ZERO;
        }
        let along = moved - normal * moved.dot(normal);
        let grip = S::narrow(friction.product(depth));
        // most contacts stick, which needs no root
        if along.squared() <= grip.product(grip) { along } else { along * grip.divide(along.length()) }
    }
}
