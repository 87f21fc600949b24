//! Random rationals and masks, also nasty ones.

use proptest::prelude::*;
use subcert::exact::{Rational, Scalar};
use subcert::scheme::{Mask, Rules, Scheme};

/// 2^exponent.
pub fn two(exponent: i32) -> Rational {
    Rational::from(2).pow(exponent)
}

/// p/q of a size about 1, with denominators that f64 likes and dislikes.
pub fn coefficient() -> impl Strategy<Value = Rational> {
    let denominator = prop_oneof![
        4 => 1_i64..60,
        2 => prop::sample::select(vec![16, 25, 128, 1_296, 1_000, 1 << 40]),
        1 => prop::sample::select(vec![1_000_000_007, (1 << 61) - 1, 10_i64.pow(18)]),
    ];
    (denominator, -2.0..2.0_f64).prop_map(|(q, size)| {
        #[expect(clippy::cast_possible_truncation, clippy::cast_precision_loss)]
        let p = (size * q as f64) as i64;
        Rational::new(p, q)
    })
}

/// A rational of any sign and of a size up to 2^±1100, beyond the range of f64.
pub fn wide() -> impl Strategy<Value = Rational> {
    let exponent = prop_oneof![4 => -80..80_i32, 1 => -1_100..1_100_i32];
    (any::<i64>(), 1..i64::MAX, exponent).prop_map(|(p, q, e)| Rational::new(p, q) * two(e))
}

/// An affine mask of arity 2…5 and width 1…8, at an offset −9…9: the last
/// coefficient of every rule is what is missing to 1.
pub fn mask() -> impl Strategy<Value = Mask> {
    (2..=5_usize, 1..=8_usize, -9..=9_i64).prop_flat_map(|(arity, width, offset)| {
        let row = prop::collection::vec(coefficient(), width - 1);
        prop::collection::vec(row, arity).prop_map(move |mut rows| {
            for row in &mut rows {
                row.push(Rational::one() - Rational::total(&*row));
            }
            Mask::new(rows, offset).expect("affine by construction")
        })
    })
}

/// A curve scheme, or less often a tensor product.
pub fn scheme() -> impl Strategy<Value = Scheme> {
    prop_oneof![
        5 => mask().prop_map(Scheme::Curve),
        1 => (mask(), mask()).prop_map(|(first, second)| Scheme::Tensor(first, second)),
    ]
}

/// The largest Σ_j |r_{α,j}|.
pub fn largest_row_sum(rules: &Rules) -> Rational {
    let sums = rules.rows().iter().map(|row| row.iter().map(Rational::abs).sum());
    sums.max().expect("there is a rule")
}
