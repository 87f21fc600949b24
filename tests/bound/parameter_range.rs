//! Norms as functions of a parameter against their values at single parameters.

use crate::common::r;
use proptest::prelude::*;
use subcert::bound::{
    Order, ParameterRange, RangeError, norm_below, norm_function, polynomial_rules, power_norm,
};
use subcert::exact::{
    IntegerPolynomial, IntervalSet, Rational, RationalPolynomial, RealAlgebraic, format::fixed,
};
use subcert::scheme::{Rules, parse_parametric};

const ORDERS: [Order; 2] = [Order::Adjoint, Order::Forward];

/// Rules whose coefficients are polynomials of at most this degree.
fn rules(degree: usize) -> impl Strategy<Value = Rules<RationalPolynomial>> {
    let entry = prop::collection::vec((-5_i64..6, 1_i64..5).prop_map(|(p, q)| r(p, q)), degree + 1);
    (2_usize..4, 1_usize..4).prop_flat_map(move |(arity, width)| {
        let entry = entry.clone().prop_map(|c| RationalPolynomial::new(&c));
        let rows = prop::collection::vec(prop::collection::vec(entry, width), arity);
        rows.prop_map(|rows| Rules::new(rows, 0).expect("rules"))
    })
}

/// The norm at one parameter, by the walk on integers.
fn at(rules: &Rules<RationalPolynomial>, x: &Rational, levels: u32, order: Order) -> Rational {
    power_norm(&rules.map(|entry| entry.value_at(x)), levels, order).expect("few rows").value
}

/// Rationals within 2^−40 of the ends, on both sides of each.
fn beside_ends(set: &IntervalSet) -> Vec<Rational> {
    let tiny = Rational::new(1, 1_i64 << 40);
    let beside = |place: &RealAlgebraic| {
        let unit = &tiny / Rational::from(4);
        let digits = subcert::exact::Enclosed::enclosure(place, 1);
        [digits.lower() - &unit, digits.upper() + unit]
    };
    set.ends().flat_map(|(place, _)| beside(place)).collect()
}

fn samples(more: Vec<Rational>) -> Vec<Rational> {
    (-12..13).map(|p| r(p, 7)).chain(more).collect()
}

proptest! {
    #![proptest_config(crate::common::cases(60))]

    /// The set, and the function, at many parameters and beside each end.
    #[test]
    fn against_single_parameters(
        rules in prop_oneof![3 => rules(1), 1 => rules(2)], levels in 1_u32..4,
        forward in any::<bool>(), limit in (1_i64..7, 1_i64..3).prop_map(|(p, q)| r(p, q)),
    ) {
        let order = ORDERS[usize::from(forward)];
        let set = norm_below(&rules, levels, order, &limit).expect("within the caps");
        for x in samples(beside_ends(&set)) {
            let value = at(&rules, &x, levels, order);
            prop_assert_eq!(set.contains(&x), value < limit, "{} at {}: {}", set, x, value);
        }
        let function = norm_function(&rules, levels, order).expect("within the caps");
        let breaks = function.breakpoints().iter().flat_map(|b| <[Rational; 2]>::from(b.bounds()));
        for x in samples(breaks.collect()) {
            prop_assert_eq!(function.at(&x), at(&rules, &x, levels, order), "at {}", x);
        }
        prop_assert_eq!(function.below(&limit), set);
    }

    /// T_{cd} ≤ T_c^d; the ends are roots of their minimal polynomials, which have no
    /// other root near.
    #[test]
    fn sets_grow_with_multiples(rules in rules(1)) {
        let range = ParameterRange::new(&rules, 4).expect("within the caps");
        for (small, large) in [(1, 2), (1, 3), (1, 4), (2, 4)] {
            let (small, large) = (&range.levels[small - 1], &range.levels[large - 1]);
            prop_assert_eq!(&small.union(large), large);
        }
        for set in &range.levels {
            prop_assert_eq!(&set.union(&range.union), &range.union);
            prop_assert!(set.ends().all(|(_, belongs)| !belongs));
            for (end, _) in set.ends() {
                let minimal = end.minimal_polynomial().expect("few factors");
                let (low, high) = end.bounds();
                let roots = RealAlgebraic::roots_between(&minimal, Some(low), Some(high));
                prop_assert_eq!(&roots[..], std::slice::from_ref(end));
                prop_assert_eq!(minimal.irreducible_factors(), Some(vec![minimal.clone()]));
            }
        }
    }
}

