//! Control points around a vertex or on a face, by sectors.

use crate::exact::{Rational, Scalar};
use std::collections::BTreeMap;

/// Where the control points of a sector stand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Lattice {
    /// Quadrilaterals at a vertex: (a, b), a ≥ 1, b ≥ 0, and the vertex (0, 0).
    Primal,
    /// Quadrilaterals around a face, whose corner in this sector is (0, 0): a, b ≥ 0.
    Dual,
    /// Triangles at a vertex: as for quadrilaterals, with the diagonals from (1, 0) to (0, 1).
    Triangle,
}

/// A point p + qω as (p, q).
pub(super) type Point<R> = [R; 2];

/// Points x with x = ω^s·(p + qω) at a place of sector s, ω² = 2cω − 1.
#[derive(Clone, Debug)]
pub(super) struct Net<R> {
    pub(super) lattice: Lattice,
    pub(super) cosine: R,
    pub(super) points: BTreeMap<(i32, i32), Point<R>>,
    /// Where the ring between two levels begins, which ends at twice this distance: at 1, and at 2 where the points next to the vertex
    /// have rules of their own. From there on, new points have the rules of the regular part.
    pub(super) start: i32,
}

/// p/q.
pub(super) fn ratio<R: Scalar>(p: i64, q: i64) -> R {
    R::from_rational(&Rational::new(p, q))
}

impl<R: Scalar> Net<R> {
    /// The point at any place, as seen from sector 0.
    pub(super) fn at(&self, place: (i32, i32)) -> Point<R> {
        let ((mut a, mut b), mut turns) = (place, 0);
        loop {
            let here = match self.lattice {
                Lattice::Dual => a >= 0 && b >= 0,
                _ => (a >= 1 && b >= 0) || (a, b) == (0, 0),
            };
            if here {
                break;
            }
            let back = b < 0;
            (a, b) = match (self.lattice, back) {
                (Lattice::Primal, true) => (-b, a),
                (Lattice::Primal, false) => (b, -a),
                (Lattice::Dual, true) => (-1 - b, a),
                (Lattice::Dual, false) => (b, -1 - a),
                (Lattice::Triangle, true) => (-b, a + b),
                (Lattice::Triangle, false) => (a + b, -a),
            };
            turns += if back { -1 } else { 1 };
        }
        let mut point = self.points[&(a, b)].clone();
        for _ in 0..i32::abs(turns) {
            point = if turns > 0 { self.turned(&point) } else { self.turned_back(&point) };
        }
        point
    }

    /// ω(p + qω).
    fn turned(&self, [p, q]: &Point<R>) -> Point<R> {
        let twice = self.cosine.plus(&self.cosine);
        [R::zero().minus(q), p.plus(&twice.times(q))]
    }

    /// (p + qω)/ω.
    fn turned_back(&self, [p, q]: &Point<R>) -> Point<R> {
        let twice = self.cosine.plus(&self.cosine);
        [twice.times(p).plus(q), R::zero().minus(p)]
    }

    /// The points of the level on whose lattice the ring is: those of the next one, or of the second where the ring begins at
    /// 2.
    pub(super) fn refined(&self, eigenvalue: &R) -> Net<R> {
        let far = if self.lattice == Lattice::Dual { 2 } else { 3 };
        let next = self.next(eigenvalue, far);
        if self.start == 1 { next } else { next.next(eigenvalue, 2 * far - 1) }
    }

    /// The points of the next level up to so many faces far, by the rules of the regular part; λ times the old ones at the vertex,
    /// on the face, and where points have rules of their own.
    fn next(&self, eigenvalue: &R, far: i32) -> Net<R> {
        let own: &[(i32, i32)] = match (self.start, self.lattice) {
            (1, _) => &[(0, 0)],
            (_, Lattice::Primal) => &[(0, 0), (1, 0), (1, 1)],
            _ => &[(0, 0), (1, 0)],
        };
        let mut points = BTreeMap::new();
        for a in 0..=far {
            for b in 0..=far {
                let place = (a, b);
                if own.contains(&place) {
                    let old = &self.points[&place];
                    points.insert(place, old.each_ref().map(|x| x.times(eigenvalue)));
                } else if (a > 0 || self.lattice == Lattice::Dual)
                    && (self.lattice != Lattice::Triangle || a + b <= far)
                {
                    points.insert(place, self.by_rule(place));
                }
            }
        }
        Net { lattice: self.lattice, cosine: self.cosine.clone(), points, start: self.start }
    }

    /// The new point at a place, by the rule of the regular part.
    pub(super) fn by_rule(&self, (a, b): (i32, i32)) -> Point<R> {
        let terms: Vec<((i32, i32), i64)> = match self.lattice {
            Lattice::Triangle => triangle_rule(a, b),
            lattice => {
                let line = |x| if lattice == Lattice::Dual { dual_rule(x) } else { primal_rule(x) };
                let both =
                    |(x, u): (i32, i64)| line(b).into_iter().map(move |(y, v)| ((x, y), u * v));
                line(a).into_iter().flat_map(both).collect()
            }
        };
        let whole = terms.iter().map(|(_, weight)| weight).sum();
        let mut sum = [R::zero(), R::zero()];
        for (place, weight) in terms {
            let weight = ratio::<R>(weight, whole);
            let old = self.at(place);
            for (sum, x) in sum.iter_mut().zip(&old) {
                sum.accumulate(&x.times(&weight));
            }
        }
        sum
    }
}

/// Cubic B-splines.
fn primal_rule(x: i32) -> Vec<(i32, i64)> {
    let half = x.div_euclid(2);
    if x.rem_euclid(2) == 0 {
        vec![(half - 1, 1), (half, 6), (half + 1, 1)]
    } else {
        vec![(half, 1), (half + 1, 1)]
    }
}

/// Quadratic B-splines.
fn dual_rule(x: i32) -> Vec<(i32, i64)> {
    let half = x.div_euclid(2);
    let other = if x.rem_euclid(2) == 0 { half - 1 } else { half + 1 };
    vec![(half, 3), (other, 1)]
}

/// The quartic box spline of three directions.
fn triangle_rule(a: i32, b: i32) -> Vec<((i32, i32), i64)> {
    let (x, y) = (a.div_euclid(2), b.div_euclid(2));
    let (near, far) = match (a.rem_euclid(2), b.rem_euclid(2)) {
        (0, 0) => {
            let around = [(1, 0), (0, 1), (-1, 1), (-1, 0), (0, -1), (1, -1)];
            let six = around.iter().map(|(u, v)| ((x + u, y + v), 1));
            return std::iter::once(((x, y), 10)).chain(six).collect();
        }
        (1, 0) => ([(0, 0), (1, 0)], [(0, 1), (1, -1)]),
        (0, _) => ([(0, 0), (0, 1)], [(1, 0), (-1, 1)]),
        _ => ([(1, 0), (0, 1)], [(0, 0), (1, 1)]),
    };
    let weighted = |places: [(i32, i32); 2], weight| places.map(|(u, v)| ((x + u, y + v), weight));
    [weighted(near, 3), weighted(far, 1)].concat()
}
