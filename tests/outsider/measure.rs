//! An outsider's function for sheets of any number type and size: the centre of mass.

use kerchief::{Cloth, Gravity, Leapfrog, Q24, Scalar, Scene, Shear, Stretch, Units, measure};

/// The centre of mass of the free particles, m.
fn centre<S: Scalar, const W: usize, const H: usize>(cloth: &Cloth<S, W, H>, units: &Units) -> [f64; 3] {
    let (mut mass, mut moment) = (0.0, [0.0; 3]);
    for (position, inverse_mass) in cloth.position.values().zip(cloth.inverse_mass.values()) {
        if *inverse_mass != S::ZERO {
            let share = 1.0 / inverse_mass.to_f64();
            mass += share;
            position.to_f64().into_iter().zip(&mut moment).for_each(|(x, sum)| *sum += share * x * units.cell);
        }
    }
    moment.map(|sum| sum / mass)
}

/// The centre of mass falls by ½·g·t², with any motion within the sheet.
fn the_centre_falls_freely<S: Scalar>(bound: f64) {
    let units = Units::sheet([5, 4], [0.4, 0.3], 1e-3, 0.02, 8);
    let mut cloth = Cloth::<S, 5, 4>::lay(&units, units.point([0.0; 3]));
    cloth.share_area();
    // displaced at two corners, so that waves run through the sheet
    cloth.position.0[0].x[0] -= S::HALF;
    cloth.position.0[3].z[4] += S::HALF;
    let start = centre(&cloth, &units);
    let links = (Stretch::new(&units, units.stiffness(20.0)), Shear::new(&units, units.stiffness(5.0)));
    let scene = Scene::new(&units, Gravity::new(units.acceleration([0.0, 0.0, -9.81])), links, (), Leapfrog);
    let mut memory = scene.memory();
    let stretched = measure::strain(&cloth, &scene.links.0).largest;
    for frame in 1..=20 {
        scene.step(&mut cloth, &mut memory);
        let time = f64::from(frame) * units.frame;
        let expected = [start[0], start[1], start[2] - 0.5 * 9.81 * time * time];
        let found = centre(&cloth, &units);
        (0..3).for_each(|k| {
            let error = (found[k] - expected[k]).abs();
            assert!(error < bound, "frame {frame} in {}: {error} m off", S::NAME);
        });
    }
    assert!(measure::strain(&cloth, &scene.links.0).largest != stretched, "the sheet keeps its shape");
}

#[test]
fn a_measure_of_ones_own_serves_every_number_type() {
    the_centre_falls_freely::<f64>(1e-14);
    the_centre_falls_freely::<f32>(1e-6);
    // the velocity gained in a substep is 4.9e-3 cells per tick, rounded to 6e-6 of it, and the fall is 0.8 m
    the_centre_falls_freely::<Q24>(5e-6);
}
