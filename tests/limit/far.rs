//! Polygons that are far from their limits, and functionals pulled back: against fractions,
//! level by level.

use super::values::{convergent, parameter};
use proptest::prelude::*;
use subcert::exact::Rational;
use subcert::limit::{Functional, Limit, LimitError};

/// The same search with every place computed from level 0.
fn naive(limit: &Limit, level: u32) -> (Rational, Rational) {
    let arity = limit.mask().arity();
    let mut best = (Rational::zero(), Rational::zero());
    for k in 0..=level {
        let place = best.1.clone();
        let digit = |digit: usize| (&place + Rational::from(digit)) / Rational::from(arity);
        let places = (0..arity).map(digit).chain([place.clone()]);
        best = places.map(|t| (limit.error(k, &t).unwrap().norm(), t)).max().unwrap();
    }
    best
}

/// P^∞(t) by shifts and rules, as fractions.
fn pulled_back(limit: &Limit, t: &Rational) -> Functional {
    let arity = Rational::from(limit.mask().arity());
    let floor = |x: &Rational| x.floor().to_i64().unwrap();
    let (whole, mut rest, mut digits) = (floor(t), t - Rational::from(t.floor()), Vec::new());
    while !rest.is_zero() {
        rest *= &arity;
        digits.push(floor(&rest));
        rest -= &Rational::from(rest.floor());
    }
    let zero = limit.at(&Rational::zero()).unwrap();
    let coarser = |f: Functional, digit: &i64| f.shifted(*digit).after(limit.mask().rules());
    digits.iter().rev().fold(zero, coarser).shifted(whole)
}

proptest! {
    #![proptest_config(crate::common::cases(24))]

    #[test]
    fn far_polygons_are_those_of_the_naive_search(limit in convergent(4, 4), level in 0_u32..6) {
        let far = limit.far_polygon(level).unwrap();
        let (distance, parameter) = naive(&limit, level);
        prop_assert_eq!(&far.distance, &distance);
        prop_assert_eq!(&far.parameter, &parameter);
        let error = limit.error(level, &parameter).unwrap();
        prop_assert_eq!(error.norm(), distance);
        prop_assert_eq!(far.polygon, error.extremal_polygon());
    }

    #[test]
    fn integers_pull_back_as_fractions_do(
        (limit, t) in convergent(4, 4).prop_flat_map(|limit| {
            let arity = limit.mask().arity();
            (Just(limit), parameter(arity))
        }),
    ) {
        prop_assert_eq!(limit.at(&t).unwrap(), pulled_back(&limit, &t));
    }
}

#[test]
fn levels_have_a_cap() {
    let limit = super::values::limit(&crate::common::mask("chaikin"));
    assert_eq!(limit.far_polygon(129), Err(LimitError::Level(129)));
}
