//! Exponents of Sobolev, Riesz bounds and peaks that are known exactly, and what has none.

use crate::masks::{outcome, relation_of, values};
use std::time::{Duration, Instant};
use subcert_check::Outcome;

#[test]
fn splines_and_wavelets() {
    values(&[
        ("sobolev(haar)", "1/2"),
        ("sobolev(hat)", "3/2"),
        ("sobolev(two)", "5/2"),
        ("sobolev(cubic)", "7/2"),
        ("sobolev(bell)", "17/2"),
        ("sobolev(ternary)", "3/2"),
        ("sobolev(daubechies)", "1"),
        ("sobolev(scheme = b-spline, degree = 4)", "9/2"),
        ("riesz_lower(hat)", "1/3"),
        ("riesz_upper(hat)", "1"),
        ("riesz_lower(haar)", "1"),
        ("riesz_lower(daubechies)", "1"),
        ("riesz_upper(daubechies)", "1"),
        ("riesz_lower(cubic)", "17/315"),
        ("riesz_upper(cubic)", "1"),
        // The alternating sum of the products, and for irrational masks too.
        (
            "riesz_lower(golden)",
            "inner_product(golden, 0) + 2*sum(k = 1..4, (-1)^k*inner_product(golden, k))",
        ),
        (
            "riesz_lower(four)",
            "inner_product(four, 0) + 2*sum(k = 1..6, (-1)^k*inner_product(four, k))",
        ),
        ("riesz_lower(averaged)", "0"),
        ("overshoot(cubic)", "1"),
        ("gibbs(cubic)", "1"),
        ("overshoot(golden)", "1"),
        // The mask has negative coefficients, and a product of masks has none.
        ("overshoot(mirrored)", "1"),
        ("gibbs(late)", "1"),
    ]);
}

#[test]
fn products_of_functions_in_l2() {
    values(&[
        ("inner_product(haar, 0)", "1"),
        ("inner_product(haar, 1)", "0"),
        ("inner_product(haar, 0, with = hat)", "1/2"),
        ("inner_product(hat, 0, with = haar)", "1/2"),
        ("inner_product(haar, 0, with = cubic)", "11/24"),
        ("riesz_upper(haar)", "1"),
    ]);
}

#[test]
fn independent_and_same() {
    values(&[
        ("independent(haar)", "1"),
        ("independent(four)", "1"),
        ("independent(daubechies)", "1"),
        ("independent(golden)", "1"),
        ("independent(averaged)", "0"),
        ("independent(stretched)", "0"),
        ("same(hat, with = hat)", "1"),
        ("same(hat, with = cubic)", "0"),
        ("same(hat, with = ternary)", "0"),
        ("same(scheme = b-spline, degree = 3, with = cubic)", "1"),
        ("same(scheme = b-spline, with = cubic, degree = 2)", "0"),
        ("sum_rules(scheme = corner-cutting, w = 0)", "1"),
    ]);
    let parameter = |states: &str, of: &str| {
        let fields = format!("states = '{states}'\nfor = '{of}'");
        relation_of(
            "[[scheme]]\nname = 'hat'\nmask = '[1, 2, 1]/2'\n[define]\norder = 'sum_rules(scheme = b-spline, degree = n)'\n",
            &fields,
            &format!("states {states}\n holds 3"),
        )
    };
    // The value of an index of the claim, also in a definition.
    assert_eq!(
        parameter("sum_rules(scheme = b-spline, degree = n) = n + 1", "n = 1..3"),
        Outcome::Valid
    );
    assert_eq!(parameter("order = n + 1", "n = 1..3"), Outcome::Valid);
    for states in [
        "sum_rules(scheme = b-spline, degree = n-1) = n",
        "sum_rules(scheme = b-spline, degree = m) = n + 1",
        "sum_rules(scheme = b-spline, order = n) = n + 1",
        "sum_rules(scheme = b-spline, width = n) = n + 1",
        "sum_rules(scheme = b-spline) = n + 1",
        "sum_rules(hat, degree = n) = 2",
        "sum(k = 1..1, sum_rules(scheme = b-spline, degree = k)) = 2",
    ] {
        assert_ne!(parameter(states, "n = 1..3"), Outcome::Valid, "{states}");
    }
}

#[test]
fn what_is_not_known() {
    for states in [
        "sobolev(averaged) = 3/2",
        "sobolev(stretched) = 1/2",
        "sobolev(long) = 1",
        "sobolev(fine) = 1",
        "overshoot(haar) = 1",
        "gibbs(wild) = 1",
        "riesz_lower(wild) = 1",
        "overshoot(round) = 1",
        "riesz_lower(fine) = 0",
    ] {
        let found = outcome(states, "holds 1");
        assert!(matches!(found, Outcome::Incomplete(_)), "{states}: {found:?}");
    }
    for states in [
        "sobolev(hat, 1) = 3/2",
        "sobolev() = 3/2",
        "overshoot(hat, 0) = 1",
        "gibbs(hat, data = sampled) = 1",
        "riesz_lower(hat, with = hat) = 1/3",
        "same(hat) = 1",
        "independent(hat, 1) = 1",
    ] {
        let found = outcome(states, "holds 1");
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
}

/// Long masks end within the steps of a claim.
#[test]
fn extreme_masks() {
    let start = Instant::now();
    for symbol in [
        "((1+z)^2/(4*z))^12*sum(j=0..11, binomial(11+j,j)*((2-z-1/z)/4)^j)*2",
        "(1+z)*sum(i=0..40, (i+1)*(1-2*mod(i,3))*z^i)/sum(i=0..40, (i+1)*(1-2*mod(i,3)))",
        "(sum(i=0..63,z^i)/64)^2*(-10 + 84*z - 10*z^2)",
        "(1+z)*(1 + 10^3000*z)/(1 + 10^3000)*1",
    ] {
        for formula in ["overshoot()", "gibbs()", "sobolev()", "independent()"] {
            let schemes = format!("[[scheme]]\nname = 's'\nsymbol = '{symbol}'\n");
            let states = format!("{formula} = 7");
            let fields = format!("scheme = 's'\nstates = '{states}'");
            let found = relation_of(&schemes, &fields, &format!("states {states}\n holds 1"));
            assert!(found != Outcome::Valid, "{symbol}");
        }
    }
    assert!(start.elapsed() < Duration::from_secs(90), "{:?}", start.elapsed());
}
