//! Values of formulas: numbers, and polynomials in symbols.

use crate::decimal::{Q, int};
use crate::number::Number;
use crate::sturm;
use num_bigint::BigInt;
use num_traits::{One, Zero};
use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::rc::Rc;

/// The most binary digits of a number, and the most terms of a polynomial.
pub const MAX_SIZE: u64 = 500_000;

/// The greatest degree of a polynomial whose sign is asked for.
const MAX_DEGREE: u32 = 256;

/// Why a formula has no value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Stop {
    /// The paper does not state this parameter.
    Unstated(String),
    /// The definition has no value here: why.
    Undefined(&'static str),
    /// It is beyond what this program computes: which cap.
    Capped(&'static str),
    /// The formula is wrong: why.
    Wrong(String),
    /// A polynomial changes its sign on a piece, here.
    Split(Q),
}

/// An open interval of a symbol; `None` where an end is infinite.
#[derive(Clone, Debug)]
pub struct Piece {
    /// The symbol.
    pub symbol: Rc<str>,
    /// The lower end.
    pub low: Option<Q>,
    /// The upper end.
    pub high: Option<Q>,
}

/// Symbols with their powers, by name.
type Monomial = Vec<(Rc<str>, u32)>;

/// A number, or a polynomial that is none.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Number(Number),
    /// Monomials with their coefficients, none of which is 0.
    Polynomial(BTreeMap<Monomial, Number>),
}

use Value::Polynomial;

const FIELD: Stop = Stop::Capped("the field of the cosines");
const SIZE: Stop = Stop::Capped("the size of a number or polynomial");

impl From<Q> for Value {
    fn from(value: Q) -> Value {
        Value::Number(value.into())
    }
}

impl Value {
    /// An integer.
    pub fn int(value: i64) -> Value {
        Value::from(int(value))
    }

    /// A symbol.
    pub fn symbol(name: &str) -> Value {
        Polynomial(BTreeMap::from([(vec![(Rc::from(name), 1)], Number::from(Q::one()))]))
    }

    /// This as a number, if it is one.
    pub fn number(&self) -> Result<&Number, Stop> {
        match self {
            Value::Number(number) => Ok(number),
            Polynomial(_) => Err(Stop::Wrong("this has no value while a name is a symbol".into())),
        }
    }

    /// This as a rational number, if it is one.
    pub fn rational(&self) -> Option<Q> {
        self.number().ok().and_then(Number::rational)
    }

    /// Whether it is 0, as a polynomial.
    pub fn is_zero(&self) -> bool {
        self.number().is_ok_and(Number::is_zero)
    }

    fn into_terms(self) -> BTreeMap<Monomial, Number> {
        match self {
            Polynomial(terms) => terms,
            Value::Number(number) if number.is_zero() => BTreeMap::new(),
            Value::Number(number) => BTreeMap::from([(Vec::new(), number)]),
        }
    }

    fn from_terms(mut terms: BTreeMap<Monomial, Number>) -> Value {
        terms.retain(|_, coefficient| !coefficient.is_zero());
        if terms.keys().all(Vec::is_empty) {
            let constant = terms.into_values().next();
            return Value::Number(constant.unwrap_or_else(|| Q::zero().into()));
        }
        Polynomial(terms)
    }

    fn size(&self) -> u64 {
        match self {
            Value::Number(number) => number.bits(),
            Polynomial(terms) => terms.values().map(|c| 1 + c.bits()).sum(),
        }
    }

    /// About what self · other costs: sixteen products of 64 binary digits, or one of
    /// two terms, count as one.
    pub fn cost(&self, other: &Value) -> u64 {
        let terms = |value: &Value| match value {
            Value::Number(_) => 1,
            Polynomial(terms) => terms.len() as u64,
        };
        let limbs = (self.size() / 64).saturating_mul(other.size() / 64);
        (terms(self) * terms(other)).saturating_add(limbs / 16)
    }

    /// self + factor·other.
    pub fn plus(&self, factor: i64, other: &Value) -> Result<Value, Stop> {
        if let (Value::Number(a), Value::Number(b)) = (self, other) {
            return Ok(Value::Number(a.plus(factor, b).ok_or(FIELD)?));
        }
        self.clone().add(factor, other)
    }

