//! An outsider's collider: a bowl, the inside of a sphere.

use kerchief::collider::{Contact, Stationary};
use kerchief::{Cloth, Collider, Gravity, Moment, Q24, Scalar, Scene, Units, Vec3, Xpbd, measure};

struct Bowl<S> {
    /// The radius around the origin, cells.
    radius: S,
}

impl<S> Stationary for Bowl<S> {}

impl<S: Scalar> Collider<S> for Bowl<S> {
    fn contact(&self, _moment: Moment, position: Vec3<S>, _moved: Vec3<S>) -> Option<Contact<S>> {
        let squared = position.squared();
        (squared > self.radius.product(self.radius)).then(|| {
            let distance = S::root(squared);
            Contact::smooth(-position.map(|component| component.divide(distance)), distance - self.radius)
        })
    }
}

/// The lowest coordinate of falling particles without links, and their largest distance from the origin, cells, over 25 frames of 0.02 s.
fn fall<S: Scalar>(bowl: impl Collider<S> + Stationary) -> [f64; 2] {
    let units = Units::sheet([4, 4], [0.3, 0.3], 1e-3, 0.02, 4);
    let mut cloth = Cloth::<S, 4, 4>::lay(&units, units.point([0.1, -0.2, 0.0]));
    let gravity = Gravity::new(units.acceleration([0.0, 0.0, -9.81]));
    let scene = Scene::new(&units, gravity, (), bowl, Xpbd);
    let (mut lowest, mut farthest): (f64, f64) = (0.0, 0.0);
    for _ in 0..25 {
        scene.step(&mut cloth, &mut scene.memory());
        lowest = lowest.min(measure::bounds(&cloth)[0].z.to_f64());
        let distances = cloth.position.values().map(|x| x.length().to_f64());
        farthest = distances.fold(farthest, f64::max);
    }
    [lowest, farthest]
}

fn particles_stay_in_the_bowl<S: Scalar>() {
    let [lowest, farthest] = fall(Bowl::<S> { radius: S::from_int(6) });
    assert!(farthest < 6.0 + 1e-5, "{farthest} cells from the centre in {}", S::NAME);
    assert!(lowest < -5.5, "no particle came to the bottom in {}: {lowest}", S::NAME);
    let [lowest, _] = fall::<S>(());
    assert!(lowest < -11.0, "without a bowl they fall on in {}: {lowest}", S::NAME);
}

#[test]
fn a_collider_of_ones_own_holds_what_falls() {
    particles_stay_in_the_bowl::<f32>();
    particles_stay_in_the_bowl::<f64>();
    particles_stay_in_the_bowl::<Q24>();
}
