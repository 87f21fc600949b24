//! Values of formulas: polynomials in symbols. Most of them are numbers.

use super::decimal::{Q, capped, common_multiple};
use super::number::Number;
use crate::text::Stop;
use num_bigint::BigInt;
use num_traits::Zero;
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most binary digits of a number, and the most terms of a polynomial.
const MAX_SIZE: u64 = 500_000;

/// The greatest degree of a polynomial whose coefficients are asked for.
const MAX_DEGREE: u32 = 256;

/// Symbols with their powers, by name.
type Monomial = Vec<(Rc<str>, u32)>;

/// A polynomial, or a number.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Value {
    /// The coefficient on 1.
    constant: Number,
    /// The coefficients on monomials in symbols. None of them is 0.
    terms: BTreeMap<Monomial, Number>,
}

const SIZE: Stop = Stop::Capped("the size of a number or polynomial");

impl From<Number> for Value {
    fn from(constant: Number) -> Value {
        Value { constant, terms: BTreeMap::new() }
    }
}

impl From<Q> for Value {
    fn from(value: Q) -> Value {
        Number::from(value).into()
    }
}

impl Value {
    /// An integer.
    pub fn int(value: i64) -> Value {
        Number::Small(value, 1).into()
    }

    /// A symbol.
    pub fn symbol(name: &str) -> Value {
        let terms = BTreeMap::from([(vec![(Rc::from(name), 1)], Number::Small(1, 1))]);
        Value { constant: Number::Small(0, 1), terms }
    }

    /// The polynomial in a symbol with these coefficients, the constant one first.
    pub fn polynomial(name: &str, coefficients: Vec<Q>) -> Value {
        let (mut constant, mut terms) = (Number::Small(0, 1), BTreeMap::new());
        let named = (0..).zip(coefficients).filter(|(_, c)| !c.is_zero());
        for (power, c) in named {
            match power {
                0 => constant = c.into(),
                _ => drop(terms.insert(vec![(Rc::from(name), power)], Number::from(c))),
            }
        }
        Value { constant, terms }
    }

    /// The number that this is; an error for a polynomial.
    pub fn number(&self) -> Result<&Number, Stop> {
        if self.terms.is_empty() {
            return Ok(&self.constant);
        }
        Err(Stop::Wrong("this has no value while a name is a symbol".into()))
    }

    /// The rational number that this is, if it is one.
    pub fn rational(&self) -> Option<Q> {
        self.number().ok()?.rational()
    }

    /// The rational numbers that all entries of a mask are; `None` if one is none.
    pub fn rationals(rows: &[Vec<Value>]) -> Option<Vec<Vec<Q>>> {
        rows.iter().map(|row| row.iter().map(Value::rational).collect()).collect()
    }

    /// The monomials with coefficients that are not 0.
    pub fn all(&self) -> impl Iterator<Item = (&[(Rc<str>, u32)], &Number)> + Clone {
        let terms = self.terms.iter().map(|(monomial, number)| (&monomial[..], number));
        let constant = (!self.constant.is_zero()).then_some((&[][..], &self.constant));
        constant.into_iter().chain(terms)
    }

    /// The number of monomials.
    fn count(&self) -> u64 {
        self.terms.len() as u64 + u64::from(!self.constant.is_zero())
    }

    /// Whether it is the polynomial 0.
    pub fn is_zero(&self) -> bool {
        self.count() == 0
    }

    fn is_small(&self) -> bool {
        self.terms.is_empty() && self.constant.is_small()
    }

    fn size(&self) -> u64 {
        self.all().map(|(_, c)| 1 + c.bits()).sum()
    }

    /// An estimate of the steps of self · other. A product of two terms, and sixteen products of 64
    /// binary digits, count as one step.
    pub fn cost(&self, other: &Value) -> u64 {
        if self.is_small() && other.is_small() {
            return 1;
        }
        let limbs = (self.size() / 64).saturating_mul(other.size() / 64);
        (self.count() * other.count()).saturating_add(limbs / 16)
    }

    /// The same with the steps of the coordinates of irrational numbers.
    pub fn steps(&self, other: &Value) -> u64 {
        if self.is_small() && other.is_small() {
            return 1;
        }
        let pairs = self.all().flat_map(|(_, a)| other.all().map(|(_, b)| a.cost_in_field(b)));
        pairs.fold(self.cost(other), u64::saturating_add)
    }

    /// An estimate of the steps of self + other, where these are fractions of large numbers.
    pub fn cost_of_sum(&self, other: &Value) -> u64 {
        self.all().chain(other.all()).map(|(_, number)| number.cost_of_sum()).sum()
    }

    /// An estimate of the steps of self/divisor.
    pub fn cost_of_quotient(&self, divisor: &Value) -> u64 {
        let inverse = divisor.number().map_or(0, Number::cost_of_inverse);
        inverse.saturating_add(self.cost(divisor))
    }

    /// self + factor·other.
    pub fn plus(&self, factor: i64, other: &Value) -> Result<Value, Stop> {
        let mut sum = self.clone();
        sum.add(factor, other)?;
        Ok(sum)
    }

    /// Adds factor·other to this value.
    pub fn add(&mut self, factor: i64, other: &Value) -> Result<(), Stop> {
        other.all().try_for_each(|(monomial, term)| self.add_term(monomial, factor, term))
    }

    fn add_term(&mut self, on: &[(Rc<str>, u32)], factor: i64, term: &Number) -> Result<(), Stop> {
        if on.is_empty() {
            self.constant = self.constant.plus(factor, term)?;
            return Ok(());
        }
        let Some(known) = self.terms.get_mut(on) else {
            self.terms.insert(on.to_vec(), term.times(&Number::Small(factor, 1))?);
            return Ok(());
        };
        *known = known.plus(factor, term)?;
        if known.is_zero() {
            self.terms.remove(on);
        }
        Ok(())
    }

