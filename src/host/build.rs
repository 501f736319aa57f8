//! The conversion of a description to the core's types, in one number type.

use std::format;
use std::vec::Vec;

use super::choice::{Pose, SolverKind};
use super::description::{Description, Spring};
use super::error::SceneError;
use super::fit::{Fit, finite};
use super::parts::{Parts, Springs};
use crate::cloth::Cloth;
use crate::fingerprint::Fingerprint;
use crate::force::{Drag, Gravity};
use crate::grid::Node;
use crate::link::{Bend, Links, Shear, StrainLimited, Stretch, Tether, Visitor};
use crate::moment::Moment;
use crate::particles::Particles;
use crate::scalar::Scalar;
use crate::units::{Strength, Units};

/// A sheet's size, mass and step are at most this and at least its inverse, in SI units. Without this check an error would name a quantity scaled by these.
const EXTREME: f64 = 1e18;
/// The largest number of pins to which tethers may be attached.
const ANCHORS: usize = 256;

pub(super) type Forces<S, P> = (Gravity<S>, Option<Drag<S>>, <P as Parts<S>>::Air, <P as Parts<S>>::Hand);
type Family<S, P, L> = Option<<P as Parts<S>>::Springs<L>>;
type Families<S, P> = (Family<S, P, Stretch<S>>, Family<S, P, Shear<S>>, Family<S, P, Bend<S>>);

/// All links of a scene. Each family is optional.
pub(super) struct SceneLinks<S: Scalar + Send, P: Parts<S>> {
    pub(super) springs: Families<S, P>,
    limit: Option<StrainLimited<Families<S, P>, S>>,
    tether: Option<Tether<S, ANCHORS>>,
}

impl<S: Scalar + Send, P: Parts<S>> Links<S> for SceneLinks<S, P> {
    type Directions = <Families<S, P> as Links<S>>::Directions;
    type Damping = <Families<S, P> as Links<S>>::Damping;

    fn springs<V: Visitor<S>>(&self, visitor: &mut V) {
        self.springs.springs(visitor);
    }

    fn dampers<V: Visitor<S>>(&self, visitor: &mut V) {
        self.springs.dampers(visitor);
    }

    fn confine<const W: usize, const H: usize>(&self, particles: &mut Particles<S, W, H>, moment: Moment) {
        self.tether.confine(particles, moment);
        self.limit.confine(particles, moment);
    }

    fn fingerprint(&self, print: &mut Fingerprint) {
        self.springs.fingerprint(print);
        self.limit.fingerprint(print);
        self.tether.fingerprint(print);
    }
}

impl Description {
    /// The units of its sheet.
    pub(super) fn units(&self) -> Result<Units, SceneError> {
        let sheet = &self.sheet;
        let mass_key = format!("cloth.{}", sheet.mass_key);
        let measures = [
            ("cloth.height", sheet.height),
            // A chain has no width.
            ("cloth.width", if sheet.columns > 1 { sheet.width } else { sheet.height }),
            (&mass_key, sheet.mass),
            ("solver.step", self.solver.step),
        ];
        for (key, measure) in measures {
            if measure > EXTREME {
                return Err(SceneError::new(key, format!("too large, above {EXTREME:e}")));
            }
            if measure < 1.0 / EXTREME {
                return Err(SceneError::new(key, format!("too small, below {:e}", 1.0 / EXTREME)));
            }
        }
        let (particles, size) = ([sheet.columns, sheet.rows], [sheet.width, sheet.height]);
        Ok(Units::sheet(particles, size, sheet.mass, self.solver.step, self.solver.substeps))
    }

