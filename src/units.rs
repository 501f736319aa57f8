//! The sheet's own units, and their conversion from and to SI.
//!
//! The core measures lengths in cells, times in ticks and masses in particles, so that the numbers it computes with are near one. A tick is a power of two of
//! substeps, about one frame. A drift `x += v·h` is then a shift, and velocities keep their bits for any substep length.
//!
//! Every method of [`Units`] that converts from SI is a `const fn`: firmware evaluates it at compile time and links no float routine.
//!
//! Invalid values are rejected here, so that a step needs no check: a size that is not positive, a number that is not finite, a negative stiffness. The
//! rejection is a compiler error in a constant and a panic elsewhere. A value that a number type does not represent to within a sixteenth is rejected where it
//! gets its type, as by [`Gravity::new`](crate::Gravity::new), or in a constant by `fits`:
//!
//! ```
//! use kerchief::units::Acceleration;
//! use kerchief::{Q24, Units};
//!
//! const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
//! const WEIGHT: Acceleration = UNITS.acceleration([0.0, 0.0, -9.81]).fits::<Q24>();
//! assert_eq!(WEIGHT, UNITS.acceleration([0.0, 0.0, -9.81]));
//! ```
//!
//! ```
//! use kerchief::Units;
//!
//! const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
//! assert_eq!(UNITS.cell, 0.02);
//! ```

use crate::scalar::Scalar;
use crate::scalar::fit::{Fit, fit, is_finite, is_in_range, is_not_negative, is_positive};
use crate::vec3::Vec3;

/// Limit on the substeps of a frame. With 2²⁴ of them one substep is the last place of a tick, in fixed point and in `f32`.
const MOST_SUBSTEPS: u32 = 1 << 24;

/// Limit of the facet model: the largest part of the wind's speed normal to a triangle that a corner of mass 1 gains in a substep. Half this value would weaken
/// wind in light sheets that are moved once a frame.
const MOST_OF_WIND: f64 = 1.0 / 3.0;

/// The length of a cell, of a tick and the mass of a particle, and the division of a frame into substeps.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Units {
    /// The longer side of a cell, m.
    pub cell: f64,
    /// The sides of a cell along a row and along a column, in cells: one of them is 1.
    pub sides: [f64; 2],
    /// The unit of mass: the mass of a particle whose inverse mass is 1, kg.
    pub mass: f64,
    /// A frame, s.
    pub frame: f64,
    /// Solver steps per frame.
    pub substeps: u32,
}

/// Lengths from the origin, cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point(pub [f64; 3]);

/// A length, cells.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Length(pub f64);

/// A velocity, cells per tick. Only [`Units::velocity`] makes one, so that metres per second are not mistaken for it.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Velocity(pub [f64; 3]);

/// The velocity change by an acceleration in a substep, cells per tick. Only [`Units::acceleration`] makes one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub struct Acceleration(pub [f64; 3]);

/// A spring's stiffness κ, or a damper's strength, relative to the inertia of a particle in one substep. It is stored as the quotient `dividend / divisor` of
/// two numbers between 0 and 1: so any material fits any number type.
///
/// κ = k·h²/m for a stiffness k, κ = d·h/m for a damping d.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Strength {
    /// min(κ, 1)
    pub dividend: f64,
    /// min(1/κ, 1)
    pub divisor: f64,
}

/// The effect of drag γ on a velocity in a substep h.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DragRate {
    /// γ·h
    pub rate: f64,
    /// exp(−γ·h)
    pub decay: f64,
    /// (1 − exp(−γ·h))/(γ·h)
    pub gain: f64,
}

/// A wind's velocity and the strength of its pressure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Airflow {
    /// For the facet model the velocity change per cell², for the aerodynamic model the velocity in cells per tick.
    pub wind: [f64; 3],
    /// The aerodynamic model's factor; unused by the facet model.
    pub pressure: f64,
    /// The facet model's limit on |n|, cells²: see [`FacetWind::widest`](crate::FacetWind::widest). Unused by the aerodynamic model.
    pub widest: f64,
}

