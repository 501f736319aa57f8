//! What pulls on particles from outside: gravity, drag, wind, a hand.
//!
//! `()` is no force and a tuple is all of its members. A force of your own implements [`Force`].

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
/// What a force says of itself is at first what no force contradicts, and then costs a little: [`DRAG`](Self::DRAG), [`UNIFORM`](Self::UNIFORM),
/// [`is_field`](Self::is_field) and [`follows_velocity`](Self::follows_velocity) are for forces that want to cost less.
pub trait Force<S: Scalar> {
    /// Whether [`drag`](Self::drag) may be any. A force that says no costs no product.
    const DRAG: bool = true;
    /// Whether [`uniform`](Self::uniform) may be anything but zero. A force that says no costs no addition: adding zero is not nothing for a
    /// float, which knows two of them.
    const UNIFORM: bool = true;

    /// Whether the force is a field that [`particles`](Self::particles) or [`cells`](Self::cells) evaluates: if not, they are not called.
    #[inline]
    fn is_field(&self) -> bool {
        true
    }

    /// The velocity that every particle gains in a substep whatever its mass (cells per tick).
    #[inline]
    fn uniform(&self) -> Vec3<S> {
        Vec3::ZERO
    }

    /// How drag slows every particle.
    #[inline]
    fn drag(&self) -> Slowdown<S> {
        Slowdown::NONE
    }

    /// Whether the field depends on velocities, so that leapfrog evaluates it twice.
    #[inline]
    fn follows_velocity(&self) -> bool {
        true
    }

    /// Adds the velocities that the particles of a row would gain in a substep if their mass were 1 (cells per tick).
    #[inline]
    fn particles<const W: usize>(&self, _row: Row<'_, S, W>, _gain: &mut Vec3<[S; W]>) {}

    /// Adds the velocities that the particles of two neighbouring rows would gain from the cells between them.
    #[inline]
    fn cells<const W: usize>(&self, _rows: [Row<'_, S, W>; 2], _gains: [&mut Vec3<[S; W]>; 2]) {}

    /// Takes all in that the force depends on, so that a sheet at rest wakes when it changes: see [`rest`](crate::rest). What is left at its default keeps
    /// sheets awake.
    #[inline]
    fn fingerprint(&self, print: &mut Fingerprint) {
        print.unknown();
    }
}

/// A row of particles.
#[derive(Clone, Copy, Debug)]
pub struct Row<'a, S, const W: usize> {
    /// Which row of the sheet it is.
    pub index: usize,
    /// Where they are, cells.
    pub position: &'a Vec3<[S; W]>,
    /// How fast they move, cells per tick.
    pub velocity: &'a Vec3<[S; W]>,
    /// Their inverse masses, in that of an ordinary particle; zero for a pin.
    pub inverse_mass: &'a [S; W],
}

/// The exact effect of a drag γ on a substep h: `v(h) = decay·v + gain·h·a` under a constant acceleration a.
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

    /// Two drags at once.
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

/// Weight (thesis, 3.3 and listing 5.2). It may change while the sheet moves, as on a board that is tilted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gravity<S> {
    /// The velocity gained in a substep, cells per tick.
    pub gain: Vec3<S>,
}

impl<S: Scalar> Gravity<S> {
    /// Gravity of this acceleration.
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

/// Drag in proportion to a particle's mass and velocity, `−m·γ·v`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drag<S> {
    slowdown: Slowdown<S>,
}

impl<S: Scalar> Drag<S> {
    /// Drag of this rate.
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

/// A force that is there or not, decided while the program runs.
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
