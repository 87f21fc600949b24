//! Rule `levels`: a bound for one scheme, proved at all levels by finitely many (THEOREMS.md, 40).

use super::promise::{change, errors, flows, kept};
use super::sound::Promised;
use super::theorem::Instance;
use crate::certificate::Block;
use crate::decimal::Q;
use crate::evaluate::Scope;
use crate::formula::{Expr, Head};
use crate::paper::{Paper, formula_of};
use crate::reject::{Checked, Reason, Stop, require};
use crate::ring::less;
use crate::toml::Toml;
use crate::value::Value;
use crate::witness::Setting;
use num_integer::Integer;
use num_traits::{One, ToPrimitive, Zero};
use std::cell::RefCell;

/// The last level that is looked at, and the longest period.
const MAX_LEVEL: u32 = 64;

/// How deep definitions and parts of a formula may be nested.
const MAX_DEPTH: usize = 128;

const NESTING: Stop = Stop::Capped("the nesting of formulas");

/// Checks `grows …`, `times …` and the levels.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
    Instance { mut scope, schemes, offset, setting }: Instance<'a>,
) -> Checked<()> {
    block.look();
    // One of several schemes or values proves nothing of the others.
    let one = ["schemes", "values"].iter().all(|key| claim.get(key).is_none());
    require(one && claim.get("scheme").is_some(), Reason::Single)?;
    let bounds = claim.text("bounds").unwrap_or_default();
    let quantity = ["difference", "step", "distance"].contains(&bounds);
    require(quantity, Reason::Malformed("a theorem about a bound"))?;
    let by = formula_of(claim, "by")?;
    for name in ["k", "beta"] {
        scope.values.insert(name.to_owned(), Value::symbol(name));
    }
    let (period, ratio, spreads) = growth(&scope, &by, 0)?;
    require(spreads == 1, Reason::Growth)?;
    let said = block.after("grows")?.split_once(' ').unwrap_or_default();
    require(said.0 == period.to_string() && paper.number(said.1)?.equals(&ratio)?, Reason::Growth)?;
    let times: u32 = block.after("times")?.parse().unwrap_or(0);
    let from: u32 = claim.text("from").and_then(|from| from.parse().ok()).unwrap_or(0);
    let levels = period.checked_mul(times).filter(|levels| (1..=MAX_LEVEL).contains(levels));
    let levels = levels.filter(|_| from <= MAX_LEVEL).ok_or(Reason::Level)?;
    let power = ratio.power(times.into())?;
    scope.values.insert("beta".to_owned(), Value::int(1));
    let known = RefCell::default();
    let (spread, level, tolerance) = (Value::int(1), None, None);
    let mut promised =
        Promised { paper, bounds: &known, scope, schemes, offset, spread, level, tolerance };
    let mut functionals = Vec::new();
    match &setting {
        Setting::Masks(..) => {
            let factor = promised.constant(&Value::int(levels.into()))?;
            require(factor.compare(&power)?.is_le(), Reason::Contraction)?;
        }
        Setting::Ring(ring, earlier) => {
            let differences = ring.differences()?;
            functionals = match bounds {
                "difference" => differences.clone(),
                "step" => {
                    let units = ring.units();
                    let old = earlier.as_ref().map_or(&units, |earlier| &earlier.weights);
                    let steps = ring.weights.iter().zip(old).map(|(new, old)| less(new, old));
                    steps.collect::<Result<_, Stop>>()?
                }
                _ => {
                    // Only of what an interpolant keeps the limit is known.
                    require(earlier.is_none(), Reason::NoLimit)?;
                    errors(paper, ring, block)?
                }
            };
            let after = ring.functionals_before(differences, levels)?;
            flows(paper, ring, block, &after, (&power, Reason::Contraction))?;
            functionals = ring.functionals_before(functionals, from)?;
        }
    }
    for k in from..from + levels {
        let said = block.after("level")?;
        let (said, evidence) = said.split_once(' ').unwrap_or((said, ""));
        require(said == k.to_string(), Reason::Level)?;
        promised.scope.values.insert("k".to_owned(), Value::int(k.into()));
        let most = promised.scope.value(&by)?;
        if let (Setting::Masks(..), "distance") = (&setting, bounds) {
            kept(&promised, &setting, evidence, (k, &most))?;
            continue;
        }
        require(evidence.is_empty(), Reason::Malformed("level K"))?;
        match &setting {
            Setting::Ring(ring, _) => {
                functionals = ring.functionals_before(functionals, u32::from(k > from))?;
                flows(paper, ring, block, &functionals, (&most, Reason::TooLarge))?;
            }
            Setting::Masks(rules, _) => {
                let mut bound = promised.constant(&Value::int(k.into()))?;
                if let ("step", [_]) = (bounds, &rules[..]) {
                    bound = change(&promised, rules, k, k + 1)?;
                } else if bounds == "step" {
                    let one = promised.factor()?;
                    promised.schemes.reverse();
                    let other = promised.factor()?;
                    bound =
                        bound.times(if one.compare(&other)?.is_le() { &one } else { &other })?;
                }
                require(bound.compare(&most)?.is_le(), Reason::TooLarge)?;
            }
        }
    }
    block.word("proved")
}

