//! Dense polynomials in one variable over the integers.
//!
//! Every polynomial over the rationals has the same roots as a polynomial over the
//! integers, and an operation on integers takes about a thirtieth of the time of one on
//! fractions.

use crate::exact::{CommonDenominator, Integer, Rational};
use std::fmt;
use std::ops::{Add, Mul, Neg, Sub};

/// A polynomial c_0 + c_1 x + … + c_d x^d over the integers, c_d ≠ 0. The polynomial 0
/// has no coefficients.
///
/// ```
/// use subcert::exact::{IntegerPolynomial, Rational};
///
/// let p = IntegerPolynomial::from([-1, 1, 1]);
/// assert_eq!(p.to_string(), "x^2 + x - 1");
/// assert_eq!(p.value_at(&Rational::new(1, 2)), Rational::new(-1, 4));
/// assert_eq!((&p * &p).square_free(), p);
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash, Default)]
pub struct IntegerPolynomial {
    coefficients: Vec<Integer>,
}

impl<T: Into<Integer>, const N: usize> From<[T; N]> for IntegerPolynomial {
    fn from(coefficients: [T; N]) -> IntegerPolynomial {
        IntegerPolynomial::new(coefficients.into_iter().map(Into::into).collect())
    }
}

impl IntegerPolynomial {
    /// Σ c_i x^i for `coefficients` c_0, c_1, …
    #[must_use]
    pub fn new(mut coefficients: Vec<Integer>) -> IntegerPolynomial {
        let length = coefficients.iter().rposition(|c| !c.is_zero()).map_or(0, |last| last + 1);
        coefficients.truncate(length);
        IntegerPolynomial { coefficients }
    }

    /// q·Σ c_i x^i, where q > 0 is the least common denominator of the rationals
    /// c_0, c_1, …
    #[must_use]
    pub fn over_common_denominator(coefficients: &[Rational]) -> IntegerPolynomial {
        let mut common = CommonDenominator::of(&[coefficients.to_vec()]);
        IntegerPolynomial::new(common.numerators.swap_remove(0))
    }

    /// c_0, …, c_d.
    #[must_use]
    pub fn coefficients(&self) -> &[Integer] {
        &self.coefficients
    }

    /// The degree d; `None` for the polynomial 0.
    #[must_use]
    pub fn degree(&self) -> Option<usize> {
        self.coefficients.len().checked_sub(1)
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.coefficients.is_empty()
    }

    /// c_d; 0 for the polynomial 0.
    #[must_use]
    pub fn leading(&self) -> Integer {
        self.coefficients.last().cloned().unwrap_or_else(Integer::zero)
    }

    /// The value at `point`.
    #[must_use]
    pub fn value_at(&self, point: &Rational) -> Rational {
        let (value, scale) = self.scaled_value(point);
        Rational::new(value, scale)
    }

    /// (q^d·f(p/q), q^d), by Horner's rule on integers.
    pub(crate) fn scaled_value(&self, point: &Rational) -> (Integer, Integer) {
        let (p, q) = (point.numerator(), point.denominator());
        let Some((leading, rest)) = self.coefficients.split_last() else {
            return (Integer::zero(), Integer::one());
        };
        rest.iter().rev().fold((leading.clone(), Integer::one()), |(value, scale), coefficient| {
            let scale = scale * &q;
            (value * &p + coefficient * &scale, scale)
        })
    }

    /// The derivative.
    #[must_use]
    pub fn derivative(&self) -> IntegerPolynomial {
        let terms = self.coefficients.iter().enumerate().skip(1);
        IntegerPolynomial::new(terms.map(|(i, c)| c * Integer::from(i)).collect())
    }

    /// The greatest common divisor of the coefficients; 0 for the polynomial 0.
    #[must_use]
    pub fn content(&self) -> Integer {
        self.coefficients.iter().fold(Integer::zero(), |gcd, c| gcd.gcd(c))
    }

    /// This polynomial divided by its content, which keeps the signs.
    fn without_content(&self) -> IntegerPolynomial {
        let content = self.content();
        if content.is_zero() || content == Integer::one() {
            return self.clone();
        }
        let coefficients = self.coefficients.iter().map(|c| c.div_floor(&content)).collect();
        IntegerPolynomial { coefficients }
    }

    /// The primitive polynomial with the same roots: no prime divides all of its
    /// coefficients, and the leading coefficient is positive. 0 for the polynomial 0.
    #[must_use]
    pub fn primitive(&self) -> IntegerPolynomial {
        let primitive = self.without_content();
        if primitive.leading().sign() < 0 { -&primitive } else { primitive }
    }

