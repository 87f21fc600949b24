//! Piecewise polynomial functions against their values at points.

use proptest::prelude::*;
use std::ops::Bound;
use subcert::bound::{Order, Terms, displacement, power_norm, power_norm_generic};
use subcert::exact::{
    Interval, IntervalSet, Parametric, PiecewisePolynomial, Rational, RationalPolynomial, Real,
    RealAlgebraic, Scalar,
};
use subcert::scheme::find;

fn q(p: i64, q: i64) -> Rational {
    Rational::new(p, q)
}

fn rational() -> impl Strategy<Value = Rational> {
    (-6_i64..7, 1_i64..5).prop_map(|(p, q)| Rational::new(p, q))
}

/// A formula in x.
#[derive(Clone, Debug)]
enum Tree {
    Constant(Rational),
    Variable,
    Plus(Box<Tree>, Box<Tree>),
    Minus(Box<Tree>, Box<Tree>),
    Scaled(Rational, Box<Tree>),
    Times(Box<Tree>, Box<Tree>),
    Magnitude(Box<Tree>),
    Greater(Box<Tree>, Box<Tree>),
    Lesser(Box<Tree>, Box<Tree>),
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![rational().prop_map(Tree::Constant), Just(Tree::Variable)];
    leaf.prop_recursive(4, 12, 2, |inner| {
        let pair = (inner.clone(), inner.clone()).prop_map(|(l, r)| (Box::new(l), Box::new(r)));
        prop_oneof![
            pair.clone().prop_map(|(l, r)| Tree::Plus(l, r)),
            pair.clone().prop_map(|(l, r)| Tree::Minus(l, r)),
            (rational(), inner.clone()).prop_map(|(c, t)| Tree::Scaled(c, Box::new(t))),
            pair.clone().prop_map(|(l, r)| Tree::Times(l, r)),
            inner.prop_map(|t| Tree::Magnitude(Box::new(t))),
            pair.clone().prop_map(|(l, r)| Tree::Greater(l, r)),
            pair.prop_map(|(l, r)| Tree::Lesser(l, r)),
        ]
    })
}

fn function(tree: &Tree) -> PiecewisePolynomial {
    match tree {
        Tree::Constant(value) => PiecewisePolynomial::constant(value.clone()),
        Tree::Variable => PiecewisePolynomial::variable(),
        Tree::Plus(l, r) => function(l).plus(&function(r)),
        Tree::Minus(l, r) => function(l).minus(&function(r)),
        Tree::Scaled(factor, t) => function(t).scaled(factor),
        Tree::Times(l, r) => function(l).times(&function(r)),
        Tree::Magnitude(t) => function(t).magnitude(),
        Tree::Greater(l, r) => function(l).greater(&function(r)),
        Tree::Lesser(l, r) => function(l).lesser(&function(r)),
    }
}

fn value(tree: &Tree, x: &Rational) -> Rational {
    match tree {
        Tree::Constant(value) => value.clone(),
        Tree::Variable => x.clone(),
        Tree::Plus(l, r) => value(l, x) + value(r, x),
        Tree::Minus(l, r) => value(l, x) - value(r, x),
        Tree::Scaled(factor, t) => factor * value(t, x),
        Tree::Times(l, r) => value(l, x) * value(r, x),
        Tree::Magnitude(t) => value(t, x).abs(),
        Tree::Greater(l, r) => value(l, x).max(value(r, x)),
        Tree::Lesser(l, r) => value(l, x).min(value(r, x)),
    }
}

/// The breaks of the functions, points between and beyond them, and the points
/// given.
fn points(functions: &[&PiecewisePolynomial], more: &[Rational]) -> Vec<Rational> {
    let mut points: Vec<Rational> = more.to_vec();
    points.extend(functions.iter().flat_map(|f| f.breakpoints()).flat_map(beside));
    let tiny = q(1, 1_000_003);
    let near: Vec<Rational> =
        points.iter().flat_map(|point| [point - &tiny, point + &tiny]).collect();
    points.extend(near);
    points.sort();
    let between: Vec<Rational> =
        points.windows(2).map(|pair| (&pair[0] + &pair[1]) / Rational::from(2)).collect();
    points.extend(between);
    points.extend([q(-1_000_000, 1), q(1_000_000, 1)]);
    points
}

