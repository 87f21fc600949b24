//! The rule `promise`: whether the promise of a table about its printed numbers is kept for all
//! control data, cell by cell.

#![warn(clippy::arithmetic_side_effects)]

use super::claim::Table;
use super::sound::{self, MAX_LEVEL, Promised};
use crate::claims::Paper;
use crate::data::{Points, Rules, Setting, Witness, violated};
use crate::numbers::{Q, Value};
use crate::schemes::{LocalRules, less};
use crate::text::{Block, Checked, Promise, Reason, Stop, compare, require};
use num_traits::{Signed, Zero};
use std::collections::BTreeMap;
use std::rc::Rc;

/// The most points of a level.
const MAX_POINTS: i64 = 1 << 16;

/// Checks the lines `witness`, and those of the cells.
pub fn check(table: &Table<'_>, block: &mut Block<'_>) -> Checked<()> {
    let mut witnesses = BTreeMap::new();
    while let Some(name) = block.maybe("witness") {
        require(!witnesses.contains_key(name), Reason::Taken)?;
        witnesses.insert(name, Witness::read(table.paper, block)?);
    }
    if table.claim.get("promise").is_none() {
        return Ok(());
    }
    let mut settings = BTreeMap::new();
    for at in table.places() {
        let Some((_, printed)) = table.printed(at) else { continue };
        block.look();
        let verdict = Promise::named(block.next_word()).ok_or(Reason::Promises)?;
        let (_, said) = block.any()?;
        let (found, said) = table.place(said)?;
        require(found == at, Reason::Promises)?;
        if verdict == Promise::Undecided {
            require(said.is_empty(), Reason::Malformed("ROW COLUMN"))?;
            continue;
        }
        let promised = Promised::new(table, at)?;
        let (level, most) = promised.stated(printed.value.into())?;
        let level = sound::level(level)?;
        let setting = setting(table, &promised, &mut settings)?;
        if verdict == Promise::Kept {
            match &*setting {
                Setting::LocalRules(ring, _) => {
                    require(said.is_empty(), Reason::Malformed("ROW COLUMN"))?;
                    // A depth is promised for later levels too: averages are no farther away.
                    let lasts = promised.tolerance.is_none() || ring.averages()?;
                    require(lasts, Reason::Grows)?;
                    let errors = errors(table.paper, ring, block)?;
                    let functionals = ring.functionals_before(errors, level)?;
                    let small = |cost: &Value| {
                        let bound = cost.times(&promised.spread)?;
                        compare(bound.compare(&most)?.is_le(), &bound, &most, Reason::TooLarge)
                    };
                    flows(table.paper, ring, block, &functionals, &small)?;
                }
                Setting::Masks(..) => kept(&promised, &setting, said, (level, &most))?,
            }
            continue;
        }
        let broken = |said: &str, points: Points| -> Checked<()> {
            let (name, sides) = said.split_once(' ').unwrap_or((said, ""));
            let witness = witnesses.get(name).ok_or(Reason::NoWitness)?;
            let spread = witness.spreads(&setting)?.into_iter().max().filter(Q::is_positive);
            let spread = spread.ok_or(Reason::Malformed("data that are not all equal"))?;
            // A depth is promised for later levels too.
            let (sides, later) = sides.split_once(" level ").unwrap_or((sides, ""));
            let at = match later.parse::<u32>() {
                _ if later.is_empty() => level,
                Ok(later) if promised.tolerance.is_some() && later > level => later,
                _ => return Err(Reason::Malformed("a later level").into()),
            };
            let distance = witness.value(&setting, "distance", (at, points))?;
            let left = distance.times(&promised.spread)?.over(&spread.into())?;
            violated(table.paper, sides, &left, &most)
        };
        broken(said, Points::Indexed)?;
        if let Some(said) = block.maybe("naturally") {
            let (found, said) = table.place(said)?;
            require(found == at, Reason::Promises)?;
            broken(said, Points::Natural)?;
        }
    }
    Ok(())
}

/// The setting of a cell.
fn setting<'a>(
    table: &'a Table<'a>,
    promised: &Promised<'a>,
    known: &mut BTreeMap<String, Rc<Setting<'a>>>,
) -> Checked<Rc<Setting<'a>>> {
    let Promised { scope, schemes, offset, .. } = promised;
    let library = table.paper.library;
    let ring = table.claim.get("promise").and_then(|promise| promise.text("ring"));
    let key = match ring {
        Some(ring) => format!("{:?}", library.entry(ring, scope)?.2),
        None => format!("{:?} {offset:?}", schemes.iter().map(Rc::as_ptr).collect::<Vec<_>>()),
    };
    if let Some(known) = known.get(&key) {
        return Ok(Rc::clone(known));
    }
    let setting = Rc::new(match ring {
        Some(ring) => Setting::LocalRules(Box::new(LocalRules::new(library, ring, scope)?), None),
        None => Setting::masks(library, schemes, *offset)?,
    });
    known.insert(key, Rc::clone(&setting));
    Ok(setting)
}

