//! Integer polynomials in one variable.

use proptest::prelude::*;
use subcert::exact::{Integer, IntegerPolynomial, Rational};

pub(super) fn polynomial(most: usize) -> impl Strategy<Value = IntegerPolynomial> {
    prop::collection::vec((-9_i64..10).prop_map(Integer::from), 0..=most + 1)
        .prop_map(IntegerPolynomial::new)
}

fn naive_value(polynomial: &IntegerPolynomial, at: &Rational) -> Rational {
    let terms = polynomial.coefficients().iter().zip(0..);
    terms.map(|(c, exponent)| Rational::from(c.clone()) * at.pow(exponent)).sum()
}

fn scaled(polynomial: &IntegerPolynomial, factor: &Integer) -> IntegerPolynomial {
    polynomial * &IntegerPolynomial::new(vec![factor.clone()])
}

proptest! {
    #[test]
    fn evaluation_is_a_homomorphism(
        p in polynomial(6), q in polynomial(6), a in -9_i64..10, b in 1_i64..9,
    ) {
        let at = Rational::new(a, b);
        let (x, y) = (p.value_at(&at), q.value_at(&at));
        prop_assert_eq!(&x, &naive_value(&p, &at));
        prop_assert_eq!(p.sign_at(&at), x.sign());
        prop_assert_eq!((&p + &q).value_at(&at), &x + &y);
        prop_assert_eq!((&p - &q).value_at(&at), &x - &y);
        prop_assert_eq!((&p * &q).value_at(&at), &x * &y);
        prop_assert_eq!((-&p).value_at(&at), -x);
        prop_assert!((&p - &p).is_zero());
    }

    #[test]
    fn leibniz(p in polynomial(6), q in polynomial(6)) {
        let rule = &(&p.derivative() * &q) + &(&p * &q.derivative());
        prop_assert_eq!((&p * &q).derivative(), rule);
    }

    #[test]
    fn division_with_remainder(p in polynomial(9), d in polynomial(5)) {
        prop_assume!(!d.is_zero());
        let (scale, quotient, rest) = p.div_rem(&d);
        prop_assert!(scale.sign() > 0);
        prop_assert_eq!(scaled(&p, &scale), &(&quotient * &d) + &rest);
        prop_assert!(rest.degree().is_none_or(|degree| degree < d.degree().unwrap()));
    }

    #[test]
    fn the_gcd_divides_and_is_divided(
        p in polynomial(4), q in polynomial(4), common in polynomial(3),
    ) {
        let (a, b) = (&p * &common, &q * &common);
        let gcd = a.gcd(&b);
        prop_assert_eq!(&gcd, &gcd.primitive());
        if gcd.is_zero() {
            prop_assert!(a.is_zero() && b.is_zero());
            return Ok(());
        }
        prop_assert!(a.div_rem(&gcd).2.is_zero() && b.div_rem(&gcd).2.is_zero());
        if !common.is_zero() {
            prop_assert!(gcd.div_rem(&common).2.is_zero());
        }
        // What is left has nothing in common any more.
        let (left, right) = (a.div_rem(&gcd).1, b.div_rem(&gcd).1);
        prop_assert_eq!(left.gcd(&right).degree(), Some(0));
    }

    #[test]
    fn square_free_parts(p in polynomial(3), q in polynomial(2)) {
        let product = &(&p * &p) * &q;
        prop_assume!(!product.is_zero());
        let part = product.square_free();
        prop_assert_eq!(part.gcd(&part.derivative()).degree(), Some(0));
        // The same roots: each divides a power of the other.
        let power = (1..8).fold(part.clone(), |power, _| &power * &part);
        prop_assert!(power.div_rem(&product).2.is_zero());
        prop_assert!(product.div_rem(&part).2.is_zero());
    }
}

#[test]
fn forms() {
    let p = IntegerPolynomial::from([0, -1, 0, 12, 0]);
    assert_eq!((p.degree(), p.leading(), p.content()), (Some(3), 12.into(), 1.into()));
    assert_eq!(p.to_string(), "12x^3 - x");
    assert_eq!(IntegerPolynomial::from([-6, 0, -4]).primitive().to_string(), "2x^2 + 3");
    assert_eq!(IntegerPolynomial::default().to_string(), "0");
    assert_eq!(IntegerPolynomial::default().degree(), None);
    let halves = [Rational::new(1, 2), Rational::new(-2, 3), Rational::zero()];
    let cleared = IntegerPolynomial::over_common_denominator(&halves);
    assert_eq!(cleared.to_string(), "-4x + 3");
    // x⁴ + x³ + … over x² + 1, by hand: 2x³ − 3 = (2x)(x² + 1) − 2x − 3.
    let (s, q, r) = IntegerPolynomial::from([-3, 0, 0, 2]).div_rem(&[1, 0, 1].into());
    assert_eq!((s, q.to_string(), r.to_string()), (1.into(), "2x".into(), "-2x - 3".into()));
}
