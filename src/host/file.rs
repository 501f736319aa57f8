//! The scene file as it is written: tables and keys, before defaults are filled in.

use core::fmt;
use core::marker::PhantomData;
use std::format;
use std::string::String;
use std::vec::Vec;

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer, StrDeserializer};
use serde::de::{Deserializer, Error, MapAccess, SeqAccess, Visitor};

use super::choice::{Pose, SolverKind, Weave};
use super::error::SceneError;
use super::quantity::{Colour, Count, Fraction, NonNegative, Number, Positive, Vector};

/// The limit on values, keys and lines of a file, counted by the characters that begin or end them. In memory each is some hundred times as long as in the file.
const MOST_VALUES: usize = 1 << 18;

/// A whole file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct File {
    #[serde(default)]
    pub(super) name: String,
    pub(super) cloth: Table<Cloth>,
    pub(super) stretch: Option<Table<Links>>,
    pub(super) shear: Option<Table<Links>>,
    pub(super) bend: Option<Table<Links>>,
    pub(super) tether: Option<Table<Tether>>,
    #[serde(default)]
    pub(super) environment: Table<Environment>,
    #[serde(default)]
    pub(super) sphere: Vec<Table<Sphere>>,
    #[serde(default)]
    pub(super) plane: Vec<Table<Plane>>,
    #[serde(default)]
    pub(super) capsule: Vec<Table<Capsule>>,
    #[serde(default)]
    pub(super) solver: Table<Solver>,
    #[serde(rename = "self")]
    pub(super) self_contact: Option<Table<SelfContact>>,
    pub(super) rest: Option<Table<Rest>>,
    #[serde(default)]
    pub(super) run: Table<Run>,
    #[serde(default)]
    pub(super) picture: Table<Picture>,
}

impl File {
    /// Reads the text of a scene file; every number it returns is finite and in its range.
    pub(super) fn parse(text: &str) -> Result<Self, SceneError> {
        let mut ends = text.bytes().enumerate().filter(|(_, byte)| b",=[.\n".contains(byte));
        if let Some((end, _)) = ends.nth(MOST_VALUES) {
            let line = text[..end].matches('\n').count() + 1;
            return Err(SceneError::new(format!("line {line}"), format!("more than {MOST_VALUES} values")));
        }
        let document = toml::Deserializer::parse(text).map_err(|error| SceneError::from_syntax(text, &error))?;
        serde_path_to_error::deserialize(document).map_err(|error| SceneError::from_toml(text, &error))
    }
}

/// A table of keys, and nothing else. By default, serde also accepts a list of values in the order of the keys.
#[derive(Debug, Default)]
pub(super) struct Table<T>(pub(super) T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Table<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Keys<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Keys<T> {
            type Value = Table<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a table")
            }
            fn visit_map<A: MapAccess<'de>>(self, keys: A) -> Result<Table<T>, A::Error> {
                T::deserialize(MapAccessDeserializer::new(keys)).map(Table)
            }
        }
        deserializer.deserialize_any(Keys(PhantomData))
    }
}

/// One of several names. By default, serde also accepts a table with the name as its key.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Named<T>(pub(super) T);

impl<'de, T: Deserialize<'de>> Deserialize<'de> for Named<T> {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Name<T>(PhantomData<T>);
        impl<'de, T: Deserialize<'de>> Visitor<'de> for Name<T> {
            type Value = Named<T>;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a string")
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<Named<T>, E> {
                T::deserialize(StrDeserializer::new(name)).map(Named)
            }
        }
        deserializer.deserialize_any(Name(PhantomData))
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Cloth {
    pub(super) columns: Count,
    pub(super) rows: Count,
    pub(super) width: Option<Number>,
    pub(super) height: Positive,
    pub(super) mass: Option<Positive>,
    pub(super) density: Option<Positive>,
    pub(super) hem: Option<Positive>,
    #[serde(default)]
    pub(super) pose: Named<Pose>,
    #[serde(default)]
    pub(super) origin: Vector,
    #[serde(default)]
    pub(super) pins: Pins,
}

