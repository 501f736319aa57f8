//! Wind on sheets with a light border. The part of a particle's velocity that air takes in a substep was once bounded for masses of a quarter and more only: lighter particles
//! were thrown back faster than they came, until numbers overflowed.

use kerchief::{
    AerodynamicWind, Cloth, Force, Gravity, Grid, Lines, Node, PanelWind, Q13, Q24, Scalar, Scene, Solver, Stretch,
    Units, Xpbd, measure,
};

use crate::stage::DOWN;

const SIDE: usize = 4;

/// The largest strain in 4 s of a light sheet that hangs from one corner in a gale. `change` sets its masses.
fn largest_strain<S: Scalar, V: Solver<S> + Copy>(
    solver: V,
    substeps: u32,
    change: impl Fn(&mut Cloth<S, SIDE, SIDE>),
) -> f64 {
    let units = Units::sheet([SIDE; 2], [1.0; 2], 0.01 / 9.0, 0.02, substeps);
    let mut cloth = Cloth::hang(&units, units.point([0.0; 3]));
    change(&mut cloth);
    cloth.pin(Node::new(0, 0));
    let flow = [0.0, 60.0, 0.0];
    let air = AerodynamicWind::new(units.aerodynamic_wind(flow, 1.2, 1.0));
    let panels = PanelWind::new(units.panel_wind(flow, 1.2, 1.0));
    strain_in(&units, air, &solver, cloth).max(strain_in(&units, panels, &solver, cloth))
}

fn strain_in<S: Scalar, F: Force<S>, V: Solver<S> + Copy>(
    units: &Units,
    air: F,
    solver: &V,
    mut cloth: Cloth<S, SIDE, SIDE>,
) -> f64 {
    let forces = (Gravity::new(units.acceleration(DOWN)), air);
    let scene = Scene::new(units, forces, Stretch::new(units, units.stiffness(100.0)), (), *solver);
    let mut memory = scene.memory();
    (0..200).fold(0.0, |strain: f64, _| {
        scene.step(&mut cloth, &mut memory);
        let now = measure::strain(&cloth, &scene.links).largest.to_f64();
        if now.is_nan() { f64::INFINITY } else { strain.max(now) }
    })
}

#[test]
fn wind_does_not_throw_light_particles_back() {
    fn every<S: Scalar>() {
        for hem in [0.05, 0.3] {
            let light = |cloth: &mut Cloth<S, SIDE, SIDE>| {
                cloth.share_area();
                cloth.hem(S::from_f64(hem));
            };
            for substeps in [4, 64] {
                let strain = largest_strain(Lines::new(), substeps, light);
                assert!(strain < 2.0, "{strain} by lines in {}: hem {hem}, {substeps} substeps", S::NAME);
                let strain = largest_strain(Xpbd, substeps, light);
                assert!(strain < 10.0, "{strain} by xpbd in {}: hem {hem}, {substeps} substeps", S::NAME);
            }
        }
        // light particles need not be on the border: all of them, or one inside
        let all = |cloth: &mut Cloth<S, SIDE, SIDE>| cloth.inverse_mass = Grid::filled(S::from_int(40));
        let inside = |cloth: &mut Cloth<S, SIDE, SIDE>| cloth.inverse_mass[Node::new(1, 2)] = S::from_int(40);
        for substeps in [4, 64] {
            let strain = largest_strain(Lines::new(), substeps, all);
            assert!(strain < 2.0, "{strain} by lines in {}: all light, {substeps} substeps", S::NAME);
            let strain = largest_strain(Lines::new(), substeps, inside);
            assert!(strain < 2.0, "{strain} by lines in {}: one light, {substeps} substeps", S::NAME);
        }
    }
    every::<f32>();
    every::<f64>();
    every::<Q24>();
    every::<Q13>();
}