/// A wind's velocity, the strength of its pressure on panels, and a panel's area at rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PanelFlow {
    /// The velocity of the air, cells per tick.
    pub wind: [f64; 3],
    /// The velocity that each corner of a panel of 1 cell² gains in a substep if the panel moves against the air at one cell per tick.
    pub pressure: f64,
    /// The area of a panel at rest, cells².
    pub area: f64,
}

impl Units {
    /// The units of a sheet of `[columns, rows]` particles and `[width, height]` (m). A particle of inverse mass 1 has `mass` (kg). The sheet moves in frames
    /// of `frame` seconds, divided into `substeps`.
    ///
    /// The size along a side with a single particle is ignored.
    ///
    /// # Panics
    /// At compile time in a constant: for a sheet whose size, mass or frame is not positive and finite, and for no substeps or more than 2²⁴.
    #[track_caller]
    pub const fn sheet(particles: [usize; 2], size: [f64; 2], mass: f64, frame: f64, substeps: u32) -> Self {
        let (across, down) = (spacing(particles[0], size[0]), spacing(particles[1], size[1]));
        let cell = if across > down { across } else { down };
        assert!(cell > 0.0, "a sheet needs two particles and a positive size");
        assert!(is_finite(cell), "a sheet needs a finite size");
        assert!(is_positive(mass), "a particle needs a positive mass");
        assert!(is_positive(frame) && substeps > 0, "a frame needs a positive length and one substep at least");
        let units = Self { cell, sides: [across / cell, down / cell], mass, frame, substeps };
        units.check_substeps();
        units
    }

    /// Rejects units put together by hand whose number of substeps no solver can count.
    #[track_caller]
    pub(crate) const fn check_substeps(&self) {
        assert!(self.substeps > 0, "a frame needs a positive length and one substep at least");
        assert!(self.substeps <= MOST_SUBSTEPS, "a frame has at most 16777216 substeps");
    }

    /// A substep, s.
    pub const fn substep(&self) -> f64 {
        self.frame / self.substeps as f64
    }

    /// The logarithm to base 2 of the substeps in a tick, which are the smallest power of two that covers a frame.
    pub const fn shift(&self) -> u32 {
        self.substeps.next_power_of_two().trailing_zeros()
    }

    /// A tick, s: about one frame, exactly one where `substeps` is a power of two.
    pub const fn tick(&self) -> f64 {
        self.substep() * (1_u64 << self.shift()) as f64
    }

    /// A length in m.
    ///
    /// # Panics
    /// At compile time in a constant, as all methods below: for values that are not finite.
    #[track_caller]
    pub const fn length(&self, metres: f64) -> Length {
        check([metres]);
        Length(metres / self.cell)
    }

    /// A position in m.
    #[track_caller]
    pub const fn point(&self, metres: [f64; 3]) -> Point {
        check(metres);
        self.place(metres)
    }

    /// [`point`](Self::point) without its check: an exploded sheet has positions that are not finite.
    pub(crate) const fn place(&self, metres: [f64; 3]) -> Point {
        Point(scaled(metres, 1.0 / self.cell))
    }

    /// [`velocity`](Self::velocity) without its check, for the same reason.
    pub(crate) const fn motion(&self, metres_per_second: [f64; 3]) -> Velocity {
        Velocity(scaled(metres_per_second, self.tick() / self.cell))
    }

    /// A velocity in m/s.
    #[track_caller]
    pub const fn velocity(&self, metres_per_second: [f64; 3]) -> Velocity {
        check(metres_per_second);
        self.motion(metres_per_second)
    }

