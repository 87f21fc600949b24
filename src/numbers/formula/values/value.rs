//! The types of values of formulas.

use crate::exact::{
    CosineError, FieldElement, Integer, Parametric, Polynomial, QuotientAt, Rational, Real,
    RealCyclotomic, Scalar, common_conductor,
};
use crate::formula::error::FormulaErrorKind;
use crate::formula::root_error::{RootError, rational_root};

/// A type of values of formulas. An operation that the type does not have returns `None`.
pub trait Value: Scalar + std::fmt::Display {
    /// This as a rational number, if it is one.
    fn as_rational(&self) -> Option<Rational>;
    /// This as a number of a field Q(2cos(2π/n)), if it is one.
    fn number(&self) -> Option<RealCyclotomic> {
        self.as_rational().map(RealCyclotomic::from)
    }
    /// This number, if the type has it.
    fn of_number(number: &RealCyclotomic) -> Option<Self> {
        number.as_rational().map(Self::from_rational)
    }
    /// A measure of the cost of an operation on this value, in bits; 0 for values that
    /// stay small.
    fn size(&self) -> u64;
    /// A measure of the cost of self · other, at least the size of the product.
    fn product_size(&self, other: &Self) -> u64 {
        self.size().saturating_add(other.size())
    }
    /// A measure of the cost of one product when a row is multiplied `levels` times by a
    /// matrix of such values.
    fn row_product_size(&self, _levels: u32) -> u64 {
        self.product_size(self)
    }
    /// A measure of the cost of self / divisor, for divisor ≠ 0.
    fn quotient_size(&self, divisor: &Self) -> u64 {
        self.product_size(divisor)
    }
    /// self / divisor, for divisor ≠ 0.
    fn quotient(&self, divisor: &Self) -> Option<Self>;
    /// self / divisor, for divisor ≠ 0.
    ///
    /// # Errors
    /// When the type does not have the quotient.
    fn divided(&self, divisor: &Self) -> Result<Self, FormulaErrorKind> {
        self.quotient(divisor).ok_or(FormulaErrorKind::Unsupported(
            "division by a symbolic parameter is not an identity of polynomials, and by what may be 0 it has no value",
        ))
    }
    /// |self|.
    fn absolute(&self) -> Option<Self>;
    /// The greater of the two.
    fn larger(&self, other: &Self) -> Option<Self>;

    /// ⌊self⌋.
    fn floor(&self) -> Option<Integer> {
        self.as_rational().map(|value| value.floor())
    }

    /// This as a function of a parameter at a place of it, if it is one.
    fn at_place(&self) -> Option<QuotientAt> {
        None
    }
    /// This function of a parameter at a place of it, if the type has it.
    #[must_use]
    fn of_place(_: QuotientAt) -> Option<Self> {
        None
    }

    /// This as a number of some real field, if the type is about these.
    fn element(&self) -> Option<FieldElement> {
        None
    }
    /// This number of a real field, if the type has it.
    #[must_use]
    fn of_element(_: &FieldElement) -> Option<Self> {
        None
    }

    /// Whether this is 0; `None` when the answer depends on a symbol.
    fn vanishes(&self) -> Option<bool> {
        self.as_rational().map(|value| value.is_zero())
    }

    /// cos(2π·`turn`). Types without cosines have only the rational ones.
    ///
    /// # Errors
    /// When the type does not contain this number.
    fn cosine(turn: &Rational) -> Result<Self, CosineError> {
        let cosine = RealCyclotomic::cosine(turn)?;
        match cosine.as_rational() {
            Some(value) => Ok(Self::from_rational(value)),
            None => Err(CosineError::irrational(turn)),
        }
    }

    /// cos(2π·`turn`) for a turn that is no rational number, if the type has it.
    fn cosine_of(_turn: &Self) -> Option<Self> {
        None
    }

    /// The square root, if the type has it without [`root`](Self::root).
    fn square_root(&self) -> Option<Self> {
        None
    }

