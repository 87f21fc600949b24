//! The net of an eigenvector, in the coordinates p + qω, ω = e^{2πik/n}.

use super::ball::Ball;
use super::equations::{kernel, solve};
use super::inner::Inner;
use super::lattice::{Part, Place};
use crate::text::{Checked, Reason, Stop};
use std::collections::BTreeMap;

/// p and q.
pub type Point = [Ball; 2];

/// Points of sector 0.
pub struct Net {
    /// The regular part.
    pub part: Part,
    /// cos(2πk/n).
    pub cosine: Ball,
    /// Where the ring between two levels begins: at 1, and at 2 if points next to the vertex have rules of their own.
    pub start: i32,
    points: BTreeMap<Place, Point>,
}

/// ω^turns·(p + qω): ω² = 2cω − 1.
fn turned(cosine: &Ball, [p, q]: &Point, turns: i32) -> Point {
    let twice = cosine.plus(cosine);
    let zero = Ball::from(0);
    let mut point = [p.clone(), q.clone()];
    for _ in 0..turns.unsigned_abs() {
        let [p, q] = &point;
        point = if turns > 0 {
            [zero.minus(q), p.plus(&twice.times(q))]
        } else {
            [twice.times(p).plus(q), zero.minus(p)]
        };
    }
    point
}

impl Net {
    /// The eigenvector of block k for an eigenvalue, which is none of the outer points.
    pub fn of(inner: &Inner, k: usize, value: &Ball) -> Checked<Net> {
        let undecided = || Stop::Undecided("the eigenvector");
        let mut block = inner.block(k)?;
        for (i, row) in block.iter_mut().enumerate() {
            row[i] = row[i].minus(value);
        }
        let mut vector = kernel(&block).ok_or_else(undecided)?;
        let (part, cosine) = (inner.part, inner.cosine(k)?);
        let zero = || Ball::from(0);
        if part != Part::Biquadratic && k > 0 {
            // The vertex.
            vector.insert(0, zero());
        }
        let mut points = BTreeMap::new();
        for (&place, y) in part.inner().iter().zip(vector) {
            let point = if place == (1, 1) {
                // y·e^{iπk/n} = y(1 + ω)/(2cos(πk/n)).
                let half = inner.half_cosine(k)?;
                let share = y.times(&half.plus(&half).inverse().ok_or_else(undecided)?);
                [share.clone(), share]
            } else {
                [y, zero()]
            };
            points.insert(place, point);
        }
        let outer = outer(part, &cosine, value, &points).ok_or_else(undecided)?;
        points.extend(outer);
        Ok(Net { part, cosine, start: if inner.own { 2 } else { 1 }, points })
    }

    /// The point at a place.
    pub fn at(&self, place: Place) -> Checked<Point> {
        let (home, turns) = self.part.turned(place);
        let point = self.points.get(&home).ok_or(Reason::Vertex("a place of the ring"))?;
        Ok(turned(&self.cosine, point, turns))
    }

    /// The points of the next level, up to three places away, or two on a face; of the second level, up to five, where the ring
    /// begins at 2.
    pub fn refined(&self, value: &Ball) -> Checked<Net> {
        if self.start == 1 {
            return self.next(value, if self.part == Part::Biquadratic { 2 } else { 3 });
        }
        self.next(value, 3)?.next(value, 5)
    }

    /// The points of the next level up to a distance.
    fn next(&self, value: &Ball, far: i32) -> Checked<Net> {
        let own = if self.start == 1 { &[(0, 0)][..] } else { self.part.inner() };
        let mut points = BTreeMap::new();
        for place in (0..=far).flat_map(|a| (0..=far).map(move |b| (a, b))) {
            let (home, turns) = self.part.turned(place);
            let beyond = self.part == Part::BoxSpline && place.0 + place.1 > far;
            if turns != 0 || home != place || beyond {
                continue;
            }
            let mut sum = [Ball::from(0), Ball::from(0)];
            if own.contains(&place) {
                sum = self.at(place)?.map(|x| x.times(value));
            } else {
                for (old, weight) in self.part.rule(place) {
                    let (point, weight) = (self.at(old)?, Ball::from(&weight));
                    for (sum, x) in sum.iter_mut().zip(&point) {
                        *sum = sum.plus(&x.times(&weight));
                    }
                }
            }
            points.insert(place, sum);
        }
        Ok(Net { part: self.part, cosine: self.cosine.clone(), start: self.start, points })
    }
}

/// The outer points x of an eigenvector: λx is what the rules of the regular part make of all points.
fn outer(
    part: Part,
    cosine: &Ball,
    value: &Ball,
    inner: &BTreeMap<Place, Point>,
) -> Option<Vec<(Place, Point)>> {
    let places = part.outer();
    let unknowns = 2 * places.len();
    let mut rows = vec![vec![Ball::from(0); unknowns + 1]; unknowns];
    for (i, &place) in places.iter().enumerate() {
        for c in 0..2 {
            rows[2 * i + c][2 * i + c] = value.clone();
        }
        for (old, weight) in part.rule(place) {
            let (weight, (home, turns)) = (Ball::from(&weight), part.turned(old));
            let mut add = |column: usize, point: Point, minus: bool| {
                for (c, x) in point.iter().enumerate() {
                    let (entry, term) = (&mut rows[2 * i + c][column], x.times(&weight));
                    *entry = if minus { entry.minus(&term) } else { entry.plus(&term) };
                }
            };
            if let Some(at) = places.iter().position(|known| *known == home) {
                // The columns of p and of q are ω^turns·1 and ω^turns·ω.
                let units = [[Ball::from(1), Ball::from(0)], [Ball::from(0), Ball::from(1)]];
                for (c, unit) in units.iter().enumerate() {
                    add(2 * at + c, turned(cosine, unit, turns), true);
                }
            } else {
                add(unknowns, turned(cosine, inner.get(&home)?, turns), false);
            }
        }
    }
    let solution = solve(rows)?;
    let points = solution.chunks(2).map(|pair| [pair[0].clone(), pair[1].clone()]);
    Some(places.iter().copied().zip(points).collect())
}
