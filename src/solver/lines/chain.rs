//! A row or a column of links, solved exactly.
//!
//! With unit normals n, inverse masses w and a strength κ = a/b, the linearised constraints `|d| − L = λ/κ` of a chain form a tridiagonal system. In
//! multipliers μ = λ/a, which fit any number type,
//!
//! `(a·(w_i + w_{i+1}) + b)·μ_i − a·w_i·(n_{i−1}·n_i)·μ_{i−1} − a·w_{i+1}·(n_i·n_{i+1})·μ_{i+1} = |d_i| − L`.
//!
//! One pass down and one up solve it (L. Thomas, 1949), where Gauss–Seidel carries news one link a sweep. With equal masses and one end free the pivots stay
//! between a·w and 2·a·w + b.

use crate::cloth::Cloth;
use crate::grid::Node;
use crate::link::Quotient;
use crate::moment::Moment;
use crate::scalar::{Rest, Scalar};
use crate::vec3::Vec3;

use super::displace;

/// Links of one kind.
pub(super) struct Chain<'a, S> {
    pub(super) rest: &'a Rest<S>,
    pub(super) strength: Quotient<S>,
    pub(super) moment: Moment,
}

impl<S: Scalar> Chain<'_, S> {
    /// Lets a chain act with the part `warm` of its last multipliers.
    #[inline]
    pub(super) fn pull<const N: usize, const W: usize, const H: usize>(
        &self,
        cloth: &mut Cloth<S, W, H>,
        node: impl Fn(usize) -> Node,
        tension: &mut [S; N],
        warm: S,
    ) {
        let mut pull_before = Vec3::ZERO;
        let mut x = cloth.position.at(node(0));
        for k in 0..N {
            let mut pull = Vec3::ZERO;
            if k + 1 < N {
                let next = cloth.position.at(node(k + 1));
                let d = next - x;
                tension[k] = tension[k] * warm;
                let (_, inverse) = S::gauge(d.squared(), self.rest);
                pull = d * (inverse * tension[k] * self.strength.dividend);
                x = next;
            }
            let w = cloth.inverse_mass[node(k)];
            displace(cloth, node(k), (pull - pull_before) * w, self.moment);
            pull_before = pull;
        }
    }

    /// Solves a chain of `N` particles and moves them. `tension` holds the multipliers, at the first particle of each link. Returns the largest
    /// difference between a link's length and rest length that it met.
    #[inline]
    pub(super) fn solve<const N: usize, const W: usize, const H: usize>(
        &self,
        cloth: &mut Cloth<S, W, H>,
        node: impl Fn(usize) -> Node,
        tension: &mut [S; N],
    ) -> S {
        let Quotient { dividend, divisor } = self.strength;
        let mut normals = [Vec3::<S>::ZERO; N];
        // the change of a multiplier is `right + ahead · (change of the next)`
        let mut ahead = [S::ZERO; N];
        let mut right = [S::ZERO; N];
        let mut worst = S::ZERO;
        let mut normal_before = Vec3::ZERO;
        let (mut pivot_before, mut right_before) = (S::ZERO, S::ZERO);
        let (mut xa, mut wa) = (cloth.position.at(node(0)), cloth.inverse_mass[node(0)] * dividend);
        for k in 0..N - 1 {
            let b = node(k + 1);
            let (xb, wb) = (cloth.position.at(b), cloth.inverse_mass[b] * dividend);
            let d = xb - xa;
            let (excess, inverse) = S::gauge(d.squared(), self.rest);
            let residual = excess - divisor * tension[k];
            worst = worst.max(residual.abs());
            let normal = d * inverse;
            let coupling = wa * normal_before.dot(normal);
            let factor = coupling * pivot_before;
            let pivot = (wa + wb + divisor - coupling * factor).recip();
            right_before = (residual + coupling * right_before) * pivot;
            if k > 0 {
                ahead[k - 1] = factor;
            }
            normals[k] = normal;
            right[k] = right_before;
            (normal_before, pivot_before, xa, wa) = (normal, pivot, xb, wb);
        }
        let mut change = S::ZERO;
        let mut pull_after = Vec3::ZERO;
        for k in (0..N - 1).rev() {
            change = right[k] + ahead[k] * change;
            tension[k] += change;
            let pull = normals[k] * (change * dividend);
            let b = node(k + 1);
            let w = cloth.inverse_mass[b];
            displace(cloth, b, (pull_after - pull) * w, self.moment);
            pull_after = pull;
        }
        let a = node(0);
        let w = cloth.inverse_mass[a];
        displace(cloth, a, pull_after * w, self.moment);
        worst
    }
}
