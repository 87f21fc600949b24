//! Relations of all integers from one on, by polynomials.

#![warn(clippy::arithmetic_side_effects)]

use super::compare::{fits, judged};
use super::states::{Comparison, Rest, Sign};
use crate::claims::Paper;
use crate::formulas::Scope;
use crate::kinds::equation::cases::{Index, Values, cases, scope};
use crate::numbers::{Q, Value, common_multiple};
use crate::text::{Checked, Reason, Stop, Toml, require};
use num_bigint::BigInt;
use num_traits::{One, Signed, ToPrimitive as _, Zero};
use std::cmp::Ordering;
use std::rc::Rc;

/// The most integers at which a polynomial is compared.
const MAX_TRIED: usize = 10_000;

/// The greatest degree of a polynomial in an index.
const MAX_DEGREE: u32 = 256;

/// Checks that every case is true. The indices with all values are symbols.
pub fn shown<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    indices: &[Index<'a>],
    stated: &[Comparison],
) -> Checked<()> {
    let from = |index: &Index<'a>| match index.values {
        Values::From(least) => Some((index.name, least)),
        _ => None,
    };
    // Hypotheses may hold of some values of an index only.
    require(claim.texts("hypotheses").next().is_none(), Reason::NotAll)?;
    let all: Vec<(&str, i64)> = indices.iter().filter_map(from).collect();
    let names: Vec<&str> = all.iter().map(|(name, _)| *name).collect();
    let cases = cases(paper, indices.iter().filter(|index| !index.is_all()))?;
    require(!cases.is_empty(), Reason::NoCase)?;
    let memory = Rc::default();
    for case in &cases {
        let scope = scope(paper, claim, (case, &names), &memory)?;
        for comparison in stated {
            require(always(comparison, &scope, &all)?, Reason::NotAll)?;
        }
    }
    Ok(())
}

/// Whether a comparison of polynomials is shown for all values of these indices.
fn always(comparison: &Comparison, scope: &Scope<'_>, all: &[(&str, i64)]) -> Result<bool, Stop> {
    let left = scope.value(&comparison.left.expr)?;
    match &comparison.rest {
        Rest::Is(_) => Ok(!judged(comparison, scope)?.0),
        Rest::Member(members) => {
            let members = members.iter().map(|member| scope.value(member));
            let members = members.collect::<Result<Vec<Value>, Stop>>()?;
            for value in members.iter().chain([&left]) {
                only(value, all)?;
            }
            let equal = members.iter().map(|member| left.equals(member));
            Ok(equal.collect::<Result<Vec<bool>, Stop>>()?.contains(&true))
        }
        Rest::Sign(Sign::Equal, right) => left.equals(&scope.value(&right.expr)?),
        Rest::Sign(sign, right) => {
            let right = scope.value(&right.expr)?;
            for value in [&left, &right] {
                only(value, all)?;
            }
            let difference = left.minus(&right)?;
            if *sign == Sign::Near {
                // A printed number is near to no polynomial of all integers but a number.
                let numbers = left.number().is_ok() && right.number().is_ok();
                return Ok(numbers && !judged(comparison, scope)?.0);
            }
            match difference.number() {
                Ok(number) => Ok(fits(*sign, number.sign()?.cmp(&0))),
                Err(_) => polynomial(scope, *sign, &difference, all),
            }
        }
    }
}

/// Checks that a value has no symbols but these indices.
fn only(value: &Value, all: &[(&str, i64)]) -> Result<(), Stop> {
    let known = |name: &str| all.iter().any(|(index, _)| *index == name);
    let mut names = value.all().flat_map(|(monomial, _)| monomial);
    if names.all(|(name, _)| known(name)) {
        return Ok(());
    }
    Err(Stop::Wrong("values with symbols are compared with = only".into()))
}

/// Whether d(t) has this sign for all values of its only index t. Its roots are below 1 + max |c_i/c_g|.
fn polynomial(
    scope: &Scope<'_>,
    sign: Sign,
    difference: &Value,
    all: &[(&str, i64)],
) -> Result<bool, Stop> {
    let mut powers = difference.all().flat_map(|(monomial, _)| monomial);
    if powers.any(|(_, power)| *power > MAX_DEGREE) {
        return Err(Stop::Capped("the degree of a polynomial in an index"));
    }
    let of = |(name, least): &(&str, i64)| Some((difference.univariate(name)?, *least));
    let Some((coefficients, least)) = all.iter().find_map(of) else { return Ok(false) };
    // A positive multiple with integer coefficients.
    let over = common_multiple(coefficients.iter().map(Q::denom))?;
    let whole: Vec<BigInt> = coefficients.iter().map(|c| c.numer() * (&over / c.denom())).collect();
    let Some((leading, lower)) = whole.split_last().filter(|(leading, _)| !leading.is_zero())
    else {
        return Ok(false);
    };
    let greatest = lower.iter().map(|c| Q::new(c.abs(), leading.abs())).max();
    let bound = (greatest.unwrap_or_else(Q::zero) + Q::one()).ceil().to_integer() + BigInt::one();
    let at_end = if leading.is_positive() { Ordering::Greater } else { Ordering::Less };
    if !fits(sign, at_end) {
        return Ok(false);
    }
    let count = (bound - BigInt::from(least) + BigInt::one()).max(BigInt::zero());
    let count = count.to_usize().filter(|count| *count <= MAX_TRIED);
    let count = count.ok_or(Stop::Capped("the integers at which a polynomial is compared"))?;
    let longest = whole.iter().map(BigInt::bits).max().unwrap_or(0) / 64;
    let terms = whole.len() as u64;
    let steps = terms.saturating_mul((longest.saturating_add(terms) / 16).saturating_add(1));
    for t in (least..).take(count) {
        scope.spend(steps)?;
        let value = whole.iter().rev().fold(BigInt::zero(), |sum, c| sum * t + c);
        if !fits(sign, value.cmp(&BigInt::zero())) {
            return Ok(false);
        }
    }
    Ok(true)
}
