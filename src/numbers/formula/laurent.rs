//! Laurent polynomials as values of formulas: symbols of masks.

use super::ast::Operator;
use super::builtin::{MAX_BITS, apply};
use super::error::FormulaErrorKind;
use super::root_error::RootError;
use super::values::value::Value;
use crate::exact::{CosineError, Integer, Rational, Scalar};
use std::collections::BTreeMap;
use std::fmt;

/// The name of the variable in the text of a symbol.
pub const SYMBOL_VARIABLE: &str = "z";

/// The greatest |k| of a power z^k: more coefficients than any mask has.
pub const MAX_SYMBOL_POWER: u64 = 16_384;

/// The bits counted for each term besides its coefficient.
const TERM_BITS: u64 = 10;

/// How many times [`MAX_BITS`] all coefficients together may have that a division meets.
const DIVISION: u64 = 8;

/// Why there is no quotient.
const REMAINDER: &str = "this division leaves a remainder: a symbol has finitely many powers of z, so that a divisor is a number, a power \
     of z, or a factor of what stands before it, as in (1 - z^4)/(1 - z)";

/// Σ_k c_k z^k over finitely many integers k, also negative ones: the symbol of a mask.
///
/// As a [`Value`] it has sums, products, powers, and those quotients that leave no remainder; every other function has
/// a value only of constants.
///
/// ```
/// use subcert::exact::Rational;
/// use subcert::formula::{Laurent, Parameters, evaluate, parse};
///
/// let symbol = parse("z^-1*(1 - z^4)/(1 - z)/2")?;
/// let z = Parameters::from([("z", Laurent::<Rational>::variable())]);
/// let value = evaluate(&symbol, &z)?;
/// assert_eq!(value.to_string(), "1/2*z^-1 + 1/2 + 1/2*z + 1/2*z^2");
/// assert_eq!(value.powers(), Some((-1, 2)));
/// # Ok::<(), subcert::formula::FormulaError>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Laurent<V = Rational> {
    /// The coefficients by powers. None of them is known to be 0.
    terms: BTreeMap<i64, V>,
}

impl<V: Value> Laurent<V> {
    /// The sum of these coefficients times powers of z.
    pub fn of(terms: impl IntoIterator<Item = (i64, V)>) -> Laurent<V> {
        Laurent { terms: terms.into_iter().filter(|(_, c)| !is_zero(c)).collect() }
    }

    /// c, which is c·z^0.
    #[must_use]
    pub fn constant(c: V) -> Laurent<V> {
        Laurent::of([(0, c)])
    }

    /// z.
    #[must_use]
    pub fn variable() -> Laurent<V> {
        Laurent::of([(1, V::from_rational(&Rational::one()))])
    }

    /// The lowest and the highest power with a coefficient; `None` of 0.
    #[must_use]
    pub fn powers(&self) -> Option<(i64, i64)> {
        Some((*self.terms.first_key_value()?.0, *self.terms.last_key_value()?.0))
    }

    /// The coefficient of z^`power`, 0 where there is none.
    #[must_use]
    pub fn coefficient(&self, power: i64) -> V {
        self.terms.get(&power).cloned().unwrap_or_else(V::zero)
    }

    /// The number that this is, if it is one.
    #[must_use]
    pub fn as_constant(&self) -> Option<V> {
        match self.powers() {
            None | Some((0, 0)) => Some(self.coefficient(0)),
            Some(_) => None,
        }
    }

    /// The greatest |k|.
    fn reach(&self) -> u64 {
        self.powers().map_or(0, |(low, high)| low.unsigned_abs().max(high.unsigned_abs()))
    }

    /// Σ_k ±c_k z^k added to this.
    fn joined(&self, other: &Self, operation: fn(&V, &V) -> V) -> Self {
        let [mut sum, other] = in_one_field(self, other);
        for (power, c) in other.terms {
            let value = operation(&sum.coefficient(power), &c);
            sum.terms.insert(power, value);
        }
        Laurent::of(sum.terms)
    }

