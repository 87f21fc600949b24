//! Piecewise linear functions against their values at points.

use proptest::prelude::*;
use std::ops::Bound;
use subcert::bound::{Order, Terms, displacement, power_norm, power_norm_generic};
use subcert::exact::{Interval, IntervalSet, Parametric, PiecewiseLinear, Rational, Real, Scalar};
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
    Magnitude(Box<Tree>),
    Greater(Box<Tree>, Box<Tree>),
    Lesser(Box<Tree>, Box<Tree>),
}

fn tree() -> impl Strategy<Value = Tree> {
    let leaf = prop_oneof![rational().prop_map(Tree::Constant), Just(Tree::Variable)];
    leaf.prop_recursive(5, 24, 2, |inner| {
        let pair = (inner.clone(), inner.clone()).prop_map(|(l, r)| (Box::new(l), Box::new(r)));
        prop_oneof![
            pair.clone().prop_map(|(l, r)| Tree::Plus(l, r)),
            pair.clone().prop_map(|(l, r)| Tree::Minus(l, r)),
            (rational(), inner.clone()).prop_map(|(c, t)| Tree::Scaled(c, Box::new(t))),
            inner.prop_map(|t| Tree::Magnitude(Box::new(t))),
            pair.clone().prop_map(|(l, r)| Tree::Greater(l, r)),
            pair.prop_map(|(l, r)| Tree::Lesser(l, r)),
        ]
    })
}

fn function(tree: &Tree) -> PiecewiseLinear {
    match tree {
        Tree::Constant(value) => PiecewiseLinear::constant(value.clone()),
        Tree::Variable => PiecewiseLinear::variable(),
        Tree::Plus(l, r) => function(l).plus(&function(r)),
        Tree::Minus(l, r) => function(l).minus(&function(r)),
        Tree::Scaled(factor, t) => function(t).scaled(factor),
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
        Tree::Magnitude(t) => value(t, x).abs(),
        Tree::Greater(l, r) => value(l, x).max(value(r, x)),
        Tree::Lesser(l, r) => value(l, x).min(value(r, x)),
    }
}

/// The breaks of the functions, points between and beyond them, and the points
/// given.
fn points(functions: &[&PiecewiseLinear], more: &[Rational]) -> Vec<Rational> {
    let mut points: Vec<Rational> = more.to_vec();
    points.extend(functions.iter().flat_map(|f| f.breakpoints().iter().cloned()));
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

/// The ends of the intervals, all of them finite, and points next to them.
fn ends(set: &IntervalSet) -> Vec<Rational> {
    let ends = set.intervals().iter().flat_map(|interval| [&interval.low, &interval.high]);
    let place = |end: &Bound<Rational>| match end {
        Bound::Unbounded => None,
        Bound::Included(place) | Bound::Excluded(place) => Some(place.clone()),
    };
    let tiny = q(1, 1_000_003);
    let places = ends.filter_map(place);
    places.flat_map(|place| [&place - &tiny, place.clone(), place + &tiny]).collect()
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

    /// The breaks are where the slope changes, and nowhere else.
    #[test]
    fn the_form_is_normal(tree in tree()) {
        let function = function(&tree);
        let breaks = function.breakpoints();
        prop_assert!(breaks.windows(2).all(|pair| pair[0] < pair[1]));
        for (i, point) in breaks.iter().enumerate() {
            let step = breaks.windows(2).map(|pair| &pair[1] - &pair[0]).min();
            let step = step.unwrap_or_else(Rational::one) / Rational::from(2);
            let [before, here, after] =
                [point - &step, point.clone(), point + &step].map(|x| function.at(&x));
            prop_assert_ne!(&here - &before, &after - &here, "break {}", i);
        }
    }

    #[test]
    fn laws_hold_as_equality_of_functions(a in tree(), b in tree(), c in tree(), k in rational()) {
        let (f, g, h) = (function(&a), function(&b), function(&c));
        let zero = PiecewiseLinear::constant(Rational::zero());
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

    #[test]
    fn products_where_they_exist(a in tree(), b in tree(), at in prop::collection::vec(rational(), 8)) {
        let (f, g) = (function(&a), function(&b));
        if let Some(product) = f.times(&g) {
            for x in points(&[&f, &g, &product], &at) {
                prop_assert_eq!(product.at(&x), f.at(&x) * g.at(&x));
            }
        } else {
            // Then the second difference of the product is not 0 somewhere between
            // two breaks: both factors have a slope there.
            let mut breaks = points(&[&f, &g], &[Rational::zero()]);
            breaks.sort();
            breaks.dedup();
            let curved = breaks.windows(2).any(|pair| {
                let middle = (&pair[0] + &pair[1]) / Rational::from(2);
                let product = |x: &Rational| f.at(x) * g.at(x);
                product(&pair[0]) + product(&pair[1]) != Rational::from(2) * product(&middle)
            });
            prop_assert!(curved, "{} times {}", f, g);
        }
    }
}

fn x() -> PiecewiseLinear {
    PiecewiseLinear::variable()
}

fn constant(p: i64, q: i64) -> PiecewiseLinear {
    PiecewiseLinear::constant(Rational::new(p, q))
}

#[test]
fn hand_made_facts() {
    let tent = constant(1, 1).minus(&x().magnitude()).greater(&constant(0, 1));
    assert_eq!(tent.breakpoints(), [q(-1, 1), q(0, 1), q(1, 1)]);
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
    assert_eq!(right.times(&left), Some(constant(0, 1)));
    assert_eq!(right.times(&right), None);
    assert_eq!(x().times(&constant(-2, 3)), Some(x().scaled(&q(-2, 3))));
    // max(|x|, 1) − |x| − … breaks that cancel are gone.
    assert_eq!(x().magnitude().minus(&x().magnitude()).piece_count(), 1);
    assert_eq!(x().greater(&x().scaled(&q(-1, 1))), x().magnitude());
    assert_eq!(x().as_constant(), None);
    assert_eq!(constant(3, 4).as_constant(), Some(q(3, 4)));
}

#[test]
fn intervals_cover_intervals() {
    let interval = |low, high| Interval { low, high };
    let (in_0, ex_0) = (Bound::Included(q(0, 1)), Bound::Excluded(q(0, 1)));
    let (in_1, ex_1) = (Bound::Included(q(1, 1)), Bound::Excluded(q(1, 1)));
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
    let square = x.times(&x);
    for poisoned in [
        square.clone(),
        square.minus(&square),
        one.plus(&square).times(&Parametric::zero()),
        one.over(&x),
        square.magnitude(),
        square.greater(&one),
        one.lesser(&square),
        Parametric::total(&[one.clone(), square.clone()]),
    ] {
        assert!(poisoned.function().is_none(), "{poisoned}");
        assert_ne!(poisoned, poisoned.clone());
        assert_eq!(poisoned.to_string(), "a function that is not piecewise linear");
    }
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
