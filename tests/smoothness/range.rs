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

/// C^1 exactly for −1 < a < 1: the symbol is (1 + z)(1 + z²)((1 − a) + (1 + a)z)/4. And (1 − w + wz²)(1 + z)²/2, whose
/// parts have a common zero that moves with w, for 0 < w < 1.
#[test]
fn shifts_that_are_dependent_for_all_parameters() {
    let one = Rational::one();
    let cases: [(&str, &str, &[[Rational; 2]], &str); 2] = [
        ("[(1-a)/4, 1/2, 1/2, 1/2, (1+a)/4]", "a", &[[one.clone(), one]], "-1"),
        ("[(1-w)/2, 1-w, 1/2, w, w/2]", "w", &[], "0"),
    ];
    for (text, name, reduction, low) in cases {
        let range = smooth_range(&rules(text, name), 1, 2).expect("a reduction");
        assert_eq!(range.reduction, reduction);
        assert_eq!(range.inside.to_string(), format!("({low}, 1)"));
        assert_eq!(range.outside.to_string(), format!("(-inf, {low}] u [1, inf)"));
        for value in ["-3/2", "-1", "-1/2", "0", "1/3", "1", "2"] {
            let smooth = of(&text.replace(name, &format!("({value})"))).continuity >= Some(1);
            let value = parse_rational(value).expect("a number");
            assert_eq!(smooth, range.inside.contains(&value), "{name} = {value}");
        }
    }
    // Of C^2 sum rules decide, as they do where shifts are independent.
    let found = smooth_range(&rules(cases[0].0, "a"), 2, 1).unwrap_err();
    assert_eq!(found, SmoothRangeError::SumRules { m: 2, needed: 3, found: 2, reduced: true });
    let found = smooth_range(&rules("[a, 1/2, 1-a, 1/2]", "a"), 1, 2).unwrap_err();
    assert_eq!(found, SmoothRangeError::SumRules { m: 1, needed: 2, found: 1, reduced: false });
}

/// The four-point scheme times g(z²)/g(z).
#[test]
fn reductions_lead_back() {
    let plain = smooth_range(&rules("four-point", "w"), 1, 2).expect("short rules");
    let numbers = |g: &[i64]| g.iter().copied().map(Rational::from).collect::<Vec<Rational>>();
    let cases: [(&str, &[&[i64]]); 2] = [
        ("[-w, w, 1/2-w, 1/2+w, 1/2+w, 1/2-w, w, -w]", &[&[1, 1]]),
        ("[-w, w, 1/2, 1/2, 0, 0, 1/2, 1/2, w, -w]", &[&[1, 0, 1], &[1, 1]]),
    ];
    for (text, reduction) in cases {
        let range = smooth_range(&rules(text, "w"), 1, 2).expect("short rules");
        assert!(range.reduction.iter().map(Vec::as_slice).eq(reduction.iter().map(|g| numbers(g))));
        assert_eq!((&range.inside, &range.outside), (&plain.inside, &plain.outside));
    }
}

/// (1 + z)²(a + (1 − 2a)z + az²)(1 − z + z²)²/2. The roots ω of 1 + z + z² are a cycle of z ↦ z², and twice they reduce the
/// symbol. At a = 3/4 the limits for the reduced one are C^1, but the scheme converges for 0 < a < 2/3 only, as it has the
/// eigenvalue |A(ω)|/2 = |1 − 3a|.
#[test]
fn a_reduction_by_cycles_says_nothing_of_convergence() {
    let text = "[a/2, 1/2-a, a/2, a, 1-2*a, a, a/2, 1/2-a, a/2]";
    let range = smooth_range(&rules(text, "a"), 1, 1).expect("short rules");
    assert_eq!(range.reduction, vec![vec![Rational::one(); 3]; 2]);
    assert_eq!(range.outside.to_string(), "(-inf, 0] u [2/3, inf)");
    assert!(range.gap <= Some(Rational::new(1, 1000)), "{:?}", range.gap);
    let reduced =
        smooth_range(&rules("[a/2, 1/2, 1-a, 1/2, a/2]", "a"), 1, 1).expect("short rules");
    for (a, converges) in [("1/2", true), ("3/4", false)] {
        let value = parse_rational(a).expect("a number");
        assert!(reduced.inside.contains(&value));
        assert_eq!(range.inside.contains(&value), converges);
        assert_eq!(of(&text.replace('a', a)).continuity >= Some(1), converges);
    }
}
