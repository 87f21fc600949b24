//! Polynomials in one variable over the rationals.

use crate::exact::{Integer, IntegerPolynomial, Rational, Scalar, common_denominator};

/// The most integers at which a polynomial is computed one by one.
pub const MAX_TRIED_INTEGERS: i64 = 10_000;

/// A polynomial in one variable over Q: an integer polynomial over one
/// denominator, in lowest terms.
///
/// ```
/// use subcert::exact::{Rational, RationalPolynomial};
///
/// let p = RationalPolynomial::new(&[Rational::new(-1, 16), Rational::from(-3)]);
/// assert_eq!(p.value_at(&Rational::new(1, 48)), Rational::new(-1, 8));
/// assert_eq!(p.times(&p).describe("w"), "1/256 + 3/8*w + 9*w^2");
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct RationalPolynomial {
    numerator: IntegerPolynomial,
    /// Positive, and coprime to the content of the numerator.
    denominator: Integer,
}

impl RationalPolynomial {
    /// Σ c_i x^i for `coefficients` c_0, c_1, …
    #[must_use]
    pub fn new(coefficients: &[Rational]) -> RationalPolynomial {
        let denominator = common_denominator(coefficients);
        let numerator = IntegerPolynomial::over_common_denominator(coefficients);
        RationalPolynomial { numerator, denominator }
    }

    /// `numerator` / `denominator`.
    ///
    /// # Panics
    /// When `denominator` is 0.
    #[must_use]
    pub fn over(numerator: &IntegerPolynomial, denominator: &Integer) -> RationalPolynomial {
        assert!(!denominator.is_zero(), "division by zero");
        let common = numerator.content().gcd(denominator);
        let common = if denominator.sign() < 0 { -common } else { common };
        let reduced = numerator.coefficients().iter().map(|c| c.div_floor(&common)).collect();
        RationalPolynomial {
            numerator: IntegerPolynomial::new(reduced),
            denominator: denominator.div_floor(&common),
        }
    }

    /// The constant `value`.
    #[must_use]
    pub fn constant(value: Rational) -> RationalPolynomial {
        RationalPolynomial::new(&[value])
    }

    /// An integer b ≥ 2 from which on this polynomial has no root and the sign of its highest coefficient:
    /// ⌈1 + max |c_i/c_g|⌉ + 1, by Cauchy's bound; `None` of the polynomial 0, and beyond 2^32.
    ///
    /// ```
    /// use subcert::exact::{Rational, RationalPolynomial};
    ///
    /// let p = RationalPolynomial::new(&[-6, 1, 1].map(Rational::from));
    /// assert_eq!(p.settled_from(), Some(8));
    /// ```
    #[must_use]
    pub fn settled_from(&self) -> Option<i64> {
        let coefficients = self.coefficients();
        let (highest, others) = coefficients.split_last()?;
        let ratios = others.iter().map(|c| (c / highest).abs());
        let most = ratios.fold(Rational::zero(), Rational::max);
        let bound = (most + Rational::from(1)).ceil() + Integer::one();
        bound.within(1 << 32)
    }

    /// Whether this is shown to be 0 at no integer from `first` on: at most 10,000 integers are tried.
    ///
    /// ```
    /// use subcert::exact::{Rational, RationalPolynomial};
    ///
    /// let p = RationalPolynomial::new(&[-6, 1, 1].map(Rational::from));
    /// assert!(!p.is_never_zero_from(2) && p.is_never_zero_from(3));
    /// ```
    #[must_use]
    pub fn is_never_zero_from(&self, first: i64) -> bool {
        let Some(settled) = self.settled_from() else { return false };
        settled.saturating_sub(first) < MAX_TRIED_INTEGERS
            && (first..=settled).all(|t| !self.value_at(&Rational::from(t)).is_zero())
    }

    /// Whether this is linear, and negative at no number from `first` on.
    ///
    /// ```
    /// use subcert::exact::{Rational, RationalPolynomial};
    ///
    /// let line = RationalPolynomial::new(&[-3, 1].map(Rational::from));
    /// assert!(line.is_nonnegative_line_from(3) && !line.is_nonnegative_line_from(2));
    /// ```
    #[must_use]
    pub fn is_nonnegative_line_from(&self, first: i64) -> bool {
        let slope = self.coefficients().get(1).map_or(0, Rational::sign);
        self.degree().is_none_or(|degree| degree <= 1)
            && slope >= 0
            && self.value_at(&Rational::from(first)).sign() >= 0
    }

