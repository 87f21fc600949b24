//! Random masks against the definitions.

use proptest::prelude::*;
use subcert::exact::{Enclosed as _, Rational};
use subcert::scheme::Mask;
use subcert::smoothness::{Smoothness, Symbol};

/// Affine rules with entries in sixteenths.
fn masks(arity: usize, width: usize) -> impl Strategy<Value = Mask> {
    let row = proptest::collection::vec(-3_i64..=9, width - 1).prop_map(|mut row| {
        row.insert(row.len() / 2, 16 - row.iter().sum::<i64>());
        row.into_iter().map(|x| Rational::new(x, 16)).collect::<Vec<Rational>>()
    });
    proptest::collection::vec(row, arity).prop_map(|rows| Mask::new(rows, 0).expect("affine"))
}

/// The differences of order k of S^l δ, by the rules themselves: the largest.
fn largest_difference(mask: &Mask, k: usize, levels: u32) -> Rational {
    let mut points = vec![Rational::zero(); 8 * mask.width()];
    let middle = points.len() / 2;
    points[middle] = Rational::one();
    for _ in 0..levels {
        points = mask.rules().refine_open(&points);
    }
    for _ in 0..k {
        points = points.windows(2).map(|pair| &pair[1] - &pair[0]).collect();
    }
    points.iter().map(Rational::abs).max().expect("points")
}

/// ‖S_B^l‖ of the differences of order k, by the coefficients of B(z)⋯B(z^{n^{l−1}}).
pub(super) fn power_norm(symbol: &Symbol, k: usize, levels: u32) -> Rational {
    let n = symbol.arity();
    let b = symbol.difference(k, &Rational::one()).expect("sum rules");
    let b = b.coefficients();
    let mut product = vec![Rational::one()];
    let mut step = 1;
    for _ in 0..levels {
        let mut longer = vec![Rational::zero(); product.len() + step * (b.len() - 1)];
        for (i, x) in product.iter().enumerate() {
            for (j, y) in b.iter().enumerate() {
                longer[i + step * j] += &(x * y);
            }
        }
        (product, step) = (longer, step * n);
    }
    let class = |e: usize| product.iter().skip(e).step_by(step).map(Rational::abs).sum();
    (0..step).map(class).max().expect("a class")
}

fn check(mask: &Mask, levels: u32) -> Result<(), TestCaseError> {
    let smoothness = Smoothness::of(mask).expect("short rules");
    let differences = &smoothness.differences;
    let (n, k) = (Rational::from(mask.arity()), differences.order);
    let radius = &differences.radius;
    let degree = i32::try_from(radius.degree).expect("short");
    for l in 1..=levels {
        // ϱ^l ≤ n^{Kl}‖S_B^l‖ for every l.
        let power = i32::try_from(l).expect("few");
        let scale = n.pow(power * i32::try_from(k).expect("few"));
        let norm = power_norm(&smoothness.symbol, k, l) * &scale;
        prop_assert!(radius.root.enclosure(0).lower().pow(power) <= norm.pow(degree));
        // The differences of the data δ are among the values of the operator at Δ^Kδ.
        let largest = largest_difference(mask, k, l) * scale;
        prop_assert!(largest <= norm * Rational::from(2).pow(i32::try_from(k).expect("few")));
    }
    if let Some(hull) = &radius.hull {
        prop_assert!(hull.proves(&differences.matrices));
    }
    if let (Some(m), Some(fails)) = (smoothness.continuity, smoothness.continuity_fails) {
        prop_assert!(m < fails && m < k.max(1) + 1);
    }
    if let Some(hoelder) = &smoothness.hoelder {
        prop_assert!(hoelder.lower <= hoelder.upper);
        let m = Rational::from(smoothness.continuity.expect("it converges"));
        prop_assert!(hoelder.upper > m);
    }
    Ok(())
}

proptest! {
    #![proptest_config(crate::common::cases(16))]

    #[test]
    fn binary_masks(mask in masks(2, 3)) {
        check(&mask, 10)?;
    }

    #[test]
    fn wider_binary_masks(mask in masks(2, 4)) {
        check(&mask, 9)?;
    }

    #[test]
    fn ternary_masks(mask in masks(3, 3)) {
        check(&mask, 6)?;
    }

    /// A(z)·(1 + z)/2 smooths a binary scheme by one derivative: φ becomes its integral over [t − 1, t].
    #[test]
    fn one_factor_more_is_one_derivative_more(mask in masks(2, 3)) {
        let smoothness = Smoothness::of(&mask).expect("short rules");
        let coefficients = smoothness.symbol.coefficients();
        let half = Rational::new(1, 2);
        let at = |i: usize| coefficients.get(i).cloned().unwrap_or_else(Rational::zero);
        let mut longer: Vec<Rational> = (0..=coefficients.len())
            .map(|i| (at(i) + i.checked_sub(1).map_or_else(Rational::zero, at)) * &half)
            .collect();
        if longer.len() % 2 == 1 {
            longer.push(Rational::zero());
        }
        let rule = |alpha: usize| longer.iter().skip(alpha).step_by(2).rev().cloned().collect();
        let other = Mask::new(vec![rule(0), rule(1)], 0).expect("affine");
        let other = Smoothness::of(&other).expect("short rules");
        prop_assert_eq!(other.sum_rules, smoothness.sum_rules + 1);
        if let (Some(a), Some(b)) = (&smoothness.hoelder, &other.hoelder) {
            prop_assert!(&a.lower + Rational::one() <= b.upper);
            prop_assert!(b.lower <= &a.upper + Rational::one());
        }
    }
}
