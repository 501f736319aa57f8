//! Wind on panels against the aerodynamic model: `cargo test --test wind -- --nocapture` prints their differences.

use kerchief::force::{Force, Row};
use kerchief::{AerodynamicWind, Cloth, Node, PanelWind, Q13, Q24, Scalar, Units, Vec3};

use rig::reference::{Model, Pose, Sheet, Wind};
use rig::scenes::{GRAVITY, springs};
use rig::{Pace, Rig};

/// The velocity that each particle of mass 1 gains in a substep, row by row.
fn gains<S: Scalar, F: Force<S>, const W: usize, const H: usize>(wind: &F, cloth: &Cloth<S, W, H>) -> Vec<[f64; 3]> {
    let mut all = [Vec3::row(Vec3::ZERO); H];
    for row in 1..H {
        let [above, below] = [row - 1, row].map(|row| Row {
            index: row,
            position: &cloth.position.0[row],
            velocity: &cloth.velocity.0[row],
            inverse_mass: &cloth.inverse_mass.0[row],
        });
        let (upper, lower) = all.split_at_mut(row);
        wind.cells([above, below], [&mut upper[row - 1], &mut lower[0]]);
    }
    all.iter().flat_map(|row| (0..W).map(|column| row.at(column).to_f64())).collect()
}

fn norm(x: [f64; 3]) -> f64 {
    x.iter().map(|x| x * x).sum::<f64>().sqrt()
}

fn difference(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|k| a[k] - b[k])
}

fn sum(all: &[[f64; 3]]) -> [f64; 3] {
    all.iter().fold([0.0; 3], |sum, x| std::array::from_fn(|k| sum[k] + x[k]))
}

/// Directions spread over the whole sphere.
fn directions() -> impl Iterator<Item = [f64; 3]> {
    (0..400).map(|k| {
        let (z, turn) = (1.0 - (2 * k + 1) as f64 / 400.0, 2.399_963 * f64::from(k));
        let rim = (1.0 - z * z).sqrt();
        [rim * turn.cos(), rim * turn.sin(), z]
    })
}

/// The largest difference between both models' forces on a rigid plate, over the force on a plate across the flow: in all directions, of a plate moving in calm air and one at rest
/// in moving air.
fn plate<S: Scalar>(size: [f64; 2], speed: f64) -> f64 {
    const SIDE: usize = 6;
    let units = Units::sheet([SIDE; 2], size, 0.02, 0.02, 8);
    let plate = |direction: [f64; 3], air: [f64; 3]| {
        // perpendicular to `direction`
        let mut side = if direction[0].abs() < 0.9 { [1.0, 0.0, 0.0] } else { [0.0, 1.0, 0.0] };
        let along: f64 = (0..3).map(|k| side[k] * direction[k]).sum();
        side = std::array::from_fn(|k| side[k] - along * direction[k]);
        let a = side.map(|x| x / norm(side));
        let b = [1, 2, 0].map(|k| {
            let l = (k + 1) % 3;
            direction[k] * a[l] - direction[l] * a[k]
        });
        let mut cloth = Cloth::<S, SIDE, SIDE>::lay(&units, units.point([0.0; 3]));
        for (row, column) in (0..SIDE).flat_map(|row| (0..SIDE).map(move |column| (row, column))) {
            let [across, down] = [column as f64 * units.sides[0], row as f64 * units.sides[1]];
            let place = std::array::from_fn(|k| across * a[k] + down * b[k]);
            cloth.position.set(Node::new(column, row), Vec3::from_f64(place));
        }
        let own = units.velocity(difference(air, [0.0, 0.0, speed])).0;
        cloth.velocity.change(|_| Vec3::from_f64(own.map(|x| -x)));
        cloth
    };
    let wide = |cloth: &Cloth<S, SIDE, SIDE>| {
        let mut same = Cloth::<f64, SIDE, SIDE>::lay(&units, units.point([0.0; 3]));
        let mut values = cloth.position.values();
        same.position.change(|_| values.next().map_or(Vec3::ZERO, |x| Vec3::from_f64(x.to_f64())));
        let mut values = cloth.velocity.values();
        same.velocity.change(|_| values.next().map_or(Vec3::ZERO, |x| Vec3::from_f64(x.to_f64())));
        same
    };
    let (mut largest, mut error) = (0.0_f64, 0.0_f64);
    for air in [[0.0; 3], [0.0, 0.0, speed]] {
        let panels = PanelWind::<S>::new(units.panel_wind(air, 1.2, 1.2));
        let exact = AerodynamicWind::<f64>::new(units.aerodynamic_wind(air, 1.2, 1.2));
        for direction in directions() {
            let cloth = plate(direction, air);
            let (found, expected) = (gains(&panels, &cloth), gains(&exact, &wide(&cloth)));
            error = error.max(norm(difference(sum(&found), sum(&expected))));
            largest = largest.max(norm(sum(&expected)));
            // inside the plate, where six triangles or four panels share a particle, particles are compared one by one
            for (column, row) in [(2, 2), (3, 1), (4, 4)] {
                let k = row * SIDE + column;
                error = error.max(25.0 * norm(difference(found[k], expected[k])));
            }
        }
    }
    error / largest
}