/// Checks `L M c`: the sound bound at level L, and β times a bound of the distance of the levels L
/// and k, are together at most what is promised; for a depth, also with each level between in place
/// of k.
pub fn kept(
    promised: &Promised<'_>,
    setting: &Setting<'_>,
    said: &str,
    (level, most): (u32, &Value),
) -> Checked<()> {
    let malformed = Reason::Malformed("L M c, L from the level on");
    let (later, constants) = said.split_once(' ').unwrap_or((said, ""));
    let later: Option<u32> = later.parse().ok().filter(|l| (level..=MAX_LEVEL).contains(l));
    let (Some(later), Setting::Masks(rules, _)) = (later, setting) else {
        return Err(malformed.into());
    };
    let bound = promised.bound(later.into(), constants)?;
    // The sound bound at level L holds for all later levels; a depth is promised for the levels
    // before it too.
    let last = if promised.tolerance.is_some() { later } else { level };
    for level in level..=last {
        let mut bound = bound.clone();
        if later > level {
            let change = change(promised, rules, level, later)?.times(&promised.spread)?;
            bound.add(1, &change)?;
        }
        compare(bound.compare(most)?.is_le(), &bound, most, Reason::TooLarge)?;
    }
    Ok(())
}

/// Checks `weights …`, and gives e_a − w for every point.
pub fn errors(
    paper: &Paper<'_>,
    ring: &LocalRules<'_>,
    block: &mut Block<'_>,
) -> Checked<Vec<Vec<Value>>> {
    let weights = paper.numbers(block.after("weights")?)?;
    require(ring.is_limit(&weights)?, Reason::Weights)?;
    require(ring.contracts()?, Reason::NoLimit)?;
    let errors = ring.units().into_iter().map(|unit| less(&unit, &weights));
    Ok(errors.collect::<Result<_, Stop>>()?)
}

/// Checks a line `flow …` for each functional: the flow carries the functional, and its cost is
/// `small`.
pub fn flows(
    paper: &Paper<'_>,
    ring: &LocalRules<'_>,
    block: &mut Block<'_>,
    functionals: &[Vec<Value>],
    small: &dyn Fn(&Value) -> Checked<()>,
) -> Checked<()> {
    for functional in functionals {
        let flow = paper.numbers(block.after("flow")?)?;
        require(flow.len() == ring.edges.len(), Reason::Malformed("a number for each edge"))?;
        let (cost, carried) = ring.carried(&flow)?;
        for (carried, needed) in carried.iter().zip(functional) {
            compare(carried.equals(needed)?, carried, needed, Reason::Flow)?;
        }
        small(&cost)?;
    }
    Ok(())
}

/// A bound of ‖P^l − P^k‖ for the spread 1.
pub fn change(promised: &Promised<'_>, rules: &[Rules<'_>], k: u32, l: u32) -> Result<Value, Stop> {
    let largest = |rules: &Rules<'_>| -> Result<Value, Stop> {
        let count = rules.arity().checked_pow(l).filter(|count| *count <= MAX_POINTS);
        let count = count.ok_or(Stop::Capped("the points of a level"))?;
        let mut largest = Q::zero();
        for i in 0..count {
            let new = rules.at(l, &Q::from_integer(i.into()))?;
            let old = rules.polygon(k, &Q::new(i.into(), count.into()), &Q::zero())?;
            largest = largest.max(new.minus(&old).norm_on_differences());
        }
        Ok(largest.into())
    };
    let [first, second] = rules else { return largest(&rules[0]) };
    // This is THEOREMS.md, 32, with level l in place of the limit.
    let norm = |axis: usize, level: u32| {
        let rules = &promised.schemes[axis].mask;
        promised.paper.library.products.greatest(rules, &Value::int(level.into()))
    };
    let (c, d) = (largest(first)?, largest(second)?);
    let one = c.times(&norm(1, l)?)?.plus(1, &d.times(&norm(0, k)?)?)?;
    let other = d.times(&norm(0, l)?)?.plus(1, &c.times(&norm(1, k)?)?)?;
    Ok(if one.compare(&other)?.is_lt() { one } else { other })
}
