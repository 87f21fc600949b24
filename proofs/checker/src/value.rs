//! Values of formulas: polynomials in symbols, most of them without any.

use crate::decimal::{Q, int};
use crate::number::Number;
use crate::reject::Stop;
use crate::root::{Root, sign_between};
use num_bigint::BigInt;
use num_integer::Integer;
use num_traits::{One, Zero};
use std::cmp::Ordering;
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::rc::Rc;

/// The most binary digits of a number, and the most terms of a polynomial.
const MAX_SIZE: u64 = 500_000;

/// The greatest degree of a polynomial whose sign is asked for.
const MAX_DEGREE: u32 = 256;

/// An open interval of a symbol, `None` where an end is infinite; or one number.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The symbol.
    pub symbol: Rc<str>,
    /// The lower end.
    pub low: Option<Root>,
    /// The upper end; where both are the same, the piece is this number.
    pub high: Option<Root>,
}

/// Symbols with their powers, by name.
type Monomial = Vec<(Rc<str>, u32)>;

/// A polynomial, or a number.
#[derive(Clone, Debug, PartialEq)]
pub struct Value {
    /// Monomials with their coefficients, none of which is 0.
    terms: BTreeMap<Monomial, Number>,
}

const SIZE: Stop = Stop::Capped("the size of a number or polynomial");

impl From<Number> for Value {
    fn from(number: Number) -> Value {
        let terms = [(Monomial::new(), number)];
        Value { terms: terms.into_iter().filter(|(_, number)| !number.is_zero()).collect() }
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
        Value::from(int(value))
    }

    /// A symbol.
    pub fn symbol(name: &str) -> Value {
        Value { terms: BTreeMap::from([(vec![(Rc::from(name), 1)], Number::from(Q::one()))]) }
    }

    /// This as a number, if it is one.
    pub fn number(&self) -> Result<Number, Stop> {
        match self.terms.first_key_value() {
            None => Ok(Number::from(Q::zero())),
            Some((monomial, number)) if monomial.is_empty() && self.terms.len() == 1 => {
                Ok(number.clone())
            }
            _ => Err(Stop::Wrong("this has no value while a name is a symbol".into())),
        }
    }

    /// This as a rational number, if it is one.
    pub fn rational(&self) -> Option<Q> {
        self.number().ok()?.rational()
    }

    /// Whether it is 0, as a polynomial.
    pub fn is_zero(&self) -> bool {
        self.terms.is_empty()
    }

    fn size(&self) -> u64 {
        self.terms.values().map(|c| 1 + c.bits()).sum()
    }

    /// About what self · other costs: sixteen products of 64 binary digits, or one of
    /// two terms, count as one.
    pub fn cost(&self, other: &Value) -> u64 {
        let limbs = (self.size() / 64).saturating_mul(other.size() / 64);
        ((self.terms.len() * other.terms.len()) as u64).saturating_add(limbs / 16)
    }

    /// self + factor·other.
    pub fn plus(&self, factor: i64, other: &Value) -> Result<Value, Stop> {
        let mut sum = self.clone();
        sum.add(factor, other)?;
        Ok(sum)
    }

    /// The same, in the place of this value.
    pub fn add(&mut self, factor: i64, other: &Value) -> Result<(), Stop> {
        let mut terms = other.terms.iter();
        terms.try_for_each(|(monomial, term)| self.add_term(monomial.clone(), factor, term))
    }

    fn add_term(&mut self, on: Monomial, factor: i64, term: &Number) -> Result<(), Stop> {
        match self.terms.entry(on) {
            Entry::Vacant(place) => {
                place.insert(term.times_integer(factor));
            }
            Entry::Occupied(mut known) => {
                let sum = known.get().plus(factor, term)?;
                if sum.is_zero() {
                    known.remove();
                } else {
                    known.insert(sum);
                }
            }
        }
        Ok(())
    }