#[test]
fn rigid_plates_are_pressed_as_by_the_aerodynamic_model_at_every_angle() {
    fn every<S: Scalar>(bound: f64) {
        for size in [[1.0, 1.0], [1.0, 0.6], [0.3, 1.0], [0.1, 1.0]] {
            for speed in [0.5, 2.0, 10.0, 40.0] {
                // a force of only a few last places has fewer than two digits
                if size[0] < 0.2 && speed < 1.0 {
                    continue;
                }
                let error = plate::<S>(size, speed);
                println!("{}, {size:?} m, {speed} m/s: {:.2e}", S::NAME, error);
                assert!(error < bound, "{size:?} m, {speed} m/s in {}: {error:e}", S::NAME);
            }
        }
    }
    every::<f32>(1e-5);
    every::<f64>(1e-12);
    every::<Q24>(0.02);
    every::<Q13>(0.02);
}

/// Differences between both models on a flag that is pinned along its left side and moves in the aerodynamic model's wind: root mean square of the forces on particles and of the
/// total force, each over the root mean square of the force itself.
fn flag<S: Scalar>([width, height]: [f64; 2], wind: [f64; 3]) -> [f64; 2] {
    const SIDE: usize = 16;
    let sheet = Sheet::new(Pose::Hang, [SIDE; 2], [width, height]).with_density(0.12).with_left_pinned();
    let model = Model {
        families: springs(2_000.0, 200.0, 2.0),
        gravity: GRAVITY,
        drag: 0.3,
        wind: Some(Wind::Aerodynamic { velocity: wind, density: 1.2, drag_coefficient: 1.2 }),
        ..Model::new(sheet)
    };
    let mut rig = Rig::<S, _, SIDE, SIDE>::new(&model, Pace::new(1.0 / 60.0, 8), kerchief::Lines::default());
    let exact = AerodynamicWind::<S>::new(rig.units.aerodynamic_wind(wind, 1.2, 1.2));
    let panels = PanelWind::<S>::new(rig.units.panel_wind(wind, 1.2, 1.2));
    let (mut errors, mut squares) = ([0.0; 2], [0.0; 2]);
    for frame in 0..300 {
        rig.step();
        // only once the flag flies
        if frame < 60 {
            continue;
        }
        let (found, expected) = (gains(&panels, &rig.cloth), gains(&exact, &rig.cloth));
        let square = |x: [f64; 3]| norm(x) * norm(x);
        for (found, expected) in found.iter().zip(&expected) {
            errors[0] += square(difference(*found, *expected));
            squares[0] += square(*expected);
        }
        errors[1] += square(difference(sum(&found), sum(&expected)));
        squares[1] += square(sum(&expected));
    }
    std::array::from_fn(|k| (errors[k] / squares[k]).sqrt())
}

#[test]
fn flags_in_motion_are_pressed_nearly_as_by_the_aerodynamic_model() {
    fn every<S: Scalar>() {
        for (size, wind, bounds) in [
            ([1.5, 1.0], [5.0, 0.5, 0.0], [0.15, 0.08]),
            ([3.0, 2.0], [8.0, 0.5, 0.0], [0.25, 0.16]),
            ([1.5, 1.0], [2.0, 3.0, 0.0], [0.12, 0.05]),
        ] {
            let [particle, whole] = flag::<S>(size, wind);
            println!("{}, {size:?} m, {wind:?} m/s: {particle:.3} per particle, {whole:.3} in all", S::NAME);
            assert!(particle < bounds[0] && whole < bounds[1], "{size:?} in {}: {particle}, {whole}", S::NAME);
        }
    }
    every::<f64>();
    every::<f32>();
    every::<Q24>();
    every::<Q13>();
}
