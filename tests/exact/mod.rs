//! Numbers: reading, printing and arithmetic, against naive versions, against
//! num-bigint and num-rational, and against facts from elsewhere.

mod algebraic;
mod arithmetic;
mod characteristic;
mod cosine;
mod cosine_facts;
mod cosine_internals;
mod cosine_polynomial;
mod decimal;
mod doo_sabin;
mod enclosure;
mod expression;
mod format;
mod integer_function;
mod linear;
mod matrix;
mod number_field;
mod other_numbers;
mod piecewise;
mod polynomial;
mod quotient_at;
mod reading;
mod univariate;

use num_bigint::BigInt;
use num_rational::BigRational;
use proptest::prelude::*;
use subcert::exact::{Integer, Rational};

/// An integer of up to 380 digits, the short ones as likely as the long ones, and as those
/// at the ends of machine words.
fn integer() -> impl Strategy<Value = BigInt> {
    let limbs = prop_oneof![
        prop::collection::vec(any::<u32>(), 0..3),
        prop::collection::vec(any::<u32>(), 0..40)
    ];
    let of_any_size = (any::<bool>(), limbs).prop_map(|(negative, limbs)| {
        let magnitude = BigInt::from(num_bigint::BigUint::new(limbs));
        if negative { -magnitude } else { magnitude }
    });
    let near_a_power =
        (any::<bool>(), prop::sample::select(&[31, 32, 62, 63, 64, 126, 127, 128]), -2..3);
    let near_a_power = near_a_power.prop_map(|(negative, places, off)| {
        let power = BigInt::from(1) << places;
        if negative { off - power } else { power + off }
    });
    prop_oneof![2 => of_any_size, 1 => near_a_power]
}

fn nonzero() -> impl Strategy<Value = BigInt> {
    integer().prop_filter("not 0", |value| *value != BigInt::ZERO)
}

fn ratio() -> impl Strategy<Value = BigRational> {
    (integer(), nonzero()).prop_map(|(p, q)| BigRational::new(p, q))
}

/// A ratio that often terminates in the decimal system, so that ties occur.
fn ratio_with_ties() -> impl Strategy<Value = BigRational> {
    let terminating = (any::<i32>(), 0_u32..8, 0_u32..4).prop_map(|(p, twos, fives)| {
        BigRational::new(p.into(), BigInt::from(2).pow(twos) * BigInt::from(5).pow(fives))
    });
    prop_oneof![terminating, ratio()]
}

/// The same number in the crate's type, by way of its digits.
fn ours(value: &BigInt) -> Integer {
    let digits = Integer::from_digits(value.magnitude().to_string().as_str()).expect("digits");
    if value.sign() == num_bigint::Sign::Minus { -digits } else { digits }
}

fn our_ratio(value: &BigRational) -> Rational {
    Rational::new(ours(value.numer()), ours(value.denom()))
}

/// The same number in num-rational's type, by way of its digits.
fn theirs(value: &Rational) -> BigRational {
    let integer = |value: Integer| value.to_string().parse::<BigInt>().expect("digits");
    BigRational::new_raw(integer(value.numerator()), integer(value.denominator()))
}
