//! Proofs of what is refuted, and refutations of what is proved.

use super::Sides;
use crate::random_papers::draft::{Bound, Claim, Draft, Instance, Shape};
use crate::random_papers::formula::{Env, Tree};
use crate::random_papers::naive::{Q, int};
use crate::random_papers::program::{Block, blocks, bound as whole, checked, written};
use crate::random_papers::truth::{Witness, names};
use num_traits::{One, Zero};
use subcert_check::{Outcome, Reason};

pub fn sides(draft: &Draft, claim: &Claim, bound: &Bound, own: Option<Block>) -> Sides {
    let (mut one, mut other) = (proofs(draft, claim, bound), refutations(draft, claim, bound));
    other.extend(
        bound.instances.iter().flat_map(|instance| searched(draft, claim, bound, instance)),
    );
    match own {
        Some(own) if own.verdict() == "proved" => one.insert(0, own),
        Some(own) if own.verdict() == "refuted" => other.insert(0, own),
        _ => {}
    }
    Sides { one, other }
}

/// The claim with another bound from another level on.
fn twin(draft: &Draft, claim: &Claim, bound: &Bound, by: &str, from: u32) -> Option<Block> {
    let text = claim
        .text
        .replace(&format!("by = '{}'", bound.by), &format!("by = '{by}'"))
        .replace(&format!("from = '{}'", bound.from), &format!("from = '{from}'"));
    blocks(&written(&draft.with([&Claim { text, ..claim.clone() }]))?).pop()
}

/// The values that a bound may be thought to have: names by the letter, or definitions before them, or
/// what is given before what a bound speaks of.
fn readings(draft: &Draft, instance: &Instance, spreads: &[Q], level: u32, by: &Tree) -> Vec<Q> {
    let letter = names(draft, instance, spreads, ("k", int(level.into())));
    let mut found: Vec<Q> = letter.value(by).into_iter().collect();
    let mut given = letter.clone();
    given.values.extend(draft.names.given.clone());
    found.extend(given.value(by));
    let mut defined: Env<'_> = letter.clone();
    defined.values.retain(|name, _| !draft.names.definitions.contains_key(name));
    found.extend(defined.value(by));
    found.dedup();
    found
}

/// The data that are worst at the first levels, against the bound.
fn refutations(draft: &Draft, claim: &Claim, bound: &Bound) -> Vec<Block> {
    let mut blocks = Vec::new();
    for from in bound.from..bound.from + 3 {
        if bound.quantity == "depth" {
            break;
        }
        let Some(twin) = twin(draft, claim, bound, "beta*0", from) else { continue };
        let twin = twin.indexed();
        let Some(witness) =
            (twin.verdict() == "refuted").then(|| Witness::read(&twin, false)).flatten()
        else {
            continue;
        };
        let reference = twin.after("scheme").unwrap_or_default();
        let Some(instance) =
            bound.instances.iter().find(|instance| instance.reference == reference)
        else {
            continue;
        };
        let left =
            twin.after("sides").and_then(|sides| sides.split(' ').next()).unwrap_or_default();
        let spreads = witness.spreads(&instance.shape);
        for right in readings(draft, instance, &spreads, witness.level, &bound.by) {
            let line = |line: &str| match line.split(' ').next() {
                Some("by") => format!("by {}", bound.by),
                Some("sides") => format!("sides {left} {right}"),
                _ => line.to_owned(),
            };
            let lines: Vec<String> = twin.lines().into_iter().map(line).collect();
            blocks.push(twin.with_lines(&lines));
        }
    }
    blocks
}

/// Steps and hats of several heights, also along one index alone, where they are worst.
fn searched(draft: &Draft, claim: &Claim, bound: &Bound, instance: &Instance) -> Vec<Block> {
    let indices = match &instance.shape {
        Shape::Curve(_) => 1,
        Shape::Net(_) => 2,
        Shape::LocalRules(..) => return Vec::new(),
    };
    if !["difference", "step"].contains(&bound.quantity) {
        return Vec::new();
    }
    let polygons = [vec![0], vec![0, 1], vec![0, 2], vec![0, 1, 0]].map(|polygon| vec![polygon]);
    let all: Vec<Vec<Vec<i64>>> = match indices {
        1 => polygons[1..].to_vec(),
        _ => [[0, 1], [1, 0], [1, 2], [2, 1], [3, 3]]
            .map(|pair| pair.map(|at: usize| polygons[at][0].clone()).to_vec())
            .to_vec(),
    };
    let mut blocks = Vec::new();
    for (level, data) in (bound.from..bound.from + 2).flat_map(|k| all.iter().map(move |x| (k, x)))
    {
        let window = -3_i64..=6;
        let single = window.clone().map(|i| vec![i.to_string()]);
        let places: Vec<Vec<String>> = if indices == 1 {
            single.collect()
        } else {
            let axes: &[&str] = if bound.quantity == "difference" { &["1", "2"] } else { &[""] };
            let pairs = window.clone().flat_map(|i| window.clone().map(move |j| [i, j]));
            let with = |[i, j]: [i64; 2]| {
                axes.iter().map(move |axis| {
                    let words = [i.to_string(), j.to_string(), (*axis).to_owned()];
                    words.into_iter().filter(|word| !word.is_empty()).collect()
                })
            };
            pairs.flat_map(with).collect()
        };
        let value = |place: Vec<String>| {
            let witness = Witness::of_polygons(level, data, place.clone());
            let (value, _) = witness.value(bound, &instance.shape, &Q::zero()).ok()?;
            Some((value, place))
        };
        let Some((value, place)) = places.into_iter().filter_map(value).max() else { continue };
        let spreads = Witness::of_polygons(level, data, place.clone()).spreads(&instance.shape);
        for right in readings(draft, instance, &spreads, level, &bound.by) {
            let mut lines = vec![
                format!("bounds {}", bound.quantity),
                format!("by {}", bound.by),
                format!("scheme {}", instance.reference),
            ];
            lines.extend(instance.values.iter().map(|(name, value)| format!("let {name} {value}")));
            lines.push(format!("level {level}"));
            for polygon in data {
                let points: Vec<String> = polygon.iter().map(ToString::to_string).collect();
                lines.push(format!("polygon 0 {}", points.join(" ")));
            }
            lines.push(format!("at {}", place.join(" ")));
            lines.push(format!("sides {value} {right}"));
            lines.push("refuted".to_owned());
            blocks.push(theorem_block(claim, &lines));
        }
    }
    blocks
}

