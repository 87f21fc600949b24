//! Butterfly rules: eigenfunctions that are no polynomials, enclosed by refined nets.
//!
//! The points of a net are on the surface. A midpoint differs from the mean of the ends of its edge by a sum of
//! differences along parallel edges with weights ±1/16, four of them; and differences of new neighbours are sums of differences along
//! parallel edges, with weights whose absolute values sum to at most 7/8. So on an edge a linear form of the limit differs
//! from the one between its ends by at most Σ (1/4)(7/8)^i = 2 times the greatest difference of neighbours, of those
//! that are at most three edges from the edge.

use super::ball::Ball;
use super::net::{Lattice, Net, Point, ratio};
use crate::exact::{RealCyclotomic, Scalar as _};
use crate::scheme::LocalRules;
use crate::spectrum::surroundings;
use std::collections::BTreeMap;

/// The levels of the net on which the curve is looked at.
const LEVELS: std::ops::RangeInclusive<u32> = 3..=7;

/// How far the points are that have an effect on an edge.
const REACH: i32 = 3;

/// Whether rules are those of the butterfly scheme, on two rings around a vertex of valence n.
pub(super) fn is_butterfly(ring: &LocalRules, n: usize) -> bool {
    let names = ring.orbits().iter().map(|orbit| orbit.name.as_str());
    if !names.eq(["vertex", "edge", "face", "ray"]) {
        return false;
    }
    let Ok(model) = surroundings("butterfly", Some(n)) else { return false };
    let model = model.ring;
    let same = |a: usize| ring.weights().row(a).eq(model.weights().row(a));
    ring.point_count() == model.point_count() && (0..ring.point_count()).all(same)
}

/// The net of the eigenvector of block k for λ > 1/8, c = cos(2πk/n), on three rings; the vertex is 0.
///
/// The edge points are E, and the next ones on their rays E/λ. A face point is f(1 + ω), and (λ − 1/8)f = E/2 − (2c − 1)E/16 −
/// E/(16λ), as ω² + 1/ω = (2c − 1)(1 + ω). Points are multiplied by λ, λ − 1/8 and λ + 1/16 to have no quotients.
pub(super) fn eigenvector(cosine: &RealCyclotomic, value: &Ball) -> Net<Ball> {
    let cosine = Ball::of(cosine);
    let zero = Ball::zero;
    let sixteen = |x: &Ball| x.times(&ratio(16, 1));
    let less = value.minus(&ratio(1, 8));
    let edge = sixteen(&value.times(&less));
    let two = cosine.plus(&cosine);
    let face = value.times(&ratio::<Ball>(9, 1).minus(&two)).minus(&ratio(1, 1));
    let points = BTreeMap::from([
        ((0, 0), [zero(), zero()]),
        ((1, 0), [edge, zero()]),
        ((1, 1), [face.clone(), face]),
        ((2, 0), [sixteen(&less), zero()]),
    ]);
    let mut net = Net { lattice: Lattice::Triangle, cosine, points, start: 1 };
    // λx is the rule's sum, in which x has the weight −1/16.
    let own = value.plus(&ratio(1, 16));
    let [right, left] = [(2, 1), (1, 2)].map(|place| sum(&net, place, Some(place)));
    scale(&mut net, &own);
    net.points.insert((2, 1), right);
    net.points.insert((1, 2), left);
    let ray = sum(&net, (3, 0), None);
    scale(&mut net, value);
    net.points.insert((3, 0), ray);
    net
}

fn scale(net: &mut Net<Ball>, by: &Ball) {
    for x in net.points.values_mut().flatten() {
        *x = x.times(by);
    }
}

/// The rule of a new point, in sixteenths.
fn rule((a, b): (i32, i32)) -> Vec<((i32, i32), i64)> {
    let (x, y) = (a.div_euclid(2), b.div_euclid(2));
    let (near, wings, far) = match (a.rem_euclid(2), b.rem_euclid(2)) {
        (0, 0) => return vec![((x, y), 16)],
        (1, 0) => ([(0, 0), (1, 0)], [(0, 1), (1, -1)], [(-1, 1), (1, 1), (0, -1), (2, -1)]),
        (0, _) => ([(0, 0), (0, 1)], [(1, 0), (-1, 1)], [(1, -1), (1, 1), (-1, 0), (-1, 2)]),
        _ => ([(1, 0), (0, 1)], [(0, 0), (1, 1)], [(1, -1), (-1, 1), (2, 0), (0, 2)]),
    };
    let weighted = |place: &(i32, i32), weight| ((x + place.0, y + place.1), weight);
    let near = near.iter().map(|place| weighted(place, 8));
    let wings = wings.iter().map(|place| weighted(place, 2));
    near.chain(wings).chain(far.iter().map(|place| weighted(place, -1))).collect()
}