    /// The same, in the place of this value.
    pub fn add(self, factor: i64, other: &Value) -> Result<Value, Stop> {
        let mut sum = match self {
            Value::Number(_) if matches!(other, Value::Number(_)) => {
                return self.plus(factor, other);
            }
            value => value.into_terms(),
        };
        for (monomial, coefficient) in other.clone().into_terms() {
            let known = sum.entry(monomial).or_insert_with(|| Q::zero().into());
            *known = known.plus(factor, &coefficient).ok_or(FIELD)?;
        }
        Ok(Value::from_terms(sum))
    }

    /// self · other.
    pub fn times(&self, other: &Value) -> Result<Value, Stop> {
        if self.size().saturating_add(other.size()) > MAX_SIZE {
            return Err(SIZE);
        }
        if let (Value::Number(a), Value::Number(b)) = (self, other) {
            return Ok(Value::Number(a.times(b).ok_or(FIELD)?));
        }
        let (left, right) = (self.clone().into_terms(), other.clone().into_terms());
        if (left.len() * right.len()) as u64 > MAX_SIZE {
            return Err(SIZE);
        }
        let mut product: BTreeMap<Monomial, Number> = BTreeMap::new();
        for (a, x) in &left {
            for (b, y) in &right {
                let monomial = joined(a, b);
                let term = x.times(y).ok_or(FIELD)?;
                match product.entry(monomial) {
                    Entry::Occupied(mut sum) => {
                        let more = sum.get().plus(1, &term).ok_or(FIELD)?;
                        sum.insert(more);
                    }
                    Entry::Vacant(place) => {
                        place.insert(term);
                    }
                }
            }
        }
        Ok(Value::from_terms(product))
    }

    /// self / divisor, for a divisor that is a number.
    pub fn over(&self, divisor: &Value) -> Result<Value, Stop> {
        let divisor = divisor.number()?;
        if divisor.is_zero() {
            return Err(Stop::Undefined("division by zero"));
        }
        self.times(&Value::Number(divisor.inverse().ok_or(FIELD)?))
    }

    /// base^exponent.
    pub fn power(&self, exponent: i64) -> Result<Value, Stop> {
        let size = self.size().saturating_mul(exponent.unsigned_abs());
        let symbolic = self.rational().is_none() && exponent.unsigned_abs() > 64;
        if symbolic || self.size() > 3 && size > MAX_SIZE || exponent.unsigned_abs() > MAX_SIZE {
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
        if let Value::Number(number) = self {
            return number.sign().ok_or(Stop::Capped("the precision of a sign"));
        }
        let symbolic = || Stop::Wrong("this has no value while a name is a symbol".into());
        let piece = piece.ok_or_else(symbolic)?;
        let polynomial = self.univariate(&piece.symbol).ok_or_else(symbolic)?;
        let sign = sturm::sign_on(&polynomial, piece.low.as_ref(), piece.high.as_ref());
        sign.ok_or_else(|| match &polynomial[..] {
            [constant, slope] => Stop::Split(-constant / slope),
            _ => Stop::Wrong("the sign changes between two breaks".into()),
        })
    }

    /// The rational coefficients on the powers of a symbol, if it has no other.
    fn univariate(&self, symbol: &str) -> Option<Vec<Q>> {
        let mut polynomial = Vec::new();
        for (monomial, coefficient) in self.clone().into_terms() {
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

    /// |self|.
    pub fn abs(&self, piece: Option<&Piece>) -> Result<Value, Stop> {
        if self.sign(piece)? < 0 { Value::int(0).plus(-1, self) } else { Ok(self.clone()) }
    }

    /// The greater of the two.
    pub fn max(&self, other: &Value, piece: Option<&Piece>) -> Result<Value, Stop> {
        let less = self.plus(-1, other)?.sign(piece)? < 0;
        Ok(if less { other.clone() } else { self.clone() })
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
        self.number()?.floor().ok_or(Stop::Capped("the precision of a sign"))
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
