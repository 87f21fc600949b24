//! Roots of polynomials of degree 2 with functions of an integer as coefficients.

use crate::exact::{IntegerFunction, Rational, Scalar as _};
use std::cmp::Ordering;

/// The roots of a polynomial.
pub(super) struct Roots {
    /// Descending, each as often as it is one.
    pub(super) real: Vec<IntegerFunction>,
    /// The product of two that are not real.
    pub(super) complex: Option<IntegerFunction>,
}

/// p without its factors x, and how many there are.
fn reduced(p: &[IntegerFunction]) -> (&[IntegerFunction], usize) {
    let is_zero = |c: &&IntegerFunction| c.sign().is_some_and(Ordering::is_eq);
    let zeros = p.iter().take_while(is_zero).count();
    (&p[zeros..], zeros)
}

/// p over x − a, if a is a root.
pub(super) fn without(p: &[IntegerFunction], a: &IntegerFunction) -> Option<Vec<IntegerFunction>> {
    let mut quotient = Vec::new();
    let mut carry = IntegerFunction::zero();
    for c in p.iter().rev() {
        carry = carry.times(a).plus(c);
        quotient.push(carry.clone());
    }
    let rest = quotient.pop()?;
    quotient.reverse();
    rest.sign()?.is_eq().then_some(quotient)
}

/// In descending order, if that is known.
pub(super) fn ordered(values: Vec<IntegerFunction>) -> Option<Vec<IntegerFunction>> {
    let mut found: Vec<IntegerFunction> = Vec::new();
    for value in values {
        let mut place = 0;
        while place < found.len() && found[place].minus(&value).sign()?.is_gt() {
            place += 1;
        }
        found.insert(place, value);
    }
    Some(found)
}

/// The first that is shown to be at least as great as each.
pub(super) fn greatest(values: &[IntegerFunction]) -> Option<&IntegerFunction> {
    let is_above = |x: &IntegerFunction, y: &IntegerFunction| {
        x == y || x.minus(y).sign().is_some_and(Ordering::is_ge)
    };
    values.iter().find(|x| values.iter().all(|y| is_above(x, y)))
}

impl Roots {
    /// Those of a polynomial with the leading coefficient 1, of degree at most 2 but for factors x.
    pub(super) fn of(p: &[IntegerFunction]) -> Option<Roots> {
        let (p, zeros) = reduced(p);
        let zero = IntegerFunction::zero();
        let mut real = vec![zero.clone(); zeros];
        let mut complex = None;
        match p {
            [_] => {}
            [a, _] => real.push(zero.minus(a)),
            [b, a, _] => {
                let number = |p, q| IntegerFunction::from_rational(&Rational::new(p, q));
                let discriminant = a.times(a).minus(&b.times(&number(4, 1)));
                if discriminant.sign()?.is_lt() {
                    complex = Some(b.clone());
                } else {
                    let root = discriminant.square_root()?;
                    let half = |x: IntegerFunction| x.times(&number(1, 2));
                    real.extend([half(root.minus(a)), half(zero.minus(a).minus(&root))]);
                }
            }
            _ => return None,
        }
        Some(Roots { real: ordered(real)?, complex })
    }

    /// The absolute values, those of the real roots first, in their order.
    pub(super) fn sizes(&self) -> Option<Vec<IntegerFunction>> {
        let size = |x: &IntegerFunction| match x.sign()? {
            Ordering::Less => Some(IntegerFunction::zero().minus(x)),
            _ => Some(x.clone()),
        };
        let real = self.real.iter().map(size);
        let complex = self.complex.iter().map(IntegerFunction::square_root);
        real.chain(complex).collect()
    }
}

/// Whether the conditions of `proofs/THEOREMS.md`, 145 (c), hold, so that all roots of p are below λ > 0, or at most λ, in absolute value.
pub(super) fn are_within(
    p: &[IntegerFunction],
    lambda: &IntegerFunction,
    holds: fn(Ordering) -> bool,
) -> bool {
    let is = |x: IntegerFunction| x.sign().is_some_and(holds);
    match reduced(p).0 {
        [_] => true,
        [a, _] => is(lambda.plus(a)) && is(lambda.minus(a)),
        [b, a, _] => {
            let square = lambda.times(lambda);
            let (sum, product) = (square.plus(b), lambda.times(a));
            is(square.minus(b)) && is(sum.plus(&product)) && is(sum.minus(&product)) && is(sum)
        }
        _ => false,
    }
}
