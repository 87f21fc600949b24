//! Numbers that depend on a free parameter.

use crate::cap::Cap;
use crate::exact::scalar::{Real, Scalar};
use crate::exact::{PiecewisePolynomial, Rational};
use std::fmt;

/// The most pieces, and the greatest degree, that a function of a parameter may have.
const MAX_PIECES: usize = 4_096;
const MAX_DEGREE: usize = 64;

/// A number that depends on one free parameter: a piecewise polynomial function of the
/// parameter, or a marker that the function has left this class.
///
/// The operations of a [`Scalar`] cannot fail. But a quotient of two piecewise polynomial
/// functions need not be piecewise polynomial, and functions of more than 4096 pieces or
/// of a degree above 64 are not computed. In these cases the result is
/// [`Parametric::Outside`], and so is everything computed from it. The caller sees this
/// at the end instead of a wrong function.
///
/// ```
/// use subcert::bound::{Order, Terms, displacement, power_norm_generic};
/// use subcert::exact::{Parametric, Rational, Real};
/// use subcert::scheme::find;
///
/// // T_1 and σ of the 4-point scheme with tension w, as functions of w.
/// let parameters = [("w".to_owned(), Parametric::variable())].into();
/// let mask = find("four-point").expect("it is there").mask(&parameters)?;
/// let contraction = power_norm_generic(&mask.difference(), 1, Order::Adjoint)?;
/// let sigma = displacement(&mask, Terms::Each);
/// let function = contraction.function().expect("piecewise linear");
/// assert_eq!(function.at(&Rational::new(1, 16)), Rational::new(5, 8));
/// assert_eq!(function.below(&Rational::one()).describe("w"), "-1/4 < w < 1/4");
/// assert_eq!(sigma.function().map(|f| f.piece_count()), Some(2));
/// assert_eq!(Parametric::variable().over(&Parametric::variable()).function(), None);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
pub enum Parametric {
    /// A piecewise polynomial function of the parameter.
    Function(PiecewisePolynomial),
    /// No function is known: a value is beyond this cap, or without one, a divisor depended on the parameter.
    Outside(Option<Cap>),
}

impl Parametric {
    /// The parameter itself.
    #[must_use]
    pub fn variable() -> Parametric {
        Parametric::Function(PiecewisePolynomial::variable())
    }

    /// The function, if it is piecewise polynomial.
    #[must_use]
    pub fn function(&self) -> Option<&PiecewisePolynomial> {
        match self {
            Parametric::Function(function) => Some(function),
            Parametric::Outside(_) => None,
        }
    }

    fn beyond(what: &'static str, most: usize) -> Parametric {
        Parametric::Outside(Some(Cap::new(what, most as u64)))
    }

    fn with(
        &self,
        other: &Parametric,
        apply: impl FnOnce(
            &PiecewisePolynomial,
            &PiecewisePolynomial,
        ) -> Result<PiecewisePolynomial, Parametric>,
    ) -> Parametric {
        let (left, right) = match (self, other) {
            (Parametric::Function(left), Parametric::Function(right)) => (left, right),
            // What has no function at any cap comes first.
            (Parametric::Outside(None), _) | (_, Parametric::Outside(None)) => {
                return Parametric::Outside(None);
            }
            (Parametric::Outside(cap), _) | (_, Parametric::Outside(cap)) => {
                return Parametric::Outside(cap.clone());
            }
        };
        match apply(left, right) {
            Ok(function) if function.piece_count() <= MAX_PIECES => Parametric::Function(function),
            Ok(_) => Parametric::beyond("the number of pieces of a function", MAX_PIECES),
            Err(outside) => outside,
        }
    }

    /// The lesser of the two.
    #[must_use]
    pub fn lesser(&self, other: &Parametric) -> Parametric {
        self.with(other, |left, right| Ok(left.lesser(right)))
    }
}

/// [`Parametric::Outside`] is equal to nothing, not even to itself, since its value is
/// unknown.
impl PartialEq for Parametric {
    fn eq(&self, other: &Parametric) -> bool {
        self.function().zip(other.function()).is_some_and(|(left, right)| left == right)
    }
}

impl fmt::Display for Parametric {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Parametric::Function(function) => function.fmt(f),
            Parametric::Outside(None) => f.pad("a function that is not piecewise polynomial"),
            Parametric::Outside(Some(_)) => f.pad("a function beyond the caps"),
        }
    }
}

impl Scalar for Parametric {
    fn from_rational(value: &Rational) -> Parametric {
        Parametric::Function(PiecewisePolynomial::constant(value.clone()))
    }
    fn plus(&self, other: &Parametric) -> Parametric {
        self.with(other, |left, right| Ok(left.plus(right)))
    }
    fn minus(&self, other: &Parametric) -> Parametric {
        self.with(other, |left, right| Ok(left.minus(right)))
    }
    fn times(&self, other: &Parametric) -> Parametric {
        self.with(other, |left, right| {
            if left.degree() + right.degree() > MAX_DEGREE {
                return Err(Parametric::beyond("the degree of a function", MAX_DEGREE));
            }
            Ok(left.times(right))
        })
    }
}

/// Operations are pointwise: [`Real::greater`] is the pointwise maximum. A quotient stays
/// in this class only for a constant divisor.
impl Real for Parametric {
    fn magnitude(&self) -> Parametric {
        self.with(self, |function, _| Ok(function.magnitude()))
    }
    fn greater(&self, other: &Parametric) -> Parametric {
        self.with(other, |left, right| Ok(left.greater(right)))
    }
    fn over(&self, other: &Parametric) -> Parametric {
        self.with(other, |left, right| {
            let divisor = right.as_constant().ok_or(Parametric::Outside(None))?;
            Ok(left.scaled(&divisor.recip()))
        })
    }
}
