//! Claims about smoothness: known schemes against what is known of them, and wrong and open claims.

use crate::common::claims::{DEPENDENT, DEPENDENT_SCHEME, judged, paper};
use proptest::prelude::*;
use subcert::audit::{Direction, KnownLimits, SmoothnessVerdict};
use subcert::exact::{Enclosed as _, LogSum, LogTerm, Rational};

/// The verdict of a claim with these fields.
fn verdict(kind: &str, fields: &str) -> SmoothnessVerdict {
    let paper = paper(&format!("[[{kind}]]\nid = 'c'\nlocus = 'l'\n{fields}\n"));
    judged(&paper).smoothness[0].verdict
}

const CONFIRMED: SmoothnessVerdict = SmoothnessVerdict::Confirmed;
const REFUTED: SmoothnessVerdict = SmoothnessVerdict::Refuted;
const OPEN: SmoothnessVerdict = SmoothnessVerdict::Open;
const NOT_CHECKABLE: SmoothnessVerdict = SmoothnessVerdict::NotCheckable;

#[test]
fn continuity() {
    for (scheme, says, expected) in [
        // B-splines of degree d are C^{d−1}, and no more.
        ("b-spline:degree=3", "continuous = '2'\nnot_continuous = '3'", CONFIRMED),
        ("b-spline:degree=3", "continuous = '3'", REFUTED),
        ("b-spline:degree=3", "not_continuous = '2'", REFUTED),
        // One half is wrong.
        ("b-spline:degree=3", "continuous = '1'\nnot_continuous = '2'", REFUTED),
        ("chaikin", "continuous = '0'", CONFIRMED),
        ("four-point:w=1/2", "not_continuous = '0'", CONFIRMED),
        ("four-point:w=1/2", "continuous = '0'", REFUTED),
        ("quinary-three-point", "not_continuous = '1'", CONFIRMED),
        // The matrices are too large.
        ("newton:j=40,n=2", "continuous = '2'", NOT_CHECKABLE),
    ] {
        let fields = format!("scheme = '{scheme}'\n{says}");
        assert_eq!(verdict("smoothness", &fields), expected, "{fields}");
    }
    assert_eq!(verdict("smoothness", "absent = 'the mask'"), NOT_CHECKABLE);
}

#[test]
fn exponents() {
    for (scheme, says, expected) in [
        // Dubuc and Deslauriers: 2, 6 − log_2 9 = 2.8300749…
        ("six-point:w=3/256", "value = '6 - log_2(9)'", CONFIRMED),
        ("six-point:w=3/256", "value = '6 - 2*log_2(3)'", CONFIRMED),
        ("six-point:w=3/256", "value = '8 - log_2(36)'", CONFIRMED),
        ("six-point:w=3/256", "value = '6 - log_2(9) + 1/10^30'", REFUTED),
        ("six-point:w=3/256", "printed = '2.830'", CONFIRMED),
        ("six-point:w=3/256", "printed = '2.83007499856'", CONFIRMED),
        (
            "six-point:w=3/256",
            "printed = '2.83007499'",
            SmoothnessVerdict::Rounding(Direction::Cut),
        ),
        ("six-point:w=3/256", "printed = '2.831'", SmoothnessVerdict::Rounding(Direction::Away)),
        ("six-point:w=3/256", "printed = '2.832'", REFUTED),
        ("six-point:w=3/256", "printed = '2.829'", REFUTED),
        ("six-point:w=3/256", "at_least = '2.83'\nat_most = '2.8301'", CONFIRMED),
        ("six-point:w=3/256", "at_least = '6 - log_2(9)'", CONFIRMED),
        ("six-point:w=3/256", "at_most = '2.83'", REFUTED),
        ("six-point:w=3/256", "value = '6 - log_2(9)'\nattained = false", REFUTED),
        ("four-point:w=1/16", "value = '2'\nattained = false", CONFIRMED),
        ("four-point:w=1/16", "value = '2'\nattained = true", REFUTED),
        ("four-point:w=1/16", "value = 'log_3(9)'", CONFIRMED),
        // This is 2, but the bases are different.
        ("four-point:w=1/16", "value = 'log_3(9) + log_5(5) - 1'", OPEN),
        ("ternary-four-point:mu=1/11", "value = 'log_3(11)'", CONFIRMED),
        // Without limits there is no exponent.
        ("four-point:w=1", "at_least = '0'", REFUTED),
        ("newton:j=40,n=2", "printed = '3.1'", NOT_CHECKABLE),
    ] {
        let fields = format!("scheme = '{scheme}'\n{says}");
        assert_eq!(verdict("exponent", &fields), expected, "{fields}");
    }
    assert_eq!(verdict("exponent", "absent = 'the mask'"), NOT_CHECKABLE);
}

