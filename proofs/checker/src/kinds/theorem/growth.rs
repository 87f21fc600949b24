//! The growth of a formula in `k` and `beta`.

use crate::formulas::{Expr, Head, Scope};
use crate::numbers::Value;
use crate::text::Stop;
use num_integer::Integer;
use num_traits::ToPrimitive;

/// The longest period.
pub const MAX_PERIOD: u32 = 64;

/// The greatest exponent that a period adds.
const MAX_STEP: i64 = 10_000;

/// How deep definitions and parts of a formula may be nested.
const MAX_DEPTH: usize = 128;

/// A triple (p, q, d): f(k + p) = q·f(k) for all k, and f is a multiple of beta^d.
type Growth = (u32, Value, i64);

/// The growth or slope of a formula. The error `None` says that the formula has none.
type Known<T> = Result<T, Option<Stop>>;

/// The growth of a formula in a scope where `k` and `beta` are symbols. The formula is made of
/// beta and of powers with k in the exponent only.
pub fn growth(scope: &Scope<'_>, expr: &Expr, depth: usize) -> Known<Growth> {
    nested(depth)?;
    if steady(scope, expr)?.is_some() {
        return Ok((1, Value::int(1), 0));
    }
    match expr {
        Expr::Name(name) if name == "beta" => Ok((1, Value::int(1), 1)),
        Expr::Name(name) => growth(scope, definition(scope, name)?, depth + 1),
        Expr::Of(Head::Minus, parts) => growth(scope, &parts[0], depth + 1),
        Expr::Of(Head::Power, parts) => {
            let base = steady(scope, &parts[0])?.ok_or(None)?;
            let (period, step) = slope(scope, &parts[1], depth + 1)?;
            // A slope that is no integer gives no growth.
            let capped = |stop: &Stop| matches!(stop, Stop::Capped(_));
            let whole = step.integer(MAX_STEP).map_err(|stop| Some(stop).filter(capped))?;
            let ratio = base.power(whole)?;
            scope.spend(ratio.cost(&ratio))?;
            Ok((period, ratio, 0))
        }
        Expr::Of(Head::Chain(operators), parts) => {
            let mut whole = growth(scope, &parts[0], depth + 1)?;
            for (operator, part) in operators.iter().zip(&parts[1..]) {
                let next = growth(scope, part, depth + 1)?;
                let period = within(whole.0.lcm(&next.0))?;
                let own = whole.1.power((period / whole.0).into())?;
                let other = next.1.power((period / next.0).into())?;
                scope.spend(own.cost(&other))?;
                whole = match operator {
                    '*' => (period, own.times(&other)?, degree(whole.2.checked_add(next.2))?),
                    '/' => (period, own.over(&other)?, degree(whole.2.checked_sub(next.2))?),
                    _ => {
                        let same = own.equals(&other)? && whole.2 == next.2;
                        (period, Some(own).filter(|_| same).ok_or(None)?, whole.2)
                    }
                };
            }
            Ok(whole)
        }
        _ => Err(None),
    }
}

/// The slope (p, s) of a formula: e(k + p) = e(k) + s for all k.
fn slope(scope: &Scope<'_>, expr: &Expr, depth: usize) -> Known<(u32, Value)> {
    nested(depth)?;
    if let Some(line) = symbolic(scope, expr)?.and_then(|value| value.univariate("k")) {
        let line = Some(line).filter(|line| line.len() <= 2).ok_or(None)?;
        return Ok((1, line.into_iter().nth(1).unwrap_or_default().into()));
    }
    match expr {
        Expr::Name(name) => slope(scope, definition(scope, name)?, depth + 1),
        Expr::Of(Head::Call(floor, _), parts) if floor == "floor" && parts.len() == 1 => {
            let (period, step) = slope(scope, &parts[0], depth + 1)?;
            let times = step.rational().and_then(|step| step.denom().to_u32()).ok_or(None)?;
            let period = within(period * within(times)?)?;
            Ok((period, step.times(&Value::int(times.into()))?))
        }
        // One part varies with k, and the others do not.
        Expr::Of(Head::Chain(operators), parts) => {
            let first = if ['+', '-'].contains(&operators[0]) { '+' } else { '*' };
            let (mut varying, mut factor) = (None, Value::int(1));
            for (operator, part) in [first].iter().chain(operators).zip(parts) {
                match (operator, steady(scope, part)?) {
                    ('*', Some(number)) => {
                        scope.spend(factor.cost(&number))?;
                        factor = factor.times(&number)?;
                    }
                    ('/', Some(number)) => {
                        scope.spend(factor.cost(&number))?;
                        factor = factor.over(&number)?;
                    }
                    (_, Some(_)) => {}
                    ('+' | '-' | '*', None) if varying.is_none() => {
                        varying = Some(slope(scope, part, depth + 1)?);
                        factor = if *operator == '-' { factor.negated()? } else { factor };
                    }
                    _ => return Err(None),
                }
            }
            let (period, step) = varying.ok_or(None)?;
            Ok((period, step.times(&factor)?))
        }
        _ => Err(None),
    }
}

/// The value of a formula that depends on neither `k` nor `beta`.
fn steady(scope: &Scope<'_>, expr: &Expr) -> Result<Option<Value>, Stop> {
    Ok(symbolic(scope, expr)?.filter(|value| value.number().is_ok()))
}

/// The value as a polynomial in `k` and `beta`, if the formula has one.
fn symbolic(scope: &Scope<'_>, expr: &Expr) -> Result<Option<Value>, Stop> {
    match scope.value(expr) {
        Err(stop @ Stop::Capped(_)) => Err(stop),
        value => Ok(value.ok()),
    }
}

fn definition<'s>(scope: &'s Scope<'_>, name: &str) -> Known<&'s Expr> {
    let definition = scope.definitions.get(name).filter(|_| !scope.values.contains_key(name));
    definition.map(|definition| &**definition).ok_or(None)
}

fn within(period: u32) -> Known<u32> {
    Some(period).filter(|period| (1..=MAX_PERIOD).contains(period)).ok_or(None)
}

fn degree(degree: Option<i64>) -> Result<i64, Stop> {
    degree.ok_or(Stop::Capped("the power of the spread"))
}

fn nested(depth: usize) -> Result<(), Stop> {
    if depth < MAX_DEPTH { Ok(()) } else { Err(Stop::Capped("the nesting of formulas")) }
}
