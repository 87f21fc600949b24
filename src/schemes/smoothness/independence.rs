//! Masks with linearly independent shifts of φ, and the reduction of others to such.

use super::symbol::Symbol;
use crate::exact::{
    Integer, IntegerPolynomial, Rational, Real, Scalar, divided, greatest_divisor, square_free,
    stretched,
};

/// A symbol of which the basic limit function φ_0 has linearly independent shifts and is as smooth as φ:
/// φ is a combination of finitely many shifts of φ_0.
///
/// With the greatest common divisor g of the n parts of the symbol, A becomes A(z)·g(z)/g(z^n). So it does with
/// a polynomial g whose roots are roots of unity of one order, and are permuted by z ↦ z^n, where g(z^n) divides A·g.
/// Each step lowers the degree. `proofs/THEOREMS.md`, 108 and 121.
pub(super) fn independent<F: Real + PartialEq>(symbol: &Symbol<F>) -> Symbol<F> {
    let (mut symbol, n) = (symbol.clone(), symbol.arity());
    let next = |symbol: &Symbol<F>| {
        let Dependence { g, .. } = dependence(&[symbol.coefficients().to_vec()], n)?;
        exchanged(symbol.coefficients(), &g, n)
    };
    while let Some(coefficients) = next(&symbol) {
        symbol = Symbol::new(n, symbol.powers().0, coefficients);
    }
    symbol
}

/// Whether the shifts of the basic limit function are linearly independent: all of them, over the whole line.
///
/// ```
/// use subcert::scheme::parse_scheme;
/// use subcert::smoothness::{Symbol, is_independent};
///
/// let of = |text| is_independent(&Symbol::of(parse_scheme(text).unwrap().masks()[0]));
/// assert!(of("chaikin"));
/// // A third of the box of the length 3.
/// assert!(!of("1 + z^3"));
/// ```
#[must_use]
pub fn is_independent<F: Real + PartialEq>(symbol: &Symbol<F>) -> bool {
    independent(symbol) == *symbol
}

/// What shows that shifts are linearly dependent.
pub(super) struct Dependence<F> {
    /// A monic polynomial for which g(z^n) divides A·g.
    pub(super) g: Vec<F>,
    /// Whether the roots of g are elements of cycles of z ↦ z^n; otherwise g(z^n) divides A.
    pub(super) cycles: bool,
}

/// The next polynomial for which all of these symbols are reduced.
pub(super) fn dependence<F: Real + PartialEq>(
    symbols: &[Vec<F>],
    n: usize,
) -> Option<Dependence<F>> {
    let all = || (0..n).flat_map(|e| symbols.iter().map(move |symbol| (e, symbol)));
    let part = |(e, symbol): (usize, &Vec<F>)| -> Vec<F> {
        symbol.iter().skip(e).step_by(n).cloned().collect()
    };
    let g = all().map(part).fold(Vec::new(), |gcd, part| greatest_divisor(&gcd, &part));
    if g.len() > 1 {
        return Some(Dependence { g, cycles: false });
    }
    Some(Dependence { g: of_cycles(symbols, n)?, cycles: true })
}

/// The elements of cycles of z ↦ z^n, of the least order of which there are some, all of whose other preimages are
/// zeros of the symbols.
fn of_cycles<F: Real + PartialEq>(symbols: &[Vec<F>], n: usize) -> Option<Vec<F>> {
    let closed = closed_part(symbols, n);
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
    orders.map(of_order).find(|g| g.len() > 1)
}

/// The polynomial of the z ≠ 1 such that for all w = z, z^n, z^{n²}, …, A(wω) = 0 for all ω ≠ 1 with ω^n = 1.
///
/// With the parts A_e, A(wω) = Σ ω^e·w^eA_e(w^n). So this holds if and only if all w^eA_e(w^n) are one number.
fn closed_part<F: Real + PartialEq>(symbols: &[Vec<F>], n: usize) -> Vec<F> {
    let difference = |(e, symbol): (usize, &Vec<F>)| -> Vec<F> {
        let coefficient = |(i, a): (usize, &F)| match i % n {
            class if class == e => a.clone(),
            class if class == e + 1 => F::zero().minus(a),
            _ => F::zero(),
        };
        symbol.iter().enumerate().map(coefficient).collect()
    };
    let all = (0..n - 1).flat_map(|e| symbols.iter().map(move |symbol| (e, symbol)));
    let differences = all.map(difference);
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

/// A·g(z)/g(z^n) for a monic g, if that is a polynomial.
pub(super) fn exchanged<P: Scalar + PartialEq>(symbol: &[P], g: &[P], n: usize) -> Option<Vec<P>> {
    let degree = g.len() - 1;
    let mut rest = vec![P::zero(); symbol.len() + degree];
    for (i, a) in symbol.iter().enumerate() {
        for (j, c) in g.iter().enumerate() {
            rest[i + j].accumulate(&a.times(c));
        }
    }
    let low = n * degree;
    for i in (low..rest.len()).rev() {
        let c = rest[i].clone();
        for (j, g) in g[..degree].iter().enumerate() {
            rest[i - low + n * j].lessen(&c.times(g));
        }
    }
    let quotient = rest.split_off(low.min(rest.len()));
    let zero = P::zero();
    rest.iter().all(|x| *x == zero).then_some(quotient)
}

fn gcd(a: usize, b: usize) -> usize {
    if b == 0 { a } else { gcd(b, a % b) }
}

/// Φ_m: x^m − 1 over Φ_d for all d < m that divide m.
pub(super) fn cyclotomic(m: usize) -> IntegerPolynomial {
    let mut coefficients = vec![Integer::zero(); m + 1];
    coefficients[0] = -Integer::one();
    coefficients[m] = Integer::one();
    let whole = IntegerPolynomial::new(coefficients);
    let divisors = (1..m).filter(|&d| m.is_multiple_of(d));
    divisors.fold(whole, |rest, d| rest.div_rem(&cyclotomic(d)).1.primitive())
}
