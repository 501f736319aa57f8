//! Forces, links and colliders of a scene, in any number type.
//!
//! A number type that doesn't represent a constant to within a sixteenth is refused here, so that the page can name the constant. The library would panic.

use kerchief::material::Springs;
use kerchief::{Bend, Damped, Drag, Gravity, Hand, PanelWind, Plane, Scalar, Shear, Sheet, Sphere, Stretch};

use crate::settings::{SIZE, Settings, Solver};

/// The constant that the number type does not represent.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// Gravity.
    Gravity = 1,
    /// Drag.
    Drag,
    /// Wind.
    Wind,
    /// Stretch springs.
    Stretch,
    /// Shear springs.
    Shear,
    /// Bend springs.
    Bend,
    /// The dampers of springs.
    Damping,
}

/// Gravity, drag and wind.
pub type Weather<S> = (Gravity<S>, Drag<S>, Option<PanelWind<S>>);
/// All forces but those of springs.
pub type Forces<S> = (Gravity<S>, Drag<S>, Option<PanelWind<S>>, Hand<S>);
/// Springs with their dampers.
pub type Links<S> = (Damped<Stretch<S>, S>, Option<Damped<Shear<S>, S>>, Option<Damped<Bend<S>, S>>);
/// The colliders: ball and floor.
pub type Obstacles<S> = (Option<Sphere<S>>, Plane<S>);

/// The angle of folds between neighbouring cells at which bend springs are as stiff as the fabric, rad.
const FOLD: f64 = 0.5;
/// The ball's radius, and the margin at which particles keep from it, m.
pub const BALL: f64 = 0.15;
const BALL_MARGIN: f64 = 0.012;
const BALL_FRICTION: f64 = 0.3;
/// The margin at which particles keep from the floor, m.
const FLOOR_MARGIN: f64 = 0.004;
const FLOOR_FRICTION: f64 = 0.5;
/// Density of air, kg/m³, and the drag coefficient of a plate.
const AIR: f64 = 1.2;
const PLATE: f64 = 1.2;
/// The hand: the distance up to which its force grows (m), its largest force (weights of the sheet), its damping (N·s/m).
const REACH: f64 = 0.15;
const WEIGHTS: f64 = 4.0;
const GRIP: f64 = 0.3;

/// Whether `S` represents these components to within a sixteenth of the largest.
fn represents<S: Scalar, const M: usize>(values: [f64; M]) -> bool {
    let largest = values.into_iter().fold(0.0, |largest: f64, value| largest.max(value.abs()));
    largest <= S::LARGEST
        && values.into_iter().all(|value| 16.0 * (S::from_f64(value).to_f64() - value).abs() <= largest)
}

/// Refuses a constant that `S` does not represent.
fn check<S: Scalar, const M: usize>(refusal: Refusal, values: [f64; M]) -> Result<(), Refusal> {
    if represents::<S, M>(values) { Ok(()) } else { Err(refusal) }
}

/// The stiffness of the sheet's springs, N/m; zero for families that are off.
pub fn stiffness<S: Scalar, const N: usize>(sheet: &Sheet<S, N, N>, settings: &Settings) -> Springs {
    let Springs { stretch, shear, bend } = settings.material().springs(&sheet.units, FOLD);
    let times = |stiffness: f64, there: bool| if there { stiffness * settings.stiffness } else { 0.0 };
    Springs { stretch: times(stretch, true), shear: times(shear, settings.shear), bend: times(bend, settings.bend) }
}

/// Springs and dampers.
///
/// # Errors
/// If `S` does not represent a stiffness or a damping.
pub fn links<S: Scalar, const N: usize>(sheet: &Sheet<S, N, N>, settings: &Settings) -> Result<Links<S>, Refusal> {
    let Springs { stretch, shear, bend } = stiffness(sheet, settings);
    // Verlet divides the stiffness among its sweeps: `S` has to represent a sweep's part, too.
    let sweeps = if settings.solver == Solver::Verlet { f64::from(settings.sweeps) } else { 1.0 };
    let damper = |refusal: Refusal, stiffness: f64| {
        let damper = settings.damping * stiffness;
        for part in [1.0, sweeps] {
            let strength = sheet.units.stiffness(stiffness / part);
            check::<S, 1>(refusal, [strength.dividend])?;
        }
        check::<S, 1>(Refusal::Damping, [sheet.units.damping(damper).dividend])?;
        Ok(damper)
    };
    let dampers = [damper(Refusal::Stretch, stretch)?, damper(Refusal::Shear, shear)?, damper(Refusal::Bend, bend)?];
    Ok((
        sheet.damped(sheet.stretch(stretch), dampers[0]),
        settings.shear.then(|| sheet.damped(sheet.shear(shear), dampers[1])),
        settings.bend.then(|| sheet.damped(sheet.bend(bend), dampers[2])),
    ))
}

