//! Every substitution that the README and the docs propose compiles without a type annotation beyond the number type, and runs.

use kerchief::{BackwardEuler, ForwardEuler, Leapfrog, Lines, Node, Q13, Q24, Sheet, Stillness, Verlet, Xpbd, measure};

const DOWN: [f64; 3] = [0.0, 0.0, -9.81];
/// A cell of a sheet of 8 × 8 particles and 30 cm, m.
const THICKNESS: f64 = 0.3 / 7.0;

macro_rules! plays {
    ($sheet:ident, $forces:expr, $links:expr, $colliders:expr, $solver:expr) => {{
        let mut cloth = $sheet.hang([0.0, 0.0, 0.3]);
        cloth.pin(Node::new(0, 0));
        cloth.pin(Node::new(7, 0));
        let mut scene = $sheet.scene($forces, $links, $colliders, $solver);
        let mut memory = scene.memory();
        let start = measure::digest(&cloth);
        for _frame in 0..3 {
            scene.play(&mut cloth, &mut memory);
        }
        let what = concat!(
            stringify!($number),
            stringify!($forces),
            stringify!($links),
            stringify!($colliders),
            stringify!($solver)
        );
        assert!(measure::is_finite(&cloth) && measure::digest(&cloth) != start, "{what}");
    }};
}

macro_rules! of_every_number {
    ($($name:ident: $number:ty),+) => {$(
        #[test]
        fn $name() {
            // m, kg of a particle, s, substeps
            const SHEET: Sheet<$number, 8, 8> = Sheet::new([0.3, 0.3], 1e-3, 1.0 / 60.0, 16);
            macro_rules! with_every_solver {
                ($forces:expr, $links:expr, $colliders:expr) => {
                    with_every_solver!($forces, $links, $colliders, ForwardEuler::new(), Leapfrog::new(), Verlet::new());
                    with_every_solver!($forces, $links, $colliders, Xpbd::new(), BackwardEuler::new(), Lines::new());
                };
                ($forces:expr, $links:expr, $colliders:expr, $a:expr, $b:expr, $c:expr) => {
                    plays!(SHEET, $forces, $links, $colliders, $a);
                    plays!(SHEET, $forces, $links, $colliders, $b);
                    plays!(SHEET, $forces, $links, $colliders, $c);
                    plays!(SHEET, $forces, $links, $colliders, SHEET.resting(Stillness::DEFAULT, $a));
                    plays!(SHEET, $forces, $links, $colliders, SHEET.resting(Stillness::DEFAULT, $b));
                    plays!(SHEET, $forces, $links, $colliders, SHEET.resting(Stillness::DEFAULT, $c));
                };
            }
            let gravity = SHEET.gravity(DOWN);
            let links = (SHEET.stretch(100.0), SHEET.shear(1.0));
            let damped = (SHEET.damped(SHEET.stretch(100.0), 0.01), SHEET.shear(1.0), SHEET.bend(0.1));
            let ball = SHEET.ball([0.15, 0.1, 0.0], 0.05, 0.005);
            let pushed = SHEET.moving_ball([0.15, 0.1, 0.0], 0.05, 0.005, [0.0, 0.1, 0.0]);
            let ground = SHEET.plane([0.0, 0.0, -0.2], [0.0, 0.0, 1.0], 0.005);
            with_every_solver!(gravity, links, ());
            plays!(SHEET, gravity, links, ball, SHEET.self_contact(THICKNESS, 0.3, Lines::new()));
            plays!(SHEET, gravity, links, (), SHEET.self_contact(THICKNESS, 0.3, Xpbd::new()));
            with_every_solver!((gravity, SHEET.aerodynamic_wind([3.0, 1.0, 0.0], 1.2, 1.2)), links, ball);
            with_every_solver!((gravity, SHEET.facet_wind([0.3, 0.1, 0.0]), SHEET.drag(0.5)), damped, (pushed, ground));
            with_every_solver!((gravity, SHEET.panel_wind([3.0, 1.0, 0.0], 1.2, 1.2)), links, ball);
            with_every_solver!(gravity, Some(SHEET.stretch(100.0)), SHEET.rod([0.0, 0.1, 0.0], [0.3, 0.1, 0.0], 0.02, 0.005));
        }
    )+};
}

of_every_number!(in_f32: f32, in_f64: f64, in_q24: Q24, in_q13: Q13);
