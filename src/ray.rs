//! Picking by a ray: the triangle that it hits, and the particle nearest to the hit.
//!
//! `Camera::ray` (feature `graphics`) makes the ray of a pixel; [`Ray::new`] makes the ray of any other camera. A [`Hand`](crate::Hand) can then drag the
//! particle that was hit:
//!
//! ```
//! # #[cfg(feature = "graphics")]
//! # fn main() {
//! use embedded_graphics::geometry::{Point, Size};
//! use kerchief::render::{Camera, View};
//! use kerchief::{Cloth, Node, Q24, Units};
//!
//! const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-4, 1.0 / 60.0, 8);
//! const VIEW: View = View::new(30.0, 20.0).at(UNITS.point([0.15, 0.0, 0.15]), UNITS.length(1.0));
//!
//! let cloth = Cloth::<Q24, 16, 16>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
//! let camera = Camera::new(&VIEW, Size::new(320, 240));
//! let pixel = camera.project(cloth.position.at(Node::new(4, 9))).unwrap();
//! let hit = camera.ray(pixel).hit(&cloth).unwrap();
//! assert_eq!(hit.node(), Node::new(4, 9));
//! assert!(camera.ray(Point::new(0, 0)).hit(&cloth).is_none());
//! # }
//! # #[cfg(not(feature = "graphics"))]
//! # fn main() {}
//! ```

use crate::grid::{Grid, Node};
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::Length;
use crate::vec3::Vec3;

/// A half-line that starts at the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ray<S> {
    /// A point on the line, cells. Not the eye, which may be beyond the range of fixed point.
    through: Vec3<S>,
    /// A unit vector away from the eye.
    forward: Vec3<S>,
    /// Two more unit vectors, perpendicular to the ray and to each other.
    across: [Vec3<S>; 2],
    /// The start of the ray, cells forward of `through`.
    start: S,
}

/// The first point at which a ray hits a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hit<S> {
    /// The corners of the triangle.
    pub corners: [Node; 3],
    /// The hit's position in the triangle: the weights of the corners, each from 0 to 1, with the sum 1.
    pub weights: [S; 3],
    /// The hit's position in the scene, cells.
    pub position: Vec3<S>,
}

impl<S: Scalar> Hit<S> {
    /// The corner with the largest weight: the particle nearest to the hit.
    pub fn node(&self) -> Node {
        let nearer = |a: usize, b: usize| if self.weights[b] > self.weights[a] { b } else { a };
        self.corners[nearer(nearer(0, 1), 2)]
    }
}

/// A position relative to a ray.
#[derive(Clone, Copy)]
struct Seen<S> {
    /// Offset from the line, cells.
    aside: [S; 2],
    /// Distance along the ray, cells.
    depth: S,
}

impl<S: Scalar> Ray<S> {
    /// The ray from a point (cells) in a direction of any length.
    ///
    /// # Panics
    /// If the direction has no length.
    #[track_caller]
    pub fn new(from: Vec3<S>, direction: Vec3<S>) -> Self {
        Self::line(from, direction, S::ZERO)
    }

    /// The line through a point; the ray starts `start` cells forward of it.
    #[track_caller]
    pub(crate) fn line(through: Vec3<S>, direction: Vec3<S>, start: S) -> Self {
        let forward = unit(direction);
        // the coordinate axis nearest to a perpendicular of the ray
        let [x, y, z] = [forward.x, forward.y, forward.z].map(S::abs);
        let axis = if x <= y && x <= z {
            Vec3::new(S::ONE, S::ZERO, S::ZERO)
        } else if y <= z {
            Vec3::new(S::ZERO, S::ONE, S::ZERO)
        } else {
            Vec3::new(S::ZERO, S::ZERO, S::ONE)
        };
        let right = unit(forward.cross(axis));
        Self { through, forward, across: [right, forward.cross(right)], start }
    }

    /// The direction, a unit vector.
    pub fn forward(&self) -> Vec3<S> {
        self.forward
    }

