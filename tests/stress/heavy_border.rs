//! Sheets with heavy borders, in steps in which they fall by cells. The multipliers of their links, in displacements of a particle of mass 1, once exceeded the range of
//! fixed point: they wrapped and threw the sheet out of the range of positions.

use kerchief::{Lines, Q13, Q24, Scalar};

use crate::stage::{CLOTH, Sheet, Stage};

/// The largest strain in 40 s by the line solver, of a sheet whose border particles are `border` times as heavy as its inner ones.
fn largest_strain<S: Scalar>(border: f64) -> f64 {
    let sheet = Sheet { mass: 0.2 / 64.0, frame: 0.2, substeps: 1, drag: 0.1, ..CLOTH };
    let mut stage = Stage::<S, Lines, 8, 8>::new(&sheet, Lines::new());
    stage.cloth.hem(S::from_f64(border));
    stage.place(|stage, node| {
        let (place, by) = (stage.at(node), stage.random_vector(0.05 / 7.0));
        core::array::from_fn(|axis| place[axis] + by[axis])
    });
    (0..200).fold(0.0, |strain: f64, _| {
        stage.step();
        strain.max(stage.strain())
    })
}

#[test]
fn heavy_borders_are_held_by_fixed_point_as_by_floats() {
    for border in [10.0, 40.0, 80.0] {
        let exact = largest_strain::<f64>(border);
        for (name, strain) in [("q24", largest_strain::<Q24>(border)), ("q13", largest_strain::<Q13>(border))] {
            assert!(strain < 2.0 * exact, "a strain of {strain} in {name}, {exact} in f64, border {border}");
        }
    }
}
