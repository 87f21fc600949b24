//! Where the limits are C^m, in a parameter: inside and outside meet.

use super::known::of;
use subcert::bound::polynomial_rules;
use subcert::exact::{Rational, RationalPolynomial, parse_rational};
use subcert::scheme::{Rules, parse_parametric};
use subcert::smoothness::{SmoothRange, SmoothRangeError, smooth_range};

fn rules(scheme: &str, parameter: &str) -> Rules<RationalPolynomial> {
    let mask = parse_parametric(scheme, parameter).expect("a mask");
    polynomial_rules(mask.rules(), parameter).expect("polynomials")
}

/// The gap over the length of the only interval inside.
fn relative_gap(range: &SmoothRange) -> Rational {
    let [inside] = range.inside.intervals() else { panic!("{}", range.inside) };
    let ends = range.inside.ends().map(|(end, _)| end.bounds().0).collect::<Vec<Rational>>();
    assert!(inside.rational().is_some());
    range.gap.as_ref().expect("bounded") / (&ends[1] - &ends[0])
}

#[test]
fn both_sets_of_the_six_point_scheme_meet() {
    let rules = rules("six-point", "w");
    let most = Rational::new(1, 1000);
    let values = [
        "-0.187", "-1/20", "1/1000", "0.0124", "3/200", "0.01697", "0.017", "1/30", "0.0448",
        "1/10", "3",
    ];
    let single = values.map(|w| {
        let value = parse_rational(w).expect("a number");
        (value, of(&format!("six-point:w={w}")).continuity)
    });
    for m in 0..=3 {
        let range = smooth_range(&rules, m, 1).expect("short rules");
        let gap = relative_gap(&range);
        assert!(gap <= most, "C^{m}: {gap}");
        // What single parameters say agrees.
        for (w, continuity) in &single {
            let smooth = *continuity >= Some(m);
            assert!(smooth || !range.inside.contains(w), "C^{m} at {w}");
            assert!(!smooth || !range.outside.contains(w), "C^{m} at {w}");
        }
    }
}

/// C^1 exactly for −1 < a < 1: the symbol is (1 + z)(1 + z²)((1 − a) + (1 + a)z)/4. Sum rules alone deny nothing here.
#[test]
fn sum_rules_deny_nothing_where_shifts_are_dependent() {
    let text = "[(1-a)/4, 1/2, 1/2, 1/2, (1+a)/4]";
    let found = smooth_range(&rules(text, "a"), 1, 2).unwrap_err();
    assert_eq!(found, SmoothRangeError::Dependent { m: 1, found: 1 });
    let limits = of(&text.replace('a', "1/3"));
    assert_eq!(limits.deciding().is_below(1), Some(true));
    // Where they are independent, sum rules decide.
    let found = smooth_range(&rules("[a, 1/2, 1-a, 1/2]", "a"), 1, 2).unwrap_err();
    assert_eq!(found, SmoothRangeError::SumRules { m: 1, needed: 2, found: 1 });
}