    /// The point of the whole line nearest to `point` (cells): the target of a dragged particle when the ray moves.
    pub fn foot(&self, point: Vec3<S>) -> Vec3<S> {
        self.through + self.forward * point.difference(self.through).dot(self.forward)
    }

    /// The first hit of the ray on a sheet, from either side; `None` if there is none. A chain has no triangles: use [`nearest`](Self::nearest).
    ///
    /// Every triangle is tested. No ray passes between two of them.
    pub fn hit<const W: usize, const H: usize>(&self, particles: &Particles<S, W, H>) -> Option<Hit<S>> {
        let mut first: Option<(S, [Node; 3], [S; 3])> = None;
        for row in 1..H {
            for column in 1..W {
                let [p, q, s, t] = [(1, 1), (0, 1), (1, 0), (0, 0)].map(|(left, up)| {
                    let node = Node::new(column - left, row - up);
                    (node, self.seen(particles.position.at(node)))
                });
                for corners in [[p, q, s], [q, t, s]] {
                    let Some(weights) = weights(corners.map(|(_, seen)| seen.aside)) else { continue };
                    let depth = (0..3).fold(S::ZERO, |depth, k| depth + corners[k].1.depth * weights[k]);
                    if depth >= self.start && first.is_none_or(|(nearest, ..)| depth < nearest) {
                        first = Some((depth, corners.map(|(node, _)| node), weights));
                    }
                }
            }
        }
        first.map(|(_, corners, weights)| {
            let [a, b, c] = corners.map(|node| particles.position.at(node));
            Hit { corners, weights, position: a + (b - a) * weights[1] + (c - a) * weights[2] }
        })
    }

    /// The particle that a pointer selects: the one nearest to the hit, or without a hit the one [nearest](Self::nearest) to the ray.
    pub fn pick<const W: usize, const H: usize>(&self, particles: &Particles<S, W, H>, within: Length) -> Option<Node> {
        self.hit(particles).map(|hit| hit.node()).or_else(|| self.nearest(particles, within))
    }

    /// The particle nearest to the ray, if it is nearer than `within`.
    pub fn nearest<const W: usize, const H: usize>(
        &self,
        particles: &Particles<S, W, H>,
        within: Length,
    ) -> Option<Node> {
        let Length(within) = within;
        let within = S::from_f64(within);
        let (mut nearest, mut least) = (None, within.product(within));
        for node in Grid::<S, W, H>::nodes() {
            let Seen { aside: [x, y], depth } = self.seen(particles.position.at(node));
            let squared = x.product(x) + y.product(y);
            if depth >= self.start && squared < least {
                (nearest, least) = (Some(node), squared);
            }
        }
        nearest
    }

    fn seen(&self, point: Vec3<S>) -> Seen<S> {
        let offset = point.difference(self.through);
        Seen { aside: self.across.map(|axis| offset.dot(axis)), depth: offset.dot(self.forward) }
    }
}

#[track_caller]
fn unit<S: Scalar>(vector: Vec3<S>) -> Vec3<S> {
    let length = vector.length();
    assert!(length > S::ZERO, "a ray has a direction");
    vector.map(|component| component.divide(length))
}

/// The weights of the corners for the origin, if it lies within the triangle or on its edge; otherwise `None`.
fn weights<S: Scalar>([a, b, c]: [[S; 2]; 3]) -> Option<[S; 3]> {
    around([a, b, c]).or_else(|| around([a, c, b]).map(|[a, c, b]| [a, b, c]))
}

