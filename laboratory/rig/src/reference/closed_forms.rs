//! Cases of the model with an exact or semi-analytical solution.

/// Height of each particle of a chain at rest under its own weight, below its pinned top particle, m: the first
/// is 0, the others negative. A link carries the weight of all particles below it.
///
/// `masses` run from the top down (the pin's own does not matter); `rest` is each link's rest length.
pub fn hanging_chain(masses: &[f64], rest: f64, stiffness: f64, gravity: f64) -> Vec<f64> {
    let mut heights = vec![0.0];
    for link in 1..masses.len() {
        let weight = gravity * masses[link..].iter().sum::<f64>();
        heights.push(heights[link - 1] - (rest + weight / stiffness));
    }
    heights
}

/// A chain at rest between two pins, `span` = (horizontal, upward) from the first to the last: each particle's
/// position relative to the first. With `compliance` = 1/stiffness = 0 it is the discrete catenary of
/// inextensible links.
///
/// Statics: the horizontal component H of the tension is the same in every link, and the vertical component V grows
/// by each weight passed. Both components in the first link determine the shape. They minimise the convex complementary energy
/// `Σ(L·T + T²/2k) - (H, V)·span` (T a link's tension), found by Newton's method.
///
/// # Panics
/// If there is no finite solution: an inextensible chain is too short for the span. And if one pin is above the
/// other: a link without tension would have no defined direction.
pub fn chain_between_pins(masses: &[f64], rest: f64, compliance: f64, gravity: f64, span: [f64; 2]) -> Vec<[f64; 2]> {
    assert!(span[0] > 0.0, "pins one above the other");
    let links = masses.len() - 1;
    let places = |[h, mut v]: [f64; 2]| {
        let mut places = vec![[0.0, 0.0]];
        for link in 0..links {
            let extent = rest / h.hypot(v) + compliance;
            let [x, z] = places[link];
            places.push([x + extent * h, z + extent * v]);
            v += gravity * masses[link + 1];
        }
        places
    };
    let miss = |pull: [f64; 2]| {
        let end = places(pull)[links];
        [end[0] - span[0], end[1] - span[1]]
    };
    let weight = gravity * masses[1..links].iter().sum::<f64>();
    let mut pull = [weight, -weight / 2.0];
    for _ in 0..200 {
        let [x, z] = miss(pull);
        if x.hypot(z) <= 1e-14 * rest * links as f64 {
            return places(pull);
        }
        // Derivative of the end's position: the sum over the links of (L/T + 1/k)·1 - L/T³·(H, V)(H, V)ᵀ.
        let (mut hh, mut hv, mut vv) = (0.0, 0.0, 0.0);
        let [h, mut v] = pull;
        for link in 0..links {
            let tension = h.hypot(v);
            let curve = rest / tension.powi(3);
            hh += curve * v * v + compliance;
            hv -= curve * h * v;
            vv += curve * h * h + compliance;
            v += gravity * masses[link + 1];
        }
        let determinant = hh * vv - hv * hv;
        let step = [(hv * z - vv * x) / determinant, (hv * x - hh * z) / determinant];
        let shortened = |part: f64| [pull[0] + part * step[0], pull[1] + part * step[1]];
        let closer = (0..50).map(|i| shortened(0.5_f64.powi(i))).find(|&p| {
            let [a, b] = miss(p);
            a.hypot(b) < x.hypot(z)
        });
        match closer {
            Some(p) => pull = p,
            // Only round-off is left.
            None if x.hypot(z) < 1e-12 * rest * links as f64 => return places(pull),
            None => break,
        }
    }
    panic!("no rest for a chain of {links} links of {rest} m across {span:?} m");
}

/// Laguerre polynomials `L_0(x)` to `L_n(x)` by their recurrence.
fn laguerre(n: usize, x: f64) -> Vec<f64> {
    let mut values = vec![1.0, 1.0 - x];
    for k in 1..n {
        let next = ((2 * k + 1) as f64 - x) * values[k] - k as f64 * values[k - 1];
        values.push(next / (k + 1) as f64);
    }
    values
}

