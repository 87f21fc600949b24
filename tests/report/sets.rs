//! Sets of a parameter in words: what is proved is never said of more values, and ends are named.

use proptest::prelude::*;
use std::ops::Bound;
use subcert::exact::{
    Integer, IntegerPolynomial, Interval, IntervalSet, Rational, RealAlgebraic, parse_rational,
};
use subcert::float::nearest;
use subcert::report::{found_texts, interval_texts, number, proved_texts};

fn closed(low: &RealAlgebraic, high: &RealAlgebraic) -> IntervalSet {
    IntervalSet::from(Interval {
        low: Bound::Included(low.clone()),
        high: Bound::Included(high.clone()),
    })
}

fn outside(low: &RealAlgebraic, high: &RealAlgebraic) -> IntervalSet {
    let below = Interval { low: Bound::Unbounded, high: Bound::Included(low.clone()) };
    let above = Interval { low: Bound::Included(high.clone()), high: Bound::Unbounded };
    IntervalSet::from(below).union(&IntervalSet::from(above))
}

fn r(numerator: i64, denominator: i64) -> RealAlgebraic {
    RealAlgebraic::from(Rational::new(numerator, denominator))
}

#[test]
fn ends_are_named_where_they_are_known() {
    let inside = closed(&r(-16_383, 32_768), &r(16_383, 32_768));
    let half = outside(&r(-1, 2), &r(1, 2));
    // 1/32768 = 3.05…e-5, rounded upwards.
    assert_eq!(
        proved_texts(&inside, &half, "w"),
        ["|w| < 1/2, proved up to 3.1·10^-5 of the ends"]
    );
    // Beyond 3/4 nothing is known of the ends.
    assert_eq!(
        proved_texts(&inside, &outside(&r(-3, 4), &r(3, 4)), "w"),
        ["-0.499969 <= w <= 0.499969"]
    );
    assert_eq!(found_texts(&inside, "w"), ["-0.499969 <= w <= 0.499969"]);
    // An end of the opposite that a search has left is no name either.
    let near = outside(&r(-16_385, 32_768), &r(16_385, 32_768));
    assert_eq!(proved_texts(&inside, &near, "w"), ["-0.499969 <= w <= 0.499969"]);
    assert_eq!(found_texts(&near, "w"), ["w <= -0.500031", "w >= 0.500031"]);
    // One end exactly, the other one nearly.
    let from_zero = IntervalSet::from(Interval {
        low: Bound::Excluded(r(0, 1)),
        high: Bound::Included(r(16_383, 32_768)),
    });
    let opposite = outside(&r(0, 1), &r(1, 2));
    assert_eq!(
        proved_texts(&from_zero, &opposite, "w"),
        ["0 < w < 1/2, proved up to 3.1·10^-5 of the upper end"]
    );
    // Between the set and the opposite lies another part of the set.
    let parts = closed(&r(0, 1), &r(127, 256)).union(&closed(&r(128, 256), &r(255, 256)));
    assert_eq!(
        proved_texts(&parts, &outside(&r(-1, 1), &r(1, 1)), "w"),
        ["0 <= w <= 0.496093", "1/2 <= w < 1, proved up to 0.004 of the upper end"]
    );
    assert_eq!(
        interval_texts(&closed(&r(-16_383, 32_768), &r(1, 3)), "w"),
        ["-16383/32768 <= w <= 1/3"]
    );
    assert_eq!(interval_texts(&closed(&r(1, 3), &r(1, 3)), "w"), ["w = 1/3"]);
    assert_eq!(interval_texts(&IntervalSet::everything(), "w"), ["every w"]);
}

