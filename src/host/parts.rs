//! The parts that the scenes of a program may use. A part that is left out costs nothing.

use std::format;

use super::description::{Description, Wind, WindModel};
use super::error::SceneError;
use super::fit::{Fit, finite};
use super::grip::Grip;
use super::obstacles::{Obstacles, Solids};
use crate::force::{AerodynamicWind, FacetWind, Force, Hand, PanelWind};
use crate::link::{Damped, Links};
use crate::scalar::Scalar;
use crate::units::{Length, Units};

/// A link family that a scene may have.
pub trait Springs<S: Scalar + Send>: Links<S> + Copy + Send + 'static {}

impl<S: Scalar + Send, L: Links<S> + Copy + Send + 'static> Springs<S> for L {}

/// The types from which simulations of scenes are assembled.
pub trait Parts<S: Scalar + Send>: 'static {
    /// The wind.
    type Air: Force<S> + Send;
    /// A family of links, with dampers if the parts have them.
    type Springs<L: Springs<S>>: Springs<S>;

    /// The hand. Its default is no hand.
    type Hand: Force<S> + Default + Send;

    /// The obstacles.
    type Obstacles: Obstacles<S>;

    /// Makes the core's wind.
    ///
    /// # Errors
    ///
    /// If the parts have no such wind, or the number type does not represent it.
    fn air(units: &Units, wind: Option<&Wind>) -> Result<Self::Air, SceneError>;

    /// Makes the core's hand, which has not grabbed a particle yet.
    ///
    /// # Errors
    ///
    /// If the parts have no hand, or the number type does not represent it.
    fn hand(units: &Units, grip: &Grip) -> Result<Self::Hand, SceneError>;

    /// The hand, if there is one.
    fn present(hand: &mut Self::Hand) -> Option<&mut Hand<S>>;

    /// `springs` with parallel dampers of `damping` (N·s/m). `table` is their name in the scene file.
    ///
    /// # Errors
    ///
    /// If the parts have no dampers, or the number type does not represent them.
    fn springs<L: Springs<S>>(
        units: &Units,
        table: &str,
        springs: L,
        damping: f64,
    ) -> Result<Self::Springs<L>, SceneError>;

    /// Makes the core's colliders.
    ///
    /// # Errors
    ///
    /// If the parts have none, or the number type does not represent them.
    fn obstacles(scene: &Description, units: &Units) -> Result<Self::Obstacles, SceneError>;
}

/// Every part that a scene file can describe.
#[derive(Clone, Copy, Debug)]
pub enum Everything {}

impl<S: Scalar + Send> Parts<S> for Everything {
    type Air = (Option<FacetWind<S>>, Option<AerodynamicWind<S>>, Option<PanelWind<S>>);
    type Springs<L: Springs<S>> = Damped<L, S>;
    type Hand = Option<Hand<S>>;
    type Obstacles = Solids<S>;

    fn air(units: &Units, wind: Option<&Wind>) -> Result<Self::Air, SceneError> {
        if let Some(wind) = wind {
            finite(VELOCITY, &wind.velocity)?;
        }
        match wind {
            Some(&Wind { velocity, model: WindModel::Aerodynamic { density, drag_coefficient } }) => {
                still_finite(density, drag_coefficient)?;
                let flow = units.aerodynamic_wind(velocity, density, drag_coefficient);
                Fit::<S>::constant(VELOCITY, flow.wind)?;
                Fit::<S>::constant("environment.wind.density", [flow.pressure])?;
                Ok((None, Some(AerodynamicWind::new(flow)), None))
            }
            Some(&Wind { velocity, model: WindModel::Panel { density, drag_coefficient } }) => {
                still_finite(density, drag_coefficient)?;
                let flow = units.panel_wind(velocity, density, drag_coefficient);
                Fit::<S>::constant(VELOCITY, flow.wind)?;
                Fit::<S>::constant("environment.wind.density", [flow.pressure])?;
                Ok((None, None, Some(PanelWind::new(flow))))
            }
            Some(Wind { velocity, model: WindModel::Facet }) => {
                let flow = units.facet_wind(*velocity);
                Fit::<S>::constant(VELOCITY, flow.wind)?;
                Ok((Some(FacetWind::new(flow)), None, None))
            }
            None => Ok((None, None, None)),
        }
    }

