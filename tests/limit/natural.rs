//! Distances in the natural parametrisation: values derived by hand or by another program, and naive
//! refinement.

use super::values::limit;
use crate::common::{at, differences, int, largest, mask, polygon, r, refine};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::limit::{
    Comparison, ControlPolygon, Distances, Functional, Limit, LimitError, natural_shift,
};
use subcert::scheme::Mask;

/// A mask of rows of numbers over one denominator, at an offset.
fn of_rows(rows: &[&[i64]], denominator: i64, offset: i64) -> Mask {
    let row = |row: &&[i64]| row.iter().map(|entry| r(*entry, denominator)).collect();
    Mask::new(rows.iter().map(row).collect(), offset).expect("a mask")
}

/// Keeps lines with s = 1/3: the digits of s repeat after two.
fn third() -> Mask {
    of_rows(&[&[3, 8, 1], &[1, 6, 5]], 12, -1)
}

/// Keeps lines with s = 2/5: the digits of s repeat after four.
fn two_fifths() -> Mask {
    of_rows(&[&[5, 14, 1], &[1, 12, 7]], 20, -1)
}

#[test]
fn shifts_derived_by_hand() {
    let shift = |mask: &Mask| {
        let natural = natural_shift(mask);
        (natural.shift, natural.keeps_lines)
    };
    for (scheme, s) in [
        ("chaikin", r(-1, 2)),
        ("b-spline:degree=4", r(-1, 2)),
        ("b-spline:degree=5", r(0, 1)),
        ("four-point:w=1/16", r(0, 1)),
        ("newton:j=0,n=3", r(-1, 4)),
        ("ternary-four-point-approximating", r(-1, 4)),
        ("quinary-three-point", r(1, 2)),
    ] {
        assert_eq!(shift(&mask(scheme)), (s, true), "{scheme}");
    }
    assert_eq!(shift(&third()), (r(1, 3), true));
    assert_eq!(shift(&two_fifths()), (r(2, 5), true));
    // s_0 = −4/5 and s_1 = −2/5: lines are not kept.
    // The digits of their mean repeat after four.
    assert_eq!(shift(&of_rows(&[&[6, 4], &[3, 7]], 10, 0)), (r(-3, 5), false));
}

/// Limits at parameters whose digits repeat, from a program that solves other systems.
#[test]
fn limits_at_rational_parameters() {
    let third = limit(&third());
    let row = |d: i64, row: &[i64]| row.iter().map(|c| r(*c, d)).collect::<Vec<_>>();
    let expected = [r(6034, 690_335), r(282_539, 1_380_670), r(781_563, 1_380_670)];
    let rest = [r(60_465, 276_134), r(435, 276_134)];
    let expected = Functional::new(-2, expected.into_iter().chain(rest));
    assert_eq!(third.at(&r(1, 3)).unwrap(), expected);
    let four_point = limit(&mask("four-point:w=1/16"));
    let seventh = row(10_012_513, &[45_296, -560_621, 9_379_184, 1_337_024, -188_416, 46]);
    assert_eq!(four_point.at(&r(1, 7)).unwrap(), Functional::new(-2, seventh));
    let chaikin = limit(&mask("chaikin"));
    assert_eq!(chaikin.at(&r(2, 7)).unwrap(), Functional::new(0, row(98, &[25, 69, 4])));
    let ternary = limit(&mask("ternary-three-point:a=1/4"));
    assert_eq!(ternary.at(&r(1, 2)).unwrap(), Functional::new(-1, row(22, &[-1, 12, 12, -1])));
    // 2 has order 100 modulo 101.
    assert!(matches!(chaikin.at(&r(1, 101)), Err(LimitError::Parameter { .. })));
}

