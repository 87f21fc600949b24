//! Eigenvalues of single products, exactly.

use super::matrix_set::{MatrixSet, echelon, row_times};
use crate::exact::{
    Enclosed as _, Rational, RealAlgebraic, characteristic_polynomial, symmetric_square_polynomial,
};

/// The largest absolute value of a real eigenvalue of a product; `None` where it has none other than 0.
pub(super) fn largest_real(set: &MatrixSet, word: &[usize]) -> Option<RealAlgebraic> {
    let polynomial = characteristic_polynomial(&set.product(word));
    let roots = RealAlgebraic::roots_of(&polynomial);
    let least = roots.first().filter(|root| root.sign() < 0).map(negated);
    let greatest = roots.last().filter(|root| root.sign() > 0).cloned();
    least.into_iter().chain(greatest).max()
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
    let found = crate::exact::SturmSequence::new(&mirrored).roots_between(Some(-high), Some(-low));
    // The ends are no roots unless the number is rational, so that just one root is between them.
    found.into_iter().next().expect("the mirrored root")
}

/// The square of the spectral radius of a product, which may have no real eigenvalue.
pub(super) fn square_of_radius(set: &MatrixSet, word: &[usize]) -> Option<RealAlgebraic> {
    let polynomial = symmetric_square_polynomial(&set.product(word));
    RealAlgebraic::roots_of(&polynomial).pop().filter(|root| root.sign() > 0)
}

/// Which eigenvalue bounds the radius from below.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A positive one.
    Positive,
    /// A negative one.
    Negative,
    /// The product of two conjugate ones.
    Conjugate,
}

/// A rational number q > 0 that a real eigenvalue of a product, of minus the product, or of the product on
/// symmetric tensors reaches, as the sign of the characteristic polynomial at q shows.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Eigenvalue {
    /// Which of the three.
    pub kind: Kind,
    /// q: ϱ^l ≥ q for l factors, or ϱ^{2l} ≥ q.
    pub at_least: Rational,
}

/// The eigenvalue of a product that is next to `root`, by a sign; `None` where no sign shows it.
pub(super) fn shown(
    set: &MatrixSet,
    word: &[usize],
    root: &RealAlgebraic,
    conjugate: bool,
) -> Option<Eigenvalue> {
    let at_least = root.enclosure(0).lower().clone();
    if at_least.sign() <= 0 {
        return None;
    }
    let product = set.product(word);
    if conjugate {
        let shows = symmetric_square_polynomial(&product).sign_at(&at_least) <= 0;
        return shows.then_some(Eigenvalue { kind: Kind::Conjugate, at_least });
    }
    let polynomial = characteristic_polynomial(&product);
    if polynomial.sign_at(&at_least) <= 0 {
        return Some(Eigenvalue { kind: Kind::Positive, at_least });
    }
    let mirrored = polynomial.sign_at(&-&at_least);
    let shows = if product.len().is_multiple_of(2) { mirrored <= 0 } else { mirrored >= 0 };
    shows.then_some(Eigenvalue { kind: Kind::Negative, at_least })
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
pub fn jordan_block(set: &MatrixSet, q: &Rational, longest: usize) -> Option<JordanBlock> {
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

fn is_defective(matrix: &[Vec<Rational>], eigenvalue: &Rational) -> bool {
    let mut shifted = matrix.to_vec();
    for (i, row) in shifted.iter_mut().enumerate() {
        row[i] -= eigenvalue;
    }
    let rank = echelon(shifted.clone()).len();
    if rank == matrix.len() {
        return false;
    }
    let square = shifted.iter().map(|row| row_times(row, &shifted)).collect();
    echelon(square).len() < rank
}
