//! Quotients of polynomials in t and cos(π/t), and square roots of them.

use super::quotient::Quotient;
use super::sign::{COSINE, FREE, INDEX, NEAR, PLACE, TURN};
use super::sum::{MAX_TERMS, Sum, inverse_of, product, sign_of};
use crate::exact::{
    Polynomial, Rational, RationalPolynomial, RealCyclotomic, RealExpression, Scalar,
};
use std::cmp::Ordering;
use std::fmt;

/// The greatest multiple of the angle π/t.
const MAX_MULTIPLE: i64 = 128;

/// A function of an integer t, for all t from one on: Σ_S f_S Π_{s∈S} √d_s, with quotients f_S of polynomials in t and
/// cos(π/t), and such polynomials d_s > 0.
///
/// ```
/// use std::cmp::Ordering;
/// use subcert::exact::{IntegerFunction, Rational, Scalar};
///
/// let t = IntegerFunction::index(3);
/// let square = t.times(&t).plus(&IntegerFunction::from_rational(&Rational::from(1)));
/// let root = square.square_root().expect("a square root of what is positive");
/// assert_eq!(root.minus(&t).sign(), Some(Ordering::Greater));
/// assert_eq!(root.times(&root).minus(&square).sign(), Some(Ordering::Equal));
/// ```
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct IntegerFunction {
    /// The least t; 0 for numbers.
    first: i64,
    /// `None` where an operation has no such function.
    sum: Option<Sum>,
}

impl IntegerFunction {
    /// t, for t ≥ `first` ≥ 16.
    ///
    /// # Panics
    /// When `first` is less.
    #[must_use]
    pub fn index(first: i64) -> IntegerFunction {
        assert!(first >= 3, "the least t");
        IntegerFunction::of(first, Quotient::from(Polynomial::variable(INDEX)))
    }

    /// An integer d of which only 6 < d < t − 6 is known.
    #[must_use]
    pub fn place(first: i64) -> IntegerFunction {
        IntegerFunction::of(first, Quotient::from(Polynomial::variable(PLACE)))
    }

    /// The distances d of which the values are looked at one by one are at most this.
    pub const NEAR: i64 = NEAR;

    /// cos(kπ/t).
    #[must_use]
    pub fn half_cosine(first: i64, k: i64) -> IntegerFunction {
        IntegerFunction::of(first, Quotient::from(chebyshev(COSINE, k.unsigned_abs())))
    }

    /// A polynomial in t.
    #[must_use]
    pub fn polynomial(first: i64, p: &RationalPolynomial) -> IntegerFunction {
        IntegerFunction::of(first, Quotient::from(p.in_name(INDEX)))
    }

    /// A number of which nothing is known.
    #[must_use]
    pub fn free(first: i64) -> IntegerFunction {
        IntegerFunction::of(first, Quotient::from(Polynomial::variable(FREE)))
    }

    /// The a and b of a + bx, where x is [free](Self::free) and stands in neither.
    #[must_use]
    pub fn line_in_free(&self) -> Option<[IntegerFunction; 2]> {
        let Quotient { numerator, denominator } = self.quotient()?;
        let powers = numerator.by_powers(FREE);
        if powers.len() > 2 || denominator.by_powers(FREE).len() > 1 {
            return None;
        }
        Some([0, 1].map(|i| {
            let power = powers.get(i).cloned().unwrap_or_default();
            IntegerFunction::of(self.first, Quotient::new(&power, denominator))
        }))
    }

    fn of(first: i64, quotient: Quotient) -> IntegerFunction {
        IntegerFunction { first, sum: Some(Sum::from(quotient)) }
    }

    fn unknown(first: i64) -> IntegerFunction {
        IntegerFunction { first, sum: None }
    }

    /// Whether some operation had no such function.
    #[must_use]
    pub fn is_unknown(&self) -> bool {
        self.sum.is_none()
    }

    /// The number that this is for all t.
    #[must_use]
    pub fn as_constant(&self) -> Option<Rational> {
        self.quotient()?.as_constant()
    }

    fn quotient(&self) -> Option<&Quotient> {
        let (first, others) = self.sum.as_ref()?.coefficients.split_first()?;
        others.iter().all(Quotient::is_zero).then_some(first)
    }

    /// This as a polynomial in t, if it is one.
    #[must_use]
    pub fn as_polynomial(&self) -> Option<RationalPolynomial> {
        let Quotient { numerator, denominator } = self.quotient()?;
        denominator.as_constant()?;
        numerator.in_variable(INDEX)
    }

