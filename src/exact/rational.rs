//! Rational numbers of any size.

use super::backend;
use super::integer::Integer;
use super::ops::{binary_operator, ring_basics};
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
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Rational(pub(super) backend::Rat);

binary_operator!(Rational, backend::Rat, Add, add, AddAssign, add_assign);
binary_operator!(Rational, backend::Rat, Sub, sub, SubAssign, sub_assign);
binary_operator!(Rational, backend::Rat, Mul, mul, MulAssign, mul_assign);
binary_operator!(Rational, backend::Rat, Div, div, DivAssign, div_assign);
ring_basics!(Rational, backend::Rat);

impl Rational {
    /// numerator / denominator, reduced.
    ///
    /// # Panics
    /// When `denominator` is 0.
    #[must_use]
    pub fn new(numerator: impl Into<Integer>, denominator: impl Into<Integer>) -> Rational {
        let denominator = denominator.into();
        assert!(!denominator.is_zero(), "a fraction with denominator 0");
        Rational(backend::rat(numerator.into().0, denominator.0))
    }

    /// 0.
    #[must_use]
    pub fn zero() -> Rational {
        Rational::from(0)
    }

    /// 1.
    #[must_use]
    pub fn one() -> Rational {
        Rational::from(1)
    }

    /// p of p/q.
    #[must_use]
    pub fn numerator(&self) -> Integer {
        Integer(self.0.numer().clone())
    }

    /// q of p/q, positive.
    #[must_use]
    pub fn denominator(&self) -> Integer {
        Integer(self.0.denom().clone())
    }

    /// Whether this is 0.
    #[must_use]
    pub fn is_zero(&self) -> bool {
        backend::rat_is_zero(&self.0)
    }

    /// Whether q = 1.
    #[must_use]
    pub fn is_integer(&self) -> bool {
        self.denominator() == Integer::one()
    }

    /// −1, 0 or 1.
    #[must_use]
    pub fn sign(&self) -> i8 {
        backend::rat_sign(&self.0)
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
        Rational::new(self.denominator(), self.numerator())
    }

    /// self^exponent; x^0 = 1, also for x = 0.
    ///
    /// # Panics
    /// When this is 0 and `exponent` < 0.
    #[must_use]
    pub fn pow(&self, exponent: i32) -> Rational {
        let base = if exponent < 0 { self.recip() } else { self.clone() };
        Rational(backend::rat_pow(&base.0, exponent.unsigned_abs()))
    }

    /// 10^exponent.
    #[must_use]
    pub fn power_of_ten(exponent: i32) -> Rational {
        Rational::from(10).pow(exponent)
    }

    /// The greatest integer that is not above this.
    #[must_use]
    pub fn floor(&self) -> Integer {
        self.numerator().div_floor(&self.denominator())
    }

    /// The least integer that is not below this.
    #[must_use]
    pub fn ceil(&self) -> Integer {
        -(-self).floor()
    }

    /// The integer nearest to this, the even one of two.
    #[must_use]
    pub fn round_half_even(&self) -> Integer {
        let floor = self.floor();
        let twice_rest = (self - Rational::from(floor.clone())) * Rational::from(2);
        let up = match twice_rest.cmp(&Rational::one()) {
            std::cmp::Ordering::Less => false,
            std::cmp::Ordering::Equal => !floor.is_even(),
            std::cmp::Ordering::Greater => true,
        };
        if up { floor + Integer::one() } else { floor }
    }

    /// The number of binary digits of numerator and denominator together: a
    /// measure of what an operation on this costs.
    #[must_use]
    pub fn bits(&self) -> u64 {
        backend::rat_bits(&self.0)
    }
}

impl From<Integer> for Rational {
    fn from(value: Integer) -> Rational {
        Rational(backend::Rat::from(value.0))
    }
}

/// A copy: what takes a number takes a reference to one.
impl From<&Rational> for Rational {
    fn from(value: &Rational) -> Rational {
        value.clone()
    }
}

macro_rules! from_machine {
    ($($type:ty),*) => {$(
        impl From<$type> for Rational {
            fn from(value: $type) -> Rational {
                Rational::from(Integer::from(value))
            }
        }
    )*};
}
from_machine!(i32, u32, i64, u64, i128, usize);

impl fmt::Display for Rational {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.is_integer() {
            f.pad(&self.numerator().to_string())
        } else {
            f.pad(&format!("{}/{}", self.numerator(), self.denominator()))
        }
    }
}
