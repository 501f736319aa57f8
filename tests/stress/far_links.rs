//! A plane far in front of a sheet's pins, which overstretches the links between them. `Q13` once took one in a hundred of such links for links near their rest length. Their
//! directions then had any length: corrections exceeded the elongations, and at last moved the sheet out of the range of fixed point.

use kerchief::collider::Plane;
use kerchief::measure::strain;
use kerchief::{Cloth, Drag, Gravity, Lines, Node, Q13, Q24, Scalar, Scene, Shear, Stretch, Units, Vec3};

/// The furthest coordinate (cells) and the largest strain of a sheet whose upper edge is pinned this many cells behind a plane.
fn torn<S: Scalar, const N: usize>(behind: f64) -> [f64; 2] {
    let cell = 0.016;
    let units = Units::sheet([N; 2], [cell * (N - 1) as f64; 2], 2e-5, 0.0074, 8);
    let mut cloth = Cloth::<S, N, N>::hang(&units, units.point([0.0; 3]));
    (0..N).for_each(|column| cloth.pin(Node::new(column, 0)));
    let normal = [0.1, -0.86, -0.5];
    let plane = Plane::<S>::new(
        units.point(normal.map(|component| behind * cell * component)),
        Vec3::from_f64(normal),
        units.length(0.0),
    );
    let forces = (Gravity::new(units.acceleration([-18.6, -10.1, -12.0])), Drag::new(units.drag(1.0)));
    let links = (Stretch::new(&units, units.stiffness(16600.0)), Shear::new(&units, units.stiffness(33800.0)));
    let scene = Scene::new(&units, forces, links, plane, Lines::new());
    let mut memory = scene.memory();
    let [mut furthest, mut largest] = [0.0_f64; 2];
    for _ in 0..20 {
        scene.step(&mut cloth, &mut memory);
        let place = cloth.position.values().flat_map(Vec3::to_f64);
        furthest = place.fold(furthest, |most, x| most.max(x.abs()));
        largest = largest.max(strain(&cloth, &scene.links).largest.to_f64());
    }
    [furthest, largest]
}

fn as_in_f64<const N: usize>() {
    for behind in [4.0, 8.0, 12.0, 16.0, 18.0, 24.0, 31.0, 36.0] {
        let exact = torn::<f64, N>(behind);
        for (found, name) in [(torn::<Q24, N>(behind), Q24::NAME), (torn::<Q13, N>(behind), Q13::NAME)] {
            let most = exact.map(|exact| 1.25 * exact + 1.0);
            assert!(found[0] < most[0] && found[1] < most[1], "{N}, {behind} in {name}: {found:.1?}, {exact:.1?}");
        }
    }
}

#[test]
fn fixed_point_holds_torn_sheets_as_floats_do() {
    as_in_f64::<8>();
    as_in_f64::<16>();
}
