//! External forces on particles: gravity, drag, wind, a hand.
//!
//! `()` is no force; a tuple combines its members. A force of your own implements [`Force`].

mod hand;
mod panel;
mod wind;
#[cfg(test)]
mod wrapped;

use crate::fingerprint::Fingerprint;
use crate::scalar::Scalar;
use crate::units::{Acceleration, DragRate};
use crate::vec3::Vec3;

pub use hand::Hand;
pub use panel::PanelWind;
pub use wind::{AerodynamicWind, FacetWind};

/// A force, or none, or several.
///
/// The defaults are valid for every force and cost a little. A force overrides [`DRAG`](Self::DRAG), [`UNIFORM`](Self::UNIFORM), [`is_field`](Self::is_field)
/// and [`follows_velocity`](Self::follows_velocity) to cost less.
pub trait Force<S: Scalar> {
    /// Whether [`drag`](Self::drag) may differ from none. `false` saves a product.
    const DRAG: bool = true;
    /// Whether [`uniform`](Self::uniform) may differ from zero. `false` saves an addition: in floats adding zero is not the identity, as there are two zeros.
    const UNIFORM: bool = true;

    /// Whether the force is a field, evaluated by [`particles`](Self::particles) or [`cells`](Self::cells): if not, they are not called.
    #[inline]
    fn is_field(&self) -> bool {
        true
    }

    /// The velocity change of every particle in a substep, independent of its mass (cells per tick).
    #[inline]
    fn uniform(&self) -> Vec3<S> {
        Vec3::ZERO
    }

    /// The drag on every particle.
    #[inline]
    fn drag(&self) -> Slowdown<S> {
        Slowdown::NONE
    }

    /// Whether the field depends on velocities, so that leapfrog evaluates it twice.
    #[inline]
    fn follows_velocity(&self) -> bool {
        true
    }

    /// Adds the velocity changes of the particles of a row in a substep, for particles of mass 1 (cells per tick).
    #[inline]
    fn particles<const W: usize>(&self, _row: Row<'_, S, W>, _gain: &mut Vec3<[S; W]>) {}

    /// Adds the velocity changes, for particles of mass 1, by the cells between two neighbouring rows to the particles of those rows.
    #[inline]
    fn cells<const W: usize>(&self, _rows: [Row<'_, S, W>; 2], _gains: [&mut Vec3<[S; W]>; 2]) {}

    /// Adds all data that the force depends on, so that a sheet at rest wakes when it changes: see [`rest`](crate::rest). A force with the default method keeps
    /// sheets awake.
    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.unknown();
    }
}

/// A row of particles.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a, S, const W: usize> {
    /// The row's number in the sheet.
    pub index: usize,
    /// Positions, cells.
    pub position: &'a Vec3<[S; W]>,
    /// Velocities, cells per tick.
    pub velocity: &'a Vec3<[S; W]>,
    /// Inverse masses, in 1/[`Units::mass`](crate::Units::mass); zero for a pin.
    pub inverse_mass: &'a [S; W],
}

/// The exact effect of a drag γ in a substep h: `v(h) = decay·v + gain·h·a` under a constant acceleration a.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slowdown<S> {
    /// γ·h
    pub rate: S,
    /// exp(−γ·h)
    pub decay: S,
    /// (1 − exp(−γ·h))/(γ·h)
    pub gain: S,
}

impl<S: Scalar> Slowdown<S> {
    /// No drag.
    pub const NONE: Self = Self { rate: S::ZERO, decay: S::ONE, gain: S::ONE };

    /// The combined effect of two drags.
    #[must_use]
    pub fn and(self, other: Self) -> Self {
        if self.rate == S::ZERO {
            return other;
        }
        if other.rate == S::ZERO {
            return self;
        }
        let (rate, decay) = (self.rate + other.rate, self.decay * other.decay);
        Self { rate, decay, gain: (S::ONE - decay).divide(rate) }
    }
}

/// Gravity (thesis, 3.3 and listing 5.2). It may change while the sheet moves, as on a board that is tilted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity<S> {
    /// The velocity change in a substep, cells per tick.
    pub gain: Vec3<S>,
}

impl<S: Scalar> Gravity<S> {
    /// Gravity with this acceleration.
    ///
    /// # Panics
    /// If it doesn't [fit](Acceleration::fits) the number type.
    #[track_caller]
    #[inline]
    pub fn new(acceleration: Acceleration) -> Self {
        Self { gain: Vec3::from_f64(acceleration.fits::<S>().0) }
    }
}

impl<S: Scalar> Force<S> for Gravity<S> {
    const DRAG: bool = false;

    #[inline]
    fn is_field(&self) -> bool {
        false
    }

