//! The classical Runge-Kutta method (Kutta 1901), with steps that are halved until the solution converges.

use super::vector::{Vector, add, dot, scale, sub};
use super::{Ode, State};

/// RK4 is stable for every decaying or oscillating motion exp(s·t) as long as |s|·h is below this: the radius of a
/// half disc within its stability region.
const STABLE_RADIUS: f64 = 2.6;

/// The number of times that `solve` halves its first step before it gives up.
const MOST_HALVINGS: u32 = 6;

/// The first solution has at least this number of steps in total, even if nothing vibrates.
const FEWEST_STEPS: f64 = 64.0;

/// States at the requested times.
#[derive(Clone, Debug)]
pub struct Solution {
    pub times: Vec<f64>,
    pub states: Vec<State>,
    /// Largest RMS distance, over all times, from the solution with twice the step, divided by the sheet's size. In the
    /// limit, a method of order 4 is 15 times closer than this to the exact solution.
    pub difference: f64,
    /// Observed order: log2 of the ratio of the last two differences, if there are two.
    pub order: Option<f64>,
    /// Steps taken in total.
    pub steps: usize,
}

impl Solution {
    pub fn last(&self) -> &State {
        self.states.last().expect("a solution has at least one time")
    }

    /// Richardson's estimate of the error, with the observed order limited to 1 … 4. Without an observed order it is the
    /// whole difference.
    pub fn error(&self) -> f64 {
        let order = self.order.unwrap_or(1.0).clamp(1.0, 4.0);
        self.difference / (order.exp2() - 1.0)
    }
}

impl Ode {
    /// The longest step at which RK4 is stable on a taut sheet, s; infinite if nothing vibrates.
    pub fn stable_step(&self) -> f64 {
        let (frequency_squared, rate) = self.fastest();
        // The larger root of |s|² = rate·|s| + ω², which bounds the eigenvalues s of the damped motion.
        STABLE_RADIUS / (rate / 2.0 + (rate * rate / 4.0 + frequency_squared).sqrt())
    }

    /// Takes `steps` steps of `h` seconds.
    pub fn rk4(&self, state: &mut State, h: f64, steps: usize) {
        // Weight of a stage's slope in the step, and the part of the step at which the next stage is evaluated.
        const STAGES: [(f64, f64); 4] = [(1.0 / 6.0, 0.5), (1.0 / 3.0, 0.5), (1.0 / 3.0, 1.0), (1.0 / 6.0, 0.0)];
        let mut begin = state.clone();
        let mut stage = state.clone();
        let mut acceleration = vec![[0.0; 3]; state.position.len()];
        for _ in 0..steps {
            begin.clone_from(state);
            stage.clone_from(state);
            for (weight, next) in STAGES {
                self.acceleration(&stage, &mut acceleration);
                for (i, &a) in acceleration.iter().enumerate() {
                    let v = stage.velocity[i];
                    state.position[i] = add(state.position[i], scale(weight * h, v));
                    state.velocity[i] = add(state.velocity[i], scale(weight * h, a));
                    stage.position[i] = add(begin.position[i], scale(next * h, v));
                    stage.velocity[i] = add(begin.velocity[i], scale(next * h, a));
                }
            }
        }
    }

    /// The solution at ascending `times` (s, from 0 on). The step is halved until two solutions differ by at most
    /// `tolerance` (RMS distance over the sheet's size, at every time). The finer one is returned.
    ///
    /// # Panics
    /// If two solutions still disagree at 64 times the steps that stability needs. Then `tolerance` is below
    /// round-off, or the motion is chaotic: an undamped sheet's motion is, soon after its first swing.
    pub fn solve(&self, start: &State, times: &[f64], tolerance: f64) -> Solution {
        assert!(times.first().is_some_and(|&t| t >= 0.0) && times.is_sorted(), "times ascend from 0: {times:?}");
        let first = self.stable_step().min(times[times.len() - 1] / FEWEST_STEPS);
        let (mut states, _) = self.record(start, times, first, 1);
        let mut before = f64::NAN;
        for halving in 1..=MOST_HALVINGS {
            let (finer, steps) = self.record(start, times, first, 1 << halving);
            let distances = states.iter().zip(&finer).map(|(a, b)| rms_distance(&a.position, &b.position));
            // A coarse solution may have blown up: `f64::max` would ignore its undefined distance.
            let difference = distances.fold(0.0, |m, d| if d > m || d.is_nan() { d } else { m }) / self.size;
            if difference <= tolerance {
                let order = before.is_finite().then(|| (before / difference).log2());
                return Solution { times: times.to_vec(), states: finer, difference, order, steps };
            }
            before = difference;
            states = finer;
        }
        panic!(
            "the reference did not converge: after {MOST_HALVINGS} halvings of a step of {first:.3e} s two solutions are \
             still {before:.1e} of the sheet's size apart, {tolerance:.1e} was asked for"
        );
    }

    /// The states at `times` and the number of steps. Every step is at most `longest / divisor`.
    fn record(&self, start: &State, times: &[f64], longest: f64, divisor: usize) -> (Vec<State>, usize) {
        let (mut state, mut now, mut total) = (start.clone(), 0.0, 0);
        let mut states = Vec::with_capacity(times.len());
        for &time in times {
            if time > now {
                // The number of steps to each time is rounded up before it is multiplied by `divisor`, so that every halving is exact.
                let steps = ((time - now) / longest).ceil() as usize * divisor;
                self.rk4(&mut state, (time - now) / steps as f64, steps);
                now = time;
                total += steps;
            }
            states.push(state.clone());
        }
        (states, total)
    }
}

/// RMS distance between particles of the same index, m.
pub fn rms_distance(a: &[Vector], b: &[Vector]) -> f64 {
    assert_eq!(a.len(), b.len(), "two states of the same sheet");
    let squared = |(&a, &b): (&Vector, &Vector)| dot(sub(a, b), sub(a, b));
    (a.iter().zip(b).map(squared).sum::<f64>() / a.len() as f64).sqrt()
}