/// The small swings of `n` equal masses on a massless inextensible thread, a mass after every `link` m of it:
/// their angular frequencies, slowest first, 1/s.
///
/// ω² = x·g/link with x the roots of the Laguerre polynomial `L_n` (the equation of motion of mass k from the
/// bottom is the polynomials' recurrence). As n grows, the slowest goes to 1.2024·√(g/length) of the hanging rope.
pub fn pendulum_frequencies(n: usize, link: f64, gravity: f64) -> Vec<f64> {
    // L_0 … L_n form a Sturm chain: as many roots of L_n lie below x as signs change along it.
    let roots_below = |x: f64| laguerre(n, x).windows(2).filter(|w| (w[0] < 0.0) != (w[1] < 0.0)).count();
    let root = |i: usize| {
        let (mut low, mut high) = (0.0, (4 * n + 2) as f64);
        for _ in 0..100 {
            let middle = f64::midpoint(low, high);
            if roots_below(middle) > i { high = middle } else { low = middle }
        }
        low
    };
    (0..n).map(|i| (root(i) * gravity / link).sqrt()).collect()
}

/// The mode with angular frequency `omega`: sideways displacements from the pivot (0) down to the lowest mass (1).
pub fn pendulum_mode(n: usize, link: f64, gravity: f64, omega: f64) -> Vec<f64> {
    let mut shape = laguerre(n, omega * omega * link / gravity);
    shape.reverse();
    shape
}

/// Squared angular frequency of the longitudinal mode `j` (1 …) of a free straight chain of `n` equal masses, 1/s²:
/// (4k/m)·sin²(jπ/2n). It is exact at any amplitude that doesn't fold the chain.
pub fn lengthwise_frequency_squared(n: usize, j: usize, stiffness: f64, mass: f64) -> f64 {
    4.0 * stiffness / mass * (j as f64 * core::f64::consts::PI / (2 * n) as f64).sin().powi(2)
}

/// Displacement of particle `i` in that mode: cos(jπ(i + ½)/n).
pub fn lengthwise_mode(n: usize, j: usize, i: usize) -> f64 {
    (j as f64 * core::f64::consts::PI * (i as f64 + 0.5) / n as f64).cos()
}

/// q and q' at time `t` for q'' + rate·q' + ω²·q = 0, from q = 1 at rest, in the underdamped case.
pub fn damped_oscillation(omega_squared: f64, rate: f64, t: f64) -> [f64; 2] {
    let decay = rate / 2.0;
    assert!(omega_squared > decay * decay, "overdamped");
    let omega = (omega_squared - decay * decay).sqrt();
    let (sin, cos) = (omega * t).sin_cos();
    let envelope = (-decay * t).exp();
    [envelope * (cos + decay / omega * sin), -envelope * omega_squared / omega * sin]
}

/// Displacement and velocity at time `t` along one axis under a constant acceleration and drag γ, from `velocity`.
pub fn fall_with_drag(acceleration: f64, drag: f64, velocity: f64, t: f64) -> [f64; 2] {
    if drag == 0.0 {
        return [velocity * t + acceleration * t * t / 2.0, velocity + acceleration * t];
    }
    let terminal = terminal_velocity(acceleration, drag);
    let decayed = -(-drag * t).exp_m1();
    [terminal * t + (velocity - terminal) * decayed / drag, velocity + (terminal - velocity) * decayed]
}

/// Terminal velocity of a fall with drag γ: a/γ, m/s.
pub fn terminal_velocity(acceleration: f64, drag: f64) -> f64 {
    acceleration / drag
}

/// Terminal speed of a flat horizontal sheet of `areal_density` (kg/m²) in still air, in the aerodynamic model:
/// √(2·g·σ/(ρ·C)), m/s.
pub fn parachute_velocity(gravity: f64, areal_density: f64, air_density: f64, drag_coefficient: f64) -> f64 {
    (2.0 * gravity * areal_density / (air_density * drag_coefficient)).sqrt()
}

/// Distance and speed at time `t` of a fall from rest under quadratic drag, with terminal speed `terminal`.
pub fn parachute_fall(gravity: f64, terminal: f64, t: f64) -> [f64; 2] {
    let s = gravity * t / terminal;
    [terminal * terminal / gravity * s.cosh().ln(), terminal * s.tanh()]
}
