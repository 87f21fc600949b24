//! Quotients of polynomials in one parameter, at a place of the parameter.

use crate::exact::scalar::{Real, Scalar};
use crate::exact::{Integer, IntegerPolynomial, Rational, RationalPolynomial, RealAlgebraic};
use std::cell::{Cell, RefCell};
use std::fmt;
use std::rc::Rc;

/// A place of a parameter: a number, and the polynomials whose signs were asked for there.
///
/// A computation that asks for signs only, of polynomials in the parameter, takes the same course at all numbers of an interval
/// around the place in which none of them has a root. So a rational number of an open interval stands for all of it, if none of
/// [`Place::asked`] has a root there.
#[derive(Debug)]
pub struct Place {
    at: RealAlgebraic,
    /// A polynomial with this root, if the number is irrational.
    modulus: Option<IntegerPolynomial>,
    asked: RefCell<Vec<IntegerPolynomial>>,
    /// Whether one of these has the number as a root.
    special: Cell<bool>,
}

impl Place {
    /// The place of this number.
    #[must_use]
    pub fn new(at: RealAlgebraic) -> Place {
        let modulus = at.as_rational().is_none().then(|| at.polynomial());
        Place { at, modulus, asked: RefCell::default(), special: Cell::new(false) }
    }

    /// The number.
    #[must_use]
    pub fn number(&self) -> &RealAlgebraic {
        &self.at
    }

    /// The polynomials that are no constants and whose signs were asked for, each once.
    #[must_use]
    pub fn asked(&self) -> Vec<IntegerPolynomial> {
        self.asked.borrow().clone()
    }

    /// The sign of a polynomial at the number.
    fn sign(&self, p: &IntegerPolynomial) -> i8 {
        if p.degree().unwrap_or(0) == 0 {
            return p.leading().sign();
        }
        let mut asked = self.asked.borrow_mut();
        if !asked.contains(p) {
            asked.push(p.clone());
        }
        let sign = match self.at.as_rational() {
            Some(at) => p.sign_at(at),
            None => self.at.sign_of(p),
        };
        if sign == 0 {
            self.special.set(true);
        }
        sign
    }

    /// The number, if it is rational and stands for no interval any more: then functions are as well their values there.
    fn alone(&self) -> Option<&Rational> {
        self.at.as_rational().filter(|_| self.special.get())
    }
}

/// p(x)/q(x) for polynomials p and q over Q in one parameter x, at a [`Place`] where q is not 0, in lowest terms.
///
/// Arithmetic is that of functions of x. Comparisons are those of their values at the place, and the place notes what they rest
/// on. A constant has no place.
///
/// ```
/// use std::rc::Rc;
/// use subcert::exact::{Place, QuotientAt, Rational, Real, Scalar};
///
/// let place = Rc::new(Place::new(Rational::from(3).into()));
/// let x = QuotientAt::variable(&place);
/// let two = QuotientAt::from_rational(&Rational::from(2));
/// // |x − 2| is x − 2 for all x without a root of x − 2 between them and 3.
/// assert_eq!(x.minus(&two).magnitude().to_string(), "-2 + x");
/// assert_eq!(place.asked().len(), 1);
/// // (x² − 4)/(x − 2)
/// let quotient = x.times(&x).minus(&two.times(&two)).over(&x.minus(&two));
/// assert_eq!(quotient.to_string(), "2 + x");
/// assert_eq!(quotient, QuotientAt::from_rational(&Rational::from(5)));
/// ```
#[derive(Clone, Debug)]
pub struct QuotientAt {
    numerator: RationalPolynomial,
    /// Primitive, with a positive leading coefficient; 1 for a polynomial.
    denominator: IntegerPolynomial,
    place: Option<Rc<Place>>,
}

impl QuotientAt {
    /// The parameter.
    #[must_use]
    pub fn variable(place: &Rc<Place>) -> QuotientAt {
        let (numerator, place) = (RationalPolynomial::variable(), Some(Rc::clone(place)));
        QuotientAt { numerator, denominator: one(), place }
    }

    /// The polynomial that this is, if it is one.
    #[must_use]
    pub fn as_polynomial(&self) -> Option<&RationalPolynomial> {
        self.is_polynomial().then_some(&self.numerator)
    }

    /// A polynomial at the place of this.
    #[must_use]
    pub fn with(&self, polynomial: &RationalPolynomial) -> QuotientAt {
        QuotientAt { numerator: polynomial.clone(), denominator: one(), place: self.place.clone() }
    }

