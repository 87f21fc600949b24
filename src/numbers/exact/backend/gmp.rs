//! GMP, through rug.

use num_bigint::{BigInt, BigUint, Sign};
use rug::Complete as _;
use rug::integer::Order;
use rug::ops::{DivRounding as _, Pow as _, RemRounding as _};

pub(crate) use rug::Integer as Int;

pub(crate) const NAME: &str = "GMP";

pub(crate) fn parse_digits(digits: &str, radix: u32) -> Option<Int> {
    Int::parse_radix(digits, i32::try_from(radix).ok()?).ok().map(Int::from)
}

/// The same number of num-bigint.
pub(crate) fn to_big(a: &Int) -> BigInt {
    let mut digits = vec![0_u32; a.significant_digits::<u32>()];
    a.write_digits(&mut digits, Order::Lsf);
    let magnitude = BigInt::from(BigUint::new(digits));
    if a.is_negative() { -magnitude } else { magnitude }
}

pub(crate) fn from_big(a: BigInt) -> Int {
    let (sign, digits) = a.to_u32_digits();
    let magnitude = Int::from_digits(&digits, Order::Lsf);
    if sign == Sign::Minus { -magnitude } else { magnitude }
}

/// Σ 2^{64i}·words[i].
pub(crate) fn from_words(words: &[u64]) -> Int {
    Int::from_digits(words, Order::Lsf)
}

pub(crate) fn div_floor(a: &Int, b: &Int) -> Int {
    Int::from(a.div_floor(b))
}

/// a/b, which is an integer.
pub(crate) fn div_exact(a: &Int, b: &Int) -> Int {
    a.div_exact_ref(b).complete()
}

pub(crate) fn gcd(a: &Int, b: &Int) -> Int {
    a.gcd_ref(b).complete()
}

pub(crate) fn pow(a: &Int, exponent: u32) -> Int {
    Int::from(a.pow(exponent))
}

pub(crate) fn neg(a: &Int) -> Int {
    (-a).complete()
}

pub(crate) fn sign(a: &Int) -> i8 {
    a.cmp0() as i8
}

pub(crate) fn bits(a: &Int) -> u64 {
    u64::from(a.significant_bits())
}

pub(crate) fn is_even(a: &Int) -> bool {
    a.is_even()
}

/// How often 2 divides a; `None` for 0.
pub(crate) fn trailing_zeros(a: &Int) -> Option<u32> {
    a.find_one(0)
}

pub(crate) fn to_i64(a: &Int) -> Option<i64> {
    a.to_i64()
}

pub(crate) fn to_i128(a: &Int) -> Option<i128> {
    a.to_i128()
}

/// a·2^places.
pub(crate) fn shl(a: &Int, places: u32) -> Int {
    (a << places).complete()
}

/// ⌊a/2^places⌋.
pub(crate) fn shr(a: &Int, places: u32) -> Int {
    (a >> places).complete()
}

/// a mod modulus, from 0 to modulus − 1.
pub(crate) fn residue(a: &Int, modulus: u64) -> u64 {
    Int::from(a.rem_euc(Int::from(modulus))).to_u64().expect("less than the modulus")
}