/// Rational points around a number, as near as its first enclosure, and itself where
/// it is rational.
fn beside(place: &RealAlgebraic) -> Vec<Rational> {
    let (low, high) = place.bounds();
    let tiny = q(1, 1_000_003);
    vec![&low - &tiny, low, high.clone(), high + tiny]
}

/// Points at and beside the ends of the intervals.
fn ends(set: &IntervalSet) -> Vec<Rational> {
    set.ends().flat_map(|(place, _)| beside(place)).collect()
}

proptest! {
    #[test]
    fn operations_are_those_at_every_point(
        tree in tree(), at in prop::collection::vec(rational(), 8),
    ) {
        let function = function(&tree);
        for x in points(&[&function], &at) {
            prop_assert_eq!(function.at(&x), value(&tree, &x), "at {}", x);
        }
    }

    /// The breaks are where one polynomial becomes another, and they agree there.
    #[test]
    fn the_form_is_normal(tree in tree()) {
        let function = function(&tree);
        let breaks = function.breakpoints();
        prop_assert!(breaks.windows(2).all(|pair| pair[0] < pair[1]));
        prop_assert_eq!(function.pieces().len(), breaks.len() + 1);
        for (pair, place) in function.pieces().windows(2).zip(breaks) {
            prop_assert_ne!(&pair[0], &pair[1]);
            let difference = pair[0].minus(&pair[1]);
            prop_assert!(RealAlgebraic::roots_of(difference.numerator()).contains(place));
        }
    }

    #[test]
    fn laws_hold_as_equality_of_functions(a in tree(), b in tree(), c in tree(), k in rational()) {
        let (f, g, h) = (function(&a), function(&b), function(&c));
        let zero = PiecewisePolynomial::constant(Rational::zero());
        prop_assert_eq!(f.plus(&g), g.plus(&f));
        prop_assert_eq!(f.plus(&g).plus(&h), f.plus(&g.plus(&h)));
        prop_assert_eq!(f.minus(&g).plus(&g), f.clone());
        prop_assert_eq!(f.minus(&f), zero.clone());
        prop_assert_eq!(f.plus(&g).scaled(&k), f.scaled(&k).plus(&g.scaled(&k)));
        prop_assert_eq!(f.greater(&g), g.greater(&f));
        prop_assert_eq!(f.greater(&g).greater(&h), f.greater(&g.greater(&h)));
        prop_assert_eq!(f.greater(&g).plus(&h), f.plus(&h).greater(&g.plus(&h)));
        prop_assert_eq!(f.greater(&g).plus(&f.lesser(&g)), f.plus(&g));
        prop_assert_eq!(f.greater(&f.lesser(&g)), f.clone());
        prop_assert_eq!(f.magnitude().magnitude(), f.magnitude());
        prop_assert_eq!(f.scaled(&k).magnitude(), f.magnitude().scaled(&k.abs()));
        prop_assert_eq!(f.magnitude().minus(&f).lesser(&zero), zero);
        prop_assert_eq!(f == g, f.differs(&g).is_empty());
    }

    #[test]
    fn level_sets_against_sampling(
        a in tree(), b in tree(), bound in rational(), at in prop::collection::vec(rational(), 8),
    ) {
        let (f, g) = (function(&a), function(&b));
        let sets = [f.below(&bound), f.at_most(&bound), f.exceeds(&g), f.differs(&g)];
        for (i, set) in sets.iter().enumerate() {
            let mut at = at.clone();
            at.extend(ends(set));
            for x in points(&[&f, &g], &at) {
                let (f, g) = (value(&a, &x), value(&b, &x));
                let inside = [f < bound, f <= bound, f > g, f != g][i];
                prop_assert_eq!(set.contains(&x), inside, "set {} = {} at {}", i, set, x);
            }
            // Two neighbours are not one interval.
            let apart = set.intervals().windows(2).all(|pair| match (&pair[0].high, &pair[1].low) {
                (Bound::Excluded(end), Bound::Excluded(start)) => end <= start,
                (Bound::Included(end), Bound::Included(start) | Bound::Excluded(start))
                | (Bound::Excluded(end), Bound::Included(start)) => end < start,
                _ => false,
            });
            prop_assert!(apart, "{}", set);
        }
    }

    /// Unions and intersections against membership.
    #[test]
    fn sets_are_combined(a in tree(), b in tree(), at in prop::collection::vec(rational(), 8)) {
        let zero = Rational::zero();
        let (one, other) = (function(&a).at_most(&zero), function(&b).below(&zero));
        let (union, both) = (one.union(&other), one.intersection(&other));
        for x in at.into_iter().chain(ends(&one)).chain(ends(&other)) {
            let (left, right) = (one.contains(&x), other.contains(&x));
            prop_assert_eq!(union.contains(&x), left || right, "{} u {} at {}", one, other, x);
            prop_assert_eq!(both.contains(&x), left && right, "{} n {} at {}", one, other, x);
        }
        prop_assert_eq!(one.union(&other), other.union(&one));
        prop_assert_eq!(one.intersection(&union), one.clone());
        prop_assert_eq!(one.union(&both), one.clone());
        if let Some((low, high)) = other.hull() {
            prop_assert!(!other.contains(&low) && !other.contains(&high));
        }
        for interval in both.intervals() {
            let inside = interval.rational();
            prop_assert!(inside.is_none_or(|x| both.contains(&x)));
        }
    }

    /// Σ|p_j| in one pass and term by term.
    #[test]
    fn sums_of_magnitudes(polynomials in prop::collection::vec(
        prop::collection::vec(rational(), 0..4), 0..5,
    )) {
        let polynomials: Vec<RationalPolynomial> =
            polynomials.iter().map(|c| RationalPolynomial::new(c)).collect();
        let naive = polynomials.iter().fold(constant(0, 1), |sum, p| {
            sum.plus(&PiecewisePolynomial::from(p.clone()).magnitude())
        });
        prop_assert_eq!(PiecewisePolynomial::sum_of_magnitudes(&polynomials), naive);
    }
}

