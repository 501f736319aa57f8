//! The strength of a hand.

use super::description::Description;
use super::error::SceneError;

/// A hand's spring, damper and reach: see [`Hand`](crate::Hand).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// The compliance of the spring, m/N.
    pub compliance: f64,
    /// The strength of the damper, N·s/m.
    pub damping: f64,
    /// The distance beyond which the force of the spring does not grow, m.
    pub reach: f64,
    /// The largest speed at which a pin is carried, m/s. No force moves a pin.
    pub speed: f64,
}

/// The largest force of the hand, in weights of the sheet.
const WEIGHTS: f64 = 4.0;
/// The reach, in longer sides of the sheet, and below the speed, in longer sides per second.
const REACH: f64 = 0.25;
const SPEED: f64 = 3.0;
/// The damping, in √(stiffness of the hand · mass of the sheet): small, so that the hand does not brake the sheet.
const DAMPING: f64 = 0.125;
/// m/s²
const GRAVITY: f64 = 9.81;

impl Grip {
    /// A grip in proportion to a scene's sheet. Its force is at most four weights of the sheet, reached at a distance of a quarter of the sheet's longer side.
    pub fn of(scene: &Description) -> Self {
        let sheet = &scene.sheet;
        let side = sheet.width.max(sheet.height);
        let along = |particles: usize| if sheet.shares_area() { particles.max(2) - 1 } else { particles };
        let mass = sheet.mass * (along(sheet.columns) * along(sheet.rows)) as f64;
        let reach = REACH * side;
        let compliance = reach / (WEIGHTS * GRAVITY * mass);
        Self { compliance, damping: DAMPING * libm::sqrt(mass / compliance), reach, speed: SPEED * side }
    }

    /// Refuses a grip that is invalid in every number type.
    pub(super) fn check(&self) -> Result<(), SceneError> {
        let Self { compliance, damping, reach, speed } = *self;
        let named = [("compliance", compliance), ("damping", damping), ("reach", reach), ("speed", speed)];
        let refused = named.into_iter().find(|(_, value)| !(*value >= 0.0 && value.is_finite()));
        refused.map_or(Ok(()), |(name, _)| {
            Err(SceneError::new(std::format!("hand.{name}"), "must be finite, zero or above"))
        })
    }
}

#[cfg(test)]
mod tests {
    use std::boxed::Box;
    use std::string::String;

    use super::*;
    use crate::host::{Bare, Everything, Simulation, SolverKind};
    use crate::scalar::{Q24, Scalar};

    /// A sheet of 0.2 kg that lies in the air, pinned at two corners.
    const SCENE: &str = "
        [cloth]
        columns = 4
        rows = 4
        width = 1.0
        height = 1.0
        density = 0.2
        pins = [[0, 0], [3, 0]]
        [stretch]
        stiffness = 100.0
        [shear]
        stiffness = 10.0
        [environment]
        gravity = [0.0, 0.0, -9.81]
        drag = 1.0
        [solver]
        step = 0.02
        substeps = 8
    ";

    fn scene() -> Description {
        Description::parse(SCENE).unwrap()
    }

    fn moving<S: Scalar + Send>(scene: &Description) -> Box<dyn Simulation> {
        let mut moving = scene.simulation_on::<Everything, S, 4, 4>().unwrap();
        play(&mut *moving, 50);
        moving
    }

    fn play(moving: &mut dyn Simulation, frames: u32) {
        (0..frames).for_each(|_| moving.frame());
    }

    fn place(moving: &dyn Simulation, column: usize, row: usize) -> [f64; 3] {
        moving.still().positions[4 * row + column]
    }

    fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
        libm::sqrt((0..3).map(|axis| (a[axis] - b[axis]) * (a[axis] - b[axis])).sum())
    }

    fn stretch(moving: &dyn Simulation) -> f64 {
        moving.strains().stretch.unwrap().largest
    }

    #[test]
    fn a_hand_pulls_with_four_weights_of_the_sheet() {
        let Grip { compliance, reach, .. } = Grip::of(&scene());
        assert!((reach / compliance - 4.0 * 0.2 * 9.81).abs() < 1e-12);
        assert_eq!(reach, 0.25);
    }

    /// By every solver that is stable here, in floats and fixed point.
    #[test]
    fn what_is_dragged_follows_and_what_is_released_falls() {
        fn check<S: Scalar + Send>(scene: &Description) {
            let mut moving = moving::<S>(scene);
            let from = place(&*moving, 2, 3);
            let [x, y, z] = from;
            let target = [x + 0.1, y, z + 0.3];
            moving.grab(2, 3, &Grip::of(scene)).unwrap();
            moving.drag(target);
            play(&mut *moving, 100);
            let dragged = place(&*moving, 2, 3);
            let left = apart(dragged, target);
            assert!(left < 0.15, "{:?} in {}: {left} m before its target", scene.solver.kind, S::NAME);
            moving.release();
            play(&mut *moving, 20);
            let fallen = dragged[2] - place(&*moving, 2, 3)[2];
            assert!(fallen > 0.1, "{:?} in {}: fallen by {fallen} m", scene.solver.kind, S::NAME);
        }
        let mut scene = scene();
        // forward Euler does not stay stable here without a hand
        for kind in SolverKind::ALL.into_iter().filter(|kind| *kind != SolverKind::ForwardEuler) {
            scene.solver.kind = kind;
            check::<f32>(&scene);
            check::<Q24>(&scene);
        }
    }

    /// Wherever the pointer goes, links are stretched by the stated force and no further.
    #[test]
    fn a_hand_overstretches_nothing_however_far_it_goes() {
        fn check<S: Scalar + Send>() {
            let scene = scene();
            let mut moving = moving::<S>(&scene);
            moving.grab(3, 3, &Grip::of(&scene)).unwrap();
            for target in [[1e9, -1e9, 1e9], [-1e9, 1e9, -1e9], [f64::NAN; 3], [0.0, 0.0, 1e300]] {
                moving.drag(target);
                for _ in 0..100 {
                    moving.frame();
                    // four weights strain a single link, of 100 N/m and a third of a metre, by 0.24; when they reverse, by twice that
                    assert!(moving.is_finite() && stretch(&*moving) < 0.5, "{}: {}", S::NAME, stretch(&*moving));
                }
            }
        }
        check::<f32>();
        check::<Q24>();
    }

    #[test]
    fn a_pin_is_carried_at_a_speed() {
        let scene = scene();
        let mut moving = moving::<Q24>(&scene);
        let from = place(&*moving, 0, 0);
        moving.grab(0, 0, &Grip::of(&scene)).unwrap();
        moving.drag([from[0] - 0.1, from[1], from[2] + 0.1]);
        moving.frame();
        let carried = apart(place(&*moving, 0, 0), from);
        assert!((carried - 3.0 * 0.02).abs() < 1e-5, "{carried}");
        moving.release();
        let left = place(&*moving, 0, 0);
        play(&mut *moving, 10);
        assert_eq!(place(&*moving, 0, 0), left, "a pin stays");
        assert!(moving.state().pinned[0]);
    }

    /// A sheet at rest wakes when it is dragged.
    #[test]
    fn a_sheet_at_rest_wakes_in_a_hand() {
        let scene = Description::parse(&std::format!("{SCENE}\n[rest]\n")).unwrap();
        let mut moving = moving::<f32>(&scene);
        (0..2000).take_while(|_| !moving.is_at_rest()).count();
        play(&mut *moving, 2000);
        assert!(moving.is_at_rest());
        let [x, y, z] = place(&*moving, 2, 3);
        moving.grab(2, 3, &Grip::of(&scene)).unwrap();
        moving.drag([x, y + 0.2, z]);
        play(&mut *moving, 10);
        assert!(!moving.is_at_rest() && place(&*moving, 2, 3)[1] > y + 0.02);
    }

    #[test]
    fn no_grip_is_refused_in_a_line() {
        let scene = scene();
        let grip = Grip::of(&scene);
        let mut moving = moving::<Q24>(&scene);
        let before = moving.digest();
        let mut refused = |grip: Grip| -> String { moving.grab(1, 1, &grip).unwrap_err().key };
        assert_eq!(refused(Grip { compliance: -1.0, ..grip }), "hand.compliance");
        assert_eq!(refused(Grip { damping: f64::NAN, ..grip }), "hand.damping");
        assert_eq!(refused(Grip { reach: 1e6, ..grip }), "hand.reach");
        assert_eq!(refused(Grip { compliance: 1e9, ..grip }), "hand.compliance", "too weak for fixed point");
        moving.drag([0.0; 3]);
        moving.release();
        assert_eq!(moving.digest(), before);
        let bare = Description { spheres: std::vec::Vec::new(), ..scene };
        let mut bare = bare.simulation_on::<Bare, f32, 4, 4>().unwrap();
        assert_eq!(bare.grab(1, 1, &grip).unwrap_err().key, "hand");
    }
}
