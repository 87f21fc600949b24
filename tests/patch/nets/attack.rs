//! The certified level against thousands of limit points, each by its functional of the control points.

use super::{depth, distances, length};
use crate::common::{int, r};
use crate::net::{CLOSED, bumpy, heights, nets, scheme};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::float::nearest;
use subcert::limit::{Functional, Limit, natural_shift};
use subcert::net::{Net, NetScheme};
use subcert::oracle::SplitMix64;
use subcert::patch::net_a_priori;
use subcert::scheme::Mask;

/// One direction: the limit, the shift, and the cells that the net determines.
struct Line {
    limit: Limit,
    shift: Rational,
    cells: Vec<i64>,
    arity: i64,
}

impl Line {
    fn new(mask: &Mask, count: usize, closed: bool) -> Line {
        let limit = Limit::new(mask).expect("it converges");
        let shift = natural_shift(mask).shift;
        // Parameters of few digits: at others a limit is the solution of a system.
        let unit = int(mask.arity()).pow(4);
        let inside = |cell: &i64| {
            [0, 1, unit / 2, unit - 1, unit].into_iter().all(|u| {
                let t = Rational::from(*cell) + r(u, unit);
                let both = [
                    limit.at(&t),
                    limit.polygon_from(0, &t, &shift),
                    limit.polygon_from(3, &t, &shift),
                ];
                both.iter().all(|f| {
                    let (first, last) =
                        f.as_ref().expect("a fraction").support().expect("a sum of 1");
                    first >= 0 && last < int(count)
                })
            })
        };
        let all = 0..int(count);
        let cells = if closed { all.collect() } else { all.filter(inside).collect() };
        Line { limit, shift, cells, arity: int(mask.arity()) }
    }

    /// The limit and the polygon of a level at t.
    fn at(&self, level: u32, t: &Rational) -> [Functional; 2] {
        let polygon = self.limit.polygon_from(level, t, &self.shift);
        [self.limit.at(t).expect("a fraction"), polygon.expect("a fraction")]
    }

    /// A parameter that some digits after those of the level tell.
    fn random(&self, level: u32, random: u64) -> Rational {
        let cell = self.cells[usize::try_from(random % self.cells.len() as u64).expect("small")];
        let points = self.arity.pow(level + 2);
        let digits = i64::try_from(random / 97 % u64::try_from(points + 1).expect("positive"));
        Rational::from(cell) + r(digits.expect("small"), points)
    }
}

fn lines(net: &Net, scheme: &NetScheme) -> [Line; 2] {
    let closed = net.closed().both();
    [0, 1].map(|d| Line::new(&scheme.masks()[d], net.sizes()[d], closed[d]))
}

/// Σ f_i g_j x_{i,j}.
fn value(net: &Net, f: &Functional, g: &Functional) -> [Rational; 3] {
    let (rows, columns) = (int(net.rows()), int(net.columns()));
    let mut sum = [0, 0, 0].map(Rational::from);
    for (i, x) in f.terms() {
        for (j, y) in g.terms() {
            let place = i.rem_euclid(rows) * columns + j.rem_euclid(columns);
            assert!(net.closed().u || (0..rows).contains(&i), "point {i} is outside");
            assert!(net.closed().v || (0..columns).contains(&j), "point {j} is outside");
            let weight = x * y;
            let point = &net.points()[usize::try_from(place).expect("a place")];
            for (sum, x) in sum.iter_mut().zip(point) {
                *sum += &(&weight * x);
            }
        }
    }
    sum
}

/// |P^∞ − P^k| at (s, t).
fn distance(net: &Net, lines: &[Line; 2], level: u32, at: [&Rational; 2]) -> f64 {
    let [[l, p], [m, q]] = [0, 1].map(|d| lines[d].at(level, at[d]));
    let (limit, polygon) = (value(net, &l, &m), value(net, &p, &q));
    length([0, 1, 2].map(|c| nearest(&(&limit[c] - &polygon[c]))))
}

/// The greatest distance of some points.
fn greatest(net: &Net, lines: &[Line; 2], level: u32, count: usize) -> f64 {
    let mut random = SplitMix64::new(u64::from(level) + 5);
    let mut greatest = 0.0_f64;
    for _ in 0..count {
        let s = lines[0].random(level, random.next().expect("there is always one"));
        let t = lines[1].random(level, random.next().expect("there is always one"));
        greatest = greatest.max(distance(net, lines, level, [&s, &t]));
    }
    greatest
}

const NAMES: [&str; 8] = [
    "bicubic",
    "chaikin",
    "b-spline:degree=4 x b-spline:degree=5",
    "four-point:w=1/16",
    "four-point:w=1/50 x b-spline:degree=3",
    "ternary-three-point:a=7/27",
    "ternary-four-point-approximating x chaikin",
    "quinary-three-point x b-spline:degree=3",
];

