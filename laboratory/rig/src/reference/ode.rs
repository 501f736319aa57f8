//! The right-hand side of the equation of motion, and the quantities it conserves.

use super::vector::{Vector, add, cross, dot, norm, scale, sub};
use super::{Model, Wind};

/// Positions in m and velocities in m/s, by index.
#[derive(Clone, Debug)]
pub struct State {
    pub position: Vec<Vector>,
    pub velocity: Vec<Vector>,
}

struct Link {
    i: usize,
    j: usize,
    rest: f64,
    stiffness: f64,
    damping: f64,
}

/// A [`Model`] with its links and triangles listed.
pub struct Ode {
    links: Vec<Link>,
    cells: Vec<[usize; 4]>,
    triangles: Vec<[usize; 3]>,
    mass: Vec<f64>,
    pinned: Vec<bool>,
    gravity: Vector,
    drag: f64,
    wind: Option<Wind>,
    pub(super) size: f64,
}

impl Ode {
    pub fn new(model: &Model) -> Self {
        let sheet = &model.sheet;
        let start = sheet.positions();
        let mut links = Vec::new();
        for family in &model.families {
            for i in 0..sheet.particles() {
                for &offset in family.offsets {
                    if let Some(j) = sheet.neighbour(i, offset) {
                        let rest = norm(sub(start[i], start[j]));
                        links.push(Link { i, j, rest, stiffness: family.stiffness, damping: family.damping });
                    }
                }
            }
        }
        let cells = sheet.cells();
        let triangles = cells.iter().flat_map(|&[p, q, s, t]| [[q, p, s], [t, q, s]]).collect();
        let mut pinned = vec![false; sheet.particles()];
        for &pin in &sheet.pins {
            pinned[sheet.index(pin)] = true;
        }
        Self {
            links,
            cells,
            triangles,
            mass: sheet.masses.clone(),
            pinned,
            gravity: model.gravity,
            drag: model.drag,
            wind: model.wind.clone(),
            size: sheet.size(),
        }
    }

    /// Acceleration of every particle, m/s². The acceleration of a pin is zero: it rests, or keeps its initial velocity.
    pub fn acceleration(&self, state: &State, out: &mut [Vector]) {
        out.fill([0.0; 3]);
        self.add_link_forces(state, out);
        if let Some(wind) = &self.wind {
            self.add_wind_forces(wind, state, out);
        }
        for (i, a) in out.iter_mut().enumerate() {
            *a = if self.pinned[i] {
                [0.0; 3]
            } else {
                let field = sub(self.gravity, scale(self.drag, state.velocity[i]));
                add(field, scale(1.0 / self.mass[i], *a))
            };
        }
    }

    fn add_link_forces(&self, State { position, velocity }: &State, force: &mut [Vector]) {
        for &Link { i, j, rest, stiffness, damping } in &self.links {
            let d = sub(position[i], position[j]);
            let length = norm(d);
            let spring = scale(-stiffness * (length - rest) / length, d);
            let f = sub(spring, scale(damping, sub(velocity[i], velocity[j])));
            force[i] = add(force[i], f);
            force[j] = sub(force[j], f);
        }
    }

    fn add_wind_forces(&self, wind: &Wind, state: &State, force: &mut [Vector]) {
        let State { position, velocity } = state;
        if let Wind::Panel { velocity, density, drag_coefficient } = *wind {
            return self.add_panel_forces(velocity, density * drag_coefficient, state, force);
        }
        for &[a, b, c] in &self.triangles {
            let n = cross(sub(position[b], position[a]), sub(position[c], position[a]));
            let twice_area = norm(n);
            if twice_area == 0.0 {
                continue;
            }
            let unit = scale(1.0 / twice_area, n);
            let on_each_corner = match *wind {
                Wind::Facet(wind) => scale(dot(unit, wind), n),
                Wind::Aerodynamic { velocity: wind, density, drag_coefficient } => {
                    let mean = scale(1.0 / 3.0, add(add(velocity[a], velocity[b]), velocity[c]));
                    let across = dot(unit, sub(wind, mean));
                    let area = twice_area / 2.0;
                    scale(0.5 * density * drag_coefficient * area * across * across.abs() / 3.0, unit)
                }
                Wind::Panel { .. } => unreachable!("it presses on cells"),
            };
            for corner in [a, b, c] {
                force[corner] = add(force[corner], on_each_corner);
            }
        }
    }

    fn add_panel_forces(&self, wind: Vector, drag: f64, State { position, velocity }: &State, force: &mut [Vector]) {
        for &[p, q, s, t] in &self.cells {
            let vector_area = scale(0.5, cross(sub(position[t], position[p]), sub(position[s], position[q])));
            let area = norm(vector_area);
            if area == 0.0 {
                continue;
            }
            let unit = scale(1.0 / area, vector_area);
            let corners = [p, q, s, t];
            let sum = corners.iter().fold([0.0; 3], |sum, &corner| add(sum, velocity[corner]));
            let across = dot(unit, sub(wind, scale(0.25, sum)));
            let whole = scale(0.5 * drag * area * across * across.abs(), unit);
            for corner in corners {
                force[corner] = add(force[corner], scale(0.25, whole));
            }
        }
    }

    /// Bounds on the squared angular frequency (1/s²) and the damping rate (1/s) of any motion about a taut
    /// sheet, by Gershgorin's theorem: twice the sum of k/m and of `k_d/m` over the links of one particle.
    pub(super) fn fastest(&self) -> (f64, f64) {
        let mut bounds = vec![(0.0, 0.0); self.mass.len()];
        for link in &self.links {
            for i in [link.i, link.j] {
                if !self.pinned[i] {
                    bounds[i].0 += 2.0 * link.stiffness / self.mass[i];
                    bounds[i].1 += 2.0 * link.damping / self.mass[i];
                }
            }
        }
        let largest = bounds.iter().fold((0.0, 0.0), |m: (f64, f64), b| (m.0.max(b.0), m.1.max(b.1)));
        (largest.0, largest.1 + self.drag)
    }

    /// Sum of kinetic, elastic and gravitational energy, J. The gravitational energy is zero at the coordinate origin.
    pub fn energy(&self, State { position, velocity }: &State) -> f64 {
        let of_particle =
            |i: usize| self.mass[i] * (dot(velocity[i], velocity[i]) / 2.0 - dot(self.gravity, position[i]));
        let of_link = |link: &Link| {
            let stretch = norm(sub(position[link.i], position[link.j])) - link.rest;
            link.stiffness * stretch * stretch / 2.0
        };
        (0..self.mass.len()).map(of_particle).sum::<f64>() + self.links.iter().map(of_link).sum::<f64>()
    }

    /// Momentum, kg·m/s.
    pub fn momentum(&self, state: &State) -> Vector {
        let of = |i: usize| scale(self.mass[i], state.velocity[i]);
        (0..self.mass.len()).map(of).fold([0.0; 3], add)
    }

    /// Angular momentum about the coordinate origin, kg·m²/s.
    pub fn angular_momentum(&self, state: &State) -> Vector {
        let of = |i: usize| scale(self.mass[i], cross(state.position[i], state.velocity[i]));
        (0..self.mass.len()).map(of).fold([0.0; 3], add)
    }
}