fn x() -> PiecewisePolynomial {
    PiecewisePolynomial::variable()
}

fn constant(p: i64, q: i64) -> PiecewisePolynomial {
    PiecewisePolynomial::constant(Rational::new(p, q))
}

#[test]
fn hand_made_facts() {
    let tent = constant(1, 1).minus(&x().magnitude()).greater(&constant(0, 1));
    assert_eq!(tent.breakpoints(), [-1, 0, 1].map(|x| RealAlgebraic::from(q(x, 1))));
    assert_eq!(
        tent.describe("w"),
        "0 for w <= -1, 1 + w for -1 <= w <= 0, 1 - w for 0 <= w <= 1, 0 for w >= 1"
    );
    assert_eq!(tent.at_most(&q(0, 1)).to_string(), "(-inf, -1] u [1, inf)");
    assert_eq!(tent.below(&q(1, 2)).to_string(), "(-inf, -1/2) u (1/2, inf)");
    assert_eq!(tent.below(&q(1, 1)).describe("w"), "w < 0 or w > 0");
    assert_eq!(tent.below(&q(0, 1)).to_string(), "{}");
    assert_eq!(tent.below(&q(0, 1)).describe("w"), "no w");
    assert_eq!(tent.below(&q(2, 1)).describe("w"), "every w");
    assert_eq!(x().magnitude().at_most(&q(0, 1)).describe("w"), "w = 0");
    assert_eq!(x().differs(&x().magnitude()).to_string(), "(-inf, 0)");
    // |x| + x and its mirror image: nowhere have both a slope.
    let right = x().magnitude().plus(&x());
    let left = x().magnitude().minus(&x());
    assert_eq!(right.times(&left), constant(0, 1));
    assert_eq!(x().times(&constant(-2, 3)), x().scaled(&q(-2, 3)));
    // |x² − 2| has its breaks at ±√2, and is at most 1 from 1 to √3.
    let square = x().times(&x()).minus(&constant(2, 1)).magnitude();
    assert_eq!(square.piece_count(), 3);
    let one = q(1, 1);
    let set = square.at_most(&one);
    assert!(set.contains(&one) && set.contains(&q(-173_205_080, 100_000_000)));
    assert!(!set.contains(&q(173_205_081, 100_000_000)));
    // x² touches 0: that is no interval of its own.
    assert_eq!(x().times(&x()).exceeds(&constant(0, 1)).describe("w"), "w < 0 or w > 0");
    assert_eq!(x().times(&x()).at_most(&q(0, 1)).describe("w"), "w = 0");
    // max(|x|, 1) − |x| − … breaks that cancel are gone.
    assert_eq!(x().magnitude().minus(&x().magnitude()).piece_count(), 1);
    assert_eq!(x().greater(&x().scaled(&q(-1, 1))), x().magnitude());
    assert_eq!(x().as_constant(), None);
    assert_eq!(constant(3, 4).as_constant(), Some(q(3, 4)));
}

