//! What is mirrored or moved moves mirrored or moved.

use kerchief::{Q24, Scalar};

use rig::reference::Model;
use rig::scenes::corners;
use rig::{Method, Pace, moved};

/// The largest difference between a sheet on two corners and its mirror image after 10 s, over its size.
fn asymmetry<S: Scalar>(method: Method) -> f64 {
    let mut model = corners(8);
    model.sheet.origin = [-5.0, 0.0, 0.0];
    let mut motion = moved::<S, 8, 8>(&model, Pace::new(0.1, 32), method);
    motion.run(100);
    let x = motion.state().position;
    let pairs = (0..8).flat_map(|row| (0..8).map(move |column| (row * 8 + column, row * 8 + 7 - column)));
    let differences = pairs.flat_map(|(a, b)| [x[a][0] + x[b][0], x[a][1] - x[b][1], x[a][2] - x[b][2]]);
    differences.fold(0.0, |worst: f64, difference| worst.max(difference.abs())) / 10.0
}

#[test]
fn a_mirrored_sheet_moves_as_the_mirror_image() {
    // links are visited in colours or all at once and rows solved from both ends, so that no side comes first
    for method in [Method::Leapfrog, Method::Verlet(4), Method::Xpbd, Method::Lines(2), Method::LinesMindful] {
        assert_eq!(asymmetry::<f32>(method), 0.0, "{method:?} in f32");
        assert_eq!(asymmetry::<f64>(method), 0.0, "{method:?} in f64");
    }
    // a tie is rounded up, which a mirror turns down
    assert!(asymmetry::<Q24>(Method::Xpbd) < 1e-3);
    assert!(asymmetry::<Q24>(Method::Lines(2)) < 1e-3);
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