fn range(scheme: &str, parameter: &str, levels: u32) -> ParameterRange {
    let mask = parse_parametric(scheme, parameter).expect("a mask");
    let rules = polynomial_rules(&mask.difference(), parameter).expect("polynomials");
    ParameterRange::new(&rules, levels).expect("within the caps")
}

/// Dyn, Gregory and Levin 1987 show that their 4-point scheme has a continuous limit
/// for −3/8 < w < (−1 + √13)/8, by two levels.
#[test]
fn the_four_point_scheme() {
    let range = range("four-point", "w", 6);
    assert_eq!(range.levels[0].describe("w"), "-1/4 < w < 1/4");
    let ends: Vec<&RealAlgebraic> = range.levels[1].ends().map(|(end, _)| end).collect();
    assert_eq!(*ends[0], RealAlgebraic::from(r(-3, 8)));
    // 8w + 1 = √13.
    assert_eq!(ends[1].minimal_polynomial(), Some(IntegerPolynomial::from([-3, 4, 16])));
    assert_eq!(fixed(ends[1], 6), "0.325694");
    // For w = 1/2 the scheme does not converge.
    for set in &range.levels {
        assert!(!set.contains(&r(1, 2)) && !set.contains(&r(-1, 2)) && set.contains(&r(1, 16)));
    }
    assert!(range.levels[5].contains(&r(43, 100)) && !range.levels[4].contains(&r(43, 100)));
}

/// δ of the ternary 3-point scheme is max{2|a − 1/3| + |2a − 1|, 2|a − 1/3| + …}: by
/// hand 1/6 < a < 2/3.
#[test]
fn other_schemes() {
    assert_eq!(range("ternary-three-point", "a", 1).union.describe("a"), "1/6 < a < 2/3");
    assert_eq!(range("six-point", "w", 1).union.describe("w"), "-5/48 < w < 1/16");
    // Another parameter given as a formula of the free one.
    let halved = range("four-point:w=v/2", "v", 1);
    assert_eq!(halved.union.describe("v"), "-1/2 < v < 1/2");
    // A norm that is at most 1 everywhere, and one that is nowhere below.
    let half = RationalPolynomial::constant(r(1, 2));
    let x = RationalPolynomial::variable();
    let both = |a: &RationalPolynomial, b: &RationalPolynomial| {
        Rules::new(vec![vec![a.clone()], vec![b.clone()]], 0).expect("rules")
    };
    let everywhere = norm_below(&both(&half, &half), 3, Order::Adjoint, &Rational::one());
    assert_eq!(everywhere, Ok(IntervalSet::everything()));
    let shifted = x.plus(&RationalPolynomial::constant(Rational::from(2)));
    let nowhere = norm_below(&both(&x, &shifted), 1, Order::Adjoint, &Rational::one());
    assert_eq!(nowhere, Ok(IntervalSet::default()));
}

#[test]
fn caps() {
    let mask = parse_parametric("six-point", "w").expect("a mask");
    let rules = polynomial_rules(&mask.difference(), "w").expect("polynomials");
    let error = ParameterRange::new(&rules, 10).expect_err("1024 rows of degree 10");
    assert_eq!(error, RangeError::Work { arity: 2, levels: 10, width: 6, degree: 10 });
    assert!(norm_function(&rules, 63, Order::Adjoint).is_err());
}
