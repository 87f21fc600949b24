//! Signs of polynomials on intervals, by Sturm's theorem.

use crate::decimal::Q;
use num_traits::{Signed, Zero};

/// p(x), for coefficients from the constant up.
fn at(p: &[Q], x: &Q) -> Q {
    p.iter().rev().fold(Q::zero(), |sum, coefficient| sum * x + coefficient)
}

fn trim(p: &mut Vec<Q>) {
    while p.last().is_some_and(Zero::is_zero) {
        p.pop();
    }
}

/// Quotient and remainder of p by a divisor with a leading coefficient ≠ 0.
fn divide(mut p: Vec<Q>, divisor: &[Q]) -> (Vec<Q>, Vec<Q>) {
    let mut quotient = vec![Q::zero(); (p.len() + 1).saturating_sub(divisor.len())];
    for i in (0..quotient.len()).rev() {
        quotient[i] = &p[i + divisor.len() - 1] / &divisor[divisor.len() - 1];
        for (j, coefficient) in divisor.iter().enumerate() {
            let product = &quotient[i] * coefficient;
            p[i + j] -= product;
        }
    }
    trim(&mut p);
    (quotient, p)
}

/// The sign of p at x, or as x goes to ±∞.
fn sign_at(p: &[Q], x: Option<&Q>, below: bool) -> i8 {
    let value = match (x, p.last()) {
        (Some(x), _) => at(p, x),
        (None, Some(last)) if below && p.len().is_multiple_of(2) => -last.clone(),
        (None, Some(last)) => last.clone(),
        (None, None) => Q::zero(),
    };
    if value.is_zero() {
        0
    } else if value.is_positive() {
        1
    } else {
        -1
    }
}

/// The number of distinct roots of p between low and high, neither of which is one.
fn roots_between(p: &[Q], low: Option<&Q>, high: Option<&Q>) -> usize {
    // Sturm's chain: p, p′, and then minus the remainders.
    let derivative = p.iter().enumerate().skip(1);
    let derivative = derivative.map(|(i, c)| c * Q::from_integer(i.into())).collect();
    let mut chain = vec![p.to_vec(), derivative];
    while let [.., before, last] = &chain[..] {
        if last.is_empty() {
            chain.pop();
            break;
        }
        let (_, remainder) = divide(before.clone(), last);
        chain.push(remainder.into_iter().map(|c| -c).collect());
    }
    let changes = |x: Option<&Q>, below: bool| {
        let signs = chain.iter().map(|p| sign_at(p, x, below)).filter(|sign| *sign != 0);
        let signs: Vec<i8> = signs.collect();
        signs.windows(2).filter(|pair| pair[0] != pair[1]).count()
    };
    changes(low, true).saturating_sub(changes(high, false))
}

/// The sign of p on the open interval from low to high; `None` when it has several.
pub fn sign_on(p: &[Q], low: Option<&Q>, high: Option<&Q>) -> Option<i8> {
    let mut p = p.to_vec();
    trim(&mut p);
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
    if roots_between(&p, low, high) > 0 {
        return None;
    }
    // Without a root between, p has the sign that it has next to either end.
    Some(turned * sign_at(&p, low, true))
}