    /// The polynomial x.
    #[must_use]
    pub fn variable() -> RationalPolynomial {
        RationalPolynomial {
            numerator: IntegerPolynomial::from([0, 1]),
            denominator: Integer::one(),
        }
    }

    /// This polynomial times the least common denominator of its coefficients, which is
    /// positive.
    #[must_use]
    pub fn numerator(&self) -> &IntegerPolynomial {
        &self.numerator
    }

    /// The degree; `None` for 0.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.numerator.degree()
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.numerator.is_zero()
    }

    /// c_0, …, c_d.
    #[must_use]
    pub fn coefficients(&self) -> Vec<Rational> {
        let over = |c: &Integer| Rational::new(c.clone(), self.denominator.clone());
        self.numerator.coefficients().iter().map(over).collect()
    }

    /// The value of a constant polynomial; `None` for any other.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        match &self.coefficients()[..] {
            [] => Some(Rational::zero()),
            [value] => Some(value.clone()),
            _ => None,
        }
    }

    /// The number of binary digits of all coefficients together.
    #[must_use]
    pub fn bits(&self) -> u64 {
        let digits = self.numerator.coefficients().iter().map(|c| c.bits() + 1).sum::<u64>();
        digits + self.denominator.bits()
    }

    /// The value at `point`.
    #[must_use]
    pub fn value_at(&self, point: &Rational) -> Rational {
        self.numerator.value_at(point) / Rational::from(self.denominator.clone())
    }

    /// The sign of the value at `point`: −1, 0 or 1.
    #[must_use]
    pub fn sign_at(&self, point: &Rational) -> i8 {
        self.numerator.sign_at(point)
    }

    /// self + other.
    #[must_use]
    pub fn plus(&self, other: &RationalPolynomial) -> RationalPolynomial {
        if self.denominator == other.denominator {
            return RationalPolynomial::over(
                &(&self.numerator + &other.numerator),
                &self.denominator,
            );
        }
        let scale =
            |p: &IntegerPolynomial, by: &Integer| p * &IntegerPolynomial::new(vec![by.clone()]);
        let sum = &scale(&self.numerator, &other.denominator)
            + &scale(&other.numerator, &self.denominator);
        RationalPolynomial::over(&sum, &(&self.denominator * &other.denominator))
    }

    /// −self.
    #[must_use]
    pub fn negated(&self) -> RationalPolynomial {
        RationalPolynomial { numerator: -&self.numerator, denominator: self.denominator.clone() }
    }

    /// self − other.
    #[must_use]
    pub fn minus(&self, other: &RationalPolynomial) -> RationalPolynomial {
        self.plus(&other.negated())
    }

    /// self · other.
    #[must_use]
    pub fn times(&self, other: &RationalPolynomial) -> RationalPolynomial {
        let denominator = &self.denominator * &other.denominator;
        RationalPolynomial::over(&(&self.numerator * &other.numerator), &denominator)
    }

    /// The remainder of self by `divisor`.
    ///
    /// # Panics
    /// When `divisor` is 0.
    #[must_use]
    pub fn modulo(&self, divisor: &IntegerPolynomial) -> RationalPolynomial {
        if self.degree() < divisor.degree() {
            return self.clone();
        }
        let (scale, _, rest) = self.numerator.div_rem(divisor);
        RationalPolynomial::over(&rest, &(scale * &self.denominator))
    }
}

impl Scalar for RationalPolynomial {
    fn from_rational(value: &Rational) -> Self {
        RationalPolynomial::constant(value.clone())
    }
    fn plus(&self, other: &Self) -> Self {
        RationalPolynomial::plus(self, other)
    }
    fn minus(&self, other: &Self) -> Self {
        RationalPolynomial::minus(self, other)
    }
    fn times(&self, other: &Self) -> Self {
        RationalPolynomial::times(self, other)
    }
}
