//! Symmetry: a mirrored or shifted scene has the mirrored or shifted motion.

use kerchief::{Q13, Q24, Scalar};

use rig::reference::{Model, Wind};
use rig::scenes::{corners, syrup};
use rig::{Method, Pace, moved};

/// The solvers that are stable for the sheets below in every number type.
const METHODS: [Method; 4] = [Method::BackwardEuler, Method::Verlet(4), Method::Xpbd, Method::Lines(2)];

/// The largest difference between a sheet and its mirror image in 10 s, over the sheet's size.
fn asymmetry<S: Scalar>(mut model: Model, method: Method) -> f64 {
    model.sheet.origin = [-5.0, 0.0, 0.0];
    let mut motion = moved::<S, 8, 8>(&model, Pace::new(0.1, 32), method);
    let mut worst = 0.0_f64;
    for _ in 0..10 {
        motion.run(10);
        let x = motion.state().position;
        let pairs = (0..8).flat_map(|row| (0..8).map(move |column| (row * 8 + column, row * 8 + 7 - column)));
        let differences = pairs.flat_map(|(a, b)| [x[a][0] + x[b][0], x[a][1] - x[b][1], x[a][2] - x[b][2]]);
        worst = differences.fold(worst, |worst, difference| worst.max(difference.abs()));
    }
    worst / 10.0
}

#[test]
fn a_mirrored_sheet_moves_as_the_mirror_image() {
    for model in [corners(8), syrup(8)] {
        // links are visited in colours or all at once, and rows are solved from both ends, so that no side comes first
        for method in METHODS {
            assert_eq!(asymmetry::<f32>(model.clone(), method), 0.0, "{method:?} in f32");
            assert_eq!(asymmetry::<f64>(model.clone(), method), 0.0, "{method:?} in f64");
            // ties are rounded up, which in the mirror image is down; a swinging sheet amplifies the difference
            let [q24, q13] = [asymmetry::<Q24>(model.clone(), method), asymmetry::<Q13>(model.clone(), method)];
            assert!(q24 < 2e-4, "{method:?} in q24: {q24:e}");
            assert!(q13 < 2e-3, "{method:?} in q13: {q13:e}");
        }
    }
    assert_eq!(asymmetry::<f32>(corners(8), Method::Leapfrog), 0.0);
    assert_eq!(asymmetry::<f64>(corners(8), Method::Leapfrog), 0.0);
}

/// The triangles of every cell meet in the same diagonal, in both halves of the sheet.
#[test]
fn wind_has_no_mirror() {
    let air = Wind::Aerodynamic { velocity: [0.0, 3.0, 1.0], density: 1.2, drag_coefficient: 1.2 };
    for wind in [Wind::Facet([0.0, 3.0, 1.0]), air] {
        let asymmetry = asymmetry::<f64>(Model { wind: Some(wind.clone()), ..corners(8) }, Method::Xpbd);
        assert!((1e-2..0.2).contains(&asymmetry), "{asymmetry} in {wind:?}");
    }
}

/// A cell's diagonals are each other's mirror images.
#[test]
fn wind_on_panels_has_a_mirror() {
    let wind = Wind::Panel { velocity: [0.0, 3.0, 1.0], density: 1.2, drag_coefficient: 1.2 };
    for method in METHODS {
        let model = Model { wind: Some(wind.clone()), ..corners(8) };
        assert_eq!(asymmetry::<f32>(model.clone(), method), 0.0, "{method:?} in f32");
        assert_eq!(asymmetry::<f64>(model.clone(), method), 0.0, "{method:?} in f64");
        let [q24, q13] = [asymmetry::<Q24>(model.clone(), method), asymmetry::<Q13>(model, method)];
        assert!(q24 < 2e-3 && q13 < 4e-3, "{method:?}: {q24:e} in q24, {q13:e} in q13");
    }
}

#[test]
fn the_same_scene_elsewhere_moves_the_same() {
    for method in [Method::BackwardEuler, Method::Xpbd, Method::Lines(2), Method::Leapfrog] {
        let here = corners(8);
        let mut there: Model = corners(8);
        there.sheet.origin = [3.0, -7.0, 5.0];
        let [mut a, mut b] = [&here, &there].map(|model| moved::<f64, 8, 8>(model, Pace::new(0.1, 32), method));
        a.run(10);
        b.run(10);
        for (x, y) in a.state().position.iter().zip(&b.state().position) {
            for (axis, shift) in [3.0, -7.0, 5.0].into_iter().enumerate() {
                let error = y[axis] - x[axis] - shift;
                assert!(error.abs() < 1e-7, "{method:?}: {error:e} m");
            }
        }
    }
}