    /// A position (cells) in m: the inverse of [`point`](Self::point). Undefined components stay undefined.
    ///
    /// ```
    /// use kerchief::{Cloth, Node, Q24, Units};
    ///
    /// const UNITS: Units = Units::sheet([16, 16], [0.3, 0.3], 1e-3, 1.0 / 60.0, 8);
    /// let cloth = Cloth::<Q24, 16, 16>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.5]));
    /// let [x, _, z] = UNITS.metres(cloth.position.at(Node::new(15, 0)));
    /// assert!((x - 0.3).abs() < 1e-8 && (z - 0.5).abs() < 1e-8);
    /// ```
    pub fn metres<S: Scalar>(&self, place: Vec3<S>) -> [f64; 3] {
        scaled(place.to_f64(), self.cell)
    }

    /// A velocity (cells per tick) in m/s: the inverse of [`velocity`](Self::velocity).
    pub fn metres_per_second<S: Scalar>(&self, velocity: Vec3<S>) -> [f64; 3] {
        scaled(velocity.to_f64(), self.cell / self.tick())
    }

    /// An acceleration in m/s².
    #[track_caller]
    pub const fn acceleration(&self, metres_per_second2: [f64; 3]) -> Acceleration {
        check(metres_per_second2);
        Acceleration(scaled(metres_per_second2, self.substep() * self.tick() / self.cell))
    }

    /// A spring's stiffness in N/m; infinity is rigid.
    ///
    /// # Panics
    /// At compile time in a constant: if it is negative or undefined.
    #[track_caller]
    pub const fn stiffness(&self, newtons_per_metre: f64) -> Strength {
        assert!(is_not_negative(newtons_per_metre), "a stiffness is zero or above");
        Strength::new(newtons_per_metre * self.substep() * self.substep() / self.mass)
    }

    /// A spring's compliance in m/N; zero is rigid.
    ///
    /// # Panics
    /// At compile time in a constant: if it is negative or undefined.
    #[track_caller]
    pub const fn compliance(&self, metres_per_newton: f64) -> Strength {
        assert!(is_not_negative(metres_per_newton), "a compliance is zero or above");
        if metres_per_newton == 0.0 {
            return Strength { dividend: 1.0, divisor: 0.0 };
        }
        self.stiffness(1.0 / metres_per_newton)
    }

    /// A link's damping in N·s/m.
    ///
    /// # Panics
    /// At compile time in a constant: if it is negative or undefined.
    #[track_caller]
    pub const fn damping(&self, newton_seconds_per_metre: f64) -> Strength {
        assert!(is_not_negative(newton_seconds_per_metre), "a damping is zero or above");
        Strength::new(newton_seconds_per_metre * self.substep() / self.mass)
    }

    /// A sheet's drag γ in 1/s.
    ///
    /// # Panics
    /// At compile time in a constant: if it is negative or not finite.
    #[track_caller]
    pub const fn drag(&self, per_second: f64) -> DragRate {
        assert!(is_finite(per_second) && is_not_negative(per_second), "a drag is finite, zero or above");
        let rate = per_second * self.substep();
        let decay = exp_minus(rate);
        // where the quotient loses digits by cancellation, its series does not
        let gain = if rate < 1e-4 { 1.0 - rate / 2.0 + rate * rate / 6.0 } else { (1.0 - decay) / rate };
        DragRate { rate, decay, gain }
    }

    /// The drag that multiplies the displacement of a frame by `1 − fraction`, `0 ≤ fraction < 1`: the damping factor of position Verlet.
    ///
    /// # Panics
    /// At compile time in a constant: for any other fraction.
    #[track_caller]
    pub const fn verlet_damping(&self, fraction: f64) -> DragRate {
        assert!(fraction >= 0.0 && fraction < 1.0, "a damping factor is at least 0 and below 1");
        self.drag(minus_ln(1.0 - fraction) / self.frame)
    }

    /// Wind of the facet model, m/s.
    #[track_caller]
    pub const fn facet_wind(&self, metres_per_second: [f64; 3]) -> Airflow {
        check(metres_per_second);
        let gain = self.cell * self.substep() * self.tick() / self.mass;
        // the part of the wind's normal speed that a corner gains from a triangle of |n| = 1
        let part = self.cell * self.cell * self.substep() / self.mass;
        Airflow { wind: scaled(metres_per_second, gain), pressure: 0.0, widest: MOST_OF_WIND / part }
    }

