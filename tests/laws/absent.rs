//! A family without links has no effect: diagonals of a chain.

use kerchief::{Q13, Q24, Scalar};

use rig::reference::{Family, SHEAR};
use rig::scenes::chain;
use rig::{Method, Pace, moved};

/// Whether a chain ends in the same bits after it gets diagonals with a hundred times the stiffness and the damping of its links.
fn is_unchanged<S: Scalar>(method: Method) -> bool {
    let digest = |further: Option<Family>| {
        let mut model = chain();
        model.families[0].damping = 3.0;
        model.families.extend(further);
        let mut motion = moved::<S, 1, 32>(&model, Pace::new(1.0 / 60.0, 4), method);
        motion.run(30);
        motion.digest()
    };
    let stiff = Family::new(SHEAR, 100.0 * chain().families[0].stiffness).damped(300.0);
    digest(None) == digest(Some(stiff))
}

#[test]
fn diagonals_of_a_chain_change_nothing() {
    for method in [
        Method::ForwardEuler,
        Method::BackwardEuler,
        Method::Leapfrog,
        Method::Verlet(4),
        Method::Xpbd,
        Method::Lines(2),
    ] {
        assert!(is_unchanged::<f32>(method), "{method:?} in f32");
        assert!(is_unchanged::<f64>(method), "{method:?} in f64");
        assert!(is_unchanged::<Q24>(method), "{method:?} in q24");
        assert!(is_unchanged::<Q13>(method), "{method:?} in q13");
    }
}
