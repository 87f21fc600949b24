//! T_c and Λ_c of named schemes.

use crate::common::{mask, r};
use subcert::bound::{Constants, Operator, Order, Suprema, joint_norm};
use subcert::exact::{Rational, parse_rational};

fn norms(scheme: &str, operator: Operator, order: Order, count: u32) -> Vec<Rational> {
    let constants = Constants::new(mask(scheme));
    (1..=count).map(|c| constants.norm(operator, c, order).unwrap()).collect()
}

// Computed independently, with fractions in another language.
#[test]
fn values_known_from_elsewhere() {
    let values = |texts: &[&str]| -> Vec<Rational> {
        texts.iter().map(|text| parse_rational(text).unwrap()).collect()
    };
    for (scheme, order, expected) in [
        (
            "quinary-three-point",
            Order::Forward,
            ["0.68", "0.3088", "0.128576", "0.05179648"].as_slice(),
        ),
        ("quinary-three-point", Order::Adjoint, &["0.68", "0.2704", "0.091712", "0.02887936"]),
        ("six-point:w=39/2000", Order::Adjoint, &["0.742", "0.405345"]),
    ] {
        let count = u32::try_from(expected.len()).unwrap();
        assert_eq!(norms(scheme, Operator::Difference, order, count), values(expected), "{scheme}");
    }
    // The four-point scheme: 1/2 + 1/8 and 1 + 2/16·…: first differences and S itself.
    assert_eq!(norms("four-point", Operator::Difference, Order::Adjoint, 1), [r(5, 8)]);
    assert_eq!(norms("four-point", Operator::Scheme, Order::Adjoint, 1), [r(5, 4)]);
}

// The differences of a B-spline scheme are half a B-spline scheme: T_c = 2^−c, Λ_c = 1.
#[test]
fn b_splines() {
    for degree in 1..=7 {
        let constants = Constants::new(mask(&format!("b-spline:degree={degree}")));
        for c in 0..=6 {
            for order in [Order::Adjoint, Order::Forward] {
                let t = constants.norm(Operator::Difference, c, Order::Adjoint).unwrap();
                assert_eq!(t, r(1, 2).pow(c.cast_signed()));
                let lambda = constants.norm(Operator::Scheme, c, Order::Adjoint).unwrap();
                assert_eq!(lambda, Rational::one());
                let tensor = constants.tensor(c, order, Suprema::Independent).unwrap();
                assert_eq!(tensor, constants.norm(Operator::Difference, c, order).unwrap());
            }
        }
    }
}

// A constant is the same when it is asked for again, after others were.
#[test]
fn what_is_kept_is_not_confused() {
    let mask = mask("six-point:w=3/256");
    let shared = Constants::new(mask.clone());
    for _ in 0..2 {
        for c in 0..=4 {
            for order in [Order::Adjoint, Order::Forward] {
                let fresh = Constants::new(mask.clone());
                let t = fresh.norm(Operator::Difference, c, order).unwrap();
                let lambda = fresh.norm(Operator::Scheme, c, order).unwrap();
                let joint = joint_norm(&mask.difference(), mask.rules(), c, order).unwrap().value;
                assert_eq!(shared.tensor(c, order, Suprema::Joint), Ok(joint.clone()));
                assert_eq!(shared.norm(Operator::Scheme, c, order), Ok(lambda.clone()));
                assert_eq!(shared.norm(Operator::Difference, c, order), Ok(t.clone()));
                assert_eq!(shared.tensor(c, order, Suprema::Independent), Ok(&t * &lambda));
                assert!(joint <= t * lambda);
            }
        }
    }
    assert!(shared.norm(Operator::Scheme, 257, Order::Adjoint).is_err());
    assert_eq!(shared.difference(), &mask.difference());
}