#[test]
fn intervals_cover_intervals() {
    let interval = |low, high| Interval { low, high };
    let (in_0, ex_0) = (Bound::Included(q(0, 1).into()), Bound::Excluded(q(0, 1).into()));
    let (in_1, ex_1) = (Bound::Included(q(1, 1).into()), Bound::Excluded(q(1, 1).into()));
    let closed = interval(in_0.clone(), in_1.clone());
    let open = interval(ex_0.clone(), ex_1.clone());
    let half = interval(ex_0, Bound::Unbounded);
    assert!(closed.covers(&open) && !open.covers(&closed) && open.covers(&open));
    assert!(half.covers(&open) && !half.covers(&closed) && !open.covers(&half));
    assert!(!interval(in_0, ex_1).covers(&interval(Bound::Unbounded, in_1)));
}

#[test]
fn what_is_outside_the_class_stays_outside() {
    let x = Parametric::variable();
    let one = Parametric::from_rational(&Rational::one());
    let quotient = one.over(&x);
    let high = (0..7).fold(x.clone(), |power, _| power.times(&power));
    for poisoned in [
        quotient.clone(),
        quotient.minus(&quotient),
        one.plus(&quotient).times(&Parametric::zero()),
        quotient.magnitude(),
        quotient.greater(&one),
        one.lesser(&quotient),
        Parametric::total(&[one.clone(), quotient.clone()]),
    ] {
        assert!(poisoned.function().is_none(), "{poisoned}");
        assert_ne!(poisoned, poisoned.clone());
        assert_eq!(poisoned.to_string(), "a function that is not piecewise polynomial");
    }
    assert!(high.function().is_none());
    assert_eq!(high.to_string(), "a function beyond the caps");
    assert_eq!(x.over(&one.plus(&one)).plus(&x.over(&one.plus(&one))), x);
}

/// The same constants, computed as functions and at single parameters.
#[test]
fn constants_of_schemes_as_functions_of_their_parameter() {
    let schemes = [
        ("four-point", "w"),
        ("six-point", "w"),
        ("ternary-three-point", "a"),
        ("ternary-four-point", "mu"),
    ];
    for (scheme, parameter) in schemes {
        let definition = find(scheme).expect("a scheme of the catalogue");
        let symbolic = [(parameter.to_owned(), Parametric::variable())].into();
        let symbolic = definition.mask(&symbolic).expect("a mask of functions");
        let norm = power_norm_generic(&symbolic.difference(), 1, Order::Adjoint).expect("9 rows");
        let norm = norm.function().expect("a contraction constant for c = 1").clone();
        for numerator in -24..=24 {
            let at = q(numerator, 12);
            let mask = definition.mask(&[(parameter.to_owned(), at.clone())].into());
            let mask = mask.expect("a mask");
            let expected = power_norm(&mask.difference(), 1, Order::Forward).expect("few rows");
            assert_eq!(norm.at(&at), expected.value, "{scheme} at {at}");
            for (offset, terms) in [(0, Terms::Each), (-1, Terms::Each), (0, Terms::Total)] {
                let sigma = displacement(&symbolic.with_offset(offset), terms);
                let sigma = sigma.function().expect("piecewise linear").at(&at);
                let expected = displacement(&mask.with_offset(offset), terms);
                assert_eq!(sigma, expected, "{scheme} at {at}, offset {offset}, {terms:?}");
            }
        }
    }
}
