//! The Pareto front: the points for which no other point has less cost and less error.

/// Indices of the points (cost, error) on the Pareto front, by ascending cost. Points with an infinite or undefined coordinate are ignored.
pub fn front(points: &[(f64, f64)]) -> Vec<usize> {
    let mut order: Vec<usize> =
        (0..points.len()).filter(|&i| points[i].0.is_finite() && points[i].1.is_finite()).collect();
    order.sort_by(|&i, &j| points[i].partial_cmp(&points[j]).expect("finite numbers"));
    let mut least = f64::INFINITY;
    order.retain(|&i| {
        let is_less = points[i].1 < least;
        least = least.min(points[i].1);
        is_less
    });
    order
}

/// The cheapest point with an error of at most `error`.
pub fn cheapest(points: &[(f64, f64)], error: f64) -> Option<usize> {
    front(points).into_iter().find(|&i| points[i].1 <= error)
}

/// The most accurate point that costs at most `budget`.
pub fn best_within(points: &[(f64, f64)], budget: f64) -> Option<usize> {
    front(points).into_iter().rfind(|&i| points[i].0 <= budget)
}
