//! Bounds of particles while they move on at their velocities.

use core::ops::Range;

use crate::grid::Node;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::vec3::Vec3;

use super::extent::Extent;
use super::tiling::{Tiling, inside};

/// Particles, and the time for which their motion is bounded.
#[derive(Clone, Copy)]
pub(super) struct Sweep<'a, S, const W: usize, const H: usize> {
    particles: &'a Particles<S, W, H>,
    /// The time is a tick, so many times halved.
    halvings: u32,
}

impl<'a, S: Scalar, const W: usize, const H: usize> Sweep<'a, S, W, H> {
    pub(super) fn new(particles: &'a Particles<S, W, H>, halvings: u32) -> Self {
        Self { particles, halvings }
    }

    /// The box of a particle's way.
    pub(super) fn place(self, node: Node) -> Extent {
        let node = inside::<W, H>(node);
        let now = self.particles.position.at(node);
        let then = now + self.particles.velocity.at(node).halve(self.halvings);
        let along = |now: S, then: S| outwards([now.min(then), now.max(then)]);
        let [x, y, z] = [along(now.x, then.x), along(now.y, then.y), along(now.z, then.z)];
        Extent { low: [x[0], y[0], z[0]], high: [x[1], y[1], z[1]] }
    }

    /// Bounds the tiles in a row of tiles, and the edges that start there. `bound(tile, axis, spans)` gets the spans of places, of edges along rows and of edges down columns.
    /// A chain has no cells, and its spans of edges are empty.
    pub(super) fn tiles(self, row: usize, mut bound: impl FnMut(usize, usize, [[i32; 2]; 3])) {
        let first = row * Tiling::<W, H>::ACROSS;
        let rows = Tiling::<W, H>::tile(first).rows;
        for axis in 0..3 {
            let [places, across, down] = self.columns(axis, rows.start, rows.end);
            for tile in first..first + Tiling::<W, H>::ACROSS {
                let Range { start, end } = Tiling::<W, H>::tile(tile).columns;
                let cells = const { W > 1 && H > 1 };
                let edges = if cells {
                    // for the last column, the edges that lead to it
                    [across.within(start.min(W - 2), end.min(W - 1)), down.within(start, end)]
                } else {
                    [[i32::MAX, i32::MIN]; 2]
                };
                bound(tile, axis, [places.within(start, end), edges[0], edges[1]]);
            }
        }
    }

    /// The spans of some rows, column by column: of places along an axis, of edges along rows, and of edges down columns.
    fn columns(self, axis: usize, first: usize, end: usize) -> [Span<S, W>; 3] {
        let row = |row: usize| Line {
            place: component(&self.particles.position.0[row.min(H - 1)], axis),
            velocity: component(&self.particles.velocity.0[row.min(H - 1)], axis),
            halvings: self.halvings,
        };
        // for the last row, the edges that lead down to it
        let upper = |row: usize| if row + 1 < H { row } else { row.saturating_sub(1) };
        let mut spans = [Span::NONE; 3];
        let [places, across, down] = &mut spans;
        let (begin, above) = (row(first), upper(first));
        let below = row((above + 1).min(H - 1));
        for column in 0..W {
            places.start(column, begin.way(column));
            across.start(column, begin.edge((column + 1).min(W - 1), &begin, column));
            down.start(column, below.edge(column, &row(above), column));
        }
        for index in first..end {
            let above = upper(index);
            row(index).take(&row(above), &row((above + 1).min(H - 1)), places, across, down);
        }
        spans
    }
}

/// The components of a row along an axis.
struct Line<'a, S, const W: usize> {
    place: &'a [S; W],
    velocity: &'a [S; W],
    halvings: u32,
}

impl<S: Scalar, const W: usize> Line<'_, S, W> {
    /// A particle's place now and at the end.
    #[inline(always)]
    fn way(&self, column: usize) -> [S; 2] {
        [self.place[column], self.place[column] + self.velocity[column].halve(self.halvings)]
    }

    /// The edge from a particle of another row to one of this row, now and at the end.
    #[inline(always)]
    fn edge(&self, column: usize, other: &Self, from: usize) -> [S; 2] {
        let ([now, then], [start, start_then]) = (self.way(column), other.way(from));
        [now - start, then - start_then]
    }

    /// Extends the spans by the row's places and edges, and by the edges between two rows.
    #[inline(never)] // so that the compiler knows that rows and spans don't alias
    fn take(
        &self,
        above: &Self,
        below: &Self,
        places: &mut Span<S, W>,
        across: &mut Span<S, W>,
        down: &mut Span<S, W>,
    ) {
        for column in 0..W {
            places.take(column, self.way(column));
        }
        for column in 1..W {
            across.take(column - 1, self.edge(column, self, column - 1));
        }
        for column in 0..W {
            down.take(column, below.edge(column, above, column));
        }
    }
}

/// The least and the largest number of each column.
#[derive(Clone, Copy)]
struct Span<S, const W: usize> {
    low: [S; W],
    high: [S; W],
}

impl<S: Scalar, const W: usize> Span<S, W> {
    const NONE: Self = Self { low: [S::ZERO; W], high: [S::ZERO; W] };

    #[inline(always)]
    fn start(&mut self, column: usize, [now, _]: [S; 2]) {
        (self.low[column], self.high[column]) = (now, now);
    }

    #[inline(always)]
    fn take(&mut self, column: usize, [now, then]: [S; 2]) {
        self.low[column] = self.low[column].min(now.min(then));
        self.high[column] = self.high[column].max(now.max(then));
    }

    /// The span of some columns together, at least one.
    fn within(&self, from: usize, end: usize) -> [i32; 2] {
        let of = |numbers: &[S; W], choose: fn(S, S) -> S| {
            let some = numbers.get(from..end).unwrap_or_default();
            some.iter().copied().reduce(choose).unwrap_or(S::ZERO)
        };
        outwards([of(&self.low, S::min), of(&self.high, S::max)])
    }
}

/// A span in coarse numbers, rounded outwards.
fn outwards<S: Scalar>([low, high]: [S; 2]) -> [i32; 2] {
    [low.coarse().saturating_sub(1), high.coarse().saturating_add(1)]
}

/// The largest difference of two velocities along an axis, cells per tick.
#[inline(never)]
pub(super) fn spread<S: Scalar, const W: usize, const H: usize>(particles: &Particles<S, W, H>) -> S {
    let mut largest = S::ZERO;
    for axis in 0..3 {
        let first = *component(&particles.velocity.0[0], axis);
        let mut span = Span { low: first, high: first };
        for row in &particles.velocity.0 {
            let velocity = component(row, axis);
            for column in 0..W {
                span.low[column] = span.low[column].min(velocity[column]);
                span.high[column] = span.high[column].max(velocity[column]);
            }
        }
        let low = span.low.into_iter().fold(span.low[0], S::min);
        let high = span.high.into_iter().fold(span.high[0], S::max);
        largest = largest.max(high.difference(low));
    }
    largest
}

#[inline(always)]
fn component<S, const W: usize>(row: &Vec3<[S; W]>, axis: usize) -> &[S; W] {
    match axis {
        0 => &row.x,
        1 => &row.y,
        _ => &row.z,
    }
}