    fn hand(units: &Units, grip: &Grip) -> Result<Self::Hand, SceneError> {
        grip.check()?;
        let (spring, damper) = (units.compliance(grip.compliance), units.damping(grip.damping));
        Fit::<S>::constant("hand.compliance", [spring.dividend])?;
        Fit::<S>::constant("hand.damping", [damper.dividend])?;
        let reach = Length(grip.reach / units.cell);
        Fit::<S>::number("hand.reach", reach.0)?;
        Ok(Some(Hand::new(units, spring, damper, reach)))
    }

    fn present(hand: &mut Self::Hand) -> Option<&mut Hand<S>> {
        hand.as_mut()
    }

    fn springs<L: Springs<S>>(
        units: &Units,
        table: &str,
        springs: L,
        damping: f64,
    ) -> Result<Self::Springs<L>, SceneError> {
        let damping = units.damping(damping);
        Fit::<S>::constant(format!("{table}.damping"), [damping.dividend])?;
        Ok(Damped::new(springs, damping))
    }

    fn obstacles(scene: &Description, units: &Units) -> Result<Solids<S>, SceneError> {
        scene.solids(units)
    }
}

/// Checks values that no file reader has checked: they may be set while a scene runs.
fn still_finite(density: f64, drag_coefficient: f64) -> Result<(), SceneError> {
    finite("environment.wind.density", &[density])?;
    finite("environment.wind.drag_coefficient", &[drag_coefficient])
}

/// A sheet of undamped springs under gravity and drag, and nothing else. Most goals of a solver are measured on such sheets.
#[derive(Clone, Copy, Debug)]
pub enum Bare {}

impl<S: Scalar + Send> Parts<S> for Bare {
    type Air = ();
    type Springs<L: Springs<S>> = L;
    type Hand = ();
    type Obstacles = ();

    fn air(_: &Units, wind: Option<&Wind>) -> Result<(), SceneError> {
        wind.map_or(Ok(()), |_| Err(SceneError::new("environment.wind", "a bare sheet has no wind")))
    }

    fn hand(_: &Units, _: &Grip) -> Result<(), SceneError> {
        Err(SceneError::new("hand", "nothing takes hold of a bare sheet"))
    }

    fn present((): &mut ()) -> Option<&mut Hand<S>> {
        None
    }

    fn springs<L: Springs<S>>(_: &Units, table: &str, springs: L, damping: f64) -> Result<L, SceneError> {
        if damping == 0.0 {
            Ok(springs)
        } else {
            Err(SceneError::new(format!("{table}.damping"), "these springs have no dampers"))
        }
    }

    fn obstacles(scene: &Description, _: &Units) -> Result<(), SceneError> {
        let present =
            [("sphere", scene.spheres.len()), ("plane", scene.planes.len()), ("capsule", scene.capsules.len())];
        let found = present.into_iter().find(|(_, count)| *count > 0);
        found.map_or(Ok(()), |(table, _)| Err(SceneError::new(table, "a bare sheet has nothing in its way")))
    }
}

const VELOCITY: &str = "environment.wind.velocity";

#[cfg(test)]
mod tests {
    use std::vec::Vec;

    use super::*;
    use crate::host::{Counted, SolverKind};

    const SCENE: &str = r#"
        [cloth]
        columns = 4
        rows = 4
        width = 1.0
        height = 1.0
        density = 0.2
        pins = "left"
        [stretch]
        stiffness = 100.0
        [shear]
        stiffness = 10.0
        [environment]
        gravity = [0.0, 0.0, -9.81]
        drag = 0.3
        wind = { velocity = [1.0, 3.0, 0.5], model = "facet" }
        [[sphere]]
        centre = [0.6, 0.5, -0.3]
        radius = 0.2
        [solver]
        step = 0.02
        substeps = 4
    "#;

