//! num-bigint.

mod gcd;

use num_bigint::Sign;
use num_integer::Integer as _;
use num_traits::ToPrimitive as _;

pub(crate) use num_bigint::BigInt as Int;

pub(crate) const NAME: &str = "num-bigint";

pub(crate) fn parse_digits(digits: &str, radix: u32) -> Option<Int> {
    Int::parse_bytes(digits.as_bytes(), radix)
}

/// The same number of num-bigint.
pub(crate) fn to_big(a: &Int) -> Int {
    a.clone()
}

pub(crate) fn from_big(a: Int) -> Int {
    a
}

/// Σ 2^{64i}·words[i].
#[expect(clippy::cast_possible_truncation, reason = "a word is cut in two")]
pub(crate) fn from_words(words: &[u64]) -> Int {
    let halves = words.iter().flat_map(|&word| [word as u32, (word >> 32) as u32]).collect();
    Int::from(num_bigint::BigUint::new(halves))
}

pub(crate) fn div_floor(a: &Int, b: &Int) -> Int {
    a.div_floor(b)
}

/// a/b, which is an integer.
pub(crate) fn div_exact(a: &Int, b: &Int) -> Int {
    a / b
}

pub(crate) fn gcd(a: &Int, b: &Int) -> Int {
    gcd::gcd(a.magnitude(), b.magnitude()).into()
}

pub(crate) fn pow(a: &Int, exponent: u32) -> Int {
    a.pow(exponent)
}

pub(crate) fn neg(a: &Int) -> Int {
    -a
}

pub(crate) fn sign(a: &Int) -> i8 {
    match a.sign() {
        Sign::Minus => -1,
        Sign::NoSign => 0,
        Sign::Plus => 1,
    }
}

pub(crate) fn bits(a: &Int) -> u64 {
    a.bits()
}

pub(crate) fn is_even(a: &Int) -> bool {
    a.is_even()
}

/// How often 2 divides a; `None` for 0.
pub(crate) fn trailing_zeros(a: &Int) -> Option<u32> {
    a.trailing_zeros().and_then(|zeros| u32::try_from(zeros).ok())
}

pub(crate) fn to_i64(a: &Int) -> Option<i64> {
    a.to_i64()
}

pub(crate) fn to_i128(a: &Int) -> Option<i128> {
    a.to_i128()
}

/// a·2^places.
pub(crate) fn shl(a: &Int, places: u32) -> Int {
    a << places
}

/// ⌊a/2^places⌋.
pub(crate) fn shr(a: &Int, places: u32) -> Int {
    a >> places
}

/// a mod modulus, from 0 to modulus − 1.
pub(crate) fn residue(a: &Int, modulus: u64) -> u64 {
    let rest = (a.magnitude() % modulus).to_u64().expect("less than the modulus");
    if a.sign() == Sign::Minus && rest > 0 { modulus - rest } else { rest }
}
