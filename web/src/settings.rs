//! The settings of the page.

use kerchief::Material;
use kerchief::material::{BLANKET, DENIM, INTERLOCK, JACKET, PONTE_ROMA, RIB_KNIT, TABLECLOTH, TROUSERS};

/// A frame, s.
pub const FRAME: f64 = 1.0 / 60.0;
/// A side of the sheet, m.
pub const SIZE: f64 = 0.6;

/// The fabrics, in the order of the page.
pub const FABRICS: [Material; 8] = [DENIM, INTERLOCK, RIB_KNIT, PONTE_ROMA, TROUSERS, JACKET, TABLECLOTH, BLANKET];

/// A solver.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Solver {
    /// [`kerchief::Lines`]
    Lines,
    /// [`kerchief::Xpbd`]
    Xpbd,
    /// [`kerchief::Leapfrog`]
    Leapfrog,
    /// [`kerchief::BackwardEuler`]
    BackwardEuler,
    /// [`kerchief::Verlet`]
    Verlet,
    /// [`kerchief::ForwardEuler`]
    ForwardEuler,
}

impl Solver {
    /// Every solver, in the order of the page.
    pub const ALL: [Self; 6] =
        [Self::Lines, Self::Xpbd, Self::Leapfrog, Self::BackwardEuler, Self::Verlet, Self::ForwardEuler];

    /// Its name in the page's address.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Lines => "lines",
            Self::Xpbd => "xpbd",
            Self::Leapfrog => "leapfrog",
            Self::BackwardEuler => "backward-euler",
            Self::Verlet => "verlet",
            Self::ForwardEuler => "forward-euler",
        }
    }
}

/// A number type.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Number {
    /// 32-bit floating point.
    F32,
    /// 64-bit floating point.
    F64,
    /// [`kerchief::Q24`]
    Q24,
    /// [`kerchief::Q13`]
    Q13,
}

impl Number {
    /// Every number type, in the order of the page.
    pub const ALL: [Self; 4] = [Self::F32, Self::F64, Self::Q24, Self::Q13];
}

/// How a sheet starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Start {
    /// Laid flat, pinned at two corners.
    Corners,
    /// Hung, pinned at its upper edge.
    Curtain,
    /// Hung, pinned at its left edge.
    Flag,
    /// Laid flat above the ball, without pins.
    Ball,
}

impl Start {
    /// Every start, in the order of the page.
    pub const ALL: [Self; 4] = [Self::Corners, Self::Curtain, Self::Flag, Self::Ball];

    /// The centre of the ball, m.
    pub const fn ball(self) -> [f64; 3] {
        match self {
            Self::Corners => [0.0, -0.05, 0.2],
            Self::Curtain | Self::Flag => [0.0, 0.18, 0.3],
            Self::Ball => [0.0, 0.0, 0.22],
        }
    }
}

/// All settings of a sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Settings {
    /// Particles a side.
    pub side: usize,
    /// The number type.
    pub number: Number,
    /// The solver.
    pub solver: Solver,
    /// Substeps in a frame.
    pub substeps: u32,
    /// Sweeps in a substep, of solvers that have them; Newton steps of backward Euler.
    pub sweeps: u32,
    /// The start.
    pub start: Start,
    /// An index into [`FABRICS`].
    pub fabric: usize,
    /// Factor on the fabric's stiffness, for all springs.
    pub stiffness: f64,
    /// Whether the sheet has shear springs.
    pub shear: bool,
    /// Whether the sheet has bend springs.
    pub bend: bool,
    /// [`Material::damping`], s.
    pub damping: f64,
    /// Drag, 1/s.
    pub drag: f64,
    /// Wind speed, m/s.
    pub wind: f64,
    /// Direction towards which the wind blows, degrees: 0 is to the right, 90 away from the viewer.
    pub heading: f64,
    /// Inclination of gravity to the right, degrees.
    pub tilt: f64,
    /// Inclination of gravity away from the viewer, degrees.
    pub roll: f64,
    /// Whether there is a ball.
    pub ball: bool,
}

impl Settings {
    /// The settings at the page's start.
    pub const DEFAULT: Self = Self {
        side: 16,
        number: Number::F32,
        solver: Solver::Lines,
        substeps: 8,
        sweeps: 2,
        start: Start::Corners,
        fabric: 0,
        stiffness: 1.0,
        shear: true,
        bend: true,
        damping: 0.0,
        drag: 0.5,
        wind: 0.0,
        heading: 90.0,
        tilt: 0.0,
        roll: 0.0,
        ball: false,
    };

    /// Sets the parameter with this index in the list `PARAMETERS` of `engine.js`.
    pub fn set(&mut self, parameter: u32, value: f64) {
        let index = value as usize;
        match parameter {
            0 => self.side = index,
            1 => self.number = Number::ALL[index],
            2 => self.solver = Solver::ALL[index],
            3 => self.substeps = value as u32,
            4 => self.sweeps = value as u32,
            5 => self.start = Start::ALL[index],
            6 => self.fabric = index,
            7 => self.stiffness = value,
            8 => self.shear = index != 0,
            9 => self.bend = index != 0,
            10 => self.damping = value,
            11 => self.drag = value,
            12 => self.wind = value,
            13 => self.heading = value,
            14 => self.tilt = value,
            15 => self.roll = value,
            16 => self.ball = index != 0,
            _ => unreachable!("the page knows these parameters"),
        }
    }

    /// The fabric.
    pub const fn material(&self) -> Material {
        FABRICS[self.fabric]
    }

    /// Gravity, m/s².
    pub fn gravity(&self) -> [f64; 3] {
        let [tilt, roll] = [self.tilt, self.roll].map(f64::to_radians);
        let down = -9.81 * libm::cos(tilt);
        [9.81 * libm::sin(tilt), -down * libm::sin(roll), down * libm::cos(roll)]
    }

    /// The velocity of the air, m/s.
    pub fn air(&self) -> [f64; 3] {
        let heading = self.heading.to_radians();
        [self.wind * libm::cos(heading), self.wind * libm::sin(heading), 0.0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn gravity_keeps_its_strength_wherever_it_leans() {
        for (tilt, roll) in [(0.0, 0.0), (30.0, 0.0), (0.0, -50.0), (70.0, 20.0)] {
            let [x, y, z] = Settings { tilt, roll, ..Settings::DEFAULT }.gravity();
            assert!((libm::sqrt(x * x + y * y + z * z) - 9.81).abs() < 1e-12, "{tilt} {roll}");
            assert!(x * tilt >= 0.0 && y * roll >= 0.0 && z < 0.0, "{tilt} {roll}: {x} {y} {z}");
        }
    }
}
