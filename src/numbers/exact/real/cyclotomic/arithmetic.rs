//! The arithmetic operators of [`RealCyclotomic`].

use super::field::Field;
use super::norm::cofactor;
use super::number::{Element, Form, RealCyclotomic};
use super::row_product::left_product;
use crate::exact::{Integer, Rational, Real, Scalar};
use std::ops::{Add, Div, Mul, Neg, Sub};
use std::sync::Arc;

/// The field of lowest conductor that holds both.
///
/// # Panics
/// When the conductor of that field is beyond the cap.
fn common_field(left: &Element, right: &Element) -> Arc<Field> {
    if Arc::ptr_eq(&left.field, &right.field) {
        return Arc::clone(&left.field);
    }
    Field::of(num_integer::lcm(left.field.conductor(), right.field.conductor()))
}

impl Element {
    fn scaled(&self, factor: &Rational) -> RealCyclotomic {
        let p = factor.numerator();
        let numerators = self.numerators.iter().map(|a| a * &p).collect();
        let denominator = &self.denominator * factor.denominator();
        RealCyclotomic::normal(Arc::clone(&self.field), numerators, denominator)
    }

    fn plus_rational(&self, value: &Rational) -> RealCyclotomic {
        let (p, q) = (value.numerator(), value.denominator());
        let mut numerators: Vec<Integer> = self.numerators.iter().map(|a| a * &q).collect();
        numerators[0] += &(p * &self.denominator);
        RealCyclotomic::normal(Arc::clone(&self.field), numerators, &self.denominator * &q)
    }

    fn plus(&self, other: &Element) -> RealCyclotomic {
        let field = common_field(self, other);
        let (left, right) = (self.lifted(&field), other.lifted(&field));
        if self.denominator == other.denominator {
            let sum = left.iter().zip(&*right).map(|(a, b)| a + b).collect();
            return RealCyclotomic::normal(field, sum, self.denominator.clone());
        }
        let denominator = self.denominator.lcm(&other.denominator);
        let p = denominator.div_floor(&self.denominator);
        let q = denominator.div_floor(&other.denominator);
        let sum = left.iter().zip(&*right).map(|(a, b)| a * &p + b * &q).collect();
        RealCyclotomic::normal(field, sum, denominator)
    }

    fn times(&self, other: &Element) -> RealCyclotomic {
        let field = common_field(self, other);
        let product = field.multiply(&self.lifted(&field), &other.lifted(&field));
        RealCyclotomic::normal(field, product, &self.denominator * &other.denominator)
    }

    /// The inverse q/f of the number f/q: q·A/N, where N is the norm of f and f·A = N.
    fn recip(&self) -> RealCyclotomic {
        let (numerators, norm) = cofactor(&self.field, &self.numerators);
        let factor = Rational::new(self.denominator.clone(), norm);
        Element { field: Arc::clone(&self.field), numerators, denominator: Integer::one() }
            .scaled(&factor)
    }
}

impl RealCyclotomic {
    /// 1/self, computed from the norm of the numerator. The norm is found modulo as many
    /// primes of 31 bits as its digits require. Each prime takes O(m²) operations in a
    /// field of degree m.
    ///
    /// # Panics
    /// When this is 0.
    ///
    /// ```
    /// use subcert::exact::{Rational, RealCyclotomic};
    ///
    /// // 1/(2cos36°) = 2cos36° − 1
    /// let golden = &RealCyclotomic::from(2) * &RealCyclotomic::cosine(&Rational::new(1, 10))?;
    /// assert_eq!(golden.recip(), &golden - &RealCyclotomic::from(1));
    /// # Ok::<(), subcert::exact::CosineError>(())
    /// ```
    #[must_use]
    pub fn recip(&self) -> RealCyclotomic {
        match &self.0 {
            Form::Rational(value) => RealCyclotomic::from(value.recip()),
            Form::Irrational(element) => element.recip(),
        }
    }

    /// The cost of [`recip`](Self::recip) in units of 64 operations: m² operations for
    /// each prime of 31 bits that the bound (Σ_k 2|a_k|)^m on the norm requires.
    pub(crate) fn recip_cost(&self) -> u64 {
        let Form::Irrational(element) = &self.0 else { return self.bits() };
        let degree = element.field.degree() as u64;
        let sum: Integer = element.terms().map(|(_, a)| a.abs()).sum();
        let primes = degree.saturating_mul(sum.bits() + 1) / 30 + 1;
        (degree * degree / 64 + 1).saturating_mul(primes)
    }