fn theorem_block(claim: &Claim, lines: &[String]) -> Block {
    let head = Block { kind: "theorem".to_owned(), id: claim.id.clone(), text: String::new() };
    head.with_lines(lines)
}

/// All that the rule `grows` may accept, with small numbers.
fn proofs(draft: &Draft, claim: &Claim, bound: &Bound) -> Vec<Block> {
    let [instance] = &bound.instances[..] else { return Vec::new() };
    if bound.quantity == "depth"
        || !instance.values.is_empty()
        || !claim.text.contains("\nscheme = ")
    {
        return Vec::new();
    }
    let text = draft.with([claim]);
    let stated = [
        format!("bounds {}", bound.quantity),
        format!("by {}", bound.by),
        format!("scheme {}", instance.reference),
    ];
    let mut blocks = Vec::new();
    for (period, ratio) in growths(draft, bound, instance) {
        let with = |times: u32, rest: &[String]| {
            let grows = [format!("grows {period} {ratio}"), format!("times {times}")];
            theorem_block(claim, &[&stated[..], &grows, rest].concat())
        };
        let probe = checked(&text, &whole(&[&with(1, &["none".to_owned()])])).unwrap_or_default();
        let otherwise = |outcome: &Outcome| matches!(outcome, Outcome::Invalid(_, why) if matches!(why.reason, Reason::Growth(..)));
        if probe.iter().any(|(_, outcome)| otherwise(outcome)) {
            continue;
        }
        for times in [1, 2, 4].into_iter().filter(|times| period * times <= 4) {
            for rest in levels(draft, claim, bound, instance, period * times) {
                blocks.push(with(times, &rest));
            }
        }
    }
    blocks
}

/// Periods and ratios that the bound may be thought to have.
fn growths(draft: &Draft, bound: &Bound, instance: &Instance) -> Vec<(u32, Q)> {
    let spreads: Vec<Q> = match &instance.shape {
        Shape::Net(_) => vec![Q::one(), Q::one()],
        _ => vec![Q::one()],
    };
    let mut found = Vec::new();
    for period in 1..=3 {
        let now = readings(draft, instance, &spreads, bound.from, &bound.by);
        let later = readings(draft, instance, &spreads, bound.from + period, &bound.by);
        let ratios = now.iter().zip(&later).filter(|(now, _)| !now.is_zero());
        let mut ratios: Vec<Q> = ratios.map(|(now, later)| later / now).collect();
        ratios.extend([Q::one(), Q::new(1.into(), 2.into()), Q::new(1.into(), 3.into())]);
        ratios.sort();
        ratios.dedup();
        found.extend(ratios.into_iter().map(|ratio| (period, ratio)));
    }
    found
}

/// The lines of the levels: of masks they have few numbers, which are tried; of a ring those of the
/// same claim with a bound that is much larger.
fn levels(
    draft: &Draft,
    claim: &Claim,
    bound: &Bound,
    instance: &Instance,
    count: u32,
) -> Vec<Vec<String>> {
    let lines = |rest: &dyn Fn(u32) -> String| {
        let levels = bound.from..bound.from + count;
        let lines = levels.map(|level| format!("level {level}{}", rest(level)));
        lines.chain(["proved".to_owned()]).collect::<Vec<String>>()
    };
    match (&instance.shape, bound.quantity) {
        (Shape::LocalRules(..), _) => {
            let by = format!("1000000*({})", bound.by);
            let Some(twin) = twin(draft, claim, bound, &by, bound.from) else { return Vec::new() };
            let all = twin.lines();
            let times = all.iter().position(|line| line.starts_with("times "));
            times
                .map(|at| all[at + 1..].iter().map(|line| (*line).to_owned()).collect())
                .into_iter()
                .collect()
        }
        (_, "distance") => {
            let numbers = [(0, 1), (2, 1), (6, 1), (0, 2), (4, 2), (4, 3), (6, 4)];
            let rest =
                |(later, c): (u32, u32)| lines(&|level| format!(" {} {c} {c}", level + later));
            numbers.into_iter().map(rest).collect()
        }
        _ => vec![lines(&|_| String::new())],
    }
}