    /// The sum of values.
    pub fn total<'v>(values: impl IntoIterator<Item = &'v Value>) -> Result<Value, Stop> {
        values.into_iter().try_fold(Value::int(0), |sum, value| sum.plus(1, value))
    }

    /// A common denominator.
    pub fn denominator<'v>(values: impl IntoIterator<Item = &'v Value>) -> Result<Value, Stop> {
        let numbers = values.into_iter().flat_map(Value::all);
        let bottoms: Vec<BigInt> = numbers.map(|(_, number)| number.bottom()).collect();
        Ok(Q::from_integer(common_multiple(&bottoms)?).into())
    }

    /// self − other.
    pub fn minus(&self, other: &Value) -> Result<Value, Stop> {
        self.plus(-1, other)
    }

    /// −self.
    pub fn negated(&self) -> Result<Value, Stop> {
        Value::int(0).minus(self)
    }

    /// self · other.
    pub fn times(&self, other: &Value) -> Result<Value, Stop> {
        let terms = self.count() * other.count();
        let small = self.is_small() && other.is_small();
        if !small && (self.size().saturating_add(other.size()) > MAX_SIZE || terms > MAX_SIZE) {
            return Err(SIZE);
        }
        if let (Ok(one), Ok(other)) = (self.number(), other.number()) {
            return Ok(one.times(other)?.into());
        }
        let mut product = Value::int(0);
        for (a, x) in self.all() {
            for (b, y) in other.all() {
                product.add_term(&joined(a, b)?, 1, &x.times(y)?)?;
            }
        }
        Ok(product)
    }

    /// self / divisor, for a divisor that is a number.
    pub fn over(&self, divisor: &Value) -> Result<Value, Stop> {
        let inverse = divisor.number()?.inverse();
        self.times(&inverse.ok_or(Stop::Undefined("division by zero"))?.into())
    }

    /// base^exponent.
    pub fn power(&self, exponent: i64) -> Result<Value, Stop> {
        let size = self.size().saturating_mul(exponent.unsigned_abs());
        let symbolic = self.rational().is_none() && exponent.unsigned_abs() > 64;
        if symbolic || self.size() > 4 && size > MAX_SIZE || exponent.unsigned_abs() > MAX_SIZE {
            return Err(SIZE);
        }
        let (mut power, mut square) = (Value::int(1), self.clone());
        let mut rest = exponent.unsigned_abs();
        while rest > 0 {
            if rest % 2 == 1 {
                power = power.times(&square)?;
            }
            rest /= 2;
            if rest > 0 {
                square = square.times(&square)?;
            }
        }
        if exponent < 0 { Value::int(1).over(&power) } else { Ok(power) }
    }

    /// The rational coefficients on the powers of a symbol, if there is no other symbol.
    pub fn univariate(&self, symbol: &str) -> Option<Vec<Q>> {
        let mut polynomial = Vec::new();
        for (monomial, coefficient) in self.all() {
            let power = match monomial {
                [] => 0,
                [(name, power)] if **name == *symbol && *power <= MAX_DEGREE => *power as usize,
                _ => return None,
            };
            polynomial.resize(polynomial.len().max(power + 1), Q::zero());
            polynomial[power] = coefficient.rational()?;
        }
        Some(polynomial)
    }

    /// The coefficient on a symbol, if there is no other term.
    pub fn multiple_of(&self, symbol: &str) -> Option<Q> {
        match &self.univariate(symbol)?[..] {
            [] => Some(Q::zero()),
            [constant, multiple] if constant.is_zero() => Some(multiple.clone()),
            _ => None,
        }
    }

    /// The symbols of a polynomial of degree at most 1.
    pub fn linear(&self) -> Option<Vec<String>> {
        let symbol = |monomial: &Monomial| match &monomial[..] {
            [(name, 1)] => Some(name.to_string()),
            _ => None,
        };
        self.terms.keys().map(symbol).collect()
    }

    /// The coefficient on a symbol.
    pub fn coefficient(&self, symbol: &str) -> Value {
        let known = self.terms.get(&vec![(Rc::from(symbol), 1)]);
        known.map_or(Value::int(0), |coefficient| coefficient.clone().into())
    }

    /// Whether the two are equal, as polynomials.
    pub fn equals(&self, other: &Value) -> Result<bool, Stop> {
        Ok(self.minus(other)?.is_zero())
    }

    /// An integer from −limit to limit, which is a cap.
    pub fn integer(&self, limit: i64) -> Result<i64, Stop> {
        let integer = self.rational().filter(Q::is_integer);
        let integer = integer.ok_or_else(|| Stop::Wrong("an integer is needed".to_owned()))?;
        capped(integer.numer(), limit).ok_or(Stop::Capped("the size of an integer"))
    }

    /// ⌊self⌋.
    pub fn floor(&self) -> Result<BigInt, Stop> {
        self.number()?.floor()
    }
}

/// The product of two monomials.
fn joined(left: &[(Rc<str>, u32)], right: &[(Rc<str>, u32)]) -> Result<Monomial, Stop> {
    let mut product = left.to_vec();
    for (name, power) in right {
        match product.binary_search_by(|(known, _)| known.cmp(name)) {
            Ok(at) => product[at].1 = product[at].1.checked_add(*power).ok_or(SIZE)?,
            Err(at) => product.insert(at, (Rc::clone(name), *power)),
        }
    }
    Ok(product)
}