    /// A common denominator.
    pub fn denominator(values: &[Value]) -> Value {
        let numbers = values.iter().flat_map(|value| value.terms.values());
        let common = numbers.fold(BigInt::one(), |common, number| common.lcm(number.bottom()));
        Q::from_integer(common).into()
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
        let terms = (self.terms.len() * other.terms.len()) as u64;
        if self.size().saturating_add(other.size()) > MAX_SIZE || terms > MAX_SIZE {
            return Err(SIZE);
        }
        let mut product = Value::int(0);
        for (a, x) in &self.terms {
            for (b, y) in &other.terms {
                product.add_term(joined(a, b), 1, &x.times(y)?)?;
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

    /// The sign: of a polynomial, the one it has on the whole piece.
    pub fn sign(&self, piece: Option<&Piece>) -> Result<i8, Stop> {
        let piece = match (self.number(), piece) {
            (Err(_), Some(piece)) => piece,
            (number, _) => return number?.sign(),
        };
        let polynomial = self.univariate(&piece.symbol);
        let polynomial = polynomial.ok_or(Stop::Wrong("no polynomial in one symbol".into()))?;
        match (&piece.low, &piece.high) {
            (Some(low), Some(high)) if low == high => low.sign_of(&polynomial),
            (low, high) => {
                let sign = sign_between(&polynomial, low.as_ref(), high.as_ref())?;
                sign.map_err(Stop::Split)
            }
        }
    }

    /// The rational coefficients on the powers of a symbol, if it has no other.
    fn univariate(&self, symbol: &str) -> Option<Vec<Q>> {
        let mut polynomial = Vec::new();
        for (monomial, coefficient) in &self.terms {
            let power = match &monomial[..] {
                [] => 0,
                [(name, power)] if **name == *symbol && *power <= MAX_DEGREE => *power as usize,
                _ => return None,
            };
            polynomial.resize(polynomial.len().max(power + 1), Q::zero());
            polynomial[power] = coefficient.rational()?;
        }
        Some(polynomial)
    }

    /// The coefficient on a symbol, if there is nothing else.
    pub fn multiple_of(&self, symbol: &str) -> Option<Q> {
        match &self.univariate(symbol)?[..] {
            [] => Some(Q::zero()),
            [constant, multiple] if constant.is_zero() => Some(multiple.clone()),
            _ => None,
        }
    }

    /// |self|.
    pub fn abs(&self, piece: Option<&Piece>) -> Result<Value, Stop> {
        if self.sign(piece)? < 0 { self.negated() } else { Ok(self.clone()) }
    }

    /// The greater of the two.
    pub fn max(&self, other: &Value, piece: Option<&Piece>) -> Result<Value, Stop> {
        let less = self.compare_on(other, piece)?.is_lt();
        Ok(if less { other.clone() } else { self.clone() })
    }

    /// How two numbers compare.
    pub fn compare(&self, other: &Value) -> Result<Ordering, Stop> {
        self.compare_on(other, None)
    }

    /// The same of polynomials on a piece.
    pub fn compare_on(&self, other: &Value, piece: Option<&Piece>) -> Result<Ordering, Stop> {
        match (self.rational(), other.rational()) {
            (Some(one), Some(other)) => Ok(one.cmp(&other)),
            _ => Ok(self.minus(other)?.sign(piece)?.cmp(&0)),
        }
    }

    /// Whether the two are equal, as polynomials.
    pub fn equals(&self, other: &Value) -> Result<bool, Stop> {
        Ok(self.minus(other)?.is_zero())
    }

    /// An integer from −limit to limit.
    pub fn integer(&self, limit: i64) -> Result<i64, Stop> {
        let integer = self.rational().filter(Q::is_integer);
        let integer = integer.and_then(|value| i64::try_from(value.numer()).ok());
        let integer = integer.filter(|value| value.abs() <= limit);
        integer.ok_or_else(|| Stop::Wrong(format!("an integer up to {limit} is needed")))
    }

    /// ⌊self⌋.
    pub fn floor(&self) -> Result<BigInt, Stop> {
        self.number()?.floor()
    }
}

/// The product of two monomials.
fn joined(left: &Monomial, right: &Monomial) -> Monomial {
    let mut product = left.clone();
    for (name, power) in right {
        match product.binary_search_by(|(known, _)| known.cmp(name)) {
            Ok(at) => product[at].1 = product[at].1.saturating_add(*power),
            Err(at) => product.insert(at, (Rc::clone(name), *power)),
        }
    }
    product
}
