//! Masks with irrational coefficients.

use subcert::certificate::smoothness_certificate;
use subcert::exact::{Enclosed as _, FieldElement, Rational, Scalar as _, format::fixed};
use subcert::scheme::{Mask, parse_algebraic, parse_scheme};
use subcert::smoothness::Smoothness;
use subcert_check::check_radius;

fn mask(name: &str) -> Mask<FieldElement> {
    parse_algebraic(name).unwrap_or_else(|error| panic!("{name}: {error}"))
}

fn daubechies(length: usize) -> Mask<FieldElement> {
    mask(&format!("examples/daubechies-{length}.toml"))
}

#[test]
fn daubechies_filters() {
    // Daubechies and Lagarias 1992: 2 − log_2(1 + √3), 1.0878 and 1.6179; φ is continuous, C^1 and C^1.
    for (length, exponent, continuity) in [(4, "0.5500", 0), (6, "1.0878", 1), (8, "1.6179", 1)] {
        let smoothness = Smoothness::of(&daubechies(length)).expect("short rules");
        assert_eq!(smoothness.sum_rules, length / 2, "{length}");
        assert_eq!(smoothness.continuity, Some(continuity), "{length}");
        assert_eq!(smoothness.continuity_fails, Some(continuity + 1), "{length}");
        let hoelder = smoothness.hoelder.expect("it converges");
        assert_eq!(fixed(&hoelder.lower, 4), exponent, "{length}");
        assert_eq!(fixed(&hoelder.upper, 4), exponent, "{length}");
        assert!(hoelder.formula.is_some() && hoelder.attained == Some(true), "{length}");
    }
}

#[test]
fn the_exponent_of_d4_is_a_closed_form() {
    let smoothness = Smoothness::of(&daubechies(4)).expect("short rules");
    let formula = smoothness.hoelder.expect("it converges").formula.expect("exact");
    let text = "2 - log_2(x), x = 2.73205080757 the root of x^2 - 2x - 2 from 2 to 3";
    assert_eq!(formula.to_string(), text);
}

#[test]
fn the_order_of_the_coefficients_does_not_matter() {
    // The conjugate of D4, −√3 in place of √3, is the filter in reverse order.
    let reversed = |mask: &Mask<FieldElement>| {
        let rows = mask.rules().rows().iter().rev().map(|row| row.iter().rev().cloned().collect());
        Mask::new(rows.collect(), 0).expect("affine")
    };
    for length in [4, 6] {
        let mask = daubechies(length);
        let [a, b] = [&mask, &reversed(&mask)].map(|mask| {
            let hoelder = Smoothness::of(mask).expect("short rules").hoelder.expect("convergent");
            hoelder.formula.expect("exact").to_string()
        });
        assert_eq!(a, b);
    }
}

/// The same rational mask over the rationals and over a field.
#[test]
fn rational_masks_are_as_smooth_over_a_field() {
    for name in ["chaikin", "four-point:w=1/16", "six-point:w=1/100", "ternary-four-point:mu=1/11"]
    {
        let scheme = parse_scheme(name).expect("a scheme");
        let rational = Smoothness::of(scheme.masks()[0]).expect("short rules");
        let lifted = Smoothness::of(&scheme.masks()[0].map(FieldElement::from_rational));
        let lifted = lifted.expect("short rules");
        let said = |continuity, fails, hoelder: Option<subcert::smoothness::Hoelder>| {
            let hoelder = hoelder.expect("it converges");
            (
                continuity,
                fails,
                hoelder.formula.map(|formula| formula.to_string()),
                hoelder.attained,
            )
        };
        assert_eq!(
            said(rational.continuity, rational.continuity_fails, rational.hoelder),
            said(lifted.continuity, lifted.continuity_fails, lifted.hoelder),
            "{name}"
        );
    }
}

/// At irrational parameters the exponent lies between those at rational ones next to them.
#[test]
fn irrational_parameters_are_between_rational_ones() {
    // √2/32 = 0.0441941738…; a weight in the catalogue's own mask.
    let exponent = |smoothness: Option<subcert::smoothness::Hoelder>| {
        let hoelder = smoothness.expect("it converges");
        (hoelder.lower, hoelder.upper)
    };
    let at = |w: &str| {
        let scheme = parse_scheme(&format!("four-point:w={w}")).expect("a scheme");
        exponent(Smoothness::of(scheme.masks()[0]).expect("short rules").hoelder)
    };
    let (below, above) = (at("0.04419417"), at("0.04419418"));
    let (low, high) =
        exponent(Smoothness::of(&mask("four-point:w=sqrt(2)/32")).expect("short").hoelder);
    let slack = Rational::new(1, 1_000_000);
    assert!(&low - &slack <= below.1.max(above.1.clone()) && below.0.min(above.0) <= high + slack);
}

