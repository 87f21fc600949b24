//! Laurent polynomials as values of formulas: symbols of masks.

use super::ast::Operator;
use super::builtin::{MAX_BITS, apply};
use super::error::FormulaErrorKind;
use super::power::Power;
use super::root_error::RootError;
use super::values::value::Value;
use crate::exact::{CosineError, Integer, Rational, Scalar};
use std::collections::BTreeMap;
use std::fmt;

/// The greatest |k| of a power z^k: more coefficients than any mask has.
pub const MAX_SYMBOL_POWER: u64 = 16_384;

/// The bits counted for each term besides its coefficient.
const TERM_BITS: u64 = 10;

/// How many times [`MAX_BITS`] all coefficients together may have that a division meets.
const DIVISION: u64 = 8;

/// Why there is no quotient.
const REMAINDER: &str = "this division leaves a remainder: a symbol has finitely many powers of z, so that a divisor is a number, a power \
     of z, or a factor of what stands before it, as in (1 - z^4)/(1 - z)";

/// Σ_k c_k z^k over finitely many powers k, also negative ones: the symbol of a mask. A power is one integer, or with `[i64; 3]` for P
/// those of x, y and z.
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
pub struct Laurent<V = Rational, P = i64> {
    /// The coefficients by powers. None of them is known to be 0.
    terms: BTreeMap<P, V>,
}

impl<V: Value> Laurent<V> {
    /// z.
    #[must_use]
    pub fn variable() -> Laurent<V> {
        Laurent::power(1)
    }
}

impl<V: Value, P: Power> Laurent<V, P> {
    /// The sum of these coefficients times powers of the variables.
    pub fn of(terms: impl IntoIterator<Item = (P, V)>) -> Laurent<V, P> {
        Laurent { terms: terms.into_iter().filter(|(_, c)| !is_zero(c)).collect() }
    }

    /// c, which is c·z^0.
    #[must_use]
    pub fn constant(c: V) -> Laurent<V, P> {
        Laurent::of([(P::ZERO, c)])
    }

    /// This power of the variables.
    #[must_use]
    pub fn power(power: P) -> Laurent<V, P> {
        Laurent::of([(power, V::from_rational(&Rational::one()))])
    }

    /// The coefficients that are not known to be 0, by powers.
    pub fn terms(&self) -> impl Iterator<Item = (P, &V)> {
        self.terms.iter().map(|(power, c)| (*power, c))
    }

    /// The lowest and the highest power with a coefficient; `None` of 0.
    #[must_use]
    pub fn powers(&self) -> Option<(P, P)> {
        Some((*self.terms.first_key_value()?.0, *self.terms.last_key_value()?.0))
    }

    /// The least and the greatest exponent of each variable; `None` of 0.
    #[must_use]
    pub fn ranges(&self) -> Option<(P, P)> {
        let mut powers = self.terms.keys().copied();
        let first = powers.next()?;
        Some(powers.fold((first, first), |(low, high), power| {
            (low.with(power, i64::min), high.with(power, i64::max))
        }))
    }

    /// The coefficient of this power, 0 where there is none.
    #[must_use]
    pub fn coefficient(&self, power: P) -> V {
        self.terms.get(&power).cloned().unwrap_or_else(V::zero)
    }

    /// The number that this is, if it is one.
    #[must_use]
    pub fn as_constant(&self) -> Option<V> {
        match self.powers() {
            Some((low, high)) if (low, high) != (P::ZERO, P::ZERO) => None,
            _ => Some(self.coefficient(P::ZERO)),
        }
    }