    /// The real root of this number, counted from 1 in increasing order, of the polynomial with these coefficients, from
    /// the constant term upwards.
    ///
    /// # Errors
    /// When there is no such root, or the type does not contain it.
    fn root(_coefficients: &[Self], _number: i64) -> Result<Self, RootError> {
        Err(RootError::NotHere)
    }

    /// An error unless this and `other` lie in one field within the caps, as they must before they are combined.
    ///
    /// # Errors
    /// When they do not.
    fn meets(&self, other: &Self) -> Result<(), FormulaErrorKind> {
        common_conductor(self.conductor(), other.conductor())?;
        Ok(())
    }

    /// These values in one field.
    ///
    /// # Errors
    /// When no field within the caps has them.
    fn together(values: Vec<Self>) -> Result<Vec<Self>, FormulaErrorKind> {
        values.iter().map(Value::conductor).try_fold(1, common_conductor)?;
        Ok(values)
    }

    /// The conductor n of the field Q(2cos(2π/n)) of this value; 1 for types without such
    /// fields. Before two values are combined, the caller must check that they have a
    /// [`common_conductor`](crate::exact::common_conductor).
    fn conductor(&self) -> u32 {
        1
    }
}

/// The bits counted for each term of a polynomial besides its coefficient.
const TERM_BITS: u64 = 10;

impl Value for Rational {
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        rational_root(coefficients, number)
    }
    fn as_rational(&self) -> Option<Rational> {
        Some(self.clone())
    }
    fn size(&self) -> u64 {
        self.bits()
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self / divisor)
    }
    fn absolute(&self) -> Option<Self> {
        Some(self.abs())
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(self.max(other).clone())
    }
}

impl Value for Polynomial {
    fn as_rational(&self) -> Option<Rational> {
        self.as_constant()?.as_rational().cloned()
    }
    fn number(&self) -> Option<RealCyclotomic> {
        self.as_constant()
    }
    fn of_number(number: &RealCyclotomic) -> Option<Self> {
        Some(Polynomial::constant(number.clone()))
    }
    fn size(&self) -> u64 {
        let bits = self.coefficients().map(|c| TERM_BITS + c.bits()).sum();
        self.degree().max(bits)
    }
    fn product_size(&self, other: &Self) -> u64 {
        // Every coefficient of `self` is multiplied by every coefficient of `other`.
        let (left, right) = (self.term_count() as u64, other.term_count() as u64);
        let bits = |p: &Polynomial| p.coefficients().map(RealCyclotomic::bits).sum::<u64>();
        let terms = |p: &Polynomial| p.coefficients().map(|c| c.term_count() as u64).sum::<u64>();
        let bits = left
            .saturating_mul(right.saturating_mul(TERM_BITS) + bits(other))
            .saturating_add(right.saturating_mul(bits(self)))
            .saturating_add(terms(self).saturating_mul(terms(other)));
        bits.max(self.degree() + other.degree())
    }
    fn quotient_size(&self, divisor: &Self) -> u64 {
        let inverse = divisor.as_constant().map_or(0, |divisor| divisor.recip_cost());
        self.product_size(divisor).saturating_add(inverse)
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        let inverse = &RealCyclotomic::from(1) / &divisor.as_constant()?;
        Some(self * &Polynomial::constant(inverse))
    }
    fn absolute(&self) -> Option<Self> {
        Some(Polynomial::constant(self.as_constant()?.abs()))
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(Polynomial::constant(self.as_constant()?.max(other.as_constant()?)))
    }
    fn floor(&self) -> Option<Integer> {
        Some(self.as_constant()?.floor())
    }
    fn cosine(turn: &Rational) -> Result<Self, CosineError> {
        RealCyclotomic::cosine(turn).map(Polynomial::constant)
    }
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        let numbers: Option<Vec<RealCyclotomic>> =
            coefficients.iter().map(Polynomial::as_constant).collect();
        cyclotomic_root(&numbers.ok_or(RootError::NotHere)?, number).map(Polynomial::constant)
    }
    fn conductor(&self) -> u32 {
        // The coefficients have a common field, so the least common multiple is within
        // the cap.
        let others = self.coefficients().map(RealCyclotomic::conductor).filter(|&n| n > 1);
        others.fold(1, num_integer::lcm)
    }
}

