//! Integer square roots, and square factors.

use crate::exact::{Integer, Rational};

/// Square factors are looked for among the squares of the integers up to this.
const MAX_FACTOR: u32 = 1_000;

/// ⌊√x⌋ for x ≥ 0, by Newton's method from above.
///
/// # Panics
/// When x has more than 2^32 bits.
#[must_use]
pub fn floor_root(x: &Integer) -> Integer {
    if x.is_zero() {
        return Integer::zero();
    }
    let bits = u32::try_from(x.bits()).expect("it fits in memory");
    let mut root = Integer::one().shifted_left(bits.div_ceil(2));
    loop {
        let next = (&root + x.div_floor(&root)).shifted_right(1);
        if next >= root {
            return root;
        }
        root = next;
    }
}

/// (s, t) with x = s²·t for a rational x > 0, s > 0 rational and t a positive integer. t is 1 for the
/// square of a rational, and is divided by the squares of small primes.
pub(in crate::exact) fn square_part(x: &Rational) -> (Rational, Integer) {
    let (mut rest, q) = (x.numerator() * x.denominator(), x.denominator());
    let mut root = Integer::one();
    let whole = floor_root(&rest);
    if &whole * &whole == rest {
        return (Rational::new(whole, q), Integer::one());
    }
    for factor in 2..=MAX_FACTOR {
        let square = Integer::from(factor * factor);
        if square > rest {
            break;
        }
        while rest.residue(factor * factor) == 0 {
            rest = rest.div_floor(&square);
            root *= &Integer::from(factor);
        }
    }
    (Rational::new(root, q), rest)
}
