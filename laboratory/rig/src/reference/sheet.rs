//! The sheet before it moves: positions, masses and pins.

use super::vector::{Vector, add};

#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pose {
    /// Flat in the x-y plane, rows along y.
    Lay,
    /// Upright in the x-z plane, row 0 on top.
    Hang,
}

/// A grid of particles; particle (column, row) has the index `row * columns + column`.
#[derive(Clone, Debug)]
pub struct Sheet {
    pub columns: usize,
    pub rows: usize,
    /// m; ignored for a single column, as the height is for a single row.
    pub width: f64,
    pub height: f64,
    /// Start of particle (0, 0), m.
    pub origin: Vector,
    pub pose: Pose,
    /// Masses of the particles by index, kg.
    pub masses: Vec<f64>,
    /// Pinned particles as (column, row).
    pub pins: Vec<(usize, usize)>,
}

impl Sheet {
    /// A free sheet at the origin with 1 kg per particle.
    pub fn new(pose: Pose, [columns, rows]: [usize; 2], [width, height]: [f64; 2]) -> Self {
        let masses = vec![1.0; columns * rows];
        Self { columns, rows, width, height, origin: [0.0; 3], pose, masses, pins: Vec::new() }
    }

    #[must_use]
    pub fn with_origin(self, origin: Vector) -> Self {
        Self { origin, ..self }
    }

    /// The same mass for each particle, kg.
    #[must_use]
    pub fn with_mass(mut self, mass: f64) -> Self {
        self.masses.fill(mass);
        self
    }

    /// Masses from an area density, kg/m²: each cell gives a quarter of its mass to each of its corners.
    #[must_use]
    pub fn with_density(mut self, density: f64) -> Self {
        assert!(self.columns > 1 && self.rows > 1, "a chain has no area");
        let [width, height] = self.cell();
        self.masses.fill(0.0);
        for corners in self.cells() {
            for i in corners {
                self.masses[i] += density * width * height / 4.0;
            }
        }
        self
    }

    /// Multiplies the masses of border particles by `factor`.
    #[must_use]
    pub fn with_hem(mut self, factor: f64) -> Self {
        for row in 0..self.rows {
            for column in 0..self.columns {
                if row == 0 || column == 0 || row + 1 == self.rows || column + 1 == self.columns {
                    self.masses[row * self.columns + column] *= factor;
                }
            }
        }
        self
    }

    #[must_use]
    pub fn with_pins(mut self, pins: &[(usize, usize)]) -> Self {
        self.pins.extend_from_slice(pins);
        self
    }

    /// Pins row 0.
    #[must_use]
    pub fn with_top_pinned(mut self) -> Self {
        self.pins.extend((0..self.columns).map(|column| (column, 0)));
        self
    }

    /// Pins column 0.
    #[must_use]
    pub fn with_left_pinned(mut self) -> Self {
        self.pins.extend((0..self.rows).map(|row| (0, row)));
        self
    }

    pub fn particles(&self) -> usize {
        self.columns * self.rows
    }

    pub fn index(&self, (column, row): (usize, usize)) -> usize {
        assert!(column < self.columns && row < self.rows, "({column}, {row}) is outside the grid");
        row * self.columns + column
    }

    /// The index of the particle at an offset (columns, rows) from particle `i`, if the grid has one.
    pub fn neighbour(&self, i: usize, (right, down): (i32, i32)) -> Option<usize> {
        let column = (i % self.columns).checked_add_signed(right as isize).filter(|&c| c < self.columns)?;
        let row = (i / self.columns).checked_add_signed(down as isize).filter(|&r| r < self.rows)?;
        Some(self.index((column, row)))
    }

    /// Width and height of a cell, m; 0 along a direction without cells.
    pub fn cell(&self) -> [f64; 2] {
        let spacing = |extent: f64, count: usize| if count > 1 { extent / (count - 1) as f64 } else { 0.0 };
        [spacing(self.width, self.columns), spacing(self.height, self.rows)]
    }

    /// The longer side, m: the unit of position errors.
    pub fn size(&self) -> f64 {
        let [width, height] = self.cell();
        (width * (self.columns - 1) as f64).max(height * (self.rows - 1) as f64)
    }

    /// Corner indices [p, q, s, t] of every cell: (c, r), (c+1, r), (c, r+1), (c+1, r+1).
    pub fn cells(&self) -> Vec<[usize; 4]> {
        let mut cells = Vec::new();
        for row in 1..self.rows {
            for column in 1..self.columns {
                let t = row * self.columns + column;
                cells.push([t - self.columns - 1, t - self.columns, t - 1, t]);
            }
        }
        cells
    }

    /// Start positions of all particles, by index, m.
    pub fn positions(&self) -> Vec<Vector> {
        let [width, height] = self.cell();
        let place = |i: usize| {
            let (along, down) = ((i % self.columns) as f64 * width, (i / self.columns) as f64 * height);
            add(self.origin, if self.pose == Pose::Lay { [along, down, 0.0] } else { [along, 0.0, -down] })
        };
        (0..self.particles()).map(place).collect()
    }
}