#[test]
fn numbers_are_exact_or_cut() {
    let roots = |coefficients: &[i64]| {
        let coefficients = coefficients.iter().map(|c| Integer::from(*c)).collect();
        let roots = RealAlgebraic::roots_of(&IntegerPolynomial::new(coefficients));
        roots.iter().map(number).collect::<Vec<String>>()
    };
    // (1 ± √73)/4 are the roots of 2x² − x − 9.
    assert_eq!(roots(&[-9, -1, 2]), ["(1 - √73)/4", "(1 + √73)/4"]);
    assert_eq!(roots(&[-2, 0, 1]), ["-√2", "√2"]);
    assert_eq!(roots(&[-3, 0, 4]), ["-√3/2", "√3/2"]);
    assert_eq!(roots(&[-1, -2, 1]), ["1 - √2", "1 + √2"]);
    assert_eq!(roots(&[9, 1, -2]), ["(1 - √73)/4", "(1 + √73)/4"]);
    // 32w³ + 4w − 1 has the root 0.19272924926…
    assert_eq!(roots(&[-1, 4, 0, 32]), ["0.192729249264…"]);
}

proptest! {
    /// What is said of a set is true of no value outside it, and of all but a part of 10^-5 of it.
    #[test]
    fn decimals_are_rounded_into_the_set(low in -40_000_i64..40_000, length in 1_i64..40_000, power in 7_u32..16) {
        let unit = 1_i64 << power;
        let (low, high) = (Rational::new(low, unit), Rational::new(low + length, unit));
        let texts = found_texts(&closed(&low.clone().into(), &high.clone().into()), "w");
        let words: Vec<&str> = texts[0].split(" <= ").collect();
        prop_assert_eq!(words.len(), 3, "{}", texts[0]);
        let said = [words[0], words[2]].map(|text| parse_rational(text).expect("a number"));
        prop_assert!(low <= said[0] && said[0] <= said[1] && said[1] <= high, "{}", texts[0]);
        let near = |x: &Rational, y: &Rational| (x - y).abs() <= x.abs() * Rational::new(1, 100_000);
        prop_assert!(near(&low, &said[0]) && near(&high, &said[1]), "{}", texts[0]);
    }

    /// The distance that is said is no less than that of the ends, and no more than a tenth above.
    #[test]
    fn distances_are_rounded_upwards(numerator in 1_i64..500, power in 16_u32..40) {
        let gap = Rational::new(numerator, 1_i64 << power);
        let high = Rational::one() - &gap;
        let texts = proved_texts(&closed(&r(0, 1), &high.into()), &outside(&r(-1, 1), &r(1, 1)), "w");
        let said = texts[0].split("up to ").nth(1).and_then(|text| text.split(" of the").next());
        let said = parse_rational(&said.expect("a distance").replace('·', " × ")).expect("a number");
        prop_assert!(gap <= said && said <= &gap * Rational::new(11, 10), "{} for {gap}", texts[0]);
    }

    /// The formula of a root has its value.
    #[test]
    fn roots_by_formula(a in 1_i64..30, b in -30_i64..30, c in -30_i64..30) {
        for root in RealAlgebraic::roots_of(&IntegerPolynomial::from([c, b, a])) {
            let text = number(&root);
            prop_assert!((value(&text) - nearest(&root)).abs() < 1e-9, "{text} of {root}");
        }
    }
}

/// The value of `(p + q√d)/r`, of a fraction, or of a decimal that is cut.
fn value(text: &str) -> f64 {
    let float = |text: &str| text.trim_end_matches('…').parse::<f64>().expect("a number");
    let (sum, below) =
        text.rsplit_once('/').map_or((text, 1.0), |(sum, below)| (sum, float(below)));
    let term = |term: &str| {
        let (sign, size) = term.strip_prefix('-').map_or((1.0, term), |size| (-1.0, size));
        let (factor, root) =
            size.split_once('√').map_or((size, 1.0), |(q, d)| (q, float(d).sqrt()));
        sign * root * if factor.is_empty() { 1.0 } else { float(factor) }
    };
    let sum = sum.trim_matches(['(', ')']).replace(" - ", " + -");
    sum.split(" + ").map(term).sum::<f64>() / below
}
