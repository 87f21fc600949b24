//! Rational numbers of any size.

mod operators;
mod others;

use super::integer::Integer;
use super::word;
use std::borrow::Cow;
use std::cmp::Ordering;
use std::fmt;

/// A rational number p/q, always in lowest terms with q > 0.
///
/// ```
/// use subcert::exact::Rational;
///
/// let a = Rational::new(-35, 1296) + Rational::new(1, 2);
/// assert_eq!(a.to_string(), "613/1296");
/// assert_eq!(Rational::new(2, -4), Rational::new(-1, 2));
/// ```
///
/// `/` and `%` panic where the divisor is 0. `%` leaves a remainder of the sign of the dividend. The traits of
/// [num-traits](super::crates::num_traits) that make sense hold, and numbers of num-rational, num-bigint and rug
/// convert from and to this one. As text it is p/q, or p where q = 1, also in files (serde); from text,
/// [`parse_rational`](super::parse_rational) reads it.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::exact::crates::num_rational::{BigRational, Ratio};
///
/// let theirs: BigRational = Rational::new(1, 3).into();
/// assert_eq!(Rational::from(&theirs + &theirs), "2/3".parse()?);
/// assert_eq!(Ratio::<i64>::try_from(Rational::new(2, 6))?, Ratio::new(1, 3));
/// assert_eq!(Rational::new(-7, 2) % Rational::from(2), Rational::new(-3, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Rational(Form);

/// Each value has exactly one form, so that derived equality and hashing are right.
#[derive(Clone, PartialEq, Eq, Hash)]
enum Form {
    /// p and q.
    Words(i64, i64),
    /// p and q, where at least one is beyond `i64`.
    Large(Box<Fraction>),
}
use Form::{Large, Words};

#[derive(Clone, PartialEq, Eq, Hash)]
struct Fraction {
    p: Integer,
    q: Integer,
}

impl Rational {
    /// numerator / denominator, reduced.
    ///
    /// # Panics
    /// When `denominator` is 0.
    #[must_use]
    pub fn new(numerator: impl Into<Integer>, denominator: impl Into<Integer>) -> Rational {
        let (p, q) = (numerator.into(), denominator.into());
        assert!(!q.is_zero(), "a fraction with denominator 0");
        if let (Some(p), Some(q)) = (p.to_i64(), q.to_i64()) {
            return Rational::of_words(word::fraction(p, q));
        }
        let divisor = p.gcd(&q);
        let (p, q) = (p.div_exact(&divisor), q.div_exact(&divisor));
        if q.sign() < 0 { Rational::of(-p, -q) } else { Rational::of(p, q) }
    }

    /// 0.
    #[must_use]
    pub fn zero() -> Rational {
        Rational(Words(0, 1))
    }

    /// 1.
    #[must_use]
    pub fn one() -> Rational {
        Rational(Words(1, 1))
    }

    /// p of p/q.
    #[must_use]
    pub fn numerator(&self) -> Integer {
        match &self.0 {
            Words(p, _) => Integer::from(*p),
            Large(fraction) => fraction.p.clone(),
        }
    }

    /// q of p/q, positive.
    #[must_use]
    pub fn denominator(&self) -> Integer {
        match &self.0 {
            Words(_, q) => Integer::from(*q),
            Large(fraction) => fraction.q.clone(),
        }
    }

    /// p and q, if both are `i64`.
    pub(super) fn as_words(&self) -> Option<(i64, i64)> {
        match &self.0 {
            Words(p, q) => Some((*p, *q)),
            Large(_) => None,
        }
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        self.0 == Words(0, 1)
    }

