//! The absolute values of symbols on the unit circle, and their extremes.

use crate::masks::{outcome, relation_of, values};
use crate::zeros::{Numbers, float};
use std::f64::consts::PI;
use std::fmt::Write as _;
use subcert_check::{Outcome, Reason, Stop};

#[test]
fn values_on_the_circle() {
    values(&[
        ("modulus(two, 0)", "2"),
        ("modulus(two, 1/2)", "0"),
        ("modulus(two, -7/2)", "0"),
        ("modulus(two, 1/4)", "sqrt(2)/2"),
        ("modulus(two, 1/6)", "3*sqrt(3)/4"),
        ("modulus(two, 1000001/3)", "1/4"),
        ("modulus(two, 1/5)", "2*cos(pi/5)^3"),
        ("modulus(four, 1/4)", "1"),
        ("modulus(haar, 1/7)", "2*cos(pi/7)"),
        ("modulus(haar, 199/400)", "2*cos(199*pi/400)"),
        ("modulus(daubechies, 1/4)", "sqrt(2)"),
        ("modulus(daubechies, 1/3)", "sqrt(10)/4"),
        ("modulus(daubechies, 1/2)", "0"),
        ("modulus(ternary, 1/3)", "0"),
        ("modulus(ternary, 2/5)", "(1 + 2*cos(4*pi/5))^2/3"),
        ("modulus_upper(two)", "2"),
        ("modulus_lower(two)", "0"),
        ("modulus_upper(cubic)", "2"),
        ("modulus_upper(four)", "2"),
        ("modulus_lower(four)", "0"),
        ("modulus_upper(daubechies)", "2"),
        ("modulus_lower(daubechies)", "0"),
        ("modulus_upper(ternary)", "3"),
        ("modulus_lower(ternary)", "0"),
        ("modulus_upper(golden)", "2"),
        // |1 + z|²|2 − z|² = 10 + 2c − 8c², c = 1/8.
        ("modulus_upper(rough)", "9*sqrt(2)/4"),
        ("modulus_lower(rough)", "0"),
        ("modulus_upper(rough)^2", "81/8"),
    ]);
    // What is no number of a field that is known, and equal to one.
    for (states, lines) in [
        ("modulus(later, 1/5)*modulus(later, 1/5) = modulus(later, 4/5)^2", "holds 1"),
        ("modulus(rough, 1/5)^2 = 10 + 2*cos(2*pi/5) - 8*cos(2*pi/5)^2", "holds 1"),
        ("modulus(rough, 1/5) = sqrt(10 + 2*cos(2*pi/5) - 8*cos(2*pi/5)^2)", "holds 1"),
        ("modulus(rough, 1/5) < 3.14", "holds 1"),
        ("modulus(rough, 1/5) > 3.14", "fails 1\n case in -1 0"),
        ("modulus_lower(two) <= modulus(two, 1/5) <= modulus_upper(two)", "holds 2"),
    ] {
        assert_eq!(outcome(states, lines), Outcome::Valid, "{states}");
    }
}

