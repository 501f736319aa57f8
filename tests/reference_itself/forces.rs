//! Masses, poses and forces of single links and cells, worked out by hand.

use super::{acceleration, assert_near};
use rig::reference::vector::{add, dot, scale};
use rig::reference::{BEND, Family, Model, Pose, SHEAR, STRETCH, Sheet, Vector, Wind};

#[test]
fn poses_are_the_models() {
    let lay = Sheet::new(Pose::Lay, [3, 2], [2.0, 5.0]).with_origin([1.0, 2.0, 3.0]).positions();
    assert_eq!(lay[..2], [[1.0, 2.0, 3.0], [2.0, 2.0, 3.0]]);
    assert_eq!(lay[5], [3.0, 7.0, 3.0]);
    let hang = Sheet::new(Pose::Hang, [3, 2], [2.0, 5.0]).positions();
    assert_eq!(hang[5], [2.0, 0.0, -5.0]);
    let chain = Sheet::new(Pose::Hang, [1, 3], [7.0, 4.0]);
    assert_eq!(chain.positions(), [[0.0, 0.0, 0.0], [0.0, 0.0, -2.0], [0.0, 0.0, -4.0]]);
    assert_eq!(chain.size(), 4.0);
}

#[test]
fn density_spreads_the_mass_of_the_area() {
    let sheet = Sheet::new(Pose::Lay, [4, 3], [3.0, 4.0]).with_density(0.5);
    assert_near([sheet.masses.iter().sum(), 0.0, 0.0], [6.0, 0.0, 0.0], 1e-14);
    let share = |column, row| sheet.masses[sheet.index((column, row))];
    // A cell of 2 m² weighs 1 kg. A particle has a quarter of each cell around it.
    assert_eq!([share(0, 0), share(1, 0), share(3, 1), share(1, 1)], [0.25, 0.5, 0.5, 1.0]);
    let hemmed = sheet.clone().with_hem(2.0);
    assert_eq!(hemmed.masses, [[0.5, 1.0, 1.0, 0.5], [1.0, 1.0, 1.0, 1.0], [0.5, 1.0, 1.0, 0.5]].concat());
}

#[test]
fn pins_are_where_they_are_named() {
    let sheet = Sheet::new(Pose::Hang, [3, 2], [1.0, 1.0]);
    assert_eq!(sheet.clone().with_top_pinned().pins, [(0, 0), (1, 0), (2, 0)]);
    assert_eq!(sheet.clone().with_left_pinned().pins, [(0, 0), (0, 1)]);
    let model = Model { gravity: [0.0, 0.0, -2.0], ..Model::new(sheet.with_pins(&[(2, 0)]).with_pins(&[(0, 1)])) };
    let fall = acceleration(&model, &model.start()).iter().map(|a| a[2]).collect::<Vec<_>>();
    assert_eq!(fall, [-2.0, -2.0, 0.0, 0.0, -2.0, -2.0]);
}

#[test]
fn a_stretched_link_pulls_by_hand() {
    // Two particles 3 m apart, with a link of 2 m and k = 5 N/m: 5 N. They part at 4 m/s across the link: 0.5·4 N.
    let mut model = Model::new(Sheet::new(Pose::Lay, [2, 1], [2.0, 0.0]));
    model.sheet.masses = vec![1.0, 4.0];
    model.families.push(Family::new(STRETCH, 5.0).damped(0.5));
    let mut state = model.start();
    state.position[1][0] = 3.0;
    state.velocity[1][1] = 4.0;
    assert_eq!(acceleration(&model, &state), [[5.0, 2.0, 0.0], [-1.25, -0.5, 0.0]]);
}

#[test]
fn every_family_has_its_links() {
    // A 3×3 grid with cells of 1×1. With all distances doubled, a link of rest length L exerts a force of k·L.
    let pull = |offsets| {
        let mut model = Model::new(Sheet::new(Pose::Lay, [3, 3], [2.0, 2.0]));
        model.families.push(Family::new(offsets, 1.0));
        let mut state = model.start();
        state.position.iter_mut().for_each(|x| *x = scale(2.0, *x));
        acceleration(&model, &state)
    };
    let close = |a: &[Vector], b: [[f64; 2]; 3]| {
        // The three particles of the first row.
        a.iter().zip(b).for_each(|(&a, [x, y])| assert_near(a, [x, y, 0.0], 1e-15));
    };
    close(&pull(STRETCH), [[1.0, 1.0], [0.0, 1.0], [-1.0, 1.0]]);
    close(&pull(SHEAR), [[1.0, 1.0], [0.0, 2.0], [-1.0, 1.0]]);
    close(&pull(BEND), [[2.0, 2.0], [0.0, 2.0], [-2.0, 2.0]]);
}

/// One cell of 2 m × 3 m in the x-y plane, in the wind.
fn cell(wind: Wind) -> Model {
    Model { wind: Some(wind), ..Model::new(Sheet::new(Pose::Lay, [2, 2], [2.0, 3.0])) }
}

#[test]
fn facet_wind_on_a_cell_by_hand() {
    // Both triangles have n = ±(0, 0, 6): n·(n/|n| · wind) = 6·wind_z ẑ on each of their corners, whichever way
    // round they are listed. p and t belong to one triangle, q and s to both.
    let model = cell(Wind::Facet([7.0, 5.0, -0.5]));
    let a = acceleration(&model, &model.start());
    assert_eq!(a, [[0.0, 0.0, -3.0], [0.0, 0.0, -6.0], [0.0, 0.0, -6.0], [0.0, 0.0, -3.0]]);

    // Upright, it catches the wind's y instead.
    let mut upright = model.clone();
    upright.sheet.pose = Pose::Hang;
    assert_eq!(acceleration(&upright, &upright.start())[1], [0.0, 60.0, 0.0]);

    // With t lifted by 2 m: (q - t)×(s - t) = (0, -3, -2)×(-2, 0, -2) = (6, 4, -6), |n|² = 88.
    let mut lifted = model.start();
    lifted.position[3][2] = 2.0;
    let n = [6.0, 4.0, -6.0];
    let across = dot(n, [7.0, 5.0, -0.5]) / 88.0_f64.sqrt();
    let a = acceleration(&model, &lifted);
    assert_near(a[3], scale(across, n), 1e-13);
    assert_near(a[0], [0.0, 0.0, -3.0], 1e-14);
    assert_near(a[1], add(a[0], a[3]), 1e-13);
}

#[test]
fn aerodynamic_wind_on_a_cell_by_hand() {
    // Relative wind 2 m/s up; a triangle of 3 m²: ½·1.2·0.5·3·2² = 3.6 N, a third of it on each corner.
    let model = cell(Wind::Aerodynamic { velocity: [9.0, 0.0, 3.0], density: 1.2, drag_coefficient: 0.5 });
    let mut state = model.start();
    state.velocity.fill([-4.0, 1.0, 1.0]);
    let a = acceleration(&model, &state);
    for (a, expected) in a.iter().zip([1.2, 2.4, 2.4, 1.2]) {
        assert_near(*a, [0.0, 0.0, expected], 1e-14);
    }
    // As much faster than the wind, it gets the opposite force. A triangle has the mean velocity of its corners.
    state.velocity.fill([0.0, 0.0, 5.0]);
    assert_near(acceleration(&model, &state)[1], [0.0, 0.0, -2.4], 1e-14);
    state.velocity = vec![[0.0, 0.0, 3.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 0.0]];
    assert_near(acceleration(&model, &state)[0], [0.0, 0.0, 1.2], 1e-14);
    assert_near(acceleration(&model, &state)[3], [0.0, 0.0, 2.7], 1e-14);
}
