//! Masks with linearly independent shifts of φ, and the reduction of others to such.

use super::symbol::Symbol;
use crate::exact::{Integer, IntegerPolynomial, Rational, divided, greatest_divisor, square_free};
use crate::joint::Entry;

/// A symbol of which the basic limit function φ_0 has linearly independent shifts and is as smooth as φ:
/// φ is a combination of finitely many shifts of φ_0.
///
/// With the greatest common divisor g of the n parts of the symbol, A becomes A(z)·g(z)/g(z^n). So it does with
/// a polynomial g whose roots are roots of unity of one order, and are permuted by z ↦ z^n, where g(z^n) divides A·g.
/// Each step lowers the degree. `proofs/THEOREMS.md`, 108 and 121.
pub(super) fn independent<F: Entry>(symbol: &Symbol<F>) -> Symbol<F> {
    let mut symbol = symbol.clone();
    while let Some(next) = reduced_by_parts(&symbol).or_else(|| reduced_by_cycles(&symbol)) {
        symbol = next;
    }
    symbol
}

/// g(z^n).
fn stretched<F: Entry>(g: &[F], n: usize) -> Vec<F> {
    let mut coefficients = Vec::new();
    for c in g {
        coefficients.resize(coefficients.len().next_multiple_of(n), F::zero());
        coefficients.push(c.clone());
    }
    coefficients
}

fn reduced_by_parts<F: Entry>(symbol: &Symbol<F>) -> Option<Symbol<F>> {
    let n = symbol.arity();
    let part = |e: usize| symbol.coefficients().iter().skip(e).step_by(n).cloned().collect();
    let g = (0..n).map(part).fold(Vec::new(), |gcd, part: Vec<F>| greatest_divisor(&gcd, &part));
    if g.len() <= 1 { None } else { exchanged(symbol, &g) }
}

/// The roots of g: the elements of cycles of z ↦ z^n, of the least order of which there are some, all of whose
/// other preimages are zeros of the symbol.
fn reduced_by_cycles<F: Entry>(symbol: &Symbol<F>) -> Option<Symbol<F>> {
    let n = symbol.arity();
    let closed = closed_part(symbol);
    if closed.len() <= 1 {
        return None;
    }
    // The roots are taken into themselves, and not to 0, so that some of them lie on cycles.
    let orders = (2_usize..).filter(|m| gcd(*m, n) == 1);
    let of_order = |m: usize| {
        let whole = |c: &Integer| F::from_rational(&Rational::from(c.clone()));
        let order: Vec<F> = cyclotomic(m).coefficients().iter().map(whole).collect();
        greatest_divisor(&closed, &order)
    };
    let g = orders.map(of_order).find(|g| g.len() > 1)?;
    exchanged(symbol, &g)
}

/// The polynomial of the z ≠ 1 such that for all w = z, z^n, z^{n²}, …, A(wω) = 0 for all ω ≠ 1 with ω^n = 1.
///
/// With the parts A_e, A(wω) = Σ ω^e·w^eA_e(w^n). So this holds if and only if all w^eA_e(w^n) are one number.
fn closed_part<F: Entry>(symbol: &Symbol<F>) -> Vec<F> {
    let n = symbol.arity();
    let difference = |e: usize| -> Vec<F> {
        let coefficient = |(i, a): (usize, &F)| match i % n {
            class if class == e => a.clone(),
            class if class == e + 1 => F::zero().minus(a),
            _ => F::zero(),
        };
        symbol.coefficients().iter().enumerate().map(coefficient).collect()
    };
    let differences = (0..n - 1).map(difference);
    let common = differences.fold(Vec::new(), |gcd, p| greatest_divisor(&gcd, &p));
    let mut closed = square_free(&common);
    let one = F::from_rational(&Rational::one());
    let (without, rest) = divided(&closed, &[F::zero().minus(&one), one]);
    if rest.is_empty() {
        closed = without;
    }
    loop {
        let next = greatest_divisor(&closed, &stretched(&closed, n));
        if next.len() == closed.len() {
            return next;
        }
        closed = next;
    }
}

/// A·g(z)/g(z^n), if that is a polynomial.
fn exchanged<F: Entry>(symbol: &Symbol<F>, g: &[F]) -> Option<Symbol<F>> {
    let mut product = vec![F::zero(); symbol.coefficients().len() + g.len() - 1];
    for (i, a) in symbol.coefficients().iter().enumerate() {
        for (j, c) in g.iter().enumerate() {
            product[i + j].accumulate(&a.times(c));
        }
    }
    let (quotient, rest) = divided(&product, &stretched(g, symbol.arity()));
    let (lowest, _) = symbol.powers();
    rest.is_empty().then(|| Symbol::new(symbol.arity(), lowest, quotient))
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
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
