//! The greatest common divisor by Lehmer's algorithm (Knuth 1997, 4.5.2, Algorithm L):
//! several steps of Euclid's algorithm are computed from the leading bits and applied to
//! the whole numbers at once. The function of num-bigint proceeds bit by bit.

use crate::exact::word;
use num_bigint::BigUint;

/// The number of leading bits that the steps are computed from.
const LEADING: u32 = 62;

pub(super) fn gcd(a: &BigUint, b: &BigUint) -> BigUint {
    let (mut a, mut b) = (a.to_u64_digits(), b.to_u64_digits());
    if (a.len(), a.last()) < (b.len(), b.last()) {
        (a, b) = (b, a);
    }
    loop {
        match b[..] {
            [] => return number(&a),
            [b] => {
                let rest = (number(&a) % b).to_u64_digits().first().copied().unwrap_or(0);
                return word::gcd(rest, b).into();
            }
            _ => {}
        }
        match steps(&a, &b) {
            Some([first, second]) => {
                (a, b) = (combination(first, &a, &b), combination(second, &a, &b));
            }
            // The leading bits do not determine the first quotient: one full division.
            None => {
                (a, b) = {
                    let rest = (number(&a) % number(&b)).to_u64_digits();
                    (b, rest)
                }
            }
        }
    }
}

/// The effect of several steps of Euclid's algorithm on (a, b): coefficients \[x, y\] of
/// the two combinations x·a + y·b that result. `None` when the leading bits do not
/// determine the first quotient.
fn steps(a: &[u64], b: &[u64]) -> Option<[[i64; 2]; 2]> {
    let (mut high, mut low) = (leading(a, a)?, leading(b, a)?);
    let (mut first, mut second) = ([1, 0], [0, 1]);
    // The missing low bits leave an interval for the fraction a/b. The quotient is
    // determined when both ends of this interval give the same one.
    while low + second[0] != 0 && low + second[1] != 0 {
        let quotient = (high + first[0]) / (low + second[0]);
        if quotient != (high + first[1]) / (low + second[1]) {
            break;
        }
        (high, low) = (low, high - quotient * low);
        let next = [first[0] - quotient * second[0], first[1] - quotient * second[1]];
        (first, second) = (second, next);
    }
    (first[1] != 0).then_some([first, second])
}

/// The bits of `digits` at the places of the LEADING leading bits of `longer`.
fn leading(digits: &[u64], longer: &[u64]) -> Option<i64> {
    let at = |place: usize| digits.get(place).copied().unwrap_or(0);
    let (last, top) = (longer.len() - 1, longer.last()?);
    let window = u128::from(at(last)) << 64 | u128::from(at(last - 1));
    i64::try_from(window >> (128 - LEADING - top.leading_zeros())).ok()
}

/// x·a + y·b, which is not negative.
fn combination([x, y]: [i64; 2], a: &[u64], b: &[u64]) -> Vec<u64> {
    let (x, y) = (i128::from(x), i128::from(y));
    let digits = b.iter().chain(std::iter::repeat(&0));
    let mut carry = 0_i128;
    let mut sum: Vec<u64> = Vec::with_capacity(a.len());
    for (a, b) in a.iter().zip(digits) {
        // x and y have opposite signs, so the sum is below 2^126.
        carry += x * i128::from(*a) + y * i128::from(*b);
        sum.push(low_digit(carry));
        carry >>= 64;
    }
    while sum.last() == Some(&0) {
        sum.pop();
    }
    sum
}

fn low_digit(value: i128) -> u64 {
    let low = value.cast_unsigned() & u128::from(u64::MAX);
    u64::try_from(low).expect("64 bits")
}

fn number(digits: &[u64]) -> BigUint {
    let halves = digits.iter().flat_map(|digit| [digit & 0xffff_ffff, digit >> 32]);
    BigUint::new(halves.map(|half| u32::try_from(half).expect("32 bits")).collect())
}