    /// The quotient by a divisor of several terms: each step takes away the lowest power that is left, or the highest.
    ///
    /// # Errors
    /// When a remainder is left, or coefficients become too large.
    fn by_steps(&self, divisor: &Self) -> Result<Self, FormulaErrorKind> {
        let (Some((low, high)), Some((first, last))) = (self.powers(), divisor.powers()) else {
            return Ok(self.clone());
        };
        let steps: Vec<i64> = (low - first..=high - last).collect();
        // The power of the divisor whose coefficient can be divided by.
        let divides = |power: &i64| divisor.coefficient(*power).vanishes() == Some(false);
        let end = [first, last].into_iter().find(divides).ok_or(FormulaErrorKind::Unsupported(
            "the lowest or the highest coefficient of a divisor has to be a number that is not 0",
        ))?;
        let lead = divisor.coefficient(end);
        let (mut rest, mut quotient) = (self.terms.clone(), BTreeMap::new());
        let mut left = DIVISION * MAX_BITS;
        for step in 0..steps.len() {
            let k = if end == first { steps[step] } else { steps[steps.len() - 1 - step] };
            let Some(c) = rest.remove(&(k + end)) else { continue };
            let c = apply(Operator::Divide, c, &lead)?;
            for (power, d) in divisor.terms.iter().filter(|(power, _)| **power != end) {
                let product = apply(Operator::Multiply, c.clone(), d)?;
                let known = rest.remove(&(power + k)).unwrap_or_else(V::zero);
                let value = apply(Operator::Subtract, known, &product)?;
                left = left.saturating_sub(TERM_BITS + value.size());
                if !is_zero(&value) {
                    rest.insert(power + k, value);
                }
            }
            if left == 0 {
                let most = DIVISION * MAX_BITS;
                return Err(FormulaErrorKind::too_large("the number of bits of a division", most));
            }
            quotient.insert(k, c);
        }
        if rest.values().all(|c| c.vanishes() == Some(true)) {
            Ok(Laurent::of(quotient))
        } else {
            Err(FormulaErrorKind::Undefined(REMAINDER.to_owned()))
        }
    }
}

/// Whether this is known to be 0 at once.
fn is_zero<V: Value>(value: &V) -> bool {
    value.as_rational().is_some_and(|value| value.is_zero())
}

/// Both with all of their coefficients in one field, if there is one: where two are combined, [`Value::meets`] has found
/// that there is.
fn in_one_field<V: Value>(left: &Laurent<V>, right: &Laurent<V>) -> [Laurent<V>; 2] {
    let both = [left.clone(), right.clone()];
    match Value::together(both.to_vec()).map(<[Laurent<V>; 2]>::try_from) {
        Ok(Ok(together)) => together,
        _ => both,
    }
}

impl<V: Value> fmt::Display for Laurent<V> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if self.terms.is_empty() {
            return f.write_str("0");
        }
        for (place, (power, c)) in self.terms.iter().enumerate() {
            let c = c.to_string();
            let (negative, size) = match c.strip_prefix('-') {
                Some(size) if !c.contains(' ') => (true, size),
                _ => (false, &c[..]),
            };
            f.write_str(match (place, negative) {
                (0, false) => "",
                (0, true) => "-",
                (_, false) => " + ",
                (_, true) => " - ",
            })?;
            let z = match power {
                0 => String::new(),
                1 => SYMBOL_VARIABLE.to_owned(),
                _ => format!("{SYMBOL_VARIABLE}^{power}"),
            };
            let size = if size.contains(' ') { format!("({size})") } else { size.to_owned() };
            match (&size[..], &z[..]) {
                (_, "") => f.write_str(&size)?,
                ("1", _) => f.write_str(&z)?,
                _ => write!(f, "{size}*{z}")?,
            }
        }
        Ok(())
    }
}

impl<V: Value> Scalar for Laurent<V> {
    fn from_rational(value: &Rational) -> Self {
        Laurent::constant(V::from_rational(value))
    }
    fn plus(&self, other: &Self) -> Self {
        self.joined(other, V::plus)
    }
    fn minus(&self, other: &Self) -> Self {
        self.joined(other, V::minus)
    }
    fn times(&self, other: &Self) -> Self {
        let [left, right] = in_one_field(self, other);
        let mut product: BTreeMap<i64, V> = BTreeMap::new();
        for (p, a) in &left.terms {
            for (q, b) in &right.terms {
                product.entry(p + q).or_insert_with(V::zero).accumulate(&a.times(b));
            }
        }
        Laurent::of(product)
    }
}

