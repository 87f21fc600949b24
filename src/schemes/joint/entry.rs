//! The numbers that may be entries of matrices: rational, or of one real field Q(α).

use super::matrix_set::{Matrix, MatrixSet};
use crate::exact::{Enclosed, FieldElement, IntegerPolynomial, Rational, Real, RealAlgebraic};
use std::fmt::Display;

/// The greatest degree of the field in which a hull for rational matrices is verified.
const MAX_DEGREE: usize = 12;

/// Rational matrices, or matrices over one real field.
pub trait Entry: Real + PartialOrd + Enclosed + Display + std::fmt::Debug {
    /// −1, 0 or 1.
    fn signum(&self) -> i8;

    /// The distinct real roots of a polynomial with these coefficients, not all 0, from the constant term upwards, in
    /// increasing order; `None` beyond the caps.
    fn real_roots(coefficients: &[Self]) -> Option<Vec<RealAlgebraic>>;

    /// These matrices, and a real root of a polynomial, over one field; `None` beyond the caps.
    fn with_root(
        set: &MatrixSet<Self>,
        coefficients: &[Self],
        root: &RealAlgebraic,
    ) -> Option<(MatrixSet<FieldElement>, FieldElement)>;

    /// The same set, if all matrices of this kind are rational.
    fn rational(set: &MatrixSet<Self>) -> Option<&MatrixSet>;
}

impl Entry for Rational {
    fn signum(&self) -> i8 {
        self.sign()
    }

    fn real_roots(coefficients: &[Rational]) -> Option<Vec<RealAlgebraic>> {
        let polynomial = IntegerPolynomial::over_common_denominator(coefficients);
        Some(RealAlgebraic::roots_of(&polynomial))
    }

    fn with_root(
        set: &MatrixSet,
        _: &[Rational],
        root: &RealAlgebraic,
    ) -> Option<(MatrixSet<FieldElement>, FieldElement)> {
        use crate::exact::Scalar as _;
        if root.minimal_polynomial()?.degree()? > MAX_DEGREE {
            return None;
        }
        Some((set.map(FieldElement::from_rational), FieldElement::generator(root)?))
    }

    fn rational(set: &MatrixSet) -> Option<&MatrixSet> {
        Some(set)
    }
}

impl Entry for FieldElement {
    fn signum(&self) -> i8 {
        self.sign()
    }

    fn real_roots(coefficients: &[FieldElement]) -> Option<Vec<RealAlgebraic>> {
        FieldElement::real_roots(coefficients).ok()
    }

    fn with_root(
        set: &MatrixSet<FieldElement>,
        coefficients: &[FieldElement],
        root: &RealAlgebraic,
    ) -> Option<(MatrixSet<FieldElement>, FieldElement)> {
        let (inside, root) = FieldElement::adjoined(coefficients, root).ok()?;
        // The entries follow the coefficients into the field of the root.
        let entries = set.matrices().iter().flatten().flatten().cloned();
        let all: Vec<FieldElement> = [root].into_iter().chain(inside).chain(entries).collect();
        let mut all = FieldElement::together(&all).ok()?.into_iter();
        let root = all.next()?;
        let mut entries = all.skip(coefficients.len());
        let matrices: Option<Vec<Matrix<FieldElement>>> = set
            .matrices()
            .iter()
            .map(|rows| {
                rows.iter().map(|row| row.iter().map(|_| entries.next()).collect()).collect()
            })
            .collect();
        Some((MatrixSet::new(matrices?).ok()?, root))
    }

    fn rational(_: &MatrixSet<FieldElement>) -> Option<&MatrixSet> {
        None
    }
}