    /// The greatest |k| of all exponents k.
    fn reach(&self) -> u64 {
        let exponents = self.terms.keys().flat_map(Power::exponents);
        exponents.map(|(_, k)| k.unsigned_abs()).max().unwrap_or(0)
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

    /// The quotient by a divisor of several terms: each step takes away the lowest power that is left, or the highest. The exponents of an exact
    /// quotient are in known ranges, since the least ones of factors add up, and so do the greatest.
    ///
    /// # Errors
    /// When a remainder is left, or coefficients become too large.
    fn by_steps(&self, divisor: &Self) -> Result<Self, FormulaErrorKind> {
        let (Some((first, last)), Some((least, greatest))) = (divisor.powers(), divisor.ranges())
        else {
            return Ok(self.clone());
        };
        let Some((low, high)) = self.ranges() else { return Ok(self.clone()) };
        let (low, high) = (low.minus(least), high.minus(greatest));
        let fits = |k: P| low.with(k, i64::min) == low && high.with(k, i64::max) == high;
        // The power of the divisor whose coefficient can be divided by.
        let divides = |power: &P| divisor.coefficient(*power).vanishes() == Some(false);
        let end = [first, last].into_iter().find(divides).ok_or(FormulaErrorKind::Unsupported(
            "the lowest or the highest coefficient of a divisor has to be a number that is not 0",
        ))?;
        let lead = divisor.coefficient(end);
        let (mut rest, mut quotient) = (self.terms.clone(), BTreeMap::new());
        let mut remainder = Vec::new();
        let mut left = DIVISION * MAX_BITS;
        while let Some((power, c)) = if end == first { rest.pop_first() } else { rest.pop_last() } {
            let k = power.minus(end);
            if !fits(k) {
                remainder.push(c);
                continue;
            }
            let c = apply(Operator::Divide, c, &lead)?;
            for (power, d) in divisor.terms.iter().filter(|(power, _)| **power != end) {
                let product = apply(Operator::Multiply, c.clone(), d)?;
                let known = rest.remove(&power.plus(k)).unwrap_or_else(V::zero);
                let value = apply(Operator::Subtract, known, &product)?;
                left = left.saturating_sub(TERM_BITS + value.size());
                if !is_zero(&value) {
                    rest.insert(power.plus(k), value);
                }
            }
            if left == 0 {
                let most = DIVISION * MAX_BITS;
                return Err(FormulaErrorKind::too_large("the number of bits of a division", most));
            }
            quotient.insert(k, c);
        }
        if remainder.iter().all(|c| c.vanishes() == Some(true)) {
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
fn in_one_field<V: Value, P: Power>(
    left: &Laurent<V, P>,
    right: &Laurent<V, P>,
) -> [Laurent<V, P>; 2] {
    let both = [left.clone(), right.clone()];
    match Value::together(both.to_vec()).map(<[Laurent<V, P>; 2]>::try_from) {
        Ok(Ok(together)) => together,
        _ => both,
    }
}

impl<V: Value, P: Power> fmt::Display for Laurent<V, P> {
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
            let factor = |(name, exponent): (&str, i64)| match exponent {
                0 => None,
                1 => Some(name.to_owned()),
                _ => Some(format!("{name}^{exponent}")),
            };
            let z = power.exponents().filter_map(factor).collect::<Vec<String>>().join("*");
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

impl<V: Value, P: Power> Scalar for Laurent<V, P> {
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
        let mut product: BTreeMap<P, V> = BTreeMap::new();
        for (p, a) in &left.terms {
            for (q, b) in &right.terms {
                product.entry(p.plus(*q)).or_insert_with(V::zero).accumulate(&a.times(b));
            }
        }
        Laurent::of(product)
    }
}

impl<V: Value, P: Power> Value for Laurent<V, P> {
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
        match (&divisor.terms.iter().collect::<Vec<_>>()[..], self.ranges(), divisor.ranges()) {
            ([(_, d)], ..) => {
                let sizes = self.terms.values().map(|c| c.quotient_size(d));
                sizes.fold(0, u64::saturating_add)
            }
            (_, Some((low, high)), Some((first, last))) => {
                let sizes = high.minus(last).minus(low.minus(first));
                let steps = sizes.exponents().map(|(_, k)| u64::try_from(k + 1).unwrap_or(0));
                let steps = steps.fold(1, u64::saturating_mul);
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
                let over = |(k, c): (&P, &V)| {
                    Ok((k.minus(*power), apply(Operator::Divide, c.clone(), d)?))
                };
                let terms: Result<Vec<(P, V)>, FormulaErrorKind> =
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
        let powers: Vec<Vec<P>> =
            values.iter().map(|value| value.terms.keys().copied().collect()).collect();
        let all = values.into_iter().flat_map(|value| value.terms.into_values()).collect();
        let mut all = V::together(all)?.into_iter();
        let again = |powers: Vec<P>| Laurent { terms: powers.into_iter().zip(&mut all).collect() };
        Ok(powers.into_iter().map(again).collect())
    }
    fn conductor(&self) -> u32 {
        let conductors = self.terms.values().map(Value::conductor).filter(|&n| n > 1);
        conductors.fold(1, num_integer::lcm)
    }
}
