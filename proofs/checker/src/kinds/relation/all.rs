//! Relations of all integers from one on, by polynomials.

#![warn(clippy::arithmetic_side_effects)]

use super::compare::{fits, judged};
use super::states::{Comparison, Rest, Sign};
use crate::claims::Paper;
use crate::formulas::Scope;
use crate::functions::families;
use crate::kinds::equation::cases::{Index, Values, cases, scope_of_all};
use crate::numbers::{Integers, Meter, Value};
use crate::schemes::Every;
use crate::text::{Checked, Reason, Stop, Toml, require};
use std::rc::Rc;

/// Checks that every case is true. The indices with all values are symbols.
pub fn shown<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    indices: &[Index<'a>],
    stated: &[Comparison],
) -> Checked<()> {
    let from = |index: &Index<'a>| match index.values {
        Values::From(least) => Some(Integers { index: index.name.to_owned(), least }),
        _ => None,
    };
    // Hypotheses may hold of some values of an index only.
    require(claim.texts("hypotheses").next().is_none(), Reason::NotAll)?;
    let all: Vec<Integers> = indices.iter().filter_map(from).collect();
    let cases = cases(paper, indices.iter().filter(|index| !index.is_all()))?;
    require(!cases.is_empty(), Reason::NoCase)?;
    let near = |comparison: &Comparison| matches!(comparison.rest, Rest::Sign(Sign::Near, _));
    let symbols = claim.texts("symbols").next().is_some();
    let families = all.len() == 1 && !symbols && !stated.iter().any(near);
    for case in &cases {
        let every = Every { indices: all.clone(), families, family: None };
        // What definitions say of a family is so in this case only.
        let scope = scope_of_all(paper, claim, (case, every), &Rc::default())?;
        if let Some(family) = scope.every.as_ref().and_then(|every| every.family.as_ref()) {
            families::exist(paper.library.meter, family)?;
        }
        for comparison in stated {
            let holds = always(paper.library.meter, comparison, &scope, &all)?;
            require(holds, Reason::NotAll)?;
        }
    }
    Ok(())
}

/// Whether a comparison of polynomials is shown for all values of these indices.
fn always(
    meter: &Meter,
    comparison: &Comparison,
    scope: &Scope<'_>,
    all: &[Integers],
) -> Result<bool, Stop> {
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
            let one = all.iter().find(|integers| integers.has(&difference)).or(all.first());
            one.map_or(Ok(false), |one| one.all(meter, &difference, |order| fits(*sign, order)))
        }
    }
}

/// Checks that a value has no symbols but these indices.
fn only(value: &Value, all: &[Integers]) -> Result<(), Stop> {
    let known = |name: &str| all.iter().any(|integers| integers.index == name);
    let mut names = value.all().flat_map(|(monomial, _)| monomial);
    if names.all(|(name, _)| known(name)) {
        return Ok(());
    }
    Err(Stop::Wrong("values with symbols are compared with = only".into()))
}
