//! Functions of a parameter at a place: against their values, and one number for an interval.

use proptest::prelude::*;
use std::rc::Rc;
use subcert::exact::{Place, QuotientAt, Rational, RealAlgebraic, Scalar};

/// A formula in x.
#[derive(Clone, Debug)]
enum Formula {
    X,
    Number(i64, i64),
    Sum(Box<Formula>, Box<Formula>),
    Product(Box<Formula>, Box<Formula>),
    Quotient(Box<Formula>, Box<Formula>),
    Size(Box<Formula>),
    Greater(Box<Formula>, Box<Formula>),
}

fn formula() -> impl Strategy<Value = Formula> {
    let leaf = prop_oneof![
        Just(Formula::X),
        (-4_i64..5, 1_i64..4).prop_map(|(p, q)| Formula::Number(p, q)),
    ];
    leaf.prop_recursive(4, 16, 2, |inner| {
        let both = (inner.clone(), inner.clone()).prop_map(|(a, b)| (Box::new(a), Box::new(b)));
        prop_oneof![
            both.clone().prop_map(|(a, b)| Formula::Sum(a, b)),
            both.clone().prop_map(|(a, b)| Formula::Product(a, b)),
            both.clone().prop_map(|(a, b)| Formula::Quotient(a, b)),
            both.prop_map(|(a, b)| Formula::Greater(a, b)),
            inner.prop_map(|a| Formula::Size(Box::new(a))),
        ]
    })
}

/// The value of a formula; `None` where it divides by 0.
fn value<F: subcert::exact::Real + PartialEq>(formula: &Formula, x: &F) -> Option<F> {
    let of = |formula: &Formula| value(formula, x);
    Some(match formula {
        Formula::X => x.clone(),
        Formula::Number(p, q) => F::from_rational(&Rational::new(*p, *q)),
        Formula::Sum(a, b) => of(a)?.plus(&of(b)?),
        Formula::Product(a, b) => of(a)?.times(&of(b)?),
        Formula::Quotient(a, b) => {
            let (a, b) = (of(a)?, of(b)?);
            (b != F::zero()).then(|| a.over(&b))?
        }
        Formula::Size(a) => of(a)?.magnitude(),
        Formula::Greater(a, b) => of(a)?.greater(&of(b)?),
    })
}

proptest! {
    #[test]
    fn values_are_those_of_numbers(formula in formula(), (p, q) in (-9_i64..10, 1_i64..9), (r, s) in (-9_i64..10, 1_i64..9)) {
        let number = Rational::new(p, q);
        let place = Rc::new(Place::new(number.clone().into()));
        let found = value(&formula, &QuotientAt::variable(&place));
        let exact = value(&formula, &number);
        prop_assert_eq!(found.is_some(), exact.is_some());
        let (Some(found), Some(exact)) = (found, exact) else { return Ok(()) };
        // Whether there is a root between this number and another one.
        let asked = place.asked();
        prop_assert!(found == QuotientAt::from_rational(&exact), "{} is no {}", found, exact);
        let other = Rational::new(r, s);
        let (low, high) = if number < other { (&number, &other) } else { (&other, &number) };
        let within = |root: &RealAlgebraic| root.cmp_rational(low).is_ge() && root.cmp_rational(high).is_le();
        if asked.iter().flat_map(RealAlgebraic::roots_of).any(|root| within(&root)) {
            return Ok(());
        }
        let elsewhere = Rc::new(Place::new(other.into()));
        let there = value(&formula, &QuotientAt::variable(&elsewhere)).expect("the same branches");
        prop_assert_eq!(there.to_string(), found.to_string());
    }

    /// The sign of a polynomial at its roots, between them, and beside others.
    #[test]
    fn signs_at_irrational_numbers(a in -5_i64..6, b in -5_i64..6, c in 2_i64..7) {
        let root = &RealAlgebraic::roots_of(&[-c, 0, 1].into())[1];
        // a + b√c
        let size = (a * a).cmp(&(b * b * c));
        let expected = match (a.signum(), b.signum()) {
            (0, sign) | (sign, 0) => sign,
            (x, y) if x == y => x,
            (x, y) => match size {
                std::cmp::Ordering::Greater => x,
                std::cmp::Ordering::Equal => 0,
                std::cmp::Ordering::Less => y,
            },
        };
        prop_assert_eq!(i64::from(root.sign_of(&[a, b].into())), expected);
        prop_assert_eq!(root.sign_of(&[-c * a, -c * b, a, b].into()), 0);
    }
}
