//! The highest angular frequency ω of a flat sheet at rest. Explicit solvers are stable for steps h up to a limit on ω·h.
//!
//! Springs at rest resist only along their own direction, so that the vibrations lie in the sheet's plane. ω² is the largest eigenvalue of M⁻¹·K, with the stiffness
//! matrix K and the masses M. Power iteration finds it (G. Golub, C. Van Loan, *Matrix Computations*, 2013, 7.3).

use kerchief::material::Springs;

/// Offsets (across, down) of the links of a family.
const FAMILIES: [[[i32; 2]; 2]; 3] = [[[1, 0], [0, 1]], [[1, 1], [1, -1]], [[2, 0], [0, 2]]];
/// Products M⁻¹·K·x of the iteration. The estimate approaches ω² from below, and is then less than a percent short of it.
const PRODUCTS: u32 = 150;

/// The frequency (1/s) of a sheet of `side × side` particles whose inverse masses (1/kg) are listed row by row.
pub fn highest(side: usize, inverse_masses: &[f64], springs: &Springs) -> f64 {
    let stiffnesses = [springs.stretch, springs.shear, springs.bend];
    // A start without any symmetry contains all modes.
    let mut way: Vec<[f64; 2]> =
        (0..side * side).map(|k| [1.1, 2.3].map(|pace| libm::sin(pace * k as f64 + 0.4))).collect();
    let mut square = 0.0;
    for _ in 0..PRODUCTS {
        let mut pull = vec![[0.0; 2]; side * side];
        for (family, stiffness) in FAMILIES.iter().zip(stiffnesses) {
            for &step in family {
                add(side, step, stiffness, &way, &mut pull);
            }
        }
        for (pull, inverse) in pull.iter_mut().zip(inverse_masses) {
            *pull = pull.map(|component| component * inverse);
        }
        let length = libm::sqrt(pull.iter().flatten().map(|component| component * component).sum());
        if length == 0.0 {
            return 0.0;
        }
        square = length;
        way = pull.iter().map(|pull| pull.map(|component| component / length)).collect();
    }
    libm::sqrt(square)
}

/// Adds the forces of the springs along `step` for the displacements `way`.
fn add(side: usize, [across, down]: [i32; 2], stiffness: f64, way: &[[f64; 2]], pull: &mut [[f64; 2]]) {
    let length = libm::sqrt(f64::from(across * across + down * down));
    let along = [f64::from(across) / length, f64::from(down) / length];
    let within = |place: i32| (0..side as i32).contains(&place);
    for row in 0..side as i32 {
        for column in 0..side as i32 {
            if !(within(column + across) && within(row + down)) {
                continue;
            }
            let index = |column: i32, row: i32| row as usize * side + column as usize;
            let (a, b) = (index(column, row), index(column + across, row + down));
            let longer = along[0] * (way[b][0] - way[a][0]) + along[1] * (way[b][1] - way[a][1]);
            for axis in 0..2 {
                pull[a][axis] -= stiffness * longer * along[axis];
                pull[b][axis] += stiffness * longer * along[axis];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const STRETCH: Springs = Springs { stretch: 30.0, shear: 0.0, bend: 0.0 };

    /// Without shear springs rows and columns vibrate independently. A free chain of N particles has ω² = 4·k/m·cos²(π/2N).
    #[test]
    fn a_sheet_of_equal_masses_has_the_frequency_of_its_rows() {
        let side = 9;
        let found = highest(side, &[1.0 / 2e-3; 81], &STRETCH);
        let expected = 2.0 * (30.0_f64 / 2e-3).sqrt() * (core::f64::consts::PI / 18.0).cos();
        assert!((found / expected - 1.0).abs() < 0.01, "{found} {expected}");
    }

    #[test]
    fn a_held_sheet_has_none() {
        assert_eq!(highest(4, &[0.0; 16], &STRETCH), 0.0);
    }

    #[test]
    fn stiffer_springs_and_lighter_particles_have_a_higher_one() {
        let usual = highest(8, &[500.0; 64], &STRETCH);
        assert!((highest(8, &[2000.0; 64], &STRETCH) / usual - 2.0).abs() < 1e-9);
        let sheared = highest(8, &[500.0; 64], &Springs { shear: 10.0, ..STRETCH });
        assert!(sheared > 1.1 * usual, "{sheared} {usual}");
    }
}