#[test]
fn ranges() {
    let four_point = "scheme = 'four-point:w=w'\nvariable = 'w'\nsmoothness = '1'";
    let ternary = "scheme = 'ternary-four-point:mu=w'\nvariable = 'w'\nsmoothness = '2'";
    for (scheme, says, expected) in [
        // Dyn, Gregory and Levin: up to (√5 − 1)/8 = 0.1545… The sharp end is 0.192729249…
        (four_point, "from = '0'\nto = '1/8'", CONFIRMED),
        (four_point, "from = '0'\nto = '(2*cos(pi/5) - 1)/4'", CONFIRMED),
        (four_point, "from = '0'\nto = '0.1927'", CONFIRMED),
        (four_point, "from = '0'\nto = '1/5'", REFUTED),
        (four_point, "from = '-1/1000'\nto = '1/8'", REFUTED),
        (four_point, "from = '0'\nto = '1/8'\nclosed = true", REFUTED),
        (four_point, "from = '1/100'\nto = '1/8'\nclosed = true", CONFIRMED),
        (four_point, "from = '0'", REFUTED),
        (four_point, "from = '0'\nto = '0.1928'", SmoothnessVerdict::RoundedEnds),
        (four_point, "from = '0'\nto = '0.1928'\nclosed = true", REFUTED),
        (four_point, "from = '0'\nto = '0.193'\nonly = true", SmoothnessVerdict::RoundedEnds),
        (four_point, "from = '0'\nto = '0.18'\nonly = true", REFUTED),
        (four_point, "from = '0'\nto = '1/8'\nonly = true", REFUTED),
        (four_point, "from = '0'\nto = '0.1927292492'\nonly = true", OPEN),
        // Hassan, Ivrissimtzis, Dodgson and Sabin: from 1/15 to 1/9, and no further.
        (ternary, "from = '1/15'\nto = '1/9'\nonly = true", CONFIRMED),
        (ternary, "from = '1/15'\nto = '1/9'\nonly = true\nclosed = true", REFUTED),
        (ternary, "from = '1/14'\nto = '1/9'", CONFIRMED),
        (ternary, "from = '1/16'\nto = '1/9'", REFUTED),
        // C^5 needs more sum rules than hold for all w.
        (
            "scheme = 'four-point:w=w'\nvariable = 'w'\nsmoothness = '5'",
            "from = '0'\nto = '1/8'",
            REFUTED,
        ),
    ] {
        let fields = format!("{scheme}\n{says}");
        assert_eq!(verdict("range", &fields), expected, "{fields}");
    }
}

/// The shifts are linearly dependent for all w: (1 + z)(1 + z²)((1 − w) + (1 + w)z)/4.
#[test]
fn ranges_of_dependent_shifts() {
    for (says, expected) in [
        ("from = '-1'\nto = '1'", CONFIRMED),
        ("from = '-1'\nto = '1'\nclosed = true", REFUTED),
        ("from = '-1'\nto = '5/4'", REFUTED),
        ("from = '-1'\nto = '1/2'\nonly = true", REFUTED),
    ] {
        let fields = format!("{DEPENDENT}{says}\n{DEPENDENT_SCHEME}");
        assert_eq!(verdict("range", &fields), expected, "{says}");
    }
}

#[test]
fn a_refuted_range_shows_a_value() {
    let paper = paper(
        "[[range]]\nid = 'c'\nlocus = 'l'\nscheme = 'four-point:w=w'\nvariable = 'w'\nsmoothness = '1'\n\
         from = '0'\nto = '1/5'\n",
    );
    let audit = judged(&paper);
    let KnownLimits::Range(range) = &audit.smoothness[0].known else { panic!("a range") };
    let witness = range.witness.as_ref().expect("a value");
    assert!(witness.inside && witness.at < Rational::new(1, 5));
    assert!(witness.at > Rational::new(1_927, 10_000), "{}", witness.at);
    assert!(witness.at.denominator() <= 1_000.into(), "{}", witness.at);
    let proven = witness.limits.proven().expect("a mask");
    assert_eq!(proven.continuity_fails, Some(1));
}