    /// The number of terms of its polynomials.
    #[must_use]
    pub fn term_count(&self) -> usize {
        self.sum.as_ref().map_or(0, Sum::term_count)
    }

    /// The bits of the coefficients of its polynomials.
    #[must_use]
    pub fn bits(&self) -> u64 {
        let of = |p: &Polynomial| p.coefficients().map(RealCyclotomic::bits).sum::<u64>();
        self.sum.as_ref().map_or(0, |sum| {
            let radicals: u64 = sum.radicals.iter().map(of).sum();
            let quotients = sum.coefficients.iter();
            radicals + quotients.map(|f| of(&f.numerator) + of(&f.denominator)).sum::<u64>()
        })
    }

    /// The sign, if it is one for all t, and is found.
    #[must_use]
    pub fn sign(&self) -> Option<Ordering> {
        let sum = self.sum.as_ref()?;
        sign_of(&sum.coefficients, &sum.radicals, self.first)
    }

    /// The value at a t that counts; `None` where cos(π/t) lies in no field of [`RealCyclotomic`] within the caps.
    #[must_use]
    pub fn value_at(&self, t: i64) -> Option<RealExpression> {
        let cosine = RealCyclotomic::cosine(&Rational::new(1, t.checked_mul(2)?)).ok()?;
        let point = Rational::from(t);
        let value = |p: &Polynomial| {
            p.by_powers(COSINE).iter().rev().try_fold(RealCyclotomic::from(0), |sum, c| {
                let c = c.in_variable(INDEX)?.value_at(&point);
                Some(&(&sum * &cosine) + &RealCyclotomic::from(c))
            })
        };
        let sum = self.sum.as_ref()?;
        let roots = sum.radicals.iter().map(|d| RealExpression::from(value(d)?).sqrt().ok());
        let roots = roots.collect::<Option<Vec<RealExpression>>>()?;
        let mut total = RealExpression::zero();
        for (set, Quotient { numerator, denominator }) in sum.coefficients.iter().enumerate() {
            let quotient = &value(numerator)? / &value(denominator)?;
            let own = roots.iter().enumerate().filter(|(i, _)| set >> i & 1 == 1);
            let term = own.fold(RealExpression::from(quotient), |term, (_, root)| term.times(root));
            total = total.plus(&term);
        }
        Some(total)
    }

    /// 1/self, if this is shown to be 0 for no t.
    #[must_use]
    pub fn inverse(&self) -> Option<IntegerFunction> {
        let sum = self.sum.as_ref()?;
        let coefficients = inverse_of(&sum.coefficients, &sum.radicals, self.first)?;
        let sum = Sum { radicals: sum.radicals.clone(), coefficients };
        Some(IntegerFunction { first: self.first, sum: Some(sum) })
    }

    /// √self, if this has no square roots in it and is shown to be negative for no t.
    #[must_use]
    pub fn square_root(&self) -> Option<IntegerFunction> {
        let quotient = self.quotient()?;
        match quotient.sign_from(self.first)? {
            Ordering::Less => None,
            Ordering::Equal => Some(IntegerFunction::zero()),
            Ordering::Greater => {
                let Quotient { numerator, denominator } = quotient;
                // √(p/q) = √(pq)/|q|.
                let inverse = Quotient::from(denominator.clone()).inverse_from(self.first)?;
                let inverse = match inverse.sign_from(self.first)? {
                    Ordering::Less => inverse.negated(),
                    _ => inverse,
                };
                let radicals = vec![numerator * denominator];
                let coefficients = vec![Quotient::constant(&Rational::zero()), inverse];
                let sum = Some(Sum { radicals, coefficients });
                Some(IntegerFunction { first: self.first, sum })
            }
        }
    }