/// (p, q, d) with by(k + p) = q·by(k) for all k, for a multiple of beta^d.
type Growth = (u32, Value, i64);

fn growth(scope: &Scope<'_>, expr: &Expr, depth: usize) -> Checked<Growth> {
    require(depth < MAX_DEPTH, Reason::Stopped(NESTING))?;
    if steady(scope, expr)?.is_some() {
        return Ok((1, Value::int(1), 0));
    }
    match expr {
        Expr::Name(name) if name == "beta" => Ok((1, Value::int(1), 1)),
        Expr::Name(name) => growth(scope, definition(scope, name)?, depth + 1),
        Expr::Of(Head::Minus, parts) => growth(scope, &parts[0], depth + 1),
        Expr::Of(Head::Power, parts) => {
            let base = steady(scope, &parts[0])?.ok_or(Reason::Growth)?;
            let (period, step) = slope(scope, &parts[1], depth + 1)?;
            let step = Some(step).filter(Q::is_integer).and_then(|step| step.to_i64());
            Ok((period, base.power(step.ok_or(Reason::Growth)?)?, 0))
        }
        Expr::Of(Head::Chain(operators), parts) => {
            let mut whole = growth(scope, &parts[0], depth + 1)?;
            for (operator, part) in operators.iter().zip(&parts[1..]) {
                let next = growth(scope, part, depth + 1)?;
                let period = within(whole.0.lcm(&next.0))?;
                let own = whole.1.power((period / whole.0).into())?;
                let other = next.1.power((period / next.0).into())?;
                whole = match operator {
                    '*' => (period, own.times(&other)?, whole.2 + next.2),
                    '/' => (period, own.over(&other)?, whole.2 - next.2),
                    _ => {
                        require(own.equals(&other)? && whole.2 == next.2, Reason::Growth)?;
                        (period, own, whole.2)
                    }
                };
            }
            Ok(whole)
        }
        _ => Err(Reason::Growth.into()),
    }
}

/// (p, s) with e(k + p) = e(k) + s for all k.
fn slope(scope: &Scope<'_>, expr: &Expr, depth: usize) -> Checked<(u32, Q)> {
    require(depth < MAX_DEPTH, Reason::Stopped(NESTING))?;
    if let Some(line) = symbolic(scope, expr)?.and_then(|value| value.univariate("k")) {
        require(line.len() <= 2, Reason::Growth)?;
        return Ok((1, line.into_iter().nth(1).unwrap_or_default()));
    }
    match expr {
        Expr::Name(name) => slope(scope, definition(scope, name)?, depth + 1),
        Expr::Of(Head::Call(floor, _), parts) if floor == "floor" && parts.len() == 1 => {
            let (period, step) = slope(scope, &parts[0], depth + 1)?;
            let times = within(step.denom().to_u32().unwrap_or(0))?;
            Ok((within(period * times)?, step * Q::from_integer(times.into())))
        }
        // One part varies, and the others are numbers.
        Expr::Of(Head::Chain(operators), parts) => {
            let first = if ['+', '-'].contains(&operators[0]) { '+' } else { '*' };
            let (mut varying, mut factor) = (None, Q::one());
            for (operator, part) in [first].iter().chain(operators).zip(parts) {
                match (operator, steady(scope, part)?.map(|value| value.rational())) {
                    ('*', Some(Some(number))) => factor *= number,
                    ('/', Some(Some(number))) if !number.is_zero() => factor /= number,
                    ('+' | '-', Some(Some(_))) => {}
                    ('+' | '-' | '*', None) if varying.is_none() => {
                        varying = Some(slope(scope, part, depth + 1)?);
                        factor = if *operator == '-' { -factor } else { factor };
                    }
                    _ => return Err(Reason::Growth.into()),
                }
            }
            let (period, step) = varying.ok_or(Reason::Growth)?;
            Ok((period, step * factor))
        }
        _ => Err(Reason::Growth.into()),
    }
}

/// The value of a formula that depends on neither `k` nor `beta`.
fn steady(scope: &Scope<'_>, expr: &Expr) -> Result<Option<Value>, Stop> {
    Ok(symbolic(scope, expr)?.filter(|value| value.number().is_ok()))
}

/// The value where `k` and `beta` are symbols; none if a formula asks what these are.
fn symbolic(scope: &Scope<'_>, expr: &Expr) -> Result<Option<Value>, Stop> {
    match scope.value(expr) {
        Err(stop @ Stop::Capped(_)) => Err(stop),
        value => Ok(value.ok()),
    }
}

fn definition<'s>(scope: &'s Scope<'_>, name: &str) -> Checked<&'s Expr> {
    let definition = scope.definitions.get(name).filter(|_| !scope.values.contains_key(name));
    Ok(definition.ok_or(Reason::Growth)?)
}

fn within(period: u32) -> Checked<u32> {
    require((1..=MAX_LEVEL).contains(&period), Reason::Growth)?;
    Ok(period)
}
