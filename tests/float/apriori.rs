//! The bound in advance always encloses the true error.

use crate::float::strategy::{mask, two, wide};
use proptest::prelude::*;
use subcert::bound::{Order, Terms, displacement, power_norm, power_norm_generic};
use subcert::exact::{Rational, Real, Scalar};
use subcert::float::{Tracked, exact};

/// The same computation in both arithmetics.
#[derive(Clone, Debug)]
struct Both {
    float: f64,
    tracked: Tracked,
}

impl Both {
    fn of(value: &Rational) -> Both {
        Both { float: f64::from_rational(value), tracked: Tracked::from_rational(value) }
    }

    /// Applies operation number `which` of [`OPERATIONS`].
    fn apply(&self, other: &Both, which: usize) -> Option<Both> {
        if which == 3 && other.tracked.value().is_zero() {
            return None;
        }
        Some(Both {
            float: operation(&self.float, &other.float, which),
            tracked: operation(&self.tracked, &other.tracked, which),
        })
    }

    #[track_caller]
    fn check(&self) {
        let bound = self.tracked.error();
        assert!(bound >= 0.0, "{bound}");
        let Some(bound) = exact(bound) else { return };
        let found = exact(self.float).unwrap_or_else(|| panic!("finite bound: {self:?}"));
        assert!((found - self.tracked.value()).abs() <= bound, "{self:?}");
    }
}

const OPERATIONS: usize = 6;

fn operation<S: Real>(x: &S, y: &S, which: usize) -> S {
    match which {
        0 => x.plus(y),
        1 => x.minus(y),
        2 => x.times(y),
        3 => x.over(y),
        4 => x.greater(y),
        _ => x.magnitude(),
    }
}

proptest! {
    /// Programs on a stack of numbers of every size, with every operation.
    #[test]
    fn random_programs(
        inputs in prop::collection::vec(wide(), 1..5),
        program in prop::collection::vec((0..OPERATIONS, any::<prop::sample::Index>(), any::<prop::sample::Index>()), 1..14),
    ) {
        let mut numbers: Vec<Both> = inputs.iter().map(Both::of).collect();
        numbers.push(Both::of(&Rational::zero()));
        numbers.push(Both::of(&Rational::from(-1)));
        for (which, x, y) in program {
            let (x, y) = (x.get(&numbers).clone(), y.get(&numbers).clone());
            numbers.extend(x.apply(&y, which));
        }
        for number in &numbers {
            number.check();
        }
    }

    /// The exact value that is carried along is the one of the exact path.
    #[test]
    fn the_carried_value_is_exact(mask in mask()) {
        let tracked = mask.map(<Tracked>::from_rational);
        let norm = power_norm_generic(&tracked.difference(), 2, Order::Adjoint).unwrap();
        let exact_norm = power_norm(&mask.difference(), 2, Order::Adjoint).unwrap().value;
        prop_assert_eq!(norm.value(), &exact_norm);
        let sigma = displacement(&tracked, Terms::Each);
        prop_assert_eq!(sigma.value(), &displacement(&mask, Terms::Each));
    }
}

fn tracked(value: &Rational) -> Tracked {
    Tracked::from_rational(value)
}

#[test]
fn numbers_that_fit_carry_no_error() {
    for value in [two(-1074), two(1023), Rational::new(-3, 8), Rational::zero(), two(200)] {
        assert_eq!(tracked(&value).error().to_bits(), 0, "{value}");
    }
    let quarter = tracked(&Rational::new(1, 4));
    assert_eq!(quarter.plus(&quarter).times(&quarter).error().to_bits(), 0);
}

#[test]
fn conversion_costs_half_a_unit_at_most() {
    let tenth = tracked(&Rational::new(1, 10));
    // u·0.1, and a little for rounding upwards.
    assert!(tenth.error() >= 0.1 * f64::EPSILON / 2.0);
    assert!(tenth.error() < 0.1 * f64::EPSILON / 2.0 * 1.000_001);
}

#[test]
fn underflow_is_counted() {
    let tiny = tracked(&two(-600));
    let product = tiny.times(&tiny);
    assert_eq!(*product.value(), two(-1200));
    assert_eq!(product.error().to_bits(), 1);
    let quotient = tiny.over(&tracked(&two(600)));
    assert_eq!(quotient.error().to_bits(), 1);
    assert_eq!(tracked(&two(-2000)).error().to_bits(), 1);
}

#[test]
fn overflow_promises_nothing() {
    let huge = tracked(&two(600));
    let product = huge.times(&huge);
    assert!(product.error().is_infinite());
    // 0·∞ is NaN in f64.
    assert!(product.times(&Tracked::zero()).error().is_infinite());
    assert!(Tracked::zero().times(&product).error().is_infinite());
    assert!(product.greater(&Tracked::zero()).error().is_infinite());
    assert!(Tracked::zero().over(&product).error().is_infinite());
    assert!(tracked(&two(1024)).error().is_infinite());
    assert_eq!(tracked(&two(1023)).error().to_bits(), 0);
}

#[test]
fn a_divisor_that_may_be_zero_promises_nothing() {
    let third = tracked(&Rational::new(1, 3));
    let residue = third.plus(&third).plus(&third).minus(&tracked(&(Rational::one() - two(-60))));
    assert!(residue.error() > 0.0);
    assert!(Tracked::from_rational(&Rational::one()).over(&residue).error().is_infinite());
    // One that is surely not 0 has a bound.
    assert!(third.over(&third).error() < 1e-15);
}

#[test]
fn not_a_number_stays_visible() {
    let nan = f64::NAN;
    assert!(nan.greater(&1.0).is_nan());
    assert!(1.0_f64.greater(&nan).is_nan());
    assert!(<f64 as Real>::maximum([1.0, nan, 2.0]).is_nan());
    assert_eq!(<f64 as Real>::maximum([1.0, 3.0, 2.0]).to_bits(), 3.0_f64.to_bits());
}
