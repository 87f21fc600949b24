//! Values of the basic limit function and its derivatives, against limits of polygons and truncated powers.

use proptest::prelude::*;
use subcert::exact::{FieldElement, Rational};
use subcert::limit::Limit;
use subcert::scheme::{Mask, parse_algebraic, parse_scheme};
use subcert::smoothness::{BasicError, BasicValues, Coefficient, Smoothness};

fn rational(scheme: &str) -> Mask {
    parse_scheme(scheme).expect("a scheme").masks()[0].clone()
}

fn values(mask: &Mask, m: usize, level: u32) -> Result<BasicValues, BasicError> {
    BasicValues::of(&Smoothness::of(mask).expect("short rules"), m, level)
}

/// φ(t) is the weight of x_0 in the limit at t, which is found in another way.
#[test]
fn values_are_weights_of_limits() {
    for (scheme, level) in [
        ("four-point:w=1/16", 3),
        ("chaikin", 4),
        ("ternary-four-point:mu=1/10", 2),
        ("quaternary-four-point:mu=1/2", 2),
        ("de-rham", 3),
    ] {
        let mask = rational(scheme);
        let limit = Limit::new(&mask).expect("it converges");
        let found = values(&mask, 0, level).expect("it converges");
        let steps = Rational::from(mask.arity()).pow(level.cast_signed());
        for (j, value) in (found.first..).zip(&found.values) {
            let weights = limit.at(&(Rational::from(j) / &steps)).expect("few digits");
            assert_eq!(*value, weights.coefficient(0), "{scheme} at {j}/{steps}");
        }
        let beyond = Rational::from(found.first - 1) / &steps;
        assert!(limit.at(&beyond).expect("few digits").coefficient(0).is_zero(), "{scheme}");
    }
}

/// The B-spline of degree d is Σ_i (−1)^i C(d + 1, i) (t − i)_+^d/d!, up to a shift of t; so are its derivatives.
#[test]
fn derivatives_of_splines_are_truncated_powers() {
    let degree = 4_u32;
    let mask = rational("b-spline:degree=4");
    for m in 0..degree {
        let found = values(&mask, m as usize, 2).expect("a smooth spline");
        let (rest, steps) = (degree - m, Rational::from(4));
        let factorial = |n: u32| {
            (1..=n).map(|i| Rational::from(i64::from(i))).fold(Rational::one(), |p, i| p * i)
        };
        let start = Rational::from(found.first) / &steps;
        for (j, value) in (found.first..).zip(&found.values) {
            let t = Rational::from(j) / &steps - &start;
            let term = |i: u32| {
                let base = &t - Rational::from(i64::from(i));
                let sign = if i.is_multiple_of(2) { 1 } else { -1 };
                let choose = factorial(degree + 1) / (factorial(i) * factorial(degree + 1 - i));
                if base.sign() <= 0 {
                    Rational::zero()
                } else {
                    Rational::from(sign) * choose * base.pow(rest.cast_signed())
                }
            };
            let expected: Rational = (0..=degree + 1).map(term).sum();
            assert_eq!(*value, expected / factorial(rest), "order {m} at {j}/4");
        }
    }
    assert_eq!(values(&mask, 4, 0), Err(BasicError::Fails(4)));
}

/// Σ_i i^l φ^{(m)}(t − i) is 0 for l < m and m! for l = m, as polynomials of degree m are generated.
fn moments<F: Coefficient>(found: &BasicValues<F>) {
    let steps = i64::try_from(found.arity.pow(found.level)).expect("a small number");
    let last = found.first + i64::try_from(found.values.len()).expect("a small number") - 1;
    let factorial: i64 = (1..).take(found.order).product();
    for start in 0..steps {
        for l in 0..=found.order {
            let (low, high) =
                ((start - last).div_euclid(steps) - 1, (start - found.first).div_euclid(steps) + 1);
            let sum = (low..=high).fold(F::zero(), |sum, i| {
                let power = Rational::from(i).pow(i32::try_from(l).expect("small"));
                sum.plus(&F::from_rational(&power).times(&found.at(start - i * steps)))
            });
            let expected = if l == found.order { factorial } else { 0 };
            assert!(
                sum == F::from_rational(&Rational::from(expected)),
                "moment {l} at {start}/{steps}"
            );
        }
    }
}

#[test]
fn irrational_coefficients_have_values_too() {
    let mask: Mask<FieldElement> = parse_algebraic("daubechies-6").expect("a mask");
    let smoothness = Smoothness::of(&mask).expect("short rules");
    for m in 0..=1 {
        moments(&BasicValues::of(&smoothness, m, 2).expect("C^1"));
    }
}

#[test]
fn what_is_not_shown_has_no_values() {
    assert_eq!(values(&rational("four-point:w=1/2"), 0, 0), Err(BasicError::Diverges));
    assert_eq!(values(&rational("haar"), 0, 0), Err(BasicError::Diverges));
    assert_eq!(values(&rational("chaikin"), 2, 0), Err(BasicError::Fails(2)));
    assert!(matches!(values(&rational("chaikin"), 0, 40), Err(BasicError::TooMany(_))));
    assert!(matches!(values(&rational("chaikin"), 0, 4_000), Err(BasicError::TooMany(_))));
    // The support of the spline of degree d has d + 2 whole numbers.
    let wide = Smoothness::of(&rational("b-spline:degree=39")).expect("short rules");
    assert_eq!(BasicValues::of(&wide, 0, 0), Err(BasicError::Wide(40)));
    assert_eq!(BasicValues::count(&wide, 1), Some(81));
}

proptest! {
    #![proptest_config(crate::common::cases(10))]
    /// A random scheme, and the one that takes means of its neighbouring points, whose derived scheme it is.
    #[test]
    fn values_keep_the_laws_of_generated_polynomials(
        first in proptest::collection::vec(0_i64..=3, 2),
        second in proptest::collection::vec(0_i64..=3, 2),
    ) {
        let row = |x: &Vec<i64>| -> Vec<Rational> {
            [x[0], 8 - x[0] - x[1], x[1]].map(|x| Rational::new(x, 8)).to_vec()
        };
        let rows = [row(&first), row(&second)];
        let half = Rational::new(1, 2);
        let at = |row: &[Rational], j: usize| row.get(j).cloned().unwrap_or_else(Rational::zero);
        let before = |row: &[Rational], j: usize| j.checked_sub(1).map_or_else(Rational::zero, |j| at(row, j));
        let mean = |alpha: usize| -> Vec<Rational> {
            (0..4).map(|j| {
                let other = if alpha == 0 { at(&rows[1], j) } else { before(&rows[0], j) };
                (before(&rows[alpha], j) + other) * &half
            }).collect()
        };
        for (mask, least) in [
            (Mask::new(rows.to_vec(), 0).expect("affine"), 0),
            (Mask::new(vec![mean(0), mean(1)], -1).expect("affine"), 1),
        ] {
            let smoothness = Smoothness::of(&mask).expect("short rules");
            prop_assert!(smoothness.sum_rules > least);
            for m in 0..=smoothness.continuity.unwrap_or(0) {
                if let Ok(found) = BasicValues::of(&smoothness, m, 2) {
                    moments(&found);
                }
            }
        }
    }
}
