//! Eigenvalues of single products, exactly.

use super::entry::Entry;
use super::matrix_set::MatrixSet;
use crate::exact::{
    Enclosed as _, Rational, RealAlgebraic, characteristic_coefficients, echelon, row_times,
    symmetric_square_coefficients, value_at,
};

/// A positive root of a polynomial.
pub(super) struct Root<F> {
    pub(super) root: RealAlgebraic,
    pub(super) polynomial: Vec<F>,
}

/// The largest absolute value of a real eigenvalue of a product; `None` where it has none other than 0, or the
/// roots are beyond the caps.
pub(super) fn largest_real<F: Entry>(set: &MatrixSet<F>, word: &[usize]) -> Option<Root<F>> {
    let polynomial = characteristic_coefficients(&set.product(word));
    let roots = F::real_roots(&polynomial)?;
    let least = roots.first().filter(|root| root.sign() < 0).map(negated);
    let greatest = roots.last().filter(|root| root.sign() > 0).cloned();
    let negative = least > greatest;
    let root = if negative { least? } else { greatest? };
    Some(Root { root, polynomial: if negative { mirrored(polynomial) } else { polynomial } })
}

/// p(−x).
fn mirrored<F: Entry>(mut p: Vec<F>) -> Vec<F> {
    for c in p.iter_mut().skip(1).step_by(2) {
        *c = F::zero().minus(c);
    }
    p
}

/// −α.
fn negated(root: &RealAlgebraic) -> RealAlgebraic {
    if let Some(value) = root.as_rational() {
        return RealAlgebraic::from(-value);
    }
    let polynomial = root.polynomial();
    let signs = [Rational::one(), -Rational::one()];
    let coefficients = polynomial.coefficients().iter().zip(signs.iter().cycle());
    let coefficients: Vec<Rational> =
        coefficients.map(|(c, sign)| Rational::from(c.clone()) * sign).collect();
    let mirrored = crate::exact::IntegerPolynomial::over_common_denominator(&coefficients);
    let (low, high) = root.bounds();
    let found = RealAlgebraic::roots_between(&mirrored, Some(-high), Some(-low));
    // The ends are no roots unless the number is rational, so that just one root is between them.
    found.into_iter().next().expect("the mirrored root")
}

/// The square of the spectral radius of a product, which may have no real eigenvalue.
pub(super) fn square_of_radius<F: Entry>(set: &MatrixSet<F>, word: &[usize]) -> Option<Root<F>> {
    let polynomial = symmetric_square_coefficients(&set.product(word));
    let root = F::real_roots(&polynomial)?.pop().filter(|root| root.sign() > 0)?;
    Some(Root { root, polynomial })
}

/// Which eigenvalue bounds the radius from below.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LeadingEigenvalue {
    /// A positive one.
    Positive,
    /// A negative one.
    Negative,
    /// One of any argument.
    Modulus,
}

/// A rational number q > 0 that a real eigenvalue of a product P, or of −P, or the modulus of an eigenvalue reaches: as the sign of the characteristic
/// polynomial at q shows, or as not all zeros of this polynomial have a modulus below q.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Eigenvalue {
    /// Which of the three.
    pub kind: LeadingEigenvalue,
    /// The factors of P, in the order of multiplication.
    pub product: Vec<usize>,
    /// q: ϱ^l ≥ q for l factors.
    pub at_least: Rational,
}

/// The eigenvalue of a product, or of its square where `root` is that of two conjugate ones, that is next to `root`; `None` where nothing shows it.
pub(super) fn shown<F: Entry>(
    set: &MatrixSet<F>,
    word: &[usize],
    root: &RealAlgebraic,
    conjugate: bool,
) -> Option<Eigenvalue> {
    let at_least = root.enclosure(0).lower().clone();
    if at_least.sign() <= 0 {
        return None;
    }
    let product = if conjugate { word.repeat(2) } else { word.to_vec() };
    let polynomial = characteristic_coefficients(&set.product(&product));
    let at = |x: &Rational| value_at(&polynomial, &F::from_rational(x)).signum();
    let shows = |kind: &LeadingEigenvalue| match kind {
        LeadingEigenvalue::Positive => at(&at_least) <= 0,
        LeadingEigenvalue::Negative if polynomial.len() % 2 == 1 => at(&-&at_least) <= 0,
        LeadingEigenvalue::Negative => at(&-&at_least) >= 0,
        LeadingEigenvalue::Modulus => reaches(&polynomial, &at_least),
    };
    let kinds =
        [LeadingEigenvalue::Positive, LeadingEigenvalue::Negative, LeadingEigenvalue::Modulus];
    let kind = kinds.into_iter().find(shows)?;
    Some(Eigenvalue { kind, product, at_least })
}

/// Whether a zero of a monic polynomial f has a modulus of at least q > 0. By Schur and Cohn all zeros of g(x) = f(qx)/q^n are inside the unit circle if
/// g(0)² < 1, and all of (g(x) − g(0)x^n g(1/x))/x are.
fn reaches<F: Entry>(polynomial: &[F], q: &Rational) -> bool {
    let one = F::from_rational(&Rational::one());
    let inverse = F::from_rational(&q.recip());
    let mut power = one.clone();
    let mut scaled: Vec<F> = Vec::with_capacity(polynomial.len());
    for c in polynomial.iter().rev() {
        scaled.push(c.times(&power));
        power = power.times(&inverse);
    }
    scaled.reverse();
    while scaled.len() > 1 {
        let first = scaled[0].clone();
        let rest = one.minus(&first.times(&first));
        if rest.signum() <= 0 {
            return true;
        }
        let reversed = scaled.iter().rev();
        let next = scaled.iter().zip(reversed).skip(1);
        scaled = next.map(|(c, other)| c.minus(&first.times(other)).over(&rest)).collect();
    }
    false
}

/// A product with a Jordan block of size 2 or more.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct JordanBlock {
    /// The factors, in the order of multiplication.
    pub word: Vec<usize>,
    /// The eigenvalue.
    pub eigenvalue: Rational,
}

/// A product of up to `longest` factors with an eigenvalue ±q^l, l its length, that has a Jordan block of
/// size 2 or more: there the rank of (P − λI)² is less than that of P − λI. The powers of this product
/// then grow faster than q^{lk}.
#[must_use]
pub fn jordan_block<F: Entry>(
    set: &MatrixSet<F>,
    q: &Rational,
    longest: usize,
) -> Option<JordanBlock> {
    let mut words = vec![Vec::new()];
    for length in 1..=longest {
        let extend = |word: &Vec<usize>| {
            let word = word.clone();
            (0..set.matrices().len()).map(move |i| [&word[..], &[i]].concat())
        };
        words = words.iter().flat_map(extend).collect();
        let power = (1..length).fold(q.clone(), |power, _| power * q);
        for word in &words {
            for eigenvalue in [power.clone(), -&power] {
                if is_defective(&set.product(word), &eigenvalue) {
                    return Some(JordanBlock { word: word.clone(), eigenvalue });
                }
            }
        }
    }
    None
}

fn is_defective<F: Entry>(matrix: &[Vec<F>], eigenvalue: &Rational) -> bool {
    let eigenvalue = F::from_rational(eigenvalue);
    let mut shifted = matrix.to_vec();
    for (i, row) in shifted.iter_mut().enumerate() {
        row[i].lessen(&eigenvalue);
    }
    let rank = echelon(shifted.clone()).0.len();
    if rank == matrix.len() {
        return false;
    }
    let square: Vec<Vec<F>> = shifted.iter().map(|row| row_times(row, &shifted)).collect();
    echelon(square).0.len() < rank
}
