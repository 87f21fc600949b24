//! Operators, order and conversions of [`Rational`].

use super::Form::{Large, Words};
use super::{Fraction, Rational};
use crate::exact::Integer;
use crate::exact::ops::{binary_operator, computed_operator, ring_basics};
use crate::exact::word;
use crate::stop::check;
use std::cmp::Ordering;
use std::ops::Neg;

computed_operator!(Rational, add, add_in_place, Add::add, AddAssign::add_assign);
computed_operator!(Rational, sub, sub_in_place, Sub::sub, SubAssign::sub_assign);
computed_operator!(Rational, mul, mul_in_place, Mul::mul, MulAssign::mul_assign);
computed_operator!(Rational, div, div_in_place, Div::div, DivAssign::div_assign);
computed_operator!(Rational, rem, rem_in_place, Rem::rem, RemAssign::rem_assign);
ring_basics!(Rational);

fn add(a: &Rational, b: &Rational) -> Rational {
    check();
    if let (Words(p, q), Words(r, s)) = (&a.0, &b.0) {
        return Rational::of_words(word::sum((i128::from(*p), *q), (i128::from(*r), *s)));
    }
    let (a, b) = (a.fraction(), b.fraction());
    sum(&a, &b.p, &b.q)
}

fn sub(a: &Rational, b: &Rational) -> Rational {
    check();
    if let (Words(p, q), Words(r, s)) = (&a.0, &b.0) {
        return Rational::of_words(word::sum((i128::from(*p), *q), (-i128::from(*r), *s)));
    }
    let (a, b) = (a.fraction(), b.fraction());
    sum(&a, &-&b.p, &b.q)
}

fn mul(a: &Rational, b: &Rational) -> Rational {
    check();
    if let (Words(p, q), Words(r, s)) = (&a.0, &b.0) {
        return Rational::of_words(word::product((*p, *q), (*r, *s)));
    }
    let (a, b) = (a.fraction(), b.fraction());
    let (first, second) = (a.p.gcd(&b.q), b.p.gcd(&a.q));
    Rational::of(
        a.p.div_exact(&first) * b.p.div_exact(&second),
        a.q.div_exact(&second) * b.q.div_exact(&first),
    )
}

fn div(a: &Rational, b: &Rational) -> Rational {
    mul(a, &b.recip())
}

/// a − b·n, where n is a/b without its fractional part: of the sign of a, and below b in absolute value.
fn rem(a: &Rational, b: &Rational) -> Rational {
    a - b * Rational::from(div(a, b).trunc())
}

/// p/q + r/s. Every common factor of the numerator and the least common denominator
/// divides gcd(q, s) (Knuth 1997, 4.5.1).
fn sum(Fraction { p, q }: &Fraction, r: &Integer, s: &Integer) -> Rational {
    let divisor = q.gcd(s);
    let (reduced, cofactor) = (q.div_exact(&divisor), s.div_exact(&divisor));
    let numerator = p * &cofactor + r * &reduced;
    let shared = numerator.gcd(&divisor);
    Rational::of(numerator.div_exact(&shared), reduced * s.div_exact(&shared))
}

impl Neg for &Rational {
    type Output = Rational;
    fn neg(self) -> Rational {
        match &self.0 {
            Words(p, q) => Rational::of_words((-i128::from(*p), i128::from(*q))),
            Large(fraction) => Rational::of(-&fraction.p, fraction.q.clone()),
        }
    }
}

impl Ord for Rational {
    fn cmp(&self, other: &Rational) -> Ordering {
        if let (Words(p, q), Words(r, s)) = (&self.0, &other.0) {
            return (i128::from(*p) * i128::from(*s)).cmp(&(i128::from(*r) * i128::from(*q)));
        }
        self.sign().cmp(&other.sign()).then_with(|| {
            let (a, b) = (self.fraction(), other.fraction());
            (&a.p * &b.q).cmp(&(&b.p * &a.q))
        })
    }
}

impl From<&Integer> for Rational {
    fn from(value: &Integer) -> Rational {
        Rational::from(value.clone())
    }
}

impl From<Integer> for Rational {
    fn from(value: Integer) -> Rational {
        Rational::of(value, Integer::one())
    }
}

/// Clones, so that `impl Into` accepts references.
impl From<&Rational> for Rational {
    fn from(value: &Rational) -> Rational {
        value.clone()
    }
}
