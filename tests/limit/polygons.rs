//! Thousands of random control polygons, refined in plain integers: none is farther from
//! its limit than the distance constants say, and each is as far as its own distance says.

use super::values::limit;
use crate::common::{int, mask, r};
use subcert::exact::Rational;
use subcert::limit::{ControlPolygon, Distances};
use subcert::oracle::SplitMix64;
use subcert::scheme::Mask;

/// The levels that are compared with the limit, and the level of its parameters.
const LEVELS: usize = 8;
const DIGITS: usize = 6;

/// A scheme on integers: the mask times `scale`.
struct Plain {
    arity: usize,
    offset: i128,
    rows: Vec<Vec<i128>>,
    scale: i128,
    /// The limit at 0 times `whole`, by the indices of the points.
    at_zero: Vec<(i128, i128)>,
    whole: i128,
}

fn integer(value: &Rational, scale: i128) -> i128 {
    let (p, q) = (value.numerator().to_i128().unwrap(), value.denominator().to_i128().unwrap());
    assert_eq!(scale % q, 0);
    p * (scale / q)
}

fn common<'a>(values: impl Iterator<Item = &'a Rational>) -> i128 {
    let lcm = values.fold(subcert::exact::Integer::one(), |lcm, x| lcm.lcm(&x.denominator()));
    lcm.to_i128().unwrap()
}

fn cyclic(points: &[i128], index: i128) -> i128 {
    points[usize::try_from(index.rem_euclid(points.len() as i128)).unwrap()]
}

impl Plain {
    fn new(mask: &Mask) -> Plain {
        let zero = limit(mask).at(&Rational::zero()).unwrap();
        let scale = common(mask.rules().rows().iter().flatten());
        let whole = common(zero.terms().map(|(_, c)| c));
        let row = |row: &Vec<Rational>| row.iter().map(|x| integer(x, scale)).collect();
        Plain {
            arity: mask.arity(),
            offset: mask.offset().into(),
            rows: mask.rules().rows().iter().map(row).collect(),
            scale,
            at_zero: zero.terms().map(|(i, c)| (i.into(), integer(c, whole))).collect(),
            whole,
        }
    }

    /// The points of the next level, times `scale`.
    fn refine(&self, points: &[i128]) -> Vec<i128> {
        let rule = |i: usize, row: &Vec<i128>| {
            let first = i as i128 + self.offset;
            (first..).zip(row).map(|(j, a)| a * cyclic(points, j)).sum::<i128>()
        };
        let all = (0..points.len()).flat_map(|i| self.rows.iter().map(move |row| rule(i, row)));
        all.collect()
    }

    /// For k = 0, …, 8 the greatest |P^∞ − P^k| at all i/n^6 of a closed polygon.
    fn distances(&self, points: &[i128]) -> Vec<Rational> {
        let mut levels = vec![points.to_vec()];
        while levels.len() <= LEVELS {
            levels.push(self.refine(&levels[levels.len() - 1]));
        }
        let power = |level: usize| self.scale.pow(u32::try_from(level).unwrap());
        let steps = |digits: usize| self.arity.pow(u32::try_from(digits).unwrap());
        let count = points.len() * steps(DIGITS);
        let fine = &levels[DIGITS];
        let value = |i: usize| {
            let terms = self.at_zero.iter().map(|(j, w)| w * cyclic(fine, i as i128 + j));
            terms.sum::<i128>()
        };
        let limit: Vec<i128> = (0..count).map(value).collect();
        // All values times whole·scale^8·n^6.
        let digits = steps(DIGITS) as i128;
        let limit_scale = power(LEVELS - DIGITS) * digits;
        let distance = |(k, level): (usize, &Vec<i128>)| {
            let scale = self.whole * power(LEVELS - k);
            let on_polygon = |i: usize| {
                if let Some(finer) = k.checked_sub(DIGITS) {
                    return level[i * steps(finer)] * digits;
                }
                let parts = steps(DIGITS - k);
                let (left, s) = (i / parts, (i % parts) as i128);
                let (x, y) = (level[left], level[(left + 1) % level.len()]);
                ((parts as i128 - s) * x + s * y) * (digits / parts as i128)
            };
            let off = |i: usize| (limit[i] * limit_scale - on_polygon(i) * scale).abs();
            let greatest = (0..count).map(off).max().unwrap();
            Rational::new(greatest, self.whole * power(LEVELS) * digits)
        };
        levels.iter().enumerate().map(distance).collect()
    }
}

/// A closed polygon of 3 to 6 integers, large or small ones.
fn random_polygon(random: &mut SplitMix64) -> Vec<i128> {
    let mut below = |n: u64| i128::from(random.next().unwrap() % n);
    let (count, size) = (3 + below(4), 1 + below(9));
    (0..count).map(|_| below(u64::try_from(2 * size + 1).unwrap()) - size).collect()
}

fn spread(points: &[i128]) -> Rational {
    let steps = (0..points.len()).map(|i| (cyclic(points, i as i128 + 1) - points[i]).abs());
    Rational::from(i64::try_from(steps.max().unwrap()).unwrap())
}