/// C_k for k = 0, 1, … from hand-derived formulas and another program's exact values.
#[test]
fn constants_derived_elsewhere() {
    let natural = |mask: &Mask| Distances::natural(&limit(mask)).expect("a natural shift");
    let closed = |scheme: &str, expected: &dyn Fn(u32) -> Rational| {
        let distances = natural(&mask(scheme));
        for k in 0..6 {
            let found = distances.constant(k, &(expected(k) / Rational::from(1_000))).unwrap();
            assert!(found.enclosure.contains(&expected(k)), "{scheme}, {k}");
            assert_eq!(*found.enclosure.lower(), expected(k), "{scheme}, {k}");
        }
    };
    closed("chaikin", &|k| Rational::new(1, 4).pow(k.cast_signed() + 1));
    closed("b-spline:degree=3", &|k| r(1, 3) * r(1, 4).pow(k.cast_signed()));
    closed("newton:j=0,n=3", &|k| r(1, 6).pow(k.cast_signed() + 1));
    // Exact values that are attained, and proved upper bounds to five digits or more.
    for (mask, k, lower, upper) in [
        (third(), 0, r(61_335, 138_067), r(44_424_084, 100_000_000)),
        (third(), 1, r(233_567, 2_071_005), r(1_128_012_127, 10_000_000_000)),
        (third(), 2, r(1_561_861, 49_704_120), r(314_293_532, 10_000_000_000)),
        (two_fifths(), 1, r(93_825_100, 1_000_000_000), r(93_842_027, 1_000_000_000)),
        (mask("b-spline:degree=4"), 0, r(13, 32), r(13, 32)),
        (mask("b-spline:degree=4"), 2, r(479, 24_576), r(19_491_965, 1_000_000_000)),
        (
            mask("ternary-four-point-approximating"),
            1,
            r(3_119_507, 68_191_713),
            r(45_767, 1_000_000),
        ),
        (
            mask("ternary-four-point-approximating"),
            3,
            r(735_877, 1_000_000_000),
            r(736_241, 1_000_000_000),
        ),
    ] {
        let found = natural(&mask).constant(k, &(&lower / Rational::from(2_000))).unwrap();
        assert!(*found.enclosure.upper() >= lower, "{k}: {:?}", found.enclosure);
        assert!(*found.enclosure.lower() <= upper, "{k}: {:?}", found.enclosure);
    }
}

/// A line-keeping mask: Chaikin's and the 4-point scheme's kind, with a free shift.
fn keeping_lines() -> impl Strategy<Value = Mask> {
    // Rows a, b, c of weights with first moments m_α = (α − c)/2: three weights, two conditions.
    let row = |mean: Rational, free: i64| {
        let c = r(free, 16);
        let b = mean - &c * Rational::from(2);
        vec![Rational::one() - &b - &c, b, c]
    };
    (-3_i64..4, 1_i64..6, -1_i64..4, -1_i64..4, -1_i64..1).prop_filter_map(
        "a mask that contracts",
        move |(p, q, one, other, offset)| {
            let mean = r(p, 2 * q) + r(1, 2);
            let rows = vec![row(mean.clone(), one), row(mean + r(1, 2), other)];
            let mask = Mask::new(rows, offset).ok()?;
            Limit::new(&mask).ok()?;
            Some(mask)
        },
    )
}

/// |P^∞ − P^k| at the points of P^m, all at (i + s)/n^level, from naive refinement: P^m is within
/// `rest` of the limit.
fn seen(mask: &Mask, points: &[Rational], k: u32, m: u32, s: &Rational) -> Rational {
    let polygon = |level| (0..level).fold(points.to_vec(), |x, _| refine(mask.rules(), &x));
    let (coarse, fine) = (polygon(k), polygon(m));
    let ratio = Rational::from(mask.arity()).pow((m - k).cast_signed());
    let distance = |i: usize| {
        // (u + s)/n^k = (i + s)/n^m.
        let u = (Rational::from(i) + s) / &ratio - s;
        let whole = u.floor().to_i64().expect("small");
        let part = u - Rational::from(whole);
        let (near, next) = (at(&coarse, whole).clone(), at(&coarse, whole + 1).clone());
        at(&fine, int(i)).clone() - (near * (Rational::one() - &part) + next * part)
    };
    largest(&(0..fine.len()).map(distance).collect::<Vec<_>>())
}

/// The mean 1/6 = 0.0010101…₂ is not rounded; 1/59 is, as the powers of 2 repeat modulo 59 after 58 steps only.
#[test]
fn a_mean_is_rounded_only_where_its_digits_repeat_late() {
    let mask = |a: Rational| {
        let rows = vec![
            vec![(r(1, 1) + &a) / r(4, 1), r(1, 2), (r(1, 1) - &a) / r(4, 1)],
            vec![r(0, 1), r(1, 2), r(1, 2)],
        ];
        subcert::scheme::Mask::new(rows, -1).unwrap()
    };
    let found = |a: Rational| natural_shift(&mask(a));
    let third = found(r(1, 3));
    assert_eq!((third.shift, third.keeps_lines, third.rounded), (r(1, 6), false, false));
    // To the nearest multiple of 1/2048.
    for i in -9..10 {
        let late = found(r(4 * i + 2, 59));
        assert!(late.rounded && (late.shift - r(2 * i + 1, 59)).abs() <= r(1, 4096), "{i}");
    }
}