/// n, as a number of digits after the point.
fn decimal(value: &Rational, places: u32) -> String {
    subcert::exact::format::fixed(value, places)
}

#[test]
fn the_digits_of_an_exponent_decide() {
    for w in ["1/20", "1/12", "1/9", "3/20"] {
        let claim = |printed: &str| format!("scheme = 'four-point:w={w}'\nprinted = '{printed}'");
        let paper = paper(&format!("[[exponent]]\nid = 'c'\nlocus = 'l'\n{}\n", claim("1")));
        let audit = judged(&paper);
        let KnownLimits::Limits(limits) = &audit.smoothness[0].known else { panic!("limits") };
        let hoelder = limits.smoothness.hoelder.as_ref().expect("it converges");
        let exponent = hoelder.formula.as_ref().expect("it is exact");
        for places in [2, 5, 9] {
            let middle = exponent.enclosure(2).lower().clone();
            let unit = Rational::power_of_ten(-i32::try_from(places).expect("few"));
            assert_eq!(verdict("exponent", &claim(&decimal(&middle, places))), CONFIRMED);
            for off in [-2, 2] {
                let other = decimal(&(&middle + &unit * Rational::from(off)), places);
                assert_eq!(verdict("exponent", &claim(&other)), REFUTED, "{w}: {other}");
            }
        }
    }
}

proptest! {
    #![proptest_config(crate::common::cases(64))]

    /// a·log_b(x^e) = a·e·log_b(x), and log_b(xy) = log_b(x) + log_b(y): exactly equal, and no longer if
    /// anything is added. Enclosures agree with f64.
    #[test]
    fn sums_of_logarithms(
        base in 2_u32..9,
        (p, q, e) in (1_i32..50, 1_i32..50, 1_i32..6),
        (c, d) in (1_i32..20, 1_i32..20),
        whole in -9_i32..9,
    ) {
        let whole_number = |x: i32| Rational::from(i64::from(x));
        let of = whole_number(p) / whole_number(q);
        let base_of = base as usize;
        let term = |factor: Rational, of: Rational| LogTerm { factor, base: base_of, of };
        let sum = |terms| LogSum { rational: whole_number(whole), terms };
        let factor = whole_number(c) / whole_number(d);
        let left = sum(vec![term(factor.clone(), of.pow(e))]);
        let right = sum(vec![
            term(&factor * whole_number(e), whole_number(p)),
            term(-(&factor * whole_number(e)), whole_number(q)),
        ]);
        prop_assert_eq!(left.compare(&right), Some(std::cmp::Ordering::Equal));
        let more = right.clone().plus(LogSum::from(Rational::power_of_ten(-40)));
        prop_assert_eq!(left.compare(&more), Some(std::cmp::Ordering::Less));
        let logarithm = (f64::from(p) / f64::from(q)).ln() / f64::from(base).ln();
        let expected = f64::from(whole) + f64::from(c) / f64::from(d) * f64::from(e) * logarithm;
        let enclosure = left.enclosure(0);
        let near = |x: &Rational| (subcert::float::nearest(x) - expected).abs() < 1e-9;
        prop_assert!(near(enclosure.lower()) && near(enclosure.upper()));
    }
}

#[test]
fn regular_vertices_are_twice_differentiable() {
    for (scheme, valence, m, expected) in [
        ("catmull-clark", 4, 2, CONFIRMED),
        ("loop", 6, 2, CONFIRMED),
        ("loop-warren", 6, 2, CONFIRMED),
        // Third derivatives of a cubic spline jump, which is not decided here.
        ("catmull-clark", 4, 3, OPEN),
        ("catmull-clark", 5, 2, REFUTED),
        ("loop", 5, 2, OPEN),
        ("doo-sabin", 4, 2, OPEN),
        // Another weight than that of the box spline.
        ("loop-weight:beta=1/15", 6, 2, OPEN),
    ] {
        let fields = format!("scheme = '{scheme}'\nvalences = '{valence}'\ncontinuous = '{m}'");
        assert_eq!(verdict("smoothness", &fields), expected, "{fields}");
    }
    // The rules of the models are those of the splines.
    for (scheme, weights) in [("catmull-clark:N=4", [9, 16]), ("loop:N=6", [5, 8])] {
        let ring = subcert::scheme::parse_local_rules(scheme).expect("a ring");
        let own = ring.weights().entry(0, 0).as_rational().cloned();
        assert_eq!(own, Some(Rational::new(weights[0], weights[1])));
    }
}