/// Compares `count` polygons, some of them also with their own distances, which are met
/// to this width.
fn compare(name: &str, mask: &Mask, count: usize, width: &Rational) {
    let distances = Distances::new(&limit(mask)).unwrap();
    let levels = 0..=u32::try_from(LEVELS).unwrap();
    let constants: Vec<_> = levels.map(|k| distances.constant(k, width).unwrap()).collect();
    for (k, constant) in constants.iter().enumerate() {
        let (lower, upper) = (constant.enclosure.lower(), constant.enclosure.upper());
        assert!(lower <= upper && upper - lower <= *width, "{name}, level {k}");
    }
    let plain = Plain::new(mask);
    let mut random = SplitMix64::new(mask.arity() as u64 * 1000 + mask.width() as u64);
    for case in 0..count {
        let points = random_polygon(&mut random);
        let spread = spread(&points);
        let seen = plain.distances(&points);
        for (k, (seen, constant)) in seen.iter().zip(&constants).enumerate() {
            let most = constant.enclosure.upper() * &spread;
            assert!(*seen <= most, "{name}: {points:?} at level {k}: {seen} > {most}");
        }
        if case % 100 > 0 {
            continue;
        }
        let values: Vec<Rational> =
            points.iter().map(|x| r(i64::try_from(*x).unwrap(), 1)).collect();
        let own = ControlPolygon::closed(&values);
        for (k, seen) in (0..).zip(&seen) {
            let own = distances.of_polygon(&own, k, width).unwrap().enclosure;
            assert!(seen <= own.upper(), "{name}: {points:?} at level {k}");
            // What is between the parameters i/n^6 is not seen; half of it is, at least.
            let twice = seen + seen;
            assert!(*own.lower() <= twice || k > 4, "{name}: {points:?} at level {k}");
        }
    }
}

#[test]
fn no_binary_polygon_is_farther() {
    for name in [
        "b-spline:degree=1",
        "chaikin",
        "b-spline:degree=3",
        "b-spline:degree=4",
        "b-spline:degree=5",
        "four-point",
        "four-point:w=1/10",
        "six-point:w=3/256",
    ] {
        compare(name, &mask(name), 400, &r(1, 500));
    }
    compare("four-point, shifted", &mask("four-point").with_offset(0), 400, &r(1, 100));
}

#[test]
fn no_polygon_of_higher_arity_is_farther() {
    for (name, count) in [
        ("newton:j=1,n=3", 60),
        ("ternary-four-point:mu=1/11", 60),
        ("quaternary-four-point:mu=0", 15),
        ("quinary-three-point", 5),
    ] {
        compare(name, &mask(name), count, &r(1, 200));
    }
}

// C_k of the B-splines of degree 1 to 5. Degree 1 is its polygon, and 2 and 3 stand in
// `distances.rs`. Of degree 4 the line x_i = i is 2^−k/2 away: that is the sum of the
// coefficients of the functional. One of them has the other sign, the outermost: a tail
// t^4/24 of the basis function, at t = 2^−k.
#[test]
fn quartic_b_spline_by_hand() {
    let distances = Distances::new(&limit(&mask("b-spline:degree=4"))).unwrap();
    for k in 0..9 {
        let expected = r(1, 2 << k) + r(1, 12 << (4 * k));
        let constant = distances.constant(k, &(&expected * r(1, 1000))).unwrap().enclosure;
        assert!(constant.contains(&expected), "level {k}: {constant:?}");
    }
}

// Of degree 5 at the points of level k: with ∇Δ^k = 4^−k S^k∇Δ^0 of the cubic scheme S, the
// distance is (1, 28, 1)/120 of ∇Δ^k. At 0 the row S^k has c = 2/3 + 4^−k/3 in its middle
// and a = 2/3 − 2·4^−k/3 beside it, and the norm by Δ^0 is twice the greatest coefficient
// by ∇Δ^0: 2·4^−k(28c + 2a)/120 = 4^−k(1/3 + 2·4^−k/15).
#[test]
fn quintic_b_spline_by_hand() {
    let distances = Distances::new(&limit(&mask("b-spline:degree=5"))).unwrap();
    for k in 0..9 {
        let scale = r(1, 1 << (2 * k));
        let value = &scale * (r(1, 3) + &scale * r(2, 15));
        let constant = distances.constant(k, &(&value * r(1, 1000))).unwrap().enclosure;
        assert!(constant.contains(&value), "level {k}: {value}, {constant:?}");
        assert_eq!(*constant.lower(), value, "level {k}");
        let error = distances.limit().error(k, &Rational::from(int(7))).unwrap();
        assert_eq!(error.norm(), value);
    }
}

// The least level at which both coordinates are near enough: no level before is, by one of
// them, though it may be by the other.
#[test]
fn points_need_all_coordinates_at_one_level() {
    let distances = Distances::new(&limit(&mask("four-point:w=1/4"))).unwrap();
    let mut random = SplitMix64::new(1);
    let coordinate = |random: &mut SplitMix64| {
        let points = random_polygon(random);
        let points: Vec<Rational> =
            (0..6).map(|i| r(i64::try_from(cyclic(&points, i)).unwrap(), 1)).collect();
        ControlPolygon::closed(&points)
    };
    for _ in 0..20 {
        let both = [coordinate(&mut random), coordinate(&mut random)];
        for tolerance in [r(1, 2), r(1, 20)] {
            let depth = distances.depth_of_points(&both, &tolerance).unwrap();
            let each = both.each_ref().map(|x| distances.depth_of_polygon(x, &tolerance).unwrap());
            assert!(depth.lower >= each[0].lower.max(each[1].lower));
            let all_at = |k: u32| {
                both.iter().all(|x| {
                    let own = distances.of_polygon(x, k, &r(1, 2000)).unwrap().enclosure;
                    *own.lower() <= tolerance
                })
            };
            assert!(all_at(depth.upper));
            for k in 0..depth.lower {
                let exceeds = |x: &ControlPolygon| {
                    let compared = distances.compare_polygon(x, k, &tolerance).unwrap();
                    matches!(compared, subcert::limit::Comparison::Exceeds(_))
                };
                assert!(both.iter().any(exceeds), "level {k}");
            }
        }
    }
}
