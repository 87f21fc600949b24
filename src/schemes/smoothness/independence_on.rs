//! For which values of a parameter the shifts of the basic limit function are linearly independent.

use super::family::{Coefficients, divided};
use super::independence::cyclotomic;
use crate::exact::{IntegerPolynomial, Rational, RationalPolynomial, determinant};
use std::collections::BTreeSet;

/// The greatest order of roots of unity on a cycle that is looked at.
const MAX_ORDER: usize = 1 << 14;

/// The most rows of a determinant.
const MAX_ROWS: usize = 40;

/// Polynomials in the parameter: where none of them is 0, the shifts are linearly independent. The coefficients of the symbol come from the constant term
/// upwards. `None` where no such polynomials are found: the shifts may be dependent for all values.
///
/// A zero that all n parts of the symbol have in common is one of the first part and of each other one, and their resultant is 0. On a cycle of z ↦ z^n of
/// roots of unity of order m, of which A(wω) = 0 for all ω ≠ 1, ω^n = 1, and on the conjugate one, there are all primitive roots of this order, if
/// the powers of n and their negatives are all units mod m. Then Φ_{md} divides A for all d > 1 that divide n. Otherwise the resultant of A and Φ_{mp} is 0, p > 1 the
/// least divisor of n. A cycle and its conjugate with L elements take L(n − 1) zeros of A. `proofs/THEOREMS.md`, 108 and 121.
///
/// ```
/// use subcert::exact::{Rational, RationalPolynomial};
/// use subcert::smoothness::independence_conditions;
///
/// // w + (1 − w)z + (1 − w)z² + wz³: at w = 1/2 it is (1 + z)(1 + z²)/2.
/// let linear = |a: i64, b: i64| RationalPolynomial::new(&[a, b].map(Rational::from));
/// let mask = [linear(0, 1), linear(1, -1), linear(1, -1), linear(0, 1)];
/// let all = independence_conditions(&mask, 2).expect("independent for most w");
/// let holds = |w: &Rational| all.iter().all(|p| p.sign_at(w) != 0);
/// assert!(holds(&Rational::new(1, 4)) && !holds(&Rational::new(1, 2)));
/// ```
#[must_use]
pub fn independence_conditions(
    symbol: &[RationalPolynomial],
    n: usize,
) -> Option<Vec<RationalPolynomial>> {
    let start = symbol.iter().position(|a| !a.is_zero())?;
    let end = symbol.iter().rposition(|a| !a.is_zero())?;
    let symbol = &symbol[start..=end];
    let part = |e: usize| -> Coefficients { symbol.iter().skip(e).step_by(n).cloned().collect() };
    let first = trimmed(part(0));
    let mut common = RationalPolynomial::constant(Rational::zero());
    for e in 1..n {
        let other = trimmed(part(e));
        if first.is_empty() || other.is_empty() {
            return None;
        }
        common = greatest_common(&common, &resultant(&first, &other)?);
    }
    let mut conditions = vec![common];
    for m in orders((symbol.len() - 1) / (n - 1), n)? {
        conditions.push(cycle(symbol, n, m)?);
    }
    (!conditions.iter().any(RationalPolynomial::is_zero)).then_some(conditions)
}

/// The orders of roots of unity other than 1 that have at most so many images under z ↦ z^n, all on a cycle.
fn orders(most: usize, n: usize) -> Option<BTreeSet<usize>> {
    let mut orders = BTreeSet::new();
    let mut power = 1_usize;
    for _ in 0..most {
        power = power.checked_mul(n).filter(|power| *power <= MAX_ORDER)?;
        orders.extend((2..power).filter(|m| (power - 1).is_multiple_of(*m)));
    }
    Some(orders)
}

/// A polynomial in the parameter that is 0 where A vanishes as it should at a cycle of roots of unity of order m.
fn cycle(symbol: &[RationalPolynomial], n: usize, m: usize) -> Option<RationalPolynomial> {
    let monic = |order: usize| -> Vec<Rational> {
        cyclotomic(order).coefficients().iter().map(|c| Rational::from(c.clone())).collect()
    };
    let (mut known, mut power) = (BTreeSet::new(), 1);
    while known.insert(power) {
        known.insert(m - power);
        power = power * n % m;
    }
    if known.len() * (n - 1) >= symbol.len() {
        return Some(RationalPolynomial::constant(Rational::one()));
    }
    let units = (1..m).filter(|k| num_integer::gcd(*k, m) == 1).count();
    let divisors = (2..=n).filter(|d| n.is_multiple_of(*d));
    if known.len() == units {
        let rests = divisors.flat_map(|d| divided(symbol, &monic(m * d)).1);
        let zero = RationalPolynomial::constant(Rational::zero());
        return Some(rests.fold(zero, |common, rest| greatest_common(&common, &rest)));
    }
    let least = divisors.min()?;
    let whole = |c: &Rational| RationalPolynomial::constant(c.clone());
    resultant(symbol, &monic(m * least).iter().map(whole).collect::<Coefficients>())
}

fn trimmed(mut part: Coefficients) -> Coefficients {
    while part.last().is_some_and(RationalPolynomial::is_zero) {
        part.pop();
    }
    // A factor z has no other zero.
    part.drain(..part.iter().take_while(|c| c.is_zero()).count());
    part
}

/// The greatest common divisor, up to a number.
fn greatest_common(p: &RationalPolynomial, q: &RationalPolynomial) -> RationalPolynomial {
    let common: IntegerPolynomial = p.numerator().gcd(q.numerator());
    RationalPolynomial::over(&common, &1.into())
}

/// The resultant of two polynomials in z, by its values at integers.
fn resultant(p: &[RationalPolynomial], q: &[RationalPolynomial]) -> Option<RationalPolynomial> {
    let [a, b] = [p.len() - 1, q.len() - 1];
    let degree = |p: &[RationalPolynomial]| p.iter().filter_map(RationalPolynomial::degree).max();
    let most = b * degree(p)? + a * degree(q)?;
    if a + b > MAX_ROWS {
        return None;
    }
    let value = |at: usize| {
        let at = Rational::from(at);
        let [p, q] = [p, q].map(|p| p.iter().map(|c| c.value_at(&at)).collect::<Vec<Rational>>());
        let row = |p: &[Rational], shift: usize| {
            let mut row = vec![Rational::zero(); a + b];
            row[shift..shift + p.len()].clone_from_slice(p);
            row
        };
        let rows = (0..b).map(|shift| row(&p, shift)).chain((0..a).map(|shift| row(&q, shift)));
        determinant(&rows.collect::<Vec<Vec<Rational>>>())
    };
    let mut differences: Vec<Rational> = (0..=most).map(value).collect();
    // Newton's form Σ_k Δ^k binomial(x, k).
    let mut sum = RationalPolynomial::constant(Rational::zero());
    let mut basis = RationalPolynomial::constant(Rational::one());
    for k in 0..=most {
        let first = RationalPolynomial::constant(differences[0].clone());
        sum = sum.plus(&basis.times(&first));
        differences = differences.windows(2).map(|two| &two[1] - &two[0]).collect();
        let over = Rational::from(k + 1);
        let next = [Rational::zero() - Rational::from(k) / &over, over.recip()];
        basis = basis.times(&RationalPolynomial::new(&next));
    }
    Some(sum)
}