    /// The number, if this does not depend on the parameter.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        if self.is_polynomial() { self.numerator.as_constant() } else { None }
    }

    /// The number of binary digits of all coefficients together.
    #[must_use]
    pub fn bits(&self) -> u64 {
        let digits = self.denominator.coefficients().iter().map(Integer::bits).sum::<u64>();
        self.numerator.bits() + digits
    }

    /// The greater degree of numerator and denominator.
    #[must_use]
    pub fn degree(&self) -> usize {
        self.numerator.degree().max(self.denominator.degree()).unwrap_or(0)
    }

    /// The sign of the value at the place.
    #[must_use]
    pub fn sign(&self) -> i8 {
        match (&self.place, self.numerator.as_constant()) {
            (None, _) => self.numerator.numerator().leading().sign(),
            (Some(_), Some(constant)) if self.is_polynomial() => constant.sign(),
            (Some(place), _) => {
                let below = if self.is_polynomial() { 1 } else { place.sign(&self.denominator) };
                place.sign(self.numerator.numerator()) * below
            }
        }
    }

    fn is_polynomial(&self) -> bool {
        self.denominator.degree() == Some(0)
    }

    /// numerator/denominator in lowest terms, at the place of either operand; the denominator is not 0.
    fn reduced(
        numerator: &RationalPolynomial,
        denominator: &IntegerPolynomial,
        places: [&QuotientAt; 2],
    ) -> QuotientAt {
        let place = places.into_iter().find_map(|side| side.place.clone());
        if let Some(at) = place.as_deref().and_then(Place::alone) {
            return QuotientAt::from_rational(&(numerator.value_at(at) / denominator.value_at(at)));
        }
        if let Some(modulus) = place.as_deref().and_then(|place| place.modulus.as_ref())
            && [numerator.degree(), denominator.degree()].into_iter().any(|d| d >= modulus.degree())
        {
            // Functions of equal values at the number do as well, and these stay small.
            let below = RationalPolynomial::over(denominator, &Integer::one()).modulo(modulus);
            let above = numerator.modulo(modulus);
            let numerator = above.times(&RationalPolynomial::constant(content(&below).recip()));
            return QuotientAt::in_lowest_terms(&numerator, below.numerator(), place);
        }
        QuotientAt::in_lowest_terms(numerator, denominator, place)
    }

    /// The same, of polynomials that are small.
    fn in_lowest_terms(
        numerator: &RationalPolynomial,
        denominator: &IntegerPolynomial,
        place: Option<Rc<Place>>,
    ) -> QuotientAt {
        let factor = |factor: Rational| numerator.times(&RationalPolynomial::constant(factor));
        if numerator.is_zero() || denominator.degree() == Some(0) {
            let numerator = factor(Rational::from(denominator.leading()).recip());
            return QuotientAt { numerator, denominator: one(), place };
        }
        let common = numerator.numerator().gcd(denominator);
        // common·quotient = scale·numerator
        let over_common = |p: &IntegerPolynomial| {
            let (scale, quotient, _) = p.div_rem(&common);
            RationalPolynomial::over(&quotient, &scale)
        };
        let below = over_common(denominator);
        let primitive = below.numerator().primitive();
        // What the integers of the numerator lack, and what the denominator has too much.
        let lacking = content(numerator);
        let leading = below.coefficients().last().cloned().unwrap_or_else(Rational::one);
        let excess = leading / Rational::from(primitive.leading());
        let above = over_common(numerator.numerator());
        let numerator = above.times(&RationalPolynomial::constant(lacking / excess));
        QuotientAt { numerator, denominator: primitive, place }
    }
}

/// The number p/q, where q is the polynomial over the integers of which p ≠ 0 is a multiple.
fn content(p: &RationalPolynomial) -> Rational {
    let leading = p.coefficients().last().cloned().unwrap_or_else(Rational::one);
    leading / Rational::from(p.numerator().leading())
}

fn one() -> IntegerPolynomial {
    IntegerPolynomial::from([1])
}

fn times(p: &RationalPolynomial, q: &IntegerPolynomial) -> RationalPolynomial {
    p.times(&RationalPolynomial::over(q, &Integer::one()))
}

impl PartialEq for QuotientAt {
    fn eq(&self, other: &QuotientAt) -> bool {
        self.minus(other).sign() == 0
    }
}

impl fmt::Display for QuotientAt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let numerator = self.numerator.describe("x");
        if self.is_polynomial() {
            return f.pad(&numerator);
        }
        let denominator = RationalPolynomial::over(&self.denominator, &Integer::one());
        f.pad(&format!("({numerator})/({})", denominator.describe("x")))
    }
}

impl Scalar for QuotientAt {
    fn from_rational(value: &Rational) -> QuotientAt {
        let numerator = RationalPolynomial::constant(value.clone());
        QuotientAt { numerator, denominator: one(), place: None }
    }
    fn plus(&self, other: &QuotientAt) -> QuotientAt {
        if self.denominator == other.denominator {
            let sum = self.numerator.plus(&other.numerator);
            return QuotientAt::reduced(&sum, &self.denominator, [self, other]);
        }
        let crossed = times(&self.numerator, &other.denominator)
            .plus(&times(&other.numerator, &self.denominator));
        let denominator = &self.denominator * &other.denominator;
        QuotientAt::reduced(&crossed, &denominator, [self, other])
    }
    fn minus(&self, other: &QuotientAt) -> QuotientAt {
        let negated = QuotientAt { numerator: other.numerator.negated(), ..other.clone() };
        self.plus(&negated)
    }
    fn times(&self, other: &QuotientAt) -> QuotientAt {
        let denominator = &self.denominator * &other.denominator;
        QuotientAt::reduced(&self.numerator.times(&other.numerator), &denominator, [self, other])
    }
}

impl Real for QuotientAt {
    fn magnitude(&self) -> QuotientAt {
        if self.sign() < 0 { QuotientAt::zero().minus(self) } else { self.clone() }
    }
    fn greater(&self, other: &QuotientAt) -> QuotientAt {
        if self.minus(other).sign() < 0 { other.clone() } else { self.clone() }
    }
    fn over(&self, other: &QuotientAt) -> QuotientAt {
        let numerator = times(&self.numerator, &other.denominator);
        let divisor = &other.numerator;
        // The divisor as integers over a number.
        let number = divisor.coefficients().last().cloned().unwrap_or_else(Rational::zero)
            / Rational::from(divisor.numerator().leading());
        let numerator = numerator.times(&RationalPolynomial::constant(number.recip()));
        let denominator = &self.denominator * divisor.numerator();
        QuotientAt::reduced(&numerator, &denominator, [self, other])
    }
}
