//! Fast sheets that are as light as the air around them. In fixed point pressure times velocity once overflowed and became negative: the air pushed the sheet on instead of
//! braking it.

use kerchief::{AerodynamicWind, Cloth, Force, PanelWind, Q13, Q24, Scalar, Scene, Units, Vec3, Xpbd};

const SIDE: usize = 4;
const UNITS: Units = Units::sheet([SIDE; 2], [3.0; 2], 1.0, 0.1, 4);

/// The part of `speed` (cells a tick) that a frame in thick air leaves, by the aerodynamic and the panel model.
fn left<S: Scalar>(density: f64, speed: f64) -> [f64; 2] {
    let air = AerodynamicWind::<S>::new(UNITS.aerodynamic_wind([0.0; 3], density, 1.0));
    let panels = PanelWind::<S>::new(UNITS.panel_wind([0.0; 3], density, 1.0));
    [left_by::<S, _>(air, speed), left_by::<S, _>(panels, speed)]
}

fn left_by<S: Scalar, F: Force<S>>(air: F, speed: f64) -> f64 {
    let units = UNITS;
    let mut cloth = Cloth::<S, SIDE, SIDE>::lay(&units, units.point([0.0; 3]));
    cloth.velocity.change(|_| Vec3::from_f64([0.0, 0.0, speed]));
    let scene = Scene::new(&units, air, (), (), Xpbd);
    scene.step(&mut cloth, &mut scene.memory());
    cloth.velocity.values().map(|v| v.to_f64()[2] / speed).fold(0.0, f64::max)
}

#[test]
fn air_never_pushes_on() {
    fn every<S: Scalar>() {
        for density in [50.0, 500.0, 4000.0] {
            for speed in [0.3, 1.0, 3.0, 10.0, 25.0] {
                let exact = left::<f64>(density, speed);
                for (left, exact) in left::<S>(density, speed).into_iter().zip(exact) {
                    assert!((left - exact).abs() < 1e-3, "{left}, {exact} in {}: {density} kg/m³, {speed}", S::NAME);
                    assert!((0.0..1.0).contains(&left), "{left} in {}: {density} kg/m³, {speed}", S::NAME);
                }
            }
        }
    }
    every::<f32>();
    every::<f64>();
    every::<Q24>();
    every::<Q13>();
}
