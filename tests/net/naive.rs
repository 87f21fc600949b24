//! Refinement as it is defined: every point of the next level all of whose points are there.

use super::{CLOSED, bumpy, scheme};
use crate::common::int;
use std::collections::BTreeMap;
use subcert::exact::Rational;
use subcert::mesh::Point;
use subcert::net::{Net, NetScheme, refine_net};
use subcert::scheme::Mask;

type Points = BTreeMap<(i64, i64), Point<Rational>>;

fn points_of(net: &Net) -> Points {
    let place = |k: usize| (int(k / net.columns()), int(k % net.columns()));
    net.points().iter().enumerate().map(|(k, point)| (place(k), point.clone())).collect()
}

/// The points and weights of point `index` of the next level.
fn terms(mask: &Mask, index: i64) -> Vec<(i64, Rational)> {
    let n = int(mask.arity());
    let row = &mask.rules().rows()[usize::try_from(index.rem_euclid(n)).expect("a residue")];
    let first = index.div_euclid(n) + mask.offset();
    (first..).zip(row.iter().cloned()).filter(|(_, weight)| !weight.is_zero()).collect()
}

/// All points of the next level that these determine.
fn refined(points: &Points, sizes: [i64; 2], net: &Net, scheme: &NetScheme) -> Points {
    let masks = scheme.masks();
    let closed = net.closed().both();
    let reach = |d: usize| {
        let n = int(masks[d].arity());
        if closed[d] { 0..n * sizes[d] } else { -200..n * sizes[d] + 400 }
    };
    let at = |d: usize, index: i64| if closed[d] { index.rem_euclid(sizes[d]) } else { index };
    let mut all = Points::new();
    for i in reach(0) {
        for j in reach(1) {
            let mut sum = Some([0, 0, 0].map(Rational::from));
            for (p, x) in terms(&masks[0], i) {
                for (q, y) in terms(&masks[1], j) {
                    sum = match (sum, points.get(&(at(0, p), at(1, q)))) {
                        (Some(mut sum), Some(point)) => {
                            for (sum, value) in sum.iter_mut().zip(point) {
                                *sum += &(&x * &y * value);
                            }
                            Some(sum)
                        }
                        _ => None,
                    };
                }
            }
            if let Some(point) = sum {
                all.insert((i, j), point);
            }
        }
    }
    all
}

/// Where a net stands among these points.
fn place(net: &Net, points: &Points) -> Option<(i64, i64)> {
    let same = |&(i, j): &(i64, i64)| {
        net.points().iter().enumerate().all(|(k, point)| {
            let place = (i + int(k / net.columns()), j + int(k % net.columns()));
            points.get(&place) == Some(point)
        })
    };
    points.keys().copied().find(same)
}

#[test]
fn refinement_is_that_of_the_definition() {
    for name in [
        "bicubic",
        "chaikin",
        "b-spline:degree=4 x chaikin",
        "four-point:w=1/16 x b-spline:degree=3",
        "ternary-three-point:a=7/27 x chaikin",
        "quaternary-four-point:mu=1/50",
        "newton:j=1,n=3",
    ] {
        let scheme = scheme(name);
        for closed in CLOSED {
            let net = bumpy(7, 8, closed);
            let found = refine_net(&net, &scheme, 1).expect("a refined net");
            let expected = refined(&points_of(&net), [7, 8], &net, &scheme);
            let place = place(&found, &expected);
            let place = place.unwrap_or_else(|| panic!("{name} {closed:?}: other points"));
            // A closed direction begins with point 0 and has all.
            let [n, m] = scheme.masks().each_ref().map(Mask::arity);
            if closed.u {
                assert_eq!((place.0, found.rows()), (0, 7 * n), "{name}");
            }
            if closed.v {
                assert_eq!((place.1, found.columns()), (0, 8 * m), "{name}");
            }
        }
    }
}

/// An open net of B-splines has all points of the next level that it determines.
#[test]
fn nothing_of_splines_is_lost() {
    for (name, sizes) in
        [("bicubic", [9, 11]), ("chaikin", [10, 12]), ("b-spline:degree=5", [7, 9])]
    {
        let scheme = scheme(name);
        let net = bumpy(6, 7, CLOSED[0]);
        let found = refine_net(&net, &scheme, 1).expect("a refined net");
        assert_eq!(found.sizes(), sizes, "{name}");
        assert_eq!(refined(&points_of(&net), [6, 7], &net, &scheme).len(), sizes[0] * sizes[1]);
    }
}

/// Four points of a bicubic net in each direction: by hand, from (1, 6, 1)/8 and (1, 1)/2.
#[test]
fn one_piece_by_hand() {
    let mut points = Vec::new();
    for i in 0..4 {
        for j in 0..4 {
            points.push([j, i, if (i, j) == (1, 1) { 64 } else { 0 }].map(Rational::from));
        }
    }
    let net = Net::new(points, 4, CLOSED[0]).expect("a net");
    let refined = refine_net(&net, &scheme("bicubic"), 1).expect("a refined net");
    let heights: Vec<i64> =
        refined.points().iter().map(|point| point[2].floor().to_i64().expect("small")).collect();
    // 64 times (4, 6, 4, 1, 0)/8 in both directions.
    let row = [4, 6, 4, 1, 0];
    let expected: Vec<i64> = row.iter().flat_map(|x| row.map(|y| x * y)).collect();
    assert_eq!(heights, expected);
}
