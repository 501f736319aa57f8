//! Saved and restored state, by any format of [`serde`] (feature `serde`).
//!
//! A step changes only the [`Cloth`] and the memory of its solver, [`Resting`](crate::Resting)'s included. Restored together they continue with the same bits.
//!
//! ```
//! use kerchief::*;
//!
//! const UNITS: Units = Units::sheet([8, 8], [0.3, 0.3], 1e-3, 1.0 / 60.0, 4);
//! type State = (Cloth<Q24, 8, 8>, <Lines as Solver<Q24>>::Memory<Stretch<Q24>, 8, 8>);
//!
//! let mut cloth = Cloth::<Q24, 8, 8>::hang(&UNITS, UNITS.point([0.0, 0.0, 0.3]));
//! cloth.pin(Node::new(0, 0));
//! let gravity = Gravity::new(UNITS.acceleration([0.0, 0.0, -9.81]));
//! let scene = Scene::new(&UNITS, gravity, Stretch::new(&UNITS, UNITS.stiffness(100.0)), (), Lines::new());
//! let mut memory = scene.memory();
//! (0..10).for_each(|_| scene.step(&mut cloth, &mut memory));
//!
//! let bytes = postcard::to_stdvec(&(&cloth, &memory))?;
//! let (mut restored, mut remembered): State = postcard::from_bytes(&bytes)?;
//! scene.step(&mut cloth, &mut memory);
//! scene.step(&mut restored, &mut remembered);
//! assert_eq!(restored, cloth);
//! # Ok::<(), postcard::Error>(())
//! ```
//!
//! Other state that changes while a scene runs, such as a moving ball or a [`Hand`](crate::Hand), must be saved by the caller: its fields are numbers, [`Vec3`]
//! and [`Node`]. A fixed-point number is saved as its bits, a whole number of 2⁻²⁴.
//!
//! # Errors
//!
//! Values that cannot have been saved are rejected, so that a step still cannot fail: a sheet of another size, a number that is not finite, a negative mass,
//! counters beyond the range of every solver. An exploded sheet is rejected for the same reason. The values include the solver's parameters: a memory belongs
//! to the scene that it was saved from, and to the version of this crate.

use core::fmt;
use core::marker::PhantomData;

use serde::de::{Deserialize, Deserializer, Error, SeqAccess, Visitor};
use serde::ser::{Serialize, SerializeTuple, Serializer};

use crate::cloth::Cloth;
use crate::grid::{Grid, Node};
use crate::particles::Particles;
use crate::scalar::{Fixed24, Scalar};
use crate::vec3::Vec3;
use crate::vectors::Vectors;

/// Values on a grid, with its size. Without the size, a format without field names would accept the rows of a grid of another size.
#[derive(serde::Serialize, serde::Deserialize)]
struct Sheet<V> {
    columns: usize,
    rows: usize,
    values: V,
}

/// The values of `count` nodes, computed from their index.
struct Each<F> {
    count: usize,
    value: F,
}

impl<T: Serialize, F: Fn(usize) -> T> Serialize for Each<F> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut tuple = serializer.serialize_tuple(self.count)?;
        (0..self.count).try_for_each(|index| tuple.serialize_element(&(self.value)(index)))?;
        tuple.end()
    }
}

/// `W × H` values, row by row.
struct Rows<T, const W: usize, const H: usize>([[T; W]; H]);

impl<'de, T: Deserialize<'de> + Copy, const W: usize, const H: usize> Deserialize<'de> for Rows<T, W, H> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Values<T, const W: usize, const H: usize>(PhantomData<T>);
        impl<'de, T: Deserialize<'de> + Copy, const W: usize, const H: usize> Visitor<'de> for Values<T, W, H> {
            type Value = Rows<T, W, H>;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                write!(f, "{} values", W * H)
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut values: A) -> Result<Self::Value, A::Error> {
                let first = values.next_element()?.ok_or_else(|| Error::invalid_length(0, &self))?;
                let mut rows = [[first; W]; H];
                for (index, place) in rows.as_flattened_mut().iter_mut().enumerate().skip(1) {
                    *place = values.next_element()?.ok_or_else(|| Error::invalid_length(index, &self))?;
                }
                Ok(Rows(rows))
            }
        }
        deserializer.deserialize_tuple(W * H, Values(PhantomData))
    }
}

impl<T: Serialize, const W: usize, const H: usize> Serialize for Grid<T, W, H> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let values = Each { count: W * H, value: |index: usize| &self.0[index / W][index % W] };
        Sheet { columns: W, rows: H, values }.serialize(serializer)
    }
}

