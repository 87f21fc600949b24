//! num-bigint and num-rational.

use num_integer::Integer as _;
use num_traits::{Signed as _, ToPrimitive as _, Zero as _};

pub(in crate::exact) use num_bigint::BigInt as Int;
pub(in crate::exact) use num_rational::BigRational as Rat;

pub(in crate::exact) const NAME: &str = "num-bigint";

pub(in crate::exact) fn parse_digits(digits: &str) -> Option<Int> {
    Int::parse_bytes(digits.as_bytes(), 10)
}

/// Σ 2^{64i}·words[i].
#[expect(clippy::cast_possible_truncation, reason = "a word is cut in two")]
pub(in crate::exact) fn from_words(words: &[u64]) -> Int {
    let halves = words.iter().flat_map(|&word| [word as u32, (word >> 32) as u32]).collect();
    Int::from(num_bigint::BigUint::new(halves))
}

pub(in crate::exact) fn div_floor(a: &Int, b: &Int) -> Int {
    a.div_floor(b)
}

pub(in crate::exact) fn gcd(a: &Int, b: &Int) -> Int {
    a.gcd(b)
}

pub(in crate::exact) fn pow(a: &Int, exponent: u32) -> Int {
    a.pow(exponent)
}

pub(in crate::exact) fn abs(a: &Int) -> Int {
    a.abs()
}

pub(in crate::exact) fn sign(a: &Int) -> i8 {
    match a.sign() {
        num_bigint::Sign::Minus => -1,
        num_bigint::Sign::NoSign => 0,
        num_bigint::Sign::Plus => 1,
    }
}

pub(in crate::exact) fn bits(a: &Int) -> u64 {
    a.bits()
}

pub(in crate::exact) fn is_even(a: &Int) -> bool {
    a.is_even()
}

pub(in crate::exact) fn to_i128(a: &Int) -> Option<i128> {
    a.to_i128()
}

/// a·2^places.
pub(in crate::exact) fn shl(a: &Int, places: u32) -> Int {
    a << places
}

/// ⌊a/2^places⌋.
pub(in crate::exact) fn shr(a: &Int, places: u32) -> Int {
    a >> places
}

/// a mod modulus, from 0 to modulus − 1.
pub(in crate::exact) fn residue(a: &Int, modulus: u32) -> u32 {
    a.mod_floor(&Int::from(modulus)).to_u32().expect("less than the modulus")
}

pub(in crate::exact) fn rat(numerator: Int, denominator: Int) -> Rat {
    Rat::new(numerator, denominator)
}

pub(in crate::exact) fn rat_is_zero(a: &Rat) -> bool {
    a.is_zero()
}

pub(in crate::exact) fn rat_sign(a: &Rat) -> i8 {
    sign(a.numer())
}

pub(in crate::exact) fn rat_pow(a: &Rat, exponent: u32) -> Rat {
    num_traits::Pow::pow(a, exponent)
}

pub(in crate::exact) fn rat_bits(a: &Rat) -> u64 {
    bits(a.numer()) + bits(a.denom())
}