proptest! {
    #![proptest_config(crate::common::cases(12))]

    /// What naive refinement of closed polygons shows is within the constant and the distance of
    /// the polygon; a witness is as far as it says.
    #[test]
    fn natural_distances_are_those_of_naive_refinement(
        mask in keeping_lines(), points in polygon(3..7), k in 0_u32..3,
    ) {
        let limit = limit(&mask);
        let natural = natural_shift(&mask);
        prop_assert!(natural.keeps_lines);
        let distances = Distances::natural(&limit);
        prop_assume!(!matches!(distances, Err(LimitError::Parameter { .. } | LimitError::Window(_))));
        let distances = distances.unwrap();
        let all = match distances.constant(k, &r(1, 100)) {
            Ok(found) => found,
            Err(LimitError::TooFine { .. }) => return Ok(()),
            Err(error) => return Err(TestCaseError::fail(error.to_string())),
        };
        let error = distances.error(k, &all.parameter).unwrap();
        prop_assert_eq!(&error.norm(), all.enclosure.lower());
        let spread = largest(&differences(&points));
        let closed = ControlPolygon::closed(&points);
        let m = k + 5;
        // P^m is within C_m·spread of the limit.
        let rest = match distances.constant(m, &r(1, 1_000)) {
            Ok(found) => found.enclosure.upper() * &spread,
            Err(_) => return Ok(()),
        };
        let seen = seen(&mask, &points, k, m, distances.shift());
        prop_assert!(seen.clone() <= all.enclosure.upper() * &spread + &rest);
        let own = distances.of_polygon(&closed, k, &r(1, 100)).unwrap();
        prop_assert!(seen <= own.enclosure.upper() + &rest);
        if let Comparison::Exceeds(witness) =
            distances.compare(k, &(all.enclosure.lower() * r(1, 2))).unwrap()
        {
            // Lines keep their place: the distance is the same when a line is added.
            let value = |i: i64| witness.polygon.points.get(usize::try_from(i - witness.polygon.first).unwrap_or(usize::MAX)).map_or(0, |x| *x);
            let difference = |i: i64| Rational::from(value(i + 1) - value(i));
            let error = distances.error(k, &witness.parameter).unwrap();
            prop_assert_eq!(error.apply(difference).abs(), witness.distance);
            prop_assert!(error.apply(|_| Rational::one()).is_zero());
        }
    }

}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    /// Where (n − 1)s is an integer, the natural parametrisation is that of another offset.
    #[test]
    fn whole_shifts_are_offsets(offset in -3_i64..4, k in 0_u32..4) {
        let cubic = mask("b-spline:degree=3").with_offset(offset);
        let own = Distances::natural(&limit(&cubic)).unwrap();
        let centred = Distances::new(&limit(&mask("b-spline:degree=3"))).unwrap();
        let width = r(1, 10_000);
        prop_assert_eq!(
            own.constant(k, &width).unwrap().enclosure,
            centred.constant(k, &width).unwrap().enclosure
        );
    }
}

/// A later level can be farther from the limit: a depth is for all levels from it on.
#[test]
fn depths_last() {
    // Rules (1/2, 1/2), (2/3, 1/3): T_1 = 7/6, C_0 < 0.44 and C_1 > 0.4999.
    let mask = of_rows(&[&[3, 3], &[4, 2]], 6, 0);
    let limit = limit(&mask);
    let distances = Distances::new(&limit).unwrap();
    let tolerance = r(49, 100);
    assert_eq!(distances.compare(0, &tolerance).unwrap(), Comparison::Within);
    assert!(matches!(distances.compare(1, &tolerance).unwrap(), Comparison::Exceeds(_)));
    let depth = distances.depth(&Rational::one(), &tolerance).unwrap();
    assert_eq!(depth.lower, depth.upper);
    assert!(depth.upper > 1);
    for later in depth.upper..depth.upper + 6 {
        assert_eq!(distances.compare(later, &tolerance).unwrap(), Comparison::Within);
    }
    assert!(matches!(
        distances.compare(depth.upper - 1, &tolerance).unwrap(),
        Comparison::Exceeds(_)
    ));
}

/// The depths that people expect of Chaikin's scheme, and those of the papers' parametrisation.
#[test]
fn chaikin_is_near_after_four_levels() {
    let limit = limit(&mask("chaikin"));
    let depth = |distances: Distances| {
        let depth = distances.depth(&Rational::one(), &r(1, 1000)).unwrap();
        assert_eq!(depth.lower, depth.upper);
        depth.upper
    };
    assert_eq!(depth(Distances::natural(&limit).unwrap()), 4);
    assert_eq!(depth(Distances::new(&limit).unwrap()), 9);
}