    /// The least common denominator of the coefficients of all `values`.
    pub(super) fn denominator(values: &[RealCyclotomic]) -> Integer {
        values.iter().fold(Integer::one(), |lcm, value| match &value.0 {
            Form::Rational(value) => lcm.lcm(&value.denominator()),
            Form::Irrational(element) => lcm.lcm(&element.denominator),
        })
    }

    /// Adds or subtracts in place, if both numbers are in one field and have denominator
    /// 1, so that no reduction to lowest terms is needed. Returns whether it did so.
    fn add_in_place(&mut self, other: &RealCyclotomic, subtract: bool) -> bool {
        let (Form::Irrational(this), Form::Irrational(other)) = (&mut self.0, &other.0) else {
            return false;
        };
        let one = Integer::one();
        let whole = this.denominator == one && other.denominator == one;
        if !whole || !Arc::ptr_eq(&this.field, &other.field) {
            return false;
        }
        for (a, b) in this.numerators.iter_mut().zip(&other.numerators) {
            if subtract {
                *a -= b;
            } else {
                *a += b;
            }
        }
        if this.numerators[1..].iter().all(Integer::is_zero) {
            *self = RealCyclotomic::from(this.numerators.swap_remove(0));
        }
        true
    }

    /// |self|.
    #[must_use]
    pub fn abs(&self) -> RealCyclotomic {
        if self.sign() < 0 { -self } else { self.clone() }
    }
}

impl Neg for &RealCyclotomic {
    type Output = RealCyclotomic;
    fn neg(self) -> RealCyclotomic {
        match &self.0 {
            Form::Rational(value) => RealCyclotomic::from(-value),
            Form::Irrational(element) => {
                let numerators = element.numerators.iter().map(|a| -a).collect();
                RealCyclotomic(Form::Irrational(Element { numerators, ..element.clone() }))
            }
        }
    }
}

impl Add for &RealCyclotomic {
    type Output = RealCyclotomic;
    fn add(self, other: &RealCyclotomic) -> RealCyclotomic {
        match (&self.0, &other.0) {
            (Form::Rational(a), Form::Rational(b)) => RealCyclotomic::from(a + b),
            (Form::Irrational(a), Form::Rational(b)) | (Form::Rational(b), Form::Irrational(a)) => {
                a.plus_rational(b)
            }
            (Form::Irrational(a), Form::Irrational(b)) => a.plus(b),
        }
    }
}

impl Sub for &RealCyclotomic {
    type Output = RealCyclotomic;
    fn sub(self, other: &RealCyclotomic) -> RealCyclotomic {
        self + &-other
    }
}

impl Mul for &RealCyclotomic {
    type Output = RealCyclotomic;
    fn mul(self, other: &RealCyclotomic) -> RealCyclotomic {
        match (&self.0, &other.0) {
            (Form::Rational(a), Form::Rational(b)) => RealCyclotomic::from(a * b),
            (Form::Irrational(a), Form::Rational(b)) | (Form::Rational(b), Form::Irrational(a)) => {
                a.scaled(b)
            }
            (Form::Irrational(a), Form::Irrational(b)) => a.times(b),
        }
    }
}

impl Div for &RealCyclotomic {
    type Output = RealCyclotomic;
    /// # Panics
    /// When `other` is 0.
    fn div(self, other: &RealCyclotomic) -> RealCyclotomic {
        self.times(&other.recip())
    }
}

impl Scalar for RealCyclotomic {
    fn from_rational(value: &Rational) -> Self {
        RealCyclotomic::from(value.clone())
    }
    fn plus(&self, other: &Self) -> Self {
        self + other
    }
    fn accumulate(&mut self, other: &Self) {
        if !self.add_in_place(other, false) {
            *self = &*self + other;
        }
    }
    fn minus(&self, other: &Self) -> Self {
        self - other
    }
    fn lessen(&mut self, other: &Self) {
        if !self.add_in_place(other, true) {
            *self = &*self - other;
        }
    }
    fn times(&self, other: &Self) -> Self {
        self * other
    }
    fn common_denominator(values: &[Self]) -> Integer {
        RealCyclotomic::denominator(values)
    }
    fn left_product(w: &[Self], values: &[Self], names: &[Vec<u32>]) -> Vec<Self> {
        left_product(w, values, names)
    }
}

impl Real for RealCyclotomic {
    fn magnitude(&self) -> Self {
        self.abs()
    }
    fn greater(&self, other: &Self) -> Self {
        if self < other { other.clone() } else { self.clone() }
    }
    fn over(&self, other: &Self) -> Self {
        self / other
    }
    fn rounded(values: &[Self]) -> Option<Vec<i64>> {
        RealCyclotomic::rounded(values)
    }
}