    /// Wind of the aerodynamic model: its velocity in m/s, the air's density in kg/m³, the drag coefficient of a plate across the flow.
    ///
    /// # Panics
    /// At compile time in a constant: for values that are not finite, and if density or coefficient is negative.
    #[track_caller]
    pub const fn aerodynamic_wind(&self, metres_per_second: [f64; 3], density: f64, drag_coefficient: f64) -> Airflow {
        check([density, drag_coefficient]);
        assert!(is_not_negative(density), "a density is zero or above");
        assert!(is_not_negative(drag_coefficient), "a drag coefficient is zero or above");
        // ½·ρ·c·A·u², A = |n|/2 for the triangle's normal n = (b−a)×(c−a), a third of it on each corner
        let wind = self.velocity(metres_per_second).0;
        let pressure = density * drag_coefficient * self.cell * self.cell * self.cell * self.substep()
            / (12.0 * self.mass * self.tick());
        Airflow { wind, pressure, widest: 0.0 }
    }

    /// Wind on panels: its velocity in m/s, the air's density in kg/m³, the drag coefficient of a plate across the flow.
    ///
    /// # Panics
    /// At compile time in a constant: for values that are not finite, and if density or coefficient is negative.
    #[track_caller]
    pub const fn panel_wind(&self, metres_per_second: [f64; 3], density: f64, drag_coefficient: f64) -> PanelFlow {
        let Airflow { wind, pressure, .. } = self.aerodynamic_wind(metres_per_second, density, drag_coefficient);
        // a cell's area is |n|, twice that of a triangle; each of its corners has a quarter of the force instead of a third
        let area = self.sides[0] * self.sides[1];
        PanelFlow { wind, pressure: 1.5 * pressure, area: if area > 0.0 { area } else { 1.0 } }
    }
}

/// Rejects values that `S` does not represent.
#[track_caller]
#[inline(always)]
pub(crate) const fn check_fit<S: Scalar, const N: usize>(values: [f64; N]) {
    match fit::<S, N>(values) {
        Fit::Well => {}
        Fit::TooLarge => panic!("a constant of the scene is not finite, or too large for its number type"),
        Fit::AsZero | Fit::Coarsely => panic!(
            "a constant of the scene is too small for its number type, which would change it by more than a sixteenth: take fewer substeps or a float"
        ),
    }
}

impl Velocity {
    /// The same velocity, which `S` represents.
    ///
    /// # Panics
    /// At compile time in a constant: where rounding would change it by more than a sixteenth, or `S` has no number as large.
    #[track_caller]
    #[inline(always)]
    #[must_use]
    pub const fn fits<S: Scalar>(self) -> Self {
        check_fit::<S, 3>(self.0);
        self
    }
}

impl Acceleration {
    /// The same acceleration, which `S` represents.
    ///
    /// # Panics
    /// At compile time in a constant: where rounding would change it by more than a sixteenth, or `S` has no number as large.
    #[track_caller]
    #[inline(always)]
    #[must_use]
    pub const fn fits<S: Scalar>(self) -> Self {
        check_fit::<S, 3>(self.0);
        self
    }
}

impl DragRate {
    /// The same drag, which `S` represents.
    ///
    /// # Panics
    /// At compile time in a constant: where rounding would change it by more than a sixteenth, or `S` has no number as large; and if it is negative.
    #[track_caller]
    #[inline(always)]
    #[must_use]
    pub const fn fits<S: Scalar>(self) -> Self {
        let Self { rate, decay, gain } = self;
        assert!(
            is_not_negative(rate) && is_not_negative(decay) && is_not_negative(gain),
            "a drag is finite, zero or above"
        );
        check_fit::<S, 1>([rate]);
        // a strong drag may leave no velocity
        check_fit::<S, 3>([1.0, decay, gain]);
        self
    }
}

