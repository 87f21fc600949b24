//! Polynomials in three variables.

use proptest::prelude::*;
use subcert::exact::{Polynomial, Rational, RealCyclotomic};
use subcert::formula::{Parameters, evaluate, parse};

const NAMES: [&str; 3] = ["u", "v", "w"];

/// Coefficient and exponents of each term; terms may coincide and cancel.
type Terms = Vec<(RealCyclotomic, [u32; 3])>;

/// p/q + r·cos(2πs/t), mostly with r = 0.
fn number() -> impl Strategy<Value = RealCyclotomic> {
    (-6_i64..7, 1_i64..5, -4_i64..3, 1_i64..4, 4_i64..8).prop_map(|(p, q, r, s, t)| {
        let cosine = RealCyclotomic::cosine(&Rational::new(s, t)).expect("a small conductor");
        &RealCyclotomic::from(Rational::new(p, q)) + &(&RealCyclotomic::from(r.max(0)) * &cosine)
    })
}

fn terms() -> impl Strategy<Value = Terms> {
    prop::collection::vec((number(), prop::array::uniform3(0_u32..4)), 0..6)
}

fn polynomial(terms: &Terms) -> Polynomial {
    terms.iter().fold(Polynomial::default(), |sum, (coefficient, exponents)| {
        let start = Polynomial::constant(coefficient.clone());
        let powers = NAMES.iter().zip(exponents);
        let variables = powers.flat_map(|(name, &e)| (0..e).map(|_| Polynomial::variable(name)));
        &sum + &variables.fold(start, |product, variable| &product * &variable)
    })
}

fn value(terms: &Terms, at: &[RealCyclotomic; 3]) -> RealCyclotomic {
    let term = |(coefficient, exponents): &(RealCyclotomic, [u32; 3])| {
        let factors = at.iter().zip(exponents).flat_map(|(x, &e)| (0..e).map(move |_| x));
        factors.fold(coefficient.clone(), |product, x| &product * x)
    };
    terms.iter().map(term).fold(RealCyclotomic::from(0), |sum, term| &sum + &term)
}

/// The value of a polynomial: it prints as a formula.
fn printed_value(polynomial: &Polynomial, at: &[RealCyclotomic; 3]) -> RealCyclotomic {
    let formula = parse(&polynomial.to_string()).expect("a polynomial prints as a formula");
    let [u, v, w] = at.clone();
    evaluate(&formula, &Parameters::from([("u", u), ("v", v), ("w", w)])).expect("a value")
}

proptest! {
    #[test]
    fn evaluation_is_a_homomorphism(
        p in terms(), q in terms(), at in prop::array::uniform3(number()),
    ) {
        let (a, b) = (polynomial(&p), polynomial(&q));
        let (x, y) = (value(&p, &at), value(&q, &at));
        prop_assert_eq!(printed_value(&a, &at), x.clone());
        prop_assert_eq!(printed_value(&(&a + &b), &at), &x + &y);
        prop_assert_eq!(printed_value(&(&a - &b), &at), &x - &y);
        prop_assert_eq!(printed_value(&(&a * &b), &at), &x * &y);
    }

    #[test]
    fn ring_laws_hold_in_normal_form(p in terms(), q in terms(), r in terms()) {
        let (a, b, c) = (polynomial(&p), polynomial(&q), polynomial(&r));
        let one = Polynomial::constant(Rational::one());
        prop_assert_eq!(&a + &b, &b + &a);
        prop_assert_eq!(&a * &b, &b * &a);
        prop_assert_eq!(&(&a + &b) + &c, &a + &(&b + &c));
        prop_assert_eq!(&(&a * &b) * &c, &a * &(&b * &c));
        prop_assert_eq!(&a * &(&b + &c), &(&a * &b) + &(&a * &c));
        prop_assert_eq!(&a * &one, a.clone());
        prop_assert_eq!(&(&a - &b) + &b, a.clone());
        prop_assert!((&a - &a).is_zero());
        prop_assert!((&a * &Polynomial::default()).is_zero());
        if !a.is_zero() && !b.is_zero() {
            prop_assert_eq!((&a * &b).degree(), a.degree() + b.degree());
        }
        // Equal exactly when equal as functions: a grid of 4^3 points decides,
        // since every exponent is at most 3.
        let grid = (0..64).map(|i| [i % 4, i / 4 % 4, i / 16].map(RealCyclotomic::from));
        let agree = grid.into_iter().all(|at| value(&p, &at) == value(&q, &at));
        prop_assert_eq!(a == b, agree);
    }
}

#[test]
fn binomial_theorem_and_forms() {
    let (u, w) = (Polynomial::variable("u"), Polynomial::variable("w"));
    let mut power = Polynomial::constant(Rational::one());
    for n in 0..8_usize {
        assert_eq!((power.term_count(), power.degree()), (n + 1, n as u64));
        power = &power * &(&u + &w);
    }
    let half = Polynomial::constant(Rational::new(-1, 2));
    let sum = &(&half * &(&u * &(&w * &w))) + &half;
    assert_eq!(sum.to_string(), "-1/2 - 1/2*u*w^2");
    assert_eq!(sum.as_constant(), None);
    assert_eq!(u.as_constant(), None);
    assert_eq!((&u - &u).as_constant(), Some(RealCyclotomic::from(0)));
    assert_eq!(half.as_constant(), Some(Rational::new(-1, 2).into()));
    assert_eq!((&u - &u).to_string(), "0");
    let cosine = Polynomial::constant(RealCyclotomic::cosine(&Rational::new(2, 5)).unwrap());
    let sum = &(&(&half * &cosine) * &u) + &(&half - &cosine);
    assert_eq!(sum.to_string(), "cos(2*pi/5) + (1/4 + 1/2*cos(2*pi/5))*u");
}
