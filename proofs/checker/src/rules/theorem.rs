//! Rule `theorem`: open, or refuted by a polygon.

use crate::certificate::Block;
use crate::convolution::classes;
use crate::decimal::{Q, int, read_rational};
use crate::functions::greatest;
use crate::paper::{Paper, formula_of, restates};
use crate::polygon::{Polygon, Rules};
use crate::reject::{Checked, Reason};
use crate::toml::Toml;
use crate::value::Value;
use num_traits::Signed;

/// The most levels of a witness.
const MAX_LEVEL: u32 = 64;

/// The most levels, and residue classes, of a constant that shows convergence.
const MAX_CLASSES: usize = 1 << 12;

/// Checks a theorem.
pub fn check<'a>(paper: &'a Paper<'a>, claim: &'a Toml, block: &mut Block<'_>) -> Checked<()> {
    if let Some((line, _)) = block.optional("open") {
        return Err(line.reject(Reason::Open));
    }
    for key in ["bounds", "by", "scheme"] {
        let (line, said) = block.take(key)?;
        restates(line, key, said, claim.text(key))?;
    }
    let mut scope = paper.scope();
    scope.values.clone_from(&paper.given);
    while let Some((line, said)) = block.optional("let") {
        let (name, value) = said.split_once(' ').unwrap_or((said, ""));
        let taken = ["k", "beta"].contains(&name) || paper.definitions.contains_key(name);
        let value = paper.closed(line, value.trim())?;
        if taken || scope.values.insert(name.to_owned(), value).is_some() {
            return Err(line.reject(Reason::Taken));
        }
    }
    let (line, said) = block.take("level")?;
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let reference = claim.text("scheme").unwrap_or_default();
    let schemes = paper.library.resolve(reference, &scope).map_err(stopped)?;
    let [scheme] = &schemes[..] else { return Err(line.reject(Reason::Malformed("a curve"))) };
    scope.scheme = Some(scheme.clone());
    let row = |row: &Vec<Value>| row.iter().map(Value::rational).collect::<Option<Vec<Q>>>();
    let mask = scheme.mask.iter().map(row).collect::<Option<Vec<_>>>();
    let mask = mask.ok_or(line.reject(Reason::Malformed("a rational mask")))?;
    let rules = Rules { mask, offset: scheme.offset };
    let from: u32 = claim.text("from").and_then(|from| from.parse().ok()).unwrap_or(0);
    let level: u32 = said.parse().map_err(|_| line.reject(Reason::Malformed("a level")))?;
    if level < from || level > MAX_LEVEL {
        return Err(line.reject(Reason::Level));
    }
    let (line, said) = block.take("polygon")?;
    let numbers: Option<Vec<Q>> = said.split_whitespace().map(read_rational).collect();
    let numbers = numbers.filter(|numbers| numbers.len() > 1 && numbers[0].is_integer());
    let numbers = numbers.ok_or(line.reject(Reason::Malformed("polygon FIRST NUMBER…")))?;
    let first = Value::from(numbers[0].clone()).integer(1_000_000).map_err(stopped)?;
    let control = Polygon { first, points: numbers[1..].to_vec() };
    let (line, said) = block.take("at")?;
    let at = read_rational(said).ok_or(line.reject(Reason::Malformed("a number")))?;
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    let mut polygon = control.clone();
    for _ in 0..level {
        polygon = polygon.refined(&rules).map_err(stopped)?;
    }
    let arity = Q::from_integer(rules.mask.len().into());
    let u = (0..level).fold(at.clone(), |u, _| u * &arity);
    let left = match claim.text("bounds") {
        Some("difference") => {
            polygon.difference(Value::from(at).integer(1 << 40).map_err(stopped)?)
        }
        Some("step") => {
            let next = polygon.refined(&rules).and_then(|next| next.interpolate(&(&u * &arity)));
            next.map_err(stopped)? - polygon.interpolate(&u).map_err(stopped)?
        }
        Some("distance") => {
            let mut steps = (0..MAX_LEVEL).scan(u.clone(), |u, _| {
                *u *= &arity;
                Some(u.is_integer())
            });
            if !u.is_integer() && !steps.any(|whole| whole) {
                return Err(line.reject(Reason::Malformed("an n-adic number")));
            }
            let mut contracts = false;
            for c in 1.. {
                if rules.mask.len().saturating_pow(c) > MAX_CLASSES || contracts {
                    break;
                }
                let sums = classes(&scope, scheme, "b", false, &Value::int(c.into()));
                let constant = sums.and_then(|sums| greatest(&scope, &sums)).map_err(stopped)?;
                contracts = constant.rational().is_some_and(|constant| constant < int(1));
            }
            let limit = polygon.limit(&rules, &u).map_err(stopped)?.filter(|_| contracts);
            let limit = limit.ok_or(line.reject(Reason::NoLimit))?;
            limit - polygon.interpolate(&u).map_err(stopped)?
        }
        _ => return Err(line.reject(Reason::Malformed("a bound at a level"))),
    };
    let (line, said) = block.take("sides")?;
    let stopped = |stop| line.reject(Reason::Stopped(stop));
    scope.values.insert("k".to_owned(), Value::int(level.into()));
    scope.values.insert("beta".to_owned(), control.spread().into());
    let right = formula_of(claim, "by").and_then(|by| scope.value(&by)).map_err(stopped)?;
    let sides = [Value::from(left.abs()), right];
    let said: Vec<&str> = said.split_whitespace().collect();
    for (i, side) in sides.iter().enumerate() {
        let said = paper.closed(line, said.get(i).unwrap_or(&""))?;
        if said.plus(-1, side).map_or(true, |off| !off.is_zero()) {
            return Err(line.reject(Reason::Value));
        }
    }
    // A bound that is negative presupposes what does not hold, such as a constant below 1.
    if sides[1].sign(None).map_err(stopped)? < 0 {
        return Err(line.reject(Reason::Negative));
    }
    let above = sides[0].plus(-1, &sides[1]).and_then(|above| above.sign(None)).map_err(stopped)?;
    if above <= 0 {
        return Err(line.reject(Reason::NotViolated));
    }
    block.take("refuted").map(|_| ())
}