#[test]
fn dependent_shifts_are_reduced_over_a_field() {
    // z ↦ z⁴ takes e^{2πi/5} to its conjugate, so that the two are the roots of a g over Q(√5), g = z² − 2cos(2π/5)z + 1, and
    // g(z⁴)/g(z) is a polynomial, which Φ_5(z⁴)/Φ_5(z) does not divide. Times the symbol σ²/4 of the hat function of arity 4,
    // it has dependent shifts.
    let number = |x: i64| FieldElement::from_rational(&Rational::from(x));
    let cosine = FieldElement::root(&[number(-1), number(1), number(1)], 2).expect("degree 2");
    let middle = number(0).minus(&cosine);
    // z⁸ − cz⁴ + 1 over z² − cz + 1, from the top.
    let mut rest = vec![FieldElement::zero(); 9];
    (rest[0], rest[4], rest[8]) = (number(1), middle.clone(), number(1));
    let mut quotient = vec![FieldElement::zero(); 7];
    for i in (0..7).rev() {
        let c = rest[i + 2].clone();
        rest[i + 1].lessen(&c.times(&middle));
        rest[i].lessen(&c);
        quotient[i] = c;
    }
    assert!(rest[..2].iter().all(|x| x.sign() == 0));
    let mut symbol = vec![FieldElement::zero(); 16];
    for (i, x) in [1, 2, 3, 4, 3, 2, 1].into_iter().enumerate() {
        for (j, y) in quotient.iter().enumerate() {
            symbol[i + j].accumulate(&y.times(&FieldElement::from_rational(&Rational::new(x, 4))));
        }
    }
    let rule = |alpha: usize| symbol.iter().skip(alpha).step_by(4).rev().cloned().collect();
    let mask = Mask::new((0..4).map(rule).collect(), 0).expect("affine");
    let smoothness = Smoothness::of(&mask).expect("short rules");
    let reduced = smoothness.reduced.expect("dependent shifts");
    // The hat function is left.
    assert_eq!(reduced.symbol.coefficients().len(), 7);
    assert_eq!((smoothness.continuity, smoothness.continuity_fails), (Some(0), Some(1)));
}

#[test]
fn the_checker_accepts_irrational_masks_and_no_false_number() {
    for (length, continuous) in [(4, 0), (6, 1), (8, 1)] {
        let mask = daubechies(length);
        let smoothness = Smoothness::of(&mask).expect("short rules");
        let text = smoothness_certificate(&mask, &smoothness).expect("a radius that is not 0");
        let radius =
            check_radius(&text).unwrap_or_else(|rejection| panic!("{length}: {rejection:?}"));
        assert_eq!(
            (radius.continuous, radius.not_continuous),
            (Some(continuous), Some(continuous + 1))
        );
        let altered = |word: &str, rest: &str| {
            let line = text.lines().find(|line| line.starts_with(word)).expect("a line");
            text.replacen(line, &format!("{word} {rest}"), 1)
        };
        let bound = smoothness.differences.radius.hull.as_ref().expect("a hull").bound.clone();
        let root = smoothness.differences.radius.root.enclosure(0).upper().clone();
        let degree = i32::try_from(smoothness.differences.radius.degree).expect("short");
        // Bounds that are off by the seventh digit only.
        let less = &bound * (Rational::one() - Rational::new(1, 10_000_000));
        let more = root * (Rational::one() + Rational::new(1, 10_000_000)).pow(degree);
        for wrong in [
            altered("at-most", &less.to_string()),
            altered("eigenvalue", &format!("positive {more}")),
            altered("continuous", &(continuous + 1).to_string()),
            altered("not-continuous", &continuous.to_string()),
            altered("between", "-100 100"),
        ] {
            assert!(check_radius(&wrong).is_err(), "{length}:\n{}", &wrong[..wrong.len().min(400)]);
        }
    }
}

#[test]
fn large_fields_of_large_matrices_are_refused() {
    let wide =
        mask("six-point:w=root([-2, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1], 1)/500");
    let error = Smoothness::of(&wide).expect_err("a field of degree 17");
    assert!(error.to_string().contains("over a field of degree 17"), "{error}");
}

#[test]
fn where_no_root_is_found_both_bounds_are_rational() {
    // The norm of a polynomial of degree 4 over a field of degree 17 has degree 68, which is beyond the cap.
    let mask =
        mask("four-point:w=root([-1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, -1, 0, 3], 1)/12");
    let smoothness = Smoothness::of(&mask).expect("short rules");
    assert_eq!((smoothness.continuity, smoothness.continuity_fails), (Some(1), Some(2)));
    let hoelder = smoothness.hoelder.as_ref().expect("it converges");
    assert!(
        hoelder.formula.is_none() && &hoelder.upper - &hoelder.lower < Rational::new(1, 1_000_000)
    );
    let text = smoothness_certificate(&mask, &smoothness).expect("a radius that is not 0");
    let radius = check_radius(&text).expect("a valid certificate");
    assert_eq!((radius.continuous, radius.not_continuous), (Some(1), Some(2)));
}