    /// cos(2π·self), if this is α + β/t with 2α and 2β integers, or α + rd/t with an integer r, |r| ≤ 6.
    #[must_use]
    pub fn cosine(&self) -> Option<IntegerFunction> {
        let index = Quotient::from(Polynomial::variable(INDEX));
        let turns = self.quotient()?.times(&index);
        turns.denominator.as_constant()?;
        let turns = turns.numerator;
        if turns.linear()?.iter().any(|name| ![INDEX, PLACE].contains(name)) {
            return None;
        }
        let integer = |c: &RealCyclotomic, factor: i64| {
            let scaled = c.as_rational()? * &Rational::from(factor);
            scaled.is_integer().then(|| scaled.numerator().within(MAX_MULTIPLE))?
        };
        let halves = integer(&turns.coefficient(INDEX), 2)?;
        let multiple =
            turns.by_powers(PLACE).first().map_or_else(Polynomial::default, Clone::clone);
        let multiple = multiple.by_powers(INDEX).into_iter().next().unwrap_or_default();
        let multiple = integer(&multiple.as_constant()?, 2)?;
        let place = integer(&turns.coefficient(PLACE), 1)?;
        let cosine = match (place, multiple) {
            (0, k) => chebyshev(COSINE, k.unsigned_abs()),
            (r, 0) if r.abs() <= NEAR => chebyshev(TURN, r.unsigned_abs()),
            _ => return None,
        };
        let found = IntegerFunction::of(self.first, Quotient::from(cosine));
        Some(if halves % 2 == 0 { found } else { IntegerFunction::zero().minus(&found) })
    }

    /// The b_0, …, b_6 with self = Σ_r b_r cos(2πrd/t); `None` where it is no such sum.
    #[must_use]
    pub fn waves(&self) -> Option<Vec<IntegerFunction>> {
        let quotient = self.quotient()?;
        let has = |p: &Polynomial, name: &str| p.by_powers(name).len() > 1;
        if has(&quotient.numerator, PLACE)
            || [PLACE, TURN].iter().any(|name| has(&quotient.denominator, name))
        {
            return None;
        }
        let mut powers = quotient.numerator.by_powers(TURN);
        let mut waves = Vec::new();
        // The highest power is that of the highest wave.
        while let Some(leading) = powers.pop() {
            let r = powers.len() as u64;
            let wave = chebyshev(TURN, r).by_powers(TURN);
            let scale = wave.last().and_then(Polynomial::as_constant)?.as_rational()?.recip();
            let b = &leading * &Polynomial::constant(scale);
            for (power, c) in powers.iter_mut().zip(&wave) {
                *power = &*power - &(&b * c);
            }
            let b = Quotient::new(&b, &quotient.denominator);
            waves.push(IntegerFunction::of(self.first, b));
        }
        waves.reverse();
        (waves.len() <= usize::try_from(NEAR + 1).ok()?).then_some(waves)
    }
}

/// T_k of a variable.
fn chebyshev(variable: &str, k: u64) -> Polynomial {
    let x = Polynomial::variable(variable);
    let twice = &x + &x;
    let (mut last, mut next) = (Polynomial::constant(1), x);
    for _ in 0..k {
        let following = &(&twice * &next) - &last;
        last = std::mem::replace(&mut next, following);
    }
    last
}

impl From<i64> for IntegerFunction {
    fn from(value: i64) -> IntegerFunction {
        IntegerFunction::from_rational(&Rational::from(value))
    }
}

impl Scalar for IntegerFunction {
    fn from_rational(value: &Rational) -> IntegerFunction {
        IntegerFunction::of(0, Quotient::constant(value))
    }

    fn plus(&self, other: &IntegerFunction) -> IntegerFunction {
        self.with(other, |left, right, _| {
            left.iter().zip(right).map(|(left, right)| left.plus(right)).collect()
        })
    }

    fn minus(&self, other: &IntegerFunction) -> IntegerFunction {
        self.with(other, |left, right, _| {
            left.iter().zip(right).map(|(left, right)| left.plus(&right.negated())).collect()
        })
    }

    fn times(&self, other: &IntegerFunction) -> IntegerFunction {
        self.with(other, product)
    }
}

impl IntegerFunction {
    fn with(
        &self,
        other: &IntegerFunction,
        operation: impl Fn(&[Quotient], &[Quotient], &[Polynomial]) -> Vec<Quotient>,
    ) -> IntegerFunction {
        let first = self.first.max(other.first);
        let both = self.sum.as_ref().zip(other.sum.as_ref());
        let Some((radicals, left, right)) = both.and_then(|(a, b)| a.together(b)) else {
            return IntegerFunction::unknown(first);
        };
        let coefficients = operation(&left, &right, &radicals);
        let sum = Sum { radicals, coefficients };
        let small = sum.term_count() <= MAX_TERMS;
        IntegerFunction { first, sum: Some(sum).filter(|_| small) }
    }
}

impl fmt::Display for IntegerFunction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.quotient() {
            Some(Quotient { numerator, denominator }) if denominator.as_constant().is_some() => {
                write!(f, "{numerator}")
            }
            Some(Quotient { numerator, denominator }) => {
                write!(f, "({numerator})/({denominator})")
            }
            None => write!(f, "a function with square roots"),
        }
    }
}
