//! Relations of all integers from one on: by polynomials, and by functions of an integer.

#![warn(clippy::arithmetic_side_effects)]

use super::compare::{fits, judged, judged_reals};
use super::states::{Comparison, Rest, Sign};
use crate::claims::Paper;
use crate::formulas::{Expr, Scope};
use crate::functions::families;
use crate::integers::{LEAST, Said};
use crate::kinds::equation::cases::{Case, Index, Values, cases};
use crate::kinds::equation::scopes::{scope, scope_of_all, scope_of_every};
use crate::numbers::{Integers, Meter, Value, int};
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
    let symbols = claim.texts("symbols").next().is_some();
    let families = all.len() == 1 && !symbols && !stated.iter().any(is_near);
    let one = if let [one] = &all[..] { Some(one).filter(|_| !symbols) } else { None };
    for case in &cases {
        let every = || Every { indices: all.clone(), families, family: None };
        // What definitions say of a family is so in this case only.
        let scope = scope_of_all(paper, claim, (case, every()), &Rc::default());
        let scope = scope.and_then(|scope| {
            if let Some(family) = scope.every.as_ref().and_then(|every| every.family.as_ref()) {
                families::exist(paper.library.meter, family)?;
            }
            Ok(scope)
        });
        for comparison in stated {
            let found = scope.as_ref().map_err(Clone::clone);
            let found =
                found.and_then(|scope| always(paper.library.meter, comparison, scope, &all));
            if matches!(found, Ok(true)) {
                continue;
            }
            let of = Functions { paper, claim, case, every: &every };
            let known = scope.as_ref().ok();
            let other = one.filter(|_| !is_near(comparison));
            let other = other.map(|one| of.hold(one, comparison, known));
            decided(found, other)?;
        }
    }
    Ok(())
}

fn is_near(comparison: &Comparison) -> bool {
    matches!(comparison.rest, Rest::Sign(Sign::Near, _))
}

/// What is found by polynomials, and otherwise by functions of an integer.
fn decided(found: Result<bool, Stop>, other: Option<Result<bool, Stop>>) -> Checked<()> {
    let stop = match (found, other) {
        (Ok(true), _) | (_, Some(Ok(true))) => return Ok(()),
        (Err(stop @ (Stop::Capped(_) | Stop::Undecided(_) | Stop::Family(_))), _)
        | (Err(stop), None)
        | (Err(_), Some(Err(stop))) => stop,
        (Ok(false), _) | (Err(_), Some(Ok(false))) => return Err(Reason::NotAll.into()),
    };
    Err(stop.into())
}

/// What is said in a case of the other indices.
struct Functions<'c, 'a> {
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    case: &'c Case<'a>,
    every: &'c dyn Fn() -> Every,
}

impl<'a> Functions<'_, 'a> {
    /// Whether a comparison is true for the first integers, and for all later ones by functions of an integer.
    fn hold(
        &self,
        one: &Integers,
        comparison: &Comparison,
        known: Option<&Scope<'a>>,
    ) -> Result<bool, Stop> {
        let (paper, claim) = (self.paper, self.claim);
        let last = one.least.max(LEAST);
        let memory = Rc::default();
        for t in one.least..last {
            let case = [&self.case[..], &[(&one.index[..], int(t))]].concat();
            let scope = scope(paper, claim, &case, &memory)?;
            let fails = if let Ok((fails, _)) = judged(comparison, &scope) {
                fails
            } else {
                let found = judged_reals(paper.library, comparison, &scope)?;
                found.fails.ok_or(Stop::Undecided("a comparison of one of the first integers"))?
            };
            if fails {
                return Ok(false);
            }
        }
        let without;
        let scope = if let Some(scope) = known {
            scope
        } else {
            let every = (self.every)();
            without = scope_of_every(paper, claim, (self.case, every), &Rc::default())?;
            &without
        };
        let own = claim.text("scheme");
        let said = Said { library: paper.library, scope, index: (&one.index, last), own };
        if known.is_none() {
            said.has_ring()?;
        }
        let left = &comparison.left.expr;
        let signs = |others: &[&Expr]| said.signs(left, others);
        match &comparison.rest {
            Rest::Sign(sign, right) => {
                let found = signs(&[&right.expr])?.into_iter().next();
                let found = found.ok_or(Stop::Integers("a sign"))??;
                Ok(fits(*sign, found.cmp(&0)))
            }
            Rest::Member(members) => {
                let found = signs(&members.iter().collect::<Vec<&Expr>>())?;
                if found.iter().any(|sign| matches!(sign, Ok(0))) {
                    return Ok(true);
                }
                let found = found.into_iter().collect::<Result<Vec<i8>, Stop>>()?;
                Ok(found.contains(&0))
            }
            Rest::Is(one) => {
                let other = Expr::Number(Value::int(i64::from(*one)));
                let found = signs(&[&other])?.into_iter().next();
                Ok(found.ok_or(Stop::Integers("a sign"))?? == 0)
            }
        }
    }
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