fn attack(net: &Net, name: &str, tolerance: &Rational, count: usize) {
    let scheme = scheme(name);
    let lines = lines(net, &scheme);
    let found = distances(net, &scheme).depth(tolerance).expect("a depth");
    let epsilon = nearest(tolerance);
    for level in found.level..found.level + 2 {
        let greatest = greatest(net, &lines, level, count);
        assert!(greatest <= epsilon, "{name} level {level}: {greatest} > {epsilon}");
        if level == found.level {
            assert!(greatest <= found.distance[1] * (1.0 + 1e-9), "{name}: {greatest} {found:?}");
        }
    }
    assert!(found.distance[1] <= epsilon * 1.002, "{name}: {found:?}");
    assert!(found.distance[0] <= found.distance[1] && found.apart <= found.distance[1]);
    assert!(found.too_few.is_none_or(|few| few < found.level));
    if let Some(beyond) = &found.beyond {
        let far = length([0, 1, 2].map(|c| beyond.on_mesh[c] - beyond.on_limit[c]));
        assert!(far > epsilon * (1.0 - 1e-9), "{name}: {found:?}");
    }
    let guaranteed = net_a_priori(net, &scheme, tolerance).expect("a level");
    assert!(guaranteed.level >= found.level, "{name}: {guaranteed:?} {found:?}");
}

#[test]
fn no_limit_point_is_farther_away_than_certified() {
    for (i, name) in NAMES.into_iter().enumerate() {
        // Open and closed nets in turn.
        let net = bumpy(10, 11, CLOSED[2 * (i % 2)]);
        for tolerance in [r(1, 1), r(1, 20)] {
            attack(&net, name, &tolerance, 12);
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(5))]

    #[test]
    fn nor_of_random_nets(
        net in nets(10, 10),
        name in prop::sample::select(&NAMES[..]),
        (p, q) in (1_i64..30, 1_i64..20),
    ) {
        attack(&net, name, &r(p, q), 24);
    }
}

/// Heights over the indices: the coordinates of a place are its parameters, and there the distance is what the
/// place says. The face is the one above which it is.
#[test]
fn the_witness_is_where_it_is_said_to_be() {
    for name in ["bicubic", "chaikin", "four-point:w=1/16", "b-spline:degree=4"] {
        let net =
            heights(11, 12, |i, j| Rational::from((7 * i * i + 5 * i * j + 3 * j * j * j) % 11));
        let scheme = scheme(name);
        let lines = lines(&net, &scheme);
        for tolerance in [r(1, 2), r(1, 30)] {
            let found = depth(&net, &scheme, &tolerance);
            let level = found.too_few.expect("a bumpy net");
            assert_eq!(level + 1, found.level, "{name}");
            let worst = found.worst.as_ref().map(|place| (found.level, place, found.distance[0]));
            let beyond = found.beyond.as_ref().map(|place| (level, place, nearest(&tolerance)));
            for (level, place, least) in [worst, beyond].into_iter().flatten() {
                let [x, y, _] = place.on_mesh;
                // Point i belongs to i + s.
                let at = [(y, 0), (x, 1)]
                    .map(|(x, d)| subcert::float::exact(x).expect("finite") + &lines[d].shift);
                let distance = distance(&net, &lines, level, [&at[0], &at[1]]);
                assert!(distance >= least * (1.0 - 1e-9), "{name}: {distance} {least} {place:?}");
                let far = length([0, 1, 2].map(|c| place.on_mesh[c] - place.on_limit[c]));
                assert!((distance - far).abs() < 1e-9, "{name}: {distance} {far}");
                let (i, j) = (place.face / 11, place.face % 11);
                let over = |index: usize, x: f64| (x - 0.5 - nearest(&Rational::from(index))).abs();
                assert!(over(i, y) <= 0.5 && over(j, x) <= 0.5, "{name}: {place:?}");
                let vertex = place.vertex.expect("a vertex");
                let near =
                    |index: usize, x: f64| (x - nearest(&Rational::from(index))).abs() <= 0.5;
                assert!(near(vertex / 12, y) && near(vertex % 12, x), "{name}: {place:?}");
                // The face of the level is that of the refined net which holds the point.
                let refined = subcert::net::refine_net(&net, &scheme, level).expect("a net");
                let Some(face) = place.level_face else { continue };
                let columns = refined.faces()[1];
                let face = usize::try_from(face).expect("small");
                let corner = &refined.points()[face / columns * refined.columns() + face % columns];
                let part = 1.0 / f64::from(1_u32 << level);
                for (c, at) in [(0, x), (1, y)] {
                    let from = at - nearest(&corner[c]);
                    assert!((-1e-9..=part + 1e-9).contains(&from), "{name}: {from} {place:?}");
                }
            }
        }
    }
}
