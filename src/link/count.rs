//! Numbers as types: the links of a scene determine the lengths of a solver's arrays.

use core::fmt::Debug;

use crate::grid::Grid;
use crate::scalar::Scalar;

/// An initial value, known at compile time.
pub trait Blank: Copy + Debug + Send + 'static {
    /// All zeros.
    const BLANK: Self;
}

impl<S: Scalar, const W: usize, const H: usize> Blank for Grid<S, W, H> {
    const BLANK: Self = Self::filled(S::ZERO);
}

impl<T: Blank, const N: usize> Blank for [T; N] {
    const BLANK: Self = [T::BLANK; N];
}

/// A number as a type: see [`Directions`].
pub trait Count {
    /// The number.
    const NUMBER: usize;

    /// An array of [`NUMBER`](Self::NUMBER) values.
    type Array<T: Blank>: Blank + AsMut<[T]>;

    /// One more, at most 24.
    type Next: Count;

    /// The sum with another number, at most 24.
    type Plus<B: Count>: Count;
}

/// The number of directions of a family of links: one for links along rows or along columns, two for links along both diagonals of a box.
#[derive(Clone, Copy, Debug)]
pub enum Directions<const N: usize> {}

impl Count for Directions<0> {
    const NUMBER: usize = 0;
    type Array<T: Blank> = [T; 0];
    type Next = Directions<1>;
    type Plus<B: Count> = B;
}

macro_rules! count {
    ($($number:literal after $before:literal, then $next:literal;)+) => {
        $(impl Count for Directions<$number> {
            const NUMBER: usize = $number;
            type Array<T: Blank> = [T; $number];
            type Next = Directions<$next>;
            type Plus<B: Count> = <Directions<$before> as Count>::Plus<B::Next>;
        })+
    };
}

count! {
    1 after 0, then 2;
    2 after 1, then 3;
    3 after 2, then 4;
    4 after 3, then 5;
    5 after 4, then 6;
    6 after 5, then 7;
    7 after 6, then 8;
    8 after 7, then 9;
    9 after 8, then 10;
    10 after 9, then 11;
    11 after 10, then 12;
    12 after 11, then 13;
    13 after 12, then 14;
    14 after 13, then 15;
    15 after 14, then 16;
    16 after 15, then 17;
    17 after 16, then 18;
    18 after 17, then 19;
    19 after 18, then 20;
    20 after 19, then 21;
    21 after 20, then 22;
    22 after 21, then 23;
    23 after 22, then 24;
    24 after 23, then 24;
}

/// Whether links may have dampers, as a type: [`Undamped`] or [`WithDampers`].
pub trait Damping {
    /// Whether there may be any.
    const ANY: bool;

    /// A solver's memory of the velocity changes by springs, needed beside dampers: a vector of `T`s, or nothing.
    type Pull<T: Blank>: Blank + AsMut<[T]>;

    /// Whether these or the other links may have dampers.
    type Or<B: Damping>: Damping;
}

/// No link has a damper.
#[derive(Clone, Copy, Debug)]
pub enum Undamped {}

/// Links may have dampers.
#[derive(Clone, Copy, Debug)]
pub enum WithDampers {}

impl Damping for Undamped {
    const ANY: bool = false;
    type Pull<T: Blank> = [T; 0];
    type Or<B: Damping> = B;
}

impl Damping for WithDampers {
    const ANY: bool = true;
    type Pull<T: Blank> = [T; 3];
    type Or<B: Damping> = Self;
}

#[cfg(test)]
mod tests {
    use super::*;

    type Sum<const A: usize, const B: usize> = <Directions<A> as Count>::Plus<Directions<B>>;

    #[test]
    fn numbers_are_added_and_end_at_24() {
        fn sum<const A: usize, const B: usize>() -> usize
        where
            Directions<A>: Count,
            Directions<B>: Count,
        {
            Sum::<A, B>::NUMBER
        }
        assert_eq!([sum::<0, 0>(), sum::<0, 3>(), sum::<2, 0>(), sum::<2, 2>(), sum::<4, 3>()], [0, 3, 2, 4, 7]);
        assert_eq!([sum::<23, 1>(), sum::<24, 0>(), sum::<24, 1>(), sum::<20, 9>()], [24; 4]);
        assert_eq!(<Sum<2, 3> as Count>::Array::<Grid<f32, 2, 2>>::BLANK, [Grid([[0.0; 2]; 2]); 5]);
    }

    #[test]
    fn links_have_dampers_if_any_of_them_has() {
        fn any<A: Damping, B: Damping>() -> bool {
            <A::Or<B> as Damping>::ANY
        }
        assert!(!any::<Undamped, Undamped>());
        assert!(any::<WithDampers, Undamped>() && any::<Undamped, WithDampers>() && any::<WithDampers, WithDampers>());
    }
}