impl Airflow {
    /// The same wind, which `S` represents.
    ///
    /// # Panics
    /// At compile time in a constant: where rounding would change it by more than a sixteenth, or `S` has no number as large; and for negative pressures.
    #[track_caller]
    #[inline(always)]
    #[must_use]
    pub const fn fits<S: Scalar>(self) -> Self {
        assert!(is_not_negative(self.pressure), "a wind's pressure is zero or above");
        check_fit::<S, 3>(self.wind);
        check_fit::<S, 1>([self.pressure]);
        assert!(is_not_negative(self.widest), "a wind's bound is zero or above");
        self
    }
}

impl PanelFlow {
    /// The same wind, which `S` represents.
    ///
    /// # Panics
    /// At compile time in a constant: where rounding would change it by more than a sixteenth, or `S` has no number as large; and for negative pressures and
    /// areas that are not positive.
    #[track_caller]
    #[inline(always)]
    #[must_use]
    pub const fn fits<S: Scalar>(self) -> Self {
        assert!(is_not_negative(self.pressure), "a wind's pressure is zero or above");
        assert!(is_positive(self.area) && self.area <= 1.0, "a panel's area is positive, and 1 cell² at most");
        check_fit::<S, 3>(self.wind);
        check_fit::<S, 1>([self.pressure]);
        check_fit::<S, 1>([self.area]);
        self
    }
}

impl Length {
    /// Rejects lengths that are negative, undefined or beyond the range of `S`.
    #[track_caller]
    #[inline(always)]
    pub(crate) const fn check_size<S: Scalar>(self) {
        assert!(is_not_negative(self.0), "a radius or margin is zero or above");
        assert!(is_in_range::<S>(self.0), "a length is beyond the range of the number type");
    }
}

impl Strength {
    /// The same strength, which `S` represents. A spring that is rigid in the numbers of `S` fits.
    ///
    /// # Panics
    /// At compile time in a constant: where rounding would change it by more than a sixteenth, and if it is negative.
    #[track_caller]
    #[inline(always)]
    #[must_use]
    pub const fn fits<S: Scalar>(self) -> Self {
        let Self { dividend, divisor } = self;
        assert!(is_not_negative(dividend) && is_not_negative(divisor), "a strength is zero or above");
        check_fit::<S, 1>([dividend]);
        // 1/κ is added to inverse masses: beside them a small value is negligible
        check_fit::<S, 2>([1.0, divisor]);
        self
    }

    const fn new(strength: f64) -> Self {
        if strength > 1.0 {
            Self { dividend: 1.0, divisor: 1.0 / strength }
        } else {
            Self { dividend: strength, divisor: 1.0 }
        }
    }

    /// κ
    pub const fn value(self) -> f64 {
        self.dividend / self.divisor
    }
}

impl Point {
    /// Rejects positions beyond the range of `S`.
    #[track_caller]
    #[inline(always)]
    pub(crate) const fn check<S: Scalar>(self) {
        let [x, y, z] = self.0;
        assert!(
            is_in_range::<S>(x) && is_in_range::<S>(y) && is_in_range::<S>(z),
            "a place is not finite, or beyond the range of the number type"
        );
    }

    /// The vector of the nearest numbers.
    pub fn to_vec<S: Scalar>(self) -> Vec3<S> {
        Vec3::from_f64(self.0)
    }
}

/// The distance between neighbours on a side with this number of particles; 0 for a single particle.
#[track_caller]
const fn spacing(particles: usize, size: f64) -> f64 {
    if particles < 2 {
        return 0.0;
    }
    assert!(size > 0.0, "a sheet needs two particles and a positive size");
    size / (particles - 1) as f64
}

#[track_caller]
const fn check<const N: usize>(values: [f64; N]) {
    let mut k = 0;
    while k < N {
        assert!(is_finite(values[k]), "numbers of a scene are finite");
        k += 1;
    }
}

const fn scaled(v: [f64; 3], factor: f64) -> [f64; 3] {
    [v[0] * factor, v[1] * factor, v[2] * factor]
}