/// What the rule makes of the old points, but for one of them.
fn sum(net: &Net<Ball>, place: (i32, i32), without: Option<(i32, i32)>) -> Point<Ball> {
    let mut sum = [Ball::zero(), Ball::zero()];
    for (old, weight) in rule(place) {
        if Some(old) != without {
            let weight = ratio::<Ball>(weight, 16);
            for (sum, x) in sum.iter_mut().zip(&net.at(old)) {
                sum.accumulate(&x.times(&weight));
            }
        }
    }
    sum
}

/// The next level of a net of an eigenvector for λ that has the points a + b ≤ far: those with a + b ≤ 2·far − 2.
fn refined(net: &Net<Ball>, value: &Ball, far: i32) -> Net<Ball> {
    let mut points = BTreeMap::from([((0, 0), net.points[&(0, 0)].clone())]);
    for a in 1..=2 * far - 2 {
        for b in 0..=2 * far - 2 - a {
            let point = if (a, b) == (1, 0) {
                net.points[&(1, 0)].each_ref().map(|x| x.times(value))
            } else {
                sum(net, (a, b), None)
            };
            points.insert((a, b), point);
        }
    }
    Net { lattice: net.lattice, cosine: net.cosine.clone(), points, start: 1 }
}

/// Whether the limit of a net is shown to be apart from 0 on a closed curve around the vertex that turns by a sector do not change;
/// with `one_sign`, that p + q has one sign there.
pub(super) fn is_apart(net: Net<Ball>, value: &Ball, one_sign: bool) -> bool {
    let (mut net, mut far) = (net, 3);
    for level in 1..=*LEVELS.end() {
        net = refined(&net, value, far);
        far = 2 * far - 2;
        // All points up to three edges from the curve a + b = m have a + b ≤ far.
        let m = far - REACH;
        if LEVELS.contains(&level)
            && (0..m).all(|i| cell(&net, [(m - i, i), (m - i - 1, i + 1)], one_sign))
        {
            return true;
        }
    }
    false
}

/// Whether a linear form is shown to be positive on an edge; p + q, or its opposite, times a constant, with `one_sign`.
fn cell(net: &Net<Ball>, ends: [(i32, i32); 2], one_sign: bool) -> bool {
    let at = ends.map(|place| net.at(place));
    let towards = if one_sign {
        // The sign at the edge point decides, as all cells have to agree with it.
        let first = &net.points[&(1, 0)][0];
        [first.clone(), first.clone()]
    } else {
        [0, 1].map(|i| at[0][i].plus(&at[1][i]))
    };
    let form = |[p, q]: &Point<Ball>| {
        let [s, t] = &towards;
        if one_sign {
            return p.times(s).plus(&q.times(t));
        }
        p.times(s).plus(&q.times(t)).plus(&net.cosine.times(&p.times(t).plus(&q.times(s))))
    };
    let values = at.each_ref().map(form);
    let double = |x: &Ball| x.plus(x);
    let is_small = |difference: &Ball| {
        values.iter().all(|value| {
            let twice = double(difference);
            value.minus(&twice).sign() == Some(1) && value.plus(&twice).sign() == Some(1)
        })
    };
    let mut known: BTreeMap<(i32, i32), Ball> = BTreeMap::new();
    for (a, b) in ends {
        for u in -REACH..=REACH {
            for v in (-REACH).max(-REACH - u)..=REACH.min(REACH - u) {
                let place = (a + u, b + v);
                known.entry(place).or_insert_with(|| form(&net.at(place)));
            }
        }
    }
    let next = [(1, 0), (0, 1), (1, -1)];
    known.iter().all(|((a, b), value)| {
        let others = next.iter().filter_map(|(u, v)| known.get(&(a + u, b + v)));
        others.into_iter().all(|other| is_small(&value.minus(other)))
    })
}
