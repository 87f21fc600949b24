//! Numbers, small and large, against fractions of another library.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::Zero;
use proptest::prelude::*;
use subcert_check::{Outcome, check};

/// A formula with its value.
type Formula = (String, BigRational);

/// Numbers of all sizes, many of them next to the ends of machine integers.
fn number() -> impl Strategy<Value = Formula> {
    let near = |bits: u32| (-3_i128..=3).prop_map(move |off| (1_i128 << bits) + off);
    let integer =
        prop_oneof![-9_i128..=9, near(31), near(32), near(62), near(63), near(64), near(100)];
    let bottom = prop_oneof![1_i128..=9, near(32), near(62), near(63)];
    (integer, any::<bool>(), bottom).prop_map(|(top, negative, bottom)| {
        let top = if negative { -top } else { top };
        let sign = if top < 0 { "-" } else { "" };
        let value = BigRational::new(BigInt::from(top), BigInt::from(bottom));
        (format!("({sign}{}/{bottom})", top.unsigned_abs()), value)
    })
}

fn formula() -> impl Strategy<Value = Formula> {
    number().prop_recursive(4, 16, 2, |inner| {
        (inner.clone(), inner, 0..6).prop_map(|((a, x), (b, y), operator)| match operator {
            0 => (format!("({a} + {b})"), x + y),
            1 => (format!("({a} - {b})"), x - y),
            2 => (format!("({a}*{b})"), x * y),
            3 if !y.is_zero() => (format!("({a}/{b})"), x / y),
            4 => (format!("max({a}, {b})"), x.max(y)),
            _ => (format!("floor({a})"), x.floor()),
        })
    })
}

/// What the checker says of a certificate of an equation.
fn outcome(left: &str, right: &str, verdict: &str) -> Outcome {
    let claims =
        format!("key = \"k\"\n[[equation]]\nid = \"e\"\nleft = '{left}'\nright = '{right}'");
    let certificate = format!(
        "subcert-certificate 4\npaper k\nequation e\n  left {left}\n  right {right}\n  {verdict}\nend 1\n"
    );
    let report = check(&claims, &[&certificate]).expect("a claim file");
    report.claims.into_iter().next().expect("a claim").2
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(512))]

    #[test]
    fn formulas_have_the_values_of_fractions((left, value) in formula(), unit in number()) {
        let right = format!("{}/{}", value.numer(), value.denom()).replace('-', "0-");
        prop_assert_eq!(outcome(&left, &right, "holds 1"), Outcome::Valid);
        // Anything else is another number.
        prop_assume!(!unit.1.is_zero());
        let other = format!("{right} + {}", unit.0);
        let holds = outcome(&left, &other, "holds 1");
        prop_assert!(matches!(holds, Outcome::Invalid(..)), "{:?}", holds);
        let difference = format!("fails 1\n  case = 0 - {}", unit.0);
        prop_assert_eq!(outcome(&left, &other, &difference), Outcome::Valid);
    }

    // The same with a cosine beside them: cos(2π/5) = (√5 − 1)/4 is a root of 4x² + 2x − 1.
    #[test]
    fn numbers_with_cosines_are_a_field((a, x) in number(), (b, y) in number()) {
        let root = "cos(2*pi/5)";
        // (x + yr)(x + y(−1/2 − r)) = x² − xy/2 − y²/4
        let left = format!("({a} + {b}*{root})*({a} - {b}*(1/2 + {root}))");
        let norm = &x * &x - &x * &y / BigInt::from(2) - &y * &y / BigInt::from(4);
        let right = format!("{}/{}", norm.numer(), norm.denom()).replace('-', "0-");
        prop_assert_eq!(outcome(&left, &right, "holds 1"), Outcome::Valid);
        if !norm.is_zero() {
            let quotient = format!("1/({a} + {b}*{root})*({a} + {b}*{root})");
            prop_assert_eq!(outcome(&quotient, "1", "holds 1"), Outcome::Valid);
        }
    }
}