/// [`weights`] for corners in counter-clockwise order.
fn around<S: Scalar>([a, b, c]: [[S; 2]; 3]) -> Option<[S; 3]> {
    // adds twice the area of the triangle of two corners and the origin to a sum: exact in fixed point, and of equal size for the triangle on the other side of
    // an edge, so that there is no gap between them
    let add =
        |sum: S::Sum, [x, y]: [S; 2], [u, v]: [S; 2]| S::accumulate(S::accumulate(sum, x.product(v)), (-y).product(u));
    let parts = [add(S::EMPTY, b, c), add(S::EMPTY, c, a), add(S::EMPTY, a, b)];
    let whole = add(add(parts[0], c, a), a, b);
    if parts.iter().all(|part| *part >= S::EMPTY) && whole > S::EMPTY {
        Some(parts.map(|part| S::quotient(part, whole)))
    } else {
        None
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cloth::Cloth;
    use crate::scalar::{Q13, Q24};
    use crate::units::Units;

    const UNITS: Units = Units::sheet([6, 5], [0.5, 0.4], 1e-3, 0.01, 4);

    type Sheet<S> = Cloth<S, 6, 5>;

    /// A flat sheet at a height of one cell.
    fn sheet<S: Scalar>() -> Sheet<S> {
        Cloth::lay(&UNITS, UNITS.point([0.0, 0.0, 0.1]))
    }

    fn vector<S: Scalar>(components: [f64; 3]) -> Vec3<S> {
        Vec3::from_f64(components)
    }

    fn hits_are_where_the_ray_goes<S: Scalar>(bound: f64) {
        let cloth = sheet::<S>();
        for (column, row) in [(0.3, 0.4), (0.8, 0.9), (4.9, 3.9), (2.0, 3.0), (0.0, 0.0), (5.0, 4.0), (3.4, 1.7)] {
            for (x, y, z) in [(0.0, 0.0, 5.0), (2.0, -3.0, 4.0), (-1.0, 2.0, -6.0), (40.0, 30.0, 50.0)] {
                let ray = Ray::<S>::new(vector([column + x, row + y, 1.0 + z]), vector([-x, -y, -z]));
                let expected = [column, row, 1.0];
                // on the sheet's border rounding decides
                let inner = column > 0.0 && column < 5.0;
                let Some(hit) = ray.hit(&cloth) else {
                    assert!(!inner, "{expected:?} in {}", S::NAME);
                    continue;
                };
                let [sum, total] = [hit.position.to_f64(), hit.weights.map(S::to_f64)];
                for k in 0..3 {
                    assert!((sum[k] - expected[k]).abs() < bound, "{expected:?} in {}: {hit:?}", S::NAME);
                }
                assert!((total.iter().sum::<f64>() - 1.0).abs() < 1e-6, "{total:?}");
                let nearest = Node::new(libm::round(column) as usize, libm::round(row) as usize);
                if (column - 0.5).fract() != 0.0 && (row - 0.5).fract() != 0.0 {
                    let far = |node: Node| libm::hypot(node.column as f64 - column, node.row as f64 - row);
                    assert!(far(hit.node()) < far(nearest) + 0.6, "{hit:?}");
                }
                let foot = ray.foot(hit.position);
                assert!((foot - hit.position).to_f64().iter().all(|x| x.abs() < bound), "{foot:?}");
            }
        }
    }

    #[test]
    fn hits_are_where_the_ray_goes_in_every_number_type() {
        hits_are_where_the_ray_goes::<f64>(1e-12);
        hits_are_where_the_ray_goes::<f32>(1e-4);
        hits_are_where_the_ray_goes::<Q24>(2e-5);
        hits_are_where_the_ray_goes::<Q13>(2e-5);
    }

    /// Rays through the edges between triangles, and through particles at which six triangles meet.
    #[test]
    fn no_ray_passes_between_triangles() {
        fn check<S: Scalar>() {
            let mut cloth = sheet::<S>();
            cloth.position.change(|place| place + vector(place.to_f64().map(|x| 0.2 * libm::sin(3.0 * x))));
            let eye = vector::<S>([2.3, 1.9, 9.0]);
            for row in 1..4 {
                for column in 1..5 {
                    let node = Node::new(column, row);
                    for next in [Node::new(column + 1, row), Node::new(column, row + 1), Node::new(column - 1, row + 1)]
                    {
                        for part in 0..8 {
                            let [a, b] = [node, next].map(|node| cloth.position.at(node));
                            let aim = a + (b - a) * S::from_int(part).divide(S::from_int(8));
                            assert!(Ray::new(eye, aim - eye).hit(&cloth).is_some(), "{node:?} {next:?} {part}");
                        }
                    }
                }
            }
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
    }

    #[test]
    fn the_first_of_two_layers_is_hit() {
        fn check<S: Scalar>() {
            let mut cloth = sheet::<S>();
            // folded over: columns 3 to 5 lie above columns 2 to 0
            for node in Grid::<S, 6, 5>::nodes().filter(|node| node.column > 2) {
                cloth.position.set(node, vector([5.0 - node.column as f64, node.row as f64, 2.0]));
            }
            let at = |height: f64, down: f64| Ray::new(vector([0.8, 2.3, height]), vector([0.0, 0.0, down]));
            assert_eq!(at(9.0, -1.0).hit(&cloth).unwrap().node(), Node::new(4, 2));
            assert_eq!(at(-9.0, 1.0).hit(&cloth).unwrap().node(), Node::new(1, 2));
            // from between the layers, up and down
            assert_eq!(at(1.5, 1.0).hit(&cloth).unwrap().node(), Node::new(4, 2));
            assert_eq!(at(1.5, -1.0).hit(&cloth).unwrap().node(), Node::new(1, 2));
            // no layer is in front of the eye
            assert_eq!(at(2.5, 1.0).hit(&cloth), None);
        }
        check::<f64>();
        check::<f32>();
        check::<Q24>();
        check::<Q13>();
    }

    #[test]
    fn beside_the_sheet_the_nearest_particle_is_found() {
        let cloth = sheet::<Q24>();
        let ray = Ray::<Q24>::new(vector([5.4, 2.2, 9.0]), vector([0.0, 0.0, -1.0]));
        assert_eq!(ray.hit(&cloth), None);
        assert_eq!(ray.nearest(&cloth, UNITS.length(0.05)), Some(Node::new(5, 2)));
        assert_eq!(ray.nearest(&cloth, UNITS.length(0.04)), None);
        assert_eq!(ray.pick(&cloth, UNITS.length(0.05)), Some(Node::new(5, 2)));
        let within = Ray::<Q24>::new(vector([3.4, 1.7, 9.0]), vector([0.0, 0.0, -1.0]));
        assert_eq!(within.pick(&cloth, UNITS.length(0.0)), Some(Node::new(3, 2)));
        let away = Ray::<Q24>::new(vector([5.4, 2.2, 9.0]), vector([0.0, 0.0, 1.0]));
        assert_eq!(away.nearest(&cloth, UNITS.length(0.05)), None);
        let units = Units::sheet([1, 8], [0.0, 0.7], 1e-3, 0.01, 4);
        let chain = Cloth::<f32, 1, 8>::hang(&units, units.point([0.0; 3]));
        let ray = Ray::<f32>::new(vector([0.2, -9.0, -3.2]), vector([0.0, 1.0, 0.0]));
        assert_eq!(ray.hit(&chain), None);
        assert_eq!(ray.nearest(&chain, units.length(0.05)), Some(Node::new(0, 3)));
    }

    #[test]
    fn what_is_undefined_is_not_hit() {
        let mut cloth = sheet::<f32>();
        cloth.position.change(|_| Vec3::new(f32::NAN, 0.0, 0.0));
        let ray = Ray::<f32>::new(vector([0.5, 0.5, 9.0]), vector([0.0, 0.0, -1.0]));
        assert_eq!((ray.hit(&cloth), ray.nearest(&cloth, UNITS.length(1.0))), (None, None));
        cloth.position.change(|_| Vec3::ZERO);
        assert_eq!(ray.hit(&cloth), None, "of no area");
    }

    #[test]
    #[should_panic(expected = "a ray has a direction")]
    fn a_ray_without_a_direction_is_refused() {
        let _ = Ray::<Q24>::new(Vec3::ZERO, Vec3::ZERO);
    }
}
