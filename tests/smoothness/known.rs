//! Schemes whose smoothness the literature states.

use std::ops::Bound;
use subcert::bound::polynomial_rules;
use subcert::exact::{
    IntegerPolynomial, Rational, RationalPolynomial, RealAlgebraic, format::fixed, parse_rational,
};
use subcert::scheme::{Mask, parse_parametric, parse_scheme};
use subcert::smoothness::{Smoothness, contractions, smooth_range};
use subcert::stop::Stop;

pub fn of(name: &str) -> Smoothness {
    Smoothness::of(parse_scheme(name).expect("a scheme").masks()[0]).expect("short rules")
}

/// The mask with these rules over one denominator.
fn mask(denominator: i64, rules: &[&[i64]]) -> Mask {
    let row = |row: &&[i64]| row.iter().map(|&x| Rational::new(x, denominator)).collect();
    Mask::new(rules.iter().map(row).collect(), 0).expect("an affine mask")
}

/// (the largest m proven, the least m refuted, the formula, whether it is attained).
fn said(smoothness: &Smoothness) -> (Option<usize>, Option<usize>, Option<String>, Option<bool>) {
    let hoelder = smoothness.hoelder.as_ref();
    let formula = hoelder.and_then(|hoelder| hoelder.formula.as_ref()).map(ToString::to_string);
    let attained = hoelder.and_then(|hoelder| hoelder.attained);
    (smoothness.continuity, smoothness.continuity_fails, formula, attained)
}

#[test]
fn b_splines_of_degree_d_are_smooth_of_order_d_minus_1() {
    for degree in 1..=6 {
        let smoothness = of(&format!("b-spline:degree={degree}"));
        let expected = (Some(degree - 1), Some(degree), Some(degree.to_string()), Some(true));
        assert_eq!(said(&smoothness), expected, "degree {degree}");
        assert_eq!((smoothness.sum_rules, smoothness.reproduction), (degree + 1, 1));
    }
}

#[test]
fn interpolating_schemes() {
    // Dubuc 1986, Deslauriers and Dubuc 1989: C^1, and φ' has no Lipschitz constant.
    assert_eq!(said(&of("four-point:w=1/16")), (Some(1), Some(2), Some("2".into()), Some(false)));
    let six = of("six-point:w=3/256");
    assert_eq!(said(&six), (Some(2), Some(3), Some("6 - log_2(9)".into()), Some(true)));
    assert_eq!((six.sum_rules, six.reproduction), (6, 5));
    // Hassan, Ivrissimtzis, Dodgson and Sabin 2002: C^2 for 1/15 < μ < 1/9, in that interval only.
    for (mu, smooth) in
        [("1/15", 1), ("1/14", 2), ("1/11", 2), ("11/100", 2), ("1/9", 1), ("1/8", 1)]
    {
        let smoothness = of(&format!("ternary-four-point:mu={mu}"));
        assert_eq!(smoothness.continuity, Some(smooth), "μ = {mu}");
        assert_eq!(smoothness.continuity_fails, Some(smooth + 1), "μ = {mu}");
    }
    // Hechler, Mößner and Reif 2009: the four-point scheme is C^1 up to the root 0.1927… of 32w³ + 4w = 1.
    for (w, smooth) in [("0.19272", 1), ("0.19274", 0), ("1/1000", 1), ("0", 0), ("-1/100", 0)] {
        assert_eq!(of(&format!("four-point:w={w}")).continuity, Some(smooth), "w = {w}");
    }
}

#[test]
fn schemes_that_diverge() {
    for name in ["four-point:w=-1", "four-point:w=1/2", "four-point:w=3"] {
        let smoothness = of(name);
        assert_eq!((smoothness.continuity, smoothness.continuity_fails), (None, Some(0)), "{name}");
        assert!(smoothness.hoelder.is_none());
    }
}