    /// Whether q = 1.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        match &self.0 {
            Words(_, q) => *q == 1,
            Large(fraction) => fraction.q == Integer::one(),
        }
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(&self) -> i8 {
        match &self.0 {
            Words(p, _) => match p.cmp(&0) {
                Ordering::Less => -1,
                Ordering::Equal => 0,
                Ordering::Greater => 1,
            },
            Large(fraction) => fraction.p.sign(),
        }
    }

    /// |self|.
    #[must_use]
    pub fn abs(&self) -> Rational {
        if self.sign() < 0 { -self } else { self.clone() }
    }

    /// 1 / self.
    ///
    /// # Panics
    /// When this is 0.
    #[must_use]
    pub fn recip(&self) -> Rational {
        let (p, q) = (self.numerator(), self.denominator());
        assert!(!p.is_zero(), "a fraction with denominator 0");
        if p.sign() < 0 { Rational::of(-q, -p) } else { Rational::of(q, p) }
    }

    /// self^exponent; x^0 = 1, also for x = 0.
    ///
    /// # Panics
    /// When this is 0 and `exponent` < 0.
    #[must_use]
    pub fn pow(&self, exponent: i32) -> Rational {
        let base = if exponent < 0 { self.recip() } else { self.clone() };
        let exponent = exponent.unsigned_abs();
        Rational::of(base.numerator().pow(exponent), base.denominator().pow(exponent))
    }

    /// 10^exponent.
    #[must_use]
    pub fn power_of_ten(exponent: i32) -> Rational {
        Rational::from(10).pow(exponent)
    }

    /// The greatest integer that is not above this.
    #[must_use]
    pub fn floor(&self) -> Integer {
        match &self.0 {
            Words(p, q) => Integer::from(p.div_euclid(*q)),
            Large(fraction) => fraction.p.div_floor(&fraction.q),
        }
    }

    /// The fractional part self − ⌊self⌋, in [0, 1); see [`floor`](Rational::floor).
    #[must_use]
    pub fn fract(&self) -> Rational {
        self - Rational::from(self.floor())
    }

    /// The least integer that is not below this.
    #[must_use]
    pub fn ceil(&self) -> Integer {
        -(-self).floor()
    }

    /// The integer part: the nearest integer on the way to 0.
    #[must_use]
    pub fn trunc(&self) -> Integer {
        if self.sign() < 0 { self.ceil() } else { self.floor() }
    }

    /// The nearest integer; of two equally near ones, the even one.
    #[must_use]
    pub fn round_half_even(&self) -> Integer {
        let floor = self.floor();
        let twice_rest = (self - Rational::from(floor.clone())) * Rational::from(2);
        let up = match twice_rest.cmp(&Rational::one()) {
            Ordering::Less => false,
            Ordering::Equal => !floor.is_even(),
            Ordering::Greater => true,
        };
        if up { floor + Integer::one() } else { floor }
    }

    /// The number of binary digits of numerator and denominator together: a measure of
    /// the cost of an operation.
    #[must_use]
    pub fn bits(&self) -> u64 {
        match &self.0 {
            Words(p, q) => word::bits(*p) + word::bits(*q),
            Large(fraction) => fraction.p.bits() + fraction.q.bits(),
        }
    }

    /// p/q, given in lowest terms with q > 0.
    fn of(p: Integer, q: Integer) -> Rational {
        Rational(match (p.to_i64(), q.to_i64()) {
            (Some(p), Some(q)) => Words(p, q),
            _ => Large(Box::new(Fraction { p, q })),
        })
    }

    /// p/q, given in lowest terms with q > 0 as wide machine integers.
    fn of_words((p, q): (i128, i128)) -> Rational {
        match (i64::try_from(p), i64::try_from(q)) {
            (Ok(p), Ok(q)) => Rational(Words(p, q)),
            _ => Rational::of(Integer::from(p), Integer::from(q)),
        }
    }

    fn fraction(&self) -> Cow<'_, Fraction> {
        match &self.0 {
            Words(p, q) => Cow::Owned(Fraction { p: Integer::from(*p), q: Integer::from(*q) }),
            Large(fraction) => Cow::Borrowed(fraction),
        }
    }
}

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_integer() {
            f.pad(&self.numerator().to_string())
        } else {
            f.pad(&format!("{}/{}", self.numerator(), self.denominator()))
        }
    }
}
