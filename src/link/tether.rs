//! Tethers: no particle is further from a pin than its rest distance along the sheet (T.-Y. Kim, N. Chentanez, M. Müller-Fischer, *Long range attachments*,
//! 2012).
//!
//! They remove remaining super-elasticity cheaply, and bias positions by up to a few percent of the sheet. So they are an option, never a default.

use heapless::Vec;

use crate::fingerprint::Fingerprint;
use crate::grid::{Grid, Node};
use crate::link::{Directions, Links, Undamped};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::scalar::fit::{is_finite, is_not_negative};
use crate::units::Units;

/// Tethers from each particle to up to `N` pins.
#[derive(Clone, Debug, PartialEq)]
pub struct Tether<S, const N: usize> {
    anchors: Vec<Node, N>,
    sides: [S; 2],
}

impl<S: Scalar, const N: usize> Tether<S, N> {
    /// Tethers to `anchors`, each `1 + slack` times as long as the distance at rest. An anchor outside a sheet has no effect.
    ///
    /// # Errors
    /// Returns the anchors if there are more than `N`.
    ///
    /// # Panics
    /// If the slack is negative or not finite.
    #[track_caller]
    pub fn new<'a>(units: &Units, anchors: &'a [Node], slack: f64) -> Result<Self, &'a [Node]> {
        assert!(is_finite(slack) && is_not_negative(slack), "a slack is finite, zero or above");
        let slack = S::from_f64(slack);
        let sides = units.sides.map(|side| S::from_f64(side) * (S::ONE + slack));
        Vec::from_slice(anchors).map(|anchors| Self { anchors, sides }).map_err(|_| anchors)
    }
}

impl<S: Scalar, const N: usize> Links<S> for Tether<S, N> {
    type Directions = Directions<0>;
    type Damping = Undamped;

    fn fingerprint(&self, print: &mut Fingerprint) {
        print.numbers(self.sides);
        self.anchors.iter().for_each(|anchor| print.word((anchor.row << 16 | anchor.column) as u32));
    }

    fn confine<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, moment: Moment) {
        for &anchor in &self.anchors {
            // a released pin has no effect
            if anchor.column >= W || anchor.row >= H || !particles.is_pinned(anchor) {
                continue;
            }
            let pin = particles.position.at(anchor);
            for node in Grid::<S, W, H>::nodes() {
                if particles.is_pinned(node) {
                    continue;
                }
                let across = self.sides[0].times(node.column as i32 - anchor.column as i32);
                let down = self.sides[1].times(node.row as i32 - anchor.row as i32);
                let longest = across.product(across) + down.product(down);
                let d = pin - particles.position.at(node);
                let squared = d.squared();
                // a slack tether needs no root
                if squared > longest {
                    let part = S::ONE - S::root(longest).divide(S::root(squared));
                    particles.displace(node, d * part, moment);
                }
            }
        }
    }
}