    /// The same scene without wind and ball.
    fn calm() -> Description {
        Description { wind: None, spheres: Vec::new(), ..Description::parse(SCENE).unwrap() }
    }

    #[test]
    fn fewer_parts_give_the_same_bits() {
        fn digest<P: Parts<f32>>(scene: &Description) -> u32 {
            let mut moving = scene.simulation_on::<P, f32, 4, 4>().unwrap();
            (0..25).for_each(|_| moving.frame());
            moving.digest()
        }
        let mut scene = calm();
        for kind in SolverKind::ALL {
            scene.solver.kind = kind;
            assert_eq!(digest::<Bare>(&scene), digest::<Everything>(&scene), "{kind:?}");
        }
    }

    #[test]
    fn what_a_scene_does_not_name_takes_no_more_than_a_look() {
        fn operations<P: Parts<Counted>>(scene: &Description) -> u64 {
            let mut moving = scene.simulation_on::<P, Counted, 4, 4>().unwrap();
            Counted::reset();
            moving.frame();
            Counted::operations().total()
        }
        let mut scene = calm();
        for kind in SolverKind::ALL {
            scene.solver.kind = kind;
            let (all, needed) = (operations::<Everything>(&scene), operations::<Bare>(&scene));
            // the difference is a check for dampers at each visit of a family
            assert!(100 * (all - needed) < needed, "{kind:?}: {all}, {needed}");
        }
    }

    /// Values that are set while a scene runs come from no file, so the simulation checks them.
    #[test]
    fn what_is_undefined_is_refused() {
        let mut moving = Description::parse(SCENE).unwrap().simulation_on::<Everything, crate::Q24, 4, 4>().unwrap();
        for bad in [f64::NAN, f64::INFINITY] {
            let refused = moving.set_gravity([0.0, bad, 0.0]).unwrap_err();
            assert_eq!(refused.key, "environment.gravity");
            let [density, drag_coefficient] = [1.2; 2];
            let models = [
                WindModel::Facet,
                WindModel::Aerodynamic { density, drag_coefficient },
                WindModel::Panel { density, drag_coefficient },
            ];
            for model in models {
                assert_eq!(moving.set_wind(Some(&Wind { velocity: [bad; 3], model })).unwrap_err().key, VELOCITY);
            }
            let model = WindModel::Aerodynamic { density: bad, drag_coefficient: 1.2 };
            let refused = moving.set_wind(Some(&Wind { velocity: [1.0; 3], model })).unwrap_err();
            assert_eq!(refused.key, "environment.wind.density");
        }
    }

    #[test]
    fn what_is_not_there_is_refused() {
        fn refused(scene: &Description) -> Option<std::string::String> {
            scene.simulation_on::<Bare, f32, 4, 4>().err().map(|error| error.key)
        }
        let parsed = |from: &str, to: &str| Description::parse(&SCENE.replace(from, to)).unwrap();
        let (wind, spheres) = (parsed("", "").wind, parsed("", "").spheres);
        assert_eq!(refused(&calm()), None);
        assert_eq!(refused(&Description { wind, ..calm() }).as_deref(), Some("environment.wind"));
        assert_eq!(refused(&Description { spheres, ..calm() }).as_deref(), Some("sphere"));
        let refused =
            |from: &str, to: &str| refused(&Description { wind: None, spheres: Vec::new(), ..parsed(from, to) });
        assert_eq!(refused("stiffness = 10.0", "stiffness = 10.0\ndamping = 0.1").as_deref(), Some("shear.damping"));
        assert_eq!(refused(" = 4\n        rows = 4", " = 8\n        rows = 8").as_deref(), Some("cloth.columns"));
    }
}