/// Gravity, drag and wind.
///
/// # Errors
/// If `S` does not represent a component.
pub fn weather<S: Scalar, const N: usize>(sheet: &Sheet<S, N, N>, settings: &Settings) -> Result<Weather<S>, Refusal> {
    let units = &sheet.units;
    check::<S, 3>(Refusal::Gravity, units.acceleration(settings.gravity()).0)?;
    check::<S, 1>(Refusal::Drag, [units.drag(settings.drag).rate])?;
    let wind = if settings.wind > 0.0 {
        let flow = units.panel_wind(settings.air(), AIR, PLATE);
        check::<S, 3>(Refusal::Wind, flow.wind)?;
        check::<S, 1>(Refusal::Wind, [flow.pressure])?;
        Some(PanelWind::new(flow))
    } else {
        None
    };
    Ok((sheet.gravity(settings.gravity()), sheet.drag(settings.drag), wind))
}

/// A hand without a particle.
pub fn hand<S: Scalar, const N: usize>(sheet: &Sheet<S, N, N>, settings: &Settings) -> Hand<S> {
    let weight = 9.81 * settings.material().density * SIZE * SIZE;
    sheet.hand(REACH / (WEIGHTS * weight), GRIP, REACH)
}

/// The ball, if there is one.
pub fn ball<S: Scalar, const N: usize>(sheet: &Sheet<S, N, N>, settings: &Settings) -> Option<Sphere<S>> {
    settings.ball.then(|| sheet.ball(settings.start.ball(), BALL, BALL_MARGIN).with_friction(BALL_FRICTION))
}

/// The floor.
pub fn floor<S: Scalar, const N: usize>(sheet: &Sheet<S, N, N>) -> Plane<S> {
    sheet.plane([0.0; 3], [0.0, 0.0, 1.0], FLOOR_MARGIN).with_friction(FLOOR_FRICTION)
}

#[cfg(test)]
mod tests {
    use kerchief::{Q13, Q24};

    use super::*;
    use crate::settings::FRAME;

    fn sheet<S: Scalar>(substeps: u32, settings: &Settings) -> Sheet<S, 16, 16> {
        Sheet::of(&settings.material(), [SIZE; 2], FRAME, substeps)
    }

    #[test]
    fn every_fabric_fits_every_number_type_in_any_substep_of_the_page() {
        fn check<S: Scalar>() {
            for fabric in 0..8 {
                for substeps in [1, 8, 64] {
                    let settings = Settings { fabric, wind: 6.0, ..Settings::DEFAULT };
                    let sheet = sheet::<S>(substeps, &settings);
                    assert!(links(&sheet, &settings).is_ok(), "{} {fabric} {substeps}", S::NAME);
                    assert!(weather(&sheet, &settings).is_ok(), "{} {fabric} {substeps}", S::NAME);
                    let _ = (hand(&sheet, &settings), ball(&sheet, &settings), floor(&sheet));
                }
            }
        }
        check::<f32>();
        check::<f64>();
        check::<Q24>();
        check::<Q13>();
    }

    #[test]
    fn what_fixed_point_does_not_represent_is_named() {
        let soft = Settings { stiffness: 1e-6, ..Settings::DEFAULT };
        assert_eq!(links(&sheet::<Q24>(64, &soft), &soft).err(), Some(Refusal::Stretch));
        assert!(links(&sheet::<f32>(64, &soft), &soft).is_ok());
        let thin = Settings { drag: 1e-4, ..Settings::DEFAULT };
        assert_eq!(weather(&sheet::<Q24>(64, &thin), &thin).err(), Some(Refusal::Drag));
    }
}