impl<V: Value> Value for Laurent<V> {
    fn as_rational(&self) -> Option<Rational> {
        self.as_constant()?.as_rational()
    }
    fn size(&self) -> u64 {
        self.terms.values().map(|c| TERM_BITS.saturating_add(c.size())).fold(0, u64::saturating_add)
    }
    fn product_size(&self, other: &Self) -> u64 {
        let terms = self.terms.len().saturating_mul(other.terms.len()) as u64;
        if terms > MAX_BITS {
            return terms;
        }
        let row = |a: &V| {
            let sizes = other.terms.values().map(|b| a.product_size(b));
            sizes.fold(0, u64::saturating_add)
        };
        self.terms.values().map(row).fold(terms, u64::saturating_add)
    }
    fn quotient_size(&self, divisor: &Self) -> u64 {
        match (&divisor.terms.iter().collect::<Vec<_>>()[..], self.powers(), divisor.powers()) {
            ([(_, d)], ..) => {
                let sizes = self.terms.values().map(|c| c.quotient_size(d));
                sizes.fold(0, u64::saturating_add)
            }
            (_, Some((low, high)), Some((first, last))) => {
                let steps = u64::try_from((high - last) - (low - first) + 1).unwrap_or(0);
                steps.saturating_mul(divisor.size()).saturating_add(self.size())
            }
            _ => 0,
        }
    }
    fn quotient(&self, divisor: &Self) -> Option<Self> {
        self.divided(divisor).ok()
    }
    fn divided(&self, divisor: &Self) -> Result<Self, FormulaErrorKind> {
        match (divisor.terms.first_key_value(), divisor.terms.len()) {
            (Some((power, d)), 1) => {
                let over =
                    |(k, c): (&i64, &V)| Ok((k - power, apply(Operator::Divide, c.clone(), d)?));
                let terms: Result<Vec<(i64, V)>, FormulaErrorKind> =
                    self.terms.iter().map(over).collect();
                Ok(Laurent::of(terms?))
            }
            _ => self.by_steps(divisor),
        }
    }
    fn absolute(&self) -> Option<Self> {
        self.as_constant()?.absolute().map(Laurent::constant)
    }
    fn larger(&self, other: &Self) -> Option<Self> {
        self.as_constant()?.larger(&other.as_constant()?).map(Laurent::constant)
    }
    fn floor(&self) -> Option<Integer> {
        self.as_constant()?.floor()
    }
    fn vanishes(&self) -> Option<bool> {
        match self.as_constant() {
            Some(constant) => constant.vanishes(),
            None => self.terms.values().any(|c| c.vanishes() == Some(false)).then_some(false),
        }
    }
    fn cosine(turn: &Rational) -> Result<Self, CosineError> {
        V::cosine(turn).map(Laurent::constant)
    }
    fn root(coefficients: &[Self], number: i64) -> Result<Self, RootError> {
        let constants: Option<Vec<V>> = coefficients.iter().map(Laurent::as_constant).collect();
        V::root(&constants.ok_or(RootError::Variable)?, number).map(Laurent::constant)
    }
    fn meets(&self, other: &Self) -> Result<(), FormulaErrorKind> {
        if self.reach().saturating_add(other.reach()) > MAX_SYMBOL_POWER {
            return Err(FormulaErrorKind::too_large("the power of z", MAX_SYMBOL_POWER));
        }
        Value::together(vec![self.clone(), other.clone()]).map(|_| ())
    }
    fn together(values: Vec<Self>) -> Result<Vec<Self>, FormulaErrorKind> {
        let powers: Vec<Vec<i64>> =
            values.iter().map(|value| value.terms.keys().copied().collect()).collect();
        let all = values.into_iter().flat_map(|value| value.terms.into_values()).collect();
        let mut all = V::together(all)?.into_iter();
        let again =
            |powers: Vec<i64>| Laurent { terms: powers.into_iter().zip(&mut all).collect() };
        Ok(powers.into_iter().map(again).collect())
    }
    fn conductor(&self) -> u32 {
        let conductors = self.terms.values().map(Value::conductor).filter(|&n| n > 1);
        conductors.fold(1, num_integer::lcm)
    }
}