    #[inline]
    fn follows_velocity(&self) -> bool {
        false
    }

    #[inline]
    fn uniform(&self) -> Vec3<S> {
        self.gain
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.vector(self.gain);
    }
}

/// Drag proportional to a particle's mass and velocity, `−m·γ·v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag<S> {
    slowdown: Slowdown<S>,
}

impl<S: Scalar> Drag<S> {
    /// Drag with this rate.
    ///
    /// # Panics
    /// If it doesn't [fit](DragRate::fits) the number type.
    #[track_caller]
    #[inline]
    pub fn new(drag: DragRate) -> Self {
        let drag = drag.fits::<S>();
        let [rate, decay, gain] = [drag.rate, drag.decay, drag.gain].map(S::from_f64);
        Self { slowdown: Slowdown { rate, decay, gain } }
    }
}

impl<S: Scalar> Force<S> for Drag<S> {
    const DRAG: bool = true;
    const UNIFORM: bool = false;

    #[inline]
    fn is_field(&self) -> bool {
        false
    }

    #[inline]
    fn follows_velocity(&self) -> bool {
        false
    }

    #[inline]
    fn drag(&self) -> Slowdown<S> {
        self.slowdown
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        let Slowdown { rate, decay, gain } = self.slowdown;
        print.numbers([rate, decay, gain]);
    }
}

impl<S: Scalar> Force<S> for () {
    const DRAG: bool = false;
    const UNIFORM: bool = false;

    #[inline]
    fn is_field(&self) -> bool {
        false
    }

    #[inline]
    fn follows_velocity(&self) -> bool {
        false
    }

    #[inline]
    fn fingerprint(&self, _print: &mut Fingerprint) {}
}

/// An optional force, chosen at run time.
impl<S: Scalar, T: Force<S>> Force<S> for Option<T> {
    const DRAG: bool = T::DRAG;
    const UNIFORM: bool = T::UNIFORM;

    #[inline]
    fn is_field(&self) -> bool {
        self.as_ref().is_some_and(T::is_field)
    }

    #[inline]
    fn uniform(&self) -> Vec3<S> {
        self.as_ref().map_or(Vec3::ZERO, T::uniform)
    }

    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.word(u32::from(self.is_some()));
        if let Some(force) = self {
            force.fingerprint(print);
        }
    }

    #[inline]
    fn drag(&self) -> Slowdown<S> {
        self.as_ref().map_or(Slowdown::NONE, T::drag)
    }

    #[inline]
    fn follows_velocity(&self) -> bool {
        self.as_ref().is_some_and(T::follows_velocity)
    }

    #[inline]
    fn particles<const W: usize>(&self, row: Row<'_, S, W>, gain: &mut Vec3<[S; W]>) {
        if let Some(force) = self {
            force.particles(row, gain);
        }
    }

    #[inline]
    fn cells<const W: usize>(&self, rows: [Row<'_, S, W>; 2], gains: [&mut Vec3<[S; W]>; 2]) {
        if let Some(force) = self {
            force.cells(rows, gains);
        }
    }
}

macro_rules! tuple {
    ($($name:ident),+) => {
        impl<S: Scalar, $($name: Force<S>),+> Force<S> for ($($name,)+) {
            const DRAG: bool = $($name::DRAG)||+;
            const UNIFORM: bool = $($name::UNIFORM)||+;

            #[inline]
            fn is_field(&self) -> bool {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.is_field())||+
            }

            #[inline]
            fn uniform(&self) -> Vec3<S> {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                let mut gain = None;
                $(if $name::UNIFORM {
                    let uniform = $name.uniform();
                    gain = Some(gain.map_or(uniform, |gain| gain + uniform));
                })+
                gain.unwrap_or(Vec3::ZERO)
            }

            #[inline]
            fn fingerprint(&self, print: &mut Fingerprint) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.fingerprint(print);)+
            }

            #[inline]
            fn drag(&self) -> Slowdown<S> {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                Slowdown::NONE$(.and($name.drag()))+
            }

            #[inline]
            fn follows_velocity(&self) -> bool {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.follows_velocity())||+
            }

            #[inline]
            fn particles<const W: usize>(&self, row: Row<'_, S, W>, gain: &mut Vec3<[S; W]>) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.particles(row, gain);)+
            }

            #[inline]
            fn cells<const W: usize>(&self, rows: [Row<'_, S, W>; 2], [upper, lower]: [&mut Vec3<[S; W]>; 2]) {
                #[allow(non_snake_case)]
                let ($($name,)+) = self;
                $($name.cells(rows, [upper, lower]);)+
            }
        }
    };
}

tuple!(A);
tuple!(A, B);
tuple!(A, B, C);
tuple!(A, B, C, D);
