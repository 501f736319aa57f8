//! Wrappers around links forward everything, in any order of nesting.

use kerchief::link::{Family, Links, Visitor};
use kerchief::{Cloth, Damped, Node, Q24, Scalar, Scene, Shear, StrainLimited, Stretch, Units, Vec3, Verlet};

const UNITS: Units = Units::sheet([5, 4], [0.4, 0.3], 1e-3, 0.02, 4);

/// Counts the families that are shown.
struct Shown(usize);

impl<S: Scalar> Visitor<S> for Shown {
    fn family<const ACROSS: usize, const DOWN: usize>(&mut self, _: &Family<S>) {
        self.0 += 1;
    }
}

fn springs<S: Scalar>() -> (Stretch<S>, Shear<S>) {
    (Stretch::new(&UNITS, UNITS.stiffness(1.0)), Shear::new(&UNITS, UNITS.stiffness(0.1)))
}

fn damped<S: Scalar, L>(links: L) -> Damped<L, S> {
    Damped::new(links, UNITS.damping(0.001))
}

fn limited<S: Scalar, L>(links: L) -> StrainLimited<L, S> {
    StrainLimited::new(links, 0.1)
}

/// The number of spring families, of damper families, and the longest edge (cells) after a frame that starts with a corner moved by three cells.
fn found<S: Scalar, L: Links<S>>(links: L) -> (usize, usize, f64) {
    let (mut shown, mut dampers) = (Shown(0), Shown(0));
    links.springs(&mut shown);
    links.dampers(&mut dampers);
    let mut cloth = Cloth::<S, 5, 4>::lay(&UNITS, UNITS.point([0.0; 3]));
    cloth.position.add(Node::new(4, 3), Vec3::from_f64([2.0, 2.0, 1.0]));
    let scene = Scene::new(&UNITS, (), links, (), Verlet { sweeps: 1 });
    scene.step(&mut cloth, &mut scene.memory());
    let place = |column, row| cloth.position.at(Node::new(column, row));
    let rows = (0..4).flat_map(|row| (0..4).map(move |column| (place(column + 1, row) - place(column, row)).length()));
    (shown.0, dampers.0, rows.map(S::to_f64).fold(0.0, f64::max))
}

fn check<S: Scalar>() {
    let (_, _, free) = found::<S, _>(springs::<S>());
    assert!(free > 1.5, "in {} the corner comes back without a limit: {free}", S::NAME);
    let nested = [
        ("a damped limit", found::<S, _>(damped::<S, _>(limited::<S, _>(springs::<S>()))), 3),
        ("a limit on damped links", found::<S, _>(limited::<S, _>(damped::<S, _>(springs::<S>()))), 3),
        ("an option", found::<S, _>(Some(damped::<S, _>(Some(limited::<S, _>(springs::<S>()))))), 3),
        (
            "a tuple of options",
            found::<S, _>((Some(limited::<S, _>(damped::<S, _>(springs::<S>()))), None::<Stretch<S>>)),
            3,
        ),
        ("twice damped", found::<S, _>(damped::<S, _>(damped::<S, _>(limited::<S, _>(springs::<S>())))), 3),
        ("twice limited", found::<S, _>(limited::<S, _>(limited::<S, _>(damped::<S, _>(springs::<S>())))), 3),
    ];
    for (name, (shown, dampers, edge), families) in nested {
        assert_eq!((shown, dampers), (families, families), "{name} in {}", S::NAME);
        assert!(edge < 1.1001, "{name} in {}: an edge of {edge} cells", S::NAME);
    }
}

#[test]
fn wrappers_forward_springs_dampers_and_limits_in_any_order() {
    check::<f32>();
    check::<f64>();
    check::<Q24>();
}
