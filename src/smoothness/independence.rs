//! Masks with linearly independent shifts of φ, and the reduction of others to such.

use super::symbol::{Symbol, quotient};
use crate::exact::{Integer, IntegerPolynomial, RationalPolynomial};

/// A symbol of which the basic limit function φ_0 has linearly independent shifts and is as smooth as φ:
/// φ is a combination of finitely many shifts of φ_0.
///
/// With the greatest common divisor g of the n parts of the symbol, A becomes A(z)·g(z)/g(z^n). Where
/// Φ_M(z^n)/Φ_M(z) divides A for some M > 1 that has no common divisor with n, A is divided by it; Φ_M
/// is the cyclotomic polynomial. Each step lowers the degree. `proofs/THEOREMS.md`, 108.
pub(super) fn independent(symbol: &Symbol) -> Symbol {
    let mut symbol = symbol.clone();
    while let Some(next) = reduced_by_parts(&symbol).or_else(|| reduced_by_cycle(&symbol)) {
        symbol = next;
    }
    symbol
}

/// g(z^n).
fn stretched(g: &IntegerPolynomial, n: usize) -> IntegerPolynomial {
    let mut coefficients = Vec::new();
    for c in g.coefficients() {
        coefficients.resize(coefficients.len().next_multiple_of(n), Integer::zero());
        coefficients.push(c.clone());
    }
    IntegerPolynomial::new(coefficients)
}

fn reduced_by_parts(symbol: &Symbol) -> Option<Symbol> {
    let (n, p) = (symbol.arity(), symbol.polynomial());
    let part = |e: usize| {
        IntegerPolynomial::new(
            p.numerator().coefficients().iter().skip(e).step_by(n).cloned().collect(),
        )
    };
    let zero = IntegerPolynomial::default();
    let g = (0..n).map(part).fold(zero, |gcd, part| gcd.gcd(&part));
    if g.degree()? == 0 {
        return None;
    }
    exchanged(symbol, &g)
}

fn reduced_by_cycle(symbol: &Symbol) -> Option<Symbol> {
    let n = symbol.arity();
    // The factors of σ are no factors of the polynomials that are looked for.
    let (_, rest) = symbol.sum_rules();
    // φ(M)(n − 1) is at most the degree, and φ(M) ≥ √(M/2).
    let most = rest.polynomial().degree()? / (n - 1);
    let totients = totients(2 * most * most);
    let orders = (2..totients.len()).filter(|&m| totients[m] <= most && gcd(m, n) == 1);
    let cycle = |m: &usize| exchanged(&rest, &cyclotomic(*m)).is_some();
    let m = orders.into_iter().find(cycle)?;
    exchanged(symbol, &cyclotomic(m))
}

/// A·g(z)/g(z^n), if that is a polynomial.
fn exchanged(symbol: &Symbol, g: &IntegerPolynomial) -> Option<Symbol> {
    let product = symbol.polynomial().times(&RationalPolynomial::over(g, &Integer::one()));
    let reduced = quotient(&product, &stretched(g, symbol.arity()))?;
    Some(Symbol::new(symbol.arity(), symbol.powers().0, &reduced))
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// φ(0), …, φ(last), by a sieve.
fn totients(last: usize) -> Vec<usize> {
    let mut totients: Vec<usize> = (0..=last).collect();
    for p in 2..=last {
        if totients[p] == p {
            for multiple in (p..=last).step_by(p) {
                totients[multiple] -= totients[multiple] / p;
            }
        }
    }
    totients
}

/// Φ_m: x^m − 1 over Φ_d for all d < m that divide m.
fn cyclotomic(m: usize) -> IntegerPolynomial {
    let mut coefficients = vec![Integer::zero(); m + 1];
    coefficients[0] = -Integer::one();
    coefficients[m] = Integer::one();
    let whole = IntegerPolynomial::new(coefficients);
    let divisors = (1..m).filter(|&d| m.is_multiple_of(d));
    divisors.fold(whole, |rest, d| rest.div_rem(&cyclotomic(d)).1.primitive())
}