/// exp(−x) for x ≥ 0, by its series at x/2ⁿ ≤ ½ and n squarings: the standard library's function is no `const fn`.
const fn exp_minus(x: f64) -> f64 {
    if x > 745.0 {
        return 0.0;
    }
    let mut reduced = x;
    let mut squarings = 0;
    while reduced > 0.5 {
        reduced *= 0.5;
        squarings += 1;
    }
    let mut term = 1.0;
    let mut sum = 1.0;
    let mut k = 1;
    while k < 18 {
        term *= -reduced / k as f64;
        sum += term;
        k += 1;
    }
    while squarings > 0 {
        sum *= sum;
        squarings -= 1;
    }
    sum
}

/// −ln(x) for 0 < x ≤ 1, by Halley's method on `exp(−y) = x`.
const fn minus_ln(x: f64) -> f64 {
    let mut y = 0.0;
    let mut k = 0;
    while k < 64 {
        let e = exp_minus(y);
        // Halley's step converges from any start below the root
        y += 2.0 * (e - x) / (e + x);
        k += 1;
    }
    y
}

#[cfg(test)]
mod tests {
    use super::*;

    const UNITS: Units = Units::sheet([32, 32], [10.0, 10.0], 1.0, 0.1, 8);

    #[test]
    fn a_tick_is_a_frame_where_substeps_are_a_power_of_two() {
        assert!((UNITS.tick() - 0.1).abs() < 1e-15);
        let three = Units { substeps: 3, ..UNITS };
        assert!((three.tick() - 4.0 * 0.1 / 3.0).abs() < 1e-15);
    }

    #[test]
    fn what_went_in_comes_out() {
        let (place, velocity) = ([0.3, -2.0, 7.5], [-1.0, 0.25, 3.0]);
        let near = |found: [f64; 3], expected: [f64; 3], bound: f64| {
            found.into_iter().zip(expected).all(|(found, expected)| (found - expected).abs() < bound)
        };
        assert!(near(UNITS.metres(UNITS.point(place).to_vec::<f64>()), place, 1e-14));
        assert!(near(UNITS.metres(UNITS.point(place).to_vec::<crate::Q24>()), place, 1e-7));
        let moving = Vec3::<f64>::from_f64(UNITS.velocity(velocity).0);
        assert!(near(UNITS.metres_per_second(moving), velocity, 1e-14));
    }

    #[test]
    fn exponentials_agree_with_the_standard_library() {
        for x in [0.0, 1e-9, 0.1, 0.5, 1.0, 3.7, 20.0, 100.0] {
            let expected = libm::exp(-x);
            assert!((exp_minus(x) - expected).abs() <= 1e-13 * expected, "{x}");
        }
        assert_eq!(exp_minus(1e4), 0.0);
        for x in [1.0, 0.9, 0.5, 0.01, 1e-6] {
            assert!((minus_ln(x) + libm::log(x)).abs() < 1e-13, "{x}");
        }
    }

    #[test]
    fn verlet_damping_leaves_its_part_of_a_frames_displacement() {
        let drag = UNITS.verlet_damping(0.1);
        assert!((libm::pow(drag.decay, 8.0) - 0.9).abs() < 1e-14);
        assert!((drag.rate - 1.053_605_156_578_263 * 0.0125).abs() < 1e-14);
    }

    #[test]
    fn strengths_are_quotients_of_numbers_up_to_one() {
        for k in [1e-12, 1.0, 94_270.0, 1e11] {
            let strength = UNITS.stiffness(k);
            assert!(strength.dividend <= 1.0 && strength.divisor <= 1.0);
            assert!((strength.value() - k * 0.0125 * 0.0125).abs() < 1e-12 * strength.value());
        }
        assert_eq!(UNITS.compliance(0.0), Strength { dividend: 1.0, divisor: 0.0 });
        assert_eq!(UNITS.compliance(1e-3), UNITS.stiffness(1e3));
    }
}