/// `pins`: a named set or a list of `[column, row]`.
#[derive(Debug)]
pub(super) enum Pins {
    Top,
    Left,
    Corners,
    TopCorners,
    /// Lists of any length: the resolver reports a pin that is not `[column, row]`.
    Nodes(Vec<Vec<i64>>),
}

impl Default for Pins {
    fn default() -> Self {
        Self::Nodes(Vec::new())
    }
}

impl<'de> Deserialize<'de> for Pins {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct NameOrNodes;
        impl<'de> Visitor<'de> for NameOrNodes {
            type Value = Pins;
            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("a list of [column, row] or one of \"top\", \"left\", \"corners\", \"top-corners\"")
            }
            fn visit_str<E: Error>(self, name: &str) -> Result<Pins, E> {
                match name {
                    "top" => Ok(Pins::Top),
                    "left" => Ok(Pins::Left),
                    "corners" => Ok(Pins::Corners),
                    "top-corners" => Ok(Pins::TopCorners),
                    _ => Err(E::invalid_value(serde::de::Unexpected::Str(name), &self)),
                }
            }
            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<Pins, A::Error> {
                Deserialize::deserialize(SeqAccessDeserializer::new(list)).map(Pins::Nodes)
            }
        }
        deserializer.deserialize_any(NameOrNodes)
    }
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Links {
    pub(super) stiffness: Option<NonNegative>,
    pub(super) compliance: Option<Positive>,
    pub(super) damping: Option<NonNegative>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Tether {
    pub(super) slack: Option<NonNegative>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Environment {
    #[serde(default)]
    pub(super) gravity: Vector,
    pub(super) drag: Option<NonNegative>,
    pub(super) verlet_damping: Option<Fraction>,
    pub(super) wind: Option<Table<Wind>>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Wind {
    pub(super) velocity: Vector,
    pub(super) model: Named<WindModel>,
    pub(super) density: Option<Positive>,
    pub(super) drag_coefficient: Option<NonNegative>,
}

#[derive(Clone, Copy, Debug, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub(super) enum WindModel {
    Facet,
    Aerodynamic,
    Panel,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Sphere {
    pub(super) centre: Vector,
    pub(super) radius: Positive,
    pub(super) margin: Option<NonNegative>,
    pub(super) friction: Option<NonNegative>,
    #[serde(default)]
    pub(super) velocity: Vector,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Plane {
    pub(super) point: Vector,
    pub(super) normal: Vector,
    pub(super) margin: Option<NonNegative>,
    pub(super) friction: Option<NonNegative>,
}

#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Capsule {
    pub(super) a: Vector,
    pub(super) b: Vector,
    pub(super) radius: Positive,
    pub(super) margin: Option<NonNegative>,
    pub(super) friction: Option<NonNegative>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Solver {
    pub(super) kind: Option<Named<SolverKind>>,
    pub(super) step: Option<Positive>,
    pub(super) substeps: Option<Count>,
    pub(super) iterations: Option<Count>,
    pub(super) sweeps: Option<Count>,
    pub(super) tolerance: Option<Positive>,
    pub(super) strain_limit: Option<Positive>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SelfContact {
    pub(super) thickness: Option<Positive>,
    pub(super) friction: Option<NonNegative>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Rest {
    pub(super) speed: Option<Positive>,
    pub(super) acceleration: Option<Positive>,
    pub(super) time: Option<Positive>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Run {
    pub(super) frames: Option<Count>,
}

#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Picture {
    pub(super) azimuth: Option<Number>,
    pub(super) elevation: Option<Number>,
    pub(super) low: Option<Vector>,
    pub(super) high: Option<Vector>,
    #[serde(default)]
    pub(super) pattern: Named<Weave>,
    pub(super) bands: Option<Count>,
    pub(super) colours: Option<Vec<Colour>>,
}