#[test]
fn dependent_shifts_are_reduced() {
    // (1 + z)(1 + z²)/2: the mean of two neighbouring hat functions.
    let hats = Smoothness::of(&mask(2, &[&[1, 1], &[1, 1]])).expect("short rules");
    assert!(hats.reduced.is_some());
    assert_eq!(said(&hats), (Some(0), Some(1), Some("1".into()), Some(true)));
    // (1 + z)³(1 − z + z²)/4: the mean of three neighbouring quadratic B-splines, through Φ_3.
    let quadratic = Smoothness::of(&mask(4, &[&[2, 1, 1], &[1, 1, 2]]));
    let coefficients = quadratic.expect("short rules");
    let product = RationalPolynomial::new(coefficients.symbol.coefficients()).describe("z");
    assert_eq!(product, "1/4 + 1/2*z + 1/4*z^2 + 1/4*z^3 + 1/2*z^4 + 1/4*z^5");
    assert!(coefficients.reduced.is_some());
    assert_eq!(said(&coefficients), (Some(1), Some(2), Some("2".into()), Some(true)));
}

#[test]
fn contractions_are_those_of_the_definition() {
    // 2·S_2 of the four-point scheme at w = 1/16 contracts in two levels, by 3/4 (Dyn 1992).
    let four = of("four-point:w=1/16");
    let found = contractions(&four.symbol, 1, &Stop::default());
    let expected = [Some((1, Rational::new(5, 8))), Some((2, Rational::new(3, 4)))];
    assert_eq!(found, expected);
}

#[test]
fn exponents_of_the_eight_point_scheme() {
    // Deslauriers and Dubuc, eight points: 3.551 in Daubechies' table of 2N = 8.
    let eight =
        mask(2048, &[&[0, 0, 0, 2048, 0, 0, 0, 0], &[-5, 49, -245, 1225, 1225, -245, 49, -5]]);
    let smoothness = Smoothness::of(&eight).expect("short rules");
    assert_eq!((smoothness.sum_rules, smoothness.reproduction), (8, 7));
    assert_eq!(smoothness.continuity, Some(3));
    let hoelder = smoothness.hoelder.expect("it converges");
    assert_eq!(fixed(&hoelder.lower, 3), "3.551");
    assert_eq!(fixed(&hoelder.upper, 3), "3.551");
}

#[test]
fn the_four_point_scheme_is_c1_up_to_the_root_of_a_cubic() {
    // Dyn, Levin and Gregory 1987, Dyn 1992: c = 2 gives 0 < w < (√5 − 1)/8. Hechler, Mößner and Reif 2009: the
    // exact end is the root of 32w³ + 4w − 1.
    let mask = parse_parametric("four-point", "w").expect("a mask");
    let rules = polynomial_rules(mask.rules(), "w").expect("polynomials");
    let range = smooth_range(&rules, 1, 2).expect("short rules");
    let [interval] = range.contraction.levels[1].intervals() else { panic!("one interval") };
    let golden = RealAlgebraic::roots_of(&IntegerPolynomial::from([-1, 4, 16]));
    assert_eq!(interval.low, Bound::Excluded(Rational::zero().into()));
    assert_eq!(interval.high, Bound::Excluded(golden[1].clone()));
    let cubic = RealAlgebraic::roots_of(&IntegerPolynomial::from([-1, 4, 0, 32]));
    let [below, above] = range.outside.intervals() else { panic!("{}", range.outside) };
    assert_eq!(
        (&below.low, &below.high),
        (&Bound::Unbounded, &Bound::Included(Rational::zero().into()))
    );
    assert_eq!((&above.low, &above.high), (&Bound::Included(cubic[0].clone()), &Bound::Unbounded));
    assert!(range.gap.expect("bounded") <= Rational::new(1, 1000));
    assert!(!range.but_finitely_many);
    // What single parameters say agrees.
    for w in ["1/1000", "1/10", "0.19", "0.1927", "0.1928", "1/5", "0", "-1/7", "-3/4", "-20", "50"]
    {
        let smooth = of(&format!("four-point:w={w}")).continuity >= Some(1);
        let w = parse_rational(w).expect("a number");
        assert!(smooth || !range.inside.contains(&w), "{w}");
        assert!(!smooth || !range.outside.contains(&w), "{w}");
    }
}

