//! Roots of quadratic polynomials by their formula.

use crate::exact::{Integer, Rational, RealAlgebraic};

/// The most binary digits of a discriminant whose squares are looked for.
const MAX_BITS: u64 = 40;

/// The greatest number whose square is looked for in it.
const MAX_FACTOR: i64 = 4_096;

/// A root of a·x² + b·x + c as `(1 + √73)/4`; `None` for a number of another degree, or with a long discriminant.
pub(crate) fn radical(number: &RealAlgebraic) -> Option<String> {
    let minimal = number.minimal_polynomial()?;
    let [c, b, a] = minimal.coefficients() else { return None };
    let mut radicand = b * b - &(&Integer::from(4) * &(a * c));
    if radicand.bits() > MAX_BITS {
        return None;
    }
    // b² − 4ac = s²·radicand.
    let mut s = Integer::one();
    for factor in 2..=MAX_FACTOR {
        let square = Integer::from(factor * factor);
        if square > radicand {
            break;
        }
        while let (quotient, rest) = radicand.div_rem_floor(&square)
            && rest.is_zero()
        {
            radicand = quotient;
            s = &s * &Integer::from(factor);
        }
    }
    let below = &Integer::from(2) * a;
    let middle = Rational::new(-b, below.clone());
    let shared = b.gcd(&s).gcd(&below);
    let part = |x: &Integer| x.div_floor(&shared);
    let (p, q, below) = (part(&-b), part(&s), part(&below).abs());
    let p = if a.sign() < 0 { -p } else { p };
    let root =
        if q == Integer::one() { format!("√{radicand}") } else { format!("{q}√{radicand}") };
    let greater = number.cmp_rational(&middle).is_gt();
    let sum = match (p.is_zero(), greater) {
        (true, true) => root,
        (true, false) => format!("-{root}"),
        (false, true) => format!("{p} + {root}"),
        (false, false) => format!("{p} - {root}"),
    };
    Some(match (below == Integer::one(), p.is_zero()) {
        (true, _) => sum,
        (false, true) => format!("{sum}/{below}"),
        (false, false) => format!("({sum})/{below}"),
    })
}
