//! The rule `levels`: finitely many levels prove a bound for one scheme at all levels
//! (THEOREMS.md, 40).

use super::growth::{MAX_PERIOD, growth};
use super::instance::{Instance, first_level, points};
use crate::claims::Paper;
use crate::data::{Points, Setting};
use crate::formulas::formula_of;
use crate::kinds::table::promise::{change, errors, flows, kept};
use crate::kinds::table::sound::Promised;
use crate::numbers::Value;
use crate::schemes::less;
use crate::text::{Block, Checked, Reason, Stop, Text, Toml, Verdict, compare, require};
use std::cell::RefCell;

/// Checks `grows …`, `times …` and the levels.
pub fn check<'a>(
    paper: &'a Paper<'a>,
    claim: &'a Toml,
    block: &mut Block<'_>,
    Instance { mut scope, schemes, offset, setting }: Instance<'a>,
) -> Checked<()> {
    block.look();
    // A proof for one of several schemes or values says nothing about the others.
    let one = ["schemes", "values"].iter().all(|key| claim.get(key).is_none());
    require(one && claim.get("scheme").is_some(), Reason::Single)?;
    let bounds = claim.text("bounds").unwrap_or_default();
    if points(claim)? == Points::Natural {
        // The lines are about points at i/n^k.
        return Err(Reason::NotShown.into());
    }
    let quantity = ["difference", "step", "distance"].contains(&bounds);
    require(quantity, Reason::Malformed("a theorem about a bound"))?;
    let by = formula_of(claim, "by")?;
    for name in ["k", "beta"] {
        scope.values.insert(name.to_owned(), Value::symbol(name));
    }
    let said = block.peek().map_or("", |line| line.word().1);
    let other = |found: &str| Reason::Growth(Text(said.to_string()), Text(found.to_string()));
    let grown = growth(&scope, &by, 0);
    let (period, ratio, spreads) =
        grown.map_err(|stop| stop.map_or_else(|| other("none"), Reason::Stopped))?;
    require(spreads == 1, other("not proportional to beta"))?;
    let said = block.after("grows")?.split_once(' ').unwrap_or_default();
    let same = said.0 == period.to_string() && paper.number(said.1)?.equals(&ratio)?;
    require(same, other(&format!("{period} {ratio}")))?;
    let times: u32 = block.after("times")?.parse().map_err(|_| Reason::Malformed("times J"))?;
    let from = first_level(claim)?;
    let levels = period.checked_mul(times).filter(|levels| (1..=MAX_PERIOD).contains(levels));
    let levels = levels.filter(|_| from <= MAX_PERIOD).ok_or(Reason::Level)?;
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
            compare(factor.compare(&power)?.is_le(), &factor, &power, Reason::Contraction)?;
        }
        Setting::LocalRules(ring, earlier) => {
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
                    // Where there is an interpolant, the limit is known only for the points that it
                    // keeps.
                    require(earlier.is_none(), Reason::NoLimit)?;
                    errors(paper, ring, block)?
                }
            };
            let after = ring.functionals_before(differences, levels)?;
            flows(paper, ring, block, &after, &|cost| {
                compare(cost.compare(&power)?.is_le(), cost, &power, Reason::Contraction)
            })?;
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
            Setting::LocalRules(ring, _) => {
                functionals = ring.functionals_before(functionals, u32::from(k > from))?;
                flows(paper, ring, block, &functionals, &|cost| {
                    compare(cost.compare(&most)?.is_le(), cost, &most, Reason::TooLarge)
                })?;
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
                compare(bound.compare(&most)?.is_le(), &bound, &most, Reason::TooLarge)?;
            }
        }
    }
    block.word(Verdict::Proved.name())
}