    /// The sheet in its initial pose, without pins.
    pub(super) fn cloth<S: Scalar, const W: usize, const H: usize>(
        &self,
        units: &Units,
    ) -> Result<Cloth<S, W, H>, SceneError> {
        let sheet = &self.sheet;
        let [width, height] = ["cloth.width", "cloth.height"];
        for (side, (count, key, other)) in units.sides.into_iter().zip([(W, width, height), (H, height, width)]) {
            // Links need the inverse square of their rest length.
            let numbers = [side, 1.0 / (side * side)];
            if count > 1 && numbers.into_iter().any(|number| Fit::<S>::number(key, number).is_err()) {
                return Err(SceneError::new(key, format!("too small beside {other} for {}", S::NAME)));
            }
        }
        let origin = units.point(sheet.origin);
        let [right, down] = [units.sides[0] * (W - 1) as f64, units.sides[1] * (H - 1) as f64];
        let [x, y, z] = origin.0;
        let opposite = match sheet.pose {
            Pose::Lay => [x + right, y + down, z],
            Pose::Hang => [x + right, y, z - down],
        };
        Fit::<S>::place("cloth.origin", origin.0)?;
        Fit::<S>::place("cloth.origin", opposite)?;
        let mut cloth = match sheet.pose {
            Pose::Lay => Cloth::lay(units, origin),
            Pose::Hang => Cloth::hang(units, origin),
        };
        if sheet.shares_area() {
            cloth.share_area();
        }
        if let Some(hem) = sheet.hem {
            let factor = Fit::<S>::number("cloth.hem", hem)?;
            // the largest sum of inverse masses at the ends of a link: a corner and its neighbour if particles share the area
            let most = if sheet.shares_area() { 4.0 + 2.0 } else { 2.0 };
            Fit::<S>::number("cloth.hem", most / hem)?;
            Fit::<S>::number("cloth.hem", 1.0 / hem)?;
            cloth.hem(factor);
        }
        Ok(cloth)
    }

    pub(super) fn forces<S: Scalar + Send, P: Parts<S>>(&self, units: &Units) -> Result<Forces<S, P>, SceneError> {
        let drag = match self.drag {
            Some(drag) => {
                let rate = units.drag(drag.rate);
                Fit::<S>::constant(format!("environment.{}", drag.key), [rate.rate])?;
                Some(Drag::new(rate))
            }
            None => None,
        };
        Ok((gravity(units, self.gravity)?, drag, P::air(units, self.wind.as_ref())?, P::Hand::default()))
    }

    pub(super) fn links<S: Scalar + Send, P: Parts<S>>(&self, units: &Units) -> Result<SceneLinks<S, P>, SceneError> {
        // A sweep of Verlet applies its part of the stiffness.
        let parts = if self.solver.kind == SolverKind::Verlet { self.solver.iterations } else { 1 };
        let springs = (
            family::<S, P, _>(units, "stretch", self.stretch, parts, Stretch::new)?,
            family::<S, P, _>(units, "shear", self.shear, parts, Shear::new)?,
            family::<S, P, _>(units, "bend", self.bend, parts, Bend::new)?,
        );
        let limit = match self.solver.strain_limit {
            Some(limit) => {
                let key = "solver.strain_limit";
                // The longest links are two cells long.
                Fit::<S>::number(key, 2.0 * (1.0 + limit))?;
                Fit::<S>::number(key, limit)?;
                Some(StrainLimited::new(springs, limit))
            }
            None => None,
        };
        let tether = match self.tether_slack {
            Some(slack) => {
                let cells = (self.sheet.columns.max(self.sheet.rows) - 1) as f64;
                Fit::<S>::number("tether.slack", (1.0 + slack) * cells)?;
                Fit::<S>::number("tether.slack", slack)?;
                let anchors: Vec<_> = self.sheet.pins.iter().map(|&[column, row]| Node { column, row }).collect();
                let reason = || SceneError::new("tether", format!("holds to {ANCHORS} pins at most"));
                Some(Tether::new(units, &anchors, slack).map_err(|_| reason())?)
            }
            None => None,
        };
        Ok(SceneLinks { springs, limit, tether })
    }
}

/// Makes the core's gravity, from m/s².
pub(super) fn gravity<S: Scalar>(units: &Units, gravity: [f64; 3]) -> Result<Gravity<S>, SceneError> {
    finite("environment.gravity", &gravity)?;
    let acceleration = units.acceleration(gravity);
    Fit::<S>::constant("environment.gravity", acceleration.0)?;
    Ok(Gravity::new(acceleration))
}

fn family<S: Scalar + Send, P: Parts<S>, L: Springs<S>>(
    units: &Units,
    table: &str,
    spring: Option<Spring>,
    parts: u32,
    family: impl Fn(&Units, Strength) -> L,
) -> Result<Family<S, P, L>, SceneError> {
    let Some(spring) = spring else { return Ok(None) };
    let strength = units.stiffness(spring.stiffness);
    for strength in [strength, units.stiffness(spring.stiffness / f64::from(parts))] {
        Fit::<S>::constant(format!("{table}.{}", spring.key), [strength.dividend])?;
    }
    P::springs(units, table, family(units, strength), spring.damping).map(Some)
}