/// What the certificate may not say, and what has no value.
#[test]
fn forged_moduli() {
    for (states, lines) in [
        ("modulus(two, 1/4) = sqrt(2)", "holds 1"),
        ("modulus(two, 1/4) = -sqrt(2)/2", "holds 1"),
        ("modulus(two, 1/4) = sqrt(2)/2", "fails 1\n case = 0"),
        ("modulus(two, 1/4) = 1", "fails 1\n case = 1"),
        ("modulus(two, 1/4) = 1", "fails 1"),
        ("modulus(rough, 1/5) < 3.14", "fails 1\n case in -1 1"),
        ("modulus(rough, 1/5) > 3.14", "fails 1\n case in 0 1"),
        ("modulus(rough, 1/5) > 3.14", "holds 1"),
        ("modulus(rough, 1/5)^2 = 10", "holds 1"),
        ("modulus_upper(rough) = 3", "holds 1"),
        ("modulus_upper(rough) = 9*sqrt(2)/4 + 1/10^40", "holds 1"),
        ("modulus_upper(rough) = modulus(rough, 1/5)", "holds 1"),
        ("modulus_upper(rough) < 3.18", "holds 1"),
        ("modulus_lower(rough) > 0", "holds 1"),
        ("modulus_upper(two) = 1.99", "holds 1"),
        ("hurwitz(two) = 0", "holds 1"),
        ("hurwitz(averaged)", "holds 1"),
        ("not hurwitz(cubic)", "holds 1"),
        ("keeps_ratios(hat, 1, 2) = 0", "holds 1"),
        ("keeps_ratios(cutting, 1, 1)", "holds 1"),
        ("vanishing_moments(two) = 1", "holds 1"),
        // What is asked wrongly.
        ("modulus(two) = 0", "holds 1"),
        ("modulus(two, 0, 0) = 2", "holds 1"),
        ("modulus(two, sqrt(2)) >= 0", "holds 1"),
        ("modulus_upper(two, 1) = 2", "holds 1"),
        ("hurwitz(two, 1) = 1", "holds 1"),
        ("hurwitz(two, order = forward) = 1", "holds 1"),
        ("vanishing_moments(two, 1) = 0", "holds 1"),
        ("keeps_ratios(hat, 1) = 1", "holds 1"),
        ("keeps_ratios(hat, 1, 2, 3) = 1", "holds 1"),
        ("keeps_ratios(hat, -1, 2) = 1", "holds 1"),
        ("keeps_ratios(hat, 9, 2) = 1", "holds 1"),
        ("keeps_ratios(hat, 1/2, 2) = 1", "holds 1"),
        ("keeps_ratios(hat, 1, 1/2) >= 0", "holds 1"),
        ("keeps_ratios(hat, 1, 0) >= 0", "holds 1"),
        ("keeps_ratios(hat, 1, -1) >= 0", "holds 1"),
        ("keeps_ratios(hat, 3, 2) >= 0", "holds 1"),
        ("keeps_ratios(haar, 2, 2) >= 0", "holds 1"),
    ] {
        let found = outcome(states, lines);
        assert!(matches!(found, Outcome::Invalid(..)), "{states}: {found:?}");
    }
    for states in [
        "modulus(two, 1/1001) >= 0",
        "modulus(two, 10^7) >= 0",
        "keeps_ratios(hat, 10^7, 2) = 1",
        // The extremes between −1 and 1 of what has irrational coefficients.
        "modulus_upper(round) >= 1",
    ] {
        let found = outcome(states, "holds 1");
        let Outcome::Incomplete(Some(rejection)) = &found else {
            assert_eq!((states, found), ("modulus(two, 10^7) >= 0", Outcome::Valid));
            continue;
        };
        assert!(matches!(rejection.reason, Reason::Stopped(Stop::Capped(_))), "{states}");
    }
}

/// Extremes of random symbols between those at many points, and a little beyond.
#[test]
fn random_extremes() {
    let mut numbers = Numbers(7);
    for _ in 0..25 {
        let q: Vec<i64> = (0..2 + numbers.around(3).abs()).map(|_| numbers.around(4)).collect();
        let total: i64 = q.iter().sum();
        if total == 0 {
            continue;
        }
        let mut text = String::from("0");
        for (k, c) in q.iter().enumerate() {
            let _ = write!(text, " + ({c})*z^{k}");
        }
        let scheme = format!("[[scheme]]\nname = 's'\nsymbol = '(1 + z)*({text})/({total})'\n");
        let at = |t: f64| {
            let (mut re, mut im) = (0.0, 0.0);
            for (k, c) in (0_i64..).zip(&q) {
                re += float(*c) * (t * float(k)).cos();
                im += float(*c) * (t * float(k)).sin();
            }
            2.0 * (t / 2.0).cos().abs() * re.hypot(im) / float(total).abs()
        };
        let all: Vec<f64> = (0..=20_000).map(|k| at(PI * float(k) / 20_000.0)).collect();
        let least = all.iter().copied().fold(f64::INFINITY, f64::min);
        let most = all.iter().copied().fold(0.0, f64::max);
        for (states, holds) in [
            (format!("modulus_upper(s) in [{:.9}, {:.6}]", most - 1e-8, most + 1e-5), true),
            (format!("modulus_lower(s) in [{:.9}, {:.9}]", -1e-9, least + 1e-8), true),
            (format!("modulus_upper(s) in [{:.6}, {:.6}]", most + 1e-5, most + 1.0), false),
            (format!("modulus_upper(s) in [{:.6}, {:.6}]", -1.0, most - 1e-5), false),
            (
                format!(
                    "modulus(s, 1/5) in [{:.9}, {:.9}]",
                    at(0.4 * PI) - 1e-8,
                    at(0.4 * PI) + 1e-8
                ),
                true,
            ),
        ] {
            let lines = format!("states {states}\n holds 2");
            let found = relation_of(&scheme, &format!("states = '{states}'"), &lines);
            assert_eq!(found == Outcome::Valid, holds, "{text}: {states}: {found:?}");
        }
    }
}
