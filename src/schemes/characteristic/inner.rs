//! Eigenvectors on the inner ring: the points that have rules of their own.

use super::ball::Ball;
use super::family::Family;
use crate::exact::{Rational, RealCyclotomic, Scalar as _};
use crate::scheme::LocalRules;

/// The inner ring of rules that are their own mirror image, with its weights enclosed.
pub(super) struct Inner<'r> {
    family: Family,
    ring: &'r LocalRules,
    order: usize,
}

/// An integer.
fn whole(x: i64) -> Ball {
    Ball::from_rational(&Rational::from(x))
}

impl<'r> Inner<'r> {
    pub(super) fn new(family: Family, ring: &'r LocalRules, order: usize) -> Inner<'r> {
        Inner { family, ring, order }
    }

    /// cos(2πj/n).
    pub(super) fn cosine(&self, j: usize) -> Ball {
        let turn = Rational::new(j % self.order, self.order);
        Ball::of(&RealCyclotomic::cosine(&turn).expect("no more points than a ring may have"))
    }

    /// The first point of an orbit.
    fn first(&self, orbit: usize) -> usize {
        self.ring.orbits()[..orbit].iter().map(|orbit| orbit.count).sum()
    }

    /// Σ_d m_{(a,0),(b,d)}·factor(d), the weights of the first point of an orbit at the points of another.
    fn sum(&self, a: usize, b: usize, factor: impl Fn(usize) -> Ball) -> Ball {
        let (row, from) = (self.first(a), self.first(b));
        let weight = |d: usize| self.ring.weights().entry(row, from + d);
        let terms = (0..self.ring.orbits()[b].count).filter(|d| weight(*d).sign() != 0);
        terms.fold(Ball::zero(), |sum, d| sum.plus(&Ball::of(weight(d)).times(&factor(d))))
    }

    /// The eigenvector of block k, 0 < k < n/2, for its eigenvalue: the values at the vertex, at edge point 0, and at
    /// face point 0 divided by 1 + ω^k. The last is real, as the rules are their own mirror image. `None` where enclosures
    /// do not show which of its equations are independent.
    pub(super) fn turning(&self, k: usize, value: &Ball) -> Option<[Ball; 3]> {
        if self.family != Family::Bicubic {
            return Some([Ball::zero(), whole(1), whole(1)]);
        }
        let n = self.order;
        let at = |d: usize| self.cosine(k * d);
        // λE = aE + bF and λF = gE + hF, with (1 + ω^k)ω^{kd} and its inverse as sums of cosines.
        let a = self.sum(1, 1, at);
        let b = self.sum(1, 2, |d| at(d).plus(&at(d + 1)));
        let h = self.sum(2, 2, at);
        // Times 2(1 + c_k).
        let g = self.sum(2, 1, |d| at(d).plus(&at(d + n - 1)));
        let twice = whole(2).plus(&at(1).times(&whole(2)));
        let far = value.minus(&h);
        let [edge, face] = if b.is_apart() {
            [b, value.minus(&a)]
        } else if far.is_apart() {
            [far.times(&twice), g]
        } else {
            return None;
        };
        Some([Ball::zero(), edge, face])
    }

    /// The eigenvector of block 0 for a simple eigenvalue, in the same form with ω = 1; `None` without a vertex,
    /// or where enclosures do not show which rows are independent.
    pub(super) fn still(&self, value: &Ball) -> Option<[Ball; 3]> {
        let orbits = match self.family {
            Family::Bicubic => 3,
            Family::BoxSpline => 2,
            Family::Biquadratic => return None,
        };
        let one = |_| whole(1);
        let row = |a: usize| -> Vec<Ball> {
            let entry = |b: usize| {
                let sum = self.sum(a, b, one);
                if a == b { sum.minus(value) } else { sum }
            };
            (0..orbits).map(entry).collect()
        };
        let rows: Vec<Vec<Ball>> = (0..orbits).map(row).collect();
        let minor = |x: &[Ball], y: &[Ball], i: usize, j: usize| {
            x[i].times(&y[j]).minus(&x[j].times(&y[i]))
        };
        let found = if orbits == 2 {
            let vectors = rows.iter().map(|row| vec![row[1].clone(), Ball::zero().minus(&row[0])]);
            vectors.collect::<Vec<_>>()
        } else {
            let pairs = [(0, 1), (0, 2), (1, 2)];
            let cross = |(i, j): (usize, usize)| {
                let (x, y) = (&rows[i], &rows[j]);
                vec![minor(x, y, 1, 2), minor(x, y, 2, 0), minor(x, y, 0, 1)]
            };
            pairs.into_iter().map(cross).collect()
        };
        let vector = found.into_iter().find(|vector| vector.iter().any(Ball::is_apart))?;
        let half = Ball::from_rational(&Rational::new(1, 2));
        let face = vector.get(2).map_or_else(Ball::zero, |face| face.times(&half));
        Some([vector[0].clone(), vector[1].clone(), face])
    }

    /// The eigenvector of block 0 at a vertex for an eigenvalue, by the rules of the other points alone: it is one if the number
    /// is an eigenvalue.
    pub(super) fn still_by_edges(&self, value: &Ball) -> [Ball; 3] {
        let one = |_| whole(1);
        let sum = |a: usize, b: usize| self.sum(a, b, one);
        let edge = sum(1, 1).minus(value);
        if self.family != Family::Bicubic {
            return [Ball::zero().minus(&edge), sum(1, 0), Ball::zero()];
        }
        let face = sum(2, 2).minus(value);
        let minor = |a: &Ball, b: &Ball, c: &Ball, d: &Ball| a.times(d).minus(&b.times(c));
        let half = Ball::from_rational(&Rational::new(1, 2));
        [
            minor(&edge, &sum(1, 2), &sum(2, 1), &face),
            minor(&sum(1, 2), &sum(1, 0), &face, &sum(2, 0)),
            minor(&sum(1, 0), &edge, &sum(2, 0), &sum(2, 1)).times(&half),
        ]
    }
}
