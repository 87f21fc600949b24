//! Polynomials in one variable, from the constant coefficient up, and their signs by Sturm's
//! theorem.

use crate::decimal::Q;
use num_traits::{Num, Signed, Zero};

/// Quotient and remainder by a divisor whose leading coefficient divides all that it has to.
pub fn divide<T: Num + Clone>(mut p: Vec<T>, divisor: &[T]) -> (Vec<T>, Vec<T>) {
    let degree = divisor.len() - 1;
    let mut quotient = vec![T::zero(); p.len().saturating_sub(degree)];
    for i in (0..quotient.len()).rev() {
        quotient[i] = p[i + degree].clone() / divisor[degree].clone();
        for (j, coefficient) in divisor.iter().enumerate() {
            p[i + j] = p[i + j].clone() - quotient[i].clone() * coefficient.clone();
        }
    }
    p.truncate(degree);
    (quotient, p)
}

/// Without coefficients 0 at the end.
fn trimmed(mut p: Vec<Q>) -> Vec<Q> {
    while p.last().is_some_and(Zero::is_zero) {
        p.pop();
    }
    p
}

/// −1, 0 or 1.
pub fn signum<T: Signed>(value: &T) -> i8 {
    i8::from(value.is_positive()) - i8::from(value.is_negative())
}

/// p(x).
fn at(p: &[Q], x: &Q) -> Q {
    p.iter().rev().fold(Q::zero(), |sum, coefficient| sum * x + coefficient)
}

/// The sign of p at x, or as x goes to −∞ (`below`) or ∞.
fn sign_at(p: &[Q], x: Option<&Q>, below: bool) -> i8 {
    match (x, p.last()) {
        (Some(x), _) => signum(&at(p, x)),
        (None, Some(last)) if below && p.len().is_multiple_of(2) => -signum(last),
        (None, last) => last.map_or(0, signum),
    }
}

/// The number of distinct roots of p between low and high, neither of which is one.
fn roots_between(p: &[Q], low: Option<&Q>, high: Option<&Q>) -> usize {
    // Sturm's chain: p, p′, and then minus the remainders.
    let powers = (1_i64..).map(|i| Q::from_integer(i.into()));
    let mut chain = vec![p.to_vec(), p[1..].iter().zip(powers).map(|(c, i)| c * i).collect()];
    while let [.., before, last] = &chain[..]
        && !last.is_empty()
    {
        let (_, remainder) = divide(before.clone(), last);
        chain.push(trimmed(remainder).into_iter().map(|c| -c).collect());
    }
    let changes = |x: Option<&Q>, below: bool| {
        let signs = chain.iter().map(|p| sign_at(p, x, below)).filter(|sign| *sign != 0);
        signs.collect::<Vec<i8>>().windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    changes(low, true).saturating_sub(changes(high, false))
}

/// The sign of p on the open interval from low to high; `None` when it has several.
pub fn sign_on(p: &[Q], low: Option<&Q>, high: Option<&Q>) -> Option<i8> {
    let mut p = trimmed(p.to_vec());
    if p.is_empty() {
        return Some(0);
    }
    // Roots at the ends are divided out: x − low is positive on the interval, and
    // x − high negative.
    let mut turned = 1;
    for (end, factor) in [(low, 1), (high, -1)] {
        while let Some(root) = end.filter(|end| at(&p, end).is_zero()) {
            (p, _) = divide(p, &[-root.clone(), Q::from_integer(1.into())]);
            turned *= factor;
        }
    }
    // Without a root between, p has the sign that it has next to either end.
    (roots_between(&p, low, high) == 0).then(|| turned * sign_at(&p, low, true))
}
