//! Values of the parameter of a family at which more holds than at the others.

use super::exponent::Smoothness;
use super::parametric::ParametricSymbol;
use super::symbol::over_sigma;
use crate::exact::{IntegerPolynomial, Rational, RationalPolynomial, RealAlgebraic};
use crate::scheme::{Mask, Rules};
use std::collections::BTreeSet;

/// The most values whose smoothness is examined.
const MAX_EXAMINED: usize = 8;

/// A value of the parameter at which the sum rules are of a higher order than at most values, or the support is shorter.
#[derive(Clone, Debug)]
pub struct SpecialValue {
    /// The value.
    pub value: RealAlgebraic,
    /// The order of the sum rules there.
    pub sum_rules: usize,
    /// The support of the basic limit function there.
    pub support: (Rational, Rational),
    /// The scheme there, if the value is rational and it can be examined.
    pub smoothness: Option<Smoothness>,
}

/// The special values of a parameter.
#[derive(Clone, Debug)]
pub struct SpecialValues {
    /// The order of the sum rules at all values but these.
    pub sum_rules: usize,
    /// The support of the basic limit function at all values but some of these.
    pub support: (Rational, Rational),
    /// The special values, in increasing order.
    pub values: Vec<SpecialValue>,
}

impl SpecialValues {
    /// The special values of a mask with polynomials in one parameter as coefficients.
    ///
    /// With A = σ^K B for all values, the order is above K where σ divides B: at the common real roots of the coefficients of
    /// the remainder, and so on with the quotient. The support is shorter at the roots of the first and the last coefficient.
    ///
    /// ```
    /// use subcert::bound::polynomial_rules;
    /// use subcert::exact::Rational;
    /// use subcert::scheme::parse_parametric;
    /// use subcert::smoothness::SpecialValues;
    ///
    /// let mask = parse_parametric("four-point", "w")?;
    /// let special = SpecialValues::of(&polynomial_rules(mask.rules(), "w")?);
    /// let [zero, sixteenth] = &special.values[..] else { panic!("two values") };
    /// assert_eq!((special.sum_rules, sixteenth.sum_rules), (2, 4));
    /// assert_eq!(sixteenth.value.as_rational(), Some(&Rational::new(1, 16)));
    /// assert_eq!(zero.support, ((-1).into(), 1.into()));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Panics
    /// When the mask has 2^63 coefficients.
    #[must_use]
    pub fn of(rules: &Rules<RationalPolynomial>) -> SpecialValues {
        let (n, width) = (rules.arity(), rules.width());
        let places = (0..width).rev();
        let all: Vec<RationalPolynomial> =
            places.flat_map(|j| rules.rows().iter().map(move |row| row[j].clone())).collect();
        let small = |x: usize| i64::try_from(x).expect("a mask is short");
        let lowest = -small(n) * (rules.offset() + small(width) - 1);
        // The support where so many of the first and the last coefficients are 0.
        let support = |zeros: [usize; 2]| {
            let over = |power: i64| Rational::from(power) / Rational::from(n - 1);
            (over(lowest + small(zeros[0])), over(lowest + small(all.len() - 1 - zeros[1])))
        };
        let zeros = |is_zero: &dyn Fn(&RationalPolynomial) -> bool| {
            let first = all.iter().take_while(|c| is_zero(c)).count();
            let last = all.iter().rev().take_while(|c| is_zero(c)).count();
            [first, last]
        };
        let always = zeros(&RationalPolynomial::is_zero);
        let (sum_rules, steps) = steps(ParametricSymbol::of(rules).coefficients(), n);
        let ends = [&all[always[0]], &all[all.len() - 1 - always[1]]];
        let ends = ends.map(|c| roots(c.numerator()));
        let places: BTreeSet<RealAlgebraic> =
            ends.into_iter().chain(steps.iter().cloned()).flatten().collect();
        let mut examined = 0;
        let special = |value: RealAlgebraic| {
            let vanishes =
                |c: &RationalPolynomial| c.is_zero() || roots(c.numerator()).contains(&value);
            let order = steps.iter().take_while(|step| step.contains(&value)).count();
            let rational = value.as_rational().filter(|_| examined < MAX_EXAMINED).cloned();
            examined += usize::from(rational.is_some());
            SpecialValue {
                sum_rules: sum_rules + order,
                support: support(zeros(&vanishes)),
                smoothness: rational.and_then(|value| at(rules, &value)),
                value,
            }
        };
        let values = places.into_iter().map(special).collect();
        SpecialValues { sum_rules, support: support(always), values }
    }

    /// The first rational value with sum rules of the highest order, if that is above the order at most values.
    #[must_use]
    pub fn best(&self) -> Option<Rational> {
        let above = self.values.iter().filter(|one| one.sum_rules > self.sum_rules);
        let rational =
            above.filter_map(|one| Some((one.sum_rules, one.value.as_rational()?.clone())));
        let best = rational.reduce(|best, next| if next.0 > best.0 { next } else { best });
        best.map(|(_, value)| value)
    }
}

/// The order of the sum rules for all values, and where it is one more at least, two more, and so on.
fn steps(coefficients: &[RationalPolynomial], n: usize) -> (usize, Vec<Vec<RealAlgebraic>>) {
    let (mut order, mut rest) = (0, coefficients.to_vec());
    while let Some(quotient) = over_sigma(&rest, n) {
        (order, rest) = (order + 1, quotient);
    }
    let (mut found, mut common) = (Vec::new(), IntegerPolynomial::new(Vec::new()));
    while let Some((quotient, remainder)) = divided(&rest, n) {
        common = remainder.iter().fold(common, |common, c| common.gcd(c.numerator()));
        // Where the remainder is 0 for all values, the quotient would have been taken above.
        let places = roots(&common);
        if places.is_empty() {
            break;
        }
        found.push(places);
        rest = quotient;
    }
    (order, found)
}

/// The quotient and the remainder of p by σ(z) = 1 + z + … + z^{n−1}, from the constant terms upwards, up to a power of z;
/// `None` where p is shorter than σ.
fn divided(
    p: &[RationalPolynomial],
    n: usize,
) -> Option<(Vec<RationalPolynomial>, Vec<RationalPolynomial>)> {
    let count = (p.len() + 1).checked_sub(n).filter(|count| *count > 0)?;
    let mut rest = p.to_vec();
    let mut quotient = Vec::with_capacity(count);
    for i in 0..count {
        let c = rest[i].clone();
        rest[i..i + n].iter_mut().for_each(|x| *x = x.minus(&c));
        quotient.push(c);
    }
    Some((quotient, rest.split_off(count)))
}

/// The real roots; none of a constant.
fn roots(polynomial: &IntegerPolynomial) -> Vec<RealAlgebraic> {
    if polynomial.degree().unwrap_or(0) == 0 {
        return Vec::new();
    }
    RealAlgebraic::roots_of(polynomial)
}

/// How smooth the limits are at this value, if the mask there can be examined.
fn at(rules: &Rules<RationalPolynomial>, value: &Rational) -> Option<Smoothness> {
    let mask = Mask::new(rules.map(|c| c.value_at(value)).rows().to_vec(), rules.offset()).ok()?;
    Smoothness::of(&mask).ok()
}
