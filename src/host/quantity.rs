//! Numbers of a scene file, checked while they are read, so that an error names their key.

use core::fmt;
use core::marker::PhantomData;
use std::format;

use serde::Deserialize;
use serde::de::{Deserializer, Error, SeqAccess, Visitor};

/// A condition on a finite number.
pub(super) trait Range {
    /// The condition in words, after "must be".
    const WORDS: &'static str;
    /// Whether `value`, which is finite, satisfies the condition.
    fn holds(value: f64) -> bool;
}

macro_rules! range {
    ($(#[$doc:meta])* $name:ident, $words:literal, $holds:expr) => {
        $(#[$doc])*
        #[derive(Clone, Copy, Debug)]
        pub(super) enum $name {}
        impl Range for $name {
            const WORDS: &'static str = $words;
            fn holds(value: f64) -> bool {
                let holds: fn(f64) -> bool = $holds;
                holds(value)
            }
        }
    };
}
range!(/** Any finite number. */ Any, "finite", |_| true);
range!(/** Above zero. */ AboveZero, "above zero", |x| x > 0.0);
range!(/** Zero or above. */ NotNegative, "zero or above", |x| x >= 0.0);
range!(/** A fraction below one: `0 <= x < 1`. */ Share, "at least 0 and below 1", |x| (0.0..1.0).contains(&x));

/// A finite number that satisfies `R`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Quantity<R> {
    value: f64,
    range: PhantomData<R>,
}

/// Any finite number.
pub(super) type Number = Quantity<Any>;
/// A number above zero.
pub(super) type Positive = Quantity<AboveZero>;
/// A number not below zero.
pub(super) type NonNegative = Quantity<NotNegative>;
/// A number of `[0, 1)`.
pub(super) type Fraction = Quantity<Share>;

impl<R: Range> Quantity<R> {
    /// The number.
    pub(super) fn get(self) -> f64 {
        self.value
    }

    fn check<E: Error>(value: f64) -> Result<Self, E> {
        if !value.is_finite() {
            Err(E::custom(format!("must be finite, is {value}")))
        } else if R::holds(value) {
            Ok(Self { value, range: PhantomData })
        } else {
            Err(E::custom(format!("must be {}, is {value}", R::WORDS)))
        }
    }
}

impl<'de, R: Range> Deserialize<'de> for Quantity<R> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Numeric<R>(PhantomData<R>);
        impl<R: Range> Visitor<'_> for Numeric<R> {
            type Value = Quantity<R>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a number")
            }
            fn visit_f64<E: Error>(self, value: f64) -> Result<Self::Value, E> {
                Quantity::check(value)
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<Self::Value, E> {
                Quantity::check(value as f64)
            }
            fn visit_u64<E: Error>(self, value: u64) -> Result<Self::Value, E> {
                Quantity::check(value as f64)
            }
        }
        deserializer.deserialize_any(Numeric(PhantomData))
    }
}

/// A vector `[x, y, z]`.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Vector(pub [f64; 3]);

impl<'de> Deserialize<'de> for Vector {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Three;
        impl<'de> Visitor<'de> for Three {
            type Value = Vector;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("three numbers [x, y, z]")
            }
            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<Vector, A::Error> {
                let mut vector = [0.0; 3];
                for (count, slot) in vector.iter_mut().enumerate() {
                    *slot = list.next_element::<Number>()?.ok_or_else(|| A::Error::invalid_length(count, &self))?.get();
                }
                match list.next_element::<Number>()? {
                    None => Ok(Vector(vector)),
                    Some(_) => Err(A::Error::invalid_length(4, &self)),
                }
            }
        }
        deserializer.deserialize_any(Three)
    }
}

/// The largest count in a scene, such as substeps or frames.
pub const MOST: u32 = 1 << 20;

/// A whole number from 1 to [`MOST`].
#[derive(Clone, Copy, Debug)]
pub(super) struct Count(u32);

impl Count {
    /// The number.
    pub(super) fn get(self) -> u32 {
        self.0
    }
}

impl<'de> Deserialize<'de> for Count {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Whole;
        impl Visitor<'_> for Whole {
            type Value = Count;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a whole number")
            }
            fn visit_i64<E: Error>(self, value: i64) -> Result<Count, E> {
                match u32::try_from(value) {
                    Ok(count) if (1..=MOST).contains(&count) => Ok(Count(count)),
                    _ => Err(E::custom(format!("must be a whole number from 1 to {MOST}, is {value}"))),
                }
            }
        }
        deserializer.deserialize_any(Whole)
    }
}

/// A colour `"#rrggbb"`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Colour(pub(super) [u8; 3]);

impl<'de> Deserialize<'de> for Colour {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Hexadecimal;
        impl Visitor<'_> for Hexadecimal {
            type Value = Colour;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a colour \"#rrggbb\"")
            }
            fn visit_str<E: Error>(self, text: &str) -> Result<Colour, E> {
                let digits = text.strip_prefix('#').filter(|digits| digits.len() == 6);
                let digits = digits.filter(|digits| digits.bytes().all(|digit| digit.is_ascii_hexdigit()));
                let number = digits.and_then(|digits| u32::from_str_radix(digits, 16).ok());
                let [_, red, green, blue] =
                    number.ok_or_else(|| E::invalid_value(serde::de::Unexpected::Str(text), &self))?.to_be_bytes();
                Ok(Colour([red, green, blue]))
            }
        }
        deserializer.deserialize_any(Hexadecimal)
    }
}