/// The root of a polynomial with these coefficients, if it is known to be in a field Q(2cos(2π/n)): a rational one of a
/// polynomial with rational coefficients, or the square root of a rational number.
fn cyclotomic_root(
    coefficients: &[RealCyclotomic],
    number: i64,
) -> Result<RealCyclotomic, RootError> {
    let rational: Option<Vec<Rational>> =
        coefficients.iter().map(|c| c.as_rational().cloned()).collect();
    let rational = rational.ok_or(RootError::NotHere)?;
    match rational_root(&rational, number) {
        Ok(root) => Ok(root.into()),
        Err(RootError::Irrational) => match &rational[..] {
            [c, b, a] if b.is_zero() => {
                // The roots of ax² + c, c/a < 0.
                let root = RealCyclotomic::square_root(&-(c / a)).ok_or(RootError::NotHere)?;
                Ok(if number == 2 { root } else { -&root })
            }
            _ => Err(RootError::NotHere),
        },
        Err(error) => Err(error),
    }
}

impl Value for RealCyclotomic {
    fn as_rational(&self) -> Option<Rational> {
        self.as_rational().cloned()
    }
    fn number(&self) -> Option<RealCyclotomic> {
        Some(self.clone())
    }
    fn of_number(number: &RealCyclotomic) -> Option<Self> {
        Some(number.clone())
    }
    fn size(&self) -> u64 {
        self.bits()
    }
    fn product_size(&self, other: &Self) -> u64 {
        // A product of two cosine terms counts as one bit: it is much quicker than a
        // product of two terms of a polynomial.
        let terms = self.term_count() as u64 * other.term_count() as u64;
        terms.saturating_add(self.bits()).saturating_add(other.bits())
    }
    fn row_product_size(&self, levels: u32) -> u64 {
        self.row_product_size(levels)
    }
    fn quotient_size(&self, divisor: &Self) -> u64 {
        self.bits().saturating_add(divisor.recip_cost())
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self / divisor)
    }
    fn absolute(&self) -> Option<Self> {
        Some(self.abs())
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(self.max(other).clone())
    }
    fn floor(&self) -> Option<Integer> {
        Some(self.floor())
    }
    fn vanishes(&self) -> Option<bool> {
        // The number 0 is always stored as a rational.
        Some(self.as_rational().is_some_and(Rational::is_zero))
    }
    fn cosine(turn: &Rational) -> Result<Self, CosineError> {
        RealCyclotomic::cosine(turn)
    }
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        cyclotomic_root(coefficients, number)
    }
    fn conductor(&self) -> u32 {
        self.conductor()
    }
}

/// Quotients that are not piecewise polynomial are [`Parametric::Outside`]. The caller of
/// an evaluation must check for it.
impl Value for Parametric {
    fn as_rational(&self) -> Option<Rational> {
        self.function()?.as_constant()
    }
    fn size(&self) -> u64 {
        // The time to isolate the roots of a piece grows about with the square of its
        // degree.
        self.function().map_or(0, |f| f.bits().saturating_mul(f.degree().pow(2).max(1) as u64))
    }
    fn product_size(&self, other: &Self) -> u64 {
        let pieces = |value: &Parametric| value.function().map_or(1, |f| f.piece_count() as u64);
        let (left, right) = (self.size(), other.size());
        left.saturating_mul(pieces(other)).saturating_add(right.saturating_mul(pieces(self)))
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        Some(self.over(divisor))
    }
    fn absolute(&self) -> Option<Self> {
        Some(self.magnitude())
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        Some(self.greater(other))
    }
}