impl<'de, T: Deserialize<'de> + Copy, const W: usize, const H: usize> Deserialize<'de> for Grid<T, W, H> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Sheet { columns, rows, values: Rows(values) } = Sheet::deserialize(deserializer)?;
        if (columns, rows) == (W, H) {
            Ok(Self(values))
        } else {
            Err(Error::custom(format_args!("a sheet of {columns} × {rows} particles, not of {W} × {H}")))
        }
    }
}

impl<S: Serialize, const W: usize, const H: usize> Serialize for Vectors<S, W, H> {
    fn serialize<R: Serializer>(&self, serializer: R) -> Result<R::Ok, R::Error> {
        let value = |index: usize| {
            let (row, column) = (&self.0[index / W], index % W);
            (&row.x[column], &row.y[column], &row.z[column])
        };
        Sheet { columns: W, rows: H, values: Each { count: W * H, value } }.serialize(serializer)
    }
}

impl<'de, S: Scalar + Deserialize<'de>, const W: usize, const H: usize> Deserialize<'de> for Vectors<S, W, H> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let values = Grid::<Vec3<S>, W, H>::deserialize(deserializer)?;
        let mut vectors = Self::filled(Vec3::ZERO);
        Grid::<S, W, H>::nodes().for_each(|node| vectors.set(node, values[node]));
        Ok(vectors)
    }
}

impl<S: Serialize> Serialize for Vec3<S> {
    fn serialize<R: Serializer>(&self, serializer: R) -> Result<R::Ok, R::Error> {
        (&self.x, &self.y, &self.z).serialize(serializer)
    }
}

impl<'de, S: Deserialize<'de>> Deserialize<'de> for Vec3<S> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Deserialize::deserialize(deserializer).map(|(x, y, z)| Self { x, y, z })
    }
}

impl Serialize for Node {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        (self.column, self.row).serialize(serializer)
    }
}

impl<'de> Deserialize<'de> for Node {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Deserialize::deserialize(deserializer).map(|(column, row)| Self { column, row })
    }
}

impl<K: Copy> Serialize for Fixed24<K> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        self.to_bits().serialize(serializer)
    }
}

impl<'de, K> Deserialize<'de> for Fixed24<K> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        Deserialize::deserialize(deserializer).map(Self::from_bits)
    }
}

/// The serialised form of particles.
#[derive(serde::Serialize, serde::Deserialize)]
#[serde(rename = "Particles")]
struct Written<V, G> {
    position: V,
    velocity: V,
    inverse_mass: G,
}

impl<S: Serialize, const W: usize, const H: usize> Serialize for Particles<S, W, H> {
    fn serialize<R: Serializer>(&self, serializer: R) -> Result<R::Ok, R::Error> {
        let Self { position, velocity, inverse_mass } = self;
        Written { position, velocity, inverse_mass }.serialize(serializer)
    }
}

impl<'de, S: Scalar + Deserialize<'de>, const W: usize, const H: usize> Deserialize<'de> for Particles<S, W, H> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let Written { position, velocity, inverse_mass } = Written::deserialize(deserializer)?;
        let particles = Self { position: check(position)?, velocity: check(velocity)?, inverse_mass };
        if particles.inverse_mass.values().all(|mass| *mass >= S::ZERO && mass.is_finite()) {
            Ok(particles)
        } else {
            Err(Error::custom("an inverse mass is finite, zero or above"))
        }
    }
}

impl<S: Serialize, const W: usize, const H: usize> Serialize for Cloth<S, W, H> {
    fn serialize<R: Serializer>(&self, serializer: R) -> Result<R::Ok, R::Error> {
        Particles::serialize(self, serializer)
    }
}

impl<'de, S: Scalar + Deserialize<'de>, const W: usize, const H: usize> Deserialize<'de> for Cloth<S, W, H> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let mut cloth = Self::BLANK;
        *cloth = Particles::deserialize(deserializer)?;
        Ok(cloth)
    }
}

/// Vectors with finite components only.
pub(crate) fn finite<'de, D: Deserializer<'de>, S: Scalar + Deserialize<'de>, const W: usize, const H: usize>(
    deserializer: D,
) -> Result<Vectors<S, W, H>, D::Error> {
    check(Deserialize::deserialize(deserializer)?)
}

fn check<E: Error, S: Scalar, const W: usize, const H: usize>(
    vectors: Vectors<S, W, H>,
) -> Result<Vectors<S, W, H>, E> {
    if vectors.values().all(|Vec3 { x, y, z }| x.is_finite() && y.is_finite() && z.is_finite()) {
        Ok(vectors)
    } else {
        Err(Error::custom("places and velocities are finite"))
    }
}