#[test]
fn the_ternary_scheme_is_c2_between_two_fractions() {
    let mask = parse_parametric("ternary-four-point", "mu").expect("a mask");
    let rules = polynomial_rules(mask.rules(), "mu").expect("polynomials");
    let range = smooth_range(&rules, 2, 1).expect("short rules");
    assert_eq!(range.outside.describe("mu"), "mu <= 1/15 or mu >= 1/9");
    assert!(range.gap.expect("bounded") <= Rational::new(1, 1000));
    assert!(range.inside.contains(&Rational::new(1, 11)));
    let error = smooth_range(&rules, 3, 1).expect_err("no sum rules");
    assert!(error.to_string().contains("sum rules of order 4"), "{error}");
}

#[test]
fn long_masks() {
    // 31 coefficients, and matrices of 29 rows where no sum rule is divided off. The quotient by the sum rules is not
    // negative on the unit circle, so that the middle coefficient of its iterates is the largest one (Rioul 1992, 4),
    // and grows as the radius.
    let long = of("dubuc-deslauriers:m=8");
    assert_eq!((long.sum_rules, long.continuity, long.continuity_fails), (16, Some(5), Some(6)));
    let mut quotient: Vec<f64> = vec![0.0; 31];
    for i in 0..16_i32 {
        let at = |j: i32| f64::from(2 * j - 15);
        let others = (0..16).filter(|j| *j != i);
        quotient[usize::try_from(2 * i).expect("a place")] =
            others.map(|j| at(j) / (at(j) - at(i))).product();
    }
    quotient[15] = 1.0;
    for _ in 0..16 {
        for k in 1..quotient.len() {
            quotient[k] -= quotient[k - 1];
        }
        for x in &mut quotient {
            *x *= 2.0;
        }
        assert!(quotient.pop().expect("a rest").abs() < 1e-6);
    }
    let mut coefficients = vec![1.0];
    let mut middle = vec![1.0];
    for _ in 0..9 {
        let mut finer = vec![0.0; 2 * coefficients.len() - 1 + quotient.len() - 1];
        for (j, c) in coefficients.iter().enumerate() {
            for (k, q) in quotient.iter().enumerate() {
                finer[2 * j + k] += c * q;
            }
        }
        middle.push(finer[finer.len() / 2]);
        coefficients = finer;
    }
    // Aitken's rule takes off what the second eigenvalue adds.
    let ratios: Vec<f64> = (6..9).map(|k| middle[k + 1] / middle[k]).collect();
    let (last, before) = (ratios[2] - ratios[1], ratios[1] - ratios[0]);
    let ratio = ratios[2] - last * last / (last - before);
    let exponent = 16.0 - ratio.log2();
    let hoelder = long.hoelder.expect("an exponent");
    let [low, high] = [&hoelder.lower, &hoelder.upper].map(subcert::float::nearest);
    assert!(
        (low - exponent).abs() < 1e-3 && (high - exponent).abs() < 1e-3,
        "{low} {exponent} {high}"
    );
}

/// A search that is stopped says less, and nothing else.
#[test]
fn what_is_proven_before_a_search_is_stopped() {
    let stop = Stop::default();
    stop.stop();
    let mut converge = 0;
    for name in ["b-spline:degree=3", "four-point:w=1/16", "six-point:w=3/256", "four-point:w=2"] {
        let scheme = parse_scheme(name).expect("in the catalogue");
        let mask = scheme.masks()[0];
        let found = Smoothness::until(mask, &stop).expect("it is short");
        let whole = Smoothness::of(mask).expect("it is short");
        assert!(found.differences.radius.stopped && !found.differences.radius.exact, "{name}");
        assert!(found.continuity <= whole.continuity, "{name}");
        assert!(
            found
                .continuity_fails
                .is_none_or(|m| whole.continuity_fails.is_some_and(|least| least <= m)),
            "{name}"
        );
        if let (Some(found), Some(whole)) = (found.hoelder, whole.hoelder) {
            assert!(found.lower <= whole.upper && whole.lower <= found.upper, "{name}");
            converge += 1;
        }
    }
    assert!(converge > 0);
}
