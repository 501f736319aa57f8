use kerchief::*;
fn run<S: Scalar, V: Solver<S>>(name: &str, solver: V, substeps: u32, k: f64, frames: u32) {
    let u = Units::sheet([16, 16], [10.0, 10.0], 1.0, 0.1, substeps);
    let mut cloth = Cloth::<S, 16, 16>::lay(&u, u.point([-5.0, -5.0, 0.0]));
    cloth.pin(Node::new(0, 0));
    cloth.pin(Node::new(15, 0));
    let (st, sh, be) = (Stretch::new(&u, u.stiffness(k)), Shear::new(&u, u.stiffness(9427.)), Bend::new(&u, u.stiffness(942.7)));
    let scene = Scene::new(&u, (Gravity::new(u.acceleration([0., 0., -9.81])), Drag::new(u.verlet_damping(0.1))), (st, sh, be), (), solver);
    let mut m = scene.memory();
    let mut worst = 0.0f64;
    for _ in 0..frames {
        scene.step(&mut cloth, &mut m);
        worst = worst.max(measure::strain(&cloth, &st).largest.to_f64());
    }
    let p = cloth.position[Node::new(8, 15)].to_f64().map(|x| x * u.cell);
    println!("{name:16} {:4} n={substeps:4} strain max {worst:.4} end {:.4} p {:.5?} digest {:08x}", S::NAME, measure::strain(&cloth, &st).largest.to_f64(), p, measure::digest(&cloth));
}
fn main() {
    let k = 94270.0;
    run::<f64, _>("leapfrog", Leapfrog, 512, k, 20);
    run::<f64, _>("leapfrog", Leapfrog, 64, k, 20);
    run::<f32, _>("leapfrog", Leapfrog, 64, k, 20);
    run::<Q24, _>("leapfrog", Leapfrog, 64, k, 20);
    for n in [8, 32, 128] {
        run::<f64, _>("xpbd", Xpbd, n, k, 20);
        run::<f32, _>("xpbd", Xpbd, n, k, 20);
        run::<Q24, _>("xpbd", Xpbd, n, k, 20);
    }
    run::<f64, _>("verlet15", Verlet { sweeps: 15 }, 1, k, 20);
    run::<f64, _>("verlet15", Verlet { sweeps: 15 }, 16, k, 20);
    for n in [1, 8, 32, 128] {
        run::<f64, _>("backward", BackwardEuler { newton_steps: 3 }, n, k, 20);
    }
    run::<f32, _>("backward", BackwardEuler { newton_steps: 3 }, 8, k, 20);
    run::<Q24, _>("backward", BackwardEuler { newton_steps: 3 }, 1, k, 20);
    run::<Q24, _>("backward", BackwardEuler { newton_steps: 3 }, 8, k, 20);
    run::<f64, _>("backward1", BackwardEuler { newton_steps: 1 }, 8, k, 20);
    run::<f64, _>("backward6", BackwardEuler { newton_steps: 6 }, 8, k, 20);
    run::<f64, _>("backward6", BackwardEuler { newton_steps: 6 }, 1, k, 20);
    run::<f64, _>("forward", ForwardEuler, 512, k, 20);
}
