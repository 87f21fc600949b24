//! Normals: vectors with one square root, and their directions.

use super::super::point::{Point, combination, cross, difference};
use super::super::root::Root;
use crate::exact::{Real, RealCyclotomic, Scalar};
use crate::float::nearest;

/// A normal p + q√d of a limit surface, of any length but 0. It points to the side from which the
/// faces are counter-clockwise.
#[derive(Clone, Debug, PartialEq)]
pub struct Normal {
    plain: Point<RealCyclotomic>,
    rooted: Option<(Point<RealCyclotomic>, RealCyclotomic)>,
}

impl Normal {
    /// t₀ × t₁; `None` where that is 0.
    pub(super) fn of([first, second]: &[Point<RealCyclotomic>; 2]) -> Option<Normal> {
        Normal { plain: cross(first, second), rooted: None }.unless_zero()
    }

    /// t₀ × t₁ with t_i = p_i + q_i√d:
    /// p₀ × p₁ + d q₀ × q₁ + (p₀ × q₁ − p₁ × q₀)√d.
    pub(super) fn with_root(
        [p0, p1]: &[Point<RealCyclotomic>; 2],
        [q0, q1]: &[Point<RealCyclotomic>; 2],
        radicand: RealCyclotomic,
    ) -> Option<Normal> {
        let one = RealCyclotomic::from(1);
        let plain = combination([(&one, &cross(p0, p1)), (&radicand, &cross(q0, q1))]);
        let rooted = difference(&cross(p0, q1), &cross(p1, q0));
        Normal { plain, rooted: Some((rooted, radicand)) }.unless_zero()
    }

    /// p.
    #[must_use]
    pub fn plain(&self) -> &Point<RealCyclotomic> {
        &self.plain
    }

    /// q and d, if there is a root.
    #[must_use]
    pub fn rooted(&self) -> Option<(&Point<RealCyclotomic>, &RealCyclotomic)> {
        self.rooted.as_ref().map(|(q, d)| (q, d))
    }

    /// The coordinates as formulas, such as `1/2 + (3/4)*sqrt(17/4)`.
    #[must_use]
    pub fn exact(&self) -> [String; 3] {
        [0, 1, 2].map(|i| {
            let plain = self.plain[i].to_string();
            match &self.rooted {
                Some((q, d)) if q[i].sign() != 0 => format!("{plain} + ({})*sqrt({d})", q[i]),
                _ => plain,
            }
        })
    }

    /// The unit vector of this direction: the nearest f64 of each coordinate.
    #[must_use]
    pub fn unit(&self) -> [f64; 3] {
        let squares = [0, 1, 2].map(|i| self.square(i));
        let zero = RealCyclotomic::zero();
        let d = self.rooted.as_ref().map_or(&zero, |(_, d)| d);
        let total =
            squares[1..].iter().fold(squares[0].clone(), |[a, b], [c, e]| [a.plus(c), b.plus(e)]);
        // (A + B√d)(A − B√d). It is 0 only if p − q√d is the zero vector, and then this is 2p.
        let [a, b] = &total;
        let norm = a.times(a).minus(&b.times(b).times(d));
        if norm.sign() == 0 {
            return Normal { plain: self.plain.clone(), rooted: None }.unit();
        }
        [0, 1, 2].map(|i| {
            let sign = self.sign(i);
            if sign == 0 {
                return 0.0;
            }
            let [x, y] = &squares[i];
            let plain = x.times(a).minus(&y.times(b).times(d)).over(&norm);
            let rooted = y.times(a).minus(&x.times(b)).over(&norm);
            let root = nearest(&Root { plain, rooted, radicand: d.clone() });
            if sign < 0 { -root } else { root }
        })
    }

    /// (p + q√d)² = p² + q²d + 2pq√d of a coordinate.
    fn square(&self, i: usize) -> [RealCyclotomic; 2] {
        let p = &self.plain[i];
        let square = p.times(p);
        match &self.rooted {
            None => [square, RealCyclotomic::zero()],
            Some((q, d)) => {
                let product = p.times(&q[i]);
                [square.plus(&q[i].times(&q[i]).times(d)), product.plus(&product)]
            }
        }
    }

    /// The sign of a coordinate p + q√d: that of p and q if they do not differ in sign; otherwise
    /// that of p if p² > q²d, and that of q if p² < q²d.
    fn sign(&self, i: usize) -> i8 {
        let p = &self.plain[i];
        let Some((q, d)) = &self.rooted else { return p.sign() };
        match (p.sign(), q[i].sign()) {
            (p, 0) => p,
            (0, q) => q,
            (p, q) if p == q => p,
            (sign, _) => sign * p.times(p).minus(&q[i].times(&q[i]).times(d)).sign(),
        }
    }

    fn unless_zero(self) -> Option<Normal> {
        (0..3).any(|i| self.sign(i) != 0).then_some(self)
    }
}