    /// (s, Q, R) with s·self = Q·divisor + R, deg R < deg divisor, and s > 0 a power of
    /// |l|, where l is the leading coefficient of `divisor`.
    ///
    /// # Panics
    /// When `divisor` is 0.
    ///
    /// ```
    /// use subcert::exact::{Integer, IntegerPolynomial};
    ///
    /// let (s, q, r) = IntegerPolynomial::from([0, 0, 1]).div_rem(&IntegerPolynomial::from([1, -2]));
    /// assert_eq!((s, q.to_string(), r.to_string()), (4.into(), "-2x - 1".into(), "1".into()));
    /// ```
    #[must_use]
    pub fn div_rem(
        &self,
        divisor: &IntegerPolynomial,
    ) -> (Integer, IntegerPolynomial, IntegerPolynomial) {
        let (leading, lower) = divisor.coefficients.split_last().expect("division by zero");
        let (size, negative) = (leading.abs(), leading.sign() < 0);
        let mut scale = Integer::one();
        let mut rest = self.coefficients.clone();
        let mut quotient = vec![Integer::zero(); rest.len().saturating_sub(lower.len())];
        for shift in (0..quotient.len()).rev() {
            let top = rest.pop().expect("as long as shift + divisor");
            if top.is_zero() {
                continue;
            }
            // |l|·rest − (±top)·x^shift·divisor has no leading term, where ± is the sign
            // of l.
            for coefficient in quotient.iter_mut().chain(&mut rest) {
                *coefficient *= &size;
            }
            scale *= &size;
            let factor = if negative { -top } else { top };
            for (coefficient, c) in rest[shift..].iter_mut().zip(lower) {
                *coefficient -= &(&factor * c);
            }
            quotient[shift] = factor;
        }
        (scale, IntegerPolynomial::new(quotient), IntegerPolynomial::new(rest))
    }

    /// The remainder of self modulo `divisor` up to a positive factor, divided by its
    /// content.
    pub(super) fn remainder(&self, divisor: &IntegerPolynomial) -> IntegerPolynomial {
        self.div_rem(divisor).2.without_content()
    }

    /// The greatest common divisor over the rationals, primitive; 0 when both
    /// are 0.
    #[must_use]
    pub fn gcd(&self, other: &IntegerPolynomial) -> IntegerPolynomial {
        let (mut a, mut b) = (self.without_content(), other.without_content());
        while !b.is_zero() {
            (a, b) = (b.clone(), a.remainder(&b));
        }
        a.primitive()
    }
}

impl Neg for &IntegerPolynomial {
    type Output = IntegerPolynomial;
    fn neg(self) -> IntegerPolynomial {
        IntegerPolynomial { coefficients: self.coefficients.iter().map(|c| -c).collect() }
    }
}

impl Add for &IntegerPolynomial {
    type Output = IntegerPolynomial;
    fn add(self, other: &IntegerPolynomial) -> IntegerPolynomial {
        let (long, short) = if self.coefficients.len() < other.coefficients.len() {
            (other, self)
        } else {
            (self, other)
        };
        let mut sum = long.coefficients.clone();
        for (coefficient, c) in sum.iter_mut().zip(&short.coefficients) {
            *coefficient += c;
        }
        IntegerPolynomial::new(sum)
    }
}

impl Sub for &IntegerPolynomial {
    type Output = IntegerPolynomial;
    fn sub(self, other: &IntegerPolynomial) -> IntegerPolynomial {
        self + &-other
    }
}

impl Mul for &IntegerPolynomial {
    type Output = IntegerPolynomial;
    fn mul(self, other: &IntegerPolynomial) -> IntegerPolynomial {
        let length = self.coefficients.len() + other.coefficients.len();
        let mut product = vec![Integer::zero(); length];
        for (i, a) in self.coefficients.iter().enumerate() {
            for (j, b) in other.coefficients.iter().enumerate() {
                product[i + j].add_product(a, b);
            }
        }
        IntegerPolynomial::new(product)
    }
}

impl fmt::Display for IntegerPolynomial {
    /// As `3x^2 - x + 1`.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut text = String::new();
        for (exponent, c) in self.coefficients.iter().enumerate().rev() {
            if c.is_zero() {
                continue;
            }
            text.push_str(match (text.is_empty(), c.sign() < 0) {
                (true, true) => "-",
                (true, false) => "",
                (false, true) => " - ",
                (false, false) => " + ",
            });
            let size = c.abs();
            if exponent == 0 || size != Integer::one() {
                text.push_str(&size.to_string());
            }
            match exponent {
                0 => {}
                1 => text.push('x'),
                _ => text.extend(["x^", &exponent.to_string()]),
            }
        }
        f.pad(if text.is_empty() { "0" } else { &text })
    }
}
